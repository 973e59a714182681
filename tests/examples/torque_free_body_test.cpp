// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/torque_free_body.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::torque_free_body_test {
namespace {

using namespace torsor::runtime;
using Body = torque_free_body::Mechanism<double>;
using State = StateVector<Body>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-14};

// The exact motion for moments 1, 2, 3 and w(0) = (1, 0, 1): w = (cn, sn, dn)(t | 1/3), the quaternion by 45-digit
// integration that keeps to it: (q0, q1, q2, q3, w1, w2, w3).
struct Exact {
  double time;
  std::array<const char*, 7> y;
};
constexpr std::array<Exact, 3> exact{{
    {1.0,
     {"0.779039602588222083294302712014", "0.358209265957277589992155218045", "0.195829970694799900486704543550",
      "0.475850861047037701774269624451", "0.577802471812079937363580884566", "0.816176637479810842829787597445",
      "0.882015815510536339758249550784"}},
    {10.0,
     {"0.861441174065477436952564492453", "0.107340757620159006299730429182", "0.220947321794367315503355867348",
      "-0.444498983542278055644230974623", "-0.921069998444332242515558387201", "0.389397044115331980202430138720",
      "0.974400660583082425017336221834"}},
    {100.0,
     {"-0.269809365972167636312279149149", "-0.0239624342082225162819584125933", "0.0880922371038113855433187706313",
      "0.958576270070649825692654472653", "-0.848467676551519475410339994405", "0.529247202965935502123348241277",
      "0.95217249805427130414690158576"}},
}};

// Both are right to 30 digits at the least.
TEST(TorqueFreeBody, HasACommittedReferenceThatAgreesWithTheExactMotionTo29Digits) {
  for (const Exact& at : {exact[0], exact[1]}) {
    const auto row = examples::reference_digits("torque_free_body", at.time == 1.0 ? "1" : "10");
    ASSERT_EQ(row.size(), 7U);
    for (std::size_t i = 0; i < 7; ++i) {
      examples::expect_digits(row[i], at.y[i], 2e-30, "component " + std::to_string(i));
    }
  }
}

// q and -q are the same orientation; here the sign is kept, too, because the motion is continuous.
TEST(TorqueFreeBody, MeetsTheExactMotionInDouble) {
  const auto motion = equations_of_motion<Body>();
  State y = motion.initial();
  double t = 0.0;
  examples::Amplification growth(motion, motion.initial(), 0.0);
  for (const Exact& at : exact) {
    const auto result = integrate(motion, y, t, at.time, precise);
    ASSERT_TRUE(result) << describe(result);
    t = at.time;
    // 2e-14 a step at the most, |y| being 1; they grow as one made at the start does.
    const double local = 2e-14 * static_cast<double>(result.statistics.accepted);
    const double allowed = local * growth.until(t);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(y[i], std::stod(at.y[i]), allowed) << i << " at " << t;
  }
}

// 4 K(1/3): the angular velocity comes back, the orientation does not.
TEST(TorqueFreeBody, HasThePeriodOfJacobisFunctions) {
  constexpr double period = 6.93566754103174010033968930267;
  const auto motion = equations_of_motion<Body>();
  const State y = examples::state_at(motion, motion.initial(), 0.0, period, precise);
  const State start = motion.initial();
  // 2e-14 at each of some 500 steps, growing by less than ten.
  for (std::size_t i = 4; i < 7; ++i) EXPECT_NEAR(y[i], start[i], 1e-10);
  EXPECT_GT(std::abs(y[0] - start[0]), 0.01);
}

// The moment of momentum is fixed in space: R J w = (1, 0, 3). It leaves the unit sphere of quaternions by no more than
// the errors of the steps.
TEST(TorqueFreeBody, KeepsItsMomentOfMomentumInSpace) {
  const auto motion = equations_of_motion<Body>();
  State y = motion.initial();
  double worst = 0.0, norm = 0.0;
  const auto result = integrate(motion, y, 0.0, 50.0, precise, [&](double t, const State& now) {
    const auto s = unpack<Body>(t, now);
    Body::Kinematics at{};
    Body::kinematics(motion.precomputed(), s, at);
    const std::array<double, 3> sigma{s.v.e_omega_x, 2.0 * s.v.e_omega_y, 3.0 * s.v.e_omega_z}, fixed{1.0, 0.0, 3.0};
    for (std::size_t i = 0; i < 3; ++i) {
      const double along =
          at.body_rotation[i] * sigma[0] + at.body_rotation[i + 3] * sigma[1] + at.body_rotation[i + 6] * sigma[2];
      worst = std::fmax(worst, std::abs(along - fixed[i]));
    }
    norm = std::fmax(norm, std::abs(std::hypot(std::hypot(now[0], now[1]), std::hypot(now[2], now[3])) - 1.0));
  });
  ASSERT_TRUE(result) << describe(result);
  const double local = 2e-14 * static_cast<double>(result.statistics.accepted);
  EXPECT_LE(worst, 10.0 * local);  // |sigma| is 3.2; an orientation wrong by e turns it by 2 e
  EXPECT_LE(norm, 2.0 * local);
}

// About the middle axis the body tumbles: the smallest disturbance grows and turns the axis over. Linearised, w1 and w3
// grow with sqrt((I2 - I1)(I3 - I2)/(I1 I3)) w2; about the others it stays.
TEST(TorqueFreeBody, TumblesAboutItsMiddleAxisOnly) {
  const auto motion = equations_of_motion<Body>();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    State y{1.0, 0.0, 0.0, 0.0, 1e-4, 1e-4, 1e-4};
    y[4 + axis] = 1.0;
    double least = 1.0;
    const auto result = integrate(motion, y, 0.0, 50.0, precise,
                                  [&](double, const State& now) { least = std::fmin(least, now[4 + axis]); });
    ASSERT_TRUE(result) << describe(result);
    if (axis == 1) {
      EXPECT_LT(least, -0.999);
    } else {
      EXPECT_GT(least, 0.999);
    }
  }
}

TEST(TorqueFreeBody, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Body>(equations_of_motion<Body>(), 50.0, 1e-13);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-7);
  EXPECT_EQ(balance.work, 0.0);
  Body::Energy energy{};
  Body::energy(Body::precompute(Body::default_parameters()), Body::initial_state(), {}, energy);
  EXPECT_DOUBLE_EQ(energy.kinetic, 2.0);
}

}  // namespace
}  // namespace torsor::torque_free_body_test
