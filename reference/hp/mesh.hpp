// SPDX-License-Identifier: GPL-3.0-or-later
// Elements between inlet and exit. Their breakpoints are fixed in xi = T (X - X*)/(X* - X_a), -T <= xi <= 0, and move
// with the exit X*; T is the length that the domain had when the mesh was made, so that the stretching
// s = (X* - X_a)/T is near 1.
#pragma once

#include <functional>
#include <vector>

namespace ehd::reference::hp {

struct Mesh {
  double inlet = 0;                 ///< X_a
  std::vector<double> breakpoints;  ///< xi, increasing; the last is 0
  std::vector<int> degrees;         ///< one an element
  [[nodiscard]] int elements() const { return static_cast<int>(degrees.size()); }
  [[nodiscard]] double extent() const { return -breakpoints.front(); }  ///< T
  /// Intervals between nodes, and collocation points: the sum of the degrees.
  [[nodiscard]] int intervals() const;
};

/// Elements graded about -l and about l, where the exit is near. There they begin with `inlet_zone` / 2.
/// Neighbours differ by the ratio `growth` at most. The first element takes what is left, and may differ by 3.
struct Seed {
  double inlet = 0;
  double exit = 1;
  double length = 1;      ///< l, where the inlet zone stands
  double inlet_zone = 0;  ///< its width
  int degree = 8;
  double growth = 2;
};
[[nodiscard]] Mesh seeded_mesh(const Seed& seed);

/// Elements with excess > 1 are cut at `cut` of their length. Neighbours e and e + 1 become one where mergeable(e)
/// holds; each element is merged once at most. Elements shorter than twice `shortest` are not cut.
[[nodiscard]] Mesh adapted(const Mesh& mesh, const std::vector<double>& excess,
                           const std::function<bool(int)>& mergeable, double shortest, double cut = 0.5);

/// The mesh with exactly `elements` elements: cuts the elements of largest excess in two, or joins the neighbours of
/// smallest excess. A cut is assumed to divide the excess by 2^degree.
[[nodiscard]] Mesh with_elements(const Mesh& mesh, std::vector<double> excess, int elements, double shortest);
/// The mesh with new degrees, nearly equal and larger towards the inlet, whose sum is `intervals`.
[[nodiscard]] Mesh with_intervals(Mesh mesh, int intervals);
/// All degrees set to `degree`.
[[nodiscard]] Mesh with_degree(Mesh mesh, int degree);
/// Every inner breakpoint moved by `part` of the element on its right: nearly the same sizes, no common breakpoint.
[[nodiscard]] Mesh shifted(Mesh mesh, double part);
/// The mesh without the part before X = `inlet`. `exit` is X*; with it the stretching stays as it is.
[[nodiscard]] Mesh cut_at(Mesh mesh, double inlet, double exit);

}  // namespace ehd::reference::hp
