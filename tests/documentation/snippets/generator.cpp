// SPDX-License-Identifier: GPL-3.0-or-later
// Snippets of the manual that describe mechanisms or ask about them, in what they take for granted: snippets.mjs puts the n-th
// block of C++ of a page where a line "// snippet: PAGE n" stands.
#include <functional>
#include <string>

// snippet: docs/queries.md 1
#include "torsor/generator/listing/listing.hpp"
#include "torsor/generator/torsor.hpp"

namespace torsor {
// snippet: docs/architecture.md 1
}  // namespace torsor

using namespace torsor;
using namespace torsor::literals;

void contacts(Scene& scene, const FrameHandle& ball, const FrameHandle& rod, const Expression& R, const Expression& r,
              const Expression& theta, const Expression& f, const Expression& e) {
  // snippet: docs/contacts.md 1
}

void measured_vectors(Scene& scene, const Expression& c, const Expression& k) {
  // snippet: docs/formulas.md 1
}

void support(Scene& scene, const Expression& a, const Expression& b) {
  // snippet: docs/formulas.md 2
}

void friction(Scene& scene, const ConstraintHandle& floor, const Expression& f, const Expression& fs, const Expression& s0) {
  // snippet: docs/formulas.md 3
}
