// SPDX-License-Identifier: MIT
// quadruped
// Made by torsor 0.1.0 from quadruped.urdf; change that and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              542              699          0             0                 16       0   1273    1283
//   mass_matrix             307              402          0             0                 12       0    733     803
//   bias                    388              512          0             0                 12       0    924    1026
//   inverse_dynamics        446              549          0             0                 12       0   1019    1121
//   forward_dynamics        950             1176         14             0                 12       0   2164    2346
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
  static constexpr unsigned long long fingerprint = 0xa45fc8803421c5b2ULL;
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
    const Scalar z6890 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_y + q_trunk_attitude_z
        * v_trunk_attitude_omega_z + q_trunk_attitude_x * v_trunk_attitude_omega_x);
    const Scalar z6891 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_z - q_trunk_attitude_z
        * v_trunk_attitude_omega_y + q_trunk_attitude_w * v_trunk_attitude_omega_x);
    const Scalar z6892 = n0_5 * (q_trunk_attitude_z * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_z + q_trunk_attitude_w * v_trunk_attitude_omega_y);
    const Scalar z6893 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_y - q_trunk_attitude_w * v_trunk_attitude_omega_z);
    rates[0] = v_trunk_x;
    rates[1] = v_trunk_y;
    rates[2] = v_trunk_z;
    rates[3] = -z6890;
    rates[4] = z6891;
    rates[5] = z6892;
    rates[6] = -z6893;
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
    const Scalar z785 = q_front_left_thigh + q_front_left_knee;
    const Scalar z855 = q_front_right_thigh + q_front_right_knee;
    const Scalar z921 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z987 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z785, z855, z921, z987};
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
    const Scalar z786 = sines_[12], z787 = cosines_[12];
    const Scalar z856 = sines_[13], z857 = cosines_[13];
    const Scalar z922 = sines_[14], z923 = cosines_[14];
    const Scalar z988 = sines_[15], z989 = cosines_[15];
    const Scalar z704 = n2 * q_trunk_attitude_y;
    const Scalar z706 = n2 * q_trunk_attitude_z;
    const Scalar z713 = n2 * q_trunk_attitude_x;
    const Scalar z749 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z750 = n0_2 * v_trunk_attitude_omega_z;
    const Scalar z751 = n0_05 * v_trunk_attitude_omega_x;
    const Scalar z708 = q_trunk_attitude_x * z704;
    const Scalar z709 = q_trunk_attitude_w * z706;
    const Scalar z715 = q_trunk_attitude_z * z704;
    const Scalar z716 = q_trunk_attitude_w * z713;
    const Scalar z705 = q_trunk_attitude_y * z704;
    const Scalar z707 = q_trunk_attitude_z * z706;
    const Scalar z711 = z708 - z709;
    const Scalar z712 = z708 + z709;
    const Scalar z719 = z715 + z716;
    const Scalar z714 = q_trunk_attitude_x * z713;
    const Scalar z720 = q_trunk_attitude_x * z706;
    const Scalar z721 = q_trunk_attitude_w * z704;
    const Scalar z717 = n1 - z707 - z714;
    const Scalar z722 = n1 - z705 - z714;
    const Scalar z724 = z720 + z721;
    const Scalar z752 = n0_2 * v_trunk_attitude_omega_y - z751;
    const Scalar z710 = n1 - z705 - z707;
    const Scalar z718 = z715 - z716;
    const Scalar z723 = z720 - z721;
    const Scalar z755 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z735 = s_front_left_hip * z711 - c_front_left_hip * z724;
    const Scalar z737 = s_front_left_hip * z717 - c_front_left_hip * z718;
    const Scalar z739 = s_front_left_hip * z719 - c_front_left_hip * z722;
    const Scalar z759 = v_trunk_x + z711 * z750 - z724 * z752 - z710 * z749;  // velocity of front_left_hip_link, x
    const Scalar z760 = v_trunk_y - z712 * z749 + z717 * z750 - z718 * z752;  // velocity of front_left_hip_link, y
    const Scalar z761 = v_trunk_z + z719 * z750 - z722 * z752 - z723 * z749;  // velocity of front_left_hip_link, z
    const Scalar z775 = n0_08 * z755;
    const Scalar z754 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z725 = v_trunk_attitude_omega_x * z710;  // angular velocity of trunk_attitude_omega_x, x
    const Scalar z728 = v_trunk_attitude_omega_y * z711 + z725;  // angular velocity of trunk_attitude_omega_y, x
    const Scalar z726 = v_trunk_attitude_omega_x * z712;  // angular velocity of trunk_attitude_omega_x, y
    const Scalar z729 = v_trunk_attitude_omega_y * z717 + z726;  // angular velocity of trunk_attitude_omega_y, y
    const Scalar z727 = v_trunk_attitude_omega_x * z723;  // angular velocity of trunk_attitude_omega_x, z
    const Scalar z730 = v_trunk_attitude_omega_y * z719 + z727;  // angular velocity of trunk_attitude_omega_y, z
    const Scalar z731 = v_trunk_attitude_omega_z * z724 + z728;  // angular velocity of trunk, x
    const Scalar z753 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z732 = v_trunk_attitude_omega_z * z718 + z729;  // angular velocity of trunk, y
    const Scalar z733 = v_trunk_attitude_omega_z * z722 + z730;  // angular velocity of trunk, z
    const Scalar z734 = s_front_left_hip * z724 + c_front_left_hip * z711;
    const Scalar z736 = s_front_left_hip * z718 + c_front_left_hip * z717;
    const Scalar z738 = s_front_left_hip * z722 + c_front_left_hip * z719;
    const Scalar z740 = n0_05 * z711;
    const Scalar z742 = n0_2 * z712;
    const Scalar z744 = n0_05 * z719;
    const Scalar z741 = n0_2 * z710 + z740;
    const Scalar z743 = n0_05 * z717 + z742;
    const Scalar z745 = n0_2 * z723 + z744;
    const Scalar z746 = q_trunk_x + z741;  // place of front_left_hip_link, x
    const Scalar z747 = q_trunk_y + z743;  // place of front_left_hip_link, y
    const Scalar z810 = s_front_right_hip * z724 + c_front_right_hip * z711;
    const Scalar z748 = q_trunk_z + z745;  // place of front_left_hip_link, z
    const Scalar z816 = n0_2 * z710 - z740;
    const Scalar z778 = v_front_left_thigh + z753;
    const Scalar z817 = n0_05 * z717 - z742;
    const Scalar z818 = n0_2 * z723 - z744;
    const Scalar z811 = s_front_right_hip * z711 - c_front_right_hip * z724;
    const Scalar z813 = s_front_right_hip * z717 - c_front_right_hip * z718;
    const Scalar z815 = s_front_right_hip * z719 - c_front_right_hip * z722;
    const Scalar z774 = n0_08 * z754;
    const Scalar z763 = s_front_left_thigh * z710 - c_front_left_thigh * z735;
    const Scalar z765 = s_front_left_thigh * z712 - c_front_left_thigh * z737;
    const Scalar z767 = s_front_left_thigh * z723 - c_front_left_thigh * z739;
    const Scalar z776 = c_front_left_thigh * z755 + s_front_left_thigh * z754;
    const Scalar z789 = z710 * z786 - z735 * z787;
    const Scalar z791 = z712 * z786 - z737 * z787;
    const Scalar z793 = z723 * z786 - z739 * z787;
    const Scalar z782 = z759 - z735 * z775 + z710 * z774;  // velocity of front_left_thigh_link, x
    const Scalar z783 = z760 - z737 * z775 + z712 * z774;  // velocity of front_left_thigh_link, y
    const Scalar z784 = z761 - z739 * z775 + z723 * z774;  // velocity of front_left_thigh_link, z
    const Scalar z794 = n0_2 * z763;
    const Scalar z795 = n0_2 * z765;
    const Scalar z796 = n0_2 * z767;
    const Scalar z801 = n0_2 * z776;
    const Scalar z812 = s_front_right_hip * z718 + c_front_right_hip * z717;
    const Scalar z814 = s_front_right_hip * z722 + c_front_right_hip * z719;
    const Scalar z777 = s_front_left_thigh * z755 - c_front_left_thigh * z754;
    const Scalar z802 = s_front_left_knee * z777 - c_front_left_knee * z776;
    const Scalar z768 = n0_08 * z734;
    const Scalar z769 = n0_08 * z736;
    const Scalar z770 = n0_08 * z738;
    const Scalar z762 = c_front_left_thigh * z710 + s_front_left_thigh * z735;
    const Scalar z764 = c_front_left_thigh * z712 + s_front_left_thigh * z737;
    const Scalar z766 = c_front_left_thigh * z723 + s_front_left_thigh * z739;
    const Scalar z800 = n0_2 * z778;
    const Scalar z803 = v_front_left_knee + z778;
    const Scalar z756 = v_front_left_hip * z710 + z731;  // angular velocity of front_left_hip_link, x
    const Scalar z779 = v_front_left_thigh * z734 + z756;  // angular velocity of front_left_thigh_link, x
    const Scalar z819 = q_trunk_x + z816;  // place of front_right_hip_link, x
    const Scalar z757 = v_front_left_hip * z712 + z732;  // angular velocity of front_left_hip_link, y
    const Scalar z780 = v_front_left_thigh * z736 + z757;  // angular velocity of front_left_thigh_link, y
    const Scalar z820 = q_trunk_y - z817;  // place of front_right_hip_link, y
    const Scalar z804 = v_front_left_knee * z734 + z779;  // angular velocity of front_left_shank_link, x
    const Scalar z758 = v_front_left_hip * z723 + z733;  // angular velocity of front_left_hip_link, z
    const Scalar z822 = n0_2 * v_trunk_attitude_omega_y + z751;
    const Scalar z805 = v_front_left_knee * z736 + z780;  // angular velocity of front_left_shank_link, y
    const Scalar z781 = v_front_left_thigh * z738 + z758;  // angular velocity of front_left_thigh_link, z
    const Scalar z824 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z806 = v_front_left_knee * z738 + z781;  // angular velocity of front_left_shank_link, z
    const Scalar z825 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z829 = v_trunk_x + z711 * z750 - z724 * z822 + z710 * z749;  // velocity of front_right_hip_link, x
    const Scalar z830 = v_trunk_y + z712 * z749 + z717 * z750 - z718 * z822;  // velocity of front_right_hip_link, y
    const Scalar z831 = v_trunk_z + z719 * z750 - z722 * z822 + z723 * z749;  // velocity of front_right_hip_link, z
    const Scalar z833 = s_front_right_thigh * z710 - c_front_right_thigh * z811;
    const Scalar z823 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z832 = c_front_right_thigh * z710 + s_front_right_thigh * z811;
    const Scalar z821 = q_trunk_z + z818;  // place of front_right_hip_link, z
    const Scalar z788 = z710 * z787 + z735 * z786;
    const Scalar z790 = z712 * z787 + z737 * z786;
    const Scalar z792 = z723 * z787 + z739 * z786;
    const Scalar z807 = z782 + z734 * z801 - z762 * z800;  // velocity of front_left_shank_link, x
    const Scalar z808 = z783 + z736 * z801 - z764 * z800;  // velocity of front_left_shank_link, y
    const Scalar z809 = z784 + z738 * z801 - z766 * z800;  // velocity of front_left_shank_link, z
    const Scalar z826 = v_front_right_hip * z710 + z731;  // angular velocity of front_right_hip_link, x
    const Scalar z827 = v_front_right_hip * z712 + z732;  // angular velocity of front_right_hip_link, y
    const Scalar z828 = v_front_right_hip * z723 + z733;  // angular velocity of front_right_hip_link, z
    const Scalar z771 = z746 + z768;  // place of front_left_thigh_link, x
    const Scalar z834 = c_front_right_thigh * z712 + s_front_right_thigh * z813;
    const Scalar z772 = z747 + z769;  // place of front_left_thigh_link, y
    const Scalar z835 = s_front_right_thigh * z712 - c_front_right_thigh * z813;
    const Scalar z773 = z748 + z770;  // place of front_left_thigh_link, z
    const Scalar z848 = v_front_right_thigh + z823;
    const Scalar z849 = v_front_right_thigh * z810 + z826;  // angular velocity of front_right_thigh_link, x
    const Scalar z850 = v_front_right_thigh * z812 + z827;  // angular velocity of front_right_thigh_link, y
    const Scalar z851 = v_front_right_thigh * z814 + z828;  // angular velocity of front_right_thigh_link, z
    const Scalar z844 = n0_08 * z824;
    const Scalar z845 = n0_08 * z825;
    const Scalar z837 = s_front_right_thigh * z723 - c_front_right_thigh * z815;
    const Scalar z846 = c_front_right_thigh * z825 + s_front_right_thigh * z824;
    const Scalar z859 = z710 * z856 - z811 * z857;
    const Scalar z852 = z710 * z844 - z829 - z811 * z845;  // velocity of front_right_thigh_link, x
    const Scalar z853 = z712 * z844 - z830 - z813 * z845;  // velocity of front_right_thigh_link, y
    const Scalar z854 = z723 * z844 - z831 - z815 * z845;  // velocity of front_right_thigh_link, z
    const Scalar z847 = s_front_right_thigh * z825 - c_front_right_thigh * z824;
    const Scalar z838 = n0_08 * z810;
    const Scalar z839 = n0_08 * z812;
    const Scalar z840 = n0_08 * z814;
    const Scalar z836 = c_front_right_thigh * z723 + s_front_right_thigh * z815;
    const Scalar z858 = z710 * z857 + z811 * z856;
    const Scalar z841 = z819 - z838;  // place of front_right_thigh_link, x
    const Scalar z842 = z820 - z839;  // place of front_right_thigh_link, y
    const Scalar z843 = z821 - z840;  // place of front_right_thigh_link, z
    const Scalar z797 = z771 - z794;  // place of front_left_shank_link, x
    const Scalar z860 = z712 * z857 + z813 * z856;
    const Scalar z798 = z772 - z795;  // place of front_left_shank_link, y
    const Scalar z861 = z712 * z856 - z813 * z857;
    const Scalar z799 = z773 - z796;  // place of front_left_shank_link, z
    const Scalar z874 = v_front_right_knee * z810 + z849;  // angular velocity of front_right_shank_link, x
    const Scalar z875 = v_front_right_knee * z812 + z850;  // angular velocity of front_right_shank_link, y
    const Scalar z876 = v_front_right_knee * z814 + z851;  // angular velocity of front_right_shank_link, z
    const Scalar z872 = s_front_right_knee * z847 - c_front_right_knee * z846;
    const Scalar z891 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z881 = s_rear_left_hip * z711 - c_rear_left_hip * z724;
    const Scalar z883 = s_rear_left_hip * z717 - c_rear_left_hip * z718;
    const Scalar z885 = s_rear_left_hip * z719 - c_rear_left_hip * z722;
    const Scalar z895 = v_trunk_x - z711 * z750 + z724 * z822 - z710 * z749;  // velocity of rear_left_hip_link, x
    const Scalar z896 = v_trunk_y - z712 * z749 - z717 * z750 + z718 * z822;  // velocity of rear_left_hip_link, y
    const Scalar z897 = v_trunk_z - z719 * z750 + z722 * z822 - z723 * z749;  // velocity of rear_left_hip_link, z
    const Scalar z911 = n0_08 * z891;
    const Scalar z890 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z910 = n0_08 * z890;
    const Scalar z863 = z723 * z856 - z815 * z857;
    const Scalar z899 = s_rear_left_thigh * z710 - c_rear_left_thigh * z881;
    const Scalar z901 = s_rear_left_thigh * z712 - c_rear_left_thigh * z883;
    const Scalar z903 = s_rear_left_thigh * z723 - c_rear_left_thigh * z885;
    const Scalar z912 = c_rear_left_thigh * z891 + s_rear_left_thigh * z890;
    const Scalar z889 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z914 = v_rear_left_thigh + z889;
    const Scalar z864 = n0_2 * z833;
    const Scalar z865 = n0_2 * z835;
    const Scalar z866 = n0_2 * z837;
    const Scalar z871 = n0_2 * z846;
    const Scalar z880 = s_rear_left_hip * z724 + c_rear_left_hip * z711;
    const Scalar z882 = s_rear_left_hip * z718 + c_rear_left_hip * z717;
    const Scalar z884 = s_rear_left_hip * z722 + c_rear_left_hip * z719;
    const Scalar z918 = z895 - z881 * z911 + z710 * z910;  // velocity of rear_left_thigh_link, x
    const Scalar z919 = z896 - z883 * z911 + z712 * z910;  // velocity of rear_left_thigh_link, y
    const Scalar z920 = z897 - z885 * z911 + z723 * z910;  // velocity of rear_left_thigh_link, z
    const Scalar z913 = s_rear_left_thigh * z891 - c_rear_left_thigh * z890;
    const Scalar z904 = n0_08 * z880;
    const Scalar z905 = n0_08 * z882;
    const Scalar z906 = n0_08 * z884;
    const Scalar z870 = n0_2 * z848;
    const Scalar z898 = c_rear_left_thigh * z710 + s_rear_left_thigh * z881;
    const Scalar z900 = c_rear_left_thigh * z712 + s_rear_left_thigh * z883;
    const Scalar z902 = c_rear_left_thigh * z723 + s_rear_left_thigh * z885;
    const Scalar z873 = v_front_right_knee + z848;
    const Scalar z886 = q_trunk_x - z816;  // place of rear_left_hip_link, x
    const Scalar z887 = q_trunk_y + z817;  // place of rear_left_hip_link, y
    const Scalar z888 = q_trunk_z - z818;  // place of rear_left_hip_link, z
    const Scalar z862 = z723 * z857 + z815 * z856;
    const Scalar z925 = z710 * z922 - z881 * z923;
    const Scalar z927 = z712 * z922 - z883 * z923;
    const Scalar z929 = z723 * z922 - z885 * z923;
    const Scalar z877 = z810 * z871 - z852 - z832 * z870;  // velocity of front_right_shank_link, x
    const Scalar z878 = z812 * z871 - z853 - z834 * z870;  // velocity of front_right_shank_link, y
    const Scalar z879 = z814 * z871 - z854 - z836 * z870;  // velocity of front_right_shank_link, z
    const Scalar z892 = v_rear_left_hip * z710 + z731;  // angular velocity of rear_left_hip_link, x
    const Scalar z915 = v_rear_left_thigh * z880 + z892;  // angular velocity of rear_left_thigh_link, x
    const Scalar z893 = v_rear_left_hip * z712 + z732;  // angular velocity of rear_left_hip_link, y
    const Scalar z916 = v_rear_left_thigh * z882 + z893;  // angular velocity of rear_left_thigh_link, y
    const Scalar z894 = v_rear_left_hip * z723 + z733;  // angular velocity of rear_left_hip_link, z
    const Scalar z917 = v_rear_left_thigh * z884 + z894;  // angular velocity of rear_left_thigh_link, z
    const Scalar z924 = z710 * z923 + z881 * z922;
    const Scalar z926 = z712 * z923 + z883 * z922;
    const Scalar z928 = z723 * z923 + z885 * z922;
    const Scalar z907 = z886 + z904;  // place of rear_left_thigh_link, x
    const Scalar z908 = z887 + z905;  // place of rear_left_thigh_link, y
    const Scalar z909 = z888 + z906;  // place of rear_left_thigh_link, z
    const Scalar z867 = z841 - z864;  // place of front_right_shank_link, x
    const Scalar z930 = n0_2 * z899;
    const Scalar z868 = z842 - z865;  // place of front_right_shank_link, y
    const Scalar z931 = n0_2 * z901;
    const Scalar z869 = z843 - z866;  // place of front_right_shank_link, z
    const Scalar z940 = v_rear_left_knee * z880 + z915;  // angular velocity of rear_left_shank_link, x
    const Scalar z941 = v_rear_left_knee * z882 + z916;  // angular velocity of rear_left_shank_link, y
    const Scalar z942 = v_rear_left_knee * z884 + z917;  // angular velocity of rear_left_shank_link, z
    const Scalar z958 = v_rear_right_hip * z710 + z731;  // angular velocity of rear_right_hip_link, x
    const Scalar z959 = v_rear_right_hip * z712 + z732;  // angular velocity of rear_right_hip_link, y
    const Scalar z960 = v_rear_right_hip * z723 + z733;  // angular velocity of rear_right_hip_link, z
    const Scalar z938 = s_rear_left_knee * z913 - c_rear_left_knee * z912;
    const Scalar z956 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z957 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z961 = v_trunk_x - z711 * z750 + z724 * z752 + z710 * z749;  // velocity of rear_right_hip_link, x
    const Scalar z962 = v_trunk_y + z712 * z749 - z717 * z750 + z718 * z752;  // velocity of rear_right_hip_link, y
    const Scalar z963 = v_trunk_z - z719 * z750 + z722 * z752 + z723 * z749;  // velocity of rear_right_hip_link, z
    const Scalar z976 = n0_08 * z956;
    const Scalar z947 = s_rear_right_hip * z711 - c_rear_right_hip * z724;
    const Scalar z949 = s_rear_right_hip * z717 - c_rear_right_hip * z718;
    const Scalar z951 = s_rear_right_hip * z719 - c_rear_right_hip * z722;
    const Scalar z977 = n0_08 * z957;
    const Scalar z965 = s_rear_right_thigh * z710 - c_rear_right_thigh * z947;
    const Scalar z967 = s_rear_right_thigh * z712 - c_rear_right_thigh * z949;
    const Scalar z969 = s_rear_right_thigh * z723 - c_rear_right_thigh * z951;
    const Scalar z978 = c_rear_right_thigh * z957 + s_rear_right_thigh * z956;
    const Scalar z991 = z710 * z988 - z947 * z989;
    const Scalar z993 = z712 * z988 - z949 * z989;
    const Scalar z955 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z980 = v_rear_right_thigh + z955;
    const Scalar z932 = n0_2 * z903;
    const Scalar z995 = z723 * z988 - z951 * z989;
    const Scalar z937 = n0_2 * z912;
    const Scalar z946 = s_rear_right_hip * z724 + c_rear_right_hip * z711;
    const Scalar z981 = v_rear_right_thigh * z946 + z958;  // angular velocity of rear_right_thigh_link, x
    const Scalar z948 = s_rear_right_hip * z718 + c_rear_right_hip * z717;
    const Scalar z982 = v_rear_right_thigh * z948 + z959;  // angular velocity of rear_right_thigh_link, y
    const Scalar z950 = s_rear_right_hip * z722 + c_rear_right_hip * z719;
    const Scalar z983 = v_rear_right_thigh * z950 + z960;  // angular velocity of rear_right_thigh_link, z
    const Scalar z984 = z710 * z976 - z961 - z947 * z977;  // velocity of rear_right_thigh_link, x
    const Scalar z985 = z712 * z976 - z962 - z949 * z977;  // velocity of rear_right_thigh_link, y
    const Scalar z986 = z723 * z976 - z963 - z951 * z977;  // velocity of rear_right_thigh_link, z
    const Scalar z979 = s_rear_right_thigh * z957 - c_rear_right_thigh * z956;
    const Scalar z970 = n0_08 * z946;
    const Scalar z971 = n0_08 * z948;
    const Scalar z972 = n0_08 * z950;
    const Scalar z936 = n0_2 * z914;
    const Scalar z964 = c_rear_right_thigh * z710 + s_rear_right_thigh * z947;
    const Scalar z966 = c_rear_right_thigh * z712 + s_rear_right_thigh * z949;
    const Scalar z968 = c_rear_right_thigh * z723 + s_rear_right_thigh * z951;
    const Scalar z939 = v_rear_left_knee + z914;
    const Scalar z952 = q_trunk_x - z741;  // place of rear_right_hip_link, x
    const Scalar z953 = q_trunk_y - z743;  // place of rear_right_hip_link, y
    const Scalar z954 = q_trunk_z - z745;  // place of rear_right_hip_link, z
    const Scalar z943 = z918 + z880 * z937 - z898 * z936;  // velocity of rear_left_shank_link, x
    const Scalar z944 = z919 + z882 * z937 - z900 * z936;  // velocity of rear_left_shank_link, y
    const Scalar z945 = z920 + z884 * z937 - z902 * z936;  // velocity of rear_left_shank_link, z
    const Scalar z990 = z710 * z989 + z947 * z988;
    const Scalar z992 = z712 * z989 + z949 * z988;
    const Scalar z994 = z723 * z989 + z951 * z988;
    const Scalar z973 = z952 - z970;  // place of rear_right_thigh_link, x
    const Scalar z974 = z953 - z971;  // place of rear_right_thigh_link, y
    const Scalar z975 = z954 - z972;  // place of rear_right_thigh_link, z
    const Scalar z933 = z907 - z930;  // place of rear_left_shank_link, x
    const Scalar z996 = n0_2 * z965;
    const Scalar z934 = z908 - z931;  // place of rear_left_shank_link, y
    const Scalar z997 = n0_2 * z967;
    const Scalar z935 = z909 - z932;  // place of rear_left_shank_link, z
    const Scalar z1006 = v_rear_right_knee * z946 + z981;  // angular velocity of rear_right_shank_link, x
    const Scalar z1007 = v_rear_right_knee * z948 + z982;  // angular velocity of rear_right_shank_link, y
    const Scalar z1008 = v_rear_right_knee * z950 + z983;  // angular velocity of rear_right_shank_link, z
    const Scalar z1019 = n0_04 * z755;
    const Scalar z1030 = n0_09 * z776;
    const Scalar z1004 = s_rear_right_knee * z979 - c_rear_right_knee * z978;
    const Scalar z1018 = n0_04 * z754;
    const Scalar z1020 = z759 - z735 * z1019 + z710 * z1018;
    const Scalar z1021 = z760 - z737 * z1019 + z712 * z1018;
    const Scalar z1022 = z761 - z739 * z1019 + z723 * z1018;
    const Scalar z1029 = n0_09 * z778;
    const Scalar z1031 = z782 + z734 * z1030 - z762 * z1029;
    const Scalar z1032 = z783 + z736 * z1030 - z764 * z1029;
    const Scalar z1033 = z784 + z738 * z1030 - z766 * z1029;
    const Scalar z1023 = n0_09 * z763;
    const Scalar z1026 = z771 - z1023;
    const Scalar z1024 = n0_09 * z765;
    const Scalar z1027 = z772 - z1024;
    const Scalar z1025 = n0_09 * z767;
    const Scalar z1028 = z773 - z1025;
    const Scalar z998 = n0_2 * z969;
    const Scalar z1003 = n0_2 * z978;
    const Scalar z1045 = n0_2 * z789;
    const Scalar z1034 = n0_1 * z789;
    const Scalar z1037 = z797 - z1034;
    const Scalar z1048 = z797 - z1045;
    const Scalar z1046 = n0_2 * z791;
    const Scalar z1035 = n0_1 * z791;
    const Scalar z1038 = z798 - z1035;
    const Scalar z1049 = z798 - z1046;
    const Scalar z1047 = n0_2 * z793;
    const Scalar z1036 = n0_1 * z793;
    const Scalar z1039 = z799 - z1036;
    const Scalar z1050 = z799 - z1047;
    const Scalar z1002 = n0_2 * z980;
    const Scalar z1005 = v_rear_right_knee + z980;
    const Scalar z1009 = z946 * z1003 - z984 - z964 * z1002;  // velocity of rear_right_shank_link, x
    const Scalar z1010 = z948 * z1003 - z985 - z966 * z1002;  // velocity of rear_right_shank_link, y
    const Scalar z1011 = z950 * z1003 - z986 - z968 * z1002;  // velocity of rear_right_shank_link, z
    const Scalar z1040 = n0_1 * z803;
    const Scalar z1051 = n0_2 * z803;
    const Scalar z1041 = n0_1 * z802;
    const Scalar z1052 = n0_2 * z802;
    const Scalar z1042 = z788 * z1040 - z807 + z734 * z1041;
    const Scalar z1053 = z788 * z1051 - z807 + z734 * z1052;
    const Scalar z1043 = z790 * z1040 - z808 + z736 * z1041;
    const Scalar z1044 = z792 * z1040 - z809 + z738 * z1041;
    const Scalar z1054 = z790 * z1051 - z808 + z736 * z1052;
    const Scalar z1055 = z792 * z1051 - z809 + z738 * z1052;
    const Scalar z999 = z973 - z996;  // place of rear_right_shank_link, x
    const Scalar z1000 = z974 - z997;  // place of rear_right_shank_link, y
    const Scalar z1001 = z975 - z998;  // place of rear_right_shank_link, z
    const Scalar z1062 = n0_04 * z824;
    const Scalar z1063 = n0_04 * z825;
    const Scalar z1064 = z710 * z1062 - z829 - z811 * z1063;
    const Scalar z1065 = z712 * z1062 - z830 - z813 * z1063;
    const Scalar z1066 = z723 * z1062 - z831 - z815 * z1063;
    const Scalar z1067 = n0_09 * z833;
    const Scalar z1070 = z841 - z1067;
    const Scalar z1068 = n0_09 * z835;
    const Scalar z1071 = z842 - z1068;
    const Scalar z1069 = n0_09 * z837;
    const Scalar z1012 = n0_04 * z734;
    const Scalar z1015 = z746 + z1012;
    const Scalar z1072 = z843 - z1069;
    const Scalar z1013 = n0_04 * z736;
    const Scalar z1016 = z747 + z1013;
    const Scalar z1073 = n0_09 * z848;
    const Scalar z1014 = n0_04 * z738;
    const Scalar z1017 = z748 + z1014;
    const Scalar z1074 = n0_09 * z846;
    const Scalar z1075 = z810 * z1074 - z852 - z832 * z1073;
    const Scalar z1076 = z812 * z1074 - z853 - z834 * z1073;
    const Scalar z1077 = z814 * z1074 - z854 - z836 * z1073;
    const Scalar z1107 = n0_04 * z891;
    const Scalar z1106 = n0_04 * z890;
    const Scalar z1108 = z895 - z881 * z1107 + z710 * z1106;
    const Scalar z1109 = z896 - z883 * z1107 + z712 * z1106;
    const Scalar z1110 = z897 - z885 * z1107 + z723 * z1106;
    const Scalar z1111 = n0_09 * z899;
    const Scalar z1114 = z907 - z1111;
    const Scalar z1112 = n0_09 * z901;
    const Scalar z1115 = z908 - z1112;
    const Scalar z1113 = n0_09 * z903;
    const Scalar z1089 = n0_2 * z859;
    const Scalar z1078 = n0_1 * z859;
    const Scalar z1081 = z867 - z1078;
    const Scalar z1092 = z867 - z1089;
    const Scalar z1090 = n0_2 * z861;
    const Scalar z1079 = n0_1 * z861;
    const Scalar z1082 = z868 - z1079;
    const Scalar z1093 = z868 - z1090;
    const Scalar z1091 = n0_2 * z863;
    const Scalar z1080 = n0_1 * z863;
    const Scalar z1083 = z869 - z1080;
    const Scalar z1094 = z869 - z1091;
    const Scalar z1084 = n0_1 * z873;
    const Scalar z1095 = n0_2 * z873;
    const Scalar z1085 = n0_1 * z872;
    const Scalar z1096 = n0_2 * z872;
    const Scalar z1086 = z858 * z1084 - z877 + z810 * z1085;
    const Scalar z1097 = z858 * z1095 - z877 + z810 * z1096;
    const Scalar z1087 = z860 * z1084 - z878 + z812 * z1085;
    const Scalar z1088 = z862 * z1084 - z879 + z814 * z1085;
    const Scalar z1098 = z860 * z1095 - z878 + z812 * z1096;
    const Scalar z1099 = z862 * z1095 - z879 + z814 * z1096;
    const Scalar z1056 = n0_04 * z810;
    const Scalar z1059 = z819 - z1056;
    const Scalar z1116 = z909 - z1113;
    const Scalar z1057 = n0_04 * z812;
    const Scalar z1060 = z820 - z1057;
    const Scalar z1117 = n0_09 * z914;
    const Scalar z1058 = n0_04 * z814;
    const Scalar z1061 = z821 - z1058;
    const Scalar z1118 = n0_09 * z912;
    const Scalar z1119 = z918 + z880 * z1118 - z898 * z1117;
    const Scalar z1120 = z919 + z882 * z1118 - z900 * z1117;
    const Scalar z1121 = z920 + z884 * z1118 - z902 * z1117;
    const Scalar z1150 = n0_04 * z956;
    const Scalar z1151 = n0_04 * z957;
    const Scalar z1152 = z710 * z1150 - z961 - z947 * z1151;
    const Scalar z1153 = z712 * z1150 - z962 - z949 * z1151;
    const Scalar z1154 = z723 * z1150 - z963 - z951 * z1151;
    const Scalar z1155 = n0_09 * z965;
    const Scalar z1158 = z973 - z1155;
    const Scalar z1156 = n0_09 * z967;
    const Scalar z1159 = z974 - z1156;
    const Scalar z1157 = n0_09 * z969;
    const Scalar z1133 = n0_2 * z925;
    const Scalar z1122 = n0_1 * z925;
    const Scalar z1125 = z933 - z1122;
    const Scalar z1136 = z933 - z1133;
    const Scalar z1134 = n0_2 * z927;
    const Scalar z1123 = n0_1 * z927;
    const Scalar z1126 = z934 - z1123;
    const Scalar z1137 = z934 - z1134;
    const Scalar z1135 = n0_2 * z929;
    const Scalar z1124 = n0_1 * z929;
    const Scalar z1127 = z935 - z1124;
    const Scalar z1138 = z935 - z1135;
    const Scalar z1128 = n0_1 * z939;
    const Scalar z1139 = n0_2 * z939;
    const Scalar z1129 = n0_1 * z938;
    const Scalar z1140 = n0_2 * z938;
    const Scalar z1130 = z924 * z1128 - z943 + z880 * z1129;
    const Scalar z1141 = z924 * z1139 - z943 + z880 * z1140;
    const Scalar z1131 = z926 * z1128 - z944 + z882 * z1129;
    const Scalar z1132 = z928 * z1128 - z945 + z884 * z1129;
    const Scalar z1142 = z926 * z1139 - z944 + z882 * z1140;
    const Scalar z1143 = z928 * z1139 - z945 + z884 * z1140;
    const Scalar z1100 = n0_04 * z880;
    const Scalar z1103 = z886 + z1100;
    const Scalar z1160 = z975 - z1157;
    const Scalar z1101 = n0_04 * z882;
    const Scalar z1104 = z887 + z1101;
    const Scalar z1161 = n0_09 * z980;
    const Scalar z1102 = n0_04 * z884;
    const Scalar z1105 = z888 + z1102;
    const Scalar z1191 = z794 + z1045;
    const Scalar z1192 = z795 + z1046;
    const Scalar z1193 = z796 + z1047;
    const Scalar z1197 = z768 - z1191;
    const Scalar z1198 = z769 - z1192;
    const Scalar z1199 = z770 - z1193;
    const Scalar z1162 = n0_09 * z978;
    const Scalar z1163 = z946 * z1162 - z984 - z964 * z1161;
    const Scalar z1164 = z948 * z1162 - z985 - z966 * z1161;
    const Scalar z1165 = z950 * z1162 - z986 - z968 * z1161;
    const Scalar z1188 = z736 * z1047 - z738 * z1046;
    const Scalar z1189 = z734 * z1047 - z738 * z1045;
    const Scalar z1190 = z734 * z1046 - z736 * z1045;
    const Scalar z1194 = z736 * z1193 - z738 * z1192;
    const Scalar z1195 = z734 * z1193 - z738 * z1191;
    const Scalar z1196 = z734 * z1192 - z736 * z1191;
    const Scalar z1200 = z712 * z1199 - z723 * z1198;
    const Scalar z1201 = z710 * z1199 - z723 * z1197;
    const Scalar z1202 = z710 * z1198 - z712 * z1197;
    const Scalar z1203 = z741 + z1197;
    const Scalar z1177 = n0_2 * z991;
    const Scalar z1166 = n0_1 * z991;
    const Scalar z1169 = z999 - z1166;
    const Scalar z1180 = z999 - z1177;
    const Scalar z1178 = n0_2 * z993;
    const Scalar z1167 = n0_1 * z993;
    const Scalar z1170 = z1000 - z1167;
    const Scalar z1181 = z1000 - z1178;
    const Scalar z1179 = n0_2 * z995;
    const Scalar z1168 = n0_1 * z995;
    const Scalar z1171 = z1001 - z1168;
    const Scalar z1182 = z1001 - z1179;
    const Scalar z1172 = n0_1 * z1005;
    const Scalar z1183 = n0_2 * z1005;
    const Scalar z1173 = n0_1 * z1004;
    const Scalar z1184 = n0_2 * z1004;
    const Scalar z1174 = z990 * z1172 - z1009 + z946 * z1173;
    const Scalar z1185 = z990 * z1183 - z1009 + z946 * z1184;
    const Scalar z1175 = z992 * z1172 - z1010 + z948 * z1173;
    const Scalar z1176 = z994 * z1172 - z1011 + z950 * z1173;
    const Scalar z1186 = z992 * z1183 - z1010 + z948 * z1184;
    const Scalar z1187 = z994 * z1183 - z1011 + z950 * z1184;
    const Scalar z1144 = n0_04 * z946;
    const Scalar z1147 = z952 - z1144;
    const Scalar z1204 = z743 + z1198;
    const Scalar z1145 = n0_04 * z948;
    const Scalar z1148 = z953 - z1145;
    const Scalar z1205 = z745 + z1199;
    const Scalar z1146 = n0_04 * z950;
    const Scalar z1149 = z954 - z1146;
    const Scalar z1218 = z864 + z1089;
    const Scalar z1219 = z865 + z1090;
    const Scalar z1220 = z866 + z1091;
    const Scalar z1245 = z930 + z1133;
    const Scalar z1246 = z931 + z1134;
    const Scalar z1247 = z932 + z1135;
    const Scalar z1224 = z838 + z1218;
    const Scalar z1225 = z839 + z1219;
    const Scalar z1226 = z840 + z1220;
    const Scalar z1251 = z904 - z1245;
    const Scalar z1252 = z905 - z1246;
    const Scalar z1253 = z906 - z1247;
    const Scalar z1206 = z718 * z1205 - z722 * z1204;
    const Scalar z1207 = z722 * z1203 - z724 * z1205;
    const Scalar z1208 = z718 * z1203 - z724 * z1204;
    const Scalar z1209 = z717 * z1205 - z719 * z1204;
    const Scalar z1210 = z711 * z1205 - z719 * z1203;
    const Scalar z1211 = z711 * z1204 - z717 * z1203;
    const Scalar z1212 = z712 * z1205 - z723 * z1204;
    const Scalar z1213 = z710 * z1205 - z723 * z1203;
    const Scalar z1214 = z710 * z1204 - z712 * z1203;
    const Scalar z1272 = z996 + z1177;
    const Scalar z1273 = z997 + z1178;
    const Scalar z1274 = z998 + z1179;
    const Scalar z1215 = z812 * z1091 - z814 * z1090;
    const Scalar z1216 = z810 * z1091 - z814 * z1089;
    const Scalar z1217 = z810 * z1090 - z812 * z1089;
    const Scalar z1278 = z970 + z1272;
    const Scalar z1279 = z971 + z1273;
    const Scalar z1280 = z972 + z1274;
    const Scalar z1221 = z812 * z1220 - z814 * z1219;
    const Scalar z1222 = z810 * z1220 - z814 * z1218;
    const Scalar z1223 = z810 * z1219 - z812 * z1218;
    const Scalar z1284 = z741 + z1278;
    const Scalar z1285 = z743 + z1279;
    const Scalar z1286 = z745 + z1280;
    const Scalar z1227 = z712 * z1226 - z723 * z1225;
    const Scalar z1228 = z710 * z1226 - z723 * z1224;
    const Scalar z1232 = z818 - z1226;
    const Scalar z1259 = z818 - z1253;
    const Scalar z1229 = z710 * z1225 - z712 * z1224;
    const Scalar z1230 = z816 - z1224;
    const Scalar z1231 = z817 + z1225;
    const Scalar z1257 = z816 - z1251;
    const Scalar z1258 = z817 + z1252;
    const Scalar z1233 = z718 * z1232 + z722 * z1231;
    const Scalar z1234 = z722 * z1230 - z724 * z1232;
    const Scalar z1235 = z718 * z1230 + z724 * z1231;
    const Scalar z1236 = z717 * z1232 + z719 * z1231;
    const Scalar z1237 = z711 * z1232 - z719 * z1230;
    const Scalar z1238 = z711 * z1231 + z717 * z1230;
    const Scalar z1239 = z712 * z1232 + z723 * z1231;
    const Scalar z1240 = z710 * z1232 - z723 * z1230;
    const Scalar z1241 = z710 * z1231 + z712 * z1230;
    const Scalar z1242 = z882 * z1135 - z884 * z1134;
    const Scalar z1243 = z880 * z1135 - z884 * z1133;
    const Scalar z1244 = z880 * z1134 - z882 * z1133;
    const Scalar z1248 = z882 * z1247 - z884 * z1246;
    const Scalar z1249 = z880 * z1247 - z884 * z1245;
    const Scalar z1250 = z880 * z1246 - z882 * z1245;
    const Scalar z1254 = z712 * z1253 - z723 * z1252;
    const Scalar z1255 = z710 * z1253 - z723 * z1251;
    const Scalar z1256 = z710 * z1252 - z712 * z1251;
    const Scalar z1260 = z718 * z1259 + z722 * z1258;
    const Scalar z1261 = z722 * z1257 - z724 * z1259;
    const Scalar z1262 = z718 * z1257 + z724 * z1258;
    const Scalar z1263 = z717 * z1259 + z719 * z1258;
    const Scalar z1264 = z711 * z1259 - z719 * z1257;
    const Scalar z1265 = z711 * z1258 + z717 * z1257;
    const Scalar z1266 = z712 * z1259 + z723 * z1258;
    const Scalar z1267 = z710 * z1259 - z723 * z1257;
    const Scalar z1268 = z710 * z1258 + z712 * z1257;
    const Scalar z1269 = z948 * z1179 - z950 * z1178;
    const Scalar z1270 = z946 * z1179 - z950 * z1177;
    const Scalar z1271 = z946 * z1178 - z948 * z1177;
    const Scalar z1275 = z948 * z1274 - z950 * z1273;
    const Scalar z1276 = z946 * z1274 - z950 * z1272;
    const Scalar z1277 = z946 * z1273 - z948 * z1272;
    const Scalar z1281 = z712 * z1280 - z723 * z1279;
    const Scalar z1282 = z710 * z1280 - z723 * z1278;
    const Scalar z1283 = z710 * z1279 - z712 * z1278;
    const Scalar z1287 = z718 * z1286 - z722 * z1285;
    const Scalar z1288 = z722 * z1284 - z724 * z1286;
    const Scalar z1289 = z718 * z1284 - z724 * z1285;
    const Scalar z1290 = z717 * z1286 - z719 * z1285;
    const Scalar z1291 = z711 * z1286 - z719 * z1284;
    const Scalar z1292 = z711 * z1285 - z717 * z1284;
    const Scalar z1293 = z712 * z1286 - z723 * z1285;
    const Scalar z1294 = z710 * z1286 - z723 * z1284;
    const Scalar z1295 = z710 * z1285 - z712 * z1284;
    result.trunk_position[0] = q_trunk_x;
    result.trunk_position[1] = q_trunk_y;
    result.trunk_position[2] = q_trunk_z;
    result.trunk_rotation[0] = z710;
    result.trunk_rotation[1] = z712;
    result.trunk_rotation[2] = z723;
    result.trunk_rotation[3] = z711;
    result.trunk_rotation[4] = z717;
    result.trunk_rotation[5] = z719;
    result.trunk_rotation[6] = z724;
    result.trunk_rotation[7] = z718;
    result.trunk_rotation[8] = z722;
    result.trunk_velocity[0] = v_trunk_x;
    result.trunk_velocity[1] = v_trunk_y;
    result.trunk_velocity[2] = v_trunk_z;
    result.trunk_angular_velocity[0] = z731;
    result.trunk_angular_velocity[1] = z732;
    result.trunk_angular_velocity[2] = z733;
    result.front_left_hip_link_position[0] = z1015;
    result.front_left_hip_link_position[1] = z1016;
    result.front_left_hip_link_position[2] = z1017;
    result.front_left_hip_link_rotation[0] = z710;
    result.front_left_hip_link_rotation[1] = z712;
    result.front_left_hip_link_rotation[2] = z723;
    result.front_left_hip_link_rotation[3] = z734;
    result.front_left_hip_link_rotation[4] = z736;
    result.front_left_hip_link_rotation[5] = z738;
    result.front_left_hip_link_rotation[6] = -z735;
    result.front_left_hip_link_rotation[7] = -z737;
    result.front_left_hip_link_rotation[8] = -z739;
    result.front_left_hip_link_velocity[0] = z1020;
    result.front_left_hip_link_velocity[1] = z1021;
    result.front_left_hip_link_velocity[2] = z1022;
    result.front_left_hip_link_angular_velocity[0] = z756;
    result.front_left_hip_link_angular_velocity[1] = z757;
    result.front_left_hip_link_angular_velocity[2] = z758;
    result.front_left_thigh_link_position[0] = z1026;
    result.front_left_thigh_link_position[1] = z1027;
    result.front_left_thigh_link_position[2] = z1028;
    result.front_left_thigh_link_rotation[0] = z762;
    result.front_left_thigh_link_rotation[1] = z764;
    result.front_left_thigh_link_rotation[2] = z766;
    result.front_left_thigh_link_rotation[3] = z734;
    result.front_left_thigh_link_rotation[4] = z736;
    result.front_left_thigh_link_rotation[5] = z738;
    result.front_left_thigh_link_rotation[6] = z763;
    result.front_left_thigh_link_rotation[7] = z765;
    result.front_left_thigh_link_rotation[8] = z767;
    result.front_left_thigh_link_velocity[0] = z1031;
    result.front_left_thigh_link_velocity[1] = z1032;
    result.front_left_thigh_link_velocity[2] = z1033;
    result.front_left_thigh_link_angular_velocity[0] = z779;
    result.front_left_thigh_link_angular_velocity[1] = z780;
    result.front_left_thigh_link_angular_velocity[2] = z781;
    result.front_left_shank_link_position[0] = z1037;
    result.front_left_shank_link_position[1] = z1038;
    result.front_left_shank_link_position[2] = z1039;
    result.front_left_shank_link_rotation[0] = z788;
    result.front_left_shank_link_rotation[1] = z790;
    result.front_left_shank_link_rotation[2] = z792;
    result.front_left_shank_link_rotation[3] = z734;
    result.front_left_shank_link_rotation[4] = z736;
    result.front_left_shank_link_rotation[5] = z738;
    result.front_left_shank_link_rotation[6] = z789;
    result.front_left_shank_link_rotation[7] = z791;
    result.front_left_shank_link_rotation[8] = z793;
    result.front_left_shank_link_velocity[0] = -z1042;
    result.front_left_shank_link_velocity[1] = -z1043;
    result.front_left_shank_link_velocity[2] = -z1044;
    result.front_left_shank_link_angular_velocity[0] = z804;
    result.front_left_shank_link_angular_velocity[1] = z805;
    result.front_left_shank_link_angular_velocity[2] = z806;
    result.front_left_foot_position[0] = z1048;
    result.front_left_foot_position[1] = z1049;
    result.front_left_foot_position[2] = z1050;
    result.front_left_foot_rotation[0] = z788;
    result.front_left_foot_rotation[1] = z790;
    result.front_left_foot_rotation[2] = z792;
    result.front_left_foot_rotation[3] = z734;
    result.front_left_foot_rotation[4] = z736;
    result.front_left_foot_rotation[5] = z738;
    result.front_left_foot_rotation[6] = z789;
    result.front_left_foot_rotation[7] = z791;
    result.front_left_foot_rotation[8] = z793;
    result.front_left_foot_velocity[0] = -z1053;
    result.front_left_foot_velocity[1] = -z1054;
    result.front_left_foot_velocity[2] = -z1055;
    result.front_left_foot_angular_velocity[0] = z804;
    result.front_left_foot_angular_velocity[1] = z805;
    result.front_left_foot_angular_velocity[2] = z806;
    result.front_right_hip_link_position[0] = z1059;
    result.front_right_hip_link_position[1] = z1060;
    result.front_right_hip_link_position[2] = z1061;
    result.front_right_hip_link_rotation[0] = z710;
    result.front_right_hip_link_rotation[1] = z712;
    result.front_right_hip_link_rotation[2] = z723;
    result.front_right_hip_link_rotation[3] = z810;
    result.front_right_hip_link_rotation[4] = z812;
    result.front_right_hip_link_rotation[5] = z814;
    result.front_right_hip_link_rotation[6] = -z811;
    result.front_right_hip_link_rotation[7] = -z813;
    result.front_right_hip_link_rotation[8] = -z815;
    result.front_right_hip_link_velocity[0] = -z1064;
    result.front_right_hip_link_velocity[1] = -z1065;
    result.front_right_hip_link_velocity[2] = -z1066;
    result.front_right_hip_link_angular_velocity[0] = z826;
    result.front_right_hip_link_angular_velocity[1] = z827;
    result.front_right_hip_link_angular_velocity[2] = z828;
    result.front_right_thigh_link_position[0] = z1070;
    result.front_right_thigh_link_position[1] = z1071;
    result.front_right_thigh_link_position[2] = z1072;
    result.front_right_thigh_link_rotation[0] = z832;
    result.front_right_thigh_link_rotation[1] = z834;
    result.front_right_thigh_link_rotation[2] = z836;
    result.front_right_thigh_link_rotation[3] = z810;
    result.front_right_thigh_link_rotation[4] = z812;
    result.front_right_thigh_link_rotation[5] = z814;
    result.front_right_thigh_link_rotation[6] = z833;
    result.front_right_thigh_link_rotation[7] = z835;
    result.front_right_thigh_link_rotation[8] = z837;
    result.front_right_thigh_link_velocity[0] = z1075;
    result.front_right_thigh_link_velocity[1] = z1076;
    result.front_right_thigh_link_velocity[2] = z1077;
    result.front_right_thigh_link_angular_velocity[0] = z849;
    result.front_right_thigh_link_angular_velocity[1] = z850;
    result.front_right_thigh_link_angular_velocity[2] = z851;
    result.front_right_shank_link_position[0] = z1081;
    result.front_right_shank_link_position[1] = z1082;
    result.front_right_shank_link_position[2] = z1083;
    result.front_right_shank_link_rotation[0] = z858;
    result.front_right_shank_link_rotation[1] = z860;
    result.front_right_shank_link_rotation[2] = z862;
    result.front_right_shank_link_rotation[3] = z810;
    result.front_right_shank_link_rotation[4] = z812;
    result.front_right_shank_link_rotation[5] = z814;
    result.front_right_shank_link_rotation[6] = z859;
    result.front_right_shank_link_rotation[7] = z861;
    result.front_right_shank_link_rotation[8] = z863;
    result.front_right_shank_link_velocity[0] = -z1086;
    result.front_right_shank_link_velocity[1] = -z1087;
    result.front_right_shank_link_velocity[2] = -z1088;
    result.front_right_shank_link_angular_velocity[0] = z874;
    result.front_right_shank_link_angular_velocity[1] = z875;
    result.front_right_shank_link_angular_velocity[2] = z876;
    result.front_right_foot_position[0] = z1092;
    result.front_right_foot_position[1] = z1093;
    result.front_right_foot_position[2] = z1094;
    result.front_right_foot_rotation[0] = z858;
    result.front_right_foot_rotation[1] = z860;
    result.front_right_foot_rotation[2] = z862;
    result.front_right_foot_rotation[3] = z810;
    result.front_right_foot_rotation[4] = z812;
    result.front_right_foot_rotation[5] = z814;
    result.front_right_foot_rotation[6] = z859;
    result.front_right_foot_rotation[7] = z861;
    result.front_right_foot_rotation[8] = z863;
    result.front_right_foot_velocity[0] = -z1097;
    result.front_right_foot_velocity[1] = -z1098;
    result.front_right_foot_velocity[2] = -z1099;
    result.front_right_foot_angular_velocity[0] = z874;
    result.front_right_foot_angular_velocity[1] = z875;
    result.front_right_foot_angular_velocity[2] = z876;
    result.rear_left_hip_link_position[0] = z1103;
    result.rear_left_hip_link_position[1] = z1104;
    result.rear_left_hip_link_position[2] = z1105;
    result.rear_left_hip_link_rotation[0] = z710;
    result.rear_left_hip_link_rotation[1] = z712;
    result.rear_left_hip_link_rotation[2] = z723;
    result.rear_left_hip_link_rotation[3] = z880;
    result.rear_left_hip_link_rotation[4] = z882;
    result.rear_left_hip_link_rotation[5] = z884;
    result.rear_left_hip_link_rotation[6] = -z881;
    result.rear_left_hip_link_rotation[7] = -z883;
    result.rear_left_hip_link_rotation[8] = -z885;
    result.rear_left_hip_link_velocity[0] = z1108;
    result.rear_left_hip_link_velocity[1] = z1109;
    result.rear_left_hip_link_velocity[2] = z1110;
    result.rear_left_hip_link_angular_velocity[0] = z892;
    result.rear_left_hip_link_angular_velocity[1] = z893;
    result.rear_left_hip_link_angular_velocity[2] = z894;
    result.rear_left_thigh_link_position[0] = z1114;
    result.rear_left_thigh_link_position[1] = z1115;
    result.rear_left_thigh_link_position[2] = z1116;
    result.rear_left_thigh_link_rotation[0] = z898;
    result.rear_left_thigh_link_rotation[1] = z900;
    result.rear_left_thigh_link_rotation[2] = z902;
    result.rear_left_thigh_link_rotation[3] = z880;
    result.rear_left_thigh_link_rotation[4] = z882;
    result.rear_left_thigh_link_rotation[5] = z884;
    result.rear_left_thigh_link_rotation[6] = z899;
    result.rear_left_thigh_link_rotation[7] = z901;
    result.rear_left_thigh_link_rotation[8] = z903;
    result.rear_left_thigh_link_velocity[0] = z1119;
    result.rear_left_thigh_link_velocity[1] = z1120;
    result.rear_left_thigh_link_velocity[2] = z1121;
    result.rear_left_thigh_link_angular_velocity[0] = z915;
    result.rear_left_thigh_link_angular_velocity[1] = z916;
    result.rear_left_thigh_link_angular_velocity[2] = z917;
    result.rear_left_shank_link_position[0] = z1125;
    result.rear_left_shank_link_position[1] = z1126;
    result.rear_left_shank_link_position[2] = z1127;
    result.rear_left_shank_link_rotation[0] = z924;
    result.rear_left_shank_link_rotation[1] = z926;
    result.rear_left_shank_link_rotation[2] = z928;
    result.rear_left_shank_link_rotation[3] = z880;
    result.rear_left_shank_link_rotation[4] = z882;
    result.rear_left_shank_link_rotation[5] = z884;
    result.rear_left_shank_link_rotation[6] = z925;
    result.rear_left_shank_link_rotation[7] = z927;
    result.rear_left_shank_link_rotation[8] = z929;
    result.rear_left_shank_link_velocity[0] = -z1130;
    result.rear_left_shank_link_velocity[1] = -z1131;
    result.rear_left_shank_link_velocity[2] = -z1132;
    result.rear_left_shank_link_angular_velocity[0] = z940;
    result.rear_left_shank_link_angular_velocity[1] = z941;
    result.rear_left_shank_link_angular_velocity[2] = z942;
    result.rear_left_foot_position[0] = z1136;
    result.rear_left_foot_position[1] = z1137;
    result.rear_left_foot_position[2] = z1138;
    result.rear_left_foot_rotation[0] = z924;
    result.rear_left_foot_rotation[1] = z926;
    result.rear_left_foot_rotation[2] = z928;
    result.rear_left_foot_rotation[3] = z880;
    result.rear_left_foot_rotation[4] = z882;
    result.rear_left_foot_rotation[5] = z884;
    result.rear_left_foot_rotation[6] = z925;
    result.rear_left_foot_rotation[7] = z927;
    result.rear_left_foot_rotation[8] = z929;
    result.rear_left_foot_velocity[0] = -z1141;
    result.rear_left_foot_velocity[1] = -z1142;
    result.rear_left_foot_velocity[2] = -z1143;
    result.rear_left_foot_angular_velocity[0] = z940;
    result.rear_left_foot_angular_velocity[1] = z941;
    result.rear_left_foot_angular_velocity[2] = z942;
    result.rear_right_hip_link_position[0] = z1147;
    result.rear_right_hip_link_position[1] = z1148;
    result.rear_right_hip_link_position[2] = z1149;
    result.rear_right_hip_link_rotation[0] = z710;
    result.rear_right_hip_link_rotation[1] = z712;
    result.rear_right_hip_link_rotation[2] = z723;
    result.rear_right_hip_link_rotation[3] = z946;
    result.rear_right_hip_link_rotation[4] = z948;
    result.rear_right_hip_link_rotation[5] = z950;
    result.rear_right_hip_link_rotation[6] = -z947;
    result.rear_right_hip_link_rotation[7] = -z949;
    result.rear_right_hip_link_rotation[8] = -z951;
    result.rear_right_hip_link_velocity[0] = -z1152;
    result.rear_right_hip_link_velocity[1] = -z1153;
    result.rear_right_hip_link_velocity[2] = -z1154;
    result.rear_right_hip_link_angular_velocity[0] = z958;
    result.rear_right_hip_link_angular_velocity[1] = z959;
    result.rear_right_hip_link_angular_velocity[2] = z960;
    result.rear_right_thigh_link_position[0] = z1158;
    result.rear_right_thigh_link_position[1] = z1159;
    result.rear_right_thigh_link_position[2] = z1160;
    result.rear_right_thigh_link_rotation[0] = z964;
    result.rear_right_thigh_link_rotation[1] = z966;
    result.rear_right_thigh_link_rotation[2] = z968;
    result.rear_right_thigh_link_rotation[3] = z946;
    result.rear_right_thigh_link_rotation[4] = z948;
    result.rear_right_thigh_link_rotation[5] = z950;
    result.rear_right_thigh_link_rotation[6] = z965;
    result.rear_right_thigh_link_rotation[7] = z967;
    result.rear_right_thigh_link_rotation[8] = z969;
    result.rear_right_thigh_link_velocity[0] = z1163;
    result.rear_right_thigh_link_velocity[1] = z1164;
    result.rear_right_thigh_link_velocity[2] = z1165;
    result.rear_right_thigh_link_angular_velocity[0] = z981;
    result.rear_right_thigh_link_angular_velocity[1] = z982;
    result.rear_right_thigh_link_angular_velocity[2] = z983;
    result.rear_right_shank_link_position[0] = z1169;
    result.rear_right_shank_link_position[1] = z1170;
    result.rear_right_shank_link_position[2] = z1171;
    result.rear_right_shank_link_rotation[0] = z990;
    result.rear_right_shank_link_rotation[1] = z992;
    result.rear_right_shank_link_rotation[2] = z994;
    result.rear_right_shank_link_rotation[3] = z946;
    result.rear_right_shank_link_rotation[4] = z948;
    result.rear_right_shank_link_rotation[5] = z950;
    result.rear_right_shank_link_rotation[6] = z991;
    result.rear_right_shank_link_rotation[7] = z993;
    result.rear_right_shank_link_rotation[8] = z995;
    result.rear_right_shank_link_velocity[0] = -z1174;
    result.rear_right_shank_link_velocity[1] = -z1175;
    result.rear_right_shank_link_velocity[2] = -z1176;
    result.rear_right_shank_link_angular_velocity[0] = z1006;
    result.rear_right_shank_link_angular_velocity[1] = z1007;
    result.rear_right_shank_link_angular_velocity[2] = z1008;
    result.rear_right_foot_position[0] = z1180;
    result.rear_right_foot_position[1] = z1181;
    result.rear_right_foot_position[2] = z1182;
    result.rear_right_foot_rotation[0] = z990;
    result.rear_right_foot_rotation[1] = z992;
    result.rear_right_foot_rotation[2] = z994;
    result.rear_right_foot_rotation[3] = z946;
    result.rear_right_foot_rotation[4] = z948;
    result.rear_right_foot_rotation[5] = z950;
    result.rear_right_foot_rotation[6] = z991;
    result.rear_right_foot_rotation[7] = z993;
    result.rear_right_foot_rotation[8] = z995;
    result.rear_right_foot_velocity[0] = -z1185;
    result.rear_right_foot_velocity[1] = -z1186;
    result.rear_right_foot_velocity[2] = -z1187;
    result.rear_right_foot_angular_velocity[0] = z1006;
    result.rear_right_foot_angular_velocity[1] = z1007;
    result.rear_right_foot_angular_velocity[2] = z1008;
    result.front_left_foot_origin_position[0] = z1048;
    result.front_left_foot_origin_position[1] = z1049;
    result.front_left_foot_origin_position[2] = z1050;
    result.front_left_foot_origin_velocity[0] = -z1053;
    result.front_left_foot_origin_velocity[1] = -z1054;
    result.front_left_foot_origin_velocity[2] = -z1055;
    result.front_left_foot_origin_jacobian[0] = n1;
    result.front_left_foot_origin_jacobian[3] = n0;
    result.front_left_foot_origin_jacobian[6] = n0;
    result.front_left_foot_origin_jacobian[9] = z1212;
    result.front_left_foot_origin_jacobian[12] = z1209;
    result.front_left_foot_origin_jacobian[15] = z1206;
    result.front_left_foot_origin_jacobian[18] = z1200;
    result.front_left_foot_origin_jacobian[21] = -z1194;
    result.front_left_foot_origin_jacobian[24] = -z1188;
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
    result.front_left_foot_origin_jacobian[10] = -z1213;
    result.front_left_foot_origin_jacobian[13] = -z1210;
    result.front_left_foot_origin_jacobian[16] = z1207;
    result.front_left_foot_origin_jacobian[19] = -z1201;
    result.front_left_foot_origin_jacobian[22] = z1195;
    result.front_left_foot_origin_jacobian[25] = z1189;
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
    result.front_left_foot_origin_jacobian[11] = z1214;
    result.front_left_foot_origin_jacobian[14] = z1211;
    result.front_left_foot_origin_jacobian[17] = -z1208;
    result.front_left_foot_origin_jacobian[20] = z1202;
    result.front_left_foot_origin_jacobian[23] = -z1196;
    result.front_left_foot_origin_jacobian[26] = -z1190;
    result.front_left_foot_origin_jacobian[29] = n0;
    result.front_left_foot_origin_jacobian[32] = n0;
    result.front_left_foot_origin_jacobian[35] = n0;
    result.front_left_foot_origin_jacobian[38] = n0;
    result.front_left_foot_origin_jacobian[41] = n0;
    result.front_left_foot_origin_jacobian[44] = n0;
    result.front_left_foot_origin_jacobian[47] = n0;
    result.front_left_foot_origin_jacobian[50] = n0;
    result.front_left_foot_origin_jacobian[53] = n0;
    result.front_right_foot_origin_position[0] = z1092;
    result.front_right_foot_origin_position[1] = z1093;
    result.front_right_foot_origin_position[2] = z1094;
    result.front_right_foot_origin_velocity[0] = -z1097;
    result.front_right_foot_origin_velocity[1] = -z1098;
    result.front_right_foot_origin_velocity[2] = -z1099;
    result.front_right_foot_origin_jacobian[0] = n1;
    result.front_right_foot_origin_jacobian[3] = n0;
    result.front_right_foot_origin_jacobian[6] = n0;
    result.front_right_foot_origin_jacobian[9] = z1239;
    result.front_right_foot_origin_jacobian[12] = z1236;
    result.front_right_foot_origin_jacobian[15] = z1233;
    result.front_right_foot_origin_jacobian[18] = n0;
    result.front_right_foot_origin_jacobian[21] = n0;
    result.front_right_foot_origin_jacobian[24] = n0;
    result.front_right_foot_origin_jacobian[27] = -z1227;
    result.front_right_foot_origin_jacobian[30] = -z1221;
    result.front_right_foot_origin_jacobian[33] = -z1215;
    result.front_right_foot_origin_jacobian[36] = n0;
    result.front_right_foot_origin_jacobian[39] = n0;
    result.front_right_foot_origin_jacobian[42] = n0;
    result.front_right_foot_origin_jacobian[45] = n0;
    result.front_right_foot_origin_jacobian[48] = n0;
    result.front_right_foot_origin_jacobian[51] = n0;
    result.front_right_foot_origin_jacobian[1] = n0;
    result.front_right_foot_origin_jacobian[4] = n1;
    result.front_right_foot_origin_jacobian[7] = n0;
    result.front_right_foot_origin_jacobian[10] = -z1240;
    result.front_right_foot_origin_jacobian[13] = -z1237;
    result.front_right_foot_origin_jacobian[16] = z1234;
    result.front_right_foot_origin_jacobian[19] = n0;
    result.front_right_foot_origin_jacobian[22] = n0;
    result.front_right_foot_origin_jacobian[25] = n0;
    result.front_right_foot_origin_jacobian[28] = z1228;
    result.front_right_foot_origin_jacobian[31] = z1222;
    result.front_right_foot_origin_jacobian[34] = z1216;
    result.front_right_foot_origin_jacobian[37] = n0;
    result.front_right_foot_origin_jacobian[40] = n0;
    result.front_right_foot_origin_jacobian[43] = n0;
    result.front_right_foot_origin_jacobian[46] = n0;
    result.front_right_foot_origin_jacobian[49] = n0;
    result.front_right_foot_origin_jacobian[52] = n0;
    result.front_right_foot_origin_jacobian[2] = n0;
    result.front_right_foot_origin_jacobian[5] = n0;
    result.front_right_foot_origin_jacobian[8] = n1;
    result.front_right_foot_origin_jacobian[11] = -z1241;
    result.front_right_foot_origin_jacobian[14] = -z1238;
    result.front_right_foot_origin_jacobian[17] = -z1235;
    result.front_right_foot_origin_jacobian[20] = n0;
    result.front_right_foot_origin_jacobian[23] = n0;
    result.front_right_foot_origin_jacobian[26] = n0;
    result.front_right_foot_origin_jacobian[29] = -z1229;
    result.front_right_foot_origin_jacobian[32] = -z1223;
    result.front_right_foot_origin_jacobian[35] = -z1217;
    result.front_right_foot_origin_jacobian[38] = n0;
    result.front_right_foot_origin_jacobian[41] = n0;
    result.front_right_foot_origin_jacobian[44] = n0;
    result.front_right_foot_origin_jacobian[47] = n0;
    result.front_right_foot_origin_jacobian[50] = n0;
    result.front_right_foot_origin_jacobian[53] = n0;
    result.rear_left_foot_origin_position[0] = z1136;
    result.rear_left_foot_origin_position[1] = z1137;
    result.rear_left_foot_origin_position[2] = z1138;
    result.rear_left_foot_origin_velocity[0] = -z1141;
    result.rear_left_foot_origin_velocity[1] = -z1142;
    result.rear_left_foot_origin_velocity[2] = -z1143;
    result.rear_left_foot_origin_jacobian[0] = n1;
    result.rear_left_foot_origin_jacobian[3] = n0;
    result.rear_left_foot_origin_jacobian[6] = n0;
    result.rear_left_foot_origin_jacobian[9] = -z1266;
    result.rear_left_foot_origin_jacobian[12] = -z1263;
    result.rear_left_foot_origin_jacobian[15] = -z1260;
    result.rear_left_foot_origin_jacobian[18] = n0;
    result.rear_left_foot_origin_jacobian[21] = n0;
    result.rear_left_foot_origin_jacobian[24] = n0;
    result.rear_left_foot_origin_jacobian[27] = n0;
    result.rear_left_foot_origin_jacobian[30] = n0;
    result.rear_left_foot_origin_jacobian[33] = n0;
    result.rear_left_foot_origin_jacobian[36] = z1254;
    result.rear_left_foot_origin_jacobian[39] = -z1248;
    result.rear_left_foot_origin_jacobian[42] = -z1242;
    result.rear_left_foot_origin_jacobian[45] = n0;
    result.rear_left_foot_origin_jacobian[48] = n0;
    result.rear_left_foot_origin_jacobian[51] = n0;
    result.rear_left_foot_origin_jacobian[1] = n0;
    result.rear_left_foot_origin_jacobian[4] = n1;
    result.rear_left_foot_origin_jacobian[7] = n0;
    result.rear_left_foot_origin_jacobian[10] = z1267;
    result.rear_left_foot_origin_jacobian[13] = z1264;
    result.rear_left_foot_origin_jacobian[16] = -z1261;
    result.rear_left_foot_origin_jacobian[19] = n0;
    result.rear_left_foot_origin_jacobian[22] = n0;
    result.rear_left_foot_origin_jacobian[25] = n0;
    result.rear_left_foot_origin_jacobian[28] = n0;
    result.rear_left_foot_origin_jacobian[31] = n0;
    result.rear_left_foot_origin_jacobian[34] = n0;
    result.rear_left_foot_origin_jacobian[37] = -z1255;
    result.rear_left_foot_origin_jacobian[40] = z1249;
    result.rear_left_foot_origin_jacobian[43] = z1243;
    result.rear_left_foot_origin_jacobian[46] = n0;
    result.rear_left_foot_origin_jacobian[49] = n0;
    result.rear_left_foot_origin_jacobian[52] = n0;
    result.rear_left_foot_origin_jacobian[2] = n0;
    result.rear_left_foot_origin_jacobian[5] = n0;
    result.rear_left_foot_origin_jacobian[8] = n1;
    result.rear_left_foot_origin_jacobian[11] = z1268;
    result.rear_left_foot_origin_jacobian[14] = z1265;
    result.rear_left_foot_origin_jacobian[17] = z1262;
    result.rear_left_foot_origin_jacobian[20] = n0;
    result.rear_left_foot_origin_jacobian[23] = n0;
    result.rear_left_foot_origin_jacobian[26] = n0;
    result.rear_left_foot_origin_jacobian[29] = n0;
    result.rear_left_foot_origin_jacobian[32] = n0;
    result.rear_left_foot_origin_jacobian[35] = n0;
    result.rear_left_foot_origin_jacobian[38] = z1256;
    result.rear_left_foot_origin_jacobian[41] = -z1250;
    result.rear_left_foot_origin_jacobian[44] = -z1244;
    result.rear_left_foot_origin_jacobian[47] = n0;
    result.rear_left_foot_origin_jacobian[50] = n0;
    result.rear_left_foot_origin_jacobian[53] = n0;
    result.rear_right_foot_origin_position[0] = z1180;
    result.rear_right_foot_origin_position[1] = z1181;
    result.rear_right_foot_origin_position[2] = z1182;
    result.rear_right_foot_origin_velocity[0] = -z1185;
    result.rear_right_foot_origin_velocity[1] = -z1186;
    result.rear_right_foot_origin_velocity[2] = -z1187;
    result.rear_right_foot_origin_jacobian[0] = n1;
    result.rear_right_foot_origin_jacobian[3] = n0;
    result.rear_right_foot_origin_jacobian[6] = n0;
    result.rear_right_foot_origin_jacobian[9] = -z1293;
    result.rear_right_foot_origin_jacobian[12] = -z1290;
    result.rear_right_foot_origin_jacobian[15] = -z1287;
    result.rear_right_foot_origin_jacobian[18] = n0;
    result.rear_right_foot_origin_jacobian[21] = n0;
    result.rear_right_foot_origin_jacobian[24] = n0;
    result.rear_right_foot_origin_jacobian[27] = n0;
    result.rear_right_foot_origin_jacobian[30] = n0;
    result.rear_right_foot_origin_jacobian[33] = n0;
    result.rear_right_foot_origin_jacobian[36] = n0;
    result.rear_right_foot_origin_jacobian[39] = n0;
    result.rear_right_foot_origin_jacobian[42] = n0;
    result.rear_right_foot_origin_jacobian[45] = -z1281;
    result.rear_right_foot_origin_jacobian[48] = -z1275;
    result.rear_right_foot_origin_jacobian[51] = -z1269;
    result.rear_right_foot_origin_jacobian[1] = n0;
    result.rear_right_foot_origin_jacobian[4] = n1;
    result.rear_right_foot_origin_jacobian[7] = n0;
    result.rear_right_foot_origin_jacobian[10] = z1294;
    result.rear_right_foot_origin_jacobian[13] = z1291;
    result.rear_right_foot_origin_jacobian[16] = -z1288;
    result.rear_right_foot_origin_jacobian[19] = n0;
    result.rear_right_foot_origin_jacobian[22] = n0;
    result.rear_right_foot_origin_jacobian[25] = n0;
    result.rear_right_foot_origin_jacobian[28] = n0;
    result.rear_right_foot_origin_jacobian[31] = n0;
    result.rear_right_foot_origin_jacobian[34] = n0;
    result.rear_right_foot_origin_jacobian[37] = n0;
    result.rear_right_foot_origin_jacobian[40] = n0;
    result.rear_right_foot_origin_jacobian[43] = n0;
    result.rear_right_foot_origin_jacobian[46] = z1282;
    result.rear_right_foot_origin_jacobian[49] = z1276;
    result.rear_right_foot_origin_jacobian[52] = z1270;
    result.rear_right_foot_origin_jacobian[2] = n0;
    result.rear_right_foot_origin_jacobian[5] = n0;
    result.rear_right_foot_origin_jacobian[8] = n1;
    result.rear_right_foot_origin_jacobian[11] = -z1295;
    result.rear_right_foot_origin_jacobian[14] = -z1292;
    result.rear_right_foot_origin_jacobian[17] = z1289;
    result.rear_right_foot_origin_jacobian[20] = n0;
    result.rear_right_foot_origin_jacobian[23] = n0;
    result.rear_right_foot_origin_jacobian[26] = n0;
    result.rear_right_foot_origin_jacobian[29] = n0;
    result.rear_right_foot_origin_jacobian[32] = n0;
    result.rear_right_foot_origin_jacobian[35] = n0;
    result.rear_right_foot_origin_jacobian[38] = n0;
    result.rear_right_foot_origin_jacobian[41] = n0;
    result.rear_right_foot_origin_jacobian[44] = n0;
    result.rear_right_foot_origin_jacobian[47] = -z1283;
    result.rear_right_foot_origin_jacobian[50] = -z1277;
    result.rear_right_foot_origin_jacobian[53] = -z1271;
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
    const Scalar z1822 = k0 * s_rear_right_knee;
    const Scalar z1823 = k0 * c_rear_right_knee;
    const Scalar z1803 = n0_032 * c_rear_right_knee;
    const Scalar z1804 = n0_032 * s_rear_right_knee;
    const Scalar z1782 = n2 * q_trunk_attitude_y;
    const Scalar z1784 = n2 * q_trunk_attitude_z;
    const Scalar z1783 = q_trunk_attitude_y * z1782;
    const Scalar z1785 = q_trunk_attitude_z * z1784;
    const Scalar z1786 = q_trunk_attitude_x * z1782;
    const Scalar z1787 = q_trunk_attitude_w * z1784;
    const Scalar z1791 = n2 * q_trunk_attitude_x;
    const Scalar z1798 = q_trunk_attitude_x * z1784;
    const Scalar z1799 = q_trunk_attitude_w * z1782;
    const Scalar z1788 = n1 - z1783 - z1785;
    const Scalar z1790 = z1786 + z1787;
    const Scalar z1792 = q_trunk_attitude_x * z1791;
    const Scalar z1793 = q_trunk_attitude_z * z1782;
    const Scalar z1794 = q_trunk_attitude_w * z1791;
    const Scalar z1801 = z1798 - z1799;
    const Scalar z1789 = z1786 - z1787;
    const Scalar z1795 = n1 - z1785 - z1792;
    const Scalar z1797 = z1793 + z1794;
    const Scalar z1800 = n1 - z1783 - z1792;
    const Scalar z1796 = z1793 - z1794;
    const Scalar z1802 = z1798 + z1799;
    const Scalar z1805 = k4 + n0_2 * z1803;
    const Scalar z1806 = s_rear_right_thigh * z1804;
    const Scalar z1808 = c_rear_right_thigh * z1804;
    const Scalar z1824 = c_rear_right_knee * z1823;
    const Scalar z1825 = s_rear_right_knee * z1822;
    const Scalar z1826 = s_rear_right_knee * z1823;
    const Scalar z1829 = k4 + n0_4 * z1803;
    const Scalar z1830 = n0_124 + z1803;
    const Scalar z1807 = c_rear_right_thigh * z1803 - z1806;
    const Scalar z1809 = s_rear_right_thigh * z1803 + z1808;
    const Scalar z1827 = n0_4 * z1803 - z1825;
    const Scalar z1828 = n0_2 * z1804 + z1826;
    const Scalar z1832 = k8 + z1824;
    const Scalar z1833 = c_rear_right_thigh * z1830 - z1806;
    const Scalar z1834 = s_rear_right_thigh * z1830 + z1808;
    const Scalar z1831 = k9 + z1829;
    const Scalar z1810 = n0_08 * z1809;
    const Scalar z1811 = n0_08 * z1807;
    const Scalar z1812 = s_rear_right_hip * z1809;
    const Scalar z1813 = c_rear_right_hip * z1809;
    const Scalar z1835 = n0_08 * z1834;
    const Scalar z1836 = n0_08 * z1833;
    const Scalar z1837 = s_rear_right_hip * z1834;
    const Scalar z1838 = c_rear_right_hip * z1834;
    const Scalar z1847 = z1827 + z1832;
    const Scalar z1848 = n2 * z1828;
    const Scalar z1855 = k11 - z1831;
    const Scalar z1856 = n0_1048 * s_rear_right_hip + c_rear_right_hip * z1833;
    const Scalar z1857 = s_rear_right_hip * z1833 - n0_1048 * c_rear_right_hip;
    const Scalar z1814 = c_rear_right_hip * z1805 + s_rear_right_hip * z1811;
    const Scalar z1815 = s_rear_right_hip * z1805 - c_rear_right_hip * z1811;
    const Scalar z1816 = z1810 + n0_05 * z1813;
    const Scalar z1819 = z1788 * z1807 + z1789 * z1812 - z1802 * z1813;
    const Scalar z1820 = z1790 * z1807 + z1795 * z1812 - z1796 * z1813;
    const Scalar z1821 = z1801 * z1807 + z1797 * z1812 - z1800 * z1813;
    const Scalar z1839 = c_rear_right_hip * z1831 + s_rear_right_hip * z1836;
    const Scalar z1840 = s_rear_right_hip * z1831 - c_rear_right_hip * z1836;
    const Scalar z1841 = z1835 + n0_05 * z1838;
    const Scalar z1844 = z1788 * z1833 + z1789 * z1837 - z1802 * z1838;
    const Scalar z1845 = z1790 * z1833 + z1795 * z1837 - z1796 * z1838;
    const Scalar z1849 = s_rear_right_thigh * z1847 + c_rear_right_thigh * z1848;
    const Scalar z1846 = z1801 * z1833 + z1797 * z1837 - z1800 * z1838;
    const Scalar z1818 = n0_05 * z1807 - z1815 - n0_2 * z1812;
    const Scalar z1843 = n0_05 * z1833 - z1840 - n0_2 * z1837;
    const Scalar z1817 = n0_2 * z1813 + z1814;
    const Scalar z1842 = n0_2 * z1838 + z1839;
    const Scalar z1900 = k0 * s_rear_left_knee;
    const Scalar z1903 = s_rear_left_knee * z1900;
    const Scalar z1853 = c_rear_right_thigh * z1849 - z1828;
    const Scalar z1850 = s_rear_right_thigh * z1849;
    const Scalar z1851 = z1832 - z1850;
    const Scalar z1852 = z1827 - z1850;
    const Scalar z1901 = k0 * c_rear_left_knee;
    const Scalar z1863 = z1789 * z1856 + z1802 * z1857;
    const Scalar z1854 = k14 + z1852;
    const Scalar z1864 = z1795 * z1856 + z1796 * z1857;
    const Scalar z1865 = z1797 * z1856 + z1800 * z1857;
    const Scalar z1860 = z1854 - n0_05 * z1857;
    const Scalar z1873 = z1854 - n0_1 * z1857;
    const Scalar z1881 = n0_032 * c_rear_left_knee;
    const Scalar z1905 = n0_4 * z1881 - z1903;
    const Scalar z1878 = n0_0406 + z1873;
    const Scalar z1902 = c_rear_left_knee * z1901;
    const Scalar z1904 = s_rear_left_knee * z1901;
    const Scalar z1910 = k8 + z1902;
    const Scalar z1882 = n0_032 * s_rear_left_knee;
    const Scalar z1906 = n0_2 * z1882 + z1904;
    const Scalar z1884 = s_rear_left_thigh * z1882;
    const Scalar z1886 = c_rear_left_thigh * z1882;
    const Scalar z1908 = n0_124 + z1881;
    const Scalar z1907 = k4 + n0_4 * z1881;
    const Scalar z1909 = k9 + z1907;
    const Scalar z1911 = c_rear_left_thigh * z1908 - z1884;
    const Scalar z1912 = s_rear_left_thigh * z1908 + z1886;
    const Scalar z1885 = c_rear_left_thigh * z1881 - z1884;
    const Scalar z1887 = s_rear_left_thigh * z1881 + z1886;
    const Scalar z1883 = k4 + n0_2 * z1881;
    const Scalar z1866 = z1851 - z1855;
    const Scalar z1914 = n0_08 * z1911;
    const Scalar z1867 = n2 * z1836;
    const Scalar z1868 = s_rear_right_hip * z1866 - c_rear_right_hip * z1867;
    const Scalar z1913 = n0_08 * z1912;
    const Scalar z1858 = s_rear_right_hip * z1853 - c_rear_right_hip * z1835;
    const Scalar z1859 = s_rear_right_hip * z1835 + c_rear_right_hip * z1853;
    const Scalar z1862 = n0_2 * z1856 + z1859;
    const Scalar z1872 = c_rear_right_hip * z1868 + z1836;
    const Scalar z1869 = s_rear_right_hip * z1868;
    const Scalar z1861 = n0_2 * z1857 + z1858;
    const Scalar z1874 = n0_05 * z1834 - z1858 - n0_2 * z1857;
    const Scalar z1871 = z1851 - z1869;
    const Scalar z1870 = z1855 + z1869;
    const Scalar z1876 = n0_05 * z1856 - z1872;
    const Scalar z1875 = n0_4 * z1834 - z1870;
    const Scalar z1877 = n0_4 * z1834 - z1871 - n0_1 * z1857;
    const Scalar z1925 = z1905 + z1910;
    const Scalar z1879 = k17 + z1875;
    const Scalar z1926 = n2 * z1906;
    const Scalar z1927 = s_rear_left_thigh * z1925 + c_rear_left_thigh * z1926;
    const Scalar z1933 = k11 - z1909;
    const Scalar z1934 = n0_1048 * s_rear_left_hip - c_rear_left_hip * z1911;
    const Scalar z1880 = k18 + z1877;
    const Scalar z1945 = n2 * z1914;
    const Scalar z1935 = n0_1048 * c_rear_left_hip + s_rear_left_hip * z1911;
    const Scalar z1931 = c_rear_left_thigh * z1927 - z1906;
    const Scalar z1928 = s_rear_left_thigh * z1927;
    const Scalar z1941 = z1789 * z1934 - z1802 * z1935;
    const Scalar z1929 = z1910 - z1928;
    const Scalar z1930 = z1905 - z1928;
    const Scalar z1942 = z1795 * z1934 - z1796 * z1935;
    const Scalar z1943 = z1797 * z1934 - z1800 * z1935;
    const Scalar z1932 = k14 + z1930;
    const Scalar z1944 = z1929 - z1933;
    const Scalar z1936 = c_rear_left_hip * z1913 + s_rear_left_hip * z1931;
    const Scalar z1946 = c_rear_left_hip * z1945 + s_rear_left_hip * z1944;
    const Scalar z1937 = s_rear_left_hip * z1913 - c_rear_left_hip * z1931;
    const Scalar z1940 = n0_2 * z1934 + z1937;
    const Scalar z1938 = z1932 + n0_05 * z1935;
    const Scalar z1939 = n0_2 * z1935 + z1936;
    const Scalar z1947 = s_rear_left_hip * z1946;
    const Scalar z1889 = n0_08 * z1885;
    const Scalar z1890 = s_rear_left_hip * z1887;
    const Scalar z1893 = s_rear_left_hip * z1883 + c_rear_left_hip * z1889;
    const Scalar z1892 = s_rear_left_hip * z1889 - c_rear_left_hip * z1883;
    const Scalar z1915 = s_rear_left_hip * z1912;
    const Scalar z1896 = z1893 + n0_05 * z1885 + n0_2 * z1890;
    const Scalar z1918 = s_rear_left_hip * z1909 + c_rear_left_hip * z1914;
    const Scalar z1921 = z1918 + n0_05 * z1911 + n0_2 * z1915;
    const Scalar z1917 = s_rear_left_hip * z1914 - c_rear_left_hip * z1909;
    const Scalar z1888 = n0_08 * z1887;
    const Scalar z1950 = c_rear_left_hip * z1946 - z1914;
    const Scalar z1949 = z1929 - z1947;
    const Scalar z1948 = z1933 + z1947;
    const Scalar z1891 = c_rear_left_hip * z1887;
    const Scalar z1894 = z1888 + n0_05 * z1891;
    const Scalar z1895 = n0_2 * z1891 - z1892;
    const Scalar z1956 = z1834 + z1912;
    const Scalar z1951 = z1932 + n0_1 * z1935;
    const Scalar z1952 = z1936 + n0_05 * z1912 + n0_2 * z1935;
    const Scalar z1953 = n0_4 * z1912 - z1948;
    const Scalar z1954 = n0_05 * z1934 - z1950;
    const Scalar z1955 = n0_4 * z1912 - z1949 + n0_1 * z1935;
    const Scalar z1916 = c_rear_left_hip * z1912;
    const Scalar z1919 = z1913 + n0_05 * z1916;
    const Scalar z1920 = n0_2 * z1916 - z1917;
    const Scalar z1897 = z1788 * z1885 + z1789 * z1890 - z1802 * z1891;
    const Scalar z1957 = z1857 + z1935;
    const Scalar z1898 = z1790 * z1885 + z1795 * z1890 - z1796 * z1891;
    const Scalar z1899 = z1801 * z1885 + z1797 * z1890 - z1800 * z1891;
    const Scalar z1958 = z1856 - z1934;
    const Scalar z1959 = z1878 + z1951;
    const Scalar z1960 = z1874 - z1952;
    const Scalar z1961 = z1879 + z1953;
    const Scalar z1962 = z1862 - z1940;
    const Scalar z1963 = z1876 + z1954;
    const Scalar z1964 = z1880 + z1955;
    const Scalar z1922 = z1788 * z1911 + z1789 * z1915 - z1802 * z1916;
    const Scalar z1923 = z1790 * z1911 + z1795 * z1915 - z1796 * z1916;
    const Scalar z1924 = z1801 * z1911 + z1797 * z1915 - z1800 * z1916;
    const Scalar z1984 = k0 * s_front_right_knee;
    const Scalar z1985 = k0 * c_front_right_knee;
    const Scalar z1987 = s_front_right_knee * z1984;
    const Scalar z1965 = n0_032 * c_front_right_knee;
    const Scalar z1986 = c_front_right_knee * z1985;
    const Scalar z1988 = s_front_right_knee * z1985;
    const Scalar z1966 = n0_032 * s_front_right_knee;
    const Scalar z1989 = n0_4 * z1965 - z1987;
    const Scalar z1994 = k8 + z1986;
    const Scalar z1990 = n0_2 * z1966 + z1988;
    const Scalar z1991 = k4 + n0_4 * z1965;
    const Scalar z1993 = k9 + z1991;
    const Scalar z2009 = z1989 + z1994;
    const Scalar z2010 = n2 * z1990;
    const Scalar z1968 = s_front_right_thigh * z1966;
    const Scalar z1970 = c_front_right_thigh * z1966;
    const Scalar z1992 = n0_124 + z1965;
    const Scalar z1995 = c_front_right_thigh * z1992 - z1968;
    const Scalar z2011 = s_front_right_thigh * z2009 + c_front_right_thigh * z2010;
    const Scalar z1996 = s_front_right_thigh * z1992 + z1970;
    const Scalar z1969 = c_front_right_thigh * z1965 - z1968;
    const Scalar z1971 = s_front_right_thigh * z1965 + z1970;
    const Scalar z1967 = k4 + n0_2 * z1965;
    const Scalar z2017 = k11 - z1993;
    const Scalar z1998 = n0_08 * z1995;
    const Scalar z2015 = c_front_right_thigh * z2011 - z1990;
    const Scalar z2012 = s_front_right_thigh * z2011;
    const Scalar z2029 = n2 * z1998;
    const Scalar z1997 = n0_08 * z1996;
    const Scalar z2018 = n0_1048 * s_front_right_hip + c_front_right_hip * z1995;
    const Scalar z2013 = z1994 - z2012;
    const Scalar z2014 = z1989 - z2012;
    const Scalar z2020 = s_front_right_hip * z2015 - c_front_right_hip * z1997;
    const Scalar z2016 = k14 + z2014;
    const Scalar z2021 = s_front_right_hip * z1997 + c_front_right_hip * z2015;
    const Scalar z2028 = z2013 - z2017;
    const Scalar z2030 = s_front_right_hip * z2028 - c_front_right_hip * z2029;
    const Scalar z2024 = n0_2 * z2018 - z2021;
    const Scalar z1973 = n0_08 * z1969;
    const Scalar z2019 = s_front_right_hip * z1995 - n0_1048 * c_front_right_hip;
    const Scalar z2022 = z2016 - n0_05 * z2019;
    const Scalar z2023 = n0_2 * z2019 - z2020;
    const Scalar z2025 = z1789 * z2018 + z1802 * z2019;
    const Scalar z2026 = z1795 * z2018 + z1796 * z2019;
    const Scalar z2027 = z1797 * z2018 + z1800 * z2019;
    const Scalar z2031 = s_front_right_hip * z2030;
    const Scalar z1974 = s_front_right_hip * z1971;
    const Scalar z1977 = s_front_right_hip * z1967 - c_front_right_hip * z1973;
    const Scalar z1976 = c_front_right_hip * z1967 + s_front_right_hip * z1973;
    const Scalar z1980 = n0_05 * z1969 - z1977 + n0_2 * z1974;
    const Scalar z1999 = s_front_right_hip * z1996;
    const Scalar z2002 = s_front_right_hip * z1993 - c_front_right_hip * z1998;
    const Scalar z2005 = n0_05 * z1995 - z2002 + n0_2 * z1999;
    const Scalar z2001 = c_front_right_hip * z1993 + s_front_right_hip * z1998;
    const Scalar z1972 = n0_08 * z1971;
    const Scalar z2034 = c_front_right_hip * z2030 + z1998;
    const Scalar z2033 = z2013 - z2031;
    const Scalar z2032 = z2017 + z2031;
    const Scalar z1975 = c_front_right_hip * z1971;
    const Scalar z1978 = z1972 + n0_05 * z1975;
    const Scalar z1979 = n0_2 * z1975 - z1976;
    const Scalar z2040 = z1956 + z1996;
    const Scalar z2035 = z2016 - n0_1 * z2019;
    const Scalar z2036 = n0_05 * z1996 - z2020 + n0_2 * z2019;
    const Scalar z2037 = n0_4 * z1996 + z2032;
    const Scalar z2038 = n0_05 * z2018 - z2034;
    const Scalar z2039 = z2033 + n0_4 * z1996 + n0_1 * z2019;
    const Scalar z2000 = c_front_right_hip * z1996;
    const Scalar z2003 = z1997 + n0_05 * z2000;
    const Scalar z2004 = n0_2 * z2000 - z2001;
    const Scalar z1981 = z1788 * z1969 + z1789 * z1974 - z1802 * z1975;
    const Scalar z2041 = z1957 + z2019;
    const Scalar z1982 = z1790 * z1969 + z1795 * z1974 - z1796 * z1975;
    const Scalar z1983 = z1801 * z1969 + z1797 * z1974 - z1800 * z1975;
    const Scalar z2042 = z1958 + z2018;
    const Scalar z2043 = z1959 + z2035;
    const Scalar z2044 = z1960 + z2036;
    const Scalar z2045 = z1961 - z2037;
    const Scalar z2046 = z1962 - z2024;
    const Scalar z2047 = z1963 + z2038;
    const Scalar z2048 = z1964 - z2039;
    const Scalar z2006 = z1788 * z1995 + z1789 * z1999 - z1802 * z2000;
    const Scalar z2007 = z1790 * z1995 + z1795 * z1999 - z1796 * z2000;
    const Scalar z2008 = z1801 * z1995 + z1797 * z1999 - z1800 * z2000;
    const Scalar z2068 = k0 * s_front_left_knee;
    const Scalar z2069 = k0 * c_front_left_knee;
    const Scalar z2071 = s_front_left_knee * z2068;
    const Scalar z2049 = n0_032 * c_front_left_knee;
    const Scalar z2070 = c_front_left_knee * z2069;
    const Scalar z2072 = s_front_left_knee * z2069;
    const Scalar z2050 = n0_032 * s_front_left_knee;
    const Scalar z2073 = n0_4 * z2049 - z2071;
    const Scalar z2078 = k8 + z2070;
    const Scalar z2074 = n0_2 * z2050 + z2072;
    const Scalar z2052 = s_front_left_thigh * z2050;
    const Scalar z2054 = c_front_left_thigh * z2050;
    const Scalar z2076 = n0_124 + z2049;
    const Scalar z2093 = z2073 + z2078;
    const Scalar z2094 = n2 * z2074;
    const Scalar z2075 = k4 + n0_4 * z2049;
    const Scalar z2077 = k9 + z2075;
    const Scalar z2079 = c_front_left_thigh * z2076 - z2052;
    const Scalar z2095 = s_front_left_thigh * z2093 + c_front_left_thigh * z2094;
    const Scalar z2080 = s_front_left_thigh * z2076 + z2054;
    const Scalar z2053 = c_front_left_thigh * z2049 - z2052;
    const Scalar z2055 = s_front_left_thigh * z2049 + z2054;
    const Scalar z2051 = k4 + n0_2 * z2049;
    const Scalar z2082 = n0_08 * z2079;
    const Scalar z2101 = k11 - z2077;
    const Scalar z2099 = c_front_left_thigh * z2095 - z2074;
    const Scalar z2096 = s_front_left_thigh * z2095;
    const Scalar z2113 = n2 * z2082;
    const Scalar z2081 = n0_08 * z2080;
    const Scalar z2057 = n0_08 * z2053;
    const Scalar z2097 = z2078 - z2096;
    const Scalar z2098 = z2073 - z2096;
    const Scalar z2104 = c_front_left_hip * z2081 + s_front_left_hip * z2099;
    const Scalar z2105 = s_front_left_hip * z2081 - c_front_left_hip * z2099;
    const Scalar z2100 = k14 + z2098;
    const Scalar z2112 = z2097 - z2101;
    const Scalar z2102 = n0_1048 * s_front_left_hip - c_front_left_hip * z2079;
    const Scalar z2114 = c_front_left_hip * z2113 + s_front_left_hip * z2112;
    const Scalar z2108 = n0_2 * z2102 - z2105;
    const Scalar z2058 = s_front_left_hip * z2055;
    const Scalar z2061 = s_front_left_hip * z2051 + c_front_left_hip * z2057;
    const Scalar z2060 = s_front_left_hip * z2057 - c_front_left_hip * z2051;
    const Scalar z2064 = z2061 + n0_05 * z2053 - n0_2 * z2058;
    const Scalar z2115 = s_front_left_hip * z2114;
    const Scalar z2083 = s_front_left_hip * z2080;
    const Scalar z2086 = s_front_left_hip * z2077 + c_front_left_hip * z2082;
    const Scalar z2089 = z2086 + n0_05 * z2079 - n0_2 * z2083;
    const Scalar z2085 = s_front_left_hip * z2082 - c_front_left_hip * z2077;
    const Scalar z2103 = n0_1048 * c_front_left_hip + s_front_left_hip * z2079;
    const Scalar z2106 = z2100 + n0_05 * z2103;
    const Scalar z2107 = n0_2 * z2103 - z2104;
    const Scalar z2109 = z1789 * z2102 - z1802 * z2103;
    const Scalar z2110 = z1795 * z2102 - z1796 * z2103;
    const Scalar z2111 = z1797 * z2102 - z1800 * z2103;
    const Scalar z2056 = n0_08 * z2055;
    const Scalar z2118 = c_front_left_hip * z2114 - z2082;
    const Scalar z2117 = z2097 - z2115;
    const Scalar z2116 = z2101 + z2115;
    const Scalar z2059 = c_front_left_hip * z2055;
    const Scalar z2062 = z2056 + n0_05 * z2059;
    const Scalar z2063 = n0_2 * z2059 + z2060;
    const Scalar z2124 = z2040 + z2080;
    const Scalar z2119 = z2100 + n0_1 * z2103;
    const Scalar z2120 = z2104 + n0_05 * z2080 - n0_2 * z2103;
    const Scalar z2121 = n0_4 * z2080 + z2116;
    const Scalar z2122 = n0_05 * z2102 - z2118;
    const Scalar z2123 = z2117 + n0_4 * z2080 - n0_1 * z2103;
    const Scalar z2084 = c_front_left_hip * z2080;
    const Scalar z2087 = z2081 + n0_05 * z2084;
    const Scalar z2088 = n0_2 * z2084 + z2085;
    const Scalar z2065 = z1788 * z2053 + z1789 * z2058 - z1802 * z2059;
    const Scalar z2125 = z2041 + z2103;
    const Scalar z2066 = z1790 * z2053 + z1795 * z2058 - z1796 * z2059;
    const Scalar z2067 = z1801 * z2053 + z1797 * z2058 - z1800 * z2059;
    const Scalar z2127 = z2043 + z2119;
    const Scalar z2128 = z2044 - z2120;
    const Scalar z2129 = z2045 - z2121;
    const Scalar z2130 = z2046 + z2108;
    const Scalar z2131 = z2047 + z2122;
    const Scalar z2126 = z2042 - z2102;
    const Scalar z2090 = z1788 * z2079 + z1789 * z2083 - z1802 * z2084;
    const Scalar z2091 = z1790 * z2079 + z1795 * z2083 - z1796 * z2084;
    const Scalar z2092 = z1801 * z2079 + z1797 * z2083 - z1800 * z2084;
    const Scalar z2132 = z2048 - z2123;
    const Scalar z2133 = z1789 * z2124 + z1788 * z2125;
    const Scalar z2134 = z1795 * z2124 + z1790 * z2125;
    const Scalar z2135 = z1797 * z2124 + z1801 * z2125;
    const Scalar z2136 = z1788 * z2126 - z1802 * z2124;
    const Scalar z2137 = z1790 * z2126 - z1796 * z2124;
    const Scalar z2138 = z1800 * z2124 - z1801 * z2126;
    const Scalar z2139 = z1789 * z2126 + z1802 * z2125;
    const Scalar z2140 = z1795 * z2126 + z1796 * z2125;
    const Scalar z2141 = z1797 * z2126 + z1800 * z2125;
    mass[0] = n12_24;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z2139;
    mass[4] = -z2136;
    mass[5] = -z2133;
    mass[6] = -z2109;
    mass[7] = -z2090;
    mass[8] = -z2065;
    mass[9] = z2025;
    mass[10] = -z2006;
    mass[11] = -z1981;
    mass[12] = -z1941;
    mass[13] = -z1922;
    mass[14] = -z1897;
    mass[15] = z1863;
    mass[16] = -z1844;
    mass[17] = -z1819;
    mass[18] = n0;
    mass[19] = n12_24;
    mass[20] = n0;
    mass[21] = z2140;
    mass[22] = -z2137;
    mass[23] = -z2134;
    mass[24] = -z2110;
    mass[25] = -z2091;
    mass[26] = -z2066;
    mass[27] = z2026;
    mass[28] = -z2007;
    mass[29] = -z1982;
    mass[30] = -z1942;
    mass[31] = -z1923;
    mass[32] = -z1898;
    mass[33] = z1864;
    mass[34] = -z1845;
    mass[35] = -z1820;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n12_24;
    mass[39] = z2141;
    mass[40] = z2138;
    mass[41] = -z2135;
    mass[42] = -z2111;
    mass[43] = -z2092;
    mass[44] = -z2067;
    mass[45] = z2027;
    mass[46] = -z2008;
    mass[47] = -z1983;
    mass[48] = -z1943;
    mass[49] = -z1924;
    mass[50] = -z1899;
    mass[51] = z1865;
    mass[52] = -z1846;
    mass[53] = -z1821;
    mass[54] = z2139;
    mass[55] = z2140;
    mass[56] = z2141;
    mass[57] = z2127;
    mass[58] = -z2128;
    mass[59] = -z2130;
    mass[60] = z2106;
    mass[61] = z2087;
    mass[62] = z2062;
    mass[63] = z2022;
    mass[64] = -z2003;
    mass[65] = -z1978;
    mass[66] = z1938;
    mass[67] = z1919;
    mass[68] = z1894;
    mass[69] = z1860;
    mass[70] = -z1841;
    mass[71] = -z1816;
    mass[72] = -z2136;
    mass[73] = -z2137;
    mass[74] = z2138;
    mass[75] = -z2128;
    mass[76] = z2129;
    mass[77] = -z2131;
    mass[78] = -z2107;
    mass[79] = -z2088;
    mass[80] = -z2063;
    mass[81] = -z2023;
    mass[82] = -z2004;
    mass[83] = -z1979;
    mass[84] = z1939;
    mass[85] = z1920;
    mass[86] = z1895;
    mass[87] = z1861;
    mass[88] = z1842;
    mass[89] = z1817;
    mass[90] = -z2133;
    mass[91] = -z2134;
    mass[92] = -z2135;
    mass[93] = -z2130;
    mass[94] = -z2131;
    mass[95] = z2132;
    mass[96] = -z2108;
    mass[97] = z2089;
    mass[98] = z2064;
    mass[99] = z2024;
    mass[100] = -z2005;
    mass[101] = -z1980;
    mass[102] = z1940;
    mass[103] = z1921;
    mass[104] = z1896;
    mass[105] = -z1862;
    mass[106] = -z1843;
    mass[107] = -z1818;
    mass[108] = -z2109;
    mass[109] = -z2110;
    mass[110] = -z2111;
    mass[111] = z2106;
    mass[112] = -z2107;
    mass[113] = -z2108;
    mass[114] = z2100;
    mass[115] = z2081;
    mass[116] = z2056;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n0;
    mass[121] = n0;
    mass[122] = n0;
    mass[123] = n0;
    mass[124] = n0;
    mass[125] = n0;
    mass[126] = -z2090;
    mass[127] = -z2091;
    mass[128] = -z2092;
    mass[129] = z2087;
    mass[130] = -z2088;
    mass[131] = z2089;
    mass[132] = z2081;
    mass[133] = z2077;
    mass[134] = z2051;
    mass[135] = n0;
    mass[136] = n0;
    mass[137] = n0;
    mass[138] = n0;
    mass[139] = n0;
    mass[140] = n0;
    mass[141] = n0;
    mass[142] = n0;
    mass[143] = n0;
    mass[144] = -z2065;
    mass[145] = -z2066;
    mass[146] = -z2067;
    mass[147] = z2062;
    mass[148] = -z2063;
    mass[149] = z2064;
    mass[150] = z2056;
    mass[151] = z2051;
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
    mass[162] = z2025;
    mass[163] = z2026;
    mass[164] = z2027;
    mass[165] = z2022;
    mass[166] = -z2023;
    mass[167] = z2024;
    mass[168] = n0;
    mass[169] = n0;
    mass[170] = n0;
    mass[171] = z2016;
    mass[172] = -z1997;
    mass[173] = -z1972;
    mass[174] = n0;
    mass[175] = n0;
    mass[176] = n0;
    mass[177] = n0;
    mass[178] = n0;
    mass[179] = n0;
    mass[180] = -z2006;
    mass[181] = -z2007;
    mass[182] = -z2008;
    mass[183] = -z2003;
    mass[184] = -z2004;
    mass[185] = -z2005;
    mass[186] = n0;
    mass[187] = n0;
    mass[188] = n0;
    mass[189] = -z1997;
    mass[190] = z1993;
    mass[191] = z1967;
    mass[192] = n0;
    mass[193] = n0;
    mass[194] = n0;
    mass[195] = n0;
    mass[196] = n0;
    mass[197] = n0;
    mass[198] = -z1981;
    mass[199] = -z1982;
    mass[200] = -z1983;
    mass[201] = -z1978;
    mass[202] = -z1979;
    mass[203] = -z1980;
    mass[204] = n0;
    mass[205] = n0;
    mass[206] = n0;
    mass[207] = -z1972;
    mass[208] = z1967;
    mass[209] = k4;
    mass[210] = n0;
    mass[211] = n0;
    mass[212] = n0;
    mass[213] = n0;
    mass[214] = n0;
    mass[215] = n0;
    mass[216] = -z1941;
    mass[217] = -z1942;
    mass[218] = -z1943;
    mass[219] = z1938;
    mass[220] = z1939;
    mass[221] = z1940;
    mass[222] = n0;
    mass[223] = n0;
    mass[224] = n0;
    mass[225] = n0;
    mass[226] = n0;
    mass[227] = n0;
    mass[228] = z1932;
    mass[229] = z1913;
    mass[230] = z1888;
    mass[231] = n0;
    mass[232] = n0;
    mass[233] = n0;
    mass[234] = -z1922;
    mass[235] = -z1923;
    mass[236] = -z1924;
    mass[237] = z1919;
    mass[238] = z1920;
    mass[239] = z1921;
    mass[240] = n0;
    mass[241] = n0;
    mass[242] = n0;
    mass[243] = n0;
    mass[244] = n0;
    mass[245] = n0;
    mass[246] = z1913;
    mass[247] = z1909;
    mass[248] = z1883;
    mass[249] = n0;
    mass[250] = n0;
    mass[251] = n0;
    mass[252] = -z1897;
    mass[253] = -z1898;
    mass[254] = -z1899;
    mass[255] = z1894;
    mass[256] = z1895;
    mass[257] = z1896;
    mass[258] = n0;
    mass[259] = n0;
    mass[260] = n0;
    mass[261] = n0;
    mass[262] = n0;
    mass[263] = n0;
    mass[264] = z1888;
    mass[265] = z1883;
    mass[266] = k4;
    mass[267] = n0;
    mass[268] = n0;
    mass[269] = n0;
    mass[270] = z1863;
    mass[271] = z1864;
    mass[272] = z1865;
    mass[273] = z1860;
    mass[274] = z1861;
    mass[275] = -z1862;
    mass[276] = n0;
    mass[277] = n0;
    mass[278] = n0;
    mass[279] = n0;
    mass[280] = n0;
    mass[281] = n0;
    mass[282] = n0;
    mass[283] = n0;
    mass[284] = n0;
    mass[285] = z1854;
    mass[286] = -z1835;
    mass[287] = -z1810;
    mass[288] = -z1844;
    mass[289] = -z1845;
    mass[290] = -z1846;
    mass[291] = -z1841;
    mass[292] = z1842;
    mass[293] = -z1843;
    mass[294] = n0;
    mass[295] = n0;
    mass[296] = n0;
    mass[297] = n0;
    mass[298] = n0;
    mass[299] = n0;
    mass[300] = n0;
    mass[301] = n0;
    mass[302] = n0;
    mass[303] = -z1835;
    mass[304] = z1831;
    mass[305] = z1805;
    mass[306] = -z1819;
    mass[307] = -z1820;
    mass[308] = -z1821;
    mass[309] = -z1816;
    mass[310] = z1817;
    mass[311] = -z1818;
    mass[312] = n0;
    mass[313] = n0;
    mass[314] = n0;
    mass[315] = n0;
    mass[316] = n0;
    mass[317] = n0;
    mass[318] = n0;
    mass[319] = n0;
    mass[320] = n0;
    mass[321] = -z1810;
    mass[322] = z1805;
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
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k12 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k13 = traits::constant(0.01928, 0.01928f, "241/12500");
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
    const Scalar z2539 = n2 * q_trunk_attitude_y;
    const Scalar z2548 = n2 * q_trunk_attitude_x;
    const Scalar z2541 = n2 * q_trunk_attitude_z;
    const Scalar z2589 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z2587 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z2540 = q_trunk_attitude_y * z2539;
    const Scalar z2550 = q_trunk_attitude_z * z2539;
    const Scalar z2551 = q_trunk_attitude_w * z2548;
    const Scalar z2549 = q_trunk_attitude_x * z2548;
    const Scalar z2555 = q_trunk_attitude_x * z2541;
    const Scalar z2554 = z2550 + z2551;
    const Scalar z2556 = q_trunk_attitude_w * z2539;
    const Scalar z2557 = n1 - z2540 - z2549;
    const Scalar z2558 = z2555 - z2556;
    const Scalar z2580 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z2588 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z2571 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z2579 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z2562 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z2570 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z2569 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z2553 = z2550 - z2551;
    const Scalar z2578 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z2559 = z2555 + z2556;
    const Scalar z2561 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z2543 = q_trunk_attitude_x * z2539;
    const Scalar z2560 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z2542 = q_trunk_attitude_z * z2541;
    const Scalar z2544 = q_trunk_attitude_w * z2541;
    const Scalar z2545 = n1 - z2540 - z2542;
    const Scalar z2552 = n1 - z2542 - z2549;
    const Scalar z2547 = z2543 + z2544;
    const Scalar z2546 = z2543 - z2544;
    const Scalar z2609 = n9_81 * z2554;
    const Scalar z2614 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z2610 = n9_81 * z2557;
    const Scalar z2611 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z2612 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z2613 = z2611 + z2612;
    const Scalar z2615 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z2616 = z2612 + z2615;
    const Scalar z2617 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z2608 = n9_81 * z2558;
    const Scalar z2618 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z2621 = z2610 + n0_2 * z2617 + n0_05 * z2618;
    const Scalar z2620 = z2609 + n0_2 * z2614 - n0_05 * z2616;
    const Scalar z2619 = z2608 - n0_2 * z2613 + n0_05 * z2614;
    const Scalar z2596 = n0_05 * v_front_left_hip;
    const Scalar z2597 = n0_05 * v_front_left_thigh;
    const Scalar z2622 = s_front_left_hip * z2621 + c_front_left_hip * z2620;
    const Scalar z2598 = n0_05 * v_front_left_knee;
    const Scalar z2599 = n0_05 * v_front_right_hip;
    const Scalar z2600 = n0_05 * v_front_right_thigh;
    const Scalar z2601 = n0_05 * v_front_right_knee;
    const Scalar z2602 = n0_05 * v_rear_left_hip;
    const Scalar z2603 = n0_05 * v_rear_left_thigh;
    const Scalar z2604 = n0_05 * v_rear_left_knee;
    const Scalar z2605 = n0_05 * v_rear_right_hip;
    const Scalar z2606 = n0_05 * v_rear_right_thigh;
    const Scalar z2607 = n0_05 * v_rear_right_knee;
    const Scalar z2563 = c_front_left_thigh * z2562 + s_front_left_thigh * z2561;
    const Scalar z2623 = s_front_left_hip * z2620 - c_front_left_hip * z2621;
    const Scalar z2564 = s_front_left_thigh * z2562 - c_front_left_thigh * z2561;
    const Scalar z2565 = v_front_left_thigh + z2560;
    const Scalar z2572 = c_front_right_thigh * z2571 + s_front_right_thigh * z2570;
    const Scalar z2573 = s_front_right_thigh * z2571 - c_front_right_thigh * z2570;
    const Scalar z2590 = c_rear_right_thigh * z2589 + s_rear_right_thigh * z2588;
    const Scalar z2591 = s_rear_right_thigh * z2589 - c_rear_right_thigh * z2588;
    const Scalar z2581 = c_rear_left_thigh * z2580 + s_rear_left_thigh * z2579;
    const Scalar z2582 = s_rear_left_thigh * z2580 - c_rear_left_thigh * z2579;
    const Scalar z2592 = v_rear_right_thigh + z2587;
    const Scalar z2593 = s_rear_right_knee * z2591 - c_rear_right_knee * z2590;
    const Scalar z2594 = s_rear_right_knee * z2590 + c_rear_right_knee * z2591;
    const Scalar z2625 = v_front_left_hip * z2560;  // angular acceleration of front_left_hip_link, z
    const Scalar z2583 = v_rear_left_thigh + z2578;
    const Scalar z2584 = s_rear_left_knee * z2582 - c_rear_left_knee * z2581;
    const Scalar z2585 = s_rear_left_knee * z2581 + c_rear_left_knee * z2582;
    const Scalar z2595 = v_rear_right_knee + z2592;
    const Scalar z2574 = v_front_right_thigh + z2569;
    const Scalar z2575 = s_front_right_knee * z2573 - c_front_right_knee * z2572;
    const Scalar z2576 = s_front_right_knee * z2572 + c_front_right_knee * z2573;
    const Scalar z2586 = v_rear_left_knee + z2583;
    const Scalar z2566 = s_front_left_knee * z2564 - c_front_left_knee * z2563;
    const Scalar z2567 = s_front_left_knee * z2563 + c_front_left_knee * z2564;
    const Scalar z2577 = v_front_right_knee + z2574;
    const Scalar z2626 = z2560 * z2562;
    const Scalar z2627 = z2625 + z2626;
    const Scalar z2568 = v_front_left_knee + z2565;
    const Scalar z2631 = z2560 * z2561;
    const Scalar z2662 = v_front_right_hip * z2569;  // angular acceleration of front_right_hip_link, z
    const Scalar z2669 = s_front_right_thigh * z2662;
    const Scalar z2657 = z2609 + n0_2 * z2614 + n0_05 * z2616;
    const Scalar z2658 = z2610 + n0_2 * z2617 - n0_05 * z2618;
    const Scalar z2676 = v_front_right_thigh * z2573 - z2669;  // angular acceleration of front_right_thigh_link, x
    const Scalar z2663 = z2569 * z2571;
    const Scalar z2664 = z2662 + z2663;
    const Scalar z2670 = c_front_right_thigh * z2662;
    const Scalar z2677 = v_front_right_thigh * z2572 - z2670;  // angular acceleration of front_right_thigh_link, z
    const Scalar z2668 = z2569 * z2570;
    const Scalar z2632 = s_front_left_thigh * z2625;
    const Scalar z2633 = c_front_left_thigh * z2625;
    const Scalar z2639 = v_front_left_thigh * z2564 - z2632;  // angular acceleration of front_left_thigh_link, x
    const Scalar z2640 = v_front_left_thigh * z2563 - z2633;  // angular acceleration of front_left_thigh_link, z
    const Scalar z2656 = z2608 - n0_2 * z2613 - n0_05 * z2614;
    const Scalar z2665 = z2570 * z2570;
    const Scalar z2666 = z2571 * z2571;
    const Scalar z2667 = z2665 + z2666;
    const Scalar z2661 = v_front_right_hip * z2570;  // angular acceleration of front_right_hip_link, y
    const Scalar z2660 = s_front_right_hip * z2657 - c_front_right_hip * z2658;
    const Scalar z2659 = s_front_right_hip * z2658 + c_front_right_hip * z2657;
    const Scalar z2672 = z2659 + n0_08 * z2667;
    const Scalar z2628 = z2561 * z2561;
    const Scalar z2629 = z2562 * z2562;
    const Scalar z2630 = z2628 + z2629;
    const Scalar z2671 = z2656 - n0_08 * z2664;
    const Scalar z2624 = v_front_left_hip * z2561;  // angular acceleration of front_left_hip_link, y
    const Scalar z2693 = z2608 + n0_2 * z2613 + n0_05 * z2614;
    const Scalar z2635 = z2622 - n0_08 * z2630;
    const Scalar z2680 = z2573 * z2574;
    const Scalar z2681 = z2676 + z2680;
    const Scalar z2678 = z2572 * z2573;
    const Scalar z2686 = s_front_right_knee * z2676 - c_front_right_knee * z2677;
    const Scalar z2685 = s_front_right_knee * z2677 + c_front_right_knee * z2676;
    const Scalar z2692 = v_front_right_knee * z2575 + z2686;  // angular acceleration of front_right_shank_link, z
    const Scalar z2691 = v_front_right_knee * z2576 + z2685;  // angular acceleration of front_right_shank_link, x
    const Scalar z2673 = z2660 - n0_08 * z2668;
    const Scalar z2643 = z2564 * z2565;
    const Scalar z2644 = z2639 + z2643;
    const Scalar z2641 = z2563 * z2564;
    const Scalar z2682 = z2572 * z2572;
    const Scalar z2683 = z2574 * z2574;
    const Scalar z2684 = z2682 + z2683;
    const Scalar z2649 = s_front_left_knee * z2639 - c_front_left_knee * z2640;
    const Scalar z2648 = s_front_left_knee * z2640 + c_front_left_knee * z2639;
    const Scalar z2655 = v_front_left_knee * z2566 + z2649;  // angular acceleration of front_left_shank_link, z
    const Scalar z2654 = v_front_left_knee * z2567 + z2648;  // angular acceleration of front_left_shank_link, x
    const Scalar z2634 = z2619 + n0_08 * z2627;
    const Scalar z2694 = z2609 - n0_2 * z2614 - n0_05 * z2616;
    const Scalar z2695 = z2610 - n0_2 * z2617 + n0_05 * z2618;
    const Scalar z2675 = s_front_right_thigh * z2671 - c_front_right_thigh * z2673;
    const Scalar z2674 = s_front_right_thigh * z2673 + c_front_right_thigh * z2671;
    const Scalar z2689 = z2675 + n0_2 * z2684;
    const Scalar z2688 = z2672 - n0_2 * z2681;
    const Scalar z2636 = z2623 + n0_08 * z2631;
    const Scalar z2696 = s_rear_left_hip * z2695 + c_rear_left_hip * z2694;
    const Scalar z2645 = z2563 * z2563;
    const Scalar z2646 = z2565 * z2565;
    const Scalar z2647 = z2645 + z2646;
    const Scalar z2679 = z2661 - z2678;
    const Scalar z2651 = z2635 - n0_2 * z2644;
    const Scalar z2638 = s_front_left_thigh * z2634 - c_front_left_thigh * z2636;
    const Scalar z2637 = s_front_left_thigh * z2636 + c_front_left_thigh * z2634;
    const Scalar z2697 = s_rear_left_hip * z2694 - c_rear_left_hip * z2695;
    const Scalar z2652 = z2638 + n0_2 * z2647;
    const Scalar z2699 = v_rear_left_hip * z2578;  // angular acceleration of rear_left_hip_link, z
    const Scalar z2700 = z2578 * z2580;
    const Scalar z2701 = z2699 + z2700;
    const Scalar z2698 = v_rear_left_hip * z2579;  // angular acceleration of rear_left_hip_link, y
    const Scalar z2687 = z2674 + n0_2 * z2679;
    const Scalar z2690 = s_front_right_knee * z2689 - c_front_right_knee * z2687;
    const Scalar z2642 = z2624 - z2641;
    const Scalar z2705 = z2578 * z2579;
    const Scalar z2706 = s_rear_left_thigh * z2699;
    const Scalar z2707 = c_rear_left_thigh * z2699;
    const Scalar z2702 = z2579 * z2579;
    const Scalar z2703 = z2580 * z2580;
    const Scalar z2704 = z2702 + z2703;
    const Scalar z2708 = z2693 + n0_08 * z2701;
    const Scalar z2650 = z2637 + n0_2 * z2642;
    const Scalar z2653 = s_front_left_knee * z2652 - c_front_left_knee * z2650;
    const Scalar z2731 = z2609 - n0_2 * z2614 + n0_05 * z2616;
    const Scalar z2730 = z2608 + n0_2 * z2613 - n0_05 * z2614;
    const Scalar z2713 = v_rear_left_thigh * z2582 - z2706;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z2714 = v_rear_left_thigh * z2581 - z2707;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z2709 = z2696 - n0_08 * z2704;
    const Scalar z2736 = v_rear_right_hip * z2587;  // angular acceleration of rear_right_hip_link, z
    const Scalar z2743 = s_rear_right_thigh * z2736;
    const Scalar z2732 = z2610 - n0_2 * z2617 - n0_05 * z2618;
    const Scalar z2737 = z2587 * z2589;
    const Scalar z2750 = v_rear_right_thigh * z2591 - z2743;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z2738 = z2736 + z2737;
    const Scalar z2744 = c_rear_right_thigh * z2736;
    const Scalar z2751 = v_rear_right_thigh * z2590 - z2744;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z2742 = z2587 * z2588;
    const Scalar z2739 = z2588 * z2588;
    const Scalar z2740 = z2589 * z2589;
    const Scalar z2741 = z2739 + z2740;
    const Scalar z2734 = s_rear_right_hip * z2731 - c_rear_right_hip * z2732;
    const Scalar z2733 = s_rear_right_hip * z2732 + c_rear_right_hip * z2731;
    const Scalar z2746 = z2733 + n0_08 * z2741;
    const Scalar z2745 = z2730 - n0_08 * z2738;
    const Scalar z2735 = v_rear_right_hip * z2588;  // angular acceleration of rear_right_hip_link, y
    const Scalar z2754 = z2591 * z2592;
    const Scalar z2755 = z2750 + z2754;
    const Scalar z2752 = z2590 * z2591;
    const Scalar z2767 = z2593 * z2594;
    const Scalar z2760 = s_rear_right_knee * z2750 - c_rear_right_knee * z2751;
    const Scalar z2759 = s_rear_right_knee * z2751 + c_rear_right_knee * z2750;
    const Scalar z2766 = v_rear_right_knee * z2593 + z2760;  // angular acceleration of rear_right_shank_link, z
    const Scalar z2765 = v_rear_right_knee * z2594 + z2759;  // angular acceleration of rear_right_shank_link, x
    const Scalar z2769 = z2594 * z2595;
    const Scalar z2747 = z2734 - n0_08 * z2742;
    const Scalar z2756 = z2590 * z2590;
    const Scalar z2757 = z2592 * z2592;
    const Scalar z2758 = z2756 + z2757;
    const Scalar z2768 = z2735 + z2767;
    const Scalar z2749 = s_rear_right_thigh * z2745 - c_rear_right_thigh * z2747;
    const Scalar z2748 = s_rear_right_thigh * z2747 + c_rear_right_thigh * z2745;
    const Scalar z2763 = z2749 + n0_2 * z2758;
    const Scalar z2762 = z2746 - n0_2 * z2755;
    const Scalar z2717 = z2582 * z2583;
    const Scalar z2718 = z2713 + z2717;
    const Scalar z2715 = z2581 * z2582;
    const Scalar z2723 = s_rear_left_knee * z2713 - c_rear_left_knee * z2714;
    const Scalar z2722 = s_rear_left_knee * z2714 + c_rear_left_knee * z2713;
    const Scalar z2729 = v_rear_left_knee * z2584 + z2723;  // angular acceleration of rear_left_shank_link, z
    const Scalar z2728 = v_rear_left_knee * z2585 + z2722;  // angular acceleration of rear_left_shank_link, x
    const Scalar z2753 = z2735 - z2752;
    const Scalar z2710 = z2697 + n0_08 * z2705;
    const Scalar z2770 = z2765 + z2769;
    const Scalar z2719 = z2581 * z2581;
    const Scalar z2720 = z2583 * z2583;
    const Scalar z2721 = z2719 + z2720;
    const Scalar z2761 = z2748 + n0_2 * z2753;
    const Scalar z2764 = s_rear_right_knee * z2763 - c_rear_right_knee * z2761;
    const Scalar z2712 = s_rear_left_thigh * z2708 - c_rear_left_thigh * z2710;
    const Scalar z2711 = s_rear_left_thigh * z2710 + c_rear_left_thigh * z2708;
    const Scalar z2726 = z2712 + n0_2 * z2721;
    const Scalar z2771 = z2593 * z2593;
    const Scalar z2774 = z2593 * z2595;
    const Scalar z2775 = z2766 + z2774;
    const Scalar z2772 = z2595 * z2595;
    const Scalar z2773 = z2771 + z2772;
    const Scalar z2725 = z2709 - n0_2 * z2718;
    const Scalar z2716 = z2698 - z2715;
    const Scalar z2780 = k6 * z2735 + k7 * z2767 - n0_032 * z2764;  // moment on rear_right_shank_link, y
    const Scalar z2776 = n0_032 * z2768;  // force on rear_right_shank_link, x
    const Scalar z2778 = n0_032 * z2773;  // force on rear_right_shank_link, z
    const Scalar z2781 = k9 * z2775;  // moment on rear_right_shank_link, z
    const Scalar z2779 = n0_032 * z2762 - k10 * z2770;  // moment on rear_right_shank_link, x
    const Scalar z2777 = n0_032 * z2770;  // force on rear_right_shank_link, y
    const Scalar z2783 = s_rear_right_knee * z2776 - c_rear_right_knee * z2778;
    const Scalar z2782 = s_rear_right_knee * z2778 + c_rear_right_knee * z2776;
    const Scalar z2724 = z2711 + n0_2 * z2716;
    const Scalar z2786 = z2590 * z2592;
    const Scalar z2727 = s_rear_left_knee * z2726 - c_rear_left_knee * z2724;
    const Scalar z2790 = n0_124 * z2758 - z2783;  // force on rear_right_thigh_link, z
    const Scalar z2787 = z2751 + z2786;
    const Scalar z2798 = z2588 * z2589;
    // moment on rear_right_thigh_link, y
    const Scalar z2792 = k12 * z2735 - k13 * z2752 + n0_124 * z2748 + n0_2 * z2782 + z2780;
    const Scalar z2788 = n0_124 * z2753 + z2782;  // force on rear_right_thigh_link, x
    const Scalar z2799 = z2735 + z2798;
    const Scalar z2829 = z2581 * z2583;
    const Scalar z2830 = z2714 + z2829;
    const Scalar z2841 = z2579 * z2580;
    const Scalar z2804 = z2792 + n0_0002 * z2799;  // moment on rear_right_hip_link, y
    const Scalar z2842 = z2698 + z2841;
    const Scalar z2810 = z2584 * z2585;
    const Scalar z2812 = z2585 * z2586;
    const Scalar z2813 = z2728 + z2812;
    const Scalar z2823 = k6 * z2698 + k7 * z2810 - n0_032 * z2727;  // moment on rear_left_shank_link, y
    const Scalar z2811 = z2698 + z2810;
    const Scalar z2819 = n0_032 * z2811;  // force on rear_left_shank_link, x
    const Scalar z2822 = n0_032 * z2725 - k10 * z2813;  // moment on rear_left_shank_link, x
    const Scalar z2820 = n0_032 * z2813;  // force on rear_left_shank_link, y
    const Scalar z2814 = z2584 * z2584;
    const Scalar z2817 = z2584 * z2586;
    const Scalar z2818 = z2729 + z2817;
    const Scalar z2815 = z2586 * z2586;
    const Scalar z2816 = z2814 + z2815;
    const Scalar z2784 = s_rear_right_knee * z2781 - c_rear_right_knee * z2779;
    const Scalar z2785 = c_rear_right_knee * z2781 + s_rear_right_knee * z2779;
    const Scalar z2791 = n0_124 * z2746 - k15 * z2755 - n0_2 * z2777 - z2784;  // moment on rear_right_thigh_link, x
    const Scalar z2789 = n0_124 * z2755 + z2777;  // force on rear_right_thigh_link, y
    const Scalar z2793 = z2785 - n0_0002 * z2787;  // moment on rear_right_thigh_link, z
    const Scalar z2801 = n0_1048 * z2741 - z2789;  // force on rear_right_hip_link, y
    const Scalar z2821 = n0_032 * z2816;  // force on rear_left_shank_link, z
    const Scalar z2824 = k9 * z2818;  // moment on rear_left_shank_link, z
    const Scalar z2853 = z2575 * z2576;
    const Scalar z2826 = s_rear_left_knee * z2819 - c_rear_left_knee * z2821;
    const Scalar z2825 = s_rear_left_knee * z2821 + c_rear_left_knee * z2819;
    const Scalar z2833 = n0_124 * z2721 - z2826;  // force on rear_left_thigh_link, z
    const Scalar z2794 = s_rear_right_thigh * z2790 + c_rear_right_thigh * z2788;
    const Scalar z2795 = s_rear_right_thigh * z2788 - c_rear_right_thigh * z2790;
    // moment on rear_left_thigh_link, y
    const Scalar z2835 = k12 * z2698 - k13 * z2715 + n0_124 * z2711 + n0_2 * z2825 + z2823;
    const Scalar z2831 = n0_124 * z2716 + z2825;  // force on rear_left_thigh_link, x
    const Scalar z2855 = z2576 * z2577;
    const Scalar z2854 = z2661 + z2853;
    const Scalar z2847 = z2835 + n0_0002 * z2842;  // moment on rear_left_hip_link, y
    const Scalar z2827 = s_rear_left_knee * z2824 - c_rear_left_knee * z2822;
    const Scalar z2828 = c_rear_left_knee * z2824 + s_rear_left_knee * z2822;
    const Scalar z2834 = n0_124 * z2709 - k15 * z2718 - n0_2 * z2820 - z2827;  // moment on rear_left_thigh_link, x
    const Scalar z2832 = n0_124 * z2718 + z2820;  // force on rear_left_thigh_link, y
    const Scalar z2836 = z2828 - n0_0002 * z2830;  // moment on rear_left_thigh_link, z
    const Scalar z2844 = n0_1048 * z2704 + z2832;  // force on rear_left_hip_link, y
    const Scalar z2837 = s_rear_left_thigh * z2833 + c_rear_left_thigh * z2831;
    const Scalar z2838 = s_rear_left_thigh * z2831 - c_rear_left_thigh * z2833;
    const Scalar z2797 = s_rear_right_thigh * z2791 + c_rear_right_thigh * z2793;
    const Scalar z2805 = n0_1048 * z2730 - k17 * z2738 + n0_08 * z2794 - z2797;  // moment on rear_right_hip_link, z
    const Scalar z2800 = n0_1048 * z2738 - z2794;  // force on rear_right_hip_link, x
    const Scalar z2796 = s_rear_right_thigh * z2793 - c_rear_right_thigh * z2791;
    const Scalar z2856 = z2691 + z2855;
    const Scalar z2803 = n0_1048 * z2734 - k18 * z2742 + n0_08 * z2795 - z2796;  // moment on rear_right_hip_link, x
    const Scalar z2802 = n0_1048 * z2742 - z2795;  // force on rear_right_hip_link, z
    const Scalar z2862 = n0_032 * z2854;  // force on front_right_shank_link, x
    const Scalar z2865 = n0_032 * z2688 - k10 * z2856;  // moment on front_right_shank_link, x
    const Scalar z2863 = n0_032 * z2856;  // force on front_right_shank_link, y
    const Scalar z2857 = z2575 * z2575;
    const Scalar z2860 = z2575 * z2577;
    const Scalar z2861 = z2692 + z2860;
    const Scalar z2858 = z2577 * z2577;
    const Scalar z2859 = z2857 + z2858;
    const Scalar z2843 = n0_1048 * z2701 + z2837;  // force on rear_left_hip_link, x
    const Scalar z2807 = s_rear_right_hip * z2801 + c_rear_right_hip * z2802;
    const Scalar z2806 = s_rear_right_hip * z2802 - c_rear_right_hip * z2801;
    const Scalar z2866 = k6 * z2661 + k7 * z2853 - n0_032 * z2690;  // moment on front_right_shank_link, y
    const Scalar z2864 = n0_032 * z2859;  // force on front_right_shank_link, z
    const Scalar z2867 = k9 * z2861;  // moment on front_right_shank_link, z
    const Scalar z2809 = s_rear_right_hip * z2804 - c_rear_right_hip * z2805;
    const Scalar z2808 = c_rear_right_hip * z2804 + s_rear_right_hip * z2805;
    const Scalar z2872 = z2572 * z2574;
    const Scalar z2873 = z2677 + z2872;
    const Scalar z2884 = z2570 * z2571;
    const Scalar z2885 = z2661 + z2884;
    const Scalar z2896 = z2566 * z2567;
    const Scalar z2898 = z2567 * z2568;
    const Scalar z2897 = z2624 + z2896;
    const Scalar z2869 = s_front_right_knee * z2862 - c_front_right_knee * z2864;
    const Scalar z2868 = s_front_right_knee * z2864 + c_front_right_knee * z2862;
    // moment on front_right_thigh_link, y
    const Scalar z2878 = k12 * z2661 - k13 * z2678 + n0_124 * z2674 + n0_2 * z2868 + z2866;
    const Scalar z2876 = n0_124 * z2684 - z2869;  // force on front_right_thigh_link, z
    const Scalar z2874 = n0_124 * z2679 + z2868;  // force on front_right_thigh_link, x
    const Scalar z2870 = s_front_right_knee * z2867 - c_front_right_knee * z2865;
    const Scalar z2871 = c_front_right_knee * z2867 + s_front_right_knee * z2865;
    const Scalar z2877 = n0_124 * z2672 - k15 * z2681 - n0_2 * z2863 - z2870;  // moment on front_right_thigh_link, x
    const Scalar z2875 = n0_124 * z2681 + z2863;  // force on front_right_thigh_link, y
    const Scalar z2879 = z2871 - n0_0002 * z2873;  // moment on front_right_thigh_link, z
    const Scalar z2887 = n0_1048 * z2667 - z2875;  // force on front_right_hip_link, y
    const Scalar z2890 = z2878 + n0_0002 * z2885;  // moment on front_right_hip_link, y
    const Scalar z2880 = s_front_right_thigh * z2876 + c_front_right_thigh * z2874;
    const Scalar z2881 = s_front_right_thigh * z2874 - c_front_right_thigh * z2876;
    const Scalar z2886 = n0_1048 * z2664 - z2880;  // force on front_right_hip_link, x
    const Scalar z2845 = n0_1048 * z2705 + z2838;  // force on rear_left_hip_link, z
    const Scalar z2840 = s_rear_left_thigh * z2834 + c_rear_left_thigh * z2836;
    const Scalar z2848 = n0_1048 * z2693 + k17 * z2701 + n0_08 * z2837 + z2840;  // moment on rear_left_hip_link, z
    const Scalar z2839 = s_rear_left_thigh * z2836 - c_rear_left_thigh * z2834;
    const Scalar z2846 = n0_1048 * z2697 + k18 * z2705 + n0_08 * z2838 + z2839;  // moment on rear_left_hip_link, x
    const Scalar z2899 = z2654 + z2898;
    const Scalar z2905 = n0_032 * z2897;  // force on front_left_shank_link, x
    const Scalar z2908 = n0_032 * z2651 - k10 * z2899;  // moment on front_left_shank_link, x
    const Scalar z2906 = n0_032 * z2899;  // force on front_left_shank_link, y
    const Scalar z2900 = z2566 * z2566;
    const Scalar z2903 = z2566 * z2568;
    const Scalar z2904 = z2655 + z2903;
    const Scalar z2901 = z2568 * z2568;
    const Scalar z2902 = z2900 + z2901;
    const Scalar z2883 = s_front_right_thigh * z2877 + c_front_right_thigh * z2879;
    const Scalar z2891 = n0_1048 * z2656 - k17 * z2664 + n0_08 * z2880 - z2883;  // moment on front_right_hip_link, z
    const Scalar z2882 = s_front_right_thigh * z2879 - c_front_right_thigh * z2877;
    const Scalar z2889 = n0_1048 * z2660 - k18 * z2668 + n0_08 * z2881 - z2882;  // moment on front_right_hip_link, x
    const Scalar z2888 = n0_1048 * z2668 - z2881;  // force on front_right_hip_link, z
    const Scalar z2907 = n0_032 * z2902;  // force on front_left_shank_link, z
    const Scalar z2850 = s_rear_left_hip * z2844 + c_rear_left_hip * z2845;
    const Scalar z2849 = s_rear_left_hip * z2845 - c_rear_left_hip * z2844;
    const Scalar z2909 = k6 * z2624 + k7 * z2896 - n0_032 * z2653;  // moment on front_left_shank_link, y
    const Scalar z2910 = k9 * z2904;  // moment on front_left_shank_link, z
    const Scalar z2893 = s_front_right_hip * z2887 + c_front_right_hip * z2888;
    const Scalar z2892 = s_front_right_hip * z2888 - c_front_right_hip * z2887;
    const Scalar z2852 = s_rear_left_hip * z2847 + c_rear_left_hip * z2848;
    const Scalar z2851 = s_rear_left_hip * z2848 - c_rear_left_hip * z2847;
    const Scalar z2952 = z2600 - z2878;
    const Scalar z2953 = z2601 - z2866;
    const Scalar z2915 = z2563 * z2565;
    const Scalar z2916 = z2640 + z2915;
    const Scalar z2927 = z2561 * z2562;
    const Scalar z2950 = z2598 - z2909;
    const Scalar z2951 = z2599 + z2889;
    const Scalar z2928 = z2624 + z2927;
    const Scalar z2912 = s_front_left_knee * z2905 - c_front_left_knee * z2907;
    const Scalar z2911 = s_front_left_knee * z2907 + c_front_left_knee * z2905;
    // moment on front_left_thigh_link, y
    const Scalar z2921 = k12 * z2624 - k13 * z2641 + n0_124 * z2637 + n0_2 * z2911 + z2909;
    const Scalar z2919 = n0_124 * z2647 - z2912;  // force on front_left_thigh_link, z
    const Scalar z2917 = n0_124 * z2642 + z2911;  // force on front_left_thigh_link, x
    const Scalar z2913 = s_front_left_knee * z2910 - c_front_left_knee * z2908;
    const Scalar z2914 = c_front_left_knee * z2910 + s_front_left_knee * z2908;
    const Scalar z2920 = n0_124 * z2635 - k15 * z2644 - n0_2 * z2906 - z2913;  // moment on front_left_thigh_link, x
    const Scalar z2918 = n0_124 * z2644 + z2906;  // force on front_left_thigh_link, y
    const Scalar z2922 = z2914 - n0_0002 * z2916;  // moment on front_left_thigh_link, z
    const Scalar z2930 = n0_1048 * z2630 + z2918;  // force on front_left_hip_link, y
    const Scalar z2949 = z2597 - z2921;
    const Scalar z2933 = z2921 + n0_0002 * z2928;  // moment on front_left_hip_link, y
    const Scalar z2923 = s_front_left_thigh * z2919 + c_front_left_thigh * z2917;
    const Scalar z2924 = s_front_left_thigh * z2917 - c_front_left_thigh * z2919;
    const Scalar z2929 = n0_1048 * z2627 + z2923;  // force on front_left_hip_link, x
    const Scalar z2926 = s_front_left_thigh * z2920 + c_front_left_thigh * z2922;
    const Scalar z2934 = n0_1048 * z2619 + k17 * z2627 + n0_08 * z2923 + z2926;  // moment on front_left_hip_link, z
    const Scalar z2925 = s_front_left_thigh * z2922 - c_front_left_thigh * z2920;
    const Scalar z2932 = n0_1048 * z2623 + k18 * z2631 + n0_08 * z2924 + z2925;  // moment on front_left_hip_link, x
    const Scalar z2931 = n0_1048 * z2631 + z2924;  // force on front_left_hip_link, z
    const Scalar z2948 = z2596 - z2932;
    const Scalar z2939 = n12_24 * z2608 - z2800 + z2843 - z2886 + z2929;  // force on trunk, x
    const Scalar z2894 = c_front_right_hip * z2890 + s_front_right_hip * z2891;
    const Scalar z2895 = s_front_right_hip * z2890 - c_front_right_hip * z2891;
    const Scalar z2955 = z2603 - z2835;
    const Scalar z2956 = z2604 - z2823;
    const Scalar z2958 = z2606 - z2792;
    const Scalar z2959 = z2607 - z2780;
    const Scalar z2954 = z2602 - z2846;
    const Scalar z2957 = z2605 + z2803;
    const Scalar z2936 = s_front_left_hip * z2930 + c_front_left_hip * z2931;
    // moment on trunk, x
    const Scalar z2942 = n0_0306 * z2618 + z2803 - z2846 + z2889 - z2932 - n0_05 * (z2807 + z2850 + z2893 + z2936);
    const Scalar z2935 = s_front_left_hip * z2931 - c_front_left_hip * z2930;
    const Scalar z2941 = n12_24 * z2610 + z2807 - z2850 + z2893 - z2936;  // force on trunk, z
    const Scalar z2940 = n12_24 * z2609 - z2806 + z2849 - z2892 + z2935;  // force on trunk, y
    const Scalar z2945 = z2545 * z2939 + z2559 * z2941 + z2546 * z2940;
    const Scalar z2946 = z2547 * z2939 + z2553 * z2941 + z2552 * z2940;
    const Scalar z2947 = z2558 * z2939 + z2557 * z2941 + z2554 * z2940;
    const Scalar z2937 = s_front_left_hip * z2934 - c_front_left_hip * z2933;
    // moment on trunk, y
    const Scalar z2943 = n0_3254 * z2617 + z2808 + z2894 - z2851 - z2937 - n0_2 * (z2807 - z2850 - z2893 + z2936);
    const Scalar z2938 = s_front_left_hip * z2933 + c_front_left_hip * z2934;
    // moment on trunk, z
    const Scalar z2944 = n0_2948 * z2614 - z2809 - n0_05 * (z2800 + z2843 + z2886 + z2929) - z2852 - z2895 - z2938
        + n0_2 * (z2806 - z2849 - z2892 + z2935);
    forces.trunk_x = z2945;
    forces.trunk_y = z2946;
    forces.trunk_z = z2947;
    forces.trunk_attitude_omega_x = z2942;
    forces.trunk_attitude_omega_y = -z2943;
    forces.trunk_attitude_omega_z = z2944;
    forces.front_left_hip = z2948;
    forces.front_left_thigh = z2949;
    forces.front_left_knee = z2950;
    forces.front_right_hip = z2951;
    forces.front_right_thigh = z2952;
    forces.front_right_knee = z2953;
    forces.rear_left_hip = z2954;
    forces.rear_left_thigh = z2955;
    forces.rear_left_knee = z2956;
    forces.rear_right_hip = z2957;
    forces.rear_right_thigh = z2958;
    forces.rear_right_knee = z2959;
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
    const Scalar k7 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar k8 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k10 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar k11 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k12 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar k13 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k15 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k17 = traits::constant(0.0082038, 0.0082038f, "41019/5000000");
    const Scalar k18 = traits::constant(0.0080038, 0.0080038f, "40019/5000000");
    const Scalar k19 = traits::constant(0.0084038, 0.0084038f, "42019/5000000");
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
    const Scalar z3278 = n2 * q_trunk_attitude_y;
    const Scalar z3280 = n2 * q_trunk_attitude_z;
    const Scalar z3287 = n2 * q_trunk_attitude_x;
    const Scalar z3326 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z3281 = q_trunk_attitude_z * z3280;
    const Scalar z3282 = q_trunk_attitude_x * z3278;
    const Scalar z3283 = q_trunk_attitude_w * z3280;
    const Scalar z3294 = q_trunk_attitude_x * z3280;
    const Scalar z3295 = q_trunk_attitude_w * z3278;
    const Scalar z3288 = q_trunk_attitude_x * z3287;
    const Scalar z3285 = z3282 - z3283;
    const Scalar z3289 = q_trunk_attitude_z * z3278;
    const Scalar z3290 = q_trunk_attitude_w * z3287;
    const Scalar z3298 = z3294 + z3295;
    const Scalar z3279 = q_trunk_attitude_y * z3278;
    const Scalar z3291 = n1 - z3281 - z3288;
    const Scalar z3286 = z3282 + z3283;
    const Scalar z3292 = z3289 - z3290;
    const Scalar z3293 = z3289 + z3290;
    const Scalar z3297 = z3294 - z3295;
    const Scalar z3296 = n1 - z3279 - z3288;
    const Scalar z3284 = n1 - z3279 - z3281;
    const Scalar z3348 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z3351 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z3353 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z3328 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z3352 = z3348 + z3351;
    const Scalar z3347 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z3350 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z3354 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z3317 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z3327 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z3319 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z3349 = z3347 + z3348;
    const Scalar z3318 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z3310 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z3308 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z3301 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z3309 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z3300 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z3299 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z3357 = z3301 * z3301;
    const Scalar z3335 = n0_05 * v_front_left_hip;
    const Scalar z3336 = n0_05 * v_front_left_thigh;
    const Scalar z3337 = n0_05 * v_front_left_knee;
    const Scalar z3338 = n0_05 * v_front_right_hip;
    const Scalar z3339 = n0_05 * v_front_right_thigh;
    const Scalar z3340 = n0_05 * v_front_right_knee;
    const Scalar z3341 = n0_05 * v_rear_left_hip;
    const Scalar z3342 = n0_05 * v_rear_left_thigh;
    const Scalar z3343 = n0_05 * v_rear_left_knee;
    const Scalar z3344 = n0_05 * v_rear_right_hip;
    const Scalar z3345 = n0_05 * v_rear_right_thigh;
    const Scalar z3346 = n0_05 * v_rear_right_knee;
    const Scalar z3302 = c_front_left_thigh * z3301 + s_front_left_thigh * z3300;
    const Scalar z3303 = s_front_left_thigh * z3301 - c_front_left_thigh * z3300;
    const Scalar z3304 = v_front_left_thigh + z3299;
    const Scalar z3311 = c_front_right_thigh * z3310 + s_front_right_thigh * z3309;
    const Scalar z3312 = s_front_right_thigh * z3310 - c_front_right_thigh * z3309;
    const Scalar z3313 = v_front_right_thigh + z3308;
    const Scalar z3320 = c_rear_left_thigh * z3319 + s_rear_left_thigh * z3318;
    const Scalar z3321 = s_rear_left_thigh * z3319 - c_rear_left_thigh * z3318;
    const Scalar z3322 = v_rear_left_thigh + z3317;
    const Scalar z3329 = c_rear_right_thigh * z3328 + s_rear_right_thigh * z3327;
    const Scalar z3330 = s_rear_right_thigh * z3328 - c_rear_right_thigh * z3327;
    const Scalar z3331 = v_rear_right_thigh + z3326;
    const Scalar z3355 = z3299 * z3301;
    const Scalar z3356 = z3300 * z3300;
    const Scalar z3359 = z3299 * z3300;
    const Scalar z3307 = v_front_left_knee + z3304;
    const Scalar z3316 = v_front_right_knee + z3313;
    const Scalar z3325 = v_rear_left_knee + z3322;
    const Scalar z3334 = v_rear_right_knee + z3331;
    const Scalar z3358 = z3356 + z3357;
    const Scalar z3363 = z3304 * z3304;
    const Scalar z3305 = s_front_left_knee * z3303 - c_front_left_knee * z3302;
    const Scalar z3332 = s_rear_right_knee * z3330 - c_rear_right_knee * z3329;
    const Scalar z3333 = s_rear_right_knee * z3329 + c_rear_right_knee * z3330;
    const Scalar z3323 = s_rear_left_knee * z3321 - c_rear_left_knee * z3320;
    const Scalar z3324 = s_rear_left_knee * z3320 + c_rear_left_knee * z3321;
    const Scalar z3314 = s_front_right_knee * z3312 - c_front_right_knee * z3311;
    const Scalar z3315 = s_front_right_knee * z3311 + c_front_right_knee * z3312;
    const Scalar z3365 = z3308 * z3310;
    const Scalar z3306 = s_front_left_knee * z3302 + c_front_left_knee * z3303;
    const Scalar z3385 = z3326 * z3328;
    const Scalar z3389 = z3326 * z3327;
    const Scalar z3379 = z3317 * z3318;
    const Scalar z3386 = z3327 * z3327;
    const Scalar z3387 = z3328 * z3328;
    const Scalar z3388 = z3386 + z3387;
    const Scalar z3403 = z3327 * z3328;
    const Scalar z3375 = z3317 * z3319;
    const Scalar z3376 = z3318 * z3318;
    const Scalar z3377 = z3319 * z3319;
    const Scalar z3378 = z3376 + z3377;
    const Scalar z3412 = z3318 * z3319;
    const Scalar z3391 = z3330 * z3331;
    const Scalar z3395 = z3332 * z3333;
    const Scalar z3381 = z3321 * z3322;
    const Scalar z3392 = z3329 * z3329;
    const Scalar z3393 = z3331 * z3331;
    const Scalar z3394 = z3392 + z3393;
    const Scalar z3402 = z3329 * z3331;
    const Scalar z3397 = z3332 * z3332;
    const Scalar z3398 = z3334 * z3334;
    const Scalar z3399 = z3397 + z3398;
    const Scalar z3369 = z3308 * z3309;
    const Scalar z3404 = z3323 * z3324;
    const Scalar z3400 = z3332 * z3334;
    const Scalar z3396 = z3333 * z3334;
    const Scalar z3390 = z3329 * z3330;
    const Scalar z3401 = n0_032 * z3399;  // force on rear_right_shank_link, z
    const Scalar z3382 = z3320 * z3320;
    const Scalar z3383 = z3322 * z3322;
    const Scalar z3384 = z3382 + z3383;
    const Scalar z3411 = z3320 * z3322;
    const Scalar z3406 = z3323 * z3323;
    const Scalar z3407 = z3325 * z3325;
    const Scalar z3408 = z3406 + z3407;
    const Scalar z3366 = z3309 * z3309;
    const Scalar z3367 = z3310 * z3310;
    const Scalar z3368 = z3366 + z3367;
    const Scalar z3409 = z3323 * z3325;
    const Scalar z3405 = z3324 * z3325;
    const Scalar z3410 = n0_032 * z3408;  // force on rear_left_shank_link, z
    const Scalar z3413 = z3314 * z3315;
    const Scalar z3380 = z3320 * z3321;
    const Scalar z3371 = z3312 * z3313;
    const Scalar z3415 = z3314 * z3314;
    const Scalar z3416 = z3316 * z3316;
    const Scalar z3417 = z3415 + z3416;
    const Scalar z3372 = z3311 * z3311;
    const Scalar z3373 = z3313 * z3313;
    const Scalar z3374 = z3372 + z3373;
    const Scalar z3361 = z3303 * z3304;
    const Scalar z3418 = z3314 * z3316;
    const Scalar z3419 = n0_032 * z3417;  // force on front_right_shank_link, z
    const Scalar z3414 = z3315 * z3316;
    const Scalar z3370 = z3311 * z3312;
    const Scalar z3360 = z3302 * z3303;
    const Scalar z3420 = z3311 * z3313;
    const Scalar z3421 = z3309 * z3310;
    const Scalar z3362 = z3302 * z3302;
    const Scalar z3364 = z3362 + z3363;
    const Scalar z3429 = z3302 * z3304;
    const Scalar z3430 = z3300 * z3301;
    const Scalar z3431 = n9_81 + a_trunk_z;
    const Scalar z3433 = a_trunk_x * z3285 + a_trunk_y * z3291 + z3293 * z3431;
    const Scalar z3434 = a_trunk_x * z3298 + a_trunk_y * z3292 + z3296 * z3431;
    const Scalar z3432 = a_trunk_y * z3286 + z3297 * z3431 + a_trunk_x * z3284;
    const Scalar z3437 = a_trunk_attitude_omega_y - z3353;
    const Scalar z3436 = a_trunk_attitude_omega_z + z3350;
    const Scalar z3438 = a_trunk_attitude_omega_x + z3354;
    const Scalar z3435 = a_trunk_attitude_omega_z - z3350;
    const Scalar z3473 = a_trunk_attitude_omega_y * s_front_right_hip - a_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z3481 = v_front_right_hip * z3308 + z3473;  // angular acceleration of front_right_hip_link, z
    // angular acceleration of front_right_hip_link, x
    const Scalar z3479 = a_trunk_attitude_omega_x + a_front_right_hip;
    const Scalar z3472 = a_trunk_attitude_omega_y * c_front_right_hip + a_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z3480 = v_front_right_hip * z3309 - z3472;  // angular acceleration of front_right_hip_link, y
    const Scalar z3440 = a_trunk_attitude_omega_y * s_front_left_hip - a_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z3448 = v_front_left_hip * z3299 + z3440;  // angular acceleration of front_left_hip_link, z
    const Scalar z3475 = n0_05 * z3352 + z3433 + n0_2 * z3436;
    const Scalar z3446 = a_trunk_attitude_omega_x + a_front_left_hip;  // angular acceleration of front_left_hip_link, x
    const Scalar z3439 = a_trunk_attitude_omega_y * c_front_left_hip + a_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z3447 = v_front_left_hip * z3300 - z3439;  // angular acceleration of front_left_hip_link, y
    const Scalar z3449 = z3355 + z3448;
    const Scalar z3476 = z3434 - n0_2 * z3437 - n0_05 * z3438;
    const Scalar z3442 = n0_05 * z3352 - z3433 - n0_2 * z3436;
    const Scalar z3478 = s_front_right_hip * z3475 - c_front_right_hip * z3476;
    const Scalar z3477 = s_front_right_hip * z3476 + c_front_right_hip * z3475;
    const Scalar z3451 = c_front_left_thigh * z3446 + s_front_left_thigh * z3448;
    const Scalar z3458 = v_front_left_thigh * z3303 - z3451;  // angular acceleration of front_left_thigh_link, x
    const Scalar z3452 = s_front_left_thigh * z3446 - c_front_left_thigh * z3448;
    const Scalar z3460 = v_front_left_thigh * z3302 + z3452;  // angular acceleration of front_left_thigh_link, z
    const Scalar z3443 = z3434 - n0_2 * z3437 + n0_05 * z3438;
    const Scalar z3462 = z3361 + z3458;
    const Scalar z3459 = a_front_left_thigh - z3447;  // angular acceleration of front_left_thigh_link, y
    const Scalar z3474 = n0_2 * z3349 - z3432 - n0_05 * z3435;
    const Scalar z3422 = z3305 * z3306;
    const Scalar z3482 = z3365 + z3481;
    const Scalar z3470 = a_front_left_knee + z3459;  // angular acceleration of front_left_shank_link, y
    const Scalar z3445 = s_front_left_hip * z3442 + c_front_left_hip * z3443;
    const Scalar z3444 = s_front_left_hip * z3443 - c_front_left_hip * z3442;
    const Scalar z3454 = n0_08 * z3358 - z3444;
    const Scalar z3450 = z3359 - z3446;
    const Scalar z3424 = z3305 * z3305;
    const Scalar z3425 = z3307 * z3307;
    const Scalar z3426 = z3424 + z3425;
    const Scalar z3441 = n0_2 * z3349 - z3432 + n0_05 * z3435;
    const Scalar z3455 = z3445 - n0_08 * z3450;
    const Scalar z3428 = n0_032 * z3426;  // force on front_left_shank_link, z
    const Scalar z3464 = s_front_left_knee * z3458 - c_front_left_knee * z3460;
    const Scalar z3463 = s_front_left_knee * z3460 + c_front_left_knee * z3458;
    const Scalar z3471 = v_front_left_knee * z3305 + z3464;  // angular acceleration of front_left_shank_link, z
    const Scalar z3427 = z3305 * z3307;
    const Scalar z3423 = z3306 * z3307;
    const Scalar z3469 = v_front_left_knee * z3306 + z3463;  // angular acceleration of front_left_shank_link, x
    const Scalar z3487 = n0_08 * z3368 + z3477;
    const Scalar z3506 = a_trunk_attitude_omega_y * s_rear_left_hip - a_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z3512 = a_trunk_attitude_omega_x + a_rear_left_hip;  // angular acceleration of rear_left_hip_link, x
    const Scalar z3508 = n0_05 * z3352 - z3433 + n0_2 * z3436;
    const Scalar z3505 = a_trunk_attitude_omega_y * c_rear_left_hip + a_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z3509 = z3434 + n0_2 * z3437 + n0_05 * z3438;
    const Scalar z3511 = s_rear_left_hip * z3508 + c_rear_left_hip * z3509;
    const Scalar z3510 = s_rear_left_hip * z3509 - c_rear_left_hip * z3508;
    const Scalar z3484 = c_front_right_thigh * z3479 + s_front_right_thigh * z3481;
    const Scalar z3491 = v_front_right_thigh * z3312 - z3484;  // angular acceleration of front_right_thigh_link, x
    const Scalar z3485 = s_front_right_thigh * z3479 - c_front_right_thigh * z3481;
    const Scalar z3493 = v_front_right_thigh * z3311 + z3485;  // angular acceleration of front_right_thigh_link, z
    const Scalar z3507 = n0_2 * z3349 + z3432 - n0_05 * z3435;
    const Scalar z3495 = z3371 + z3491;
    const Scalar z3492 = a_front_right_thigh - z3480;  // angular acceleration of front_right_thigh_link, y
    const Scalar z3483 = z3369 - z3479;
    const Scalar z3503 = a_front_right_knee + z3492;  // angular acceleration of front_right_shank_link, y
    const Scalar z3488 = z3478 - n0_08 * z3483;
    const Scalar z3497 = s_front_right_knee * z3491 - c_front_right_knee * z3493;
    const Scalar z3496 = s_front_right_knee * z3493 + c_front_right_knee * z3491;
    const Scalar z3504 = v_front_right_knee * z3314 + z3497;  // angular acceleration of front_right_shank_link, z
    const Scalar z3486 = z3474 + n0_08 * z3482;
    const Scalar z3502 = v_front_right_knee * z3315 + z3496;  // angular acceleration of front_right_shank_link, x
    const Scalar z3490 = c_front_right_thigh * z3488 + s_front_right_thigh * z3486;
    const Scalar z3489 = s_front_right_thigh * z3488 - c_front_right_thigh * z3486;
    const Scalar z3499 = z3487 - n0_2 * z3495;
    const Scalar z3500 = n0_2 * z3374 - z3490;
    const Scalar z3453 = z3441 - n0_08 * z3449;
    const Scalar z3514 = v_rear_left_hip * z3317 + z3506;  // angular acceleration of rear_left_hip_link, z
    const Scalar z3513 = v_rear_left_hip * z3318 - z3505;  // angular acceleration of rear_left_hip_link, y
    const Scalar z3515 = z3375 + z3514;
    const Scalar z3494 = z3370 + z3492;
    const Scalar z3456 = s_front_left_thigh * z3455 + c_front_left_thigh * z3453;
    const Scalar z3457 = s_front_left_thigh * z3453 - c_front_left_thigh * z3455;
    const Scalar z3520 = n0_08 * z3378 - z3510;
    const Scalar z3467 = n0_2 * z3364 - z3457;
    const Scalar z3517 = c_rear_left_thigh * z3512 + s_rear_left_thigh * z3514;
    const Scalar z3518 = s_rear_left_thigh * z3512 - c_rear_left_thigh * z3514;
    const Scalar z3516 = z3379 - z3512;
    const Scalar z3519 = z3507 + n0_08 * z3515;
    const Scalar z3461 = z3360 + z3459;
    const Scalar z3524 = v_rear_left_thigh * z3321 - z3517;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z3521 = z3511 - n0_08 * z3516;
    const Scalar z3466 = z3454 + n0_2 * z3462;
    const Scalar z3523 = c_rear_left_thigh * z3521 + s_rear_left_thigh * z3519;
    const Scalar z3522 = s_rear_left_thigh * z3521 - c_rear_left_thigh * z3519;
    const Scalar z3498 = z3489 - n0_2 * z3494;
    const Scalar z3501 = s_front_right_knee * z3500 - c_front_right_knee * z3498;
    const Scalar z3465 = z3456 + n0_2 * z3461;
    const Scalar z3526 = v_rear_left_thigh * z3320 + z3518;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z3468 = c_front_left_knee * z3465 + s_front_left_knee * z3467;
    const Scalar z3541 = n0_05 * z3352 + z3433 - n0_2 * z3436;
    const Scalar z3542 = z3434 + n0_2 * z3437 - n0_05 * z3438;
    const Scalar z3540 = n0_2 * z3349 + z3432 + n0_05 * z3435;
    const Scalar z3528 = z3381 + z3524;
    const Scalar z3533 = n0_2 * z3384 + z3523;
    const Scalar z3539 = a_trunk_attitude_omega_y * s_rear_right_hip - a_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z3547 = v_rear_right_hip * z3326 + z3539;  // angular acceleration of rear_right_hip_link, z
    const Scalar z3545 = a_trunk_attitude_omega_x + a_rear_right_hip;  // angular acceleration of rear_right_hip_link, x
    const Scalar z3538 = a_trunk_attitude_omega_y * c_rear_right_hip + a_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z3546 = v_rear_right_hip * z3327 - z3538;  // angular acceleration of rear_right_hip_link, y
    const Scalar z3548 = z3385 + z3547;
    const Scalar z3550 = c_rear_right_thigh * z3545 + s_rear_right_thigh * z3547;
    const Scalar z3551 = s_rear_right_thigh * z3545 - c_rear_right_thigh * z3547;
    const Scalar z3558 = a_rear_right_thigh - z3546;  // angular acceleration of rear_right_thigh_link, y
    const Scalar z3544 = s_rear_right_hip * z3541 - c_rear_right_hip * z3542;
    const Scalar z3557 = v_rear_right_thigh * z3330 - z3550;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z3559 = v_rear_right_thigh * z3329 + z3551;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z3543 = s_rear_right_hip * z3542 + c_rear_right_hip * z3541;
    const Scalar z3553 = n0_08 * z3388 + z3543;
    const Scalar z3561 = z3391 + z3557;
    const Scalar z3583 = z3402 + z3559;
    const Scalar z3549 = z3389 - z3545;
    const Scalar z3552 = z3540 - n0_08 * z3548;
    const Scalar z3569 = a_rear_right_knee + z3558;  // angular acceleration of rear_right_shank_link, y
    const Scalar z3525 = a_rear_left_thigh - z3513;  // angular acceleration of rear_left_thigh_link, y
    const Scalar z3563 = s_rear_right_knee * z3557 - c_rear_right_knee * z3559;
    const Scalar z3562 = s_rear_right_knee * z3559 + c_rear_right_knee * z3557;
    const Scalar z3570 = v_rear_right_knee * z3332 + z3563;  // angular acceleration of rear_right_shank_link, z
    const Scalar z3568 = v_rear_right_knee * z3333 + z3562;  // angular acceleration of rear_right_shank_link, x
    const Scalar z3554 = z3544 - n0_08 * z3549;
    const Scalar z3573 = z3400 + z3570;
    const Scalar z3571 = z3395 - z3569;
    const Scalar z3572 = z3396 + z3568;
    const Scalar z3574 = n0_032 * z3571;  // force on rear_right_shank_link, x
    const Scalar z3536 = a_rear_left_knee + z3525;  // angular acceleration of rear_left_shank_link, y
    const Scalar z3530 = s_rear_left_knee * z3524 - c_rear_left_knee * z3526;
    const Scalar z3537 = v_rear_left_knee * z3323 + z3530;  // angular acceleration of rear_left_shank_link, z
    const Scalar z3529 = s_rear_left_knee * z3526 + c_rear_left_knee * z3524;
    const Scalar z3535 = v_rear_left_knee * z3324 + z3529;  // angular acceleration of rear_left_shank_link, x
    const Scalar z3578 = k7 * z3573;  // moment on rear_right_shank_link, z
    const Scalar z3556 = s_rear_right_thigh * z3552 - c_rear_right_thigh * z3554;
    const Scalar z3555 = s_rear_right_thigh * z3554 + c_rear_right_thigh * z3552;
    const Scalar z3566 = n0_2 * z3394 + z3556;
    const Scalar z3565 = z3553 - n0_2 * z3561;
    const Scalar z3576 = n0_032 * z3565 - k8 * z3572;  // moment on rear_right_shank_link, x
    const Scalar z3575 = n0_032 * z3572;  // force on rear_right_shank_link, y
    const Scalar z3560 = z3390 + z3558;
    const Scalar z3532 = z3520 + n0_2 * z3528;
    const Scalar z3527 = z3380 + z3525;
    const Scalar z3564 = z3555 - n0_2 * z3560;
    const Scalar z3580 = s_rear_right_knee * z3574 - c_rear_right_knee * z3401;
    const Scalar z3579 = s_rear_right_knee * z3401 + c_rear_right_knee * z3574;
    const Scalar z3567 = s_rear_right_knee * z3566 - c_rear_right_knee * z3564;
    const Scalar z3586 = n0_124 * z3394 - z3580;  // force on rear_right_thigh_link, z
    const Scalar z3577 = k10 * z3395 - k11 * z3569 - n0_032 * z3567;  // moment on rear_right_shank_link, y
    const Scalar z3584 = n0_124 * z3560 - z3579;  // force on rear_right_thigh_link, x
    const Scalar z3531 = z3522 + n0_2 * z3527;
    // moment on rear_right_thigh_link, y
    const Scalar z3588 = k12 * z3390 + k13 * z3558 - n0_124 * z3555 - n0_2 * z3579 - z3577;
    const Scalar z3534 = s_rear_left_knee * z3533 + c_rear_left_knee * z3531;
    const Scalar z3607 = z3409 + z3537;
    const Scalar z3606 = z3405 + z3535;
    const Scalar z3640 = z3414 + z3502;
    const Scalar z3594 = z3403 + z3546;
    const Scalar z3617 = z3411 + z3526;
    const Scalar z3628 = z3412 + z3513;
    const Scalar z3612 = k7 * z3607;  // moment on rear_left_shank_link, z
    const Scalar z3610 = n0_032 * z3532 + k8 * z3606;  // moment on rear_left_shank_link, x
    const Scalar z3609 = n0_032 * z3606;  // force on rear_left_shank_link, y
    const Scalar z3611 = k10 * z3404 - k11 * z3536 - n0_032 * z3534;  // moment on rear_left_shank_link, y
    const Scalar z3605 = z3404 - z3536;
    const Scalar z3608 = n0_032 * z3605;  // force on rear_left_shank_link, x
    const Scalar z3599 = z3588 - n0_0002 * z3594;  // moment on rear_right_hip_link, y
    const Scalar z3639 = z3413 - z3503;
    const Scalar z3581 = s_rear_right_knee * z3578 - c_rear_right_knee * z3576;
    const Scalar z3582 = c_rear_right_knee * z3578 + s_rear_right_knee * z3576;
    const Scalar z3641 = z3418 + z3504;
    const Scalar z3587 = n0_124 * z3553 - k15 * z3561 - n0_2 * z3575 - z3581;  // moment on rear_right_thigh_link, x
    const Scalar z3589 = z3582 - n0_0002 * z3583;  // moment on rear_right_thigh_link, z
    const Scalar z3585 = n0_124 * z3561 + z3575;  // force on rear_right_thigh_link, y
    const Scalar z3645 = k10 * z3413 - k11 * z3503 - n0_032 * z3501;  // moment on front_right_shank_link, y
    const Scalar z3596 = n0_1048 * z3388 - z3585;  // force on rear_right_hip_link, y
    const Scalar z3642 = n0_032 * z3639;  // force on front_right_shank_link, x
    const Scalar z3646 = k7 * z3641;  // moment on front_right_shank_link, z
    const Scalar z3644 = n0_032 * z3499 - k8 * z3640;  // moment on front_right_shank_link, x
    const Scalar z3643 = n0_032 * z3640;  // force on front_right_shank_link, y
    const Scalar z3614 = s_rear_left_knee * z3608 - c_rear_left_knee * z3410;
    const Scalar z3613 = s_rear_left_knee * z3410 + c_rear_left_knee * z3608;
    // moment on rear_left_thigh_link, y
    const Scalar z3622 = k12 * z3380 + k13 * z3525 + n0_124 * z3522 - n0_2 * z3613 - z3611;
    const Scalar z3620 = n0_124 * z3384 - z3614;  // force on rear_left_thigh_link, z
    const Scalar z3618 = n0_124 * z3527 - z3613;  // force on rear_left_thigh_link, x
    const Scalar z3615 = s_rear_left_knee * z3612 + c_rear_left_knee * z3610;
    const Scalar z3616 = s_rear_left_knee * z3610 - c_rear_left_knee * z3612;
    const Scalar z3621 = n0_124 * z3520 + k15 * z3528 + n0_2 * z3609 + z3615;  // moment on rear_left_thigh_link, x
    const Scalar z3623 = z3616 + n0_0002 * z3617;  // moment on rear_left_thigh_link, z
    const Scalar z3619 = n0_124 * z3528 + z3609;  // force on rear_left_thigh_link, y
    const Scalar z3630 = n0_1048 * z3378 + z3619;  // force on rear_left_hip_link, y
    const Scalar z3633 = z3622 - n0_0002 * z3628;  // moment on rear_left_hip_link, y
    const Scalar z3648 = s_front_right_knee * z3642 - c_front_right_knee * z3419;
    const Scalar z3647 = s_front_right_knee * z3419 + c_front_right_knee * z3642;
    const Scalar z3590 = s_rear_right_thigh * z3586 - c_rear_right_thigh * z3584;
    const Scalar z3591 = s_rear_right_thigh * z3584 + c_rear_right_thigh * z3586;
    const Scalar z3651 = z3420 + z3493;
    const Scalar z3597 = n0_1048 * z3549 + z3591;  // force on rear_right_hip_link, z
    const Scalar z3593 = s_rear_right_thigh * z3587 + c_rear_right_thigh * z3589;
    const Scalar z3600 = n0_1048 * z3540 - k17 * z3548 + n0_08 * z3590 - z3593;  // moment on rear_right_hip_link, z
    const Scalar z3595 = n0_1048 * z3548 - z3590;  // force on rear_right_hip_link, x
    const Scalar z3592 = s_rear_right_thigh * z3589 - c_rear_right_thigh * z3587;
    // moment on rear_right_hip_link, x
    const Scalar z3598 = k18 * z3389 - n0_1048 * z3544 - k19 * z3545 + n0_08 * z3591 + z3592;
    // moment on front_right_thigh_link, y
    const Scalar z3656 = k12 * z3370 + k13 * z3492 - n0_124 * z3489 - n0_2 * z3647 - z3645;
    const Scalar z3654 = n0_124 * z3374 - z3648;  // force on front_right_thigh_link, z
    const Scalar z3652 = n0_124 * z3494 - z3647;  // force on front_right_thigh_link, x
    const Scalar z3624 = s_rear_left_thigh * z3620 - c_rear_left_thigh * z3618;
    const Scalar z3625 = s_rear_left_thigh * z3618 + c_rear_left_thigh * z3620;
    const Scalar z3631 = n0_1048 * z3516 - z3625;  // force on rear_left_hip_link, z
    const Scalar z3649 = s_front_right_knee * z3646 - c_front_right_knee * z3644;
    const Scalar z3650 = c_front_right_knee * z3646 + s_front_right_knee * z3644;
    const Scalar z3655 = n0_124 * z3487 - k15 * z3495 - n0_2 * z3643 - z3649;  // moment on front_right_thigh_link, x
    const Scalar z3653 = n0_124 * z3495 + z3643;  // force on front_right_thigh_link, y
    const Scalar z3657 = z3650 - n0_0002 * z3651;  // moment on front_right_thigh_link, z
    const Scalar z3627 = s_rear_left_thigh * z3621 + c_rear_left_thigh * z3623;
    const Scalar z3634 = n0_1048 * z3507 + k17 * z3515 + n0_08 * z3624 - z3627;  // moment on rear_left_hip_link, z
    const Scalar z3629 = n0_1048 * z3515 + z3624;  // force on rear_left_hip_link, x
    const Scalar z3626 = s_rear_left_thigh * z3623 - c_rear_left_thigh * z3621;
    // moment on rear_left_hip_link, x
    const Scalar z3632 = k18 * z3379 - n0_1048 * z3511 - k19 * z3512 - n0_08 * z3625 - z3626;
    const Scalar z3658 = s_front_right_thigh * z3654 - c_front_right_thigh * z3652;
    const Scalar z3659 = s_front_right_thigh * z3652 + c_front_right_thigh * z3654;
    const Scalar z3604 = s_rear_right_hip * z3599 + c_rear_right_hip * z3600;
    const Scalar z3603 = s_rear_right_hip * z3600 - c_rear_right_hip * z3599;
    const Scalar z3602 = s_rear_right_hip * z3596 + c_rear_right_hip * z3597;
    const Scalar z3601 = s_rear_right_hip * z3597 - c_rear_right_hip * z3596;
    const Scalar z3675 = z3427 + z3471;
    const Scalar z3674 = z3423 + z3469;
    const Scalar z3662 = z3421 + z3480;
    const Scalar z3664 = n0_1048 * z3368 - z3653;  // force on front_right_hip_link, y
    const Scalar z3685 = z3429 + z3460;
    const Scalar z3680 = k7 * z3675;  // moment on front_left_shank_link, z
    const Scalar z3678 = n0_032 * z3466 + k8 * z3674;  // moment on front_left_shank_link, x
    const Scalar z3677 = n0_032 * z3674;  // force on front_left_shank_link, y
    const Scalar z3679 = k10 * z3422 - k11 * z3470 - n0_032 * z3468;  // moment on front_left_shank_link, y
    const Scalar z3673 = z3422 - z3470;
    const Scalar z3676 = n0_032 * z3673;  // force on front_left_shank_link, x
    const Scalar z3665 = n0_1048 * z3483 + z3659;  // force on front_right_hip_link, z
    const Scalar z3667 = z3656 - n0_0002 * z3662;  // moment on front_right_hip_link, y
    const Scalar z3683 = s_front_left_knee * z3680 + c_front_left_knee * z3678;
    const Scalar z3684 = s_front_left_knee * z3678 - c_front_left_knee * z3680;
    const Scalar z3689 = n0_124 * z3454 + k15 * z3462 + n0_2 * z3677 + z3683;  // moment on front_left_thigh_link, x
    const Scalar z3687 = n0_124 * z3462 + z3677;  // force on front_left_thigh_link, y
    const Scalar z3691 = z3684 + n0_0002 * z3685;  // moment on front_left_thigh_link, z
    const Scalar z3682 = s_front_left_knee * z3676 - c_front_left_knee * z3428;
    const Scalar z3681 = s_front_left_knee * z3428 + c_front_left_knee * z3676;
    // moment on front_left_thigh_link, y
    const Scalar z3690 = k12 * z3360 + k13 * z3459 + n0_124 * z3456 - n0_2 * z3681 - z3679;
    const Scalar z3688 = n0_124 * z3364 - z3682;  // force on front_left_thigh_link, z
    const Scalar z3686 = n0_124 * z3461 - z3681;  // force on front_left_thigh_link, x
    const Scalar z3692 = s_front_left_thigh * z3688 - c_front_left_thigh * z3686;
    const Scalar z3693 = s_front_left_thigh * z3686 + c_front_left_thigh * z3688;
    const Scalar z3663 = n0_1048 * z3482 - z3658;  // force on front_right_hip_link, x
    const Scalar z3637 = c_rear_left_hip * z3633 + s_rear_left_hip * z3634;
    const Scalar z3638 = s_rear_left_hip * z3633 - c_rear_left_hip * z3634;
    const Scalar z3661 = s_front_right_thigh * z3655 + c_front_right_thigh * z3657;
    const Scalar z3668 = n0_1048 * z3474 + k17 * z3482 - n0_08 * z3658 + z3661;  // moment on front_right_hip_link, z
    const Scalar z3660 = s_front_right_thigh * z3657 - c_front_right_thigh * z3655;
    // moment on front_right_hip_link, x
    const Scalar z3666 = k18 * z3369 - n0_1048 * z3478 - k19 * z3479 + n0_08 * z3659 + z3660;
    const Scalar z3636 = s_rear_left_hip * z3630 + c_rear_left_hip * z3631;
    const Scalar z3635 = s_rear_left_hip * z3631 - c_rear_left_hip * z3630;
    const Scalar z3718 = z3337 - z3679;
    const Scalar z3720 = z3339 + z3656;
    const Scalar z3721 = z3340 - z3645;
    const Scalar z3723 = z3342 + z3622;
    const Scalar z3724 = z3343 - z3611;
    const Scalar z3726 = z3345 + z3588;
    const Scalar z3727 = z3346 - z3577;
    const Scalar z3698 = n0_1048 * z3358 + z3687;  // force on front_left_hip_link, y
    const Scalar z3696 = z3430 + z3447;
    const Scalar z3717 = z3336 + z3690;
    const Scalar z3701 = z3690 - n0_0002 * z3696;  // moment on front_left_hip_link, y
    const Scalar z3719 = z3338 - z3666;
    const Scalar z3722 = z3341 - z3632;
    const Scalar z3725 = z3344 - z3598;
    const Scalar z3699 = n0_1048 * z3450 - z3693;  // force on front_left_hip_link, z
    const Scalar z3697 = n0_1048 * z3449 + z3692;  // force on front_left_hip_link, x
    const Scalar z3707 = n12_24 * z3432 - z3595 + z3629 - z3663 + z3697;  // force on trunk, x
    const Scalar z3670 = s_front_right_hip * z3664 + c_front_right_hip * z3665;
    const Scalar z3669 = s_front_right_hip * z3665 - c_front_right_hip * z3664;
    const Scalar z3695 = s_front_left_thigh * z3689 + c_front_left_thigh * z3691;
    const Scalar z3702 = n0_1048 * z3441 - k17 * z3449 - n0_08 * z3692 + z3695;  // moment on front_left_hip_link, z
    const Scalar z3694 = s_front_left_thigh * z3691 - c_front_left_thigh * z3689;
    // moment on front_left_hip_link, x
    const Scalar z3700 = k18 * z3359 - n0_1048 * z3445 - k19 * z3446 - n0_08 * z3693 - z3694;
    const Scalar z3716 = z3335 - z3700;
    const Scalar z3671 = c_front_right_hip * z3667 + s_front_right_hip * z3668;
    const Scalar z3672 = s_front_right_hip * z3667 - c_front_right_hip * z3668;
    const Scalar z3704 = s_front_left_hip * z3698 + c_front_left_hip * z3699;
    // moment on trunk, x
    const Scalar z3710 = n0_0406 * a_trunk_attitude_omega_x - z3598 + n0_0306 * z3354 - z3666 - z3632 - z3700 - n0_05
        * (z3602 + z3636 + z3670 + z3704);
    const Scalar z3703 = s_front_left_hip * z3699 - c_front_left_hip * z3698;
    const Scalar z3709 = n12_24 * z3434 + z3602 - z3636 + z3670 - z3704;  // force on trunk, z
    const Scalar z3708 = n12_24 * z3433 - z3601 + z3635 - z3669 + z3703;  // force on trunk, y
    const Scalar z3713 = z3284 * z3707 + z3298 * z3709 + z3285 * z3708;
    const Scalar z3714 = z3286 * z3707 + z3292 * z3709 + z3291 * z3708;
    const Scalar z3715 = z3297 * z3707 + z3296 * z3709 + z3293 * z3708;
    const Scalar z3706 = s_front_left_hip * z3701 + c_front_left_hip * z3702;
    // moment on trunk, z
    const Scalar z3712 = z3604 + n0_366 * a_trunk_attitude_omega_z + n0_2948 * z3350 - n0_05 * (z3595 + z3629 + z3663
        + z3697) + z3638 + z3672 + z3706 + n0_2 * (z3601 - z3635 - z3669 + z3703);
    const Scalar z3705 = s_front_left_hip * z3702 - c_front_left_hip * z3701;
    // moment on trunk, y
    const Scalar z3711 = z3637 + n0_3354 * a_trunk_attitude_omega_y - n0_3254 * z3353 + z3671 + n0_2 * (z3602 - z3636
        - z3670 + z3704) - z3603 - z3705;
    forces.trunk_x = z3713;
    forces.trunk_y = z3714;
    forces.trunk_z = z3715;
    forces.trunk_attitude_omega_x = z3710;
    forces.trunk_attitude_omega_y = z3711;
    forces.trunk_attitude_omega_z = z3712;
    forces.front_left_hip = z3716;
    forces.front_left_thigh = z3717;
    forces.front_left_knee = z3718;
    forces.front_right_hip = z3719;
    forces.front_right_thigh = z3720;
    forces.front_right_knee = z3721;
    forces.rear_left_hip = z3722;
    forces.rear_left_thigh = z3723;
    forces.rear_left_knee = z3724;
    forces.rear_right_hip = z3725;
    forces.rear_right_thigh = z3726;
    forces.rear_right_knee = z3727;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k11 = traits::constant(0.0050898, 0.0050898f, "25449/5000000");
    const Scalar k12 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k14 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k16 = traits::constant(0.20040707687490214, 0.20040707f, "1280/6387");
    const Scalar k17 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k18 = traits::constant(0.0329736, 0.0329736f, "41217/1250000");
    const Scalar k19 = traits::constant(0.0325736, 0.0325736f, "40717/1250000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar k21 = traits::constant(0.4970944, 0.4970944f, "77671/156250");
    const Scalar k22 = traits::constant(0.4664944, 0.4664944f, "291559/625000");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar k24 = traits::constant(195.71003601064663, 195.71004f, "1250000/6387");
    const Scalar k25 = traits::constant(6.262721152340692, 6.262721f, "40000/6387");
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
    const Scalar z5254 = k0 * s_rear_right_knee;
    const Scalar z5252 = n0_032 * c_rear_right_knee;
    const Scalar z5253 = n0_032 * s_rear_right_knee;
    const Scalar z5195 = n2 * q_trunk_attitude_y;
    const Scalar z5255 = k0 * c_rear_right_knee;
    const Scalar z5204 = n2 * q_trunk_attitude_x;
    const Scalar z5196 = q_trunk_attitude_y * z5195;
    const Scalar z5206 = q_trunk_attitude_z * z5195;
    const Scalar z5207 = q_trunk_attitude_w * z5204;
    const Scalar z5197 = n2 * q_trunk_attitude_z;
    const Scalar z5205 = q_trunk_attitude_x * z5204;
    const Scalar z5211 = q_trunk_attitude_x * z5197;
    const Scalar z5210 = z5206 + z5207;
    const Scalar z5212 = q_trunk_attitude_w * z5195;
    const Scalar z5213 = n1 - z5196 - z5205;
    const Scalar z5214 = z5211 - z5212;
    const Scalar z5243 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z5245 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z5234 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z5236 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z5244 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z5209 = z5206 - z5207;
    const Scalar z5225 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z5215 = z5211 + z5212;
    const Scalar z5227 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z5199 = q_trunk_attitude_x * z5195;
    const Scalar z5216 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z5218 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z5235 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z5226 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z5217 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z5198 = q_trunk_attitude_z * z5197;
    const Scalar z5200 = q_trunk_attitude_w * z5197;
    const Scalar z5208 = n1 - z5198 - z5205;
    const Scalar z5201 = n1 - z5196 - z5198;
    const Scalar z5203 = z5199 + z5200;
    const Scalar z5202 = z5199 - z5200;
    const Scalar z5274 = k0 * s_rear_left_knee;
    const Scalar z5275 = k0 * c_rear_left_knee;
    const Scalar z5272 = n0_032 * c_rear_left_knee;
    const Scalar z5273 = n0_032 * s_rear_left_knee;
    const Scalar z5256 = c_rear_right_knee * z5255;
    const Scalar z5257 = s_rear_right_knee * z5254;
    const Scalar z5258 = s_rear_right_knee * z5255;
    const Scalar z5261 = n0_124 + z5252;
    const Scalar z5276 = c_rear_left_knee * z5275;
    const Scalar z5277 = s_rear_left_knee * z5274;
    const Scalar z5278 = s_rear_left_knee * z5275;
    const Scalar z5259 = n0_4 * z5252 - z5257;
    const Scalar z5260 = n0_2 * z5253 + z5258;
    const Scalar z5262 = k7 + z5256;
    const Scalar z5263 = s_rear_right_thigh * z5253 - c_rear_right_thigh * z5261;
    const Scalar z5264 = c_rear_right_thigh * z5253 + s_rear_right_thigh * z5261;
    const Scalar z5219 = c_front_left_thigh * z5218 + s_front_left_thigh * z5217;
    const Scalar z5279 = n0_4 * z5272 - z5277;
    const Scalar z5220 = s_front_left_thigh * z5218 - c_front_left_thigh * z5217;
    const Scalar z5280 = n0_2 * z5273 + z5278;
    const Scalar z5221 = v_front_left_thigh + z5216;
    const Scalar z5281 = n0_124 + z5272;
    const Scalar z5228 = c_front_right_thigh * z5227 + s_front_right_thigh * z5226;
    const Scalar z5229 = s_front_right_thigh * z5227 - c_front_right_thigh * z5226;
    const Scalar z5230 = v_front_right_thigh + z5225;
    const Scalar z5237 = c_rear_left_thigh * z5236 + s_rear_left_thigh * z5235;
    const Scalar z5238 = s_rear_left_thigh * z5236 - c_rear_left_thigh * z5235;
    const Scalar z5239 = v_rear_left_thigh + z5234;
    const Scalar z5246 = c_rear_right_thigh * z5245 + s_rear_right_thigh * z5244;
    const Scalar z5248 = v_rear_right_thigh + z5243;
    const Scalar z5247 = s_rear_right_thigh * z5245 - c_rear_right_thigh * z5244;
    const Scalar z5265 = z5259 + z5262;
    const Scalar z5266 = n2 * z5260;
    const Scalar z5249 = s_rear_right_knee * z5247 - c_rear_right_knee * z5246;
    const Scalar z5267 = s_rear_right_thigh * z5265 + c_rear_right_thigh * z5266;
    const Scalar z5250 = s_rear_right_knee * z5246 + c_rear_right_knee * z5247;
    const Scalar z5240 = s_rear_left_knee * z5238 - c_rear_left_knee * z5237;
    const Scalar z5241 = s_rear_left_knee * z5237 + c_rear_left_knee * z5238;
    const Scalar z5251 = v_rear_right_knee + z5248;
    const Scalar z5231 = s_front_right_knee * z5229 - c_front_right_knee * z5228;
    const Scalar z5271 = c_rear_right_thigh * z5267 - z5260;
    const Scalar z5268 = s_rear_right_thigh * z5267;
    const Scalar z5232 = s_front_right_knee * z5228 + c_front_right_knee * z5229;
    const Scalar z5270 = z5259 - z5268;
    const Scalar z5269 = z5262 - z5268;
    const Scalar z5242 = v_rear_left_knee + z5239;
    const Scalar z5222 = s_front_left_knee * z5220 - c_front_left_knee * z5219;
    const Scalar z5282 = k7 + z5276;
    const Scalar z5223 = s_front_left_knee * z5219 + c_front_left_knee * z5220;
    const Scalar z5283 = s_rear_left_thigh * z5273 - c_rear_left_thigh * z5281;
    const Scalar z5233 = v_front_right_knee + z5230;
    const Scalar z5224 = v_front_left_knee + z5221;
    const Scalar z5284 = c_rear_left_thigh * z5273 + s_rear_left_thigh * z5281;
    const Scalar z5294 = k0 * s_front_right_knee;
    const Scalar z5297 = s_front_right_knee * z5294;
    const Scalar z5295 = k0 * c_front_right_knee;
    const Scalar z5314 = k0 * s_front_left_knee;
    const Scalar z5317 = s_front_left_knee * z5314;
    const Scalar z5292 = n0_032 * c_front_right_knee;
    const Scalar z5315 = k0 * c_front_left_knee;
    const Scalar z5299 = n0_4 * z5292 - z5297;
    const Scalar z5301 = n0_124 + z5292;
    const Scalar z5296 = c_front_right_knee * z5295;
    const Scalar z5298 = s_front_right_knee * z5295;
    const Scalar z5302 = k7 + z5296;
    const Scalar z5312 = n0_032 * c_front_left_knee;
    const Scalar z5319 = n0_4 * z5312 - z5317;
    const Scalar z5321 = n0_124 + z5312;
    const Scalar z5285 = z5279 + z5282;
    const Scalar z5293 = n0_032 * s_front_right_knee;
    const Scalar z5300 = n0_2 * z5293 + z5298;
    const Scalar z5316 = c_front_left_knee * z5315;
    const Scalar z5318 = s_front_left_knee * z5315;
    const Scalar z5322 = k7 + z5316;
    const Scalar z5313 = n0_032 * s_front_left_knee;
    const Scalar z5320 = n0_2 * z5313 + z5318;
    const Scalar z5286 = n2 * z5280;
    const Scalar z5287 = s_rear_left_thigh * z5285 + c_rear_left_thigh * z5286;
    const Scalar z5305 = z5299 + z5302;
    const Scalar z5325 = z5319 + z5322;
    const Scalar z5306 = n2 * z5300;
    const Scalar z5307 = s_front_right_thigh * z5305 + c_front_right_thigh * z5306;
    const Scalar z5291 = c_rear_left_thigh * z5287 - z5280;
    const Scalar z5288 = s_rear_left_thigh * z5287;
    const Scalar z5326 = n2 * z5320;
    const Scalar z5327 = s_front_left_thigh * z5325 + c_front_left_thigh * z5326;
    const Scalar z5290 = z5279 - z5288;
    const Scalar z5289 = z5282 - z5288;
    const Scalar z5311 = c_front_right_thigh * z5307 - z5300;
    const Scalar z5308 = s_front_right_thigh * z5307;
    const Scalar z5331 = c_front_left_thigh * z5327 - z5320;
    const Scalar z5328 = s_front_left_thigh * z5327;
    const Scalar z5310 = z5299 - z5308;
    const Scalar z5309 = z5302 - z5308;
    const Scalar z5303 = s_front_right_thigh * z5293 - c_front_right_thigh * z5301;
    const Scalar z5304 = c_front_right_thigh * z5293 + s_front_right_thigh * z5301;
    const Scalar z5330 = z5319 - z5328;
    const Scalar z5329 = z5322 - z5328;
    const Scalar z5323 = s_front_left_thigh * z5313 - c_front_left_thigh * z5321;
    const Scalar z5324 = c_front_left_thigh * z5313 + s_front_left_thigh * z5321;
    const Scalar z5345 = n9_81 * z5210;
    const Scalar z5350 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z5347 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z5348 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z5349 = z5347 + z5348;
    const Scalar z5351 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z5352 = z5348 + z5351;
    const Scalar z5346 = n9_81 * z5213;
    const Scalar z5353 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z5344 = n9_81 * z5214;
    const Scalar z5354 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z5391 = z5346 + n0_2 * z5353 - n0_05 * z5354;
    const Scalar z5390 = z5345 + n0_2 * z5350 + n0_05 * z5352;
    const Scalar z5356 = z5345 + n0_2 * z5350 - n0_05 * z5352;
    const Scalar z5361 = v_front_left_hip * z5216;  // angular acceleration of front_left_hip_link, z
    const Scalar z5362 = z5216 * z5218;
    const Scalar z5363 = z5361 + z5362;
    const Scalar z5367 = z5216 * z5217;
    const Scalar z5389 = z5344 - n0_2 * z5349 - n0_05 * z5350;
    const Scalar z5357 = z5346 + n0_2 * z5353 + n0_05 * z5354;
    const Scalar z5355 = z5344 - n0_2 * z5349 + n0_05 * z5350;
    const Scalar z5359 = s_front_left_hip * z5356 - c_front_left_hip * z5357;
    const Scalar z5358 = s_front_left_hip * z5357 + c_front_left_hip * z5356;
    const Scalar z5370 = z5355 + n0_08 * z5363;
    const Scalar z5372 = z5359 + n0_08 * z5367;
    const Scalar z5368 = s_front_left_thigh * z5361;
    const Scalar z5369 = c_front_left_thigh * z5361;
    const Scalar z5375 = v_front_left_thigh * z5220 - z5368;  // angular acceleration of front_left_thigh_link, x
    const Scalar z5376 = v_front_left_thigh * z5219 - z5369;  // angular acceleration of front_left_thigh_link, z
    const Scalar z5380 = z5219 * z5219;
    const Scalar z5381 = z5221 * z5221;
    const Scalar z5382 = z5380 + z5381;
    const Scalar z5374 = s_front_left_thigh * z5370 - c_front_left_thigh * z5372;
    const Scalar z5373 = s_front_left_thigh * z5372 + c_front_left_thigh * z5370;
    const Scalar z5386 = z5374 + n0_2 * z5382;
    const Scalar z5343 = n0_05 * v_rear_right_knee;
    const Scalar z5364 = z5217 * z5217;
    const Scalar z5365 = z5218 * z5218;
    const Scalar z5366 = z5364 + z5365;
    const Scalar z5377 = z5219 * z5220;
    const Scalar z5378 = z5220 * z5221;
    const Scalar z5379 = z5375 + z5378;
    const Scalar z5340 = n0_05 * v_rear_left_knee;
    const Scalar z5384 = s_front_left_knee * z5375 - c_front_left_knee * z5376;
    const Scalar z5371 = z5358 - n0_08 * z5366;
    const Scalar z5383 = s_front_left_knee * z5376 + c_front_left_knee * z5375;
    const Scalar z5388 = v_front_left_knee * z5222 + z5384;  // angular acceleration of front_left_shank_link, z
    const Scalar z5387 = v_front_left_knee * z5223 + z5383;  // angular acceleration of front_left_shank_link, x
    const Scalar z5337 = n0_05 * v_front_right_knee;
    const Scalar z5334 = n0_05 * v_front_left_knee;
    const Scalar z5385 = z5371 - n0_2 * z5379;
    const Scalar z5342 = n0_05 * v_rear_right_thigh;
    const Scalar z5339 = n0_05 * v_rear_left_thigh;
    const Scalar z5336 = n0_05 * v_front_right_thigh;
    const Scalar z5333 = n0_05 * v_front_left_thigh;
    const Scalar z5341 = n0_05 * v_rear_right_hip;
    const Scalar z5338 = n0_05 * v_rear_left_hip;
    const Scalar z5335 = n0_05 * v_front_right_hip;
    const Scalar z5332 = n0_05 * v_front_left_hip;
    const Scalar z5395 = v_front_right_hip * z5225;  // angular acceleration of front_right_hip_link, z
    const Scalar z5396 = z5225 * z5227;
    const Scalar z5397 = z5395 + z5396;
    const Scalar z5401 = z5225 * z5226;
    const Scalar z5393 = s_front_right_hip * z5390 - c_front_right_hip * z5391;
    const Scalar z5392 = s_front_right_hip * z5391 + c_front_right_hip * z5390;
    const Scalar z5404 = z5389 - n0_08 * z5397;
    const Scalar z5406 = z5393 - n0_08 * z5401;
    const Scalar z5402 = s_front_right_thigh * z5395;
    const Scalar z5403 = c_front_right_thigh * z5395;
    const Scalar z5409 = v_front_right_thigh * z5229 - z5402;  // angular acceleration of front_right_thigh_link, x
    const Scalar z5410 = v_front_right_thigh * z5228 - z5403;  // angular acceleration of front_right_thigh_link, z
    const Scalar z5414 = z5228 * z5228;
    const Scalar z5415 = z5230 * z5230;
    const Scalar z5416 = z5414 + z5415;
    const Scalar z5408 = s_front_right_thigh * z5404 - c_front_right_thigh * z5406;
    const Scalar z5407 = s_front_right_thigh * z5406 + c_front_right_thigh * z5404;
    const Scalar z5398 = z5226 * z5226;
    const Scalar z5399 = z5227 * z5227;
    const Scalar z5400 = z5398 + z5399;
    const Scalar z5411 = z5228 * z5229;
    const Scalar z5412 = z5229 * z5230;
    const Scalar z5413 = z5409 + z5412;
    const Scalar z5418 = s_front_right_knee * z5409 - c_front_right_knee * z5410;
    const Scalar z5405 = z5392 + n0_08 * z5400;
    const Scalar z5417 = s_front_right_knee * z5410 + c_front_right_knee * z5409;
    const Scalar z5394 = v_front_right_hip * z5226;  // angular acceleration of front_right_hip_link, y
    const Scalar z5360 = v_front_left_hip * z5217;  // angular acceleration of front_left_hip_link, y
    const Scalar z5420 = z5408 + n0_2 * z5416;
    const Scalar z5422 = v_front_right_knee * z5231 + z5418;  // angular acceleration of front_right_shank_link, z
    const Scalar z5421 = v_front_right_knee * z5232 + z5417;  // angular acceleration of front_right_shank_link, x
    const Scalar z5458 = z5345 - n0_2 * z5350 + n0_05 * z5352;
    const Scalar z5424 = z5345 - n0_2 * z5350 - n0_05 * z5352;
    const Scalar z5463 = v_rear_right_hip * z5243;  // angular acceleration of rear_right_hip_link, z
    const Scalar z5464 = z5243 * z5245;
    const Scalar z5465 = z5463 + z5464;
    const Scalar z5469 = z5243 * z5244;
    const Scalar z5459 = z5346 - n0_2 * z5353 - n0_05 * z5354;
    const Scalar z5457 = z5344 + n0_2 * z5349 - n0_05 * z5350;
    const Scalar z5423 = z5344 + n0_2 * z5349 + n0_05 * z5350;
    const Scalar z5429 = v_rear_left_hip * z5234;  // angular acceleration of rear_left_hip_link, z
    const Scalar z5430 = z5234 * z5236;
    const Scalar z5431 = z5429 + z5430;
    const Scalar z5435 = z5234 * z5235;
    const Scalar z5425 = z5346 - n0_2 * z5353 + n0_05 * z5354;
    const Scalar z5461 = s_rear_right_hip * z5458 - c_rear_right_hip * z5459;
    const Scalar z5460 = s_rear_right_hip * z5459 + c_rear_right_hip * z5458;
    const Scalar z5472 = z5457 - n0_08 * z5465;
    const Scalar z5427 = s_rear_left_hip * z5424 - c_rear_left_hip * z5425;
    const Scalar z5426 = s_rear_left_hip * z5425 + c_rear_left_hip * z5424;
    const Scalar z5474 = z5461 - n0_08 * z5469;
    const Scalar z5438 = z5423 + n0_08 * z5431;
    const Scalar z5470 = s_rear_right_thigh * z5463;
    const Scalar z5471 = c_rear_right_thigh * z5463;
    const Scalar z5477 = v_rear_right_thigh * z5247 - z5470;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z5478 = v_rear_right_thigh * z5246 - z5471;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z5440 = z5427 + n0_08 * z5435;
    const Scalar z5476 = s_rear_right_thigh * z5472 - c_rear_right_thigh * z5474;
    const Scalar z5475 = s_rear_right_thigh * z5474 + c_rear_right_thigh * z5472;
    const Scalar z5436 = s_rear_left_thigh * z5429;
    const Scalar z5437 = c_rear_left_thigh * z5429;
    const Scalar z5443 = v_rear_left_thigh * z5238 - z5436;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z5444 = v_rear_left_thigh * z5237 - z5437;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z5448 = z5237 * z5237;
    const Scalar z5449 = z5239 * z5239;
    const Scalar z5450 = z5448 + z5449;
    const Scalar z5466 = z5244 * z5244;
    const Scalar z5467 = z5245 * z5245;
    const Scalar z5468 = z5466 + z5467;
    const Scalar z5442 = s_rear_left_thigh * z5438 - c_rear_left_thigh * z5440;
    const Scalar z5441 = s_rear_left_thigh * z5440 + c_rear_left_thigh * z5438;
    const Scalar z5454 = z5442 + n0_2 * z5450;
    const Scalar z5473 = z5460 + n0_08 * z5468;
    const Scalar z5432 = z5235 * z5235;
    const Scalar z5433 = z5236 * z5236;
    const Scalar z5434 = z5432 + z5433;
    const Scalar z5445 = z5237 * z5238;
    const Scalar z5446 = z5238 * z5239;
    const Scalar z5447 = z5443 + z5446;
    const Scalar z5452 = s_rear_left_knee * z5443 - c_rear_left_knee * z5444;
    const Scalar z5439 = z5426 - n0_08 * z5434;
    const Scalar z5451 = s_rear_left_knee * z5444 + c_rear_left_knee * z5443;
    const Scalar z5456 = v_rear_left_knee * z5240 + z5452;  // angular acceleration of rear_left_shank_link, z
    const Scalar z5455 = v_rear_left_knee * z5241 + z5451;  // angular acceleration of rear_left_shank_link, x
    const Scalar z5453 = z5439 - n0_2 * z5447;
    const Scalar z5419 = z5405 - n0_2 * z5413;
    const Scalar z5482 = z5246 * z5246;
    const Scalar z5483 = z5248 * z5248;
    const Scalar z5484 = z5482 + z5483;
    const Scalar z5479 = z5246 * z5247;
    const Scalar z5480 = z5247 * z5248;
    const Scalar z5481 = z5477 + z5480;
    const Scalar z5486 = s_rear_right_knee * z5477 - c_rear_right_knee * z5478;
    const Scalar z5485 = s_rear_right_knee * z5478 + c_rear_right_knee * z5477;
    const Scalar z5487 = z5473 - n0_2 * z5481;
    const Scalar z5462 = v_rear_right_hip * z5244;  // angular acceleration of rear_right_hip_link, y
    const Scalar z5428 = v_rear_left_hip * z5235;  // angular acceleration of rear_left_hip_link, y
    const Scalar z5505 = z5246 * z5248;
    const Scalar z5506 = z5478 + z5505;
    const Scalar z5529 = z5237 * z5239;
    const Scalar z5530 = z5444 + z5529;
    const Scalar z5512 = z5244 * z5245;
    const Scalar z5536 = z5235 * z5236;
    const Scalar z5488 = z5476 + n0_2 * z5484;
    const Scalar z5490 = v_rear_right_knee * z5249 + z5486;  // angular acceleration of rear_right_shank_link, z
    const Scalar z5489 = v_rear_right_knee * z5250 + z5485;  // angular acceleration of rear_right_shank_link, x
    const Scalar z5513 = z5462 + z5512;
    const Scalar z5537 = z5428 + z5536;
    const Scalar z5491 = z5249 * z5250;
    const Scalar z5492 = z5250 * z5251;
    const Scalar z5493 = z5489 + z5492;
    const Scalar z5553 = z5228 * z5230;
    const Scalar z5497 = z5249 * z5251;
    const Scalar z5498 = z5490 + z5497;
    const Scalar z5494 = z5249 * z5249;
    const Scalar z5554 = z5410 + z5553;
    const Scalar z5495 = z5251 * z5251;
    const Scalar z5496 = z5494 + z5495;
    const Scalar z5501 = n0_032 * z5487 - k11 * z5493;  // moment on rear_right_shank_link, x
    const Scalar z5502 = k12 * z5498;  // moment on rear_right_shank_link, z
    const Scalar z5499 = n0_032 * z5493;  // force on rear_right_shank_link, y
    const Scalar z5500 = n0_032 * z5496;  // force on rear_right_shank_link, z
    const Scalar z5560 = z5226 * z5227;
    const Scalar z5561 = z5394 + z5560;
    const Scalar z5515 = z5240 * z5241;
    const Scalar z5516 = z5241 * z5242;
    const Scalar z5517 = z5455 + z5516;
    const Scalar z5539 = z5231 * z5232;
    const Scalar z5540 = z5232 * z5233;
    const Scalar z5541 = z5421 + z5540;
    const Scalar z5521 = z5240 * z5242;
    const Scalar z5522 = z5456 + z5521;
    const Scalar z5518 = z5240 * z5240;
    const Scalar z5519 = z5242 * z5242;
    const Scalar z5520 = z5518 + z5519;
    const Scalar z5525 = n0_032 * z5453 - k11 * z5517;  // moment on rear_left_shank_link, x
    const Scalar z5526 = k12 * z5522;  // moment on rear_left_shank_link, z
    const Scalar z5549 = n0_032 * z5419 - k11 * z5541;  // moment on front_right_shank_link, x
    const Scalar z5524 = n0_032 * z5520;  // force on rear_left_shank_link, z
    const Scalar z5523 = n0_032 * z5517;  // force on rear_left_shank_link, y
    const Scalar z5547 = n0_032 * z5541;  // force on front_right_shank_link, y
    const Scalar z5545 = z5231 * z5233;
    const Scalar z5546 = z5422 + z5545;
    const Scalar z5542 = z5231 * z5231;
    const Scalar z5543 = z5233 * z5233;
    const Scalar z5544 = z5542 + z5543;
    const Scalar z5504 = c_rear_right_knee * z5502 + s_rear_right_knee * z5501;
    const Scalar z5503 = s_rear_right_knee * z5502 - c_rear_right_knee * z5501;
    const Scalar z5509 = z5504 - n0_0002 * z5506;  // moment on rear_right_thigh_link, z
    const Scalar z5508 = n0_124 * z5473 - k14 * z5481 - n0_2 * z5499 - z5503;  // moment on rear_right_thigh_link, x
    const Scalar z5507 = n0_124 * z5481 + z5499;  // force on rear_right_thigh_link, y
    const Scalar z5514 = n0_1048 * z5468 - z5507;  // force on rear_right_hip_link, y
    const Scalar z5550 = k12 * z5546;  // moment on front_right_shank_link, z
    const Scalar z5548 = n0_032 * z5544;  // force on front_right_shank_link, z
    const Scalar z5563 = z5222 * z5223;
    const Scalar z5564 = z5223 * z5224;
    const Scalar z5565 = z5387 + z5564;
    const Scalar z5569 = z5222 * z5224;
    const Scalar z5566 = z5222 * z5222;
    const Scalar z5567 = z5224 * z5224;
    const Scalar z5568 = z5566 + z5567;
    const Scalar z5528 = c_rear_left_knee * z5526 + s_rear_left_knee * z5525;
    const Scalar z5527 = s_rear_left_knee * z5526 - c_rear_left_knee * z5525;
    const Scalar z5533 = z5528 - n0_0002 * z5530;  // moment on rear_left_thigh_link, z
    const Scalar z5532 = n0_124 * z5439 - k14 * z5447 - n0_2 * z5523 - z5527;  // moment on rear_left_thigh_link, x
    const Scalar z5531 = n0_124 * z5447 + z5523;  // force on rear_left_thigh_link, y
    const Scalar z5538 = n0_1048 * z5434 + z5531;  // force on rear_left_hip_link, y
    const Scalar z5552 = c_front_right_knee * z5550 + s_front_right_knee * z5549;
    const Scalar z5551 = s_front_right_knee * z5550 - c_front_right_knee * z5549;
    const Scalar z5557 = z5552 - n0_0002 * z5554;  // moment on front_right_thigh_link, z
    const Scalar z5556 = n0_124 * z5405 - k14 * z5413 - n0_2 * z5547 - z5551;  // moment on front_right_thigh_link, x
    const Scalar z5555 = n0_124 * z5413 + z5547;  // force on front_right_thigh_link, y
    const Scalar z5562 = n0_1048 * z5400 - z5555;  // force on front_right_hip_link, y
    const Scalar z5510 = s_rear_right_thigh * z5509 - c_rear_right_thigh * z5508;
    const Scalar z5570 = z5388 + z5569;
    const Scalar z5511 = s_rear_right_thigh * z5508 + c_rear_right_thigh * z5509;
    const Scalar z5577 = z5219 * z5221;
    const Scalar z5578 = z5376 + z5577;
    const Scalar z5584 = z5217 * z5218;
    const Scalar z5592 = u_front_right_knee_torque - z5337;
    const Scalar z5589 = u_front_left_knee_torque - z5334;
    const Scalar z5574 = k12 * z5570;  // moment on front_left_shank_link, z
    const Scalar z5572 = n0_032 * z5568;  // force on front_left_shank_link, z
    const Scalar z5573 = n0_032 * z5385 - k11 * z5565;  // moment on front_left_shank_link, x
    const Scalar z5571 = n0_032 * z5565;  // force on front_left_shank_link, y
    const Scalar z5591 = u_front_right_thigh_torque - z5336;
    const Scalar z5588 = u_front_left_thigh_torque - z5333;
    const Scalar z5593 = u_rear_left_hip_torque - z5338;
    const Scalar z5590 = u_front_right_hip_torque - z5335;
    const Scalar z5585 = z5360 + z5584;
    const Scalar z5587 = u_front_left_hip_torque - z5332;
    const Scalar z5576 = c_front_left_knee * z5574 + s_front_left_knee * z5573;
    const Scalar z5575 = s_front_left_knee * z5574 - c_front_left_knee * z5573;
    const Scalar z5581 = z5576 - n0_0002 * z5578;  // moment on front_left_thigh_link, z
    const Scalar z5580 = n0_124 * z5371 - k14 * z5379 - n0_2 * z5571 - z5575;  // moment on front_left_thigh_link, x
    const Scalar z5579 = n0_124 * z5379 + z5571;  // force on front_left_thigh_link, y
    const Scalar z5586 = n0_1048 * z5366 + z5579;  // force on front_left_hip_link, y
    const Scalar z5534 = s_rear_left_thigh * z5533 - c_rear_left_thigh * z5532;
    const Scalar z5535 = s_rear_left_thigh * z5532 + c_rear_left_thigh * z5533;
    const Scalar z5598 = u_rear_right_knee_torque - z5343;
    const Scalar z5595 = u_rear_left_knee_torque - z5340;
    const Scalar z5597 = u_rear_right_thigh_torque - z5342;
    const Scalar z5594 = u_rear_left_thigh_torque - z5339;
    const Scalar z5596 = u_rear_right_hip_torque - z5341;
    const Scalar z5600 = k16 * c_rear_right_knee;
    const Scalar z5601 = c_rear_right_knee * z5600;
    const Scalar z5603 = s_rear_right_knee * z5600;
    const Scalar z5599 = k16 * s_rear_right_knee;
    const Scalar z5602 = s_rear_right_knee * z5599;
    const Scalar z5558 = s_front_right_thigh * z5557 - c_front_right_thigh * z5556;
    const Scalar z5559 = s_front_right_thigh * z5556 + c_front_right_thigh * z5557;
    const Scalar z5604 = n0_2 * z5601;
    const Scalar z5605 = n0_2 * z5603;
    const Scalar z5606 = n0_2 * z5604;
    const Scalar z5608 = n0_124 - z5604;
    const Scalar z5582 = s_front_left_thigh * z5581 - c_front_left_thigh * z5580;
    const Scalar z5583 = s_front_left_thigh * z5580 + c_front_left_thigh * z5581;
    const Scalar z5607 = k17 - z5606;
    const Scalar z5609 = n1 / z5607;
    const Scalar z5610 = z5608 * z5609;
    const Scalar z5611 = z5605 * z5609;
    const Scalar z5612 = z5601 + z5608 * z5610;
    const Scalar z5613 = z5603 - z5608 * z5611;
    const Scalar z5614 = z5602 + z5605 * z5611;
    const Scalar z5615 = z5612 - z5614;
    const Scalar z5616 = n2 * z5613;
    const Scalar z5617 = s_rear_right_thigh * z5615 + c_rear_right_thigh * z5616;
    const Scalar z5618 = s_rear_right_thigh * z5617;
    const Scalar z5621 = c_rear_right_thigh * z5617 - z5613;
    const Scalar z5619 = z5614 + z5618;
    const Scalar z5620 = z5612 - z5618;
    const Scalar z5622 = n0_08 * z5621;
    const Scalar z5623 = n0_08 * z5619;
    const Scalar z5624 = n0_08 * z5620;
    const Scalar z5627 = z5271 + n0_08 * z5622;
    const Scalar z5625 = z5270 - n0_08 * z5623;
    const Scalar z5628 = z5269 + n0_08 * z5624;
    const Scalar z5629 = n0_1048 - z5623;
    const Scalar z5630 = n0_1048 - z5624;
    const Scalar z5626 = k18 + z5625;
    const Scalar z5690 = k16 * c_rear_left_knee;
    const Scalar z5689 = k16 * s_rear_left_knee;
    const Scalar z5631 = n1 / z5626;
    const Scalar z5691 = c_rear_left_knee * z5690;
    const Scalar z5632 = z5627 * z5631;
    const Scalar z5692 = s_rear_left_knee * z5689;
    const Scalar z5633 = z5622 * z5631;
    const Scalar z5693 = s_rear_left_knee * z5690;
    const Scalar z5634 = z5263 * z5631;
    const Scalar z5694 = n0_2 * z5691;
    const Scalar z5635 = z5629 * z5631;
    const Scalar z5695 = n0_2 * z5693;
    const Scalar z5636 = z5620 + z5622 * z5633;
    const Scalar z5696 = n0_2 * z5694;
    const Scalar z5637 = z5622 * z5634;
    const Scalar z5697 = k17 - z5696;
    const Scalar z5638 = z5263 * z5634;
    const Scalar z5698 = n0_124 - z5694;
    const Scalar z5639 = z5622 * z5632 - z5630;
    const Scalar z5699 = n1 / z5697;
    const Scalar z5640 = z5621 - z5622 * z5635;
    const Scalar z5700 = z5698 * z5699;
    const Scalar z5641 = z5263 * z5632 + z5264;
    const Scalar z5701 = z5695 * z5699;
    const Scalar z5642 = z5263 * z5635;
    const Scalar z5702 = z5691 + z5698 * z5700;
    const Scalar z5643 = z5622 - z5629 * z5632;
    const Scalar z5703 = z5693 - z5698 * z5701;
    const Scalar z5644 = z5627 * z5632 + z5628;
    const Scalar z5704 = z5692 + z5695 * z5701;
    const Scalar z5645 = z5619 + z5629 * z5635;
    const Scalar z5705 = z5702 - z5704;
    const Scalar z5660 = n2 * z5642;
    const Scalar z5646 = k19 - z5644;
    const Scalar z5706 = n2 * z5703;
    const Scalar z5652 = s_rear_right_hip * z5639;
    const Scalar z5653 = c_rear_right_hip * z5639;
    const Scalar z5654 = s_rear_right_hip * z5643 + c_rear_right_hip * z5641;
    const Scalar z5659 = z5638 - z5645;
    const Scalar z5661 = c_rear_right_hip * z5637 + s_rear_right_hip * z5640;
    const Scalar z5662 = s_rear_right_hip * z5637 - c_rear_right_hip * z5640;
    const Scalar z5686 = n12_24 - z5636;
    const Scalar z5647 = s_rear_right_hip * z5646;
    const Scalar z5707 = s_rear_left_thigh * z5705 + c_rear_left_thigh * z5706;
    const Scalar z5663 = c_rear_right_hip * z5660 + s_rear_right_hip * z5659;
    const Scalar z5648 = s_rear_right_hip * z5647;
    const Scalar z5708 = s_rear_left_thigh * z5707;
    const Scalar z5651 = c_rear_right_hip * z5647;
    const Scalar z5668 = n0_05 * z5662;
    const Scalar z5671 = z5652 - n0_2 * z5662;
    const Scalar z5674 = n0_05 * z5636 + z5653 - n0_2 * z5661;
    const Scalar z5655 = s_rear_right_hip * z5654;
    const Scalar z5657 = c_rear_right_hip * z5654 - z5641;
    const Scalar z5658 = c_rear_right_hip * z5654;
    const Scalar z5649 = k19 - z5648;
    const Scalar z5709 = z5704 + z5708;
    const Scalar z5650 = z5644 + z5648;
    const Scalar z5711 = c_rear_left_thigh * z5707 - z5703;
    const Scalar z5710 = z5702 - z5708;
    const Scalar z5713 = n0_08 * z5709;
    const Scalar z5712 = n0_08 * z5711;
    const Scalar z5714 = n0_08 * z5710;
    const Scalar z5664 = s_rear_right_hip * z5663;
    const Scalar z5667 = c_rear_right_hip * z5663 - z5642;
    const Scalar z5656 = z5643 - z5655;
    const Scalar z5717 = z5291 + n0_08 * z5712;
    const Scalar z5715 = z5290 - n0_08 * z5713;
    const Scalar z5718 = z5289 + n0_08 * z5714;
    const Scalar z5719 = n0_1048 - z5713;
    const Scalar z5720 = n0_1048 - z5714;
    const Scalar z5665 = z5638 - z5664;
    const Scalar z5666 = z5645 + z5664;
    const Scalar z5669 = n0_05 * z5667;
    const Scalar z5672 = z5655 - n0_2 * z5667;
    const Scalar z5676 = z5656 + n0_2 * z5667 - z5668;
    const Scalar z5716 = k18 + z5715;
    const Scalar z5675 = z5658 + n0_05 * z5661 - n0_2 * z5665;
    const Scalar z5683 = z5651 - n0_05 * z5671 - n0_2 * (z5656 - z5672);
    const Scalar z5684 = z5650 + n0_05 * (z5653 + z5674) - n0_2 * (z5658 + z5675);
    const Scalar z5721 = n1 / z5716;
    const Scalar z5682 = n0_05 * (z5656 - z5668) + n0_2 * z5669;
    const Scalar z5687 = n12_24 - z5665;
    const Scalar z5685 = k21 - z5684;
    const Scalar z5673 = z5657 + n0_2 * z5666;
    const Scalar z5680 = n0_2 * (z5657 + z5673) + z5649;
    const Scalar z5670 = n0_05 * z5666;
    const Scalar z5679 = n0_05 * z5657 + n0_2 * z5670;
    const Scalar z5688 = n12_24 - z5666;
    const Scalar z5725 = z5719 * z5721;
    const Scalar z5724 = z5283 * z5721;
    const Scalar z5722 = z5717 * z5721;
    const Scalar z5723 = z5712 * z5721;
    const Scalar z5677 = n0_05 * z5670;
    const Scalar z5734 = z5717 * z5722 + z5718;
    const Scalar z5735 = z5709 + z5719 * z5725;
    const Scalar z5733 = z5712 - z5719 * z5722;
    const Scalar z5729 = z5712 * z5722 - z5720;
    const Scalar z5730 = z5711 - z5712 * z5725;
    const Scalar z5731 = z5283 * z5722 + z5284;
    const Scalar z5726 = z5710 + z5712 * z5723;
    const Scalar z5727 = z5712 * z5724;
    const Scalar z5681 = k22 - z5680;
    const Scalar z5678 = n0_0406 - z5677;
    const Scalar z5728 = z5283 * z5724;
    const Scalar z5732 = z5283 * z5725;
    const Scalar z5788 = z5686 - z5726;
    const Scalar z5795 = k16 * c_front_right_knee;
    const Scalar z5794 = k16 * s_front_right_knee;
    const Scalar z5749 = z5728 - z5735;
    const Scalar z5750 = n2 * z5732;
    const Scalar z5743 = c_rear_left_hip * z5729;
    const Scalar z5753 = s_rear_left_hip * z5749 - c_rear_left_hip * z5750;
    const Scalar z5742 = s_rear_left_hip * z5729;
    const Scalar z5744 = s_rear_left_hip * z5733 - c_rear_left_hip * z5731;
    const Scalar z5747 = c_rear_left_hip * z5744 + z5731;
    const Scalar z5736 = k19 - z5734;
    const Scalar z5737 = s_rear_left_hip * z5736;
    const Scalar z5797 = s_front_right_knee * z5794;
    const Scalar z5796 = c_front_right_knee * z5795;
    const Scalar z5757 = c_rear_left_hip * z5753 + z5732;
    const Scalar z5754 = s_rear_left_hip * z5753;
    const Scalar z5748 = c_rear_left_hip * z5744;
    const Scalar z5745 = s_rear_left_hip * z5744;
    const Scalar z5746 = z5733 - z5745;
    const Scalar z5755 = z5728 - z5754;
    const Scalar z5756 = z5735 + z5754;
    const Scalar z5762 = z5745 + n0_2 * z5757;
    const Scalar z5792 = z5667 + z5757;
    const Scalar z5751 = s_rear_left_hip * z5730 - c_rear_left_hip * z5727;
    const Scalar z5752 = s_rear_left_hip * z5727 + c_rear_left_hip * z5730;
    const Scalar z5764 = n0_05 * z5726 + z5743 + n0_2 * z5751;
    const Scalar z5761 = z5742 - n0_2 * z5752;
    const Scalar z5783 = z5672 - z5762;
    const Scalar z5791 = z5687 - z5755;
    const Scalar z5765 = z5748 + n0_05 * z5751 + n0_2 * z5755;
    const Scalar z5789 = z5661 + z5751;
    const Scalar z5786 = z5675 - z5765;
    const Scalar z5793 = z5688 - z5756;
    const Scalar z5782 = z5671 - z5761;
    const Scalar z5785 = z5674 - z5764;
    const Scalar z5790 = z5662 - z5752;
    const Scalar z5758 = n0_05 * z5752;
    const Scalar z5779 = z5668 + z5758;
    const Scalar z5738 = s_rear_left_hip * z5737;
    const Scalar z5798 = s_front_right_knee * z5795;
    const Scalar z5740 = z5734 + z5738;
    const Scalar z5741 = c_rear_left_hip * z5737;
    const Scalar z5775 = z5741 - n0_05 * z5761 + n0_2 * (z5746 - z5762);
    const Scalar z5777 = z5740 + n0_05 * (z5743 + z5764) + n0_2 * (z5748 + z5765);
    const Scalar z5739 = k19 - z5738;
    const Scalar z5799 = n0_2 * z5796;
    const Scalar z5801 = n0_2 * z5799;
    const Scalar z5803 = n0_124 - z5799;
    const Scalar z5800 = n0_2 * z5798;
    const Scalar z5776 = z5683 + z5775;
    const Scalar z5763 = z5747 - n0_2 * z5756;
    const Scalar z5778 = z5685 - z5777;
    const Scalar z5802 = k17 - z5801;
    const Scalar z5771 = z5739 - n0_2 * (z5747 + z5763);
    const Scalar z5784 = z5673 - z5763;
    const Scalar z5804 = n1 / z5802;
    const Scalar z5760 = n0_05 * z5756;
    const Scalar z5769 = n0_05 * z5747 - n0_2 * z5760;
    const Scalar z5781 = z5670 - z5760;
    const Scalar z5767 = n0_05 * z5760;
    const Scalar z5759 = n0_05 * z5757;
    const Scalar z5772 = z5681 - z5771;
    const Scalar z5768 = z5678 - z5767;
    const Scalar z5770 = z5679 + z5769;
    const Scalar z5766 = z5758 + z5746 - n0_2 * z5757;
    const Scalar z5773 = n0_05 * (z5746 + z5758) - n0_2 * z5759;
    const Scalar z5774 = z5682 + z5773;
    const Scalar z5780 = z5669 - z5759;
    const Scalar z5787 = z5676 - z5766;
    const Scalar z5805 = z5803 * z5804;
    const Scalar z5806 = z5800 * z5804;
    const Scalar z5807 = z5796 + z5803 * z5805;
    const Scalar z5808 = z5798 - z5803 * z5806;
    const Scalar z5809 = z5797 + z5800 * z5806;
    const Scalar z5810 = z5807 - z5809;
    const Scalar z5811 = n2 * z5808;
    const Scalar z5812 = s_front_right_thigh * z5810 + c_front_right_thigh * z5811;
    const Scalar z5813 = s_front_right_thigh * z5812;
    const Scalar z5816 = c_front_right_thigh * z5812 - z5808;
    const Scalar z5814 = z5809 + z5813;
    const Scalar z5815 = z5807 - z5813;
    const Scalar z5817 = n0_08 * z5816;
    const Scalar z5818 = n0_08 * z5814;
    const Scalar z5819 = n0_08 * z5815;
    const Scalar z5822 = z5311 + n0_08 * z5817;
    const Scalar z5820 = z5310 - n0_08 * z5818;
    const Scalar z5823 = z5309 + n0_08 * z5819;
    const Scalar z5824 = n0_1048 - z5818;
    const Scalar z5825 = n0_1048 - z5819;
    const Scalar z5821 = k18 + z5820;
    const Scalar z5826 = n1 / z5821;
    const Scalar z5827 = z5822 * z5826;
    const Scalar z5828 = z5817 * z5826;
    const Scalar z5829 = z5303 * z5826;
    const Scalar z5830 = z5824 * z5826;
    const Scalar z5831 = z5815 + z5817 * z5828;
    const Scalar z5832 = z5817 * z5829;
    const Scalar z5833 = z5303 * z5829;
    const Scalar z5834 = z5817 * z5827 - z5825;
    const Scalar z5835 = z5816 - z5817 * z5830;
    const Scalar z5836 = z5303 * z5827 + z5304;
    const Scalar z5837 = z5303 * z5830;
    const Scalar z5838 = z5817 - z5824 * z5827;
    const Scalar z5839 = z5822 * z5827 + z5823;
    const Scalar z5899 = k16 * s_front_left_knee;
    const Scalar z5840 = z5814 + z5824 * z5830;
    const Scalar z5900 = k16 * c_front_left_knee;
    const Scalar z5855 = n2 * z5837;
    const Scalar z5841 = k19 - z5839;
    const Scalar z5901 = c_front_left_knee * z5900;
    const Scalar z5847 = s_front_right_hip * z5834;
    const Scalar z5848 = c_front_right_hip * z5834;
    const Scalar z5849 = s_front_right_hip * z5838 + c_front_right_hip * z5836;
    const Scalar z5854 = z5833 - z5840;
    const Scalar z5856 = c_front_right_hip * z5832 + s_front_right_hip * z5835;
    const Scalar z5857 = s_front_right_hip * z5832 - c_front_right_hip * z5835;
    const Scalar z5893 = z5788 - z5831;
    const Scalar z5842 = s_front_right_hip * z5841;
    const Scalar z5902 = s_front_left_knee * z5899;
    const Scalar z5858 = c_front_right_hip * z5855 + s_front_right_hip * z5854;
    const Scalar z5843 = s_front_right_hip * z5842;
    const Scalar z5903 = s_front_left_knee * z5900;
    const Scalar z5846 = c_front_right_hip * z5842;
    const Scalar z5863 = n0_05 * z5857;
    const Scalar z5866 = z5847 + n0_2 * z5857;
    const Scalar z5869 = n0_05 * z5831 + z5848 + n0_2 * z5856;
    const Scalar z5894 = z5789 + z5856;
    const Scalar z5895 = z5790 + z5857;
    const Scalar z5850 = s_front_right_hip * z5849;
    const Scalar z5852 = c_front_right_hip * z5849 - z5836;
    const Scalar z5853 = c_front_right_hip * z5849;
    const Scalar z5844 = k19 - z5843;
    const Scalar z5904 = n0_2 * z5901;
    const Scalar z5845 = z5839 + z5843;
    const Scalar z5906 = n0_2 * z5904;
    const Scalar z5908 = n0_124 - z5904;
    const Scalar z5905 = n0_2 * z5903;
    const Scalar z5907 = k17 - z5906;
    const Scalar z5909 = n1 / z5907;
    const Scalar z5859 = s_front_right_hip * z5858;
    const Scalar z5862 = c_front_right_hip * z5858 - z5837;
    const Scalar z5884 = z5779 + z5863;
    const Scalar z5851 = z5838 - z5850;
    const Scalar z5887 = z5782 + z5866;
    const Scalar z5890 = z5785 + z5869;
    const Scalar z5860 = z5833 - z5859;
    const Scalar z5861 = z5840 + z5859;
    const Scalar z5864 = n0_05 * z5862;
    const Scalar z5867 = z5850 + n0_2 * z5862;
    const Scalar z5871 = z5851 - n0_2 * z5862 - z5863;
    const Scalar z5897 = z5792 + z5862;
    const Scalar z5910 = z5908 * z5909;
    const Scalar z5911 = z5905 * z5909;
    const Scalar z5865 = n0_05 * z5861;
    const Scalar z5868 = z5852 - n0_2 * z5861;
    const Scalar z5870 = z5853 + n0_05 * z5856 + n0_2 * z5860;
    const Scalar z5896 = z5791 - z5860;
    const Scalar z5898 = z5793 - z5861;
    const Scalar z5878 = n0_05 * (z5851 - z5863) - n0_2 * z5864;
    const Scalar z5885 = z5780 + z5864;
    const Scalar z5880 = z5846 - n0_05 * z5866 + n0_2 * (z5851 - z5867);
    const Scalar z5888 = z5783 + z5867;
    const Scalar z5914 = z5902 + z5905 * z5911;
    const Scalar z5912 = z5901 + z5908 * z5910;
    const Scalar z5882 = z5845 + n0_05 * (z5848 + z5869) + n0_2 * (z5853 + z5870);
    const Scalar z5913 = z5903 - z5908 * z5911;
    const Scalar z5879 = z5774 + z5878;
    const Scalar z5891 = z5786 + z5870;
    const Scalar z5881 = z5776 + z5880;
    const Scalar z5892 = z5787 + z5871;
    const Scalar z5876 = z5844 - n0_2 * (z5852 + z5868);
    const Scalar z5883 = z5778 - z5882;
    const Scalar z5877 = z5772 - z5876;
    const Scalar z5889 = z5784 + z5868;
    const Scalar z5874 = n0_05 * z5852 - n0_2 * z5865;
    const Scalar z5875 = z5770 + z5874;
    const Scalar z5886 = z5781 + z5865;
    const Scalar z5872 = n0_05 * z5865;
    const Scalar z5873 = z5768 - z5872;
    const Scalar z5915 = z5912 - z5914;
    const Scalar z5916 = n2 * z5913;
    const Scalar z5917 = s_front_left_thigh * z5915 + c_front_left_thigh * z5916;
    const Scalar z5918 = s_front_left_thigh * z5917;
    const Scalar z5921 = c_front_left_thigh * z5917 - z5913;
    const Scalar z5919 = z5914 + z5918;
    const Scalar z5920 = z5912 - z5918;
    const Scalar z5922 = n0_08 * z5921;
    const Scalar z5923 = n0_08 * z5919;
    const Scalar z5924 = n0_08 * z5920;
    const Scalar z5927 = z5331 + n0_08 * z5922;
    const Scalar z5925 = z5330 - n0_08 * z5923;
    const Scalar z5928 = z5329 + n0_08 * z5924;
    const Scalar z5929 = n0_1048 - z5923;
    const Scalar z5930 = n0_1048 - z5924;
    const Scalar z5926 = k18 + z5925;
    const Scalar z5931 = n1 / z5926;
    const Scalar z5932 = z5927 * z5931;
    const Scalar z5933 = z5922 * z5931;
    const Scalar z5934 = z5323 * z5931;
    const Scalar z5935 = z5929 * z5931;
    const Scalar z5936 = z5920 + z5922 * z5933;
    const Scalar z5937 = z5922 * z5934;
    const Scalar z5938 = z5323 * z5934;
    const Scalar z5939 = z5922 * z5932 - z5930;
    const Scalar z5940 = z5921 - z5922 * z5935;
    const Scalar z5941 = z5323 * z5932 + z5324;
    const Scalar z5942 = z5323 * z5935;
    const Scalar z5943 = z5922 - z5929 * z5932;
    const Scalar z5944 = z5927 * z5932 + z5928;
    const Scalar z5945 = z5919 + z5929 * z5935;
    const Scalar z5960 = n2 * z5942;
    const Scalar z5946 = k19 - z5944;
    const Scalar z5952 = s_front_left_hip * z5939;
    const Scalar z5953 = c_front_left_hip * z5939;
    const Scalar z5954 = s_front_left_hip * z5943 - c_front_left_hip * z5941;
    const Scalar z5959 = z5938 - z5945;
    const Scalar z5961 = s_front_left_hip * z5940 - c_front_left_hip * z5937;
    const Scalar z5962 = s_front_left_hip * z5937 + c_front_left_hip * z5940;
    const Scalar z5998 = z5893 - z5936;
    const Scalar z5947 = s_front_left_hip * z5946;
    const Scalar z5963 = s_front_left_hip * z5959 - c_front_left_hip * z5960;
    const Scalar z5948 = s_front_left_hip * z5947;
    const Scalar z5951 = c_front_left_hip * z5947;
    const Scalar z5968 = n0_05 * z5962;
    const Scalar z5971 = z5952 + n0_2 * z5962;
    const Scalar z6000 = z5895 - z5962;
    const Scalar z5955 = s_front_left_hip * z5954;
    const Scalar z5957 = c_front_left_hip * z5954 + z5941;
    const Scalar z5958 = c_front_left_hip * z5954;
    const Scalar z5974 = n0_05 * z5936 + z5953 - n0_2 * z5961;
    const Scalar z5999 = z5894 + z5961;
    const Scalar z5949 = k19 - z5948;
    const Scalar z5950 = z5944 + z5948;
    const Scalar z5989 = z5884 + z5968;
    const Scalar z5956 = z5943 - z5955;
    const Scalar z5964 = s_front_left_hip * z5963;
    const Scalar z5967 = c_front_left_hip * z5963 + z5942;
    const Scalar z5992 = z5887 - z5971;
    const Scalar z5995 = z5890 - z5974;
    const Scalar z5965 = z5938 - z5964;
    const Scalar z5966 = z5945 + z5964;
    const Scalar z5969 = n0_05 * z5967;
    const Scalar z5972 = z5955 - n0_2 * z5967;
    const Scalar z5976 = z5968 + z5956 + n0_2 * z5967;
    const Scalar z6002 = z5897 + z5967;
    const Scalar z5970 = n0_05 * z5966;
    const Scalar z5973 = z5957 + n0_2 * z5966;
    const Scalar z5975 = z5958 + n0_05 * z5961 - n0_2 * z5965;
    const Scalar z6001 = z5896 - z5965;
    const Scalar z6003 = z5898 - z5966;
    const Scalar z5983 = n0_05 * (z5956 + z5968) + n0_2 * z5969;
    const Scalar z5990 = z5885 - z5969;
    const Scalar z5985 = z5951 - n0_05 * z5971 - n0_2 * (z5956 - z5972);
    const Scalar z5993 = z5888 - z5972;
    const Scalar z5977 = n0_05 * z5970;
    const Scalar z5979 = n0_05 * z5957 + n0_2 * z5970;
    const Scalar z5991 = z5886 - z5970;
    const Scalar z5981 = n0_2 * (z5957 + z5973) + z5949;
    const Scalar z5987 = z5950 + n0_05 * (z5953 + z5974) - n0_2 * (z5958 + z5975);
    const Scalar z5996 = z5891 - z5975;
    const Scalar z5978 = z5873 - z5977;
    const Scalar z5994 = z5889 - z5973;
    const Scalar z5980 = z5875 + z5979;
    const Scalar z5984 = z5879 + z5983;
    const Scalar z5997 = z5892 - z5976;
    const Scalar z5986 = z5881 + z5985;
    const Scalar z5982 = z5877 - z5981;
    const Scalar z5988 = z5883 - z5987;
    const Scalar z6004 = n1 / z5988;
    const Scalar z6005 = z5984 * z6004;
    const Scalar z6006 = z5986 * z6004;
    const Scalar z6007 = z5995 * z6004;
    const Scalar z6008 = z5996 * z6004;
    const Scalar z6009 = z5997 * z6004;
    const Scalar z6010 = z5989 - z5995 * z6005;
    const Scalar z6011 = z5978 - z5984 * z6005;
    const Scalar z6012 = z5995 * z6007 - z5998;
    const Scalar z6013 = z5990 - z5996 * z6005;
    const Scalar z6014 = z5991 + z5997 * z6005;
    const Scalar z6015 = z5992 - z5995 * z6006;
    const Scalar z6075 = z5373 - n0_2 * z5377;
    const Scalar z6016 = z5980 - z5984 * z6006;
    const Scalar z6076 = s_front_left_knee * z5386 - c_front_left_knee * z6075;
    const Scalar z6017 = z5995 * z6008 + z5999;
    const Scalar z6077 = z5407 - n0_2 * z5411;
    const Scalar z6018 = z5993 - z5996 * z6006;
    const Scalar z6078 = s_front_right_knee * z5420 - c_front_right_knee * z6077;
    const Scalar z6019 = z5982 - z5986 * z6006;
    const Scalar z6079 = z5441 - n0_2 * z5445;
    const Scalar z6020 = z5996 * z6008 - z6001;
    const Scalar z6080 = s_rear_left_knee * z5454 - c_rear_left_knee * z6079;
    const Scalar z6023 = z5996 * z6009 - z6002;
    const Scalar z6022 = z5995 * z6009 - z6000;
    const Scalar z6021 = z5994 - z5997 * z6006;
    const Scalar z6024 = z5997 * z6009 - z6003;
    const Scalar z6025 = n1 / z6019;
    const Scalar z6081 = z5475 - n0_2 * z5479;
    const Scalar z6082 = s_rear_right_knee * z5488 - c_rear_right_knee * z6081;
    const Scalar z6083 = n0_032 * z5491;
    const Scalar z6084 = k0 * z5491 - n0_032 * z6082;
    const Scalar z6085 = z5598 + z6084;
    const Scalar z6026 = z6016 * z6025;
    const Scalar z6027 = z6015 * z6025;
    const Scalar z6028 = z6018 * z6025;
    const Scalar z6029 = z6021 * z6025;
    const Scalar z6086 = k24 * z6085;
    const Scalar z6087 = z6083 - k25 * z6085;
    const Scalar z6030 = z6010 - z6015 * z6026;
    const Scalar z6031 = z6011 - z6016 * z6026;
    const Scalar z6032 = z6012 + z6015 * z6027;
    const Scalar z6033 = z6013 - z6018 * z6026;
    const Scalar z6034 = z6014 + z6021 * z6026;
    const Scalar z6035 = z6015 * z6028 + z6017;
    const Scalar z6039 = z6021 * z6029 + z6024;
    const Scalar z6037 = z6015 * z6029 + z6022;
    const Scalar z6036 = z6018 * z6028 + z6020;
    const Scalar z6038 = z6018 * z6029 + z6023;
    const Scalar z6040 = n1 / z6031;
    const Scalar z6088 = s_rear_right_knee * z5500 + c_rear_right_knee * z6087;
    const Scalar z6092 = n0_124 * z5475 - z5598 - k7 * z5479 + n0_2 * z6088;
    const Scalar z6089 = s_rear_right_knee * z6087 - c_rear_right_knee * z5500;
    const Scalar z6090 = n0_124 * z5479 - z6088;
    const Scalar z6091 = n0_124 * z5484 - z6089;
    const Scalar z6093 = z5597 + z6092;
    const Scalar z6095 = z5610 * z6093 + z6090;
    const Scalar z6094 = z5609 * z6093;
    const Scalar z6096 = z5611 * z6093 - z6091;
    const Scalar z6041 = z6030 * z6040;
    const Scalar z6042 = z6033 * z6040;
    const Scalar z6102 = n0_0002 * z5513 - z5597;
    const Scalar z6043 = z6034 * z6040;
    const Scalar z6097 = s_rear_right_thigh * z6096 + c_rear_right_thigh * z6095;
    const Scalar z6049 = z6034 * z6043 + z6039;
    const Scalar z6098 = s_rear_right_thigh * z6095 - c_rear_right_thigh * z6096;
    const Scalar z6046 = z6033 * z6042 + z6036;
    const Scalar z6048 = z6033 * z6043 - z6038;
    const Scalar z6101 = n0_1048 * z5461 - z5510 - k26 * z5469 - n0_08 * z6098;
    const Scalar z6103 = n0_1048 * z5457 - z5511 - k27 * z5465 - n0_08 * z6097;
    const Scalar z6100 = n0_1048 * z5469 + z6098;
    const Scalar z6099 = n0_1048 * z5465 + z6097;
    const Scalar z6045 = z6030 * z6042 + z6035;
    const Scalar z6047 = z6030 * z6043 - z6037;
    const Scalar z6044 = z6030 * z6041 + z6032;
    const Scalar z6104 = z5596 - z6101;
    const Scalar z6106 = z5632 * z6104 - z6103;
    const Scalar z6108 = z5514 - z5634 * z6104;
    const Scalar z6109 = z5635 * z6104 - z6100;
    const Scalar z6107 = z5633 * z6104 + z6099;
    const Scalar z6105 = z5631 * z6104;
    const Scalar z6057 = z5210 * z6046 + z5213 * z6048 + z5214 * z6045;
    const Scalar z6058 = z5210 * z6048 + z5213 * z6049 + z5214 * z6047;
    const Scalar z6056 = z5210 * z6045 + z5213 * z6047 + z5214 * z6044;
    const Scalar z6064 = z5210 * z6057 + z5213 * z6058 + z5214 * z6056;
    const Scalar z6054 = z5203 * z6045 + z5208 * z6046 + z5209 * z6048;
    const Scalar z6051 = z5201 * z6045 + z5202 * z6046 + z5215 * z6048;
    const Scalar z6065 = n1 / z6064;
    const Scalar z6053 = z5203 * z6044 + z5208 * z6045 + z5209 * z6047;
    const Scalar z6050 = z5201 * z6044 + z5202 * z6045 + z5215 * z6047;
    const Scalar z6055 = z5203 * z6047 + z5208 * z6048 + z5209 * z6049;
    const Scalar z6052 = z5201 * z6047 + z5202 * z6048 + z5215 * z6049;
    const Scalar z6115 = k0 * z5515 - n0_032 * z6080;
    const Scalar z6114 = n0_032 * z5515;
    const Scalar z6116 = z5595 + z6115;
    const Scalar z6113 = s_rear_right_hip * z6102 + c_rear_right_hip * z6106;
    const Scalar z6112 = s_rear_right_hip * z6106 - c_rear_right_hip * z6102;
    const Scalar z6118 = z6114 - k25 * z6116;
    const Scalar z6117 = k24 * z6116;
    const Scalar z6110 = s_rear_right_hip * z6109 + c_rear_right_hip * z6108;
    const Scalar z6111 = s_rear_right_hip * z6108 - c_rear_right_hip * z6109;
    const Scalar z6063 = z5210 * z6054 + z5213 * z6055 + z5214 * z6053;
    const Scalar z6062 = z5203 * z6053 + z5208 * z6054 + z5209 * z6055;
    const Scalar z6061 = z5201 * z6053 + z5202 * z6054 + z5215 * z6055;
    const Scalar z6067 = z6063 * z6065;
    const Scalar z6070 = z6062 - z6063 * z6067;
    const Scalar z6060 = z5210 * z6051 + z5213 * z6052 + z5214 * z6050;
    const Scalar z6059 = z5201 * z6050 + z5202 * z6051 + z5215 * z6052;
    const Scalar z6069 = z6060 * z6067 - z6061;
    const Scalar z6071 = n1 / z6070;
    const Scalar z6119 = s_rear_left_knee * z5524 + c_rear_left_knee * z6118;
    const Scalar z6123 = n0_124 * z5441 - z5595 - k7 * z5445 + n0_2 * z6119;
    const Scalar z6120 = s_rear_left_knee * z6118 - c_rear_left_knee * z5524;
    const Scalar z6121 = n0_124 * z5445 - z6119;
    const Scalar z6122 = n0_124 * z5450 - z6120;
    const Scalar z6124 = z5594 + z6123;
    const Scalar z6125 = z5699 * z6124;
    const Scalar z6066 = z6060 * z6065;
    const Scalar z6068 = z6059 - z6060 * z6066;
    const Scalar z6126 = z5700 * z6124 + z6121;
    const Scalar z6127 = z5701 * z6124 - z6122;
    const Scalar z6072 = z6069 * z6071;
    const Scalar z6073 = z6068 - z6069 * z6072;
    const Scalar z6133 = n0_0002 * z5537 - z5594;
    const Scalar z6129 = s_rear_left_thigh * z6126 - c_rear_left_thigh * z6127;
    const Scalar z6128 = s_rear_left_thigh * z6127 + c_rear_left_thigh * z6126;
    const Scalar z6074 = n1 / z6073;
    const Scalar z6146 = k0 * z5539 - n0_032 * z6078;
    const Scalar z6132 = z5534 + n0_1048 * z5427 + k26 * z5435 - n0_08 * z6129;
    const Scalar z6134 = z5535 + n0_1048 * z5423 + k27 * z5431 - n0_08 * z6128;
    const Scalar z6131 = n0_1048 * z5435 - z6129;
    const Scalar z6130 = n0_1048 * z5431 - z6128;
    const Scalar z6145 = n0_032 * z5539;
    const Scalar z6147 = z5592 + z6146;
    const Scalar z6177 = k0 * z5563 - n0_032 * z6076;
    const Scalar z6176 = n0_032 * z5563;
    const Scalar z6178 = z5589 + z6177;
    const Scalar z6149 = z6145 - k25 * z6147;
    const Scalar z6135 = z5593 + z6132;
    const Scalar z6137 = z5722 * z6135 + z6134;
    const Scalar z6180 = z6176 - k25 * z6178;
    const Scalar z6164 = n0_0002 * z5561 - z5591;
    const Scalar z6139 = z5538 + z5724 * z6135;
    const Scalar z6140 = z5725 * z6135 - z6131;
    const Scalar z6195 = n0_0002 * z5585 - z5588;
    const Scalar z6138 = z5723 * z6135 + z6130;
    const Scalar z6136 = z5721 * z6135;
    const Scalar z6148 = k24 * z6147;
    const Scalar z6179 = k24 * z6178;
    const Scalar z6150 = s_front_right_knee * z5548 + c_front_right_knee * z6149;
    const Scalar z6154 = n0_124 * z5407 - z5592 - k7 * z5411 + n0_2 * z6150;
    const Scalar z6151 = s_front_right_knee * z6149 - c_front_right_knee * z5548;
    const Scalar z6152 = n0_124 * z5411 - z6150;
    const Scalar z6155 = z5591 + z6154;
    const Scalar z6153 = n0_124 * z5416 - z6151;
    const Scalar z6157 = z5805 * z6155 + z6152;
    const Scalar z6156 = z5804 * z6155;
    const Scalar z6158 = z5806 * z6155 - z6153;
    const Scalar z6181 = s_front_left_knee * z5572 + c_front_left_knee * z6180;
    const Scalar z6185 = n0_124 * z5373 - z5589 - k7 * z5377 + n0_2 * z6181;
    const Scalar z6182 = s_front_left_knee * z6180 - c_front_left_knee * z5572;
    const Scalar z6183 = n0_124 * z5377 - z6181;
    const Scalar z6186 = z5588 + z6185;
    const Scalar z6184 = n0_124 * z5382 - z6182;
    const Scalar z6188 = z5910 * z6186 + z6183;
    const Scalar z6187 = z5909 * z6186;
    const Scalar z6189 = z5911 * z6186 - z6184;
    const Scalar z6160 = s_front_right_thigh * z6157 - c_front_right_thigh * z6158;
    const Scalar z6159 = s_front_right_thigh * z6158 + c_front_right_thigh * z6157;
    const Scalar z6163 = n0_1048 * z5393 - z5558 - k26 * z5401 - n0_08 * z6160;
    const Scalar z6165 = n0_1048 * z5389 - z5559 - k27 * z5397 - n0_08 * z6159;
    const Scalar z6162 = n0_1048 * z5401 + z6160;
    const Scalar z6161 = n0_1048 * z5397 + z6159;
    const Scalar z6166 = z5590 - z6163;
    const Scalar z6168 = z5827 * z6166 - z6165;
    const Scalar z6170 = z5562 - z5829 * z6166;
    const Scalar z6171 = z5830 * z6166 - z6162;
    const Scalar z6169 = z5828 * z6166 + z6161;
    const Scalar z6167 = z5826 * z6166;
    const Scalar z6191 = s_front_left_thigh * z6188 - c_front_left_thigh * z6189;
    const Scalar z6190 = s_front_left_thigh * z6189 + c_front_left_thigh * z6188;
    const Scalar z6194 = z5582 + n0_1048 * z5359 + k26 * z5367 - n0_08 * z6191;
    const Scalar z6196 = z5583 + n0_1048 * z5355 + k27 * z5363 - n0_08 * z6190;
    const Scalar z6193 = n0_1048 * z5367 - z6191;
    const Scalar z6192 = n0_1048 * z5363 - z6190;
    const Scalar z6197 = z5587 + z6194;
    const Scalar z6199 = z5932 * z6197 + z6196;
    const Scalar z6200 = z5933 * z6197 + z6192;
    const Scalar z6198 = z5931 * z6197;
    const Scalar z6144 = s_rear_left_hip * z6133 + c_rear_left_hip * z6137;
    const Scalar z6143 = s_rear_left_hip * z6137 - c_rear_left_hip * z6133;
    const Scalar z6175 = s_front_right_hip * z6164 + c_front_right_hip * z6168;
    const Scalar z6174 = s_front_right_hip * z6168 - c_front_right_hip * z6164;
    const Scalar z6141 = s_rear_left_hip * z6140 + c_rear_left_hip * z6139;
    const Scalar z6142 = s_rear_left_hip * z6139 - c_rear_left_hip * z6140;
    const Scalar z6201 = z5586 + z5934 * z6197;
    const Scalar z6202 = z5935 * z6197 - z6193;
    const Scalar z6207 = n12_24 * z5344 - z6107 + z6138 - z6169 + z6200;
    const Scalar z6206 = s_front_left_hip * z6195 + c_front_left_hip * z6199;
    const Scalar z6205 = s_front_left_hip * z6199 - c_front_left_hip * z6195;
    const Scalar z6172 = s_front_right_hip * z6171 + c_front_right_hip * z6170;
    const Scalar z6173 = s_front_right_hip * z6170 - c_front_right_hip * z6171;
    const Scalar z6203 = s_front_left_hip * z6202 + c_front_left_hip * z6201;
    const Scalar z6212 = n0_2948 * z5350 - z6113 - z6144 - z6175 - z6206 - n0_05 * (z6107 + z6138 + z6169 + z6200)
        - n0_2 * (z6110 - z6141 - z6172 + z6203);
    const Scalar z6208 = n12_24 * z5345 + z6110 - z6141 + z6172 - z6203;
    const Scalar z6204 = s_front_left_hip * z6201 - c_front_left_hip * z6202;
    const Scalar z6210 = n0_0306 * z5354 + z5587 + z5590 + z5593 + z5596 - n0_05 * (z6111 + z6142 + z6173 + z6204);
    const Scalar z6211 = n0_3254 * z5353 - z6112 - z6143 - z6174 - z6205 - n0_2 * (z6111 - z6142 - z6173 + z6204);
    const Scalar z6209 = n12_24 * z5346 + z6111 - z6142 + z6173 - z6204;
    const Scalar z6214 = z6005 * z6212 + z6210;
    const Scalar z6215 = z6006 * z6212 - z6211;
    const Scalar z6216 = z6007 * z6212 + z6207;
    const Scalar z6217 = z6008 * z6212 + z6208;
    const Scalar z6218 = z6009 * z6212 - z6209;
    const Scalar z6213 = z6004 * z6212;
    const Scalar z6220 = z6026 * z6215 - z6214;
    const Scalar z6221 = z6027 * z6215 - z6216;
    const Scalar z6222 = z6028 * z6215 - z6217;
    const Scalar z6223 = z6029 * z6215 - z6218;
    const Scalar z6219 = z6025 * z6215;
    const Scalar z6225 = z6041 * z6220 - z6221;
    const Scalar z6226 = z6042 * z6220 - z6222;
    const Scalar z6227 = z6043 * z6220 + z6223;
    const Scalar z6224 = z6040 * z6220;
    const Scalar z6228 = z5201 * z6225 + z5202 * z6226 + z5215 * z6227;
    const Scalar z6229 = z5203 * z6225 + z5208 * z6226 + z5209 * z6227;
    const Scalar z6230 = z5210 * z6226 + z5213 * z6227 + z5214 * z6225;
    const Scalar z6231 = z6065 * z6230;
    const Scalar z6232 = z6066 * z6230 - z6228;
    const Scalar z6233 = z6067 * z6230 - z6229;
    const Scalar z6234 = z6071 * z6233;
    const Scalar z6235 = z6072 * z6233 + z6232;
    const Scalar z6236 = z6074 * z6235;
    const Scalar z6237 = z6072 * z6236 + z6234;
    const Scalar z6238 = z6231 + z6066 * z6236 + z6067 * z6237;
    const Scalar z6239 = z5201 * z6236 + z5203 * z6237 - z5214 * z6238;
    const Scalar z6240 = z5202 * z6236 + z5208 * z6237 - z5210 * z6238;
    const Scalar z6241 = z5215 * z6236 + z5209 * z6237 - z5213 * z6238;
    const Scalar z6242 = z6224 + z6041 * z6239 + z6042 * z6240 + z6043 * z6241;
    const Scalar z6243 = z6219 - z6027 * z6239 - z6028 * z6240 + z6029 * z6241 + z6026 * z6242;
    const Scalar z6244 = z6009 * z6241 - z6213 - z6007 * z6239 - z6008 * z6240 + z6005 * z6242 - z6006 * z6243;
    const Scalar z6247 = z6241 - n0_05 * z6242 - n0_2 * z6243;
    const Scalar z6266 = z6241 + n0_05 * z6242 - n0_2 * z6243;
    const Scalar z6285 = z6241 - n0_05 * z6242 + n0_2 * z6243;
    const Scalar z6303 = z6241 + n0_05 * z6242 + n0_2 * z6243;
    const Scalar z6245 = z6239 + n0_05 * z6244;
    const Scalar z6246 = z6240 - n0_2 * z6244;
    const Scalar z6248 = s_front_left_hip * z6244 - c_front_left_hip * z6243;
    const Scalar z6249 = s_front_left_hip * z6243 + c_front_left_hip * z6244;
    const Scalar z6265 = z6239 - n0_05 * z6244;
    const Scalar z6267 = s_front_right_hip * z6244 - c_front_right_hip * z6243;
    const Scalar z6268 = s_front_right_hip * z6243 + c_front_right_hip * z6244;
    const Scalar z6284 = z6240 + n0_2 * z6244;
    const Scalar z6286 = s_rear_left_hip * z6244 - c_rear_left_hip * z6243;
    const Scalar z6287 = s_rear_left_hip * z6243 + c_rear_left_hip * z6244;
    const Scalar z6305 = s_rear_right_hip * z6243 + c_rear_right_hip * z6244;
    const Scalar z6304 = s_rear_right_hip * z6244 - c_rear_right_hip * z6243;
    const Scalar z6250 = s_front_left_hip * z6247 + c_front_left_hip * z6246;
    const Scalar z6251 = s_front_left_hip * z6246 - c_front_left_hip * z6247;
    const Scalar z6269 = s_front_right_hip * z6266 + c_front_right_hip * z6246;
    const Scalar z6270 = s_front_right_hip * z6246 - c_front_right_hip * z6266;
    const Scalar z6252 = z6198 + z5932 * z6249 + z5933 * z6245 - z5934 * z6250 - z5935 * z6251;
    const Scalar z6271 = z6167 + z5827 * z6268 - z5828 * z6265 - z5829 * z6269 + z5830 * z6270;
    const Scalar z6254 = z6245 + n0_08 * z6249;
    const Scalar z6273 = z6265 - n0_08 * z6268;
    const Scalar z6255 = z6251 + n0_08 * z6252;
    const Scalar z6253 = z6242 - z6252;
    const Scalar z6274 = z6270 - n0_08 * z6271;
    const Scalar z6272 = z6242 - z6271;
    const Scalar z6288 = s_rear_left_hip * z6285 + c_rear_left_hip * z6284;
    const Scalar z6289 = s_rear_left_hip * z6284 - c_rear_left_hip * z6285;
    const Scalar z6290 = z6136 + z5722 * z6287 + z5723 * z6245 - z5724 * z6288 - z5725 * z6289;
    const Scalar z6292 = z6245 + n0_08 * z6287;
    const Scalar z6306 = s_rear_right_hip * z6303 + c_rear_right_hip * z6284;
    const Scalar z6307 = s_rear_right_hip * z6284 - c_rear_right_hip * z6303;
    const Scalar z6308 = z6105 + z5632 * z6305 - z5633 * z6265 - z5634 * z6306 + z5635 * z6307;
    const Scalar z6310 = z6265 - n0_08 * z6305;
    const Scalar z6293 = z6289 + n0_08 * z6290;
    const Scalar z6291 = z6242 - z6290;
    const Scalar z6309 = z6242 - z6308;
    const Scalar z6311 = z6307 - n0_08 * z6308;
    const Scalar z6256 = c_front_left_thigh * z6254 + s_front_left_thigh * z6255;
    const Scalar z6257 = s_front_left_thigh * z6254 - c_front_left_thigh * z6255;
    const Scalar z6258 = z5910 * z6256 - z6187 + z5911 * z6257;
    const Scalar z6275 = c_front_right_thigh * z6273 + s_front_right_thigh * z6274;
    const Scalar z6276 = s_front_right_thigh * z6273 - c_front_right_thigh * z6274;
    const Scalar z6277 = z5805 * z6275 - z6156 + z5806 * z6276;
    const Scalar z6261 = z6256 - n0_2 * z6258;
    const Scalar z6259 = z6248 + z6258;
    const Scalar z6294 = c_rear_left_thigh * z6292 + s_rear_left_thigh * z6293;
    const Scalar z6260 = z5360 - z6259;  // acceleration of joint front_left_thigh_link
    const Scalar z6295 = s_rear_left_thigh * z6292 - c_rear_left_thigh * z6293;
    const Scalar z6296 = z5700 * z6294 - z6125 + z5701 * z6295;
    const Scalar z6262 = s_front_left_knee * z6257 - c_front_left_knee * z6261;
    const Scalar z6263 = z6179 + k25 * z6262;
    const Scalar z6280 = z6275 - n0_2 * z6277;
    const Scalar z6281 = s_front_right_knee * z6276 - c_front_right_knee * z6280;
    const Scalar z6299 = z6294 - n0_2 * z6296;
    const Scalar z6264 = z6258 + z6263;
    const Scalar z6312 = c_rear_right_thigh * z6310 + s_rear_right_thigh * z6311;
    const Scalar z6313 = s_rear_right_thigh * z6310 - c_rear_right_thigh * z6311;
    const Scalar z6314 = z5610 * z6312 - z6094 + z5611 * z6313;
    const Scalar z6300 = s_rear_left_knee * z6295 - c_rear_left_knee * z6299;
    const Scalar z6278 = z6267 + z6277;
    const Scalar z6282 = z6148 + k25 * z6281;
    const Scalar z6297 = z6286 + z6296;
    const Scalar z6301 = z6117 + k25 * z6300;
    const Scalar z6317 = z6312 - n0_2 * z6314;
    const Scalar z6315 = z6304 + z6314;
    const Scalar z6279 = z5394 - z6278;  // acceleration of joint front_right_thigh_link
    const Scalar z6283 = z6277 + z6282;
    const Scalar z6298 = z5428 - z6297;  // acceleration of joint rear_left_thigh_link
    const Scalar z6302 = z6296 + z6301;
    const Scalar z6316 = z5462 - z6315;  // acceleration of joint rear_right_thigh_link
    const Scalar z6318 = s_rear_right_knee * z6313 - c_rear_right_knee * z6317;
    const Scalar z6319 = z6086 + k25 * z6318;
    const Scalar z6320 = z6314 + z6319;
    accelerations.trunk_x = -z6236;
    accelerations.trunk_y = -z6237;
    accelerations.trunk_z = z6238;
    accelerations.trunk_attitude_omega_x = z6242;
    accelerations.trunk_attitude_omega_y = -z6243;
    accelerations.trunk_attitude_omega_z = z6244;
    accelerations.front_left_hip = -z6253;
    accelerations.front_left_thigh = z6260;
    accelerations.front_left_knee = z6264;
    accelerations.front_right_hip = -z6272;
    accelerations.front_right_thigh = z6279;
    accelerations.front_right_knee = z6283;
    accelerations.rear_left_hip = -z6291;
    accelerations.rear_left_thigh = z6298;
    accelerations.rear_left_knee = z6302;
    accelerations.rear_right_hip = -z6309;
    accelerations.rear_right_thigh = z6316;
    accelerations.rear_right_knee = z6320;
    if (!(traits::regular(z5607, z5607) && traits::regular(z5626, z5626) && traits::regular(z5697, z5697)
        && traits::regular(z5716, z5716) && traits::regular(z5802, z5802) && traits::regular(z5821, z5821)
        && traits::regular(z5907, z5907) && traits::regular(z5926, z5926) && traits::regular(z5988, z5988)
        && traits::regular(z6019, z6019) && traits::regular(z6031, z6031) && traits::regular(-z6064, -z6064)
        && traits::regular(-z6070, -z6070) && traits::regular(-z6073, -z6073))) return torsor::Status::singular;
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_0014 = traits::constant(0.0014, 0.0014f, "7/5000");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar k10 = traits::constant(0.00928, 0.00928f, "29/3125");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n0_26 = traits::constant(0.26, 0.26f, "13/50");
    const Scalar k13 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_0125 = traits::constant(0.0125, 0.0125f, "1/80");
    const Scalar n0_0425 = traits::constant(0.0425, 0.0425f, "17/400");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar k18 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
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
    const Scalar z6624 = q_front_left_thigh + q_front_left_knee;
    const Scalar z6638 = q_front_right_thigh + q_front_right_knee;
    const Scalar z6651 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z6664 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z6624, z6638, z6651, z6664};
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
    const Scalar z6625 = sines_[12], z6626 = cosines_[12];
    const Scalar z6639 = sines_[13], z6640 = cosines_[13];
    const Scalar z6652 = sines_[14], z6653 = cosines_[14];
    const Scalar z6665 = sines_[15], z6666 = cosines_[15];
    const Scalar z6594 = n2 * q_trunk_attitude_y;
    const Scalar z6596 = n2 * q_trunk_attitude_z;
    const Scalar z6603 = n2 * q_trunk_attitude_x;
    const Scalar z6620 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z6634 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z6647 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z6610 = q_trunk_attitude_x * z6596;
    const Scalar z6611 = q_trunk_attitude_w * z6594;
    const Scalar z6597 = q_trunk_attitude_z * z6596;
    const Scalar z6598 = q_trunk_attitude_x * z6594;
    const Scalar z6599 = q_trunk_attitude_w * z6596;
    const Scalar z6605 = q_trunk_attitude_z * z6594;
    const Scalar z6606 = q_trunk_attitude_w * z6603;
    const Scalar z6614 = z6610 + z6611;
    const Scalar z6595 = q_trunk_attitude_y * z6594;
    const Scalar z6601 = z6598 - z6599;
    const Scalar z6604 = q_trunk_attitude_x * z6603;
    const Scalar z6608 = z6605 - z6606;
    const Scalar z6607 = n1 - z6597 - z6604;
    const Scalar z6612 = n1 - z6595 - z6604;
    const Scalar z6609 = z6605 + z6606;
    const Scalar z6602 = z6598 + z6599;
    const Scalar z6613 = z6610 - z6611;
    const Scalar z6600 = n1 - z6595 - z6597;
    const Scalar z6684 = v_trunk_x * z6614 + v_trunk_y * z6608 + v_trunk_z * z6612;
    const Scalar z6683 = v_trunk_x * z6601 + v_trunk_y * z6607 + v_trunk_z * z6609;
    const Scalar z6682 = v_trunk_y * z6602 + v_trunk_z * z6613 + v_trunk_x * z6600;
    const Scalar z6685 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z6660 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z6619 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z6633 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z6646 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z6659 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z6686 = z6682 - z6685;
    const Scalar z6618 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z6632 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z6645 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z6658 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z6670 = n0_05 * v_front_left_hip;
    const Scalar z6671 = n0_05 * v_front_left_thigh;
    const Scalar z6672 = n0_05 * v_front_left_knee;
    const Scalar z6673 = n0_05 * v_front_right_hip;
    const Scalar z6674 = n0_05 * v_front_right_thigh;
    const Scalar z6675 = n0_05 * v_front_right_knee;
    const Scalar z6676 = n0_05 * v_rear_left_hip;
    const Scalar z6677 = n0_05 * v_rear_left_thigh;
    const Scalar z6678 = n0_05 * v_rear_left_knee;
    const Scalar z6679 = n0_05 * v_rear_right_hip;
    const Scalar z6680 = n0_05 * v_rear_right_thigh;
    const Scalar z6681 = n0_05 * v_rear_right_knee;
    const Scalar z6615 = n0_2 * z6613;
    const Scalar z6687 = n0_2 * v_trunk_attitude_omega_z + z6683;
    const Scalar z6616 = n0_05 * z6609 + z6615;
    const Scalar z6688 = z6684 + n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z6617 = q_trunk_z + z6616;  // place of front_left_hip_link, z
    const Scalar z6657 = q_trunk_z - z6616;  // place of rear_right_hip_link, z
    const Scalar z6690 = s_front_left_hip * z6687 - c_front_left_hip * z6688;
    const Scalar z6689 = s_front_left_hip * z6688 + c_front_left_hip * z6687;
    const Scalar z6630 = n0_05 * z6609 - z6615;
    const Scalar z6631 = q_trunk_z - z6630;  // place of front_right_hip_link, z
    const Scalar z6644 = q_trunk_z + z6630;  // place of rear_left_hip_link, z
    const Scalar z6621 = c_front_left_thigh * z6620 + s_front_left_thigh * z6619;
    const Scalar z6623 = v_front_left_thigh + z6618;
    const Scalar z6637 = v_front_right_thigh + z6632;
    const Scalar z6650 = v_rear_left_thigh + z6645;
    const Scalar z6663 = v_rear_right_thigh + z6658;
    const Scalar z6692 = n0_08 * z6620 - z6690;
    const Scalar z6691 = n0_08 * z6619 + z6686;
    const Scalar z6622 = s_front_left_thigh * z6620 - c_front_left_thigh * z6619;
    const Scalar z6628 = s_front_left_knee * z6621 + c_front_left_knee * z6622;
    const Scalar z6627 = s_front_left_knee * z6622 - c_front_left_knee * z6621;
    const Scalar z6636 = s_front_right_thigh * z6634 - c_front_right_thigh * z6633;
    const Scalar z6649 = s_rear_left_thigh * z6647 - c_rear_left_thigh * z6646;
    const Scalar z6662 = s_rear_right_thigh * z6660 - c_rear_right_thigh * z6659;
    const Scalar z6693 = s_front_left_thigh * z6692 - c_front_left_thigh * z6691;
    const Scalar z6694 = s_front_left_thigh * z6691 + c_front_left_thigh * z6692;
    const Scalar z6635 = c_front_right_thigh * z6634 + s_front_right_thigh * z6633;
    const Scalar z6642 = s_front_right_knee * z6635 + c_front_right_knee * z6636;
    const Scalar z6641 = s_front_right_knee * z6636 - c_front_right_knee * z6635;
    const Scalar z6648 = c_rear_left_thigh * z6647 + s_rear_left_thigh * z6646;
    const Scalar z6655 = s_rear_left_knee * z6648 + c_rear_left_knee * z6649;
    const Scalar z6654 = s_rear_left_knee * z6649 - c_rear_left_knee * z6648;
    const Scalar z6661 = c_rear_right_thigh * z6660 + s_rear_right_thigh * z6659;
    const Scalar z6668 = s_rear_right_knee * z6661 + c_rear_right_knee * z6662;
    const Scalar z6667 = s_rear_right_knee * z6662 - c_rear_right_knee * z6661;
    const Scalar z6695 = n0_2 * z6623 + z6693;
    const Scalar z6629 = v_front_left_knee + z6623;
    const Scalar z6699 = z6682 + z6685;
    const Scalar z6698 = s_front_left_knee * z6695 - c_front_left_knee * z6694;
    const Scalar z6697 = s_front_left_knee * z6694 + c_front_left_knee * z6695;
    const Scalar z6700 = n0_05 * v_trunk_attitude_omega_x - z6684 + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z6702 = s_front_right_hip * z6687 + c_front_right_hip * z6700;
    const Scalar z6701 = s_front_right_hip * z6700 - c_front_right_hip * z6687;
    const Scalar z6703 = n0_08 * z6633 - z6699;
    const Scalar z6704 = n0_08 * z6634 + z6702;
    const Scalar z6643 = v_front_right_knee + z6637;
    const Scalar z6711 = n0_2 * v_trunk_attitude_omega_z - z6683;
    const Scalar z6712 = z6684 + n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z6714 = s_rear_left_hip * z6711 + c_rear_left_hip * z6712;
    const Scalar z6713 = s_rear_left_hip * z6712 - c_rear_left_hip * z6711;
    const Scalar z6715 = n0_08 * z6646 + z6686;
    const Scalar z6705 = s_front_right_thigh * z6704 - c_front_right_thigh * z6703;
    const Scalar z6706 = s_front_right_thigh * z6703 + c_front_right_thigh * z6704;
    const Scalar z6716 = n0_08 * z6647 + z6714;
    const Scalar z6707 = n0_2 * z6637 - z6705;
    const Scalar z6717 = s_rear_left_thigh * z6716 - c_rear_left_thigh * z6715;
    const Scalar z6718 = s_rear_left_thigh * z6715 + c_rear_left_thigh * z6716;
    const Scalar z6710 = c_front_right_knee * z6706 + s_front_right_knee * z6707;
    const Scalar z6709 = s_front_right_knee * z6706 - c_front_right_knee * z6707;
    const Scalar z6656 = v_rear_left_knee + z6650;
    const Scalar z6723 = n0_05 * v_trunk_attitude_omega_x - z6684 - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z6725 = s_rear_right_hip * z6711 - c_rear_right_hip * z6723;
    const Scalar z6724 = s_rear_right_hip * z6723 + c_rear_right_hip * z6711;
    const Scalar z6726 = n0_08 * z6659 - z6699;
    const Scalar z6727 = n0_08 * z6660 - z6725;
    const Scalar z6719 = n0_2 * z6650 + z6717;
    const Scalar z6722 = s_rear_left_knee * z6719 - c_rear_left_knee * z6718;
    const Scalar z6721 = s_rear_left_knee * z6718 + c_rear_left_knee * z6719;
    const Scalar z6728 = s_rear_right_thigh * z6727 - c_rear_right_thigh * z6726;
    const Scalar z6669 = v_rear_right_knee + z6663;
    const Scalar z6729 = s_rear_right_thigh * z6726 + c_rear_right_thigh * z6727;
    const Scalar z6736 = n0_02 * z6620 - n0_5 * z6690;
    const Scalar z6737 = n0_0014 * z6620 - n0_02 * z6690;
    const Scalar z6740 = n0_072 * z6623 + n0_8 * z6693;
    const Scalar z6743 = k10 * z6623 + n0_072 * z6693;
    const Scalar z6741 = n0_8 * z6689 + n0_072 * z6621;
    const Scalar z6742 = n0_072 * z6689 + k10 * z6621;
    const Scalar z6696 = n0_2 * z6621 + z6689;
    const Scalar z6744 = n0_032 * z6629 + n0_26 * z6697;
    const Scalar z6747 = k13 * z6629 + n0_032 * z6697;
    const Scalar z6745 = n0_032 * z6627 - n0_26 * z6696;
    const Scalar z6746 = k13 * z6627 - n0_032 * z6696;
    const Scalar z6750 = n0_02 * z6634 + n0_5 * z6702;
    const Scalar z6751 = n0_0014 * z6634 + n0_02 * z6702;
    const Scalar z6754 = n0_072 * z6637 - n0_8 * z6705;
    const Scalar z6757 = k10 * z6637 - n0_072 * z6705;
    const Scalar z6755 = n0_072 * z6635 - n0_8 * z6701;
    const Scalar z6756 = k10 * z6635 - n0_072 * z6701;
    const Scalar z6708 = n0_2 * z6635 - z6701;
    const Scalar z6758 = n0_032 * z6643 - n0_26 * z6709;
    const Scalar z6761 = k13 * z6643 - n0_032 * z6709;
    const Scalar z6759 = n0_032 * z6641 - n0_26 * z6708;
    const Scalar z6760 = k13 * z6641 - n0_032 * z6708;
    const Scalar z6763 = n0_02 * z6647 + n0_5 * z6714;
    const Scalar z6764 = n0_0014 * z6647 + n0_02 * z6714;
    const Scalar z6766 = n0_072 * z6650 + n0_8 * z6717;
    const Scalar z6769 = k10 * z6650 + n0_072 * z6717;
    const Scalar z6767 = n0_8 * z6713 + n0_072 * z6648;
    const Scalar z6768 = n0_072 * z6713 + k10 * z6648;
    const Scalar z6720 = n0_2 * z6648 + z6713;
    const Scalar z6770 = n0_032 * z6656 + n0_26 * z6721;
    const Scalar z6773 = k13 * z6656 + n0_032 * z6721;
    const Scalar z6771 = n0_032 * z6654 - n0_26 * z6720;
    const Scalar z6772 = k13 * z6654 - n0_032 * z6720;
    const Scalar z6789 = n0_08 * c_front_left_hip;
    const Scalar z6775 = n0_02 * z6660 - n0_5 * z6725;
    const Scalar z6776 = n0_0014 * z6660 - n0_02 * z6725;
    const Scalar z6730 = n0_2 * z6663 - z6728;
    const Scalar z6790 = n0_08 * s_front_left_hip;
    const Scalar z6733 = c_rear_right_knee * z6729 + s_rear_right_knee * z6730;
    const Scalar z6732 = s_rear_right_knee * z6729 - c_rear_right_knee * z6730;
    const Scalar z6786 = n0_02 * c_front_left_hip;
    const Scalar z6778 = n0_072 * z6663 - n0_8 * z6728;
    const Scalar z6781 = k10 * z6663 - n0_072 * z6728;
    const Scalar z6731 = n0_2 * z6661 - z6724;
    const Scalar z6791 = n0_05 + z6789;
    const Scalar z6792 = z6615 + z6612 * z6790 + z6609 * z6791;
    const Scalar z6779 = n0_072 * z6661 - n0_8 * z6724;
    const Scalar z6780 = k10 * z6661 - n0_072 * z6724;
    const Scalar z6734 = n0_5 * z6686;
    const Scalar z6738 = n0_02 * z6686;
    const Scalar z6748 = n0_5 * z6699;
    const Scalar z6793 = q_trunk_z + z6792;
    const Scalar z6752 = n0_02 * z6699;
    const Scalar z6787 = n0_02 * s_front_left_hip;
    const Scalar z6788 = z6609 * z6786 + z6612 * z6787;
    const Scalar z6794 = n0_072 * s_front_left_thigh;
    const Scalar z6735 = n0_02 * z6619 + z6734;
    const Scalar z6795 = n0_072 * c_front_left_thigh;
    const Scalar z6739 = n0_0014 * z6619 + z6738;
    const Scalar z6799 = n0_2 * s_front_left_thigh;
    const Scalar z6762 = n0_02 * z6646 + z6734;
    const Scalar z6800 = n0_2 * c_front_left_thigh;
    const Scalar z6765 = n0_0014 * z6646 + z6738;
    const Scalar z6803 = n0_2 - z6799;
    const Scalar z6808 = n0_032 * z6626;
    const Scalar z6796 = s_front_left_hip * z6795;
    const Scalar z6802 = c_front_left_hip * z6800 - z6790;
    const Scalar z6801 = s_front_left_hip * z6800 + z6789;
    const Scalar z6797 = c_front_left_hip * z6795;
    const Scalar z6804 = n0_05 + z6801;
    const Scalar z6807 = n0_032 * z6625;
    const Scalar z6798 = z6609 * z6796 - z6612 * z6797 - z6613 * z6794;
    const Scalar z6805 = z6613 * z6803 - z6612 * z6802 + z6609 * z6804;
    const Scalar z6749 = n0_02 * z6633 - z6748;
    const Scalar z6809 = s_front_left_hip * z6808;
    const Scalar z6810 = c_front_left_hip * z6808;
    const Scalar z6812 = n0_02 * c_front_right_hip;
    const Scalar z6753 = n0_0014 * z6633 - z6752;
    const Scalar z6816 = n0_08 * s_front_right_hip;
    const Scalar z6826 = n0_2 * c_front_right_thigh;
    const Scalar z6815 = n0_08 * c_front_right_hip;
    const Scalar z6821 = n0_072 * c_front_right_thigh;
    const Scalar z6811 = z6609 * z6809 - z6612 * z6810 - z6613 * z6807;
    const Scalar z6825 = n0_2 * s_front_right_thigh;
    const Scalar z6828 = c_front_right_hip * z6826 + z6816;
    const Scalar z6822 = s_front_right_hip * z6821;
    const Scalar z6774 = n0_02 * z6659 - z6748;
    const Scalar z6834 = n0_032 * z6640;
    const Scalar z6777 = n0_0014 * z6659 - z6752;
    const Scalar z6841 = n0_08 * c_rear_left_hip;
    const Scalar z6829 = n0_2 - z6825;
    const Scalar z6835 = s_front_right_hip * z6834;
    const Scalar z6806 = q_trunk_z + z6805;
    const Scalar z6827 = s_front_right_hip * z6826 - z6815;
    const Scalar z6823 = c_front_right_hip * z6821;
    const Scalar z6836 = c_front_right_hip * z6834;
    const Scalar z6817 = n0_05 + z6815;
    const Scalar z6830 = n0_05 - z6827;
    const Scalar z6838 = n0_02 * c_rear_left_hip;
    const Scalar z6818 = z6612 * z6816 - z6615 + z6609 * z6817;
    const Scalar z6813 = n0_02 * s_front_right_hip;
    const Scalar z6831 = z6612 * z6828 - z6613 * z6829 + z6609 * z6830;
    const Scalar z6820 = n0_072 * s_front_right_thigh;
    const Scalar z6833 = n0_032 * z6639;
    const Scalar z6824 = z6609 * z6822 - z6612 * z6823 - z6613 * z6820;
    const Scalar z6839 = n0_02 * s_rear_left_hip;
    const Scalar z6782 = n0_032 * z6669 - n0_26 * z6732;
    const Scalar z6842 = n0_08 * s_rear_left_hip;
    const Scalar z6783 = n0_032 * z6667 - n0_26 * z6731;
    const Scalar z6843 = n0_05 + z6841;
    const Scalar z6837 = z6609 * z6835 - z6612 * z6836 - z6613 * z6833;
    const Scalar z6784 = k13 * z6667 - n0_032 * z6731;
    const Scalar z6844 = z6612 * z6842 - z6615 + z6609 * z6843;
    const Scalar z6785 = k13 * z6669 - n0_032 * z6732;
    const Scalar z6852 = n0_2 * c_rear_left_thigh;
    const Scalar z6853 = s_rear_left_hip * z6852 + z6841;
    const Scalar z6868 = n0_08 * s_rear_right_hip;
    const Scalar z6847 = n0_072 * c_rear_left_thigh;
    const Scalar z6860 = n0_032 * z6653;
    const Scalar z6867 = n0_08 * c_rear_right_hip;
    const Scalar z6873 = n0_072 * c_rear_right_thigh;
    const Scalar z6848 = s_rear_left_hip * z6847;
    const Scalar z6814 = z6609 * z6812 + z6612 * z6813;
    const Scalar z6877 = n0_2 * s_rear_right_thigh;
    const Scalar z6878 = n0_2 * c_rear_right_thigh;
    const Scalar z6840 = z6609 * z6838 + z6612 * z6839;
    const Scalar z6856 = n0_05 + z6853;
    const Scalar z6854 = c_rear_left_hip * z6852 - z6842;
    const Scalar z6861 = s_rear_left_hip * z6860;
    const Scalar z6874 = s_rear_right_hip * z6873;
    const Scalar z6851 = n0_2 * s_rear_left_thigh;
    const Scalar z6819 = q_trunk_z - z6818;
    const Scalar z6881 = n0_2 + z6877;
    const Scalar z6886 = n0_032 * z6666;
    const Scalar z6832 = q_trunk_z - z6831;
    const Scalar z6880 = c_rear_right_hip * z6878 + z6868;
    const Scalar z6845 = q_trunk_z + z6844;
    const Scalar z6887 = s_rear_right_hip * z6886;
    const Scalar z6879 = s_rear_right_hip * z6878 - z6867;
    const Scalar z6849 = c_rear_left_hip * z6847;
    const Scalar z6862 = c_rear_left_hip * z6860;
    const Scalar z6875 = c_rear_right_hip * z6873;
    const Scalar z6888 = c_rear_right_hip * z6886;
    const Scalar z6855 = n0_2 + z6851;
    const Scalar z6857 = z6609 * z6856 - z6612 * z6854 - z6613 * z6855;
    const Scalar z6864 = n0_02 * c_rear_right_hip;
    const Scalar z6869 = n0_05 + z6867;
    const Scalar z6882 = n0_05 - z6879;
    const Scalar z6846 = n0_072 * s_rear_left_thigh;
    const Scalar z6850 = z6609 * z6848 - z6612 * z6849 - z6613 * z6846;
    const Scalar z6859 = n0_032 * z6652;
    const Scalar z6865 = n0_02 * s_rear_right_hip;
    const Scalar z6872 = n0_072 * s_rear_right_thigh;
    const Scalar z6863 = z6609 * z6861 - z6612 * z6862 - z6613 * z6859;
    const Scalar z6885 = n0_032 * z6665;
    const Scalar z6870 = z6615 + z6612 * z6868 + z6609 * z6869;
    const Scalar z6883 = z6613 * z6881 + z6612 * z6880 + z6609 * z6882;
    const Scalar z6858 = q_trunk_z + z6857;
    const Scalar z6866 = z6609 * z6864 + z6612 * z6865;
    const Scalar z6871 = q_trunk_z - z6870;
    const Scalar z6876 = z6609 * z6874 - z6612 * z6875 - z6613 * z6872;
    const Scalar z6884 = q_trunk_z - z6883;
    const Scalar z6889 = z6609 * z6887 - z6612 * z6888 - z6613 * z6885;
    result.kinetic = n0_0125 * v_trunk_attitude_omega_x * v_trunk_attitude_omega_x + n0_0425 * v_trunk_attitude_omega_y
        * v_trunk_attitude_omega_y + v_trunk_attitude_omega_z * z6685 + n3 * (z6682 * z6682 + z6683 * z6683 + z6684
        * z6684) + n0_25 * (z6689 * z6689 + z6701 * z6701 + z6713 * z6713 + z6724 * z6724) + k18 * (z6628 * z6628
        + z6642 * z6642 + z6655 * z6655 + z6668 * z6668) + n0_4 * (z6694 * z6694 + z6706 * z6706 + z6718 * z6718 + z6729
        * z6729) + n0_0002 * (z6618 * z6618 + z6632 * z6632 + z6645 * z6645 + z6658 * z6658 + z6622 * z6622 + z6636
        * z6636 + z6649 * z6649 + z6662 * z6662) + n0_13 * (z6710 * z6710 + z6733 * z6733 + z6698 * z6698 + z6722
        * z6722) + n0_5 * (z6619 * z6739 + z6620 * z6737 + z6633 * z6753 + z6634 * z6751 + z6646 * z6765 + z6647 * z6764
        + z6659 * z6777 + z6660 * z6776 - z6690 * z6736 + z6702 * z6750 + z6714 * z6763 - z6725 * z6775 + z6686 * (z6735
        + z6762) - z6699 * (z6749 + z6774) + z6621 * z6742 + z6648 * z6768 + z6689 * z6741 + z6713 * z6767 + z6635
        * z6756 + z6661 * z6780 - z6701 * z6755 - z6724 * z6779 + z6623 * z6743 + z6637 * z6757 + z6650 * z6769 + z6663
        * z6781 + z6693 * z6740 - z6705 * z6754 + z6717 * z6766 - z6728 * z6778 + z6627 * z6746 + z6641 * z6760 + z6654
        * z6772 + z6667 * z6784 - z6696 * z6745 - z6708 * z6759 - z6720 * z6771 - z6731 * z6783 + z6629 * z6747 + z6643
        * z6761 + z6656 * z6773 + z6669 * z6785 + z6697 * z6744 - z6709 * z6758 + z6721 * z6770 - z6732 * z6782);
    result.force_function = -n58_86 * q_trunk_z - n4_905 * (z6617 + z6631 + z6644 + z6657) - n7_848 * (z6793 + z6819
        + z6845 + z6871) - n2_5506 * (z6806 + z6884 + z6832 + z6858) - n9_81 * (z6788 - z6814 + z6840 - z6866 + z6798
        + z6824 + z6850 + z6876 + z6811 + z6837 + z6863 + z6889);
    result.power = v_front_left_hip * (u_front_left_hip_torque - z6670) + v_front_left_thigh
        * (u_front_left_thigh_torque - z6671) + v_front_left_knee * (u_front_left_knee_torque - z6672)
        + v_front_right_hip * (u_front_right_hip_torque - z6673) + v_front_right_thigh * (u_front_right_thigh_torque
        - z6674) + v_front_right_knee * (u_front_right_knee_torque - z6675) + v_rear_left_hip * (u_rear_left_hip_torque
        - z6676) + v_rear_left_thigh * (u_rear_left_thigh_torque - z6677) + v_rear_left_knee * (u_rear_left_knee_torque
        - z6678) + v_rear_right_hip * (u_rear_right_hip_torque - z6679) + v_rear_right_thigh
        * (u_rear_right_thigh_torque - z6680) + v_rear_right_knee * (u_rear_right_knee_torque - z6681);
  }
};

}  // namespace quadruped
