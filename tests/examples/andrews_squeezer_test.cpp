// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/andrews_squeezer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/small_motions/equilibrium_stability.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::andrews_squeezer_test {
namespace {

using namespace torsor::runtime;
using torsor::Real;
using Squeezer = andrews_squeezer::Mechanism<double>;
using State = StateVector<Squeezer>;

constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

// At t = 0.03: beta, Theta, gamma, Phi, delta, Omega, epsilon and their rates, to 24 digits and more from two
// derivations (the published equations in quadruple precision, and the bodies' kinematics in 40 digits).
constexpr std::array<const char*, 14> at_003{
    "15.8107711951537070971193873",   "-15.7563710584118394697277528", "0.0408222401196458048582823196",
    "-0.534730116342079593770185031", "0.524409965879954069371655800", "0.534730116342079593770185031",
    "1.04808074104193787306851547",   "1139.92030225910606419809685",  "-1424.37929517754007319602644",
    "11.0329119106185937453273113",   "19.2933741050320408316275568",  "0.573569914829502453817687862",
    "-19.2933741050320408316275568",  "0.323179149249130874990748391"};

/// As the IVP Test Set prints them, from a run in 1e-14.
constexpr std::array<double, 14> printed{
    15.81077119629904,  -15.75637105984298, 0.04082224013073101, -0.5347301163226948, 0.5244099658805304,
    0.5347301163226948, 1.048080741042263,  1139.920302151208,   -1424.379294994111,  11.03291221937134,
    19.29337464421385,  0.5735699284790808, -19.29337464421385,  0.3231791658026955};

State motion_at(double t) {
  const auto motion = equations_of_motion<Squeezer>();
  return examples::state_at(motion, motion.initial(), 0.0, t, precise);
}

TEST(AndrewsSqueezer, HasACommittedReferenceThatAgreesWithTheRecomputedMotion) {
  const auto row = examples::reference_digits("andrews_squeezer", "0.03");
  ASSERT_EQ(row.size(), at_003.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    // Half a unit of the 24th digit.
    examples::expect_digits(row[i], at_003[i], 5e-24 * std::abs(std::stod(at_003[i])) + 1e-27, std::to_string(i));
  }
}

// The printed values are right to 1e-10 in the large ones, some 3e-10 in gamma and 5.1e-8 in the small rates.
TEST(AndrewsSqueezer, AgreesWithThePrintedValuesAsFarAsTheyGo) {
  const auto row = examples::reference_digits("andrews_squeezer", "0.03");
  ASSERT_EQ(row.size(), printed.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool small_rate = i >= 9, small_angle = i >= 2 && i < 7;
    const double tolerance = small_rate ? 5.2e-8 : small_angle ? 3e-10 : 2e-10;
    EXPECT_NEAR(row[i].to_double(), printed[i], tolerance * std::abs(printed[i])) << i;
  }
}

// Published and recomputed to 30 digits; their multipliers have the opposite sign (M q'' = f - G' lambda).
TEST(AndrewsSqueezer, StartsWithThePublishedAccelerationsAndMultipliers) {
  const auto motion = equations_of_motion<Squeezer>();
  Squeezer::Accelerations a{};
  Squeezer::Multipliers lambda{};
  ASSERT_EQ(motion.accelerations(Squeezer::initial_state(), a, lambda), Evaluation::ok);
  // Rounding of the angles alone moves the loops by 1e-17 m of 1e-2, and what balances at rest by 1e-13.
  EXPECT_NEAR(a.beta, 14222.44391995411387, 1e-12 * 14222);
  EXPECT_NEAR(a.Theta, -10666.83293996558540, 1e-12 * 10667);
  for (const double other : {a.gamma, a.Phi, a.delta, a.Omega, a.epsilon}) EXPECT_NEAR(other, 0.0, 1e-8);
  EXPECT_NEAR(lambda[0], -98.56687039624108961, 1e-10);
  EXPECT_NEAR(lambda[1], 6.122688344255662655, 1e-10);
  for (int j = 2; j < 6; ++j) EXPECT_NEAR(lambda[j], 0.0, 1e-10);
}

TEST(AndrewsSqueezer, MovesAsRecomputedInDouble) {
  const auto motion = equations_of_motion<Squeezer>();
  const double allowed = 1e-13 * examples::amplification(motion, motion.initial(), 0.0, 0.03);
  const State y = motion_at(0.03);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double expected = std::stod(at_003[i]);
    EXPECT_NEAR(y[i], expected, 100 * allowed * (1 + std::abs(expected))) << i;
    EXPECT_NEAR(y[i], expected, 1e-8 * (1 + std::abs(expected))) << i;
  }
  Squeezer::Accelerations a{};
  Squeezer::Multipliers lambda{};
  ASSERT_EQ(motion.accelerations(unpack<Squeezer>(0.03, y), a, lambda), Evaluation::ok);
  EXPECT_NEAR(a.beta, -24631.7631228746344700507956, 1e-7 * 24632);
  EXPECT_NEAR(a.Theta, 51850.3196364642315337540007, 1e-7 * 51850);
  constexpr std::array<double, 6> theirs{199.175348104538628186, -29.7553099749717633244, 23.0665436111221511286,
                                         31.4527252757711370754, 22.6424947863943785777,  11.6173923526112559068};
  for (int j = 0; j < 6; ++j) EXPECT_NEAR(lambda[j], -theirs[static_cast<std::size_t>(j)], 1e-7 * 199) << j;

  const auto later = unpack<Squeezer>(0.05, motion_at(0.05));
  EXPECT_NEAR(later.q.beta, 33.8258677669545173322721512, 1e-8 * 34);
  EXPECT_NEAR(later.q.Theta, -33.5834315174638684983794688, 1e-8 * 34);
  EXPECT_NEAR(later.q.gamma, 0.113395073812599015025277873, 1e-8);
  EXPECT_NEAR(later.q.Phi, -0.407852865601884442493055245, 1e-8);
  EXPECT_NEAR(later.q.delta, 0.526060444916995827132740555, 1e-8);
  EXPECT_NEAR(later.q.epsilon, 1.05690242943496283098682483, 1e-8);
  EXPECT_NEAR(later.v.beta, 1144.53550265384746840333518, 1e-8 * 1145);
  Squeezer::Kinematics places{};
  Squeezer::kinematics(motion.precomputed(), later, places);
  EXPECT_NEAR(places.F_position[0], -0.00520850472229671997568071770, 1e-10);
  EXPECT_NEAR(places.F_position[1], 0.00467669526031072158493879744, 1e-10);
}

// Nothing pulls the loops back: what a step leaves open in the velocities opens them further. Over the whole run it
// stays a hundred thousand times below the accuracy asked for.
TEST(AndrewsSqueezer, KeepsItsLoopsClosed) {
  const auto motion = equations_of_motion<Squeezer>();
  Squeezer::Constraints loops{};
  Squeezer::constraints(motion.precomputed(), unpack<Squeezer>(0.05, motion_at(0.05)), loops);
  for (const double gap : loops.value) EXPECT_NEAR(gap, 0.0, 1e-11);
  for (const double rate : loops.rate) EXPECT_NEAR(rate, 0.0, 1e-8);
}

TEST(AndrewsSqueezer, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Squeezer>(equations_of_motion<Squeezer>(), 0.03, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-7);
  // The torque alone: M (beta - beta_0).
  EXPECT_NEAR(balance.work, 0.033 * (15.8107711951537070971 + 0.06171389001427644796), 1e-8);
}

// One freedom left of seven: beta, which the scene wants.
TEST(AndrewsSqueezer, IsLinearisedInItsOneFreedom) {
  static_assert(Squeezer::independent_coordinate_count == 1 && Squeezer::independent_coordinates[0] == 0);
  const auto motion = equations_of_motion<Squeezer>();
  Squeezer::Accelerations a{};
  Squeezer::Multipliers lambda{};
  const auto start = Squeezer::initial_state();
  ASSERT_EQ(motion.accelerations(start, a, lambda), Evaluation::ok);
  Squeezer::Linearisation linear{};
  ASSERT_EQ(Squeezer::linearisation(motion.precomputed(), start, a, lambda, {}, linear), torsor::Status::ok);
  // The torque is all that works on beta at rest: beta'' = M / M_r.
  EXPECT_NEAR(linear.M_r[0], 0.033 / 14222.44391995411387, 1e-12 * linear.M_r[0]);
  EXPECT_NEAR(linear.F_r[0], 0.0, 1e-12);
}

// While it moves as well: x' = A x of the kernel is M x'' + C x' + K x = 0 of the one freedom.
TEST(AndrewsSqueezer, IsLinearisedWhileItMoves) {
  const auto motion = equations_of_motion<Squeezer>();
  FoundState<Squeezer> s{unpack<Squeezer>(0.03, motion_at(0.03))};
  ASSERT_EQ(motion.accelerations(s.state, s.accelerations, s.multipliers), Evaluation::ok);
  const LinearSystem small = linearised_at<Squeezer>(motion.precomputed(), s);
  ASSERT_EQ(small.size(), 1);
  Squeezer::Linearisation linear{};
  ASSERT_EQ(Squeezer::linearisation(motion.precomputed(), s.state, s.accelerations, s.multipliers, {}, linear),
            torsor::Status::ok);
  const Eigen::MatrixXd A = state_matrix(linear);
  // The coordinate's own rate, and what either form divides by M: a rounding or two.
  EXPECT_EQ(A(0, 0), 0.0);
  EXPECT_EQ(A(0, 1), 1.0);
  EXPECT_NEAR(A(1, 0), -small.K(0, 0) / small.M(0, 0), 1e-15 * std::abs(A(1, 0)));
  EXPECT_NEAR(A(1, 1), -small.C(0, 0) / small.M(0, 0), 1e-15 * std::abs(A(1, 1)));
  EXPECT_GT(std::abs(A(1, 1)), 1.0);  // it does move: a linkage at rest has no such term
}

}  // namespace
}  // namespace torsor::andrews_squeezer_test
