#pragma once

#include "bem_contact/base/temporary_folder.hpp"
#include "bem_contact/explore/start.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <filesystem>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace bem_contact::explore {

/// A scene as the page asks for it.
struct Question {
  std::string text;                      ///< TOML
  std::vector<SceneChange> changes = {}; ///< of the text
  HeldFiles files = {};                  ///< that the scene may name
  std::string window = {};               ///< who asks
};

/// Throws InputError for what is no question.
Question parse_question(const std::string& json);

/// Turns questions into scenes, and sees to it that no file is read but those that the program was started
/// with and those that came with the question. Several threads may ask at once.
class AskedScenes {
public:
  explicit AskedScenes(const Start& start);

  /// To be solved: held files lie in a folder of copies. Throws InputError for what is no scene, and for a
  /// file that may not be read.
  SceneFile scene(const Question& question);
  /// To be kept: the text with its changes, and names as the text has them.
  GivenScene given(const Question& question);
  /// What its keys name, but for standard profiles; of "FILE#2" the name is FILE. No file is read.
  std::vector<NamedFile> names(const Question& question) const;
  /// From now on a scene may name this file of ours.
  void hold(const std::string& name, const std::filesystem::path& file);
  /// What a message says, without the folder of copies.
  std::string in_plain_names(std::string message) const;

private:
  struct Copy {
    std::filesystem::path place;
    std::size_t bytes;
  };

  std::filesystem::path copy_of(const std::string& name, const std::string& content);
  void forget_old_copies();
  void require_readable(const NamedFile& file) const;
  std::optional<std::filesystem::path> of_ours(const std::string& name);
  SceneText text_of(const Question& question) const;
  SceneReader reader_of(const Question& question) const;

  std::string source_;
  std::filesystem::path folder_;             ///< where relative paths of scenes start
  std::set<std::filesystem::path> readable_; ///< in the form of plain()
  TemporaryFolder copies_;
  std::list<Copy> written_;                           ///< the one used last is the first
  std::map<std::string, std::filesystem::path> ours_; ///< by the names of hold()
  mutable std::mutex writing_;
};

} // namespace bem_contact::explore
