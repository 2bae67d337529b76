#include "fem_influence/shared/memory.hpp"

#include <sys/resource.h>

#include <fstream>
#include <limits>
#include <string>

namespace bem_contact::fem {

namespace {
constexpr double kib_per_gib = 1024.0 * 1024.0;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / kib_per_gib;
}

double available_memory() {
  std::ifstream in("/proc/meminfo");
  for (std::string word; in >> word;)
    if (double kib = 0; word == "MemAvailable:" && in >> kib)
      return kib / kib_per_gib;
  return std::numeric_limits<double>::infinity();
}

} // namespace bem_contact::fem
