#include "bem_contact/influence/dense.hpp"

#include "bem_contact/base/loaded_library.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

extern "C" {
void openblas_set_num_threads(int);
int openblas_get_num_threads();
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a,
            const int* lda, double* x, const int* incx);
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void sgetrf_(const int* m, const int* n, float* a, const int* lda, int* pivots, int* info);
void strsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const float* alpha, const float* a, const int* lda, float* b, const int* ldb);
void sgemv_(const char* trans, const int* m, const int* n, const float* alpha, const float* a, const int* lda,
            const float* x, const int* incx, const float* beta, float* y, const int* incy);
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta, double* y, const int* incy);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
}

namespace bem_contact {

namespace {

constexpr LoadedLibrary blas(CONFORMAL_OPENBLAS_LIBRARY);
BEM_CONTACT_LOADED_FUNCTION(blas, openblas_set_num_threads)
BEM_CONTACT_LOADED_FUNCTION(blas, openblas_get_num_threads)
BEM_CONTACT_LOADED_FUNCTION(blas, dpotrf_)
BEM_CONTACT_LOADED_FUNCTION(blas, dtrsv_)
BEM_CONTACT_LOADED_FUNCTION(blas, dtrsm_)
BEM_CONTACT_LOADED_FUNCTION(blas, sgetrf_)
BEM_CONTACT_LOADED_FUNCTION(blas, strsm_)
BEM_CONTACT_LOADED_FUNCTION(blas, sgemv_)
BEM_CONTACT_LOADED_FUNCTION(blas, dgemv_)
BEM_CONTACT_LOADED_FUNCTION(blas, dgemm_)

/// Bytes of memory that OpenBLAS takes for each call that runs beside others, and keeps. Where the system
/// gives none it asks again and again, for ever.
constexpr std::size_t blas_buffer = 128 << 20;
/// Fewer numbers of the vectors of a product or a triangular system do not need one: they are on the stack,
/// up to 2048 bytes.
constexpr int largest_without_buffer = 200;

/// As OpenBLAS asks for it: of the system and, where that has none, of the heap.
bool is_there_memory_for_a_buffer() {
  void* volatile const found = std::malloc(blas_buffer); // volatile: or it is left out
  std::free(found);
  return found != nullptr;
}

/// While one lives OpenBLAS computes on one thread. Its threads gain nothing at these sizes, and where other
/// work runs beside they wait for each other fifty times as long as they compute. The number is OpenBLAS's
/// own and global, so it is given back as it was (NumPy may share it) when the last of all callers is
/// through. Throws std::bad_alloc.
class OneThread {
public:
  /// `numbers` are copied at most, where a call has one column alone.
  explicit OneThread(int numbers = largest_without_buffer) {
    const std::lock_guard lock(mutex);
    const bool takes_buffer = numbers >= largest_without_buffer && callers >= buffers;
    if ((takes_buffer || !is_open) && !is_there_memory_for_a_buffer()) // where it is opened it takes one, too
      throw std::bad_alloc();
    is_open = true;
    if (takes_buffer)
      buffers = callers + 1;
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
  inline static bool is_open = false;
  inline static int callers = 0, before = 1;
  inline static int buffers = 0; ///< that OpenBLAS has, at least: the most callers so far
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

namespace {

/// x := op(L)^-1 x
void solve_triangle(const char* op, const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  const int n = static_cast<int>(factor.rows()), columns = static_cast<int>(x.cols()), stride = 1,
            between = static_cast<int>(x.outerStride());
  const double one = 1;
  const OneThread one_thread(columns == 1 ? 2 * n : largest_without_buffer);
  if (n > 0 && columns == 1) // dtrsm, and LAPACK's dpotrs, copy the factor first, which takes longer
    dtrsv_("L", op, "N", &n, factor.data(), &n, x.data(), &stride);
  else if (n > 0 && columns > 0)
    dtrsm_("L", "L", op, "N", &n, &columns, &one, factor.data(), &n, x.data(), &between);
}

} // namespace

void solve_lower(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  solve_triangle("N", factor, x);
}

void solve_lower_transposed(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  solve_triangle("T", factor, x);
}

namespace {

constexpr int lu_block = 32; ///< rows and columns of a block on the diagonal. Chosen

/// y += sign A x with A of m rows and n columns, `stride` floats from column to column
void add_product(int m, int n, float sign, const float* a, int stride, const float* x, float* y) {
  const float one = 1;
  const int step = 1;
  if (m > 0 && n > 0)
    sgemv_("N", &m, &n, &sign, a, &stride, x, &step, &one, y, &step);
}

} // namespace

LuFactors::LuFactors(Eigen::MatrixXf a) : factors_(std::move(a)), pivots_(factors_.rows()) {
  const int n = static_cast<int>(factors_.rows());
  if (n == 0)
    return;
  int info = 0;
  const OneThread one_thread;
  sgetrf_(&n, &n, factors_.data(), &n, pivots_.data(), &info);
  regular_ = info == 0;
  if (!regular_)
    return;
  lower_.setZero(lu_block, n);
  upper_.setZero(lu_block, n);
  const float one = 1;
  for (int k = 0; k < n; k += lu_block) {
    const int size = std::min(lu_block, n - k);
    for (Eigen::MatrixXf* inverse : {&lower_, &upper_}) {
      const bool is_lower = inverse == &lower_;
      inverse->block(0, k, size, size).setIdentity();
      strsm_("L", is_lower ? "L" : "U", "N", is_lower ? "U" : "N", &size, &size, &one, &factors_(k, k), &n,
             &(*inverse)(0, k), &lu_block);
    }
  }
}

void LuFactors::solve(Eigen::Ref<Eigen::VectorXf> x) const {
  const int n = static_cast<int>(factors_.rows());
  const OneThread one_thread;
  for (int i = 0; i < n; ++i)
    std::swap(x[i], x[pivots_[static_cast<std::size_t>(i)] - 1]);
  std::array<float, lu_block> solved{};
  const auto solve_block = [&](const Eigen::MatrixXf& inverse, int k, int size) {
    solved.fill(0);
    add_product(size, size, 1, &inverse(0, k), lu_block, &x[k], solved.data());
    std::copy_n(solved.data(), size, &x[k]);
  };
  for (int k = 0; k < n; k += lu_block) {
    const int size = std::min(lu_block, n - k), below = k + size;
    solve_block(lower_, k, size);
    if (below < n)
      add_product(n - below, size, -1, &factors_(below, k), n, &x[k], &x[below]);
  }
  for (int k = (n - 1) / lu_block * lu_block; k >= 0 && n > 0; k -= lu_block) {
    const int size = std::min(lu_block, n - k);
    solve_block(upper_, k, size);
    add_product(k, size, -1, &factors_(0, k), n, &x[k], x.data());
  }
}

void dense_product(const Eigen::MatrixXf& a, Eigen::Ref<const Eigen::VectorXf> x,
                   Eigen::Ref<Eigen::VectorXf> out) {
  const int m = static_cast<int>(a.rows()), n = static_cast<int>(a.cols()), stride = 1;
  const float one = 1, zero = 0;
  const OneThread one_thread(m + n);
  if (m > 0 && n > 0)
    sgemv_("N", &m, &n, &one, a.data(), &m, x.data(), &stride, &zero, out.data(), &stride);
}

void dense_product(const Eigen::MatrixXd& a, Eigen::Ref<const Eigen::VectorXd> x,
                   Eigen::Ref<Eigen::VectorXd> out) {
  const int m = static_cast<int>(a.rows()), n = static_cast<int>(a.cols()), stride = 1;
  const double one = 1, zero = 0;
  const OneThread one_thread(m + n);
  if (m > 0 && n > 0)
    dgemv_("N", &m, &n, &one, a.data(), &m, x.data(), &stride, &zero, out.data(), &stride);
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
