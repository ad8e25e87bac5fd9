// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/bench/cost_scaling.hpp"

#include <fftw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>
#include <set>

#include "contact/text.hpp"
#include "fast/convolution.hpp"
#include "io/duration.hpp"
#include "io/json.hpp"
#include "io/tables.hpp"
#include "verification/bench/child.hpp"
#include "verification/bench/csv.hpp"
#include "verification/bench/setting.hpp"
#include "verification/studies/box.hpp"

namespace ehd::verification {

namespace {

constexpr int fewest = 256;        ///< intervals of the first size
constexpr int warm_up_nodes = 64;  ///< of the solve before anything is measured
constexpr int fewest_to_fit = 3;   ///< sizes that an exponent is fitted to
/// Sizes that an exponent is fitted from: on fewer intervals, costs that do not grow with n weigh too much.
constexpr int far_enough = 4096;
/// Largest sizes: of solvers on uniform grids, of other FFT solvers, of all when quick.
constexpr int far = 1 << 20, middle = 1 << 14, near = 1 << 12;
constexpr double trend_repeat_s = 5;  ///< longer than usual, since the trend is read from few large sizes

bool same(const MoesGroups& a, const MoesGroups& b) { return a.M == b.M && a.L == b.L; }

std::string name_of(const MoesGroups& contact) { return fmt::format("({}, {})", plain(contact.M), plain(contact.L)); }

}  // namespace

double convolution_s(int intervals, const Repetition& repetition) {
  if (intervals < 1) throw std::invalid_argument(fmt::format("a convolution on {} intervals", intervals));
  const int length = 2 * intervals, modes = length / 2 + 1;
  double* const real = fftw_alloc_real(static_cast<std::size_t>(length));
  fftw_complex* const spectrum = fftw_alloc_complex(static_cast<std::size_t>(modes));
  if (!real || !spectrum) throw std::bad_alloc();
  fast::require_plan_memory(length);
  const fftw_plan forward = fftw_plan_dft_r2c_1d(length, real, spectrum, FFTW_ESTIMATE);
  const fftw_plan backward = fftw_plan_dft_c2r_1d(length, spectrum, real, FFTW_ESTIMATE);
  const Array kernel = Array::LinSpaced(modes, 1, 2) / length;
  const Array x = Array::LinSpaced(intervals, -1, 1).square();
  Array y = Array::Zero(intervals);
  std::vector<double> seconds;
  do {
    const Stopwatch watch;
    std::copy(x.begin(), x.end(), real);
    std::fill(real + intervals, real + length, 0.0);
    fftw_execute(forward);
    for (int k = 0; k < modes; ++k) {
      spectrum[k][0] *= kernel[k];
      spectrum[k][1] *= kernel[k];
    }
    fftw_execute(backward);
    std::copy(real, real + intervals, y.begin());
    seconds.push_back(watch.seconds());
  } while (!repetition.satisfied_by(seconds));
  fftw_destroy_plan(forward);
  fftw_destroy_plan(backward);
  fftw_free(real);
  fftw_free(spectrum);
  return median(seconds);
}

double c_now() {
  constexpr Repetition many{.least = 200, .least_s = 0.02, .enough_s = 0.1, .most = 100000};
  return convolution_s(unit_intervals, many);
}

std::optional<double> ScalingRow::median_s() const {
  return wall_s.empty() ? std::nullopt : std::optional(median(wall_s));
}

std::optional<double> ScalingRow::per_unit() const {
  const double bare = work_units * convolution_s;
  return wall_s.empty() || !(bare > 0) ? std::nullopt : std::optional(*median_s() / bare);
}

std::optional<double> ScalingRow::ns_per_n_log_n() const {
  if (wall_s.empty() || nodes_used < 2) return std::nullopt;
  constexpr double nanoseconds = 1e9;
  return nanoseconds * *median_s() / (nodes_used * std::log2(nodes_used));
}

ScalingRequest usual_scaling(const std::vector<const RegisteredSolver*>& solvers, bool quick) {
  ScalingRequest request;
  if (!quick) request.repetition.enough_s = trend_repeat_s;
  request.contacts = quick ? std::vector<MoesGroups>{{5, 5}} : std::vector<MoesGroups>{{20, 10}, {5, 5}};
  for (const RegisteredSolver* solver : solvers) {
    if (!solver->uses_fft) continue;  // dense solvers: n^3, and memory n^2
    const bool uniform = solver->name.ends_with(".uniform");
    request.solvers.push_back({solver, quick ? near : uniform ? far : middle});
  }
  return request;
}

namespace {

/// One size, measured in the child.
Json measured(const RegisteredSolver& solver, const Problem& problem, const Request& asked,
              const Repetition& repetition) {
  // A small solve first loads the pages of the program and its libraries, which do not belong to the measured solve.
  (void)solver.solve(problem, {.tolerance = {}, .nodes = warm_up_nodes, .time_limit_s = asked.time_limit_s});
  return_free_memory();
  const double before = resident_memory_bytes();
  std::vector<double> seconds;
  Json json;
  while (!repetition.satisfied_by(seconds)) {
    const Solution solution = solver.solve(problem, asked);
    const SolveRecord& record = solution.record;
    seconds.push_back(record.cost.wall_s);
    if (seconds.size() > 1) continue;
    json["peak_bytes"] = peak_memory_bytes() - before;
    json["status"] = static_cast<int>(record.status);
    json["reason"] = record.reason;
    json["nodes"] = record.cost.nodes;
    json["work_units"] = record.cost.work_units;
    json["newton_iterations"] = record.cost.newton_iterations;
    json["stages"] = Json::array();
    for (const auto& [stage, s] : record.cost.stage_s) json["stages"].push_back({{"name", stage}, {"s", s}});
    if (record.status != StopReason::converged) break;
  }
  json["wall_s"] = seconds;
  json["convolution_s"] = convolution_s(*asked.nodes, repetition);  // at once, so that the machine is equally busy
  return json;
}

void fill(const Json& json, ScalingRow& row) {
  row.status = static_cast<StopReason>(json["status"].get<int>());
  row.reason = json["reason"];
  row.wall_s = json["wall_s"].get<std::vector<double>>();
  row.convolution_s = json["convolution_s"];
  row.peak_bytes = json["peak_bytes"];
  row.nodes_used = json["nodes"];
  row.work_units = json["work_units"];
  row.newton_iterations = json["newton_iterations"];
  for (const Json& stage : json["stages"]) row.stage_s.emplace_back(stage["name"], stage["s"]);
}

}  // namespace

std::vector<ScalingRow> run_scaling(const ScalingRequest& request) {
  std::vector<ScalingRow> rows;
  for (const MoesGroups& contact : request.contacts) {
    const Problem problem = problem_at(contact, true, TruncatedAt{usual_cut});
    int most = 0;
    for (const auto& range : request.solvers) most = std::max(most, range.most);
    std::set<std::string> given_up;
    // Sizes outside, solvers inside: solvers are compared at about the same time.
    for (int n = fewest; n <= most; n *= 2) {
      for (const auto& [solver, largest] : request.solvers) {
        if (n > largest) continue;
        ScalingRow row{.solver = solver->name, .contact = contact, .nodes = n};
        if (given_up.contains(solver->name)) {
          row.reason = "not run: fewer intervals already reached the time limit";
        } else if (solver->memory_bytes(n) > available_memory_bytes()) {
          row.reason = "not run: it would not fit into memory";
        } else {
          if (request.progress) request.progress(fmt::format("{}: {}, n = {}", name_of(contact), solver->name, n));
          const Request asked = Setting{.solver = solver->name, .nodes = n}.request(request.time_limit_s);
          const ChildEnd end = [&, one = solver]() -> ChildEnd {
            try {
              return in_child([&] { return measured(*one, problem, asked, request.repetition).dump(); });
            } catch (const Refused& refused) {
              return {{}, refused.what()};
            } catch (const std::bad_alloc&) {
              return {{}, memory_is_exhausted};
            }
          }();
          if (end.text) {
            fill(Json::parse(*end.text), row);
          } else {
            row.reason = "not measured: " + end.why;
          }
          if (row.status == StopReason::limit_reached) given_up.insert(solver->name);
        }
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

std::optional<double> fitted_exponent(const std::vector<ScalingRow>& rows, const std::string& solver,
                                      const MoesGroups& contact, int least) {
  std::vector<double> x, y;
  for (const ScalingRow& row : rows) {
    if (row.solver != solver || !same(row.contact, contact) || row.status != StopReason::converged) continue;
    if (row.nodes_used < least) continue;
    x.push_back(std::log(row.nodes_used));
    y.push_back(std::log(*row.median_s()));
  }
  if (x.size() < fewest_to_fit) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(x.size());
  const Array logs = Eigen::Map<const Array>(x.data(), count), times = Eigen::Map<const Array>(y.data(), count);
  const Array from_mean = logs - logs.mean();
  return (from_mean * (times - times.mean())).sum() / from_mean.square().sum();
}

// -- output -----------------------------------------------------------------------------------------------------

Json to_json(const std::vector<ScalingRow>& rows) {
  Json list = Json::array();
  for (const ScalingRow& row : rows) {
    Json json{{"solver", row.solver},
              {"M", row.contact.M},
              {"L", row.contact.L},
              {"nodes_asked", row.nodes},
              {"status", status_cell(row.status)}};
    if (!row.reason.empty()) json["reason"] = row.reason;
    if (row.status) {
      json["nodes"] = row.nodes_used;
      put(json, "wall_s", row.median_s());
      json["solves"] = row.wall_s.size();
      put(json, "work_units", row.work_units);
      json["newton_iterations"] = row.newton_iterations;
      put(json, "convolution_s", row.convolution_s);
      put(json, "time_per_unit", row.per_unit());
      put(json, "ns_per_n_log2_n", row.ns_per_n_log_n());
      put(json, "peak_bytes", row.peak_bytes);
      for (const auto& [stage, seconds] : row.stage_s) put(json["stage_s"], stage, seconds);
    }
    list.push_back(json);
  }
  return list;
}

namespace {

/// Stages of all rows, each once, in order of appearance.
std::vector<std::string> stages_of(const std::vector<ScalingRow>& rows) {
  std::vector<std::string> stages;
  for (const ScalingRow& row : rows) {
    for (const auto& [stage, seconds] : row.stage_s) {
      if (std::find(stages.begin(), stages.end(), stage) == stages.end()) stages.push_back(stage);
    }
  }
  return stages;
}

}  // namespace

std::string scaling_csv(const std::vector<ScalingRow>& rows) {
  const std::vector<std::string> stages = stages_of(rows);
  std::vector<std::string> header{
      "solver",          "M",         "L",          "nodes_asked",       "status",        "nodes",
      "wall_s",          "solves",    "work_units", "newton_iterations", "convolution_s", "time_per_unit",
      "ns_per_n_log2_n", "peak_bytes"};
  for (const auto& stage : stages) header.push_back(stage + "_s");
  std::string csv = csv_line(header);
  for (const ScalingRow& row : rows) {
    std::vector<std::string> cells{row.solver, plain(row.contact.M), plain(row.contact.L), std::to_string(row.nodes),
                                   status_cell(row.status)};
    if (row.status) {
      for (const auto& cell :
           {std::to_string(row.nodes_used), csv_number(row.median_s()), std::to_string(row.wall_s.size()),
            csv_number(row.work_units), std::to_string(row.newton_iterations), csv_number(row.convolution_s),
            csv_number(row.per_unit()), csv_number(row.ns_per_n_log_n()), csv_number(row.peak_bytes)})
        cells.push_back(cell);
    } else {
      cells.resize(cells.size() + 9);
    }
    for (const auto& stage : stages) {
      const auto at =
          std::find_if(row.stage_s.begin(), row.stage_s.end(), [&](const auto& one) { return one.first == stage; });
      cells.push_back(at == row.stage_s.end() ? "" : csv_number(at->second));
    }
    csv += csv_line(cells);
  }
  return csv;
}

namespace {

std::string costs_table(const std::vector<ScalingRow>& rows) {
  constexpr double megabyte = 1e6;
  std::vector<std::vector<std::string>> table{{"M, L", "solver", "intervals", "status", "time [ms]", "solves",
                                               "work units", "one convolution [ms]", "time/(units x it)",
                                               "ns/(n log2 n)", "peak [MB]", "bytes/n"}};
  for (const ScalingRow& row : rows) {
    const bool ran = row.status.has_value();
    const auto time = row.median_s();
    table.push_back({name_of(row.contact), row.solver, std::to_string(row.nodes),
                     ran ? std::string(to_string(*row.status)) : "not run", time ? milliseconds(*time) : "-",
                     std::to_string(row.wall_s.size()), ran ? plain(row.work_units, 3) : "-",
                     ran ? milliseconds(row.convolution_s) : "-", dash(row.per_unit(), 3),
                     dash(row.ns_per_n_log_n(), 3), ran ? plain(row.peak_bytes / megabyte, 3) : "-",
                     ran ? plain(row.peak_bytes / row.nodes, 3) : "-"});
  }
  return "Cost against the number of intervals, each size in a process of its own\n" + aligned_in_parts(table, 3, "  ");
}

std::string reasons_list(const std::vector<ScalingRow>& rows) {
  std::string text;
  for (const ScalingRow& row : rows) {
    if (!row.reason.empty())
      text += fmt::format("  {}, {}, n = {}: {}\n", name_of(row.contact), row.solver, row.nodes, row.reason);
  }
  return text.empty() ? "" : "\n" + text;
}

std::string exponents_table(const std::vector<ScalingRow>& rows) {
  std::vector<std::vector<std::string>> table{{"M, L", "solver", "time ~ n^"}};
  for (const ScalingRow& row : rows) {
    const bool seen = std::any_of(rows.data(), &row, [&](const ScalingRow& before) {
      return before.solver == row.solver && same(before.contact, row.contact);
    });
    if (seen) continue;
    if (const auto exponent = fitted_exponent(rows, row.solver, row.contact, far_enough))
      table.push_back({name_of(row.contact), row.solver, plain(*exponent, 3)});
  }
  if (table.size() == 1) return "";
  return fmt::format("\nfitted from n = {}\n{}", far_enough, aligned_in_parts(table, 2, "  "));
}

std::string stages_table(const std::vector<ScalingRow>& rows) {
  std::vector<std::vector<std::string>> table{{"M, L", "solver", "intervals"}};
  for (const ScalingRow& row : rows) {
    if (row.stage_s.empty() || row.wall_s.empty()) continue;  // every row has the same stages: fast/run.cpp
    table.push_back({name_of(row.contact), row.solver, std::to_string(row.nodes)});
    for (const auto& [stage, seconds] : row.stage_s) {
      if (table.size() == 2) table.front().push_back(stage);
      table.back().push_back(plain(100 * seconds / row.wall_s.front(), 2));
    }
  }
  return table.size() == 1 ? "" : "\nwhere the first solve's time went [%]\n" + aligned_in_parts(table, 3, "  ");
}

}  // namespace

std::string human_table(const std::vector<ScalingRow>& rows) {
  return fmt::format("{}{}{}{}\n", costs_table(rows), reasons_list(rows), exponents_table(rows), stages_table(rows));
}

}  // namespace ehd::verification
