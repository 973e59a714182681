// SPDX-License-Identifier: GPL-3.0-or-later

// What `verify` measures is what a header computes: the same bits. Fused multiplications would differ.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off")
#elif defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "generated/loading_robot.hpp"
#include "generated/satellite_arms.hpp"
#include "generated/shaker.hpp"
#include "generated/vibration_absorber.hpp"
#include "torsor/generator/verification/kernel_accuracy.hpp"
#include "tests/examples/scenes.hpp"

namespace torsor::verified_kernels_test {
namespace {

/// Compares every entry that the header gives for one kernel with what verify computed for it.
class Comparison {
 public:
  Comparison(KernelAccuracy& accuracy, const std::string& kernel) : name_(kernel) {
    const auto& kernels = accuracy.kernels();
    const auto place = std::find_if(kernels.begin(), kernels.end(), [&](const OwnKernel& k) { return k.kernel.name == kernel; });
    EXPECT_NE(place, kernels.end()) << kernel;
    const std::vector<double> values = accuracy.computed(static_cast<std::size_t>(place - kernels.begin()));
    for (std::size_t i = 0; i < values.size(); ++i) expected_.emplace_back(place->kernel.assignments[i].target.to_string(), values[i]);
  }

  template <class Scalar>
  void entry(const std::string& target, Scalar found) {
    const auto place =
        std::find_if(expected_.begin(), expected_.end(), [&](const auto& e) { return e.first == target; });
    ASSERT_NE(place, expected_.end()) << name_ << ": " << target;
    EXPECT_EQ(place->second, static_cast<double>(found)) << name_ << ": " << target;
    ++compared_;
  }
  template <class Array>
  void entries(const std::string& target, const Array& found, int count) {
    for (int i = 0; i < count; ++i) entry(target + "[" + std::to_string(i) + "]", found[static_cast<std::size_t>(i)]);
  }
  void expect_compared(std::size_t count) const { EXPECT_EQ(compared_, count) << name_; }

 private:
  std::string name_;
  std::vector<std::pair<std::string, double>> expected_;
  std::size_t compared_ = 0;
};

template <template <class> class Mechanism, class Scalar>
void expect_same_bits(const Scene& scene, Precision precision, StateFormat format) {
  using M = Mechanism<Scalar>;
  constexpr int n = M::velocity_count;
  // Those of the committed headers: terms stand in the order in which kernels were derived.
  const std::string kernels =
      "kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,"
      "linearisation";
  const auto accuracy = kernel_accuracy(scene, {}, parse_kernel_list(kernels), precision);
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const StressState state(scene, accuracy->symbols(), seed, format);
    accuracy->move_to(state);
    const auto value = [&](const SymbolPointer& symbol) {
      const auto& known = state.symbols();  // a kernel reads nothing else
      return std::find(known.begin(), known.end(), symbol) == known.end() ? Scalar(0)
                                                                          : static_cast<Scalar>(state.value(symbol));
    };
    typename M::State s{};
    typename M::Accelerations a{};
    typename M::Inputs u{};
    typename M::Multipliers lambda{};
    s.time = value(scene.content().time);
    int i = 0;
    for (const CoordinateContent& c : scene.content().coordinates) {
      if (!c.unknown()) continue;
      s.q[i] = value(c.q);
      s.v[i] = value(c.v);
      a[i] = value(c.a);
      ++i;
    }
    ASSERT_EQ(i, n);
    int input = 0;
    for (const ActionContent& action : scene.content().actions) {
      if (const auto* motor = std::get_if<Motor>(&action)) u[input++] = value(motor->input);
    }
    auto parameters = M::default_parameters();
    int number = 0;
    for (const ParameterContent& parameter : scene.content().parameters) {
      if (parameter.run_time || !parameter.value) parameters[number++] = value(parameter.symbol);
    }
    const auto p = M::precompute(parameters);

    std::array<Scalar, static_cast<std::size_t>(n) * n> mass{};
    M::mass_matrix(p, s, mass);
    Comparison of_mass(*accuracy, "mass_matrix");
    of_mass.entries("mass", mass, n * n);

    typename M::GeneralizedForces forces{};
    M::bias(p, s, forces);
    Comparison(*accuracy, "bias").entries("forces", forces, n);
    M::inverse_dynamics(p, s, a, lambda, forces);
    Comparison(*accuracy, "inverse_dynamics").entries("forces", forces, n);

    typename M::Accelerations solved{};
    typename M::Multipliers multipliers{};
    if (M::forward_dynamics(p, s, u, solved, multipliers) == Status::ok) {
      Comparison(*accuracy, "forward_dynamics").entries("accelerations", solved, n);
    }
    typename M::Energy energy{};
    M::energy(p, s, u, energy);
    Comparison of_energy(*accuracy, "energy");
    of_energy.entry("result.kinetic", energy.kinetic);
    of_energy.entry("result.force_function", energy.force_function);
    of_energy.expect_compared(2);
  }
}

template <template <class> class Mechanism>
void expect_same_bits(const Scene& scene) {
  SCOPED_TRACE(scene.name());
  expect_same_bits<Mechanism, double>(scene, Precision::in_double, double_states);
  expect_same_bits<Mechanism, float>(scene, Precision::in_float, float_states);
}

TEST(VerifiedKernels, AreThoseOfTheHeaderBitForBit) {
  expect_same_bits<loading_robot::Mechanism>(loading_robot_scene());
  expect_same_bits<satellite_arms::Mechanism>(satellite_arms_scene());
  expect_same_bits<shaker::Mechanism>(shaker_scene());
  expect_same_bits<vibration_absorber::Mechanism>(vibration_absorber_scene());
}

}  // namespace
}  // namespace torsor::verified_kernels_test
