// SPDX-License-Identifier: GPL-3.0-or-later
#include "runtime/contacts/impact_laws.hpp"

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
    for (const ImpactLaw law : {ImpactLaw::newton_moreau, ImpactLaw::poisson, ImpactLaw::sequential}) {
      const auto result = impact(problem, std::array{e}, law);
      EXPECT_NEAR(result.P(0), (1 + e) * 384 / 401, 1e-15) << describe(law);
      const double lost = -result.P(0) * (problem.q(0) + result.w(0)) / 2;
      EXPECT_NEAR(lost, (1 - e * e) * 768 / 401, 4e-15);
    }
  }
}

}  // namespace
}  // namespace impact_laws_test
