// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "torsor/runtime/batch/simd_pack.hpp"
#include "torsor/runtime/batch/simd_sincos.hpp"

namespace torsor {

// All are defined by every generated header, which may be included before this one or after it.
template <class Scalar>
struct scalar_traits;
template <class Scalar, bool in_float>
struct SineCosine;
template <class Scalar>
bool rounds_to_one_side(const Scalar& x) noexcept;

/// What a kernel needs of its scalar, for packs. Pivots are regular when they are in every lane; the sines and cosines
/// are those of generated headers: the same core, and beyond its bound, lane by lane, the same exact reduction.
template <class Number, int lanes, runtime::InstructionSet instructions>
struct scalar_traits<runtime::Simd<Number, lanes, instructions>> {
  using Scalar = runtime::Simd<Number, lanes, instructions>;
  using Mask = typename Scalar::Mask;
  static constexpr bool is_float = sizeof(Number) == sizeof(float);

  TORSOR_SIMD_INLINED static Scalar constant(double in_double, float in_float, const char* /*exact*/) noexcept {
    return Scalar(is_float ? static_cast<Number>(in_float) : static_cast<Number>(in_double));
  }
  template <class Callable>
  TORSOR_SIMD_INLINED static Scalar formula(double in_double, float in_float, const Callable&) noexcept {
    return constant(in_double, in_float, nullptr);
  }
  TORSOR_SIMD_INLINED static Scalar pi() noexcept { return constant(3.141592653589793, 3.1415927f, nullptr); }
  TORSOR_SIMD_INLINED static Scalar select(const Mask& mask, const Scalar& if_true, const Scalar& if_false) noexcept {
    return Scalar::select(mask, if_true, if_false);
  }
  TORSOR_SIMD_INLINED static void sincos(const Scalar& angle, Scalar& sine, Scalar& cosine) noexcept {
    const Scalar angles[1] = {angle};
    Scalar sines[1], cosines[1];
    sincos(angles, sines, cosines);
    sine = sines[0];
    cosine = cosines[0];
  }
  template <int N>
  TORSOR_SIMD_INLINED static void sincos(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N]) noexcept {
#if defined(TORSOR_STD_SINCOS) || defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0)
    lane_by_lane(angles, sines, cosines, N, Number(-1));
#else
    using Core = SineCosine<Scalar, is_float>;
    if constexpr (Scalar::in_register) {
      runtime::sincos_in_packs(angles, sines, cosines);
    } else {
      for (int i = 0; i < N; ++i) Core::core(angles[i], sines[i], cosines[i]);
    }
    const Number bound = static_cast<Number>(Core::bound);
    Scalar sum = abs(angles[0]);
    for (int i = 1; i < N; ++i) sum += abs(angles[i]);
    const bool to_one_side = rounds_to_one_side(sum[0]);
    if (all(sum <= Scalar(bound)) && !to_one_side) return;
    lane_by_lane(angles, sines, cosines, N, to_one_side ? Number(-1) : bound);
#endif
  }
  TORSOR_SIMD_INLINED static Scalar sqrt(const Scalar& x) noexcept { return Scalar::sqrt(x); }
  static Scalar exp(const Scalar& x) noexcept {
    Scalar result;
    for (int i = 0; i < lanes; ++i) result.set(i, std::exp(x[i]));
    return result;
  }
  static Scalar log(const Scalar& x) noexcept {
    Scalar result;
    for (int i = 0; i < lanes; ++i) result.set(i, std::log(x[i]));
    return result;
  }
  /// Lane by lane; a kernel asks whether it holds in all.
  TORSOR_SIMD_INLINED static Mask regular(const Scalar& pivot, const Scalar& diagonal) noexcept {
    return opposite(pivot <= constant(0x1p-52, 0x1p-23f, nullptr) * abs(diagonal));
  }
  TORSOR_SIMD_INLINED static Mask finite(const Scalar& x) noexcept { return x - x >= constant(0.0, 0.0f, nullptr); }

 private:
  /// Of angles beyond the bound, which are rare.
  TORSOR_SIMD_OUTLINED static void lane_by_lane(const Scalar* angles, Scalar* sines, Scalar* cosines, int count,
                                                Number bound) noexcept {
    for (int i = 0; i < count; ++i) {
      for (int lane = 0; lane < lanes; ++lane) {
        const Number angle = angles[i][lane];
        if (std::abs(angle) <= bound) continue;
        Number sine, cosine;
        scalar_traits<Number>::sincos(angle, sine, cosine);
        sines[i].set(lane, sine);
        cosines[i].set(lane, cosine);
      }
    }
  }
};

}  // namespace torsor
