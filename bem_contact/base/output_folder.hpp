#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Who writes into a folder, and how.
struct FolderUse {
  std::string maker;     ///< the command: "study"
  std::string list = ""; ///< which of its lists, where several processes write at the same time
  bool alone = true;     ///< the whole folder is the maker's; else the files of others may lie in it
  std::vector<std::filesystem::path> inputs = {}; ///< files that the run reads
};

/// A folder for files whose names the user did not choose, so that he cannot know what they would replace.
///
/// A list in the folder (.made_by_study) says what the maker has written: lines "SHA-256  name", as
/// `sha256sum -c` reads them. A file that is not in the list, or that has changed since, is not ours: the run
/// is refused, and the file is neither replaced nor removed. So is a name that is a link. A line without a
/// digest comes before each file, so that one is ours whose writing was interrupted.
class OutputFolder {
public:
  /// Makes the folder, and marks one that the maker has alone. Throws InputError where they cannot be made,
  /// and for a folder that the maker has to have alone and that holds something else.
  OutputFolder(std::filesystem::path folder, FolderUse use);

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

  /// Whether a maker has begun such a list.
  static bool has_list(const std::filesystem::path& folder, const FolderUse& use);

  bool lists(const std::string& name) const { return listed_.contains(name); }
  /// Whether the file is there as the maker has written it.
  bool owns(const std::string& name) const;
  /// Throws InputError unless a file of that name may be written.
  void require(const std::string& name) const;
  /// Throws InputError where a listed file was changed. One that is gone is no harm.
  void require_unchanged() const;

  /// The file, which the caller writes now: require(), and a line of the list. Then done().
  std::filesystem::path take(const std::string& name);
  void done(const std::string& name);
  /// Does all three for a text.
  void write(const std::string& name, const std::function<void(std::ostream&)>& write);
  /// Says that what is there may be replaced, as a state that does not count any more.
  void adopt(const std::string& name) { done(name); }
  /// Removes the file if it is ours.
  void remove(const std::string& name);
  /// remove() of all that is listed but these.
  void remove_others(const std::vector<std::string>& kept);
  /// Removes all that is listed, and the list and the folder where nothing else is in it.
  void remove_all();

private:
  struct Written {
    std::string digest = {}; ///< SHA-256; "": none
    bool begun = false;      ///< its writing has not ended
  };

  std::filesystem::path list_file() const;
  void require_alone() const;
  void begin_list() const;
  void read_list();
  void note(std::string_view digest, const std::string& name);

  std::filesystem::path folder_;
  FolderUse use_;
  std::map<std::string, Written> listed_;
};

} // namespace bem_contact
