// SPDX-License-Identifier: GPL-3.0-or-later
// made_report DIR: the made results as files, for the browser test.
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/output_file.hpp"
#include "tests/verification/report/made_results.hpp"

int main(int argc, char** argv) {
  using namespace ehd;
  using namespace ehd::verification;
  if (argc != 2) {
    std::cerr << "usage: made_report DIR\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  for (const auto& [name, json] : {std::pair<const char*, Json>{"results.json", test::made_results()},
                                   {"bench.json", test::made_bench()},
                                   {"stress.json", test::made_stress()}})
    OutputFile(folder / name).commit(json_text(json));
  return 0;
}
