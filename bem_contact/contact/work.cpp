#include "bem_contact/contact/work.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/settings.hpp"

#include <fmt/format.h>

namespace bem_contact {

WorkBudget::WorkBudget() : WorkBudget(contact::most_work) {}

WorkBudget::WorkBudget(const std::atomic<bool>* stop) : most_(contact::most_work), stop_(stop) {}

void WorkBudget::spend(double units) {
  end_if_stopped(stop_);
  used_ += units;
  if (used_ > most_)
    throw ConvergenceError(
        "The work allowed for one case is used up",
        fmt::format("{:.2g} products with influence numbers times elements, and there is no "
                    "solution yet",
                    most_),
        "Give larger elements (grid.dx, grid.ds), a less strict grid.accuracy, or fewer rows "
        "(grid.s_from, grid.s_to).");
}

double product_work(bool translational, int rows) {
  return translational ? 1.0 : 1.0 + rows / contact::rows_per_unit;
}

double spectra_work(bool translational, int pairs, double rows, double columns) {
  return translational ? 0.0 : pairs * rows * rows * columns * columns / contact::spectra_terms_per_unit;
}

double sweep_work(double elements) {
  return contact::sweep_units * elements * elements;
}

} // namespace bem_contact
