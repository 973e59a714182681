// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/emission/mechanism_listing.hpp"

namespace torsor {

/// The whole function of a kernel with its documentation, in C++.
std::string cpp_function(const MechanismListing& mechanism, const KernelListing& kernel);

}  // namespace torsor
