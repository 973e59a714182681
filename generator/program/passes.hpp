// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// What makes programs cheap. Each pass is exact, and can be left out to see what it saves.
struct Passes {
  bool sharing = true;      ///< a sum or product that is there already, up to sign, is not computed again
  bool identities = true;   ///< sin² + cos² = 1
  bool zero_test = true;    ///< what vanishes identically, although its terms do not show it, is zero
  bool products = true;     ///< a product that stands in several sums of a kernel is computed once
  bool factoring = true;    ///< what terms of a sum share is multiplied once
  bool hoisting = true;     ///< what depends on parameters alone is computed once for a set of them
  bool regrouping = true;   ///< inertia moves across joints to where it has the same effect and costs less
  bool off_axis = true;     ///< inverse dynamics: so does the whole spread of mass along a joint's axis
  bool reframing = true;    ///< links get frames in which turns and lengths cost least
  bool length_unit = true;  ///< lengths in units of the most frequent one, whose products vanish
  bool scheduling = true;   ///< terms and definitions in an order in which a processor waits little
};

struct PassName {
  const char* name;
  bool Passes::*on;
};

/// All passes, in the order of their declaration.
const std::vector<PassName>& pass_names();

/// All passes but those of a comma-separated list. Throws UsageError naming an unknown one and listing the known ones.
Passes passes_without(const std::string& list);

}  // namespace torsor
