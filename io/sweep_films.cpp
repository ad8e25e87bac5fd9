// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/sweep_films.hpp"

#include <fmt/format.h>

#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/sweep_source.hpp"
#include "workflow/film_table_build.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

/// [LOW, HIGH] with least <= LOW < HIGH <= most.
std::pair<double, double> table_ends(const SweepSource& source, const toml::table& table, const char* key, double least,
                                     double most) {
  const std::string allowed = fmt::format("[LOW, HIGH] with {} <= LOW < HIGH <= {}", plain(least), plain(most));
  const toml::node* node = table.get(key);
  if (!node) source.fail(line_of(table), "[table]", fmt::format("{} is missing; required is {}", key, allowed));
  const std::string name = std::string("table.") + key;
  const toml::array* ends = node->as_array();
  if (!ends) source.fail_type(name, *node, allowed);
  const auto low = ends->size() == 2 ? number_of((*ends)[0]) : std::nullopt;
  const auto high = ends->size() == 2 ? number_of((*ends)[1]) : std::nullopt;
  if (!low || !high || !(*low >= least && *low < *high && *high <= most))
    source.fail(name, *node, "is no range; allowed is " + allowed);
  return {*low, *high};
}

FilmTableRequest table_request(const Sweep& sweep) {
  return {.range = sweep.table->range, .tolerance = sweep.tolerance};
}

}  // namespace

void read_films(const SweepSource& source, Sweep& sweep) {
  const toml::node *films = source.root().get("films"), *node = source.root().get("table");
  const bool asked = films && source.choice("films", *films, {"solve", "table"}) == "table";
  if (!asked) {
    if (node) source.fail("table", *node, "belongs to films = \"table\"; allowed without it is no [table]");
    return;
  }
  if (sweep.bearing)
    source.fail("films", *films, "belongs to the sweep of a contact; allowed is no films for a bearing");
  if (sweep.solver != default_solver().name)
    source.fail("films", *films,
                fmt::format("is made by {}; allowed is that solver, not {}", default_solver().name, sweep.solver));
  const toml::table* table = node ? node->as_table() : nullptr;
  if (!table) source.missing("[table]", "[table] with M = [LOW, HIGH] and L = [LOW, HIGH]");
  source.require_known(*table, " in [table]", {"M", "L"});
  const auto [M_low, M_high] = table_ends(source, *table, "M", smallest_M, largest_M);
  const auto [L_low, L_high] = table_ends(source, *table, "L", 0, largest_L);
  sweep.table = {.range = {.M_low = M_low, .M_high = M_high, .L_low = L_low, .L_high = L_high},
                 .oil = table_oil(read_case(sweep.case_text, sweep.case_file))};
}

void require_in_table(const SweepTable& table, const Case& row_case) {
  if (!same_oil(table_oil(row_case), table.oil))
    throw case_error(row_case, "lubricant",
                     "the oil or the inlet differs from the table's; allowed are those of the case");
  const auto& contact = std::get<ContactCase>(row_case.body);
  const Groups groups = nondimensionalise(contact.statement, *contact.lubricant, *contact.inlet).problem.groups;
  const FilmRange& range = table.range;
  if (!range.contains({.M = groups.M, .L = groups.L}))
    throw case_error(
        row_case, "",
        fmt::format("M = {}, L = {} is outside the table; allowed is M {} to {}, L {} to {}", plain(groups.M),
                    plain(groups.L), plain(range.M_low), plain(range.M_high), plain(range.L_low), plain(range.L_high)));
}

FilmTable build_table(const Sweep& sweep, const SweepRequest& request) {
  const FilmTableRequest asked = table_request(sweep);
  return build_film_table(
      sweep.table->oil, asked,
      film_solves(sweep.table->oil, asked.tolerance, request.threads, request.time_limit_s, request.deadline));
}

}  // namespace ehd
