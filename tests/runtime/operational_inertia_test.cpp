// SPDX-License-Identifier: GPL-3.0-or-later
// Operational-space inertias against elimination in more digits, and where the arm cannot move the task.
#include "torsor/runtime/numerics/operational_inertia.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace operational_inertia_test {
namespace {

using namespace torsor::runtime;
using Number = long double;
using Rows = std::vector<std::vector<Number>>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A X = B by Gauss's elimination with exchange of rows.
Rows solved(Rows A, Rows B) {
  const std::size_t n = A.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k; i < n; ++i) best = std::abs(A[i][k]) > std::abs(A[best][k]) ? i : best;
    std::swap(A[k], A[best]);
    std::swap(B[k], B[best]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Number factor = A[i][k] / A[k][k];
      for (std::size_t j = 0; j < n; ++j) A[i][j] -= factor * A[k][j];
      for (std::size_t j = 0; j < B[i].size(); ++j) B[i][j] -= factor * B[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (Number& entry : B[i]) entry /= A[i][i];
  }
  return B;
}
Rows transposed(const Rows& A) {
  Rows B(A.front().size(), std::vector<Number>(A.size()));
  for (std::size_t i = 0; i < A.size(); ++i) {
    for (std::size_t j = 0; j < B.size(); ++j) B[j][i] = A[i][j];
  }
  return B;
}
Rows product(const Rows& A, const Rows& B) {
  Rows C(A.size(), std::vector<Number>(B.front().size()));
  for (std::size_t i = 0; i < A.size(); ++i) {
    for (std::size_t k = 0; k < B.size(); ++k) {
      for (std::size_t j = 0; j < C[i].size(); ++j) C[i][j] += A[i][k] * B[k][j];
    }
  }
  return C;
}
Rows identity(std::size_t n) {
  Rows one(n, std::vector<Number>(n));
  for (std::size_t i = 0; i < n; ++i) one[i][i] = 1;
  return one;
}

/// An arm of n joints: axes and places of joints from the point, and a mass matrix with condition of some tens.
struct Arm {
  Rows jacobian, mass;

  Arm(unsigned seed, std::size_t n, Number length) : jacobian(6, std::vector<Number>(n)), mass(identity(n)) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-1, 1);
    for (std::size_t j = 0; j < n; ++j) {
      std::array<Number, 3> axis{}, away{};
      for (std::size_t i = 0; i < 3; ++i) {
        axis[i] = part(random);
        away[i] = length * static_cast<Number>(part(random));
      }
      for (std::size_t i = 0; i < 3; ++i) {
        jacobian[i][j] = axis[(i + 1) % 3] * away[(i + 2) % 3] - axis[(i + 2) % 3] * away[(i + 1) % 3];
        jacobian[i + 3][j] = axis[i];
      }
    }
    Rows root(n, std::vector<Number>(n));
    for (auto& row : root) {
      for (Number& entry : row) entry = part(random);
    }
    mass = product(root, transposed(root));
    for (std::size_t i = 0; i < n; ++i) mass[i][i] += 0.5L;
    for (auto& row : mass) {
      for (Number& entry : row) entry *= length * length;
    }
  }
  [[nodiscard]] Rows inverse() const { return product(jacobian, solved(mass, transposed(jacobian))); }
};

template <class Scalar = double>
std::array<Scalar, 36> by_columns(const Rows& W) {
  std::array<Scalar, 36> all{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) all[6 * j + i] = static_cast<Scalar>(W[i][j]);
  }
  return all;
}
template <std::size_t k>
Rows block(const Rows& W, const std::array<TwistRow, k>& rows) {
  Rows part(k, std::vector<Number>(k));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) part[i][j] = W[static_cast<std::size_t>(rows[i])][static_cast<std::size_t>(rows[j])];
  }
  return part;
}
template <class Scalar, std::size_t k>
Rows numbers(const SmallMatrix<Scalar, k, k>& A) {
  Rows B(k, std::vector<Number>(k));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) B[i][j] = A(static_cast<int>(i), static_cast<int>(j));
  }
  return B;
}

/// Entries over the roots of those on the diagonal, so that units do not matter.
void expect_near(const Rows& found, const Rows& right, double bound) {
  for (std::size_t i = 0; i < right.size(); ++i) {
    for (std::size_t j = 0; j < right.size(); ++j) {
      const Number size = std::sqrt(right[i][i] * right[j][j]);
      EXPECT_LE(std::abs(found[i][j] - right[i][j]), static_cast<Number>(bound) * size) << i << ", " << j;
    }
  }
}
template <class Scalar, std::size_t k>
void expect_inverse(const Rows& W, const std::array<TwistRow, k>& rows, double length, double bound) {
  const auto task = operational_inertia(by_columns<Scalar>(W), rows, {.length = static_cast<Scalar>(length)});
  EXPECT_EQ(task.evaluation, Evaluation::ok);
  EXPECT_EQ(task.rank, static_cast<int>(k));
  expect_near(numbers(task.inertia), solved(block(W, rows), identity(k)), bound);
}

// Conditions of these inverses go up to 1e4: 2e3 and more roundings of each entry are its error.
TEST(OperationalInertia, IsTheInverseOfTheRowsOfTheTask) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    for (const double length : {1e-6, 1.0, 1e3}) {
      const Rows W = Arm(seed, 8, static_cast<Number>(length)).inverse();
      expect_inverse<double>(W, twist_rows, length, 1e5 * epsilon);
      expect_inverse<double>(W, translation_rows, length, 1e4 * epsilon);
      expect_inverse<double>(W, rotation_rows, length, 1e4 * epsilon);
      expect_inverse<double>(W, std::array{TwistRow::about_y}, length, 4 * epsilon);
      expect_inverse<double>(W, std::array{TwistRow::z, TwistRow::about_x}, length, 1e3 * epsilon);
    }
    expect_inverse<float>(Arm(seed, 8, 1).inverse(), translation_rows, 1.0, 1e4 * static_cast<double>(1.2e-7F));
  }
}

TEST(OperationalInertia, OfFewerRowsIsNoBlockOfTheWhole) {
  const Rows W = Arm(3, 8, 1).inverse();
  const auto whole = operational_inertia(by_columns(W));
  const auto part = operational_inertia(by_columns(W), translation_rows);
  EXPECT_GT(whole.inertia(0, 0), 1.05 * part.inertia(0, 0));  // which holds the rotations
}

// Along axes of its own the same arm has the same inertia, turned.
TEST(OperationalInertia, IsAlongTheAxesThatAreGiven) {
  const Rows W = Arm(5, 7, 1).inverse();
  const double c = 0.8, s = 0.6;
  const std::array<double, 9> axes{c, s, 0, -s * c, c * c, s, s * s, -c * s, c};  // about x by b after z by a, both 3-4-5
  const auto ground = operational_inertia(by_columns(W), translation_rows);
  const auto tool = operational_inertia(by_columns(W), translation_rows, {.axes = axes});
  ASSERT_EQ(tool.evaluation, Evaluation::ok);
  Rows R(3, std::vector<Number>(3));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) R[i][j] = static_cast<Number>(axes[3 * j + i]);
  }
  expect_near(product(R, product(numbers(tool.inertia), transposed(R))), numbers(ground.inertia), 1e4 * epsilon);
}

/// Two links of length 1 in the plane x, y, the second turned by `bend` from the first, which is turned by `turn`.
Rows plane_arm(Number turn, Number bend) {
  const Number x = std::cos(turn), y = std::sin(turn), a = std::cos(turn + bend), b = std::sin(turn + bend);
  Rows J(6, std::vector<Number>(2));
  J[0] = {-y - b, -b};
  J[1] = {x + a, a};
  J[5] = {1, 1};
  const Number along = std::cos(bend) / 2;
  const Rows mass{{5.0L / 3 + 2 * along, 1.0L / 3 + along}, {1.0L / 3 + along, 1.0L / 3}};
  return product(J, solved(mass, transposed(J)));
}

void expect_pseudo_inverse(const Rows& W, const Rows& inertia) {
  const Rows again = product(product(W, inertia), W), once = product(product(inertia, W), inertia);
  for (std::size_t i = 0; i < W.size(); ++i) {
    for (std::size_t j = 0; j < W.size(); ++j) {
      EXPECT_NEAR(static_cast<double>(again[i][j]), static_cast<double>(W[i][j]), 1e-13) << i << ", " << j;
      EXPECT_NEAR(static_cast<double>(once[i][j]), static_cast<double>(inertia[i][j]), 1e-13) << i << ", " << j;
    }
  }
}

TEST(OperationalInertia, OfAnArmOfFewFreedomsIsAPseudoInverse) {
  const Rows W = plane_arm(0.3L, 1.1L);
  const auto whole = operational_inertia(by_columns(W));
  EXPECT_EQ(whole.evaluation, Evaluation::singular);
  EXPECT_EQ(whole.rank, 2);
  expect_pseudo_inverse(W, numbers(whole.inertia));
  EXPECT_EQ(whole.inertia(2, 2), 0.0);  // nothing moves out of the plane, and no force is asked for there
  const std::array plane{TwistRow::x, TwistRow::y};
  EXPECT_EQ(operational_inertia(by_columns(W), plane).evaluation, Evaluation::ok);
  EXPECT_EQ(operational_inertia(by_columns(W), std::array{TwistRow::z}).rank, 0);
}

// Stretched, whatever the directions: along the axes a row is zero, aslant the rows differ by rounding alone.
TEST(OperationalInertia, OfAStretchedArmKnowsItsDirectionWithoutMotion) {
  const std::array plane{TwistRow::x, TwistRow::y};
  for (const Number turn : {0.0L, 0.3L, 2.0L}) {
    const Rows W = plane_arm(turn, 0);
    const auto task = operational_inertia(by_columns(W), plane);
    EXPECT_EQ(task.evaluation, Evaluation::singular);
    EXPECT_EQ(task.rank, 1);
    expect_pseudo_inverse(block(W, plane), numbers(task.inertia));
    EXPECT_EQ(operational_inertia(by_columns(plane_arm(turn, 1e-7L)), plane).rank, 1);
    expect_inverse<double>(plane_arm(turn, 1e-3L), plane, 1.0, 1e8 * epsilon);  // of condition 1e7
  }
}

// A wrist's centre: what it moves by is rounding of the places of joints, and three such rows are no inertia of 1e33 kg.
TEST(OperationalInertia, IsNoneWhereThePointOnlyTurns) {
  Arm wrist(4, 3, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    for (Number& entry : wrist.jacobian[i]) entry *= 1e-16L;
  }
  const auto task = operational_inertia(by_columns(wrist.inverse()), translation_rows);
  EXPECT_EQ(task.evaluation, Evaluation::singular);
  EXPECT_EQ(task.rank, 0);
  for (const double entry : task.inertia.entries) EXPECT_EQ(entry, 0.0);
  EXPECT_EQ(operational_inertia(by_columns(wrist.inverse()), rotation_rows).evaluation, Evaluation::ok);
  EXPECT_EQ(operational_inertia(by_columns(wrist.inverse())).rank, 3);
}

TEST(OperationalInertia, RefusesWhatIsNoInverseInertia) {
  Rows W = Arm(6, 7, 1).inverse();
  W[1][1] = -W[1][1];
  EXPECT_EQ(operational_inertia(by_columns(W), translation_rows).evaluation, Evaluation::singular);
  W[4][1] = std::numeric_limits<Number>::quiet_NaN();
  const auto task = operational_inertia(by_columns(W), translation_rows);
  EXPECT_EQ(task.evaluation, Evaluation::not_finite);
  EXPECT_TRUE(std::isnan(task.inertia(0, 0)));
  EXPECT_EQ(operational_inertia(std::array<double, 36>{}).rank, 0);
}

}  // namespace
}  // namespace operational_inertia_test
