// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/scene_runner.hpp"

namespace torsor::force_function_command_test {
namespace {

using namespace testing_programs;

TEST(ForceFunctionCommand, SaysWhichOfTheThreeCasesItIsAndWhy) {
  const Outcome weight = run(pendulum, {"force-function", "--actions", "gravity"});
  EXPECT_EQ(weight.code, 0);
  EXPECT_EQ(weight.out,
            "pendulum: gravity, wherever they act\n"
            "  Q_theta = -9.81 mass length sin(theta)\n"
            "  power = -9.81 mass length sin(theta) theta'\n"
            "  potential energy\n"
            "  U = 9.81 mass length cos(theta)\n"
            "    U of the springs, attractions, given functions and weight\n");
  const Outcome all = run(pendulum, {"force-function"});
  EXPECT_EQ(all.code, 0);
  EXPECT_EQ(all.out,
            "pendulum: all actions, wherever they act\n"
            "  Q_theta = -9.81 mass length sin(theta) + torque\n"
            "  power = -9.81 mass length sin(theta) theta' + theta' torque\n"
            "  no force function\n"
            "    Q_theta depends on the input torque\n");
}

TEST(ForceFunctionCommand, RefusesUnknownNames) {
  expect_failure(run(pendulum, {"force-function", "--bodies", "bib"}), 3,
                 "unknown body 'bib' in a selection of actions: did you mean 'bob'? the scene has bob");
}

}  // namespace
}  // namespace torsor::force_function_command_test
