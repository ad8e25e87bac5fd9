// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/film_formulas.hpp"

#include <cmath>
#include <numbers>

namespace ehd {

double moes_film_formula(const MoesGroups& moes) {
  // Moes' four asymptotes RI, EI, RP, EP, joined as in Venner (1991).
  const double ri = 3 / moes.M;
  const double ei = 2.621 * std::pow(moes.M, -0.2);
  const double rp = 1.287 * std::pow(moes.L, 2.0 / 3);
  const double ep = 1.311 * std::pow(moes.M, -0.125) * std::pow(moes.L, 0.75);
  const double s = (7 + 8 * std::exp(-2 * ei / ri)) / 5;
  const double isoviscous = std::pow(std::pow(ri, 7.0 / 3) + std::pow(ei, 7.0 / 3), 3 * s / 7);
  const double piezoviscous = moes.L > 0 ? std::pow(std::pow(rp, -3.5) + std::pow(ep, -3.5), -2 * s / 7) : 0.0;
  return std::pow(isoviscous + piezoviscous, 1 / s);
}

double expected_film(const MoesGroups& moes) { return moes_film_formula(moes) / moes_film_per_hertz_film(moes.M); }

std::vector<FilmFormula> film_formulas(const MoesGroups& moes, double G) {
  std::vector<FilmFormula> formulas{{"Moes (Venner 1991)", Quantity::film_couette, moes_film_formula(moes)}};
  if (!(moes.L > 0) || !(G > 0)) return formulas;
  const DowsonGroups groups = dowson_from(moes, G);
  const double moes_per_film_ratio = 1 / std::sqrt(2 * groups.U_mean);  // h/R -> (h/R) U_s^(-1/2)
  const auto add = [&](const char* name, Quantity of, double c, double a, double u, double w) {
    formulas.push_back(
        {name, of,
         c * std::pow(groups.G, a) * std::pow(groups.U_mean, u) * std::pow(groups.W, w) * moes_per_film_ratio});
  };
  add("Dowson & Higginson 1966", Quantity::film_minimum, 1.6, 0.6, 0.7, -0.13);
  add("Dowson & Higginson 1977", Quantity::film_minimum, 2.65, 0.54, 0.70, -0.13);
  add("Hamrock & Jacobson 1984", Quantity::film_minimum, 3.07, 0.57, 0.71, -0.11);
  add("Pan & Hamrock 1989", Quantity::film_minimum, 1.714, 0.568, 0.694, -0.128);
  add("Dowson & Toyoda 1978", Quantity::film_central, 3.06, 0.56, 0.69, -0.10);
  add("Pan & Hamrock 1989", Quantity::film_central, 2.922, 0.470, 0.692, -0.166);
  return formulas;
}

SpikeFormula pan_hamrock_spike(const MoesGroups& moes, double G) {
  const DowsonGroups groups = dowson_from(moes, G);
  const auto power = [&](double c, double w, double u, double g) {
    return c * std::pow(groups.W, w) * std::pow(groups.U_mean, u) * std::pow(groups.G, g);
  };
  const double pressure = std::sqrt(groups.W / (2 * std::numbers::pi)),
               half_width = std::sqrt(8 * groups.W / std::numbers::pi);
  return {.height = power(0.648, 0.185, 0.275, 0.391) / pressure,
          .place = power(1.111, 0.606, -0.021, 0.077) / half_width,
          .minimum_place = power(1.439, 0.548, -0.011, 0.026) / half_width};
}

}  // namespace ehd
