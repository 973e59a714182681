// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/base/number.hpp"

namespace torsor {

/// What touches, and what its surface is made of: the values of run-time parameters.
struct Surfaces {
  std::vector<std::string> named;  ///< links, bodies, or pairs of links
  Number friction = Number::rational(1, 2), restitution;
};

}  // namespace torsor
