// SPDX-License-Identifier: GPL-3.0-or-later
// Mass matrices and their solution next to configurations where large terms cancel, in double.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "tests/scenes/bodies.hpp"
#include "tests/verification/right_to_rounding.hpp"

namespace torsor::cancellation_test {
namespace {

using namespace testing_mechanisms;

/// A top of the moments A across and C along its axis y, by the angles alpha (x), beta (z), gamma (y).
Scene top(const char* across, const char* along, bool run_time) {
  Scene scene("top");
  const auto parameter = [&](const char* name, const char* value) {
    return run_time ? scene.run_time_parameter(name, "kg m^2", moment(value))
                    : scene.parameter(name, "kg m^2", moment(value));
  };
  const Expression a = parameter("A", across), c = parameter("C", along);
  const Expression alpha = scene.coordinate("alpha", "rad"), beta = scene.coordinate("beta", "rad"),
                   gamma = scene.coordinate("gamma", "rad");
  const FrameHandle first = scene.revolute("first", scene.ground(), axis::x, alpha);
  const FrameHandle second = scene.revolute("second", first, axis::z, beta);
  scene.body("top", scene.revolute("top", second, axis::y, gamma),
             Inertia::general({.mass = kilograms("1"), .xx = a, .yy = c, .zz = a}));
  return scene;
}

class Tops : public ::testing::TestWithParam<bool> {};

/// M_αα = A cos²β + C sin²β: a sum of positive terms, each of four roundings at most, with sine and cosine of half an
/// ulp: 4 ulp whatever the ratio of both moments.
TEST_P(Tops, MomentsOfALongTopKeepTheirDigits) {
  testing_rounding::RightToRounding check(testing_rounding::unit_of<double>);
  for (const bool is_long : {true, false}) {
    const char* const across = is_long ? "1024.3" : "0.3";
    const char* const along = is_long ? "0.3" : "1024.3";
    const Equations equations(top(across, along, GetParam()));
    for (const double beta : {1.5707, 1.57079632, 1e-6, 0.4}) {
      const auto number = [&](const SymbolPointer& symbol) {
        if (symbol->name == "A") return std::stod(across);
        if (symbol->name == "C") return std::stod(along);
        return symbol->name == "beta" ? beta : 0.0;
      };
      const double found = Evaluator<double>(equations.program(), number)(equations.mass()[0][0]);
      const long double s = std::sin(static_cast<long double>(beta)), c = std::cos(static_cast<long double>(beta));
      const long double true_moment = std::stod(across) * c * c + std::stod(along) * s * s;
      check.entry(std::string(across) + " at " + std::to_string(beta), found, true_moment, 8);
    }
  }
  EXPECT_TRUE(check) << check;
}

/// Next to β = π/2 the axes of alpha and gamma meet and M is singular. Pivots cos²β alone: with the torque cos β about
/// alpha the acceleration is 1/(A cos β), condition |β tan β|; six roundings.
TEST_P(Tops, AccelerationsNextToALockedAngleKeepTheirDigits) {
  const Equations equations(top("0.3", "0.6", GetParam()));
  const ValueMatrix& mass = equations.mass();
  const Factorisation factorisation(equations.program(), mass);
  const Value torque = equations.program().cos(equations.model().q(1));
  const Value alpha = factorisation.solve({torque, Value(), Value()})[0];
  testing_rounding::RightToRounding check(testing_rounding::unit_of<double>);
  for (const double beta : {1.5, 1.57, 1.5707, 1.570796}) {
    const auto number = [&](const SymbolPointer& symbol) {
      if (symbol->name == "A") return 0.3;
      if (symbol->name == "C") return 0.6;
      return symbol->name == "beta" ? beta : 0.0;
    };
    const double found = Evaluator<double>(equations.program(), number)(alpha);
    const long double expected = 1 / (0.3L * std::cos(static_cast<long double>(beta)));
    check.entry(std::to_string(beta), found, expected, 12);
  }
  EXPECT_TRUE(check) << check;
}
INSTANTIATE_TEST_SUITE_P(Parameters, Tops, ::testing::Bool());

}  // namespace
}  // namespace torsor::cancellation_test
