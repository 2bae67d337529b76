#include "bem_contact/influence/file_seal.hpp"

#include "bem_contact/base/error.hpp"

#include <openssl/evp.h>

#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

namespace bem_contact {
namespace {

constexpr const char* title = "conformal-contact influence function";

std::vector<std::byte> read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError("the influence file '" + file.string() + "' cannot be opened",
                     std::filesystem::exists(file) ? "no permission to read it" : "there is no such file",
                     "check its name, or compute it with tools/influence");
  if (!std::filesystem::is_regular_file(file))
    throw InputError("'" + file.string() + "' is no influence file", "it is not a regular file",
                     "name a file that fem_influence wrote");
  std::vector<std::byte> bytes(std::filesystem::file_size(file));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(in.gcount()) != bytes.size())
    throw InputError("the influence file '" + file.string() + "' cannot be read", "reading stopped early",
                     "check the disk, or compute it again");
  return bytes;
}

std::array<char, seal_size> make_seal(int major, int minor, std::span<const std::byte> whole_file) {
  std::ostringstream text;
  text << title << "\nformat " << major << '.' << minor << "\nbytes " << whole_file.size() << "\nsha256 "
       << sha256(whole_file.subspan(seal_size)) << '\n';
  std::array<char, seal_size> seal{};
  const std::string s = text.str();
  std::memcpy(seal.data(), s.data(), s.size());
  return seal;
}

} // namespace

std::string sha256(std::span<const std::byte> data) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(data.data(), data.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw Error("a checksum cannot be computed", "OpenSSL's SHA-256 failed",
                "check the OpenSSL installation");
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    hex += "0123456789abcdef"[digest[i] >> 4];
    hex += "0123456789abcdef"[digest[i] & 15];
  }
  return hex;
}

void seal(std::span<std::byte> whole_file, int format_major, int format_minor) {
  const auto text = make_seal(format_major, format_minor, whole_file);
  std::memcpy(whole_file.data(), text.data(), text.size());
}

void seal_file(const std::filesystem::path& file, int format_major, int format_minor) {
  const auto text = make_seal(format_major, format_minor, read_bytes(file));
  std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
  out.write(text.data(), text.size());
  out.close();
  if (!out)
    throw InputError("the influence file '" + file.string() + "' cannot be written", "the disk may be full",
                     "make room and run again");
}

bool begins_with_seal(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string found(std::strlen(title), '\0');
  return in.read(found.data(), static_cast<std::streamsize>(found.size())) && found == title;
}

void check_seal(const std::filesystem::path& file, int format_major) {
  const std::vector<std::byte> bytes = read_bytes(file);
  const std::string name = std::string("'").append(file.string()).append("'"); // gcc 12 warns of operator+
  std::istringstream head(
      std::string(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), seal_size)));
  std::string line, word;
  std::getline(head, line);
  if (line != title)
    throw InputError(name + " is no influence file", "its first line is not '" + std::string(title) + "'",
                     "name a file that fem_influence wrote");
  const std::string again = "copy it again from where it was whole, or compute it again";
  int major = 0, minor = 0;
  char dot = 0;
  std::size_t size = 0;
  head >> word >> major >> dot >> minor >> word >> size;
  if (!head)
    throw InputError("the influence file " + name + " is damaged", "its first 512 bytes cannot be read",
                     again);
  if (major != format_major)
    throw InputError("the influence file " + name + " has format version " + std::to_string(major) + "." +
                         std::to_string(minor),
                     "this program reads version " + std::to_string(format_major),
                     "compute it again with the fem_influence of this version");
  if (bytes.size() < size || bytes.size() < seal_size)
    throw InputError("the influence file " + name + " is truncated",
                     "it holds " + std::to_string(bytes.size()) + " of " + std::to_string(size) + " bytes",
                     again);
  const auto expected = make_seal(major, minor, bytes);
  if (std::memcmp(expected.data(), bytes.data(), seal_size) != 0)
    throw InputError("the influence file " + name + " was altered", "its checksum does not hold", again);
}

} // namespace bem_contact
