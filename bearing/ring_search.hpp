// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ring stands under a load. The energy of increasing laws is convex in the ring's displacement, so the force
// along any line increases.
#pragma once

#include <limits>

#include "bearing/ring.hpp"

namespace ehd::bearing {

/// A displacement of the ring, and how far its forces there are from the load.
struct Place {
  Vector2 v;
  RingState state;
  double miss_N = std::numeric_limits<double>::infinity();
};

/// The radial form: one search along the load, to rounding. Rollers on the jump of a law that is cut at delta = 0 share
/// the load that the others do not carry. `miss_N`: the unbalanced force along the load.
[[nodiscard]] Place balance_along_the_load(Ring& ring, const LawPair& laws, const Loading& loading);

/// The plane form: Newton's steps, each searched for a place where the force along it has at least halved. Returns the
/// best place that was met; `miss_N` is the larger component.
[[nodiscard]] Place balance_in_the_plane(Ring& ring, const Loading& loading);

}  // namespace ehd::bearing
