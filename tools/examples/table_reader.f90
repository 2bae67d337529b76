! Looks forces up in a table of bem_contact: as table_reader.py, with the same arguments.
!     gfortran PREFIX/include/conformal_contact.f90 table_reader.f90 -o table_reader -lconformal_contact
program table_reader
  use conformal_contact
  implicit none
  character(2), parameter :: names(3) = ['Fx', 'Fy', 'Mz']
  character(kind=c_char) :: message(1000)
  character(500) :: word
  real(c_double) :: at(10), values(100), errors(100)
  integer(c_int) :: axes, columns, column, code, i
  type(c_ptr) :: table
  call get_command_argument(1, word)
  code = conformal_table_open(trim(word) // c_null_char, table, message, 1000)
  if (code == conformal_ok) code = conformal_table_size(table, axes, columns)
  do i = 2, command_argument_count()
    call get_command_argument(i, word)
    read (word, *) at(i - 1)
  end do
  if (code == conformal_ok .and. command_argument_count() == 1 + conformal_ellipse_values) then
    code = conformal_table_creep_forces(table, at, values, errors, message, 1000)
  else if (code == conformal_ok) then
    code = conformal_table_look_up(table, at, axes, values, errors, columns, message, 1000)
  end if
  if (code /= conformal_ok) print '(1000a)', message(:index(transfer(message, repeat(' ', 1000)), c_null_char) - 1)
  do i = 1, merge(3, 0, code == conformal_ok)
    if (conformal_table_find(table, names(i) // c_null_char, column) /= conformal_ok) cycle
    print '(2a, es24.16, a, es9.1)', names(i), ' ', values(column + 1), ' +-', errors(column + 1)
  end do
  if (code /= conformal_ok) stop 2
end program
