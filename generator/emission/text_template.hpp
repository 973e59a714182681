// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace torsor {

/// Replaces the placeholders `@name@` (lower-case letters, digits, underscores) of a template by their texts.
///
/// A placeholder that is alone on its line gives its indentation to every line of its text, and takes the line away
/// with it when the text is empty. Texts are copied as they are: a placeholder inside one is not replaced.
/// Throws Error naming the template and a placeholder that has no text, a text whose placeholder is missing, or a
/// stray '@'.
std::string fill_template(std::string_view name, std::string_view text,
                          const std::map<std::string, std::string>& values);

/// Every line of a text behind the indentation, each ended; empty lines stay empty.
std::string indented(const std::string& text, std::string_view indentation);

}  // namespace torsor
