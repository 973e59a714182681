// SPDX-License-Identifier: GPL-3.0-or-later
// A misspelt word of any kind is answered with the word that is likely meant.
#include "tests/cli/scene_runner.hpp"

namespace torsor::did_you_mean_command_test {
namespace {

using namespace testing_programs;

/// A pendulum beside names that are easily misspelt.
Scene named() {
  Scene scene = pendulum();
  const PointHandle tip = scene.point("fingertip", "arm", {0, -Expression::quantity("1.5", "m"), 0});
  scene.spring("rubber", {.a = tip,
                          .b = scene.point("anchor", scene.ground(), {Expression::quantity("1", "m"), 0, 0}),
                          .stiffness = Expression::quantity("3", "N/m")});
  return scene;
}

void expect_suggestion(const std::vector<std::string>& arguments, int code, const std::string& word) {
  const Outcome outcome = run(named, arguments);
  EXPECT_EQ(outcome.code, code);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("did you mean '" + word + "'?"), std::string::npos) << outcome.err;
}

TEST(DidYouMeanCommand, AnswersEveryMisspeltWord) {
  expect_suggestion({"equation"}, 2, "equations");
  expect_suggestion({"genrate", "-o", "-"}, 2, "generate");
  expect_suggestion({"counts", "--kernels", "forward_dynamic"}, 2, "forward_dynamics");
  expect_suggestion({"counts", "--kernel", "bias"}, 2, "--kernels");
  expect_suggestion({"counts", "--run-time", "lenght"}, 2, "length");
  expect_suggestion({"counts", "--forward", "factorization"}, 2, "factorisation");
  expect_suggestion({"counts", "--without", "hosting"}, 2, "hoisting");
  expect_suggestion({"equations", "--format", "latx"}, 2, "latex");
  expect_suggestion({"equations", "--about", "tetha=0"}, 2, "theta");
  expect_suggestion({"statics", "--about", "tetha=0"}, 2, "theta");
  expect_suggestion({"statics", "--about", "theta=sine(1)"}, 2, "sin");
  expect_suggestion({"theorem", "--kind", "momment"}, 2, "moment");
  expect_suggestion({"theorem", "--bodies", "bobb"}, 3, "bob");
  expect_suggestion({"theorem", "--kind", "moment", "--at", "fingertpi"}, 3, "fingertip");
  expect_suggestion({"theorem", "--axes", "grond"}, 3, "ground");
  expect_suggestion({"force-function", "--actions", "ruber"}, 3, "rubber");
  expect_suggestion({"graph", "--of", "structur"}, 2, "structure");
  expect_suggestion({"structure", "--inputs-outputs", "amr"}, 2, "arm");
}

TEST(DidYouMeanCommand, SaysWhereOptionsStand) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--json", "list"}, {"--inputs-outputs", "arm", "structure"}}) {
    const Outcome outcome = run(named, words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("; options of a command stand behind its name; see --help"), std::string::npos)
        << outcome.err;
  }
}

TEST(DidYouMeanCommand, AnswersNamesInScenes) {
  const auto with = [](Scene (*make)(), const std::string& word) {
    const Outcome outcome = run(make, {"list"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("did you mean '" + word + "'?"), std::string::npos) << outcome.err;
  };
  with(
      [] {
        Scene scene = named();
        scene.torque("twist", "arn", {0, 0, Expression::quantity("1", "N m")}, "ground");
        return scene;
      },
      "arm");
  with(
      [] {
        Scene scene = named();
        scene.force("push", {.body = "arm",
                             .point = scene.point("finger_tip"),
                             .components = {Expression::quantity("1", "N"), 0, 0},
                             .axes = "ground"});
        return scene;
      },
      "fingertip");
  with(
      [] {
        Scene scene = named();
        scene.parameter("speed", "Rad/s", 1);
        return scene;
      },
      "rad");
}

// Where an option is missing, a misspelt one is told first.
TEST(DidYouMeanCommand, TellsAMisspeltOptionBeforeOneThatIsMissing) {
  const Outcome outcome = run(named, {"generate", "--kernals", "bias"});
  const std::string told = "unknown option '--kernals'; did you mean '--kernels'?; see --help";
  EXPECT_NE(outcome.err.find(told), std::string::npos) << outcome.err;
  EXPECT_NE(run(named, {"generate", "--kernels", "bias"}).err.find("--output is required"), std::string::npos);
}

TEST(DidYouMeanCommand, SuggestsNothingWhereNothingIsNear) {
  const Outcome outcome = run(named, {"counts", "--run-time", "stiffness"});
  EXPECT_EQ(outcome.err.find("did you mean"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace torsor::did_you_mean_command_test
