#include "bem_contact/app/run_program.hpp"
#include "bem_contact/base/program.hpp"

int main(int argc, char** argv) {
  bem_contact::hold_standard_streams();
  bem_contact::leave_blas_threads_where_memory_is_limited(argv);
  bem_contact::meet_file_size_limit();
  bem_contact::keep_freed_memory();
  return bem_contact::checked_exit_code(bem_contact::app::run_program(argc, argv));
}
