// SPDX-License-Identifier: GPL-3.0-or-later
// toml++ compiled here, not taken from Debian's library: that one reads each number through a stream of its own. The
// stream takes an eighth of what a call of libehd costs above its solve, and turns 1e-400 into 0.
#define TOML_IMPLEMENTATION
#define TOML_FLOAT_CHARCONV 1

#include <toml++/toml.h>
