// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/contacts/impact_laws.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace impact_laws_test {
namespace {

using namespace torsor::runtime;
using Restitutions = std::array<double, 4>;

// Balls on a line that touch: contact i between ball i and i + 1, w = v(i + 1) - v(i).
struct Row {
  std::vector<double> masses, before;
  bool on_floor = false;  ///< a further contact, the first, below the first ball
};

struct After {
  std::vector<double> v;
  ImpactResult result;
};

After strike(const Row& row, const Restitutions& e, ImpactLaw law, bool reversed = false) {
  const auto n = static_cast<int>(row.masses.size()), contacts = n - (row.on_floor ? 0 : 1);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(contacts, n), inverse = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd v(n);
  for (int i = 0; i < n; ++i) {
    inverse(i, i) = 1 / row.masses[static_cast<std::size_t>(i)];
    v(i) = row.before[static_cast<std::size_t>(i)];
  }
  for (int c = 0; c < contacts; ++c) {
    const int upper = row.on_floor ? c : c + 1;
    J(c, upper) = 1;
    if (upper > 0) J(c, upper - 1) = -1;
  }
  if (reversed) J = J.colwise().reverse().eval();
  ContactProblem problem;
  problem.count = contacts;
  problem.laws.fill(coulomb(0, 0));
  problem.W = J * inverse * J.transpose();
  problem.q = J * v;
  const ImpactResult result = impact(problem, e, law);
  const Eigen::VectorXd after = v + inverse * J.transpose() * result.P;
  return {{after.data(), after.data() + n}, result};
}

void expect_velocities(const After& after, const std::vector<double>& exact) {
  EXPECT_EQ(after.result.verdict, ContactVerdict::unique);
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(after.v[i], exact[i], 4e-15) << i;
}

// Exact rationals, by enumeration of active sets in fractions.
TEST(ImpactLaw, OfNewtonAndMoreauStrikesAllContactsAtOnce) {
  const ImpactLaw law = ImpactLaw::newton_moreau;
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {1, 1}, law), {-1.0 / 3, 2.0 / 3, 2.0 / 3});
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0.5, 0.5}, law), {0, 0.5, 0.5});
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0, 0}, law), {1.0 / 3, 1.0 / 3, 1.0 / 3});
  expect_velocities(strike({{1, 1, 1, 1, 1}, {1, 0, 0, 0, 0}}, {1, 1, 1, 1}, law), {-0.6, 0.4, 0.4, 0.4, 0.4});
  expect_velocities(strike({{1, 1, 1, 1, 1}, {1, 0, 0, 0, 0}}, {0.5, 0.5, 0.5, 0.5}, law), {-0.2, 0.3, 0.3, 0.3, 0.3});
  expect_velocities(strike({{1, 1, 1, 1, 1}, {1, 1, 0, 0, 0}}, {1, 1, 1, 1}, law), {-0.2, -0.2, 0.8, 0.8, 0.8});
  expect_velocities(strike({{2, 1, 1}, {1, 0, 0}}, {1, 1}, law), {0, 1, 1});
  expect_velocities(strike({{1, 1, 1}, {1, 0, -1}}, {0.5, 0.5}, law), {-0.5, 0, 0.5});
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0, 1}, law), {1.0 / 3, 1.0 / 3, 1.0 / 3});
  expect_velocities(strike({{3, 1}, {-1, -1}, true}, {1, 1}, law), {1, 1});
  // The same whatever the order of declaration.
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0.5, 0.5}, law, true), {0, 0.5, 0.5});
}

// A body whose slip turns round while e = 1 gains: N + 0.8 T = 2, T = -0.1 N, so that -P · (w- + w+)/2 = -0.0520... Another one, that
// does not act on it, loses 1/2.
TEST(ImpactLaw, OfNewtonAndMoreauMayGiveEnergyToOneBodyWhileAnotherLosesMore) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = coulomb(1, 0.1);
  problem.W = Eigen::MatrixXd{{1, 0.8}, {0.8, 1}};
  problem.q = Eigen::VectorXd{{-1.0, -1.0}};
  const Restitutions e{1, 0};
  const ImpactResult alone = impact(problem, e);
  const double N = 2 / (1 - 0.08), T = -0.1 * N, after = -1 + 0.8 * N + T;
  EXPECT_NEAR(alone.lost, -T * (after - 1) / 2, 1e-15);
  EXPECT_LT(alone.lost, -0.05);
  EXPECT_TRUE(alone.gains);
  problem.count = 2;
  problem.laws[1] = coulomb(0, 0);
  problem.W = Eigen::MatrixXd{{1, 0.8, 0}, {0.8, 1, 0}, {0, 0, 1}};
  problem.q = Eigen::VectorXd{{-1.0, -1.0, -1.0}};
  const ImpactResult both = impact(problem, e);
  EXPECT_NEAR(both.lost, alone.lost + 0.5, 1e-15);
  EXPECT_TRUE(both.gains);
  problem.laws[0] = coulomb(0, 0);
  problem.W = Eigen::MatrixXd{{1, 0}, {0, 1}};
  problem.q = Eigen::VectorXd{{-1.0, -1.0}};
  EXPECT_FALSE(impact(problem, e).gains);
}

TEST(ImpactLaw, OfPoissonGivesBackAPartOfTheImpulseOfCompression) {
  const ImpactLaw law = ImpactLaw::poisson;
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0.5, 0.5}, law), {0, 0.5, 0.5});
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0, 1}, law), {1.0 / 6, 1.0 / 6, 2.0 / 3});
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {0.5, 1}, law), {0, 1.0 / 3, 2.0 / 3});
  expect_velocities(strike({{1, 1, 1}, {1, 0, 0}}, {1, 0}, law), {-1.0 / 3, 2.0 / 3, 2.0 / 3});
}

TEST(ImpactLaw, OfSequencesCollidesTwoByTwo) {
  const ImpactLaw law = ImpactLaw::sequential;
  const After three = strike({{1, 1, 1}, {1, 0, 0}}, {1, 1}, law);
  expect_velocities(three, {0, 0, 1});
  EXPECT_EQ(three.result.collisions, 2);
  const After half = strike({{1, 1, 1}, {1, 0, 0}}, {0.5, 0.5}, law);
  expect_velocities(half, {13.0 / 64, 15.0 / 64, 9.0 / 16});
  EXPECT_EQ(half.result.collisions, 3);
  expect_velocities(strike({{1, 1, 1, 1, 1}, {1, 0, 0, 0, 0}}, {0.5, 0.5, 0.5, 0.5}, law),
                    {2521.0 / 16384, 2739.0 / 16384, 729.0 / 4096, 189.0 / 1024, 81.0 / 256});
  expect_velocities(strike({{2, 1, 1}, {1, 0, 0}}, {1, 1}, law), {1.0 / 9, 4.0 / 9, 4.0 / 3});
  // Which end is first decides.
  expect_velocities(strike({{1, 1, 1}, {1, 0, -1}}, {0.5, 0.5}, law), {-23.0 / 64, 3.0 / 64, 5.0 / 16});
  expect_velocities(strike({{1, 1, 1}, {1, 0, -1}}, {0.5, 0.5}, law, true), {-5.0 / 16, -3.0 / 64, 23.0 / 64});
  EXPECT_EQ(strike({{1, 1, 1}, {1, 0, 0}}, {0.08, 0.08}, law).result.collisions, 10);
}

// A block falls on the floor and sticks there; then a ball strikes it from the side, and it slides. Once it was held as before, and
// with it all momentum along the floor was lost.
TEST(ImpactLaw, OfSequencesLetsGoWhatALaterCollisionMoves) {
  Eigen::Matrix3d J;  // of v = (x', z') of the block and x' of the ball, all of 1 kg
  J << 0, 1, 0, 1, 0, 0, -1, 0, 1;
  ContactProblem problem;
  problem.count = 2;
  problem.laws[0] = coulomb(1, 0.5);
  problem.laws[1] = coulomb(0, 0);
  problem.W = J * J.transpose();
  problem.q = J * Eigen::Vector3d(0, -1, -1);
  const ImpactResult result = impact(problem, Restitutions{0, 0}, ImpactLaw::sequential);
  EXPECT_TRUE(result.closed[0] && result.closed[1]);
  EXPECT_FALSE(result.sticks[0]);
  EXPECT_NEAR((result.w - Eigen::Vector3d(0, -0.5, 0)).cwiseAbs().maxCoeff(), 0, 1e-16);
  EXPECT_NEAR((result.P - Eigen::Vector3d(1, 0, 0.5)).cwiseAbs().maxCoeff(), 0, 1e-16);
  EXPECT_NEAR(result.lost, 0.75, 1e-15);
  problem.q = J * Eigen::Vector3d(0, -1, 0);  // nothing comes from the side
  EXPECT_TRUE(impact(problem, Restitutions{0, 0}, ImpactLaw::sequential).sticks[0]);
}

// A ball of 0.3 kg at 4 m/s strikes a hinged rod 0.9 m below its hinge; J = 0.96 kg m² (percussions, course §7.6).
TEST(ImpactLaw, LosesTheEnergyOfCarnot) {
  for (const double e : {0.0, 0.5, 1.0}) {
    ContactProblem problem;
    problem.count = 1;
    problem.laws[0] = coulomb(0, 0);
    problem.W.resize(1, 1);
    problem.W << 1 / 0.3 + 0.81 / 0.96;
    problem.q.resize(1);
    problem.q << -4;
    for (const ImpactLaw law : {ImpactLaw::newton_moreau, ImpactLaw::poisson, ImpactLaw::energetic, ImpactLaw::sequential}) {
      const auto result = impact(problem, std::array{e}, law);
      EXPECT_NEAR(result.P(0), (1 + e) * 384 / 401, 1e-15) << describe(law);
      const double lost = -result.P(0) * (problem.q(0) + result.w(0)) / 2;
      EXPECT_NEAR(lost, (1 - e * e) * 768 / 401, 4e-15);
    }
  }
}

// A rod of mass 1 and length 2 that meets the ground with an end, leaning: cos 0.6, sin 0.8. By hand, in fractions.
ContactProblem leaning_rod(double f, double normal, double slip) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = coulomb(1, f);
  problem.W.resize(2, 2);
  problem.W << 2.08, 1.44, 1.44, 2.92;
  problem.q.resize(2);
  problem.q << normal, slip;
  return problem;
}

double energy_lost(const ContactProblem& problem, const ImpactResult& result) {
  return -result.P.dot(problem.q + result.w) / 2;
}

TEST(ImpactLaw, OfEnergyGivesBackAShareOfTheWorkOfCompression) {
  // A slip that lasts: the same as Newton's law. dw_N/dp = 2.08 - 0.1 1.44.
  const ContactProblem sliding = leaning_rod(0.1, -1, 10);
  const auto slides = impact(sliding, std::array{0.5}, ImpactLaw::energetic);
  EXPECT_NEAR(slides.P(0), 1.5 / 1.936, 1e-15);
  EXPECT_NEAR(slides.w(0), 0.5, 1e-15);
  EXPECT_FALSE(slides.sticks[0] || slides.closed[0]);
  // Without slip it sticks: dw_N/dp = 100/73.
  const auto sticks = impact(leaning_rod(2, -1, 0), std::array{0.5}, ImpactLaw::energetic);
  EXPECT_NEAR(sticks.P(0), 1.5 * 0.73, 1e-15);
  EXPECT_NEAR(sticks.w(0), 0.5, 1e-15);
  EXPECT_TRUE(sticks.sticks[0]);
  // Without friction to hold it, it slips to the side that W says: dw_N/dp = 2.08 - 0.1 1.44.
  const auto begins = impact(leaning_rod(0.1, -1, 0), std::array{0.0}, ImpactLaw::energetic);
  EXPECT_NEAR(begins.P(0), 1 / 1.936, 1e-15);
  EXPECT_NEAR(begins.w(1), (1.44 - 0.292) / 1.936, 1e-15);
  EXPECT_TRUE(begins.closed[0]);
}

// It starts with w_N = 0 and the slip 1: with f = 2 the normal impulse presses the end down, dw_N/dp = -0.8, until the slip
// has ended at p = 5/22. The work of compression is 9/275.
TEST(ImpactLaw, OfEnergyHasImpactsWithoutCollision) {
  const ContactProblem problem = leaning_rod(2, 0, 1);
  const auto result = impact(problem, std::array{0.5}, ImpactLaw::energetic);
  const double after = std::sqrt(18.0 / 803);
  EXPECT_EQ(result.verdict, ContactVerdict::unique);
  EXPECT_NEAR(result.w(0), after, 1e-15);
  EXPECT_NEAR(result.w(1), 0, 1e-15);
  EXPECT_NEAR(result.P(0), 5.0 / 22 + 73.0 / 550 + 0.73 * after, 1e-15);
  EXPECT_GT(energy_lost(problem, result), 0);
  EXPECT_TRUE(result.sticks[0]);
}

// Newton's law gives energy where the slip turns round: Kane's example. The energetic law never does.
TEST(ImpactLaw, OfEnergyNeverGivesAny) {
  int gained = 0;
  for (int k = 0; k < 400; ++k) {
    const double f = 0.05 * (k % 20), slip = 0.3 * (k / 20 - 10);
    const ContactProblem problem = leaning_rod(f, -1, slip);
    const auto energetic = impact(problem, std::array{0.9}, ImpactLaw::energetic);
    EXPECT_GE(energy_lost(problem, energetic), -1e-15) << f << " " << slip;
    EXPECT_LE((problem.q + problem.W * energetic.P - energetic.w).cwiseAbs().maxCoeff(), 4e-15);
    EXPECT_LE(std::abs(energetic.P(1)), f * energetic.P(0) + 1e-15);
    const auto newton = impact(problem, std::array{0.9}, ImpactLaw::newton_moreau);
    gained += newton.verdict != ContactVerdict::none && energy_lost(problem, newton) < -1e-3 ? 1 : 0;
  }
  EXPECT_GT(gained, 0);
}

// Routh's way in small steps of the impulse, in space.
ImpactResult in_small_steps(const ContactProblem& problem, double e, double step) {
  ImpactResult result;
  result.P = ContactVector::Zero(3);
  result.w = problem.q;
  double taken = 0, given = 0;
  while (result.w(0) < 0 || given < -e * e * taken) {
    const double speed = std::hypot(result.w(1), result.w(2));
    ContactVector force(3);
    force << 1, -problem.law(0).friction * result.w(1) / speed, -problem.law(0).friction * result.w(2) / speed;
    const ContactVector change = problem.W * force;
    (result.w(0) < 0 ? taken : given) += step * (result.w(0) + step * change(0) / 2);
    result.P += step * force;
    result.w += step * change;
  }
  return result;
}

TEST(ImpactLaw, OfEnergyTurnsTheSlipInSpace) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = coulomb(2, 0.3);
  problem.W.resize(3, 3);
  problem.W << 2, 0.5, -0.4, 0.5, 3, 0.6, -0.4, 0.6, 2.5;
  problem.q.resize(3);
  problem.q << -1, 0.8, 1.1;
  const auto exact = impact(problem, std::array{0.7}, ImpactLaw::energetic);
  EXPECT_EQ(exact.verdict, ContactVerdict::unique);
  EXPECT_LE((problem.q + problem.W * exact.P - exact.w).cwiseAbs().maxCoeff(), 1e-13);
  const auto coarse = in_small_steps(problem, 0.7, 1e-4), fine = in_small_steps(problem, 0.7, 1e-5);
  EXPECT_LE((fine.P - exact.P).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_LE((fine.P - exact.P).cwiseAbs().maxCoeff(), (coarse.P - exact.P).cwiseAbs().maxCoeff() / 3);
  // A plane impact seen in turned tangents, whose slip ends.
  const double c = 0.6, s = 0.8;
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, c, -s, 0, s, c;
  const ContactProblem flat = leaning_rod(0.9, -1, 0.5);
  Eigen::Matrix3d W = Eigen::Matrix3d::Zero();
  W.topLeftCorner(2, 2) = flat.W;
  W(2, 2) = 2;
  problem.laws[0] = coulomb(2, 0.9);
  problem.W = turn * W * turn.transpose();
  problem.q = turn * Eigen::Vector3d(-1, 0.5, 0);
  const auto in_plane = impact(flat, std::array{0.7}, ImpactLaw::energetic);
  const auto turned = impact(problem, std::array{0.7}, ImpactLaw::energetic);
  const Eigen::Vector3d back = turn.transpose() * turned.P;
  EXPECT_NEAR(back(0), in_plane.P(0), 1e-13);
  EXPECT_NEAR(back(1), in_plane.P(1), 1e-13);
  EXPECT_NEAR(back(2), 0, 1e-13);
  EXPECT_TRUE(in_plane.sticks[0] && turned.sticks[0]);
}

TEST(ImpactLaw, OfEnergyIsOneOfASingleContact) {
  ContactProblem two;
  two.count = 2;
  two.laws.fill(coulomb(0, 0));
  two.W = Eigen::Matrix2d::Identity();
  two.q = Eigen::Vector2d(-1, -1);
  EXPECT_FALSE(impact(two, std::array{1.0, 1.0}, ImpactLaw::energetic).applies);
  EXPECT_TRUE(impact(two, std::array{1.0, 1.0}).applies);
}

}  // namespace
}  // namespace impact_laws_test
