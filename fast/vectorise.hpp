// SPDX-License-Identifier: GPL-3.0-or-later
// EHD_VECTORISE before a loop says that no array written in it overlaps another one. gcc needs that where a loop writes
// many arrays: it compares at most ten pairs of addresses at run time, else it does not vectorise.
#pragma once

#ifdef __clang__
#define EHD_VECTORISE
#else
#define EHD_VECTORISE _Pragma("GCC ivdep")
#endif
