// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/size_bounds.hpp"

namespace torsor {

/// A sentence as a literal of C and C++. Names in it may have any letters; the place of a number is \001, and no sign is one
/// that a format gives a meaning to.
std::string sentence_literal(const std::string& text);

/// How many numbers `make_sizes` gives for the bounds.
std::size_t count_of_numbers(const std::vector<SizeBound>& bounds);

/// The bounds as entries of a table of C or C++: `{at_least, 0, 0, "body 'arm' has the mass m = \001 kg: ..."}`. The relation;
/// where among the numbers of `make_sizes` the two are that it compares, and where those of the text begin; what is said where
/// it is broken. `scope` stands before the names of relations.
std::string size_table(const std::vector<SizeBound>& bounds, const std::string& scope);

}  // namespace torsor
