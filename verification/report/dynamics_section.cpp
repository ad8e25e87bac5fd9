// SPDX-License-Identifier: GPL-3.0-or-later
// A bearing in small motion: stiffness and damping of its contacts around it, and of the ring over the frequency.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/report/bearing_tables.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

constexpr const char* axis_stiffness = "stiffness [N/\u00b5m]";
constexpr const char* axis_damping = "damping [N s/m]";

Series curve(std::size_t k, const std::string& name, std::vector<double> x, std::vector<double> y) {
  const Look look = look_of_curve(k);
  return {.name = name,
          .x = std::move(x),
          .y = std::move(y),
          .line = look.line,
          .marker = look.marker,
          .colour = look.colour,
          .hollow = true};
}

/// Two panels, stiffness above damping. `prefixes`: what the keys of each curve begin with, and its name.
Figure stiffness_and_damping(const View& values, const Axis& x, const std::vector<double>& places,
                             const std::vector<std::pair<std::string, std::string>>& prefixes) {
  Figure figure;
  Panel stiffness{.x = x, .y = {.label = axis_stiffness, .low = 0}},
      damping{.x = x, .y = {.label = axis_damping, .low = 0}};
  stiffness.x.silent = true;
  for (std::size_t k = 0; k < prefixes.size(); ++k) {
    const auto& [prefix, name] = prefixes[k];
    stiffness.series.push_back(
        curve(k, name, places, scaled(values.numbers(prefix + "_stiffness_N_per_m"), 1 / micro)));
    damping.series.push_back(curve(k, "", places, values.numbers(prefix + "_damping_N_s_per_m")));
    damping.series.back().of = name;  // the legend above serves both
  }
  figure.panels = {stiffness, damping};
  return figure;
}

/// Im K = omega times damping leads Re K by this angle; below 0 where the motion is driven.
void add_phase(Figure& figure, const View& ring, const std::vector<std::pair<std::string, std::string>>& prefixes) {
  const std::vector<double> frequencies = ring.numbers("frequency_Hz");
  Panel phase{.x = figure.panels.back().x, .y = {.label = "phase of *K* [deg]"}};
  figure.panels.back().x.silent = true;
  for (std::size_t k = 0; k < prefixes.size(); ++k) {
    const auto& [prefix, name] = prefixes[k];
    const auto stiffness = ring.numbers(prefix + "_stiffness_N_per_m"),
               damping = ring.numbers(prefix + "_damping_N_s_per_m");
    std::vector<double> degrees;
    for (std::size_t i = 0; i < std::min({frequencies.size(), stiffness.size(), damping.size()}); ++i)
      degrees.push_back(std::atan2(2 * std::numbers::pi * frequencies[i] * damping[i], stiffness[i]) * 180 /
                        std::numbers::pi);
    phase.series.push_back(curve(k, "", frequencies, degrees));
    phase.series.back().of = name;
  }
  figure.panels.push_back(std::move(phase));
}

}  // namespace

void add_dynamics(Page& page, const std::vector<View>& bearings) {
  for (const View& bearing : bearings) {
    const std::string id = bearing.text("id");
    page.heading(escaped(id) + " in small motion, law ehd");
    page.begin_fold("Stiffness and damping: around the bearing, and over the frequency");
    page.begin_figures();
    const View contacts = bearing["contacts"], ring = bearing["ring"];
    Figure around =
        stiffness_and_damping(contacts, {.label = "azimuth *\u03c8* [deg]", .low = 0, .high = 180, .step = 30},
                              contacts.numbers("azimuth_deg"), {{"inner", "inner"}, {"outer", "outer"}});
    around.id = "fig-motion-around-" + id;
    around.title = "Contacts of " + id + " in motion";
    around.description = "Stiffness and damping of each roller's contacts over the azimuth, slow motion.";
    page.figure(std::move(around),
                "<b>" + escaped(id) +
                    "</b>: stiffness and damping of the contacts around the bearing, slow motion. The "
                    "rollers at the edge of the load zone damp most.");
    const std::vector<std::pair<std::string, std::string>> directions = {{"along", "along the load"},
                                                                         {"across", "across"}};
    Figure over = stiffness_and_damping(ring, {.label = "frequency [Hz]", .scale = Scale::logarithmic},
                                        ring.numbers("frequency_Hz"), directions);
    add_phase(over, ring, directions);
    over.id = "fig-motion-ring-" + id;
    over.title = "Stiffness and damping of " + id + " over frequency";
    over.description =
        "Diagonal entries of the ring's 2 x 2 stiffness and damping, and their phase, over the frequency.";
    page.figure(std::move(over), "<b>" + escaped(id) +
                                     "</b>: stiffness and damping of the ring over frequency, rollers' mass included; "
                                     "the phase of <i>K</i> = stiffness + i\u2009<i>\u03c9</i> damping.");
    page.end_figures();
    page.end_fold();
  }
}

}  // namespace ehd::report
