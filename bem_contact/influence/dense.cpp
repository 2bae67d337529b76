#include "bem_contact/influence/dense.hpp"

#include <mutex>
#include <vector>

extern "C" {
void openblas_set_num_threads(int);
int openblas_get_num_threads();
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a,
            const int* lda, double* x, const int* incx);
void sgesv_(const int* n, const int* nrhs, float* a, const int* lda, int* pivots, float* b, const int* ldb,
            int* info);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
}

namespace bem_contact {

namespace {

/// While one lives OpenBLAS computes on one thread. Its threads gain nothing at these sizes, and where other
/// work runs beside they wait for each other fifty times as long as they compute. The number is OpenBLAS's
/// own and global, so it is given back as it was (NumPy may share it) when the last of all callers is
/// through.
class OneThread {
public:
  OneThread() {
    const std::lock_guard lock(mutex);
    if (callers++ == 0) {
      before = openblas_get_num_threads();
      if (before != 1) // it does not look itself
        openblas_set_num_threads(1);
    }
  }
  ~OneThread() {
    const std::lock_guard lock(mutex);
    if (--callers == 0 && before != 1)
      openblas_set_num_threads(before);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

private:
  inline static std::mutex mutex;
  inline static int callers = 0, before = 1;
};

} // namespace

bool factor_cholesky(Eigen::MatrixXd& a) {
  const int n = static_cast<int>(a.rows());
  int info = 0;
  const OneThread one_thread;
  if (n > 0)
    dpotrf_("L", &n, a.data(), &n, &info);
  return info == 0;
}

void solve_factored(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::VectorXd> x) {
  const int n = static_cast<int>(factor.rows()), stride = 1;
  const OneThread one_thread;
  // LAPACK's dpotrs copies the factor first, which takes longer than to solve with it.
  if (n > 0)
    for (const char* transposed : {"N", "T"})
      dtrsv_("L", transposed, "N", &n, factor.data(), &n, x.data(), &stride);
}

bool solve_lu(Eigen::MatrixXf& a, Eigen::VectorXf& x) {
  const int n = static_cast<int>(a.rows()), nrhs = 1;
  int info = 0;
  std::vector<int> pivots(a.rows());
  const OneThread one_thread;
  if (n > 0)
    sgesv_(&n, &nrhs, a.data(), &n, pivots.data(), x.data(), &n, &info);
  return info == 0;
}

namespace {

/// op(A) B into `out`, op(A) with `rows` rows: A itself or, where `transposed`, A^T.
void multiply(bool transposed, Eigen::Index rows, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
              double* out) {
  const int m = static_cast<int>(rows), n = static_cast<int>(b.cols()), k = static_cast<int>(b.rows()),
            stride = static_cast<int>(a.rows());
  const double one = 1, zero = 0;
  const OneThread one_thread;
  if (m > 0 && n > 0)
    dgemm_(transposed ? "T" : "N", "N", &m, &n, &k, &one, a.data(), &stride, b.data(), &k, &zero, out, &m);
}

} // namespace

void dense_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out) {
  multiply(false, a.rows(), a, b, out);
}

void dense_product_of_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double* out) {
  multiply(true, a.cols(), a, b, out);
}

} // namespace bem_contact
