#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standards/standard_tables.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"

#include <pybind11/numpy.h>

#include <optional>
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

py::dict curve_of(const ProfileCurve& curve, double step) {
  std::vector<double> s, y, z, inclination, curvature;
  for (const CurvePoint& p : points_along(curve, step)) {
    s.push_back(p.s);
    y.push_back(p.position.y);
    z.push_back(p.position.z);
    inclination.push_back(p.delta);
    curvature.push_back(p.curvature);
  }
  return py::dict("s"_a = array_of(s), "y"_a = array_of(y), "z"_a = array_of(z),
                  "inclination"_a = array_of(inclination), "curvature"_a = array_of(curvature));
}

double inclination_of(const MeasuredProfile& profile, ProfileKind kind) {
  return profile.points > 0 && kind == ProfileKind::rail
             ? rail_inclination(profile.curve, profile.scatter_left())
             : 0;
}

py::object like_of(const MeasuredProfile& profile, ProfileKind kind, double inclination) {
  const std::optional<LikeStandard> like =
      profile.points > 0 ? like_standard(profile.curve, kind, profile.scatter_left()) : std::nullopt;
  if (!like)
    return py::none();
  return py::dict("name"_a = like->name, "other"_a = like->other, "least_depth"_a = like->least_depth,
                  "largest_depth"_a = like->largest_depth, "angle"_a = like->angle,
                  "inclination"_a = inclination);
}

py::object noise_of(const MeasuredProfile& p) {
  if (p.points == 0 || p.noise.coarse)
    return py::none();
  return py::dict("scatter"_a = p.noise.scatter, "spacing"_a = p.noise.spacing,
                  "pressure"_a = p.noise.pressure, "smoothing"_a = p.noise.smoothing);
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
  const MeasuredProfile found = described_profile(name, its, reading_of(name, its, reading));
  py::list outliers;
  for (const Outlier& o : found.outliers)
    outliers.append(py::dict("y"_a = o.point.y, "z"_a = o.point.z, "distance"_a = o.distance));
  py::dict out = curve_of(found.curve, step);
  out["kind"] = std::string(name_of(its));
  out["name"] = found.curve.name();
  out["points"] = found.points;
  out["noise"] = noise_of(found);
  out["outliers"] = outliers;
  const double inclination = inclination_of(found, its);
  out["like"] = like_of(found, its, inclination);
  out["inclination_in_file"] = inclination;
  out["removed_rms"] = found.removed_rms;
  out["removed_most"] = found.removed_most;
  return out;
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
      "measured file `points` (how many), `noise` (None where it is not known: `scatter` and `spacing`, mm; "
      "`pressure`, MPa, by which a curve through all points is off; `smoothing`, mm, advised, 0: none), "
      "`outliers` (dicts of y, z, distance, mm), `like` (the nearest standard or None: `name`, `other`, "
      "`least_depth` and `largest_depth` worn off, mm, `angle`, rad, `inclination`), "
      "`inclination_in_file` (of a rail that is inclined already, rad, else 0), `removed_rms` and "
      "`removed_most` (by smoothing, mm). Raises InputError for what is no "
      "profile.");
}

} // namespace bem_contact
