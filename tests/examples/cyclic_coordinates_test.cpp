// SPDX-License-Identifier: GPL-3.0-or-later
// Where a mechanism stands on its ground is nothing to its equations: places enter as differences made before any sum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "generated/chaplygin_sleigh.hpp"
#include "generated/four_wheel_vehicle.hpp"
#include "generated/quadruped_on_its_feet.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "generated/tumbler_rough_table.hpp"
#include "generated/whipple_bicycle.hpp"

namespace torsor::cyclic_coordinates_test {
namespace {

/// What each kernel writes; those of places and of a state are no equations.
template <class M>
class Written {
 public:
  explicit Written(const typename M::State& state) : state_(state), precomputed_(M::precompute(M::default_parameters())) {}
  std::vector<double> all;
  std::vector<std::string> kernels;

  template <class Code, class... Arguments>
  void operator()(const KernelDescription& kernel,
                  Code (*function)(const typename M::Precomputed&, const typename M::State&, Arguments...) noexcept) {
    if constexpr ((std::is_class_v<std::remove_cvref_t<Arguments>> && ...)) {
      const std::string_view name = kernel.name;
      if (name == "kinematics" || name == "first_integrals") return;
      kernels.emplace_back(name);
      std::tuple<std::remove_cvref_t<Arguments>...> given{};
      std::apply(
          [&](auto&... each) {
            (fill(each), ...);
            static_cast<void>(function(precomputed_, state_, each...));
            (keep(each), ...);
          },
          given);
    }
  }

 private:
  template <class Argument>
  static void fill(Argument& argument) {
    if constexpr (std::is_empty_v<Argument>) return;
    const double number = 0.375;
    for (std::size_t at = 0; at + sizeof number <= sizeof argument; at += sizeof number) {
      std::memcpy(reinterpret_cast<char*>(&argument) + at, &number, sizeof number);
    }
  }
  template <class Argument>
  void keep(const Argument& argument) {
    if constexpr (std::is_empty_v<Argument>) return;
    const std::size_t before = all.size();
    all.resize(before + sizeof argument / sizeof(double));
    std::memcpy(all.data() + before, &argument, (all.size() - before) * sizeof(double));
  }

  typename M::State state_;
  typename M::Precomputed precomputed_;
};

/// The first coordinates are those of a translation along the ground.
template <template <class> class Mechanism>
void expect_same_bits_far_away(int cyclic = 2) {
  using M = Mechanism<double>;
  std::mt19937 random(7);
  for (int seed = 0; seed < 4; ++seed) {
    typename M::State state = M::initial_state();
    const auto drawn = [&random] { return 1e-3 * static_cast<double>(random() % 2000) - 1; };
    for (int i = 0; i < M::coordinate_count; ++i) state.q[i] += 0.3 * drawn();
    for (int i = 0; i < M::velocity_count; ++i) state.v[i] = drawn();
    typename M::State far = state;
    for (int i = 0; i < cyclic; ++i) far.q[i] += i == 0 ? 1e6 : -3e6;
    Written<M> here(state), there(far);
    M::for_each_kernel(here);
    M::for_each_kernel(there);
    ASSERT_GE(here.kernels.size(), 3U) << M::name;
    ASSERT_EQ(here.all.size(), there.all.size());
    EXPECT_TRUE(std::any_of(here.all.begin(), here.all.end(), [](double x) { return std::abs(x) > 1e-3 && x != 0.375; }));
    for (std::size_t i = 0; i < here.all.size(); ++i) {
      if (std::isnan(here.all[i]) && std::isnan(there.all[i])) continue;
      EXPECT_EQ(here.all[i], there.all[i]) << M::name << ", number " << i;
    }
  }
}

TEST(CyclicCoordinates, EnterNoContacts) {
  expect_same_bits_far_away<quadruped_on_its_feet::Mechanism>();
  expect_same_bits_far_away<tumbler_rough_table::Mechanism>();
}

TEST(CyclicCoordinates, EnterNoConstraintsNorAccelerations) {
  expect_same_bits_far_away<whipple_bicycle::Mechanism>();
  expect_same_bits_far_away<rolling_hoop_contact_forces::Mechanism>();
  expect_same_bits_far_away<chaplygin_sleigh::Mechanism>();
  expect_same_bits_far_away<four_wheel_vehicle::Mechanism>();
}

}  // namespace
}  // namespace torsor::cyclic_coordinates_test
