// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/expression/expression.hpp"

namespace torsor {

/// Whether the formula takes one of several forms: max, min, abs, sign and piecewise.
bool takes_forms(const Expression& e);

/// The formula with a sum of all forms in place of the one taken, each with a factor of its own: it depends at every place
/// on what the formula depends on anywhere, as a rope that is slack at one of them does.
Expression generic_form(const Expression& e);

}  // namespace torsor
