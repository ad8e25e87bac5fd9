// SPDX-License-Identifier: GPL-3.0-or-later
#include "workflow/film_table_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "contact/text.hpp"
#include "workflow/chebyshev.hpp"
#include "workflow/film_table_bend.hpp"
#include "workflow/registry.hpp"

namespace ehd {

namespace {

/// The stated error is this many times the largest difference to a held-out solve, and the errors of the solves. Of 200
/// to 800 random solves the worst was .7 to 2.5 times that difference, for four tables and each film.
constexpr double found_factor = 3;
/// Held-out solves of a panel: at least so many, and one for so many coefficients.
constexpr long fewest_held_out = 32, coefficients_per_held_out = 4;
/// Held-out solves between the first solved contact and the bend: at these y of each panel and these shares of the way
/// in x. The table errs most at the bend: at .5 alone it was off by up to 2.8 times what it then stated.
constexpr double y_in_gap[] = {-0.8, 0, 0.8}, x_in_gap[] = {0.5, 0.98};
constexpr long solves_in_gap = std::ssize(y_in_gap) * std::ssize(x_in_gap);
/// Where the bend is steep, errors stand along a narrow band, which evenly spread points miss (by 6 times over M 1..7,
/// L 1..25). So every second held-out point is chosen among 32: where the highest degrees contribute most.
constexpr int candidates_a_point = 32;
/// The degrees first grow until the norm of the last coefficients is this share of the tolerance.
constexpr double tail_share = 0.3;
constexpr int first_degree = 4;
/// A panel is given up for smaller ones where its last coefficients are so many times too large, or where it has so
/// many coefficients. Between M = 1 or 2 and 7, at degree 8, panels with less than 37 times came to 130 to 270
/// coefficients and panels with more than 53 times to 400 to 1100 or no end. From degree 8 on the times halve in two
/// degrees.
constexpr int telling_degree = 8;
double hopeless_tail(int degree) { return std::max(2.0, 45 * std::exp2((telling_degree - degree) / 2.0)); }
constexpr long most_promising = 300;
/// A panel beside the bend takes 100 to 350 solves. None is planned where fewer are allowed for each.
constexpr long solves_a_panel = 150, fewest_smaller = 4;

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

constexpr long fewest_nodes = (first_degree + 1L) * (first_degree + 1L);
constexpr long fewest_of_a_panel = fewest_nodes + fewest_held_out;
static_assert(fewest_nodes / coefficients_per_held_out <= fewest_held_out);

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
  /// `reserved`: solves that later panels need.
  GrowingPanel(FilmTable& table, const FilmTableRequest& request, const FilmSource& source, const PanelPlan& plan,
               long reserved)
      : table_(table), request_(request), source_(source), plan_(plan), reserved_(reserved) {
    panel_.shape = plan.shape;
    panel_.x_first = plan.x_first;
    panel_.x_last = plan.x_last;
    panel_.degree_M = panel_.degree_L = first_degree;
    x_ = y_ = leja_points(static_cast<std::size_t>(request_.most_degree) + 1);
    for (double& x : x_) x = solved_x(x);
  }

  /// Grows until held-out solves agree with it, or cannot grow. False: given up, since its size does not promise to
  /// stay small; without `may_give_up` it then grows on. Throws NotSolved.
  [[nodiscard]] bool grow(bool may_give_up) {
    const auto given_up = [&] { return may_give_up && !promising(); };
    if (solved_.empty()) fit();
    while (!given_up() && step_by_tails()) fit();
    if (given_up()) return false;
    for (add_held_out(); !agrees(); add_held_out()) {
      bool grown = false;
      do {
        grown = worth_growing() && step_larger_tail();
        if (grown) fit();
        if (given_up()) return false;
      } while (grown && !agrees());
      if (grown) continue;
      table_.status = StopReason::tolerance_not_met;
      break;
    }
    add();
    return true;
  }

  /// The last coefficients of M are larger than those of L.
  [[nodiscard]] bool longer_in_M() const { return largest(tail_M_) >= largest(tail_L_); }

 private:
  /// Adds it to the table.
  void add() {
    for (std::size_t k = 0; k < table_film_count; ++k) {
      FilmTableErrors& errors = table_.errors[k];
      errors.found = std::max(errors.found, found_[k]);
      errors.solves = std::max(errors.solves, solves_[k]);
    }
    table_.panels.push_back(panel_);
    if (plan_.extrapolates()) judge_gap();
  }

  /// Held-out solves between the bend and the nearest solved contacts.
  void judge_gap() {
    std::vector<MoesGroups> contacts;
    const double begin = plan_.x_last < 1 ? plan_.x_last : plan_.x_first, end = plan_.x_last < 1 ? 1 : -1;
    for (const double y : y_in_gap)
      for (const double share : x_in_gap) {
        const MoesGroups at = contact_at(panel_.shape, begin + share * (end - begin), y);
        if (table_.range.contains(at)) contacts.push_back(at);
      }
    if (contacts.empty()) return;
    if (!table_.at_bend) table_.at_bend = BendErrors{.gap = bend_gap, .stated = ByFilm<double>{}};
    std::optional<ByFilm<double>>& stated = table_.at_bend->stated;
    const std::vector<SolvedFilms> solved = source_(contacts);
    table_.held_out += static_cast<long>(contacts.size());
    for (std::size_t i = 0; i < contacts.size() && stated; ++i) {
      if (!solved[i].why.empty()) {
        stated.reset();
        return;
      }
      const auto films = films_in(panel_, contacts[i]);
      for (std::size_t k = 0; k < table_film_count; ++k) {
        const Quantity film = table_films[k];
        const double value = solved[i].value[k];
        const double found = std::abs(films[k].value - value) / table_error_unit(film, value);
        const double of_solve = solved[i].error[k] / table_unit_of_stated(film, value);
        (*stated)[k] = std::max((*stated)[k], found_factor * found + of_solve);
      }
    }
  }

  /// From -1 … 1 to the part of the panel that is solved.
  [[nodiscard]] double solved_x(double x) const { return plan_.x_first + (plan_.x_last - plan_.x_first) * (x + 1) / 2; }

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
        solves_[k] =
            std::max(solves_[k], solved[i].error[k] / table_unit_of_stated(table_films[k], solved[i].value[k]));
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
        contacts.push_back(contact_at(panel_.shape, x_[static_cast<std::size_t>(i)], y_[static_cast<std::size_t>(j)]));
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

  [[nodiscard]] bool promising() const {
    const long coefficients = (panel_.degree_M + 1L) * (panel_.degree_L + 1L);
    if (coefficients > most_promising) return false;
    if (!is_straight(panel_.shape)) return true;
    const double aim = tail_share * request_.tolerance;
    const auto hopeless = [&](const ByFilm<double>& tail, int degree) {
      return degree >= telling_degree && largest(tail) > hopeless_tail(degree) * aim;
    };
    return !hopeless(tail_M_, panel_.degree_M) && !hopeless(tail_L_, panel_.degree_L);
  }

  /// Raises a degree whose tail is too large. False: none is, or the bounds do not allow it.
  bool step_by_tails() {
    const double aim = tail_share * request_.tolerance;
    return step(largest(tail_M_) > aim, largest(tail_L_) > aim);
  }
  bool step_larger_tail() { return step(longer_in_M(), !longer_in_M()); }
  bool step(bool in_M, bool in_L) {
    const int M = std::min(panel_.degree_M + in_M, request_.most_degree);
    const int L = std::min(panel_.degree_L + in_L, request_.most_degree);
    const long now = (panel_.degree_M + 1L) * (panel_.degree_L + 1L), then = (M + 1L) * (L + 1L);
    const long spent = table_.solves + table_.held_out + reserved_ + (plan_.extrapolates() ? solves_in_gap : 0);
    if (then == now || spent + then - now + held_out_of(then) > request_.most_solves) return false;
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
      auto at = spread_point(spread_points_used_++);
      at.first = solved_x(at.first);
      const double term = last_terms(at.first, at.second);
      if (!(term > largest_term)) continue;
      largest_term = term;
      chosen = at;
    }
    return contact_at(panel_.shape, chosen.first, chosen.second);
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
    found_ = {};
    for (const HeldOut& point : held_out_) {
      const auto films = films_in(panel_, point.at);
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
  const PanelPlan& plan_;
  long reserved_;
  FilmPanel panel_;
  std::vector<double> x_, y_;
  std::map<std::pair<int, int>, ByFilm<double>> solved_;
  ByFilm<double> tail_M_ = {}, tail_L_ = {}, found_ = {}, solves_ = {};
  std::vector<HeldOut> held_out_;
  int spread_points_used_ = 0;
};

/// Adds a panel, or the smaller ones in its place. `reserved`: solves that later panels need.
void add_panel(FilmTable& table, const FilmTableRequest& request, const FilmSource& source, const PanelPlan& plan,
               long reserved) {
  GrowingPanel panel(table, request, source, plan, reserved);
  if (panel.grow(true)) return;
  const long left = request.most_solves - table.solves - table.held_out - reserved;
  std::vector<PanelPlan> smaller;
  if (left > fewest_smaller * solves_a_panel) {
    if (plan.may_bend) {
      BendPlans beside = panels_beside_bend(plan.shape, source, left / solves_a_panel);
      table.solves += beside.solves;
      smaller = std::move(beside.panels);
    }
    if (smaller.empty()) smaller = halves(plan, panel.longer_in_M());
  }
  if (smaller.empty()) (void)panel.grow(false);
  for (std::size_t p = 0; p < smaller.size(); ++p)
    add_panel(table, request, source, smaller[p],
              reserved + static_cast<long>(smaller.size() - p - 1) * (fewest_of_a_panel + solves_in_gap));
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
  if (table.at_bend && table.at_bend->stated)
    for (std::size_t k = 0; k < table_film_count; ++k)
      (*table.at_bend->stated)[k] = std::max((*table.at_bend->stated)[k], table.errors[k].stated);
  // One panel may have the largest error found, another solves that err by more than they were asked for.
  if (worst > table.tolerance) table.status = StopReason::tolerance_not_met;
  if (table.status == StopReason::tolerance_not_met)
    table.reason = fmt::format(
        "the stated error of {} is {} after {} solves and {} held-out ones; the largest found is {}",
        to_string(table_films[of]), plain(worst, 2), table.solves, table.held_out, plain(table.errors[of].found, 2));
}

}  // namespace

long fewest_solves(const FilmRange& range) {
  return static_cast<long>(straight_panels(range).size()) * fewest_of_a_panel;
}

FilmTable build_film_table(const TableOil& oil, const FilmTableRequest& request, const FilmSource& source) {
  FilmTable table{.solver = default_solver().name,
                  .lubricant = oil.lubricant,
                  .inlet = oil.inlet,
                  .range = request.range,
                  .tolerance = request.tolerance,
                  .panels = {}};
  try {
    const std::vector<PanelPlan> plans = straight_panels(request.range);
    for (std::size_t p = 0; p < plans.size(); ++p)
      add_panel(table, request, source, plans[p], static_cast<long>(plans.size() - p - 1) * fewest_of_a_panel);
  } catch (const NotSolved& failure) {
    table.status = StopReason::limit_reached;
    table.reason = failure.why;
    table.panels.clear();
    return table;
  }
  state_errors(table);
  return table;
}

}  // namespace ehd
