// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/precomputation.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "torsor/generator/listing/lowering.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::precomputation_test {
namespace {

/// What functions of two parameters have computed once.
class PutTogether : public testing::Test {
 protected:
  /// Of a function with these results, derived in a program of its own.
  Listing once(const std::vector<Expression>& results) {
    Program program;
    std::vector<Value> values;
    const Value state = program.lower(x_);
    for (const Expression& each : results) values.push_back(program.bind(program.lower(each)) * state);
    return lower_precompute(program, make_schedule(program, values), layout_);
  }
  static std::vector<std::string> names(const Precomputation& all) {
    std::vector<std::string> list;
    for (const PrecomputedMember& each : all.members()) list.push_back(each.name);
    return list;
  }

  Scene scene_{"put_together"};
  Expression x_ = scene_.coordinate("x", "1"), a_ = scene_.parameter("a", "1"), b_ = scene_.parameter("b", "1");
  Layout layout_{{x_.as_symbol()}, {}, {}, {}, {}, {a_.as_symbol(), b_.as_symbol()}};
};

TEST_F(PutTogether, ComputesWhatIsAlikeOnce) {
  Precomputation all;
  EXPECT_EQ(all.add(once({a_ * b_ + 1, a_ + b_})), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(all.add(once({a_ + b_, a_ * a_ + b_})), (std::vector<std::size_t>{1, 2}));
  ASSERT_EQ(all.listing().outputs.size(), 3u);
  EXPECT_EQ(count(all.listing()).total(), 2 + 1 + 2);
}

TEST_F(PutTogether, NamesAMemberAfterItsFormulaWhicheverOthersThereAre) {
  Precomputation alone, behind;
  alone.add(once({a_ + b_}));
  behind.add(once({a_ * b_ + 1, b_ - a_}));
  const std::size_t place = behind.add(once({a_ + b_})).at(0);
  EXPECT_EQ(names(behind).at(place), names(alone).at(0));
  EXPECT_NE(names(behind).at(0), names(behind).at(1));
}

TEST_F(PutTogether, LeavesOutWhatTakesNoOperation) {
  Program program;
  const std::vector<Value> results{program.lower(a_), program.lower(a_ + b_)};
  EXPECT_EQ(make_schedule(program, results).results.sums().size(), 1u);
}

TEST_F(PutTogether, TakesASineThatAnotherFunctionLacked) {
  Precomputation all;
  all.add(once({sin(a_) + 1, cos(b_)}));
  all.add(once({sin(b_) + cos(a_)}));
  EXPECT_EQ(count(all.listing()).sincos_pairs, 2);
  // Each quantity that a statement reads is defined before it.
  std::vector<bool> known(all.listing().quantities.size(), false);
  for (const ValueNumber given : all.listing().given) known[static_cast<std::size_t>(given)] = true;
  const auto define = [&known](ValueNumber value_number) { known[static_cast<std::size_t>(value_number)] = true; };
  const std::function<void(const Formula&)> expect_known = [&](const Formula& formula) {
    if (formula.kind == Formula::Kind::value_number) {
      EXPECT_TRUE(known[static_cast<std::size_t>(formula.value_number.value())]);
    }
    for (const Formula& child : formula.children) expect_known(child);
  };
  for (const Statement& statement : all.listing().statements) {
    if (const auto* assigned = std::get_if<Assigned>(&statement)) {
      expect_known(assigned->right);
      define(assigned->quantity);
    } else if (const auto* group = std::get_if<SinesAndCosines>(&statement)) {
      for (const SineCosinePair& pair : group->angles) {
        EXPECT_TRUE(known[static_cast<std::size_t>(pair.angle)]);
        if (pair.sine) define(*pair.sine);
        if (pair.cosine) define(*pair.cosine);
      }
    }
  }
  for (const Output& output : all.listing().outputs) expect_known(output.value.formula);
}

}  // namespace
}  // namespace torsor::precomputation_test
