// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "torsor/generator/base/number.hpp"

namespace torsor {

/// A constant rotation with exact entries: column j holds the components, in the outer frame, of axis j of the inner
/// frame, so that v_outer = R v_inner. Any rotation by multiples of 15 degrees about an axis is exact; for another
/// constant angle use a revolute joint with that number as its angle.
class Rotation {
 public:
  Rotation();  ///< identity

  /// Row-major entries. Throws SceneError unless RᵀR = 1 and det R = 1 hold exactly.
  static Rotation matrix(const std::array<Number, 9>& row_major);
  /// Rotation about axis 0, 1 or 2 (x, y, z) by k·π/12, i.e. k times 15 degrees.
  static Rotation about(int axis, int twelfths_of_pi);

  const Number& operator()(int row, int column) const { return entries_[static_cast<std::size_t>(3 * row + column)]; }
  bool is_identity() const;
  Rotation transpose() const;
  friend Rotation operator*(const Rotation& a, const Rotation& b);

 private:
  std::array<Number, 9> entries_;
};

}  // namespace torsor
