/* What this compiler's libstdc++ takes of a newer glibc than that of the portable program (linux.cmake). */
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

/* Glibc 2.32: nonzero while there is one thread. Zero is always safe, reference counts are then atomic. */
char __libc_single_threaded = 0;

/* Glibc 2.36, behind std::random_device. */
uint32_t arc4random(void) {
  uint32_t bits;
  if (getentropy(&bits, sizeof bits) != 0)
    abort();
  return bits;
}
