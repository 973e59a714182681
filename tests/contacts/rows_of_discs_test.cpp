// SPDX-License-Identifier: GPL-3.0-or-later
// Discs in rows above each other: more contacts than those of which all regimes are tried. Truth: disc_pile.md of the references,
// where bounds are found in 45 digits by a simplex.
#include "tests/contacts/rows_of_discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/contacts/simple_systems.hpp"

namespace rows_of_discs {
namespace {

using Eigen::VectorXd;
constexpr double limit = 0.433987512359;  // of the friction of six discs

struct Case {
  std::vector<Touch> all;
  int count;
  ContactProblem problem;
  Case(const std::vector<int>& rows, double f, unsigned seed)
      : all(in_order(touches(rows), seed)), count(discs(rows)), problem(problem_of(all, count, f)) {}
  [[nodiscard]] VectorXd a(const ContactSolution& s) const { return accelerations(all, count, s.r); }
};

void expect_rest(const Case& pile, const ContactSolution& s) {
  EXPECT_EQ(s.u.norm(), 0);
  EXPECT_LE(pile.a(s).cwiseAbs().maxCoeff(), 1e-11);
  for (int i = 0; i < pile.problem.count; ++i) {
    EXPECT_GE(s.r(2 * i), 0);
    EXPECT_LE(std::abs(s.r(2 * i + 1)), pile.problem.law(i).friction * s.r(2 * i) * (1 + 1e-15));
  }
}

// Accelerations and forces of the sheet: 0 to 2 are the base, 3 and 4 the middle row, 5 is the top.
void expect_collapse(const Case& pile, const ContactSolution& s) {
  const VectorXd a = pile.a(s);
  constexpr double base = 0.1049530271626291383765121, middle = 0.09792250744477209753989143;
  const auto near = [&](int disc, int component, double value) {
    EXPECT_NEAR(a(3 * disc + component), value, 1e-13) << disc << ' ' << component;
  };
  near(0, 0, -base);
  near(2, 0, base);
  near(1, 0, 0);
  near(1, 2, 0);
  near(3, 0, -middle);
  near(4, 0, middle);
  near(3, 1, -0.004059072451647734306962222);
  near(4, 1, -0.004059072451647734306962222);
  near(5, 1, -0.0605946584846100378021805);
  EXPECT_NEAR(std::abs(a(2)), 2 * base, 1e-13);
  EXPECT_NEAR(std::abs(a(3 * 3 + 2)), 0.2261423441318492139808731, 1e-13);
}

// Sweeps found a collapse, or rest, by the order of contacts. With f above 0.6 they always rest: the collapse that the sheet
// gives for every f is possible then too.
TEST(RowsOfDiscs, OfSixRestWhereTheyCanAndCouldCollapse) {
  for (const double f : {limit + 1e-9, 0.4341, 0.435, 0.44, 0.46, 0.49, 0.5, 0.6, 0.8, 1.0, 2.0}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const Case pile({3, 2, 1}, f, seed);
      const ContactAnswer answer = solve_contacts(pile.problem);
      ASSERT_EQ(answer.verdict, ContactVerdict::several) << f << ' ' << seed;
      ASSERT_EQ(answer.count, 2U);
      EXPECT_TRUE(answer.best().indeterminate);
      expect_rest(pile, answer.best());
      expect_collapse(pile, answer.solutions[1]);
    }
  }
}

TEST(RowsOfDiscs, OfSixCollapseBelow) {
  for (const double f : {0.38, 0.4, 0.43, limit - 1e-9}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const Case pile({3, 2, 1}, f, seed);
      const ContactAnswer answer = solve_contacts(pile.problem);
      ASSERT_EQ(answer.verdict, ContactVerdict::not_examined) << f << ' ' << seed;
      ASSERT_EQ(answer.count, 1U);
      expect_collapse(pile, answer.best());
    }
  }
}

TEST(RowsOfDiscs, OfTenRestAboveTheirLimitOnly) {
  for (const double f : {0.45, 0.4729, 0.47297, 0.5, 0.8}) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      const Case pile({4, 3, 2, 1}, f, seed);
      const ContactAnswer answer = solve_contacts(pile.problem);
      ASSERT_TRUE(answer);
      const bool rests = f > 0.472959946014;
      EXPECT_EQ(answer.best().u.norm() == 0, rests) << f;
      EXPECT_EQ(answer.verdict == ContactVerdict::several, rests) << f;
      EXPECT_TRUE(answer.best().indeterminate);
      if (rests) expect_rest(pile, answer.best());
    }
  }
}

// A third disc beside the base, or a fourth above it, changes nothing of tan 15°. Where it lies on the floor alone it is pressed
// from the side by nothing, unless f >= 1: that one force is zero, but others vary.
TEST(RowsOfDiscs, OfTwoRowsHaveReactionsThatAreNotUnique) {
  for (const std::vector<int>& rows : {std::vector<int>{2, 1}, {3, 1}, {3, 2}, {4, 3}, {5, 1}}) {
    for (const double f : {0.2680, 0.2706, 0.2814, 0.36, 0.4287, 0.7}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        const Case pile(rows, f, seed);
        const ContactAnswer answer = solve_contacts(pile.problem);
        ASSERT_EQ(answer.verdict, ContactVerdict::indeterminate) << rows[0] << '+' << rows[1] << ' ' << f << ' ' << seed;
        expect_rest(pile, answer.best());
      }
    }
    const Case pile(rows, 0.2679, 0);
    EXPECT_GT(solve_contacts(pile.problem).best().u.norm(), 0) << rows[0] << '+' << rows[1];
  }
}

// From no reactions, as the first step of a motion by steps.
TEST(RowsOfDiscs, OfSixRestInTheFirstStep) {
  for (const double f : {0.435, 0.5}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const Case pile({3, 2, 1}, f, seed);
      const ContactAnswer answer = go_on_contacts(pile.problem, ContactVector::Zero(pile.problem.rows()));
      ASSERT_TRUE(answer) << f << ' ' << seed;
      expect_rest(pile, answer.best());
    }
  }
}

/// The last contact is that of a disc far away which begins to slide: it is no part of the pile.
ContactProblem beside_a_sliding_disc(const Case& pile) {
  ContactProblem both = pile.problem;
  const int rows = both.rows();
  both.laws[static_cast<std::size_t>(both.count++)] = coulomb(1, 0.2);
  both.W.conservativeResize(rows + 2, rows + 2);
  both.W.bottomRows(2).setZero();
  both.W.rightCols(2).setZero();
  both.W.bottomRightCorner(2, 2) << 1, 0, 0, 3;
  both.q.conservativeResize(rows + 2);
  both.q.tail(2) << -1, 0.75;
  return both;
}

TEST(RowsOfDiscs, RestWhateverSlipsElsewhere) {
  const Case pile({3, 2, 1}, 0.45, 1);
  const int rows = pile.problem.rows();
  const ContactAnswer answer = solve_contacts(beside_a_sliding_disc(pile));
  ASSERT_EQ(answer.verdict, ContactVerdict::several);
  ASSERT_EQ(answer.count, 2U);
  EXPECT_EQ(answer.best().u.head(rows).norm(), 0);
  for (std::size_t j = 0; j < 2; ++j) {
    const ContactSolution& s = answer.solutions[j];
    EXPECT_EQ(s.r(rows), 1);
    EXPECT_EQ(s.r(rows + 1), -0.2);
    EXPECT_NEAR(s.u(rows + 1), 0.15, 1e-15);
    EXPECT_EQ(s.regimes[12], ContactRegime::slides);
    EXPECT_LE(s.residual, 1e-13);
  }
}

TEST(RowsOfDiscs, RestInStepsWhateverSlipsElsewhere) {
  for (const double f : {0.45, 0.5}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const Case pile({3, 2, 1}, f, seed);
      const ContactProblem both = beside_a_sliding_disc(pile);
      const ContactAnswer answer = go_on_contacts(both, ContactVector::Zero(both.rows()));
      ASSERT_TRUE(answer) << f << ' ' << seed;
      EXPECT_EQ(answer.best().u.head(pile.problem.rows()).norm(), 0) << f << ' ' << seed;
      EXPECT_EQ(answer.best().regimes[12], ContactRegime::slides);
    }
  }
}

// A seventh disc beside the base is pulled away: it must leave, and the pile may rest as if it were not there. Once one of both
// motions was found, and told as the only one.
TEST(RowsOfDiscs, RestBesideOneThatIsPulledAwayFromThem) {
  for (const double pull : {0.3, 2.0}) {
    for (const double f : {0.43, limit - 1e-4, limit + 1e-4, 0.45, 0.5}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        SCOPED_TRACE(testing::Message() << "pull " << pull << ", f " << f << ", order " << seed);
        std::vector<Touch> all = touches({3, 2, 1});
        all.push_back({6, -1, 0, 1});
        all.push_back({6, 2, 1, 0});
        all = in_order(all, seed);
        ContactProblem problem = problem_of(all, 7, f);
        VectorXd forces = weights(7);
        forces(18) = pull;
        problem.q = jacobian(all, 7) * forces.cwiseQuotient(masses(7));
        const ContactAnswer answer = solve_contacts(problem);
        ASSERT_TRUE(answer);
        double moved = 0, parted = 0;
        for (std::size_t c = 0; c < all.size(); ++c) {
          const Eigen::Vector2d u = answer.best().u.segment<2>(2 * static_cast<Eigen::Index>(c));
          const bool apart = all[c].a == 6 || all[c].b == 6;
          if (!apart) moved = std::max(moved, u.norm());
          if (apart && all[c].b >= 0) parted = u(0);
        }
        EXPECT_GT(parted, 0.05);
        EXPECT_LE(natural_map_residual(problem, answer.best()), 1e-13);
        if (f > limit) {
          EXPECT_EQ(moved, 0);
          EXPECT_TRUE(answer.best().indeterminate);
          EXPECT_EQ(answer.verdict, ContactVerdict::several);
          ASSERT_EQ(answer.count, 2U);
        } else {
          EXPECT_GT(moved, 0.1);
          EXPECT_EQ(answer.verdict, ContactVerdict::not_examined);
        }
      }
    }
  }
}

// Without friction laws make one convex problem: its motion is the only one, however many contacts there are.
TEST(RowsOfDiscs, WithoutFrictionHaveOneMotion) {
  const Case pile({3, 2, 1}, 0, 0);
  const ContactAnswer answer = solve_contacts(pile.problem);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer.verdict, ContactVerdict::unique);
}

// As a mechanism of 18 freedoms and 12 contacts.
using Pile = simple_systems::ByHand<18, 18, 12>;

Pile pile(double f, unsigned seed) {
  Pile system;
  system.rules.fill(ContactRule{.tangents = 1, .friction = f});
  system.fill = [all = in_order(touches({3, 2, 1}), seed)](double, const Pile::State& y, ContactReading& r) {
    r.M = masses(6).asDiagonal();
    r.F = weights(6);
    std::vector<Touch> now = all;
    r.drift.setZero();
    const Eigen::Map<const VectorXd> q(y.data(), 18), v(y.data() + 18, 18);
    for (std::size_t c = 0; c < all.size(); ++c) {
      auto& [a, b, nx, nz] = now[c];
      if (b < 0) {
        r.gap[c] = q(3 * a + 1) - 0.5;
        continue;
      }
      const Eigen::Vector2d d = q.segment<2>(3 * a) - q.segment<2>(3 * b), change = v.segment<2>(3 * a) - v.segment<2>(3 * b);
      const double length = d.norm();
      nx = d(0) / length;
      nz = d(1) / length;
      r.gap[c] = length - 1;
      const double turns = (nz * change(0) - nx * change(1)) / length, parts = nx * change(0) + nz * change(1);
      const auto row = 2 * static_cast<Eigen::Index>(c);
      r.drift(row) = turns * turns * length;
      r.drift(row + 1) = -parts * turns;
    }
    r.J = jacobian(now, 6);
    r.w = r.J * v;
  };
  return system;
}

Pile::State at_start() {
  Pile::State y{};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t row = i < 3 ? 0 : i < 5 ? 1 : 2, place = i - (row == 0 ? 0 : row == 1 ? 3 : 5);
    y[3 * i] = static_cast<double>(place) + 0.5 * static_cast<double>(row);
    y[3 * i + 1] = 0.5 + std::sqrt(0.75) * static_cast<double>(row);
  }
  return y;
}

constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

TEST(RowsOfDiscs, OfSixStayWhereTheyAreAndTellOfTheCollapse) {
  for (const double f : {0.434, 0.44, 0.5}) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      Pile::State y = at_start();
      const ContactResult result = integrate_contacts(pile(f, seed), y, 0, 1, precise);
      ASSERT_TRUE(result) << describe(result.status);
      EXPECT_GE(result.ambiguous, 1) << f << ' ' << seed;
      EXPECT_GE(result.indeterminate, 1);
      EXPECT_EQ(result.events, 0);
      for (std::size_t i = 0; i < 18; ++i) {
        EXPECT_NEAR(y[i], at_start()[i], 1e-14) << f << ' ' << seed << ' ' << i;
        EXPECT_NEAR(y[18 + i], 0, 1e-14);
      }
    }
  }
}

TEST(RowsOfDiscs, OfSixFallTheSameInEveryOrder) {
  Pile::State first = at_start();
  const ContactResult fallen = integrate_contacts(pile(0.4, 0), first, 0, 0.3, precise);
  ASSERT_TRUE(fallen) << describe(fallen.status);
  EXPECT_EQ(fallen.ambiguous, 0);
  EXPECT_LT(first[16], at_start()[16] - 2e-3);
  for (unsigned seed = 1; seed < 4; ++seed) {
    Pile::State y = at_start();
    const ContactResult result = integrate_contacts(pile(0.4, seed), y, 0, 0.3, precise);
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_EQ(result.ambiguous, 0);
    EXPECT_EQ(result.events, fallen.events);
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], first[i], 1e-11) << seed << ' ' << i;
  }
}

}  // namespace
}  // namespace rows_of_discs
