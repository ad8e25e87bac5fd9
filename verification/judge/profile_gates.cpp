// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/profile_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/file_text.hpp"
#include "verification/judge/csv_reader.hpp"
#include "verification/judge/submission.hpp"
#include "verification/median.hpp"

namespace ehd::judging {

namespace {

using std::numbers::pi;
using verification::Tolerance;
using verification::Verdict;

constexpr FileKind profile_kind{.name = "a profile (CSV with columns X, P, H)", .most_bytes = 32 << 20};
constexpr Eigen::Index fewest_nodes = 16, most_nodes = 100000;
constexpr double widest = 1e6;         // |X|: the lightest case of the atlas begins at -6000
constexpr double highest = 1e6;        // |P|: the sharpest spikes of Barus' law stay below 100
constexpr double thickest = 1e12;      // |H|: the gap X^2/2 at the widest X is 5e11
constexpr double usual_error = 1e-3;   // the program's own default tolerance: gates ask for no more than three digits
constexpr double safety = 2;           // times what half of the nodes change: that change is the scheme's error
constexpr double coarsest = 0.1;       // a gate with a larger tolerance would let everything through
constexpr double tallest_spike = 100;  // p/p_H: the sharpest spikes of Barus' law stay below
constexpr double same_limit = 1e-9;    // relative: cut rows show one limit, printed with 10 digits or more
constexpr double loaded = 0.1;         // the film equation is judged where P is above this part of its maximum
constexpr std::size_t fewest_places = 2;   // H_0 is fitted: the film equation of one node holds whatever P is
constexpr Eigen::Index most_places = 400;  // so many nodes of the film equation, each an integral over all nodes

/// Every second node, with the first and the last. A node beside a cut one is cut, so that no cut is lost.
SubmittedProfile halved(const SubmittedProfile& profile) {
  const Eigen::Index n = profile.X.size(), kept = n / 2 + 1;
  SubmittedProfile half{.X = Array(kept), .P = Array(kept), .H = Array(kept), .cut = ArrayOf<bool>(kept)};
  for (Eigen::Index i = 0; i < kept; ++i) {
    const Eigen::Index at = i + 1 < kept ? 2 * i : n - 1;
    const Eigen::Index first = std::max<Eigen::Index>(at - 1, 0), last = std::min(at + 1, n - 1);
    half.cut[i] = profile.cut.segment(first, last - first + 1).any();
    half.X[i] = profile.X[at];
    half.P[i] = profile.P[at];
    half.H[i] = profile.H[at];
  }
  return half;
}

double trapezoid(const SubmittedProfile& profile) {
  const Eigen::Index n = profile.X.size() - 1;
  return ((profile.X.tail(n) - profile.X.head(n)) * (profile.P.tail(n) + profile.P.head(n))).sum() / 2;
}

/// The rows that say that P is cut, and show the largest P. P = 0 at the inlet is no spike that was cut.
ArrayOf<bool> cut_at_limit(const SubmittedProfile& profile) {
  if (profile.cut.size() != profile.P.size()) return ArrayOf<bool>::Constant(profile.P.size(), false);
  return profile.cut && profile.P >= (1 - same_limit) * profile.P.maxCoeff();
}

/// What the trapezoid rule gives for 1 in the cut rows and 0 in the others.
double width_of_cut(const SubmittedProfile& profile) {
  return trapezoid({.X = profile.X, .P = profile.cut.cast<double>(), .H = {}});
}

/// The load that P lacks: 0 where P has load enough.
double missing_load(const SubmittedProfile& profile) { return std::max(0.0, pi / 2 - trapezoid(profile)); }

/// The profile with the missing load in its cut rows.
SubmittedProfile with_missing_load(SubmittedProfile profile) {
  const double missing = missing_load(profile), width = width_of_cut(profile);
  if (width > 0) profile.P += missing / width * profile.cut.cast<double>();
  return profile;
}

/// The load before the first node, where the pressure of a flooded inlet falls as |X|^-3.
double load_before(const SubmittedProfile& profile) {
  return std::abs(profile.P[0]) * std::max(std::abs(profile.X[0]), 1.0) / 2;
}

/// Int P(s) ln|x - s| ds for P that is linear between the nodes, integrated exactly.
double log_integral(const SubmittedProfile& profile, double x) {
  const auto zeroth = [](double t) { return t == 0 ? 0 : t * std::log(std::abs(t)) - t; };
  const auto first = [](double t) { return t == 0 ? 0 : t * t * (std::log(std::abs(t)) / 2 - 0.25); };
  double sum = 0, left = profile.X[0] - x, zeroth_left = zeroth(left), first_left = first(left);
  for (Eigen::Index k = 0; k + 1 < profile.X.size(); ++k) {
    const double right = profile.X[k + 1] - x, zeroth_right = zeroth(right), first_right = first(right);
    const double slope = (profile.P[k + 1] - profile.P[k]) / (right - left);
    sum += (profile.P[k] - slope * left) * (zeroth_right - zeroth_left) + slope * (first_right - first_left);
    left = right;
    zeroth_left = zeroth_right;
    first_left = first_right;
  }
  return sum;
}

/// Nodes of the film equation: under pressure, and in the halved profile too.
std::vector<Eigen::Index> places_under_pressure(const SubmittedProfile& profile) {
  const double edge = loaded * profile.P.maxCoeff();
  std::vector<Eigen::Index> candidates, places;
  for (Eigen::Index i = 0; i + 1 < profile.X.size(); i += 2)
    if (edge > 0 && profile.P[i] >= edge) candidates.push_back(i);
  const auto step = std::max<std::size_t>(1, candidates.size() / static_cast<std::size_t>(most_places));
  for (std::size_t k = 0; k < candidates.size(); k += step) places.push_back(candidates[k]);
  return places;
}

/// What is left of H(X) - X^2/2 + (1/pi) Int P ln|X - s| ds at some nodes when its median, H_0, is taken away, over the
/// film `scale` there.
std::vector<double> film_residual(const SubmittedProfile& integrated, const SubmittedProfile& at, const Array& scale,
                                  const std::vector<Eigen::Index>& places) {
  std::vector<double> left;
  left.reserve(places.size());
  for (const Eigen::Index i : places)
    left.push_back(at.H[i] - at.X[i] * at.X[i] / 2 + log_integral(integrated, at.X[i]) / pi);
  const double offset = verification::median(left);
  for (std::size_t k = 0; k < places.size(); ++k) left[k] = (left[k] - offset) / scale[places[k]];
  return left;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::isfinite(value) ? std::abs(value) : widest);
  return most;
}

Gate decided(std::string name, std::string quadrature, double error, double uncertainty, const Tolerance& tolerance) {
  const bool passes = error <= tolerance.value();
  const bool coarse = tolerance.value() > coarsest;
  return {.name = std::move(name),
          .quadrature = std::move(quadrature),
          .judged = true,
          .error = error,
          .uncertainty = uncertainty,
          .tolerance = tolerance,
          .verdict = !passes  ? Verdict::fail
                     : coarse ? Verdict::inconclusive
                              : Verdict::pass};
}

/// A gate that fails because the profile has nothing to judge.
Gate nothing_to_judge(std::string name, std::string what, const Tolerance& tolerance) {
  return {.name = std::move(name),
          .quadrature = std::move(what),
          .judged = false,
          .error = 1,
          .uncertainty = 0,
          .tolerance = tolerance,
          .verdict = Verdict::fail};
}

Tolerance gate_tolerance(double uncertainty, double stated_error) {
  return Tolerance::discretisation(uncertainty, safety) +
         Tolerance::required(std::clamp(stated_error, usual_error, coarsest), "the stated error, from 1e-3 to 0.1");
}

Gate load_gate(const SubmittedProfile& profile, const SubmittedProfile& half, double stated_error) {
  const double load = trapezoid(profile), error = std::abs(2 / pi * load - 1);
  const double uncertainty = 2 / pi * (std::abs(load - trapezoid(half)) + load_before(profile));
  Gate gate = decided("load balance", "trapezoid rule over all nodes", error, uncertainty,
                      gate_tolerance(uncertainty, stated_error));
  // Spikes in the cut rows hold what is missing. They cannot hold less than nothing.
  const double missing = missing_load(profile);
  if (gate.verdict == Verdict::fail && missing > 0 && missing <= tallest_spike * width_of_cut(profile))
    gate.verdict = Verdict::inconclusive;
  return gate;
}

/// What is left of the film equation at some places, over the film there.
struct FilmLeft {
  std::vector<double> residual;
  double uncertainty = 0;  ///< what half of the nodes would change
};

FilmLeft film_left(const SubmittedProfile& profile, const SubmittedProfile& half, const Array& scale,
                   const std::vector<Eigen::Index>& places) {
  FilmLeft left{.residual = film_residual(profile, profile, scale, places)};
  const auto coarser = film_residual(half, profile, scale, places);
  double thinnest = widest;
  for (std::size_t k = 0; k < places.size(); ++k) {
    left.uncertainty = std::max(left.uncertainty, std::abs(left.residual[k] - coarser[k]));
    thinnest = std::min(thinnest, scale[places[k]]);
  }
  // The pressure before the first node bends the film by 2/(pi |X_0|) of its load, over the contact's width.
  left.uncertainty += 2 / pi * load_before(profile) / std::max(std::abs(profile.X[0]), 1.0) / thinnest;
  return left;
}

/// Whether the cut rows can explain that the film equation fails: it holds outside of them, once the missing load
/// stands in them. How the load is spread over them is not known. At the distances near and far from their ends, that
/// moves the film by missing/pi ln(far/near) at most, and its median, H_0, by the median of that.
bool cut_explains(const SubmittedProfile& profile, const SubmittedProfile& half, const Array& scale,
                  const std::vector<Eigen::Index>& places, double stated_error) {
  if (!profile.cut.any()) return false;
  Eigen::Index first = 0, last = profile.X.size() - 1;
  while (!profile.cut[first]) ++first;
  while (!profile.cut[last]) --last;
  const double begin = profile.X[std::max<Eigen::Index>(first - 1, 0)],
               end = profile.X[std::min(last + 1, profile.X.size() - 1)];
  std::vector<Eigen::Index> outside;
  std::vector<double> unknown;
  const double missing = missing_load(profile);
  for (const Eigen::Index i : places) {
    const double to_begin = std::abs(profile.X[i] - begin), to_end = std::abs(profile.X[i] - end);
    if (profile.X[i] >= begin && profile.X[i] <= end) continue;
    outside.push_back(i);
    unknown.push_back(missing / pi * std::abs(std::log(to_end / to_begin)));
  }
  if (outside.empty()) return true;
  const FilmLeft left = film_left(with_missing_load(profile), with_missing_load(half), scale, outside);
  const double allowed = gate_tolerance(left.uncertainty, stated_error).value(),
               of_offset = verification::median(unknown);
  for (std::size_t k = 0; k < outside.size(); ++k)
    if (!(std::abs(left.residual[k]) <= allowed + (unknown[k] + of_offset) / scale[outside[k]])) return false;
  return true;
}

Gate film_gate(const SubmittedProfile& profile, const SubmittedProfile& half, double stated_error, bool dry) {
  const auto nothing = [&](const char* what) {
    return nothing_to_judge(film_equation, what, gate_tolerance(0, stated_error));
  };
  const Array scale = dry ? Array(Array::Ones(profile.X.size())) : profile.H;
  if (!(profile.P.maxCoeff() > 0)) return nothing("no pressure to judge");
  const auto places = places_under_pressure(profile);
  if (places.size() < fewest_places) return nothing("too few nodes under pressure to judge");
  if (std::any_of(places.begin(), places.end(), [&](Eigen::Index i) { return !(scale[i] > 0); }))
    return nothing("no film to judge: H is not above 0 under the pressure");
  const FilmLeft left = film_left(profile, half, scale, places);
  Gate gate = decided(film_equation, "pressure linear between the nodes, its logarithmic integral exact; H_0 fitted",
                      largest(left.residual), left.uncertainty, gate_tolerance(left.uncertainty, stated_error));
  if (gate.verdict == Verdict::fail && cut_explains(profile, half, scale, places, stated_error))
    gate.verdict = Verdict::inconclusive;
  return gate;
}

Gate sign_gate(const SubmittedProfile& profile) {
  constexpr double rounding = 1e-9;
  const Tolerance tolerance = Tolerance::required(rounding, "cavitation: rounding alone may leave P below 0");
  const double most = profile.P.abs().maxCoeff();
  if (!(most > 0)) return nothing_to_judge("P >= 0", "no pressure to judge", tolerance);
  return decided("P >= 0", "smallest P over the largest", std::max(0.0, -profile.P.minCoeff()) / most, 0, tolerance);
}

}  // namespace

SubmittedProfile read_profile(const std::filesystem::path& file) {
  CsvReader csv(file, profile_kind, static_cast<std::size_t>(most_nodes));
  const std::size_t columns[] = {csv.column("X"), csv.column("P"), csv.column("H")};
  const std::size_t unresolved = csv.column("P_unresolved", false);
  std::vector<double> values[3];
  std::vector<Eigen::Index> cut;
  while (csv.next()) {
    csv.require_all_cells();
    if (unresolved < csv.size() && csv.number(unresolved) != 0)
      cut.push_back(static_cast<Eigen::Index>(values[0].size()));
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = csv.number(columns[c]);
      if (c == 0 && std::abs(value) > widest)
        throw csv.refuse(columns[c], "is far outside; allowed is X = x/b, -1e6 to 1e6");
      if (c == 1 && std::abs(value) > highest)
        throw csv.refuse(columns[c], "is far outside; allowed is P = p/p_H, -1e6 to 1e6");
      if (c == 2 && std::abs(value) > thickest)
        throw csv.refuse(columns[c], "is far outside; allowed is H = h R/b^2, -1e12 to 1e12");
      if (c == 0 && !values[0].empty() && !(value > values[0].back()))
        throw csv.refuse(columns[c], "is not above the X before it; allowed are rows by increasing X, each X once");
      values[c].push_back(value);
    }
  }
  const auto nodes = static_cast<Eigen::Index>(values[0].size());
  if (nodes < fewest_nodes) throw refusal(file.string(), fmt::format("has {} rows; required are 16 at least", nodes));
  const auto field = [&](std::size_t c) { return Array(Eigen::Map<const Array>(values[c].data(), nodes)); };
  SubmittedProfile profile{.X = field(0), .P = field(1), .H = field(2), .cut = ArrayOf<bool>::Constant(nodes, false)};
  for (const Eigen::Index row : cut) profile.cut[row] = true;
  return profile;
}

bool is_cut(const SubmittedProfile& profile) { return cut_at_limit(profile).any(); }

std::vector<Gate> gates_of(const SubmittedProfile& submitted, double stated_error, bool dry) {
  SubmittedProfile profile = submitted;
  profile.cut = cut_at_limit(submitted);
  const SubmittedProfile half = halved(profile);
  return {load_gate(profile, half, stated_error), film_gate(profile, half, stated_error, dry), sign_gate(profile)};
}

}  // namespace ehd::judging
