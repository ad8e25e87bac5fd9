// SPDX-License-Identifier: GPL-3.0-or-later
// Int_-1^1 P_k(t) ln|u - t| dt for all k at once, exactly, at any distance and in any real scalar type.
//
// m_k(u) = 2 (Q_(k+1)(u) - Q_(k-1)(u))/(2k + 1), k >= 1, with Q_k the Legendre functions of the second kind (on the cut
// their principal values): integrate by parts with Int P_k = (P_(k+1) - P_(k-1))/(2k+1) and Neumann's
// Q_k(u) = 1/2 Int P_k(t)/(u - t) dt.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "reference/hp/reference_element.hpp"

namespace ehd::reference::hp {

namespace detail {

/// Up to this (degree + 1) acosh(u) the forward recurrence is taken: it loses less than a digit.
inline constexpr double forward_reach = 1.5;
/// Miller's recurrence begins so many steps above degree + 2: this number times the binary digits, over acosh(u). Its
/// error falls by e^(-2 acosh(u)) a step, so ln(2)/2 = 0.347 would be enough; the rest is a reserve.
inline constexpr double miller_steps = 0.38;

/// m_k from Q_0 … Q_(degree+1), k >= 1.
template <class Scalar, class Out>
void moments_from_Q(int degree, const VectorOf<Scalar>& Q, Out&& m) {
  for (int k = 1; k <= degree; ++k) m[k] = Scalar(2) * (Q[k + 1] - Q[k - 1]) / Scalar(2 * k + 1);
}

/// The ends of the element, u = 1: m_0 = 2 ln 2 - 2, m_k = -2/(k(k+1)).
template <class Scalar, class Out>
void moments_at_right_end(int degree, Out&& m) {
  using std::log;
  m[0] = Scalar(2) * log(Scalar(2)) - Scalar(2);
  for (int k = 1; k <= degree; ++k) m[k] = Scalar(-2) / Scalar(k * (k + 1));
}

}  // namespace detail

/// For a point of the element itself, -1 <= u <= 1; from_left = 1 + u and from_right = 1 - u without cancellation.
/// `work` has degree + 2 entries. m: degree + 1 entries.
template <class Scalar, class Out>
void moments_inside(int degree, const Scalar& u, const Scalar& from_left, const Scalar& from_right,
                    VectorOf<Scalar>& work, Out&& m) {
  using std::log;
  if (from_right == Scalar(0) || from_left == Scalar(0)) {
    detail::moments_at_right_end<Scalar>(degree, m);
    if (from_left == Scalar(0))
      for (int k = 1; k <= degree; k += 2) m[k] = -m[k];
    return;
  }
  const Scalar log_left = log(from_left), log_right = log(from_right);
  work[0] = (log_left - log_right) / Scalar(2);
  work[1] = u * work[0] - Scalar(1);
  for (int k = 1; k <= degree; ++k)
    work[k + 1] = (Scalar(2 * k + 1) * u * work[k] - Scalar(k) * work[k - 1]) / Scalar(k + 1);
  m[0] = from_left * log_left + from_right * log_right - Scalar(2);
  detail::moments_from_Q(degree, work, m);
}

/// For a point at u = 1 + beyond, beyond >= 0. At the far side, u = -1 - beyond, m_k changes its sign for odd k.
template <class Scalar, class Out>
void moments_outside(int degree, const Scalar& beyond, VectorOf<Scalar>& work, Out&& m) {
  using std::log;
  using std::log1p;
  using std::sqrt;
  if (beyond == Scalar(0)) {
    detail::moments_at_right_end<Scalar>(degree, m);
    return;
  }
  const Scalar u = Scalar(1) + beyond;
  const Scalar acosh_u = log1p(beyond + sqrt(beyond * (beyond + Scalar(2))));
  work[0] = log1p(Scalar(2) / beyond) / Scalar(2);
  if (Scalar(degree + 1) * acosh_u <= Scalar(detail::forward_reach)) {
    // k + 1 times Q_(k+1) with u = 1 + beyond.
    work[1] = u * work[0] - Scalar(1);
    for (int k = 1; k <= degree; ++k)
      work[k + 1] = (Scalar(2 * k + 1) * u * work[k] - Scalar(k) * work[k - 1]) / Scalar(k + 1);
  } else {
    // Miller: r_k = Q_k/Q_(k-1) downwards from far above.
    constexpr double digits = std::numeric_limits<Scalar>::digits;
    const int first = degree + 2 + static_cast<int>(detail::miller_steps * digits / static_cast<double>(acosh_u));
    Scalar ratio(0);
    for (int k = first; k > degree + 1; --k) ratio = Scalar(k) / (Scalar(2 * k + 1) * u - Scalar(k + 1) * ratio);
    for (int k = degree + 1; k >= 1; --k) {
      ratio = Scalar(k) / (Scalar(2 * k + 1) * u - Scalar(k + 1) * ratio);
      work[k] = ratio;
    }
    for (int k = 1; k <= degree + 1; ++k) work[k] *= work[k - 1];
  }
  m[0] = u < Scalar(2) ? (beyond + Scalar(2)) * log(beyond + Scalar(2)) - beyond * log(beyond) - Scalar(2)
                       : log(beyond) + log(beyond + Scalar(2)) + Scalar(2) * work[1];
  detail::moments_from_Q(degree, work, m);
}

}  // namespace ehd::reference::hp
