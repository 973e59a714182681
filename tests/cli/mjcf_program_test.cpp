// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "tests/cli/tool_runner.hpp"
#ifdef TORSOR_WITH_MUJOCO
#include <mujoco/mujoco.h>

#include "torsor/generator/import/mujoco_reader.hpp"
#endif

namespace torsor::mjcf_program_test {
namespace {

using testing_programs::Outcome;
using testing_programs::torsor_tool;

const std::string crane = TORSOR_SOURCE_DIR "/tests/import/data/mjcf/crane.xml";

TEST(TorsorToolWithMjcf, SaysWhatToInstallWhereMujocoIsNot) {
  const Outcome outcome = torsor_tool({"list", crane}, nullptr);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "torsor: " + crane +
                             ": is MJCF, which this program was built without; install libmujoco-dev and "
                             "build torsor again\n");
}

#ifdef TORSOR_WITH_MUJOCO

TEST(TorsorToolWithMjcf, GeneratesAHeaderThatTellsWhatDoesNotAct) {
  const Outcome outcome = torsor_tool(
      {"generate", crane, "--kernels", "inverse_dynamics", "--gravity", "0,0,-1.62", "-o", "-"}, read_with_mujoco);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "note: contacts do not act: the geometry of 5 geoms is kept and has no effect\n");
  EXPECT_NE(outcome.out.find("torsor generate crane.xml --gravity 0,0,-1.62 --kernels inverse_dynamics"),
            std::string::npos);
  EXPECT_NE(outcome.out.find("is Ry(pi/6): body boom"), std::string::npos);
  EXPECT_NE(outcome.out.find("//   contacts do not act"), std::string::npos);
  EXPECT_EQ(torsor_tool({"generate", crane, "--kernels", "inverse_dynamics", "--gravity", "0,0,-1.62", "-o", "-"},
                        read_with_mujoco)
                .out,
            outcome.out);
}

// The command in the header is one that a shell runs, and that gives the header again, whatever the file is called.
TEST(TorsorToolWithMjcf, RepeatsEveryOptionInTheCommandInTheHeader) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "-it's a\ncrane.xml";
  std::filesystem::copy_file(crane, file, std::filesystem::copy_options::overwrite_existing);
  const auto command = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"generate", file.string(), "--quiet", "--kernels", "mass_matrix", "-o", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::string header = torsor_tool(arguments, read_with_mujoco).out;
    const std::size_t begin = header.find("//   torsor generate ");
    const std::size_t end = header.find(" --kernels ", begin);
    return begin == std::string::npos ? "no command" : header.substr(begin + 5, end - begin - 5);
  };
  const std::string start = R"(torsor generate $'./-it\'s a\012crane.xml')";
  EXPECT_EQ(command({}), start);
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--gravity", "0.1,1/3,-9.81"}, {"--angle-tolerance", "1e-05"},
                                             {"--no-motors"}, {"--no-dampers"}, {"--name", "lift"}}) {
    const std::string text = options.size() == 1 ? options[0] : options[0] + " " + options[1];
    EXPECT_EQ(command(options), start + " " + text);
  }
  std::filesystem::remove(file);
}

TEST(TorsorToolWithMjcf, TellsWhatIsWrong) {
  EXPECT_EQ(torsor_tool({"list", crane, "--base", "floating"}, read_with_mujoco).err,
            "torsor: --base floating is for URDF; write <freejoint/> in the first body of '" + crane + "'\n");
  EXPECT_EQ(torsor_tool({"list", crane, "--points", "bom"}, read_with_mujoco).code, 2);
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("bad_" + std::to_string(getpid()) + ".xml");
  std::ofstream(file) << "<mujoco>\n<worldbody>\n<body><jiont/></body></worldbody></mujoco>";
  EXPECT_EQ(torsor_tool({"list", file.string()}, read_with_mujoco).err,
            "torsor: " + file.string() +
                ":3: MuJoCo: XML Error: Schema violation: unrecognized element Element 'jiont', line 3; correct the name, "
                "or if the file is for a later MuJoCo than " +
                mj_versionString() + ", write it in the terms of " + mj_versionString() +
                " or build torsor with the later one\n");
  std::ofstream(file) << "<mujoco model=\"stone\"><worldbody><body name=\"b\"/></worldbody></mujoco>";
  EXPECT_EQ(torsor_tool({"list", file.string()}, read_with_mujoco).err,
            "torsor: " + file.string() +
                ": no joint of the model 'stone' moves, so there is nothing to derive; give a body a <joint> or a "
                "<freejoint/>\n");
  std::filesystem::remove(file);
}

TEST(TorsorToolWithMjcf, NamesFilesThatItDependsOn) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("mjcf_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.xml") << "<mujoco><include file=\"b.xml\"/></mujoco>";
  std::ofstream(folder / "b.xml")
      << "<mujocoinclude><worldbody><body name=\"rod\"><joint name=\"turn\"/>"
         "<geom size=\"0.1\" contype=\"0\" conaffinity=\"0\"/></body></worldbody></mujocoinclude>";
  const std::string a = (folder / "a.xml").string(), rule = (folder / "a.stamp.d").string();
  const Outcome outcome = torsor_tool({"list", a, "--depfile", rule}, read_with_mujoco);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("turn"), std::string::npos);
  std::ifstream file(rule);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_EQ(text, (folder / "a.stamp").string() + ": \\\n  " + a + " \\\n  " + (folder / "b.xml").string() + "\n");
  std::filesystem::remove_all(folder);
}

#endif

}  // namespace
}  // namespace torsor::mjcf_program_test
