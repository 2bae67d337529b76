// What is kept for contacts of few elements while elements enter and leave the contact: against matrices that
// are made anew.
#include "bem_contact/contact/normal/bordered_factor.hpp"
#include "bem_contact/contact/normal/settings.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/contact/tangential/contact_matrix.hpp"
#include "bem_contact/contact/tangential/newton_factors.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/contact/textbook.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using namespace bem_contact;
using namespace bem_contact::contact;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Eigen::VectorXf;

ContactProblem small_problem() {
  return scenes::flat(scenes::steel, {27000.0, 0.33}, 12, 10, 0.5, 0.4, 1, 1);
}

/// A disc of the grid's elements.
std::vector<int> disc(const ContactProblem& problem) {
  std::vector<int> out;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (std::hypot(i % 12 - 5.5, i / 12 - 4.5) < 4.3)
      out.push_back(i);
  return out;
}

/// Without `leaving` of the elements, and with `entering` of the others; in rising order.
std::vector<int> changed(const ContactProblem& problem, const std::vector<int>& elements, int leaving,
                         int entering, std::mt19937& random) {
  std::vector<int> in = elements, out;
  for (int i = 0; i < problem.grid.size(); ++i)
    if (!std::ranges::binary_search(elements, i))
      out.push_back(i);
  std::ranges::shuffle(in, random);
  std::ranges::shuffle(out, random);
  in.resize(in.size() - leaving);
  in.insert(in.end(), out.begin(), out.begin() + entering);
  std::ranges::sort(in);
  return in;
}

MatrixXd whole_block(const NormalLines& lines, const std::vector<int>& elements) {
  return lines.block(elements).selfadjointView<Eigen::Lower>();
}

TEST(BorderedFactor, SolvesForElementsThatCameAndWent) {
  const ContactProblem problem = small_problem();
  const NormalLines lines(problem.numbers, problem.grid.mx);
  const std::vector<int> first = disc(problem);
  std::mt19937 random(1);
  BorderedFactor factor(lines, first);
  ASSERT_TRUE(factor.positive());
  for (const auto& [leaving, entering] :
       {std::pair(0, 0), {1, 0}, {0, 1}, {3, 0}, {0, 3}, {2, 3}, {4, 2}, {0, 0}, {1, 1}}) {
    const std::vector<int> now = changed(problem, first, leaving, entering, random);
    ASSERT_TRUE(factor.use_elements(lines, now)) << leaving << ", " << entering;
    ASSERT_TRUE(factor.positive());
    EXPECT_EQ(factor.elements(), now);
    const VectorXd right = VectorXd::Random(static_cast<Eigen::Index>(now.size()));
    const VectorXd exact = whole_block(lines, now).llt().solve(right);
    EXPECT_LT((factor.solve(right) - exact).norm(), 1e-12 * exact.norm()) << leaving << ", " << entering;
  }
}

TEST(BorderedFactor, ManyChangesAskForAFactorOfTheirOwn) {
  const ContactProblem problem = small_problem();
  const NormalLines lines(problem.numbers, problem.grid.mx);
  const std::vector<int> first = disc(problem);
  std::mt19937 random(2);
  BorderedFactor factor(lines, first);
  const int many = static_cast<int>(most_bordered * static_cast<double>(first.size())) + 1;
  EXPECT_FALSE(factor.use_elements(lines, changed(problem, first, many, 0, random)));
  EXPECT_EQ(factor.elements(), first) << "nothing changes";
  const VectorXd right = VectorXd::Ones(static_cast<Eigen::Index>(first.size()));
  EXPECT_LT((whole_block(lines, first) * factor.solve(right) - right).norm(), 1e-11);
}

TEST(BorderedFactor, SaysWhatIsNotPositiveDefinite) {
  ContactProblem problem = small_problem();
  const std::vector<int> first = disc(problem);
  problem.numbers.at(1, 0, component_n, 0, component_n) *= 20; // neighbours pull each other down
  const NormalLines wrong(problem.numbers, problem.grid.mx);
  EXPECT_FALSE(BorderedFactor(wrong, first).positive());
  std::vector<int> apart; // every other column
  for (int i = 0; i < problem.grid.size(); i += 2)
    apart.push_back(i);
  BorderedFactor factor(wrong, apart);
  ASSERT_TRUE(factor.positive());
  std::vector<int> together = apart;
  together.insert(together.begin() + 1, 1);
  ASSERT_TRUE(factor.use_elements(wrong, together));
  EXPECT_FALSE(factor.positive());
}

TEST(ContactMatrix, IsTheTextbooksAndStaysItWhereElementsChange) {
  ContactProblem problem = small_problem();
  scenes::set_creepage(problem, 0.3, 1e-3, 0, 0);
  const std::array<double, 3> present = slip_step(problem).present;
  std::mt19937 random(3);
  ContactMatrix matrix(problem, present, disc(problem));
  for (const auto& [leaving, entering] : {std::pair(2, 0), {0, 2}, {3, 4}, {0, 0}, {30, 20}}) {
    matrix = matrix.with(problem, present, changed(problem, matrix.elements, leaving, entering, random));
    const ContactMatrix anew(problem, present, matrix.elements);
    EXPECT_LT((matrix.b - anew.b).cwiseAbs().maxCoeff(), 1e-15 * anew.b.cwiseAbs().maxCoeff());
    EXPECT_EQ(matrix.fast, (matrix.b / matrix.scale).cast<float>());
    for (const std::size_t to : {std::size_t{0}, matrix.elements.size() - 1})
      for (std::size_t from = 0; from < matrix.elements.size(); ++from)
        for (const int c : {component_x, component_s})
          for (const int d : {component_x, component_s})
            EXPECT_NEAR(
                matrix.b(2 * static_cast<Eigen::Index>(to) + c, 2 * static_cast<Eigen::Index>(from) + d),
                textbook::step_number(problem, matrix.elements[to], c, matrix.elements[from], d),
                1e-15 * matrix.b.cwiseAbs().maxCoeff());
  }
}

/// Of each element whether it sticks, slips a little or slips fully, in turn.
std::vector<NewtonElement> mixed_states(std::size_t count, float stiffness) {
  std::vector<NewtonElement> out;
  for (std::size_t a = 0; a < count; ++a) {
    const float angle = 0.1f * static_cast<float>(a);
    const Eigen::Vector2f along(-std::sin(angle), std::cos(angle));
    const float m = a % 3 == 0 ? 2.0f : a % 3 == 1 ? 0.3f : 0.0f;
    out.push_back({m == 2 ? Eigen::Matrix2f(Eigen::Matrix2f::Identity())
                          : Eigen::Matrix2f(m * along * along.transpose()),
                   stiffness, m});
  }
  return out;
}

TEST(NewtonFactors, SolveAlongBoundsAndLeaveTheRest) {
  ContactProblem problem = small_problem();
  scenes::set_creepage(problem, 0.3, 1e-3, 0, 0);
  const ContactMatrix matrix(problem, slip_step(problem).present, disc(problem));
  const auto stiffness = static_cast<float>(matrix.scale / matrix.b(0, 0));
  const std::vector<NewtonElement> elements = mixed_states(matrix.elements.size(), stiffness);
  NewtonFactors factors(matrix.elements, elements, matrix.fast);
  ASSERT_TRUE(factors.regular());
  VectorXf v = VectorXf::Random(matrix.b.rows());
  for (std::size_t a = 0; a < elements.size(); ++a) // nothing across a bound
    v.segment<2>(2 * static_cast<Eigen::Index>(a)) =
        elements[a].along(v.segment<2>(2 * static_cast<Eigen::Index>(a)));
  VectorXf x(v.size()), image(v.size());
  factors.solve(elements, v, x);
  newton_image(elements, {}, x, matrix.fast * x, image);
  EXPECT_LT((image - v).norm(), 1e-5f * v.norm());

  // An element that the factors do not know, and one that has gone.
  std::vector<int> others = matrix.elements;
  others.erase(others.begin());
  others.push_back(problem.grid.size() - 1);
  factors.use_elements(others);
  std::vector<NewtonElement> now(elements.begin() + 1, elements.end());
  now.push_back(elements.front());
  VectorXf right = VectorXf::Zero(v.size());
  right.tail<2>().setOnes();
  factors.solve(now, right, x);
  EXPECT_EQ(x, right);
}

} // namespace
