#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Says whether there is something of that name, and whether it is a regular file. False, not an exception,
/// for a name that is too long or a link that leads back to itself.
bool file_exists(const std::filesystem::path& file);
bool is_regular(const std::filesystem::path& file);
/// ".csv" of "Runs/A.CSV"; "" of a name without an ending.
std::string lower_ending(const std::filesystem::path& file);

/// Throws InputError for what cannot be read to an end: nothing of that name, a folder, a device, a socket.
/// Pipes may be read. `what` names the file in the message.
void require_readable(const std::string& file, std::string_view what);

/// Opens a file of bytes. Throws InputError where it cannot.
std::ifstream open_input(const std::string& file, std::string_view what);
/// Throws InputError where reading `in` to its end has failed.
void require_read(const std::istream& in, const std::string& file, std::string_view what);

/// bytes. A text for people is never larger: ten million points take 100 bytes each.
inline constexpr std::size_t largest_text = 1'000'000'000;

/// Three bytes that say that a text is UTF-8. Excel puts them in front of each CSV file, and no editor shows
/// them.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// The whole content of a file, byte by byte. Throws InputError when it cannot be read, or has more than
/// `most` bytes; `what` names it there.
std::string read_bytes(const std::string& file, std::string_view what, std::size_t most = largest_text);
/// The same of a text, without a byte order mark.
std::string read_text_file(const std::string& file, std::string_view what, std::size_t most = largest_text);

/// The points y z of a profile that this project wrote, one in each line.
std::vector<Point2> read_points(const std::filesystem::path& file);

} // namespace bem_contact
