// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "torsor/generator/printing/written.hpp"

namespace torsor::printing {

/// Makes (b − a)² of a page (a − b)² where the page has a − b as a factor too, and b − a nowhere.
class OrientedSquares {
 public:
  /// Looks at what the page has.
  void see(const Written& written);
  Written oriented(Written written) const;
  /// An entry of a matrix: b − a in a product is −(a − b) there.
  Written oriented_entry(Written entry) const;

 private:
  std::set<std::string> factors_;  // texts of sums in parentheses to the first power
};

}  // namespace torsor::printing
