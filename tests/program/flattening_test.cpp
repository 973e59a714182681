// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/flattening.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::flattening_test {
namespace {

struct Angle {
  Scene scene{"symbols"};
  Program program;
  Expression a = scene.parameter("a", "1"), c = scene.parameter("c", "1"), q = scene.coordinate("q", "rad"),
             x = scene.coordinate("x", "rad"), y = scene.coordinate("y", "rad");

  Value bound(const Expression& formula) { return program.bind(program.lower(formula)); }
};

/// (A + (C − A) cos²) − (C cos / C) (C cos) = A sin²: the pivot of a top next to its locked angle.
TEST(Flattening, LeavesOneTermOfThePivotOfALockedAngle) {
  Angle of;
  const Value mass = of.bound(of.a + (of.c - of.a) * cos(of.q) * cos(of.q));
  const Value side = of.bound(of.c * cos(of.q)), pivot = of.bound(of.c);
  const Value lower = of.program.bind(side * pow(pivot, -1));
  const Value flat = Flattening(of.program).difference(mass, lower, side);
  ASSERT_EQ(flat.polynomial().terms().size(), 1U) << to_string(flat);
  EXPECT_TRUE(identically_zero(flat - of.program.lower(of.a * sin(of.q) * sin(of.q))));
}

TEST(Flattening, GivesAnExactZero) {
  Angle of;
  const Value whole = of.bound(of.a * cos(of.q) + of.a * of.x);
  const Value part = of.bound(cos(of.q) + of.x);
  EXPECT_TRUE(Flattening(of.program).difference(whole, of.bound(of.a), part).is_zero());
}

/// a + 2 cos q − (1 + cos q)²/1 = (a − 1) − cos²: with a = 2 it is sin² and not a difference.
TEST(Flattening, PrefersTheFormWhoseTermsHaveOneSign) {
  Angle of;
  const Value mass = of.bound(2 + 2 * cos(of.q)), side = of.bound(1 + cos(of.q));
  const Value flat = Flattening(of.program).difference(mass, side, side);
  ASSERT_EQ(flat.polynomial().terms().size(), 1U) << to_string(flat);
  EXPECT_TRUE(identically_zero(flat - of.program.lower(sin(of.q) * sin(of.q))));
}

/// (x − y)² as x² − 2xy + y² would lose what the difference keeps.
TEST(Flattening, LeavesProductsOfSumsAsTheyStand) {
  Angle of;
  const Value difference = of.bound(of.x - of.y);
  const Value square = difference * difference;
  EXPECT_EQ(Flattening(of.program).cheaper(square).polynomial(), square.polynomial());
  const Value rest = Flattening(of.program).difference(of.bound(of.a), difference, difference);
  EXPECT_EQ(rest.polynomial(), (of.bound(of.a) - square).polynomial());
}

TEST(Flattening, AnswersNothingBeyondItsLimitAndWithoutIdentitiesLeavesAllAsItStands) {
  Angle of;
  const Value sum = of.bound(of.a + of.c + of.x), other = of.bound(of.x - of.y + of.q);
  EXPECT_FALSE(Flattening(of.program, 4)(sum * other));
  EXPECT_TRUE(Flattening(of.program, 9)(sum * other));
  Passes passes;
  passes.identities = false;
  Program plain({}, passes);
  const Value cosine = plain.bind(plain.lower(cos(of.q)));
  const Value one = plain.number(Number(1));
  EXPECT_EQ(Flattening(plain).difference(one, cosine, cosine).polynomial(), (one - cosine * cosine).polynomial());
}

/// (a x + c) − 2 (a x/2 + y) + (y + (y + cos q)): all but c and cos q cancel, the latter two levels deep.
TEST(Cancelled, PutsSumsBackWhoseTermsCancel) {
  Angle of;
  const Value first = of.bound(of.a * of.x + of.c), second = of.bound(of.a * of.x / 2 + of.y);
  const Value y = of.program.lower(of.y), third = of.bound(of.y + cos(of.q));
  const Value last = of.program.bind(third + y);
  const Value left = cancelled(of.program, first - 2 * second + last);
  EXPECT_EQ(left.polynomial().terms().size(), 2U) << to_string(left);
  EXPECT_TRUE(identically_zero(left - of.program.lower(of.c + cos(of.q))));
}

TEST(Cancelled, LeavesSumsAloneOfWhichNothingCancels) {
  Angle of;
  const Value first = of.bound(of.a + of.x), second = of.bound(of.c + of.y), x = of.program.lower(of.x);
  const Value sum = first + second, once_more = first + x;  // a + 2 x: no term vanishes
  EXPECT_EQ(to_string(cancelled(of.program, sum)), to_string(sum));
  EXPECT_EQ(to_string(cancelled(of.program, once_more)), to_string(once_more));
}

}  // namespace
}  // namespace torsor::flattening_test
