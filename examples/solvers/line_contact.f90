! SPDX-License-Identifier: GPL-3.0-or-later
! A deliberately simple solver of the line contact, to start your own from: the equations of line_contact.py in Fortran.
! Finite differences on an equal grid, Newton's method with a dense matrix, no library.
!
!   gfortran -O2 line_contact.f90 -o line_contact
!   line_contact CASE.json OUT.json TOLERANCE          for ehd compare --external, {case} {out} {tolerance}
!
! The inlet has to be cut. Exit code: 0 the tolerance is met, 1 it is not, 2 the case cannot be read or is not for this
! program.
module contact
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp), parameter :: pi = acos(-1d0)
  character(len=16) :: viscosity, density
  real(dp) :: lambda, alpha, p0, z, a, c
contains
  ! ln(eta/eta_0) and rho/rho_0 with their slopes; alpha p_H is `share` of the case's.
  elemental subroutine laws(P, share, eta, eta_P, rho, rho_P)
    real(dp), intent(in) :: P, share
    real(dp), intent(out) :: eta, eta_P, rho, rho_P
    eta = 0; eta_P = 0; rho = 1; rho_P = 0
    if (viscosity == 'barus') then
      eta = share*alpha*P; eta_P = share*alpha
    else if (viscosity == 'roelands') then
      eta = share*alpha*p0/z*((1 + P/p0)**z - 1); eta_P = share*alpha*(1 + P/p0)**(z - 1)
    end if
    if (density /= 'incompressible') then
      rho = 1 + a*P/(1 + c*P); rho_P = a/(1 + c*P)**2
    end if
  end subroutine

  ! A x = b by Gauss' elimination with row exchange; b becomes x.
  subroutine eliminate(A, b)
    real(dp), intent(inout) :: A(:, :), b(:)
    real(dp) :: row(size(b)), one
    integer :: i, k, m
    m = size(b)
    do k = 1, m
      i = k - 1 + maxloc(abs(A(k:, k)), 1)
      row = A(k, :); A(k, :) = A(i, :); A(i, :) = row
      one = b(k); b(k) = b(i); b(i) = one
      do i = k + 1, m
        A(i, k) = A(i, k)/A(k, k)
        b(i) = b(i) - A(i, k)*b(k)
      end do
      do i = k + 1, m
        A(k + 1:, i) = A(k + 1:, i) - A(k + 1:, k)*A(k, i)
      end do
    end do
    do k = m, 1, -1
      b(k) = (b(k) - dot_product(A(k, k + 1:), b(k + 1:)))/A(k, k)
    end do
  end subroutine

  ! Pressure and offset H_0 on the grid X(0:n), from a start. P is 0 behind the exit.
  subroutine newton(n, X, P, H_0, H, lam, share, found)
    integer, intent(in) :: n
    real(dp), intent(in) :: X(0:n), lam, share
    real(dp), intent(inout) :: P(0:n), H_0
    real(dp), intent(out) :: H(0:n)
    logical, intent(out) :: found
    real(dp), dimension(0:n) :: eta, eta_P, rho, rho_P, e, F
    real(dp) :: K(0:n, 0:n), F_P(0:n - 1, 0:n + 1), edge(-n:n + 1), h1, slope, mean, largest
    real(dp), allocatable :: J(:, :), b(:)
    integer :: i, m, last, iteration
    h1 = X(1) - X(0)
    edge = [((i - 0.5d0)*h1, i=-n, n + 1)]
    edge = edge*log(abs(edge)) - edge
    do i = 0, n
      do m = 0, n
        K(i, m) = -(edge(i - m + 1) - edge(i - m))/pi
      end do
    end do
    found = .false.
    do iteration = 1, 60
      call laws(P, share, eta, eta_P, rho, rho_P)
      H = H_0 + X**2/2 + matmul(K, P)
      e = rho*H**3*exp(-eta)/lam
      do i = 0, n - 1  ! faces: the flow and its derivatives to P(0:n) and H_0 (column n + 1)
        slope = (P(i + 1) - P(i))/h1
        mean = (e(i) + e(i + 1))/2
        F(i) = mean*slope
        F_P(i, 0:n) = slope*(3*e(i)/H(i)*K(i, :) + 3*e(i + 1)/H(i + 1)*K(i + 1, :))/2
        F_P(i, n + 1) = slope*(3*e(i)/H(i) + 3*e(i + 1)/H(i + 1))/2
        F_P(i, i) = F_P(i, i) + slope*e(i)*(rho_P(i)/rho(i) - eta_P(i))/2 - mean/h1
        F_P(i, i + 1) = F_P(i, i + 1) + slope*e(i + 1)*(rho_P(i + 1)/rho(i + 1) - eta_P(i + 1))/2 + mean/h1
        call wedge(i, merge(0.5d0, 1.5d0, i == 0))  ! upwind: 1.5 f_i - 0.5 f_(i-1)
        call wedge(merge(1, i - 1, i == 0), merge(0.5d0, -0.5d0, i == 0))
      end do
      last = n - 1
      do while (last > 1 .and. P(last) <= 0)
        last = last - 1
      end do
      if (last < n - 1) then
        if (F(last + 1) - F(last) > 0) last = last + 1
      end if
      allocate (J(last + 1, last + 1), b(last + 1))
      J(:last, :last) = F_P(1:last, 1:last) - F_P(0:last - 1, 1:last)
      J(:last, last + 1) = F_P(1:last, n + 1) - F_P(0:last - 1, n + 1)
      J(last + 1, :last) = h1
      J(last + 1, last + 1) = 0
      b = -[F(1:last) - F(0:last - 1), h1*sum(P) - pi/2]
      call eliminate(J, b)
      largest = maxval(abs(b(:last)))
      P(1:last) = P(1:last) + min(1d0, 0.3d0/largest)*b(:last)
      H_0 = H_0 + min(1d0, 0.3d0/largest)*b(last + 1)
      P(last + 1:) = 0
      deallocate (J, b)
      do i = 1, n
        if (X(i) > 0 .and. P(i) < 0) then
          P(i:) = 0
          exit
        end if
      end do
      P = max(P, 0d0)
      if (largest < 1d-9) then
        H = H_0 + X**2/2 + matmul(K, P)
        found = .true.
        return
      end if
    end do
  contains
    subroutine wedge(at, weight)  ! takes weight * rho H of a node from face i
      integer, intent(in) :: at
      real(dp), intent(in) :: weight
      F(i) = F(i) - weight*rho(at)*H(at)
      F_P(i, 0:n) = F_P(i, 0:n) - weight*rho(at)*K(at, :)
      F_P(i, at) = F_P(i, at) - weight*rho_P(at)*H(at)
      F_P(i, n + 1) = F_P(i, n + 1) - weight*rho(at)
    end subroutine
  end subroutine

  ! The smallest film, by a parabola, and the film at X = 0, by a cubic through four nodes.
  function films(n, X, H) result(both)
    integer, intent(in) :: n
    real(dp), intent(in) :: X(0:n), H(0:n)
    real(dp) :: both(2), weight
    integer :: i, j, at
    at = minloc(H, 1, abs(X) < 1.3d0) - 1
    both(1) = H(at) - (H(at - 1) - H(at + 1))**2/(8*(H(at - 1) - 2*H(at) + H(at + 1)))
    at = count(X < 0) - 2
    both(2) = 0
    do i = at, at + 3
      weight = 1
      do j = at, at + 3
        if (j /= i) weight = weight*(0 - X(j))/(X(i) - X(j))
      end do
      both(2) = both(2) + weight*H(i)
    end do
  end function
end module

program line_contact
  use contact
  implicit none
  integer, parameter :: coarsest = 128, finest = 1024, steps = 12
  character(len=:), allocatable :: text
  character(len=512) :: case_file, out_file, word
  real(dp) :: tolerance, inlet, H_0, error, now(2), before(2), first
  real(dp), allocatable :: X(:), P(:), H(:), start(:)
  integer :: n, i, k
  logical :: found

  call get_command_argument(1, case_file)
  call get_command_argument(2, out_file)
  call get_command_argument(3, word)
  read (word, *) tolerance
  call read_text(trim(case_file))
  if (index(text, '"flooded"') > 0 .or. index(text, '"lambda"') == 0) then
    write (0, '(a)') 'line_contact: the inlet is not cut; required is a case with a number for its inlet'
    stop 2, quiet=.true.
  end if
  viscosity = word_after('"law"', index(text, '"viscosity"'))
  density = word_after('"law"', index(text, '"density"'))
  if (all(viscosity /= [character(len=16) :: 'isoviscous', 'barus', 'roelands'])) then
    write (0, '(a)') 'line_contact: the viscosity law is unknown; required is isoviscous, barus or roelands'
    stop 2, quiet=.true.
  end if
  lambda = number('"lambda"'); alpha = number('"alpha_p_H"'); inlet = number('"inlet"')
  p0 = number('"p0_over_p_H"'); z = number('"z"'); a = number('"density_a"'); c = number('"density_c"')

  n = coarsest
  error = huge(error)
  before = huge(error)
  do while (n <= finest .and. error > tolerance)
    allocate (X(0:n), H(0:n), start(0:n))
    X = [(inlet + (1.6d0 - inlet)*i/n, i=0, n)]
    if (n == coarsest) then
      start = sqrt(max(1 - X**2, 0d0)); H_0 = 1
      first = max(lambda, 0.5d0)
      do k = 0, steps - 1  ! from a thick film of an oil without pressure dependence to the case
        call newton(n, X, start, H_0, H, first*(lambda/first)**(k/(steps - 1d0)), k/(steps - 1d0), found)
      end do
    else
      start(0:n:2) = P
      start(1:n - 1:2) = (P(0:n/2 - 1) + P(1:n/2))/2
      call newton(n, X, start, H_0, H, lambda, 1d0, found)
    end if
    if (.not. found) then
      write (0, '(a)') 'line_contact: Newton''s method did not converge'
      stop 1, quiet=.true.
    end if
    now = films(n, X, H)
    error = min(maxval(abs(now/before - 1)), 1d0)
    before = now
    if (allocated(P)) deallocate (P)
    allocate (P(0:n), source=start)
    deallocate (X, H, start)
    n = 2*n
  end do
  call write_submission()
  if (.not. error <= tolerance) stop 1, quiet=.true.
contains
  subroutine read_text(name)
    character(len=*), intent(in) :: name
    integer :: unit, length, fault
    open (newunit=unit, file=name, access='stream', form='unformatted', status='old', iostat=fault, iomsg=word)
    if (fault /= 0) then
      write (0, '(2a)') 'line_contact: the case cannot be read: ', trim(word)
      stop 2, quiet=.true.
    end if
    inquire (unit, size=length)
    allocate (character(len=length) :: text)
    read (unit) text
    close (unit)
  end subroutine

  ! The number after a key; 0 where the case has no such key.
  real(dp) function number(key)
    character(len=*), intent(in) :: key
    integer :: at
    number = 0
    at = index(text, key//':', back=.true.)  ! the last one: "version" is also part of the provenance
    if (at > 0) then
      at = at + len(key) + 1
      word = text(at:at + scan(text(at:), ','//new_line('a')//'}') - 2)
      read (word, *) number
    end if
  end function

  function word_after(key, from) result(found_word)
    character(len=*), intent(in) :: key
    integer, intent(in) :: from
    character(len=:), allocatable :: found_word
    integer :: at, length
    at = from + index(text(from:), key) + len(key)
    at = at + index(text(at:), '"')
    length = index(text(at:), '"') - 1
    found_word = text(at:at + length - 1)
  end function

  subroutine write_submission()
    integer :: unit
    open (newunit=unit, file=trim(out_file), status='replace')
    write (unit, '(a)') '{"schema": "ehd-submission-1", "solver": {"name": "line_contact.f90", "version": "1"},'
    write (unit, '(3a,i0,a)') ' "results": [{"case": "', word_after('"case"', 1), '", "version": ', &
      nint(number('"version"')), ', "scaling": "hertz",'
    write (unit, '(3(a,es23.16e3))') '  "film.minimum": ', now(1), ', "film.central": ', now(2), &
      ', "stated_error": ', error
    write (unit, '(a)') ' }]}'
    close (unit)
  end subroutine
end program
