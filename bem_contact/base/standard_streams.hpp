#pragma once

namespace bem_contact {

/// The first thing a program does. If standard input, output or error is closed, the next file that the
/// program opens would take its place, and messages would be written into that file. Whatever is closed is
/// held open in a way that lets no byte through: to write to a closed standard output stays an error.
void hold_standard_streams();

/// The last thing a program does: `code` if all that was printed has reached standard output. Otherwise (a
/// full disk) 1, with a message on standard error.
int checked_exit_code(int code);

} // namespace bem_contact
