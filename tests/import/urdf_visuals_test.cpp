// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/urdf_visuals.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/import/urdf.hpp"

namespace torsor::urdf_visuals_test {
namespace {

std::string robot(const std::string& visuals) {
  return R"(<robot name="r"><material name="red"><color rgba="1 0 0 1"/></material>
    <link name="base"/>
    <link name="arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)" +
         visuals + R"(</link>
    <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/></joint></robot>)";
}

std::vector<Shown> shown(const std::string& visuals, const UrdfOptions& options = {}) {
  return read_urdf_text(robot(visuals), "r.urdf", options).scene.content().shown;
}

double metres(const Expression& length) { return std::stod(length.to_string()); }

TEST(UrdfVisuals, AreShownOnTheirLinks) {
  const auto all = shown(R"(
    <visual><origin xyz="1 2 3" rpy="0 0 1.5707963267948966"/><geometry><box size="1 2 3"/></geometry><material name="red"/></visual>
    <visual><geometry><cylinder radius="0.5" length="4"/></geometry>
      <material name="own"><color rgba="0 0.5 2 1"/></material></visual>
    <visual><geometry><sphere radius="2"/></geometry><material name="own"/></visual>
    <visual><geometry><mesh filename="package://p/a.stl" scale="1 2 3"/></geometry></visual>)");
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(metres(std::get<form::Box>(all[0].form).edges[2]), 3.0);
  EXPECT_EQ(metres(all[0].placement.origin[1]), 2.0);
  // x of the box along y of the link, exactly: a box may touch.
  EXPECT_EQ(all[0].placement.rotation(1, 0).to_double(), 1.0);
  EXPECT_TRUE(all[0].placement.rotation(0, 0).is_zero());
  EXPECT_EQ(all[0].colour->red, 1.0);
  EXPECT_EQ(metres(std::get<form::Cylinder>(all[1].form).length), 4.0);
  EXPECT_EQ(all[1].colour->green, 0.5);
  EXPECT_EQ(all[1].colour->blue, 1.0);  // no more than all light
  EXPECT_EQ(all[2].colour->green, 0.5);
  EXPECT_EQ(std::get<form::Mesh>(all[3].form).file, "package://p/a.stl");
  EXPECT_EQ(std::get<form::Mesh>(all[3].form).scale[1], 2.0);
  EXPECT_FALSE(all[3].colour);
}

// 1.5708 is 3.7e-6 beyond π/2.
TEST(UrdfVisuals, AreTurnedByExactAnglesWithinTheTolerance) {
  const std::string box = R"(<visual><origin rpy="0 0 1.5708"/><geometry><box size="1 2 3"/></geometry></visual>)";
  UrdfOptions coarse;
  coarse.angle_tolerance = Number::rational(1, 100000);
  EXPECT_FALSE(shown(box).at(0).placement.rotation(0, 0).is_zero());
  EXPECT_TRUE(shown(box, coarse).at(0).placement.rotation(0, 0).is_zero());
}

TEST(UrdfVisuals, AreTurnedByQuaternions) {
  const auto all = shown(R"(
    <visual><origin quat_xyzw="0 0 0.70710678118654752 0.70710678118654752"/>
      <geometry><box size="1 2 3"/></geometry></visual>
    <visual><origin quat_xyzw="1 2 2 4"/><geometry><sphere radius="2"/></geometry></visual>)");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].placement.rotation(1, 0).to_double(), 1.0);
  EXPECT_TRUE(all[0].placement.rotation(0, 0).is_zero());
  EXPECT_EQ(all[1].placement.rotation(0, 0), Number::rational(9, 25));  // (16 + 1 - 4 - 4)/25
}

TEST(UrdfVisuals, MeshesHaveTheScaleOfTheFile) {
  const auto all = shown(R"(<visual><geometry><mesh filename="a.stl" scale="0.001 0.001 0.001"/></geometry></visual>)");
  EXPECT_EQ(std::get<form::Mesh>(all.at(0).form).scale[2], 0.001);
}

// The sphere of `marker` has no place in a robot that is not joined to it; the world is left out where its child floats.
TEST(UrdfVisuals, OfLinksThatAreLeftOutAreShownNowhere) {
  const std::string picture = "<visual><geometry><sphere radius=\"1\"/></geometry></visual>";
  const std::string mass =
      R"(<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)";
  const std::string lonely = "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\">" + mass + picture +
                             "</link><link name=\"marker\">" + picture +
                             R"(</link><joint name="turn" type="continuous"><parent link="base"/><child link="arm"/></joint>)" +
                             "</robot>";
  EXPECT_EQ(read_urdf_text(lonely, "r.urdf").scene.content().shown.size(), 1U);
  const std::string world = "<robot name=\"r\"><link name=\"world\">" + picture + "</link><link name=\"arm\">" + mass + picture +
                            R"(</link><joint name="hold" type="fixed"><parent link="world"/><child link="arm"/></joint></robot>)";
  UrdfOptions floating;
  floating.base = UrdfBase::floating;
  EXPECT_EQ(read_urdf_text(world, "r.urdf", floating).scene.content().shown.size(), 1U);
}

// A picture decides nothing: what is wrong in it makes no robot unreadable.
TEST(UrdfVisuals, AreLeftOutWhereTheyCannotBeRead) {
  for (const char* visual :
       {"<visual/>", "<visual><geometry/></visual>", "<visual><geometry><box/></geometry></visual>",
        "<visual><geometry><box size=\"1 2\"/></geometry></visual>", "<visual><geometry><box size=\"1 2 x\"/></geometry></visual>",
        "<visual><geometry><sphere radius=\"-1\"/></geometry></visual>", "<visual><geometry><sphere radius=\"nan\"/></geometry></visual>",
        "<visual><geometry><cylinder radius=\"1\" length=\"1e300\"/></geometry></visual>",
        "<visual><origin rpy=\"a b c\"/><geometry><sphere radius=\"1\"/></geometry></visual>",
        "<visual><origin quat_xyzw=\"0 0 0 0\"/><geometry><sphere radius=\"1\"/></geometry></visual>",
        "<visual><origin quat_xyzw=\"0 0 1\"/><geometry><sphere radius=\"1\"/></geometry></visual>",
        "<visual><origin rpy=\"0 0 0\" quat_xyzw=\"0 0 0 1\"/><geometry><sphere radius=\"1\"/></geometry></visual>",
        "<visual><geometry><mesh filename=\"a.stl\" scale=\"0.001\"/></geometry></visual>",
        "<visual><geometry><mesh filename=\"a.stl\" scale=\"1 1 1 1\"/></geometry></visual>",
        "<visual><geometry><mesh filename=\"a.stl\" scale=\"mm\"/></geometry></visual>",
        "<visual><geometry><mesh/></geometry></visual>", "<visual><geometry><capsule/></geometry></visual>"}) {
    EXPECT_TRUE(shown(visual).empty()) << visual;
  }
}

}  // namespace
}  // namespace torsor::urdf_visuals_test
