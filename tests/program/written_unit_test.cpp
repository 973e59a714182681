// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/written_unit.hpp"

#include <gtest/gtest.h>

#include <string>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::written_unit_test {
namespace {

TEST(WrittenUnit, IsWhatAPersonWrites) {
  const auto written = [](const char* unit) { return written_unit(Unit::parse(unit)); };
  EXPECT_EQ(written("kg m^2 s^-2"), "N m");
  EXPECT_EQ(written("kg m s^-2"), "N");
  EXPECT_EQ(written("s^-1"), "rad/s");
  EXPECT_EQ(written("kg s^-2"), "N/m");
  EXPECT_EQ(written("kg s^-1"), "N s/m");
  EXPECT_EQ(written("kg m^2 s^-1"), "N m s");
  EXPECT_EQ(written("m s^-2"), "m/s^2");
  EXPECT_EQ(written("kg m^-3"), "kg/m^3");
  EXPECT_EQ(written("m^-1"), "1/m");
  EXPECT_EQ(written("m^(1/2) s^(-1/2)"), "m^(1/2)/s^(1/2)");
  EXPECT_EQ(written("1"), "1");
}

TEST(WrittenUnit, IsReadBack) {
  for (int mass = -2; mass <= 2; ++mass) {
    for (int length = -3; length <= 3; ++length) {
      for (int time = -4; time <= 4; ++time) {
        for (int current = -1; current <= 1; ++current) {
          const Unit unit(mass, length, time, current);
          EXPECT_EQ(Unit::parse(written_unit(unit)), unit) << written_unit(unit);
        }
      }
    }
  }
}

TEST(WrittenUnit, OfACoordinateWithoutADimensionIsAnAngles) {
  EXPECT_EQ(written_unit(Symbol{"q", Unit(), SymbolKind::coordinate, 0, nullptr, {}}), "rad");
  EXPECT_EQ(written_unit(Symbol{"c", Unit(), SymbolKind::parameter, 0, nullptr, {}}), "1");
  const auto attitude = std::make_shared<AttitudeSymbols>();
  EXPECT_EQ(written_unit(Symbol{"e_w", Unit(), SymbolKind::coordinate, 0, nullptr, attitude}), "1");
}

TEST(WrittenUnit, OfASymbolIsWhatItsAuthorWrote) {
  Scene scene("units");
  const auto written = [](const Expression& symbol) { return written_unit(*symbol.as_symbol()); };
  EXPECT_EQ(written(scene.parameter("k", "N*m/rad")), "N m/rad");
  EXPECT_EQ(written(scene.run_time_parameter("phi_0", "rad", 3)), "rad");
  EXPECT_EQ(written(scene.parameter("E", "J")), "J");
  EXPECT_EQ(written(scene.parameter("n", "1")), "1");
  scene.coordinate("theta", "rad");
  scene.coordinate("s", "1");
  const CoordinateContent& angle = scene.content().coordinates[0];
  EXPECT_EQ(written_unit(*angle.q), "rad");
  EXPECT_EQ(written_unit(*angle.v), "rad/s");
  const CoordinateContent& ratio = scene.content().coordinates[1];
  EXPECT_EQ(written_unit(*ratio.q), "1");
  EXPECT_EQ(written_unit(*ratio.v), "1/s");
  EXPECT_EQ(written_unit(*ratio.a), "1/s^2");
}

}  // namespace
}  // namespace torsor::written_unit_test
