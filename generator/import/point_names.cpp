// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/point_names.hpp"

#include <algorithm>

namespace torsor {

std::vector<std::string> point_names(const std::vector<std::string>& given, const std::vector<std::string>& every,
                                     const std::vector<std::string>& others) {
  const std::string all = "all";
  const auto is_called_so = [&all](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), all) != names.end();
  };
  const bool means_every = given == std::vector<std::string>{all} && !is_called_so(every) && !is_called_so(others);
  return means_every ? every : given;
}

}  // namespace torsor
