// SPDX-License-Identifier: GPL-3.0-or-later
// The squeeze term against the flow that it stands for, and the exact flow of a motion that changes nothing.
#include "reference/hp/harmonic.hpp"

#include <cmath>

#include "tests/check.hpp"
#include "tests/reference/hp/solved.hpp"
#include "tests/reference/problems.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using verification::Tolerance;

constexpr double mesh_tolerance = 1e-9;

Resolved solved_contact(const Problem& problem) { return physics(problem, 0.3, 12, mesh_tolerance, 1e-8); }

/// Int rho H dX over an element of the state, by a rule of its own.
double mass_on(const Problem& problem, const Collocation<double>& equations, const State<double>& state, int element) {
  constexpr int degree = 30;
  const VectorOf<double> t = lobatto_nodes<double>(degree), weights = lobatto_weights<double>(degree, t);
  std::vector<Place<double>> places;
  ArrayOf<double> P(degree + 1);
  for (int i = 0; i <= degree; ++i) {
    places.push_back({element, 1 + t[i], 1 - t[i]});
    P[i] = equations.interpolate(state.P, element, t[i]);
  }
  const ArrayOf<double> H = equations.film(state, places, equations.kernel_rows(places));
  const ArrayOf<double> mass = evaluate(problem.density, P).value * H;
  return equations.half_length(element) * equations.stretching(state.exit) * weights.dot(mass.matrix());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_harmonic)

BOOST_AUTO_TEST_CASE(squeeze_is_the_integral_of_the_changing_mass) {
  const Problem problem = distinct_problem(5, 5, TruncatedAt{-4});
  const Resolved steady = solved_contact(problem);
  const Collocation<double>& equations = *steady.equations;
  const Harmonic harmonic(problem, steady);
  const int n = equations.intervals();
  VectorOf<double> u = VectorOf<double>::Zero(n + 3);  // the exit stays, so that a place is a place
  const ArrayOf<double> X = equations.node_coordinates(steady.run.state.exit);
  u.head(n) = ((X + 4).cube() * (X[n] - X) / 20).head(n).matrix();
  u[n] = 0.37;
  const VectorOf<double> squeeze = harmonic.squeeze(u);
  constexpr double change = 1e-5;  // rounding leaves 1e-10 of the quotient
  State<double> more = steady.run.state, less = steady.run.state;
  more.P.head(n) += change * u.head(n), less.P.head(n) -= change * u.head(n);
  more.offset += change * u[n], less.offset -= change * u[n];
  double beyond = 0;
  int rows = 0;
  for (int e = equations.mesh().elements() - 1; e >= 0; --e) {
    beyond += (mass_on(problem, equations, more, e) - mass_on(problem, equations, less, e)) / (2 * change);
    // A row is the left end of an element. rho P_1 and the logarithms at the ends are no polynomials.
    EHD_CHECK(std::abs(squeeze[equations.first_node(e)] - beyond), Tolerance::discretisation(mesh_tolerance, 100));
    ++rows;
  }
  BOOST_TEST(rows > 10);
}

// P_1 = V P_0' X*_1 and the same film at the same places: the mesh has moved and the oil has not.
BOOST_AUTO_TEST_CASE(a_mesh_that_moves_alone_squeezes_nothing) {
  for (const Inlet& inlet : {Inlet(TruncatedAt{-4}), Inlet(TruncatedAt{-11})}) {
    const Problem problem = distinct_problem(5, 5, inlet);
    const Resolved steady = solved_contact(problem);
    const Collocation<double>& equations = *steady.equations;
    const int n = equations.intervals();
    const auto places = equations.node_places();
    const double s = equations.stretching(steady.run.state.exit);
    VectorOf<double> u = VectorOf<double>::Zero(n + 3);
    for (int j = 0; j < n; ++j) {
      const auto& place = places[static_cast<std::size_t>(j)];
      const auto& shape = equations.reference(place.element);
      const VectorOf<double> modes =
          shape.to_legendre * steady.run.state.P.segment(equations.first_node(place.element), shape.degree + 1);
      u[j] = equations.coordinate_by_exit(place) * modes.dot(legendre_derivatives(shape.degree, place.from_left - 1)) /
             (equations.half_length(place.element) * s);
    }
    u[n + 2] = 1;
    const VectorOf<double> squeeze = Harmonic(problem, steady).squeeze(u);
    // C X*_1 alone is 0.3; slopes of polynomials that resolve films to 1e-9 lose some digits.
    EHD_CHECK(squeeze.head(n).cwiseAbs().maxCoeff(), Tolerance::discretisation(mesh_tolerance, 1e3));
  }
}

BOOST_AUTO_TEST_SUITE_END()
