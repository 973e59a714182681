// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/limit_met.hpp"

namespace torsor::printing {

std::string limit_met(InlineView& view, const Value& value, const NaturalLanguage& say) {
  const double before = view.term_bound(value);
  const InlineLimits& limits = view.limits();
  return before > limits.expansion ? say("up to {:.2g} terms before anything cancels, limit {}", before, limits.expansion)
                                   : say("more than {} terms", limits.terms);
}

}  // namespace torsor::printing
