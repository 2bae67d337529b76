#include "bem_contact/base/output_folder.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/base/system/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <iterator>
#include <sstream>
#include <utility>

namespace bem_contact {

namespace {

namespace fs = std::filesystem;

/// Bytes. A list has 100 for each time that a file is written.
constexpr std::size_t largest_list = 100'000'000;

const std::string no_digest(sha256_size, '-'); ///< of a file that is being written
const std::string no_file(sha256_size, '0');   ///< of one that was removed

std::string mark_of(const FolderUse& use) {
  return ".made_by_" + use.maker;
}

std::string name_of_list(const FolderUse& use) {
  return mark_of(use) + (use.list.empty() ? "" : "_" + use.list);
}

std::string heading_of(const FolderUse& use) {
  return fmt::format(
      "# Files of bem_contact {}, as sha256sum -c reads them. What is not listed is not its own.", use.maker);
}

bool is_link(const fs::path& file) {
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(file, ignored));
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

[[noreturn]] void refuse_replacing(const fs::path& file, const std::string& why,
                                   const std::string& what_to_do) {
  throw InputError(fmt::format("The file '{}' would be replaced", file.string()), why, what_to_do);
}

} // namespace

OutputFolder::OutputFolder(fs::path folder, FolderUse use)
    : folder_(std::move(folder)), use_(std::move(use)) {
  make_folder(folder_);
  if (use_.alone)
    require_alone();
  if (is_there(list_file()))
    read_list();
  else if (use_.alone)
    begin_list();
}

bool OutputFolder::has_list(const fs::path& folder, const FolderUse& use) {
  return is_there(folder / name_of_list(use));
}

fs::path OutputFolder::list_file() const {
  return folder_ / name_of_list(use_);
}

void OutputFolder::begin_list() const {
  write_text(list_file(), [&](std::ostream& out) { out << heading_of(use_) << '\n'; });
}

void OutputFolder::require_alone() const {
  std::error_code failed;
  std::string other;
  for (fs::directory_iterator at(folder_, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(mark_of(use_)))
      return;
    other = name;
  }
  if (failed || !other.empty())
    throw InputError(
        fmt::format("The folder '{}' is not one of bem_contact {}", folder_.string(), use_.maker),
        failed ? failed.message()
               : fmt::format("it is not empty ('{}'), and has no list {}: its files might be "
                             "overwritten",
                             other, mark_of(use_)),
        "Give a new folder, or an empty one.");
}

void OutputFolder::read_list() {
  const fs::path file = list_file();
  const std::string heading = heading_of(use_);
  std::istringstream in(is_link(file) || !is_regular(file)
                            ? std::string()
                            : read_text_file(file.string(), "list", largest_list));
  std::string line;
  if (!std::getline(in, line) || line != heading)
    throw InputError(fmt::format("The list '{}' cannot be used", file.string()),
                     fmt::format("it is damaged, or not of bem_contact {}", use_.maker),
                     "Give another folder.");
  while (std::getline(in, line)) {
    if (line.size() <= sha256_size + 2 || line.substr(sha256_size, 2) != "  ")
      continue; // a kill left it unfinished
    const std::string digest = line.substr(0, sha256_size);
    Written& one = listed_[line.substr(sha256_size + 2)];
    one.begun = digest == no_digest;
    if (!one.begun)
      one.digest = digest;
  }
}

bool OutputFolder::owns(const std::string& name) const {
  const auto found = listed_.find(name);
  const fs::path file = folder_ / name;
  return found != listed_.end() && !is_link(file) && is_regular(file) &&
         (found->second.begun || sha256_of_file(file.string()) == found->second.digest);
}

void OutputFolder::require(const std::string& name) const {
  const fs::path file = folder_ / name;
  if (name.find_first_of("\n\r") != name.npos)
    throw InputError(fmt::format("The file '{}' cannot be written", file.string()),
                     "its name has more than one line", "Rename the file that it is named after.");
  require_outputs(use_.inputs, {{.option = "bem_contact " + use_.maker, .file = file}});
  if (is_link(file))
    refuse_replacing(file, "it is a link", "Give another folder, or remove it.");
  if (is_there(file) && !owns(name))
    refuse_replacing(file,
                     lists(name) ? "it has changed since it was written"
                                 : fmt::format("bem_contact {} has not made it", use_.maker),
                     "Give another folder, or move this file.");
}

void OutputFolder::require_unchanged() const {
  for (const auto& [name, written] : listed_)
    if (is_there(folder_ / name) && !owns(name))
      throw InputError(
          fmt::format("The file '{}' has changed since it was written", (folder_ / name).string()),
          fmt::format("its SHA-256 is not that of {}", list_file().string()),
          "Bring it back as it was, or begin in a new folder.");
}

fs::path OutputFolder::take(const std::string& name) {
  require(name);
  note(no_digest, name);
  return folder_ / name;
}

void OutputFolder::done(const std::string& name) {
  const fs::path file = folder_ / name;
  note(is_regular(file) ? sha256_of_file(file.string()) : no_file, name);
}

void OutputFolder::write(const std::string& name, const std::function<void(std::ostream&)>& write) {
  write_text(take(name), write);
  done(name);
}

void OutputFolder::remove(const std::string& name) {
  if (!owns(name))
    return;
  std::error_code ignored;
  fs::remove(folder_ / name, ignored);
  note(no_file, name);
}

void OutputFolder::remove_others(const std::vector<std::string>& kept) {
  const std::map<std::string, Written> all = listed_;
  for (const auto& [name, written] : all)
    if (std::ranges::count(kept, name) == 0)
      remove(name);
}

void OutputFolder::remove_all() {
  remove_others({});
  std::error_code ignored;
  const auto entries = std::distance(fs::directory_iterator(folder_, ignored), fs::directory_iterator());
  if (!ignored && entries == 1 && is_there(list_file())) {
    fs::remove(list_file(), ignored);
    fs::remove(folder_, ignored);
  }
}

/// Appended in one piece: a kill leaves a line or none.
void OutputFolder::note(std::string_view digest, const std::string& name) {
  Written& one = listed_[name];
  const bool begun = digest == no_digest;
  if (begun ? one.begun : !one.begun && one.digest == digest)
    return;
  one.begun = begun;
  if (!begun)
    one.digest = digest;
  if (!is_there(list_file()))
    begin_list();
  const std::string line = fmt::format("{}  {}\n", digest, name);
  const int list = system::open_file(list_file(), system::OpenFor::appending);
  const bool written = list >= 0 && system::write_all(list, line);
  const std::string why = std::strerror(errno);
  if (list >= 0)
    system::close_file(list);
  if (!written)
    throw Error(fmt::format("The list '{}' cannot be written", list_file().string()), why,
                "Check that the disk is not full and that you may write there.");
}

} // namespace bem_contact
