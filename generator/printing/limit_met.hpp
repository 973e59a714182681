// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/printing/inline_view.hpp"

namespace torsor::printing {

/// Which limit a value meets that is not written out.
std::string limit_met(InlineView& view, const Value& value, const NaturalLanguage& say);

}  // namespace torsor::printing
