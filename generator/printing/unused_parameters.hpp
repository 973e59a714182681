// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/printing/lagrange_equations.hpp"

namespace torsor::printing {

/// Parameters that stand in no equation, by themselves or by way of others, in the order of the scene: they fell out, or only a
/// picture or the start takes them. Where something is too long to be written out, what it is made of counts.
std::vector<std::string> parameters_without_use(LagrangeEquations& equations);

}  // namespace torsor::printing
