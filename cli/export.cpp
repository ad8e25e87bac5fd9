// SPDX-License-Identifier: GPL-3.0-or-later
// ehd export: numbers for another program. The films of one oil as a table; the law of a raceway (export_law).
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "bearing/law_table.hpp"
#include "cli/case_choice.hpp"
#include "cli/export_law.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "contact/nondimensional.hpp"
#include "contact/text.hpp"
#include "io/duration.hpp"
#include "io/film_table_c.hpp"
#include "io/film_table_text.hpp"
#include "io/output_file.hpp"
#include "workflow/case.hpp"
#include "workflow/film_table_build.hpp"

namespace ehd::cli {

namespace {

struct ExportOptions {
  std::string what, case_name;
  std::optional<std::string> M, L, output, threads, most_solves, time_limit_total;
  LawExportOptions law;  ///< --raceway, --law and --knots; the others are shared
  std::string format = "csv";
  RequestOptions request;
  CaseChanges changes;
};

const char* const export_examples = R"(
Examples:
  ehd export films own-moes-20-10 --M 2:1000 --L 2.5:20                the oil of the case, to 1e-4, as CSV
  ehd export films my-bearing.toml --M 5:500 --L 5:15 --tolerance 1e-3 --format json
  ehd export films own-moes-20-10 --M 2:1000 --L 2.5:20 --format c --output films.c
  ehd export law na4908 --raceway inner --format c --output inner.c    force, stiffness, film and damping over delta
  ehd export law na4908 --raceway outer --format matlab --output ehd_na4908_outer_law.m

films: minimum, central and Couette film and the offset H_0 over M and L, as Chebyshev coefficients
(docs/films-table.md). The C form has a function that evaluates them, with derivatives. Further solves, which the table
does not use, measure its errors.

law: force, stiffness, film and damping of a raceway over the approach, as knots with cubic Hermite polynomials between
them (docs/law-table.md). The C and MATLAB forms have a function that evaluates them. The file states the error of the
law and that of the table.

Exit code: 0 the table meets the tolerance; 1 it does not (the file says how far), or a contact was not solved;
2 bad input or usage.)";

/// LOW:HIGH inside a range.
struct Ends {
  double low = 0, high = 0;
};
Ends ends_from(const char* option, const std::optional<std::string>& text, double least, double most) {
  const std::string allowed =
      fmt::format("; allowed is LOW:HIGH with {} <= LOW < HIGH <= {}", plain(least), plain(most));
  if (!text) throw UsageError(fmt::format("export films: {} is missing{}", option, allowed));
  const auto colon = text->find(':');
  if (colon == std::string::npos) throw option_error(option, *text, "is no range" + allowed);
  Ends ends;
  try {
    const Interval range{.low = least, .high = most};
    ends = {.low = parse_number(option, text->substr(0, colon), range),
            .high = parse_number(option, text->substr(colon + 1), range)};
  } catch (const UsageError&) {
    throw option_error(option, *text, "is no range" + allowed);
  }
  if (!(ends.low < ends.high)) throw option_error(option, *text, "is empty" + allowed);
  return ends;
}

using Writer = std::function<std::string(const FilmTable& table)>;
Writer writer_named(const std::string& format, const CaseChanges& changes) {
  if (format == "csv") return film_table_csv;
  if (format == "json")
    return [changes](const FilmTable& table) {
      Json json = to_json(table);
      changes.put_into(json);
      return json_text(json);
    };
  if (format == "c") return film_table_c;
  throw unknown_word_error("--format", format, "csv, json, c");
}

/// The table, with the contacts solved so far shown on a terminal.
FilmTable build(const TableOil& oil, const FilmTableRequest& request, const ExportOptions& options) {
  const FilmSource solves = film_solves(oil, request.tolerance, thread_count(options.threads),
                                        options.request.request().time_limit_s, deadline_in(options.time_limit_total));
  Progress progress;
  std::size_t solved = 0;
  return build_film_table(oil, request, [&](const std::vector<MoesGroups>& contacts) {
    progress.step(solved, solved + contacts.size(), "contacts; their errors may ask for more");
    solved += contacts.size();
    return solves(contacts);
  });
}

int export_films(const ExportOptions& options) {
  const Writer write = writer_named(options.format, options.changes);
  const Ends M = ends_from("--M", options.M, smallest_M, largest_M), L = ends_from("--L", options.L, 0, largest_L);
  FilmTableRequest request{.range = {.M_low = M.low, .M_high = M.high, .L_low = L.low, .L_high = L.high}};
  if (options.request.tolerance) request.tolerance = options.request.request().tolerance.tightest();
  const allowed::Integer solve_counts{.low = static_cast<int>(fewest_solves(request.range)), .high = 1000000};
  if (options.most_solves) request.most_solves = parse_integer("--max-solves", *options.most_solves, solve_counts);
  const Case stated = options.changes.read(options.case_name);
  const TableOil oil = table_oil(stated);
  require_distinct({{"the case", stated.file}}, {{"--output", options.output.value_or("")}});
  std::optional<OutputFile> file = opened(options.output);

  const auto begin = std::chrono::steady_clock::now();
  FilmTable table = build(oil, request, options);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  table.case_id = stated.id;
  table.version = stated.version;
  table.title = stated.title;
  if (!table.panels.empty()) {
    if (file) {
      file->append(write(table));
      file->commit();
      for (const std::string& line : film_table_words(table)) print(line + "\n");
      print(fmt::format("time {}\n", duration(passed.count())));
    } else {
      print(write(table));
    }
  }
  if (table.status == StopReason::converged) return success;
  complain(fmt::format("ehd: export films: {}: {}; {}", to_string(table.status), table.reason,
                       table.panels.empty() ? "there is no table" : "a smaller range of M or L needs less"));
  return not_met;
}

/// An option of the other table would have no effect. Throws UsageError.
void require_own_options(const ExportOptions& options) {
  using Given = std::pair<const char*, const std::optional<std::string>&>;
  const auto refuse = [](std::initializer_list<Given> given, const char* owner) {
    for (const auto& [name, value] : given)
      if (value)
        throw option_error(name, *value, std::string("belongs to export ") + owner + "; allowed is without it");
  };
  if (options.what == "films")
    refuse({{"--raceway", options.law.raceway}, {"--law", options.law.law}, {"--knots", options.law.knots}}, "law");
  if (options.what == "law")
    refuse({{"--M", options.M},
            {"--L", options.L},
            {"--tolerance", options.request.tolerance},
            {"--threads", options.threads},
            {"--max-solves", options.most_solves}},
           "films");
}

int export_any(const ExportOptions& options) {
  require_own_options(options);
  if (options.what == "films") return export_films(options);
  if (options.what != "law") throw unknown_word_error("export: WHAT", options.what, "films, law");
  LawExportOptions law = options.law;
  law.case_name = options.case_name;
  law.changes = options.changes;
  law.format = options.format;
  law.output = options.output;
  law.time_limit = options.request.time_limit;
  law.time_limit_total = options.time_limit_total;
  return export_law(law);
}

}  // namespace

void describe_export(Command& command) {
  auto options = std::make_shared<ExportOptions>();
  command.summary("Tables for other programs: the films of one oil, or the contact force law of a raceway");
  command.examples(export_examples);
  command.text("WHAT", options->what, "films or law").required().completed_by("films, law");
  command
      .text("CASE", options->case_name,
            "films: a contact or a bearing, whose oil the table is for; law: a bearing. A file (TOML) or an id")
      .required();
  command.text("--raceway", options->law.raceway, "law: inner or outer").called("RACEWAY").completed_by("inner, outer");
  command.text("--law", options->law.law, "law: ehd, also where nothing is said; the other laws are formulas")
      .completed_by(std::string(to_string(bearing::Law::ehd)));
  command.text("--knots", options->law.knots, "law: number of knots (32)").called("N");
  command.text("--M", options->M, "range of Moes' load group").called("LOW:HIGH");
  command.text("--L", options->L, "range of Moes' lubricant group").called("LOW:HIGH");
  command.text("--tolerance", options->request.tolerance, "error allowed in every film of the table (1e-4)")
      .called("T");
  command.text("--format", options->format, "csv, json or c; law: matlab too")
      .called("FORMAT")
      .showing_default()
      .completed_by("csv, json, c, matlab");
  command.text("--output", options->output, "write the table into a file (standard output)").called("FILE");
  command.text("--threads", options->threads, "solves side by side (as many as there are cores)").called("N");
  command.text("--max-solves", options->most_solves, "solves in all, held-out ones among them (4000)").called("N");
  command.text("--time-limit", options->request.time_limit, "seconds for each solve (300)").called("S");
  options->changes.add_to(command);
  add_time_limit_total(command, options->time_limit_total);
  command.runs([options] { return export_any(*options); });
}

}  // namespace ehd::cli
