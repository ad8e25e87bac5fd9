// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "contact/text.hpp"
#include "workflow/batch.hpp"
#include "workflow/chebyshev.hpp"

namespace ehd {

namespace {

/// Where the range of M is split. The pressure spike passes X = 0 near M = 1.3 (L = 20) to 4 (L = 2.5), and the central
/// film bends there. Above 7 degrees of 8 in M and 6 in L leave 2e-5 over M 7..1000, L 2.5..20; between 2 and 7 the
/// bend takes 10 and 14. One panel over all of it would need 33 x 17 solves.
constexpr std::array bend_M{1.0, 7.0};

/// The stated error is this many times the largest difference to a held-out solve, and the errors of the solves. Of 200
/// to 800 random solves the worst was .7 to 2.5 times that difference, for four tables and each film.
constexpr double found_factor = 3;
/// Held-out solves of a panel: at least so many, and one for so many coefficients.
constexpr long fewest_held_out = 32, coefficients_per_held_out = 4;
/// Where the bend is steep, errors stand along a narrow band, which evenly spread points miss (by 6 times over M 1..7,
/// L 1..25). So every second held-out point is chosen among 32: where the highest degrees contribute most.
constexpr int candidates_a_point = 32;
/// Each solve is asked for this share of the tolerance.
constexpr double solve_share = 0.2;
/// The degrees first grow until the norm of the last coefficients is this share of the tolerance.
constexpr double tail_share = 0.3;
constexpr int first_degree = 4;

/// Point number k of the sequence R2 in the square -1 … 1: any run of it is spread evenly. Source: M. Roberts, The
/// unreasonable effectiveness of quasirandom sequences (2018).
std::pair<double, double> spread_point(int k) {
  constexpr double golden = 1.32471795724474602596;  // g^3 = g + 1
  const auto fraction = [k](double step) {
    const double at = 0.5 + step * (k + 1);
    return 2 * (at - std::floor(at)) - 1;
  };
  return {fraction(1 / golden), fraction(1 / (golden * golden))};
}

/// Held-out solves of a panel with so many coefficients.
long held_out_of(long coefficients) { return std::max(fewest_held_out, coefficients / coefficients_per_held_out); }

/// What a table could not have: the reason in one sentence.
struct NotSolved {
  std::string why;
};

/// A contact that no coefficient was made of.
struct HeldOut {
  MoesGroups at;
  ByFilm<double> films;
};

/// One panel while it grows.
class GrowingPanel {
 public:
  GrowingPanel(FilmTable& table, const FilmTableRequest& request, const FilmSource& source, double M_low, double M_high)
      : table_(table), request_(request), source_(source) {
    panel_.M_low = M_low;
    panel_.M_high = M_high;
    panel_.degree_M = panel_.degree_L = first_degree;
  }

  /// Grows until held-out solves agree with it, or cannot grow. Throws NotSolved.
  void grow() {
    x_ = y_ = leja_points(static_cast<std::size_t>(request_.most_degree) + 1);
    for (fit(); step_by_tails();) fit();
    for (add_held_out(); !agrees(); add_held_out()) {
      bool grown = false;
      do {
        grown = worth_growing() && step_larger_tail();
        if (grown) fit();
      } while (grown && !agrees());
      if (grown) continue;
      table_.status = StopReason::tolerance_not_met;
      break;
    }
    for (std::size_t k = 0; k < table_film_count; ++k) {
      FilmTableErrors& errors = table_.errors[k];
      errors.found = std::max(errors.found, found_[k]);
      errors.solves = std::max(errors.solves, solves_[k]);
    }
    table_.panels.push_back(panel_);
  }

 private:
  std::vector<SolvedFilms> solve(const std::vector<MoesGroups>& contacts, long& count) {
    std::vector<SolvedFilms> solved = source_(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (!solved[i].why.empty())
        throw NotSolved{fmt::format("the contact at M = {}, L = {} was not solved: {}", plain(contacts[i].M),
                                    plain(contacts[i].L), solved[i].why)};
      for (std::size_t k = 0; k < table_film_count; ++k) {
        if (!(solved[i].value[k] > table_shift(table_films[k])))
          throw NotSolved{fmt::format("{} at M = {}, L = {} has no logarithm", to_string(table_films[k]),
                                      plain(contacts[i].M), plain(contacts[i].L))};
        const double unit =
            has_absolute_error(table_films[k]) ? table_error_unit(table_films[k], solved[i].value[k]) : 1;
        solves_[k] = std::max(solves_[k], solved[i].error[k] / unit);
      }
    }
    count += static_cast<long>(contacts.size());
    return solved;
  }

  /// The points that the degrees need and that were not solved before.
  void solve_missing() {
    std::vector<std::pair<int, int>> missing;
    std::vector<MoesGroups> contacts;
    for (int i = 0; i <= panel_.degree_M; ++i)
      for (int j = 0; j <= panel_.degree_L; ++j) {
        if (solved_.count({i, j}) > 0) continue;
        missing.emplace_back(i, j);
        contacts.push_back(
            contact_at(panel_, table_.range, x_[static_cast<std::size_t>(i)], y_[static_cast<std::size_t>(j)]));
      }
    const auto films = solve(contacts, table_.solves);
    for (std::size_t i = 0; i < missing.size(); ++i) solved_[missing[i]] = films[i].value;
  }

  void fit() {
    solve_missing();
    const Eigen::Index rows = panel_.degree_M + 1, columns = panel_.degree_L + 1;
    const std::vector<double> x(x_.begin(), x_.begin() + rows), y(y_.begin(), y_.begin() + columns);
    for (std::size_t k = 0; k < table_film_count; ++k) {
      MatrixOf<double> values(rows, columns);
      for (const auto& [at, films] : solved_)
        if (at.first < rows && at.second < columns)
          values(at.first, at.second) = std::log(films[k] - table_shift(table_films[k]));
      const MatrixOf<double> c = chebyshev_coefficients(values, x, y);
      panel_.coefficients[k].clear();
      for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < columns; ++j) panel_.coefficients[k].push_back(c(i, j));
      set_tails(k, c.cwiseAbs() * size_of(k, values));
    }
  }

  /// The factor from an error of the logarithm to the error that the table states.
  static double size_of(std::size_t k, const MatrixOf<double>& logarithms) {
    const double largest = std::exp(logarithms.maxCoeff());
    return largest / table_error_unit(table_films[k], largest + table_shift(table_films[k]));
  }

  /// What the highest degree of M and that of L contribute.
  void set_tails(std::size_t k, const MatrixOf<double>& c) {
    tail_M_[k] = c.row(c.rows() - 1).norm();
    tail_L_[k] = c.col(c.cols() - 1).norm();
  }

  /// Raises a degree whose tail is too large. False: none is, or the bounds do not allow it.
  bool step_by_tails() {
    const double aim = tail_share * request_.tolerance;
    return step(largest(tail_M_) > aim, largest(tail_L_) > aim);
  }
  bool step_larger_tail() {
    const bool M = largest(tail_M_) >= largest(tail_L_);
    return step(M, !M);
  }
  bool step(bool in_M, bool in_L) {
    const int M = std::min(panel_.degree_M + in_M, request_.most_degree);
    const int L = std::min(panel_.degree_L + in_L, request_.most_degree);
    const long now = (panel_.degree_M + 1L) * (panel_.degree_L + 1L), then = (M + 1L) * (L + 1L);
    if (then == now || table_.solves + table_.held_out + then - now + held_out_of(then) > request_.most_solves)
      return false;
    panel_.degree_M = M;
    panel_.degree_L = L;
    return true;
  }

  /// More coefficients cannot help where a solve alone states more than the tolerance.
  [[nodiscard]] bool worth_growing() const { return largest(solves_) < request_.tolerance; }

  static double largest(const ByFilm<double>& values) { return *std::max_element(values.begin(), values.end()); }
  /// What the two highest degrees of M, or of L, contribute to a film at a place of the panel, at most. Two, because
  /// one alone vanishes at places where the degrees left out do not.
  [[nodiscard]] double last_terms(double x, double y) const {
    const ChebyshevBasis of_M(panel_.degree_M, x), of_L(panel_.degree_L, y);
    const std::size_t columns = static_cast<std::size_t>(panel_.degree_L) + 1;
    double largest_term = 0;
    for (const std::vector<double>& c : panel_.coefficients) {
      double by_M = 0, by_L = 0;
      for (const int back : {0, 1}) {
        const int i_last = panel_.degree_M - back, j_last = panel_.degree_L - back;
        double row = 0, column = 0;
        for (int j = 0; j <= panel_.degree_L; ++j)
          row += c[static_cast<std::size_t>(i_last) * columns + static_cast<std::size_t>(j)] * of_L.value[j];
        for (int i = 0; i <= panel_.degree_M; ++i)
          column += c[static_cast<std::size_t>(i) * columns + static_cast<std::size_t>(j_last)] * of_M.value[i];
        by_M += std::abs(row * of_M.value[i_last]);
        by_L += std::abs(column * of_L.value[j_last]);
      }
      largest_term = std::max({largest_term, by_M, by_L});
    }
    return largest_term;
  }

  /// The next point of the spread, or the one of the next few where the highest degrees contribute most.
  MoesGroups next_held_out(int candidates) {
    double largest_term = -1;
    std::pair<double, double> chosen;
    for (int k = 0; k < candidates; ++k) {
      const auto at = spread_point(spread_points_used_++);
      const double term = last_terms(at.first, at.second);
      if (!(term > largest_term)) continue;
      largest_term = term;
      chosen = at;
    }
    return contact_at(panel_, table_.range, chosen.first, chosen.second);
  }

  /// Solves further held-out points. Those before have decided about degrees; these have not.
  void add_held_out() {
    std::vector<MoesGroups> contacts;
    const long count = held_out_of((panel_.degree_M + 1L) * (panel_.degree_L + 1L));
    for (long k = 0; k < count; ++k) contacts.push_back(next_held_out(k % 2 == 0 ? 1 : candidates_a_point));
    const auto solved = solve(contacts, table_.held_out);
    for (std::size_t i = 0; i < contacts.size(); ++i) held_out_.push_back({contacts[i], solved[i].value});
  }

  /// Measures the largest error at the held-out points. True: what the panel then states meets the tolerance, also
  /// where the solves of another panel err by the share that each is asked for.
  bool agrees() {
    const FilmTable alone{.lubricant = {}, .inlet = {}, .range = table_.range, .panels = {panel_}, .reason = {}};
    found_ = {};
    for (const HeldOut& point : held_out_) {
      const auto films = *films_at(alone, point.at);
      for (std::size_t k = 0; k < table_film_count; ++k)
        found_[k] = std::max(
            found_[k], std::abs(films[k].value - point.films[k]) / table_error_unit(table_films[k], point.films[k]));
    }
    for (std::size_t k = 0; k < table_film_count; ++k)
      if (!(found_factor * found_[k] + std::max(solves_[k], solve_share * request_.tolerance) <= request_.tolerance))
        return false;
    return true;
  }

  FilmTable& table_;
  const FilmTableRequest& request_;
  const FilmSource& source_;
  FilmPanel panel_;
  std::vector<double> x_, y_;
  std::map<std::pair<int, int>, ByFilm<double>> solved_;
  ByFilm<double> tail_M_ = {}, tail_L_ = {}, found_ = {}, solves_ = {};
  std::vector<HeldOut> held_out_;
  int spread_points_used_ = 0;
};

/// The panels: the range, split where the films bend.
std::vector<double> panel_ends(const FilmRange& range) {
  std::vector<double> ends{range.M_low};
  for (const double M : bend_M)
    if (M > range.M_low && M < range.M_high) ends.push_back(M);
  ends.push_back(range.M_high);
  return ends;
}

void state_errors(FilmTable& table) {
  double worst = 0;
  std::size_t of = 0;
  for (std::size_t k = 0; k < table_film_count; ++k) {
    FilmTableErrors& errors = table.errors[k];
    errors.stated = found_factor * errors.found + errors.solves;
    if (errors.stated > worst) {
      worst = errors.stated;
      of = k;
    }
  }
  // One panel may have the largest error found, another solves that err by more than they were asked for.
  if (worst > table.tolerance) table.status = StopReason::tolerance_not_met;
  if (table.status == StopReason::tolerance_not_met)
    table.reason = fmt::format(
        "the stated error of {} is {} after {} solves and {} held-out ones; the largest found is {}",
        to_string(table_films[of]), plain(worst, 2), table.solves, table.held_out, plain(table.errors[of].found, 2));
}

}  // namespace

long fewest_solves(const FilmRange& range) {
  constexpr long nodes = first_degree + 1, first_grid = nodes * nodes;
  return static_cast<long>(panel_ends(range).size() - 1) * (first_grid + held_out_of(first_grid));
}

FilmTable build_film_table(const TableOil& oil, const FilmTableRequest& request, const FilmSource& source) {
  FilmTable table{.solver = default_solver().name,
                  .lubricant = oil.lubricant,
                  .inlet = oil.inlet,
                  .range = request.range,
                  .tolerance = request.tolerance,
                  .panels = {}};
  try {
    const std::vector<double> ends = panel_ends(request.range);
    for (std::size_t p = 0; p + 1 < ends.size(); ++p) GrowingPanel(table, request, source, ends[p], ends[p + 1]).grow();
  } catch (const NotSolved& failure) {
    table.status = StopReason::limit_reached;
    table.reason = failure.why;
    table.panels.clear();
    return table;
  }
  state_errors(table);
  return table;
}

// -- the solves -------------------------------------------------------------------------------------------------

FilmSource film_solves(const TableOil& oil, const FilmTableRequest& request, unsigned threads, double time_limit_s,
                       const Deadline& deadline) {
  RegisteredSolver solver = default_solver();
  solver.solve = deadline.limiting(solver.solve);
  Request each;
  each.tolerance = solve_share * request.tolerance;
  each.time_limit_s = time_limit_s;
  return [oil, solver, each, threads](const std::vector<MoesGroups>& contacts) {
    std::vector<Problem> problems;
    for (const MoesGroups& at : contacts) {
      problems.push_back(problem_of(oil, at));
      problems.back().wanted = {table_films.begin(), table_films.end()};
    }
    std::vector<SolvedFilms> films;
    for (const Solution& solution : solve_all(solver, problems, each, threads)) {
      SolvedFilms& one = films.emplace_back();
      const SolveRecord& record = solution.record;
      // A solve that missed its tolerance states its error, and the table's error has it.
      if (record.status != StopReason::converged && record.status != StopReason::tolerance_not_met)
        one.why = std::string(to_string(record.status)) + (record.reason.empty() ? "" : ": " + record.reason);
      for (std::size_t k = 0; k < table_film_count && one.why.empty(); ++k) {
        const auto at = solution.observables.find(table_films[k]);
        if (at == solution.observables.end() || !at->second.error) {
          one.why = std::string(to_string(table_films[k])) + " is not known with an error";
          break;
        }
        one.value[k] = at->second.value;
        one.error[k] = *at->second.error;
      }
    }
    return films;
  };
}

}  // namespace ehd
