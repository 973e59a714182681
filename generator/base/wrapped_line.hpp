// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace torsor {

/// Breaks a line of code longer than 120 columns before operators or after commas; later lines are indented further.
std::string wrapped(const std::string& line, std::size_t indentation);

}  // namespace torsor
