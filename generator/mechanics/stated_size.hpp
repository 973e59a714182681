// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/expression/expression.hpp"

namespace torsor {

/// A length [m] of which a scene keeps only what was made of it, squares that have no sign: what it must be.
struct StatedSize {
  enum class Least { zero, above_zero, other };

  std::string what;  ///< "radius of a cylinder"
  Expression value;
  Least least = Least::zero;
  std::string other_what{};  ///< of another size, which must not be larger
  Expression other{};
};

}  // namespace torsor
