#include "bem_contact/base/program.hpp"

#include "bem_contact/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string>
#include <system_error>

namespace bem_contact {

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
