// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "torsor/generator/cli/scene_program.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::testing_programs {

/// What a scene program did.
struct Outcome {
  int code = 0;
  std::string out, err;
};

/// Runs the main function of a program in this process, `main(argc, argv)`, as `name <arguments>`.
template <class Main>
Outcome run_main(const char* name, const std::vector<std::string>& arguments, const Main& main) {
  std::vector<const char*> argv{name};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code = main(static_cast<int>(argv.size()), argv.data());
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

/// Runs a scene program in this process, as `scene <arguments>`.
inline Outcome run(Scene (*make_scene)(), const std::vector<std::string>& arguments) {
  return run_main("scene", arguments,
                  [&](int argc, const char* const* argv) { return run_scene_program(argc, argv, make_scene); });
}

/// One clear line on stderr, nothing on stdout, that exit code.
inline void expect_failure(const Outcome& outcome, int code, const std::string& message) {
  EXPECT_EQ(outcome.code, code);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "scene: " + message + "\n");
}

/// The same where only the beginning of the message is worth fixing.
inline void expect_failure_beginning(const Outcome& outcome, int code, const std::string& beginning) {
  EXPECT_EQ(outcome.code, code);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("scene: " + beginning)) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

inline Scene pendulum() { return testing_mechanisms::pendulum_with_motor(); }

}  // namespace torsor::testing_programs
