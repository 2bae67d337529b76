#include "bem_contact/python/values.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/scene/sweep_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace py = pybind11;

namespace bem_contact {

namespace {

std::string type_name(const py::object& value) {
  return py::cast<std::string>(py::type::of(value).attr("__name__"));
}

/// NumPy's numbers and arrays as Python's own.
py::object without_numpy(const py::object& value) {
  return py::hasattr(value, "tolist") ? py::object(value.attr("tolist")()) : value;
}

bool is_path(const py::object& value) {
  return py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__");
}

/// `what` the path is for.
std::string path_given_for(const py::object& given, const char* what) {
  const py::object path = py::hasattr(given, "__fspath__") ? py::object(given.attr("__fspath__")()) : given;
  if (!py::isinstance<py::str>(path))
    refuse_type(fmt::format("The {} cannot be used", what),
                py::isinstance<py::bytes>(path) ? "its path is of bytes"
                                                : fmt::format("its type is {}", type_name(path)),
                "Give the path as text or as pathlib.Path.");
  return text_of(path, what);
}

bool is_number(const py::object& value) {
  return !py::isinstance<py::bool_>(value) &&
         (py::hasattr(value, "__index__") || py::hasattr(value, "__float__"));
}

double number_of(const py::object& value) {
  try {
    return py::float_(value).cast<double>();
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_OverflowError))
      throw;
    throw InputError("A number has more than 300 digits", "out of range", "Give a smaller value.");
  }
}

SchemaValue whole_number(const std::string& key, const py::object& value) {
  const py::int_ whole(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr())));
  int beyond = 0;
  const long long number = PyLong_AsLongLongAndOverflow(whole.ptr(), &beyond);
  if (beyond != 0)
    throw InputError(key + " is a whole number of more than 19 digits", "out of range",
                     "Give a smaller value.");
  return static_cast<std::int64_t>(number);
}

/// Names with commas between, as files have them.
std::string texts_of(const std::string& key, const py::object& list) {
  std::vector<std::string> out;
  for (const py::handle element : list)
    out.push_back(text_of(py::reinterpret_borrow<py::object>(element), key.c_str()));
  return fmt::format("{}", fmt::join(out, ", "));
}

SchemaValue value_of(const std::string& key, const py::object& given) {
  const py::object value = without_numpy(given);
  if (py::isinstance<py::bool_>(value))
    return value.cast<bool>();
  if (is_path(value))
    return path_given_for(value, key.c_str());
  if (py::hasattr(value, "__index__"))
    return whole_number(key, value);
  if (is_number(value))
    return number_of(value);
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (is_list && py::len(value) > 0 && py::isinstance<py::str>(*py::iter(value)))
    return texts_of(key, value);
  std::vector<double> numbers;
  if (is_list)
    for (const py::handle element : value) {
      const py::object number = without_numpy(py::reinterpret_borrow<py::object>(element));
      if (!is_number(number))
        refuse_type(fmt::format("The value of {} cannot be used", key),
                    fmt::format("its list holds something of type {}", type_name(number)),
                    "Give a list of numbers, or an array of one dimension.");
      numbers.push_back(number_of(number));
    }
  else
    refuse_type(fmt::format("The value of {} cannot be used", key),
                fmt::format("its type is {}", type_name(given)),
                "Give a number, text, True, False, or a list of numbers.");
  return numbers;
}

/// A part of a key, in quotes where TOML wants some: what is wrong with it is for the schema to say.
std::string key_text(const std::string& key) {
  const bool bare = !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '.';
  });
  return bare ? key : toml_text(key);
}

std::string toml_of(SchemaValue value) {
  if (auto* text = std::get_if<std::string>(&value))
    return toml_text(*text);
  if (auto* number = std::get_if<double>(&value))
    return value_text(number);
  if (auto* list = std::get_if<std::vector<double>>(&value))
    return value_text(list);
  return to_text(value);
}

/// The entries of a dict whose keys are texts. `cannot`, `whose` and `example` are for the error of other
/// keys.
std::vector<std::pair<std::string, py::object>> entries_of(const py::object& dict, const char* cannot,
                                                           const char* whose, const char* example) {
  std::vector<std::pair<std::string, py::object>> out;
  for (const py::handle item : dict.attr("items")()) {
    const auto [key, value] = py::cast<std::pair<py::object, py::object>>(item);
    if (!py::isinstance<py::str>(key))
      refuse_type(cannot, fmt::format("one of {} keys is of type {}", whose, type_name(key)),
                  fmt::format("Name the keys of a scene, as {}.", example));
    out.emplace_back(text_of(key, "a key"), value);
  }
  return out;
}

/// A dict may hold itself. Throws InputError for one that is nested so deep.
void require_depth(std::size_t depth, const char* cannot) {
  constexpr std::size_t most = 20; // no key of a scene has more than three parts
  if (depth > most)
    throw InputError(cannot, fmt::format("dicts are nested in it more than {} deep", most),
                     "Look whether one of them holds itself.");
}

/// Lists of [sweep] and [table] may hold texts.
std::string toml_list(const std::string& key, const py::object& list) {
  std::vector<std::string> out;
  for (const py::handle element : list)
    out.push_back(toml_of(value_of(key, py::reinterpret_borrow<py::object>(element))));
  return fmt::format("[{}]", fmt::join(out, ", "));
}

/// One line `a.b.c = value` for each entry of the dict and of those in it.
void add_table(const py::object& table, const std::string& prefix, std::string& text, std::size_t depth = 0) {
  require_depth(depth, "The scene cannot be used");
  for (const auto& [key, value] :
       entries_of(table, "The scene cannot be used", "its", "{'load': {'force': 1e5}}")) {
    const std::string name = key_text(key), path = prefix.empty() ? name : prefix + "." + name;
    if (py::hasattr(value, "items")) {
      add_table(value, path, text, depth + 1);
      continue;
    }
    const py::object plain = without_numpy(value);
    const bool of_cases = path.starts_with("sweep.") || path.starts_with("table.");
    const bool is_list = py::isinstance<py::list>(plain) || py::isinstance<py::tuple>(plain);
    text +=
        path + " = " + (of_cases && is_list ? toml_list(path, plain) : toml_of(value_of(path, value))) + "\n";
  }
}

/// One change for each entry of the dict and of those in it: {'load': {'force': 1e5}} is {'load.force': 1e5}.
void add_changes(const py::object& changes, const std::string& prefix, std::vector<SceneChange>& list,
                 std::size_t depth = 0) {
  require_depth(depth, "The changes cannot be used");
  for (const auto& [key, value] :
       entries_of(changes, "The changes cannot be used", "their", "{'position.lateral': 6.6}")) {
    const std::string path = prefix + key;
    if (py::hasattr(value, "items") && py::len(value) > 0)
      add_changes(value, path + ".", list, depth + 1);
    else
      list.push_back({path, value_of(path, value)});
  }
}

} // namespace

void refuse_type(const std::string& problem, const std::string& why, const std::string& what_to_do) {
  throw py::type_error(Error(problem, why, what_to_do).what());
}

std::string text_of(const py::object& text, const char* what) {
  if (!py::isinstance<py::str>(text))
    refuse_type(fmt::format("The {} cannot be used", what), fmt::format("its type is {}", type_name(text)),
                "Give a text.");
  py::ssize_t size = 0;
  if (const char* bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size))
    return {bytes, static_cast<std::size_t>(size)};
  PyErr_Clear();
  throw InputError(fmt::format("The text of {} cannot be used", what),
                   "it is no UTF-8: it holds half a character, as the name of a file does that is none",
                   "Give the file a name in UTF-8.");
}

std::string path_of(const py::object& path) {
  return path_given_for(path, "file");
}

SceneText scene_of(const py::object& scene, const py::object& folder) {
  const auto start = [&](const std::filesystem::path& own) {
    const std::filesystem::path given = folder.is_none() ? own.string() : path_given_for(folder, "folder");
    return std::filesystem::absolute(given.empty() ? "." : given);
  };
  if (py::hasattr(scene, "items")) {
    std::string text;
    add_table(scene, "", text);
    return {text, "dict", start(".")};
  }
  if (!is_path(scene))
    refuse_type("The scene cannot be used", fmt::format("its type is {}", type_name(scene)),
                "Give the path of a scene file, its text, or a dict.");
  std::string name = path_given_for(scene, "scene");
  // No scene fits into one line, and hardly a file has a name of two.
  if (py::isinstance<py::str>(scene) && name.find('\n') != std::string::npos)
    return {std::move(name), "text", start(".")};
  return {read_text_file(name, "scene file"), name, start(std::filesystem::path(name).parent_path() / ".")};
}

py::tuple tuple_of(const SceneText& scene) {
  return py::make_tuple(scene.toml, scene.source, scene.folder.string());
}

SceneText scene_text_of(const py::tuple& scene) {
  return {scene[0].cast<std::string>(), scene[1].cast<std::string>(), scene[2].cast<std::string>()};
}

SceneFile scene_file_of(const py::object& scene, const py::object& folder,
                        std::span<const SceneChange> changes) {
  return parse_scene_file(scene_of(scene, folder), changes);
}

std::vector<SceneChange> changes_of(const py::object& changes) {
  std::vector<SceneChange> list;
  if (changes.is_none())
    return list;
  if (!py::hasattr(changes, "items"))
    refuse_type("The changes cannot be used", fmt::format("their type is {}", type_name(changes)),
                "Give a dict, as {'position.lateral': 6.6}.");
  add_changes(changes, "", list);
  return list;
}

std::string all_models() {
  return fmt::format("{}, {}", automatic_model, fmt::join(EnumNames<Model>::names, ", "));
}

std::string model_of(const py::object& model) {
  if (model.is_none())
    return "";
  if (!py::isinstance<py::str>(model))
    refuse_type("The model cannot be used", fmt::format("its type is {}", type_name(model)),
                fmt::format("Give one of {}.", all_models()));
  return text_of(model, "model");
}

std::vector<double> numbers_in(const py::object& values, std::string_view what) {
  const std::string key(what);
  py::dict one;
  one[py::str(key)] = values;
  const std::vector<SceneChange> given = changes_of(one);
  const bool one_value = given.size() == 1 && given.front().key == key; // not if `values` is a dict
  const auto* numbers = one_value ? std::get_if<std::vector<double>>(&given.front().value) : nullptr;
  if (!numbers || numbers->empty())
    refuse_type(fmt::format("The values of {} cannot be used", key), "they are no list of numbers",
                "Give a list or an array, as [0, 1e-3, 2e-3].");
  return *numbers;
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

void refuse_unknown(const char* function, const std::vector<std::string>& known, const py::args& more,
                    const py::kwargs& unknown) {
  if (!more.empty())
    refuse_type(fmt::format("{}() has too many arguments", function),
                fmt::format("{} more than it takes", more.size()),
                fmt::format("See help(bem_contact.{}).", function));
  for (const auto& item : unknown) {
    const std::string name = text_of(py::reinterpret_borrow<py::object>(item.first), "an argument");
    const auto like = nearest_names(name, known, 1);
    refuse_type(fmt::format("{}() has no argument '{}'", function, name),
                fmt::format("its arguments are {} and {}",
                            fmt::join(known.begin(), std::prev(known.end()), ", "), known.back()),
                like.empty() ? "Put keys of the scene into the dict `changes`."
                             : fmt::format("Did you mean {}?", like.front()));
  }
}

} // namespace bem_contact
