! Solves a scene for some forces and prints the largest pressure of each, in MPa.
program client
  use conformal_contact
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  type(c_ptr) :: contact
  character(kind=c_char) :: message(1000)
  character(len=500) :: scene
  real(c_double) :: totals(conformal_totals_count), errors(conformal_totals_count), pmax
  integer(c_int) :: force
  integer :: i
  call get_command_argument(1, scene)
  if (conformal_open_file(trim(scene) // c_null_char, contact, message, 1000) /= conformal_ok) stop 1
  if (conformal_key(contact, "load.force" // c_null_char, force) /= conformal_ok) stop 2
  do i = 1, 3
    if (conformal_set_number(contact, force, 1d5 / i) /= conformal_ok) stop 3
    if (conformal_solve(contact) /= conformal_ok) stop 4
    if (conformal_totals(contact, totals, conformal_totals_count) /= conformal_ok) stop 5
    if (conformal_total_errors(contact, errors, conformal_totals_count) /= conformal_ok) stop 7
    if (conformal_number(contact, "patches/0/pmax" // c_null_char, pmax) /= conformal_ok) stop 8
    if (pmax /= totals(1 + conformal_pmax)) stop 9
    if (conformal_number(contact, "patches/0/pmex" // c_null_char, pmax) /= conformal_wrong_input) stop 10
    print '(es24.16)', totals(1 + conformal_pmax)
    write (error_unit, '(a, es9.2, a)') '+-', errors(1 + conformal_pmax), ' MPa (NaN: none is stated)'
  end do
  if (conformal_set_number(contact, force, -1d0) /= conformal_wrong_input) stop 6
  call conformal_close(contact)
end program
