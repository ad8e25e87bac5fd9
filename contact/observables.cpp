// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/observables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/legendre.hpp"
#include "contact/quantities.hpp"

namespace ehd {

namespace {

using Index = Eigen::Index;

/// Neighbouring nodes: the index of the first one, and how many.
struct Window {
  Index first, count;
};

/// `count` nodes from `centre_left` on, shifted inwards at the ends of the grid.
Window window(Index centre_left, Index count, Index size) {
  count = std::min(count, size);
  return {std::clamp<Index>(centre_left, 0, size - count), count};
}

struct Point {
  double x, y;
};

/// Vertex of the parabola through nodes i-1, i, i+1, where i is an interior local extremum.
Point vertex(const Array& x, const Array& y, Index i) {
  const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
  const double slope_left = (y[i] - y[i - 1]) / left, slope_right = (y[i + 1] - y[i]) / right;
  const double curvature = (slope_right - slope_left) / (left + right);  // half of y''
  if (curvature == 0) return {x[i], y[i]};
  const double slope = (slope_left * right + slope_right * left) / (left + right);
  const double step = std::clamp(-slope / (2 * curvature), -left, right);
  return {x[i] + step, y[i] + step * (slope + step * curvature)};
}

/// Golden-section search: its ratio, and the steps after which only rounding is left.
constexpr double golden = 0.61803398874989484820;
constexpr int golden_steps = 60;
/// A quartic through an unresolved kink overshoots. One that goes below the node by more than this many times the
/// parabola's depth is not used.
constexpr double deepest_quartic = 3;

/// Minimum of the quartic through five nodes about i within [x_(i-1), x_(i+1)], by golden section; the parabola's
/// vertex where the quartic has no lower point there than the node itself.
Point minimum_between_nodes(const Array& x, const Array& y, Index i) {
  const Index size = x.size();
  if (i == 0 || i + 1 == size) return {x[i], y[i]};
  const Point parabola = vertex(x, y, i);
  if (size < 5) return parabola;
  const Window w = window(i - 2, 5, size);
  const Array nodes = x.segment(w.first, w.count), values = y.segment(w.first, w.count);
  double a = x[i - 1], b = x[i + 1];
  double c = b - golden * (b - a), d = a + golden * (b - a);
  double fc = interpolate(nodes, values, c), fd = interpolate(nodes, values, d);
  for (int step = 0; step < golden_steps; ++step) {
    if (fc < fd) {
      b = d, d = c, fd = fc;
      c = b - golden * (b - a), fc = interpolate(nodes, values, c);
    } else {
      a = c, c = d, fc = fd;
      d = a + golden * (b - a), fd = interpolate(nodes, values, d);
    }
  }
  const Point quartic{(a + b) / 2, interpolate(nodes, values, (a + b) / 2)};
  const double depth = y[i] - parabola.y;
  if (quartic.y > y[i] || y[i] - quartic.y > deepest_quartic * depth) return parabola;
  return quartic;
}

/// One polynomial of a field.
class Element {
 public:
  Element(const Fields& fields, std::size_t k)
      : first_(fields.elements[k]),
        degree_(static_cast<int>(fields.elements[k + 1] - first_)),
        left_(fields.X[first_]),
        half_((fields.X[first_ + degree_] - left_) / 2),
        nodes_(lobatto_nodes<double>(degree_)),
        to_legendre_(lobatto_to_legendre(degree_, nodes_)) {}

  [[nodiscard]] VectorOf<double> coefficients(const Array& y) const {
    return to_legendre_ * y.segment(first_, degree_ + 1).matrix();
  }
  [[nodiscard]] double value(const VectorOf<double>& coefficients, double t) const {
    return coefficients.dot(legendre(degree_, t));
  }
  /// t of a place; no better than X's own digits.
  [[nodiscard]] double local(double X) const { return (X - left_) / half_ - 1; }
  [[nodiscard]] double place(double t) const { return left_ + half_ * (1 + t); }
  /// Int f dy, f and y given at the nodes: the Lobatto rule is exact for a polynomial f of the same degree.
  [[nodiscard]] double integral_over(const Array& f, const Array& y) const {
    const VectorOf<double> a = coefficients(y), weights = lobatto_weights(degree_, nodes_);
    double sum = 0;
    for (int j = 0; j <= degree_; ++j)
      sum += weights[j] * f[first_ + j] * a.dot(legendre_derivatives(degree_, static_cast<double>(nodes_[j])));
    return sum;
  }
  [[nodiscard]] double integral(const Array& y) const {
    return half_ * lobatto_weights(degree_, nodes_).dot(y.segment(first_, degree_ + 1).matrix());
  }
  /// The smallest value next to node i of the field: golden section between its neighbours in the element.
  [[nodiscard]] Point minimum(const Array& y, Eigen::Index i) const {
    const int j = static_cast<int>(i - first_);
    const VectorOf<double> a = coefficients(y);
    double low = nodes_[std::max(j - 1, 0)], high = nodes_[std::min(j + 1, degree_)];
    for (int step = 0; step < golden_steps; ++step) {
      const double c = high - golden * (high - low), d = low + golden * (high - low);
      if (value(a, c) < value(a, d))
        high = d;
      else
        low = c;
    }
    const double t = (low + high) / 2;
    return {place(t), value(a, t)};
  }

 private:
  Eigen::Index first_;
  int degree_;
  double left_, half_;
  VectorOf<double> nodes_;
  MatrixOf<double> to_legendre_;
};

/// The element that holds node i; where two do, the left one.
std::size_t element_of(const Fields& fields, Eigen::Index i) {
  const auto at = std::lower_bound(fields.elements.begin() + 1, fields.elements.end() - 1, i);
  return static_cast<std::size_t>(at - fields.elements.begin()) - 1;
}

/// Minimum of the piecewise polynomial y next to its smallest node i.
Point minimum_of_elements(const Fields& fields, const Array& y, Eigen::Index i) {
  const std::size_t k = element_of(fields, i);
  Point lowest = Element(fields, k).minimum(y, i);
  if (i == fields.elements[k + 1] && k + 2 < fields.elements.size()) {
    const Point right = Element(fields, k + 1).minimum(y, i);
    if (right.y < lowest.y) lowest = right;
  }
  return lowest;
}

Point maximum_of_elements(const Fields& fields, const Array& y, Eigen::Index i) {
  const Point lowest = minimum_of_elements(fields, -y, i);
  return {lowest.x, -lowest.y};
}

/// The spike: the last local maximum of P that has a local minimum and another local maximum before it; the node.
std::optional<Index> spike(const Array& X, const Array& P) {
  std::optional<Index> last, before;
  for (Index i = 1; i + 1 < P.size(); ++i) {
    if (P[i] > P[i - 1] && P[i] >= P[i + 1]) {
      before = last;
      last = i;
    }
  }
  if (!last || !before || X[*last] <= 0) return std::nullopt;
  const double valley = P.segment(*before, *last - *before).minCoeff();
  constexpr double round_off_ripple = 1e-9;  // relative; a spike of this height is rounding on any grid here
  if (P[*last] - valley <= round_off_ripple * P[*last]) return std::nullopt;
  return last;
}

}  // namespace

double interpolate(const Array& nodes, const Array& values, double x) {
  // Neville's scheme, in place; a handful of nodes needs no heap.
  Eigen::Array<double, Eigen::Dynamic, 1, 0, 16, 1> few;
  Array many;
  if (values.size() <= 16)
    few = values;
  else
    many = values;
  double* const p = values.size() <= 16 ? few.data() : many.data();
  for (Index k = 1; k < nodes.size(); ++k) {
    for (Index i = 0; i + k < nodes.size(); ++i)
      p[i] = ((x - nodes[i + k]) * p[i] - (x - nodes[i]) * p[i + 1]) / (nodes[i] - nodes[i + k]);
  }
  return p[0];
}

namespace observed {

namespace {

bool has_elements(const Fields& fields) { return !fields.elements.empty(); }

/// The sum of part(element) over the polynomial elements, added to `start`.
template <class Part>
double summed_over_elements(const Fields& fields, double start, const Part& part) {
  for (std::size_t k = 0; k + 1 < fields.elements.size(); ++k) start += part(Element(fields, k));
  return start;
}

Reading reading_at(const Point& point) { return {.value = point.y, .place = point.x}; }

}  // namespace

std::optional<Reading> film_minimum(const Fields& fields) {
  Index i = 0;
  fields.H.minCoeff(&i);
  return reading_at(has_elements(fields) ? minimum_of_elements(fields, fields.H, i)
                                         : minimum_between_nodes(fields.X, fields.H, i));
}

std::optional<Reading> film_central(const Fields& fields) {
  const Array &X = fields.X, &H = fields.H;
  if (!(X[0] <= 0 && X[X.size() - 1] >= 0)) return std::nullopt;
  const Index right = std::lower_bound(X.begin(), X.end(), 0.0) - X.begin();
  if (has_elements(fields)) {
    const Element element(fields, element_of(fields, right));
    return Reading{.value = element.value(element.coefficients(H), element.local(0)), .place = 0.0};
  }
  const Window w = window(right - 3, 6, X.size());
  return Reading{.value = interpolate(X.segment(w.first, w.count), H.segment(w.first, w.count), 0.0), .place = 0.0};
}

std::optional<Reading> film_couette(const Fields& fields) {
  const Array &H = fields.H, &density = fields.density;
  const Index last = fields.X.size() - 1;
  return Reading{.value = density[last] * H[last]};
}

std::optional<Reading> film_offset(const Fields& fields) { return Reading{.value = fields.offset}; }

std::optional<Reading> approach(const Fields& fields) { return Reading{.value = -fields.offset}; }

std::optional<Reading> pressure_exit(const Fields& fields) {
  const double exit = fields.X[fields.X.size() - 1];
  return Reading{.value = exit, .place = exit};
}

std::optional<Reading> pressure_maximum(const Fields& fields) {
  const Array &X = fields.X, &P = fields.P;
  Index i = 0;
  P.maxCoeff(&i);
  if (has_elements(fields)) return reading_at(maximum_of_elements(fields, P, i));
  const bool interior = i > 0 && i < X.size() - 1;
  return reading_at(interior ? vertex(X, P, i) : Point{X[i], P[i]});
}

std::optional<Reading> pressure_spike(const Fields& fields) {
  const Array &X = fields.X, &P = fields.P;
  const auto i = spike(X, P);
  if (!i) return std::nullopt;
  return reading_at(has_elements(fields) ? maximum_of_elements(fields, P, *i) : vertex(X, P, *i));
}

std::optional<Reading> rolling_force(const Fields& fields) {
  const Array &P = fields.P, &H = fields.H;
  const Index last = fields.X.size() - 1;
  double twice = summed_over_elements(fields, fields.work_beyond_inlet,
                                      [&](const Element& element) { return element.integral_over(H, P); });
  if (!has_elements(fields)) twice += ((H.head(last) + H.tail(last)) * (P.tail(last) - P.head(last))).sum() / 2;
  return Reading{.value = std::abs(twice) / 2};
}

std::optional<Reading> load_error(const Fields& fields) {
  const Array &X = fields.X, &P = fields.P;
  const Index last = X.size() - 1;
  double load = summed_over_elements(fields, fields.load_beyond_inlet,
                                     [&](const Element& element) { return element.integral(P); });
  if (fields.weights.size() > 0)
    load += (fields.weights * P).sum();
  else if (!has_elements(fields))
    load += ((P.head(last) + P.tail(last)) * (X.tail(last) - X.head(last))).sum() / 2;
  return Reading{.value = std::abs(2 * load / std::numbers::pi - 1)};
}

std::optional<Reading> flux_variation(const Fields& fields) {
  const Array& flux = fields.flux;
  const Index last = fields.X.size() - 1;
  const double exit = fields.density[last] * fields.H[last];
  return Reading{.value = ((flux - exit).abs().maxCoeff()) / std::abs(exit)};
}

}  // namespace observed

Observables observe(const Fields& fields, const Wanted& wanted) {
  Observables seen;
  for (const QuantityRow& row : quantity_table()) {
    if (!wanted.contains(row.quantity)) continue;
    if (const auto reading = row.observe(fields)) seen[row.quantity] = *reading;
  }
  return seen;
}

double roughness_at_centre(const Fields& fields) {
  const Array &X = fields.X, &H = fields.H;
  constexpr Index nodes_at_centre = 8, k = 3;  // k neighbours on each side
  constexpr Index nodes_beside_peak = 2;
  constexpr double times_beside_peak = 3.5;
  const Index right = std::lower_bound(X.begin(), X.end(), 0.0) - X.begin();
  const Index first = std::max(right - nodes_at_centre / 2, k);
  const Index last = std::min(right + nodes_at_centre / 2, X.size() - k);
  double largest = 0;
  Array nodes(2 * k), films(2 * k);
  for (Index i = first; i < last; ++i) {
    nodes << X.segment(i - k, k), X.segment(i + 1, k);
    films << H.segment(i - k, k), H.segment(i + 1, k);
    largest = std::max(largest, std::abs(interpolate(nodes, films, X[i]) / H[i] - 1));
  }
  Index peak = 0;
  fields.P.maxCoeff(&peak);
  return std::abs(peak - right) <= nodes_beside_peak ? times_beside_peak * largest : largest;
}

void keep_wanted(Observables& observables, const Wanted& wanted) {
  std::erase_if(observables, [&](const auto& entry) { return !wanted.contains(entry.first); });
}

}  // namespace ehd
