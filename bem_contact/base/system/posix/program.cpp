#include "bem_contact/base/program.hpp"

#include "bem_contact/base/large_table.hpp"
#include "bem_contact/base/system/memory.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/resource.h>
#include <system_error>
#include <unistd.h>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace bem_contact {

namespace {

/// Bytes. The heap of a case on 50,000 elements with half-space numbers takes 100 MB. What is reserved is
/// only addresses; what is kept is more, or the end of the reserve would be given back. Chosen.
constexpr std::size_t reserved = std::size_t(256) << 20;
constexpr std::size_t kept = 2 * reserved; ///< bytes, as above
constexpr int usual_top_pad = 128 << 10;   ///< bytes, as mallopt(3) has it
constexpr int largest_piece = 32 << 20;    ///< bytes, the most that glibc takes

/// Asks for large pages on a heap that hardly anyone has touched yet. The first touch of a page costs a
/// change to the kernel and back; large ones cost a hundredth of that for each byte. Nothing is used before
/// it is touched, and where large pages cannot be had all is as before.
void reserve_large_pages() {
#ifdef M_TOP_PAD
  const auto heap_end = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  // A large page that is touched before it is asked for stays small. So one piece, which is never used nor
  // given back, reaches up to the first of them. What malloc() notes of the rest lies before it, too.
  constexpr std::uintptr_t note = 4096;
  const std::uintptr_t begin = (heap_end() + usual_top_pad + 3 * note) / large_page * large_page + large_page;
  mallopt(M_TOP_PAD, static_cast<int>(reserved)); // the heap grows by so much beyond what is asked for
  [[maybe_unused]] static void* volatile unused =
      std::malloc(begin - heap_end() - note); // volatile: or it is left out
  mallopt(M_TOP_PAD, usual_top_pad);
  const std::uintptr_t end = heap_end() / large_page * large_page;
  if (end > begin)
    system::ask_for_large_pages(reinterpret_cast<void*>(begin), end - begin);
#endif
}

/// If standard input, output or error is closed, the next file that the program opens would take its place,
/// and messages would be written into that file. Whatever is closed is held open in a way that lets no byte
/// through: to write to a closed standard output stays an error.
void hold_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      // The lowest free number is this one. Its wrong direction makes each use an error.
      static_cast<void>(open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

/// OpenBLAS starts a thread for each core before main(), and where memory is limited (`ulimit -v`) and short,
/// these threads look for it for ever, also when the program ends. Under such a limit the program begins anew
/// without them; none of ours uses them.
void leave_blas_threads_where_memory_is_limited(char** argv) {
  const auto limited = [](decltype(RLIMIT_AS) resource) {
    rlimit limit{};
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  };
  constexpr const char* threads = "OPENBLAS_NUM_THREADS";
  const char* now = std::getenv(threads);
  if ((!limited(RLIMIT_AS) && !limited(RLIMIT_DATA)) || (now && std::string_view(now) == "1"))
    return;
  const std::filesystem::path program = this_program();
  if (!program.empty() && setenv(threads, "1", 1) == 0)
    execv(program.c_str(), argv); // where that fails, all is as before
}

/// A write beyond the limit on the size of files (ulimit -f) becomes an error that says so. Without this a
/// signal ends the program without a word.
void meet_file_size_limit() {
  std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace

std::filesystem::path this_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
}

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_TRIM_THRESHOLD, static_cast<int>(kept));
  mallopt(M_MMAP_THRESHOLD, largest_piece); // a larger piece is given back
#endif
  reserve_large_pages();
}

void begin_program(char** argv) {
  hold_standard_streams();
  leave_blas_threads_where_memory_is_limited(argv);
  meet_file_size_limit();
}

} // namespace bem_contact
