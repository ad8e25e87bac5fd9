// SPDX-License-Identifier: GPL-3.0-or-later
// A field as a function of X, and the distance of two fields.
#pragma once

#include <vector>

#include "contact/solution.hpp"

namespace ehd {

/// A field between its nodes: straight lines, or the polynomials of its elements (as in Fields::elements).
class Profile {
 public:
  /// X increases; X and values have the same size, at least 2. `elements` is empty, or names the Gauss-Lobatto nodes of
  /// one polynomial after the other, from the first node to the last.
  Profile(const Array& X, const Array& values, const std::vector<Eigen::Index>& elements = {});

  [[nodiscard]] std::size_t pieces() const { return ends_.size() - 1; }
  [[nodiscard]] double end(std::size_t k) const { return ends_[k]; }  ///< piece k reaches from end(k) to end(k + 1)
  [[nodiscard]] double first() const { return ends_.front(); }
  [[nodiscard]] double last() const { return ends_.back(); }
  [[nodiscard]] int degree() const { return degree_; }  ///< the largest
  /// The polynomial of piece k at x.
  [[nodiscard]] double value(std::size_t k, double x) const;

 private:
  std::vector<double> ends_;
  std::vector<double> coefficients_;  ///< Legendre, of all pieces
  std::vector<std::size_t> begins_;   ///< where those of piece k begin; one more than pieces
  int degree_ = 1;
};

[[nodiscard]] inline Profile pressure_profile(const Fields& fields) { return {fields.X, fields.P, fields.elements}; }

/// ||profile - truth|| / ||truth|| in L2 over the interval that both cover, integrated exactly (to rounding) between
/// neighbouring ends of the pieces of both. NaN where they have no interval in common, or the truth vanishes on it.
[[nodiscard]] double relative_l2_error(const Profile& profile, const Profile& truth);

}  // namespace ehd
