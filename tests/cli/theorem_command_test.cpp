// SPDX-License-Identifier: GPL-3.0-or-later
#include "examples/loading_robot/scene.cpp"
#include "examples/satellite_arms/scene.cpp"
#include "examples/watt_governor/scene.cpp"
#include "examples/winder/scene.cpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/scenes/sliding.hpp"

namespace torsor::theorem_command_test {
namespace {

using namespace testing_programs;
using testing_mechanisms::kilograms;
using testing_mechanisms::metres;
using testing_mechanisms::nut_on_a_thread;
using testing_mechanisms::SlidingPoint;
using testing_mechanisms::quantity;

/// What stands under the heading, without the lines of the unknowns.
std::string theorem(Scene (*scene)(), std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "theorem");
  const Outcome outcome = run(scene, arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::size_t heading = outcome.out.find("\n\n"), end = outcome.out.find("  [joint X]");
  return outcome.out.substr(heading + 2, end - heading - 2);
}

// Formulas of Pommier, 8.3.2 exercises 5, 7 and 4, by hand: an arm seen from S1, which turns at psi', has the dynamic
// moment (B2 + m2 b2²) θ2'' − ψ'² cos θ2 (m2 a2 b2 + (A2 + m2 b2² − C2) sin θ2) about its hinge.
TEST(TheoremCommand, WritesTheMomentThatMovesAnArmOfTheSatellite) {
  EXPECT_EQ(theorem(satellite_arms_scene,
                    {"--bodies", "S2", "--kind", "moment", "--at", "O2", "--axes", "S1", "--direction", "y"}),
            "Newton-Euler for S2: moment at O2 along y of S1\n"
            "  (b2^2 m2 + B2) theta_2'' - cos(theta_2) (a2 b2 m2 + (b2^2 m2 + A2 - C2) sin(theta_2)) psi'^2\n"
            "    = -v2 theta_2' - K2 (theta_2 - 1/2 pi) + b2 m2 g sin(theta_2) + Cm2\n"
            "  No unknown of a joint enters: an equation of motion.\n");
}

// The centre of S2 is at b2 (sin θ2 x1 + cos θ2 z1): its acceleration along z1 is that of a turn by θ2.
TEST(TheoremCommand, NamesTheUnknownActionsOfJoints) {
  const std::string expected =
      "  -b2 m2 sin(theta_2) theta_2'' - b2 m2 cos(theta_2) theta_2'^2 = -m2 g - sin(theta_2) [S2 X] + cos(theta_2) "
      "[S2 Z]\n"
      "  Unknown: [S2 X], [S2 Z].\n";
  EXPECT_EQ(theorem(satellite_arms_scene, {"--bodies", "S2", "--axes", "S1", "--direction", "z"}),
            "Newton-Euler for S2: resultant along z of S1\n" + expected);
  EXPECT_EQ(theorem(satellite_arms_scene, {"--bodies", "S2", "--axes", "S1", "--direction", "0,0,1"}),
            "Newton-Euler for S2: resultant along 0,0,1 of S1\n" + expected);
}

// Of a slide along x1 at (x, h) from the turning axis, with S3 hanging on it: Y12 of the exercise, question 3.
TEST(TheoremCommand, GivesTheTransverseReactionOfTheRobot) {
  EXPECT_EQ(theorem(loading_robot_scene, {"--bodies", "S2,S3", "--axes", "S1", "--direction", "y"}),
            "Newton-Euler for S2, S3: resultant along y of S1\n"
            "  (L2 m2 + (m2 + m3) x - L3 m3 cos(beta)) alpha'' - L3 m3 cos(beta) beta'' - (h (m2 + m3) - L3 m3 "
            "sin(beta)) alpha'^2 + 2 (m2 + m3) alpha' x'\n"
            "    + 2 L3 m3 sin(beta) alpha' beta' + L3 m3 sin(beta) beta'^2\n"
            "    = -(m2 + m3) g cos(alpha) + [S2 Y]\n"
            "  Unknown: [S2 Y].\n");
}

// The bobbin slides in the field ω² of its own distance from the axis; the motor's torque keeps ω.
TEST(TheoremCommand, TakesAFrameForItsOrigin) {
  EXPECT_EQ(theorem(winder_scene, {"--bodies", "S", "--axes", "holder", "--direction", "z"}),
            "Newton-Euler for S: resultant along z of holder\n"
            "  m lambda'' - m omega^2 sin(slope)^2 lambda = m (a k - g) cos(slope) - m k lambda\n"
            "  No unknown of a joint enters: an equation of motion.\n");
  EXPECT_EQ(theorem(winder_scene, {"--kind", "moment", "--at", "ground", "--direction", "z"}),
            "Newton-Euler for Sigma, S: moment at ground along z of ground\n"
            "  -m b sin(slope) lambda'' + C cos(slope) phi'' + 2 m omega sin(slope)^2 lambda lambda' = "
            "[pivot_with_motor N]\n"
            "  Unknown: [pivot_with_motor N].\n");
}

// ½ m l² θ'² with weight and motor: dT/dt = m l² θ' θ''.
TEST(TheoremCommand, WritesTheEnergyTheorem) {
  EXPECT_EQ(
      theorem(pendulum, {"--kind", "energy"}),
      "Energy theorem for bob\n"
      "  T = 1/2 mass length^2 theta'^2    (in J)\n"
      "  P_ext = -9.81 mass length sin(theta) theta' + theta' torque    (power of the actions from outside, in W)\n"
      "  P_int = 0    (power of the actions between the bodies, in W)\n"
      "  dT/dt = P_ext + P_int:  mass length^2 theta' theta'' = -9.81 mass length sin(theta) theta' + theta' "
      "torque\n"
      "  No unknown of a joint enters: an equation of motion.\n");
}

// A damped pendulum: m l² s² + c s ± m g l; the top is a rest, but no minimum of −U.
Scene damped(int damping) {
  Scene scene("damped");
  const Expression m = scene.parameter("m", "kg", 2), l = scene.parameter("l", "m", 1),
                   g = scene.parameter("g", "m/s^2", 10);
  const Expression c = scene.parameter("c", "N m s", damping), theta = scene.coordinate("theta", "rad");
  scene.body("bob", scene.revolute("arm", scene.ground(), axis::z, theta), Inertia::point(m).at({0, -l, 0}));
  scene.gravity({0, -g, 0});
  scene.damper("air", theta, c);
  return scene;
}
Scene air_damped() { return damped(3); }
Scene undamped() { return damped(0); }

// The bob at its distance l: V = l θ' x, σ about the hinge l · m l θ', Γ = l θ'' x + l θ'² y.
TEST(ScrewCommand, WritesMomentumAndDynamicScrew) {
  const Outcome outcome = run(air_damped, {"screw", "--body", "bob", "--at", "arm", "--axes", "arm"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(outcome.out.find("\n\n") + 2),
            "Screws of bob at arm along the axes of arm\n"
            "  Twist: angular velocity [rad/s], velocity of the body's own point [m/s].\n"
            "  Omega = [ 0      ]\n"
            "          [ 0      ]\n"
            "          [ theta' ]\n"
            "  V(arm) = [ 0 ]\n"
            "           [ 0 ]\n"
            "           [ 0 ]\n"
            "  Momentum screw: [kg m/s], [N m s].\n"
            "  m V_G = [ m l theta' ]\n"
            "          [ 0          ]\n"
            "          [ 0          ]\n"
            "  sigma(arm) = [ 0            ]\n"
            "               [ 0            ]\n"
            "               [ m l^2 theta' ]\n"
            "  Dynamic screw: [N], [N m].\n"
            "  m Gamma_G = [ m l theta''  ]\n"
            "              [ m l theta'^2 ]\n"
            "              [ 0            ]\n"
            "  delta(arm) = [ 0             ]\n"
            "               [ 0             ]\n"
            "               [ m l^2 theta'' ]\n"
            "  Kinetic energy [J].\n"
            "  T = 1/2 m l^2 theta'^2\n");
  expect_failure(run(pendulum, {"screw"}), 2,
                 "a screw needs the point at which it is reduced: --at POINT, or a frame's name for its origin");
  expect_failure_beginning(run(pendulum, {"screw", "--at", "ground", "--body", "bib"}), 3, "unknown body 'bib'");
}

TEST(TheoremCommand, IsSpelledInLatexAsOtherPagesAre) {
  const std::string latex = run(pendulum, {"theorem", "--kind", "energy", "--format", "latex", "--document"}).out;
  EXPECT_TRUE(latex.starts_with("\\documentclass")) << latex;
  EXPECT_NE(latex.find("T &= \\frac{1}{2} \\mathrm{mass}\\, \\mathrm{length}^{2}\\, \\dot{\\theta}^{2}"), std::string::npos) << latex;
  const std::string statics = run(air_damped, {"statics", "--format", "latex"}).out;
  EXPECT_NE(statics.find("\\mathbf{H} &= \\begin{pmatrix}"), std::string::npos) << statics;
  const std::string unknowns = run(air_damped, {"unknowns", "--format", "latex"}).out;
  EXPECT_NE(unknowns.find("\\subsection*{Newton-Euler}"), std::string::npos) << unknowns;
  EXPECT_EQ(run(pendulum, {"theorem", "--format", "html"}).code, 2);
  for (const char* command : {"theorem", "equations"}) {
    expect_failure(run(pendulum, {command, "--document"}), 2,
                   "--document is for --format latex: a page of text is whole as it is");
  }
}

TEST(TheoremCommand, RefusesWhatItDoesNotKnow) {
  expect_failure(run(pendulum, {"theorem", "--kind", "power"}), 2,
                 "unknown kind 'power' of theorem: use resultant, moment or energy");
  expect_failure(
      run(pendulum, {"theorem", "--kind", "moment"}), 2,
      "a theorem of moment needs the point at which moments are taken: --at POINT, or a frame's name for its "
      "origin");
  expect_failure(run(pendulum, {"theorem", "--direction", "1,0"}), 2,
                 "the direction '1,0' is neither x, y, z nor three components, e.g. 0,1,0");
  expect_failure(run(pendulum, {"theorem", "--direction", "0,0,0"}), 2,
                 "the direction '0,0,0' is the null vector: give x, y, z or a direction, e.g. 0,1,0");
  for (const std::vector<std::string>& unused :
       {std::vector<std::string>{"--at", "ground"}, {"--direction", "z"}, {"--axes", "arm"}}) {
    std::vector<std::string> arguments{"theorem", "--kind", "energy"};
    arguments.insert(arguments.end(), unused.begin(), unused.end());
    expect_failure_beginning(run(pendulum, arguments), 2, "the energy theorem has no point and no direction");
  }
  expect_failure_beginning(run(pendulum, {"unknowns", "--axes", "arm"}), 2, "--axes is for --isolate BODIES --at POINT");
  expect_failure_beginning(run(pendulum, {"theorem", "--kind", "moment", "--at", "nowhere"}), 3,
                           "unknown point 'nowhere'");
  expect_failure_beginning(run(pendulum, {"theorem", "--bodies", "bib"}), 3, "unknown body 'bib'");
}

/// The text from a heading to the next empty line.
std::string section(const std::string& text, const std::string& heading) {
  const std::size_t begin = text.find("\n" + heading + "\n");
  if (begin == std::string::npos) return "no " + heading + " in\n" + text;
  const std::size_t body = begin + heading.size() + 2;
  return text.substr(body, text.find("\n\n", body) - body);
}

// Watt's governor: −(U + T0) = −2 (m + M) g L cos θ − m L² ω² sin² θ; upright arms rest while m L ω² < (m + M) g.
TEST(StaticsCommand, WritesTheRelativeEquilibriaOfTheGovernor) {
  const std::string any = run(watt_governor_scene, {"statics"}).out;
  EXPECT_EQ(section(any, "Equations of equilibrium"),
            "  -(U + T0) = -2 g (m + M) L cos(theta) - m L^2 omega^2 sin(theta)^2    (in J)\n"
            "  theta:  0 = 2 L sin(theta) (g (m + M) - m L omega^2 cos(theta))");
  const std::string at = run(watt_governor_scene, {"statics", "--about", "theta=0"}).out;
  EXPECT_EQ(section(at, "At theta = 0"), "  Every equation of equilibrium holds: a rest, whatever the parameters.");
  EXPECT_EQ(
      section(at, "Lejeune-Dirichlet"),
      "  H = [ 2 ((g - L omega^2) m + g M) L ]\n"
      "  H: second derivatives of -(U + T0) there.\n"
      "  Stable where H is positive definite, else it cannot conclude (a condition that always holds is left out):\n"
      "    2 ((g - L omega^2) m + g M) L > 0\n"
      "  With the scene's values: cannot conclude: pivot 1 of the Hessian of -(U + T0) is -42.5700, not a minimum.");
  EXPECT_EQ(section(at, "Routh and Hurwitz, linearised equations"),
            "  det(M s^2 + C s + K) has the coefficients\n"
            "  a2 = 2 m L^2\n"
            "  a1 = 0\n"
            "  a0 = 2 ((g - L omega^2) m + g M) L\n"
            "  Cannot conclude that it is stable: a determinant of Hurwitz vanishes whatever the parameters, so that "
            "some root has Re s >= 0.\n"
            "  With the scene's values: unstable, a root has Re s > 0.\n");
}

/// A particle on a round hill that turns G v to its side: s^4 + (G^2 - 2 k) s^2 + k^2 for a mass of 1 kg.
Scene on_a_hill(const std::string& turning) {
  Scene scene("hill");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m");
  const Expression k = scene.parameter("k", "N/m", 1), G = scene.parameter("G", "N s/m", Expression::quantity(turning, "1"));
  scene.body("particle", scene.prismatic("particle", scene.prismatic("slide", scene.ground(), axis::x, x), axis::y, y),
             Inertia::point(Expression::quantity("1", "kg")));
  scene.force_function("hill", k * (x * x + y * y) / 2);
  scene.generalised_force("turn x", x, G * rate(y));
  scene.generalised_force("turn y", y, -G * rate(x));
  return scene;
}

// Stable by the gyroscopic forces for G^2 > 4 k. Between 2 k and 4 k no coefficient is negative, and four roots leave the axis.
TEST(StaticsCommand, CountsTheRootsThatGyroscopicForcesHold) {
  const auto verdict = [](Scene (*scene)()) {
    const std::string all = run(scene, {"statics", "--about", "x=0", "--about", "y=0"}).out;
    const std::string text = section(all, "Routh and Hurwitz, linearised equations");
    return text.substr(text.find("Re s >= 0.\n") + 11);
  };
  const std::string unstable = "  With the scene's values: unstable, a root has Re s > 0.\n";
  EXPECT_EQ(verdict([] { return on_a_hill("1.4"); }), unstable);
  EXPECT_EQ(verdict([] { return on_a_hill("1.99"); }), unstable);
  EXPECT_EQ(verdict([] { return on_a_hill("2.01"); }),
            "  With the scene's values: no root has Re s > 0, and 4 of 4 have Re s = 0.\n");
}

TEST(StaticsCommand, SetsParametersOnly) {
  EXPECT_EQ(section(run(watt_governor_scene, {"statics", "--set", "omega=0"}).out, "Equations of equilibrium"),
            "  -U = -2 g (m + M) L cos(theta)    (in J)\n"
            "  theta:  0 = 2 g (m + M) L sin(theta)");
  expect_failure(run(watt_governor_scene, {"statics", "--set", "theta=0"}), 2,
                 "--set takes parameters, e.g. m=0, and 'theta' is none: name a state by --about");
}

TEST(StaticsCommand, TellsStableFromUnstableAndFromWhatItCannotConclude) {
  const std::string bottom = run(air_damped, {"statics", "--about", "theta=0"}).out;
  EXPECT_EQ(
      section(bottom, "Lejeune-Dirichlet"),
      "  H = [ m l g ]\n"
      "  H: second derivatives of -U there.\n"
      "  Stable where H is positive definite, else it cannot conclude (a condition that always holds is left out):\n"
      "    m l g > 0\n"
      "  With the scene's values: stable: -(U + T0) has a strict minimum; Lejeune-Dirichlet presupposes that 'air' "
      "dissipates and that inputs are zero.");
  EXPECT_EQ(section(bottom, "Routh and Hurwitz, linearised equations"),
            "  det(M s^2 + C s + K) has the coefficients\n"
            "  a2 = m l^2\n"
            "  a1 = c\n"
            "  a0 = m l g\n"
            "  All roots have Re s < 0, and the rest is asymptotically stable, exactly where\n"
            "    m l^2 > 0\n"
            "    c > 0\n"
            "    m l g c > 0\n"
            "  With the scene's values: asymptotically stable.\n");
  const std::string top = run(air_damped, {"statics", "--about", "theta=pi"}).out;
  EXPECT_EQ(
      section(top, "Lejeune-Dirichlet"),
      "  H = [ -m l g ]\n"
      "  H: second derivatives of -U there.\n"
      "  Stable where H is positive definite, else it cannot conclude (a condition that always holds is left out):\n"
      "    -m l g > 0\n"
      "  With the scene's values: cannot conclude: pivot 1 of the Hessian of -(U + T0) is -20.0000, not a minimum.");
  EXPECT_EQ(section(top, "Routh and Hurwitz, linearised equations"),
            "  det(M s^2 + C s + K) has the coefficients\n"
            "  a2 = m l^2\n"
            "  a1 = c\n"
            "  a0 = -m l g\n"
            "  All roots have Re s < 0, and the rest is asymptotically stable, exactly where\n"
            "    m l^2 > 0\n"
            "    c > 0\n"
            "    -m l g c > 0\n"
            "  With the scene's values: unstable, a root has Re s > 0.\n");
  // Without air the roots are imaginary: a condition is an equality there, which decides nothing.
  const std::string still = run(undamped, {"statics", "--about", "theta=0"}).out;
  EXPECT_NE(still.find("  With the scene's values: cannot conclude, a condition is an equality.\n"),
            std::string::npos)
      << still;
  const std::string leaning = run(air_damped, {"statics", "--about", "theta=1"}).out;
  EXPECT_EQ(leaning.find("if this is a rest"), std::string::npos) << "it is none: " << leaning;
  EXPECT_EQ(section(leaning, "At theta = 1"), "  theta:  0 = sin(1) m l g    (must hold for a rest)");
  expect_failure_beginning(run(air_damped, {"statics", "--about", "phi=1"}), 2, "");
}

// Without its turning Watt's governor is two pendulums: no ω is left, and with ω = 0 upright arms are stable.
TEST(StaticsCommand, TakesValuesOfParameters) {
  const std::string still = run(watt_governor_scene, {"statics", "--about", "theta=0", "--set", "omega=0"}).out;
  EXPECT_EQ(section(still, "Equations of equilibrium").find("omega^2"), std::string::npos) << still;
  EXPECT_NE(still.find("  With omega = 0.\n"), std::string::npos) << still;
  EXPECT_NE(still.find("  H = [ 2 g (m + M) L ]\n"), std::string::npos) << still;
  expect_failure_beginning(run(watt_governor_scene, {"statics", "--set", "theta=0"}), 2, "--set takes parameters");
  expect_failure_beginning(run(watt_governor_scene, {"statics", "--set", "omega"}), 2, "--set takes NAME=VALUE");
}

Scene on_a_circle() {
  SlidingPoint it("on_a_circle");
  it.scene.initial(it.y, metres("-1"));
  it.scene.gravity({0, quantity("-10", "m/s^2"), 0});
  it.scene.holonomic("circle", it.x * it.x + it.y * it.y - metres("1") * metres("1"));
  return it.scene;
}

TEST(StaticsCommand, SaysWhyLejeuneDirichletDoesNotApply) {
  const std::string text = run(on_a_circle, {"statics"}).out;
  EXPECT_EQ(
      section(text, "Second derivatives of -U at any configuration"),
      "  Lejeune-Dirichlet cannot conclude: the scene has constraints; describe it with independent coordinates, or "
      "let the runtime project the second derivatives on the tangent space.\n");
}

/// A spring of law 3 N/m along x towards a wall at 2 m sin(5 t), and nothing along y.
Scene shaken_puck() {
  Scene scene("shaken_puck");
  const Expression x = scene.coordinate("x", "m"), y = scene.coordinate("y", "m"), z = scene.coordinate("z", "m");
  const FrameHandle along = scene.prismatic("along", scene.ground(), axis::x, x);
  const FrameHandle across = scene.prismatic("across", along, axis::y, y);
  scene.body("puck", scene.prismatic("puck", across, axis::z, z), Inertia::point(kilograms("1")));
  const Expression wall = metres("2") * sin(Expression::quantity("5", "1/s") * scene.time());
  scene.spring("spring", x - wall, Expression::quantity("3", "N/m"));
  return scene;
}

TEST(StaticsCommand, SaysWhatHoldsEverywhereAndThatTimeStandsInTheRest) {
  const std::string text = section(run(shaken_puck, {"statics"}).out, "Equations of equilibrium");
  EXPECT_EQ(text.find("0 = 0"), std::string::npos) << text;
  EXPECT_NE(text.find("  The equations of y, z hold everywhere: nothing acts along them at rest.\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  Time stands in these equations: a rest fulfils them at every t."), std::string::npos) << text;
  const std::string french = run(shaken_puck, {"statics", "--language", "fr"}).out;
  EXPECT_NE(french.find("Les équations de y, z sont toujours vérifiées : rien n'agit suivant ces paramètres au repos.\n"), std::string::npos) << french;
  EXPECT_NE(french.find("Le temps figure dans ces équations : un équilibre les vérifie à tout instant t.\n"), std::string::npos) << french;
  EXPECT_EQ(run(on_a_circle, {"statics"}).out.find("Time stands"), std::string::npos);
}

// The thread's force along z, cos q sin q − sin q cos q times what it is, does not enter along y.
TEST(TheoremCommand, NamesTheMultipliersThatEnterAndNoOthers) {
  EXPECT_EQ(theorem(nut_on_a_thread, {"--bodies", "nut", "--direction", "y"}),
            "Newton-Euler for nut: resultant along y of ground\n"
            "  0 = lambda_thread_y + [nut Y]\n"
            "  Unknown: [nut Y], lambda_thread_y.\n");
  EXPECT_EQ(theorem(nut_on_a_thread, {"--bodies", "nut", "--kind", "moment", "--at", "nut", "--direction", "z"}),
            "Newton-Euler for nut: moment at nut along z of ground\n"
            "  0 = lambda_thread_rz + [nut N]\n"
            "  Unknown: [nut N], lambda_thread_rz.\n");
}

/// As a robot's arm on a root link that has mass.
Scene arm_on_a_pillar() {
  Scene scene("arm_on_a_pillar");
  const Expression theta = scene.coordinate("theta", "rad");
  scene.body("pillar", scene.weld("pillar", scene.ground(), {}), Inertia::point(kilograms("3")));
  scene.body("arm", scene.revolute("arm", "pillar", axis::z, theta), Inertia::point(kilograms("1")).at({metres("2"), 0, 0}));
  return scene;
}

Scene pillar_alone() {
  Scene scene("pillar_alone");
  scene.prismatic("slide", scene.ground(), axis::x, scene.coordinate("x", "m"));
  scene.body("pillar", scene.weld("pillar", scene.ground(), {}), Inertia::point(kilograms("3")));
  scene.keep_massless();
  return scene;
}

TEST(TheoremCommand, IsolatesAllThatMovesWhereNoBodyIsNamed) {
  const std::vector<std::vector<std::string>> requests{
      {"theorem", "--kind", "moment", "--at", "pillar", "--direction", "z"}, {"theorem", "--kind", "energy"}, {"theorem"}};
  for (const std::vector<std::string>& request : requests) {
    const Outcome outcome = run(arm_on_a_pillar, request);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(" for arm"), std::string::npos) << outcome.out;
  }
  const std::string moment = theorem(arm_on_a_pillar, {"--kind", "moment", "--at", "pillar", "--direction", "z"});
  EXPECT_NE(moment.find("  4 theta'' = 0"), std::string::npos) << moment;
  const Outcome named = run(arm_on_a_pillar, {"theorem", "--bodies", "arm,pillar"});
  EXPECT_EQ(named.code, 3);
  EXPECT_NE(named.err.find("isolates pillar, part of the ground"), std::string::npos) << named.err;
  const Outcome none = run(pillar_alone, {"theorem"});
  EXPECT_EQ(none.code, 3);
  EXPECT_NE(none.err.find("no body of the scene moves"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace torsor::theorem_command_test
