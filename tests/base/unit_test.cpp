// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/unit.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/base/error_of.hpp"

namespace torsor::unit_test {
namespace {

std::string error_of(const auto& action) { return testing_errors::error_of<UnitError>(action); }

TEST(Unit, ReadsProductsQuotientsAndPowers) {
  const Unit torque(1, 2, -2);
  for (const char* text :
       {"kg m^2/s^2", "N*m", "N m", "N·m", "J", "kg*m^2*s^-2", "kg m m/s/s", "W s", "Pa m^3", "kg (m/s)^2", "N·m·rad",
        " N  m ", "kg·m^2 / s^2", "V A s", "m^(4/2) kg/s^(2)", "Wb A", "C V", "(N m)"}) {
    EXPECT_EQ(Unit::parse(text), torque) << text;
  }
  EXPECT_EQ(Unit::parse("N/m"), Unit(1, 0, -2));
  EXPECT_EQ(Unit::parse("N s/m"), Unit(1, 0, -1));
  EXPECT_EQ(Unit::parse("rad/s"), Unit::parse("Hz"));
  EXPECT_EQ(Unit::parse("1/s"), units::radian_per_second);
  EXPECT_EQ(Unit::parse("1"), Unit());
  EXPECT_EQ(Unit::parse("rad"), Unit());
  EXPECT_EQ(Unit::parse("J/(kg K)"), Unit(0, 2, -2) / Unit::base(4));
  EXPECT_EQ(Unit::parse("V/A"), Unit::parse("ohm"));
  EXPECT_EQ(Unit::parse("H/s"), Unit::parse("ohm"));
  EXPECT_EQ(Unit::parse("ohm F"), units::second);
  EXPECT_EQ(Unit::parse("T m^2"), Unit::parse("Wb"));
  EXPECT_EQ(Unit::parse("cd/mol"), Unit::base(6) / Unit::base(5));
}

TEST(Unit, MultipliesDividesAndTakesPowers) {
  EXPECT_EQ(units::newton * units::metre, units::joule);
  EXPECT_EQ(units::joule / units::second, units::watt);
  EXPECT_EQ(units::metre.pow(3) / units::metre.pow(2), units::metre);
  EXPECT_EQ(units::metre.pow(0), units::one);
  EXPECT_TRUE((units::newton / units::newton).is_dimensionless());
  EXPECT_EQ((units::metre / units::second).pow(-2), Unit(0, -2, 2));
  static_assert(units::joule == units::newton_metre);
  static_assert(units::newton != units::joule);
  static_assert(units::watt.half_exponent(2) == -6);
}

TEST(Unit, TakesRootsDownToHalves) {
  EXPECT_EQ((units::joule / units::kilogram).root(), units::metre_per_second);
  EXPECT_EQ(units::kilogram.root() * units::kilogram.root(), units::kilogram);
  EXPECT_EQ(units::kilogram.root().half_exponent(0), 1);
  EXPECT_EQ(Unit::parse("kg^(1/2)"), units::kilogram.root());
  EXPECT_EQ(Unit::parse("m^(-3/2)"), units::metre.pow(-3).root());
  EXPECT_EQ(
      error_of([] { static_cast<void>(units::kilogram.root().root()); }),
      "the unit kg^(1/2) has no square root here: the exponent of kg would be a quarter; take roots of even powers");
}

TEST(Unit, IsPrintedInBaseUnitsAndReadBack) {
  EXPECT_EQ(units::joule.to_string(), "kg m^2 s^-2");
  EXPECT_EQ(Unit().to_string(), "1");
  EXPECT_EQ(units::kilogram.root().to_string(), "kg^(1/2)");
  EXPECT_EQ((units::one / units::metre.root()).to_string(), "m^(-1/2)");
  EXPECT_EQ(Unit::parse("ohm").to_string(), "kg m^2 s^-3 A^-2");
  std::mt19937 engine(3);
  std::uniform_int_distribution<int> exponent(-4, 4);
  for (int round = 0; round < 500; ++round) {
    const auto draw = [&] { return exponent(engine); };
    const int mass = draw(), length = draw(), time = draw(), current = draw(), heat = draw(), amount = draw();
    const Unit square = Unit(mass * 2, length, time, current) * Unit::base(4).pow(heat) * Unit::base(5).pow(amount);
    const Unit unit = square * units::kilogram.root() * units::second.root().pow(mass);
    EXPECT_EQ(Unit::parse(unit.to_string()), unit) << unit.to_string();
  }
}

TEST(Unit, IsSpacedAsInPrint) {
  EXPECT_EQ(spaced_unit("N*m/rad"), "N m/rad");
  EXPECT_EQ(spaced_unit("N·m·s"), "N m s");
  EXPECT_EQ(spaced_unit(" N  m "), "N m");
  EXPECT_EQ(spaced_unit("kg·m^2 / s^2"), "kg m^2/s^2");
  EXPECT_EQ(spaced_unit("J / ( kg * K )"), "J/(kg K)");
  EXPECT_EQ(spaced_unit("kg (m/s)^2"), "kg (m/s)^2");
  EXPECT_EQ(spaced_unit("m^(-1/2)"), "m^(-1/2)");
  EXPECT_EQ(spaced_unit("1"), "1");
}

TEST(Unit, TellsTheRemedyForAScaledUnit) {
  EXPECT_EQ(error_of([] { Unit::parse("N mm"); }),
            "cannot read the unit \"N mm\": \"mm\" is a scaled unit; use the SI unit m (multiply the value by 1/1000)");
  EXPECT_EQ(
      error_of([] { Unit::parse("deg"); }),
      "cannot read the unit \"deg\": \"deg\" is a scaled unit; use the SI unit rad (multiply the value by pi/180)");
  EXPECT_EQ(error_of([] { Unit::parse("g"); }),
            "cannot read the unit \"g\": \"g\" is a scaled unit; use the SI unit kg (multiply the value by 1/1000)");
  EXPECT_NE(error_of([] { Unit::parse("°"); }).find("use the SI unit rad"), std::string::npos);
}

TEST(Unit, ListsTheKnownNamesForAnUnknownOne) {
  EXPECT_EQ(error_of([] { Unit::parse("kg furlong"); }),
            "cannot read the unit \"kg furlong\": \"furlong\" is unknown; the known units are 1 kg m s A K mol cd rad "
            "sr N J W Pa "
            "Hz C V ohm F H Wb T");
}

TEST(Unit, RefusesATextItCannotReadInOneWay) {
  const auto reason = [](const char* text) {
    const std::string prefix = "cannot read the unit \"" + std::string(text) + "\": ";
    const std::string message = error_of([text] { Unit::parse(text); });
    return message.substr(0, prefix.size()) == prefix ? message.substr(prefix.size()) : "other: " + message;
  };
  const std::string ambiguous =
      "a product after a '/' can be read in two ways; write parentheses, as in J/(kg K), or J/kg/K";
  EXPECT_EQ(reason("J/kg K"), ambiguous);
  EXPECT_EQ(reason("m/s*kg"), ambiguous);
  const std::string missing = "a unit's name is missing; the dimensionless unit is written 1";
  for (const char* text : {"", " ", "kg*", "/s", "kg//s", "m^2^2*", "()"}) EXPECT_NE(reason(text), "") << text;
  EXPECT_EQ(reason(""), missing);
  EXPECT_EQ(reason("kg*"), missing);
  EXPECT_EQ(reason("/s"), missing);
  EXPECT_EQ(reason("()"), missing);
  EXPECT_EQ(reason("(kg m"), "a closing parenthesis is missing");
  EXPECT_EQ(reason("kg)"), "\")\" is not expected there");
  const std::string exponent = "an exponent is an integer or a half, as in m^2, m^-1 or m^(1/2)";
  EXPECT_EQ(reason("m^(1/3)"), exponent);
  EXPECT_NE(reason("m^x").find("an exponent is an integer between -63 and 63"), std::string::npos);
  EXPECT_NE(reason("m^99").find("an exponent is an integer between -63 and 63"), std::string::npos);
  EXPECT_NE(reason("m^1.5").find("other: "), 0u);
}

// Each level takes a part of the stack.
TEST(Unit, RefusesParenthesesThatAreNestedTooDeeply) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "kg(";
  const std::string message = error_of([&deep] { Unit::parse(deep); });
  EXPECT_NE(message.find("parentheses are nested more than 20 deep"), std::string::npos) << message.substr(0, 500);
  EXPECT_LT(message.size(), 400U);
  EXPECT_EQ(Unit::parse("((((((((m))))))))"), units::metre);
  EXPECT_EQ(Unit::parse("(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)(m)"), units::metre.pow(22));
}

TEST(Unit, RefusesExponentsBeyondItsRange) {
  EXPECT_EQ(
      error_of([] { static_cast<void>(units::metre.pow(63) * units::metre); }),
      "the product of units leads to an exponent of 64, beyond the limit of 63: check the powers of the expression");
  EXPECT_NE(error_of([] { static_cast<void>(units::metre.pow(2000000000)); }), "no error");
  EXPECT_NE(error_of([] { static_cast<void>(units::metre.pow(-63) / units::metre); }), "no error");
  EXPECT_NE(error_of([] { static_cast<void>(Unit(64)); }), "no error");
  EXPECT_EQ(units::one.pow(2000000000), units::one);
}

}  // namespace
}  // namespace torsor::unit_test
