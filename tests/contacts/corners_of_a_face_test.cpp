// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of a face of one body: slips that others hold need no search, and nothing is lost without it.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

#include "torsor/runtime/contacts/regime_enumeration.hpp"
#include "tests/long_tests.hpp"

namespace corners_of_a_face_test {
namespace {

using namespace torsor::runtime;
using torsor::wanted;
using Eigen::Vector3d;

/// A box of mass 1 on those corners of its lower face that the bits of `which` name.
ContactProblem box_on(unsigned which, const Vector3d& push, const Vector3d& turn, double f) {
  ContactProblem problem;
  Eigen::Matrix<double, 12, 6> J;
  int rows = 0;
  for (unsigned corner = 0; corner < 4; ++corner) {
    if ((which >> corner & 1U) == 0) continue;
    const Vector3d place{corner / 2 == 0 ? -0.15 : 0.15, corner % 2 == 0 ? -0.05 : 0.05, -0.1};
    for (const int axis : {2, 0, 1}) {
      const Vector3d along = Vector3d::Unit(axis);
      J.row(rows).head<3>() = along;
      J.row(rows++).tail<3>() = place.cross(along);
    }
    problem.laws[static_cast<std::size_t>(problem.count++)] = coulomb(2, f);
  }
  Eigen::Matrix<double, 6, 1> mobility, a;
  mobility << 1, 1, 1, 12 / 0.13, 12 / 0.05, 12 / 0.1;
  a << push, turn;
  problem.W = J.topRows(rows) * mobility.asDiagonal() * J.topRows(rows).transpose();
  problem.q = J.topRows(rows) * a;
  return problem;
}

bool has(const ContactAnswer& answer, const ContactSolution& motion) {
  const auto* const first = answer.solutions.data();
  return std::any_of(first, first + answer.count, [&](const ContactSolution& each) {
    return (each.u - motion.u).cwiseAbs().maxCoeff() <= 1e-7 * std::max(1.0, motion.u.cwiseAbs().maxCoeff());
  });
}

// Every regime tried without relations is the truth. Families of motions are met at one member, which depends on the way.
TEST(CornersOfAFace, HaveAllMotionsWithoutASearchOfWhatIsHeld) {
  const int tries = wanted(4, 300);
  std::mt19937 source(20);
  std::normal_distribution<double> normal;
  int motions = 0, rests = 0;
  for (const unsigned which : {3U, 5U, 9U, 7U, 13U, 15U}) {
    for (const double f : {0.05, 0.2, 0.8}) {
      for (int k = 0; k < tries; ++k) {
        const double turns = k % 2 == 0 ? 5 : 60;
        const Vector3d push{2 * normal(source), 2 * normal(source), -9.81};
        const Vector3d turn{turns * normal(source), turns * normal(source), turns * normal(source)};
        const ContactProblem problem = box_on(which, push, turn, f);
        const ContactAnswer all = RegimeEnumeration(problem, false).run(), related = RegimeEnumeration(problem).run();
        SCOPED_TRACE(testing::Message() << which << " " << f << " " << k);
        ASSERT_EQ(all.count == 0, related.count == 0);
        motions += static_cast<int>(all.count);
        rests += all.count > 0 && all.best().u.isZero(0) ? 1 : 0;
        for (std::size_t i = 0; i < all.count; ++i) {
          EXPECT_TRUE(all.solutions[i].moves || has(related, all.solutions[i])) << i;
        }
        for (std::size_t i = 0; i < related.count; ++i) {
          EXPECT_LE(related.solutions[i].residual, 1e-13);
          EXPECT_TRUE(related.solutions[i].moves || has(all, related.solutions[i])) << i;
        }
        // One motion is one: a slip of size zero in any direction is no family of others.
        const bool one = related.count == 1 && !related.best().moves;
        EXPECT_FALSE(one && related.verdict == ContactVerdict::several);
      }
    }
  }
  EXPECT_GT(motions, 18 * tries);
  EXPECT_GT(rests, 2 * tries);
}

}  // namespace
}  // namespace corners_of_a_face_test
