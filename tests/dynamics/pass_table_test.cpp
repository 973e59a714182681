// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/motion/pass_table.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/motion/model.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::pass_table_test {
namespace {

/// q^4 and 0 = sin(2 q) - 2 sin(q) cos(q), where the passes on results allow: the sum of exponents, and whether the zero is one.
struct Left {
  int power = 0;
  bool zero = false;
};

Left left_by(const Passes& passes) {
  Program program({}, passes);
  const auto symbol = std::make_shared<const Symbol>(Symbol{"q", Unit(), SymbolKind::coordinate, 0, {}});
  const Value q = program.symbol(symbol);
  const Value hidden = program.sin(Number(2) * q) - Number(2) * program.sin(q) * program.cos(q);
  Computation computation{{{{"r", "", 0}, pow(q, 4)}, {{"r", "", 1}, hidden}}};
  run_passes(passes, program, computation);
  Left left;
  for (const Factor& factor : computation.assignments[0].value.polynomial().terms()[0].monomial) left.power += factor.exponent;
  left.zero = computation.assignments[1].value.is_zero();
  return left;
}

TEST(PassTable, RunsThosePassesOnResultsThatAreOn) {
  const Left all = left_by({});
  EXPECT_EQ(all.power, 2) << "of the square, which has a definition of its own";
  EXPECT_TRUE(all.zero);
  const Left without_products = left_by(passes_without("products"));
  EXPECT_EQ(without_products.power, 4);
  EXPECT_TRUE(without_products.zero);
  const Left without_zero_test = left_by(passes_without("zero_test"));
  EXPECT_EQ(without_zero_test.power, 2);
  EXPECT_FALSE(without_zero_test.zero);
}

TEST(PassTable, RunsNoPassWithoutTheOneThatItNeeds) { EXPECT_EQ(left_by(passes_without("sharing")).power, 4); }

/// Masses of the links, as text.
std::string masses(const BodyTree& tree) {
  std::string text;
  for (const Link& link : tree.links()) text += to_string(link.mass.mass) + "; ";
  return text;
}

TEST(PassTable, MovesInertiaInTheTreesThatRecursionsTake) {
  const Scene scene = testing_mechanisms::random_mechanism(901);
  const auto trees = [&scene](const std::string& without) {
    ModelOptions options;
    options.passes = passes_without(without);
    Program program(Model::resolver(scene, options), options.passes);
    const Model model(scene, program, options);
    return std::vector<std::string>{masses(model.with_bodies()), masses(model.regrouped()), masses(model.without_lines())};
  };
  const std::vector<std::string> all = trees(""), no_line = trees("off_axis"), none = trees("regrouping");
  EXPECT_NE(all[1], all[0]);
  EXPECT_EQ(no_line[2], no_line[1]) << "the trees differ by off_axis alone";
  EXPECT_EQ(none[1], none[0]);
  EXPECT_EQ(none[2], none[0]) << "off_axis needs regrouping";
}

TEST(PassTable, NamesEachPassOnce) {
  for (const Pass& pass : all_passes()) {
    Passes others = passes_without(pass.name);
    EXPECT_FALSE(others.*pass.on) << pass.name;
    others.*pass.on = true;
    for (const Pass& other : all_passes()) EXPECT_TRUE(others.*other.on) << pass.name << " and " << other.name;
  }
}

}  // namespace
}  // namespace torsor::pass_table_test
