// SPDX-License-Identifier: GPL-3.0-or-later
// Provenance of the numbers, and how to cite them.
#include <fmt/format.h>

#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

void add_provenance(Page& page, const std::string& title, const View& provenance) {
  if (!provenance.exists()) return;
  std::string list = "<dl>";
  const auto row = [&](const char* name, const std::string& value) {
    if (!value.empty()) list += fmt::format("<dt>{}</dt><dd>{}</dd>", name, escaped(value));
  };
  row("version", provenance.cell("version"));
  std::string commit = provenance.text("commit");
  if (const auto dirty = provenance.flag("dirty"); !commit.empty() && dirty)
    commit += *dirty ? ", with changes that are not committed" : ", clean";
  row("commit", commit);
  row("compiler", provenance.text("compiler"));
  row("flags", provenance.text("flags"));
  std::string libraries;
  for (const auto& [name, version] : provenance["libraries"].members())
    libraries += fmt::format("{}{} {}", libraries.empty() ? "" : ", ", name, version.cell());
  row("libraries", libraries);
  std::string cpu = provenance.text("cpu");
  if (provenance.has("cores")) cpu += (cpu.empty() ? "" : ", ") + provenance.cell("cores") + " cores";
  row("machine", cpu);
  row("date", provenance.text("date"));
  page.heading(title);
  page.add(list + "</dl>\n");
}

}  // namespace

void add_origin(Page& page, const View& results, const View& bench, const View& stress) {
  page.section("origin", "Provenance, how to cite", "Provenance");
  const View provenance = results["provenance"];
  page.begin_fold("Version, compiler, libraries, machine");
  add_provenance(page, "The suite (results.json)", provenance);
  add_provenance(page, "Times (bench.json)", bench["provenance"]);
  add_provenance(page, "Stress (stress.json)", stress["provenance"]);
  page.end_fold();
  page.heading("How to cite");
  const std::string version = provenance.cell("version"), commit = provenance.text("commit"),
                    date = provenance.text("date");
  std::string text = EHD_CITATION_AUTHORS ": " EHD_CITATION_TITLE;
  if (!version.empty()) text += ", version " + version;
  if (!commit.empty())
    text += ", commit " + commit.substr(0, 12) + (provenance.flag("dirty").value_or(false) ? " (with changes)" : "");
  if (date.size() >= 4) text += " (" + date.substr(0, 4) + ")";
  page.add("<pre>" + escaped(text + ".") + "</pre>\n");
  page.paragraph(
      "CITATION.cff has the same for programs; <code>ehd cases --bibtex</code> the source of every benchmark case, to "
      "be cited beside it.");
}

}  // namespace ehd::report
