#include "bem_contact/base/standard_streams.hpp"

#include "bem_contact/base/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string>
#include <system_error>

namespace bem_contact {

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
