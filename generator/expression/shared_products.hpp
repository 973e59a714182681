// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/expression/program.hpp"

namespace torsor {

/// The same values by other definitions: a product that stands in several sums has one of its own, and so have the
/// squares in higher powers and products of parameters, which are then computed once for a set of them.
///
/// The most frequent pair of factors goes first (after Breuer, Generation of optimal code for expressions via
/// factorization, 1969). It is taken out of those sums that have fewer operations without it and are not known later,
/// and only where, all of them together, no instruction more is left of a processor that fuses products with sums: a
/// product that is fused in each of two sums costs nothing in the second. Sums of several terms are not taken out: terms
/// that do not belong together would be rounded together. Exact; nothing changes without the passes
/// `sharing` and `products`.
std::vector<Value> with_shared_products(Program& program, const std::vector<Value>& values);

}  // namespace torsor
