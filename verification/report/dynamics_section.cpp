// SPDX-License-Identifier: GPL-3.0-or-later
// A bearing in small motion: stiffness and damping of its contacts around it, and of the ring over the frequency.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "contact/text.hpp"
#include "verification/report/report.hpp"

namespace ehd::report {

namespace {

constexpr const char* axis_stiffness = "stiffness [N/\u00b5m]";
constexpr const char* axis_damping = "damping [N s/m]";
/// What the keys of the ring's curves begin with, and the names of these curves.
const std::vector<std::pair<std::string, std::string>> directions = {{"along", "along the load"}, {"across", "across"}};

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
Figure stiffness_and_damping(const std::string& title_markup, const View& values, const Axis& x,
                             const std::vector<double>& places,
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
  stiffness.title = title_markup;
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

/// The ring over clearance and speed. Results of earlier versions have neither.
void add_changes(Page& page, const View& bearing, const std::string& id) {
  struct Change {
    const char *key, *places, *id, *label, *name;
    Scale scale;
  };
  for (const Change& one :
       {Change{"over_clearance", "clearance_um", "clearance", "diametral clearance *P*_{d} [\u00b5m]", "clearance",
               Scale::linear},
        Change{"over_speed", "part_of_speed", "speed", "speed / speed of the case", "speed", Scale::logarithmic}}) {
    const View ring = bearing[one.key];
    const std::vector<double> places = ring.numbers(one.places);
    if (places.empty()) continue;
    Figure figure = stiffness_and_damping(literal(id) + ", ring", ring, {.label = one.label, .scale = one.scale},
                                          places, directions);
    figure.id = fmt::format("fig-motion-{}-{}", one.id, id);
    figure.title = fmt::format("Stiffness and damping of {} over {}", id, one.name);
    figure.description =
        fmt::format("Diagonal entries of the ring's 2 x 2 stiffness and damping, over the {}.", one.name);
    page.figure(std::move(figure),
                fmt::format("<b>{}</b>: stiffness and damping of the ring over the {}, all else as "
                            "in the case; at {} Hz.",
                            escaped(id), one.name, plain(bearing.number("frequency_of_changes_Hz").value_or(0))));
  }
}

}  // namespace

void add_dynamics(Page& page, const std::vector<View>& bearings) {
  if (bearings.empty()) {
    page.heading("Bearings in small motion");
    page.absent("Stiffness and damping of bearings in small motion, which --quick leaves out, are",
                "ehd verify --output DIR");
  }
  for (const View& bearing : bearings) {
    const std::string id = bearing.text("id");
    page.heading(escaped(id) + " in small motion, law ehd");
    page.begin_fold("Stiffness and damping: around the bearing, and over the frequency");
    page.begin_figures();
    const View contacts = bearing["contacts"], ring = bearing["ring"];
    Figure around = stiffness_and_damping(literal(id) + ", each roller's contacts", contacts,
                                          {.label = "azimuth *\u03c8* [deg]", .low = 0, .high = 180, .step = 30},
                                          contacts.numbers("azimuth_deg"),
                                          {{"inner", "inner raceway"}, {"outer", "outer raceway"}});
    around.id = "fig-motion-around-" + id;
    around.title = "Contacts of " + id + " in motion";
    around.description = "Stiffness and damping of each roller's contacts over the azimuth, slow motion.";
    page.figure(std::move(around),
                "<b>" + escaped(id) +
                    "</b>: stiffness and damping of the contacts around the bearing, slow motion. The "
                    "rollers at the edge of the load zone damp most.");
    Figure over =
        stiffness_and_damping(literal(id) + ", ring", ring, {.label = "frequency [Hz]", .scale = Scale::logarithmic},
                              ring.numbers("frequency_Hz"), directions);
    add_phase(over, ring, directions);
    over.id = "fig-motion-ring-" + id;
    over.title = "Stiffness and damping of " + id + " over frequency";
    over.description =
        "Diagonal entries of the ring's 2 x 2 stiffness and damping, and their phase, over the frequency.";
    page.figure(std::move(over), "<b>" + escaped(id) +
                                     "</b>: stiffness and damping of the ring over frequency, rollers' mass included; "
                                     "the phase of <i>K</i> = stiffness + i\u2009<i>\u03c9</i> damping.");
    add_changes(page, bearing, id);
    page.end_figures();
    page.end_fold();
  }
}

}  // namespace ehd::report
