// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/grains/grain_passage.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
template <int dim>
GrainWall<dim> segment(const typename GrainWall<dim>::Vector& point, const typename GrainWall<dim>::Vector& end) {
  GrainWall<dim> wall;
  wall.shape = GrainWall<dim>::Shape::segment;
  wall.point = point;
  wall.end = end;
  return wall;
}

/// One grain of 1 cm that flies along x at a segment across its way, at x = 0.5 m.
template <int dim>
void expect_said_or_stopped() {
  using Vector = typename Grains<dim>::Vector;
  for (const double speed : {0.3, 1.0, 3.0, 10.0, 50.0}) {
    for (const double place : {0.1, 0.22, 0.31}) {
      Grains<dim> grains;
      grains.gravity.setZero();
      grains.walls.push_back(segment<dim>(0.5 * Vector::Unit(0) - Vector::Unit(1), 0.5 * Vector::Unit(0) + Vector::Unit(1)));
      grains.add(place * Vector::Unit(0), 0.01, 1, speed * Vector::Unit(0));
      GrainMotion<dim> motion(grains);
      bool said = false;
      for (int k = 0; k < 3 + 0.5 / (speed * 0.01); ++k) said = motion.step(0.01).status == GrainStatus::too_fast || said;
      EXPECT_TRUE(said || grains.x[0](0) < 0.5) << speed << ' ' << place;
      EXPECT_FALSE(said && speed < 0.5) << speed << ' ' << place;
    }
  }
}
TEST(GrainPassage, SaysThatAGrainPassesThroughASegment) { expect_said_or_stopped<2>(); }
TEST(GrainPassage, SaysThatASphereInSpacePassesThroughASegment) { expect_said_or_stopped<3>(); }

// A sphere of 1 cm and 10 cm a step, past the middle, an end or the line beyond an end of a segment across its way.
TEST(GrainPassage, InSpaceIsToldByTheLeastDistance) {
  const auto said = [](double along, double beside) {
    Grains<3> grains;
    grains.gravity.setZero();
    grains.walls.push_back(segment<3>({0.15, -1, 0}, {0.15, 1, 0}));
    grains.add({0.05, along, beside}, 0.01, 1, {10, 0, 0});
    GrainMotion<3> motion(grains);
    bool any = false;
    for (int k = 0; k < 4; ++k) any = motion.step(0.01).status == GrainStatus::too_fast || any;
    return any;
  };
  EXPECT_TRUE(said(0, 0.004));
  EXPECT_FALSE(said(0, 0.006));
  EXPECT_TRUE(said(1.004, 0));
  EXPECT_FALSE(said(1.006, 0));
  EXPECT_TRUE(said(-1.003, 0.003));
  EXPECT_FALSE(said(-1.005, 0.005));
  EXPECT_FALSE(said(2, 0));
}
// Contacts are looked for where the centre lies on the segment, or beside it by a rounding: it goes no further.
template <int dim>
void expect_stopped_on_a_segment() {
  using Vector = typename Grains<dim>::Vector;
  for (int turn = 0; turn < 40; ++turn) {
    Vector u = Vector::Zero(), across = Vector::Zero();
    u(0) = std::cos(0.1 + turn), u(dim - 1) = std::sin(0.1 + turn);
    across(0) = -u(dim - 1), across(dim - 1) = u(0);
    const Vector middle = 0.3 * Vector::Ones();
    Grains<dim> grains;
    grains.gravity.setZero();
    grains.walls.push_back(segment<dim>(middle - across, middle + across));
    grains.add(middle - 0.6 * u, 0.1, 1, 40 * u);
    GrainMotion<dim> motion(grains);
    bool said = false;
    for (int k = 0; k < 4; ++k) said = motion.step(0.01).status == GrainStatus::too_fast || said;
    EXPECT_TRUE(said || (grains.x[0] - middle).dot(u) < 0) << turn;
  }
}
TEST(GrainPassage, OfACentreOnASegmentIsNone) {
  expect_stopped_on_a_segment<2>();
  expect_stopped_on_a_segment<3>();
}
TEST(GrainPassage, OntoAnEndOfASegmentIsNone) {
  Grains<2> grains;
  grains.gravity.setZero();
  grains.walls.push_back(segment<2>({0, 0}, {1, 0}));
  grains.add({-0.6, 0}, 0.1, 1, {40, 0});
  GrainMotion<2> motion(grains);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(motion.step(0.01).status, GrainStatus::ok);
  EXPECT_LT(grains.x[0](0), 0);
}
TEST(GrainPassage, HasANormalOfAGrainThatLiesOnASegment) {
  const WallGap<3> lying = wall_gap<3>(segment<3>({-1, -1, 0}, {1, 1, 0}), {0, 0, 0}, 0.1);
  EXPECT_NEAR(std::abs(lying.n(2)), 1, 1e-15);
  EXPECT_EQ(lying.gap, -0.1);
  const WallGap<2> rolling = wall_gap<2>(segment<2>({-1, 0}, {1, 0}), {0.5, 0}, 0.1, {3, -4});
  EXPECT_EQ(rolling.n(1), 1);
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
