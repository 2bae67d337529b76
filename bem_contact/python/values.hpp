#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

/// What Python hands over, in the words of a scene. Anything may come, so that messages are ours; TypeError
/// for what has the wrong type.
namespace bem_contact {

/// A str or a path.
std::string path_of(const pybind11::object& scene);
/// A dict of keys and values, or None. Values are numbers and arrays of any type of NumPy, too.
std::vector<SceneChange> changes_of(const pybind11::object& changes);
/// None and "": the scene's own.
std::string model_of(const pybind11::object& model);
/// Throws TypeError if there are any, naming the nearest known argument.
void refuse_unknown(const char* function, const pybind11::args& more, const pybind11::kwargs& unknown);

} // namespace bem_contact
