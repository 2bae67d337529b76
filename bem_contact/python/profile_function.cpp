#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standards/standard_tables.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/profile_record.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <string>
#include <vector>

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

/// How a file is read, by the keys of the same names in [rail] or [wheel] of a scene, and checked as those.
ProfileReading reading_of(const std::string& name, ProfileKind kind, const py::object& keys) {
  const bool wheel = kind == ProfileKind::wheel;
  std::vector<SceneChange> changes{{"rail.profile", wheel ? "60E1" : name},
                                   {"wheel.profile", wheel ? name : "S1002"}};
  for (SceneChange change : changes_of(keys)) {
    change.key = std::string(name_of(kind)) + '.' + change.key;
    changes.push_back(std::move(change));
  }
  const SceneFile scene = scene_without_file(changes);
  return wheel ? scene.wheel.reading : scene.rail.reading;
}

py::dict profile(const py::object& file, const py::object& of_kind, const py::object& reading, double step) {
  const std::string kind = text_of(of_kind, "kind");
  if (!kind.empty() && kind != "rail" && kind != "wheel")
    throw InputError("There is no kind of profiles '" + kind + "'", "there are rails and wheels",
                     "Give rail or wheel.");
  if (!(step > 0))
    throw InputError("A step of " + std::to_string(step) + " mm cannot be", "no points would lie along it",
                     "Give a step above 0.");
  const std::string name = path_of(file);
  const ProfileKind its = kind_of_profile(name, kind);
  const ProfileReading how = reading_of(name, its, reading);
  const MeasuredProfile found = described_profile(name, its, how);
  return as_dict(record_of(found, findings_of(found, its, how), its, step));
}

py::list standards() {
  py::list out;
  for (const StandardEntry& entry : standard_entries()) {
    py::list others;
    for (const std::string& name : entry.other_names)
      others.append(name);
    out.append(py::dict("name"_a = entry.name, "kind"_a = std::string(name_of(entry.kind)),
                        "part"_a = std::string(name_of(entry.part)), "standard"_a = entry.standard,
                        "other_names"_a = others, "remark"_a = entry.remark));
  }
  return out;
}

} // namespace

void add_profile(py::module_& module) {
  module.def(
      "standards", &standards,
      "All profiles of standards that are built in, as `bem_contact profile --list` prints them: a list of "
      "dicts with `name`, `kind` (rail or wheel), `part` (section: a whole rail; head: of a rail; curve: "
      "the whole contact curve), `standard` and its edition, `other_names` (a list) and `remark`.");
  module.def(
      "profile", &profile, "file"_a, "kind"_a = "", "reading"_a = py::none(), py::kw_only(), "step"_a = 0.1,
      "What a profile file says, as `bem_contact profile` prints it; also of a standard (\"60E1\") or a body "
      "file. `kind`: rail or wheel, needed where neither name nor ending says it. `reading`: keys of [rail] "
      "or "
      "[wheel] of a scene, as {\"smoothing\": 8, \"nominal\": \"S1002\", \"unit\": \"mm\", \"mirror\": "
      "True}. "
      "A dict: arrays `s` (arc length), `y`, `z` (mm, z down), `inclination` (rad) and `curvature` (1/mm, > "
      "0 "
      "convex) at equal steps, at most `step` mm long, in the frame of the profile (y to the field side; a "
      "wheel is walked from the field side, with an inclination near pi on the tread); `kind`, `name`; of a "
      "measured file `points` (how many), `noise` (None where it is not known: `scatter`, `waves` of 2 to 10 "
      "mm "
      "and `spacing`, mm; `pressure`, MPa, by which a curve through all points is off; `smoothing`, mm, that "
      "removes it, 0: none), "
      "`outliers` (dicts of y, z, distance, mm), `like` (the nearest standard or None: `name`, `other`, "
      "`least_depth` and `largest_depth` worn off, mm, `angle`, rad, `inclination`), "
      "`inclination_in_file` (of a rail that is inclined already, rad, else 0), `leans_outwards` (rad), "
      "`advice` (`nominal`, else `smoothing`, mm, and `mirror`: what to give in `reading`), `removed_rms` "
      "and "
      "`removed_most` (by smoothing, mm). EN 15313's numbers, mm: of a wheel `flange` (`Sh`, `Sd`, `qR`), of "
      "a rail that is worn from a standard `wear` (`W1`, `W2`, `W3`); else None. Raises InputError for what "
      "is no "
      "profile.");
}

} // namespace bem_contact
