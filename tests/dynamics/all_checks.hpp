// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/verification/check.hpp"
#include "tests/program/test_symbols.hpp"

namespace torsor::testing_mechanisms {

/// A scene that nothing is missing of passes each check at two random states, in 40 digits; in double what some hundred
/// operations round.
inline void expect_all_checks(const Scene& scene) {
  EXPECT_EQ(testing_symbols::error_of([&] { validate(scene); }), "no error");
  for (const CheckResult& result : check_scene(scene, {.digits = 40, .states = 2})) {
    const double bound = result.name.starts_with("double.") ? 1e-11 : result.bound;
    EXPECT_LE(result.worst, bound) << scene.name() << ": " << result.name;
  }
}

}  // namespace torsor::testing_mechanisms
