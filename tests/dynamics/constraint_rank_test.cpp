// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/constraint_rank.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "tests/dynamics/constrained_motion.hpp"
#include "tests/program/test_symbols.hpp"
#include "tests/scenes/loops.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::constraint_rank_test {
namespace {

using namespace testing_symbols;
using namespace testing_mechanisms;
using namespace literals;
using Indices = std::vector<std::size_t>;
using Flags = std::vector<bool>;

// Values of sixty digits: what is equal is equal to 1e-45.
constexpr double exact = 1e-45;

TEST(ConstraintRank, KeepsAllRowsOfALoopThatNeedsThem) {
  FourBar bars("planar");
  bars.close();
  const ConstraintRank rank = constraint_rank(bars.scene);
  EXPECT_EQ(rank.kept, (Indices{0, 1}));
  EXPECT_FALSE(rank.redundant());
  EXPECT_EQ(rank.determinate, (Flags{true, true}));
  EXPECT_FALSE(rank.singular_start());
}

// A spatial revolute joint holds five directions of a loop whose plane holds three of them already: h = 3.
TEST(ConstraintRank, MovesFourBarsClosedByASpatialPinAsByAPlanarOne) {
  const WorkingDigits precision(60);
  FourBar planar("planar");
  planar.close();
  FourBar spatial("spatial");
  const auto ends = spatial.ends();
  spatial.scene.loop_joint("pin", {.type = JointType::revolute, .a = ends.first, .b = ends.second});
  EXPECT_EQ(error_of([&] { validate(spatial.scene); }), "no error");

  const Equations one(planar.scene), other(spatial.scene);
  const ConstraintRank& rank = other.redundancy();
  ASSERT_EQ(other.constraints().size(), 5U);  // pin_x along the pin, y and z across it, ry and rz
  EXPECT_EQ(rank.kept, (Indices{1, 2}));
  EXPECT_EQ(rank.dropped, (Indices{0, 3, 4}));
  EXPECT_EQ(rank.determinate, (Flags{false, true, true, false, false}));
  EXPECT_FALSE(rank.singular_start());

  const ConstrainedMotion motion(one);
  ConstrainedMotion::State state{
      {rational(6, 5), rational(-4, 5), rational(13, 10)}, {rational(7, 5), Real(0), Real(0)}, {}};
  motion.satisfy(state, {0, 1}, {1, 2}, {0, 1}, {1, 2});
  Evaluator<Real> first = motion.at(state);
  const ConstrainedMotion same(other);
  Evaluator<Real> second = same.at(state);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(relative_difference(second(other.forward().accelerations[i]), first(one.forward().accelerations[i])),
              exact);
  }
  // The force on the rocker, in ground axes and along the axes of the coupler's end: y_tip = y, z_tip = −x of the link.
  const Real x = first(one.forward().multipliers[0]), y = first(one.forward().multipliers[1]);
  const Real angle = state.q[0] + state.q[1];
  const std::vector<Real> pin = second(other.forward().multipliers);
  EXPECT_LT(relative_difference(pin[1], cos(angle) * y - sin(angle) * x), exact);
  EXPECT_LT(relative_difference(abs(pin[2]), abs(cos(angle) * x + sin(angle) * y)), exact);
  for (const std::size_t j : {0U, 3U, 4U}) EXPECT_TRUE(pin[j].is_zero());
}

/// A door free in space, held by joints at two places of its axis z, with gravity aslant.
struct Door {
  Scene scene;
  FrameHandle door, lower, upper, lower_frame, upper_frame;

  Door(const std::string& name, JointType lower_type, JointType upper_type) : scene(name) {
    const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
    const Expression p = scene.coordinate("p", "rad"), r = scene.coordinate("r", "rad"),
                     q = scene.coordinate("q", "rad");
    door = scene.free("door", scene.ground(), {x, y, z}, {.sequence = AngleSequence{{0, 1, 2}}, .angles = {p, r, q}});
    scene.body("door", door,
               Inertia::general({.mass = kilograms("20"), .xx = moment("8"), .yy = moment("7"),
                                 .zz = moment("2"), .xy = moment("0.2"), .xz = moment("0.3")})
                   .at({metres("0.4"), metres("0.1"), metres("0.9")}));
    scene.gravity({quantity("3", "m/s^2"), quantity("1", "m/s^2"), quantity("-9", "m/s^2")});
    const Rotation x_up = Rotation::about(1, -6);
    const Triple high{0, 0, metres("2")};
    lower_frame = scene.weld("lower_frame", scene.ground(), {{0, 0, 0}, x_up});
    upper_frame = scene.weld("upper_frame", scene.ground(), {high, x_up});
    lower = scene.weld("lower", door, {{0, 0, 0}, x_up});
    upper = scene.weld("upper", door, {high, x_up});
    scene.loop_joint("low", {.type = lower_type, .a = lower_frame, .b = lower});
    scene.loop_joint("high", {.type = upper_type, .a = upper_frame, .b = upper});
    scene.initial(q, 0, quantity("0.7", "rad/s"));
  }
};

/// Acceleration of a door on one hinge: J q̈ = m z · (OG ∧ g), J about the axis, at the angle q.
Real door_acceleration(const Real& q) {
  const Real x = rational(4, 10), y = rational(1, 10), m = Real(20);
  const Real inertia = Real(2) + m * (x * x + y * y);
  const Real gx = cos(q) * x - sin(q) * y, gy = sin(q) * x + cos(q) * y;
  return m * (gx * Real(1) - gy * Real(3)) / inertia;
}

ConstrainedMotion::State turned_door() {
  return {{Real(0), Real(0), Real(0), Real(0), Real(0), rational(3, 5)},
          {Real(0), Real(0), Real(0), Real(0), Real(0), rational(9, 10)},
          {}};
}

TEST(ConstraintRank, OpensADoorOnTwoHinges) {
  const WorkingDigits precision(60);
  const Door door("door", JointType::revolute, JointType::revolute);
  EXPECT_EQ(error_of([&] { validate(door.scene); }), "no error");
  const Equations equations(door.scene);
  EXPECT_EQ(equations.redundancy().kept, (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(equations.redundancy().dropped, (Indices{5, 6, 7, 8, 9}));
  // Either hinge could hold the door alone: nothing about them is determinate.
  EXPECT_EQ(equations.redundancy().determinate, Flags(10, false));
  const ConstrainedMotion motion(equations);
  const auto state = turned_door();
  Evaluator<Real> here = motion.at(state);
  const std::vector<Real> a = here(equations.forward().accelerations);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LT(abs(a[i]).to_double(), exact) << i;
  EXPECT_LT(relative_difference(a[5], door_acceleration(state.q[5])), exact);
}

// Two ball joints leave the door its turn and share only the force along the axis as they like.
TEST(ConstraintRank, FindsTheOneIndeterminateForceOfADoorOnTwoBalls) {
  const WorkingDigits precision(60);
  const Door balls("balls", JointType::spherical, JointType::spherical);
  const Door slider("slider", JointType::spherical, JointType::sphere_in_cylinder);
  const Equations two(balls.scene), minimal(slider.scene);
  EXPECT_FALSE(minimal.redundancy().redundant());
  EXPECT_EQ(two.redundancy().kept, (Indices{0, 1, 2, 4, 5}));
  EXPECT_EQ(two.redundancy().dropped, (Indices{3}));  // high_x, along the axis
  EXPECT_EQ(two.redundancy().determinate, (Flags{false, true, true, false, true, true}));
  const auto state = turned_door();
  const ConstrainedMotion of_two(two), of_minimal(minimal);
  Evaluator<Real> first = of_two.at(state), second = of_minimal.at(state);
  const std::vector<Real> shared = first(two.forward().multipliers), alone = second(minimal.forward().multipliers);
  for (const auto& [i, j] : std::vector<std::pair<std::size_t, std::size_t>>{{0, 0}, {1, 1}, {2, 2}, {4, 3}, {5, 4}}) {
    EXPECT_LT(relative_difference(shared[i], alone[j]), exact) << i;
  }
  EXPECT_TRUE(shared[3].is_zero());
}

/// Six times one freedom and a closed loop: it should not move, and does.
TEST(ConstraintRank, MovesBennettsLinkage) {
  const WorkingDigits precision(60);
  Scene scene = bennett();
  for (const char* name : {"first", "second", "third"}) {
    scene.body(name, name, Inertia::solid_sphere(kilograms("1"), metres("0.2")).at({metres("0.5"), metres("0.1"), 0}));
  }
  scene.gravity({0, quantity("2", "m/s^2"), quantity("-9", "m/s^2")});
  EXPECT_EQ(error_of([&] { validate(scene); }), "no error");
  const Equations equations(scene);
  EXPECT_EQ(equations.redundancy().kept.size(), 2U);
  EXPECT_EQ(equations.redundancy().dropped.size(), 3U);

  // On the way: every row holds, those left out too, and so do their accelerations.
  const ConstrainedMotion motion(equations);
  const Real angle = rational(9, 5);
  ConstrainedMotion::State state{{angle, rational(19, 10), -angle}, {rational(11, 10), Real(0), Real(0)}, {}};
  const Indices kept = equations.redundancy().kept;
  motion.satisfy(state, kept, {1, 2}, kept, {1, 2});
  EXPECT_LT(relative_difference(state.q[2], -angle), exact);
  const auto tangent = [](const Real& x) { return sin(x) / cos(x); };
  EXPECT_LT(relative_difference(tangent(state.q[0] / Real(2)) * tangent(state.q[1] / Real(2)), sqrt(Real(3))), exact);
  Evaluator<Real> here = motion.at(state);
  const std::vector<Real> accelerations = here(equations.forward().accelerations);
  for (const ConstraintRow& row : equations.constraints()) {
    EXPECT_LT(abs(here(row.value)).to_double(), exact) << row.name;
    EXPECT_LT(abs(here(row.rate)).to_double(), exact) << row.name;
    Real sum = here(row.gamma);
    for (std::size_t i = 0; i < 3; ++i) sum += here(row.jacobian[i]) * accelerations[i];
    EXPECT_LT(abs(sum).to_double(), exact) << row.name;
  }
  EXPECT_LT(relative_difference(accelerations[2], -accelerations[0]), exact);
}

// A parallelogram laid flat can go on as one or as a crossed one: a change point.
TEST(ConstraintRank, ReportsAStartWhereTheLoopBranches) {
  const ConstraintRank rank = constraint_rank(parallelogram(Angle::of_the_joint, 0));
  EXPECT_EQ(rank.rank_at_start, 1U);
  EXPECT_EQ(rank.kept, (Indices{0, 1}));
  EXPECT_TRUE(rank.singular_start());
}

/// Cranks of 0.3 m in a row, each tied to the next by a bar of 1 m, all laid flat: a change point of every window.
Scene folded_parallelograms(int windows, bool pins) {
  Scene scene("windows");
  const auto name = [](const char* what, int i) { return what + std::to_string(i); };
  std::vector<FrameHandle> cranks;
  for (int i = 0; i <= windows; ++i) {
    const Expression place = Expression(i) * metres("1");
    const Expression q = scene.coordinate(name("q", i), "rad");
    cranks.push_back(scene.revolute(name("crank", i), scene.ground(), axis::z, q, {.origin = {place, 0, 0}}));
    scene.body(name("crank", i), cranks.back(), Inertia::rod(kilograms("1"), metres("0.3"), 0));
  }
  for (int i = 0; i < windows; ++i) {
    const FrameHandle& crank = cranks[static_cast<std::size_t>(i)];
    const Expression turn = scene.coordinate(name("turn", i), "rad");
    const FrameHandle bar = scene.revolute(name("bar", i), crank, axis::z, turn, {{metres("0.3"), 0, 0}});
    scene.body(name("bar", i), bar, Inertia::rod(kilograms("1"), metres("1"), 0));
    const FrameHandle& next = cranks[static_cast<std::size_t>(i) + 1];
    if (pins) {
      const FrameHandle end = scene.weld(name("end", i), bar, x_along_z({metres("1"), 0, 0}));
      const FrameHandle tip = scene.weld(name("tip", i), next, x_along_z({metres("0.3"), 0, 0}));
      scene.loop_joint(name("pin", i), {.type = JointType::revolute, .a = end, .b = tip});
    } else {
      const PointHandle end = scene.point(name("end", i), bar, {metres("1"), 0, 0});
      const PointHandle tip = scene.point(name("tip", i), next, {metres("0.3"), 0, 0});
      scene.closure(name("x", i), end, tip, axis::x);
      scene.closure(name("y", i), end, tip, axis::y);
    }
  }
  return scene;
}

TEST(ConstraintRank, FindsAWayOnWhereManyLoopsBranchAtOnce) {
  for (const bool pins : {false, true}) {
    for (const int windows : {1, 2, 3, 5, 8, 12}) {
      const Scene scene = folded_parallelograms(windows, pins);
      ASSERT_EQ(error_of([&] { validate(scene); }), "no error") << windows;
      const ConstraintRank rank = constraint_rank(scene);
      const auto count = static_cast<std::size_t>(windows);
      EXPECT_TRUE(rank.closed && rank.singular_start());
      EXPECT_EQ(rank.kept.size(), 2 * count);  // one freedom is left of 2 windows + 1
      EXPECT_EQ(rank.rank_at_start, count);    // across the bars only
      EXPECT_EQ(rank.dropped.size(), pins ? 3 * count : 0U);
    }
  }
}

Scene two_laws(const Expression& second, bool as_rate, const Expression& factor = Expression(1)) {
  SlidingPoint it("laws");
  Scene& scene = it.scene;
  const Expression x = it.x;
  const Expression t = scene.time(), law = x - quantity("2", "m/s") * t;
  scene.initial(x, 0, quantity("2", "m/s"));
  scene.holonomic("first", law);
  const Expression more = second * t * t * t;
  if (as_rate)
    scene.nonholonomic("second", factor * (rate(x) - quantity("2", "m/s") + second * t * t));
  else
    scene.holonomic("second", factor * (Expression(3) * law + more));
  return scene;
}

TEST(ConstraintRank, RefusesConstraintsThatContradictEachOther) {
  const Expression none = quantity("0", "m/s^3"), some = quantity("0.5", "m/s^3");
  EXPECT_EQ(constraint_rank(two_laws(none, false)).dropped, (Indices{1}));
  EXPECT_EQ(constraint_rank(two_laws(none, true)).dropped, (Indices{1}));
  EXPECT_EQ(
      error_of<SceneError>([&] { constraint_rank(two_laws(some, false)); }),
      "constraint 'second' depends on those before it at the initial configuration, and no neighbouring "
      "configuration satisfies them all: it contradicts them, or the closed loop cannot move; drop it, or correct "
      "the dimensions");
  EXPECT_EQ(
      error_of<SceneError>([&] { constraint_rank(two_laws(some, true)); }),
      "constraint 'second' asks for a velocity that contradicts the constraints it depends on: no motion satisfies "
      "them all; drop it or correct its law of time");
}

// A constraint may be written in any unit: what it says, and so what it contradicts, is the same.
TEST(ConstraintRank, JudgesContradictionsInAnyUnit) {
  const Expression none = quantity("0", "m/s^3"), some = quantity("0.5", "m/s^3");
  for (const Expression& factor : {1e-9_r, Expression(1), Expression(1000000000)}) {
    for (const bool as_rate : {false, true}) {
      EXPECT_EQ(constraint_rank(two_laws(none, as_rate, factor)).dropped, (Indices{1})) << factor.to_string();
      EXPECT_THROW(constraint_rank(two_laws(some, as_rate, factor)), SceneError) << factor.to_string() << ' ' << as_rate;
    }
  }
}

TEST(ConstraintRank, RefusesAPinThatMissesThePlaneOfItsLoop) {
  FourBar bars("bent");
  const Rotation x_up = Rotation::about(1, -6);
  const FrameHandle tip = bars.scene.weld("tip", bars.coupler, {{metres("2"), 0, metres("0.1")}, x_up});
  const FrameHandle end = bars.scene.weld("end", bars.rocker, {{metres("1.5"), 0, 0}, x_up});
  bars.scene.loop_joint("pin", {.type = JointType::revolute, .a = tip, .b = end});
  EXPECT_EQ(
      error_of<SceneError>([&] { validate(bars.scene); }),
      "constraint 'pin_x' involves no coordinate: no motion can satisfy or violate it; drop it or write it with the "
      "scene's coordinates");
}

TEST(ConstraintRank, RefusesFrictionOfAnIndeterminateNormal) {
  Scene scene("table");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle block = scene.prismatic("block", scene.prismatic("slide", scene.ground(), axis::x, x), axis::z, z);
  scene.body("block", block, Inertia::point(kilograms("1")));
  const PointHandle left = scene.point("left", block, {0, 0, 0}),
                    right = scene.point("right", block, {metres("1"), 0, 0});
  const ConstraintHandle first = scene.point_in_plane("first", left, scene.ground());
  scene.point_in_plane("second", right, scene.ground());
  scene.sliding_friction(
      "friction", first,
      {.coefficient = Expression(1) / 5, .body = block, .point = left, .direction = axis::x, .axes = scene.ground()});
  EXPECT_EQ(error_of<SceneError>([&] { constraint_rank(scene); }),
            "constraint 'first' carries friction but repeats other constraints: its normal force is indeterminate, and "
            "the motion with it; release one of the constraints");
}

}  // namespace
}  // namespace torsor::constraint_rank_test
