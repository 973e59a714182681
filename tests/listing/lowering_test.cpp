// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/lowering.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::lowering_test {
namespace {

class LoweredFunction : public testing::Test {
 protected:
  Listing lowered(const Computation& computation) {
    schedule_ = make_schedule(program_, computation.values());
    return lower(program_, schedule_.function, computation, {&layout_, &schedule_, "tested"});
  }
  SymbolPointer symbol(const Expression& expression) { return expression.as_symbol(); }

  Scene scene_{"lowered"};
  Expression x_ = scene_.coordinate("x", "1"), y_ = scene_.coordinate("y", "1");
  Expression a_ = scene_.parameter("a", "1"), b_ = scene_.parameter("b", "1");
  Program program_;
  Layout layout_{{symbol(x_), symbol(y_)}, {}, {}, {}, {}, {symbol(a_), symbol(b_)}};
  Schedule schedule_;
};

TEST_F(LoweredFunction, ReadsArgumentsByTheirPlaces) {
  const Listing listing = lowered({{{{"r", "", 0}, program_.lower(y_ * x_ + y_)}}});
  ASSERT_EQ(listing.given.size(), 2u);
  for (const ValueNumber given : listing.given) {
    const Quantity& quantity = listing.quantity(given);
    EXPECT_EQ(quantity.table, Table::coordinate);
    EXPECT_EQ(quantity.name, quantity.index == 0 ? "q_x" : "q_y");
  }
  EXPECT_TRUE(listing.reads(Table::coordinate));
  EXPECT_FALSE(listing.reads(Table::parameter));
  EXPECT_EQ(count(listing).total(), 2);
}

TEST_F(LoweredFunction, RefusesWhatItIsNotGiven) {
  const Expression z = scene_.coordinate("z", "1");
  try {
    lowered({{{{"r", "", 0}, program_.lower(z * z)}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the kernel 'tested' needs 'z', which is not among its arguments");
  }
}

TEST_F(LoweredFunction, ComputesWhatRepeatsUpToSignOnce) {
  const Value value = program_.lower(x_ * y_ + x_);
  const Listing listing = lowered({{{{"r", "", 0}, value}, {{"r", "", 1}, -value}, {{"r", "", 2}, program_.number(Number(3))}}});
  ASSERT_EQ(listing.outputs.size(), 3u);
  EXPECT_TRUE(listing.outputs[0].checked);
  const Output& second = listing.outputs[1];
  EXPECT_FALSE(second.checked);
  EXPECT_TRUE(second.value.negative);
  ASSERT_EQ(second.value.formula.kind, Formula::Kind::value_number);
  const Quantity& read = listing.quantity(second.value.formula.value_number.value());
  EXPECT_EQ(read.table, Table::output);
  EXPECT_EQ(read.index, 0u);
  EXPECT_FALSE(listing.outputs[2].checked) << "a number is finite";
  EXPECT_EQ(count(listing).total(), 2);
}

TEST_F(LoweredFunction, LeavesWhatDependsOnParametersToPrecompute) {
  const Value product = program_.bind(program_.lower(a_ * b_ + a_));
  const Computation computation{{{{"r", "", 0}, product * program_.lower(x_)}, {{"r", "", 1}, program_.lower(a_ * a_)}}};
  const Listing listing = lowered(computation);
  EXPECT_TRUE(listing.reads(Table::precomputed));
  EXPECT_FALSE(listing.reads(Table::parameter));
  EXPECT_EQ(count(listing).total(), 1);
  const Listing precompute = lower_precompute(program_, schedule_, layout_);
  EXPECT_EQ(precomputed_count(schedule_), 2u);
  EXPECT_EQ(precompute.outputs.size(), 2u);
  EXPECT_EQ(count(precompute).total(), 3);
}

TEST_F(LoweredFunction, TakesSinesOfAnglesThatNeedNoneTogether) {
  const Value sine = program_.lower(sin(x_)), other = program_.lower(cos(y_ + 1));
  const Value nested = program_.sin(program_.bind(sine * program_.lower(y_)));
  const Listing listing = lowered({{{{"r", "", 0}, nested + other}}});
  std::vector<std::size_t> groups;
  for (const Statement& each : listing.statements) {
    if (const auto* group = std::get_if<SinesAndCosines>(&each)) groups.push_back(group->angles.size());
  }
  EXPECT_EQ(groups, (std::vector<std::size_t>{2, 1}));
}

TEST_F(LoweredFunction, MeasuresPivotsThatMayVanish) {
  const Value pivot = program_.lower(1 + x_ * x_), diagonal = program_.lower(2 + x_ * x_);
  Computation computation{{{{"r", "", 0}, pivot}}};
  computation.pivots = {{pivot, diagonal}, {program_.number(Number(2)), program_.number(Number(3))}};
  const Listing listing = lowered(computation);
  ASSERT_EQ(listing.pivots.size(), 1u) << "a positive number is regular whatever the state";
  EXPECT_EQ(listing.quantity(listing.pivots[0].pivot.formula.value_number.value()).table, Table::output);
  EXPECT_EQ(listing.of_pivots.size(), 1u);
  EXPECT_EQ(count(listing).total(), 4);
}

TEST_F(LoweredFunction, MeasuresPivotsThatAreNegativeNumbers) {
  const Value pivot = program_.lower(1 + x_ * x_);
  Computation computation{{{{"r", "", 0}, pivot}}};
  computation.pivots = {{program_.number(Number(-2)), program_.number(Number(3))}};
  EXPECT_EQ(lowered(computation).pivots.size(), 1u) << "no state makes it regular";
}

TEST_F(LoweredFunction, DropsWhatOnlyLiteralsRead) {
  const Value angle = program_.lower(sin(Expression(0.3)));
  const Listing listing = lowered({{{{"r", "", 0}, angle * program_.lower(x_)}}});
  const auto needed = [&](bool computed) {
    const std::vector<bool> read = read_quantities(listing, computed);
    std::size_t statements = 0;
    for (const Statement& each : listing.statements) statements += is_needed(each, read) ? 1 : 0;
    return statements;
  };
  EXPECT_EQ(needed(true), 2u) << "the number 0.3 and its sine";
  EXPECT_EQ(needed(false), 1u);
}

TEST(TargetText, NamesMemberAndEntry) {
  EXPECT_EQ((Target{"forces", "", 3}).to_string(), "forces[3]");
  EXPECT_EQ((Target{"result", "A", 7}).to_string(), "result.A[7]");
  EXPECT_EQ((Target{"result", "power"}).to_string(), "result.power");
  EXPECT_EQ(Target{"mass"}[2], (Target{"mass", "", 2}));
}

}  // namespace
}  // namespace torsor::lowering_test
