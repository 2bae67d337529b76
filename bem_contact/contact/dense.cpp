#include "bem_contact/contact/dense.hpp"

#include <vector>

extern "C" {
void dposv_(const char* uplo, const int* n, const int* nrhs, double* a, const int* lda, double* b,
            const int* ldb, int* info);
void dgesv_(const int* n, const int* nrhs, double* a, const int* lda, int* pivots, double* b, const int* ldb,
            int* info);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
}

namespace bem_contact::contact {

bool solve_cholesky(Eigen::MatrixXd& a, Eigen::MatrixXd& x) {
  const int n = static_cast<int>(a.rows()), nrhs = static_cast<int>(x.cols());
  int info = 0;
  if (n > 0)
    dposv_("L", &n, &nrhs, a.data(), &n, x.data(), &n, &info);
  return info == 0;
}

bool solve_lu(Eigen::MatrixXd& a, Eigen::MatrixXd& x) {
  const int n = static_cast<int>(a.rows()), nrhs = static_cast<int>(x.cols());
  int info = 0;
  std::vector<int> pivots(a.rows());
  if (n > 0)
    dgesv_(&n, &nrhs, a.data(), &n, pivots.data(), x.data(), &n, &info);
  return info == 0;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd c(a.rows(), b.cols());
  const int m = static_cast<int>(a.rows()), n = static_cast<int>(b.cols()), k = static_cast<int>(a.cols());
  const double one = 1, zero = 0;
  if (c.size() > 0)
    dgemm_("N", "N", &m, &n, &k, &one, a.data(), &m, b.data(), &k, &zero, c.data(), &m);
  return c;
}

} // namespace bem_contact::contact
