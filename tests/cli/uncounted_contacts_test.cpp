// SPDX-License-Identifier: GPL-3.0-or-later
// What equations of the smooth mechanism leave out is said wherever they are printed, and contents name it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::uncounted_contacts_test {
namespace {

using testing_programs::Outcome;
using testing_programs::run;

/// A pendulum whose bearing rubs, on a link that a rotor drives.
Scene pendulum() {
  Scene scene("pendulum");
  const Expression q = scene.coordinate("q", "rad");
  const FrameHandle rod = scene.revolute("rod", scene.ground(), axis::y, q);
  scene.body("bob", rod, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, Expression::quantity("-1", "m")}));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.dry_friction("bearing", q, {.bound = Expression::quantity("0.1", "N m")});
  scene.reflected_inertia("rotor", q, Expression::quantity("0.2", "kg m^2"));
  return scene;
}

/// A ball over the ground between two walls, which its slide rubs on.
Scene ball() {
  Scene scene("ball");
  const Expression x = scene.coordinate("x", "m"), z = scene.coordinate("z", "m");
  const FrameHandle slide = scene.prismatic("slide", scene.ground(), axis::x, x);
  const FrameHandle lift = scene.prismatic("lift", slide, axis::z, z);
  scene.body("ball", lift, Inertia::point(Expression::quantity("1", "kg")));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  const Expression radius = Expression::quantity("0.1", "m");
  scene.contact("floor", shape::Sphere{.frame = lift, .radius = radius}, shape::Plane{.frame = "ground"}, {});
  scene.stop(x, Expression::quantity("-1", "m"), Expression::quantity("1", "m"));
  scene.joint_friction("guide", slide, {.friction = Expression(Number::rational(1, 10))});
  scene.initial(z, 1);
  return scene;
}

const std::string open = "Every contact is taken to be open here";
const std::string dry = "Dry friction is not counted here: ";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(UncountedContacts, AreSaidWhereEquationsArePrinted) {
  const std::vector<std::vector<std::string>> commands{
      {"unknowns"}, {"statics"}, {"force-function"}, {"theorem", "--kind", "energy"}};
  for (const std::vector<std::string>& command : commands) {
    const Outcome of_pendulum = run(pendulum, command), of_ball = run(ball, command);
    ASSERT_EQ(of_pendulum.code, 0) << of_pendulum.err;
    ASSERT_EQ(of_ball.code, 0) << of_ball.err;
    EXPECT_TRUE(has(of_pendulum.out, dry + "bearing.")) << of_pendulum.out;
    EXPECT_FALSE(has(of_pendulum.out, open)) << "there is none: " << of_pendulum.out;
    EXPECT_TRUE(has(of_ball.out, dry + "guide.")) << of_ball.out;
    EXPECT_TRUE(has(of_ball.out, open)) << of_ball.out;
  }
}

TEST(UncountedContacts, AreInTheContentsAndInTheGraphOfAnalysis) {
  const auto contents = nlohmann::json::parse(run(ball, {"list", "--json"}).out);
  std::vector<std::string> contacts;
  for (const auto& each : contents["contacts"]) {
    contacts.push_back(each["name"].get<std::string>() + ": " + each["kind"].get<std::string>());
  }
  EXPECT_EQ(contacts, (std::vector<std::string>{"floor: contact", "x_lower: stop", "x_upper: stop", "guide: dry friction"}));
  const auto rotors = nlohmann::json::parse(run(pendulum, {"list", "--json"}).out);
  EXPECT_EQ(rotors["reflected_inertias"], nlohmann::json({"rotor"}));
  EXPECT_EQ(rotors["frames"], nlohmann::json({"ground", "rod", "rotor"})) << "as the columns of the kernel poses";
  EXPECT_EQ(rotors["bodies"], nlohmann::json({"bob"}));
  std::vector<std::string> links;
  const auto structure = nlohmann::json::parse(run(ball, {"structure", "--json"}).out);
  for (const auto& each : structure["links"]) {
    links.push_back(each["name"].get<std::string>() + ": " + each["what"].get<std::string>());
  }
  for (const char* link : {"floor: contact", "x_lower: stop", "guide: dry friction"}) {
    EXPECT_EQ(std::count(links.begin(), links.end(), link), 1) << link;
  }
}

}  // namespace
}  // namespace torsor::uncounted_contacts_test
