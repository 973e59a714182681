// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/abi/motion_call.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "generated/torque_free_body.hpp"

namespace motion_call_test {
namespace {

using namespace torsor::runtime;
using namespace torsor::runtime::abi;
using Body = torque_free_body::Mechanism<double>;
constexpr std::size_t n = coordinates_of<Body> + velocities_of<Body>;
using State = StateVector<Body>;

struct Moved {
  std::int64_t failed = 0;
  std::int32_t status = -1;
  std::array<State, 2> states{};
};

/// From 0 to 0.5 s, with the quaternion of the start as it is given.
Moved moved(const std::array<double, 4>& attitude, std::int32_t method) {
  State start = pack<Body>(initial_state_of<Body>(Body::precompute(Body::default_parameters())));
  for (std::size_t k = 0; k < 4; ++k) start[static_cast<std::size_t>(Body::quaternions[0]) + k] = attitude[k];
  for (std::size_t k = 0; k < 3; ++k) start[n - 3 + k] = 0.5 + 0.4 * static_cast<double>(k);
  const std::array<double, 2> times{0.0, 0.5};
  Moved result;
  torsor_motion call{};
  call.motions = call.threads = 1;
  call.method = method;
  call.step = 0.01;
  call.relative_tolerance = call.absolute_tolerance = 1e-10;
  call.start = {start.data(), sizeof(start), sizeof(double), 0};
  call.times = times.data();
  call.time_count = times.size();
  call.states = {result.states.data(), sizeof(result.states), sizeof(State), sizeof(double)};
  call.statuses = &result.status;
  result.failed = MotionCall<Body>(Body::default_parameters(), call)();
  return result;
}

// The kernels take its norm for 1: with another one they would give another motion, and energies of none.
TEST(MotionCall, GivesTheQuaternionOfTheStartItsNorm) {
  constexpr std::array<double, 4> unit{0.5, -0.5, 0.7, 0.1};
  for (const std::int32_t method : {0, 1, 2, 3, 4}) {
    const Moved expected = moved(unit, method);
    ASSERT_EQ(expected.status, torsor_motion_reached_end);
    for (const double size : {0x1p-1000, 0.5, 1.0 + 1e-6, 1.01, 0x1p1000}) {
      const Moved found = moved({unit[0] * size, unit[1] * size, unit[2] * size, unit[3] * size}, method);
      EXPECT_EQ(found.status, torsor_motion_reached_end);
      for (std::size_t k = 0; k < n; ++k) {
        EXPECT_NEAR(found.states[0][k], expected.states[0][k], 4e-16) << "size " << size << ", method " << method;
        EXPECT_NEAR(found.states[1][k], expected.states[1][k], 1e-13) << "size " << size << ", method " << method;
      }
    }
  }
}

TEST(MotionCall, LeavesANormOfOneWithinRoundings) {
  const std::array<double, 4> attitude{0.6, 0.0, 0.8000000000000002, 0.0};  // its square is 1 + 3.6e-16
  const Moved found = moved(attitude, 0);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(found.states[0][static_cast<std::size_t>(Body::quaternions[0]) + k], attitude[k]);
  }
}

TEST(MotionCall, SaysThatAQuaternionOfZerosIsNoAttitude) {
  const Moved found = moved({0.0, -0.0, 0.0, 0.0}, 0);
  EXPECT_EQ(found.failed, 1);
  EXPECT_EQ(found.status, torsor_motion_zero_quaternion);
  for (const State& state : found.states) {
    for (const double number : state) EXPECT_TRUE(std::isnan(number));
  }
  EXPECT_EQ(moved({std::nan(""), 0.0, 0.0, 0.0}, 0).status, torsor_motion_invalid_options);
}

}  // namespace
}  // namespace motion_call_test
