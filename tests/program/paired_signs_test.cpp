// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/paired_signs.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/flattening.hpp"

namespace torsor::paired_signs_test {
namespace {

struct Lengths {
  Scene scene{"symbols"};
  Program program;
  Expression k = scene.parameter("k", "1"), x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");

  Value value(const Expression& formula) { return program.lower(formula); }
  bool same(const Value& a, const Expression& b) { return a.polynomial() == value(b).polynomial(); }
  double at(const Value& of, double x_value) {
    return Evaluator<double>(program, [&](const SymbolPointer& symbol) { return symbol == x.as_symbol() ? x_value : 3.0; })(of);
  }
};

TEST(PairedSigns, LeaveProductsWithoutKinks) {
  Lengths of;
  const Expression size = abs(of.x), turned = sign(of.x), area = abs(of.x * of.y);
  EXPECT_TRUE(of.same(of.value(size * size), of.x * of.x));
  EXPECT_TRUE(of.same(of.value(sqrt(of.x * of.x) * sqrt(of.x * of.x)), of.x * of.x));
  EXPECT_TRUE(of.same(of.value(pow(size, 3)), of.x * of.x * size));
  EXPECT_TRUE(of.same(of.value(of.k * pow(size, -2)), of.k * pow(of.x, -2)));
  EXPECT_TRUE(of.same(of.value(of.k * turned * size), of.k * of.x));
  EXPECT_TRUE(of.same(of.value(turned * pow(size, -1)), pow(of.x, -1)));
  EXPECT_TRUE(of.same(of.value(pow(turned, 2)), 1));
  EXPECT_TRUE(of.same(of.value(pow(turned, -3)), turned));
  EXPECT_TRUE(of.same(of.value(area * area), of.x * of.x * of.y * of.y));
  // Other arguments are left alone.
  const Value mixed = of.value(turned * abs(of.y));
  EXPECT_EQ(mixed.polynomial().terms()[0].monomial.size(), 2u);
  EXPECT_TRUE(of.same(of.value(pow(turned, 2) * abs(of.y) * size), abs(of.y) * size));
}

TEST(PairedSigns, AreFoundBehindNames) {
  Lengths of;
  const Value turned = of.value(sign(of.x)), named = of.program.bind(of.value(of.k * sign(of.x)), "slope");
  EXPECT_TRUE(of.same(named * turned, of.k));
  EXPECT_TRUE(of.same(pow(named, 2), of.k * of.k));
}

// k (|x| - y)^2 / 2 has the slope k (|x| - y) sign(x) and the curvature k, at x = 0 too on either side.
TEST(PairedSigns, GiveSquaresOfLengthsTheirCurvature) {
  Lengths of;
  const Expression size = sqrt(of.x * of.x);
  for (const Expression& square : {size * size, pow(size, 2), pow(size - of.y, 2)}) {
    const Value slope = partial_derivation(of.program, of.x.as_symbol())(of.value(of.k * square / 2));
    const Value curvature = partial_derivation(of.program, of.x.as_symbol())(slope);
    for (const double x : {0.0, -0.0, 1e-300, 2.0, -2.0}) EXPECT_EQ(of.at(curvature, x), 3.0) << x;
  }
}

// r^4 is a polynomial, r^3 has a slope at r = 0.
TEST(PairedSigns, LeavePowersOfDistancesTheirSlopes) {
  Lengths of;
  const Expression r = sqrt(of.x * of.x + of.y * of.y);
  const SymbolPointer x = of.x.as_symbol(), y = of.y.as_symbol();
  const auto at_centre = [&](const Value& value) {
    return Evaluator<double>(of.program, [](const SymbolPointer&) { return 0.0; })(value);
  };
  for (const int power : {3, 4, 5}) {
    const Value value = of.value(pow(r, power)), forward = partial_derivation(of.program, x)(value);
    EXPECT_EQ(at_centre(forward), 0) << power;
    EXPECT_EQ(at_centre(gradient(value, {x, y})[1]), 0) << power;
    if (power == 3) continue;
    EXPECT_EQ(at_centre(partial_derivation(of.program, y)(forward)), 0) << power;
  }
}

TEST(PairedSigns, AreFoundInSumsThatAreMultipliedOut) {
  Lengths of;
  const Expression size = abs(of.x);
  const Value product = of.value((size + of.y) * (size - of.y));
  Flattening flat(of.program, 100);
  EXPECT_TRUE(flat(product)->polynomial() == of.value(of.x * of.x - of.y * of.y).polynomial());
}

}  // namespace
}  // namespace torsor::paired_signs_test
