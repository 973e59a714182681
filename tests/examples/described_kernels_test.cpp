// SPDX-License-Identifier: GPL-3.0-or-later
// What headers say of themselves is what their types say; a new kernel is met here by itself.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "generated/andrews_squeezer.hpp"
#include "generated/arm7.hpp"
#include "generated/double_pendulum.hpp"
#include "generated/flyball_governor.hpp"
#include "generated/loading_robot.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/torque_free_body.hpp"

namespace torsor::described_kernels_test {
namespace {

template <class Check>
void for_some_mechanisms(const Check& check) {
  check(andrews_squeezer::Mechanism<double>());
  check(arm7::Mechanism<double>());
  check(double_pendulum::Mechanism<double>());
  check(flyball_governor::Mechanism<double>());
  check(loading_robot::Mechanism<double>());
  check(rolling_hoop::Mechanism<double>());
  check(torque_free_body::Mechanism<double>());
}

/// Numbers in what an argument points to or refers to; nothing in one that is read.
template <class M, class Argument>
struct Written {
  static constexpr std::size_t numbers = 0;
};
template <class M, class T>
struct Written<M, const T&> {
  static constexpr std::size_t numbers = 0;
};
template <class M, class T>
struct Written<M, T&> {
  static constexpr std::size_t numbers = std::is_empty_v<T> ? 0 : sizeof(T) / sizeof(double);
};

template <class M>
struct Walk {
  std::vector<std::string> names;

  template <class Code, class... Arguments>
  void operator()(const KernelDescription& kernel,
                  Code (*function)(const typename M::Precomputed&, const typename M::State&, Arguments...)) {
    names.emplace_back(kernel.name);
    EXPECT_NE(function, nullptr);
    EXPECT_EQ(kernel.has_status, (std::is_same_v<Code, Status>)) << kernel.name;
    EXPECT_EQ(kernel.reads_accelerations, (std::is_same_v<Arguments, const typename M::Accelerations&> || ...));
    EXPECT_EQ(kernel.reads_multipliers, (std::is_same_v<Arguments, const typename M::Multipliers&> || ...));
    EXPECT_EQ(kernel.reads_inputs, (std::is_same_v<Arguments, const typename M::Inputs&> || ...));
    std::size_t numbers = 0;
    for (int r = 0; r < kernel.result_count; ++r) {
      const ResultDescription& result = kernel.results[r];
      numbers += static_cast<std::size_t>(result.rows) * static_cast<std::size_t>(result.columns);
      EXPECT_STRNE(result.result, "") << kernel.name;
      EXPECT_TRUE(result.dimensions == 2 || result.columns == 1) << kernel.name;
      EXPECT_TRUE(result.dimensions > 0 || result.rows == 1) << kernel.name;
      EXPECT_EQ(std::string_view(result.unit).find("^-"), std::string_view::npos)
          << M::name << ": " << kernel.name << ": a person writes N for kg m s^-2";
    }
    EXPECT_EQ(numbers, (Written<M, Arguments>::numbers + ... + 0)) << M::name << ": " << kernel.name;
  }
};

TEST(DescribedKernels, HaveTheShapesOfTheirTypes) {
  for_some_mechanisms([]<class M>(const M&) {
    Walk<M> walk;
    M::for_each_kernel(walk);
    ASSERT_EQ(walk.names.size(), M::Description::kernels.size()) << M::name;
    for (std::size_t k = 0; k < walk.names.size(); ++k) EXPECT_EQ(walk.names[k], M::Description::kernels[k].name);
    EXPECT_GE(walk.names.size(), 3U) << M::name;
  });
}

TEST(DescribedQuantities, AreAsManyAsThereAreWithNames) {
  for_some_mechanisms([]<class M>(const M&) {
    EXPECT_EQ(M::Description::coordinates.size(), static_cast<std::size_t>(M::coordinate_count));
    EXPECT_EQ(M::Description::velocities.size(), static_cast<std::size_t>(M::velocity_count));
    EXPECT_EQ(M::Description::inputs.size(), static_cast<std::size_t>(M::input_count));
    EXPECT_EQ(M::Description::multipliers.size(), static_cast<std::size_t>(M::multiplier_count));
    EXPECT_EQ(M::Description::parameters.size(), static_cast<std::size_t>(M::parameter_count));
  });
  static_assert(double_pendulum::Description::coordinates.size() == 2, "data for the compiler too");
  EXPECT_STREQ(double_pendulum::Description::coordinates[0].name, "theta_1");
  EXPECT_STREQ(double_pendulum::Description::coordinates[0].unit, "rad");
  EXPECT_STREQ(double_pendulum::Description::velocities[1].unit, "rad/s");
  EXPECT_STREQ(loading_robot::Description::inputs[0].unit, "N m");
  EXPECT_STREQ(loading_robot::Description::inputs[1].unit, "N");
}

TEST(ShortForms, GiveTheBitsOfTheKernelsWithAllArguments) {
  using M = double_pendulum::Mechanism<double>;
  const auto p = M::precompute(M::default_parameters());
  auto state = M::initial_state();
  state.v = {0.3, -0.7};
  M::Accelerations whole{}, brief{};
  M::Multipliers none{};
  ASSERT_EQ(M::forward_dynamics(p, state, M::Inputs(), whole, none), Status::ok);
  ASSERT_EQ(M::forward_dynamics(p, state, brief), Status::ok);
  M::GeneralizedForces forces{}, brief_forces{};
  M::inverse_dynamics(p, state, whole, none, forces);
  M::inverse_dynamics(p, state, whole, brief_forces);
  for (int i = 0; i < M::velocity_count; ++i) {
    EXPECT_EQ(whole[i], brief[i]);
    EXPECT_EQ(forces[i], brief_forces[i]);
  }
  using Hoop = rolling_hoop::Mechanism<double>;  // with multipliers, without inputs
  Hoop::Accelerations a{}, brief_a{};
  Hoop::Multipliers lambda{}, brief_lambda{};
  const auto hoop = Hoop::precompute(Hoop::default_parameters());
  ASSERT_EQ(Hoop::forward_dynamics(hoop, Hoop::initial_state(), {}, a, lambda), Status::ok);
  ASSERT_EQ(Hoop::forward_dynamics(hoop, Hoop::initial_state(), brief_a, brief_lambda), Status::ok);
  for (int j = 0; j < Hoop::multiplier_count; ++j) EXPECT_EQ(lambda[j], brief_lambda[j]);
}

/// Loops over what a mechanism does not have compile, and do nothing.
TEST(EmptyStructures, HaveMembersByNumber) {
  using M = double_pendulum::Mechanism<double>;
  M::Inputs inputs;
  double sum = 0;
  for (int i = 0; i < M::Inputs::size; ++i) {
    inputs[i] = 1;
    sum += inputs[i];
  }
  EXPECT_EQ(sum, 0);
  static_assert(std::is_empty_v<M::Inputs>);
}

}  // namespace
}  // namespace torsor::described_kernels_test
