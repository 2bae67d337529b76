#pragma once

#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Why a command does not continue the work that it finds in a file: it was begun with other input, as its
/// digest shows.
inline constexpr const char* digest_changed =
    "the scene, a file that it names, an option or this program (version or commit) has changed since";

/// Something that a result depends on besides the text of its scene.
struct InputRecord {
  std::string key;    ///< "rail.profile"
  std::string name;   ///< as the scene gives it; of an absolute path the last part
  std::string sha256; ///< of the file's bytes; "": a standard profile, which is part of the program
  std::optional<std::string> content; ///< of a file of text: the scene can be repeated without it
};

/// A scene as a command was given it.
struct GivenScene {
  SceneText text;                  ///< of its file
  std::string model;               ///< of the option --model; "": none
  SceneFile scene;                 ///< with the model of the option
  std::vector<InputRecord> inputs; ///< inputs_of() the scene, before it is solved; empty: not recorded
};

/// Reads the file once, so that it may be a pipe; `changes` replace its values. Throws InputError for what is
/// no scene.
GivenScene read_given_scene(const std::string& file, const std::string& model,
                            std::span<const SceneChange> changes = {});

/// The same for a command with these outputs, none of which may be a file that it reads. If there is a result
/// file among them, the inputs are recorded.
GivenScene read_given_scene_for(const std::vector<Output>& outputs, const std::string& file,
                                const std::string& model);

/// Files as inputs of their keys. What is no regular file can be read only once, and is not read here.
std::vector<InputRecord> records_of(const std::vector<NamedFile>& files);

/// All files and standard profiles of a scene.
std::vector<InputRecord> inputs_of(const SceneFile& scene);
/// The scene's own file, which may be empty, and all files that the scene names: no output may be one of
/// them.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const SceneFile& scene);

/// Texts "scene_text" and "scene_with_defaults", attributes program, commit, scene, scene_folder (relative to
/// the folder of `output`), model_option, and the groups "materials" and "inputs": of each input "inputs/KEY"
/// the attributes name, sha256 ("" of a standard profile), and the text "inputs/KEY/content".
void add_scene(H5Table& table, const GivenScene& given, const std::filesystem::path& output);
/// The beginning of a file: its format, and that.
H5Table file_of(const char* format, const GivenScene& given, const std::filesystem::path& output);

/// The inputs of a result file.
std::vector<InputRecord> stored_inputs(const H5Table& table);

} // namespace bem_contact::app
