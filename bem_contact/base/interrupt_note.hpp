#pragma once

#include <cstddef>
#include <string>

namespace bem_contact {

/// What a long computation says when Ctrl-C (SIGINT) or SIGTERM ends it: how much is done, and how to go on.
/// While the object lives, such a signal first writes the note to standard error, and then does what it would
/// have done. One object at a time; child processes write nothing.
class InterruptNote {
public:
  /// `what` is counted, as in "cases"; `how_to_go_on` is a sentence.
  InterruptNote(std::string what, std::string how_to_go_on);
  ~InterruptNote();
  InterruptNote(const InterruptNote&) = delete;
  InterruptNote& operator=(const InterruptNote&) = delete;

  void done(std::size_t count, std::size_t total);

private:
  std::string what_, how_to_go_on_;
};

} // namespace bem_contact
