// SPDX-License-Identifier: GPL-3.0-or-later
// How the paper's statements depend on the datum x_0 (paper_statements.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "contact/text.hpp"
#include "io/tables.hpp"
#include "verification/studies/paper_statements.hpp"
#include "workflow/bearing_run.hpp"

namespace ehd::verification {

namespace {

/// The dry balances: the datum does not change them. Empty where one is missing.
std::vector<BearingResult> dry_balances(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory,
                                        bearing::Form form) {
  std::vector<BearingResult> dry;
  for (const Case& one : cases) {
    const auto results = run_bearing(one, {.laws = {law}, .explicitly = true, .films = false, .form = form}, memory);
    const BearingResult* const found = balance_by(law, results);
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
    const BearingResult* const film = balance_by(law, results);
    if (!film) return {};
    clearances.push_back({body.geometry.clearance_m, dry[k], *film});
  }
  return clearances;
}

bool holds(const std::vector<PaperStatement>& statements, char letter) {
  const PaperStatement* const one = find_statement(statements, letter);
  return one && one->holds;
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

/// The lengths at which a reading holds. Between two scanned lengths with different answers bisection finds the end:
/// the last length at which the reading was found to hold, so that a range never claims more than was judged.
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

std::vector<DatumRow> compare_data(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory,
                                   bearing::Form form) {
  std::vector<DatumRow> rows;
  const std::vector<std::pair<std::string, Datum>> data{
      {"palmgren", PalmgrenDatum{}},         {"lundberg", LundbergDatum{}},      {"x_0 = 20 mm", LengthDatum{0.020}},
      {"x_0 = 2.5 mm", LengthDatum{0.0025}}, {"x_0 = 1 mm", LengthDatum{0.001}}, {"x_0 = 0.5 mm", LengthDatum{0.0005}}};
  const auto dry = dry_balances(cases, bearing::Law::hertz, memory, form);
  for (const auto& [name, datum] : data) {
    DatumRow row{name, with_datum(cases, dry, datum, law, memory, form), {}};
    row.statements = judge_paper_statements(row.clearances);
    if (!row.statements.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

DatumScan scan_datum(const std::vector<Case>& cases, bearing::Law law, ContactMemory& memory, bearing::Form form,
                     bearing::Law dry_law) {
  DatumScan scan;
  const auto dry = dry_balances(cases, dry_law, memory, form);
  const auto* const body = cases.empty() ? nullptr : std::get_if<BearingCase>(&cases.front().body);
  scan.half_width_m = body ? heaviest_half_width_m(dry, body->geometry.length_m) : 0;
  if (!(scan.half_width_m > 0)) return scan;
  // An approach grows with the load where x_0 > b/2; 0.6 b leaves a tenth of b for loads above the dry ones. A law that
  // needs a longer x_0 has no balance there; `balanced_m` shows that.
  scan.lowest_m = 0.6 * scan.half_width_m;
  scan.step = std::exp2(0.1);
  scan.precision = 1.005;  // ends are printed to about one per cent
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
    return [letter, name](const Judged& of) {
      const PaperStatement* const one = find_statement(of, letter);
      return one && one->part(name).value();
    };
  };
  const auto at_top = [](const std::string& wanted) {
    return [wanted](const Judged& of) {
      return std::all_of(wanted.begin(), wanted.end(), [&](char letter) {
        const PaperStatement* const one = find_statement(of, letter);
        return one && one->holds_at_top.value_or(one->holds);
      });
    };
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
  scan.b_at_top_m = find(at_top("b"));
  scan.c_at_top_m = find(at_top("c"));
  scan.c_close_m = find(part('c', "close at psi = 0"));
  scan.c_opposite_m = find(part('c', "opposite"));
  scan.d_m = find(letters("d"));
  scan.abc_m = find(letters("abc"));
  scan.all_hold_m = find(letters("abcd"));
  const Reading all_at_top = at_top("abcd");
  scan.at_top_m = find(all_at_top);
  for (const auto& [x, of] : known) {
    if (!all_at_top(of)) continue;
    const double share = find_statement(of, 'a')->value("apart").value();
    auto& range = scan.apart_there;
    range = range ? std::pair(std::min(range->first, share), std::max(range->second, share)) : std::pair(share, share);
  }
  scan.all_hold_mildly_m =
      find(both(both(letters("ad"), at_top("b")), both(part('c', "closest"), part('c', "opposite"))));
  return scan;
}

std::string words_of(const DatumScan& scan, const DatumScan::Ranges& ranges, int digits) {
  // Two searches may find the same end with different rounding, far below the precision of the scan.
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
    words += fmt::format("{}{} to {} mm", words.empty() ? "" : ", ", end(low, true), end(high, false));
  return words.empty() ? "nowhere" : words;
}

std::string human_data(const std::vector<DatumRow>& rows, const DatumScan& scan) {
  std::string text;
  if (!rows.empty()) {
    std::vector<std::vector<std::string>> table{{"datum"}};
    for (const ClearanceComparison& at : rows.front().clearances) {
      table.front().push_back(fmt::format("f_i(0) N, P_d {} um", plain(1e6 * at.clearance_m)));
      table.front().emplace_back("delta_i um");
    }
    table.front().insert(table.front().end(), {"(a)", "(b)", "(c)", "(d)"});
    for (const DatumRow& row : rows) {
      std::vector<std::string> cells{row.datum};
      for (const ClearanceComparison& at : row.clearances) {
        cells.push_back(fmt::format("{:.0f}/{:.0f}", top_force_N(at.dry), top_force_N(at.film)));
        cells.push_back(fmt::format("{:.2f}/{:.2f}", 1e6 * top_approach_m(at.dry), 1e6 * top_approach_m(at.film)));
      }
      for (const char letter : statement_letters) cells.push_back(cell_of(*find_statement(row.statements, letter)));
      table.push_back(std::move(cells));
    }
    text += aligned_in_parts(table, 1, "  ") + "\n";
  }
  text += fmt::format(
      "  x_0 scanned from {:.3g} mm, 0.6 of the half width of the heaviest dry contact (half of it: no law), to {:.3g} "
      "mm "
      "in steps of {:.2g} %, ends to {:.2g} %; what is narrower than a step may be missed:\n",
      1e3 * scan.lowest_m, 1e3 * scan.highest_m, 100 * (scan.step - 1), 100 * (scan.precision - 1));
  const auto line = [&](const std::string& what, const DatumScan::Ranges& list) {
    text += fmt::format("    {}: {}\n", what, words_of(scan, list));
  };
  const std::string similar = percent(similar_load);
  line("there is a balance", scan.balanced_m);
  line("(a) holds", scan.a_m);
  line(fmt::format("(a) first half, similar: no roller's load more than {} of the largest dry load from its dry one",
                   similar),
       scan.a_similar_m);
  line("(a) second half, f_i(0) lower than dry at the smallest clearance", scan.a_lower_m);
  line("(b) holds", scan.b_m);
  line("(b) at psi = 0 alone", scan.b_at_top_m);
  line("(c) holds", scan.c_m);
  line("(c) at psi = 0 alone", scan.c_at_top_m);
  line(fmt::format("(c) first half, f_i(0) within {} of dry at the middle clearance", percent(close_load)),
       scan.c_close_m);
  line("(c) second half, opposite of (a) at the largest clearance", scan.c_opposite_m);
  line("(d) holds", scan.d_m);
  line("(a), (b) and (c) together", scan.abc_m);
  line("(a), (b), (c) and (d) together", scan.all_hold_m);
  line("the same, each judged at psi = 0 alone", scan.at_top_m);
  if (scan.apart_there)
    text += fmt::format(
        "      there the loads are {:.1f} to {:.1f} % of the largest dry load apart, where \"similar\" asks for {}\n",
        100 * scan.apart_there->first, 100 * scan.apart_there->second, similar);
  line("all four with (b) at psi = 0 and \"close\" in (c) read as closer there than at the other two clearances",
       scan.all_hold_mildly_m);
  return text;
}

}  // namespace ehd::verification
