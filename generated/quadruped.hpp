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
// joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              542              709          0             0                 16       0   1283    1283
//   mass_matrix             307              416          0             0                 12       0    747     803
//   bias                    388              518          0             0                 12       0    930    1026
//   inverse_dynamics        446              555          0             0                 12       0   1025    1121
//   forward_dynamics        950             1186         14             0                 12       0   2174    2346
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

  /// Of r = x - n pi/2 for |x| <= bound, and `shifted`, n + shift(); what is no
  /// number gives no number.
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
    if constexpr (sizeof(Numbers) == 32) {  // AVX has an instruction that looks at the bit of the sign
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
  static constexpr unsigned long long fingerprint = 0x645da292da2e720dULL;
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
    const Scalar z3541 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_y + q_trunk_attitude_z
        * v_trunk_attitude_omega_z + q_trunk_attitude_x * v_trunk_attitude_omega_x);
    const Scalar z3542 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_z - q_trunk_attitude_z
        * v_trunk_attitude_omega_y + q_trunk_attitude_w * v_trunk_attitude_omega_x);
    const Scalar z3543 = n0_5 * (q_trunk_attitude_z * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_z + q_trunk_attitude_w * v_trunk_attitude_omega_y);
    const Scalar z3544 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_y - q_trunk_attitude_w * v_trunk_attitude_omega_z);
    rates[0] = v_trunk_x;
    rates[1] = v_trunk_y;
    rates[2] = v_trunk_z;
    rates[3] = -z3541;
    rates[4] = z3542;
    rates[5] = z3543;
    rates[6] = -z3544;
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
    const Scalar z153 = q_front_left_thigh + q_front_left_knee;
    const Scalar z224 = q_front_right_thigh + q_front_right_knee;
    const Scalar z291 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z358 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z153, z224, z291, z358};
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
    const Scalar z154 = sines_[12], z155 = cosines_[12];
    const Scalar z225 = sines_[13], z226 = cosines_[13];
    const Scalar z292 = sines_[14], z293 = cosines_[14];
    const Scalar z359 = sines_[15], z360 = cosines_[15];
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z14 + z16;
    const Scalar z25 = z21 + z22;
    const Scalar z118 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z119 = n0_2 * v_trunk_attitude_omega_z;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z30 = z26 + z27;
    const Scalar z120 = n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z24 = z21 - z22;
    const Scalar z29 = z26 - z27;
    const Scalar z123 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z107 = z18 * s_front_left_hip - z30 * c_front_left_hip;
    const Scalar z109 = z23 * s_front_left_hip - z24 * c_front_left_hip;
    const Scalar z111 = z25 * s_front_left_hip - z28 * c_front_left_hip;
    const Scalar z127 = v_trunk_x + z18 * z119 + z30 * z120 - z17 * z118;  // velocity of front_left_hip_link, x
    const Scalar z128 = v_trunk_y - z19 * z118 + z23 * z119 + z24 * z120;  // velocity of front_left_hip_link, y
    const Scalar z129 = v_trunk_z + z25 * z119 + z28 * z120 - z29 * z118;  // velocity of front_left_hip_link, z
    const Scalar z143 = n0_08 * z123;
    const Scalar z122 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z97 = z17 * v_trunk_attitude_omega_x;  // angular velocity of trunk_attitude_omega_x, x
    const Scalar z100 = z18 * v_trunk_attitude_omega_y + z97;  // angular velocity of trunk_attitude_omega_y, x
    const Scalar z98 = z19 * v_trunk_attitude_omega_x;  // angular velocity of trunk_attitude_omega_x, y
    const Scalar z101 = z23 * v_trunk_attitude_omega_y + z98;  // angular velocity of trunk_attitude_omega_y, y
    const Scalar z99 = z29 * v_trunk_attitude_omega_x;  // angular velocity of trunk_attitude_omega_x, z
    const Scalar z102 = z25 * v_trunk_attitude_omega_y + z99;  // angular velocity of trunk_attitude_omega_y, z
    const Scalar z103 = z30 * v_trunk_attitude_omega_z + z100;  // angular velocity of trunk, x
    const Scalar z121 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z104 = z24 * v_trunk_attitude_omega_z + z101;  // angular velocity of trunk, y
    const Scalar z105 = z28 * v_trunk_attitude_omega_z + z102;  // angular velocity of trunk, z
    const Scalar z106 = z18 * c_front_left_hip + z30 * s_front_left_hip;
    const Scalar z108 = z23 * c_front_left_hip + z24 * s_front_left_hip;
    const Scalar z110 = z25 * c_front_left_hip + z28 * s_front_left_hip;
    const Scalar z112 = n0_05 * z18 + n0_2 * z17;
    const Scalar z113 = n0_2 * z19 + n0_05 * z23;
    const Scalar z114 = n0_05 * z25 + n0_2 * z29;
    const Scalar z115 = q_trunk_x + z112;  // place of front_left_hip_link, x
    const Scalar z146 = v_front_left_thigh + z121;
    const Scalar z142 = n0_08 * z122;
    const Scalar z131 = z17 * s_front_left_thigh - c_front_left_thigh * z107;
    const Scalar z133 = z19 * s_front_left_thigh - c_front_left_thigh * z109;
    const Scalar z135 = z29 * s_front_left_thigh - c_front_left_thigh * z111;
    const Scalar z144 = c_front_left_thigh * z123 + s_front_left_thigh * z122;
    const Scalar z157 = z17 * z154 - z107 * z155;
    const Scalar z159 = z19 * z154 - z109 * z155;
    const Scalar z161 = z29 * z154 - z111 * z155;
    const Scalar z150 = z127 - z107 * z143 + z17 * z142;  // velocity of front_left_thigh_link, x
    const Scalar z151 = z128 - z109 * z143 + z19 * z142;  // velocity of front_left_thigh_link, y
    const Scalar z152 = z129 - z111 * z143 + z29 * z142;  // velocity of front_left_thigh_link, z
    const Scalar z162 = n0_2 * z131;
    const Scalar z163 = n0_2 * z133;
    const Scalar z164 = n0_2 * z135;
    const Scalar z169 = n0_2 * z144;
    const Scalar z179 = z18 * c_front_right_hip + z30 * s_front_right_hip;
    const Scalar z145 = s_front_left_thigh * z123 - c_front_left_thigh * z122;
    const Scalar z170 = s_front_left_knee * z145 - c_front_left_knee * z144;
    const Scalar z136 = n0_08 * z106;
    const Scalar z137 = n0_08 * z108;
    const Scalar z138 = n0_08 * z110;
    const Scalar z130 = z17 * c_front_left_thigh + s_front_left_thigh * z107;
    const Scalar z132 = z19 * c_front_left_thigh + s_front_left_thigh * z109;
    const Scalar z134 = z29 * c_front_left_thigh + s_front_left_thigh * z111;
    const Scalar z168 = n0_2 * z146;
    const Scalar z172 = v_front_left_knee + z146;
    const Scalar z116 = q_trunk_y + z113;  // place of front_left_hip_link, y
    const Scalar z180 = z18 * s_front_right_hip - z30 * c_front_right_hip;
    const Scalar z117 = q_trunk_z + z114;  // place of front_left_hip_link, z
    const Scalar z182 = z23 * s_front_right_hip - z24 * c_front_right_hip;
    const Scalar z184 = z25 * s_front_right_hip - z28 * c_front_right_hip;
    const Scalar z181 = z23 * c_front_right_hip + z24 * s_front_right_hip;
    const Scalar z183 = z25 * c_front_right_hip + z28 * s_front_right_hip;
    const Scalar z185 = n0_2 * z17 - n0_05 * z18;
    const Scalar z186 = n0_2 * z19 - n0_05 * z23;
    const Scalar z187 = n0_05 * z25 - n0_2 * z29;
    const Scalar z124 = z17 * v_front_left_hip + z103;  // angular velocity of front_left_hip_link, x
    const Scalar z147 = v_front_left_thigh * z106 + z124;  // angular velocity of front_left_thigh_link, x
    const Scalar z188 = q_trunk_x + z185;  // place of front_right_hip_link, x
    const Scalar z125 = z19 * v_front_left_hip + z104;  // angular velocity of front_left_hip_link, y
    const Scalar z148 = v_front_left_thigh * z108 + z125;  // angular velocity of front_left_thigh_link, y
    const Scalar z189 = q_trunk_y + z186;  // place of front_right_hip_link, y
    const Scalar z173 = v_front_left_knee * z106 + z147;  // angular velocity of front_left_shank_link, x
    const Scalar z126 = z29 * v_front_left_hip + z105;  // angular velocity of front_left_hip_link, z
    const Scalar z149 = v_front_left_thigh * z110 + z126;  // angular velocity of front_left_thigh_link, z
    const Scalar z174 = v_front_left_knee * z108 + z148;  // angular velocity of front_left_shank_link, y
    const Scalar z191 = n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z193 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z175 = v_front_left_knee * z110 + z149;  // angular velocity of front_left_shank_link, z
    const Scalar z194 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z198 = v_trunk_x + z18 * z119 - z30 * z191 + z17 * z118;  // velocity of front_right_hip_link, x
    const Scalar z199 = v_trunk_y + z19 * z118 + z23 * z119 - z24 * z191;  // velocity of front_right_hip_link, y
    const Scalar z200 = v_trunk_z + z25 * z119 - z28 * z191 + z29 * z118;  // velocity of front_right_hip_link, z
    const Scalar z202 = z17 * s_front_right_thigh - c_front_right_thigh * z180;
    const Scalar z192 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z201 = z17 * c_front_right_thigh + s_front_right_thigh * z180;
    const Scalar z190 = q_trunk_z - z187;  // place of front_right_hip_link, z
    const Scalar z156 = z17 * z155 + z107 * z154;
    const Scalar z158 = z19 * z155 + z109 * z154;
    const Scalar z160 = z29 * z155 + z111 * z154;
    const Scalar z176 = z150 + z106 * z169 - z130 * z168;  // velocity of front_left_shank_link, x
    const Scalar z177 = z151 + z108 * z169 - z132 * z168;  // velocity of front_left_shank_link, y
    const Scalar z178 = z152 + z110 * z169 - z134 * z168;  // velocity of front_left_shank_link, z
    const Scalar z195 = z17 * v_front_right_hip + z103;  // angular velocity of front_right_hip_link, x
    const Scalar z196 = z19 * v_front_right_hip + z104;  // angular velocity of front_right_hip_link, y
    const Scalar z197 = z29 * v_front_right_hip + z105;  // angular velocity of front_right_hip_link, z
    const Scalar z139 = z115 + z136;  // place of front_left_thigh_link, x
    const Scalar z203 = z19 * c_front_right_thigh + s_front_right_thigh * z182;
    const Scalar z140 = z116 + z137;  // place of front_left_thigh_link, y
    const Scalar z204 = z19 * s_front_right_thigh - c_front_right_thigh * z182;
    const Scalar z141 = z117 + z138;  // place of front_left_thigh_link, z
    const Scalar z217 = v_front_right_thigh + z192;
    const Scalar z218 = v_front_right_thigh * z179 + z195;  // angular velocity of front_right_thigh_link, x
    const Scalar z219 = v_front_right_thigh * z181 + z196;  // angular velocity of front_right_thigh_link, y
    const Scalar z220 = v_front_right_thigh * z183 + z197;  // angular velocity of front_right_thigh_link, z
    const Scalar z213 = n0_08 * z193;
    const Scalar z214 = n0_08 * z194;
    const Scalar z206 = z29 * s_front_right_thigh - c_front_right_thigh * z184;
    const Scalar z215 = c_front_right_thigh * z194 + s_front_right_thigh * z193;
    const Scalar z228 = z17 * z225 - z180 * z226;
    const Scalar z221 = z17 * z213 - z198 - z180 * z214;  // velocity of front_right_thigh_link, x
    const Scalar z222 = z19 * z213 - z199 - z182 * z214;  // velocity of front_right_thigh_link, y
    const Scalar z223 = z29 * z213 - z200 - z184 * z214;  // velocity of front_right_thigh_link, z
    const Scalar z216 = s_front_right_thigh * z194 - c_front_right_thigh * z193;
    const Scalar z207 = n0_08 * z179;
    const Scalar z208 = n0_08 * z181;
    const Scalar z209 = n0_08 * z183;
    const Scalar z205 = z29 * c_front_right_thigh + s_front_right_thigh * z184;
    const Scalar z227 = z17 * z226 + z180 * z225;
    const Scalar z210 = z188 - z207;  // place of front_right_thigh_link, x
    const Scalar z211 = z189 - z208;  // place of front_right_thigh_link, y
    const Scalar z212 = z190 - z209;  // place of front_right_thigh_link, z
    const Scalar z165 = z139 - z162;  // place of front_left_shank_link, x
    const Scalar z229 = z19 * z226 + z182 * z225;
    const Scalar z166 = z140 - z163;  // place of front_left_shank_link, y
    const Scalar z230 = z19 * z225 - z182 * z226;
    const Scalar z167 = z141 - z164;  // place of front_left_shank_link, z
    const Scalar z244 = v_front_right_knee * z179 + z218;  // angular velocity of front_right_shank_link, x
    const Scalar z245 = v_front_right_knee * z181 + z219;  // angular velocity of front_right_shank_link, y
    const Scalar z246 = v_front_right_knee * z183 + z220;  // angular velocity of front_right_shank_link, z
    const Scalar z241 = s_front_right_knee * z216 - c_front_right_knee * z215;
    const Scalar z261 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z251 = z18 * s_rear_left_hip - z30 * c_rear_left_hip;
    const Scalar z253 = z23 * s_rear_left_hip - z24 * c_rear_left_hip;
    const Scalar z255 = z25 * s_rear_left_hip - z28 * c_rear_left_hip;
    const Scalar z265 = v_trunk_x - z18 * z119 + z30 * z191 - z17 * z118;  // velocity of rear_left_hip_link, x
    const Scalar z266 = v_trunk_y - z19 * z118 - z23 * z119 + z24 * z191;  // velocity of rear_left_hip_link, y
    const Scalar z267 = v_trunk_z - z25 * z119 + z28 * z191 - z29 * z118;  // velocity of rear_left_hip_link, z
    const Scalar z281 = n0_08 * z261;
    const Scalar z260 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z280 = n0_08 * z260;
    const Scalar z232 = z29 * z225 - z184 * z226;
    const Scalar z269 = z17 * s_rear_left_thigh - c_rear_left_thigh * z251;
    const Scalar z271 = z19 * s_rear_left_thigh - c_rear_left_thigh * z253;
    const Scalar z273 = z29 * s_rear_left_thigh - c_rear_left_thigh * z255;
    const Scalar z282 = c_rear_left_thigh * z261 + s_rear_left_thigh * z260;
    const Scalar z259 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z284 = v_rear_left_thigh + z259;
    const Scalar z233 = n0_2 * z202;
    const Scalar z234 = n0_2 * z204;
    const Scalar z235 = n0_2 * z206;
    const Scalar z240 = n0_2 * z215;
    const Scalar z250 = z18 * c_rear_left_hip + z30 * s_rear_left_hip;
    const Scalar z252 = z23 * c_rear_left_hip + z24 * s_rear_left_hip;
    const Scalar z254 = z25 * c_rear_left_hip + z28 * s_rear_left_hip;
    const Scalar z288 = z265 - z251 * z281 + z17 * z280;  // velocity of rear_left_thigh_link, x
    const Scalar z289 = z266 - z253 * z281 + z19 * z280;  // velocity of rear_left_thigh_link, y
    const Scalar z290 = z267 - z255 * z281 + z29 * z280;  // velocity of rear_left_thigh_link, z
    const Scalar z283 = s_rear_left_thigh * z261 - c_rear_left_thigh * z260;
    const Scalar z274 = n0_08 * z250;
    const Scalar z275 = n0_08 * z252;
    const Scalar z276 = n0_08 * z254;
    const Scalar z239 = n0_2 * z217;
    const Scalar z268 = z17 * c_rear_left_thigh + s_rear_left_thigh * z251;
    const Scalar z270 = z19 * c_rear_left_thigh + s_rear_left_thigh * z253;
    const Scalar z272 = z29 * c_rear_left_thigh + s_rear_left_thigh * z255;
    const Scalar z243 = v_front_right_knee + z217;
    const Scalar z256 = q_trunk_x - z185;  // place of rear_left_hip_link, x
    const Scalar z257 = q_trunk_y - z186;  // place of rear_left_hip_link, y
    const Scalar z258 = q_trunk_z + z187;  // place of rear_left_hip_link, z
    const Scalar z231 = z29 * z226 + z184 * z225;
    const Scalar z295 = z17 * z292 - z251 * z293;
    const Scalar z297 = z19 * z292 - z253 * z293;
    const Scalar z299 = z29 * z292 - z255 * z293;
    const Scalar z247 = z179 * z240 - z221 - z201 * z239;  // velocity of front_right_shank_link, x
    const Scalar z248 = z181 * z240 - z222 - z203 * z239;  // velocity of front_right_shank_link, y
    const Scalar z249 = z183 * z240 - z223 - z205 * z239;  // velocity of front_right_shank_link, z
    const Scalar z262 = z17 * v_rear_left_hip + z103;  // angular velocity of rear_left_hip_link, x
    const Scalar z285 = v_rear_left_thigh * z250 + z262;  // angular velocity of rear_left_thigh_link, x
    const Scalar z263 = z19 * v_rear_left_hip + z104;  // angular velocity of rear_left_hip_link, y
    const Scalar z286 = v_rear_left_thigh * z252 + z263;  // angular velocity of rear_left_thigh_link, y
    const Scalar z264 = z29 * v_rear_left_hip + z105;  // angular velocity of rear_left_hip_link, z
    const Scalar z287 = v_rear_left_thigh * z254 + z264;  // angular velocity of rear_left_thigh_link, z
    const Scalar z294 = z17 * z293 + z251 * z292;
    const Scalar z296 = z19 * z293 + z253 * z292;
    const Scalar z298 = z29 * z293 + z255 * z292;
    const Scalar z277 = z256 + z274;  // place of rear_left_thigh_link, x
    const Scalar z278 = z257 + z275;  // place of rear_left_thigh_link, y
    const Scalar z279 = z258 + z276;  // place of rear_left_thigh_link, z
    const Scalar z236 = z210 - z233;  // place of front_right_shank_link, x
    const Scalar z300 = n0_2 * z269;
    const Scalar z237 = z211 - z234;  // place of front_right_shank_link, y
    const Scalar z301 = n0_2 * z271;
    const Scalar z238 = z212 - z235;  // place of front_right_shank_link, z
    const Scalar z311 = v_rear_left_knee * z250 + z285;  // angular velocity of rear_left_shank_link, x
    const Scalar z312 = v_rear_left_knee * z252 + z286;  // angular velocity of rear_left_shank_link, y
    const Scalar z313 = v_rear_left_knee * z254 + z287;  // angular velocity of rear_left_shank_link, z
    const Scalar z329 = z17 * v_rear_right_hip + z103;  // angular velocity of rear_right_hip_link, x
    const Scalar z330 = z19 * v_rear_right_hip + z104;  // angular velocity of rear_right_hip_link, y
    const Scalar z331 = z29 * v_rear_right_hip + z105;  // angular velocity of rear_right_hip_link, z
    const Scalar z308 = s_rear_left_knee * z283 - c_rear_left_knee * z282;
    const Scalar z327 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z328 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z332 = v_trunk_x - z18 * z119 - z30 * z120 + z17 * z118;  // velocity of rear_right_hip_link, x
    const Scalar z333 = v_trunk_y + z19 * z118 - z23 * z119 - z24 * z120;  // velocity of rear_right_hip_link, y
    const Scalar z334 = v_trunk_z - z25 * z119 - z28 * z120 + z29 * z118;  // velocity of rear_right_hip_link, z
    const Scalar z347 = n0_08 * z327;
    const Scalar z318 = z18 * s_rear_right_hip - z30 * c_rear_right_hip;
    const Scalar z320 = z23 * s_rear_right_hip - z24 * c_rear_right_hip;
    const Scalar z322 = z25 * s_rear_right_hip - z28 * c_rear_right_hip;
    const Scalar z348 = n0_08 * z328;
    const Scalar z336 = z17 * s_rear_right_thigh - c_rear_right_thigh * z318;
    const Scalar z338 = z19 * s_rear_right_thigh - c_rear_right_thigh * z320;
    const Scalar z340 = z29 * s_rear_right_thigh - c_rear_right_thigh * z322;
    const Scalar z349 = c_rear_right_thigh * z328 + s_rear_right_thigh * z327;
    const Scalar z362 = z17 * z359 - z318 * z360;
    const Scalar z364 = z19 * z359 - z320 * z360;
    const Scalar z326 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z351 = v_rear_right_thigh + z326;
    const Scalar z302 = n0_2 * z273;
    const Scalar z366 = z29 * z359 - z322 * z360;
    const Scalar z307 = n0_2 * z282;
    const Scalar z317 = z18 * c_rear_right_hip + z30 * s_rear_right_hip;
    const Scalar z352 = v_rear_right_thigh * z317 + z329;  // angular velocity of rear_right_thigh_link, x
    const Scalar z319 = z23 * c_rear_right_hip + z24 * s_rear_right_hip;
    const Scalar z353 = v_rear_right_thigh * z319 + z330;  // angular velocity of rear_right_thigh_link, y
    const Scalar z321 = z25 * c_rear_right_hip + z28 * s_rear_right_hip;
    const Scalar z354 = v_rear_right_thigh * z321 + z331;  // angular velocity of rear_right_thigh_link, z
    const Scalar z355 = z17 * z347 - z332 - z318 * z348;  // velocity of rear_right_thigh_link, x
    const Scalar z356 = z19 * z347 - z333 - z320 * z348;  // velocity of rear_right_thigh_link, y
    const Scalar z357 = z29 * z347 - z334 - z322 * z348;  // velocity of rear_right_thigh_link, z
    const Scalar z350 = s_rear_right_thigh * z328 - c_rear_right_thigh * z327;
    const Scalar z341 = n0_08 * z317;
    const Scalar z342 = n0_08 * z319;
    const Scalar z343 = n0_08 * z321;
    const Scalar z306 = n0_2 * z284;
    const Scalar z335 = z17 * c_rear_right_thigh + s_rear_right_thigh * z318;
    const Scalar z337 = z19 * c_rear_right_thigh + s_rear_right_thigh * z320;
    const Scalar z339 = z29 * c_rear_right_thigh + s_rear_right_thigh * z322;
    const Scalar z310 = v_rear_left_knee + z284;
    const Scalar z323 = q_trunk_x - z112;  // place of rear_right_hip_link, x
    const Scalar z324 = q_trunk_y - z113;  // place of rear_right_hip_link, y
    const Scalar z325 = q_trunk_z - z114;  // place of rear_right_hip_link, z
    const Scalar z314 = z288 + z250 * z307 - z268 * z306;  // velocity of rear_left_shank_link, x
    const Scalar z315 = z289 + z252 * z307 - z270 * z306;  // velocity of rear_left_shank_link, y
    const Scalar z316 = z290 + z254 * z307 - z272 * z306;  // velocity of rear_left_shank_link, z
    const Scalar z361 = z17 * z360 + z318 * z359;
    const Scalar z363 = z19 * z360 + z320 * z359;
    const Scalar z365 = z29 * z360 + z322 * z359;
    const Scalar z344 = z323 - z341;  // place of rear_right_thigh_link, x
    const Scalar z345 = z324 - z342;  // place of rear_right_thigh_link, y
    const Scalar z346 = z325 - z343;  // place of rear_right_thigh_link, z
    const Scalar z303 = z277 - z300;  // place of rear_left_shank_link, x
    const Scalar z367 = n0_2 * z336;
    const Scalar z304 = z278 - z301;  // place of rear_left_shank_link, y
    const Scalar z368 = n0_2 * z338;
    const Scalar z305 = z279 - z302;  // place of rear_left_shank_link, z
    const Scalar z378 = v_rear_right_knee * z317 + z352;  // angular velocity of rear_right_shank_link, x
    const Scalar z379 = v_rear_right_knee * z319 + z353;  // angular velocity of rear_right_shank_link, y
    const Scalar z380 = v_rear_right_knee * z321 + z354;  // angular velocity of rear_right_shank_link, z
    const Scalar z391 = n0_04 * z123;
    const Scalar z402 = n0_09 * z144;
    const Scalar z375 = s_rear_right_knee * z350 - c_rear_right_knee * z349;
    const Scalar z390 = n0_04 * z122;
    const Scalar z392 = z127 - z107 * z391 + z17 * z390;
    const Scalar z393 = z128 - z109 * z391 + z19 * z390;
    const Scalar z394 = z129 - z111 * z391 + z29 * z390;
    const Scalar z401 = n0_09 * z146;
    const Scalar z403 = z150 + z106 * z402 - z130 * z401;
    const Scalar z404 = z151 + z108 * z402 - z132 * z401;
    const Scalar z405 = z152 + z110 * z402 - z134 * z401;
    const Scalar z395 = n0_09 * z131;
    const Scalar z398 = z139 - z395;
    const Scalar z396 = n0_09 * z133;
    const Scalar z399 = z140 - z396;
    const Scalar z397 = n0_09 * z135;
    const Scalar z400 = z141 - z397;
    const Scalar z369 = n0_2 * z340;
    const Scalar z374 = n0_2 * z349;
    const Scalar z417 = n0_2 * z157;
    const Scalar z406 = n0_1 * z157;
    const Scalar z409 = z165 - z406;
    const Scalar z420 = z165 - z417;
    const Scalar z418 = n0_2 * z159;
    const Scalar z407 = n0_1 * z159;
    const Scalar z410 = z166 - z407;
    const Scalar z421 = z166 - z418;
    const Scalar z419 = n0_2 * z161;
    const Scalar z408 = n0_1 * z161;
    const Scalar z411 = z167 - z408;
    const Scalar z422 = z167 - z419;
    const Scalar z373 = n0_2 * z351;
    const Scalar z377 = v_rear_right_knee + z351;
    const Scalar z381 = z317 * z374 - z355 - z335 * z373;  // velocity of rear_right_shank_link, x
    const Scalar z382 = z319 * z374 - z356 - z337 * z373;  // velocity of rear_right_shank_link, y
    const Scalar z383 = z321 * z374 - z357 - z339 * z373;  // velocity of rear_right_shank_link, z
    const Scalar z412 = n0_1 * z172;
    const Scalar z423 = n0_2 * z172;
    const Scalar z413 = n0_1 * z170;
    const Scalar z424 = n0_2 * z170;
    const Scalar z414 = z156 * z412 - z176 + z106 * z413;
    const Scalar z425 = z156 * z423 - z176 + z106 * z424;
    const Scalar z415 = z158 * z412 - z177 + z108 * z413;
    const Scalar z416 = z160 * z412 - z178 + z110 * z413;
    const Scalar z426 = z158 * z423 - z177 + z108 * z424;
    const Scalar z427 = z160 * z423 - z178 + z110 * z424;
    const Scalar z370 = z344 - z367;  // place of rear_right_shank_link, x
    const Scalar z371 = z345 - z368;  // place of rear_right_shank_link, y
    const Scalar z372 = z346 - z369;  // place of rear_right_shank_link, z
    const Scalar z434 = n0_04 * z193;
    const Scalar z435 = n0_04 * z194;
    const Scalar z436 = z17 * z434 - z198 - z180 * z435;
    const Scalar z437 = z19 * z434 - z199 - z182 * z435;
    const Scalar z438 = z29 * z434 - z200 - z184 * z435;
    const Scalar z439 = n0_09 * z202;
    const Scalar z442 = z210 - z439;
    const Scalar z440 = n0_09 * z204;
    const Scalar z443 = z211 - z440;
    const Scalar z441 = n0_09 * z206;
    const Scalar z384 = n0_04 * z106;
    const Scalar z387 = z115 + z384;
    const Scalar z444 = z212 - z441;
    const Scalar z385 = n0_04 * z108;
    const Scalar z388 = z116 + z385;
    const Scalar z445 = n0_09 * z217;
    const Scalar z386 = n0_04 * z110;
    const Scalar z389 = z117 + z386;
    const Scalar z446 = n0_09 * z215;
    const Scalar z447 = z179 * z446 - z221 - z201 * z445;
    const Scalar z448 = z181 * z446 - z222 - z203 * z445;
    const Scalar z449 = z183 * z446 - z223 - z205 * z445;
    const Scalar z479 = n0_04 * z261;
    const Scalar z478 = n0_04 * z260;
    const Scalar z480 = z265 - z251 * z479 + z17 * z478;
    const Scalar z481 = z266 - z253 * z479 + z19 * z478;
    const Scalar z482 = z267 - z255 * z479 + z29 * z478;
    const Scalar z483 = n0_09 * z269;
    const Scalar z486 = z277 - z483;
    const Scalar z484 = n0_09 * z271;
    const Scalar z487 = z278 - z484;
    const Scalar z485 = n0_09 * z273;
    const Scalar z461 = n0_2 * z228;
    const Scalar z450 = n0_1 * z228;
    const Scalar z453 = z236 - z450;
    const Scalar z464 = z236 - z461;
    const Scalar z462 = n0_2 * z230;
    const Scalar z451 = n0_1 * z230;
    const Scalar z454 = z237 - z451;
    const Scalar z465 = z237 - z462;
    const Scalar z463 = n0_2 * z232;
    const Scalar z452 = n0_1 * z232;
    const Scalar z455 = z238 - z452;
    const Scalar z466 = z238 - z463;
    const Scalar z456 = n0_1 * z243;
    const Scalar z467 = n0_2 * z243;
    const Scalar z457 = n0_1 * z241;
    const Scalar z468 = n0_2 * z241;
    const Scalar z458 = z227 * z456 - z247 + z179 * z457;
    const Scalar z469 = z227 * z467 - z247 + z179 * z468;
    const Scalar z459 = z229 * z456 - z248 + z181 * z457;
    const Scalar z460 = z231 * z456 - z249 + z183 * z457;
    const Scalar z470 = z229 * z467 - z248 + z181 * z468;
    const Scalar z471 = z231 * z467 - z249 + z183 * z468;
    const Scalar z428 = n0_04 * z179;
    const Scalar z431 = z188 - z428;
    const Scalar z488 = z279 - z485;
    const Scalar z429 = n0_04 * z181;
    const Scalar z432 = z189 - z429;
    const Scalar z489 = n0_09 * z284;
    const Scalar z430 = n0_04 * z183;
    const Scalar z433 = z190 - z430;
    const Scalar z490 = n0_09 * z282;
    const Scalar z491 = z288 + z250 * z490 - z268 * z489;
    const Scalar z492 = z289 + z252 * z490 - z270 * z489;
    const Scalar z493 = z290 + z254 * z490 - z272 * z489;
    const Scalar z522 = n0_04 * z327;
    const Scalar z523 = n0_04 * z328;
    const Scalar z524 = z17 * z522 - z332 - z318 * z523;
    const Scalar z525 = z19 * z522 - z333 - z320 * z523;
    const Scalar z526 = z29 * z522 - z334 - z322 * z523;
    const Scalar z527 = n0_09 * z336;
    const Scalar z530 = z344 - z527;
    const Scalar z528 = n0_09 * z338;
    const Scalar z531 = z345 - z528;
    const Scalar z529 = n0_09 * z340;
    const Scalar z505 = n0_2 * z295;
    const Scalar z494 = n0_1 * z295;
    const Scalar z497 = z303 - z494;
    const Scalar z508 = z303 - z505;
    const Scalar z506 = n0_2 * z297;
    const Scalar z495 = n0_1 * z297;
    const Scalar z498 = z304 - z495;
    const Scalar z509 = z304 - z506;
    const Scalar z507 = n0_2 * z299;
    const Scalar z496 = n0_1 * z299;
    const Scalar z499 = z305 - z496;
    const Scalar z510 = z305 - z507;
    const Scalar z500 = n0_1 * z310;
    const Scalar z511 = n0_2 * z310;
    const Scalar z501 = n0_1 * z308;
    const Scalar z512 = n0_2 * z308;
    const Scalar z502 = z294 * z500 - z314 + z250 * z501;
    const Scalar z513 = z294 * z511 - z314 + z250 * z512;
    const Scalar z503 = z296 * z500 - z315 + z252 * z501;
    const Scalar z504 = z298 * z500 - z316 + z254 * z501;
    const Scalar z514 = z296 * z511 - z315 + z252 * z512;
    const Scalar z515 = z298 * z511 - z316 + z254 * z512;
    const Scalar z472 = n0_04 * z250;
    const Scalar z475 = z256 + z472;
    const Scalar z532 = z346 - z529;
    const Scalar z473 = n0_04 * z252;
    const Scalar z476 = z257 + z473;
    const Scalar z533 = n0_09 * z351;
    const Scalar z474 = n0_04 * z254;
    const Scalar z477 = z258 + z474;
    const Scalar z563 = z162 + z417;
    const Scalar z564 = z163 + z418;
    const Scalar z565 = z164 + z419;
    const Scalar z569 = z136 - z563;
    const Scalar z570 = z137 - z564;
    const Scalar z571 = z138 - z565;
    const Scalar z534 = n0_09 * z349;
    const Scalar z535 = z317 * z534 - z355 - z335 * z533;
    const Scalar z536 = z319 * z534 - z356 - z337 * z533;
    const Scalar z537 = z321 * z534 - z357 - z339 * z533;
    const Scalar z560 = z108 * z419 - z110 * z418;
    const Scalar z561 = z106 * z419 - z110 * z417;
    const Scalar z562 = z106 * z418 - z108 * z417;
    const Scalar z566 = z108 * z565 - z110 * z564;
    const Scalar z567 = z106 * z565 - z110 * z563;
    const Scalar z568 = z106 * z564 - z108 * z563;
    const Scalar z572 = z19 * z571 - z29 * z570;
    const Scalar z573 = z17 * z571 - z29 * z569;
    const Scalar z574 = z17 * z570 - z19 * z569;
    const Scalar z575 = z112 + z569;
    const Scalar z549 = n0_2 * z362;
    const Scalar z538 = n0_1 * z362;
    const Scalar z541 = z370 - z538;
    const Scalar z552 = z370 - z549;
    const Scalar z550 = n0_2 * z364;
    const Scalar z539 = n0_1 * z364;
    const Scalar z542 = z371 - z539;
    const Scalar z553 = z371 - z550;
    const Scalar z551 = n0_2 * z366;
    const Scalar z540 = n0_1 * z366;
    const Scalar z543 = z372 - z540;
    const Scalar z554 = z372 - z551;
    const Scalar z544 = n0_1 * z377;
    const Scalar z555 = n0_2 * z377;
    const Scalar z545 = n0_1 * z375;
    const Scalar z556 = n0_2 * z375;
    const Scalar z546 = z361 * z544 - z381 + z317 * z545;
    const Scalar z557 = z361 * z555 - z381 + z317 * z556;
    const Scalar z547 = z363 * z544 - z382 + z319 * z545;
    const Scalar z548 = z365 * z544 - z383 + z321 * z545;
    const Scalar z558 = z363 * z555 - z382 + z319 * z556;
    const Scalar z559 = z365 * z555 - z383 + z321 * z556;
    const Scalar z516 = n0_04 * z317;
    const Scalar z519 = z323 - z516;
    const Scalar z576 = z113 + z570;
    const Scalar z517 = n0_04 * z319;
    const Scalar z520 = z324 - z517;
    const Scalar z577 = z114 + z571;
    const Scalar z518 = n0_04 * z321;
    const Scalar z521 = z325 - z518;
    const Scalar z593 = z233 + z461;
    const Scalar z594 = z234 + z462;
    const Scalar z595 = z235 + z463;
    const Scalar z623 = z300 + z505;
    const Scalar z624 = z301 + z506;
    const Scalar z625 = z302 + z507;
    const Scalar z599 = z207 + z593;
    const Scalar z600 = z208 + z594;
    const Scalar z601 = z209 + z595;
    const Scalar z629 = z274 - z623;
    const Scalar z630 = z275 - z624;
    const Scalar z631 = z276 - z625;
    const Scalar z578 = z24 * z577 - z28 * z576;
    const Scalar z579 = z28 * z575 - z30 * z577;
    const Scalar z580 = z24 * z575 - z30 * z576;
    const Scalar z581 = z23 * z577 - z25 * z576;
    const Scalar z582 = z18 * z577 - z25 * z575;
    const Scalar z583 = z18 * z576 - z23 * z575;
    const Scalar z584 = z19 * z577 - z29 * z576;
    const Scalar z585 = z17 * z577 - z29 * z575;
    const Scalar z586 = z17 * z576 - z19 * z575;
    const Scalar z653 = z367 + z549;
    const Scalar z654 = z368 + z550;
    const Scalar z655 = z369 + z551;
    const Scalar z590 = z181 * z463 - z183 * z462;
    const Scalar z591 = z179 * z463 - z183 * z461;
    const Scalar z592 = z179 * z462 - z181 * z461;
    const Scalar z659 = z341 + z653;
    const Scalar z660 = z342 + z654;
    const Scalar z661 = z343 + z655;
    const Scalar z596 = z181 * z595 - z183 * z594;
    const Scalar z597 = z179 * z595 - z183 * z593;
    const Scalar z598 = z179 * z594 - z181 * z593;
    const Scalar z665 = z112 + z659;
    const Scalar z666 = z113 + z660;
    const Scalar z667 = z114 + z661;
    const Scalar z602 = z19 * z601 - z29 * z600;
    const Scalar z603 = z17 * z601 - z29 * z599;
    const Scalar z607 = z187 + z601;
    const Scalar z637 = z187 + z631;
    const Scalar z604 = z17 * z600 - z19 * z599;
    const Scalar z605 = z185 - z599;
    const Scalar z606 = z186 - z600;
    const Scalar z635 = z185 - z629;
    const Scalar z636 = z186 - z630;
    const Scalar z608 = z24 * z607 + z28 * z606;
    const Scalar z609 = z28 * z605 + z30 * z607;
    const Scalar z610 = z24 * z605 - z30 * z606;
    const Scalar z611 = z23 * z607 + z25 * z606;
    const Scalar z612 = z18 * z607 + z25 * z605;
    const Scalar z613 = z18 * z606 - z23 * z605;
    const Scalar z614 = z19 * z607 + z29 * z606;
    const Scalar z615 = z17 * z607 + z29 * z605;
    const Scalar z616 = z17 * z606 - z19 * z605;
    const Scalar z620 = z252 * z507 - z254 * z506;
    const Scalar z621 = z250 * z507 - z254 * z505;
    const Scalar z622 = z250 * z506 - z252 * z505;
    const Scalar z626 = z252 * z625 - z254 * z624;
    const Scalar z627 = z250 * z625 - z254 * z623;
    const Scalar z628 = z250 * z624 - z252 * z623;
    const Scalar z632 = z19 * z631 - z29 * z630;
    const Scalar z633 = z17 * z631 - z29 * z629;
    const Scalar z634 = z17 * z630 - z19 * z629;
    const Scalar z638 = z24 * z637 + z28 * z636;
    const Scalar z639 = z28 * z635 + z30 * z637;
    const Scalar z640 = z24 * z635 - z30 * z636;
    const Scalar z641 = z23 * z637 + z25 * z636;
    const Scalar z642 = z18 * z637 + z25 * z635;
    const Scalar z643 = z18 * z636 - z23 * z635;
    const Scalar z644 = z19 * z637 + z29 * z636;
    const Scalar z645 = z17 * z637 + z29 * z635;
    const Scalar z646 = z17 * z636 - z19 * z635;
    const Scalar z650 = z319 * z551 - z321 * z550;
    const Scalar z651 = z317 * z551 - z321 * z549;
    const Scalar z652 = z317 * z550 - z319 * z549;
    const Scalar z656 = z319 * z655 - z321 * z654;
    const Scalar z657 = z317 * z655 - z321 * z653;
    const Scalar z658 = z317 * z654 - z319 * z653;
    const Scalar z662 = z19 * z661 - z29 * z660;
    const Scalar z663 = z17 * z661 - z29 * z659;
    const Scalar z664 = z17 * z660 - z19 * z659;
    const Scalar z668 = z24 * z667 - z28 * z666;
    const Scalar z669 = z28 * z665 - z30 * z667;
    const Scalar z670 = z24 * z665 - z30 * z666;
    const Scalar z671 = z23 * z667 - z25 * z666;
    const Scalar z672 = z18 * z667 - z25 * z665;
    const Scalar z673 = z18 * z666 - z23 * z665;
    const Scalar z674 = z19 * z667 - z29 * z666;
    const Scalar z675 = z17 * z667 - z29 * z665;
    const Scalar z676 = z17 * z666 - z19 * z665;
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
    result.trunk_velocity[0] = v_trunk_x;
    result.trunk_velocity[1] = v_trunk_y;
    result.trunk_velocity[2] = v_trunk_z;
    result.trunk_angular_velocity[0] = z103;
    result.trunk_angular_velocity[1] = z104;
    result.trunk_angular_velocity[2] = z105;
    result.front_left_hip_link_position[0] = z387;
    result.front_left_hip_link_position[1] = z388;
    result.front_left_hip_link_position[2] = z389;
    result.front_left_hip_link_rotation[0] = z17;
    result.front_left_hip_link_rotation[1] = z19;
    result.front_left_hip_link_rotation[2] = z29;
    result.front_left_hip_link_rotation[3] = z106;
    result.front_left_hip_link_rotation[4] = z108;
    result.front_left_hip_link_rotation[5] = z110;
    result.front_left_hip_link_rotation[6] = -z107;
    result.front_left_hip_link_rotation[7] = -z109;
    result.front_left_hip_link_rotation[8] = -z111;
    result.front_left_hip_link_velocity[0] = z392;
    result.front_left_hip_link_velocity[1] = z393;
    result.front_left_hip_link_velocity[2] = z394;
    result.front_left_hip_link_angular_velocity[0] = z124;
    result.front_left_hip_link_angular_velocity[1] = z125;
    result.front_left_hip_link_angular_velocity[2] = z126;
    result.front_left_thigh_link_position[0] = z398;
    result.front_left_thigh_link_position[1] = z399;
    result.front_left_thigh_link_position[2] = z400;
    result.front_left_thigh_link_rotation[0] = z130;
    result.front_left_thigh_link_rotation[1] = z132;
    result.front_left_thigh_link_rotation[2] = z134;
    result.front_left_thigh_link_rotation[3] = z106;
    result.front_left_thigh_link_rotation[4] = z108;
    result.front_left_thigh_link_rotation[5] = z110;
    result.front_left_thigh_link_rotation[6] = z131;
    result.front_left_thigh_link_rotation[7] = z133;
    result.front_left_thigh_link_rotation[8] = z135;
    result.front_left_thigh_link_velocity[0] = z403;
    result.front_left_thigh_link_velocity[1] = z404;
    result.front_left_thigh_link_velocity[2] = z405;
    result.front_left_thigh_link_angular_velocity[0] = z147;
    result.front_left_thigh_link_angular_velocity[1] = z148;
    result.front_left_thigh_link_angular_velocity[2] = z149;
    result.front_left_shank_link_position[0] = z409;
    result.front_left_shank_link_position[1] = z410;
    result.front_left_shank_link_position[2] = z411;
    result.front_left_shank_link_rotation[0] = z156;
    result.front_left_shank_link_rotation[1] = z158;
    result.front_left_shank_link_rotation[2] = z160;
    result.front_left_shank_link_rotation[3] = z106;
    result.front_left_shank_link_rotation[4] = z108;
    result.front_left_shank_link_rotation[5] = z110;
    result.front_left_shank_link_rotation[6] = z157;
    result.front_left_shank_link_rotation[7] = z159;
    result.front_left_shank_link_rotation[8] = z161;
    result.front_left_shank_link_velocity[0] = -z414;
    result.front_left_shank_link_velocity[1] = -z415;
    result.front_left_shank_link_velocity[2] = -z416;
    result.front_left_shank_link_angular_velocity[0] = z173;
    result.front_left_shank_link_angular_velocity[1] = z174;
    result.front_left_shank_link_angular_velocity[2] = z175;
    result.front_left_foot_position[0] = z420;
    result.front_left_foot_position[1] = z421;
    result.front_left_foot_position[2] = z422;
    result.front_left_foot_rotation[0] = z156;
    result.front_left_foot_rotation[1] = z158;
    result.front_left_foot_rotation[2] = z160;
    result.front_left_foot_rotation[3] = z106;
    result.front_left_foot_rotation[4] = z108;
    result.front_left_foot_rotation[5] = z110;
    result.front_left_foot_rotation[6] = z157;
    result.front_left_foot_rotation[7] = z159;
    result.front_left_foot_rotation[8] = z161;
    result.front_left_foot_velocity[0] = -z425;
    result.front_left_foot_velocity[1] = -z426;
    result.front_left_foot_velocity[2] = -z427;
    result.front_left_foot_angular_velocity[0] = z173;
    result.front_left_foot_angular_velocity[1] = z174;
    result.front_left_foot_angular_velocity[2] = z175;
    result.front_right_hip_link_position[0] = z431;
    result.front_right_hip_link_position[1] = z432;
    result.front_right_hip_link_position[2] = z433;
    result.front_right_hip_link_rotation[0] = z17;
    result.front_right_hip_link_rotation[1] = z19;
    result.front_right_hip_link_rotation[2] = z29;
    result.front_right_hip_link_rotation[3] = z179;
    result.front_right_hip_link_rotation[4] = z181;
    result.front_right_hip_link_rotation[5] = z183;
    result.front_right_hip_link_rotation[6] = -z180;
    result.front_right_hip_link_rotation[7] = -z182;
    result.front_right_hip_link_rotation[8] = -z184;
    result.front_right_hip_link_velocity[0] = -z436;
    result.front_right_hip_link_velocity[1] = -z437;
    result.front_right_hip_link_velocity[2] = -z438;
    result.front_right_hip_link_angular_velocity[0] = z195;
    result.front_right_hip_link_angular_velocity[1] = z196;
    result.front_right_hip_link_angular_velocity[2] = z197;
    result.front_right_thigh_link_position[0] = z442;
    result.front_right_thigh_link_position[1] = z443;
    result.front_right_thigh_link_position[2] = z444;
    result.front_right_thigh_link_rotation[0] = z201;
    result.front_right_thigh_link_rotation[1] = z203;
    result.front_right_thigh_link_rotation[2] = z205;
    result.front_right_thigh_link_rotation[3] = z179;
    result.front_right_thigh_link_rotation[4] = z181;
    result.front_right_thigh_link_rotation[5] = z183;
    result.front_right_thigh_link_rotation[6] = z202;
    result.front_right_thigh_link_rotation[7] = z204;
    result.front_right_thigh_link_rotation[8] = z206;
    result.front_right_thigh_link_velocity[0] = z447;
    result.front_right_thigh_link_velocity[1] = z448;
    result.front_right_thigh_link_velocity[2] = z449;
    result.front_right_thigh_link_angular_velocity[0] = z218;
    result.front_right_thigh_link_angular_velocity[1] = z219;
    result.front_right_thigh_link_angular_velocity[2] = z220;
    result.front_right_shank_link_position[0] = z453;
    result.front_right_shank_link_position[1] = z454;
    result.front_right_shank_link_position[2] = z455;
    result.front_right_shank_link_rotation[0] = z227;
    result.front_right_shank_link_rotation[1] = z229;
    result.front_right_shank_link_rotation[2] = z231;
    result.front_right_shank_link_rotation[3] = z179;
    result.front_right_shank_link_rotation[4] = z181;
    result.front_right_shank_link_rotation[5] = z183;
    result.front_right_shank_link_rotation[6] = z228;
    result.front_right_shank_link_rotation[7] = z230;
    result.front_right_shank_link_rotation[8] = z232;
    result.front_right_shank_link_velocity[0] = -z458;
    result.front_right_shank_link_velocity[1] = -z459;
    result.front_right_shank_link_velocity[2] = -z460;
    result.front_right_shank_link_angular_velocity[0] = z244;
    result.front_right_shank_link_angular_velocity[1] = z245;
    result.front_right_shank_link_angular_velocity[2] = z246;
    result.front_right_foot_position[0] = z464;
    result.front_right_foot_position[1] = z465;
    result.front_right_foot_position[2] = z466;
    result.front_right_foot_rotation[0] = z227;
    result.front_right_foot_rotation[1] = z229;
    result.front_right_foot_rotation[2] = z231;
    result.front_right_foot_rotation[3] = z179;
    result.front_right_foot_rotation[4] = z181;
    result.front_right_foot_rotation[5] = z183;
    result.front_right_foot_rotation[6] = z228;
    result.front_right_foot_rotation[7] = z230;
    result.front_right_foot_rotation[8] = z232;
    result.front_right_foot_velocity[0] = -z469;
    result.front_right_foot_velocity[1] = -z470;
    result.front_right_foot_velocity[2] = -z471;
    result.front_right_foot_angular_velocity[0] = z244;
    result.front_right_foot_angular_velocity[1] = z245;
    result.front_right_foot_angular_velocity[2] = z246;
    result.rear_left_hip_link_position[0] = z475;
    result.rear_left_hip_link_position[1] = z476;
    result.rear_left_hip_link_position[2] = z477;
    result.rear_left_hip_link_rotation[0] = z17;
    result.rear_left_hip_link_rotation[1] = z19;
    result.rear_left_hip_link_rotation[2] = z29;
    result.rear_left_hip_link_rotation[3] = z250;
    result.rear_left_hip_link_rotation[4] = z252;
    result.rear_left_hip_link_rotation[5] = z254;
    result.rear_left_hip_link_rotation[6] = -z251;
    result.rear_left_hip_link_rotation[7] = -z253;
    result.rear_left_hip_link_rotation[8] = -z255;
    result.rear_left_hip_link_velocity[0] = z480;
    result.rear_left_hip_link_velocity[1] = z481;
    result.rear_left_hip_link_velocity[2] = z482;
    result.rear_left_hip_link_angular_velocity[0] = z262;
    result.rear_left_hip_link_angular_velocity[1] = z263;
    result.rear_left_hip_link_angular_velocity[2] = z264;
    result.rear_left_thigh_link_position[0] = z486;
    result.rear_left_thigh_link_position[1] = z487;
    result.rear_left_thigh_link_position[2] = z488;
    result.rear_left_thigh_link_rotation[0] = z268;
    result.rear_left_thigh_link_rotation[1] = z270;
    result.rear_left_thigh_link_rotation[2] = z272;
    result.rear_left_thigh_link_rotation[3] = z250;
    result.rear_left_thigh_link_rotation[4] = z252;
    result.rear_left_thigh_link_rotation[5] = z254;
    result.rear_left_thigh_link_rotation[6] = z269;
    result.rear_left_thigh_link_rotation[7] = z271;
    result.rear_left_thigh_link_rotation[8] = z273;
    result.rear_left_thigh_link_velocity[0] = z491;
    result.rear_left_thigh_link_velocity[1] = z492;
    result.rear_left_thigh_link_velocity[2] = z493;
    result.rear_left_thigh_link_angular_velocity[0] = z285;
    result.rear_left_thigh_link_angular_velocity[1] = z286;
    result.rear_left_thigh_link_angular_velocity[2] = z287;
    result.rear_left_shank_link_position[0] = z497;
    result.rear_left_shank_link_position[1] = z498;
    result.rear_left_shank_link_position[2] = z499;
    result.rear_left_shank_link_rotation[0] = z294;
    result.rear_left_shank_link_rotation[1] = z296;
    result.rear_left_shank_link_rotation[2] = z298;
    result.rear_left_shank_link_rotation[3] = z250;
    result.rear_left_shank_link_rotation[4] = z252;
    result.rear_left_shank_link_rotation[5] = z254;
    result.rear_left_shank_link_rotation[6] = z295;
    result.rear_left_shank_link_rotation[7] = z297;
    result.rear_left_shank_link_rotation[8] = z299;
    result.rear_left_shank_link_velocity[0] = -z502;
    result.rear_left_shank_link_velocity[1] = -z503;
    result.rear_left_shank_link_velocity[2] = -z504;
    result.rear_left_shank_link_angular_velocity[0] = z311;
    result.rear_left_shank_link_angular_velocity[1] = z312;
    result.rear_left_shank_link_angular_velocity[2] = z313;
    result.rear_left_foot_position[0] = z508;
    result.rear_left_foot_position[1] = z509;
    result.rear_left_foot_position[2] = z510;
    result.rear_left_foot_rotation[0] = z294;
    result.rear_left_foot_rotation[1] = z296;
    result.rear_left_foot_rotation[2] = z298;
    result.rear_left_foot_rotation[3] = z250;
    result.rear_left_foot_rotation[4] = z252;
    result.rear_left_foot_rotation[5] = z254;
    result.rear_left_foot_rotation[6] = z295;
    result.rear_left_foot_rotation[7] = z297;
    result.rear_left_foot_rotation[8] = z299;
    result.rear_left_foot_velocity[0] = -z513;
    result.rear_left_foot_velocity[1] = -z514;
    result.rear_left_foot_velocity[2] = -z515;
    result.rear_left_foot_angular_velocity[0] = z311;
    result.rear_left_foot_angular_velocity[1] = z312;
    result.rear_left_foot_angular_velocity[2] = z313;
    result.rear_right_hip_link_position[0] = z519;
    result.rear_right_hip_link_position[1] = z520;
    result.rear_right_hip_link_position[2] = z521;
    result.rear_right_hip_link_rotation[0] = z17;
    result.rear_right_hip_link_rotation[1] = z19;
    result.rear_right_hip_link_rotation[2] = z29;
    result.rear_right_hip_link_rotation[3] = z317;
    result.rear_right_hip_link_rotation[4] = z319;
    result.rear_right_hip_link_rotation[5] = z321;
    result.rear_right_hip_link_rotation[6] = -z318;
    result.rear_right_hip_link_rotation[7] = -z320;
    result.rear_right_hip_link_rotation[8] = -z322;
    result.rear_right_hip_link_velocity[0] = -z524;
    result.rear_right_hip_link_velocity[1] = -z525;
    result.rear_right_hip_link_velocity[2] = -z526;
    result.rear_right_hip_link_angular_velocity[0] = z329;
    result.rear_right_hip_link_angular_velocity[1] = z330;
    result.rear_right_hip_link_angular_velocity[2] = z331;
    result.rear_right_thigh_link_position[0] = z530;
    result.rear_right_thigh_link_position[1] = z531;
    result.rear_right_thigh_link_position[2] = z532;
    result.rear_right_thigh_link_rotation[0] = z335;
    result.rear_right_thigh_link_rotation[1] = z337;
    result.rear_right_thigh_link_rotation[2] = z339;
    result.rear_right_thigh_link_rotation[3] = z317;
    result.rear_right_thigh_link_rotation[4] = z319;
    result.rear_right_thigh_link_rotation[5] = z321;
    result.rear_right_thigh_link_rotation[6] = z336;
    result.rear_right_thigh_link_rotation[7] = z338;
    result.rear_right_thigh_link_rotation[8] = z340;
    result.rear_right_thigh_link_velocity[0] = z535;
    result.rear_right_thigh_link_velocity[1] = z536;
    result.rear_right_thigh_link_velocity[2] = z537;
    result.rear_right_thigh_link_angular_velocity[0] = z352;
    result.rear_right_thigh_link_angular_velocity[1] = z353;
    result.rear_right_thigh_link_angular_velocity[2] = z354;
    result.rear_right_shank_link_position[0] = z541;
    result.rear_right_shank_link_position[1] = z542;
    result.rear_right_shank_link_position[2] = z543;
    result.rear_right_shank_link_rotation[0] = z361;
    result.rear_right_shank_link_rotation[1] = z363;
    result.rear_right_shank_link_rotation[2] = z365;
    result.rear_right_shank_link_rotation[3] = z317;
    result.rear_right_shank_link_rotation[4] = z319;
    result.rear_right_shank_link_rotation[5] = z321;
    result.rear_right_shank_link_rotation[6] = z362;
    result.rear_right_shank_link_rotation[7] = z364;
    result.rear_right_shank_link_rotation[8] = z366;
    result.rear_right_shank_link_velocity[0] = -z546;
    result.rear_right_shank_link_velocity[1] = -z547;
    result.rear_right_shank_link_velocity[2] = -z548;
    result.rear_right_shank_link_angular_velocity[0] = z378;
    result.rear_right_shank_link_angular_velocity[1] = z379;
    result.rear_right_shank_link_angular_velocity[2] = z380;
    result.rear_right_foot_position[0] = z552;
    result.rear_right_foot_position[1] = z553;
    result.rear_right_foot_position[2] = z554;
    result.rear_right_foot_rotation[0] = z361;
    result.rear_right_foot_rotation[1] = z363;
    result.rear_right_foot_rotation[2] = z365;
    result.rear_right_foot_rotation[3] = z317;
    result.rear_right_foot_rotation[4] = z319;
    result.rear_right_foot_rotation[5] = z321;
    result.rear_right_foot_rotation[6] = z362;
    result.rear_right_foot_rotation[7] = z364;
    result.rear_right_foot_rotation[8] = z366;
    result.rear_right_foot_velocity[0] = -z557;
    result.rear_right_foot_velocity[1] = -z558;
    result.rear_right_foot_velocity[2] = -z559;
    result.rear_right_foot_angular_velocity[0] = z378;
    result.rear_right_foot_angular_velocity[1] = z379;
    result.rear_right_foot_angular_velocity[2] = z380;
    result.front_left_foot_origin_position[0] = z420;
    result.front_left_foot_origin_position[1] = z421;
    result.front_left_foot_origin_position[2] = z422;
    result.front_left_foot_origin_velocity[0] = -z425;
    result.front_left_foot_origin_velocity[1] = -z426;
    result.front_left_foot_origin_velocity[2] = -z427;
    result.front_left_foot_origin_jacobian[0] = n1;
    result.front_left_foot_origin_jacobian[3] = n0;
    result.front_left_foot_origin_jacobian[6] = n0;
    result.front_left_foot_origin_jacobian[9] = z584;
    result.front_left_foot_origin_jacobian[12] = z581;
    result.front_left_foot_origin_jacobian[15] = z578;
    result.front_left_foot_origin_jacobian[18] = z572;
    result.front_left_foot_origin_jacobian[21] = -z566;
    result.front_left_foot_origin_jacobian[24] = -z560;
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
    result.front_left_foot_origin_jacobian[10] = -z585;
    result.front_left_foot_origin_jacobian[13] = -z582;
    result.front_left_foot_origin_jacobian[16] = z579;
    result.front_left_foot_origin_jacobian[19] = -z573;
    result.front_left_foot_origin_jacobian[22] = z567;
    result.front_left_foot_origin_jacobian[25] = z561;
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
    result.front_left_foot_origin_jacobian[11] = z586;
    result.front_left_foot_origin_jacobian[14] = z583;
    result.front_left_foot_origin_jacobian[17] = -z580;
    result.front_left_foot_origin_jacobian[20] = z574;
    result.front_left_foot_origin_jacobian[23] = -z568;
    result.front_left_foot_origin_jacobian[26] = -z562;
    result.front_left_foot_origin_jacobian[29] = n0;
    result.front_left_foot_origin_jacobian[32] = n0;
    result.front_left_foot_origin_jacobian[35] = n0;
    result.front_left_foot_origin_jacobian[38] = n0;
    result.front_left_foot_origin_jacobian[41] = n0;
    result.front_left_foot_origin_jacobian[44] = n0;
    result.front_left_foot_origin_jacobian[47] = n0;
    result.front_left_foot_origin_jacobian[50] = n0;
    result.front_left_foot_origin_jacobian[53] = n0;
    result.front_right_foot_origin_position[0] = z464;
    result.front_right_foot_origin_position[1] = z465;
    result.front_right_foot_origin_position[2] = z466;
    result.front_right_foot_origin_velocity[0] = -z469;
    result.front_right_foot_origin_velocity[1] = -z470;
    result.front_right_foot_origin_velocity[2] = -z471;
    result.front_right_foot_origin_jacobian[0] = n1;
    result.front_right_foot_origin_jacobian[3] = n0;
    result.front_right_foot_origin_jacobian[6] = n0;
    result.front_right_foot_origin_jacobian[9] = -z614;
    result.front_right_foot_origin_jacobian[12] = -z611;
    result.front_right_foot_origin_jacobian[15] = -z608;
    result.front_right_foot_origin_jacobian[18] = n0;
    result.front_right_foot_origin_jacobian[21] = n0;
    result.front_right_foot_origin_jacobian[24] = n0;
    result.front_right_foot_origin_jacobian[27] = -z602;
    result.front_right_foot_origin_jacobian[30] = -z596;
    result.front_right_foot_origin_jacobian[33] = -z590;
    result.front_right_foot_origin_jacobian[36] = n0;
    result.front_right_foot_origin_jacobian[39] = n0;
    result.front_right_foot_origin_jacobian[42] = n0;
    result.front_right_foot_origin_jacobian[45] = n0;
    result.front_right_foot_origin_jacobian[48] = n0;
    result.front_right_foot_origin_jacobian[51] = n0;
    result.front_right_foot_origin_jacobian[1] = n0;
    result.front_right_foot_origin_jacobian[4] = n1;
    result.front_right_foot_origin_jacobian[7] = n0;
    result.front_right_foot_origin_jacobian[10] = z615;
    result.front_right_foot_origin_jacobian[13] = z612;
    result.front_right_foot_origin_jacobian[16] = z609;
    result.front_right_foot_origin_jacobian[19] = n0;
    result.front_right_foot_origin_jacobian[22] = n0;
    result.front_right_foot_origin_jacobian[25] = n0;
    result.front_right_foot_origin_jacobian[28] = z603;
    result.front_right_foot_origin_jacobian[31] = z597;
    result.front_right_foot_origin_jacobian[34] = z591;
    result.front_right_foot_origin_jacobian[37] = n0;
    result.front_right_foot_origin_jacobian[40] = n0;
    result.front_right_foot_origin_jacobian[43] = n0;
    result.front_right_foot_origin_jacobian[46] = n0;
    result.front_right_foot_origin_jacobian[49] = n0;
    result.front_right_foot_origin_jacobian[52] = n0;
    result.front_right_foot_origin_jacobian[2] = n0;
    result.front_right_foot_origin_jacobian[5] = n0;
    result.front_right_foot_origin_jacobian[8] = n1;
    result.front_right_foot_origin_jacobian[11] = z616;
    result.front_right_foot_origin_jacobian[14] = z613;
    result.front_right_foot_origin_jacobian[17] = -z610;
    result.front_right_foot_origin_jacobian[20] = n0;
    result.front_right_foot_origin_jacobian[23] = n0;
    result.front_right_foot_origin_jacobian[26] = n0;
    result.front_right_foot_origin_jacobian[29] = -z604;
    result.front_right_foot_origin_jacobian[32] = -z598;
    result.front_right_foot_origin_jacobian[35] = -z592;
    result.front_right_foot_origin_jacobian[38] = n0;
    result.front_right_foot_origin_jacobian[41] = n0;
    result.front_right_foot_origin_jacobian[44] = n0;
    result.front_right_foot_origin_jacobian[47] = n0;
    result.front_right_foot_origin_jacobian[50] = n0;
    result.front_right_foot_origin_jacobian[53] = n0;
    result.rear_left_foot_origin_position[0] = z508;
    result.rear_left_foot_origin_position[1] = z509;
    result.rear_left_foot_origin_position[2] = z510;
    result.rear_left_foot_origin_velocity[0] = -z513;
    result.rear_left_foot_origin_velocity[1] = -z514;
    result.rear_left_foot_origin_velocity[2] = -z515;
    result.rear_left_foot_origin_jacobian[0] = n1;
    result.rear_left_foot_origin_jacobian[3] = n0;
    result.rear_left_foot_origin_jacobian[6] = n0;
    result.rear_left_foot_origin_jacobian[9] = z644;
    result.rear_left_foot_origin_jacobian[12] = z641;
    result.rear_left_foot_origin_jacobian[15] = z638;
    result.rear_left_foot_origin_jacobian[18] = n0;
    result.rear_left_foot_origin_jacobian[21] = n0;
    result.rear_left_foot_origin_jacobian[24] = n0;
    result.rear_left_foot_origin_jacobian[27] = n0;
    result.rear_left_foot_origin_jacobian[30] = n0;
    result.rear_left_foot_origin_jacobian[33] = n0;
    result.rear_left_foot_origin_jacobian[36] = z632;
    result.rear_left_foot_origin_jacobian[39] = -z626;
    result.rear_left_foot_origin_jacobian[42] = -z620;
    result.rear_left_foot_origin_jacobian[45] = n0;
    result.rear_left_foot_origin_jacobian[48] = n0;
    result.rear_left_foot_origin_jacobian[51] = n0;
    result.rear_left_foot_origin_jacobian[1] = n0;
    result.rear_left_foot_origin_jacobian[4] = n1;
    result.rear_left_foot_origin_jacobian[7] = n0;
    result.rear_left_foot_origin_jacobian[10] = -z645;
    result.rear_left_foot_origin_jacobian[13] = -z642;
    result.rear_left_foot_origin_jacobian[16] = -z639;
    result.rear_left_foot_origin_jacobian[19] = n0;
    result.rear_left_foot_origin_jacobian[22] = n0;
    result.rear_left_foot_origin_jacobian[25] = n0;
    result.rear_left_foot_origin_jacobian[28] = n0;
    result.rear_left_foot_origin_jacobian[31] = n0;
    result.rear_left_foot_origin_jacobian[34] = n0;
    result.rear_left_foot_origin_jacobian[37] = -z633;
    result.rear_left_foot_origin_jacobian[40] = z627;
    result.rear_left_foot_origin_jacobian[43] = z621;
    result.rear_left_foot_origin_jacobian[46] = n0;
    result.rear_left_foot_origin_jacobian[49] = n0;
    result.rear_left_foot_origin_jacobian[52] = n0;
    result.rear_left_foot_origin_jacobian[2] = n0;
    result.rear_left_foot_origin_jacobian[5] = n0;
    result.rear_left_foot_origin_jacobian[8] = n1;
    result.rear_left_foot_origin_jacobian[11] = -z646;
    result.rear_left_foot_origin_jacobian[14] = -z643;
    result.rear_left_foot_origin_jacobian[17] = z640;
    result.rear_left_foot_origin_jacobian[20] = n0;
    result.rear_left_foot_origin_jacobian[23] = n0;
    result.rear_left_foot_origin_jacobian[26] = n0;
    result.rear_left_foot_origin_jacobian[29] = n0;
    result.rear_left_foot_origin_jacobian[32] = n0;
    result.rear_left_foot_origin_jacobian[35] = n0;
    result.rear_left_foot_origin_jacobian[38] = z634;
    result.rear_left_foot_origin_jacobian[41] = -z628;
    result.rear_left_foot_origin_jacobian[44] = -z622;
    result.rear_left_foot_origin_jacobian[47] = n0;
    result.rear_left_foot_origin_jacobian[50] = n0;
    result.rear_left_foot_origin_jacobian[53] = n0;
    result.rear_right_foot_origin_position[0] = z552;
    result.rear_right_foot_origin_position[1] = z553;
    result.rear_right_foot_origin_position[2] = z554;
    result.rear_right_foot_origin_velocity[0] = -z557;
    result.rear_right_foot_origin_velocity[1] = -z558;
    result.rear_right_foot_origin_velocity[2] = -z559;
    result.rear_right_foot_origin_jacobian[0] = n1;
    result.rear_right_foot_origin_jacobian[3] = n0;
    result.rear_right_foot_origin_jacobian[6] = n0;
    result.rear_right_foot_origin_jacobian[9] = -z674;
    result.rear_right_foot_origin_jacobian[12] = -z671;
    result.rear_right_foot_origin_jacobian[15] = -z668;
    result.rear_right_foot_origin_jacobian[18] = n0;
    result.rear_right_foot_origin_jacobian[21] = n0;
    result.rear_right_foot_origin_jacobian[24] = n0;
    result.rear_right_foot_origin_jacobian[27] = n0;
    result.rear_right_foot_origin_jacobian[30] = n0;
    result.rear_right_foot_origin_jacobian[33] = n0;
    result.rear_right_foot_origin_jacobian[36] = n0;
    result.rear_right_foot_origin_jacobian[39] = n0;
    result.rear_right_foot_origin_jacobian[42] = n0;
    result.rear_right_foot_origin_jacobian[45] = -z662;
    result.rear_right_foot_origin_jacobian[48] = -z656;
    result.rear_right_foot_origin_jacobian[51] = -z650;
    result.rear_right_foot_origin_jacobian[1] = n0;
    result.rear_right_foot_origin_jacobian[4] = n1;
    result.rear_right_foot_origin_jacobian[7] = n0;
    result.rear_right_foot_origin_jacobian[10] = z675;
    result.rear_right_foot_origin_jacobian[13] = z672;
    result.rear_right_foot_origin_jacobian[16] = -z669;
    result.rear_right_foot_origin_jacobian[19] = n0;
    result.rear_right_foot_origin_jacobian[22] = n0;
    result.rear_right_foot_origin_jacobian[25] = n0;
    result.rear_right_foot_origin_jacobian[28] = n0;
    result.rear_right_foot_origin_jacobian[31] = n0;
    result.rear_right_foot_origin_jacobian[34] = n0;
    result.rear_right_foot_origin_jacobian[37] = n0;
    result.rear_right_foot_origin_jacobian[40] = n0;
    result.rear_right_foot_origin_jacobian[43] = n0;
    result.rear_right_foot_origin_jacobian[46] = z663;
    result.rear_right_foot_origin_jacobian[49] = z657;
    result.rear_right_foot_origin_jacobian[52] = z651;
    result.rear_right_foot_origin_jacobian[2] = n0;
    result.rear_right_foot_origin_jacobian[5] = n0;
    result.rear_right_foot_origin_jacobian[8] = n1;
    result.rear_right_foot_origin_jacobian[11] = -z676;
    result.rear_right_foot_origin_jacobian[14] = -z673;
    result.rear_right_foot_origin_jacobian[17] = z670;
    result.rear_right_foot_origin_jacobian[20] = n0;
    result.rear_right_foot_origin_jacobian[23] = n0;
    result.rear_right_foot_origin_jacobian[26] = n0;
    result.rear_right_foot_origin_jacobian[29] = n0;
    result.rear_right_foot_origin_jacobian[32] = n0;
    result.rear_right_foot_origin_jacobian[35] = n0;
    result.rear_right_foot_origin_jacobian[38] = n0;
    result.rear_right_foot_origin_jacobian[41] = n0;
    result.rear_right_foot_origin_jacobian[44] = n0;
    result.rear_right_foot_origin_jacobian[47] = -z664;
    result.rear_right_foot_origin_jacobian[50] = -z658;
    result.rear_right_foot_origin_jacobian[53] = -z652;
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
    const Scalar z704 = k0 * s_rear_right_knee;
    const Scalar z705 = k0 * c_rear_right_knee;
    const Scalar z680 = n0_032 * c_rear_right_knee;
    const Scalar z681 = n0_032 * s_rear_right_knee;
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z19 = z14 + z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z25 = z21 + z22;
    const Scalar z18 = z14 - z16;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z24 = z21 - z22;
    const Scalar z29 = z26 - z27;
    const Scalar z30 = z26 + z27;
    const Scalar z682 = k4 + n0_2 * z680;
    const Scalar z683 = s_rear_right_thigh * z681 - c_rear_right_thigh * z680;
    const Scalar z684 = s_rear_right_thigh * z680 + c_rear_right_thigh * z681;
    const Scalar z706 = c_rear_right_knee * z705;
    const Scalar z707 = s_rear_right_knee * z704;
    const Scalar z708 = s_rear_right_knee * z705;
    const Scalar z711 = k4 + n0_4 * z680;
    const Scalar z712 = n0_124 + z680;
    const Scalar z709 = n0_4 * z680 - z707;
    const Scalar z710 = n0_2 * z681 + z708;
    const Scalar z714 = k8 + z706;
    const Scalar z715 = s_rear_right_thigh * z681 - c_rear_right_thigh * z712;
    const Scalar z716 = c_rear_right_thigh * z681 + s_rear_right_thigh * z712;
    const Scalar z713 = k9 + z711;
    const Scalar z685 = n0_08 * z684;
    const Scalar z686 = n0_08 * z683;
    const Scalar z687 = s_rear_right_hip * z684;
    const Scalar z688 = c_rear_right_hip * z684;
    const Scalar z717 = n0_08 * z716;
    const Scalar z718 = n0_08 * z715;
    const Scalar z719 = s_rear_right_hip * z716;
    const Scalar z720 = c_rear_right_hip * z716;
    const Scalar z736 = z709 + z714;
    const Scalar z737 = n2 * z710;
    const Scalar z744 = k11 - z713;
    const Scalar z745 = n0_1048 * s_rear_right_hip - c_rear_right_hip * z715;
    const Scalar z746 = n0_1048 * c_rear_right_hip + s_rear_right_hip * z715;
    const Scalar z689 = s_rear_right_hip * z686 - c_rear_right_hip * z682;
    const Scalar z690 = s_rear_right_hip * z682 + c_rear_right_hip * z686;
    const Scalar z691 = z685 + n0_05 * z688;
    const Scalar z694 = z17 * z683 - z18 * z687 + z30 * z688;
    const Scalar z695 = z19 * z683 - z23 * z687 + z24 * z688;
    const Scalar z696 = z25 * z687 - z28 * z688 - z29 * z683;
    const Scalar z721 = s_rear_right_hip * z718 - c_rear_right_hip * z713;
    const Scalar z722 = s_rear_right_hip * z713 + c_rear_right_hip * z718;
    const Scalar z723 = z717 + n0_05 * z720;
    const Scalar z726 = z17 * z715 - z18 * z719 + z30 * z720;
    const Scalar z727 = z19 * z715 - z23 * z719 + z24 * z720;
    const Scalar z738 = s_rear_right_thigh * z736 + c_rear_right_thigh * z737;
    const Scalar z728 = z25 * z719 - z28 * z720 - z29 * z715;
    const Scalar z693 = z690 + n0_05 * z683 + n0_2 * z687;
    const Scalar z725 = z722 + n0_05 * z715 + n0_2 * z719;
    const Scalar z692 = n0_2 * z688 - z689;
    const Scalar z724 = n0_2 * z720 - z721;
    const Scalar z801 = k0 * s_rear_left_knee;
    const Scalar z804 = s_rear_left_knee * z801;
    const Scalar z742 = c_rear_right_thigh * z738 - z710;
    const Scalar z739 = s_rear_right_thigh * z738;
    const Scalar z740 = z714 - z739;
    const Scalar z741 = z709 - z739;
    const Scalar z802 = k0 * c_rear_left_knee;
    const Scalar z752 = z18 * z745 - z30 * z746;
    const Scalar z743 = k14 + z741;
    const Scalar z753 = z23 * z745 - z24 * z746;
    const Scalar z754 = z25 * z745 - z28 * z746;
    const Scalar z749 = z743 + n0_05 * z746;
    const Scalar z769 = z743 + n0_1 * z746;
    const Scalar z777 = n0_032 * c_rear_left_knee;
    const Scalar z806 = n0_4 * z777 - z804;
    const Scalar z774 = n0_0406 + z769;
    const Scalar z803 = c_rear_left_knee * z802;
    const Scalar z805 = s_rear_left_knee * z802;
    const Scalar z811 = k8 + z803;
    const Scalar z778 = n0_032 * s_rear_left_knee;
    const Scalar z807 = n0_2 * z778 + z805;
    const Scalar z808 = k4 + n0_4 * z777;
    const Scalar z810 = k9 + z808;
    const Scalar z809 = n0_124 + z777;
    const Scalar z763 = n2 * z718;
    const Scalar z812 = s_rear_left_thigh * z778 - c_rear_left_thigh * z809;
    const Scalar z813 = c_rear_left_thigh * z778 + s_rear_left_thigh * z809;
    const Scalar z762 = z740 - z744;
    const Scalar z764 = c_rear_right_hip * z763 + s_rear_right_hip * z762;
    const Scalar z815 = n0_08 * z812;
    const Scalar z814 = n0_08 * z813;
    const Scalar z747 = s_rear_right_hip * z742 - c_rear_right_hip * z717;
    const Scalar z748 = s_rear_right_hip * z717 + c_rear_right_hip * z742;
    const Scalar z768 = c_rear_right_hip * z764 - z718;
    const Scalar z765 = s_rear_right_hip * z764;
    const Scalar z767 = z740 - z765;
    const Scalar z766 = z744 + z765;
    const Scalar z751 = n0_2 * z745 + z748;
    const Scalar z772 = n0_05 * z745 - z768;
    const Scalar z771 = n0_4 * z716 - z766;
    const Scalar z773 = n0_4 * z716 - z767 + n0_1 * z746;
    const Scalar z750 = n0_2 * z746 - z747;
    const Scalar z770 = n0_05 * z716 - z747 + n0_2 * z746;
    const Scalar z775 = k17 + z771;
    const Scalar z833 = z806 + z811;
    const Scalar z834 = n2 * z807;
    const Scalar z835 = s_rear_left_thigh * z833 + c_rear_left_thigh * z834;
    const Scalar z776 = k18 + z773;
    const Scalar z841 = k11 - z810;
    const Scalar z842 = n0_1048 * s_rear_left_hip + c_rear_left_hip * z812;
    const Scalar z843 = s_rear_left_hip * z812 - n0_1048 * c_rear_left_hip;
    const Scalar z849 = z18 * z842 + z30 * z843;
    const Scalar z839 = c_rear_left_thigh * z835 - z807;
    const Scalar z836 = s_rear_left_thigh * z835;
    const Scalar z850 = z23 * z842 + z24 * z843;
    const Scalar z837 = z811 - z836;
    const Scalar z838 = z806 - z836;
    const Scalar z851 = z25 * z842 + z28 * z843;
    const Scalar z840 = k14 + z838;
    const Scalar z859 = z837 - z841;
    const Scalar z844 = c_rear_left_hip * z814 + s_rear_left_hip * z839;
    const Scalar z845 = s_rear_left_hip * z814 - c_rear_left_hip * z839;
    const Scalar z848 = n0_2 * z842 + z845;
    const Scalar z846 = z840 - n0_05 * z843;
    const Scalar z847 = n0_2 * z843 - z844;
    const Scalar z779 = k4 + n0_2 * z777;
    const Scalar z860 = n2 * z815;
    const Scalar z780 = s_rear_left_thigh * z778 - c_rear_left_thigh * z777;
    const Scalar z861 = s_rear_left_hip * z859 - c_rear_left_hip * z860;
    const Scalar z781 = s_rear_left_thigh * z777 + c_rear_left_thigh * z778;
    const Scalar z862 = s_rear_left_hip * z861;
    const Scalar z783 = n0_08 * z780;
    const Scalar z784 = s_rear_left_hip * z781;
    const Scalar z816 = s_rear_left_hip * z813;
    const Scalar z785 = c_rear_left_hip * z781;
    const Scalar z782 = n0_08 * z781;
    const Scalar z788 = z782 + n0_05 * z785;
    const Scalar z864 = z837 - z862;
    const Scalar z863 = z841 + z862;
    const Scalar z865 = c_rear_left_hip * z861 + z815;
    const Scalar z866 = z840 - n0_1 * z843;
    const Scalar z791 = z17 * z780 - z18 * z784 + z30 * z785;
    const Scalar z792 = z19 * z780 - z23 * z784 + z24 * z785;
    const Scalar z793 = z25 * z784 - z28 * z785 - z29 * z780;
    const Scalar z787 = s_rear_left_hip * z779 - c_rear_left_hip * z783;
    const Scalar z790 = n0_05 * z780 - z787 - n0_2 * z784;
    const Scalar z786 = c_rear_left_hip * z779 + s_rear_left_hip * z783;
    const Scalar z789 = n0_2 * z785 + z786;
    const Scalar z874 = z774 + z866;
    const Scalar z877 = z751 - z848;
    const Scalar z871 = z716 + z813;
    const Scalar z872 = z746 + z843;
    const Scalar z873 = z745 - z842;
    const Scalar z869 = n0_05 * z842 - z865;
    const Scalar z878 = z772 + z869;
    const Scalar z867 = z844 + n0_05 * z813 - n0_2 * z843;
    const Scalar z870 = n0_4 * z813 - z864 - n0_1 * z843;
    const Scalar z875 = z770 - z867;
    const Scalar z879 = z776 + z870;
    const Scalar z868 = n0_4 * z813 - z863;
    const Scalar z876 = z775 + z868;
    const Scalar z817 = c_rear_left_hip * z813;
    const Scalar z820 = z814 + n0_05 * z817;
    const Scalar z823 = z17 * z812 - z18 * z816 + z30 * z817;
    const Scalar z824 = z19 * z812 - z23 * z816 + z24 * z817;
    const Scalar z825 = z25 * z816 - z28 * z817 - z29 * z812;
    const Scalar z880 = n0_032 * c_front_right_knee;
    const Scalar z881 = n0_032 * s_front_right_knee;
    const Scalar z882 = k4 + n0_2 * z880;
    const Scalar z883 = s_front_right_thigh * z881 - c_front_right_thigh * z880;
    const Scalar z884 = s_front_right_thigh * z880 + c_front_right_thigh * z881;
    const Scalar z819 = s_rear_left_hip * z810 - c_rear_left_hip * z815;
    const Scalar z822 = n0_05 * z812 - z819 - n0_2 * z816;
    const Scalar z818 = c_rear_left_hip * z810 + s_rear_left_hip * z815;
    const Scalar z821 = n0_2 * z817 + z818;
    const Scalar z904 = k0 * s_front_right_knee;
    const Scalar z907 = s_front_right_knee * z904;
    const Scalar z905 = k0 * c_front_right_knee;
    const Scalar z906 = c_front_right_knee * z905;
    const Scalar z908 = s_front_right_knee * z905;
    const Scalar z912 = n0_124 + z880;
    const Scalar z911 = k4 + n0_4 * z880;
    const Scalar z909 = n0_4 * z880 - z907;
    const Scalar z914 = k8 + z906;
    const Scalar z910 = n0_2 * z881 + z908;
    const Scalar z913 = k9 + z911;
    const Scalar z915 = s_front_right_thigh * z881 - c_front_right_thigh * z912;
    const Scalar z916 = c_front_right_thigh * z881 + s_front_right_thigh * z912;
    const Scalar z936 = z909 + z914;
    const Scalar z937 = n2 * z910;
    const Scalar z918 = n0_08 * z915;
    const Scalar z938 = s_front_right_thigh * z936 + c_front_right_thigh * z937;
    const Scalar z944 = k11 - z913;
    const Scalar z963 = n2 * z918;
    const Scalar z917 = n0_08 * z916;
    const Scalar z945 = n0_1048 * s_front_right_hip - c_front_right_hip * z915;
    const Scalar z946 = n0_1048 * c_front_right_hip + s_front_right_hip * z915;
    const Scalar z942 = c_front_right_thigh * z938 - z910;
    const Scalar z939 = s_front_right_thigh * z938;
    const Scalar z952 = z18 * z945 - z30 * z946;
    const Scalar z940 = z914 - z939;
    const Scalar z941 = z909 - z939;
    const Scalar z953 = z23 * z945 - z24 * z946;
    const Scalar z954 = z25 * z945 - z28 * z946;
    const Scalar z943 = k14 + z941;
    const Scalar z962 = z940 - z944;
    const Scalar z947 = s_front_right_hip * z942 - c_front_right_hip * z917;
    const Scalar z964 = c_front_right_hip * z963 + s_front_right_hip * z962;
    const Scalar z948 = s_front_right_hip * z917 + c_front_right_hip * z942;
    const Scalar z951 = n0_2 * z945 - z948;
    const Scalar z949 = z943 + n0_05 * z946;
    const Scalar z950 = n0_2 * z946 + z947;
    const Scalar z965 = s_front_right_hip * z964;
    const Scalar z886 = n0_08 * z883;
    const Scalar z887 = s_front_right_hip * z884;
    const Scalar z919 = s_front_right_hip * z916;
    const Scalar z888 = c_front_right_hip * z884;
    const Scalar z885 = n0_08 * z884;
    const Scalar z891 = z885 + n0_05 * z888;
    const Scalar z967 = z940 - z965;
    const Scalar z966 = z944 + z965;
    const Scalar z968 = c_front_right_hip * z964 - z918;
    const Scalar z969 = z943 + n0_1 * z946;
    const Scalar z894 = z17 * z883 - z18 * z887 + z30 * z888;
    const Scalar z895 = z19 * z883 - z23 * z887 + z24 * z888;
    const Scalar z896 = z25 * z887 - z28 * z888 - z29 * z883;
    const Scalar z890 = s_front_right_hip * z882 + c_front_right_hip * z886;
    const Scalar z893 = z890 + n0_05 * z883 - n0_2 * z887;
    const Scalar z889 = s_front_right_hip * z886 - c_front_right_hip * z882;
    const Scalar z892 = n0_2 * z888 + z889;
    const Scalar z977 = z874 + z969;
    const Scalar z980 = z877 - z951;
    const Scalar z974 = z871 + z916;
    const Scalar z975 = z872 + z946;
    const Scalar z976 = z873 + z945;
    const Scalar z972 = n0_05 * z945 - z968;
    const Scalar z981 = z878 + z972;
    const Scalar z970 = n0_05 * z916 - z947 - n0_2 * z946;
    const Scalar z973 = z967 + n0_4 * z916 - n0_1 * z946;
    const Scalar z978 = z875 + z970;
    const Scalar z982 = z879 - z973;
    const Scalar z971 = n0_4 * z916 + z966;
    const Scalar z979 = z876 - z971;
    const Scalar z920 = c_front_right_hip * z916;
    const Scalar z923 = z917 + n0_05 * z920;
    const Scalar z926 = z17 * z915 - z18 * z919 + z30 * z920;
    const Scalar z927 = z19 * z915 - z23 * z919 + z24 * z920;
    const Scalar z928 = z25 * z919 - z28 * z920 - z29 * z915;
    const Scalar z983 = n0_032 * c_front_left_knee;
    const Scalar z984 = n0_032 * s_front_left_knee;
    const Scalar z985 = k4 + n0_2 * z983;
    const Scalar z986 = s_front_left_thigh * z984 - c_front_left_thigh * z983;
    const Scalar z987 = s_front_left_thigh * z983 + c_front_left_thigh * z984;
    const Scalar z922 = s_front_right_hip * z913 + c_front_right_hip * z918;
    const Scalar z925 = z922 + n0_05 * z915 - n0_2 * z919;
    const Scalar z921 = s_front_right_hip * z918 - c_front_right_hip * z913;
    const Scalar z924 = n0_2 * z920 + z921;
    const Scalar z1007 = k0 * s_front_left_knee;
    const Scalar z1010 = s_front_left_knee * z1007;
    const Scalar z1008 = k0 * c_front_left_knee;
    const Scalar z1009 = c_front_left_knee * z1008;
    const Scalar z1011 = s_front_left_knee * z1008;
    const Scalar z1014 = k4 + n0_4 * z983;
    const Scalar z1012 = n0_4 * z983 - z1010;
    const Scalar z1017 = k8 + z1009;
    const Scalar z1013 = n0_2 * z984 + z1011;
    const Scalar z1015 = n0_124 + z983;
    const Scalar z1016 = k9 + z1014;
    const Scalar z1018 = s_front_left_thigh * z984 - c_front_left_thigh * z1015;
    const Scalar z1019 = c_front_left_thigh * z984 + s_front_left_thigh * z1015;
    const Scalar z1039 = z1012 + z1017;
    const Scalar z1040 = n2 * z1013;
    const Scalar z1047 = k11 - z1016;
    const Scalar z1041 = s_front_left_thigh * z1039 + c_front_left_thigh * z1040;
    const Scalar z1021 = n0_08 * z1018;
    const Scalar z1066 = n2 * z1021;
    const Scalar z1020 = n0_08 * z1019;
    const Scalar z989 = n0_08 * z986;
    const Scalar z990 = s_front_left_hip * z987;
    const Scalar z1022 = s_front_left_hip * z1019;
    const Scalar z1048 = n0_1048 * s_front_left_hip + c_front_left_hip * z1018;
    const Scalar z1045 = c_front_left_thigh * z1041 - z1013;
    const Scalar z1042 = s_front_left_thigh * z1041;
    const Scalar z1049 = s_front_left_hip * z1018 - n0_1048 * c_front_left_hip;
    const Scalar z1043 = z1017 - z1042;
    const Scalar z1044 = z1012 - z1042;
    const Scalar z1055 = z18 * z1048 + z30 * z1049;
    const Scalar z1056 = z23 * z1048 + z24 * z1049;
    const Scalar z1046 = k14 + z1044;
    const Scalar z1057 = z25 * z1048 + z28 * z1049;
    const Scalar z1052 = z1046 - n0_05 * z1049;
    const Scalar z1065 = z1043 - z1047;
    const Scalar z1067 = s_front_left_hip * z1065 - c_front_left_hip * z1066;
    const Scalar z1050 = c_front_left_hip * z1020 + s_front_left_hip * z1045;
    const Scalar z1051 = s_front_left_hip * z1020 - c_front_left_hip * z1045;
    const Scalar z1054 = n0_2 * z1048 - z1051;
    const Scalar z1053 = n0_2 * z1049 + z1050;
    const Scalar z991 = c_front_left_hip * z987;
    const Scalar z988 = n0_08 * z987;
    const Scalar z994 = z988 + n0_05 * z991;
    const Scalar z1072 = z1046 - n0_1 * z1049;
    const Scalar z997 = z17 * z986 - z18 * z990 + z30 * z991;
    const Scalar z998 = z19 * z986 - z23 * z990 + z24 * z991;
    const Scalar z999 = z25 * z990 - z28 * z991 - z29 * z986;
    const Scalar z1068 = s_front_left_hip * z1067;
    const Scalar z1070 = z1043 - z1068;
    const Scalar z1069 = z1047 + z1068;
    const Scalar z1071 = c_front_left_hip * z1067 + z1021;
    const Scalar z993 = s_front_left_hip * z985 - c_front_left_hip * z989;
    const Scalar z996 = n0_05 * z986 - z993 + n0_2 * z990;
    const Scalar z992 = c_front_left_hip * z985 + s_front_left_hip * z989;
    const Scalar z995 = n0_2 * z991 - z992;
    const Scalar z1080 = z977 + z1072;
    const Scalar z1083 = z980 + z1054;
    const Scalar z1077 = z974 + z1019;
    const Scalar z1078 = z975 + z1049;
    const Scalar z1079 = z976 - z1048;
    const Scalar z1075 = n0_05 * z1048 - z1071;
    const Scalar z1084 = z981 + z1075;
    const Scalar z1073 = z1050 + n0_05 * z1019 + n0_2 * z1049;
    const Scalar z1081 = z978 - z1073;
    const Scalar z1076 = z1070 + n0_4 * z1019 + n0_1 * z1049;
    const Scalar z1085 = z982 - z1076;
    const Scalar z1074 = n0_4 * z1019 + z1069;
    const Scalar z1082 = z979 - z1074;
    const Scalar z1023 = c_front_left_hip * z1019;
    const Scalar z1025 = s_front_left_hip * z1016 - c_front_left_hip * z1021;
    const Scalar z1024 = c_front_left_hip * z1016 + s_front_left_hip * z1021;
    const Scalar z1026 = z1020 + n0_05 * z1023;
    const Scalar z1027 = n0_2 * z1023 - z1024;
    const Scalar z1028 = n0_05 * z1018 - z1025 + n0_2 * z1022;
    const Scalar z1029 = z17 * z1018 - z18 * z1022 + z30 * z1023;
    const Scalar z1030 = z19 * z1018 - z23 * z1022 + z24 * z1023;
    const Scalar z1031 = z25 * z1022 - z28 * z1023 - z29 * z1018;
    const Scalar z1086 = z17 * z1078 - z18 * z1077;
    const Scalar z1087 = z19 * z1078 - z23 * z1077;
    const Scalar z1088 = z25 * z1077 - z29 * z1078;
    const Scalar z1096 = z17 * z1079 - z30 * z1077;
    const Scalar z1097 = z19 * z1079 - z24 * z1077;
    const Scalar z1098 = z28 * z1077 - z29 * z1079;
    const Scalar z1106 = z18 * z1079 - z30 * z1078;
    const Scalar z1107 = z23 * z1079 - z24 * z1078;
    const Scalar z1108 = z25 * z1079 - z28 * z1078;
    mass[0] = n12_24;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z1106;
    mass[4] = -z1096;
    mass[5] = z1086;
    mass[6] = -z1055;
    mass[7] = z1029;
    mass[8] = z997;
    mass[9] = z952;
    mass[10] = z926;
    mass[11] = z894;
    mass[12] = -z849;
    mass[13] = z823;
    mass[14] = z791;
    mass[15] = z752;
    mass[16] = z726;
    mass[17] = z694;
    mass[18] = n0;
    mass[19] = n12_24;
    mass[20] = n0;
    mass[21] = z1107;
    mass[22] = -z1097;
    mass[23] = z1087;
    mass[24] = -z1056;
    mass[25] = z1030;
    mass[26] = z998;
    mass[27] = z953;
    mass[28] = z927;
    mass[29] = z895;
    mass[30] = -z850;
    mass[31] = z824;
    mass[32] = z792;
    mass[33] = z753;
    mass[34] = z727;
    mass[35] = z695;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n12_24;
    mass[39] = z1108;
    mass[40] = z1098;
    mass[41] = -z1088;
    mass[42] = -z1057;
    mass[43] = -z1031;
    mass[44] = -z999;
    mass[45] = z954;
    mass[46] = -z928;
    mass[47] = -z896;
    mass[48] = -z851;
    mass[49] = -z825;
    mass[50] = -z793;
    mass[51] = z754;
    mass[52] = -z728;
    mass[53] = -z696;
    mass[54] = z1106;
    mass[55] = z1107;
    mass[56] = z1108;
    mass[57] = z1080;
    mass[58] = -z1081;
    mass[59] = -z1083;
    mass[60] = z1052;
    mass[61] = z1026;
    mass[62] = z994;
    mass[63] = z949;
    mass[64] = -z923;
    mass[65] = -z891;
    mass[66] = z846;
    mass[67] = z820;
    mass[68] = z788;
    mass[69] = z749;
    mass[70] = -z723;
    mass[71] = -z691;
    mass[72] = -z1096;
    mass[73] = -z1097;
    mass[74] = z1098;
    mass[75] = -z1081;
    mass[76] = z1082;
    mass[77] = -z1084;
    mass[78] = z1053;
    mass[79] = -z1027;
    mass[80] = -z995;
    mass[81] = z950;
    mass[82] = -z924;
    mass[83] = -z892;
    mass[84] = -z847;
    mass[85] = z821;
    mass[86] = z789;
    mass[87] = -z750;
    mass[88] = z724;
    mass[89] = z692;
    mass[90] = z1086;
    mass[91] = z1087;
    mass[92] = -z1088;
    mass[93] = -z1083;
    mass[94] = -z1084;
    mass[95] = z1085;
    mass[96] = -z1054;
    mass[97] = -z1028;
    mass[98] = -z996;
    mass[99] = z951;
    mass[100] = z925;
    mass[101] = z893;
    mass[102] = z848;
    mass[103] = -z822;
    mass[104] = -z790;
    mass[105] = -z751;
    mass[106] = z725;
    mass[107] = z693;
    mass[108] = -z1055;
    mass[109] = -z1056;
    mass[110] = -z1057;
    mass[111] = z1052;
    mass[112] = z1053;
    mass[113] = -z1054;
    mass[114] = z1046;
    mass[115] = z1020;
    mass[116] = z988;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n0;
    mass[121] = n0;
    mass[122] = n0;
    mass[123] = n0;
    mass[124] = n0;
    mass[125] = n0;
    mass[126] = z1029;
    mass[127] = z1030;
    mass[128] = -z1031;
    mass[129] = z1026;
    mass[130] = -z1027;
    mass[131] = -z1028;
    mass[132] = z1020;
    mass[133] = z1016;
    mass[134] = z985;
    mass[135] = n0;
    mass[136] = n0;
    mass[137] = n0;
    mass[138] = n0;
    mass[139] = n0;
    mass[140] = n0;
    mass[141] = n0;
    mass[142] = n0;
    mass[143] = n0;
    mass[144] = z997;
    mass[145] = z998;
    mass[146] = -z999;
    mass[147] = z994;
    mass[148] = -z995;
    mass[149] = -z996;
    mass[150] = z988;
    mass[151] = z985;
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
    mass[162] = z952;
    mass[163] = z953;
    mass[164] = z954;
    mass[165] = z949;
    mass[166] = z950;
    mass[167] = z951;
    mass[168] = n0;
    mass[169] = n0;
    mass[170] = n0;
    mass[171] = z943;
    mass[172] = -z917;
    mass[173] = -z885;
    mass[174] = n0;
    mass[175] = n0;
    mass[176] = n0;
    mass[177] = n0;
    mass[178] = n0;
    mass[179] = n0;
    mass[180] = z926;
    mass[181] = z927;
    mass[182] = -z928;
    mass[183] = -z923;
    mass[184] = -z924;
    mass[185] = z925;
    mass[186] = n0;
    mass[187] = n0;
    mass[188] = n0;
    mass[189] = -z917;
    mass[190] = z913;
    mass[191] = z882;
    mass[192] = n0;
    mass[193] = n0;
    mass[194] = n0;
    mass[195] = n0;
    mass[196] = n0;
    mass[197] = n0;
    mass[198] = z894;
    mass[199] = z895;
    mass[200] = -z896;
    mass[201] = -z891;
    mass[202] = -z892;
    mass[203] = z893;
    mass[204] = n0;
    mass[205] = n0;
    mass[206] = n0;
    mass[207] = -z885;
    mass[208] = z882;
    mass[209] = k4;
    mass[210] = n0;
    mass[211] = n0;
    mass[212] = n0;
    mass[213] = n0;
    mass[214] = n0;
    mass[215] = n0;
    mass[216] = -z849;
    mass[217] = -z850;
    mass[218] = -z851;
    mass[219] = z846;
    mass[220] = -z847;
    mass[221] = z848;
    mass[222] = n0;
    mass[223] = n0;
    mass[224] = n0;
    mass[225] = n0;
    mass[226] = n0;
    mass[227] = n0;
    mass[228] = z840;
    mass[229] = z814;
    mass[230] = z782;
    mass[231] = n0;
    mass[232] = n0;
    mass[233] = n0;
    mass[234] = z823;
    mass[235] = z824;
    mass[236] = -z825;
    mass[237] = z820;
    mass[238] = z821;
    mass[239] = -z822;
    mass[240] = n0;
    mass[241] = n0;
    mass[242] = n0;
    mass[243] = n0;
    mass[244] = n0;
    mass[245] = n0;
    mass[246] = z814;
    mass[247] = z810;
    mass[248] = z779;
    mass[249] = n0;
    mass[250] = n0;
    mass[251] = n0;
    mass[252] = z791;
    mass[253] = z792;
    mass[254] = -z793;
    mass[255] = z788;
    mass[256] = z789;
    mass[257] = -z790;
    mass[258] = n0;
    mass[259] = n0;
    mass[260] = n0;
    mass[261] = n0;
    mass[262] = n0;
    mass[263] = n0;
    mass[264] = z782;
    mass[265] = z779;
    mass[266] = k4;
    mass[267] = n0;
    mass[268] = n0;
    mass[269] = n0;
    mass[270] = z752;
    mass[271] = z753;
    mass[272] = z754;
    mass[273] = z749;
    mass[274] = -z750;
    mass[275] = -z751;
    mass[276] = n0;
    mass[277] = n0;
    mass[278] = n0;
    mass[279] = n0;
    mass[280] = n0;
    mass[281] = n0;
    mass[282] = n0;
    mass[283] = n0;
    mass[284] = n0;
    mass[285] = z743;
    mass[286] = -z717;
    mass[287] = -z685;
    mass[288] = z726;
    mass[289] = z727;
    mass[290] = -z728;
    mass[291] = -z723;
    mass[292] = z724;
    mass[293] = z725;
    mass[294] = n0;
    mass[295] = n0;
    mass[296] = n0;
    mass[297] = n0;
    mass[298] = n0;
    mass[299] = n0;
    mass[300] = n0;
    mass[301] = n0;
    mass[302] = n0;
    mass[303] = -z717;
    mass[304] = z713;
    mass[305] = z682;
    mass[306] = z694;
    mass[307] = z695;
    mass[308] = -z696;
    mass[309] = -z691;
    mass[310] = z692;
    mass[311] = z693;
    mass[312] = n0;
    mass[313] = n0;
    mass[314] = n0;
    mass[315] = n0;
    mass[316] = n0;
    mass[317] = n0;
    mass[318] = n0;
    mass[319] = n0;
    mass[320] = n0;
    mass[321] = -z685;
    mass[322] = z682;
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
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z25 = z21 + z22;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z328 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z29 = z26 - z27;
    const Scalar z326 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z261 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z327 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z194 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z260 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z123 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z193 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z192 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z259 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z122 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z24 = z21 - z22;
    const Scalar z121 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z30 = z26 + z27;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z19 = z14 + z16;
    const Scalar z18 = z14 - z16;
    const Scalar z1163 = n9_81 * z25;
    const Scalar z1168 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z1164 = n9_81 * z28;
    const Scalar z1165 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z1166 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z1167 = z1165 + z1166;
    const Scalar z1169 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z1170 = z1166 + z1169;
    const Scalar z1171 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z1162 = n9_81 * z29;
    const Scalar z1172 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z1175 = z1164 + n0_2 * z1171 + n0_05 * z1172;
    const Scalar z1174 = z1163 + n0_2 * z1168 - n0_05 * z1170;
    const Scalar z1173 = z1162 - n0_2 * z1167 + n0_05 * z1168;
    const Scalar z1139 = n0_05 * v_front_left_hip;
    const Scalar z1141 = n0_05 * v_front_left_thigh;
    const Scalar z1176 = s_front_left_hip * z1175 + c_front_left_hip * z1174;
    const Scalar z1143 = n0_05 * v_front_left_knee;
    const Scalar z1145 = n0_05 * v_front_right_hip;
    const Scalar z1147 = n0_05 * v_front_right_thigh;
    const Scalar z1149 = n0_05 * v_front_right_knee;
    const Scalar z1151 = n0_05 * v_rear_left_hip;
    const Scalar z1153 = n0_05 * v_rear_left_thigh;
    const Scalar z1155 = n0_05 * v_rear_left_knee;
    const Scalar z1157 = n0_05 * v_rear_right_hip;
    const Scalar z1159 = n0_05 * v_rear_right_thigh;
    const Scalar z1161 = n0_05 * v_rear_right_knee;
    const Scalar z144 = c_front_left_thigh * z123 + s_front_left_thigh * z122;
    const Scalar z1177 = s_front_left_hip * z1174 - c_front_left_hip * z1175;
    const Scalar z145 = s_front_left_thigh * z123 - c_front_left_thigh * z122;
    const Scalar z349 = c_rear_right_thigh * z328 + s_rear_right_thigh * z327;
    const Scalar z350 = s_rear_right_thigh * z328 - c_rear_right_thigh * z327;
    const Scalar z282 = c_rear_left_thigh * z261 + s_rear_left_thigh * z260;
    const Scalar z283 = s_rear_left_thigh * z261 - c_rear_left_thigh * z260;
    const Scalar z215 = c_front_right_thigh * z194 + s_front_right_thigh * z193;
    const Scalar z216 = s_front_right_thigh * z194 - c_front_right_thigh * z193;
    const Scalar z351 = v_rear_right_thigh + z326;
    const Scalar z375 = s_rear_right_knee * z350 - c_rear_right_knee * z349;
    const Scalar z376 = s_rear_right_knee * z349 + c_rear_right_knee * z350;
    const Scalar z284 = v_rear_left_thigh + z259;
    const Scalar z308 = s_rear_left_knee * z283 - c_rear_left_knee * z282;
    const Scalar z309 = s_rear_left_knee * z282 + c_rear_left_knee * z283;
    const Scalar z377 = v_rear_right_knee + z351;
    const Scalar z217 = v_front_right_thigh + z192;
    const Scalar z241 = s_front_right_knee * z216 - c_front_right_knee * z215;
    const Scalar z242 = s_front_right_knee * z215 + c_front_right_knee * z216;
    const Scalar z310 = v_rear_left_knee + z284;
    const Scalar z146 = v_front_left_thigh + z121;
    const Scalar z1179 = v_front_left_hip * z121;  // angular acceleration of front_left_hip_link, z
    const Scalar z170 = s_front_left_knee * z145 - c_front_left_knee * z144;
    const Scalar z171 = s_front_left_knee * z144 + c_front_left_knee * z145;
    const Scalar z243 = v_front_right_knee + z217;
    const Scalar z1180 = z121 * z123;
    const Scalar z1181 = z1179 + z1180;
    const Scalar z172 = v_front_left_knee + z146;
    const Scalar z1185 = z121 * z122;
    const Scalar z1217 = v_front_right_hip * z192;  // angular acceleration of front_right_hip_link, z
    const Scalar z1224 = s_front_right_thigh * z1217;
    const Scalar z1212 = z1163 + n0_2 * z1168 + n0_05 * z1170;
    const Scalar z1213 = z1164 + n0_2 * z1171 - n0_05 * z1172;
    const Scalar z1231 = v_front_right_thigh * z216 - z1224;  // angular acceleration of front_right_thigh_link, x
    const Scalar z1218 = z192 * z194;
    const Scalar z1219 = z1217 + z1218;
    const Scalar z1225 = c_front_right_thigh * z1217;
    const Scalar z1232 = v_front_right_thigh * z215 - z1225;  // angular acceleration of front_right_thigh_link, z
    const Scalar z1223 = z192 * z193;
    const Scalar z1186 = s_front_left_thigh * z1179;
    const Scalar z1187 = c_front_left_thigh * z1179;
    const Scalar z1193 = v_front_left_thigh * z145 - z1186;  // angular acceleration of front_left_thigh_link, x
    const Scalar z1194 = v_front_left_thigh * z144 - z1187;  // angular acceleration of front_left_thigh_link, z
    const Scalar z1211 = z1162 - n0_2 * z1167 - n0_05 * z1168;
    const Scalar z1220 = z193 * z193;
    const Scalar z1221 = z194 * z194;
    const Scalar z1222 = z1220 + z1221;
    const Scalar z1216 = v_front_right_hip * z193;  // angular acceleration of front_right_hip_link, y
    const Scalar z1215 = s_front_right_hip * z1212 - c_front_right_hip * z1213;
    const Scalar z1214 = s_front_right_hip * z1213 + c_front_right_hip * z1212;
    const Scalar z1227 = z1214 + n0_08 * z1222;
    const Scalar z1182 = z122 * z122;
    const Scalar z1183 = z123 * z123;
    const Scalar z1184 = z1182 + z1183;
    const Scalar z1226 = z1211 - n0_08 * z1219;
    const Scalar z1178 = v_front_left_hip * z122;  // angular acceleration of front_left_hip_link, y
    const Scalar z1249 = z1162 + n0_2 * z1167 + n0_05 * z1168;
    const Scalar z1189 = z1176 - n0_08 * z1184;
    const Scalar z1235 = z216 * z217;
    const Scalar z1236 = z1231 + z1235;
    const Scalar z1233 = z215 * z216;
    const Scalar z1241 = s_front_right_knee * z1231 - c_front_right_knee * z1232;
    const Scalar z1240 = s_front_right_knee * z1232 + c_front_right_knee * z1231;
    const Scalar z1248 = v_front_right_knee * z241 + z1241;  // angular acceleration of front_right_shank_link, z
    const Scalar z1247 = v_front_right_knee * z242 + z1240;  // angular acceleration of front_right_shank_link, x
    const Scalar z1228 = z1215 - n0_08 * z1223;
    const Scalar z1197 = z145 * z146;
    const Scalar z1198 = z1193 + z1197;
    const Scalar z1195 = z144 * z145;
    const Scalar z1237 = z215 * z215;
    const Scalar z1238 = z217 * z217;
    const Scalar z1239 = z1237 + z1238;
    const Scalar z1203 = s_front_left_knee * z1193 - c_front_left_knee * z1194;
    const Scalar z1202 = s_front_left_knee * z1194 + c_front_left_knee * z1193;
    const Scalar z1210 = v_front_left_knee * z170 + z1203;  // angular acceleration of front_left_shank_link, z
    const Scalar z1209 = v_front_left_knee * z171 + z1202;  // angular acceleration of front_left_shank_link, x
    const Scalar z1188 = z1173 + n0_08 * z1181;
    const Scalar z1250 = z1163 - n0_2 * z1168 - n0_05 * z1170;
    const Scalar z1251 = z1164 - n0_2 * z1171 + n0_05 * z1172;
    const Scalar z1230 = s_front_right_thigh * z1226 - c_front_right_thigh * z1228;
    const Scalar z1229 = s_front_right_thigh * z1228 + c_front_right_thigh * z1226;
    const Scalar z1244 = z1230 + n0_2 * z1239;
    const Scalar z1243 = z1227 - n0_2 * z1236;
    const Scalar z1190 = z1177 + n0_08 * z1185;
    const Scalar z1252 = s_rear_left_hip * z1251 + c_rear_left_hip * z1250;
    const Scalar z1199 = z144 * z144;
    const Scalar z1200 = z146 * z146;
    const Scalar z1201 = z1199 + z1200;
    const Scalar z1234 = z1216 - z1233;
    const Scalar z1205 = z1189 - n0_2 * z1198;
    const Scalar z1192 = s_front_left_thigh * z1188 - c_front_left_thigh * z1190;
    const Scalar z1191 = s_front_left_thigh * z1190 + c_front_left_thigh * z1188;
    const Scalar z1253 = s_rear_left_hip * z1250 - c_rear_left_hip * z1251;
    const Scalar z1206 = z1192 + n0_2 * z1201;
    const Scalar z1255 = v_rear_left_hip * z259;  // angular acceleration of rear_left_hip_link, z
    const Scalar z1256 = z259 * z261;
    const Scalar z1257 = z1255 + z1256;
    const Scalar z1254 = v_rear_left_hip * z260;  // angular acceleration of rear_left_hip_link, y
    const Scalar z1242 = z1229 + n0_2 * z1234;
    const Scalar z1245 = s_front_right_knee * z1244 - c_front_right_knee * z1242;
    const Scalar z1196 = z1178 - z1195;
    const Scalar z1261 = z259 * z260;
    const Scalar z1262 = s_rear_left_thigh * z1255;
    const Scalar z1263 = c_rear_left_thigh * z1255;
    const Scalar z1258 = z260 * z260;
    const Scalar z1259 = z261 * z261;
    const Scalar z1260 = z1258 + z1259;
    const Scalar z1264 = z1249 + n0_08 * z1257;
    const Scalar z1204 = z1191 + n0_2 * z1196;
    const Scalar z1207 = s_front_left_knee * z1206 - c_front_left_knee * z1204;
    const Scalar z1288 = z1163 - n0_2 * z1168 + n0_05 * z1170;
    const Scalar z1287 = z1162 + n0_2 * z1167 - n0_05 * z1168;
    const Scalar z1269 = v_rear_left_thigh * z283 - z1262;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z1270 = v_rear_left_thigh * z282 - z1263;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z1265 = z1252 - n0_08 * z1260;
    const Scalar z1293 = v_rear_right_hip * z326;  // angular acceleration of rear_right_hip_link, z
    const Scalar z1300 = s_rear_right_thigh * z1293;
    const Scalar z1289 = z1164 - n0_2 * z1171 - n0_05 * z1172;
    const Scalar z1294 = z326 * z328;
    const Scalar z1307 = v_rear_right_thigh * z350 - z1300;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z1295 = z1293 + z1294;
    const Scalar z1301 = c_rear_right_thigh * z1293;
    const Scalar z1308 = v_rear_right_thigh * z349 - z1301;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z1299 = z326 * z327;
    const Scalar z1296 = z327 * z327;
    const Scalar z1297 = z328 * z328;
    const Scalar z1298 = z1296 + z1297;
    const Scalar z1291 = s_rear_right_hip * z1288 - c_rear_right_hip * z1289;
    const Scalar z1290 = s_rear_right_hip * z1289 + c_rear_right_hip * z1288;
    const Scalar z1303 = z1290 + n0_08 * z1298;
    const Scalar z1302 = z1287 - n0_08 * z1295;
    const Scalar z1292 = v_rear_right_hip * z327;  // angular acceleration of rear_right_hip_link, y
    const Scalar z1311 = z350 * z351;
    const Scalar z1312 = z1307 + z1311;
    const Scalar z1309 = z349 * z350;
    const Scalar z1325 = z375 * z376;
    const Scalar z1317 = s_rear_right_knee * z1307 - c_rear_right_knee * z1308;
    const Scalar z1316 = s_rear_right_knee * z1308 + c_rear_right_knee * z1307;
    const Scalar z1324 = v_rear_right_knee * z375 + z1317;  // angular acceleration of rear_right_shank_link, z
    const Scalar z1323 = v_rear_right_knee * z376 + z1316;  // angular acceleration of rear_right_shank_link, x
    const Scalar z1327 = z376 * z377;
    const Scalar z1304 = z1291 - n0_08 * z1299;
    const Scalar z1313 = z349 * z349;
    const Scalar z1314 = z351 * z351;
    const Scalar z1315 = z1313 + z1314;
    const Scalar z1326 = z1292 + z1325;
    const Scalar z1306 = s_rear_right_thigh * z1302 - c_rear_right_thigh * z1304;
    const Scalar z1305 = s_rear_right_thigh * z1304 + c_rear_right_thigh * z1302;
    const Scalar z1320 = z1306 + n0_2 * z1315;
    const Scalar z1319 = z1303 - n0_2 * z1312;
    const Scalar z1273 = z283 * z284;
    const Scalar z1274 = z1269 + z1273;
    const Scalar z1271 = z282 * z283;
    const Scalar z1279 = s_rear_left_knee * z1269 - c_rear_left_knee * z1270;
    const Scalar z1278 = s_rear_left_knee * z1270 + c_rear_left_knee * z1269;
    const Scalar z1286 = v_rear_left_knee * z308 + z1279;  // angular acceleration of rear_left_shank_link, z
    const Scalar z1285 = v_rear_left_knee * z309 + z1278;  // angular acceleration of rear_left_shank_link, x
    const Scalar z1310 = z1292 - z1309;
    const Scalar z1266 = z1253 + n0_08 * z1261;
    const Scalar z1328 = z1323 + z1327;
    const Scalar z1275 = z282 * z282;
    const Scalar z1276 = z284 * z284;
    const Scalar z1277 = z1275 + z1276;
    const Scalar z1318 = z1305 + n0_2 * z1310;
    const Scalar z1321 = s_rear_right_knee * z1320 - c_rear_right_knee * z1318;
    const Scalar z1268 = s_rear_left_thigh * z1264 - c_rear_left_thigh * z1266;
    const Scalar z1267 = s_rear_left_thigh * z1266 + c_rear_left_thigh * z1264;
    const Scalar z1282 = z1268 + n0_2 * z1277;
    const Scalar z1329 = z375 * z375;
    const Scalar z1332 = z375 * z377;
    const Scalar z1333 = z1324 + z1332;
    const Scalar z1330 = z377 * z377;
    const Scalar z1331 = z1329 + z1330;
    const Scalar z1281 = z1265 - n0_2 * z1274;
    const Scalar z1272 = z1254 - z1271;
    const Scalar z1338 = k6 * z1292 + k7 * z1325 - n0_032 * z1321;  // moment on rear_right_shank_link, y
    const Scalar z1334 = n0_032 * z1326;  // force on rear_right_shank_link, x
    const Scalar z1336 = n0_032 * z1331;  // force on rear_right_shank_link, z
    const Scalar z1339 = k9 * z1333;  // moment on rear_right_shank_link, z
    const Scalar z1337 = n0_032 * z1319 - k10 * z1328;  // moment on rear_right_shank_link, x
    const Scalar z1335 = n0_032 * z1328;  // force on rear_right_shank_link, y
    const Scalar z1341 = s_rear_right_knee * z1334 - c_rear_right_knee * z1336;
    const Scalar z1340 = s_rear_right_knee * z1336 + c_rear_right_knee * z1334;
    const Scalar z1280 = z1267 + n0_2 * z1272;
    const Scalar z1344 = z349 * z351;
    const Scalar z1283 = s_rear_left_knee * z1282 - c_rear_left_knee * z1280;
    const Scalar z1348 = n0_124 * z1315 - z1341;  // force on rear_right_thigh_link, z
    const Scalar z1345 = z1308 + z1344;
    const Scalar z1356 = z327 * z328;
    // moment on rear_right_thigh_link, y
    const Scalar z1350 = k12 * z1292 - k13 * z1309 + n0_124 * z1305 + n0_2 * z1340 + z1338;
    const Scalar z1346 = n0_124 * z1310 + z1340;  // force on rear_right_thigh_link, x
    const Scalar z1357 = z1292 + z1356;
    const Scalar z1387 = z282 * z284;
    const Scalar z1388 = z1270 + z1387;
    const Scalar z1399 = z260 * z261;
    const Scalar z1362 = z1350 + n0_0002 * z1357;  // moment on rear_right_hip_link, y
    const Scalar z1400 = z1254 + z1399;
    const Scalar z1368 = z308 * z309;
    const Scalar z1370 = z309 * z310;
    const Scalar z1371 = z1285 + z1370;
    const Scalar z1381 = k6 * z1254 + k7 * z1368 - n0_032 * z1283;  // moment on rear_left_shank_link, y
    const Scalar z1369 = z1254 + z1368;
    const Scalar z1377 = n0_032 * z1369;  // force on rear_left_shank_link, x
    const Scalar z1380 = n0_032 * z1281 - k10 * z1371;  // moment on rear_left_shank_link, x
    const Scalar z1378 = n0_032 * z1371;  // force on rear_left_shank_link, y
    const Scalar z1372 = z308 * z308;
    const Scalar z1375 = z308 * z310;
    const Scalar z1376 = z1286 + z1375;
    const Scalar z1373 = z310 * z310;
    const Scalar z1374 = z1372 + z1373;
    const Scalar z1342 = s_rear_right_knee * z1339 - c_rear_right_knee * z1337;
    const Scalar z1343 = c_rear_right_knee * z1339 + s_rear_right_knee * z1337;
    const Scalar z1349 = n0_124 * z1303 - k15 * z1312 - n0_2 * z1335 - z1342;  // moment on rear_right_thigh_link, x
    const Scalar z1347 = n0_124 * z1312 + z1335;  // force on rear_right_thigh_link, y
    const Scalar z1351 = z1343 - n0_0002 * z1345;  // moment on rear_right_thigh_link, z
    const Scalar z1359 = n0_1048 * z1298 - z1347;  // force on rear_right_hip_link, y
    const Scalar z1379 = n0_032 * z1374;  // force on rear_left_shank_link, z
    const Scalar z1382 = k9 * z1376;  // moment on rear_left_shank_link, z
    const Scalar z1411 = z241 * z242;
    const Scalar z1384 = s_rear_left_knee * z1377 - c_rear_left_knee * z1379;
    const Scalar z1383 = s_rear_left_knee * z1379 + c_rear_left_knee * z1377;
    const Scalar z1391 = n0_124 * z1277 - z1384;  // force on rear_left_thigh_link, z
    const Scalar z1352 = s_rear_right_thigh * z1348 + c_rear_right_thigh * z1346;
    const Scalar z1353 = s_rear_right_thigh * z1346 - c_rear_right_thigh * z1348;
    // moment on rear_left_thigh_link, y
    const Scalar z1393 = k12 * z1254 - k13 * z1271 + n0_124 * z1267 + n0_2 * z1383 + z1381;
    const Scalar z1389 = n0_124 * z1272 + z1383;  // force on rear_left_thigh_link, x
    const Scalar z1413 = z242 * z243;
    const Scalar z1412 = z1216 + z1411;
    const Scalar z1405 = z1393 + n0_0002 * z1400;  // moment on rear_left_hip_link, y
    const Scalar z1385 = s_rear_left_knee * z1382 - c_rear_left_knee * z1380;
    const Scalar z1386 = c_rear_left_knee * z1382 + s_rear_left_knee * z1380;
    const Scalar z1392 = n0_124 * z1265 - k15 * z1274 - n0_2 * z1378 - z1385;  // moment on rear_left_thigh_link, x
    const Scalar z1390 = n0_124 * z1274 + z1378;  // force on rear_left_thigh_link, y
    const Scalar z1394 = z1386 - n0_0002 * z1388;  // moment on rear_left_thigh_link, z
    const Scalar z1402 = n0_1048 * z1260 + z1390;  // force on rear_left_hip_link, y
    const Scalar z1395 = s_rear_left_thigh * z1391 + c_rear_left_thigh * z1389;
    const Scalar z1396 = s_rear_left_thigh * z1389 - c_rear_left_thigh * z1391;
    const Scalar z1355 = s_rear_right_thigh * z1349 + c_rear_right_thigh * z1351;
    const Scalar z1363 = n0_1048 * z1287 - k17 * z1295 + n0_08 * z1352 - z1355;  // moment on rear_right_hip_link, z
    const Scalar z1358 = n0_1048 * z1295 - z1352;  // force on rear_right_hip_link, x
    const Scalar z1354 = s_rear_right_thigh * z1351 - c_rear_right_thigh * z1349;
    const Scalar z1414 = z1247 + z1413;
    const Scalar z1361 = n0_1048 * z1291 - k18 * z1299 + n0_08 * z1353 - z1354;  // moment on rear_right_hip_link, x
    const Scalar z1360 = n0_1048 * z1299 - z1353;  // force on rear_right_hip_link, z
    const Scalar z1420 = n0_032 * z1412;  // force on front_right_shank_link, x
    const Scalar z1423 = n0_032 * z1243 - k10 * z1414;  // moment on front_right_shank_link, x
    const Scalar z1421 = n0_032 * z1414;  // force on front_right_shank_link, y
    const Scalar z1415 = z241 * z241;
    const Scalar z1418 = z241 * z243;
    const Scalar z1419 = z1248 + z1418;
    const Scalar z1416 = z243 * z243;
    const Scalar z1417 = z1415 + z1416;
    const Scalar z1401 = n0_1048 * z1257 + z1395;  // force on rear_left_hip_link, x
    const Scalar z1365 = s_rear_right_hip * z1359 + c_rear_right_hip * z1360;
    const Scalar z1364 = s_rear_right_hip * z1360 - c_rear_right_hip * z1359;
    const Scalar z1424 = k6 * z1216 + k7 * z1411 - n0_032 * z1245;  // moment on front_right_shank_link, y
    const Scalar z1422 = n0_032 * z1417;  // force on front_right_shank_link, z
    const Scalar z1425 = k9 * z1419;  // moment on front_right_shank_link, z
    const Scalar z1367 = s_rear_right_hip * z1362 - c_rear_right_hip * z1363;
    const Scalar z1366 = c_rear_right_hip * z1362 + s_rear_right_hip * z1363;
    const Scalar z1430 = z215 * z217;
    const Scalar z1431 = z1232 + z1430;
    const Scalar z1442 = z193 * z194;
    const Scalar z1443 = z1216 + z1442;
    const Scalar z1454 = z170 * z171;
    const Scalar z1456 = z171 * z172;
    const Scalar z1455 = z1178 + z1454;
    const Scalar z1427 = s_front_right_knee * z1420 - c_front_right_knee * z1422;
    const Scalar z1426 = s_front_right_knee * z1422 + c_front_right_knee * z1420;
    // moment on front_right_thigh_link, y
    const Scalar z1436 = k12 * z1216 - k13 * z1233 + n0_124 * z1229 + n0_2 * z1426 + z1424;
    const Scalar z1434 = n0_124 * z1239 - z1427;  // force on front_right_thigh_link, z
    const Scalar z1432 = n0_124 * z1234 + z1426;  // force on front_right_thigh_link, x
    const Scalar z1428 = s_front_right_knee * z1425 - c_front_right_knee * z1423;
    const Scalar z1429 = c_front_right_knee * z1425 + s_front_right_knee * z1423;
    const Scalar z1435 = n0_124 * z1227 - k15 * z1236 - n0_2 * z1421 - z1428;  // moment on front_right_thigh_link, x
    const Scalar z1433 = n0_124 * z1236 + z1421;  // force on front_right_thigh_link, y
    const Scalar z1437 = z1429 - n0_0002 * z1431;  // moment on front_right_thigh_link, z
    const Scalar z1445 = n0_1048 * z1222 - z1433;  // force on front_right_hip_link, y
    const Scalar z1448 = z1436 + n0_0002 * z1443;  // moment on front_right_hip_link, y
    const Scalar z1438 = s_front_right_thigh * z1434 + c_front_right_thigh * z1432;
    const Scalar z1439 = s_front_right_thigh * z1432 - c_front_right_thigh * z1434;
    const Scalar z1444 = n0_1048 * z1219 - z1438;  // force on front_right_hip_link, x
    const Scalar z1403 = n0_1048 * z1261 + z1396;  // force on rear_left_hip_link, z
    const Scalar z1398 = s_rear_left_thigh * z1392 + c_rear_left_thigh * z1394;
    const Scalar z1406 = n0_1048 * z1249 + k17 * z1257 + n0_08 * z1395 + z1398;  // moment on rear_left_hip_link, z
    const Scalar z1397 = s_rear_left_thigh * z1394 - c_rear_left_thigh * z1392;
    const Scalar z1404 = n0_1048 * z1253 + k18 * z1261 + n0_08 * z1396 + z1397;  // moment on rear_left_hip_link, x
    const Scalar z1457 = z1209 + z1456;
    const Scalar z1463 = n0_032 * z1455;  // force on front_left_shank_link, x
    const Scalar z1466 = n0_032 * z1205 - k10 * z1457;  // moment on front_left_shank_link, x
    const Scalar z1464 = n0_032 * z1457;  // force on front_left_shank_link, y
    const Scalar z1458 = z170 * z170;
    const Scalar z1461 = z170 * z172;
    const Scalar z1462 = z1210 + z1461;
    const Scalar z1459 = z172 * z172;
    const Scalar z1460 = z1458 + z1459;
    const Scalar z1441 = s_front_right_thigh * z1435 + c_front_right_thigh * z1437;
    const Scalar z1449 = n0_1048 * z1211 - k17 * z1219 + n0_08 * z1438 - z1441;  // moment on front_right_hip_link, z
    const Scalar z1440 = s_front_right_thigh * z1437 - c_front_right_thigh * z1435;
    const Scalar z1447 = n0_1048 * z1215 - k18 * z1223 + n0_08 * z1439 - z1440;  // moment on front_right_hip_link, x
    const Scalar z1446 = n0_1048 * z1223 - z1439;  // force on front_right_hip_link, z
    const Scalar z1465 = n0_032 * z1460;  // force on front_left_shank_link, z
    const Scalar z1408 = s_rear_left_hip * z1402 + c_rear_left_hip * z1403;
    const Scalar z1407 = s_rear_left_hip * z1403 - c_rear_left_hip * z1402;
    const Scalar z1467 = k6 * z1178 + k7 * z1454 - n0_032 * z1207;  // moment on front_left_shank_link, y
    const Scalar z1468 = k9 * z1462;  // moment on front_left_shank_link, z
    const Scalar z1451 = s_front_right_hip * z1445 + c_front_right_hip * z1446;
    const Scalar z1450 = s_front_right_hip * z1446 - c_front_right_hip * z1445;
    const Scalar z1410 = s_rear_left_hip * z1405 + c_rear_left_hip * z1406;
    const Scalar z1409 = s_rear_left_hip * z1406 - c_rear_left_hip * z1405;
    const Scalar z1517 = z1147 - z1436;
    const Scalar z1518 = z1149 - z1424;
    const Scalar z1473 = z144 * z146;
    const Scalar z1474 = z1194 + z1473;
    const Scalar z1485 = z122 * z123;
    const Scalar z1515 = z1143 - z1467;
    const Scalar z1516 = z1145 + z1447;
    const Scalar z1486 = z1178 + z1485;
    const Scalar z1470 = s_front_left_knee * z1463 - c_front_left_knee * z1465;
    const Scalar z1469 = s_front_left_knee * z1465 + c_front_left_knee * z1463;
    // moment on front_left_thigh_link, y
    const Scalar z1479 = k12 * z1178 - k13 * z1195 + n0_124 * z1191 + n0_2 * z1469 + z1467;
    const Scalar z1477 = n0_124 * z1201 - z1470;  // force on front_left_thigh_link, z
    const Scalar z1475 = n0_124 * z1196 + z1469;  // force on front_left_thigh_link, x
    const Scalar z1471 = s_front_left_knee * z1468 - c_front_left_knee * z1466;
    const Scalar z1472 = c_front_left_knee * z1468 + s_front_left_knee * z1466;
    const Scalar z1478 = n0_124 * z1189 - k15 * z1198 - n0_2 * z1464 - z1471;  // moment on front_left_thigh_link, x
    const Scalar z1476 = n0_124 * z1198 + z1464;  // force on front_left_thigh_link, y
    const Scalar z1480 = z1472 - n0_0002 * z1474;  // moment on front_left_thigh_link, z
    const Scalar z1488 = n0_1048 * z1184 + z1476;  // force on front_left_hip_link, y
    const Scalar z1514 = z1141 - z1479;
    const Scalar z1491 = z1479 + n0_0002 * z1486;  // moment on front_left_hip_link, y
    const Scalar z1481 = s_front_left_thigh * z1477 + c_front_left_thigh * z1475;
    const Scalar z1482 = s_front_left_thigh * z1475 - c_front_left_thigh * z1477;
    const Scalar z1487 = n0_1048 * z1181 + z1481;  // force on front_left_hip_link, x
    const Scalar z1484 = s_front_left_thigh * z1478 + c_front_left_thigh * z1480;
    const Scalar z1492 = n0_1048 * z1173 + k17 * z1181 + n0_08 * z1481 + z1484;  // moment on front_left_hip_link, z
    const Scalar z1483 = s_front_left_thigh * z1480 - c_front_left_thigh * z1478;
    const Scalar z1490 = n0_1048 * z1177 + k18 * z1185 + n0_08 * z1482 + z1483;  // moment on front_left_hip_link, x
    const Scalar z1489 = n0_1048 * z1185 + z1482;  // force on front_left_hip_link, z
    const Scalar z1513 = z1139 - z1490;
    const Scalar z1497 = n12_24 * z1162 - z1358 + z1401 - z1444 + z1487;  // force on trunk, x
    const Scalar z1452 = c_front_right_hip * z1448 + s_front_right_hip * z1449;
    const Scalar z1453 = s_front_right_hip * z1448 - c_front_right_hip * z1449;
    const Scalar z1520 = z1153 - z1393;
    const Scalar z1521 = z1155 - z1381;
    const Scalar z1523 = z1159 - z1350;
    const Scalar z1524 = z1161 - z1338;
    const Scalar z1519 = z1151 - z1404;
    const Scalar z1522 = z1157 + z1361;
    const Scalar z1494 = s_front_left_hip * z1488 + c_front_left_hip * z1489;
    // moment on trunk, x
    const Scalar z1500 = n0_0306 * z1172 + z1361 - z1404 + z1447 - z1490 - n0_05 * (z1365 + z1408 + z1451 + z1494);
    const Scalar z1493 = s_front_left_hip * z1489 - c_front_left_hip * z1488;
    const Scalar z1499 = n12_24 * z1164 + z1365 - z1408 + z1451 - z1494;  // force on trunk, z
    const Scalar z1498 = n12_24 * z1163 - z1364 + z1407 - z1450 + z1493;  // force on trunk, y
    const Scalar z1503 = z17 * z1497 + z30 * z1499 + z18 * z1498;
    const Scalar z1504 = z19 * z1497 + z24 * z1499 + z23 * z1498;
    const Scalar z1505 = z29 * z1497 + z28 * z1499 + z25 * z1498;
    const Scalar z1495 = s_front_left_hip * z1492 - c_front_left_hip * z1491;
    // moment on trunk, y
    const Scalar z1501 = n0_3254 * z1171 + z1366 + z1452 - z1409 - z1495 - n0_2 * (z1365 - z1408 - z1451 + z1494);
    const Scalar z1496 = s_front_left_hip * z1491 + c_front_left_hip * z1492;
    // moment on trunk, z
    const Scalar z1502 = n0_2948 * z1168 - z1367 - n0_05 * (z1358 + z1401 + z1444 + z1487) - z1410 - z1453 - z1496
        + n0_2 * (z1364 - z1407 - z1450 + z1493);
    forces.trunk_x = z1503;
    forces.trunk_y = z1504;
    forces.trunk_z = z1505;
    forces.trunk_attitude_omega_x = z1500;
    forces.trunk_attitude_omega_y = -z1501;
    forces.trunk_attitude_omega_z = z1502;
    forces.front_left_hip = z1513;
    forces.front_left_thigh = z1514;
    forces.front_left_knee = z1515;
    forces.front_right_hip = z1516;
    forces.front_right_thigh = z1517;
    forces.front_right_knee = z1518;
    forces.rear_left_hip = z1519;
    forces.rear_left_thigh = z1520;
    forces.rear_left_knee = z1521;
    forces.rear_right_hip = z1522;
    forces.rear_right_thigh = z1523;
    forces.rear_right_knee = z1524;
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
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z18 = z14 - z16;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z30 = z26 + z27;
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z19 = z14 + z16;
    const Scalar z24 = z21 - z22;
    const Scalar z25 = z21 + z22;
    const Scalar z29 = z26 - z27;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z326 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z1166 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z1169 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z1171 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z328 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z1170 = z1166 + z1169;
    const Scalar z1165 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z1168 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z1172 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z259 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z327 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z261 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z1167 = z1165 + z1166;
    const Scalar z260 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z194 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z192 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z123 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z193 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z122 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z121 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z1183 = z123 * z123;
    const Scalar z1139 = n0_05 * v_front_left_hip;
    const Scalar z1141 = n0_05 * v_front_left_thigh;
    const Scalar z1143 = n0_05 * v_front_left_knee;
    const Scalar z1145 = n0_05 * v_front_right_hip;
    const Scalar z1147 = n0_05 * v_front_right_thigh;
    const Scalar z1149 = n0_05 * v_front_right_knee;
    const Scalar z1151 = n0_05 * v_rear_left_hip;
    const Scalar z1153 = n0_05 * v_rear_left_thigh;
    const Scalar z1155 = n0_05 * v_rear_left_knee;
    const Scalar z1157 = n0_05 * v_rear_right_hip;
    const Scalar z1159 = n0_05 * v_rear_right_thigh;
    const Scalar z1161 = n0_05 * v_rear_right_knee;
    const Scalar z144 = c_front_left_thigh * z123 + s_front_left_thigh * z122;
    const Scalar z145 = s_front_left_thigh * z123 - c_front_left_thigh * z122;
    const Scalar z146 = v_front_left_thigh + z121;
    const Scalar z215 = c_front_right_thigh * z194 + s_front_right_thigh * z193;
    const Scalar z216 = s_front_right_thigh * z194 - c_front_right_thigh * z193;
    const Scalar z217 = v_front_right_thigh + z192;
    const Scalar z282 = c_rear_left_thigh * z261 + s_rear_left_thigh * z260;
    const Scalar z283 = s_rear_left_thigh * z261 - c_rear_left_thigh * z260;
    const Scalar z284 = v_rear_left_thigh + z259;
    const Scalar z349 = c_rear_right_thigh * z328 + s_rear_right_thigh * z327;
    const Scalar z350 = s_rear_right_thigh * z328 - c_rear_right_thigh * z327;
    const Scalar z351 = v_rear_right_thigh + z326;
    const Scalar z1185 = z121 * z122;
    const Scalar z1180 = z121 * z123;
    const Scalar z1182 = z122 * z122;
    const Scalar z1184 = z1182 + z1183;
    const Scalar z377 = v_rear_right_knee + z351;
    const Scalar z375 = s_rear_right_knee * z350 - c_rear_right_knee * z349;
    const Scalar z376 = s_rear_right_knee * z349 + c_rear_right_knee * z350;
    const Scalar z308 = s_rear_left_knee * z283 - c_rear_left_knee * z282;
    const Scalar z309 = s_rear_left_knee * z282 + c_rear_left_knee * z283;
    const Scalar z310 = v_rear_left_knee + z284;
    const Scalar z241 = s_front_right_knee * z216 - c_front_right_knee * z215;
    const Scalar z242 = s_front_right_knee * z215 + c_front_right_knee * z216;
    const Scalar z170 = s_front_left_knee * z145 - c_front_left_knee * z144;
    const Scalar z1218 = z192 * z194;
    const Scalar z171 = s_front_left_knee * z144 + c_front_left_knee * z145;
    const Scalar z1220 = z193 * z193;
    const Scalar z243 = v_front_right_knee + z217;
    const Scalar z172 = v_front_left_knee + z146;
    const Scalar z1294 = z326 * z328;
    const Scalar z1299 = z326 * z327;
    const Scalar z1261 = z259 * z260;
    const Scalar z1296 = z327 * z327;
    const Scalar z1297 = z328 * z328;
    const Scalar z1298 = z1296 + z1297;
    const Scalar z1356 = z327 * z328;
    const Scalar z1256 = z259 * z261;
    const Scalar z1258 = z260 * z260;
    const Scalar z1259 = z261 * z261;
    const Scalar z1260 = z1258 + z1259;
    const Scalar z1399 = z260 * z261;
    const Scalar z1311 = z350 * z351;
    const Scalar z1325 = z375 * z376;
    const Scalar z1273 = z283 * z284;
    const Scalar z1313 = z349 * z349;
    const Scalar z1314 = z351 * z351;
    const Scalar z1315 = z1313 + z1314;
    const Scalar z1344 = z349 * z351;
    const Scalar z1329 = z375 * z375;
    const Scalar z1330 = z377 * z377;
    const Scalar z1331 = z1329 + z1330;
    const Scalar z1223 = z192 * z193;
    const Scalar z1368 = z308 * z309;
    const Scalar z1332 = z375 * z377;
    const Scalar z1327 = z376 * z377;
    const Scalar z1309 = z349 * z350;
    const Scalar z1336 = n0_032 * z1331;  // force on rear_right_shank_link, z
    const Scalar z1275 = z282 * z282;
    const Scalar z1276 = z284 * z284;
    const Scalar z1277 = z1275 + z1276;
    const Scalar z1387 = z282 * z284;
    const Scalar z1372 = z308 * z308;
    const Scalar z1373 = z310 * z310;
    const Scalar z1374 = z1372 + z1373;
    const Scalar z1221 = z194 * z194;
    const Scalar z1222 = z1220 + z1221;
    const Scalar z1375 = z308 * z310;
    const Scalar z1370 = z309 * z310;
    const Scalar z1411 = z241 * z242;
    const Scalar z1379 = n0_032 * z1374;  // force on rear_left_shank_link, z
    const Scalar z1271 = z282 * z283;
    const Scalar z1235 = z216 * z217;
    const Scalar z1415 = z241 * z241;
    const Scalar z1416 = z243 * z243;
    const Scalar z1417 = z1415 + z1416;
    const Scalar z1237 = z215 * z215;
    const Scalar z1238 = z217 * z217;
    const Scalar z1239 = z1237 + z1238;
    const Scalar z1197 = z145 * z146;
    const Scalar z1418 = z241 * z243;
    const Scalar z1422 = n0_032 * z1417;  // force on front_right_shank_link, z
    const Scalar z1413 = z242 * z243;
    const Scalar z1233 = z215 * z216;
    const Scalar z1195 = z144 * z145;
    const Scalar z1430 = z215 * z217;
    const Scalar z1442 = z193 * z194;
    const Scalar z1199 = z144 * z144;
    const Scalar z1454 = z170 * z171;
    const Scalar z1200 = z146 * z146;
    const Scalar z1201 = z1199 + z1200;
    const Scalar z1473 = z144 * z146;
    const Scalar z1485 = z122 * z123;
    const Scalar z1525 = n9_81 + a_trunk_z;
    const Scalar z1527 = a_trunk_x * z18 + a_trunk_y * z23 + z25 * z1525;
    const Scalar z1528 = a_trunk_x * z30 + a_trunk_y * z24 + z28 * z1525;
    const Scalar z1526 = a_trunk_y * z19 + z29 * z1525 + a_trunk_x * z17;
    const Scalar z1531 = a_trunk_attitude_omega_y - z1171;
    const Scalar z1530 = a_trunk_attitude_omega_z + z1168;
    const Scalar z1532 = a_trunk_attitude_omega_x + z1172;
    const Scalar z1529 = a_trunk_attitude_omega_z - z1168;
    const Scalar z1568 = a_trunk_attitude_omega_y * s_front_right_hip - a_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z1576 = v_front_right_hip * z192 + z1568;  // angular acceleration of front_right_hip_link, z
    // angular acceleration of front_right_hip_link, x
    const Scalar z1574 = a_trunk_attitude_omega_x + a_front_right_hip;
    const Scalar z1567 = a_trunk_attitude_omega_y * c_front_right_hip + a_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z1575 = v_front_right_hip * z193 - z1567;  // angular acceleration of front_right_hip_link, y
    const Scalar z1577 = z1218 + z1576;
    const Scalar z1534 = a_trunk_attitude_omega_y * s_front_left_hip - a_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z1542 = v_front_left_hip * z121 + z1534;  // angular acceleration of front_left_hip_link, z
    const Scalar z1570 = n0_05 * z1170 + z1527 + n0_2 * z1530;
    const Scalar z1540 = a_trunk_attitude_omega_x + a_front_left_hip;  // angular acceleration of front_left_hip_link, x
    const Scalar z1533 = a_trunk_attitude_omega_y * c_front_left_hip + a_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z1541 = v_front_left_hip * z122 - z1533;  // angular acceleration of front_left_hip_link, y
    const Scalar z1543 = z1180 + z1542;
    const Scalar z1571 = z1528 - n0_2 * z1531 - n0_05 * z1532;
    const Scalar z1536 = n0_05 * z1170 - z1527 - n0_2 * z1530;
    const Scalar z1573 = s_front_right_hip * z1570 - c_front_right_hip * z1571;
    const Scalar z1572 = s_front_right_hip * z1571 + c_front_right_hip * z1570;
    const Scalar z1545 = c_front_left_thigh * z1540 + s_front_left_thigh * z1542;
    const Scalar z1552 = v_front_left_thigh * z145 - z1545;  // angular acceleration of front_left_thigh_link, x
    const Scalar z1546 = s_front_left_thigh * z1540 - c_front_left_thigh * z1542;
    const Scalar z1554 = v_front_left_thigh * z144 + z1546;  // angular acceleration of front_left_thigh_link, z
    const Scalar z1537 = z1528 - n0_2 * z1531 + n0_05 * z1532;
    const Scalar z1556 = z1197 + z1552;
    const Scalar z1553 = a_front_left_thigh - z1541;  // angular acceleration of front_left_thigh_link, y
    const Scalar z1569 = n0_2 * z1167 - z1526 - n0_05 * z1529;
    const Scalar z1565 = a_front_left_knee + z1553;  // angular acceleration of front_left_shank_link, y
    const Scalar z1539 = s_front_left_hip * z1536 + c_front_left_hip * z1537;
    const Scalar z1538 = s_front_left_hip * z1537 - c_front_left_hip * z1536;
    const Scalar z1544 = z1185 - z1540;
    const Scalar z1548 = n0_08 * z1184 - z1538;
    const Scalar z1458 = z170 * z170;
    const Scalar z1459 = z172 * z172;
    const Scalar z1460 = z1458 + z1459;
    const Scalar z1535 = n0_2 * z1167 - z1526 + n0_05 * z1529;
    const Scalar z1549 = z1539 - n0_08 * z1544;
    const Scalar z1465 = n0_032 * z1460;  // force on front_left_shank_link, z
    const Scalar z1558 = s_front_left_knee * z1552 - c_front_left_knee * z1554;
    const Scalar z1557 = s_front_left_knee * z1554 + c_front_left_knee * z1552;
    const Scalar z1566 = v_front_left_knee * z170 + z1558;  // angular acceleration of front_left_shank_link, z
    const Scalar z1461 = z170 * z172;
    const Scalar z1456 = z171 * z172;
    const Scalar z1564 = v_front_left_knee * z171 + z1557;  // angular acceleration of front_left_shank_link, x
    const Scalar z1582 = n0_08 * z1222 + z1572;
    const Scalar z1602 = a_trunk_attitude_omega_y * s_rear_left_hip - a_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z1608 = a_trunk_attitude_omega_x + a_rear_left_hip;  // angular acceleration of rear_left_hip_link, x
    const Scalar z1604 = n0_05 * z1170 - z1527 + n0_2 * z1530;
    const Scalar z1601 = a_trunk_attitude_omega_y * c_rear_left_hip + a_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z1605 = z1528 + n0_2 * z1531 + n0_05 * z1532;
    const Scalar z1607 = s_rear_left_hip * z1604 + c_rear_left_hip * z1605;
    const Scalar z1606 = s_rear_left_hip * z1605 - c_rear_left_hip * z1604;
    const Scalar z1579 = c_front_right_thigh * z1574 + s_front_right_thigh * z1576;
    const Scalar z1586 = v_front_right_thigh * z216 - z1579;  // angular acceleration of front_right_thigh_link, x
    const Scalar z1580 = s_front_right_thigh * z1574 - c_front_right_thigh * z1576;
    const Scalar z1588 = v_front_right_thigh * z215 + z1580;  // angular acceleration of front_right_thigh_link, z
    const Scalar z1603 = n0_2 * z1167 + z1526 - n0_05 * z1529;
    const Scalar z1590 = z1235 + z1586;
    const Scalar z1587 = a_front_right_thigh - z1575;  // angular acceleration of front_right_thigh_link, y
    const Scalar z1578 = z1223 - z1574;
    const Scalar z1599 = a_front_right_knee + z1587;  // angular acceleration of front_right_shank_link, y
    const Scalar z1583 = z1573 - n0_08 * z1578;
    const Scalar z1592 = s_front_right_knee * z1586 - c_front_right_knee * z1588;
    const Scalar z1591 = s_front_right_knee * z1588 + c_front_right_knee * z1586;
    const Scalar z1600 = v_front_right_knee * z241 + z1592;  // angular acceleration of front_right_shank_link, z
    const Scalar z1581 = z1569 + n0_08 * z1577;
    const Scalar z1598 = v_front_right_knee * z242 + z1591;  // angular acceleration of front_right_shank_link, x
    const Scalar z1585 = c_front_right_thigh * z1583 + s_front_right_thigh * z1581;
    const Scalar z1584 = s_front_right_thigh * z1583 - c_front_right_thigh * z1581;
    const Scalar z1594 = z1582 - n0_2 * z1590;
    const Scalar z1595 = n0_2 * z1239 - z1585;
    const Scalar z1547 = z1535 - n0_08 * z1543;
    const Scalar z1610 = v_rear_left_hip * z259 + z1602;  // angular acceleration of rear_left_hip_link, z
    const Scalar z1609 = v_rear_left_hip * z260 - z1601;  // angular acceleration of rear_left_hip_link, y
    const Scalar z1611 = z1256 + z1610;
    const Scalar z1589 = z1233 + z1587;
    const Scalar z1550 = s_front_left_thigh * z1549 + c_front_left_thigh * z1547;
    const Scalar z1551 = s_front_left_thigh * z1547 - c_front_left_thigh * z1549;
    const Scalar z1616 = n0_08 * z1260 - z1606;
    const Scalar z1561 = n0_2 * z1201 - z1551;
    const Scalar z1613 = c_rear_left_thigh * z1608 + s_rear_left_thigh * z1610;
    const Scalar z1614 = s_rear_left_thigh * z1608 - c_rear_left_thigh * z1610;
    const Scalar z1612 = z1261 - z1608;
    const Scalar z1615 = z1603 + n0_08 * z1611;
    const Scalar z1555 = z1195 + z1553;
    const Scalar z1620 = v_rear_left_thigh * z283 - z1613;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z1617 = z1607 - n0_08 * z1612;
    const Scalar z1560 = z1548 + n0_2 * z1556;
    const Scalar z1619 = c_rear_left_thigh * z1617 + s_rear_left_thigh * z1615;
    const Scalar z1618 = s_rear_left_thigh * z1617 - c_rear_left_thigh * z1615;
    const Scalar z1593 = z1584 - n0_2 * z1589;
    const Scalar z1596 = s_front_right_knee * z1595 - c_front_right_knee * z1593;
    const Scalar z1559 = z1550 + n0_2 * z1555;
    const Scalar z1622 = v_rear_left_thigh * z282 + z1614;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z1562 = c_front_left_knee * z1559 + s_front_left_knee * z1561;
    const Scalar z1638 = n0_05 * z1170 + z1527 - n0_2 * z1530;
    const Scalar z1639 = z1528 + n0_2 * z1531 - n0_05 * z1532;
    const Scalar z1637 = n0_2 * z1167 + z1526 + n0_05 * z1529;
    const Scalar z1624 = z1273 + z1620;
    const Scalar z1629 = n0_2 * z1277 + z1619;
    const Scalar z1636 = a_trunk_attitude_omega_y * s_rear_right_hip - a_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z1644 = v_rear_right_hip * z326 + z1636;  // angular acceleration of rear_right_hip_link, z
    const Scalar z1642 = a_trunk_attitude_omega_x + a_rear_right_hip;  // angular acceleration of rear_right_hip_link, x
    const Scalar z1635 = a_trunk_attitude_omega_y * c_rear_right_hip + a_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z1643 = v_rear_right_hip * z327 - z1635;  // angular acceleration of rear_right_hip_link, y
    const Scalar z1645 = z1294 + z1644;
    const Scalar z1647 = c_rear_right_thigh * z1642 + s_rear_right_thigh * z1644;
    const Scalar z1648 = s_rear_right_thigh * z1642 - c_rear_right_thigh * z1644;
    const Scalar z1655 = a_rear_right_thigh - z1643;  // angular acceleration of rear_right_thigh_link, y
    const Scalar z1641 = s_rear_right_hip * z1638 - c_rear_right_hip * z1639;
    const Scalar z1654 = v_rear_right_thigh * z350 - z1647;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z1656 = v_rear_right_thigh * z349 + z1648;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z1640 = s_rear_right_hip * z1639 + c_rear_right_hip * z1638;
    const Scalar z1650 = n0_08 * z1298 + z1640;
    const Scalar z1658 = z1311 + z1654;
    const Scalar z1681 = z1344 + z1656;
    const Scalar z1646 = z1299 - z1642;
    const Scalar z1649 = z1637 - n0_08 * z1645;
    const Scalar z1667 = a_rear_right_knee + z1655;  // angular acceleration of rear_right_shank_link, y
    const Scalar z1621 = a_rear_left_thigh - z1609;  // angular acceleration of rear_left_thigh_link, y
    const Scalar z1660 = s_rear_right_knee * z1654 - c_rear_right_knee * z1656;
    const Scalar z1659 = s_rear_right_knee * z1656 + c_rear_right_knee * z1654;
    const Scalar z1668 = v_rear_right_knee * z375 + z1660;  // angular acceleration of rear_right_shank_link, z
    const Scalar z1666 = v_rear_right_knee * z376 + z1659;  // angular acceleration of rear_right_shank_link, x
    const Scalar z1651 = z1641 - n0_08 * z1646;
    const Scalar z1671 = z1332 + z1668;
    const Scalar z1669 = z1325 - z1667;
    const Scalar z1670 = z1327 + z1666;
    const Scalar z1672 = n0_032 * z1669;  // force on rear_right_shank_link, x
    const Scalar z1633 = a_rear_left_knee + z1621;  // angular acceleration of rear_left_shank_link, y
    const Scalar z1626 = s_rear_left_knee * z1620 - c_rear_left_knee * z1622;
    const Scalar z1634 = v_rear_left_knee * z308 + z1626;  // angular acceleration of rear_left_shank_link, z
    const Scalar z1625 = s_rear_left_knee * z1622 + c_rear_left_knee * z1620;
    const Scalar z1632 = v_rear_left_knee * z309 + z1625;  // angular acceleration of rear_left_shank_link, x
    const Scalar z1676 = k7 * z1671;  // moment on rear_right_shank_link, z
    const Scalar z1653 = s_rear_right_thigh * z1649 - c_rear_right_thigh * z1651;
    const Scalar z1652 = s_rear_right_thigh * z1651 + c_rear_right_thigh * z1649;
    const Scalar z1663 = n0_2 * z1315 + z1653;
    const Scalar z1662 = z1650 - n0_2 * z1658;
    const Scalar z1674 = n0_032 * z1662 - k8 * z1670;  // moment on rear_right_shank_link, x
    const Scalar z1673 = n0_032 * z1670;  // force on rear_right_shank_link, y
    const Scalar z1657 = z1309 + z1655;
    const Scalar z1628 = z1616 + n0_2 * z1624;
    const Scalar z1623 = z1271 + z1621;
    const Scalar z1661 = z1652 - n0_2 * z1657;
    const Scalar z1678 = s_rear_right_knee * z1672 - c_rear_right_knee * z1336;
    const Scalar z1677 = s_rear_right_knee * z1336 + c_rear_right_knee * z1672;
    const Scalar z1664 = s_rear_right_knee * z1663 - c_rear_right_knee * z1661;
    const Scalar z1684 = n0_124 * z1315 - z1678;  // force on rear_right_thigh_link, z
    const Scalar z1675 = k10 * z1325 - k11 * z1667 - n0_032 * z1664;  // moment on rear_right_shank_link, y
    const Scalar z1682 = n0_124 * z1657 - z1677;  // force on rear_right_thigh_link, x
    const Scalar z1627 = z1618 + n0_2 * z1623;
    // moment on rear_right_thigh_link, y
    const Scalar z1686 = k12 * z1309 + k13 * z1655 - n0_124 * z1652 - n0_2 * z1677 - z1675;
    const Scalar z1630 = s_rear_left_knee * z1629 + c_rear_left_knee * z1627;
    const Scalar z1705 = z1375 + z1634;
    const Scalar z1704 = z1370 + z1632;
    const Scalar z1738 = z1413 + z1598;
    const Scalar z1692 = z1356 + z1643;
    const Scalar z1715 = z1387 + z1622;
    const Scalar z1726 = z1399 + z1609;
    const Scalar z1710 = k7 * z1705;  // moment on rear_left_shank_link, z
    const Scalar z1708 = n0_032 * z1628 + k8 * z1704;  // moment on rear_left_shank_link, x
    const Scalar z1707 = n0_032 * z1704;  // force on rear_left_shank_link, y
    const Scalar z1709 = k10 * z1368 - k11 * z1633 - n0_032 * z1630;  // moment on rear_left_shank_link, y
    const Scalar z1703 = z1368 - z1633;
    const Scalar z1706 = n0_032 * z1703;  // force on rear_left_shank_link, x
    const Scalar z1697 = z1686 - n0_0002 * z1692;  // moment on rear_right_hip_link, y
    const Scalar z1737 = z1411 - z1599;
    const Scalar z1679 = s_rear_right_knee * z1676 - c_rear_right_knee * z1674;
    const Scalar z1680 = c_rear_right_knee * z1676 + s_rear_right_knee * z1674;
    const Scalar z1739 = z1418 + z1600;
    const Scalar z1685 = n0_124 * z1650 - k15 * z1658 - n0_2 * z1673 - z1679;  // moment on rear_right_thigh_link, x
    const Scalar z1687 = z1680 - n0_0002 * z1681;  // moment on rear_right_thigh_link, z
    const Scalar z1683 = n0_124 * z1658 + z1673;  // force on rear_right_thigh_link, y
    const Scalar z1743 = k10 * z1411 - k11 * z1599 - n0_032 * z1596;  // moment on front_right_shank_link, y
    const Scalar z1694 = n0_1048 * z1298 - z1683;  // force on rear_right_hip_link, y
    const Scalar z1740 = n0_032 * z1737;  // force on front_right_shank_link, x
    const Scalar z1744 = k7 * z1739;  // moment on front_right_shank_link, z
    const Scalar z1742 = n0_032 * z1594 - k8 * z1738;  // moment on front_right_shank_link, x
    const Scalar z1741 = n0_032 * z1738;  // force on front_right_shank_link, y
    const Scalar z1712 = s_rear_left_knee * z1706 - c_rear_left_knee * z1379;
    const Scalar z1711 = s_rear_left_knee * z1379 + c_rear_left_knee * z1706;
    // moment on rear_left_thigh_link, y
    const Scalar z1720 = k12 * z1271 + k13 * z1621 + n0_124 * z1618 - n0_2 * z1711 - z1709;
    const Scalar z1718 = n0_124 * z1277 - z1712;  // force on rear_left_thigh_link, z
    const Scalar z1716 = n0_124 * z1623 - z1711;  // force on rear_left_thigh_link, x
    const Scalar z1713 = s_rear_left_knee * z1710 + c_rear_left_knee * z1708;
    const Scalar z1714 = s_rear_left_knee * z1708 - c_rear_left_knee * z1710;
    const Scalar z1719 = n0_124 * z1616 + k15 * z1624 + n0_2 * z1707 + z1713;  // moment on rear_left_thigh_link, x
    const Scalar z1721 = z1714 + n0_0002 * z1715;  // moment on rear_left_thigh_link, z
    const Scalar z1717 = n0_124 * z1624 + z1707;  // force on rear_left_thigh_link, y
    const Scalar z1728 = n0_1048 * z1260 + z1717;  // force on rear_left_hip_link, y
    const Scalar z1731 = z1720 - n0_0002 * z1726;  // moment on rear_left_hip_link, y
    const Scalar z1746 = s_front_right_knee * z1740 - c_front_right_knee * z1422;
    const Scalar z1745 = s_front_right_knee * z1422 + c_front_right_knee * z1740;
    const Scalar z1688 = s_rear_right_thigh * z1684 - c_rear_right_thigh * z1682;
    const Scalar z1689 = s_rear_right_thigh * z1682 + c_rear_right_thigh * z1684;
    const Scalar z1749 = z1430 + z1588;
    const Scalar z1695 = n0_1048 * z1646 + z1689;  // force on rear_right_hip_link, z
    const Scalar z1691 = s_rear_right_thigh * z1685 + c_rear_right_thigh * z1687;
    const Scalar z1698 = n0_1048 * z1637 - k17 * z1645 + n0_08 * z1688 - z1691;  // moment on rear_right_hip_link, z
    const Scalar z1693 = n0_1048 * z1645 - z1688;  // force on rear_right_hip_link, x
    const Scalar z1690 = s_rear_right_thigh * z1687 - c_rear_right_thigh * z1685;
    // moment on rear_right_hip_link, x
    const Scalar z1696 = k18 * z1299 - n0_1048 * z1641 - k19 * z1642 + n0_08 * z1689 + z1690;
    // moment on front_right_thigh_link, y
    const Scalar z1754 = k12 * z1233 + k13 * z1587 - n0_124 * z1584 - n0_2 * z1745 - z1743;
    const Scalar z1752 = n0_124 * z1239 - z1746;  // force on front_right_thigh_link, z
    const Scalar z1750 = n0_124 * z1589 - z1745;  // force on front_right_thigh_link, x
    const Scalar z1722 = s_rear_left_thigh * z1718 - c_rear_left_thigh * z1716;
    const Scalar z1723 = s_rear_left_thigh * z1716 + c_rear_left_thigh * z1718;
    const Scalar z1729 = n0_1048 * z1612 - z1723;  // force on rear_left_hip_link, z
    const Scalar z1747 = s_front_right_knee * z1744 - c_front_right_knee * z1742;
    const Scalar z1748 = c_front_right_knee * z1744 + s_front_right_knee * z1742;
    const Scalar z1753 = n0_124 * z1582 - k15 * z1590 - n0_2 * z1741 - z1747;  // moment on front_right_thigh_link, x
    const Scalar z1751 = n0_124 * z1590 + z1741;  // force on front_right_thigh_link, y
    const Scalar z1755 = z1748 - n0_0002 * z1749;  // moment on front_right_thigh_link, z
    const Scalar z1725 = s_rear_left_thigh * z1719 + c_rear_left_thigh * z1721;
    const Scalar z1732 = n0_1048 * z1603 + k17 * z1611 + n0_08 * z1722 - z1725;  // moment on rear_left_hip_link, z
    const Scalar z1727 = n0_1048 * z1611 + z1722;  // force on rear_left_hip_link, x
    const Scalar z1724 = s_rear_left_thigh * z1721 - c_rear_left_thigh * z1719;
    // moment on rear_left_hip_link, x
    const Scalar z1730 = k18 * z1261 - n0_1048 * z1607 - k19 * z1608 - n0_08 * z1723 - z1724;
    const Scalar z1756 = s_front_right_thigh * z1752 - c_front_right_thigh * z1750;
    const Scalar z1757 = s_front_right_thigh * z1750 + c_front_right_thigh * z1752;
    const Scalar z1702 = s_rear_right_hip * z1697 + c_rear_right_hip * z1698;
    const Scalar z1701 = s_rear_right_hip * z1698 - c_rear_right_hip * z1697;
    const Scalar z1700 = s_rear_right_hip * z1694 + c_rear_right_hip * z1695;
    const Scalar z1699 = s_rear_right_hip * z1695 - c_rear_right_hip * z1694;
    const Scalar z1773 = z1461 + z1566;
    const Scalar z1772 = z1456 + z1564;
    const Scalar z1760 = z1442 + z1575;
    const Scalar z1762 = n0_1048 * z1222 - z1751;  // force on front_right_hip_link, y
    const Scalar z1783 = z1473 + z1554;
    const Scalar z1778 = k7 * z1773;  // moment on front_left_shank_link, z
    const Scalar z1776 = n0_032 * z1560 + k8 * z1772;  // moment on front_left_shank_link, x
    const Scalar z1775 = n0_032 * z1772;  // force on front_left_shank_link, y
    const Scalar z1777 = k10 * z1454 - k11 * z1565 - n0_032 * z1562;  // moment on front_left_shank_link, y
    const Scalar z1771 = z1454 - z1565;
    const Scalar z1774 = n0_032 * z1771;  // force on front_left_shank_link, x
    const Scalar z1763 = n0_1048 * z1578 + z1757;  // force on front_right_hip_link, z
    const Scalar z1765 = z1754 - n0_0002 * z1760;  // moment on front_right_hip_link, y
    const Scalar z1781 = s_front_left_knee * z1778 + c_front_left_knee * z1776;
    const Scalar z1782 = s_front_left_knee * z1776 - c_front_left_knee * z1778;
    const Scalar z1787 = n0_124 * z1548 + k15 * z1556 + n0_2 * z1775 + z1781;  // moment on front_left_thigh_link, x
    const Scalar z1785 = n0_124 * z1556 + z1775;  // force on front_left_thigh_link, y
    const Scalar z1789 = z1782 + n0_0002 * z1783;  // moment on front_left_thigh_link, z
    const Scalar z1780 = s_front_left_knee * z1774 - c_front_left_knee * z1465;
    const Scalar z1779 = s_front_left_knee * z1465 + c_front_left_knee * z1774;
    // moment on front_left_thigh_link, y
    const Scalar z1788 = k12 * z1195 + k13 * z1553 + n0_124 * z1550 - n0_2 * z1779 - z1777;
    const Scalar z1786 = n0_124 * z1201 - z1780;  // force on front_left_thigh_link, z
    const Scalar z1784 = n0_124 * z1555 - z1779;  // force on front_left_thigh_link, x
    const Scalar z1790 = s_front_left_thigh * z1786 - c_front_left_thigh * z1784;
    const Scalar z1791 = s_front_left_thigh * z1784 + c_front_left_thigh * z1786;
    const Scalar z1761 = n0_1048 * z1577 - z1756;  // force on front_right_hip_link, x
    const Scalar z1735 = c_rear_left_hip * z1731 + s_rear_left_hip * z1732;
    const Scalar z1736 = s_rear_left_hip * z1731 - c_rear_left_hip * z1732;
    const Scalar z1759 = s_front_right_thigh * z1753 + c_front_right_thigh * z1755;
    const Scalar z1766 = n0_1048 * z1569 + k17 * z1577 - n0_08 * z1756 + z1759;  // moment on front_right_hip_link, z
    const Scalar z1758 = s_front_right_thigh * z1755 - c_front_right_thigh * z1753;
    // moment on front_right_hip_link, x
    const Scalar z1764 = k18 * z1223 - n0_1048 * z1573 - k19 * z1574 + n0_08 * z1757 + z1758;
    const Scalar z1734 = s_rear_left_hip * z1728 + c_rear_left_hip * z1729;
    const Scalar z1733 = s_rear_left_hip * z1729 - c_rear_left_hip * z1728;
    const Scalar z1823 = z1143 - z1777;
    const Scalar z1825 = z1147 + z1754;
    const Scalar z1826 = z1149 - z1743;
    const Scalar z1828 = z1153 + z1720;
    const Scalar z1829 = z1155 - z1709;
    const Scalar z1831 = z1159 + z1686;
    const Scalar z1832 = z1161 - z1675;
    const Scalar z1796 = n0_1048 * z1184 + z1785;  // force on front_left_hip_link, y
    const Scalar z1794 = z1485 + z1541;
    const Scalar z1822 = z1141 + z1788;
    const Scalar z1799 = z1788 - n0_0002 * z1794;  // moment on front_left_hip_link, y
    const Scalar z1824 = z1145 - z1764;
    const Scalar z1827 = z1151 - z1730;
    const Scalar z1830 = z1157 - z1696;
    const Scalar z1797 = n0_1048 * z1544 - z1791;  // force on front_left_hip_link, z
    const Scalar z1795 = n0_1048 * z1543 + z1790;  // force on front_left_hip_link, x
    const Scalar z1805 = n12_24 * z1526 - z1693 + z1727 - z1761 + z1795;  // force on trunk, x
    const Scalar z1768 = s_front_right_hip * z1762 + c_front_right_hip * z1763;
    const Scalar z1767 = s_front_right_hip * z1763 - c_front_right_hip * z1762;
    const Scalar z1793 = s_front_left_thigh * z1787 + c_front_left_thigh * z1789;
    const Scalar z1800 = n0_1048 * z1535 - k17 * z1543 - n0_08 * z1790 + z1793;  // moment on front_left_hip_link, z
    const Scalar z1792 = s_front_left_thigh * z1789 - c_front_left_thigh * z1787;
    // moment on front_left_hip_link, x
    const Scalar z1798 = k18 * z1185 - n0_1048 * z1539 - k19 * z1540 - n0_08 * z1791 - z1792;
    const Scalar z1821 = z1139 - z1798;
    const Scalar z1769 = c_front_right_hip * z1765 + s_front_right_hip * z1766;
    const Scalar z1770 = s_front_right_hip * z1765 - c_front_right_hip * z1766;
    const Scalar z1802 = s_front_left_hip * z1796 + c_front_left_hip * z1797;
    // moment on trunk, x
    const Scalar z1808 = n0_0406 * a_trunk_attitude_omega_x - z1696 + n0_0306 * z1172 - z1764 - z1730 - z1798 - n0_05
        * (z1700 + z1734 + z1768 + z1802);
    const Scalar z1801 = s_front_left_hip * z1797 - c_front_left_hip * z1796;
    const Scalar z1807 = n12_24 * z1528 + z1700 - z1734 + z1768 - z1802;  // force on trunk, z
    const Scalar z1806 = n12_24 * z1527 - z1699 + z1733 - z1767 + z1801;  // force on trunk, y
    const Scalar z1811 = z17 * z1805 + z30 * z1807 + z18 * z1806;
    const Scalar z1812 = z19 * z1805 + z24 * z1807 + z23 * z1806;
    const Scalar z1813 = z29 * z1805 + z28 * z1807 + z25 * z1806;
    const Scalar z1804 = s_front_left_hip * z1799 + c_front_left_hip * z1800;
    // moment on trunk, z
    const Scalar z1810 = z1702 + n0_366 * a_trunk_attitude_omega_z + n0_2948 * z1168 - n0_05 * (z1693 + z1727 + z1761
        + z1795) + z1736 + z1770 + z1804 + n0_2 * (z1699 - z1733 - z1767 + z1801);
    const Scalar z1803 = s_front_left_hip * z1800 - c_front_left_hip * z1799;
    // moment on trunk, y
    const Scalar z1809 = z1735 + n0_3354 * a_trunk_attitude_omega_y - n0_3254 * z1171 + z1769 + n0_2 * (z1700 - z1734
        - z1768 + z1802) - z1701 - z1803;
    forces.trunk_x = z1811;
    forces.trunk_y = z1812;
    forces.trunk_z = z1813;
    forces.trunk_attitude_omega_x = z1808;
    forces.trunk_attitude_omega_y = z1809;
    forces.trunk_attitude_omega_z = z1810;
    forces.front_left_hip = z1821;
    forces.front_left_thigh = z1822;
    forces.front_left_knee = z1823;
    forces.front_right_hip = z1824;
    forces.front_right_thigh = z1825;
    forces.front_right_knee = z1826;
    forces.rear_left_hip = z1827;
    forces.rear_left_thigh = z1828;
    forces.rear_left_knee = z1829;
    forces.rear_right_hip = z1830;
    forces.rear_right_thigh = z1831;
    forces.rear_right_knee = z1832;
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
    const Scalar z704 = k0 * s_rear_right_knee;
    const Scalar z705 = k0 * c_rear_right_knee;
    const Scalar z680 = n0_032 * c_rear_right_knee;
    const Scalar z681 = n0_032 * s_rear_right_knee;
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z25 = z21 + z22;
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z29 = z26 - z27;
    const Scalar z326 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z328 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z259 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z261 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z327 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z192 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z194 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z24 = z21 - z22;
    const Scalar z121 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z30 = z26 + z27;
    const Scalar z123 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z260 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z193 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z122 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z19 = z14 + z16;
    const Scalar z18 = z14 - z16;
    const Scalar z801 = k0 * s_rear_left_knee;
    const Scalar z802 = k0 * c_rear_left_knee;
    const Scalar z777 = n0_032 * c_rear_left_knee;
    const Scalar z778 = n0_032 * s_rear_left_knee;
    const Scalar z706 = c_rear_right_knee * z705;
    const Scalar z707 = s_rear_right_knee * z704;
    const Scalar z708 = s_rear_right_knee * z705;
    const Scalar z712 = n0_124 + z680;
    const Scalar z803 = c_rear_left_knee * z802;
    const Scalar z804 = s_rear_left_knee * z801;
    const Scalar z805 = s_rear_left_knee * z802;
    const Scalar z709 = n0_4 * z680 - z707;
    const Scalar z710 = n0_2 * z681 + z708;
    const Scalar z714 = k7 + z706;
    const Scalar z715 = s_rear_right_thigh * z681 - c_rear_right_thigh * z712;
    const Scalar z716 = c_rear_right_thigh * z681 + s_rear_right_thigh * z712;
    const Scalar z144 = c_front_left_thigh * z123 + s_front_left_thigh * z122;
    const Scalar z806 = n0_4 * z777 - z804;
    const Scalar z145 = s_front_left_thigh * z123 - c_front_left_thigh * z122;
    const Scalar z807 = n0_2 * z778 + z805;
    const Scalar z146 = v_front_left_thigh + z121;
    const Scalar z809 = n0_124 + z777;
    const Scalar z215 = c_front_right_thigh * z194 + s_front_right_thigh * z193;
    const Scalar z216 = s_front_right_thigh * z194 - c_front_right_thigh * z193;
    const Scalar z217 = v_front_right_thigh + z192;
    const Scalar z282 = c_rear_left_thigh * z261 + s_rear_left_thigh * z260;
    const Scalar z349 = c_rear_right_thigh * z328 + s_rear_right_thigh * z327;
    const Scalar z351 = v_rear_right_thigh + z326;
    const Scalar z736 = z709 + z714;
    const Scalar z737 = n2 * z710;
    const Scalar z350 = s_rear_right_thigh * z328 - c_rear_right_thigh * z327;
    const Scalar z284 = v_rear_left_thigh + z259;
    const Scalar z738 = s_rear_right_thigh * z736 + c_rear_right_thigh * z737;
    const Scalar z283 = s_rear_left_thigh * z261 - c_rear_left_thigh * z260;
    const Scalar z375 = s_rear_right_knee * z350 - c_rear_right_knee * z349;
    const Scalar z376 = s_rear_right_knee * z349 + c_rear_right_knee * z350;
    const Scalar z308 = s_rear_left_knee * z283 - c_rear_left_knee * z282;
    const Scalar z742 = c_rear_right_thigh * z738 - z710;
    const Scalar z739 = s_rear_right_thigh * z738;
    const Scalar z309 = s_rear_left_knee * z282 + c_rear_left_knee * z283;
    const Scalar z741 = z709 - z739;
    const Scalar z740 = z714 - z739;
    const Scalar z377 = v_rear_right_knee + z351;
    const Scalar z241 = s_front_right_knee * z216 - c_front_right_knee * z215;
    const Scalar z242 = s_front_right_knee * z215 + c_front_right_knee * z216;
    const Scalar z310 = v_rear_left_knee + z284;
    const Scalar z170 = s_front_left_knee * z145 - c_front_left_knee * z144;
    const Scalar z811 = k7 + z803;
    const Scalar z171 = s_front_left_knee * z144 + c_front_left_knee * z145;
    const Scalar z812 = s_rear_left_thigh * z778 - c_rear_left_thigh * z809;
    const Scalar z243 = v_front_right_knee + z217;
    const Scalar z172 = v_front_left_knee + z146;
    const Scalar z813 = c_rear_left_thigh * z778 + s_rear_left_thigh * z809;
    const Scalar z904 = k0 * s_front_right_knee;
    const Scalar z907 = s_front_right_knee * z904;
    const Scalar z905 = k0 * c_front_right_knee;
    const Scalar z1007 = k0 * s_front_left_knee;
    const Scalar z1010 = s_front_left_knee * z1007;
    const Scalar z880 = n0_032 * c_front_right_knee;
    const Scalar z1008 = k0 * c_front_left_knee;
    const Scalar z909 = n0_4 * z880 - z907;
    const Scalar z912 = n0_124 + z880;
    const Scalar z906 = c_front_right_knee * z905;
    const Scalar z908 = s_front_right_knee * z905;
    const Scalar z914 = k7 + z906;
    const Scalar z983 = n0_032 * c_front_left_knee;
    const Scalar z1012 = n0_4 * z983 - z1010;
    const Scalar z1015 = n0_124 + z983;
    const Scalar z833 = z806 + z811;
    const Scalar z881 = n0_032 * s_front_right_knee;
    const Scalar z910 = n0_2 * z881 + z908;
    const Scalar z1009 = c_front_left_knee * z1008;
    const Scalar z1011 = s_front_left_knee * z1008;
    const Scalar z1017 = k7 + z1009;
    const Scalar z984 = n0_032 * s_front_left_knee;
    const Scalar z1013 = n0_2 * z984 + z1011;
    const Scalar z834 = n2 * z807;
    const Scalar z835 = s_rear_left_thigh * z833 + c_rear_left_thigh * z834;
    const Scalar z936 = z909 + z914;
    const Scalar z1039 = z1012 + z1017;
    const Scalar z937 = n2 * z910;
    const Scalar z938 = s_front_right_thigh * z936 + c_front_right_thigh * z937;
    const Scalar z839 = c_rear_left_thigh * z835 - z807;
    const Scalar z836 = s_rear_left_thigh * z835;
    const Scalar z1040 = n2 * z1013;
    const Scalar z1041 = s_front_left_thigh * z1039 + c_front_left_thigh * z1040;
    const Scalar z838 = z806 - z836;
    const Scalar z837 = z811 - z836;
    const Scalar z942 = c_front_right_thigh * z938 - z910;
    const Scalar z939 = s_front_right_thigh * z938;
    const Scalar z1045 = c_front_left_thigh * z1041 - z1013;
    const Scalar z1042 = s_front_left_thigh * z1041;
    const Scalar z941 = z909 - z939;
    const Scalar z940 = z914 - z939;
    const Scalar z915 = s_front_right_thigh * z881 - c_front_right_thigh * z912;
    const Scalar z916 = c_front_right_thigh * z881 + s_front_right_thigh * z912;
    const Scalar z1044 = z1012 - z1042;
    const Scalar z1043 = z1017 - z1042;
    const Scalar z1018 = s_front_left_thigh * z984 - c_front_left_thigh * z1015;
    const Scalar z1019 = c_front_left_thigh * z984 + s_front_left_thigh * z1015;
    const Scalar z1163 = n9_81 * z25;
    const Scalar z1168 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z1165 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z1166 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z1167 = z1165 + z1166;
    const Scalar z1169 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z1170 = z1166 + z1169;
    const Scalar z1164 = n9_81 * z28;
    const Scalar z1171 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z1162 = n9_81 * z29;
    const Scalar z1172 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z1213 = z1164 + n0_2 * z1171 - n0_05 * z1172;
    const Scalar z1212 = z1163 + n0_2 * z1168 + n0_05 * z1170;
    const Scalar z1174 = z1163 + n0_2 * z1168 - n0_05 * z1170;
    const Scalar z1179 = v_front_left_hip * z121;  // angular acceleration of front_left_hip_link, z
    const Scalar z1180 = z121 * z123;
    const Scalar z1181 = z1179 + z1180;
    const Scalar z1185 = z121 * z122;
    const Scalar z1211 = z1162 - n0_2 * z1167 - n0_05 * z1168;
    const Scalar z1175 = z1164 + n0_2 * z1171 + n0_05 * z1172;
    const Scalar z1173 = z1162 - n0_2 * z1167 + n0_05 * z1168;
    const Scalar z1177 = s_front_left_hip * z1174 - c_front_left_hip * z1175;
    const Scalar z1176 = s_front_left_hip * z1175 + c_front_left_hip * z1174;
    const Scalar z1188 = z1173 + n0_08 * z1181;
    const Scalar z1190 = z1177 + n0_08 * z1185;
    const Scalar z1186 = s_front_left_thigh * z1179;
    const Scalar z1187 = c_front_left_thigh * z1179;
    const Scalar z1193 = v_front_left_thigh * z145 - z1186;  // angular acceleration of front_left_thigh_link, x
    const Scalar z1194 = v_front_left_thigh * z144 - z1187;  // angular acceleration of front_left_thigh_link, z
    const Scalar z1199 = z144 * z144;
    const Scalar z1200 = z146 * z146;
    const Scalar z1201 = z1199 + z1200;
    const Scalar z1192 = s_front_left_thigh * z1188 - c_front_left_thigh * z1190;
    const Scalar z1191 = s_front_left_thigh * z1190 + c_front_left_thigh * z1188;
    const Scalar z1206 = z1192 + n0_2 * z1201;
    const Scalar z1161 = n0_05 * v_rear_right_knee;
    const Scalar z1182 = z122 * z122;
    const Scalar z1183 = z123 * z123;
    const Scalar z1184 = z1182 + z1183;
    const Scalar z1195 = z144 * z145;
    const Scalar z1197 = z145 * z146;
    const Scalar z1198 = z1193 + z1197;
    const Scalar z1155 = n0_05 * v_rear_left_knee;
    const Scalar z1203 = s_front_left_knee * z1193 - c_front_left_knee * z1194;
    const Scalar z1189 = z1176 - n0_08 * z1184;
    const Scalar z1202 = s_front_left_knee * z1194 + c_front_left_knee * z1193;
    const Scalar z1210 = v_front_left_knee * z170 + z1203;  // angular acceleration of front_left_shank_link, z
    const Scalar z1209 = v_front_left_knee * z171 + z1202;  // angular acceleration of front_left_shank_link, x
    const Scalar z1149 = n0_05 * v_front_right_knee;
    const Scalar z1143 = n0_05 * v_front_left_knee;
    const Scalar z1205 = z1189 - n0_2 * z1198;
    const Scalar z1159 = n0_05 * v_rear_right_thigh;
    const Scalar z1153 = n0_05 * v_rear_left_thigh;
    const Scalar z1147 = n0_05 * v_front_right_thigh;
    const Scalar z1141 = n0_05 * v_front_left_thigh;
    const Scalar z1157 = n0_05 * v_rear_right_hip;
    const Scalar z1151 = n0_05 * v_rear_left_hip;
    const Scalar z1145 = n0_05 * v_front_right_hip;
    const Scalar z1139 = n0_05 * v_front_left_hip;
    const Scalar z1217 = v_front_right_hip * z192;  // angular acceleration of front_right_hip_link, z
    const Scalar z1218 = z192 * z194;
    const Scalar z1219 = z1217 + z1218;
    const Scalar z1223 = z192 * z193;
    const Scalar z1215 = s_front_right_hip * z1212 - c_front_right_hip * z1213;
    const Scalar z1214 = s_front_right_hip * z1213 + c_front_right_hip * z1212;
    const Scalar z1226 = z1211 - n0_08 * z1219;
    const Scalar z1228 = z1215 - n0_08 * z1223;
    const Scalar z1224 = s_front_right_thigh * z1217;
    const Scalar z1225 = c_front_right_thigh * z1217;
    const Scalar z1231 = v_front_right_thigh * z216 - z1224;  // angular acceleration of front_right_thigh_link, x
    const Scalar z1232 = v_front_right_thigh * z215 - z1225;  // angular acceleration of front_right_thigh_link, z
    const Scalar z1237 = z215 * z215;
    const Scalar z1238 = z217 * z217;
    const Scalar z1239 = z1237 + z1238;
    const Scalar z1230 = s_front_right_thigh * z1226 - c_front_right_thigh * z1228;
    const Scalar z1229 = s_front_right_thigh * z1228 + c_front_right_thigh * z1226;
    const Scalar z1220 = z193 * z193;
    const Scalar z1221 = z194 * z194;
    const Scalar z1222 = z1220 + z1221;
    const Scalar z1233 = z215 * z216;
    const Scalar z1235 = z216 * z217;
    const Scalar z1236 = z1231 + z1235;
    const Scalar z1241 = s_front_right_knee * z1231 - c_front_right_knee * z1232;
    const Scalar z1227 = z1214 + n0_08 * z1222;
    const Scalar z1240 = s_front_right_knee * z1232 + c_front_right_knee * z1231;
    const Scalar z1216 = v_front_right_hip * z193;  // angular acceleration of front_right_hip_link, y
    const Scalar z1178 = v_front_left_hip * z122;  // angular acceleration of front_left_hip_link, y
    const Scalar z1244 = z1230 + n0_2 * z1239;
    const Scalar z1248 = v_front_right_knee * z241 + z1241;  // angular acceleration of front_right_shank_link, z
    const Scalar z1247 = v_front_right_knee * z242 + z1240;  // angular acceleration of front_right_shank_link, x
    const Scalar z1288 = z1163 - n0_2 * z1168 + n0_05 * z1170;
    const Scalar z1250 = z1163 - n0_2 * z1168 - n0_05 * z1170;
    const Scalar z1293 = v_rear_right_hip * z326;  // angular acceleration of rear_right_hip_link, z
    const Scalar z1294 = z326 * z328;
    const Scalar z1295 = z1293 + z1294;
    const Scalar z1299 = z326 * z327;
    const Scalar z1289 = z1164 - n0_2 * z1171 - n0_05 * z1172;
    const Scalar z1287 = z1162 + n0_2 * z1167 - n0_05 * z1168;
    const Scalar z1249 = z1162 + n0_2 * z1167 + n0_05 * z1168;
    const Scalar z1255 = v_rear_left_hip * z259;  // angular acceleration of rear_left_hip_link, z
    const Scalar z1256 = z259 * z261;
    const Scalar z1257 = z1255 + z1256;
    const Scalar z1261 = z259 * z260;
    const Scalar z1251 = z1164 - n0_2 * z1171 + n0_05 * z1172;
    const Scalar z1291 = s_rear_right_hip * z1288 - c_rear_right_hip * z1289;
    const Scalar z1290 = s_rear_right_hip * z1289 + c_rear_right_hip * z1288;
    const Scalar z1302 = z1287 - n0_08 * z1295;
    const Scalar z1253 = s_rear_left_hip * z1250 - c_rear_left_hip * z1251;
    const Scalar z1252 = s_rear_left_hip * z1251 + c_rear_left_hip * z1250;
    const Scalar z1304 = z1291 - n0_08 * z1299;
    const Scalar z1264 = z1249 + n0_08 * z1257;
    const Scalar z1300 = s_rear_right_thigh * z1293;
    const Scalar z1301 = c_rear_right_thigh * z1293;
    const Scalar z1307 = v_rear_right_thigh * z350 - z1300;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z1308 = v_rear_right_thigh * z349 - z1301;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z1266 = z1253 + n0_08 * z1261;
    const Scalar z1306 = s_rear_right_thigh * z1302 - c_rear_right_thigh * z1304;
    const Scalar z1305 = s_rear_right_thigh * z1304 + c_rear_right_thigh * z1302;
    const Scalar z1262 = s_rear_left_thigh * z1255;
    const Scalar z1263 = c_rear_left_thigh * z1255;
    const Scalar z1269 = v_rear_left_thigh * z283 - z1262;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z1270 = v_rear_left_thigh * z282 - z1263;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z1275 = z282 * z282;
    const Scalar z1276 = z284 * z284;
    const Scalar z1277 = z1275 + z1276;
    const Scalar z1296 = z327 * z327;
    const Scalar z1297 = z328 * z328;
    const Scalar z1298 = z1296 + z1297;
    const Scalar z1268 = s_rear_left_thigh * z1264 - c_rear_left_thigh * z1266;
    const Scalar z1267 = s_rear_left_thigh * z1266 + c_rear_left_thigh * z1264;
    const Scalar z1282 = z1268 + n0_2 * z1277;
    const Scalar z1303 = z1290 + n0_08 * z1298;
    const Scalar z1258 = z260 * z260;
    const Scalar z1259 = z261 * z261;
    const Scalar z1260 = z1258 + z1259;
    const Scalar z1271 = z282 * z283;
    const Scalar z1273 = z283 * z284;
    const Scalar z1274 = z1269 + z1273;
    const Scalar z1279 = s_rear_left_knee * z1269 - c_rear_left_knee * z1270;
    const Scalar z1265 = z1252 - n0_08 * z1260;
    const Scalar z1278 = s_rear_left_knee * z1270 + c_rear_left_knee * z1269;
    const Scalar z1286 = v_rear_left_knee * z308 + z1279;  // angular acceleration of rear_left_shank_link, z
    const Scalar z1285 = v_rear_left_knee * z309 + z1278;  // angular acceleration of rear_left_shank_link, x
    const Scalar z1281 = z1265 - n0_2 * z1274;
    const Scalar z1243 = z1227 - n0_2 * z1236;
    const Scalar z1313 = z349 * z349;
    const Scalar z1314 = z351 * z351;
    const Scalar z1315 = z1313 + z1314;
    const Scalar z1309 = z349 * z350;
    const Scalar z1311 = z350 * z351;
    const Scalar z1312 = z1307 + z1311;
    const Scalar z1317 = s_rear_right_knee * z1307 - c_rear_right_knee * z1308;
    const Scalar z1316 = s_rear_right_knee * z1308 + c_rear_right_knee * z1307;
    const Scalar z1319 = z1303 - n0_2 * z1312;
    const Scalar z1292 = v_rear_right_hip * z327;  // angular acceleration of rear_right_hip_link, y
    const Scalar z1254 = v_rear_left_hip * z260;  // angular acceleration of rear_left_hip_link, y
    const Scalar z1344 = z349 * z351;
    const Scalar z1345 = z1308 + z1344;
    const Scalar z1387 = z282 * z284;
    const Scalar z1388 = z1270 + z1387;
    const Scalar z1356 = z327 * z328;
    const Scalar z1399 = z260 * z261;
    const Scalar z1320 = z1306 + n0_2 * z1315;
    const Scalar z1324 = v_rear_right_knee * z375 + z1317;  // angular acceleration of rear_right_shank_link, z
    const Scalar z1323 = v_rear_right_knee * z376 + z1316;  // angular acceleration of rear_right_shank_link, x
    const Scalar z1357 = z1292 + z1356;
    const Scalar z1400 = z1254 + z1399;
    const Scalar z1325 = z375 * z376;
    const Scalar z1327 = z376 * z377;
    const Scalar z1328 = z1323 + z1327;
    const Scalar z1430 = z215 * z217;
    const Scalar z1332 = z375 * z377;
    const Scalar z1333 = z1324 + z1332;
    const Scalar z1329 = z375 * z375;
    const Scalar z1431 = z1232 + z1430;
    const Scalar z1330 = z377 * z377;
    const Scalar z1331 = z1329 + z1330;
    const Scalar z1337 = n0_032 * z1319 - k11 * z1328;  // moment on rear_right_shank_link, x
    const Scalar z1339 = k12 * z1333;  // moment on rear_right_shank_link, z
    const Scalar z1335 = n0_032 * z1328;  // force on rear_right_shank_link, y
    const Scalar z1336 = n0_032 * z1331;  // force on rear_right_shank_link, z
    const Scalar z1442 = z193 * z194;
    const Scalar z1443 = z1216 + z1442;
    const Scalar z1368 = z308 * z309;
    const Scalar z1370 = z309 * z310;
    const Scalar z1371 = z1285 + z1370;
    const Scalar z1411 = z241 * z242;
    const Scalar z1413 = z242 * z243;
    const Scalar z1414 = z1247 + z1413;
    const Scalar z1375 = z308 * z310;
    const Scalar z1376 = z1286 + z1375;
    const Scalar z1372 = z308 * z308;
    const Scalar z1373 = z310 * z310;
    const Scalar z1374 = z1372 + z1373;
    const Scalar z1380 = n0_032 * z1281 - k11 * z1371;  // moment on rear_left_shank_link, x
    const Scalar z1382 = k12 * z1376;  // moment on rear_left_shank_link, z
    const Scalar z1423 = n0_032 * z1243 - k11 * z1414;  // moment on front_right_shank_link, x
    const Scalar z1379 = n0_032 * z1374;  // force on rear_left_shank_link, z
    const Scalar z1378 = n0_032 * z1371;  // force on rear_left_shank_link, y
    const Scalar z1421 = n0_032 * z1414;  // force on front_right_shank_link, y
    const Scalar z1418 = z241 * z243;
    const Scalar z1419 = z1248 + z1418;
    const Scalar z1415 = z241 * z241;
    const Scalar z1416 = z243 * z243;
    const Scalar z1417 = z1415 + z1416;
    const Scalar z1343 = c_rear_right_knee * z1339 + s_rear_right_knee * z1337;
    const Scalar z1342 = s_rear_right_knee * z1339 - c_rear_right_knee * z1337;
    const Scalar z1351 = z1343 - n0_0002 * z1345;  // moment on rear_right_thigh_link, z
    const Scalar z1349 = n0_124 * z1303 - k14 * z1312 - n0_2 * z1335 - z1342;  // moment on rear_right_thigh_link, x
    const Scalar z1347 = n0_124 * z1312 + z1335;  // force on rear_right_thigh_link, y
    const Scalar z1359 = n0_1048 * z1298 - z1347;  // force on rear_right_hip_link, y
    const Scalar z1425 = k12 * z1419;  // moment on front_right_shank_link, z
    const Scalar z1422 = n0_032 * z1417;  // force on front_right_shank_link, z
    const Scalar z1454 = z170 * z171;
    const Scalar z1456 = z171 * z172;
    const Scalar z1457 = z1209 + z1456;
    const Scalar z1461 = z170 * z172;
    const Scalar z1458 = z170 * z170;
    const Scalar z1459 = z172 * z172;
    const Scalar z1460 = z1458 + z1459;
    const Scalar z1386 = c_rear_left_knee * z1382 + s_rear_left_knee * z1380;
    const Scalar z1385 = s_rear_left_knee * z1382 - c_rear_left_knee * z1380;
    const Scalar z1394 = z1386 - n0_0002 * z1388;  // moment on rear_left_thigh_link, z
    const Scalar z1392 = n0_124 * z1265 - k14 * z1274 - n0_2 * z1378 - z1385;  // moment on rear_left_thigh_link, x
    const Scalar z1390 = n0_124 * z1274 + z1378;  // force on rear_left_thigh_link, y
    const Scalar z1402 = n0_1048 * z1260 + z1390;  // force on rear_left_hip_link, y
    const Scalar z1429 = c_front_right_knee * z1425 + s_front_right_knee * z1423;
    const Scalar z1428 = s_front_right_knee * z1425 - c_front_right_knee * z1423;
    const Scalar z1437 = z1429 - n0_0002 * z1431;  // moment on front_right_thigh_link, z
    const Scalar z1435 = n0_124 * z1227 - k14 * z1236 - n0_2 * z1421 - z1428;  // moment on front_right_thigh_link, x
    const Scalar z1433 = n0_124 * z1236 + z1421;  // force on front_right_thigh_link, y
    const Scalar z1445 = n0_1048 * z1222 - z1433;  // force on front_right_hip_link, y
    const Scalar z1354 = s_rear_right_thigh * z1351 - c_rear_right_thigh * z1349;
    const Scalar z1462 = z1210 + z1461;
    const Scalar z1355 = s_rear_right_thigh * z1349 + c_rear_right_thigh * z1351;
    const Scalar z1473 = z144 * z146;
    const Scalar z1474 = z1194 + z1473;
    const Scalar z1485 = z122 * z123;
    const Scalar z1838 = u_front_right_knee_torque - z1149;
    const Scalar z1835 = u_front_left_knee_torque - z1143;
    const Scalar z1468 = k12 * z1462;  // moment on front_left_shank_link, z
    const Scalar z1465 = n0_032 * z1460;  // force on front_left_shank_link, z
    const Scalar z1466 = n0_032 * z1205 - k11 * z1457;  // moment on front_left_shank_link, x
    const Scalar z1464 = n0_032 * z1457;  // force on front_left_shank_link, y
    const Scalar z1837 = u_front_right_thigh_torque - z1147;
    const Scalar z1834 = u_front_left_thigh_torque - z1141;
    const Scalar z1839 = u_rear_left_hip_torque - z1151;
    const Scalar z1836 = u_front_right_hip_torque - z1145;
    const Scalar z1486 = z1178 + z1485;
    const Scalar z1833 = u_front_left_hip_torque - z1139;
    const Scalar z1472 = c_front_left_knee * z1468 + s_front_left_knee * z1466;
    const Scalar z1471 = s_front_left_knee * z1468 - c_front_left_knee * z1466;
    const Scalar z1480 = z1472 - n0_0002 * z1474;  // moment on front_left_thigh_link, z
    const Scalar z1478 = n0_124 * z1189 - k14 * z1198 - n0_2 * z1464 - z1471;  // moment on front_left_thigh_link, x
    const Scalar z1476 = n0_124 * z1198 + z1464;  // force on front_left_thigh_link, y
    const Scalar z1488 = n0_1048 * z1184 + z1476;  // force on front_left_hip_link, y
    const Scalar z1397 = s_rear_left_thigh * z1394 - c_rear_left_thigh * z1392;
    const Scalar z1398 = s_rear_left_thigh * z1392 + c_rear_left_thigh * z1394;
    const Scalar z1844 = u_rear_right_knee_torque - z1161;
    const Scalar z1841 = u_rear_left_knee_torque - z1155;
    const Scalar z1843 = u_rear_right_thigh_torque - z1159;
    const Scalar z1840 = u_rear_left_thigh_torque - z1153;
    const Scalar z1842 = u_rear_right_hip_torque - z1157;
    const Scalar z1846 = k16 * c_rear_right_knee;
    const Scalar z1847 = c_rear_right_knee * z1846;
    const Scalar z1849 = s_rear_right_knee * z1846;
    const Scalar z1845 = k16 * s_rear_right_knee;
    const Scalar z1848 = s_rear_right_knee * z1845;
    const Scalar z1440 = s_front_right_thigh * z1437 - c_front_right_thigh * z1435;
    const Scalar z1441 = s_front_right_thigh * z1435 + c_front_right_thigh * z1437;
    const Scalar z1850 = n0_2 * z1847;
    const Scalar z1851 = n0_2 * z1849;
    const Scalar z1852 = n0_2 * z1850;
    const Scalar z1854 = n0_124 - z1850;
    const Scalar z1483 = s_front_left_thigh * z1480 - c_front_left_thigh * z1478;
    const Scalar z1484 = s_front_left_thigh * z1478 + c_front_left_thigh * z1480;
    const Scalar z1853 = k17 - z1852;
    const Scalar z1855 = n1 / z1853;
    const Scalar z1856 = z1854 * z1855;
    const Scalar z1857 = z1851 * z1855;
    const Scalar z1858 = z1847 + z1854 * z1856;
    const Scalar z1859 = z1849 - z1854 * z1857;
    const Scalar z1860 = z1848 + z1851 * z1857;
    const Scalar z1861 = z1858 - z1860;
    const Scalar z1862 = n2 * z1859;
    const Scalar z1863 = s_rear_right_thigh * z1861 + c_rear_right_thigh * z1862;
    const Scalar z1864 = s_rear_right_thigh * z1863;
    const Scalar z1867 = c_rear_right_thigh * z1863 - z1859;
    const Scalar z1865 = z1860 + z1864;
    const Scalar z1866 = z1858 - z1864;
    const Scalar z1868 = n0_08 * z1867;
    const Scalar z1869 = n0_08 * z1865;
    const Scalar z1870 = n0_08 * z1866;
    const Scalar z1873 = z742 + n0_08 * z1868;
    const Scalar z1871 = z741 - n0_08 * z1869;
    const Scalar z1874 = z740 + n0_08 * z1870;
    const Scalar z1875 = n0_1048 - z1869;
    const Scalar z1876 = n0_1048 - z1870;
    const Scalar z1872 = k18 + z1871;
    const Scalar z1936 = k16 * c_rear_left_knee;
    const Scalar z1935 = k16 * s_rear_left_knee;
    const Scalar z1877 = n1 / z1872;
    const Scalar z1937 = c_rear_left_knee * z1936;
    const Scalar z1878 = z1873 * z1877;
    const Scalar z1938 = s_rear_left_knee * z1935;
    const Scalar z1879 = z1868 * z1877;
    const Scalar z1939 = s_rear_left_knee * z1936;
    const Scalar z1880 = z715 * z1877;
    const Scalar z1940 = n0_2 * z1937;
    const Scalar z1881 = z1875 * z1877;
    const Scalar z1941 = n0_2 * z1939;
    const Scalar z1882 = z1866 + z1868 * z1879;
    const Scalar z1942 = n0_2 * z1940;
    const Scalar z1883 = z1868 * z1880;
    const Scalar z1943 = k17 - z1942;
    const Scalar z1884 = z715 * z1880;
    const Scalar z1944 = n0_124 - z1940;
    const Scalar z1885 = z1868 * z1878 - z1876;
    const Scalar z1945 = n1 / z1943;
    const Scalar z1886 = z1867 - z1868 * z1881;
    const Scalar z1946 = z1944 * z1945;
    const Scalar z1887 = z715 * z1878 + z716;
    const Scalar z1947 = z1941 * z1945;
    const Scalar z1888 = z715 * z1881;
    const Scalar z1948 = z1937 + z1944 * z1946;
    const Scalar z1889 = z1868 - z1875 * z1878;
    const Scalar z1949 = z1939 - z1944 * z1947;
    const Scalar z1890 = z1873 * z1878 + z1874;
    const Scalar z1950 = z1938 + z1941 * z1947;
    const Scalar z1891 = z1865 + z1875 * z1881;
    const Scalar z1951 = z1948 - z1950;
    const Scalar z1906 = n2 * z1888;
    const Scalar z1892 = k19 - z1890;
    const Scalar z1952 = n2 * z1949;
    const Scalar z1898 = s_rear_right_hip * z1885;
    const Scalar z1899 = c_rear_right_hip * z1885;
    const Scalar z1900 = s_rear_right_hip * z1889 + c_rear_right_hip * z1887;
    const Scalar z1905 = z1884 - z1891;
    const Scalar z1907 = c_rear_right_hip * z1883 + s_rear_right_hip * z1886;
    const Scalar z1908 = s_rear_right_hip * z1883 - c_rear_right_hip * z1886;
    const Scalar z1932 = n12_24 - z1882;
    const Scalar z1893 = s_rear_right_hip * z1892;
    const Scalar z1953 = s_rear_left_thigh * z1951 + c_rear_left_thigh * z1952;
    const Scalar z1909 = c_rear_right_hip * z1906 + s_rear_right_hip * z1905;
    const Scalar z1894 = s_rear_right_hip * z1893;
    const Scalar z1954 = s_rear_left_thigh * z1953;
    const Scalar z1897 = c_rear_right_hip * z1893;
    const Scalar z1914 = n0_05 * z1908;
    const Scalar z1917 = z1898 - n0_2 * z1908;
    const Scalar z1920 = n0_05 * z1882 + z1899 - n0_2 * z1907;
    const Scalar z1901 = s_rear_right_hip * z1900;
    const Scalar z1903 = c_rear_right_hip * z1900 - z1887;
    const Scalar z1904 = c_rear_right_hip * z1900;
    const Scalar z1895 = k19 - z1894;
    const Scalar z1955 = z1950 + z1954;
    const Scalar z1896 = z1890 + z1894;
    const Scalar z1957 = c_rear_left_thigh * z1953 - z1949;
    const Scalar z1956 = z1948 - z1954;
    const Scalar z1959 = n0_08 * z1955;
    const Scalar z1958 = n0_08 * z1957;
    const Scalar z1960 = n0_08 * z1956;
    const Scalar z1910 = s_rear_right_hip * z1909;
    const Scalar z1913 = c_rear_right_hip * z1909 - z1888;
    const Scalar z1902 = z1889 - z1901;
    const Scalar z1963 = z839 + n0_08 * z1958;
    const Scalar z1961 = z838 - n0_08 * z1959;
    const Scalar z1964 = z837 + n0_08 * z1960;
    const Scalar z1965 = n0_1048 - z1959;
    const Scalar z1966 = n0_1048 - z1960;
    const Scalar z1911 = z1884 - z1910;
    const Scalar z1912 = z1891 + z1910;
    const Scalar z1915 = n0_05 * z1913;
    const Scalar z1918 = z1901 - n0_2 * z1913;
    const Scalar z1922 = z1902 - n0_05 * z1908 + n0_2 * z1913;
    const Scalar z1962 = k18 + z1961;
    const Scalar z1921 = z1904 + n0_05 * z1907 - n0_2 * z1911;
    const Scalar z1967 = n1 / z1962;
    const Scalar z1929 = z1897 - n0_05 * z1917 - n0_2 * (z1902 - z1918);
    const Scalar z1930 = z1896 + n0_05 * (z1899 + z1920) - n0_2 * (z1904 + z1921);
    const Scalar z1928 = n0_05 * (z1902 - z1914) + n0_2 * z1915;
    const Scalar z1931 = k21 - z1930;
    const Scalar z1933 = n12_24 - z1911;
    const Scalar z1919 = z1903 + n0_2 * z1912;
    const Scalar z1926 = n0_2 * (z1903 + z1919) + z1895;
    const Scalar z1916 = n0_05 * z1912;
    const Scalar z1925 = n0_05 * z1903 + n0_2 * z1916;
    const Scalar z1934 = n12_24 - z1912;
    const Scalar z1971 = z1965 * z1967;
    const Scalar z1970 = z812 * z1967;
    const Scalar z1968 = z1963 * z1967;
    const Scalar z1969 = z1958 * z1967;
    const Scalar z1980 = z1963 * z1968 + z1964;
    const Scalar z1981 = z1955 + z1965 * z1971;
    const Scalar z1979 = z1958 - z1965 * z1968;
    const Scalar z1975 = z1958 * z1968 - z1966;
    const Scalar z1976 = z1957 - z1958 * z1971;
    const Scalar z1977 = z812 * z1968 + z813;
    const Scalar z1972 = z1956 + z1958 * z1969;
    const Scalar z1973 = z1958 * z1970;
    const Scalar z1927 = k22 - z1926;
    const Scalar z1974 = z812 * z1970;
    const Scalar z1978 = z812 * z1971;
    const Scalar z1982 = k19 - z1980;
    const Scalar z1923 = n0_05 * z1916;
    const Scalar z1983 = s_rear_left_hip * z1982;
    const Scalar z1924 = n0_0406 - z1923;
    const Scalar z2034 = z1932 - z1972;
    const Scalar z2041 = k16 * c_front_right_knee;
    const Scalar z2042 = c_front_right_knee * z2041;
    const Scalar z2040 = k16 * s_front_right_knee;
    const Scalar z2043 = s_front_right_knee * z2040;
    const Scalar z1995 = z1974 - z1981;
    const Scalar z1996 = n2 * z1978;
    const Scalar z1999 = s_rear_left_hip * z1995 - c_rear_left_hip * z1996;
    const Scalar z1989 = c_rear_left_hip * z1975;
    const Scalar z1988 = s_rear_left_hip * z1975;
    const Scalar z1990 = s_rear_left_hip * z1979 - c_rear_left_hip * z1977;
    const Scalar z1993 = c_rear_left_hip * z1990 + z1977;
    const Scalar z1994 = c_rear_left_hip * z1990;
    const Scalar z1991 = s_rear_left_hip * z1990;
    const Scalar z1997 = s_rear_left_hip * z1976 - c_rear_left_hip * z1973;
    const Scalar z1998 = s_rear_left_hip * z1973 + c_rear_left_hip * z1976;
    const Scalar z2010 = n0_05 * z1972 + z1989 + n0_2 * z1997;
    const Scalar z2003 = c_rear_left_hip * z1999 + z1978;
    const Scalar z2000 = s_rear_left_hip * z1999;
    const Scalar z2001 = z1974 - z2000;
    const Scalar z2002 = z1981 + z2000;
    const Scalar z2007 = z1988 - n0_2 * z1998;
    const Scalar z1992 = z1979 - z1991;
    const Scalar z2008 = z1991 + n0_2 * z2003;
    const Scalar z2029 = z1918 - z2008;
    const Scalar z2037 = z1933 - z2001;
    const Scalar z2011 = z1994 + n0_05 * z1997 + n0_2 * z2001;
    const Scalar z2035 = z1907 + z1997;
    const Scalar z2032 = z1921 - z2011;
    const Scalar z2038 = z1913 + z2003;
    const Scalar z2039 = z1934 - z2002;
    const Scalar z2028 = z1917 - z2007;
    const Scalar z2031 = z1920 - z2010;
    const Scalar z2036 = z1908 - z1998;
    const Scalar z1984 = s_rear_left_hip * z1983;
    const Scalar z2044 = s_front_right_knee * z2041;
    const Scalar z1986 = z1980 + z1984;
    const Scalar z1987 = c_rear_left_hip * z1983;
    const Scalar z2021 = z1987 - n0_05 * z2007 + n0_2 * (z1992 - z2008);
    const Scalar z2023 = z1986 + n0_05 * (z1989 + z2010) + n0_2 * (z1994 + z2011);
    const Scalar z1985 = k19 - z1984;
    const Scalar z2045 = n0_2 * z2042;
    const Scalar z2047 = n0_2 * z2045;
    const Scalar z2049 = n0_124 - z2045;
    const Scalar z2046 = n0_2 * z2044;
    const Scalar z2022 = z1929 + z2021;
    const Scalar z2009 = z1993 - n0_2 * z2002;
    const Scalar z2024 = z1931 - z2023;
    const Scalar z2048 = k17 - z2047;
    const Scalar z2017 = z1985 - n0_2 * (z1993 + z2009);
    const Scalar z2030 = z1919 - z2009;
    const Scalar z2050 = n1 / z2048;
    const Scalar z2006 = n0_05 * z2002;
    const Scalar z2015 = n0_05 * z1993 - n0_2 * z2006;
    const Scalar z2027 = z1916 - z2006;
    const Scalar z2013 = n0_05 * z2006;
    const Scalar z2004 = n0_05 * z1998;
    const Scalar z2018 = z1927 - z2017;
    const Scalar z2014 = z1924 - z2013;
    const Scalar z2016 = z1925 + z2015;
    const Scalar z2012 = z1992 + n0_05 * z1998 - n0_2 * z2003;
    const Scalar z2033 = z1922 - z2012;
    const Scalar z2005 = n0_05 * z2003;
    const Scalar z2019 = n0_05 * (z1992 + z2004) - n0_2 * z2005;
    const Scalar z2026 = z1915 - z2005;
    const Scalar z2025 = z1914 + z2004;
    const Scalar z2051 = z2049 * z2050;
    const Scalar z2052 = z2046 * z2050;
    const Scalar z2020 = z1928 + z2019;
    const Scalar z2053 = z2042 + z2049 * z2051;
    const Scalar z2054 = z2044 - z2049 * z2052;
    const Scalar z2055 = z2043 + z2046 * z2052;
    const Scalar z2056 = z2053 - z2055;
    const Scalar z2057 = n2 * z2054;
    const Scalar z2058 = s_front_right_thigh * z2056 + c_front_right_thigh * z2057;
    const Scalar z2059 = s_front_right_thigh * z2058;
    const Scalar z2062 = c_front_right_thigh * z2058 - z2054;
    const Scalar z2060 = z2055 + z2059;
    const Scalar z2061 = z2053 - z2059;
    const Scalar z2063 = n0_08 * z2062;
    const Scalar z2064 = n0_08 * z2060;
    const Scalar z2065 = n0_08 * z2061;
    const Scalar z2068 = z942 + n0_08 * z2063;
    const Scalar z2066 = z941 - n0_08 * z2064;
    const Scalar z2069 = z940 + n0_08 * z2065;
    const Scalar z2070 = n0_1048 - z2064;
    const Scalar z2071 = n0_1048 - z2065;
    const Scalar z2067 = k18 + z2066;
    const Scalar z2072 = n1 / z2067;
    const Scalar z2073 = z2068 * z2072;
    const Scalar z2074 = z2063 * z2072;
    const Scalar z2075 = z915 * z2072;
    const Scalar z2076 = z2070 * z2072;
    const Scalar z2077 = z2061 + z2063 * z2074;
    const Scalar z2078 = z2063 * z2075;
    const Scalar z2079 = z915 * z2075;
    const Scalar z2080 = z2063 * z2073 - z2071;
    const Scalar z2081 = z2062 - z2063 * z2076;
    const Scalar z2082 = z915 * z2073 + z916;
    const Scalar z2083 = z915 * z2076;
    const Scalar z2084 = z2063 - z2070 * z2073;
    const Scalar z2085 = z2068 * z2073 + z2069;
    const Scalar z2145 = k16 * s_front_left_knee;
    const Scalar z2086 = z2060 + z2070 * z2076;
    const Scalar z2146 = k16 * c_front_left_knee;
    const Scalar z2101 = n2 * z2083;
    const Scalar z2087 = k19 - z2085;
    const Scalar z2147 = c_front_left_knee * z2146;
    const Scalar z2093 = s_front_right_hip * z2080;
    const Scalar z2094 = c_front_right_hip * z2080;
    const Scalar z2095 = s_front_right_hip * z2084 + c_front_right_hip * z2082;
    const Scalar z2100 = z2079 - z2086;
    const Scalar z2102 = c_front_right_hip * z2078 + s_front_right_hip * z2081;
    const Scalar z2103 = s_front_right_hip * z2078 - c_front_right_hip * z2081;
    const Scalar z2139 = z2034 - z2077;
    const Scalar z2088 = s_front_right_hip * z2087;
    const Scalar z2148 = s_front_left_knee * z2145;
    const Scalar z2104 = c_front_right_hip * z2101 + s_front_right_hip * z2100;
    const Scalar z2089 = s_front_right_hip * z2088;
    const Scalar z2149 = s_front_left_knee * z2146;
    const Scalar z2092 = c_front_right_hip * z2088;
    const Scalar z2109 = n0_05 * z2103;
    const Scalar z2112 = z2093 + n0_2 * z2103;
    const Scalar z2115 = n0_05 * z2077 + z2094 + n0_2 * z2102;
    const Scalar z2140 = z2035 + z2102;
    const Scalar z2141 = z2036 + z2103;
    const Scalar z2096 = s_front_right_hip * z2095;
    const Scalar z2098 = c_front_right_hip * z2095 - z2082;
    const Scalar z2099 = c_front_right_hip * z2095;
    const Scalar z2090 = k19 - z2089;
    const Scalar z2150 = n0_2 * z2147;
    const Scalar z2091 = z2085 + z2089;
    const Scalar z2152 = n0_2 * z2150;
    const Scalar z2154 = n0_124 - z2150;
    const Scalar z2151 = n0_2 * z2149;
    const Scalar z2153 = k17 - z2152;
    const Scalar z2155 = n1 / z2153;
    const Scalar z2105 = s_front_right_hip * z2104;
    const Scalar z2108 = c_front_right_hip * z2104 - z2083;
    const Scalar z2130 = z2025 + z2109;
    const Scalar z2097 = z2084 - z2096;
    const Scalar z2133 = z2028 + z2112;
    const Scalar z2136 = z2031 + z2115;
    const Scalar z2106 = z2079 - z2105;
    const Scalar z2107 = z2086 + z2105;
    const Scalar z2110 = n0_05 * z2108;
    const Scalar z2113 = z2096 + n0_2 * z2108;
    const Scalar z2117 = z2097 - n0_05 * z2103 - n0_2 * z2108;
    const Scalar z2143 = z2038 + z2108;
    const Scalar z2156 = z2154 * z2155;
    const Scalar z2157 = z2151 * z2155;
    const Scalar z2111 = n0_05 * z2107;
    const Scalar z2114 = z2098 - n0_2 * z2107;
    const Scalar z2116 = z2099 + n0_05 * z2102 + n0_2 * z2106;
    const Scalar z2142 = z2037 - z2106;
    const Scalar z2144 = z2039 - z2107;
    const Scalar z2124 = n0_05 * (z2097 - z2109) - n0_2 * z2110;
    const Scalar z2131 = z2026 + z2110;
    const Scalar z2126 = z2092 - n0_05 * z2112 + n0_2 * (z2097 - z2113);
    const Scalar z2160 = z2148 + z2151 * z2157;
    const Scalar z2134 = z2029 + z2113;
    const Scalar z2158 = z2147 + z2154 * z2156;
    const Scalar z2128 = z2091 + n0_05 * (z2094 + z2115) + n0_2 * (z2099 + z2116);
    const Scalar z2159 = z2149 - z2154 * z2157;
    const Scalar z2125 = z2020 + z2124;
    const Scalar z2127 = z2022 + z2126;
    const Scalar z2137 = z2032 + z2116;
    const Scalar z2138 = z2033 + z2117;
    const Scalar z2122 = z2090 - n0_2 * (z2098 + z2114);
    const Scalar z2129 = z2024 - z2128;
    const Scalar z2123 = z2018 - z2122;
    const Scalar z2135 = z2030 + z2114;
    const Scalar z2120 = n0_05 * z2098 - n0_2 * z2111;
    const Scalar z2121 = z2016 + z2120;
    const Scalar z2132 = z2027 + z2111;
    const Scalar z2118 = n0_05 * z2111;
    const Scalar z2119 = z2014 - z2118;
    const Scalar z2161 = z2158 - z2160;
    const Scalar z2162 = n2 * z2159;
    const Scalar z2163 = s_front_left_thigh * z2161 + c_front_left_thigh * z2162;
    const Scalar z2164 = s_front_left_thigh * z2163;
    const Scalar z2167 = c_front_left_thigh * z2163 - z2159;
    const Scalar z2165 = z2160 + z2164;
    const Scalar z2166 = z2158 - z2164;
    const Scalar z2168 = n0_08 * z2167;
    const Scalar z2169 = n0_08 * z2165;
    const Scalar z2170 = n0_08 * z2166;
    const Scalar z2173 = z1045 + n0_08 * z2168;
    const Scalar z2171 = z1044 - n0_08 * z2169;
    const Scalar z2174 = z1043 + n0_08 * z2170;
    const Scalar z2175 = n0_1048 - z2169;
    const Scalar z2176 = n0_1048 - z2170;
    const Scalar z2172 = k18 + z2171;
    const Scalar z2177 = n1 / z2172;
    const Scalar z2178 = z2173 * z2177;
    const Scalar z2179 = z2168 * z2177;
    const Scalar z2180 = z1018 * z2177;
    const Scalar z2181 = z2175 * z2177;
    const Scalar z2182 = z2166 + z2168 * z2179;
    const Scalar z2183 = z2168 * z2180;
    const Scalar z2184 = z1018 * z2180;
    const Scalar z2185 = z2168 * z2178 - z2176;
    const Scalar z2186 = z2167 - z2168 * z2181;
    const Scalar z2187 = z1018 * z2178 + z1019;
    const Scalar z2188 = z1018 * z2181;
    const Scalar z2189 = z2168 - z2175 * z2178;
    const Scalar z2190 = z2173 * z2178 + z2174;
    const Scalar z2191 = z2165 + z2175 * z2181;
    const Scalar z2206 = n2 * z2188;
    const Scalar z2192 = k19 - z2190;
    const Scalar z2198 = s_front_left_hip * z2185;
    const Scalar z2199 = c_front_left_hip * z2185;
    const Scalar z2200 = s_front_left_hip * z2189 - c_front_left_hip * z2187;
    const Scalar z2205 = z2184 - z2191;
    const Scalar z2207 = s_front_left_hip * z2186 - c_front_left_hip * z2183;
    const Scalar z2208 = s_front_left_hip * z2183 + c_front_left_hip * z2186;
    const Scalar z2244 = z2139 - z2182;
    const Scalar z2193 = s_front_left_hip * z2192;
    const Scalar z2209 = s_front_left_hip * z2205 - c_front_left_hip * z2206;
    const Scalar z2194 = s_front_left_hip * z2193;
    const Scalar z2197 = c_front_left_hip * z2193;
    const Scalar z2214 = n0_05 * z2208;
    const Scalar z2217 = z2198 + n0_2 * z2208;
    const Scalar z2246 = z2141 - z2208;
    const Scalar z2201 = s_front_left_hip * z2200;
    const Scalar z2203 = c_front_left_hip * z2200 + z2187;
    const Scalar z2204 = c_front_left_hip * z2200;
    const Scalar z2220 = n0_05 * z2182 + z2199 - n0_2 * z2207;
    const Scalar z2245 = z2140 + z2207;
    const Scalar z2195 = k19 - z2194;
    const Scalar z2196 = z2190 + z2194;
    const Scalar z2235 = z2130 + z2214;
    const Scalar z2202 = z2189 - z2201;
    const Scalar z2210 = s_front_left_hip * z2209;
    const Scalar z2213 = c_front_left_hip * z2209 + z2188;
    const Scalar z2238 = z2133 - z2217;
    const Scalar z2241 = z2136 - z2220;
    const Scalar z2211 = z2184 - z2210;
    const Scalar z2212 = z2191 + z2210;
    const Scalar z2215 = n0_05 * z2213;
    const Scalar z2218 = z2201 - n0_2 * z2213;
    const Scalar z2222 = z2202 + n0_05 * z2208 + n0_2 * z2213;
    const Scalar z2248 = z2143 + z2213;
    const Scalar z2216 = n0_05 * z2212;
    const Scalar z2219 = z2203 + n0_2 * z2212;
    const Scalar z2221 = z2204 + n0_05 * z2207 - n0_2 * z2211;
    const Scalar z2247 = z2142 - z2211;
    const Scalar z2249 = z2144 - z2212;
    const Scalar z2229 = n0_05 * (z2202 + z2214) + n0_2 * z2215;
    const Scalar z2236 = z2131 - z2215;
    const Scalar z2231 = z2197 - n0_05 * z2217 - n0_2 * (z2202 - z2218);
    const Scalar z2239 = z2134 - z2218;
    const Scalar z2223 = n0_05 * z2216;
    const Scalar z2225 = n0_05 * z2203 + n0_2 * z2216;
    const Scalar z2237 = z2132 - z2216;
    const Scalar z2227 = n0_2 * (z2203 + z2219) + z2195;
    const Scalar z2233 = z2196 + n0_05 * (z2199 + z2220) - n0_2 * (z2204 + z2221);
    const Scalar z2224 = z2119 - z2223;
    const Scalar z2242 = z2137 - z2221;
    const Scalar z2226 = z2121 + z2225;
    const Scalar z2230 = z2125 + z2229;
    const Scalar z2240 = z2135 - z2219;
    const Scalar z2243 = z2138 - z2222;
    const Scalar z2232 = z2127 + z2231;
    const Scalar z2228 = z2123 - z2227;
    const Scalar z2234 = z2129 - z2233;
    const Scalar z2250 = n1 / z2234;
    const Scalar z2251 = z2230 * z2250;
    const Scalar z2252 = z2232 * z2250;
    const Scalar z2253 = z2241 * z2250;
    const Scalar z2254 = z2242 * z2250;
    const Scalar z2255 = z2243 * z2250;
    const Scalar z2256 = z2235 - z2241 * z2251;
    const Scalar z2257 = z2224 - z2230 * z2251;
    const Scalar z2258 = z2241 * z2253 - z2244;
    const Scalar z2259 = z2236 - z2242 * z2251;
    const Scalar z2260 = z2237 + z2243 * z2251;
    const Scalar z2261 = z2238 - z2241 * z2252;
    const Scalar z2344 = z1191 - n0_2 * z1195;
    const Scalar z2262 = z2226 - z2230 * z2252;
    const Scalar z2345 = s_front_left_knee * z1206 - c_front_left_knee * z2344;
    const Scalar z2263 = z2241 * z2254 + z2245;
    const Scalar z2347 = z1229 - n0_2 * z1233;
    const Scalar z2264 = z2239 - z2242 * z2252;
    const Scalar z2348 = s_front_right_knee * z1244 - c_front_right_knee * z2347;
    const Scalar z2265 = z2228 - z2232 * z2252;
    const Scalar z2350 = z1267 - n0_2 * z1271;
    const Scalar z2266 = z2242 * z2254 - z2247;
    const Scalar z2351 = s_rear_left_knee * z1282 - c_rear_left_knee * z2350;
    const Scalar z2269 = z2242 * z2255 - z2248;
    const Scalar z2268 = z2241 * z2255 - z2246;
    const Scalar z2271 = n1 / z2265;
    const Scalar z2267 = z2240 - z2243 * z2252;
    const Scalar z2270 = z2243 * z2255 - z2249;
    const Scalar z2353 = z1305 - n0_2 * z1309;
    const Scalar z2354 = s_rear_right_knee * z1320 - c_rear_right_knee * z2353;
    const Scalar z2356 = n0_032 * z1325;
    const Scalar z2357 = k0 * z1325 - n0_032 * z2354;
    const Scalar z2358 = z1844 + z2357;
    const Scalar z2272 = z2262 * z2271;
    const Scalar z2273 = z2261 * z2271;
    const Scalar z2274 = z2264 * z2271;
    const Scalar z2275 = z2267 * z2271;
    const Scalar z2359 = k24 * z2358;
    const Scalar z2360 = z2356 - k25 * z2358;
    const Scalar z2276 = z2256 - z2261 * z2272;
    const Scalar z2277 = z2257 - z2262 * z2272;
    const Scalar z2278 = z2258 + z2261 * z2273;
    const Scalar z2279 = z2259 - z2264 * z2272;
    const Scalar z2280 = z2260 + z2267 * z2272;
    const Scalar z2285 = z2267 * z2275 + z2270;
    const Scalar z2282 = z2264 * z2274 + z2266;
    const Scalar z2284 = z2264 * z2275 + z2269;
    const Scalar z2281 = z2261 * z2274 + z2263;
    const Scalar z2283 = z2261 * z2275 + z2268;
    const Scalar z2286 = n1 / z2277;
    const Scalar z2361 = s_rear_right_knee * z1336 + c_rear_right_knee * z2360;
    const Scalar z2365 = n0_124 * z1305 - z1844 - k7 * z1309 + n0_2 * z2361;
    const Scalar z2362 = s_rear_right_knee * z2360 - c_rear_right_knee * z1336;
    const Scalar z2363 = n0_124 * z1309 - z2361;
    const Scalar z2364 = n0_124 * z1315 - z2362;
    const Scalar z2366 = z1843 + z2365;
    const Scalar z2368 = z1856 * z2366 + z2363;
    const Scalar z2367 = z1855 * z2366;
    const Scalar z2369 = z1857 * z2366 - z2364;
    const Scalar z2287 = z2276 * z2286;
    const Scalar z2288 = z2279 * z2286;
    const Scalar z2375 = n0_0002 * z1357 - z1843;
    const Scalar z2289 = z2280 * z2286;
    const Scalar z2370 = s_rear_right_thigh * z2369 + c_rear_right_thigh * z2368;
    const Scalar z2295 = z2280 * z2289 + z2285;
    const Scalar z2371 = s_rear_right_thigh * z2368 - c_rear_right_thigh * z2369;
    const Scalar z2292 = z2279 * z2288 + z2282;
    const Scalar z2294 = z2279 * z2289 - z2284;
    const Scalar z2374 = n0_1048 * z1291 - z1354 - k26 * z1299 - n0_08 * z2371;
    const Scalar z2376 = n0_1048 * z1287 - z1355 - k27 * z1295 - n0_08 * z2370;
    const Scalar z2373 = n0_1048 * z1299 + z2371;
    const Scalar z2372 = n0_1048 * z1295 + z2370;
    const Scalar z2291 = z2276 * z2288 + z2281;
    const Scalar z2293 = z2276 * z2289 - z2283;
    const Scalar z2290 = z2276 * z2287 + z2278;
    const Scalar z2377 = z1842 - z2374;
    const Scalar z2379 = z1878 * z2377 - z2376;
    const Scalar z2381 = z1359 - z1880 * z2377;
    const Scalar z2382 = z1881 * z2377 - z2373;
    const Scalar z2380 = z1879 * z2377 + z2372;
    const Scalar z2378 = z1877 * z2377;
    const Scalar z2303 = z25 * z2292 + z28 * z2294 + z29 * z2291;
    const Scalar z2304 = z25 * z2294 + z28 * z2295 + z29 * z2293;
    const Scalar z2302 = z25 * z2291 + z28 * z2293 + z29 * z2290;
    const Scalar z2313 = z25 * z2303 + z28 * z2304 + z29 * z2302;
    const Scalar z2300 = z19 * z2291 + z23 * z2292 + z24 * z2294;
    const Scalar z2297 = z17 * z2291 + z18 * z2292 + z30 * z2294;
    const Scalar z2314 = n1 / z2313;
    const Scalar z2299 = z19 * z2290 + z23 * z2291 + z24 * z2293;
    const Scalar z2296 = z17 * z2290 + z18 * z2291 + z30 * z2293;
    const Scalar z2301 = z19 * z2293 + z23 * z2294 + z24 * z2295;
    const Scalar z2298 = z17 * z2293 + z18 * z2294 + z30 * z2295;
    const Scalar z2388 = k0 * z1368 - n0_032 * z2351;
    const Scalar z2387 = n0_032 * z1368;
    const Scalar z2389 = z1841 + z2388;
    const Scalar z2386 = s_rear_right_hip * z2375 + c_rear_right_hip * z2379;
    const Scalar z2385 = s_rear_right_hip * z2379 - c_rear_right_hip * z2375;
    const Scalar z2391 = z2387 - k25 * z2389;
    const Scalar z2390 = k24 * z2389;
    const Scalar z2383 = s_rear_right_hip * z2382 + c_rear_right_hip * z2381;
    const Scalar z2384 = s_rear_right_hip * z2381 - c_rear_right_hip * z2382;
    const Scalar z2310 = z25 * z2300 + z28 * z2301 + z29 * z2299;
    const Scalar z2309 = z19 * z2299 + z23 * z2300 + z24 * z2301;
    const Scalar z2308 = z17 * z2299 + z18 * z2300 + z30 * z2301;
    const Scalar z2316 = z2310 * z2314;
    const Scalar z2319 = z2309 - z2310 * z2316;
    const Scalar z2307 = z25 * z2297 + z28 * z2298 + z29 * z2296;
    const Scalar z2305 = z17 * z2296 + z18 * z2297 + z30 * z2298;
    const Scalar z2318 = z2307 * z2316 - z2308;
    const Scalar z2326 = n1 / z2319;
    const Scalar z2392 = s_rear_left_knee * z1379 + c_rear_left_knee * z2391;
    const Scalar z2396 = n0_124 * z1267 - z1841 - k7 * z1271 + n0_2 * z2392;
    const Scalar z2393 = s_rear_left_knee * z2391 - c_rear_left_knee * z1379;
    const Scalar z2394 = n0_124 * z1271 - z2392;
    const Scalar z2395 = n0_124 * z1277 - z2393;
    const Scalar z2397 = z1840 + z2396;
    const Scalar z2398 = z1945 * z2397;
    const Scalar z2315 = z2307 * z2314;
    const Scalar z2317 = z2305 - z2307 * z2315;
    const Scalar z2399 = z1946 * z2397 + z2394;
    const Scalar z2400 = z1947 * z2397 - z2395;
    const Scalar z2329 = z2318 * z2326;
    const Scalar z2332 = z2317 - z2318 * z2329;
    const Scalar z2406 = n0_0002 * z1400 - z1840;
    const Scalar z2402 = s_rear_left_thigh * z2399 - c_rear_left_thigh * z2400;
    const Scalar z2401 = s_rear_left_thigh * z2400 + c_rear_left_thigh * z2399;
    const Scalar z2340 = n1 / z2332;
    const Scalar z2419 = k0 * z1411 - n0_032 * z2348;
    const Scalar z2405 = z1397 + n0_1048 * z1253 + k26 * z1261 - n0_08 * z2402;
    const Scalar z2407 = z1398 + n0_1048 * z1249 + k27 * z1257 - n0_08 * z2401;
    const Scalar z2404 = n0_1048 * z1261 - z2402;
    const Scalar z2403 = n0_1048 * z1257 - z2401;
    const Scalar z2418 = n0_032 * z1411;
    const Scalar z2420 = z1838 + z2419;
    const Scalar z2450 = k0 * z1454 - n0_032 * z2345;
    const Scalar z2449 = n0_032 * z1454;
    const Scalar z2451 = z1835 + z2450;
    const Scalar z2422 = z2418 - k25 * z2420;
    const Scalar z2408 = z1839 + z2405;
    const Scalar z2410 = z1968 * z2408 + z2407;
    const Scalar z2453 = z2449 - k25 * z2451;
    const Scalar z2437 = n0_0002 * z1443 - z1837;
    const Scalar z2412 = z1402 + z1970 * z2408;
    const Scalar z2413 = z1971 * z2408 - z2404;
    const Scalar z2468 = n0_0002 * z1486 - z1834;
    const Scalar z2411 = z1969 * z2408 + z2403;
    const Scalar z2409 = z1967 * z2408;
    const Scalar z2421 = k24 * z2420;
    const Scalar z2452 = k24 * z2451;
    const Scalar z2423 = s_front_right_knee * z1422 + c_front_right_knee * z2422;
    const Scalar z2427 = n0_124 * z1229 - z1838 - k7 * z1233 + n0_2 * z2423;
    const Scalar z2424 = s_front_right_knee * z2422 - c_front_right_knee * z1422;
    const Scalar z2425 = n0_124 * z1233 - z2423;
    const Scalar z2428 = z1837 + z2427;
    const Scalar z2426 = n0_124 * z1239 - z2424;
    const Scalar z2430 = z2051 * z2428 + z2425;
    const Scalar z2429 = z2050 * z2428;
    const Scalar z2431 = z2052 * z2428 - z2426;
    const Scalar z2454 = s_front_left_knee * z1465 + c_front_left_knee * z2453;
    const Scalar z2458 = n0_124 * z1191 - z1835 - k7 * z1195 + n0_2 * z2454;
    const Scalar z2455 = s_front_left_knee * z2453 - c_front_left_knee * z1465;
    const Scalar z2456 = n0_124 * z1195 - z2454;
    const Scalar z2459 = z1834 + z2458;
    const Scalar z2457 = n0_124 * z1201 - z2455;
    const Scalar z2461 = z2156 * z2459 + z2456;
    const Scalar z2460 = z2155 * z2459;
    const Scalar z2462 = z2157 * z2459 - z2457;
    const Scalar z2433 = s_front_right_thigh * z2430 - c_front_right_thigh * z2431;
    const Scalar z2432 = s_front_right_thigh * z2431 + c_front_right_thigh * z2430;
    const Scalar z2436 = n0_1048 * z1215 - z1440 - k26 * z1223 - n0_08 * z2433;
    const Scalar z2438 = n0_1048 * z1211 - z1441 - k27 * z1219 - n0_08 * z2432;
    const Scalar z2435 = n0_1048 * z1223 + z2433;
    const Scalar z2434 = n0_1048 * z1219 + z2432;
    const Scalar z2439 = z1836 - z2436;
    const Scalar z2441 = z2073 * z2439 - z2438;
    const Scalar z2443 = z1445 - z2075 * z2439;
    const Scalar z2444 = z2076 * z2439 - z2435;
    const Scalar z2442 = z2074 * z2439 + z2434;
    const Scalar z2440 = z2072 * z2439;
    const Scalar z2464 = s_front_left_thigh * z2461 - c_front_left_thigh * z2462;
    const Scalar z2463 = s_front_left_thigh * z2462 + c_front_left_thigh * z2461;
    const Scalar z2467 = z1483 + n0_1048 * z1177 + k26 * z1185 - n0_08 * z2464;
    const Scalar z2469 = z1484 + n0_1048 * z1173 + k27 * z1181 - n0_08 * z2463;
    const Scalar z2466 = n0_1048 * z1185 - z2464;
    const Scalar z2465 = n0_1048 * z1181 - z2463;
    const Scalar z2470 = z1833 + z2467;
    const Scalar z2472 = z2178 * z2470 + z2469;
    const Scalar z2473 = z2179 * z2470 + z2465;
    const Scalar z2471 = z2177 * z2470;
    const Scalar z2417 = s_rear_left_hip * z2406 + c_rear_left_hip * z2410;
    const Scalar z2416 = s_rear_left_hip * z2410 - c_rear_left_hip * z2406;
    const Scalar z2448 = s_front_right_hip * z2437 + c_front_right_hip * z2441;
    const Scalar z2447 = s_front_right_hip * z2441 - c_front_right_hip * z2437;
    const Scalar z2414 = s_rear_left_hip * z2413 + c_rear_left_hip * z2412;
    const Scalar z2415 = s_rear_left_hip * z2412 - c_rear_left_hip * z2413;
    const Scalar z2474 = z1488 + z2180 * z2470;
    const Scalar z2475 = z2181 * z2470 - z2466;
    const Scalar z2480 = n12_24 * z1162 - z2380 + z2411 - z2442 + z2473;
    const Scalar z2479 = s_front_left_hip * z2468 + c_front_left_hip * z2472;
    const Scalar z2478 = s_front_left_hip * z2472 - c_front_left_hip * z2468;
    const Scalar z2445 = s_front_right_hip * z2444 + c_front_right_hip * z2443;
    const Scalar z2446 = s_front_right_hip * z2443 - c_front_right_hip * z2444;
    const Scalar z2476 = s_front_left_hip * z2475 + c_front_left_hip * z2474;
    const Scalar z2485 = n0_2948 * z1168 - z2386 - z2417 - z2448 - z2479 - n0_05 * (z2380 + z2411 + z2442 + z2473)
        - n0_2 * (z2383 - z2414 - z2445 + z2476);
    const Scalar z2481 = n12_24 * z1163 + z2383 - z2414 + z2445 - z2476;
    const Scalar z2477 = s_front_left_hip * z2474 - c_front_left_hip * z2475;
    const Scalar z2483 = n0_0306 * z1172 + z1833 + z1836 + z1839 + z1842 - n0_05 * (z2384 + z2415 + z2446 + z2477);
    const Scalar z2484 = n0_3254 * z1171 - z2385 - z2416 - z2447 - z2478 - n0_2 * (z2384 - z2415 - z2446 + z2477);
    const Scalar z2482 = n12_24 * z1164 + z2384 - z2415 + z2446 - z2477;
    const Scalar z2487 = z2251 * z2485 + z2483;
    const Scalar z2488 = z2252 * z2485 - z2484;
    const Scalar z2489 = z2253 * z2485 + z2480;
    const Scalar z2490 = z2254 * z2485 + z2481;
    const Scalar z2491 = z2255 * z2485 - z2482;
    const Scalar z2486 = z2250 * z2485;
    const Scalar z2493 = z2272 * z2488 - z2487;
    const Scalar z2494 = z2273 * z2488 - z2489;
    const Scalar z2495 = z2274 * z2488 - z2490;
    const Scalar z2496 = z2275 * z2488 - z2491;
    const Scalar z2492 = z2271 * z2488;
    const Scalar z2498 = z2287 * z2493 - z2494;
    const Scalar z2499 = z2288 * z2493 - z2495;
    const Scalar z2500 = z2289 * z2493 + z2496;
    const Scalar z2497 = z2286 * z2493;
    const Scalar z2501 = z17 * z2498 + z18 * z2499 + z30 * z2500;
    const Scalar z2502 = z19 * z2498 + z23 * z2499 + z24 * z2500;
    const Scalar z2503 = z25 * z2499 + z28 * z2500 + z29 * z2498;
    const Scalar z2504 = z2314 * z2503;
    const Scalar z2505 = z2315 * z2503 - z2501;
    const Scalar z2506 = z2316 * z2503 - z2502;
    const Scalar z2509 = z2326 * z2506;
    const Scalar z2512 = z2329 * z2506 + z2505;
    const Scalar z2514 = z2340 * z2512;
    const Scalar z2518 = z2329 * z2514 + z2509;
    const Scalar z2519 = z2504 + z2315 * z2514 + z2316 * z2518;
    const Scalar z2520 = z17 * z2514 + z19 * z2518 - z29 * z2519;
    const Scalar z2521 = z18 * z2514 + z23 * z2518 - z25 * z2519;
    const Scalar z2522 = z30 * z2514 + z24 * z2518 - z28 * z2519;
    const Scalar z2523 = z2497 + z2287 * z2520 + z2288 * z2521 + z2289 * z2522;
    const Scalar z2524 = z2492 - z2273 * z2520 - z2274 * z2521 + z2275 * z2522 + z2272 * z2523;
    const Scalar z2525 = z2255 * z2522 - z2486 - z2253 * z2520 - z2254 * z2521 + z2251 * z2523 - z2252 * z2524;
    const Scalar z2528 = z2522 - n0_05 * z2523 - n0_2 * z2524;
    const Scalar z2553 = z2522 + n0_05 * z2523 - n0_2 * z2524;
    const Scalar z2578 = z2522 - n0_05 * z2523 + n0_2 * z2524;
    const Scalar z2602 = z2522 + n0_05 * z2523 + n0_2 * z2524;
    const Scalar z2526 = z2520 + n0_05 * z2525;
    const Scalar z2527 = z2521 - n0_2 * z2525;
    const Scalar z2529 = s_front_left_hip * z2525 - c_front_left_hip * z2524;
    const Scalar z2530 = s_front_left_hip * z2524 + c_front_left_hip * z2525;
    const Scalar z2552 = z2520 - n0_05 * z2525;
    const Scalar z2554 = s_front_right_hip * z2525 - c_front_right_hip * z2524;
    const Scalar z2555 = s_front_right_hip * z2524 + c_front_right_hip * z2525;
    const Scalar z2577 = z2521 + n0_2 * z2525;
    const Scalar z2579 = s_rear_left_hip * z2525 - c_rear_left_hip * z2524;
    const Scalar z2580 = s_rear_left_hip * z2524 + c_rear_left_hip * z2525;
    const Scalar z2604 = s_rear_right_hip * z2524 + c_rear_right_hip * z2525;
    const Scalar z2603 = s_rear_right_hip * z2525 - c_rear_right_hip * z2524;
    const Scalar z2531 = s_front_left_hip * z2528 + c_front_left_hip * z2527;
    const Scalar z2532 = s_front_left_hip * z2527 - c_front_left_hip * z2528;
    const Scalar z2556 = s_front_right_hip * z2553 + c_front_right_hip * z2527;
    const Scalar z2557 = s_front_right_hip * z2527 - c_front_right_hip * z2553;
    const Scalar z2533 = z2471 + z2178 * z2530 + z2179 * z2526 - z2180 * z2531 - z2181 * z2532;
    const Scalar z2558 = z2440 + z2073 * z2555 - z2074 * z2552 - z2075 * z2556 + z2076 * z2557;
    const Scalar z2535 = z2526 + n0_08 * z2530;
    const Scalar z2560 = z2552 - n0_08 * z2555;
    const Scalar z2536 = z2532 + n0_08 * z2533;
    const Scalar z2534 = z2523 - z2533;
    const Scalar z2561 = z2557 - n0_08 * z2558;
    const Scalar z2559 = z2523 - z2558;
    const Scalar z2581 = s_rear_left_hip * z2578 + c_rear_left_hip * z2577;
    const Scalar z2582 = s_rear_left_hip * z2577 - c_rear_left_hip * z2578;
    const Scalar z2583 = z2409 + z1968 * z2580 + z1969 * z2526 - z1970 * z2581 - z1971 * z2582;
    const Scalar z2585 = z2526 + n0_08 * z2580;
    const Scalar z2605 = s_rear_right_hip * z2602 + c_rear_right_hip * z2577;
    const Scalar z2606 = s_rear_right_hip * z2577 - c_rear_right_hip * z2602;
    const Scalar z2607 = z2378 + z1878 * z2604 - z1879 * z2552 - z1880 * z2605 + z1881 * z2606;
    const Scalar z2609 = z2552 - n0_08 * z2604;
    const Scalar z2586 = z2582 + n0_08 * z2583;
    const Scalar z2584 = z2523 - z2583;
    const Scalar z2608 = z2523 - z2607;
    const Scalar z2610 = z2606 - n0_08 * z2607;
    const Scalar z2539 = c_front_left_thigh * z2535 + s_front_left_thigh * z2536;
    const Scalar z2540 = s_front_left_thigh * z2535 - c_front_left_thigh * z2536;
    const Scalar z2541 = z2156 * z2539 - z2460 + z2157 * z2540;
    const Scalar z2564 = c_front_right_thigh * z2560 + s_front_right_thigh * z2561;
    const Scalar z2565 = s_front_right_thigh * z2560 - c_front_right_thigh * z2561;
    const Scalar z2566 = z2051 * z2564 - z2429 + z2052 * z2565;
    const Scalar z2544 = z2539 - n0_2 * z2541;
    const Scalar z2542 = z2529 + z2541;
    const Scalar z2589 = c_rear_left_thigh * z2585 + s_rear_left_thigh * z2586;
    const Scalar z2543 = z1178 - z2542;  // acceleration of joint front_left_thigh_link
    const Scalar z2590 = s_rear_left_thigh * z2585 - c_rear_left_thigh * z2586;
    const Scalar z2591 = z1946 * z2589 - z2398 + z1947 * z2590;
    const Scalar z2548 = s_front_left_knee * z2540 - c_front_left_knee * z2544;
    const Scalar z2550 = z2452 + k25 * z2548;
    const Scalar z2569 = z2564 - n0_2 * z2566;
    const Scalar z2573 = s_front_right_knee * z2565 - c_front_right_knee * z2569;
    const Scalar z2594 = z2589 - n0_2 * z2591;
    const Scalar z2551 = z2541 + z2550;
    const Scalar z2613 = c_rear_right_thigh * z2609 + s_rear_right_thigh * z2610;
    const Scalar z2614 = s_rear_right_thigh * z2609 - c_rear_right_thigh * z2610;
    const Scalar z2615 = z1856 * z2613 - z2367 + z1857 * z2614;
    const Scalar z2598 = s_rear_left_knee * z2590 - c_rear_left_knee * z2594;
    const Scalar z2567 = z2554 + z2566;
    const Scalar z2575 = z2421 + k25 * z2573;
    const Scalar z2592 = z2579 + z2591;
    const Scalar z2600 = z2390 + k25 * z2598;
    const Scalar z2618 = z2613 - n0_2 * z2615;
    const Scalar z2616 = z2603 + z2615;
    const Scalar z2568 = z1216 - z2567;  // acceleration of joint front_right_thigh_link
    const Scalar z2576 = z2566 + z2575;
    const Scalar z2593 = z1254 - z2592;  // acceleration of joint rear_left_thigh_link
    const Scalar z2601 = z2591 + z2600;
    const Scalar z2617 = z1292 - z2616;  // acceleration of joint rear_right_thigh_link
    const Scalar z2622 = s_rear_right_knee * z2614 - c_rear_right_knee * z2618;
    const Scalar z2624 = z2359 + k25 * z2622;
    const Scalar z2625 = z2615 + z2624;
    accelerations.trunk_x = -z2514;
    accelerations.trunk_y = -z2518;
    accelerations.trunk_z = z2519;
    accelerations.trunk_attitude_omega_x = z2523;
    accelerations.trunk_attitude_omega_y = -z2524;
    accelerations.trunk_attitude_omega_z = z2525;
    accelerations.front_left_hip = -z2534;
    accelerations.front_left_thigh = z2543;
    accelerations.front_left_knee = z2551;
    accelerations.front_right_hip = -z2559;
    accelerations.front_right_thigh = z2568;
    accelerations.front_right_knee = z2576;
    accelerations.rear_left_hip = -z2584;
    accelerations.rear_left_thigh = z2593;
    accelerations.rear_left_knee = z2601;
    accelerations.rear_right_hip = -z2608;
    accelerations.rear_right_thigh = z2617;
    accelerations.rear_right_knee = z2625;
    if (!(traits::regular(z1853, z1853) && traits::regular(z1872, z1872) && traits::regular(z1943, z1943)
        && traits::regular(z1962, z1962) && traits::regular(z2048, z2048) && traits::regular(z2067, z2067)
        && traits::regular(z2153, z2153) && traits::regular(z2172, z2172) && traits::regular(z2234, z2234)
        && traits::regular(z2265, z2265) && traits::regular(z2277, z2277) && traits::regular(-z2313, -z2313)
        && traits::regular(-z2319, -z2319) && traits::regular(-z2332, -z2332))) return torsor::Status::singular;
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
    const Scalar z153 = q_front_left_thigh + q_front_left_knee;
    const Scalar z224 = q_front_right_thigh + q_front_right_knee;
    const Scalar z291 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z358 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z153, z224, z291, z358};
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
    const Scalar z154 = sines_[12], z155 = cosines_[12];
    const Scalar z225 = sines_[13], z226 = cosines_[13];
    const Scalar z292 = sines_[14], z293 = cosines_[14];
    const Scalar z359 = sines_[15], z360 = cosines_[15];
    const Scalar z26 = n2 * q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z27 = n2 * q_trunk_attitude_y * q_trunk_attitude_w;
    const Scalar z12 = n2 * q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_y * q_trunk_attitude_x;
    const Scalar z16 = n2 * q_trunk_attitude_z * q_trunk_attitude_w;
    const Scalar z21 = n2 * q_trunk_attitude_y * q_trunk_attitude_z;
    const Scalar z22 = n2 * q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z30 = z26 + z27;
    const Scalar z10 = n2 * q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z18 = z14 - z16;
    const Scalar z20 = n2 * q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z24 = z21 - z22;
    const Scalar z23 = n1 - z12 - z20;
    const Scalar z28 = n1 - z10 - z20;
    const Scalar z25 = z21 + z22;
    const Scalar z19 = z14 + z16;
    const Scalar z29 = z26 - z27;
    const Scalar z17 = n1 - z10 - z12;
    const Scalar z3284 = v_trunk_x * z30 + v_trunk_y * z24 + v_trunk_z * z28;
    const Scalar z3283 = v_trunk_x * z18 + v_trunk_y * z23 + v_trunk_z * z25;
    const Scalar z3287 = z3284 + n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z3286 = n0_2 * v_trunk_attitude_omega_z + z3283;
    const Scalar z3282 = v_trunk_y * z19 + v_trunk_z * z29 + v_trunk_x * z17;
    const Scalar z123 = v_trunk_attitude_omega_x + v_front_left_hip;
    const Scalar z194 = v_trunk_attitude_omega_x + v_front_right_hip;
    const Scalar z261 = v_trunk_attitude_omega_x + v_rear_left_hip;
    const Scalar z328 = v_trunk_attitude_omega_x + v_rear_right_hip;
    const Scalar z122 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z193 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z260 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z327 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z3285 = n0_05 * v_trunk_attitude_omega_z - z3282;
    const Scalar z121 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z192 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z259 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z1139 = n0_05 * v_front_left_hip;
    const Scalar z1141 = n0_05 * v_front_left_thigh;
    const Scalar z1143 = n0_05 * v_front_left_knee;
    const Scalar z1145 = n0_05 * v_front_right_hip;
    const Scalar z1147 = n0_05 * v_front_right_thigh;
    const Scalar z1149 = n0_05 * v_front_right_knee;
    const Scalar z1151 = n0_05 * v_rear_left_hip;
    const Scalar z1153 = n0_05 * v_rear_left_thigh;
    const Scalar z1155 = n0_05 * v_rear_left_knee;
    const Scalar z1157 = n0_05 * v_rear_right_hip;
    const Scalar z1159 = n0_05 * v_rear_right_thigh;
    const Scalar z1161 = n0_05 * v_rear_right_knee;
    const Scalar z326 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z114 = n0_05 * z25 + n0_2 * z29;
    const Scalar z117 = q_trunk_z + z114;  // place of front_left_hip_link, z
    const Scalar z325 = q_trunk_z - z114;  // place of rear_right_hip_link, z
    const Scalar z3289 = s_front_left_hip * z3286 - c_front_left_hip * z3287;
    const Scalar z3288 = s_front_left_hip * z3287 + c_front_left_hip * z3286;
    const Scalar z146 = v_front_left_thigh + z121;
    const Scalar z217 = v_front_right_thigh + z192;
    const Scalar z284 = v_rear_left_thigh + z259;
    const Scalar z351 = v_rear_right_thigh + z326;
    const Scalar z3291 = n0_08 * z123 - z3289;
    const Scalar z3290 = n0_08 * z122 - z3285;
    const Scalar z145 = s_front_left_thigh * z123 - c_front_left_thigh * z122;
    const Scalar z216 = s_front_right_thigh * z194 - c_front_right_thigh * z193;
    const Scalar z283 = s_rear_left_thigh * z261 - c_rear_left_thigh * z260;
    const Scalar z350 = s_rear_right_thigh * z328 - c_rear_right_thigh * z327;
    const Scalar z3292 = s_front_left_thigh * z3291 - c_front_left_thigh * z3290;
    const Scalar z144 = c_front_left_thigh * z123 + s_front_left_thigh * z122;
    const Scalar z3293 = s_front_left_thigh * z3290 + c_front_left_thigh * z3291;
    const Scalar z171 = s_front_left_knee * z144 + c_front_left_knee * z145;
    const Scalar z170 = s_front_left_knee * z145 - c_front_left_knee * z144;
    const Scalar z215 = c_front_right_thigh * z194 + s_front_right_thigh * z193;
    const Scalar z242 = s_front_right_knee * z215 + c_front_right_knee * z216;
    const Scalar z241 = s_front_right_knee * z216 - c_front_right_knee * z215;
    const Scalar z282 = c_rear_left_thigh * z261 + s_rear_left_thigh * z260;
    const Scalar z309 = s_rear_left_knee * z282 + c_rear_left_knee * z283;
    const Scalar z308 = s_rear_left_knee * z283 - c_rear_left_knee * z282;
    const Scalar z349 = c_rear_right_thigh * z328 + s_rear_right_thigh * z327;
    const Scalar z376 = s_rear_right_knee * z349 + c_rear_right_knee * z350;
    const Scalar z375 = s_rear_right_knee * z350 - c_rear_right_knee * z349;
    const Scalar z3294 = n0_2 * z146 + z3292;
    const Scalar z3297 = s_front_left_knee * z3294 - c_front_left_knee * z3293;
    const Scalar z3296 = s_front_left_knee * z3293 + c_front_left_knee * z3294;
    const Scalar z172 = v_front_left_knee + z146;
    const Scalar z3298 = n0_05 * v_trunk_attitude_omega_z + z3282;
    const Scalar z243 = v_front_right_knee + z217;
    const Scalar z310 = v_rear_left_knee + z284;
    const Scalar z377 = v_rear_right_knee + z351;
    const Scalar z3295 = n0_2 * z144 + z3288;
    const Scalar z187 = n0_05 * z25 - n0_2 * z29;
    const Scalar z190 = q_trunk_z - z187;  // place of front_right_hip_link, z
    const Scalar z258 = q_trunk_z + z187;  // place of rear_left_hip_link, z
    const Scalar z3310 = n0_2 * v_trunk_attitude_omega_z - z3283;
    const Scalar z3333 = n0_02 * z122 - n0_5 * z3285;
    const Scalar z3336 = n0_0014 * z122 - n0_02 * z3285;
    const Scalar z3334 = n0_02 * z123 - n0_5 * z3289;
    const Scalar z3335 = n0_0014 * z123 - n0_02 * z3289;
    const Scalar z3337 = n0_072 * z146 + n0_8 * z3292;
    const Scalar z3340 = k10 * z146 + n0_072 * z3292;
    const Scalar z3338 = n0_8 * z3288 + n0_072 * z144;
    const Scalar z3339 = n0_072 * z3288 + k10 * z144;
    const Scalar z3341 = n0_032 * z172 + n0_26 * z3296;
    const Scalar z3344 = k13 * z172 + n0_032 * z3296;
    const Scalar z3342 = n0_032 * z170 - n0_26 * z3295;
    const Scalar z3343 = k13 * z170 - n0_032 * z3295;
    const Scalar z3345 = n0_02 * z193 - n0_5 * z3298;
    const Scalar z3348 = n0_0014 * z193 - n0_02 * z3298;
    const Scalar z3302 = n0_08 * z193 - z3298;
    const Scalar z3357 = n0_02 * z260 - n0_5 * z3285;
    const Scalar z3299 = n0_05 * v_trunk_attitude_omega_x - z3284 + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z3311 = z3284 + n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z3322 = n0_05 * v_trunk_attitude_omega_x - z3284 - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z3301 = s_front_right_hip * z3286 + c_front_right_hip * z3299;
    const Scalar z3300 = s_front_right_hip * z3299 - c_front_right_hip * z3286;
    const Scalar z3346 = n0_02 * z194 + n0_5 * z3301;
    const Scalar z3347 = n0_0014 * z194 + n0_02 * z3301;
    const Scalar z3303 = n0_08 * z194 + z3301;
    const Scalar z3350 = n0_072 * z215 - n0_8 * z3300;
    const Scalar z3351 = k10 * z215 - n0_072 * z3300;
    const Scalar z3307 = n0_2 * z215 - z3300;
    const Scalar z3354 = n0_032 * z241 - n0_26 * z3307;
    const Scalar z3355 = k13 * z241 - n0_032 * z3307;
    const Scalar z3360 = n0_0014 * z260 - n0_02 * z3285;
    const Scalar z3314 = n0_08 * z260 - z3285;
    const Scalar z3313 = s_rear_left_hip * z3310 + c_rear_left_hip * z3311;
    const Scalar z3312 = s_rear_left_hip * z3311 - c_rear_left_hip * z3310;
    const Scalar z3358 = n0_02 * z261 + n0_5 * z3313;
    const Scalar z3359 = n0_0014 * z261 + n0_02 * z3313;
    const Scalar z3315 = n0_08 * z261 + z3313;
    const Scalar z3362 = n0_8 * z3312 + n0_072 * z282;
    const Scalar z3363 = n0_072 * z3312 + k10 * z282;
    const Scalar z3319 = n0_2 * z282 + z3312;
    const Scalar z3324 = s_rear_right_hip * z3310 - c_rear_right_hip * z3322;
    const Scalar z3323 = s_rear_right_hip * z3322 + c_rear_right_hip * z3310;
    const Scalar z3326 = n0_08 * z328 - z3324;
    const Scalar z3325 = n0_08 * z327 - z3298;
    const Scalar z3304 = s_front_right_thigh * z3303 - c_front_right_thigh * z3302;
    const Scalar z3305 = s_front_right_thigh * z3302 + c_front_right_thigh * z3303;
    const Scalar z3349 = n0_072 * z217 - n0_8 * z3304;
    const Scalar z3352 = k10 * z217 - n0_072 * z3304;
    const Scalar z3306 = n0_2 * z217 - z3304;
    const Scalar z3309 = c_front_right_knee * z3305 + s_front_right_knee * z3306;
    const Scalar z3308 = s_front_right_knee * z3305 - c_front_right_knee * z3306;
    const Scalar z3366 = n0_032 * z308 - n0_26 * z3319;
    const Scalar z3367 = k13 * z308 - n0_032 * z3319;
    const Scalar z3353 = n0_032 * z243 - n0_26 * z3308;
    const Scalar z3356 = k13 * z243 - n0_032 * z3308;
    const Scalar z3316 = s_rear_left_thigh * z3315 - c_rear_left_thigh * z3314;
    const Scalar z3327 = s_rear_right_thigh * z3326 - c_rear_right_thigh * z3325;
    const Scalar z3317 = s_rear_left_thigh * z3314 + c_rear_left_thigh * z3315;
    const Scalar z3328 = s_rear_right_thigh * z3325 + c_rear_right_thigh * z3326;
    const Scalar z3318 = n0_2 * z284 + z3316;
    const Scalar z3329 = n0_2 * z351 - z3327;
    const Scalar z3321 = s_rear_left_knee * z3318 - c_rear_left_knee * z3317;
    const Scalar z3320 = s_rear_left_knee * z3317 + c_rear_left_knee * z3318;
    const Scalar z3387 = n0_08 * s_front_left_hip;
    const Scalar z3332 = c_rear_right_knee * z3328 + s_rear_right_knee * z3329;
    const Scalar z3331 = s_rear_right_knee * z3328 - c_rear_right_knee * z3329;
    const Scalar z3386 = n0_08 * c_front_left_hip;
    const Scalar z3388 = n0_05 + z3386;
    const Scalar z3361 = n0_072 * z284 + n0_8 * z3316;
    const Scalar z3364 = k10 * z284 + n0_072 * z3316;
    const Scalar z3381 = n0_02 * c_front_left_hip;
    const Scalar z3330 = n0_2 * z349 - z3323;
    const Scalar z3391 = n0_2 * z29 + z28 * z3387 + z25 * z3388;
    const Scalar z3443 = n0_2 * c_front_right_thigh;
    const Scalar z3392 = q_trunk_z + z3391;
    const Scalar z3402 = n0_2 * s_front_left_thigh;
    const Scalar z3406 = n0_2 - z3402;
    const Scalar z3365 = n0_032 * z310 + n0_26 * z3320;
    const Scalar z3368 = k13 * z310 + n0_032 * z3320;
    const Scalar z3403 = n0_2 * c_front_left_thigh;
    const Scalar z3396 = n0_072 * c_front_left_thigh;
    const Scalar z3369 = n0_02 * z327 - n0_5 * z3298;
    const Scalar z3372 = n0_0014 * z327 - n0_02 * z3298;
    const Scalar z3415 = n0_032 * z155;
    const Scalar z3427 = n0_08 * s_front_right_hip;
    const Scalar z3370 = n0_02 * z328 - n0_5 * z3324;
    const Scalar z3371 = n0_0014 * z328 - n0_02 * z3324;
    const Scalar z3436 = n0_072 * c_front_right_thigh;
    const Scalar z3442 = n0_2 * s_front_right_thigh;
    const Scalar z3446 = n0_2 - z3442;
    const Scalar z3373 = n0_072 * z351 - n0_8 * z3327;
    const Scalar z3376 = k10 * z351 - n0_072 * z3327;
    const Scalar z3445 = n0_08 * s_front_right_hip + c_front_right_hip * z3443;
    const Scalar z3455 = n0_032 * z226;
    const Scalar z3444 = s_front_right_hip * z3443 - n0_08 * c_front_right_hip;
    const Scalar z3447 = n0_05 - z3444;
    const Scalar z3374 = n0_072 * z349 - n0_8 * z3323;
    const Scalar z3375 = k10 * z349 - n0_072 * z3323;
    const Scalar z3397 = s_front_left_hip * z3396;
    const Scalar z3405 = n0_08 * s_front_left_hip - c_front_left_hip * z3403;
    const Scalar z3450 = z28 * z3445 - z29 * z3446 + z25 * z3447;
    const Scalar z3416 = s_front_left_hip * z3415;
    const Scalar z3437 = s_front_right_hip * z3436;
    const Scalar z3451 = q_trunk_z - z3450;
    const Scalar z3456 = s_front_right_hip * z3455;
    const Scalar z3404 = n0_08 * c_front_left_hip + s_front_left_hip * z3403;
    const Scalar z3398 = c_front_left_hip * z3396;
    const Scalar z3417 = c_front_left_hip * z3415;
    const Scalar z3438 = c_front_right_hip * z3436;
    const Scalar z3457 = c_front_right_hip * z3455;
    const Scalar z3407 = n0_05 + z3404;
    const Scalar z3377 = n0_032 * z377 - n0_26 * z3331;
    const Scalar z3410 = z29 * z3406 + z28 * z3405 + z25 * z3407;
    const Scalar z3467 = n0_08 * s_rear_left_hip;
    const Scalar z3426 = n0_08 * c_front_right_hip;
    const Scalar z3380 = k13 * z377 - n0_032 * z3331;
    const Scalar z3466 = n0_08 * c_rear_left_hip;
    const Scalar z3421 = n0_02 * c_front_right_hip;
    const Scalar z3411 = q_trunk_z + z3410;
    const Scalar z3428 = n0_05 + z3426;
    const Scalar z3461 = n0_02 * c_rear_left_hip;
    const Scalar z3431 = z28 * z3427 - n0_2 * z29 + z25 * z3428;
    const Scalar z3382 = n0_02 * s_front_left_hip;
    const Scalar z3385 = z25 * z3381 + z28 * z3382;
    const Scalar z3395 = n0_072 * s_front_left_thigh;
    const Scalar z3414 = n0_032 * z154;
    const Scalar z3401 = z25 * z3397 - z28 * z3398 - z29 * z3395;
    const Scalar z3422 = n0_02 * s_front_right_hip;
    const Scalar z3435 = n0_072 * s_front_right_thigh;
    const Scalar z3454 = n0_032 * z225;
    const Scalar z3420 = z25 * z3416 - z28 * z3417 - z29 * z3414;
    const Scalar z3462 = n0_02 * s_rear_left_hip;
    const Scalar z3378 = n0_032 * z375 - n0_26 * z3330;
    const Scalar z3468 = n0_05 + z3466;
    const Scalar z3379 = k13 * z375 - n0_032 * z3330;
    const Scalar z3483 = n0_2 * c_rear_left_thigh;
    const Scalar z3476 = n0_072 * c_rear_left_thigh;
    const Scalar z3482 = n0_2 * s_rear_left_thigh;
    const Scalar z3485 = n0_08 * s_rear_left_hip - c_rear_left_hip * z3483;
    const Scalar z3441 = z25 * z3437 - z28 * z3438 - z29 * z3435;
    const Scalar z3495 = n0_032 * z293;
    const Scalar z3516 = n0_072 * c_rear_right_thigh;
    const Scalar z3477 = s_rear_left_hip * z3476;
    const Scalar z3460 = z25 * z3456 - z28 * z3457 - z29 * z3454;
    const Scalar z3486 = n0_2 + z3482;
    const Scalar z3496 = s_rear_left_hip * z3495;
    const Scalar z3507 = n0_08 * s_rear_right_hip;
    const Scalar z3484 = n0_08 * c_rear_left_hip + s_rear_left_hip * z3483;
    const Scalar z3506 = n0_08 * c_rear_right_hip;
    const Scalar z3425 = z25 * z3421 + z28 * z3422;
    const Scalar z3522 = n0_2 * s_rear_right_thigh;
    const Scalar z3523 = n0_2 * c_rear_right_thigh;
    const Scalar z3465 = z25 * z3461 + z28 * z3462;
    const Scalar z3517 = s_rear_right_hip * z3516;
    const Scalar z3478 = c_rear_left_hip * z3476;
    const Scalar z3497 = c_rear_left_hip * z3495;
    const Scalar z3518 = c_rear_right_hip * z3516;
    const Scalar z3487 = n0_05 + z3484;
    const Scalar z3501 = n0_02 * c_rear_right_hip;
    const Scalar z3490 = z28 * z3485 - z29 * z3486 + z25 * z3487;
    const Scalar z3508 = n0_05 + z3506;
    const Scalar z3475 = n0_072 * s_rear_left_thigh;
    const Scalar z3494 = n0_032 * z292;
    const Scalar z3481 = z25 * z3477 - z28 * z3478 - z29 * z3475;
    const Scalar z3502 = n0_02 * s_rear_right_hip;
    const Scalar z3515 = n0_072 * s_rear_right_thigh;
    const Scalar z3471 = z28 * z3467 - n0_2 * z29 + z25 * z3468;
    const Scalar z3511 = n0_2 * z29 + z28 * z3507 + z25 * z3508;
    const Scalar z3432 = q_trunk_z - z3431;
    const Scalar z3526 = n0_2 + z3522;
    const Scalar z3535 = n0_032 * z360;
    const Scalar z3525 = n0_08 * s_rear_right_hip + c_rear_right_hip * z3523;
    const Scalar z3536 = s_rear_right_hip * z3535;
    const Scalar z3524 = s_rear_right_hip * z3523 - n0_08 * c_rear_right_hip;
    const Scalar z3537 = c_rear_right_hip * z3535;
    const Scalar z3527 = n0_05 - z3524;
    const Scalar z3534 = n0_032 * z359;
    const Scalar z3500 = z25 * z3496 - z28 * z3497 - z29 * z3494;
    const Scalar z3530 = z29 * z3526 + z28 * z3525 + z25 * z3527;
    const Scalar z3472 = q_trunk_z + z3471;
    const Scalar z3491 = q_trunk_z + z3490;
    const Scalar z3505 = z25 * z3501 + z28 * z3502;
    const Scalar z3512 = q_trunk_z - z3511;
    const Scalar z3521 = z25 * z3517 - z28 * z3518 - z29 * z3515;
    const Scalar z3531 = q_trunk_z - z3530;
    const Scalar z3540 = z25 * z3536 - z28 * z3537 - z29 * z3534;
    result.kinetic = n0_0125 * v_trunk_attitude_omega_x * v_trunk_attitude_omega_x + n0_0425 * v_trunk_attitude_omega_y
        * v_trunk_attitude_omega_y + n0_05 * v_trunk_attitude_omega_z * v_trunk_attitude_omega_z + n3 * (z3282 * z3282
        + z3283 * z3283 + z3284 * z3284) + n0_25 * (z3288 * z3288 + z3300 * z3300 + z3312 * z3312 + z3323 * z3323) + k18
        * (z171 * z171 + z242 * z242 + z309 * z309 + z376 * z376) + n0_4 * (z3293 * z3293 + z3305 * z3305 + z3317
        * z3317 + z3328 * z3328) + n0_0002 * (z121 * z121 + z192 * z192 + z259 * z259 + z326 * z326 + z145 * z145 + z216
        * z216 + z283 * z283 + z350 * z350) + n0_13 * (z3309 * z3309 + z3332 * z3332 + z3297 * z3297 + z3321 * z3321)
        + n0_5 * (z123 * z3335 + z194 * z3347 + z261 * z3359 + z328 * z3371 - z3289 * z3334 + z3301 * z3346 + z3313
        * z3358 - z3324 * z3370 + z122 * z3336 + z193 * z3348 + z260 * z3360 + z327 * z3372 + z144 * z3339 + z282
        * z3363 + z3288 * z3338 + z3312 * z3362 - z3285 * (z3333 + z3357) - z3298 * (z3345 + z3369) + z215 * z3351
        + z349 * z3375 - z3300 * z3350 - z3323 * z3374 + z146 * z3340 + z217 * z3352 + z284 * z3364 + z351 * z3376
        + z3292 * z3337 - z3304 * z3349 + z3316 * z3361 - z3327 * z3373 + z170 * z3343 + z241 * z3355 + z308 * z3367
        + z375 * z3379 - z3295 * z3342 - z3307 * z3354 - z3319 * z3366 - z3330 * z3378 + z172 * z3344 + z243 * z3356
        + z310 * z3368 + z377 * z3380 + z3296 * z3341 - z3308 * z3353 + z3320 * z3365 - z3331 * z3377);
    result.force_function = -n58_86 * q_trunk_z - n4_905 * (z117 + z190 + z258 + z325) - n7_848 * (z3392 + z3512 + z3432
        + z3472) - n2_5506 * (z3411 + z3531 + z3451 + z3491) - n9_81 * (z3385 - z3425 + z3465 - z3505 + z3401 + z3441
        + z3481 + z3521 + z3420 + z3460 + z3500 + z3540);
    result.power = v_front_left_hip * (u_front_left_hip_torque - z1139) + v_front_left_thigh
        * (u_front_left_thigh_torque - z1141) + v_front_left_knee * (u_front_left_knee_torque - z1143)
        + v_front_right_hip * (u_front_right_hip_torque - z1145) + v_front_right_thigh * (u_front_right_thigh_torque
        - z1147) + v_front_right_knee * (u_front_right_knee_torque - z1149) + v_rear_left_hip * (u_rear_left_hip_torque
        - z1151) + v_rear_left_thigh * (u_rear_left_thigh_torque - z1153) + v_rear_left_knee * (u_rear_left_knee_torque
        - z1155) + v_rear_right_hip * (u_rear_right_hip_torque - z1157) + v_rear_right_thigh
        * (u_rear_right_thigh_torque - z1159) + v_rear_right_knee * (u_rear_right_knee_torque - z1161);
  }
};

}  // namespace quadruped
