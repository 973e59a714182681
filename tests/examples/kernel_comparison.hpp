// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Include after a generated header.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/verification/real_scalar_traits.hpp"
#include "tests/verification/right_to_rounding.hpp"

namespace examples {

namespace testing_rounding = torsor::testing_rounding;
using torsor::Real;

template <class Scalar>
Scalar scalar(double value) {
  if constexpr (std::is_same_v<Scalar, Real>) {
    return Real::from_double(value);
  } else {
    return static_cast<Scalar>(value);
  }
}
inline Real exactly(const Real& x) { return x; }
inline Real exactly(double x) { return Real::from_double(x); }

/// Results of one kernel: entries that form a vector of one unit share a key.
using Results = std::map<std::string, std::vector<Real>>;

/// Evaluates every kernel of a mechanism at one state, given in double, on any scalar. `units` has one letter per
/// coordinate, m for metres and r for radians: what they work with differs in unit.
template <template <class> class Mechanism, class Scalar>
class Evaluated {
 public:
  using M = Mechanism<Scalar>;
  static constexpr int n = M::velocity_count;

  Evaluated(std::string_view units, int bodies, unsigned seed) : units_(units), bodies_(bodies) {
    // Drawn in float, so that the state is the same on every scalar.
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.5F, 1.5F);
    const auto draw = [&](auto& members) {
      for (int i = 0; i < members.size; ++i) members[i] = scalar<Scalar>(uniform(random));
    };
    state_.time = scalar<Scalar>(std::abs(uniform(random)));
    draw(state_.q);
    draw(state_.v);
    draw(accelerations_);
    draw(multipliers_);
    draw(inputs_);
    auto parameters = M::default_parameters();
    const auto doubles = Mechanism<float>::default_parameters();
    for (int i = 0; i < M::parameter_count; ++i) parameters[i] = scalar<Scalar>(doubles[i]);
    precomputed_ = M::precompute(parameters);
    evaluate();
  }

  /// What needs no solution of equations, and what does: their errors grow with the condition of the mass matrix.
  Results direct, solved;
  std::vector<Real> mass;  ///< column by column

 private:
  std::string unit(int i) const { return std::string(1, units_[static_cast<std::size_t>(i)]); }
  std::string pair_of_units(int i, int j) const { return std::min(unit(i), unit(j)) + std::max(unit(i), unit(j)); }

  template <class Vector>
  void add_vector(Results& results, const std::string& name, const Vector& values) {
    for (int i = 0; i < n; ++i) results[name + "." + unit(i)].push_back(exactly(values[i]));
  }
  template <class Array>
  void add_matrix(Results& results, const std::string& name, const Array& values) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        results[name + "." + pair_of_units(i, j)].push_back(exactly(values[static_cast<std::size_t>(i + n * j)]));
      }
    }
  }
  template <class Array>
  void add_all(Results& results, const std::string& name, const Array& values) {
    for (const Scalar& value : values) results[name].push_back(exactly(value));
  }

  void evaluate() {
    const auto& p = precomputed_;
    const auto& s = state_;
    if constexpr (requires(typename M::GeneralizedForces f) { M::bias(p, s, f); }) {
      typename M::GeneralizedForces forces{};
      M::bias(p, s, forces);
      add_vector(direct, "bias", forces);
      M::inverse_dynamics(p, s, accelerations_, multipliers_, forces);
      add_vector(direct, "inverse_dynamics", forces);
      std::array<Scalar, static_cast<std::size_t>(n) * n> matrix{};
      M::mass_matrix(p, s, matrix);
      add_matrix(direct, "mass_matrix", matrix);
      for (const Scalar& entry : matrix) mass.push_back(exactly(entry));
      typename M::Accelerations accelerations{};
      typename M::Multipliers multipliers{};
      EXPECT_EQ(M::forward_dynamics(p, s, inputs_, accelerations, multipliers), torsor::Status::ok);
      add_vector(solved, "forward_dynamics", accelerations);
      for (int j = 0; j < M::multiplier_count; ++j) solved["multipliers"].push_back(exactly(multipliers[j]));
    }
    evaluate_energies();
    evaluate_constraints();
    evaluate_kinematics();
    evaluate_linearisation();
  }

  void evaluate_energies() {
    typename M::Energy energy{};
    M::energy(precomputed_, state_, inputs_, energy);
    direct["energy"] = {exactly(energy.kinetic), exactly(energy.force_function)};
    direct["power"] = {exactly(energy.power)};
    // Dependent on M so that a mechanism without the kernel is no error.
    [&]<class Mechanism_>(const Mechanism_*) {
      if constexpr (requires { typename Mechanism_::FirstIntegrals; }) {
        typename Mechanism_::FirstIntegrals integrals{};
        Mechanism_::first_integrals(precomputed_, state_, integrals);
        for (int i = 0; i < integrals.size; ++i) direct["integral " + std::to_string(i)] = {exactly(integrals[i])};
      }
      if constexpr (requires { typename Mechanism_::Reactions; }) {
        typename Mechanism_::Reactions reactions{};
        Mechanism_::reactions(precomputed_, state_, accelerations_, multipliers_, inputs_, reactions);
        for (int i = 0; i < reactions.size; ++i) direct["reaction " + std::to_string(i)] = {exactly(reactions[i])};
      }
    }(static_cast<const M*>(nullptr));
  }

  void evaluate_constraints() {
    [&]<class Mechanism_>(const Mechanism_*) {
      if constexpr (requires { typename Mechanism_::Constraints; }) {
        typename Mechanism_::Constraints constraints{};
        Mechanism_::constraints(precomputed_, state_, constraints);
        add_all(direct, "constraint value", constraints.value);
        add_all(direct, "constraint rate", constraints.rate);
        add_all(direct, "constraint gamma", constraints.gamma);
        constexpr int m = M::multiplier_count;
        for (int j = 0; j < n; ++j) {
          for (int i = 0; i < m; ++i) {
            direct["jacobian." + unit(j)].push_back(exactly(constraints.jacobian[static_cast<std::size_t>(i + m * j)]));
          }
        }
      }
    }(static_cast<const M*>(nullptr));
  }

  // The members of Kinematics: of each body position, rotation, velocity, angular velocity; of each point position,
  // velocity and a Jacobian whose columns have the units of the coordinates. All are columns of three components.
  void evaluate_kinematics() {
    typename M::Kinematics kinematics{};
    M::kinematics(precomputed_, state_, kinematics);
    const Scalar* next = reinterpret_cast<const Scalar*>(&kinematics);
    const auto take = [&](const std::string& key, int columns) {
      for (int i = 0; i < 3 * columns; ++i) direct[key].push_back(exactly(*next++));
    };
    for (int body = 0; body < bodies_; ++body) {
      const std::string name = "body " + std::to_string(body);
      take(name + " position", 1);
      take(name + " rotation", 3);
      take(name + " velocity", 1);
      take(name + " angular velocity", 1);
    }
    const Scalar* end = reinterpret_cast<const Scalar*>(&kinematics + 1);
    for (int point = 0; next != end; ++point) {
      const std::string name = "point " + std::to_string(point);
      ASSERT_GE(end - next, 6 + 3 * n) << "the members of Kinematics are not those this test knows";
      take(name + " position", 1);
      take(name + " velocity", 1);
      for (int j = 0; j < n; ++j) take(name + " jacobian." + unit(j), 1);
    }
  }

  void evaluate_linearisation() {
    typename M::Linearisation linear{};
    if constexpr (M::multiplier_count == 0) {
      EXPECT_EQ(M::linearisation(precomputed_, state_, accelerations_, multipliers_, inputs_, linear),
                torsor::Status::ok);
      for (int j = 0; j < 2 * n; ++j) {
        for (int i = 0; i < 2 * n; ++i) {
          const std::string key = "A." + std::to_string(i / n) + std::to_string(j / n) + unit(i % n) + unit(j % n);
          solved[key].push_back(exactly(linear.A[static_cast<std::size_t>(i + 2 * n * j)]));
        }
      }
      if constexpr (M::input_count > 0) {
        add_all(direct, "E", linear.E);
        for (int j = 0; j < M::input_count; ++j) {
          for (int i = n; i < 2 * n; ++i) {
            solved["B." + std::to_string(j) + unit(i % n)].push_back(
                exactly(linear.B[static_cast<std::size_t>(i + 2 * n * j)]));
          }
        }
      }
    } else {
      M::linearisation(precomputed_, state_, accelerations_, multipliers_, inputs_, linear);
    }
    add_matrix(direct, "linear M", linear.M);
    add_matrix(direct, "linear C", linear.C);
    add_matrix(direct, "linear K", linear.K);
    for (int i = 0; i < n; ++i) direct["F." + unit(i)].push_back(exactly(linear.F[static_cast<std::size_t>(i)]));
  }

  std::string_view units_;
  int bodies_;
  typename M::State state_{};
  typename M::Accelerations accelerations_{};
  typename M::Multipliers multipliers_{};
  typename M::Inputs inputs_{};
  typename M::Precomputed precomputed_{};
};

/// All groups against the truth: what is left of terms that cancel is some roundings of the group's own size.
inline void compare(testing_rounding::RightToRounding& check, const Results& results, const Results& truth,
                    double allowed) {
  for (const auto& [key, expected] : truth) check.vector(key, results.at(key), expected, allowed);
}

}  // namespace examples
