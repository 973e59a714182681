// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/random_mechanism.hpp"

namespace torsor::testing_mechanisms {

/// A random mechanism without actions and constraints, at a random state, in 50 digits.
class RandomModel : public ::testing::TestWithParam<unsigned> {
 protected:
  explicit RandomModel(std::uint64_t seed_of_state)
      : scene(random_mechanism(GetParam(), {.actions = false, .constraints = false})),
        equations(scene),
        state(scene, seed_of_state),
        evaluate(equations.program(), state.in_real()) {}

  int links() const { return static_cast<int>(model.links().size()); }
  /// |v| at the random state, where everything is of order one to a thousand: 50 digits leave 1e-44.
  double size(const Vector& v) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += abs(evaluate(v[i])).to_double();
    return sum;
  }

  const WorkingDigits precision{50};
  Scene scene;
  Equations equations;
  const Model& model = equations.model();
  Program& program = equations.program();
  RandomState state;
  Evaluator<Real> evaluate;
};

}  // namespace torsor::testing_mechanisms
