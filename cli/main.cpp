// SPDX-License-Identifier: GPL-3.0-or-later
// The program `ehd`: options and exit codes only. What it does lives in the subcommands, a file each.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "cli/commands.hpp"
#include "cli/common.hpp"
#include "io/output_file.hpp"

namespace {

const char* examples = R"(
Examples:
  ehd solve own-moes-20-10            one contact, by the id of a benchmark case
  ehd solve --M 20 --L 10             the same kind of contact without a file
  ehd compare own-moes-20-10          the solvers side by side
  ehd bearing na4908                  the load distribution of a bearing
  ehd plan own-moes-20-10             what would be computed, what is skipped, and why
  ehd sweep sweep.toml                a case over lists and ranges of its keys
  ehd cases                           the benchmark cases and how to cite them
  ehd verify                          the verification suite
  ehd bench                           run time against achieved error
  ehd stress                          numerical stability
  ehd report out/verify               what they left there, as one HTML page
  ehd atlas --only m20-l10-           certified solutions over M and L, with the digits that are known
  ehd maps                            how far the film formulas are off, over M and L

Exit code: 0 success; 1 a check failed or a solve did not converge; 2 bad input or usage.)";

/// Only the first line: what follows it in a parse error is help that nobody asked for.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

int run(int argc, char** argv) {
  using namespace ehd::cli;
  int exit_code = success;
  CLI::App app("Elastohydrodynamic line contacts and the roller bearings that run on them, verified", "ehd");
  app.set_version_flag("--version", std::string("ehd ") + EHD_VERSION, "Print the version");
  app.footer(examples);
  app.require_subcommand(0, 1);
  add_solve(app, exit_code);
  add_compare(app, exit_code);
  add_bearing(app, exit_code);
  add_cases(app, exit_code);
  add_plan(app, exit_code);
  add_verify(app, exit_code);
  add_bench(app, exit_code);
  add_stress(app, exit_code);
  add_report(app, exit_code);
  add_atlas(app, exit_code);
  add_maps(app, exit_code);
  add_statements(app, exit_code);
  add_sweep(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
    return success;
  } catch (const CLI::Success&) {  // --help, of the program or of a subcommand
    const auto chosen = app.get_subcommands();
    print(chosen.empty() ? app.help() : chosen.front()->help("ehd"));
    return success;
  } catch (const CLI::ParseError& error) {
    complain("ehd: " + first_line(error.what()) + "; ehd --help shows what is allowed");
    return bad_input;
  }
  if (app.get_subcommands().empty()) print(app.help());
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const ehd::OutputError& error) {
    ehd::cli::complain("ehd: " + std::string(error.what()));
    return ehd::cli::bad_input;
  } catch (const std::bad_alloc&) {
    ehd::cli::complain("ehd: memory is exhausted");
    return ehd::cli::not_met;
  } catch (const std::exception& error) {
    ehd::cli::complain("ehd: internal error: " + std::string(error.what()));
    return ehd::cli::not_met;
  }
}
