// SPDX-License-Identifier: MIT
// quadruped
// Made by torsor 0.1.0 from quadruped.urdf; change that and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              988             1385          0             0                 16       0   2405    2405
//   mass_matrix             311              408          0             0                 12       0    743     795
//   bias                    388              518          0             0                 12       0    930    1026
//   inverse_dynamics        446              555          0             0                 12       0   1025    1121
//   forward_dynamics        958             1170         14             0                 12       0   2166    2330
//   energy                  352              494          0             0                 16       0    878     980
//
// Not computed because this mechanism does not need it:
//   kinematics: of 546 results 132 vanish identically, 108 repeat another up to sign
//   mass_matrix: of 324 results 114 vanish identically, 96 repeat another up to sign
//   constraints: left out, the scene has no constraints
//
// Angles and axes that were made exact:
//   1.5707963267948966 is pi/2: link front_left_thigh_link (rpy), link front_right_thigh_link (rpy), link rear_left_thigh_link (rpy), link rear_right_thigh_link (rpy)
//
// To write this file again:
//   torsor generate quadruped.urdf --base floating --points front_left_foot,front_right_foot,rear_left_foot,rear_right_foot --initial "trunk_z=0.8,trunk_x'=0.5,trunk_attitude_omega_x=0.3,trunk_attitude_omega_y=-0.5,front_left_thigh=0.7,front_left_knee=-1.4,front_right_thigh=0.7,front_right_knee=-1.4,rear_left_thigh=0.7,rear_left_knee=-1.4,rear_right_thigh=0.7,rear_right_knee=-1.4" --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output quadruped.hpp
#pragma once

#include <array>
#include <cmath>

#ifndef TORSOR_KERNEL_SUPPORT
#define TORSOR_KERNEL_SUPPORT 2
// Define it before the first generated header to annotate every function, e.g. as __host__ __device__.
#ifndef TORSOR_DEVICE
#define TORSOR_DEVICE
#endif
// Define TORSOR_STD_SINCOS before the first generated header, alike in the whole program, for std::sin and std::cos.

// Sine and cosine in one, of one angle or of several at once, with an error of at most 1 ulp (of some more where the
// processor is set to round up, down or towards zero). With rounding to nearest:
//  * the angle loses its quadrant, x = n pi/2 + r, by parts of pi/2 so short that n times a part is exact. Whether a
//    product and a sum are fused does not matter, here or elsewhere; letting the compiler reassociate sums would;
//  * two polynomials of least greatest error give the sine and the cosine of r, |r| <= pi/4;
//  * angles beyond `bound` are rare: they are reduced exactly, in integers, by a function that is not inlined, and so
//    are all angles under another rounding, which would give the nearest integers wrong.
// The core has no branch, so that compilers turn a loop over several angles into vector instructions.
#ifndef TORSOR_STD_SINCOS
#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0)
#define TORSOR_STD_SINCOS  // sums would be reassociated or hold more digits than their type
#endif
#endif
#if defined(_MSC_VER)
#define TORSOR_INLINED __forceinline
#define TORSOR_OUTLINED __declspec(noinline)
#else
#define TORSOR_INLINED inline __attribute__((always_inline))
#define TORSOR_OUTLINED __attribute__((noinline, cold))
#endif

namespace torsor {

template <class Scalar>
struct scalar_traits;

/// For float, double and packs of either (`in_float` says of which): of these, constants, sums and
/// products only are used.
template <class Scalar, bool in_float>
struct SineCosine {
  /// The core is meant for |x| <= bound; n is then exact in 10 or 21 bits and its products with the parts in 24 or 53.
  static constexpr double bound = in_float ? 1600.0 : 2097152.0;

  TORSOR_DEVICE TORSOR_INLINED static Scalar number(double for_double, float for_float) noexcept {
    return scalar_traits<Scalar>::constant(for_double, for_float, nullptr);
  }
  /// To the nearest integer, of two the even one.
  TORSOR_DEVICE TORSOR_INLINED static Scalar rounded(const Scalar& x) noexcept {
    const Scalar unit_ulp = number(0x1.8p52, 0x1.8p23f);
    return (x + unit_ulp) - unit_ulp;
  }

  /// Of high - rest, |high| <= pi/4, rest being about an ulp of high at most.
  TORSOR_DEVICE TORSOR_INLINED static void of_reduced(const Scalar& high, const Scalar& rest, Scalar& sine,
                                                      Scalar& cosine) noexcept {
    const Scalar one = number(1.0, 1.0f), half = number(0.5, 0.5f);
    const Scalar z = high * high, z2 = z * z;
    // sin r = r + r z S(z), cos r = 1 - z/2 + z z C(z)
    Scalar S, C;
    if constexpr (in_float) {
      const Scalar S01 = number(0.0, -0x1.555546p-3f) + z * number(0.0, 0x1.110778p-7f);
      const Scalar C01 = number(0.0, 0x1.55554ap-5f) + z * number(0.0, -0x1.6c0c1ap-10f);
      S = S01 + z2 * number(0.0, -0x1.9953f2p-13f);
      C = C01 + z2 * number(0.0, 0x1.99e0eep-16f);
    } else {
      const Scalar z4 = z2 * z2;
      const Scalar S01 = number(-0x1.5555555555548p-3, 0.0f) + z * number(0x1.111111110f73p-7, 0.0f);
      const Scalar S23 = number(-0x1.a01a019be9217p-13, 0.0f) + z * number(0x1.71de35552b518p-19, 0.0f);
      const Scalar S45 = number(-0x1.ae5e4b83e1601p-26, 0.0f) + z * number(0x1.5d8b55934597bp-33, 0.0f);
      const Scalar C01 = number(0x1.555555555554cp-5, 0.0f) + z * number(-0x1.6c16c16c1521bp-10, 0.0f);
      const Scalar C23 = number(0x1.a01a019cbeb68p-16, 0.0f) + z * number(-0x1.27e4f8121198fp-22, 0.0f);
      const Scalar C45 = number(0x1.1ee9f0cbf70d6p-29, 0.0f) + z * number(-0x1.8fb0e15d5f2ap-37, 0.0f);
      S = (S01 + z2 * S23) + z4 * S45;
      C = (C01 + z2 * C23) + z4 * C45;
    }
    const Scalar half_z = half * z, w = one - half_z;
    // Far below an ulp, it makes the correction of -0 a -0, and so the sine.
    const Scalar tiny = number(0x1p-100, 0x1p-60f);
    sine = high + (high * (tiny + z * S) - rest * w);
    cosine = w + (((one - w) - half_z) + (z2 * C + high * rest));
  }

  /// Of n pi/2 more.
  TORSOR_DEVICE TORSOR_INLINED static void turn(const Scalar& n, Scalar& sine, Scalar& cosine) noexcept {
    const Scalar one = number(1.0, 1.0f), two = number(2.0, 2.0f), half = number(0.5, 0.5f);
    const Scalar s = sine, c = cosine;
    // i = cos(n pi/2) = sin((n + 1) pi/2) and j = -sin(n pi/2): halves are rounded to even, which tells 1 from 3.
    const Scalar next = n + one;
    const Scalar i = next - two * rounded(half * next);
    const Scalar j = two * rounded(half * n) - n;
    sine = s * i - c * j;
    cosine = c * i + s * j;
  }

  /// For |x| <= bound; what is no number gives no number. Exact are n times the first three parts of pi/2, the first
  /// difference, and each rounded difference together with its rounding error.
  TORSOR_DEVICE TORSOR_INLINED static void core(const Scalar& x, Scalar& sine, Scalar& cosine) noexcept {
    const Scalar n = rounded(x * number(0x1.45f306dc9c883p-1, 0x1.45f306p-1f));
    const Scalar first = x - n * number(0x1.921fb544p+0, 0x1.9218p+0f);
    const Scalar second = n * number(0x1.0b4611a6p-34, 0x1.ed5p-14f);
    const Scalar third = n * number(0x1.3198a2ep-69, 0x1.10bp-30f);
    const Scalar fourth = n * number(0x1.b839a252049c1p-104, 0x1.184698p-44f);
    const Scalar r = first - second;
    const Scalar taken = first - r;
    const Scalar error = (first - (r + taken)) - (second - taken);
    const Scalar high = r - third;
    const Scalar rest = ((third - (r - high)) - error) + fourth;
    of_reduced(high, rest, sine, cosine);
    turn(n, sine, cosine);
  }
};

/// Whether sums are rounded up, down or towards zero: a little more and a little less than one then differ. What is no
/// number does not tell. x keeps compilers from doing the sums themselves.
template <class Scalar>
TORSOR_DEVICE TORSOR_INLINED bool rounds_to_one_side(const Scalar& x) noexcept {
  const Scalar one = static_cast<Scalar>(1) + (x - x), little = static_cast<Scalar>(0x1p-60);
  return (one + little) - (one - little) > static_cast<Scalar>(0);
}

/// Of any x, beyond the bound too, where n pi/2 is subtracted exactly: x/(2 pi) modulo 1 in integers, with as many
/// digits of 1/(2 pi) as |x - n pi/2| >= 2^-62 needs. Infinite: not a number. Under any rounding.
TORSOR_OUTLINED inline void sincos_far(double x, double& sine, double& cosine) noexcept {
  using Word = unsigned long long;  // of which 32 bits are used
  constexpr Word mask = 0xffffffffu;
  // 1/(2 pi) behind 64 zeros
  static constexpr unsigned turns[] = {
      0u,          0u,          0x28be60dbu, 0x9391054au, 0x7f09d5f4u, 0x7d4d3770u, 0x36d8a566u, 0x4f10e410u,
      0x7f9458eau, 0xf7aef158u, 0x6dc91b8eu, 0x909374b8u, 0x01924bbau, 0x82746487u, 0x3f877ac7u, 0x2c4a69cfu,
      0xba208d7du, 0x4baed121u, 0x3a671c09u, 0xad17df90u, 0x4e64758eu, 0x60d4ce7du, 0x272117e2u, 0xef7e4a0eu,
      0xc7fe25ffu, 0xf7816603u, 0xfbcbc462u, 0xd6829b47u, 0xdb4d9fb3u, 0xc9f2c26du, 0xd3d18fd9u, 0xa797fa8bu,
      0x5d49eeb1u, 0xfaf97c5eu, 0xcf41ce7du, 0xe294a4bau, 0x9afed7ecu, 0x47e35742u, 0x1580cc11u};
  if (!(std::abs(x) <= 0x1.fffffffffffffp+1023)) {
    sine = cosine = x - x;
    return;
  }
  if (std::abs(x) <= 0.5) {
    SineCosine<double, false>::of_reduced(x, 0.0, sine, cosine);
    return;
  }
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(x), &exponent);
  const Word integer = static_cast<Word>(std::ldexp(mantissa, 53));  // |x| = integer 2^(exponent - 53)
  const int position = exponent - 53 + 64;                           // at least 64 - 53
  const int skipped = position / 32, shift = position % 32;
  const Word low_word = (integer & mask) << shift, high_word = (integer >> 32) << shift;
  const Word factor[3] = {low_word & mask, ((low_word >> 32) + high_word) & mask,
                          (((low_word >> 32) + high_word) >> 32)};

  // The fraction of the product with seven words of 1/(2 pi), the lowest word first: an error of 2^-139 at most.
  Word turn[8] = {};
  for (int k = 0; k < 7; ++k) {
    Word carry = 0;
    for (int m = 0; m < 3 && k + m < 7; ++m) {
      carry += turn[k + m] + factor[m] * turns[skipped + 6 - k];
      turn[k + m] = carry & mask;
      carry >>= 32;
    }
    if (k + 3 < 7) turn[k + 3] = carry;
  }
  // Quarters of a turn, to nearest; what is left, |rest| <= 1/8, and its sign
  const Word quarter = ((turn[6] + 0x20000000u) & mask) >> 30;
  turn[6] = (turn[6] - (quarter << 30)) & mask;
  const bool negative = (turn[6] >> 31) != 0;
  Word carry = negative ? 1 : 0;
  for (int k = 0; k < 7; ++k) {
    turn[k] = (negative ? ~turn[k] & mask : turn[k]) + carry;
    carry = turn[k] >> 32;
    turn[k] &= mask;
  }
  // Its 128 leading bits, and these times pi/4
  int zeros = 0;
  for (; zeros < 96 && (turn[6] >> 31) == 0; ++zeros) {
    for (int k = 6; k > 0; --k) turn[k] = ((turn[k] << 1) & mask) | (turn[k - 1] >> 31);
    turn[0] = (turn[0] << 1) & mask;
  }
  static constexpr Word quarter_pi[4] = {0x80dc1cd1u, 0xc4c6628bu, 0x2168c234u, 0xc90fdaa2u};
  Word product[8] = {};
  for (int k = 0; k < 4; ++k) {
    carry = 0;
    for (int m = 0; m < 4; ++m) {
      carry += product[k + m] + turn[3 + k] * quarter_pi[m];
      product[k + m] = carry & mask;
      carry >>= 32;
    }
    product[k + 4] = carry;
  }
  // At least 0.39: 53 bits reach into the second word's last eleven bits or beyond.
  const Word leading = (product[7] << 32) | product[6], following = (product[5] << 32) | product[4];
  const double high = std::ldexp(static_cast<double>(leading & ~Word{2047}), 3 - zeros - 64);
  const double low = std::ldexp(static_cast<double>(((leading & 2047) << 53) | (following >> 11)), 3 - zeros - 117);
  double s = 0, c = 0;
  SineCosine<double, false>::of_reduced(negative ? -high : high, negative ? low : -low, s, c);
  const double turned = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
  cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
  sine = x < 0 ? -turned : turned;
}
TORSOR_OUTLINED inline void sincos_far(float x, float& sine, float& cosine) noexcept {
  double s = 0, c = 0;
  if (std::abs(x) <= static_cast<float>(SineCosine<double, false>::bound) && !rounds_to_one_side(x))
    SineCosine<double, false>::core(static_cast<double>(x), s, c);
  else
    sincos_far(static_cast<double>(x), s, c);
  sine = static_cast<float>(s);
  cosine = static_cast<float>(c);
}

/// Of one angle, in float or double.
template <class Scalar>
TORSOR_DEVICE inline void sincos_of_one(const Scalar& angle, Scalar& sine, Scalar& cosine) noexcept {
#if defined(__CUDA_ARCH__)
  if constexpr (sizeof(Scalar) == sizeof(float))
    ::sincosf(angle, &sine, &cosine);
  else
    ::sincos(angle, &sine, &cosine);
#elif defined(TORSOR_STD_SINCOS)
  sine = std::sin(angle);
  cosine = std::cos(angle);
#else
  using Core = SineCosine<Scalar, sizeof(Scalar) == sizeof(float)>;
  if (std::abs(angle) > static_cast<Scalar>(Core::bound) || rounds_to_one_side(angle))
    sincos_far(angle, sine, cosine);
  else
    Core::core(angle, sine, cosine);
#endif
}

/// Of some angles up to the bound, a multiple of what a vector holds. Local arrays, which nothing else can point to.
template <int size, class Scalar>
TORSOR_DEVICE TORSOR_INLINED void sincos_of_block(const Scalar* angles, Scalar* sines, Scalar* cosines) noexcept {
  Scalar x[size], s[size], c[size];
  for (int i = 0; i < size; ++i) x[i] = angles[i];
  // Compilers make vector instructions of a loop, but not always of a row of statements.
#if defined(__clang__)
#pragma clang loop unroll(disable)
#elif defined(__GNUC__) && !defined(__CUDACC__)
#pragma GCC unroll 1
#endif
  for (int i = 0; i < size; ++i) SineCosine<Scalar, sizeof(Scalar) == sizeof(float)>::core(x[i], s[i], c[i]);
  for (int i = 0; i < size; ++i) sines[i] = s[i];
  for (int i = 0; i < size; ++i) cosines[i] = c[i];
}

/// Of several angles at once, in float or double: as many as a vector holds go through the core together.
template <class Scalar, int N>
TORSOR_DEVICE inline void sincos_of_several(const Scalar (&angles)[N], Scalar (&sines)[N],
                                            Scalar (&cosines)[N]) noexcept {
  constexpr int narrow = 16 / sizeof(Scalar);
#if defined(__AVX__)
  constexpr int wide = 32 / sizeof(Scalar);
#else
  constexpr int wide = narrow;
#endif
#if defined(__CUDA_ARCH__) || defined(TORSOR_STD_SINCOS)
  constexpr bool by_vectors = false;
#elif defined(__clang__)
  constexpr bool by_vectors = N >= 4;  // it leaves a loop over two as it is
#else
  constexpr bool by_vectors = N >= narrow;
#endif
  if constexpr (by_vectors) {
    constexpr int vector = N >= wide ? wide : narrow, rest = N % vector;
    // Of a rest some angles are done again: a whole vector costs less than two or three alone.
#if defined(__clang__)
    sincos_of_block<N - rest>(angles, sines, cosines);  // best as one loop
    if constexpr (rest > 1) {
      sincos_of_block<vector>(angles + (N - vector), sines + (N - vector), cosines + (N - vector));
    }
#else
    for (int next = 0; next < N - (rest == 1); next += vector) {
      const int first = next + vector <= N ? next : N - vector;
      sincos_of_block<vector>(angles + first, sines + first, cosines + first);
    }
#endif
    if constexpr (rest == 1) sincos_of_one(angles[N - 1], sines[N - 1], cosines[N - 1]);
    constexpr Scalar bound = static_cast<Scalar>(SineCosine<Scalar, sizeof(Scalar) == sizeof(float)>::bound);
    Scalar sum = 0;
    for (int i = 0; i < N; ++i) sum += std::abs(angles[i]);
    const bool to_one_side = rounds_to_one_side(sum);
    if (sum <= bound && !to_one_side) return;
    for (int i = 0; i < N; ++i) {
      if (std::abs(angles[i]) > bound || to_one_side) sincos_far(angles[i], sines[i], cosines[i]);
    }
  } else {
    for (int i = 0; i < N; ++i) sincos_of_one(angles[i], sines[i], cosines[i]);
  }
}

/// Of several angles of any scalar: at once where its traits have a `sincos` of arrays, else one by one.
template <class Scalar, int N>
TORSOR_DEVICE auto sincos_by_traits(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N], int) noexcept
    -> decltype(scalar_traits<Scalar>::sincos(angles, sines, cosines)) {
  scalar_traits<Scalar>::sincos(angles, sines, cosines);
}
template <class Scalar, int N>
TORSOR_DEVICE void sincos_by_traits(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N],
                                    long) noexcept {
  for (int i = 0; i < N; ++i) scalar_traits<Scalar>::sincos(angles[i], sines[i], cosines[i]);
}
template <class Scalar, int N>
TORSOR_DEVICE void sines_and_cosines(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N]) noexcept {
  sincos_by_traits(angles, sines, cosines, 0);
}

}  // namespace torsor

namespace torsor {

/// What a kernel says about its results; the larger, the worse.
enum class Status : int { ok = 0, singular = 1, not_finite = 2 };

/// What a kernel needs of its scalar. This one serves float and double; specialise it, once a header is included, for
/// any other (a pack of several states, a high-precision number).
template <class Scalar>
struct scalar_traits {
  static_assert(sizeof(Scalar) == sizeof(float) || sizeof(Scalar) == sizeof(double),
                "specialise torsor::scalar_traits for a scalar that is neither float nor double");
  static constexpr bool is_float = sizeof(Scalar) == sizeof(float);

  /// A number, rounded for either format. `exact` is "num/den", or "a;b;c;d" for a + b sqrt(2) + c sqrt(3) + d sqrt(6).
  TORSOR_DEVICE static constexpr Scalar constant(double in_double, float in_float, const char* /*exact*/) noexcept {
    return is_float ? static_cast<Scalar>(in_float) : static_cast<Scalar>(in_double);
  }
  /// The same for a number that is no such sum: a callable computes it where literals are not precise enough.
  template <class Callable>
  TORSOR_DEVICE static constexpr Scalar formula(double in_double, float in_float, const Callable&) noexcept {
    return constant(in_double, in_float, nullptr);
  }
  TORSOR_DEVICE static constexpr Scalar pi() noexcept { return constant(3.141592653589793, 3.1415927f, nullptr); }
  TORSOR_DEVICE static constexpr Scalar select(bool condition, Scalar if_true, Scalar if_false) noexcept {
    return condition ? if_true : if_false;
  }
  TORSOR_DEVICE static void sincos(const Scalar& angle, Scalar& sine, Scalar& cosine) noexcept {
    sincos_of_one(angle, sine, cosine);
  }
  /// Of several angles at once; a specialisation without it gets them one by one.
  template <int N>
  TORSOR_DEVICE static void sincos(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N]) noexcept {
    sincos_of_several(angles, sines, cosines);
  }
  TORSOR_DEVICE static Scalar sqrt(const Scalar& x) noexcept { return std::sqrt(x); }
  TORSOR_DEVICE static Scalar exp(const Scalar& x) noexcept { return std::exp(x); }
  TORSOR_DEVICE static Scalar log(const Scalar& x) noexcept { return std::log(x); }
  /// Whether a pivot is positive beyond the rounding of the diagonal entry it came from; not when it is not a number.
  TORSOR_DEVICE static bool regular(const Scalar& pivot, const Scalar& diagonal) noexcept {
    return pivot > constant(0x1p-52, 0x1p-23f, nullptr) * std::abs(diagonal);
  }
};

}  // namespace torsor
#elif TORSOR_KERNEL_SUPPORT != 2
#error "headers of incompatible versions of torsor meet here: write them again with one version"
#endif

namespace quadruped {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "quadruped";
  static constexpr int coordinate_count = 19;
  static constexpr int velocity_count = 18;
  static constexpr int input_count = 12;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[] = {3};
  /// Range of each freedom, largest rate and largest effort, by its index in v; infinite where the scene states none.
  /// Data: no kernel looks at them.
  struct Limits { double lower, upper, velocity, effort; };
  static constexpr Limits limits[] = {
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_x
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_y
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_z
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_attitude_omega_x
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_attitude_omega_y
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_attitude_omega_z
      {-0.8, 0.8, 20.0, 25.0},  // front_left_hip
      {-1.5, 3.0, 20.0, 25.0},  // front_left_thigh
      {-2.7, -0.3, 20.0, 40.0},  // front_left_knee
      {-0.8, 0.8, 20.0, 25.0},  // front_right_hip
      {-1.5, 3.0, 20.0, 25.0},  // front_right_thigh
      {-2.7, -0.3, 20.0, 40.0},  // front_right_knee
      {-0.8, 0.8, 20.0, 25.0},  // rear_left_hip
      {-1.5, 3.0, 20.0, 25.0},  // rear_left_thigh
      {-2.7, -0.3, 20.0, 40.0},  // rear_left_knee
      {-0.8, 0.8, 20.0, 25.0},  // rear_right_hip
      {-1.5, 3.0, 20.0, 25.0},  // rear_right_thigh
      {-2.7, -0.3, 20.0, 40.0},  // rear_right_knee
  };

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar trunk_x;  ///< coordinate [m]
    Scalar trunk_y;  ///< coordinate [m]
    Scalar trunk_z;  ///< coordinate [m]
    Scalar trunk_attitude_w;  ///< component of a unit quaternion [1]
    Scalar trunk_attitude_x;  ///< component of a unit quaternion [1]
    Scalar trunk_attitude_y;  ///< component of a unit quaternion [1]
    Scalar trunk_attitude_z;  ///< component of a unit quaternion [1]
    Scalar front_left_hip;  ///< coordinate [rad or 1]
    Scalar front_left_thigh;  ///< coordinate [rad or 1]
    Scalar front_left_knee;  ///< coordinate [rad or 1]
    Scalar front_right_hip;  ///< coordinate [rad or 1]
    Scalar front_right_thigh;  ///< coordinate [rad or 1]
    Scalar front_right_knee;  ///< coordinate [rad or 1]
    Scalar rear_left_hip;  ///< coordinate [rad or 1]
    Scalar rear_left_thigh;  ///< coordinate [rad or 1]
    Scalar rear_left_knee;  ///< coordinate [rad or 1]
    Scalar rear_right_hip;  ///< coordinate [rad or 1]
    Scalar rear_right_thigh;  ///< coordinate [rad or 1]
    Scalar rear_right_knee;  ///< coordinate [rad or 1]
    static constexpr int size = 19;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::trunk_x, &Coordinates::trunk_y, &Coordinates::trunk_z,
          &Coordinates::trunk_attitude_w, &Coordinates::trunk_attitude_x, &Coordinates::trunk_attitude_y,
          &Coordinates::trunk_attitude_z, &Coordinates::front_left_hip, &Coordinates::front_left_thigh,
          &Coordinates::front_left_knee, &Coordinates::front_right_hip, &Coordinates::front_right_thigh,
          &Coordinates::front_right_knee, &Coordinates::rear_left_hip, &Coordinates::rear_left_thigh,
          &Coordinates::rear_left_knee, &Coordinates::rear_right_hip, &Coordinates::rear_right_thigh,
          &Coordinates::rear_right_knee};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar trunk_x;  ///< its rate [m/s]
    Scalar trunk_y;  ///< its rate [m/s]
    Scalar trunk_z;  ///< its rate [m/s]
    Scalar trunk_attitude_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar trunk_attitude_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar trunk_attitude_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar front_left_hip;  ///< its rate [rad/s]
    Scalar front_left_thigh;  ///< its rate [rad/s]
    Scalar front_left_knee;  ///< its rate [rad/s]
    Scalar front_right_hip;  ///< its rate [rad/s]
    Scalar front_right_thigh;  ///< its rate [rad/s]
    Scalar front_right_knee;  ///< its rate [rad/s]
    Scalar rear_left_hip;  ///< its rate [rad/s]
    Scalar rear_left_thigh;  ///< its rate [rad/s]
    Scalar rear_left_knee;  ///< its rate [rad/s]
    Scalar rear_right_hip;  ///< its rate [rad/s]
    Scalar rear_right_thigh;  ///< its rate [rad/s]
    Scalar rear_right_knee;  ///< its rate [rad/s]
    static constexpr int size = 18;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::trunk_x, &Velocities::trunk_y, &Velocities::trunk_z,
          &Velocities::trunk_attitude_omega_x, &Velocities::trunk_attitude_omega_y, &Velocities::trunk_attitude_omega_z,
          &Velocities::front_left_hip, &Velocities::front_left_thigh, &Velocities::front_left_knee,
          &Velocities::front_right_hip, &Velocities::front_right_thigh, &Velocities::front_right_knee,
          &Velocities::rear_left_hip, &Velocities::rear_left_thigh, &Velocities::rear_left_knee,
          &Velocities::rear_right_hip, &Velocities::rear_right_thigh, &Velocities::rear_right_knee};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar trunk_x;  ///< its second rate [m/s^2]
    Scalar trunk_y;  ///< its second rate [m/s^2]
    Scalar trunk_z;  ///< its second rate [m/s^2]
    Scalar trunk_attitude_omega_x;  ///< its rate [rad/s^2]
    Scalar trunk_attitude_omega_y;  ///< its rate [rad/s^2]
    Scalar trunk_attitude_omega_z;  ///< its rate [rad/s^2]
    Scalar front_left_hip;  ///< its second rate [rad/s^2]
    Scalar front_left_thigh;  ///< its second rate [rad/s^2]
    Scalar front_left_knee;  ///< its second rate [rad/s^2]
    Scalar front_right_hip;  ///< its second rate [rad/s^2]
    Scalar front_right_thigh;  ///< its second rate [rad/s^2]
    Scalar front_right_knee;  ///< its second rate [rad/s^2]
    Scalar rear_left_hip;  ///< its second rate [rad/s^2]
    Scalar rear_left_thigh;  ///< its second rate [rad/s^2]
    Scalar rear_left_knee;  ///< its second rate [rad/s^2]
    Scalar rear_right_hip;  ///< its second rate [rad/s^2]
    Scalar rear_right_thigh;  ///< its second rate [rad/s^2]
    Scalar rear_right_knee;  ///< its second rate [rad/s^2]
    static constexpr int size = 18;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::trunk_x, &Accelerations::trunk_y,
          &Accelerations::trunk_z, &Accelerations::trunk_attitude_omega_x, &Accelerations::trunk_attitude_omega_y,
          &Accelerations::trunk_attitude_omega_z, &Accelerations::front_left_hip, &Accelerations::front_left_thigh,
          &Accelerations::front_left_knee, &Accelerations::front_right_hip, &Accelerations::front_right_thigh,
          &Accelerations::front_right_knee, &Accelerations::rear_left_hip, &Accelerations::rear_left_thigh,
          &Accelerations::rear_left_knee, &Accelerations::rear_right_hip, &Accelerations::rear_right_thigh,
          &Accelerations::rear_right_knee};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar trunk_x;  ///< works with the rate of trunk_x [N]
    Scalar trunk_y;  ///< works with the rate of trunk_y [N]
    Scalar trunk_z;  ///< works with the rate of trunk_z [N]
    Scalar trunk_attitude_omega_x;  ///< works with trunk_attitude_omega_x [N m]
    Scalar trunk_attitude_omega_y;  ///< works with trunk_attitude_omega_y [N m]
    Scalar trunk_attitude_omega_z;  ///< works with trunk_attitude_omega_z [N m]
    Scalar front_left_hip;  ///< works with the rate of front_left_hip [N m]
    Scalar front_left_thigh;  ///< works with the rate of front_left_thigh [N m]
    Scalar front_left_knee;  ///< works with the rate of front_left_knee [N m]
    Scalar front_right_hip;  ///< works with the rate of front_right_hip [N m]
    Scalar front_right_thigh;  ///< works with the rate of front_right_thigh [N m]
    Scalar front_right_knee;  ///< works with the rate of front_right_knee [N m]
    Scalar rear_left_hip;  ///< works with the rate of rear_left_hip [N m]
    Scalar rear_left_thigh;  ///< works with the rate of rear_left_thigh [N m]
    Scalar rear_left_knee;  ///< works with the rate of rear_left_knee [N m]
    Scalar rear_right_hip;  ///< works with the rate of rear_right_hip [N m]
    Scalar rear_right_thigh;  ///< works with the rate of rear_right_thigh [N m]
    Scalar rear_right_knee;  ///< works with the rate of rear_right_knee [N m]
    static constexpr int size = 18;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::trunk_x, &GeneralizedForces::trunk_y,
          &GeneralizedForces::trunk_z, &GeneralizedForces::trunk_attitude_omega_x,
          &GeneralizedForces::trunk_attitude_omega_y, &GeneralizedForces::trunk_attitude_omega_z,
          &GeneralizedForces::front_left_hip, &GeneralizedForces::front_left_thigh, &GeneralizedForces::front_left_knee,
          &GeneralizedForces::front_right_hip, &GeneralizedForces::front_right_thigh,
          &GeneralizedForces::front_right_knee, &GeneralizedForces::rear_left_hip, &GeneralizedForces::rear_left_thigh,
          &GeneralizedForces::rear_left_knee, &GeneralizedForces::rear_right_hip, &GeneralizedForces::rear_right_thigh,
          &GeneralizedForces::rear_right_knee};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar front_left_hip_torque;  ///< motor [N m]
    Scalar front_left_thigh_torque;  ///< motor [N m]
    Scalar front_left_knee_torque;  ///< motor [N m]
    Scalar front_right_hip_torque;  ///< motor [N m]
    Scalar front_right_thigh_torque;  ///< motor [N m]
    Scalar front_right_knee_torque;  ///< motor [N m]
    Scalar rear_left_hip_torque;  ///< motor [N m]
    Scalar rear_left_thigh_torque;  ///< motor [N m]
    Scalar rear_left_knee_torque;  ///< motor [N m]
    Scalar rear_right_hip_torque;  ///< motor [N m]
    Scalar rear_right_thigh_torque;  ///< motor [N m]
    Scalar rear_right_knee_torque;  ///< motor [N m]
    static constexpr int size = 12;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::front_left_hip_torque, &Inputs::front_left_thigh_torque,
          &Inputs::front_left_knee_torque, &Inputs::front_right_hip_torque, &Inputs::front_right_thigh_torque,
          &Inputs::front_right_knee_torque, &Inputs::rear_left_hip_torque, &Inputs::rear_left_thigh_torque,
          &Inputs::rear_left_knee_torque, &Inputs::rear_right_hip_torque, &Inputs::rear_right_thigh_torque,
          &Inputs::rear_right_knee_torque};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    static constexpr int size = 0;
  };

  /// Time [s], coordinates and velocities.
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
  };

  /// Parameters and what depends on them only: built once for each set of parameters.
  struct Precomputed {
    Parameters parameters;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n1_4 = traits::constant(1.4, 1.4f, "7/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    state.time = n0;
    state.q.trunk_x = n0;
    state.q.trunk_y = n0;
    state.q.trunk_z = n0_8;
    state.q.trunk_attitude_w = n1;
    state.q.trunk_attitude_x = n0;
    state.q.trunk_attitude_y = n0;
    state.q.trunk_attitude_z = n0;
    state.q.front_left_hip = n0;
    state.q.front_left_thigh = n0_7;
    state.q.front_left_knee = -n1_4;
    state.q.front_right_hip = n0;
    state.q.front_right_thigh = n0_7;
    state.q.front_right_knee = -n1_4;
    state.q.rear_left_hip = n0;
    state.q.rear_left_thigh = n0_7;
    state.q.rear_left_knee = -n1_4;
    state.q.rear_right_hip = n0;
    state.q.rear_right_thigh = n0_7;
    state.q.rear_right_knee = -n1_4;
    state.v.trunk_x = n0_5;
    state.v.trunk_y = n0;
    state.v.trunk_z = n0;
    state.v.trunk_attitude_omega_x = n0_3;
    state.v.trunk_attitude_omega_y = -n0_5;
    state.v.trunk_attitude_omega_z = n0;
    state.v.front_left_hip = n0;
    state.v.front_left_thigh = n0;
    state.v.front_left_knee = n0;
    state.v.front_right_hip = n0;
    state.v.front_right_thigh = n0;
    state.v.front_right_knee = n0;
    state.v.rear_left_hip = n0;
    state.v.rear_left_thigh = n0;
    state.v.rear_left_knee = n0;
    state.v.rear_right_hip = n0;
    state.v.rear_right_thigh = n0;
    state.v.rear_right_knee = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> trunk_position;  ///< centre of mass of trunk [m]
    std::array<Scalar, 9> trunk_rotation;  ///< from the axes of trunk to the ground's (3 x 3)
    std::array<Scalar, 3> trunk_velocity;  ///< velocity of the centre of mass of trunk [m/s]
    std::array<Scalar, 3> trunk_angular_velocity;  ///< angular velocity of trunk [rad/s]
    std::array<Scalar, 3> front_left_hip_link_position;  ///< centre of mass of front_left_hip_link [m]
    std::array<Scalar, 9> front_left_hip_link_rotation;  ///< from the axes of front_left_hip_link to the ground's (3 x 3)
    std::array<Scalar, 3> front_left_hip_link_velocity;  ///< velocity of the centre of mass of front_left_hip_link [m/s]
    std::array<Scalar, 3> front_left_hip_link_angular_velocity;  ///< angular velocity of front_left_hip_link [rad/s]
    std::array<Scalar, 3> front_left_thigh_link_position;  ///< centre of mass of front_left_thigh_link [m]
    std::array<Scalar, 9> front_left_thigh_link_rotation;  ///< from the axes of front_left_thigh_link to the ground's (3 x 3)
    std::array<Scalar, 3> front_left_thigh_link_velocity;  ///< velocity of the centre of mass of front_left_thigh_link [m/s]
    std::array<Scalar, 3> front_left_thigh_link_angular_velocity;  ///< angular velocity of front_left_thigh_link [rad/s]
    std::array<Scalar, 3> front_left_shank_link_position;  ///< centre of mass of front_left_shank_link [m]
    std::array<Scalar, 9> front_left_shank_link_rotation;  ///< from the axes of front_left_shank_link to the ground's (3 x 3)
    std::array<Scalar, 3> front_left_shank_link_velocity;  ///< velocity of the centre of mass of front_left_shank_link [m/s]
    std::array<Scalar, 3> front_left_shank_link_angular_velocity;  ///< angular velocity of front_left_shank_link [rad/s]
    std::array<Scalar, 3> front_left_foot_position;  ///< centre of mass of front_left_foot [m]
    std::array<Scalar, 9> front_left_foot_rotation;  ///< from the axes of front_left_foot to the ground's (3 x 3)
    std::array<Scalar, 3> front_left_foot_velocity;  ///< velocity of the centre of mass of front_left_foot [m/s]
    std::array<Scalar, 3> front_left_foot_angular_velocity;  ///< angular velocity of front_left_foot [rad/s]
    std::array<Scalar, 3> front_right_hip_link_position;  ///< centre of mass of front_right_hip_link [m]
    std::array<Scalar, 9> front_right_hip_link_rotation;  ///< from the axes of front_right_hip_link to the ground's (3 x 3)
    std::array<Scalar, 3> front_right_hip_link_velocity;  ///< velocity of the centre of mass of front_right_hip_link [m/s]
    std::array<Scalar, 3> front_right_hip_link_angular_velocity;  ///< angular velocity of front_right_hip_link [rad/s]
    std::array<Scalar, 3> front_right_thigh_link_position;  ///< centre of mass of front_right_thigh_link [m]
    std::array<Scalar, 9> front_right_thigh_link_rotation;  ///< from the axes of front_right_thigh_link to the ground's (3 x 3)
    std::array<Scalar, 3> front_right_thigh_link_velocity;  ///< velocity of the centre of mass of front_right_thigh_link [m/s]
    std::array<Scalar, 3> front_right_thigh_link_angular_velocity;  ///< angular velocity of front_right_thigh_link [rad/s]
    std::array<Scalar, 3> front_right_shank_link_position;  ///< centre of mass of front_right_shank_link [m]
    std::array<Scalar, 9> front_right_shank_link_rotation;  ///< from the axes of front_right_shank_link to the ground's (3 x 3)
    std::array<Scalar, 3> front_right_shank_link_velocity;  ///< velocity of the centre of mass of front_right_shank_link [m/s]
    std::array<Scalar, 3> front_right_shank_link_angular_velocity;  ///< angular velocity of front_right_shank_link [rad/s]
    std::array<Scalar, 3> front_right_foot_position;  ///< centre of mass of front_right_foot [m]
    std::array<Scalar, 9> front_right_foot_rotation;  ///< from the axes of front_right_foot to the ground's (3 x 3)
    std::array<Scalar, 3> front_right_foot_velocity;  ///< velocity of the centre of mass of front_right_foot [m/s]
    std::array<Scalar, 3> front_right_foot_angular_velocity;  ///< angular velocity of front_right_foot [rad/s]
    std::array<Scalar, 3> rear_left_hip_link_position;  ///< centre of mass of rear_left_hip_link [m]
    std::array<Scalar, 9> rear_left_hip_link_rotation;  ///< from the axes of rear_left_hip_link to the ground's (3 x 3)
    std::array<Scalar, 3> rear_left_hip_link_velocity;  ///< velocity of the centre of mass of rear_left_hip_link [m/s]
    std::array<Scalar, 3> rear_left_hip_link_angular_velocity;  ///< angular velocity of rear_left_hip_link [rad/s]
    std::array<Scalar, 3> rear_left_thigh_link_position;  ///< centre of mass of rear_left_thigh_link [m]
    std::array<Scalar, 9> rear_left_thigh_link_rotation;  ///< from the axes of rear_left_thigh_link to the ground's (3 x 3)
    std::array<Scalar, 3> rear_left_thigh_link_velocity;  ///< velocity of the centre of mass of rear_left_thigh_link [m/s]
    std::array<Scalar, 3> rear_left_thigh_link_angular_velocity;  ///< angular velocity of rear_left_thigh_link [rad/s]
    std::array<Scalar, 3> rear_left_shank_link_position;  ///< centre of mass of rear_left_shank_link [m]
    std::array<Scalar, 9> rear_left_shank_link_rotation;  ///< from the axes of rear_left_shank_link to the ground's (3 x 3)
    std::array<Scalar, 3> rear_left_shank_link_velocity;  ///< velocity of the centre of mass of rear_left_shank_link [m/s]
    std::array<Scalar, 3> rear_left_shank_link_angular_velocity;  ///< angular velocity of rear_left_shank_link [rad/s]
    std::array<Scalar, 3> rear_left_foot_position;  ///< centre of mass of rear_left_foot [m]
    std::array<Scalar, 9> rear_left_foot_rotation;  ///< from the axes of rear_left_foot to the ground's (3 x 3)
    std::array<Scalar, 3> rear_left_foot_velocity;  ///< velocity of the centre of mass of rear_left_foot [m/s]
    std::array<Scalar, 3> rear_left_foot_angular_velocity;  ///< angular velocity of rear_left_foot [rad/s]
    std::array<Scalar, 3> rear_right_hip_link_position;  ///< centre of mass of rear_right_hip_link [m]
    std::array<Scalar, 9> rear_right_hip_link_rotation;  ///< from the axes of rear_right_hip_link to the ground's (3 x 3)
    std::array<Scalar, 3> rear_right_hip_link_velocity;  ///< velocity of the centre of mass of rear_right_hip_link [m/s]
    std::array<Scalar, 3> rear_right_hip_link_angular_velocity;  ///< angular velocity of rear_right_hip_link [rad/s]
    std::array<Scalar, 3> rear_right_thigh_link_position;  ///< centre of mass of rear_right_thigh_link [m]
    std::array<Scalar, 9> rear_right_thigh_link_rotation;  ///< from the axes of rear_right_thigh_link to the ground's (3 x 3)
    std::array<Scalar, 3> rear_right_thigh_link_velocity;  ///< velocity of the centre of mass of rear_right_thigh_link [m/s]
    std::array<Scalar, 3> rear_right_thigh_link_angular_velocity;  ///< angular velocity of rear_right_thigh_link [rad/s]
    std::array<Scalar, 3> rear_right_shank_link_position;  ///< centre of mass of rear_right_shank_link [m]
    std::array<Scalar, 9> rear_right_shank_link_rotation;  ///< from the axes of rear_right_shank_link to the ground's (3 x 3)
    std::array<Scalar, 3> rear_right_shank_link_velocity;  ///< velocity of the centre of mass of rear_right_shank_link [m/s]
    std::array<Scalar, 3> rear_right_shank_link_angular_velocity;  ///< angular velocity of rear_right_shank_link [rad/s]
    std::array<Scalar, 3> rear_right_foot_position;  ///< centre of mass of rear_right_foot [m]
    std::array<Scalar, 9> rear_right_foot_rotation;  ///< from the axes of rear_right_foot to the ground's (3 x 3)
    std::array<Scalar, 3> rear_right_foot_velocity;  ///< velocity of the centre of mass of rear_right_foot [m/s]
    std::array<Scalar, 3> rear_right_foot_angular_velocity;  ///< angular velocity of rear_right_foot [rad/s]
    std::array<Scalar, 3> front_left_foot_origin_position;  ///< position of front_left_foot_origin [m]
    std::array<Scalar, 3> front_left_foot_origin_velocity;  ///< velocity of the material point at front_left_foot_origin [m/s]
    std::array<Scalar, 54> front_left_foot_origin_jacobian;  ///< partial velocities of front_left_foot_origin (3 x 18)
    std::array<Scalar, 3> front_right_foot_origin_position;  ///< position of front_right_foot_origin [m]
    std::array<Scalar, 3> front_right_foot_origin_velocity;  ///< velocity of the material point at front_right_foot_origin [m/s]
    std::array<Scalar, 54> front_right_foot_origin_jacobian;  ///< partial velocities of front_right_foot_origin (3 x 18)
    std::array<Scalar, 3> rear_left_foot_origin_position;  ///< position of rear_left_foot_origin [m]
    std::array<Scalar, 3> rear_left_foot_origin_velocity;  ///< velocity of the material point at rear_left_foot_origin [m/s]
    std::array<Scalar, 54> rear_left_foot_origin_jacobian;  ///< partial velocities of rear_left_foot_origin (3 x 18)
    std::array<Scalar, 3> rear_right_foot_origin_position;  ///< position of rear_right_foot_origin [m]
    std::array<Scalar, 3> rear_right_foot_origin_velocity;  ///< velocity of the material point at rear_right_foot_origin [m/s]
    std::array<Scalar, 54> rear_right_foot_origin_jacobian;  ///< partial velocities of rear_right_foot_origin (3 x 18)
  };

  /// Energies of the mechanism.
  struct Energy {
    Scalar kinetic;  ///< kinetic energy T [J]
    Scalar force_function;  ///< force function U of gravity and springs [J]
    Scalar power;  ///< power of dampers, given forces and motors [W]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Energy::*member_(int i_) noexcept {
      constexpr Scalar Energy::*members_[] = {&Energy::kinetic, &Energy::force_function, &Energy::power};
      return members_[i_];
    }
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 19>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_trunk_x = state.v.trunk_x;
    const Scalar v_trunk_y = state.v.trunk_y;
    const Scalar v_trunk_z = state.v.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar z3662 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_y + q_trunk_attitude_z
        * v_trunk_attitude_omega_z + q_trunk_attitude_x * v_trunk_attitude_omega_x);
    const Scalar z3663 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_z - q_trunk_attitude_z
        * v_trunk_attitude_omega_y + q_trunk_attitude_w * v_trunk_attitude_omega_x);
    const Scalar z3664 = n0_5 * (q_trunk_attitude_z * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_z + q_trunk_attitude_w * v_trunk_attitude_omega_y);
    const Scalar z3665 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_y - q_trunk_attitude_w * v_trunk_attitude_omega_z);
    rates[0] = v_trunk_x;
    rates[1] = v_trunk_y;
    rates[2] = v_trunk_z;
    rates[3] = -z3662;
    rates[4] = z3663;
    rates[5] = z3664;
    rates[6] = -z3665;
    rates[7] = v_front_left_hip;
    rates[8] = v_front_left_thigh;
    rates[9] = v_front_left_knee;
    rates[10] = v_front_right_hip;
    rates[11] = v_front_right_thigh;
    rates[12] = v_front_right_knee;
    rates[13] = v_rear_left_hip;
    rates[14] = v_rear_left_thigh;
    rates[15] = v_rear_left_knee;
    rates[16] = v_rear_right_hip;
    rates[17] = v_rear_right_thigh;
    rates[18] = v_rear_right_knee;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n0_09 = traits::constant(0.09, 0.09f, "9/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_trunk_x = state.q.trunk_x;
    const Scalar v_trunk_x = state.v.trunk_x;
    const Scalar q_trunk_y = state.q.trunk_y;
    const Scalar v_trunk_y = state.v.trunk_y;
    const Scalar q_trunk_z = state.q.trunk_z;
    const Scalar v_trunk_z = state.v.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar z270 = q_front_left_thigh + q_front_left_knee;
    const Scalar z403 = q_front_right_thigh + q_front_right_knee;
    const Scalar z536 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z669 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z270, z403, z536, z669};
    Scalar sines_[16], cosines_[16];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z271 = sines_[12], z272 = cosines_[12];
    const Scalar z404 = sines_[13], z405 = cosines_[13];
    const Scalar z537 = sines_[14], z538 = cosines_[14];
    const Scalar z670 = sines_[15], z671 = cosines_[15];
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z97 = v_trunk_x * z17 + v_trunk_y * z19 + v_trunk_z * z29;
    const Scalar z98 = v_trunk_x * z18 + v_trunk_y * z23 + v_trunk_z * z25;
    const Scalar z99 = v_trunk_x * z30 + v_trunk_y * z24 + v_trunk_z * z28;
    const Scalar z100 = n0_05 * v_trunk_attitude_omega_z - z97;
    const Scalar z101 = n0_2 * v_trunk_attitude_omega_z + z98;
    const Scalar z102 = n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y + z99;
    const Scalar z103 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z104 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z105 = s_front_left_hip * z102 + c_front_left_hip * z101;
    const Scalar z106 = s_front_left_hip * z101 - c_front_left_hip * z102;
    const Scalar z107 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z108 = z100 - n0_08 * z104;
    const Scalar z109 = z106 - n0_08 * z107;
    const Scalar z110 = s_front_left_thigh * z104 + c_front_left_thigh * z107;
    const Scalar z111 = s_front_left_thigh * z107 - c_front_left_thigh * z104;
    const Scalar z112 = s_front_left_thigh * z109 - c_front_left_thigh * z108;
    const Scalar z113 = s_front_left_thigh * z108 + c_front_left_thigh * z109;
    const Scalar z114 = v_front_left_thigh + z103;  // angular velocity of front_left_thigh_link, y
    const Scalar z115 = z112 - n0_2 * z114;
    const Scalar z116 = z105 + n0_2 * z110;
    const Scalar z117 = s_front_left_knee * z111 - c_front_left_knee * z110;
    const Scalar z118 = s_front_left_knee * z110 + c_front_left_knee * z111;
    const Scalar z119 = s_front_left_knee * z113 + c_front_left_knee * z115;
    const Scalar z120 = s_front_left_knee * z115 - c_front_left_knee * z113;
    const Scalar z121 = v_front_left_knee + z114;  // angular velocity of front_left_shank_link, y
    const Scalar z122 = n0_05 * v_trunk_attitude_omega_z + z97;
    const Scalar z123 = n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y - z99;
    const Scalar z124 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z125 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z126 = s_front_right_hip * z123 - c_front_right_hip * z101;
    const Scalar z127 = s_front_right_hip * z101 + c_front_right_hip * z123;
    const Scalar z128 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z129 = z122 - n0_08 * z125;
    const Scalar z130 = z127 + n0_08 * z128;
    const Scalar z131 = s_front_right_thigh * z125 + c_front_right_thigh * z128;
    const Scalar z132 = s_front_right_thigh * z128 - c_front_right_thigh * z125;
    const Scalar z133 = s_front_right_thigh * z130 + c_front_right_thigh * z129;
    const Scalar z134 = s_front_right_thigh * z129 - c_front_right_thigh * z130;
    const Scalar z135 = v_front_right_thigh + z124;  // angular velocity of front_right_thigh_link, y
    const Scalar z136 = z133 - n0_2 * z135;
    const Scalar z137 = z126 - n0_2 * z131;
    const Scalar z138 = s_front_right_knee * z132 - c_front_right_knee * z131;
    const Scalar z139 = s_front_right_knee * z131 + c_front_right_knee * z132;
    const Scalar z140 = s_front_right_knee * z134 - c_front_right_knee * z136;
    const Scalar z141 = s_front_right_knee * z136 + c_front_right_knee * z134;
    const Scalar z142 = v_front_right_knee + z135;  // angular velocity of front_right_shank_link, y
    const Scalar z143 = n0_2 * v_trunk_attitude_omega_z - z98;
    const Scalar z144 = n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y + z99;
    const Scalar z145 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z146 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z147 = s_rear_left_hip * z144 - c_rear_left_hip * z143;
    const Scalar z148 = s_rear_left_hip * z143 + c_rear_left_hip * z144;
    const Scalar z149 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z150 = z100 - n0_08 * z146;
    const Scalar z151 = z148 + n0_08 * z149;
    const Scalar z152 = s_rear_left_thigh * z146 + c_rear_left_thigh * z149;
    const Scalar z153 = s_rear_left_thigh * z149 - c_rear_left_thigh * z146;
    const Scalar z154 = s_rear_left_thigh * z151 + c_rear_left_thigh * z150;
    const Scalar z155 = s_rear_left_thigh * z150 - c_rear_left_thigh * z151;
    const Scalar z156 = v_rear_left_thigh + z145;  // angular velocity of rear_left_thigh_link, y
    const Scalar z157 = z154 + n0_2 * z156;
    const Scalar z158 = z147 + n0_2 * z152;
    const Scalar z159 = s_rear_left_knee * z153 - c_rear_left_knee * z152;
    const Scalar z160 = s_rear_left_knee * z152 + c_rear_left_knee * z153;
    const Scalar z161 = s_rear_left_knee * z155 - c_rear_left_knee * z157;
    const Scalar z162 = s_rear_left_knee * z157 + c_rear_left_knee * z155;
    const Scalar z163 = v_rear_left_knee + z156;  // angular velocity of rear_left_shank_link, y
    const Scalar z164 = n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y - z99;
    const Scalar z165 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z166 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z167 = s_rear_right_hip * z164 + c_rear_right_hip * z143;
    const Scalar z168 = s_rear_right_hip * z143 - c_rear_right_hip * z164;
    const Scalar z169 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z170 = z122 - n0_08 * z166;
    const Scalar z171 = z168 - n0_08 * z169;
    const Scalar z172 = s_rear_right_thigh * z166 + c_rear_right_thigh * z169;
    const Scalar z173 = s_rear_right_thigh * z169 - c_rear_right_thigh * z166;
    const Scalar z174 = s_rear_right_thigh * z171 - c_rear_right_thigh * z170;
    const Scalar z175 = s_rear_right_thigh * z170 + c_rear_right_thigh * z171;
    const Scalar z176 = v_rear_right_thigh + z165;  // angular velocity of rear_right_thigh_link, y
    const Scalar z177 = z174 + n0_2 * z176;
    const Scalar z178 = z167 - n0_2 * z172;
    const Scalar z179 = s_rear_right_knee * z173 - c_rear_right_knee * z172;
    const Scalar z180 = s_rear_right_knee * z172 + c_rear_right_knee * z173;
    const Scalar z181 = s_rear_right_knee * z175 + c_rear_right_knee * z177;
    const Scalar z182 = s_rear_right_knee * z177 - c_rear_right_knee * z175;
    const Scalar z183 = v_rear_right_knee + z176;  // angular velocity of rear_right_shank_link, y
    const Scalar z184 = z17 * z97 + z18 * z98 + z30 * z99;
    const Scalar z185 = z19 * z97 + z23 * z98 + z24 * z99;
    const Scalar z186 = z25 * z98 + z28 * z99 + z29 * z97;
    const Scalar z187 = z17 * v_trunk_attitude_omega_x + z18 * v_trunk_attitude_omega_y + z30
        * v_trunk_attitude_omega_z;
    const Scalar z188 = z19 * v_trunk_attitude_omega_x + z23 * v_trunk_attitude_omega_y + z24
        * v_trunk_attitude_omega_z;
    const Scalar z189 = z25 * v_trunk_attitude_omega_y + z28 * v_trunk_attitude_omega_z + z29
        * v_trunk_attitude_omega_x;
    const Scalar z190 = n0_04 * c_front_left_hip;
    const Scalar z191 = n0_04 * s_front_left_hip;
    const Scalar z192 = n0_05 + z190;
    const Scalar z193 = n0_2 * z17 + z18 * z192 + z30 * z191;
    const Scalar z194 = n0_2 * z19 + z23 * z192 + z24 * z191;
    const Scalar z195 = z25 * z192 + z28 * z191 + n0_2 * z29;
    const Scalar z196 = q_trunk_z + z195;
    const Scalar z197 = q_trunk_y + z194;
    const Scalar z198 = q_trunk_x + z193;
    const Scalar z199 = z18 * c_front_left_hip + z30 * s_front_left_hip;
    const Scalar z200 = z23 * c_front_left_hip + z24 * s_front_left_hip;
    const Scalar z201 = z25 * c_front_left_hip + z28 * s_front_left_hip;
    const Scalar z202 = z18 * s_front_left_hip - z30 * c_front_left_hip;
    const Scalar z203 = z23 * s_front_left_hip - z24 * c_front_left_hip;
    const Scalar z204 = z25 * s_front_left_hip - z28 * c_front_left_hip;
    const Scalar z205 = z100 - n0_04 * z104;
    const Scalar z206 = z106 - n0_04 * z107;
    const Scalar z207 = s_front_left_hip * z206 + c_front_left_hip * z105;
    const Scalar z208 = s_front_left_hip * z105 - c_front_left_hip * z206;
    const Scalar z209 = z17 * z205 - z18 * z207 - z30 * z208;
    const Scalar z210 = z19 * z205 - z23 * z207 - z24 * z208;
    const Scalar z211 = z25 * z207 + z28 * z208 - z29 * z205;
    const Scalar z212 = s_front_left_hip * z104 + c_front_left_hip * z103;
    const Scalar z213 = s_front_left_hip * z103 - c_front_left_hip * z104;
    const Scalar z214 = z17 * z107 + z18 * z212 + z30 * z213;
    const Scalar z215 = z19 * z107 + z23 * z212 + z24 * z213;
    const Scalar z216 = z25 * z212 + z28 * z213 + z29 * z107;
    const Scalar z217 = n0_09 * s_front_left_thigh;
    const Scalar z218 = n0_09 * c_front_left_thigh;
    const Scalar z219 = s_front_left_hip * z218 + n0_08 * c_front_left_hip;
    const Scalar z220 = n0_08 * s_front_left_hip - c_front_left_hip * z218;
    const Scalar z221 = n0_2 - z217;
    const Scalar z222 = n0_05 + z219;
    const Scalar z223 = z17 * z221 + z18 * z222 + z30 * z220;
    const Scalar z224 = z19 * z221 + z23 * z222 + z24 * z220;
    const Scalar z225 = z25 * z222 + z28 * z220 + z29 * z221;
    const Scalar z226 = q_trunk_z + z225;
    const Scalar z227 = q_trunk_y + z224;
    const Scalar z228 = q_trunk_x + z223;
    const Scalar z229 = s_front_left_hip * s_front_left_thigh;
    const Scalar z230 = c_front_left_hip * s_front_left_thigh;
    const Scalar z231 = z17 * c_front_left_thigh + z18 * z229 - z30 * z230;
    const Scalar z232 = z19 * c_front_left_thigh + z23 * z229 - z24 * z230;
    const Scalar z233 = z25 * z229 - z28 * z230 + z29 * c_front_left_thigh;
    const Scalar z234 = s_front_left_hip * c_front_left_thigh;
    const Scalar z235 = c_front_left_hip * c_front_left_thigh;
    const Scalar z236 = z17 * s_front_left_thigh - z18 * z234 + z30 * z235;
    const Scalar z237 = z19 * s_front_left_thigh - z23 * z234 + z24 * z235;
    const Scalar z238 = z25 * z234 - z28 * z235 - z29 * s_front_left_thigh;
    const Scalar z239 = z112 - n0_09 * z114;
    const Scalar z240 = z105 + n0_09 * z110;
    const Scalar z241 = s_front_left_thigh * z113 - c_front_left_thigh * z239;
    const Scalar z242 = s_front_left_thigh * z239 + c_front_left_thigh * z113;
    const Scalar z243 = s_front_left_hip * z242 + c_front_left_hip * z240;
    const Scalar z244 = s_front_left_hip * z240 - c_front_left_hip * z242;
    const Scalar z245 = z17 * z241 - z18 * z243 - z30 * z244;
    const Scalar z246 = z19 * z241 - z23 * z243 - z24 * z244;
    const Scalar z247 = z25 * z243 + z28 * z244 - z29 * z241;
    const Scalar z248 = s_front_left_thigh * z111 + c_front_left_thigh * z110;
    const Scalar z249 = s_front_left_thigh * z110 - c_front_left_thigh * z111;
    const Scalar z250 = s_front_left_hip * z249 + c_front_left_hip * z114;
    const Scalar z251 = s_front_left_hip * z114 - c_front_left_hip * z249;
    const Scalar z252 = z17 * z248 + z18 * z250 + z30 * z251;
    const Scalar z253 = z19 * z248 + z23 * z250 + z24 * z251;
    const Scalar z254 = z25 * z250 + z28 * z251 + z29 * z248;
    const Scalar z255 = n0_1 * s_front_left_knee;
    const Scalar z256 = n0_1 * c_front_left_knee;
    const Scalar z257 = n0_2 + z256;
    const Scalar z258 = s_front_left_thigh * z257 + c_front_left_thigh * z255;
    const Scalar z259 = s_front_left_thigh * z255 - c_front_left_thigh * z257;
    const Scalar z260 = s_front_left_hip * z259 - n0_08 * c_front_left_hip;
    const Scalar z261 = n0_08 * s_front_left_hip + c_front_left_hip * z259;
    const Scalar z262 = n0_2 - z258;
    const Scalar z263 = n0_05 - z260;
    const Scalar z264 = z17 * z262 + z18 * z263 + z30 * z261;
    const Scalar z265 = z19 * z262 + z23 * z263 + z24 * z261;
    const Scalar z266 = z25 * z263 + z28 * z261 + z29 * z262;
    const Scalar z267 = q_trunk_z + z266;
    const Scalar z268 = q_trunk_y + z265;
    const Scalar z269 = q_trunk_x + z264;
    const Scalar z273 = s_front_left_hip * z271;
    const Scalar z274 = c_front_left_hip * z271;
    const Scalar z275 = z17 * z272 + z18 * z273 - z30 * z274;
    const Scalar z276 = z19 * z272 + z23 * z273 - z24 * z274;
    const Scalar z277 = z25 * z273 - z28 * z274 + z29 * z272;
    const Scalar z278 = s_front_left_hip * z272;
    const Scalar z279 = c_front_left_hip * z272;
    const Scalar z280 = z17 * z271 - z18 * z278 + z30 * z279;
    const Scalar z281 = z19 * z271 - z23 * z278 + z24 * z279;
    const Scalar z282 = z25 * z278 - z28 * z279 - z29 * z271;
    const Scalar z283 = z119 - n0_1 * z121;
    const Scalar z284 = z116 - n0_1 * z117;
    const Scalar z285 = z120 * z271 + z272 * z283;
    const Scalar z286 = z120 * z272 - z271 * z283;
    const Scalar z287 = s_front_left_hip * z286 - c_front_left_hip * z284;
    const Scalar z288 = s_front_left_hip * z284 + c_front_left_hip * z286;
    const Scalar z289 = z17 * z285 - z18 * z287 + z30 * z288;
    const Scalar z290 = z19 * z285 - z23 * z287 + z24 * z288;
    const Scalar z291 = z25 * z287 - z28 * z288 - z29 * z285;
    const Scalar z292 = z117 * z272 - z118 * z271;
    const Scalar z293 = z117 * z271 + z118 * z272;
    const Scalar z294 = s_front_left_hip * z293 - c_front_left_hip * z121;
    const Scalar z295 = s_front_left_hip * z121 + c_front_left_hip * z293;
    const Scalar z296 = z17 * z292 + z18 * z294 - z30 * z295;
    const Scalar z297 = z19 * z292 + z23 * z294 - z24 * z295;
    const Scalar z298 = z25 * z294 - z28 * z295 + z29 * z292;
    const Scalar z299 = n0_2 * s_front_left_knee;
    const Scalar z300 = n0_2 * c_front_left_knee;
    const Scalar z301 = n0_2 + z300;
    const Scalar z302 = s_front_left_thigh * z301 + c_front_left_thigh * z299;
    const Scalar z303 = s_front_left_thigh * z299 - c_front_left_thigh * z301;
    const Scalar z304 = s_front_left_hip * z303 - n0_08 * c_front_left_hip;
    const Scalar z305 = n0_08 * s_front_left_hip + c_front_left_hip * z303;
    const Scalar z306 = n0_2 - z302;
    const Scalar z307 = n0_05 - z304;
    const Scalar z308 = z17 * z306 + z18 * z307 + z30 * z305;
    const Scalar z309 = z19 * z306 + z23 * z307 + z24 * z305;
    const Scalar z310 = z25 * z307 + z28 * z305 + z29 * z306;
    const Scalar z311 = q_trunk_z + z310;
    const Scalar z312 = q_trunk_y + z309;
    const Scalar z313 = q_trunk_x + z308;
    const Scalar z314 = z119 - n0_2 * z121;
    const Scalar z315 = z116 - n0_2 * z117;
    const Scalar z316 = z120 * z271 + z272 * z314;
    const Scalar z317 = z120 * z272 - z271 * z314;
    const Scalar z318 = s_front_left_hip * z317 - c_front_left_hip * z315;
    const Scalar z319 = s_front_left_hip * z315 + c_front_left_hip * z317;
    const Scalar z320 = z17 * z316 - z18 * z318 + z30 * z319;
    const Scalar z321 = z19 * z316 - z23 * z318 + z24 * z319;
    const Scalar z322 = z25 * z318 - z28 * z319 - z29 * z316;
    const Scalar z323 = n0_04 * c_front_right_hip;
    const Scalar z324 = n0_04 * s_front_right_hip;
    const Scalar z325 = n0_05 + z323;
    const Scalar z326 = n0_2 * z17 - z18 * z325 - z30 * z324;
    const Scalar z327 = n0_2 * z19 - z23 * z325 - z24 * z324;
    const Scalar z328 = z25 * z325 + z28 * z324 - n0_2 * z29;
    const Scalar z329 = q_trunk_z - z328;
    const Scalar z330 = q_trunk_y + z327;
    const Scalar z331 = q_trunk_x + z326;
    const Scalar z332 = z18 * c_front_right_hip + z30 * s_front_right_hip;
    const Scalar z333 = z23 * c_front_right_hip + z24 * s_front_right_hip;
    const Scalar z334 = z25 * c_front_right_hip + z28 * s_front_right_hip;
    const Scalar z335 = z18 * s_front_right_hip - z30 * c_front_right_hip;
    const Scalar z336 = z23 * s_front_right_hip - z24 * c_front_right_hip;
    const Scalar z337 = z25 * s_front_right_hip - z28 * c_front_right_hip;
    const Scalar z338 = z122 - n0_04 * z125;
    const Scalar z339 = z127 + n0_04 * z128;
    const Scalar z340 = s_front_right_hip * z339 - c_front_right_hip * z126;
    const Scalar z341 = s_front_right_hip * z126 + c_front_right_hip * z339;
    const Scalar z342 = z17 * z338 + z18 * z340 - z30 * z341;
    const Scalar z343 = z19 * z338 + z23 * z340 - z24 * z341;
    const Scalar z344 = z25 * z340 - z28 * z341 + z29 * z338;
    const Scalar z345 = s_front_right_hip * z125 + c_front_right_hip * z124;
    const Scalar z346 = s_front_right_hip * z124 - c_front_right_hip * z125;
    const Scalar z347 = z17 * z128 + z18 * z345 + z30 * z346;
    const Scalar z348 = z19 * z128 + z23 * z345 + z24 * z346;
    const Scalar z349 = z25 * z345 + z28 * z346 + z29 * z128;
    const Scalar z350 = n0_09 * s_front_right_thigh;
    const Scalar z351 = n0_09 * c_front_right_thigh;
    const Scalar z352 = s_front_right_hip * z351 - n0_08 * c_front_right_hip;
    const Scalar z353 = n0_08 * s_front_right_hip + c_front_right_hip * z351;
    const Scalar z354 = n0_2 - z350;
    const Scalar z355 = n0_05 - z352;
    const Scalar z356 = z17 * z354 - z18 * z355 - z30 * z353;
    const Scalar z357 = z19 * z354 - z23 * z355 - z24 * z353;
    const Scalar z358 = z25 * z355 + z28 * z353 - z29 * z354;
    const Scalar z359 = q_trunk_z - z358;
    const Scalar z360 = q_trunk_y + z357;
    const Scalar z361 = q_trunk_x + z356;
    const Scalar z362 = s_front_right_hip * s_front_right_thigh;
    const Scalar z363 = c_front_right_hip * s_front_right_thigh;
    const Scalar z364 = z17 * c_front_right_thigh + z18 * z362 - z30 * z363;
    const Scalar z365 = z19 * c_front_right_thigh + z23 * z362 - z24 * z363;
    const Scalar z366 = z25 * z362 - z28 * z363 + z29 * c_front_right_thigh;
    const Scalar z367 = s_front_right_hip * c_front_right_thigh;
    const Scalar z368 = c_front_right_hip * c_front_right_thigh;
    const Scalar z369 = z17 * s_front_right_thigh - z18 * z367 + z30 * z368;
    const Scalar z370 = z19 * s_front_right_thigh - z23 * z367 + z24 * z368;
    const Scalar z371 = z25 * z367 - z28 * z368 - z29 * s_front_right_thigh;
    const Scalar z372 = z133 - n0_09 * z135;
    const Scalar z373 = z126 - n0_09 * z131;
    const Scalar z374 = s_front_right_thigh * z134 + c_front_right_thigh * z372;
    const Scalar z375 = s_front_right_thigh * z372 - c_front_right_thigh * z134;
    const Scalar z376 = s_front_right_hip * z375 - c_front_right_hip * z373;
    const Scalar z377 = s_front_right_hip * z373 + c_front_right_hip * z375;
    const Scalar z378 = z17 * z374 + z18 * z376 - z30 * z377;
    const Scalar z379 = z19 * z374 + z23 * z376 - z24 * z377;
    const Scalar z380 = z25 * z376 - z28 * z377 + z29 * z374;
    const Scalar z381 = s_front_right_thigh * z132 + c_front_right_thigh * z131;
    const Scalar z382 = s_front_right_thigh * z131 - c_front_right_thigh * z132;
    const Scalar z383 = s_front_right_hip * z382 + c_front_right_hip * z135;
    const Scalar z384 = s_front_right_hip * z135 - c_front_right_hip * z382;
    const Scalar z385 = z17 * z381 + z18 * z383 + z30 * z384;
    const Scalar z386 = z19 * z381 + z23 * z383 + z24 * z384;
    const Scalar z387 = z25 * z383 + z28 * z384 + z29 * z381;
    const Scalar z388 = n0_1 * s_front_right_knee;
    const Scalar z389 = n0_1 * c_front_right_knee;
    const Scalar z390 = n0_2 + z389;
    const Scalar z391 = s_front_right_thigh * z390 + c_front_right_thigh * z388;
    const Scalar z392 = s_front_right_thigh * z388 - c_front_right_thigh * z390;
    const Scalar z393 = s_front_right_hip * z392 + n0_08 * c_front_right_hip;
    const Scalar z394 = n0_08 * s_front_right_hip - c_front_right_hip * z392;
    const Scalar z395 = n0_2 - z391;
    const Scalar z396 = n0_05 + z393;
    const Scalar z397 = z17 * z395 - z18 * z396 - z30 * z394;
    const Scalar z398 = z19 * z395 - z23 * z396 - z24 * z394;
    const Scalar z399 = z25 * z396 + z28 * z394 - z29 * z395;
    const Scalar z400 = q_trunk_z - z399;
    const Scalar z401 = q_trunk_y + z398;
    const Scalar z402 = q_trunk_x + z397;
    const Scalar z406 = s_front_right_hip * z404;
    const Scalar z407 = c_front_right_hip * z404;
    const Scalar z408 = z17 * z405 + z18 * z406 - z30 * z407;
    const Scalar z409 = z19 * z405 + z23 * z406 - z24 * z407;
    const Scalar z410 = z25 * z406 - z28 * z407 + z29 * z405;
    const Scalar z411 = s_front_right_hip * z405;
    const Scalar z412 = c_front_right_hip * z405;
    const Scalar z413 = z17 * z404 - z18 * z411 + z30 * z412;
    const Scalar z414 = z19 * z404 - z23 * z411 + z24 * z412;
    const Scalar z415 = z25 * z411 - z28 * z412 - z29 * z404;
    const Scalar z416 = z140 + n0_1 * z142;
    const Scalar z417 = z137 + n0_1 * z138;
    const Scalar z418 = z141 * z404 - z405 * z416;
    const Scalar z419 = z141 * z405 + z404 * z416;
    const Scalar z420 = s_front_right_hip * z419 + c_front_right_hip * z417;
    const Scalar z421 = s_front_right_hip * z417 - c_front_right_hip * z419;
    const Scalar z422 = z17 * z418 - z18 * z420 - z30 * z421;
    const Scalar z423 = z19 * z418 - z23 * z420 - z24 * z421;
    const Scalar z424 = z25 * z420 + z28 * z421 - z29 * z418;
    const Scalar z425 = z138 * z405 - z139 * z404;
    const Scalar z426 = z138 * z404 + z139 * z405;
    const Scalar z427 = s_front_right_hip * z426 - c_front_right_hip * z142;
    const Scalar z428 = s_front_right_hip * z142 + c_front_right_hip * z426;
    const Scalar z429 = z17 * z425 + z18 * z427 - z30 * z428;
    const Scalar z430 = z19 * z425 + z23 * z427 - z24 * z428;
    const Scalar z431 = z25 * z427 - z28 * z428 + z29 * z425;
    const Scalar z432 = n0_2 * s_front_right_knee;
    const Scalar z433 = n0_2 * c_front_right_knee;
    const Scalar z434 = n0_2 + z433;
    const Scalar z435 = s_front_right_thigh * z434 + c_front_right_thigh * z432;
    const Scalar z436 = s_front_right_thigh * z432 - c_front_right_thigh * z434;
    const Scalar z437 = s_front_right_hip * z436 + n0_08 * c_front_right_hip;
    const Scalar z438 = n0_08 * s_front_right_hip - c_front_right_hip * z436;
    const Scalar z439 = n0_2 - z435;
    const Scalar z440 = n0_05 + z437;
    const Scalar z441 = z17 * z439 - z18 * z440 - z30 * z438;
    const Scalar z442 = z19 * z439 - z23 * z440 - z24 * z438;
    const Scalar z443 = z25 * z440 + z28 * z438 - z29 * z439;
    const Scalar z444 = q_trunk_z - z443;
    const Scalar z445 = q_trunk_y + z442;
    const Scalar z446 = q_trunk_x + z441;
    const Scalar z447 = z140 + n0_2 * z142;
    const Scalar z448 = z137 + n0_2 * z138;
    const Scalar z449 = z141 * z404 - z405 * z447;
    const Scalar z450 = z141 * z405 + z404 * z447;
    const Scalar z451 = s_front_right_hip * z450 + c_front_right_hip * z448;
    const Scalar z452 = s_front_right_hip * z448 - c_front_right_hip * z450;
    const Scalar z453 = z17 * z449 - z18 * z451 - z30 * z452;
    const Scalar z454 = z19 * z449 - z23 * z451 - z24 * z452;
    const Scalar z455 = z25 * z451 + z28 * z452 - z29 * z449;
    const Scalar z456 = n0_04 * c_rear_left_hip;
    const Scalar z457 = n0_04 * s_rear_left_hip;
    const Scalar z458 = n0_05 + z456;
    const Scalar z459 = n0_2 * z17 - z18 * z458 - z30 * z457;
    const Scalar z460 = n0_2 * z19 - z23 * z458 - z24 * z457;
    const Scalar z461 = z25 * z458 + z28 * z457 - n0_2 * z29;
    const Scalar z462 = q_trunk_z + z461;
    const Scalar z463 = q_trunk_y - z460;
    const Scalar z464 = q_trunk_x - z459;
    const Scalar z465 = z18 * c_rear_left_hip + z30 * s_rear_left_hip;
    const Scalar z466 = z23 * c_rear_left_hip + z24 * s_rear_left_hip;
    const Scalar z467 = z25 * c_rear_left_hip + z28 * s_rear_left_hip;
    const Scalar z468 = z18 * s_rear_left_hip - z30 * c_rear_left_hip;
    const Scalar z469 = z23 * s_rear_left_hip - z24 * c_rear_left_hip;
    const Scalar z470 = z25 * s_rear_left_hip - z28 * c_rear_left_hip;
    const Scalar z471 = z100 - n0_04 * z146;
    const Scalar z472 = z148 + n0_04 * z149;
    const Scalar z473 = s_rear_left_hip * z472 - c_rear_left_hip * z147;
    const Scalar z474 = s_rear_left_hip * z147 + c_rear_left_hip * z472;
    const Scalar z475 = z17 * z471 + z18 * z473 - z30 * z474;
    const Scalar z476 = z19 * z471 + z23 * z473 - z24 * z474;
    const Scalar z477 = z25 * z473 - z28 * z474 + z29 * z471;
    const Scalar z478 = s_rear_left_hip * z146 + c_rear_left_hip * z145;
    const Scalar z479 = s_rear_left_hip * z145 - c_rear_left_hip * z146;
    const Scalar z480 = z17 * z149 + z18 * z478 + z30 * z479;
    const Scalar z481 = z19 * z149 + z23 * z478 + z24 * z479;
    const Scalar z482 = z25 * z478 + z28 * z479 + z29 * z149;
    const Scalar z483 = n0_09 * s_rear_left_thigh;
    const Scalar z484 = n0_09 * c_rear_left_thigh;
    const Scalar z485 = s_rear_left_hip * z484 + n0_08 * c_rear_left_hip;
    const Scalar z486 = n0_08 * s_rear_left_hip - c_rear_left_hip * z484;
    const Scalar z487 = n0_2 + z483;
    const Scalar z488 = n0_05 + z485;
    const Scalar z489 = z17 * z487 - z18 * z488 - z30 * z486;
    const Scalar z490 = z19 * z487 - z23 * z488 - z24 * z486;
    const Scalar z491 = z25 * z488 + z28 * z486 - z29 * z487;
    const Scalar z492 = q_trunk_z + z491;
    const Scalar z493 = q_trunk_y - z490;
    const Scalar z494 = q_trunk_x - z489;
    const Scalar z495 = s_rear_left_hip * s_rear_left_thigh;
    const Scalar z496 = c_rear_left_hip * s_rear_left_thigh;
    const Scalar z497 = z17 * c_rear_left_thigh + z18 * z495 - z30 * z496;
    const Scalar z498 = z19 * c_rear_left_thigh + z23 * z495 - z24 * z496;
    const Scalar z499 = z25 * z495 - z28 * z496 + z29 * c_rear_left_thigh;
    const Scalar z500 = s_rear_left_hip * c_rear_left_thigh;
    const Scalar z501 = c_rear_left_hip * c_rear_left_thigh;
    const Scalar z502 = z17 * s_rear_left_thigh - z18 * z500 + z30 * z501;
    const Scalar z503 = z19 * s_rear_left_thigh - z23 * z500 + z24 * z501;
    const Scalar z504 = z25 * z500 - z28 * z501 - z29 * s_rear_left_thigh;
    const Scalar z505 = z154 + n0_09 * z156;
    const Scalar z506 = z147 + n0_09 * z152;
    const Scalar z507 = s_rear_left_thigh * z155 + c_rear_left_thigh * z505;
    const Scalar z508 = s_rear_left_thigh * z505 - c_rear_left_thigh * z155;
    const Scalar z509 = s_rear_left_hip * z508 - c_rear_left_hip * z506;
    const Scalar z510 = s_rear_left_hip * z506 + c_rear_left_hip * z508;
    const Scalar z511 = z17 * z507 + z18 * z509 - z30 * z510;
    const Scalar z512 = z19 * z507 + z23 * z509 - z24 * z510;
    const Scalar z513 = z25 * z509 - z28 * z510 + z29 * z507;
    const Scalar z514 = s_rear_left_thigh * z153 + c_rear_left_thigh * z152;
    const Scalar z515 = s_rear_left_thigh * z152 - c_rear_left_thigh * z153;
    const Scalar z516 = s_rear_left_hip * z515 + c_rear_left_hip * z156;
    const Scalar z517 = s_rear_left_hip * z156 - c_rear_left_hip * z515;
    const Scalar z518 = z17 * z514 + z18 * z516 + z30 * z517;
    const Scalar z519 = z19 * z514 + z23 * z516 + z24 * z517;
    const Scalar z520 = z25 * z516 + z28 * z517 + z29 * z514;
    const Scalar z521 = n0_1 * s_rear_left_knee;
    const Scalar z522 = n0_1 * c_rear_left_knee;
    const Scalar z523 = n0_2 + z522;
    const Scalar z524 = s_rear_left_thigh * z523 + c_rear_left_thigh * z521;
    const Scalar z525 = s_rear_left_thigh * z521 - c_rear_left_thigh * z523;
    const Scalar z526 = s_rear_left_hip * z525 - n0_08 * c_rear_left_hip;
    const Scalar z527 = n0_08 * s_rear_left_hip + c_rear_left_hip * z525;
    const Scalar z528 = n0_2 + z524;
    const Scalar z529 = n0_05 - z526;
    const Scalar z530 = z17 * z528 - z18 * z529 - z30 * z527;
    const Scalar z531 = z19 * z528 - z23 * z529 - z24 * z527;
    const Scalar z532 = z25 * z529 + z28 * z527 - z29 * z528;
    const Scalar z533 = q_trunk_z + z532;
    const Scalar z534 = q_trunk_y - z531;
    const Scalar z535 = q_trunk_x - z530;
    const Scalar z539 = s_rear_left_hip * z537;
    const Scalar z540 = c_rear_left_hip * z537;
    const Scalar z541 = z17 * z538 + z18 * z539 - z30 * z540;
    const Scalar z542 = z19 * z538 + z23 * z539 - z24 * z540;
    const Scalar z543 = z25 * z539 - z28 * z540 + z29 * z538;
    const Scalar z544 = s_rear_left_hip * z538;
    const Scalar z545 = c_rear_left_hip * z538;
    const Scalar z546 = z17 * z537 - z18 * z544 + z30 * z545;
    const Scalar z547 = z19 * z537 - z23 * z544 + z24 * z545;
    const Scalar z548 = z25 * z544 - z28 * z545 - z29 * z537;
    const Scalar z549 = z161 - n0_1 * z163;
    const Scalar z550 = z158 - n0_1 * z159;
    const Scalar z551 = z162 * z537 - z538 * z549;
    const Scalar z552 = z162 * z538 + z537 * z549;
    const Scalar z553 = s_rear_left_hip * z552 + c_rear_left_hip * z550;
    const Scalar z554 = s_rear_left_hip * z550 - c_rear_left_hip * z552;
    const Scalar z555 = z17 * z551 - z18 * z553 - z30 * z554;
    const Scalar z556 = z19 * z551 - z23 * z553 - z24 * z554;
    const Scalar z557 = z25 * z553 + z28 * z554 - z29 * z551;
    const Scalar z558 = z159 * z538 - z160 * z537;
    const Scalar z559 = z159 * z537 + z160 * z538;
    const Scalar z560 = s_rear_left_hip * z559 - c_rear_left_hip * z163;
    const Scalar z561 = s_rear_left_hip * z163 + c_rear_left_hip * z559;
    const Scalar z562 = z17 * z558 + z18 * z560 - z30 * z561;
    const Scalar z563 = z19 * z558 + z23 * z560 - z24 * z561;
    const Scalar z564 = z25 * z560 - z28 * z561 + z29 * z558;
    const Scalar z565 = n0_2 * s_rear_left_knee;
    const Scalar z566 = n0_2 * c_rear_left_knee;
    const Scalar z567 = n0_2 + z566;
    const Scalar z568 = s_rear_left_thigh * z567 + c_rear_left_thigh * z565;
    const Scalar z569 = s_rear_left_thigh * z565 - c_rear_left_thigh * z567;
    const Scalar z570 = s_rear_left_hip * z569 - n0_08 * c_rear_left_hip;
    const Scalar z571 = n0_08 * s_rear_left_hip + c_rear_left_hip * z569;
    const Scalar z572 = n0_2 + z568;
    const Scalar z573 = n0_05 - z570;
    const Scalar z574 = z17 * z572 - z18 * z573 - z30 * z571;
    const Scalar z575 = z19 * z572 - z23 * z573 - z24 * z571;
    const Scalar z576 = z25 * z573 + z28 * z571 - z29 * z572;
    const Scalar z577 = q_trunk_z + z576;
    const Scalar z578 = q_trunk_y - z575;
    const Scalar z579 = q_trunk_x - z574;
    const Scalar z580 = z161 - n0_2 * z163;
    const Scalar z581 = z158 - n0_2 * z159;
    const Scalar z582 = z162 * z537 - z538 * z580;
    const Scalar z583 = z162 * z538 + z537 * z580;
    const Scalar z584 = s_rear_left_hip * z583 + c_rear_left_hip * z581;
    const Scalar z585 = s_rear_left_hip * z581 - c_rear_left_hip * z583;
    const Scalar z586 = z17 * z582 - z18 * z584 - z30 * z585;
    const Scalar z587 = z19 * z582 - z23 * z584 - z24 * z585;
    const Scalar z588 = z25 * z584 + z28 * z585 - z29 * z582;
    const Scalar z589 = n0_04 * c_rear_right_hip;
    const Scalar z590 = n0_04 * s_rear_right_hip;
    const Scalar z591 = n0_05 + z589;
    const Scalar z592 = n0_2 * z17 + z18 * z591 + z30 * z590;
    const Scalar z593 = n0_2 * z19 + z23 * z591 + z24 * z590;
    const Scalar z594 = z25 * z591 + z28 * z590 + n0_2 * z29;
    const Scalar z595 = q_trunk_z - z594;
    const Scalar z596 = q_trunk_y - z593;
    const Scalar z597 = q_trunk_x - z592;
    const Scalar z598 = z18 * c_rear_right_hip + z30 * s_rear_right_hip;
    const Scalar z599 = z23 * c_rear_right_hip + z24 * s_rear_right_hip;
    const Scalar z600 = z25 * c_rear_right_hip + z28 * s_rear_right_hip;
    const Scalar z601 = z18 * s_rear_right_hip - z30 * c_rear_right_hip;
    const Scalar z602 = z23 * s_rear_right_hip - z24 * c_rear_right_hip;
    const Scalar z603 = z25 * s_rear_right_hip - z28 * c_rear_right_hip;
    const Scalar z604 = z122 - n0_04 * z166;
    const Scalar z605 = z168 - n0_04 * z169;
    const Scalar z606 = s_rear_right_hip * z605 + c_rear_right_hip * z167;
    const Scalar z607 = s_rear_right_hip * z167 - c_rear_right_hip * z605;
    const Scalar z608 = z17 * z604 - z18 * z606 - z30 * z607;
    const Scalar z609 = z19 * z604 - z23 * z606 - z24 * z607;
    const Scalar z610 = z25 * z606 + z28 * z607 - z29 * z604;
    const Scalar z611 = s_rear_right_hip * z166 + c_rear_right_hip * z165;
    const Scalar z612 = s_rear_right_hip * z165 - c_rear_right_hip * z166;
    const Scalar z613 = z17 * z169 + z18 * z611 + z30 * z612;
    const Scalar z614 = z19 * z169 + z23 * z611 + z24 * z612;
    const Scalar z615 = z25 * z611 + z28 * z612 + z29 * z169;
    const Scalar z616 = n0_09 * s_rear_right_thigh;
    const Scalar z617 = n0_09 * c_rear_right_thigh;
    const Scalar z618 = s_rear_right_hip * z617 - n0_08 * c_rear_right_hip;
    const Scalar z619 = n0_08 * s_rear_right_hip + c_rear_right_hip * z617;
    const Scalar z620 = n0_2 + z616;
    const Scalar z621 = n0_05 - z618;
    const Scalar z622 = z17 * z620 + z18 * z621 + z30 * z619;
    const Scalar z623 = z19 * z620 + z23 * z621 + z24 * z619;
    const Scalar z624 = z25 * z621 + z28 * z619 + z29 * z620;
    const Scalar z625 = q_trunk_z - z624;
    const Scalar z626 = q_trunk_y - z623;
    const Scalar z627 = q_trunk_x - z622;
    const Scalar z628 = s_rear_right_hip * s_rear_right_thigh;
    const Scalar z629 = c_rear_right_hip * s_rear_right_thigh;
    const Scalar z630 = z17 * c_rear_right_thigh + z18 * z628 - z30 * z629;
    const Scalar z631 = z19 * c_rear_right_thigh + z23 * z628 - z24 * z629;
    const Scalar z632 = z25 * z628 - z28 * z629 + z29 * c_rear_right_thigh;
    const Scalar z633 = s_rear_right_hip * c_rear_right_thigh;
    const Scalar z634 = c_rear_right_hip * c_rear_right_thigh;
    const Scalar z635 = z17 * s_rear_right_thigh - z18 * z633 + z30 * z634;
    const Scalar z636 = z19 * s_rear_right_thigh - z23 * z633 + z24 * z634;
    const Scalar z637 = z25 * z633 - z28 * z634 - z29 * s_rear_right_thigh;
    const Scalar z638 = z174 + n0_09 * z176;
    const Scalar z639 = z167 - n0_09 * z172;
    const Scalar z640 = s_rear_right_thigh * z175 - c_rear_right_thigh * z638;
    const Scalar z641 = s_rear_right_thigh * z638 + c_rear_right_thigh * z175;
    const Scalar z642 = s_rear_right_hip * z641 + c_rear_right_hip * z639;
    const Scalar z643 = s_rear_right_hip * z639 - c_rear_right_hip * z641;
    const Scalar z644 = z17 * z640 - z18 * z642 - z30 * z643;
    const Scalar z645 = z19 * z640 - z23 * z642 - z24 * z643;
    const Scalar z646 = z25 * z642 + z28 * z643 - z29 * z640;
    const Scalar z647 = s_rear_right_thigh * z173 + c_rear_right_thigh * z172;
    const Scalar z648 = s_rear_right_thigh * z172 - c_rear_right_thigh * z173;
    const Scalar z649 = s_rear_right_hip * z648 + c_rear_right_hip * z176;
    const Scalar z650 = s_rear_right_hip * z176 - c_rear_right_hip * z648;
    const Scalar z651 = z17 * z647 + z18 * z649 + z30 * z650;
    const Scalar z652 = z19 * z647 + z23 * z649 + z24 * z650;
    const Scalar z653 = z25 * z649 + z28 * z650 + z29 * z647;
    const Scalar z654 = n0_1 * s_rear_right_knee;
    const Scalar z655 = n0_1 * c_rear_right_knee;
    const Scalar z656 = n0_2 + z655;
    const Scalar z657 = s_rear_right_thigh * z656 + c_rear_right_thigh * z654;
    const Scalar z658 = s_rear_right_thigh * z654 - c_rear_right_thigh * z656;
    const Scalar z659 = s_rear_right_hip * z658 + n0_08 * c_rear_right_hip;
    const Scalar z660 = n0_08 * s_rear_right_hip - c_rear_right_hip * z658;
    const Scalar z661 = n0_2 + z657;
    const Scalar z662 = n0_05 + z659;
    const Scalar z663 = z17 * z661 + z18 * z662 + z30 * z660;
    const Scalar z664 = z19 * z661 + z23 * z662 + z24 * z660;
    const Scalar z665 = z25 * z662 + z28 * z660 + z29 * z661;
    const Scalar z666 = q_trunk_z - z665;
    const Scalar z667 = q_trunk_y - z664;
    const Scalar z668 = q_trunk_x - z663;
    const Scalar z672 = s_rear_right_hip * z670;
    const Scalar z673 = c_rear_right_hip * z670;
    const Scalar z674 = z17 * z671 + z18 * z672 - z30 * z673;
    const Scalar z675 = z19 * z671 + z23 * z672 - z24 * z673;
    const Scalar z676 = z25 * z672 - z28 * z673 + z29 * z671;
    const Scalar z677 = s_rear_right_hip * z671;
    const Scalar z678 = c_rear_right_hip * z671;
    const Scalar z679 = z17 * z670 - z18 * z677 + z30 * z678;
    const Scalar z680 = z19 * z670 - z23 * z677 + z24 * z678;
    const Scalar z681 = z25 * z677 - z28 * z678 - z29 * z670;
    const Scalar z682 = z181 + n0_1 * z183;
    const Scalar z683 = z178 + n0_1 * z179;
    const Scalar z684 = z182 * z670 + z671 * z682;
    const Scalar z685 = z182 * z671 - z670 * z682;
    const Scalar z686 = s_rear_right_hip * z685 - c_rear_right_hip * z683;
    const Scalar z687 = s_rear_right_hip * z683 + c_rear_right_hip * z685;
    const Scalar z688 = z17 * z684 - z18 * z686 + z30 * z687;
    const Scalar z689 = z19 * z684 - z23 * z686 + z24 * z687;
    const Scalar z690 = z25 * z686 - z28 * z687 - z29 * z684;
    const Scalar z691 = z179 * z671 - z180 * z670;
    const Scalar z692 = z179 * z670 + z180 * z671;
    const Scalar z693 = s_rear_right_hip * z692 - c_rear_right_hip * z183;
    const Scalar z694 = s_rear_right_hip * z183 + c_rear_right_hip * z692;
    const Scalar z695 = z17 * z691 + z18 * z693 - z30 * z694;
    const Scalar z696 = z19 * z691 + z23 * z693 - z24 * z694;
    const Scalar z697 = z25 * z693 - z28 * z694 + z29 * z691;
    const Scalar z698 = n0_2 * s_rear_right_knee;
    const Scalar z699 = n0_2 * c_rear_right_knee;
    const Scalar z700 = n0_2 + z699;
    const Scalar z701 = s_rear_right_thigh * z700 + c_rear_right_thigh * z698;
    const Scalar z702 = s_rear_right_thigh * z698 - c_rear_right_thigh * z700;
    const Scalar z703 = s_rear_right_hip * z702 + n0_08 * c_rear_right_hip;
    const Scalar z704 = n0_08 * s_rear_right_hip - c_rear_right_hip * z702;
    const Scalar z705 = n0_2 + z701;
    const Scalar z706 = n0_05 + z703;
    const Scalar z707 = z17 * z705 + z18 * z706 + z30 * z704;
    const Scalar z708 = z19 * z705 + z23 * z706 + z24 * z704;
    const Scalar z709 = z25 * z706 + z28 * z704 + z29 * z705;
    const Scalar z710 = q_trunk_z - z709;
    const Scalar z711 = q_trunk_y - z708;
    const Scalar z712 = q_trunk_x - z707;
    const Scalar z713 = z181 + n0_2 * z183;
    const Scalar z714 = z178 + n0_2 * z179;
    const Scalar z715 = z182 * z670 + z671 * z713;
    const Scalar z716 = z182 * z671 - z670 * z713;
    const Scalar z717 = s_rear_right_hip * z716 - c_rear_right_hip * z714;
    const Scalar z718 = s_rear_right_hip * z714 + c_rear_right_hip * z716;
    const Scalar z719 = z17 * z715 - z18 * z717 + z30 * z718;
    const Scalar z720 = z19 * z715 - z23 * z717 + z24 * z718;
    const Scalar z721 = z25 * z717 - z28 * z718 - z29 * z715;
    const Scalar z722 = q_trunk_x - z313;
    const Scalar z723 = q_trunk_y - z312;
    const Scalar z724 = q_trunk_z - z311;
    const Scalar z725 = z19 * z724 - z29 * z723;
    const Scalar z726 = z17 * z724 - z29 * z722;
    const Scalar z727 = z17 * z723 - z19 * z722;
    const Scalar z728 = z23 * z724 - z25 * z723;
    const Scalar z729 = z18 * z724 - z25 * z722;
    const Scalar z730 = z18 * z723 - z23 * z722;
    const Scalar z731 = z24 * z724 - z28 * z723;
    const Scalar z732 = z28 * z722 - z30 * z724;
    const Scalar z733 = z24 * z722 - z30 * z723;
    const Scalar z734 = n0_2 * z17 + n0_05 * z18;
    const Scalar z735 = n0_2 * z19 + n0_05 * z23;
    const Scalar z736 = n0_05 * z25 + n0_2 * z29;
    const Scalar z737 = q_trunk_z + z736;
    const Scalar z738 = q_trunk_y + z735;
    const Scalar z739 = q_trunk_x + z734;
    const Scalar z740 = z313 - z739;
    const Scalar z741 = z312 - z738;
    const Scalar z742 = z311 - z737;
    const Scalar z743 = z19 * z742 - z29 * z741;
    const Scalar z744 = z17 * z742 - z29 * z740;
    const Scalar z745 = z17 * z741 - z19 * z740;
    const Scalar z746 = n0_08 * c_front_left_hip;
    const Scalar z747 = n0_08 * s_front_left_hip;
    const Scalar z748 = n0_05 + z746;
    const Scalar z749 = n0_2 * z17 + z18 * z748 + z30 * z747;
    const Scalar z750 = n0_2 * z19 + z23 * z748 + z24 * z747;
    const Scalar z751 = z25 * z748 + z28 * z747 + n0_2 * z29;
    const Scalar z752 = q_trunk_z + z751;
    const Scalar z753 = q_trunk_y + z750;
    const Scalar z754 = q_trunk_x + z749;
    const Scalar z755 = z313 - z754;
    const Scalar z756 = z312 - z753;
    const Scalar z757 = z311 - z752;
    const Scalar z758 = z200 * z757 - z201 * z756;
    const Scalar z759 = z199 * z757 - z201 * z755;
    const Scalar z760 = z199 * z756 - z200 * z755;
    const Scalar z761 = n0_2 * s_front_left_thigh;
    const Scalar z762 = n0_2 * c_front_left_thigh;
    const Scalar z763 = s_front_left_hip * z762 + n0_08 * c_front_left_hip;
    const Scalar z764 = n0_08 * s_front_left_hip - c_front_left_hip * z762;
    const Scalar z765 = n0_2 - z761;
    const Scalar z766 = n0_05 + z763;
    const Scalar z767 = z17 * z765 + z18 * z766 + z30 * z764;
    const Scalar z768 = z19 * z765 + z23 * z766 + z24 * z764;
    const Scalar z769 = z25 * z766 + z28 * z764 + z29 * z765;
    const Scalar z770 = q_trunk_z + z769;
    const Scalar z771 = q_trunk_y + z768;
    const Scalar z772 = q_trunk_x + z767;
    const Scalar z773 = z313 - z772;
    const Scalar z774 = z312 - z771;
    const Scalar z775 = z311 - z770;
    const Scalar z776 = z200 * z775 - z201 * z774;
    const Scalar z777 = z199 * z775 - z201 * z773;
    const Scalar z778 = z199 * z774 - z200 * z773;
    const Scalar z779 = q_trunk_x - z446;
    const Scalar z780 = q_trunk_y - z445;
    const Scalar z781 = q_trunk_z - z444;
    const Scalar z782 = z19 * z781 - z29 * z780;
    const Scalar z783 = z17 * z781 - z29 * z779;
    const Scalar z784 = z17 * z780 - z19 * z779;
    const Scalar z785 = z23 * z781 - z25 * z780;
    const Scalar z786 = z18 * z781 - z25 * z779;
    const Scalar z787 = z18 * z780 - z23 * z779;
    const Scalar z788 = z24 * z781 - z28 * z780;
    const Scalar z789 = z28 * z779 - z30 * z781;
    const Scalar z790 = z24 * z779 - z30 * z780;
    const Scalar z791 = n0_2 * z17 - n0_05 * z18;
    const Scalar z792 = n0_2 * z19 - n0_05 * z23;
    const Scalar z793 = n0_05 * z25 - n0_2 * z29;
    const Scalar z794 = q_trunk_z - z793;
    const Scalar z795 = q_trunk_y + z792;
    const Scalar z796 = q_trunk_x + z791;
    const Scalar z797 = z446 - z796;
    const Scalar z798 = z445 - z795;
    const Scalar z799 = z444 - z794;
    const Scalar z800 = z19 * z799 - z29 * z798;
    const Scalar z801 = z17 * z799 - z29 * z797;
    const Scalar z802 = z17 * z798 - z19 * z797;
    const Scalar z803 = n0_08 * c_front_right_hip;
    const Scalar z804 = n0_08 * s_front_right_hip;
    const Scalar z805 = n0_05 + z803;
    const Scalar z806 = n0_2 * z17 - z18 * z805 - z30 * z804;
    const Scalar z807 = n0_2 * z19 - z23 * z805 - z24 * z804;
    const Scalar z808 = z25 * z805 + z28 * z804 - n0_2 * z29;
    const Scalar z809 = q_trunk_z - z808;
    const Scalar z810 = q_trunk_y + z807;
    const Scalar z811 = q_trunk_x + z806;
    const Scalar z812 = z446 - z811;
    const Scalar z813 = z445 - z810;
    const Scalar z814 = z444 - z809;
    const Scalar z815 = z333 * z814 - z334 * z813;
    const Scalar z816 = z332 * z814 - z334 * z812;
    const Scalar z817 = z332 * z813 - z333 * z812;
    const Scalar z818 = n0_2 * s_front_right_thigh;
    const Scalar z819 = n0_2 * c_front_right_thigh;
    const Scalar z820 = s_front_right_hip * z819 - n0_08 * c_front_right_hip;
    const Scalar z821 = n0_08 * s_front_right_hip + c_front_right_hip * z819;
    const Scalar z822 = n0_2 - z818;
    const Scalar z823 = n0_05 - z820;
    const Scalar z824 = z17 * z822 - z18 * z823 - z30 * z821;
    const Scalar z825 = z19 * z822 - z23 * z823 - z24 * z821;
    const Scalar z826 = z25 * z823 + z28 * z821 - z29 * z822;
    const Scalar z827 = q_trunk_z - z826;
    const Scalar z828 = q_trunk_y + z825;
    const Scalar z829 = q_trunk_x + z824;
    const Scalar z830 = z446 - z829;
    const Scalar z831 = z445 - z828;
    const Scalar z832 = z444 - z827;
    const Scalar z833 = z333 * z832 - z334 * z831;
    const Scalar z834 = z332 * z832 - z334 * z830;
    const Scalar z835 = z332 * z831 - z333 * z830;
    const Scalar z836 = q_trunk_x - z579;
    const Scalar z837 = q_trunk_y - z578;
    const Scalar z838 = q_trunk_z - z577;
    const Scalar z839 = z19 * z838 - z29 * z837;
    const Scalar z840 = z17 * z838 - z29 * z836;
    const Scalar z841 = z17 * z837 - z19 * z836;
    const Scalar z842 = z23 * z838 - z25 * z837;
    const Scalar z843 = z18 * z838 - z25 * z836;
    const Scalar z844 = z18 * z837 - z23 * z836;
    const Scalar z845 = z24 * z838 - z28 * z837;
    const Scalar z846 = z28 * z836 - z30 * z838;
    const Scalar z847 = z24 * z836 - z30 * z837;
    const Scalar z848 = q_trunk_z + z793;
    const Scalar z849 = q_trunk_y - z792;
    const Scalar z850 = q_trunk_x - z791;
    const Scalar z851 = z579 - z850;
    const Scalar z852 = z578 - z849;
    const Scalar z853 = z577 - z848;
    const Scalar z854 = z19 * z853 - z29 * z852;
    const Scalar z855 = z17 * z853 - z29 * z851;
    const Scalar z856 = z17 * z852 - z19 * z851;
    const Scalar z857 = n0_08 * c_rear_left_hip;
    const Scalar z858 = n0_08 * s_rear_left_hip;
    const Scalar z859 = n0_05 + z857;
    const Scalar z860 = n0_2 * z17 - z18 * z859 - z30 * z858;
    const Scalar z861 = n0_2 * z19 - z23 * z859 - z24 * z858;
    const Scalar z862 = z25 * z859 + z28 * z858 - n0_2 * z29;
    const Scalar z863 = q_trunk_z + z862;
    const Scalar z864 = q_trunk_y - z861;
    const Scalar z865 = q_trunk_x - z860;
    const Scalar z866 = z579 - z865;
    const Scalar z867 = z578 - z864;
    const Scalar z868 = z577 - z863;
    const Scalar z869 = z466 * z868 - z467 * z867;
    const Scalar z870 = z465 * z868 - z467 * z866;
    const Scalar z871 = z465 * z867 - z466 * z866;
    const Scalar z872 = n0_2 * s_rear_left_thigh;
    const Scalar z873 = n0_2 * c_rear_left_thigh;
    const Scalar z874 = s_rear_left_hip * z873 + n0_08 * c_rear_left_hip;
    const Scalar z875 = n0_08 * s_rear_left_hip - c_rear_left_hip * z873;
    const Scalar z876 = n0_2 + z872;
    const Scalar z877 = n0_05 + z874;
    const Scalar z878 = z17 * z876 - z18 * z877 - z30 * z875;
    const Scalar z879 = z19 * z876 - z23 * z877 - z24 * z875;
    const Scalar z880 = z25 * z877 + z28 * z875 - z29 * z876;
    const Scalar z881 = q_trunk_z + z880;
    const Scalar z882 = q_trunk_y - z879;
    const Scalar z883 = q_trunk_x - z878;
    const Scalar z884 = z579 - z883;
    const Scalar z885 = z578 - z882;
    const Scalar z886 = z577 - z881;
    const Scalar z887 = z466 * z886 - z467 * z885;
    const Scalar z888 = z465 * z886 - z467 * z884;
    const Scalar z889 = z465 * z885 - z466 * z884;
    const Scalar z890 = q_trunk_x - z712;
    const Scalar z891 = q_trunk_y - z711;
    const Scalar z892 = q_trunk_z - z710;
    const Scalar z893 = z19 * z892 - z29 * z891;
    const Scalar z894 = z17 * z892 - z29 * z890;
    const Scalar z895 = z17 * z891 - z19 * z890;
    const Scalar z896 = z23 * z892 - z25 * z891;
    const Scalar z897 = z18 * z892 - z25 * z890;
    const Scalar z898 = z18 * z891 - z23 * z890;
    const Scalar z899 = z24 * z892 - z28 * z891;
    const Scalar z900 = z28 * z890 - z30 * z892;
    const Scalar z901 = z24 * z890 - z30 * z891;
    const Scalar z902 = q_trunk_z - z736;
    const Scalar z903 = q_trunk_y - z735;
    const Scalar z904 = q_trunk_x - z734;
    const Scalar z905 = z712 - z904;
    const Scalar z906 = z711 - z903;
    const Scalar z907 = z710 - z902;
    const Scalar z908 = z19 * z907 - z29 * z906;
    const Scalar z909 = z17 * z907 - z29 * z905;
    const Scalar z910 = z17 * z906 - z19 * z905;
    const Scalar z911 = n0_08 * c_rear_right_hip;
    const Scalar z912 = n0_08 * s_rear_right_hip;
    const Scalar z913 = n0_05 + z911;
    const Scalar z914 = n0_2 * z17 + z18 * z913 + z30 * z912;
    const Scalar z915 = n0_2 * z19 + z23 * z913 + z24 * z912;
    const Scalar z916 = z25 * z913 + z28 * z912 + n0_2 * z29;
    const Scalar z917 = q_trunk_z - z916;
    const Scalar z918 = q_trunk_y - z915;
    const Scalar z919 = q_trunk_x - z914;
    const Scalar z920 = z712 - z919;
    const Scalar z921 = z711 - z918;
    const Scalar z922 = z710 - z917;
    const Scalar z923 = z599 * z922 - z600 * z921;
    const Scalar z924 = z598 * z922 - z600 * z920;
    const Scalar z925 = z598 * z921 - z599 * z920;
    const Scalar z926 = n0_2 * s_rear_right_thigh;
    const Scalar z927 = n0_2 * c_rear_right_thigh;
    const Scalar z928 = s_rear_right_hip * z927 - n0_08 * c_rear_right_hip;
    const Scalar z929 = n0_08 * s_rear_right_hip + c_rear_right_hip * z927;
    const Scalar z930 = n0_2 + z926;
    const Scalar z931 = n0_05 - z928;
    const Scalar z932 = z17 * z930 + z18 * z931 + z30 * z929;
    const Scalar z933 = z19 * z930 + z23 * z931 + z24 * z929;
    const Scalar z934 = z25 * z931 + z28 * z929 + z29 * z930;
    const Scalar z935 = q_trunk_z - z934;
    const Scalar z936 = q_trunk_y - z933;
    const Scalar z937 = q_trunk_x - z932;
    const Scalar z938 = z712 - z937;
    const Scalar z939 = z711 - z936;
    const Scalar z940 = z710 - z935;
    const Scalar z941 = z599 * z940 - z600 * z939;
    const Scalar z942 = z598 * z940 - z600 * z938;
    const Scalar z943 = z598 * z939 - z599 * z938;
    result.trunk_position[0] = q_trunk_x;
    result.trunk_position[1] = q_trunk_y;
    result.trunk_position[2] = q_trunk_z;
    result.trunk_rotation[0] = z17;
    result.trunk_rotation[1] = z19;
    result.trunk_rotation[2] = z29;
    result.trunk_rotation[3] = z18;
    result.trunk_rotation[4] = z23;
    result.trunk_rotation[5] = z25;
    result.trunk_rotation[6] = z30;
    result.trunk_rotation[7] = z24;
    result.trunk_rotation[8] = z28;
    result.trunk_velocity[0] = z184;
    result.trunk_velocity[1] = z185;
    result.trunk_velocity[2] = z186;
    result.trunk_angular_velocity[0] = z187;
    result.trunk_angular_velocity[1] = z188;
    result.trunk_angular_velocity[2] = z189;
    result.front_left_hip_link_position[0] = z198;
    result.front_left_hip_link_position[1] = z197;
    result.front_left_hip_link_position[2] = z196;
    result.front_left_hip_link_rotation[0] = z17;
    result.front_left_hip_link_rotation[1] = z19;
    result.front_left_hip_link_rotation[2] = z29;
    result.front_left_hip_link_rotation[3] = z199;
    result.front_left_hip_link_rotation[4] = z200;
    result.front_left_hip_link_rotation[5] = z201;
    result.front_left_hip_link_rotation[6] = -z202;
    result.front_left_hip_link_rotation[7] = -z203;
    result.front_left_hip_link_rotation[8] = -z204;
    result.front_left_hip_link_velocity[0] = -z209;
    result.front_left_hip_link_velocity[1] = -z210;
    result.front_left_hip_link_velocity[2] = z211;
    result.front_left_hip_link_angular_velocity[0] = z214;
    result.front_left_hip_link_angular_velocity[1] = z215;
    result.front_left_hip_link_angular_velocity[2] = z216;
    result.front_left_thigh_link_position[0] = z228;
    result.front_left_thigh_link_position[1] = z227;
    result.front_left_thigh_link_position[2] = z226;
    result.front_left_thigh_link_rotation[0] = z231;
    result.front_left_thigh_link_rotation[1] = z232;
    result.front_left_thigh_link_rotation[2] = z233;
    result.front_left_thigh_link_rotation[3] = z199;
    result.front_left_thigh_link_rotation[4] = z200;
    result.front_left_thigh_link_rotation[5] = z201;
    result.front_left_thigh_link_rotation[6] = z236;
    result.front_left_thigh_link_rotation[7] = z237;
    result.front_left_thigh_link_rotation[8] = -z238;
    result.front_left_thigh_link_velocity[0] = -z245;
    result.front_left_thigh_link_velocity[1] = -z246;
    result.front_left_thigh_link_velocity[2] = z247;
    result.front_left_thigh_link_angular_velocity[0] = z252;
    result.front_left_thigh_link_angular_velocity[1] = z253;
    result.front_left_thigh_link_angular_velocity[2] = z254;
    result.front_left_shank_link_position[0] = z269;
    result.front_left_shank_link_position[1] = z268;
    result.front_left_shank_link_position[2] = z267;
    result.front_left_shank_link_rotation[0] = z275;
    result.front_left_shank_link_rotation[1] = z276;
    result.front_left_shank_link_rotation[2] = z277;
    result.front_left_shank_link_rotation[3] = z199;
    result.front_left_shank_link_rotation[4] = z200;
    result.front_left_shank_link_rotation[5] = z201;
    result.front_left_shank_link_rotation[6] = z280;
    result.front_left_shank_link_rotation[7] = z281;
    result.front_left_shank_link_rotation[8] = -z282;
    result.front_left_shank_link_velocity[0] = z289;
    result.front_left_shank_link_velocity[1] = z290;
    result.front_left_shank_link_velocity[2] = -z291;
    result.front_left_shank_link_angular_velocity[0] = -z296;
    result.front_left_shank_link_angular_velocity[1] = -z297;
    result.front_left_shank_link_angular_velocity[2] = -z298;
    result.front_left_foot_position[0] = z313;
    result.front_left_foot_position[1] = z312;
    result.front_left_foot_position[2] = z311;
    result.front_left_foot_rotation[0] = z275;
    result.front_left_foot_rotation[1] = z276;
    result.front_left_foot_rotation[2] = z277;
    result.front_left_foot_rotation[3] = z199;
    result.front_left_foot_rotation[4] = z200;
    result.front_left_foot_rotation[5] = z201;
    result.front_left_foot_rotation[6] = z280;
    result.front_left_foot_rotation[7] = z281;
    result.front_left_foot_rotation[8] = -z282;
    result.front_left_foot_velocity[0] = z320;
    result.front_left_foot_velocity[1] = z321;
    result.front_left_foot_velocity[2] = -z322;
    result.front_left_foot_angular_velocity[0] = -z296;
    result.front_left_foot_angular_velocity[1] = -z297;
    result.front_left_foot_angular_velocity[2] = -z298;
    result.front_right_hip_link_position[0] = z331;
    result.front_right_hip_link_position[1] = z330;
    result.front_right_hip_link_position[2] = z329;
    result.front_right_hip_link_rotation[0] = z17;
    result.front_right_hip_link_rotation[1] = z19;
    result.front_right_hip_link_rotation[2] = z29;
    result.front_right_hip_link_rotation[3] = z332;
    result.front_right_hip_link_rotation[4] = z333;
    result.front_right_hip_link_rotation[5] = z334;
    result.front_right_hip_link_rotation[6] = -z335;
    result.front_right_hip_link_rotation[7] = -z336;
    result.front_right_hip_link_rotation[8] = -z337;
    result.front_right_hip_link_velocity[0] = z342;
    result.front_right_hip_link_velocity[1] = z343;
    result.front_right_hip_link_velocity[2] = z344;
    result.front_right_hip_link_angular_velocity[0] = z347;
    result.front_right_hip_link_angular_velocity[1] = z348;
    result.front_right_hip_link_angular_velocity[2] = z349;
    result.front_right_thigh_link_position[0] = z361;
    result.front_right_thigh_link_position[1] = z360;
    result.front_right_thigh_link_position[2] = z359;
    result.front_right_thigh_link_rotation[0] = z364;
    result.front_right_thigh_link_rotation[1] = z365;
    result.front_right_thigh_link_rotation[2] = z366;
    result.front_right_thigh_link_rotation[3] = z332;
    result.front_right_thigh_link_rotation[4] = z333;
    result.front_right_thigh_link_rotation[5] = z334;
    result.front_right_thigh_link_rotation[6] = z369;
    result.front_right_thigh_link_rotation[7] = z370;
    result.front_right_thigh_link_rotation[8] = -z371;
    result.front_right_thigh_link_velocity[0] = z378;
    result.front_right_thigh_link_velocity[1] = z379;
    result.front_right_thigh_link_velocity[2] = z380;
    result.front_right_thigh_link_angular_velocity[0] = z385;
    result.front_right_thigh_link_angular_velocity[1] = z386;
    result.front_right_thigh_link_angular_velocity[2] = z387;
    result.front_right_shank_link_position[0] = z402;
    result.front_right_shank_link_position[1] = z401;
    result.front_right_shank_link_position[2] = z400;
    result.front_right_shank_link_rotation[0] = z408;
    result.front_right_shank_link_rotation[1] = z409;
    result.front_right_shank_link_rotation[2] = z410;
    result.front_right_shank_link_rotation[3] = z332;
    result.front_right_shank_link_rotation[4] = z333;
    result.front_right_shank_link_rotation[5] = z334;
    result.front_right_shank_link_rotation[6] = z413;
    result.front_right_shank_link_rotation[7] = z414;
    result.front_right_shank_link_rotation[8] = -z415;
    result.front_right_shank_link_velocity[0] = z422;
    result.front_right_shank_link_velocity[1] = z423;
    result.front_right_shank_link_velocity[2] = -z424;
    result.front_right_shank_link_angular_velocity[0] = -z429;
    result.front_right_shank_link_angular_velocity[1] = -z430;
    result.front_right_shank_link_angular_velocity[2] = -z431;
    result.front_right_foot_position[0] = z446;
    result.front_right_foot_position[1] = z445;
    result.front_right_foot_position[2] = z444;
    result.front_right_foot_rotation[0] = z408;
    result.front_right_foot_rotation[1] = z409;
    result.front_right_foot_rotation[2] = z410;
    result.front_right_foot_rotation[3] = z332;
    result.front_right_foot_rotation[4] = z333;
    result.front_right_foot_rotation[5] = z334;
    result.front_right_foot_rotation[6] = z413;
    result.front_right_foot_rotation[7] = z414;
    result.front_right_foot_rotation[8] = -z415;
    result.front_right_foot_velocity[0] = z453;
    result.front_right_foot_velocity[1] = z454;
    result.front_right_foot_velocity[2] = -z455;
    result.front_right_foot_angular_velocity[0] = -z429;
    result.front_right_foot_angular_velocity[1] = -z430;
    result.front_right_foot_angular_velocity[2] = -z431;
    result.rear_left_hip_link_position[0] = z464;
    result.rear_left_hip_link_position[1] = z463;
    result.rear_left_hip_link_position[2] = z462;
    result.rear_left_hip_link_rotation[0] = z17;
    result.rear_left_hip_link_rotation[1] = z19;
    result.rear_left_hip_link_rotation[2] = z29;
    result.rear_left_hip_link_rotation[3] = z465;
    result.rear_left_hip_link_rotation[4] = z466;
    result.rear_left_hip_link_rotation[5] = z467;
    result.rear_left_hip_link_rotation[6] = -z468;
    result.rear_left_hip_link_rotation[7] = -z469;
    result.rear_left_hip_link_rotation[8] = -z470;
    result.rear_left_hip_link_velocity[0] = -z475;
    result.rear_left_hip_link_velocity[1] = -z476;
    result.rear_left_hip_link_velocity[2] = -z477;
    result.rear_left_hip_link_angular_velocity[0] = z480;
    result.rear_left_hip_link_angular_velocity[1] = z481;
    result.rear_left_hip_link_angular_velocity[2] = z482;
    result.rear_left_thigh_link_position[0] = z494;
    result.rear_left_thigh_link_position[1] = z493;
    result.rear_left_thigh_link_position[2] = z492;
    result.rear_left_thigh_link_rotation[0] = z497;
    result.rear_left_thigh_link_rotation[1] = z498;
    result.rear_left_thigh_link_rotation[2] = z499;
    result.rear_left_thigh_link_rotation[3] = z465;
    result.rear_left_thigh_link_rotation[4] = z466;
    result.rear_left_thigh_link_rotation[5] = z467;
    result.rear_left_thigh_link_rotation[6] = z502;
    result.rear_left_thigh_link_rotation[7] = z503;
    result.rear_left_thigh_link_rotation[8] = -z504;
    result.rear_left_thigh_link_velocity[0] = -z511;
    result.rear_left_thigh_link_velocity[1] = -z512;
    result.rear_left_thigh_link_velocity[2] = -z513;
    result.rear_left_thigh_link_angular_velocity[0] = z518;
    result.rear_left_thigh_link_angular_velocity[1] = z519;
    result.rear_left_thigh_link_angular_velocity[2] = z520;
    result.rear_left_shank_link_position[0] = z535;
    result.rear_left_shank_link_position[1] = z534;
    result.rear_left_shank_link_position[2] = z533;
    result.rear_left_shank_link_rotation[0] = z541;
    result.rear_left_shank_link_rotation[1] = z542;
    result.rear_left_shank_link_rotation[2] = z543;
    result.rear_left_shank_link_rotation[3] = z465;
    result.rear_left_shank_link_rotation[4] = z466;
    result.rear_left_shank_link_rotation[5] = z467;
    result.rear_left_shank_link_rotation[6] = z546;
    result.rear_left_shank_link_rotation[7] = z547;
    result.rear_left_shank_link_rotation[8] = -z548;
    result.rear_left_shank_link_velocity[0] = -z555;
    result.rear_left_shank_link_velocity[1] = -z556;
    result.rear_left_shank_link_velocity[2] = z557;
    result.rear_left_shank_link_angular_velocity[0] = -z562;
    result.rear_left_shank_link_angular_velocity[1] = -z563;
    result.rear_left_shank_link_angular_velocity[2] = -z564;
    result.rear_left_foot_position[0] = z579;
    result.rear_left_foot_position[1] = z578;
    result.rear_left_foot_position[2] = z577;
    result.rear_left_foot_rotation[0] = z541;
    result.rear_left_foot_rotation[1] = z542;
    result.rear_left_foot_rotation[2] = z543;
    result.rear_left_foot_rotation[3] = z465;
    result.rear_left_foot_rotation[4] = z466;
    result.rear_left_foot_rotation[5] = z467;
    result.rear_left_foot_rotation[6] = z546;
    result.rear_left_foot_rotation[7] = z547;
    result.rear_left_foot_rotation[8] = -z548;
    result.rear_left_foot_velocity[0] = -z586;
    result.rear_left_foot_velocity[1] = -z587;
    result.rear_left_foot_velocity[2] = z588;
    result.rear_left_foot_angular_velocity[0] = -z562;
    result.rear_left_foot_angular_velocity[1] = -z563;
    result.rear_left_foot_angular_velocity[2] = -z564;
    result.rear_right_hip_link_position[0] = z597;
    result.rear_right_hip_link_position[1] = z596;
    result.rear_right_hip_link_position[2] = z595;
    result.rear_right_hip_link_rotation[0] = z17;
    result.rear_right_hip_link_rotation[1] = z19;
    result.rear_right_hip_link_rotation[2] = z29;
    result.rear_right_hip_link_rotation[3] = z598;
    result.rear_right_hip_link_rotation[4] = z599;
    result.rear_right_hip_link_rotation[5] = z600;
    result.rear_right_hip_link_rotation[6] = -z601;
    result.rear_right_hip_link_rotation[7] = -z602;
    result.rear_right_hip_link_rotation[8] = -z603;
    result.rear_right_hip_link_velocity[0] = z608;
    result.rear_right_hip_link_velocity[1] = z609;
    result.rear_right_hip_link_velocity[2] = -z610;
    result.rear_right_hip_link_angular_velocity[0] = z613;
    result.rear_right_hip_link_angular_velocity[1] = z614;
    result.rear_right_hip_link_angular_velocity[2] = z615;
    result.rear_right_thigh_link_position[0] = z627;
    result.rear_right_thigh_link_position[1] = z626;
    result.rear_right_thigh_link_position[2] = z625;
    result.rear_right_thigh_link_rotation[0] = z630;
    result.rear_right_thigh_link_rotation[1] = z631;
    result.rear_right_thigh_link_rotation[2] = z632;
    result.rear_right_thigh_link_rotation[3] = z598;
    result.rear_right_thigh_link_rotation[4] = z599;
    result.rear_right_thigh_link_rotation[5] = z600;
    result.rear_right_thigh_link_rotation[6] = z635;
    result.rear_right_thigh_link_rotation[7] = z636;
    result.rear_right_thigh_link_rotation[8] = -z637;
    result.rear_right_thigh_link_velocity[0] = z644;
    result.rear_right_thigh_link_velocity[1] = z645;
    result.rear_right_thigh_link_velocity[2] = -z646;
    result.rear_right_thigh_link_angular_velocity[0] = z651;
    result.rear_right_thigh_link_angular_velocity[1] = z652;
    result.rear_right_thigh_link_angular_velocity[2] = z653;
    result.rear_right_shank_link_position[0] = z668;
    result.rear_right_shank_link_position[1] = z667;
    result.rear_right_shank_link_position[2] = z666;
    result.rear_right_shank_link_rotation[0] = z674;
    result.rear_right_shank_link_rotation[1] = z675;
    result.rear_right_shank_link_rotation[2] = z676;
    result.rear_right_shank_link_rotation[3] = z598;
    result.rear_right_shank_link_rotation[4] = z599;
    result.rear_right_shank_link_rotation[5] = z600;
    result.rear_right_shank_link_rotation[6] = z679;
    result.rear_right_shank_link_rotation[7] = z680;
    result.rear_right_shank_link_rotation[8] = -z681;
    result.rear_right_shank_link_velocity[0] = -z688;
    result.rear_right_shank_link_velocity[1] = -z689;
    result.rear_right_shank_link_velocity[2] = z690;
    result.rear_right_shank_link_angular_velocity[0] = -z695;
    result.rear_right_shank_link_angular_velocity[1] = -z696;
    result.rear_right_shank_link_angular_velocity[2] = -z697;
    result.rear_right_foot_position[0] = z712;
    result.rear_right_foot_position[1] = z711;
    result.rear_right_foot_position[2] = z710;
    result.rear_right_foot_rotation[0] = z674;
    result.rear_right_foot_rotation[1] = z675;
    result.rear_right_foot_rotation[2] = z676;
    result.rear_right_foot_rotation[3] = z598;
    result.rear_right_foot_rotation[4] = z599;
    result.rear_right_foot_rotation[5] = z600;
    result.rear_right_foot_rotation[6] = z679;
    result.rear_right_foot_rotation[7] = z680;
    result.rear_right_foot_rotation[8] = -z681;
    result.rear_right_foot_velocity[0] = -z719;
    result.rear_right_foot_velocity[1] = -z720;
    result.rear_right_foot_velocity[2] = z721;
    result.rear_right_foot_angular_velocity[0] = -z695;
    result.rear_right_foot_angular_velocity[1] = -z696;
    result.rear_right_foot_angular_velocity[2] = -z697;
    result.front_left_foot_origin_position[0] = z313;
    result.front_left_foot_origin_position[1] = z312;
    result.front_left_foot_origin_position[2] = z311;
    result.front_left_foot_origin_velocity[0] = z320;
    result.front_left_foot_origin_velocity[1] = z321;
    result.front_left_foot_origin_velocity[2] = -z322;
    result.front_left_foot_origin_jacobian[0] = n1;
    result.front_left_foot_origin_jacobian[3] = n0;
    result.front_left_foot_origin_jacobian[6] = n0;
    result.front_left_foot_origin_jacobian[9] = -z725;
    result.front_left_foot_origin_jacobian[12] = -z728;
    result.front_left_foot_origin_jacobian[15] = -z731;
    result.front_left_foot_origin_jacobian[18] = z743;
    result.front_left_foot_origin_jacobian[21] = z758;
    result.front_left_foot_origin_jacobian[24] = z776;
    result.front_left_foot_origin_jacobian[27] = n0;
    result.front_left_foot_origin_jacobian[30] = n0;
    result.front_left_foot_origin_jacobian[33] = n0;
    result.front_left_foot_origin_jacobian[36] = n0;
    result.front_left_foot_origin_jacobian[39] = n0;
    result.front_left_foot_origin_jacobian[42] = n0;
    result.front_left_foot_origin_jacobian[45] = n0;
    result.front_left_foot_origin_jacobian[48] = n0;
    result.front_left_foot_origin_jacobian[51] = n0;
    result.front_left_foot_origin_jacobian[1] = n0;
    result.front_left_foot_origin_jacobian[4] = n1;
    result.front_left_foot_origin_jacobian[7] = n0;
    result.front_left_foot_origin_jacobian[10] = z726;
    result.front_left_foot_origin_jacobian[13] = z729;
    result.front_left_foot_origin_jacobian[16] = -z732;
    result.front_left_foot_origin_jacobian[19] = -z744;
    result.front_left_foot_origin_jacobian[22] = -z759;
    result.front_left_foot_origin_jacobian[25] = -z777;
    result.front_left_foot_origin_jacobian[28] = n0;
    result.front_left_foot_origin_jacobian[31] = n0;
    result.front_left_foot_origin_jacobian[34] = n0;
    result.front_left_foot_origin_jacobian[37] = n0;
    result.front_left_foot_origin_jacobian[40] = n0;
    result.front_left_foot_origin_jacobian[43] = n0;
    result.front_left_foot_origin_jacobian[46] = n0;
    result.front_left_foot_origin_jacobian[49] = n0;
    result.front_left_foot_origin_jacobian[52] = n0;
    result.front_left_foot_origin_jacobian[2] = n0;
    result.front_left_foot_origin_jacobian[5] = n0;
    result.front_left_foot_origin_jacobian[8] = n1;
    result.front_left_foot_origin_jacobian[11] = -z727;
    result.front_left_foot_origin_jacobian[14] = -z730;
    result.front_left_foot_origin_jacobian[17] = z733;
    result.front_left_foot_origin_jacobian[20] = z745;
    result.front_left_foot_origin_jacobian[23] = z760;
    result.front_left_foot_origin_jacobian[26] = z778;
    result.front_left_foot_origin_jacobian[29] = n0;
    result.front_left_foot_origin_jacobian[32] = n0;
    result.front_left_foot_origin_jacobian[35] = n0;
    result.front_left_foot_origin_jacobian[38] = n0;
    result.front_left_foot_origin_jacobian[41] = n0;
    result.front_left_foot_origin_jacobian[44] = n0;
    result.front_left_foot_origin_jacobian[47] = n0;
    result.front_left_foot_origin_jacobian[50] = n0;
    result.front_left_foot_origin_jacobian[53] = n0;
    result.front_right_foot_origin_position[0] = z446;
    result.front_right_foot_origin_position[1] = z445;
    result.front_right_foot_origin_position[2] = z444;
    result.front_right_foot_origin_velocity[0] = z453;
    result.front_right_foot_origin_velocity[1] = z454;
    result.front_right_foot_origin_velocity[2] = -z455;
    result.front_right_foot_origin_jacobian[0] = n1;
    result.front_right_foot_origin_jacobian[3] = n0;
    result.front_right_foot_origin_jacobian[6] = n0;
    result.front_right_foot_origin_jacobian[9] = -z782;
    result.front_right_foot_origin_jacobian[12] = -z785;
    result.front_right_foot_origin_jacobian[15] = -z788;
    result.front_right_foot_origin_jacobian[18] = n0;
    result.front_right_foot_origin_jacobian[21] = n0;
    result.front_right_foot_origin_jacobian[24] = n0;
    result.front_right_foot_origin_jacobian[27] = z800;
    result.front_right_foot_origin_jacobian[30] = z815;
    result.front_right_foot_origin_jacobian[33] = z833;
    result.front_right_foot_origin_jacobian[36] = n0;
    result.front_right_foot_origin_jacobian[39] = n0;
    result.front_right_foot_origin_jacobian[42] = n0;
    result.front_right_foot_origin_jacobian[45] = n0;
    result.front_right_foot_origin_jacobian[48] = n0;
    result.front_right_foot_origin_jacobian[51] = n0;
    result.front_right_foot_origin_jacobian[1] = n0;
    result.front_right_foot_origin_jacobian[4] = n1;
    result.front_right_foot_origin_jacobian[7] = n0;
    result.front_right_foot_origin_jacobian[10] = z783;
    result.front_right_foot_origin_jacobian[13] = z786;
    result.front_right_foot_origin_jacobian[16] = -z789;
    result.front_right_foot_origin_jacobian[19] = n0;
    result.front_right_foot_origin_jacobian[22] = n0;
    result.front_right_foot_origin_jacobian[25] = n0;
    result.front_right_foot_origin_jacobian[28] = -z801;
    result.front_right_foot_origin_jacobian[31] = -z816;
    result.front_right_foot_origin_jacobian[34] = -z834;
    result.front_right_foot_origin_jacobian[37] = n0;
    result.front_right_foot_origin_jacobian[40] = n0;
    result.front_right_foot_origin_jacobian[43] = n0;
    result.front_right_foot_origin_jacobian[46] = n0;
    result.front_right_foot_origin_jacobian[49] = n0;
    result.front_right_foot_origin_jacobian[52] = n0;
    result.front_right_foot_origin_jacobian[2] = n0;
    result.front_right_foot_origin_jacobian[5] = n0;
    result.front_right_foot_origin_jacobian[8] = n1;
    result.front_right_foot_origin_jacobian[11] = -z784;
    result.front_right_foot_origin_jacobian[14] = -z787;
    result.front_right_foot_origin_jacobian[17] = z790;
    result.front_right_foot_origin_jacobian[20] = n0;
    result.front_right_foot_origin_jacobian[23] = n0;
    result.front_right_foot_origin_jacobian[26] = n0;
    result.front_right_foot_origin_jacobian[29] = z802;
    result.front_right_foot_origin_jacobian[32] = z817;
    result.front_right_foot_origin_jacobian[35] = z835;
    result.front_right_foot_origin_jacobian[38] = n0;
    result.front_right_foot_origin_jacobian[41] = n0;
    result.front_right_foot_origin_jacobian[44] = n0;
    result.front_right_foot_origin_jacobian[47] = n0;
    result.front_right_foot_origin_jacobian[50] = n0;
    result.front_right_foot_origin_jacobian[53] = n0;
    result.rear_left_foot_origin_position[0] = z579;
    result.rear_left_foot_origin_position[1] = z578;
    result.rear_left_foot_origin_position[2] = z577;
    result.rear_left_foot_origin_velocity[0] = -z586;
    result.rear_left_foot_origin_velocity[1] = -z587;
    result.rear_left_foot_origin_velocity[2] = z588;
    result.rear_left_foot_origin_jacobian[0] = n1;
    result.rear_left_foot_origin_jacobian[3] = n0;
    result.rear_left_foot_origin_jacobian[6] = n0;
    result.rear_left_foot_origin_jacobian[9] = -z839;
    result.rear_left_foot_origin_jacobian[12] = -z842;
    result.rear_left_foot_origin_jacobian[15] = -z845;
    result.rear_left_foot_origin_jacobian[18] = n0;
    result.rear_left_foot_origin_jacobian[21] = n0;
    result.rear_left_foot_origin_jacobian[24] = n0;
    result.rear_left_foot_origin_jacobian[27] = n0;
    result.rear_left_foot_origin_jacobian[30] = n0;
    result.rear_left_foot_origin_jacobian[33] = n0;
    result.rear_left_foot_origin_jacobian[36] = z854;
    result.rear_left_foot_origin_jacobian[39] = z869;
    result.rear_left_foot_origin_jacobian[42] = z887;
    result.rear_left_foot_origin_jacobian[45] = n0;
    result.rear_left_foot_origin_jacobian[48] = n0;
    result.rear_left_foot_origin_jacobian[51] = n0;
    result.rear_left_foot_origin_jacobian[1] = n0;
    result.rear_left_foot_origin_jacobian[4] = n1;
    result.rear_left_foot_origin_jacobian[7] = n0;
    result.rear_left_foot_origin_jacobian[10] = z840;
    result.rear_left_foot_origin_jacobian[13] = z843;
    result.rear_left_foot_origin_jacobian[16] = -z846;
    result.rear_left_foot_origin_jacobian[19] = n0;
    result.rear_left_foot_origin_jacobian[22] = n0;
    result.rear_left_foot_origin_jacobian[25] = n0;
    result.rear_left_foot_origin_jacobian[28] = n0;
    result.rear_left_foot_origin_jacobian[31] = n0;
    result.rear_left_foot_origin_jacobian[34] = n0;
    result.rear_left_foot_origin_jacobian[37] = -z855;
    result.rear_left_foot_origin_jacobian[40] = -z870;
    result.rear_left_foot_origin_jacobian[43] = -z888;
    result.rear_left_foot_origin_jacobian[46] = n0;
    result.rear_left_foot_origin_jacobian[49] = n0;
    result.rear_left_foot_origin_jacobian[52] = n0;
    result.rear_left_foot_origin_jacobian[2] = n0;
    result.rear_left_foot_origin_jacobian[5] = n0;
    result.rear_left_foot_origin_jacobian[8] = n1;
    result.rear_left_foot_origin_jacobian[11] = -z841;
    result.rear_left_foot_origin_jacobian[14] = -z844;
    result.rear_left_foot_origin_jacobian[17] = z847;
    result.rear_left_foot_origin_jacobian[20] = n0;
    result.rear_left_foot_origin_jacobian[23] = n0;
    result.rear_left_foot_origin_jacobian[26] = n0;
    result.rear_left_foot_origin_jacobian[29] = n0;
    result.rear_left_foot_origin_jacobian[32] = n0;
    result.rear_left_foot_origin_jacobian[35] = n0;
    result.rear_left_foot_origin_jacobian[38] = z856;
    result.rear_left_foot_origin_jacobian[41] = z871;
    result.rear_left_foot_origin_jacobian[44] = z889;
    result.rear_left_foot_origin_jacobian[47] = n0;
    result.rear_left_foot_origin_jacobian[50] = n0;
    result.rear_left_foot_origin_jacobian[53] = n0;
    result.rear_right_foot_origin_position[0] = z712;
    result.rear_right_foot_origin_position[1] = z711;
    result.rear_right_foot_origin_position[2] = z710;
    result.rear_right_foot_origin_velocity[0] = -z719;
    result.rear_right_foot_origin_velocity[1] = -z720;
    result.rear_right_foot_origin_velocity[2] = z721;
    result.rear_right_foot_origin_jacobian[0] = n1;
    result.rear_right_foot_origin_jacobian[3] = n0;
    result.rear_right_foot_origin_jacobian[6] = n0;
    result.rear_right_foot_origin_jacobian[9] = -z893;
    result.rear_right_foot_origin_jacobian[12] = -z896;
    result.rear_right_foot_origin_jacobian[15] = -z899;
    result.rear_right_foot_origin_jacobian[18] = n0;
    result.rear_right_foot_origin_jacobian[21] = n0;
    result.rear_right_foot_origin_jacobian[24] = n0;
    result.rear_right_foot_origin_jacobian[27] = n0;
    result.rear_right_foot_origin_jacobian[30] = n0;
    result.rear_right_foot_origin_jacobian[33] = n0;
    result.rear_right_foot_origin_jacobian[36] = n0;
    result.rear_right_foot_origin_jacobian[39] = n0;
    result.rear_right_foot_origin_jacobian[42] = n0;
    result.rear_right_foot_origin_jacobian[45] = z908;
    result.rear_right_foot_origin_jacobian[48] = z923;
    result.rear_right_foot_origin_jacobian[51] = z941;
    result.rear_right_foot_origin_jacobian[1] = n0;
    result.rear_right_foot_origin_jacobian[4] = n1;
    result.rear_right_foot_origin_jacobian[7] = n0;
    result.rear_right_foot_origin_jacobian[10] = z894;
    result.rear_right_foot_origin_jacobian[13] = z897;
    result.rear_right_foot_origin_jacobian[16] = -z900;
    result.rear_right_foot_origin_jacobian[19] = n0;
    result.rear_right_foot_origin_jacobian[22] = n0;
    result.rear_right_foot_origin_jacobian[25] = n0;
    result.rear_right_foot_origin_jacobian[28] = n0;
    result.rear_right_foot_origin_jacobian[31] = n0;
    result.rear_right_foot_origin_jacobian[34] = n0;
    result.rear_right_foot_origin_jacobian[37] = n0;
    result.rear_right_foot_origin_jacobian[40] = n0;
    result.rear_right_foot_origin_jacobian[43] = n0;
    result.rear_right_foot_origin_jacobian[46] = -z909;
    result.rear_right_foot_origin_jacobian[49] = -z924;
    result.rear_right_foot_origin_jacobian[52] = -z942;
    result.rear_right_foot_origin_jacobian[2] = n0;
    result.rear_right_foot_origin_jacobian[5] = n0;
    result.rear_right_foot_origin_jacobian[8] = n1;
    result.rear_right_foot_origin_jacobian[11] = -z895;
    result.rear_right_foot_origin_jacobian[14] = -z898;
    result.rear_right_foot_origin_jacobian[17] = z901;
    result.rear_right_foot_origin_jacobian[20] = n0;
    result.rear_right_foot_origin_jacobian[23] = n0;
    result.rear_right_foot_origin_jacobian[26] = n0;
    result.rear_right_foot_origin_jacobian[29] = n0;
    result.rear_right_foot_origin_jacobian[32] = n0;
    result.rear_right_foot_origin_jacobian[35] = n0;
    result.rear_right_foot_origin_jacobian[38] = n0;
    result.rear_right_foot_origin_jacobian[41] = n0;
    result.rear_right_foot_origin_jacobian[44] = n0;
    result.rear_right_foot_origin_jacobian[47] = z910;
    result.rear_right_foot_origin_jacobian[50] = z925;
    result.rear_right_foot_origin_jacobian[53] = z943;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state,
      std::array<Scalar, 324>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k3 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k7 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k10 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k11 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar k12 = traits::constant(0.0329736, 0.0329736f, "41217/1250000");
    const Scalar k13 = traits::constant(0.0325736, 0.0325736f, "40717/1250000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar k17 = traits::constant(0.4664944, 0.4664944f, "291559/625000");
    const Scalar k18 = traits::constant(0.4970944, 0.4970944f, "77671/156250");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z944 = n0_032 * c_rear_right_knee;
    const Scalar z945 = n0_032 * s_rear_right_knee;
    const Scalar z946 = k3 + n0_2 * z944;
    const Scalar z947 = s_rear_right_thigh * z945 - c_rear_right_thigh * z944;
    const Scalar z948 = s_rear_right_thigh * z944 + c_rear_right_thigh * z945;
    const Scalar z949 = n0_08 * z948;
    const Scalar z950 = n0_08 * z947;
    const Scalar z951 = s_rear_right_hip * z948;
    const Scalar z952 = c_rear_right_hip * z948;
    const Scalar z953 = s_rear_right_hip * z950 - c_rear_right_hip * z946;
    const Scalar z954 = s_rear_right_hip * z946 + c_rear_right_hip * z950;
    const Scalar z955 = z949 + n0_05 * z952;
    const Scalar z956 = n0_2 * z952 - z953;
    const Scalar z957 = n0_05 * z947 + n0_2 * z951 + z954;
    const Scalar z958 = z17 * z947 - z18 * z951 + z30 * z952;
    const Scalar z959 = z19 * z947 - z23 * z951 + z24 * z952;
    const Scalar z960 = z25 * z951 - z28 * z952 - z29 * z947;
    const Scalar z968 = k7 * s_rear_right_knee;
    const Scalar z969 = s_rear_right_knee * z968;
    const Scalar z970 = k7 - z969;
    const Scalar z971 = c_rear_right_knee * z968;
    const Scalar z972 = n0_4 * z944 - z969;
    const Scalar z973 = n0_2 * z945 + z971;
    const Scalar z974 = k3 + n0_4 * z944;
    const Scalar z975 = n0_124 + z944;
    const Scalar z976 = k10 + z974;
    const Scalar z977 = k11 + z970;
    const Scalar z978 = s_rear_right_thigh * z945 - c_rear_right_thigh * z975;
    const Scalar z979 = s_rear_right_thigh * z975 + c_rear_right_thigh * z945;
    const Scalar z980 = n0_08 * z979;
    const Scalar z981 = n0_08 * z978;
    const Scalar z982 = s_rear_right_hip * z979;
    const Scalar z983 = c_rear_right_hip * z979;
    const Scalar z984 = s_rear_right_hip * z981 - c_rear_right_hip * z976;
    const Scalar z985 = s_rear_right_hip * z976 + c_rear_right_hip * z981;
    const Scalar z986 = z980 + n0_05 * z983;
    const Scalar z987 = n0_2 * z983 - z984;
    const Scalar z988 = n0_05 * z978 + n0_2 * z982 + z985;
    const Scalar z989 = z17 * z978 - z18 * z982 + z30 * z983;
    const Scalar z990 = z19 * z978 - z23 * z982 + z24 * z983;
    const Scalar z991 = z25 * z982 - z28 * z983 - z29 * z978;
    const Scalar z999 = z972 + z977;
    const Scalar z1000 = n2 * z973;
    const Scalar z1001 = s_rear_right_thigh * z999 + c_rear_right_thigh * z1000;
    const Scalar z1002 = s_rear_right_thigh * z1001;
    const Scalar z1003 = z977 - z1002;
    const Scalar z1004 = z972 - z1002;
    const Scalar z1005 = c_rear_right_thigh * z1001 - z973;
    const Scalar z1006 = k12 + z1004;
    const Scalar z1007 = k13 - z976;
    const Scalar z1008 = n0_1048 * s_rear_right_hip - c_rear_right_hip * z978;
    const Scalar z1009 = s_rear_right_hip * z978 + n0_1048 * c_rear_right_hip;
    const Scalar z1010 = s_rear_right_hip * z1005 - c_rear_right_hip * z980;
    const Scalar z1011 = s_rear_right_hip * z980 + c_rear_right_hip * z1005;
    const Scalar z1012 = z1006 + n0_05 * z1009;
    const Scalar z1013 = n0_2 * z1009 - z1010;
    const Scalar z1014 = n0_2 * z1008 + z1011;
    const Scalar z1015 = z18 * z1008 - z30 * z1009;
    const Scalar z1016 = z23 * z1008 - z24 * z1009;
    const Scalar z1017 = z25 * z1008 - z28 * z1009;
    const Scalar z1025 = z1003 - z1007;
    const Scalar z1026 = n2 * z981;
    const Scalar z1027 = s_rear_right_hip * z1025 + c_rear_right_hip * z1026;
    const Scalar z1028 = s_rear_right_hip * z1027;
    const Scalar z1029 = z1007 + z1028;
    const Scalar z1030 = z1003 - z1028;
    const Scalar z1031 = c_rear_right_hip * z1027 - z981;
    const Scalar z1032 = z1006 + n0_1 * z1009;
    const Scalar z1033 = n0_05 * z979 + n0_2 * z1009 - z1010;
    const Scalar z1034 = n0_4 * z979 - z1029;
    const Scalar z1035 = n0_05 * z1008 - z1031;
    const Scalar z1036 = n0_4 * z979 + n0_1 * z1009 - z1030;
    const Scalar z1037 = n0_0406 + z1032;
    const Scalar z1038 = k17 + z1034;
    const Scalar z1039 = k18 + z1036;
    const Scalar z1040 = n0_032 * c_rear_left_knee;
    const Scalar z1041 = n0_032 * s_rear_left_knee;
    const Scalar z1042 = k3 + n0_2 * z1040;
    const Scalar z1043 = s_rear_left_thigh * z1041 - c_rear_left_thigh * z1040;
    const Scalar z1044 = s_rear_left_thigh * z1040 + c_rear_left_thigh * z1041;
    const Scalar z1045 = n0_08 * z1044;
    const Scalar z1046 = n0_08 * z1043;
    const Scalar z1047 = s_rear_left_hip * z1044;
    const Scalar z1048 = c_rear_left_hip * z1044;
    const Scalar z1049 = s_rear_left_hip * z1046 + c_rear_left_hip * z1042;
    const Scalar z1050 = s_rear_left_hip * z1042 - c_rear_left_hip * z1046;
    const Scalar z1051 = z1045 + n0_05 * z1048;
    const Scalar z1052 = n0_2 * z1048 + z1049;
    const Scalar z1053 = n0_05 * z1043 - n0_2 * z1047 - z1050;
    const Scalar z1054 = z17 * z1043 - z18 * z1047 + z30 * z1048;
    const Scalar z1055 = z19 * z1043 - z23 * z1047 + z24 * z1048;
    const Scalar z1056 = z25 * z1047 - z28 * z1048 - z29 * z1043;
    const Scalar z1064 = k7 * s_rear_left_knee;
    const Scalar z1065 = s_rear_left_knee * z1064;
    const Scalar z1066 = k7 - z1065;
    const Scalar z1067 = c_rear_left_knee * z1064;
    const Scalar z1068 = n0_4 * z1040 - z1065;
    const Scalar z1069 = n0_2 * z1041 + z1067;
    const Scalar z1070 = k3 + n0_4 * z1040;
    const Scalar z1071 = n0_124 + z1040;
    const Scalar z1072 = k10 + z1070;
    const Scalar z1073 = k11 + z1066;
    const Scalar z1074 = s_rear_left_thigh * z1041 - c_rear_left_thigh * z1071;
    const Scalar z1075 = s_rear_left_thigh * z1071 + c_rear_left_thigh * z1041;
    const Scalar z1076 = n0_08 * z1075;
    const Scalar z1077 = n0_08 * z1074;
    const Scalar z1078 = s_rear_left_hip * z1075;
    const Scalar z1079 = c_rear_left_hip * z1075;
    const Scalar z1080 = s_rear_left_hip * z1077 + c_rear_left_hip * z1072;
    const Scalar z1081 = s_rear_left_hip * z1072 - c_rear_left_hip * z1077;
    const Scalar z1082 = z1076 + n0_05 * z1079;
    const Scalar z1083 = n0_2 * z1079 + z1080;
    const Scalar z1084 = n0_05 * z1074 - n0_2 * z1078 - z1081;
    const Scalar z1085 = z17 * z1074 - z18 * z1078 + z30 * z1079;
    const Scalar z1086 = z19 * z1074 - z23 * z1078 + z24 * z1079;
    const Scalar z1087 = z25 * z1078 - z28 * z1079 - z29 * z1074;
    const Scalar z1095 = z1068 + z1073;
    const Scalar z1096 = n2 * z1069;
    const Scalar z1097 = s_rear_left_thigh * z1095 + c_rear_left_thigh * z1096;
    const Scalar z1098 = s_rear_left_thigh * z1097;
    const Scalar z1099 = z1073 - z1098;
    const Scalar z1100 = z1068 - z1098;
    const Scalar z1101 = c_rear_left_thigh * z1097 - z1069;
    const Scalar z1102 = k12 + z1100;
    const Scalar z1103 = k13 - z1072;
    const Scalar z1104 = n0_1048 * s_rear_left_hip + c_rear_left_hip * z1074;
    const Scalar z1105 = s_rear_left_hip * z1074 - n0_1048 * c_rear_left_hip;
    const Scalar z1106 = s_rear_left_hip * z1101 + c_rear_left_hip * z1076;
    const Scalar z1107 = s_rear_left_hip * z1076 - c_rear_left_hip * z1101;
    const Scalar z1108 = z1102 - n0_05 * z1105;
    const Scalar z1109 = n0_2 * z1105 - z1106;
    const Scalar z1110 = n0_2 * z1104 + z1107;
    const Scalar z1111 = z18 * z1104 + z30 * z1105;
    const Scalar z1112 = z23 * z1104 + z24 * z1105;
    const Scalar z1113 = z25 * z1104 + z28 * z1105;
    const Scalar z1121 = z1099 - z1103;
    const Scalar z1122 = n2 * z1077;
    const Scalar z1123 = s_rear_left_hip * z1121 - c_rear_left_hip * z1122;
    const Scalar z1124 = s_rear_left_hip * z1123;
    const Scalar z1125 = z1103 + z1124;
    const Scalar z1126 = z1099 - z1124;
    const Scalar z1127 = c_rear_left_hip * z1123 + z1077;
    const Scalar z1128 = z1102 - n0_1 * z1105;
    const Scalar z1129 = n0_05 * z1075 - n0_2 * z1105 + z1106;
    const Scalar z1130 = n0_4 * z1075 - z1125;
    const Scalar z1131 = n0_05 * z1104 - z1127;
    const Scalar z1132 = n0_4 * z1075 - n0_1 * z1105 - z1126;
    const Scalar z1133 = z979 + z1075;
    const Scalar z1134 = z1009 + z1105;
    const Scalar z1135 = z1008 - z1104;
    const Scalar z1136 = z1037 + z1128;
    const Scalar z1137 = z1033 - z1129;
    const Scalar z1138 = z1038 + z1130;
    const Scalar z1139 = z1014 - z1110;
    const Scalar z1140 = z1035 + z1131;
    const Scalar z1141 = z1039 + z1132;
    const Scalar z1142 = n0_032 * c_front_right_knee;
    const Scalar z1143 = n0_032 * s_front_right_knee;
    const Scalar z1144 = k3 + n0_2 * z1142;
    const Scalar z1145 = s_front_right_thigh * z1143 - c_front_right_thigh * z1142;
    const Scalar z1146 = s_front_right_thigh * z1142 + c_front_right_thigh * z1143;
    const Scalar z1147 = n0_08 * z1146;
    const Scalar z1148 = n0_08 * z1145;
    const Scalar z1149 = s_front_right_hip * z1146;
    const Scalar z1150 = c_front_right_hip * z1146;
    const Scalar z1151 = s_front_right_hip * z1148 - c_front_right_hip * z1144;
    const Scalar z1152 = s_front_right_hip * z1144 + c_front_right_hip * z1148;
    const Scalar z1153 = z1147 + n0_05 * z1150;
    const Scalar z1154 = n0_2 * z1150 + z1151;
    const Scalar z1155 = n0_05 * z1145 - n0_2 * z1149 + z1152;
    const Scalar z1156 = z17 * z1145 - z18 * z1149 + z30 * z1150;
    const Scalar z1157 = z19 * z1145 - z23 * z1149 + z24 * z1150;
    const Scalar z1158 = z25 * z1149 - z28 * z1150 - z29 * z1145;
    const Scalar z1166 = k7 * s_front_right_knee;
    const Scalar z1167 = s_front_right_knee * z1166;
    const Scalar z1168 = k7 - z1167;
    const Scalar z1169 = c_front_right_knee * z1166;
    const Scalar z1170 = n0_4 * z1142 - z1167;
    const Scalar z1171 = n0_2 * z1143 + z1169;
    const Scalar z1172 = k3 + n0_4 * z1142;
    const Scalar z1173 = n0_124 + z1142;
    const Scalar z1174 = k10 + z1172;
    const Scalar z1175 = k11 + z1168;
    const Scalar z1176 = s_front_right_thigh * z1143 - c_front_right_thigh * z1173;
    const Scalar z1177 = s_front_right_thigh * z1173 + c_front_right_thigh * z1143;
    const Scalar z1178 = n0_08 * z1177;
    const Scalar z1179 = n0_08 * z1176;
    const Scalar z1180 = s_front_right_hip * z1177;
    const Scalar z1181 = c_front_right_hip * z1177;
    const Scalar z1182 = s_front_right_hip * z1179 - c_front_right_hip * z1174;
    const Scalar z1183 = s_front_right_hip * z1174 + c_front_right_hip * z1179;
    const Scalar z1184 = z1178 + n0_05 * z1181;
    const Scalar z1185 = n0_2 * z1181 + z1182;
    const Scalar z1186 = n0_05 * z1176 - n0_2 * z1180 + z1183;
    const Scalar z1187 = z17 * z1176 - z18 * z1180 + z30 * z1181;
    const Scalar z1188 = z19 * z1176 - z23 * z1180 + z24 * z1181;
    const Scalar z1189 = z25 * z1180 - z28 * z1181 - z29 * z1176;
    const Scalar z1197 = z1170 + z1175;
    const Scalar z1198 = n2 * z1171;
    const Scalar z1199 = s_front_right_thigh * z1197 + c_front_right_thigh * z1198;
    const Scalar z1200 = s_front_right_thigh * z1199;
    const Scalar z1201 = z1175 - z1200;
    const Scalar z1202 = z1170 - z1200;
    const Scalar z1203 = c_front_right_thigh * z1199 - z1171;
    const Scalar z1204 = k12 + z1202;
    const Scalar z1205 = k13 - z1174;
    const Scalar z1206 = n0_1048 * s_front_right_hip - c_front_right_hip * z1176;
    const Scalar z1207 = s_front_right_hip * z1176 + n0_1048 * c_front_right_hip;
    const Scalar z1208 = s_front_right_hip * z1203 - c_front_right_hip * z1178;
    const Scalar z1209 = s_front_right_hip * z1178 + c_front_right_hip * z1203;
    const Scalar z1210 = z1204 + n0_05 * z1207;
    const Scalar z1211 = n0_2 * z1207 + z1208;
    const Scalar z1212 = n0_2 * z1206 - z1209;
    const Scalar z1213 = z18 * z1206 - z30 * z1207;
    const Scalar z1214 = z23 * z1206 - z24 * z1207;
    const Scalar z1215 = z25 * z1206 - z28 * z1207;
    const Scalar z1223 = z1201 - z1205;
    const Scalar z1224 = n2 * z1179;
    const Scalar z1225 = s_front_right_hip * z1223 + c_front_right_hip * z1224;
    const Scalar z1226 = s_front_right_hip * z1225;
    const Scalar z1227 = z1205 + z1226;
    const Scalar z1228 = z1201 - z1226;
    const Scalar z1229 = c_front_right_hip * z1225 - z1179;
    const Scalar z1230 = z1204 + n0_1 * z1207;
    const Scalar z1231 = n0_05 * z1177 - n0_2 * z1207 - z1208;
    const Scalar z1232 = n0_4 * z1177 + z1227;
    const Scalar z1233 = n0_05 * z1206 - z1229;
    const Scalar z1234 = n0_4 * z1177 - n0_1 * z1207 + z1228;
    const Scalar z1235 = z1133 + z1177;
    const Scalar z1236 = z1134 + z1207;
    const Scalar z1237 = z1135 + z1206;
    const Scalar z1238 = z1136 + z1230;
    const Scalar z1239 = z1137 + z1231;
    const Scalar z1240 = z1138 - z1232;
    const Scalar z1241 = z1139 - z1212;
    const Scalar z1242 = z1140 + z1233;
    const Scalar z1243 = z1141 - z1234;
    const Scalar z1244 = n0_032 * c_front_left_knee;
    const Scalar z1245 = n0_032 * s_front_left_knee;
    const Scalar z1246 = k3 + n0_2 * z1244;
    const Scalar z1247 = s_front_left_thigh * z1245 - c_front_left_thigh * z1244;
    const Scalar z1248 = s_front_left_thigh * z1244 + c_front_left_thigh * z1245;
    const Scalar z1249 = n0_08 * z1248;
    const Scalar z1250 = n0_08 * z1247;
    const Scalar z1251 = s_front_left_hip * z1248;
    const Scalar z1252 = c_front_left_hip * z1248;
    const Scalar z1253 = s_front_left_hip * z1250 + c_front_left_hip * z1246;
    const Scalar z1254 = s_front_left_hip * z1246 - c_front_left_hip * z1250;
    const Scalar z1255 = z1249 + n0_05 * z1252;
    const Scalar z1256 = n0_2 * z1252 - z1253;
    const Scalar z1257 = n0_05 * z1247 + n0_2 * z1251 - z1254;
    const Scalar z1258 = z17 * z1247 - z18 * z1251 + z30 * z1252;
    const Scalar z1259 = z19 * z1247 - z23 * z1251 + z24 * z1252;
    const Scalar z1260 = z25 * z1251 - z28 * z1252 - z29 * z1247;
    const Scalar z1268 = k7 * s_front_left_knee;
    const Scalar z1269 = s_front_left_knee * z1268;
    const Scalar z1270 = k7 - z1269;
    const Scalar z1271 = c_front_left_knee * z1268;
    const Scalar z1272 = n0_4 * z1244 - z1269;
    const Scalar z1273 = n0_2 * z1245 + z1271;
    const Scalar z1274 = k3 + n0_4 * z1244;
    const Scalar z1275 = n0_124 + z1244;
    const Scalar z1276 = k10 + z1274;
    const Scalar z1277 = k11 + z1270;
    const Scalar z1278 = s_front_left_thigh * z1245 - c_front_left_thigh * z1275;
    const Scalar z1279 = s_front_left_thigh * z1275 + c_front_left_thigh * z1245;
    const Scalar z1280 = n0_08 * z1279;
    const Scalar z1281 = n0_08 * z1278;
    const Scalar z1282 = s_front_left_hip * z1279;
    const Scalar z1283 = c_front_left_hip * z1279;
    const Scalar z1284 = s_front_left_hip * z1281 + c_front_left_hip * z1276;
    const Scalar z1285 = s_front_left_hip * z1276 - c_front_left_hip * z1281;
    const Scalar z1286 = z1280 + n0_05 * z1283;
    const Scalar z1287 = n0_2 * z1283 - z1284;
    const Scalar z1288 = n0_05 * z1278 + n0_2 * z1282 - z1285;
    const Scalar z1289 = z17 * z1278 - z18 * z1282 + z30 * z1283;
    const Scalar z1290 = z19 * z1278 - z23 * z1282 + z24 * z1283;
    const Scalar z1291 = z25 * z1282 - z28 * z1283 - z29 * z1278;
    const Scalar z1299 = z1272 + z1277;
    const Scalar z1300 = n2 * z1273;
    const Scalar z1301 = s_front_left_thigh * z1299 + c_front_left_thigh * z1300;
    const Scalar z1302 = s_front_left_thigh * z1301;
    const Scalar z1303 = z1277 - z1302;
    const Scalar z1304 = z1272 - z1302;
    const Scalar z1305 = c_front_left_thigh * z1301 - z1273;
    const Scalar z1306 = k12 + z1304;
    const Scalar z1307 = k13 - z1276;
    const Scalar z1308 = n0_1048 * s_front_left_hip + c_front_left_hip * z1278;
    const Scalar z1309 = s_front_left_hip * z1278 - n0_1048 * c_front_left_hip;
    const Scalar z1310 = s_front_left_hip * z1305 + c_front_left_hip * z1280;
    const Scalar z1311 = s_front_left_hip * z1280 - c_front_left_hip * z1305;
    const Scalar z1312 = z1306 - n0_05 * z1309;
    const Scalar z1313 = n0_2 * z1309 + z1310;
    const Scalar z1314 = n0_2 * z1308 - z1311;
    const Scalar z1315 = z18 * z1308 + z30 * z1309;
    const Scalar z1316 = z23 * z1308 + z24 * z1309;
    const Scalar z1317 = z25 * z1308 + z28 * z1309;
    const Scalar z1325 = z1303 - z1307;
    const Scalar z1326 = n2 * z1281;
    const Scalar z1327 = s_front_left_hip * z1325 - c_front_left_hip * z1326;
    const Scalar z1328 = s_front_left_hip * z1327;
    const Scalar z1329 = z1307 + z1328;
    const Scalar z1330 = z1303 - z1328;
    const Scalar z1331 = c_front_left_hip * z1327 + z1281;
    const Scalar z1332 = z1306 - n0_1 * z1309;
    const Scalar z1333 = n0_05 * z1279 + n0_2 * z1309 + z1310;
    const Scalar z1334 = n0_4 * z1279 + z1329;
    const Scalar z1335 = n0_05 * z1308 - z1331;
    const Scalar z1336 = n0_4 * z1279 + n0_1 * z1309 + z1330;
    const Scalar z1337 = z1235 + z1279;
    const Scalar z1338 = z1236 + z1309;
    const Scalar z1339 = z1237 - z1308;
    const Scalar z1340 = z1238 + z1332;
    const Scalar z1341 = z1239 - z1333;
    const Scalar z1342 = z1240 - z1334;
    const Scalar z1343 = z1241 + z1314;
    const Scalar z1344 = z1242 + z1335;
    const Scalar z1345 = z1243 - z1336;
    const Scalar z1346 = z17 * z1338 - z18 * z1337;
    const Scalar z1347 = z19 * z1338 - z23 * z1337;
    const Scalar z1348 = z25 * z1337 - z29 * z1338;
    const Scalar z1356 = z17 * z1339 - z30 * z1337;
    const Scalar z1357 = z19 * z1339 - z24 * z1337;
    const Scalar z1358 = z28 * z1337 - z29 * z1339;
    const Scalar z1366 = z18 * z1339 - z30 * z1338;
    const Scalar z1367 = z23 * z1339 - z24 * z1338;
    const Scalar z1368 = z25 * z1339 - z28 * z1338;
    mass[0] = n12_24;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z1366;
    mass[4] = -z1356;
    mass[5] = z1346;
    mass[6] = -z1315;
    mass[7] = z1289;
    mass[8] = z1258;
    mass[9] = z1213;
    mass[10] = z1187;
    mass[11] = z1156;
    mass[12] = -z1111;
    mass[13] = z1085;
    mass[14] = z1054;
    mass[15] = z1015;
    mass[16] = z989;
    mass[17] = z958;
    mass[18] = n0;
    mass[19] = n12_24;
    mass[20] = n0;
    mass[21] = z1367;
    mass[22] = -z1357;
    mass[23] = z1347;
    mass[24] = -z1316;
    mass[25] = z1290;
    mass[26] = z1259;
    mass[27] = z1214;
    mass[28] = z1188;
    mass[29] = z1157;
    mass[30] = -z1112;
    mass[31] = z1086;
    mass[32] = z1055;
    mass[33] = z1016;
    mass[34] = z990;
    mass[35] = z959;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n12_24;
    mass[39] = z1368;
    mass[40] = z1358;
    mass[41] = -z1348;
    mass[42] = -z1317;
    mass[43] = -z1291;
    mass[44] = -z1260;
    mass[45] = z1215;
    mass[46] = -z1189;
    mass[47] = -z1158;
    mass[48] = -z1113;
    mass[49] = -z1087;
    mass[50] = -z1056;
    mass[51] = z1017;
    mass[52] = -z991;
    mass[53] = -z960;
    mass[54] = z1366;
    mass[55] = z1367;
    mass[56] = z1368;
    mass[57] = z1340;
    mass[58] = -z1341;
    mass[59] = -z1343;
    mass[60] = z1312;
    mass[61] = z1286;
    mass[62] = z1255;
    mass[63] = z1210;
    mass[64] = -z1184;
    mass[65] = -z1153;
    mass[66] = z1108;
    mass[67] = z1082;
    mass[68] = z1051;
    mass[69] = z1012;
    mass[70] = -z986;
    mass[71] = -z955;
    mass[72] = -z1356;
    mass[73] = -z1357;
    mass[74] = z1358;
    mass[75] = -z1341;
    mass[76] = z1342;
    mass[77] = -z1344;
    mass[78] = z1313;
    mass[79] = -z1287;
    mass[80] = -z1256;
    mass[81] = z1211;
    mass[82] = -z1185;
    mass[83] = -z1154;
    mass[84] = -z1109;
    mass[85] = z1083;
    mass[86] = z1052;
    mass[87] = -z1013;
    mass[88] = z987;
    mass[89] = z956;
    mass[90] = z1346;
    mass[91] = z1347;
    mass[92] = -z1348;
    mass[93] = -z1343;
    mass[94] = -z1344;
    mass[95] = z1345;
    mass[96] = -z1314;
    mass[97] = -z1288;
    mass[98] = -z1257;
    mass[99] = z1212;
    mass[100] = z1186;
    mass[101] = z1155;
    mass[102] = z1110;
    mass[103] = -z1084;
    mass[104] = -z1053;
    mass[105] = -z1014;
    mass[106] = z988;
    mass[107] = z957;
    mass[108] = -z1315;
    mass[109] = -z1316;
    mass[110] = -z1317;
    mass[111] = z1312;
    mass[112] = z1313;
    mass[113] = -z1314;
    mass[114] = z1306;
    mass[115] = z1280;
    mass[116] = z1249;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n0;
    mass[121] = n0;
    mass[122] = n0;
    mass[123] = n0;
    mass[124] = n0;
    mass[125] = n0;
    mass[126] = z1289;
    mass[127] = z1290;
    mass[128] = -z1291;
    mass[129] = z1286;
    mass[130] = -z1287;
    mass[131] = -z1288;
    mass[132] = z1280;
    mass[133] = z1276;
    mass[134] = z1246;
    mass[135] = n0;
    mass[136] = n0;
    mass[137] = n0;
    mass[138] = n0;
    mass[139] = n0;
    mass[140] = n0;
    mass[141] = n0;
    mass[142] = n0;
    mass[143] = n0;
    mass[144] = z1258;
    mass[145] = z1259;
    mass[146] = -z1260;
    mass[147] = z1255;
    mass[148] = -z1256;
    mass[149] = -z1257;
    mass[150] = z1249;
    mass[151] = z1246;
    mass[152] = k3;
    mass[153] = n0;
    mass[154] = n0;
    mass[155] = n0;
    mass[156] = n0;
    mass[157] = n0;
    mass[158] = n0;
    mass[159] = n0;
    mass[160] = n0;
    mass[161] = n0;
    mass[162] = z1213;
    mass[163] = z1214;
    mass[164] = z1215;
    mass[165] = z1210;
    mass[166] = z1211;
    mass[167] = z1212;
    mass[168] = n0;
    mass[169] = n0;
    mass[170] = n0;
    mass[171] = z1204;
    mass[172] = -z1178;
    mass[173] = -z1147;
    mass[174] = n0;
    mass[175] = n0;
    mass[176] = n0;
    mass[177] = n0;
    mass[178] = n0;
    mass[179] = n0;
    mass[180] = z1187;
    mass[181] = z1188;
    mass[182] = -z1189;
    mass[183] = -z1184;
    mass[184] = -z1185;
    mass[185] = z1186;
    mass[186] = n0;
    mass[187] = n0;
    mass[188] = n0;
    mass[189] = -z1178;
    mass[190] = z1174;
    mass[191] = z1144;
    mass[192] = n0;
    mass[193] = n0;
    mass[194] = n0;
    mass[195] = n0;
    mass[196] = n0;
    mass[197] = n0;
    mass[198] = z1156;
    mass[199] = z1157;
    mass[200] = -z1158;
    mass[201] = -z1153;
    mass[202] = -z1154;
    mass[203] = z1155;
    mass[204] = n0;
    mass[205] = n0;
    mass[206] = n0;
    mass[207] = -z1147;
    mass[208] = z1144;
    mass[209] = k3;
    mass[210] = n0;
    mass[211] = n0;
    mass[212] = n0;
    mass[213] = n0;
    mass[214] = n0;
    mass[215] = n0;
    mass[216] = -z1111;
    mass[217] = -z1112;
    mass[218] = -z1113;
    mass[219] = z1108;
    mass[220] = -z1109;
    mass[221] = z1110;
    mass[222] = n0;
    mass[223] = n0;
    mass[224] = n0;
    mass[225] = n0;
    mass[226] = n0;
    mass[227] = n0;
    mass[228] = z1102;
    mass[229] = z1076;
    mass[230] = z1045;
    mass[231] = n0;
    mass[232] = n0;
    mass[233] = n0;
    mass[234] = z1085;
    mass[235] = z1086;
    mass[236] = -z1087;
    mass[237] = z1082;
    mass[238] = z1083;
    mass[239] = -z1084;
    mass[240] = n0;
    mass[241] = n0;
    mass[242] = n0;
    mass[243] = n0;
    mass[244] = n0;
    mass[245] = n0;
    mass[246] = z1076;
    mass[247] = z1072;
    mass[248] = z1042;
    mass[249] = n0;
    mass[250] = n0;
    mass[251] = n0;
    mass[252] = z1054;
    mass[253] = z1055;
    mass[254] = -z1056;
    mass[255] = z1051;
    mass[256] = z1052;
    mass[257] = -z1053;
    mass[258] = n0;
    mass[259] = n0;
    mass[260] = n0;
    mass[261] = n0;
    mass[262] = n0;
    mass[263] = n0;
    mass[264] = z1045;
    mass[265] = z1042;
    mass[266] = k3;
    mass[267] = n0;
    mass[268] = n0;
    mass[269] = n0;
    mass[270] = z1015;
    mass[271] = z1016;
    mass[272] = z1017;
    mass[273] = z1012;
    mass[274] = -z1013;
    mass[275] = -z1014;
    mass[276] = n0;
    mass[277] = n0;
    mass[278] = n0;
    mass[279] = n0;
    mass[280] = n0;
    mass[281] = n0;
    mass[282] = n0;
    mass[283] = n0;
    mass[284] = n0;
    mass[285] = z1006;
    mass[286] = -z980;
    mass[287] = -z949;
    mass[288] = z989;
    mass[289] = z990;
    mass[290] = -z991;
    mass[291] = -z986;
    mass[292] = z987;
    mass[293] = z988;
    mass[294] = n0;
    mass[295] = n0;
    mass[296] = n0;
    mass[297] = n0;
    mass[298] = n0;
    mass[299] = n0;
    mass[300] = n0;
    mass[301] = n0;
    mass[302] = n0;
    mass[303] = -z980;
    mass[304] = z976;
    mass[305] = z946;
    mass[306] = z958;
    mass[307] = z959;
    mass[308] = -z960;
    mass[309] = -z955;
    mass[310] = z956;
    mass[311] = z957;
    mass[312] = n0;
    mass[313] = n0;
    mass[314] = n0;
    mass[315] = n0;
    mass[316] = n0;
    mass[317] = n0;
    mass[318] = n0;
    mass[319] = n0;
    mass[320] = n0;
    mass[321] = -z949;
    mass[322] = z946;
    mass[323] = k3;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k7 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k8 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k9 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar k10 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k12 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar k13 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k14 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k17 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
    const Scalar k18 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z103 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z104 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z107 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z110 = s_front_left_thigh * z104 + c_front_left_thigh * z107;
    const Scalar z111 = s_front_left_thigh * z107 - c_front_left_thigh * z104;
    const Scalar z114 = v_front_left_thigh + z103;  // angular velocity of front_left_thigh_link, y
    const Scalar z117 = s_front_left_knee * z111 - c_front_left_knee * z110;
    const Scalar z118 = s_front_left_knee * z110 + c_front_left_knee * z111;
    const Scalar z121 = v_front_left_knee + z114;  // angular velocity of front_left_shank_link, y
    const Scalar z124 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z125 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z128 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z131 = s_front_right_thigh * z125 + c_front_right_thigh * z128;
    const Scalar z132 = s_front_right_thigh * z128 - c_front_right_thigh * z125;
    const Scalar z135 = v_front_right_thigh + z124;  // angular velocity of front_right_thigh_link, y
    const Scalar z138 = s_front_right_knee * z132 - c_front_right_knee * z131;
    const Scalar z139 = s_front_right_knee * z131 + c_front_right_knee * z132;
    const Scalar z142 = v_front_right_knee + z135;  // angular velocity of front_right_shank_link, y
    const Scalar z145 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z146 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z149 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z152 = s_rear_left_thigh * z146 + c_rear_left_thigh * z149;
    const Scalar z153 = s_rear_left_thigh * z149 - c_rear_left_thigh * z146;
    const Scalar z156 = v_rear_left_thigh + z145;  // angular velocity of rear_left_thigh_link, y
    const Scalar z159 = s_rear_left_knee * z153 - c_rear_left_knee * z152;
    const Scalar z160 = s_rear_left_knee * z152 + c_rear_left_knee * z153;
    const Scalar z163 = v_rear_left_knee + z156;  // angular velocity of rear_left_shank_link, y
    const Scalar z165 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z166 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z169 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z172 = s_rear_right_thigh * z166 + c_rear_right_thigh * z169;
    const Scalar z173 = s_rear_right_thigh * z169 - c_rear_right_thigh * z166;
    const Scalar z176 = v_rear_right_thigh + z165;  // angular velocity of rear_right_thigh_link, y
    const Scalar z179 = s_rear_right_knee * z173 - c_rear_right_knee * z172;
    const Scalar z180 = s_rear_right_knee * z172 + c_rear_right_knee * z173;
    const Scalar z183 = v_rear_right_knee + z176;  // angular velocity of rear_right_shank_link, y
    const Scalar z1399 = n0_05 * v_front_left_hip;
    const Scalar z1401 = n0_05 * v_front_left_thigh;
    const Scalar z1403 = n0_05 * v_front_left_knee;
    const Scalar z1405 = n0_05 * v_front_right_hip;
    const Scalar z1407 = n0_05 * v_front_right_thigh;
    const Scalar z1409 = n0_05 * v_front_right_knee;
    const Scalar z1411 = n0_05 * v_rear_left_hip;
    const Scalar z1413 = n0_05 * v_rear_left_thigh;
    const Scalar z1415 = n0_05 * v_rear_left_knee;
    const Scalar z1417 = n0_05 * v_rear_right_hip;
    const Scalar z1419 = n0_05 * v_rear_right_thigh;
    const Scalar z1421 = n0_05 * v_rear_right_knee;
    const Scalar z1422 = n9_81 * z29;
    const Scalar z1423 = n9_81 * z25;
    const Scalar z1424 = n9_81 * z28;
    const Scalar z1425 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z1426 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z1427 = z1425 + z1426;
    const Scalar z1428 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z1429 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z1430 = z1426 + z1429;
    const Scalar z1431 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z1432 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z1433 = z1422 - n0_2 * z1427 + n0_05 * z1428;
    const Scalar z1434 = z1423 + n0_2 * z1428 - n0_05 * z1430;
    const Scalar z1435 = z1424 + n0_2 * z1431 + n0_05 * z1432;
    const Scalar z1436 = s_front_left_hip * z1435 + c_front_left_hip * z1434;
    const Scalar z1437 = s_front_left_hip * z1434 - c_front_left_hip * z1435;
    const Scalar z1438 = v_front_left_hip * z104;  // angular acceleration of front_left_hip_link, y
    const Scalar z1439 = v_front_left_hip * z103;  // angular acceleration of front_left_hip_link, z
    const Scalar z1440 = z103 * z107;
    const Scalar z1441 = z1439 + z1440;
    const Scalar z1442 = z104 * z104;
    const Scalar z1443 = z107 * z107;
    const Scalar z1444 = z1442 + z1443;
    const Scalar z1445 = z103 * z104;
    const Scalar z1446 = s_front_left_thigh * z1439;
    const Scalar z1447 = c_front_left_thigh * z1439;
    const Scalar z1448 = z1433 + n0_08 * z1441;
    const Scalar z1449 = z1436 - n0_08 * z1444;
    const Scalar z1450 = z1437 + n0_08 * z1445;
    const Scalar z1451 = s_front_left_thigh * z1450 + c_front_left_thigh * z1448;
    const Scalar z1452 = s_front_left_thigh * z1448 - c_front_left_thigh * z1450;
    const Scalar z1453 = v_front_left_thigh * z111 - z1446;  // angular acceleration of front_left_thigh_link, x
    const Scalar z1454 = v_front_left_thigh * z110 - z1447;  // angular acceleration of front_left_thigh_link, z
    const Scalar z1455 = z110 * z111;
    const Scalar z1456 = z1438 - z1455;
    const Scalar z1457 = z111 * z114;
    const Scalar z1458 = z1453 + z1457;
    const Scalar z1459 = z110 * z110;
    const Scalar z1460 = z114 * z114;
    const Scalar z1461 = z1459 + z1460;
    const Scalar z1462 = s_front_left_knee * z1454 + c_front_left_knee * z1453;
    const Scalar z1463 = s_front_left_knee * z1453 - c_front_left_knee * z1454;
    const Scalar z1464 = z1451 + n0_2 * z1456;
    const Scalar z1465 = z1449 - n0_2 * z1458;
    const Scalar z1466 = z1452 + n0_2 * z1461;
    const Scalar z1467 = s_front_left_knee * z1466 - c_front_left_knee * z1464;
    const Scalar z1469 = v_front_left_knee * z118 + z1462;  // angular acceleration of front_left_shank_link, x
    const Scalar z1470 = v_front_left_knee * z117 + z1463;  // angular acceleration of front_left_shank_link, z
    const Scalar z1471 = z1422 - n0_2 * z1427 - n0_05 * z1428;
    const Scalar z1472 = z1423 + n0_2 * z1428 + n0_05 * z1430;
    const Scalar z1473 = z1424 + n0_2 * z1431 - n0_05 * z1432;
    const Scalar z1474 = s_front_right_hip * z1473 + c_front_right_hip * z1472;
    const Scalar z1475 = s_front_right_hip * z1472 - c_front_right_hip * z1473;
    const Scalar z1476 = v_front_right_hip * z125;  // angular acceleration of front_right_hip_link, y
    const Scalar z1477 = v_front_right_hip * z124;  // angular acceleration of front_right_hip_link, z
    const Scalar z1478 = z124 * z128;
    const Scalar z1479 = z1477 + z1478;
    const Scalar z1480 = z125 * z125;
    const Scalar z1481 = z128 * z128;
    const Scalar z1482 = z1480 + z1481;
    const Scalar z1483 = z124 * z125;
    const Scalar z1484 = s_front_right_thigh * z1477;
    const Scalar z1485 = c_front_right_thigh * z1477;
    const Scalar z1486 = z1471 - n0_08 * z1479;
    const Scalar z1487 = z1474 + n0_08 * z1482;
    const Scalar z1488 = z1475 - n0_08 * z1483;
    const Scalar z1489 = s_front_right_thigh * z1488 + c_front_right_thigh * z1486;
    const Scalar z1490 = s_front_right_thigh * z1486 - c_front_right_thigh * z1488;
    const Scalar z1491 = v_front_right_thigh * z132 - z1484;  // angular acceleration of front_right_thigh_link, x
    const Scalar z1492 = v_front_right_thigh * z131 - z1485;  // angular acceleration of front_right_thigh_link, z
    const Scalar z1493 = z131 * z132;
    const Scalar z1494 = z1476 - z1493;
    const Scalar z1495 = z132 * z135;
    const Scalar z1496 = z1491 + z1495;
    const Scalar z1497 = z131 * z131;
    const Scalar z1498 = z135 * z135;
    const Scalar z1499 = z1497 + z1498;
    const Scalar z1500 = s_front_right_knee * z1492 + c_front_right_knee * z1491;
    const Scalar z1501 = s_front_right_knee * z1491 - c_front_right_knee * z1492;
    const Scalar z1502 = z1489 + n0_2 * z1494;
    const Scalar z1503 = z1487 - n0_2 * z1496;
    const Scalar z1504 = z1490 + n0_2 * z1499;
    const Scalar z1505 = s_front_right_knee * z1504 - c_front_right_knee * z1502;
    const Scalar z1507 = v_front_right_knee * z139 + z1500;  // angular acceleration of front_right_shank_link, x
    const Scalar z1508 = v_front_right_knee * z138 + z1501;  // angular acceleration of front_right_shank_link, z
    const Scalar z1509 = z1422 + n0_2 * z1427 + n0_05 * z1428;
    const Scalar z1510 = z1423 - n0_2 * z1428 - n0_05 * z1430;
    const Scalar z1511 = z1424 - n0_2 * z1431 + n0_05 * z1432;
    const Scalar z1512 = s_rear_left_hip * z1511 + c_rear_left_hip * z1510;
    const Scalar z1513 = s_rear_left_hip * z1510 - c_rear_left_hip * z1511;
    const Scalar z1514 = v_rear_left_hip * z146;  // angular acceleration of rear_left_hip_link, y
    const Scalar z1515 = v_rear_left_hip * z145;  // angular acceleration of rear_left_hip_link, z
    const Scalar z1516 = z145 * z149;
    const Scalar z1517 = z1515 + z1516;
    const Scalar z1518 = z146 * z146;
    const Scalar z1519 = z149 * z149;
    const Scalar z1520 = z1518 + z1519;
    const Scalar z1521 = z145 * z146;
    const Scalar z1522 = s_rear_left_thigh * z1515;
    const Scalar z1523 = c_rear_left_thigh * z1515;
    const Scalar z1524 = z1509 + n0_08 * z1517;
    const Scalar z1525 = z1512 - n0_08 * z1520;
    const Scalar z1526 = z1513 + n0_08 * z1521;
    const Scalar z1527 = s_rear_left_thigh * z1526 + c_rear_left_thigh * z1524;
    const Scalar z1528 = s_rear_left_thigh * z1524 - c_rear_left_thigh * z1526;
    const Scalar z1529 = v_rear_left_thigh * z153 - z1522;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z1530 = v_rear_left_thigh * z152 - z1523;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z1531 = z152 * z153;
    const Scalar z1532 = z1514 - z1531;
    const Scalar z1533 = z153 * z156;
    const Scalar z1534 = z1529 + z1533;
    const Scalar z1535 = z152 * z152;
    const Scalar z1536 = z156 * z156;
    const Scalar z1537 = z1535 + z1536;
    const Scalar z1538 = s_rear_left_knee * z1530 + c_rear_left_knee * z1529;
    const Scalar z1539 = s_rear_left_knee * z1529 - c_rear_left_knee * z1530;
    const Scalar z1540 = z1527 + n0_2 * z1532;
    const Scalar z1541 = z1525 - n0_2 * z1534;
    const Scalar z1542 = z1528 + n0_2 * z1537;
    const Scalar z1543 = s_rear_left_knee * z1542 - c_rear_left_knee * z1540;
    const Scalar z1545 = v_rear_left_knee * z160 + z1538;  // angular acceleration of rear_left_shank_link, x
    const Scalar z1546 = v_rear_left_knee * z159 + z1539;  // angular acceleration of rear_left_shank_link, z
    const Scalar z1547 = z1422 + n0_2 * z1427 - n0_05 * z1428;
    const Scalar z1548 = z1423 - n0_2 * z1428 + n0_05 * z1430;
    const Scalar z1549 = z1424 - n0_2 * z1431 - n0_05 * z1432;
    const Scalar z1550 = s_rear_right_hip * z1549 + c_rear_right_hip * z1548;
    const Scalar z1551 = s_rear_right_hip * z1548 - c_rear_right_hip * z1549;
    const Scalar z1552 = v_rear_right_hip * z166;  // angular acceleration of rear_right_hip_link, y
    const Scalar z1553 = v_rear_right_hip * z165;  // angular acceleration of rear_right_hip_link, z
    const Scalar z1554 = z165 * z169;
    const Scalar z1555 = z1553 + z1554;
    const Scalar z1556 = z166 * z166;
    const Scalar z1557 = z169 * z169;
    const Scalar z1558 = z1556 + z1557;
    const Scalar z1559 = z165 * z166;
    const Scalar z1560 = s_rear_right_thigh * z1553;
    const Scalar z1561 = c_rear_right_thigh * z1553;
    const Scalar z1562 = z1547 - n0_08 * z1555;
    const Scalar z1563 = z1550 + n0_08 * z1558;
    const Scalar z1564 = z1551 - n0_08 * z1559;
    const Scalar z1565 = s_rear_right_thigh * z1564 + c_rear_right_thigh * z1562;
    const Scalar z1566 = s_rear_right_thigh * z1562 - c_rear_right_thigh * z1564;
    const Scalar z1567 = v_rear_right_thigh * z173 - z1560;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z1568 = v_rear_right_thigh * z172 - z1561;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z1569 = z172 * z173;
    const Scalar z1570 = z1552 - z1569;
    const Scalar z1571 = z173 * z176;
    const Scalar z1572 = z1567 + z1571;
    const Scalar z1573 = z172 * z172;
    const Scalar z1574 = z176 * z176;
    const Scalar z1575 = z1573 + z1574;
    const Scalar z1576 = s_rear_right_knee * z1568 + c_rear_right_knee * z1567;
    const Scalar z1577 = s_rear_right_knee * z1567 - c_rear_right_knee * z1568;
    const Scalar z1578 = z1565 + n0_2 * z1570;
    const Scalar z1579 = z1563 - n0_2 * z1572;
    const Scalar z1580 = z1566 + n0_2 * z1575;
    const Scalar z1581 = s_rear_right_knee * z1580 - c_rear_right_knee * z1578;
    const Scalar z1583 = v_rear_right_knee * z180 + z1576;  // angular acceleration of rear_right_shank_link, x
    const Scalar z1584 = v_rear_right_knee * z179 + z1577;  // angular acceleration of rear_right_shank_link, z
    const Scalar z1585 = z179 * z180;
    const Scalar z1586 = z1552 + z1585;
    const Scalar z1587 = z180 * z183;
    const Scalar z1588 = z1583 + z1587;
    const Scalar z1589 = z179 * z179;
    const Scalar z1590 = z183 * z183;
    const Scalar z1591 = z1589 + z1590;
    const Scalar z1592 = z179 * z183;
    const Scalar z1593 = z1584 + z1592;
    const Scalar z1594 = n0_032 * z1586;  // force on rear_right_shank_link, x
    const Scalar z1595 = n0_032 * z1588;  // force on rear_right_shank_link, y
    const Scalar z1596 = n0_032 * z1591;  // force on rear_right_shank_link, z
    const Scalar z1597 = n0_032 * z1579 - k7 * z1588;  // moment on rear_right_shank_link, x
    const Scalar z1598 = k8 * z1552 - n0_032 * z1581 + k9 * z1585;  // moment on rear_right_shank_link, y
    const Scalar z1599 = k10 * z1593;  // moment on rear_right_shank_link, z
    const Scalar z1600 = s_rear_right_knee * z1596 + c_rear_right_knee * z1594;
    const Scalar z1601 = s_rear_right_knee * z1594 - c_rear_right_knee * z1596;
    const Scalar z1602 = s_rear_right_knee * z1599 - c_rear_right_knee * z1597;
    const Scalar z1603 = s_rear_right_knee * z1597 + c_rear_right_knee * z1599;
    const Scalar z1604 = z172 * z176;
    const Scalar z1605 = z1568 + z1604;
    const Scalar z1606 = n0_124 * z1570 + z1600;  // force on rear_right_thigh_link, x
    const Scalar z1607 = n0_124 * z1572 + z1595;  // force on rear_right_thigh_link, y
    const Scalar z1608 = n0_124 * z1575 - z1601;  // force on rear_right_thigh_link, z
    const Scalar z1609 = n0_124 * z1563 - k12 * z1572 - n0_2 * z1595 - z1602;  // moment on rear_right_thigh_link, x
    // moment on rear_right_thigh_link, y
    const Scalar z1610 = k13 * z1552 + n0_124 * z1565 - k14 * z1569 + z1598 + n0_2 * z1600;
    const Scalar z1611 = z1603 - n0_0002 * z1605;  // moment on rear_right_thigh_link, z
    const Scalar z1612 = s_rear_right_thigh * z1608 + c_rear_right_thigh * z1606;
    const Scalar z1613 = s_rear_right_thigh * z1606 - c_rear_right_thigh * z1608;
    const Scalar z1614 = s_rear_right_thigh * z1611 - c_rear_right_thigh * z1609;
    const Scalar z1615 = s_rear_right_thigh * z1609 + c_rear_right_thigh * z1611;
    const Scalar z1616 = z166 * z169;
    const Scalar z1617 = z1552 + z1616;
    const Scalar z1618 = n0_1048 * z1555 - z1612;  // force on rear_right_hip_link, x
    const Scalar z1619 = n0_1048 * z1558 - z1607;  // force on rear_right_hip_link, y
    const Scalar z1620 = n0_1048 * z1559 - z1613;  // force on rear_right_hip_link, z
    const Scalar z1621 = n0_1048 * z1551 - k17 * z1559 + n0_08 * z1613 - z1614;  // moment on rear_right_hip_link, x
    const Scalar z1622 = z1610 + n0_0002 * z1617;  // moment on rear_right_hip_link, y
    const Scalar z1623 = n0_1048 * z1547 - k18 * z1555 + n0_08 * z1612 - z1615;  // moment on rear_right_hip_link, z
    const Scalar z1624 = s_rear_right_hip * z1620 - c_rear_right_hip * z1619;
    const Scalar z1625 = s_rear_right_hip * z1619 + c_rear_right_hip * z1620;
    const Scalar z1626 = s_rear_right_hip * z1623 + c_rear_right_hip * z1622;
    const Scalar z1627 = s_rear_right_hip * z1622 - c_rear_right_hip * z1623;
    const Scalar z1628 = z159 * z160;
    const Scalar z1629 = z1514 + z1628;
    const Scalar z1630 = z160 * z163;
    const Scalar z1631 = z1545 + z1630;
    const Scalar z1632 = z159 * z159;
    const Scalar z1633 = z163 * z163;
    const Scalar z1634 = z1632 + z1633;
    const Scalar z1635 = z159 * z163;
    const Scalar z1636 = z1546 + z1635;
    const Scalar z1637 = n0_032 * z1629;  // force on rear_left_shank_link, x
    const Scalar z1638 = n0_032 * z1631;  // force on rear_left_shank_link, y
    const Scalar z1639 = n0_032 * z1634;  // force on rear_left_shank_link, z
    const Scalar z1640 = n0_032 * z1541 - k7 * z1631;  // moment on rear_left_shank_link, x
    const Scalar z1641 = k8 * z1514 - n0_032 * z1543 + k9 * z1628;  // moment on rear_left_shank_link, y
    const Scalar z1642 = k10 * z1636;  // moment on rear_left_shank_link, z
    const Scalar z1643 = s_rear_left_knee * z1639 + c_rear_left_knee * z1637;
    const Scalar z1644 = s_rear_left_knee * z1637 - c_rear_left_knee * z1639;
    const Scalar z1645 = s_rear_left_knee * z1642 - c_rear_left_knee * z1640;
    const Scalar z1646 = s_rear_left_knee * z1640 + c_rear_left_knee * z1642;
    const Scalar z1647 = z152 * z156;
    const Scalar z1648 = z1530 + z1647;
    const Scalar z1649 = n0_124 * z1532 + z1643;  // force on rear_left_thigh_link, x
    const Scalar z1650 = n0_124 * z1534 + z1638;  // force on rear_left_thigh_link, y
    const Scalar z1651 = n0_124 * z1537 - z1644;  // force on rear_left_thigh_link, z
    const Scalar z1652 = n0_124 * z1525 - k12 * z1534 - n0_2 * z1638 - z1645;  // moment on rear_left_thigh_link, x
    // moment on rear_left_thigh_link, y
    const Scalar z1653 = k13 * z1514 + n0_124 * z1527 - k14 * z1531 + z1641 + n0_2 * z1643;
    const Scalar z1654 = z1646 - n0_0002 * z1648;  // moment on rear_left_thigh_link, z
    const Scalar z1655 = s_rear_left_thigh * z1651 + c_rear_left_thigh * z1649;
    const Scalar z1656 = s_rear_left_thigh * z1649 - c_rear_left_thigh * z1651;
    const Scalar z1657 = s_rear_left_thigh * z1654 - c_rear_left_thigh * z1652;
    const Scalar z1658 = s_rear_left_thigh * z1652 + c_rear_left_thigh * z1654;
    const Scalar z1659 = z146 * z149;
    const Scalar z1660 = z1514 + z1659;
    const Scalar z1661 = n0_1048 * z1517 + z1655;  // force on rear_left_hip_link, x
    const Scalar z1662 = n0_1048 * z1520 + z1650;  // force on rear_left_hip_link, y
    const Scalar z1663 = n0_1048 * z1521 + z1656;  // force on rear_left_hip_link, z
    const Scalar z1664 = n0_1048 * z1513 + k17 * z1521 + n0_08 * z1656 + z1657;  // moment on rear_left_hip_link, x
    const Scalar z1665 = z1653 + n0_0002 * z1660;  // moment on rear_left_hip_link, y
    const Scalar z1666 = n0_1048 * z1509 + k18 * z1517 + n0_08 * z1655 + z1658;  // moment on rear_left_hip_link, z
    const Scalar z1667 = s_rear_left_hip * z1663 - c_rear_left_hip * z1662;
    const Scalar z1668 = s_rear_left_hip * z1662 + c_rear_left_hip * z1663;
    const Scalar z1669 = s_rear_left_hip * z1666 - c_rear_left_hip * z1665;
    const Scalar z1670 = s_rear_left_hip * z1665 + c_rear_left_hip * z1666;
    const Scalar z1671 = z138 * z139;
    const Scalar z1672 = z1476 + z1671;
    const Scalar z1673 = z139 * z142;
    const Scalar z1674 = z1507 + z1673;
    const Scalar z1675 = z138 * z138;
    const Scalar z1676 = z142 * z142;
    const Scalar z1677 = z1675 + z1676;
    const Scalar z1678 = z138 * z142;
    const Scalar z1679 = z1508 + z1678;
    const Scalar z1680 = n0_032 * z1672;  // force on front_right_shank_link, x
    const Scalar z1681 = n0_032 * z1674;  // force on front_right_shank_link, y
    const Scalar z1682 = n0_032 * z1677;  // force on front_right_shank_link, z
    const Scalar z1683 = n0_032 * z1503 - k7 * z1674;  // moment on front_right_shank_link, x
    const Scalar z1684 = k8 * z1476 - n0_032 * z1505 + k9 * z1671;  // moment on front_right_shank_link, y
    const Scalar z1685 = k10 * z1679;  // moment on front_right_shank_link, z
    const Scalar z1686 = s_front_right_knee * z1682 + c_front_right_knee * z1680;
    const Scalar z1687 = s_front_right_knee * z1680 - c_front_right_knee * z1682;
    const Scalar z1688 = s_front_right_knee * z1685 - c_front_right_knee * z1683;
    const Scalar z1689 = s_front_right_knee * z1683 + c_front_right_knee * z1685;
    const Scalar z1690 = z131 * z135;
    const Scalar z1691 = z1492 + z1690;
    const Scalar z1692 = n0_124 * z1494 + z1686;  // force on front_right_thigh_link, x
    const Scalar z1693 = n0_124 * z1496 + z1681;  // force on front_right_thigh_link, y
    const Scalar z1694 = n0_124 * z1499 - z1687;  // force on front_right_thigh_link, z
    const Scalar z1695 = n0_124 * z1487 - k12 * z1496 - n0_2 * z1681 - z1688;  // moment on front_right_thigh_link, x
    // moment on front_right_thigh_link, y
    const Scalar z1696 = k13 * z1476 + n0_124 * z1489 - k14 * z1493 + z1684 + n0_2 * z1686;
    const Scalar z1697 = z1689 - n0_0002 * z1691;  // moment on front_right_thigh_link, z
    const Scalar z1698 = s_front_right_thigh * z1694 + c_front_right_thigh * z1692;
    const Scalar z1699 = s_front_right_thigh * z1692 - c_front_right_thigh * z1694;
    const Scalar z1700 = s_front_right_thigh * z1697 - c_front_right_thigh * z1695;
    const Scalar z1701 = s_front_right_thigh * z1695 + c_front_right_thigh * z1697;
    const Scalar z1702 = z125 * z128;
    const Scalar z1703 = z1476 + z1702;
    const Scalar z1704 = n0_1048 * z1479 - z1698;  // force on front_right_hip_link, x
    const Scalar z1705 = n0_1048 * z1482 - z1693;  // force on front_right_hip_link, y
    const Scalar z1706 = n0_1048 * z1483 - z1699;  // force on front_right_hip_link, z
    const Scalar z1707 = n0_1048 * z1475 - k17 * z1483 + n0_08 * z1699 - z1700;  // moment on front_right_hip_link, x
    const Scalar z1708 = z1696 + n0_0002 * z1703;  // moment on front_right_hip_link, y
    const Scalar z1709 = n0_1048 * z1471 - k18 * z1479 + n0_08 * z1698 - z1701;  // moment on front_right_hip_link, z
    const Scalar z1710 = s_front_right_hip * z1706 - c_front_right_hip * z1705;
    const Scalar z1711 = s_front_right_hip * z1705 + c_front_right_hip * z1706;
    const Scalar z1712 = s_front_right_hip * z1709 + c_front_right_hip * z1708;
    const Scalar z1713 = s_front_right_hip * z1708 - c_front_right_hip * z1709;
    const Scalar z1714 = z117 * z118;
    const Scalar z1715 = z1438 + z1714;
    const Scalar z1716 = z118 * z121;
    const Scalar z1717 = z1469 + z1716;
    const Scalar z1718 = z117 * z117;
    const Scalar z1719 = z121 * z121;
    const Scalar z1720 = z1718 + z1719;
    const Scalar z1721 = z117 * z121;
    const Scalar z1722 = z1470 + z1721;
    const Scalar z1723 = n0_032 * z1715;  // force on front_left_shank_link, x
    const Scalar z1724 = n0_032 * z1717;  // force on front_left_shank_link, y
    const Scalar z1725 = n0_032 * z1720;  // force on front_left_shank_link, z
    const Scalar z1726 = n0_032 * z1465 - k7 * z1717;  // moment on front_left_shank_link, x
    const Scalar z1727 = k8 * z1438 - n0_032 * z1467 + k9 * z1714;  // moment on front_left_shank_link, y
    const Scalar z1728 = k10 * z1722;  // moment on front_left_shank_link, z
    const Scalar z1729 = s_front_left_knee * z1725 + c_front_left_knee * z1723;
    const Scalar z1730 = s_front_left_knee * z1723 - c_front_left_knee * z1725;
    const Scalar z1731 = s_front_left_knee * z1728 - c_front_left_knee * z1726;
    const Scalar z1732 = s_front_left_knee * z1726 + c_front_left_knee * z1728;
    const Scalar z1733 = z110 * z114;
    const Scalar z1734 = z1454 + z1733;
    const Scalar z1735 = n0_124 * z1456 + z1729;  // force on front_left_thigh_link, x
    const Scalar z1736 = n0_124 * z1458 + z1724;  // force on front_left_thigh_link, y
    const Scalar z1737 = n0_124 * z1461 - z1730;  // force on front_left_thigh_link, z
    const Scalar z1738 = n0_124 * z1449 - k12 * z1458 - n0_2 * z1724 - z1731;  // moment on front_left_thigh_link, x
    // moment on front_left_thigh_link, y
    const Scalar z1739 = k13 * z1438 + n0_124 * z1451 - k14 * z1455 + z1727 + n0_2 * z1729;
    const Scalar z1740 = z1732 - n0_0002 * z1734;  // moment on front_left_thigh_link, z
    const Scalar z1741 = s_front_left_thigh * z1737 + c_front_left_thigh * z1735;
    const Scalar z1742 = s_front_left_thigh * z1735 - c_front_left_thigh * z1737;
    const Scalar z1743 = s_front_left_thigh * z1740 - c_front_left_thigh * z1738;
    const Scalar z1744 = s_front_left_thigh * z1738 + c_front_left_thigh * z1740;
    const Scalar z1745 = z104 * z107;
    const Scalar z1746 = z1438 + z1745;
    const Scalar z1747 = n0_1048 * z1441 + z1741;  // force on front_left_hip_link, x
    const Scalar z1748 = n0_1048 * z1444 + z1736;  // force on front_left_hip_link, y
    const Scalar z1749 = n0_1048 * z1445 + z1742;  // force on front_left_hip_link, z
    const Scalar z1750 = n0_1048 * z1437 + k17 * z1445 + n0_08 * z1742 + z1743;  // moment on front_left_hip_link, x
    const Scalar z1751 = z1739 + n0_0002 * z1746;  // moment on front_left_hip_link, y
    const Scalar z1752 = n0_1048 * z1433 + k18 * z1441 + n0_08 * z1741 + z1744;  // moment on front_left_hip_link, z
    const Scalar z1753 = s_front_left_hip * z1749 - c_front_left_hip * z1748;
    const Scalar z1754 = s_front_left_hip * z1748 + c_front_left_hip * z1749;
    const Scalar z1755 = s_front_left_hip * z1752 - c_front_left_hip * z1751;
    const Scalar z1756 = s_front_left_hip * z1751 + c_front_left_hip * z1752;
    const Scalar z1757 = n12_24 * z1422 - z1618 + z1661 - z1704 + z1747;  // force on trunk, x
    const Scalar z1758 = n12_24 * z1423 - z1624 + z1667 - z1710 + z1753;  // force on trunk, y
    const Scalar z1759 = n12_24 * z1424 + z1625 - z1668 + z1711 - z1754;  // force on trunk, z
    // moment on trunk, x
    const Scalar z1760 = -n0_05 * (z1625 + z1668 + z1711 + z1754) + n0_0306 * z1432 + z1621 - z1664 + z1707 - z1750;
    // moment on trunk, y
    const Scalar z1761 = -n0_2 * (z1625 - z1668 - z1711 + z1754) + n0_3254 * z1431 + z1626 - z1669 + z1712 - z1755;
    // moment on trunk, z
    const Scalar z1762 = -n0_05 * (z1618 + z1661 + z1704 + z1747) + n0_2 * (z1624 - z1667 - z1710 + z1753) + n0_2948
        * z1428 - z1627 - z1670 - z1713 - z1756;
    const Scalar z1763 = z17 * z1757 + z18 * z1758 + z30 * z1759;
    const Scalar z1764 = z19 * z1757 + z23 * z1758 + z24 * z1759;
    const Scalar z1765 = z25 * z1758 + z28 * z1759 + z29 * z1757;
    const Scalar z1773 = z1399 - z1750;
    const Scalar z1774 = z1401 - z1739;
    const Scalar z1775 = z1403 - z1727;
    const Scalar z1776 = z1405 + z1707;
    const Scalar z1777 = z1407 - z1696;
    const Scalar z1778 = z1409 - z1684;
    const Scalar z1779 = z1411 - z1664;
    const Scalar z1780 = z1413 - z1653;
    const Scalar z1781 = z1415 - z1641;
    const Scalar z1782 = z1417 + z1621;
    const Scalar z1783 = z1419 - z1610;
    const Scalar z1784 = z1421 - z1598;
    forces.trunk_x = z1763;
    forces.trunk_y = z1764;
    forces.trunk_z = z1765;
    forces.trunk_attitude_omega_x = z1760;
    forces.trunk_attitude_omega_y = -z1761;
    forces.trunk_attitude_omega_z = z1762;
    forces.front_left_hip = z1773;
    forces.front_left_thigh = z1774;
    forces.front_left_knee = z1775;
    forces.front_right_hip = z1776;
    forces.front_right_thigh = z1777;
    forces.front_right_knee = z1778;
    forces.rear_left_hip = z1779;
    forces.rear_left_thigh = z1780;
    forces.rear_left_knee = z1781;
    forces.rear_right_hip = z1782;
    forces.rear_right_thigh = z1783;
    forces.rear_right_knee = z1784;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k7 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k8 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar k9 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k10 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k12 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar k13 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar k14 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k17 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
    const Scalar k18 = traits::constant(0.0084038, 0.0084038f, "42019/5000000");
    const Scalar k19 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_3354 = traits::constant(0.3354, 0.3354f, "1677/5000");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
    const Scalar n0_366 = traits::constant(0.366, 0.366f, "183/500");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar a_trunk_x = accelerations.trunk_x;
    const Scalar a_trunk_y = accelerations.trunk_y;
    const Scalar a_trunk_z = accelerations.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar a_trunk_attitude_omega_x = accelerations.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar a_trunk_attitude_omega_y = accelerations.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar a_trunk_attitude_omega_z = accelerations.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar a_front_left_hip = accelerations.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar a_front_left_thigh = accelerations.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar a_front_left_knee = accelerations.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar a_front_right_hip = accelerations.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar a_front_right_thigh = accelerations.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar a_front_right_knee = accelerations.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar a_rear_left_hip = accelerations.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar a_rear_left_thigh = accelerations.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar a_rear_left_knee = accelerations.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar a_rear_right_hip = accelerations.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar a_rear_right_thigh = accelerations.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar a_rear_right_knee = accelerations.rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z103 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z104 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z107 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z110 = s_front_left_thigh * z104 + c_front_left_thigh * z107;
    const Scalar z111 = s_front_left_thigh * z107 - c_front_left_thigh * z104;
    const Scalar z114 = v_front_left_thigh + z103;  // angular velocity of front_left_thigh_link, y
    const Scalar z117 = s_front_left_knee * z111 - c_front_left_knee * z110;
    const Scalar z118 = s_front_left_knee * z110 + c_front_left_knee * z111;
    const Scalar z121 = v_front_left_knee + z114;  // angular velocity of front_left_shank_link, y
    const Scalar z124 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z125 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z128 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z131 = s_front_right_thigh * z125 + c_front_right_thigh * z128;
    const Scalar z132 = s_front_right_thigh * z128 - c_front_right_thigh * z125;
    const Scalar z135 = v_front_right_thigh + z124;  // angular velocity of front_right_thigh_link, y
    const Scalar z138 = s_front_right_knee * z132 - c_front_right_knee * z131;
    const Scalar z139 = s_front_right_knee * z131 + c_front_right_knee * z132;
    const Scalar z142 = v_front_right_knee + z135;  // angular velocity of front_right_shank_link, y
    const Scalar z145 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z146 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z149 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z152 = s_rear_left_thigh * z146 + c_rear_left_thigh * z149;
    const Scalar z153 = s_rear_left_thigh * z149 - c_rear_left_thigh * z146;
    const Scalar z156 = v_rear_left_thigh + z145;  // angular velocity of rear_left_thigh_link, y
    const Scalar z159 = s_rear_left_knee * z153 - c_rear_left_knee * z152;
    const Scalar z160 = s_rear_left_knee * z152 + c_rear_left_knee * z153;
    const Scalar z163 = v_rear_left_knee + z156;  // angular velocity of rear_left_shank_link, y
    const Scalar z165 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z166 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z169 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z172 = s_rear_right_thigh * z166 + c_rear_right_thigh * z169;
    const Scalar z173 = s_rear_right_thigh * z169 - c_rear_right_thigh * z166;
    const Scalar z176 = v_rear_right_thigh + z165;  // angular velocity of rear_right_thigh_link, y
    const Scalar z179 = s_rear_right_knee * z173 - c_rear_right_knee * z172;
    const Scalar z180 = s_rear_right_knee * z172 + c_rear_right_knee * z173;
    const Scalar z183 = v_rear_right_knee + z176;  // angular velocity of rear_right_shank_link, y
    const Scalar z1399 = n0_05 * v_front_left_hip;
    const Scalar z1401 = n0_05 * v_front_left_thigh;
    const Scalar z1403 = n0_05 * v_front_left_knee;
    const Scalar z1405 = n0_05 * v_front_right_hip;
    const Scalar z1407 = n0_05 * v_front_right_thigh;
    const Scalar z1409 = n0_05 * v_front_right_knee;
    const Scalar z1411 = n0_05 * v_rear_left_hip;
    const Scalar z1413 = n0_05 * v_rear_left_thigh;
    const Scalar z1415 = n0_05 * v_rear_left_knee;
    const Scalar z1417 = n0_05 * v_rear_right_hip;
    const Scalar z1419 = n0_05 * v_rear_right_thigh;
    const Scalar z1421 = n0_05 * v_rear_right_knee;
    const Scalar z1425 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z1426 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z1427 = z1425 + z1426;
    const Scalar z1428 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z1429 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z1430 = z1426 + z1429;
    const Scalar z1431 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z1432 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z1440 = z103 * z107;
    const Scalar z1442 = z104 * z104;
    const Scalar z1443 = z107 * z107;
    const Scalar z1444 = z1442 + z1443;
    const Scalar z1445 = z103 * z104;
    const Scalar z1455 = z110 * z111;
    const Scalar z1457 = z111 * z114;
    const Scalar z1459 = z110 * z110;
    const Scalar z1460 = z114 * z114;
    const Scalar z1461 = z1459 + z1460;
    const Scalar z1478 = z124 * z128;
    const Scalar z1480 = z125 * z125;
    const Scalar z1481 = z128 * z128;
    const Scalar z1482 = z1480 + z1481;
    const Scalar z1483 = z124 * z125;
    const Scalar z1493 = z131 * z132;
    const Scalar z1495 = z132 * z135;
    const Scalar z1497 = z131 * z131;
    const Scalar z1498 = z135 * z135;
    const Scalar z1499 = z1497 + z1498;
    const Scalar z1516 = z145 * z149;
    const Scalar z1518 = z146 * z146;
    const Scalar z1519 = z149 * z149;
    const Scalar z1520 = z1518 + z1519;
    const Scalar z1521 = z145 * z146;
    const Scalar z1531 = z152 * z153;
    const Scalar z1533 = z153 * z156;
    const Scalar z1535 = z152 * z152;
    const Scalar z1536 = z156 * z156;
    const Scalar z1537 = z1535 + z1536;
    const Scalar z1554 = z165 * z169;
    const Scalar z1556 = z166 * z166;
    const Scalar z1557 = z169 * z169;
    const Scalar z1558 = z1556 + z1557;
    const Scalar z1559 = z165 * z166;
    const Scalar z1569 = z172 * z173;
    const Scalar z1571 = z173 * z176;
    const Scalar z1573 = z172 * z172;
    const Scalar z1574 = z176 * z176;
    const Scalar z1575 = z1573 + z1574;
    const Scalar z1585 = z179 * z180;
    const Scalar z1587 = z180 * z183;
    const Scalar z1589 = z179 * z179;
    const Scalar z1590 = z183 * z183;
    const Scalar z1591 = z1589 + z1590;
    const Scalar z1592 = z179 * z183;
    const Scalar z1596 = n0_032 * z1591;  // force on rear_right_shank_link, z
    const Scalar z1604 = z172 * z176;
    const Scalar z1616 = z166 * z169;
    const Scalar z1628 = z159 * z160;
    const Scalar z1630 = z160 * z163;
    const Scalar z1632 = z159 * z159;
    const Scalar z1633 = z163 * z163;
    const Scalar z1634 = z1632 + z1633;
    const Scalar z1635 = z159 * z163;
    const Scalar z1639 = n0_032 * z1634;  // force on rear_left_shank_link, z
    const Scalar z1647 = z152 * z156;
    const Scalar z1659 = z146 * z149;
    const Scalar z1671 = z138 * z139;
    const Scalar z1673 = z139 * z142;
    const Scalar z1675 = z138 * z138;
    const Scalar z1676 = z142 * z142;
    const Scalar z1677 = z1675 + z1676;
    const Scalar z1678 = z138 * z142;
    const Scalar z1682 = n0_032 * z1677;  // force on front_right_shank_link, z
    const Scalar z1690 = z131 * z135;
    const Scalar z1702 = z125 * z128;
    const Scalar z1714 = z117 * z118;
    const Scalar z1716 = z118 * z121;
    const Scalar z1718 = z117 * z117;
    const Scalar z1719 = z121 * z121;
    const Scalar z1720 = z1718 + z1719;
    const Scalar z1721 = z117 * z121;
    const Scalar z1725 = n0_032 * z1720;  // force on front_left_shank_link, z
    const Scalar z1733 = z110 * z114;
    const Scalar z1745 = z104 * z107;
    const Scalar z1785 = n9_81 + a_trunk_z;
    const Scalar z1786 = a_trunk_x * z17 + a_trunk_y * z19 + z29 * z1785;
    const Scalar z1787 = a_trunk_x * z18 + a_trunk_y * z23 + z25 * z1785;
    const Scalar z1788 = a_trunk_x * z30 + a_trunk_y * z24 + z28 * z1785;
    const Scalar z1789 = a_trunk_attitude_omega_z - z1428;
    const Scalar z1790 = a_trunk_attitude_omega_z + z1428;
    const Scalar z1791 = a_trunk_attitude_omega_y - z1431;
    const Scalar z1792 = a_trunk_attitude_omega_x + z1432;
    const Scalar z1793 = a_trunk_attitude_omega_y * c_front_left_hip + a_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z1794 = a_trunk_attitude_omega_y * s_front_left_hip - a_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z1795 = n0_2 * z1427 - z1786 + n0_05 * z1789;
    const Scalar z1796 = n0_05 * z1430 - z1787 - n0_2 * z1790;
    const Scalar z1797 = z1788 - n0_2 * z1791 + n0_05 * z1792;
    const Scalar z1798 = s_front_left_hip * z1797 - c_front_left_hip * z1796;
    const Scalar z1799 = s_front_left_hip * z1796 + c_front_left_hip * z1797;
    const Scalar z1800 = a_trunk_attitude_omega_x + a_front_left_hip;  // angular acceleration of front_left_hip_link, x
    const Scalar z1801 = v_front_left_hip * z104 - z1793;  // angular acceleration of front_left_hip_link, y
    const Scalar z1802 = v_front_left_hip * z103 + z1794;  // angular acceleration of front_left_hip_link, z
    const Scalar z1803 = z1440 + z1802;
    const Scalar z1804 = z1445 - z1800;
    const Scalar z1805 = s_front_left_thigh * z1802 + c_front_left_thigh * z1800;
    const Scalar z1806 = s_front_left_thigh * z1800 - c_front_left_thigh * z1802;
    const Scalar z1807 = z1795 - n0_08 * z1803;
    const Scalar z1808 = n0_08 * z1444 - z1798;
    const Scalar z1809 = z1799 - n0_08 * z1804;
    const Scalar z1810 = s_front_left_thigh * z1809 + c_front_left_thigh * z1807;
    const Scalar z1811 = s_front_left_thigh * z1807 - c_front_left_thigh * z1809;
    const Scalar z1812 = v_front_left_thigh * z111 - z1805;  // angular acceleration of front_left_thigh_link, x
    const Scalar z1813 = a_front_left_thigh - z1801;  // angular acceleration of front_left_thigh_link, y
    const Scalar z1814 = v_front_left_thigh * z110 + z1806;  // angular acceleration of front_left_thigh_link, z
    const Scalar z1815 = z1455 + z1813;
    const Scalar z1816 = z1457 + z1812;
    const Scalar z1817 = s_front_left_knee * z1814 + c_front_left_knee * z1812;
    const Scalar z1818 = s_front_left_knee * z1812 - c_front_left_knee * z1814;
    const Scalar z1819 = z1810 + n0_2 * z1815;
    const Scalar z1820 = z1808 + n0_2 * z1816;
    const Scalar z1821 = n0_2 * z1461 - z1811;
    const Scalar z1822 = s_front_left_knee * z1821 + c_front_left_knee * z1819;
    const Scalar z1824 = v_front_left_knee * z118 + z1817;  // angular acceleration of front_left_shank_link, x
    const Scalar z1825 = a_front_left_knee + z1813;  // angular acceleration of front_left_shank_link, y
    const Scalar z1826 = v_front_left_knee * z117 + z1818;  // angular acceleration of front_left_shank_link, z
    const Scalar z1827 = a_trunk_attitude_omega_y * c_front_right_hip + a_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z1828 = a_trunk_attitude_omega_y * s_front_right_hip - a_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z1829 = n0_2 * z1427 - z1786 - n0_05 * z1789;
    const Scalar z1830 = n0_05 * z1430 + z1787 + n0_2 * z1790;
    const Scalar z1831 = z1788 - n0_2 * z1791 - n0_05 * z1792;
    const Scalar z1832 = s_front_right_hip * z1831 + c_front_right_hip * z1830;
    const Scalar z1833 = s_front_right_hip * z1830 - c_front_right_hip * z1831;
    // angular acceleration of front_right_hip_link, x
    const Scalar z1834 = a_trunk_attitude_omega_x + a_front_right_hip;
    const Scalar z1835 = v_front_right_hip * z125 - z1827;  // angular acceleration of front_right_hip_link, y
    const Scalar z1836 = v_front_right_hip * z124 + z1828;  // angular acceleration of front_right_hip_link, z
    const Scalar z1837 = z1478 + z1836;
    const Scalar z1838 = z1483 - z1834;
    const Scalar z1839 = s_front_right_thigh * z1836 + c_front_right_thigh * z1834;
    const Scalar z1840 = s_front_right_thigh * z1834 - c_front_right_thigh * z1836;
    const Scalar z1841 = z1829 + n0_08 * z1837;
    const Scalar z1842 = n0_08 * z1482 + z1832;
    const Scalar z1843 = z1833 - n0_08 * z1838;
    const Scalar z1844 = s_front_right_thigh * z1843 - c_front_right_thigh * z1841;
    const Scalar z1845 = s_front_right_thigh * z1841 + c_front_right_thigh * z1843;
    const Scalar z1846 = v_front_right_thigh * z132 - z1839;  // angular acceleration of front_right_thigh_link, x
    const Scalar z1847 = a_front_right_thigh - z1835;  // angular acceleration of front_right_thigh_link, y
    const Scalar z1848 = v_front_right_thigh * z131 + z1840;  // angular acceleration of front_right_thigh_link, z
    const Scalar z1849 = z1493 + z1847;
    const Scalar z1850 = z1495 + z1846;
    const Scalar z1851 = s_front_right_knee * z1848 + c_front_right_knee * z1846;
    const Scalar z1852 = s_front_right_knee * z1846 - c_front_right_knee * z1848;
    const Scalar z1853 = z1844 - n0_2 * z1849;
    const Scalar z1854 = z1842 - n0_2 * z1850;
    const Scalar z1855 = n0_2 * z1499 - z1845;
    const Scalar z1856 = s_front_right_knee * z1855 - c_front_right_knee * z1853;
    const Scalar z1858 = v_front_right_knee * z139 + z1851;  // angular acceleration of front_right_shank_link, x
    const Scalar z1859 = a_front_right_knee + z1847;  // angular acceleration of front_right_shank_link, y
    const Scalar z1860 = v_front_right_knee * z138 + z1852;  // angular acceleration of front_right_shank_link, z
    const Scalar z1861 = a_trunk_attitude_omega_y * c_rear_left_hip + a_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z1862 = a_trunk_attitude_omega_y * s_rear_left_hip - a_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z1863 = n0_2 * z1427 + z1786 - n0_05 * z1789;
    const Scalar z1864 = n0_05 * z1430 - z1787 + n0_2 * z1790;
    const Scalar z1865 = z1788 + n0_2 * z1791 + n0_05 * z1792;
    const Scalar z1866 = s_rear_left_hip * z1865 - c_rear_left_hip * z1864;
    const Scalar z1867 = s_rear_left_hip * z1864 + c_rear_left_hip * z1865;
    const Scalar z1868 = a_trunk_attitude_omega_x + a_rear_left_hip;  // angular acceleration of rear_left_hip_link, x
    const Scalar z1869 = v_rear_left_hip * z146 - z1861;  // angular acceleration of rear_left_hip_link, y
    const Scalar z1870 = v_rear_left_hip * z145 + z1862;  // angular acceleration of rear_left_hip_link, z
    const Scalar z1871 = z1516 + z1870;
    const Scalar z1872 = z1521 - z1868;
    const Scalar z1873 = s_rear_left_thigh * z1870 + c_rear_left_thigh * z1868;
    const Scalar z1874 = s_rear_left_thigh * z1868 - c_rear_left_thigh * z1870;
    const Scalar z1875 = z1863 + n0_08 * z1871;
    const Scalar z1876 = n0_08 * z1520 - z1866;
    const Scalar z1877 = z1867 - n0_08 * z1872;
    const Scalar z1878 = s_rear_left_thigh * z1877 - c_rear_left_thigh * z1875;
    const Scalar z1879 = s_rear_left_thigh * z1875 + c_rear_left_thigh * z1877;
    const Scalar z1880 = v_rear_left_thigh * z153 - z1873;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z1881 = a_rear_left_thigh - z1869;  // angular acceleration of rear_left_thigh_link, y
    const Scalar z1882 = v_rear_left_thigh * z152 + z1874;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z1883 = z1531 + z1881;
    const Scalar z1884 = z1533 + z1880;
    const Scalar z1885 = s_rear_left_knee * z1882 + c_rear_left_knee * z1880;
    const Scalar z1886 = s_rear_left_knee * z1880 - c_rear_left_knee * z1882;
    const Scalar z1887 = z1878 + n0_2 * z1883;
    const Scalar z1888 = z1876 + n0_2 * z1884;
    const Scalar z1889 = n0_2 * z1537 + z1879;
    const Scalar z1890 = s_rear_left_knee * z1889 + c_rear_left_knee * z1887;
    const Scalar z1892 = v_rear_left_knee * z160 + z1885;  // angular acceleration of rear_left_shank_link, x
    const Scalar z1893 = a_rear_left_knee + z1881;  // angular acceleration of rear_left_shank_link, y
    const Scalar z1894 = v_rear_left_knee * z159 + z1886;  // angular acceleration of rear_left_shank_link, z
    const Scalar z1895 = a_trunk_attitude_omega_y * c_rear_right_hip + a_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z1896 = a_trunk_attitude_omega_y * s_rear_right_hip - a_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z1897 = n0_2 * z1427 + z1786 + n0_05 * z1789;
    const Scalar z1898 = n0_05 * z1430 + z1787 - n0_2 * z1790;
    const Scalar z1899 = z1788 + n0_2 * z1791 - n0_05 * z1792;
    const Scalar z1900 = s_rear_right_hip * z1899 + c_rear_right_hip * z1898;
    const Scalar z1901 = s_rear_right_hip * z1898 - c_rear_right_hip * z1899;
    const Scalar z1902 = a_trunk_attitude_omega_x + a_rear_right_hip;  // angular acceleration of rear_right_hip_link, x
    const Scalar z1903 = v_rear_right_hip * z166 - z1895;  // angular acceleration of rear_right_hip_link, y
    const Scalar z1904 = v_rear_right_hip * z165 + z1896;  // angular acceleration of rear_right_hip_link, z
    const Scalar z1905 = z1554 + z1904;
    const Scalar z1906 = z1559 - z1902;
    const Scalar z1907 = s_rear_right_thigh * z1904 + c_rear_right_thigh * z1902;
    const Scalar z1908 = s_rear_right_thigh * z1902 - c_rear_right_thigh * z1904;
    const Scalar z1909 = z1897 - n0_08 * z1905;
    const Scalar z1910 = n0_08 * z1558 + z1900;
    const Scalar z1911 = z1901 - n0_08 * z1906;
    const Scalar z1912 = s_rear_right_thigh * z1911 + c_rear_right_thigh * z1909;
    const Scalar z1913 = s_rear_right_thigh * z1909 - c_rear_right_thigh * z1911;
    const Scalar z1914 = v_rear_right_thigh * z173 - z1907;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z1915 = a_rear_right_thigh - z1903;  // angular acceleration of rear_right_thigh_link, y
    const Scalar z1916 = v_rear_right_thigh * z172 + z1908;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z1917 = z1569 + z1915;
    const Scalar z1918 = z1571 + z1914;
    const Scalar z1919 = s_rear_right_knee * z1916 + c_rear_right_knee * z1914;
    const Scalar z1920 = s_rear_right_knee * z1914 - c_rear_right_knee * z1916;
    const Scalar z1921 = z1912 - n0_2 * z1917;
    const Scalar z1922 = z1910 - n0_2 * z1918;
    const Scalar z1923 = n0_2 * z1575 + z1913;
    const Scalar z1924 = s_rear_right_knee * z1923 - c_rear_right_knee * z1921;
    const Scalar z1926 = v_rear_right_knee * z180 + z1919;  // angular acceleration of rear_right_shank_link, x
    const Scalar z1927 = a_rear_right_knee + z1915;  // angular acceleration of rear_right_shank_link, y
    const Scalar z1928 = v_rear_right_knee * z179 + z1920;  // angular acceleration of rear_right_shank_link, z
    const Scalar z1929 = z1585 - z1927;
    const Scalar z1930 = z1587 + z1926;
    const Scalar z1931 = z1592 + z1928;
    const Scalar z1932 = n0_032 * z1929;  // force on rear_right_shank_link, x
    const Scalar z1933 = n0_032 * z1930;  // force on rear_right_shank_link, y
    const Scalar z1934 = n0_032 * z1922 - k7 * z1930;  // moment on rear_right_shank_link, x
    const Scalar z1935 = k8 * z1585 - n0_032 * z1924 - k9 * z1927;  // moment on rear_right_shank_link, y
    const Scalar z1936 = k10 * z1931;  // moment on rear_right_shank_link, z
    const Scalar z1937 = s_rear_right_knee * z1596 + c_rear_right_knee * z1932;
    const Scalar z1938 = s_rear_right_knee * z1932 - c_rear_right_knee * z1596;
    const Scalar z1939 = s_rear_right_knee * z1936 - c_rear_right_knee * z1934;
    const Scalar z1940 = s_rear_right_knee * z1934 + c_rear_right_knee * z1936;
    const Scalar z1941 = z1604 + z1916;
    const Scalar z1942 = n0_124 * z1917 - z1937;  // force on rear_right_thigh_link, x
    const Scalar z1943 = n0_124 * z1918 + z1933;  // force on rear_right_thigh_link, y
    const Scalar z1944 = n0_124 * z1575 - z1938;  // force on rear_right_thigh_link, z
    const Scalar z1945 = n0_124 * z1910 - k12 * z1918 - n0_2 * z1933 - z1939;  // moment on rear_right_thigh_link, x
    // moment on rear_right_thigh_link, y
    const Scalar z1946 = k13 * z1569 - n0_124 * z1912 + k14 * z1915 - z1935 - n0_2 * z1937;
    const Scalar z1947 = z1940 - n0_0002 * z1941;  // moment on rear_right_thigh_link, z
    const Scalar z1948 = s_rear_right_thigh * z1944 - c_rear_right_thigh * z1942;
    const Scalar z1949 = s_rear_right_thigh * z1942 + c_rear_right_thigh * z1944;
    const Scalar z1950 = s_rear_right_thigh * z1947 - c_rear_right_thigh * z1945;
    const Scalar z1951 = s_rear_right_thigh * z1945 + c_rear_right_thigh * z1947;
    const Scalar z1952 = z1616 + z1903;
    const Scalar z1953 = n0_1048 * z1905 - z1948;  // force on rear_right_hip_link, x
    const Scalar z1954 = n0_1048 * z1558 - z1943;  // force on rear_right_hip_link, y
    const Scalar z1955 = n0_1048 * z1906 + z1949;  // force on rear_right_hip_link, z
    // moment on rear_right_hip_link, x
    const Scalar z1956 = k17 * z1559 - n0_1048 * z1901 - k18 * z1902 + n0_08 * z1949 + z1950;
    const Scalar z1957 = z1946 - n0_0002 * z1952;  // moment on rear_right_hip_link, y
    const Scalar z1958 = n0_1048 * z1897 - k19 * z1905 + n0_08 * z1948 - z1951;  // moment on rear_right_hip_link, z
    const Scalar z1959 = s_rear_right_hip * z1955 - c_rear_right_hip * z1954;
    const Scalar z1960 = s_rear_right_hip * z1954 + c_rear_right_hip * z1955;
    const Scalar z1961 = s_rear_right_hip * z1958 - c_rear_right_hip * z1957;
    const Scalar z1962 = s_rear_right_hip * z1957 + c_rear_right_hip * z1958;
    const Scalar z1963 = z1628 - z1893;
    const Scalar z1964 = z1630 + z1892;
    const Scalar z1965 = z1635 + z1894;
    const Scalar z1966 = n0_032 * z1963;  // force on rear_left_shank_link, x
    const Scalar z1967 = n0_032 * z1964;  // force on rear_left_shank_link, y
    const Scalar z1968 = n0_032 * z1888 + k7 * z1964;  // moment on rear_left_shank_link, x
    const Scalar z1969 = k8 * z1628 - n0_032 * z1890 - k9 * z1893;  // moment on rear_left_shank_link, y
    const Scalar z1970 = k10 * z1965;  // moment on rear_left_shank_link, z
    const Scalar z1971 = s_rear_left_knee * z1639 + c_rear_left_knee * z1966;
    const Scalar z1972 = s_rear_left_knee * z1966 - c_rear_left_knee * z1639;
    const Scalar z1973 = s_rear_left_knee * z1970 + c_rear_left_knee * z1968;
    const Scalar z1974 = s_rear_left_knee * z1968 - c_rear_left_knee * z1970;
    const Scalar z1975 = z1647 + z1882;
    const Scalar z1976 = n0_124 * z1883 - z1971;  // force on rear_left_thigh_link, x
    const Scalar z1977 = n0_124 * z1884 + z1967;  // force on rear_left_thigh_link, y
    const Scalar z1978 = n0_124 * z1537 - z1972;  // force on rear_left_thigh_link, z
    const Scalar z1979 = n0_124 * z1876 + k12 * z1884 + n0_2 * z1967 + z1973;  // moment on rear_left_thigh_link, x
    // moment on rear_left_thigh_link, y
    const Scalar z1980 = k13 * z1531 + n0_124 * z1878 + k14 * z1881 - z1969 - n0_2 * z1971;
    const Scalar z1981 = z1974 + n0_0002 * z1975;  // moment on rear_left_thigh_link, z
    const Scalar z1982 = s_rear_left_thigh * z1978 - c_rear_left_thigh * z1976;
    const Scalar z1983 = s_rear_left_thigh * z1976 + c_rear_left_thigh * z1978;
    const Scalar z1984 = s_rear_left_thigh * z1981 - c_rear_left_thigh * z1979;
    const Scalar z1985 = s_rear_left_thigh * z1979 + c_rear_left_thigh * z1981;
    const Scalar z1986 = z1659 + z1869;
    const Scalar z1987 = n0_1048 * z1871 + z1982;  // force on rear_left_hip_link, x
    const Scalar z1988 = n0_1048 * z1520 + z1977;  // force on rear_left_hip_link, y
    const Scalar z1989 = n0_1048 * z1872 - z1983;  // force on rear_left_hip_link, z
    // moment on rear_left_hip_link, x
    const Scalar z1990 = k17 * z1521 - n0_1048 * z1867 - k18 * z1868 - n0_08 * z1983 - z1984;
    const Scalar z1991 = z1980 - n0_0002 * z1986;  // moment on rear_left_hip_link, y
    const Scalar z1992 = n0_1048 * z1863 + k19 * z1871 + n0_08 * z1982 - z1985;  // moment on rear_left_hip_link, z
    const Scalar z1993 = s_rear_left_hip * z1989 - c_rear_left_hip * z1988;
    const Scalar z1994 = s_rear_left_hip * z1988 + c_rear_left_hip * z1989;
    const Scalar z1995 = s_rear_left_hip * z1992 + c_rear_left_hip * z1991;
    const Scalar z1996 = s_rear_left_hip * z1991 - c_rear_left_hip * z1992;
    const Scalar z1997 = z1671 - z1859;
    const Scalar z1998 = z1673 + z1858;
    const Scalar z1999 = z1678 + z1860;
    const Scalar z2000 = n0_032 * z1997;  // force on front_right_shank_link, x
    const Scalar z2001 = n0_032 * z1998;  // force on front_right_shank_link, y
    const Scalar z2002 = n0_032 * z1854 - k7 * z1998;  // moment on front_right_shank_link, x
    const Scalar z2003 = k8 * z1671 - n0_032 * z1856 - k9 * z1859;  // moment on front_right_shank_link, y
    const Scalar z2004 = k10 * z1999;  // moment on front_right_shank_link, z
    const Scalar z2005 = s_front_right_knee * z1682 + c_front_right_knee * z2000;
    const Scalar z2006 = s_front_right_knee * z2000 - c_front_right_knee * z1682;
    const Scalar z2007 = s_front_right_knee * z2004 - c_front_right_knee * z2002;
    const Scalar z2008 = s_front_right_knee * z2002 + c_front_right_knee * z2004;
    const Scalar z2009 = z1690 + z1848;
    const Scalar z2010 = n0_124 * z1849 - z2005;  // force on front_right_thigh_link, x
    const Scalar z2011 = n0_124 * z1850 + z2001;  // force on front_right_thigh_link, y
    const Scalar z2012 = n0_124 * z1499 - z2006;  // force on front_right_thigh_link, z
    const Scalar z2013 = n0_124 * z1842 - k12 * z1850 - n0_2 * z2001 - z2007;  // moment on front_right_thigh_link, x
    // moment on front_right_thigh_link, y
    const Scalar z2014 = k13 * z1493 - n0_124 * z1844 + k14 * z1847 - z2003 - n0_2 * z2005;
    const Scalar z2015 = z2008 - n0_0002 * z2009;  // moment on front_right_thigh_link, z
    const Scalar z2016 = s_front_right_thigh * z2012 - c_front_right_thigh * z2010;
    const Scalar z2017 = s_front_right_thigh * z2010 + c_front_right_thigh * z2012;
    const Scalar z2018 = s_front_right_thigh * z2015 - c_front_right_thigh * z2013;
    const Scalar z2019 = s_front_right_thigh * z2013 + c_front_right_thigh * z2015;
    const Scalar z2020 = z1702 + z1835;
    const Scalar z2021 = n0_1048 * z1837 - z2016;  // force on front_right_hip_link, x
    const Scalar z2022 = n0_1048 * z1482 - z2011;  // force on front_right_hip_link, y
    const Scalar z2023 = n0_1048 * z1838 + z2017;  // force on front_right_hip_link, z
    // moment on front_right_hip_link, x
    const Scalar z2024 = k17 * z1483 - n0_1048 * z1833 - k18 * z1834 + n0_08 * z2017 + z2018;
    const Scalar z2025 = z2014 - n0_0002 * z2020;  // moment on front_right_hip_link, y
    const Scalar z2026 = n0_1048 * z1829 + k19 * z1837 - n0_08 * z2016 + z2019;  // moment on front_right_hip_link, z
    const Scalar z2027 = s_front_right_hip * z2023 - c_front_right_hip * z2022;
    const Scalar z2028 = s_front_right_hip * z2022 + c_front_right_hip * z2023;
    const Scalar z2029 = s_front_right_hip * z2026 + c_front_right_hip * z2025;
    const Scalar z2030 = s_front_right_hip * z2025 - c_front_right_hip * z2026;
    const Scalar z2031 = z1714 - z1825;
    const Scalar z2032 = z1716 + z1824;
    const Scalar z2033 = z1721 + z1826;
    const Scalar z2034 = n0_032 * z2031;  // force on front_left_shank_link, x
    const Scalar z2035 = n0_032 * z2032;  // force on front_left_shank_link, y
    const Scalar z2036 = n0_032 * z1820 + k7 * z2032;  // moment on front_left_shank_link, x
    const Scalar z2037 = k8 * z1714 - n0_032 * z1822 - k9 * z1825;  // moment on front_left_shank_link, y
    const Scalar z2038 = k10 * z2033;  // moment on front_left_shank_link, z
    const Scalar z2039 = s_front_left_knee * z1725 + c_front_left_knee * z2034;
    const Scalar z2040 = s_front_left_knee * z2034 - c_front_left_knee * z1725;
    const Scalar z2041 = s_front_left_knee * z2038 + c_front_left_knee * z2036;
    const Scalar z2042 = s_front_left_knee * z2036 - c_front_left_knee * z2038;
    const Scalar z2043 = z1733 + z1814;
    const Scalar z2044 = n0_124 * z1815 - z2039;  // force on front_left_thigh_link, x
    const Scalar z2045 = n0_124 * z1816 + z2035;  // force on front_left_thigh_link, y
    const Scalar z2046 = n0_124 * z1461 - z2040;  // force on front_left_thigh_link, z
    const Scalar z2047 = n0_124 * z1808 + k12 * z1816 + n0_2 * z2035 + z2041;  // moment on front_left_thigh_link, x
    // moment on front_left_thigh_link, y
    const Scalar z2048 = k13 * z1455 + n0_124 * z1810 + k14 * z1813 - z2037 - n0_2 * z2039;
    const Scalar z2049 = z2042 + n0_0002 * z2043;  // moment on front_left_thigh_link, z
    const Scalar z2050 = s_front_left_thigh * z2046 - c_front_left_thigh * z2044;
    const Scalar z2051 = s_front_left_thigh * z2044 + c_front_left_thigh * z2046;
    const Scalar z2052 = s_front_left_thigh * z2049 - c_front_left_thigh * z2047;
    const Scalar z2053 = s_front_left_thigh * z2047 + c_front_left_thigh * z2049;
    const Scalar z2054 = z1745 + z1801;
    const Scalar z2055 = n0_1048 * z1803 + z2050;  // force on front_left_hip_link, x
    const Scalar z2056 = n0_1048 * z1444 + z2045;  // force on front_left_hip_link, y
    const Scalar z2057 = n0_1048 * z1804 - z2051;  // force on front_left_hip_link, z
    // moment on front_left_hip_link, x
    const Scalar z2058 = k17 * z1445 - n0_1048 * z1799 - k18 * z1800 - n0_08 * z2051 - z2052;
    const Scalar z2059 = z2048 - n0_0002 * z2054;  // moment on front_left_hip_link, y
    const Scalar z2060 = n0_1048 * z1795 - k19 * z1803 - n0_08 * z2050 + z2053;  // moment on front_left_hip_link, z
    const Scalar z2061 = s_front_left_hip * z2057 - c_front_left_hip * z2056;
    const Scalar z2062 = s_front_left_hip * z2056 + c_front_left_hip * z2057;
    const Scalar z2063 = s_front_left_hip * z2060 - c_front_left_hip * z2059;
    const Scalar z2064 = s_front_left_hip * z2059 + c_front_left_hip * z2060;
    const Scalar z2065 = n12_24 * z1786 - z1953 + z1987 - z2021 + z2055;  // force on trunk, x
    const Scalar z2066 = n12_24 * z1787 - z1959 + z1993 - z2027 + z2061;  // force on trunk, y
    const Scalar z2067 = n12_24 * z1788 + z1960 - z1994 + z2028 - z2062;  // force on trunk, z
    // moment on trunk, x
    const Scalar z2068 = -n0_05 * (z1960 + z1994 + z2028 + z2062) + n0_0406 * a_trunk_attitude_omega_x + n0_0306 * z1432
        - z1956 - z1990 - z2024 - z2058;
    // moment on trunk, y
    const Scalar z2069 = n0_2 * (z1960 - z1994 - z2028 + z2062) + n0_3354 * a_trunk_attitude_omega_y - n0_3254 * z1431
        - z1961 + z1995 + z2029 - z2063;
    // moment on trunk, z
    const Scalar z2070 = -n0_05 * (z1953 + z1987 + z2021 + z2055) + n0_2 * (z1959 - z1993 - z2027 + z2061) + n0_366
        * a_trunk_attitude_omega_z + n0_2948 * z1428 + z1962 + z1996 + z2030 + z2064;
    const Scalar z2071 = z17 * z2065 + z18 * z2066 + z30 * z2067;
    const Scalar z2072 = z19 * z2065 + z23 * z2066 + z24 * z2067;
    const Scalar z2073 = z25 * z2066 + z28 * z2067 + z29 * z2065;
    const Scalar z2081 = z1399 - z2058;
    const Scalar z2082 = z1401 + z2048;
    const Scalar z2083 = z1403 - z2037;
    const Scalar z2084 = z1405 - z2024;
    const Scalar z2085 = z1407 + z2014;
    const Scalar z2086 = z1409 - z2003;
    const Scalar z2087 = z1411 - z1990;
    const Scalar z2088 = z1413 + z1980;
    const Scalar z2089 = z1415 - z1969;
    const Scalar z2090 = z1417 - z1956;
    const Scalar z2091 = z1419 + z1946;
    const Scalar z2092 = z1421 - z1935;
    forces.trunk_x = z2071;
    forces.trunk_y = z2072;
    forces.trunk_z = z2073;
    forces.trunk_attitude_omega_x = z2068;
    forces.trunk_attitude_omega_y = z2069;
    forces.trunk_attitude_omega_z = z2070;
    forces.front_left_hip = z2081;
    forces.front_left_thigh = z2082;
    forces.front_left_knee = z2083;
    forces.front_right_hip = z2084;
    forces.front_right_thigh = z2085;
    forces.front_right_knee = z2086;
    forces.rear_left_hip = z2087;
    forces.rear_left_thigh = z2088;
    forces.rear_left_knee = z2089;
    forces.rear_right_hip = z2090;
    forces.rear_right_thigh = z2091;
    forces.rear_right_knee = z2092;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k3 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k7 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k11 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k12 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar k13 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k16 = traits::constant(0.20040707687490214, 0.20040707f, "1280/6387");
    const Scalar k17 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k18 = traits::constant(0.0329736, 0.0329736f, "41217/1250000");
    const Scalar k19 = traits::constant(0.0325736, 0.0325736f, "40717/1250000");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar k21 = traits::constant(0.4664944, 0.4664944f, "291559/625000");
    const Scalar k22 = traits::constant(0.4970944, 0.4970944f, "77671/156250");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar k24 = traits::constant(195.71003601064663, 195.71004f, "1250000/6387");
    const Scalar k25 = traits::constant(6.262721152340692, 6.262721f, "40000/6387");
    const Scalar k26 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
    const Scalar k27 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar u_front_left_hip_torque = inputs.front_left_hip_torque;
    const Scalar u_front_left_thigh_torque = inputs.front_left_thigh_torque;
    const Scalar u_front_left_knee_torque = inputs.front_left_knee_torque;
    const Scalar u_front_right_hip_torque = inputs.front_right_hip_torque;
    const Scalar u_front_right_thigh_torque = inputs.front_right_thigh_torque;
    const Scalar u_front_right_knee_torque = inputs.front_right_knee_torque;
    const Scalar u_rear_left_hip_torque = inputs.rear_left_hip_torque;
    const Scalar u_rear_left_thigh_torque = inputs.rear_left_thigh_torque;
    const Scalar u_rear_left_knee_torque = inputs.rear_left_knee_torque;
    const Scalar u_rear_right_hip_torque = inputs.rear_right_hip_torque;
    const Scalar u_rear_right_thigh_torque = inputs.rear_right_thigh_torque;
    const Scalar u_rear_right_knee_torque = inputs.rear_right_knee_torque;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z103 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z104 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z107 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z110 = s_front_left_thigh * z104 + c_front_left_thigh * z107;
    const Scalar z111 = s_front_left_thigh * z107 - c_front_left_thigh * z104;
    const Scalar z114 = v_front_left_thigh + z103;  // angular velocity of front_left_thigh_link, y
    const Scalar z117 = s_front_left_knee * z111 - c_front_left_knee * z110;
    const Scalar z118 = s_front_left_knee * z110 + c_front_left_knee * z111;
    const Scalar z121 = v_front_left_knee + z114;  // angular velocity of front_left_shank_link, y
    const Scalar z124 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z125 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z128 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z131 = s_front_right_thigh * z125 + c_front_right_thigh * z128;
    const Scalar z132 = s_front_right_thigh * z128 - c_front_right_thigh * z125;
    const Scalar z135 = v_front_right_thigh + z124;  // angular velocity of front_right_thigh_link, y
    const Scalar z138 = s_front_right_knee * z132 - c_front_right_knee * z131;
    const Scalar z139 = s_front_right_knee * z131 + c_front_right_knee * z132;
    const Scalar z142 = v_front_right_knee + z135;  // angular velocity of front_right_shank_link, y
    const Scalar z145 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z146 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z149 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z152 = s_rear_left_thigh * z146 + c_rear_left_thigh * z149;
    const Scalar z153 = s_rear_left_thigh * z149 - c_rear_left_thigh * z146;
    const Scalar z156 = v_rear_left_thigh + z145;  // angular velocity of rear_left_thigh_link, y
    const Scalar z159 = s_rear_left_knee * z153 - c_rear_left_knee * z152;
    const Scalar z160 = s_rear_left_knee * z152 + c_rear_left_knee * z153;
    const Scalar z163 = v_rear_left_knee + z156;  // angular velocity of rear_left_shank_link, y
    const Scalar z165 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z166 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z169 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z172 = s_rear_right_thigh * z166 + c_rear_right_thigh * z169;
    const Scalar z173 = s_rear_right_thigh * z169 - c_rear_right_thigh * z166;
    const Scalar z176 = v_rear_right_thigh + z165;  // angular velocity of rear_right_thigh_link, y
    const Scalar z179 = s_rear_right_knee * z173 - c_rear_right_knee * z172;
    const Scalar z180 = s_rear_right_knee * z172 + c_rear_right_knee * z173;
    const Scalar z183 = v_rear_right_knee + z176;  // angular velocity of rear_right_shank_link, y
    const Scalar z944 = n0_032 * c_rear_right_knee;
    const Scalar z945 = n0_032 * s_rear_right_knee;
    const Scalar z968 = k3 * s_rear_right_knee;
    const Scalar z969 = s_rear_right_knee * z968;
    const Scalar z970 = k3 - z969;
    const Scalar z971 = c_rear_right_knee * z968;
    const Scalar z972 = n0_4 * z944 - z969;
    const Scalar z973 = n0_2 * z945 + z971;
    const Scalar z975 = n0_124 + z944;
    const Scalar z977 = k7 + z970;
    const Scalar z978 = s_rear_right_thigh * z945 - c_rear_right_thigh * z975;
    const Scalar z979 = s_rear_right_thigh * z975 + c_rear_right_thigh * z945;
    const Scalar z999 = z972 + z977;
    const Scalar z1000 = n2 * z973;
    const Scalar z1001 = s_rear_right_thigh * z999 + c_rear_right_thigh * z1000;
    const Scalar z1002 = s_rear_right_thigh * z1001;
    const Scalar z1003 = z977 - z1002;
    const Scalar z1004 = z972 - z1002;
    const Scalar z1005 = c_rear_right_thigh * z1001 - z973;
    const Scalar z1040 = n0_032 * c_rear_left_knee;
    const Scalar z1041 = n0_032 * s_rear_left_knee;
    const Scalar z1064 = k3 * s_rear_left_knee;
    const Scalar z1065 = s_rear_left_knee * z1064;
    const Scalar z1066 = k3 - z1065;
    const Scalar z1067 = c_rear_left_knee * z1064;
    const Scalar z1068 = n0_4 * z1040 - z1065;
    const Scalar z1069 = n0_2 * z1041 + z1067;
    const Scalar z1071 = n0_124 + z1040;
    const Scalar z1073 = k7 + z1066;
    const Scalar z1074 = s_rear_left_thigh * z1041 - c_rear_left_thigh * z1071;
    const Scalar z1075 = s_rear_left_thigh * z1071 + c_rear_left_thigh * z1041;
    const Scalar z1095 = z1068 + z1073;
    const Scalar z1096 = n2 * z1069;
    const Scalar z1097 = s_rear_left_thigh * z1095 + c_rear_left_thigh * z1096;
    const Scalar z1098 = s_rear_left_thigh * z1097;
    const Scalar z1099 = z1073 - z1098;
    const Scalar z1100 = z1068 - z1098;
    const Scalar z1101 = c_rear_left_thigh * z1097 - z1069;
    const Scalar z1142 = n0_032 * c_front_right_knee;
    const Scalar z1143 = n0_032 * s_front_right_knee;
    const Scalar z1166 = k3 * s_front_right_knee;
    const Scalar z1167 = s_front_right_knee * z1166;
    const Scalar z1168 = k3 - z1167;
    const Scalar z1169 = c_front_right_knee * z1166;
    const Scalar z1170 = n0_4 * z1142 - z1167;
    const Scalar z1171 = n0_2 * z1143 + z1169;
    const Scalar z1173 = n0_124 + z1142;
    const Scalar z1175 = k7 + z1168;
    const Scalar z1176 = s_front_right_thigh * z1143 - c_front_right_thigh * z1173;
    const Scalar z1177 = s_front_right_thigh * z1173 + c_front_right_thigh * z1143;
    const Scalar z1197 = z1170 + z1175;
    const Scalar z1198 = n2 * z1171;
    const Scalar z1199 = s_front_right_thigh * z1197 + c_front_right_thigh * z1198;
    const Scalar z1200 = s_front_right_thigh * z1199;
    const Scalar z1201 = z1175 - z1200;
    const Scalar z1202 = z1170 - z1200;
    const Scalar z1203 = c_front_right_thigh * z1199 - z1171;
    const Scalar z1244 = n0_032 * c_front_left_knee;
    const Scalar z1245 = n0_032 * s_front_left_knee;
    const Scalar z1268 = k3 * s_front_left_knee;
    const Scalar z1269 = s_front_left_knee * z1268;
    const Scalar z1270 = k3 - z1269;
    const Scalar z1271 = c_front_left_knee * z1268;
    const Scalar z1272 = n0_4 * z1244 - z1269;
    const Scalar z1273 = n0_2 * z1245 + z1271;
    const Scalar z1275 = n0_124 + z1244;
    const Scalar z1277 = k7 + z1270;
    const Scalar z1278 = s_front_left_thigh * z1245 - c_front_left_thigh * z1275;
    const Scalar z1279 = s_front_left_thigh * z1275 + c_front_left_thigh * z1245;
    const Scalar z1299 = z1272 + z1277;
    const Scalar z1300 = n2 * z1273;
    const Scalar z1301 = s_front_left_thigh * z1299 + c_front_left_thigh * z1300;
    const Scalar z1302 = s_front_left_thigh * z1301;
    const Scalar z1303 = z1277 - z1302;
    const Scalar z1304 = z1272 - z1302;
    const Scalar z1305 = c_front_left_thigh * z1301 - z1273;
    const Scalar z1399 = n0_05 * v_front_left_hip;
    const Scalar z1401 = n0_05 * v_front_left_thigh;
    const Scalar z1403 = n0_05 * v_front_left_knee;
    const Scalar z1405 = n0_05 * v_front_right_hip;
    const Scalar z1407 = n0_05 * v_front_right_thigh;
    const Scalar z1409 = n0_05 * v_front_right_knee;
    const Scalar z1411 = n0_05 * v_rear_left_hip;
    const Scalar z1413 = n0_05 * v_rear_left_thigh;
    const Scalar z1415 = n0_05 * v_rear_left_knee;
    const Scalar z1417 = n0_05 * v_rear_right_hip;
    const Scalar z1419 = n0_05 * v_rear_right_thigh;
    const Scalar z1421 = n0_05 * v_rear_right_knee;
    const Scalar z1422 = n9_81 * z29;
    const Scalar z1423 = n9_81 * z25;
    const Scalar z1424 = n9_81 * z28;
    const Scalar z1425 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z1426 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z1427 = z1425 + z1426;
    const Scalar z1428 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z1429 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z1430 = z1426 + z1429;
    const Scalar z1431 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z1432 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z1433 = z1422 - n0_2 * z1427 + n0_05 * z1428;
    const Scalar z1434 = z1423 + n0_2 * z1428 - n0_05 * z1430;
    const Scalar z1435 = z1424 + n0_2 * z1431 + n0_05 * z1432;
    const Scalar z1436 = s_front_left_hip * z1435 + c_front_left_hip * z1434;
    const Scalar z1437 = s_front_left_hip * z1434 - c_front_left_hip * z1435;
    const Scalar z1438 = v_front_left_hip * z104;  // angular acceleration of front_left_hip_link, y
    const Scalar z1439 = v_front_left_hip * z103;  // angular acceleration of front_left_hip_link, z
    const Scalar z1440 = z103 * z107;
    const Scalar z1441 = z1439 + z1440;
    const Scalar z1442 = z104 * z104;
    const Scalar z1443 = z107 * z107;
    const Scalar z1444 = z1442 + z1443;
    const Scalar z1445 = z103 * z104;
    const Scalar z1446 = s_front_left_thigh * z1439;
    const Scalar z1447 = c_front_left_thigh * z1439;
    const Scalar z1448 = z1433 + n0_08 * z1441;
    const Scalar z1449 = z1436 - n0_08 * z1444;
    const Scalar z1450 = z1437 + n0_08 * z1445;
    const Scalar z1451 = s_front_left_thigh * z1450 + c_front_left_thigh * z1448;
    const Scalar z1452 = s_front_left_thigh * z1448 - c_front_left_thigh * z1450;
    const Scalar z1453 = v_front_left_thigh * z111 - z1446;  // angular acceleration of front_left_thigh_link, x
    const Scalar z1454 = v_front_left_thigh * z110 - z1447;  // angular acceleration of front_left_thigh_link, z
    const Scalar z1455 = z110 * z111;
    const Scalar z1457 = z111 * z114;
    const Scalar z1458 = z1453 + z1457;
    const Scalar z1459 = z110 * z110;
    const Scalar z1460 = z114 * z114;
    const Scalar z1461 = z1459 + z1460;
    const Scalar z1462 = s_front_left_knee * z1454 + c_front_left_knee * z1453;
    const Scalar z1463 = s_front_left_knee * z1453 - c_front_left_knee * z1454;
    const Scalar z1465 = z1449 - n0_2 * z1458;
    const Scalar z1466 = z1452 + n0_2 * z1461;
    const Scalar z1469 = v_front_left_knee * z118 + z1462;  // angular acceleration of front_left_shank_link, x
    const Scalar z1470 = v_front_left_knee * z117 + z1463;  // angular acceleration of front_left_shank_link, z
    const Scalar z1471 = z1422 - n0_2 * z1427 - n0_05 * z1428;
    const Scalar z1472 = z1423 + n0_2 * z1428 + n0_05 * z1430;
    const Scalar z1473 = z1424 + n0_2 * z1431 - n0_05 * z1432;
    const Scalar z1474 = s_front_right_hip * z1473 + c_front_right_hip * z1472;
    const Scalar z1475 = s_front_right_hip * z1472 - c_front_right_hip * z1473;
    const Scalar z1476 = v_front_right_hip * z125;  // angular acceleration of front_right_hip_link, y
    const Scalar z1477 = v_front_right_hip * z124;  // angular acceleration of front_right_hip_link, z
    const Scalar z1478 = z124 * z128;
    const Scalar z1479 = z1477 + z1478;
    const Scalar z1480 = z125 * z125;
    const Scalar z1481 = z128 * z128;
    const Scalar z1482 = z1480 + z1481;
    const Scalar z1483 = z124 * z125;
    const Scalar z1484 = s_front_right_thigh * z1477;
    const Scalar z1485 = c_front_right_thigh * z1477;
    const Scalar z1486 = z1471 - n0_08 * z1479;
    const Scalar z1487 = z1474 + n0_08 * z1482;
    const Scalar z1488 = z1475 - n0_08 * z1483;
    const Scalar z1489 = s_front_right_thigh * z1488 + c_front_right_thigh * z1486;
    const Scalar z1490 = s_front_right_thigh * z1486 - c_front_right_thigh * z1488;
    const Scalar z1491 = v_front_right_thigh * z132 - z1484;  // angular acceleration of front_right_thigh_link, x
    const Scalar z1492 = v_front_right_thigh * z131 - z1485;  // angular acceleration of front_right_thigh_link, z
    const Scalar z1493 = z131 * z132;
    const Scalar z1495 = z132 * z135;
    const Scalar z1496 = z1491 + z1495;
    const Scalar z1497 = z131 * z131;
    const Scalar z1498 = z135 * z135;
    const Scalar z1499 = z1497 + z1498;
    const Scalar z1500 = s_front_right_knee * z1492 + c_front_right_knee * z1491;
    const Scalar z1501 = s_front_right_knee * z1491 - c_front_right_knee * z1492;
    const Scalar z1503 = z1487 - n0_2 * z1496;
    const Scalar z1504 = z1490 + n0_2 * z1499;
    const Scalar z1507 = v_front_right_knee * z139 + z1500;  // angular acceleration of front_right_shank_link, x
    const Scalar z1508 = v_front_right_knee * z138 + z1501;  // angular acceleration of front_right_shank_link, z
    const Scalar z1509 = z1422 + n0_2 * z1427 + n0_05 * z1428;
    const Scalar z1510 = z1423 - n0_2 * z1428 - n0_05 * z1430;
    const Scalar z1511 = z1424 - n0_2 * z1431 + n0_05 * z1432;
    const Scalar z1512 = s_rear_left_hip * z1511 + c_rear_left_hip * z1510;
    const Scalar z1513 = s_rear_left_hip * z1510 - c_rear_left_hip * z1511;
    const Scalar z1514 = v_rear_left_hip * z146;  // angular acceleration of rear_left_hip_link, y
    const Scalar z1515 = v_rear_left_hip * z145;  // angular acceleration of rear_left_hip_link, z
    const Scalar z1516 = z145 * z149;
    const Scalar z1517 = z1515 + z1516;
    const Scalar z1518 = z146 * z146;
    const Scalar z1519 = z149 * z149;
    const Scalar z1520 = z1518 + z1519;
    const Scalar z1521 = z145 * z146;
    const Scalar z1522 = s_rear_left_thigh * z1515;
    const Scalar z1523 = c_rear_left_thigh * z1515;
    const Scalar z1524 = z1509 + n0_08 * z1517;
    const Scalar z1525 = z1512 - n0_08 * z1520;
    const Scalar z1526 = z1513 + n0_08 * z1521;
    const Scalar z1527 = s_rear_left_thigh * z1526 + c_rear_left_thigh * z1524;
    const Scalar z1528 = s_rear_left_thigh * z1524 - c_rear_left_thigh * z1526;
    const Scalar z1529 = v_rear_left_thigh * z153 - z1522;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z1530 = v_rear_left_thigh * z152 - z1523;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z1531 = z152 * z153;
    const Scalar z1533 = z153 * z156;
    const Scalar z1534 = z1529 + z1533;
    const Scalar z1535 = z152 * z152;
    const Scalar z1536 = z156 * z156;
    const Scalar z1537 = z1535 + z1536;
    const Scalar z1538 = s_rear_left_knee * z1530 + c_rear_left_knee * z1529;
    const Scalar z1539 = s_rear_left_knee * z1529 - c_rear_left_knee * z1530;
    const Scalar z1541 = z1525 - n0_2 * z1534;
    const Scalar z1542 = z1528 + n0_2 * z1537;
    const Scalar z1545 = v_rear_left_knee * z160 + z1538;  // angular acceleration of rear_left_shank_link, x
    const Scalar z1546 = v_rear_left_knee * z159 + z1539;  // angular acceleration of rear_left_shank_link, z
    const Scalar z1547 = z1422 + n0_2 * z1427 - n0_05 * z1428;
    const Scalar z1548 = z1423 - n0_2 * z1428 + n0_05 * z1430;
    const Scalar z1549 = z1424 - n0_2 * z1431 - n0_05 * z1432;
    const Scalar z1550 = s_rear_right_hip * z1549 + c_rear_right_hip * z1548;
    const Scalar z1551 = s_rear_right_hip * z1548 - c_rear_right_hip * z1549;
    const Scalar z1552 = v_rear_right_hip * z166;  // angular acceleration of rear_right_hip_link, y
    const Scalar z1553 = v_rear_right_hip * z165;  // angular acceleration of rear_right_hip_link, z
    const Scalar z1554 = z165 * z169;
    const Scalar z1555 = z1553 + z1554;
    const Scalar z1556 = z166 * z166;
    const Scalar z1557 = z169 * z169;
    const Scalar z1558 = z1556 + z1557;
    const Scalar z1559 = z165 * z166;
    const Scalar z1560 = s_rear_right_thigh * z1553;
    const Scalar z1561 = c_rear_right_thigh * z1553;
    const Scalar z1562 = z1547 - n0_08 * z1555;
    const Scalar z1563 = z1550 + n0_08 * z1558;
    const Scalar z1564 = z1551 - n0_08 * z1559;
    const Scalar z1565 = s_rear_right_thigh * z1564 + c_rear_right_thigh * z1562;
    const Scalar z1566 = s_rear_right_thigh * z1562 - c_rear_right_thigh * z1564;
    const Scalar z1567 = v_rear_right_thigh * z173 - z1560;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z1568 = v_rear_right_thigh * z172 - z1561;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z1569 = z172 * z173;
    const Scalar z1571 = z173 * z176;
    const Scalar z1572 = z1567 + z1571;
    const Scalar z1573 = z172 * z172;
    const Scalar z1574 = z176 * z176;
    const Scalar z1575 = z1573 + z1574;
    const Scalar z1576 = s_rear_right_knee * z1568 + c_rear_right_knee * z1567;
    const Scalar z1577 = s_rear_right_knee * z1567 - c_rear_right_knee * z1568;
    const Scalar z1579 = z1563 - n0_2 * z1572;
    const Scalar z1580 = z1566 + n0_2 * z1575;
    const Scalar z1583 = v_rear_right_knee * z180 + z1576;  // angular acceleration of rear_right_shank_link, x
    const Scalar z1584 = v_rear_right_knee * z179 + z1577;  // angular acceleration of rear_right_shank_link, z
    const Scalar z1585 = z179 * z180;
    const Scalar z1587 = z180 * z183;
    const Scalar z1588 = z1583 + z1587;
    const Scalar z1589 = z179 * z179;
    const Scalar z1590 = z183 * z183;
    const Scalar z1591 = z1589 + z1590;
    const Scalar z1592 = z179 * z183;
    const Scalar z1593 = z1584 + z1592;
    const Scalar z1595 = n0_032 * z1588;  // force on rear_right_shank_link, y
    const Scalar z1596 = n0_032 * z1591;  // force on rear_right_shank_link, z
    const Scalar z1597 = n0_032 * z1579 - k11 * z1588;  // moment on rear_right_shank_link, x
    const Scalar z1599 = k12 * z1593;  // moment on rear_right_shank_link, z
    const Scalar z1602 = s_rear_right_knee * z1599 - c_rear_right_knee * z1597;
    const Scalar z1603 = s_rear_right_knee * z1597 + c_rear_right_knee * z1599;
    const Scalar z1604 = z172 * z176;
    const Scalar z1605 = z1568 + z1604;
    const Scalar z1607 = n0_124 * z1572 + z1595;  // force on rear_right_thigh_link, y
    const Scalar z1609 = n0_124 * z1563 - k13 * z1572 - n0_2 * z1595 - z1602;  // moment on rear_right_thigh_link, x
    const Scalar z1611 = z1603 - n0_0002 * z1605;  // moment on rear_right_thigh_link, z
    const Scalar z1614 = s_rear_right_thigh * z1611 - c_rear_right_thigh * z1609;
    const Scalar z1615 = s_rear_right_thigh * z1609 + c_rear_right_thigh * z1611;
    const Scalar z1616 = z166 * z169;
    const Scalar z1617 = z1552 + z1616;
    const Scalar z1619 = n0_1048 * z1558 - z1607;  // force on rear_right_hip_link, y
    const Scalar z1628 = z159 * z160;
    const Scalar z1630 = z160 * z163;
    const Scalar z1631 = z1545 + z1630;
    const Scalar z1632 = z159 * z159;
    const Scalar z1633 = z163 * z163;
    const Scalar z1634 = z1632 + z1633;
    const Scalar z1635 = z159 * z163;
    const Scalar z1636 = z1546 + z1635;
    const Scalar z1638 = n0_032 * z1631;  // force on rear_left_shank_link, y
    const Scalar z1639 = n0_032 * z1634;  // force on rear_left_shank_link, z
    const Scalar z1640 = n0_032 * z1541 - k11 * z1631;  // moment on rear_left_shank_link, x
    const Scalar z1642 = k12 * z1636;  // moment on rear_left_shank_link, z
    const Scalar z1645 = s_rear_left_knee * z1642 - c_rear_left_knee * z1640;
    const Scalar z1646 = s_rear_left_knee * z1640 + c_rear_left_knee * z1642;
    const Scalar z1647 = z152 * z156;
    const Scalar z1648 = z1530 + z1647;
    const Scalar z1650 = n0_124 * z1534 + z1638;  // force on rear_left_thigh_link, y
    const Scalar z1652 = n0_124 * z1525 - k13 * z1534 - n0_2 * z1638 - z1645;  // moment on rear_left_thigh_link, x
    const Scalar z1654 = z1646 - n0_0002 * z1648;  // moment on rear_left_thigh_link, z
    const Scalar z1657 = s_rear_left_thigh * z1654 - c_rear_left_thigh * z1652;
    const Scalar z1658 = s_rear_left_thigh * z1652 + c_rear_left_thigh * z1654;
    const Scalar z1659 = z146 * z149;
    const Scalar z1660 = z1514 + z1659;
    const Scalar z1662 = n0_1048 * z1520 + z1650;  // force on rear_left_hip_link, y
    const Scalar z1671 = z138 * z139;
    const Scalar z1673 = z139 * z142;
    const Scalar z1674 = z1507 + z1673;
    const Scalar z1675 = z138 * z138;
    const Scalar z1676 = z142 * z142;
    const Scalar z1677 = z1675 + z1676;
    const Scalar z1678 = z138 * z142;
    const Scalar z1679 = z1508 + z1678;
    const Scalar z1681 = n0_032 * z1674;  // force on front_right_shank_link, y
    const Scalar z1682 = n0_032 * z1677;  // force on front_right_shank_link, z
    const Scalar z1683 = n0_032 * z1503 - k11 * z1674;  // moment on front_right_shank_link, x
    const Scalar z1685 = k12 * z1679;  // moment on front_right_shank_link, z
    const Scalar z1688 = s_front_right_knee * z1685 - c_front_right_knee * z1683;
    const Scalar z1689 = s_front_right_knee * z1683 + c_front_right_knee * z1685;
    const Scalar z1690 = z131 * z135;
    const Scalar z1691 = z1492 + z1690;
    const Scalar z1693 = n0_124 * z1496 + z1681;  // force on front_right_thigh_link, y
    const Scalar z1695 = n0_124 * z1487 - k13 * z1496 - n0_2 * z1681 - z1688;  // moment on front_right_thigh_link, x
    const Scalar z1697 = z1689 - n0_0002 * z1691;  // moment on front_right_thigh_link, z
    const Scalar z1700 = s_front_right_thigh * z1697 - c_front_right_thigh * z1695;
    const Scalar z1701 = s_front_right_thigh * z1695 + c_front_right_thigh * z1697;
    const Scalar z1702 = z125 * z128;
    const Scalar z1703 = z1476 + z1702;
    const Scalar z1705 = n0_1048 * z1482 - z1693;  // force on front_right_hip_link, y
    const Scalar z1714 = z117 * z118;
    const Scalar z1716 = z118 * z121;
    const Scalar z1717 = z1469 + z1716;
    const Scalar z1718 = z117 * z117;
    const Scalar z1719 = z121 * z121;
    const Scalar z1720 = z1718 + z1719;
    const Scalar z1721 = z117 * z121;
    const Scalar z1722 = z1470 + z1721;
    const Scalar z1724 = n0_032 * z1717;  // force on front_left_shank_link, y
    const Scalar z1725 = n0_032 * z1720;  // force on front_left_shank_link, z
    const Scalar z1726 = n0_032 * z1465 - k11 * z1717;  // moment on front_left_shank_link, x
    const Scalar z1728 = k12 * z1722;  // moment on front_left_shank_link, z
    const Scalar z1731 = s_front_left_knee * z1728 - c_front_left_knee * z1726;
    const Scalar z1732 = s_front_left_knee * z1726 + c_front_left_knee * z1728;
    const Scalar z1733 = z110 * z114;
    const Scalar z1734 = z1454 + z1733;
    const Scalar z1736 = n0_124 * z1458 + z1724;  // force on front_left_thigh_link, y
    const Scalar z1738 = n0_124 * z1449 - k13 * z1458 - n0_2 * z1724 - z1731;  // moment on front_left_thigh_link, x
    const Scalar z1740 = z1732 - n0_0002 * z1734;  // moment on front_left_thigh_link, z
    const Scalar z1743 = s_front_left_thigh * z1740 - c_front_left_thigh * z1738;
    const Scalar z1744 = s_front_left_thigh * z1738 + c_front_left_thigh * z1740;
    const Scalar z1745 = z104 * z107;
    const Scalar z1746 = z1438 + z1745;
    const Scalar z1748 = n0_1048 * z1444 + z1736;  // force on front_left_hip_link, y
    const Scalar z2093 = u_front_left_hip_torque - z1399;
    const Scalar z2094 = u_front_left_thigh_torque - z1401;
    const Scalar z2095 = u_front_left_knee_torque - z1403;
    const Scalar z2096 = u_front_right_hip_torque - z1405;
    const Scalar z2097 = u_front_right_thigh_torque - z1407;
    const Scalar z2098 = u_front_right_knee_torque - z1409;
    const Scalar z2099 = u_rear_left_hip_torque - z1411;
    const Scalar z2100 = u_rear_left_thigh_torque - z1413;
    const Scalar z2101 = u_rear_left_knee_torque - z1415;
    const Scalar z2102 = u_rear_right_hip_torque - z1417;
    const Scalar z2103 = u_rear_right_thigh_torque - z1419;
    const Scalar z2104 = u_rear_right_knee_torque - z1421;
    const Scalar z2105 = k16 * s_rear_right_knee;
    const Scalar z2106 = s_rear_right_knee * z2105;
    const Scalar z2107 = k16 - z2106;
    const Scalar z2108 = c_rear_right_knee * z2105;
    const Scalar z2109 = n0_2 * z2107;
    const Scalar z2110 = n0_2 * z2108;
    const Scalar z2111 = n0_2 * z2109;
    const Scalar z2112 = k17 - z2111;
    const Scalar z2113 = n0_124 - z2109;
    const Scalar z2114 = n1 / z2112;
    const Scalar z2115 = z2113 * z2114;
    const Scalar z2116 = z2110 * z2114;
    const Scalar z2117 = z2107 + z2113 * z2115;
    const Scalar z2118 = z2108 - z2113 * z2116;
    const Scalar z2119 = z2106 + z2110 * z2116;
    const Scalar z2120 = z2117 - z2119;
    const Scalar z2121 = n2 * z2118;
    const Scalar z2122 = s_rear_right_thigh * z2120 + c_rear_right_thigh * z2121;
    const Scalar z2123 = s_rear_right_thigh * z2122;
    const Scalar z2124 = z2119 + z2123;
    const Scalar z2125 = z2117 - z2123;
    const Scalar z2126 = c_rear_right_thigh * z2122 - z2118;
    const Scalar z2127 = n0_08 * z2126;
    const Scalar z2128 = n0_08 * z2124;
    const Scalar z2129 = n0_08 * z2125;
    const Scalar z2130 = z1004 - n0_08 * z2128;
    const Scalar z2131 = k18 + z2130;
    const Scalar z2132 = z1005 + n0_08 * z2127;
    const Scalar z2133 = z1003 + n0_08 * z2129;
    const Scalar z2134 = n0_1048 - z2128;
    const Scalar z2135 = n0_1048 - z2129;
    const Scalar z2136 = n1 / z2131;
    const Scalar z2137 = z2132 * z2136;
    const Scalar z2138 = z2127 * z2136;
    const Scalar z2139 = z978 * z2136;
    const Scalar z2140 = z2134 * z2136;
    const Scalar z2141 = z2125 + z2127 * z2138;
    const Scalar z2142 = z2127 * z2139;
    const Scalar z2143 = z978 * z2139;
    const Scalar z2144 = z2127 * z2137 - z2135;
    const Scalar z2145 = z2126 - z2127 * z2140;
    const Scalar z2146 = z978 * z2137 + z979;
    const Scalar z2147 = z978 * z2140;
    const Scalar z2148 = z2127 - z2134 * z2137;
    const Scalar z2149 = z2132 * z2137 + z2133;
    const Scalar z2150 = z2124 + z2134 * z2140;
    const Scalar z2151 = k19 - z2149;
    const Scalar z2152 = s_rear_right_hip * z2151;
    const Scalar z2153 = s_rear_right_hip * z2152;
    const Scalar z2154 = k19 - z2153;
    const Scalar z2155 = z2149 + z2153;
    const Scalar z2156 = c_rear_right_hip * z2152;
    const Scalar z2157 = s_rear_right_hip * z2148 + c_rear_right_hip * z2146;
    const Scalar z2158 = s_rear_right_hip * z2157;
    const Scalar z2159 = s_rear_right_hip * z2144;
    const Scalar z2160 = c_rear_right_hip * z2144;
    const Scalar z2161 = z2148 - z2158;
    const Scalar z2162 = c_rear_right_hip * z2157 - z2146;
    const Scalar z2163 = c_rear_right_hip * z2157;
    const Scalar z2164 = z2143 - z2150;
    const Scalar z2165 = n2 * z2147;
    const Scalar z2166 = s_rear_right_hip * z2164 + c_rear_right_hip * z2165;
    const Scalar z2167 = s_rear_right_hip * z2166;
    const Scalar z2168 = s_rear_right_hip * z2145 + c_rear_right_hip * z2142;
    const Scalar z2169 = s_rear_right_hip * z2142 - c_rear_right_hip * z2145;
    const Scalar z2170 = z2143 - z2167;
    const Scalar z2171 = z2150 + z2167;
    const Scalar z2172 = c_rear_right_hip * z2166 - z2147;
    const Scalar z2173 = n0_05 * z2169;
    const Scalar z2174 = n0_05 * z2172;
    const Scalar z2175 = n0_05 * z2171;
    const Scalar z2176 = z2159 - n0_2 * z2169;
    const Scalar z2177 = z2158 - n0_2 * z2172;
    const Scalar z2178 = z2162 + n0_2 * z2171;
    const Scalar z2179 = n0_05 * z2141 + z2160 - n0_2 * z2168;
    const Scalar z2180 = z2163 + n0_05 * z2168 - n0_2 * z2170;
    const Scalar z2181 = z2161 - n0_05 * z2169 + n0_2 * z2172;
    const Scalar z2182 = n0_05 * z2175;
    const Scalar z2183 = n0_0406 - z2182;
    const Scalar z2184 = n0_05 * z2162 + n0_2 * z2175;
    const Scalar z2185 = n0_2 * (z2162 + z2178) + z2154;
    const Scalar z2186 = k21 - z2185;
    const Scalar z2187 = n0_05 * (z2161 - z2173) + n0_2 * z2174;
    const Scalar z2188 = -n0_2 * (z2161 - z2177) + z2156 - n0_05 * z2176;
    const Scalar z2189 = n0_05 * (z2160 + z2179) - n0_2 * (z2163 + z2180) + z2155;
    const Scalar z2190 = k22 - z2189;
    const Scalar z2191 = n12_24 - z2141;
    const Scalar z2192 = n12_24 - z2170;
    const Scalar z2193 = n12_24 - z2171;
    const Scalar z2194 = k16 * s_rear_left_knee;
    const Scalar z2195 = s_rear_left_knee * z2194;
    const Scalar z2196 = k16 - z2195;
    const Scalar z2197 = c_rear_left_knee * z2194;
    const Scalar z2198 = n0_2 * z2196;
    const Scalar z2199 = n0_2 * z2197;
    const Scalar z2200 = n0_2 * z2198;
    const Scalar z2201 = k17 - z2200;
    const Scalar z2202 = n0_124 - z2198;
    const Scalar z2203 = n1 / z2201;
    const Scalar z2204 = z2202 * z2203;
    const Scalar z2205 = z2199 * z2203;
    const Scalar z2206 = z2196 + z2202 * z2204;
    const Scalar z2207 = z2197 - z2202 * z2205;
    const Scalar z2208 = z2195 + z2199 * z2205;
    const Scalar z2209 = z2206 - z2208;
    const Scalar z2210 = n2 * z2207;
    const Scalar z2211 = s_rear_left_thigh * z2209 + c_rear_left_thigh * z2210;
    const Scalar z2212 = s_rear_left_thigh * z2211;
    const Scalar z2213 = z2208 + z2212;
    const Scalar z2214 = z2206 - z2212;
    const Scalar z2215 = c_rear_left_thigh * z2211 - z2207;
    const Scalar z2216 = n0_08 * z2215;
    const Scalar z2217 = n0_08 * z2213;
    const Scalar z2218 = n0_08 * z2214;
    const Scalar z2219 = z1100 - n0_08 * z2217;
    const Scalar z2220 = k18 + z2219;
    const Scalar z2221 = z1101 + n0_08 * z2216;
    const Scalar z2222 = z1099 + n0_08 * z2218;
    const Scalar z2223 = n0_1048 - z2217;
    const Scalar z2224 = n0_1048 - z2218;
    const Scalar z2225 = n1 / z2220;
    const Scalar z2226 = z2221 * z2225;
    const Scalar z2227 = z2216 * z2225;
    const Scalar z2228 = z1074 * z2225;
    const Scalar z2229 = z2223 * z2225;
    const Scalar z2230 = z2214 + z2216 * z2227;
    const Scalar z2231 = z2216 * z2228;
    const Scalar z2232 = z1074 * z2228;
    const Scalar z2233 = z2216 * z2226 - z2224;
    const Scalar z2234 = z2215 - z2216 * z2229;
    const Scalar z2235 = z1074 * z2226 + z1075;
    const Scalar z2236 = z1074 * z2229;
    const Scalar z2237 = z2216 - z2223 * z2226;
    const Scalar z2238 = z2221 * z2226 + z2222;
    const Scalar z2239 = z2213 + z2223 * z2229;
    const Scalar z2240 = k19 - z2238;
    const Scalar z2241 = s_rear_left_hip * z2240;
    const Scalar z2242 = s_rear_left_hip * z2241;
    const Scalar z2243 = k19 - z2242;
    const Scalar z2244 = z2238 + z2242;
    const Scalar z2245 = c_rear_left_hip * z2241;
    const Scalar z2246 = s_rear_left_hip * z2237 - c_rear_left_hip * z2235;
    const Scalar z2247 = s_rear_left_hip * z2246;
    const Scalar z2248 = s_rear_left_hip * z2233;
    const Scalar z2249 = c_rear_left_hip * z2233;
    const Scalar z2250 = z2237 - z2247;
    const Scalar z2251 = c_rear_left_hip * z2246 + z2235;
    const Scalar z2252 = c_rear_left_hip * z2246;
    const Scalar z2253 = z2232 - z2239;
    const Scalar z2254 = n2 * z2236;
    const Scalar z2255 = s_rear_left_hip * z2253 - c_rear_left_hip * z2254;
    const Scalar z2256 = s_rear_left_hip * z2255;
    const Scalar z2257 = s_rear_left_hip * z2234 - c_rear_left_hip * z2231;
    const Scalar z2258 = s_rear_left_hip * z2231 + c_rear_left_hip * z2234;
    const Scalar z2259 = z2232 - z2256;
    const Scalar z2260 = z2239 + z2256;
    const Scalar z2261 = c_rear_left_hip * z2255 + z2236;
    const Scalar z2262 = n0_05 * z2258;
    const Scalar z2263 = n0_05 * z2261;
    const Scalar z2264 = n0_05 * z2260;
    const Scalar z2265 = z2248 - n0_2 * z2258;
    const Scalar z2266 = z2247 + n0_2 * z2261;
    const Scalar z2267 = z2251 - n0_2 * z2260;
    const Scalar z2268 = n0_05 * z2230 + z2249 + n0_2 * z2257;
    const Scalar z2269 = z2252 + n0_05 * z2257 + n0_2 * z2259;
    const Scalar z2270 = z2250 + n0_05 * z2258 - n0_2 * z2261;
    const Scalar z2271 = n0_05 * z2264;
    const Scalar z2272 = z2183 - z2271;
    const Scalar z2273 = n0_05 * z2251 - n0_2 * z2264;
    const Scalar z2274 = z2184 + z2273;
    const Scalar z2275 = -n0_2 * (z2251 + z2267) + z2243;
    const Scalar z2276 = z2186 - z2275;
    const Scalar z2277 = n0_05 * (z2250 + z2262) - n0_2 * z2263;
    const Scalar z2278 = z2187 + z2277;
    const Scalar z2279 = n0_2 * (z2250 - z2266) + z2245 - n0_05 * z2265;
    const Scalar z2280 = z2188 + z2279;
    const Scalar z2281 = n0_05 * (z2249 + z2268) + n0_2 * (z2252 + z2269) + z2244;
    const Scalar z2282 = z2190 - z2281;
    const Scalar z2283 = z2173 + z2262;
    const Scalar z2284 = z2174 - z2263;
    const Scalar z2285 = z2175 - z2264;
    const Scalar z2286 = z2176 - z2265;
    const Scalar z2287 = z2177 - z2266;
    const Scalar z2288 = z2178 - z2267;
    const Scalar z2289 = z2179 - z2268;
    const Scalar z2290 = z2180 - z2269;
    const Scalar z2291 = z2181 - z2270;
    const Scalar z2292 = z2191 - z2230;
    const Scalar z2293 = z2168 + z2257;
    const Scalar z2294 = z2169 - z2258;
    const Scalar z2295 = z2192 - z2259;
    const Scalar z2296 = z2172 + z2261;
    const Scalar z2297 = z2193 - z2260;
    const Scalar z2298 = k16 * s_front_right_knee;
    const Scalar z2299 = s_front_right_knee * z2298;
    const Scalar z2300 = k16 - z2299;
    const Scalar z2301 = c_front_right_knee * z2298;
    const Scalar z2302 = n0_2 * z2300;
    const Scalar z2303 = n0_2 * z2301;
    const Scalar z2304 = n0_2 * z2302;
    const Scalar z2305 = k17 - z2304;
    const Scalar z2306 = n0_124 - z2302;
    const Scalar z2307 = n1 / z2305;
    const Scalar z2308 = z2306 * z2307;
    const Scalar z2309 = z2303 * z2307;
    const Scalar z2310 = z2300 + z2306 * z2308;
    const Scalar z2311 = z2301 - z2306 * z2309;
    const Scalar z2312 = z2299 + z2303 * z2309;
    const Scalar z2313 = z2310 - z2312;
    const Scalar z2314 = n2 * z2311;
    const Scalar z2315 = s_front_right_thigh * z2313 + c_front_right_thigh * z2314;
    const Scalar z2316 = s_front_right_thigh * z2315;
    const Scalar z2317 = z2312 + z2316;
    const Scalar z2318 = z2310 - z2316;
    const Scalar z2319 = c_front_right_thigh * z2315 - z2311;
    const Scalar z2320 = n0_08 * z2319;
    const Scalar z2321 = n0_08 * z2317;
    const Scalar z2322 = n0_08 * z2318;
    const Scalar z2323 = z1202 - n0_08 * z2321;
    const Scalar z2324 = k18 + z2323;
    const Scalar z2325 = z1203 + n0_08 * z2320;
    const Scalar z2326 = z1201 + n0_08 * z2322;
    const Scalar z2327 = n0_1048 - z2321;
    const Scalar z2328 = n0_1048 - z2322;
    const Scalar z2329 = n1 / z2324;
    const Scalar z2330 = z2325 * z2329;
    const Scalar z2331 = z2320 * z2329;
    const Scalar z2332 = z1176 * z2329;
    const Scalar z2333 = z2327 * z2329;
    const Scalar z2334 = z2318 + z2320 * z2331;
    const Scalar z2335 = z2320 * z2332;
    const Scalar z2336 = z1176 * z2332;
    const Scalar z2337 = z2320 * z2330 - z2328;
    const Scalar z2338 = z2319 - z2320 * z2333;
    const Scalar z2339 = z1176 * z2330 + z1177;
    const Scalar z2340 = z1176 * z2333;
    const Scalar z2341 = z2320 - z2327 * z2330;
    const Scalar z2342 = z2325 * z2330 + z2326;
    const Scalar z2343 = z2317 + z2327 * z2333;
    const Scalar z2344 = k19 - z2342;
    const Scalar z2345 = s_front_right_hip * z2344;
    const Scalar z2346 = s_front_right_hip * z2345;
    const Scalar z2347 = k19 - z2346;
    const Scalar z2348 = z2342 + z2346;
    const Scalar z2349 = c_front_right_hip * z2345;
    const Scalar z2350 = s_front_right_hip * z2341 + c_front_right_hip * z2339;
    const Scalar z2351 = s_front_right_hip * z2350;
    const Scalar z2352 = s_front_right_hip * z2337;
    const Scalar z2353 = c_front_right_hip * z2337;
    const Scalar z2354 = z2341 - z2351;
    const Scalar z2355 = c_front_right_hip * z2350 - z2339;
    const Scalar z2356 = c_front_right_hip * z2350;
    const Scalar z2357 = z2336 - z2343;
    const Scalar z2358 = n2 * z2340;
    const Scalar z2359 = s_front_right_hip * z2357 + c_front_right_hip * z2358;
    const Scalar z2360 = s_front_right_hip * z2359;
    const Scalar z2361 = s_front_right_hip * z2338 + c_front_right_hip * z2335;
    const Scalar z2362 = s_front_right_hip * z2335 - c_front_right_hip * z2338;
    const Scalar z2363 = z2336 - z2360;
    const Scalar z2364 = z2343 + z2360;
    const Scalar z2365 = c_front_right_hip * z2359 - z2340;
    const Scalar z2366 = n0_05 * z2362;
    const Scalar z2367 = n0_05 * z2365;
    const Scalar z2368 = n0_05 * z2364;
    const Scalar z2369 = z2352 + n0_2 * z2362;
    const Scalar z2370 = z2351 + n0_2 * z2365;
    const Scalar z2371 = z2355 - n0_2 * z2364;
    const Scalar z2372 = n0_05 * z2334 + z2353 + n0_2 * z2361;
    const Scalar z2373 = z2356 + n0_05 * z2361 + n0_2 * z2363;
    const Scalar z2374 = z2354 - n0_05 * z2362 - n0_2 * z2365;
    const Scalar z2375 = n0_05 * z2368;
    const Scalar z2376 = z2272 - z2375;
    const Scalar z2377 = n0_05 * z2355 - n0_2 * z2368;
    const Scalar z2378 = z2274 + z2377;
    const Scalar z2379 = -n0_2 * (z2355 + z2371) + z2347;
    const Scalar z2380 = z2276 - z2379;
    const Scalar z2381 = n0_05 * (z2354 - z2366) - n0_2 * z2367;
    const Scalar z2382 = z2278 + z2381;
    const Scalar z2383 = n0_2 * (z2354 - z2370) + z2349 - n0_05 * z2369;
    const Scalar z2384 = z2280 + z2383;
    const Scalar z2385 = n0_05 * (z2353 + z2372) + n0_2 * (z2356 + z2373) + z2348;
    const Scalar z2386 = z2282 - z2385;
    const Scalar z2387 = z2283 + z2366;
    const Scalar z2388 = z2284 + z2367;
    const Scalar z2389 = z2285 + z2368;
    const Scalar z2390 = z2286 + z2369;
    const Scalar z2391 = z2287 + z2370;
    const Scalar z2392 = z2288 + z2371;
    const Scalar z2393 = z2289 + z2372;
    const Scalar z2394 = z2290 + z2373;
    const Scalar z2395 = z2291 + z2374;
    const Scalar z2396 = z2292 - z2334;
    const Scalar z2397 = z2293 + z2361;
    const Scalar z2398 = z2294 + z2362;
    const Scalar z2399 = z2295 - z2363;
    const Scalar z2400 = z2296 + z2365;
    const Scalar z2401 = z2297 - z2364;
    const Scalar z2402 = k16 * s_front_left_knee;
    const Scalar z2403 = s_front_left_knee * z2402;
    const Scalar z2404 = k16 - z2403;
    const Scalar z2405 = c_front_left_knee * z2402;
    const Scalar z2406 = n0_2 * z2404;
    const Scalar z2407 = n0_2 * z2405;
    const Scalar z2408 = n0_2 * z2406;
    const Scalar z2409 = k17 - z2408;
    const Scalar z2410 = n0_124 - z2406;
    const Scalar z2411 = n1 / z2409;
    const Scalar z2412 = z2410 * z2411;
    const Scalar z2413 = z2407 * z2411;
    const Scalar z2414 = z2404 + z2410 * z2412;
    const Scalar z2415 = z2405 - z2410 * z2413;
    const Scalar z2416 = z2403 + z2407 * z2413;
    const Scalar z2417 = z2414 - z2416;
    const Scalar z2418 = n2 * z2415;
    const Scalar z2419 = s_front_left_thigh * z2417 + c_front_left_thigh * z2418;
    const Scalar z2420 = s_front_left_thigh * z2419;
    const Scalar z2421 = z2416 + z2420;
    const Scalar z2422 = z2414 - z2420;
    const Scalar z2423 = c_front_left_thigh * z2419 - z2415;
    const Scalar z2424 = n0_08 * z2423;
    const Scalar z2425 = n0_08 * z2421;
    const Scalar z2426 = n0_08 * z2422;
    const Scalar z2427 = z1304 - n0_08 * z2425;
    const Scalar z2428 = k18 + z2427;
    const Scalar z2429 = z1305 + n0_08 * z2424;
    const Scalar z2430 = z1303 + n0_08 * z2426;
    const Scalar z2431 = n0_1048 - z2425;
    const Scalar z2432 = n0_1048 - z2426;
    const Scalar z2433 = n1 / z2428;
    const Scalar z2434 = z2429 * z2433;
    const Scalar z2435 = z2424 * z2433;
    const Scalar z2436 = z1278 * z2433;
    const Scalar z2437 = z2431 * z2433;
    const Scalar z2438 = z2422 + z2424 * z2435;
    const Scalar z2439 = z2424 * z2436;
    const Scalar z2440 = z1278 * z2436;
    const Scalar z2441 = z2424 * z2434 - z2432;
    const Scalar z2442 = z2423 - z2424 * z2437;
    const Scalar z2443 = z1278 * z2434 + z1279;
    const Scalar z2444 = z1278 * z2437;
    const Scalar z2445 = z2424 - z2431 * z2434;
    const Scalar z2446 = z2429 * z2434 + z2430;
    const Scalar z2447 = z2421 + z2431 * z2437;
    const Scalar z2448 = k19 - z2446;
    const Scalar z2449 = s_front_left_hip * z2448;
    const Scalar z2450 = s_front_left_hip * z2449;
    const Scalar z2451 = k19 - z2450;
    const Scalar z2452 = z2446 + z2450;
    const Scalar z2453 = c_front_left_hip * z2449;
    const Scalar z2454 = s_front_left_hip * z2445 - c_front_left_hip * z2443;
    const Scalar z2455 = s_front_left_hip * z2454;
    const Scalar z2456 = s_front_left_hip * z2441;
    const Scalar z2457 = c_front_left_hip * z2441;
    const Scalar z2458 = z2445 - z2455;
    const Scalar z2459 = c_front_left_hip * z2454 + z2443;
    const Scalar z2460 = c_front_left_hip * z2454;
    const Scalar z2461 = z2440 - z2447;
    const Scalar z2462 = n2 * z2444;
    const Scalar z2463 = s_front_left_hip * z2461 - c_front_left_hip * z2462;
    const Scalar z2464 = s_front_left_hip * z2463;
    const Scalar z2465 = s_front_left_hip * z2442 - c_front_left_hip * z2439;
    const Scalar z2466 = s_front_left_hip * z2439 + c_front_left_hip * z2442;
    const Scalar z2467 = z2440 - z2464;
    const Scalar z2468 = z2447 + z2464;
    const Scalar z2469 = c_front_left_hip * z2463 + z2444;
    const Scalar z2470 = n0_05 * z2466;
    const Scalar z2471 = n0_05 * z2469;
    const Scalar z2472 = n0_05 * z2468;
    const Scalar z2473 = z2456 + n0_2 * z2466;
    const Scalar z2474 = z2455 - n0_2 * z2469;
    const Scalar z2475 = z2459 + n0_2 * z2468;
    const Scalar z2476 = n0_05 * z2438 + z2457 - n0_2 * z2465;
    const Scalar z2477 = z2460 + n0_05 * z2465 - n0_2 * z2467;
    const Scalar z2478 = z2458 + n0_05 * z2466 + n0_2 * z2469;
    const Scalar z2479 = n0_05 * z2472;
    const Scalar z2480 = z2376 - z2479;
    const Scalar z2481 = n0_05 * z2459 + n0_2 * z2472;
    const Scalar z2482 = z2378 + z2481;
    const Scalar z2483 = n0_2 * (z2459 + z2475) + z2451;
    const Scalar z2484 = z2380 - z2483;
    const Scalar z2485 = n0_05 * (z2458 + z2470) + n0_2 * z2471;
    const Scalar z2486 = z2382 + z2485;
    const Scalar z2487 = -n0_2 * (z2458 - z2474) + z2453 - n0_05 * z2473;
    const Scalar z2488 = z2384 + z2487;
    const Scalar z2489 = n0_05 * (z2457 + z2476) - n0_2 * (z2460 + z2477) + z2452;
    const Scalar z2490 = z2386 - z2489;
    const Scalar z2491 = z2387 + z2470;
    const Scalar z2492 = z2388 - z2471;
    const Scalar z2493 = z2389 - z2472;
    const Scalar z2494 = z2390 - z2473;
    const Scalar z2495 = z2391 - z2474;
    const Scalar z2496 = z2392 - z2475;
    const Scalar z2497 = z2393 - z2476;
    const Scalar z2498 = z2394 - z2477;
    const Scalar z2499 = z2395 - z2478;
    const Scalar z2500 = z2396 - z2438;
    const Scalar z2501 = z2397 + z2465;
    const Scalar z2502 = z2398 - z2466;
    const Scalar z2503 = z2399 - z2467;
    const Scalar z2504 = z2400 + z2469;
    const Scalar z2505 = z2401 - z2468;
    const Scalar z2506 = n1 / z2490;
    const Scalar z2507 = z2486 * z2506;
    const Scalar z2508 = z2488 * z2506;
    const Scalar z2509 = z2497 * z2506;
    const Scalar z2510 = z2498 * z2506;
    const Scalar z2511 = z2499 * z2506;
    const Scalar z2512 = z2491 - z2497 * z2507;
    const Scalar z2513 = z2480 - z2486 * z2507;
    const Scalar z2514 = z2497 * z2509 - z2500;
    const Scalar z2515 = z2492 - z2498 * z2507;
    const Scalar z2516 = z2493 + z2499 * z2507;
    const Scalar z2517 = z2494 - z2497 * z2508;
    const Scalar z2518 = z2482 - z2486 * z2508;
    const Scalar z2519 = z2497 * z2510 + z2501;
    const Scalar z2520 = z2495 - z2498 * z2508;
    const Scalar z2521 = z2484 - z2488 * z2508;
    const Scalar z2522 = z2498 * z2510 - z2503;
    const Scalar z2523 = z2496 - z2499 * z2508;
    const Scalar z2524 = z2497 * z2511 - z2502;
    const Scalar z2525 = z2498 * z2511 - z2504;
    const Scalar z2526 = z2499 * z2511 - z2505;
    const Scalar z2527 = n1 / z2521;
    const Scalar z2528 = z2518 * z2527;
    const Scalar z2529 = z2517 * z2527;
    const Scalar z2530 = z2520 * z2527;
    const Scalar z2531 = z2523 * z2527;
    const Scalar z2532 = z2512 - z2517 * z2528;
    const Scalar z2533 = z2513 - z2518 * z2528;
    const Scalar z2534 = z2514 + z2517 * z2529;
    const Scalar z2535 = z2515 - z2520 * z2528;
    const Scalar z2536 = z2516 + z2523 * z2528;
    const Scalar z2537 = z2517 * z2530 + z2519;
    const Scalar z2538 = z2520 * z2530 + z2522;
    const Scalar z2539 = z2517 * z2531 + z2524;
    const Scalar z2540 = z2520 * z2531 + z2525;
    const Scalar z2541 = z2523 * z2531 + z2526;
    const Scalar z2542 = n1 / z2533;
    const Scalar z2543 = z2532 * z2542;
    const Scalar z2544 = z2535 * z2542;
    const Scalar z2545 = z2536 * z2542;
    const Scalar z2546 = z2532 * z2543 + z2534;
    const Scalar z2547 = z2532 * z2544 + z2537;
    const Scalar z2548 = z2535 * z2544 + z2538;
    const Scalar z2549 = z2532 * z2545 - z2539;
    const Scalar z2550 = z2535 * z2545 - z2540;
    const Scalar z2551 = z2536 * z2545 + z2541;
    const Scalar z2552 = z17 * z2546 + z18 * z2547 + z30 * z2549;
    const Scalar z2553 = z17 * z2547 + z18 * z2548 + z30 * z2550;
    const Scalar z2554 = z17 * z2549 + z18 * z2550 + z30 * z2551;
    const Scalar z2555 = z19 * z2546 + z23 * z2547 + z24 * z2549;
    const Scalar z2556 = z19 * z2547 + z23 * z2548 + z24 * z2550;
    const Scalar z2557 = z19 * z2549 + z23 * z2550 + z24 * z2551;
    const Scalar z2558 = z25 * z2547 + z28 * z2549 + z29 * z2546;
    const Scalar z2559 = z25 * z2548 + z28 * z2550 + z29 * z2547;
    const Scalar z2560 = z25 * z2550 + z28 * z2551 + z29 * z2549;
    const Scalar z2561 = z17 * z2552 + z18 * z2553 + z30 * z2554;
    const Scalar z2563 = z25 * z2553 + z28 * z2554 + z29 * z2552;
    const Scalar z2564 = z17 * z2555 + z18 * z2556 + z30 * z2557;
    const Scalar z2565 = z19 * z2555 + z23 * z2556 + z24 * z2557;
    const Scalar z2566 = z25 * z2556 + z28 * z2557 + z29 * z2555;
    const Scalar z2569 = z25 * z2559 + z28 * z2560 + z29 * z2558;
    const Scalar z2570 = n1 / z2569;
    const Scalar z2571 = z2563 * z2570;
    const Scalar z2572 = z2566 * z2570;
    const Scalar z2573 = z2561 - z2563 * z2571;
    const Scalar z2574 = z2563 * z2572 - z2564;
    const Scalar z2575 = z2565 - z2566 * z2572;
    const Scalar z2582 = n1 / z2575;
    const Scalar z2585 = z2574 * z2582;
    const Scalar z2588 = z2573 - z2574 * z2585;
    const Scalar z2596 = n1 / z2588;
    const Scalar z2600 = z1451 - n0_2 * z1455;
    const Scalar z2601 = s_front_left_knee * z1466 - c_front_left_knee * z2600;
    const Scalar z2603 = z1489 - n0_2 * z1493;
    const Scalar z2604 = s_front_right_knee * z1504 - c_front_right_knee * z2603;
    const Scalar z2606 = z1527 - n0_2 * z1531;
    const Scalar z2607 = s_rear_left_knee * z1542 - c_rear_left_knee * z2606;
    const Scalar z2609 = z1565 - n0_2 * z1569;
    const Scalar z2610 = s_rear_right_knee * z1580 - c_rear_right_knee * z2609;
    const Scalar z2612 = n0_032 * z1585;
    const Scalar z2613 = k3 * z1585 - n0_032 * z2610;
    const Scalar z2614 = z2104 + z2613;
    const Scalar z2615 = k24 * z2614;
    const Scalar z2616 = z2612 - k25 * z2614;
    const Scalar z2617 = s_rear_right_knee * z1596 + c_rear_right_knee * z2616;
    const Scalar z2618 = s_rear_right_knee * z2616 - c_rear_right_knee * z1596;
    const Scalar z2619 = n0_124 * z1569 - z2617;
    const Scalar z2620 = n0_124 * z1575 - z2618;
    const Scalar z2621 = n0_124 * z1565 - k7 * z1569 - z2104 + n0_2 * z2617;
    const Scalar z2622 = z2103 + z2621;
    const Scalar z2623 = z2114 * z2622;
    const Scalar z2624 = z2115 * z2622 + z2619;
    const Scalar z2625 = z2116 * z2622 - z2620;
    const Scalar z2626 = s_rear_right_thigh * z2625 + c_rear_right_thigh * z2624;
    const Scalar z2627 = s_rear_right_thigh * z2624 - c_rear_right_thigh * z2625;
    const Scalar z2628 = n0_1048 * z1555 + z2626;
    const Scalar z2629 = n0_1048 * z1559 + z2627;
    const Scalar z2630 = n0_1048 * z1551 - k26 * z1559 - z1614 - n0_08 * z2627;
    const Scalar z2631 = n0_0002 * z1617 - z2103;
    const Scalar z2632 = n0_1048 * z1547 - k27 * z1555 - z1615 - n0_08 * z2626;
    const Scalar z2633 = z2102 - z2630;
    const Scalar z2634 = z2136 * z2633;
    const Scalar z2635 = z2137 * z2633 - z2632;
    const Scalar z2636 = z2138 * z2633 + z2628;
    const Scalar z2637 = z1619 - z2139 * z2633;
    const Scalar z2638 = z2140 * z2633 - z2629;
    const Scalar z2639 = s_rear_right_hip * z2638 + c_rear_right_hip * z2637;
    const Scalar z2640 = s_rear_right_hip * z2637 - c_rear_right_hip * z2638;
    const Scalar z2641 = s_rear_right_hip * z2635 - c_rear_right_hip * z2631;
    const Scalar z2642 = s_rear_right_hip * z2631 + c_rear_right_hip * z2635;
    const Scalar z2643 = n0_032 * z1628;
    const Scalar z2644 = k3 * z1628 - n0_032 * z2607;
    const Scalar z2645 = z2101 + z2644;
    const Scalar z2646 = k24 * z2645;
    const Scalar z2647 = z2643 - k25 * z2645;
    const Scalar z2648 = s_rear_left_knee * z1639 + c_rear_left_knee * z2647;
    const Scalar z2649 = s_rear_left_knee * z2647 - c_rear_left_knee * z1639;
    const Scalar z2650 = n0_124 * z1531 - z2648;
    const Scalar z2651 = n0_124 * z1537 - z2649;
    const Scalar z2652 = n0_124 * z1527 - k7 * z1531 - z2101 + n0_2 * z2648;
    const Scalar z2653 = z2100 + z2652;
    const Scalar z2654 = z2203 * z2653;
    const Scalar z2655 = z2204 * z2653 + z2650;
    const Scalar z2656 = z2205 * z2653 - z2651;
    const Scalar z2657 = s_rear_left_thigh * z2656 + c_rear_left_thigh * z2655;
    const Scalar z2658 = s_rear_left_thigh * z2655 - c_rear_left_thigh * z2656;
    const Scalar z2659 = n0_1048 * z1517 - z2657;
    const Scalar z2660 = n0_1048 * z1521 - z2658;
    const Scalar z2661 = n0_1048 * z1513 + k26 * z1521 + z1657 - n0_08 * z2658;
    const Scalar z2662 = n0_0002 * z1660 - z2100;
    const Scalar z2663 = n0_1048 * z1509 + k27 * z1517 + z1658 - n0_08 * z2657;
    const Scalar z2664 = z2099 + z2661;
    const Scalar z2665 = z2225 * z2664;
    const Scalar z2666 = z2226 * z2664 + z2663;
    const Scalar z2667 = z2227 * z2664 + z2659;
    const Scalar z2668 = z1662 + z2228 * z2664;
    const Scalar z2669 = z2229 * z2664 - z2660;
    const Scalar z2670 = s_rear_left_hip * z2669 + c_rear_left_hip * z2668;
    const Scalar z2671 = s_rear_left_hip * z2668 - c_rear_left_hip * z2669;
    const Scalar z2672 = s_rear_left_hip * z2666 - c_rear_left_hip * z2662;
    const Scalar z2673 = s_rear_left_hip * z2662 + c_rear_left_hip * z2666;
    const Scalar z2674 = n0_032 * z1671;
    const Scalar z2675 = k3 * z1671 - n0_032 * z2604;
    const Scalar z2676 = z2098 + z2675;
    const Scalar z2677 = k24 * z2676;
    const Scalar z2678 = z2674 - k25 * z2676;
    const Scalar z2679 = s_front_right_knee * z1682 + c_front_right_knee * z2678;
    const Scalar z2680 = s_front_right_knee * z2678 - c_front_right_knee * z1682;
    const Scalar z2681 = n0_124 * z1493 - z2679;
    const Scalar z2682 = n0_124 * z1499 - z2680;
    const Scalar z2683 = n0_124 * z1489 - k7 * z1493 - z2098 + n0_2 * z2679;
    const Scalar z2684 = z2097 + z2683;
    const Scalar z2685 = z2307 * z2684;
    const Scalar z2686 = z2308 * z2684 + z2681;
    const Scalar z2687 = z2309 * z2684 - z2682;
    const Scalar z2688 = s_front_right_thigh * z2687 + c_front_right_thigh * z2686;
    const Scalar z2689 = s_front_right_thigh * z2686 - c_front_right_thigh * z2687;
    const Scalar z2690 = n0_1048 * z1479 + z2688;
    const Scalar z2691 = n0_1048 * z1483 + z2689;
    const Scalar z2692 = n0_1048 * z1475 - k26 * z1483 - z1700 - n0_08 * z2689;
    const Scalar z2693 = n0_0002 * z1703 - z2097;
    const Scalar z2694 = n0_1048 * z1471 - k27 * z1479 - z1701 - n0_08 * z2688;
    const Scalar z2695 = z2096 - z2692;
    const Scalar z2696 = z2329 * z2695;
    const Scalar z2697 = z2330 * z2695 - z2694;
    const Scalar z2698 = z2331 * z2695 + z2690;
    const Scalar z2699 = z1705 - z2332 * z2695;
    const Scalar z2700 = z2333 * z2695 - z2691;
    const Scalar z2701 = s_front_right_hip * z2700 + c_front_right_hip * z2699;
    const Scalar z2702 = s_front_right_hip * z2699 - c_front_right_hip * z2700;
    const Scalar z2703 = s_front_right_hip * z2697 - c_front_right_hip * z2693;
    const Scalar z2704 = s_front_right_hip * z2693 + c_front_right_hip * z2697;
    const Scalar z2705 = n0_032 * z1714;
    const Scalar z2706 = k3 * z1714 - n0_032 * z2601;
    const Scalar z2707 = z2095 + z2706;
    const Scalar z2708 = k24 * z2707;
    const Scalar z2709 = z2705 - k25 * z2707;
    const Scalar z2710 = s_front_left_knee * z1725 + c_front_left_knee * z2709;
    const Scalar z2711 = s_front_left_knee * z2709 - c_front_left_knee * z1725;
    const Scalar z2712 = n0_124 * z1455 - z2710;
    const Scalar z2713 = n0_124 * z1461 - z2711;
    const Scalar z2714 = n0_124 * z1451 - k7 * z1455 - z2095 + n0_2 * z2710;
    const Scalar z2715 = z2094 + z2714;
    const Scalar z2716 = z2411 * z2715;
    const Scalar z2717 = z2412 * z2715 + z2712;
    const Scalar z2718 = z2413 * z2715 - z2713;
    const Scalar z2719 = s_front_left_thigh * z2718 + c_front_left_thigh * z2717;
    const Scalar z2720 = s_front_left_thigh * z2717 - c_front_left_thigh * z2718;
    const Scalar z2721 = n0_1048 * z1441 - z2719;
    const Scalar z2722 = n0_1048 * z1445 - z2720;
    const Scalar z2723 = n0_1048 * z1437 + k26 * z1445 + z1743 - n0_08 * z2720;
    const Scalar z2724 = n0_0002 * z1746 - z2094;
    const Scalar z2725 = n0_1048 * z1433 + k27 * z1441 + z1744 - n0_08 * z2719;
    const Scalar z2726 = z2093 + z2723;
    const Scalar z2727 = z2433 * z2726;
    const Scalar z2728 = z2434 * z2726 + z2725;
    const Scalar z2729 = z2435 * z2726 + z2721;
    const Scalar z2730 = z1748 + z2436 * z2726;
    const Scalar z2731 = z2437 * z2726 - z2722;
    const Scalar z2732 = s_front_left_hip * z2731 + c_front_left_hip * z2730;
    const Scalar z2733 = s_front_left_hip * z2730 - c_front_left_hip * z2731;
    const Scalar z2734 = s_front_left_hip * z2728 - c_front_left_hip * z2724;
    const Scalar z2735 = s_front_left_hip * z2724 + c_front_left_hip * z2728;
    const Scalar z2736 = n12_24 * z1422 - z2636 + z2667 - z2698 + z2729;
    const Scalar z2737 = n12_24 * z1423 + z2639 - z2670 + z2701 - z2732;
    const Scalar z2738 = n12_24 * z1424 + z2640 - z2671 + z2702 - z2733;
    const Scalar z2739 = -n0_05 * (z2640 + z2671 + z2702 + z2733) + n0_0306 * z1432 + z2093 + z2096 + z2099 + z2102;
    const Scalar z2740 = -n0_2 * (z2640 - z2671 - z2702 + z2733) + n0_3254 * z1431 - z2641 - z2672 - z2703 - z2734;
    const Scalar z2741 = -n0_05 * (z2636 + z2667 + z2698 + z2729) - n0_2 * (z2639 - z2670 - z2701 + z2732) + n0_2948
        * z1428 - z2642 - z2673 - z2704 - z2735;
    const Scalar z2742 = z2506 * z2741;
    const Scalar z2743 = z2507 * z2741 + z2739;
    const Scalar z2744 = z2508 * z2741 - z2740;
    const Scalar z2745 = z2509 * z2741 + z2736;
    const Scalar z2746 = z2510 * z2741 + z2737;
    const Scalar z2747 = z2511 * z2741 - z2738;
    const Scalar z2748 = z2527 * z2744;
    const Scalar z2749 = z2528 * z2744 - z2743;
    const Scalar z2750 = z2529 * z2744 - z2745;
    const Scalar z2751 = z2530 * z2744 - z2746;
    const Scalar z2752 = z2531 * z2744 - z2747;
    const Scalar z2753 = z2542 * z2749;
    const Scalar z2754 = z2543 * z2749 - z2750;
    const Scalar z2755 = z2544 * z2749 - z2751;
    const Scalar z2756 = z2545 * z2749 + z2752;
    const Scalar z2757 = z17 * z2754 + z18 * z2755 + z30 * z2756;
    const Scalar z2758 = z19 * z2754 + z23 * z2755 + z24 * z2756;
    const Scalar z2759 = z25 * z2755 + z28 * z2756 + z29 * z2754;
    const Scalar z2760 = z2570 * z2759;
    const Scalar z2761 = z2571 * z2759 - z2757;
    const Scalar z2762 = z2572 * z2759 - z2758;
    const Scalar z2765 = z2582 * z2762;
    const Scalar z2768 = z2585 * z2762 + z2761;
    const Scalar z2770 = z2596 * z2768;
    const Scalar z2774 = z2585 * z2770 + z2765;
    const Scalar z2775 = z2571 * z2770 + z2572 * z2774 + z2760;
    const Scalar z2776 = z17 * z2770 + z19 * z2774 - z29 * z2775;
    const Scalar z2777 = z18 * z2770 + z23 * z2774 - z25 * z2775;
    const Scalar z2778 = z24 * z2774 - z28 * z2775 + z30 * z2770;
    const Scalar z2779 = z2543 * z2776 + z2544 * z2777 + z2545 * z2778 + z2753;
    const Scalar z2780 = z2528 * z2779 - z2529 * z2776 - z2530 * z2777 + z2531 * z2778 + z2748;
    const Scalar z2781 = z2507 * z2779 - z2508 * z2780 - z2509 * z2776 - z2510 * z2777 + z2511 * z2778 - z2742;
    const Scalar z2782 = z2776 + n0_05 * z2781;
    const Scalar z2783 = z2777 - n0_2 * z2781;
    const Scalar z2784 = z2778 - n0_05 * z2779 - n0_2 * z2780;
    const Scalar z2785 = s_front_left_hip * z2781 - c_front_left_hip * z2780;
    const Scalar z2786 = s_front_left_hip * z2780 + c_front_left_hip * z2781;
    const Scalar z2787 = s_front_left_hip * z2784 + c_front_left_hip * z2783;
    const Scalar z2788 = s_front_left_hip * z2783 - c_front_left_hip * z2784;
    const Scalar z2789 = z2434 * z2786 + z2435 * z2782 - z2436 * z2787 - z2437 * z2788 + z2727;
    const Scalar z2790 = z2779 - z2789;
    const Scalar z2791 = z2782 + n0_08 * z2786;
    const Scalar z2792 = z2788 + n0_08 * z2789;
    const Scalar z2795 = s_front_left_thigh * z2792 + c_front_left_thigh * z2791;
    const Scalar z2796 = s_front_left_thigh * z2791 - c_front_left_thigh * z2792;
    const Scalar z2797 = z2412 * z2795 + z2413 * z2796 - z2716;
    const Scalar z2798 = z2785 + z2797;
    const Scalar z2799 = z1438 - z2798;  // acceleration of joint front_left_thigh_link
    const Scalar z2800 = z2795 - n0_2 * z2797;
    const Scalar z2804 = s_front_left_knee * z2796 - c_front_left_knee * z2800;
    const Scalar z2806 = z2708 + k25 * z2804;
    const Scalar z2807 = z2797 + z2806;
    const Scalar z2808 = z2776 - n0_05 * z2781;
    const Scalar z2809 = z2778 + n0_05 * z2779 - n0_2 * z2780;
    const Scalar z2810 = s_front_right_hip * z2781 - c_front_right_hip * z2780;
    const Scalar z2811 = s_front_right_hip * z2780 + c_front_right_hip * z2781;
    const Scalar z2812 = s_front_right_hip * z2809 + c_front_right_hip * z2783;
    const Scalar z2813 = s_front_right_hip * z2783 - c_front_right_hip * z2809;
    const Scalar z2814 = z2330 * z2811 - z2331 * z2808 - z2332 * z2812 + z2333 * z2813 + z2696;
    const Scalar z2815 = z2779 - z2814;
    const Scalar z2816 = z2808 - n0_08 * z2811;
    const Scalar z2817 = z2813 - n0_08 * z2814;
    const Scalar z2820 = s_front_right_thigh * z2817 + c_front_right_thigh * z2816;
    const Scalar z2821 = s_front_right_thigh * z2816 - c_front_right_thigh * z2817;
    const Scalar z2822 = z2308 * z2820 + z2309 * z2821 - z2685;
    const Scalar z2823 = z2810 + z2822;
    const Scalar z2824 = z1476 - z2823;  // acceleration of joint front_right_thigh_link
    const Scalar z2825 = z2820 - n0_2 * z2822;
    const Scalar z2829 = s_front_right_knee * z2821 - c_front_right_knee * z2825;
    const Scalar z2831 = z2677 + k25 * z2829;
    const Scalar z2832 = z2822 + z2831;
    const Scalar z2833 = z2777 + n0_2 * z2781;
    const Scalar z2834 = z2778 - n0_05 * z2779 + n0_2 * z2780;
    const Scalar z2835 = s_rear_left_hip * z2781 - c_rear_left_hip * z2780;
    const Scalar z2836 = s_rear_left_hip * z2780 + c_rear_left_hip * z2781;
    const Scalar z2837 = s_rear_left_hip * z2834 + c_rear_left_hip * z2833;
    const Scalar z2838 = s_rear_left_hip * z2833 - c_rear_left_hip * z2834;
    const Scalar z2839 = z2226 * z2836 + z2227 * z2782 - z2228 * z2837 - z2229 * z2838 + z2665;
    const Scalar z2840 = z2779 - z2839;
    const Scalar z2841 = z2782 + n0_08 * z2836;
    const Scalar z2842 = z2838 + n0_08 * z2839;
    const Scalar z2845 = s_rear_left_thigh * z2842 + c_rear_left_thigh * z2841;
    const Scalar z2846 = s_rear_left_thigh * z2841 - c_rear_left_thigh * z2842;
    const Scalar z2847 = z2204 * z2845 + z2205 * z2846 - z2654;
    const Scalar z2848 = z2835 + z2847;
    const Scalar z2849 = z1514 - z2848;  // acceleration of joint rear_left_thigh_link
    const Scalar z2850 = z2845 - n0_2 * z2847;
    const Scalar z2854 = s_rear_left_knee * z2846 - c_rear_left_knee * z2850;
    const Scalar z2856 = z2646 + k25 * z2854;
    const Scalar z2857 = z2847 + z2856;
    const Scalar z2858 = z2778 + n0_05 * z2779 + n0_2 * z2780;
    const Scalar z2859 = s_rear_right_hip * z2781 - c_rear_right_hip * z2780;
    const Scalar z2860 = s_rear_right_hip * z2780 + c_rear_right_hip * z2781;
    const Scalar z2861 = s_rear_right_hip * z2858 + c_rear_right_hip * z2833;
    const Scalar z2862 = s_rear_right_hip * z2833 - c_rear_right_hip * z2858;
    const Scalar z2863 = z2137 * z2860 - z2138 * z2808 - z2139 * z2861 + z2140 * z2862 + z2634;
    const Scalar z2864 = z2779 - z2863;
    const Scalar z2865 = z2808 - n0_08 * z2860;
    const Scalar z2866 = z2862 - n0_08 * z2863;
    const Scalar z2869 = s_rear_right_thigh * z2866 + c_rear_right_thigh * z2865;
    const Scalar z2870 = s_rear_right_thigh * z2865 - c_rear_right_thigh * z2866;
    const Scalar z2871 = z2115 * z2869 + z2116 * z2870 - z2623;
    const Scalar z2872 = z2859 + z2871;
    const Scalar z2873 = z1552 - z2872;  // acceleration of joint rear_right_thigh_link
    const Scalar z2874 = z2869 - n0_2 * z2871;
    const Scalar z2878 = s_rear_right_knee * z2870 - c_rear_right_knee * z2874;
    const Scalar z2880 = z2615 + k25 * z2878;
    const Scalar z2881 = z2871 + z2880;
    accelerations.trunk_x = -z2770;
    accelerations.trunk_y = -z2774;
    accelerations.trunk_z = z2775;
    accelerations.trunk_attitude_omega_x = z2779;
    accelerations.trunk_attitude_omega_y = -z2780;
    accelerations.trunk_attitude_omega_z = z2781;
    accelerations.front_left_hip = -z2790;
    accelerations.front_left_thigh = z2799;
    accelerations.front_left_knee = z2807;
    accelerations.front_right_hip = -z2815;
    accelerations.front_right_thigh = z2824;
    accelerations.front_right_knee = z2832;
    accelerations.rear_left_hip = -z2840;
    accelerations.rear_left_thigh = z2849;
    accelerations.rear_left_knee = z2857;
    accelerations.rear_right_hip = -z2864;
    accelerations.rear_right_thigh = z2873;
    accelerations.rear_right_knee = z2881;
    if (!(traits::regular(z2112, z2112) && traits::regular(z2131, z2131) && traits::regular(z2201, z2201)
        && traits::regular(z2220, z2220) && traits::regular(z2305, z2305) && traits::regular(z2324, z2324)
        && traits::regular(z2409, z2409) && traits::regular(z2428, z2428) && traits::regular(z2490, z2490)
        && traits::regular(z2521, z2521) && traits::regular(z2533, z2533) && traits::regular(-z2569, -z2569)
        && traits::regular(-z2575, -z2575) && traits::regular(-z2588, -z2588))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.trunk_x - accelerations.trunk_x) + (accelerations.trunk_y
        - accelerations.trunk_y) + (accelerations.trunk_z - accelerations.trunk_z)
        + (accelerations.trunk_attitude_omega_x - accelerations.trunk_attitude_omega_x)
        + (accelerations.trunk_attitude_omega_y - accelerations.trunk_attitude_omega_y)
        + (accelerations.trunk_attitude_omega_z - accelerations.trunk_attitude_omega_z) + (accelerations.front_left_hip
        - accelerations.front_left_hip) + (accelerations.front_left_thigh - accelerations.front_left_thigh)
        + (accelerations.front_left_knee - accelerations.front_left_knee) + (accelerations.front_right_hip
        - accelerations.front_right_hip) + (accelerations.front_right_thigh - accelerations.front_right_thigh)
        + (accelerations.front_right_knee - accelerations.front_right_knee) + (accelerations.rear_left_hip
        - accelerations.rear_left_hip) + (accelerations.rear_left_thigh - accelerations.rear_left_thigh)
        + (accelerations.rear_left_knee - accelerations.rear_left_knee) + (accelerations.rear_right_hip
        - accelerations.rear_right_hip) + (accelerations.rear_right_thigh - accelerations.rear_right_thigh)
        + (accelerations.rear_right_knee - accelerations.rear_right_knee);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_0014 = traits::constant(0.0014, 0.0014f, "7/5000");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k10 = traits::constant(0.00928, 0.00928f, "29/3125");
    const Scalar n0_26 = traits::constant(0.26, 0.26f, "13/50");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k13 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar k17 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_13 = traits::constant(0.13, 0.13f, "13/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_0125 = traits::constant(0.0125, 0.0125f, "1/80");
    const Scalar n0_0425 = traits::constant(0.0425, 0.0425f, "17/400");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n2_5506 = traits::constant(2.5506, 2.5506f, "12753/5000");
    const Scalar n58_86 = traits::constant(58.86, 58.86f, "2943/50");
    const Scalar v_trunk_x = state.v.trunk_x;
    const Scalar v_trunk_y = state.v.trunk_y;
    const Scalar q_trunk_z = state.q.trunk_z;
    const Scalar v_trunk_z = state.v.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar u_front_left_hip_torque = inputs.front_left_hip_torque;
    const Scalar u_front_left_thigh_torque = inputs.front_left_thigh_torque;
    const Scalar u_front_left_knee_torque = inputs.front_left_knee_torque;
    const Scalar u_front_right_hip_torque = inputs.front_right_hip_torque;
    const Scalar u_front_right_thigh_torque = inputs.front_right_thigh_torque;
    const Scalar u_front_right_knee_torque = inputs.front_right_knee_torque;
    const Scalar u_rear_left_hip_torque = inputs.rear_left_hip_torque;
    const Scalar u_rear_left_thigh_torque = inputs.rear_left_thigh_torque;
    const Scalar u_rear_left_knee_torque = inputs.rear_left_knee_torque;
    const Scalar u_rear_right_hip_torque = inputs.rear_right_hip_torque;
    const Scalar u_rear_right_thigh_torque = inputs.rear_right_thigh_torque;
    const Scalar u_rear_right_knee_torque = inputs.rear_right_knee_torque;
    const Scalar z270 = q_front_left_thigh + q_front_left_knee;
    const Scalar z403 = q_front_right_thigh + q_front_right_knee;
    const Scalar z536 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z669 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z270, z403, z536, z669};
    Scalar sines_[16], cosines_[16];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z271 = sines_[12], z272 = cosines_[12];
    const Scalar z404 = sines_[13], z405 = cosines_[13];
    const Scalar z537 = sines_[14], z538 = cosines_[14];
    const Scalar z670 = sines_[15], z671 = cosines_[15];
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z97 = v_trunk_x * z17 + v_trunk_y * z19 + v_trunk_z * z29;
    const Scalar z98 = v_trunk_x * z18 + v_trunk_y * z23 + v_trunk_z * z25;
    const Scalar z99 = v_trunk_x * z30 + v_trunk_y * z24 + v_trunk_z * z28;
    const Scalar z100 = n0_05 * v_trunk_attitude_omega_z - z97;
    const Scalar z101 = n0_2 * v_trunk_attitude_omega_z + z98;
    const Scalar z102 = n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y + z99;
    const Scalar z103 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z104 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z105 = s_front_left_hip * z102 + c_front_left_hip * z101;
    const Scalar z106 = s_front_left_hip * z101 - c_front_left_hip * z102;
    const Scalar z107 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z108 = z100 - n0_08 * z104;
    const Scalar z109 = z106 - n0_08 * z107;
    const Scalar z110 = s_front_left_thigh * z104 + c_front_left_thigh * z107;
    const Scalar z111 = s_front_left_thigh * z107 - c_front_left_thigh * z104;
    const Scalar z112 = s_front_left_thigh * z109 - c_front_left_thigh * z108;
    const Scalar z113 = s_front_left_thigh * z108 + c_front_left_thigh * z109;
    const Scalar z114 = v_front_left_thigh + z103;  // angular velocity of front_left_thigh_link, y
    const Scalar z115 = z112 - n0_2 * z114;
    const Scalar z116 = z105 + n0_2 * z110;
    const Scalar z117 = s_front_left_knee * z111 - c_front_left_knee * z110;
    const Scalar z118 = s_front_left_knee * z110 + c_front_left_knee * z111;
    const Scalar z119 = s_front_left_knee * z113 + c_front_left_knee * z115;
    const Scalar z120 = s_front_left_knee * z115 - c_front_left_knee * z113;
    const Scalar z121 = v_front_left_knee + z114;  // angular velocity of front_left_shank_link, y
    const Scalar z122 = n0_05 * v_trunk_attitude_omega_z + z97;
    const Scalar z123 = n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y - z99;
    const Scalar z124 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z125 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z126 = s_front_right_hip * z123 - c_front_right_hip * z101;
    const Scalar z127 = s_front_right_hip * z101 + c_front_right_hip * z123;
    const Scalar z128 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z129 = z122 - n0_08 * z125;
    const Scalar z130 = z127 + n0_08 * z128;
    const Scalar z131 = s_front_right_thigh * z125 + c_front_right_thigh * z128;
    const Scalar z132 = s_front_right_thigh * z128 - c_front_right_thigh * z125;
    const Scalar z133 = s_front_right_thigh * z130 + c_front_right_thigh * z129;
    const Scalar z134 = s_front_right_thigh * z129 - c_front_right_thigh * z130;
    const Scalar z135 = v_front_right_thigh + z124;  // angular velocity of front_right_thigh_link, y
    const Scalar z136 = z133 - n0_2 * z135;
    const Scalar z137 = z126 - n0_2 * z131;
    const Scalar z138 = s_front_right_knee * z132 - c_front_right_knee * z131;
    const Scalar z139 = s_front_right_knee * z131 + c_front_right_knee * z132;
    const Scalar z140 = s_front_right_knee * z134 - c_front_right_knee * z136;
    const Scalar z141 = s_front_right_knee * z136 + c_front_right_knee * z134;
    const Scalar z142 = v_front_right_knee + z135;  // angular velocity of front_right_shank_link, y
    const Scalar z143 = n0_2 * v_trunk_attitude_omega_z - z98;
    const Scalar z144 = n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y + z99;
    const Scalar z145 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z146 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z147 = s_rear_left_hip * z144 - c_rear_left_hip * z143;
    const Scalar z148 = s_rear_left_hip * z143 + c_rear_left_hip * z144;
    const Scalar z149 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z150 = z100 - n0_08 * z146;
    const Scalar z151 = z148 + n0_08 * z149;
    const Scalar z152 = s_rear_left_thigh * z146 + c_rear_left_thigh * z149;
    const Scalar z153 = s_rear_left_thigh * z149 - c_rear_left_thigh * z146;
    const Scalar z154 = s_rear_left_thigh * z151 + c_rear_left_thigh * z150;
    const Scalar z155 = s_rear_left_thigh * z150 - c_rear_left_thigh * z151;
    const Scalar z156 = v_rear_left_thigh + z145;  // angular velocity of rear_left_thigh_link, y
    const Scalar z157 = z154 + n0_2 * z156;
    const Scalar z158 = z147 + n0_2 * z152;
    const Scalar z159 = s_rear_left_knee * z153 - c_rear_left_knee * z152;
    const Scalar z160 = s_rear_left_knee * z152 + c_rear_left_knee * z153;
    const Scalar z161 = s_rear_left_knee * z155 - c_rear_left_knee * z157;
    const Scalar z162 = s_rear_left_knee * z157 + c_rear_left_knee * z155;
    const Scalar z163 = v_rear_left_knee + z156;  // angular velocity of rear_left_shank_link, y
    const Scalar z164 = n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y - z99;
    const Scalar z165 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z166 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z167 = s_rear_right_hip * z164 + c_rear_right_hip * z143;
    const Scalar z168 = s_rear_right_hip * z143 - c_rear_right_hip * z164;
    const Scalar z169 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z170 = z122 - n0_08 * z166;
    const Scalar z171 = z168 - n0_08 * z169;
    const Scalar z172 = s_rear_right_thigh * z166 + c_rear_right_thigh * z169;
    const Scalar z173 = s_rear_right_thigh * z169 - c_rear_right_thigh * z166;
    const Scalar z174 = s_rear_right_thigh * z171 - c_rear_right_thigh * z170;
    const Scalar z175 = s_rear_right_thigh * z170 + c_rear_right_thigh * z171;
    const Scalar z176 = v_rear_right_thigh + z165;  // angular velocity of rear_right_thigh_link, y
    const Scalar z177 = z174 + n0_2 * z176;
    const Scalar z178 = z167 - n0_2 * z172;
    const Scalar z179 = s_rear_right_knee * z173 - c_rear_right_knee * z172;
    const Scalar z180 = s_rear_right_knee * z172 + c_rear_right_knee * z173;
    const Scalar z181 = s_rear_right_knee * z175 + c_rear_right_knee * z177;
    const Scalar z182 = s_rear_right_knee * z177 - c_rear_right_knee * z175;
    const Scalar z183 = v_rear_right_knee + z176;  // angular velocity of rear_right_shank_link, y
    const Scalar z736 = n0_05 * z25 + n0_2 * z29;
    const Scalar z737 = q_trunk_z + z736;
    const Scalar z746 = n0_08 * c_front_left_hip;
    const Scalar z747 = n0_08 * s_front_left_hip;
    const Scalar z748 = n0_05 + z746;
    const Scalar z751 = z25 * z748 + z28 * z747 + n0_2 * z29;
    const Scalar z752 = q_trunk_z + z751;
    const Scalar z761 = n0_2 * s_front_left_thigh;
    const Scalar z762 = n0_2 * c_front_left_thigh;
    const Scalar z763 = s_front_left_hip * z762 + n0_08 * c_front_left_hip;
    const Scalar z764 = n0_08 * s_front_left_hip - c_front_left_hip * z762;
    const Scalar z765 = n0_2 - z761;
    const Scalar z766 = n0_05 + z763;
    const Scalar z769 = z25 * z766 + z28 * z764 + z29 * z765;
    const Scalar z770 = q_trunk_z + z769;
    const Scalar z793 = n0_05 * z25 - n0_2 * z29;
    const Scalar z794 = q_trunk_z - z793;
    const Scalar z803 = n0_08 * c_front_right_hip;
    const Scalar z804 = n0_08 * s_front_right_hip;
    const Scalar z805 = n0_05 + z803;
    const Scalar z808 = z25 * z805 + z28 * z804 - n0_2 * z29;
    const Scalar z809 = q_trunk_z - z808;
    const Scalar z818 = n0_2 * s_front_right_thigh;
    const Scalar z819 = n0_2 * c_front_right_thigh;
    const Scalar z820 = s_front_right_hip * z819 - n0_08 * c_front_right_hip;
    const Scalar z821 = n0_08 * s_front_right_hip + c_front_right_hip * z819;
    const Scalar z822 = n0_2 - z818;
    const Scalar z823 = n0_05 - z820;
    const Scalar z826 = z25 * z823 + z28 * z821 - z29 * z822;
    const Scalar z827 = q_trunk_z - z826;
    const Scalar z848 = q_trunk_z + z793;
    const Scalar z857 = n0_08 * c_rear_left_hip;
    const Scalar z858 = n0_08 * s_rear_left_hip;
    const Scalar z859 = n0_05 + z857;
    const Scalar z862 = z25 * z859 + z28 * z858 - n0_2 * z29;
    const Scalar z863 = q_trunk_z + z862;
    const Scalar z872 = n0_2 * s_rear_left_thigh;
    const Scalar z873 = n0_2 * c_rear_left_thigh;
    const Scalar z874 = s_rear_left_hip * z873 + n0_08 * c_rear_left_hip;
    const Scalar z875 = n0_08 * s_rear_left_hip - c_rear_left_hip * z873;
    const Scalar z876 = n0_2 + z872;
    const Scalar z877 = n0_05 + z874;
    const Scalar z880 = z25 * z877 + z28 * z875 - z29 * z876;
    const Scalar z881 = q_trunk_z + z880;
    const Scalar z902 = q_trunk_z - z736;
    const Scalar z911 = n0_08 * c_rear_right_hip;
    const Scalar z912 = n0_08 * s_rear_right_hip;
    const Scalar z913 = n0_05 + z911;
    const Scalar z916 = z25 * z913 + z28 * z912 + n0_2 * z29;
    const Scalar z917 = q_trunk_z - z916;
    const Scalar z926 = n0_2 * s_rear_right_thigh;
    const Scalar z927 = n0_2 * c_rear_right_thigh;
    const Scalar z928 = s_rear_right_hip * z927 - n0_08 * c_rear_right_hip;
    const Scalar z929 = n0_08 * s_rear_right_hip + c_rear_right_hip * z927;
    const Scalar z930 = n0_2 + z926;
    const Scalar z931 = n0_05 - z928;
    const Scalar z934 = z25 * z931 + z28 * z929 + z29 * z930;
    const Scalar z935 = q_trunk_z - z934;
    const Scalar z1399 = n0_05 * v_front_left_hip;
    const Scalar z1401 = n0_05 * v_front_left_thigh;
    const Scalar z1403 = n0_05 * v_front_left_knee;
    const Scalar z1405 = n0_05 * v_front_right_hip;
    const Scalar z1407 = n0_05 * v_front_right_thigh;
    const Scalar z1409 = n0_05 * v_front_right_knee;
    const Scalar z1411 = n0_05 * v_rear_left_hip;
    const Scalar z1413 = n0_05 * v_rear_left_thigh;
    const Scalar z1415 = n0_05 * v_rear_left_knee;
    const Scalar z1417 = n0_05 * v_rear_right_hip;
    const Scalar z1419 = n0_05 * v_rear_right_thigh;
    const Scalar z1421 = n0_05 * v_rear_right_knee;
    const Scalar z3538 = n0_5 * z100 - n0_02 * z104;
    const Scalar z3539 = n0_5 * z106 - n0_02 * z107;
    const Scalar z3540 = n0_02 * z106 - n0_0014 * z107;
    const Scalar z3541 = n0_02 * z100 - n0_0014 * z104;
    const Scalar z3542 = n0_8 * z112 - n0_072 * z114;
    const Scalar z3543 = n0_8 * z105 + n0_072 * z110;
    const Scalar z3544 = n0_072 * z105 + k10 * z110;
    const Scalar z3545 = n0_072 * z112 - k10 * z114;
    const Scalar z3546 = n0_26 * z119 - n0_032 * z121;
    const Scalar z3547 = n0_26 * z116 - n0_032 * z117;
    const Scalar z3548 = n0_032 * z116 - k13 * z117;
    const Scalar z3549 = n0_032 * z119 - k13 * z121;
    const Scalar z3550 = n0_5 * z122 - n0_02 * z125;
    const Scalar z3551 = n0_5 * z127 + n0_02 * z128;
    const Scalar z3552 = n0_02 * z127 + n0_0014 * z128;
    const Scalar z3553 = n0_02 * z122 - n0_0014 * z125;
    const Scalar z3554 = n0_8 * z133 - n0_072 * z135;
    const Scalar z3555 = n0_8 * z126 - n0_072 * z131;
    const Scalar z3556 = n0_072 * z126 - k10 * z131;
    const Scalar z3557 = n0_072 * z133 - k10 * z135;
    const Scalar z3558 = n0_26 * z140 + n0_032 * z142;
    const Scalar z3559 = n0_26 * z137 + n0_032 * z138;
    const Scalar z3560 = n0_032 * z137 + k13 * z138;
    const Scalar z3561 = n0_032 * z140 + k13 * z142;
    const Scalar z3562 = n0_5 * z100 - n0_02 * z146;
    const Scalar z3563 = n0_5 * z148 + n0_02 * z149;
    const Scalar z3564 = n0_02 * z148 + n0_0014 * z149;
    const Scalar z3565 = n0_02 * z100 - n0_0014 * z146;
    const Scalar z3566 = n0_8 * z154 + n0_072 * z156;
    const Scalar z3567 = n0_8 * z147 + n0_072 * z152;
    const Scalar z3568 = n0_072 * z147 + k10 * z152;
    const Scalar z3569 = n0_072 * z154 + k10 * z156;
    const Scalar z3570 = n0_26 * z161 - n0_032 * z163;
    const Scalar z3571 = n0_26 * z158 - n0_032 * z159;
    const Scalar z3572 = n0_032 * z158 - k13 * z159;
    const Scalar z3573 = n0_032 * z161 - k13 * z163;
    const Scalar z3574 = n0_5 * z122 - n0_02 * z166;
    const Scalar z3575 = n0_5 * z168 - n0_02 * z169;
    const Scalar z3576 = n0_02 * z168 - n0_0014 * z169;
    const Scalar z3577 = n0_02 * z122 - n0_0014 * z166;
    const Scalar z3578 = n0_8 * z174 + n0_072 * z176;
    const Scalar z3579 = n0_8 * z167 - n0_072 * z172;
    const Scalar z3580 = n0_072 * z167 - k10 * z172;
    const Scalar z3581 = n0_072 * z174 + k10 * z176;
    const Scalar z3582 = n0_26 * z181 + n0_032 * z183;
    const Scalar z3583 = n0_26 * z178 + n0_032 * z179;
    const Scalar z3584 = n0_032 * z178 + k13 * z179;
    const Scalar z3585 = n0_032 * z181 + k13 * z183;
    const Scalar z3586 = n0_02 * c_front_left_hip;
    const Scalar z3587 = n0_02 * s_front_left_hip;
    const Scalar z3590 = z25 * z3586 + z28 * z3587;
    const Scalar z3591 = n0_072 * s_front_left_thigh;
    const Scalar z3592 = n0_072 * c_front_left_thigh;
    const Scalar z3593 = s_front_left_hip * z3592;
    const Scalar z3594 = c_front_left_hip * z3592;
    const Scalar z3597 = z25 * z3593 - z28 * z3594 - z29 * z3591;
    const Scalar z3598 = n0_032 * z271;
    const Scalar z3599 = n0_032 * z272;
    const Scalar z3600 = s_front_left_hip * z3599;
    const Scalar z3601 = c_front_left_hip * z3599;
    const Scalar z3604 = z25 * z3600 - z28 * z3601 - z29 * z3598;
    const Scalar z3605 = n0_02 * c_front_right_hip;
    const Scalar z3606 = n0_02 * s_front_right_hip;
    const Scalar z3609 = z25 * z3605 + z28 * z3606;
    const Scalar z3610 = n0_072 * s_front_right_thigh;
    const Scalar z3611 = n0_072 * c_front_right_thigh;
    const Scalar z3612 = s_front_right_hip * z3611;
    const Scalar z3613 = c_front_right_hip * z3611;
    const Scalar z3616 = z25 * z3612 - z28 * z3613 - z29 * z3610;
    const Scalar z3617 = n0_032 * z404;
    const Scalar z3618 = n0_032 * z405;
    const Scalar z3619 = s_front_right_hip * z3618;
    const Scalar z3620 = c_front_right_hip * z3618;
    const Scalar z3623 = z25 * z3619 - z28 * z3620 - z29 * z3617;
    const Scalar z3624 = n0_02 * c_rear_left_hip;
    const Scalar z3625 = n0_02 * s_rear_left_hip;
    const Scalar z3628 = z25 * z3624 + z28 * z3625;
    const Scalar z3629 = n0_072 * s_rear_left_thigh;
    const Scalar z3630 = n0_072 * c_rear_left_thigh;
    const Scalar z3631 = s_rear_left_hip * z3630;
    const Scalar z3632 = c_rear_left_hip * z3630;
    const Scalar z3635 = z25 * z3631 - z28 * z3632 - z29 * z3629;
    const Scalar z3636 = n0_032 * z537;
    const Scalar z3637 = n0_032 * z538;
    const Scalar z3638 = s_rear_left_hip * z3637;
    const Scalar z3639 = c_rear_left_hip * z3637;
    const Scalar z3642 = z25 * z3638 - z28 * z3639 - z29 * z3636;
    const Scalar z3643 = n0_02 * c_rear_right_hip;
    const Scalar z3644 = n0_02 * s_rear_right_hip;
    const Scalar z3647 = z25 * z3643 + z28 * z3644;
    const Scalar z3648 = n0_072 * s_rear_right_thigh;
    const Scalar z3649 = n0_072 * c_rear_right_thigh;
    const Scalar z3650 = s_rear_right_hip * z3649;
    const Scalar z3651 = c_rear_right_hip * z3649;
    const Scalar z3654 = z25 * z3650 - z28 * z3651 - z29 * z3648;
    const Scalar z3655 = n0_032 * z670;
    const Scalar z3656 = n0_032 * z671;
    const Scalar z3657 = s_rear_right_hip * z3656;
    const Scalar z3658 = c_rear_right_hip * z3656;
    const Scalar z3661 = z25 * z3657 - z28 * z3658 - z29 * z3655;
    result.kinetic = n0_5 * (z100 * (z3538 + z3562) + z122 * (z3550 + z3574) - z104 * z3541 + z105 * z3543 + z106
        * z3539 - z107 * z3540 + z110 * z3544 + z112 * z3542 - z114 * z3545 + z116 * z3547 - z117 * z3548 + z119 * z3546
        - z121 * z3549 - z125 * z3553 + z126 * z3555 + z127 * z3551 + z128 * z3552 - z131 * z3556 + z133 * z3554 - z135
        * z3557 + z137 * z3559 + z138 * z3560 + z140 * z3558 + z142 * z3561 - z146 * z3565 + z147 * z3567 + z148 * z3563
        + z149 * z3564 + z152 * z3568 + z154 * z3566 + z156 * z3569 + z158 * z3571 - z159 * z3572 + z161 * z3570 - z163
        * z3573 - z166 * z3577 + z167 * z3579 + z168 * z3575 - z169 * z3576 - z172 * z3580 + z174 * z3578 + z176 * z3581
        + z178 * z3583 + z179 * z3584 + z181 * z3582 + z183 * z3585) + n0_0002 * (z103 * z103 + z111 * z111 + z124
        * z124 + z132 * z132 + z145 * z145 + z153 * z153 + z165 * z165 + z173 * z173) + n0_25 * (z105 * z105 + z126
        * z126 + z147 * z147 + z167 * z167) + n0_4 * (z113 * z113 + z134 * z134 + z155 * z155 + z175 * z175) + k17
        * (z118 * z118 + z139 * z139 + z160 * z160 + z180 * z180) + n0_13 * (z120 * z120 + z141 * z141 + z162 * z162
        + z182 * z182) + n3 * (z97 * z97 + z98 * z98 + z99 * z99) + n0_0125 * v_trunk_attitude_omega_x
        * v_trunk_attitude_omega_x + n0_0425 * v_trunk_attitude_omega_y * v_trunk_attitude_omega_y + n0_05
        * v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    result.force_function = -n9_81 * (z3590 + z3597 + z3604 - z3609 + z3616 + z3623 + z3628 + z3635 + z3642 - z3647
        + z3654 + z3661) - n4_905 * (z737 + z794 + z848 + z902) - n7_848 * (z752 + z809 + z863 + z917) - n2_5506 * (z770
        + z827 + z881 + z935) - n58_86 * q_trunk_z;
    result.power = v_front_left_hip * (u_front_left_hip_torque - z1399) + v_front_left_thigh
        * (u_front_left_thigh_torque - z1401) + v_front_left_knee * (u_front_left_knee_torque - z1403)
        + v_front_right_hip * (u_front_right_hip_torque - z1405) + v_front_right_thigh * (u_front_right_thigh_torque
        - z1407) + v_front_right_knee * (u_front_right_knee_torque - z1409) + v_rear_left_hip * (u_rear_left_hip_torque
        - z1411) + v_rear_left_thigh * (u_rear_left_thigh_torque - z1413) + v_rear_left_knee * (u_rear_left_knee_torque
        - z1415) + v_rear_right_hip * (u_rear_right_hip_torque - z1417) + v_rear_right_thigh
        * (u_rear_right_thigh_torque - z1419) + v_rear_right_knee * (u_rear_right_knee_torque - z1421);
  }
};

}  // namespace quadruped
