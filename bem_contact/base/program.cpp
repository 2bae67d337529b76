#include "bem_contact/base/program.hpp"

#include "bem_contact/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <system_error>
#include <unistd.h>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace bem_contact {

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_TRIM_THRESHOLD, 256 << 20); // bytes
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes, the most that glibc takes; a larger piece is given back
#endif
}

void hold_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      // The lowest free number is this one. Its wrong direction makes each use an error.
      static_cast<void>(open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

int checked_exit_code(int code) {
  errno = 0;
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return code;
  const std::string why = errno != 0 ? std::generic_category().message(errno) : "the disk may be full";
  const Error error("Standard output cannot be written", why,
                    "Do not use what was printed; check that the disk is not full, and run it again.");
  std::fputs(("error: " + std::string(error.what()) + "\n").c_str(), stderr);
  return 1;
}

} // namespace bem_contact
