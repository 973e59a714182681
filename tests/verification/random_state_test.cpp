// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/random_state.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/program/test_symbols.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::random_state_test {
namespace {

using namespace testing_mechanisms;
using namespace testing_symbols;

TEST(RandomState, IsTheSameForTheSameSeedAndOtherForAnother) {
  const Scene scene = pendulum();
  const SymbolPointer theta = scene.content().coordinates[0].q;
  EXPECT_EQ(RandomState(scene, 3).value(theta), RandomState(scene, 3).value(theta));
  std::set<double> values;
  for (std::uint64_t seed = 0; seed < 20; ++seed) values.insert(RandomState(scene, seed).value(theta));
  EXPECT_EQ(values.size(), 20U);
}

TEST(RandomState, IsTheSameNumberInBothFormats) {
  const Scene scene = pendulum();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomState state(scene, seed);
    for (const SymbolPointer& symbol : {scene.content().coordinates[0].q, scene.content().coordinates[0].v}) {
      const double value = state.in_double()(symbol);
      EXPECT_LE(std::abs(value), 2);
      EXPECT_TRUE((state.in_real()(symbol) - Real::from_double(value)).is_zero());
    }
  }
}

TEST(RandomState, KeepsParametersNearTheirValues) {
  Scene scene = pendulum();
  const Expression length = scene.parameter("length", "m", 4);
  const Expression angle = scene.run_time_parameter("angle", "rad", pi() / 6);
  const Expression area = scene.parameter("area", "m^2", length * length);
  const Expression free = scene.parameter("free", "kg");
  const Expression along = scene.parameter("along", "kg m^2", 3), across = scene.parameter("across", "kg m^2", 7);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomState state(scene, seed);
    const auto in = [&](const Expression& parameter, double scale) {
      const double ratio = state.value(parameter.as_symbol()) / scale;
      return ratio >= 0.5 && ratio <= 1.5;
    };
    EXPECT_TRUE(in(length, 4));
    EXPECT_TRUE(in(angle, 0.5235987755982988));
    const double drawn = state.value(length.as_symbol());
    EXPECT_TRUE(in(area, drawn * drawn));
    EXPECT_TRUE(in(free, 1));
    // Moments keep their proportions: others may be those of no body. Of a factor of few bits thirds are rounded.
    EXPECT_TRUE(in(along, 3));
    EXPECT_NEAR(state.value(across.as_symbol()) / state.value(along.as_symbol()), 7.0 / 3.0, 1e-15);
  }
}

TEST(RandomState, NamesASymbolItDoesNotKnow) {
  const Scene scene = pendulum();  // alive, so that no other symbol can take the place of one of its own
  const RandomState state(scene, 1);
  EXPECT_EQ(error_of([&] { state.value(make_symbol("stranger")); }),
            "no value for the symbol 'stranger' at a random state");
}

}  // namespace
}  // namespace torsor::random_state_test
