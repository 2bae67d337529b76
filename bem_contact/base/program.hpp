#pragma once

#include <filesystem>

namespace bem_contact {

/// Programs call it when they start: memory that is freed stays with the process, up to 512 MB, and the first
/// 256 MB come in large pages. Each case of a sequence needs what the one before has freed; given back and
/// fetched again it costs a tenth of the time, because the system clears every page. Without large pages
/// answers take up to 15 % longer (tools/BENCHMARKS.md, section 10). A library leaves this choice to its
/// program.
void keep_freed_memory();

/// The first thing a program does, so that what it is started with cannot end it without a word: closed
/// standard streams are held open, OpenBLAS has no threads where memory is limited (the program then begins
/// anew, with `argv`), and a write beyond the limit on the size of files becomes an error.
void begin_program(char** argv);

std::filesystem::path this_program(); ///< "": the system does not say

/// The last thing a program does: `code` if all that was printed has reached standard output. Otherwise (a
/// full disk) 1, with a message on standard error.
int checked_exit_code(int code);

} // namespace bem_contact
