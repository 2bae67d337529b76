#pragma once

#include "bem_contact/uses/wheelset/equilibrium.hpp"

#include <optional>

namespace bem_contact {

/// Where all forces on the axle are met, wheelset.force_y among them, by one search for all unknowns: from an
/// equilibrium at a displacement near it. Its first step is that of the solution's derivatives, and Broyden's
/// updates follow. Nothing where the wheels have no derivatives, or where a few steps do not lead there. The
/// search at one displacement after the other (solve_lateral_force()) then takes over.
std::optional<Equilibrium> find_lateral_equilibrium(WheelPair& wheels, const WheelsetState& near,
                                                    double tolerance);

} // namespace bem_contact
