// SPDX-License-Identifier: GPL-3.0-or-later
// What an MJCF file says and a scene does not: each is told by name.
#include <gtest/gtest.h>

#ifdef TORSOR_WITH_MUJOCO

#include <fstream>

#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/mujoco_reader.hpp"

namespace torsor::mjcf_notes_test {
namespace {

std::string written(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name + ".xml";
  std::ofstream(path) << "<mujoco>" << text << "</mujoco>";
  return path;
}

// What bounds a force or a control acts in MuJoCo, and is told with how the force comes about.
TEST(Mjcf, TellsTheBoundsOfActuators) {
  const std::string one = "<worldbody><body><joint name='j'/><geom size='1'/></body></worldbody><actuator>"
                          "<motor name='u' joint='j' "
                          "ctrllimited='true' ctrlrange='-1 2' forcelimited='true' forcerange='-3 4'/></actuator>";
  EXPECT_EQ(read_with_mujoco(written("bounded", one)).actuators.at(0).law,
            "the force lies between -3 and 4; the control lies between -1 and 2");
  EXPECT_EQ(read_with_mujoco(written("unclamped", "<option><flag clampctrl='disable'/></option>" + one)).actuators.at(0).law,
            "the force lies between -3 and 4");
}

// A pair of geoms touches whatever their contype says.
TEST(Mjcf, CountsTheGeomsOfPairsAmongThoseThatTouch) {
  const MjcfModel model = read_with_mujoco(written("pair", R"(<worldbody>
    <geom name="floor" type="plane" size="1 1 1" contype="0" conaffinity="0"/>
    <body><freejoint/><geom name="ball" size="1" contype="0" conaffinity="0"/></body></worldbody>
    <contact><pair geom1="floor" geom2="ball"/></contact>)"));
  EXPECT_EQ(model.geoms.size(), 2U);
  EXPECT_EQ(mjcf_scene(model).notes,
            std::vector<std::string>{"contacts do not act: the geometry of 2 geoms is kept and has no effect"});
}

// The medium acts on all bodies, and frictionloss on what turns freely: each is named where it does not.
TEST(Mjcf, NotesTheMediumAndTheFrictionOfFreeJoints) {
  const MjcfModel model = read_with_mujoco(written("medium", R"(<option density="1000" wind="1 0 0"/><worldbody>
    <body><joint name="socket" type="ball" frictionloss="0.25"/><geom size="1" contype="0" conaffinity="0"/></body>
    </worldbody>)"));
  EXPECT_EQ(mjcf_scene(model).notes,
            (std::vector<std::string>{"the medium (density, viscosity, wind) does not act",
                                      "frictionloss of ball and free joints does not act: socket (0.25)"}));
}

}  // namespace
}  // namespace torsor::mjcf_notes_test

#endif
