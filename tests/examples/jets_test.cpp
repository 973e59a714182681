// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel `jets` of committed headers: its Taylor polynomials lead to the committed references, which come from
// Lagrange's operator and an extrapolation in high precision.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <string>

#include "generated/double_pendulum.hpp"
#include "generated/heavy_top.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/torque_free_body.hpp"
#include "torsor/runtime/batch/simd.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::examples_jets_test {
namespace {

using namespace torsor::runtime;

template <std::size_t size, std::size_t count>
std::array<double, size> value_at(const std::array<std::array<double, size>, count>& c, std::size_t order, double h) {
  std::array<double, size> y = c[order];
  for (std::size_t k = order; k-- > 0;) {
    for (std::size_t i = 0; i < size; ++i) y[i] = y[i] * h + c[k][i];
  }
  return y;
}

/// Steps of one length, short enough that the last term is far below a rounding.
template <class Mechanism>
void expect_led_to_reference(const std::string& name, double step, std::size_t order) {
  constexpr std::size_t n = coordinates_of<Mechanism> + velocities_of<Mechanism>;
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/" + name + ".reference.csv");
  const auto motion = equations_of_motion<Mechanism>();
  const double end = reference.times[0];
  const auto steps = static_cast<int>(std::ceil(end / step));
  const double h = (end - motion.initial_time()) / steps;
  auto y = motion.initial();
  double size = 1.0, last = 0.0;
  std::array<StateVector<Mechanism>, jet_order_max + 1> c;
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(motion.jets(motion.initial_time() + i * h, y, std::span(c).first(order + 1)), Evaluation::ok);
    ASSERT_EQ(c[0], y);
    for (const double each : c[order]) last = std::fmax(last, std::abs(each) * std::pow(h, static_cast<double>(order)));
    y = value_at(c, order, h);
    for (const double each : y) size = std::fmax(size, std::abs(each));
  }
  EXPECT_LT(last, 1e-16 * size) << name;
  // Some ten roundings a step, each amplified as the flow amplifies from the start.
  const double kappa = std::fmax(1.0, examples::amplification(motion, motion.initial(), 0.0, end));
  const double allowed = 10 * steps * 0x1p-53 * size * kappa;
  EXPECT_LE(examples::largest_difference(y, reference.template state<n>(0)), allowed) << name;
  EXPECT_LT(allowed, 1e-9 * size) << name << ": a bound that says little";
}

TEST(Jets, LeadTheDoublePendulumToItsReference) {
  expect_led_to_reference<double_pendulum::Mechanism<double>>("double_pendulum", 0.004, 20);
}
TEST(Jets, LeadTheHeavyTopToItsReference) {
  expect_led_to_reference<heavy_top::Mechanism<double>>("heavy_top", 0.0005, 15);
}
TEST(Jets, LeadTheRollingHoopToItsReferenceThroughItsMultipliers) {
  expect_led_to_reference<rolling_hoop::Mechanism<double>>("rolling_hoop", 0.02, 20);
}
TEST(Jets, LeadTheTorqueFreeBodyToItsReferenceByItsQuaternion) {
  expect_led_to_reference<torque_free_body::Mechanism<double>>("torque_free_body", 0.02, 20);
}

TEST(Jets, BeginWithTheRatesOfForwardDynamics) {
  const auto motion = equations_of_motion<rolling_hoop::Mechanism<double>>();
  const auto y = motion.initial();
  std::array<StateVector<rolling_hoop::Mechanism<double>>, 2> c;
  std::array<double, 10> rates{};
  ASSERT_EQ(motion.jets(0.0, y, c), Evaluation::ok);
  ASSERT_EQ(motion(0.0, y, rates), Evaluation::ok);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(c[1][i], rates[i], 1e-14 * (1 + std::abs(rates[i]))) << i;
}

// More orders than the kernel keeps room for are refused; the state alone is an order too.
TEST(Jets, OfTheRuntimeHaveOrdersFrom0To30) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  const auto y = motion.initial();
  std::array<StateVector<double_pendulum::Mechanism<double>>, 32> c{};
  EXPECT_EQ(motion.jets(0.0, y, c), Evaluation::not_finite);
  EXPECT_EQ(motion.jets(0.0, y, std::span(c).first(31)), Evaluation::ok);
  c[0] = {};
  EXPECT_EQ(motion.jets(0.0, y, std::span(c).first(1)), Evaluation::ok);
  EXPECT_EQ(c[0], y);
}

TEST(Jets, ReportStatesThatAreNotFinite) {
  const auto motion = equations_of_motion<double_pendulum::Mechanism<double>>();
  auto y = motion.initial();
  std::array<StateVector<double_pendulum::Mechanism<double>>, 11> c;
  y[2] = 1e200;  // its square is not finite
  EXPECT_EQ(motion.jets(0.0, y, c), Evaluation::not_finite);
  y[2] = std::nan("");
  EXPECT_EQ(motion.jets(0.0, y, c), Evaluation::not_finite);
}

// A trajectory in each lane: the same operations lane by lane.
TEST(Jets, RunOnPacksOfStates) {
  using Pack = Simd<double, 4>;
  using Single = double_pendulum::Mechanism<double>;
  using Several = double_pendulum::Mechanism<Pack>;
  constexpr int order = 12;
  Several::State states = Several::initial_state();
  std::array<Single::State, 4> each;
  for (int lane = 0; lane < 4; ++lane) {
    each[static_cast<std::size_t>(lane)] = Single::initial_state();
    for (int i = 0; i < 2; ++i) {
      Single::State& state = each[static_cast<std::size_t>(lane)];
      state.q[i] = 0.3 * lane - 0.5 * i;
      state.v[i] = 0.7 - 0.4 * lane * i;
      states.q[i].set(lane, state.q[i]);
      states.v[i].set(lane, state.v[i]);
    }
  }
  std::array<std::array<Pack, 4>, order + 1> packed;
  ASSERT_EQ(Several::jets(Several::precompute({}), states, {}, order, packed.data()), torsor::Status::ok);
  for (int lane = 0; lane < 4; ++lane) {
    std::array<std::array<double, 4>, order + 1> c;
    ASSERT_EQ(Single::jets(Single::precompute({}), each[static_cast<std::size_t>(lane)], {}, order, c.data()),
              torsor::Status::ok);
    for (std::size_t k = 0; k <= order; ++k) {
      // Where one is compiled with fused multiply-adds and the other without they differ by roundings: some ten an
      // order.
      double size = 0;
      for (const double value : c[k]) size = std::fmax(size, std::abs(value));
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(packed[k][i][lane], c[k][i], 10.0 * static_cast<double>(k) * 0x1p-53 * size) << k << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace torsor::examples_jets_test
