// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/orientation.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/geometry/dyad.hpp"
#include "torsor/generator/geometry/quaternion.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::orientation_test {
namespace {

using namespace testing_symbols;

bool all_zero(const Matrix& m) {
  for (int i = 0; i < 3; ++i) {
    if (!identically_zero(Vector(m(i, 0), m(i, 1), m(i, 2)))) return false;
  }
  return true;
}

/// A 3 x 3 array of numbers with rotations written out, sharing nothing with the program.
struct RealMatrix {
  std::array<std::array<Real, 3>, 3> m;

  static RealMatrix about(int axis, const Real& angle) {
    RealMatrix r{};
    const auto i = static_cast<std::size_t>(axis);
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    r.m[i][i] = Real(1);
    r.m[j][j] = r.m[k][k] = cos(angle);
    r.m[k][j] = sin(angle);
    r.m[j][k] = -sin(angle);
    return r;
  }
  friend RealMatrix operator*(const RealMatrix& a, const RealMatrix& b) {
    RealMatrix product{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t k = 0; k < 3; ++k) product.m[i][j] += a.m[i][k] * b.m[k][j];
      }
    }
    return product;
  }
};

class Orientation : public ::testing::Test {
 protected:
  Orientation() {
    psi = program.lower(first.q);
    theta = program.lower(second.q);
    phi = program.lower(third.q);
  }

  /// A unit vector that moves: (sinθ cosψ, sinθ sinψ, cosθ).
  Vector moving_axis() {
    const Value sine = program.sin(theta);
    const Value x = sine * program.cos(psi);
    const Value y = sine * program.sin(psi);
    return {x, y, program.cos(theta)};
  }

  /// dR/dt = Ω∧ R, with Ω along the axes that do not turn.
  void expect_turns_with(const Matrix& rotation, const Vector& omega) {
    for (int j = 0; j < 3; ++j) {
      const Vector e(rotation(0, j), rotation(1, j), rotation(2, j));
      const Vector moved = time_derivative(e);
      EXPECT_TRUE(identically_zero(moved - cross(omega, e))) << "axis " << j;
    }
    EXPECT_TRUE(identically_zero(angular_velocity(rotation) - omega));
  }

  /// Every entry within 1e-47 of the composition of `turns` at 50 digits: entries are at most 1 and come from some
  /// twenty roundings of 1e-50.
  void expect_composed(const Matrix& rotation, const std::vector<std::pair<int, Real>>& turns) {
    RealMatrix composed = RealMatrix::about(0, Real(0));
    for (const auto& [axis, angle] : turns) composed = composed * RealMatrix::about(axis, angle);
    Evaluator<Real> evaluate(program, at(point));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Real gap =
            evaluate(rotation(i, j)) - composed.m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        EXPECT_LT(abs(gap).to_double(), 1e-47) << i << j;
      }
    }
  }

  const WorkingDigits precision{50};
  Program program;
  TestCoordinate first{"psi"}, second{"theta"}, third{"phi"};
  Value psi, theta, phi;
  Point point{{"psi", rational(7, 5)}, {"theta", rational(-4, 3)}, {"phi", rational(23, 9)}};
};

using AxisAngleForm = Orientation;
using EulerAngles = Orientation;
using CardanAngles = Orientation;
using QuaternionForm = Orientation;
using GeometricClosure = Orientation;

TEST_F(Orientation, TurnsAboutAnAxisAsTheExactRotationDoes) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = -5; k < 24; k += 7) {
      const Value angle = program.lower(Expression(k) * pi() / Expression(12));
      EXPECT_TRUE(all_zero(rotation_matrix(program, PlaneRotation{axis, angle}) -
                         constant_matrix(program, Rotation::about(axis, k))));
    }
  }
  EXPECT_EQ(error_of<SceneError>([&] {
              rotation_matrix(program, PlaneRotation{3, psi});
            }),
            "axis 3 of a plane rotation does not exist: use 0, 1 or 2 for x, y or z");
}

TEST_F(EulerAngles, AreThreePlaneRotationsAboutZXZ) {
  const Matrix r = rotation_matrix(program, euler(psi, theta, phi));
  expect_composed(r, {{2, point["psi"]}, {0, point["theta"]}, {2, point["phi"]}});
  // The turned z axis: (sinψ sinθ, −cosψ sinθ, cosθ); the node line is x of the first intermediate base.
  EXPECT_TRUE(identically_zero(r(0, 2) - program.sin(psi) * program.sin(theta)));
  EXPECT_TRUE(identically_zero(r(1, 2) + program.cos(psi) * program.sin(theta)));
  EXPECT_TRUE(identically_zero(r(2, 2) - program.cos(theta)));
}

TEST_F(EulerAngles, TurnWithPrecessionNutationAndOwnRotation) {
  const std::vector<PlaneRotation> sequence = euler(psi, theta, phi);
  const Matrix r = rotation_matrix(program, sequence);
  const Vector omega = angular_velocity(program, sequence);
  expect_turns_with(r, omega);
  // Ω = ψ' z + θ' u + φ' Z with u the node line, in the fixed axes.
  const Value rate = program.symbol(third.v);
  const Value nutation = program.symbol(second.v);
  Vector closed;
  closed[0] = nutation * program.cos(psi) + rate * r(0, 2);
  closed[1] = nutation * program.sin(psi) + rate * r(1, 2);
  closed[2] = program.symbol(first.v) + rate * r(2, 2);
  EXPECT_TRUE(identically_zero(closed - omega));
}

TEST_F(CardanAngles, AreThreePlaneRotationsAboutXYZ) {
  const std::vector<PlaneRotation> sequence = cardan(psi, theta, phi);
  const Matrix r = rotation_matrix(program, sequence);
  expect_composed(r, {{0, point["psi"]}, {1, point["theta"]}, {2, point["phi"]}});
  expect_turns_with(r, angular_velocity(program, sequence));
}

/// The first intermediate base of Cardan's angles is (x2 = x1, y2, z2); the course prints z2 = z1.
TEST_F(CardanAngles, KeepTheFirstAxisAndNotTheThirdInTheirFirstBase) {
  const std::vector<PlaneRotation> first_only{cardan(psi, theta, phi)[0]};
  const Matrix r = rotation_matrix(program, first_only);
  const Matrix one = identity(program);
  const auto moved = [&](int axis) {
    return Vector(r(0, axis) - one(0, axis), r(1, axis) - one(1, axis), r(2, axis) - one(2, axis));
  };
  EXPECT_TRUE(identically_zero(moved(0)));
  EXPECT_FALSE(identically_zero(moved(2)));
}

TEST_F(Orientation, ComposesAnySequence) {
  const std::vector<PlaneRotation> sequence{{1, psi}, {2, Number(2) * theta}, {1, phi}, {0, psi}, {2, phi - theta}};
  const Matrix r = rotation_matrix(program, sequence);
  const Real two_theta = Real(2) * point["theta"];
  const Real difference = point["phi"] - point["theta"];
  expect_composed(r, {{1, point["psi"]}, {2, two_theta}, {1, point["phi"]}, {0, point["psi"]}, {2, difference}});
  expect_turns_with(r, angular_velocity(program, sequence));
  EXPECT_TRUE(all_zero(rotation_matrix(program, std::vector<PlaneRotation>{}) - identity(program)));
  EXPECT_TRUE(identically_zero(angular_velocity(program, std::vector<PlaneRotation>{})));
}

TEST_F(AxisAngleForm, IsTheTurnAboutZCarriedToTheAxis) {
  const Matrix r = rotation_matrix(program, AxisAngle{moving_axis(), phi});
  expect_composed(
      r, {{2, point["psi"]}, {1, point["theta"]}, {2, point["phi"]}, {1, -point["theta"]}, {2, -point["psi"]}});
  EXPECT_TRUE(identically_zero(r * moving_axis() - moving_axis()));
}

TEST_F(AxisAngleForm, TurnsFasterThanItsAngleWhenTheAxisMoves) {
  const AxisAngle turn{moving_axis(), phi};
  const Vector omega = angular_velocity(program, turn);
  expect_turns_with(rotation_matrix(program, turn), omega);
  EXPECT_FALSE(identically_zero(omega - program.symbol(third.v) * turn.axis));
  const Vector fixed(program.number(Number::rational(2, 3)), program.number(Number::rational(-1, 3)),
                     program.number(Number::rational(2, 3)));
  EXPECT_TRUE(identically_zero(angular_velocity(program, AxisAngle{fixed, phi}) - program.symbol(third.v) * fixed));
}

TEST_F(AxisAngleForm, NeedsAUnitVector) {
  const Vector skew(program.number(Number(1)), program.number(Number(2)), Value());
  const std::string message =
      "the axis (1, 2, 0) of a rotation has the square 5 and must be a unit vector: divide it by its length";
  EXPECT_EQ(error_of<SceneError>([&] { rotation_matrix(program, AxisAngle{skew, phi}); }), message);
  EXPECT_EQ(error_of<SceneError>([&] { angular_velocity(program, AxisAngle{skew, phi}); }), message);
  EXPECT_EQ(error_of<SceneError>([&] { quaternion(program, AxisAngle{skew, phi}); }), message);
}

TEST_F(QuaternionForm, IsTheSameRotationAsItsAxisAndAngle) {
  const AxisAngle turn{moving_axis(), phi};
  const Quaternion p = quaternion(program, turn);
  EXPECT_TRUE(all_zero(rotation_matrix(program, p) - rotation_matrix(program, turn)));
  EXPECT_TRUE(identically_zero(squared_norm(p) - program.number(Number(1))));
  EXPECT_TRUE(all_zero(rotation_matrix(program, Quaternion{-p.scalar, -p.vector}) - rotation_matrix(program, p)));
  EXPECT_TRUE(all_zero(rotation_matrix(program, conjugate(p)) - transpose(rotation_matrix(program, p))));
}

TEST_F(QuaternionForm, ComposesLikePlaneRotations) {
  const std::vector<PlaneRotation> sequence{{0, theta}, {2, psi}, {1, phi}, {2, theta}};
  const Quaternion p = quaternion(program, sequence);
  expect_composed(rotation_matrix(program, p),
                  {{0, point["theta"]}, {2, point["psi"]}, {1, point["phi"]}, {2, point["theta"]}});
}

TEST_F(QuaternionForm, HasTheAngularVelocityOfItsSequence) {
  const std::vector<PlaneRotation> sequence = euler(psi, theta, phi);
  const Quaternion p = quaternion(program, sequence);
  const Vector omega = bound(program, angular_velocity(p));
  EXPECT_TRUE(identically_zero(omega - angular_velocity(program, sequence)));
  expect_turns_with(rotation_matrix(program, p), omega);
  const Quaternion rate = rate_of_turn(p, omega);  // and the way back
  EXPECT_TRUE(identically_zero(rate.scalar - time_derivative(p.scalar)));
  EXPECT_TRUE(identically_zero(rate.vector - time_derivative(p.vector)));
}

/// Four coordinates of their own: the norm's rate is p·p', which the rates of an angular velocity make null.
TEST_F(QuaternionForm, KeepsItsNormUnderAnyAngularVelocity) {
  const auto symbol = [&](const char* name) { return program.lower(make_symbol(name)); };
  const Quaternion p{symbol("p0"), {symbol("p1"), symbol("p2"), symbol("p3")}};
  const Vector omega(symbol("wx"), symbol("wy"), symbol("wz"));
  const Quaternion rate = rate_of_turn(p, omega);
  const Value scalar = p.scalar * rate.scalar;
  EXPECT_TRUE(identically_zero(scalar + dot(p.vector, rate.vector)));
  EXPECT_FALSE(identically_zero(scalar));
}

/// P(b_j/b_i) takes components along b_i to components along b_j. Around a loop of bases
/// P(b1/bn) P(bn/bn−1) … P(b2/b1) = 1; the course prints P(b1/bn−1) as the second factor.
TEST_F(GeometricClosure, MultipliesTheChangesOfBaseFromTheLastToTheFirst) {
  const Matrix r12 = rotation_matrix(program, euler(psi, theta, phi));
  const Matrix r23 = rotation_matrix(program, cardan(theta, phi, psi));
  const Matrix r34 = rotation_matrix(program, AxisAngle{moving_axis(), phi});
  const Matrix r14 = bound(program, bound(program, r12 * r23) * r34);
  const Matrix p21 = transpose(r12);
  const Matrix p32 = transpose(r23);
  const Matrix p43 = transpose(r34);
  const Matrix& p14 = r14;
  const Matrix half = bound(program, p32 * p21);
  const Matrix loop = bound(program, p14 * bound(program, p43 * half));
  EXPECT_TRUE(all_zero(loop - identity(program)));
  const Matrix p13 = bound(program, r12 * r23);
  EXPECT_FALSE(all_zero(bound(program, p14 * bound(program, p13 * half)) - identity(program)));
  const Matrix other_way = bound(program, p21 * p32);
  EXPECT_FALSE(all_zero(bound(program, other_way * bound(program, p43 * p14)) - identity(program)));
}

}  // namespace
}  // namespace torsor::orientation_test
