#pragma once

namespace bem_contact::app {

/// What the program does with a command line: reads it, runs its command, and prints what goes wrong on
/// standard error. Returns the exit code (command.hpp).
int run_program(int argc, char** argv);

} // namespace bem_contact::app
