#include "bem_contact/app/structure_output.hpp"

#include "bem_contact/app/datasets.hpp"
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
  d[group + "before"] =
      line({body.before.y, body.before.z}, "mm", "point of the body where the scene puts it: y, z");
  d[group + "after"] =
      line({body.after.y, body.after.z}, "mm", "the same point where the contact was solved: y, z");
  d[group + "force"] = line({body.force.begin(), body.force.end()}, "N, N mm",
                            "of the contact on the body, along and about x, y, z at `after`");
  d[group + "motion"] = line({body.motion.begin(), body.motion.end()}, "mm, rad",
                             "compliance times force: along and about x, y, z");
  d[group + "compliance"] = matrix(body.compliance, "mm, N, rad", "motion under each unit force or moment");
  if (body.stiffness)
    d[group + "stiffness"] = matrix(*body.stiffness, "mm, N, rad", "inverse of compliance");
}

} // namespace

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
         (structure->placed ? fmt::format("the bodies stand where their motion takes them, to {:.1e} mm "
                                          "after {} solutions\n",
                                          structure->change, structure->solutions)
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
