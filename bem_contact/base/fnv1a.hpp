#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace bem_contact {

/// The 64-bit FNV-1a hash, for digests that tell one input from another (not against forgery). Files carry
/// its values.
class Fnv1a {
public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte b : bytes)
      value_ = (value_ ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

} // namespace bem_contact
