// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/regime_enumeration.hpp"

namespace contact_problem_test {
namespace {

using namespace torsor::runtime;

// One contact in space, rows N, T1, T2, from a program of forty digits that scanned every direction of slip.
struct Known {
  double friction;
  std::array<double, 3> q;
  ContactRegime regime;
  std::array<double, 3> r, u;
};
const Known known[] = {
    {0.5, {1, 0.2, -0.3}, ContactRegime::open, {0, 0, 0}, {1, 0.2, -0.3}},
    {0.9,
     {-1, 0.2, -0.3},
     ContactRegime::sticks,
     {0.5294076800222206791195056, -0.1414485105201027706409277, 0.1638080688841052704673287},
     {0, 0, 0}},
    {0.2,
     {-1, 1.5, -0.7},
     ContactRegime::slides,
     {0.516185910802316578469763, -0.09288974072907394969, 0.04504899385910972033},
     {0, 1.394206148597117012605342, -0.6761520027240869369017213}},
    {0.05,
     {-2, -0.4, 0.3},
     ContactRegime::slides,
     {0.9943752385990176102131502, 0.02276477281817568365648015, -0.04420090956512074476755465},
     {0, -0.05107347379181596387363632, 0.09916611135456665052239}},
};

ContactProblem in_space() {
  ContactProblem problem;
  problem.count = 1;
  problem.W.resize(3, 3);
  problem.W << 2, 0.3, -0.1, 0.3, 3, 0.4, -0.1, 0.4, 2.5;
  problem.q.resize(3);
  return problem;
}

TEST(OneContact, HasTheReactionOfCoulombsDisc) {
  for (const Known& k : known) {
    ContactProblem problem = in_space();
    problem.laws[0] = coulomb(2, k.friction);
    for (int i = 0; i < 3; ++i) problem.q(i) = k.q[static_cast<std::size_t>(i)];
    const auto answer = solve_contacts(problem);
    ASSERT_EQ(answer.verdict, ContactVerdict::unique);
    EXPECT_EQ(answer.best().regimes[0], k.regime);
    for (int i = 0; i < 3; ++i) {
      // The condition of W is below 2, the equations are three: some roundings of numbers up to 2.
      EXPECT_NEAR(answer.best().r(i), k.r[static_cast<std::size_t>(i)], 2e-15);
      EXPECT_NEAR(answer.best().u(i), k.u[static_cast<std::size_t>(i)], 4e-15);
    }
    EXPECT_LE(answer.best().residual, 1e-14);
  }
}

TEST(OneContact, SaysThatForcesOfPainleveDoNotExistOrAreTwo) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = coulomb(1, 1.5);
  problem.laws[0].slips = true;  // to the positive side
  problem.W.resize(2, 2);
  problem.W << 1, 0.9, 0.9, 1;
  problem.q.resize(2);
  problem.q << -1, 0;
  EXPECT_EQ(solve_contacts(problem).verdict, ContactVerdict::none);
  problem.q << 1, 0;
  const auto two = solve_contacts(problem);
  ASSERT_EQ(two.verdict, ContactVerdict::several);
  ASSERT_EQ(two.count, 2U);
  EXPECT_EQ(two.solutions[0].r(0), 0.0);
  EXPECT_NEAR(two.solutions[1].r(0), 1 / 0.35, 4e-15);  // 1 - 1.5 * 0.9 loses two bits
  // The impulses that start from that slip exist.
  problem.laws[0].slips = false;
  problem.q << -1, 1;
  EXPECT_TRUE(solve_contacts(problem));
}

// A contact without a solution beside one that has one, three times: sweeps come to a stop, which is seen at once. A thousand
// million attempts would take days.
TEST(ManyContacts, SayWithoutEndlessSweepsThatThereIsNoSolution) {
  ContactProblem problem;
  problem.count = 6;
  problem.W = ContactMatrix::Identity(12, 12);
  problem.q = ContactVector::Zero(12);
  for (int i = 0; i < problem.count; ++i) {
    problem.laws[static_cast<std::size_t>(i)] = coulomb(1, 1.5);
    problem.laws[static_cast<std::size_t>(i)].slips = i % 2 == 0;
    problem.q(2 * i) = -1;
    problem.q(2 * i + 1) = 0.3 * i;
    if (i % 2 == 0) problem.W(2 * i, 2 * i + 1) = problem.W(2 * i + 1, 2 * i) = 0.9;
  }
  constexpr ContactSolverOptions patient{.attempts = 1'000'000'000};
  EXPECT_EQ(solve_contacts(problem, patient).verdict, ContactVerdict::none);
  // Sweeps look for one, and prove nothing.
  EXPECT_EQ(iterate_contacts(problem, ContactVector::Zero(12), patient).verdict, ContactVerdict::not_found);
  EXPECT_EQ(iterate_contacts(problem, ContactVector::Ones(12), patient).verdict, ContactVerdict::not_found);
  for (int i = 0; i < problem.count; ++i) problem.laws[static_cast<std::size_t>(i)].slips = false;
  EXPECT_TRUE(iterate_contacts(problem, ContactVector::Zero(12), patient));
}

TEST(OneContact, StartsToSlideByTheLesserCoefficientAndSaysThatItCouldStick) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = {.tangents = 1, .friction = 0.2, .static_friction = 0.5};
  problem.W = Eigen::Matrix2d::Identity();
  problem.q.resize(2);
  problem.q << -1, 0.4;  // N = 1; sticks with T = -0.4, or slides with T = -0.2
  const auto answer = solve_contacts(problem);
  ASSERT_EQ(answer.verdict, ContactVerdict::several);
  EXPECT_EQ(answer.best().regimes[0], ContactRegime::sticks);  // rest persists
  EXPECT_NEAR(answer.solutions[1].u(1), 0.2, 1e-15);
  problem.q << -1, 0.6;
  const auto slides = solve_contacts(problem);
  ASSERT_EQ(slides.verdict, ContactVerdict::unique);
  EXPECT_NEAR(slides.best().r(1), -0.2, 1e-15);
}

// A box rests on its lower corners. That is its only motion: from rest a'Ma <= a'F, a power of weight, and no corner may sink.
// Slips of zero are at the edge of their cones there; reactions that would turn some against their direction are no others.
TEST(BoxAtRest, HasOneMotionAndManyReactions) {
  constexpr double a = 0.2, b = 0.15, c = 0.1, mass = 2, weight = mass * 9.81;
  const Eigen::DiagonalMatrix<double, 6> inverse(
      Eigen::Vector<double, 6>{1, 1, 1, 3 / (b * b + c * c), 3 / (a * a + c * c), 3 / (a * a + b * b)} / mass);
  for (const double friction : {0.1, 0.3, 1.0}) {
    SCOPED_TRACE(friction);
    ContactProblem problem;
    problem.count = 4;
    Eigen::Matrix<double, 12, 6> J;
    for (int k = 0; k < 4; ++k) {
      const double x = k < 2 ? -a : a, y = k % 2 == 0 ? -b : b;
      J.middleRows<3>(3 * k) << 0, 0, 1, y, -x, 0,  // up, along x, along y at (x, y, -c)
          1, 0, 0, 0, -c, -y,                       //
          0, 1, 0, c, 0, x;
      problem.laws[static_cast<std::size_t>(k)] = {.tangents = 2, .friction = friction, .static_friction = friction};
    }
    problem.W = J * inverse * J.transpose();
    problem.q = J * inverse * Eigen::Vector<double, 6>{0, 0, -weight, 0, 0, 0};
    const ContactAnswer answer = solve_contacts(problem);
    EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
    EXPECT_LE(answer.best().u.norm(), 1e-15);
    const Eigen::Vector4d N{answer.best().r(0), answer.best().r(3), answer.best().r(6), answer.best().r(9)};
    EXPECT_NEAR(N.sum(), weight, 1e-13);
    EXPECT_GT(N.minCoeff(), weight / 40);  // inside its bounds by a tenth of the largest, which is a quarter at least
  }
}

// A box that lands flat stops where impulses within their cones can stop it: those are drawn, and q = -W r is what they stop.
TEST(BoxThatLands, StopsWhereImpulsesCanStopIt) {
  constexpr double a = 0.15, b = 0.1, c = 0.05, friction = 0.8;
  const Eigen::DiagonalMatrix<double, 6> inverse(
      Eigen::Vector<double, 6>{1, 1, 1, 3 / (b * b + c * c), 3 / (a * a + c * c), 3 / (a * a + b * b)});
  std::mt19937 source(1);
  std::uniform_real_distribution<double> part(0, 1);
  for (int draw = 0; draw < 500; ++draw) {
    SCOPED_TRACE(draw);
    ContactProblem problem;
    problem.count = 4;
    Eigen::Matrix<double, 12, 6> J;
    Eigen::Vector<double, 12> r;
    RegimeSystem::Regimes sticking{};
    for (int k = 0; k < 4; ++k) {
      const double x = k < 2 ? -a : a, y = k % 2 == 0 ? -b : b, N = part(source), angle = 7 * part(source);
      const double T = 0.9 * friction * N * part(source);
      J.middleRows<3>(3 * k) << 0, 0, 1, y, -x, 0, 1, 0, 0, 0, -c, -y, 0, 1, 0, c, 0, x;
      r.segment<3>(3 * k) << N, T * std::cos(angle), T * std::sin(angle);
      problem.laws[static_cast<std::size_t>(k)] = coulomb(2, friction);
      sticking[static_cast<std::size_t>(k)] = {.pressed = true, .friction = AssumedRegime::Friction::sticks};
    }
    problem.W = J * inverse * J.transpose();
    problem.q = -problem.W * r;
    RegimeEnumeration regimes(problem);
    ASSERT_TRUE(regimes.try_from(sticking));
    const ContactAnswer answer = regimes.finish();
    EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
    EXPECT_EQ(answer.best().u.norm(), 0);
    EXPECT_LE(answer.best().residual, 1e-13);
  }
}

TEST(OneContact, OfDryFrictionAloneIsBoundedByItsForce) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = {.normal = false, .tangents = 1, .bound = 0.8, .static_bound = 0.8};
  problem.W.resize(1, 1);
  problem.W << 2;
  problem.q.resize(1);
  for (const double q : {-3.0, -1.6, -1.0, 0.0, 1.0, 1.6, 3.0}) {
    problem.q << q;
    const auto answer = solve_contacts(problem);
    ASSERT_EQ(answer.verdict, ContactVerdict::unique) << q;
    EXPECT_NEAR(answer.best().r(0), std::abs(q) <= 1.6 ? -q / 2 : std::copysign(0.8, -q), 1e-15);
  }
}

// A block on a cart that slides on whatever the block does: pulled by 9.5 N it needs 4.75 N of 6 N to rest on the cart.
TEST(ManyContacts, StickWhereTheyCanWhileOthersSlide) {
  ContactProblem problem;
  problem.count = 2;
  problem.laws[0] = {.normal = false, .tangents = 1, .bound = 0.5, .static_bound = 0.5, .slips = true};
  problem.laws[1] = {.normal = false, .tangents = 1, .bound = 4, .static_bound = 6};
  problem.W = (Eigen::Matrix2d() << 1, -1, -1, 2).finished();  // q = (x, u), both masses 1 kg
  problem.q = Eigen::Vector2d(0, 9.5);
  const ContactAnswer answer = solve_contacts(problem);
  ASSERT_EQ(answer.verdict, ContactVerdict::several);
  EXPECT_EQ(answer.solutions[0].regimes[1], ContactRegime::sticks);
  EXPECT_NEAR(answer.solutions[0].u(0), (9.5 - 0.5) / 2, 1e-12);
  EXPECT_NEAR(answer.solutions[0].r(1), -(9.5 + 0.5) / 2, 1e-12);
}

// A plank on three supports in the plane, of which two would do: forces are one freedom too many.
TEST(ManySupports, LeaveReactionsIndeterminate) {
  ContactProblem problem;
  problem.count = 3;
  Eigen::Matrix<double, 3, 2> J;
  J << 1, -1, 1, 0, 1, 1;  // height and turn
  problem.laws.fill(coulomb(0, 0));
  problem.W = J * J.transpose();
  problem.q = J * Eigen::Vector2d(-1, 0);
  const auto answer = solve_contacts(problem);
  ASSERT_EQ(answer.verdict, ContactVerdict::indeterminate);
  EXPECT_NEAR(answer.best().r.sum(), 1, 1e-15);  // the weight
  for (int i = 0; i < 3; ++i) EXPECT_GE(answer.best().r(i), 0.0);
  EXPECT_LE(answer.best().residual, 1e-15);
}

// Beyond six contacts no regime is guessed: a row of masses on a floor, pulled aside by forces that some withstand.
TEST(ManyContacts, AreSolvedByIteration) {
  constexpr int n = 12;
  ContactProblem problem;
  problem.count = n;
  problem.W = Eigen::MatrixXd::Identity(2 * n, 2 * n);
  problem.q.resize(2 * n);
  for (int i = 0; i < n; ++i) {
    problem.laws[static_cast<std::size_t>(i)] = coulomb(1, 0.5);
    if (i > 0) problem.W(2 * i, 2 * i - 2) = problem.W(2 * i - 2, 2 * i) = 0.25;
    problem.q.segment<2>(2 * i) << (i % 4 == 3 ? 1.0 : -1.0), 0.1 * i;
  }
  const auto answer = solve_contacts(problem);
  ASSERT_TRUE(answer);
  EXPECT_LE(answer.best().residual, 1e-14);
  EXPECT_EQ(answer.best().regimes[0], ContactRegime::sticks);
  EXPECT_EQ(answer.best().regimes[3], ContactRegime::open);
  EXPECT_EQ(answer.best().regimes[10], ContactRegime::slides);
}

}  // namespace
}  // namespace contact_problem_test
