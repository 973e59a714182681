// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/formula_text.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "tests/scenes/bodies.hpp"
#include "tests/scenes/with_parameters.hpp"

namespace torsor::formula_text_test {
namespace {

TEST(FormulaText, ReadsPrecedenceFunctionsAndPrimes) {
  const Scene scene = test::absorber();
  EXPECT_EQ(parse_formula("X0 + 2*d^2/R", scene).to_string(), "(X0 + 2*d^2/R)");
  EXPECT_EQ(parse_formula("-(1.5e-1)", scene).to_string(), "-3/20");
  EXPECT_EQ(parse_formula("sin(pi/2)", scene).to_string(), "sin(pi/2)");
  EXPECT_EQ(parse_formula("theta'", scene).as_symbol()->kind, SymbolKind::velocity);
}

// An attitude has no coordinate of the name of its angular velocity.
TEST(FormulaText, ReadsTheStateOfAnAttitude) {
  const Scene scene = testing_mechanisms::torque_free_body();
  EXPECT_EQ(parse_formula("e_omega_z", scene).as_symbol()->kind, SymbolKind::velocity);
  EXPECT_EQ(parse_formula("e_omega_z'", scene).as_symbol()->kind, SymbolKind::acceleration);
  EXPECT_EQ(parse_formula("e_x", scene).as_symbol(), scene.content().attitudes[0].symbols->e[1]);
}

TEST(FormulaText, SaysWhereItStopsUnderstanding) {
  const Scene scene = test::absorber();
  for (const char* text : {"", "2 +", "Y0", "(1", "1 2", "sinh(theta)", "d^x"}) {
    EXPECT_THROW(parse_formula(text, scene), UsageError) << text;
  }
  EXPECT_THROW(parse_formula("d + K", scene), UnitError);
  try {
    parse_formula("X0 + Y0", scene);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(),
                 "cannot read the formula 'X0 + Y0' at 'Y0': the scene 'vibration_absorber' has no parameter or "
                 "coordinate of that name");
  }
}

// Each level takes a part of the stack, and so does each term of a sum that is as long as a command line may be.
TEST(FormulaText, RefusesWhatHasNoEnd) {
  const Scene scene = test::absorber();
  const auto repeated = [](const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  const auto refusal = [&scene](const std::string& text) -> std::string {
    try {
      parse_formula(text, scene);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  for (const char* level : {"(", "-", "sin(", "(-", "min(d, "}) {
    EXPECT_NE(refusal(repeated(level, 500)).find("nested at most 100 deep"), std::string::npos) << level;
    EXPECT_NE(refusal(repeated(level, 60000)).find("4000 are the most"), std::string::npos) << level;
  }
  EXPECT_LT(refusal(repeated("d + ", 60000)).size(), 200U);
  EXPECT_EQ(refusal(repeated("d + ", 900) + "d"), "");
  EXPECT_EQ(refusal(repeated("(", 90) + "d" + repeated(")", 90)), "");
}

}  // namespace
}  // namespace torsor::formula_text_test
