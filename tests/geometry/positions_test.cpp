// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/positions.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/geometry/vector.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::positions_test {
namespace {

using namespace testing_symbols;

class Positions : public ::testing::Test {
 protected:
  /// Σ c_i e_i: components along the local base, seen along x, y, z.
  Vector in_fixed_axes(const LocalPosition& position, const Triple& components) {
    Vector sum;
    for (std::size_t i = 0; i < 3; ++i) {
      const Value component = program.lower(components[i]);
      sum += component * lower(program, position.base[i]);
    }
    return sum;
  }

  void expect_derivatives_of_position(const LocalPosition& position) {
    const Vector place = bound(program, lower(program, position.position));
    const Vector velocity = bound(program, time_derivative(place));
    EXPECT_TRUE(identically_zero(in_fixed_axes(position, position.velocity) - velocity));
    EXPECT_TRUE(identically_zero(in_fixed_axes(position, position.acceleration) - time_derivative(velocity)));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector e = lower(program, position.base[i]);
      const Vector next = lower(program, position.base[(i + 1) % 3]);
      const Vector last = lower(program, position.base[(i + 2) % 3]);
      EXPECT_TRUE(identically_zero(cross(e, next) - last)) << "the local base is direct";
      EXPECT_TRUE(identically_zero(dot(e, e) - program.number(Number(1))));
    }
  }

  Program program;
  TestCoordinate first{"first", units::metre}, second{"second"}, third{"third"};
  TestCoordinate y{"y", units::metre}, z{"z", units::metre};
  Expression q1{first.q}, q2{second.q}, q3{third.q};
};

TEST_F(Positions, HaveTheDerivativesOfTheirCartesianComponents) {
  expect_derivatives_of_position(cartesian(q1, Expression(y.q), Expression(z.q)));
  expect_derivatives_of_position(cylindrical(q1, q2, Expression(z.q)));
  expect_derivatives_of_position(spherical(q1, q2, q3));
}

TEST_F(Positions, MayFollowLawsOfTime) {
  const auto t = std::make_shared<const Symbol>(Symbol{"t", units::second, SymbolKind::time, 0, nullptr});
  const Expression speed(make_symbol("w", "rad/s"));
  expect_derivatives_of_position(spherical(q1, speed * Expression(t), sin(speed * Expression(t))));
}

TEST_F(Positions, LieWhereTheAnglesSay) {
  // θ = 90°, φ = 30°: ρ (0, sin 30°, cos 30°).
  const LocalPosition at = spherical(Expression::quantity("2", "m"), pi() / Expression(2), pi() / Expression(6));
  EXPECT_TRUE(lower(program, at.position)[0].is_zero());
  EXPECT_TRUE(program.lower(at.position[1]).is_number(1));
  EXPECT_EQ(program.lower(at.position[2]).polynomial().constant(), Number::from_parts(0, 0, 1, 0));
}

/// The course prints ρ' w + ρ sinφ θ' v − ρ sinφ φ' z: without the part of φ' along u.
TEST_F(Positions, DisagreeWithThePrintedSphericalVelocity) {
  const LocalPosition position = spherical(q1, q2, q3);
  const Vector velocity = bound(program, time_derivative(bound(program, lower(program, position.position))));
  const Triple without_phi{0, position.velocity[1], position.velocity[2]};
  const Expression turning = q1 * rate(q3);
  const Vector common = in_fixed_axes(position, without_phi);
  const Vector printed = common + lower(program, {0, 0, -turning * sin(q3)});
  EXPECT_FALSE(identically_zero(printed - velocity));
  const Expression missing = turning * cos(q3);
  const Vector right = printed + lower(program, {missing * cos(q2), missing * sin(q2), 0});
  EXPECT_TRUE(identically_zero(right - velocity));
}

}  // namespace
}  // namespace torsor::positions_test
