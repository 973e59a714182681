// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_set>

#include "torsor/generator/mechanics/scene_content.hpp"
#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// Parameters that are known to be positive: those to which the scene gives a positive value that no run changes, nor any
/// parameter in its formula. Looked up, never iterated.
using PositiveSymbols = std::unordered_set<const Symbol*>;
PositiveSymbols positive_parameters(const SceneContent& scene);

/// sum^(halves/2) for odd halves. Squares of numbers, of what is known to be positive and of exponentials leave the root:
/// √(c² x² + c² y²) = c √(x² + y²), √(c²) = c. The root of any other square stays one, and is written |…|.
Sum root(const Sum& sum, int halves, const PositiveSymbols& positive);

/// x²/√(x²) = √(x²), in a product: to the right for sums that are to be read, to the left for those in which squares are
/// yet to meet, sin² x/|cos x| + cos² x/|cos x|.
Sum with_squares_in_roots(const Sum& sum);
Sum with_squares_beside_roots(const Sum& sum);

}  // namespace torsor::printing
