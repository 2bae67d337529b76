#include "bem_contact/base/sha256.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/sha256_digest.hpp"

#include <array>
#include <fmt/format.h>
#include <fstream>

namespace bem_contact {
namespace {

std::string hex(const std::function<std::span<const std::byte>()>& next) {
  return fmt::format("{:02x}", fmt::join(sha256_digest(next), ""));
}

} // namespace

std::string sha256(std::initializer_list<std::span<const std::byte>> pieces) {
  auto piece = pieces.begin();
  return hex([&]() -> std::span<const std::byte> {
    while (piece != pieces.end() && piece->empty())
      ++piece;
    return piece == pieces.end() ? std::span<const std::byte>{} : *piece++;
  });
}

std::string sha256(std::string_view text) {
  return sha256({std::as_bytes(std::span(text))});
}

std::string sha256_of_rest(std::istream& in) {
  std::array<char, 1 << 16> part; // fresh memory for larger ones costs more than their hash
  return hex([&] {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    return std::as_bytes(std::span(part).first(static_cast<std::size_t>(in.gcount())));
  });
}

std::string sha256_of_file(const std::string& file) {
  std::ifstream in = open_input(file, "input");
  std::string digest = sha256_of_rest(in);
  require_read(in, file, "input");
  return digest;
}

} // namespace bem_contact
