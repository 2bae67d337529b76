#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// Something that a result depends on besides the text of its scene.
struct InputRecord {
  std::string key;    ///< "rail.profile"
  std::string name;   ///< as the scene gives it; of an absolute path the last part
  std::string sha256; ///< of the file's bytes; "": a standard profile, which is part of the program
  std::optional<std::string> content; ///< of a file of text: the scene can be repeated without it
};

/// A scene as somebody gave it.
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

/// Files as inputs of their keys. What is no regular file can be read only once, and is not read here.
std::vector<InputRecord> records_of(const std::vector<NamedFile>& files);

/// All files and standard profiles of a scene.
std::vector<InputRecord> inputs_of(const SceneFile& scene);
/// The scene's own file, which may be empty, and all files that the scene names: no output may be one of
/// them.
std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const SceneFile& scene);

/// The beginning of any answer: its format, program and commit.
record::Record headed(const char* format);
/// The beginning of a file: that, the texts "scene_text" and "scene_with_defaults", scene, scene_folder
/// (relative to the folder of `output`), model_option, "materials", and of each input "inputs/KEY" name,
/// sha256 ("" of a standard profile) and content; of a scene with sections "section_lines"
/// (SectionLines::points).
record::Record headed(const char* format, const GivenScene& given, const std::filesystem::path& output);

/// The inputs of a result file.
std::vector<InputRecord> stored_inputs(const record::Record& file);

} // namespace bem_contact
