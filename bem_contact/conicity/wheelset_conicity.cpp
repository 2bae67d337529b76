#include "bem_contact/conicity/wheelset_conicity.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/conicity/settings.hpp"

#include <fmt/format.h>

namespace bem_contact {

WheelsetConicity wheelset_conicity(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes) {
  const double largest = amplitudes.largest, step = amplitudes.step;
  if (!(step > 0 && largest >= step && largest <= 45 && largest / step <= 10000))
    throw InputError(
        fmt::format("The conicity cannot be given for amplitudes up to {:g} mm in steps of {:g} mm", largest,
                    step),
        "the step must be above 0 and not above the largest, the largest at most 45 mm, and 10000 of them "
        "are allowed",
        "Give both in mm, as 10 and 1.");
  WheelsetConicity out{.lengths = {wheelset.contact_distance(), wheelset.position.wheel_radius},
                       .stands = rolling_radius_difference(wheelset, largest + beyond_amplitude),
                       .values = {}};
  std::vector<RadiusDifference> function;
  for (const WheelsetStand& s : out.stands)
    function.push_back({s.lateral, s.difference()});
  const int count = static_cast<int>(largest / step + 1e-9);
  for (int k = 1; k <= count; ++k)
    out.values.push_back({k * step, equivalent_conicity(function, k * step, out.lengths)});
  return out;
}

} // namespace bem_contact
