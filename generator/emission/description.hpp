// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/emission/mechanism_listing.hpp"

namespace torsor {

// What a generated text says of itself, as JSON, which JavaScript reads as it stands.

/// [{"name": "theta", "unit": "rad"}, ...] of the symbols in one table of the layout.
std::string symbols_json(const MechanismListing& mechanism, Table table);

/// Of each kernel its name, its arguments behind the state, whether it returns a status, and its results: of an array
/// its size, of a structure its members with where each begins and its shape.
std::string kernels_json(const MechanismListing& mechanism);

/// Places in q of the first components (w) of the unit quaternions.
std::vector<std::size_t> quaternion_places(const MechanismListing& mechanism);
std::string quaternions_json(const MechanismListing& mechanism);

/// What an argument is called.
const char* name_of(Argument argument);

/// Unit of a symbol as a reader expects it: an angle's is rad.
std::string unit_of(const Symbol& symbol);

/// Text of several lines behind `///`.
std::string documentation_comment(const std::string& documentation);

}  // namespace torsor
