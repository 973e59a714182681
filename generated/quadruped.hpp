// SPDX-License-Identifier: MIT
// quadruped
// Made by torsor 0.1.0 from quadruped.urdf; change that and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              542              699          0             0                 16       0   1273    1283
//   mass_matrix             307              402          0             0                 12       0    733     747
//   bias                    388              512          0             0                 12       0    924     942
//   inverse_dynamics        446              549          0             0                 12       0   1019    1037
//   forward_dynamics        950             1176         14             0                 12       0   2164    2206
//   energy                  352              469          0             0                 16       0    853     980
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
//   torsor generate quadruped.urdf --base floating --points front_left_foot,front_right_foot,rear_left_foot,rear_right_foot --initial 'trunk_z=0.8,trunk_x'\''=0.5,trunk_attitude_omega_x=0.3,trunk_attitude_omega_y=-0.5,front_left_thigh=0.7,front_left_knee=-1.4,front_right_thigh=0.7,front_right_knee=-1.4,rear_left_thigh=0.7,rear_left_knee=-1.4,rear_right_thigh=0.7,rear_right_knee=-1.4' --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output quadruped.hpp
#pragma once

#include <array>
#include <cmath>

#ifndef TORSOR_KERNEL_SUPPORT
#define TORSOR_KERNEL_SUPPORT 3
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
// The core has no branch, so that several angles go through it at once.
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
  /// So large that the last bit of what is some less or more counts 1.
  TORSOR_DEVICE TORSOR_INLINED static Scalar shift() noexcept { return number(0x1.8p52, 0x1.8p23f); }
  /// To the nearest integer, of two the even one.
  TORSOR_DEVICE TORSOR_INLINED static Scalar rounded(const Scalar& x) noexcept { return (x + shift()) - shift(); }

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
      const Scalar S01 = number(-0x1.5555555555548p-3, 0.0f) + z * number(0x1.111111110f73p-7, 0.0f);
      const Scalar S23 = number(-0x1.a01a019be9217p-13, 0.0f) + z * number(0x1.71de35552b518p-19, 0.0f);
      const Scalar S45 = number(-0x1.ae5e4b83e1601p-26, 0.0f) + z * number(0x1.5d8b55934597bp-33, 0.0f);
      const Scalar C01 = number(0x1.555555555554cp-5, 0.0f) + z * number(-0x1.6c16c16c1521bp-10, 0.0f);
      const Scalar C23 = number(0x1.a01a019cbeb68p-16, 0.0f) + z * number(-0x1.27e4f8121198fp-22, 0.0f);
      const Scalar C45 = number(0x1.1ee9f0cbf70d6p-29, 0.0f) + z * number(-0x1.8fb0e15d5f2ap-37, 0.0f);
      S = S01 + z2 * (S23 + z2 * S45);
      C = C01 + z2 * (C23 + z2 * C45);
    }
    const Scalar half_z = half * z, w = one - half_z, high_z = high * z;
    // What waits for S and C comes last. The correction of -0 is a 0, which subtracted leaves it -0.
    sine = high - (rest * w - high_z * S);
    cosine = w + ((((one - w) - half_z) + high * rest) + z2 * C);
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

  /// Of r = x - n pi/2 for |x| <= bound, and `shifted`, n + shift(); what is no number gives no number.
  ///  * n P and n Q are exact, as is x - n pi/2 to the first part: products that are fused with their sums round as
  ///    others do, and may be formed twice;
  ///  * r = first - n P loses (first - r) - n P. Two operations tell it where |first| >= |n P|, as in Fast2Sum, and
  ///    elsewhere, where r is exact: both are multiples of P's last bit, and r is less than 2^53 (2^24) of them.
  TORSOR_DEVICE TORSOR_INLINED static void of_remainder(const Scalar& x, Scalar& shifted, Scalar& sine,
                                                        Scalar& cosine) noexcept {
    const Scalar P = number(0x1.0b4611a6p-34, 0x1.ed5p-14f), Q = number(0x1.3198a2ep-69, 0x1.10bp-30f);
    shifted = x * number(0x1.45f306dc9c883p-1, 0x1.45f306p-1f) + shift();
    const Scalar n = shifted - shift();
    const Scalar first = x - n * number(0x1.921fb544p+0, 0x1.9218p+0f);
    const Scalar r = first - n * P;
    const Scalar error = (first - r) - n * P;
    const Scalar high = r - n * Q;
    const Scalar rest = ((n * Q - (r - high)) - error) + n * number(0x1.b839a252049c1p-104, 0x1.184698p-44f);
    of_reduced(high, rest, sine, cosine);
  }

  /// For |x| <= bound.
  TORSOR_DEVICE TORSOR_INLINED static void core(const Scalar& x, Scalar& sine, Scalar& cosine) noexcept {
    Scalar shifted;
    of_remainder(x, shifted, sine, cosine);
    turn(shifted - shift(), sine, cosine);
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

}  // namespace torsor
// Sines and cosines of several angles at once, in vector registers where GNU C++ has types for them: of 32 bytes with
// AVX, else of 16.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define TORSOR_VECTOR_TYPES
#endif

namespace torsor {

#if defined(TORSOR_VECTOR_TYPES)
/// 0, 1, ... as arguments of a template.
template <int... place>
struct Places {};
template <int count, int... place>
struct FirstPlaces : FirstPlaces<count - 1, count - 1, place...> {};
template <int... place>
struct FirstPlaces<0, place...> {
  using type = Places<place...>;
};

/// Some registers of equally many numbers, which take the same operations by turns: while the one waits for its last
/// result, the other is at work. A scalar for SineCosine, of which it needs constants, sums and products only.
template <class Number, int lanes, int count>
struct Registers {
  typedef Number Numbers __attribute__((vector_size(lanes * sizeof(Number))));
  using Bits = decltype(Numbers{} < Numbers{});
  Numbers part[count];

  TORSOR_INLINED friend Registers operator+(const Registers& a, const Registers& b) noexcept {
    Registers sum;
    for (int i = 0; i < count; ++i) sum.part[i] = a.part[i] + b.part[i];
    return sum;
  }
  TORSOR_INLINED friend Registers operator-(const Registers& a, const Registers& b) noexcept {
    Registers difference;
    for (int i = 0; i < count; ++i) difference.part[i] = a.part[i] - b.part[i];
    return difference;
  }
  TORSOR_INLINED friend Registers operator*(const Registers& a, const Registers& b) noexcept {
    Registers product;
    for (int i = 0; i < count; ++i) product.part[i] = a.part[i] * b.part[i];
    return product;
  }
};

template <class Number, int lanes, int count>
struct scalar_traits<Registers<Number, lanes, count>> {
  using Scalar = Registers<Number, lanes, count>;
  TORSOR_INLINED static Scalar constant(double in_double, float in_float, const char* /*exact*/) noexcept {
    constexpr bool is_float = sizeof(Number) == sizeof(float);
    const Number number = is_float ? static_cast<Number>(in_float) : static_cast<Number>(in_double);
    Scalar result;
    for (int i = 0; i < count; ++i) {
      for (int lane = 0; lane < lanes; ++lane) result.part[i][lane] = number;
    }
    return result;
  }
};

/// Of angles up to the bound, bit by bit what SineCosine::core gives where nothing is fused. The quarter of the turn is
/// in the last two bits of `shifted`: it is chosen by bits, not by products.
template <class Number, int lanes, int count>
TORSOR_INLINED void sincos_of_registers(const Registers<Number, lanes, count>& angles,
                                        Registers<Number, lanes, count>& sines,
                                        Registers<Number, lanes, count>& cosines) noexcept {
  using Scalar = Registers<Number, lanes, count>;
  using Numbers = typename Scalar::Numbers;
  using Bits = typename Scalar::Bits;
  constexpr int sign_bit = 8 * static_cast<int>(sizeof(Number)) - 1;
  Scalar shifted, sine, cosine;
  SineCosine<Scalar, sizeof(Number) == sizeof(float)>::of_remainder(angles, shifted, sine, cosine);
  const Bits sign = (Bits)scalar_traits<Scalar>::constant(-0.0, -0.0f, nullptr).part[0];
  for (int i = 0; i < count; ++i) {
    const Numbers s = sine.part[i], c = cosine.part[i];
    const Bits bits = (Bits)shifted.part[i];
    const Bits odd = bits << sign_bit, upper = bits << (sign_bit - 1);
    Numbers sine_of_rest, cosine_of_rest;
    if constexpr (sizeof(Numbers) >= 32) {  // AVX chooses by the bit of the sign, AVX-512 by a mask
      const Bits exchanged = odd < Bits{};
      sine_of_rest = exchanged ? c : s;
      cosine_of_rest = exchanged ? s : c;
    } else {
      const Bits exchanged = Bits{} - (bits & 1);
      sine_of_rest = (Numbers)((exchanged & (Bits)c) | (~exchanged & (Bits)s));
      cosine_of_rest = (Numbers)((exchanged & (Bits)s) | (~exchanged & (Bits)c));
    }
    // The sine is negated for n = 2 and 3, the cosine for 1 and 2.
    sines.part[i] = (Numbers)((Bits)sine_of_rest ^ (upper & sign));
    cosines.part[i] = (Numbers)((Bits)cosine_of_rest ^ ((upper ^ odd) & sign));
  }
}

/// Of the angles first to first + size - 1, up to the bound, in one register or two; idle lanes get 0. Returns the sum
/// of their squares. Places are constants before anything is optimised: lanes then come from registers and go there,
/// where a way through memory would be stored in parts and loaded whole.
template <int size, class Number, int N, int... lane, int... place>
TORSOR_INLINED Number sincos_of_some(int first, const Number (&angles)[N], Number (&sines)[N], Number (&cosines)[N],
                                     Places<lane...>, Places<place...>) noexcept {
  constexpr int lanes = sizeof...(lane), count = size > lanes ? 2 : 1;
  using Some = Registers<Number, lanes, count>;
  const auto angle = [&](int i) noexcept { return i < size ? angles[first + i] : Number(0); };
  Some x, s, c;
  x.part[0] = typename Some::Numbers{angle(lane)...};
  if constexpr (count == 2) x.part[1] = typename Some::Numbers{angle(lane + lanes)...};
  sincos_of_registers(x, s, c);
  ((sines[first + place] = s.part[place / lanes][place % lanes]), ...);
  ((cosines[first + place] = c.part[place / lanes][place % lanes]), ...);
  typename Some::Numbers squares = x.part[0] * x.part[0];
  if constexpr (count == 2) squares += x.part[1] * x.part[1];
  return (squares[lane] + ...);
}

/// Of several angles up to the bound, by two registers at a time. Returns the sum of their squares.
template <class Number, int N>
TORSOR_INLINED Number sincos_in_registers(const Number (&angles)[N], Number (&sines)[N],
                                          Number (&cosines)[N]) noexcept {
  constexpr int narrow = 16 / static_cast<int>(sizeof(Number));
#if defined(__AVX__)
  // Registers of AVX-512 gain nothing for so few numbers.
  constexpr int lanes = N <= narrow ? narrow : 2 * narrow;
#else
  constexpr int lanes = narrow;
#endif
  constexpr int both = 2 * lanes, rest = N % both, whole = N - rest;
  using AllLanes = typename FirstPlaces<lanes>::type;
  Number squares = 0;
  if constexpr (whole > 0) {
    // One copy of the code: its constants stay where they are.
#if defined(__clang__)
#pragma clang loop unroll(disable)
#else
#pragma GCC unroll 1
#endif
    for (int i = 0; i < whole; i += both)
      squares += sincos_of_some<both>(i, angles, sines, cosines, AllLanes(), typename FirstPlaces<both>::type());
  }
  if constexpr (rest > 0)
    squares += sincos_of_some<rest>(whole, angles, sines, cosines, AllLanes(), typename FirstPlaces<rest>::type());
  return squares;
}
#endif

/// Of several angles at once, in float or double.
template <class Scalar, int N>
TORSOR_DEVICE TORSOR_INLINED void sincos_of_several(const Scalar (&angles)[N], Scalar (&sines)[N],
                                                    Scalar (&cosines)[N]) noexcept {
#if defined(TORSOR_VECTOR_TYPES) && !defined(TORSOR_STD_SINCOS)
  constexpr bool at_once = N > 1;
#else
  constexpr bool at_once = false;
#endif
  if constexpr (at_once) {
    const Scalar squares = sincos_in_registers(angles, sines, cosines);
    constexpr Scalar bound = static_cast<Scalar>(SineCosine<Scalar, sizeof(Scalar) == sizeof(float)>::bound);
    if (squares <= bound * bound && !rounds_to_one_side(squares)) return;
    for (int i = 0; i < N; ++i) {
      if (std::abs(angles[i]) > bound || rounds_to_one_side(angles[i])) sincos_far(angles[i], sines[i], cosines[i]);
    }
  } else {
    for (int i = 0; i < N; ++i) sincos_of_one(angles[i], sines[i], cosines[i]);
  }
}

/// Of several angles of any scalar: at once where its traits have a `sincos` of arrays, else one by one.
template <class Scalar, int N>
TORSOR_DEVICE TORSOR_INLINED auto sincos_by_traits(const Scalar (&angles)[N], Scalar (&sines)[N],
                                                   Scalar (&cosines)[N], int) noexcept
    -> decltype(scalar_traits<Scalar>::sincos(angles, sines, cosines)) {
  scalar_traits<Scalar>::sincos(angles, sines, cosines);
}
template <class Scalar, int N>
TORSOR_DEVICE TORSOR_INLINED void sincos_by_traits(const Scalar (&angles)[N], Scalar (&sines)[N],
                                                   Scalar (&cosines)[N], long) noexcept {
  for (int i = 0; i < N; ++i) scalar_traits<Scalar>::sincos(angles[i], sines[i], cosines[i]);
}
template <class Scalar, int N>
TORSOR_DEVICE TORSOR_INLINED void sines_and_cosines(const Scalar (&angles)[N], Scalar (&sines)[N],
                                                    Scalar (&cosines)[N]) noexcept {
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
  TORSOR_DEVICE TORSOR_INLINED static void sincos(const Scalar (&angles)[N], Scalar (&sines)[N],
                                                  Scalar (&cosines)[N]) noexcept {
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
#elif TORSOR_KERNEL_SUPPORT != 3
#error "headers of incompatible versions of torsor meet here: write them again with one version"
#endif

namespace quadruped {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "quadruped";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x86892cd03ced9125ULL;
  static constexpr int coordinate_count = 19;
  static constexpr int velocity_count = 18;
  static constexpr int input_count = 12;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;
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
    const Scalar z0 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_y + q_trunk_attitude_z
        * v_trunk_attitude_omega_z + q_trunk_attitude_x * v_trunk_attitude_omega_x);
    const Scalar z1 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_z - q_trunk_attitude_z
        * v_trunk_attitude_omega_y + q_trunk_attitude_w * v_trunk_attitude_omega_x);
    const Scalar z2 = n0_5 * (q_trunk_attitude_z * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_z + q_trunk_attitude_w * v_trunk_attitude_omega_y);
    const Scalar z3 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_y - q_trunk_attitude_w * v_trunk_attitude_omega_z);
    rates[0] = v_trunk_x;
    rates[1] = v_trunk_y;
    rates[2] = v_trunk_z;
    rates[3] = -z0;
    rates[4] = z1;
    rates[5] = z2;
    rates[6] = -z3;
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
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
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
    const Scalar z0 = q_front_left_thigh + q_front_left_knee;
    const Scalar z1 = q_front_right_thigh + q_front_right_knee;
    const Scalar z2 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z3 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z0, z1, z2, z3};
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
    const Scalar z4 = sines_[12], z5 = cosines_[12];
    const Scalar z6 = sines_[13], z7 = cosines_[13];
    const Scalar z8 = sines_[14], z9 = cosines_[14];
    const Scalar z10 = sines_[15], z11 = cosines_[15];
    const Scalar z12 = n2 * q_trunk_attitude_y;
    const Scalar z13 = n2 * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_x;
    const Scalar z15 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z16 = n0_2 * v_trunk_attitude_omega_z;
    const Scalar z17 = n0_05 * v_trunk_attitude_omega_x;
    const Scalar z18 = q_trunk_attitude_x * z12;
    const Scalar z19 = q_trunk_attitude_w * z13;
    const Scalar z20 = q_trunk_attitude_z * z12;
    const Scalar z21 = q_trunk_attitude_w * z14;
    const Scalar z22 = q_trunk_attitude_y * z12;
    const Scalar z23 = q_trunk_attitude_z * z13;
    const Scalar z24 = z18 - z19;
    const Scalar z25 = z18 + z19;
    const Scalar z26 = z20 + z21;
    const Scalar z27 = q_trunk_attitude_x * z14;
    const Scalar z28 = q_trunk_attitude_x * z13;
    const Scalar z29 = q_trunk_attitude_w * z12;
    const Scalar z30 = n1 - z23 - z27;
    const Scalar z31 = n1 - z22 - z27;
    const Scalar z32 = z28 + z29;
    const Scalar z33 = n0_2 * v_trunk_attitude_omega_y - z17;
    const Scalar z34 = n1 - z22 - z23;
    const Scalar z35 = z20 - z21;
    const Scalar z36 = z28 - z29;
    const Scalar z37 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z38 = s_front_left_hip * z24 - c_front_left_hip * z32;
    const Scalar z39 = s_front_left_hip * z30 - c_front_left_hip * z35;
    const Scalar z40 = s_front_left_hip * z26 - c_front_left_hip * z31;
    const Scalar z41 = v_trunk_x + z24 * z16 - z32 * z33 - z34 * z15;  // velocity of front_left_hip_link, x
    const Scalar z42 = v_trunk_y - z25 * z15 + z30 * z16 - z35 * z33;  // velocity of front_left_hip_link, y
    const Scalar z43 = v_trunk_z + z26 * z16 - z31 * z33 - z36 * z15;  // velocity of front_left_hip_link, z
    const Scalar z44 = n0_08 * z37;
    const Scalar z45 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z46 = v_trunk_attitude_omega_x * z34;  // angular velocity of trunk_attitude_omega_x, x
    const Scalar z47 = v_trunk_attitude_omega_y * z24 + z46;  // angular velocity of trunk_attitude_omega_y, x
    const Scalar z48 = v_trunk_attitude_omega_x * z25;  // angular velocity of trunk_attitude_omega_x, y
    const Scalar z49 = v_trunk_attitude_omega_y * z30 + z48;  // angular velocity of trunk_attitude_omega_y, y
    const Scalar z50 = v_trunk_attitude_omega_x * z36;  // angular velocity of trunk_attitude_omega_x, z
    const Scalar z51 = v_trunk_attitude_omega_y * z26 + z50;  // angular velocity of trunk_attitude_omega_y, z
    const Scalar z52 = v_trunk_attitude_omega_z * z32 + z47;  // angular velocity of trunk, x
    const Scalar z53 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z54 = v_trunk_attitude_omega_z * z35 + z49;  // angular velocity of trunk, y
    const Scalar z55 = v_trunk_attitude_omega_z * z31 + z51;  // angular velocity of trunk, z
    const Scalar z56 = s_front_left_hip * z32 + c_front_left_hip * z24;
    const Scalar z57 = s_front_left_hip * z35 + c_front_left_hip * z30;
    const Scalar z58 = s_front_left_hip * z31 + c_front_left_hip * z26;
    const Scalar z59 = n0_05 * z24;
    const Scalar z60 = n0_2 * z25;
    const Scalar z61 = n0_05 * z26;
    const Scalar z62 = n0_2 * z34 + z59;
    const Scalar z63 = n0_05 * z30 + z60;
    const Scalar z64 = n0_2 * z36 + z61;
    const Scalar z65 = q_trunk_x + z62;  // place of front_left_hip_link, x
    const Scalar z66 = q_trunk_y + z63;  // place of front_left_hip_link, y
    const Scalar z67 = s_front_right_hip * z32 + c_front_right_hip * z24;
    const Scalar z68 = q_trunk_z + z64;  // place of front_left_hip_link, z
    const Scalar z69 = n0_2 * z34 - z59;
    const Scalar z70 = v_front_left_thigh + z53;
    const Scalar z71 = n0_05 * z30 - z60;
    const Scalar z72 = n0_2 * z36 - z61;
    const Scalar z73 = s_front_right_hip * z24 - c_front_right_hip * z32;
    const Scalar z74 = s_front_right_hip * z30 - c_front_right_hip * z35;
    const Scalar z75 = s_front_right_hip * z26 - c_front_right_hip * z31;
    const Scalar z76 = n0_08 * z45;
    const Scalar z77 = s_front_left_thigh * z34 - c_front_left_thigh * z38;
    const Scalar z78 = s_front_left_thigh * z25 - c_front_left_thigh * z39;
    const Scalar z79 = s_front_left_thigh * z36 - c_front_left_thigh * z40;
    const Scalar z80 = c_front_left_thigh * z37 + s_front_left_thigh * z45;
    const Scalar z81 = z34 * z4 - z38 * z5;
    const Scalar z82 = z25 * z4 - z39 * z5;
    const Scalar z83 = z36 * z4 - z40 * z5;
    const Scalar z84 = z41 - z38 * z44 + z34 * z76;  // velocity of front_left_thigh_link, x
    const Scalar z85 = z42 - z39 * z44 + z25 * z76;  // velocity of front_left_thigh_link, y
    const Scalar z86 = z43 - z40 * z44 + z36 * z76;  // velocity of front_left_thigh_link, z
    const Scalar z87 = n0_2 * z77;
    const Scalar z88 = n0_2 * z78;
    const Scalar z89 = n0_2 * z79;
    const Scalar z90 = n0_2 * z80;
    const Scalar z91 = s_front_right_hip * z35 + c_front_right_hip * z30;
    const Scalar z92 = s_front_right_hip * z31 + c_front_right_hip * z26;
    const Scalar z93 = s_front_left_thigh * z37 - c_front_left_thigh * z45;
    const Scalar z94 = s_front_left_knee * z93 - c_front_left_knee * z80;
    const Scalar z95 = n0_08 * z56;
    const Scalar z96 = n0_08 * z57;
    const Scalar z97 = n0_08 * z58;
    const Scalar z98 = c_front_left_thigh * z34 + s_front_left_thigh * z38;
    const Scalar z99 = c_front_left_thigh * z25 + s_front_left_thigh * z39;
    const Scalar z100 = c_front_left_thigh * z36 + s_front_left_thigh * z40;
    const Scalar z101 = n0_2 * z70;
    const Scalar z102 = v_front_left_knee + z70;
    const Scalar z103 = v_front_left_hip * z34 + z52;  // angular velocity of front_left_hip_link, x
    const Scalar z104 = v_front_left_thigh * z56 + z103;  // angular velocity of front_left_thigh_link, x
    const Scalar z105 = q_trunk_x + z69;  // place of front_right_hip_link, x
    const Scalar z106 = v_front_left_hip * z25 + z54;  // angular velocity of front_left_hip_link, y
    const Scalar z107 = v_front_left_thigh * z57 + z106;  // angular velocity of front_left_thigh_link, y
    const Scalar z108 = q_trunk_y - z71;  // place of front_right_hip_link, y
    const Scalar z109 = v_front_left_knee * z56 + z104;  // angular velocity of front_left_shank_link, x
    const Scalar z110 = v_front_left_hip * z36 + z55;  // angular velocity of front_left_hip_link, z
    const Scalar z111 = n0_2 * v_trunk_attitude_omega_y + z17;
    const Scalar z112 = v_front_left_knee * z57 + z107;  // angular velocity of front_left_shank_link, y
    const Scalar z113 = v_front_left_thigh * z58 + z110;  // angular velocity of front_left_thigh_link, z
    const Scalar z114 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z115 = v_front_left_knee * z58 + z113;  // angular velocity of front_left_shank_link, z
    const Scalar z116 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z117 = v_trunk_x + z24 * z16 - z32 * z111 + z34 * z15;  // velocity of front_right_hip_link, x
    const Scalar z118 = v_trunk_y + z25 * z15 + z30 * z16 - z35 * z111;  // velocity of front_right_hip_link, y
    const Scalar z119 = v_trunk_z + z26 * z16 - z31 * z111 + z36 * z15;  // velocity of front_right_hip_link, z
    const Scalar z120 = s_front_right_thigh * z34 - c_front_right_thigh * z73;
    const Scalar z121 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z122 = c_front_right_thigh * z34 + s_front_right_thigh * z73;
    const Scalar z123 = q_trunk_z + z72;  // place of front_right_hip_link, z
    const Scalar z124 = z34 * z5 + z38 * z4;
    const Scalar z125 = z25 * z5 + z39 * z4;
    const Scalar z126 = z36 * z5 + z40 * z4;
    const Scalar z127 = z84 + z56 * z90 - z98 * z101;  // velocity of front_left_shank_link, x
    const Scalar z128 = z85 + z57 * z90 - z99 * z101;  // velocity of front_left_shank_link, y
    const Scalar z129 = z86 + z58 * z90 - z100 * z101;  // velocity of front_left_shank_link, z
    const Scalar z130 = v_front_right_hip * z34 + z52;  // angular velocity of front_right_hip_link, x
    const Scalar z131 = v_front_right_hip * z25 + z54;  // angular velocity of front_right_hip_link, y
    const Scalar z132 = v_front_right_hip * z36 + z55;  // angular velocity of front_right_hip_link, z
    const Scalar z133 = z65 + z95;  // place of front_left_thigh_link, x
    const Scalar z134 = c_front_right_thigh * z25 + s_front_right_thigh * z74;
    const Scalar z135 = z66 + z96;  // place of front_left_thigh_link, y
    const Scalar z136 = s_front_right_thigh * z25 - c_front_right_thigh * z74;
    const Scalar z137 = z68 + z97;  // place of front_left_thigh_link, z
    const Scalar z138 = v_front_right_thigh + z121;
    const Scalar z139 = v_front_right_thigh * z67 + z130;  // angular velocity of front_right_thigh_link, x
    const Scalar z140 = v_front_right_thigh * z91 + z131;  // angular velocity of front_right_thigh_link, y
    const Scalar z141 = v_front_right_thigh * z92 + z132;  // angular velocity of front_right_thigh_link, z
    const Scalar z142 = n0_08 * z114;
    const Scalar z143 = n0_08 * z116;
    const Scalar z144 = s_front_right_thigh * z36 - c_front_right_thigh * z75;
    const Scalar z145 = c_front_right_thigh * z116 + s_front_right_thigh * z114;
    const Scalar z146 = z34 * z6 - z73 * z7;
    const Scalar z147 = z34 * z142 - z117 - z73 * z143;  // velocity of front_right_thigh_link, x
    const Scalar z148 = z25 * z142 - z118 - z74 * z143;  // velocity of front_right_thigh_link, y
    const Scalar z149 = z36 * z142 - z119 - z75 * z143;  // velocity of front_right_thigh_link, z
    const Scalar z150 = s_front_right_thigh * z116 - c_front_right_thigh * z114;
    const Scalar z151 = n0_08 * z67;
    const Scalar z152 = n0_08 * z91;
    const Scalar z153 = n0_08 * z92;
    const Scalar z154 = c_front_right_thigh * z36 + s_front_right_thigh * z75;
    const Scalar z155 = z34 * z7 + z73 * z6;
    const Scalar z156 = z105 - z151;  // place of front_right_thigh_link, x
    const Scalar z157 = z108 - z152;  // place of front_right_thigh_link, y
    const Scalar z158 = z123 - z153;  // place of front_right_thigh_link, z
    const Scalar z159 = z133 - z87;  // place of front_left_shank_link, x
    const Scalar z160 = z25 * z7 + z74 * z6;
    const Scalar z161 = z135 - z88;  // place of front_left_shank_link, y
    const Scalar z162 = z25 * z6 - z74 * z7;
    const Scalar z163 = z137 - z89;  // place of front_left_shank_link, z
    const Scalar z164 = v_front_right_knee * z67 + z139;  // angular velocity of front_right_shank_link, x
    const Scalar z165 = v_front_right_knee * z91 + z140;  // angular velocity of front_right_shank_link, y
    const Scalar z166 = v_front_right_knee * z92 + z141;  // angular velocity of front_right_shank_link, z
    const Scalar z167 = s_front_right_knee * z150 - c_front_right_knee * z145;
    const Scalar z168 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z169 = s_rear_left_hip * z24 - c_rear_left_hip * z32;
    const Scalar z170 = s_rear_left_hip * z30 - c_rear_left_hip * z35;
    const Scalar z171 = s_rear_left_hip * z26 - c_rear_left_hip * z31;
    const Scalar z172 = v_trunk_x - z24 * z16 + z32 * z111 - z34 * z15;  // velocity of rear_left_hip_link, x
    const Scalar z173 = v_trunk_y - z25 * z15 - z30 * z16 + z35 * z111;  // velocity of rear_left_hip_link, y
    const Scalar z174 = v_trunk_z - z26 * z16 + z31 * z111 - z36 * z15;  // velocity of rear_left_hip_link, z
    const Scalar z175 = n0_08 * z168;
    const Scalar z176 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z177 = n0_08 * z176;
    const Scalar z178 = z36 * z6 - z75 * z7;
    const Scalar z179 = s_rear_left_thigh * z34 - c_rear_left_thigh * z169;
    const Scalar z180 = s_rear_left_thigh * z25 - c_rear_left_thigh * z170;
    const Scalar z181 = s_rear_left_thigh * z36 - c_rear_left_thigh * z171;
    const Scalar z182 = c_rear_left_thigh * z168 + s_rear_left_thigh * z176;
    const Scalar z183 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z184 = v_rear_left_thigh + z183;
    const Scalar z185 = n0_2 * z120;
    const Scalar z186 = n0_2 * z136;
    const Scalar z187 = n0_2 * z144;
    const Scalar z188 = n0_2 * z145;
    const Scalar z189 = s_rear_left_hip * z32 + c_rear_left_hip * z24;
    const Scalar z190 = s_rear_left_hip * z35 + c_rear_left_hip * z30;
    const Scalar z191 = s_rear_left_hip * z31 + c_rear_left_hip * z26;
    const Scalar z192 = z172 - z169 * z175 + z34 * z177;  // velocity of rear_left_thigh_link, x
    const Scalar z193 = z173 - z170 * z175 + z25 * z177;  // velocity of rear_left_thigh_link, y
    const Scalar z194 = z174 - z171 * z175 + z36 * z177;  // velocity of rear_left_thigh_link, z
    const Scalar z195 = s_rear_left_thigh * z168 - c_rear_left_thigh * z176;
    const Scalar z196 = n0_08 * z189;
    const Scalar z197 = n0_08 * z190;
    const Scalar z198 = n0_08 * z191;
    const Scalar z199 = n0_2 * z138;
    const Scalar z200 = c_rear_left_thigh * z34 + s_rear_left_thigh * z169;
    const Scalar z201 = c_rear_left_thigh * z25 + s_rear_left_thigh * z170;
    const Scalar z202 = c_rear_left_thigh * z36 + s_rear_left_thigh * z171;
    const Scalar z203 = v_front_right_knee + z138;
    const Scalar z204 = q_trunk_x - z69;  // place of rear_left_hip_link, x
    const Scalar z205 = q_trunk_y + z71;  // place of rear_left_hip_link, y
    const Scalar z206 = q_trunk_z - z72;  // place of rear_left_hip_link, z
    const Scalar z207 = z36 * z7 + z75 * z6;
    const Scalar z208 = z34 * z8 - z169 * z9;
    const Scalar z209 = z25 * z8 - z170 * z9;
    const Scalar z210 = z36 * z8 - z171 * z9;
    const Scalar z211 = z67 * z188 - z147 - z122 * z199;  // velocity of front_right_shank_link, x
    const Scalar z212 = z91 * z188 - z148 - z134 * z199;  // velocity of front_right_shank_link, y
    const Scalar z213 = z92 * z188 - z149 - z154 * z199;  // velocity of front_right_shank_link, z
    const Scalar z214 = v_rear_left_hip * z34 + z52;  // angular velocity of rear_left_hip_link, x
    const Scalar z215 = v_rear_left_thigh * z189 + z214;  // angular velocity of rear_left_thigh_link, x
    const Scalar z216 = v_rear_left_hip * z25 + z54;  // angular velocity of rear_left_hip_link, y
    const Scalar z217 = v_rear_left_thigh * z190 + z216;  // angular velocity of rear_left_thigh_link, y
    const Scalar z218 = v_rear_left_hip * z36 + z55;  // angular velocity of rear_left_hip_link, z
    const Scalar z219 = v_rear_left_thigh * z191 + z218;  // angular velocity of rear_left_thigh_link, z
    const Scalar z220 = z34 * z9 + z169 * z8;
    const Scalar z221 = z25 * z9 + z170 * z8;
    const Scalar z222 = z36 * z9 + z171 * z8;
    const Scalar z223 = z204 + z196;  // place of rear_left_thigh_link, x
    const Scalar z224 = z205 + z197;  // place of rear_left_thigh_link, y
    const Scalar z225 = z206 + z198;  // place of rear_left_thigh_link, z
    const Scalar z226 = z156 - z185;  // place of front_right_shank_link, x
    const Scalar z227 = n0_2 * z179;
    const Scalar z228 = z157 - z186;  // place of front_right_shank_link, y
    const Scalar z229 = n0_2 * z180;
    const Scalar z230 = z158 - z187;  // place of front_right_shank_link, z
    const Scalar z231 = v_rear_left_knee * z189 + z215;  // angular velocity of rear_left_shank_link, x
    const Scalar z232 = v_rear_left_knee * z190 + z217;  // angular velocity of rear_left_shank_link, y
    const Scalar z233 = v_rear_left_knee * z191 + z219;  // angular velocity of rear_left_shank_link, z
    const Scalar z234 = v_rear_right_hip * z34 + z52;  // angular velocity of rear_right_hip_link, x
    const Scalar z235 = v_rear_right_hip * z25 + z54;  // angular velocity of rear_right_hip_link, y
    const Scalar z236 = v_rear_right_hip * z36 + z55;  // angular velocity of rear_right_hip_link, z
    const Scalar z237 = s_rear_left_knee * z195 - c_rear_left_knee * z182;
    const Scalar z238 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z239 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z240 = v_trunk_x - z24 * z16 + z32 * z33 + z34 * z15;  // velocity of rear_right_hip_link, x
    const Scalar z241 = v_trunk_y + z25 * z15 - z30 * z16 + z35 * z33;  // velocity of rear_right_hip_link, y
    const Scalar z242 = v_trunk_z - z26 * z16 + z31 * z33 + z36 * z15;  // velocity of rear_right_hip_link, z
    const Scalar z243 = n0_08 * z238;
    const Scalar z244 = s_rear_right_hip * z24 - c_rear_right_hip * z32;
    const Scalar z245 = s_rear_right_hip * z30 - c_rear_right_hip * z35;
    const Scalar z246 = s_rear_right_hip * z26 - c_rear_right_hip * z31;
    const Scalar z247 = n0_08 * z239;
    const Scalar z248 = s_rear_right_thigh * z34 - c_rear_right_thigh * z244;
    const Scalar z249 = s_rear_right_thigh * z25 - c_rear_right_thigh * z245;
    const Scalar z250 = s_rear_right_thigh * z36 - c_rear_right_thigh * z246;
    const Scalar z251 = c_rear_right_thigh * z239 + s_rear_right_thigh * z238;
    const Scalar z252 = z34 * z10 - z244 * z11;
    const Scalar z253 = z25 * z10 - z245 * z11;
    const Scalar z254 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z255 = v_rear_right_thigh + z254;
    const Scalar z256 = n0_2 * z181;
    const Scalar z257 = z36 * z10 - z246 * z11;
    const Scalar z258 = n0_2 * z182;
    const Scalar z259 = s_rear_right_hip * z32 + c_rear_right_hip * z24;
    const Scalar z260 = v_rear_right_thigh * z259 + z234;  // angular velocity of rear_right_thigh_link, x
    const Scalar z261 = s_rear_right_hip * z35 + c_rear_right_hip * z30;
    const Scalar z262 = v_rear_right_thigh * z261 + z235;  // angular velocity of rear_right_thigh_link, y
    const Scalar z263 = s_rear_right_hip * z31 + c_rear_right_hip * z26;
    const Scalar z264 = v_rear_right_thigh * z263 + z236;  // angular velocity of rear_right_thigh_link, z
    const Scalar z265 = z34 * z243 - z240 - z244 * z247;  // velocity of rear_right_thigh_link, x
    const Scalar z266 = z25 * z243 - z241 - z245 * z247;  // velocity of rear_right_thigh_link, y
    const Scalar z267 = z36 * z243 - z242 - z246 * z247;  // velocity of rear_right_thigh_link, z
    const Scalar z268 = s_rear_right_thigh * z239 - c_rear_right_thigh * z238;
    const Scalar z269 = n0_08 * z259;
    const Scalar z270 = n0_08 * z261;
    const Scalar z271 = n0_08 * z263;
    const Scalar z272 = n0_2 * z184;
    const Scalar z273 = c_rear_right_thigh * z34 + s_rear_right_thigh * z244;
    const Scalar z274 = c_rear_right_thigh * z25 + s_rear_right_thigh * z245;
    const Scalar z275 = c_rear_right_thigh * z36 + s_rear_right_thigh * z246;
    const Scalar z276 = v_rear_left_knee + z184;
    const Scalar z277 = q_trunk_x - z62;  // place of rear_right_hip_link, x
    const Scalar z278 = q_trunk_y - z63;  // place of rear_right_hip_link, y
    const Scalar z279 = q_trunk_z - z64;  // place of rear_right_hip_link, z
    const Scalar z280 = z192 + z189 * z258 - z200 * z272;  // velocity of rear_left_shank_link, x
    const Scalar z281 = z193 + z190 * z258 - z201 * z272;  // velocity of rear_left_shank_link, y
    const Scalar z282 = z194 + z191 * z258 - z202 * z272;  // velocity of rear_left_shank_link, z
    const Scalar z283 = z34 * z11 + z244 * z10;
    const Scalar z284 = z25 * z11 + z245 * z10;
    const Scalar z285 = z36 * z11 + z246 * z10;
    const Scalar z286 = z277 - z269;  // place of rear_right_thigh_link, x
    const Scalar z287 = z278 - z270;  // place of rear_right_thigh_link, y
    const Scalar z288 = z279 - z271;  // place of rear_right_thigh_link, z
    const Scalar z289 = z223 - z227;  // place of rear_left_shank_link, x
    const Scalar z290 = n0_2 * z248;
    const Scalar z291 = z224 - z229;  // place of rear_left_shank_link, y
    const Scalar z292 = n0_2 * z249;
    const Scalar z293 = z225 - z256;  // place of rear_left_shank_link, z
    const Scalar z294 = v_rear_right_knee * z259 + z260;  // angular velocity of rear_right_shank_link, x
    const Scalar z295 = v_rear_right_knee * z261 + z262;  // angular velocity of rear_right_shank_link, y
    const Scalar z296 = v_rear_right_knee * z263 + z264;  // angular velocity of rear_right_shank_link, z
    const Scalar z297 = n0_04 * z37;
    const Scalar z298 = n0_09 * z80;
    const Scalar z299 = s_rear_right_knee * z268 - c_rear_right_knee * z251;
    const Scalar z300 = n0_04 * z45;
    const Scalar z301 = z41 - z38 * z297 + z34 * z300;
    const Scalar z302 = z42 - z39 * z297 + z25 * z300;
    const Scalar z303 = z43 - z40 * z297 + z36 * z300;
    const Scalar z304 = n0_09 * z70;
    const Scalar z305 = z84 + z56 * z298 - z98 * z304;
    const Scalar z306 = z85 + z57 * z298 - z99 * z304;
    const Scalar z307 = z86 + z58 * z298 - z100 * z304;
    const Scalar z308 = n0_09 * z77;
    const Scalar z309 = z133 - z308;
    const Scalar z310 = n0_09 * z78;
    const Scalar z311 = z135 - z310;
    const Scalar z312 = n0_09 * z79;
    const Scalar z313 = z137 - z312;
    const Scalar z314 = n0_2 * z250;
    const Scalar z315 = n0_2 * z251;
    const Scalar z316 = n0_2 * z81;
    const Scalar z317 = n0_1 * z81;
    const Scalar z318 = z159 - z317;
    const Scalar z319 = z159 - z316;
    const Scalar z320 = n0_2 * z82;
    const Scalar z321 = n0_1 * z82;
    const Scalar z322 = z161 - z321;
    const Scalar z323 = z161 - z320;
    const Scalar z324 = n0_2 * z83;
    const Scalar z325 = n0_1 * z83;
    const Scalar z326 = z163 - z325;
    const Scalar z327 = z163 - z324;
    const Scalar z328 = n0_2 * z255;
    const Scalar z329 = v_rear_right_knee + z255;
    const Scalar z330 = z259 * z315 - z265 - z273 * z328;  // velocity of rear_right_shank_link, x
    const Scalar z331 = z261 * z315 - z266 - z274 * z328;  // velocity of rear_right_shank_link, y
    const Scalar z332 = z263 * z315 - z267 - z275 * z328;  // velocity of rear_right_shank_link, z
    const Scalar z333 = n0_1 * z102;
    const Scalar z334 = n0_2 * z102;
    const Scalar z335 = n0_1 * z94;
    const Scalar z336 = n0_2 * z94;
    const Scalar z337 = z124 * z333 - z127 + z56 * z335;
    const Scalar z338 = z124 * z334 - z127 + z56 * z336;
    const Scalar z339 = z125 * z333 - z128 + z57 * z335;
    const Scalar z340 = z126 * z333 - z129 + z58 * z335;
    const Scalar z341 = z125 * z334 - z128 + z57 * z336;
    const Scalar z342 = z126 * z334 - z129 + z58 * z336;
    const Scalar z343 = z286 - z290;  // place of rear_right_shank_link, x
    const Scalar z344 = z287 - z292;  // place of rear_right_shank_link, y
    const Scalar z345 = z288 - z314;  // place of rear_right_shank_link, z
    const Scalar z346 = n0_04 * z114;
    const Scalar z347 = n0_04 * z116;
    const Scalar z348 = z34 * z346 - z117 - z73 * z347;
    const Scalar z349 = z25 * z346 - z118 - z74 * z347;
    const Scalar z350 = z36 * z346 - z119 - z75 * z347;
    const Scalar z351 = n0_09 * z120;
    const Scalar z352 = z156 - z351;
    const Scalar z353 = n0_09 * z136;
    const Scalar z354 = z157 - z353;
    const Scalar z355 = n0_09 * z144;
    const Scalar z356 = n0_04 * z56;
    const Scalar z357 = z65 + z356;
    const Scalar z358 = z158 - z355;
    const Scalar z359 = n0_04 * z57;
    const Scalar z360 = z66 + z359;
    const Scalar z361 = n0_09 * z138;
    const Scalar z362 = n0_04 * z58;
    const Scalar z363 = z68 + z362;
    const Scalar z364 = n0_09 * z145;
    const Scalar z365 = z67 * z364 - z147 - z122 * z361;
    const Scalar z366 = z91 * z364 - z148 - z134 * z361;
    const Scalar z367 = z92 * z364 - z149 - z154 * z361;
    const Scalar z368 = n0_04 * z168;
    const Scalar z369 = n0_04 * z176;
    const Scalar z370 = z172 - z169 * z368 + z34 * z369;
    const Scalar z371 = z173 - z170 * z368 + z25 * z369;
    const Scalar z372 = z174 - z171 * z368 + z36 * z369;
    const Scalar z373 = n0_09 * z179;
    const Scalar z374 = z223 - z373;
    const Scalar z375 = n0_09 * z180;
    const Scalar z376 = z224 - z375;
    const Scalar z377 = n0_09 * z181;
    const Scalar z378 = n0_2 * z146;
    const Scalar z379 = n0_1 * z146;
    const Scalar z380 = z226 - z379;
    const Scalar z381 = z226 - z378;
    const Scalar z382 = n0_2 * z162;
    const Scalar z383 = n0_1 * z162;
    const Scalar z384 = z228 - z383;
    const Scalar z385 = z228 - z382;
    const Scalar z386 = n0_2 * z178;
    const Scalar z387 = n0_1 * z178;
    const Scalar z388 = z230 - z387;
    const Scalar z389 = z230 - z386;
    const Scalar z390 = n0_1 * z203;
    const Scalar z391 = n0_2 * z203;
    const Scalar z392 = n0_1 * z167;
    const Scalar z393 = n0_2 * z167;
    const Scalar z394 = z155 * z390 - z211 + z67 * z392;
    const Scalar z395 = z155 * z391 - z211 + z67 * z393;
    const Scalar z396 = z160 * z390 - z212 + z91 * z392;
    const Scalar z397 = z207 * z390 - z213 + z92 * z392;
    const Scalar z398 = z160 * z391 - z212 + z91 * z393;
    const Scalar z399 = z207 * z391 - z213 + z92 * z393;
    const Scalar z400 = n0_04 * z67;
    const Scalar z401 = z105 - z400;
    const Scalar z402 = z225 - z377;
    const Scalar z403 = n0_04 * z91;
    const Scalar z404 = z108 - z403;
    const Scalar z405 = n0_09 * z184;
    const Scalar z406 = n0_04 * z92;
    const Scalar z407 = z123 - z406;
    const Scalar z408 = n0_09 * z182;
    const Scalar z409 = z192 + z189 * z408 - z200 * z405;
    const Scalar z410 = z193 + z190 * z408 - z201 * z405;
    const Scalar z411 = z194 + z191 * z408 - z202 * z405;
    const Scalar z412 = n0_04 * z238;
    const Scalar z413 = n0_04 * z239;
    const Scalar z414 = z34 * z412 - z240 - z244 * z413;
    const Scalar z415 = z25 * z412 - z241 - z245 * z413;
    const Scalar z416 = z36 * z412 - z242 - z246 * z413;
    const Scalar z417 = n0_09 * z248;
    const Scalar z418 = z286 - z417;
    const Scalar z419 = n0_09 * z249;
    const Scalar z420 = z287 - z419;
    const Scalar z421 = n0_09 * z250;
    const Scalar z422 = n0_2 * z208;
    const Scalar z423 = n0_1 * z208;
    const Scalar z424 = z289 - z423;
    const Scalar z425 = z289 - z422;
    const Scalar z426 = n0_2 * z209;
    const Scalar z427 = n0_1 * z209;
    const Scalar z428 = z291 - z427;
    const Scalar z429 = z291 - z426;
    const Scalar z430 = n0_2 * z210;
    const Scalar z431 = n0_1 * z210;
    const Scalar z432 = z293 - z431;
    const Scalar z433 = z293 - z430;
    const Scalar z434 = n0_1 * z276;
    const Scalar z435 = n0_2 * z276;
    const Scalar z436 = n0_1 * z237;
    const Scalar z437 = n0_2 * z237;
    const Scalar z438 = z220 * z434 - z280 + z189 * z436;
    const Scalar z439 = z220 * z435 - z280 + z189 * z437;
    const Scalar z440 = z221 * z434 - z281 + z190 * z436;
    const Scalar z441 = z222 * z434 - z282 + z191 * z436;
    const Scalar z442 = z221 * z435 - z281 + z190 * z437;
    const Scalar z443 = z222 * z435 - z282 + z191 * z437;
    const Scalar z444 = n0_04 * z189;
    const Scalar z445 = z204 + z444;
    const Scalar z446 = z288 - z421;
    const Scalar z447 = n0_04 * z190;
    const Scalar z448 = z205 + z447;
    const Scalar z449 = n0_09 * z255;
    const Scalar z450 = n0_04 * z191;
    const Scalar z451 = z206 + z450;
    const Scalar z452 = z87 + z316;
    const Scalar z453 = z88 + z320;
    const Scalar z454 = z89 + z324;
    const Scalar z455 = z95 - z452;
    const Scalar z456 = z96 - z453;
    const Scalar z457 = z97 - z454;
    const Scalar z458 = n0_09 * z251;
    const Scalar z459 = z259 * z458 - z265 - z273 * z449;
    const Scalar z460 = z261 * z458 - z266 - z274 * z449;
    const Scalar z461 = z263 * z458 - z267 - z275 * z449;
    const Scalar z462 = z57 * z324 - z58 * z320;
    const Scalar z463 = z56 * z324 - z58 * z316;
    const Scalar z464 = z56 * z320 - z57 * z316;
    const Scalar z465 = z57 * z454 - z58 * z453;
    const Scalar z466 = z56 * z454 - z58 * z452;
    const Scalar z467 = z56 * z453 - z57 * z452;
    const Scalar z468 = z25 * z457 - z36 * z456;
    const Scalar z469 = z34 * z457 - z36 * z455;
    const Scalar z470 = z34 * z456 - z25 * z455;
    const Scalar z471 = z62 + z455;
    const Scalar z472 = n0_2 * z252;
    const Scalar z473 = n0_1 * z252;
    const Scalar z474 = z343 - z473;
    const Scalar z475 = z343 - z472;
    const Scalar z476 = n0_2 * z253;
    const Scalar z477 = n0_1 * z253;
    const Scalar z478 = z344 - z477;
    const Scalar z479 = z344 - z476;
    const Scalar z480 = n0_2 * z257;
    const Scalar z481 = n0_1 * z257;
    const Scalar z482 = z345 - z481;
    const Scalar z483 = z345 - z480;
    const Scalar z484 = n0_1 * z329;
    const Scalar z485 = n0_2 * z329;
    const Scalar z486 = n0_1 * z299;
    const Scalar z487 = n0_2 * z299;
    const Scalar z488 = z283 * z484 - z330 + z259 * z486;
    const Scalar z489 = z283 * z485 - z330 + z259 * z487;
    const Scalar z490 = z284 * z484 - z331 + z261 * z486;
    const Scalar z491 = z285 * z484 - z332 + z263 * z486;
    const Scalar z492 = z284 * z485 - z331 + z261 * z487;
    const Scalar z493 = z285 * z485 - z332 + z263 * z487;
    const Scalar z494 = n0_04 * z259;
    const Scalar z495 = z277 - z494;
    const Scalar z496 = z63 + z456;
    const Scalar z497 = n0_04 * z261;
    const Scalar z498 = z278 - z497;
    const Scalar z499 = z64 + z457;
    const Scalar z500 = n0_04 * z263;
    const Scalar z501 = z279 - z500;
    const Scalar z502 = z185 + z378;
    const Scalar z503 = z186 + z382;
    const Scalar z504 = z187 + z386;
    const Scalar z505 = z227 + z422;
    const Scalar z506 = z229 + z426;
    const Scalar z507 = z256 + z430;
    const Scalar z508 = z151 + z502;
    const Scalar z509 = z152 + z503;
    const Scalar z510 = z153 + z504;
    const Scalar z511 = z196 - z505;
    const Scalar z512 = z197 - z506;
    const Scalar z513 = z198 - z507;
    const Scalar z514 = z35 * z499 - z31 * z496;
    const Scalar z515 = z31 * z471 - z32 * z499;
    const Scalar z516 = z35 * z471 - z32 * z496;
    const Scalar z517 = z30 * z499 - z26 * z496;
    const Scalar z518 = z24 * z499 - z26 * z471;
    const Scalar z519 = z24 * z496 - z30 * z471;
    const Scalar z520 = z25 * z499 - z36 * z496;
    const Scalar z521 = z34 * z499 - z36 * z471;
    const Scalar z522 = z34 * z496 - z25 * z471;
    const Scalar z523 = z290 + z472;
    const Scalar z524 = z292 + z476;
    const Scalar z525 = z314 + z480;
    const Scalar z526 = z91 * z386 - z92 * z382;
    const Scalar z527 = z67 * z386 - z92 * z378;
    const Scalar z528 = z67 * z382 - z91 * z378;
    const Scalar z529 = z269 + z523;
    const Scalar z530 = z270 + z524;
    const Scalar z531 = z271 + z525;
    const Scalar z532 = z91 * z504 - z92 * z503;
    const Scalar z533 = z67 * z504 - z92 * z502;
    const Scalar z534 = z67 * z503 - z91 * z502;
    const Scalar z535 = z62 + z529;
    const Scalar z536 = z63 + z530;
    const Scalar z537 = z64 + z531;
    const Scalar z538 = z25 * z510 - z36 * z509;
    const Scalar z539 = z34 * z510 - z36 * z508;
    const Scalar z540 = z72 - z510;
    const Scalar z541 = z72 - z513;
    const Scalar z542 = z34 * z509 - z25 * z508;
    const Scalar z543 = z69 - z508;
    const Scalar z544 = z71 + z509;
    const Scalar z545 = z69 - z511;
    const Scalar z546 = z71 + z512;
    const Scalar z547 = z35 * z540 + z31 * z544;
    const Scalar z548 = z31 * z543 - z32 * z540;
    const Scalar z549 = z35 * z543 + z32 * z544;
    const Scalar z550 = z30 * z540 + z26 * z544;
    const Scalar z551 = z24 * z540 - z26 * z543;
    const Scalar z552 = z24 * z544 + z30 * z543;
    const Scalar z553 = z25 * z540 + z36 * z544;
    const Scalar z554 = z34 * z540 - z36 * z543;
    const Scalar z555 = z34 * z544 + z25 * z543;
    const Scalar z556 = z190 * z430 - z191 * z426;
    const Scalar z557 = z189 * z430 - z191 * z422;
    const Scalar z558 = z189 * z426 - z190 * z422;
    const Scalar z559 = z190 * z507 - z191 * z506;
    const Scalar z560 = z189 * z507 - z191 * z505;
    const Scalar z561 = z189 * z506 - z190 * z505;
    const Scalar z562 = z25 * z513 - z36 * z512;
    const Scalar z563 = z34 * z513 - z36 * z511;
    const Scalar z564 = z34 * z512 - z25 * z511;
    const Scalar z565 = z35 * z541 + z31 * z546;
    const Scalar z566 = z31 * z545 - z32 * z541;
    const Scalar z567 = z35 * z545 + z32 * z546;
    const Scalar z568 = z30 * z541 + z26 * z546;
    const Scalar z569 = z24 * z541 - z26 * z545;
    const Scalar z570 = z24 * z546 + z30 * z545;
    const Scalar z571 = z25 * z541 + z36 * z546;
    const Scalar z572 = z34 * z541 - z36 * z545;
    const Scalar z573 = z34 * z546 + z25 * z545;
    const Scalar z574 = z261 * z480 - z263 * z476;
    const Scalar z575 = z259 * z480 - z263 * z472;
    const Scalar z576 = z259 * z476 - z261 * z472;
    const Scalar z577 = z261 * z525 - z263 * z524;
    const Scalar z578 = z259 * z525 - z263 * z523;
    const Scalar z579 = z259 * z524 - z261 * z523;
    const Scalar z580 = z25 * z531 - z36 * z530;
    const Scalar z581 = z34 * z531 - z36 * z529;
    const Scalar z582 = z34 * z530 - z25 * z529;
    const Scalar z583 = z35 * z537 - z31 * z536;
    const Scalar z584 = z31 * z535 - z32 * z537;
    const Scalar z585 = z35 * z535 - z32 * z536;
    const Scalar z586 = z30 * z537 - z26 * z536;
    const Scalar z587 = z24 * z537 - z26 * z535;
    const Scalar z588 = z24 * z536 - z30 * z535;
    const Scalar z589 = z25 * z537 - z36 * z536;
    const Scalar z590 = z34 * z537 - z36 * z535;
    const Scalar z591 = z34 * z536 - z25 * z535;
    result.trunk_position[0] = q_trunk_x;
    result.trunk_position[1] = q_trunk_y;
    result.trunk_position[2] = q_trunk_z;
    result.trunk_rotation[0] = z34;
    result.trunk_rotation[1] = z25;
    result.trunk_rotation[2] = z36;
    result.trunk_rotation[3] = z24;
    result.trunk_rotation[4] = z30;
    result.trunk_rotation[5] = z26;
    result.trunk_rotation[6] = z32;
    result.trunk_rotation[7] = z35;
    result.trunk_rotation[8] = z31;
    result.trunk_velocity[0] = v_trunk_x;
    result.trunk_velocity[1] = v_trunk_y;
    result.trunk_velocity[2] = v_trunk_z;
    result.trunk_angular_velocity[0] = z52;
    result.trunk_angular_velocity[1] = z54;
    result.trunk_angular_velocity[2] = z55;
    result.front_left_hip_link_position[0] = z357;
    result.front_left_hip_link_position[1] = z360;
    result.front_left_hip_link_position[2] = z363;
    result.front_left_hip_link_rotation[0] = z34;
    result.front_left_hip_link_rotation[1] = z25;
    result.front_left_hip_link_rotation[2] = z36;
    result.front_left_hip_link_rotation[3] = z56;
    result.front_left_hip_link_rotation[4] = z57;
    result.front_left_hip_link_rotation[5] = z58;
    result.front_left_hip_link_rotation[6] = -z38;
    result.front_left_hip_link_rotation[7] = -z39;
    result.front_left_hip_link_rotation[8] = -z40;
    result.front_left_hip_link_velocity[0] = z301;
    result.front_left_hip_link_velocity[1] = z302;
    result.front_left_hip_link_velocity[2] = z303;
    result.front_left_hip_link_angular_velocity[0] = z103;
    result.front_left_hip_link_angular_velocity[1] = z106;
    result.front_left_hip_link_angular_velocity[2] = z110;
    result.front_left_thigh_link_position[0] = z309;
    result.front_left_thigh_link_position[1] = z311;
    result.front_left_thigh_link_position[2] = z313;
    result.front_left_thigh_link_rotation[0] = z98;
    result.front_left_thigh_link_rotation[1] = z99;
    result.front_left_thigh_link_rotation[2] = z100;
    result.front_left_thigh_link_rotation[3] = z56;
    result.front_left_thigh_link_rotation[4] = z57;
    result.front_left_thigh_link_rotation[5] = z58;
    result.front_left_thigh_link_rotation[6] = z77;
    result.front_left_thigh_link_rotation[7] = z78;
    result.front_left_thigh_link_rotation[8] = z79;
    result.front_left_thigh_link_velocity[0] = z305;
    result.front_left_thigh_link_velocity[1] = z306;
    result.front_left_thigh_link_velocity[2] = z307;
    result.front_left_thigh_link_angular_velocity[0] = z104;
    result.front_left_thigh_link_angular_velocity[1] = z107;
    result.front_left_thigh_link_angular_velocity[2] = z113;
    result.front_left_shank_link_position[0] = z318;
    result.front_left_shank_link_position[1] = z322;
    result.front_left_shank_link_position[2] = z326;
    result.front_left_shank_link_rotation[0] = z124;
    result.front_left_shank_link_rotation[1] = z125;
    result.front_left_shank_link_rotation[2] = z126;
    result.front_left_shank_link_rotation[3] = z56;
    result.front_left_shank_link_rotation[4] = z57;
    result.front_left_shank_link_rotation[5] = z58;
    result.front_left_shank_link_rotation[6] = z81;
    result.front_left_shank_link_rotation[7] = z82;
    result.front_left_shank_link_rotation[8] = z83;
    result.front_left_shank_link_velocity[0] = -z337;
    result.front_left_shank_link_velocity[1] = -z339;
    result.front_left_shank_link_velocity[2] = -z340;
    result.front_left_shank_link_angular_velocity[0] = z109;
    result.front_left_shank_link_angular_velocity[1] = z112;
    result.front_left_shank_link_angular_velocity[2] = z115;
    result.front_left_foot_position[0] = z319;
    result.front_left_foot_position[1] = z323;
    result.front_left_foot_position[2] = z327;
    result.front_left_foot_rotation[0] = z124;
    result.front_left_foot_rotation[1] = z125;
    result.front_left_foot_rotation[2] = z126;
    result.front_left_foot_rotation[3] = z56;
    result.front_left_foot_rotation[4] = z57;
    result.front_left_foot_rotation[5] = z58;
    result.front_left_foot_rotation[6] = z81;
    result.front_left_foot_rotation[7] = z82;
    result.front_left_foot_rotation[8] = z83;
    result.front_left_foot_velocity[0] = -z338;
    result.front_left_foot_velocity[1] = -z341;
    result.front_left_foot_velocity[2] = -z342;
    result.front_left_foot_angular_velocity[0] = z109;
    result.front_left_foot_angular_velocity[1] = z112;
    result.front_left_foot_angular_velocity[2] = z115;
    result.front_right_hip_link_position[0] = z401;
    result.front_right_hip_link_position[1] = z404;
    result.front_right_hip_link_position[2] = z407;
    result.front_right_hip_link_rotation[0] = z34;
    result.front_right_hip_link_rotation[1] = z25;
    result.front_right_hip_link_rotation[2] = z36;
    result.front_right_hip_link_rotation[3] = z67;
    result.front_right_hip_link_rotation[4] = z91;
    result.front_right_hip_link_rotation[5] = z92;
    result.front_right_hip_link_rotation[6] = -z73;
    result.front_right_hip_link_rotation[7] = -z74;
    result.front_right_hip_link_rotation[8] = -z75;
    result.front_right_hip_link_velocity[0] = -z348;
    result.front_right_hip_link_velocity[1] = -z349;
    result.front_right_hip_link_velocity[2] = -z350;
    result.front_right_hip_link_angular_velocity[0] = z130;
    result.front_right_hip_link_angular_velocity[1] = z131;
    result.front_right_hip_link_angular_velocity[2] = z132;
    result.front_right_thigh_link_position[0] = z352;
    result.front_right_thigh_link_position[1] = z354;
    result.front_right_thigh_link_position[2] = z358;
    result.front_right_thigh_link_rotation[0] = z122;
    result.front_right_thigh_link_rotation[1] = z134;
    result.front_right_thigh_link_rotation[2] = z154;
    result.front_right_thigh_link_rotation[3] = z67;
    result.front_right_thigh_link_rotation[4] = z91;
    result.front_right_thigh_link_rotation[5] = z92;
    result.front_right_thigh_link_rotation[6] = z120;
    result.front_right_thigh_link_rotation[7] = z136;
    result.front_right_thigh_link_rotation[8] = z144;
    result.front_right_thigh_link_velocity[0] = z365;
    result.front_right_thigh_link_velocity[1] = z366;
    result.front_right_thigh_link_velocity[2] = z367;
    result.front_right_thigh_link_angular_velocity[0] = z139;
    result.front_right_thigh_link_angular_velocity[1] = z140;
    result.front_right_thigh_link_angular_velocity[2] = z141;
    result.front_right_shank_link_position[0] = z380;
    result.front_right_shank_link_position[1] = z384;
    result.front_right_shank_link_position[2] = z388;
    result.front_right_shank_link_rotation[0] = z155;
    result.front_right_shank_link_rotation[1] = z160;
    result.front_right_shank_link_rotation[2] = z207;
    result.front_right_shank_link_rotation[3] = z67;
    result.front_right_shank_link_rotation[4] = z91;
    result.front_right_shank_link_rotation[5] = z92;
    result.front_right_shank_link_rotation[6] = z146;
    result.front_right_shank_link_rotation[7] = z162;
    result.front_right_shank_link_rotation[8] = z178;
    result.front_right_shank_link_velocity[0] = -z394;
    result.front_right_shank_link_velocity[1] = -z396;
    result.front_right_shank_link_velocity[2] = -z397;
    result.front_right_shank_link_angular_velocity[0] = z164;
    result.front_right_shank_link_angular_velocity[1] = z165;
    result.front_right_shank_link_angular_velocity[2] = z166;
    result.front_right_foot_position[0] = z381;
    result.front_right_foot_position[1] = z385;
    result.front_right_foot_position[2] = z389;
    result.front_right_foot_rotation[0] = z155;
    result.front_right_foot_rotation[1] = z160;
    result.front_right_foot_rotation[2] = z207;
    result.front_right_foot_rotation[3] = z67;
    result.front_right_foot_rotation[4] = z91;
    result.front_right_foot_rotation[5] = z92;
    result.front_right_foot_rotation[6] = z146;
    result.front_right_foot_rotation[7] = z162;
    result.front_right_foot_rotation[8] = z178;
    result.front_right_foot_velocity[0] = -z395;
    result.front_right_foot_velocity[1] = -z398;
    result.front_right_foot_velocity[2] = -z399;
    result.front_right_foot_angular_velocity[0] = z164;
    result.front_right_foot_angular_velocity[1] = z165;
    result.front_right_foot_angular_velocity[2] = z166;
    result.rear_left_hip_link_position[0] = z445;
    result.rear_left_hip_link_position[1] = z448;
    result.rear_left_hip_link_position[2] = z451;
    result.rear_left_hip_link_rotation[0] = z34;
    result.rear_left_hip_link_rotation[1] = z25;
    result.rear_left_hip_link_rotation[2] = z36;
    result.rear_left_hip_link_rotation[3] = z189;
    result.rear_left_hip_link_rotation[4] = z190;
    result.rear_left_hip_link_rotation[5] = z191;
    result.rear_left_hip_link_rotation[6] = -z169;
    result.rear_left_hip_link_rotation[7] = -z170;
    result.rear_left_hip_link_rotation[8] = -z171;
    result.rear_left_hip_link_velocity[0] = z370;
    result.rear_left_hip_link_velocity[1] = z371;
    result.rear_left_hip_link_velocity[2] = z372;
    result.rear_left_hip_link_angular_velocity[0] = z214;
    result.rear_left_hip_link_angular_velocity[1] = z216;
    result.rear_left_hip_link_angular_velocity[2] = z218;
    result.rear_left_thigh_link_position[0] = z374;
    result.rear_left_thigh_link_position[1] = z376;
    result.rear_left_thigh_link_position[2] = z402;
    result.rear_left_thigh_link_rotation[0] = z200;
    result.rear_left_thigh_link_rotation[1] = z201;
    result.rear_left_thigh_link_rotation[2] = z202;
    result.rear_left_thigh_link_rotation[3] = z189;
    result.rear_left_thigh_link_rotation[4] = z190;
    result.rear_left_thigh_link_rotation[5] = z191;
    result.rear_left_thigh_link_rotation[6] = z179;
    result.rear_left_thigh_link_rotation[7] = z180;
    result.rear_left_thigh_link_rotation[8] = z181;
    result.rear_left_thigh_link_velocity[0] = z409;
    result.rear_left_thigh_link_velocity[1] = z410;
    result.rear_left_thigh_link_velocity[2] = z411;
    result.rear_left_thigh_link_angular_velocity[0] = z215;
    result.rear_left_thigh_link_angular_velocity[1] = z217;
    result.rear_left_thigh_link_angular_velocity[2] = z219;
    result.rear_left_shank_link_position[0] = z424;
    result.rear_left_shank_link_position[1] = z428;
    result.rear_left_shank_link_position[2] = z432;
    result.rear_left_shank_link_rotation[0] = z220;
    result.rear_left_shank_link_rotation[1] = z221;
    result.rear_left_shank_link_rotation[2] = z222;
    result.rear_left_shank_link_rotation[3] = z189;
    result.rear_left_shank_link_rotation[4] = z190;
    result.rear_left_shank_link_rotation[5] = z191;
    result.rear_left_shank_link_rotation[6] = z208;
    result.rear_left_shank_link_rotation[7] = z209;
    result.rear_left_shank_link_rotation[8] = z210;
    result.rear_left_shank_link_velocity[0] = -z438;
    result.rear_left_shank_link_velocity[1] = -z440;
    result.rear_left_shank_link_velocity[2] = -z441;
    result.rear_left_shank_link_angular_velocity[0] = z231;
    result.rear_left_shank_link_angular_velocity[1] = z232;
    result.rear_left_shank_link_angular_velocity[2] = z233;
    result.rear_left_foot_position[0] = z425;
    result.rear_left_foot_position[1] = z429;
    result.rear_left_foot_position[2] = z433;
    result.rear_left_foot_rotation[0] = z220;
    result.rear_left_foot_rotation[1] = z221;
    result.rear_left_foot_rotation[2] = z222;
    result.rear_left_foot_rotation[3] = z189;
    result.rear_left_foot_rotation[4] = z190;
    result.rear_left_foot_rotation[5] = z191;
    result.rear_left_foot_rotation[6] = z208;
    result.rear_left_foot_rotation[7] = z209;
    result.rear_left_foot_rotation[8] = z210;
    result.rear_left_foot_velocity[0] = -z439;
    result.rear_left_foot_velocity[1] = -z442;
    result.rear_left_foot_velocity[2] = -z443;
    result.rear_left_foot_angular_velocity[0] = z231;
    result.rear_left_foot_angular_velocity[1] = z232;
    result.rear_left_foot_angular_velocity[2] = z233;
    result.rear_right_hip_link_position[0] = z495;
    result.rear_right_hip_link_position[1] = z498;
    result.rear_right_hip_link_position[2] = z501;
    result.rear_right_hip_link_rotation[0] = z34;
    result.rear_right_hip_link_rotation[1] = z25;
    result.rear_right_hip_link_rotation[2] = z36;
    result.rear_right_hip_link_rotation[3] = z259;
    result.rear_right_hip_link_rotation[4] = z261;
    result.rear_right_hip_link_rotation[5] = z263;
    result.rear_right_hip_link_rotation[6] = -z244;
    result.rear_right_hip_link_rotation[7] = -z245;
    result.rear_right_hip_link_rotation[8] = -z246;
    result.rear_right_hip_link_velocity[0] = -z414;
    result.rear_right_hip_link_velocity[1] = -z415;
    result.rear_right_hip_link_velocity[2] = -z416;
    result.rear_right_hip_link_angular_velocity[0] = z234;
    result.rear_right_hip_link_angular_velocity[1] = z235;
    result.rear_right_hip_link_angular_velocity[2] = z236;
    result.rear_right_thigh_link_position[0] = z418;
    result.rear_right_thigh_link_position[1] = z420;
    result.rear_right_thigh_link_position[2] = z446;
    result.rear_right_thigh_link_rotation[0] = z273;
    result.rear_right_thigh_link_rotation[1] = z274;
    result.rear_right_thigh_link_rotation[2] = z275;
    result.rear_right_thigh_link_rotation[3] = z259;
    result.rear_right_thigh_link_rotation[4] = z261;
    result.rear_right_thigh_link_rotation[5] = z263;
    result.rear_right_thigh_link_rotation[6] = z248;
    result.rear_right_thigh_link_rotation[7] = z249;
    result.rear_right_thigh_link_rotation[8] = z250;
    result.rear_right_thigh_link_velocity[0] = z459;
    result.rear_right_thigh_link_velocity[1] = z460;
    result.rear_right_thigh_link_velocity[2] = z461;
    result.rear_right_thigh_link_angular_velocity[0] = z260;
    result.rear_right_thigh_link_angular_velocity[1] = z262;
    result.rear_right_thigh_link_angular_velocity[2] = z264;
    result.rear_right_shank_link_position[0] = z474;
    result.rear_right_shank_link_position[1] = z478;
    result.rear_right_shank_link_position[2] = z482;
    result.rear_right_shank_link_rotation[0] = z283;
    result.rear_right_shank_link_rotation[1] = z284;
    result.rear_right_shank_link_rotation[2] = z285;
    result.rear_right_shank_link_rotation[3] = z259;
    result.rear_right_shank_link_rotation[4] = z261;
    result.rear_right_shank_link_rotation[5] = z263;
    result.rear_right_shank_link_rotation[6] = z252;
    result.rear_right_shank_link_rotation[7] = z253;
    result.rear_right_shank_link_rotation[8] = z257;
    result.rear_right_shank_link_velocity[0] = -z488;
    result.rear_right_shank_link_velocity[1] = -z490;
    result.rear_right_shank_link_velocity[2] = -z491;
    result.rear_right_shank_link_angular_velocity[0] = z294;
    result.rear_right_shank_link_angular_velocity[1] = z295;
    result.rear_right_shank_link_angular_velocity[2] = z296;
    result.rear_right_foot_position[0] = z475;
    result.rear_right_foot_position[1] = z479;
    result.rear_right_foot_position[2] = z483;
    result.rear_right_foot_rotation[0] = z283;
    result.rear_right_foot_rotation[1] = z284;
    result.rear_right_foot_rotation[2] = z285;
    result.rear_right_foot_rotation[3] = z259;
    result.rear_right_foot_rotation[4] = z261;
    result.rear_right_foot_rotation[5] = z263;
    result.rear_right_foot_rotation[6] = z252;
    result.rear_right_foot_rotation[7] = z253;
    result.rear_right_foot_rotation[8] = z257;
    result.rear_right_foot_velocity[0] = -z489;
    result.rear_right_foot_velocity[1] = -z492;
    result.rear_right_foot_velocity[2] = -z493;
    result.rear_right_foot_angular_velocity[0] = z294;
    result.rear_right_foot_angular_velocity[1] = z295;
    result.rear_right_foot_angular_velocity[2] = z296;
    result.front_left_foot_origin_position[0] = z319;
    result.front_left_foot_origin_position[1] = z323;
    result.front_left_foot_origin_position[2] = z327;
    result.front_left_foot_origin_velocity[0] = -z338;
    result.front_left_foot_origin_velocity[1] = -z341;
    result.front_left_foot_origin_velocity[2] = -z342;
    result.front_left_foot_origin_jacobian[0] = n1;
    result.front_left_foot_origin_jacobian[3] = n0;
    result.front_left_foot_origin_jacobian[6] = n0;
    result.front_left_foot_origin_jacobian[9] = z520;
    result.front_left_foot_origin_jacobian[12] = z517;
    result.front_left_foot_origin_jacobian[15] = z514;
    result.front_left_foot_origin_jacobian[18] = z468;
    result.front_left_foot_origin_jacobian[21] = -z465;
    result.front_left_foot_origin_jacobian[24] = -z462;
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
    result.front_left_foot_origin_jacobian[10] = -z521;
    result.front_left_foot_origin_jacobian[13] = -z518;
    result.front_left_foot_origin_jacobian[16] = z515;
    result.front_left_foot_origin_jacobian[19] = -z469;
    result.front_left_foot_origin_jacobian[22] = z466;
    result.front_left_foot_origin_jacobian[25] = z463;
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
    result.front_left_foot_origin_jacobian[11] = z522;
    result.front_left_foot_origin_jacobian[14] = z519;
    result.front_left_foot_origin_jacobian[17] = -z516;
    result.front_left_foot_origin_jacobian[20] = z470;
    result.front_left_foot_origin_jacobian[23] = -z467;
    result.front_left_foot_origin_jacobian[26] = -z464;
    result.front_left_foot_origin_jacobian[29] = n0;
    result.front_left_foot_origin_jacobian[32] = n0;
    result.front_left_foot_origin_jacobian[35] = n0;
    result.front_left_foot_origin_jacobian[38] = n0;
    result.front_left_foot_origin_jacobian[41] = n0;
    result.front_left_foot_origin_jacobian[44] = n0;
    result.front_left_foot_origin_jacobian[47] = n0;
    result.front_left_foot_origin_jacobian[50] = n0;
    result.front_left_foot_origin_jacobian[53] = n0;
    result.front_right_foot_origin_position[0] = z381;
    result.front_right_foot_origin_position[1] = z385;
    result.front_right_foot_origin_position[2] = z389;
    result.front_right_foot_origin_velocity[0] = -z395;
    result.front_right_foot_origin_velocity[1] = -z398;
    result.front_right_foot_origin_velocity[2] = -z399;
    result.front_right_foot_origin_jacobian[0] = n1;
    result.front_right_foot_origin_jacobian[3] = n0;
    result.front_right_foot_origin_jacobian[6] = n0;
    result.front_right_foot_origin_jacobian[9] = z553;
    result.front_right_foot_origin_jacobian[12] = z550;
    result.front_right_foot_origin_jacobian[15] = z547;
    result.front_right_foot_origin_jacobian[18] = n0;
    result.front_right_foot_origin_jacobian[21] = n0;
    result.front_right_foot_origin_jacobian[24] = n0;
    result.front_right_foot_origin_jacobian[27] = -z538;
    result.front_right_foot_origin_jacobian[30] = -z532;
    result.front_right_foot_origin_jacobian[33] = -z526;
    result.front_right_foot_origin_jacobian[36] = n0;
    result.front_right_foot_origin_jacobian[39] = n0;
    result.front_right_foot_origin_jacobian[42] = n0;
    result.front_right_foot_origin_jacobian[45] = n0;
    result.front_right_foot_origin_jacobian[48] = n0;
    result.front_right_foot_origin_jacobian[51] = n0;
    result.front_right_foot_origin_jacobian[1] = n0;
    result.front_right_foot_origin_jacobian[4] = n1;
    result.front_right_foot_origin_jacobian[7] = n0;
    result.front_right_foot_origin_jacobian[10] = -z554;
    result.front_right_foot_origin_jacobian[13] = -z551;
    result.front_right_foot_origin_jacobian[16] = z548;
    result.front_right_foot_origin_jacobian[19] = n0;
    result.front_right_foot_origin_jacobian[22] = n0;
    result.front_right_foot_origin_jacobian[25] = n0;
    result.front_right_foot_origin_jacobian[28] = z539;
    result.front_right_foot_origin_jacobian[31] = z533;
    result.front_right_foot_origin_jacobian[34] = z527;
    result.front_right_foot_origin_jacobian[37] = n0;
    result.front_right_foot_origin_jacobian[40] = n0;
    result.front_right_foot_origin_jacobian[43] = n0;
    result.front_right_foot_origin_jacobian[46] = n0;
    result.front_right_foot_origin_jacobian[49] = n0;
    result.front_right_foot_origin_jacobian[52] = n0;
    result.front_right_foot_origin_jacobian[2] = n0;
    result.front_right_foot_origin_jacobian[5] = n0;
    result.front_right_foot_origin_jacobian[8] = n1;
    result.front_right_foot_origin_jacobian[11] = -z555;
    result.front_right_foot_origin_jacobian[14] = -z552;
    result.front_right_foot_origin_jacobian[17] = -z549;
    result.front_right_foot_origin_jacobian[20] = n0;
    result.front_right_foot_origin_jacobian[23] = n0;
    result.front_right_foot_origin_jacobian[26] = n0;
    result.front_right_foot_origin_jacobian[29] = -z542;
    result.front_right_foot_origin_jacobian[32] = -z534;
    result.front_right_foot_origin_jacobian[35] = -z528;
    result.front_right_foot_origin_jacobian[38] = n0;
    result.front_right_foot_origin_jacobian[41] = n0;
    result.front_right_foot_origin_jacobian[44] = n0;
    result.front_right_foot_origin_jacobian[47] = n0;
    result.front_right_foot_origin_jacobian[50] = n0;
    result.front_right_foot_origin_jacobian[53] = n0;
    result.rear_left_foot_origin_position[0] = z425;
    result.rear_left_foot_origin_position[1] = z429;
    result.rear_left_foot_origin_position[2] = z433;
    result.rear_left_foot_origin_velocity[0] = -z439;
    result.rear_left_foot_origin_velocity[1] = -z442;
    result.rear_left_foot_origin_velocity[2] = -z443;
    result.rear_left_foot_origin_jacobian[0] = n1;
    result.rear_left_foot_origin_jacobian[3] = n0;
    result.rear_left_foot_origin_jacobian[6] = n0;
    result.rear_left_foot_origin_jacobian[9] = -z571;
    result.rear_left_foot_origin_jacobian[12] = -z568;
    result.rear_left_foot_origin_jacobian[15] = -z565;
    result.rear_left_foot_origin_jacobian[18] = n0;
    result.rear_left_foot_origin_jacobian[21] = n0;
    result.rear_left_foot_origin_jacobian[24] = n0;
    result.rear_left_foot_origin_jacobian[27] = n0;
    result.rear_left_foot_origin_jacobian[30] = n0;
    result.rear_left_foot_origin_jacobian[33] = n0;
    result.rear_left_foot_origin_jacobian[36] = z562;
    result.rear_left_foot_origin_jacobian[39] = -z559;
    result.rear_left_foot_origin_jacobian[42] = -z556;
    result.rear_left_foot_origin_jacobian[45] = n0;
    result.rear_left_foot_origin_jacobian[48] = n0;
    result.rear_left_foot_origin_jacobian[51] = n0;
    result.rear_left_foot_origin_jacobian[1] = n0;
    result.rear_left_foot_origin_jacobian[4] = n1;
    result.rear_left_foot_origin_jacobian[7] = n0;
    result.rear_left_foot_origin_jacobian[10] = z572;
    result.rear_left_foot_origin_jacobian[13] = z569;
    result.rear_left_foot_origin_jacobian[16] = -z566;
    result.rear_left_foot_origin_jacobian[19] = n0;
    result.rear_left_foot_origin_jacobian[22] = n0;
    result.rear_left_foot_origin_jacobian[25] = n0;
    result.rear_left_foot_origin_jacobian[28] = n0;
    result.rear_left_foot_origin_jacobian[31] = n0;
    result.rear_left_foot_origin_jacobian[34] = n0;
    result.rear_left_foot_origin_jacobian[37] = -z563;
    result.rear_left_foot_origin_jacobian[40] = z560;
    result.rear_left_foot_origin_jacobian[43] = z557;
    result.rear_left_foot_origin_jacobian[46] = n0;
    result.rear_left_foot_origin_jacobian[49] = n0;
    result.rear_left_foot_origin_jacobian[52] = n0;
    result.rear_left_foot_origin_jacobian[2] = n0;
    result.rear_left_foot_origin_jacobian[5] = n0;
    result.rear_left_foot_origin_jacobian[8] = n1;
    result.rear_left_foot_origin_jacobian[11] = z573;
    result.rear_left_foot_origin_jacobian[14] = z570;
    result.rear_left_foot_origin_jacobian[17] = z567;
    result.rear_left_foot_origin_jacobian[20] = n0;
    result.rear_left_foot_origin_jacobian[23] = n0;
    result.rear_left_foot_origin_jacobian[26] = n0;
    result.rear_left_foot_origin_jacobian[29] = n0;
    result.rear_left_foot_origin_jacobian[32] = n0;
    result.rear_left_foot_origin_jacobian[35] = n0;
    result.rear_left_foot_origin_jacobian[38] = z564;
    result.rear_left_foot_origin_jacobian[41] = -z561;
    result.rear_left_foot_origin_jacobian[44] = -z558;
    result.rear_left_foot_origin_jacobian[47] = n0;
    result.rear_left_foot_origin_jacobian[50] = n0;
    result.rear_left_foot_origin_jacobian[53] = n0;
    result.rear_right_foot_origin_position[0] = z475;
    result.rear_right_foot_origin_position[1] = z479;
    result.rear_right_foot_origin_position[2] = z483;
    result.rear_right_foot_origin_velocity[0] = -z489;
    result.rear_right_foot_origin_velocity[1] = -z492;
    result.rear_right_foot_origin_velocity[2] = -z493;
    result.rear_right_foot_origin_jacobian[0] = n1;
    result.rear_right_foot_origin_jacobian[3] = n0;
    result.rear_right_foot_origin_jacobian[6] = n0;
    result.rear_right_foot_origin_jacobian[9] = -z589;
    result.rear_right_foot_origin_jacobian[12] = -z586;
    result.rear_right_foot_origin_jacobian[15] = -z583;
    result.rear_right_foot_origin_jacobian[18] = n0;
    result.rear_right_foot_origin_jacobian[21] = n0;
    result.rear_right_foot_origin_jacobian[24] = n0;
    result.rear_right_foot_origin_jacobian[27] = n0;
    result.rear_right_foot_origin_jacobian[30] = n0;
    result.rear_right_foot_origin_jacobian[33] = n0;
    result.rear_right_foot_origin_jacobian[36] = n0;
    result.rear_right_foot_origin_jacobian[39] = n0;
    result.rear_right_foot_origin_jacobian[42] = n0;
    result.rear_right_foot_origin_jacobian[45] = -z580;
    result.rear_right_foot_origin_jacobian[48] = -z577;
    result.rear_right_foot_origin_jacobian[51] = -z574;
    result.rear_right_foot_origin_jacobian[1] = n0;
    result.rear_right_foot_origin_jacobian[4] = n1;
    result.rear_right_foot_origin_jacobian[7] = n0;
    result.rear_right_foot_origin_jacobian[10] = z590;
    result.rear_right_foot_origin_jacobian[13] = z587;
    result.rear_right_foot_origin_jacobian[16] = -z584;
    result.rear_right_foot_origin_jacobian[19] = n0;
    result.rear_right_foot_origin_jacobian[22] = n0;
    result.rear_right_foot_origin_jacobian[25] = n0;
    result.rear_right_foot_origin_jacobian[28] = n0;
    result.rear_right_foot_origin_jacobian[31] = n0;
    result.rear_right_foot_origin_jacobian[34] = n0;
    result.rear_right_foot_origin_jacobian[37] = n0;
    result.rear_right_foot_origin_jacobian[40] = n0;
    result.rear_right_foot_origin_jacobian[43] = n0;
    result.rear_right_foot_origin_jacobian[46] = z581;
    result.rear_right_foot_origin_jacobian[49] = z578;
    result.rear_right_foot_origin_jacobian[52] = z575;
    result.rear_right_foot_origin_jacobian[2] = n0;
    result.rear_right_foot_origin_jacobian[5] = n0;
    result.rear_right_foot_origin_jacobian[8] = n1;
    result.rear_right_foot_origin_jacobian[11] = -z591;
    result.rear_right_foot_origin_jacobian[14] = -z588;
    result.rear_right_foot_origin_jacobian[17] = z585;
    result.rear_right_foot_origin_jacobian[20] = n0;
    result.rear_right_foot_origin_jacobian[23] = n0;
    result.rear_right_foot_origin_jacobian[26] = n0;
    result.rear_right_foot_origin_jacobian[29] = n0;
    result.rear_right_foot_origin_jacobian[32] = n0;
    result.rear_right_foot_origin_jacobian[35] = n0;
    result.rear_right_foot_origin_jacobian[38] = n0;
    result.rear_right_foot_origin_jacobian[41] = n0;
    result.rear_right_foot_origin_jacobian[44] = n0;
    result.rear_right_foot_origin_jacobian[47] = -z582;
    result.rear_right_foot_origin_jacobian[50] = -z579;
    result.rear_right_foot_origin_jacobian[53] = -z576;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state,
      std::array<Scalar, 324>& mass) noexcept {
    const Scalar k0 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k4 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k8 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar k9 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k11 = traits::constant(0.0325736, 0.0325736f, "40717/1250000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k14 = traits::constant(0.0329736, 0.0329736f, "41217/1250000");
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
    const Scalar z0 = k0 * s_rear_right_knee;
    const Scalar z1 = k0 * c_rear_right_knee;
    const Scalar z2 = n0_032 * c_rear_right_knee;
    const Scalar z3 = n0_032 * s_rear_right_knee;
    const Scalar z4 = n2 * q_trunk_attitude_y;
    const Scalar z5 = n2 * q_trunk_attitude_z;
    const Scalar z6 = q_trunk_attitude_y * z4;
    const Scalar z7 = q_trunk_attitude_z * z5;
    const Scalar z8 = q_trunk_attitude_x * z4;
    const Scalar z9 = q_trunk_attitude_w * z5;
    const Scalar z10 = n2 * q_trunk_attitude_x;
    const Scalar z11 = q_trunk_attitude_x * z5;
    const Scalar z12 = q_trunk_attitude_w * z4;
    const Scalar z13 = n1 - z6 - z7;
    const Scalar z14 = z8 + z9;
    const Scalar z15 = q_trunk_attitude_x * z10;
    const Scalar z16 = q_trunk_attitude_z * z4;
    const Scalar z17 = q_trunk_attitude_w * z10;
    const Scalar z18 = z11 - z12;
    const Scalar z19 = z8 - z9;
    const Scalar z20 = n1 - z7 - z15;
    const Scalar z21 = z16 + z17;
    const Scalar z22 = n1 - z6 - z15;
    const Scalar z23 = z16 - z17;
    const Scalar z24 = z11 + z12;
    const Scalar z25 = k4 + n0_2 * z2;
    const Scalar z26 = s_rear_right_thigh * z3;
    const Scalar z27 = c_rear_right_thigh * z3;
    const Scalar z28 = c_rear_right_knee * z1;
    const Scalar z29 = s_rear_right_knee * z0;
    const Scalar z30 = s_rear_right_knee * z1;
    const Scalar z31 = k4 + n0_4 * z2;
    const Scalar z32 = n0_124 + z2;
    const Scalar z33 = c_rear_right_thigh * z2 - z26;
    const Scalar z34 = s_rear_right_thigh * z2 + z27;
    const Scalar z35 = n0_4 * z2 - z29;
    const Scalar z36 = n0_2 * z3 + z30;
    const Scalar z37 = k8 + z28;
    const Scalar z38 = c_rear_right_thigh * z32 - z26;
    const Scalar z39 = s_rear_right_thigh * z32 + z27;
    const Scalar z40 = k9 + z31;
    const Scalar z41 = n0_08 * z34;
    const Scalar z42 = n0_08 * z33;
    const Scalar z43 = s_rear_right_hip * z34;
    const Scalar z44 = c_rear_right_hip * z34;
    const Scalar z45 = n0_08 * z39;
    const Scalar z46 = n0_08 * z38;
    const Scalar z47 = s_rear_right_hip * z39;
    const Scalar z48 = c_rear_right_hip * z39;
    const Scalar z49 = z35 + z37;
    const Scalar z50 = n2 * z36;
    const Scalar z51 = k11 - z40;
    const Scalar z52 = n0_1048 * s_rear_right_hip + c_rear_right_hip * z38;
    const Scalar z53 = s_rear_right_hip * z38 - n0_1048 * c_rear_right_hip;
    const Scalar z54 = c_rear_right_hip * z25 + s_rear_right_hip * z42;
    const Scalar z55 = s_rear_right_hip * z25 - c_rear_right_hip * z42;
    const Scalar z56 = z41 + n0_05 * z44;
    const Scalar z57 = z13 * z33 + z19 * z43 - z24 * z44;
    const Scalar z58 = z14 * z33 + z20 * z43 - z23 * z44;
    const Scalar z59 = z18 * z33 + z21 * z43 - z22 * z44;
    const Scalar z60 = c_rear_right_hip * z40 + s_rear_right_hip * z46;
    const Scalar z61 = s_rear_right_hip * z40 - c_rear_right_hip * z46;
    const Scalar z62 = z45 + n0_05 * z48;
    const Scalar z63 = z13 * z38 + z19 * z47 - z24 * z48;
    const Scalar z64 = z14 * z38 + z20 * z47 - z23 * z48;
    const Scalar z65 = s_rear_right_thigh * z49 + c_rear_right_thigh * z50;
    const Scalar z66 = z18 * z38 + z21 * z47 - z22 * z48;
    const Scalar z67 = n0_05 * z33 - z55 - n0_2 * z43;
    const Scalar z68 = n0_05 * z38 - z61 - n0_2 * z47;
    const Scalar z69 = n0_2 * z44 + z54;
    const Scalar z70 = n0_2 * z48 + z60;
    const Scalar z71 = k0 * s_rear_left_knee;
    const Scalar z72 = s_rear_left_knee * z71;
    const Scalar z73 = c_rear_right_thigh * z65 - z36;
    const Scalar z74 = s_rear_right_thigh * z65;
    const Scalar z75 = z37 - z74;
    const Scalar z76 = z35 - z74;
    const Scalar z77 = k0 * c_rear_left_knee;
    const Scalar z78 = z19 * z52 + z24 * z53;
    const Scalar z79 = k14 + z76;
    const Scalar z80 = z20 * z52 + z23 * z53;
    const Scalar z81 = z21 * z52 + z22 * z53;
    const Scalar z82 = z79 - n0_05 * z53;
    const Scalar z83 = z79 - n0_1 * z53;
    const Scalar z84 = n0_032 * c_rear_left_knee;
    const Scalar z85 = n0_4 * z84 - z72;
    const Scalar z86 = n0_0406 + z83;
    const Scalar z87 = c_rear_left_knee * z77;
    const Scalar z88 = s_rear_left_knee * z77;
    const Scalar z89 = k8 + z87;
    const Scalar z90 = n0_032 * s_rear_left_knee;
    const Scalar z91 = n0_2 * z90 + z88;
    const Scalar z92 = s_rear_left_thigh * z90;
    const Scalar z93 = c_rear_left_thigh * z90;
    const Scalar z94 = n0_124 + z84;
    const Scalar z95 = k4 + n0_4 * z84;
    const Scalar z96 = k9 + z95;
    const Scalar z97 = c_rear_left_thigh * z94 - z92;
    const Scalar z98 = s_rear_left_thigh * z94 + z93;
    const Scalar z99 = c_rear_left_thigh * z84 - z92;
    const Scalar z100 = s_rear_left_thigh * z84 + z93;
    const Scalar z101 = k4 + n0_2 * z84;
    const Scalar z102 = z75 - z51;
    const Scalar z103 = n0_08 * z97;
    const Scalar z104 = n2 * z46;
    const Scalar z105 = s_rear_right_hip * z102 - c_rear_right_hip * z104;
    const Scalar z106 = n0_08 * z98;
    const Scalar z107 = s_rear_right_hip * z73 - c_rear_right_hip * z45;
    const Scalar z108 = s_rear_right_hip * z45 + c_rear_right_hip * z73;
    const Scalar z109 = n0_2 * z52 + z108;
    const Scalar z110 = c_rear_right_hip * z105 + z46;
    const Scalar z111 = s_rear_right_hip * z105;
    const Scalar z112 = n0_2 * z53 + z107;
    const Scalar z113 = n0_05 * z39 - z107 - n0_2 * z53;
    const Scalar z114 = z75 - z111;
    const Scalar z115 = z51 + z111;
    const Scalar z116 = n0_05 * z52 - z110;
    const Scalar z117 = n0_4 * z39 - z115;
    const Scalar z118 = n0_4 * z39 - z114 - n0_1 * z53;
    const Scalar z119 = z85 + z89;
    const Scalar z120 = k17 + z117;
    const Scalar z121 = n2 * z91;
    const Scalar z122 = s_rear_left_thigh * z119 + c_rear_left_thigh * z121;
    const Scalar z123 = k11 - z96;
    const Scalar z124 = n0_1048 * s_rear_left_hip - c_rear_left_hip * z97;
    const Scalar z125 = k18 + z118;
    const Scalar z126 = n2 * z103;
    const Scalar z127 = n0_1048 * c_rear_left_hip + s_rear_left_hip * z97;
    const Scalar z128 = c_rear_left_thigh * z122 - z91;
    const Scalar z129 = s_rear_left_thigh * z122;
    const Scalar z130 = z19 * z124 - z24 * z127;
    const Scalar z131 = z89 - z129;
    const Scalar z132 = z85 - z129;
    const Scalar z133 = z20 * z124 - z23 * z127;
    const Scalar z134 = z21 * z124 - z22 * z127;
    const Scalar z135 = k14 + z132;
    const Scalar z136 = z131 - z123;
    const Scalar z137 = c_rear_left_hip * z106 + s_rear_left_hip * z128;
    const Scalar z138 = c_rear_left_hip * z126 + s_rear_left_hip * z136;
    const Scalar z139 = s_rear_left_hip * z106 - c_rear_left_hip * z128;
    const Scalar z140 = n0_2 * z124 + z139;
    const Scalar z141 = z135 + n0_05 * z127;
    const Scalar z142 = n0_2 * z127 + z137;
    const Scalar z143 = s_rear_left_hip * z138;
    const Scalar z144 = n0_08 * z99;
    const Scalar z145 = s_rear_left_hip * z100;
    const Scalar z146 = s_rear_left_hip * z101 + c_rear_left_hip * z144;
    const Scalar z147 = s_rear_left_hip * z144 - c_rear_left_hip * z101;
    const Scalar z148 = s_rear_left_hip * z98;
    const Scalar z149 = z146 + n0_05 * z99 + n0_2 * z145;
    const Scalar z150 = s_rear_left_hip * z96 + c_rear_left_hip * z103;
    const Scalar z151 = z150 + n0_05 * z97 + n0_2 * z148;
    const Scalar z152 = s_rear_left_hip * z103 - c_rear_left_hip * z96;
    const Scalar z153 = n0_08 * z100;
    const Scalar z154 = c_rear_left_hip * z138 - z103;
    const Scalar z155 = z131 - z143;
    const Scalar z156 = z123 + z143;
    const Scalar z157 = c_rear_left_hip * z100;
    const Scalar z158 = z153 + n0_05 * z157;
    const Scalar z159 = n0_2 * z157 - z147;
    const Scalar z160 = z39 + z98;
    const Scalar z161 = z135 + n0_1 * z127;
    const Scalar z162 = z137 + n0_05 * z98 + n0_2 * z127;
    const Scalar z163 = n0_4 * z98 - z156;
    const Scalar z164 = n0_05 * z124 - z154;
    const Scalar z165 = n0_4 * z98 - z155 + n0_1 * z127;
    const Scalar z166 = c_rear_left_hip * z98;
    const Scalar z167 = z106 + n0_05 * z166;
    const Scalar z168 = n0_2 * z166 - z152;
    const Scalar z169 = z13 * z99 + z19 * z145 - z24 * z157;
    const Scalar z170 = z53 + z127;
    const Scalar z171 = z14 * z99 + z20 * z145 - z23 * z157;
    const Scalar z172 = z18 * z99 + z21 * z145 - z22 * z157;
    const Scalar z173 = z52 - z124;
    const Scalar z174 = z86 + z161;
    const Scalar z175 = z113 - z162;
    const Scalar z176 = z120 + z163;
    const Scalar z177 = z109 - z140;
    const Scalar z178 = z116 + z164;
    const Scalar z179 = z125 + z165;
    const Scalar z180 = z13 * z97 + z19 * z148 - z24 * z166;
    const Scalar z181 = z14 * z97 + z20 * z148 - z23 * z166;
    const Scalar z182 = z18 * z97 + z21 * z148 - z22 * z166;
    const Scalar z183 = k0 * s_front_right_knee;
    const Scalar z184 = k0 * c_front_right_knee;
    const Scalar z185 = s_front_right_knee * z183;
    const Scalar z186 = n0_032 * c_front_right_knee;
    const Scalar z187 = c_front_right_knee * z184;
    const Scalar z188 = s_front_right_knee * z184;
    const Scalar z189 = n0_032 * s_front_right_knee;
    const Scalar z190 = n0_4 * z186 - z185;
    const Scalar z191 = k8 + z187;
    const Scalar z192 = n0_2 * z189 + z188;
    const Scalar z193 = k4 + n0_4 * z186;
    const Scalar z194 = k9 + z193;
    const Scalar z195 = z190 + z191;
    const Scalar z196 = n2 * z192;
    const Scalar z197 = s_front_right_thigh * z189;
    const Scalar z198 = c_front_right_thigh * z189;
    const Scalar z199 = n0_124 + z186;
    const Scalar z200 = c_front_right_thigh * z199 - z197;
    const Scalar z201 = s_front_right_thigh * z195 + c_front_right_thigh * z196;
    const Scalar z202 = s_front_right_thigh * z199 + z198;
    const Scalar z203 = c_front_right_thigh * z186 - z197;
    const Scalar z204 = s_front_right_thigh * z186 + z198;
    const Scalar z205 = k4 + n0_2 * z186;
    const Scalar z206 = k11 - z194;
    const Scalar z207 = n0_08 * z200;
    const Scalar z208 = c_front_right_thigh * z201 - z192;
    const Scalar z209 = s_front_right_thigh * z201;
    const Scalar z210 = n2 * z207;
    const Scalar z211 = n0_08 * z202;
    const Scalar z212 = n0_1048 * s_front_right_hip + c_front_right_hip * z200;
    const Scalar z213 = z191 - z209;
    const Scalar z214 = z190 - z209;
    const Scalar z215 = s_front_right_hip * z208 - c_front_right_hip * z211;
    const Scalar z216 = k14 + z214;
    const Scalar z217 = s_front_right_hip * z211 + c_front_right_hip * z208;
    const Scalar z218 = z213 - z206;
    const Scalar z219 = s_front_right_hip * z218 - c_front_right_hip * z210;
    const Scalar z220 = n0_2 * z212 - z217;
    const Scalar z221 = n0_08 * z203;
    const Scalar z222 = s_front_right_hip * z200 - n0_1048 * c_front_right_hip;
    const Scalar z223 = z216 - n0_05 * z222;
    const Scalar z224 = n0_2 * z222 - z215;
    const Scalar z225 = z19 * z212 + z24 * z222;
    const Scalar z226 = z20 * z212 + z23 * z222;
    const Scalar z227 = z21 * z212 + z22 * z222;
    const Scalar z228 = s_front_right_hip * z219;
    const Scalar z229 = s_front_right_hip * z204;
    const Scalar z230 = s_front_right_hip * z205 - c_front_right_hip * z221;
    const Scalar z231 = c_front_right_hip * z205 + s_front_right_hip * z221;
    const Scalar z232 = n0_05 * z203 - z230 + n0_2 * z229;
    const Scalar z233 = s_front_right_hip * z202;
    const Scalar z234 = s_front_right_hip * z194 - c_front_right_hip * z207;
    const Scalar z235 = n0_05 * z200 - z234 + n0_2 * z233;
    const Scalar z236 = c_front_right_hip * z194 + s_front_right_hip * z207;
    const Scalar z237 = n0_08 * z204;
    const Scalar z238 = c_front_right_hip * z219 + z207;
    const Scalar z239 = z213 - z228;
    const Scalar z240 = z206 + z228;
    const Scalar z241 = c_front_right_hip * z204;
    const Scalar z242 = z237 + n0_05 * z241;
    const Scalar z243 = n0_2 * z241 - z231;
    const Scalar z244 = z160 + z202;
    const Scalar z245 = z216 - n0_1 * z222;
    const Scalar z246 = n0_05 * z202 - z215 + n0_2 * z222;
    const Scalar z247 = n0_4 * z202 + z240;
    const Scalar z248 = n0_05 * z212 - z238;
    const Scalar z249 = z239 + n0_4 * z202 + n0_1 * z222;
    const Scalar z250 = c_front_right_hip * z202;
    const Scalar z251 = z211 + n0_05 * z250;
    const Scalar z252 = n0_2 * z250 - z236;
    const Scalar z253 = z13 * z203 + z19 * z229 - z24 * z241;
    const Scalar z254 = z170 + z222;
    const Scalar z255 = z14 * z203 + z20 * z229 - z23 * z241;
    const Scalar z256 = z18 * z203 + z21 * z229 - z22 * z241;
    const Scalar z257 = z173 + z212;
    const Scalar z258 = z174 + z245;
    const Scalar z259 = z175 + z246;
    const Scalar z260 = z176 - z247;
    const Scalar z261 = z177 - z220;
    const Scalar z262 = z178 + z248;
    const Scalar z263 = z179 - z249;
    const Scalar z264 = z13 * z200 + z19 * z233 - z24 * z250;
    const Scalar z265 = z14 * z200 + z20 * z233 - z23 * z250;
    const Scalar z266 = z18 * z200 + z21 * z233 - z22 * z250;
    const Scalar z267 = k0 * s_front_left_knee;
    const Scalar z268 = k0 * c_front_left_knee;
    const Scalar z269 = s_front_left_knee * z267;
    const Scalar z270 = n0_032 * c_front_left_knee;
    const Scalar z271 = c_front_left_knee * z268;
    const Scalar z272 = s_front_left_knee * z268;
    const Scalar z273 = n0_032 * s_front_left_knee;
    const Scalar z274 = n0_4 * z270 - z269;
    const Scalar z275 = k8 + z271;
    const Scalar z276 = n0_2 * z273 + z272;
    const Scalar z277 = s_front_left_thigh * z273;
    const Scalar z278 = c_front_left_thigh * z273;
    const Scalar z279 = n0_124 + z270;
    const Scalar z280 = z274 + z275;
    const Scalar z281 = n2 * z276;
    const Scalar z282 = k4 + n0_4 * z270;
    const Scalar z283 = k9 + z282;
    const Scalar z284 = c_front_left_thigh * z279 - z277;
    const Scalar z285 = s_front_left_thigh * z280 + c_front_left_thigh * z281;
    const Scalar z286 = s_front_left_thigh * z279 + z278;
    const Scalar z287 = c_front_left_thigh * z270 - z277;
    const Scalar z288 = s_front_left_thigh * z270 + z278;
    const Scalar z289 = k4 + n0_2 * z270;
    const Scalar z290 = n0_08 * z284;
    const Scalar z291 = k11 - z283;
    const Scalar z292 = c_front_left_thigh * z285 - z276;
    const Scalar z293 = s_front_left_thigh * z285;
    const Scalar z294 = n2 * z290;
    const Scalar z295 = n0_08 * z286;
    const Scalar z296 = n0_08 * z287;
    const Scalar z297 = z275 - z293;
    const Scalar z298 = z274 - z293;
    const Scalar z299 = c_front_left_hip * z295 + s_front_left_hip * z292;
    const Scalar z300 = s_front_left_hip * z295 - c_front_left_hip * z292;
    const Scalar z301 = k14 + z298;
    const Scalar z302 = z297 - z291;
    const Scalar z303 = n0_1048 * s_front_left_hip - c_front_left_hip * z284;
    const Scalar z304 = c_front_left_hip * z294 + s_front_left_hip * z302;
    const Scalar z305 = n0_2 * z303 - z300;
    const Scalar z306 = s_front_left_hip * z288;
    const Scalar z307 = s_front_left_hip * z289 + c_front_left_hip * z296;
    const Scalar z308 = s_front_left_hip * z296 - c_front_left_hip * z289;
    const Scalar z309 = z307 + n0_05 * z287 - n0_2 * z306;
    const Scalar z310 = s_front_left_hip * z304;
    const Scalar z311 = s_front_left_hip * z286;
    const Scalar z312 = s_front_left_hip * z283 + c_front_left_hip * z290;
    const Scalar z313 = z312 + n0_05 * z284 - n0_2 * z311;
    const Scalar z314 = s_front_left_hip * z290 - c_front_left_hip * z283;
    const Scalar z315 = n0_1048 * c_front_left_hip + s_front_left_hip * z284;
    const Scalar z316 = z301 + n0_05 * z315;
    const Scalar z317 = n0_2 * z315 - z299;
    const Scalar z318 = z19 * z303 - z24 * z315;
    const Scalar z319 = z20 * z303 - z23 * z315;
    const Scalar z320 = z21 * z303 - z22 * z315;
    const Scalar z321 = n0_08 * z288;
    const Scalar z322 = c_front_left_hip * z304 - z290;
    const Scalar z323 = z297 - z310;
    const Scalar z324 = z291 + z310;
    const Scalar z325 = c_front_left_hip * z288;
    const Scalar z326 = z321 + n0_05 * z325;
    const Scalar z327 = n0_2 * z325 + z308;
    const Scalar z328 = z244 + z286;
    const Scalar z329 = z301 + n0_1 * z315;
    const Scalar z330 = z299 + n0_05 * z286 - n0_2 * z315;
    const Scalar z331 = n0_4 * z286 + z324;
    const Scalar z332 = n0_05 * z303 - z322;
    const Scalar z333 = z323 + n0_4 * z286 - n0_1 * z315;
    const Scalar z334 = c_front_left_hip * z286;
    const Scalar z335 = z295 + n0_05 * z334;
    const Scalar z336 = n0_2 * z334 + z314;
    const Scalar z337 = z13 * z287 + z19 * z306 - z24 * z325;
    const Scalar z338 = z254 + z315;
    const Scalar z339 = z14 * z287 + z20 * z306 - z23 * z325;
    const Scalar z340 = z18 * z287 + z21 * z306 - z22 * z325;
    const Scalar z341 = z258 + z329;
    const Scalar z342 = z259 - z330;
    const Scalar z343 = z260 - z331;
    const Scalar z344 = z261 + z305;
    const Scalar z345 = z262 + z332;
    const Scalar z346 = z257 - z303;
    const Scalar z347 = z13 * z284 + z19 * z311 - z24 * z334;
    const Scalar z348 = z14 * z284 + z20 * z311 - z23 * z334;
    const Scalar z349 = z18 * z284 + z21 * z311 - z22 * z334;
    const Scalar z350 = z263 - z333;
    const Scalar z351 = z19 * z328 + z13 * z338;
    const Scalar z352 = z20 * z328 + z14 * z338;
    const Scalar z353 = z21 * z328 + z18 * z338;
    const Scalar z354 = z13 * z346 - z24 * z328;
    const Scalar z355 = z14 * z346 - z23 * z328;
    const Scalar z356 = z22 * z328 - z18 * z346;
    const Scalar z357 = z19 * z346 + z24 * z338;
    const Scalar z358 = z20 * z346 + z23 * z338;
    const Scalar z359 = z21 * z346 + z22 * z338;
    mass[0] = n12_24;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z357;
    mass[4] = -z354;
    mass[5] = -z351;
    mass[6] = -z318;
    mass[7] = -z347;
    mass[8] = -z337;
    mass[9] = z225;
    mass[10] = -z264;
    mass[11] = -z253;
    mass[12] = -z130;
    mass[13] = -z180;
    mass[14] = -z169;
    mass[15] = z78;
    mass[16] = -z63;
    mass[17] = -z57;
    mass[18] = n0;
    mass[19] = n12_24;
    mass[20] = n0;
    mass[21] = z358;
    mass[22] = -z355;
    mass[23] = -z352;
    mass[24] = -z319;
    mass[25] = -z348;
    mass[26] = -z339;
    mass[27] = z226;
    mass[28] = -z265;
    mass[29] = -z255;
    mass[30] = -z133;
    mass[31] = -z181;
    mass[32] = -z171;
    mass[33] = z80;
    mass[34] = -z64;
    mass[35] = -z58;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n12_24;
    mass[39] = z359;
    mass[40] = z356;
    mass[41] = -z353;
    mass[42] = -z320;
    mass[43] = -z349;
    mass[44] = -z340;
    mass[45] = z227;
    mass[46] = -z266;
    mass[47] = -z256;
    mass[48] = -z134;
    mass[49] = -z182;
    mass[50] = -z172;
    mass[51] = z81;
    mass[52] = -z66;
    mass[53] = -z59;
    mass[54] = z357;
    mass[55] = z358;
    mass[56] = z359;
    mass[57] = z341;
    mass[58] = -z342;
    mass[59] = -z344;
    mass[60] = z316;
    mass[61] = z335;
    mass[62] = z326;
    mass[63] = z223;
    mass[64] = -z251;
    mass[65] = -z242;
    mass[66] = z141;
    mass[67] = z167;
    mass[68] = z158;
    mass[69] = z82;
    mass[70] = -z62;
    mass[71] = -z56;
    mass[72] = -z354;
    mass[73] = -z355;
    mass[74] = z356;
    mass[75] = -z342;
    mass[76] = z343;
    mass[77] = -z345;
    mass[78] = -z317;
    mass[79] = -z336;
    mass[80] = -z327;
    mass[81] = -z224;
    mass[82] = -z252;
    mass[83] = -z243;
    mass[84] = z142;
    mass[85] = z168;
    mass[86] = z159;
    mass[87] = z112;
    mass[88] = z70;
    mass[89] = z69;
    mass[90] = -z351;
    mass[91] = -z352;
    mass[92] = -z353;
    mass[93] = -z344;
    mass[94] = -z345;
    mass[95] = z350;
    mass[96] = -z305;
    mass[97] = z313;
    mass[98] = z309;
    mass[99] = z220;
    mass[100] = -z235;
    mass[101] = -z232;
    mass[102] = z140;
    mass[103] = z151;
    mass[104] = z149;
    mass[105] = -z109;
    mass[106] = -z68;
    mass[107] = -z67;
    mass[108] = -z318;
    mass[109] = -z319;
    mass[110] = -z320;
    mass[111] = z316;
    mass[112] = -z317;
    mass[113] = -z305;
    mass[114] = z301;
    mass[115] = z295;
    mass[116] = z321;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n0;
    mass[121] = n0;
    mass[122] = n0;
    mass[123] = n0;
    mass[124] = n0;
    mass[125] = n0;
    mass[126] = -z347;
    mass[127] = -z348;
    mass[128] = -z349;
    mass[129] = z335;
    mass[130] = -z336;
    mass[131] = z313;
    mass[132] = z295;
    mass[133] = z283;
    mass[134] = z289;
    mass[135] = n0;
    mass[136] = n0;
    mass[137] = n0;
    mass[138] = n0;
    mass[139] = n0;
    mass[140] = n0;
    mass[141] = n0;
    mass[142] = n0;
    mass[143] = n0;
    mass[144] = -z337;
    mass[145] = -z339;
    mass[146] = -z340;
    mass[147] = z326;
    mass[148] = -z327;
    mass[149] = z309;
    mass[150] = z321;
    mass[151] = z289;
    mass[152] = k4;
    mass[153] = n0;
    mass[154] = n0;
    mass[155] = n0;
    mass[156] = n0;
    mass[157] = n0;
    mass[158] = n0;
    mass[159] = n0;
    mass[160] = n0;
    mass[161] = n0;
    mass[162] = z225;
    mass[163] = z226;
    mass[164] = z227;
    mass[165] = z223;
    mass[166] = -z224;
    mass[167] = z220;
    mass[168] = n0;
    mass[169] = n0;
    mass[170] = n0;
    mass[171] = z216;
    mass[172] = -z211;
    mass[173] = -z237;
    mass[174] = n0;
    mass[175] = n0;
    mass[176] = n0;
    mass[177] = n0;
    mass[178] = n0;
    mass[179] = n0;
    mass[180] = -z264;
    mass[181] = -z265;
    mass[182] = -z266;
    mass[183] = -z251;
    mass[184] = -z252;
    mass[185] = -z235;
    mass[186] = n0;
    mass[187] = n0;
    mass[188] = n0;
    mass[189] = -z211;
    mass[190] = z194;
    mass[191] = z205;
    mass[192] = n0;
    mass[193] = n0;
    mass[194] = n0;
    mass[195] = n0;
    mass[196] = n0;
    mass[197] = n0;
    mass[198] = -z253;
    mass[199] = -z255;
    mass[200] = -z256;
    mass[201] = -z242;
    mass[202] = -z243;
    mass[203] = -z232;
    mass[204] = n0;
    mass[205] = n0;
    mass[206] = n0;
    mass[207] = -z237;
    mass[208] = z205;
    mass[209] = k4;
    mass[210] = n0;
    mass[211] = n0;
    mass[212] = n0;
    mass[213] = n0;
    mass[214] = n0;
    mass[215] = n0;
    mass[216] = -z130;
    mass[217] = -z133;
    mass[218] = -z134;
    mass[219] = z141;
    mass[220] = z142;
    mass[221] = z140;
    mass[222] = n0;
    mass[223] = n0;
    mass[224] = n0;
    mass[225] = n0;
    mass[226] = n0;
    mass[227] = n0;
    mass[228] = z135;
    mass[229] = z106;
    mass[230] = z153;
    mass[231] = n0;
    mass[232] = n0;
    mass[233] = n0;
    mass[234] = -z180;
    mass[235] = -z181;
    mass[236] = -z182;
    mass[237] = z167;
    mass[238] = z168;
    mass[239] = z151;
    mass[240] = n0;
    mass[241] = n0;
    mass[242] = n0;
    mass[243] = n0;
    mass[244] = n0;
    mass[245] = n0;
    mass[246] = z106;
    mass[247] = z96;
    mass[248] = z101;
    mass[249] = n0;
    mass[250] = n0;
    mass[251] = n0;
    mass[252] = -z169;
    mass[253] = -z171;
    mass[254] = -z172;
    mass[255] = z158;
    mass[256] = z159;
    mass[257] = z149;
    mass[258] = n0;
    mass[259] = n0;
    mass[260] = n0;
    mass[261] = n0;
    mass[262] = n0;
    mass[263] = n0;
    mass[264] = z153;
    mass[265] = z101;
    mass[266] = k4;
    mass[267] = n0;
    mass[268] = n0;
    mass[269] = n0;
    mass[270] = z78;
    mass[271] = z80;
    mass[272] = z81;
    mass[273] = z82;
    mass[274] = z112;
    mass[275] = -z109;
    mass[276] = n0;
    mass[277] = n0;
    mass[278] = n0;
    mass[279] = n0;
    mass[280] = n0;
    mass[281] = n0;
    mass[282] = n0;
    mass[283] = n0;
    mass[284] = n0;
    mass[285] = z79;
    mass[286] = -z45;
    mass[287] = -z41;
    mass[288] = -z63;
    mass[289] = -z64;
    mass[290] = -z66;
    mass[291] = -z62;
    mass[292] = z70;
    mass[293] = -z68;
    mass[294] = n0;
    mass[295] = n0;
    mass[296] = n0;
    mass[297] = n0;
    mass[298] = n0;
    mass[299] = n0;
    mass[300] = n0;
    mass[301] = n0;
    mass[302] = n0;
    mass[303] = -z45;
    mass[304] = z40;
    mass[305] = z25;
    mass[306] = -z57;
    mass[307] = -z58;
    mass[308] = -z59;
    mass[309] = -z56;
    mass[310] = z69;
    mass[311] = -z67;
    mass[312] = n0;
    mass[313] = n0;
    mass[314] = n0;
    mass[315] = n0;
    mass[316] = n0;
    mass[317] = n0;
    mass[318] = n0;
    mass[319] = n0;
    mass[320] = n0;
    mass[321] = -z41;
    mass[322] = z25;
    mass[323] = k4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k6 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k7 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k9 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar k10 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k11 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k12 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k15 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k17 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar k18 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
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
    const Scalar z0 = n2 * q_trunk_attitude_y;
    const Scalar z1 = n2 * q_trunk_attitude_x;
    const Scalar z2 = n2 * q_trunk_attitude_z;
    const Scalar z3 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z4 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z5 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z6 = q_trunk_attitude_y * z0;
    const Scalar z7 = q_trunk_attitude_z * z0;
    const Scalar z8 = q_trunk_attitude_w * z1;
    const Scalar z9 = q_trunk_attitude_x * z1;
    const Scalar z10 = q_trunk_attitude_x * z2;
    const Scalar z11 = q_trunk_attitude_w * z0;
    const Scalar z12 = z7 + z8;
    const Scalar z13 = n1 - z6 - z9;
    const Scalar z14 = z10 - z11;
    const Scalar z15 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z16 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z17 = n9_81 * z12;
    const Scalar z18 = n9_81 * z14;
    const Scalar z19 = z4 + z5;
    const Scalar z20 = z5 + z15;
    const Scalar z21 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z22 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z23 = n9_81 * z13;
    const Scalar z24 = z7 - z8;
    const Scalar z25 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z26 = z10 + z11;
    const Scalar z27 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z28 = q_trunk_attitude_x * z0;
    const Scalar z29 = z23 + n0_2 * z16 + n0_05 * z21;
    const Scalar z30 = z17 + n0_2 * z3 - n0_05 * z20;
    const Scalar z31 = z22 * z22;
    const Scalar z32 = z18 - n0_2 * z19 + n0_05 * z3;
    const Scalar z33 = s_front_left_hip * z29 + c_front_left_hip * z30;
    const Scalar z34 = s_front_left_hip * z30 - c_front_left_hip * z29;
    const Scalar z35 = q_trunk_attitude_z * z2;
    const Scalar z36 = q_trunk_attitude_w * z2;
    const Scalar z37 = n1 - z6 - z35;
    const Scalar z38 = n1 - z35 - z9;
    const Scalar z39 = z28 + z36;
    const Scalar z40 = z28 - z36;
    const Scalar z41 = n0_05 * v_front_left_hip;
    const Scalar z42 = n0_05 * v_front_left_thigh;
    const Scalar z43 = n0_05 * v_front_left_knee;
    const Scalar z44 = n0_05 * v_front_right_hip;
    const Scalar z45 = n0_05 * v_front_right_thigh;
    const Scalar z46 = n0_05 * v_front_right_knee;
    const Scalar z47 = n0_05 * v_rear_left_hip;
    const Scalar z48 = n0_05 * v_rear_left_thigh;
    const Scalar z49 = n0_05 * v_rear_left_knee;
    const Scalar z50 = n0_05 * v_rear_right_hip;
    const Scalar z51 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z52 = n0_05 * v_rear_right_thigh;
    const Scalar z53 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z54 = n0_05 * v_rear_right_knee;
    const Scalar z55 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z56 = z17 + n0_2 * z3 + n0_05 * z20;
    const Scalar z57 = z23 + n0_2 * z16 - n0_05 * z21;
    const Scalar z58 = z18 - n0_2 * z19 - n0_05 * z3;
    const Scalar z59 = z55 * z55;
    const Scalar z60 = s_front_right_hip * z56 - c_front_right_hip * z57;
    const Scalar z61 = s_front_right_hip * z57 + c_front_right_hip * z56;
    const Scalar z62 = v_front_left_hip * z25;  // angular acceleration of front_left_hip_link, y
    const Scalar z63 = v_front_left_hip * z27;  // angular acceleration of front_left_hip_link, z
    const Scalar z64 = z27 * z22;
    const Scalar z65 = z25 * z25;
    const Scalar z66 = z27 * z25;
    const Scalar z67 = v_front_left_thigh + z27;  // angular velocity of front_left_thigh_link, y
    const Scalar z68 = v_front_right_hip * z51;  // angular acceleration of front_right_hip_link, z
    const Scalar z69 = c_front_right_thigh * z55 + s_front_right_thigh * z53;
    const Scalar z70 = s_front_right_thigh * z55 - c_front_right_thigh * z53;
    const Scalar z71 = z65 + z31;
    const Scalar z72 = z63 + z64;
    const Scalar z73 = c_front_left_thigh * z22 + s_front_left_thigh * z25;
    const Scalar z74 = z33 - n0_08 * z71;
    const Scalar z75 = s_front_left_thigh * z22 - c_front_left_thigh * z25;
    const Scalar z76 = s_front_right_thigh * z68;
    const Scalar z77 = v_front_right_thigh * z70 - z76;  // angular acceleration of front_right_thigh_link, x
    const Scalar z78 = z51 * z55;
    const Scalar z79 = z68 + z78;
    const Scalar z80 = c_front_right_thigh * z68;
    const Scalar z81 = v_front_right_thigh * z69 - z80;  // angular acceleration of front_right_thigh_link, z
    const Scalar z82 = s_front_left_thigh * z63;
    const Scalar z83 = c_front_left_thigh * z63;
    const Scalar z84 = v_front_left_thigh * z75 - z82;  // angular acceleration of front_left_thigh_link, x
    const Scalar z85 = v_front_left_thigh * z73 - z83;  // angular acceleration of front_left_thigh_link, z
    const Scalar z86 = v_front_right_thigh + z51;  // angular velocity of front_right_thigh_link, y
    const Scalar z87 = z51 * z53;
    const Scalar z88 = z53 * z53;
    const Scalar z89 = z88 + z59;
    const Scalar z90 = s_front_left_knee * z75 - c_front_left_knee * z73;
    const Scalar z91 = s_front_left_knee * z73 + c_front_left_knee * z75;
    const Scalar z92 = z61 + n0_08 * z89;
    const Scalar z93 = v_front_right_hip * z53;  // angular acceleration of front_right_hip_link, y
    const Scalar z94 = z58 - n0_08 * z79;
    const Scalar z95 = v_front_left_knee + z67;  // angular velocity of front_left_shank_link, y
    const Scalar z96 = z70 * z86;
    const Scalar z97 = z77 + z96;
    const Scalar z98 = z60 - n0_08 * z87;
    const Scalar z99 = z75 * z67;
    const Scalar z100 = z84 + z99;
    const Scalar z101 = z73 * z75;
    const Scalar z102 = z69 * z69;
    const Scalar z103 = z86 * z86;
    const Scalar z104 = s_front_left_knee * z84 - c_front_left_knee * z85;
    const Scalar z105 = s_front_left_knee * z85 + c_front_left_knee * z84;
    const Scalar z106 = v_front_left_knee * z90 + z104;  // angular acceleration of front_left_shank_link, z
    const Scalar z107 = v_front_left_knee * z91 + z105;  // angular acceleration of front_left_shank_link, x
    const Scalar z108 = z32 + n0_08 * z72;
    const Scalar z109 = z102 + z103;
    const Scalar z110 = s_front_right_knee * z70 - c_front_right_knee * z69;
    const Scalar z111 = s_front_right_thigh * z94 - c_front_right_thigh * z98;
    const Scalar z112 = s_front_right_thigh * z98 + c_front_right_thigh * z94;
    const Scalar z113 = z69 * z70;
    const Scalar z114 = z34 + n0_08 * z66;
    const Scalar z115 = s_front_right_knee * z69 + c_front_right_knee * z70;
    const Scalar z116 = z73 * z73;
    const Scalar z117 = z67 * z67;
    const Scalar z118 = z116 + z117;
    const Scalar z119 = z93 - z113;
    const Scalar z120 = z74 - n0_2 * z100;
    const Scalar z121 = s_front_left_thigh * z108 - c_front_left_thigh * z114;
    const Scalar z122 = s_front_left_thigh * z114 + c_front_left_thigh * z108;
    const Scalar z123 = z111 + n0_2 * z109;
    const Scalar z124 = z121 + n0_2 * z118;
    const Scalar z125 = s_front_right_knee * z77 - c_front_right_knee * z81;
    const Scalar z126 = s_front_right_knee * z81 + c_front_right_knee * z77;
    const Scalar z127 = z92 - n0_2 * z97;
    const Scalar z128 = z112 + n0_2 * z119;
    const Scalar z129 = s_front_right_knee * z123 - c_front_right_knee * z128;
    const Scalar z130 = z62 - z101;
    const Scalar z131 = v_front_right_knee * z110 + z125;  // angular acceleration of front_right_shank_link, z
    const Scalar z132 = v_front_right_knee * z115 + z126;  // angular acceleration of front_right_shank_link, x
    const Scalar z133 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z134 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z135 = z17 - n0_2 * z3 - n0_05 * z20;
    const Scalar z136 = z23 - n0_2 * z16 + n0_05 * z21;
    const Scalar z137 = z18 + n0_2 * z19 + n0_05 * z3;
    const Scalar z138 = v_front_right_knee + z86;  // angular velocity of front_right_shank_link, y
    const Scalar z139 = s_rear_left_hip * z135 - c_rear_left_hip * z136;
    const Scalar z140 = s_rear_left_hip * z136 + c_rear_left_hip * z135;
    const Scalar z141 = z122 + n0_2 * z130;
    const Scalar z142 = s_front_left_knee * z124 - c_front_left_knee * z141;
    const Scalar z143 = z17 - n0_2 * z3 + n0_05 * z20;
    const Scalar z144 = z18 + n0_2 * z19 - n0_05 * z3;
    const Scalar z145 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z146 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z147 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z148 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z149 = v_rear_right_hip * z146;  // angular acceleration of rear_right_hip_link, z
    const Scalar z150 = c_rear_right_thigh * z145 + s_rear_right_thigh * z148;
    const Scalar z151 = s_rear_right_thigh * z145 - c_rear_right_thigh * z148;
    const Scalar z152 = s_rear_right_thigh * z149;
    const Scalar z153 = c_rear_left_thigh * z147 + s_rear_left_thigh * z133;
    const Scalar z154 = s_rear_left_thigh * z147 - c_rear_left_thigh * z133;
    const Scalar z155 = z23 - n0_2 * z16 - n0_05 * z21;
    const Scalar z156 = z146 * z145;
    const Scalar z157 = z149 + z156;
    const Scalar z158 = c_rear_right_thigh * z149;
    const Scalar z159 = v_rear_left_hip * z134;  // angular acceleration of rear_left_hip_link, z
    const Scalar z160 = z148 * z148;
    const Scalar z161 = z145 * z145;
    const Scalar z162 = z160 + z161;
    const Scalar z163 = s_rear_left_thigh * z159;
    const Scalar z164 = s_rear_right_hip * z143 - c_rear_right_hip * z155;
    const Scalar z165 = s_rear_right_hip * z155 + c_rear_right_hip * z143;
    const Scalar z166 = v_rear_left_thigh * z154 - z163;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z167 = z165 + n0_08 * z162;
    const Scalar z168 = z146 * z148;
    const Scalar z169 = v_rear_left_thigh + z134;  // angular velocity of rear_left_thigh_link, y
    const Scalar z170 = s_rear_left_knee * z154 - c_rear_left_knee * z153;
    const Scalar z171 = s_rear_left_knee * z153 + c_rear_left_knee * z154;
    const Scalar z172 = z144 - n0_08 * z157;
    const Scalar z173 = z134 * z147;
    const Scalar z174 = z159 + z173;
    const Scalar z175 = c_rear_left_thigh * z159;
    const Scalar z176 = v_rear_left_thigh * z153 - z175;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z177 = z134 * z133;
    const Scalar z178 = v_rear_right_hip * z148;  // angular acceleration of rear_right_hip_link, y
    const Scalar z179 = v_rear_left_hip * z133;  // angular acceleration of rear_left_hip_link, y
    const Scalar z180 = v_rear_right_thigh + z146;  // angular velocity of rear_right_thigh_link, y
    const Scalar z181 = v_rear_left_knee + z169;  // angular velocity of rear_left_shank_link, y
    const Scalar z182 = z164 - n0_08 * z168;
    const Scalar z183 = z133 * z133;
    const Scalar z184 = v_rear_right_thigh * z151 - z152;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z185 = z147 * z147;
    const Scalar z186 = z183 + z185;
    const Scalar z187 = v_rear_right_thigh * z150 - z158;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z188 = z151 * z180;
    const Scalar z189 = z184 + z188;
    const Scalar z190 = z150 * z150;
    const Scalar z191 = z140 - n0_08 * z186;
    const Scalar z192 = z180 * z180;
    const Scalar z193 = s_rear_right_thigh * z172 - c_rear_right_thigh * z182;
    const Scalar z194 = s_rear_right_thigh * z182 + c_rear_right_thigh * z172;
    const Scalar z195 = z150 * z151;
    const Scalar z196 = z137 + n0_08 * z174;
    const Scalar z197 = z190 + z192;
    const Scalar z198 = s_rear_right_knee * z151 - c_rear_right_knee * z150;
    const Scalar z199 = z154 * z169;
    const Scalar z200 = z166 + z199;
    const Scalar z201 = z153 * z154;
    const Scalar z202 = s_rear_left_knee * z166 - c_rear_left_knee * z176;
    const Scalar z203 = s_rear_left_knee * z176 + c_rear_left_knee * z166;
    const Scalar z204 = v_rear_left_knee * z170 + z202;  // angular acceleration of rear_left_shank_link, z
    const Scalar z205 = v_rear_left_knee * z171 + z203;  // angular acceleration of rear_left_shank_link, x
    const Scalar z206 = z178 - z195;
    const Scalar z207 = z139 + n0_08 * z177;
    const Scalar z208 = s_rear_right_knee * z150 + c_rear_right_knee * z151;
    const Scalar z209 = z153 * z153;
    const Scalar z210 = z169 * z169;
    const Scalar z211 = z209 + z210;
    const Scalar z212 = s_rear_left_thigh * z196 - c_rear_left_thigh * z207;
    const Scalar z213 = s_rear_left_thigh * z207 + c_rear_left_thigh * z196;
    const Scalar z214 = z193 + n0_2 * z197;
    const Scalar z215 = z212 + n0_2 * z211;
    const Scalar z216 = s_rear_right_knee * z184 - c_rear_right_knee * z187;
    const Scalar z217 = s_rear_right_knee * z187 + c_rear_right_knee * z184;
    const Scalar z218 = z167 - n0_2 * z189;
    const Scalar z219 = z194 + n0_2 * z206;
    const Scalar z220 = s_rear_right_knee * z214 - c_rear_right_knee * z219;
    const Scalar z221 = z191 - n0_2 * z200;
    const Scalar z222 = z179 - z201;
    const Scalar z223 = v_rear_right_knee * z198 + z216;  // angular acceleration of rear_right_shank_link, z
    const Scalar z224 = v_rear_right_knee * z208 + z217;  // angular acceleration of rear_right_shank_link, x
    const Scalar z225 = v_rear_right_knee + z180;  // angular velocity of rear_right_shank_link, y
    const Scalar z226 = z198 * z208;
    const Scalar z227 = z208 * z225;
    const Scalar z228 = z178 + z226;
    const Scalar z229 = z198 * z198;
    const Scalar z230 = z225 * z225;
    const Scalar z231 = z213 + n0_2 * z222;
    const Scalar z232 = z198 * z225;
    const Scalar z233 = z229 + z230;
    const Scalar z234 = z223 + z232;
    const Scalar z235 = z224 + z227;
    const Scalar z236 = s_rear_left_knee * z215 - c_rear_left_knee * z231;
    const Scalar z237 = z150 * z180;
    const Scalar z238 = z187 + z237;
    const Scalar z239 = k6 * z178 + k7 * z226 - n0_032 * z220;  // moment on rear_right_shank_link, y
    const Scalar z240 = z148 * z145;
    const Scalar z241 = z153 * z169;
    const Scalar z242 = z176 + z241;
    const Scalar z243 = n0_032 * z228;  // force on rear_right_shank_link, x
    const Scalar z244 = n0_032 * z233;  // force on rear_right_shank_link, z
    const Scalar z245 = k9 * z234;  // moment on rear_right_shank_link, z
    const Scalar z246 = n0_032 * z218 - k10 * z235;  // moment on rear_right_shank_link, x
    const Scalar z247 = n0_032 * z235;  // force on rear_right_shank_link, y
    const Scalar z248 = z133 * z147;
    const Scalar z249 = z178 + z240;
    const Scalar z250 = z170 * z171;
    const Scalar z251 = z171 * z181;
    const Scalar z252 = z205 + z251;
    const Scalar z253 = k6 * z179 + k7 * z250 - n0_032 * z236;  // moment on rear_left_shank_link, y
    const Scalar z254 = z179 + z250;
    const Scalar z255 = n0_032 * z254;  // force on rear_left_shank_link, x
    const Scalar z256 = n0_032 * z221 - k10 * z252;  // moment on rear_left_shank_link, x
    const Scalar z257 = n0_032 * z252;  // force on rear_left_shank_link, y
    const Scalar z258 = z170 * z170;
    const Scalar z259 = z170 * z181;
    const Scalar z260 = z204 + z259;
    const Scalar z261 = z181 * z181;
    const Scalar z262 = z258 + z261;
    const Scalar z263 = s_rear_right_knee * z243 - c_rear_right_knee * z244;
    const Scalar z264 = s_rear_right_knee * z244 + c_rear_right_knee * z243;
    // moment on rear_right_thigh_link, y
    const Scalar z265 = k11 * z178 - k12 * z195 + n0_124 * z194 + n0_2 * z264 + z239;
    const Scalar z266 = n0_124 * z197 - z263;  // force on rear_right_thigh_link, z
    const Scalar z267 = n0_124 * z206 + z264;  // force on rear_right_thigh_link, x
    const Scalar z268 = n0_032 * z262;  // force on rear_left_shank_link, z
    const Scalar z269 = k9 * z260;  // moment on rear_left_shank_link, z
    const Scalar z270 = z265 + n0_0002 * z249;  // moment on rear_right_hip_link, y
    const Scalar z271 = z179 + z248;
    const Scalar z272 = s_rear_left_knee * z255 - c_rear_left_knee * z268;
    const Scalar z273 = s_rear_left_knee * z268 + c_rear_left_knee * z255;
    const Scalar z274 = n0_124 * z211 - z272;  // force on rear_left_thigh_link, z
    const Scalar z275 = s_rear_right_knee * z245 - c_rear_right_knee * z246;
    // moment on rear_left_thigh_link, y
    const Scalar z276 = k11 * z179 - k12 * z201 + n0_124 * z213 + n0_2 * z273 + z253;
    const Scalar z277 = c_rear_right_knee * z245 + s_rear_right_knee * z246;
    const Scalar z278 = n0_124 * z167 - k15 * z189 - n0_2 * z247 - z275;  // moment on rear_right_thigh_link, x
    const Scalar z279 = n0_124 * z222 + z273;  // force on rear_left_thigh_link, x
    const Scalar z280 = n0_124 * z189 + z247;  // force on rear_right_thigh_link, y
    const Scalar z281 = z277 - n0_0002 * z238;  // moment on rear_right_thigh_link, z
    const Scalar z282 = n0_1048 * z162 - z280;  // force on rear_right_hip_link, y
    const Scalar z283 = z276 + n0_0002 * z271;  // moment on rear_left_hip_link, y
    const Scalar z284 = z110 * z115;
    const Scalar z285 = s_rear_right_thigh * z266 + c_rear_right_thigh * z267;
    const Scalar z286 = s_rear_right_thigh * z267 - c_rear_right_thigh * z266;
    const Scalar z287 = z115 * z138;
    const Scalar z288 = z93 + z284;
    const Scalar z289 = s_rear_left_knee * z269 - c_rear_left_knee * z256;
    const Scalar z290 = c_rear_left_knee * z269 + s_rear_left_knee * z256;
    const Scalar z291 = n0_124 * z191 - k15 * z200 - n0_2 * z257 - z289;  // moment on rear_left_thigh_link, x
    const Scalar z292 = n0_124 * z200 + z257;  // force on rear_left_thigh_link, y
    const Scalar z293 = z290 - n0_0002 * z242;  // moment on rear_left_thigh_link, z
    const Scalar z294 = n0_1048 * z186 + z292;  // force on rear_left_hip_link, y
    const Scalar z295 = s_rear_left_thigh * z274 + c_rear_left_thigh * z279;
    const Scalar z296 = s_rear_left_thigh * z279 - c_rear_left_thigh * z274;
    const Scalar z297 = s_rear_right_thigh * z278 + c_rear_right_thigh * z281;
    const Scalar z298 = n0_1048 * z144 - k17 * z157 + n0_08 * z285 - z297;  // moment on rear_right_hip_link, z
    const Scalar z299 = n0_1048 * z157 - z285;  // force on rear_right_hip_link, x
    const Scalar z300 = s_rear_right_thigh * z281 - c_rear_right_thigh * z278;
    const Scalar z301 = z132 + z287;
    const Scalar z302 = n0_1048 * z164 - k18 * z168 + n0_08 * z286 - z300;  // moment on rear_right_hip_link, x
    const Scalar z303 = n0_1048 * z168 - z286;  // force on rear_right_hip_link, z
    const Scalar z304 = n0_032 * z288;  // force on front_right_shank_link, x
    const Scalar z305 = n0_032 * z127 - k10 * z301;  // moment on front_right_shank_link, x
    const Scalar z306 = n0_032 * z301;  // force on front_right_shank_link, y
    const Scalar z307 = z110 * z110;
    const Scalar z308 = z110 * z138;
    const Scalar z309 = z131 + z308;
    const Scalar z310 = z138 * z138;
    const Scalar z311 = z307 + z310;
    const Scalar z312 = n0_1048 * z174 + z295;  // force on rear_left_hip_link, x
    const Scalar z313 = s_rear_right_hip * z282 + c_rear_right_hip * z303;
    const Scalar z314 = s_rear_right_hip * z303 - c_rear_right_hip * z282;
    const Scalar z315 = k6 * z93 + k7 * z284 - n0_032 * z129;  // moment on front_right_shank_link, y
    const Scalar z316 = n0_032 * z311;  // force on front_right_shank_link, z
    const Scalar z317 = k9 * z309;  // moment on front_right_shank_link, z
    const Scalar z318 = s_rear_right_hip * z270 - c_rear_right_hip * z298;
    const Scalar z319 = c_rear_right_hip * z270 + s_rear_right_hip * z298;
    const Scalar z320 = z69 * z86;
    const Scalar z321 = z81 + z320;
    const Scalar z322 = z53 * z55;
    const Scalar z323 = z93 + z322;
    const Scalar z324 = z90 * z91;
    const Scalar z325 = z91 * z95;
    const Scalar z326 = z62 + z324;
    const Scalar z327 = s_front_right_knee * z304 - c_front_right_knee * z316;
    const Scalar z328 = s_front_right_knee * z316 + c_front_right_knee * z304;
    // moment on front_right_thigh_link, y
    const Scalar z329 = k11 * z93 - k12 * z113 + n0_124 * z112 + n0_2 * z328 + z315;
    const Scalar z330 = n0_124 * z109 - z327;  // force on front_right_thigh_link, z
    const Scalar z331 = n0_124 * z119 + z328;  // force on front_right_thigh_link, x
    const Scalar z332 = s_front_right_knee * z317 - c_front_right_knee * z305;
    const Scalar z333 = c_front_right_knee * z317 + s_front_right_knee * z305;
    const Scalar z334 = n0_124 * z92 - k15 * z97 - n0_2 * z306 - z332;  // moment on front_right_thigh_link, x
    const Scalar z335 = n0_124 * z97 + z306;  // force on front_right_thigh_link, y
    const Scalar z336 = z333 - n0_0002 * z321;  // moment on front_right_thigh_link, z
    const Scalar z337 = n0_1048 * z89 - z335;  // force on front_right_hip_link, y
    const Scalar z338 = z329 + n0_0002 * z323;  // moment on front_right_hip_link, y
    const Scalar z339 = s_front_right_thigh * z330 + c_front_right_thigh * z331;
    const Scalar z340 = s_front_right_thigh * z331 - c_front_right_thigh * z330;
    const Scalar z341 = n0_1048 * z79 - z339;  // force on front_right_hip_link, x
    const Scalar z342 = n0_1048 * z177 + z296;  // force on rear_left_hip_link, z
    const Scalar z343 = s_rear_left_thigh * z291 + c_rear_left_thigh * z293;
    const Scalar z344 = n0_1048 * z137 + k17 * z174 + n0_08 * z295 + z343;  // moment on rear_left_hip_link, z
    const Scalar z345 = s_rear_left_thigh * z293 - c_rear_left_thigh * z291;
    const Scalar z346 = n0_1048 * z139 + k18 * z177 + n0_08 * z296 + z345;  // moment on rear_left_hip_link, x
    const Scalar z347 = z107 + z325;
    const Scalar z348 = n0_032 * z326;  // force on front_left_shank_link, x
    const Scalar z349 = n0_032 * z120 - k10 * z347;  // moment on front_left_shank_link, x
    const Scalar z350 = n0_032 * z347;  // force on front_left_shank_link, y
    const Scalar z351 = z90 * z90;
    const Scalar z352 = z90 * z95;
    const Scalar z353 = z106 + z352;
    const Scalar z354 = z95 * z95;
    const Scalar z355 = z351 + z354;
    const Scalar z356 = s_front_right_thigh * z334 + c_front_right_thigh * z336;
    const Scalar z357 = n0_1048 * z58 - k17 * z79 + n0_08 * z339 - z356;  // moment on front_right_hip_link, z
    const Scalar z358 = s_front_right_thigh * z336 - c_front_right_thigh * z334;
    const Scalar z359 = n0_1048 * z60 - k18 * z87 + n0_08 * z340 - z358;  // moment on front_right_hip_link, x
    const Scalar z360 = n0_1048 * z87 - z340;  // force on front_right_hip_link, z
    const Scalar z361 = n0_032 * z355;  // force on front_left_shank_link, z
    const Scalar z362 = s_rear_left_hip * z294 + c_rear_left_hip * z342;
    const Scalar z363 = s_rear_left_hip * z342 - c_rear_left_hip * z294;
    const Scalar z364 = k6 * z62 + k7 * z324 - n0_032 * z142;  // moment on front_left_shank_link, y
    const Scalar z365 = k9 * z353;  // moment on front_left_shank_link, z
    const Scalar z366 = s_front_right_hip * z337 + c_front_right_hip * z360;
    const Scalar z367 = s_front_right_hip * z360 - c_front_right_hip * z337;
    const Scalar z368 = s_rear_left_hip * z283 + c_rear_left_hip * z344;
    const Scalar z369 = s_rear_left_hip * z344 - c_rear_left_hip * z283;
    const Scalar z370 = z45 - z329;
    const Scalar z371 = z46 - z315;
    const Scalar z372 = z73 * z67;
    const Scalar z373 = z85 + z372;
    const Scalar z374 = z25 * z22;
    const Scalar z375 = z43 - z364;
    const Scalar z376 = z44 + z359;
    const Scalar z377 = z62 + z374;
    const Scalar z378 = s_front_left_knee * z348 - c_front_left_knee * z361;
    const Scalar z379 = s_front_left_knee * z361 + c_front_left_knee * z348;
    // moment on front_left_thigh_link, y
    const Scalar z380 = k11 * z62 - k12 * z101 + n0_124 * z122 + n0_2 * z379 + z364;
    const Scalar z381 = n0_124 * z118 - z378;  // force on front_left_thigh_link, z
    const Scalar z382 = n0_124 * z130 + z379;  // force on front_left_thigh_link, x
    const Scalar z383 = s_front_left_knee * z365 - c_front_left_knee * z349;
    const Scalar z384 = c_front_left_knee * z365 + s_front_left_knee * z349;
    const Scalar z385 = n0_124 * z74 - k15 * z100 - n0_2 * z350 - z383;  // moment on front_left_thigh_link, x
    const Scalar z386 = n0_124 * z100 + z350;  // force on front_left_thigh_link, y
    const Scalar z387 = z384 - n0_0002 * z373;  // moment on front_left_thigh_link, z
    const Scalar z388 = n0_1048 * z71 + z386;  // force on front_left_hip_link, y
    const Scalar z389 = z42 - z380;
    const Scalar z390 = z380 + n0_0002 * z377;  // moment on front_left_hip_link, y
    const Scalar z391 = s_front_left_thigh * z381 + c_front_left_thigh * z382;
    const Scalar z392 = s_front_left_thigh * z382 - c_front_left_thigh * z381;
    const Scalar z393 = n0_1048 * z72 + z391;  // force on front_left_hip_link, x
    const Scalar z394 = s_front_left_thigh * z385 + c_front_left_thigh * z387;
    const Scalar z395 = n0_1048 * z32 + k17 * z72 + n0_08 * z391 + z394;  // moment on front_left_hip_link, z
    const Scalar z396 = s_front_left_thigh * z387 - c_front_left_thigh * z385;
    const Scalar z397 = n0_1048 * z34 + k18 * z66 + n0_08 * z392 + z396;  // moment on front_left_hip_link, x
    const Scalar z398 = n0_1048 * z66 + z392;  // force on front_left_hip_link, z
    const Scalar z399 = z41 - z397;
    const Scalar z400 = n12_24 * z18 - z299 + z312 - z341 + z393;  // force on trunk, x
    const Scalar z401 = c_front_right_hip * z338 + s_front_right_hip * z357;
    const Scalar z402 = s_front_right_hip * z338 - c_front_right_hip * z357;
    const Scalar z403 = z48 - z276;
    const Scalar z404 = z49 - z253;
    const Scalar z405 = z52 - z265;
    const Scalar z406 = z54 - z239;
    const Scalar z407 = z47 - z346;
    const Scalar z408 = z50 + z302;
    const Scalar z409 = s_front_left_hip * z388 + c_front_left_hip * z398;
    // moment on trunk, x
    const Scalar z410 = n0_0306 * z21 + z302 - z346 + z359 - z397 - n0_05 * (z313 + z362 + z366 + z409);
    const Scalar z411 = s_front_left_hip * z398 - c_front_left_hip * z388;
    const Scalar z412 = n12_24 * z23 + z313 - z362 + z366 - z409;  // force on trunk, z
    const Scalar z413 = n12_24 * z17 - z314 + z363 - z367 + z411;  // force on trunk, y
    const Scalar z414 = z37 * z400 + z26 * z412 + z40 * z413;
    const Scalar z415 = z39 * z400 + z24 * z412 + z38 * z413;
    const Scalar z416 = z14 * z400 + z13 * z412 + z12 * z413;
    const Scalar z417 = s_front_left_hip * z395 - c_front_left_hip * z390;
    // moment on trunk, y
    const Scalar z418 = n0_3254 * z16 + z319 + z401 - z369 - z417 - n0_2 * (z313 - z362 - z366 + z409);
    const Scalar z419 = s_front_left_hip * z390 + c_front_left_hip * z395;
    // moment on trunk, z
    const Scalar z420 = n0_2948 * z3 - z318 - n0_05 * (z299 + z312 + z341 + z393) - z368 - z402 - z419 + n0_2 * (z314
        - z363 - z367 + z411);
    forces.trunk_x = z414;
    forces.trunk_y = z415;
    forces.trunk_z = z416;
    forces.trunk_attitude_omega_x = z410;
    forces.trunk_attitude_omega_y = -z418;
    forces.trunk_attitude_omega_z = z420;
    forces.front_left_hip = z399;
    forces.front_left_thigh = z389;
    forces.front_left_knee = z375;
    forces.front_right_hip = z376;
    forces.front_right_thigh = z370;
    forces.front_right_knee = z371;
    forces.rear_left_hip = z407;
    forces.rear_left_thigh = z403;
    forces.rear_left_knee = z404;
    forces.rear_right_hip = z408;
    forces.rear_right_thigh = z405;
    forces.rear_right_knee = z406;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k6 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k7 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k9 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k10 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k12 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k13 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k15 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k17 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar k18 = traits::constant(0.0084038, 0.0084038f, "42019/5000000");
    const Scalar k19 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_366 = traits::constant(0.366, 0.366f, "183/500");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar n0_3354 = traits::constant(0.3354, 0.3354f, "1677/5000");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
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
    const Scalar z0 = n2 * q_trunk_attitude_y;
    const Scalar z1 = n2 * q_trunk_attitude_z;
    const Scalar z2 = n2 * q_trunk_attitude_x;
    const Scalar z3 = n9_81 + a_trunk_z;
    const Scalar z4 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z5 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z6 = q_trunk_attitude_z * z1;
    const Scalar z7 = q_trunk_attitude_x * z0;
    const Scalar z8 = q_trunk_attitude_w * z1;
    const Scalar z9 = q_trunk_attitude_x * z2;
    const Scalar z10 = q_trunk_attitude_x * z1;
    const Scalar z11 = q_trunk_attitude_w * z0;
    const Scalar z12 = z7 - z8;
    const Scalar z13 = q_trunk_attitude_z * z0;
    const Scalar z14 = q_trunk_attitude_w * z2;
    const Scalar z15 = n1 - z6 - z9;
    const Scalar z16 = z10 + z11;
    const Scalar z17 = q_trunk_attitude_y * z0;
    const Scalar z18 = z13 - z14;
    const Scalar z19 = z7 + z8;
    const Scalar z20 = z13 + z14;
    const Scalar z21 = n1 - z17 - z9;
    const Scalar z22 = z10 - z11;
    const Scalar z23 = a_trunk_x * z12 + a_trunk_y * z15 + z20 * z3;
    const Scalar z24 = a_trunk_attitude_omega_z + z4;
    const Scalar z25 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z26 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z27 = n1 - z17 - z6;
    const Scalar z28 = a_trunk_x * z16 + a_trunk_y * z18 + z21 * z3;
    const Scalar z29 = a_trunk_attitude_omega_y - z5;
    const Scalar z30 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z31 = z25 + z26;
    const Scalar z32 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z33 = z30 + z25;
    const Scalar z34 = a_trunk_y * z19 + z22 * z3 + a_trunk_x * z27;
    const Scalar z35 = a_trunk_attitude_omega_x + z32;
    const Scalar z36 = a_trunk_attitude_omega_z - z4;
    const Scalar z37 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z38 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z39 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z40 = a_trunk_attitude_omega_y * s_front_left_hip - a_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z41 = a_trunk_attitude_omega_x + a_front_left_hip;  // angular acceleration of front_left_hip_link, x
    const Scalar z42 = a_trunk_attitude_omega_y * c_front_left_hip + a_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z43 = z23 + n0_2 * z24 - n0_05 * z31;
    const Scalar z44 = z28 - n0_2 * z29 + n0_05 * z35;
    const Scalar z45 = z34 - n0_2 * z33 - n0_05 * z36;
    const Scalar z46 = s_front_left_hip * z43 - c_front_left_hip * z44;
    const Scalar z47 = s_front_left_hip * z44 + c_front_left_hip * z43;
    const Scalar z48 = z37 * z37;
    const Scalar z49 = n0_05 * v_front_left_hip;
    const Scalar z50 = n0_05 * v_front_left_thigh;
    const Scalar z51 = n0_05 * v_front_left_knee;
    const Scalar z52 = n0_05 * v_front_right_hip;
    const Scalar z53 = n0_05 * v_front_right_thigh;
    const Scalar z54 = n0_05 * v_front_right_knee;
    const Scalar z55 = n0_05 * v_rear_left_hip;
    const Scalar z56 = n0_05 * v_rear_left_thigh;
    const Scalar z57 = n0_05 * v_rear_left_knee;
    const Scalar z58 = n0_05 * v_rear_right_hip;
    const Scalar z59 = n0_05 * v_rear_right_thigh;
    const Scalar z60 = n0_05 * v_rear_right_knee;
    const Scalar z61 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z62 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z63 = a_trunk_attitude_omega_y * s_front_right_hip - a_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z64 = v_front_right_hip * z62 + z63;  // angular acceleration of front_right_hip_link, z
    const Scalar z65 = v_front_left_hip * z39 + z40;  // angular acceleration of front_left_hip_link, z
    const Scalar z66 = v_front_left_hip * z38 - z42;  // angular acceleration of front_left_hip_link, y
    const Scalar z67 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z68 = a_trunk_attitude_omega_x + a_front_right_hip;  // angular acceleration of front_right_hip_link, x
    const Scalar z69 = a_trunk_attitude_omega_y * c_front_right_hip + a_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z70 = v_front_right_hip * z67 - z69;  // angular acceleration of front_right_hip_link, y
    const Scalar z71 = c_front_right_thigh * z61 + s_front_right_thigh * z67;
    const Scalar z72 = z23 + n0_2 * z24 + n0_05 * z31;
    const Scalar z73 = c_front_left_thigh * z37 + s_front_left_thigh * z38;
    const Scalar z74 = s_front_left_thigh * z37 - c_front_left_thigh * z38;
    const Scalar z75 = z28 - n0_2 * z29 - n0_05 * z35;
    const Scalar z76 = z62 * z61;
    const Scalar z77 = z64 + z76;
    const Scalar z78 = z62 * z67;
    const Scalar z79 = z34 - n0_2 * z33 + n0_05 * z36;
    const Scalar z80 = s_front_right_hip * z72 - c_front_right_hip * z75;
    const Scalar z81 = s_front_right_hip * z75 + c_front_right_hip * z72;
    const Scalar z82 = z68 - z78;
    const Scalar z83 = c_front_left_thigh * z41 + s_front_left_thigh * z65;
    const Scalar z84 = v_front_left_thigh * z74 - z83;  // angular acceleration of front_left_thigh_link, x
    const Scalar z85 = z67 * z67;
    const Scalar z86 = z61 * z61;
    const Scalar z87 = z85 + z86;
    const Scalar z88 = v_front_left_thigh + z39;  // angular velocity of front_left_thigh_link, y
    const Scalar z89 = a_front_left_thigh - z66;  // angular acceleration of front_left_thigh_link, y
    const Scalar z90 = s_front_left_knee * z74 - c_front_left_knee * z73;
    const Scalar z91 = s_front_left_knee * z73 + c_front_left_knee * z74;
    const Scalar z92 = z39 * z37;
    const Scalar z93 = z39 * z38;
    const Scalar z94 = z65 + z92;
    const Scalar z95 = s_front_left_thigh * z41 - c_front_left_thigh * z65;
    const Scalar z96 = v_front_left_thigh * z73 + z95;  // angular acceleration of front_left_thigh_link, z
    const Scalar z97 = s_front_right_thigh * z61 - c_front_right_thigh * z67;
    const Scalar z98 = c_front_right_thigh * z68 + s_front_right_thigh * z64;
    const Scalar z99 = v_front_left_knee + z88;  // angular velocity of front_left_shank_link, y
    const Scalar z100 = a_front_left_knee + z89;  // angular acceleration of front_left_shank_link, y
    const Scalar z101 = z41 - z93;
    const Scalar z102 = z38 * z38;
    const Scalar z103 = z102 + z48;
    const Scalar z104 = s_front_right_thigh * z68 - c_front_right_thigh * z64;
    const Scalar z105 = v_front_right_thigh + z62;  // angular velocity of front_right_thigh_link, y
    const Scalar z106 = v_front_right_thigh * z97 - z98;  // angular acceleration of front_right_thigh_link, x
    const Scalar z107 = z81 + n0_08 * z87;
    const Scalar z108 = z47 - n0_08 * z103;
    const Scalar z109 = a_front_right_thigh - z70;  // angular acceleration of front_right_thigh_link, y
    const Scalar z110 = z79 - n0_08 * z77;
    const Scalar z111 = z80 + n0_08 * z82;
    const Scalar z112 = z45 + n0_08 * z94;
    const Scalar z113 = v_front_right_thigh * z71 + z104;  // angular acceleration of front_right_thigh_link, z
    const Scalar z114 = z46 - n0_08 * z101;
    const Scalar z115 = z74 * z88;
    const Scalar z116 = z84 + z115;
    const Scalar z117 = z73 * z74;
    const Scalar z118 = s_front_right_thigh * z111 + c_front_right_thigh * z110;
    const Scalar z119 = s_front_right_thigh * z110 - c_front_right_thigh * z111;
    const Scalar z120 = z71 * z97;
    const Scalar z121 = s_front_left_knee * z84 - c_front_left_knee * z96;
    const Scalar z122 = s_front_left_knee * z96 + c_front_left_knee * z84;
    const Scalar z123 = v_front_left_knee * z90 + z121;  // angular acceleration of front_left_shank_link, z
    const Scalar z124 = v_front_left_knee * z91 + z122;  // angular acceleration of front_left_shank_link, x
    const Scalar z125 = z73 * z73;
    const Scalar z126 = z88 * z88;
    const Scalar z127 = z125 + z126;
    const Scalar z128 = z109 + z120;
    const Scalar z129 = s_front_left_thigh * z114 + c_front_left_thigh * z112;
    const Scalar z130 = s_front_left_thigh * z112 - c_front_left_thigh * z114;
    const Scalar z131 = z130 + n0_2 * z127;
    const Scalar z132 = s_front_right_knee * z97 - c_front_right_knee * z71;
    const Scalar z133 = s_front_right_knee * z71 + c_front_right_knee * z97;
    const Scalar z134 = z97 * z105;
    const Scalar z135 = z106 + z134;
    const Scalar z136 = z71 * z71;
    const Scalar z137 = z105 * z105;
    const Scalar z138 = z136 + z137;
    const Scalar z139 = z108 - n0_2 * z116;
    const Scalar z140 = z89 + z117;
    const Scalar z141 = v_front_right_knee + z105;  // angular velocity of front_right_shank_link, y
    const Scalar z142 = a_front_right_knee + z109;  // angular acceleration of front_right_shank_link, y
    const Scalar z143 = z119 + n0_2 * z138;
    const Scalar z144 = s_front_right_knee * z106 - c_front_right_knee * z113;
    const Scalar z145 = s_front_right_knee * z113 + c_front_right_knee * z106;
    const Scalar z146 = v_front_right_knee * z132 + z144;  // angular acceleration of front_right_shank_link, z
    const Scalar z147 = v_front_right_knee * z133 + z145;  // angular acceleration of front_right_shank_link, x
    const Scalar z148 = z107 - n0_2 * z135;
    const Scalar z149 = z118 - n0_2 * z128;
    const Scalar z150 = s_front_right_knee * z143 - c_front_right_knee * z149;
    const Scalar z151 = z129 - n0_2 * z140;
    const Scalar z152 = s_front_left_knee * z131 - c_front_left_knee * z151;
    const Scalar z153 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z154 = a_trunk_attitude_omega_y * s_rear_right_hip - a_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z155 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z156 = z23 - n0_2 * z24 + n0_05 * z31;
    const Scalar z157 = z23 - n0_2 * z24 - n0_05 * z31;
    const Scalar z158 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z159 = a_trunk_attitude_omega_y * c_rear_right_hip + a_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z160 = z28 + n0_2 * z29 - n0_05 * z35;
    const Scalar z161 = z28 + n0_2 * z29 + n0_05 * z35;
    const Scalar z162 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z163 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z164 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z165 = a_trunk_attitude_omega_y * s_rear_left_hip - a_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z166 = v_rear_left_hip * z163 + z165;  // angular acceleration of rear_left_hip_link, z
    const Scalar z167 = a_trunk_attitude_omega_x + a_rear_left_hip;  // angular acceleration of rear_left_hip_link, x
    const Scalar z168 = z34 + n0_2 * z33 + n0_05 * z36;
    const Scalar z169 = z34 + n0_2 * z33 - n0_05 * z36;
    const Scalar z170 = s_rear_right_hip * z156 - c_rear_right_hip * z160;
    const Scalar z171 = s_rear_right_hip * z160 + c_rear_right_hip * z156;
    const Scalar z172 = a_trunk_attitude_omega_y * c_rear_left_hip + a_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z173 = v_rear_right_hip * z153 + z154;  // angular acceleration of rear_right_hip_link, z
    const Scalar z174 = v_rear_right_hip * z155 - z159;  // angular acceleration of rear_right_hip_link, y
    const Scalar z175 = v_rear_left_hip * z162 - z172;  // angular acceleration of rear_left_hip_link, y
    const Scalar z176 = a_trunk_attitude_omega_x + a_rear_right_hip;  // angular acceleration of rear_right_hip_link, x
    const Scalar z177 = z153 * z164;
    const Scalar z178 = z173 + z177;
    const Scalar z179 = c_rear_left_thigh * z158 + s_rear_left_thigh * z162;
    const Scalar z180 = s_rear_left_thigh * z158 - c_rear_left_thigh * z162;
    const Scalar z181 = c_rear_left_thigh * z167 + s_rear_left_thigh * z166;
    const Scalar z182 = v_rear_left_thigh * z180 - z181;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z183 = v_rear_left_thigh + z163;  // angular velocity of rear_left_thigh_link, y
    const Scalar z184 = a_rear_left_thigh - z175;  // angular acceleration of rear_left_thigh_link, y
    const Scalar z185 = s_rear_left_knee * z180 - c_rear_left_knee * z179;
    const Scalar z186 = s_rear_left_knee * z179 + c_rear_left_knee * z180;
    const Scalar z187 = z163 * z158;
    const Scalar z188 = z163 * z162;
    const Scalar z189 = z166 + z187;
    const Scalar z190 = s_rear_left_thigh * z167 - c_rear_left_thigh * z166;
    const Scalar z191 = v_rear_left_thigh * z179 + z190;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z192 = v_rear_left_knee + z183;  // angular velocity of rear_left_shank_link, y
    const Scalar z193 = a_rear_left_knee + z184;  // angular acceleration of rear_left_shank_link, y
    const Scalar z194 = s_rear_left_hip * z157 - c_rear_left_hip * z161;
    const Scalar z195 = s_rear_left_hip * z161 + c_rear_left_hip * z157;
    const Scalar z196 = c_rear_right_thigh * z164 + s_rear_right_thigh * z155;
    const Scalar z197 = s_rear_right_thigh * z164 - c_rear_right_thigh * z155;
    const Scalar z198 = c_rear_right_thigh * z176 + s_rear_right_thigh * z173;
    const Scalar z199 = z153 * z155;
    const Scalar z200 = z176 - z199;
    const Scalar z201 = z155 * z155;
    const Scalar z202 = z164 * z164;
    const Scalar z203 = z201 + z202;
    const Scalar z204 = z167 - z188;
    const Scalar z205 = z162 * z162;
    const Scalar z206 = s_rear_right_thigh * z176 - c_rear_right_thigh * z173;
    const Scalar z207 = z158 * z158;
    const Scalar z208 = z205 + z207;
    const Scalar z209 = v_rear_right_thigh * z197 - z198;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z210 = v_rear_right_thigh + z153;  // angular velocity of rear_right_thigh_link, y
    const Scalar z211 = z171 + n0_08 * z203;
    const Scalar z212 = z195 - n0_08 * z208;
    const Scalar z213 = a_rear_right_thigh - z174;  // angular acceleration of rear_right_thigh_link, y
    const Scalar z214 = z168 - n0_08 * z178;
    const Scalar z215 = z170 + n0_08 * z200;
    const Scalar z216 = s_rear_right_thigh * z215 + c_rear_right_thigh * z214;
    const Scalar z217 = s_rear_right_thigh * z214 - c_rear_right_thigh * z215;
    const Scalar z218 = z169 + n0_08 * z189;
    const Scalar z219 = v_rear_right_thigh * z196 + z206;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z220 = z196 * z197;
    const Scalar z221 = z194 - n0_08 * z204;
    const Scalar z222 = z213 + z220;
    const Scalar z223 = z180 * z183;
    const Scalar z224 = z182 + z223;
    const Scalar z225 = z179 * z180;
    const Scalar z226 = s_rear_left_knee * z182 - c_rear_left_knee * z191;
    const Scalar z227 = s_rear_left_knee * z191 + c_rear_left_knee * z182;
    const Scalar z228 = v_rear_left_knee * z185 + z226;  // angular acceleration of rear_left_shank_link, z
    const Scalar z229 = v_rear_left_knee * z186 + z227;  // angular acceleration of rear_left_shank_link, x
    const Scalar z230 = z179 * z179;
    const Scalar z231 = z183 * z183;
    const Scalar z232 = z230 + z231;
    const Scalar z233 = s_rear_left_thigh * z221 + c_rear_left_thigh * z218;
    const Scalar z234 = s_rear_left_thigh * z218 - c_rear_left_thigh * z221;
    const Scalar z235 = z234 + n0_2 * z232;
    const Scalar z236 = s_rear_right_knee * z197 - c_rear_right_knee * z196;
    const Scalar z237 = s_rear_right_knee * z196 + c_rear_right_knee * z197;
    const Scalar z238 = z197 * z210;
    const Scalar z239 = z209 + z238;
    const Scalar z240 = z196 * z196;
    const Scalar z241 = z210 * z210;
    const Scalar z242 = z240 + z241;
    const Scalar z243 = z212 - n0_2 * z224;
    const Scalar z244 = z184 + z225;
    const Scalar z245 = v_rear_right_knee + z210;  // angular velocity of rear_right_shank_link, y
    const Scalar z246 = a_rear_right_knee + z213;  // angular acceleration of rear_right_shank_link, y
    const Scalar z247 = z217 + n0_2 * z242;
    const Scalar z248 = s_rear_right_knee * z209 - c_rear_right_knee * z219;
    const Scalar z249 = s_rear_right_knee * z219 + c_rear_right_knee * z209;
    const Scalar z250 = v_rear_right_knee * z236 + z248;  // angular acceleration of rear_right_shank_link, z
    const Scalar z251 = v_rear_right_knee * z237 + z249;  // angular acceleration of rear_right_shank_link, x
    const Scalar z252 = z211 - n0_2 * z239;
    const Scalar z253 = z216 - n0_2 * z222;
    const Scalar z254 = s_rear_right_knee * z247 - c_rear_right_knee * z253;
    const Scalar z255 = z233 - n0_2 * z244;
    const Scalar z256 = s_rear_left_knee * z235 - c_rear_left_knee * z255;
    const Scalar z257 = z196 * z210;
    const Scalar z258 = z219 + z257;
    const Scalar z259 = z155 * z164;
    const Scalar z260 = z174 + z259;
    const Scalar z261 = z236 * z237;
    const Scalar z262 = z237 * z245;
    const Scalar z263 = z251 + z262;
    const Scalar z264 = k6 * z246 - k7 * z261 + n0_032 * z254;  // moment on rear_right_shank_link, y
    const Scalar z265 = z246 - z261;
    const Scalar z266 = z179 * z183;
    const Scalar z267 = z191 + z266;
    const Scalar z268 = n0_032 * z265;  // force on rear_right_shank_link, x
    const Scalar z269 = n0_032 * z252 - k9 * z263;  // moment on rear_right_shank_link, x
    const Scalar z270 = n0_032 * z263;  // force on rear_right_shank_link, y
    const Scalar z271 = z236 * z236;
    const Scalar z272 = z236 * z245;
    const Scalar z273 = z250 + z272;
    const Scalar z274 = z245 * z245;
    const Scalar z275 = z271 + z274;
    const Scalar z276 = z185 * z186;
    const Scalar z277 = z186 * z192;
    const Scalar z278 = z229 + z277;
    const Scalar z279 = k10 * z273;  // moment on rear_right_shank_link, z
    const Scalar z280 = k6 * z193 - k7 * z276 + n0_032 * z256;  // moment on rear_left_shank_link, y
    const Scalar z281 = z193 - z276;
    const Scalar z282 = n0_032 * z275;  // force on rear_right_shank_link, z
    const Scalar z283 = z162 * z158;
    const Scalar z284 = n0_032 * z281;  // force on rear_left_shank_link, x
    const Scalar z285 = n0_032 * z243 - k9 * z278;  // moment on rear_left_shank_link, x
    const Scalar z286 = n0_032 * z278;  // force on rear_left_shank_link, y
    const Scalar z287 = z185 * z185;
    const Scalar z288 = z185 * z192;
    const Scalar z289 = z228 + z288;
    const Scalar z290 = z192 * z192;
    const Scalar z291 = z287 + z290;
    const Scalar z292 = s_rear_right_knee * z268 + c_rear_right_knee * z282;
    const Scalar z293 = s_rear_right_knee * z282 - c_rear_right_knee * z268;
    // moment on rear_right_thigh_link, y
    const Scalar z294 = n0_124 * z216 - k12 * z213 - k13 * z220 + n0_2 * z293 - z264;
    const Scalar z295 = n0_124 * z242 + z292;  // force on rear_right_thigh_link, z
    const Scalar z296 = n0_124 * z222 - z293;  // force on rear_right_thigh_link, x
    const Scalar z297 = z175 + z283;
    const Scalar z298 = n0_032 * z291;  // force on rear_left_shank_link, z
    const Scalar z299 = k10 * z289;  // moment on rear_left_shank_link, z
    const Scalar z300 = z294 + n0_0002 * z260;  // moment on rear_right_hip_link, y
    const Scalar z301 = s_rear_right_knee * z279 - c_rear_right_knee * z269;
    const Scalar z302 = c_rear_right_knee * z279 + s_rear_right_knee * z269;
    const Scalar z303 = n0_124 * z211 - k15 * z239 - n0_2 * z270 - z301;  // moment on rear_right_thigh_link, x
    const Scalar z304 = z302 - n0_0002 * z258;  // moment on rear_right_thigh_link, z
    const Scalar z305 = n0_124 * z239 + z270;  // force on rear_right_thigh_link, y
    const Scalar z306 = n0_1048 * z203 - z305;  // force on rear_right_hip_link, y
    const Scalar z307 = z132 * z133;
    const Scalar z308 = s_rear_left_knee * z284 + c_rear_left_knee * z298;
    const Scalar z309 = s_rear_left_knee * z298 - c_rear_left_knee * z284;
    // moment on rear_left_thigh_link, y
    const Scalar z310 = n0_124 * z233 - k12 * z184 - k13 * z225 + n0_2 * z309 - z280;
    const Scalar z311 = n0_124 * z232 + z308;  // force on rear_left_thigh_link, z
    const Scalar z312 = n0_124 * z244 - z309;  // force on rear_left_thigh_link, x
    const Scalar z313 = s_rear_right_thigh * z295 - c_rear_right_thigh * z296;
    const Scalar z314 = s_rear_right_thigh * z296 + c_rear_right_thigh * z295;
    const Scalar z315 = z133 * z141;
    const Scalar z316 = n0_1048 * z200 - z314;  // force on rear_right_hip_link, z
    const Scalar z317 = z310 + n0_0002 * z297;  // moment on rear_left_hip_link, y
    const Scalar z318 = z142 - z307;
    const Scalar z319 = s_rear_right_thigh * z303 + c_rear_right_thigh * z304;
    const Scalar z320 = n0_1048 * z168 - k17 * z178 + n0_08 * z313 - z319;  // moment on rear_right_hip_link, z
    const Scalar z321 = n0_1048 * z178 - z313;  // force on rear_right_hip_link, x
    const Scalar z322 = s_rear_right_thigh * z304 - c_rear_right_thigh * z303;
    // moment on rear_right_hip_link, x
    const Scalar z323 = n0_1048 * z170 + k18 * z176 - k19 * z199 - n0_08 * z314 - z322;
    const Scalar z324 = z147 + z315;
    const Scalar z325 = n0_032 * z318;  // force on front_right_shank_link, x
    const Scalar z326 = n0_032 * z148 - k9 * z324;  // moment on front_right_shank_link, x
    const Scalar z327 = n0_032 * z324;  // force on front_right_shank_link, y
    const Scalar z328 = z132 * z132;
    const Scalar z329 = z132 * z141;
    const Scalar z330 = z146 + z329;
    const Scalar z331 = z141 * z141;
    const Scalar z332 = z328 + z331;
    const Scalar z333 = s_rear_left_knee * z299 - c_rear_left_knee * z285;
    const Scalar z334 = c_rear_left_knee * z299 + s_rear_left_knee * z285;
    const Scalar z335 = n0_124 * z212 - k15 * z224 - n0_2 * z286 - z333;  // moment on rear_left_thigh_link, x
    const Scalar z336 = n0_124 * z224 + z286;  // force on rear_left_thigh_link, y
    const Scalar z337 = n0_1048 * z208 + z336;  // force on rear_left_hip_link, y
    const Scalar z338 = z334 - n0_0002 * z267;  // moment on rear_left_thigh_link, z
    const Scalar z339 = n0_032 * z332;  // force on front_right_shank_link, z
    const Scalar z340 = s_rear_left_thigh * z311 - c_rear_left_thigh * z312;
    const Scalar z341 = s_rear_left_thigh * z312 + c_rear_left_thigh * z311;
    const Scalar z342 = n0_1048 * z204 + z341;  // force on rear_left_hip_link, z
    const Scalar z343 = n0_1048 * z189 + z340;  // force on rear_left_hip_link, x
    const Scalar z344 = s_rear_right_hip * z300 - c_rear_right_hip * z320;
    const Scalar z345 = c_rear_right_hip * z300 + s_rear_right_hip * z320;
    const Scalar z346 = c_rear_right_hip * z306 + s_rear_right_hip * z316;
    const Scalar z347 = k6 * z142 - k7 * z307 + n0_032 * z150;  // moment on front_right_shank_link, y
    const Scalar z348 = s_rear_right_hip * z306 - c_rear_right_hip * z316;
    const Scalar z349 = z71 * z105;
    const Scalar z350 = z113 + z349;
    const Scalar z351 = z67 * z61;
    const Scalar z352 = z70 + z351;
    const Scalar z353 = k10 * z330;  // moment on front_right_shank_link, z
    const Scalar z354 = z90 * z91;
    const Scalar z355 = z91 * z99;
    const Scalar z356 = z100 - z354;
    const Scalar z357 = s_front_right_knee * z325 + c_front_right_knee * z339;
    const Scalar z358 = s_front_right_knee * z339 - c_front_right_knee * z325;
    // moment on front_right_thigh_link, y
    const Scalar z359 = n0_124 * z118 - k12 * z109 - k13 * z120 + n0_2 * z358 - z347;
    const Scalar z360 = n0_124 * z138 + z357;  // force on front_right_thigh_link, z
    const Scalar z361 = n0_124 * z128 - z358;  // force on front_right_thigh_link, x
    const Scalar z362 = s_front_right_knee * z353 - c_front_right_knee * z326;
    const Scalar z363 = c_front_right_knee * z353 + s_front_right_knee * z326;
    const Scalar z364 = n0_124 * z107 - k15 * z135 - n0_2 * z327 - z362;  // moment on front_right_thigh_link, x
    const Scalar z365 = n0_124 * z135 + z327;  // force on front_right_thigh_link, y
    const Scalar z366 = z363 - n0_0002 * z350;  // moment on front_right_thigh_link, z
    const Scalar z367 = n0_1048 * z87 - z365;  // force on front_right_hip_link, y
    const Scalar z368 = z359 + n0_0002 * z352;  // moment on front_right_hip_link, y
    const Scalar z369 = s_front_right_thigh * z360 - c_front_right_thigh * z361;
    const Scalar z370 = s_front_right_thigh * z361 + c_front_right_thigh * z360;
    const Scalar z371 = n0_1048 * z82 - z370;  // force on front_right_hip_link, z
    const Scalar z372 = n0_1048 * z77 - z369;  // force on front_right_hip_link, x
    const Scalar z373 = s_rear_left_thigh * z335 + c_rear_left_thigh * z338;
    const Scalar z374 = n0_1048 * z169 + k17 * z189 + n0_08 * z340 + z373;  // moment on rear_left_hip_link, z
    const Scalar z375 = s_rear_left_thigh * z338 - c_rear_left_thigh * z335;
    // moment on rear_left_hip_link, x
    const Scalar z376 = n0_1048 * z194 - k18 * z167 + k19 * z188 - n0_08 * z341 + z375;
    const Scalar z377 = z124 + z355;
    const Scalar z378 = n0_032 * z356;  // force on front_left_shank_link, x
    const Scalar z379 = n0_032 * z139 - k9 * z377;  // moment on front_left_shank_link, x
    const Scalar z380 = n0_032 * z377;  // force on front_left_shank_link, y
    const Scalar z381 = z90 * z90;
    const Scalar z382 = z90 * z99;
    const Scalar z383 = z123 + z382;
    const Scalar z384 = z99 * z99;
    const Scalar z385 = z381 + z384;
    const Scalar z386 = s_front_right_thigh * z364 + c_front_right_thigh * z366;
    const Scalar z387 = n0_1048 * z79 - k17 * z77 + n0_08 * z369 - z386;  // moment on front_right_hip_link, z
    const Scalar z388 = s_front_right_thigh * z366 - c_front_right_thigh * z364;
    // moment on front_right_hip_link, x
    const Scalar z389 = n0_1048 * z80 + k18 * z68 - k19 * z78 - n0_08 * z370 - z388;
    const Scalar z390 = n0_032 * z385;  // force on front_left_shank_link, z
    const Scalar z391 = s_rear_left_hip * z337 - c_rear_left_hip * z342;
    const Scalar z392 = c_rear_left_hip * z337 + s_rear_left_hip * z342;
    const Scalar z393 = k6 * z100 - k7 * z354 + n0_032 * z152;  // moment on front_left_shank_link, y
    const Scalar z394 = k10 * z383;  // moment on front_left_shank_link, z
    const Scalar z395 = s_front_right_hip * z367 - c_front_right_hip * z371;
    const Scalar z396 = c_front_right_hip * z367 + s_front_right_hip * z371;
    const Scalar z397 = s_rear_left_hip * z317 + c_rear_left_hip * z374;
    const Scalar z398 = s_rear_left_hip * z374 - c_rear_left_hip * z317;
    const Scalar z399 = z53 - z359;
    const Scalar z400 = z54 + z347;
    const Scalar z401 = z73 * z88;
    const Scalar z402 = z96 + z401;
    const Scalar z403 = z38 * z37;
    const Scalar z404 = z66 + z403;
    const Scalar z405 = z51 + z393;
    const Scalar z406 = z52 + z389;
    const Scalar z407 = s_front_left_knee * z378 + c_front_left_knee * z390;
    const Scalar z408 = s_front_left_knee * z390 - c_front_left_knee * z378;
    // moment on front_left_thigh_link, y
    const Scalar z409 = n0_124 * z129 - k12 * z89 - k13 * z117 + n0_2 * z408 - z393;
    const Scalar z410 = n0_124 * z127 + z407;  // force on front_left_thigh_link, z
    const Scalar z411 = n0_124 * z140 - z408;  // force on front_left_thigh_link, x
    const Scalar z412 = s_front_left_knee * z394 - c_front_left_knee * z379;
    const Scalar z413 = c_front_left_knee * z394 + s_front_left_knee * z379;
    const Scalar z414 = n0_124 * z108 - k15 * z116 - n0_2 * z380 - z412;  // moment on front_left_thigh_link, x
    const Scalar z415 = n0_124 * z116 + z380;  // force on front_left_thigh_link, y
    const Scalar z416 = n0_1048 * z103 + z415;  // force on front_left_hip_link, y
    const Scalar z417 = z413 - n0_0002 * z402;  // moment on front_left_thigh_link, z
    const Scalar z418 = z50 - z409;
    const Scalar z419 = z409 + n0_0002 * z404;  // moment on front_left_hip_link, y
    const Scalar z420 = s_front_left_thigh * z410 - c_front_left_thigh * z411;
    const Scalar z421 = s_front_left_thigh * z411 + c_front_left_thigh * z410;
    const Scalar z422 = n0_1048 * z101 + z421;  // force on front_left_hip_link, z
    const Scalar z423 = n0_1048 * z94 + z420;  // force on front_left_hip_link, x
    const Scalar z424 = s_front_left_thigh * z414 + c_front_left_thigh * z417;
    const Scalar z425 = n0_1048 * z45 + k17 * z94 + n0_08 * z420 + z424;  // moment on front_left_hip_link, z
    const Scalar z426 = s_front_left_thigh * z417 - c_front_left_thigh * z414;
    // moment on front_left_hip_link, x
    const Scalar z427 = n0_1048 * z46 - k18 * z41 + k19 * z93 - n0_08 * z421 + z426;
    const Scalar z428 = z49 - z427;
    const Scalar z429 = n12_24 * z34 - z321 + z343 - z372 + z423;  // force on trunk, x
    const Scalar z430 = c_front_right_hip * z368 + s_front_right_hip * z387;
    const Scalar z431 = s_front_right_hip * z368 - c_front_right_hip * z387;
    const Scalar z432 = z56 - z310;
    const Scalar z433 = z57 + z280;
    const Scalar z434 = z59 - z294;
    const Scalar z435 = z60 + z264;
    const Scalar z436 = z55 - z376;
    const Scalar z437 = z58 + z323;
    const Scalar z438 = s_front_left_hip * z416 - c_front_left_hip * z422;
    // moment on trunk, x
    const Scalar z439 = z323 + n0_0406 * a_trunk_attitude_omega_x + n0_0306 * z32 - z376 + z389 - z427 - n0_05 * (z348
        + z391 + z395 + z438);
    const Scalar z440 = c_front_left_hip * z416 + s_front_left_hip * z422;
    const Scalar z441 = n12_24 * z23 + z346 - z392 + z396 - z440;  // force on trunk, y
    const Scalar z442 = n12_24 * z28 + z348 - z391 + z395 - z438;  // force on trunk, z
    const Scalar z443 = z27 * z429 + z12 * z441 + z16 * z442;
    const Scalar z444 = z19 * z429 + z15 * z441 + z18 * z442;
    const Scalar z445 = z22 * z429 + z20 * z441 + z21 * z442;
    const Scalar z446 = s_front_left_hip * z419 + c_front_left_hip * z425;
    // moment on trunk, z
    const Scalar z447 = n0_366 * a_trunk_attitude_omega_z - z344 + n0_2948 * z4 - n0_05 * (z321 + z343 + z372 + z423)
        - z397 - z431 - z446 - n0_2 * (z346 - z392 - z396 + z440);
    const Scalar z448 = s_front_left_hip * z425 - c_front_left_hip * z419;
    // moment on trunk, y
    const Scalar z449 = n0_3354 * a_trunk_attitude_omega_y - z345 - n0_3254 * z5 - z430 + n0_2 * (z348 - z391 - z395
        + z438) + z398 + z448;
    forces.trunk_x = z443;
    forces.trunk_y = z444;
    forces.trunk_z = z445;
    forces.trunk_attitude_omega_x = z439;
    forces.trunk_attitude_omega_y = z449;
    forces.trunk_attitude_omega_z = z447;
    forces.front_left_hip = z428;
    forces.front_left_thigh = z418;
    forces.front_left_knee = z405;
    forces.front_right_hip = z406;
    forces.front_right_thigh = z399;
    forces.front_right_knee = z400;
    forces.rear_left_hip = z436;
    forces.rear_left_thigh = z432;
    forces.rear_left_knee = z433;
    forces.rear_right_hip = z437;
    forces.rear_right_thigh = z434;
    forces.rear_right_knee = z435;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar k7 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k9 = traits::constant(0.20040707687490214, 0.20040707f, "1280/6387");
    const Scalar k10 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k13 = traits::constant(0.0329736, 0.0329736f, "41217/1250000");
    const Scalar k14 = traits::constant(0.0325736, 0.0325736f, "40717/1250000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar k16 = traits::constant(0.4970944, 0.4970944f, "77671/156250");
    const Scalar k17 = traits::constant(0.4664944, 0.4664944f, "291559/625000");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k20 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar k21 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k22 = traits::constant(6.262721152340692, 6.262721f, "40000/6387");
    const Scalar k23 = traits::constant(195.71003601064663, 195.71004f, "1250000/6387");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k25 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar k26 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
    const Scalar k27 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
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
    const Scalar z0 = k0 * s_rear_right_knee;
    const Scalar z1 = k0 * c_rear_right_knee;
    const Scalar z2 = k0 * s_rear_left_knee;
    const Scalar z3 = n0_032 * c_rear_right_knee;
    const Scalar z4 = k0 * c_rear_left_knee;
    const Scalar z5 = n0_032 * c_rear_left_knee;
    const Scalar z6 = n0_032 * s_rear_right_knee;
    const Scalar z7 = n0_032 * s_rear_left_knee;
    const Scalar z8 = n2 * q_trunk_attitude_y;
    const Scalar z9 = n2 * q_trunk_attitude_x;
    const Scalar z10 = q_trunk_attitude_y * z8;
    const Scalar z11 = n0_032 * c_front_right_knee;
    const Scalar z12 = q_trunk_attitude_z * z8;
    const Scalar z13 = q_trunk_attitude_w * z9;
    const Scalar z14 = n2 * q_trunk_attitude_z;
    const Scalar z15 = n0_032 * s_front_right_knee;
    const Scalar z16 = q_trunk_attitude_x * z9;
    const Scalar z17 = z12 + z13;
    const Scalar z18 = q_trunk_attitude_x * z14;
    const Scalar z19 = q_trunk_attitude_w * z8;
    const Scalar z20 = n1 - z10 - z16;
    const Scalar z21 = z12 - z13;
    const Scalar z22 = z18 - z19;
    const Scalar z23 = z18 + z19;
    const Scalar z24 = q_trunk_attitude_z * z14;
    const Scalar z25 = q_trunk_attitude_x * z8;
    const Scalar z26 = q_trunk_attitude_w * z14;
    const Scalar z27 = n1 - z24 - z16;
    const Scalar z28 = n1 - z10 - z24;
    const Scalar z29 = k0 * s_front_right_knee;
    const Scalar z30 = k0 * c_front_right_knee;
    const Scalar z31 = z25 + z26;
    const Scalar z32 = z25 - z26;
    const Scalar z33 = k0 * s_front_left_knee;
    const Scalar z34 = k0 * c_front_left_knee;
    const Scalar z35 = n0_032 * c_front_left_knee;
    const Scalar z36 = n0_032 * s_front_left_knee;
    const Scalar z37 = c_rear_right_knee * z1;
    const Scalar z38 = s_rear_right_knee * z0;
    const Scalar z39 = s_rear_right_knee * z1;
    const Scalar z40 = n0_124 + z3;
    const Scalar z41 = c_rear_left_knee * z4;
    const Scalar z42 = s_rear_left_knee * z2;
    const Scalar z43 = s_rear_left_knee * z4;
    const Scalar z44 = n0_124 + z5;
    const Scalar z45 = c_front_right_knee * z30;
    const Scalar z46 = s_front_right_knee * z29;
    const Scalar z47 = s_front_right_knee * z30;
    const Scalar z48 = n0_124 + z11;
    const Scalar z49 = c_front_left_knee * z34;
    const Scalar z50 = s_front_left_knee * z33;
    const Scalar z51 = s_front_left_knee * z34;
    const Scalar z52 = n0_4 * z3 - z38;
    const Scalar z53 = n0_2 * z6 + z39;
    const Scalar z54 = n0_124 + z35;
    const Scalar z55 = k7 + z37;
    const Scalar z56 = s_rear_right_thigh * z6 - c_rear_right_thigh * z40;
    const Scalar z57 = c_rear_right_thigh * z6 + s_rear_right_thigh * z40;
    const Scalar z58 = n0_4 * z5 - z42;
    const Scalar z59 = n0_2 * z7 + z43;
    const Scalar z60 = k7 + z41;
    const Scalar z61 = s_rear_left_thigh * z7 - c_rear_left_thigh * z44;
    const Scalar z62 = c_rear_left_thigh * z7 + s_rear_left_thigh * z44;
    const Scalar z63 = n0_4 * z11 - z46;
    const Scalar z64 = n0_2 * z15 + z47;
    const Scalar z65 = k7 + z45;
    const Scalar z66 = s_front_right_thigh * z15 - c_front_right_thigh * z48;
    const Scalar z67 = c_front_right_thigh * z15 + s_front_right_thigh * z48;
    const Scalar z68 = n0_4 * z35 - z50;
    const Scalar z69 = n0_2 * z36 + z51;
    const Scalar z70 = k7 + z49;
    const Scalar z71 = s_front_left_thigh * z36 - c_front_left_thigh * z54;
    const Scalar z72 = c_front_left_thigh * z36 + s_front_left_thigh * z54;
    const Scalar z73 = z52 + z55;
    const Scalar z74 = n2 * z53;
    const Scalar z75 = z58 + z60;
    const Scalar z76 = n2 * z59;
    const Scalar z77 = z63 + z65;
    const Scalar z78 = n2 * z64;
    const Scalar z79 = z68 + z70;
    const Scalar z80 = n2 * z69;
    const Scalar z81 = s_rear_right_thigh * z73 + c_rear_right_thigh * z74;
    const Scalar z82 = s_rear_left_thigh * z75 + c_rear_left_thigh * z76;
    const Scalar z83 = s_front_right_thigh * z77 + c_front_right_thigh * z78;
    const Scalar z84 = s_front_left_thigh * z79 + c_front_left_thigh * z80;
    const Scalar z85 = s_rear_right_thigh * z81;
    const Scalar z86 = c_rear_right_thigh * z81 - z53;
    const Scalar z87 = s_rear_left_thigh * z82;
    const Scalar z88 = c_rear_left_thigh * z82 - z59;
    const Scalar z89 = s_front_right_thigh * z83;
    const Scalar z90 = c_front_right_thigh * z83 - z64;
    const Scalar z91 = s_front_left_thigh * z84;
    const Scalar z92 = z55 - z85;
    const Scalar z93 = z52 - z85;
    const Scalar z94 = c_front_left_thigh * z84 - z69;
    const Scalar z95 = n0_05 * v_rear_right_knee;
    const Scalar z96 = n0_05 * v_rear_left_knee;
    const Scalar z97 = z58 - z87;
    const Scalar z98 = z60 - z87;
    const Scalar z99 = z63 - z89;
    const Scalar z100 = z65 - z89;
    const Scalar z101 = z68 - z91;
    const Scalar z102 = z70 - z91;
    const Scalar z103 = u_rear_right_knee_torque - z95;
    const Scalar z104 = u_rear_left_knee_torque - z96;
    const Scalar z105 = k9 * c_rear_right_knee;
    const Scalar z106 = c_rear_right_knee * z105;
    const Scalar z107 = s_rear_right_knee * z105;
    const Scalar z108 = k9 * s_rear_right_knee;
    const Scalar z109 = s_rear_right_knee * z108;
    const Scalar z110 = n0_05 * v_front_right_knee;
    const Scalar z111 = u_front_right_knee_torque - z110;
    const Scalar z112 = n0_2 * z106;
    const Scalar z113 = n0_2 * z107;
    const Scalar z114 = n0_05 * v_front_left_knee;
    const Scalar z115 = u_front_left_knee_torque - z114;
    const Scalar z116 = n0_05 * v_rear_right_thigh;
    const Scalar z117 = u_rear_right_thigh_torque - z116;
    const Scalar z118 = n0_2 * z112;
    const Scalar z119 = n0_124 - z112;
    const Scalar z120 = n0_05 * v_rear_left_thigh;
    const Scalar z121 = u_rear_left_thigh_torque - z120;
    const Scalar z122 = n0_05 * v_front_right_thigh;
    const Scalar z123 = u_front_right_thigh_torque - z122;
    const Scalar z124 = k10 - z118;
    const Scalar z125 = n0_05 * v_front_left_thigh;
    const Scalar z126 = u_front_left_thigh_torque - z125;
    const Scalar z127 = n0_05 * v_rear_right_hip;
    const Scalar z128 = u_rear_right_hip_torque - z127;
    const Scalar z129 = n0_05 * v_rear_left_hip;
    const Scalar z130 = n1 / z124;
    const Scalar z131 = u_rear_left_hip_torque - z129;
    const Scalar z132 = n0_05 * v_front_right_hip;
    const Scalar z133 = u_front_right_hip_torque - z132;
    const Scalar z134 = n0_05 * v_front_left_hip;
    const Scalar z135 = u_front_left_hip_torque - z134;
    const Scalar z136 = z119 * z130;
    const Scalar z137 = z113 * z130;
    const Scalar z138 = z106 + z119 * z136;
    const Scalar z139 = z107 - z119 * z137;
    const Scalar z140 = z109 + z113 * z137;
    const Scalar z141 = z138 - z140;
    const Scalar z142 = n2 * z139;
    const Scalar z143 = s_rear_right_thigh * z141 + c_rear_right_thigh * z142;
    const Scalar z144 = s_rear_right_thigh * z143;
    const Scalar z145 = c_rear_right_thigh * z143 - z139;
    const Scalar z146 = z140 + z144;
    const Scalar z147 = z138 - z144;
    const Scalar z148 = n0_08 * z145;
    const Scalar z149 = n0_08 * z146;
    const Scalar z150 = n0_08 * z147;
    const Scalar z151 = z86 + n0_08 * z148;
    const Scalar z152 = z93 - n0_08 * z149;
    const Scalar z153 = z92 + n0_08 * z150;
    const Scalar z154 = n0_1048 - z149;
    const Scalar z155 = n0_1048 - z150;
    const Scalar z156 = k13 + z152;
    const Scalar z157 = k9 * c_rear_left_knee;
    const Scalar z158 = k9 * s_rear_left_knee;
    const Scalar z159 = n1 / z156;
    const Scalar z160 = c_rear_left_knee * z157;
    const Scalar z161 = z151 * z159;
    const Scalar z162 = s_rear_left_knee * z158;
    const Scalar z163 = z148 * z159;
    const Scalar z164 = s_rear_left_knee * z157;
    const Scalar z165 = z56 * z159;
    const Scalar z166 = n0_2 * z160;
    const Scalar z167 = z154 * z159;
    const Scalar z168 = n0_2 * z164;
    const Scalar z169 = z147 + z148 * z163;
    const Scalar z170 = n0_2 * z166;
    const Scalar z171 = z148 * z165;
    const Scalar z172 = k10 - z170;
    const Scalar z173 = z56 * z165;
    const Scalar z174 = n0_124 - z166;
    const Scalar z175 = z148 * z161 - z155;
    const Scalar z176 = n1 / z172;
    const Scalar z177 = z145 - z148 * z167;
    const Scalar z178 = z174 * z176;
    const Scalar z179 = z56 * z161 + z57;
    const Scalar z180 = z168 * z176;
    const Scalar z181 = z56 * z167;
    const Scalar z182 = z160 + z174 * z178;
    const Scalar z183 = z148 - z154 * z161;
    const Scalar z184 = z164 - z174 * z180;
    const Scalar z185 = z151 * z161 + z153;
    const Scalar z186 = z162 + z168 * z180;
    const Scalar z187 = z146 + z154 * z167;
    const Scalar z188 = z182 - z186;
    const Scalar z189 = n2 * z181;
    const Scalar z190 = k14 - z185;
    const Scalar z191 = n2 * z184;
    const Scalar z192 = s_rear_right_hip * z175;
    const Scalar z193 = c_rear_right_hip * z175;
    const Scalar z194 = s_rear_right_hip * z183 + c_rear_right_hip * z179;
    const Scalar z195 = z173 - z187;
    const Scalar z196 = c_rear_right_hip * z171 + s_rear_right_hip * z177;
    const Scalar z197 = s_rear_right_hip * z171 - c_rear_right_hip * z177;
    const Scalar z198 = n12_24 - z169;
    const Scalar z199 = s_rear_right_hip * z190;
    const Scalar z200 = s_rear_left_thigh * z188 + c_rear_left_thigh * z191;
    const Scalar z201 = c_rear_right_hip * z189 + s_rear_right_hip * z195;
    const Scalar z202 = s_rear_right_hip * z199;
    const Scalar z203 = s_rear_left_thigh * z200;
    const Scalar z204 = c_rear_right_hip * z199;
    const Scalar z205 = n0_05 * z197;
    const Scalar z206 = z192 - n0_2 * z197;
    const Scalar z207 = n0_05 * z169 + z193 - n0_2 * z196;
    const Scalar z208 = s_rear_right_hip * z194;
    const Scalar z209 = c_rear_right_hip * z194 - z179;
    const Scalar z210 = c_rear_right_hip * z194;
    const Scalar z211 = k14 - z202;
    const Scalar z212 = z186 + z203;
    const Scalar z213 = z185 + z202;
    const Scalar z214 = c_rear_left_thigh * z200 - z184;
    const Scalar z215 = z182 - z203;
    const Scalar z216 = n0_08 * z212;
    const Scalar z217 = n0_08 * z214;
    const Scalar z218 = n0_08 * z215;
    const Scalar z219 = s_rear_right_hip * z201;
    const Scalar z220 = c_rear_right_hip * z201 - z181;
    const Scalar z221 = z183 - z208;
    const Scalar z222 = z88 + n0_08 * z217;
    const Scalar z223 = z97 - n0_08 * z216;
    const Scalar z224 = z98 + n0_08 * z218;
    const Scalar z225 = n0_1048 - z216;
    const Scalar z226 = n0_1048 - z218;
    const Scalar z227 = z173 - z219;
    const Scalar z228 = z187 + z219;
    const Scalar z229 = n0_05 * z220;
    const Scalar z230 = z208 - n0_2 * z220;
    const Scalar z231 = z221 + n0_2 * z220 - z205;
    const Scalar z232 = k13 + z223;
    const Scalar z233 = z210 + n0_05 * z196 - n0_2 * z227;
    const Scalar z234 = z204 - n0_05 * z206 - n0_2 * (z221 - z230);
    const Scalar z235 = z213 + n0_05 * (z193 + z207) - n0_2 * (z210 + z233);
    const Scalar z236 = n1 / z232;
    const Scalar z237 = n0_05 * (z221 - z205) + n0_2 * z229;
    const Scalar z238 = n12_24 - z227;
    const Scalar z239 = k16 - z235;
    const Scalar z240 = z209 + n0_2 * z228;
    const Scalar z241 = n0_2 * (z209 + z240) + z211;
    const Scalar z242 = n0_05 * z228;
    const Scalar z243 = n0_05 * z209 + n0_2 * z242;
    const Scalar z244 = n12_24 - z228;
    const Scalar z245 = z225 * z236;
    const Scalar z246 = z61 * z236;
    const Scalar z247 = z222 * z236;
    const Scalar z248 = z217 * z236;
    const Scalar z249 = n0_05 * z242;
    const Scalar z250 = z222 * z247 + z224;
    const Scalar z251 = z212 + z225 * z245;
    const Scalar z252 = z217 - z225 * z247;
    const Scalar z253 = z217 * z247 - z226;
    const Scalar z254 = z214 - z217 * z245;
    const Scalar z255 = z61 * z247 + z62;
    const Scalar z256 = z215 + z217 * z248;
    const Scalar z257 = z217 * z246;
    const Scalar z258 = k17 - z241;
    const Scalar z259 = n0_0406 - z249;
    const Scalar z260 = z61 * z246;
    const Scalar z261 = z61 * z245;
    const Scalar z262 = z198 - z256;
    const Scalar z263 = k9 * c_front_right_knee;
    const Scalar z264 = k9 * s_front_right_knee;
    const Scalar z265 = z260 - z251;
    const Scalar z266 = n2 * z261;
    const Scalar z267 = c_rear_left_hip * z253;
    const Scalar z268 = s_rear_left_hip * z265 - c_rear_left_hip * z266;
    const Scalar z269 = s_rear_left_hip * z253;
    const Scalar z270 = s_rear_left_hip * z252 - c_rear_left_hip * z255;
    const Scalar z271 = c_rear_left_hip * z270 + z255;
    const Scalar z272 = k14 - z250;
    const Scalar z273 = s_rear_left_hip * z272;
    const Scalar z274 = s_front_right_knee * z264;
    const Scalar z275 = c_front_right_knee * z263;
    const Scalar z276 = c_rear_left_hip * z268 + z261;
    const Scalar z277 = s_rear_left_hip * z268;
    const Scalar z278 = c_rear_left_hip * z270;
    const Scalar z279 = s_rear_left_hip * z270;
    const Scalar z280 = z252 - z279;
    const Scalar z281 = z260 - z277;
    const Scalar z282 = z251 + z277;
    const Scalar z283 = z279 + n0_2 * z276;
    const Scalar z284 = z220 + z276;
    const Scalar z285 = s_rear_left_hip * z254 - c_rear_left_hip * z257;
    const Scalar z286 = s_rear_left_hip * z257 + c_rear_left_hip * z254;
    const Scalar z287 = n0_05 * z256 + z267 + n0_2 * z285;
    const Scalar z288 = z269 - n0_2 * z286;
    const Scalar z289 = z230 - z283;
    const Scalar z290 = z238 - z281;
    const Scalar z291 = z278 + n0_05 * z285 + n0_2 * z281;
    const Scalar z292 = z196 + z285;
    const Scalar z293 = z233 - z291;
    const Scalar z294 = z244 - z282;
    const Scalar z295 = z206 - z288;
    const Scalar z296 = z207 - z287;
    const Scalar z297 = z197 - z286;
    const Scalar z298 = n0_05 * z286;
    const Scalar z299 = z205 + z298;
    const Scalar z300 = s_rear_left_hip * z273;
    const Scalar z301 = s_front_right_knee * z263;
    const Scalar z302 = z250 + z300;
    const Scalar z303 = c_rear_left_hip * z273;
    const Scalar z304 = z303 - n0_05 * z288 + n0_2 * (z280 - z283);
    const Scalar z305 = z302 + n0_05 * (z267 + z287) + n0_2 * (z278 + z291);
    const Scalar z306 = k14 - z300;
    const Scalar z307 = n0_2 * z275;
    const Scalar z308 = n0_2 * z307;
    const Scalar z309 = n0_124 - z307;
    const Scalar z310 = n0_2 * z301;
    const Scalar z311 = z234 + z304;
    const Scalar z312 = z271 - n0_2 * z282;
    const Scalar z313 = z239 - z305;
    const Scalar z314 = k10 - z308;
    const Scalar z315 = z306 - n0_2 * (z271 + z312);
    const Scalar z316 = z240 - z312;
    const Scalar z317 = n1 / z314;
    const Scalar z318 = n0_05 * z282;
    const Scalar z319 = n0_05 * z271 - n0_2 * z318;
    const Scalar z320 = z242 - z318;
    const Scalar z321 = n0_05 * z318;
    const Scalar z322 = n0_05 * z276;
    const Scalar z323 = z258 - z315;
    const Scalar z324 = z259 - z321;
    const Scalar z325 = z243 + z319;
    const Scalar z326 = z298 + z280 - n0_2 * z276;
    const Scalar z327 = n0_05 * (z280 + z298) - n0_2 * z322;
    const Scalar z328 = z237 + z327;
    const Scalar z329 = z229 - z322;
    const Scalar z330 = z231 - z326;
    const Scalar z331 = z309 * z317;
    const Scalar z332 = z310 * z317;
    const Scalar z333 = z275 + z309 * z331;
    const Scalar z334 = z301 - z309 * z332;
    const Scalar z335 = z274 + z310 * z332;
    const Scalar z336 = z333 - z335;
    const Scalar z337 = n2 * z334;
    const Scalar z338 = s_front_right_thigh * z336 + c_front_right_thigh * z337;
    const Scalar z339 = s_front_right_thigh * z338;
    const Scalar z340 = c_front_right_thigh * z338 - z334;
    const Scalar z341 = z335 + z339;
    const Scalar z342 = z333 - z339;
    const Scalar z343 = n0_08 * z340;
    const Scalar z344 = n0_08 * z341;
    const Scalar z345 = n0_08 * z342;
    const Scalar z346 = z90 + n0_08 * z343;
    const Scalar z347 = z99 - n0_08 * z344;
    const Scalar z348 = z100 + n0_08 * z345;
    const Scalar z349 = n0_1048 - z344;
    const Scalar z350 = n0_1048 - z345;
    const Scalar z351 = k13 + z347;
    const Scalar z352 = n1 / z351;
    const Scalar z353 = z346 * z352;
    const Scalar z354 = z343 * z352;
    const Scalar z355 = z66 * z352;
    const Scalar z356 = z349 * z352;
    const Scalar z357 = z342 + z343 * z354;
    const Scalar z358 = z343 * z355;
    const Scalar z359 = z66 * z355;
    const Scalar z360 = z343 * z353 - z350;
    const Scalar z361 = z340 - z343 * z356;
    const Scalar z362 = z66 * z353 + z67;
    const Scalar z363 = z66 * z356;
    const Scalar z364 = z343 - z349 * z353;
    const Scalar z365 = z346 * z353 + z348;
    const Scalar z366 = k9 * s_front_left_knee;
    const Scalar z367 = z341 + z349 * z356;
    const Scalar z368 = k9 * c_front_left_knee;
    const Scalar z369 = n2 * z363;
    const Scalar z370 = k14 - z365;
    const Scalar z371 = c_front_left_knee * z368;
    const Scalar z372 = s_front_right_hip * z360;
    const Scalar z373 = c_front_right_hip * z360;
    const Scalar z374 = s_front_right_hip * z364 + c_front_right_hip * z362;
    const Scalar z375 = z359 - z367;
    const Scalar z376 = c_front_right_hip * z358 + s_front_right_hip * z361;
    const Scalar z377 = s_front_right_hip * z358 - c_front_right_hip * z361;
    const Scalar z378 = z262 - z357;
    const Scalar z379 = s_front_right_hip * z370;
    const Scalar z380 = s_front_left_knee * z366;
    const Scalar z381 = c_front_right_hip * z369 + s_front_right_hip * z375;
    const Scalar z382 = s_front_right_hip * z379;
    const Scalar z383 = s_front_left_knee * z368;
    const Scalar z384 = c_front_right_hip * z379;
    const Scalar z385 = n0_05 * z377;
    const Scalar z386 = z372 + n0_2 * z377;
    const Scalar z387 = n0_05 * z357 + z373 + n0_2 * z376;
    const Scalar z388 = z292 + z376;
    const Scalar z389 = z297 + z377;
    const Scalar z390 = s_front_right_hip * z374;
    const Scalar z391 = c_front_right_hip * z374 - z362;
    const Scalar z392 = c_front_right_hip * z374;
    const Scalar z393 = k14 - z382;
    const Scalar z394 = n0_2 * z371;
    const Scalar z395 = z365 + z382;
    const Scalar z396 = n0_2 * z394;
    const Scalar z397 = n0_124 - z394;
    const Scalar z398 = n0_2 * z383;
    const Scalar z399 = k10 - z396;
    const Scalar z400 = n1 / z399;
    const Scalar z401 = s_front_right_hip * z381;
    const Scalar z402 = c_front_right_hip * z381 - z363;
    const Scalar z403 = z299 + z385;
    const Scalar z404 = z364 - z390;
    const Scalar z405 = z295 + z386;
    const Scalar z406 = z296 + z387;
    const Scalar z407 = z359 - z401;
    const Scalar z408 = z367 + z401;
    const Scalar z409 = n0_05 * z402;
    const Scalar z410 = z390 + n0_2 * z402;
    const Scalar z411 = z404 - n0_2 * z402 - z385;
    const Scalar z412 = z284 + z402;
    const Scalar z413 = z397 * z400;
    const Scalar z414 = z398 * z400;
    const Scalar z415 = n0_05 * z408;
    const Scalar z416 = z391 - n0_2 * z408;
    const Scalar z417 = z392 + n0_05 * z376 + n0_2 * z407;
    const Scalar z418 = z290 - z407;
    const Scalar z419 = z294 - z408;
    const Scalar z420 = n0_05 * (z404 - z385) - n0_2 * z409;
    const Scalar z421 = z329 + z409;
    const Scalar z422 = z384 - n0_05 * z386 + n0_2 * (z404 - z410);
    const Scalar z423 = z289 + z410;
    const Scalar z424 = z380 + z398 * z414;
    const Scalar z425 = z371 + z397 * z413;
    const Scalar z426 = z395 + n0_05 * (z373 + z387) + n0_2 * (z392 + z417);
    const Scalar z427 = z383 - z397 * z414;
    const Scalar z428 = z328 + z420;
    const Scalar z429 = z293 + z417;
    const Scalar z430 = z311 + z422;
    const Scalar z431 = z330 + z411;
    const Scalar z432 = z393 - n0_2 * (z391 + z416);
    const Scalar z433 = z313 - z426;
    const Scalar z434 = z323 - z432;
    const Scalar z435 = z316 + z416;
    const Scalar z436 = n0_05 * z391 - n0_2 * z415;
    const Scalar z437 = z325 + z436;
    const Scalar z438 = z320 + z415;
    const Scalar z439 = n0_05 * z415;
    const Scalar z440 = z324 - z439;
    const Scalar z441 = z425 - z424;
    const Scalar z442 = n2 * z427;
    const Scalar z443 = s_front_left_thigh * z441 + c_front_left_thigh * z442;
    const Scalar z444 = s_front_left_thigh * z443;
    const Scalar z445 = c_front_left_thigh * z443 - z427;
    const Scalar z446 = z424 + z444;
    const Scalar z447 = z425 - z444;
    const Scalar z448 = n0_08 * z445;
    const Scalar z449 = n0_08 * z446;
    const Scalar z450 = n0_08 * z447;
    const Scalar z451 = z94 + n0_08 * z448;
    const Scalar z452 = z101 - n0_08 * z449;
    const Scalar z453 = z102 + n0_08 * z450;
    const Scalar z454 = n0_1048 - z449;
    const Scalar z455 = n0_1048 - z450;
    const Scalar z456 = k13 + z452;
    const Scalar z457 = n1 / z456;
    const Scalar z458 = z451 * z457;
    const Scalar z459 = z448 * z457;
    const Scalar z460 = z71 * z457;
    const Scalar z461 = z454 * z457;
    const Scalar z462 = z447 + z448 * z459;
    const Scalar z463 = z448 * z460;
    const Scalar z464 = z71 * z460;
    const Scalar z465 = z448 * z458 - z455;
    const Scalar z466 = z445 - z448 * z461;
    const Scalar z467 = z71 * z458 + z72;
    const Scalar z468 = z71 * z461;
    const Scalar z469 = z448 - z454 * z458;
    const Scalar z470 = z451 * z458 + z453;
    const Scalar z471 = z446 + z454 * z461;
    const Scalar z472 = n2 * z468;
    const Scalar z473 = k14 - z470;
    const Scalar z474 = s_front_left_hip * z465;
    const Scalar z475 = c_front_left_hip * z465;
    const Scalar z476 = s_front_left_hip * z469 - c_front_left_hip * z467;
    const Scalar z477 = z464 - z471;
    const Scalar z478 = s_front_left_hip * z466 - c_front_left_hip * z463;
    const Scalar z479 = s_front_left_hip * z463 + c_front_left_hip * z466;
    const Scalar z480 = z378 - z462;
    const Scalar z481 = s_front_left_hip * z473;
    const Scalar z482 = s_front_left_hip * z477 - c_front_left_hip * z472;
    const Scalar z483 = s_front_left_hip * z481;
    const Scalar z484 = c_front_left_hip * z481;
    const Scalar z485 = n0_05 * z479;
    const Scalar z486 = z474 + n0_2 * z479;
    const Scalar z487 = z389 - z479;
    const Scalar z488 = s_front_left_hip * z476;
    const Scalar z489 = c_front_left_hip * z476 + z467;
    const Scalar z490 = c_front_left_hip * z476;
    const Scalar z491 = n0_05 * z462 + z475 - n0_2 * z478;
    const Scalar z492 = z388 + z478;
    const Scalar z493 = k14 - z483;
    const Scalar z494 = z470 + z483;
    const Scalar z495 = z403 + z485;
    const Scalar z496 = z469 - z488;
    const Scalar z497 = s_front_left_hip * z482;
    const Scalar z498 = c_front_left_hip * z482 + z468;
    const Scalar z499 = z405 - z486;
    const Scalar z500 = z406 - z491;
    const Scalar z501 = z464 - z497;
    const Scalar z502 = z471 + z497;
    const Scalar z503 = n0_05 * z498;
    const Scalar z504 = z488 - n0_2 * z498;
    const Scalar z505 = z485 + z496 + n0_2 * z498;
    const Scalar z506 = z412 + z498;
    const Scalar z507 = n0_05 * z502;
    const Scalar z508 = z489 + n0_2 * z502;
    const Scalar z509 = z490 + n0_05 * z478 - n0_2 * z501;
    const Scalar z510 = z418 - z501;
    const Scalar z511 = z419 - z502;
    const Scalar z512 = n0_05 * (z496 + z485) + n0_2 * z503;
    const Scalar z513 = z421 - z503;
    const Scalar z514 = z484 - n0_05 * z486 - n0_2 * (z496 - z504);
    const Scalar z515 = z423 - z504;
    const Scalar z516 = n0_05 * z507;
    const Scalar z517 = n0_05 * z489 + n0_2 * z507;
    const Scalar z518 = z438 - z507;
    const Scalar z519 = n0_2 * (z489 + z508) + z493;
    const Scalar z520 = z494 + n0_05 * (z475 + z491) - n0_2 * (z490 + z509);
    const Scalar z521 = z429 - z509;
    const Scalar z522 = z440 - z516;
    const Scalar z523 = z435 - z508;
    const Scalar z524 = z437 + z517;
    const Scalar z525 = z428 + z512;
    const Scalar z526 = z431 - z505;
    const Scalar z527 = z430 + z514;
    const Scalar z528 = z434 - z519;
    const Scalar z529 = z433 - z520;
    const Scalar z530 = n1 / z529;
    const Scalar z531 = z525 * z530;
    const Scalar z532 = z527 * z530;
    const Scalar z533 = z500 * z530;
    const Scalar z534 = z521 * z530;
    const Scalar z535 = z526 * z530;
    const Scalar z536 = z495 - z500 * z531;
    const Scalar z537 = z522 - z525 * z531;
    const Scalar z538 = z500 * z533 - z480;
    const Scalar z539 = z513 - z521 * z531;
    const Scalar z540 = z518 + z526 * z531;
    const Scalar z541 = z499 - z500 * z532;
    const Scalar z542 = n9_81 * z22;
    const Scalar z543 = z524 - z525 * z532;
    const Scalar z544 = n9_81 * z17;
    const Scalar z545 = z500 * z534 + z492;
    const Scalar z546 = n9_81 * z20;
    const Scalar z547 = z515 - z521 * z532;
    const Scalar z548 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z549 = z528 - z527 * z532;
    const Scalar z550 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z551 = z521 * z534 - z510;
    const Scalar z552 = z548 + z550;
    const Scalar z553 = z523 - z526 * z532;
    const Scalar z554 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z555 = z500 * z535 - z487;
    const Scalar z556 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z557 = z521 * z535 - z506;
    const Scalar z558 = z550 + z556;
    const Scalar z559 = z526 * z535 - z511;
    const Scalar z560 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z561 = n1 / z549;
    const Scalar z562 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z563 = z543 * z561;
    const Scalar z564 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z565 = z541 * z561;
    const Scalar z566 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z567 = z547 * z561;
    const Scalar z568 = z542 - n0_2 * z552 + n0_05 * z554;
    const Scalar z569 = z553 * z561;
    const Scalar z570 = z544 + n0_2 * z554 - n0_05 * z558;
    const Scalar z571 = z536 - z541 * z563;
    const Scalar z572 = z546 + n0_2 * z560 + n0_05 * z562;
    const Scalar z573 = z537 - z543 * z563;
    const Scalar z574 = s_front_left_hip * z572 + c_front_left_hip * z570;
    const Scalar z575 = z538 + z541 * z565;
    const Scalar z576 = s_front_left_hip * z570 - c_front_left_hip * z572;
    const Scalar z577 = z539 - z547 * z563;
    const Scalar z578 = z540 + z553 * z563;
    const Scalar z579 = z553 * z569 + z559;
    const Scalar z580 = n1 / z573;
    const Scalar z581 = z547 * z567 + z551;
    const Scalar z582 = z547 * z569 + z557;
    const Scalar z583 = z541 * z567 + z545;
    const Scalar z584 = z541 * z569 + z555;
    const Scalar z585 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z586 = v_front_left_hip * z564;  // angular acceleration of front_left_hip_link, z
    const Scalar z587 = z564 * z585;
    const Scalar z588 = z566 * z566;
    const Scalar z589 = z585 * z585;
    const Scalar z590 = v_front_left_hip * z566;  // angular acceleration of front_left_hip_link, y
    const Scalar z591 = z586 + z587;
    const Scalar z592 = z588 + z589;
    const Scalar z593 = z571 * z580;
    const Scalar z594 = z564 * z566;
    const Scalar z595 = z577 * z580;
    const Scalar z596 = c_front_left_thigh * z585 + s_front_left_thigh * z566;
    const Scalar z597 = z578 * z580;
    const Scalar z598 = s_front_left_thigh * z585 - c_front_left_thigh * z566;
    const Scalar z599 = z571 * z593 + z575;
    const Scalar z600 = s_front_left_thigh * z586;
    const Scalar z601 = z571 * z595 + z583;
    const Scalar z602 = z578 * z597 + z579;
    const Scalar z603 = z571 * z597 - z584;
    const Scalar z604 = c_front_left_thigh * z586;
    const Scalar z605 = z577 * z595 + z581;
    const Scalar z606 = z577 * z597 - z582;
    const Scalar z607 = z574 - n0_08 * z592;
    const Scalar z608 = z568 + n0_08 * z591;
    const Scalar z609 = z576 + n0_08 * z594;
    const Scalar z610 = s_front_left_thigh * z609 + c_front_left_thigh * z608;
    const Scalar z611 = z17 * z605 + z20 * z606 + z22 * z601;
    const Scalar z612 = z17 * z606 + z20 * z602 + z22 * z603;
    const Scalar z613 = z17 * z601 + z20 * z603 + z22 * z599;
    const Scalar z614 = z17 * z611 + z20 * z612 + z22 * z613;
    const Scalar z615 = z31 * z601 + z27 * z605 + z21 * z606;
    const Scalar z616 = z28 * z601 + z32 * z605 + z23 * z606;
    const Scalar z617 = z31 * z599 + z27 * z601 + z21 * z603;
    const Scalar z618 = z28 * z599 + z32 * z601 + z23 * z603;
    const Scalar z619 = s_front_left_thigh * z608 - c_front_left_thigh * z609;
    const Scalar z620 = v_front_left_thigh + z564;  // angular velocity of front_left_thigh_link, y
    const Scalar z621 = n1 / z614;
    const Scalar z622 = z31 * z603 + z27 * z606 + z21 * z602;
    const Scalar z623 = z28 * z603 + z32 * z606 + z23 * z602;
    const Scalar z624 = v_front_left_thigh * z598 - z600;  // angular acceleration of front_left_thigh_link, x
    const Scalar z625 = v_front_left_thigh * z596 - z604;  // angular acceleration of front_left_thigh_link, z
    const Scalar z626 = z596 * z596;
    const Scalar z627 = z620 * z620;
    const Scalar z628 = z596 * z598;
    const Scalar z629 = z598 * z620;
    const Scalar z630 = z624 + z629;
    const Scalar z631 = z17 * z615 + z20 * z622 + z22 * z617;
    const Scalar z632 = z31 * z617 + z27 * z615 + z21 * z622;
    const Scalar z633 = z28 * z617 + z32 * z615 + z23 * z622;
    const Scalar z634 = z631 * z621;
    const Scalar z635 = z632 - z631 * z634;
    const Scalar z636 = z17 * z616 + z20 * z623 + z22 * z618;
    const Scalar z637 = z28 * z618 + z32 * z616 + z23 * z623;
    const Scalar z638 = z626 + z627;
    const Scalar z639 = z636 * z634 - z633;
    const Scalar z640 = n1 / z635;
    const Scalar z641 = z610 - n0_2 * z628;
    const Scalar z642 = s_front_left_knee * z598 - c_front_left_knee * z596;
    const Scalar z643 = s_front_left_knee * z596 + c_front_left_knee * z598;
    const Scalar z644 = s_front_left_knee * z624 - c_front_left_knee * z625;
    const Scalar z645 = s_front_left_knee * z625 + c_front_left_knee * z624;
    const Scalar z646 = z607 - n0_2 * z630;
    const Scalar z647 = z636 * z621;
    const Scalar z648 = z637 - z636 * z647;
    const Scalar z649 = z619 + n0_2 * z638;
    const Scalar z650 = s_front_left_knee * z649 - c_front_left_knee * z641;
    const Scalar z651 = v_front_left_knee * z642 + z644;  // angular acceleration of front_left_shank_link, z
    const Scalar z652 = v_front_left_knee * z643 + z645;  // angular acceleration of front_left_shank_link, x
    const Scalar z653 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z654 = v_front_left_knee + z620;  // angular velocity of front_left_shank_link, y
    const Scalar z655 = z639 * z640;
    const Scalar z656 = z648 - z639 * z655;
    const Scalar z657 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z658 = z542 - n0_2 * z552 - n0_05 * z554;
    const Scalar z659 = n1 / z656;
    const Scalar z660 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z661 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z662 = z544 - n0_2 * z554 - n0_05 * z558;
    const Scalar z663 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z664 = v_rear_left_hip * z660;  // angular acceleration of rear_left_hip_link, z
    const Scalar z665 = z660 * z661;
    const Scalar z666 = z664 + z665;
    const Scalar z667 = z544 + n0_2 * z554 + n0_05 * z558;
    const Scalar z668 = z546 - n0_2 * z560 + n0_05 * z562;
    const Scalar z669 = v_front_right_hip * z653;  // angular acceleration of front_right_hip_link, z
    const Scalar z670 = z653 * z663;
    const Scalar z671 = z669 + z670;
    const Scalar z672 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z673 = z542 + n0_2 * z552 + n0_05 * z554;
    const Scalar z674 = z546 + n0_2 * z560 - n0_05 * z562;
    const Scalar z675 = s_rear_left_hip * z662 - c_rear_left_hip * z668;
    const Scalar z676 = s_rear_left_hip * z668 + c_rear_left_hip * z662;
    const Scalar z677 = z660 * z672;
    const Scalar z678 = c_rear_left_thigh * z661 + s_rear_left_thigh * z672;
    const Scalar z679 = s_front_right_hip * z667 - c_front_right_hip * z674;
    const Scalar z680 = s_front_right_hip * z674 + c_front_right_hip * z667;
    const Scalar z681 = z673 + n0_08 * z666;
    const Scalar z682 = z653 * z657;
    const Scalar z683 = v_front_right_thigh + z653;  // angular velocity of front_right_thigh_link, y
    const Scalar z684 = z658 - n0_08 * z671;
    const Scalar z685 = z675 + n0_08 * z677;
    const Scalar z686 = c_front_right_thigh * z663 + s_front_right_thigh * z657;
    const Scalar z687 = z679 - n0_08 * z682;
    const Scalar z688 = z686 * z686;
    const Scalar z689 = z683 * z683;
    const Scalar z690 = s_rear_left_thigh * z661 - c_rear_left_thigh * z672;
    const Scalar z691 = z688 + z689;
    const Scalar z692 = s_rear_left_thigh * z664;
    const Scalar z693 = c_rear_left_thigh * z664;
    const Scalar z694 = s_front_right_thigh * z663 - c_front_right_thigh * z657;
    const Scalar z695 = s_front_right_thigh * z669;
    const Scalar z696 = c_front_right_thigh * z669;
    const Scalar z697 = v_front_right_thigh * z694 - z695;  // angular acceleration of front_right_thigh_link, x
    const Scalar z698 = v_front_right_thigh * z686 - z696;  // angular acceleration of front_right_thigh_link, z
    const Scalar z699 = s_front_right_thigh * z684 - c_front_right_thigh * z687;
    const Scalar z700 = s_front_right_thigh * z687 + c_front_right_thigh * z684;
    const Scalar z701 = z699 + n0_2 * z691;
    const Scalar z702 = z686 * z694;
    const Scalar z703 = z672 * z672;
    const Scalar z704 = z661 * z661;
    const Scalar z705 = z703 + z704;
    const Scalar z706 = z657 * z657;
    const Scalar z707 = z663 * z663;
    const Scalar z708 = z706 + z707;
    const Scalar z709 = z700 - n0_2 * z702;
    const Scalar z710 = s_front_right_knee * z701 - c_front_right_knee * z709;
    const Scalar z711 = z676 - n0_08 * z705;
    const Scalar z712 = z680 + n0_08 * z708;
    const Scalar z713 = z694 * z683;
    const Scalar z714 = z697 + z713;
    const Scalar z715 = s_front_right_knee * z694 - c_front_right_knee * z686;
    const Scalar z716 = s_front_right_knee * z686 + c_front_right_knee * z694;
    const Scalar z717 = s_front_right_knee * z697 - c_front_right_knee * z698;
    const Scalar z718 = s_front_right_knee * z698 + c_front_right_knee * z697;
    const Scalar z719 = v_front_right_knee * z715 + z717;  // angular acceleration of front_right_shank_link, z
    const Scalar z720 = v_front_right_knee * z716 + z718;  // angular acceleration of front_right_shank_link, x
    const Scalar z721 = v_front_right_knee + z683;  // angular velocity of front_right_shank_link, y
    const Scalar z722 = z712 - n0_2 * z714;
    const Scalar z723 = v_rear_left_hip * z672;  // angular acceleration of rear_left_hip_link, y
    const Scalar z724 = v_front_right_hip * z657;  // angular acceleration of front_right_hip_link, y
    const Scalar z725 = z544 - n0_2 * z554 + n0_05 * z558;
    const Scalar z726 = z542 + n0_2 * z552 - n0_05 * z554;
    const Scalar z727 = v_rear_left_thigh + z660;  // angular velocity of rear_left_thigh_link, y
    const Scalar z728 = v_rear_left_thigh * z690 - z692;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z729 = v_rear_left_thigh * z678 - z693;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z730 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z731 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z732 = v_rear_right_hip * z730;  // angular acceleration of rear_right_hip_link, z
    const Scalar z733 = z730 * z731;
    const Scalar z734 = z546 - n0_2 * z560 - n0_05 * z562;
    const Scalar z735 = z732 + z733;
    const Scalar z736 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z737 = s_rear_right_hip * z725 - c_rear_right_hip * z734;
    const Scalar z738 = s_rear_right_hip * z734 + c_rear_right_hip * z725;
    const Scalar z739 = z730 * z736;
    const Scalar z740 = v_rear_right_thigh + z730;  // angular velocity of rear_right_thigh_link, y
    const Scalar z741 = z726 - n0_08 * z735;
    const Scalar z742 = c_rear_right_thigh * z731 + s_rear_right_thigh * z736;
    const Scalar z743 = z737 - n0_08 * z739;
    const Scalar z744 = z742 * z742;
    const Scalar z745 = z740 * z740;
    const Scalar z746 = s_rear_right_thigh * z731 - c_rear_right_thigh * z736;
    const Scalar z747 = z744 + z745;
    const Scalar z748 = s_rear_right_thigh * z732;
    const Scalar z749 = c_rear_right_thigh * z732;
    const Scalar z750 = v_rear_right_thigh * z746 - z748;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z751 = v_rear_right_thigh * z742 - z749;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z752 = s_rear_right_thigh * z741 - c_rear_right_thigh * z743;
    const Scalar z753 = s_rear_right_thigh * z743 + c_rear_right_thigh * z741;
    const Scalar z754 = z678 * z678;
    const Scalar z755 = z727 * z727;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z742 * z746;
    const Scalar z758 = s_rear_left_thigh * z681 - c_rear_left_thigh * z685;
    const Scalar z759 = s_rear_left_thigh * z685 + c_rear_left_thigh * z681;
    const Scalar z760 = z752 + n0_2 * z747;
    const Scalar z761 = z758 + n0_2 * z756;
    const Scalar z762 = z736 * z736;
    const Scalar z763 = z731 * z731;
    const Scalar z764 = z762 + z763;
    const Scalar z765 = z678 * z690;
    const Scalar z766 = z753 - n0_2 * z757;
    const Scalar z767 = s_rear_right_knee * z760 - c_rear_right_knee * z766;
    const Scalar z768 = z738 + n0_08 * z764;
    const Scalar z769 = z746 * z740;
    const Scalar z770 = z750 + z769;
    const Scalar z771 = z759 - n0_2 * z765;
    const Scalar z772 = s_rear_left_knee * z761 - c_rear_left_knee * z771;
    const Scalar z773 = s_rear_right_knee * z746 - c_rear_right_knee * z742;
    const Scalar z774 = s_rear_right_knee * z742 + c_rear_right_knee * z746;
    const Scalar z775 = s_rear_right_knee * z750 - c_rear_right_knee * z751;
    const Scalar z776 = s_rear_right_knee * z751 + c_rear_right_knee * z750;
    const Scalar z777 = v_rear_right_knee * z774 + z776;  // angular acceleration of rear_right_shank_link, x
    const Scalar z778 = v_rear_right_knee + z740;  // angular velocity of rear_right_shank_link, y
    const Scalar z779 = z690 * z727;
    const Scalar z780 = v_rear_right_knee * z773 + z775;  // angular acceleration of rear_right_shank_link, z
    const Scalar z781 = z728 + z779;
    const Scalar z782 = z773 * z774;
    const Scalar z783 = z774 * z778;
    const Scalar z784 = z777 + z783;
    const Scalar z785 = s_rear_left_knee * z690 - c_rear_left_knee * z678;
    const Scalar z786 = s_rear_left_knee * z678 + c_rear_left_knee * z690;
    const Scalar z787 = s_rear_left_knee * z728 - c_rear_left_knee * z729;
    const Scalar z788 = s_rear_left_knee * z729 + c_rear_left_knee * z728;
    const Scalar z789 = v_rear_left_knee * z785 + z787;  // angular acceleration of rear_left_shank_link, z
    const Scalar z790 = v_rear_left_knee * z786 + z788;  // angular acceleration of rear_left_shank_link, x
    const Scalar z791 = z773 * z778;
    const Scalar z792 = z780 + z791;
    const Scalar z793 = z773 * z773;
    const Scalar z794 = z778 * z778;
    const Scalar z795 = z793 + z794;
    const Scalar z796 = v_rear_left_knee + z727;  // angular velocity of rear_left_shank_link, y
    const Scalar z797 = z768 - n0_2 * z770;
    const Scalar z798 = z711 - n0_2 * z781;
    const Scalar z799 = z742 * z740;
    const Scalar z800 = z751 + z799;
    const Scalar z801 = n0_032 * z767 - k0 * z782;
    const Scalar z802 = n0_032 * z782;
    const Scalar z803 = k20 * z792;
    const Scalar z804 = z103 - z801;
    const Scalar z805 = n0_032 * z795;
    const Scalar z806 = n0_032 * z797 - k21 * z784;
    const Scalar z807 = z802 - k22 * z804;
    const Scalar z808 = n0_032 * z784;
    const Scalar z809 = k23 * z804;
    const Scalar z810 = c_rear_right_knee * z803 + s_rear_right_knee * z806;
    const Scalar z811 = s_rear_right_knee * z803 - c_rear_right_knee * z806;
    const Scalar z812 = s_rear_right_knee * z805 + c_rear_right_knee * z807;
    const Scalar z813 = s_rear_right_knee * z807 - c_rear_right_knee * z805;
    const Scalar z814 = v_rear_right_hip * z736;  // angular acceleration of rear_right_hip_link, y
    const Scalar z815 = z678 * z727;
    const Scalar z816 = z810 - n0_0002 * z800;
    const Scalar z817 = z729 + z815;
    const Scalar z818 = z103 - n0_124 * z753 + k7 * z757 - n0_2 * z812;
    const Scalar z819 = n0_124 * z768 - k25 * z770 - n0_2 * z808 - z811;
    const Scalar z820 = n0_124 * z757 - z812;
    const Scalar z821 = n0_124 * z747 - z813;
    const Scalar z822 = z736 * z731;
    const Scalar z823 = n0_124 * z770 + z808;
    const Scalar z824 = n0_1048 * z764 - z823;
    const Scalar z825 = z117 - z818;
    const Scalar z826 = z136 * z825 + z820;
    const Scalar z827 = z137 * z825 - z821;
    const Scalar z828 = z130 * z825;
    const Scalar z829 = z672 * z661;
    const Scalar z830 = z814 + z822;
    const Scalar z831 = z117 - n0_0002 * z830;
    const Scalar z832 = z785 * z786;
    const Scalar z833 = z786 * z796;
    const Scalar z834 = z790 + z833;
    const Scalar z835 = n0_032 * z772 - k0 * z832;
    const Scalar z836 = n0_032 * z832;
    const Scalar z837 = z785 * z796;
    const Scalar z838 = z789 + z837;
    const Scalar z839 = z785 * z785;
    const Scalar z840 = z796 * z796;
    const Scalar z841 = z839 + z840;
    const Scalar z842 = z104 - z835;
    const Scalar z843 = n0_032 * z798 - k21 * z834;
    const Scalar z844 = k20 * z838;
    const Scalar z845 = n0_032 * z841;
    const Scalar z846 = z836 - k22 * z842;
    const Scalar z847 = n0_032 * z834;
    const Scalar z848 = k23 * z842;
    const Scalar z849 = c_rear_left_knee * z844 + s_rear_left_knee * z843;
    const Scalar z850 = s_rear_left_knee * z844 - c_rear_left_knee * z843;
    const Scalar z851 = s_rear_left_knee * z845 + c_rear_left_knee * z846;
    const Scalar z852 = s_rear_left_knee * z846 - c_rear_left_knee * z845;
    const Scalar z853 = z849 - n0_0002 * z817;
    const Scalar z854 = n0_124 * z711 - k25 * z781 - n0_2 * z847 - z850;
    const Scalar z855 = z104 - n0_124 * z759 + k7 * z765 - n0_2 * z851;
    const Scalar z856 = n0_124 * z765 - z851;
    const Scalar z857 = n0_124 * z756 - z852;
    const Scalar z858 = n0_124 * z781 + z847;
    const Scalar z859 = z121 - z855;
    const Scalar z860 = z178 * z859 + z856;
    const Scalar z861 = z180 * z859 - z857;
    const Scalar z862 = z176 * z859;
    const Scalar z863 = s_rear_right_thigh * z816 - c_rear_right_thigh * z819;
    const Scalar z864 = s_rear_right_thigh * z819 + c_rear_right_thigh * z816;
    const Scalar z865 = s_rear_left_thigh * z853 - c_rear_left_thigh * z854;
    const Scalar z866 = s_rear_left_thigh * z854 + c_rear_left_thigh * z853;
    const Scalar z867 = s_rear_right_thigh * z826 - c_rear_right_thigh * z827;
    const Scalar z868 = s_rear_right_thigh * z827 + c_rear_right_thigh * z826;
    const Scalar z869 = n0_1048 * z737 - z863 - k26 * z739 - n0_08 * z867;
    const Scalar z870 = n0_1048 * z726 - z864 - k27 * z735 - n0_08 * z868;
    const Scalar z871 = n0_1048 * z739 + z867;
    const Scalar z872 = n0_1048 * z705 + z858;
    const Scalar z873 = n0_1048 * z735 + z868;
    const Scalar z874 = z128 - z869;
    const Scalar z875 = z723 + z829;
    const Scalar z876 = z121 - n0_0002 * z875;
    const Scalar z877 = z161 * z874 - z870;
    const Scalar z878 = z165 * z874 - z824;
    const Scalar z879 = z167 * z874 - z871;
    const Scalar z880 = z163 * z874 + z873;
    const Scalar z881 = z159 * z874;
    const Scalar z882 = z715 * z716;
    const Scalar z883 = s_rear_left_thigh * z860 - c_rear_left_thigh * z861;
    const Scalar z884 = s_rear_left_thigh * z861 + c_rear_left_thigh * z860;
    const Scalar z885 = z865 + n0_1048 * z675 + k26 * z677 - n0_08 * z883;
    const Scalar z886 = z866 + n0_1048 * z673 + k27 * z666 - n0_08 * z884;
    const Scalar z887 = n0_1048 * z677 - z883;
    const Scalar z888 = n0_1048 * z666 - z884;
    const Scalar z889 = z131 + z885;
    const Scalar z890 = z247 * z889 + z886;
    const Scalar z891 = z246 * z889 + z872;
    const Scalar z892 = z245 * z889 - z887;
    const Scalar z893 = z248 * z889 + z888;
    const Scalar z894 = z236 * z889;
    const Scalar z895 = s_rear_right_hip * z831 - c_rear_right_hip * z877;
    const Scalar z896 = c_rear_right_hip * z831 + s_rear_right_hip * z877;
    const Scalar z897 = s_rear_left_hip * z876 - c_rear_left_hip * z890;
    const Scalar z898 = c_rear_left_hip * z876 + s_rear_left_hip * z890;
    const Scalar z899 = s_rear_right_hip * z879 - c_rear_right_hip * z878;
    const Scalar z900 = s_rear_right_hip * z878 + c_rear_right_hip * z879;
    const Scalar z901 = z686 * z683;
    const Scalar z902 = z698 + z901;
    const Scalar z903 = z657 * z663;
    const Scalar z904 = z716 * z721;
    const Scalar z905 = z720 + z904;
    const Scalar z906 = n0_032 * z710 - k0 * z882;
    const Scalar z907 = n0_032 * z882;
    const Scalar z908 = z111 - z906;
    const Scalar z909 = n0_032 * z722 - k21 * z905;
    const Scalar z910 = n0_032 * z905;
    const Scalar z911 = z907 - k22 * z908;
    const Scalar z912 = z724 + z903;
    const Scalar z913 = z123 - n0_0002 * z912;
    const Scalar z914 = k23 * z908;
    const Scalar z915 = z715 * z721;
    const Scalar z916 = z719 + z915;
    const Scalar z917 = z715 * z715;
    const Scalar z918 = z721 * z721;
    const Scalar z919 = z917 + z918;
    const Scalar z920 = z642 * z643;
    const Scalar z921 = n0_124 * z714 + z910;
    const Scalar z922 = n0_1048 * z708 - z921;
    const Scalar z923 = k20 * z916;
    const Scalar z924 = n0_032 * z919;
    const Scalar z925 = s_rear_left_hip * z892 + c_rear_left_hip * z891;
    const Scalar z926 = s_rear_left_hip * z891 - c_rear_left_hip * z892;
    const Scalar z927 = z596 * z620;
    const Scalar z928 = z643 * z654;
    const Scalar z929 = z652 + z928;
    const Scalar z930 = n0_032 * z650 - k0 * z920;
    const Scalar z931 = n0_032 * z920;
    const Scalar z932 = z115 - z930;
    const Scalar z933 = n0_032 * z646 - k21 * z929;
    const Scalar z934 = n0_032 * z929;
    const Scalar z935 = z931 - k22 * z932;
    const Scalar z936 = k23 * z932;
    const Scalar z937 = z642 * z654;
    const Scalar z938 = z651 + z937;
    const Scalar z939 = z642 * z642;
    const Scalar z940 = z654 * z654;
    const Scalar z941 = z939 + z940;
    const Scalar z942 = c_front_right_knee * z923 + s_front_right_knee * z909;
    const Scalar z943 = s_front_right_knee * z923 - c_front_right_knee * z909;
    const Scalar z944 = n0_124 * z712 - k25 * z714 - n0_2 * z910 - z943;
    const Scalar z945 = z942 - n0_0002 * z902;
    const Scalar z946 = k20 * z938;
    const Scalar z947 = n0_032 * z941;
    const Scalar z948 = s_front_right_knee * z924 + c_front_right_knee * z911;
    const Scalar z949 = z625 + z927;
    const Scalar z950 = z111 - n0_124 * z700 + k7 * z702 - n0_2 * z948;
    const Scalar z951 = s_front_right_knee * z911 - c_front_right_knee * z924;
    const Scalar z952 = n0_124 * z702 - z948;
    const Scalar z953 = z123 - z950;
    const Scalar z954 = n0_124 * z691 - z951;
    const Scalar z955 = z331 * z953 + z952;
    const Scalar z956 = z317 * z953;
    const Scalar z957 = z332 * z953 - z954;
    const Scalar z958 = z566 * z585;
    const Scalar z959 = c_front_left_knee * z946 + s_front_left_knee * z933;
    const Scalar z960 = s_front_left_knee * z946 - c_front_left_knee * z933;
    const Scalar z961 = z959 - n0_0002 * z949;
    const Scalar z962 = n0_124 * z607 - k25 * z630 - n0_2 * z934 - z960;
    const Scalar z963 = n0_124 * z630 + z934;
    const Scalar z964 = s_front_left_knee * z947 + c_front_left_knee * z935;
    const Scalar z965 = z115 - n0_124 * z610 + k7 * z628 - n0_2 * z964;
    const Scalar z966 = s_front_left_knee * z935 - c_front_left_knee * z947;
    const Scalar z967 = n0_124 * z628 - z964;
    const Scalar z968 = n0_124 * z638 - z966;
    const Scalar z969 = z126 - z965;
    const Scalar z970 = z413 * z969 + z967;
    const Scalar z971 = z400 * z969;
    const Scalar z972 = z414 * z969 - z968;
    const Scalar z973 = s_front_right_thigh * z945 - c_front_right_thigh * z944;
    const Scalar z974 = s_front_right_thigh * z944 + c_front_right_thigh * z945;
    const Scalar z975 = s_front_left_thigh * z961 - c_front_left_thigh * z962;
    const Scalar z976 = s_front_left_thigh * z962 + c_front_left_thigh * z961;
    const Scalar z977 = s_front_right_thigh * z955 - c_front_right_thigh * z957;
    const Scalar z978 = s_front_right_thigh * z957 + c_front_right_thigh * z955;
    const Scalar z979 = n0_1048 * z679 - z973 - k26 * z682 - n0_08 * z977;
    const Scalar z980 = n0_1048 * z658 - z974 - k27 * z671 - n0_08 * z978;
    const Scalar z981 = n0_1048 * z682 + z977;
    const Scalar z982 = n0_1048 * z671 + z978;
    const Scalar z983 = n0_1048 * z592 + z963;
    const Scalar z984 = z133 - z979;
    const Scalar z985 = z590 + z958;
    const Scalar z986 = z126 - n0_0002 * z985;
    const Scalar z987 = z353 * z984 - z980;
    const Scalar z988 = z355 * z984 - z922;
    const Scalar z989 = z356 * z984 - z981;
    const Scalar z990 = z354 * z984 + z982;
    const Scalar z991 = z352 * z984;
    const Scalar z992 = s_front_left_thigh * z970 - c_front_left_thigh * z972;
    const Scalar z993 = s_front_left_thigh * z972 + c_front_left_thigh * z970;
    const Scalar z994 = z975 + n0_1048 * z576 + k26 * z594 - n0_08 * z992;
    const Scalar z995 = z976 + n0_1048 * z568 + k27 * z591 - n0_08 * z993;
    const Scalar z996 = n0_1048 * z594 - z992;
    const Scalar z997 = n0_1048 * z591 - z993;
    const Scalar z998 = z135 + z994;
    const Scalar z999 = z458 * z998 + z995;
    const Scalar z1000 = z460 * z998 + z983;
    const Scalar z1001 = z461 * z998 - z996;
    const Scalar z1002 = z459 * z998 + z997;
    const Scalar z1003 = z457 * z998;
    const Scalar z1004 = n12_24 * z542 - z880 + z893 - z990 + z1002;
    const Scalar z1005 = s_front_right_hip * z913 - c_front_right_hip * z987;
    const Scalar z1006 = c_front_right_hip * z913 + s_front_right_hip * z987;
    const Scalar z1007 = s_front_left_hip * z986 - c_front_left_hip * z999;
    const Scalar z1008 = c_front_left_hip * z986 + s_front_left_hip * z999;
    const Scalar z1009 = s_front_right_hip * z989 - c_front_right_hip * z988;
    const Scalar z1010 = s_front_right_hip * z988 + c_front_right_hip * z989;
    const Scalar z1011 = s_front_left_hip * z1001 + c_front_left_hip * z1000;
    const Scalar z1012 = n0_2948 * z554 + z895 + z897 + z1005 + z1007 - n0_05 * (z880 + z893 + z990 + z1002) - n0_2
        * (z899 - z925 - z1009 + z1011);
    const Scalar z1013 = n12_24 * z544 + z899 - z925 + z1009 - z1011;
    const Scalar z1014 = s_front_left_hip * z1000 - c_front_left_hip * z1001;
    const Scalar z1015 = n0_0306 * z562 + z135 + z133 + z131 + z128 + n0_05 * (z900 - z926 + z1010 - z1014);
    const Scalar z1016 = n0_3254 * z560 - z896 - z898 - z1006 - z1008 + n0_2 * (z900 + z926 - z1010 - z1014);
    const Scalar z1017 = n12_24 * z546 - z900 - z926 - z1010 - z1014;
    const Scalar z1018 = z531 * z1012 + z1015;
    const Scalar z1019 = z532 * z1012 - z1016;
    const Scalar z1020 = z533 * z1012 + z1004;
    const Scalar z1021 = z534 * z1012 + z1013;
    const Scalar z1022 = z535 * z1012 - z1017;
    const Scalar z1023 = z530 * z1012;
    const Scalar z1024 = z563 * z1019 - z1018;
    const Scalar z1025 = z565 * z1019 - z1020;
    const Scalar z1026 = z567 * z1019 - z1021;
    const Scalar z1027 = z569 * z1019 - z1022;
    const Scalar z1028 = z561 * z1019;
    const Scalar z1029 = z593 * z1024 - z1025;
    const Scalar z1030 = z595 * z1024 - z1026;
    const Scalar z1031 = z597 * z1024 + z1027;
    const Scalar z1032 = z580 * z1024;
    const Scalar z1033 = z28 * z1029 + z32 * z1030 + z23 * z1031;
    const Scalar z1034 = z31 * z1029 + z27 * z1030 + z21 * z1031;
    const Scalar z1035 = z17 * z1030 + z20 * z1031 + z22 * z1029;
    const Scalar z1036 = z621 * z1035;
    const Scalar z1037 = z647 * z1035 - z1033;
    const Scalar z1038 = z634 * z1035 - z1034;
    const Scalar z1039 = z640 * z1038;
    const Scalar z1040 = z655 * z1038 + z1037;
    const Scalar z1041 = z659 * z1040;
    const Scalar z1042 = z655 * z1041 + z1039;
    const Scalar z1043 = z1036 + z647 * z1041 + z634 * z1042;
    const Scalar z1044 = z28 * z1041 + z31 * z1042 - z22 * z1043;
    const Scalar z1045 = z32 * z1041 + z27 * z1042 - z17 * z1043;
    const Scalar z1046 = z23 * z1041 + z21 * z1042 - z20 * z1043;
    const Scalar z1047 = z1032 + z593 * z1044 + z595 * z1045 + z597 * z1046;
    const Scalar z1048 = z1028 - z565 * z1044 - z567 * z1045 + z569 * z1046 + z563 * z1047;
    const Scalar z1049 = z535 * z1046 - z1023 - z533 * z1044 - z534 * z1045 + z531 * z1047 - z532 * z1048;
    const Scalar z1050 = z1046 - n0_05 * z1047 - n0_2 * z1048;
    const Scalar z1051 = z1046 + n0_05 * z1047 - n0_2 * z1048;
    const Scalar z1052 = z1046 - n0_05 * z1047 + n0_2 * z1048;
    const Scalar z1053 = z1046 + n0_05 * z1047 + n0_2 * z1048;
    const Scalar z1054 = z1044 + n0_05 * z1049;
    const Scalar z1055 = z1045 - n0_2 * z1049;
    const Scalar z1056 = s_front_left_hip * z1049 - c_front_left_hip * z1048;
    const Scalar z1057 = s_front_left_hip * z1048 + c_front_left_hip * z1049;
    const Scalar z1058 = z1044 - n0_05 * z1049;
    const Scalar z1059 = s_front_right_hip * z1049 - c_front_right_hip * z1048;
    const Scalar z1060 = s_front_right_hip * z1048 + c_front_right_hip * z1049;
    const Scalar z1061 = z1045 + n0_2 * z1049;
    const Scalar z1062 = s_rear_left_hip * z1049 - c_rear_left_hip * z1048;
    const Scalar z1063 = s_rear_left_hip * z1048 + c_rear_left_hip * z1049;
    const Scalar z1064 = s_rear_right_hip * z1048 + c_rear_right_hip * z1049;
    const Scalar z1065 = s_rear_right_hip * z1049 - c_rear_right_hip * z1048;
    const Scalar z1066 = s_front_left_hip * z1050 + c_front_left_hip * z1055;
    const Scalar z1067 = s_front_left_hip * z1055 - c_front_left_hip * z1050;
    const Scalar z1068 = s_front_right_hip * z1051 + c_front_right_hip * z1055;
    const Scalar z1069 = s_front_right_hip * z1055 - c_front_right_hip * z1051;
    const Scalar z1070 = z1003 + z458 * z1057 + z459 * z1054 - z460 * z1066 - z461 * z1067;
    const Scalar z1071 = z991 + z353 * z1060 - z354 * z1058 - z355 * z1068 + z356 * z1069;
    const Scalar z1072 = z1054 + n0_08 * z1057;
    const Scalar z1073 = z1058 - n0_08 * z1060;
    const Scalar z1074 = z1067 + n0_08 * z1070;
    const Scalar z1075 = z1047 - z1070;
    const Scalar z1076 = z1069 - n0_08 * z1071;
    const Scalar z1077 = z1047 - z1071;
    const Scalar z1078 = s_rear_left_hip * z1052 + c_rear_left_hip * z1061;
    const Scalar z1079 = s_rear_left_hip * z1061 - c_rear_left_hip * z1052;
    const Scalar z1080 = z894 + z247 * z1063 + z248 * z1054 - z246 * z1078 - z245 * z1079;
    const Scalar z1081 = z1054 + n0_08 * z1063;
    const Scalar z1082 = s_rear_right_hip * z1053 + c_rear_right_hip * z1061;
    const Scalar z1083 = s_rear_right_hip * z1061 - c_rear_right_hip * z1053;
    const Scalar z1084 = z881 + z161 * z1064 - z163 * z1058 - z165 * z1082 + z167 * z1083;
    const Scalar z1085 = z1058 - n0_08 * z1064;
    const Scalar z1086 = z1079 + n0_08 * z1080;
    const Scalar z1087 = z1047 - z1080;
    const Scalar z1088 = z1047 - z1084;
    const Scalar z1089 = z1083 - n0_08 * z1084;
    const Scalar z1090 = c_front_left_thigh * z1072 + s_front_left_thigh * z1074;
    const Scalar z1091 = s_front_left_thigh * z1072 - c_front_left_thigh * z1074;
    const Scalar z1092 = z413 * z1090 - z971 + z414 * z1091;
    const Scalar z1093 = c_front_right_thigh * z1073 + s_front_right_thigh * z1076;
    const Scalar z1094 = s_front_right_thigh * z1073 - c_front_right_thigh * z1076;
    const Scalar z1095 = z331 * z1093 - z956 + z332 * z1094;
    const Scalar z1096 = z1090 - n0_2 * z1092;
    const Scalar z1097 = z1056 + z1092;
    const Scalar z1098 = c_rear_left_thigh * z1081 + s_rear_left_thigh * z1086;
    const Scalar z1099 = z590 - z1097;  // acceleration of joint front_left_thigh_link
    const Scalar z1100 = s_rear_left_thigh * z1081 - c_rear_left_thigh * z1086;
    const Scalar z1101 = z178 * z1098 - z862 + z180 * z1100;
    const Scalar z1102 = s_front_left_knee * z1091 - c_front_left_knee * z1096;
    const Scalar z1103 = z936 + k22 * z1102;
    const Scalar z1104 = z1093 - n0_2 * z1095;
    const Scalar z1105 = s_front_right_knee * z1094 - c_front_right_knee * z1104;
    const Scalar z1106 = z1098 - n0_2 * z1101;
    const Scalar z1107 = z1092 + z1103;
    const Scalar z1108 = c_rear_right_thigh * z1085 + s_rear_right_thigh * z1089;
    const Scalar z1109 = s_rear_right_thigh * z1085 - c_rear_right_thigh * z1089;
    const Scalar z1110 = z136 * z1108 - z828 + z137 * z1109;
    const Scalar z1111 = s_rear_left_knee * z1100 - c_rear_left_knee * z1106;
    const Scalar z1112 = z1059 + z1095;
    const Scalar z1113 = z914 + k22 * z1105;
    const Scalar z1114 = z1062 + z1101;
    const Scalar z1115 = z848 + k22 * z1111;
    const Scalar z1116 = z1108 - n0_2 * z1110;
    const Scalar z1117 = z1065 + z1110;
    const Scalar z1118 = z724 - z1112;  // acceleration of joint front_right_thigh_link
    const Scalar z1119 = z1095 + z1113;
    const Scalar z1120 = z723 - z1114;  // acceleration of joint rear_left_thigh_link
    const Scalar z1121 = z1101 + z1115;
    const Scalar z1122 = z814 - z1117;  // acceleration of joint rear_right_thigh_link
    const Scalar z1123 = s_rear_right_knee * z1109 - c_rear_right_knee * z1116;
    const Scalar z1124 = z809 + k22 * z1123;
    const Scalar z1125 = z1110 + z1124;
    accelerations.trunk_x = -z1041;
    accelerations.trunk_y = -z1042;
    accelerations.trunk_z = z1043;
    accelerations.trunk_attitude_omega_x = z1047;
    accelerations.trunk_attitude_omega_y = -z1048;
    accelerations.trunk_attitude_omega_z = z1049;
    accelerations.front_left_hip = -z1075;
    accelerations.front_left_thigh = z1099;
    accelerations.front_left_knee = z1107;
    accelerations.front_right_hip = -z1077;
    accelerations.front_right_thigh = z1118;
    accelerations.front_right_knee = z1119;
    accelerations.rear_left_hip = -z1087;
    accelerations.rear_left_thigh = z1120;
    accelerations.rear_left_knee = z1121;
    accelerations.rear_right_hip = -z1088;
    accelerations.rear_right_thigh = z1122;
    accelerations.rear_right_knee = z1125;
    if (!(traits::regular(z124, z124) && traits::regular(z156, z156) && traits::regular(z172, z172)
        && traits::regular(z232, z232) && traits::regular(z314, z314) && traits::regular(z351, z351)
        && traits::regular(z399, z399) && traits::regular(z456, z456) && traits::regular(z529, z529)
        && traits::regular(z549, z549) && traits::regular(z573, z573) && traits::regular(-z614, -z614)
        && traits::regular(-z635, -z635) && traits::regular(-z656, -z656))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * accelerations.trunk_x * accelerations.trunk_y * accelerations.trunk_z
        * accelerations.trunk_attitude_omega_x * accelerations.trunk_attitude_omega_y
        * accelerations.trunk_attitude_omega_z * accelerations.front_left_hip * accelerations.front_left_thigh
        * accelerations.front_left_knee) * (n0 * accelerations.front_right_hip * accelerations.front_right_thigh
        * accelerations.front_right_knee * accelerations.rear_left_hip * accelerations.rear_left_thigh
        * accelerations.rear_left_knee * accelerations.rear_right_hip * accelerations.rear_right_thigh
        * accelerations.rear_right_knee);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_0014 = traits::constant(0.0014, 0.0014f, "7/5000");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k10 = traits::constant(0.00928, 0.00928f, "29/3125");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n0_26 = traits::constant(0.26, 0.26f, "13/50");
    const Scalar k13 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_0125 = traits::constant(0.0125, 0.0125f, "1/80");
    const Scalar n0_0425 = traits::constant(0.0425, 0.0425f, "17/400");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar k19 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_13 = traits::constant(0.13, 0.13f, "13/100");
    const Scalar n58_86 = traits::constant(58.86, 58.86f, "2943/50");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n2_5506 = traits::constant(2.5506, 2.5506f, "12753/5000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
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
    const Scalar z0 = q_front_left_thigh + q_front_left_knee;
    const Scalar z1 = q_front_right_thigh + q_front_right_knee;
    const Scalar z2 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z3 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z0, z1, z2, z3};
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
    const Scalar z4 = sines_[12], z5 = cosines_[12];
    const Scalar z6 = sines_[13], z7 = cosines_[13];
    const Scalar z8 = sines_[14], z9 = cosines_[14];
    const Scalar z10 = sines_[15], z11 = cosines_[15];
    const Scalar z12 = n2 * q_trunk_attitude_y;
    const Scalar z13 = n2 * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_x;
    const Scalar z15 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z16 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z17 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z18 = q_trunk_attitude_x * z13;
    const Scalar z19 = q_trunk_attitude_w * z12;
    const Scalar z20 = q_trunk_attitude_z * z13;
    const Scalar z21 = q_trunk_attitude_x * z12;
    const Scalar z22 = q_trunk_attitude_w * z13;
    const Scalar z23 = q_trunk_attitude_z * z12;
    const Scalar z24 = q_trunk_attitude_w * z14;
    const Scalar z25 = z18 + z19;
    const Scalar z26 = q_trunk_attitude_y * z12;
    const Scalar z27 = z21 - z22;
    const Scalar z28 = q_trunk_attitude_x * z14;
    const Scalar z29 = z23 - z24;
    const Scalar z30 = n1 - z20 - z28;
    const Scalar z31 = n1 - z26 - z28;
    const Scalar z32 = z23 + z24;
    const Scalar z33 = z21 + z22;
    const Scalar z34 = v_trunk_x * z27 + v_trunk_y * z30 + v_trunk_z * z32;
    const Scalar z35 = v_trunk_x * z25 + v_trunk_y * z29 + v_trunk_z * z31;
    const Scalar z36 = z18 - z19;
    const Scalar z37 = n1 - z26 - z20;
    const Scalar z38 = v_trunk_y * z33 + v_trunk_z * z36 + v_trunk_x * z37;
    const Scalar z39 = n0_2 * v_trunk_attitude_omega_z + z34;
    const Scalar z40 = n0_2 * v_trunk_attitude_omega_z - z34;
    const Scalar z41 = z35 + n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z42 = n0_05 * v_trunk_attitude_omega_x - z35 + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z43 = z35 + n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z44 = s_front_left_hip * z39 - c_front_left_hip * z41;
    const Scalar z45 = s_front_right_hip * z39 + c_front_right_hip * z42;
    const Scalar z46 = s_rear_left_hip * z40 + c_rear_left_hip * z43;
    const Scalar z47 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z48 = z38 - z15;
    const Scalar z49 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z50 = z38 + z15;
    const Scalar z51 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z52 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z53 = s_front_left_hip * z41 + c_front_left_hip * z39;
    const Scalar z54 = s_front_right_hip * z42 - c_front_right_hip * z39;
    const Scalar z55 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z56 = n0_05 * v_trunk_attitude_omega_x - z35 - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z57 = s_rear_left_hip * z43 - c_rear_left_hip * z40;
    const Scalar z58 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z59 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z60 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z61 = v_front_left_thigh + z55;  // angular velocity of front_left_thigh_link, y
    const Scalar z62 = v_front_right_thigh + z59;  // angular velocity of front_right_thigh_link, y
    const Scalar z63 = v_rear_left_thigh + z60;  // angular velocity of rear_left_thigh_link, y
    const Scalar z64 = z44 - n0_08 * z16;
    const Scalar z65 = z45 + n0_08 * z17;
    const Scalar z66 = z46 + n0_08 * z47;
    const Scalar z67 = z48 + n0_08 * z49;
    const Scalar z68 = s_rear_right_hip * z40 - c_rear_right_hip * z56;
    const Scalar z69 = s_rear_right_hip * z56 + c_rear_right_hip * z40;
    const Scalar z70 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z71 = z50 - n0_08 * z51;
    const Scalar z72 = z48 + n0_08 * z52;
    const Scalar z73 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z74 = s_front_left_thigh * z64 + c_front_left_thigh * z67;
    const Scalar z75 = s_front_left_thigh * z67 - c_front_left_thigh * z64;
    const Scalar z76 = s_front_right_thigh * z65 + c_front_right_thigh * z71;
    const Scalar z77 = s_front_right_thigh * z71 - c_front_right_thigh * z65;
    const Scalar z78 = s_rear_left_thigh * z66 - c_rear_left_thigh * z72;
    const Scalar z79 = s_rear_left_thigh * z72 + c_rear_left_thigh * z66;
    const Scalar z80 = c_front_left_thigh * z16 + s_front_left_thigh * z49;
    const Scalar z81 = z50 - n0_08 * z58;
    const Scalar z82 = s_front_left_thigh * z16 - c_front_left_thigh * z49;
    const Scalar z83 = s_front_left_knee * z80 + c_front_left_knee * z82;
    const Scalar z84 = s_front_left_knee * z82 - c_front_left_knee * z80;
    const Scalar z85 = z68 - n0_08 * z70;
    const Scalar z86 = s_rear_right_thigh * z85 - c_rear_right_thigh * z81;
    const Scalar z87 = c_front_right_thigh * z17 + s_front_right_thigh * z51;
    const Scalar z88 = s_front_right_thigh * z17 - c_front_right_thigh * z51;
    const Scalar z89 = s_front_right_knee * z87 + c_front_right_knee * z88;
    const Scalar z90 = s_front_right_knee * z88 - c_front_right_knee * z87;
    const Scalar z91 = c_rear_left_thigh * z47 + s_rear_left_thigh * z52;
    const Scalar z92 = s_rear_left_thigh * z47 - c_rear_left_thigh * z52;
    const Scalar z93 = s_rear_left_knee * z91 + c_rear_left_knee * z92;
    const Scalar z94 = s_rear_left_knee * z92 - c_rear_left_knee * z91;
    const Scalar z95 = c_rear_right_thigh * z70 + s_rear_right_thigh * z58;
    const Scalar z96 = s_rear_right_thigh * z70 - c_rear_right_thigh * z58;
    const Scalar z97 = z74 - n0_2 * z61;
    const Scalar z98 = s_rear_right_thigh * z81 + c_rear_right_thigh * z85;
    const Scalar z99 = c_front_left_knee * z75 + s_front_left_knee * z97;
    const Scalar z100 = s_front_left_knee * z75 - c_front_left_knee * z97;
    const Scalar z101 = z76 - n0_2 * z62;
    const Scalar z102 = c_front_right_knee * z77 + s_front_right_knee * z101;
    const Scalar z103 = s_front_right_knee * z77 - c_front_right_knee * z101;
    const Scalar z104 = z78 + n0_2 * z63;
    const Scalar z105 = s_rear_left_knee * z104 - c_rear_left_knee * z79;
    const Scalar z106 = s_rear_left_knee * z79 + c_rear_left_knee * z104;
    const Scalar z107 = z53 + n0_2 * z80;
    const Scalar z108 = v_rear_right_thigh + z73;  // angular velocity of rear_right_thigh_link, y
    const Scalar z109 = s_rear_right_knee * z95 + c_rear_right_knee * z96;
    const Scalar z110 = s_rear_right_knee * z96 - c_rear_right_knee * z95;
    const Scalar z111 = z86 + n0_2 * z108;
    const Scalar z112 = v_front_left_knee + z61;  // angular velocity of front_left_shank_link, y
    const Scalar z113 = s_rear_right_knee * z111 - c_rear_right_knee * z98;
    const Scalar z114 = s_rear_right_knee * z98 + c_rear_right_knee * z111;
    const Scalar z115 = n0_5 * z44 - n0_02 * z16;
    const Scalar z116 = n0_02 * z44 - n0_0014 * z16;
    const Scalar z117 = n0_8 * z74 - n0_072 * z61;
    const Scalar z118 = n0_072 * z74 - k10 * z61;
    const Scalar z119 = n0_8 * z53 + n0_072 * z80;
    const Scalar z120 = n0_072 * z53 + k10 * z80;
    const Scalar z121 = n0_032 * z112 + n0_26 * z100;
    const Scalar z122 = n0_26 * z107 - n0_032 * z84;
    const Scalar z123 = n0_032 * z107 - k13 * z84;
    const Scalar z124 = z54 - n0_2 * z87;
    const Scalar z125 = k13 * z112 + n0_032 * z100;
    const Scalar z126 = n0_02 * z17 + n0_5 * z45;
    const Scalar z127 = n0_0014 * z17 + n0_02 * z45;
    const Scalar z128 = v_front_right_knee + z62;  // angular velocity of front_right_shank_link, y
    const Scalar z129 = n0_8 * z76 - n0_072 * z62;
    const Scalar z130 = n0_072 * z76 - k10 * z62;
    const Scalar z131 = n0_8 * z54 - n0_072 * z87;
    const Scalar z132 = n0_072 * z54 - k10 * z87;
    const Scalar z133 = n0_032 * z128 + n0_26 * z103;
    const Scalar z134 = k13 * z128 + n0_032 * z103;
    const Scalar z135 = n0_26 * z124 + n0_032 * z90;
    const Scalar z136 = n0_032 * z124 + k13 * z90;
    const Scalar z137 = n0_02 * z47 + n0_5 * z46;
    const Scalar z138 = n0_0014 * z47 + n0_02 * z46;
    const Scalar z139 = n0_072 * z63 + n0_8 * z78;
    const Scalar z140 = n0_8 * z57 + n0_072 * z91;
    const Scalar z141 = z57 + n0_2 * z91;
    const Scalar z142 = n0_072 * z57 + k10 * z91;
    const Scalar z143 = k10 * z63 + n0_072 * z78;
    const Scalar z144 = v_rear_left_knee + z63;  // angular velocity of rear_left_shank_link, y
    const Scalar z145 = n0_032 * z144 + n0_26 * z106;
    const Scalar z146 = k13 * z144 + n0_032 * z106;
    const Scalar z147 = n0_2 * z36;
    const Scalar z148 = n0_26 * z141 - n0_032 * z94;
    const Scalar z149 = n0_032 * z141 - k13 * z94;
    const Scalar z150 = z69 - n0_2 * z95;
    const Scalar z151 = n0_08 * c_front_left_hip;
    const Scalar z152 = n0_5 * z68 - n0_02 * z70;
    const Scalar z153 = n0_02 * z68 - n0_0014 * z70;
    const Scalar z154 = v_rear_right_knee + z108;  // angular velocity of rear_right_shank_link, y
    const Scalar z155 = n0_08 * s_front_left_hip;
    const Scalar z156 = n0_072 * z108 + n0_8 * z86;
    const Scalar z157 = k10 * z108 + n0_072 * z86;
    const Scalar z158 = n0_02 * c_front_left_hip;
    const Scalar z159 = n0_5 * z48;
    const Scalar z160 = n0_02 * z48;
    const Scalar z161 = n0_02 * z49 + z159;
    const Scalar z162 = n0_0014 * z49 + z160;
    const Scalar z163 = n0_2 * s_front_left_thigh;
    const Scalar z164 = n0_02 * z52 + z159;
    const Scalar z165 = n0_2 * c_front_left_thigh;
    const Scalar z166 = n0_0014 * z52 + z160;
    const Scalar z167 = n0_072 * c_front_left_thigh;
    const Scalar z168 = n0_2 - z163;
    const Scalar z169 = s_front_left_hip * z167;
    const Scalar z170 = c_front_left_hip * z167;
    const Scalar z171 = n0_8 * z69 - n0_072 * z95;
    const Scalar z172 = n0_072 * z69 - k10 * z95;
    const Scalar z173 = c_front_left_hip * z165 - z155;
    const Scalar z174 = s_front_left_hip * z165 + z151;
    const Scalar z175 = n0_05 + z151;
    const Scalar z176 = n0_05 + z174;
    const Scalar z177 = n0_5 * z50;
    const Scalar z178 = z147 + z31 * z155 + z32 * z175;
    const Scalar z179 = n0_02 * z50;
    const Scalar z180 = n0_02 * s_front_left_hip;
    const Scalar z181 = z36 * z168 - z31 * z173 + z32 * z176;
    const Scalar z182 = n0_072 * s_front_left_thigh;
    const Scalar z183 = n0_05 * z32 + z147;
    const Scalar z184 = z32 * z169 - z31 * z170 - z36 * z182;
    const Scalar z185 = n0_02 * z51 - z177;
    const Scalar z186 = n0_032 * z5;
    const Scalar z187 = s_front_left_hip * z186;
    const Scalar z188 = n0_032 * z4;
    const Scalar z189 = z32 * z158 + z31 * z180;
    const Scalar z190 = n0_0014 * z51 - z179;
    const Scalar z191 = n0_08 * s_front_right_hip;
    const Scalar z192 = n0_2 * c_front_right_thigh;
    const Scalar z193 = n0_08 * c_front_right_hip;
    const Scalar z194 = n0_02 * z58 - z177;
    const Scalar z195 = n0_072 * c_front_right_thigh;
    const Scalar z196 = n0_0014 * z58 - z179;
    const Scalar z197 = n0_2 * s_front_right_thigh;
    const Scalar z198 = c_front_right_hip * z192 + z191;
    const Scalar z199 = q_trunk_z + z178;
    const Scalar z200 = n0_032 * z7;
    const Scalar z201 = q_trunk_z + z181;
    const Scalar z202 = s_front_right_hip * z195;
    const Scalar z203 = n0_2 - z197;
    const Scalar z204 = s_front_right_hip * z192 - z193;
    const Scalar z205 = c_front_left_hip * z186;
    const Scalar z206 = z32 * z187 - z31 * z205 - z36 * z188;
    const Scalar z207 = s_front_right_hip * z200;
    const Scalar z208 = c_front_right_hip * z195;
    const Scalar z209 = c_front_right_hip * z200;
    const Scalar z210 = n0_02 * c_front_right_hip;
    const Scalar z211 = n0_05 + z193;
    const Scalar z212 = n0_05 - z204;
    const Scalar z213 = n0_02 * s_front_right_hip;
    const Scalar z214 = z31 * z198 - z36 * z203 + z32 * z212;
    const Scalar z215 = n0_072 * s_front_right_thigh;
    const Scalar z216 = n0_032 * z6;
    const Scalar z217 = z32 * z202 - z31 * z208 - z36 * z215;
    const Scalar z218 = n0_05 * z32 - z147;
    const Scalar z219 = z31 * z191 - z147 + z32 * z211;
    const Scalar z220 = n0_032 * z154 + n0_26 * z114;
    const Scalar z221 = n0_26 * z150 + n0_032 * z110;
    const Scalar z222 = n0_032 * z150 + k13 * z110;
    const Scalar z223 = n0_02 * c_rear_left_hip;
    const Scalar z224 = k13 * z154 + n0_032 * z114;
    const Scalar z225 = n0_08 * c_rear_left_hip;
    const Scalar z226 = n0_02 * s_rear_left_hip;
    const Scalar z227 = q_trunk_z + z183;
    const Scalar z228 = n0_2 * c_rear_left_thigh;
    const Scalar z229 = s_rear_left_hip * z228 + z225;
    const Scalar z230 = n0_08 * s_rear_left_hip;
    const Scalar z231 = n0_08 * s_rear_right_hip;
    const Scalar z232 = z32 * z207 - z31 * z209 - z36 * z216;
    const Scalar z233 = n0_072 * c_rear_left_thigh;
    const Scalar z234 = n0_05 + z229;
    const Scalar z235 = n0_032 * z9;
    const Scalar z236 = n0_08 * c_rear_right_hip;
    const Scalar z237 = z32 * z210 + z31 * z213;
    const Scalar z238 = s_rear_left_hip * z233;
    const Scalar z239 = c_rear_left_hip * z228 - z230;
    const Scalar z240 = s_rear_left_hip * z235;
    const Scalar z241 = z32 * z223 + z31 * z226;
    const Scalar z242 = n0_2 * s_rear_left_thigh;
    const Scalar z243 = c_rear_left_hip * z233;
    const Scalar z244 = c_rear_left_hip * z235;
    const Scalar z245 = n0_05 + z225;
    const Scalar z246 = n0_2 + z242;
    const Scalar z247 = n0_02 * c_rear_right_hip;
    const Scalar z248 = z31 * z230 - z147 + z32 * z245;
    const Scalar z249 = n0_072 * s_rear_left_thigh;
    const Scalar z250 = z32 * z238 - z31 * z243 - z36 * z249;
    const Scalar z251 = n0_032 * z8;
    const Scalar z252 = n0_02 * s_rear_right_hip;
    const Scalar z253 = z32 * z234 - z31 * z239 - z36 * z246;
    const Scalar z254 = q_trunk_z - z218;
    const Scalar z255 = n0_072 * c_rear_right_thigh;
    const Scalar z256 = s_rear_right_hip * z255;
    const Scalar z257 = c_rear_right_hip * z255;
    const Scalar z258 = n0_05 + z236;
    const Scalar z259 = z32 * z240 - z31 * z244 - z36 * z251;
    const Scalar z260 = n0_072 * s_rear_right_thigh;
    const Scalar z261 = z147 + z31 * z231 + z32 * z258;
    const Scalar z262 = q_trunk_z - z219;
    const Scalar z263 = n0_2 * s_rear_right_thigh;
    const Scalar z264 = n0_2 * c_rear_right_thigh;
    const Scalar z265 = n0_2 + z263;
    const Scalar z266 = n0_032 * z11;
    const Scalar z267 = c_rear_right_hip * z264 + z231;
    const Scalar z268 = s_rear_right_hip * z266;
    const Scalar z269 = z32 * z256 - z31 * z257 - z36 * z260;
    const Scalar z270 = s_rear_right_hip * z264 - z236;
    const Scalar z271 = c_rear_right_hip * z266;
    const Scalar z272 = n0_05 - z270;
    const Scalar z273 = n0_032 * z10;
    const Scalar z274 = q_trunk_z - z214;
    const Scalar z275 = q_trunk_z + z218;
    const Scalar z276 = q_trunk_z + z248;
    const Scalar z277 = z36 * z265 + z31 * z267 + z32 * z272;
    const Scalar z278 = q_trunk_z + z253;
    const Scalar z279 = q_trunk_z - z183;
    const Scalar z280 = z32 * z247 + z31 * z252;
    const Scalar z281 = q_trunk_z - z261;
    const Scalar z282 = q_trunk_z - z277;
    const Scalar z283 = z32 * z268 - z31 * z271 - z36 * z273;
    const Scalar z284 = n0_05 * v_front_left_hip;
    const Scalar z285 = n0_05 * v_front_left_thigh;
    const Scalar z286 = n0_05 * v_front_left_knee;
    const Scalar z287 = n0_05 * v_front_right_hip;
    const Scalar z288 = n0_05 * v_front_right_thigh;
    const Scalar z289 = n0_05 * v_front_right_knee;
    const Scalar z290 = n0_05 * v_rear_left_hip;
    const Scalar z291 = n0_05 * v_rear_left_thigh;
    const Scalar z292 = n0_05 * v_rear_left_knee;
    const Scalar z293 = n0_05 * v_rear_right_hip;
    const Scalar z294 = n0_05 * v_rear_right_thigh;
    const Scalar z295 = n0_05 * v_rear_right_knee;
    result.kinetic = n0_0125 * v_trunk_attitude_omega_x * v_trunk_attitude_omega_x + n0_0425 * v_trunk_attitude_omega_y
        * v_trunk_attitude_omega_y + v_trunk_attitude_omega_z * z15 + n3 * (z38 * z38 + z34 * z34 + z35 * z35) + n0_25
        * (z53 * z53 + z54 * z54 + z57 * z57 + z69 * z69) + n0_4 * (z75 * z75 + z77 * z77 + z79 * z79 + z98 * z98) + k19
        * (z83 * z83 + z89 * z89 + z93 * z93 + z109 * z109) + n0_0002 * (z55 * z55 + z59 * z59 + z60 * z60 + z73 * z73
        + z82 * z82 + z88 * z88 + z92 * z92 + z96 * z96) + n0_13 * (z99 * z99 + z102 * z102 + z105 * z105 + z113 * z113)
        + n0_5 * (z49 * z162 + z51 * z190 + z45 * z126 + z17 * z127 + z52 * z166 + z46 * z137 + z47 * z138 + z58 * z196
        + z48 * (z161 + z164) - z50 * (z185 + z194) + z44 * z115 - z16 * z116 + z68 * z152 - z70 * z153 + z53 * z119
        + z80 * z120 + z54 * z131 - z87 * z132 + z57 * z140 + z91 * z142 + z69 * z171 - z95 * z172 + z107 * z122 - z84
        * z123 + z124 * z135 + z90 * z136 + z78 * z139 + z63 * z143 + z141 * z148 - z94 * z149 + z86 * z156 + z108
        * z157 + z150 * z221 + z110 * z222 + z74 * z117 - z61 * z118 + z76 * z129 - z62 * z130 + z100 * z121 + z112
        * z125 + z103 * z133 + z128 * z134 + z106 * z145 + z144 * z146 + z114 * z220 + z154 * z224);
    result.force_function = -n58_86 * q_trunk_z - n4_905 * (z227 + z254 + z275 + z279) - n7_848 * (z199 + z262 + z276
        + z281) - n2_5506 * (z201 + z282 + z274 + z278) - n9_81 * (z189 - z237 + z241 - z280 + z184 + z217 + z250 + z269
        + z206 + z232 + z259 + z283);
    result.power = v_front_left_hip * (u_front_left_hip_torque - z284) + v_front_left_thigh * (u_front_left_thigh_torque
        - z285) + v_front_left_knee * (u_front_left_knee_torque - z286) + v_front_right_hip * (u_front_right_hip_torque
        - z287) + v_front_right_thigh * (u_front_right_thigh_torque - z288) + v_front_right_knee
        * (u_front_right_knee_torque - z289) + v_rear_left_hip * (u_rear_left_hip_torque - z290) + v_rear_left_thigh
        * (u_rear_left_thigh_torque - z291) + v_rear_left_knee * (u_rear_left_knee_torque - z292) + v_rear_right_hip
        * (u_rear_right_hip_torque - z293) + v_rear_right_thigh * (u_rear_right_thigh_torque - z294) + v_rear_right_knee
        * (u_rear_right_knee_torque - z295);
  }
};

}  // namespace quadruped
