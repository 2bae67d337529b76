#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace bem_contact {

inline constexpr int influence_format_major = 1;
inline constexpr int influence_format_minor = 0; ///< of a kernel
inline constexpr int table_format_minor = 1;     ///< of a table

/// Reads and checks an influence file (data/INFLUENCE_FORMAT.md). Throws InputError for a missing file, a
/// file that is not HDF5 or truncated, another major version, a checksum that does not hold, or contents
/// that validate() refuses.
InfluenceFunction read_influence_file(const std::filesystem::path& file);

/// Writes under a temporary name beside `file` and renames when complete: `file` is whole or absent.
void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function);

/// Throws InputError when the file was made for another profile (digest) or another material.
void require_profile(const InfluenceFunction& function, const std::string& profile, std::uint64_t digest);
void require_material(const InfluenceFunction& function, const Material& material);
/// Throws InputError when the lower body (rail) is an upper one and the upper body (wheel) is a lower one.
void require_order(const InfluenceFunction& lower, const InfluenceFunction& upper);
/// Throws InputError when [s_from, s_to] is not inside the strip.
void require_strip(const InfluenceFunction& function, double s_from, double s_to);

/// A run in progress: the parts done so far, by wavenumber, in `file` + ".part". Survives a kill.
/// (One part: kernel, remote, remote_self of one wavenumber.)
class PartialInfluenceFile {
public:
  /// Opens or creates; an existing file whose `fingerprint` differs is discarded.
  PartialInfluenceFile(std::filesystem::path file, std::string fingerprint, std::size_t stations,
                       std::span<const double> wavenumber);
  ~PartialInfluenceFile();
  bool has(std::size_t k) const;
  /// numbers: the kernel's lower triangle by rows, remote, remote_self, and errors of any meaning.
  void write(std::size_t k, std::vector<double> numbers);
  /// Wavenumbers, kernel and remote of all parts, which must be there, and their errors one after the other;
  /// they are kept in the file alone then.
  void take_into(InfluenceFunction& function, std::vector<double>& errors);
  void remove(); ///< after the final file is complete

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace bem_contact
