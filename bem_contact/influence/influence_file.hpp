#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace bem_contact {

inline constexpr int influence_format_major = 1;
inline constexpr int influence_format_minor = 0; ///< of a kernel
inline constexpr int table_format_minor = 1;     ///< of a table

/// Reads and checks an influence file (data/INFLUENCE_FORMAT.md). Throws InputError for a missing file, a
/// file that is not HDF5 or truncated, another major version, a checksum that does not hold, or contents
/// that validate() refuses.
InfluenceFunction read_influence_file(const std::filesystem::path& file);

/// An influence file whose kernel or table is read for the stations that are asked for, and some around them:
/// a contact needs a fifth of a running surface. One object serves one thread.
class InfluenceFile {
public:
  /// Checks the whole file and reads its strip. Throws what read_influence_file() does; the kernel is
  /// validated when it is read.
  explicit InfluenceFile(std::filesystem::path file);

  const InfluenceStrip& strip() const { return strip_; }
  /// The function on a part of its strip that has these stations. It is valid until the next call. Throws
  /// InputError where the kernel is not valid, or the file is not as it was.
  const InfluenceFunction& around(StationRange stations);

  double megabytes() const; ///< of what is in memory

private:
  struct State {
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type written;
    bool operator==(const State&) const = default;
  };
  State state() const; ///< nothing of a file that is gone
  void require_unchanged();

  std::filesystem::path path_;
  State state_;
  std::string checksum_;
  InfluenceStrip strip_;
  StationRange held_; ///< the stations of part_
  InfluenceFunction part_;
};

/// Writes under a temporary name beside `file` and renames when complete: `file` is whole or absent.
void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function);

} // namespace bem_contact
