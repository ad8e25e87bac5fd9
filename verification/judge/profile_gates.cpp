// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/judge/profile_gates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/file_text.hpp"
#include "verification/judge/csv_reader.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

namespace {

using std::numbers::pi;
using verification::Tolerance;
using verification::Verdict;

constexpr FileKind profile_kind{.name = "a profile (CSV with columns X, P, H)", .most_bytes = 32 << 20};
constexpr Eigen::Index fewest_nodes = 16, most_nodes = 100000;
constexpr double widest = 1e6;        // |X|: the lightest case of the atlas begins at -6000
constexpr double highest = 1e6;       // |P|: the sharpest spikes of Barus' law stay below 100
constexpr double thickest = 1e12;     // |H|: the gap X^2/2 at the widest X is 5e11
constexpr double usual_error = 1e-3;  // the program's own default tolerance: gates ask for no more than three digits
constexpr double safety = 2;          // over a first-order scheme, whose error is what halving the grid changes
constexpr double coarsest = 0.1;      // a gate with a larger tolerance would let everything through
constexpr double loaded = 0.1;        // the film equation is judged where P is above this part of its maximum
constexpr Eigen::Index most_places = 400;  // so many nodes of the film equation, each an integral over all nodes

/// Every second node, with the first and the last.
SubmittedProfile halved(const SubmittedProfile& profile) {
  const Eigen::Index n = profile.X.size(), kept = n / 2 + 1;
  SubmittedProfile half{.X = Array(kept), .P = Array(kept), .H = Array(kept)};
  for (Eigen::Index i = 0; i < kept; ++i) {
    const Eigen::Index at = i + 1 < kept ? 2 * i : n - 1;
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

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What is left of H(X) - X^2/2 + (1/pi) Int P ln|X - s| ds at some nodes when its median, H_0, is taken away, over the
/// film `scale` there.
std::vector<double> film_residual(const SubmittedProfile& integrated, const SubmittedProfile& at, const Array& scale,
                                  const std::vector<Eigen::Index>& places) {
  std::vector<double> left;
  left.reserve(places.size());
  for (const Eigen::Index i : places)
    left.push_back(at.H[i] - at.X[i] * at.X[i] / 2 + log_integral(integrated, at.X[i]) / pi);
  const double offset = median_of(left);
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
          .error = error,
          .uncertainty = uncertainty,
          .tolerance = tolerance,
          .verdict = !passes  ? Verdict::fail
                     : coarse ? Verdict::inconclusive
                              : Verdict::pass};
}

Tolerance gate_tolerance(double uncertainty, double stated_error) {
  return Tolerance::discretisation(uncertainty, safety) +
         Tolerance::required(std::max(stated_error, usual_error), "the stated error, 1e-3 at least");
}

Gate load_gate(const SubmittedProfile& profile, const SubmittedProfile& half, double stated_error) {
  const double load = trapezoid(profile), error = std::abs(2 / pi * load - 1);
  const double uncertainty = 2 / pi * (std::abs(load - trapezoid(half)) + load_before(profile));
  return decided("load balance", "trapezoid rule over all nodes", error, uncertainty,
                 gate_tolerance(uncertainty, stated_error));
}

Gate film_gate(const SubmittedProfile& profile, const SubmittedProfile& half, double stated_error, bool dry) {
  const Array scale = dry ? Array(Array::Ones(profile.X.size())) : profile.H;
  // Places are nodes of the halved profile too.
  const double edge = loaded * profile.P.maxCoeff();
  std::vector<Eigen::Index> candidates, places;
  for (Eigen::Index i = 0; i + 1 < profile.X.size(); i += 2)
    if (profile.P[i] >= edge) candidates.push_back(i);
  const auto step = std::max<std::size_t>(1, candidates.size() / static_cast<std::size_t>(most_places));
  for (std::size_t k = 0; k < candidates.size(); k += step) places.push_back(candidates[k]);
  const char* const quadrature = "pressure linear between the nodes, its logarithmic integral exact; H_0 fitted";
  // No pressure to speak of, or no film under it: nothing that an equation could hold for.
  const bool closed = std::any_of(places.begin(), places.end(), [&](Eigen::Index i) { return !(scale[i] > 0); });
  if (!(edge > 0) || places.empty() || closed)
    return decided("film equation", quadrature, widest, 0, gate_tolerance(0, stated_error));
  const auto residual = film_residual(profile, profile, scale, places),
             coarser = film_residual(half, profile, scale, places);
  double uncertainty = 0, thinnest = widest;
  for (std::size_t k = 0; k < places.size(); ++k) {
    uncertainty = std::max(uncertainty, std::abs(residual[k] - coarser[k]));
    thinnest = std::min(thinnest, scale[places[k]]);
  }
  // The pressure before the first node bends the film by 2/(pi |X_0|) of its load, over the contact's width.
  uncertainty += 2 / pi * load_before(profile) / std::max(std::abs(profile.X[0]), 1.0) / thinnest;
  return decided("film equation", quadrature, largest(residual), uncertainty,
                 gate_tolerance(uncertainty, stated_error));
}

Gate sign_gate(const SubmittedProfile& profile) {
  constexpr double rounding = 1e-9;
  const double most = profile.P.abs().maxCoeff();
  const double error = most > 0 ? std::max(0.0, -profile.P.minCoeff()) / most : 1;
  return decided("P >= 0", "smallest P over the largest", error, 0,
                 Tolerance::required(rounding, "cavitation: rounding alone may leave P below 0"));
}

}  // namespace

SubmittedProfile read_profile(const std::filesystem::path& file) {
  CsvReader csv(file, profile_kind, static_cast<std::size_t>(most_nodes));
  const std::size_t columns[] = {csv.column("X"), csv.column("P"), csv.column("H")};
  const std::size_t unresolved = csv.column("P_unresolved", false);
  std::vector<double> values[3];
  bool cut = false;
  while (csv.next()) {
    cut = cut || (unresolved < csv.size() && csv.number(unresolved) != 0);
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
  if (nodes < fewest_nodes)
    throw refusal(file.string(), "has " + std::to_string(nodes) + " rows; required are 16 at least");
  const auto field = [&](std::size_t c) { return Array(Eigen::Map<const Array>(values[c].data(), nodes)); };
  return {.X = field(0), .P = field(1), .H = field(2), .cut = cut};
}

std::vector<Gate> gates_of(const SubmittedProfile& profile, double stated_error, bool dry) {
  const SubmittedProfile half = halved(profile);
  std::vector<Gate> gates{load_gate(profile, half, stated_error), film_gate(profile, half, stated_error, dry)};
  for (Gate& gate : gates)
    if (profile.cut && gate.verdict == Verdict::fail) gate.verdict = Verdict::inconclusive;
  gates.push_back(sign_gate(profile));
  return gates;
}

}  // namespace ehd::judging
