// SPDX-License-Identifier: GPL-3.0-or-later
// made_report DIR [long]: the made results as files, for the browser test. `long`: with as many rows, and as long
// texts, as those of the whole suite, `ehd bench` and `ehd stress`. The page of those files has a realistic height.
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "io/json.hpp"
#include "io/output_file.hpp"
#include "tests/verification/report/made_results.hpp"

namespace {

using ehd::Json;

// Numbers of rows, as the whole suite and the benchmark have them at version 0.1.
constexpr int cases = 32, benched = 15, formulas = 7, parts = 10, answers = 6, batches = 4, statements = 8;

/// `count` copies of the first entry; `name`, where given, is a key that each copy has with a number of its own.
Json copies(const Json& list, int count, const std::string& name = "") {
  Json result = Json::array();
  for (int k = 0; k < count; ++k) {
    result.push_back(list.at(0));
    if (!name.empty()) result.back()[name] = list.at(0).at(name).get<std::string>() + "-" + std::to_string(k);
  }
  return result;
}

/// A text of that many characters, in words.
std::string words(std::size_t length) {
  std::string text;
  while (text.size() < length) text += "seven of nine words ";
  return text.substr(0, length);
}

Json long_results() {
  Json results = ehd::verification::test::made_results();
  Json& figures = results["figures"];
  figures["cases"] = copies(figures["cases"], cases, "id");
  for (Json& point : figures["maps"]["points"]) point["formulas"] = copies(point["formulas"], formulas, "name");
  figures["statements"] = copies(figures["statements"], statements);
  for (Json& one : figures["statements"]) {
    one["statement"] = words(140);
    one["numbers"] = words(270);
  }
  return results;
}

Json long_bench() {
  Json bench = ehd::verification::test::made_bench();
  Json& result = bench["work_precision"];
  result["truths"] = copies(result["truths"], benched, "case");
  for (const char* solver : {"fast.uniform", "reference.uniform", "fast of another kind"})
    result["solvers"].push_back(solver);
  bench["cost"] = copies(bench["cost"], answers);
  bench["batch"] = copies(bench["batch"], batches);
  return bench;
}

Json long_stress() {
  Json stress = ehd::verification::test::made_stress();
  stress["parts"] = copies(stress["parts"], parts, "id");
  for (Json& part : stress["parts"]) {
    part["question"] = words(90);
    part["summary"] = words(150);
  }
  return stress;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ehd;
  using namespace ehd::verification;
  const bool is_long = argc == 3 && argv[2] == std::string("long");
  if (argc != 2 && !is_long) {
    std::cerr << "usage: made_report DIR [long]\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  for (const auto& [name, json] :
       {std::pair<const char*, Json>{"results.json", is_long ? long_results() : test::made_results()},
        {"bench.json", is_long ? long_bench() : test::made_bench()},
        {"stress.json", is_long ? long_stress() : test::made_stress()}})
    OutputFile(folder / name).commit(json_text(json));
  return 0;
}
