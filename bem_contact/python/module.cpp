#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

namespace py = pybind11;

namespace bem_contact {

namespace {

using Changes = std::map<std::string, py::object>;

/// NumPy's numbers too. Throws TypeError for what no key of a scene can be.
SchemaValue value_of(const std::string& key, const py::object& value) {
  if (py::isinstance<py::bool_>(value))
    return value.cast<bool>();
  if (py::isinstance<py::str>(value))
    return value.cast<std::string>();
  if (py::hasattr(value, "__index__"))
    return value.cast<std::int64_t>();
  if (py::hasattr(value, "__float__"))
    return value.cast<double>();
  throw py::type_error("The value of " + key +
                       " cannot be used (it is no number, text, True or False) "
                       "Give one of these.");
}

std::vector<SceneChange> list_of(const Changes& changes) {
  std::vector<SceneChange> list;
  for (const auto& [key, value] : changes)
    list.push_back({key, value_of(key, value)});
  return list;
}

/// `model`: instead of the scene's own; "" for that.
SceneFile scene_of(const std::filesystem::path& file, const std::vector<SceneChange>& changes,
                   const std::string& model) {
  const SceneFile scene = read_scene_file(file, changes);
  return model.empty() ? scene : with_model(scene, model_named(model));
}

/// Nothing of Python is touched while a scene is solved: other threads may go on.
class PythonSequence {
public:
  explicit PythonSequence(std::filesystem::path scene) : scene_(std::move(scene)) {}

  SceneResult solve(const Changes& changes, const std::string& model) {
    const std::vector<SceneChange> list = list_of(changes);
    const py::gil_scoped_release others_may_run;
    return sequence_.solve(scene_of(scene_, list, model));
  }

private:
  std::filesystem::path scene_;
  Sequence sequence_;
};

SceneResult solve_one(const std::filesystem::path& file, const Changes& changes, const std::string& model) {
  return PythonSequence(file).solve(changes, model);
}

py::array_t<double> line(std::vector<double> values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// [ms][mx]; zeros where the result has none, as a frictionless one has no slip.
py::array_t<double> field(const SceneResult& r, std::vector<double> values) {
  const ContactGrid& grid = r.problem.grid;
  values.resize(grid.size(), 0.0);
  return py::array_t<double>({grid.ms, grid.mx}, values.data());
}

template <class Of> std::vector<double> each_row(const SceneResult& r, const Of& of) {
  std::vector<double> values;
  for (const ContactRow& row : r.problem.rows)
    values.push_back(of(row));
  return values;
}

std::vector<double> columns(const ContactGrid& grid) {
  std::vector<double> x;
  for (int ix = 0; ix < grid.mx; ++ix)
    x.push_back(grid.x(ix));
  return x;
}

std::vector<double> states(const ContactResult& result) {
  std::vector<double> out;
  for (const ElementState state : result.state)
    out.push_back(static_cast<double>(state));
  return out;
}

py::dict patch_of(const PatchSummary& p) {
  using namespace py::literals;
  return py::dict("Fn"_a = p.fn, "Fx"_a = p.fx, "Fs"_a = p.fs, "approach"_a = p.approach, "pmax"_a = p.pmax,
                  "area"_a = p.area, "contact"_a = p.contact, "adhesion"_a = p.adhesion, "slip"_a = p.slip,
                  "x"_a = p.x, "s"_a = p.s);
}

std::vector<py::dict> patches_of(const SceneResult& r) {
  std::vector<py::dict> out;
  for (const PatchSummary& patch : r.result.patches)
    out.push_back(patch_of(patch));
  return out;
}

/// Totals of every step of a transient or a shift, [steps] each.
py::dict history_of(const SceneResult& r) {
  py::dict out;
  const std::pair<const char*, double ContactResult::*> totals[] = {
      {"Fx", &ContactResult::Fx},
      {"Fy", &ContactResult::Fy},
      {"Fz", &ContactResult::Fz},
      {"Fs", &ContactResult::Fs},
      {"approach", &ContactResult::approach},
      {"creepage_x", &ContactResult::creepage_x},
      {"creepage_s", &ContactResult::creepage_s}};
  for (const auto& [name, member] : totals) {
    std::vector<double> values;
    for (const ContactResult& step : r.history)
      values.push_back(step.*member);
    out[name] = line(std::move(values));
  }
  return out;
}

void add_totals(py::class_<SceneResult>& c) {
  const auto total = [&](const char* name, double ContactResult::*member, const char* doc) {
    c.def_property_readonly(
        name, [member](const SceneResult& r) { return r.result.*member; }, doc);
  };
  total("Fx", &ContactResult::Fx, "On the rail, N");
  total("Fy", &ContactResult::Fy, "On the rail, N, towards the side of this wheel");
  total("Fz", &ContactResult::Fz, "On the rail, N, down");
  total("Fs", &ContactResult::Fs, "Shear force along the tangent at the reference point, N");
  total("approach", &ContactResult::approach, "mm");
  total("creepage_x", &ContactResult::creepage_x, "Found for load.force_x, added to motion.xi");
  total("creepage_s", &ContactResult::creepage_s, "Found for load.force_s, added to motion.eta");
  c.def_readonly("Mz", &SceneResult::moment, "About the vertical through the reference point, N mm");
  c.def_property_readonly(
      "pmax", [](const SceneResult& r) { return largest_pressure(r.result); }, "MPa");
  c.def_property_readonly(
      "area", [](const SceneResult& r) { return contact_area(r.result); }, "mm2");
  c.def_property_readonly(
      "friction_power",
      [](const SceneResult& r) { return friction_power(r.result, r.problem.element_area()); },
      "N mm per mm rolled (shift: N mm)");
  c.def_property_readonly("patches", patches_of, "One dict for each connected area, the largest force first");
  c.def_property_readonly("history", history_of, "Totals of every step: dict of arrays [steps]");
}

void add_fields(py::class_<SceneResult>& c) {
  const auto add = [&](const char* name, std::vector<double> ContactResult::*member, const char* doc) {
    c.def_property_readonly(
        name, [member](const SceneResult& r) { return field(r, r.result.*member); }, doc);
  };
  add("p_x", &ContactResult::px, "Traction on the rail along x, MPa, [ms][mx]");
  add("p_s", &ContactResult::ps, "Traction on the rail along s, MPa, [ms][mx]");
  add("p_n", &ContactResult::pn, "Pressure, MPa, [ms][mx]");
  add("slip_x", &ContactResult::slip_x, "Slip per unit of rolled distance (shift: mm), [ms][mx]");
  add("slip_s", &ContactResult::slip_s, "Slip per unit of rolled distance (shift: mm), [ms][mx]");
  add("deformed_distance", &ContactResult::deformed_distance, "mm, [ms][mx]");
  c.def_property_readonly(
      "state", [](const SceneResult& r) { return field(r, states(r.result)); },
      "0 exterior, 1 adhesion, 2 slip, [ms][mx]");
  c.def_property_readonly(
      "gap", [](const SceneResult& r) { return field(r, r.problem.gap); },
      "Undeformed distance along the rail's normal, mm, [ms][mx]");
  c.def_property_readonly(
      "u_n", [](const SceneResult& r) { return field(r, r.result.displacements.un); },
      "Displacement difference along n, wheel less rail, mm, [ms][mx]");
  c.def_property_readonly(
      "x", [](const SceneResult& r) { return line(columns(r.problem.grid)); },
      "Middle of the columns, rolling direction, mm, [mx]");
  const auto rows = [&](const char* name, auto of, const char* doc) {
    c.def_property_readonly(
        name, [of](const SceneResult& r) { return line(each_row(r, of)); }, doc);
  };
  rows(
      "s", [](const ContactRow& row) { return row.s; }, "Arc length along the rail, mm, [ms]");
  rows(
      "y", [](const ContactRow& row) { return row.position.y; }, "Track frame, mm, [ms]");
  rows(
      "z", [](const ContactRow& row) { return row.position.z; }, "Track frame, down, mm, [ms]");
  rows(
      "delta", [](const ContactRow& row) { return row.delta; }, "Inclination, rad, [ms]");
}

void add_trust(py::class_<SceneResult>& c) {
  c.def_property_readonly(
      "model", [](const SceneResult& r) { return std::string(name_of(r.model)); },
      "hertz, halfspace, tangent_plane or fem");
  c.def_readonly("reason", &SceneResult::reason, "Why this model");
  c.def_readonly("warnings", &SceneResult::warnings);
  c.def_property_readonly(
      "certified", [](const SceneResult& r) { return r.result.certificate.holds(); },
      "Whether the certificate holds: look at it before you use any number");
  c.def_property_readonly(
      "certificate", [](const SceneResult& r) { return r.result.certificate.worst(); },
      "Worst violation of the contact conditions, relative");
  c.def_property_readonly(
      "discretisation",
      [](const SceneResult& r) -> std::optional<double> {
        const double error = r.result.certificate.discretisation;
        return error < 0 ? std::nullopt : std::optional(error);
      },
      "Estimated discretisation error, relative; None: not estimated");
  c.def_property_readonly("seconds", [](const SceneResult& r) { return r.seconds.total; });
  c.def("__repr__", [](const SceneResult& r) {
    return "<bem_contact.Result: " + std::string(name_of(r.model)) + ", Fz " + std::to_string(r.result.Fz) +
           " N, " + std::to_string(r.result.patches.size()) + " patches, " +
           (r.result.certificate.holds() ? "certified>" : "NOT certified>");
  });
}

} // namespace

PYBIND11_MODULE(bem_contact, m) {
  m.doc() = "Conformal wheel-rail contact: scenes (TOML files) solved from Python. Units mm, N, MPa, rad.";
  py::register_exception<InputError>(m, "InputError", PyExc_ValueError);
  py::register_exception<ConvergenceError>(m, "ConvergenceError", PyExc_RuntimeError);
  py::class_<SceneResult> result(m, "Result", "One scene solved with one model. Arrays are copies.");
  add_totals(result);
  add_fields(result);
  add_trust(result);

  using namespace py::literals;
  constexpr const char* of_arguments =
      "`changes`: values of the scene's keys instead of the file's, as {\"position.lateral\": 6.6}. `model`: "
      "auto, hertz, halfspace, tangent_plane or fem; \"\" takes the scene's own. Raises InputError (a "
      "ValueError) for wrong input. Lack of convergence is in the result.";
  m.def("solve", solve_one, "scene"_a, "changes"_a = Changes(), "model"_a = "", of_arguments);
  py::class_<PythonSequence>(
      m, "Sequence",
      "Solves one scene with many changes, each from what the former ones taught: files "
      "are read once, and a case starts from the tractions of the one before.")
      .def(py::init<std::filesystem::path>(), "scene"_a)
      .def("solve", &PythonSequence::solve, "changes"_a = Changes(), "model"_a = "", of_arguments);
}

} // namespace bem_contact
