// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// The same sum with denominators divided out where they divide what is above them: a/(a + b) + b/(a + b) is 1,
/// (a² − b²)/(a + b) is a − b. Terms come over one denominator where that leaves fewer terms or fewer denominators. Parts of a
/// denominator are not looked for, and neither is what has roots in it.
Sum cancelled(const Sum& sum);

}  // namespace torsor::printing
