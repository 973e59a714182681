// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/emission/language.hpp"
#include "torsor/generator/listing/listing.hpp"

namespace torsor {

/// The lines of a function's body without indentation: the numbers it uses, what it reads, its statements, its results;
/// then its status: singular when a pivot is not regular, not_finite when a result is not, else ok. That takes one
/// multiplication for each of them, which operations leave out: they are those of the equations. Nothing is optimised
/// here: each operator of a formula is one operator of the text.
std::string print(const Listing& listing, const Language& language);

}  // namespace torsor
