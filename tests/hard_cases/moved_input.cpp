#include "tests/hard_cases/moved_input.hpp"

#include "bem_contact/contact/solve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace bem_contact::hard {
namespace {

constexpr std::array sizes{1e-9, 1e-6, 1e-3};
constexpr std::array fractions{0.125, 0.25, 0.5};

using Move = std::function<void(ContactProblem&, double size)>;

void scale(std::span<double> values, double factor) {
  for (double& v : values)
    v *= factor;
}

/// Largest elastic displacement, about the approach of the bodies.
double approach_scale(const ContactProblem& problem, const ContactResult& result) {
  double least = problem.gap.front();
  for (const double h : problem.gap)
    least = std::min(least, h);
  return std::abs(result.totals.approach - least);
}

std::vector<std::pair<std::string, Move>> moves(const ContactProblem& problem, double noise_scale) {
  std::vector<std::pair<std::string, Move>> all;
  if (problem.load == LoadKind::force)
    all.emplace_back("force", [](ContactProblem& p, double e) { p.force *= 1 + e; });
  else
    all.emplace_back("approach", [](ContactProblem& p, double e) { p.approach *= 1 + e; });
  all.emplace_back("distance", [](ContactProblem& p, double e) { scale(p.gap, 1 + e); });
  all.emplace_back("influence numbers", [](ContactProblem& p, double e) { scale(p.numbers.values, 1 + e); });
  all.emplace_back("noise on the distance", [noise_scale](ContactProblem& p, double e) {
    std::mt19937 random(11);
    std::normal_distribution<> height(0, e * noise_scale);
    for (double& h : p.gap)
      h += height(random);
  });
  if (problem.has_friction()) {
    all.emplace_back("friction", [](ContactProblem& p, double e) { p.friction *= 1 + e; });
    all.emplace_back("rigid slip", [](ContactProblem& p, double e) {
      scale(p.slip_x, 1 + e);
      scale(p.slip_s, 1 + e);
    });
  }
  return all;
}

struct Total {
  const char* name;
  double change; ///< over its scale
};

double pressure_sum(const ContactProblem& problem, const ContactResult& result) {
  double sum = 0;
  for (const double p : result.pn)
    sum += p * problem.element_area();
  return sum;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// Scales: pressure's sum for forces, mu times it for shear, pmax, the approach.
std::vector<Total> changes(const ContactProblem& problem, const ContactResult& before,
                           const ContactResult& after, double length) {
  const double carried = pressure_sum(problem, before);
  std::vector<Total> all{{"Fz", std::abs(after.totals.Fz - before.totals.Fz) / carried},
                         {"pmax", std::abs(largest(after.pn) - largest(before.pn)) / largest(before.pn)},
                         {"approach", std::abs(after.totals.approach - before.totals.approach) / length}};
  if (problem.has_friction()) {
    const double shear = std::hypot(after.totals.Fx - before.totals.Fx, after.totals.Fy - before.totals.Fy);
    all.push_back({"shear force", shear / (problem.largest_friction() * carried)});
  }
  return all;
}

/// The undeformed distance and the rigid slip `fraction` of an element further along x, by cubics through
/// four columns.
ContactProblem shifted(const ContactProblem& problem, double fraction) {
  ContactProblem out = problem;
  const int mx = problem.grid.mx;
  const auto shift = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const int ix = static_cast<int>(i) % mx, first = std::clamp(ix - 1, 0, mx - 4);
      const double t = ix + fraction - first;
      double sum = 0;
      for (int a = 0; a < 4; ++a) {
        double weight = 1;
        for (int b = 0; b < 4; ++b)
          if (b != a)
            weight *= (t - b) / (a - b);
        sum += weight * from[i - ix + first + a];
      }
      to[i] = sum;
    }
  };
  shift(problem.gap, out.gap);
  shift(problem.slip_x, out.slip_x);
  shift(problem.slip_s, out.slip_s);
  return out;
}

} // namespace

void print_moved(const std::string& name, const ContactProblem& problem, SolverOptions options) {
  if (std::getenv("BEM_CONTACT_MOVED_INPUT") == nullptr)
    return;
  options.tolerance = 1e-12; // far below the changes that are looked for
  options.estimate_discretisation = false;
  const ContactResult before = solve(problem, options);
  if (!before.certified())
    return;
  const double length = approach_scale(problem, before);
  for (const auto& [input, move] : moves(problem, length))
    for (const double size : sizes) {
      ContactProblem moved = problem;
      move(moved, size);
      const ContactResult after = solve(moved, options);
      if (!after.certified())
        std::printf("moved | %s | %s | %.0e | not converged | -\n", name.c_str(), input.c_str(), size);
      else
        for (const Total& total : changes(problem, before, after, length))
          std::printf("moved | %s | %s | %.0e | %s | %.3g\n", name.c_str(), input.c_str(), size, total.name,
                      total.change / size);
    }
  if (problem.grid.mx < 4)
    return;
  for (const double fraction : fractions) {
    const ContactResult after = solve(shifted(problem, fraction), options);
    for (const Total& total : changes(problem, before, after, length))
      std::printf("shifted | %s | %g | %s | %.3g\n", name.c_str(), fraction, total.name, total.change);
  }
}

} // namespace bem_contact::hard
