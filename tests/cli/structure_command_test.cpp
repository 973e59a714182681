// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/cli/scene_runner.hpp"

namespace torsor::structure_command_test {
namespace {

using namespace testing_programs;
using nlohmann::json;

/// A slide block that two columns guide, as a press has them.
Scene guided() {
  Scene scene("guided");
  const Expression z = scene.coordinate("z", "m"), a = scene.coordinate("a", "rad");
  const Expression metre = Expression::quantity("1", "m"), kilogram = Expression::quantity("1", "kg");
  const FrameHandle block =
      scene.cylindrical("block", scene.ground(), {.axis = axis::x, .displacement = z, .angle = a});
  const FrameHandle ring = scene.weld("ring", block, {{0, metre, 0}, {}});
  const FrameHandle column = scene.weld("column", scene.ground(), {{0, metre, 0}, {}});
  scene.loop_joint("guide", {.type = JointType::cylindrical, .a = column, .b = ring});
  const Expression J = Expression::quantity("1", "kg m^2");
  scene.body("block", block, Inertia::general({.mass = kilogram, .xx = J, .yy = J, .zz = J}));
  return scene;
}

TEST(StructureCommand, CountsAndNames) {
  const Outcome outcome = run(guided, {"structure"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "guided\n"
            "\n"
            "Joints (* with the outside)\n"
            "  *block           ground - block: cylindrical, 2 freedoms (slide along x, turn about x)\n"
            "  *guide           ground - block: cylindrical, 2 freedoms (turn about x, slide along x), closes a loop\n"
            "\n"
            "Structure graph\n"
            "  bodies 2, joints 2: independent loops mu = 1\n"
            "  freedoms of the joints n_p = 4, closure equations 6 mu = 6 of rank r = 3\n"
            "  mobility m = n_p - r = 1: 1 useful, 0 internal\n"
            "  degree of redundancy h = 6 mu - r = 3\n"
            "\n"
            "Closures (P(b/a): components along a into components along b)\n"
            "  loop 1 (guide, block)\n"
            "    P(ground/block)·P(block/ground) = I\n"
            "    O_ground O_block + O_block O_ground = 0\n"
            "    {V(block/ground)} + {V(ground/block)} = 0\n"
            "  redundant, each on its own: loop 1: Omega_y, loop 1: Omega_z, loop 1: V_y\n"
            "\n"
            "Reactions that equilibrium does not determine (components along the joint's axes)\n"
            "  block           F_y, M_y, M_z\n"
            "  guide           F_y, M_y, M_z\n"
            "\n"
            "Reduced graph\n"
            "  block and guide in parallel between ground and block: prismatic along x; redundant equations: 3 fewer\n"
            "  bodies 2, joints 1: independent loops mu = 0\n"
            "  freedoms of the joints n_p = 1, closure equations 6 mu = 0 of rank r = 0\n"
            "  mobility m = n_p - r = 1: 1 useful, 0 internal\n"
            "  degree of redundancy h = 6 mu - r = 0\n"
            "  block//guide     ground - block: prismatic along x\n"
            "\n"
            "The scene as it is written: 2 unknown coordinates, 0 driven, 4 constraints of rank 1 at the initial "
            "configuration: 1 freedom: 1 useful, 0 internal\n");
}

TEST(StructureCommand, WritesJson) {
  const json data = json::parse(run(guided, {"structure", "--json", "--inputs-outputs", "guide"}).out);
  EXPECT_EQ(data.at("generic").at("mobility"), 1);
  EXPECT_EQ(data.at("generic").at("redundancy"), 3);
  EXPECT_EQ(data.at("joints").at(0).at("outside"), false);
  EXPECT_EQ(data.at("joints").at(1).at("between"), (json{"ground", "block"}));
  EXPECT_EQ(data.at("reduced").at("joints").at(0).at("type"), "prismatic");
}

/// Four bars whose loop two formulas close instead of a joint; on the coupler turns an idle roller.
Scene four_bars() {
  Scene scene("four_bars");
  const Expression metre = Expression::quantity("1", "m"), kilogram = Expression::quantity("1", "kg");
  const Expression a = scene.coordinate("a", "rad"), b = scene.coordinate("b", "rad"), c = scene.coordinate("c", "rad");
  const Expression spin = scene.coordinate("spin", "rad");
  scene.initial(a, pi() / 2);  // a square
  scene.initial(b, -pi() / 2);
  scene.initial(c, pi() / 2);
  const FrameHandle crank = scene.revolute("crank", scene.ground(), axis::z, a);
  const FrameHandle coupler = scene.revolute("coupler", crank, axis::z, b, {{metre, 0, 0}, {}});
  const FrameHandle rocker = scene.revolute("rocker", scene.ground(), axis::z, c, {{metre, 0, 0}, {}});
  const FrameHandle roller = scene.revolute("roller", coupler, axis::z, spin);
  for (const FrameHandle& each : {crank, coupler, rocker, roller}) {
    scene.body("body_" + std::to_string(each.index), each, Inertia::disk(kilogram, metre, 2));
  }
  const PointHandle A = scene.point("A", coupler, {metre, 0, 0}), B = scene.point("B", rocker, {metre, 0, 0});
  scene.closure("pin_x", A, B, axis::x);
  scene.closure("pin_y", A, B, axis::y);
  return scene;
}

// Grashof's square has one freedom, and the roller its own; a graph that sees no loop counts the rods as free.
TEST(StructureCommand, CountsWhatConstraintsBesideTheJointsLeave) {
  const std::string text = run(four_bars, {"structure"}).out;
  EXPECT_NE(
      text.find("  mobility m = n_p - r = 4: 2 useful, 2 internal\n"
                "  degree of redundancy h = 6 mu - r = 0\n"
                "  that is the joints alone: 2 constraints are no joints beside them (pin_x, pin_y), with which the "
                "scene has 2 freedoms: 1 useful, 1 internal\n"),
      std::string::npos)
      << text;
  const json data = json::parse(run(four_bars, {"structure", "--json", "--inputs-outputs", "roller"}).out);
  EXPECT_EQ(data.at("scene").at("no_joints"), (json{"pin_x", "pin_y"}));
  EXPECT_EQ(data.at("scene").at("useful"), 1);  // of the roller now, the bars are internal
  EXPECT_EQ(data.at("scene").at("internal"), 1);
}

TEST(StructureCommand, DrawsGraphs) {
  for (const char* kind : {"structure", "analysis", "reduced"}) {
    EXPECT_TRUE(run(guided, {"graph", "--of", kind}).out.starts_with("graph \"guided\" {\n")) << kind;
    EXPECT_TRUE(run(guided, {"graph", "--of", kind, "--format", "svg"}).out.starts_with("<svg ")) << kind;
  }
}

// An axis has two directions: the wheel's own, and the one in which the search for internal motions finds it.
TEST(StructureCommand, WritesAnAxisByOneOfItsDirections) {
  const auto wheel = [] {
    Scene scene("wheel");
    const Expression turn = scene.coordinate("turn", "rad"), phi = scene.coordinate("a_name_of_many_letters", "rad");
    const FrameHandle arm = scene.revolute("arm", scene.ground(), axis::z, turn);
    const Number half = Number::rational(3, 5), rest = Number::rational(4, 5);
    const FrameHandle hub = scene.revolute("a_hub_of_many_letters", arm, {-Expression(half), Expression(rest), 0}, phi);
    const Expression J = Expression::quantity("1", "kg m^2");
    scene.body("arm", arm, Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = J, .yy = J, .zz = J}));
    scene.body("hub", hub, Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = J, .yy = J, .zz = J}));
    return scene;
  };
  const std::string out = run(wheel, {"structure"}).out;
  EXPECT_NE(out.find("   a_hub_of_many_letters arm - a_hub_of_many_letters: revolute, 1 freedom (turn about (0.6, -0.8, 0))\n"), std::string::npos) << out;
  EXPECT_EQ(out.find("(-0.6"), std::string::npos) << out;
}

TEST(StructureCommand, RefusesWhatItDoesNotKnow) {
  expect_failure(run(guided, {"graph", "--format", "png"}), 2,
                 "unknown format 'png' of a graph: use dot (Graphviz draws it) or svg");
  expect_failure(run(guided, {"graph", "--of", "tree"}), 2, "unknown graph 'tree': use structure, analysis or reduced");
  expect_failure(run(guided, {"structure", "--inputs-outputs", "wheel"}), 2,
                 "unknown joint 'wheel': the scene has block, guide");
}

// As the fingers of a gripper, of which one mimics the other.
TEST(StructureCommand, SaysWhichJointsFormulasTie) {
  const auto gripper = [] {
    Scene scene("gripper");
    const Expression q = scene.coordinate("q", "rad"), r = scene.coordinate("r", "rad");
    const Expression J = Expression::quantity("1", "kg m^2");
    const FrameHandle hand = scene.revolute("hand", scene.ground(), axis::z, r);
    for (const auto& [name, turn] : {std::pair("left", q), std::pair("right", -q)}) {
      const FrameHandle finger = scene.revolute(name, hand, axis::z, turn);
      scene.body(name, finger, Inertia::general({.mass = Expression::quantity("1", "kg"), .xx = J, .yy = J, .zz = J}));
    }
    scene.reflected_inertia("motor", 20 * r, J);
    return scene;
  };
  const Outcome outcome = run(gripper, {"structure"});
  EXPECT_NE(outcome.out.find("\n  that is the joints alone: formulas of coordinates tie left, right, and the scene has 2 "
                             "freedoms: 1 useful, 1 internal\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(run(guided, {"structure"}).out.find("formulas of coordinates"), std::string::npos);
  const auto tied = [](const auto& scene) {
    return json::parse(run(scene, {"structure", "--json"}).out).at("scene").at("tied_joints");
  };
  EXPECT_EQ(tied(gripper), (json{"left", "right"}));
  EXPECT_EQ(tied(guided), json::array());
}

}  // namespace
}  // namespace torsor::structure_command_test
