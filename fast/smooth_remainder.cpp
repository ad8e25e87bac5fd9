// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/smooth_remainder.hpp"

#include <algorithm>
#include <utility>

namespace ehd::fast {

RemainderTable RemainderTable::of(const Array& place, const Array& slope) {
  const Eigen::Index cells = place.size() - 1;
  // The lower triangle, column after column without a gap, so that all its logarithms are taken in one pass.
  Array packed((cells + 1) * (cells + 2) / 2);
  const Array per_step = static_cast<double>(cells) / Array::LinSpaced(cells, 1, static_cast<double>(cells));
  Eigen::Index first = 0;
  for (Eigen::Index j = 0; j <= cells; ++j) {
    const Eigen::Index below = cells - j;
    packed[first] = slope[j];
    packed.segment(first + 1, below) = (place.tail(below) - place[j]) * per_step.head(below);
    first += below + 1;
  }
  packed = packed.log();
  RemainderTable table{.cells = static_cast<int>(cells), .values = Eigen::MatrixXd(cells + 1, cells + 1)};
  first = 0;
  for (Eigen::Index j = 0; j <= cells; ++j) {
    const Eigen::Index below = cells - j;
    const auto column = packed.segment(first, below + 1).matrix();
    table.values.col(j).tail(below + 1) = column;
    table.values.row(j).tail(below + 1) = column.transpose();
    first += below + 1;
  }
  return table;
}

RemainderRule RemainderRule::of(int n, int cells) {
  RemainderRule rule{.n = n, .cells = cells, .base = {}, .pattern = {}, .weights = {}};
  const int order = std::min(points, cells + 1);
  rule.base.resize(static_cast<std::size_t>(n) + 1);
  rule.pattern.resize(static_cast<std::size_t>(n) + 1);
  const bool periodic = n % cells == 0;
  const int parts = periodic ? n / cells : 1;
  std::vector<int> known(static_cast<std::size_t>(points * parts), -1);
  for (int i = 0; i <= n; ++i) {
    const auto node = static_cast<std::size_t>(i);
    const int cell = std::min(static_cast<int>(static_cast<long>(i) * cells / n), cells - 1);
    const int base = std::clamp(cell - (order / 2 - 1), 0, cells + 1 - order);
    rule.base[node] = base;
    const auto kind =
        static_cast<std::size_t>(cell - base) * static_cast<std::size_t>(parts) + static_cast<std::size_t>(i % parts);
    int* const same = periodic && i < n ? &known[kind] : nullptr;
    if (same && *same >= 0) {
      rule.pattern[node] = *same;
      continue;
    }
    const double at = static_cast<double>(i) * cells / n;
    Weights w = Weights::Zero();
    for (int a = 0; a < order; ++a) {
      double product = 1;
      for (int b = 0; b < order; ++b) {
        if (b != a) product *= (at - base - b) / (a - b);
      }
      w[a] = product;
    }
    rule.pattern[node] = static_cast<int>(rule.weights.size());
    if (same) *same = rule.pattern[node];
    rule.weights.push_back(w);
  }
  return rule;
}

SmoothRemainder::SmoothRemainder(std::shared_ptr<const RemainderTable> table)
    : n_(table->cells), table_(std::move(table)) {}

SmoothRemainder::SmoothRemainder(std::shared_ptr<const RemainderTable> table, std::shared_ptr<const RemainderRule> rule)
    : n_(rule->n), table_(std::move(table)), rule_(std::move(rule)) {}

void SmoothRemainder::add(const Array& x, Array& y) const {
  if (!rule_) {
    y.matrix().noalias() += table_->values * x.matrix();
    return;
  }
  const int cells = table_->cells;
  const RemainderRule& rule = *rule_;
  in_.setZero(cells + 1 + points);  // the last few take what short tables' padding weights (zeros) add
  for (int i = 0; i <= n_;) {
    const int base = rule.first(i);
    RemainderRule::Weights sum = RemainderRule::Weights::Zero();
    for (; i <= n_ && rule.first(i) == base; ++i) sum += rule.at(i) * x[i];
    in_.segment<points>(base) += sum.matrix();
  }
  out_.setZero(cells + 1 + points);
  out_.head(cells + 1).noalias() = table_->values * in_.head(cells + 1);
  for (int i = 0; i <= n_; ++i) y[i] += (rule.at(i) * out_.segment<points>(rule.first(i)).array()).sum();
}

double SmoothRemainder::entry(int i, int j) const {
  if (!rule_) return table_->values(i, j);
  const int a = rule_->first(i), b = rule_->first(j);
  double sum = 0;
  for (int k = 0; k < points && a + k <= table_->cells; ++k) {
    for (int m = 0; m < points && b + m <= table_->cells; ++m)
      sum += rule_->at(i)[k] * rule_->at(j)[m] * table_->values(a + k, b + m);
  }
  return sum;
}

void SmoothRemainder::add_row(int i, double* row) const {
  if (!rule_) {
    Eigen::Map<Eigen::VectorXd>(row, n_ + 1) += table_->values.col(i);  // symmetric
  } else {
    for (int j = 0; j <= n_; ++j) row[j] += entry(i, j);
  }
}

}  // namespace ehd::fast
