// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of balls, a ball on a ball and a point in a corner: which law gives what, and when the order of a sequence matters. Values
// are those of multiple_impacts.md of the references.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/impact_laws.hpp"
#include "tests/contacts/simple_systems.hpp"

namespace multiple_impacts_test {
namespace {

using namespace torsor::runtime;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Contacts without friction between masses: rows J, velocities before, and one restitution.
struct Shock {
  MatrixXd J;
  VectorXd masses, before;
  double e;
  ImpactResult result{};

  VectorXd after(ImpactLaw law) {
    const VectorXd inverse = masses.cwiseInverse();
    ContactProblem problem;
    problem.count = static_cast<int>(J.rows());
    problem.laws.fill(coulomb(0, 0));
    problem.W = J * inverse.asDiagonal() * J.transpose();
    problem.q = J * before;
    std::vector<double> restitution(static_cast<std::size_t>(J.rows()), e);
    result = impact(problem, restitution, law);
    return before + inverse.asDiagonal() * J.transpose() * result.P;
  }
  [[nodiscard]] Shock reversed() const { return {J.colwise().reverse(), masses, before, e}; }
};

void expect_near(const VectorXd& a, const VectorXd& b, double error) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), error) << a.transpose() << " instead of " << b.transpose();
}

Shock row_of_balls(const VectorXd& masses, const VectorXd& before, double e) {
  const Eigen::Index n = masses.size();
  MatrixXd J = MatrixXd::Zero(n - 1, n);
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    J(i, i) = -1;
    J(i, i + 1) = 1;
  }
  return {J, masses, before, e};
}

VectorXd of(std::initializer_list<double> numbers) {
  VectorXd all(static_cast<Eigen::Index>(numbers.size()));
  Eigen::Index i = 0;
  for (const double each : numbers) all(i++) = each;
  return all;
}

TEST(MultipleImpacts, OfAnyNumberOfEqualBallsAtOnce) {
  for (int n = 2; n <= 12; ++n) {
    for (const double e : {0.0, 0.3, 1.0}) {
      VectorXd before = VectorXd::Zero(n);
      before(0) = 1;
      Shock shock = row_of_balls(VectorXd::Ones(n), before, e);
      VectorXd exact = VectorXd::Constant(n, (1 + e) / n);
      exact(0) = 1 - (1 + e) * (n - 1) / n;
      expect_near(shock.after(ImpactLaw::newton_moreau), exact, 4e-15);
      for (int i = 1; i < n; ++i) EXPECT_NEAR(shock.result.P(i - 1), (1 + e) * (n - i) / n, 4e-15);
      EXPECT_FALSE(shock.result.order_matters);
    }
  }
}

// Near the collapse at e = 7 - 4 √3 = 0.07179... there are as many collisions as one likes.
TEST(MultipleImpacts, OfSequencesNearTheirCollapse) {
  struct Case {
    double e;
    int collisions;
  };
  for (const Case& each : {Case{0.1, 6}, Case{0.08, 10}, Case{0.0719, 89}}) {
    Shock shock = row_of_balls(of({1, 1, 1}), of({1, 0, 0}), each.e);
    const VectorXd v = shock.after(ImpactLaw::sequential);
    EXPECT_EQ(shock.result.collisions, each.collisions) << each.e;
    EXPECT_NEAR(v.sum(), 1, 1e-14);
    EXPECT_FALSE(shock.result.order_matters);
    if (each.e == 0.1) expect_near(v, of({0.3327090625, 0.333631546875, 0.333659390625}), 1e-15);
  }
}

TEST(MultipleImpacts, OfSequencesThatHitTheFloorAgain) {
  // Ball m2 = 1 on ball m1 = 3, both fall with 1 m/s; the floor is the first contact.
  MatrixXd J(2, 2);
  J << 1, 0, -1, 1;
  struct Case {
    double e;
    VectorXd in_turn, at_once, impulses;
  };
  for (const Case& each : {Case{1, of({0, 2}), of({1, 1}), of({8, 2})},
                           Case{0.5, of({-1.0 / 16, 11.0 / 16}), of({0.5, 0.5}), of({6, 1.5})}}) {
    Shock shock{J, of({3, 1}), of({-1, -1}), each.e};
    expect_near(shock.after(ImpactLaw::newton_moreau), each.at_once, 4e-15);
    expect_near(shock.result.P, each.impulses, 1e-14);
    // The floor, and then the balls: the sheet has what follows until the lower one would hit the floor again.
    if (each.e == 1) expect_near(shock.after(ImpactLaw::sequential), each.in_turn, 4e-15);
  }
}

// The floor y >= 0 and a plane that rises at the angle A; e = 1. Only where A is 180°/n does the order not matter.
TEST(MultipleImpacts, OfAPointInACorner) {
  constexpr double degree = std::numbers::pi / 180;
  struct Case {
    double angle;
    VectorXd floor_first, plane_first;
    int collisions, collisions_of_plane;
  };
  const VectorXd back = of({0.9396926207859083841, 0.3420201433256687330});
  const VectorXd up = of({0.7660444431189780352, 0.6427876096865393263}), plane = of({0.5, 0.8660254037844386468});
  for (const Case& each : {Case{90, back, back, 2, 2}, Case{60, up, up, 3, 3}, Case{70, back, plane, 3, 2}}) {
    SCOPED_TRACE(testing::Message() << each.angle << "°");
    MatrixXd J(2, 2);
    J << 0, 1, std::sin(each.angle * degree), -std::cos(each.angle * degree);
    Shock shock{J, of({1, 1}), of({-std::cos(20 * degree), -std::sin(20 * degree)}), 1};
    expect_near(shock.after(ImpactLaw::sequential), each.floor_first, 1e-15);
    EXPECT_EQ(shock.result.collisions, each.collisions);
    const bool matters = each.angle == 70;
    EXPECT_EQ(shock.result.order_matters, matters);
    Shock other = shock.reversed();
    expect_near(other.after(ImpactLaw::sequential), each.plane_first, 1e-15);
    EXPECT_EQ(other.result.collisions, each.collisions_of_plane);
    EXPECT_EQ(other.result.order_matters, matters);
  }
}

TEST(MultipleImpacts, SayWhereTheOrderMatters) {
  const auto matters = [](const Shock& given, ImpactLaw law = ImpactLaw::sequential) {
    Shock shock = given;
    (void)shock.after(law);
    return shock.result.order_matters;
  };
  // Both outer balls strike the middle one: which is first decides.
  const Shock both_sides = row_of_balls(of({1, 1, 1}), of({1, 0, -1}), 0.5);
  EXPECT_TRUE(matters(both_sides));
  EXPECT_TRUE(matters(both_sides.reversed()));
  EXPECT_FALSE(matters(both_sides, ImpactLaw::newton_moreau));
  EXPECT_FALSE(matters(both_sides, ImpactLaw::poisson));
  // One ball strikes a row: one collision causes the next.
  EXPECT_FALSE(matters(row_of_balls(of({1, 1, 1, 1, 1}), of({1, 0, 0, 0, 0}), 1)));
  EXPECT_FALSE(matters(row_of_balls(of({2, 1, 1}), of({1, 0, 0}), 1)));
  // Of more than four contacts the reverse order is compared.
  EXPECT_TRUE(matters(row_of_balls(VectorXd::Ones(7), of({1, 0, -1, 0, 0, 0, 0}), 0.5)));
  // A rod falls flat on two supports, below its centre and beside it: one collision ends it, whichever is first.
  MatrixXd supports(2, 2);
  supports << 1, 0, 1, 1;
  const Shock flat{supports, of({1, 1}), of({-1, 0}), 1};
  EXPECT_TRUE(matters(flat));
  EXPECT_TRUE(matters(flat.reversed()));
  // Two pairs that have nothing to do with each other.
  MatrixXd pairs(2, 4);
  pairs << -1, 1, 0, 0, 0, 0, -1, 1;
  EXPECT_FALSE(matters({pairs, of({1, 2, 3, 4}), of({1, 0, 1, -1}), 0.5}));
}

/// A point that falls into a corner, as a motion: its events say whether the order mattered.
simple_systems::ByHand<2, 2, 2> point_in_corner(double angle) {
  const ContactRule rule{.tangents = 0, .restitution = 1};
  return {{rule, rule}, [s = std::sin(angle), c = std::cos(angle)](double, const auto& y, auto& r) {
            r.M.setIdentity();
            r.F.setZero();
            r.gap[0] = y[1];
            r.gap[1] = s * y[0] - c * y[1];
            r.J << 0, 1, s, -c;
            r.w << y[3], s * y[2] - c * y[3];
            r.drift.setZero();
          }};
}

TEST(MultipleImpacts, TellInMotionsWhereTheOrderMatters) {
  for (const double angle : {60.0, 70.0}) {
    std::array<double, 4> y{0, 0, -std::cos(std::numbers::pi / 9), -std::sin(std::numbers::pi / 9)};
    const ContactResult result = integrate_contacts(point_in_corner(angle * std::numbers::pi / 180), y, 0, 1,
                                                    DormandPrince853{}, {.law = ImpactLaw::sequential});
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_EQ(result.order_matters, angle == 70 ? 1 : 0);
  }
}

}  // namespace
}  // namespace multiple_impacts_test
