// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/queries.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/scenes/bodies.hpp"

// From here to its closing brace the function is the example of docs/queries.md, word by word.
std::string ask(const torsor::Scene& scene, const std::string& body, const std::string& hinge) {
  using namespace torsor;
  ModelOptions symbolic;
  symbolic.symbolic_parameters = true;
  const Equations equations(scene, symbolic);
  const auto written = [](const Value& value) { return readable(multiplied_out(value)); };

  // Newton-Euler: the moment about the hinge's axis z moves the body, the resultant along x gives the force on it.
  const TheoremEquation moment = theorem_equation(equations, {body}, {{Scene::point(hinge)}, Theorem::moment, axis::z});
  const TheoremEquation force = theorem_equation(equations, {body}, {{Scene::point(hinge)}, Theorem::resultant, axis::x});
  std::string text = written(moment.left) + " = " + written(moment.right) + "\n";
  text += written(force.left) + " = " + written(force.right) + "\n";

  // The energy theorem; action_power has the power of one action alone.
  const EnergyEquation energy = energy_equation(equations, {body});
  text += written(energy.equation.left) + " = " + written(energy.equation.right) + "\n";

  // Statics: where the moment vanishes at rest, and when the second derivative of the potential is positive there.
  const EquilibriumEquations statics = equilibrium_equations(equations);
  text += print_equilibrium(statics);
  const AtState hanging(equations, {{Expression(equations.model().coordinates()[0].q), 0}});
  text += readable_conditions(sylvester_conditions(equations.program(), hanging(statics.hessian)));
  return text;
}

namespace torsor::queries_test {
namespace {

using namespace testing_mechanisms;

Scene hinged_rod() {
  Scene scene("rod");
  const Expression m = scene.parameter("m", "kg"), l = scene.parameter("l", "m"), g = scene.parameter("g", "m/s^2");
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle rod = scene.revolute("rod", scene.ground(), axis::z, theta);
  scene.body("rod", rod, Inertia::point(m).at({0, -l, 0}));
  scene.point("O", scene.ground(), {0, 0, 0});
  scene.gravity({0, -g, 0});
  return scene;
}

// Pendulum of length l: m l² θ'' = −m g l sin θ, m d²(l sin θ)/dt² = X cos θ − Y sin θ along the ground's x.
TEST(Queries, AnswerAsThePageSays) {
  EXPECT_EQ(ask(hinged_rod(), "rod", "O"),
            "theta'' m l^2 = -sin(theta) m l g\n"
            "-theta'^2 sin(theta) m l + theta'' cos(theta) m l = -sin(theta) [rod Y] + cos(theta) [rod X]\n"
            "theta' theta'' m l^2 = -theta' sin(theta) m l g\n"
            "-U = -cos(theta) m l g\n"
            "theta:  0 = sin(theta) m l g\n"
            "m l g > 0\n");
}

TEST(Queries, AreShownOnTheirPageAsTheyAreCompiled) {
  const auto text_of = [](const std::string& path) {
    std::ifstream file(TORSOR_SOURCE_DIR "/" + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  };
  const std::string source = text_of("tests/dynamics/queries_test.cpp");
  const std::size_t begin = source.find("std::string ask("), end = source.find("\n}\n", begin);
  ASSERT_NE(begin, std::string::npos);
  EXPECT_NE(text_of("docs/queries.md").find(source.substr(begin, end + 3 - begin)), std::string::npos);
}

}  // namespace
}  // namespace torsor::queries_test
