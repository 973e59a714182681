// SPDX-License-Identifier: GPL-3.0-or-later
// What options add to a robot's file: rotors, dry friction, gravity as parameters.
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_drives_test {
namespace {

using namespace testing_urdf;

const std::string arm = "<link name=\"base\"/>" + link("upper") + link("hand") + link("finger") +
                        joint("elbow", "revolute", "base", "upper", "<axis xyz=\"0 1 0\"/><dynamics friction=\"0.7\"/>") +
                        joint("slide", "prismatic", "upper", "hand", "<origin xyz=\"0.3 0 0\"/><axis xyz=\"1 0 0\"/>") +
                        joint("grip", "prismatic", "hand", "finger",
                              "<axis xyz=\"0 0 1\"/><mimic joint=\"slide\" multiplier=\"-2\"/><dynamics friction=\"0.1\"/>");

std::vector<std::vector<double>> mass_matrix(const UrdfOptions& options) {
  const Equations equations(read(arm, options));
  Evaluator<Real> at(equations.program(), [](const SymbolPointer& symbol) {
    return symbol->kind == SymbolKind::pi ? Real::pi(50) : symbol->name == "elbow" ? Real(2) : Real(3);
  });
  std::vector<std::vector<double>> numbers;
  for (const auto& row : equations.mass()) {
    numbers.emplace_back();
    for (const Value& entry : row) numbers.back().push_back(at(entry).to_double());
  }
  return numbers;
}

std::string refusal(const UrdfOptions& options) {
  try {
    read(arm, options);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

/// ½ a q̇² of each joint; the mimic's displacement is −2 times the slide's, so that its rotor counts four times.
TEST(UrdfDrives, AddRotorsToTheDiagonalOfTheMassMatrix) {
  UrdfOptions options;
  const auto without = mass_matrix(options);
  options.armature = {{"elbow", Number::rational(1, 4)}, {"slide", Number(3)}, {"grip", Number::rational(1, 2)}};
  const auto with = mass_matrix(options);
  ASSERT_EQ(with.size(), 2U);
  // Sums of some numbers of size one, each rounded once from fifty digits.
  EXPECT_NEAR(with[0][0] - without[0][0], 0.25, 1e-14);
  EXPECT_NEAR(with[1][1] - without[1][1], 3 + 4 * 0.5, 1e-14);
  EXPECT_EQ(with[0][1], without[0][1]);
}

TEST(UrdfDrives, AddDryFrictionOfTheFileAndOfTheOption) {
  UrdfOptions options;
  EXPECT_TRUE(read(arm, options).content().contacts.empty());
  options.friction_of_file = true;
  options.friction = {{"elbow", Number(2)}, {"slide", Number(5)}};
  const Scene scene = read(arm, options);
  std::vector<std::string> names;
  for (const ContactContent& contact : scene.content().contacts) {
    names.push_back(contact.name);
    EXPECT_TRUE(std::holds_alternative<FrictionAlong>(contact.geometry));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"elbow_dry_friction", "slide_dry_friction", "grip_dry_friction"}));
  std::map<std::string, double> values;
  for (const ParameterContent& parameter : scene.content().parameters) {
    if (parameter.symbol->name.ends_with("_friction")) {
      values[parameter.symbol->name] = parameter_value(scene.content(), Expression(parameter.symbol)).to_double();
    }
  }
  EXPECT_EQ(values, (std::map<std::string, double>{{"elbow_friction", 2}, {"slide_friction", 5}, {"grip_friction", 0.1}}));
}

/// Fifty digits, each formula in another order.
TEST(UrdfDrives, TakeGravityFromParametersOfRunTime) {
  UrdfOptions numbers, symbols;
  numbers.gravity = {Number(1), Number(2), Number(-3)};
  symbols.run_time_gravity = true;
  const Values q{{"elbow", "0.7"}, {"slide", "0.2"}}, v{{"elbow", "-2"}, {"slide", "1"}};
  expect_same(accelerations(read(arm, symbols), q, v, {{"gravity_x", "1"}, {"gravity_y", "2"}, {"gravity_z", "-3"}}),
              accelerations(read(arm, numbers), q, v), 1e-40);
  expect_same(accelerations(read(arm, symbols), q, v, {{"gravity_z", "-9.81"}}), accelerations(read(arm), q, v), 1e-40);
}

TEST(UrdfDrives, RefuseJointsThatAreNotThere) {
  UrdfOptions options;
  options.armature = {{"elbw", Number(1)}};
  EXPECT_EQ(refusal(options),
            "unknown joint 'elbw' in --armature: did you mean 'elbow'? those that turn or slide are elbow, slide, grip");
  options = {};
  options.friction = {{"slide", Number(-1)}};
  EXPECT_EQ(refusal(options), "--friction of the joint 'slide' is -1; it is never negative");
}

TEST(UrdfDrives, AreInTheCommandOfTheHead) {
  UrdfOptions options;
  options.armature = {{"elbow", Number::rational(1, 4)}};
  options.friction = {{"slide", Number(5)}};
  options.friction_of_file = options.run_time_gravity = true;
  EXPECT_EQ(read(arm, options).content().origin.arguments,
            "machine.urdf --run-time-gravity --armature elbow=0.25 --friction file,slide=5");
}

}  // namespace
}  // namespace torsor::urdf_drives_test
