// SPDX-License-Identifier: GPL-3.0-or-later
// Random bodies with more contacts than those of which all regimes are tried: rest is found where it is possible, and only there.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include "torsor/runtime/contacts/contact_solver.hpp"

namespace random_rest_test {
namespace {

using namespace torsor::runtime;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Freedoms with masses 1, rows of contacts, coefficients of friction and the load.
struct Scene {
  int tangents;
  MatrixXd J;
  std::vector<double> f;
  VectorXd load;

  [[nodiscard]] int count() const { return static_cast<int>(f.size()); }
  [[nodiscard]] int rows() const { return 1 + tangents; }
  [[nodiscard]] auto rows_of(int contact) const { return J.middleRows(rows() * contact, rows()); }

  /// Its contacts in another order.
  [[nodiscard]] ContactProblem problem(const std::vector<int>& order) const {
    MatrixXd ordered(J.rows(), J.cols());
    ContactProblem problem;
    for (const int i : order) {
      ordered.middleRows(rows() * problem.count, rows()) = rows_of(i);
      problem.laws[static_cast<std::size_t>(problem.count++)] = coulomb(tangents, f[static_cast<std::size_t>(i)]);
    }
    problem.W = ordered * ordered.transpose();
    problem.q = ordered * load;
    return problem;
  }
  /// What is left of the load by reactions in that order.
  [[nodiscard]] VectorXd left(const std::vector<int>& order, const ContactVector& r) const {
    VectorXd sum = load;
    for (std::size_t k = 0; k < order.size(); ++k) {
      sum += rows_of(order[k]).transpose() * r.segment(rows() * static_cast<int>(k), rows());
    }
    return sum;
  }
};

// The nearest force in the cone |T| <= f N.
void project(Eigen::Ref<VectorXd> r, double f) {
  const double N = r(0), T = r.tail(r.size() - 1).norm();
  if (T <= f * N) return;
  const double along = (N + f * T) / (1 + f * f);
  if (!(along > 0)) {
    r.setZero();
    return;
  }
  r.tail(r.size() - 1) *= f * along / T;
  r(0) = along;
}

VectorXd forces_in_cones(const Scene& scene, std::mt19937& source, double part) {
  std::uniform_real_distribution<double> number;
  std::normal_distribution<double> normal;
  VectorXd r(scene.J.rows());
  for (int i = 0; i < scene.count(); ++i) {
    VectorXd own(scene.rows());
    own(0) = number(source) < 0.3 ? 0 : number(source);
    VectorXd T(scene.tangents);
    for (int k = 0; k < scene.tangents; ++k) T(k) = normal(source);
    own.tail(scene.tangents) = part * scene.f[static_cast<std::size_t>(i)] * own(0) * T.normalized();
    r.segment(scene.rows() * i, scene.rows()) = own;
  }
  return r;
}

Scene random_scene(std::mt19937& source) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> number;
  Scene scene;
  scene.tangents = source() % 2 == 0 ? 1 : 2;
  const int count = 7 + static_cast<int>(source() % 6), freedoms = 3 + static_cast<int>(source() % 9);
  scene.J.resize((1 + scene.tangents) * count, freedoms);
  for (Eigen::Index i = 0; i < scene.J.size(); ++i) scene.J(i) = normal(source);
  for (int i = 0; i < count; ++i) scene.f.push_back(0.1 + 0.6 * number(source));
  return scene;
}

/// The least |load + Jᵀ r| that forces in their cones leave, by projected gradients with momentum (Nesterov).
double least_left(const Scene& scene) {
  const double step = 1 / (scene.J * scene.J.transpose()).trace();
  VectorXd r = VectorXd::Zero(scene.J.rows()), ahead = r;
  double weight = 1;
  for (int k = 0; k < 30000; ++k) {
    const VectorXd before = r;
    r = ahead - step * (scene.J * (scene.load + scene.J.transpose() * ahead));
    for (int i = 0; i < scene.count(); ++i) {
      project(r.segment(scene.rows() * i, scene.rows()), scene.f[static_cast<std::size_t>(i)]);
    }
    const double next = (1 + std::sqrt(1 + 4 * weight * weight)) / 2;
    const bool turns = (ahead - r).dot(r - before) > 0;
    ahead = turns ? r : VectorXd(r + (weight - 1) / next * (r - before));
    weight = turns ? 1 : next;
  }
  return (scene.load + scene.J.transpose() * r).norm();
}

std::vector<int> shuffled(int count, std::mt19937& source) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), source);
  return order;
}

// Loads that forces in the cones hold, some with all friction at its bound.
TEST(RandomRest, IsFoundWhereForcesHoldTheLoad) {
  std::mt19937 source(20261128);
  for (int k = 0; k < 150; ++k) {
    Scene scene = random_scene(source);
    const VectorXd forces = forces_in_cones(scene, source, k % 3 == 0 ? 1 : 0.9);
    scene.load = -scene.J.transpose() * forces;
    std::array<ContactVerdict, 2> verdicts{};
    for (ContactVerdict& verdict : verdicts) {
      const std::vector<int> order = shuffled(scene.count(), source);
      const ContactProblem problem = scene.problem(order);
      const ContactAnswer answer = solve_contacts(problem);
      ASSERT_TRUE(answer) << k;
      verdict = answer.verdict;
      const ContactSolution& s = answer.best();
      EXPECT_EQ(s.u.norm(), 0) << k;
      EXPECT_LE(scene.left(order, s.r).norm(), 1e-10 * scene.load.norm()) << k;
      EXPECT_LE(natural_map_residual(problem, s), 1e-12) << k;
      // More components inside their bounds than equations.
      const bool free = k % 3 != 0 && (forces.array() != 0).count() > scene.J.cols();
      EXPECT_TRUE(s.indeterminate || !free) << k;
    }
    EXPECT_EQ(verdicts[0], verdicts[1]) << k;
  }
}

TEST(RandomRest, IsFoundNowhereElse) {
  std::mt19937 source(1128);
  std::normal_distribution<double> normal;
  int rest = 0, move = 0;
  for (int k = 0; k < 60; ++k) {
    Scene scene = random_scene(source);
    scene.load = -scene.J.transpose() * forces_in_cones(scene, source, 1);
    const double size = 0.3 * scene.load.norm();
    for (double& each : scene.f) each *= 0.6;
    for (Eigen::Index i = 0; i < scene.load.size(); ++i) scene.load(i) += size * normal(source);
    const double least = least_left(scene) / scene.load.norm();
    if (least > 1e-9 && least < 1e-4) continue;  // as good as at the limit
    const bool rests = least <= 1e-9;
    ++(rests ? rest : move);
    VectorXd a;
    for (int repeat = 0; repeat < 2; ++repeat) {
      const std::vector<int> order = shuffled(scene.count(), source);
      const ContactAnswer answer = solve_contacts(scene.problem(order));
      ASSERT_TRUE(answer) << k;
      EXPECT_EQ(answer.best().u.norm() == 0, rests) << k << ' ' << least;
      const VectorXd found = scene.left(order, answer.best().r);
      if (repeat == 0) a = found;
      EXPECT_LE((found - a).norm(), 1e-9 * scene.load.norm()) << k;
    }
  }
  EXPECT_GT(rest, 5);
  EXPECT_GT(move, 20);
}

}  // namespace
}  // namespace random_rest_test
