// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Columns of the regressor Y(q, v, a) that are independent, with tables that say which inertial parameters they belong
/// to and how the others are added to those (base_parameters). Dependent columns are left out: a least-squares problem
/// with them is singular, and Y_b K gives them where somebody wants them.
Kernel make_regressor(const Equations& equations);
/// Why there is none; empty where there is one.
std::string no_regressor(const Equations& equations);

}  // namespace torsor
