// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/printing/written.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor::printing {

/// The program view of results that are too long to be written out: named definitions z1, z2, ... in the order in which
/// they are computed, live ones only.
class DefinitionsView {
 public:
  DefinitionsView(const Program& program, const std::vector<Value>& results);

  struct Line {
    int number = 0;
    Written right;
    std::string name;  ///< e.g. "velocity of forearm, x"; may be empty
  };
  const std::vector<Line>& lines() const { return lines_; }

  /// A result in terms of the definitions.
  Sum sum(const Value& result) const { return of_polynomial(result.polynomial()); }

 private:
  Sum of_polynomial(const Polynomial& polynomial) const;

  std::unordered_map<ValueNumber, Sum> value_numbers_;  ///< looked up, never iterated
  std::vector<Line> lines_;
};

/// What a definition is, for a reader; empty where it has no name.
std::string meaning_of(const DefinitionsView::Line& line, const NaturalLanguage& say);

}  // namespace torsor::printing
