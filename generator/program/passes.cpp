// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/program/passes.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/base/did_you_mean.hpp"
#include "generator/base/error.hpp"

namespace torsor {

const std::vector<Pass>& all_passes() {
  using enum PassLevel;
  static const std::vector<Pass> all{
      {"sharing", program, "a sum or product that is there already, up to sign, is not computed again", &Passes::sharing},
      {"identities", program, "sin^2 + cos^2 = 1", &Passes::identities},
      {"zero_test", results, "what vanishes identically, although its terms do not show it, is zero", &Passes::zero_test},
      {"products", results, "a product that stands in several sums of a kernel is computed once", &Passes::products},
      {"factoring", listing, "what terms of a sum share is multiplied once", &Passes::factoring},
      {"hoisting", listing, "what depends on parameters alone is computed once for a set of them", &Passes::hoisting},
      {"regrouping", bodies, "inertia moves across joints to where it has the same effect and costs less", &Passes::regrouping},
      {"off_axis", bodies, "inverse dynamics: so does the whole spread of mass along a joint's axis", &Passes::off_axis},
      {"reframing", bodies, "links get frames in which turns and lengths cost least", &Passes::reframing},
      {"length_unit", bodies, "lengths in units of the most frequent one, whose products vanish", &Passes::length_unit},
      {"scheduling", listing, "terms and definitions in an order in which a processor waits little", &Passes::scheduling}};
  return all;
}

Passes passes_without(const std::string& list) {
  Passes passes;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string name = list.substr(begin, end - begin);
    begin = end + 1;
    const std::vector<Pass>& all = all_passes();
    const auto place = std::find_if(all.begin(), all.end(), [&](const Pass& pass) { return pass.name == name; });
    if (place == all.end()) {
      std::vector<std::string> known;
      for (const Pass& pass : all) known.emplace_back(pass.name);
      throw UsageError(fmt::format("unknown pass '{}' in --without: {}known are {}", name, did_you_mean(name, known),
                                   fmt::join(known, ", ")));
    }
    passes.*(place->on) = false;
  }
  return passes;
}

}  // namespace torsor
