#include "bem_contact/app/output/asked_output.hpp"

#include "bem_contact/base/counted.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::app {

namespace {

std::string body_text(const char* name, const std::optional<BodyMotion>& body) {
  if (!body)
    return "";
  const SixNumbers& m = body->motion;
  return fmt::format(
      "structure of the {}: point y {:.4f}, z {:.4f} mm moves by x {:+.4f}, y {:+.4f}, z {:+.4f} "
      "mm and turns by {:+.3e}, {:+.3e}, {:+.3e} rad about x, y, z\n",
      name, body->before.y, body->before.z, m[0], m[1], m[2], m[3], m[4], m[5]);
}

} // namespace

std::string stresses_text(const std::optional<StressesBelow>& stresses) {
  if (!stresses || stresses->largest_shear.empty())
    return "";
  const StressesBelow& b = *stresses;
  const std::size_t nd = b.depths.size(), ns = b.s.size();
  const auto largest = [](const StressField& f) { // nan: the body is not there
    const auto known = [](double stress) { return std::isnan(stress) ? -1 : stress; };
    return static_cast<std::size_t>(std::ranges::max_element(f.largest_shear, {}, known) -
                                    f.largest_shear.begin());
  };
  const auto line = [&](const StressField& f, std::size_t at, const std::vector<double>& s) {
    return fmt::format(
        "largest shear stress {:.1f} MPa (von Mises {:.1f}) at x = {:g}, s = {:g}, depth {:g} mm",
        f.largest_shear[at], f.von_mises[at], b.x[at / nd / ns], s[at / nd % ns], b.depths[at % nd]);
  };
  std::string out = fmt::format("below the surface: {}, of {}\n", line(b, largest(b), b.s),
                                counted(b.largest_shear.size(), "point", "points"));
  for (const StressesInBody& body : b.bodies) {
    const std::size_t at = largest(body.in_body), flat = largest(body.halfspace);
    out += fmt::format("in the {} ({}): {}; a half-space has {:.1f} MPa: the body {:+.1f} %\n",
                       name_of(body.side), body.body, line(body.in_body, at, body.s),
                       body.halfspace.largest_shear[flat],
                       100 * (body.in_body.largest_shear[at] / body.halfspace.largest_shear[flat] - 1));
  }
  return out;
}

std::string structure_text(const std::optional<StructuralResult>& structure) {
  if (!structure)
    return "";
  const std::string bodies = body_text("rail", structure->rail) + body_text("wheel", structure->wheel);
  const std::string shift_y =
      structure->shift_y
          ? fmt::format("the surfaces in contact slide past each other: the wheel is moved by y {:+.4f} "
                        "mm, beyond what the structures do\n",
                        *structure->shift_y)
          : "";
  return bodies + shift_y +
         (structure->placed
              ? fmt::format("the bodies stand where their motion takes them, to {:.1e} mm "
                            "after {}\n",
                            structure->change, counted(structure->solutions, "solution", "solutions"))
              : "the geometry is that of the bodies before this motion\n");
}

} // namespace bem_contact::app
