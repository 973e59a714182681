// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace torsor {

/// A font of KaTeX: "Main-Bold", and its WOFF2 file in hexadecimal digits.
struct KatexFont {
  std::string_view name;
  std::string_view digits;
};

// What was found of KaTeX when the library was built; all are empty where it was not installed (libjs-katex).
std::string_view katex_script();
std::string_view katex_style();
std::vector<KatexFont> katex_fonts();

}  // namespace torsor
