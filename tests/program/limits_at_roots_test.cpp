// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/limits_at_roots.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/program/test_symbols.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/division_by_zero.hpp"

namespace torsor::limits_at_roots_test {
namespace {

using namespace testing_symbols;
using namespace literals;

class LimitsAtRoots : public ::testing::Test {
 protected:
  SymbolPointer sx = make_symbol("x", "1", SymbolKind::velocity), sy = make_symbol("y", "1", SymbolKind::velocity);
  SymbolPointer sz = make_symbol("z", "1", SymbolKind::velocity), sk = make_symbol("k");
  Expression x = sx, y = sy, z = sz, k = sk;
  Program program;

  /// f and its slope along x with their limits, so that they are looked at together.
  std::vector<Value> with_slope(const Expression& f) {
    const Value value = program.bind(program.lower(f));
    return with_limits_at_roots(program, {value, partial_derivation(program, sx)(value)});
  }
  double at(const Value& value, double x0, double y0, double z0 = 2) {
    const Point point{{"x", Real::from_double(x0)}, {"y", Real::from_double(y0)}, {"z", Real::from_double(z0)}, {"k", Real(3)}};
    return Evaluator<Real>(program, testing_symbols::at(point))(value).to_double();
  }
  bool is_finite(const Value& value, double x0, double y0, double z0) {
    try {
      return std::isfinite(at(value, x0, y0, z0));
    } catch (const DivisionByZero&) {
      return false;
    }
  }
  /// Whether there is no value where x and y vanish.
  bool divides_by_zero(const Expression& f) { return !is_finite(with_slope(f)[1], 0, 0, 2); }
  Expression root() const { return sqrt(x * x + y * y); }
};

TEST_F(LimitsAtRoots, SlopesOfADragVanishAtRest) {
  const Expression V = root();
  for (const Expression& f : {V * x, (2 + V) * x - 2 * x, (x * x + y * y) * x / V, pow(V, 3), sin(V * y) * z,
                              (x * x + y * y) * y * exp(V) / V, k * V * (x - y)}) {
    EXPECT_EQ(at(with_slope(f)[1], 0, 0), 0) << f.to_string();
  }
  EXPECT_EQ(at(with_slope((3 + V) * x)[1], 0, 0), 3);
  EXPECT_EQ(at(with_slope(x / (2 + V * y))[1], 0, 0), 0.5);
}

/// Beside the root's zero nothing changes.
TEST_F(LimitsAtRoots, AreTheSlopesElsewhere) {
  const Value slope = with_slope(root() * x)[1];
  EXPECT_NEAR(at(slope, 0.6, 0.8), 1 + 0.36, 1e-15);
  EXPECT_NEAR(at(slope, 3e-200, 4e-200) / 5e-200, 1 + 0.36, 1e-15);
}

/// Of degree zero: the limit would depend on the way.
TEST_F(LimitsAtRoots, AreNoneWhereTheyDependOnTheWay) {
  const Expression V = root();
  for (const Expression& f : {V, x * y / V, (V - 1) * x / V, log(1 + V) * z, z * z * x / V}) {
    EXPECT_TRUE(divides_by_zero(f)) << f.to_string();
  }
  // One value that has none leaves the others as they are, which share definitions with it.
  const Value drag = partial_derivation(program, sx)(program.bind(program.lower(V * x)));
  const std::vector<Value> both{drag, partial_derivation(program, sx)(program.lower(V))};
  const std::vector<Value> same = with_limits_at_roots(program, both);
  EXPECT_EQ(same[0].polynomial(), both[0].polynomial());
  EXPECT_EQ(same[1].polynomial(), both[1].polynomial());
}

/// Roots that vanish together share what is small: x^2/(V W) with W = sqrt(4 x^2 + y^2) tends to 1/2 where y = 0.
TEST_F(LimitsAtRoots, CountWhatIsSmallOnce) {
  const Expression w = make_symbol("w", "1", SymbolKind::velocity);
  const Expression V = root(), W = sqrt(4 * x * x + y * y), U = sqrt(z * z + w * w);
  const Value together = program.lower(x * x / (V * W));
  EXPECT_EQ(with_limits_at_roots(program, {together})[0].polynomial(), together.polynomial());
  // One size in common: x^2/(V W) is 1 along x and 0 along y.
  const Value common = with_limits_at_roots(program, {program.lower(x * x / (V * sqrt(x * x + z * z)))})[0];
  EXPECT_FALSE(is_finite(common, 0, 0, 0));
  EXPECT_FALSE(is_finite(with_limits_at_roots(program, {program.lower(atan2(x * x / V, z))})[0], 0, 0, 0));
  const Value apart = with_limits_at_roots(program, {program.lower(x * x * z * z / (V * U))})[0];
  Point point{{"x", Real()}, {"y", Real()}, {"z", Real(2)}, {"w", Real(1)}};
  EXPECT_EQ(Evaluator<Real>(program, testing_symbols::at(point))(apart).to_double(), 0);
  point = {{"x", Real(1)}, {"y", Real()}, {"z", Real()}, {"w", Real()}};
  EXPECT_EQ(Evaluator<Real>(program, testing_symbols::at(point))(apart).to_double(), 0);
}

/// |y| is not small beside sqrt(x^2 + k^2 y^2) where k may be zero, and a root of parameters vanishes nowhere.
TEST_F(LimitsAtRoots, TakeNoParameterForASize) {
  const Expression V = sqrt(x * x + k * k * y * y), length = sqrt(k * k + pow(Expression(make_symbol("l")), 2));
  for (const Expression& f : {y * y / V, k * k / length}) {
    const Value value = program.lower(f);
    EXPECT_EQ(with_limits_at_roots(program, {value})[0].polynomial(), value.polynomial()) << f.to_string();
  }
  EXPECT_EQ(at(with_limits_at_roots(program, {program.lower(x * x / V)})[0], 0, 0), 0);
}

}  // namespace
}  // namespace torsor::limits_at_roots_test
