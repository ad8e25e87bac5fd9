// SPDX-License-Identifier: GPL-3.0-or-later
// Rungs 1, 3 and 5: the kernel and the film against quadrature and Hertz, the equations written out once more, and the
// Jacobian against differences with 34 digits.
#include "reference/hp/collocation.ipp"

#include <algorithm>
#include <numbers>

#include "contact/hertz.hpp"
#include "tests/check.hpp"
#include "tests/quad.hpp"
#include "tests/quadrature.hpp"
#include "tests/reference/hp/meshes.hpp"

namespace {

using namespace ehd;
using namespace ehd::reference::hp;
using namespace ehd::testing;
using std::numbers::pi;
using verification::Tolerance;

/// d residual/d(P_0 …, H_0, C, X*) by central differences.
template <class Scalar>
MatrixOf<Scalar> differences(const Collocation<Scalar>& equations, const State<Scalar>& state, const Scalar& floor,
                             const Scalar& step) {
  const int n = equations.intervals();
  MatrixOf<Scalar> D(n + 3, n + 3);
  const auto moved = [&](int j, const Scalar& by) {
    State<Scalar> at = state;
    (j < n ? at.P[j] : j == n ? at.offset : j == n + 1 ? at.flux : at.exit) += by;
    return equations.evaluate(at, floor).residual;
  };
  for (int j = 0; j < n + 3; ++j) D.col(j) = (moved(j, step) - moved(j, -step)) / (2 * step);
  return D;
}

/// Sources that nothing else in the problem resembles.
template <class Scalar>
std::shared_ptr<const SourcesOf<Scalar>> sources() {
  return std::make_shared<const SourcesOf<Scalar>>(SourcesOf<Scalar>{
      .film =
          [](const Scalar& X) {
            return std::pair<Scalar, Scalar>(Scalar(7) / 100 * X * X * X, Scalar(21) / 100 * X * X);
          },
      .balance = [](const Scalar& X) { return std::pair<Scalar, Scalar>(X * X / 20 + Scalar(1) / 50, X / 10); },
      .load = Scalar(0.013)});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hp_collocation)

BOOST_AUTO_TEST_CASE(kernel_rows_are_the_integrals_of_piecewise_polynomials) {
  const Collocation<double> equations(distinct_problem(7, 6, TruncatedAt{-3.3}), mixed_mesh(-3.3), Points::left_radau);
  const Mesh& mesh = equations.mesh();
  VectorOf<double> P(equations.intervals() + 1);
  for (Eigen::Index i = 0; i < P.size(); ++i) P[i] = 0.4 + 0.3 * std::sin(1.7 * static_cast<double>(i * i));  // rough
  std::vector<Place<double>> places;
  for (int e = 0; e < mesh.elements(); ++e) {
    for (const double from_left : {0.0, 1e-9, 0.3, 1.0, 1.7, 2.0}) places.push_back({e, from_left, 2 - from_left});
  }
  const VectorOf<double> found = equations.kernel_rows(places) * P;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double at = equations.xi(places[i]);
    double integral = 0;
    for (int e = 0; e < mesh.elements(); ++e) {
      // In t: Int P ln|xi - xi'| dxi' = half Int P(t) (ln half + ln|u - t|) dt, u from the breakpoints.
      const double half = equations.half_length(e), middle = mesh.breakpoints[static_cast<std::size_t>(e)] + half;
      const double u = places[i].element == e ? places[i].from_left - 1 : (at - middle) / half;
      const Function shape = [&](double t) { return equations.interpolate(P, e, t); };
      integral += half * (log_integral(shape, -1, 1, u) + std::log(half) * smooth_integral(shape, -1, 1));
    }
    BOOST_TEST_CONTEXT("element " << places[i].element << ", " << places[i].from_left << " from its left end") {
      // Seven integrals of size 1, each asked for 1e-13; polynomials of degree 12 through rough values reach 10.
      EHD_CHECK(std::abs(found[static_cast<Eigen::Index>(i)] - integral),
                Tolerance::iteration(asked_of_quadrature, 7 * 10));
    }
  }
  BOOST_TEST(places.size() == 42U);
}

BOOST_AUTO_TEST_CASE(film_of_a_cubic_pressure_is_its_integral_on_a_stretched_domain) {
  const double inlet = -3.3, exit = 1.37;
  const Collocation<double> equations(distinct_problem(7, 6, TruncatedAt{inlet}), mixed_mesh(inlet),
                                      Points::left_radau);
  const Function pressure = [&](double X) { return 0.03 * (exit - X) * (X + 3.9) * (5.1 - X); };
  State<double> state{.P = equations.node_coordinates(exit).unaryExpr(pressure).matrix(), .offset = 0.77, .exit = exit};
  const auto at = equations.evaluate(state, 0);
  const auto rows = at.H.size();
  BOOST_REQUIRE_EQUAL(rows, 46 + 7 + 1);
  EHD_CHECK(error(at.X[rows - 1], inlet), Tolerance::round_off(4));
  BOOST_TEST(at.X[equations.row_of_right_end(6)] == exit);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double X = std::clamp(at.X[i], inlet, exit);
    const double film = 0.77 + X * X / 2 - log_integral(pressure, inlet, exit, X) / pi;
    BOOST_TEST_CONTEXT("row " << i << ", X = " << X) {
      EHD_CHECK(std::abs(at.H[i] - film) / (1 + X * X / 2), Tolerance::round_off(100));
      EHD_CHECK(error(at.P[i], pressure(X)), Tolerance::round_off(100));
      // P' from values of size 1 over the shortest half length, 0.035, times p^2.
      const double slope = 0.03 * (-(X + 3.9) * (5.1 - X) + (exit - X) * (5.1 - X) - (exit - X) * (X + 3.9));
      EHD_CHECK(std::abs(at.slope[i] - slope), Tolerance::round_off(20, 64 / 0.035));
    }
  }
  EHD_CHECK(error(at.load_integral * equations.stretching(exit), smooth_integral(pressure, inlet, exit)),
            Tolerance::round_off(50));
  const Array at_rows = equations.film(state, equations.row_places(), equations.kernel_rows(equations.row_places()));
  EHD_CHECK((at_rows - at.H).abs().maxCoeff(), Tolerance::round_off(50));
}

BOOST_AUTO_TEST_CASE(hertz_pressure_leaves_a_flat_gap_and_hertz_gap_before_it) {
  // Ratio 2 about both ends of the contact down to 2^-28, and one element before it without pressure. On [r, 2r] a
  // root is a polynomial of degree 16 to (3 + sqrt 8)^-16 = 6e-13, times sqrt(r); the ends lose a load of r^(3/2).
  Mesh mesh{.inlet = -3, .breakpoints = {-4}, .degrees = {5}};
  for (int k = 28; k >= 0; --k) mesh.breakpoints.push_back(-2 + (k == 28 ? 0 : std::ldexp(1, -k)));
  for (int k = 1; k < 28; ++k) mesh.breakpoints.push_back(-std::ldexp(1, -k));
  mesh.breakpoints.push_back(0);
  mesh.degrees.resize(mesh.breakpoints.size() - 1, 16);
  const Collocation<double> equations(distinct_problem(7, 6, TruncatedAt{-3}), mesh, Points::left_radau);
  State<double> state{.P = VectorOf<double>::Zero(equations.intervals() + 1), .offset = hertz::dry_offset(), .exit = 1};
  const auto places = equations.node_places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& place = places[i];
    if (place.element == 0) continue;
    const auto e = static_cast<std::size_t>(place.element);
    const double half = equations.half_length(place.element);
    const double from_left = (mesh.breakpoints[e] + 2) + half * place.from_left;   // 1 + X
    const double from_right = -mesh.breakpoints[e + 1] + half * place.from_right;  // 1 - X
    state.P[static_cast<Eigen::Index>(i)] = std::sqrt(from_left * from_right);
  }
  const auto at = equations.evaluate(state, 0);
  const Array gap = hertz::gap(at.X);
  EHD_CHECK((at.H - gap).abs().maxCoeff(),
            Tolerance::discretisation(6e-13, 1));  // of the whole pressure, were none of the elements small
  EHD_CHECK(std::abs(at.residual[equations.intervals() + 1]), Tolerance::discretisation(6e-13, 1));  // the load
  BOOST_TEST(gap.maxCoeff() > 2);
}

BOOST_AUTO_TEST_CASE(a_node_of_two_elements_has_one_film) {
  for (const Inlet& inlet : {Inlet{TruncatedAt{-3.3}}, Inlet{Flooded{}}}) {
    const Collocation<double> equations(distinct_problem(7, 6, inlet), mixed_mesh(-3.3), Points::left_radau);
    const State<double> state = smooth_state(equations);
    std::vector<Place<double>> left, right;
    for (int e = 0; e + 1 < equations.mesh().elements(); ++e) {
      left.push_back({e, 2, 0});
      right.push_back({e + 1, 0, 2});
    }
    const Array H = equations.film(state, left, equations.kernel_rows(left)),
                G = equations.film(state, right, equations.kernel_rows(right));
    BOOST_REQUIRE_EQUAL(H.size(), 6);
    for (Eigen::Index e = 0; e < 6; ++e) EHD_CHECK(error(H[e], G[e]), Tolerance::round_off(20));
  }
}

BOOST_AUTO_TEST_CASE(the_equations_are_those_of_section_2_row_by_row) {
  // Written out once more with plain functions of one pressure.
  const double M = 7, floor = 1e-3, inlet = -3.3;
  const Problem problem = distinct_problem(M, 6, TruncatedAt{inlet});
  const auto roelands = std::get<Roelands>(problem.viscosity);
  const auto dowson = std::get<DowsonHigginson>(problem.density);
  const Collocation<double> equations(problem, mixed_mesh(inlet), Points::left_radau);
  const State<double> state = smooth_state(equations);
  const auto added = sources<double>();
  const Collocation<double> with_sources(problem, mixed_mesh(inlet), Points::left_radau, added);
  const auto at = equations.evaluate(state, floor);
  const auto sourced = with_sources.evaluate(state, floor);
  const double lambda = 3 * pi * pi / (8 * M * M);
  const int n = equations.intervals();
  BOOST_REQUIRE_EQUAL(at.residual.size(), n + 3);
  const auto balance = [&](Eigen::Index i, double film) {
    const double P = at.P[i];
    const double rho = 1 + dowson.a * P / (1 + dowson.c * P);
    const double log_eta = roelands.alpha * roelands.p0 / roelands.z * (std::pow(1 + P / roelands.p0, roelands.z) - 1);
    return rho * film * film * film * (std::exp(-log_eta) + floor) / lambda * at.slope[i] - rho * film + 0.31;
  };
  // ln eta is a difference: rounding moves it by eps times the factor in front.
  const double condition = roelands.alpha * roelands.p0 / roelands.z;
  for (int i = 0; i < n; ++i) {
    EHD_CHECK(std::abs(at.residual[i] - balance(i, at.H[i])) / at.scale[i], Tolerance::round_off(20, condition));
    const double X = at.X[i];
    EHD_CHECK(std::abs(sourced.H[i] - at.H[i] - 0.07 * X * X * X), Tolerance::round_off(20, 10));
    EHD_CHECK(std::abs(sourced.residual[i] - balance(i, sourced.H[i]) + 0.05 * X * X + 0.02) / sourced.scale[i],
              Tolerance::round_off(20, condition));
  }
  EHD_CHECK(error(at.residual[n], state.P[0]), Tolerance::round_off(1));
  EHD_CHECK(std::abs(at.residual[n + 1] - (2 / pi * equations.stretching(1.21) * at.load_integral - 1)),
            Tolerance::round_off(4));
  EHD_CHECK(std::abs(sourced.residual[n + 1] - at.residual[n + 1] + 0.013), Tolerance::round_off(4));
  // At the exit there is no pressure: rho = 1.
  const Eigen::Index last = equations.row_of_right_end(6);
  EHD_CHECK(error(at.residual[n + 2], 0.31 - at.H[last]), Tolerance::round_off(10));
  EHD_CHECK(std::abs(sourced.residual[n + 2] - (0.31 - sourced.H[last] - 0.05 * 1.21 * 1.21 - 0.02)),
            Tolerance::round_off(20));
  BOOST_TEST(at.scale.minCoeff() > 0);
}

BOOST_AUTO_TEST_CASE(jacobian_is_the_derivative_of_the_residual_to_round_off) {
  struct Row {
    Inlet inlet;
    double floor;
    Points points;
    bool with_sources;
  };
  const std::vector<Row> table = {
      {TruncatedAt{-3.3}, 0, Points::left_radau, false}, {TruncatedAt{-3.3}, 1e-3, Points::left_radau, false},
      {Flooded{}, 0, Points::left_radau, false},         {Flooded{}, 1e-3, Points::left_radau, false},
      {TruncatedAt{-3.3}, 1e-3, Points::gauss, true},    {Flooded{}, 0, Points::gauss, true}};
  const auto plain = sources<double>();
  const auto precise = sources<Quad>();
  int rows = 0;
  for (const Row& row : table) {
    BOOST_TEST_CONTEXT((std::holds_alternative<Flooded>(row.inlet) ? "flooded" : "truncated")
                       << ", floor " << row.floor << (row.with_sources ? ", sources" : "")) {
      const Problem problem = distinct_problem(7, 6, row.inlet);
      const Collocation<double> equations(problem, mixed_mesh(-3.3), row.points, row.with_sources ? plain : nullptr);
      const Collocation<Quad> in_quad(problem, mixed_mesh(-3.3), row.points, row.with_sources ? precise : nullptr);
      const State<double> state = smooth_state(equations);
      const State<Quad> same = in_scalar<Quad>(state);
      const MatrixOf<double> J = equations.jacobian(state, equations.evaluate(state, row.floor));
      const MatrixOf<Quad> exact = in_quad.jacobian(same, in_quad.evaluate(same, Quad(row.floor)));
      const MatrixOf<Quad> D = differences(in_quad, same, Quad(row.floor), Quad(1e-11));
      BOOST_REQUIRE_EQUAL(J.rows(), 49);
      BOOST_REQUIRE_EQUAL(J.cols(), 49);
      double formula = 0, rounding = 0;
      for (Eigen::Index i = 0; i < J.rows(); ++i) {
        const Quad size = D.row(i).cwiseAbs().maxCoeff();
        BOOST_REQUIRE(size > 0);
        for (Eigen::Index j = 0; j < J.cols(); ++j) {
          formula = std::max(formula, static_cast<double>(abs(exact(i, j) - D(i, j)) / size));
          rounding = std::max(rounding, static_cast<double>(abs(J(i, j) - D(i, j)) / size));
          BOOST_REQUIRE(std::isfinite(J(i, j)));
        }
      }
      // step^2 = 1e-22 times third derivatives over first ones, up to (alpha p_H)^2 = 40; rounding 1e-34/1e-11.
      EHD_CHECK(formula, Tolerance::discretisation(1e-22, 1e4));
      // Entries of P' are sums of p + 1 with p^2 = 144 times the values.
      EHD_CHECK(rounding, Tolerance::round_off(10, 144));
    }
    ++rows;
  }
  BOOST_TEST(rows == 6);
}

BOOST_AUTO_TEST_CASE(tail_deflection_is_its_integral_and_has_its_slope) {
  // -(1/pi) Int_x^inf 4 lambda/(3 y^3) ln(y + X) dy, y = x/t: -(4 lambda/(3 pi x^2)) Int_0^1 t ln(x/t + X) dt.
  const double lambda = 0.37;
  int rows = 0;
  for (const double x : {3.7, 42.0, 800.0}) {
    // v = X/x: the end, inside, on both sides of both switches to the series, 0, and beyond.
    for (const double v : {-1.0, -1 + 1e-9, -0.93, -0.4, -0.1000001, -0.0999999, -0.02, -1e-7, 0.0, 1e-12, 1e-3, 0.05,
                           0.0999999, 0.1000001, 0.31, 0.9}) {
      const double X = v * x;
      const auto [value, slope] = tail_deflection(lambda, x, X);
      BOOST_TEST_CONTEXT("x = " << x << ", X/x = " << v) {
        const double factor = -4 * lambda / (3 * pi * x * x);
        // By s = 1 - t, so that a logarithm at t = 1 is at 0, where its argument has digits, and s = w^4, so that the
        // quadrature sees a distance of 1e-9 from it.
        const double integral = singular_integral(
            [&](double w) {
              const double s = w * w * w * w;
              return 4 * w * w * w * (1 - s) * (std::log(x) - std::log1p(-s) + std::log((1 + v) - v * s));
            },
            0, 1);
        // Of 1/v and ln(1+v)/v^2 about 1/v^2 digits cancel before the series takes over.
        EHD_CHECK(std::abs(value / factor - integral) / (1 + std::log(x)), Tolerance::round_off(10, 100));
        if (v > -0.99) {  // at -1 the slope has a logarithm
          const double derivative = smooth_integral([&](double t) { return t * t / (x + X * t); }, 0, 1);
          EHD_CHECK(error(slope / factor, derivative), Tolerance::round_off(10, 1000));
        }
        BOOST_TEST(std::isfinite(slope));
      }
      ++rows;
    }
  }
  BOOST_TEST(rows == 48);
}

BOOST_AUTO_TEST_CASE(tail_before_a_flooded_inlet_is_the_integral_of_the_reynolds_equation_there) {
  // P' = lambda (H - C)/H^3 with H = X^2/2 + A: what is left out of pressure and load is of relative size (A/x^2)^2.
  const double lambda = distinct_problem(7, 6, Flooded{}).groups.lambda;
  int rows = 0;
  for (const double x : {20.0, 50.0, 130.0}) {
    Mesh mesh = mixed_mesh(-x);
    mesh.breakpoints.front() = -x - 1.2;
    const Collocation<double> equations(distinct_problem(7, 6, Flooded{}), mesh, Points::left_radau);
    State<double> state{
        .P = VectorOf<double>::Zero(equations.intervals() + 1), .offset = 0.8, .flux = 0.6, .exit = 1.2};
    const auto at = equations.evaluate(state, 0);
    const double A = at.H[at.H.size() - 1] - x * x / 2;
    const auto slope = [&](double y) {
      const double H = y * y / 2 + A;
      return lambda * (H - 0.6) / (H * H * H);
    };
    // y = x/t; load = Int P dy = Int (y - x) P' dy.
    const double pressure = smooth_integral([&](double t) { return t > 0 ? slope(x / t) * x / (t * t) : 0; }, 0, 1);
    const double load =
        smooth_integral([&](double t) { return t > 0 ? slope(x / t) * (x / t - x) * x / (t * t) : 0; }, 0, 1);
    BOOST_TEST_CONTEXT("x = " << x) {
      const auto remainder = Tolerance::asymptotic(40 / (x * x * x * x), "next term, (48 A^2 + 48 A C)/(7 x^4) * 3/4");
      EHD_CHECK(error(at.tail_pressure, pressure), remainder);
      EHD_CHECK(error(at.tail_load, load), remainder);
      EHD_CHECK(error(at.residual[equations.intervals()], -at.tail_pressure), Tolerance::round_off(1));
      EHD_CHECK(error(at.residual[equations.intervals() + 1], 2 / pi * at.tail_load - 1), Tolerance::round_off(4));
    }
    ++rows;
  }
  BOOST_TEST(rows == 3);
}

BOOST_AUTO_TEST_CASE(the_film_of_a_flooded_contact_is_that_of_a_truncated_one_and_the_tails_deflection) {
  const Collocation<double> cut(distinct_problem(7, 6, TruncatedAt{-3.3}), mixed_mesh(-3.3), Points::left_radau),
      full(distinct_problem(7, 6, Flooded{}), mixed_mesh(-3.3), Points::left_radau);
  const State<double> state = smooth_state(cut);
  const auto a = cut.evaluate(state, 0), b = full.evaluate(state, 0);
  for (Eigen::Index i = 0; i < a.H.size(); ++i) {
    const double deflection = tail_deflection(3 * pi * pi / (8 * 49), 3.3, a.X[i]).first;
    EHD_CHECK(std::abs(b.H[i] - a.H[i] - deflection) / b.H[i], Tolerance::round_off(4));
    BOOST_TEST(deflection < 0);
  }
}

BOOST_AUTO_TEST_CASE(film_at_any_place_is_that_of_the_equations_with_sources_too) {
  for (const Inlet& inlet : {Inlet{TruncatedAt{-3.3}}, Inlet{Flooded{}}}) {
    const Collocation<double> equations(distinct_problem(7, 6, inlet), mixed_mesh(-3.3), Points::left_radau,
                                        sources<double>());
    const State<double> state = smooth_state(equations);
    const Array H = equations.film(state, equations.row_places(), equations.kernel_rows(equations.row_places()));
    EHD_CHECK((H - equations.evaluate(state, 0).H).abs().maxCoeff(), Tolerance::round_off(50));
  }
}

BOOST_AUTO_TEST_SUITE_END()
