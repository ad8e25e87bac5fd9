// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper says of its figures, judged with computed numbers (bearing_run.hpp).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>

#include "verification/bearing_run.hpp"
#include "verification/text.hpp"

namespace ehd::verification {

namespace {

std::string format(const char* pattern, auto... values) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// The roller nearest to an azimuth [deg].
const RollerRow& roller_at(const BearingResult& result, double azimuth_deg) {
  return *std::min_element(
      result.rollers.begin(), result.rollers.end(), [&](const RollerRow& one, const RollerRow& other) {
        return std::abs(std::abs(one.azimuth_deg) - azimuth_deg) < std::abs(std::abs(other.azimuth_deg) - azimuth_deg);
      });
}

double top_force_N(const BearingResult& result) { return roller_at(result, 0).inner.force_N; }
double top_approach_m(const BearingResult& result) { return roller_at(result, 0).inner.displacement_m; }

/// (film - dry)/dry of the roller load at psi = 0.
double change_at_top(const ClearanceComparison& at) { return top_force_N(at.film) / top_force_N(at.dry) - 1; }

/// Sum over loaded rollers beyond the first pair's span where the film law carries more, less the dry one [N].
struct FurtherOut {
  double change_N = 0;   ///< sum of f_film - f_dry over the rollers that are not the nearest to psi = 0
  double largest_N = 0;  ///< change of largest size of one of them
  double largest_deg = 0;
  bool all_lower = true;  ///< no roller further out that the dry law loads carries more with the film
};
FurtherOut further_out(const ClearanceComparison& at) {
  FurtherOut result;
  const double nearest = std::abs(roller_at(at.dry, 0).azimuth_deg);
  for (std::size_t j = 0; j < at.dry.rollers.size(); ++j) {
    const double psi = std::abs(at.dry.rollers[j].azimuth_deg);
    if (psi <= nearest + 1e-9) continue;
    const double change = at.film.rollers[j].inner.force_N - at.dry.rollers[j].inner.force_N;
    result.change_N += change;
    if (at.dry.rollers[j].inner.force_N > 0 && change > 0) result.all_lower = false;
    if (std::abs(change) <= std::abs(result.largest_N)) continue;
    result.largest_N = change;
    result.largest_deg = psi;
  }
  return result;
}

int loaded_rollers(const BearingResult& result) {
  // `ehd` unloads nothing: a roller counts that carries more than a hundredth of the most loaded one.
  double largest = 0;
  for (const RollerRow& roller : result.rollers) largest = std::max(largest, roller.inner.force_N);
  int loaded = 0;
  for (const RollerRow& roller : result.rollers) loaded += roller.inner.force_N > 0.01 * largest;
  return loaded;
}

PaperStatement judge_a(const ClearanceComparison& smallest) {
  const double top = change_at_top(smallest);
  const FurtherOut further = further_out(smallest);
  return {'a',
          format("at P_d = %g um the load distributions are similar, and near psi = 0 EHD lowers the roller load",
                 1e6 * smallest.clearance_m),
          top < 0,
          format("Q(0) dry %.0f N, EHD %.0f N: %+.1f %%; the others together %+.0f N, most at %.4g deg: %+.0f N",
                 top_force_N(smallest.dry), top_force_N(smallest.film), 100 * top, further.change_N,
                 further.largest_deg, further.largest_N),
          {},
          {{"change", top}}};
}

PaperStatement judge_b(const std::vector<ClearanceComparison>& all) {
  PaperStatement statement{'b', "delta_i is considerably smaller with EHD than dry, at every clearance", true, "", {}, {}};
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  for (const ClearanceComparison& at : all) {
    const double change = top_approach_m(at.film) / top_approach_m(at.dry) - 1;
    statement.holds = statement.holds && change <= -considerably;
    least = std::max(least, change);
    most = std::min(most, change);
    statement.numbers += (statement.numbers.empty() ? "" : "; ") +
                         format("P_d %g um: delta_i(0) %.3f -> %.3f um (%+.0f %%)", 1e6 * at.clearance_m,
                                1e6 * top_approach_m(at.dry), 1e6 * top_approach_m(at.film), 100 * change);
  }
  statement.values = {{"least", least}, {"most", most}};
  return statement;
}

PaperStatement judge_c(const ClearanceComparison& smallest, const ClearanceComparison& middle,
                       const ClearanceComparison& largest) {
  const double near = change_at_top(middle), far = change_at_top(largest);
  const bool closest = std::abs(near) < std::min(std::abs(change_at_top(smallest)), std::abs(far));
  const FurtherOut further = further_out(largest);
  const bool close = std::abs(near) <= close_load;
  const bool opposite = far > 0 && further.change_N < 0;
  return {'c',
          format("at P_d = %g um EHD is close to Hertz; at %g um it raises the roller load near psi = 0 and lowers it "
                 "further out",
                 1e6 * middle.clearance_m, 1e6 * largest.clearance_m),
          close && opposite,
          format("Q(0) at %g um %.0f -> %.0f N (%+.1f %%, %s); at %g um %.0f -> %.0f N (%+.1f %%), further out %+.0f N "
                 "(%s)",
                 1e6 * middle.clearance_m, top_force_N(middle.dry), top_force_N(middle.film), 100 * near,
                 close ? "close" : "not close", 1e6 * largest.clearance_m, top_force_N(largest.dry),
                 top_force_N(largest.film), 100 * far, further.change_N, opposite ? "as said" : "not as said"),
          {{"close", close}, {"closest", closest}, {"opposite", opposite}},
          {{"middle", near}, {"largest", far}}};
}

/// With growing clearance delta_i grows at psi = 0 and falls at 90 degrees: the displacements concentrate.
PaperStatement judge_d(const std::vector<ClearanceComparison>& all) {
  PaperStatement statement{'d',
                           "with growing clearance the larger displacements concentrate near psi = 0, in both models "
                           "(the printed \"near 0 deg decrease, near 90 deg increase\" is the opposite)",
                           true,
                           "",
                           {},
                           {}};
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
      top += format("%s%.2f", comma, 1e6 * at_top);
      side += format("%s%.2f", comma, 1e6 * at_side);
      count += format("%s%d", comma, loaded_rollers(here));
    }
    statement.numbers += std::string(film ? "; EHD: " : "dry: ") + "delta_i at 0 deg " + top + " um, nearest 90 deg " +
                         side + " um, loaded rollers " + count;
  }
  return statement;
}

const BearingResult* of_law(const std::vector<BearingResult>& results, BearingLaw law) {
  for (const BearingResult& result : results) {
    if (result.law == law && !result.rollers.empty()) return &result;
  }
  return nullptr;
}

/// The cases with another datum; films are left out, since the offset film does not depend on the datum.
std::vector<ClearanceComparison> with_datum(const std::vector<Case>& cases, const Datum& datum, BearingLaw law,
                                            ContactMemory& memory, bearing::Form form) {
  std::vector<ClearanceComparison> clearances;
  for (Case one : cases) {
    auto& body = std::get<BearingCase>(one.body);
    body.datum = datum;
    const auto results =
        run_bearing(one, {.laws = {BearingLaw::hertz, law}, .explicitly = true, .films = false, .form = form}, memory);
    const BearingResult *dry = of_law(results, BearingLaw::hertz), *film = of_law(results, law);
    if (!dry || !film) return {};
    clearances.push_back({body.geometry.clearance_m, *dry, *film});
  }
  return clearances;
}

bool holds(const std::vector<PaperStatement>& statements, char letter) {
  for (const PaperStatement& statement : statements) {
    if (statement.letter == letter) return statement.holds;
  }
  return false;
}

}  // namespace

namespace {

/// One half of a statement.
bool part_holds(const std::vector<PaperStatement>& statements, char letter, const std::string& part) {
  for (const PaperStatement& statement : statements) {
    if (statement.letter != letter) continue;
    for (const auto& [name, yes] : statement.parts) {
      if (name == part) return yes;
    }
  }
  return false;
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

bool differ_only_in_clearance(const std::vector<Case>& cases) {
  const auto same = [](const BearingCase& one, const BearingCase& other) {
    const auto& [a, b] = std::pair(one.geometry, other.geometry);
    const auto lubricant = [](const BearingCase& body) {
      const BearingLubricant empty{};
      const BearingLubricant& of = body.lubricant ? *body.lubricant : empty;
      return std::tuple(body.lubricant.has_value(), of.viscosity_Pa_s, of.lubricant.viscosity, of.lubricant.density,
                        of.lubricant.alpha_per_Pa, of.lubricant.z, of.lubricant.p0_Pa);
    };
    return std::tuple(a.rollers, a.pitch_diameter_m, a.roller_diameter_m, a.length_m, a.density_kg_per_m3,
                      a.first_azimuth_deg, one.operation.inner_speed_rpm, one.operation.outer_speed_rpm,
                      one.operation.radial_load_N, one.modulus_Pa, one.poisson, one.datum.index()) ==
               std::tuple(b.rollers, b.pitch_diameter_m, b.roller_diameter_m, b.length_m, b.density_kg_per_m3,
                          b.first_azimuth_deg, other.operation.inner_speed_rpm, other.operation.outer_speed_rpm,
                          other.operation.radial_load_N, other.modulus_Pa, other.poisson, other.datum.index()) &&
           lubricant(one) == lubricant(other);
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

std::vector<DatumRow> compare_data(const std::vector<Case>& cases, BearingLaw law, ContactMemory& memory,
                                   bearing::Form form) {
  std::vector<DatumRow> rows;
  const std::vector<std::pair<std::string, Datum>> data{
      {"palmgren", PalmgrenDatum{}},         {"lundberg", LundbergDatum{}},      {"x_0 = 20 mm", LengthDatum{0.020}},
      {"x_0 = 2.5 mm", LengthDatum{0.0025}}, {"x_0 = 1 mm", LengthDatum{0.001}}, {"x_0 = 0.5 mm", LengthDatum{0.0005}}};
  for (const auto& [name, datum] : data) {
    DatumRow row{name, with_datum(cases, datum, law, memory, form), {}};
    row.statements = judge_paper_statements(row.clearances);
    if (!row.statements.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

DatumScan scan_datum(const std::vector<Case>& cases, BearingLaw law, ContactMemory& memory, bearing::Form form) {
  // From well above half the contact's half width, below which there is no law, to a metre; tenths of an octave.
  DatumScan scan;
  scan.lowest_m = 2e-4;
  scan.highest_m = 1.0;
  scan.step = std::exp2(0.1);
  std::map<char, bool> before;
  const auto extend = [](std::vector<std::pair<double, double>>& ranges, bool now, bool& was, double x) {
    if (now && was) ranges.back().second = x;
    if (now && !was) ranges.emplace_back(x, x);
    was = now;
  };
  for (double x = scan.lowest_m; x <= scan.highest_m * 1.0001; x *= scan.step) {
    const auto statements = judge_paper_statements(with_datum(cases, LengthDatum{x}, law, memory, form));
    const bool a = holds(statements, 'a'), b = holds(statements, 'b'), c = holds(statements, 'c');
    extend(scan.a_m, a, before['a'], x);
    extend(scan.b_m, b, before['b'], x);
    extend(scan.c_m, c, before['c'], x);
    extend(scan.c_close_m, part_holds(statements, 'c', "close"), before['1'], x);
    extend(scan.c_opposite_m, part_holds(statements, 'c', "opposite"), before['2'], x);
    const bool mildly = part_holds(statements, 'c', "closest") && part_holds(statements, 'c', "opposite");
    extend(scan.all_hold_m, a && b && c, before['*'], x);
    extend(scan.all_hold_mildly_m, a && b && mildly, before['~'], x);
  }
  return scan;
}

std::string human_statements(const std::vector<PaperStatement>& statements) {
  std::string text;
  for (const PaperStatement& statement : statements)
    text += std::string("  (") + statement.letter + ") " + (statement.holds ? "holds" : "does not hold") + ": " +
            statement.statement + "\n      " + statement.numbers + "\n";
  return text;
}

std::string human_data(const std::vector<DatumRow>& rows, const DatumScan& scan) {
  std::string text;
  if (!rows.empty()) {
    std::vector<std::vector<std::string>> table{{"datum"}};
    for (const ClearanceComparison& at : rows.front().clearances) {
      table.front().push_back("Q(0) N, P_d " + plain(1e6 * at.clearance_m) + " um");
      table.front().emplace_back("delta_i um");
    }
    table.front().insert(table.front().end(), {"(a)", "(b)", "(c)", "(d)"});
    for (const DatumRow& row : rows) {
      std::vector<std::string> cells{row.datum};
      for (const ClearanceComparison& at : row.clearances) {
        cells.push_back(format("%.0f/%.0f", top_force_N(at.dry), top_force_N(at.film)));
        cells.push_back(format("%.2f/%.2f", 1e6 * top_approach_m(at.dry), 1e6 * top_approach_m(at.film)));
      }
      for (const char letter : {'a', 'b', 'c', 'd'}) cells.emplace_back(holds(row.statements, letter) ? "holds" : "no");
      table.push_back(std::move(cells));
    }
    text += aligned(table, 1, "  ") + "\n";
  }
  const auto ranges = [](const std::vector<std::pair<double, double>>& list) {
    std::string words;
    for (const auto& [low, high] : list)
      words += (words.empty() ? "" : ", ") + format("%.3g to %.3g mm", 1e3 * low, 1e3 * high);
    return words.empty() ? std::string("nowhere") : words;
  };
  text += format("  x_0 scanned from %.3g to %.3g mm in steps of %.2g %%:\n", 1e3 * scan.lowest_m, 1e3 * scan.highest_m,
                 100 * (scan.step - 1));
  const auto line = [&](const char* what, const DatumScan::Ranges& list) {
    text += std::string("    ") + what + ranges(list) + "\n";
  };
  line("(a) holds ", scan.a_m);
  line("(b) holds ", scan.b_m);
  line("(c) first half, Q(0) within 2 % of dry at the middle clearance: ", scan.c_close_m);
  line("(c) second half, opposite of (a) at the largest clearance: ", scan.c_opposite_m);
  line("(a), (b) and (c) together: ", scan.all_hold_m);
  line("the same with \"close\" read as closer than at the other two clearances: ", scan.all_hold_mildly_m);
  return text;
}

}  // namespace ehd::verification
