! SPDX-License-Identifier: GPL-3.0-or-later
! One contact by its groups: the minimum film with its place and error, and the film over X.
program example
  use, intrinsic :: iso_c_binding
  use ehd
  implicit none
  type(c_ptr) :: contact
  real(c_double) :: film, x, error
  real(c_double), allocatable :: H(:), nothing(:)
  integer(c_size_t) :: nodes

  if (ehd_solve_moes(20.0_c_double, 10.0_c_double, c_null_ptr, "fast" // c_null_char, 1e-4_c_double, contact) &
      /= ehd_ok) &
    call give_up()
  if (ehd_get(contact, "film.minimum.hertz" // c_null_char, film) /= ehd_ok) call give_up()
  if (ehd_get(contact, "film.minimum.x" // c_null_char, x) /= ehd_ok) call give_up()
  if (ehd_get(contact, "film.minimum.error" // c_null_char, error) /= ehd_ok) call give_up()
  print '(a, f8.6, a, f5.3, a, es7.1)', "minimum film ", film, " at X = ", x, ", relative error ", error

  allocate (nothing(0))
  nodes = ehd_field(contact, "H" // c_null_char, nothing, 0_c_size_t)
  allocate (H(nodes))
  nodes = ehd_field(contact, "H" // c_null_char, H, nodes)
  print '(a, i0, a, f8.6)', "the film at ", nodes, " nodes is nowhere below ", minval(H)
  call ehd_free(contact)

contains

  subroutine give_up()
    print '(a)', ehd_text(ehd_last_error())
    stop 1
  end subroutine
end program
