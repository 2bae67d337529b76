#include "bem_contact/base/output_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/system/files.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace bem_contact {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 255;      // bytes, NAME_MAX
constexpr int most_links = 40;                 // as many as Linux follows
constexpr const char* temporary_mark = ".tmp"; // then comes the number of the process

[[noreturn]] void refuse(const fs::path& file, const std::string& why, const std::string& what_to_do) {
  throw InputError("The file '" + file.string() + "' cannot be written", why, what_to_do);
}

/// Of a name that could be written to.
[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw Error("The file '" + file.string() + "' cannot be written", why,
              "Check that the disk is not full and that you may write there.");
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The end of a chain of links, which need not exist. Nothing if it has no end.
std::optional<fs::path> end_of_links(const fs::path& name) {
  fs::path at = name;
  std::error_code failed;
  for (int links = 0; links < most_links; ++links) {
    if (!fs::is_symlink(fs::symlink_status(at, failed)) || system::stands_for_something_open(at))
      return at;
    const fs::path to = fs::read_symlink(at, failed);
    at = to.is_absolute() ? to : folder_of(at) / to;
  }
  return std::nullopt;
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  const auto whole = [&](const fs::path& name) {
    return fs::weakly_canonical(fs::absolute(end_of_links(name).value_or(name), ignored), ignored);
  };
  return fs::equivalent(a, b, ignored) || whole(a) == whole(b);
}

/// Throws where `output` is the file `taken`. `why` names what that is.
void refuse_overwriting(const Output& output, const fs::path& taken, const std::string& why) {
  if (!taken.empty() && same_file(output.file, taken))
    throw InputError(fmt::format("The output '{}' of {} would overwrite '{}'", output.file.string(),
                                 output.option, taken.string()),
                     why, "Give the output another name.");
}

/// Throws where a file of somebody else would be replaced.
void require_begin(const fs::path& file, const std::string& begin) {
  std::error_code unknown;
  const fs::file_status found = fs::symlink_status(file, unknown);
  const bool regular = fs::is_regular_file(found);
  if (!fs::exists(found) || (regular && fs::file_size(file, unknown) == 0))
    return;
  std::string first(begin.size(), '\0');
  std::ifstream in;
  if (regular) // a pipe would wait, and a link leads elsewhere
    in.open(file, std::ios::binary);
  if (!regular || !in.read(first.data(), static_cast<std::streamsize>(first.size())) || first != begin)
    throw InputError(fmt::format("The file '{}' exists and would be replaced", file.string()),
                     "it is not one that this command has written there",
                     "Give the output another name, or move this file.");
}

/// Beside the file. A long name loses its end for it, since no name has more than NAME_MAX bytes.
fs::path temporary_name(const fs::path& file, const std::string& ending) {
  const std::string tail = fmt::format("{}{}{}", temporary_mark, system::this_process(), ending);
  const std::string name = file.filename().string();
  return file.parent_path() / (name.substr(0, std::min(name.size(), longest_name - tail.size())) + tail);
}

bool is_too_long(const fs::path& file) {
  std::error_code why;
  return !fs::status_known(fs::status(file, why)) && why == std::errc::filename_too_long;
}

void require_permission(const fs::path& file, const fs::path& output, fs::perms allowed) {
  using enum fs::perms;
  // The system refuses root nothing, so that the bits count too.
  if ((allowed & (owner_write | group_write | others_write)) == none || !system::may_write(file))
    refuse(output, "it exists and is protected from writing", "Give another file, or chmod u+w this one.");
  if (system::is_held_elsewhere(file))
    refuse(output, "another program has it open", "Close it there, or give another file.");
}

void require_folder(const fs::path& file, const fs::path& output) {
  const fs::path folder = folder_of(file);
  std::error_code ignored;
  if (file.filename().empty())
    refuse(output, "it names no file", "Give the file a name.");
  if (!fs::is_directory(folder, ignored))
    refuse(output, "there is no folder '" + folder.string() + "'", "Make the folder, or give another file.");
  if (!system::may_write_into(folder))
    refuse(output, "you may not write to the folder '" + folder.string() + "'", "Give another file.");
}

/// What std::ofstream cannot say.
std::string last_error(const char* otherwise) {
  return errno != 0 ? std::generic_category().message(errno) : otherwise;
}

void write_through(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  const bool output = system::is_standard_output(file), error = !output && system::is_standard_error(file);
  std::ofstream opened;
  if (!output && !error)
    opened.open(file, std::ios::binary | std::ios::app);
  std::ostream& out = output ? std::cout : error ? std::cerr : opened;
  errno = 0;
  std::fflush(stdout);
  if (out)
    write(out);
  out.flush();
  if (!out)
    fail(file, last_error("writing stopped early"));
}

void replace(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  const WholeFile whole(file);
  errno = 0;
  std::ofstream out(whole.temporary(), std::ios::binary);
  if (out)
    write(out);
  out.close();
  if (!out)
    fail(file, last_error("writing stopped early"));
  whole.commit();
}

/// Whether `text` is the number of a process that has ended.
bool is_of_ended_process(std::string_view text) {
  int process = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), process);
  return failed == std::errc() && end == text.data() + text.size() && process > 0 &&
         !system::is_running(process);
}

/// Removes what killed processes have left of the same file.
void remove_leftovers(const fs::path& file, const std::string& ending) {
  const std::string begin = file.filename().string() + temporary_mark;
  std::error_code ignored;
  for (fs::directory_iterator at(folder_of(file), ignored), end; !ignored && at != end;
       at.increment(ignored)) {
    const std::string name = at->path().filename().string();
    if (name.size() > begin.size() + ending.size() && name.starts_with(begin) && name.ends_with(ending) &&
        is_of_ended_process(
            std::string_view(name).substr(begin.size(), name.size() - begin.size() - ending.size())) &&
        at->symlink_status(ignored).type() == fs::file_type::regular)
      fs::remove(at->path(), ignored);
  }
}

/// What a name leads to after a crash of the machine must be whole, too: bytes reach the disk before the name
/// does. Some file systems cannot be asked, and keep what they have.
void put_on_disk(const fs::path& written, const fs::path& file) {
  errno = 0;
  if (!system::put_on_disk(written))
    fail(file, last_error("it cannot be put on the disk"));
}

} // namespace

void require_outputs(const std::vector<fs::path>& inputs, const std::vector<Output>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->file.empty() && !output->required)
      continue;
    for (const fs::path& input : inputs)
      refuse_overwriting(*output, input, "this run reads it");
    for (auto other = outputs.begin(); other != output; ++other)
      refuse_overwriting(*output, other->file, "it is the output of " + other->option);
    output_target(output->file, output->form);
    if (!output->begins_with.empty())
      require_begin(output->file, output->begins_with);
  }
}

OutputTarget output_target(const fs::path& output, OutputForm form) {
  const std::optional<fs::path> end = end_of_links(output);
  if (!end)
    refuse(output, "it is a link that leads back to itself", "Give another file.");
  const fs::path& file = *end;
  if (output == "-")
    refuse(output, "it would be a file of this name, and not the standard output",
           form == OutputForm::text ? "Give another name, or a device such as /dev/stdout."
                                    : "Give another name.");
  if (is_too_long(file) || is_too_long(temporary_name(file, "")))
    refuse(output, "the name is too long", "Give a shorter one.");
  std::error_code unknown;
  const fs::file_status found = fs::status(file, unknown);
  if (!fs::exists(found)) {
    require_folder(file, output);
    return {file, false};
  }
  if (fs::is_directory(found))
    refuse(output, "it is a folder", "Give the name of a file in it.");
  if (fs::is_socket(found) || fs::is_block_file(found))
    refuse(output, fs::is_block_file(found) ? "it is a disk" : "it is a socket", "Give the name of a file.");
  const bool regular = fs::is_regular_file(found),
             standard = system::is_standard_output(file) || system::is_standard_error(file),
             stream = standard || !regular || system::stands_for_something_open(file);
  if (stream && form == OutputForm::whole_file)
    refuse(output,
           !regular   ? "it is a device or a pipe, and the output is a whole file"
           : standard ? "standard output goes there"
                      : "it stands for a file that is open",
           "Give the name of a regular file.");
  if (!standard)
    require_permission(file, output, found.permissions());
  if (!stream)
    require_folder(file, output);
  return {file, stream};
}

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (std::error_code unknown; !failed && !fs::is_directory(folder, unknown))
    failed = std::make_error_code(std::errc::not_a_directory);
  if (failed)
    throw InputError(fmt::format("The folder '{}' cannot be made", folder.string()),
                     failed == std::errc::filename_too_long ? "the name is too long" : failed.message(),
                     "Give another one.");
}

WholeFile::WholeFile(fs::path file, const std::string& ending)
    : file_(std::move(file)), temporary_(temporary_name(file_, ending)) {
  remove_leftovers(file_, ending);
}

WholeFile::~WholeFile() {
  std::error_code ignored; // of a file that was committed nothing is left here
  fs::remove(temporary_, ignored);
}

void WholeFile::commit() const {
  std::error_code failed;
  if (const fs::file_status before = fs::status(file_, failed); fs::exists(before))
    fs::permissions(temporary_, before.permissions(), failed);
  put_on_disk(temporary_, file_);
  fs::rename(temporary_, file_, failed);
  if (failed)
    fail(file_, failed.message());
}

void write_whole(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  replace(output_target(file, OutputForm::whole_file).file, write);
}

void write_text(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  const OutputTarget target = output_target(file, OutputForm::text);
  target.stream ? write_through(target.file, write) : replace(target.file, write);
}

} // namespace bem_contact
