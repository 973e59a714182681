// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/contacts/unique_solution.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "torsor/runtime/contacts/regime_enumeration.hpp"

namespace unique_solution_test {
namespace {

using namespace torsor::runtime;

// Contacts in space on bodies of random inertia: W = J J^T with more freedoms than rows.
ContactProblem random_problem(std::mt19937& source, int count, double friction) {
  std::normal_distribution<double> draw;
  ContactProblem problem;
  problem.count = count;
  for (int i = 0; i < count; ++i) problem.laws[static_cast<std::size_t>(i)] = coulomb(2, friction);
  const int n = problem.rows();
  Eigen::MatrixXd J = Eigen::MatrixXd::NullaryExpr(n, 3 * n, [&] { return draw(source); });
  problem.W = J * J.transpose() / n;
  problem.q = Eigen::VectorXd::NullaryExpr(n, [&] { return draw(source); });
  for (int i = 0; i < count; ++i) problem.q(problem.first_row(i)) -= 1;
  return problem;
}

// What the bound calls unique is so where all regimes are tried, and the solution is the same.
TEST(UniqueSolution, IsTheOnlyOneOfAllRegimes) {
  std::mt19937 source(1);
  int known = 0;
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    const ContactProblem problem = random_problem(source, 2, 0.1 + 0.01 * k);
    if (!solution_is_unique(problem)) continue;
    ++known;
    const ContactAnswer all = RegimeEnumeration(problem).run(), answer = solve_contacts(problem);
    ASSERT_EQ(all.verdict, ContactVerdict::unique);
    ASSERT_EQ(answer.verdict, ContactVerdict::unique);
    EXPECT_LE((answer.best().r - all.best().r).norm(), 1e-12 * all.best().r.norm());
    EXPECT_LE((answer.best().u - all.best().u).norm(), 1e-12 * (problem.W.norm() * all.best().r.norm() + problem.q.norm()));
    EXPECT_EQ(answer.best().regimes, all.best().regimes);
  }
  EXPECT_GE(known, 60);  // or the bound would say nothing
}

// f N slides one way or sticks: W_NT f > W_NN has two motions and more, friction at rest greater than in motion has two.
TEST(UniqueSolution, IsNotClaimedWhereThereAreSeveral) {
  ContactProblem problem;
  problem.count = 1;
  problem.laws[0] = coulomb(1, 2);
  problem.W = Eigen::MatrixXd{{1, 0.8}, {0.8, 1}};
  problem.q = Eigen::VectorXd{{-1.0, 0.5}};
  EXPECT_FALSE(solution_is_unique(problem));
  problem.laws[0].friction = problem.laws[0].static_friction = 0.1;
  EXPECT_TRUE(solution_is_unique(problem));
  problem.laws[0].static_friction = 0.2;
  EXPECT_FALSE(solution_is_unique(problem));
  problem.laws[0] = coulomb(1, 0.1);
  problem.W = Eigen::MatrixXd{{1, 1}, {1, 1}};  // reactions are not unique
  EXPECT_FALSE(solution_is_unique(problem));
}

}  // namespace
}  // namespace unique_solution_test
