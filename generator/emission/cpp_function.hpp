// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// A function of a header.
struct FunctionText {
  std::string body;
  std::string pointer;  ///< to the function with all its arguments
};

/// The whole function of a kernel with its documentation. Where the mechanism has no inputs or no multipliers, a second
/// one without them.
FunctionText cpp_function(const MechanismListing& mechanism, const KernelListing& kernel);

}  // namespace torsor
