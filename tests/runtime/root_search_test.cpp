// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/numerics/root_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace root_search_test {
namespace {

using namespace torsor::runtime;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

VectorXd one(double x) { return VectorXd::Constant(1, x); }

/// Roots of one function by central differences.
template <class Function>
RootSearch roots_of(const Function& f, double lower, double upper, std::vector<Eigen::Index> angles = {}) {
  const auto equations = [&f](const VectorXd& x) { return one(f(x(0))); };
  const auto slope = [&](const VectorXd& x) { return central_differences(equations, x, one(upper - lower)); };
  return find_roots({.f = equations, .derivative = slope, .unknowns = 1}, {one(lower), one(upper), std::move(angles)});
}

TEST(RootSearch, FindsEveryRootOfASineInTheBoxAndNoOther) {
  const RootSearch search = roots_of([](double x) { return std::sin(x); }, -1.0, 20.0);
  ASSERT_EQ(search.roots.size(), 7U);  // 0, π, ..., 6π
  int starts = 0;
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(search.roots[k].x(0), static_cast<double>(k) * pi, 1e-12);
    EXPECT_TRUE(search.roots[k].isolated);
    EXPECT_LE(search.roots[k].residual, 1e-12);
    starts += search.roots[k].found;
  }
  EXPECT_EQ(starts + static_cast<int>(search.failures.size()), search.starts);
  for (const FailedStart& failure : search.failures) EXPECT_EQ(failure.reason, StartFailure::left_box);
}

TEST(RootSearch, MergesAnglesThatDifferByTurns) {
  const RootSearch search = roots_of([](double x) { return std::sin(x); }, -1.0, -1.0 + 2 * pi, {0});
  ASSERT_EQ(search.roots.size(), 2U);
  EXPECT_NEAR(search.roots[0].x(0), 0.0, 1e-12);
  EXPECT_NEAR(search.roots[1].x(0), pi, 1e-12);
  EXPECT_TRUE(search.failures.empty());
}

TEST(RootSearch, SaysWhereStartsStall) {
  const RootSearch search = roots_of([](double x) { return x * x + 1.0; }, -2.0, 3.0);
  EXPECT_TRUE(search.roots.empty());
  ASSERT_EQ(static_cast<int>(search.failures.size()), search.starts);
  for (const FailedStart& failure : search.failures) {
    EXPECT_NEAR(failure.end(0), 0.0, 0.1);
    EXPECT_NEAR(failure.residual, 1.0 / 30.0, 1e-3);  // 1 of 30, the slope at 3 times the width
    EXPECT_FALSE(describe(failure.reason).empty());
  }
}

TEST(RootSearch, CallsAMultipleRootNotIsolated) {
  const RootSearch search = roots_of([](double x) { return (x - 1) * (x - 1) * (x - 1) * (x + 2); }, -3.0, 3.0);
  ASSERT_EQ(search.roots.size(), 2U);
  EXPECT_NEAR(search.roots[0].x(0), -2.0, 1e-12);
  EXPECT_TRUE(search.roots[0].isolated);
  EXPECT_NEAR(search.roots[1].x(0), 1.0, 6 * 1e-3);  // the third root of rounding; merged within 1e-3 of the box
  EXPECT_FALSE(search.roots[1].isolated);
}

// (1 + cos x) sin x is (x - π)³/2 beside π, a root known to 1e-4, on both sides of where a turn begins and ends.
TEST(RootSearch, MergesRootsThatAreATurnApart) {
  const RootSearch search =
      roots_of([](double x) { return (1.0 + std::cos(x)) * std::sin(x); }, -pi, pi, std::vector<Eigen::Index>{0});
  ASSERT_EQ(search.roots.size(), 2U);
  int at_zero = 0;
  for (const FoundRoot& root : search.roots) {
    at_zero += std::abs(root.x(0)) < 1e-9 ? 1 : 0;
    EXPECT_EQ(root.isolated, std::abs(root.x(0)) < 1e-9);
  }
  EXPECT_EQ(at_zero, 1);
}

TEST(RootSearch, ReportsValuesThatAreNotFinite) {
  const RootSearch search = roots_of([](double x) { return std::sqrt(x) - 2.0; }, -1.0, 9.0);
  ASSERT_EQ(search.roots.size(), 1U);
  EXPECT_NEAR(search.roots[0].x(0), 4.0, 1e-11);
  int not_finite = 0;
  for (const FailedStart& failure : search.failures) not_finite += failure.reason == StartFailure::not_finite;
  EXPECT_GT(not_finite, 5);
}

// Nine roots of Himmelblau's gradient, of which four are the minima (3, 2), ... of f; units of y a million times x's.
TEST(RootSearch, FindsAllRootsOfASystemWhateverItsUnits) {
  for (const double unit : {1.0, 1e6}) {
    const auto f = [unit](const VectorXd& z) {
      const double x = z(0), y = z(1) / unit, a = x * x + y - 11, b = x + y * y - 7;
      return VectorXd(Vector2d(4 * x * a + 2 * b, (2 * a + 4 * y * b) / unit));
    };
    const auto slope = [unit](const VectorXd& z) {
      const double x = z(0), y = z(1) / unit;
      MatrixXd result(2, 2);
      const double mixed = 4 * (x + y);
      result << 12 * x * x + 4 * y - 42, mixed / unit, mixed / unit, (12 * y * y + 4 * x - 26) / (unit * unit);
      return result;
    };
    const RootSearch search =
        find_roots({.f = f, .derivative = slope, .unknowns = 2}, {Vector2d(-5, -5 * unit), Vector2d(5, 5 * unit)});
    ASSERT_EQ(search.roots.size(), 9U);
    bool minimum = false;
    for (const FoundRoot& root : search.roots) {
      minimum = minimum || (std::abs(root.x(0) - 3) < 1e-11 && std::abs(root.x(1) / unit - 2) < 1e-11);
    }
    EXPECT_TRUE(minimum);
  }
}

// A circle of roots: each start ends somewhere on it, and none of them is isolated.
TEST(RootSearch, FollowsCurvesOfRoots) {
  const auto f = [](const VectorXd& x) { return one(x.squaredNorm() - 1.0); };
  const auto slope = [](const VectorXd& x) { return MatrixXd(2.0 * x.transpose()); };
  const RootSearch search =
      find_roots({.f = f, .derivative = slope, .unknowns = 2}, {Vector2d(-2, -2), Vector2d(2, 2)});
  EXPECT_GT(search.roots.size(), 50U);
  for (const FoundRoot& root : search.roots) {
    EXPECT_NEAR(root.x.norm(), 1.0, 1e-11);
    EXPECT_FALSE(root.isolated);
  }
}

// An unknown without bounds that enters linearly: λ with x² = 2, λ x = 3e9.
TEST(RootSearch, NeedsNoBoundsForLinearUnknowns) {
  const auto f = [](const VectorXd& x) { return VectorXd(Vector2d(x(0) * x(0) - 2, x(0) * x(1) - 3e9)); };
  const auto slope = [](const VectorXd& x) {
    MatrixXd result(2, 2);
    result << 2 * x(0), 0, x(1), x(0);
    return result;
  };
  const RootSearch search = find_roots({.f = f, .derivative = slope, .unknowns = 2}, {one(-2), one(3)});
  ASSERT_EQ(search.roots.size(), 2U);
  EXPECT_NEAR(search.roots[1].x(0), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(search.roots[1].x(1), 3e9 / std::sqrt(2.0), 1e-3);
}

TEST(RootSearch, RefusesABoxThatIsNone) {
  const auto f = [](const VectorXd& x) { return x; };
  const auto slope = [](const VectorXd& x) { return MatrixXd(MatrixXd::Identity(x.size(), x.size())); };
  EXPECT_THROW((void)find_roots({.f = f, .derivative = slope, .unknowns = 1}, {one(1), one(1)}), std::invalid_argument);
  EXPECT_THROW((void)find_roots({.f = f, .derivative = slope, .unknowns = 1}, {one(1), Vector2d(2, 2)}),
               std::invalid_argument);
  EXPECT_THROW((void)find_roots({.f = f, .derivative = slope, .unknowns = 1}, {one(0), one(INFINITY)}),
               std::invalid_argument);
}

}  // namespace
}  // namespace root_search_test
