! SPDX-License-Identifier: GPL-3.0-or-later
! One contact by its groups: minimum film, its error, and the place of the largest pressure.
program example
  use, intrinsic :: iso_c_binding
  use ehd
  implicit none
  type(c_ptr) :: contact
  real(c_double) :: film, error, x
  real(c_double), allocatable :: P(:), none(:)
  integer(c_size_t) :: nodes

  allocate (none(0))
  select case (ehd_solve_moes(20.0_c_double, 10.0_c_double, c_null_ptr, "fast" // c_null_char, 1e-4_c_double, contact))
  case (ehd_ok)
    nodes = ehd_field(contact, "P" // c_null_char, none, 0_c_size_t)
    allocate (P(nodes))
    nodes = ehd_field(contact, "P" // c_null_char, P, nodes)
    if (ehd_get(contact, "film.minimum.hertz" // c_null_char, film) /= ehd_ok) stop 1
    if (ehd_get(contact, "film.minimum.error" // c_null_char, error) /= ehd_ok) stop 1
    if (ehd_get(contact, "pressure.maximum.x" // c_null_char, x) /= ehd_ok) stop 1
    print '(a, f8.6, a, es7.1)', "minimum film ", film, ", relative error ", error
    print '(a, f6.3, a, i0, a, f6.4)', "largest pressure at X = ", x, "; ", size(P), " nodes, largest P ", maxval(P)
    call ehd_free(contact)
  case default
    print '(a)', ehd_text(ehd_last_error())
    stop 1
  end select
end program
