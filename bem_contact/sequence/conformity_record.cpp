#include "bem_contact/sequence/conformity_record.hpp"

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/fixed_text.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"

#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// mm. A larger radius is printed as straight. Chosen.
constexpr double straight = 20000.0;

std::string radius_words(double radius) {
  return std::abs(radius) < straight ? fmt::format("{:.1f} mm", radius) : "straight";
}

} // namespace

std::span<const ColumnOf<Conformity>> conformity_columns() {
  using C = Conformity;
  static constexpr ColumnOf<Conformity> columns[] = {
      {"lateral", "mm", "lateral displacement of the wheelset", [](const C& c) { return c.lateral; }},
      {"rail_s", "mm", "where the rigid bodies touch first, on the rail",
       [](const C& c) { return c.rail_s; }},
      {"wheel_s", "mm", "the same on the wheel", [](const C& c) { return c.wheel_s; }},
      {"delta", "rad", "inclination of the rail there", [](const C& c) { return c.delta; }},
      {"end_s", "mm", "the gauge point on the rail, or 20 mm from the touching point",
       [](const C& c) { return c.end_s; }},
      {"largest_distance", "mm",
       "along the rail's normal, from the touching point to there; 100: the normal "
       "misses the wheel",
       [](const C& c) { return c.largest; }},
      {"largest_s", "mm", "where on the rail that is", [](const C& c) { return c.largest_s; }},
      {"width", "mm", "arc length around the touching point with a distance below 0.1 mm",
       [](const C& c) { return c.width; }},
      {"turn", "rad", "of the rail's normal over that width", [](const C& c) { return c.turn; }},
      {"rail_radius", "mm", "mean over that width; > 0 convex", [](const C& c) { return c.rail_radius; }},
      {"wheel_radius", "mm", "the same of the wheel's profile", [](const C& c) { return c.wheel_radius; }},
      {"ratio", "1", "of the radii, rail over wheel; 1: the wheel fits exactly",
       [](const C& c) { return c.ratio(); }}};
  return columns;
}

record::Content conformity_of(const std::optional<Conformity>& conformity) {
  if (!conformity)
    return {};
  record::Record out = record::numbers_of(conformity_columns(), false, *conformity);
  out.add("fit", std::string(words_of(conformity->fit())));
  return out;
}

std::string conformity_text(const Conformity& c, const std::string& where) {
  const std::string most = c.largest < excluded_gap ? fmt::format("{:.3f} mm", c.largest)
                                                    : "more than any wheel is near (the normal misses it)";
  return fmt::format(
      "conformity at {}: {}: largest distance {} between s = {} and {} mm; below 0.1 mm over {:.2f} "
      "mm, in which the normal turns by {:.1f} degrees; radii rail {}, wheel {}",
      where, words_of(c.fit()), most, fixed_text(c.rail_s, 2), fixed_text(c.end_s, 2), c.width,
      degrees(c.turn), radius_words(c.rail_radius), radius_words(c.wheel_radius));
}

} // namespace bem_contact
