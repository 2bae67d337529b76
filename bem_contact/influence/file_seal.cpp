#include "bem_contact/influence/file_seal.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/quick_checksum.hpp"
#include "bem_contact/base/sha256.hpp"

#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <string>

namespace bem_contact {
namespace {

constexpr const char* title = "conformal-contact influence function";

std::ifstream open_file(const std::filesystem::path& file) {
  // Before it is opened, because a pipe would wait for somebody to write.
  if (file_exists(file) && !is_regular(file))
    throw InputError("'" + file.string() + "' is no influence file", "it is not a regular file",
                     "Name a file that fem_influence wrote.");
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError("The influence file '" + file.string() + "' cannot be opened",
                     file_exists(file) ? "no permission to read it" : "there is no such file",
                     fmt::format("Check its name, compute it from the body file: tools/influence BODY.toml "
                                 "{0}, or see which are prepared: "
                                 "bem_contact influence list.",
                                 file.string()));
  return in;
}

/// The first four lines.
std::string four_lines(int major, int minor, std::size_t bytes, const std::string& hash) {
  return fmt::format("{}\nformat {}.{}\nbytes {}\nsha256 {}\n", title, major, minor, bytes, hash);
}

std::string fifth_line(const std::string& checksum) {
  return fmt::format("xxh3 {}\n", checksum);
}

/// The text, then zeros.
std::string padded(std::string text) {
  text.resize(seal_size, '\0');
  return text;
}

} // namespace

void seal(std::span<std::byte> whole_file, int format_major, int format_minor) {
  const std::span<const std::byte> contents = whole_file.subspan(seal_size);
  const std::string lines = four_lines(format_major, format_minor, whole_file.size(), sha256({contents}));
  const std::string text = padded(lines + fifth_line(quick_checksum(lines, contents)));
  std::memcpy(whole_file.data(), text.data(), text.size());
}

std::string seal_of(const std::filesystem::path& file) {
  if (!is_regular(file))
    return {};
  std::ifstream in(file, std::ios::binary);
  std::string found(seal_size, '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  found.resize(static_cast<std::size_t>(in.gcount()));
  return found.starts_with(title) ? found : std::string();
}

void require_replaceable_influence(const std::filesystem::path& file) {
  std::error_code unknown;
  if (is_regular(file) && std::filesystem::file_size(file, unknown) > 0 && !begins_with_seal(file))
    throw InputError(fmt::format("The file '{}' exists and would be replaced", file.string()),
                     "it is no influence file", "Give the output another name, or move this file.");
}

std::string check_seal(const std::filesystem::path& file, int format_major) {
  std::ifstream in = open_file(file);
  std::error_code unknown;
  const std::uintmax_t size_there = std::filesystem::file_size(file, unknown);
  const std::size_t found = unknown ? 0 : static_cast<std::size_t>(size_there);
  const std::string name = std::string("'").append(file.string()).append("'"); // gcc 12 warns of operator+
  std::string first(std::min(found, seal_size), '\0');
  in.read(first.data(), static_cast<std::streamsize>(first.size()));
  std::istringstream head(first);
  std::string line, word;
  std::getline(head, line);
  if (line != title)
    throw InputError(name + " is no influence file", "its first line is not '" + std::string(title) + "'",
                     "Name a file that fem_influence wrote.");
  const std::string again = "Copy it again from where it was whole, or compute it again.";
  int major = 0, minor = 0;
  char dot = 0;
  std::size_t size = 0;
  std::string hash;
  head >> word >> major >> dot >> minor >> word >> size >> word >> hash;
  if (!head)
    throw InputError("The influence file " + name + " is damaged", "its first 512 bytes cannot be read",
                     again);
  if (major != format_major)
    throw InputError(fmt::format("The influence file {} has format version {}.{}", name, major, minor),
                     fmt::format("this program reads version {}", format_major),
                     "Compute it again with the fem_influence of this version.");
  if (found < size || found < seal_size)
    throw InputError("The influence file " + name + " is truncated",
                     fmt::format("it holds {} of {} bytes", found, size), again);
  const bool quick = head >> word && word == "xxh3";
  const std::string lines = four_lines(major, minor, found, quick ? hash : sha256_of_rest(in));
  if (first != padded(quick ? lines + fifth_line(quick_checksum(lines, in)) : lines))
    throw InputError("The influence file " + name + " was altered", "its checksum does not hold", again);
  return hash;
}

} // namespace bem_contact
