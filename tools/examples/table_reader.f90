! Reads a table of bem_contact as plain text (bem_contact table --text) and interpolates in it: as table_reader.py, with
! the same arguments. Text, because the modules of HDF5 for Fortran fit only the compiler that made them.
!     gfortran table_reader.f90 -o table_reader
module table_reader
  implicit none
  integer, parameter :: dp = kind(1d0)
  type :: line
    real(dp), allocatable :: values(:)
  end type
  type :: table
    type(line), allocatable :: axes(:), columns(:) ! in the order of the file: Fx, Fy, Mz of a creep table
    character(40), allocatable :: names(:)
    real(dp), allocatable :: scale(:, :) ! log10(a/b), C11, C22, C23
  end type
contains
  function read_table(file) result(t)
    character(*), intent(in) :: file
    type(table) :: t
    character(40) :: name, unit
    real(dp) :: error
    integer :: u, i, axes, columns, scales
    integer, allocatable :: n(:)
    open (newunit=u, file=file, action='read')
    read (u, *) name
    read (u, *) axes, columns, scales
    allocate (n(axes), t%axes(axes), t%columns(columns), t%names(columns), t%scale(4, scales))
    read (u, *) n
    do i = 1, axes
      allocate (t%axes(i)%values(n(i)))
      read (u, *) name, unit, t%axes(i)%values
    end do
    do i = 1, columns
      allocate (t%columns(i)%values(product(n)))
      read (u, *) t%names(i), unit, error, t%columns(i)%values
    end do
    if (scales > 0) read (u, *) t%scale
    close (u)
  end function

  ! Cubic in each coordinate, by the slopes of parabolas through three points; constant beyond the ends. The last axis
  ! runs fastest. Begin with axis 1 and index 0.
  recursive real(dp) function value(axes, values, at, axis, index) result(v)
    type(line), intent(in) :: axes(:)
    real(dp), intent(in) :: values(:), at(:)
    integer, intent(in) :: axis, index
    integer :: i, n
    real(dp) :: h, k, share, low, high, chord, first, last
    if (axis > size(axes)) then
      v = values(index + 1)
      return
    end if
    associate (x => axes(axis)%values)
      n = size(x)
      i = min(max(count(x <= at(axis)), 1), n - 1)
      h = x(i + 1) - x(i)
      share = min(max((at(axis) - x(i)) / h, 0d0), 1d0)
      low = point(i)
      high = point(i + 1)
      chord = (high - low) / h
      first = chord
      last = chord
      if (i > 1) then
        k = x(i) - x(i - 1)
        first = (h * (low - point(i - 1)) / k + k * chord) / (h + k)
      end if
      if (i < n - 1) then
        k = x(i + 2) - x(i + 1)
        last = (k * chord + h * (point(i + 2) - high) / k) / (h + k)
      end if
    end associate
    if (i == 1) first = 2 * chord - last
    if (i == n - 1) last = 2 * chord - first
    v = low + share * h * (chord + (1 - share) * ((first - chord) * (1 - share) - (last - chord) * share))
  contains
    recursive real(dp) function point(j)
      integer, intent(in) :: j
      point = value(axes, values, at, axis + 1, index * n + j - 1)
    end function
  end function

  ! Fx, Fy (N) and Mz (N mm) on the rail; q: a, b (mm), G (MPa), mu N (N), xi, eta, phi (1/mm).
  function creep_forces(t, q) result(f)
    type(table), intent(in) :: t
    real(dp), intent(in) :: q(7)
    real(dp) :: f(3), k(3), at(4), c, unit, x, y, z, w, sign_y, share
    integer :: i
    at(1) = log10(q(1) / q(2))
    c = sqrt(q(1) * q(2))
    i = min(max(count(t%scale(1, :) <= at(1)), 1), size(t%scale, 2) - 1) ! Kalker's coefficients: linear
    share = min(max((at(1) - t%scale(1, i)) / (t%scale(1, i + 1) - t%scale(1, i)), 0d0), 1d0)
    k = (1 - share) * t%scale(2:4, i) + share * t%scale(2:4, i + 1)
    unit = q(3) * c**2 / q(4)
    sign_y = merge(-1d0, 1d0, q(6) < 0)
    x = unit * k(1) / 3 * abs(q(5))
    y = sign_y * unit * k(2) / 3 * q(6)
    z = sign_y * unit * c * k(3) * q(7)
    w = norm2([x, y, z])
    at(2:4) = [atan2(hypot(y, z), x), atan2(z, y), w / (1 + w)]
    f = [(value(t%axes, t%columns(i)%values, at, 1, 0), i=1, 3)]
    f = f * q(4) * [sign(1d0, q(5)), sign_y, sign_y * c]
  end function
end module

program main
  use table_reader
  implicit none
  type(table) :: t
  character(1000) :: word
  real(dp) :: numbers(7) = 0
  integer :: i, column
  call get_command_argument(1, word)
  t = read_table(trim(word))
  do i = 2, command_argument_count()
    call get_command_argument(i, word)
    read (word, *) numbers(i - 1)
  end do
  if (size(t%scale) > 0) then
    write (*, '(3g24.12)') creep_forces(t, numbers)
  else
    do column = 1, size(t%names)
      if (any(t%names(column) == ['Fx', 'Fy', 'Mz'])) &
        write (*, '(g24.12)') value(t%axes, t%columns(column)%values, numbers(:size(t%axes)), 1, 0)
    end do
  end if
end program
