// SPDX-License-Identifier: GPL-3.0-or-later
// The contacts of one raceway that an EHD solver has solved. bearing/ knows no solver: the solver is a function that
// the caller hands in.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "bearing/geometry.hpp"

namespace ehd::bearing {

/// One solved contact.
struct SolvedContact {
  double offset = 0;        ///< H_0 in Hertz units, datum x_0 = b
  double offset_error = 0;  ///< absolute
  double film_minimum_m = 0;
  double film_error = 0;  ///< relative error of film_minimum_m
  bool converged = true;  ///< false: the best solution missed its tolerance; its errors are still honest
};
/// A contact that has no solution.
struct SolveFailure {
  std::string why;
  bool limit = false;  ///< true: the solver ran out of iterations or time; false: the equations gave no solution
};
using ContactResult = std::variant<SolvedContact, SolveFailure>;

/// Solves the contact at a load [N/m].
using ContactPoint = std::function<ContactResult(double load_N_per_m)>;

/// The solved contacts of one raceway. Each load is solved once, however many laws and bearings ask for it.
class SolvedContacts {
 public:
  SolvedContacts(RacewayContact contact, ContactPoint solve) : contact_(contact), solve_(std::move(solve)) {}

  /// The contact at a force [N], solved now or taken from memory.
  [[nodiscard]] const ContactResult& at(double force_N);
  [[nodiscard]] const RacewayContact& contact() const { return contact_; }
  [[nodiscard]] long solves() const { return solves_; }    ///< calls of the solver
  [[nodiscard]] long recalls() const { return recalls_; }  ///< requests answered from memory

 private:
  RacewayContact contact_;
  ContactPoint solve_;
  std::map<double, ContactResult> results_;
  long solves_ = 0, recalls_ = 0;
};

/// The offset film of a solved contact [m], F = (b^2/R)(H_0 - H_0,dry) = delta_dry - delta (film_curve.hpp).
[[nodiscard]] double offset_film_m(const RacewayContact& contact, double force_N, const SolvedContact& solved);

/// What offset_error is of the offset film, relative.
[[nodiscard]] double relative_offset_error(const SolvedContact& solved);

}  // namespace ehd::bearing
