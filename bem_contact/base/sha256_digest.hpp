#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

namespace bem_contact {

/// For sha256.cpp: the digest of all pieces that `next` gives, up to an empty one. One of two sources makes
/// it: sha256_openssl.cpp, or sha256_alone.cpp, which needs no library.
std::array<unsigned char, 32> sha256_digest(const std::function<std::span<const std::byte>()>& next);

} // namespace bem_contact
