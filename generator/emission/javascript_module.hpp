// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// A mechanism as an ES module without imports: the kernels of `emit_header` as functions of typed arrays, with names
/// and units of all that they read and write. Without fused operations, results have the bits of the C++ header in
/// double.
std::string emit_javascript(const MechanismListing& mechanism);

}  // namespace torsor
