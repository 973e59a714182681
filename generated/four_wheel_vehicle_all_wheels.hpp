// SPDX-License-Identifier: MIT
// four_wheel_vehicle_all_wheels: Four-wheel vehicle: the eight conditions of its four wheels
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               12               28          0             0                  4       0     48       -
//   kinematics               64               73          0             0                  9       0    155     155
//   mass_matrix              44               44          0             0                  1       0     90     118
//   bias                     43               60          0             0                  1       0    105     191
//   inverse_dynamics        116              111          0             0                  5       0    237     374
//   forward_dynamics        599              729         11             0                  5       0   1349    1479
//   energy                   48               74          0             0                  5       0    132     162
//   constraints              44               56          0             0                  4       0    108     132
//
// Not computed because this mechanism does not need it:
//   kinematics: of 246 results 131 vanish identically, 30 repeat another up to sign
//   mass_matrix: of 121 results 82 vanish identically, 14 repeat another up to sign
//   bias: of 11 results 4 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 112 results 64 vanish identically, 8 repeat another up to sign
//
// To write this file again:
//   four_wheel_vehicle_all_wheels_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output four_wheel_vehicle_all_wheels.hpp
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

namespace four_wheel_vehicle_all_wheels {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle_all_wheels";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xc88e6c5e3b39d049ULL;
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 11;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 8;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha_1;  ///< parameter [rad or 1]
    Scalar alpha_2;  ///< parameter [rad or 1]
    Scalar alpha_3;  ///< parameter [rad or 1]
    Scalar alpha_4;  ///< parameter [rad or 1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::alpha_1, &Parameters::alpha_2, &Parameters::alpha_3,
          &Parameters::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar phi_1;  ///< coordinate [rad or 1]
    Scalar phi_2;  ///< coordinate [rad or 1]
    Scalar phi_3;  ///< coordinate [rad or 1]
    Scalar phi_4;  ///< coordinate [rad or 1]
    Scalar s_1;  ///< coordinate [m]
    Scalar s_2;  ///< coordinate [m]
    Scalar s_3;  ///< coordinate [m]
    Scalar s_4;  ///< coordinate [m]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4, &Coordinates::s_1,
          &Coordinates::s_2, &Coordinates::s_3, &Coordinates::s_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar phi_1;  ///< its rate [rad/s]
    Scalar phi_2;  ///< its rate [rad/s]
    Scalar phi_3;  ///< its rate [rad/s]
    Scalar phi_4;  ///< its rate [rad/s]
    Scalar s_1;  ///< its rate [m/s]
    Scalar s_2;  ///< its rate [m/s]
    Scalar s_3;  ///< its rate [m/s]
    Scalar s_4;  ///< its rate [m/s]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4, &Velocities::s_1, &Velocities::s_2,
          &Velocities::s_3, &Velocities::s_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar phi_1;  ///< its second rate [rad/s^2]
    Scalar phi_2;  ///< its second rate [rad/s^2]
    Scalar phi_3;  ///< its second rate [rad/s^2]
    Scalar phi_4;  ///< its second rate [rad/s^2]
    Scalar s_1;  ///< its second rate [m/s^2]
    Scalar s_2;  ///< its second rate [m/s^2]
    Scalar s_3;  ///< its second rate [m/s^2]
    Scalar s_4;  ///< its second rate [m/s^2]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4,
          &Accelerations::s_1, &Accelerations::s_2, &Accelerations::s_3, &Accelerations::s_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar phi_1;  ///< works with the rate of phi_1 [N m]
    Scalar phi_2;  ///< works with the rate of phi_2 [N m]
    Scalar phi_3;  ///< works with the rate of phi_3 [N m]
    Scalar phi_4;  ///< works with the rate of phi_4 [N m]
    Scalar s_1;  ///< works with the rate of s_1 [N]
    Scalar s_2;  ///< works with the rate of s_2 [N]
    Scalar s_3;  ///< works with the rate of s_3 [N]
    Scalar s_4;  ///< works with the rate of s_4 [N]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4, &GeneralizedForces::s_1, &GeneralizedForces::s_2, &GeneralizedForces::s_3,
          &GeneralizedForces::s_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< of the constraint wheel_4_x [N]
    Scalar lambda_wheel_4_y;  ///< of the constraint wheel_4_y [N]
    static constexpr int size = 8;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_wheel_1_x, &Multipliers::lambda_wheel_1_y,
          &Multipliers::lambda_wheel_2_x, &Multipliers::lambda_wheel_2_y, &Multipliers::lambda_wheel_3_x,
          &Multipliers::lambda_wheel_3_y, &Multipliers::lambda_wheel_4_x, &Multipliers::lambda_wheel_4_y};
      return members_[i_];
    }
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
    Scalar s_alpha_1;
    Scalar c_alpha_1;
    Scalar s_alpha_2;
    Scalar c_alpha_2;
    Scalar s_alpha_3;
    Scalar c_alpha_3;
    Scalar s_alpha_4;
    Scalar c_alpha_4;
    Scalar z174;
    Scalar z175;
    Scalar z176;
    Scalar z206;
    Scalar z207;
    Scalar z208;
    Scalar z243;
    Scalar z244;
    Scalar z245;
    Scalar z280;
    Scalar z281;
    Scalar z282;
    Scalar z565;
    Scalar z566;
    Scalar z574;
    Scalar z575;
    Scalar z583;
    Scalar z584;
    Scalar z592;
    Scalar z593;
    Scalar z691;
    Scalar z700;
    Scalar z709;
    Scalar z718;
    Scalar z1014;
    Scalar z1015;
    Scalar z1016;
    Scalar z1017;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar pi = traits::pi();
    parameters.alpha_1 = -n0_25 * pi;
    parameters.alpha_2 = -n1_over_6 * pi;
    parameters.alpha_3 = n0;
    parameters.alpha_4 = n0;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar p_alpha_1 = parameters.alpha_1;
    const Scalar p_alpha_2 = parameters.alpha_2;
    const Scalar p_alpha_3 = parameters.alpha_3;
    const Scalar p_alpha_4 = parameters.alpha_4;
    const Scalar angles_[] = {p_alpha_1, p_alpha_2, p_alpha_3, p_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha_1 = sines_[0], c_alpha_1 = cosines_[0];
    const Scalar s_alpha_2 = sines_[1], c_alpha_2 = cosines_[1];
    const Scalar s_alpha_3 = sines_[2], c_alpha_3 = cosines_[2];
    const Scalar s_alpha_4 = sines_[3], c_alpha_4 = cosines_[3];
    const Scalar z174 = n20 * c_alpha_4;
    const Scalar z175 = n20 * s_alpha_4;
    const Scalar z176 = z174 + k1 * z175;
    const Scalar z206 = n20 * c_alpha_3;
    const Scalar z207 = n20 * s_alpha_3;
    const Scalar z208 = z206 - k1 * z207;
    const Scalar z243 = n20 * c_alpha_2;
    const Scalar z244 = n20 * s_alpha_2;
    const Scalar z245 = z243 + k1 * z244;
    const Scalar z280 = n20 * c_alpha_1;
    const Scalar z281 = n20 * s_alpha_1;
    const Scalar z282 = z280 - k1 * z281;
    const Scalar z565 = s_alpha_1 + k1 * c_alpha_1;
    const Scalar z566 = k1 * s_alpha_1 - c_alpha_1;
    const Scalar z574 = s_alpha_2 - k1 * c_alpha_2;
    const Scalar z575 = k1 * s_alpha_2 + c_alpha_2;
    const Scalar z583 = s_alpha_3 + k1 * c_alpha_3;
    const Scalar z584 = k1 * s_alpha_3 - c_alpha_3;
    const Scalar z592 = s_alpha_4 - k1 * c_alpha_4;
    const Scalar z593 = k1 * s_alpha_4 + c_alpha_4;
    const Scalar z691 = n0_05 * z176;
    const Scalar z700 = n0_05 * z208;
    const Scalar z709 = n0_05 * z245;
    const Scalar z718 = n0_05 * z282;
    const Scalar z1014 = z176 * z691;
    const Scalar z1015 = z208 * z700;
    const Scalar z1016 = z245 * z709;
    const Scalar z1017 = z282 * z718;
    precomputed.s_alpha_1 = s_alpha_1;
    precomputed.c_alpha_1 = c_alpha_1;
    precomputed.s_alpha_2 = s_alpha_2;
    precomputed.c_alpha_2 = c_alpha_2;
    precomputed.s_alpha_3 = s_alpha_3;
    precomputed.c_alpha_3 = c_alpha_3;
    precomputed.s_alpha_4 = s_alpha_4;
    precomputed.c_alpha_4 = c_alpha_4;
    precomputed.z174 = z174;
    precomputed.z175 = z175;
    precomputed.z176 = z176;
    precomputed.z206 = z206;
    precomputed.z207 = z207;
    precomputed.z208 = z208;
    precomputed.z243 = z243;
    precomputed.z244 = z244;
    precomputed.z245 = z245;
    precomputed.z280 = z280;
    precomputed.z281 = z281;
    precomputed.z282 = z282;
    precomputed.z565 = z565;
    precomputed.z566 = z566;
    precomputed.z574 = z574;
    precomputed.z575 = z575;
    precomputed.z583 = z583;
    precomputed.z584 = z584;
    precomputed.z592 = z592;
    precomputed.z593 = z593;
    precomputed.z691 = z691;
    precomputed.z700 = z700;
    precomputed.z709 = z709;
    precomputed.z718 = z718;
    precomputed.z1014 = z1014;
    precomputed.z1015 = z1015;
    precomputed.z1016 = z1016;
    precomputed.z1017 = z1017;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(2.732050807568877, 2.732051f, "1;0;1;0");
    const Scalar k3 = traits::constant(9.428090415820634, 9.42809f, "0;20/3;0;0");
    const Scalar n40_over_3 = traits::constant(13.333333333333334, 13.333333f, "40/3");
    const Scalar k5 = traits::constant(11.547005383792515, 11.547006f, "0;0;20/3;0");
    const Scalar n20_over_3 = traits::constant(6.666666666666667, 6.6666665f, "20/3");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.psi = n0;
    state.q.phi_1 = n0;
    state.q.phi_2 = n0;
    state.q.phi_3 = n0;
    state.q.phi_4 = n0;
    state.q.s_1 = n0;
    state.q.s_2 = n0;
    state.q.s_3 = n0;
    state.q.s_4 = n0;
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
    state.v.s_1 = n0;
    state.v.s_2 = n0;
    state.v.s_3 = n0;
    state.v.s_4 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> chassis_position;  ///< centre of mass of chassis [m]
    std::array<Scalar, 9> chassis_rotation;  ///< from the axes of chassis to the ground's (3 x 3)
    std::array<Scalar, 3> chassis_velocity;  ///< velocity of the centre of mass of chassis [m/s]
    std::array<Scalar, 3> chassis_angular_velocity;  ///< angular velocity of chassis [rad/s]
    std::array<Scalar, 3> wheel_1_position;  ///< centre of mass of wheel_1 [m]
    std::array<Scalar, 9> wheel_1_rotation;  ///< from the axes of wheel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_1_velocity;  ///< velocity of the centre of mass of wheel_1 [m/s]
    std::array<Scalar, 3> wheel_1_angular_velocity;  ///< angular velocity of wheel_1 [rad/s]
    std::array<Scalar, 3> wheel_2_position;  ///< centre of mass of wheel_2 [m]
    std::array<Scalar, 9> wheel_2_rotation;  ///< from the axes of wheel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_2_velocity;  ///< velocity of the centre of mass of wheel_2 [m/s]
    std::array<Scalar, 3> wheel_2_angular_velocity;  ///< angular velocity of wheel_2 [rad/s]
    std::array<Scalar, 3> wheel_3_position;  ///< centre of mass of wheel_3 [m]
    std::array<Scalar, 9> wheel_3_rotation;  ///< from the axes of wheel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_3_velocity;  ///< velocity of the centre of mass of wheel_3 [m/s]
    std::array<Scalar, 3> wheel_3_angular_velocity;  ///< angular velocity of wheel_3 [rad/s]
    std::array<Scalar, 3> wheel_4_position;  ///< centre of mass of wheel_4 [m]
    std::array<Scalar, 9> wheel_4_rotation;  ///< from the axes of wheel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_4_velocity;  ///< velocity of the centre of mass of wheel_4 [m/s]
    std::array<Scalar, 3> wheel_4_angular_velocity;  ///< angular velocity of wheel_4 [rad/s]
    std::array<Scalar, 3> P1_position;  ///< position of P1 [m]
    std::array<Scalar, 3> P1_velocity;  ///< velocity of the material point at P1 [m/s]
    std::array<Scalar, 33> P1_jacobian;  ///< partial velocities of P1 (3 x 11)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 33> P2_jacobian;  ///< partial velocities of P2 (3 x 11)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 33> P3_jacobian;  ///< partial velocities of P3 (3 x 11)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 33> P4_jacobian;  ///< partial velocities of P4 (3 x 11)
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

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 8> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 8> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 88> jacobian;  ///< A, stored column by column (8 x 11)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z55 = q_psi + p_alpha_1;
    const Scalar z80 = q_psi + p_alpha_2;
    const Scalar z104 = q_psi + p_alpha_3;
    const Scalar z126 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4, z55, z80, z104, z126};
    Scalar sines_[9], cosines_[9];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z56 = sines_[5], z57 = cosines_[5];
    const Scalar z81 = sines_[6], z82 = cosines_[6];
    const Scalar z105 = sines_[7], z106 = cosines_[7];
    const Scalar z127 = sines_[8], z128 = cosines_[8];
    const Scalar z62 = k0 * v_psi;
    const Scalar z58 = s_psi - k0 * c_psi;
    const Scalar z59 = k0 * s_psi + c_psi;
    const Scalar z83 = s_psi + k0 * c_psi;
    const Scalar z63 = v_x - v_psi * c_psi - s_psi * z62;  // velocity of steered_1, x
    const Scalar z64 = v_y - v_psi * s_psi + c_psi * z62;  // velocity of steered_1, y
    const Scalar z87 = v_x - v_psi * c_psi + s_psi * z62;  // velocity of steered_2, x
    const Scalar z88 = v_y - v_psi * s_psi - c_psi * z62;  // velocity of steered_2, y
    const Scalar z109 = v_x + v_psi * c_psi + s_psi * z62;  // velocity of steered_3, x
    const Scalar z110 = v_y + v_psi * s_psi - c_psi * z62;  // velocity of steered_3, y
    const Scalar z131 = v_x + v_psi * c_psi - s_psi * z62;  // velocity of steered_4, x
    const Scalar z132 = v_y + v_psi * s_psi + c_psi * z62;  // velocity of steered_4, y
    const Scalar z84 = k0 * s_psi - c_psi;
    const Scalar z69 = v_psi * q_s_1;
    const Scalar z93 = v_psi * q_s_2;
    const Scalar z115 = v_psi * q_s_3;
    const Scalar z65 = q_s_1 * z57;
    const Scalar z66 = q_s_1 * z56;
    const Scalar z89 = q_s_2 * z82;
    const Scalar z90 = q_s_2 * z81;
    const Scalar z111 = q_s_3 * z106;
    const Scalar z72 = c_phi_1 * z56;
    const Scalar z73 = s_phi_1 * z56;
    const Scalar z74 = c_phi_1 * z57;
    const Scalar z75 = s_phi_1 * z57;
    const Scalar z78 = v_phi_1 * z57;  // angular velocity of wheel_1, x
    const Scalar z79 = v_phi_1 * z56;  // angular velocity of wheel_1, y
    const Scalar z96 = c_phi_2 * z81;
    const Scalar z97 = s_phi_2 * z81;
    const Scalar z98 = c_phi_2 * z82;
    const Scalar z99 = s_phi_2 * z82;
    const Scalar z102 = v_phi_2 * z82;  // angular velocity of wheel_2, x
    const Scalar z103 = v_phi_2 * z81;  // angular velocity of wheel_2, y
    const Scalar z118 = c_phi_3 * z105;
    const Scalar z119 = s_phi_3 * z105;
    const Scalar z120 = c_phi_3 * z106;
    const Scalar z121 = s_phi_3 * z106;
    const Scalar z124 = v_phi_3 * z106;  // angular velocity of wheel_3, x
    const Scalar z125 = v_phi_3 * z105;  // angular velocity of wheel_3, y
    const Scalar z112 = q_s_3 * z105;
    const Scalar z133 = q_s_4 * z128;
    const Scalar z134 = q_s_4 * z127;
    const Scalar z60 = q_x - z58;  // place of steered_1, x
    const Scalar z61 = q_y + z59;  // place of steered_1, y
    const Scalar z140 = c_phi_4 * z127;
    const Scalar z141 = s_phi_4 * z127;
    const Scalar z137 = v_psi * q_s_4;
    const Scalar z85 = q_x - z83;  // place of steered_2, x
    const Scalar z86 = q_y - z84;  // place of steered_2, y
    const Scalar z107 = q_x + z58;  // place of steered_3, x
    const Scalar z108 = q_y - z59;  // place of steered_3, y
    const Scalar z129 = q_x + z83;  // place of steered_4, x
    const Scalar z130 = q_y + z84;  // place of steered_4, y
    const Scalar z67 = z60 + z65;  // place of axle_1, x
    const Scalar z142 = c_phi_4 * z128;
    const Scalar z68 = z61 + z66;  // place of axle_1, y
    const Scalar z143 = s_phi_4 * z128;
    const Scalar z146 = v_phi_4 * z128;  // angular velocity of wheel_4, x
    const Scalar z91 = z85 + z89;  // place of axle_2, x
    const Scalar z92 = z86 + z90;  // place of axle_2, y
    const Scalar z113 = z107 + z111;  // place of axle_3, x
    const Scalar z114 = z108 + z112;  // place of axle_3, y
    const Scalar z135 = z129 + z133;  // place of axle_4, x
    const Scalar z136 = z130 + z134;  // place of axle_4, y
    const Scalar z70 = z63 + v_s_1 * z57 - z56 * z69;  // velocity of axle_1, x
    const Scalar z147 = v_phi_4 * z127;  // angular velocity of wheel_4, y
    const Scalar z71 = z64 + v_s_1 * z56 + z57 * z69;  // velocity of axle_1, y
    const Scalar z148 = z58 - z65;
    const Scalar z156 = z58 + z111;
    const Scalar z149 = z59 + z66;
    const Scalar z152 = z83 - z89;
    const Scalar z153 = z84 - z90;
    const Scalar z94 = z87 + v_s_2 * z82 - z81 * z93;  // velocity of axle_2, x
    const Scalar z95 = z88 + v_s_2 * z81 + z82 * z93;  // velocity of axle_2, y
    const Scalar z116 = z109 + v_s_3 * z106 - z105 * z115;  // velocity of axle_3, x
    const Scalar z117 = z110 + v_s_3 * z105 + z106 * z115;  // velocity of axle_3, y
    const Scalar z138 = z131 + v_s_4 * z128 - z127 * z137;  // velocity of axle_4, x
    const Scalar z139 = z132 + v_s_4 * z127 + z128 * z137;  // velocity of axle_4, y
    const Scalar z157 = z59 - z112;
    const Scalar z160 = z83 + z133;
    const Scalar z161 = z84 + z134;
    result.chassis_position[0] = q_x;
    result.chassis_position[1] = q_y;
    result.chassis_position[2] = n0_3;
    result.chassis_rotation[0] = c_psi;
    result.chassis_rotation[1] = s_psi;
    result.chassis_rotation[2] = n0;
    result.chassis_rotation[3] = -s_psi;
    result.chassis_rotation[4] = c_psi;
    result.chassis_rotation[5] = n0;
    result.chassis_rotation[6] = n0;
    result.chassis_rotation[7] = n0;
    result.chassis_rotation[8] = n1;
    result.chassis_velocity[0] = v_x;
    result.chassis_velocity[1] = v_y;
    result.chassis_velocity[2] = n0;
    result.chassis_angular_velocity[0] = n0;
    result.chassis_angular_velocity[1] = n0;
    result.chassis_angular_velocity[2] = v_psi;
    result.wheel_1_position[0] = z67;
    result.wheel_1_position[1] = z68;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z57;
    result.wheel_1_rotation[1] = z56;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z72;
    result.wheel_1_rotation[4] = z74;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z73;
    result.wheel_1_rotation[7] = -z75;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z70;
    result.wheel_1_velocity[1] = z71;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z78;
    result.wheel_1_angular_velocity[1] = z79;
    result.wheel_1_angular_velocity[2] = v_psi;
    result.wheel_2_position[0] = z91;
    result.wheel_2_position[1] = z92;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z82;
    result.wheel_2_rotation[1] = z81;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z96;
    result.wheel_2_rotation[4] = z98;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z97;
    result.wheel_2_rotation[7] = -z99;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = z94;
    result.wheel_2_velocity[1] = z95;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z102;
    result.wheel_2_angular_velocity[1] = z103;
    result.wheel_2_angular_velocity[2] = v_psi;
    result.wheel_3_position[0] = z113;
    result.wheel_3_position[1] = z114;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = z106;
    result.wheel_3_rotation[1] = z105;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z118;
    result.wheel_3_rotation[4] = z120;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z119;
    result.wheel_3_rotation[7] = -z121;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = z116;
    result.wheel_3_velocity[1] = z117;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z124;
    result.wheel_3_angular_velocity[1] = z125;
    result.wheel_3_angular_velocity[2] = v_psi;
    result.wheel_4_position[0] = z135;
    result.wheel_4_position[1] = z136;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = z128;
    result.wheel_4_rotation[1] = z127;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z140;
    result.wheel_4_rotation[4] = z142;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z141;
    result.wheel_4_rotation[7] = -z143;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z138;
    result.wheel_4_velocity[1] = z139;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z146;
    result.wheel_4_angular_velocity[1] = z147;
    result.wheel_4_angular_velocity[2] = v_psi;
    result.P1_position[0] = z67;
    result.P1_position[1] = z68;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z70;
    result.P1_velocity[1] = z71;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = -z149;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[21] = z57;
    result.P1_jacobian[24] = n0;
    result.P1_jacobian[27] = n0;
    result.P1_jacobian[30] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z148;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[22] = z56;
    result.P1_jacobian[25] = n0;
    result.P1_jacobian[28] = n0;
    result.P1_jacobian[31] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P1_jacobian[23] = n0;
    result.P1_jacobian[26] = n0;
    result.P1_jacobian[29] = n0;
    result.P1_jacobian[32] = n0;
    result.P2_position[0] = z91;
    result.P2_position[1] = z92;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = z94;
    result.P2_velocity[1] = z95;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z153;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[21] = n0;
    result.P2_jacobian[24] = z82;
    result.P2_jacobian[27] = n0;
    result.P2_jacobian[30] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z152;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[22] = n0;
    result.P2_jacobian[25] = z81;
    result.P2_jacobian[28] = n0;
    result.P2_jacobian[31] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P2_jacobian[23] = n0;
    result.P2_jacobian[26] = n0;
    result.P2_jacobian[29] = n0;
    result.P2_jacobian[32] = n0;
    result.P3_position[0] = z113;
    result.P3_position[1] = z114;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = z116;
    result.P3_velocity[1] = z117;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z157;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[21] = n0;
    result.P3_jacobian[24] = n0;
    result.P3_jacobian[27] = z106;
    result.P3_jacobian[30] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = z156;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[22] = n0;
    result.P3_jacobian[25] = n0;
    result.P3_jacobian[28] = z105;
    result.P3_jacobian[31] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P3_jacobian[23] = n0;
    result.P3_jacobian[26] = n0;
    result.P3_jacobian[29] = n0;
    result.P3_jacobian[32] = n0;
    result.P4_position[0] = z135;
    result.P4_position[1] = z136;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z138;
    result.P4_velocity[1] = z139;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = -z161;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[21] = n0;
    result.P4_jacobian[24] = n0;
    result.P4_jacobian[27] = n0;
    result.P4_jacobian[30] = z128;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = z160;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[22] = n0;
    result.P4_jacobian[25] = n0;
    result.P4_jacobian[28] = n0;
    result.P4_jacobian[31] = z127;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
    result.P4_jacobian[23] = n0;
    result.P4_jacobian[26] = n0;
    result.P4_jacobian[29] = n0;
    result.P4_jacobian[32] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 121>& mass) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k5 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar q_psi = state.q.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z174 = precomputed.z174;
    const Scalar z175 = precomputed.z175;
    const Scalar z176 = precomputed.z176;
    const Scalar z206 = precomputed.z206;
    const Scalar z207 = precomputed.z207;
    const Scalar z208 = precomputed.z208;
    const Scalar z243 = precomputed.z243;
    const Scalar z244 = precomputed.z244;
    const Scalar z245 = precomputed.z245;
    const Scalar z280 = precomputed.z280;
    const Scalar z281 = precomputed.z281;
    const Scalar z282 = precomputed.z282;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z329 = n20 * q_s_4;
    const Scalar z340 = n20 * q_s_3;
    const Scalar z353 = n20 * q_s_2;
    const Scalar z366 = n20 * q_s_1;
    const Scalar z327 = s_psi * z175 - c_psi * z174;
    const Scalar z332 = s_alpha_4 * z329;
    const Scalar z343 = s_alpha_3 * z340;
    const Scalar z333 = c_alpha_4 * z329;
    const Scalar z344 = c_alpha_3 * z340;
    const Scalar z330 = q_s_4 * z329;
    const Scalar z356 = s_alpha_2 * z353;
    const Scalar z335 = k1 + z333;
    const Scalar z336 = n20 - z332;
    const Scalar z346 = k1 - z344;
    const Scalar z347 = n20 - z343;
    const Scalar z357 = c_alpha_2 * z353;
    const Scalar z331 = n0_5 + z330;
    const Scalar z341 = q_s_3 * z340;
    const Scalar z369 = s_alpha_1 * z366;
    const Scalar z348 = z335 - z346;
    const Scalar z349 = z336 + z347;
    const Scalar z359 = k1 - z357;
    const Scalar z360 = n20 + z356;
    const Scalar z370 = c_alpha_1 * z366;
    const Scalar z334 = k3 - n2 * z332 + k5 * z333 + z331;
    const Scalar z342 = n0_5 + z341;
    const Scalar z354 = q_s_2 * z353;
    const Scalar z361 = z348 - z359;
    const Scalar z362 = z349 - z360;
    const Scalar z372 = k1 + z370;
    const Scalar z373 = n20 + z369;
    const Scalar z337 = n900 + z334;
    const Scalar z345 = k3 - n2 * z343 - k5 * z344 + z342;
    const Scalar z355 = n0_5 + z354;
    const Scalar z367 = q_s_1 * z366;
    const Scalar z374 = z361 + z372;
    const Scalar z375 = z362 - z373;
    const Scalar z350 = z337 + z345;
    const Scalar z358 = k3 + n2 * z356 - k5 * z357 + z355;
    const Scalar z368 = n0_5 + z367;
    const Scalar z363 = z350 + z358;
    const Scalar z371 = k3 + n2 * z369 + k5 * z370 + z368;
    const Scalar z328 = s_psi * z174 + c_psi * z175;
    const Scalar z338 = s_psi * z207 - c_psi * z206;
    const Scalar z339 = s_psi * z206 + c_psi * z207;
    const Scalar z351 = s_psi * z244 - c_psi * z243;
    const Scalar z352 = s_psi * z243 + c_psi * z244;
    const Scalar z364 = s_psi * z281 - c_psi * z280;
    const Scalar z365 = s_psi * z280 + c_psi * z281;
    const Scalar z376 = z363 + z371;
    const Scalar z377 = s_psi * z374 - c_psi * z375;
    const Scalar z378 = s_psi * z375 + c_psi * z374;
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = -z377;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = -z364;
    mass[8] = -z351;
    mass[9] = -z338;
    mass[10] = -z327;
    mass[11] = n0;
    mass[12] = n880;
    mass[13] = z378;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z365;
    mass[19] = z352;
    mass[20] = z339;
    mass[21] = z328;
    mass[22] = -z377;
    mass[23] = z378;
    mass[24] = z376;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = -z282;
    mass[30] = -z245;
    mass[31] = z208;
    mass[32] = z176;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0_9;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
    mass[49] = n0;
    mass[50] = n0;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = n0;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = n0_9;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = n0;
    mass[71] = n0;
    mass[72] = n0_9;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = -z364;
    mass[78] = z365;
    mass[79] = -z282;
    mass[80] = n0;
    mass[81] = n0;
    mass[82] = n0;
    mass[83] = n0;
    mass[84] = n20;
    mass[85] = n0;
    mass[86] = n0;
    mass[87] = n0;
    mass[88] = -z351;
    mass[89] = z352;
    mass[90] = -z245;
    mass[91] = n0;
    mass[92] = n0;
    mass[93] = n0;
    mass[94] = n0;
    mass[95] = n0;
    mass[96] = n20;
    mass[97] = n0;
    mass[98] = n0;
    mass[99] = -z338;
    mass[100] = z339;
    mass[101] = z208;
    mass[102] = n0;
    mass[103] = n0;
    mass[104] = n0;
    mass[105] = n0;
    mass[106] = n0;
    mass[107] = n0;
    mass[108] = n20;
    mass[109] = n0;
    mass[110] = -z327;
    mass[111] = z328;
    mass[112] = z176;
    mass[113] = n0;
    mass[114] = n0;
    mass[115] = n0;
    mass[116] = n0;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n20;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z444 = v_psi * v_psi;
    const Scalar z449 = n2 * v_psi;
    const Scalar z445 = k1 * z444;
    const Scalar z446 = s_alpha_1 * z444 + c_alpha_1 * z445;
    const Scalar z447 = s_alpha_1 * z445 - c_alpha_1 * z444;
    const Scalar z451 = s_alpha_2 * z444 - c_alpha_2 * z445;
    const Scalar z452 = c_alpha_2 * z444 + s_alpha_2 * z445;
    const Scalar z460 = c_alpha_4 * z444 + s_alpha_4 * z445;
    const Scalar z456 = s_alpha_3 * z445 - c_alpha_3 * z444;
    const Scalar z454 = v_s_2 * z449 - z452;
    const Scalar z462 = v_s_4 * z449 + z460;
    const Scalar z455 = s_alpha_3 * z444 + c_alpha_3 * z445;
    const Scalar z459 = s_alpha_4 * z444 - c_alpha_4 * z445;
    const Scalar z458 = v_s_3 * z449 - z456;
    const Scalar z464 = n20 * z462;  // force on axle_4, y
    const Scalar z474 = n20 * z454;  // force on axle_2, y
    const Scalar z457 = q_s_3 * z444 - z455;
    const Scalar z461 = q_s_4 * z444 - z459;
    const Scalar z450 = v_s_1 * z449 + z447;
    const Scalar z465 = q_s_4 * z464;  // moment on steered_4, z
    const Scalar z469 = n20 * z458;  // force on axle_3, y
    const Scalar z475 = q_s_2 * z474;  // moment on steered_2, z
    const Scalar z453 = q_s_2 * z444 + z451;
    const Scalar z463 = n20 * z461;  // force on axle_4, x
    const Scalar z468 = n20 * z457;  // force on axle_3, x
    const Scalar z470 = q_s_3 * z469;  // moment on steered_3, z
    const Scalar z479 = n20 * z450;  // force on axle_1, y
    const Scalar z448 = q_s_1 * z444 + z446;
    const Scalar z473 = n20 * z453;  // force on axle_2, x
    const Scalar z480 = q_s_1 * z479;  // moment on steered_1, z
    const Scalar z478 = n20 * z448;  // force on axle_1, x
    const Scalar z466 = s_alpha_4 * z464 + c_alpha_4 * z463;
    const Scalar z467 = s_alpha_4 * z463 - c_alpha_4 * z464;
    const Scalar z471 = c_alpha_3 * z468 + s_alpha_3 * z469;
    const Scalar z472 = s_alpha_3 * z468 - c_alpha_3 * z469;
    const Scalar z476 = s_alpha_2 * z474 + c_alpha_2 * z473;
    const Scalar z477 = s_alpha_2 * z473 - c_alpha_2 * z474;
    const Scalar z481 = c_alpha_1 * z478 + s_alpha_1 * z479;
    const Scalar z482 = s_alpha_1 * z478 - c_alpha_1 * z479;
    const Scalar z483 = z466 + z471 + z476 + z481;  // force on S, x
    const Scalar z484 = z467 + z472 + z477 + z482;  // force on S, y
    // moment on S, z
    const Scalar z485 = z465 + z475 + z470 + z480 - z466 - z471 + z476 + z481 - k1 * (z467 - z472 - z477 + z482);
    const Scalar z486 = s_psi * z484 - c_psi * z483;
    const Scalar z487 = s_psi * z483 + c_psi * z484;
    forces.x = z486;
    forces.y = -z487;
    forces.psi = z485;
    forces.phi_1 = n0;
    forces.phi_2 = n0;
    forces.phi_3 = n0;
    forces.phi_4 = n0;
    forces.s_1 = -z478;
    forces.s_2 = -z473;
    forces.s_3 = -z468;
    forces.s_4 = -z463;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar k3 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar a_s_1 = accelerations.s_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar a_s_2 = accelerations.s_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar a_s_3 = accelerations.s_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar a_s_4 = accelerations.s_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z565 = precomputed.z565;
    const Scalar z566 = precomputed.z566;
    const Scalar z574 = precomputed.z574;
    const Scalar z575 = precomputed.z575;
    const Scalar z583 = precomputed.z583;
    const Scalar z584 = precomputed.z584;
    const Scalar z592 = precomputed.z592;
    const Scalar z593 = precomputed.z593;
    const Scalar z613 = q_psi + p_alpha_1;
    const Scalar z616 = q_psi + p_alpha_2;
    const Scalar z619 = q_psi + p_alpha_3;
    const Scalar z622 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z613, z616, z619, z622};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z614 = sines_[1], z615 = cosines_[1];
    const Scalar z617 = sines_[2], z618 = cosines_[2];
    const Scalar z620 = sines_[3], z621 = cosines_[3];
    const Scalar z623 = sines_[4], z624 = cosines_[4];
    const Scalar z625 = v_psi * v_psi;
    const Scalar z626 = a_x * c_psi + a_y * s_psi;
    const Scalar z627 = a_x * s_psi - a_y * c_psi;
    const Scalar z633 = n2 * v_psi;
    const Scalar z656 = n0_5 * a_psi;
    const Scalar z653 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z660 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z666 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z672 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z685 = q_s_1 + z565;
    const Scalar z686 = q_s_2 + z574;
    const Scalar z687 = q_s_3 - z583;
    const Scalar z628 = a_psi + k3 * z625 - z626;
    const Scalar z688 = q_s_4 - z592;
    const Scalar z629 = k3 * a_psi - z625 - z627;
    const Scalar z635 = a_psi - k3 * z625 - z626;
    const Scalar z636 = k3 * a_psi + z625 + z627;
    const Scalar z641 = a_psi + k3 * z625 + z626;
    const Scalar z642 = k3 * a_psi - z625 + z627;
    const Scalar z647 = a_psi - k3 * z625 + z626;
    const Scalar z648 = k3 * a_psi + z625 - z627;
    const Scalar z630 = s_alpha_1 * z629 - c_alpha_1 * z628;
    const Scalar z631 = s_alpha_1 * z628 + c_alpha_1 * z629;
    const Scalar z637 = s_alpha_2 * z636 + c_alpha_2 * z635;
    const Scalar z638 = s_alpha_2 * z635 - c_alpha_2 * z636;
    const Scalar z643 = s_alpha_3 * z642 - c_alpha_3 * z641;
    const Scalar z644 = s_alpha_3 * z641 + c_alpha_3 * z642;
    const Scalar z649 = s_alpha_4 * z648 + c_alpha_4 * z647;
    const Scalar z650 = s_alpha_4 * z647 - c_alpha_4 * z648;
    const Scalar z632 = q_s_1 * z625 - a_s_1 - z630;
    const Scalar z634 = z631 + a_psi * q_s_1 + v_s_1 * z633;
    const Scalar z639 = q_s_2 * z625 - a_s_2 + z637;
    const Scalar z640 = z638 + a_psi * q_s_2 + v_s_2 * z633;
    const Scalar z645 = q_s_3 * z625 - a_s_3 + z643;
    const Scalar z646 = a_psi * q_s_3 - z644 + v_s_3 * z633;
    const Scalar z651 = q_s_4 * z625 - a_s_4 - z649;
    const Scalar z652 = a_psi * q_s_4 - z650 + v_s_4 * z633;
    const Scalar z654 = n20 * z651;  // force on axle_4, x
    const Scalar z661 = n20 * z645;  // force on axle_3, x
    const Scalar z667 = n20 * z639;  // force on axle_2, x
    const Scalar z673 = n20 * z632;  // force on axle_1, x
    const Scalar z655 = n20 * z652;  // force on axle_4, y
    const Scalar z662 = n20 * z646;  // force on axle_3, y
    const Scalar z668 = n20 * z640;  // force on axle_2, y
    const Scalar z674 = n20 * z634;  // force on axle_1, y
    const Scalar z657 = q_s_4 * z655 + z656;  // moment on steered_4, z
    const Scalar z658 = c_alpha_4 * z654 + s_alpha_4 * z655;
    const Scalar z659 = s_alpha_4 * z654 - c_alpha_4 * z655;
    const Scalar z663 = q_s_3 * z662 + z656;  // moment on steered_3, z
    const Scalar z664 = c_alpha_3 * z661 + s_alpha_3 * z662;
    const Scalar z665 = s_alpha_3 * z661 - c_alpha_3 * z662;
    const Scalar z669 = q_s_2 * z668 + z656;  // moment on steered_2, z
    const Scalar z670 = c_alpha_2 * z667 + s_alpha_2 * z668;
    const Scalar z671 = s_alpha_2 * z667 - c_alpha_2 * z668;
    const Scalar z676 = c_alpha_1 * z673 + s_alpha_1 * z674;
    const Scalar z677 = s_alpha_1 * z673 - c_alpha_1 * z674;
    const Scalar z678 = z658 + z664 + z670 + z676;  // force on S, x
    const Scalar z679 = z659 + z665 + z671 + z677;  // force on S, y
    const Scalar z675 = q_s_1 * z674 + z656;  // moment on steered_1, z
    // moment on S, z
    const Scalar z680 = n900 * a_psi + z657 - z658 + z663 - z664 + z669 + z670 + z675 + z676 - k3 * (z659 - z665 - z671
        + z677);
    const Scalar z681 = s_psi * z679 - c_psi * z678;
    const Scalar z682 = s_psi * z678 + c_psi * z679;
    const Scalar z683 = n800 * a_x + z681;  // force on S.y, x
    const Scalar z684 = n800 * a_y - z682;  // force on S.y, y
    forces.x = -l_lambda_wheel_1_x * z615 + l_lambda_wheel_1_y * z614 - l_lambda_wheel_2_x * z618 + l_lambda_wheel_2_y
        * z617 - l_lambda_wheel_3_x * z621 + l_lambda_wheel_3_y * z620 - l_lambda_wheel_4_x * z624 + l_lambda_wheel_4_y
        * z623 + z683;
    forces.y = -l_lambda_wheel_1_x * z614 - l_lambda_wheel_1_y * z615 - l_lambda_wheel_2_x * z617 - l_lambda_wheel_2_y
        * z618 - l_lambda_wheel_3_x * z620 - l_lambda_wheel_3_y * z621 - l_lambda_wheel_4_x * z623 - l_lambda_wheel_4_y
        * z624 + z684;
    forces.psi = -z566 * l_lambda_wheel_1_x + z575 * l_lambda_wheel_2_x + z584 * l_lambda_wheel_3_x - z593
        * l_lambda_wheel_4_x - l_lambda_wheel_1_y * z685 - l_lambda_wheel_2_y * z686 - l_lambda_wheel_3_y * z687
        - l_lambda_wheel_4_y * z688 + z680;
    forces.phi_1 = -n0_3 * l_lambda_wheel_1_y + z672;
    forces.phi_2 = -n0_3 * l_lambda_wheel_2_y + z666;
    forces.phi_3 = -n0_3 * l_lambda_wheel_3_y + z660;
    forces.phi_4 = -n0_3 * l_lambda_wheel_4_y + z653;
    forces.s_1 = -l_lambda_wheel_1_x - z673;
    forces.s_2 = -l_lambda_wheel_2_x - z667;
    forces.s_3 = -l_lambda_wheel_3_x - z661;
    forces.s_4 = -l_lambda_wheel_4_x - z654;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k4 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar k6 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar k7 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z174 = precomputed.z174;
    const Scalar z175 = precomputed.z175;
    const Scalar z206 = precomputed.z206;
    const Scalar z207 = precomputed.z207;
    const Scalar z243 = precomputed.z243;
    const Scalar z244 = precomputed.z244;
    const Scalar z280 = precomputed.z280;
    const Scalar z281 = precomputed.z281;
    const Scalar z565 = precomputed.z565;
    const Scalar z566 = precomputed.z566;
    const Scalar z574 = precomputed.z574;
    const Scalar z575 = precomputed.z575;
    const Scalar z583 = precomputed.z583;
    const Scalar z584 = precomputed.z584;
    const Scalar z592 = precomputed.z592;
    const Scalar z593 = precomputed.z593;
    const Scalar z691 = precomputed.z691;
    const Scalar z700 = precomputed.z700;
    const Scalar z709 = precomputed.z709;
    const Scalar z718 = precomputed.z718;
    const Scalar z1014 = precomputed.z1014;
    const Scalar z1015 = precomputed.z1015;
    const Scalar z1016 = precomputed.z1016;
    const Scalar z1017 = precomputed.z1017;
    const Scalar z1018 = q_psi + p_alpha_1;
    const Scalar z1021 = q_psi + p_alpha_2;
    const Scalar z1024 = q_psi + p_alpha_3;
    const Scalar z1027 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z1018, z1021, z1024, z1027};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z1019 = sines_[1], z1020 = cosines_[1];
    const Scalar z1022 = sines_[2], z1023 = cosines_[2];
    const Scalar z1025 = sines_[3], z1026 = cosines_[3];
    const Scalar z1028 = sines_[4], z1029 = cosines_[4];
    const Scalar z1032 = n20 * q_s_4;
    const Scalar z1043 = n20 * q_s_3;
    const Scalar z1056 = n20 * q_s_2;
    const Scalar z1069 = n20 * q_s_1;
    const Scalar z1031 = s_psi * z174 + c_psi * z175;
    const Scalar z1035 = s_alpha_4 * z1032;
    const Scalar z1046 = s_alpha_3 * z1043;
    const Scalar z1036 = c_alpha_4 * z1032;
    const Scalar z1033 = q_s_4 * z1032;
    const Scalar z1059 = s_alpha_2 * z1056;
    const Scalar z1047 = c_alpha_3 * z1043;
    const Scalar z1034 = n0_5 + z1033;
    const Scalar z1044 = q_s_3 * z1043;
    const Scalar z1072 = s_alpha_1 * z1069;
    const Scalar z1060 = c_alpha_2 * z1056;
    const Scalar z1045 = n0_5 + z1044;
    const Scalar z1037 = k2 - n2 * z1035 + k4 * z1036 + z1034;
    const Scalar z1057 = q_s_2 * z1056;
    const Scalar z1073 = c_alpha_1 * z1069;
    const Scalar z1048 = k2 - n2 * z1046 - k4 * z1047 + z1045;
    const Scalar z1058 = n0_5 + z1057;
    const Scalar z1070 = q_s_1 * z1069;
    const Scalar z1039 = n20 - z1035;
    const Scalar z1050 = n20 - z1046;
    const Scalar z1040 = n900 + z1037;
    const Scalar z1061 = k2 + n2 * z1059 - k4 * z1060 + z1058;
    const Scalar z1053 = z1040 + z1048;
    const Scalar z1071 = n0_5 + z1070;
    const Scalar z1038 = k6 + z1036;
    const Scalar z1049 = k6 - z1047;
    const Scalar z1052 = z1039 + z1050;
    const Scalar z1063 = n20 + z1059;
    const Scalar z1066 = z1053 + z1061;
    const Scalar z1074 = k2 + n2 * z1072 + k4 * z1073 + z1071;
    const Scalar z1051 = z1038 - z1049;
    const Scalar z1062 = k6 - z1060;
    const Scalar z1065 = z1052 - z1063;
    const Scalar z1076 = n20 + z1072;
    const Scalar z1079 = z1066 + z1074;
    const Scalar z1064 = z1051 - z1062;
    const Scalar z1075 = k6 + z1073;
    const Scalar z1078 = z1065 - z1076;
    const Scalar z1077 = z1064 + z1075;
    const Scalar z1042 = s_psi * z206 + c_psi * z207;
    const Scalar z1055 = s_psi * z243 + c_psi * z244;
    const Scalar z1081 = s_psi * z1078 + c_psi * z1077;
    const Scalar z1068 = s_psi * z280 + c_psi * z281;
    const Scalar z1030 = s_psi * z175 - c_psi * z174;
    const Scalar z1080 = s_psi * z1077 - c_psi * z1078;
    const Scalar z1041 = s_psi * z207 - c_psi * z206;
    const Scalar z1054 = s_psi * z244 - c_psi * z243;
    const Scalar z1067 = s_psi * z281 - c_psi * z280;
    const Scalar z1141 = q_s_4 - z592;
    const Scalar z1136 = q_s_3 - z583;
    const Scalar z1131 = q_s_2 + z574;
    const Scalar z1082 = v_psi * v_psi;
    const Scalar z1083 = k7 * z1082;
    const Scalar z1087 = n2 * v_psi;
    const Scalar z1126 = q_s_1 + z565;
    const Scalar z1128 = v_psi * z1020;
    const Scalar z1133 = v_psi * z1023;
    const Scalar z1138 = v_psi * z1026;
    const Scalar z1093 = s_alpha_3 * z1082 + c_alpha_3 * z1083;
    const Scalar z1097 = s_alpha_4 * z1082 - c_alpha_4 * z1083;
    const Scalar z1098 = c_alpha_4 * z1082 + s_alpha_4 * z1083;
    const Scalar z1095 = q_s_3 * z1082 - z1093;
    const Scalar z1099 = q_s_4 * z1082 - z1097;
    const Scalar z1100 = v_s_4 * z1087 + z1098;
    const Scalar z1089 = s_alpha_2 * z1082 - c_alpha_2 * z1083;
    const Scalar z1091 = q_s_2 * z1082 + z1089;
    const Scalar z1101 = n20 * z1099;  // force on axle_4, x
    const Scalar z1102 = n20 * z1100;  // force on axle_4, y
    const Scalar z1106 = n20 * z1095;  // force on axle_3, x
    const Scalar z1090 = c_alpha_2 * z1082 + s_alpha_2 * z1083;
    const Scalar z1092 = v_s_2 * z1087 - z1090;
    const Scalar z1111 = n20 * z1091;  // force on axle_2, x
    const Scalar z1094 = s_alpha_3 * z1083 - c_alpha_3 * z1082;
    const Scalar z1096 = v_s_3 * z1087 - z1094;
    const Scalar z1112 = n20 * z1092;  // force on axle_2, y
    const Scalar z1084 = s_alpha_1 * z1082 + c_alpha_1 * z1083;
    const Scalar z1085 = s_alpha_1 * z1083 - c_alpha_1 * z1082;
    const Scalar z1086 = q_s_1 * z1082 + z1084;
    const Scalar z1088 = v_s_1 * z1087 + z1085;
    const Scalar z1153 = z1014 - z1079;
    const Scalar z1161 = z1015 + z1153;
    const Scalar z1152 = z691 * z1031 - z1081;
    const Scalar z1160 = z700 * z1042 + z1152;
    const Scalar z1151 = z691 * z1030 - z1080;
    const Scalar z1159 = z700 * z1041 + z1151;
    const Scalar z1107 = n20 * z1096;  // force on axle_3, y
    const Scalar z1116 = n20 * z1086;  // force on axle_1, x
    const Scalar z1117 = n20 * z1088;  // force on axle_1, y
    const Scalar z1147 = n0_05 * z1031;
    const Scalar z1150 = n880 - z1031 * z1147;
    const Scalar z1155 = n0_05 * z1042;
    const Scalar z1146 = n0_05 * z1030;
    const Scalar z1149 = z1030 * z1147;
    const Scalar z1148 = n880 - z1030 * z1146;
    const Scalar z1157 = z1041 * z1155 + z1149;
    const Scalar z1158 = z1042 * z1155 - z1150;
    const Scalar z1154 = n0_05 * z1041;
    const Scalar z1156 = z1041 * z1154 - z1148;
    const Scalar z1162 = n0_05 * z1054;
    const Scalar z1104 = s_alpha_4 * z1102 + c_alpha_4 * z1101;
    const Scalar z1105 = s_alpha_4 * z1101 - c_alpha_4 * z1102;
    const Scalar z1103 = q_s_4 * z1102;  // moment on steered_4, z
    const Scalar z1167 = z709 * z1054 - z1159;
    const Scalar z1164 = z1054 * z1162 + z1156;
    const Scalar z1163 = n0_05 * z1055;
    const Scalar z1165 = z1054 * z1163 + z1157;
    const Scalar z1166 = z1055 * z1163 + z1158;
    const Scalar z1109 = c_alpha_3 * z1106 + s_alpha_3 * z1107;
    const Scalar z1110 = s_alpha_3 * z1106 - c_alpha_3 * z1107;
    const Scalar z1108 = q_s_3 * z1107;  // moment on steered_3, z
    const Scalar z1168 = z709 * z1055 - z1160;
    const Scalar z1169 = z1016 + z1161;
    const Scalar z1171 = n0_05 * z1068;
    const Scalar z1170 = n0_05 * z1067;
    const Scalar z1172 = z1067 * z1170 + z1164;
    const Scalar z1114 = s_alpha_2 * z1112 + c_alpha_2 * z1111;
    const Scalar z1115 = s_alpha_2 * z1111 - c_alpha_2 * z1112;
    const Scalar z1113 = q_s_2 * z1112;  // moment on steered_2, z
    const Scalar z1177 = z1017 + z1169;
    const Scalar z1176 = z718 * z1068 + z1168;
    const Scalar z1174 = z1068 * z1171 + z1166;
    const Scalar z1173 = z1067 * z1171 + z1165;
    const Scalar z1175 = z718 * z1067 + z1167;
    const Scalar z1119 = c_alpha_1 * z1116 + s_alpha_1 * z1117;
    const Scalar z1120 = s_alpha_1 * z1116 - c_alpha_1 * z1117;
    const Scalar z1118 = q_s_1 * z1117;  // moment on steered_1, z
    // moment on S, z
    const Scalar z1123 = z1103 + z1113 + z1108 + z1118 - z1104 - z1109 + z1114 + z1119 - k7 * (z1105 - z1110 - z1115
        + z1120);
    const Scalar z1121 = z1104 + z1109 + z1114 + z1119;  // force on S, x
    const Scalar z1122 = z1105 + z1110 + z1115 + z1120;  // force on S, y
    const Scalar z1178 = n1 / z1177;
    const Scalar z1180 = z1176 * z1178;
    const Scalar z1179 = z1175 * z1178;
    const Scalar z1124 = s_psi * z1122 - c_psi * z1121;
    const Scalar z1125 = s_psi * z1121 + c_psi * z1122;
    const Scalar z1183 = z1174 - z1176 * z1180;
    const Scalar z1182 = z1173 - z1175 * z1180;
    const Scalar z1181 = z1172 - z1175 * z1179;
    const Scalar z1184 = n1 / z1183;
    const Scalar z1143 = v_psi * z1029;
    const Scalar z1127 = v_psi * z1019;
    const Scalar z1188 = z1019 - z1171;
    const Scalar z1132 = v_psi * z1022;
    const Scalar z1137 = v_psi * z1025;
    const Scalar z1142 = v_psi * z1028;
    const Scalar z1129 = v_x * z1127 - v_y * z1128;
    const Scalar z1130 = v_x * z1128 + v_y * z1127 - v_psi * v_s_1;
    const Scalar z1134 = v_x * z1132 - v_y * z1133;
    const Scalar z1135 = v_x * z1133 + v_y * z1132 - v_psi * v_s_2;
    const Scalar z1197 = z1020 + z1126 * z1180;
    const Scalar z1139 = v_x * z1137 - v_y * z1138;
    const Scalar z1140 = v_x * z1138 + v_y * z1137 - v_psi * v_s_3;
    const Scalar z1185 = z1182 * z1184;
    const Scalar z1186 = z1181 - z1182 * z1185;
    const Scalar z1198 = z1019 + z1126 * z1179 - z1185 * z1197;
    const Scalar z1189 = z1020 + z1170 + z1185 * z1188;
    const Scalar z1187 = n1 / z1186;
    const Scalar z1144 = v_x * z1142 - v_y * z1143;
    const Scalar z1145 = v_x * z1143 + v_y * z1142 - v_psi * v_s_4;
    const Scalar z1242 = z1028 - z1147;
    const Scalar z1243 = z1029 + z1146 + z1185 * z1242;
    const Scalar z1233 = z1026 + z1136 * z1180;
    const Scalar z1234 = z1025 + z1136 * z1179 - z1185 * z1233;
    const Scalar z1224 = z1025 - z1155;
    const Scalar z1225 = z1026 + z1154 + z1185 * z1224;
    const Scalar z1215 = z1023 + z1131 * z1180;
    const Scalar z1244 = z1187 * z1243;
    const Scalar z1235 = z1187 * z1234;
    const Scalar z1199 = z1187 * z1198;
    const Scalar z1226 = z1187 * z1225;
    const Scalar z1190 = z1187 * z1189;
    const Scalar z1216 = z1022 + z1131 * z1179 - z1185 * z1215;
    const Scalar z1245 = z1184 * z1242 + z1185 * z1244;
    const Scalar z1236 = z1184 * z1233 - z1185 * z1235;
    const Scalar z1227 = z1184 * z1224 + z1185 * z1226;
    const Scalar z1217 = z1187 * z1216;
    const Scalar z1218 = z1184 * z1215 - z1185 * z1217;
    const Scalar z1200 = z1184 * z1197 - z1185 * z1199;
    const Scalar z1191 = z1184 * z1188 + z1185 * z1190;
    const Scalar z1251 = z1029 + z1141 * z1180;
    const Scalar z1246 = z1179 * z1244 - z1180 * z1245;
    const Scalar z1250 = n0_05 - z1146 * z1244 + z1147 * z1245 - z691 * z1246;
    const Scalar z1237 = z1136 * z1178 + z1179 * z1235 + z1180 * z1236;
    const Scalar z1241 = z1146 * z1235 + z1147 * z1236 + z691 * z1237;
    const Scalar z1228 = z1179 * z1226 - z1180 * z1227;
    const Scalar z1232 = z1146 * z1226 - z1147 * z1227 + z691 * z1228;
    const Scalar z1219 = z1131 * z1178 + z1179 * z1217 + z1180 * z1218;
    const Scalar z1231 = n0_05 - z1154 * z1226 + z1155 * z1227 - z700 * z1228;
    const Scalar z1206 = z1022 - z1163;
    const Scalar z1223 = z1146 * z1217 + z1147 * z1218 + z691 * z1219;
    const Scalar z1207 = z1023 + z1162 + z1185 * z1206;
    const Scalar z1208 = z1187 * z1207;
    const Scalar z1222 = z1154 * z1217 + z1155 * z1218 + z700 * z1219;
    const Scalar z1209 = z1184 * z1206 + z1185 * z1208;
    const Scalar z1201 = z1126 * z1178 + z1179 * z1199 + z1180 * z1200;
    const Scalar z1210 = z1179 * z1208 - z1180 * z1209;
    const Scalar z1205 = z1146 * z1199 + z1147 * z1200 + z691 * z1201;
    const Scalar z1214 = z1146 * z1208 - z1147 * z1209 + z691 * z1210;
    const Scalar z1213 = z1154 * z1208 - z1155 * z1209 + z700 * z1210;
    const Scalar z1212 = n0_05 - z1162 * z1208 + z1163 * z1209 + z709 * z1210;
    const Scalar z1203 = z709 * z1201 - z1162 * z1199 - z1163 * z1200;
    const Scalar z1204 = z1154 * z1199 + z1155 * z1200 + z700 * z1201;
    const Scalar z1192 = z1179 * z1190 - z1180 * z1191;
    const Scalar z1252 = z1028 + z1141 * z1179 - z1185 * z1251;
    const Scalar z1196 = z1146 * z1190 - z1147 * z1191 + z691 * z1192;
    const Scalar z1193 = n0_05 - z1170 * z1190 + z1171 * z1191 + z718 * z1192;
    const Scalar z1253 = z1187 * z1252;
    const Scalar z1194 = z1163 * z1191 - z1162 * z1190 + z709 * z1192;
    const Scalar z1254 = z1184 * z1251 - z1185 * z1253;
    const Scalar z1195 = z1154 * z1190 - z1155 * z1191 + z700 * z1192;
    const Scalar z1255 = z1141 * z1178 + z1179 * z1253 + z1180 * z1254;
    const Scalar z1261 = z1019 * z1190 - z1020 * z1191 + z1126 * z1192;
    const Scalar z1260 = z1193 + z566 * z1192 - z1020 * z1190 - z1019 * z1191;
    const Scalar z1202 = z718 * z1201 - z1170 * z1199 - z1171 * z1200;
    const Scalar z1269 = n0_1 - z1022 * z1217 - z1023 * z1218 - z1131 * z1219;
    const Scalar z1268 = z1022 * z1208 - z1023 * z1209 + z1131 * z1210;
    const Scalar z1265 = z1023 * z1208 + z1022 * z1209 + z575 * z1210 - z1212;
    const Scalar z1264 = z575 * z1201 - z1022 * z1200 + z1023 * z1199 - z1203;
    const Scalar z1267 = z1022 * z1199 + z1023 * z1200 + z1131 * z1201;
    const Scalar z1262 = n0_1 - z1019 * z1199 - z1020 * z1200 - z1126 * z1201;
    const Scalar z1263 = z1023 * z1190 + z1022 * z1191 + z575 * z1192 - z1194;
    const Scalar z1266 = z1022 * z1190 - z1023 * z1191 + z1131 * z1192;
    const Scalar z1270 = z1026 * z1190 + z1025 * z1191 + z584 * z1192 + z1195;
    const Scalar z1211 = z1171 * z1209 - z1170 * z1208 + z718 * z1210;
    const Scalar z1279 = z1025 * z1226 - z1026 * z1227 + z1136 * z1228;
    const Scalar z1274 = z1026 * z1226 + z1025 * z1227 + z584 * z1228 - z1231;
    const Scalar z1273 = z1026 * z1217 - z1025 * z1218 + z584 * z1219 + z1222;
    const Scalar z1278 = z1025 * z1217 + z1026 * z1218 + z1136 * z1219;
    const Scalar z1272 = z1026 * z1208 + z1025 * z1209 + z584 * z1210 + z1213;
    const Scalar z1277 = z1025 * z1208 - z1026 * z1209 + z1136 * z1210;
    const Scalar z1271 = z1026 * z1199 - z1025 * z1200 + z584 * z1201 + z1204;
    const Scalar z1276 = z1025 * z1199 + z1026 * z1200 + z1136 * z1201;
    const Scalar z1275 = z1025 * z1190 - z1026 * z1191 + z1136 * z1192;
    const Scalar z1220 = z718 * z1219 - z1170 * z1217 - z1171 * z1218;
    const Scalar z1280 = n0_1 - z1025 * z1235 - z1026 * z1236 - z1136 * z1237;
    const Scalar z1221 = z709 * z1219 - z1162 * z1217 - z1163 * z1218;
    const Scalar z1287 = z1250 + z593 * z1246 - z1029 * z1244 - z1028 * z1245;
    const Scalar z1286 = z1028 * z1236 - z1241 - z1029 * z1235 + z593 * z1237;
    const Scalar z1285 = z593 * z1228 - z1232 - z1029 * z1226 - z1028 * z1227;
    const Scalar z1284 = z1028 * z1218 - z1223 - z1029 * z1217 + z593 * z1219;
    const Scalar z1283 = z593 * z1210 - z1214 - z1029 * z1208 - z1028 * z1209;
    const Scalar z1282 = z1028 * z1200 - z1205 - z1029 * z1199 + z593 * z1201;
    const Scalar z1281 = z593 * z1192 - z1196 - z1029 * z1190 - z1028 * z1191;
    const Scalar z1288 = z1028 * z1190 - z1029 * z1191 + z1141 * z1192;
    const Scalar z1229 = z1171 * z1227 - z1170 * z1226 + z718 * z1228;
    const Scalar z1289 = z1028 * z1199 + z1029 * z1200 + z1141 * z1201;
    const Scalar z1230 = z1163 * z1227 - z1162 * z1226 + z709 * z1228;
    const Scalar z1295 = n0_1 - z1028 * z1253 - z1029 * z1254 - z1141 * z1255;
    const Scalar z1294 = z1028 * z1244 - z1029 * z1245 + z1141 * z1246;
    const Scalar z1296 = n1 / z1295;
    const Scalar z1293 = z1028 * z1235 + z1029 * z1236 + z1141 * z1237;
    const Scalar z1292 = z1028 * z1226 - z1029 * z1227 + z1141 * z1228;
    const Scalar z1291 = z1028 * z1217 + z1029 * z1218 + z1141 * z1219;
    const Scalar z1290 = z1028 * z1208 - z1029 * z1209 + z1141 * z1210;
    const Scalar z1297 = z1288 * z1296;
    const Scalar z1238 = z718 * z1237 - z1170 * z1235 - z1171 * z1236;
    const Scalar z1298 = z1289 * z1296;
    const Scalar z1239 = z709 * z1237 - z1162 * z1235 - z1163 * z1236;
    const Scalar z1299 = z1290 * z1296;
    const Scalar z1240 = z1154 * z1235 + z1155 * z1236 + z700 * z1237;
    const Scalar z1305 = z1261 + z1288 * z1298;
    const Scalar z1303 = z1294 * z1296;
    const Scalar z1302 = z1293 * z1296;
    const Scalar z1301 = z1292 * z1296;
    const Scalar z1300 = z1291 * z1296;
    const Scalar z1306 = z1262 - z1289 * z1298;
    const Scalar z1304 = z1260 - z1288 * z1297;
    const Scalar z1247 = z1171 * z1245 - z1170 * z1244 + z718 * z1246;
    const Scalar z1307 = z1263 + z1288 * z1299;
    const Scalar z1248 = z1163 * z1245 - z1162 * z1244 + z709 * z1246;
    const Scalar z1308 = z1264 + z1289 * z1299;
    const Scalar z1249 = z1154 * z1244 - z1155 * z1245 + z700 * z1246;
    const Scalar z1312 = z1268 + z1290 * z1300;
    const Scalar z1311 = z1267 + z1289 * z1300;
    const Scalar z1315 = z1271 + z1289 * z1301;
    const Scalar z1310 = z1266 + z1288 * z1300;
    const Scalar z1314 = z1270 + z1288 * z1301;
    const Scalar z1313 = z1269 - z1291 * z1300;
    const Scalar z1309 = z1265 + z1290 * z1299;
    const Scalar z1256 = z718 * z1255 - z1170 * z1253 - z1171 * z1254;
    const Scalar z1316 = z1272 + z1290 * z1301;
    const Scalar z1257 = z709 * z1255 - z1162 * z1253 - z1163 * z1254;
    const Scalar z1317 = z1273 + z1291 * z1301;
    const Scalar z1258 = z1154 * z1253 + z1155 * z1254 + z700 * z1255;
    const Scalar z1318 = z1274 + z1292 * z1301;
    const Scalar z1259 = z1146 * z1253 + z1147 * z1254 + z691 * z1255;
    const Scalar z1331 = z1287 - z1294 * z1303;
    const Scalar z1330 = z1286 - z1293 * z1303;
    const Scalar z1332 = n1 / z1331;
    const Scalar z1324 = z1280 - z1293 * z1302;
    const Scalar z1323 = z1279 + z1292 * z1302;
    const Scalar z1329 = z1285 - z1292 * z1303;
    const Scalar z1322 = z1278 + z1291 * z1302;
    const Scalar z1328 = z1284 - z1291 * z1303;
    const Scalar z1321 = z1277 + z1290 * z1302;
    const Scalar z1327 = z1283 - z1290 * z1303;
    const Scalar z1320 = z1276 + z1289 * z1302;
    const Scalar z1326 = z1282 - z1289 * z1303;
    const Scalar z1319 = z1275 + z1288 * z1302;
    const Scalar z1325 = z1281 - z1288 * z1303;
    const Scalar z1333 = z1325 * z1332;
    const Scalar z1338 = z1330 * z1332;
    const Scalar z1337 = z1329 * z1332;
    const Scalar z1336 = z1328 * z1332;
    const Scalar z1335 = z1327 * z1332;
    const Scalar z1334 = z1326 * z1332;
    const Scalar z1339 = z1304 - z1325 * z1333;
    const Scalar z1359 = z1324 - z1330 * z1338;
    const Scalar z1358 = z1323 + z1329 * z1338;
    const Scalar z1353 = z1318 + z1329 * z1337;
    const Scalar z1352 = z1317 + z1328 * z1337;
    const Scalar z1360 = n1 / z1359;
    const Scalar z1357 = z1322 + z1328 * z1338;
    const Scalar z1348 = z1313 - z1328 * z1336;
    const Scalar z1347 = z1312 + z1327 * z1336;
    const Scalar z1351 = z1316 + z1327 * z1337;
    const Scalar z1356 = z1321 + z1327 * z1338;
    const Scalar z1344 = z1309 + z1327 * z1335;
    const Scalar z1343 = z1308 + z1326 * z1335;
    const Scalar z1346 = z1311 + z1326 * z1336;
    const Scalar z1350 = z1315 + z1326 * z1337;
    const Scalar z1355 = z1320 + z1326 * z1338;
    const Scalar z1341 = z1306 - z1326 * z1334;
    const Scalar z1340 = z1305 + z1325 * z1334;
    const Scalar z1342 = z1307 + z1325 * z1335;
    const Scalar z1345 = z1310 + z1325 * z1336;
    const Scalar z1349 = z1314 + z1325 * z1337;
    const Scalar z1354 = z1319 + z1325 * z1338;
    const Scalar z1416 = z691 * z1101 + z700 * z1106 - z709 * z1111 - z718 * z1116 + z1123;
    const Scalar z1417 = z1101 * z1147 - z1125 + z1106 * z1155 + z1111 * z1163 + z1116 * z1171 + z1180 * z1416;
    const Scalar z1418 = z1101 * z1146 - z1124 + z1106 * z1154 + z1111 * z1162 + z1116 * z1170 + z1179 * z1416 - z1185
        * z1417;
    const Scalar z1419 = z1187 * z1418;
    const Scalar z1365 = z1358 * z1360;
    const Scalar z1380 = z1353 + z1358 * z1365;
    const Scalar z1379 = z1352 + z1357 * z1365;
    const Scalar z1420 = z1184 * z1417 - z1185 * z1419;
    const Scalar z1378 = z1351 + z1356 * z1365;
    const Scalar z1381 = n1 / z1380;
    const Scalar z1377 = z1350 + z1355 * z1365;
    const Scalar z1376 = z1349 + z1354 * z1365;
    const Scalar z1364 = z1357 * z1360;
    const Scalar z1375 = z1348 - z1357 * z1364;
    const Scalar z1374 = z1347 + z1356 * z1364;
    const Scalar z1373 = z1346 + z1355 * z1364;
    const Scalar z1372 = z1345 + z1354 * z1364;
    const Scalar z1363 = z1356 * z1360;
    const Scalar z1371 = z1344 + z1356 * z1363;
    const Scalar z1370 = z1343 + z1355 * z1363;
    const Scalar z1369 = z1342 + z1354 * z1363;
    const Scalar z1362 = z1355 * z1360;
    const Scalar z1368 = z1341 - z1355 * z1362;
    const Scalar z1367 = z1340 + z1354 * z1362;
    const Scalar z1385 = z1379 * z1381;
    const Scalar z1384 = z1378 * z1381;
    const Scalar z1383 = z1377 * z1381;
    const Scalar z1361 = z1354 * z1360;
    const Scalar z1421 = z1178 * z1416 + z1179 * z1419 + z1180 * z1420;
    const Scalar z1422 = n0_05 * z1116 - z1170 * z1419 - z1171 * z1420 + z718 * z1421;
    const Scalar z1423 = n0_05 * z1111 - z1162 * z1419 - z1163 * z1420 + z709 * z1421;
    const Scalar z1424 = z1154 * z1419 - n0_05 * z1106 + z1155 * z1420 + z700 * z1421;
    const Scalar z1425 = z1146 * z1419 - n0_05 * z1101 + z1147 * z1420 + z691 * z1421;
    const Scalar z1395 = z1375 + z1379 * z1385;
    const Scalar z1366 = z1339 - z1354 * z1361;
    const Scalar z1427 = z1019 * z1419 - z1130 + z1020 * z1420 + z1126 * z1421;
    const Scalar z1429 = z1022 * z1419 - z1135 + z1023 * z1420 + z1131 * z1421;
    const Scalar z1431 = z1025 * z1419 - z1140 + z1026 * z1420 + z1136 * z1421;
    const Scalar z1433 = z1028 * z1419 - z1145 + z1029 * z1420 + z1141 * z1421;
    const Scalar z1394 = z1374 - z1378 * z1385;
    const Scalar z1391 = z1371 - z1378 * z1384;
    const Scalar z1396 = n1 / z1395;
    const Scalar z1390 = z1370 - z1377 * z1384;
    const Scalar z1393 = z1373 - z1377 * z1385;
    const Scalar z1388 = z1368 + z1377 * z1383;
    const Scalar z1387 = z1367 - z1376 * z1383;
    const Scalar z1389 = z1369 - z1376 * z1384;
    const Scalar z1392 = z1372 - z1376 * z1385;
    const Scalar z1426 = z1019 * z1420 - z1129 - z1020 * z1419 + z566 * z1421 + z1422;
    const Scalar z1428 = z1134 + z1023 * z1419 - z1022 * z1420 + z575 * z1421 - z1423;
    const Scalar z1430 = z1139 + z1026 * z1419 - z1025 * z1420 + z584 * z1421 + z1424;
    const Scalar z1432 = z1028 * z1420 - z1144 - z1029 * z1419 + z593 * z1421 - z1425;
    const Scalar z1434 = z1303 * z1433 - z1432;
    const Scalar z1399 = z1394 * z1396;
    const Scalar z1405 = z1391 + z1394 * z1399;
    const Scalar z1404 = z1390 + z1393 * z1399;
    const Scalar z1403 = z1389 + z1392 * z1399;
    const Scalar z1435 = z1431 + z1302 * z1433 - z1338 * z1434;
    const Scalar z1406 = n1 / z1405;
    const Scalar z1398 = z1393 * z1396;
    const Scalar z1402 = z1388 - z1393 * z1398;
    const Scalar z1401 = z1387 + z1392 * z1398;
    const Scalar z1436 = z1430 + z1301 * z1433 - z1337 * z1434 + z1365 * z1435;
    const Scalar z1437 = z1429 + z1300 * z1433 - z1336 * z1434 + z1364 * z1435 - z1385 * z1436;
    const Scalar z1438 = z1428 + z1299 * z1433 - z1335 * z1434 + z1363 * z1435 - z1384 * z1436 + z1399 * z1437;
    const Scalar z1408 = z1404 * z1406;
    const Scalar z1411 = z1402 + z1404 * z1408;
    const Scalar z1410 = z1401 - z1403 * z1408;
    const Scalar z1439 = z1427 + z1298 * z1433 - z1334 * z1434 + z1362 * z1435 - z1383 * z1436 + z1398 * z1437 - z1408
        * z1438;
    const Scalar z1412 = n1 / z1411;
    const Scalar z1382 = z1376 * z1381;
    const Scalar z1386 = z1366 + z1376 * z1382;
    const Scalar z1449 = z1262 + z1269 + z1280 + z1295 - z1265 - z1274 + z1260 + z1287;
    const Scalar z1450 = n4096 * z1449;
    const Scalar z1397 = z1392 * z1396;
    const Scalar z1400 = z1386 - z1392 * z1397;
    const Scalar z1407 = z1403 * z1406;
    const Scalar z1413 = z1410 * z1412;
    const Scalar z1409 = z1400 + z1403 * z1407;
    const Scalar z1440 = z1297 * z1433 - z1426 - z1333 * z1434 + z1361 * z1435 - z1382 * z1436 + z1397 * z1437 - z1407
        * z1438 + z1413 * z1439;
    const Scalar z1414 = z1409 - z1410 * z1413;
    const Scalar z1415 = n1 / z1414;
    const Scalar z1441 = z1415 * z1440;
    const Scalar z1442 = z1412 * z1439 + z1413 * z1441;
    const Scalar z1443 = z1406 * z1438 + z1407 * z1441 + z1408 * z1442;
    const Scalar z1454 = n1_over_3 * z1442;
    const Scalar z1444 = z1396 * z1437 + z1397 * z1441 + z1398 * z1442 - z1399 * z1443;
    const Scalar z1445 = z1381 * z1436 + z1382 * z1441 + z1383 * z1442 - z1384 * z1443 + z1385 * z1444;
    const Scalar z1455 = n1_over_3 * z1444;
    const Scalar z1446 = z1360 * z1435 + z1361 * z1441 + z1362 * z1442 - z1363 * z1443 + z1364 * z1444 - z1365 * z1445;
    const Scalar z1447 = z1332 * z1434 - z1333 * z1441 - z1334 * z1442 + z1335 * z1443 - z1336 * z1444 + z1337 * z1445
        - z1338 * z1446;
    const Scalar z1456 = n1_over_3 * z1446;
    const Scalar z1448 = z1296 * z1433 + z1297 * z1441 + z1298 * z1442 - z1299 * z1443 + z1300 * z1444 - z1301 * z1445
        + z1302 * z1446 + z1303 * z1447;
    const Scalar z1451 = z1419 + z1190 * z1441 + z1199 * z1442 - z1208 * z1443 + z1217 * z1444 - z1226 * z1445 + z1235
        * z1446 + z1244 * z1447 + z1253 * z1448;
    const Scalar z1452 = z1191 * z1441 - z1420 - z1200 * z1442 - z1209 * z1443 - z1218 * z1444 - z1227 * z1445 - z1236
        * z1446 + z1245 * z1447 - z1254 * z1448;
    const Scalar z1453 = z1421 + z1192 * z1441 + z1201 * z1442 - z1210 * z1443 + z1219 * z1444 - z1228 * z1445 + z1237
        * z1446 + z1246 * z1447 + z1255 * z1448;
    const Scalar z1458 = z1422 + z1193 * z1441 + z1202 * z1442 - z1211 * z1443 + z1220 * z1444 - z1229 * z1445 + z1238
        * z1446 + z1247 * z1447 + z1256 * z1448;
    const Scalar z1459 = z1423 + z1194 * z1441 + z1203 * z1442 - z1212 * z1443 + z1221 * z1444 - z1230 * z1445 + z1239
        * z1446 + z1248 * z1447 + z1257 * z1448;
    const Scalar z1460 = z1424 + z1195 * z1441 + z1204 * z1442 - z1213 * z1443 + z1222 * z1444 + z1231 * z1445 + z1240
        * z1446 + z1249 * z1447 + z1258 * z1448;
    const Scalar z1457 = n1_over_3 * z1448;
    const Scalar z1461 = z1425 + z1196 * z1441 + z1205 * z1442 - z1214 * z1443 + z1223 * z1444 - z1232 * z1445 + z1241
        * z1446 - z1250 * z1447 + z1259 * z1448;
    accelerations.x = -z1451;
    accelerations.y = -z1452;
    accelerations.psi = z1453;
    accelerations.phi_1 = -z1454;
    accelerations.phi_2 = -z1455;
    accelerations.phi_3 = -z1456;
    accelerations.phi_4 = -z1457;
    accelerations.s_1 = z1458;
    accelerations.s_2 = z1459;
    accelerations.s_3 = -z1460;
    accelerations.s_4 = -z1461;
    multipliers.lambda_wheel_1_x = z1441;
    multipliers.lambda_wheel_1_y = -z1442;
    multipliers.lambda_wheel_2_x = -z1443;
    multipliers.lambda_wheel_2_y = -z1444;
    multipliers.lambda_wheel_3_x = -z1445;
    multipliers.lambda_wheel_3_y = -z1446;
    multipliers.lambda_wheel_4_x = z1447;
    multipliers.lambda_wheel_4_y = -z1448;
    if (!(traits::regular(-z1186, n880) && traits::regular(-z1183, n880) && traits::regular(-z1177, z1079)
        && traits::regular(z1414, z1450) && traits::regular(z1411, z1450) && traits::regular(-z1405, z1450)
        && traits::regular(z1395, z1450) && traits::regular(-z1380, z1450) && traits::regular(z1359, z1450)
        && traits::regular(z1331, z1450) && traits::regular(z1295, z1450))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.phi_1
        * accelerations.phi_2 * accelerations.phi_3 * accelerations.phi_4 * accelerations.s_1 * accelerations.s_2) * (n0
        * accelerations.s_3 * accelerations.s_4 * multipliers.lambda_wheel_1_x * multipliers.lambda_wheel_1_y
        * multipliers.lambda_wheel_2_x * multipliers.lambda_wheel_2_y * multipliers.lambda_wheel_3_x
        * multipliers.lambda_wheel_3_y * multipliers.lambda_wheel_4_x * multipliers.lambda_wheel_4_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z1462 = v_x * c_psi + v_y * s_psi;
    const Scalar z1463 = v_x * s_psi - v_y * c_psi;
    const Scalar z76 = v_psi * s_phi_1;
    const Scalar z77 = v_psi * c_phi_1;
    const Scalar z100 = v_psi * s_phi_2;
    const Scalar z101 = v_psi * c_phi_2;
    const Scalar z122 = v_psi * s_phi_3;
    const Scalar z123 = v_psi * c_phi_3;
    const Scalar z144 = v_psi * s_phi_4;
    const Scalar z145 = v_psi * c_phi_4;
    const Scalar z1464 = v_psi - z1462;
    const Scalar z1465 = k0 * v_psi - z1463;
    const Scalar z1472 = k0 * v_psi + z1463;
    const Scalar z1479 = v_psi + z1462;
    const Scalar z1466 = s_alpha_1 * z1465 - c_alpha_1 * z1464;
    const Scalar z1467 = s_alpha_1 * z1464 + c_alpha_1 * z1465;
    const Scalar z1473 = c_alpha_2 * z1464 + s_alpha_2 * z1472;
    const Scalar z1474 = s_alpha_2 * z1464 - c_alpha_2 * z1472;
    const Scalar z1480 = s_alpha_3 * z1472 - c_alpha_3 * z1479;
    const Scalar z1481 = s_alpha_3 * z1479 + c_alpha_3 * z1472;
    const Scalar z1486 = c_alpha_4 * z1479 + s_alpha_4 * z1465;
    const Scalar z1487 = s_alpha_4 * z1479 - c_alpha_4 * z1465;
    const Scalar z1468 = v_psi * q_s_1 + z1467;
    const Scalar z1475 = v_psi * q_s_2 + z1474;
    const Scalar z1476 = v_s_2 - z1473;  // velocity of axle_2, x
    const Scalar z1482 = v_psi * q_s_3 - z1481;
    const Scalar z1488 = v_psi * q_s_4 - z1487;
    const Scalar z1489 = v_s_4 + z1486;  // velocity of axle_4, x
    const Scalar z1469 = v_s_1 + z1466;  // velocity of axle_1, x
    const Scalar z1483 = v_s_3 - z1480;  // velocity of axle_3, x
    const Scalar z1470 = c_phi_1 * z1468;
    const Scalar z1471 = s_phi_1 * z1468;
    const Scalar z1477 = c_phi_2 * z1475;
    const Scalar z1478 = s_phi_2 * z1475;
    const Scalar z1484 = c_phi_3 * z1482;
    const Scalar z1485 = s_phi_3 * z1482;
    const Scalar z1490 = c_phi_4 * z1488;
    const Scalar z1491 = s_phi_4 * z1488;
    result.kinetic = n450 * v_psi * v_psi + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3 * v_phi_3 + v_phi_4
        * v_phi_4) + n400 * (z1462 * z1462 + z1463 * z1463) + n0_25 * (z76 * z76 + z77 * z77 + z100 * z100 + z101 * z101
        + z122 * z122 + z123 * z123 + z144 * z144 + z145 * z145) + n10 * (z1476 * z1476 + z1489 * z1489 + z1469 * z1469
        + z1483 * z1483 + z1470 * z1470 + z1471 * z1471 + z1477 * z1477 + z1478 * z1478 + z1484 * z1484 + z1485 * z1485
        + z1490 * z1490 + z1491 * z1491);
    result.force_function = n0;
    result.power = n0;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z565 = precomputed.z565;
    const Scalar z566 = precomputed.z566;
    const Scalar z574 = precomputed.z574;
    const Scalar z575 = precomputed.z575;
    const Scalar z583 = precomputed.z583;
    const Scalar z584 = precomputed.z584;
    const Scalar z592 = precomputed.z592;
    const Scalar z593 = precomputed.z593;
    const Scalar z55 = q_psi + p_alpha_1;
    const Scalar z80 = q_psi + p_alpha_2;
    const Scalar z104 = q_psi + p_alpha_3;
    const Scalar z126 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z55, z80, z104, z126};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z56 = sines_[0], z57 = cosines_[0];
    const Scalar z81 = sines_[1], z82 = cosines_[1];
    const Scalar z105 = sines_[2], z106 = cosines_[2];
    const Scalar z127 = sines_[3], z128 = cosines_[3];
    const Scalar z570 = v_psi * z57;
    const Scalar z579 = v_psi * z82;
    const Scalar z588 = v_psi * z106;
    const Scalar z597 = v_psi * z128;
    const Scalar z567 = q_s_1 + z565;
    const Scalar z569 = v_psi * z56;
    const Scalar z576 = q_s_2 + z574;
    const Scalar z578 = v_psi * z81;
    const Scalar z585 = q_s_3 - z583;
    const Scalar z587 = v_psi * z105;
    const Scalar z594 = q_s_4 - z592;
    const Scalar z596 = v_psi * z127;
    const Scalar z568 = v_psi * z566 + v_s_1 + v_x * z57 + v_y * z56;
    const Scalar z572 = v_x * z56 - v_y * z57 - v_psi * z567 - n0_3 * v_phi_1;
    const Scalar z577 = v_s_2 - v_psi * z575 + v_x * z82 + v_y * z81;
    const Scalar z581 = v_x * z81 - v_y * z82 - v_psi * z576 - n0_3 * v_phi_2;
    const Scalar z586 = v_s_3 - v_psi * z584 + v_x * z106 + v_y * z105;
    const Scalar z590 = v_x * z105 - v_y * z106 - v_psi * z585 - n0_3 * v_phi_3;
    const Scalar z595 = v_psi * z593 + v_s_4 + v_x * z128 + v_y * z127;
    const Scalar z599 = v_x * z127 - v_y * z128 - v_psi * z594 - n0_3 * v_phi_4;
    const Scalar z571 = v_x * z569 - v_y * z570;
    const Scalar z573 = v_x * z570 + v_y * z569 - v_psi * v_s_1;
    const Scalar z580 = v_x * z578 - v_y * z579;
    const Scalar z582 = v_x * z579 + v_y * z578 - v_psi * v_s_2;
    const Scalar z589 = v_x * z587 - v_y * z588;
    const Scalar z591 = v_x * z588 + v_y * z587 - v_psi * v_s_3;
    const Scalar z598 = v_x * z596 - v_y * z597;
    const Scalar z600 = v_x * z597 + v_y * z596 - v_psi * v_s_4;
    result.value[0] = n0;
    result.rate[0] = z568;
    result.gamma[0] = -z571;
    result.value[1] = n0;
    result.rate[1] = -z572;
    result.gamma[1] = -z573;
    result.value[2] = n0;
    result.rate[2] = z577;
    result.gamma[2] = -z580;
    result.value[3] = n0;
    result.rate[3] = -z581;
    result.gamma[3] = -z582;
    result.value[4] = n0;
    result.rate[4] = z586;
    result.gamma[4] = -z589;
    result.value[5] = n0;
    result.rate[5] = -z590;
    result.gamma[5] = -z591;
    result.value[6] = n0;
    result.rate[6] = z595;
    result.gamma[6] = -z598;
    result.value[7] = n0;
    result.rate[7] = -z599;
    result.gamma[7] = -z600;
    result.jacobian[0] = z57;
    result.jacobian[1] = -z56;
    result.jacobian[2] = z82;
    result.jacobian[3] = -z81;
    result.jacobian[4] = z106;
    result.jacobian[5] = -z105;
    result.jacobian[6] = z128;
    result.jacobian[7] = -z127;
    result.jacobian[8] = z56;
    result.jacobian[9] = z57;
    result.jacobian[10] = z81;
    result.jacobian[11] = z82;
    result.jacobian[12] = z105;
    result.jacobian[13] = z106;
    result.jacobian[14] = z127;
    result.jacobian[15] = z128;
    result.jacobian[16] = z566;
    result.jacobian[17] = z567;
    result.jacobian[18] = -z575;
    result.jacobian[19] = z576;
    result.jacobian[20] = -z584;
    result.jacobian[21] = z585;
    result.jacobian[22] = z593;
    result.jacobian[23] = z594;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0_3;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = n0;
    result.jacobian[35] = n0_3;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = n0_3;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0_3;
    result.jacobian[56] = n1;
    result.jacobian[57] = n0;
    result.jacobian[58] = n0;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n1;
    result.jacobian[67] = n0;
    result.jacobian[68] = n0;
    result.jacobian[69] = n0;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n1;
    result.jacobian[77] = n0;
    result.jacobian[78] = n0;
    result.jacobian[79] = n0;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = n0;
    result.jacobian[85] = n0;
    result.jacobian[86] = n1;
    result.jacobian[87] = n0;
  }
};

}  // namespace four_wheel_vehicle_all_wheels
