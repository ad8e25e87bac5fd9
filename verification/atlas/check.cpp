// SPDX-License-Identifier: GPL-3.0-or-later
// Comparison of atlas.csv with the case files beside it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <system_error>

#include "contact/text.hpp"
#include "io/case_reader.hpp"
#include "io/find_case.hpp"
#include "verification/atlas/columns.hpp"
#include "verification/atlas/table.hpp"

namespace ehd::verification {

std::filesystem::path atlas_folder() { return cases_folder() / "atlas"; }

std::vector<std::filesystem::path> atlas_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const auto& path = entry->path();
    if (path.extension() == ".toml" && path.filename().string().starts_with("atlas-")) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

namespace {

constexpr std::size_t columns_of_the_point = 7;  ///< id ... numerical_test: they follow from the point alone
/// Uncertainties of the table and of the case are both rounded up to two digits; of H_0 one is absolute and the other
/// relative. They may differ by this share.
constexpr double two_digits = 0.11;

bool same_lubricant(const Lubricant& a, const Lubricant& b) {
  return a.viscosity == b.viscosity && a.density == b.density && a.alpha_per_Pa == b.alpha_per_Pa && a.z == b.z &&
         (!a.z || a.p0_Pa == b.p0_Pa);
}

/// A number of a row against the expectation of its case (null: there is none); empty where they agree.
std::string difference(const AtlasColumn& column, const AtlasRow& row, const Expectation* expected) {
  const std::string name(column.name), digits = row.at(name), error = row.at(column.error_name());
  const std::string in_case = expected ? expected->digits : "";
  if (in_case != digits)
    return fmt::format("{} is {}, not {}", name, in_case.empty() ? "absent" : in_case,
                       digits.empty() ? "absent" : digits);
  if (digits.empty()) return "";
  if (expected->scaling != Scaling::hertz || expected->kind != ExpectationKind::computed)
    return name + " is not a computed one in Hertz units";
  const double uncertainty =
      column.absolute ? expected->uncertainty * std::abs(expected->value) : expected->uncertainty;
  if (!(std::abs(uncertainty - std::stod(error)) <= two_digits * uncertainty))
    return fmt::format("the uncertainty of {} is {}, not {}", name, plain(uncertainty), error);
  return "";
}

/// A row against its case; empty where they agree.
std::string difference(const AtlasRow& row, const Case& read) {
  const auto* contact = std::get_if<ContactCase>(&read.body);
  const auto* moes = contact ? std::get_if<MoesGroups>(&contact->statement) : nullptr;
  if (!moes || contact->dry()) return "states no lubricated contact by M and L";
  const AtlasPoint point{.laws = atlas_laws_from(row.at("laws")).value_or(AtlasLaws{}),
                         .M = moes->M,
                         .L = moes->L,
                         .inlet = *contact->inlet};
  const auto as_row = atlas_row(point, {});
  for (std::size_t i = 0; i < columns_of_the_point; ++i) {
    if (as_row[i] != row.at(atlas_columns()[i]))
      return fmt::format("{} is {}, not {}", atlas_columns()[i], as_row[i], row.at(atlas_columns()[i]));
  }
  if (!same_lubricant(*contact->lubricant, point.contact().lubricant.value()))
    return "has another lubricant than " + row.at("laws");
  if (read.title != point.title()) return "is called " + read.title;
  std::size_t compared = 0;
  for (const AtlasColumn& column : columns_of_values) {
    if (!column.quantity) continue;
    const auto at = std::find_if(read.expectations.begin(), read.expectations.end(),
                                 [&](const Expectation& one) { return one.quantity == to_string(*column.quantity); });
    const Expectation* const expected = at == read.expectations.end() ? nullptr : &*at;
    compared += expected ? 1 : 0;
    if (const std::string what = difference(column, row, expected); !what.empty()) return what;
  }
  return compared == read.expectations.size() ? "" : "expects what the table does not have";
}

}  // namespace

std::vector<std::string> atlas_disagreements(const std::filesystem::path& folder) {
  const AtlasTable table = read_atlas_table(folder / atlas_csv_name);
  std::vector<std::string> found;
  std::set<std::string> ids;
  for (const auto& row : table.rows) {
    const std::string& id = row.at("id");
    if (!ids.insert(id).second) found.push_back(fmt::format("{}: stands twice in {}", id, atlas_csv_name));
    try {
      const std::string what = difference(row, read_case(folder / (id + ".toml")));
      if (!what.empty()) found.push_back(id + ": the case differs from the table: " + what);
    } catch (const CaseError& wrong) {
      found.push_back(wrong.what());
    } catch (const std::logic_error&) {  // std::stod
      found.push_back(id + ": a number of the table cannot be read");
    }
  }
  for (const auto& file : atlas_files(folder)) {
    if (!ids.contains(file.stem().string()))
      found.push_back(fmt::format("{}: is not in {}", file.string(), atlas_csv_name));
  }
  return found;
}

}  // namespace ehd::verification
