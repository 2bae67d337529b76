#include "bem_contact/python/values.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace py = pybind11;

namespace bem_contact {

namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& why, const std::string& what_to_do) {
  throw py::type_error(Error(problem, why, what_to_do).what());
}

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

bool is_number(const py::object& value) {
  return !py::isinstance<py::bool_>(value) &&
         (py::hasattr(value, "__index__") || py::hasattr(value, "__float__"));
}

double number_of(const py::object& value) {
  return py::float_(value).cast<double>();
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

SchemaValue value_of(const std::string& key, const py::object& given) {
  const py::object value = without_numpy(given);
  if (py::isinstance<py::bool_>(value))
    return value.cast<bool>();
  if (is_path(value))
    return path_of(value);
  if (py::hasattr(value, "__index__"))
    return whole_number(key, value);
  if (is_number(value))
    return number_of(value);
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  std::vector<double> numbers;
  if (is_list)
    for (const py::handle element : value) {
      const py::object number = without_numpy(py::reinterpret_borrow<py::object>(element));
      if (!is_number(number))
        refuse(fmt::format("The value of {} cannot be used", key),
               fmt::format("its list holds something of type {}", type_name(number)),
               "Give a list of numbers, or an array of one dimension.");
      numbers.push_back(number_of(number));
    }
  else
    refuse(fmt::format("The value of {} cannot be used", key),
           fmt::format("its type is {}", type_name(given)),
           "Give a number, text, True, False, or a list of numbers.");
  return numbers;
}

} // namespace

std::string path_of(const py::object& scene) {
  if (!is_path(scene))
    refuse("The scene cannot be used", fmt::format("its type is {}", type_name(scene)),
           "Give the path of a scene file, as text or as pathlib.Path.");
  const py::object path = py::hasattr(scene, "__fspath__") ? py::object(scene.attr("__fspath__")()) : scene;
  if (!py::isinstance<py::str>(path))
    refuse("The scene cannot be used", "its path is of bytes", "Give the path as text or as pathlib.Path.");
  return path.cast<std::string>();
}

std::vector<SceneChange> changes_of(const py::object& changes) {
  std::vector<SceneChange> list;
  if (changes.is_none())
    return list;
  if (!py::hasattr(changes, "items"))
    refuse("The changes cannot be used", fmt::format("their type is {}", type_name(changes)),
           "Give a dict, as {'position.lateral': 6.6}.");
  for (const py::handle item : changes.attr("items")()) {
    const auto [key, value] = py::cast<std::pair<py::object, py::object>>(item);
    if (!py::isinstance<py::str>(key))
      refuse("The changes cannot be used", fmt::format("one of their keys is of type {}", type_name(key)),
             "Name the keys of a scene, as {'position.lateral': 6.6}.");
    const auto name = key.cast<std::string>();
    list.push_back({name, value_of(name, value)});
  }
  return list;
}

std::string model_of(const py::object& model) {
  if (model.is_none())
    return "";
  if (!py::isinstance<py::str>(model))
    refuse("The model cannot be used", fmt::format("its type is {}", type_name(model)),
           "Give 'auto', 'hertz', 'halfspace', 'tangent_plane' or 'fem'.");
  return model.cast<std::string>();
}

void refuse_unknown(const char* function, const py::args& more, const py::kwargs& unknown) {
  if (!more.empty())
    refuse(fmt::format("{}() has too many arguments", function),
           fmt::format("{} more than it takes", more.size()), "See help(bem_contact.solve).");
  for (const auto& item : unknown) {
    const auto name = py::cast<std::string>(item.first);
    const std::vector<std::string> known{"scene", "changes", "model"};
    const auto like = nearest_names(name, known, 1);
    refuse(fmt::format("{}() has no argument '{}'", function, name),
           "its arguments are scene, changes and model",
           like.empty() ? "Put keys of the scene into the dict `changes`."
                        : fmt::format("Did you mean {}?", like.front()));
  }
}

} // namespace bem_contact
