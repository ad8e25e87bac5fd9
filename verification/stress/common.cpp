// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "verification/stress/parts.hpp"

namespace ehd::verification::stress {

Ended ended(const Solution& solution) {
  Ended end{.status = solution.record.status,
            .reason = solution.record.reason,
            .iterations = solution.record.cost.newton_iterations,
            .wall_s = solution.record.cost.wall_s};
  for (const auto& [quantity, reading] : solution.observables)
    end.finite = end.finite && std::isfinite(reading.value) && std::isfinite(reading.place.value_or(0)) &&
                 std::isfinite(reading.error.value_or(0));
  const Fields& fields = solution.fields;
  for (const Array* field : {&fields.X, &fields.P, &fields.H, &fields.density, &fields.log_viscosity, &fields.flux})
    end.finite = end.finite && field->allFinite();
  for (std::size_t k = 0; k < 2; ++k) {
    const auto at = solution.observables.find(judged_films[k]);
    if (at == solution.observables.end()) continue;
    end.film[k] = at->second.value;
    end.error[k] = at->second.error;
  }
  return end;
}

bool out_of_time(StopReason status, double wall_s, double time_limit_s) {
  constexpr double counted = 0.9;  // a solver's limit counts FFT planning too, wall_s does not
  return status == StopReason::limit_reached && wall_s >= counted * time_limit_s;
}

Verdict holds_in_time(bool holds, bool out_of_time) {
  return holds ? Verdict::pass : out_of_time ? Verdict::inconclusive : Verdict::fail;
}

double over_stated_errors(const Ended& one, const Ended& other) {
  if (!one.has_films() || !other.has_films()) return std::numeric_limits<double>::quiet_NaN();
  double worst = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double ratio = std::abs(*one.film[k] / *other.film[k] - 1) / (*one.error[k] + *other.error[k]);
    if (!(ratio <= worst)) worst = ratio;  // NaN stays
    if (std::isnan(worst)) return worst;
  }
  return worst;
}

Tolerance within_stated_errors() {
  return Tolerance::required(1, "difference of the films over the sum of the errors that both solvers state");
}

void keep_larger(std::optional<Tolerance>& largest, const Tolerance& one) {
  if (!largest || one.value() > largest->value()) largest = one;
}

std::vector<BoxContact> cut_contacts(std::vector<BoxContact> contacts) {
  for (BoxContact& contact : contacts) contact.inlet = TruncatedAt{usual_cut};
  return contacts;
}

Json json_of(const Ended& end) {
  Json json{
      {"status", static_cast<int>(end.status)}, {"reason", end.reason}, {"finite", end.finite}, {"wall_s", end.wall_s}};
  for (std::size_t k = 0; k < 2; ++k) {
    put(json, fmt::format("film{}", k), end.film[k]);
    put(json, fmt::format("error{}", k), end.error[k]);
  }
  return json;
}

Ended ended_from(const Json& json) {
  Ended end{.status = static_cast<StopReason>(json.at("status").get<int>()),
            .reason = json.at("reason").get<std::string>(),
            .wall_s = json.at("wall_s").get<double>(),
            .finite = json.at("finite").get<bool>()};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string film = fmt::format("film{}", k), error = fmt::format("error{}", k);
    if (json.contains(film)) end.film[k] = json.at(film).get<double>();
    if (json.contains(error)) end.error[k] = json.at(error).get<double>();
  }
  return end;
}

}  // namespace ehd::verification::stress
