// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/paper_statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "workflow/bearing_run.hpp"

namespace ehd::verification {

namespace {

/// The roller nearest to an azimuth [deg].
const RollerRow& roller_at(const BearingResult& result, double azimuth_deg) {
  return *std::min_element(
      result.rollers.begin(), result.rollers.end(), [&](const RollerRow& one, const RollerRow& other) {
        return std::abs(std::abs(one.azimuth_deg) - azimuth_deg) < std::abs(std::abs(other.azimuth_deg) - azimuth_deg);
      });
}

/// The value of a name among pairs.
template <class Value>
std::optional<Value> named(const std::vector<std::pair<std::string, Value>>& pairs, std::string_view name) {
  for (const auto& [key, value] : pairs)
    if (key == name) return value;
  return std::nullopt;
}

}  // namespace

std::vector<bearing::Law> film_laws() {
  std::vector<bearing::Law> laws = laws_of(bearing::Laws::all);
  std::erase_if(laws, [](bearing::Law law) { return !needs_film(law); });
  return laws;
}

const BearingResult* balance_by(bearing::Law law, const std::vector<BearingResult>& results) {
  for (const BearingResult& result : results)
    if (result.law == law && !result.rollers.empty()) return &result;
  return nullptr;
}

std::optional<bool> PaperStatement::part(std::string_view name) const { return named(parts, name); }
std::optional<double> PaperStatement::value(std::string_view name) const { return named(values, name); }

const PaperStatement* find_statement(const std::vector<PaperStatement>& statements, char letter) {
  for (const PaperStatement& statement : statements)
    if (statement.letter == letter) return &statement;
  return nullptr;
}

double top_force_N(const BearingResult& result) { return roller_at(result, 0).inner.force_N; }
double top_approach_m(const BearingResult& result) { return roller_at(result, 0).inner.displacement_m; }

namespace {

/// (film - dry)/dry of the roller load at psi = 0.
double change_at_top(const ClearanceComparison& at) { return top_force_N(at.film) / top_force_N(at.dry) - 1; }

/// How the film changes the loads of the rollers that the dry law loads, without those nearest to psi = 0. Rollers that
/// the dry law does not load are not counted: a film always pushes, so their load can only grow.
struct FurtherOut {
  double change_N = 0;    ///< sum of f_film - f_dry
  int lower = 0, of = 0;  ///< how many of them carry less with the film
};
FurtherOut further_out(const ClearanceComparison& at) {
  FurtherOut result;
  const double nearest = std::abs(roller_at(at.dry, 0).azimuth_deg), largest_N = largest_force_N(at.dry);
  for (std::size_t j = 0; j < at.dry.rollers.size(); ++j) {
    const RollerRow& dry = at.dry.rollers[j];
    if (std::abs(dry.azimuth_deg) <= nearest + 1e-9 || !bearing::is_loaded(dry.inner.force_N, largest_N)) continue;
    const double change = at.film.rollers[j].inner.force_N - dry.inner.force_N;
    result.change_N += change;
    result.lower += change < 0;
    ++result.of;
  }
  return result;
}
std::string words_of(const FurtherOut& further) {
  return fmt::format("further out {:+.0f} N, {} of {} rollers that dry loads carry less", further.change_N,
                     further.lower, further.of);
}

/// How far the two load distributions are apart: the largest change of any roller's load.
struct Apart {
  double share = 0;  ///< of the largest dry load
  double change_N = 0, azimuth_deg = 0;
};
Apart apart(const ClearanceComparison& at) {
  Apart most;
  for (std::size_t j = 0; j < at.dry.rollers.size(); ++j) {
    const double change = at.film.rollers[j].inner.force_N - at.dry.rollers[j].inner.force_N;
    if (std::isnan(most.change_N)) break;  // NaN is similar to nothing
    if (!(std::abs(change) <= std::abs(most.change_N))) most = {0, change, std::abs(at.dry.rollers[j].azimuth_deg)};
  }
  most.share = std::abs(most.change_N) / largest_force_N(at.dry);
  return most;
}
std::string words_of(const Apart& most) {
  return fmt::format("furthest apart at {:.4g} deg: {:+.0f} N, {:.1f} % of the largest dry load", most.azimuth_deg,
                     most.change_N, 100 * most.share);
}

PaperStatement judge_a(const ClearanceComparison& smallest) {
  const double top = change_at_top(smallest);
  const Apart most = apart(smallest);
  const FurtherOut further = further_out(smallest);
  const bool similar = most.share <= similar_load, lower = top < 0;
  return {.letter = 'a',
          .statement = fmt::format(
              "at P_d = {:g} um the load distributions are similar, and near psi = 0 EHD lowers the roller load (the "
              "printed \"in contrast ... decrease\" further out contradicts that: the loads have to add up to F_r)",
              1e6 * smallest.clearance_m),
          .holds = similar && lower,
          .holds_at_top = std::abs(top) <= similar_load && lower,
          .numbers = fmt::format("f_i(0) dry {:.0f} N, EHD {:.0f} N: {:+.1f} %; {}, {}: at most {:g} %; {}: they {}",
                                 top_force_N(smallest.dry), top_force_N(smallest.film), 100 * top, words_of(most),
                                 similar ? "similar" : "not similar", 100 * similar_load, words_of(further),
                                 further.change_N < 0 ? "decrease, as printed" : "do not decrease"),
          .parts = {{"similar", similar}, {"lower", lower}, {"printed decrease", further.change_N < 0}},
          .values = {{"change", top}, {"apart", most.share}}};
}

/// How the film changes delta_i at one clearance.
struct Approaches {
  double top = 0;                                           ///< (film - dry)/dry at psi = 0
  double least = -std::numeric_limits<double>::infinity();  ///< the same, where it is smaller by the least, of `loaded`
  int loaded = 0;                                           ///< rollers that the dry law loads
  int larger = 0, of = 0;                                   ///< of the others: where delta_i is larger with the film
  double largest_m = 0;                                     ///< by how much, at most
};
Approaches approaches(const ClearanceComparison& at) {
  Approaches result{.top = top_approach_m(at.film) / top_approach_m(at.dry) - 1};
  const double largest_N = largest_force_N(at.dry);
  for (std::size_t j = 0; j < at.dry.rollers.size(); ++j) {
    const double dry = at.dry.rollers[j].inner.displacement_m, film = at.film.rollers[j].inner.displacement_m;
    if (bearing::is_loaded(at.dry.rollers[j].inner.force_N, largest_N)) {
      ++result.loaded;
      if (!(film / dry - 1 <= result.least)) result.least = film / dry - 1;  // NaN stays, and is not smaller
      if (std::isnan(result.least)) break;
    } else {
      ++result.of;
      result.larger += film > dry;
      result.largest_m = std::max(result.largest_m, film - dry);
    }
  }
  return result;
}

PaperStatement judge_b(const std::vector<ClearanceComparison>& all) {
  PaperStatement statement{.letter = 'b',
                           .statement = "delta_i is considerably smaller with EHD than dry, at every clearance",
                           .holds = true,
                           .holds_at_top = true};
  double least = -std::numeric_limits<double>::infinity(), most = -least, loaded = least, outside_m = 0;
  for (const ClearanceComparison& at : all) {
    const Approaches here = approaches(at);
    statement.holds_at_top = *statement.holds_at_top && here.top <= -considerably;
    statement.holds = statement.holds && here.top <= -considerably && here.least <= -considerably;
    least = std::max(least, here.top);
    most = std::min(most, here.top);
    loaded = std::max(loaded, here.least);
    outside_m = std::max(outside_m, here.largest_m);
    statement.numbers += (statement.numbers.empty() ? "" : "; ") +
                         fmt::format(
                             "P_d {:g} um: delta_i(0) {:.3f} -> {:.3f} um ({:+.0f} %), {} loaded rollers {:+.0f} "
                             "% or less, of {} others {} larger",
                             1e6 * at.clearance_m, 1e6 * top_approach_m(at.dry), 1e6 * top_approach_m(at.film),
                             100 * here.top, here.loaded, 100 * here.least, here.of, here.larger);
    if (here.larger > 0) statement.numbers += fmt::format(" (by {:.2f} um at most)", 1e6 * here.largest_m);
  }
  statement.values = {{"least", least}, {"most", most}, {"loaded", loaded}, {"outside_m", outside_m}};
  return statement;
}

PaperStatement judge_c(const ClearanceComparison& smallest, const ClearanceComparison& middle,
                       const ClearanceComparison& largest) {
  const double near = change_at_top(middle), far = change_at_top(largest);
  const bool closest = std::abs(near) < std::min(std::abs(change_at_top(smallest)), std::abs(far));
  const Apart most = apart(middle);
  const FurtherOut further = further_out(largest);
  const bool close_at_top = std::abs(near) <= close_load, close = close_at_top && most.share <= close_load;
  const bool opposite = far > 0 && further.change_N < 0;
  return {
      .letter = 'c',
      .statement = fmt::format(
          "at P_d = {:g} um EHD is close to Hertz; at {:g} um it raises the roller load near psi = 0 and lowers it "
          "further out",
          1e6 * middle.clearance_m, 1e6 * largest.clearance_m),
      .holds = close && opposite,
      .holds_at_top = close_at_top && opposite,
      .numbers = fmt::format(
          "f_i(0) at {:g} um {:.0f} -> {:.0f} N ({:+.1f} %, {}); {}, {}: at most {:g} %; at {:g} um {:.0f} -> {:.0f} "
          "N ({:+.1f} %), {} ({})",
          1e6 * middle.clearance_m, top_force_N(middle.dry), top_force_N(middle.film), 100 * near,
          close_at_top ? "close" : "not close", words_of(most), close ? "close" : "not close", 100 * close_load,
          1e6 * largest.clearance_m, top_force_N(largest.dry), top_force_N(largest.film), 100 * far, words_of(further),
          opposite ? "as said" : "not as said"),
      .parts = {{"close", close}, {"close at psi = 0", close_at_top}, {"closest", closest}, {"opposite", opposite}},
      .values = {{"middle", near}, {"largest", far}, {"apart", most.share}}};
}

/// With growing clearance delta_i grows at psi = 0 and falls at 90 degrees: the displacements concentrate.
PaperStatement judge_d(const std::vector<ClearanceComparison>& all) {
  PaperStatement statement{
      .letter = 'd',
      .statement =
          "with growing clearance the larger displacements concentrate near psi = 0, in both models (the "
          "printed \"near 0 deg decrease, near 90 deg increase\" is the opposite)",
      .holds = true};
  for (const bool film : {false, true}) {
    std::string top, side, count;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const BearingResult& here = film ? all[k].film : all[k].dry;
      const double at_top = top_approach_m(here), at_side = roller_at(here, 90).inner.displacement_m;
      if (k > 0) {
        const BearingResult& before = film ? all[k - 1].film : all[k - 1].dry;
        statement.holds =
            statement.holds && at_top > top_approach_m(before) && at_side < roller_at(before, 90).inner.displacement_m;
      }
      const char* comma = k > 0 ? ", " : "";
      top += fmt::format("{}{:.2f}", comma, 1e6 * at_top);
      side += fmt::format("{}{:.2f}", comma, 1e6 * at_side);
      count += fmt::format("{}{}", comma, loaded_rollers(here.rollers));
    }
    statement.numbers += fmt::format("{}delta_i at 0 deg {} um, nearest 90 deg {} um, loaded rollers {}",
                                     film ? "; EHD: " : "dry: ", top, side, count);
  }
  return statement;
}

}  // namespace

std::vector<PaperStatement> judge_paper_statements(std::vector<ClearanceComparison> clearances) {
  const bool complete = std::all_of(clearances.begin(), clearances.end(), [](const ClearanceComparison& at) {
    return !at.dry.rollers.empty() && at.dry.rollers.size() == at.film.rollers.size();
  });
  if (clearances.size() < 3 || !complete) return {};
  std::sort(clearances.begin(), clearances.end(),
            [](const auto& one, const auto& other) { return one.clearance_m < other.clearance_m; });
  return {judge_a(clearances.front()), judge_b(clearances),
          judge_c(clearances.front(), clearances[1], clearances.back()), judge_d(clearances)};
}

bool is_of_the_paper(const Case& one) { return one.source.starts_with("tsuhanonatocavalca"); }

bool differ_only_in_clearance(const std::vector<Case>& cases) {
  // Structs are taken apart by all their members: a new one does not compile until it is compared too.
  const auto same = [](const BearingCase& one, const BearingCase& other) {
    const auto lubricant = [](const BearingCase& body) {
      const BearingLubricant empty{};
      // The grade adds nothing: it is in the viscosity and alpha.
      const auto& [oil, viscosity_Pa_s, grade] = body.lubricant ? *body.lubricant : empty;
      const auto& [viscosity, density, alpha, z, p0_Pa] = oil;
      return std::tuple(body.lubricant.has_value(), viscosity_Pa_s, viscosity, density, alpha, z, p0_Pa);
    };
    struct StatedNumber {
      using Number = std::optional<double>;
      Number operator()(const PalmgrenDatum& of) const { return of.load_N; }
      Number operator()(const LundbergDatum&) const { return std::nullopt; }
      Number operator()(const LengthDatum& of) const { return of.x0_m; }
    };
    const auto datum = [](const BearingCase& body) {
      return std::pair(body.datum.index(), std::visit(StatedNumber{}, body.datum));
    };
    const auto bearing = [](const BearingCase& body) {
      [[maybe_unused]] const auto& [rollers, pitch_m, roller_m, length_m, clearance_m, density, azimuth_deg] =
          body.geometry;
      const auto& [inner_rpm, outer_rpm, load_N] = body.operation;
      return std::tuple(rollers, pitch_m, roller_m, length_m, density, azimuth_deg, body.ring_thickness_m,
                        body.roughness_m, inner_rpm, outer_rpm, load_N, body.modulus_Pa, body.poisson);
    };
    return bearing(one) == bearing(other) && lubricant(one) == lubricant(other) && datum(one) == datum(other) &&
           one.fit.load_N == other.fit.load_N && one.fit.points == other.fit.points && one.fit.of == other.fit.of;
  };
  std::vector<double> clearances;
  for (const Case& one : cases) {
    const auto* body = std::get_if<BearingCase>(&one.body);
    const auto* first = std::get_if<BearingCase>(&cases.front().body);
    if (!body || !first || !same(*first, *body)) return false;
    clearances.push_back(body->geometry.clearance_m);
  }
  std::sort(clearances.begin(), clearances.end());
  return !clearances.empty() && std::adjacent_find(clearances.begin(), clearances.end()) == clearances.end();
}

std::string verdict_of(const PaperStatement& statement) {
  if (statement.holds) return "holds";
  return statement.holds_at_top.value_or(false) ? "does not hold; at psi = 0 alone it does" : "does not hold";
}

std::string cell_of(const PaperStatement& statement) {
  return statement.holds ? "holds" : statement.holds_at_top.value_or(false) ? "at 0" : "no";
}

std::string human_statements(const std::vector<PaperStatement>& statements) {
  std::string text;
  for (const PaperStatement& statement : statements)
    text += fmt::format("  ({}) {}: {}\n      {}\n", statement.letter, verdict_of(statement), statement.statement,
                        statement.numbers);
  return text;
}

}  // namespace ehd::verification
