// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// The names that the option --points stands for: `all` by itself is `every` part, unless one of them or of the `others`
/// is called so.
std::vector<std::string> point_names(const std::vector<std::string>& given, const std::vector<std::string>& every,
                                     const std::vector<std::string>& others = {});

}  // namespace torsor
