#include "bem_contact/contact/tangential/gcr.hpp"
#include "bem_contact/contact/tangential/settings.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

using namespace bem_contact;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXd;

namespace {

constexpr int elements = 60, unknowns = 2 * elements, most = 200;

/// J = 1 - m + m B with a mask m, as in Newton's method: 1 where an element sticks, else 0.
struct Systems {
  MatrixXd b = MatrixXd::Random(unknowns, unknowns) / unknowns + 2 * MatrixXd::Identity(unknowns, unknowns);
  VectorXd mask = VectorXd::Ones(unknowns);
  contact::Gcr gcr{{contact::kept_solutions, contact::kept_directions}};

  Systems() { gcr.use_elements(numbered(0)); }
  static std::vector<int> numbered(int first) {
    std::vector<int> list(elements);
    std::iota(list.begin(), list.end(), first);
    return list;
  }
  MatrixXd jacobian() const {
    return mask.asDiagonal() * b + MatrixXd((1 - mask.array()).matrix().asDiagonal());
  }
  bool solve(const VectorXd& right, double tolerance, VectorXd& x) {
    const MatrixXf single = b.cast<float>();
    const Eigen::VectorXf m = mask.cast<float>();
    return gcr.solve([&](const auto& z, auto&& bz) { bz = single * z; },
                     [&](const auto& z, const auto& bz, auto&& jz) {
                       jz = m.cwiseProduct(bz) + (1 - m.array()).matrix().cwiseProduct(z);
                     },
                     [](const auto& v, auto&& out) { out = v; }, right, {tolerance, most}, x);
  }
  double relative_residual(const VectorXd& right, const VectorXd& x) const {
    return (right - jacobian() * x).norm() / right.norm();
  }
};

TEST(Gcr, SolvesWhatLuFactorsSolve) {
  Systems systems;
  const VectorXd right = VectorXd::Random(unknowns);
  VectorXd x;
  ASSERT_TRUE(systems.solve(right, 1e-5, x));
  const VectorXd exact = systems.jacobian().partialPivLu().solve(right);
  EXPECT_LT((x - exact).norm(), 1e-4 * exact.norm());
  EXPECT_GT(systems.gcr.products(), 1);
}

TEST(Gcr, WhatItSolvedBeforeCostsNoProduct) {
  Systems systems;
  const VectorXd right = VectorXd::Random(unknowns);
  VectorXd x;
  ASSERT_TRUE(systems.solve(right, 1e-5, x));
  ASSERT_TRUE(systems.solve(-3 * right, 1e-4, x));
  EXPECT_EQ(systems.gcr.products(), 0);
  EXPECT_LT(systems.relative_residual(-3 * right, x), 2e-4);
}

/// Some elements begin to slip: the matrix is another one, and what was kept still serves it.
TEST(Gcr, KeptProductsServeTheNextMatrix) {
  Systems systems, fresh;
  fresh.b = systems.b;
  const VectorXd right = VectorXd::Random(unknowns);
  VectorXd x;
  ASSERT_TRUE(systems.solve(right, 1e-5, x));
  systems.mask.head(6).setZero();
  fresh.mask = systems.mask;
  ASSERT_TRUE(fresh.solve(right, 1e-4, x));
  ASSERT_TRUE(systems.solve(right, 1e-4, x));
  EXPECT_LT(systems.gcr.products(), fresh.gcr.products());
  EXPECT_LT(systems.relative_residual(right, x), 2e-4);
}

/// Products with the matrix of other elements would give a wrong answer that looks solved.
TEST(Gcr, ForgetsProductsOfOtherElements) {
  Systems systems;
  const VectorXd right = VectorXd::Random(unknowns);
  VectorXd x;
  ASSERT_TRUE(systems.solve(right, 1e-5, x));
  systems.b *= 2;
  systems.gcr.use_elements(Systems::numbered(1));
  ASSERT_TRUE(systems.solve(right, 1e-4, x));
  EXPECT_GT(systems.gcr.products(), 0);
  EXPECT_LT(systems.relative_residual(right, x), 2e-4);
}

TEST(Gcr, GoesOnWhenMoreWasSolvedThanIsKept) {
  Systems systems;
  VectorXd x;
  for (int k = 0; k < 3 * contact::kept_solutions; ++k) {
    const VectorXd right = VectorXd::Random(unknowns);
    ASSERT_TRUE(systems.solve(right, 1e-4, x)) << k;
    EXPECT_LT(systems.relative_residual(right, x), 2e-4) << k;
  }
}

/// The same by LU factors of the whole matrix [J, columns; rows', 0].
TEST(Gcr, SolvesABorderedSystem) {
  for (const int further : {1, 2}) {
    const int n = 60;
    std::srand(further);
    const Eigen::MatrixXd j = 4 * Eigen::MatrixXd::Identity(n, n) + 0.3 * Eigen::MatrixXd::Random(n, n);
    const Eigen::MatrixXd columns = Eigen::MatrixXd::Random(n, further),
                          rows = Eigen::MatrixXd::Random(n, further);
    const Eigen::VectorXd rhs = Eigen::VectorXd::Random(n), sums = Eigen::VectorXd::Random(further);
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + further, n + further);
    whole << j, columns, rows.transpose(), Eigen::MatrixXd::Zero(further, further);
    Eigen::VectorXd right(n + further);
    right << rhs, sums;
    const Eigen::VectorXd exact = whole.lu().solve(right);
    const Eigen::MatrixXf fast = j.cast<float>();
    contact::Gcr gcr{{contact::kept_solutions, contact::kept_directions}};
    contact::BorderedSolution found;
    const auto product = [&](const auto& v, auto&& out) { out = fast * v; };
    const auto image = [](const auto&, const auto& bv, Eigen::VectorXf& out) { out = bv; };
    const auto inverse = [](const Eigen::VectorXf& v, auto&& out) { out = 0.25f * v; };
    for (int again = 0; again < 2; ++again) { // the second time from what was kept
      EXPECT_TRUE(gcr.solve(product, image, inverse, rhs, {columns, rows, sums}, {1e-5, 100}, found));
      EXPECT_LT((found.x - exact.head(n)).norm(), 1e-4 * exact.norm());
      EXPECT_LT((found.y - exact.tail(further)).norm(), 1e-4 * exact.norm());
      EXPECT_LT((rows.transpose() * found.x - sums).norm(), 1e-5 * sums.norm());
    }
  }
}

TEST(Gcr, SaysWhereItDidNotConverge) {
  Systems systems;
  systems.b.setZero(); // and the mask is all 1: singular
  VectorXd x;
  EXPECT_FALSE(systems.solve(VectorXd::Random(unknowns), 1e-4, x));
}

} // namespace
