// SPDX-License-Identifier: GPL-3.0-or-later
// The notes of a bearing result: which note, and the numbers that stand nowhere else in the result.
// io/bearing_notes.hpp words them.
#pragma once

#include <string>
#include <variant>

#include "bearing/geometry.hpp"
#include "workflow/plausibility.hpp"

namespace ehd::note {

/// The line of a raceway does not describe its contacts (LinearFit::describes_contacts). It stands before all other
/// notes.
struct PoorLine {
  bearing::Raceway raceway = bearing::Raceway::inner;
};
/// Where the datum x_0 comes from.
struct Datum {
  enum class From {
    stated,           ///< the case states x_0
    lundberg,         ///< x_0 = l
    palmgren,         ///< delta_dry meets the hertz law at `met_at_N`
    without_a_force,  ///< palmgren, but the dry rollers carry nothing: x_0 = l, without effect
  };
  From from = From::stated;
  double met_at_N = 0;
};
/// A key of [datum] beside a law that does not read it.
struct UnreadDatum {
  std::string key;         ///< "x0_m"
  std::string law;         ///< of the datum
  std::string belongs_to;  ///< the law that reads the key
};
/// The force across the load that holds the ring in the radial form.
struct LateralForce {
  double force_N = 0;
};
/// The fit of a raceway begins at lightest_fit_M (bearing_fit.hpp), not where the dry balance would have it begin.
struct RaisedFit {
  bearing::Raceway raceway = bearing::Raceway::inner;
  double from_N = 0, unraised_N = 0;
};
/// Contacts with a force outside the range of their fit.
struct OutsideFit {
  bearing::Raceway raceway = bearing::Raceway::inner;
  int contacts = 0;
  double lightest_N = 0, heaviest_N = 0;
};
struct Curve {
  bearing::Raceway raceway = bearing::Raceway::inner;
  long contacts_below = 0;  ///< with a force below the lightest solved one
};
/// What the oil's grade gives (contact/oil_grade.hpp), and what nondimensionalise remarks about the oil.
struct Oil {
  std::string remark;
};
/// BearingResult::variants has the variant. Without a balance in the plane it is balanced in the radial form.
struct CutVariant {
  bool on_jump = false;  ///< rollers stand on the jump of the cut law
  bool radial = false;
};
struct NoVariant {
  std::string why;
};
struct NoFilms {
  std::string why;
  bool limit = false;  ///< a contact of the films ran out of iterations or time
};
/// BearingResult::dynamics is there; without `damped` the law knows no damping.
struct Dynamics {
  bool damped = false;
};
/// BearingResult::torque is there.
struct Torque {};
/// A number outside its usual range (plausibility.hpp).
using Unusual = ehd::Unusual;
/// A film is thinner than the roughness.
struct ThinFilm {
  double lambda_ratio = 0;
};
/// The error of a balance with films is not known.
struct NoBudget {
  std::string why;
};

/// A straight line without a balance by the law ehd in the same run: its error is not known.
struct LineAlone {
  bool ehd_failed = false;  ///< ehd was asked for, and found no balance
};

}  // namespace ehd::note

namespace ehd {

using BearingNote =
    std::variant<note::PoorLine, note::Datum, note::UnreadDatum, note::LateralForce, note::RaisedFit, note::OutsideFit,
                 note::Curve, note::Oil, note::CutVariant, note::NoVariant, note::NoFilms, note::Dynamics, note::Torque,
                 note::Unusual, note::ThinFilm, note::NoBudget, note::LineAlone>;

}  // namespace ehd
