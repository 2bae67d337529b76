#include "bem_contact/base/error.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/contact/history.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/sequence_object.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/sequence/printed_errors.hpp"
#include "bem_contact/sequence/result_warnings.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace py = pybind11;

namespace bem_contact {

namespace {

/// None of the arguments is converted by pybind11, so that what is wrong with one is said in our words.
std::unique_ptr<PythonSequence> sequence_of(const py::object& scene, const py::args& more,
                                            const py::kwargs& unknown) {
  refuse_unknown("Sequence", more, unknown);
  return std::make_unique<PythonSequence>(path_of(scene));
}

PythonResult solve_changed(const PythonSequence& sequence, const py::object& changes, const py::object& model,
                           const py::object& strict, const py::args& more, const py::kwargs& unknown) {
  refuse_unknown("solve", more, unknown);
  PythonResult solved{sequence.solve(changes_of(changes), model_of(model)), {}};
  if (py::bool_(strict))
    refuse_warnings(solved.solved->warnings);
  return solved;
}

PythonResult solve_one(const py::object& scene, const py::object& changes, const py::object& model,
                       const py::object& strict, const py::args& more, const py::kwargs& unknown) {
  return solve_changed(PythonSequence(path_of(scene)), changes, model, strict, more, unknown);
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

std::optional<double> known(double error) {
  return std::isnan(error) ? std::nullopt : std::optional(error);
}

py::dict patch_of(const SceneResult& r, std::size_t index) {
  using namespace py::literals;
  const PatchSummary& p = r.result.patches[index];
  py::dict out("Fn"_a = p.fn, "Fx"_a = p.fx, "Fs"_a = p.fs, "approach"_a = p.approach, "pmax"_a = p.pmax,
               "area"_a = p.area, "contact"_a = p.contact, "adhesion"_a = p.adhesion, "slip"_a = p.slip,
               "x"_a = p.x, "s"_a = p.s);
  for (const PrintedPatchNumber& number : printed_patch_numbers())
    out[number.error_name] = known(errors_of_patch(r.result, index).*number.error);
  return out;
}

std::vector<py::dict> patches_of(const SceneResult& r) {
  std::vector<py::dict> out;
  for (std::size_t i = 0; i < r.result.patches.size(); ++i)
    out.push_back(patch_of(r, i));
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

py::object body_of(const std::optional<BodyMotion>& body) {
  using namespace py::literals;
  if (!body)
    return py::none();
  const auto matrix = [](const SixBySix& m) { return py::array_t<double>({6, 6}, m.front().data()); };
  return py::dict("before"_a = std::array{body->before.y, body->before.z},
                  "after"_a = std::array{body->after.y, body->after.z},
                  "force"_a = line({body->force.begin(), body->force.end()}),
                  "motion"_a = line({body->motion.begin(), body->motion.end()}),
                  "compliance"_a = matrix(body->compliance),
                  "stiffness"_a = body->stiffness ? py::object(matrix(*body->stiffness)) : py::none());
}

py::object structure_of(const SceneResult& r) {
  using namespace py::literals;
  if (!r.structure)
    return py::none();
  return py::dict("rail"_a = body_of(r.structure->rail), "wheel"_a = body_of(r.structure->wheel),
                  "placed"_a = r.structure->placed, "solutions"_a = r.structure->solutions,
                  "last_change"_a = r.structure->change, "lowered"_a = r.structure->lowered);
}

void add_totals(ResultClass& c) {
  const auto total = [&](const char* name, double ContactResult::*member, const char* doc) {
    c.def_property_readonly(
        name, [member](const SceneResult& r) { return r.result.*member; }, doc);
  };
  total("Fx", &ContactResult::Fx, "On the rail, N");
  total("Fy", &ContactResult::Fy, "On the rail, N, towards the side of this wheel");
  total("Fz", &ContactResult::Fz, "On the rail, N, down");
  total("Fs", &ContactResult::Fs, "Shear force along the tangent at the reference point, N");
  total("approach", &ContactResult::approach, "mm");
  c.def_readonly("approach_datum", &SceneResult::approach_datum,
                 "Of which points of the bodies the approach is the relative displacement");
  c.def_property_readonly("structure", structure_of,
                          "Structural motion, dict of rail, wheel (force, motion, 6 x 6 compliance and "
                          "stiffness), placed, solutions, "
                          "last_change, lowered; None where no body gives way");
  total("creepage_x", &ContactResult::creepage_x, "Found for load.force_x, added to motion.xi");
  total("creepage_s", &ContactResult::creepage_s, "Found for load.force_s, added to motion.eta");
  c.def_readonly("Mz", &SceneResult::moment, "About the vertical through the reference point, N mm");
  c.def_readonly(
      "lateral", &SceneResult::lateral,
      "Lateral displacement of the wheelset, mm, given or found for load.force_y; None of a patch");
  c.def_property_readonly(
      "other_laterals",
      [](const SceneResult& r) { return r.found_lateral ? r.found_lateral->others : std::vector<double>(); },
      "Other displacements with the same load.force_y, to some hundredths, mm");
  c.def_readonly("xi", &SceneResult::xi, "Longitudinal creepage, with what was found for load.force_x");
  c.def_property_readonly(
      "free_rolling_xi",
      [](const SceneResult& r) { return r.free_rolling ? std::optional(r.free_rolling->xi) : std::nullopt; },
      "Longitudinal creepage at which Fx is 0; None: not looked for");
  c.def_property_readonly(
      "free_rolling_radius",
      [](const SceneResult& r) {
        return r.free_rolling ? std::optional(r.free_rolling->rolling_radius) : std::nullopt;
      },
      "Rolling radius at which Fx is 0, mm; None: not looked for");
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

void add_fields(ResultClass& c) {
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

void add_trust(ResultClass& c) {
  c.def_property_readonly(
      "model", [](const SceneResult& r) { return std::string(name_of(r.model)); },
      "hertz, halfspace, tangent_plane or fem");
  c.def_readonly("reason", &SceneResult::reason, "Why this model");
  c.def_readonly("warnings", &SceneResult::warnings,
                 "What to know before the numbers are used, each with its figure and what to do");
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
  for (const PrintedNumber& number : printed_numbers())
    c.def_property_readonly(
        number.error_name, [error = number.error](const SceneResult& r) { return known(error(r)); },
        "Estimated error by the size of the elements, absolute; None: not known");
  c.def_property_readonly(
      "adhesion_share", [](const SceneResult& r) { return adhesion_share(r.result); },
      "Of the elements in contact");
  c.def_property_readonly(
      "converges_with_elements",
      [](const SceneResult& r) {
        return r.result.discretisation ? std::optional(r.result.discretisation->converges) : std::nullopt;
      },
      "False: smaller elements show another field, and no error can be told; None: not estimated");
  c.def_property_readonly("seconds", [](const SceneResult& r) { return r.seconds.total; });
  c.def("__repr__", [](const py::object& r) {
    return py::str("<bem_contact.Result: {}, Fz {:.6g} N, {} patches, {}>")
        .format(r.attr("model"), r.attr("Fz"), py::len(r.attr("patches")),
                r.attr("certified").cast<bool>() ? "certified" : "NOT certified");
  });
}

} // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled part of the package bem_contact.";
  m.attr("__version__") = std::string(version());
  py::register_exception<InputError>(m, "InputError", PyExc_ValueError);
  py::register_exception<ConvergenceError>(m, "ConvergenceError", PyExc_RuntimeError);
  ResultClass result(m, "One scene solved with one model. Arrays are copies. Can be copied and pickled.");
  add_totals(result);
  add_fields(result);
  add_trust(result);

  using namespace py::literals;
  constexpr const char* of_arguments =
      "`changes`: values of the scene's keys instead of the file's, as {\"position.lateral\": 6.6}; numbers "
      "and "
      "arrays may be NumPy's. `model`: "
      "auto, hertz, halfspace, tangent_plane or fem; \"\" takes the scene's own. Raises InputError (a "
      "ValueError) for wrong input. `strict`: warnings are errors. Lack of convergence is in the result.";
  m.def("solve", solve_one, "scene"_a = py::none(), "changes"_a = py::none(), "model"_a = py::none(),
        "strict"_a = false, of_arguments);
  py::class_<PythonSequence>(
      m, "Sequence",
      "Solves one scene with many changes, each from what the former ones taught: files are read once, and a "
      "case starts from the tractions of the one before. The scene is read, and its paths are fixed, when "
      "the "
      "object is made. Several threads may call one object: each call waits for the one before. Several "
      "objects run side by side. Ctrl-C ends a running solve.")
      .def(py::init(&sequence_of), "scene"_a = py::none())
      .def("solve", &solve_changed, "changes"_a = py::none(), "model"_a = py::none(), "strict"_a = false,
           of_arguments);
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_stopped_solutions));
}

} // namespace bem_contact
