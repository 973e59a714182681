// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/batch/simd_pack.hpp"

namespace torsor {

// Both are defined by every generated header, which may be included before this one or after it.
template <class Scalar>
struct scalar_traits;
template <class Scalar, bool in_float>
struct SineCosine;

namespace runtime {

/// Packs that take the same operations by turns: while the one waits for its last result, the other is at work. A
/// scalar for SineCosine, which needs constants, sums and products only.
template <class Pack, int count>
struct SideBySide {
  Pack pack[count];

  [[nodiscard]] friend TORSOR_SIMD_INLINED SideBySide operator+(const SideBySide& a, const SideBySide& b) noexcept {
    SideBySide result;
    for (int i = 0; i < count; ++i) result.pack[i] = a.pack[i] + b.pack[i];
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED SideBySide operator-(const SideBySide& a, const SideBySide& b) noexcept {
    SideBySide result;
    for (int i = 0; i < count; ++i) result.pack[i] = a.pack[i] - b.pack[i];
    return result;
  }
  [[nodiscard]] friend TORSOR_SIMD_INLINED SideBySide operator*(const SideBySide& a, const SideBySide& b) noexcept {
    SideBySide result;
    for (int i = 0; i < count; ++i) result.pack[i] = a.pack[i] * b.pack[i];
    return result;
  }
};

}  // namespace runtime

template <class Pack, int count>
struct scalar_traits<runtime::SideBySide<Pack, count>> {
  using Scalar = runtime::SideBySide<Pack, count>;
  TORSOR_SIMD_INLINED static Scalar constant(double in_double, float in_float, const char* exact) noexcept {
    Scalar result;
    for (int i = 0; i < count; ++i) result.pack[i] = scalar_traits<Pack>::constant(in_double, in_float, exact);
    return result;
  }
};

namespace runtime {

/// Sines and cosines of `count` angles, up to SineCosine's bound, in packs that fill a register: bit by bit what
/// SineCosine::core gives where the compiler fuses nothing else (-ffp-contract=off), within the same bound where it
/// does; by fewer operations and with several at work.
///  * n is exact in 21 bits (float: 10), n P and n Q are exact, so a product that is fused with its sum rounds as one
///    that is not, and may be formed twice;
///  * r = first - n P loses (first - r) - n P. Two operations tell it where |first| >= |n P|, as in Fast2Sum, and
///    elsewhere, because r is exact there: both are multiples of P's last bit, and r is less than 2^53 (2^24) of them;
///  * the quarter of the turn is in the last two bits of n + 1.5 2^52 (2^23): it is chosen by bits, not by products.
template <int count, bool in_float, class Pack>
TORSOR_SIMD_INLINED void sincos_side_by_side(const Pack* angles, Pack* sines, Pack* cosines) noexcept {
  using Packs = SideBySide<Pack, count>;
  const auto number = [](double for_double, float for_float) {
    return scalar_traits<Packs>::constant(for_double, for_float, nullptr);
  };
  Packs x;
  for (int i = 0; i < count; ++i) x.pack[i] = angles[i];
  const Packs unit_ulp = number(0x1.8p52, 0x1.8p23f);
  const Packs P = number(0x1.0b4611a6p-34, 0x1.ed5p-14f), Q = number(0x1.3198a2ep-69, 0x1.10bp-30f);
  const Packs turned = x * number(0x1.45f306dc9c883p-1, 0x1.45f306p-1f) + unit_ulp;
  const Packs n = turned - unit_ulp;
  const Packs first = x - n * number(0x1.921fb544p+0, 0x1.9218p+0f);
  const Packs r = first - n * P;
  const Packs error = (first - r) - n * P;
  const Packs high = r - n * Q;
  const Packs rest = ((n * Q - (r - high)) - error) + n * number(0x1.b839a252049c1p-104, 0x1.184698p-44f);
  Packs sine, cosine;
  SineCosine<Packs, in_float>::of_reduced(high, rest, sine, cosine);
  for (int i = 0; i < count; ++i) Pack::turn(turned.pack[i], sine.pack[i], cosine.pack[i], sines[i], cosines[i]);
}

/// Of all N angles, by twos.
template <bool in_float, int N, class Pack>
TORSOR_SIMD_INLINED void sincos_in_registers(const Pack (&angles)[N], Pack (&sines)[N], Pack (&cosines)[N]) noexcept {
  // One copy of the code: its constants stay where they are.
#if defined(__clang__)
#pragma clang loop unroll(disable)
#elif defined(__GNUC__)
#pragma GCC unroll 1
#endif
  for (int i = 0; i + 1 < N; i += 2) sincos_side_by_side<2, in_float>(angles + i, sines + i, cosines + i);
  if constexpr (N % 2 != 0) sincos_side_by_side<1, in_float>(angles + (N - 1), sines + (N - 1), cosines + (N - 1));
}

}  // namespace runtime
}  // namespace torsor
