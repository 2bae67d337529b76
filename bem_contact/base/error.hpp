#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// An error a user can act on. what() reads "<problem> (<why it is one>) <what to do>". If it is neither of
/// the classes below, the machine is to blame and not the input: a disk that gets full while a file is
/// written, a process that cannot be started. Programs exit with 1.
class Error : public std::runtime_error {
public:
  /// The three parts of what(): "<problem> (<why>) <what to do>".
  Error(std::string_view problem, std::string_view why, std::string_view what_to_do);
  /// What what() of another one said, perhaps in another process, and what it belongs to.
  explicit Error(const std::string& whole) : std::runtime_error(whole) {}
};

/// The input is wrong: a file, a key, a value, or two inputs that do not fit. Programs exit with 2.
class InputError : public Error {
public:
  using Error::Error; ///< as Error
};

/// The input is fine and no certified solution was found within the bounds. Programs exit with 3.
class ConvergenceError : public Error {
public:
  using Error::Error; ///< as Error
};

/// The candidates most like `word`, best first, at most `most` of them; none that is hardly like it.
std::vector<std::string> nearest_names(std::string_view word, std::span<const std::string> candidates,
                                       std::size_t most = 3);

} // namespace bem_contact
