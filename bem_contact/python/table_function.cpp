#include "bem_contact/base/error.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/stopped.hpp"
#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/task/tasks.hpp"
#include "bem_contact/uses/table/creep_table.hpp"
#include "bem_contact/uses/table/packed_table.hpp"
#include "bem_contact/uses/table/scene_table.hpp"
#include "bem_contact/uses/table/table_file.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace bem_contact {

namespace {

using namespace py::literals;

py::dict dict_of(const table::ContactTable& t) {
  py::dict axes, first, values, errors, units;
  std::vector<std::size_t> shape;
  for (const table::Axis& axis : t.axes) {
    axes[axis.name.c_str()] = array_of(axis.points);
    units[axis.name.c_str()] = axis.unit;
    shape.push_back(axis.points.size());
    if (!axis.first.empty())
      first[axis.name.c_str()] =
          py::array_t<std::int64_t>(static_cast<py::ssize_t>(axis.first.size()),
                                    std::vector<std::int64_t>(axis.first.begin(), axis.first.end()).data());
  }
  if (t.nested())
    shape = {t.size()};
  for (const table::Column& c : t.columns) {
    values[c.name.c_str()] = py::array_t<double>(shape, c.values.data());
    units[c.name.c_str()] = c.unit;
    errors[c.name.c_str()] =
        py::dict("interpolation"_a = c.interpolation_error, "elements"_a = c.element_error,
                 "stated"_a = c.error(), "scale"_a = c.scale, "held"_a = c.held);
  }
  py::object scale = py::none();
  if (t.scale)
    scale = py::dict("log10_a_over_b"_a = array_of(t.scale->log10_a_over_b), "C11"_a = array_of(t.scale->c11),
                     "C22"_a = array_of(t.scale->c22));
  return py::dict("axes"_a = axes, "first"_a = first, "values"_a = values, "errors"_a = errors,
                  "units"_a = units, "creep_scale"_a = scale, "tolerance"_a = t.tolerance,
                  "solved"_a = t.solved);
}

/// The lists of the scene's table [table], or those of the dict `axes` instead.
table::SceneTable described(const py::object& scene, const py::object& axes, const py::object& folder) {
  const SceneText given = scene_of(scene, folder);
  if (axes.is_none())
    return table::parse_scene_table(given);
  table::SceneTable out{given};
  for (const SceneChange& axis : changes_of(axes))
    if (const auto* numbers = std::get_if<std::vector<double>>(&axis.value))
      out.axes.push_back({axis.key, *numbers});
    else
      refuse_type("The axis " + axis.key + " cannot be used", "it is no list of numbers",
                  "Give one, as [4e4, 8e4].");
  return out;
}

/// `solve`: one after the other, if there is no executor.
py::dict solved(table::ContactTable t, const table::PointSolver& solve, const table::PointsSolver& shared,
                const table::Wanted& wanted, const std::optional<std::filesystem::path>& output) {
  if (shared)
    table::refine(t, shared, wanted);
  else
    t = stoppable([t, solve, wanted](const std::atomic<bool>* stop) {
      table::ContactTable refined = t;
      const table::PointSolver until_stopped = [&solve, stop](const table::Point& point) {
        end_if_stopped(stop);
        return solve(point);
      };
      table::refine(refined, table::one_by_one(until_stopped), wanted);
      return refined;
    });
  if (output)
    table::write_table(
        *output,
        {{"format", record::Text{table_format}}, {"program", record::Text{provenance("bem_contact")}}}, t);
  return dict_of(t);
}

py::dict make_table(const py::object& scene, const py::object& axes, std::vector<std::string> hold,
                    double tolerance, std::size_t most_points, std::pair<double, double> ratio,
                    double poisson, int elements, const std::optional<std::filesystem::path>& output,
                    const py::object& folder, const py::object& executor) {
  table::Wanted wanted{.tolerance = tolerance, .most_points = most_points};
  const bool shared = !executor.is_none();
  if (scene.is_none()) {
    if (!axes.is_none() || !hold.empty())
      throw InputError("A table without a scene has no axes of yours", "it is one of creep forces",
                       "Give a scene, or leave out `axes` and `hold`.");
    table::ContactTable t = table::creep_table({poisson, ratio.first, ratio.second, elements, tolerance});
    const table::CreepScale scale = *t.scale;
    return solved(std::move(t), table::creep_point_solver(scale, elements),
                  shared ? task::points_by(engine_of(executor), scale, elements) : nullptr, wanted, output);
  }
  wanted.rescale = table::rescale;
  table::SceneTable order = described(scene, axes, folder);
  if (!hold.empty())
    order.hold = std::move(hold);
  return solved(table::table_of(order), table::scene_point_solver(order),
                shared ? task::points_by(engine_of(executor), order) : nullptr, wanted, output);
}

/// A table to look up in, and its members for Python, made once.
struct PythonTable {
  explicit PythonTable(table::ContactTable read) : table(std::move(read)), members(dict_of(table)) {}

  table::ContactTable table;
  py::dict members;
};

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Name: value of each column at one point, or an array of them at many.
py::dict look_up(const PythonTable& self, const Points& at) {
  const std::vector<table::Column>& columns = self.table.columns;
  const auto width = static_cast<std::size_t>(at.ndim() > 0 ? at.shape(at.ndim() - 1) : 1);
  table::require_coordinates(self.table, width); // of no points, too
  std::vector<std::vector<double>> found(columns.size());
  for (std::size_t first = 0; first < static_cast<std::size_t>(at.size()); first += width) {
    const std::vector<double> values = table::look_up(self.table, {at.data() + first, width});
    for (std::size_t c = 0; c < columns.size(); ++c)
      found[c].push_back(values[c]);
  }
  py::dict out;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (at.ndim() < 2)
      out[columns[c].name.c_str()] = found[c].at(0);
    else
      out[columns[c].name.c_str()] = py::array_t<double>(
          std::vector<py::ssize_t>(at.shape(), at.shape() + at.ndim() - 1), found[c].data());
  return out;
}

/// What conformal_table_force() gives.
py::dict force(const PythonTable& self, const std::vector<double>& at,
               const std::optional<std::vector<std::string>>& columns) {
  const std::vector<std::string> names = columns.value_or(std::vector<std::string>{"Fx", "Fy", "Fz", "Mz"});
  const table::PackedForces found = table::look_up(self.table, table::packed(self.table, names), at);
  py::dict values, derivatives, errors;
  for (std::size_t c = 0; c < names.size(); ++c) {
    py::dict along;
    for (std::size_t a = 0; a < at.size(); ++a)
      along[self.table.axes[a].name.c_str()] = found.derivatives[c * at.size() + a];
    values[names[c].c_str()] = found.values[c];
    errors[names[c].c_str()] = found.errors[c];
    derivatives[names[c].c_str()] = along;
  }
  return py::dict("values"_a = values, "derivatives"_a = derivatives, "errors"_a = errors);
}

py::dict creep_forces(const PythonTable& self, double a, double b, double shear_modulus, double bound,
                      double xi, double eta, double phi) {
  const table::TabulatedForces f =
      table::creep_forces(self.table, {a, b, shear_modulus, bound}, xi, eta, phi);
  return py::dict("Fx"_a = f.Fx, "Fy"_a = f.Fy, "Mz"_a = f.Mz,
                  "errors"_a = py::dict("Fx"_a = f.Fx_error, "Fy"_a = f.Fy_error, "Mz"_a = f.Mz_error));
}

} // namespace

void add_table(py::module_& module) {
  py::class_<PythonTable> reader(module, "Table",
                                 "A table of bem_contact.table() or `bem_contact table` to look up in.");
  for (const char* name :
       {"axes", "first", "values", "errors", "units", "creep_scale", "tolerance", "solved"})
    reader.def_property_readonly(
        name, [name](const PythonTable& self) { return py::object(self.members[name]); },
        "As in the dict that table() returns.");
  reader
      .def("look_up", look_up, "at"_a,
           "A dict with the value of each column at a point, one coordinate for each axis; for an array of "
           "points (last dimension: axes) arrays of values. `errors` says how far they are from solutions. "
           "InputError outside the axes.")
      .def("force", force, "at"_a, "columns"_a = py::none(),
           "\"values\", \"derivatives\" (by column and axis) and stated \"errors\" of some `columns` (Fx, "
           "Fy, Fz "
           "and Mz) at a point, one coordinate for each axis: what conformal_table_force() gives in C. All "
           "are "
           "continuous in each coordinate but the errors, which are those of the table. InputError outside "
           "the "
           "axes.")
      .def("creep_forces", creep_forces, "a"_a, "b"_a, "shear_modulus"_a, "bound"_a, "xi"_a = 0, "eta"_a = 0,
           "phi"_a = 0,
           "Fx, Fy (N) and Mz (N mm) on the rail of an elliptic contact with semi-axes a along x and b (mm), "
           "shear modulus (MPa) and friction bound mu N (N), for creepages xi, eta and phi (1/mm); and their "
           "\"errors\". InputError where a/b is outside the table.");
  module.def(
      "read_table", [](const std::filesystem::path& file) { return PythonTable{table::read_table(file)}; },
      "file"_a, "Reads a table (HDF5) of table() or of the command `bem_contact table`: a Table.");
  module.def(
      "table", make_table, "scene"_a = py::none(), "axes"_a = py::none(), py::kw_only(),
      "hold"_a = std::vector<std::string>{}, "tolerance"_a = table::Wanted{}.tolerance,
      "most_points"_a = table::Wanted{}.most_points,
      "ratio"_a = std::pair(table::CreepTableOptions{}.from, table::CreepTableOptions{}.to),
      "poisson"_a = 0.28, "elements"_a = table::CreepTableOptions{}.elements, "output"_a = py::none(),
      "folder"_a = py::none(), "executor"_a = py::none(),
      "Forces over axes, refined until the interpolation is within `tolerance`. Without a `scene`: creep "
      "forces of an ellipse over a/b (`ratio`, from and to) and the creepages, for `poisson` and so many "
      "`elements` across. With a scene, as solve() takes it: `axes` (a dict of keys and lists of numbers) or "
      "its own table [table]; `hold` names the numbers whose error is kept within the tolerance. A dict: "
      "\"axes\", \"first\" (of creep forces: where on an axis the points begin that belong to each point of "
      "the axes before it), \"values\" (an array over all axes for each number; of creep forces over all "
      "points), \"errors\" (interpolation, elements, stated: both, scale, held), \"units\", \"creep_scale\". "
      "`output`: an "
      "HDF5 file, too. `executor`: any of concurrent.futures, or with its methods, shares the points. Then "
      "the "
      "numbers are those of the program, however many share them.");
}

} // namespace bem_contact
