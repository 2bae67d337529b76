#include "bem_contact/contact/work.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Units of work (work.hpp). Some minutes: about 10 times what the costliest accepted case takes (7e8).
constexpr double most_work = 1e10;
/// Rows. A product A p with influence numbers that depend on both rows (that are not translational) costs
/// 1 + rows / this units an element (measured).
constexpr double rows_per_unit = 20.0;
/// 1. Before the first such product the numbers are transformed. For each pair of components that costs
/// rows^2 columns^2 / this units (measured).
constexpr double spectra_terms_per_unit = 75;
/// Units. A Gauss-Seidel sweep costs this times the square of its elements (measured).
constexpr double sweep_units = 0.08;

} // namespace

WorkBudget::WorkBudget() : WorkBudget(most_work) {}

WorkBudget::WorkBudget(const std::atomic<bool>* stop) : most_(most_work), stop_(stop) {}

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
  return translational ? 1.0 : 1.0 + rows / rows_per_unit;
}

double spectra_work(bool translational, int pairs, double rows, double columns) {
  return translational ? 0.0 : pairs * rows * rows * columns * columns / spectra_terms_per_unit;
}

double sweep_work(double elements) {
  return sweep_units * elements * elements;
}

} // namespace bem_contact
