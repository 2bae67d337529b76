#include "bem_contact/contact/friction_memory.hpp"

#include <cmath>

namespace bem_contact::contact {

std::vector<double> remembered_factors(const ContactProblem& problem, const std::vector<double>& velocity,
                                       const std::vector<char>& in_contact) {
  const int mx = problem.grid.mx;
  const double seconds = problem.grid.dx / problem.speed; // from element to element
  std::vector<double> out(velocity.size(), 1.0);
  for (int row = 0; row < problem.grid.ms; ++row) {
    double factor = 1, before = 0; // at the leading edge, half an element ahead of the first middle
    for (int i = (row + 1) * mx - 1; i >= row * mx; --i) {
      if (!in_contact[i]) {
        factor = 1;
        before = 0;
        continue;
      }
      const double rate = problem.memory->rate(velocity[i]), law = problem.falling_factor(row, velocity[i]);
      factor = law + (factor - law) * std::exp(-0.5 * (before + rate) * seconds);
      before = rate;
      out[i] = factor;
    }
  }
  return out;
}

} // namespace bem_contact::contact
