! Solves a scene for some forces and prints the largest pressure of each, in MPa.
module conformal_contact
  use, intrinsic :: iso_c_binding
  implicit none
  integer(c_int), parameter :: conformal_ok = 0, conformal_wrong_input = 2
  integer, parameter :: conformal_pmax = 8 + 1, conformal_totals_count = 13 ! arrays begin at 1 here
  interface
    integer(c_int) function conformal_open_file(scene, handle, message, size) bind(c)
      import
      character(kind=c_char), intent(in) :: scene(*)
      type(c_ptr), intent(out) :: handle
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int), value :: size
    end function
    integer(c_int) function conformal_key(handle, name, key) bind(c)
      import
      type(c_ptr), value :: handle
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), intent(out) :: key
    end function
    integer(c_int) function conformal_set_number(handle, key, number) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: key
      real(c_double), value :: number
    end function
    integer(c_int) function conformal_solve(handle) bind(c)
      import
      type(c_ptr), value :: handle
    end function
    integer(c_int) function conformal_totals(handle, totals, count) bind(c)
      import
      type(c_ptr), value :: handle
      real(c_double), intent(out) :: totals(*)
      integer(c_int), value :: count
    end function
    subroutine conformal_close(handle) bind(c)
      import
      type(c_ptr), value :: handle
    end subroutine
  end interface
end module

program client
  use conformal_contact
  implicit none
  type(c_ptr) :: contact
  character(kind=c_char) :: message(1000)
  character(len=500) :: scene
  real(c_double) :: totals(conformal_totals_count)
  integer(c_int) :: force
  integer :: i
  call get_command_argument(1, scene)
  if (conformal_open_file(trim(scene) // c_null_char, contact, message, 1000) /= conformal_ok) stop 1
  if (conformal_key(contact, "load.force" // c_null_char, force) /= conformal_ok) stop 2
  do i = 1, 3
    if (conformal_set_number(contact, force, 1d5 / i) /= conformal_ok) stop 3
    if (conformal_solve(contact) /= conformal_ok) stop 4
    if (conformal_totals(contact, totals, conformal_totals_count) /= conformal_ok) stop 5
    print '(es24.16)', totals(conformal_pmax)
  end do
  if (conformal_set_number(contact, force, -1d0) /= conformal_wrong_input) stop 6
  call conformal_close(contact)
end program
