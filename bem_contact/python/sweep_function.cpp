#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/python/executors.hpp"
#include "bem_contact/python/functions.hpp"
#include "bem_contact/python/stoppable.hpp"
#include "bem_contact/python/values.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/sweep/sweep_rows.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace bem_contact {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict check(const py::object& scene, const py::object& changes, const py::object& model,
               const py::object& folder) {
  const SceneFile file = with_model(scene_file_of(scene, folder, changes_of(changes)), model_of(model));
  const SceneDescription found = stoppable([file](const std::atomic<bool>*) { return describe_scene(file); });
  return py::dict("lines"_a = found.lines, "warnings"_a = found.warnings.texts());
}

/// The values of a key, an array if they are numbers.
py::object values_of_key(const SweepFile& sweep, std::size_t axis) {
  const std::vector<SchemaValue>& values = sweep.axes[axis].values;
  std::vector<double> numbers;
  py::list texts;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const SchemaValue& value = values[sweep.indices(i)[axis]];
    if (const double* number = std::get_if<double>(&value))
      numbers.push_back(*number);
    if (const std::int64_t* number = std::get_if<std::int64_t>(&value))
      numbers.push_back(double(*number));
    const std::string* text = std::get_if<std::string>(&value);
    texts.append(text ? *text : to_text(value));
  }
  return numbers.size() == sweep.size() ? py::object(array_of(numbers)) : py::object(texts);
}

/// An array, or a list of names; nan and "" where there is no result.
py::object column_of(const SweepColumn& column, const std::vector<double>& values) {
  if (!is_model(column))
    return array_of(values);
  py::list names;
  for (const double value : values)
    names.append(std::isnan(value) ? std::string_view() : name_of(static_cast<Model>(value)));
  return names;
}

py::array_t<std::int64_t> whole(const std::vector<std::size_t>& numbers) {
  return py::array_t<std::int64_t>(py::cast(numbers));
}

/// Gives every case of the sweep a key's value.
void change_all(SweepFile& sweep, const SceneChange& change) {
  if (std::ranges::count(sweep.axes, change.key, &SweepFile::Axis::key) > 0)
    throw InputError("The change of " + change.key + " cannot be made",
                     "the sweep gives it a value in each case", "Leave it out, or take it out of [sweep].");
  sweep.axes.push_back({change.key, {change.value}});
}

/// The package's class, which is a dict.
py::object as_sweep(const py::dict& columns) {
  return py::module_::import("bem_contact").attr("Sweep")(columns);
}

/// The cases of a scene, with changes of all of them.
SweepFile sweep_of(SceneText scene, const py::object& changes) {
  SweepFile file = parse_sweep_file(std::move(scene));
  for (const SceneChange& change : changes_of(changes))
    change_all(file, change);
  return file;
}

std::vector<SweepCase> solve_range(const SweepFile& sweep, CaseRange cases, const std::string& model) {
  return stoppable([=](const std::atomic<bool>* stop) {
    std::vector<SweepCase> out;
    solve_cases(sweep, cases, {.model = model, .stop = stop}, shared_files(), [&](SweepCase one) {
      out.push_back(std::move(one));
      return true;
    });
    return out;
  });
}

/// Rows of a matrix as one array, [column][case].
py::array_t<double> matrix_of(const std::vector<std::vector<double>>& columns) {
  const std::size_t length = columns.empty() ? 0 : columns.front().size();
  py::array_t<double> out({columns.size(), length});
  if (length == 0) // there is no place to copy to
    return out;
  for (std::size_t k = 0; k < columns.size(); ++k)
    std::ranges::copy(columns[k], out.mutable_data(static_cast<py::ssize_t>(k), 0));
  return out;
}

std::vector<std::vector<double>> columns_in(const py::handle& matrix) {
  const auto all = matrix.cast<py::array_t<double, py::array::c_style>>();
  std::vector<std::vector<double>> out;
  for (py::ssize_t k = 0; k < all.shape(0); ++k)
    out.emplace_back(all.data() + k * all.shape(1), all.data() + (k + 1) * all.shape(1));
  return out;
}

/// Columns, which can be pickled.
py::tuple tuple_of_rows(const SweepRows& rows) {
  std::vector<int> status;
  for (const record::Outcome one : rows.status)
    status.push_back(static_cast<int>(one));
  return py::make_tuple(rows.cases.first, rows.cases.last, py::array_t<int>(py::cast(status)), rows.reasons,
                        matrix_of(rows.numbers.cases), whole(rows.numbers.patch_case),
                        whole(rows.numbers.patch_rank), matrix_of(rows.numbers.patches));
}

SweepRows rows_in(const py::tuple& t) {
  SweepRows rows{{t[0].cast<std::size_t>(), t[1].cast<std::size_t>()}, {}, {}, {}};
  for (const int one : t[2].cast<std::vector<int>>())
    rows.status.push_back(static_cast<record::Outcome>(one));
  rows.reasons = t[3].cast<std::map<std::size_t, std::string>>();
  rows.numbers = {columns_in(t[4]), t[5].cast<std::vector<std::size_t>>(),
                  t[6].cast<std::vector<std::size_t>>(), columns_in(t[7])};
  return rows;
}

/// In a process or thread of an executor: the cases of a range.
py::tuple solve_sweep_part(const py::tuple& scene, const py::object& changes, const std::string& model,
                           std::size_t first, std::size_t last) {
  const SweepFile sweep = sweep_of(scene_text_of(scene), changes);
  return tuple_of_rows(rows_of({first, last}, solve_range(sweep, {first, last}, model), columns_of(sweep)));
}

/// As the program asks for a sweep that it writes. Changes are options.
AskedSweep asked_sweep(SweepFile sweep, const py::object& changes, const std::string& model) {
  AskedSweep asked{.scene = sweep.text.source, .sweep = std::move(sweep), .model = model};
  std::string options = model;
  for (const SceneChange& change : changes_of(changes))
    options += fmt::format(" {} = {}", change.key, to_text(change.value));
  asked.origins = origins_of(asked.sweep, options);
  asked.digest = digest_of(asked.origins);
  return asked;
}

/// Whether a former call has left the part. One that is damaged is solved again.
bool is_there(const AskedSweep& asked, const std::filesystem::path& file) {
  if (!is_regular(file))
    return false;
  try {
    read_part(asked, file);
    return true;
  } catch (const PartFault& fault) {
    if (!fault.damaged)
      throw;
    return false;
  }
}

/// In a process or thread of an executor: writes the file of a part, unless it is there.
void write_sweep_part(const py::tuple& scene, const py::object& changes, const std::string& model,
                      std::size_t first, std::size_t last, const std::string& file) {
  const AskedSweep asked = asked_sweep(sweep_of(scene_text_of(scene), changes), changes, model);
  if (is_there(asked, file))
    return;
  stoppable([=](const std::atomic<bool>* stop) {
    solve_part(
        asked, {first, last}, file, [] {}, stop);
    return true;
  });
}

/// What sweep() is asked besides its scene.
struct SharedSweep {
  py::object changes;
  std::string model;
  py::object executor, progress;
  std::string output; ///< folder; "": none

  /// Tasks of whole chunks, so that what is found is what one process finds.
  std::vector<CaseRange> tasks(const SweepFile& sweep) const {
    constexpr std::size_t most_tasks = 1000; // each reads its files again
    const std::size_t cases = sweep.size(), chunk = cut_of(sweep, model, *shared_files()).chunk,
                      chunks = (cases + chunk - 1) / chunk,
                      size = chunk * ((chunks + most_tasks - 1) / most_tasks);
    std::vector<CaseRange> out;
    for (std::size_t first = 0; first < cases; first += size)
      out.push_back({first, std::min(cases, first + size)});
    return out;
  }
  std::string file(CaseRange cases) const {
    return (std::filesystem::path(output) / fmt::format("{}-{}.h5", cases.first, cases.last)).string();
  }
  void say(std::size_t done, std::size_t of) const {
    if (!progress.is_none())
      progress(done, of);
  }
};

AllSweepRows solve_sweep_with(const SweepFile& sweep, const SharedSweep& how) {
  const std::vector<CaseRange> ranges = how.tasks(sweep);
  const bool files = !how.output.empty();
  if (files)
    make_folder(how.output);
  const py::tuple text = tuple_of(sweep.text); // one for all tasks: it grows with the cases
  py::list tasks;
  for (const CaseRange& cases : ranges) {
    const py::tuple task = py::make_tuple(text, how.changes, how.model, cases.first, cases.last);
    tasks.append(files ? py::tuple(task + py::make_tuple(how.file(cases))) : task);
  }
  AllSweepRows rows;
  std::size_t done = 0;
  run_each(how.executor, files ? "sweep_file" : "sweep", tasks,
           [&](std::size_t task, const py::object& part) {
             if (!files)
               rows[ranges[task].first] = rows_in(part);
             how.say(done += ranges[task].size(), sweep.size());
           });
  if (files) {
    const AskedSweep asked = asked_sweep(sweep, how.changes, how.model);
    for (const CaseRange& cases : ranges)
      rows[cases.first] = read_rows(read_part(asked, how.file(cases)), asked.columns());
  }
  return rows;
}

/// One column of all, which is taken from its parts.
template <class Value, class Column> std::vector<Value> taken(AllSweepRows& rows, const Column& column) {
  std::vector<Value> out;
  for (auto& [first, part] : rows) {
    std::vector<Value>& some = column(part.numbers);
    out.insert(out.end(), some.begin(), some.end());
    std::vector<Value>().swap(some);
  }
  return out;
}

void add_cases(py::dict& out, const SweepFile& file, const AllSweepRows& rows) {
  py::list status, reason;
  std::vector<double> weights;
  for (const auto& [first, part] : rows)
    for (std::size_t i = 0; i < part.status.size(); ++i) {
      const auto why = part.reasons.find(first + i);
      status.append(name_of(part.status[i]));
      reason.append(why == part.reasons.end() ? std::string() : why->second);
      weights.push_back(file.weight(first + i));
    }
  out["status"] = status;
  out["reason"] = reason;
  out["weight"] = array_of(weights);
}

py::dict answer_of(const SweepFile& file, std::size_t swept, AllSweepRows rows) {
  py::dict out;
  for (std::size_t axis = 0; axis < swept; ++axis)
    out[file.axes[axis].key.c_str()] = values_of_key(file, axis);
  add_cases(out, file, rows);
  const SweepColumns& columns = columns_of(file);
  for (std::size_t k = 0; k < columns.cases.size(); ++k)
    out[columns.cases[k].name.c_str()] =
        column_of(columns.cases[k], taken<double>(
                                        rows, [k](SweepNumbers & n) -> auto& { return n.cases[k]; }));
  if (columns.patches.empty())
    return out;
  py::dict patches("case"_a = whole(taken<std::size_t>(rows, std::mem_fn(&SweepNumbers::patch_case))),
                   "patch"_a = whole(taken<std::size_t>(rows, std::mem_fn(&SweepNumbers::patch_rank))));
  for (std::size_t k = 0; k < columns.patches.size(); ++k)
    patches[columns.patches[k].name.c_str()] =
        column_of(columns.patches[k], taken<double>(
                                          rows, [k](SweepNumbers & n) -> auto& { return n.patches[k]; }));
  out["patches"] = patches;
  return out;
}

py::object sweep(const py::object& scene, const py::object& changes, const py::object& model,
                 const py::object& folder, const py::object& executor, const py::object& output,
                 const py::object& progress) {
  if (model.is_none() && py::isinstance<py::str>(changes)) // the model was the second argument
    return sweep(scene, py::none(), changes, folder, executor, output, progress);
  SweepFile file = parse_sweep_file(scene_of(scene, folder));
  const std::size_t swept = file.axes.size();
  file = sweep_of(file.text, changes);
  const SharedSweep how{changes, model_of(model), executor, progress,
                        output.is_none() ? "" : std::filesystem::absolute(path_of(output)).string()};
  check_cases(file, file.all());
  with_model(file.first_scene(), how.model); // refuses what is no model
  AllSweepRows rows;
  if (executor.is_none() && output.is_none() && progress.is_none())
    rows[0] = rows_of(file.all(), solve_range(file, file.all(), how.model), columns_of(file));
  else
    rows = solve_sweep_with(file, how);
  return as_sweep(answer_of(file, swept, std::move(rows)));
}

} // namespace

void add_check_and_sweep(py::module_& module) {
  module.def(
      "check", &check, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(),
      "What would be solved, and whether the influence files suffice; nothing is solved. `scene`, `changes`, "
      "`model`: as solve() takes them, or as wheelset() does. A dict: `lines`, the text that `bem_contact "
      "check` prints, and `warnings`. Raises InputError where solve() or wheelset() would before it solves.");
  module.def(
      "sweep", &sweep, "scene"_a, "changes"_a = py::none(), "model"_a = py::none(), py::kw_only(),
      "folder"_a = py::none(), "executor"_a = py::none(), "output"_a = py::none(), "progress"_a = py::none(),
      "Solves a scene for the lists of its table [sweep], as `bem_contact sweep` does. "
      "`scene`, `changes`, `model`: as solve() takes them. A dict of columns, one entry for each case: the "
      "keys swept "
      "over, under their names (\"position.lateral\"; an array, or a list of texts), `status` (certified, "
      "not "
      "certified or refused), `reason` (what is wrong or doubtful, in words), `model`, `weight`, and the "
      "numbers of a Result under their names (\"pmax\", \"Fx\", \"Fx_error\" ...; nan where there is no "
      "result); `to_frame()` makes a DataFrame of pandas of them; `patches`: the same of all patches, with "
      "`case` (from 0) and `patch` (from 1, the largest force first). Of wheelsets, the numbers of "
      "wheelset(), and `patches` with `left` (1: of the left wheel). mm, N, MPa, rad. Raises "
      "InputError for a scene without [sweep] and a value that no scene has. `executor`: any of "
      "concurrent.futures, or with its methods, shares the cases; the numbers are the same. `output`: a "
      "folder; each task "
      "writes its cases to a file there, and after a stop, or where a worker was killed, the same call "
      "solves "
      "what is missing (`bem_contact sweep SCENE --join FOLDER` reads these files, too, if there are no "
      "changes). `progress`: called as progress(cases that are done, all) after each task.");
  module.def("_sweep_part", &solve_sweep_part, "scene"_a, "changes"_a, "model"_a, "first"_a, "last"_a);
  module.def("_sweep_file_part", &write_sweep_part, "scene"_a, "changes"_a, "model"_a, "first"_a, "last"_a,
             "file"_a);
}

} // namespace bem_contact
