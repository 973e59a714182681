// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

/// The text with these of its characters as entities of XML and HTML: by name where XML has one, else by number.
std::string with_entities(std::string_view text, std::string_view characters);

}  // namespace torsor
