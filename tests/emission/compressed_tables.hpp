// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace torsor::testing_headers {

/// Numbers of the table `name[] = {...};` of a header.
inline std::vector<std::size_t> numbers(const std::string& tables, const std::string& name) {
  std::vector<std::size_t> all;
  const std::size_t begin = tables.find(name + "[] = {");
  if (begin == std::string::npos) return all;
  std::string list = tables.substr(begin + name.size() + 6);
  list = list.substr(0, list.find('}'));
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    all.push_back(std::stoul(list.substr(at, end - at)));
    at = end + 1;
  }
  return all;
}

}  // namespace torsor::testing_headers
