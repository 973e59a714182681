// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// The members of `Description` of a header: what the vectors hold, and what each kernel reads and writes.
std::string cpp_description(const MechanismListing& mechanism);

/// Declarations of the constants that come along with a structure.
std::string cpp_tables(const Structure& structure);

}  // namespace torsor
