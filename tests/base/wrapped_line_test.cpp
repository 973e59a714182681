// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/wrapped_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace torsor::wrapped_line_test {
namespace {

TEST(WrappedLine, IsBrokenBehindCommasOutsideOfTexts) {
  const std::string name(100, 'n');
  EXPECT_EQ(wrapped("f(" + name + ", second, third, fourth);", 0), "f(" + name + ", second, third,\n    fourth);");
  EXPECT_EQ(wrapped("{" + name + ", \"N m, N, N m, kg m^2\", 3}", 0), "{" + name + ",\n    \"N m, N, N m, kg m^2\", 3}");
  EXPECT_EQ(wrapped("{\"" + name + "\", \"say \\\"N, m\\\", once, and more\", 3}", 0),
            "{\"" + name + "\",\n    \"say \\\"N, m\\\", once, and more\", 3}");
}

}  // namespace
}  // namespace torsor::wrapped_line_test
