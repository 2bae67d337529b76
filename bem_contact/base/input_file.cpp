#include "bem_contact/base/input_file.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace bem_contact {

namespace {

[[noreturn]] void refuse(const std::string& file, std::string_view what, std::string_view why,
                         std::string_view what_to_do) {
  throw InputError(fmt::format("{} '{}' cannot be read", what, file), why, what_to_do);
}

} // namespace

bool file_exists(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

bool is_regular(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

void require_readable(const std::string& file, std::string_view what) {
  std::error_code ignored;
  const std::filesystem::file_status found = std::filesystem::status(file, ignored);
  if (std::filesystem::is_directory(found))
    refuse(file, what, "it is a folder", "Name a file.");
  if (std::filesystem::is_character_file(found) || std::filesystem::is_block_file(found) ||
      std::filesystem::is_socket(found))
    refuse(file, what, "it is a device, which need not have an end", "Name a file.");
}

std::ifstream open_input(const std::string& file, std::string_view what) {
  require_readable(file, what);
  std::ifstream in(std::filesystem::path(file), std::ios::binary); // a name is UTF-8 on every system
  if (!in)
    refuse(file, what, file_exists(file) ? "no permission" : "there is no such file",
           "Check the path; relative paths start in the folder of the file that names them.");
  return in;
}

void require_read(const std::istream& in, const std::string& file, std::string_view what) {
  if (in.bad())
    refuse(file, what, "reading it failed", "Check the disk, or copy the file.");
}

std::string read_bytes(const std::string& file, std::string_view what, std::size_t most) {
  std::ifstream in = open_input(file, what);
  const auto require_size = [&](std::uintmax_t size) {
    if (size > most)
      refuse(file, what, fmt::format("it has more than {} bytes", most), "Name a smaller file.");
  };
  std::error_code unknown;
  if (is_regular(file)) // a gigabyte is not read for nothing; of a pipe only reading tells
    if (const std::uintmax_t size = std::filesystem::file_size(file, unknown); !unknown)
      require_size(size);
  constexpr std::size_t piece = 1 << 16;
  std::string text;
  for (std::size_t size = 0; in; text.resize(size)) {
    text.resize(std::max(2 * size, piece)); // doubled, so that a large file is not copied again and again
    in.read(text.data() + size, static_cast<std::streamsize>(text.size() - size));
    size += static_cast<std::size_t>(in.gcount());
    require_size(size);
  }
  require_read(in, file, what);
  return text;
}

std::string read_text_file(const std::string& file, std::string_view what, std::size_t most) {
  std::string text = read_bytes(file, what, most);
  if (text.starts_with(byte_order_mark))
    text.erase(0, byte_order_mark.size());
  return text;
}

std::vector<Point2> read_points(const std::filesystem::path& file) {
  std::istringstream in(read_text_file(file.string(), "profile"));
  std::vector<Point2> points;
  for (Point2 p; in >> p.y >> p.z;)
    points.push_back(p);
  return points;
}

} // namespace bem_contact
