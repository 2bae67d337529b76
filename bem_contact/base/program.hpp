#pragma once

namespace bem_contact {

/// Programs call it when they start: memory that is freed stays with the process, up to 512 MB, and the first
/// 256 MB come in large pages. Each case of a sequence needs what the one before has freed; given back and
/// fetched again it costs a tenth of the time, because the system clears every page. Large pages take a third
/// of the time of a first answer on 10,000 elements (tools/BENCHMARKS.md, section 10). A library leaves this
/// choice to its program.
void keep_freed_memory();

/// The first thing a program does. If standard input, output or error is closed, the next file that the
/// program opens would take its place, and messages would be written into that file. Whatever is closed is
/// held open in a way that lets no byte through: to write to a closed standard output stays an error.
void hold_standard_streams();

/// Programs call it before they need memory. OpenBLAS starts a thread for each core before main(), and where
/// memory is limited (`ulimit -v`) and short, these threads look for it for ever, also when the program ends.
/// Under such a limit the program begins anew without them; none of ours uses them.
void leave_blas_threads_where_memory_is_limited(char** argv);

/// A write beyond the limit on the size of files (ulimit -f) becomes an error that says so. Without this a
/// signal ends the program without a word.
void meet_file_size_limit();

/// The last thing a program does: `code` if all that was printed has reached standard output. Otherwise (a
/// full disk) 1, with a message on standard error.
int checked_exit_code(int code);

} // namespace bem_contact
