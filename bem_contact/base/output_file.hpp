#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace bem_contact {

/// What an output must be.
enum class OutputForm {
  text,      ///< anything that takes bytes one after the other
  whole_file ///< a regular file (HDF5)
};

/// A file that a program is asked to write.
struct Output {
  std::string option;         ///< that names it: "--csv"
  std::filesystem::path file; ///< empty: it is not asked for
  OutputForm form = OutputForm::text;
  bool required = false; ///< an empty name is refused
  /// Of a name that the user did not give: a file that is there is replaced only where it begins so, since
  /// one that does not is somebody else's. "": the name was given.
  std::string begins_with = {};
};

/// Programs call it before they compute. Throws InputError for an output that is an input or the same file as
/// another output, by whatever name, so that no program loses a file that it was given; and for one that
/// cannot be written (output_target()). Empty paths are passed over; files need not exist.
void require_outputs(const std::vector<std::filesystem::path>& inputs, const std::vector<Output>& outputs);

/// What the name of an output leads to.
struct OutputTarget {
  std::filesystem::path file; ///< links are followed
  /// A device, a pipe, or where this program's standard output or error goes: it is written through, and
  /// never replaced.
  bool stream = false;
};

/// Finds out what `output` leads to. Throws InputError if it cannot be written: a folder, a socket, a disk, a
/// file without write permission (for root too), a folder that is not there or may not be written to; for a
/// whole file also a stream.
OutputTarget output_target(const std::filesystem::path& output, OutputForm form);

/// Makes a folder for outputs, and those that it lies in; one that is there will do. Throws InputError.
void make_folder(const std::filesystem::path& folder);

/// A file that is whole or absent. It is written under a temporary name beside it, and commit() renames it.
/// What was not committed is removed with the object; what a killed process has left, by the next one that
/// writes the same file.
class WholeFile {
public:
  /// `file`: where a link leads to (output_target()). The temporary name ends with `ending`, for a writer
  /// that tells the format by it.
  explicit WholeFile(std::filesystem::path file, const std::string& ending = "");
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& file() const { return file_; }
  const std::filesystem::path& temporary() const { return temporary_; }
  /// An existing file is replaced, and its permissions are kept. Throws Error where that fails.
  void commit() const;

private:
  std::filesystem::path file_, temporary_;
};

/// Writes a WholeFile at once. A link is followed, and what it leads to is replaced. Throws InputError for a
/// name that cannot be written to (output_target()), Error where writing fails, as on a full disk.
void write_whole(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// Does the same for text, which a stream takes too.
void write_text(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

} // namespace bem_contact
