// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace torsor::xacro {

/// The letters of a text in UTF-8, as Python counts them: one for each code point. A byte that is of none counts as one.
std::vector<std::string> letters(const std::string& text);
std::size_t letter_count(const std::string& text);
/// Those from `begin` on, `count` at most.
std::string part_of_letters(const std::string& text, std::size_t begin, std::size_t count);
bool is_ascii(const std::string& text);

}  // namespace torsor::xacro
