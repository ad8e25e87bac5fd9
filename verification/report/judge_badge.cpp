// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "verification/report/judge_page.hpp"
#include "verification/report/svg.hpp"

namespace ehd::report {

namespace {

/// "light 3.1": the worse of the medians of a load's regimes; at the end how many numbers are missing.
std::vector<std::string> badge_words(const View& judgement) {
  std::vector<std::string> words;
  double missing = 0;
  for (const char* load : {"light", "moderate", "heavy"}) {
    std::optional<double> digits;
    for (const View& row : judgement.list("regimes")) {
      if (row.text("load") != load) continue;
      missing += row.number("missing").value_or(0);
      if (const auto median = row.number("median_given")) digits = std::min(digits.value_or(*median), *median);
    }
    if (digits) words.push_back(fmt::format("{} {:.1f}", load, *digits));
  }
  if (missing > 0) words.push_back(fmt::format("{:.0f} missing", missing));
  return words;
}

}  // namespace

std::string judge_badge(const Json& judgement) {
  constexpr double height = 20, size = 11, margin = 8, baseline = 14;
  const View view(judgement, "judgement");
  const bool gates_hold = view.flag("gates_hold").value_or(true);
  const std::string label = "ehd digits",
                    value = gates_hold ? fmt::format("{}", fmt::join(badge_words(view), " | ")) : "a gate failed";
  const double left = text_width(label, size) + 2 * margin, right = text_width(value, size) + 2 * margin;
  const auto text = [&](double x, const std::string& words) {
    return fmt::format(R"(<text x="{}" y="{}" fill="#fff" font-family="sans-serif" font-size="{}">{}</text>)",
                       pixels(x), pixels(baseline), size, escaped(words));
  };
  return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" role="img" aria-label="{2}">)"
                     R"(<title>{2}</title><rect width="{3}" height="{1}" fill="#444"/>)"
                     R"(<rect x="{3}" width="{4}" height="{1}" fill="{5}"/>{6}{7}</svg>)"
                     "\n",
                     pixels(left + right), pixels(height),
                     escaped(fmt::format("{}: {}: {}", view["solver"].text("name"), label, value)), pixels(left),
                     pixels(right), gates_hold ? "#0e3a6e" : "#b04e0a", text(margin, label),
                     text(left + margin, value));
}

}  // namespace ehd::report
