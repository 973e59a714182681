// SPDX-License-Identifier: MIT
// model_making_press: Model-making press: two columns, a screw and two cups
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               51               85          2             0                  2       0    142     142
//   mass_matrix              16               36          0             0                  0       0     52      52
//   bias                     36               89          0             0                  0       0    125     125
//   inverse_dynamics        122              205          1             0                  1       0    330     330
//   forward_dynamics        311              564          9             0                  1       0    886     934
//   energy                   46               84          2             0                  0       0    132     144
//   constraints             159              284          2             0                  1       0    447     503
//
// Not computed because this mechanism does not need it:
//   kinematics: of 72 results 16 vanish identically, 16 repeat another up to sign
//   mass_matrix: of 81 results 60 vanish identically, 6 repeat another up to sign
//   bias: of 9 results 1 vanish identically
//   forward_dynamics: of 19 results 4 vanish identically
//   constraints: of 120 results 76 vanish identically, 1 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: L2_z, L2_ry, L2_rz, L5_z.
//   Indeterminate, as they are shared with those in a way that no motion tells: lambda_L3_z.
//
// To write this file again:
//   model_making_press_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output model_making_press.hpp
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

namespace model_making_press {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "model_making_press";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x2054a1b55dec1418ULL;
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 10;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 2;
  static constexpr int quaternions[] = {2, 6};
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 4;
  static constexpr int redundant_multipliers[] = {1, 2, 3, 7};

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar a_z;  ///< coordinate [m]
    Scalar a;  ///< coordinate [rad or 1]
    Scalar lower_w;  ///< component of a unit quaternion [1]
    Scalar lower_x;  ///< component of a unit quaternion [1]
    Scalar lower_y;  ///< component of a unit quaternion [1]
    Scalar lower_z;  ///< component of a unit quaternion [1]
    Scalar upper_w;  ///< component of a unit quaternion [1]
    Scalar upper_x;  ///< component of a unit quaternion [1]
    Scalar upper_y;  ///< component of a unit quaternion [1]
    Scalar upper_z;  ///< component of a unit quaternion [1]
    Scalar omega_z;  ///< coordinate [rad or 1]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::a_z, &Coordinates::a, &Coordinates::lower_w,
          &Coordinates::lower_x, &Coordinates::lower_y, &Coordinates::lower_z, &Coordinates::upper_w,
          &Coordinates::upper_x, &Coordinates::upper_y, &Coordinates::upper_z, &Coordinates::omega_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar a_z;  ///< its rate [m/s]
    Scalar a;  ///< its rate [rad/s]
    Scalar lower_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar lower_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar lower_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar omega_z;  ///< its rate [rad/s]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::a_z, &Velocities::a, &Velocities::lower_omega_x,
          &Velocities::lower_omega_y, &Velocities::lower_omega_z, &Velocities::upper_omega_x,
          &Velocities::upper_omega_y, &Velocities::upper_omega_z, &Velocities::omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar a_z;  ///< its second rate [m/s^2]
    Scalar a;  ///< its second rate [rad/s^2]
    Scalar lower_omega_x;  ///< its rate [rad/s^2]
    Scalar lower_omega_y;  ///< its rate [rad/s^2]
    Scalar lower_omega_z;  ///< its rate [rad/s^2]
    Scalar upper_omega_x;  ///< its rate [rad/s^2]
    Scalar upper_omega_y;  ///< its rate [rad/s^2]
    Scalar upper_omega_z;  ///< its rate [rad/s^2]
    Scalar omega_z;  ///< its second rate [rad/s^2]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::a_z, &Accelerations::a,
          &Accelerations::lower_omega_x, &Accelerations::lower_omega_y, &Accelerations::lower_omega_z,
          &Accelerations::upper_omega_x, &Accelerations::upper_omega_y, &Accelerations::upper_omega_z,
          &Accelerations::omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar a_z;  ///< works with the rate of a_z [N]
    Scalar a;  ///< works with the rate of a [N m]
    Scalar lower_omega_x;  ///< works with lower_omega_x [N m]
    Scalar lower_omega_y;  ///< works with lower_omega_y [N m]
    Scalar lower_omega_z;  ///< works with lower_omega_z [N m]
    Scalar upper_omega_x;  ///< works with upper_omega_x [N m]
    Scalar upper_omega_y;  ///< works with upper_omega_y [N m]
    Scalar upper_omega_z;  ///< works with upper_omega_z [N m]
    Scalar omega_z;  ///< works with the rate of omega_z [N m]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::a_z, &GeneralizedForces::a,
          &GeneralizedForces::lower_omega_x, &GeneralizedForces::lower_omega_y, &GeneralizedForces::lower_omega_z,
          &GeneralizedForces::upper_omega_x, &GeneralizedForces::upper_omega_y, &GeneralizedForces::upper_omega_z,
          &GeneralizedForces::omega_z};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C;  ///< motor [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_L2_y;  ///< of the constraint L2_y [N]
    Scalar lambda_L2_z;  ///< indeterminate, of the constraint L2_z [N]
    Scalar lambda_L2_ry;  ///< indeterminate, of the constraint L2_ry [N m]
    Scalar lambda_L2_rz;  ///< indeterminate, of the constraint L2_rz [N m]
    Scalar lambda_L3_z;  ///< indeterminate, of the constraint L3_z [N]
    Scalar lambda_L3_rx;  ///< of the constraint L3_rx [N m]
    Scalar lambda_L3_ry;  ///< of the constraint L3_ry [N m]
    Scalar lambda_L5_z;  ///< indeterminate, of the constraint L5_z [N]
    Scalar lambda_L5_rx;  ///< of the constraint L5_rx [N m]
    Scalar lambda_L5_ry;  ///< of the constraint L5_ry [N m]
    static constexpr int size = 10;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_L2_y, &Multipliers::lambda_L2_z,
          &Multipliers::lambda_L2_ry, &Multipliers::lambda_L2_rz, &Multipliers::lambda_L3_z, &Multipliers::lambda_L3_rx,
          &Multipliers::lambda_L3_ry, &Multipliers::lambda_L5_z, &Multipliers::lambda_L5_rx,
          &Multipliers::lambda_L5_ry};
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.a_z = n0;
    state.q.a = n0;
    state.q.lower_w = n1;
    state.q.lower_x = n0;
    state.q.lower_y = n0;
    state.q.lower_z = n0;
    state.q.upper_w = n1;
    state.q.upper_x = n0;
    state.q.upper_y = n0;
    state.q.upper_z = n0;
    state.q.omega_z = n0;
    state.v.a_z = n0;
    state.v.a = n0;
    state.v.lower_omega_x = n0;
    state.v.lower_omega_y = n0;
    state.v.lower_omega_z = n0;
    state.v.upper_omega_x = n0;
    state.v.upper_omega_y = n0;
    state.v.upper_omega_z = n0;
    state.v.omega_z = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> traverse_position;  ///< centre of mass of traverse [m]
    std::array<Scalar, 9> traverse_rotation;  ///< from the axes of traverse to the ground's (3 x 3)
    std::array<Scalar, 3> traverse_velocity;  ///< velocity of the centre of mass of traverse [m/s]
    std::array<Scalar, 3> traverse_angular_velocity;  ///< angular velocity of traverse [rad/s]
    std::array<Scalar, 3> screw_position;  ///< centre of mass of screw [m]
    std::array<Scalar, 9> screw_rotation;  ///< from the axes of screw to the ground's (3 x 3)
    std::array<Scalar, 3> screw_velocity;  ///< velocity of the centre of mass of screw [m/s]
    std::array<Scalar, 3> screw_angular_velocity;  ///< angular velocity of screw [rad/s]
    std::array<Scalar, 3> lower_cup_position;  ///< centre of mass of lower_cup [m]
    std::array<Scalar, 9> lower_cup_rotation;  ///< from the axes of lower_cup to the ground's (3 x 3)
    std::array<Scalar, 3> lower_cup_velocity;  ///< velocity of the centre of mass of lower_cup [m/s]
    std::array<Scalar, 3> lower_cup_angular_velocity;  ///< angular velocity of lower_cup [rad/s]
    std::array<Scalar, 3> upper_cup_position;  ///< centre of mass of upper_cup [m]
    std::array<Scalar, 9> upper_cup_rotation;  ///< from the axes of upper_cup to the ground's (3 x 3)
    std::array<Scalar, 3> upper_cup_velocity;  ///< velocity of the centre of mass of upper_cup [m/s]
    std::array<Scalar, 3> upper_cup_angular_velocity;  ///< angular velocity of upper_cup [rad/s]
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
    std::array<Scalar, 10> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 10> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 90> jacobian;  ///< A, stored column by column (10 x 9)
    std::array<Scalar, 10> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 11>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_a_z = state.v.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar z351 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w
        * v_lower_omega_y);
    const Scalar z352 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w
        * v_lower_omega_z);
    const Scalar z354 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w
        * v_lower_omega_x);
    const Scalar z355 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z411 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z412 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z414 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z415 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    rates[0] = v_a_z;
    rates[1] = v_a;
    rates[2] = -z355;
    rates[3] = z354;
    rates[4] = z351;
    rates[5] = -z352;
    rates[6] = -z415;
    rates[7] = z414;
    rates[8] = z411;
    rates[9] = -z412;
    rates[10] = v_omega_z;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar angles_[] = {q_a, q_omega_z};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_a = sines_[0], c_a = cosines_[0];
    const Scalar s_omega_z = sines_[1], c_omega_z = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z11 = n2 * q_lower_z * q_lower_z;
    const Scalar z13 = n2 * q_lower_y * q_lower_x;
    const Scalar z15 = n2 * q_lower_z * q_lower_w;
    const Scalar z39 = n2 * q_upper_z * q_upper_z;
    const Scalar z41 = n2 * q_upper_y * q_upper_x;
    const Scalar z43 = n2 * q_upper_z * q_upper_w;
    const Scalar z16 = n1 - z9 - z11;
    const Scalar z18 = z13 + z15;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z44 = n1 - z37 - z39;
    const Scalar z46 = z41 + z43;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z17 = z13 - z15;
    const Scalar z22 = n1 - z11 - z19;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z45 = z41 - z43;
    const Scalar z50 = n1 - z39 - z47;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z28 = z25 - z26;
    const Scalar z29 = z25 + z26;
    const Scalar z56 = z53 - z54;
    const Scalar z57 = z53 + z54;
    const Scalar z23 = z20 - z21;
    const Scalar z24 = z20 + z21;
    const Scalar z51 = z48 - z49;
    const Scalar z52 = z48 + z49;
    const Scalar z71 = s_a * z18 - c_a * z16;
    const Scalar z74 = s_a * z16 + c_a * z18;
    const Scalar z98 = s_a * z46 - c_a * z44;
    const Scalar z101 = s_a * z44 + c_a * z46;
    const Scalar z72 = s_a * z22 - c_a * z17;
    const Scalar z75 = s_a * z17 + c_a * z22;
    const Scalar z87 = v_a + z28 * v_lower_omega_x;  // angular velocity of lower_omega_x, z
    const Scalar z99 = s_a * z50 - c_a * z45;
    const Scalar z102 = s_a * z45 + c_a * z50;
    const Scalar z110 = v_a + z56 * v_upper_omega_x;  // angular velocity of upper_omega_x, z
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z73 = s_a * z23 - c_a * z29;
    const Scalar z76 = s_a * z29 + c_a * z23;
    const Scalar z93 = z24 * v_lower_omega_y + z87;  // angular velocity of lower_omega_y, z
    const Scalar z100 = s_a * z51 - c_a * z57;
    const Scalar z103 = s_a * z57 + c_a * z51;
    const Scalar z114 = z52 * v_upper_omega_y + z110;  // angular velocity of upper_omega_y, z
    const Scalar z85 = v_lower_omega_x * z71;  // angular velocity of lower_omega_x, x
    const Scalar z86 = v_lower_omega_x * z74;  // angular velocity of lower_omega_x, y
    const Scalar z108 = v_upper_omega_x * z98;  // angular velocity of upper_omega_x, x
    const Scalar z109 = v_upper_omega_x * z101;  // angular velocity of upper_omega_x, y
    const Scalar z77 = n0_1 * c_a;
    const Scalar z80 = n0_1 * v_a;
    const Scalar z91 = v_lower_omega_y * z72 + z85;  // angular velocity of lower_omega_y, x
    const Scalar z92 = v_lower_omega_y * z75 + z86;  // angular velocity of lower_omega_y, y
    const Scalar z112 = v_upper_omega_y * z99 + z108;  // angular velocity of upper_omega_y, x
    const Scalar z113 = v_upper_omega_y * z102 + z109;  // angular velocity of upper_omega_y, y
    const Scalar z78 = n0_1 * s_a;
    const Scalar z79 = n0_1 - z77;  // place of lower_omega_x, x
    const Scalar z88 = s_a * z80;  // velocity of lower_omega_x, x
    const Scalar z89 = c_a * z80;  // velocity of lower_omega_x, y
    const Scalar z95 = v_lower_omega_z * z73 + z91;  // angular velocity of lower_cup, x
    const Scalar z96 = v_lower_omega_z * z76 + z92;  // angular velocity of lower_cup, y
    const Scalar z97 = z27 * v_lower_omega_z + z93;  // angular velocity of lower_cup, z
    const Scalar z116 = v_upper_omega_z * z100 + z112;  // angular velocity of upper_cup, x
    const Scalar z117 = v_upper_omega_z * z103 + z113;  // angular velocity of upper_cup, y
    const Scalar z118 = z55 * v_upper_omega_z + z114;  // angular velocity of upper_cup, z
    const Scalar z119 = n0_002 * q_omega_z / pi;
    const Scalar z120 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    result.traverse_position[0] = -z79;
    result.traverse_position[1] = z78;
    result.traverse_position[2] = q_a_z;
    result.traverse_rotation[0] = c_a;
    result.traverse_rotation[1] = s_a;
    result.traverse_rotation[2] = n0;
    result.traverse_rotation[3] = -s_a;
    result.traverse_rotation[4] = c_a;
    result.traverse_rotation[5] = n0;
    result.traverse_rotation[6] = n0;
    result.traverse_rotation[7] = n0;
    result.traverse_rotation[8] = n1;
    result.traverse_velocity[0] = -z88;
    result.traverse_velocity[1] = z89;
    result.traverse_velocity[2] = v_a_z;
    result.traverse_angular_velocity[0] = n0;
    result.traverse_angular_velocity[1] = n0;
    result.traverse_angular_velocity[2] = v_a;
    result.screw_position[0] = n0;
    result.screw_position[1] = n0;
    result.screw_position[2] = z119;
    result.screw_rotation[0] = c_omega_z;
    result.screw_rotation[1] = s_omega_z;
    result.screw_rotation[2] = n0;
    result.screw_rotation[3] = -s_omega_z;
    result.screw_rotation[4] = c_omega_z;
    result.screw_rotation[5] = n0;
    result.screw_rotation[6] = n0;
    result.screw_rotation[7] = n0;
    result.screw_rotation[8] = n1;
    result.screw_velocity[0] = n0;
    result.screw_velocity[1] = n0;
    result.screw_velocity[2] = z120;
    result.screw_angular_velocity[0] = n0;
    result.screw_angular_velocity[1] = n0;
    result.screw_angular_velocity[2] = v_omega_z;
    result.lower_cup_position[0] = -z79;
    result.lower_cup_position[1] = z78;
    result.lower_cup_position[2] = q_a_z;
    result.lower_cup_rotation[0] = -z71;
    result.lower_cup_rotation[1] = z74;
    result.lower_cup_rotation[2] = z28;
    result.lower_cup_rotation[3] = -z72;
    result.lower_cup_rotation[4] = z75;
    result.lower_cup_rotation[5] = z24;
    result.lower_cup_rotation[6] = -z73;
    result.lower_cup_rotation[7] = z76;
    result.lower_cup_rotation[8] = z27;
    result.lower_cup_velocity[0] = -z88;
    result.lower_cup_velocity[1] = z89;
    result.lower_cup_velocity[2] = v_a_z;
    result.lower_cup_angular_velocity[0] = -z95;
    result.lower_cup_angular_velocity[1] = z96;
    result.lower_cup_angular_velocity[2] = z97;
    result.upper_cup_position[0] = -z79;
    result.upper_cup_position[1] = z78;
    result.upper_cup_position[2] = q_a_z;
    result.upper_cup_rotation[0] = -z98;
    result.upper_cup_rotation[1] = z101;
    result.upper_cup_rotation[2] = z56;
    result.upper_cup_rotation[3] = -z99;
    result.upper_cup_rotation[4] = z102;
    result.upper_cup_rotation[5] = z52;
    result.upper_cup_rotation[6] = -z100;
    result.upper_cup_rotation[7] = z103;
    result.upper_cup_rotation[8] = z55;
    result.upper_cup_velocity[0] = -z88;
    result.upper_cup_velocity[1] = z89;
    result.upper_cup_velocity[2] = v_a_z;
    result.upper_cup_angular_velocity[0] = -z116;
    result.upper_cup_angular_velocity[1] = z117;
    result.upper_cup_angular_velocity[2] = z118;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 81>& mass) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k5 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar pi = traits::pi();
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z192 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z68;
    });
    const Scalar z193 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z68 * z192;
    });
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z52 = z48 + z49;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z24 = z20 + z21;
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z128 = k5 * z52;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z123 = k5 * z55;
    const Scalar z156 = k5 * z24;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z56 = z53 - z54;
    const Scalar z151 = k5 * z27;
    const Scalar z28 = z25 - z26;
    const Scalar z133 = k5 * z56;
    const Scalar z161 = k5 * z28;
    const Scalar z144 = z52 * z128 + z55 * z123 + z56 * z133;
    const Scalar z172 = z24 * z156 + z27 * z151 + z28 * z161;
    const Scalar z146 = n0_0002 + z144;
    const Scalar z174 = n0_0002 + z172;
    const Scalar z148 = n0_01 + z146;
    const Scalar z180 = z148 + z174;
    mass[0] = n0_84;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = z180;
    mass[11] = z161;
    mass[12] = z156;
    mass[13] = z151;
    mass[14] = z133;
    mass[15] = z128;
    mass[16] = z123;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = z161;
    mass[20] = k5;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = z156;
    mass[29] = n0;
    mass[30] = k5;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = z151;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k5;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = z133;
    mass[47] = n0;
    mass[48] = n0;
    mass[49] = n0;
    mass[50] = k5;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = z128;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = k5;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = z123;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = k5;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = n0;
    mass[78] = n0;
    mass[79] = n0;
    mass[80] = z193;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar k9 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar pi = traits::pi();
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z13 = n2 * q_lower_y * q_lower_x;
    const Scalar z15 = n2 * q_lower_z * q_lower_w;
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z41 = n2 * q_upper_y * q_upper_x;
    const Scalar z43 = n2 * q_upper_z * q_upper_w;
    const Scalar z197 = v_a * v_a;
    const Scalar z17 = z13 - z15;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z45 = z41 - z43;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z198 = n0_1 * z197;
    const Scalar z24 = z20 + z21;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z52 = z48 + z49;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z11 = n2 * q_lower_z * q_lower_z;
    const Scalar z39 = n2 * q_upper_z * q_upper_z;
    const Scalar z29 = z25 + z26;
    const Scalar z57 = z53 + z54;
    const Scalar z16 = n1 - z9 - z11;
    const Scalar z44 = n1 - z37 - z39;
    const Scalar z200 = z17 * z198 - n9_81 * z24;
    const Scalar z209 = z45 * z198 - n9_81 * z52;
    const Scalar z28 = z25 - z26;
    const Scalar z56 = z53 - z54;
    const Scalar z201 = n9_81 * z27 - z29 * z198;
    const Scalar z210 = n9_81 * z55 - z57 * z198;
    const Scalar z218 = n0_02 * z209;  // force on upper_cup, y
    const Scalar z230 = n0_02 * z200;  // force on lower_cup, y
    const Scalar z219 = n0_02 * z210;  // force on upper_cup, z
    const Scalar z231 = n0_02 * z201;  // force on lower_cup, z
    const Scalar z199 = z16 * z198 - n9_81 * z28;
    const Scalar z208 = z44 * z198 - n9_81 * z56;
    const Scalar z217 = n0_02 * z208;  // force on upper_cup, x
    const Scalar z229 = n0_02 * z199;  // force on lower_cup, x
    const Scalar z82 = v_a * z24;
    const Scalar z83 = v_a * z27;
    const Scalar z105 = v_a * z52;
    const Scalar z106 = v_a * z55;
    const Scalar z225 = z52 * z218 - z55 * z219 + z56 * z217;
    const Scalar z237 = z24 * z230 - z27 * z231 + z28 * z229;
    const Scalar z81 = v_a * z28;
    const Scalar z104 = v_a * z56;
    const Scalar z202 = v_lower_omega_x * z83;  // angular acceleration of lower_omega_x, y
    const Scalar z203 = v_lower_omega_x * z82;  // angular acceleration of lower_omega_x, z
    const Scalar z204 = v_lower_omega_y * z83;  // angular acceleration of lower_omega_y, x
    const Scalar z211 = v_upper_omega_x * z106;  // angular acceleration of upper_omega_x, y
    const Scalar z212 = v_upper_omega_x * z105;  // angular acceleration of upper_omega_x, z
    const Scalar z213 = v_upper_omega_y * z106;  // angular acceleration of upper_omega_y, x
    const Scalar z243 = z225 + z237;  // force on ring_A, z
    const Scalar z195 = n0_0005 * v_omega_z;
    const Scalar z194 = n20000 * q_a_z;
    const Scalar z205 = v_lower_omega_y * z81 - z203;  // angular acceleration of lower_omega_y, z
    const Scalar z206 = v_lower_omega_z * z82 - z204;  // angular acceleration of lower_cup, x
    const Scalar z207 = v_lower_omega_z * z81 - z202;  // angular acceleration of lower_cup, y
    const Scalar z214 = v_upper_omega_y * z104 - z212;  // angular acceleration of upper_omega_y, z
    const Scalar z215 = v_upper_omega_z * z105 - z213;  // angular acceleration of upper_cup, x
    const Scalar z216 = v_upper_omega_z * z104 - z211;  // angular acceleration of upper_cup, y
    const Scalar z251 = n7_848 - z243;  // force on ring_A.1, z
    const Scalar z220 = k9 * z215;  // moment on upper_cup, x
    const Scalar z221 = k9 * z216;  // moment on upper_cup, y
    const Scalar z222 = k9 * z214;  // moment on upper_cup, z
    const Scalar z232 = k9 * z206;  // moment on lower_cup, x
    const Scalar z233 = k9 * z207;  // moment on lower_cup, y
    const Scalar z234 = k9 * z205;  // moment on lower_cup, z
    const Scalar z252 = z194 + z251;
    const Scalar z253 = n2_943 * z68 + z195;
    forces.a_z = z252;
    forces.a = n0;
    forces.lower_omega_x = z232;
    forces.lower_omega_y = -z233;
    forces.lower_omega_z = z234;
    forces.upper_omega_x = z220;
    forces.upper_omega_y = -z221;
    forces.upper_omega_z = z222;
    forces.omega_z = z253;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k6 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar q_a_z = state.q.a_z;
    const Scalar a_a_z = accelerations.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar a_a = accelerations.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar a_lower_omega_x = accelerations.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar a_lower_omega_y = accelerations.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar a_lower_omega_z = accelerations.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar a_upper_omega_x = accelerations.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar a_upper_omega_y = accelerations.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar a_upper_omega_z = accelerations.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar a_omega_z = accelerations.omega_z;
    const Scalar l_lambda_L2_y = multipliers.lambda_L2_y;
    const Scalar l_lambda_L2_z = multipliers.lambda_L2_z;
    const Scalar l_lambda_L3_z = multipliers.lambda_L3_z;
    const Scalar l_lambda_L3_rx = multipliers.lambda_L3_rx;
    const Scalar l_lambda_L3_ry = multipliers.lambda_L3_ry;
    const Scalar l_lambda_L5_z = multipliers.lambda_L5_z;
    const Scalar l_lambda_L5_rx = multipliers.lambda_L5_rx;
    const Scalar l_lambda_L5_ry = multipliers.lambda_L5_ry;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z192 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z68;
    });
    const Scalar z193 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z68 * z192;
    });
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z13 = n2 * q_lower_y * q_lower_x;
    const Scalar z15 = n2 * q_lower_z * q_lower_w;
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z41 = n2 * q_upper_y * q_upper_x;
    const Scalar z43 = n2 * q_upper_z * q_upper_w;
    const Scalar z197 = v_a * v_a;
    const Scalar z17 = z13 - z15;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z45 = z41 - z43;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z198 = n0_1 * z197;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z24 = z20 + z21;
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z52 = z48 + z49;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z11 = n2 * q_lower_z * q_lower_z;
    const Scalar z28 = z25 - z26;
    const Scalar z39 = n2 * q_upper_z * q_upper_z;
    const Scalar z29 = z25 + z26;
    const Scalar z57 = z53 + z54;
    const Scalar z16 = n1 - z9 - z11;
    const Scalar z44 = n1 - z37 - z39;
    const Scalar z161 = k6 * z28;
    const Scalar z200 = z17 * z198 - n9_81 * z24;
    const Scalar z209 = z45 * z198 - n9_81 * z52;
    const Scalar z56 = z53 - z54;
    const Scalar z128 = k6 * z52;
    const Scalar z156 = k6 * z24;
    const Scalar z23 = z20 - z21;
    const Scalar z201 = n9_81 * z27 - z29 * z198;
    const Scalar z51 = z48 - z49;
    const Scalar z210 = n9_81 * z55 - z57 * z198;
    const Scalar z218 = n0_02 * z209;  // force on upper_cup, y
    const Scalar z230 = n0_02 * z200;  // force on lower_cup, y
    const Scalar z219 = n0_02 * z210;  // force on upper_cup, z
    const Scalar z231 = n0_02 * z201;  // force on lower_cup, z
    const Scalar z199 = z16 * z198 - n9_81 * z28;
    const Scalar z208 = z44 * z198 - n9_81 * z56;
    const Scalar z123 = k6 * z55;
    const Scalar z217 = n0_02 * z208;  // force on upper_cup, x
    const Scalar z229 = n0_02 * z199;  // force on lower_cup, x
    const Scalar z237 = z24 * z230 - z27 * z231 + z28 * z229;
    const Scalar z133 = k6 * z56;
    const Scalar z82 = v_a * z24;
    const Scalar z225 = z52 * z218 - z55 * z219 + z56 * z217;
    const Scalar z83 = v_a * z27;
    const Scalar z105 = v_a * z52;
    const Scalar z243 = z225 + z237;  // force on ring_A, z
    const Scalar z106 = v_a * z55;
    const Scalar z151 = k6 * z27;
    const Scalar z81 = v_a * z28;
    const Scalar z251 = n7_848 - z243;  // force on ring_A.1, z
    const Scalar z104 = v_a * z56;
    const Scalar z202 = v_lower_omega_x * z83;  // angular acceleration of lower_omega_x, y
    const Scalar z204 = v_lower_omega_y * z83;  // angular acceleration of lower_omega_y, x
    const Scalar z206 = v_lower_omega_z * z82 - z204;  // angular acceleration of lower_cup, x
    const Scalar z203 = v_lower_omega_x * z82;  // angular acceleration of lower_omega_x, z
    const Scalar z205 = v_lower_omega_y * z81 - z203;  // angular acceleration of lower_omega_y, z
    const Scalar z207 = v_lower_omega_z * z81 - z202;  // angular acceleration of lower_cup, y
    const Scalar z233 = k6 * z207;  // moment on lower_cup, y
    const Scalar z232 = k6 * z206;  // moment on lower_cup, x
    const Scalar z211 = v_upper_omega_x * z106;  // angular acceleration of upper_omega_x, y
    const Scalar z213 = v_upper_omega_y * z106;  // angular acceleration of upper_omega_y, x
    const Scalar z215 = v_upper_omega_z * z105 - z213;  // angular acceleration of upper_cup, x
    const Scalar z212 = v_upper_omega_x * z105;  // angular acceleration of upper_omega_x, z
    const Scalar z214 = v_upper_omega_y * z104 - z212;  // angular acceleration of upper_omega_y, z
    const Scalar z216 = v_upper_omega_z * z104 - z211;  // angular acceleration of upper_cup, y
    const Scalar z221 = k6 * z216;  // moment on upper_cup, y
    const Scalar z220 = k6 * z215;  // moment on upper_cup, x
    const Scalar z234 = k6 * z205;  // moment on lower_cup, z
    const Scalar z119 = n0_002 * q_omega_z / pi;
    const Scalar z222 = k6 * z214;  // moment on upper_cup, z
    const Scalar z144 = z52 * z128 + z55 * z123 + z56 * z133;
    const Scalar z146 = n0_0002 + z144;
    const Scalar z172 = z24 * z156 + z27 * z151 + z28 * z161;
    const Scalar z148 = n0_01 + z146;
    const Scalar z174 = n0_0002 + z172;
    const Scalar z78 = n0_1 * s_a;
    const Scalar z195 = n0_0005 * v_omega_z;
    const Scalar z77 = n0_1 * c_a;
    const Scalar z253 = n2_943 * z68 + z195;
    const Scalar z180 = z148 + z174;
    const Scalar z194 = n20000 * q_a_z;
    const Scalar z252 = z194 + z251;
    const Scalar z79 = n0_1 - z77;  // place of lower_omega_x, x
    const Scalar z368 = z23 * z77 + z29 * z78;
    const Scalar z425 = z51 * z77 + z57 * z78;
    const Scalar z326 = n0_84 * a_a_z + z252;
    const Scalar z327 = a_lower_omega_x * z161 + a_lower_omega_y * z156 + a_upper_omega_x * z133 + a_upper_omega_y
        * z128 + a_lower_omega_z * z151 + a_upper_omega_z * z123 + a_a * z180;
    const Scalar z328 = z232 + k6 * a_lower_omega_x + a_a * z161;
    const Scalar z329 = k6 * a_lower_omega_y - z233 + a_a * z156;
    const Scalar z347 = q_a_z - z119;
    const Scalar z369 = q_lower_y * q_lower_y - q_lower_z * q_lower_z;
    const Scalar z370 = q_lower_x * q_lower_x - q_lower_w * q_lower_w;
    const Scalar z330 = z234 + k6 * a_lower_omega_z + a_a * z151;
    const Scalar z375 = q_lower_y * q_lower_x + q_lower_z * q_lower_w;
    const Scalar z426 = q_upper_y * q_upper_y - q_upper_z * q_upper_z;
    const Scalar z331 = z220 + k6 * a_upper_omega_x + a_a * z133;
    const Scalar z427 = q_upper_x * q_upper_x - q_upper_w * q_upper_w;
    const Scalar z432 = q_upper_y * q_upper_x + q_upper_z * q_upper_w;
    const Scalar z332 = k6 * a_upper_omega_y - z221 + a_a * z128;
    const Scalar z371 = z369 - z370;
    const Scalar z376 = n2 * z375;
    const Scalar z428 = z426 - z427;
    const Scalar z333 = z222 + k6 * a_upper_omega_z + a_a * z123;
    const Scalar z433 = n2 * z432;
    const Scalar z372 = q_lower_y * q_lower_x - q_lower_z * q_lower_w;
    const Scalar z377 = q_lower_z * q_lower_z - q_lower_x * q_lower_x;
    const Scalar z401 = z369 + z370;
    const Scalar z378 = q_lower_y * q_lower_y - q_lower_w * q_lower_w;
    const Scalar z429 = q_upper_y * q_upper_x - q_upper_z * q_upper_w;
    const Scalar z456 = z426 + z427;
    const Scalar z434 = q_upper_z * q_upper_z - q_upper_x * q_upper_x;
    const Scalar z435 = q_upper_y * q_upper_y - q_upper_w * q_upper_w;
    const Scalar z334 = a_omega_z * z193 + z253;
    const Scalar z373 = n2 * z372;
    const Scalar z379 = z377 + z378;
    const Scalar z374 = z24 * z347 + z78 * z371 + z79 * z373;
    const Scalar z430 = n2 * z429;
    const Scalar z436 = z434 + z435;
    const Scalar z381 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z382 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z380 = z28 * z347 + z78 * z376 - z79 * z379;
    const Scalar z438 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z439 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z335 = n0_2 * c_a;
    const Scalar z336 = n0_2 * s_a;
    const Scalar z383 = z27 * z68;
    const Scalar z402 = n2 * z381;
    const Scalar z405 = z377 - z378;
    const Scalar z406 = n2 * z382;
    const Scalar z431 = z52 * z347 + z78 * z428 + z79 * z430;
    const Scalar z437 = z56 * z347 + z78 * z433 - z79 * z436;
    const Scalar z440 = z55 * z68;
    const Scalar z457 = n2 * z438;
    const Scalar z460 = z434 - z435;
    const Scalar z461 = n2 * z439;
    forces.a_z = z326 + z27 * l_lambda_L3_z + z55 * l_lambda_L5_z;
    forces.a = z327 - z335 * l_lambda_L2_y - z336 * l_lambda_L2_z + z368 * l_lambda_L3_z + z425 * l_lambda_L5_z;
    forces.lower_omega_x = z328 - z401 * l_lambda_L3_rx - z374 * l_lambda_L3_z;
    forces.lower_omega_y = z405 * l_lambda_L3_ry + z329 + z380 * l_lambda_L3_z;
    forces.lower_omega_z = z330 + z402 * l_lambda_L3_rx - z406 * l_lambda_L3_ry;
    forces.upper_omega_x = z331 - z456 * l_lambda_L5_rx - z431 * l_lambda_L5_z;
    forces.upper_omega_y = z460 * l_lambda_L5_ry + z332 + z437 * l_lambda_L5_z;
    forces.upper_omega_z = z333 + z457 * l_lambda_L5_rx - z461 * l_lambda_L5_ry;
    forces.omega_z = z334 - z383 * l_lambda_L3_z - z440 * l_lambda_L5_z;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k5 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n100000 = traits::constant(1e+05, 1e+05f, "100000/1");
    const Scalar n25_over_21 = traits::constant(1.1904761904761905, 1.1904762f, "25/21");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z192 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z68;
    });
    const Scalar z193 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z68 * z192;
    });
    const Scalar z474 = traits::formula(9987.856223025203, 9987.856f, [&]() -> Scalar {
      return n1 / z193;
    });
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z52 = z48 + z49;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z24 = z20 + z21;
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z128 = k5 * z52;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z123 = k5 * z55;
    const Scalar z156 = k5 * z24;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z56 = z53 - z54;
    const Scalar z151 = k5 * z27;
    const Scalar z28 = z25 - z26;
    const Scalar z133 = k5 * z56;
    const Scalar z119 = n0_002 * q_omega_z / pi;
    const Scalar z23 = z20 - z21;
    const Scalar z161 = k5 * z28;
    const Scalar z29 = z25 + z26;
    const Scalar z144 = z52 * z128 + z55 * z123 + z56 * z133;
    const Scalar z57 = z53 + z54;
    const Scalar z146 = n0_0002 + z144;
    const Scalar z172 = z24 * z156 + z27 * z151 + z28 * z161;
    const Scalar z148 = n0_01 + z146;
    const Scalar z174 = n0_0002 + z172;
    const Scalar z78 = n0_1 * s_a;
    const Scalar z77 = n0_1 * c_a;
    const Scalar z13 = n2 * q_lower_y * q_lower_x;
    const Scalar z180 = z148 + z174;
    const Scalar z15 = n2 * q_lower_z * q_lower_w;
    const Scalar z17 = z13 - z15;
    const Scalar z41 = n2 * q_upper_y * q_upper_x;
    const Scalar z43 = n2 * q_upper_z * q_upper_w;
    const Scalar z45 = z41 - z43;
    const Scalar z197 = v_a * v_a;
    const Scalar z198 = n0_1 * z197;
    const Scalar z11 = n2 * q_lower_z * q_lower_z;
    const Scalar z16 = n1 - z9 - z11;
    const Scalar z39 = n2 * q_upper_z * q_upper_z;
    const Scalar z44 = n1 - z37 - z39;
    const Scalar z200 = z17 * z198 - n9_81 * z24;
    const Scalar z209 = z45 * z198 - n9_81 * z52;
    const Scalar z210 = n9_81 * z55 - z57 * z198;
    const Scalar z219 = n0_02 * z210;  // force on upper_cup, z
    const Scalar z199 = z16 * z198 - n9_81 * z28;
    const Scalar z218 = n0_02 * z209;  // force on upper_cup, y
    const Scalar z230 = n0_02 * z200;  // force on lower_cup, y
    const Scalar z208 = z44 * z198 - n9_81 * z56;
    const Scalar z201 = n9_81 * z27 - z29 * z198;
    const Scalar z231 = n0_02 * z201;  // force on lower_cup, z
    const Scalar z217 = n0_02 * z208;  // force on upper_cup, x
    const Scalar z229 = n0_02 * z199;  // force on lower_cup, x
    const Scalar z225 = z52 * z218 - z55 * z219 + z56 * z217;
    const Scalar z237 = z24 * z230 - z27 * z231 + z28 * z229;
    const Scalar z105 = v_a * z52;
    const Scalar z106 = v_a * z55;
    const Scalar z104 = v_a * z56;
    const Scalar z79 = n0_1 - z77;  // place of lower_omega_x, x
    const Scalar z83 = v_a * z27;
    const Scalar z82 = v_a * z24;
    const Scalar z204 = v_lower_omega_y * z83;  // angular acceleration of lower_omega_y, x
    const Scalar z202 = v_lower_omega_x * z83;  // angular acceleration of lower_omega_x, y
    const Scalar z194 = n20000 * q_a_z;
    const Scalar z243 = z225 + z237;  // force on ring_A, z
    const Scalar z81 = v_a * z28;
    const Scalar z347 = q_a_z - z119;
    const Scalar z206 = v_lower_omega_z * z82 - z204;  // angular acceleration of lower_cup, x
    const Scalar z203 = v_lower_omega_x * z82;  // angular acceleration of lower_omega_x, z
    const Scalar z251 = n7_848 - z243;  // force on ring_A.1, z
    const Scalar z207 = v_lower_omega_z * z81 - z202;  // angular acceleration of lower_cup, y
    const Scalar z205 = v_lower_omega_y * z81 - z203;  // angular acceleration of lower_omega_y, z
    const Scalar z232 = k5 * z206;  // moment on lower_cup, x
    const Scalar z252 = z194 + z251;
    const Scalar z233 = k5 * z207;  // moment on lower_cup, y
    const Scalar z234 = k5 * z205;  // moment on lower_cup, z
    const Scalar z335 = n0_2 * c_a;
    const Scalar z120 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z362 = v_a_z - z120;
    const Scalar z351 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w
        * v_lower_omega_y);
    const Scalar z354 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w
        * v_lower_omega_x);
    const Scalar z352 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w
        * v_lower_omega_z);
    const Scalar z355 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z341 = v_a * s_a;
    const Scalar z359 = n4 * q_lower_y * z351;
    const Scalar z360 = n4 * q_lower_x * z354;
    const Scalar z361 = z359 + z360;
    const Scalar z212 = v_upper_omega_x * z105;  // angular acceleration of upper_omega_x, z
    const Scalar z214 = v_upper_omega_y * z104 - z212;  // angular acceleration of upper_omega_y, z
    const Scalar z213 = v_upper_omega_y * z106;  // angular acceleration of upper_omega_y, x
    const Scalar z215 = v_upper_omega_z * z105 - z213;  // angular acceleration of upper_cup, x
    const Scalar z211 = v_upper_omega_x * z106;  // angular acceleration of upper_omega_x, y
    const Scalar z216 = v_upper_omega_z * z104 - z211;  // angular acceleration of upper_cup, y
    const Scalar z222 = k5 * z214;  // moment on upper_cup, z
    const Scalar z339 = v_a * c_a;
    const Scalar z342 = v_a * z341;
    const Scalar z220 = k5 * z215;  // moment on upper_cup, x
    const Scalar z353 = n2 * (q_lower_y * z352 - q_lower_z * z351);
    const Scalar z221 = k5 * z216;  // moment on upper_cup, y
    const Scalar z356 = n2 * (q_lower_x * z355 - q_lower_w * z354);
    const Scalar z357 = z353 - z356;
    const Scalar z195 = n0_0005 * v_omega_z;
    const Scalar z368 = z23 * z77 + z29 * z78;
    const Scalar z253 = n2_943 * z68 + z195;
    const Scalar z366 = n0_1 * z341;
    const Scalar z377 = q_lower_z * q_lower_z - q_lower_x * q_lower_x;
    const Scalar z378 = q_lower_y * q_lower_y - q_lower_w * q_lower_w;
    const Scalar z382 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z406 = n2 * z382;
    const Scalar z405 = z377 - z378;
    const Scalar z379 = z377 + z378;
    const Scalar z369 = q_lower_y * q_lower_y - q_lower_z * q_lower_z;
    const Scalar z370 = q_lower_x * q_lower_x - q_lower_w * q_lower_w;
    const Scalar z381 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z402 = n2 * z381;
    const Scalar z401 = z369 + z370;
    const Scalar z371 = z369 - z370;
    const Scalar z372 = q_lower_y * q_lower_x - q_lower_z * q_lower_w;
    const Scalar z373 = n2 * z372;
    const Scalar z375 = q_lower_y * q_lower_x + q_lower_z * q_lower_w;
    const Scalar z376 = n2 * z375;
    const Scalar z383 = z27 * z68;
    const Scalar z374 = z24 * z347 + z78 * z371 + z79 * z373;
    const Scalar z380 = z28 * z347 + z78 * z376 - z79 * z379;
    const Scalar z386 = n0_5 * (v_lower_omega_x * z351 - v_lower_omega_y * z354 + v_lower_omega_z * z355);
    const Scalar z389 = n0_5 * (v_lower_omega_x * z354 + v_lower_omega_y * z351 - v_lower_omega_z * z352);
    const Scalar z387 = n0_5 * (v_lower_omega_x * z352 + v_lower_omega_y * z355 + v_lower_omega_z * z354);
    const Scalar z390 = n0_5 * (v_lower_omega_x * z355 - v_lower_omega_y * z352 - v_lower_omega_z * z351);
    const Scalar z411 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z414 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z412 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z388 = n4 * z351 * z352 + n2 * (q_lower_y * z386 + q_lower_z * z387);
    const Scalar z393 = n4 * z352 * z354 + n2 * (q_lower_z * z390 + q_lower_x * z386);
    const Scalar z363 = n2 * (q_lower_z * z354 - q_lower_x * z352);
    const Scalar z391 = n4 * z354 * z355 + n2 * (q_lower_x * z389 + q_lower_w * z390);
    const Scalar z397 = n4 * (q_lower_x * z390 - z354 * z354);
    const Scalar z394 = n4 * z351 * z355 + n2 * (q_lower_y * z389 + q_lower_w * z387);
    const Scalar z396 = n4 * (q_lower_y * z387 - z351 * z351);
    const Scalar z398 = z396 + z397;
    const Scalar z364 = n2 * (q_lower_y * z355 - q_lower_w * z351);
    const Scalar z365 = z363 - z364;
    const Scalar z392 = z388 - z391;
    const Scalar z403 = z388 + z391;
    const Scalar z395 = z393 + z394;
    const Scalar z407 = z393 - z394;
    const Scalar z358 = n0_1 * z339;
    const Scalar z345 = v_a * z339;
    const Scalar z385 = n0_1 * z345;
    const Scalar z384 = n0_1 * z342;
    const Scalar z343 = n0_2 * z342;
    const Scalar z473 = u_C - z253;
    const Scalar z475 = n100000 * z123;
    const Scalar z476 = z123 * z475 - z180;
    const Scalar z399 = z78 * z392 - z347 * z398 + z79 * z395 + z23 * z384 - z29 * z385 + n2 * (z361 * z362 + z357
        * z358 - z365 * z366);
    const Scalar z477 = n100000 * z128;
    const Scalar z478 = z128 * z477 + z476;
    const Scalar z479 = n100000 * z133;
    const Scalar z481 = n100000 * z151;
    const Scalar z483 = n100000 * z156;
    const Scalar z485 = n100000 * z161;
    const Scalar z434 = q_upper_z * q_upper_z - q_upper_x * q_upper_x;
    const Scalar z480 = z133 * z479 + z478;
    const Scalar z435 = q_upper_y * q_upper_y - q_upper_w * q_upper_w;
    const Scalar z460 = z434 - z435;
    const Scalar z439 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z482 = z151 * z481 + z480;
    const Scalar z461 = n2 * z439;
    const Scalar z426 = q_upper_y * q_upper_y - q_upper_z * q_upper_z;
    const Scalar z484 = z156 * z483 + z482;
    const Scalar z427 = q_upper_x * q_upper_x - q_upper_w * q_upper_w;
    const Scalar z456 = z426 + z427;
    const Scalar z438 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z486 = z161 * z485 + z484;
    const Scalar z457 = n2 * z438;
    const Scalar z505 = z401 * z485 - z402 * z481;
    const Scalar z496 = n25_over_21 * z27;
    const Scalar z487 = n1 / z486;
    const Scalar z495 = z368 + z374 * z485 - z380 * z483;
    const Scalar z504 = z383 * z474;
    const Scalar z415 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z513 = z405 * z483 - z406 * z481;
    const Scalar z441 = n0_5 * (v_upper_omega_x * z411 - v_upper_omega_y * z414 + v_upper_omega_z * z415);
    const Scalar z444 = n0_5 * (v_upper_omega_x * z414 + v_upper_omega_y * z411 - v_upper_omega_z * z412);
    const Scalar z514 = z487 * z513;
    const Scalar z506 = z487 * z505;
    const Scalar z497 = z487 * z495;
    const Scalar z488 = z335 * z487;
    const Scalar z445 = n0_5 * (v_upper_omega_x * z415 - v_upper_omega_y * z412 - v_upper_omega_z * z411);
    const Scalar z518 = z479 * z514;
    const Scalar z519 = z477 * z514;
    const Scalar z516 = n100000 * z405 - z483 * z514;
    const Scalar z520 = z475 * z514;
    const Scalar z517 = n100000 * z406 + z481 * z514;
    const Scalar z508 = z483 * z506;
    const Scalar z510 = z479 * z506;
    const Scalar z511 = z477 * z506;
    const Scalar z507 = n100000 * z401 - z485 * z506;
    const Scalar z509 = n100000 * z402 + z481 * z506;
    const Scalar z512 = z475 * z506;
    const Scalar z499 = n100000 * z380 + z483 * z497;
    const Scalar z500 = z481 * z497;
    const Scalar z501 = z479 * z497;
    const Scalar z502 = z477 * z497;
    const Scalar z498 = n100000 * z374 - z485 * z497;
    const Scalar z503 = z475 * z497;
    const Scalar z489 = z485 * z488;
    const Scalar z490 = z483 * z488;
    const Scalar z492 = z479 * z488;
    const Scalar z493 = z477 * z488;
    const Scalar z491 = z481 * z488;
    const Scalar z494 = z475 * z488;
    const Scalar z442 = n0_5 * (v_upper_omega_x * z412 + v_upper_omega_y * z415 + v_upper_omega_z * z414);
    const Scalar z521 = z456 * z479 - z457 * z475;
    const Scalar z443 = n4 * z411 * z412 + n2 * (q_upper_y * z441 + q_upper_z * z442);
    const Scalar z448 = n4 * z412 * z414 + n2 * (q_upper_z * z445 + q_upper_x * z441);
    const Scalar z446 = n4 * z414 * z415 + n2 * (q_upper_x * z444 + q_upper_w * z445);
    const Scalar z449 = n4 * z411 * z415 + n2 * (q_upper_y * z444 + q_upper_w * z442);
    const Scalar z458 = z443 + z446;
    const Scalar z462 = z448 - z449;
    const Scalar z522 = z487 * z521;
    const Scalar z537 = z335 * z488;
    const Scalar z529 = z460 * z477 - z461 * z475;
    const Scalar z530 = z487 * z529;
    const Scalar z527 = z477 * z522;
    const Scalar z526 = n100000 * z456 - z479 * z522;
    const Scalar z528 = n100000 * z457 + z475 * z522;
    const Scalar z535 = n100000 * z460 - z477 * z530;
    const Scalar z536 = n100000 * z461 + z475 * z530;
    const Scalar z534 = z479 * z530;
    const Scalar z557 = z460 * z535 + z461 * z536;
    const Scalar z556 = z460 * z527 - z461 * z528;
    const Scalar z551 = z456 * z526 + z457 * z528;
    const Scalar z550 = z456 * z518 - z457 * z520;
    const Scalar z555 = z460 * z519 - z461 * z520;
    const Scalar z558 = n1 / z557;
    const Scalar z546 = z405 * z516 + z406 * z517;
    const Scalar z545 = z405 * z508 - z406 * z509;
    const Scalar z549 = z456 * z510 - z457 * z512;
    const Scalar z554 = z460 * z511 - z461 * z512;
    const Scalar z542 = z401 * z507 + z402 * z509;
    const Scalar z541 = z402 * z500 + z401 * z498;
    const Scalar z544 = z405 * z499 - z406 * z500;
    const Scalar z548 = z456 * z501 - z457 * z503;
    const Scalar z563 = z556 * z558;
    const Scalar z562 = z555 * z558;
    const Scalar z561 = z554 * z558;
    const Scalar z553 = z460 * z502 - z461 * z503;
    const Scalar z573 = z546 - z555 * z562;
    const Scalar z572 = z545 + z554 * z562;
    const Scalar z569 = z542 - z554 * z561;
    const Scalar z568 = z541 - z553 * z561;
    const Scalar z571 = z544 + z553 * z562;
    const Scalar z539 = z27 * z496 + z383 * z504 - z368 * z497 + z374 * z498 + z380 * z499;
    const Scalar z538 = z368 * z488 + z374 * z489 - z380 * z490;
    const Scalar z560 = z553 * z558;
    const Scalar z566 = z539 - z553 * z560;
    const Scalar z540 = z401 * z489 - z402 * z491;
    const Scalar z543 = z405 * z490 - z406 * z491;
    const Scalar z547 = z456 * z492 - z457 * z494;
    const Scalar z552 = z460 * z493 - z461 * z494;
    const Scalar z565 = z538 + z552 * z560;
    const Scalar z567 = z540 + z552 * z561;
    const Scalar z570 = z543 + z552 * z562;
    const Scalar z574 = z547 + z552 * z563;
    const Scalar z559 = z552 * z558;
    const Scalar z564 = z537 + z552 * z559;
    const Scalar z515 = z485 * z514;
    const Scalar z578 = z551 - z556 * z563;
    const Scalar z577 = z550 + z555 * z563;
    const Scalar z576 = z549 + z554 * z563;
    const Scalar z575 = z548 + z553 * z563;
    const Scalar z579 = n1 / z578;
    const Scalar z523 = z485 * z522;
    const Scalar z531 = z485 * z530;
    const Scalar z524 = z483 * z522;
    const Scalar z532 = z483 * z530;
    const Scalar z525 = z481 * z522;
    const Scalar z533 = z481 * z530;
    const Scalar z614 = n25_over_21 * z252;
    const Scalar z615 = n100000 * z232;
    const Scalar z616 = n100000 * z233;
    const Scalar z617 = n100000 * z234;
    const Scalar z623 = z401 * z615 - z403 - z402 * z617;
    const Scalar z624 = z407 + z406 * z617 + z405 * z616;
    const Scalar z618 = n100000 * z220;
    const Scalar z620 = n100000 * z222;
    const Scalar z625 = z456 * z618 - z458 - z457 * z620;
    const Scalar z621 = z473 * z474;
    const Scalar z622 = z27 * z614 - z374 * z615 - z380 * z616 + z383 * z621 + z399;
    const Scalar z619 = n100000 * z221;
    const Scalar z626 = z462 + z461 * z620 + z460 * z619;
    const Scalar z583 = z577 * z579;
    const Scalar z593 = z573 - z577 * z583;
    const Scalar z592 = z572 + z576 * z583;
    const Scalar z591 = z571 + z575 * z583;
    const Scalar z590 = z570 + z574 * z583;
    const Scalar z594 = n1 / z593;
    const Scalar z627 = z563 * z626 - z625;
    const Scalar z628 = z624 + z562 * z626 + z583 * z627;
    const Scalar z582 = z576 * z579;
    const Scalar z589 = z569 - z576 * z582;
    const Scalar z588 = z568 - z575 * z582;
    const Scalar z587 = z567 + z574 * z582;
    const Scalar z581 = z575 * z579;
    const Scalar z586 = z566 - z575 * z581;
    const Scalar z585 = z565 + z574 * z581;
    const Scalar z580 = z574 * z579;
    const Scalar z584 = z564 + z574 * z580;
    const Scalar z595 = z590 * z594;
    const Scalar z596 = z591 * z594;
    const Scalar z597 = z592 * z594;
    const Scalar z598 = z584 + z590 * z595;
    const Scalar z599 = z585 + z590 * z596;
    const Scalar z600 = z586 - z591 * z596;
    const Scalar z601 = z587 + z590 * z597;
    const Scalar z603 = z589 - z592 * z597;
    const Scalar z602 = z588 - z591 * z597;
    const Scalar z629 = z561 * z626 - z623 + z582 * z627 + z597 * z628;
    const Scalar z604 = n1 / z603;
    const Scalar z605 = z601 * z604;
    const Scalar z606 = z602 * z604;
    const Scalar z607 = z598 + z601 * z605;
    const Scalar z608 = z599 - z601 * z606;
    const Scalar z609 = z600 - z602 * z606;
    const Scalar z630 = z622 + z560 * z626 + z581 * z627 + z596 * z628 - z606 * z629;
    const Scalar z610 = n1 / z609;
    const Scalar z611 = z608 * z610;
    const Scalar z612 = z607 + z608 * z611;
    const Scalar z631 = z343 + z559 * z626 + z580 * z627 + z595 * z628 + z605 * z629 + z611 * z630;
    const Scalar z613 = n1 / z612;
    const Scalar z632 = z613 * z631;
    const Scalar z633 = z610 * z630 - z611 * z632;
    const Scalar z634 = z604 * z629 - z605 * z632 - z606 * z633;
    const Scalar z638 = z496 * z633 - z614;
    const Scalar z646 = z504 * z633 - z621;
    const Scalar z635 = z594 * z628 - z595 * z632 + z596 * z633 + z597 * z634;
    const Scalar z636 = z579 * z627 - z580 * z632 + z581 * z633 + z582 * z634 + z583 * z635;
    const Scalar z637 = z558 * z626 - z559 * z632 + z560 * z633 + z561 * z634 + z562 * z635 + z563 * z636;
    const Scalar z639 = z488 * z632 - z497 * z633 - z506 * z634 - z514 * z635 - z522 * z636 - z530 * z637;
    const Scalar z640 = z615 + z489 * z632 + z498 * z633 + z507 * z634 - z515 * z635 - z523 * z636 - z531 * z637;
    const Scalar z641 = z490 * z632 - z616 - z499 * z633 - z508 * z634 + z516 * z635 - z524 * z636 - z532 * z637;
    const Scalar z642 = z617 + z491 * z632 - z500 * z633 - z509 * z634 - z517 * z635 - z525 * z636 - z533 * z637;
    const Scalar z643 = z618 + z492 * z632 - z501 * z633 - z510 * z634 - z518 * z635 + z526 * z636 - z534 * z637;
    const Scalar z644 = z493 * z632 - z619 - z502 * z633 - z511 * z634 - z519 * z635 - z527 * z636 + z535 * z637;
    const Scalar z645 = z620 + z494 * z632 - z503 * z633 - z512 * z634 - z520 * z635 - z528 * z636 - z536 * z637;
    accelerations.a_z = z638;
    accelerations.a = z639;
    accelerations.lower_omega_x = -z640;
    accelerations.lower_omega_y = -z641;
    accelerations.lower_omega_z = -z642;
    accelerations.upper_omega_x = -z643;
    accelerations.upper_omega_y = -z644;
    accelerations.upper_omega_z = -z645;
    accelerations.omega_z = -z646;
    multipliers.lambda_L2_y = -z632;
    multipliers.lambda_L2_z = n0;
    multipliers.lambda_L2_ry = n0;
    multipliers.lambda_L2_rz = n0;
    multipliers.lambda_L3_z = -z633;
    multipliers.lambda_L3_rx = -z634;
    multipliers.lambda_L3_ry = z635;
    multipliers.lambda_L5_z = n0;
    multipliers.lambda_L5_rx = -z636;
    multipliers.lambda_L5_ry = z637;
    if (!(traits::regular(-z486, z180) && traits::regular(z193, z193) && traits::regular(-z612, -z537)
        && traits::regular(z609, z539) && traits::regular(z603, z542) && traits::regular(z593, z546)
        && traits::regular(z578, z551) && traits::regular(z557, z557))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.a_z * accelerations.a * accelerations.lower_omega_x
        * accelerations.lower_omega_y * accelerations.lower_omega_z * accelerations.upper_omega_x
        * accelerations.upper_omega_y * accelerations.upper_omega_z * accelerations.omega_z * multipliers.lambda_L2_y
        * multipliers.lambda_L3_z * multipliers.lambda_L3_rx * multipliers.lambda_L3_ry * multipliers.lambda_L5_rx
        * multipliers.lambda_L5_ry;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_005 = traits::constant(0.005, 0.005f, "1/200");
    const Scalar k7 = traits::constant(5e-05, 5e-05f, "1/20000");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar k9 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    const Scalar pi = traits::pi();
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z11 = n2 * q_lower_z * q_lower_z;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z39 = n2 * q_upper_z * q_upper_z;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z13 = n2 * q_lower_y * q_lower_x;
    const Scalar z15 = n2 * q_lower_z * q_lower_w;
    const Scalar z23 = z20 - z21;
    const Scalar z24 = z20 + z21;
    const Scalar z28 = z25 - z26;
    const Scalar z41 = n2 * q_upper_y * q_upper_x;
    const Scalar z43 = n2 * q_upper_z * q_upper_w;
    const Scalar z51 = z48 - z49;
    const Scalar z52 = z48 + z49;
    const Scalar z56 = z53 - z54;
    const Scalar z80 = n0_1 * v_a;
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z18 = z13 + z15;
    const Scalar z22 = n1 - z11 - z19;
    const Scalar z46 = z41 + z43;
    const Scalar z50 = n1 - z39 - z47;
    const Scalar z81 = v_a * z28;
    const Scalar z82 = v_a * z24;
    const Scalar z83 = v_a * z27;
    const Scalar z104 = v_a * z56;
    const Scalar z105 = v_a * z52;
    const Scalar z106 = v_a * z55;
    const Scalar z84 = v_lower_omega_x + z81;
    const Scalar z90 = v_lower_omega_y + z82;
    const Scalar z94 = v_lower_omega_z + z83;
    const Scalar z107 = v_upper_omega_x + z104;
    const Scalar z111 = v_upper_omega_y + z105;
    const Scalar z115 = v_upper_omega_z + z106;
    const Scalar z119 = n0_002 * q_omega_z / pi;
    const Scalar z120 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z195 = n0_0005 * v_omega_z;
    const Scalar z647 = v_a_z * z28 + z18 * z80;
    const Scalar z648 = v_a_z * z24 + z22 * z80;
    const Scalar z649 = z23 * z80 + v_a_z * z27;
    const Scalar z650 = v_a_z * z56 + z46 * z80;
    const Scalar z651 = v_a_z * z52 + z50 * z80;
    const Scalar z652 = z51 * z80 + v_a_z * z55;
    result.kinetic = n0_4 * v_a_z * v_a_z + n0_005 * v_a * v_a + k7 * v_omega_z * v_omega_z + n0_15 * z120 * z120 + k9
        * (z84 * z84 + z90 * z90 + z94 * z94 + z107 * z107 + z111 * z111 + z115 * z115) + n0_01 * (z647 * z647 + z648
        * z648 + z649 * z649 + z650 * z650 + z651 * z651 + z652 * z652);
    result.force_function = -q_a_z * (n8_2404 + n10000 * q_a_z) - n2_943 * z119;
    result.power = -v_omega_z * (z195 - u_C);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z351 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w
        * v_lower_omega_y);
    const Scalar z354 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w
        * v_lower_omega_x);
    const Scalar z352 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w
        * v_lower_omega_z);
    const Scalar z355 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z9 = n2 * q_lower_y * q_lower_y;
    const Scalar z37 = n2 * q_upper_y * q_upper_y;
    const Scalar z19 = n2 * q_lower_x * q_lower_x;
    const Scalar z47 = n2 * q_upper_x * q_upper_x;
    const Scalar z120 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z27 = n1 - z9 - z19;
    const Scalar z55 = n1 - z37 - z47;
    const Scalar z78 = n0_1 * s_a;
    const Scalar z119 = n0_002 * q_omega_z / pi;
    const Scalar z359 = n4 * q_lower_y * z351;
    const Scalar z360 = n4 * q_lower_x * z354;
    const Scalar z362 = v_a_z - z120;
    const Scalar z347 = q_a_z - z119;
    const Scalar z361 = z359 + z360;
    const Scalar z77 = n0_1 * c_a;
    const Scalar z353 = n2 * (q_lower_y * z352 - q_lower_z * z351);
    const Scalar z356 = n2 * (q_lower_x * z355 - q_lower_w * z354);
    const Scalar z341 = v_a * s_a;
    const Scalar z357 = z353 - z356;
    const Scalar z20 = n2 * q_lower_y * q_lower_z;
    const Scalar z21 = n2 * q_lower_x * q_lower_w;
    const Scalar z48 = n2 * q_upper_y * q_upper_z;
    const Scalar z49 = n2 * q_upper_x * q_upper_w;
    const Scalar z339 = v_a * c_a;
    const Scalar z336 = n0_2 * s_a;
    const Scalar z25 = n2 * q_lower_z * q_lower_x;
    const Scalar z26 = n2 * q_lower_y * q_lower_w;
    const Scalar z53 = n2 * q_upper_z * q_upper_x;
    const Scalar z54 = n2 * q_upper_y * q_upper_w;
    const Scalar z23 = z20 - z21;
    const Scalar z24 = z20 + z21;
    const Scalar z51 = z48 - z49;
    const Scalar z52 = z48 + z49;
    const Scalar z28 = z25 - z26;
    const Scalar z29 = z25 + z26;
    const Scalar z383 = z27 * z68;
    const Scalar z386 = n0_5 * (v_lower_omega_x * z351 - v_lower_omega_y * z354 + v_lower_omega_z * z355);
    const Scalar z389 = n0_5 * (v_lower_omega_x * z354 + v_lower_omega_y * z351 - v_lower_omega_z * z352);
    const Scalar z340 = n0_2 * z339;
    const Scalar z344 = n0_2 * z341;
    const Scalar z368 = z23 * z77 + z29 * z78;
    const Scalar z387 = n0_5 * (v_lower_omega_x * z352 + v_lower_omega_y * z355 + v_lower_omega_z * z354);
    const Scalar z388 = n4 * z351 * z352 + n2 * (q_lower_y * z386 + q_lower_z * z387);
    const Scalar z79 = n0_1 - z77;  // place of lower_omega_x, x
    const Scalar z350 = z27 * z347 + z23 * z78 + z29 * z79;
    const Scalar z342 = v_a * z341;
    const Scalar z366 = n0_1 * z341;
    const Scalar z343 = n0_2 * z342;
    const Scalar z384 = n0_1 * z342;
    const Scalar z358 = n0_1 * z339;
    const Scalar z345 = v_a * z339;
    const Scalar z346 = n0_2 * z345;
    const Scalar z385 = n0_1 * z345;
    const Scalar z56 = z53 - z54;
    const Scalar z57 = z53 + z54;
    const Scalar z390 = n0_5 * (v_lower_omega_x * z355 - v_lower_omega_y * z352 - v_lower_omega_z * z351);
    const Scalar z393 = n4 * z352 * z354 + n2 * (q_lower_z * z390 + q_lower_x * z386);
    const Scalar z363 = n2 * (q_lower_z * z354 - q_lower_x * z352);
    const Scalar z391 = n4 * z354 * z355 + n2 * (q_lower_x * z389 + q_lower_w * z390);
    const Scalar z394 = n4 * z351 * z355 + n2 * (q_lower_y * z389 + q_lower_w * z387);
    const Scalar z396 = n4 * (q_lower_y * z387 - z351 * z351);
    const Scalar z364 = n2 * (q_lower_y * z355 - q_lower_w * z351);
    const Scalar z392 = z388 - z391;
    const Scalar z395 = z393 + z394;
    const Scalar z369 = q_lower_y * q_lower_y - q_lower_z * q_lower_z;
    const Scalar z370 = q_lower_x * q_lower_x - q_lower_w * q_lower_w;
    const Scalar z375 = q_lower_y * q_lower_x + q_lower_z * q_lower_w;
    const Scalar z376 = n2 * z375;
    const Scalar z365 = z363 - z364;
    const Scalar z367 = z27 * z362 - z347 * z361 - z78 * z357 + z23 * z358 + z29 * z366 + z79 * z365;
    const Scalar z371 = z369 - z370;
    const Scalar z372 = q_lower_y * q_lower_x - q_lower_z * q_lower_w;
    const Scalar z373 = n2 * z372;
    const Scalar z377 = q_lower_z * q_lower_z - q_lower_x * q_lower_x;
    const Scalar z378 = q_lower_y * q_lower_y - q_lower_w * q_lower_w;
    const Scalar z374 = z24 * z347 + z78 * z371 + z79 * z373;
    const Scalar z335 = n0_2 * c_a;
    const Scalar z397 = n4 * (q_lower_x * z390 - z354 * z354);
    const Scalar z398 = z396 + z397;
    const Scalar z337 = n0_1 - z335;
    const Scalar z338 = n0_1 + z337;
    const Scalar z400 = z353 + z356;
    const Scalar z401 = z369 + z370;
    const Scalar z403 = z388 + z391;
    const Scalar z399 = z78 * z392 - z347 * z398 + z79 * z395 + z23 * z384 - z29 * z385 + n2 * (z361 * z362 + z357
        * z358 - z365 * z366);
    const Scalar z404 = z363 + z364;
    const Scalar z407 = z393 - z394;
    const Scalar z411 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z414 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z425 = z51 * z77 + z57 * z78;
    const Scalar z412 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z405 = z377 - z378;
    const Scalar z379 = z377 + z378;
    const Scalar z415 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z380 = z28 * z347 + z78 * z376 - z79 * z379;
    const Scalar z441 = n0_5 * (v_upper_omega_x * z411 - v_upper_omega_y * z414 + v_upper_omega_z * z415);
    const Scalar z442 = n0_5 * (v_upper_omega_x * z412 + v_upper_omega_y * z415 + v_upper_omega_z * z414);
    const Scalar z418 = n4 * q_upper_y * z411;
    const Scalar z410 = z55 * z347 + z51 * z78 + z57 * z79;
    const Scalar z440 = z55 * z68;
    const Scalar z419 = n4 * q_upper_x * z414;
    const Scalar z420 = z418 + z419;
    const Scalar z413 = n2 * (q_upper_y * z412 - q_upper_z * z411);
    const Scalar z416 = n2 * (q_upper_x * z415 - q_upper_w * z414);
    const Scalar z417 = z413 - z416;
    const Scalar z421 = n2 * (q_upper_z * z414 - q_upper_x * z412);
    const Scalar z422 = n2 * (q_upper_y * z415 - q_upper_w * z411);
    const Scalar z426 = q_upper_y * q_upper_y - q_upper_z * q_upper_z;
    const Scalar z427 = q_upper_x * q_upper_x - q_upper_w * q_upper_w;
    const Scalar z432 = q_upper_y * q_upper_x + q_upper_z * q_upper_w;
    const Scalar z433 = n2 * z432;
    const Scalar z423 = z421 - z422;
    const Scalar z424 = z55 * z362 - z347 * z420 - z78 * z417 + z51 * z358 + z57 * z366 + z79 * z423;
    const Scalar z428 = z426 - z427;
    const Scalar z429 = q_upper_y * q_upper_x - q_upper_z * q_upper_w;
    const Scalar z430 = n2 * z429;
    const Scalar z434 = q_upper_z * q_upper_z - q_upper_x * q_upper_x;
    const Scalar z435 = q_upper_y * q_upper_y - q_upper_w * q_upper_w;
    const Scalar z431 = z52 * z347 + z78 * z428 + z79 * z430;
    const Scalar z436 = z434 + z435;
    const Scalar z437 = z56 * z347 + z78 * z433 - z79 * z436;
    const Scalar z381 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z402 = n2 * z381;
    const Scalar z443 = n4 * z411 * z412 + n2 * (q_upper_y * z441 + q_upper_z * z442);
    const Scalar z382 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z455 = z413 + z416;
    const Scalar z456 = z426 + z427;
    const Scalar z459 = z421 + z422;
    const Scalar z460 = z434 - z435;
    const Scalar z406 = n2 * z382;
    const Scalar z444 = n0_5 * (v_upper_omega_x * z414 + v_upper_omega_y * z411 - v_upper_omega_z * z412);
    const Scalar z445 = n0_5 * (v_upper_omega_x * z415 - v_upper_omega_y * z412 - v_upper_omega_z * z411);
    const Scalar z448 = n4 * z412 * z414 + n2 * (q_upper_z * z445 + q_upper_x * z441);
    const Scalar z446 = n4 * z414 * z415 + n2 * (q_upper_x * z444 + q_upper_w * z445);
    const Scalar z452 = n4 * (q_upper_x * z445 - z414 * z414);
    const Scalar z449 = n4 * z411 * z415 + n2 * (q_upper_y * z444 + q_upper_w * z442);
    const Scalar z451 = n4 * (q_upper_y * z442 - z411 * z411);
    const Scalar z447 = z443 - z446;
    const Scalar z458 = z443 + z446;
    const Scalar z453 = z451 + z452;
    const Scalar z450 = z448 + z449;
    const Scalar z438 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z439 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z454 = z78 * z447 - z347 * z453 + z79 * z450 + z51 * z384 - z57 * z385 + n2 * (z362 * z420 + z358
        * z417 - z366 * z423);
    const Scalar z457 = n2 * z438;
    const Scalar z461 = n2 * z439;
    const Scalar z462 = z448 - z449;
    result.value[0] = z336;
    result.rate[0] = z340;
    result.gamma[0] = -z343;
    result.value[1] = z338;
    result.rate[1] = z344;
    result.gamma[1] = z346;
    result.value[2] = n0;
    result.rate[2] = n0;
    result.gamma[2] = n0;
    result.value[3] = n0;
    result.rate[3] = n0;
    result.gamma[3] = n0;
    result.value[4] = -z350;
    result.rate[4] = -z367;
    result.gamma[4] = z399;
    result.value[5] = -z24;
    result.rate[5] = z400;
    result.gamma[5] = z403;
    result.value[6] = z28;
    result.rate[6] = z404;
    result.gamma[6] = -z407;
    result.value[7] = -z410;
    result.rate[7] = -z424;
    result.gamma[7] = z454;
    result.value[8] = -z52;
    result.rate[8] = z455;
    result.gamma[8] = z458;
    result.value[9] = z56;
    result.rate[9] = z459;
    result.gamma[9] = -z462;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = -z27;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = -z55;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = z335;
    result.jacobian[11] = z336;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = -z368;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = -z425;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = n0;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = z374;
    result.jacobian[25] = z401;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = -z380;
    result.jacobian[35] = n0;
    result.jacobian[36] = -z405;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = -z402;
    result.jacobian[46] = z406;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0;
    result.jacobian[56] = n0;
    result.jacobian[57] = z431;
    result.jacobian[58] = z456;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n0;
    result.jacobian[67] = -z437;
    result.jacobian[68] = n0;
    result.jacobian[69] = -z460;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n0;
    result.jacobian[77] = n0;
    result.jacobian[78] = -z457;
    result.jacobian[79] = z461;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = z383;
    result.jacobian[85] = n0;
    result.jacobian[86] = n0;
    result.jacobian[87] = z440;
    result.jacobian[88] = n0;
    result.jacobian[89] = n0;
  }
};

}  // namespace model_making_press
