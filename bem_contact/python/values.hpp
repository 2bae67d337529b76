#pragma once

#include "bem_contact/python/sequence_object.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What Python hands over, in the words of a scene. Anything may come, so that messages are ours; TypeError
/// for what has the wrong type.
namespace bem_contact {

/// A path of a scene file, the text of one (of more than one line), or a dict of its keys, nested or dotted.
/// Relative paths start in `folder`, which is made absolute; "": in the working directory; None: in the
/// file's folder, of a text or a dict in the working directory.
SceneText scene_of(const pybind11::object& scene, const pybind11::object& folder);
/// The same for another process and back: text, source and folder.
pybind11::tuple tuple_of(const SceneText& scene);
SceneText scene_text_of(const pybind11::tuple& scene);
/// The same, read with changes of its keys.
SceneFile scene_file_of(const pybind11::object& scene, const pybind11::object& folder,
                        std::span<const SceneChange> changes);
/// A dict of keys and values, with dots or of dicts, or None. Values are numbers and arrays of any type of
/// NumPy, too.
std::vector<SceneChange> changes_of(const pybind11::object& changes);
/// Throws TypeError for what is no text, and InputError for one that has no UTF-8 (os.listdir() gives such
/// names). `what` it is for.
std::string text_of(const pybind11::object& text, const char* what);
/// A text or a pathlib.Path.
std::string path_of(const pybind11::object& path);
/// "auto, hertz ...": what solver.model may be.
std::string all_models();
/// None and "": the scene's own.
std::string model_of(const pybind11::object& model);
/// Numbers of a list or an array of one dimension, one at least. Throws TypeError. `what` they are, in words.
std::vector<double> numbers_in(const pybind11::object& values, std::string_view what);
/// A copy, as an array of one dimension.
pybind11::array_t<double> array_of(const std::vector<double>& values);
/// Throws TypeError.
[[noreturn]] void refuse_type(const std::string& problem, const std::string& why,
                              const std::string& what_to_do);
/// Throws TypeError if there are any, naming the nearest known argument.
void refuse_unknown(const char* function, const std::vector<std::string>& known, const pybind11::args& more,
                    const pybind11::kwargs& unknown);

} // namespace bem_contact
