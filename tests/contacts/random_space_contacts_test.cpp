// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts on random problems in space against a scan of directions. TORSOR_LONG_TESTS: 10^5 of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <random>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "tests/contacts/space_truth.hpp"

namespace random_space_contacts_test {
namespace {

using namespace space_truth;

// As many freedoms as rows, one less or one more: one less leaves reactions indeterminate where all stick. Some contacts slide
// already, and some hold more than they rub.
ContactProblem random_problem(std::mt19937& source, int count) {
  std::normal_distribution<double> normal;
  ContactProblem problem;
  problem.count = count;
  const int rows = 3 * count, freedoms = rows - 1 + static_cast<int>(source() % 3);
  const double normals = source() % 2 == 0 ? 0.3 : 1;  // small against tangents, slips may be several
  Eigen::MatrixXd J(rows, freedoms);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < freedoms; ++j) J(i, j) = normal(source) * (i % 3 == 0 ? normals : 1);
  }
  Eigen::VectorXd v(freedoms);
  for (int j = 0; j < freedoms; ++j) v(j) = normal(source);
  problem.W = J * J.transpose();
  problem.q = J * v;
  for (int i = 0; i < count; ++i) {
    ContactLaw& law = problem.laws[static_cast<std::size_t>(i)];
    law = coulomb(2, 2 * std::abs(normal(source)));
    if (source() % 4 == 0) law.static_friction = 1.4 * law.friction;
    if (source() % 4 != 0) continue;
    law.slips = true;
    const double angle = 2 * std::numbers::pi * static_cast<double>(source() % 1000) / 1000;
    law.slip = {std::cos(angle), std::sin(angle)};
  }
  return problem;
}

void expect_lawful(const ContactProblem& problem, const ContactSolution& s) {
  for (int i = 0; i < problem.count; ++i) {
    EXPECT_GE(s.r(3 * i), 0.0);
    EXPECT_GE(s.u(3 * i), 0.0);
    EXPECT_LE(std::hypot(s.r(3 * i + 1), s.r(3 * i + 2)), problem.law(i).static_friction * s.r(3 * i) * (1 + 1e-15));
  }
}

class RandomSpaceContacts : public testing::TestWithParam<int> {};

// Problems within 1e-7 of another verdict are left out: rounding and the scan may decide otherwise there.
TEST_P(RandomSpaceContacts, HaveTheVerdictOfAScanOfDirections) {
  const int count = GetParam();
  const bool many = std::getenv("TORSOR_LONG_TESTS") != nullptr;
  const int total = many ? (count == 1 ? 90'000 : 10'000) : count == 1 ? 500 : 200;
  std::mt19937 source(20261126);
  std::array<int, 4> seen{};
  int near = 0;
  for (int k = 0; k < total; ++k) {
    SCOPED_TRACE(testing::Message() << "problem " << k);
    const ContactProblem problem = random_problem(source, count);
    SpaceTruth truth(problem, 400, 32);
    const auto answer = solve_contacts(problem);
    if (truth.verdict() != answer.verdict) truth = SpaceTruth(problem, 40'000, 96);  // two zeros in one cell
    if (truth.margin() < 1e-7) {
      ++near;
      continue;
    }
    EXPECT_EQ(answer.verdict, truth.verdict());
    ++seen[static_cast<std::size_t>(answer.verdict)];
    for (std::size_t i = 0; i < answer.count; ++i) {
      expect_lawful(problem, answer.solutions[i]);
      EXPECT_TRUE(truth.has_motion(answer.solutions[i].u));
    }
  }
  for (const int each : seen) EXPECT_GT(each, 0);
  EXPECT_LE(near, 1 + total / 100);
}

INSTANTIATE_TEST_SUITE_P(OfContacts, RandomSpaceContacts, testing::Values(1, 2));

}  // namespace
}  // namespace random_space_contacts_test
