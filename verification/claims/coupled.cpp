// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 5: the coupled equations against a manufactured solution: real deflection, both laws, full film
// (verification/studies/manufactured_study.hpp). Orders are fitted over four grids.
#include <cmath>
#include <functional>
#include <string>

#include "verification/claims/topics.hpp"
#include "verification/studies/fits.hpp"
#include "verification/studies/manufactured_study.hpp"

namespace ehd::verification {

namespace {

using exact::Manufactured;
using Contact = ManufacturedContact;
using Errors = ManufacturedErrors;

Findings judge_solver(const Contact& contact, const std::string& name) {
  const Manufactured truth = contact.make();
  const RegisteredSolver& solver = *find_solver(name);
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
    found.claims.push_back(order_claim(
        {.id = "manufactured/" + contact.name + "/" + name + "/" + what,
         .rung = 5,
         .statement = name + " reaches the manufactured " + what + " (" + contact.name + ") with its declared order",
         .solver = name},
        slope(x, y), solver.description.formal_order,
        Tolerance::calibrated(0.1, "fitted orders over four grids are read to a tenth"),
        "error " + three_digits(errors.back().*member) + " on " + std::to_string(grids[3]) + " cells"));
  }
  return found;
}

/// In h: continuous piecewise polynomials of degree p that satisfy a first-order equation at the zeros of a polynomial
/// orthogonal to a constant (p >= 2 Radau points) have order p + 1 everywhere (de Boor & Swartz 1973, SIAM
/// J. Numer. Anal. 10, 582). Numbers that are integrals converge faster, and are not judged.
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
        {.id = "manufactured/" + contact.name + "/collocation/degree-" + std::to_string(degree),
         .rung = 5,
         .statement = "collocation of degree " + std::to_string(degree) + " reaches the manufactured pressure (" +
                      contact.name + ") with order " + std::to_string(degree + 1),
         .solver = "reference"},
        slope(x, y), degree + 1, Tolerance::calibrated(0.1, "fitted orders over four grids are read to a tenth"),
        "error " + three_digits(std::exp(y.back())) + " on 162 elements"));
  }
  return found;
}

/// In p: geometric, at Bernstein's factor a degree.
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
                   .solver = "reference"},
                  std::exp(-slope(x, y)), ellipse,
                  Tolerance::calibrated(0.1 * ellipse,
                                        "the factor a degree, fitted over seven degrees, is read to a tenth of itself"),
                  "degrees 6 to 18 on 5 elements, error " + three_digits(std::exp(y.back())) + " at 18"));
  return found;
}

}  // namespace

std::vector<Topic> coupled_topics() {
  std::vector<Topic> topics;
  const auto add = [&](std::function<Findings()> judge) {
    topics.push_back({.name = "manufactured solutions", .rungs = {5}, .judge = std::move(judge)});
  };
  for (const Contact& contact : manufactured_contacts) {
    for (const std::string name : {"reference.uniform", "reference.linear", "fast.uniform", "fast"})
      add([&contact, name] { return judge_solver(contact, name); });
    add([&contact] { return judge_collocation_in_h(contact); });
    add([&contact] { return judge_collocation_in_p(contact); });
  }
  return topics;
}

}  // namespace ehd::verification
