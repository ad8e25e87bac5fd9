// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "contact/text.hpp"
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
    const auto at = solution.observables.find(films[k]);
    if (at == solution.observables.end()) continue;
    end.film[k] = at->second.value;
    end.error[k] = at->second.error;
  }
  return end;
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

double hertz_pressure_Pa(const Groups& groups) {
  constexpr double alpha_per_Pa = 2.2e-8;
  return groups.alpha_p_H / alpha_per_Pa;
}

std::string law_name(bool roelands) { return roelands ? "Roelands" : "Barus"; }

std::string contact_name(const MoesGroups& moes, bool roelands) {
  return "M = " + plain(moes.M) + ", L = " + plain(moes.L) + ", " + law_name(roelands);
}

struct Draw::Engine {
  std::mt19937 random;
};
Draw::Draw(unsigned seed) : engine_(std::make_unique<Engine>(Engine{std::mt19937(seed)})) {}
Draw::~Draw() = default;
double Draw::uniform(double from, double to) {
  constexpr double all = 4294967296.0;
  return from + (to - from) * (static_cast<double>(engine_->random()) / all);
}
double Draw::logarithmic(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
int Draw::index(int count) { return std::min(count - 1, static_cast<int>(uniform(0, count))); }

}  // namespace ehd::verification::stress
