// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/emission/mechanism_listing.hpp"

namespace torsor {

/// A mechanism as one C99 header: the kernels of `emit_header` as inline functions `<scene>_<kernel>`, in double, or in
/// float where TORSOR_SINGLE is defined. Without fused operations, results have the bits of the C++ header.
/// Throws SceneError for a name that cannot stand in a header.
std::string emit_c(const MechanismListing& mechanism);

}  // namespace torsor
