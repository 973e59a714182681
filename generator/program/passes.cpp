// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/program/passes.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/base/did_you_mean.hpp"
#include "generator/base/error.hpp"

namespace torsor {

const std::vector<PassName>& pass_names() {
  static const std::vector<PassName> names{
      {"sharing", &Passes::sharing},       {"identities", &Passes::identities}, {"zero_test", &Passes::zero_test},
      {"products", &Passes::products},     {"factoring", &Passes::factoring},   {"hoisting", &Passes::hoisting},
      {"regrouping", &Passes::regrouping}, {"off_axis", &Passes::off_axis},     {"reframing", &Passes::reframing},
      {"length_unit", &Passes::length_unit},
      {"scheduling", &Passes::scheduling}};
  return names;
}

Passes passes_without(const std::string& list) {
  Passes passes;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string name = list.substr(begin, end - begin);
    begin = end + 1;
    const auto& names = pass_names();
    const auto place = std::find_if(names.begin(), names.end(), [&](const PassName& pass) { return pass.name == name; });
    if (place == names.end()) {
      std::vector<std::string> known;
      for (const PassName& pass : names) known.emplace_back(pass.name);
      throw UsageError(fmt::format("unknown pass '{}' in --without: {}known are {}", name, did_you_mean(name, known),
                                   fmt::join(known, ", ")));
    }
    passes.*(place->on) = false;
  }
  return passes;
}

}  // namespace torsor
