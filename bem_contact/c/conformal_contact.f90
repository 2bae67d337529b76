! conformal_contact.h for Fortran: the same functions with the same arguments. The header says what each is for.
! Compile this file with your own. Texts end with c_null_char. Indices of totals, axes and columns count from 0 as in C:
! add 1 for an array of Fortran.
module conformal_contact
  use, intrinsic :: iso_c_binding
  implicit none
  integer(c_int), parameter :: conformal_ok = 0, conformal_unforeseen = 1, conformal_wrong_input = 2, &
                               conformal_not_converged = 3, conformal_stopped = 4
  integer, parameter :: conformal_fx = 0, conformal_fy = 1, conformal_fz = 2, conformal_fs = 3, conformal_mz = 4, &
                        conformal_approach = 5, conformal_creepage_x = 6, conformal_creepage_s = 7, &
                        conformal_pmax = 8, conformal_area = 9, conformal_friction_power = 10, &
                        conformal_certificate = 11, conformal_discretisation = 12, conformal_totals_count = 13
  integer, parameter :: conformal_patch_values = 32, conformal_ellipse_values = 7
  interface
    function conformal_version() bind(c)
      import
      type(c_ptr) :: conformal_version
    end function
    integer(c_int) function conformal_open_file(scene_file, handle, message, size) bind(c)
      import
      character(kind=c_char), intent(in) :: scene_file(*)
      type(c_ptr), intent(out) :: handle
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int), value :: size
    end function
    integer(c_int) function conformal_open_text(toml, folder, handle, message, size) bind(c)
      import
      character(kind=c_char), intent(in) :: toml(*), folder(*)
      type(c_ptr), intent(out) :: handle
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int), value :: size
    end function
    subroutine conformal_close(handle) bind(c)
      import
      type(c_ptr), value :: handle
    end subroutine
    function conformal_message(handle) bind(c)
      import
      type(c_ptr), value :: handle
      type(c_ptr) :: conformal_message
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
    integer(c_int) function conformal_set_numbers(handle, key, numbers, count) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: key, count
      real(c_double), intent(in) :: numbers(*)
    end function
    integer(c_int) function conformal_set_text(handle, key, text) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: key
      character(kind=c_char), intent(in) :: text(*)
    end function
    integer(c_int) function conformal_solve(handle) bind(c)
      import
      type(c_ptr), value :: handle
    end function
    integer(c_int) function conformal_stop(handle) bind(c)
      import
      type(c_ptr), value :: handle
    end function
    integer(c_int) function conformal_totals(handle, totals, count) bind(c)
      import
      type(c_ptr), value :: handle
      real(c_double), intent(out) :: totals(*)
      integer(c_int), value :: count
    end function
    integer(c_int) function conformal_total_errors(handle, errors, count) bind(c)
      import
      type(c_ptr), value :: handle
      real(c_double), intent(out) :: errors(*)
      integer(c_int), value :: count
    end function
    integer(c_int) function conformal_number(handle, path, number) bind(c)
      import
      type(c_ptr), value :: handle
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), intent(inout) :: number
    end function
    integer(c_int) function conformal_model(handle, name, reason) bind(c)
      import
      type(c_ptr), value :: handle
      type(c_ptr), intent(out) :: name, reason
    end function
    integer(c_int) function conformal_why_no_errors(handle, text) bind(c)
      import
      type(c_ptr), value :: handle
      type(c_ptr), intent(out) :: text
    end function
    integer(c_int) function conformal_patch_count(handle, count) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), intent(out) :: count
    end function
    integer(c_int) function conformal_patch(handle, index, values, count) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: index, count
      real(c_double), intent(out) :: values(*)
    end function
    integer(c_int) function conformal_patch_errors(handle, index, errors, count) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: index, count
      real(c_double), intent(out) :: errors(*)
    end function
    integer(c_int) function conformal_grid(handle, mx, ms) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), intent(out) :: mx, ms
    end function
    integer(c_int) function conformal_array(handle, which, values, count) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: which, count
      real(c_double), intent(out) :: values(*)
    end function
    integer(c_int) function conformal_warning_count(handle, count) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), intent(out) :: count
    end function
    integer(c_int) function conformal_warning(handle, index, text) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_int), value :: index
      type(c_ptr), intent(out) :: text
    end function
    integer(c_int) function conformal_table_open(file, table, message, size) bind(c)
      import
      character(kind=c_char), intent(in) :: file(*)
      type(c_ptr), intent(out) :: table
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int), value :: size
    end function
    subroutine conformal_table_close(table) bind(c)
      import
      type(c_ptr), value :: table
    end subroutine
    integer(c_int) function conformal_table_size(table, axes, columns) bind(c)
      import
      type(c_ptr), value :: table
      integer(c_int), intent(out) :: axes, columns
    end function
    integer(c_int) function conformal_table_axis(table, index, name, unit, from, to) bind(c)
      import
      type(c_ptr), value :: table
      integer(c_int), value :: index
      type(c_ptr), intent(out) :: name, unit
      real(c_double), intent(out) :: from, to
    end function
    integer(c_int) function conformal_table_column(table, index, name, unit, error) bind(c)
      import
      type(c_ptr), value :: table
      integer(c_int), value :: index
      type(c_ptr), intent(out) :: name, unit
      real(c_double), intent(out) :: error
    end function
    integer(c_int) function conformal_table_find(table, name, column) bind(c)
      import
      type(c_ptr), value :: table
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), intent(out) :: column
    end function
    integer(c_int) function conformal_table_look_up(table, at, axes, values, errors, columns, message, size) bind(c)
      import
      type(c_ptr), value :: table
      real(c_double), intent(in) :: at(*)
      integer(c_int), value :: axes, columns, size
      real(c_double), intent(inout) :: values(*), errors(*)
      character(kind=c_char), intent(out) :: message(*)
    end function
    integer(c_int) function conformal_table_creep_forces(table, ellipse, forces, errors, message, size) bind(c)
      import
      type(c_ptr), value :: table
      real(c_double), intent(in) :: ellipse(7)
      real(c_double), intent(inout) :: forces(3), errors(3)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int), value :: size
    end function
  end interface
end module
