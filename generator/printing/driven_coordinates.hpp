// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "torsor/generator/printing/canonical_sum.hpp"

namespace torsor::printing {

/// Laws of time that a page lists once, "L = L_0 − v t", so that formulas hold the name of the coordinate instead: L² for
/// L_0² − 2 L_0 v t + v² t². Rates and accelerations are laws too: ψ'² for A² Ω² cos² Ω t.
class DrivenCoordinates {
 public:
  /// Of laws that are as short in a sum the earlier one is taken.
  void add(SymbolPointer name, Sum law) { laws_.emplace_back(std::move(name), std::move(law)); }

  /// The angle of a sine or a cosine: a law that is in it as a whole becomes its name.
  Sum named_in_angle(Sum angle) const;
  /// Any sum: a law becomes its name where that makes the sum shorter and nothing is divided by what it was not before.
  Sum named(Sum sum) const;

 private:
  std::vector<std::pair<SymbolPointer, Sum>> laws_;
};

bool depends_on_time(const Sum& sum);

}  // namespace torsor::printing
