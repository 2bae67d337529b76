#include "bem_contact/inside/loaded_inside.hpp"

#include "bem_contact/base/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact::inside {

LoadedInside loaded_by(const record::Record& result, std::uint64_t profile_digest, double poisson,
                       std::span<const BelowSurface> own) {
  const Side side = side_of(result, profile_digest);
  LoadedInside out{read_tractions(result, side), {}};
  if (std::abs(out.tractions.poisson - poisson) > 1e-9)
    throw InputError("The body has another material than the result",
                     fmt::format("Poisson's ratios are {:g} and {:g}", poisson, out.tractions.poisson),
                     "Correct [material] of the body file, or solve the scene again.");
  out.stresses = halfspace_inside(out.tractions, side, own);
  out.stresses.traction_error = traction_error(result);
  return out;
}

} // namespace bem_contact::inside
