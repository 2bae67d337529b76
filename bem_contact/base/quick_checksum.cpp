#include "bem_contact/base/quick_checksum.hpp"

#include <array>
#include <fmt/format.h>
#include <istream>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace bem_contact {
namespace {

/// What XXH3 keeps between two parts.
class Sum {
public:
  explicit Sum(std::string_view first) {
    XXH3_128bits_reset(&state_);
    add(std::as_bytes(std::span(first)));
  }

  void add(std::span<const std::byte> part) { XXH3_128bits_update(&state_, part.data(), part.size()); }

  std::string text() const {
    const XXH128_hash_t sum = XXH3_128bits_digest(&state_);
    return fmt::format("{:016x}{:016x}", sum.high64, sum.low64);
  }

private:
  XXH3_state_t state_;
};

} // namespace

std::string quick_checksum(std::string_view text, std::span<const std::byte> following) {
  Sum sum(text);
  sum.add(following);
  return sum.text();
}

std::string quick_checksum(std::string_view text, std::istream& following) {
  Sum sum(text);
  std::array<char, 1 << 16> part; // fresh memory for larger ones costs more than their sum
  do {
    following.read(part.data(), static_cast<std::streamsize>(part.size()));
    sum.add(std::as_bytes(std::span(part).first(static_cast<std::size_t>(following.gcount()))));
  } while (following);
  return sum.text();
}

} // namespace bem_contact
