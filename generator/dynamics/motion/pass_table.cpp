// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/pass_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {

namespace {

void reframe(BodyTrees& trees) {
  trees.with_bodies = reframed(trees.with_bodies);
  trees.regrouped = trees.without_lines = trees.with_bodies;
}

void regroup(BodyTrees& trees) { trees.regrouped = trees.without_lines = regrouped(trees.with_bodies); }

void move_off_axes(BodyTrees& trees) { trees.without_lines = without_lines(trees.with_bodies); }

void measure_lengths(BodyTrees& trees) {
  for (BodyTree* tree : {&trees.with_bodies, &trees.regrouped, &trees.without_lines}) *tree = in_length_unit(*tree);
}

}  // namespace

const std::vector<Pass>& all_passes() {
  static const std::vector<Pass> all{
      {"sharing", "a sum or product that is there already, up to sign, is not computed again", &Passes::sharing,
       Rule{"program", "what follows from two equal definitions has been derived twice by then"}},
      {"identities", "sin^2 + cos^2 = 1", &Passes::identities,
       Rule{"program", "by then other definitions have read the product whose terms cancel"}},
      {"zero_test", "what vanishes identically, although its terms do not show it, is zero", &Passes::zero_test,
       OnResults(clear_identically_zero)},
      {"products", "a product that stands in several sums of a kernel is computed once", &Passes::products,
       OnResults(share_products), &Passes::sharing},
      {"factoring", "what terms of a sum share is multiplied once", &Passes::factoring,
       Rule{"listing", "a statement is a tree, and what terms share shows in the flat sum alone"}},
      {"hoisting", "what depends on parameters alone is computed once for a set of them", &Passes::hoisting,
       Rule{"listing", "it divides definitions among two listings, before either is made"}},
      {"reframing", "links get frames in which turns and lengths cost least", &Passes::reframing, reframe},
      {"regrouping", "inertia moves across joints to where it has the same effect and costs less", &Passes::regrouping,
       regroup},
      {"off_axis", "inverse dynamics: so does the whole spread of mass along a joint's axis", &Passes::off_axis,
       move_off_axes, &Passes::regrouping},
      {"length_unit", "lengths in units of the most frequent one, whose products vanish", &Passes::length_unit,
       measure_lengths},
      {"scheduling", "terms and definitions in an order in which a processor waits little", &Passes::scheduling,
       Rule{"listing", "statements are numbered in the order that it gives them"}}};
  return all;
}

const char* Pass::level() const {
  if (std::holds_alternative<OnBodies>(function)) return "bodies";
  if (std::holds_alternative<OnResults>(function)) return "results";
  return std::get<Rule>(function).level;
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
