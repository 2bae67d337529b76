#include "bem_contact/app/fmu/zip_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <zlib.h>

namespace bem_contact::app {

namespace {

/// Numbers of the format (PKWARE, APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16), the lowest byte first.
struct ZipBytes {
  std::string text;
  void add(std::uint64_t number, int bytes) {
    for (int i = 0; i < bytes; ++i)
      text += static_cast<char>(number >> (8 * i) & 0xff);
  }
  void add2(std::initializer_list<std::uint64_t> numbers) {
    for (const std::uint64_t number : numbers)
      add(number, 2);
  }
  void add4(std::initializer_list<std::uint64_t> numbers) {
    for (const std::uint64_t number : numbers)
      add(number, 4);
  }
};
constexpr std::uint64_t version = 20, utf8_names = 1 << 11, deflated = 8;
constexpr std::uint64_t midnight = 0,
                        first_day = (1 << 5) + 1; // 1 January 1980: two runs write the same bytes
constexpr std::uint64_t file_mark = 0x04034b50, directory_mark = 0x02014b50, end_mark = 0x06054b50;

/// Compressed without zlib's own header, as archives have it.
std::string deflated_bytes(const std::string& bytes) {
  constexpr int bare = -15, memory = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, bare, memory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw Error("The archive cannot be written", "zlib has no memory for it", "Free memory.");
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string archive_of(const std::vector<ZipEntry>& entries) {
  ZipBytes files, directory;
  for (const ZipEntry& entry : entries) {
    const std::string packed = deflated_bytes(entry.bytes);
    const auto crc =
        crc32(0, reinterpret_cast<const Bytef*>(entry.bytes.data()), static_cast<uInt>(entry.bytes.size()));
    const std::uint64_t place = files.text.size();
    const auto about = [&](ZipBytes& out) {
      out.add2({version, utf8_names, deflated, midnight, first_day});
      out.add4({crc, packed.size(), entry.bytes.size()});
      out.add2({entry.name.size(), 0});
    };
    files.add4({file_mark});
    about(files);
    files.text += entry.name + packed;
    directory.add4({directory_mark});
    directory.add2({version});
    about(directory);
    directory.add2({0, 0, 0}); // comment, disk, kind
    directory.add4({0, place});
    directory.text += entry.name;
  }
  ZipBytes end;
  end.add4({end_mark});
  end.add2({0, 0, entries.size(), entries.size()});
  end.add4({directory.text.size(), files.text.size()});
  end.add2({0});
  return files.text + directory.text + end.text;
}

} // namespace

void write_zip(const std::filesystem::path& file, const std::vector<ZipEntry>& entries) {
  std::uint64_t size = 0;
  for (const ZipEntry& entry : entries)
    size += entry.bytes.size();
  if (size > std::numeric_limits<std::int32_t>::max())
    throw InputError(fmt::format("'{}' cannot be written", file.string()), "an archive holds at most 2 GB",
                     "Take a smaller table.");
  const std::string archive = archive_of(entries);
  write_whole(file, [&](std::ostream& out) { out << archive; });
}

} // namespace bem_contact::app
