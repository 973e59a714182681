// SPDX-License-Identifier: GPL-3.0-or-later
// Links that touch each other.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "tests/import/urdf_motion.hpp"

namespace torsor::urdf_contacts_test {
namespace {

using namespace testing_urdf;

std::string with_collisions(const std::string& name, const std::vector<std::string>& collisions) {
  const std::string whole = link(name);
  std::string text = whole.substr(0, whole.rfind("</link>"));
  for (const std::string& each : collisions) text += "<collision>" + each + "</collision>";
  return text + "</link>";
}
std::string sphere(const std::string& radius, const std::string& place) {
  return "<origin xyz=\"" + place + "\"/><geometry><sphere radius=\"" + radius + "\"/></geometry>";
}

const std::string limit = "<limit lower=\"-9\" upper=\"9\" effort=\"9\" velocity=\"9\"/>";
const std::string cell =
    with_collisions("base", {sphere("0.1", "0 0 -9")}) + with_collisions("ball", {sphere("0.05", "0 0 0.1")}) +
    with_collisions("pair", {sphere("0.1", "0.3 0 0"), sphere("0.2", "-0.4 0 0")}) +
    // Its x axis points down, its z axis along x.
    with_collisions(
        "table",
        {"<origin xyz=\"0 0 -0.5\" rpy=\"0 1.5707963267948966 0\"/><geometry><box size=\"0.4 0.6 1\"/></geometry>"}) +
    with_collisions("drum", {"<geometry><cylinder radius=\"0.3\" length=\"0.5\"/></geometry>"}) +
    with_collisions("hood", {"<geometry><mesh filename=\"hood.stl\"/></geometry>"}) +
    with_collisions("knob", {sphere("0.01", "0 0 0")}) + with_collisions("left:ball", {sphere("0.02", "0 0 0")}) +
    link("bare") + joint("lift", "prismatic", "base", "ball", "<origin xyz=\"0 0 2\"/><axis xyz=\"0 0 1\"/>" + limit) +
    joint("slide", "prismatic", "base", "pair", "<origin xyz=\"0 3 0\"/><axis xyz=\"0 1 0\"/>" + limit) +
    joint("ram", "prismatic", "base", "table", "<axis xyz=\"0 0 1\"/>" + limit) +
    joint("spin", "revolute", "base", "drum", "<origin xyz=\"1.5 0 4\"/><axis xyz=\"0 1 0\"/>" + limit) +
    joint("hinge", "revolute", "base", "hood", "<axis xyz=\"0 1 0\"/>" + limit) +
    joint("screw", "fixed", "ball", "knob", "") +
    joint("rail", "prismatic", "base", "left:ball", "<origin xyz=\"0 -2 0\"/><axis xyz=\"0 1 0\"/>" + limit) +
    joint("glue", "fixed", "base", "bare", "");

UrdfOptions meeting(std::vector<std::string> contacts) {
  UrdfOptions options;
  options.contacts.named = std::move(contacts);
  return options;
}

/// Gaps at the start, by the contacts' names.
std::map<std::string, double> gaps(const std::vector<std::string>& contacts) {
  const Scene scene = read(cell, meeting(contacts));
  validate(scene);
  Program program(Model::resolver(scene, {}));
  const std::vector<ContactRows> rows = contact_rows(Model(scene, program));
  Evaluator<Real> start(program,
                        [&scene](const SymbolPointer& symbol) { return initial_value(scene.content(), symbol); });
  std::map<std::string, double> result;
  for (const ContactRows& each : rows) result[each.name] = start(each.gap).to_double();
  return result;
}

void expect_gaps(const std::vector<std::string>& contacts, const std::map<std::string, double>& expected) {
  const auto found = gaps(contacts);
  ASSERT_EQ(found.size(), expected.size());
  // Roundings of numbers below 5.
  for (const auto& [name, gap] : expected) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_NEAR(found.at(name), gap, 2e-15) << name;
  }
}

// Centres at (0, 0, 2.1), (0.3, 3, 0) and (-0.4, 3, 0).
TEST(UrdfContacts, OfSpheresAreOfEachWithEach) {
  expect_gaps({"ball:pair"}, {{"ball_pair_1", std::sqrt(0.09 + 9 + 2.1 * 2.1) - 0.15},
                              {"ball_pair_2", std::sqrt(0.16 + 9 + 2.1 * 2.1) - 0.25}});
  expect_gaps({"pair:ball"}, {{"pair_ball_1", std::sqrt(0.09 + 9 + 2.1 * 2.1) - 0.15},
                              {"pair_ball_2", std::sqrt(0.16 + 9 + 2.1 * 2.1) - 0.25}});
}

// Names may hold the colon that parts the links.
TEST(UrdfContacts, TakeTheLinksThatAreThere) {
  expect_gaps({"left:ball:ball"}, {{"left_ball_ball", std::sqrt(4 + 2.1 * 2.1) - 0.07}});
  expect_gaps({"ball:left:ball"}, {{"ball_left_ball", std::sqrt(4 + 2.1 * 2.1) - 0.07}});
}

// The table's face -x is at z = -0.3 and points up, its face +z at x = 0.5; the drum's face -z is at z = 3.75 and
// points down.
TEST(UrdfContacts, OfAFaceAreThoseOfItsPlane) {
  expect_gaps({"ball:table-x"}, {{"ball_table", 2.1 - 0.05 + 0.3}});
  expect_gaps({"table-x:ball"}, {{"table_ball", 2.1 - 0.05 + 0.3}});
  expect_gaps(
      {"ball:drum-z", "drum:table+z"},
      {{"ball_drum", 3.75 - 2.1 - 0.05}, {"drum_table_top", 1.5 - 0.3 - 0.5}, {"drum_table_base", 1.5 - 0.3 - 0.5}});
  std::map<std::string, double> corners;
  for (int k = 1; k <= 8; ++k) corners["table_drum_" + std::to_string(k)] = k <= 4 ? 3.75 + 0.3 : 3.75 + 0.7;
  expect_gaps({"table:drum-z"}, corners);
}

TEST(UrdfContacts, HaveTheirCoefficientsAsParameters) {
  UrdfOptions options = meeting({"ball:pair"});
  options.contacts.friction = Number::rational(1, 4);
  options.contacts.restitution = Number::rational(3, 4);
  const Scene scene = read(cell, options);
  std::map<std::string, double> values;
  for (const ParameterContent& each : scene.content().parameters) {
    if (each.run_time) values[each.symbol->name] = initial_value(scene.content(), each.symbol).to_double();
  }
  EXPECT_EQ(values, (std::map<std::string, double>{{"contacts_friction", 0.25}, {"contacts_restitution", 0.75}}));
}

template <class Refusal>
void expect_refused(const std::vector<std::string>& contacts, const std::string& message) {
  try {
    validate(read(cell, meeting(contacts)));
    ADD_FAILURE() << "accepted; expected: " << message;
  } catch (const Refusal& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(UrdfContacts, RefuseWhatIsNoPairOfLinksThatCanMeet) {
  expect_refused<UsageError>({"ball"}, "--contacts takes pairs of links, A:B, e.g. left_finger:ball, and got 'ball'");
  expect_refused<UsageError>({"ball:tabel"},
                             "the link 'tabel' in --contacts ball:tabel is unknown: did you mean 'table'");
  expect_refused<UsageError>({"tabel+z:pair"},
                             "the link 'tabel' in --contacts tabel+z:pair is unknown: did you mean 'table'");
  expect_refused<UsageError>({"ball:bare"}, "the link 'bare' in --contacts ball:bare has no <collision>");
  expect_refused<FileError>({"ball:hood"}, "the <collision> of the link 'hood' is no sphere, box or cylinder");
  expect_refused<UsageError>({"ball:ball"}, "names the link 'ball' twice, and a link does not meet itself");
  expect_refused<UsageError>({"ball:base"},
                             "the links 'ball' and 'base' of --contacts ball:base share the joint 'lift'");
  expect_refused<UsageError>({"ball:knob"},
                             "the links 'ball' and 'knob' of --contacts ball:knob are one body by fixed joints");
  expect_refused<UsageError>({"knob:pair", "pair:knob"},
                             "--contacts pair:knob is a pair that was named before: name it once");
  expect_refused<SceneError>({"ball:drum+z"}, "contact 'ball_drum' starts penetrating: its gap is -2.2 m at t = 0");
  // Two are one body by a joint that an option fixes.
  UrdfOptions options = meeting({"ball:pair"});
  options.fix = {"lift", "slide"};
  EXPECT_THROW(read(cell, options), UsageError);
}

TEST(UrdfContacts, RefuseShapesThatHaveNoExactContact) {
  expect_refused<UsageError>(
      {"ball:table"},
      "the sphere of 'ball' and the box of 'table' in --contacts ball:table have no exact contact: "
      "write spheres in their place, or name a face as in --contacts ball:table+z, which is then");
  expect_refused<UsageError>(
      {"drum:pair"},
      "the cylinder of 'drum' and the sphere of 'pair' in --contacts drum:pair have no exact contact: "
      "write spheres in their place, or name a face as in --contacts drum+z:pair, which is then");
  expect_refused<UsageError>({"drum:table"}, "as in --contacts drum:table+z");
  expect_refused<UsageError>({"ball:pair+x"}, "the link 'pair' in --contacts ball:pair+x has 2 <collision> elements");
  expect_refused<UsageError>(
      {"ball+x:pair"},
      "the <collision> of the link 'ball' in --contacts ball+x:pair is a sphere, which has no plane face +x");
  expect_refused<UsageError>({"ball:drum+x"}, "is a cylinder, which has no plane face +x");
  expect_refused<UsageError>({"drum-z:table+x"}, "names two faces, which meet along edges");
}

}  // namespace
}  // namespace torsor::urdf_contacts_test
