// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 5: the coupled equations against manufactured solutions with real deflection, both laws and full film
// (verification/studies/manufactured_study.hpp). Orders are fitted over four grids.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

#include "contact/text.hpp"
#include "verification/claims/shared.hpp"
#include "verification/claims/topics.hpp"
#include "verification/studies/fits.hpp"
#include "verification/studies/manufactured_study.hpp"
#include "verification/studies/motion_study.hpp"

namespace ehd::verification {

namespace {

using exact::Manufactured;
using Contact = ManufacturedContact;
using Errors = ManufacturedErrors;

Findings judge_solver(const Contact& contact, const RegisteredSolver& solver) {
  const Manufactured truth = contact.make();
  constexpr auto& grids = manufactured_grids;
  std::vector<Errors> errors;
  std::vector<double> x;
  for (const int intervals : grids) {
    errors.push_back(errors_of_solver(solver, truth, intervals));
    x.push_back(-std::log(intervals));
  }
  Findings found;
  for (const auto& [what, member] : manufactured_quantities) {
    std::vector<double> y;
    for (const Errors& one : errors) y.push_back(std::log(one.*member));
    found.claims.push_back(
        order_claim({.id = fmt::format("manufactured/{}/{}/{}", contact.name, solver.name, what),
                     .rung = 5,
                     .statement = fmt::format("{} reaches the manufactured {} ({}) with its declared order",
                                              solver.name, what, contact.name),
                     .solver = solver.name},
                    slope(x, y), solver.description.formal_order, order_over_four_grids(),
                    fmt::format("error {} on {} cells", scientific(errors.back().*member, 2), grids[3])));
  }
  return found;
}

/// Order in h. Continuous piecewise polynomials of degree p that satisfy a first-order equation at p >= 2 Radau points
/// have order p + 1 everywhere (de Boor & Swartz 1973, SIAM J. Numer. Anal. 10, 582). Integrals converge faster; they
/// are not judged.
Findings judge_collocation_in_h(const Contact& contact) {
  const Manufactured truth = contact.make();
  Findings found;
  for (const int degree : {2, 3}) {
    std::vector<double> x, y;
    for (const int elements : collocation_elements) {
      x.push_back(-std::log(elements));
      y.push_back(std::log(errors_of_collocation(truth, elements, degree).pressure));
    }
    found.claims.push_back(order_claim(
        {.id = fmt::format("manufactured/{}/collocation/degree-{}", contact.name, degree),
         .rung = 5,
         .statement = fmt::format("collocation of degree {} reaches the manufactured pressure ({}) with order {}",
                                  degree, contact.name, degree + 1),
         .solver = certified_solver().name},
        slope(x, y), degree + 1, order_over_four_grids(),
        fmt::format("error {} on 162 elements", scientific(std::exp(y.back()), 2))));
  }
  return found;
}

/// In p the convergence is geometric. Each degree divides the error by Bernstein's factor.
Findings judge_collocation_in_p(const Contact& contact) {
  const Manufactured truth = contact.make();
  const double ellipse = bernstein_factor(truth, collocation_elements_in_p);
  std::vector<double> x, y;
  for (const int degree : collocation_degrees) {
    x.push_back(degree);
    y.push_back(std::log(errors_of_collocation(truth, collocation_elements_in_p, degree).pressure));
  }
  Findings found;
  found.claims.push_back(
      order_claim({.id = "manufactured/" + contact.name + "/collocation/spectral",
                   .rung = 5,
                   .statement = "collocation reaches the manufactured pressure (" + contact.name +
                                ") geometrically in the degree, at the rate of its pole",
                   .solver = certified_solver().name},
                  std::exp(-slope(x, y)), ellipse,
                  Tolerance::calibrated(0.1 * ellipse,
                                        "the factor a degree, fitted over seven degrees, is read to a tenth of itself"),
                  fmt::format("degrees 6 to 18 on 5 elements, error {} at 18", scientific(std::exp(y.back()), 2))));
  return found;
}

// ---- small motion about them -------------------------------------------------------------------------------------

Findings judge_motion_of_fast(const Contact& contact) {
  const auto truth = exact::ManufacturedMotion::about(contact.make());
  std::vector<MotionErrors> errors;
  std::vector<double> x;
  for (const int intervals : manufactured_grids) {
    errors.push_back(motion_errors_of_fast(truth, intervals));
    x.push_back(-std::log(intervals));
  }
  Findings found;
  for (const auto& [what, member] : motion_quantities) {
    std::vector<double> y;
    for (const MotionErrors& one : errors) y.push_back(std::log(one.*member));
    found.claims.push_back(order_claim(
        {.id = fmt::format("manufactured/{}/motion/fast/{}", contact.name, what),
         .rung = 5,
         .statement =
             fmt::format("the harmonic equations of fast reach the manufactured {} ({}) with the order of its grids",
                         what, contact.name),
         .solver = "fast"},
        slope(x, y), default_solver().description.formal_order, order_over_four_grids(),
        fmt::format("error {} on {} cells", scientific(errors.back().*member, 2), manufactured_grids[3])));
  }
  return found;
}

/// The first-order equations are collocated at the same points, so that they have the same orders.
Findings judge_motion_of_collocation(const Contact& contact) {
  const auto truth = exact::ManufacturedMotion::about(contact.make());
  Findings found;
  for (const int degree : {2, 3}) {
    std::vector<double> x, y;
    for (const int elements : motion_elements) {
      x.push_back(-std::log(elements));
      y.push_back(std::log(motion_errors_of_collocation(truth, elements, degree).pressure));
    }
    found.claims.push_back(order_claim(
        {.id = fmt::format("manufactured/{}/motion/collocation/degree-{}", contact.name, degree),
         .rung = 5,
         .statement =
             fmt::format("harmonic collocation of degree {} reaches the manufactured pressure ({}) with order {}",
                         degree, contact.name, degree + 1),
         .solver = certified_solver().name},
        slope(x, y), degree + 1, order_over_four_grids(),
        fmt::format("error {} on {} elements", scientific(std::exp(y.back()), 2), motion_elements[3])));
  }
  return found;
}

}  // namespace

std::vector<Topic> coupled_topics() {
  std::vector<Topic> topics;
  const auto add = [&](std::function<Findings()> judge) {
    topics.push_back({.name = "manufactured solutions", .rungs = {5}, .judge = std::move(judge)});
  };
  for (const Contact& contact : manufactured_contacts) {
    for (const RegisteredSolver& solver : solvers())
      if (!solver.certified) add([&contact, &solver] { return judge_solver(contact, solver); });
    add([&contact] { return judge_collocation_in_h(contact); });
    add([&contact] { return judge_collocation_in_p(contact); });
    add([&contact] { return judge_motion_of_fast(contact); });
    add([&contact] { return judge_motion_of_collocation(contact); });
  }
  return topics;
}

}  // namespace ehd::verification
