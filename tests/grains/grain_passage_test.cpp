// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/grains/grain_passage.hpp"

#include <gtest/gtest.h>

#include "torsor/runtime/grains/grain_motion.hpp"

namespace grain_passage_test {
namespace {

using namespace torsor::runtime;

// Two discs that fly towards each other, and one towards a segment: what happens to them at any step is a blow, or the
// status says that the step is too long for it.
TEST(GrainPassage, SaysThatGrainsPassThroughEachOther) {
  for (const double speed : {0.3, 1.0, 3.0, 10.0, 100.0}) {
    for (const double gap : {0.005, 0.013, 0.051, 0.13}) {
      Grains<2> grains;
      grains.gravity.setZero();
      const double R = 0.01, h = 0.01;
      grains.add({0, 0}, R, 1, {speed, 0});
      grains.add({2 * R + gap, 0}, R, 1, {-speed, 0});
      GrainMotion<2> motion(grains);
      bool said = false;
      for (int k = 0; k < 3 + gap / (speed * h); ++k) said = motion.step(h).status == GrainStatus::too_fast || said;
      EXPECT_TRUE(said || grains.x[0](0) < grains.x[1](0)) << speed << ' ' << gap;
      EXPECT_FALSE(said && speed * h < R / 2) << speed << ' ' << gap;
    }
  }
}
TEST(GrainPassage, SaysThatAGrainPassesThroughASegment) {
  for (const double speed : {0.3, 1.0, 3.0, 10.0, 50.0}) {
    for (const double place : {0.1, 0.22, 0.31}) {
      Grains<2> grains;
      grains.gravity.setZero();
      GrainWall<2> wall;
      wall.shape = GrainWall<2>::Shape::segment;
      wall.point = {0.5, -1};
      wall.end = {0.5, 1};
      grains.walls.push_back(wall);
      grains.add({place, 0}, 0.01, 1, {speed, 0});
      GrainMotion<2> motion(grains);
      bool said = false;
      for (int k = 0; k < 3 + 0.5 / (speed * 0.01); ++k) said = motion.step(0.01).status == GrainStatus::too_fast || said;
      EXPECT_TRUE(said || grains.x[0](0) < 0.5) << speed << ' ' << place;
      EXPECT_FALSE(said && speed < 0.5) << speed << ' ' << place;
    }
  }
}
// A blow from outside between two steps is seen before the grains have moved by it.
TEST(GrainPassage, SeesVelocitiesThatAreSetBetweenSteps) {
  Grains<2> grains;
  grains.gravity.setZero();
  grains.add({0, 0}, 0.01, 1, {0, 0});
  grains.add({0.03, 0}, 0.01, 1, {0, 0});
  GrainMotion<2> motion(grains);
  EXPECT_EQ(motion.step(0.02).status, GrainStatus::ok);
  grains.v[0] = {3.5, 0};
  EXPECT_EQ(motion.step(0.02).status, GrainStatus::too_fast);
}
// Grains that pass beside each other, or meet where they look for contacts, do nothing that needs a word.
TEST(GrainPassage, IsNoneBesideEachOther) {
  Grains<2> grains;
  grains.gravity.setZero();
  grains.add({0, 0}, 0.01, 1, {1.5, 0});
  grains.add({0.1, 0.021}, 0.01, 1, {-1.5, 0});
  GrainMotion<2> motion(grains);
  for (int k = 0; k < 10; ++k) EXPECT_EQ(motion.step(0.01).status, GrainStatus::ok) << k;
  EXPECT_GT(grains.x[0](0), grains.x[1](0));
}
// A shower falls as one: nothing passes anything, however fast it is.
TEST(GrainPassage, LetsGrainsFallTogetherAsFastAsTheyLike) {
  Grains<2> grains;
  for (int i = 0; i < 20; ++i) grains.add({0.03 * i, 5.0}, 0.01, 1, {0, -50});
  grains.walls.push_back({.normal = {0, 1}});
  GrainMotion<2> motion(grains);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(motion.step(0.01).status, GrainStatus::ok) << k;
  for (const auto& x : grains.x) EXPECT_GE(x(1), 0.0);
}

}  // namespace
}  // namespace grain_passage_test
