// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// Shortens a sum by sin² + cos² = 1 and by the addition theorems, e.g. cos a cos b + sin a sin b = cos(a − b). Every
/// step merges two terms into one, so the result never has more terms than what came in.
Sum simplified(const Sum& sum);

}  // namespace torsor::printing
