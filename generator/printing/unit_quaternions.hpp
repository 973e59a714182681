// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// Shortens a sum by |e|² = e_w² + e_x² + e_y² + e_z² = 1 for every unit quaternion e in it. Terms that differ in their
/// components of e only belong together: of those the square of one component is replaced by what the others leave of 1,
/// which is a normal form, for the component that makes the fewest terms. What vanishes on |e| = 1 vanishes here.
Sum with_unit_quaternions(const Sum& sum);

}  // namespace torsor::printing
