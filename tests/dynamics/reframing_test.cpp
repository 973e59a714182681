// SPDX-License-Identifier: GPL-3.0-or-later
// Frames in which turns between joints cost less, against the scene's own: the same results, from fewer operations.
#include "torsor/generator/dynamics/motion/reframing.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::reframing_test {
namespace {

using namespace testing_mechanisms;

Triple place(const char* x, const char* y, const char* z) {
  return {quantity(x, "m"), quantity(y, "m"), quantity(z, "m")};
}

/// Of a quaternion of integers: an exact rotation about a generic axis.
Rotation turned(int w, int x, int y, int z) {
  const Number two = Number(2) / Number(w * w + x * x + y * y + z * z), one(1);
  return Rotation::matrix({one - two * Number(y * y + z * z), two * Number(x * y - w * z), two * Number(x * z + w * y),
                           two * Number(x * y + w * z), one - two * Number(x * x + z * z), two * Number(y * z - w * x),
                           two * Number(x * z - w * y), two * Number(y * z + w * x),
                           one - two * Number(x * x + y * y)});
}

void add_body(Scene& s, const std::string& name, FrameHandle frame) {
  s.body(name, frame, generic_body());
}

enum class Base { fixed, quaternion };
enum class Actions { none, springs_and_forces };

/// A trunk that carries two branches with generic frames; sliders in both, axes of all kinds, one driven joint, motors;
/// if wanted a spring and a given force.
Scene generic_tree(Base base, Actions actions = Actions::springs_and_forces) {
  Scene s("generic_tree");
  std::vector<Expression> q;
  for (const char* name : {"a", "b", "c", "e", "f", "h"}) q.push_back(s.coordinate(name, "rad"));
  const Expression d = s.coordinate("d", "m"), g = s.coordinate("g", "m"), driven = s.coordinate("driven", "rad");
  s.drive(driven, pow(s.time() / quantity("1", "s"), 2));
  FrameHandle parent = s.ground();
  if (base == Base::quaternion) {
    parent = s.spherical("ball", s.ground(), s.attitude("e0"), {.origin = place("0.1", "0.2", "0.3")});
    add_body(s, "base", parent);
  }
  const FrameHandle trunk = s.revolute("trunk", parent, axis::z, q[0],
                                       {.origin = place("0.1", "0.3", "-0.2"), .rotation = turned(3, 1, -2, 1)});
  const FrameHandle upper = s.revolute("upper", trunk, -axis::y, q[1],
                                       {.origin = place("0.2", "-0.1", "0.4"), .rotation = turned(5, 2, 1, -3)});
  const FrameHandle slide =
      s.prismatic("slide", upper, axis::x, d, {.origin = place("0.1", "0.1", "0.2"), .rotation = turned(2, 1, 1, 3)});
  const FrameHandle wrist = s.revolute("wrist", slide, {1, 2, 2}, q[2],
                                       {.origin = place("-0.3", "0.1", "0.1"), .rotation = turned(4, -1, 2, 1)});
  const FrameHandle tip =
      s.revolute("tip", wrist, axis::z, q[3], {.origin = place("0.1", "0.2", "0.1"), .rotation = turned(1, 2, 3, 5)});
  const FrameHandle rotor = s.revolute("rotor", trunk, axis::x, driven,
                                       {.origin = place("-0.2", "0.1", "0.1"), .rotation = turned(7, 1, 2, 2)});
  const FrameHandle rail = s.prismatic("rail", rotor, {1, 1, 3}, g, {.origin = place("0.2", "0.1", "-0.1")});
  const FrameHandle elbow =
      s.revolute("elbow", rail, axis::z, q[4], {.origin = place("0.1", "0.1", "0.1"), .rotation = turned(2, 3, -1, 1)});
  const FrameHandle hand =
      s.revolute("hand", elbow, axis::z, q[5], {.origin = place("0.3", "0.1", "0.2"), .rotation = turned(6, 0, 0, 1)});
  int index = 0;
  for (const FrameHandle& frame : {trunk, upper, slide, wrist, tip, rotor, rail, elbow, hand}) {
    add_body(s, "body" + std::to_string(index++), frame);
  }
  s.gravity({0, 0, quantity("-9.81", "m/s^2")});
  s.motor("push", d);
  s.motor("turn", q[4]);
  if (actions == Actions::none) return s;
  const PointHandle p = s.point("P", tip, place("0.3", "0.1", "0"));
  const PointHandle r = s.point("R", s.ground(), place("0", "1", "0"));
  s.spring("spring", {.a = p, .b = r, .stiffness = quantity("40", "N/m"), .rest = quantity("0.2", "m")});
  s.force("force", {.body = hand, .point = r, .components = {0, quantity("3", "N"), 0}, .axes = s.ground()});
  return s;
}

ModelOptions in_frames_of_scene() {
  ModelOptions options;
  options.passes.reframing = false;
  return options;
}

/// Results of every kernel, by name.
using Results = std::map<std::string, std::vector<Real>>;

using Names = std::vector<std::string>;

struct Derived {
  Derived(const Scene& scene, const ModelOptions& options, const Names& names) : equations(scene, options) {
    for (const std::string& name : names) kernels.push_back(make_kernel(name, equations));
  }
  Results at(const RandomState& state) {
    Evaluator<Real> evaluate(equations.program(), state.in_real());
    Results results;
    for (const Kernel& kernel : kernels) {
      for (const Assignment& each : kernel.assignments) results[kernel.name].push_back(evaluate(each.value));
    }
    return results;
  }
  int operations(const std::string& name) const {
    for (const Kernel& kernel : kernels) {
      if (kernel.name == name) return count(equations.program(), kernel.values()).total();
    }
    return 0;
  }
  Equations equations;
  std::vector<Kernel> kernels;
};

/// `allowed`: of the largest result of a kernel.
void expect_same_results(const Scene& scene, Derived& cheap, Derived& given, double allowed) {
  const RandomState state(scene, 1);
  const Results one = cheap.at(state);
  const Results other = given.at(state);
  for (const auto& [name, values] : one) {
    const std::vector<Real>& expected = other.at(name);
    ASSERT_EQ(values.size(), expected.size()) << name;
    Real size(0);
    for (const Real& each : expected) size = std::max(size, abs(each));
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_LE(abs(values[i] - expected[i]), size * Real::from_double(allowed)) << name << " " << i;
    }
  }
}

// Directions are rounded at 1e-80 and the work is done in 100 digits: what is left is multiplied by some thousand
// operations and by the condition of the mass matrix, below 1e10 together.
constexpr double of_rounded_directions = 1e-70;

/// What a tree of two branches, each with a slider, is left of its operations, at most.
void expect_less(const Derived& cheap, const Derived& given, const Names& names, double part) {
  for (const std::string& name : names) {
    EXPECT_LT(cheap.operations(name), part * given.operations(name)) << name << ": " << given.operations(name);
  }
}

TEST(Reframing, LeavesResultsOfAGenericTreeWithSlidersAsTheyAre) {
  const WorkingDigits precision(100);
  const Scene scene = generic_tree(Base::fixed);
  const Names names{"mass_matrix",  "bias",   "inverse_dynamics", "forward_dynamics", "inverse_dynamics_derivatives",
                    "kinematics", "poses", "energy",           "regressor"};
  Derived cheap(scene, {}, names), given(scene, in_frames_of_scene(), names);
  EXPECT_TRUE(cheap.equations.model().regrouped().is_reframed());
  EXPECT_FALSE(given.equations.model().regrouped().is_reframed());
  EXPECT_GT(cheap.equations.model().regrouped().rounded_directions(), 0);
  expect_same_results(scene, cheap, given, of_rounded_directions);
  expect_less(cheap, given, {"mass_matrix", "forward_dynamics"}, 0.8);
  expect_less(cheap, given, {"inverse_dynamics"}, 0.9);  // actions come from the scene's frames
}

TEST(Reframing, LeavesWhatIsToldInTheFramesOfTheScene) {
  const Scene scene = generic_tree(Base::fixed);
  for (const std::string name : {"kinematics", "poses", "energy", "regressor"}) {
    const Derived cheap(scene, {}, {name}), given(scene, in_frames_of_scene(), {name});
    EXPECT_EQ(cheap.operations(name), given.operations(name)) << name;
  }
}

TEST(Reframing, SavesAFifthOnAGenericTreeWithSliders) {
  const Scene scene = generic_tree(Base::fixed, Actions::none);
  const Names names{"mass_matrix", "inverse_dynamics", "forward_dynamics", "inverse_dynamics_derivatives",
                    "forward_dynamics_derivatives"};
  const Derived cheap(scene, {}, names), given(scene, in_frames_of_scene(), names);
  // A turn by Rx(α) costs 6 operations in place of 15, that of an array 16 in place of some 70.
  expect_less(cheap, given, names, 0.8);
}

TEST(Reframing, LeavesResultsOfABaseThatTurnsByAQuaternionAsTheyAre) {
  const WorkingDigits precision(100);
  const Scene scene = generic_tree(Base::quaternion);
  const Names names{"kinematics", "mass_matrix", "inverse_dynamics", "forward_dynamics"};
  Derived cheap(scene, {}, names), given(scene, in_frames_of_scene(), names);
  EXPECT_TRUE(cheap.equations.model().regrouped().is_reframed());
  expect_same_results(scene, cheap, given, of_rounded_directions);
  expect_less(cheap, given, {"mass_matrix", "forward_dynamics"}, 0.8);
  expect_less(cheap, given, {"inverse_dynamics"}, 0.9);  // the base keeps its frame
}

// A tree's links stand elsewhere; what a person asks for is along frames of the scene, whichever tree tells it.
TEST(Reframing, LeavesFramesOfTheSceneWhereTheyAre) {
  const WorkingDigits precision(100);
  const Scene scene = generic_tree(Base::fixed);
  const Equations equations(scene);
  const Model& model = equations.model();
  const BodyTree& tree = model.with_bodies();
  ASSERT_TRUE(tree.is_reframed());
  EXPECT_FALSE(model.is_reframed());
  const RandomState state(scene, 5);
  Evaluator<Real> evaluate(equations.program(), state.in_real());
  const auto expect_same = [&](const Vector& one, const Vector& other, const std::string& what) {
    for (int i = 0; i < 3; ++i) {
      const Real difference = evaluate(one[i]) - evaluate(other[i]);
      EXPECT_LT(abs(difference).to_double(), of_rounded_directions) << what << " " << i;
    }
  };
  bool elsewhere = false;
  const std::size_t count = scene.content().frames.size();
  for (std::size_t f = 1; f < count; ++f) {
    const FrameHandle frame{static_cast<int>(f)};
    const FramePlace &mine = model.place(frame, "test"), &other = tree.place(frame, "test");
    ASSERT_EQ(mine.link, other.link);
    elsewhere = elsewhere || !other.rotation.is_identity();
    const std::string& name = scene.content().frames[f].name;
    expect_same(model.locate(mine.origin, mine.link, 0), tree.locate(other.origin, other.link, 0), "place of " + name);
    for (int axis = 0; axis < 3; ++axis) {
      Vector unit;
      unit[axis] = equations.program().number(Number(1));
      expect_same(model.express(mine.rotation * unit, mine.link, 0), tree.express(other.rotation * unit, other.link, 0),
                  "axis of " + name);
    }
  }
  EXPECT_TRUE(elsewhere);
}

TEST(Reframing, TurnsWrenchesWithTheFramesOfLinks) {
  const WorkingDigits precision(100);
  const Scene scene = generic_tree(Base::quaternion);
  const Equations equations(scene);
  Program& program = equations.program();
  const Model& model = equations.model();
  const BodyTree& tree = model.with_bodies();
  ASSERT_TRUE(tree.is_reframed());
  const RandomState state(scene, 5);
  Evaluator<Real> evaluate(program, state.in_real());
  Wrench wrench;
  for (int i = 0; i < 3; ++i) {
    wrench.resultant[i] = program.number(Number(2 * i - 1), units::newton);
    wrench.moment[i] = program.number(Number(3 - i), units::newton_metre);
  }
  const std::vector<Twist> given = twists(model), moved = twists(tree);
  for (std::size_t k = 1; k < given.size(); ++k) {
    const Real power = evaluate(reciprocal_product(wrench, given[k]));
    const Real same = evaluate(reciprocal_product(tree.applied(k, wrench), moved[k]));
    EXPECT_LT(abs(power - same).to_double(), of_rounded_directions) << model.links()[k].name;
  }
}

/// Frames turned by multiples of π/12 about several axes: all directions are in Q(√2, √3).
Scene exact_arm() {
  Scene s("exact_arm");
  FrameHandle frame = s.ground();
  int k = 0;
  for (const Rotation& rotation :
       {Rotation(), Rotation::about(0, 2) * Rotation::about(2, 3), Rotation::about(2, 1) * Rotation::about(0, 4),
        Rotation::about(2, 6) * Rotation::about(0, 3) * Rotation::about(2, 2)}) {
    const std::string name = "q" + std::to_string(k++);
    frame = s.revolute(name, frame, axis::z, s.coordinate("angle_" + name, "rad"),
                       {.origin = place("0.3", "0", "0.1"), .rotation = rotation});
    add_body(s, "body_" + name, frame);
  }
  s.gravity({0, 0, quantity("-9.81", "m/s^2")});
  return s;
}

TEST(Reframing, IsExactWhereAnglesAre) {
  const WorkingDigits precision(100);
  const Scene scene = exact_arm();
  const Names names{"kinematics", "mass_matrix", "inverse_dynamics", "forward_dynamics", "regressor"};
  Derived cheap(scene, {}, names), given(scene, in_frames_of_scene(), names);
  ASSERT_TRUE(cheap.equations.model().regrouped().is_reframed());
  // The frame of the last link, which carries nothing, turns towards its centre of mass: one direction and one angle.
  EXPECT_LE(cheap.equations.model().regrouped().rounded_directions(), 2);
  expect_same_results(scene, cheap, given, of_rounded_directions);
  EXPECT_LT(cheap.operations("mass_matrix"), given.operations("mass_matrix"));
  EXPECT_LT(cheap.operations("inverse_dynamics"), given.operations("inverse_dynamics"));
}

TEST(Reframing, KeepsFramesOfPrintedEquationsAndThoseThatArePermuted) {
  ModelOptions printed;
  printed.symbolic_parameters = true;
  EXPECT_FALSE(Equations(generic_tree(Base::fixed), printed).model().regrouped().is_reframed());
  Scene s("quarter_turns");
  FrameHandle frame = s.ground();
  for (const std::string name : {"a", "b", "c"}) {
    frame = s.revolute(name, frame, axis::z, s.coordinate("q_" + name, "rad"),
                       {.origin = place("0.3", "0.2", "0.1"), .rotation = Rotation::about(0, 6)});
    add_body(s, "body_" + name, frame);
  }
  EXPECT_FALSE(Equations(s).model().regrouped().is_reframed());
}

// The bars of a robot with generic joint frames; before, 1596, 1210, 2960, 7370 and 9325 operations.
TEST(Reframing, OfGenericSevenJointsNeedsNoMoreThanAHandWrittenOne) {
  const ImportedRobot robot = read_urdf(TORSOR_SOURCE_DIR "/tests/reference/urdf/gen7.urdf", {});
  const std::vector<std::pair<std::string, int>> bars{{"mass_matrix", 860},
                                                      {"inverse_dynamics", 920},
                                                      {"forward_dynamics", 1950},
                                                      {"inverse_dynamics_derivatives", 4800},
                                                      {"forward_dynamics_derivatives", 6700}};
  const Equations equations(robot.scene);
  for (const auto& [name, bar] : bars) {
    equations.start_over();
    EXPECT_LE(count(equations.program(), make_kernel(name, equations).values()).total(), bar) << name;
  }
}

TEST(ExactTurn, IsOnTheCircleAndWithinItsDigits) {
  int rounded = 0;
  const ExactTurn turn = turn_towards(Number(-3), Number(5), rounded);
  EXPECT_EQ(rounded, 1);
  EXPECT_TRUE((turn.cosine * turn.cosine + turn.sine * turn.sine).is_one());
  const WorkingDigits precision(100);
  const Real across = Real(turn.cosine, 100) * Real(5) + Real(turn.sine, 100) * Real(3);
  EXPECT_LT((abs(across) / sqrt(Real(34))).to_double(), 1e-80);
  EXPECT_LT(turn.cosine.sign(), 0);
  const ExactTurn exact = turn_towards(Number(-3), Number(4), rounded);
  EXPECT_EQ(rounded, 1);
  EXPECT_EQ(exact.cosine, Number::rational(-3, 5));
  const AngleParts parts = angle_of(turn, rounded);
  const Real angle = Real(parts.twelfths) * Real::pi() / Real(12) + Real(parts.rest, 100);
  EXPECT_LT(abs(angle - atan2(Real(5), Real(-3))).to_double(), 1e-79);
  EXPECT_LE(abs(Real(parts.rest, 100)), Real::pi() / Real(4));
}

TEST(ExactTurn, FindsTheFactorsOfARotation) {
  const Rotation x = Rotation::about(0, 2), z = turned_about(2, {Number::rational(3, 5), Number::rational(4, 5)});
  const auto two = plane_factors(z * x);
  ASSERT_TRUE(two);
  ASSERT_EQ(two->size(), 2U);
  EXPECT_TRUE(((*two)[0].transpose() * z).is_identity());
  EXPECT_TRUE(((*two)[1].transpose() * x).is_identity());
  EXPECT_EQ(plane_factors(x)->size(), 1U);
  EXPECT_TRUE(plane_factors(Rotation())->empty());
  EXPECT_FALSE(plane_factors(x * z));
  EXPECT_EQ(axis_of_turn(x), 0);
  EXPECT_FALSE(axis_of_turn(Rotation::about(1, 6)));
}

}  // namespace
}  // namespace torsor::reframing_test
