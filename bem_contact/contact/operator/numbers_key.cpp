#include "bem_contact/contact/operator/numbers_key.hpp"

#include <array>
#include <bit>
#include <span>

namespace bem_contact::contact {
namespace {

/// Four interleaved chains of multiplications, so that reading the values is what takes the time.
std::uint64_t digest_of(std::span<const double> values) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15U; // 2^64 over the golden ratio
  std::array<std::uint64_t, 4> chain{1, 2, 3, 4};
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t& c = chain[i % 4];
    c = (std::rotl(c, 29) ^ std::bit_cast<std::uint64_t>(values[i])) * odd;
  }
  std::uint64_t digest = values.size();
  for (const std::uint64_t c : chain)
    digest = (std::rotl(digest, 29) ^ c) * odd;
  return digest;
}

} // namespace

NumbersKey key_of(const ContactProblem& problem) {
  const InfluenceNumbers& a = problem.numbers;
  return {problem.grid.mx,    problem.grid.ms, a.offsets, a.rows, a.translational, a.dx, a.ds,
          digest_of(a.values)};
}

} // namespace bem_contact::contact
