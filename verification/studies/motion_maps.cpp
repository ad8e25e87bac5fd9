// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/studies/motion_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "contact/text.hpp"
#include "io/tables.hpp"

namespace ehd::verification {

namespace {

using Cell = std::function<std::string(double M, double L)>;

double number(const AtlasRow& row, const std::string& column) { return std::stod(row.at(column)); }

/// M or L of the rows of a law set, increasing.
std::vector<double> all_of(const std::vector<AtlasRow>& rows, AtlasLaws laws, const std::string& column) {
  std::set<double> values;
  for (const AtlasRow& row : rows)
    if (row.at("laws") == to_string(laws)) values.insert(number(row, column));
  return {values.begin(), values.end()};
}

/// Rows of L, columns of M; columns without any cell are left out; empty where all are.
std::string map_text(const std::string& title, const std::vector<double>& all_M, const std::vector<double>& all_L,
                     const Cell& cell) {
  std::vector<std::vector<std::string>> lines{{"L \\ M"}};
  for (const double L : all_L) lines.push_back({plain(L)});
  for (const double M : all_M) {
    std::vector<std::string> column{plain(M)};
    for (const double L : all_L) column.push_back(cell(M, L));
    if (std::all_of(column.begin() + 1, column.end(), [](const std::string& one) { return one.empty(); })) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i].push_back(column[i]);
  }
  if (lines.front().size() == 1) return "";
  return fmt::format("{}\n\n{}\n", title, aligned_in_parts(lines, 1, "  "));
}

const AtlasRow* kappa_at(const MotionMaps& maps, AtlasLaws laws, MoesGroups moes, double Omega) {
  const auto row = std::ranges::find_if(maps.kappa, [&](const AtlasRow& one) {
    return one.at("laws") == to_string(laws) && number(one, "M") == moes.M && number(one, "L") == moes.L &&
           number(one, "Omega") == Omega;
  });
  return row == maps.kappa.end() ? nullptr : &*row;
}

/// Digits of a map: those that are known, at most four.
std::string short_number(const AtlasRow& row, const std::string& column) {
  constexpr int map_digits = 4;
  const std::string& text = row.at(column);
  return text.empty() ? "-" : plain(std::stod(text), std::min(map_digits, count_digits(text)));
}

std::string slow_maps(const MotionMaps& maps) {
  std::string text;
  for (const AtlasLaws laws : all_atlas_laws) {
    for (const auto& map : {std::pair{"kappa_0", "stiffness"}, std::pair{"kappa_1", "damping"}}) {
      const char *const name = map.first, *const column = map.second;
      const auto cell = [&](double M, double L) -> std::string {
        const AtlasRow* row = kappa_at(maps, laws, {M, L}, 0);
        return row ? short_number(*row, column) : "";
      };
      text += map_text(fmt::format("{}, {}", name, to_string(laws)), all_of(maps.kappa, laws, "M"),
                       all_of(maps.kappa, laws, "L"), cell);
    }
  }
  return text;
}

/// Of a point that was asked for at frequencies: Im kappa/|kappa| where it is least, in percent.
std::optional<double> least_loss_percent(const MotionMaps& maps, AtlasLaws laws, MoesGroups moes) {
  std::optional<double> least;
  for (const AtlasRow& row : maps.kappa) {
    if (row.at("laws") != to_string(laws) || number(row, "M") != moes.M || number(row, "L") != moes.L) continue;
    const double Omega = number(row, "Omega");
    if (Omega == 0 || row.at("damping").empty() || row.at("stiffness").empty()) continue;
    const double imaginary = number(row, "damping") * Omega;
    const double loss = 100 * imaginary / std::hypot(number(row, "stiffness"), imaginary);
    least = least ? std::min(*least, loss) : loss;
  }
  return least;
}

std::string driven_maps(const MotionMaps& maps) {
  std::set<double> asked;
  for (const AtlasRow& row : maps.kappa) asked.insert(number(row, "Omega"));
  std::string frequencies;
  for (const double Omega : asked) frequencies += (frequencies.empty() ? "" : ", ") + plain(Omega);
  std::string text;
  for (const AtlasLaws laws : all_atlas_laws) {
    const auto all_M = all_of(maps.kappa, laws, "M"), all_L = all_of(maps.kappa, laws, "L");
    const auto driven = [&](double M, double L) -> std::string {
      if (!kappa_at(maps, laws, {M, L}, *asked.rbegin())) return "";
      std::string cell;
      for (const double Omega : driven_frequencies(maps, laws, {M, L}))
        cell += (cell.empty() ? "" : ",") + plain(Omega);
      return cell.empty() ? "none" : cell;
    };
    const auto loss = [&](double M, double L) -> std::string {
      const auto least = least_loss_percent(maps, laws, {M, L});
      return least ? plain(*least, 2) : "";
    };
    text +=
        map_text(fmt::format("Omega with negative damping, of {}; 0: slow motion; {}", frequencies, to_string(laws)),
                 all_M, all_L, driven) +
        map_text(fmt::format("least Im kappa/|kappa| at Omega from 1 to 8, in percent; {}", to_string(laws)), all_M,
                 all_L, loss);
  }
  return text;
}

/// The similar wavelength of the list that a row has, to its four digits.
double similar_of(const AtlasRow& row) {
  constexpr double four_digits = 1e-3;
  const double similar = similar_wavelength({number(row, "M"), number(row, "L")}, number(row, "wavelength"));
  for (const double listed : similar_wavelengths)
    if (std::abs(similar / listed - 1) < four_digits) return listed;
  return similar;
}

std::string waviness_maps(const MotionMaps& maps) {
  constexpr double heavy_M = 20;
  std::string text = "amplitude ratio of waves in pure rolling, roelands\n\n";
  std::vector<std::vector<std::string>> spread{
      {"similar wavelength", "contacts M >= 20", "lowest", "highest", "highest/lowest", "M < 20", "lowest", "highest"}};
  for (const double similar : similar_wavelengths) {
    std::map<std::pair<double, double>, std::string> cells;
    std::vector<double> heavy, light;
    for (const AtlasRow& row : maps.waviness) {
      if (number(row, "slip") != 1 || similar_of(row) != similar || row.at("ratio").empty()) continue;
      cells[{number(row, "M"), number(row, "L")}] = short_number(row, "ratio");
      (number(row, "M") >= heavy_M ? heavy : light).push_back(number(row, "ratio"));
    }
    const auto cell = [&](double M, double L) -> std::string {
      const auto at = cells.find({M, L});
      return at == cells.end() ? "" : at->second;
    };
    text +=
        map_text(fmt::format("similar wavelength {}", plain(similar)), all_of(maps.waviness, AtlasLaws::roelands, "M"),
                 all_of(maps.waviness, AtlasLaws::roelands, "L"), cell);
    std::vector<std::string> line{plain(similar)};
    for (std::vector<double>* ratios : {&heavy, &light}) {
      line.push_back(std::to_string(ratios->size()));
      std::ranges::sort(*ratios);
      line.push_back(ratios->empty() ? "-" : plain(ratios->front(), 3));
      line.push_back(ratios->empty() ? "-" : plain(ratios->back(), 3));
      if (ratios == &heavy) line.push_back(ratios->empty() ? "-" : plain(ratios->back() / ratios->front(), 3));
    }
    spread.push_back(std::move(line));
  }
  return text + "how far this is one curve\n\n" + aligned_in_parts(spread, 1, "  ");
}

}  // namespace

MotionMaps motion_maps(const std::filesystem::path& folder) {
  return {.kappa = read_motion_table(kappa_table(), folder), .waviness = read_motion_table(waviness_table(), folder)};
}

std::vector<double> driven_frequencies(const MotionMaps& maps, AtlasLaws laws, MoesGroups moes) {
  std::vector<double> driven;
  for (const AtlasRow& row : maps.kappa) {
    if (row.at("laws") != to_string(laws) || number(row, "M") != moes.M || number(row, "L") != moes.L) continue;
    const bool known = !row.at("damping").empty();
    if (known && number(row, "damping") + number(row, "damping_error") < 0) driven.push_back(number(row, "Omega"));
  }
  std::ranges::sort(driven);
  return driven;
}

std::string human_motion_maps(const MotionMaps& maps) {
  return fmt::format("from cases/atlas/kappa.csv and waviness.csv; at most four digits; -: not known\n\n{}{}{}",
                     slow_maps(maps), driven_maps(maps), waviness_maps(maps));
}

}  // namespace ehd::verification
