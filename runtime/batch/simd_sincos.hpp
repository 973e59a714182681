// SPDX-License-Identifier: MIT
#pragma once
#include "torsor/runtime/batch/simd_pack.hpp"

namespace torsor {

// Both are defined by every generated header where the compiler has types for registers; it may be included before this
// one or after it.
template <class Number, int lanes, int count>
struct Registers;
template <class Number, int lanes, int count>
void sincos_of_registers(const Registers<Number, lanes, count>& angles, Registers<Number, lanes, count>& sines,
                         Registers<Number, lanes, count>& cosines) noexcept;

namespace runtime {

/// Sines and cosines of angles up to SineCosine's bound, in packs that fill a register, as headers take those of several
/// numbers: one pack after the other. A processor begins with the next while the last one's results are on their way.
template <int N, class Pack>
TORSOR_SIMD_INLINED void sincos_in_packs(const Pack (&angles)[N], Pack (&sines)[N], Pack (&cosines)[N]) noexcept {
  // One copy of the code: its constants stay where they are.
#if defined(__clang__)
#pragma clang loop unroll(disable)
#elif defined(__GNUC__)
#pragma GCC unroll 1
#endif
  for (int i = 0; i < N; ++i) {
    Registers<typename Pack::Lane, Pack::lanes, 1> x, s, c;
    x.part[0] = angles[i].numbers();
    sincos_of_registers(x, s, c);
    sines[i].set(s.part[0]);
    cosines[i].set(c.part[0]);
  }
}

}  // namespace runtime
}  // namespace torsor
