#include "bem_contact/influence/dense.hpp"

#include "bem_contact/base/loaded_library.hpp"
#include "bem_contact/influence/column_loops.hpp"
#include "bem_contact/influence/few_unknowns.hpp"

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
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void sgetrf_(const int* m, const int* n, float* a, const int* lda, int* pivots, int* info);
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
BEM_CONTACT_LOADED_FUNCTION(blas, dtrsm_)
BEM_CONTACT_LOADED_FUNCTION(blas, sgetrf_)
BEM_CONTACT_LOADED_FUNCTION(blas, dgemm_)

/// Bytes of memory that OpenBLAS takes for each call that runs beside others, and keeps. Where the system
/// gives none it asks again and again, for ever.
constexpr std::size_t blas_buffer = 128 << 20;

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
  OneThread() {
    const std::lock_guard lock(mutex);
    if (callers >= buffers && !is_there_memory_for_a_buffer())
      throw std::bad_alloc();
    buffers = std::max(buffers, callers + 1);
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
  inline static int buffers = 0; ///< that OpenBLAS has, at least: the most callers so far
};

} // namespace

bool factor_cholesky(Eigen::MatrixXd& a) {
  const int n = static_cast<int>(a.rows());
  if (n <= few::most)
    return few::factor_cholesky(a.data(), n);
  int info = 0;
  const OneThread one_thread;
  dpotrf_("L", &n, a.data(), &n, &info);
  return info == 0;
}

namespace {

/// x := op(L)^-1 x; `few_columns` does so with one column.
void solve_triangle(const char* op, void (*few_columns)(const double*, int, double*),
                    const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  const int n = static_cast<int>(factor.rows()), columns = static_cast<int>(x.cols()),
            between = static_cast<int>(x.outerStride());
  if (n <= few::most || columns == 1) { // dtrsm copies the factor first, which takes longer
    for (int k = 0; k < columns; ++k)
      few_columns(factor.data(), n, x.data() + static_cast<std::ptrdiff_t>(k) * between);
    return;
  }
  const double one = 1;
  const OneThread one_thread;
  if (columns > 0)
    dtrsm_("L", "L", op, "N", &n, &columns, &one, factor.data(), &n, x.data(), &between);
}

} // namespace

void solve_lower(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  solve_triangle("N", few::solve_lower, factor, x);
}

void solve_lower_transposed(const Eigen::MatrixXd& factor, Eigen::Ref<Eigen::MatrixXd> x) {
  solve_triangle("T", few::solve_lower_transposed, factor, x);
}

namespace {

constexpr int lu_block = 32; ///< rows and columns of a block on the diagonal. Chosen

/// The inverse of a triangle of A, in place of the identity.
void invert_triangle(bool lower, int size, const float* a, int stride, float* inverse) {
  for (int column = 0; column < size; ++column)
    for (int step = 0; step < size; ++step) {
      const int k = lower ? step : size - 1 - step;
      const float* of = a + static_cast<std::ptrdiff_t>(k) * stride;
      float* x = inverse + static_cast<std::ptrdiff_t>(column) * lu_block;
      if (!lower)
        x[k] /= of[k];
      const float factor = -x[k];
      if (factor != 0)
        add_columns(of + (lower ? k + 1 : 0), stride, 1, &factor, x + (lower ? k + 1 : 0),
                    lower ? size - 1 - k : k);
    }
}

} // namespace

LuFactors::LuFactors(Eigen::MatrixXf a) : factors_(std::move(a)), pivots_(factors_.rows()) {
  const int n = static_cast<int>(factors_.rows());
  if (n <= few::most)
    regular_ = few::factor_lu(factors_.data(), n, pivots_.data());
  else {
    int info = 0;
    const OneThread one_thread;
    sgetrf_(&n, &n, factors_.data(), &n, pivots_.data(), &info);
    std::ranges::for_each(pivots_, [](int& row) { --row; }); // LAPACK counts from 1
    regular_ = info == 0;
  }
  if (!regular_)
    return;
  lower_.setZero(lu_block, n);
  upper_.setZero(lu_block, n);
  for (int k = 0; k < n; k += lu_block) {
    const int size = std::min(lu_block, n - k);
    for (Eigen::MatrixXf* inverse : {&lower_, &upper_}) {
      inverse->block(0, k, size, size).setIdentity();
      invert_triangle(inverse == &lower_, size, &factors_(k, k), n, &(*inverse)(0, k));
    }
  }
}

void LuFactors::solve(Eigen::Ref<Eigen::VectorXf> x) const {
  const int n = static_cast<int>(factors_.rows());
  for (int i = 0; i < n; ++i)
    std::swap(x[i], x[pivots_[static_cast<std::size_t>(i)]]);
  std::array<float, lu_block> solved{};
  const auto solve_block = [&](const Eigen::MatrixXf& inverse, int k, int size) {
    solved.fill(0);
    add_columns(&inverse(0, k), lu_block, size, &x[k], solved.data(), size);
    std::copy_n(solved.data(), size, &x[k]);
    std::ranges::for_each(solved, [](float& v) { v = -v; });
  };
  for (int k = 0; k < n; k += lu_block) {
    const int size = std::min(lu_block, n - k), below = k + size;
    solve_block(lower_, k, size);
    add_columns(factors_.data() + below + static_cast<std::ptrdiff_t>(k) * n, n, size, solved.data(),
                x.data() + below, n - below);
  }
  for (int k = (n - 1) / lu_block * lu_block; k >= 0 && n > 0; k -= lu_block) {
    const int size = std::min(lu_block, n - k);
    solve_block(upper_, k, size);
    add_columns(factors_.data() + static_cast<std::ptrdiff_t>(k) * n, n, size, solved.data(), x.data(), k);
  }
}

void dense_product(const Eigen::MatrixXf& a, Eigen::Ref<const Eigen::VectorXf> x,
                   Eigen::Ref<Eigen::VectorXf> out) {
  out.setZero();
  add_columns(a.data(), a.rows(), static_cast<int>(a.cols()), x.data(), out.data(), a.rows());
}

void dense_product(const Eigen::MatrixXd& a, Eigen::Ref<const Eigen::VectorXd> x,
                   Eigen::Ref<Eigen::VectorXd> out) {
  out.setZero();
  add_columns(a.data(), a.rows(), static_cast<int>(a.cols()), x.data(), out.data(), a.rows());
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
