! SPDX-License-Identifier: GPL-3.0-or-later
! libehd from Fortran 2003. Compile this file with your own compiler, and link with -lehd. Units, errors, ownership and
! threads: ehd/ehd.h. Texts that go in end with c_null_char; texts that come out are made by ehd_text.
module ehd
  use, intrinsic :: iso_c_binding
  implicit none
  public

  ! Return values.
  integer(c_int), parameter :: ehd_ok = 0, ehd_not_met = 1, ehd_bad_input = 2
  ! How one of several contacts ended.
  integer(c_int), parameter :: ehd_converged = 0, ehd_tolerance_not_met = 1, ehd_under_resolved = 2, &
                               ehd_limit_reached = 3, ehd_diverged = 4

  interface
    type(c_ptr) function ehd_version() bind(c)
      import :: c_ptr
    end function

    type(c_ptr) function ehd_last_error() bind(c)
      import :: c_ptr
    end function

    integer(c_int) function ehd_solve(case_toml, solver, tolerance, result) bind(c)
      import :: c_char, c_double, c_int, c_ptr
      character(kind=c_char), intent(in) :: case_toml(*), solver(*)
      real(c_double), value :: tolerance
      type(c_ptr), intent(out) :: result
    end function

    ! lubricant_toml: c_loc of a text, or c_null_ptr.
    integer(c_int) function ehd_solve_moes(M, L, lubricant_toml, solver, tolerance, result) bind(c)
      import :: c_char, c_double, c_int, c_ptr
      real(c_double), value :: M, L, tolerance
      type(c_ptr), value :: lubricant_toml
      character(kind=c_char), intent(in) :: solver(*)
      type(c_ptr), intent(out) :: result
    end function

    integer(c_int) function ehd_bearing(case_toml, law, result) bind(c)
      import :: c_char, c_int, c_ptr
      character(kind=c_char), intent(in) :: case_toml(*), law(*)
      type(c_ptr), intent(out) :: result
    end function

    integer(c_int) function ehd_get(result, path, value) bind(c)
      import :: c_char, c_double, c_int, c_ptr
      type(c_ptr), value :: result
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), intent(inout) :: value
    end function

    integer(c_size_t) function ehd_field(result, name, buffer, length) bind(c)
      import :: c_char, c_double, c_ptr, c_size_t
      type(c_ptr), value :: result
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), intent(out) :: buffer(*)
      integer(c_size_t), value :: length
    end function

    type(c_ptr) function ehd_json(result) bind(c)
      import :: c_ptr
      type(c_ptr), value :: result
    end function

    subroutine ehd_free(result) bind(c)
      import :: c_ptr
      type(c_ptr), value :: result
    end subroutine

    integer(c_int) function ehd_films(n, M, L, lubricant_toml, tolerance, threads, minimum, minimum_error, central, &
                                      central_error, status) bind(c)
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: M(*), L(*)
      type(c_ptr), value :: lubricant_toml
      real(c_double), value :: tolerance
      integer(c_int), value :: threads
      real(c_double), intent(inout) :: minimum(*), minimum_error(*), central(*), central_error(*)
      integer(c_int), intent(inout) :: status(*)
    end function

    integer(c_int) function ehd_law(bearing, raceway, n, approach_m, force_N, stiffness_N_per_m) bind(c)
      import :: c_char, c_double, c_int, c_ptr, c_size_t
      type(c_ptr), value :: bearing
      character(kind=c_char), intent(in) :: raceway(*)
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: approach_m(*)
      real(c_double), intent(inout) :: force_N(*), stiffness_N_per_m(*)
    end function

    ! callback: c_funloc of a function (real(c_double), value; type(c_ptr), value) -> integer(c_int), or c_null_funptr.
    subroutine ehd_set_progress(callback, user) bind(c)
      import :: c_funptr, c_ptr
      type(c_funptr), value :: callback
      type(c_ptr), value :: user
    end subroutine

    integer(c_size_t) function ehd_text_length(text) bind(c, name="strlen")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
    end function
  end interface

contains

  ! A text that the library returns; empty for a null pointer.
  function ehd_text(text) result(copy)
    type(c_ptr), intent(in) :: text
    character(kind=c_char, len=:), allocatable :: copy
    character(kind=c_char), pointer :: letters(:)
    integer :: i
    if (.not. c_associated(text)) then
      copy = ""
      return
    end if
    call c_f_pointer(text, letters, [ehd_text_length(text)])
    allocate (character(len=size(letters)) :: copy)
    do i = 1, size(letters)
      copy(i:i) = letters(i)
    end do
  end function

end module
