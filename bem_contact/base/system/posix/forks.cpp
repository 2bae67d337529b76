#include "bem_contact/base/system/forks.hpp"

#include <pthread.h>

namespace bem_contact::system {

void watch_forks(void (*before)(), void (*here)(), void (*in_copy)()) {
  pthread_atfork(before, here, in_copy);
}

} // namespace bem_contact::system
