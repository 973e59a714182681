// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "torsor/generator/expression/expression.hpp"

namespace torsor {

/// An inequality between two quantities of one unit: where `difference` is positive, or, if not strict, zero too.
struct Condition {
  Expression difference;
  bool strict = false;
};

Condition operator<(const Expression& a, const Expression& b);
Condition operator<=(const Expression& a, const Expression& b);
Condition operator>(const Expression& a, const Expression& b);
Condition operator>=(const Expression& a, const Expression& b);

/// The value of the first row whose condition holds, else `otherwise`; all have one unit. Kernels compute every form and
/// take one without a branch: what the others are does not matter, not even that they are no numbers. A derivative is
/// that of the form taken; jumps between forms have none.
Expression piecewise(const std::vector<std::pair<Condition, Expression>>& rows, const Expression& otherwise);

/// The cubic spline through points (x, y): twice continuously differentiable, y'' = 0 at both ends, and continued by
/// straight lines (a natural spline: de Boor, A Practical Guide to Splines, ch. IV). With `end_slopes`, y' at both ends,
/// it has these instead (a complete spline). Abscissae are in the unit of x and grow, ordinates have the unit `unit`,
/// slopes that over the unit of x. Every double is its shortest decimal; slopes at the points are those of the spline,
/// rounded to 30 digits, so that value and slope are exactly continuous. Throws Error naming what is wrong with the points.
Expression spline(const Expression& x, const std::vector<std::array<double, 2>>& points, std::string_view unit = "1",
                  const std::optional<std::array<double, 2>>& end_slopes = std::nullopt);

}  // namespace torsor
