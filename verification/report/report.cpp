// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/report.hpp"

namespace ehd::report {

std::string report_html(const Documents& documents) {
  const View results(documents.results, "results.json"), bench(documents.bench, "bench.json"),
      stress(documents.stress, "stress.json");
  Page page;
  add_summary(page, results);
  add_contacts(page, results);
  add_convergence(page, results);
  add_work_precision(page, bench);
  add_maps(page, results);
  add_stress(page, stress);
  add_bearing(page, results);
  add_origin(page, results, bench, stress);
  return page.document("ehd: verification report");
}

Look look_of_law(const std::string& law) {
  if (law == "hertz") return {Line::dashed, Marker::circle, 1};
  if (law == "ehd-linear") return {Line::dash_dot, Marker::square, 2};
  if (law == "ehd") return {Line::solid, Marker::triangle, 3};
  if (law == "iso") return {Line::dotted, Marker::diamond, 4};
  return {Line::dotted, Marker::plus, 5};
}

Look look_of_solver(const std::string& solver) {
  if (solver == "reference") return {Line::solid, Marker::circle, 1};
  if (solver == "fast") return {Line::dashed, Marker::square, 2};
  if (solver == "reference.linear") return {Line::dotted, Marker::diamond, 3};
  if (solver == "reference.uniform") return {Line::dash_dot, Marker::triangle, 4};
  if (solver == "fast.uniform") return {Line::dotted, Marker::plus, 5};
  return {Line::dashed, Marker::cross, 6};
}

}  // namespace ehd::report
