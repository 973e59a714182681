// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace torsor {

/// The text of a licence of what units of FMI hold: "MIT.txt" or "MIT-0.txt". Throws Error for a name that is none.
std::string_view embedded_licence_text(std::string_view name);

/// Their names, in alphabetical order.
std::vector<std::string_view> embedded_licence_text_names();

}  // namespace torsor
