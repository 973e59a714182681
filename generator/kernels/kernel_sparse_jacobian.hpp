// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// The entries of the constraint Jacobian A(q, t) that do not vanish identically, row by row, with tables that say where
/// they stand.
Kernel make_sparse_constraint_jacobian(const Equations& equations);
/// Why there is none; empty where there is one.
std::string no_sparse_constraint_jacobian(const Equations& equations);

}  // namespace torsor
