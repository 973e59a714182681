// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/printing/written.hpp"

namespace torsor::printing {

using WrittenMatrix = std::vector<std::vector<Written>>;

/// A matrix that a line can hold: long entries have a name in it, M[1,2] (of a column M[1]), and follow it. Equal entries
/// share the name of the first.
struct FittedMatrix {
  WrittenMatrix rows;
  std::vector<std::pair<std::string, Written>> named;
  /// Empty, or why there are no rows and what `named` has instead: "by components" of a column, else "entries that are
  /// not zero" of what is too wide even with names, in the language that is asked for.
  std::string instead = {};
};

/// `width`: of a line, in characters of plain text. `entry`: the name of the matrix. An empty entry is zero.
FittedMatrix fitted(const std::string& entry, const WrittenMatrix& rows, std::size_t width, const NaturalLanguage& say = {});

}  // namespace torsor::printing
