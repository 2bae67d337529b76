#pragma once

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace bem_contact::system {

enum class CloseOthers { now, as_another_program_begins };

/// All that is open besides the standard streams is closed. It allocates nothing, so that a new child may
/// call it. Older systems have no close_range().
inline void close_others(CloseOthers when) {
  constexpr int first = STDERR_FILENO + 1;
  const bool now = when == CloseOthers::now;
#ifdef __NR_close_range
  constexpr unsigned close_on_exec = 4; // CLOSE_RANGE_CLOEXEC of linux/close_range.h
  if (syscall(__NR_close_range, first, ~0U, now ? 0U : close_on_exec) == 0)
    return;
#endif
  const long end = sysconf(_SC_OPEN_MAX);
  for (int file = first; file < end; ++file)
    if (now)
      close(file);
    else
      fcntl(file, F_SETFD, FD_CLOEXEC);
}

} // namespace bem_contact::system
