// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in a process whose locale has a decimal comma.
#include "tests/base/decimal_comma.hpp"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "torsor/generator/cli/command_line.hpp"
#include "torsor/generator/verification/verify.hpp"
#include "tests/cli/scene_runner.hpp"
#include "tests/import/xacro_values.hpp"

namespace torsor::decimal_comma_test {
namespace {

using namespace testing_programs;

TEST(DecimalComma, ChangesNoNumberOfACommand) {
  const std::vector<std::string> command = {"simulate", "--to", "0.5", "--step", "0.25", "--tolerance", "1.5e-9"};
  const auto pendulum = testing_mechanisms::pendulum;
  const Outcome expected = run(pendulum, command);
  ASSERT_EQ(expected.code, 0) << expected.err;
  const testing_locale::DecimalComma comma;
  if (!comma.is_set()) GTEST_SKIP() << "localedef makes no de_DE.UTF-8 here";
  const Outcome outcome = run(pendulum, command);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, expected.out);
  EXPECT_EQ(run_command(command, pendulum(), {}).text, expected.out) << "as Scene.run of Python has it";
  EXPECT_EQ(std::strtod("0,5", nullptr), 0.5) << "the locale of the process is what it was";
}

TEST(DecimalComma, ChangesNoNumberOfAFile) {
  const testing_locale::DecimalComma comma;
  if (!comma.is_set()) GTEST_SKIP() << "localedef makes no de_DE.UTF-8 here";
  EXPECT_EQ(testing_xacro::value_of("round(1.2345, 2)"), "1.23");
  EXPECT_EQ(parse_accuracy_exceptions("a | b | c | double | 1.5 | why").at(0).limit, 1.5);
}

}  // namespace
}  // namespace torsor::decimal_comma_test
