// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/urdf_robot.hpp"

namespace torsor::urdf_errors_test {
namespace {

/// The file is refused with this message, which begins with "bad.urdf:".
void expect_refused(const std::string& text, const std::string& message) {
  try {
    read_urdf_text(text, "bad.urdf");
    ADD_FAILURE() << "accepted; expected: " << message;
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), "bad.urdf:" + message);
  }
}

/// A robot of two links, lines 2 and 3, whose joint, from line 4, holds what is given.
std::string with_joint(const std::string& inside, const std::string& attributes = "name=\"j\" type=\"revolute\"") {
  return "<robot name=\"r\">\n<link name=\"a\"/>\n<link name=\"b\"/>\n<joint " + attributes + ">\n" + inside +
         "\n</joint></robot>";
}
const std::string ends = "<parent link=\"a\"/><child link=\"b\"/>";

/// A robot of one link with that inertial, on line 3.
std::string with_inertial(const std::string& inside) {
  return "<robot name=\"r\">\n<link name=\"a\">\n<inertial>" + inside + "</inertial></link></robot>";
}
const std::string moments = "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>";

TEST(UrdfErrors, OfXmlNameFileAndLine) {
  expect_refused("", "1: malformed XML: the file is empty; it must hold a <robot> element");
  expect_refused("<robot name=\"r\">\n<link name=\"a\">\n</robot>",
                 "3: malformed XML: </robot> stands where </link> must: <link> of line 2 is not closed by its own name");
  expect_refused("<robot name=\"r\">\n<link name=\"a\"/>\n",
                 "2: malformed XML: </robot> is missing: <robot> of line 1 is not closed when the file ends");
  expect_refused("<robot name=\"r>\">\n<!-- <a> --><![CDATA[<b>]]><link name=\"a\"></link></robots>",
                 "2: malformed XML: </robots> stands where </robot> must: <robot> of line 1 is not closed by its own name");
  expect_refused("<robot name=\"r\">\n<link name=a/></robot>",
                 "2: malformed XML: an attribute cannot be read; write name=\"value\", with quotes, and separate "
                 "attributes by spaces");
  expect_refused("<robot name=\"r\">\n\n<!-- open", "3: malformed XML: a comment is not closed; end it with -->");
  expect_refused("<robot name=\"r\">\n<link name=\"a\"/>\n<?view x=\"1\"?></robot>",
                 "3: malformed XML: <? ... ?> stands behind an element, or is not closed; move it to the head of the file, or "
                 "remove it");
  expect_refused("<!-- nothing -->", "1: the file holds no element; it must hold a <robot> element");
  expect_refused(
      "<robot name=\"r\"/>\n<robot name=\"s\"/>",
      "2: <robot name=\"s\">: stands beside the root element; an XML file has one root, which holds all others");
  expect_refused(std::string("<robot\0/>", 9), "1: the file is binary and no XML");
}

TEST(UrdfErrors, OfTheRobotNameTheElement) {
  expect_refused("<sdf/>",
                 "1: <sdf>: files that are read here have the root element <robot> (URDF, xacro) or <mujoco> (MJCF); convert "
                 "others, as SDF, to one of these first");
  expect_refused("<Robot/>", "1: <Robot>: the root element of a URDF file is <robot>; did you mean that?");
  expect_refused("<robot name=\"r\"/>", "1: <robot name=\"r\">: has no <link>; a robot has at least one");
  expect_refused("<robot name=\"r\"><link/></robot>",
                 "1: <link> of <robot name=\"r\">: has no attribute name; add name=\"...\"");
  expect_refused("<robot name=\"r\"><link name=\"a\"/>\n<link name=\"a\"/></robot>",
                 "2: <link name=\"a\">: another link at line 1 has the same name; give each its own");
}

TEST(UrdfErrors, OfAJointNameWhatIsMissing) {
  expect_refused(with_joint(ends, "name=\"j\" type=\"hinge\""),
                 "4: <joint name=\"j\">: unknown type of joint 'hinge'; use revolute, continuous, prismatic, fixed, "
                 "floating, planar or spherical");
  expect_refused(with_joint(ends, "name=\"j\" type=\"revolut\""),
                 "4: <joint name=\"j\">: unknown type of joint 'revolut'; did you mean 'revolute'? use revolute, "
                 "continuous, prismatic, fixed, floating, planar or spherical");
  expect_refused(with_joint(ends, "name=\"j\""), "4: <joint name=\"j\">: has no attribute type; add type=\"...\"");
  expect_refused(with_joint(ends, "type=\"fixed\""),
                 "4: <joint> of <robot name=\"r\">: has no attribute name; add name=\"...\"");
  expect_refused(with_joint("<child link=\"b\"/>"),
                 "4: <joint name=\"j\">: has no <parent>; add <parent link=\"...\"/> inside it");
  expect_refused(with_joint("<parent link=\"a\"/>"),
                 "4: <joint name=\"j\">: has no <child>; add <child link=\"...\"/> inside it");
  expect_refused(with_joint("<parent/><child link=\"b\"/>"),
                 "5: <parent> of <joint name=\"j\">: has no attribute link; add link=\"...\"");
  expect_refused(
      with_joint("<parent link=\"a\"/>\n<child link=\"c\"/>"),
      "6: <child> of <joint name=\"j\">: there is no link 'c'; declare it by <link name=\"c\"/> or correct the "
      "name");
  expect_refused(with_joint(ends + "\n<parent link=\"b\"/>"),
                 "6: <parent> of <joint name=\"j\">: there is another <parent> at line 5; keep one");
  expect_refused(with_joint(ends + "<axis xyz=\"0 0 0\"/>"),
                 "5: <axis> of <joint name=\"j\">: xyz is the null vector; give the direction of the joint, e.g. "
                 "xyz=\"0 0 1\"");
  expect_refused(with_joint(ends + "<axis/>"),
                 "5: <axis> of <joint name=\"j\">: has no attribute xyz; add xyz=\"...\"");
  expect_refused(with_joint(ends + "<origin rpy=\"0 0 1\" quat_xyzw=\"0 0 0 1\"/>"),
                 "5: <origin> of <joint name=\"j\">: has both rpy and quat_xyzw, which say the same thing twice; keep one");
  expect_refused(with_joint(ends + "<origin quat_xyzw=\"0 0 0 0\"/>"),
                 "5: <origin> of <joint name=\"j\">: quat_xyzw is the null quaternion, which is no orientation; write 0 0 0 "
                 "1 for none");
  expect_refused(with_joint(ends + "<dynamics damping=\"-1\"/>"),
                 "5: <dynamics> of <joint name=\"j\">: damping and friction take energy away; they are never negative");
}

// What a misspelt attribute says would be dropped without a word: the motion would be another one.
TEST(UrdfErrors, OfMisspeltAttributesAskWhetherAnotherIsMeant) {
  expect_refused(with_joint(ends + "<dynamics dampng=\"1\"/>"),
                 "5: <dynamics> of <joint name=\"j\">: has an attribute dampng: did you mean 'damping'? the attributes that "
                 "act are damping, friction");
  expect_refused(with_joint(ends + "<limit uper=\"1\"/>"),
                 "5: <limit> of <joint name=\"j\">: has an attribute uper: did you mean 'upper'? the attributes that act are "
                 "lower, upper, velocity, effort");
  expect_refused(with_joint(ends + "<origin XYZ=\"0 0 1\"/>"),
                 "5: <origin> of <joint name=\"j\">: has an attribute XYZ: did you mean 'xyz'? the attributes that act are "
                 "xyz, rpy, quat_xyzw");
  expect_refused(with_inertial("<mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" iyw=\"0.1\"/>"),
                 "3: <inertia> of <inertial> of <link name=\"a\">: has an attribute iyw: did you mean 'iyy' or 'iyz'? the "
                 "attributes that act are ixx, ixy, ixz, iyy, iyz, izz");
}

// Exporters write the whole matrix of inertia. An entry below the diagonal that says the same, or nothing, loses nothing;
// another one would be dropped.
TEST(UrdfErrors, OfAMatrixOfInertiaThatIsNotSymmetric) {
  const auto robot = [](const std::string& products) {
    return with_inertial("<mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" " + products + "/>");
  };
  const auto read = [&](const std::string& products) {
    return read_robot(robot(products), "good.urdf", Number::rational(1, 1000000000));
  };
  EXPECT_EQ(read("ixy=\"0.1\" iyx=\"0.10\" ixz=\"0\" izx=\"0\" iyz=\"-0.2\" izy=\"-2e-1\"").notes.lines(),
            std::vector<std::string>());
  const UrdfRobot zeros = read("ixy=\"0.1\" iyx=\"0\" izx=\"0\" izy=\"0\"");
  EXPECT_EQ(zeros.notes.lines(), std::vector<std::string>{"iyx, izx or izy of <inertia> is zero where ixy, ixz or iyz is "
                                                         "not; the latter act: link a"});
  ASSERT_TRUE(zeros.links.front().inertial);
  EXPECT_EQ(zeros.links.front().inertial->inertia[0][1], Number::rational(1, 10));
  expect_refused(robot("iyx=\"0.1\""),
                 "3: <inertia> of <inertial> of <link name=\"a\">: has iyx=\"0.1\" and no ixy, but a matrix of inertia is "
                 "symmetric, and ixy acts; correct one of them, or remove iyx");
  expect_refused(robot("iyz=\"0.1\" izy=\"-0.1\""),
                 "3: <inertia> of <inertial> of <link name=\"a\">: has izy=\"-0.1\" and iyz=\"0.1\", but a matrix of inertia "
                 "is symmetric, and iyz acts; correct one of them, or remove izy");
}

TEST(UrdfErrors, OfMisspeltElementsAskWhetherAnotherIsMeant) {
  const auto refused = [](const std::string& text, const std::string& part) {
    try {
      read_urdf_text(text, "bad.urdf");
    } catch (const FileError& error) {
      return std::string(error.what()).find(part) != std::string::npos;
    }
    return false;
  };
  for (const auto& [element, meant] : std::vector<std::pair<std::string, std::string>>{{"orgin", "origin"},
                                                                                       {"Origin", "origin"},
                                                                                       {"axes", "axis"},
                                                                                       {"dynamic", "dynamics"},
                                                                                       {"limits", "limit"},
                                                                                       {"mimik", "mimic"},
                                                                                       {"parents", "parent"},
                                                                                       {"chlid", "child"}}) {
    EXPECT_TRUE(refused(with_joint(ends + "<" + element + "/>"),
                        "bad.urdf:5: <" + element + "> of <joint name=\"j\">: stands in <joint>, which holds no such "
                        "element: did you mean '" + meant + "'"))
        << element;
  }
  const std::string robot = "<robot name=\"r\"><link name=\"a\">";
  EXPECT_TRUE(refused(robot + "<inertail/></link></robot>", "did you mean 'inertial'"));
  EXPECT_TRUE(refused(robot + "<inertial><mas value=\"1\"/></inertial></link></robot>", "did you mean 'mass'"));
  EXPECT_TRUE(refused(robot + "</link><jiont/></robot>", "did you mean 'joint'"));
  EXPECT_TRUE(refused(robot + "</link><Link/></robot>", "did you mean 'link'"));
}

TEST(UrdfErrors, OfWhatActsInAnotherPlaceNameThatPlace) {
  expect_refused(with_joint(ends, "name=\"j\" type=\"revolute\" axis=\"0 0 1\""),
                 "4: <joint name=\"j\">: has an attribute axis, which would be ignored; write it as <axis> inside <joint>");
  expect_refused("<robot name=\"r\">\n<link name=\"a\" mass=\"1\"/></robot>",
                 "2: <link name=\"a\">: has an attribute mass, which would be ignored; write it as <mass> inside "
                 "<inertial>");
  expect_refused(with_joint(ends, "name=\"j\" type=\"revolute\" damping=\"1\""),
                 "4: <joint name=\"j\">: has an attribute damping, which belongs to <dynamics> and would be ignored here; "
                 "move it there");
  expect_refused("<robot name=\"r\"><link name=\"a\">\n<mass value=\"1\"/></link></robot>",
                 "2: <mass> of <link name=\"a\">: belongs to <inertial> and would be ignored in <link>; move it there");
  expect_refused("<robot name=\"r\"><link name=\"a\"><visual>\n<inertial/></visual></link></robot>",
                 "2: <inertial> of <visual> of <link name=\"a\">: belongs to <link> and would be ignored in <visual>; move "
                 "it there");
  expect_refused("<robot name=\"r\"><link name=\"a\"/>\n<drake:joint name=\"j\"/></robot>",
                 "2: <drake:joint name=\"j\">: is read by another program only, and the motion depends on it; write "
                 "<joint>, or remove it");
}

TEST(UrdfErrors, OfNumbersQuoteThem) {
  const std::string origin = "5: <origin> of <joint name=\"j\">: ";
  expect_refused(with_joint(ends + "<origin xyz=\"0 1\"/>"),
                 origin + "xyz=\"0 1\" holds 2 numbers and must hold 3, separated by spaces");
  expect_refused(with_joint(ends + "<origin xyz=\"0 1 2 3\"/>"),
                 origin + "xyz=\"0 1 2 3\" holds 4 numbers and must hold 3, separated by spaces");
  for (const std::string word : {"1,0", "nan", "inf", "1/2", "1e", "0x10", "--1"}) {
    expect_refused(
        with_joint(ends + "<origin xyz=\"0 " + word + " 1\"/>"),
        origin + "xyz=\"0 " + word + " 1\": '" + word + "' is not a number; write a decimal such as 0.25 or -1.5e-3");
  }
  expect_refused(with_joint(ends + "<origin xyz=\"0 ${length} 1\"/>"),
                 origin + "xyz=\"0 ${length} 1\": '${length}' is a xacro expression; expand the file with xacro first");
  expect_refused(with_joint(ends + "<origin xyz=\"0 1e301 1\"/>"),
                 origin +
                     "xyz=\"0 1e301 1\": '1e301' is beyond the range of a double; write 0 or a number between 1e-300 "
                     "and 1e300");
  expect_refused(with_joint(ends + "<origin rpy=\"0 0 1e7\"/>"),
                 origin + "an angle is beyond 10^6; give angles in radians");
  expect_refused(
      with_joint(ends + "<limit effort=\"much\"/>"),
      "5: <limit> of <joint name=\"j\">: effort=\"much\": 'much' is not a number; write a decimal such as 0.25 "
      "or -1.5e-3");
}

TEST(UrdfErrors, OfTheTreeNameLinksAndJoints) {
  const std::string links = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\n";
  const auto fixed = [](const std::string& name, const std::string& parent, const std::string& child) {
    return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" + child +
           "\"/></joint>\n";
  };
  expect_refused(
      links + fixed("j", "a", "c") + fixed("k", "b", "c") + "</robot>",
      "3: <child> of <joint name=\"k\">: the link 'c' has two parents: 'a' by the joint 'j' of line 2, and 'b'; a "
      "link is the child of one joint, so remove one (a closed loop cannot be written in URDF: write that "
      "mechanism as a scene)");
  expect_refused(
      links + fixed("j", "a", "b") + fixed("k", "b", "a") + "</robot>",
      "2: <joint name=\"j\">: closes a loop of joints: 'j', 'k'; the links of a robot form a tree, so let one of "
      "them begin at another link");
  expect_refused(links + fixed("j", "a", "a") + "</robot>",
                 "2: <joint name=\"j\">: joins the link 'a' to itself; a joint has two different links");
  expect_refused(
      links + "<link name=\"d\"><inertial><mass value=\"1\"/></inertial></link>\n" + fixed("j", "a", "b") + "</robot>",
      "2: <link name=\"d\">: is the child of no joint, as 'a' of line 1 is; a robot has one root link, so join "
      "this one to another");
  expect_refused(links + fixed("j", "a", "b") + fixed("j", "b", "c") + "</robot>",
                 "3: <joint name=\"j\">: another joint at line 2 has the same name; give each its own");
}

TEST(UrdfErrors, OfMimicsNameTheJoints) {
  const auto robot = [](const std::string& first, const std::string& second, const std::string& type = "revolute") {
    return "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\n<joint name=\"j\" type=\"" +
           type + "\"><parent link=\"a\"/><child link=\"b\"/>" + first +
           "</joint>\n<joint name=\"k\" type=\"revolute\"><parent link=\"b\"/><child link=\"c\"/>" + second +
           "</joint></robot>";
  };
  expect_refused(robot("", "<mimic joint=\"J\"/>"),
                 "3: <mimic> of <joint name=\"k\">: there is no joint 'J' to mimic; did you mean 'j'? correct the name");
  expect_refused(robot("", "<mimic/>"), "3: <mimic> of <joint name=\"k\">: has no attribute joint; add joint=\"...\"");
  expect_refused(
      robot("<mimic joint=\"k\"/>", "<mimic joint=\"j\"/>"),
      "2: <mimic> of <joint name=\"j\">: the joints mimic one another in a circle: 'j' -> 'k' -> 'j'; let one of "
      "them be free");
  expect_refused(
      robot("", "<mimic joint=\"k\"/>"),
      "3: <mimic> of <joint name=\"k\">: the joints mimic one another in a circle: 'k' -> 'k'; let one of them "
      "be free");
  expect_refused(
      robot("", "<mimic joint=\"j\"/>", "planar"),
      "3: <mimic> of <joint name=\"k\">: the joint 'j' has no single displacement to mimic; name a revolute, "
      "continuous or prismatic joint");
  expect_refused(
      robot("<mimic joint=\"k\"/>", "", "planar"),
      "2: <mimic> of <joint name=\"j\">: only revolute, continuous and prismatic joints can mimic; remove it or "
      "change the type of joint");
}

TEST(UrdfErrors, OfInertiaNameTheLink) {
  const std::string place = "3: <inertial> of <link name=\"a\">: ";
  expect_refused(with_inertial("<mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\"/>"),
                 "3: <inertia> of <inertial> of <link name=\"a\">: has no attribute izz; add izz=\"...\"");
  expect_refused(with_inertial("<mass value=\"-1\"/>" + moments),
                 place +
                     "body 'a' has the mass a_mass = -1 kg: a mass is never negative; subtract a hole from the body it is cut "
                     "from, as in Inertia::box(...) - Inertia::cylinder(...)");
}

TEST(UrdfErrors, OfOptionsAreBadUsage) {
  const std::string one = "<robot name=\"r\"><link name=\"a\"/></robot>";
  UrdfOptions wide;
  wide.angle_tolerance = Number(1);
  EXPECT_THROW(read_urdf_text(one, "r.urdf", wide), UsageError);
  UrdfOptions unknown;
  unknown.initial = {{"elbow", "1"}};
  EXPECT_THROW(read_urdf_text(one, "r.urdf", unknown), UsageError);
  EXPECT_THROW(read_urdf("no_such_file.urdf"), FileError);
}

}  // namespace
}  // namespace torsor::urdf_errors_test
