// SPDX-License-Identifier: GPL-3.0-or-later
// Ertel-Grubin inlet: the film of a Hertzian contact whose inlet pumps the reduced pressure up to 1/alpha at X = -1.
//   Int_-infinity^-1 lambda gap/(H_c + gap)^3 dX = 1/(alpha p_H),  gap the Hertz gap outside the contact.
// The film is exact for that model. Full solutions approach it from above at high M and L.
#pragma once

namespace ehd::verification::exact {

/// H_c in Moes units; M, L > 0. The root of the equation above to 1e-12 relative.
[[nodiscard]] double ertel_grubin_film(double M, double L);

/// Left side over right side of that equation, minus 1, at a film H_c in Moes units. The root is where this is 0.
[[nodiscard]] double ertel_grubin_defect(double M, double L, double moes_film);

}  // namespace ehd::verification::exact
