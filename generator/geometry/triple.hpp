// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "torsor/generator/expression/expression.hpp"

namespace torsor {

/// Three components along the axes of some frame, as a user writes them.
using Triple = std::array<Expression, 3>;

/// Unit vectors along the axes of a frame.
namespace axis {
inline const Triple x{Expression(1), Expression(0), Expression(0)};
inline const Triple y{Expression(0), Expression(1), Expression(0)};
inline const Triple z{Expression(0), Expression(0), Expression(1)};
}  // namespace axis

Triple operator-(const Triple& v);

}  // namespace torsor
