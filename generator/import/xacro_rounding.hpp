// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// An integer of a double that holds one. Throws ExpressionError naming the function beyond 64 bits.
Value whole(const std::string& name, double value);

/// Python's round(x) and round(x, n): to the nearest, halves to even; of the exact value of the double where digits are
/// asked, to tens where n is negative.
Value rounded(const std::vector<Value>& given);

}  // namespace torsor::xacro
