// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/told_motion.hpp"

// Friction of joints in proportion to what they transmit.
namespace joint_friction_test {
namespace {

using namespace told_motion;

/// θ'² at θ after a start from rest at θ0, as it swings to the side s: with sin φ = h the line of R touches a circle of
/// radius h, so that θ'' = -g sin θ - s tan φ (θ'² + g cos θ), linear in θ'².
double square_of_rate(double theta, double start, double s, double h) {
  const double a = s * std::tan(std::asin(h)), A = 2 * g * (1 - 2 * a * a) / (1 + 4 * a * a), B = -6 * a * g / (1 + 4 * a * a);
  const auto forced = [&](double at) { return A * std::cos(at) + B * std::sin(at); };
  return forced(theta) - forced(start) * std::exp(-2 * a * (theta - start));
}

double turning_point(double start, double s, double h) {
  double moving = start + s * 1e-3, stopped = -start * 1.0001;
  for (int i = 0; i < 200; ++i) {
    const double middle = (moving + stopped) / 2;
    (square_of_rate(middle, start, s, h) > 0 ? moving : stopped) = middle;
  }
  return (moving + stopped) / 2;
}

TEST(FrictionOfAJournal, TurnsAPendulumWhereItsCircleOfFrictionSays) {
  const double h = 0.08;
  std::array<double, 2> y{1.2, 0};
  const Motion motion = move(pendulum_in_a_journal(h), y, 20);
  const auto stops = motion.all(ContactEventKind::slip_ends);
  double from = 1.2, s = -1;
  std::size_t count = 0;
  // It stays where the weight alone, whose line passes within the circle, cannot move it: |sin θ| <= h.
  for (; std::abs(std::sin(from)) > h; ++count, s = -s) {
    from = turning_point(from, s, h);
    ASSERT_LT(count, stops.size());
    EXPECT_NEAR(stops[count].state[0], from, 1e-12);
  }
  EXPECT_EQ(stops.size(), count);
  EXPECT_GE(count, 3U);
  EXPECT_EQ(stops.back().regime, ContactRegime::sticks);
  EXPECT_EQ(y[1], 0.0);
}

TEST(FrictionOfAJournal, HoldsAPendulumUpToItsCircleOfFriction) {
  const double h = 0.3;
  for (const double part : {0.999999, 1.000001}) {
    std::array<double, 2> y{std::asin(h) * part, 0};
    const auto start = y;
    move(pendulum_in_a_journal(h), y, 0.5);
    EXPECT_EQ(y == start, part < 1);
  }
}

// Steps of first order: the error falls as the step does.
TEST(FrictionOfAJournal, MovesByStepsAsFromEventToEvent) {
  std::array<double, 2> exact{1.2, 0};
  ASSERT_TRUE(integrate_contacts(pendulum_in_a_journal(0.2), exact, 0, 0.9, precise));
  const auto error = [&](long steps) {
    std::array<double, 2> y{1.2, 0};
    EXPECT_EQ(step_contacts(pendulum_in_a_journal(0.2), y, 0, 0.9, {.count = steps}), ContactStatus::reached_end);
    return std::hypot(y[0] - exact[0], y[1] - exact[1]);
  };
  const double coarse = error(900), fine = error(3600);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, coarse / 2);
}

/// The same with a stop at θ = 0, which is a couple and does not press the journal.
ByHand<1, 1, 2> that_strikes(double h, double e) {
  return {{ContactRule{.tangents = 0, .restitution = e},
           ContactRule{.tangents = 1, .normal = false, .bearing = 2, .friction = h}},
          [](double, const auto& y, auto& r) {
            r.M(0, 0) = 1;
            r.F(0) = -g * std::sin(y[0]);
            r.gap[0] = y[0];
            r.J << 1, 1;
            r.w << y[1], y[1];
            r.drift.setZero();
            r.B << 0, 1;
            r.C.setZero();
            r.R0 << y[1] * y[1] + g * std::cos(y[0]), g * std::sin(y[0]);
          }};
}

// The journal transmits the change of momentum, (1 + e) |w|, and its impulse opposes the slip after the impact.
TEST(FrictionOfAJournal, TakesItsShareOfAnImpact) {
  const double h = 0.2, e = 0.5;
  std::array<double, 2> y{0.8, 0};
  std::vector<double> impulses;
  double before = 0;
  const auto watch = [&](const ContactEvent& event) {
    if (event.kind != ContactEventKind::impact) return true;
    before = event.before[1];
    impulses.assign(event.impulses.data(), event.impulses.data() + event.impulses.size());
    return false;
  };
  static_cast<void>(integrate_contacts(that_strikes(h, e), y, 0, 5, precise, {}, watch));
  ASSERT_EQ(impulses.size(), 2U);
  const double change = -(1 + e) * before;
  EXPECT_NEAR(y[1], -e * before, 1e-13);
  EXPECT_NEAR(impulses[1], -h * change, 1e-13);
  EXPECT_NEAR(impulses[0], change * (1 + h), 1e-13);
}

/// A slider of mass m on a level guide that rubs in proportion to its reaction N, with a rod of length 1 m and a mass of 1 kg at
/// its end, and a lift of p t: q = (x, θ), θ from below.
ByHand<2, 2, 1> slider_with_pendulum(double m, double f, double p) {
  return {{ContactRule{.tangents = 1, .normal = false, .bearing = 1, .friction = f}}, [=](double t, const auto& y, auto& r) {
            const double s = std::sin(y[1]), c = std::cos(y[1]), square = y[3] * y[3];
            r.M << m + 1, c, c, 1;
            r.F << s * square, -g * s;
            r.gap[0] = 0;
            r.J << 1, 0;
            r.w << y[2];
            r.drift.setZero();
            r.B << 0, s;
            r.C.setZero();
            r.R0 << (m + 1) * g + c * square - p * t;
          }};
}

// N = N0 + n T with T = -f |N|: where f n > 1 and N0 comes to zero from above, no N is left. The integrator's steps shrink there,
// and said that the integration had failed.
TEST(FrictionOfAGuide, EndsWhereItsReactionComesToZero) {
  const double m = 0.1, f = 1, p = 60;
  std::array<double, 4> y{0, 3.05, 20, -0.5};
  const ContactResult result = integrate_contacts(slider_with_pendulum(m, f, p), y, 0, 5, precise);
  EXPECT_EQ(result.status, ContactStatus::no_solution);
  EXPECT_EQ(result.contact, 0);
  EXPECT_GT(y[2], 0.1) << "it still slides to the side 1";
  const double s = std::sin(y[1]), c = std::cos(y[1]), both = m + s * s, square = y[3] * y[3];
  const double n = -s * c / both, pressed = (m + 1) * g + c * square - p * result.time;
  const double N0 = pressed - s * s * g - s * c * s * (square + g * c) / both;
  EXPECT_GT(f * n, 1.1);
  EXPECT_NEAR(N0, 0, 1e-8 * m * g);
}

// Where f n < 1 the reaction only turns round.
TEST(FrictionOfAGuide, GoesOnWhereItsReactionTurnsRound) {
  std::array<double, 4> y{0, 3.05, 20, -0.5};
  const ContactResult result = integrate_contacts(slider_with_pendulum(0.1, 0.4, 60), y, 0, 0.2, precise);
  EXPECT_EQ(result.status, ContactStatus::reached_end);
}

/// |T| = f |c + s T| of a joint that slides to the side 1, with u = T + q.
ContactProblem pressed(double f, double s, double c) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = {.normal = false, .bearing = 1, .tangents = 1, .friction = f, .static_friction = f};
  problem.W.setConstant(1, 1, 1);
  problem.q.setConstant(1, 0.0);
  problem.S.setConstant(1, 1, s);
  problem.c.setConstant(1, c);
  return problem;
}

TEST(FrictionOfAGuide, HasTheForceThatItsOwnReactionAllows) {
  ContactProblem problem = pressed(0.5, 0.4, 3);
  problem.q(0) = 5;  // T = -0.5 (3 + 0.4 T)
  const ContactAnswer answer = solve_contacts(problem);
  ASSERT_EQ(answer.verdict, ContactVerdict::unique);
  EXPECT_EQ(answer.best().regimes[0], ContactRegime::slides);
  EXPECT_NEAR(answer.best().r(0), -1.5 / 1.2, 1e-15);
  EXPECT_LE(answer.best().residual, 1e-15);
  problem.q(0) = 1;  // T = -1 holds it: 0.5 (3 - 0.4) is more
  const ContactAnswer rest = solve_contacts(problem);
  ASSERT_EQ(rest.verdict, ContactVerdict::unique);
  EXPECT_EQ(rest.best().regimes[0], ContactRegime::sticks);
  EXPECT_NEAR(rest.best().r(0), -1, 1e-15);
}

// While it slides to the side 1 the force t = -T has t = f |c - s t|: two solutions where f s > 1, none where f s < -1.
TEST(FrictionOfAGuide, MayHaveTwoForcesOrNone) {
  ContactProblem two = pressed(0.5, 4, 3);
  two.laws[0].slips = true;
  two.q(0) = -10;
  const ContactAnswer both = solve_contacts(two);
  EXPECT_EQ(both.verdict, ContactVerdict::several);
  ASSERT_EQ(both.count, 2U);
  EXPECT_NEAR(both.solutions[0].r(0) + both.solutions[1].r(0), -0.5 - 1.5, 1e-14);
  ContactProblem none = pressed(0.5, -4, 3);
  none.laws[0].slips = true;
  EXPECT_EQ(solve_contacts(none).verdict, ContactVerdict::none);
}

// R = (1 - 1.8 t, 1.6 t) with t = |T|: t = 0.5 |R| means 4 t² = 1 - 3.6 t + 5.8 t², so that t is 1/3 or 5/3.
TEST(FrictionOfAGuide, MayHaveTwoForcesAcrossTwoDirections) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = {.normal = false, .bearing = 2, .tangents = 1, .friction = 0.5, .static_friction = 0.5, .slips = true};
  problem.W.setConstant(1, 1, 1);
  problem.q.setConstant(1, -10.0);
  problem.S.resize(2, 1);
  problem.S << 1.8, -1.6;
  problem.c.resize(2);
  problem.c << 1, 0;
  const ContactAnswer both = solve_contacts(problem);
  ASSERT_EQ(both.count, 2U);
  // The derivative of t - 0.5 |R| at the zeros is ±0.8 and more: 4 roundings of R.
  EXPECT_NEAR(std::min(-both.solutions[0].r(0), -both.solutions[1].r(0)), 1.0 / 3, 1e-15);
  EXPECT_NEAR(std::max(-both.solutions[0].r(0), -both.solutions[1].r(0)), 5.0 / 3, 3e-15);
}

/// A contact and joints that slide to the side 1, with rows of their own but one W, as of a ladder whose guide rubs.
ContactProblem with_a_contact(std::mt19937& random, int joints, int bearing) {
  const auto number = [&random](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  ContactProblem problem;
  problem.count = 1 + joints;
  const int rows = 2 + joints;
  Eigen::MatrixXd J = Eigen::MatrixXd::NullaryExpr(rows, rows + 1, [&] { return number(-1, 1); });
  problem.W = J * J.transpose();
  problem.q = Eigen::VectorXd::NullaryExpr(rows, [&] { return number(-3, 3); });
  problem.S = Eigen::MatrixXd::NullaryExpr(joints * bearing, rows, [&] { return number(-2, 2); });
  problem.c = Eigen::VectorXd::NullaryExpr(joints * bearing, [&] { return number(-2, 2); });
  const double f = number(0, 1.5);
  problem.laws[0] = {.tangents = 1, .friction = f, .static_friction = f, .slips = true};
  for (std::size_t i = 1; i <= static_cast<std::size_t>(joints); ++i) {
    const double g = number(0.1, 2);
    problem.laws[i] = {.normal = false, .bearing = bearing, .tangents = 1, .friction = g, .static_friction = g, .slips = true};
  }
  return problem;
}

/// How many motions fulfil the laws, every sign of every R tried; nothing where a number is so small that rounding may tell.
std::optional<std::size_t> motions_by_hand(const ContactProblem& problem) {
  const int joints = problem.count - 1, rows = 2 + joints;
  std::size_t count = 0;
  for (int open = 0; open < 2; ++open) {
    for (int signs = 0; signs < 1 << joints; ++signs) {
      Eigen::MatrixXd B = Eigen::MatrixXd::Zero(rows, 1 + joints);  // r = B (N, |T_1|, ...)
      B(0, 0) = 1;
      B(1, 0) = -problem.law(0).friction;
      for (int k = 0; k < joints; ++k) B(2 + k, 1 + k) = -1;
      Eigen::MatrixXd A(1 + joints, 1 + joints);
      Eigen::VectorXd b(1 + joints);
      A.row(0) = Eigen::RowVectorXd::Unit(1 + joints, 0);
      if (open == 0) A.row(0) = problem.W.row(0) * B;
      b(0) = open != 0 ? 0 : -problem.q(0);
      for (int k = 0; k < joints; ++k) {
        const double e = (signs >> k & 1) != 0 ? -1 : 1, f = problem.law(1 + k).friction;
        A.row(1 + k) = -f * e * problem.S.row(k) * B;
        A(1 + k, 1 + k) += 1;
        b(1 + k) = f * e * problem.c(k);
      }
      const Eigen::VectorXd x = A.fullPivLu().solve(b), u = problem.W * (B * x) + problem.q;
      double least = open != 0 ? u(0) : x(0);
      for (int k = 0; k < joints; ++k) least = std::min(least, x(1 + k));
      if (std::abs(least) < 1e-6 || x.cwiseAbs().maxCoeff() > 1e3) return std::nullopt;
      if (least > 0) ++count;
    }
  }
  return count;
}

/// The same of one journal: R = R_0 + R_1 t, where t = |T| solves t^2 = f^2 |R|^2.
std::optional<std::size_t> motions_of_a_journal(const ContactProblem& problem) {
  const double f = problem.law(1).friction;
  std::size_t count = 0;
  for (int open = 0; open < 2; ++open) {
    const Eigen::Vector3d of_N(1, -problem.law(0).friction, 0), of_t(0, 0, -1);
    const Eigen::RowVector3d row = problem.W.row(0);
    const double N_0 = open != 0 ? 0 : -problem.q(0) / row.dot(of_N), N_1 = open != 0 ? 0 : -row.dot(of_t) / row.dot(of_N);
    const Eigen::Vector2d R_0 = problem.S * of_N * N_0 + problem.c, R_1 = problem.S * (of_N * N_1 + of_t);
    const double a = 1 - f * f * R_1.squaredNorm(), b = -f * f * R_0.dot(R_1), c = -f * f * R_0.squaredNorm();
    const double root = b * b - a * c;
    if (std::abs(root) < 1e-6 || std::abs(a) < 1e-3) return std::nullopt;
    for (const double sign : {1.0, -1.0}) {
      const double t = (-b + sign * std::sqrt(root)) / a, N = N_0 + N_1 * t;
      if (root < 0 || t < 0) continue;
      const double least = open != 0 ? problem.W.row(0).dot(of_t) * t + problem.q(0) : N;
      if (std::abs(least) < 1e-6 || t < 1e-6 || t > 1e3) return std::nullopt;
      if (least > 0) ++count;
    }
  }
  return count;
}

void expect_all(unsigned seed, int joints, int bearing, std::optional<std::size_t> (*motions)(const ContactProblem&)) {
  std::mt19937 random(seed);
  std::array<int, 3> seen{};
  for (int k = 0; k < 300; ++k) {
    const ContactProblem problem = with_a_contact(random, joints, bearing);
    const std::optional<std::size_t> count = motions(problem);
    if (!count) continue;
    const ContactAnswer answer = solve_contacts(problem);
    EXPECT_EQ(answer.count, *count) << k;
    const ContactVerdict some = *count == 1 ? ContactVerdict::unique : ContactVerdict::several;
    EXPECT_EQ(answer.verdict, *count == 0 ? ContactVerdict::none : some) << k;
    ++seen[std::min<std::size_t>(*count, 2)];
  }
  for (const int each : seen) EXPECT_GT(each, 20);
}

// A reaction that turns round by the force of a contact was not found where the joint's own friction does not turn it.
TEST(FrictionOfAGuide, HasAllTheForcesThatAContactAllows) {
  expect_all(20, 1, 1, motions_by_hand);
  expect_all(21, 2, 1, motions_by_hand);
}

TEST(FrictionOfAJournal, HasAllTheForcesThatAContactAllows) { expect_all(22, 1, 2, motions_of_a_journal); }

/// A contact and a joint that rub and can hold two freedoms by reactions that are well inside their bounds.
ContactProblem that_can_rest(std::mt19937& random, int bearing) {
  const auto number = [&random](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const double f = number(0.2, 1.5), g = number(0.1, 1.5), N = number(0.5, 3), R = number(0.5, 5), angle = number(0, 6.28);
  ContactProblem problem;
  problem.count = 2;
  const Eigen::MatrixXd J = Eigen::MatrixXd::NullaryExpr(3, 2, [&] { return number(-1, 1); });
  const Eigen::Vector3d r(N, number(-0.8, 0.8) * f * N, number(-0.8, 0.8) * g * R);
  problem.W = J * J.transpose();
  problem.q = -problem.W * r;
  problem.S = Eigen::MatrixXd::NullaryExpr(bearing, 3, [&] { return number(-2, 2); });
  Eigen::VectorXd reaction(bearing);
  reaction(0) = bearing == 1 ? (angle < 3.14 ? R : -R) : R * std::cos(angle);
  if (bearing == 2) reaction(1) = R * std::sin(angle);
  problem.c = reaction - problem.S * r;
  problem.laws[0] = {.tangents = 1, .friction = f, .static_friction = f};
  problem.laws[1] = {.normal = false, .bearing = bearing, .tangents = 1, .friction = g, .static_friction = g};
  return problem;
}

// Reactions of both signs may hold it, with none in between.
TEST(FrictionOfAGuide, HoldsWhereAContactPressesItEitherWay) {
  std::mt19937 random(23);
  for (int k = 0; k < 400; ++k) {
    const ContactProblem problem = that_can_rest(random, 1 + k % 2);
    const ContactAnswer answer = solve_contacts(problem);
    ASSERT_TRUE(answer) << k;
    EXPECT_LE(answer.best().u.cwiseAbs().maxCoeff(), 1e-9) << k;
    EXPECT_LE(answer.best().residual, 1e-12) << k;
  }
}

// Two joints that balance each other: R of the second is zero, which rounding gives any direction.
TEST(FrictionOfSeveralJoints, IsNoneWhereTheReactionIsZero) {
  for (int k = 0; k < 200; ++k) {
    const double f = 0.1 + 0.002 * k, s = 0.9 - 0.003 * k, t = f * (1 + 0.1 * k);
    ContactProblem problem;
    problem.count = 2;
    problem.W.resize(2, 2);
    problem.W << 1, 0, 0, 1;
    problem.q.resize(2);
    problem.q << 50, 50;
    problem.S.resize(2, 2);
    problem.S << 0, 0, s, 0.3;
    problem.c.resize(2);
    problem.c << 1 + 0.1 * k, s * t;  // R of the first is 1 + 0.1 k, so that its T is -t
    for (std::size_t i = 0; i < 2; ++i) {
      problem.laws[i] = {.normal = false, .bearing = 1, .tangents = 1, .friction = f, .static_friction = f};
    }
    const ContactAnswer answer = solve_contacts(problem);
    ASSERT_TRUE(answer) << k;
    EXPECT_NEAR(answer.best().r(0), -t, 4e-15 * (1 + t)) << k;
    EXPECT_NEAR(answer.best().r(1), 0, 1e-14 * (1 + t)) << k;
  }
}

// A stop presses a guide, in units of mass that make W and S as far apart as numbers of a mechanism may be.
TEST(FrictionOfSeveralJoints, DoesNotDependOnTheUnitOfMass) {
  for (const double unit : {0x1p-48, 1.0, 0x1p48}) {
    ContactProblem problem;
    problem.count = 2;
    problem.laws[0] = {.tangents = 0};
    problem.laws[1] = {.normal = false, .bearing = 1, .tangents = 1, .friction = 0.5, .static_friction = 0.5};
    problem.W.resize(2, 2);
    problem.W << unit, 0, 0, unit;
    problem.q.resize(2);
    problem.q << -2, 50;
    problem.S.resize(1, 2);
    problem.S << 1, 0.4;
    problem.c.setConstant(1, 1 / unit);
    const ContactAnswer answer = solve_contacts(problem);
    ASSERT_EQ(answer.verdict, ContactVerdict::unique) << unit;
    EXPECT_EQ(answer.best().r(0) * unit, 2) << unit;
    EXPECT_NEAR(answer.best().r(1) * unit, -1.5 / 1.2, 1e-15) << unit;  // T = -0.5 (2 + 1 + 0.4 T) in that unit
  }
}

// Of several joints, each pressed by what the others do too: the laws are put back.
TEST(FrictionOfSeveralJoints, FulfilsTheLawOfEach) {
  ContactProblem problem;
  problem.count = 2;
  problem.W.resize(2, 2);
  problem.W << 2, 0.3, 0.3, 1.5;
  problem.q.resize(2);
  problem.q << 9, -7;
  problem.S.resize(4, 2);
  problem.S << 0.4, -0.2, 0.1, 0.5, -0.3, 0.2, 0.6, -0.1;
  problem.c.resize(4);
  problem.c << 1, -2, 3, 0.5;
  for (std::size_t i = 0; i < 2; ++i) {
    problem.laws[i] = {.normal = false, .bearing = 2, .tangents = 1, .friction = 0.3, .static_friction = 0.3};
  }
  const ContactAnswer answer = solve_contacts(problem);
  ASSERT_EQ(answer.verdict, ContactVerdict::unique);
  const ContactVector& r = answer.best().r;
  const auto length = [&](int k) { return std::hypot(problem.S.row(k).dot(r) + problem.c(k), problem.S.row(k + 1).dot(r) + problem.c(k + 1)); };
  EXPECT_NEAR(r(0), -0.3 * length(0), 1e-15);
  EXPECT_NEAR(r(1), 0.3 * length(2), 1e-15);
  const ContactAnswer swept = iterate_contacts(problem, ContactVector::Zero(2));
  ASSERT_TRUE(swept);
  EXPECT_NEAR((swept.best().r - r).norm(), 0, 1e-14);
}

}  // namespace
}  // namespace joint_friction_test
