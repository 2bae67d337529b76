#pragma once

#include <chrono>
#include <cstddef>

namespace bem_contact::explore {

/// Bytes of a request: a scene and the profiles that were dropped on the page. A profile of 10,000 points is
/// 0.3 MB. Chosen.
inline constexpr std::size_t largest_request = std::size_t(16) << 20;

/// Bytes that are taken from a connection at once. Chosen: a request without profiles is not longer.
inline constexpr std::size_t read_at_once = std::size_t(16) << 10;

/// Connections that are served at a time, a thread each, and those that wait for their turn. A browser holds
/// six open, and each stays for keep_open. When all are taken, a new one takes the place of the oldest that
/// has not shown the token, so that whoever does not know it keeps nobody out. Chosen for ten windows.
inline constexpr std::size_t most_connections = 64;
inline constexpr int most_waiting = 512;
inline constexpr std::chrono::seconds keep_open{5}; ///< how long a connection waits for its next request
/// The whole time of a request until it has shown the token, until it has been read, and of its answer's way
/// back. All of it stays on this machine. Chosen.
inline constexpr std::chrono::seconds to_show_token{2}, to_be_read{30}, to_be_written{60};

/// Bytes of the profiles that were dropped on the page and are kept as files: those used last. Chosen.
inline constexpr std::size_t most_dropped = std::size_t(256) << 20;

/// mm. Room of a strip of influence functions beyond the contact by the half-space, on either side: finite
/// elements and friction move the contact by less, and a slider may be moved a little. Chosen.
inline constexpr double strip_room = 2.0;
/// 1. Error of these influence numbers that is asked for: that of the coarse bodies of data/bodies, with
/// which the pressure is off by less than 0.1 %, and two bodies take a minute.
inline constexpr double body_tolerance = 1e-2;

/// Windows whose newest question is remembered, so that it can replace the one before. Chosen.
inline constexpr std::size_t most_windows = 64;

} // namespace bem_contact::explore
