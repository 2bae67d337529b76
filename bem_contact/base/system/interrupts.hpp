#pragma once

#include <atomic>

namespace bem_contact::system {

/// From now on what interrupts this process (Ctrl-C, SIGTERM) first writes the note that `note` points to, if
/// there is one, to standard error, and then does what it would have done. Child processes write nothing.
void write_when_interrupted(const std::atomic<const char*>& note);
/// As before the last call of write_when_interrupted().
void write_no_more();

} // namespace bem_contact::system
