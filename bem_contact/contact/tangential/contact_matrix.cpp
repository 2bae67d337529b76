#include "bem_contact/contact/tangential/contact_matrix.hpp"

#include "bem_contact/contact/tangential/step_box.hpp"

#include <cstdlib>
#include <utility>

namespace bem_contact::contact {

using Eigen::MatrixXd;

namespace {

/// 1. With a larger share of new elements that matrix is made anew. Chosen.
constexpr double most_new_elements = 0.15;

/// Elements that follow each other in both lists.
struct Run {
  Eigen::Index from, to, count;
};
std::vector<Run> known_runs(const std::vector<int>& place, const std::vector<int>& elements) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const Eigen::Index from = place[elements[k]], to = static_cast<Eigen::Index>(k);
    if (from < 0)
      continue;
    if (runs.empty() || runs.back().to + runs.back().count != to ||
        runs.back().from + runs.back().count != from)
      runs.push_back({from, to, 0});
    ++runs.back().count;
  }
  return runs;
}

MatrixXd matrix_of(const ContactProblem& problem, const std::array<double, 3>& present,
                   const std::vector<int>& elements) {
  const ElementPlaces at(elements, problem.grid.mx);
  const StepNumbers numbers(problem.numbers, at.rows, at.columns, present);
  const auto n = static_cast<Eigen::Index>(elements.size());
  MatrixXd b(2 * n, 2 * n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      for (int d = 0; d < 2; ++d)
        for (int c = 0; c < 2; ++c)
          b(2 * i + c, 2 * j + d) = numbers.line(at.column[i], at.row[i], c, at.row[j], d)[at.column[j]];
  return b;
}

} // namespace

ContactMatrix::ContactMatrix(const ContactProblem& problem, const std::array<double, 3>& present,
                             const std::vector<int>& the_elements)
    : ContactMatrix(the_elements, matrix_of(problem, present, the_elements)) {}

ContactMatrix::ContactMatrix(const std::vector<int>& the_elements, MatrixXd the_b)
    : elements(the_elements), b(std::move(the_b)), scale(b.size() > 0 ? b.diagonal().maxCoeff() : 1),
      fast((b / scale).cast<float>()) {}

ContactMatrix ContactMatrix::with(const ContactProblem& problem, const std::array<double, 3>& present,
                                  const std::vector<int>& others) const {
  std::vector<int> place(problem.grid.size(), -1);
  for (std::size_t k = 0; k < elements.size(); ++k)
    place[elements[k]] = static_cast<int>(k);
  std::vector<Eigen::Index> fresh;
  for (std::size_t k = 0; k < others.size(); ++k)
    if (place[others[k]] < 0)
      fresh.push_back(static_cast<Eigen::Index>(k));
  if (static_cast<double>(fresh.size()) > most_new_elements * static_cast<double>(others.size()))
    return {problem, present, others};
  const auto n = static_cast<Eigen::Index>(others.size());
  MatrixXd out(2 * n, 2 * n);
  const int mx = problem.grid.mx;
  const auto entry = [&](int to, int c, int from, int d) {
    const int offset = to % mx - from % mx;
    double sum = 0;
    for (int k = 0; k <= rolling_columns; ++k)
      sum += present[k] * (offset + k < 0 ? parity(c, d) : 1) *
             problem.numbers.at(std::abs(offset + k), to / mx, c, from / mx, d);
    return sum;
  };
  const auto add_entries = [&](Eigen::Index i, Eigen::Index j) {
    for (int d = 0; d < 2; ++d)
      for (int c = 0; c < 2; ++c)
        out(2 * i + c, 2 * j + d) = entry(others[i], c, others[j], d);
  };
  const std::vector<Run> runs = known_runs(place, others);
  for (Eigen::Index j = 0; j < n; ++j) {
    const int from = place[others[j]];
    if (from < 0) {
      for (Eigen::Index i = 0; i < n; ++i)
        add_entries(i, j);
      continue;
    }
    for (const Run& run : runs)
      out.block(2 * run.to, 2 * j, 2 * run.count, 2) = b.block(2 * run.from, 2 * from, 2 * run.count, 2);
    for (const Eigen::Index i : fresh)
      add_entries(i, j);
  }
  return {others, std::move(out)};
}

} // namespace bem_contact::contact
