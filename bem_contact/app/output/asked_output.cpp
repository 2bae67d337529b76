#include "bem_contact/app/output/asked_output.hpp"

#include "bem_contact/base/counted.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

namespace {

using nlohmann::json;

json body_json(const std::optional<BodyMotion>& body) {
  if (!body)
    return nullptr;
  return {{"before", {{"y", body->before.y}, {"z", body->before.z}}},
          {"after", {{"y", body->after.y}, {"z", body->after.z}}},
          {"force", body->force},
          {"motion", body->motion},
          {"compliance", body->compliance},
          {"stiffness", body->stiffness ? json(*body->stiffness) : json(nullptr)}};
}

std::string body_text(const char* name, const std::optional<BodyMotion>& body) {
  if (!body)
    return "";
  const SixNumbers& m = body->motion;
  return fmt::format(
      "structure of the {}: point y {:.4f}, z {:.4f} mm moves by x {:+.4f}, y {:+.4f}, z {:+.4f} "
      "mm and turns by {:+.3e}, {:+.3e}, {:+.3e} rad about x, y, z\n",
      name, body->before.y, body->before.z, m[0], m[1], m[2], m[3], m[4], m[5]);
}

void add_body(H5Table& table, const std::string& group, const BodyMotion& body) {
  auto& d = table.datasets;
  d[group + "before"] = H5Dataset::line({body.before.y, body.before.z}, "mm",
                                        "point of the body where the scene puts it: y, z");
  d[group + "after"] = H5Dataset::line({body.after.y, body.after.z}, "mm",
                                       "the same point where the contact was solved: y, z");
  d[group + "force"] = H5Dataset::line({body.force.begin(), body.force.end()}, "N, N mm",
                                       "of the contact on the body, along and about x, y, z at `after`");
  d[group + "motion"] = H5Dataset::line({body.motion.begin(), body.motion.end()}, "mm, rad",
                                        "compliance times force: along and about x, y, z");
  d[group + "compliance"] =
      H5Dataset::matrix(body.compliance, "mm, N, rad", "motion under each unit force or moment");
  if (body.stiffness)
    d[group + "stiffness"] = H5Dataset::matrix(*body.stiffness, "mm, N, rad", "inverse of compliance");
}

} // namespace

json stresses_json(const std::optional<StressesBelow>& stresses) {
  if (!stresses)
    return nullptr;
  json tensor = json::array();
  for (const halfspace::Stress& t : stresses->stress)
    tensor.push_back({t.xx, t.ss, t.nn, t.xs, t.xn, t.sn});
  return {{"x", stresses->x},
          {"s", stresses->s},
          {"depths", stresses->depths},
          {"components", {"xx", "ss", "nn", "xs", "xn", "sn"}},
          {"stress", tensor},
          {"von_mises", stresses->von_mises},
          {"largest_shear", stresses->largest_shear}};
}

std::string stresses_text(const std::optional<StressesBelow>& stresses) {
  if (!stresses || stresses->largest_shear.empty())
    return "";
  const StressesBelow& b = *stresses;
  const auto at =
      static_cast<std::size_t>(std::ranges::max_element(b.largest_shear) - b.largest_shear.begin());
  const std::size_t nd = b.depths.size(), ns = b.s.size();
  return fmt::format(
      "below the surface: largest shear stress {:.1f} MPa (von Mises {:.1f}) at x = {:g}, s = {:g}, "
      "depth {:g} mm, of {}\n",
      b.largest_shear[at], b.von_mises[at], b.x[at / nd / ns], b.s[at / nd % ns], b.depths[at % nd],
      counted(b.largest_shear.size(), "point", "points"));
}

void add_stresses(H5Table& table, const std::string& group, const StressesBelow& b) {
  table.datasets[group + "x"] = H5Dataset::line(b.x, "mm", "x of the points");
  table.datasets[group + "s"] = H5Dataset::line(b.s, "mm", "arc length of the points along the rail");
  table.datasets[group + "depths"] =
      H5Dataset::line(b.depths, "mm", "depth of the points below the surface, along n");
  const std::vector<std::size_t> shape{b.x.size(), b.s.size(), b.depths.size()};
  table.datasets[group + "von_mises"] = {shape, b.von_mises, "MPa", "von Mises' stress [x][s][depth]"};
  table.datasets[group + "largest_shear"] = {shape, b.largest_shear, "MPa", "largest shear stress"};
  H5Dataset tensor{shape, {}, "MPa", "xx, ss, nn, xs, xn, sn; tension positive; half-space closed forms"};
  tensor.shape.push_back(6);
  for (const halfspace::Stress& t : b.stress)
    tensor.values.insert(tensor.values.end(), {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn});
  table.datasets[group + "stress"] = std::move(tensor);
}

json structure_json(const std::optional<StructuralResult>& structure) {
  if (!structure)
    return nullptr;
  return {{"rail", body_json(structure->rail)},
          {"wheel", body_json(structure->wheel)},
          {"placed", structure->placed},
          {"aside", structure->aside ? json(*structure->aside) : json(nullptr)},
          {"solutions", structure->solutions},
          {"last_change", structure->change},
          {"lowered", structure->lowered},
          {"axes", {"x", "y", "z", "about x", "about y", "about z"}}};
}

std::string structure_text(const std::optional<StructuralResult>& structure) {
  if (!structure)
    return "";
  const std::string bodies = body_text("rail", structure->rail) + body_text("wheel", structure->wheel);
  const std::string aside =
      structure->aside
          ? fmt::format("the surfaces in contact slide past each other: the wheel is moved by y {:+.4f} "
                        "mm, beyond what the structures do\n",
                        *structure->aside)
          : "";
  return bodies + aside +
         (structure->placed
              ? fmt::format("the bodies stand where their motion takes them, to {:.1e} mm "
                            "after {}\n",
                            structure->change, counted(structure->solutions, "solution", "solutions"))
              : "the geometry is that of the bodies before this motion\n");
}

void add_structure(H5Table& table, const std::string& group, const StructuralResult& structure) {
  if (structure.rail)
    add_body(table, group + "rail/", *structure.rail);
  if (structure.wheel)
    add_body(table, group + "wheel/", *structure.wheel);
  table.attributes[group + "placed"] = structure.placed ? 1.0 : 0.0;
  if (structure.aside)
    table.attributes[group + "aside_mm"] = *structure.aside;
  table.attributes[group + "solutions"] = double(structure.solutions);
  table.attributes[group + "last_change_mm"] = structure.change;
  table.attributes[group + "lowered_mm"] = structure.lowered;
}

} // namespace bem_contact::app
