// SPDX-License-Identifier: GPL-3.0-or-later
// ehd report: the results of verify, bench and stress in a folder, as one HTML page.
#include "verification/report/report.hpp"

#include <memory>
#include <string>

#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/output_file.hpp"

namespace ehd::cli {

namespace {

const char* const report_examples = R"(
Examples:
  ehd verify --output out/verify && ehd report out/verify    leaves out/verify/report.html
  ehd bench --output out/verify; ehd report out/verify       with work-precision diagrams

Reads results.json (required), bench.json and stress.json; solves nothing. Exit code: 0 the page is written; 2 the
folder or a file in it cannot be used.)";

int report_on(const std::string& folder) {
  try {
    const auto documents = report::read_documents(folder);
    OutputFile file(std::filesystem::path(folder) / "report.html", Replaces::file);
    file.commit(report::report_html(documents));
  } catch (const report::ReportError& error) {
    throw UsageError("report: " + std::string(error.what()));
  }
  print((std::filesystem::path(folder) / "report.html").string() + "\n");
  return success;
}

}  // namespace

void describe_report(Command& command) {
  auto folder = std::make_shared<std::string>();
  command.summary("Results as one self-contained HTML page, DIR/report.html");
  command.examples(report_examples);
  command.text("DIR", *folder, "the folder that ehd verify --output has filled").required();
  command.runs([folder] { return report_on(*folder); });
}

}  // namespace ehd::cli
