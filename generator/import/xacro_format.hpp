// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/xacro_value.hpp"

namespace torsor::xacro {

/// Python's `format % values`: a tuple has a value for each conversion, a dictionary those of %(name)s, anything else is the
/// only value. Conversions are d, i, u, e, f, g, s, r and %, with flags, width and precision. Throws ExpressionError where
/// Python would, and for what is not read here.
std::string percent_format(const std::string& format, const Value& values);

}  // namespace torsor::xacro
