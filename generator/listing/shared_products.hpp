// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// The same values by other definitions: a product that stands in several sums has one of its own, and so have the
/// squares in higher powers and products of parameters, which are then computed once for a set of them.
///
/// The most frequent pair of factors goes first (after Breuer, Generation of optimal code for expressions via
/// factorization, 1969). It is taken out of those sums that cost less without it, in operations and not more in
/// instructions, are known no later if their operands are when they were, and have the same factors taken out as
/// before; and only where that saves operations in all, and no processor that fuses products with sums has an
/// instruction more: a product that two sums fuse costs nothing in the second. Sums of several terms are not taken out:
/// terms that do not belong together would be rounded together. Exact. The program must have the pass `sharing`, which
/// finds a product again.
std::vector<Value> with_shared_products(Program& program, const std::vector<Value>& values);

}  // namespace torsor
