// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/emission/mechanism_listing.hpp"

namespace torsor {

/// A function of a header, and the operations it states.
struct FunctionText {
  std::string body;
  OperationCount operations;
};

/// The whole function of a kernel with its documentation.
FunctionText cpp_function(const MechanismListing& mechanism, const KernelListing& kernel);

}  // namespace torsor
