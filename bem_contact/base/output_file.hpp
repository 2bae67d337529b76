#pragma once

#include <filesystem>
#include <span>

namespace bem_contact {

/// Throws InputError where `output` is one of `taken` (inputs, other outputs), by whatever name: a program
/// never loses a file it was given. Empty paths are passed over; files need not exist.
void refuse_overwriting(const std::filesystem::path& output, std::span<const std::filesystem::path> taken);

} // namespace bem_contact
