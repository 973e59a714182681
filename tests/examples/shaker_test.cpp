// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/shaker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "generated/shaker_damped.hpp"
#include "generated/shaker_free_support.hpp"
#include "generated/shaker_from_mass.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

#include "torsor/generator/dynamics/theorems/force_function.hpp"
#include "torsor/generator/printing/force_function_text.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::shaker_test {
namespace {

using namespace torsor::runtime;
using Shaker = shaker::Mechanism<double>;
using FromMass = shaker_from_mass::Mechanism<double>;
using FreeSupport = shaker_free_support::Mechanism<double>;
using Damped = shaker_damped::Mechanism<double>;

// The values of the scenes.
constexpr double M = 1.0, k = 400.0, c = 4.0, l0 = 0.2, g = 9.81, h = 0.01, omega = 15.0, rounding = 1.1e-16;
constexpr double tolerance = 1e-13;
constexpr DormandPrince54 precise{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};

/// Of force-function --actions <actions> --bodies <bodies>: what is said after the generalised forces and the power.
std::string verdict(const torsor::Scene& scene, const torsor::ActionSelection& selection) {
  const std::string text = torsor::force_function_text(scene, selection);
  return text.substr(text.find('\n', text.find("  power = ")) + 1);
}

// The three cases of the course, each asked of the spring itself.
TEST(Shaker, HasAPotentialEnergySeenFromBothEnds) {
  EXPECT_EQ(verdict(shaker_scene(), {{"spring"}, {}}),
            "  potential energy\n"
            "  U = -1/2 k (x - l0)^2\n"
            "    U of the springs, attractions, given functions and weight\n");
}

TEST(Shaker, HasOnlyAForceFunctionSeenFromTheMass) {
  EXPECT_EQ(verdict(shaker_from_mass_scene(), {{"spring"}, {}}),
            "  force function without potential energy\n"
            "    Q_y changes with time at fixed coordinates, and all the power is sum Q_i q_i': nothing supplies "
            "dU/dt|explicit\n"
            "  U = -1/2 k (y - l0)^2 + k h y sin(omega t) - 1/2 k h^2 sin(omega t)^2 - k l0 h sin(omega t)\n"
            "    U of the springs, attractions, given functions and weight\n");
}

TEST(Shaker, HasNoForceFunctionSeenFromTheMassWhenItsSupportIsFree) {
  EXPECT_EQ(verdict(shaker_free_support_scene(), {{"spring"}, {"mass"}}),
            "  no force function\n"
            "    dQ_lambda/dl is not dQ_l/dlambda\n");
  // Both ends together have Q_lambda = 0 and a potential energy again.
  const torsor::Equations equations(shaker_free_support_scene());
  const auto both = torsor::classify_force_function(equations, {{"spring"}, {}});
  EXPECT_EQ(both.kind, torsor::ForceFunctionCase::potential_energy);
  EXPECT_TRUE(torsor::identically_zero(both.forces[0]));
  // Q_lambda = Q_l on the mass.
  const auto mass = torsor::classify_force_function(equations, {{"spring"}, {"mass"}});
  EXPECT_TRUE(torsor::identically_zero(mass.forces[0] - mass.forces[1]));
  EXPECT_TRUE(torsor::identically_zero(mass.forces[1] - both.forces[1]));
}

TEST(Shaker, HasNoForceFunctionWithTheDamper) {
  EXPECT_EQ(verdict(shaker_damped_scene(), {{"spring", "damper"}, {}}),
            "  no force function\n"
            "    Q_y depends on the velocity y'\n");
}

double support(double t) { return h * std::sin(omega * t); }
double support_rate(double t) { return h * omega * std::cos(omega * t); }

/// M y'' = -k (y - h sin(omega t) - l0) - M g from rest at l0 - M g/k: the height of the mass, and its rate.
std::array<double, 2> undamped(double t) {
  const double own = std::sqrt(k / M);
  const double forced = h * own * own / (own * own - omega * omega);
  return {l0 - M * g / k + forced * (std::sin(omega * t) - omega / own * std::sin(own * t)),
          forced * omega * (std::cos(omega * t) - std::cos(own * t))};
}

// A linear oscillator amplifies local errors by at most 20 (positions of rates and back); some 3000 steps of 1e-13
// err by 6e-9 if all alike, 1e-10 as a random walk with its factor of 20.
TEST(Shaker, MovesAsTheForcedOscillatorInBothCoordinates) {
  for (const double t : {0.3, 1.0, 2.0, 5.0}) {
    const auto [y, rate] = undamped(t);
    const auto motion = equations_of_motion<Shaker>();
    const auto relative = examples::state_at(motion, motion.initial(), 0.0, t, precise);
    EXPECT_NEAR(relative[0] + support(t), y, 1e-10);
    EXPECT_NEAR(relative[1] + support_rate(t), rate, 2e-9);
    const auto alone = equations_of_motion<FromMass>();
    const auto absolute = examples::state_at(alone, alone.initial(), 0.0, t, precise);
    EXPECT_NEAR(absolute[0], y, 1e-10);
    EXPECT_NEAR(absolute[1], rate, 2e-9);
  }
}

// The centre of mass is thrown upwards, l oscillates about l0 at sqrt(k (1/M + 1/m_T)) = 23 rad/s. Tolerances as above.
TEST(Shaker, MovesAsTwoMassesOnASpringWhenItsSupportIsFree) {
  constexpr double m_T = 3.0, start = 0.22, speed = 5.0, share = M / (M + m_T);
  const double own = std::sqrt(k * (1.0 / M + 1.0 / m_T));
  const auto motion = equations_of_motion<FreeSupport>();
  for (const double t : {0.1, 0.5, 1.0, 2.0}) {
    const auto y = examples::state_at(motion, motion.initial(), 0.0, t, precise);
    const double stretch = (start - l0) * std::cos(own * t), rate = -(start - l0) * own * std::sin(own * t);
    EXPECT_NEAR(y[1], l0 + stretch, 1e-10);
    EXPECT_NEAR(y[3], rate, 2.3e-9);
    EXPECT_NEAR(y[0], speed * t - g * t * t / 2 - share * (l0 + stretch - start), 1e-10);
    EXPECT_NEAR(y[2], speed - g * t - share * rate, 2.3e-9);
  }
}

// With the damper, after 16 s (the start has died out to exp(-32) = 1e-14): the real and imaginary part of the
// response.
TEST(Shaker, SettlesToTheForcedResponseWithTheDamper) {
  using namespace std::complex_literals;
  for (const double frequency : {5.0, 15.0, 20.0, 40.0}) {
    const auto motion = equations_of_motion<Damped>({.c = c, .omega = frequency});
    const double t = 16.0;
    const auto y = examples::state_at(motion, motion.initial(), 0.0, t, precise);
    const std::complex<double> response = h * (k + 1i * c * frequency) /
                                          (k - M * frequency * frequency + 1i * c * frequency) *
                                          std::exp(1i * frequency * t);
    EXPECT_NEAR(y[0], l0 - M * g / k + response.imag(), 1e-10) << frequency;
    EXPECT_NEAR(y[1], frequency * response.real(), 2e-9) << frequency;
  }
}

// The spring and the weight have a potential energy: T + Ep gains what the shaker gives, its force times its velocity.
TEST(Shaker, SuppliesWhatKineticAndPotentialEnergyGain) {
  const auto motion = equations_of_motion<Shaker>();
  const auto balance =
      examples::energy_balance<Shaker>(motion, 3.0, tolerance, [&](const auto& state, const auto& a, const auto& none) {
        Shaker::Reactions reactions{};
        Shaker::reactions(motion.precomputed(), state, a, none, {}, reactions);
        // The force is that of Newton's law for the mass.
        const double lift = M * (a.x - omega * omega * support(state.time) + g);
        EXPECT_NEAR(reactions.drive, lift, 20 * 100 * rounding);
        return reactions.drive * support_rate(state.time);
      });
  examples::expect_kept(balance, 0.1);
  EXPECT_GT(balance.work, 0.1);
}

// Seen from the mass alone, U is no potential energy: T - U gains -dU/dt at constant y, the power of nothing on the
// mass.
TEST(Shaker, LeavesTMinusUByTheExplicitRateOfUSeenFromTheMass) {
  const auto balance = examples::energy_balance<FromMass>(
      equations_of_motion<FromMass>(), 3.0, tolerance, [](const auto& state, const auto&, const auto&) {
        return -k * (state.q.y - support(state.time) - l0) * support_rate(state.time);
      });
  examples::expect_kept(balance, 0.1);
  EXPECT_GT(balance.work, 0.1);
}

// The force is dU/dy of the whole square: at a random state, and not the derivative of -k (y - ...)/2.
TEST(Shaker, PullsTheMassByTheDerivativeOfTheSquare) {
  FromMass::State state{};
  state.time = 0.7;
  state.q.y = 0.31;
  FromMass::GeneralizedForces bias{};
  FromMass::bias(FromMass::precompute(FromMass::default_parameters()), state, bias);
  EXPECT_NEAR(bias.y, k * (0.31 - support(0.7) - l0) + M * g, 10 * 100 * rounding);
}

TEST(Shaker, LosesToTheDamperWhatItsOwnWorkDoesNotCover) {
  const auto balance = examples::energy_balance<Damped>(
      equations_of_motion<Damped>(), 3.0, tolerance,
      [](const auto& state, const auto& a, const auto&) { return M * (a.y + g) * support_rate(state.time); });
  examples::expect_kept(balance, 0.01);
  EXPECT_GT(balance.work, 0.01);
}

TEST(Shaker, KeepsItsEnergyWhenItsSupportIsFree) {
  const auto balance = examples::energy_balance<FreeSupport>(equations_of_motion<FreeSupport>(), 2.0, tolerance);
  examples::expect_kept(balance, 1.0);
  EXPECT_EQ(balance.work, 0.0);
}

TEST(Shaker, MeetsItsCommittedReferences) {
  const auto meets = [](const auto& motion, const std::string& name) {
    examples::expect_reference(motion, name, {.error = 1e-12, .least_amplification = 1.0});
  };
  meets(equations_of_motion<Shaker>(), "shaker");
  meets(equations_of_motion<FromMass>(), "shaker_from_mass");
  meets(equations_of_motion<FreeSupport>(), "shaker_free_support");
  meets(equations_of_motion<Damped>(), "shaker_damped");
}

}  // namespace
}  // namespace torsor::shaker_test
