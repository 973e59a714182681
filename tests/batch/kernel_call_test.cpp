// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/abi/kernel_call.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>

#include "tests/runtime/mechanisms.hpp"
#include "torsor/runtime/batch/simd.hpp"

namespace kernel_call_test {
namespace {

using namespace torsor::runtime;
using namespace torsor::runtime::abi;

/// A force 1/x, and one that is x itself: no kernel with a status.
template <class Scalar>
struct Repelled : mechanisms::ContractOf<Scalar, 2, 0> {
  using Base = mechanisms::ContractOf<Scalar, 2, 0>;
  using typename Base::Precomputed, typename Base::State, typename Base::GeneralizedForces;
  static void bias(const Precomputed&, const State& s, GeneralizedForces& h) noexcept {
    h[0] = Scalar(1.0) / s.q[0];
    h[1] = s.q[1];
  }
};
using Single = Repelled<double>;
using Packed = Repelled<NativeSimd<double>>;

TEST(KernelCall, TellsResultsThatAreNotFiniteOfKernelsWithoutAStatus) {
  KernelCall<Single, Packed> kernel;
  kernel.single = any_kernel<Single>(&Single::bias);
  kernel.packed = any_kernel<Packed>(&Packed::bias);
  const torsor_abi_result result{"bias", 2, 1, 1, ""};
  const std::array<ResultWriter, 1> writers{nullptr};
  kernel.shape.results = &result;
  kernel.shape.writers = writers.data();
  kernel.shape.result_count = 1;

  constexpr std::size_t most = 37;
  constexpr double huge = std::numeric_limits<double>::max();
  for (const std::size_t states : {std::size_t{1}, std::size_t{2}, most}) {
    std::array<std::array<double, 2>, most> q, v{}, forces{};
    for (std::size_t s = 0; s < states; ++s) q[s] = {1.0 + static_cast<double>(s), 2.0};
    q[states / 2][0] = 0.0;
    if (states > 2) q[3] = {2.0 / huge, huge};  // numbers whose sum overflows
    std::array<std::int32_t, most> statuses;
    statuses.fill(-1);
    const auto view = [](auto& data) {
      return torsor_view{data.data(), sizeof(data[0]), sizeof(double), sizeof(double)};
    };
    const torsor_view results = view(forces);
    torsor_call call{};
    call.states = states;
    call.threads = 1;
    call.q = view(q);
    call.v = view(v);
    call.results = &results;
    call.statuses = statuses.data();
    EXPECT_EQ(kernel({}, {}, call), 1);
    EXPECT_EQ(call.worst, torsor_state_not_finite);
    for (std::size_t s = 0; s < states; ++s) {
      EXPECT_EQ(statuses[s], s == states / 2 ? torsor_state_not_finite : torsor_state_ok) << s << " of " << states;
      EXPECT_EQ(forces[s][0], 1.0 / q[s][0]) << s;
    }
  }
}

}  // namespace
}  // namespace kernel_call_test
