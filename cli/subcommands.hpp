// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of `ehd`. A new one is a file NAME.cpp, which defines describe_NAME, and one line here.
#pragma once

#include "cli/command_line.hpp"

/// In the order of `ehd --help`.
#define EHD_SUBCOMMANDS(LINE) \
  LINE(solve)                 \
  LINE(compare)               \
  LINE(judge)                 \
  LINE(response)              \
  LINE(bearing)               \
  LINE(new)                   \
  LINE(convert)               \
  LINE(cases)                 \
  LINE(plan)                  \
  LINE(verify)                \
  LINE(bench)                 \
  LINE(stress)                \
  LINE(report)                \
  LINE(atlas)                 \
  LINE(maps)                  \
  LINE(statements)            \
  LINE(sweep)                 \
  LINE(export)

namespace ehd::cli {

#define EHD_DECLARE(NAME) void describe_##NAME(Command& command);
EHD_SUBCOMMANDS(EHD_DECLARE)
#undef EHD_DECLARE

}  // namespace ehd::cli
