// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

/// Text as content of an HTML element or of a quoted attribute: printable, with & < > " ' as references.
std::string html_escaped(std::string_view text);

/// Text between tags, apart from the direction of the text around it; new lines stay.
std::string html_lines(std::string_view text);

}  // namespace torsor
