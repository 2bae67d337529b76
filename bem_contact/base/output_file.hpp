#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>

namespace bem_contact {

/// Throws InputError where `output` is one of `taken` (inputs, other outputs), by whatever name: a program
/// never loses a file it was given. Empty paths are passed over; files need not exist.
void refuse_overwriting(const std::filesystem::path& output, std::span<const std::filesystem::path> taken);

/// Writes text under a temporary name beside `file` and renames when complete: `file` is whole or absent.
/// Throws InputError where it cannot be written.
void write_whole(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

} // namespace bem_contact
