// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of `ehd`, a file each. Each add_… registers its subcommand and, when it has run, leaves the exit
// code (0 success, 1 a check failed or a solve did not converge, 2 bad input) in `exit_code`.
#pragma once

#include <CLI/CLI.hpp>

namespace ehd::cli {

void add_solve(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_bearing(CLI::App& app, int& exit_code);
void add_cases(CLI::App& app, int& exit_code);
void add_plan(CLI::App& app, int& exit_code);
void add_verify(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);
void add_stress(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_atlas(CLI::App& app, int& exit_code);
void add_maps(CLI::App& app, int& exit_code);
void add_statements(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);

}  // namespace ehd::cli
