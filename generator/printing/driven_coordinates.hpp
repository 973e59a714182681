// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// law = rest + slope · base^(halves/2): the base is time or a function of it, in the rest at most with a lower power.
struct LawByBase {
  BasePointer base;
  int halves = 2;
  Number coefficient;  ///< of the slope
  Product slope;
  Sum rest;
};

/// Laws of time that a page lists once, "L = L_0 − v t", so that formulas hold the name of the coordinate instead: L² for
/// L_0² − 2 L_0 v t + v² t². Rates and accelerations are laws too: ψ'² for A² Ω² cos² Ω t.
class DrivenCoordinates {
 public:
  /// One that a page lists; `stands`: in formulas as well. Of laws that are as short in a sum the earlier one is taken.
  void add(SymbolPointer name, Sum law, bool stands);
  /// What a page lists of a coordinate or a rate.
  std::optional<Sum> law(const SymbolPointer& name) const;

  /// The angle of a sine or a cosine: a law that is in it as a whole becomes its name.
  Sum named_in_angle(Sum angle) const;
  /// Any sum: a law becomes its name where that makes the sum shorter and nothing is divided by what it was not before.
  Sum named(Sum sum) const;

 private:
  struct Law {
    SymbolPointer name;
    Sum written;
    bool stands;
    std::optional<LawByBase> by_base;  ///< of one that stands, where it is a law of time
  };
  std::vector<Law> laws_;
};

bool depends_on_time(const Sum& sum);

}  // namespace torsor::printing
