// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace torsor {

/// An element of an XML text that another one closes, or none.
struct UnclosedElement {
  int line = 0;         ///< where that is noticed
  std::string message;  ///< "</robot> is missing at the end: <robot> of line 1 is never closed"
};

/// The first element that is not closed by its own name; none when all are. Of a text that a parser has refused, to say
/// why: comments, CDATA, declarations and values in quotes are skipped as XML 1.0 has them.
std::optional<UnclosedElement> unclosed_element(std::string_view text);

}  // namespace torsor
