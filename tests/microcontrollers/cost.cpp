// SPDX-License-Identifier: GPL-3.0-or-later
// What one kernel costs a controller. With PART_KERNEL defined it is the kernel alone, HEADER's MECHANISM in REAL,
// whose object is measured; without, the program that calls it and prints how many instructions it took under QEMU,
// where 40 are a tick of the clock.
#include <cstdint>

#include HEADER

using M = MECHANISM::Mechanism<REAL>;

#if defined(PART_KERNEL)
extern "C" int mass_matrix(const M::Precomputed& p, const M::State& s, const M::Accelerations&, const M::Multipliers&,
                           const M::Inputs&, REAL* results) {
  M::mass_matrix(p, s, *reinterpret_cast<std::array<REAL, M::velocity_count * M::velocity_count>*>(results));
  return 0;
}
extern "C" int inverse_dynamics(const M::Precomputed& p, const M::State& s, const M::Accelerations& a,
                                const M::Multipliers& l, const M::Inputs&, REAL* results) {
  M::inverse_dynamics(p, s, a, l, *reinterpret_cast<M::GeneralizedForces*>(results));
  return 0;
}
extern "C" int forward_dynamics(const M::Precomputed& p, const M::State& s, const M::Accelerations&, M::Multipliers& l,
                                const M::Inputs& u, REAL* results) {
  return static_cast<int>(M::forward_dynamics(p, s, u, *reinterpret_cast<M::Accelerations*>(results), l));
}
#else
#include "examples/cortex_m/board.hpp"

extern "C" int KERNEL(const M::Precomputed& p, const M::State& s, const M::Accelerations& a, M::Multipliers& l,
                      const M::Inputs& u, REAL* results);

int main() {
  const M::Precomputed precomputed = M::precompute(M::default_parameters());
  const M::State state = M::initial_state();
  const M::Accelerations accelerations{};
  M::Multipliers multipliers{};
  const M::Inputs inputs{};
  static REAL results[M::velocity_count * M::velocity_count + 1];
  constexpr int repetitions = 1000;
  Clock::start(0x1000000, false);
  const std::uint32_t begin = Clock::now();
  for (int k = 0; k < repetitions; ++k) KERNEL(precomputed, state, accelerations, multipliers, inputs, results);
  const std::uint32_t ticks = (begin - Clock::now()) & 0xffffffU;
  say_number(static_cast<float>(ticks) * 40.0f / repetitions, 0);
  return 0;
}
#endif
