// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/base/natural_language.hpp"
#include "generator/printing/inline_view.hpp"

namespace torsor::printing {

/// Which limit a value meets that is not written out.
inline std::string limit_met(InlineView& view, const Value& value, const NaturalLanguage& say) {
  const double before = view.term_bound(value);
  return before > view.limits().expansion ? say("up to {:.2g} terms before anything cancels, limit {}", before, view.limits().expansion)
                                          : say("more than {} terms", view.limits().terms);
}

}  // namespace torsor::printing
