// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// Taylor coefficients in time of the motion through a state, c_0 = y and c_k = y⁽ᵏ⁾/k!, y positions then velocities,
/// inputs held constant: c_{k+1} = (coefficient k of dy/dt)/(k + 1), where each operation of the forward dynamics has a
/// recurrence for its coefficients (Moore 1966; Jorba & Zou 2005). Without constraints the accelerations may instead be
/// unknowns of the inverse dynamics, M q̈ + h - E u = 0, solved order by order; see SeriesSolve.
Kernel make_jets(const Equations& equations);
/// Why there are none; empty where there are.
std::string no_jets(const Equations& equations);

}  // namespace torsor
