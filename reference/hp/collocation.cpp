// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hp/collocation.ipp"

namespace ehd::reference::hp {

template class Collocation<double>;

}  // namespace ehd::reference::hp
