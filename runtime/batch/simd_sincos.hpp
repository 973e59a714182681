// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/batch/simd_pack.hpp"

namespace torsor {

// Both are defined by every generated header where the compiler has types for registers; it may be included before this
// one or after it.
template <class Number, int lanes, int count>
struct Registers;
template <class Number, int lanes, int count>
void sincos_of_registers(const Registers<Number, lanes, count>& angles, Registers<Number, lanes, count>& sines,
                         Registers<Number, lanes, count>& cosines) noexcept;

namespace runtime {

/// Sines and cosines of `count` angles up to SineCosine's bound, in packs that fill a register, as headers take those
/// of several numbers.
template <int count, class Pack>
TORSOR_SIMD_INLINED void sincos_side_by_side(const Pack* angles, Pack* sines, Pack* cosines) noexcept {
  Registers<typename Pack::Lane, Pack::lanes, count> x, s, c;
  for (int i = 0; i < count; ++i) x.part[i] = angles[i].numbers();
  sincos_of_registers(x, s, c);
  for (int i = 0; i < count; ++i) sines[i].set(s.part[i]);
  for (int i = 0; i < count; ++i) cosines[i].set(c.part[i]);
}

/// Of all N angles, by twos.
template <int N, class Pack>
TORSOR_SIMD_INLINED void sincos_in_packs(const Pack (&angles)[N], Pack (&sines)[N], Pack (&cosines)[N]) noexcept {
  // One copy of the code: its constants stay where they are.
#if defined(__clang__)
#pragma clang loop unroll(disable)
#elif defined(__GNUC__)
#pragma GCC unroll 1
#endif
  for (int i = 0; i + 1 < N; i += 2) sincos_side_by_side<2>(angles + i, sines + i, cosines + i);
  if constexpr (N % 2 != 0) sincos_side_by_side<1>(angles + (N - 1), sines + (N - 1), cosines + (N - 1));
}

}  // namespace runtime
}  // namespace torsor
