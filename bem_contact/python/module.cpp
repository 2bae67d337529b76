#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/guarded_calls.hpp"
#include "bem_contact/python/python_messages.hpp"
#include "bem_contact/python/record_object.hpp"
#include "bem_contact/python/result_object.hpp"
#include "bem_contact/python/sequence_object.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/report/report_page.hpp"
#include "bem_contact/sequence/conformity_record.hpp"
#include "bem_contact/sequence/derivative_record.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/result_file.hpp"
#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/settings.hpp"
#include "bem_contact/sequence/uncertified.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace py = pybind11;

namespace bem_contact {

namespace {

/// None of the arguments is converted by pybind11, so that what is wrong with one is said in our words.
std::unique_ptr<PythonSequence> sequence_of(const py::object& scene, const py::args& more,
                                            const py::object& folder, int threads,
                                            const py::kwargs& unknown) {
  refuse_unknown("Sequence", {"scene", "folder", "threads"}, more, unknown);
  if (threads < 1 || threads > most_threads)
    throw InputError("A Sequence cannot have " + std::to_string(threads) + " threads",
                     "it takes 1 to " + std::to_string(most_threads),
                     "Give as many as the machine has cores.");
  return std::make_unique<PythonSequence>(scene_of(scene, folder), threads);
}

/// `derivatives`: what the key of that name takes.
PythonResult solved(const PythonSequence& sequence, const py::object& changes, const py::object& model,
                    const py::object& strict, const py::object& derivatives) {
  std::vector<SceneChange> all = changes_of(changes);
  if (!derivatives.is_none()) {
    py::dict asked;
    asked["derivatives"] = derivatives;
    all.push_back(changes_of(asked).front());
  }
  const PythonSequence::Solved found = sequence.solve(std::move(all), model_of(model));
  PythonResult out{found.result, {}, found.given};
  if (py::bool_(strict))
    refuse_warnings(out.solved->warnings);
  return out;
}

PythonResult solve_changed(const PythonSequence& sequence, const py::object& changes, const py::object& model,
                           const py::object& strict, const py::args& more, const py::object& derivatives,
                           const py::kwargs& unknown) {
  refuse_unknown("Sequence.solve", {"changes", "model", "strict", "derivatives"}, more, unknown);
  return solved(sequence, changes, model, strict, derivatives);
}

PythonResult solve_one(const py::object& scene, const py::object& changes, const py::object& model,
                       const py::object& strict, const py::args& more, const py::object& folder,
                       const py::object& derivatives, const py::kwargs& unknown) {
  refuse_unknown("solve", {"scene", "changes", "model", "strict", "folder", "derivatives"}, more, unknown);
  return solved(PythonSequence(scene_of(scene, folder)), changes, model, strict, derivatives);
}

/// [ms][mx]
py::array_t<double> field(const SceneResult& r, const ElementQuantity& quantity) {
  const ContactGrid& grid = r.problem.grid;
  py::array_t<double> out({grid.ms, grid.mx});
  quantity.copy(r, {out.mutable_data(), static_cast<std::size_t>(grid.size())});
  return out;
}

/// None for nan.
std::optional<double> known(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// Writes the file of `bem_contact solve -o`.
void save(const PythonResult& r, const std::filesystem::path& file) {
  if (!r.solved || !r.given)
    throw InputError("This result cannot be saved",
                     r.solved ? "it is one of several of an answer"
                              : "one that was pickled holds only its properties",
                     "Solve the scene of this case alone, and save that.");
  GivenScene given = *r.given;
  require_outputs(files_read(given.text.source, given.scene),
                  {{.option = "file", .file = file, .form = OutputForm::whole_file, .required = true}});
  given.inputs = inputs_of(given.scene);
  record::write_hdf5(file, result_file(*r.solved, given, file));
}

/// Writes the page of `bem_contact report`.
void report_of(const PythonResult& r, const std::filesystem::path& page) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "result.h5";
  save(r, file);
  report::write_report(file, page);
}

/// Draws the picture of `bem_contact plot`.
py::object plot_of(const PythonResult& r, const py::object& picture) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "result.h5";
  save(r, file);
  return py::module_::import("bem_contact").attr("plot")(file, picture);
}

/// What stands at a path of the record, "patches/0/Fn". Raises KeyError, which names the nearest paths.
py::object at_path(PythonResult& r, const std::string& path) {
  if (!r.solved)
    throw InputError("Paths need a result that was solved here",
                     "one that was pickled holds only its properties",
                     "Take the property of that name, or solve the scene again.");
  if (!r.by_path)
    r.by_path = std::make_shared<ResultByPath>(*r.solved);
  try {
    const record::Record& all = r.by_path->record_with(path);
    if (const record::Content* content = record::find(all, path))
      return as_object(*content);
    if (const auto number = record::number_at(all, path))
      return std::isnan(*number) ? py::object(py::none()) : py::object(py::float_(*number));
    const auto values = record::values_at(all, path);
    return array_of({values.begin(), values.end()});
  } catch (const InputError& unknown) {
    throw py::key_error(unknown.what());
  }
}

/// The unit of every number, array and entry of a patch.
py::dict units_of(const SceneResult& r) {
  py::dict out;
  out["x"] = "mm";
  const auto add = [&](std::string_view name, const Unit& unit, const auto&...) {
    out[py::str(name)] = unit.of(is_shift(r));
  };
  with_errors(quantities(), add);
  with_errors(patch_quantities(), add);
  with_errors(step_quantities(), add);
  for (const auto& q : row_quantities())
    add(q.name, q.unit);
  for (const auto& q : element_quantities())
    add(q.name, q.unit);
  return out;
}

/// "On the rail, N"
std::string doc_of(const char* description, const Unit& unit, const char* shape = "") {
  std::string text = std::string(description) + ", " + unit.text() + shape;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

/// Every number of quantities(), and its error.
void add_quantities(ResultClass& c) {
  with_errors(quantities(), [&](const std::string& name, const Unit& unit, auto value,
                                const char* description, const std::string&) {
    c.def_property_readonly(
        name, [value](const SceneResult& r) { return known(value(r)); }, doc_of(description, unit));
  });
}

/// The stub of all numbers and arrays of quantities.hpp. The build writes it beside that of the package. A
/// number that a result may not have, and an error that is not known, is None.
std::string stub_of_numbers() {
  std::string out =
      "from typing import Final\n\nimport numpy as np\nfrom numpy.typing import NDArray\n\n"
      "class Numbers:\n    \"\"\"Numbers and arrays of a result. An error is absolute.\"\"\"\n\n";
  const auto add = [&](const std::string& name, const char* type, const std::string& meaning) {
    out += "    " + name + ": Final[" + type + "]\n    \"\"\"" + meaning + "\"\"\"\n";
  };
  for (const Quantity& q : quantities()) {
    add(q.name, q.missing == Missing::possible ? "float | None" : "float", doc_of(q.meaning, q.unit));
    if (q.error)
      add(record::error_name(q.name), "float | None", doc_of(record::error_meaning, q.unit));
  }
  for (const ElementQuantity& q : element_quantities())
    add(q.name, "NDArray[np.float64]", doc_of(q.meaning, q.unit, ", [ms][mx]"));
  for (const RowQuantity& q : row_quantities())
    add(q.name, "NDArray[np.float64]", doc_of(q.meaning, q.unit, ", [ms]"));
  return out;
}

void add_parts(ResultClass& c) {
  c.def_property_readonly(
      "patches", [](const SceneResult& r) { return as_object(patches_of(r)); },
      "One dict for each connected area, the largest force first: its forces, moments "
      "about its centre, pmax, area, semi-axes, place on rail and wheel, creepages there, "
      "T_gamma; `units` has their units");
  c.def_property_readonly(
      "history", [](const SceneResult& r) { return columns_of(history_of(r)); },
      "Numbers of every step: dict of arrays [steps]");
  c.def_property_readonly("units", units_of, "{name: unit} of all numbers and arrays");
  c.def_property_readonly(
      "stresses", [](const SceneResult& r) { return as_object(stresses_of(r.stresses)); },
      "Stresses below the surface, where the scene asks for them: dict of x, s, depths "
      "(mm), stress [x][s][depth][6] of `components`, von_mises and largest_shear "
      "[x][s][depth] (MPa, tension positive); with stresses.in = \"bodies\" also `rail`, `wheel`: dicts with "
      "the same names of the real body, its `s`, `error` [s][depth], and halfspace_von_mises ... there; else "
      "None");
  c.def_readonly("approach_datum", &SceneResult::approach_datum,
                 "Of which points of the bodies the approach is the relative displacement");
  c.def_property_readonly(
      "derivatives",
      [](const SceneResult& r) {
        const record::Record found = derivatives_of(r);
        return found.empty() ? py::object(py::none()) : as_object(found);
      },
      "A dict for each number that `derivatives` names, as derivatives[\"lateral\"][\"Fy\"]; None: not asked "
      "for");
  c.def_property_readonly(
      "conformity", [](const SceneResult& r) { return as_object(conformity_of(r.conformity)); },
      "How closely the rigid bodies fit where they touch first: dict of largest_distance, width, ratio, fit "
      "...; "
      "None of a patch");
  c.def_readonly(
      "track", &SceneResult::track,
      "Where wheel and rail stand: network, gauge, flange backs, tape circle, inclination; \"\" of a "
      "patch");
  c.def_property_readonly(
      "structure", [](const SceneResult& r) { return as_object(structure_of(r.structure)); },
      "Structural motion, dict of rail, wheel (force, motion, 6 x 6 compliance and "
      "stiffness), placed, solutions, "
      "last_change, lowered; None where no body gives way");
  c.def_property_readonly(
      "other_laterals",
      [](const SceneResult& r) {
        return r.motion.found_lateral ? r.motion.found_lateral->others : std::vector<double>();
      },
      "Other displacements with the same load.force_y, to some hundredths, mm");
  c.def_property_readonly(
      "lateral_slope",
      [](const SceneResult& r) {
        return r.motion.found_lateral ? std::optional(r.motion.found_lateral->slope) : std::nullopt;
      },
      "dFy/dy at the displacement found for load.force_y, N/mm");
}

void add_fields(ResultClass& c) {
  for (const ElementQuantity& q : element_quantities())
    c.def_property_readonly(
        q.name, [&q](const SceneResult& r) { return field(r, q); }, doc_of(q.meaning, q.unit, ", [ms][mx]"));
  for (const RowQuantity& q : row_quantities())
    c.def_property_readonly(
        q.name,
        [&q](const SceneResult& r) {
          std::vector<double> values;
          for (std::size_t row = 0; row < r.problem.rows.size(); ++row)
            values.push_back(q.value(r, row));
          return array_of(values);
        },
        doc_of(q.meaning, q.unit, ", [ms]"));
  c.def_property_readonly(
      "x", [](const SceneResult& r) { return array_of(r.problem.grid.columns()); },
      "Middle of the columns, rolling direction, mm, [mx]");
}

void add_trust(ResultClass& c) {
  using namespace py::literals;
  c.def_property_readonly(
      "found",
      [](const SceneResult& r) {
        return record::found_in(record_of(r, {.fields = false}), "result").sentences;
      },
      "What was found, in sentences: those that bem_contact solve and pages begin with");
  c.def_property_readonly(
      "model", [](const SceneResult& r) { return std::string(name_of(r.choice.model)); },
      "Its name in scenes, as halfspace");
  c.def_property_readonly(
      "why_this_model", [](const SceneResult& r) { return r.choice.why_this_model; },
      "Why it was solved with this model");
  c.def_property_readonly("why_no_errors", why_no_errors,
                          "Why numbers have no stated errors, and what to do; \"\" where they have");
  c.def_property_readonly(
      "warnings", [](const SceneResult& r) { return r.warnings.texts(); },
      "What to know before the numbers are used, each with its figure and what to do; the most important "
      "first");
  c.def_property_readonly(
      "warning_kinds", [](const SceneResult& r) { return r.warnings.kinds(); },
      "The kind of each of `warnings`, as \"yield\"");
  c.def_property_readonly(
      "certified", [](const SceneResult& r) { return certified(r); },
      "Whether the certificate holds, and all steps before are solutions: look at it "
      "before you use any number");
  c.def_property_readonly(
      "converges_with_elements",
      [](const SceneResult& r) {
        return r.result.trust.discretisation ? std::optional(r.result.trust.discretisation->converges)
                                             : std::nullopt;
      },
      "False: smaller elements show another field, and no error can be told; None: not estimated");
  c.def_property_readonly("seconds", [](const SceneResult& r) { return r.seconds.total; });
  c.def_property_readonly("why_not_certified", why_not_certified,
                          "Why it is not certified; \"\" where it is");
  c.def("__getitem__", at_path);
  c.def("save", save, "file"_a, "Writes the result file (HDF5) of `bem_contact solve -o`");
  c.def("report", report_of, "page"_a, "Writes the HTML page that `bem_contact report` makes of it");
  c.def("plot", plot_of, "picture"_a = py::none(),
        "Draws the picture of `bem_contact plot` and returns the figure (matplotlib). `picture`: where to "
        "write it (.png, .pdf, .svg); None: nowhere");
  c.def("_repr_html_", [](const py::object& r) {
    return py::module_::import("bem_contact.notebook").attr("result_html")(r);
  });
  c.def("__repr__", [](const py::object& r) {
    return py::str("<bem_contact.Result: {}, Fz {:.6g} N, {} patches, {}>")
        .format(r.attr("model"), r.attr("Fz"), py::len(r.attr("patches")),
                r.attr("certified").cast<bool>() ? "certified" : "NOT certified");
  });
}

/// The last one that fits is raised, so that the base comes first.
void add_exceptions(py::module_& m) {
  const py::object error = py::register_exception<Error>(m, "Error");
  const auto both = [&](PyObject* usual) { return py::make_tuple(error, py::handle(usual)); };
  py::register_exception<InputError>(m, "InputError", both(PyExc_ValueError));
  py::register_exception<ConvergenceError>(m, "ConvergenceError", both(PyExc_RuntimeError));
}

} // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled part of the package bem_contact.";
  m.attr("__version__") = std::string(version());
  m.attr("__commit__") = std::string(commit());
  m.def("_stub_of_numbers", stub_of_numbers);
  add_exceptions(m);
  send_messages_to_logging();
  ResultClass result(m, "One scene solved with one model. Arrays are copies. Can be copied and pickled.");
  add_quantities(result);
  add_parts(result);
  add_fields(result);
  add_trust(result);

  using namespace py::literals;
  const std::string of_arguments =
      "`scene`: the path of a scene file; the text of one (more than one line of TOML); or a dict, as "
      "{\"load\": {\"force\": 1e5}, \"rail.profile\": \"60E1\"}. Relative paths start in the file's folder, "
      "of a text or a dict in `folder` (None: the working directory). `changes`: values of the scene's keys "
      "instead of the file's, as {\"position.lateral\": 6.6} or {\"position\": {\"lateral\": 6.6}}; numbers "
      "and arrays may be NumPy's. `model`: " +
      all_models() +
      "; \"\" takes the scene's own. Raises InputError (a "
      "ValueError) for wrong input. `strict`: warnings are errors. `derivatives`: numbers of the scene with "
      "respect to which the result has some, as [\"load\", \"lateral\"]. Lack of convergence is in the "
      "result.";
  m.def("solve", solve_one, "scene"_a = py::none(), "changes"_a = py::none(), "model"_a = py::none(),
        "strict"_a = false, "folder"_a = py::none(), "derivatives"_a = py::none(), of_arguments.c_str());
  py::class_<PythonSequence>(
      m, "Sequence",
      "Solves one scene with many changes, each from what the former ones taught: files are read once, and a "
      "case starts from the tractions of the one before. The scene is read, and its paths are fixed, when "
      "the object is made. Several threads may call one object: each call waits for the one before. Several "
      "objects run side by side. Ctrl-C ends a running solve. `threads` share the work of a case with "
      "thousands of elements in contact; results are the same. A pickle has the scene and its folder: a copy "
      "in another process solves the same scenes, and learns for itself.")
      .def(py::pickle([](const PythonSequence& s) { return py::make_tuple(tuple_of(s.text()), s.threads()); },
                      [](const py::tuple& state) {
                        return std::make_unique<PythonSequence>(scene_text_of(state[0]),
                                                                state[1].cast<int>());
                      }))
      .def(py::init(&sequence_of), "scene"_a = py::none(), "folder"_a = py::none(), "threads"_a = 1)
      .def("solve", &solve_changed, "changes"_a = py::none(), "model"_a = py::none(), "strict"_a = false,
           "derivatives"_a = py::none(), of_arguments.c_str());
  add_conicity(m);
  add_functions(m);
  add_check_and_sweep(m);
  add_profile(m);
  add_table(m);
  add_wear_functions(m);
  add_shakedown(m);
  m.def("report", &report::write_report, "file"_a, "output"_a, py::call_guard<OthersMayRun>(),
        "Writes one HTML page of what a command wrote, or of an influence file (HDF5): the scene in "
        "words, numbers with errors, certificate, figures. It needs no network. Raises InputError for other "
        "files, and where `output` is `file` or cannot be written.");
  guard_module(m);
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_all_solutions));
  watch_forks();
}

} // namespace bem_contact
