#include "bem_contact/base/sha256_digest.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>

namespace bem_contact {

namespace {

constexpr std::size_t block_size = 64; ///< bytes
using Words = std::array<std::uint32_t, 64>;
__extension__ using Wide = unsigned __int128;

/// The first 32 bits behind the point of roots of the first 64 primes: FIPS 180-4, sections 4.2.2 and 5.3.3.
/// By whole numbers, because a double has too few digits.
template <int degree> constexpr Words bits_of_roots() {
  Words out{};
  std::size_t count = 0;
  for (unsigned prime = 2; count < out.size(); ++prime) {
    bool is_prime = true;
    for (unsigned by = 2; by * by <= prime; ++by)
      is_prime = is_prime && prime % by != 0;
    if (!is_prime)
      continue;
    Wide root = 0; // of prime 2^(32 degree)
    for (Wide bit = static_cast<Wide>(1) << 37; bit > 0; bit >>= 1) {
      const Wide more = root + bit;
      const Wide power = degree == 2 ? more * more : more * more * more;
      if (power <= static_cast<Wide>(prime) << (32 * degree))
        root = more;
    }
    out[count++] = static_cast<std::uint32_t>(root);
  }
  return out;
}

constexpr Words round_constants = bits_of_roots<3>(), square_roots = bits_of_roots<2>();

/// FIPS 180-4, section 6.2.2; names as there.
class Sha256 {
public:
  void block(const unsigned char* bytes) {
    Words w{};
    for (std::size_t t = 0; t < 16; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        w[t] = w[t] << 8 | bytes[4 * t + k];
    for (std::size_t t = 16; t < 64; ++t)
      w[t] = (std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10) + w[t - 7] +
             (std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3) + w[t - 16];
    auto [a, b, c, d, e, f, g, h] = hash_;
    for (std::size_t t = 0; t < 64; ++t) {
      const std::uint32_t first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                                  ((e & f) ^ (~e & g)) + round_constants[t] + w[t],
                          second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) +
                                   ((a & b) ^ (a & c) ^ (b & c));
      std::tie(a, b, c, d, e, f, g, h) = std::tuple(first + second, a, b, c, d + first, e, f, g);
    }
    const std::array<std::uint32_t, 8> more{a, b, c, d, e, f, g, h};
    for (std::size_t k = 0; k < 8; ++k)
      hash_[k] += more[k];
  }

  std::array<unsigned char, 32> bytes() const {
    std::array<unsigned char, 32> out{};
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = static_cast<unsigned char>(hash_[k / 4] >> (24 - 8 * (k % 4)));
    return out;
  }

private:
  std::array<std::uint32_t, 8> hash_ = [] {
    std::array<std::uint32_t, 8> first{};
    std::copy_n(square_roots.begin(), 8, first.begin());
    return first;
  }();
};

} // namespace

std::array<unsigned char, 32> sha256_digest(const std::function<std::span<const std::byte>()>& next) {
  Sha256 hash;
  std::array<unsigned char, 2 * block_size>
      open{}; // bytes that fill no block yet, and at the end what fills them up
  std::size_t held = 0;
  std::uint64_t bits = 0;
  for (auto piece = next(); !piece.empty(); piece = next()) {
    bits += 8 * static_cast<std::uint64_t>(piece.size());
    while (!piece.empty()) {
      const std::size_t taken = std::min(block_size - held, piece.size());
      std::transform(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(taken), &open[held],
                     [](std::byte b) { return static_cast<unsigned char>(b); });
      piece = piece.subspan(taken);
      if ((held += taken) == block_size) {
        hash.block(open.data());
        held = 0;
      }
    }
  }
  const std::size_t end = held < block_size - 8 ? block_size : open.size();
  std::fill(&open[held], open.data() + end, static_cast<unsigned char>(0));
  open[held] = 0x80;
  for (std::size_t k = 0; k < 8; ++k)
    open[end - 1 - k] = static_cast<unsigned char>(bits >> (8 * k));
  for (std::size_t at = 0; at < end; at += block_size)
    hash.block(&open[at]);
  return hash.bytes();
}

} // namespace bem_contact
