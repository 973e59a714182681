// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/printing/formula_text.hpp"

#include <gtest/gtest.h>

#include "generator/base/error.hpp"
#include "tests/printing/scenes.hpp"

namespace torsor::formula_text_test {
namespace {

TEST(FormulaText, ReadsPrecedenceFunctionsAndPrimes) {
  const Scene scene = test::absorber();
  EXPECT_EQ(parse_formula("X0 + 2*d^2/R", scene).to_string(), "(X0 + 2*d^(2)*R^(-1))");
  EXPECT_EQ(parse_formula("-(1.5e-1)", scene).to_string(), "-3/20");
  EXPECT_EQ(parse_formula("sin(pi/2)", scene).to_string(), "sin(pi*2^(-1))");
  EXPECT_EQ(parse_formula("theta'", scene).as_symbol()->kind, SymbolKind::velocity);
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

}  // namespace
}  // namespace torsor::formula_text_test
