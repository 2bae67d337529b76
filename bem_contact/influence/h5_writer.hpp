#pragma once

#include "bem_contact/influence/h5_table.hpp"

#include <filesystem>
#include <memory>

namespace bem_contact {

/// Writes a file table by table, for more than memory holds. It has a temporary name beside `file` until
/// finish() renames it: `file` is whole or absent. Throws InputError where it cannot be written. What `file`
/// may be: base/output_file.hpp, OutputForm::whole_file.
class H5Writer {
public:
  explicit H5Writer(const std::filesystem::path& file);
  ~H5Writer(); ///< removes what was not finished
  H5Writer(const H5Writer&) = delete;
  H5Writer& operator=(const H5Writer&) = delete;

  /// Names must be new to the file, but for groups.
  void add(const H5Table& table);
  void finish();

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact
