// SPDX-License-Identifier: GPL-3.0-or-later
// The program `ehd`: its name, help and list of subcommands. Each subcommand is a file of its own.
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "cli/interruption.hpp"
#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "cli/usage.hpp"
#include "io/output_file.hpp"
#include "io/version.hpp"

namespace {

const char* examples = R"(
Examples:
  ehd solve own-moes-20-10            one contact, by the id of a benchmark case
  ehd solve --M 20 --L 10             the same kind of contact without a file
  ehd compare own-moes-20-10          the solvers side by side
  ehd judge mine.json                 your own solver against the certified digits
  ehd response own-moes-20-10         stiffness and damping of the film
  ehd bearing na4908                  the load distribution of a bearing
  ehd new bearing my-bearing.toml     a commented case to start from
  ehd convert M=20 L=10               the same contact in other groups, and in SI
  ehd plan own-moes-20-10             what would be computed, what is skipped and why
  ehd sweep sweep.toml                a case over lists and ranges of its keys
  ehd export films na4908 --M 2:100 --L 2:15 --format c
                                      the films of one oil as a table, for another program
  ehd cases                           the benchmark cases and how to cite them
  ehd verify                          the verification suite
  ehd bench                           run time against achieved error
  ehd stress                          numerical stability
  ehd report out/verify               the results in that folder as one HTML page
  ehd atlas --output out/atlas        certified solutions over M and L, with the digits that are known
  ehd maps                            errors of the film formulas over M and L

Exit code: 0 success; 1 a check failed or a solve did not converge; 2 bad input or usage.)";

ehd::cli::Program ehd_program() {
  ehd::cli::Program program{
      .name = "ehd",
      .version = ehd::build_text,
      .summary = "Elastohydrodynamic line contacts and the roller bearings that run on them, verified",
      .examples = examples,
      .subcommands = {},
  };
#define EHD_ADD(NAME) program.subcommands.push_back({#NAME, ehd::cli::describe_##NAME});
  EHD_SUBCOMMANDS(EHD_ADD)
#undef EHD_ADD
  return program;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    ehd::cli::take_stack();
    ehd::cli::hold_closed_streams();
    ehd::cli::handle_signals();
    return ehd::cli::run_command_line(ehd_program(), argc, argv);
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
