// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

namespace torsor {

/// How much of a long test runs: `scripts/test --long` sets TORSOR_LONG_TESTS.
template <class T>
T wanted(T usual, T in_long_runs) {
  return std::getenv("TORSOR_LONG_TESTS") == nullptr ? usual : in_long_runs;
}

}  // namespace torsor
