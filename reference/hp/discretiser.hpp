// SPDX-License-Identifier: GPL-3.0-or-later
// From a problem to solved discretisations of it: the start, the coarse descent, and a mesh for each scheme.
// docs/certified-solver.md, sections 4 and 6.
#pragma once

#include <optional>
#include <vector>

#include "reference/hp/discretised.hpp"

namespace ehd::reference::hp {

/// A discretisation: its points and degree, and how its breakpoints and inlet differ from those of the first one.
struct Scheme {
  Points points = Points::left_radau;
  int degree = 12;
  double shift = 0;       ///< of the breakpoints against the first one's, in elements
  double inlet_part = 1;  ///< X_a of a flooded domain over the first one's
};

/// Tolerances below this one need the high degree.
inline constexpr double fine_tolerance = 2e-5;
inline constexpr Scheme coarse_scheme{.degree = 8};
inline constexpr Scheme fine_scheme{.degree = 12};

/// One problem on the meshes of two schemes.
struct DiscretisedTwice {
  Discretised first, second;
};

class Discretiser {
 public:
  /// The problem must outlive the discretiser.
  Discretiser(const Problem& problem, const Meter& meter);

  /// A coarse solution at the lowest floor of the fluidity, from 1e-2 up to 1, at which Newton's method finds one.
  /// Empty where it finds none.
  [[nodiscard]] std::optional<Resolved> start();
  /// The descent of the coarse mesh: a state at every floor, from `top` down.
  [[nodiscard]] std::vector<Resolved> coarse_descent(const Resolved& top, double tolerance);
  /// Descends on meshes of the scheme, from the lowest of `floors` at which such a mesh has a solution.
  [[nodiscard]] std::optional<Discretised> discretised(const std::vector<Resolved>& floors, const Scheme& scheme,
                                                       const Resolution& resolution, double tolerance);
  /// discretised() by the scheme and by a second one: higher degree, no common breakpoint, half the inlet. It descends
  /// from the floors of the first; where these give it no solution, it descends from `coarse`. Empty where one of the
  /// two has no solution.
  [[nodiscard]] std::optional<DiscretisedTwice> discretised_twice(const std::vector<Resolved>& coarse,
                                                                  const Scheme& scheme, const Resolution& resolution,
                                                                  double tolerance);
  /// A mesh of exactly `intervals` intervals, made for the solution at the floors of `guide`. Where these lead to no
  /// solution, it is made for the smoother solutions of the coarse descent.
  [[nodiscard]] std::optional<Discretised> laid_out(const Discretised& guide, const std::vector<Resolved>& coarse,
                                                    int intervals);
  /// The elements of `first` again, shifted, of 1.5 times the degree, and with half the inlet.
  [[nodiscard]] std::optional<Discretised> second_opinion(const Discretised& first);

  /// The relative error of a film by rounding. Meshes finer than this only cost time.
  [[nodiscard]] double rounding_of(double film) const;
  /// The same for the film that a fit of the literature expects.
  [[nodiscard]] double expected_rounding() const { return rounding_of(film_); }
  [[nodiscard]] const Meter& meter() const { return meter_; }

 private:
  [[nodiscard]] std::optional<Resolved> on_mesh_of(const Resolved& from, const Scheme& scheme,
                                                   const Resolution& resolution, const HomotopyLimits& limits);
  [[nodiscard]] std::optional<Resolved> as_it_is(const Resolved& start, const HomotopyLimits& limits);
  [[nodiscard]] Discretised observed(std::vector<Resolved> floors, Resolution resolution, const HomotopyLimits& limits);

  const Problem& problem_;
  Wanted wanted_;
  Meter meter_;
  double film_, length_, inlet_zone_, inlet_;
  bool flooded_;
};

}  // namespace ehd::reference::hp
