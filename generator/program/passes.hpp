// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// What makes programs cheap. Each pass is exact, and can be left out to see what it saves; see passes().
struct Passes {
  bool sharing = true;
  bool identities = true;
  bool zero_test = true;
  bool products = true;
  bool factoring = true;
  bool hoisting = true;
  bool regrouping = true;
  bool off_axis = true;
  bool reframing = true;
  bool length_unit = true;
  bool scheduling = true;
};

/// What a pass works on: docs/architecture.md says why.
enum class PassLevel {
  program,  ///< a rule by which definitions are made
  results,  ///< what a kernel gives: other definitions of the same values
  listing,  ///< how and when definitions are computed
  bodies    ///< links and inertia, before anything is derived
};

struct Pass {
  const char* name;
  PassLevel level;
  const char* effect;  ///< half a sentence
  bool Passes::*on;
};

/// All passes, in the order of their declaration.
const std::vector<Pass>& all_passes();

/// All passes but those of a comma-separated list. Throws UsageError naming an unknown one and listing the known ones.
Passes passes_without(const std::string& list);

}  // namespace torsor
