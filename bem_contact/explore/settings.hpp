#pragma once

#include <chrono>
#include <cstddef>

namespace bem_contact::explore {

/// Bytes of a request: a scene and the profiles that were dropped on the page. A profile of 10,000 points is
/// 0.3 MB. Chosen.
inline constexpr std::size_t largest_request = std::size_t(16) << 20;

/// Connections that are served at a time. A browser holds six open, and each stays for keep_open. Chosen for
/// four windows.
inline constexpr std::size_t most_connections = 24;
inline constexpr std::chrono::seconds keep_open{5}; ///< how long a connection waits for its next request

/// Windows whose newest question is remembered, so that it can replace the one before. Chosen.
inline constexpr std::size_t most_windows = 64;

} // namespace bem_contact::explore
