// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "contact/text.hpp"
#include "io/case_keys.hpp"
#include "io/faults.hpp"
#include "io/near_miss.hpp"
#include "verification/judge/csv_reader.hpp"
#include "verification/judge/submission.hpp"

namespace ehd::judging {

namespace {

constexpr FileKind csv_kind{.name = "a submission (CSV with columns case, version, quantity, value, scaling)",
                            .most_bytes = 16 << 20};
constexpr std::size_t most_faults = 20;      // lines of a refusal
constexpr std::size_t rows_per_result = 16;  // more than there are quantities

int version_in(const CsvReader& csv, std::size_t column) {
  const double version = csv.number(column);
  if (!(version >= 1 && version <= std::numeric_limits<int>::max() && version == static_cast<int>(version)))
    throw csv.refuse(column, "is no version; allowed is an integer above 0");
  return static_cast<int>(version);
}

/// Names all unknown columns, and all that are missing and that no unknown one was probably meant to be.
void require_columns(const CsvReader& csv, const std::vector<std::string>& known) {
  Faults faults;
  std::set<std::string> meant;
  for (const std::string& name : csv.header()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    faults.add(refusal(csv.place(), fmt::format("column {}: {}", shortened(name, 60), is_unknown(name, list(known)))));
    meant.insert(near_miss(name, known));
  }
  for (const std::string& name : known)
    if (name != "stated_error" && !meant.contains(name)) (void)faults.none_in([&] { (void)csv.column(name); });
  faults.refuse();
}

}  // namespace

Submission read_submission_csv(const std::filesystem::path& file) {
  CsvReader csv(file, csv_kind, most_results * rows_per_result);
  const std::vector<std::string> known{"case", "version", "quantity", "value", "scaling", "stated_error"};
  require_columns(csv, known);
  const std::size_t id = csv.column("case"), version = csv.column("version"), quantity = csv.column("quantity"),
                    value = csv.column("value"), scaling = csv.column("scaling"),
                    stated = csv.column("stated_error", false);
  Submission made{
      .file = file, .name = one_line(file.stem().string()), .version = {}, .url = {}, .hardware = {}, .results = {}};
  std::map<std::string, std::size_t> place_of;
  std::set<std::string> of_another_version;  // cases: which of their rows is wrong is not known, and one line says so
  const auto read_row = [&] {
    csv.require_all_cells();
    require_case_id(csv.place(), csv.cell(id));
    const int of_row = version_in(csv, version);
    const auto [at, is_new] = place_of.try_emplace(csv.cell(id), made.results.size());
    if (is_new)
      made.results.push_back({.case_id = csv.cell(id), .version = of_row, .numbers = {}, .place = csv.place()});
    SubmittedResult& result = made.results[at->second];
    if (of_row != result.version && of_another_version.insert(csv.cell(id)).second)
      throw csv.refuse(version, fmt::format("differs from the version {} of the case at {}; allowed is one version",
                                            result.version, result.place));
    SubmittedNumber number{.quantity = submitted_quantity(csv.place(), csv.cell(quantity)),
                           .value = csv.number(value),
                           .scaling = submitted_scaling(csv.place(), csv.cell(scaling))};
    if (stated < csv.size() && !csv.cell(stated).empty()) number.stated_error = csv.number(stated);
    require_number(csv.place(), number);
    for (const SubmittedNumber& other : result.numbers)
      if (other.quantity == number.quantity)
        throw csv.refuse(quantity, "is there twice for this case; allowed is once");
    result.numbers.push_back(number);
  };
  Faults faults;
  bool more = true;
  while (faults.none_in([&] { more = csv.next(); }) && more) {  // behind a lost quotation mark nothing is read
    if (faults.none_in(read_row) || faults.size() < most_faults) continue;
    faults.add(fmt::format("{}: up to here; the lines behind are not read", csv.place()));
    break;
  }
  faults.refuse();
  if (made.results.empty()) throw refusal(csv.place(), "has no rows; required is one a number");
  return made;
}

}  // namespace ehd::judging
