// SPDX-License-Identifier: GPL-3.0-or-later
// ehd maps: the film formulas and the cut inlet over M and L, from the atlas.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/quantities.hpp"
#include "io/case_keys.hpp"
#include "verification/atlas/atlas.hpp"
#include "verification/studies/film_maps.hpp"
#include "verification/studies/motion_maps.hpp"
#include "verification/studies/table_beside_formulas.hpp"

namespace ehd::cli {

namespace {

struct MapsOptions {
  std::optional<std::string> output, quantity;
  std::string laws = "roelands";
  bool table = false, motion = false;
};

const char* const maps_examples = R"(
Examples:
  ehd maps                                      every formula, Roelands and compressible
  ehd maps --quantity film.minimum --laws barus
  ehd maps --table                              the formulas beside a table of films, as ehd export films makes it
  ehd maps --motion                             stiffness, damping and waviness over M and L
  ehd maps --output out/maps                    leaves formula_maps.csv and inlet_maps.csv: all films and laws

The numbers are the certified ones of cases/atlas, which ehd atlas made. Only --table solves; nothing is judged.)";

/// The films of the atlas that a formula is about.
constexpr std::array map_films{Quantity::film_minimum, Quantity::film_central, Quantity::film_couette};

Quantity film_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Quantity film : map_films) names.emplace_back(to_string(film));
  const auto quantity = quantity_from(name);
  if (!quantity) throw unknown_word_error("--quantity", name, list(names));
  if (std::ranges::find(map_films, *quantity) == map_films.end())
    throw option_error("--quantity", name, "has no formula, and so no map; allowed is " + list(names));
  return *quantity;
}

int maps(const MapsOptions& options) {
  const auto quantity = options.quantity ? std::optional(film_named(*options.quantity)) : std::nullopt;
  const auto laws = verification::atlas_laws_from(options.laws);
  if (!laws || *laws == verification::AtlasLaws::isoviscous)  // L = 0 is a row of both maps
    throw unknown_word_error("--laws", options.laws, "roelands, barus");
  if (options.table && (options.output || options.quantity))
    throw UsageError("maps: --table excludes --output and --quantity; allowed is --table alone");
  if (options.motion && (options.table || options.output || options.quantity))
    throw UsageError("maps: --motion excludes --table, --output and --quantity; allowed is --motion alone");
  if (options.motion) {
    print(verification::human_motion_maps(verification::motion_maps(verification::atlas_folder())));
    return success;
  }
  const auto all = verification::film_maps(verification::atlas_folder());
  if (options.table) {
    const FilmTable table = verification::table_of_the_atlas(0);
    if (!table.panels.empty()) print(verification::table_beside_formulas(all, table));
    if (table.status == StopReason::converged) return success;
    complain(fmt::format("ehd: maps: {}: {}", to_string(table.status), table.reason));
    return not_met;
  }
  OutputFolder folder(options.output);
  folder.open({"formula_maps.csv", "inlet_maps.csv"});
  folder.write("formula_maps.csv", formula_maps_csv(all));
  folder.write("inlet_maps.csv", inlet_maps_csv(all));
  folder.commit();
  print(human_maps(all, quantity, *laws));
  return success;
}

}  // namespace

void describe_maps(Command& command) {
  auto options = std::make_shared<MapsOptions>();
  command.summary("Film formulas and cut inlets against certified films, over M and L");
  command.examples(maps_examples);
  command.text("--output", options->output, "folder for formula_maps.csv and inlet_maps.csv").called("DIR");
  command.text("--quantity", options->quantity, "film.minimum, film.central (with film.couette) or film.couette (all)")
      .called("FILM");
  command.text("--laws", options->laws, "roelands or barus (roelands)").called("LAWS");
  command.flag("--table", options->table, "a table of films beside the formulas");
  command.flag("--motion", options->motion, "stiffness, damping and waviness over M and L");
  command.runs([options] { return maps(*options); });
}

}  // namespace ehd::cli
