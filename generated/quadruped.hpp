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
  static constexpr unsigned long long fingerprint = 0xa5cb40d602bf16f1ULL;
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
    const Scalar z0 = n2 * q_trunk_attitude_y;
    const Scalar z1 = n2 * q_trunk_attitude_x;
    const Scalar z2 = n2 * q_trunk_attitude_z;
    const Scalar z3 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z4 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z5 = q_trunk_attitude_y * z0;
    const Scalar z6 = q_trunk_attitude_z * z0;
    const Scalar z7 = q_trunk_attitude_w * z1;
    const Scalar z8 = q_trunk_attitude_x * z1;
    const Scalar z9 = q_trunk_attitude_x * z2;
    const Scalar z10 = z6 + z7;
    const Scalar z11 = q_trunk_attitude_w * z0;
    const Scalar z12 = n1 - z5 - z8;
    const Scalar z13 = z9 - z11;
    const Scalar z14 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z15 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z16 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z17 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z18 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z19 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z20 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z21 = z6 - z7;
    const Scalar z22 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z23 = z9 + z11;
    const Scalar z24 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z25 = q_trunk_attitude_x * z0;
    const Scalar z26 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z27 = q_trunk_attitude_z * z2;
    const Scalar z28 = q_trunk_attitude_w * z2;
    const Scalar z29 = n1 - z5 - z27;
    const Scalar z30 = n1 - z27 - z8;
    const Scalar z31 = z25 + z28;
    const Scalar z32 = z25 - z28;
    const Scalar z33 = n9_81 * z10;
    const Scalar z34 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z35 = n9_81 * z12;
    const Scalar z36 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z37 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z38 = z36 + z37;
    const Scalar z39 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z40 = z37 + z39;
    const Scalar z41 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z42 = n9_81 * z13;
    const Scalar z43 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z44 = z35 + n0_2 * z41 + n0_05 * z43;
    const Scalar z45 = z33 + n0_2 * z34 - n0_05 * z40;
    const Scalar z46 = z42 - n0_2 * z38 + n0_05 * z34;
    const Scalar z47 = n0_05 * v_front_left_hip;
    const Scalar z48 = n0_05 * v_front_left_thigh;
    const Scalar z49 = s_front_left_hip * z44 + c_front_left_hip * z45;
    const Scalar z50 = n0_05 * v_front_left_knee;
    const Scalar z51 = n0_05 * v_front_right_hip;
    const Scalar z52 = n0_05 * v_front_right_thigh;
    const Scalar z53 = n0_05 * v_front_right_knee;
    const Scalar z54 = n0_05 * v_rear_left_hip;
    const Scalar z55 = n0_05 * v_rear_left_thigh;
    const Scalar z56 = n0_05 * v_rear_left_knee;
    const Scalar z57 = n0_05 * v_rear_right_hip;
    const Scalar z58 = n0_05 * v_rear_right_thigh;
    const Scalar z59 = n0_05 * v_rear_right_knee;
    const Scalar z60 = c_front_left_thigh * z18 + s_front_left_thigh * z24;
    const Scalar z61 = s_front_left_hip * z45 - c_front_left_hip * z44;
    const Scalar z62 = s_front_left_thigh * z18 - c_front_left_thigh * z24;
    const Scalar z63 = v_front_left_thigh + z26;
    const Scalar z64 = c_front_right_thigh * z16 + s_front_right_thigh * z19;
    const Scalar z65 = s_front_right_thigh * z16 - c_front_right_thigh * z19;
    const Scalar z66 = c_rear_right_thigh * z3 + s_rear_right_thigh * z15;
    const Scalar z67 = s_rear_right_thigh * z3 - c_rear_right_thigh * z15;
    const Scalar z68 = c_rear_left_thigh * z14 + s_rear_left_thigh * z17;
    const Scalar z69 = s_rear_left_thigh * z14 - c_rear_left_thigh * z17;
    const Scalar z70 = v_rear_right_thigh + z4;
    const Scalar z71 = s_rear_right_knee * z67 - c_rear_right_knee * z66;
    const Scalar z72 = s_rear_right_knee * z66 + c_rear_right_knee * z67;
    const Scalar z73 = v_front_left_hip * z26;  // angular acceleration of front_left_hip_link, z
    const Scalar z74 = v_rear_left_thigh + z22;
    const Scalar z75 = s_rear_left_knee * z69 - c_rear_left_knee * z68;
    const Scalar z76 = s_rear_left_knee * z68 + c_rear_left_knee * z69;
    const Scalar z77 = v_rear_right_knee + z70;
    const Scalar z78 = v_front_right_thigh + z20;
    const Scalar z79 = s_front_right_knee * z65 - c_front_right_knee * z64;
    const Scalar z80 = s_front_right_knee * z64 + c_front_right_knee * z65;
    const Scalar z81 = v_rear_left_knee + z74;
    const Scalar z82 = s_front_left_knee * z62 - c_front_left_knee * z60;
    const Scalar z83 = s_front_left_knee * z60 + c_front_left_knee * z62;
    const Scalar z84 = v_front_right_knee + z78;
    const Scalar z85 = z26 * z18;
    const Scalar z86 = z73 + z85;
    const Scalar z87 = v_front_left_knee + z63;
    const Scalar z88 = z26 * z24;
    const Scalar z89 = v_front_right_hip * z20;  // angular acceleration of front_right_hip_link, z
    const Scalar z90 = s_front_right_thigh * z89;
    const Scalar z91 = z33 + n0_2 * z34 + n0_05 * z40;
    const Scalar z92 = z35 + n0_2 * z41 - n0_05 * z43;
    const Scalar z93 = v_front_right_thigh * z65 - z90;  // angular acceleration of front_right_thigh_link, x
    const Scalar z94 = z20 * z16;
    const Scalar z95 = z89 + z94;
    const Scalar z96 = c_front_right_thigh * z89;
    const Scalar z97 = v_front_right_thigh * z64 - z96;  // angular acceleration of front_right_thigh_link, z
    const Scalar z98 = z20 * z19;
    const Scalar z99 = s_front_left_thigh * z73;
    const Scalar z100 = c_front_left_thigh * z73;
    const Scalar z101 = v_front_left_thigh * z62 - z99;  // angular acceleration of front_left_thigh_link, x
    const Scalar z102 = v_front_left_thigh * z60 - z100;  // angular acceleration of front_left_thigh_link, z
    const Scalar z103 = z42 - n0_2 * z38 - n0_05 * z34;
    const Scalar z104 = z19 * z19;
    const Scalar z105 = z16 * z16;
    const Scalar z106 = z104 + z105;
    const Scalar z107 = v_front_right_hip * z19;  // angular acceleration of front_right_hip_link, y
    const Scalar z108 = s_front_right_hip * z91 - c_front_right_hip * z92;
    const Scalar z109 = s_front_right_hip * z92 + c_front_right_hip * z91;
    const Scalar z110 = z109 + n0_08 * z106;
    const Scalar z111 = z24 * z24;
    const Scalar z112 = z18 * z18;
    const Scalar z113 = z111 + z112;
    const Scalar z114 = z103 - n0_08 * z95;
    const Scalar z115 = v_front_left_hip * z24;  // angular acceleration of front_left_hip_link, y
    const Scalar z116 = z42 + n0_2 * z38 + n0_05 * z34;
    const Scalar z117 = z49 - n0_08 * z113;
    const Scalar z118 = z65 * z78;
    const Scalar z119 = z93 + z118;
    const Scalar z120 = z64 * z65;
    const Scalar z121 = s_front_right_knee * z93 - c_front_right_knee * z97;
    const Scalar z122 = s_front_right_knee * z97 + c_front_right_knee * z93;
    const Scalar z123 = v_front_right_knee * z79 + z121;  // angular acceleration of front_right_shank_link, z
    const Scalar z124 = v_front_right_knee * z80 + z122;  // angular acceleration of front_right_shank_link, x
    const Scalar z125 = z108 - n0_08 * z98;
    const Scalar z126 = z62 * z63;
    const Scalar z127 = z101 + z126;
    const Scalar z128 = z60 * z62;
    const Scalar z129 = z64 * z64;
    const Scalar z130 = z78 * z78;
    const Scalar z131 = z129 + z130;
    const Scalar z132 = s_front_left_knee * z101 - c_front_left_knee * z102;
    const Scalar z133 = s_front_left_knee * z102 + c_front_left_knee * z101;
    const Scalar z134 = v_front_left_knee * z82 + z132;  // angular acceleration of front_left_shank_link, z
    const Scalar z135 = v_front_left_knee * z83 + z133;  // angular acceleration of front_left_shank_link, x
    const Scalar z136 = z46 + n0_08 * z86;
    const Scalar z137 = z33 - n0_2 * z34 - n0_05 * z40;
    const Scalar z138 = z35 - n0_2 * z41 + n0_05 * z43;
    const Scalar z139 = s_front_right_thigh * z114 - c_front_right_thigh * z125;
    const Scalar z140 = s_front_right_thigh * z125 + c_front_right_thigh * z114;
    const Scalar z141 = z139 + n0_2 * z131;
    const Scalar z142 = z110 - n0_2 * z119;
    const Scalar z143 = z61 + n0_08 * z88;
    const Scalar z144 = s_rear_left_hip * z138 + c_rear_left_hip * z137;
    const Scalar z145 = z60 * z60;
    const Scalar z146 = z63 * z63;
    const Scalar z147 = z145 + z146;
    const Scalar z148 = z107 - z120;
    const Scalar z149 = z117 - n0_2 * z127;
    const Scalar z150 = s_front_left_thigh * z136 - c_front_left_thigh * z143;
    const Scalar z151 = s_front_left_thigh * z143 + c_front_left_thigh * z136;
    const Scalar z152 = s_rear_left_hip * z137 - c_rear_left_hip * z138;
    const Scalar z153 = z150 + n0_2 * z147;
    const Scalar z154 = v_rear_left_hip * z22;  // angular acceleration of rear_left_hip_link, z
    const Scalar z155 = z22 * z14;
    const Scalar z156 = z154 + z155;
    const Scalar z157 = v_rear_left_hip * z17;  // angular acceleration of rear_left_hip_link, y
    const Scalar z158 = z140 + n0_2 * z148;
    const Scalar z159 = s_front_right_knee * z141 - c_front_right_knee * z158;
    const Scalar z160 = z115 - z128;
    const Scalar z161 = z22 * z17;
    const Scalar z162 = s_rear_left_thigh * z154;
    const Scalar z163 = c_rear_left_thigh * z154;
    const Scalar z164 = z17 * z17;
    const Scalar z165 = z14 * z14;
    const Scalar z166 = z164 + z165;
    const Scalar z167 = z116 + n0_08 * z156;
    const Scalar z168 = z151 + n0_2 * z160;
    const Scalar z169 = s_front_left_knee * z153 - c_front_left_knee * z168;
    const Scalar z170 = z33 - n0_2 * z34 + n0_05 * z40;
    const Scalar z171 = z42 + n0_2 * z38 - n0_05 * z34;
    const Scalar z172 = v_rear_left_thigh * z69 - z162;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z173 = v_rear_left_thigh * z68 - z163;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z174 = z144 - n0_08 * z166;
    const Scalar z175 = v_rear_right_hip * z4;  // angular acceleration of rear_right_hip_link, z
    const Scalar z176 = s_rear_right_thigh * z175;
    const Scalar z177 = z35 - n0_2 * z41 - n0_05 * z43;
    const Scalar z178 = z4 * z3;
    const Scalar z179 = v_rear_right_thigh * z67 - z176;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z180 = z175 + z178;
    const Scalar z181 = c_rear_right_thigh * z175;
    const Scalar z182 = v_rear_right_thigh * z66 - z181;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z183 = z4 * z15;
    const Scalar z184 = z15 * z15;
    const Scalar z185 = z3 * z3;
    const Scalar z186 = z184 + z185;
    const Scalar z187 = s_rear_right_hip * z170 - c_rear_right_hip * z177;
    const Scalar z188 = s_rear_right_hip * z177 + c_rear_right_hip * z170;
    const Scalar z189 = z188 + n0_08 * z186;
    const Scalar z190 = z171 - n0_08 * z180;
    const Scalar z191 = v_rear_right_hip * z15;  // angular acceleration of rear_right_hip_link, y
    const Scalar z192 = z67 * z70;
    const Scalar z193 = z179 + z192;
    const Scalar z194 = z66 * z67;
    const Scalar z195 = z71 * z72;
    const Scalar z196 = s_rear_right_knee * z179 - c_rear_right_knee * z182;
    const Scalar z197 = s_rear_right_knee * z182 + c_rear_right_knee * z179;
    const Scalar z198 = v_rear_right_knee * z71 + z196;  // angular acceleration of rear_right_shank_link, z
    const Scalar z199 = v_rear_right_knee * z72 + z197;  // angular acceleration of rear_right_shank_link, x
    const Scalar z200 = z72 * z77;
    const Scalar z201 = z187 - n0_08 * z183;
    const Scalar z202 = z66 * z66;
    const Scalar z203 = z70 * z70;
    const Scalar z204 = z202 + z203;
    const Scalar z205 = z191 + z195;
    const Scalar z206 = s_rear_right_thigh * z190 - c_rear_right_thigh * z201;
    const Scalar z207 = s_rear_right_thigh * z201 + c_rear_right_thigh * z190;
    const Scalar z208 = z206 + n0_2 * z204;
    const Scalar z209 = z189 - n0_2 * z193;
    const Scalar z210 = z69 * z74;
    const Scalar z211 = z172 + z210;
    const Scalar z212 = z68 * z69;
    const Scalar z213 = s_rear_left_knee * z172 - c_rear_left_knee * z173;
    const Scalar z214 = s_rear_left_knee * z173 + c_rear_left_knee * z172;
    const Scalar z215 = v_rear_left_knee * z75 + z213;  // angular acceleration of rear_left_shank_link, z
    const Scalar z216 = v_rear_left_knee * z76 + z214;  // angular acceleration of rear_left_shank_link, x
    const Scalar z217 = z191 - z194;
    const Scalar z218 = z152 + n0_08 * z161;
    const Scalar z219 = z199 + z200;
    const Scalar z220 = z68 * z68;
    const Scalar z221 = z74 * z74;
    const Scalar z222 = z220 + z221;
    const Scalar z223 = z207 + n0_2 * z217;
    const Scalar z224 = s_rear_right_knee * z208 - c_rear_right_knee * z223;
    const Scalar z225 = s_rear_left_thigh * z167 - c_rear_left_thigh * z218;
    const Scalar z226 = s_rear_left_thigh * z218 + c_rear_left_thigh * z167;
    const Scalar z227 = z225 + n0_2 * z222;
    const Scalar z228 = z71 * z71;
    const Scalar z229 = z71 * z77;
    const Scalar z230 = z198 + z229;
    const Scalar z231 = z77 * z77;
    const Scalar z232 = z228 + z231;
    const Scalar z233 = z174 - n0_2 * z211;
    const Scalar z234 = z157 - z212;
    const Scalar z235 = k6 * z191 + k7 * z195 - n0_032 * z224;  // moment on rear_right_shank_link, y
    const Scalar z236 = n0_032 * z205;  // force on rear_right_shank_link, x
    const Scalar z237 = n0_032 * z232;  // force on rear_right_shank_link, z
    const Scalar z238 = k9 * z230;  // moment on rear_right_shank_link, z
    const Scalar z239 = n0_032 * z209 - k10 * z219;  // moment on rear_right_shank_link, x
    const Scalar z240 = n0_032 * z219;  // force on rear_right_shank_link, y
    const Scalar z241 = s_rear_right_knee * z236 - c_rear_right_knee * z237;
    const Scalar z242 = s_rear_right_knee * z237 + c_rear_right_knee * z236;
    const Scalar z243 = z226 + n0_2 * z234;
    const Scalar z244 = z66 * z70;
    const Scalar z245 = s_rear_left_knee * z227 - c_rear_left_knee * z243;
    const Scalar z246 = n0_124 * z204 - z241;  // force on rear_right_thigh_link, z
    const Scalar z247 = z182 + z244;
    const Scalar z248 = z15 * z3;
    // moment on rear_right_thigh_link, y
    const Scalar z249 = k12 * z191 - k13 * z194 + n0_124 * z207 + n0_2 * z242 + z235;
    const Scalar z250 = n0_124 * z217 + z242;  // force on rear_right_thigh_link, x
    const Scalar z251 = z191 + z248;
    const Scalar z252 = z68 * z74;
    const Scalar z253 = z173 + z252;
    const Scalar z254 = z17 * z14;
    const Scalar z255 = z249 + n0_0002 * z251;  // moment on rear_right_hip_link, y
    const Scalar z256 = z157 + z254;
    const Scalar z257 = z75 * z76;
    const Scalar z258 = z76 * z81;
    const Scalar z259 = z216 + z258;
    const Scalar z260 = k6 * z157 + k7 * z257 - n0_032 * z245;  // moment on rear_left_shank_link, y
    const Scalar z261 = z157 + z257;
    const Scalar z262 = n0_032 * z261;  // force on rear_left_shank_link, x
    const Scalar z263 = n0_032 * z233 - k10 * z259;  // moment on rear_left_shank_link, x
    const Scalar z264 = n0_032 * z259;  // force on rear_left_shank_link, y
    const Scalar z265 = z75 * z75;
    const Scalar z266 = z75 * z81;
    const Scalar z267 = z215 + z266;
    const Scalar z268 = z81 * z81;
    const Scalar z269 = z265 + z268;
    const Scalar z270 = s_rear_right_knee * z238 - c_rear_right_knee * z239;
    const Scalar z271 = c_rear_right_knee * z238 + s_rear_right_knee * z239;
    const Scalar z272 = n0_124 * z189 - k15 * z193 - n0_2 * z240 - z270;  // moment on rear_right_thigh_link, x
    const Scalar z273 = n0_124 * z193 + z240;  // force on rear_right_thigh_link, y
    const Scalar z274 = z271 - n0_0002 * z247;  // moment on rear_right_thigh_link, z
    const Scalar z275 = n0_1048 * z186 - z273;  // force on rear_right_hip_link, y
    const Scalar z276 = n0_032 * z269;  // force on rear_left_shank_link, z
    const Scalar z277 = k9 * z267;  // moment on rear_left_shank_link, z
    const Scalar z278 = z79 * z80;
    const Scalar z279 = s_rear_left_knee * z262 - c_rear_left_knee * z276;
    const Scalar z280 = s_rear_left_knee * z276 + c_rear_left_knee * z262;
    const Scalar z281 = n0_124 * z222 - z279;  // force on rear_left_thigh_link, z
    const Scalar z282 = s_rear_right_thigh * z246 + c_rear_right_thigh * z250;
    const Scalar z283 = s_rear_right_thigh * z250 - c_rear_right_thigh * z246;
    // moment on rear_left_thigh_link, y
    const Scalar z284 = k12 * z157 - k13 * z212 + n0_124 * z226 + n0_2 * z280 + z260;
    const Scalar z285 = n0_124 * z234 + z280;  // force on rear_left_thigh_link, x
    const Scalar z286 = z80 * z84;
    const Scalar z287 = z107 + z278;
    const Scalar z288 = z284 + n0_0002 * z256;  // moment on rear_left_hip_link, y
    const Scalar z289 = s_rear_left_knee * z277 - c_rear_left_knee * z263;
    const Scalar z290 = c_rear_left_knee * z277 + s_rear_left_knee * z263;
    const Scalar z291 = n0_124 * z174 - k15 * z211 - n0_2 * z264 - z289;  // moment on rear_left_thigh_link, x
    const Scalar z292 = n0_124 * z211 + z264;  // force on rear_left_thigh_link, y
    const Scalar z293 = z290 - n0_0002 * z253;  // moment on rear_left_thigh_link, z
    const Scalar z294 = n0_1048 * z166 + z292;  // force on rear_left_hip_link, y
    const Scalar z295 = s_rear_left_thigh * z281 + c_rear_left_thigh * z285;
    const Scalar z296 = s_rear_left_thigh * z285 - c_rear_left_thigh * z281;
    const Scalar z297 = s_rear_right_thigh * z272 + c_rear_right_thigh * z274;
    const Scalar z298 = n0_1048 * z171 - k17 * z180 + n0_08 * z282 - z297;  // moment on rear_right_hip_link, z
    const Scalar z299 = n0_1048 * z180 - z282;  // force on rear_right_hip_link, x
    const Scalar z300 = s_rear_right_thigh * z274 - c_rear_right_thigh * z272;
    const Scalar z301 = z124 + z286;
    const Scalar z302 = n0_1048 * z187 - k18 * z183 + n0_08 * z283 - z300;  // moment on rear_right_hip_link, x
    const Scalar z303 = n0_1048 * z183 - z283;  // force on rear_right_hip_link, z
    const Scalar z304 = n0_032 * z287;  // force on front_right_shank_link, x
    const Scalar z305 = n0_032 * z142 - k10 * z301;  // moment on front_right_shank_link, x
    const Scalar z306 = n0_032 * z301;  // force on front_right_shank_link, y
    const Scalar z307 = z79 * z79;
    const Scalar z308 = z79 * z84;
    const Scalar z309 = z123 + z308;
    const Scalar z310 = z84 * z84;
    const Scalar z311 = z307 + z310;
    const Scalar z312 = n0_1048 * z156 + z295;  // force on rear_left_hip_link, x
    const Scalar z313 = s_rear_right_hip * z275 + c_rear_right_hip * z303;
    const Scalar z314 = s_rear_right_hip * z303 - c_rear_right_hip * z275;
    const Scalar z315 = k6 * z107 + k7 * z278 - n0_032 * z159;  // moment on front_right_shank_link, y
    const Scalar z316 = n0_032 * z311;  // force on front_right_shank_link, z
    const Scalar z317 = k9 * z309;  // moment on front_right_shank_link, z
    const Scalar z318 = s_rear_right_hip * z255 - c_rear_right_hip * z298;
    const Scalar z319 = c_rear_right_hip * z255 + s_rear_right_hip * z298;
    const Scalar z320 = z64 * z78;
    const Scalar z321 = z97 + z320;
    const Scalar z322 = z19 * z16;
    const Scalar z323 = z107 + z322;
    const Scalar z324 = z82 * z83;
    const Scalar z325 = z83 * z87;
    const Scalar z326 = z115 + z324;
    const Scalar z327 = s_front_right_knee * z304 - c_front_right_knee * z316;
    const Scalar z328 = s_front_right_knee * z316 + c_front_right_knee * z304;
    // moment on front_right_thigh_link, y
    const Scalar z329 = k12 * z107 - k13 * z120 + n0_124 * z140 + n0_2 * z328 + z315;
    const Scalar z330 = n0_124 * z131 - z327;  // force on front_right_thigh_link, z
    const Scalar z331 = n0_124 * z148 + z328;  // force on front_right_thigh_link, x
    const Scalar z332 = s_front_right_knee * z317 - c_front_right_knee * z305;
    const Scalar z333 = c_front_right_knee * z317 + s_front_right_knee * z305;
    const Scalar z334 = n0_124 * z110 - k15 * z119 - n0_2 * z306 - z332;  // moment on front_right_thigh_link, x
    const Scalar z335 = n0_124 * z119 + z306;  // force on front_right_thigh_link, y
    const Scalar z336 = z333 - n0_0002 * z321;  // moment on front_right_thigh_link, z
    const Scalar z337 = n0_1048 * z106 - z335;  // force on front_right_hip_link, y
    const Scalar z338 = z329 + n0_0002 * z323;  // moment on front_right_hip_link, y
    const Scalar z339 = s_front_right_thigh * z330 + c_front_right_thigh * z331;
    const Scalar z340 = s_front_right_thigh * z331 - c_front_right_thigh * z330;
    const Scalar z341 = n0_1048 * z95 - z339;  // force on front_right_hip_link, x
    const Scalar z342 = n0_1048 * z161 + z296;  // force on rear_left_hip_link, z
    const Scalar z343 = s_rear_left_thigh * z291 + c_rear_left_thigh * z293;
    const Scalar z344 = n0_1048 * z116 + k17 * z156 + n0_08 * z295 + z343;  // moment on rear_left_hip_link, z
    const Scalar z345 = s_rear_left_thigh * z293 - c_rear_left_thigh * z291;
    const Scalar z346 = n0_1048 * z152 + k18 * z161 + n0_08 * z296 + z345;  // moment on rear_left_hip_link, x
    const Scalar z347 = z135 + z325;
    const Scalar z348 = n0_032 * z326;  // force on front_left_shank_link, x
    const Scalar z349 = n0_032 * z149 - k10 * z347;  // moment on front_left_shank_link, x
    const Scalar z350 = n0_032 * z347;  // force on front_left_shank_link, y
    const Scalar z351 = z82 * z82;
    const Scalar z352 = z82 * z87;
    const Scalar z353 = z134 + z352;
    const Scalar z354 = z87 * z87;
    const Scalar z355 = z351 + z354;
    const Scalar z356 = s_front_right_thigh * z334 + c_front_right_thigh * z336;
    const Scalar z357 = n0_1048 * z103 - k17 * z95 + n0_08 * z339 - z356;  // moment on front_right_hip_link, z
    const Scalar z358 = s_front_right_thigh * z336 - c_front_right_thigh * z334;
    const Scalar z359 = n0_1048 * z108 - k18 * z98 + n0_08 * z340 - z358;  // moment on front_right_hip_link, x
    const Scalar z360 = n0_1048 * z98 - z340;  // force on front_right_hip_link, z
    const Scalar z361 = n0_032 * z355;  // force on front_left_shank_link, z
    const Scalar z362 = s_rear_left_hip * z294 + c_rear_left_hip * z342;
    const Scalar z363 = s_rear_left_hip * z342 - c_rear_left_hip * z294;
    const Scalar z364 = k6 * z115 + k7 * z324 - n0_032 * z169;  // moment on front_left_shank_link, y
    const Scalar z365 = k9 * z353;  // moment on front_left_shank_link, z
    const Scalar z366 = s_front_right_hip * z337 + c_front_right_hip * z360;
    const Scalar z367 = s_front_right_hip * z360 - c_front_right_hip * z337;
    const Scalar z368 = s_rear_left_hip * z288 + c_rear_left_hip * z344;
    const Scalar z369 = s_rear_left_hip * z344 - c_rear_left_hip * z288;
    const Scalar z370 = z52 - z329;
    const Scalar z371 = z53 - z315;
    const Scalar z372 = z60 * z63;
    const Scalar z373 = z102 + z372;
    const Scalar z374 = z24 * z18;
    const Scalar z375 = z50 - z364;
    const Scalar z376 = z51 + z359;
    const Scalar z377 = z115 + z374;
    const Scalar z378 = s_front_left_knee * z348 - c_front_left_knee * z361;
    const Scalar z379 = s_front_left_knee * z361 + c_front_left_knee * z348;
    // moment on front_left_thigh_link, y
    const Scalar z380 = k12 * z115 - k13 * z128 + n0_124 * z151 + n0_2 * z379 + z364;
    const Scalar z381 = n0_124 * z147 - z378;  // force on front_left_thigh_link, z
    const Scalar z382 = n0_124 * z160 + z379;  // force on front_left_thigh_link, x
    const Scalar z383 = s_front_left_knee * z365 - c_front_left_knee * z349;
    const Scalar z384 = c_front_left_knee * z365 + s_front_left_knee * z349;
    const Scalar z385 = n0_124 * z117 - k15 * z127 - n0_2 * z350 - z383;  // moment on front_left_thigh_link, x
    const Scalar z386 = n0_124 * z127 + z350;  // force on front_left_thigh_link, y
    const Scalar z387 = z384 - n0_0002 * z373;  // moment on front_left_thigh_link, z
    const Scalar z388 = n0_1048 * z113 + z386;  // force on front_left_hip_link, y
    const Scalar z389 = z48 - z380;
    const Scalar z390 = z380 + n0_0002 * z377;  // moment on front_left_hip_link, y
    const Scalar z391 = s_front_left_thigh * z381 + c_front_left_thigh * z382;
    const Scalar z392 = s_front_left_thigh * z382 - c_front_left_thigh * z381;
    const Scalar z393 = n0_1048 * z86 + z391;  // force on front_left_hip_link, x
    const Scalar z394 = s_front_left_thigh * z385 + c_front_left_thigh * z387;
    const Scalar z395 = n0_1048 * z46 + k17 * z86 + n0_08 * z391 + z394;  // moment on front_left_hip_link, z
    const Scalar z396 = s_front_left_thigh * z387 - c_front_left_thigh * z385;
    const Scalar z397 = n0_1048 * z61 + k18 * z88 + n0_08 * z392 + z396;  // moment on front_left_hip_link, x
    const Scalar z398 = n0_1048 * z88 + z392;  // force on front_left_hip_link, z
    const Scalar z399 = z47 - z397;
    const Scalar z400 = n12_24 * z42 - z299 + z312 - z341 + z393;  // force on trunk, x
    const Scalar z401 = c_front_right_hip * z338 + s_front_right_hip * z357;
    const Scalar z402 = s_front_right_hip * z338 - c_front_right_hip * z357;
    const Scalar z403 = z55 - z284;
    const Scalar z404 = z56 - z260;
    const Scalar z405 = z58 - z249;
    const Scalar z406 = z59 - z235;
    const Scalar z407 = z54 - z346;
    const Scalar z408 = z57 + z302;
    const Scalar z409 = s_front_left_hip * z388 + c_front_left_hip * z398;
    // moment on trunk, x
    const Scalar z410 = n0_0306 * z43 + z302 - z346 + z359 - z397 - n0_05 * (z313 + z362 + z366 + z409);
    const Scalar z411 = s_front_left_hip * z398 - c_front_left_hip * z388;
    const Scalar z412 = n12_24 * z35 + z313 - z362 + z366 - z409;  // force on trunk, z
    const Scalar z413 = n12_24 * z33 - z314 + z363 - z367 + z411;  // force on trunk, y
    const Scalar z414 = z29 * z400 + z23 * z412 + z32 * z413;
    const Scalar z415 = z31 * z400 + z21 * z412 + z30 * z413;
    const Scalar z416 = z13 * z400 + z12 * z412 + z10 * z413;
    const Scalar z417 = s_front_left_hip * z395 - c_front_left_hip * z390;
    // moment on trunk, y
    const Scalar z418 = n0_3254 * z41 + z319 + z401 - z369 - z417 - n0_2 * (z313 - z362 - z366 + z409);
    const Scalar z419 = s_front_left_hip * z390 + c_front_left_hip * z395;
    // moment on trunk, z
    const Scalar z420 = n0_2948 * z34 - z318 - n0_05 * (z299 + z312 + z341 + z393) - z368 - z402 - z419 + n0_2 * (z314
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
    const Scalar z0 = n2 * q_trunk_attitude_y;
    const Scalar z1 = n2 * q_trunk_attitude_z;
    const Scalar z2 = n2 * q_trunk_attitude_x;
    const Scalar z3 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z4 = q_trunk_attitude_z * z1;
    const Scalar z5 = q_trunk_attitude_x * z0;
    const Scalar z6 = q_trunk_attitude_w * z1;
    const Scalar z7 = q_trunk_attitude_x * z1;
    const Scalar z8 = q_trunk_attitude_w * z0;
    const Scalar z9 = q_trunk_attitude_x * z2;
    const Scalar z10 = z5 - z6;
    const Scalar z11 = q_trunk_attitude_z * z0;
    const Scalar z12 = q_trunk_attitude_w * z2;
    const Scalar z13 = z7 + z8;
    const Scalar z14 = q_trunk_attitude_y * z0;
    const Scalar z15 = n1 - z4 - z9;
    const Scalar z16 = z5 + z6;
    const Scalar z17 = z11 - z12;
    const Scalar z18 = z11 + z12;
    const Scalar z19 = z7 - z8;
    const Scalar z20 = n1 - z14 - z9;
    const Scalar z21 = n1 - z14 - z4;
    const Scalar z22 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z23 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z24 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z25 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z26 = z22 + z23;
    const Scalar z27 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z28 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z29 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z30 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z31 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z32 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z33 = z27 + z22;
    const Scalar z34 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z35 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z36 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z37 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z38 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z39 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z40 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z41 = z37 * z37;
    const Scalar z42 = n0_05 * v_front_left_hip;
    const Scalar z43 = n0_05 * v_front_left_thigh;
    const Scalar z44 = n0_05 * v_front_left_knee;
    const Scalar z45 = n0_05 * v_front_right_hip;
    const Scalar z46 = n0_05 * v_front_right_thigh;
    const Scalar z47 = n0_05 * v_front_right_knee;
    const Scalar z48 = n0_05 * v_rear_left_hip;
    const Scalar z49 = n0_05 * v_rear_left_thigh;
    const Scalar z50 = n0_05 * v_rear_left_knee;
    const Scalar z51 = n0_05 * v_rear_right_hip;
    const Scalar z52 = n0_05 * v_rear_right_thigh;
    const Scalar z53 = n0_05 * v_rear_right_knee;
    const Scalar z54 = c_front_left_thigh * z37 + s_front_left_thigh * z39;
    const Scalar z55 = s_front_left_thigh * z37 - c_front_left_thigh * z39;
    const Scalar z56 = v_front_left_thigh + z40;
    const Scalar z57 = c_front_right_thigh * z35 + s_front_right_thigh * z38;
    const Scalar z58 = s_front_right_thigh * z35 - c_front_right_thigh * z38;
    const Scalar z59 = v_front_right_thigh + z36;
    const Scalar z60 = c_rear_left_thigh * z32 + s_rear_left_thigh * z34;
    const Scalar z61 = s_rear_left_thigh * z32 - c_rear_left_thigh * z34;
    const Scalar z62 = v_rear_left_thigh + z30;
    const Scalar z63 = c_rear_right_thigh * z25 + s_rear_right_thigh * z31;
    const Scalar z64 = s_rear_right_thigh * z25 - c_rear_right_thigh * z31;
    const Scalar z65 = v_rear_right_thigh + z3;
    const Scalar z66 = z40 * z37;
    const Scalar z67 = z39 * z39;
    const Scalar z68 = z40 * z39;
    const Scalar z69 = v_front_left_knee + z56;
    const Scalar z70 = v_front_right_knee + z59;
    const Scalar z71 = v_rear_left_knee + z62;
    const Scalar z72 = v_rear_right_knee + z65;
    const Scalar z73 = z67 + z41;
    const Scalar z74 = z56 * z56;
    const Scalar z75 = s_front_left_knee * z55 - c_front_left_knee * z54;
    const Scalar z76 = s_rear_right_knee * z64 - c_rear_right_knee * z63;
    const Scalar z77 = s_rear_right_knee * z63 + c_rear_right_knee * z64;
    const Scalar z78 = s_rear_left_knee * z61 - c_rear_left_knee * z60;
    const Scalar z79 = s_rear_left_knee * z60 + c_rear_left_knee * z61;
    const Scalar z80 = s_front_right_knee * z58 - c_front_right_knee * z57;
    const Scalar z81 = s_front_right_knee * z57 + c_front_right_knee * z58;
    const Scalar z82 = z36 * z35;
    const Scalar z83 = s_front_left_knee * z54 + c_front_left_knee * z55;
    const Scalar z84 = z3 * z25;
    const Scalar z85 = z3 * z31;
    const Scalar z86 = z30 * z34;
    const Scalar z87 = z31 * z31;
    const Scalar z88 = z25 * z25;
    const Scalar z89 = z87 + z88;
    const Scalar z90 = z31 * z25;
    const Scalar z91 = z30 * z32;
    const Scalar z92 = z34 * z34;
    const Scalar z93 = z32 * z32;
    const Scalar z94 = z92 + z93;
    const Scalar z95 = z34 * z32;
    const Scalar z96 = z64 * z65;
    const Scalar z97 = z76 * z77;
    const Scalar z98 = z61 * z62;
    const Scalar z99 = z63 * z63;
    const Scalar z100 = z65 * z65;
    const Scalar z101 = z99 + z100;
    const Scalar z102 = z63 * z65;
    const Scalar z103 = z76 * z76;
    const Scalar z104 = z72 * z72;
    const Scalar z105 = z103 + z104;
    const Scalar z106 = z36 * z38;
    const Scalar z107 = z78 * z79;
    const Scalar z108 = z76 * z72;
    const Scalar z109 = z77 * z72;
    const Scalar z110 = z63 * z64;
    const Scalar z111 = n0_032 * z105;  // force on rear_right_shank_link, z
    const Scalar z112 = z60 * z60;
    const Scalar z113 = z62 * z62;
    const Scalar z114 = z112 + z113;
    const Scalar z115 = z60 * z62;
    const Scalar z116 = z78 * z78;
    const Scalar z117 = z71 * z71;
    const Scalar z118 = z116 + z117;
    const Scalar z119 = z38 * z38;
    const Scalar z120 = z35 * z35;
    const Scalar z121 = z119 + z120;
    const Scalar z122 = z78 * z71;
    const Scalar z123 = z79 * z71;
    const Scalar z124 = n0_032 * z118;  // force on rear_left_shank_link, z
    const Scalar z125 = z80 * z81;
    const Scalar z126 = z60 * z61;
    const Scalar z127 = z58 * z59;
    const Scalar z128 = z80 * z80;
    const Scalar z129 = z70 * z70;
    const Scalar z130 = z128 + z129;
    const Scalar z131 = z57 * z57;
    const Scalar z132 = z59 * z59;
    const Scalar z133 = z131 + z132;
    const Scalar z134 = z55 * z56;
    const Scalar z135 = z80 * z70;
    const Scalar z136 = n0_032 * z130;  // force on front_right_shank_link, z
    const Scalar z137 = z81 * z70;
    const Scalar z138 = z57 * z58;
    const Scalar z139 = z54 * z55;
    const Scalar z140 = z57 * z59;
    const Scalar z141 = z38 * z35;
    const Scalar z142 = z54 * z54;
    const Scalar z143 = z142 + z74;
    const Scalar z144 = z54 * z56;
    const Scalar z145 = z39 * z37;
    const Scalar z146 = n9_81 + a_trunk_z;
    const Scalar z147 = a_trunk_x * z10 + a_trunk_y * z15 + z18 * z146;
    const Scalar z148 = a_trunk_x * z13 + a_trunk_y * z17 + z20 * z146;
    const Scalar z149 = a_trunk_y * z16 + z19 * z146 + a_trunk_x * z21;
    const Scalar z150 = a_trunk_attitude_omega_y - z24;
    const Scalar z151 = a_trunk_attitude_omega_z + z28;
    const Scalar z152 = a_trunk_attitude_omega_x + z29;
    const Scalar z153 = a_trunk_attitude_omega_z - z28;
    const Scalar z154 = a_trunk_attitude_omega_y * s_front_right_hip - a_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z155 = v_front_right_hip * z36 + z154;  // angular acceleration of front_right_hip_link, z
    // angular acceleration of front_right_hip_link, x
    const Scalar z156 = a_trunk_attitude_omega_x + a_front_right_hip;
    const Scalar z157 = a_trunk_attitude_omega_y * c_front_right_hip + a_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z158 = v_front_right_hip * z38 - z157;  // angular acceleration of front_right_hip_link, y
    const Scalar z159 = a_trunk_attitude_omega_y * s_front_left_hip - a_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z160 = v_front_left_hip * z40 + z159;  // angular acceleration of front_left_hip_link, z
    const Scalar z161 = n0_05 * z26 + z147 + n0_2 * z151;
    const Scalar z162 = a_trunk_attitude_omega_x + a_front_left_hip;  // angular acceleration of front_left_hip_link, x
    const Scalar z163 = a_trunk_attitude_omega_y * c_front_left_hip + a_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z164 = v_front_left_hip * z39 - z163;  // angular acceleration of front_left_hip_link, y
    const Scalar z165 = z66 + z160;
    const Scalar z166 = z148 - n0_2 * z150 - n0_05 * z152;
    const Scalar z167 = n0_05 * z26 - z147 - n0_2 * z151;
    const Scalar z168 = s_front_right_hip * z161 - c_front_right_hip * z166;
    const Scalar z169 = s_front_right_hip * z166 + c_front_right_hip * z161;
    const Scalar z170 = c_front_left_thigh * z162 + s_front_left_thigh * z160;
    const Scalar z171 = v_front_left_thigh * z55 - z170;  // angular acceleration of front_left_thigh_link, x
    const Scalar z172 = s_front_left_thigh * z162 - c_front_left_thigh * z160;
    const Scalar z173 = v_front_left_thigh * z54 + z172;  // angular acceleration of front_left_thigh_link, z
    const Scalar z174 = z148 - n0_2 * z150 + n0_05 * z152;
    const Scalar z175 = z134 + z171;
    const Scalar z176 = a_front_left_thigh - z164;  // angular acceleration of front_left_thigh_link, y
    const Scalar z177 = n0_2 * z33 - z149 - n0_05 * z153;
    const Scalar z178 = z75 * z83;
    const Scalar z179 = z82 + z155;
    const Scalar z180 = a_front_left_knee + z176;  // angular acceleration of front_left_shank_link, y
    const Scalar z181 = s_front_left_hip * z167 + c_front_left_hip * z174;
    const Scalar z182 = s_front_left_hip * z174 - c_front_left_hip * z167;
    const Scalar z183 = n0_08 * z73 - z182;
    const Scalar z184 = z68 - z162;
    const Scalar z185 = z75 * z75;
    const Scalar z186 = z69 * z69;
    const Scalar z187 = z185 + z186;
    const Scalar z188 = n0_2 * z33 - z149 + n0_05 * z153;
    const Scalar z189 = z181 - n0_08 * z184;
    const Scalar z190 = n0_032 * z187;  // force on front_left_shank_link, z
    const Scalar z191 = s_front_left_knee * z171 - c_front_left_knee * z173;
    const Scalar z192 = s_front_left_knee * z173 + c_front_left_knee * z171;
    const Scalar z193 = v_front_left_knee * z75 + z191;  // angular acceleration of front_left_shank_link, z
    const Scalar z194 = z75 * z69;
    const Scalar z195 = z83 * z69;
    const Scalar z196 = v_front_left_knee * z83 + z192;  // angular acceleration of front_left_shank_link, x
    const Scalar z197 = n0_08 * z121 + z169;
    const Scalar z198 = a_trunk_attitude_omega_y * s_rear_left_hip - a_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z199 = a_trunk_attitude_omega_x + a_rear_left_hip;  // angular acceleration of rear_left_hip_link, x
    const Scalar z200 = n0_05 * z26 - z147 + n0_2 * z151;
    const Scalar z201 = a_trunk_attitude_omega_y * c_rear_left_hip + a_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z202 = z148 + n0_2 * z150 + n0_05 * z152;
    const Scalar z203 = s_rear_left_hip * z200 + c_rear_left_hip * z202;
    const Scalar z204 = s_rear_left_hip * z202 - c_rear_left_hip * z200;
    const Scalar z205 = c_front_right_thigh * z156 + s_front_right_thigh * z155;
    const Scalar z206 = v_front_right_thigh * z58 - z205;  // angular acceleration of front_right_thigh_link, x
    const Scalar z207 = s_front_right_thigh * z156 - c_front_right_thigh * z155;
    const Scalar z208 = v_front_right_thigh * z57 + z207;  // angular acceleration of front_right_thigh_link, z
    const Scalar z209 = n0_2 * z33 + z149 - n0_05 * z153;
    const Scalar z210 = z127 + z206;
    const Scalar z211 = a_front_right_thigh - z158;  // angular acceleration of front_right_thigh_link, y
    const Scalar z212 = z106 - z156;
    const Scalar z213 = a_front_right_knee + z211;  // angular acceleration of front_right_shank_link, y
    const Scalar z214 = z168 - n0_08 * z212;
    const Scalar z215 = s_front_right_knee * z206 - c_front_right_knee * z208;
    const Scalar z216 = s_front_right_knee * z208 + c_front_right_knee * z206;
    const Scalar z217 = v_front_right_knee * z80 + z215;  // angular acceleration of front_right_shank_link, z
    const Scalar z218 = z177 + n0_08 * z179;
    const Scalar z219 = v_front_right_knee * z81 + z216;  // angular acceleration of front_right_shank_link, x
    const Scalar z220 = c_front_right_thigh * z214 + s_front_right_thigh * z218;
    const Scalar z221 = s_front_right_thigh * z214 - c_front_right_thigh * z218;
    const Scalar z222 = z197 - n0_2 * z210;
    const Scalar z223 = n0_2 * z133 - z220;
    const Scalar z224 = z188 - n0_08 * z165;
    const Scalar z225 = v_rear_left_hip * z30 + z198;  // angular acceleration of rear_left_hip_link, z
    const Scalar z226 = v_rear_left_hip * z34 - z201;  // angular acceleration of rear_left_hip_link, y
    const Scalar z227 = z91 + z225;
    const Scalar z228 = z138 + z211;
    const Scalar z229 = s_front_left_thigh * z189 + c_front_left_thigh * z224;
    const Scalar z230 = s_front_left_thigh * z224 - c_front_left_thigh * z189;
    const Scalar z231 = n0_08 * z94 - z204;
    const Scalar z232 = n0_2 * z143 - z230;
    const Scalar z233 = c_rear_left_thigh * z199 + s_rear_left_thigh * z225;
    const Scalar z234 = s_rear_left_thigh * z199 - c_rear_left_thigh * z225;
    const Scalar z235 = z86 - z199;
    const Scalar z236 = z209 + n0_08 * z227;
    const Scalar z237 = z139 + z176;
    const Scalar z238 = v_rear_left_thigh * z61 - z233;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z239 = z203 - n0_08 * z235;
    const Scalar z240 = z183 + n0_2 * z175;
    const Scalar z241 = c_rear_left_thigh * z239 + s_rear_left_thigh * z236;
    const Scalar z242 = s_rear_left_thigh * z239 - c_rear_left_thigh * z236;
    const Scalar z243 = z221 - n0_2 * z228;
    const Scalar z244 = s_front_right_knee * z223 - c_front_right_knee * z243;
    const Scalar z245 = z229 + n0_2 * z237;
    const Scalar z246 = v_rear_left_thigh * z60 + z234;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z247 = c_front_left_knee * z245 + s_front_left_knee * z232;
    const Scalar z248 = n0_05 * z26 + z147 - n0_2 * z151;
    const Scalar z249 = z148 + n0_2 * z150 - n0_05 * z152;
    const Scalar z250 = n0_2 * z33 + z149 + n0_05 * z153;
    const Scalar z251 = z98 + z238;
    const Scalar z252 = n0_2 * z114 + z241;
    const Scalar z253 = a_trunk_attitude_omega_y * s_rear_right_hip - a_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z254 = v_rear_right_hip * z3 + z253;  // angular acceleration of rear_right_hip_link, z
    const Scalar z255 = a_trunk_attitude_omega_x + a_rear_right_hip;  // angular acceleration of rear_right_hip_link, x
    const Scalar z256 = a_trunk_attitude_omega_y * c_rear_right_hip + a_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z257 = v_rear_right_hip * z31 - z256;  // angular acceleration of rear_right_hip_link, y
    const Scalar z258 = z84 + z254;
    const Scalar z259 = c_rear_right_thigh * z255 + s_rear_right_thigh * z254;
    const Scalar z260 = s_rear_right_thigh * z255 - c_rear_right_thigh * z254;
    const Scalar z261 = a_rear_right_thigh - z257;  // angular acceleration of rear_right_thigh_link, y
    const Scalar z262 = s_rear_right_hip * z248 - c_rear_right_hip * z249;
    const Scalar z263 = v_rear_right_thigh * z64 - z259;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z264 = v_rear_right_thigh * z63 + z260;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z265 = s_rear_right_hip * z249 + c_rear_right_hip * z248;
    const Scalar z266 = n0_08 * z89 + z265;
    const Scalar z267 = z96 + z263;
    const Scalar z268 = z102 + z264;
    const Scalar z269 = z85 - z255;
    const Scalar z270 = z250 - n0_08 * z258;
    const Scalar z271 = a_rear_right_knee + z261;  // angular acceleration of rear_right_shank_link, y
    const Scalar z272 = a_rear_left_thigh - z226;  // angular acceleration of rear_left_thigh_link, y
    const Scalar z273 = s_rear_right_knee * z263 - c_rear_right_knee * z264;
    const Scalar z274 = s_rear_right_knee * z264 + c_rear_right_knee * z263;
    const Scalar z275 = v_rear_right_knee * z76 + z273;  // angular acceleration of rear_right_shank_link, z
    const Scalar z276 = v_rear_right_knee * z77 + z274;  // angular acceleration of rear_right_shank_link, x
    const Scalar z277 = z262 - n0_08 * z269;
    const Scalar z278 = z108 + z275;
    const Scalar z279 = z97 - z271;
    const Scalar z280 = z109 + z276;
    const Scalar z281 = n0_032 * z279;  // force on rear_right_shank_link, x
    const Scalar z282 = a_rear_left_knee + z272;  // angular acceleration of rear_left_shank_link, y
    const Scalar z283 = s_rear_left_knee * z238 - c_rear_left_knee * z246;
    const Scalar z284 = v_rear_left_knee * z78 + z283;  // angular acceleration of rear_left_shank_link, z
    const Scalar z285 = s_rear_left_knee * z246 + c_rear_left_knee * z238;
    const Scalar z286 = v_rear_left_knee * z79 + z285;  // angular acceleration of rear_left_shank_link, x
    const Scalar z287 = k7 * z278;  // moment on rear_right_shank_link, z
    const Scalar z288 = s_rear_right_thigh * z270 - c_rear_right_thigh * z277;
    const Scalar z289 = s_rear_right_thigh * z277 + c_rear_right_thigh * z270;
    const Scalar z290 = n0_2 * z101 + z288;
    const Scalar z291 = z266 - n0_2 * z267;
    const Scalar z292 = n0_032 * z291 - k8 * z280;  // moment on rear_right_shank_link, x
    const Scalar z293 = n0_032 * z280;  // force on rear_right_shank_link, y
    const Scalar z294 = z110 + z261;
    const Scalar z295 = z231 + n0_2 * z251;
    const Scalar z296 = z126 + z272;
    const Scalar z297 = z289 - n0_2 * z294;
    const Scalar z298 = s_rear_right_knee * z281 - c_rear_right_knee * z111;
    const Scalar z299 = s_rear_right_knee * z111 + c_rear_right_knee * z281;
    const Scalar z300 = s_rear_right_knee * z290 - c_rear_right_knee * z297;
    const Scalar z301 = n0_124 * z101 - z298;  // force on rear_right_thigh_link, z
    const Scalar z302 = k10 * z97 - k11 * z271 - n0_032 * z300;  // moment on rear_right_shank_link, y
    const Scalar z303 = n0_124 * z294 - z299;  // force on rear_right_thigh_link, x
    const Scalar z304 = z242 + n0_2 * z296;
    // moment on rear_right_thigh_link, y
    const Scalar z305 = k12 * z110 + k13 * z261 - n0_124 * z289 - n0_2 * z299 - z302;
    const Scalar z306 = s_rear_left_knee * z252 + c_rear_left_knee * z304;
    const Scalar z307 = z122 + z284;
    const Scalar z308 = z123 + z286;
    const Scalar z309 = z137 + z219;
    const Scalar z310 = z90 + z257;
    const Scalar z311 = z115 + z246;
    const Scalar z312 = z95 + z226;
    const Scalar z313 = k7 * z307;  // moment on rear_left_shank_link, z
    const Scalar z314 = n0_032 * z295 + k8 * z308;  // moment on rear_left_shank_link, x
    const Scalar z315 = n0_032 * z308;  // force on rear_left_shank_link, y
    const Scalar z316 = k10 * z107 - k11 * z282 - n0_032 * z306;  // moment on rear_left_shank_link, y
    const Scalar z317 = z107 - z282;
    const Scalar z318 = n0_032 * z317;  // force on rear_left_shank_link, x
    const Scalar z319 = z305 - n0_0002 * z310;  // moment on rear_right_hip_link, y
    const Scalar z320 = z125 - z213;
    const Scalar z321 = s_rear_right_knee * z287 - c_rear_right_knee * z292;
    const Scalar z322 = c_rear_right_knee * z287 + s_rear_right_knee * z292;
    const Scalar z323 = z135 + z217;
    const Scalar z324 = n0_124 * z266 - k15 * z267 - n0_2 * z293 - z321;  // moment on rear_right_thigh_link, x
    const Scalar z325 = z322 - n0_0002 * z268;  // moment on rear_right_thigh_link, z
    const Scalar z326 = n0_124 * z267 + z293;  // force on rear_right_thigh_link, y
    const Scalar z327 = k10 * z125 - k11 * z213 - n0_032 * z244;  // moment on front_right_shank_link, y
    const Scalar z328 = n0_1048 * z89 - z326;  // force on rear_right_hip_link, y
    const Scalar z329 = n0_032 * z320;  // force on front_right_shank_link, x
    const Scalar z330 = k7 * z323;  // moment on front_right_shank_link, z
    const Scalar z331 = n0_032 * z222 - k8 * z309;  // moment on front_right_shank_link, x
    const Scalar z332 = n0_032 * z309;  // force on front_right_shank_link, y
    const Scalar z333 = s_rear_left_knee * z318 - c_rear_left_knee * z124;
    const Scalar z334 = s_rear_left_knee * z124 + c_rear_left_knee * z318;
    // moment on rear_left_thigh_link, y
    const Scalar z335 = k12 * z126 + k13 * z272 + n0_124 * z242 - n0_2 * z334 - z316;
    const Scalar z336 = n0_124 * z114 - z333;  // force on rear_left_thigh_link, z
    const Scalar z337 = n0_124 * z296 - z334;  // force on rear_left_thigh_link, x
    const Scalar z338 = s_rear_left_knee * z313 + c_rear_left_knee * z314;
    const Scalar z339 = s_rear_left_knee * z314 - c_rear_left_knee * z313;
    const Scalar z340 = n0_124 * z231 + k15 * z251 + n0_2 * z315 + z338;  // moment on rear_left_thigh_link, x
    const Scalar z341 = z339 + n0_0002 * z311;  // moment on rear_left_thigh_link, z
    const Scalar z342 = n0_124 * z251 + z315;  // force on rear_left_thigh_link, y
    const Scalar z343 = n0_1048 * z94 + z342;  // force on rear_left_hip_link, y
    const Scalar z344 = z335 - n0_0002 * z312;  // moment on rear_left_hip_link, y
    const Scalar z345 = s_front_right_knee * z329 - c_front_right_knee * z136;
    const Scalar z346 = s_front_right_knee * z136 + c_front_right_knee * z329;
    const Scalar z347 = s_rear_right_thigh * z301 - c_rear_right_thigh * z303;
    const Scalar z348 = s_rear_right_thigh * z303 + c_rear_right_thigh * z301;
    const Scalar z349 = z140 + z208;
    const Scalar z350 = n0_1048 * z269 + z348;  // force on rear_right_hip_link, z
    const Scalar z351 = s_rear_right_thigh * z324 + c_rear_right_thigh * z325;
    const Scalar z352 = n0_1048 * z250 - k17 * z258 + n0_08 * z347 - z351;  // moment on rear_right_hip_link, z
    const Scalar z353 = n0_1048 * z258 - z347;  // force on rear_right_hip_link, x
    const Scalar z354 = s_rear_right_thigh * z325 - c_rear_right_thigh * z324;
    // moment on rear_right_hip_link, x
    const Scalar z355 = k18 * z85 - n0_1048 * z262 - k19 * z255 + n0_08 * z348 + z354;
    // moment on front_right_thigh_link, y
    const Scalar z356 = k12 * z138 + k13 * z211 - n0_124 * z221 - n0_2 * z346 - z327;
    const Scalar z357 = n0_124 * z133 - z345;  // force on front_right_thigh_link, z
    const Scalar z358 = n0_124 * z228 - z346;  // force on front_right_thigh_link, x
    const Scalar z359 = s_rear_left_thigh * z336 - c_rear_left_thigh * z337;
    const Scalar z360 = s_rear_left_thigh * z337 + c_rear_left_thigh * z336;
    const Scalar z361 = n0_1048 * z235 - z360;  // force on rear_left_hip_link, z
    const Scalar z362 = s_front_right_knee * z330 - c_front_right_knee * z331;
    const Scalar z363 = c_front_right_knee * z330 + s_front_right_knee * z331;
    const Scalar z364 = n0_124 * z197 - k15 * z210 - n0_2 * z332 - z362;  // moment on front_right_thigh_link, x
    const Scalar z365 = n0_124 * z210 + z332;  // force on front_right_thigh_link, y
    const Scalar z366 = z363 - n0_0002 * z349;  // moment on front_right_thigh_link, z
    const Scalar z367 = s_rear_left_thigh * z340 + c_rear_left_thigh * z341;
    const Scalar z368 = n0_1048 * z209 + k17 * z227 + n0_08 * z359 - z367;  // moment on rear_left_hip_link, z
    const Scalar z369 = n0_1048 * z227 + z359;  // force on rear_left_hip_link, x
    const Scalar z370 = s_rear_left_thigh * z341 - c_rear_left_thigh * z340;
    // moment on rear_left_hip_link, x
    const Scalar z371 = k18 * z86 - n0_1048 * z203 - k19 * z199 - n0_08 * z360 - z370;
    const Scalar z372 = s_front_right_thigh * z357 - c_front_right_thigh * z358;
    const Scalar z373 = s_front_right_thigh * z358 + c_front_right_thigh * z357;
    const Scalar z374 = s_rear_right_hip * z319 + c_rear_right_hip * z352;
    const Scalar z375 = s_rear_right_hip * z352 - c_rear_right_hip * z319;
    const Scalar z376 = s_rear_right_hip * z328 + c_rear_right_hip * z350;
    const Scalar z377 = s_rear_right_hip * z350 - c_rear_right_hip * z328;
    const Scalar z378 = z194 + z193;
    const Scalar z379 = z195 + z196;
    const Scalar z380 = z141 + z158;
    const Scalar z381 = n0_1048 * z121 - z365;  // force on front_right_hip_link, y
    const Scalar z382 = z144 + z173;
    const Scalar z383 = k7 * z378;  // moment on front_left_shank_link, z
    const Scalar z384 = n0_032 * z240 + k8 * z379;  // moment on front_left_shank_link, x
    const Scalar z385 = n0_032 * z379;  // force on front_left_shank_link, y
    const Scalar z386 = k10 * z178 - k11 * z180 - n0_032 * z247;  // moment on front_left_shank_link, y
    const Scalar z387 = z178 - z180;
    const Scalar z388 = n0_032 * z387;  // force on front_left_shank_link, x
    const Scalar z389 = n0_1048 * z212 + z373;  // force on front_right_hip_link, z
    const Scalar z390 = z356 - n0_0002 * z380;  // moment on front_right_hip_link, y
    const Scalar z391 = s_front_left_knee * z383 + c_front_left_knee * z384;
    const Scalar z392 = s_front_left_knee * z384 - c_front_left_knee * z383;
    const Scalar z393 = n0_124 * z183 + k15 * z175 + n0_2 * z385 + z391;  // moment on front_left_thigh_link, x
    const Scalar z394 = n0_124 * z175 + z385;  // force on front_left_thigh_link, y
    const Scalar z395 = z392 + n0_0002 * z382;  // moment on front_left_thigh_link, z
    const Scalar z396 = s_front_left_knee * z388 - c_front_left_knee * z190;
    const Scalar z397 = s_front_left_knee * z190 + c_front_left_knee * z388;
    // moment on front_left_thigh_link, y
    const Scalar z398 = k12 * z139 + k13 * z176 + n0_124 * z229 - n0_2 * z397 - z386;
    const Scalar z399 = n0_124 * z143 - z396;  // force on front_left_thigh_link, z
    const Scalar z400 = n0_124 * z237 - z397;  // force on front_left_thigh_link, x
    const Scalar z401 = s_front_left_thigh * z399 - c_front_left_thigh * z400;
    const Scalar z402 = s_front_left_thigh * z400 + c_front_left_thigh * z399;
    const Scalar z403 = n0_1048 * z179 - z372;  // force on front_right_hip_link, x
    const Scalar z404 = c_rear_left_hip * z344 + s_rear_left_hip * z368;
    const Scalar z405 = s_rear_left_hip * z344 - c_rear_left_hip * z368;
    const Scalar z406 = s_front_right_thigh * z364 + c_front_right_thigh * z366;
    const Scalar z407 = n0_1048 * z177 + k17 * z179 - n0_08 * z372 + z406;  // moment on front_right_hip_link, z
    const Scalar z408 = s_front_right_thigh * z366 - c_front_right_thigh * z364;
    // moment on front_right_hip_link, x
    const Scalar z409 = k18 * z106 - n0_1048 * z168 - k19 * z156 + n0_08 * z373 + z408;
    const Scalar z410 = s_rear_left_hip * z343 + c_rear_left_hip * z361;
    const Scalar z411 = s_rear_left_hip * z361 - c_rear_left_hip * z343;
    const Scalar z412 = z44 - z386;
    const Scalar z413 = z46 + z356;
    const Scalar z414 = z47 - z327;
    const Scalar z415 = z49 + z335;
    const Scalar z416 = z50 - z316;
    const Scalar z417 = z52 + z305;
    const Scalar z418 = z53 - z302;
    const Scalar z419 = n0_1048 * z73 + z394;  // force on front_left_hip_link, y
    const Scalar z420 = z145 + z164;
    const Scalar z421 = z43 + z398;
    const Scalar z422 = z398 - n0_0002 * z420;  // moment on front_left_hip_link, y
    const Scalar z423 = z45 - z409;
    const Scalar z424 = z48 - z371;
    const Scalar z425 = z51 - z355;
    const Scalar z426 = n0_1048 * z184 - z402;  // force on front_left_hip_link, z
    const Scalar z427 = n0_1048 * z165 + z401;  // force on front_left_hip_link, x
    const Scalar z428 = n12_24 * z149 - z353 + z369 - z403 + z427;  // force on trunk, x
    const Scalar z429 = s_front_right_hip * z381 + c_front_right_hip * z389;
    const Scalar z430 = s_front_right_hip * z389 - c_front_right_hip * z381;
    const Scalar z431 = s_front_left_thigh * z393 + c_front_left_thigh * z395;
    const Scalar z432 = n0_1048 * z188 - k17 * z165 - n0_08 * z401 + z431;  // moment on front_left_hip_link, z
    const Scalar z433 = s_front_left_thigh * z395 - c_front_left_thigh * z393;
    // moment on front_left_hip_link, x
    const Scalar z434 = k18 * z68 - n0_1048 * z181 - k19 * z162 - n0_08 * z402 - z433;
    const Scalar z435 = z42 - z434;
    const Scalar z436 = c_front_right_hip * z390 + s_front_right_hip * z407;
    const Scalar z437 = s_front_right_hip * z390 - c_front_right_hip * z407;
    const Scalar z438 = s_front_left_hip * z419 + c_front_left_hip * z426;
    // moment on trunk, x
    const Scalar z439 = n0_0406 * a_trunk_attitude_omega_x - z355 + n0_0306 * z29 - z409 - z371 - z434 - n0_05 * (z376
        + z410 + z429 + z438);
    const Scalar z440 = s_front_left_hip * z426 - c_front_left_hip * z419;
    const Scalar z441 = n12_24 * z148 + z376 - z410 + z429 - z438;  // force on trunk, z
    const Scalar z442 = n12_24 * z147 - z377 + z411 - z430 + z440;  // force on trunk, y
    const Scalar z443 = z21 * z428 + z13 * z441 + z10 * z442;
    const Scalar z444 = z16 * z428 + z17 * z441 + z15 * z442;
    const Scalar z445 = z19 * z428 + z20 * z441 + z18 * z442;
    const Scalar z446 = s_front_left_hip * z422 + c_front_left_hip * z432;
    // moment on trunk, z
    const Scalar z447 = z374 + n0_366 * a_trunk_attitude_omega_z + n0_2948 * z28 - n0_05 * (z353 + z369 + z403 + z427)
        + z405 + z437 + z446 + n0_2 * (z377 - z411 - z430 + z440);
    const Scalar z448 = s_front_left_hip * z432 - c_front_left_hip * z422;
    // moment on trunk, y
    const Scalar z449 = z404 + n0_3354 * a_trunk_attitude_omega_y - n0_3254 * z24 + z436 + n0_2 * (z376 - z410 - z429
        + z438) - z375 - z448;
    forces.trunk_x = z443;
    forces.trunk_y = z444;
    forces.trunk_z = z445;
    forces.trunk_attitude_omega_x = z439;
    forces.trunk_attitude_omega_y = z449;
    forces.trunk_attitude_omega_z = z447;
    forces.front_left_hip = z435;
    forces.front_left_thigh = z421;
    forces.front_left_knee = z412;
    forces.front_right_hip = z423;
    forces.front_right_thigh = z413;
    forces.front_right_knee = z414;
    forces.rear_left_hip = z424;
    forces.rear_left_thigh = z415;
    forces.rear_left_knee = z416;
    forces.rear_right_hip = z425;
    forces.rear_right_thigh = z417;
    forces.rear_right_knee = z418;
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
    const Scalar z0 = k0 * s_rear_right_knee;
    const Scalar z1 = n0_032 * c_rear_right_knee;
    const Scalar z2 = n0_032 * s_rear_right_knee;
    const Scalar z3 = n2 * q_trunk_attitude_y;
    const Scalar z4 = k0 * c_rear_right_knee;
    const Scalar z5 = n2 * q_trunk_attitude_x;
    const Scalar z6 = q_trunk_attitude_y * z3;
    const Scalar z7 = q_trunk_attitude_z * z3;
    const Scalar z8 = q_trunk_attitude_w * z5;
    const Scalar z9 = n2 * q_trunk_attitude_z;
    const Scalar z10 = q_trunk_attitude_x * z5;
    const Scalar z11 = q_trunk_attitude_x * z9;
    const Scalar z12 = z7 + z8;
    const Scalar z13 = q_trunk_attitude_w * z3;
    const Scalar z14 = n1 - z6 - z10;
    const Scalar z15 = z11 - z13;
    const Scalar z16 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z17 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z18 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z19 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z20 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z21 = z7 - z8;
    const Scalar z22 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z23 = z11 + z13;
    const Scalar z24 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z25 = q_trunk_attitude_x * z3;
    const Scalar z26 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z27 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z28 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z29 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z30 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z31 = q_trunk_attitude_z * z9;
    const Scalar z32 = q_trunk_attitude_w * z9;
    const Scalar z33 = n1 - z31 - z10;
    const Scalar z34 = n1 - z6 - z31;
    const Scalar z35 = z25 + z32;
    const Scalar z36 = z25 - z32;
    const Scalar z37 = k0 * s_rear_left_knee;
    const Scalar z38 = k0 * c_rear_left_knee;
    const Scalar z39 = n0_032 * c_rear_left_knee;
    const Scalar z40 = n0_032 * s_rear_left_knee;
    const Scalar z41 = c_rear_right_knee * z4;
    const Scalar z42 = s_rear_right_knee * z0;
    const Scalar z43 = s_rear_right_knee * z4;
    const Scalar z44 = n0_124 + z1;
    const Scalar z45 = c_rear_left_knee * z38;
    const Scalar z46 = s_rear_left_knee * z37;
    const Scalar z47 = s_rear_left_knee * z38;
    const Scalar z48 = n0_4 * z1 - z42;
    const Scalar z49 = n0_2 * z2 + z43;
    const Scalar z50 = k7 + z41;
    const Scalar z51 = s_rear_right_thigh * z2 - c_rear_right_thigh * z44;
    const Scalar z52 = c_rear_right_thigh * z2 + s_rear_right_thigh * z44;
    const Scalar z53 = c_front_left_thigh * z27 + s_front_left_thigh * z30;
    const Scalar z54 = n0_4 * z39 - z46;
    const Scalar z55 = s_front_left_thigh * z27 - c_front_left_thigh * z30;
    const Scalar z56 = n0_2 * z40 + z47;
    const Scalar z57 = v_front_left_thigh + z26;
    const Scalar z58 = n0_124 + z39;
    const Scalar z59 = c_front_right_thigh * z24 + s_front_right_thigh * z29;
    const Scalar z60 = s_front_right_thigh * z24 - c_front_right_thigh * z29;
    const Scalar z61 = v_front_right_thigh + z22;
    const Scalar z62 = c_rear_left_thigh * z19 + s_rear_left_thigh * z28;
    const Scalar z63 = s_rear_left_thigh * z19 - c_rear_left_thigh * z28;
    const Scalar z64 = v_rear_left_thigh + z18;
    const Scalar z65 = c_rear_right_thigh * z17 + s_rear_right_thigh * z20;
    const Scalar z66 = v_rear_right_thigh + z16;
    const Scalar z67 = s_rear_right_thigh * z17 - c_rear_right_thigh * z20;
    const Scalar z68 = z48 + z50;
    const Scalar z69 = n2 * z49;
    const Scalar z70 = s_rear_right_knee * z67 - c_rear_right_knee * z65;
    const Scalar z71 = s_rear_right_thigh * z68 + c_rear_right_thigh * z69;
    const Scalar z72 = s_rear_right_knee * z65 + c_rear_right_knee * z67;
    const Scalar z73 = s_rear_left_knee * z63 - c_rear_left_knee * z62;
    const Scalar z74 = s_rear_left_knee * z62 + c_rear_left_knee * z63;
    const Scalar z75 = v_rear_right_knee + z66;
    const Scalar z76 = s_front_right_knee * z60 - c_front_right_knee * z59;
    const Scalar z77 = c_rear_right_thigh * z71 - z49;
    const Scalar z78 = s_rear_right_thigh * z71;
    const Scalar z79 = s_front_right_knee * z59 + c_front_right_knee * z60;
    const Scalar z80 = z48 - z78;
    const Scalar z81 = z50 - z78;
    const Scalar z82 = v_rear_left_knee + z64;
    const Scalar z83 = s_front_left_knee * z55 - c_front_left_knee * z53;
    const Scalar z84 = k7 + z45;
    const Scalar z85 = s_front_left_knee * z53 + c_front_left_knee * z55;
    const Scalar z86 = s_rear_left_thigh * z40 - c_rear_left_thigh * z58;
    const Scalar z87 = v_front_right_knee + z61;
    const Scalar z88 = v_front_left_knee + z57;
    const Scalar z89 = c_rear_left_thigh * z40 + s_rear_left_thigh * z58;
    const Scalar z90 = k0 * s_front_right_knee;
    const Scalar z91 = s_front_right_knee * z90;
    const Scalar z92 = k0 * c_front_right_knee;
    const Scalar z93 = k0 * s_front_left_knee;
    const Scalar z94 = s_front_left_knee * z93;
    const Scalar z95 = n0_032 * c_front_right_knee;
    const Scalar z96 = k0 * c_front_left_knee;
    const Scalar z97 = n0_4 * z95 - z91;
    const Scalar z98 = n0_124 + z95;
    const Scalar z99 = c_front_right_knee * z92;
    const Scalar z100 = s_front_right_knee * z92;
    const Scalar z101 = k7 + z99;
    const Scalar z102 = n0_032 * c_front_left_knee;
    const Scalar z103 = n0_4 * z102 - z94;
    const Scalar z104 = n0_124 + z102;
    const Scalar z105 = z54 + z84;
    const Scalar z106 = n0_032 * s_front_right_knee;
    const Scalar z107 = n0_2 * z106 + z100;
    const Scalar z108 = c_front_left_knee * z96;
    const Scalar z109 = s_front_left_knee * z96;
    const Scalar z110 = k7 + z108;
    const Scalar z111 = n0_032 * s_front_left_knee;
    const Scalar z112 = n0_2 * z111 + z109;
    const Scalar z113 = n2 * z56;
    const Scalar z114 = s_rear_left_thigh * z105 + c_rear_left_thigh * z113;
    const Scalar z115 = z97 + z101;
    const Scalar z116 = z103 + z110;
    const Scalar z117 = n2 * z107;
    const Scalar z118 = s_front_right_thigh * z115 + c_front_right_thigh * z117;
    const Scalar z119 = c_rear_left_thigh * z114 - z56;
    const Scalar z120 = s_rear_left_thigh * z114;
    const Scalar z121 = n2 * z112;
    const Scalar z122 = s_front_left_thigh * z116 + c_front_left_thigh * z121;
    const Scalar z123 = z54 - z120;
    const Scalar z124 = z84 - z120;
    const Scalar z125 = c_front_right_thigh * z118 - z107;
    const Scalar z126 = s_front_right_thigh * z118;
    const Scalar z127 = c_front_left_thigh * z122 - z112;
    const Scalar z128 = s_front_left_thigh * z122;
    const Scalar z129 = z97 - z126;
    const Scalar z130 = z101 - z126;
    const Scalar z131 = s_front_right_thigh * z106 - c_front_right_thigh * z98;
    const Scalar z132 = c_front_right_thigh * z106 + s_front_right_thigh * z98;
    const Scalar z133 = z103 - z128;
    const Scalar z134 = z110 - z128;
    const Scalar z135 = s_front_left_thigh * z111 - c_front_left_thigh * z104;
    const Scalar z136 = c_front_left_thigh * z111 + s_front_left_thigh * z104;
    const Scalar z137 = n9_81 * z12;
    const Scalar z138 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z139 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z140 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z141 = z139 + z140;
    const Scalar z142 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z143 = z140 + z142;
    const Scalar z144 = n9_81 * z14;
    const Scalar z145 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z146 = n9_81 * z15;
    const Scalar z147 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z148 = z144 + n0_2 * z145 - n0_05 * z147;
    const Scalar z149 = z137 + n0_2 * z138 + n0_05 * z143;
    const Scalar z150 = z137 + n0_2 * z138 - n0_05 * z143;
    const Scalar z151 = v_front_left_hip * z26;  // angular acceleration of front_left_hip_link, z
    const Scalar z152 = z26 * z27;
    const Scalar z153 = z151 + z152;
    const Scalar z154 = z26 * z30;
    const Scalar z155 = z146 - n0_2 * z141 - n0_05 * z138;
    const Scalar z156 = z144 + n0_2 * z145 + n0_05 * z147;
    const Scalar z157 = z146 - n0_2 * z141 + n0_05 * z138;
    const Scalar z158 = s_front_left_hip * z150 - c_front_left_hip * z156;
    const Scalar z159 = s_front_left_hip * z156 + c_front_left_hip * z150;
    const Scalar z160 = z157 + n0_08 * z153;
    const Scalar z161 = z158 + n0_08 * z154;
    const Scalar z162 = s_front_left_thigh * z151;
    const Scalar z163 = c_front_left_thigh * z151;
    const Scalar z164 = v_front_left_thigh * z55 - z162;  // angular acceleration of front_left_thigh_link, x
    const Scalar z165 = v_front_left_thigh * z53 - z163;  // angular acceleration of front_left_thigh_link, z
    const Scalar z166 = z53 * z53;
    const Scalar z167 = z57 * z57;
    const Scalar z168 = z166 + z167;
    const Scalar z169 = s_front_left_thigh * z160 - c_front_left_thigh * z161;
    const Scalar z170 = s_front_left_thigh * z161 + c_front_left_thigh * z160;
    const Scalar z171 = z169 + n0_2 * z168;
    const Scalar z172 = n0_05 * v_rear_right_knee;
    const Scalar z173 = z30 * z30;
    const Scalar z174 = z27 * z27;
    const Scalar z175 = z173 + z174;
    const Scalar z176 = z53 * z55;
    const Scalar z177 = z55 * z57;
    const Scalar z178 = z164 + z177;
    const Scalar z179 = n0_05 * v_rear_left_knee;
    const Scalar z180 = s_front_left_knee * z164 - c_front_left_knee * z165;
    const Scalar z181 = z159 - n0_08 * z175;
    const Scalar z182 = s_front_left_knee * z165 + c_front_left_knee * z164;
    const Scalar z183 = v_front_left_knee * z83 + z180;  // angular acceleration of front_left_shank_link, z
    const Scalar z184 = v_front_left_knee * z85 + z182;  // angular acceleration of front_left_shank_link, x
    const Scalar z185 = n0_05 * v_front_right_knee;
    const Scalar z186 = n0_05 * v_front_left_knee;
    const Scalar z187 = z181 - n0_2 * z178;
    const Scalar z188 = n0_05 * v_rear_right_thigh;
    const Scalar z189 = n0_05 * v_rear_left_thigh;
    const Scalar z190 = n0_05 * v_front_right_thigh;
    const Scalar z191 = n0_05 * v_front_left_thigh;
    const Scalar z192 = n0_05 * v_rear_right_hip;
    const Scalar z193 = n0_05 * v_rear_left_hip;
    const Scalar z194 = n0_05 * v_front_right_hip;
    const Scalar z195 = n0_05 * v_front_left_hip;
    const Scalar z196 = v_front_right_hip * z22;  // angular acceleration of front_right_hip_link, z
    const Scalar z197 = z22 * z24;
    const Scalar z198 = z196 + z197;
    const Scalar z199 = z22 * z29;
    const Scalar z200 = s_front_right_hip * z149 - c_front_right_hip * z148;
    const Scalar z201 = s_front_right_hip * z148 + c_front_right_hip * z149;
    const Scalar z202 = z155 - n0_08 * z198;
    const Scalar z203 = z200 - n0_08 * z199;
    const Scalar z204 = s_front_right_thigh * z196;
    const Scalar z205 = c_front_right_thigh * z196;
    const Scalar z206 = v_front_right_thigh * z60 - z204;  // angular acceleration of front_right_thigh_link, x
    const Scalar z207 = v_front_right_thigh * z59 - z205;  // angular acceleration of front_right_thigh_link, z
    const Scalar z208 = z59 * z59;
    const Scalar z209 = z61 * z61;
    const Scalar z210 = z208 + z209;
    const Scalar z211 = s_front_right_thigh * z202 - c_front_right_thigh * z203;
    const Scalar z212 = s_front_right_thigh * z203 + c_front_right_thigh * z202;
    const Scalar z213 = z29 * z29;
    const Scalar z214 = z24 * z24;
    const Scalar z215 = z213 + z214;
    const Scalar z216 = z59 * z60;
    const Scalar z217 = z60 * z61;
    const Scalar z218 = z206 + z217;
    const Scalar z219 = s_front_right_knee * z206 - c_front_right_knee * z207;
    const Scalar z220 = z201 + n0_08 * z215;
    const Scalar z221 = s_front_right_knee * z207 + c_front_right_knee * z206;
    const Scalar z222 = v_front_right_hip * z29;  // angular acceleration of front_right_hip_link, y
    const Scalar z223 = v_front_left_hip * z30;  // angular acceleration of front_left_hip_link, y
    const Scalar z224 = z211 + n0_2 * z210;
    const Scalar z225 = v_front_right_knee * z76 + z219;  // angular acceleration of front_right_shank_link, z
    const Scalar z226 = v_front_right_knee * z79 + z221;  // angular acceleration of front_right_shank_link, x
    const Scalar z227 = z137 - n0_2 * z138 + n0_05 * z143;
    const Scalar z228 = z137 - n0_2 * z138 - n0_05 * z143;
    const Scalar z229 = v_rear_right_hip * z16;  // angular acceleration of rear_right_hip_link, z
    const Scalar z230 = z16 * z17;
    const Scalar z231 = z229 + z230;
    const Scalar z232 = z16 * z20;
    const Scalar z233 = z144 - n0_2 * z145 - n0_05 * z147;
    const Scalar z234 = z146 + n0_2 * z141 - n0_05 * z138;
    const Scalar z235 = z146 + n0_2 * z141 + n0_05 * z138;
    const Scalar z236 = v_rear_left_hip * z18;  // angular acceleration of rear_left_hip_link, z
    const Scalar z237 = z18 * z19;
    const Scalar z238 = z236 + z237;
    const Scalar z239 = z18 * z28;
    const Scalar z240 = z144 - n0_2 * z145 + n0_05 * z147;
    const Scalar z241 = s_rear_right_hip * z227 - c_rear_right_hip * z233;
    const Scalar z242 = s_rear_right_hip * z233 + c_rear_right_hip * z227;
    const Scalar z243 = z234 - n0_08 * z231;
    const Scalar z244 = s_rear_left_hip * z228 - c_rear_left_hip * z240;
    const Scalar z245 = s_rear_left_hip * z240 + c_rear_left_hip * z228;
    const Scalar z246 = z241 - n0_08 * z232;
    const Scalar z247 = z235 + n0_08 * z238;
    const Scalar z248 = s_rear_right_thigh * z229;
    const Scalar z249 = c_rear_right_thigh * z229;
    const Scalar z250 = v_rear_right_thigh * z67 - z248;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z251 = v_rear_right_thigh * z65 - z249;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z252 = z244 + n0_08 * z239;
    const Scalar z253 = s_rear_right_thigh * z243 - c_rear_right_thigh * z246;
    const Scalar z254 = s_rear_right_thigh * z246 + c_rear_right_thigh * z243;
    const Scalar z255 = s_rear_left_thigh * z236;
    const Scalar z256 = c_rear_left_thigh * z236;
    const Scalar z257 = v_rear_left_thigh * z63 - z255;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z258 = v_rear_left_thigh * z62 - z256;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z259 = z62 * z62;
    const Scalar z260 = z64 * z64;
    const Scalar z261 = z259 + z260;
    const Scalar z262 = z20 * z20;
    const Scalar z263 = z17 * z17;
    const Scalar z264 = z262 + z263;
    const Scalar z265 = s_rear_left_thigh * z247 - c_rear_left_thigh * z252;
    const Scalar z266 = s_rear_left_thigh * z252 + c_rear_left_thigh * z247;
    const Scalar z267 = z265 + n0_2 * z261;
    const Scalar z268 = z242 + n0_08 * z264;
    const Scalar z269 = z28 * z28;
    const Scalar z270 = z19 * z19;
    const Scalar z271 = z269 + z270;
    const Scalar z272 = z62 * z63;
    const Scalar z273 = z63 * z64;
    const Scalar z274 = z257 + z273;
    const Scalar z275 = s_rear_left_knee * z257 - c_rear_left_knee * z258;
    const Scalar z276 = z245 - n0_08 * z271;
    const Scalar z277 = s_rear_left_knee * z258 + c_rear_left_knee * z257;
    const Scalar z278 = v_rear_left_knee * z73 + z275;  // angular acceleration of rear_left_shank_link, z
    const Scalar z279 = v_rear_left_knee * z74 + z277;  // angular acceleration of rear_left_shank_link, x
    const Scalar z280 = z276 - n0_2 * z274;
    const Scalar z281 = z220 - n0_2 * z218;
    const Scalar z282 = z65 * z65;
    const Scalar z283 = z66 * z66;
    const Scalar z284 = z282 + z283;
    const Scalar z285 = z65 * z67;
    const Scalar z286 = z67 * z66;
    const Scalar z287 = z250 + z286;
    const Scalar z288 = s_rear_right_knee * z250 - c_rear_right_knee * z251;
    const Scalar z289 = s_rear_right_knee * z251 + c_rear_right_knee * z250;
    const Scalar z290 = z268 - n0_2 * z287;
    const Scalar z291 = v_rear_right_hip * z20;  // angular acceleration of rear_right_hip_link, y
    const Scalar z292 = v_rear_left_hip * z28;  // angular acceleration of rear_left_hip_link, y
    const Scalar z293 = z65 * z66;
    const Scalar z294 = z251 + z293;
    const Scalar z295 = z62 * z64;
    const Scalar z296 = z258 + z295;
    const Scalar z297 = z20 * z17;
    const Scalar z298 = z28 * z19;
    const Scalar z299 = z253 + n0_2 * z284;
    const Scalar z300 = v_rear_right_knee * z70 + z288;  // angular acceleration of rear_right_shank_link, z
    const Scalar z301 = v_rear_right_knee * z72 + z289;  // angular acceleration of rear_right_shank_link, x
    const Scalar z302 = z291 + z297;
    const Scalar z303 = z292 + z298;
    const Scalar z304 = z70 * z72;
    const Scalar z305 = z72 * z75;
    const Scalar z306 = z301 + z305;
    const Scalar z307 = z59 * z61;
    const Scalar z308 = z70 * z75;
    const Scalar z309 = z300 + z308;
    const Scalar z310 = z70 * z70;
    const Scalar z311 = z207 + z307;
    const Scalar z312 = z75 * z75;
    const Scalar z313 = z310 + z312;
    const Scalar z314 = n0_032 * z290 - k11 * z306;  // moment on rear_right_shank_link, x
    const Scalar z315 = k12 * z309;  // moment on rear_right_shank_link, z
    const Scalar z316 = n0_032 * z306;  // force on rear_right_shank_link, y
    const Scalar z317 = n0_032 * z313;  // force on rear_right_shank_link, z
    const Scalar z318 = z29 * z24;
    const Scalar z319 = z222 + z318;
    const Scalar z320 = z73 * z74;
    const Scalar z321 = z74 * z82;
    const Scalar z322 = z279 + z321;
    const Scalar z323 = z76 * z79;
    const Scalar z324 = z79 * z87;
    const Scalar z325 = z226 + z324;
    const Scalar z326 = z73 * z82;
    const Scalar z327 = z278 + z326;
    const Scalar z328 = z73 * z73;
    const Scalar z329 = z82 * z82;
    const Scalar z330 = z328 + z329;
    const Scalar z331 = n0_032 * z280 - k11 * z322;  // moment on rear_left_shank_link, x
    const Scalar z332 = k12 * z327;  // moment on rear_left_shank_link, z
    const Scalar z333 = n0_032 * z281 - k11 * z325;  // moment on front_right_shank_link, x
    const Scalar z334 = n0_032 * z330;  // force on rear_left_shank_link, z
    const Scalar z335 = n0_032 * z322;  // force on rear_left_shank_link, y
    const Scalar z336 = n0_032 * z325;  // force on front_right_shank_link, y
    const Scalar z337 = z76 * z87;
    const Scalar z338 = z225 + z337;
    const Scalar z339 = z76 * z76;
    const Scalar z340 = z87 * z87;
    const Scalar z341 = z339 + z340;
    const Scalar z342 = c_rear_right_knee * z315 + s_rear_right_knee * z314;
    const Scalar z343 = s_rear_right_knee * z315 - c_rear_right_knee * z314;
    const Scalar z344 = z342 - n0_0002 * z294;  // moment on rear_right_thigh_link, z
    const Scalar z345 = n0_124 * z268 - k14 * z287 - n0_2 * z316 - z343;  // moment on rear_right_thigh_link, x
    const Scalar z346 = n0_124 * z287 + z316;  // force on rear_right_thigh_link, y
    const Scalar z347 = n0_1048 * z264 - z346;  // force on rear_right_hip_link, y
    const Scalar z348 = k12 * z338;  // moment on front_right_shank_link, z
    const Scalar z349 = n0_032 * z341;  // force on front_right_shank_link, z
    const Scalar z350 = z83 * z85;
    const Scalar z351 = z85 * z88;
    const Scalar z352 = z184 + z351;
    const Scalar z353 = z83 * z88;
    const Scalar z354 = z83 * z83;
    const Scalar z355 = z88 * z88;
    const Scalar z356 = z354 + z355;
    const Scalar z357 = c_rear_left_knee * z332 + s_rear_left_knee * z331;
    const Scalar z358 = s_rear_left_knee * z332 - c_rear_left_knee * z331;
    const Scalar z359 = z357 - n0_0002 * z296;  // moment on rear_left_thigh_link, z
    const Scalar z360 = n0_124 * z276 - k14 * z274 - n0_2 * z335 - z358;  // moment on rear_left_thigh_link, x
    const Scalar z361 = n0_124 * z274 + z335;  // force on rear_left_thigh_link, y
    const Scalar z362 = n0_1048 * z271 + z361;  // force on rear_left_hip_link, y
    const Scalar z363 = c_front_right_knee * z348 + s_front_right_knee * z333;
    const Scalar z364 = s_front_right_knee * z348 - c_front_right_knee * z333;
    const Scalar z365 = z363 - n0_0002 * z311;  // moment on front_right_thigh_link, z
    const Scalar z366 = n0_124 * z220 - k14 * z218 - n0_2 * z336 - z364;  // moment on front_right_thigh_link, x
    const Scalar z367 = n0_124 * z218 + z336;  // force on front_right_thigh_link, y
    const Scalar z368 = n0_1048 * z215 - z367;  // force on front_right_hip_link, y
    const Scalar z369 = s_rear_right_thigh * z344 - c_rear_right_thigh * z345;
    const Scalar z370 = z183 + z353;
    const Scalar z371 = s_rear_right_thigh * z345 + c_rear_right_thigh * z344;
    const Scalar z372 = z53 * z57;
    const Scalar z373 = z165 + z372;
    const Scalar z374 = z30 * z27;
    const Scalar z375 = u_front_right_knee_torque - z185;
    const Scalar z376 = u_front_left_knee_torque - z186;
    const Scalar z377 = k12 * z370;  // moment on front_left_shank_link, z
    const Scalar z378 = n0_032 * z356;  // force on front_left_shank_link, z
    const Scalar z379 = n0_032 * z187 - k11 * z352;  // moment on front_left_shank_link, x
    const Scalar z380 = n0_032 * z352;  // force on front_left_shank_link, y
    const Scalar z381 = u_front_right_thigh_torque - z190;
    const Scalar z382 = u_front_left_thigh_torque - z191;
    const Scalar z383 = u_rear_left_hip_torque - z193;
    const Scalar z384 = u_front_right_hip_torque - z194;
    const Scalar z385 = z223 + z374;
    const Scalar z386 = u_front_left_hip_torque - z195;
    const Scalar z387 = c_front_left_knee * z377 + s_front_left_knee * z379;
    const Scalar z388 = s_front_left_knee * z377 - c_front_left_knee * z379;
    const Scalar z389 = z387 - n0_0002 * z373;  // moment on front_left_thigh_link, z
    const Scalar z390 = n0_124 * z181 - k14 * z178 - n0_2 * z380 - z388;  // moment on front_left_thigh_link, x
    const Scalar z391 = n0_124 * z178 + z380;  // force on front_left_thigh_link, y
    const Scalar z392 = n0_1048 * z175 + z391;  // force on front_left_hip_link, y
    const Scalar z393 = s_rear_left_thigh * z359 - c_rear_left_thigh * z360;
    const Scalar z394 = s_rear_left_thigh * z360 + c_rear_left_thigh * z359;
    const Scalar z395 = u_rear_right_knee_torque - z172;
    const Scalar z396 = u_rear_left_knee_torque - z179;
    const Scalar z397 = u_rear_right_thigh_torque - z188;
    const Scalar z398 = u_rear_left_thigh_torque - z189;
    const Scalar z399 = u_rear_right_hip_torque - z192;
    const Scalar z400 = k16 * c_rear_right_knee;
    const Scalar z401 = c_rear_right_knee * z400;
    const Scalar z402 = s_rear_right_knee * z400;
    const Scalar z403 = k16 * s_rear_right_knee;
    const Scalar z404 = s_rear_right_knee * z403;
    const Scalar z405 = s_front_right_thigh * z365 - c_front_right_thigh * z366;
    const Scalar z406 = s_front_right_thigh * z366 + c_front_right_thigh * z365;
    const Scalar z407 = n0_2 * z401;
    const Scalar z408 = n0_2 * z402;
    const Scalar z409 = n0_2 * z407;
    const Scalar z410 = n0_124 - z407;
    const Scalar z411 = s_front_left_thigh * z389 - c_front_left_thigh * z390;
    const Scalar z412 = s_front_left_thigh * z390 + c_front_left_thigh * z389;
    const Scalar z413 = k17 - z409;
    const Scalar z414 = n1 / z413;
    const Scalar z415 = z410 * z414;
    const Scalar z416 = z408 * z414;
    const Scalar z417 = z401 + z410 * z415;
    const Scalar z418 = z402 - z410 * z416;
    const Scalar z419 = z404 + z408 * z416;
    const Scalar z420 = z417 - z419;
    const Scalar z421 = n2 * z418;
    const Scalar z422 = s_rear_right_thigh * z420 + c_rear_right_thigh * z421;
    const Scalar z423 = s_rear_right_thigh * z422;
    const Scalar z424 = c_rear_right_thigh * z422 - z418;
    const Scalar z425 = z419 + z423;
    const Scalar z426 = z417 - z423;
    const Scalar z427 = n0_08 * z424;
    const Scalar z428 = n0_08 * z425;
    const Scalar z429 = n0_08 * z426;
    const Scalar z430 = z77 + n0_08 * z427;
    const Scalar z431 = z80 - n0_08 * z428;
    const Scalar z432 = z81 + n0_08 * z429;
    const Scalar z433 = n0_1048 - z428;
    const Scalar z434 = n0_1048 - z429;
    const Scalar z435 = k18 + z431;
    const Scalar z436 = k16 * c_rear_left_knee;
    const Scalar z437 = k16 * s_rear_left_knee;
    const Scalar z438 = n1 / z435;
    const Scalar z439 = c_rear_left_knee * z436;
    const Scalar z440 = z430 * z438;
    const Scalar z441 = s_rear_left_knee * z437;
    const Scalar z442 = z427 * z438;
    const Scalar z443 = s_rear_left_knee * z436;
    const Scalar z444 = z51 * z438;
    const Scalar z445 = n0_2 * z439;
    const Scalar z446 = z433 * z438;
    const Scalar z447 = n0_2 * z443;
    const Scalar z448 = z426 + z427 * z442;
    const Scalar z449 = n0_2 * z445;
    const Scalar z450 = z427 * z444;
    const Scalar z451 = k17 - z449;
    const Scalar z452 = z51 * z444;
    const Scalar z453 = n0_124 - z445;
    const Scalar z454 = z427 * z440 - z434;
    const Scalar z455 = n1 / z451;
    const Scalar z456 = z424 - z427 * z446;
    const Scalar z457 = z453 * z455;
    const Scalar z458 = z51 * z440 + z52;
    const Scalar z459 = z447 * z455;
    const Scalar z460 = z51 * z446;
    const Scalar z461 = z439 + z453 * z457;
    const Scalar z462 = z427 - z433 * z440;
    const Scalar z463 = z443 - z453 * z459;
    const Scalar z464 = z430 * z440 + z432;
    const Scalar z465 = z441 + z447 * z459;
    const Scalar z466 = z425 + z433 * z446;
    const Scalar z467 = z461 - z465;
    const Scalar z468 = n2 * z460;
    const Scalar z469 = k19 - z464;
    const Scalar z470 = n2 * z463;
    const Scalar z471 = s_rear_right_hip * z454;
    const Scalar z472 = c_rear_right_hip * z454;
    const Scalar z473 = s_rear_right_hip * z462 + c_rear_right_hip * z458;
    const Scalar z474 = z452 - z466;
    const Scalar z475 = c_rear_right_hip * z450 + s_rear_right_hip * z456;
    const Scalar z476 = s_rear_right_hip * z450 - c_rear_right_hip * z456;
    const Scalar z477 = n12_24 - z448;
    const Scalar z478 = s_rear_right_hip * z469;
    const Scalar z479 = s_rear_left_thigh * z467 + c_rear_left_thigh * z470;
    const Scalar z480 = c_rear_right_hip * z468 + s_rear_right_hip * z474;
    const Scalar z481 = s_rear_right_hip * z478;
    const Scalar z482 = s_rear_left_thigh * z479;
    const Scalar z483 = c_rear_right_hip * z478;
    const Scalar z484 = n0_05 * z476;
    const Scalar z485 = z471 - n0_2 * z476;
    const Scalar z486 = n0_05 * z448 + z472 - n0_2 * z475;
    const Scalar z487 = s_rear_right_hip * z473;
    const Scalar z488 = c_rear_right_hip * z473 - z458;
    const Scalar z489 = c_rear_right_hip * z473;
    const Scalar z490 = k19 - z481;
    const Scalar z491 = z465 + z482;
    const Scalar z492 = z464 + z481;
    const Scalar z493 = c_rear_left_thigh * z479 - z463;
    const Scalar z494 = z461 - z482;
    const Scalar z495 = n0_08 * z491;
    const Scalar z496 = n0_08 * z493;
    const Scalar z497 = n0_08 * z494;
    const Scalar z498 = s_rear_right_hip * z480;
    const Scalar z499 = c_rear_right_hip * z480 - z460;
    const Scalar z500 = z462 - z487;
    const Scalar z501 = z119 + n0_08 * z496;
    const Scalar z502 = z123 - n0_08 * z495;
    const Scalar z503 = z124 + n0_08 * z497;
    const Scalar z504 = n0_1048 - z495;
    const Scalar z505 = n0_1048 - z497;
    const Scalar z506 = z452 - z498;
    const Scalar z507 = z466 + z498;
    const Scalar z508 = n0_05 * z499;
    const Scalar z509 = z487 - n0_2 * z499;
    const Scalar z510 = z500 + n0_2 * z499 - z484;
    const Scalar z511 = k18 + z502;
    const Scalar z512 = z489 + n0_05 * z475 - n0_2 * z506;
    const Scalar z513 = z483 - n0_05 * z485 - n0_2 * (z500 - z509);
    const Scalar z514 = z492 + n0_05 * (z472 + z486) - n0_2 * (z489 + z512);
    const Scalar z515 = n1 / z511;
    const Scalar z516 = n0_05 * (z500 - z484) + n0_2 * z508;
    const Scalar z517 = n12_24 - z506;
    const Scalar z518 = k21 - z514;
    const Scalar z519 = z488 + n0_2 * z507;
    const Scalar z520 = n0_2 * (z488 + z519) + z490;
    const Scalar z521 = n0_05 * z507;
    const Scalar z522 = n0_05 * z488 + n0_2 * z521;
    const Scalar z523 = n12_24 - z507;
    const Scalar z524 = z504 * z515;
    const Scalar z525 = z86 * z515;
    const Scalar z526 = z501 * z515;
    const Scalar z527 = z496 * z515;
    const Scalar z528 = n0_05 * z521;
    const Scalar z529 = z501 * z526 + z503;
    const Scalar z530 = z491 + z504 * z524;
    const Scalar z531 = z496 - z504 * z526;
    const Scalar z532 = z496 * z526 - z505;
    const Scalar z533 = z493 - z496 * z524;
    const Scalar z534 = z86 * z526 + z89;
    const Scalar z535 = z494 + z496 * z527;
    const Scalar z536 = z496 * z525;
    const Scalar z537 = k22 - z520;
    const Scalar z538 = n0_0406 - z528;
    const Scalar z539 = z86 * z525;
    const Scalar z540 = z86 * z524;
    const Scalar z541 = z477 - z535;
    const Scalar z542 = k16 * c_front_right_knee;
    const Scalar z543 = k16 * s_front_right_knee;
    const Scalar z544 = z539 - z530;
    const Scalar z545 = n2 * z540;
    const Scalar z546 = c_rear_left_hip * z532;
    const Scalar z547 = s_rear_left_hip * z544 - c_rear_left_hip * z545;
    const Scalar z548 = s_rear_left_hip * z532;
    const Scalar z549 = s_rear_left_hip * z531 - c_rear_left_hip * z534;
    const Scalar z550 = c_rear_left_hip * z549 + z534;
    const Scalar z551 = k19 - z529;
    const Scalar z552 = s_rear_left_hip * z551;
    const Scalar z553 = s_front_right_knee * z543;
    const Scalar z554 = c_front_right_knee * z542;
    const Scalar z555 = c_rear_left_hip * z547 + z540;
    const Scalar z556 = s_rear_left_hip * z547;
    const Scalar z557 = c_rear_left_hip * z549;
    const Scalar z558 = s_rear_left_hip * z549;
    const Scalar z559 = z531 - z558;
    const Scalar z560 = z539 - z556;
    const Scalar z561 = z530 + z556;
    const Scalar z562 = z558 + n0_2 * z555;
    const Scalar z563 = z499 + z555;
    const Scalar z564 = s_rear_left_hip * z533 - c_rear_left_hip * z536;
    const Scalar z565 = s_rear_left_hip * z536 + c_rear_left_hip * z533;
    const Scalar z566 = n0_05 * z535 + z546 + n0_2 * z564;
    const Scalar z567 = z548 - n0_2 * z565;
    const Scalar z568 = z509 - z562;
    const Scalar z569 = z517 - z560;
    const Scalar z570 = z557 + n0_05 * z564 + n0_2 * z560;
    const Scalar z571 = z475 + z564;
    const Scalar z572 = z512 - z570;
    const Scalar z573 = z523 - z561;
    const Scalar z574 = z485 - z567;
    const Scalar z575 = z486 - z566;
    const Scalar z576 = z476 - z565;
    const Scalar z577 = n0_05 * z565;
    const Scalar z578 = z484 + z577;
    const Scalar z579 = s_rear_left_hip * z552;
    const Scalar z580 = s_front_right_knee * z542;
    const Scalar z581 = z529 + z579;
    const Scalar z582 = c_rear_left_hip * z552;
    const Scalar z583 = z582 - n0_05 * z567 + n0_2 * (z559 - z562);
    const Scalar z584 = z581 + n0_05 * (z546 + z566) + n0_2 * (z557 + z570);
    const Scalar z585 = k19 - z579;
    const Scalar z586 = n0_2 * z554;
    const Scalar z587 = n0_2 * z586;
    const Scalar z588 = n0_124 - z586;
    const Scalar z589 = n0_2 * z580;
    const Scalar z590 = z513 + z583;
    const Scalar z591 = z550 - n0_2 * z561;
    const Scalar z592 = z518 - z584;
    const Scalar z593 = k17 - z587;
    const Scalar z594 = z585 - n0_2 * (z550 + z591);
    const Scalar z595 = z519 - z591;
    const Scalar z596 = n1 / z593;
    const Scalar z597 = n0_05 * z561;
    const Scalar z598 = n0_05 * z550 - n0_2 * z597;
    const Scalar z599 = z521 - z597;
    const Scalar z600 = n0_05 * z597;
    const Scalar z601 = n0_05 * z555;
    const Scalar z602 = z537 - z594;
    const Scalar z603 = z538 - z600;
    const Scalar z604 = z522 + z598;
    const Scalar z605 = z577 + z559 - n0_2 * z555;
    const Scalar z606 = n0_05 * (z559 + z577) - n0_2 * z601;
    const Scalar z607 = z516 + z606;
    const Scalar z608 = z508 - z601;
    const Scalar z609 = z510 - z605;
    const Scalar z610 = z588 * z596;
    const Scalar z611 = z589 * z596;
    const Scalar z612 = z554 + z588 * z610;
    const Scalar z613 = z580 - z588 * z611;
    const Scalar z614 = z553 + z589 * z611;
    const Scalar z615 = z612 - z614;
    const Scalar z616 = n2 * z613;
    const Scalar z617 = s_front_right_thigh * z615 + c_front_right_thigh * z616;
    const Scalar z618 = s_front_right_thigh * z617;
    const Scalar z619 = c_front_right_thigh * z617 - z613;
    const Scalar z620 = z614 + z618;
    const Scalar z621 = z612 - z618;
    const Scalar z622 = n0_08 * z619;
    const Scalar z623 = n0_08 * z620;
    const Scalar z624 = n0_08 * z621;
    const Scalar z625 = z125 + n0_08 * z622;
    const Scalar z626 = z129 - n0_08 * z623;
    const Scalar z627 = z130 + n0_08 * z624;
    const Scalar z628 = n0_1048 - z623;
    const Scalar z629 = n0_1048 - z624;
    const Scalar z630 = k18 + z626;
    const Scalar z631 = n1 / z630;
    const Scalar z632 = z625 * z631;
    const Scalar z633 = z622 * z631;
    const Scalar z634 = z131 * z631;
    const Scalar z635 = z628 * z631;
    const Scalar z636 = z621 + z622 * z633;
    const Scalar z637 = z622 * z634;
    const Scalar z638 = z131 * z634;
    const Scalar z639 = z622 * z632 - z629;
    const Scalar z640 = z619 - z622 * z635;
    const Scalar z641 = z131 * z632 + z132;
    const Scalar z642 = z131 * z635;
    const Scalar z643 = z622 - z628 * z632;
    const Scalar z644 = z625 * z632 + z627;
    const Scalar z645 = k16 * s_front_left_knee;
    const Scalar z646 = z620 + z628 * z635;
    const Scalar z647 = k16 * c_front_left_knee;
    const Scalar z648 = n2 * z642;
    const Scalar z649 = k19 - z644;
    const Scalar z650 = c_front_left_knee * z647;
    const Scalar z651 = s_front_right_hip * z639;
    const Scalar z652 = c_front_right_hip * z639;
    const Scalar z653 = s_front_right_hip * z643 + c_front_right_hip * z641;
    const Scalar z654 = z638 - z646;
    const Scalar z655 = c_front_right_hip * z637 + s_front_right_hip * z640;
    const Scalar z656 = s_front_right_hip * z637 - c_front_right_hip * z640;
    const Scalar z657 = z541 - z636;
    const Scalar z658 = s_front_right_hip * z649;
    const Scalar z659 = s_front_left_knee * z645;
    const Scalar z660 = c_front_right_hip * z648 + s_front_right_hip * z654;
    const Scalar z661 = s_front_right_hip * z658;
    const Scalar z662 = s_front_left_knee * z647;
    const Scalar z663 = c_front_right_hip * z658;
    const Scalar z664 = n0_05 * z656;
    const Scalar z665 = z651 + n0_2 * z656;
    const Scalar z666 = n0_05 * z636 + z652 + n0_2 * z655;
    const Scalar z667 = z571 + z655;
    const Scalar z668 = z576 + z656;
    const Scalar z669 = s_front_right_hip * z653;
    const Scalar z670 = c_front_right_hip * z653 - z641;
    const Scalar z671 = c_front_right_hip * z653;
    const Scalar z672 = k19 - z661;
    const Scalar z673 = n0_2 * z650;
    const Scalar z674 = z644 + z661;
    const Scalar z675 = n0_2 * z673;
    const Scalar z676 = n0_124 - z673;
    const Scalar z677 = n0_2 * z662;
    const Scalar z678 = k17 - z675;
    const Scalar z679 = n1 / z678;
    const Scalar z680 = s_front_right_hip * z660;
    const Scalar z681 = c_front_right_hip * z660 - z642;
    const Scalar z682 = z578 + z664;
    const Scalar z683 = z643 - z669;
    const Scalar z684 = z574 + z665;
    const Scalar z685 = z575 + z666;
    const Scalar z686 = z638 - z680;
    const Scalar z687 = z646 + z680;
    const Scalar z688 = n0_05 * z681;
    const Scalar z689 = z669 + n0_2 * z681;
    const Scalar z690 = z683 - n0_2 * z681 - z664;
    const Scalar z691 = z563 + z681;
    const Scalar z692 = z676 * z679;
    const Scalar z693 = z677 * z679;
    const Scalar z694 = n0_05 * z687;
    const Scalar z695 = z670 - n0_2 * z687;
    const Scalar z696 = z671 + n0_05 * z655 + n0_2 * z686;
    const Scalar z697 = z569 - z686;
    const Scalar z698 = z573 - z687;
    const Scalar z699 = n0_05 * (z683 - z664) - n0_2 * z688;
    const Scalar z700 = z608 + z688;
    const Scalar z701 = z663 - n0_05 * z665 + n0_2 * (z683 - z689);
    const Scalar z702 = z568 + z689;
    const Scalar z703 = z659 + z677 * z693;
    const Scalar z704 = z650 + z676 * z692;
    const Scalar z705 = z674 + n0_05 * (z652 + z666) + n0_2 * (z671 + z696);
    const Scalar z706 = z662 - z676 * z693;
    const Scalar z707 = z607 + z699;
    const Scalar z708 = z572 + z696;
    const Scalar z709 = z590 + z701;
    const Scalar z710 = z609 + z690;
    const Scalar z711 = z672 - n0_2 * (z670 + z695);
    const Scalar z712 = z592 - z705;
    const Scalar z713 = z602 - z711;
    const Scalar z714 = z595 + z695;
    const Scalar z715 = n0_05 * z670 - n0_2 * z694;
    const Scalar z716 = z604 + z715;
    const Scalar z717 = z599 + z694;
    const Scalar z718 = n0_05 * z694;
    const Scalar z719 = z603 - z718;
    const Scalar z720 = z704 - z703;
    const Scalar z721 = n2 * z706;
    const Scalar z722 = s_front_left_thigh * z720 + c_front_left_thigh * z721;
    const Scalar z723 = s_front_left_thigh * z722;
    const Scalar z724 = c_front_left_thigh * z722 - z706;
    const Scalar z725 = z703 + z723;
    const Scalar z726 = z704 - z723;
    const Scalar z727 = n0_08 * z724;
    const Scalar z728 = n0_08 * z725;
    const Scalar z729 = n0_08 * z726;
    const Scalar z730 = z127 + n0_08 * z727;
    const Scalar z731 = z133 - n0_08 * z728;
    const Scalar z732 = z134 + n0_08 * z729;
    const Scalar z733 = n0_1048 - z728;
    const Scalar z734 = n0_1048 - z729;
    const Scalar z735 = k18 + z731;
    const Scalar z736 = n1 / z735;
    const Scalar z737 = z730 * z736;
    const Scalar z738 = z727 * z736;
    const Scalar z739 = z135 * z736;
    const Scalar z740 = z733 * z736;
    const Scalar z741 = z726 + z727 * z738;
    const Scalar z742 = z727 * z739;
    const Scalar z743 = z135 * z739;
    const Scalar z744 = z727 * z737 - z734;
    const Scalar z745 = z724 - z727 * z740;
    const Scalar z746 = z135 * z737 + z136;
    const Scalar z747 = z135 * z740;
    const Scalar z748 = z727 - z733 * z737;
    const Scalar z749 = z730 * z737 + z732;
    const Scalar z750 = z725 + z733 * z740;
    const Scalar z751 = n2 * z747;
    const Scalar z752 = k19 - z749;
    const Scalar z753 = s_front_left_hip * z744;
    const Scalar z754 = c_front_left_hip * z744;
    const Scalar z755 = s_front_left_hip * z748 - c_front_left_hip * z746;
    const Scalar z756 = z743 - z750;
    const Scalar z757 = s_front_left_hip * z745 - c_front_left_hip * z742;
    const Scalar z758 = s_front_left_hip * z742 + c_front_left_hip * z745;
    const Scalar z759 = z657 - z741;
    const Scalar z760 = s_front_left_hip * z752;
    const Scalar z761 = s_front_left_hip * z756 - c_front_left_hip * z751;
    const Scalar z762 = s_front_left_hip * z760;
    const Scalar z763 = c_front_left_hip * z760;
    const Scalar z764 = n0_05 * z758;
    const Scalar z765 = z753 + n0_2 * z758;
    const Scalar z766 = z668 - z758;
    const Scalar z767 = s_front_left_hip * z755;
    const Scalar z768 = c_front_left_hip * z755 + z746;
    const Scalar z769 = c_front_left_hip * z755;
    const Scalar z770 = n0_05 * z741 + z754 - n0_2 * z757;
    const Scalar z771 = z667 + z757;
    const Scalar z772 = k19 - z762;
    const Scalar z773 = z749 + z762;
    const Scalar z774 = z682 + z764;
    const Scalar z775 = z748 - z767;
    const Scalar z776 = s_front_left_hip * z761;
    const Scalar z777 = c_front_left_hip * z761 + z747;
    const Scalar z778 = z684 - z765;
    const Scalar z779 = z685 - z770;
    const Scalar z780 = z743 - z776;
    const Scalar z781 = z750 + z776;
    const Scalar z782 = n0_05 * z777;
    const Scalar z783 = z767 - n0_2 * z777;
    const Scalar z784 = z764 + z775 + n0_2 * z777;
    const Scalar z785 = z691 + z777;
    const Scalar z786 = n0_05 * z781;
    const Scalar z787 = z768 + n0_2 * z781;
    const Scalar z788 = z769 + n0_05 * z757 - n0_2 * z780;
    const Scalar z789 = z697 - z780;
    const Scalar z790 = z698 - z781;
    const Scalar z791 = n0_05 * (z775 + z764) + n0_2 * z782;
    const Scalar z792 = z700 - z782;
    const Scalar z793 = z763 - n0_05 * z765 - n0_2 * (z775 - z783);
    const Scalar z794 = z702 - z783;
    const Scalar z795 = n0_05 * z786;
    const Scalar z796 = n0_05 * z768 + n0_2 * z786;
    const Scalar z797 = z717 - z786;
    const Scalar z798 = n0_2 * (z768 + z787) + z772;
    const Scalar z799 = z773 + n0_05 * (z754 + z770) - n0_2 * (z769 + z788);
    const Scalar z800 = z708 - z788;
    const Scalar z801 = z719 - z795;
    const Scalar z802 = z714 - z787;
    const Scalar z803 = z716 + z796;
    const Scalar z804 = z707 + z791;
    const Scalar z805 = z710 - z784;
    const Scalar z806 = z709 + z793;
    const Scalar z807 = z713 - z798;
    const Scalar z808 = z712 - z799;
    const Scalar z809 = n1 / z808;
    const Scalar z810 = z804 * z809;
    const Scalar z811 = z806 * z809;
    const Scalar z812 = z779 * z809;
    const Scalar z813 = z800 * z809;
    const Scalar z814 = z805 * z809;
    const Scalar z815 = z774 - z779 * z810;
    const Scalar z816 = z801 - z804 * z810;
    const Scalar z817 = z779 * z812 - z759;
    const Scalar z818 = z792 - z800 * z810;
    const Scalar z819 = z797 + z805 * z810;
    const Scalar z820 = z778 - z779 * z811;
    const Scalar z821 = z170 - n0_2 * z176;
    const Scalar z822 = z803 - z804 * z811;
    const Scalar z823 = s_front_left_knee * z171 - c_front_left_knee * z821;
    const Scalar z824 = z779 * z813 + z771;
    const Scalar z825 = z212 - n0_2 * z216;
    const Scalar z826 = z794 - z800 * z811;
    const Scalar z827 = s_front_right_knee * z224 - c_front_right_knee * z825;
    const Scalar z828 = z807 - z806 * z811;
    const Scalar z829 = z266 - n0_2 * z272;
    const Scalar z830 = z800 * z813 - z789;
    const Scalar z831 = s_rear_left_knee * z267 - c_rear_left_knee * z829;
    const Scalar z832 = z800 * z814 - z785;
    const Scalar z833 = z779 * z814 - z766;
    const Scalar z834 = z802 - z805 * z811;
    const Scalar z835 = z805 * z814 - z790;
    const Scalar z836 = n1 / z828;
    const Scalar z837 = z254 - n0_2 * z285;
    const Scalar z838 = s_rear_right_knee * z299 - c_rear_right_knee * z837;
    const Scalar z839 = n0_032 * z304;
    const Scalar z840 = k0 * z304 - n0_032 * z838;
    const Scalar z841 = z395 + z840;
    const Scalar z842 = z822 * z836;
    const Scalar z843 = z820 * z836;
    const Scalar z844 = z826 * z836;
    const Scalar z845 = z834 * z836;
    const Scalar z846 = k24 * z841;
    const Scalar z847 = z839 - k25 * z841;
    const Scalar z848 = z815 - z820 * z842;
    const Scalar z849 = z816 - z822 * z842;
    const Scalar z850 = z817 + z820 * z843;
    const Scalar z851 = z818 - z826 * z842;
    const Scalar z852 = z819 + z834 * z842;
    const Scalar z853 = z820 * z844 + z824;
    const Scalar z854 = z834 * z845 + z835;
    const Scalar z855 = z820 * z845 + z833;
    const Scalar z856 = z826 * z844 + z830;
    const Scalar z857 = z826 * z845 + z832;
    const Scalar z858 = n1 / z849;
    const Scalar z859 = s_rear_right_knee * z317 + c_rear_right_knee * z847;
    const Scalar z860 = n0_124 * z254 - z395 - k7 * z285 + n0_2 * z859;
    const Scalar z861 = s_rear_right_knee * z847 - c_rear_right_knee * z317;
    const Scalar z862 = n0_124 * z285 - z859;
    const Scalar z863 = n0_124 * z284 - z861;
    const Scalar z864 = z397 + z860;
    const Scalar z865 = z415 * z864 + z862;
    const Scalar z866 = z414 * z864;
    const Scalar z867 = z416 * z864 - z863;
    const Scalar z868 = z848 * z858;
    const Scalar z869 = z851 * z858;
    const Scalar z870 = n0_0002 * z302 - z397;
    const Scalar z871 = z852 * z858;
    const Scalar z872 = s_rear_right_thigh * z867 + c_rear_right_thigh * z865;
    const Scalar z873 = z852 * z871 + z854;
    const Scalar z874 = s_rear_right_thigh * z865 - c_rear_right_thigh * z867;
    const Scalar z875 = z851 * z869 + z856;
    const Scalar z876 = z851 * z871 - z857;
    const Scalar z877 = n0_1048 * z241 - z369 - k26 * z232 - n0_08 * z874;
    const Scalar z878 = n0_1048 * z234 - z371 - k27 * z231 - n0_08 * z872;
    const Scalar z879 = n0_1048 * z232 + z874;
    const Scalar z880 = n0_1048 * z231 + z872;
    const Scalar z881 = z848 * z869 + z853;
    const Scalar z882 = z848 * z871 - z855;
    const Scalar z883 = z848 * z868 + z850;
    const Scalar z884 = z399 - z877;
    const Scalar z885 = z440 * z884 - z878;
    const Scalar z886 = z347 - z444 * z884;
    const Scalar z887 = z446 * z884 - z879;
    const Scalar z888 = z442 * z884 + z880;
    const Scalar z889 = z438 * z884;
    const Scalar z890 = z12 * z875 + z14 * z876 + z15 * z881;
    const Scalar z891 = z12 * z876 + z14 * z873 + z15 * z882;
    const Scalar z892 = z12 * z881 + z14 * z882 + z15 * z883;
    const Scalar z893 = z12 * z890 + z14 * z891 + z15 * z892;
    const Scalar z894 = z35 * z881 + z33 * z875 + z21 * z876;
    const Scalar z895 = z34 * z881 + z36 * z875 + z23 * z876;
    const Scalar z896 = n1 / z893;
    const Scalar z897 = z35 * z883 + z33 * z881 + z21 * z882;
    const Scalar z898 = z34 * z883 + z36 * z881 + z23 * z882;
    const Scalar z899 = z35 * z882 + z33 * z876 + z21 * z873;
    const Scalar z900 = z34 * z882 + z36 * z876 + z23 * z873;
    const Scalar z901 = k0 * z320 - n0_032 * z831;
    const Scalar z902 = n0_032 * z320;
    const Scalar z903 = z396 + z901;
    const Scalar z904 = s_rear_right_hip * z870 + c_rear_right_hip * z885;
    const Scalar z905 = s_rear_right_hip * z885 - c_rear_right_hip * z870;
    const Scalar z906 = z902 - k25 * z903;
    const Scalar z907 = k24 * z903;
    const Scalar z908 = s_rear_right_hip * z887 + c_rear_right_hip * z886;
    const Scalar z909 = s_rear_right_hip * z886 - c_rear_right_hip * z887;
    const Scalar z910 = z12 * z894 + z14 * z899 + z15 * z897;
    const Scalar z911 = z35 * z897 + z33 * z894 + z21 * z899;
    const Scalar z912 = z34 * z897 + z36 * z894 + z23 * z899;
    const Scalar z913 = z910 * z896;
    const Scalar z914 = z911 - z910 * z913;
    const Scalar z915 = z12 * z895 + z14 * z900 + z15 * z898;
    const Scalar z916 = z34 * z898 + z36 * z895 + z23 * z900;
    const Scalar z917 = z915 * z913 - z912;
    const Scalar z918 = n1 / z914;
    const Scalar z919 = s_rear_left_knee * z334 + c_rear_left_knee * z906;
    const Scalar z920 = n0_124 * z266 - z396 - k7 * z272 + n0_2 * z919;
    const Scalar z921 = s_rear_left_knee * z906 - c_rear_left_knee * z334;
    const Scalar z922 = n0_124 * z272 - z919;
    const Scalar z923 = n0_124 * z261 - z921;
    const Scalar z924 = z398 + z920;
    const Scalar z925 = z455 * z924;
    const Scalar z926 = z915 * z896;
    const Scalar z927 = z916 - z915 * z926;
    const Scalar z928 = z457 * z924 + z922;
    const Scalar z929 = z459 * z924 - z923;
    const Scalar z930 = z917 * z918;
    const Scalar z931 = z927 - z917 * z930;
    const Scalar z932 = n0_0002 * z303 - z398;
    const Scalar z933 = s_rear_left_thigh * z928 - c_rear_left_thigh * z929;
    const Scalar z934 = s_rear_left_thigh * z929 + c_rear_left_thigh * z928;
    const Scalar z935 = n1 / z931;
    const Scalar z936 = k0 * z323 - n0_032 * z827;
    const Scalar z937 = z393 + n0_1048 * z244 + k26 * z239 - n0_08 * z933;
    const Scalar z938 = z394 + n0_1048 * z235 + k27 * z238 - n0_08 * z934;
    const Scalar z939 = n0_1048 * z239 - z933;
    const Scalar z940 = n0_1048 * z238 - z934;
    const Scalar z941 = n0_032 * z323;
    const Scalar z942 = z375 + z936;
    const Scalar z943 = k0 * z350 - n0_032 * z823;
    const Scalar z944 = n0_032 * z350;
    const Scalar z945 = z376 + z943;
    const Scalar z946 = z941 - k25 * z942;
    const Scalar z947 = z383 + z937;
    const Scalar z948 = z526 * z947 + z938;
    const Scalar z949 = z944 - k25 * z945;
    const Scalar z950 = n0_0002 * z319 - z381;
    const Scalar z951 = z362 + z525 * z947;
    const Scalar z952 = z524 * z947 - z939;
    const Scalar z953 = n0_0002 * z385 - z382;
    const Scalar z954 = z527 * z947 + z940;
    const Scalar z955 = z515 * z947;
    const Scalar z956 = k24 * z942;
    const Scalar z957 = k24 * z945;
    const Scalar z958 = s_front_right_knee * z349 + c_front_right_knee * z946;
    const Scalar z959 = n0_124 * z212 - z375 - k7 * z216 + n0_2 * z958;
    const Scalar z960 = s_front_right_knee * z946 - c_front_right_knee * z349;
    const Scalar z961 = n0_124 * z216 - z958;
    const Scalar z962 = z381 + z959;
    const Scalar z963 = n0_124 * z210 - z960;
    const Scalar z964 = z610 * z962 + z961;
    const Scalar z965 = z596 * z962;
    const Scalar z966 = z611 * z962 - z963;
    const Scalar z967 = s_front_left_knee * z378 + c_front_left_knee * z949;
    const Scalar z968 = n0_124 * z170 - z376 - k7 * z176 + n0_2 * z967;
    const Scalar z969 = s_front_left_knee * z949 - c_front_left_knee * z378;
    const Scalar z970 = n0_124 * z176 - z967;
    const Scalar z971 = z382 + z968;
    const Scalar z972 = n0_124 * z168 - z969;
    const Scalar z973 = z692 * z971 + z970;
    const Scalar z974 = z679 * z971;
    const Scalar z975 = z693 * z971 - z972;
    const Scalar z976 = s_front_right_thigh * z964 - c_front_right_thigh * z966;
    const Scalar z977 = s_front_right_thigh * z966 + c_front_right_thigh * z964;
    const Scalar z978 = n0_1048 * z200 - z405 - k26 * z199 - n0_08 * z976;
    const Scalar z979 = n0_1048 * z155 - z406 - k27 * z198 - n0_08 * z977;
    const Scalar z980 = n0_1048 * z199 + z976;
    const Scalar z981 = n0_1048 * z198 + z977;
    const Scalar z982 = z384 - z978;
    const Scalar z983 = z632 * z982 - z979;
    const Scalar z984 = z368 - z634 * z982;
    const Scalar z985 = z635 * z982 - z980;
    const Scalar z986 = z633 * z982 + z981;
    const Scalar z987 = z631 * z982;
    const Scalar z988 = s_front_left_thigh * z973 - c_front_left_thigh * z975;
    const Scalar z989 = s_front_left_thigh * z975 + c_front_left_thigh * z973;
    const Scalar z990 = z411 + n0_1048 * z158 + k26 * z154 - n0_08 * z988;
    const Scalar z991 = z412 + n0_1048 * z157 + k27 * z153 - n0_08 * z989;
    const Scalar z992 = n0_1048 * z154 - z988;
    const Scalar z993 = n0_1048 * z153 - z989;
    const Scalar z994 = z386 + z990;
    const Scalar z995 = z737 * z994 + z991;
    const Scalar z996 = z738 * z994 + z993;
    const Scalar z997 = z736 * z994;
    const Scalar z998 = s_rear_left_hip * z932 + c_rear_left_hip * z948;
    const Scalar z999 = s_rear_left_hip * z948 - c_rear_left_hip * z932;
    const Scalar z1000 = s_front_right_hip * z950 + c_front_right_hip * z983;
    const Scalar z1001 = s_front_right_hip * z983 - c_front_right_hip * z950;
    const Scalar z1002 = s_rear_left_hip * z952 + c_rear_left_hip * z951;
    const Scalar z1003 = s_rear_left_hip * z951 - c_rear_left_hip * z952;
    const Scalar z1004 = z392 + z739 * z994;
    const Scalar z1005 = z740 * z994 - z992;
    const Scalar z1006 = n12_24 * z146 - z888 + z954 - z986 + z996;
    const Scalar z1007 = s_front_left_hip * z953 + c_front_left_hip * z995;
    const Scalar z1008 = s_front_left_hip * z995 - c_front_left_hip * z953;
    const Scalar z1009 = s_front_right_hip * z985 + c_front_right_hip * z984;
    const Scalar z1010 = s_front_right_hip * z984 - c_front_right_hip * z985;
    const Scalar z1011 = s_front_left_hip * z1005 + c_front_left_hip * z1004;
    const Scalar z1012 = n0_2948 * z138 - z904 - z998 - z1000 - z1007 - n0_05 * (z888 + z954 + z986 + z996) - n0_2
        * (z908 - z1002 - z1009 + z1011);
    const Scalar z1013 = n12_24 * z137 + z908 - z1002 + z1009 - z1011;
    const Scalar z1014 = s_front_left_hip * z1004 - c_front_left_hip * z1005;
    const Scalar z1015 = n0_0306 * z147 + z386 + z384 + z383 + z399 - n0_05 * (z909 + z1003 + z1010 + z1014);
    const Scalar z1016 = n0_3254 * z145 - z905 - z999 - z1001 - z1008 - n0_2 * (z909 - z1003 - z1010 + z1014);
    const Scalar z1017 = n12_24 * z144 + z909 - z1003 + z1010 - z1014;
    const Scalar z1018 = z810 * z1012 + z1015;
    const Scalar z1019 = z811 * z1012 - z1016;
    const Scalar z1020 = z812 * z1012 + z1006;
    const Scalar z1021 = z813 * z1012 + z1013;
    const Scalar z1022 = z814 * z1012 - z1017;
    const Scalar z1023 = z809 * z1012;
    const Scalar z1024 = z842 * z1019 - z1018;
    const Scalar z1025 = z843 * z1019 - z1020;
    const Scalar z1026 = z844 * z1019 - z1021;
    const Scalar z1027 = z845 * z1019 - z1022;
    const Scalar z1028 = z836 * z1019;
    const Scalar z1029 = z868 * z1024 - z1025;
    const Scalar z1030 = z869 * z1024 - z1026;
    const Scalar z1031 = z871 * z1024 + z1027;
    const Scalar z1032 = z858 * z1024;
    const Scalar z1033 = z34 * z1029 + z36 * z1030 + z23 * z1031;
    const Scalar z1034 = z35 * z1029 + z33 * z1030 + z21 * z1031;
    const Scalar z1035 = z12 * z1030 + z14 * z1031 + z15 * z1029;
    const Scalar z1036 = z896 * z1035;
    const Scalar z1037 = z926 * z1035 - z1033;
    const Scalar z1038 = z913 * z1035 - z1034;
    const Scalar z1039 = z918 * z1038;
    const Scalar z1040 = z930 * z1038 + z1037;
    const Scalar z1041 = z935 * z1040;
    const Scalar z1042 = z930 * z1041 + z1039;
    const Scalar z1043 = z1036 + z926 * z1041 + z913 * z1042;
    const Scalar z1044 = z34 * z1041 + z35 * z1042 - z15 * z1043;
    const Scalar z1045 = z36 * z1041 + z33 * z1042 - z12 * z1043;
    const Scalar z1046 = z23 * z1041 + z21 * z1042 - z14 * z1043;
    const Scalar z1047 = z1032 + z868 * z1044 + z869 * z1045 + z871 * z1046;
    const Scalar z1048 = z1028 - z843 * z1044 - z844 * z1045 + z845 * z1046 + z842 * z1047;
    const Scalar z1049 = z814 * z1046 - z1023 - z812 * z1044 - z813 * z1045 + z810 * z1047 - z811 * z1048;
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
    const Scalar z1070 = z997 + z737 * z1057 + z738 * z1054 - z739 * z1066 - z740 * z1067;
    const Scalar z1071 = z987 + z632 * z1060 - z633 * z1058 - z634 * z1068 + z635 * z1069;
    const Scalar z1072 = z1054 + n0_08 * z1057;
    const Scalar z1073 = z1058 - n0_08 * z1060;
    const Scalar z1074 = z1067 + n0_08 * z1070;
    const Scalar z1075 = z1047 - z1070;
    const Scalar z1076 = z1069 - n0_08 * z1071;
    const Scalar z1077 = z1047 - z1071;
    const Scalar z1078 = s_rear_left_hip * z1052 + c_rear_left_hip * z1061;
    const Scalar z1079 = s_rear_left_hip * z1061 - c_rear_left_hip * z1052;
    const Scalar z1080 = z955 + z526 * z1063 + z527 * z1054 - z525 * z1078 - z524 * z1079;
    const Scalar z1081 = z1054 + n0_08 * z1063;
    const Scalar z1082 = s_rear_right_hip * z1053 + c_rear_right_hip * z1061;
    const Scalar z1083 = s_rear_right_hip * z1061 - c_rear_right_hip * z1053;
    const Scalar z1084 = z889 + z440 * z1064 - z442 * z1058 - z444 * z1082 + z446 * z1083;
    const Scalar z1085 = z1058 - n0_08 * z1064;
    const Scalar z1086 = z1079 + n0_08 * z1080;
    const Scalar z1087 = z1047 - z1080;
    const Scalar z1088 = z1047 - z1084;
    const Scalar z1089 = z1083 - n0_08 * z1084;
    const Scalar z1090 = c_front_left_thigh * z1072 + s_front_left_thigh * z1074;
    const Scalar z1091 = s_front_left_thigh * z1072 - c_front_left_thigh * z1074;
    const Scalar z1092 = z692 * z1090 - z974 + z693 * z1091;
    const Scalar z1093 = c_front_right_thigh * z1073 + s_front_right_thigh * z1076;
    const Scalar z1094 = s_front_right_thigh * z1073 - c_front_right_thigh * z1076;
    const Scalar z1095 = z610 * z1093 - z965 + z611 * z1094;
    const Scalar z1096 = z1090 - n0_2 * z1092;
    const Scalar z1097 = z1056 + z1092;
    const Scalar z1098 = c_rear_left_thigh * z1081 + s_rear_left_thigh * z1086;
    const Scalar z1099 = z223 - z1097;  // acceleration of joint front_left_thigh_link
    const Scalar z1100 = s_rear_left_thigh * z1081 - c_rear_left_thigh * z1086;
    const Scalar z1101 = z457 * z1098 - z925 + z459 * z1100;
    const Scalar z1102 = s_front_left_knee * z1091 - c_front_left_knee * z1096;
    const Scalar z1103 = z957 + k25 * z1102;
    const Scalar z1104 = z1093 - n0_2 * z1095;
    const Scalar z1105 = s_front_right_knee * z1094 - c_front_right_knee * z1104;
    const Scalar z1106 = z1098 - n0_2 * z1101;
    const Scalar z1107 = z1092 + z1103;
    const Scalar z1108 = c_rear_right_thigh * z1085 + s_rear_right_thigh * z1089;
    const Scalar z1109 = s_rear_right_thigh * z1085 - c_rear_right_thigh * z1089;
    const Scalar z1110 = z415 * z1108 - z866 + z416 * z1109;
    const Scalar z1111 = s_rear_left_knee * z1100 - c_rear_left_knee * z1106;
    const Scalar z1112 = z1059 + z1095;
    const Scalar z1113 = z956 + k25 * z1105;
    const Scalar z1114 = z1062 + z1101;
    const Scalar z1115 = z907 + k25 * z1111;
    const Scalar z1116 = z1108 - n0_2 * z1110;
    const Scalar z1117 = z1065 + z1110;
    const Scalar z1118 = z222 - z1112;  // acceleration of joint front_right_thigh_link
    const Scalar z1119 = z1095 + z1113;
    const Scalar z1120 = z292 - z1114;  // acceleration of joint rear_left_thigh_link
    const Scalar z1121 = z1101 + z1115;
    const Scalar z1122 = z291 - z1117;  // acceleration of joint rear_right_thigh_link
    const Scalar z1123 = s_rear_right_knee * z1109 - c_rear_right_knee * z1116;
    const Scalar z1124 = z846 + k25 * z1123;
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
    if (!(traits::regular(z413, z413) && traits::regular(z435, z435) && traits::regular(z451, z451)
        && traits::regular(z511, z511) && traits::regular(z593, z593) && traits::regular(z630, z630)
        && traits::regular(z678, z678) && traits::regular(z735, z735) && traits::regular(z808, z808)
        && traits::regular(z828, z828) && traits::regular(z849, z849) && traits::regular(-z893, -z893)
        && traits::regular(-z914, -z914) && traits::regular(-z931, -z931))) return torsor::Status::singular;
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
    const Scalar z15 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z16 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z17 = v_trunk_attitude_omega_x + v_rear_left_hip;
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
    const Scalar z34 = z18 - z19;
    const Scalar z35 = n1 - z26 - z20;
    const Scalar z36 = v_trunk_x * z25 + v_trunk_y * z29 + v_trunk_z * z31;
    const Scalar z37 = v_trunk_x * z27 + v_trunk_y * z30 + v_trunk_z * z32;
    const Scalar z38 = v_trunk_y * z33 + v_trunk_z * z34 + v_trunk_x * z35;
    const Scalar z39 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z40 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z41 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z42 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z43 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z44 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z45 = z38 - z39;
    const Scalar z46 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z47 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z48 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z49 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z50 = n0_05 * v_front_left_hip;
    const Scalar z51 = n0_05 * v_front_left_thigh;
    const Scalar z52 = n0_05 * v_front_left_knee;
    const Scalar z53 = n0_05 * v_front_right_hip;
    const Scalar z54 = n0_05 * v_front_right_thigh;
    const Scalar z55 = n0_05 * v_front_right_knee;
    const Scalar z56 = n0_05 * v_rear_left_hip;
    const Scalar z57 = n0_05 * v_rear_left_thigh;
    const Scalar z58 = n0_05 * v_rear_left_knee;
    const Scalar z59 = n0_05 * v_rear_right_hip;
    const Scalar z60 = n0_05 * v_rear_right_thigh;
    const Scalar z61 = n0_05 * v_rear_right_knee;
    const Scalar z62 = n0_2 * z34;
    const Scalar z63 = n0_2 * v_trunk_attitude_omega_z + z37;
    const Scalar z64 = n0_05 * z32 + z62;
    const Scalar z65 = z36 + n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z66 = q_trunk_z + z64;  // place of front_left_hip_link, z
    const Scalar z67 = q_trunk_z - z64;  // place of rear_right_hip_link, z
    const Scalar z68 = s_front_left_hip * z63 - c_front_left_hip * z65;
    const Scalar z69 = s_front_left_hip * z65 + c_front_left_hip * z63;
    const Scalar z70 = n0_05 * z32 - z62;
    const Scalar z71 = q_trunk_z - z70;  // place of front_right_hip_link, z
    const Scalar z72 = q_trunk_z + z70;  // place of rear_left_hip_link, z
    const Scalar z73 = c_front_left_thigh * z15 + s_front_left_thigh * z41;
    const Scalar z74 = v_front_left_thigh + z46;
    const Scalar z75 = v_front_right_thigh + z47;
    const Scalar z76 = v_rear_left_thigh + z48;
    const Scalar z77 = v_rear_right_thigh + z49;
    const Scalar z78 = n0_08 * z15 - z68;
    const Scalar z79 = n0_08 * z41 + z45;
    const Scalar z80 = s_front_left_thigh * z15 - c_front_left_thigh * z41;
    const Scalar z81 = s_front_left_knee * z73 + c_front_left_knee * z80;
    const Scalar z82 = s_front_left_knee * z80 - c_front_left_knee * z73;
    const Scalar z83 = s_front_right_thigh * z16 - c_front_right_thigh * z42;
    const Scalar z84 = s_rear_left_thigh * z17 - c_rear_left_thigh * z43;
    const Scalar z85 = s_rear_right_thigh * z40 - c_rear_right_thigh * z44;
    const Scalar z86 = s_front_left_thigh * z78 - c_front_left_thigh * z79;
    const Scalar z87 = s_front_left_thigh * z79 + c_front_left_thigh * z78;
    const Scalar z88 = c_front_right_thigh * z16 + s_front_right_thigh * z42;
    const Scalar z89 = s_front_right_knee * z88 + c_front_right_knee * z83;
    const Scalar z90 = s_front_right_knee * z83 - c_front_right_knee * z88;
    const Scalar z91 = c_rear_left_thigh * z17 + s_rear_left_thigh * z43;
    const Scalar z92 = s_rear_left_knee * z91 + c_rear_left_knee * z84;
    const Scalar z93 = s_rear_left_knee * z84 - c_rear_left_knee * z91;
    const Scalar z94 = c_rear_right_thigh * z40 + s_rear_right_thigh * z44;
    const Scalar z95 = s_rear_right_knee * z94 + c_rear_right_knee * z85;
    const Scalar z96 = s_rear_right_knee * z85 - c_rear_right_knee * z94;
    const Scalar z97 = n0_2 * z74 + z86;
    const Scalar z98 = v_front_left_knee + z74;
    const Scalar z99 = z38 + z39;
    const Scalar z100 = s_front_left_knee * z97 - c_front_left_knee * z87;
    const Scalar z101 = s_front_left_knee * z87 + c_front_left_knee * z97;
    const Scalar z102 = n0_05 * v_trunk_attitude_omega_x - z36 + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z103 = s_front_right_hip * z63 + c_front_right_hip * z102;
    const Scalar z104 = s_front_right_hip * z102 - c_front_right_hip * z63;
    const Scalar z105 = n0_08 * z42 - z99;
    const Scalar z106 = n0_08 * z16 + z103;
    const Scalar z107 = v_front_right_knee + z75;
    const Scalar z108 = n0_2 * v_trunk_attitude_omega_z - z37;
    const Scalar z109 = z36 + n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z110 = s_rear_left_hip * z108 + c_rear_left_hip * z109;
    const Scalar z111 = s_rear_left_hip * z109 - c_rear_left_hip * z108;
    const Scalar z112 = n0_08 * z43 + z45;
    const Scalar z113 = s_front_right_thigh * z106 - c_front_right_thigh * z105;
    const Scalar z114 = s_front_right_thigh * z105 + c_front_right_thigh * z106;
    const Scalar z115 = n0_08 * z17 + z110;
    const Scalar z116 = n0_2 * z75 - z113;
    const Scalar z117 = s_rear_left_thigh * z115 - c_rear_left_thigh * z112;
    const Scalar z118 = s_rear_left_thigh * z112 + c_rear_left_thigh * z115;
    const Scalar z119 = c_front_right_knee * z114 + s_front_right_knee * z116;
    const Scalar z120 = s_front_right_knee * z114 - c_front_right_knee * z116;
    const Scalar z121 = v_rear_left_knee + z76;
    const Scalar z122 = n0_05 * v_trunk_attitude_omega_x - z36 - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z123 = s_rear_right_hip * z108 - c_rear_right_hip * z122;
    const Scalar z124 = s_rear_right_hip * z122 + c_rear_right_hip * z108;
    const Scalar z125 = n0_08 * z44 - z99;
    const Scalar z126 = n0_08 * z40 - z123;
    const Scalar z127 = n0_2 * z76 + z117;
    const Scalar z128 = s_rear_left_knee * z127 - c_rear_left_knee * z118;
    const Scalar z129 = s_rear_left_knee * z118 + c_rear_left_knee * z127;
    const Scalar z130 = s_rear_right_thigh * z126 - c_rear_right_thigh * z125;
    const Scalar z131 = v_rear_right_knee + z77;
    const Scalar z132 = s_rear_right_thigh * z125 + c_rear_right_thigh * z126;
    const Scalar z133 = n0_02 * z15 - n0_5 * z68;
    const Scalar z134 = n0_0014 * z15 - n0_02 * z68;
    const Scalar z135 = n0_072 * z74 + n0_8 * z86;
    const Scalar z136 = k10 * z74 + n0_072 * z86;
    const Scalar z137 = n0_8 * z69 + n0_072 * z73;
    const Scalar z138 = n0_072 * z69 + k10 * z73;
    const Scalar z139 = n0_2 * z73 + z69;
    const Scalar z140 = n0_032 * z98 + n0_26 * z101;
    const Scalar z141 = k13 * z98 + n0_032 * z101;
    const Scalar z142 = n0_032 * z82 - n0_26 * z139;
    const Scalar z143 = k13 * z82 - n0_032 * z139;
    const Scalar z144 = n0_02 * z16 + n0_5 * z103;
    const Scalar z145 = n0_0014 * z16 + n0_02 * z103;
    const Scalar z146 = n0_072 * z75 - n0_8 * z113;
    const Scalar z147 = k10 * z75 - n0_072 * z113;
    const Scalar z148 = n0_072 * z88 - n0_8 * z104;
    const Scalar z149 = k10 * z88 - n0_072 * z104;
    const Scalar z150 = n0_2 * z88 - z104;
    const Scalar z151 = n0_032 * z107 - n0_26 * z120;
    const Scalar z152 = k13 * z107 - n0_032 * z120;
    const Scalar z153 = n0_032 * z90 - n0_26 * z150;
    const Scalar z154 = k13 * z90 - n0_032 * z150;
    const Scalar z155 = n0_02 * z17 + n0_5 * z110;
    const Scalar z156 = n0_0014 * z17 + n0_02 * z110;
    const Scalar z157 = n0_072 * z76 + n0_8 * z117;
    const Scalar z158 = k10 * z76 + n0_072 * z117;
    const Scalar z159 = n0_8 * z111 + n0_072 * z91;
    const Scalar z160 = n0_072 * z111 + k10 * z91;
    const Scalar z161 = n0_2 * z91 + z111;
    const Scalar z162 = n0_032 * z121 + n0_26 * z129;
    const Scalar z163 = k13 * z121 + n0_032 * z129;
    const Scalar z164 = n0_032 * z93 - n0_26 * z161;
    const Scalar z165 = k13 * z93 - n0_032 * z161;
    const Scalar z166 = n0_08 * c_front_left_hip;
    const Scalar z167 = n0_02 * z40 - n0_5 * z123;
    const Scalar z168 = n0_0014 * z40 - n0_02 * z123;
    const Scalar z169 = n0_2 * z77 - z130;
    const Scalar z170 = n0_08 * s_front_left_hip;
    const Scalar z171 = c_rear_right_knee * z132 + s_rear_right_knee * z169;
    const Scalar z172 = s_rear_right_knee * z132 - c_rear_right_knee * z169;
    const Scalar z173 = n0_02 * c_front_left_hip;
    const Scalar z174 = n0_072 * z77 - n0_8 * z130;
    const Scalar z175 = k10 * z77 - n0_072 * z130;
    const Scalar z176 = n0_2 * z94 - z124;
    const Scalar z177 = n0_05 + z166;
    const Scalar z178 = z62 + z31 * z170 + z32 * z177;
    const Scalar z179 = n0_072 * z94 - n0_8 * z124;
    const Scalar z180 = k10 * z94 - n0_072 * z124;
    const Scalar z181 = n0_5 * z45;
    const Scalar z182 = n0_02 * z45;
    const Scalar z183 = n0_5 * z99;
    const Scalar z184 = q_trunk_z + z178;
    const Scalar z185 = n0_02 * z99;
    const Scalar z186 = n0_02 * s_front_left_hip;
    const Scalar z187 = z32 * z173 + z31 * z186;
    const Scalar z188 = n0_072 * s_front_left_thigh;
    const Scalar z189 = n0_02 * z41 + z181;
    const Scalar z190 = n0_072 * c_front_left_thigh;
    const Scalar z191 = n0_0014 * z41 + z182;
    const Scalar z192 = n0_2 * s_front_left_thigh;
    const Scalar z193 = n0_02 * z43 + z181;
    const Scalar z194 = n0_2 * c_front_left_thigh;
    const Scalar z195 = n0_0014 * z43 + z182;
    const Scalar z196 = n0_2 - z192;
    const Scalar z197 = n0_032 * z5;
    const Scalar z198 = s_front_left_hip * z190;
    const Scalar z199 = c_front_left_hip * z194 - z170;
    const Scalar z200 = s_front_left_hip * z194 + z166;
    const Scalar z201 = c_front_left_hip * z190;
    const Scalar z202 = n0_05 + z200;
    const Scalar z203 = n0_032 * z4;
    const Scalar z204 = z32 * z198 - z31 * z201 - z34 * z188;
    const Scalar z205 = z34 * z196 - z31 * z199 + z32 * z202;
    const Scalar z206 = n0_02 * z42 - z183;
    const Scalar z207 = s_front_left_hip * z197;
    const Scalar z208 = c_front_left_hip * z197;
    const Scalar z209 = n0_02 * c_front_right_hip;
    const Scalar z210 = n0_0014 * z42 - z185;
    const Scalar z211 = n0_08 * s_front_right_hip;
    const Scalar z212 = n0_2 * c_front_right_thigh;
    const Scalar z213 = n0_08 * c_front_right_hip;
    const Scalar z214 = n0_072 * c_front_right_thigh;
    const Scalar z215 = z32 * z207 - z31 * z208 - z34 * z203;
    const Scalar z216 = n0_2 * s_front_right_thigh;
    const Scalar z217 = c_front_right_hip * z212 + z211;
    const Scalar z218 = s_front_right_hip * z214;
    const Scalar z219 = n0_02 * z44 - z183;
    const Scalar z220 = n0_032 * z7;
    const Scalar z221 = n0_0014 * z44 - z185;
    const Scalar z222 = n0_08 * c_rear_left_hip;
    const Scalar z223 = n0_2 - z216;
    const Scalar z224 = s_front_right_hip * z220;
    const Scalar z225 = q_trunk_z + z205;
    const Scalar z226 = s_front_right_hip * z212 - z213;
    const Scalar z227 = c_front_right_hip * z214;
    const Scalar z228 = c_front_right_hip * z220;
    const Scalar z229 = n0_05 + z213;
    const Scalar z230 = n0_05 - z226;
    const Scalar z231 = n0_02 * c_rear_left_hip;
    const Scalar z232 = z31 * z211 - z62 + z32 * z229;
    const Scalar z233 = n0_02 * s_front_right_hip;
    const Scalar z234 = z31 * z217 - z34 * z223 + z32 * z230;
    const Scalar z235 = n0_072 * s_front_right_thigh;
    const Scalar z236 = n0_032 * z6;
    const Scalar z237 = z32 * z218 - z31 * z227 - z34 * z235;
    const Scalar z238 = n0_02 * s_rear_left_hip;
    const Scalar z239 = n0_032 * z131 - n0_26 * z172;
    const Scalar z240 = n0_08 * s_rear_left_hip;
    const Scalar z241 = n0_032 * z96 - n0_26 * z176;
    const Scalar z242 = n0_05 + z222;
    const Scalar z243 = z32 * z224 - z31 * z228 - z34 * z236;
    const Scalar z244 = k13 * z96 - n0_032 * z176;
    const Scalar z245 = z31 * z240 - z62 + z32 * z242;
    const Scalar z246 = k13 * z131 - n0_032 * z172;
    const Scalar z247 = n0_2 * c_rear_left_thigh;
    const Scalar z248 = s_rear_left_hip * z247 + z222;
    const Scalar z249 = n0_08 * s_rear_right_hip;
    const Scalar z250 = n0_072 * c_rear_left_thigh;
    const Scalar z251 = n0_032 * z9;
    const Scalar z252 = n0_08 * c_rear_right_hip;
    const Scalar z253 = n0_072 * c_rear_right_thigh;
    const Scalar z254 = s_rear_left_hip * z250;
    const Scalar z255 = z32 * z209 + z31 * z233;
    const Scalar z256 = n0_2 * s_rear_right_thigh;
    const Scalar z257 = n0_2 * c_rear_right_thigh;
    const Scalar z258 = z32 * z231 + z31 * z238;
    const Scalar z259 = n0_05 + z248;
    const Scalar z260 = c_rear_left_hip * z247 - z240;
    const Scalar z261 = s_rear_left_hip * z251;
    const Scalar z262 = s_rear_right_hip * z253;
    const Scalar z263 = n0_2 * s_rear_left_thigh;
    const Scalar z264 = q_trunk_z - z232;
    const Scalar z265 = n0_2 + z256;
    const Scalar z266 = n0_032 * z11;
    const Scalar z267 = q_trunk_z - z234;
    const Scalar z268 = c_rear_right_hip * z257 + z249;
    const Scalar z269 = q_trunk_z + z245;
    const Scalar z270 = s_rear_right_hip * z266;
    const Scalar z271 = s_rear_right_hip * z257 - z252;
    const Scalar z272 = c_rear_left_hip * z250;
    const Scalar z273 = c_rear_left_hip * z251;
    const Scalar z274 = c_rear_right_hip * z253;
    const Scalar z275 = c_rear_right_hip * z266;
    const Scalar z276 = n0_2 + z263;
    const Scalar z277 = z32 * z259 - z31 * z260 - z34 * z276;
    const Scalar z278 = n0_02 * c_rear_right_hip;
    const Scalar z279 = n0_05 + z252;
    const Scalar z280 = n0_05 - z271;
    const Scalar z281 = n0_072 * s_rear_left_thigh;
    const Scalar z282 = z32 * z254 - z31 * z272 - z34 * z281;
    const Scalar z283 = n0_032 * z8;
    const Scalar z284 = n0_02 * s_rear_right_hip;
    const Scalar z285 = n0_072 * s_rear_right_thigh;
    const Scalar z286 = z32 * z261 - z31 * z273 - z34 * z283;
    const Scalar z287 = n0_032 * z10;
    const Scalar z288 = z62 + z31 * z249 + z32 * z279;
    const Scalar z289 = z34 * z265 + z31 * z268 + z32 * z280;
    const Scalar z290 = q_trunk_z + z277;
    const Scalar z291 = z32 * z278 + z31 * z284;
    const Scalar z292 = q_trunk_z - z288;
    const Scalar z293 = z32 * z262 - z31 * z274 - z34 * z285;
    const Scalar z294 = q_trunk_z - z289;
    const Scalar z295 = z32 * z270 - z31 * z275 - z34 * z287;
    result.kinetic = n0_0125 * v_trunk_attitude_omega_x * v_trunk_attitude_omega_x + n0_0425 * v_trunk_attitude_omega_y
        * v_trunk_attitude_omega_y + v_trunk_attitude_omega_z * z39 + n3 * (z38 * z38 + z37 * z37 + z36 * z36) + n0_25
        * (z69 * z69 + z104 * z104 + z111 * z111 + z124 * z124) + k18 * (z81 * z81 + z89 * z89 + z92 * z92 + z95 * z95)
        + n0_4 * (z87 * z87 + z114 * z114 + z118 * z118 + z132 * z132) + n0_0002 * (z46 * z46 + z47 * z47 + z48 * z48
        + z49 * z49 + z80 * z80 + z83 * z83 + z84 * z84 + z85 * z85) + n0_13 * (z119 * z119 + z171 * z171 + z100 * z100
        + z128 * z128) + n0_5 * (z41 * z191 + z15 * z134 + z42 * z210 + z16 * z145 + z43 * z195 + z17 * z156 + z44
        * z221 + z40 * z168 - z68 * z133 + z103 * z144 + z110 * z155 - z123 * z167 + z45 * (z189 + z193) - z99 * (z206
        + z219) + z73 * z138 + z91 * z160 + z69 * z137 + z111 * z159 + z88 * z149 + z94 * z180 - z104 * z148 - z124
        * z179 + z74 * z136 + z75 * z147 + z76 * z158 + z77 * z175 + z86 * z135 - z113 * z146 + z117 * z157 - z130
        * z174 + z82 * z143 + z90 * z154 + z93 * z165 + z96 * z244 - z139 * z142 - z150 * z153 - z161 * z164 - z176
        * z241 + z98 * z141 + z107 * z152 + z121 * z163 + z131 * z246 + z101 * z140 - z120 * z151 + z129 * z162 - z172
        * z239);
    result.force_function = -n58_86 * q_trunk_z - n4_905 * (z66 + z71 + z72 + z67) - n7_848 * (z184 + z264 + z269
        + z292) - n2_5506 * (z225 + z294 + z267 + z290) - n9_81 * (z187 - z255 + z258 - z291 + z204 + z237 + z282 + z293
        + z215 + z243 + z286 + z295);
    result.power = v_front_left_hip * (u_front_left_hip_torque - z50) + v_front_left_thigh * (u_front_left_thigh_torque
        - z51) + v_front_left_knee * (u_front_left_knee_torque - z52) + v_front_right_hip * (u_front_right_hip_torque
        - z53) + v_front_right_thigh * (u_front_right_thigh_torque - z54) + v_front_right_knee
        * (u_front_right_knee_torque - z55) + v_rear_left_hip * (u_rear_left_hip_torque - z56) + v_rear_left_thigh
        * (u_rear_left_thigh_torque - z57) + v_rear_left_knee * (u_rear_left_knee_torque - z58) + v_rear_right_hip
        * (u_rear_right_hip_torque - z59) + v_rear_right_thigh * (u_rear_right_thigh_torque - z60) + v_rear_right_knee
        * (u_rear_right_knee_torque - z61);
  }
};

}  // namespace quadruped
