#pragma once

#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace bem_contact {

/// Python's Result. One that comes from a pickle has the values of the properties instead of the result.
struct PythonResult {
  std::shared_ptr<const SceneResult> solved;
  pybind11::dict kept = {};
  std::shared_ptr<const GivenScene> given =
      nullptr;                                     ///< what was solved; nothing: one of several of an answer
  std::shared_ptr<ResultByPath> by_path = nullptr; ///< nothing: no path was asked for
};

/// Declares the properties of Result as pybind11::class_ does. Each is part of a pickle from here on.
class ResultClass {
public:
  ResultClass(pybind11::module_& module, const char* doc)
      : class_(module, "Result", doc), names_(std::make_shared<std::vector<std::string>>()) {
    class_.def("__copy__", [](const PythonResult& r) { return r; }); // nothing of it can be changed
    class_.def("__deepcopy__", [](const PythonResult& r, const pybind11::dict&) { return r; });
    class_.def(pybind11::pickle(
        [names = names_](const pybind11::object& result) {
          pybind11::dict values;
          for (const std::string& name : *names)
            values[name.c_str()] = result.attr(name.c_str());
          return values;
        },
        [](const pybind11::dict& values) {
          return PythonResult{nullptr, values, nullptr};
        }));
  }

  /// `of` takes a SceneResult.
  template <class Of>
  ResultClass& def_property_readonly(const std::string& name, const Of& of, const std::string& doc = "") {
    names_->push_back(name);
    class_.def_property_readonly(
        name.c_str(),
        [name, of](const PythonResult& r) -> pybind11::object {
          return r.solved ? as_object(of(*r.solved)) : pybind11::object(r.kept[name.c_str()]);
        },
        doc.c_str());
    return *this;
  }
  template <class Value>
  ResultClass& def_readonly(const char* name, Value SceneResult::*member, const char* doc = "") {
    return def_property_readonly(
        name, [member](const SceneResult& r) { return r.*member; }, doc);
  }
  /// `of` takes Python's object.
  template <class Of, class... More> ResultClass& def(const char* name, const Of& of, const More&... more) {
    class_.def(name, of, more...);
    return *this;
  }

private:
  template <class Value> static pybind11::object as_object(Value value) {
    if constexpr (std::is_base_of_v<pybind11::handle, Value>)
      return value;
    else
      return pybind11::cast(std::move(value));
  }

  pybind11::class_<PythonResult> class_;
  std::shared_ptr<std::vector<std::string>> names_;
};

} // namespace bem_contact
