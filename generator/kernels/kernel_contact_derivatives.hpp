// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/kernels/kernel.hpp"

// What the derivatives of accelerations follow from while the regimes of contacts last: M a + h = E u + A' λ + J' r,
// A a + γ = 0, and of each row of a contact either its reaction or J a + drift = 0.

namespace torsor {

/// At given accelerations, multipliers and inputs the partial derivatives of M a + h − A' λ − E u, of A a + γ and, of the rows
/// of contacts, of J a + drift and of w; those of f and b, and of the reactions R of joints that rub in proportion to them.
/// Only of scenes that have contacts.
Kernel make_contact_motion_derivatives(const Equations& equations);

/// The partial derivatives of J a at given accelerations. With those of all unit vectors come the ones of J' r: of column i of J
/// the derivatives are those of J e_i.
Kernel make_contact_row_derivatives(const Equations& equations);

}  // namespace torsor
