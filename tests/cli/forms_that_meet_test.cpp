// SPDX-License-Identifier: GPL-3.0-or-later
// Rests where the potential changes its form.
#include "tests/cli/scene_runner.hpp"
#include "torsor/generator/expression/piecewise.hpp"

namespace torsor::forms_that_meet_test {
namespace {

using namespace testing_programs;

using Potential = Expression (*)(const Expression& x, const Expression& k);

template <Potential potential>
Scene on_a_rail() {
  Scene scene("rail");
  const Expression x = scene.coordinate("x", "m"), k = scene.parameter("k", "N/m", 4);
  scene.body("bead", scene.prismatic("rail", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("2", "kg")));
  scene.force_function("elastic", -potential(x, k));
  return scene;
}

Expression metre() { return Expression::quantity("1", "m"); }
Expression origin() { return Expression::quantity("0", "m"); }

/// 4 k to the right, 2 k to the left, 3 k at 0, where each choice has its first form.
Expression apart(const Expression& x, const Expression& k) {
  return piecewise({{x < origin(), k * x * x}}, 2 * k * x * x) / 2 + piecewise({{-x < origin(), 2 * k * x * x}}, k * x * x) / 2;
}
/// A maximum with a cusp, a slope to the left, a wall to the right, a bowl of one side, a bowl with a bound on its slope.
Expression cusp(const Expression& x, const Expression& k) { return k * x * x - k * metre() * abs(x); }
Expression fall(const Expression& x, const Expression& k) { return piecewise({{x < origin(), -k * x * x}}, k * x * x); }
Expression larger(const Expression& x, const Expression& k) {
  return k * pow(max(x, origin()), 2) - k * pow(max(-x, origin()), 2);
}
Expression bowl(const Expression& x, const Expression& k) { return k * pow(max(x, -x), 2); }
Expression smooth(const Expression& x, const Expression& k) {
  return piecewise({{x < origin(), k * x * x}}, k * x * x + k * pow(x, 3) / metre());
}

std::string statics(Scene (*scene)(), const char* about) {
  const Outcome outcome = run(scene, {"statics", "--about", about});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

constexpr const char* doubt =
    "Cannot conclude: forces or their slopes have two values at this state, one on either side of\n  0 = x\n";
constexpr const char* stable = "With the scene's values: stable: -(U + T0) has a strict minimum";

TEST(FormsThatMeet, LeaveARestUnjudged) {
  for (Scene (*scene)() : {&on_a_rail<cusp>, &on_a_rail<fall>, &on_a_rail<larger>, &on_a_rail<apart>}) {
    const std::string text = statics(scene, "x=0");
    EXPECT_NE(text.find(doubt), std::string::npos) << text;
    EXPECT_EQ(text.find(stable), std::string::npos) << text;
    EXPECT_EQ(text.find("T depends on time"), std::string::npos) << text;
  }
}

TEST(FormsThatMeet, AreNoMatterWhereTheyAgree) {
  for (Scene (*scene)() : {&on_a_rail<bowl>, &on_a_rail<smooth>}) {
    const std::string text = statics(scene, "x=0");
    EXPECT_EQ(text.find("either side"), std::string::npos) << text;
    EXPECT_NE(text.find(stable), std::string::npos) << text;
  }
}

TEST(FormsThatMeet, AreNoMatterElsewhere) {
  const std::string text = statics(on_a_rail<cusp>, "x=1/2");
  EXPECT_EQ(text.find("either side"), std::string::npos) << text;
  EXPECT_NE(text.find(stable), std::string::npos) << text;
}

using PotentialOfTwo = Expression (*)(const Expression& x, const Expression& y, const Expression& k);

template <PotentialOfTwo potential>
Scene in_a_plane() {
  Scene scene("plane");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), k = scene.parameter("k", "N/m", 4);
  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  scene.body("bead", scene.prismatic("along", across, axis::y, y), Inertia::point(Expression::quantity("2", "kg")));
  scene.force_function("elastic", -potential(x, y, k));
  return scene;
}

/// A fall in one quadrant alone, cusps inside of a choice, a cliff where an angle jumps.
Expression quadrant(const Expression& x, const Expression& y, const Expression& k) {
  return k * (x * x + y * y) / 2 + piecewise({{x < origin(), piecewise({{y < origin(), 10 * k * x * y}}, 0 * k * x * y)}}, 0 * k * x * y);
}
Expression nested(const Expression& x, const Expression& y, const Expression& k) {
  const Expression bowl = k * x * x + k * y * y, cusp = k * metre() * abs(y);
  return piecewise({{x < origin(), bowl - cusp}}, bowl - cusp * (1 + x / metre()));
}
Expression cliff(const Expression& x, const Expression& y, const Expression& k) {
  const Expression turn = k * metre() * metre();
  return k * pow(x + metre(), 2) / 2 - turn * pow(atan2(y, x) - pi(), 2) + 3 * k * y * y;
}

TEST(FormsThatMeet, AreComparedOnAllSides) {
  const auto judged = [](Scene (*scene)(), const char* x) {
    const Outcome outcome = run(scene, {"statics", "--about", x, "--about", "y=0"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find(stable), std::string::npos) << outcome.out;
    return outcome.out.find("one on either side of") != std::string::npos;
  };
  EXPECT_TRUE(judged(&in_a_plane<quadrant>, "x=0"));
  EXPECT_TRUE(judged(&in_a_plane<nested>, "x=0"));
  EXPECT_TRUE(judged(&in_a_plane<cliff>, "x=-1"));
}

/// Friction that is said by a sign of the rate has no slope at rest.
Scene rubbing() {
  Scene scene("rubbing");
  const Expression x = scene.coordinate("x", "m");
  scene.body("bead", scene.prismatic("rail", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("2", "kg")));
  scene.spring("spring", x, scene.parameter("k", "N/m", 4));
  scene.generalised_force("friction", x, -Expression::quantity("1", "N") * sign(rate(x)));
  return scene;
}

TEST(FormsThatMeet, OfRatesLeaveTheLinearisedEquationsUnjudged) {
  const std::string text = statics(rubbing, "x=0");
  const std::size_t hurwitz = text.find("Routh and Hurwitz");
  EXPECT_NE(text.find("Cannot conclude: forces or their slopes have two values", hurwitz), std::string::npos) << text;
}

std::string equations(Scene (*scene)(), std::vector<std::string> about) {
  about.insert(about.begin(), "equations");
  const Outcome outcome = run(scene, about);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome.out;
}

/// Friction of a guide half a metre wide, an angle about the origin, a motor with two gears.
Scene guided() {
  Scene scene("guided");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), L = Expression::quantity("1/2", "m");
  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  scene.body("bead", scene.prismatic("along", across, axis::y, y), Inertia::point(Expression::quantity("2", "kg")));
  scene.generalised_force("rub", y, -Expression::quantity("1", "N") * sign(rate(x)) * y / sqrt(L * L - y * y));
  return scene;
}
Scene turned() {
  Scene scene("turned");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), k = scene.parameter("k", "N/m", 4);
  const FrameHandle across = scene.prismatic("across", scene.ground(), axis::x, x);
  scene.body("bead", scene.prismatic("along", across, axis::y, y), Inertia::point(Expression::quantity("2", "kg")));
  scene.generalised_force("turn", y, -k * metre() * atan2(x, y));
  return scene;
}
Scene geared() {
  Scene scene("geared");
  const Expression x = scene.coordinate("x", "m");
  scene.body("bead", scene.prismatic("rail", scene.ground(), axis::x, x), Inertia::point(Expression::quantity("2", "kg")));
  scene.motor("u", piecewise({{x < origin(), 2 * x}}, x));
  return scene;
}

TEST(FormsThatMeet, AreToldWithTheirLawsBesideLinearisedEquations) {
  const auto told = [](const std::string& text, const std::string& condition, const std::string& law) {
    const std::size_t note = text.find("There is no linearisation: forces or their slopes have two values at this state");
    EXPECT_NE(note, std::string::npos) << text;
    const std::string what = "  " + condition + " = 0\n  Laws with two forms there: " + law + ".\n  The matrices are";
    EXPECT_NE(text.find(what, note), std::string::npos) << text;
  };
  told(equations(rubbing, {"--about", "x=0"}), "x'", "friction");
  told(equations(&on_a_rail<cusp>, {"--about", "x=0"}), "x", "elastic");
  told(equations(guided, {"--about", "x=0"}), "x'", "rub");
  told(equations(turned, {"--about", "x=0", "--about", "y=-1"}), "x", "turn");
  EXPECT_NE(equations(geared, {"--about", "x=0"}).find("There is no linearisation"), std::string::npos);
  // What the state leaves open is on one side.
  told(equations(&in_a_plane<nested>, {"--about", "x=0"}), "x", "elastic");
  for (const std::string& text :
       {equations(&on_a_rail<bowl>, {"--about", "x=0"}), equations(&on_a_rail<smooth>, {"--about", "x=0"}),
        equations(&on_a_rail<cusp>, {"--about", "x=1/2"}), equations(&on_a_rail<cusp>, {}),
        equations(rubbing, {"--about", "x=0", "--about", "x'=1"})}) {
    EXPECT_EQ(text.find("no linearisation"), std::string::npos) << text;
  }
}

/// The ends of a spring that is longer at rest meet at x = z = 0.
Scene slack() {
  Scene scene("slack");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle rail = scene.prismatic("rail", scene.ground(), axis::x, x), cart = scene.prismatic("cart", rail, axis::z, z);
  scene.body("bead", cart, Inertia::point(Expression::quantity("2", "kg")));
  scene.spring("spring", {.a = scene.point("a", cart, {0, 0, 0}), .b = scene.point("b", scene.ground(), {0, 0, 0}),
                          .stiffness = Expression::quantity("8", "N/m"), .rest = Expression::quantity("1", "m")});
  return scene;
}

TEST(FormsThatMeet, HaveAnErrorOfTheirOwnWhereThereIsNoValue) {
  for (const char* command : {"statics", "equations"}) {
    expect_failure_beginning(run(slack, {command, "--about", "x=0", "--about", "z=0"}), 2,
                             "the formulas divide by zero at this state, by the length of a spring whose ends meet");
  }
}

}  // namespace
}  // namespace torsor::forms_that_meet_test
