// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace torsor::printing {

/// About how wide LaTeX and KaTeX set a formula on one line, in points of 10-point letters.
double latex_width(std::string_view latex);

}  // namespace torsor::printing
