#include "bem_contact/app/run_program.hpp"
#include "bem_contact/base/program.hpp"

int main(int argc, char** argv) {
  bem_contact::begin_program(argv);
  bem_contact::keep_freed_memory();
  return bem_contact::checked_exit_code(bem_contact::app::run_program(argc, argv));
}
