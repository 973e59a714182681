// SPDX-License-Identifier: GPL-3.0-or-later
// Three feet of a walking machine that begin to slip at one time, each in a direction of its own.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

#include "torsor/runtime/contacts/contact_solver.hpp"

namespace slips_together_test {
namespace {

using namespace torsor::runtime;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int feet = 3;

struct Made {
  ContactProblem problem;
  ContactVector u;  ///< the motion that it was made of
};

/// A body of mass 1 and moments of inertia 1, on legs of three freedoms each. The motion is given first: where each foot
/// slips, and how hard it is pressed. Coulomb's law gives the reactions, and q = u − W r the problem that has this motion.
Made made(unsigned seed, double most_friction) {
  std::mt19937 random(seed);
  const auto between = [&random](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3 * feet, 6 + 3 * feet);
  const double legs = std::pow(10, between(-1, 0.5));
  for (int foot = 0; foot < feet; ++foot) {
    Vector3d r;
    for (double& each : r) each = between(-2, 2);
    const Matrix3d turned = (Matrix3d() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0).finished();
    Matrix3d leg;
    for (double& each : leg.reshaped()) each = legs * (between(-1, 1) + between(-1, 1) + between(-1, 1));
    A.block<3, 3>(3 * foot, 0).setIdentity();
    A.block<3, 3>(3 * foot, 3) = turned;
    A.block<3, 3>(3 * foot, 6 + 3 * foot) = leg;
  }
  Made result;
  result.problem.count = feet;
  result.problem.W = A * A.transpose();
  result.u = ContactVector::Zero(3 * feet);
  ContactVector r = result.u;
  for (int foot = 0; foot < feet; ++foot) {
    const double f = between(0.05, most_friction), N = between(0.1, 2), slip = std::pow(10, between(-2, 1));
    const double angle = between(0, 2 * std::numbers::pi);
    result.problem.laws[static_cast<std::size_t>(foot)] = coulomb(2, f);
    r.segment<3>(3 * foot) << N, -f * N * std::cos(angle), -f * N * std::sin(angle);
    result.u.segment<3>(3 * foot) << 0, slip * std::cos(angle), slip * std::sin(angle);
  }
  result.problem.q = result.u - result.problem.W * r;
  return result;
}

// Whether the motion is among those found. Cancellation in q leaves 1e-15 of the largest numbers, which a factor of a thousand in
// the inverse of W makes no more than 1e-9.
bool finds(const Made& made) {
  const ContactAnswer answer = solve_contacts(made.problem);
  const double size = made.u.norm() + made.problem.q.norm();
  return std::any_of(answer.solutions.begin(), answer.solutions.begin() + static_cast<std::ptrdiff_t>(answer.count),
                     [&](const ContactSolution& each) { return (each.u - made.u).norm() <= 1e-9 * size; });
}

// Each of these was missed by Newton's method from three directions of each slip, of some no motion was found at all.
TEST(SlipsTogether, OfThreeFeetAreFoundWhereverTheyGo) {
  for (const unsigned seed : {22U, 116U, 277U, 318U, 319U, 386U}) EXPECT_TRUE(finds(made(seed, 1))) << seed;
  for (const unsigned seed : {34U, 46U, 50U, 96U, 111U, 305U, 475U, 480U}) EXPECT_TRUE(finds(made(seed, 3))) << seed;
}

}  // namespace
}  // namespace slips_together_test
