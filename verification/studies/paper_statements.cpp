// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper says of its figures, judged with computed numbers (bearing_run.hpp).
#include "verification/studies/paper_statements.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include "contact/text.hpp"
#include "io/tables.hpp"
#include "workflow/bearing_run.hpp"

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

double largest_force_N(const BearingResult& result) {
  double largest = 0;
  for (const RollerRow& roller : result.rollers) largest = std::max(largest, roller.inner.force_N);
  return largest;
}

/// `ehd` unloads nothing: a roller counts as loaded that carries more than a hundredth of the most loaded one.
bool is_loaded(const RollerRow& roller, double largest_N) {
  return roller.inner.force_N > bearing::load_zone_share * largest_N;
}

int loaded_rollers(const BearingResult& result) {
  const double largest_N = largest_force_N(result);
  return static_cast<int>(std::count_if(result.rollers.begin(), result.rollers.end(),
                                        [&](const RollerRow& roller) { return is_loaded(roller, largest_N); }));
}

/// What the film does to the rollers that the dry law loads, those nearest to psi = 0 left out. Rollers that the dry
/// law leaves empty are no part of it: a film always pushes, so that they can only gain.
struct FurtherOut {
  double change_N = 0;    ///< sum of f_film - f_dry
  int lower = 0, of = 0;  ///< how many of them carry less with the film
};
FurtherOut further_out(const ClearanceComparison& at) {
  FurtherOut result;
  const double nearest = std::abs(roller_at(at.dry, 0).azimuth_deg), largest_N = largest_force_N(at.dry);
  for (std::size_t j = 0; j < at.dry.rollers.size(); ++j) {
    const RollerRow& dry = at.dry.rollers[j];
    if (std::abs(dry.azimuth_deg) <= nearest + 1e-9 || !is_loaded(dry, largest_N)) continue;
    const double change = at.film.rollers[j].inner.force_N - dry.inner.force_N;
    result.change_N += change;
    result.lower += change < 0;
    ++result.of;
  }
  return result;
}
std::string words_of(const FurtherOut& further) {
  return format("further out %+.0f N, %d of %d rollers that dry loads carry less", further.change_N, further.lower,
                further.of);
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
    if (std::isnan(most.change_N)) break;  // which is similar to nothing
    if (!(std::abs(change) <= std::abs(most.change_N))) most = {0, change, std::abs(at.dry.rollers[j].azimuth_deg)};
  }
  most.share = std::abs(most.change_N) / largest_force_N(at.dry);
  return most;
}

PaperStatement judge_a(const ClearanceComparison& smallest) {
  const double top = change_at_top(smallest);
  const Apart most = apart(smallest);
  const bool similar = most.share <= similar_load, lower = top < 0;
  return {
      'a',
      format("at P_d = %g um the load distributions are similar, and near psi = 0 EHD lowers the roller load",
             1e6 * smallest.clearance_m),
      similar && lower,
      format(
          "Q(0) dry %.0f N, EHD %.0f N: %+.1f %%; furthest apart at %.4g deg: %+.0f N, %.1f %% of the largest dry load "
          "(%s: at most %g %%); %s",
          top_force_N(smallest.dry), top_force_N(smallest.film), 100 * top, most.azimuth_deg, most.change_N,
          100 * most.share, similar ? "similar" : "not similar", 100 * similar_load,
          words_of(further_out(smallest)).c_str()),
      {{"similar", similar}, {"lower", lower}},
      {{"change", top}, {"apart", most.share}}};
}

PaperStatement judge_b(const std::vector<ClearanceComparison>& all) {
  PaperStatement statement{'b', "delta_i is considerably smaller with EHD than dry, at every clearance", true, "", {},
                           {}};
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
          format("Q(0) at %g um %.0f -> %.0f N (%+.1f %%, %s); at %g um %.0f -> %.0f N (%+.1f %%), %s (%s)",
                 1e6 * middle.clearance_m, top_force_N(middle.dry), top_force_N(middle.film), 100 * near,
                 close ? "close" : "not close", 1e6 * largest.clearance_m, top_force_N(largest.dry),
                 top_force_N(largest.film), 100 * far, words_of(further).c_str(), opposite ? "as said" : "not as said"),
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

const BearingResult* of_law(const std::vector<BearingResult>& results, bearing::Law law) {
  for (const BearingResult& result : results) {
    if (result.law == law && !result.rollers.empty()) return &result;
  }
  return nullptr;
}

/// The dry balances, which no datum changes; empty where one is missing.
std::vector<BearingResult> dry_balances(const std::vector<Case>& cases, ContactMemory& memory, bearing::Form form) {
  std::vector<BearingResult> dry;
  for (const Case& one : cases) {
    const auto results =
        run_bearing(one, {.laws = {bearing::Law::hertz}, .explicitly = true, .films = false, .form = form}, memory);
    const BearingResult* const found = of_law(results, bearing::Law::hertz);
    if (!found) return {};
    dry.push_back(*found);
  }
  return dry;
}

/// The cases with another datum; films are left out, since the offset film does not depend on the datum.
std::vector<ClearanceComparison> with_datum(const std::vector<Case>& cases, const std::vector<BearingResult>& dry,
                                            const Datum& datum, bearing::Law law, ContactMemory& memory,
                                            bearing::Form form) {
  std::vector<ClearanceComparison> clearances;
  if (dry.size() != cases.size()) return clearances;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    Case one = cases[k];
    auto& body = std::get<BearingCase>(one.body);
    body.datum = datum;
    const auto results = run_bearing(one, {.laws = {law}, .explicitly = true, .films = false, .form = form}, memory);
    const BearingResult* const film = of_law(results, law);
    if (!film) return {};
    clearances.push_back({body.geometry.clearance_m, dry[k], *film});
  }
  return clearances;
}

bool holds(const std::vector<PaperStatement>& statements, char letter) {
  for (const PaperStatement& statement : statements) {
    if (statement.letter == letter) return statement.holds;
  }
  return false;
}

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

double value_of(const std::vector<PaperStatement>& statements, char letter, const std::string& wanted) {
  for (const PaperStatement& statement : statements) {
    if (statement.letter != letter) continue;
    for (const auto& [name, value] : statement.values) {
      if (name == wanted) return value;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The half width of the heaviest dry contact of all balances, b = 2 f/(pi l p_H); 0 where nothing is loaded.
double heaviest_half_width_m(const std::vector<BearingResult>& dry, double length_m) {
  double widest = 0;
  for (const BearingResult& result : dry)
    for (const RollerRow& roller : result.rollers)
      for (const ContactRow* contact : {&roller.inner, &roller.outer})
        if (contact->hertz_pressure_Pa)
          widest = std::max(widest, 2 * contact->force_N / (std::numbers::pi * length_m * *contact->hertz_pressure_Pa));
  return widest;
}

using Judged = std::vector<PaperStatement>;  ///< empty where a balance is missing
using Reading = std::function<bool(const Judged&)>;

/// Where a reading holds: between two scanned lengths that differ the end is sought by bisection, and is the last
/// length found at which it holds, so that a list never claims more than was judged.
DatumScan::Ranges ranges_of(const Reading& reading, const std::vector<double>& scanned,
                            const std::function<const Judged&(double)>& judged, double precision) {
  const auto yes = [&](double x) { return reading(judged(x)); };
  const auto end_between = [&](double holds_at, double fails_at) {
    while (std::max(holds_at, fails_at) > precision * std::min(holds_at, fails_at)) {
      const double middle = std::sqrt(holds_at * fails_at);
      (yes(middle) ? holds_at : fails_at) = middle;
    }
    return holds_at;
  };
  DatumScan::Ranges ranges;
  for (std::size_t k = 0; k < scanned.size(); ++k) {
    const bool now = yes(scanned[k]), before = k > 0 && yes(scanned[k - 1]);
    if (now && !before) {
      const double low = k > 0 ? end_between(scanned[k], scanned[k - 1]) : scanned[k];
      ranges.emplace_back(low, scanned[k]);
    }
    if (now) ranges.back().second = scanned[k];
    if (!now && before) ranges.back().second = end_between(scanned[k - 1], scanned[k]);
  }
  return ranges;
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
    const auto lubricant = [](const BearingCase& body) {
      const BearingLubricant empty{};
      const BearingLubricant& of = body.lubricant ? *body.lubricant : empty;
      return std::tuple(body.lubricant.has_value(), of.viscosity_Pa_s, of.lubricant.viscosity, of.lubricant.density,
                        of.lubricant.alpha_per_Pa, of.lubricant.z, of.lubricant.p0_Pa);
    };
    const auto datum = [](const BearingCase& body) {
      const auto* palmgren = std::get_if<PalmgrenDatum>(&body.datum);
      const auto* length = std::get_if<LengthDatum>(&body.datum);
      return std::tuple(body.datum.index(), palmgren ? palmgren->load_N : std::nullopt, length ? length->x0_m : 0.0);
    };
    const auto bearing = [](const BearingCase& body) {
      const BearingGeometry& of = body.geometry;
      return std::tuple(of.rollers, of.pitch_diameter_m, of.roller_diameter_m, of.length_m, of.density_kg_per_m3,
                        of.first_azimuth_deg, of.ring_thickness_m, body.operation.inner_speed_rpm,
                        body.operation.outer_speed_rpm, body.operation.radial_load_N, body.modulus_Pa, body.poisson);
    };
    return bearing(one) == bearing(other) && lubricant(one) == lubricant(other) && datum(one) == datum(other) &&
           one.fit.load_N == other.fit.load_N && one.fit.points == other.fit.points;
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

std::vector<DatumRow> compare_data(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory,
                                   bearing::Form form) {
  std::vector<DatumRow> rows;
  const std::vector<std::pair<std::string, Datum>> data{
      {"palmgren", PalmgrenDatum{}},         {"lundberg", LundbergDatum{}},      {"x_0 = 20 mm", LengthDatum{0.020}},
      {"x_0 = 2.5 mm", LengthDatum{0.0025}}, {"x_0 = 1 mm", LengthDatum{0.001}}, {"x_0 = 0.5 mm", LengthDatum{0.0005}}};
  const auto dry = dry_balances(cases, memory, form);
  for (const auto& [name, datum] : data) {
    DatumRow row{name, with_datum(cases, dry, datum, law, memory, form), {}};
    row.statements = judge_paper_statements(row.clearances);
    if (!row.statements.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

DatumScan scan_datum(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory, bearing::Form form) {
  DatumScan scan;
  const auto dry = dry_balances(cases, memory, form);
  const auto* const body = cases.empty() ? nullptr : std::get_if<BearingCase>(&cases.front().body);
  scan.half_width_m = body ? heaviest_half_width_m(dry, body->geometry.length_m) : 0;
  if (!(scan.half_width_m > 0)) return scan;
  // An approach grows with the load where x_0 > b/2; 0.6 b leaves a tenth of b for loads above the dry ones. A law that
  // asks for more than that has no balance there, which `balanced_m` says.
  scan.lowest_m = 0.6 * scan.half_width_m;
  scan.step = std::exp2(0.1);
  scan.precision = 1.005;  // an end is asked for to one per cent
  std::vector<double> scanned;
  for (double x = scan.lowest_m; x < 1.0; x *= scan.step) scanned.push_back(x);  // a metre: longer than any roller
  if (scanned.empty()) return scan;
  scan.highest_m = scanned.back();
  std::map<double, Judged> known;
  const auto judged = [&](double x) -> const Judged& {
    const auto found = known.find(x);
    if (found != known.end()) return found->second;
    return known.emplace(x, judge_paper_statements(with_datum(cases, dry, LengthDatum{x}, law, memory, form)))
        .first->second;
  };
  const auto find = [&](const Reading& reading) { return ranges_of(reading, scanned, judged, scan.precision); };
  const auto letters = [](const std::string& wanted) {
    return [wanted](const Judged& of) {
      return std::all_of(wanted.begin(), wanted.end(), [&](char letter) { return holds(of, letter); });
    };
  };
  const auto part = [](char letter, const char* name) {
    return [letter, name](const Judged& of) { return part_holds(of, letter, name); };
  };
  const auto both = [](const Reading& one, const Reading& other) {
    return [one, other](const Judged& of) { return one(of) && other(of); };
  };
  scan.balanced_m = find([](const Judged& of) { return !of.empty(); });
  scan.a_m = find(letters("a"));
  scan.a_similar_m = find(part('a', "similar"));
  scan.a_lower_m = find(part('a', "lower"));
  scan.b_m = find(letters("b"));
  scan.c_m = find(letters("c"));
  scan.c_close_m = find(part('c', "close"));
  scan.c_opposite_m = find(part('c', "opposite"));
  scan.d_m = find(letters("d"));
  scan.abc_m = find(letters("abc"));
  scan.all_hold_m = find(letters("abcd"));
  const Reading by_sign = both(part('a', "lower"), letters("bcd"));
  scan.sign_of_a_m = find(by_sign);
  for (const auto& [x, of] : known) {
    if (!by_sign(of)) continue;
    const double share = value_of(of, 'a', "apart");
    auto& range = scan.apart_there;
    range = range ? std::pair(std::min(range->first, share), std::max(range->second, share)) : std::pair(share, share);
  }
  scan.all_hold_mildly_m = find(both(letters("abd"), both(part('c', "closest"), part('c', "opposite"))));
  return scan;
}

std::string words_of(const DatumScan& scan, const DatumScan::Ranges& ranges, int digits) {
  // The rounding of a search of its own may part an end from the scan's by less than what is sought.
  const auto same = [&](double one, double other) { return std::abs(std::log(one / other)) < 1e-9; };
  const auto end = [&](double x, bool low) {
    std::string text = plain(1e3 * x, digits);
    if (same(x, low ? scan.lowest_m : scan.highest_m)) return text + " (the scan's end)";
    for (const auto& [from, to] : scan.balanced_m)
      if (same(x, low ? from : to)) return text + " (no balance beyond)";
    return text;
  };
  std::string words;
  for (const auto& [low, high] : ranges)
    words += (words.empty() ? "" : ", ") + end(low, true) + " to " + end(high, false) + " mm";
  return words.empty() ? "nowhere" : words;
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
  text += format(
      "  x_0 scanned from %.3g mm, 0.6 of the half width of the heaviest dry contact (half of it: no law), to %.3g mm "
      "in steps of %.2g %%, ends to %.2g %%; what is narrower than a step may be missed:\n",
      1e3 * scan.lowest_m, 1e3 * scan.highest_m, 100 * (scan.step - 1), 100 * (scan.precision - 1));
  const auto line = [&](const std::string& what, const DatumScan::Ranges& list) {
    text += "    " + what + ": " + words_of(scan, list) + "\n";
  };
  const std::string close = plain(100 * close_load) + " %", similar = plain(100 * similar_load) + " %";
  line("there is a balance", scan.balanced_m);
  line("(a) holds", scan.a_m);
  line("(a) first half, similar: no roller's load more than " + similar + " of the largest dry load from its dry one",
       scan.a_similar_m);
  line("(a) second half, Q(0) lower than dry at the smallest clearance", scan.a_lower_m);
  line("(b) holds", scan.b_m);
  line("(c) holds", scan.c_m);
  line("(c) first half, Q(0) within " + close + " of dry at the middle clearance", scan.c_close_m);
  line("(c) second half, opposite of (a) at the largest clearance", scan.c_opposite_m);
  line("(d) holds", scan.d_m);
  line("(a), (b) and (c) together", scan.abc_m);
  line("(a), (b), (c) and (d) together", scan.all_hold_m);
  line("the same with the second half of (a) alone, its sign at psi = 0", scan.sign_of_a_m);
  if (scan.apart_there)
    text += format(
        "      there the loads are %.1f to %.1f %% of the largest dry load apart, where \"similar\" asks for %s\n",
        100 * scan.apart_there->first, 100 * scan.apart_there->second, similar.c_str());
  line("all four with \"close\" in (c) read as closer than at the other two clearances", scan.all_hold_mildly_m);
  return text;
}

}  // namespace ehd::verification
