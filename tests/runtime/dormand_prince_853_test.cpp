// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/observers.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/mechanisms.hpp"

namespace dormand_prince_853_test {
namespace {

using namespace torsor::runtime;
using Tableau = DormandPrinceTableau853;
using Weights = std::array<long double, Tableau::slopes>;

/// A rooted tree: its order, its density γ and, for each slope, the weight of the elementary differential it stands
/// for. Source: Hairer-Nørsett-Wanner I, II.2 (2.10), (2.17).
struct Tree {
  int order;
  long double density;
  Weights weights;
};

Weights applied(const Weights& weights) {
  Weights result{};
  for (std::size_t i = 1; i < Tableau::slopes; ++i) {
    for (std::size_t j = 0; j < i; ++j) result[i] += Tableau::weights[i - 1][j] * weights[j];
  }
  return result;
}

void add_trees(const std::vector<Tree>& known, std::size_t first, int order, const Tree& root, std::vector<Tree>& all) {
  if (root.order == order) {
    all.push_back(root);
    all.back().density *= static_cast<long double>(order);
    return;
  }
  for (std::size_t k = first; k < known.size(); ++k) {
    if (root.order + known[k].order > order) continue;
    Tree grown{root.order + known[k].order, root.density * known[k].density, applied(known[k].weights)};
    for (std::size_t i = 0; i < Tableau::slopes; ++i) grown.weights[i] *= root.weights[i];
    add_trees(known, k, order, grown, all);
  }
}

/// All rooted trees up to an order: branches are taken in the order in which they were made, so that each comes once.
std::vector<Tree> trees_up_to(int highest) {
  Tree root{1, 1.0L, {}};
  root.weights.fill(1.0L);
  std::vector<Tree> trees;
  for (int order = 1; order <= highest; ++order) {
    std::vector<Tree> more;
    add_trees(trees, 0, order, root, more);
    trees.insert(trees.end(), more.begin(), more.end());
  }
  return trees;
}

/// Largest |Σ b_i Φ_i - θ^order / γ| over the trees up to an order.
long double largest_residual(const std::vector<Tree>& trees, int order, const Weights& b, long double theta = 1.0L) {
  long double largest = 0.0L;
  for (const Tree& tree : trees) {
    if (tree.order > order) continue;
    long double sum = -std::pow(theta, static_cast<long double>(tree.order)) / tree.density;
    for (std::size_t i = 0; i < Tableau::slopes; ++i) sum += b[i] * tree.weights[i];
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

Weights row(std::size_t index) {
  Weights weights{};
  for (std::size_t j = 0; j < Tableau::slopes; ++j) weights[j] = Tableau::weights[index][j];
  return weights;
}

// The interpolant as weights of the slopes: DenseStep's own evaluation, with h = 1 and y = 0, over unit slopes.
Weights interpolant_at(long double theta) {
  DenseStep<long double, Tableau::slopes, 8> step{0.0L, 1.0L, {}};
  auto& c = step.coefficients;
  c[1] = row(Tableau::solution);
  for (std::size_t j = 0; j < Tableau::slopes; ++j) {
    c[2][j] = (j == 0 ? 1.0L : 0.0L) - c[1][j];
    c[3][j] = c[1][j] - (j == 12 ? 1.0L : 0.0L) - c[2][j];
    for (std::size_t k = 0; k < Tableau::dense_rows; ++k) c[4 + k][j] = Tableau::weights[Tableau::dense + k][j];
  }
  return step(theta);
}

// The decimals have 27 digits or more; rounding them and the sums to long double leaves 5e-20 × the largest partial
// sums, of some 400 for the interpolant and 50 otherwise (weights of the slopes up to 528 and 48, elementary weights
// below 1), in sums of sixteen terms.
constexpr long double rounding = 5.5e-20L * 16 * 50, dense_rounding = 5.5e-20L * 16 * 530;

TEST(DormandPrince853, FulfilsTheConditionsOfAllTreesUpToOrderEight) {
  const std::vector<Tree> trees = trees_up_to(9);
  ASSERT_EQ(trees.size(), 486U);  // 1 + 1 + 2 + 4 + 9 + 20 + 48 + 115 + 286
  EXPECT_LT(largest_residual(trees, 8, row(Tableau::solution)), rounding);
  EXPECT_GT(largest_residual(trees, 9, row(Tableau::solution)), 1e-6L);
}

TEST(DormandPrince853, CarriesEmbeddedSolutionsOfOrdersFiveAndThree) {
  const std::vector<Tree> trees = trees_up_to(6);
  Weights fifth = row(Tableau::solution), third{};
  for (std::size_t j = 0; j < fifth.size(); ++j) fifth[j] -= row(Tableau::fifth_order)[j];
  for (std::size_t j = 0; j < 3; ++j) third[Tableau::third_order_slopes[j]] = Tableau::third_order[j];
  EXPECT_LT(largest_residual(trees, 5, fifth), rounding);
  EXPECT_GT(largest_residual(trees, 6, fifth), 1e-6L);
  EXPECT_LT(largest_residual(trees, 3, third), rounding);
  EXPECT_GT(largest_residual(trees, 4, third), 1e-6L);
}

TEST(DormandPrince853, InterpolatesWithTheConditionsOfAllTreesUpToOrderSeven) {
  const std::vector<Tree> trees = trees_up_to(8);
  for (const long double theta : {0.1L, 0.25L, 0.5L, 0.7L, 0.95L, 1.0L}) {
    EXPECT_LT(largest_residual(trees, 7, interpolant_at(theta), theta), dense_rounding) << theta;
  }
  EXPECT_GT(largest_residual(trees, 8, interpolant_at(0.5L), 0.5L), 1e-8L);
}

TEST(DormandPrince853, PlacesItsStagesAtTheSumsOfTheirRows) {
  for (std::size_t i = 1; i < Tableau::slopes; ++i) {
    long double sum = 0.0L;
    for (std::size_t j = 0; j < i; ++j) sum += Tableau::weights[i - 1][j];
    EXPECT_NEAR(static_cast<double>(sum - Tableau::times[i]), 0.0, static_cast<double>(rounding)) << i;
  }
}

/// Unit steps of the length given: the tolerance is so loose that only the largest step limits.
DormandPrince853 of_step(double h) {
  return {.relative_tolerance = 1e3, .absolute_tolerance = 1.0, .first_step = h, .largest_step = h};
}

using Wide = std::array<long double, 2>;
using One = std::array<long double, 1>;

// y' = y cos t, y = e^(sin t): not linear in (t, y), and known everywhere.
constexpr auto growth = [](long double t, const One& y, One& rate) noexcept {
  rate[0] = y[0] * std::cos(t);
  return Evaluation::ok;
};
long double exact(long double t) { return std::exp(std::sin(t)); }

// As in the tests of the other methods: the next term of the expansion moves the observed order by less than 0.2.
TEST(DormandPrince853, HasOrderEight) {
  const auto error_of_step = [](double h) {
    One y{1.0L};
    EXPECT_TRUE(integrate(growth, y, 0.0L, 1.0L, of_step(h)));
    return std::abs(y[0] - exact(1.0L));
  };
  EXPECT_NEAR(static_cast<double>(std::log2(error_of_step(1.0 / 8) / error_of_step(1.0 / 16))), 8.0, 0.2);
}

TEST(DormandPrince853, InterpolatesWithLocalErrorOfOrderEight) {
  // h^9 at the end of a step from an exact value, h^8 inside.
  const long double start = 0.3L;
  const auto errors_of = [&](double h) {
    Wide errors{};
    const auto compare = [&](const auto& step) {
      for (int i = 1; i < 10; ++i) {
        const long double t = step.start + (step.end - step.start) * i / 10;
        errors[0] = std::max(errors[0], std::abs(step(t)[0] - exact(t)));
      }
      errors[1] = std::abs(step(step.end)[0] - exact(step.end));
    };
    One y{exact(start)};
    EXPECT_TRUE(integrate(growth, y, start, start + static_cast<long double>(h), of_step(h), compare));
    return errors;
  };
  const Wide coarse = errors_of(0.125), fine = errors_of(0.0625);
  EXPECT_NEAR(static_cast<double>(std::log2(coarse[0] / fine[0])), 8.0, 0.3);
  EXPECT_NEAR(static_cast<double>(std::log2(coarse[1] / fine[1])), 9.0, 0.3);
}

TEST(DormandPrince853, MeetsItsTolerance) {
  // Simple pendulum, L = 1, g = 9.81, from (2, 0), at t = 10 (Jacobi's elliptic functions, 50 digits).
  constexpr std::array<double, 2> end{0.015728632141428118626277592909, 5.27089879322982860518148735035};
  // Ten seconds of errors of a tolerance ε (1 + |y|), |y| up to 6.3 here, amplified by κ = 17 (see the test of 5(4)).
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    std::array<double, 2> y{2.0, 0.0};
    const auto result = integrate(equations_of_motion<mechanisms::Pendulum<double>>(), y, 0, 10,
                                  DormandPrince853{.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
    EXPECT_TRUE(result) << describe(result);
    EXPECT_LT(std::max(std::abs(y[0] - end[0]), std::abs(y[1] - end[1])), 10 * 7.3 * 17 * tolerance);
  }
}

TEST(DormandPrince853, EvaluatesTwelveTimesAStepAndThreeTimesMoreForAnInterpolant) {
  const auto motion = equations_of_motion<mechanisms::Pendulum<double>>();
  const DormandPrince853 method{.relative_tolerance = 1e-9, .first_step = 0.9};
  std::array<double, 2> y{2.0, 0.0}, z = y;
  const Statistics plain = integrate(motion, y, 0, 10, method).statistics;
  EXPECT_GT(plain.rejected, 0);
  EXPECT_EQ(plain.calls, 1 + 12 * plain.accepted + 11 * plain.rejected);
  int samples = 0;
  const auto count = [&](double, const std::array<double, 2>&) noexcept { ++samples; };
  const Statistics dense = integrate(motion, z, 0, 10, method, EquallySpaced(0.0, 0.01, count)).statistics;
  EXPECT_EQ(samples, 1001);
  EXPECT_EQ(dense.calls, 1 + 15 * dense.accepted + 11 * dense.rejected);
  EXPECT_EQ(y, z);
}

}  // namespace
}  // namespace dormand_prince_853_test
