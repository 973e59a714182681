// SPDX-License-Identifier: MIT
// four_blade_rotor: Rotor of four blades set at a pitch, turning about its centre
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation
// Parameters set at run time: alpha
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               11                4          2             0                  1       0     19       -
//   kinematics               62              101          0             0                  0       0    163     193
//   mass_matrix               0                0          0             0                  0       0      0      17
//   bias                     16               34          0             0                  0       0     50      58
//   inverse_dynamics         18               37          0             0                  0       0     55      78
//   forward_dynamics         16               36          0             0                  0       0     52      77
//   energy                   17               23          0             0                  0       0     40      55
//   first_integrals          17               24          0             0                  0       0     41      62
//   linearisation            40               81          0             0                  0       0    121     150
//
// Not computed because this mechanism does not need it:
//   kinematics: of 72 results 21 repeat another up to sign
//   mass_matrix: of 9 results 6 vanish identically
//   bias: of 3 results 1 vanish identically
//   forward_dynamics: of 3 results 1 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 66 results 43 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   four_blade_rotor_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output four_blade_rotor.hpp
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

namespace four_blade_rotor {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_blade_rotor";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x9c8b97cda392938cULL;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 2;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[] = {0};

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha;  ///< parameter [rad or 1]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::alpha};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar e_w;  ///< component of a unit quaternion [1]
    Scalar e_x;  ///< component of a unit quaternion [1]
    Scalar e_y;  ///< component of a unit quaternion [1]
    Scalar e_z;  ///< component of a unit quaternion [1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::e_w, &Coordinates::e_x, &Coordinates::e_y,
          &Coordinates::e_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar e_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar e_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar e_omega_z;  ///< angular velocity, in moving axes [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::e_omega_x, &Velocities::e_omega_y,
          &Velocities::e_omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar e_omega_x;  ///< its rate [rad/s^2]
    Scalar e_omega_y;  ///< its rate [rad/s^2]
    Scalar e_omega_z;  ///< its rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::e_omega_x, &Accelerations::e_omega_y,
          &Accelerations::e_omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar e_omega_x;  ///< works with e_omega_x [N m]
    Scalar e_omega_y;  ///< works with e_omega_y [N m]
    Scalar e_omega_z;  ///< works with e_omega_z [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::e_omega_x, &GeneralizedForces::e_omega_y,
          &GeneralizedForces::e_omega_z};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
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
    Scalar m_7b59dd2d;
    Scalar m_e1bdef79;
    Scalar m_a8fa4f8e;
    Scalar m_b375ffd8;
    Scalar m_71a5253a;
    Scalar m_f4f2deb3;
    Scalar m_a02f74de;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    parameters.alpha = n0_2;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665_8 = traits::constant(665.8, 665.8f, "3329/5");
    const Scalar n1331_6 = traits::constant(1331.6, 1331.6f, "6658/5");
    const Scalar n666_2 = traits::constant(666.2, 666.2f, "3331/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_alpha = parameters.alpha;
    Scalar s_alpha, c_alpha;
    traits::sincos(p_alpha, s_alpha, c_alpha);
    const Scalar z0 = n0_4 * s_alpha;
    const Scalar z1 = n0_4 * c_alpha;
    const Scalar z2 = c_alpha * z1;
    const Scalar z3 = s_alpha * z0;
    const Scalar z4 = n665_8 - z2;
    const Scalar z5 = n1331_6 - z3;
    const Scalar z6 = n0_4 + z4;
    const Scalar z7 = n666_2 - z2;
    const Scalar z8 = z3 - z5;
    const Scalar z9 = z2 - z6;
    const Scalar z10 = n0_4 + z7;
    const Scalar z11 = z3 + z8;
    const Scalar z12 = n0_4 - z9;
    const Scalar z13 = z2 - z10;
    const Scalar z14 = z3 + z11;
    const Scalar z15 = n1 / z13;
    const Scalar z16 = n1 / z12;
    precomputed.m_7b59dd2d = s_alpha;
    precomputed.m_e1bdef79 = c_alpha;
    precomputed.m_a8fa4f8e = z12;
    precomputed.m_b375ffd8 = z13;
    precomputed.m_71a5253a = z14;
    precomputed.m_f4f2deb3 = z15;
    precomputed.m_a02f74de = z16;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    state.time = n0;
    state.q.e_w = n1;
    state.q.e_x = n0;
    state.q.e_y = n0;
    state.q.e_z = n0;
    state.v.e_omega_x = n0_4;
    state.v.e_omega_y = n0_3;
    state.v.e_omega_z = n5;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> blade_1_position;  ///< centre of mass of blade_1 [m]
    std::array<Scalar, 9> blade_1_rotation;  ///< from the axes of blade_1 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_1_velocity;  ///< velocity of the centre of mass of blade_1 [m/s]
    std::array<Scalar, 3> blade_1_angular_velocity;  ///< angular velocity of blade_1 [rad/s]
    std::array<Scalar, 3> blade_2_position;  ///< centre of mass of blade_2 [m]
    std::array<Scalar, 9> blade_2_rotation;  ///< from the axes of blade_2 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_2_velocity;  ///< velocity of the centre of mass of blade_2 [m/s]
    std::array<Scalar, 3> blade_2_angular_velocity;  ///< angular velocity of blade_2 [rad/s]
    std::array<Scalar, 3> blade_3_position;  ///< centre of mass of blade_3 [m]
    std::array<Scalar, 9> blade_3_rotation;  ///< from the axes of blade_3 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_3_velocity;  ///< velocity of the centre of mass of blade_3 [m/s]
    std::array<Scalar, 3> blade_3_angular_velocity;  ///< angular velocity of blade_3 [rad/s]
    std::array<Scalar, 3> blade_4_position;  ///< centre of mass of blade_4 [m]
    std::array<Scalar, 9> blade_4_rotation;  ///< from the axes of blade_4 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_4_velocity;  ///< velocity of the centre of mass of blade_4 [m/s]
    std::array<Scalar, 3> blade_4_angular_velocity;  ///< angular velocity of blade_4 [rad/s]
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

  /// Quantities that every motion conserves.
  struct FirstIntegrals {
    Scalar energy;  ///< T - U [J]
    Scalar momentum_e_omega_z;  ///< dT/de_omega_z, constant in the moving axes [kg m^2 s^-1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_e_omega_z};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, w): x' = A x + B du (6 x 6)
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 4>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_e_y = state.q.e_y;
    const Scalar q_e_z = state.q.e_z;
    const Scalar q_e_x = state.q.e_x;
    const Scalar q_e_w = state.q.e_w;
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar z0 = n0_5 * (q_e_y * v_e_omega_y + q_e_z * v_e_omega_z + q_e_x * v_e_omega_x);
    const Scalar z1 = n0_5 * (q_e_y * v_e_omega_z - q_e_z * v_e_omega_y + q_e_w * v_e_omega_x);
    const Scalar z2 = n0_5 * (q_e_z * v_e_omega_x - q_e_x * v_e_omega_z + q_e_w * v_e_omega_y);
    const Scalar z3 = n0_5 * (q_e_y * v_e_omega_x - q_e_x * v_e_omega_y - q_e_w * v_e_omega_z);
    rates[0] = -z0;
    rates[1] = z1;
    rates[2] = z2;
    rates[3] = -z3;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar q_e_y = state.q.e_y;
    const Scalar q_e_z = state.q.e_z;
    const Scalar q_e_x = state.q.e_x;
    const Scalar q_e_w = state.q.e_w;
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar z0 = n2 * q_e_y;
    const Scalar z1 = n2 * q_e_z;
    const Scalar z2 = n2 * q_e_x;
    const Scalar z3 = v_e_omega_z * c_alpha;
    const Scalar z4 = v_e_omega_z * s_alpha;
    const Scalar z5 = q_e_y * z0;
    const Scalar z6 = q_e_z * z1;
    const Scalar z7 = q_e_z * z0;
    const Scalar z8 = q_e_w * z2;
    const Scalar z9 = q_e_x * z1;
    const Scalar z10 = q_e_w * z0;
    const Scalar z11 = q_e_x * z0;
    const Scalar z12 = q_e_w * z1;
    const Scalar z13 = q_e_x * z2;
    const Scalar z14 = z7 - z8;
    const Scalar z15 = z7 + z8;
    const Scalar z16 = z9 - z10;
    const Scalar z17 = z9 + z10;
    const Scalar z18 = n1 - z5 - z6;
    const Scalar z19 = z11 - z12;
    const Scalar z20 = z11 + z12;
    const Scalar z21 = n1 - z6 - z13;
    const Scalar z22 = n1 - z5 - z13;
    const Scalar z23 = s_alpha * z17;
    const Scalar z24 = s_alpha * z14;
    const Scalar z25 = c_alpha * z15;
    const Scalar z26 = c_alpha * z16;
    const Scalar z27 = v_e_omega_y * s_alpha - z3;
    const Scalar z28 = v_e_omega_x * s_alpha + z3;
    const Scalar z29 = v_e_omega_y * s_alpha + z3;
    const Scalar z30 = v_e_omega_x * s_alpha - z3;
    const Scalar z31 = v_e_omega_x * z18;  // angular velocity of e_omega_x, x
    const Scalar z32 = v_e_omega_x * z20;  // angular velocity of e_omega_x, y
    const Scalar z33 = n3 * z27;
    const Scalar z34 = v_e_omega_y * z19 + z31;  // angular velocity of e_omega_y, x
    const Scalar z35 = v_e_omega_y * z21 + z32;  // angular velocity of e_omega_y, y
    const Scalar z36 = n3 * z18;
    const Scalar z37 = n3 * z20;
    const Scalar z38 = v_e_omega_z * z17 + z34;  // angular velocity of rotor, x
    const Scalar z39 = v_e_omega_x * z16;  // angular velocity of e_omega_x, z
    const Scalar z40 = v_e_omega_z * z14 + z35;  // angular velocity of rotor, y
    const Scalar z41 = c_alpha * z17;
    const Scalar z42 = c_alpha * z14;
    const Scalar z43 = s_alpha * z15;
    const Scalar z44 = n3 * z28;
    const Scalar z45 = v_e_omega_y * z15 + z39;  // angular velocity of e_omega_y, z
    const Scalar z46 = v_e_omega_z * z22 + z45;  // angular velocity of rotor, z
    const Scalar z47 = s_alpha * z16;
    const Scalar z48 = n3 * z16;
    const Scalar z49 = c_alpha * z19 + z23;
    const Scalar z50 = n3 * z15;
    const Scalar z51 = c_alpha * z21 + z24;
    const Scalar z52 = n3 * z29;
    const Scalar z53 = n3 * z19;
    const Scalar z54 = n3 * z21;
    const Scalar z55 = s_alpha * z22 + z25;
    const Scalar z56 = s_alpha * z22 - z25;
    const Scalar z57 = v_e_omega_y * c_alpha + z4;
    const Scalar z58 = n3 * z57;
    const Scalar z59 = c_alpha * z18 - z23;
    const Scalar z60 = c_alpha * z20 - z24;
    const Scalar z61 = s_alpha * z22 - z26;
    const Scalar z62 = s_alpha * z22 + z26;
    const Scalar z63 = v_e_omega_x * c_alpha - z4;
    const Scalar z64 = n3 * z63;
    const Scalar z65 = c_alpha * z19 - z23;
    const Scalar z66 = c_alpha * z18 + z23;
    const Scalar z67 = c_alpha * z21 - z24;
    const Scalar z68 = c_alpha * z20 + z24;
    const Scalar z69 = v_e_omega_y * c_alpha - z4;
    const Scalar z70 = v_e_omega_x * c_alpha + z4;
    const Scalar z71 = n3 * z69;
    const Scalar z72 = s_alpha * z19 - z41;
    const Scalar z73 = z49 * z33 - z72 * z58;
    const Scalar z74 = n3 * z30;
    const Scalar z75 = s_alpha * z19 + z41;
    const Scalar z76 = z65 * z52 - z75 * z71;
    const Scalar z77 = n3 * z70;
    const Scalar z78 = s_alpha * z21 - z42;
    const Scalar z79 = z51 * z33 - z78 * z58;
    const Scalar z80 = s_alpha * z21 + z42;
    const Scalar z81 = z67 * z52 - z80 * z71;
    const Scalar z82 = c_alpha * z22 - z43;
    const Scalar z83 = z55 * z33 + z82 * z58;
    const Scalar z84 = c_alpha * z22 + z43;
    const Scalar z85 = z56 * z52 + z84 * z71;
    const Scalar z86 = s_alpha * z18 + z41;
    const Scalar z87 = s_alpha * z20 + z42;
    const Scalar z88 = c_alpha * z22 + z47;
    const Scalar z89 = s_alpha * z18 - z41;
    const Scalar z90 = s_alpha * z20 - z42;
    const Scalar z91 = c_alpha * z22 - z47;
    const Scalar z92 = z59 * z44 - z86 * z64;
    const Scalar z93 = z60 * z44 - z87 * z64;
    const Scalar z94 = z61 * z44 + z88 * z64;
    const Scalar z95 = z66 * z74 - z89 * z77;
    const Scalar z96 = z68 * z74 - z90 * z77;
    const Scalar z97 = z62 * z74 + z91 * z77;
    result.blade_1_position[0] = z36;
    result.blade_1_position[1] = z37;
    result.blade_1_position[2] = z48;
    result.blade_1_rotation[0] = z18;
    result.blade_1_rotation[1] = z20;
    result.blade_1_rotation[2] = z16;
    result.blade_1_rotation[3] = z49;
    result.blade_1_rotation[4] = z51;
    result.blade_1_rotation[5] = z55;
    result.blade_1_rotation[6] = -z72;
    result.blade_1_rotation[7] = -z78;
    result.blade_1_rotation[8] = z82;
    result.blade_1_velocity[0] = -z73;
    result.blade_1_velocity[1] = -z79;
    result.blade_1_velocity[2] = -z83;
    result.blade_1_angular_velocity[0] = z38;
    result.blade_1_angular_velocity[1] = z40;
    result.blade_1_angular_velocity[2] = z46;
    result.blade_2_position[0] = z53;
    result.blade_2_position[1] = z54;
    result.blade_2_position[2] = z50;
    result.blade_2_rotation[0] = z19;
    result.blade_2_rotation[1] = z21;
    result.blade_2_rotation[2] = z15;
    result.blade_2_rotation[3] = -z59;
    result.blade_2_rotation[4] = -z60;
    result.blade_2_rotation[5] = z61;
    result.blade_2_rotation[6] = z86;
    result.blade_2_rotation[7] = z87;
    result.blade_2_rotation[8] = z88;
    result.blade_2_velocity[0] = -z92;
    result.blade_2_velocity[1] = -z93;
    result.blade_2_velocity[2] = z94;
    result.blade_2_angular_velocity[0] = z38;
    result.blade_2_angular_velocity[1] = z40;
    result.blade_2_angular_velocity[2] = z46;
    result.blade_3_position[0] = -z36;
    result.blade_3_position[1] = -z37;
    result.blade_3_position[2] = -z48;
    result.blade_3_rotation[0] = -z18;
    result.blade_3_rotation[1] = -z20;
    result.blade_3_rotation[2] = -z16;
    result.blade_3_rotation[3] = -z65;
    result.blade_3_rotation[4] = -z67;
    result.blade_3_rotation[5] = z56;
    result.blade_3_rotation[6] = z75;
    result.blade_3_rotation[7] = z80;
    result.blade_3_rotation[8] = z84;
    result.blade_3_velocity[0] = -z76;
    result.blade_3_velocity[1] = -z81;
    result.blade_3_velocity[2] = z85;
    result.blade_3_angular_velocity[0] = z38;
    result.blade_3_angular_velocity[1] = z40;
    result.blade_3_angular_velocity[2] = z46;
    result.blade_4_position[0] = -z53;
    result.blade_4_position[1] = -z54;
    result.blade_4_position[2] = -z50;
    result.blade_4_rotation[0] = -z19;
    result.blade_4_rotation[1] = -z21;
    result.blade_4_rotation[2] = -z15;
    result.blade_4_rotation[3] = z66;
    result.blade_4_rotation[4] = z68;
    result.blade_4_rotation[5] = z62;
    result.blade_4_rotation[6] = -z89;
    result.blade_4_rotation[7] = -z90;
    result.blade_4_rotation[8] = z91;
    result.blade_4_velocity[0] = -z95;
    result.blade_4_velocity[1] = -z96;
    result.blade_4_velocity[2] = -z97;
    result.blade_4_angular_velocity[0] = z38;
    result.blade_4_angular_velocity[1] = z40;
    result.blade_4_angular_velocity[2] = z46;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State&,
      std::array<Scalar, 9>& mass) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar m0 = precomputed.m_a8fa4f8e;
    const Scalar m1 = precomputed.m_b375ffd8;
    const Scalar m2 = precomputed.m_71a5253a;
    mass[0] = m0;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = -m1;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = -m2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * v_e_omega_z;
    const Scalar z3 = v_e_omega_x * v_e_omega_z;
    const Scalar z4 = v_e_omega_y * c_alpha + z0;
    const Scalar z5 = v_e_omega_y * s_alpha - z1;
    const Scalar z6 = v_e_omega_x * c_alpha + z0;
    const Scalar z7 = v_e_omega_x * s_alpha - z1;
    const Scalar z8 = v_e_omega_x * c_alpha - z0;
    const Scalar z9 = z6 * z7;
    const Scalar z10 = z4 * z5;
    const Scalar z11 = v_e_omega_x * s_alpha + z1;
    const Scalar z12 = v_e_omega_y * c_alpha - z0;
    const Scalar z13 = v_e_omega_y * s_alpha + z1;
    const Scalar z14 = n0_4 * z9;  // moment on blade_4, x
    const Scalar z15 = n0_4 * z10;  // moment on blade_1, x
    const Scalar z16 = v_e_omega_y * z6;
    const Scalar z17 = z12 * z13;
    const Scalar z18 = v_e_omega_x * z12;
    const Scalar z19 = z8 * z11;
    const Scalar z20 = n0_4 * z16;  // moment on blade_4, z
    const Scalar z21 = n0_4 * z17;  // moment on blade_3, x
    const Scalar z22 = n0_4 * z18;  // moment on blade_3, z
    const Scalar z23 = v_e_omega_y * z8;
    const Scalar z24 = n0_4 * z19;  // moment on blade_2, x
    const Scalar z25 = v_e_omega_x * z4;
    const Scalar z26 = s_alpha * z20;
    const Scalar z27 = s_alpha * z22;
    const Scalar z28 = n0_4 * z23;  // moment on blade_2, z
    const Scalar z29 = n0_4 * z25;  // moment on blade_1, z
    const Scalar z30 = s_alpha * z28;
    const Scalar z31 = s_alpha * z29;
    const Scalar z32 = z15 - n665 * z2 - z21 + z26 - z30;  // moment on rotor, x
    const Scalar z33 = z14 - n665 * z3 - z24 - z27 + z31;  // moment on rotor, y
    forces.e_omega_x = -z32;
    forces.e_omega_y = z33;
    forces.e_omega_z = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar a_e_omega_x = accelerations.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar a_e_omega_y = accelerations.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar a_e_omega_z = accelerations.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_a8fa4f8e;
    const Scalar m3 = precomputed.m_b375ffd8;
    const Scalar m4 = precomputed.m_71a5253a;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * v_e_omega_z;
    const Scalar z3 = v_e_omega_x * v_e_omega_z;
    const Scalar z4 = a_e_omega_z * m4;
    const Scalar z5 = v_e_omega_y * c_alpha + z0;
    const Scalar z6 = v_e_omega_y * c_alpha - z0;
    const Scalar z7 = v_e_omega_y * s_alpha + z1;
    const Scalar z8 = v_e_omega_x * c_alpha + z0;
    const Scalar z9 = v_e_omega_x * s_alpha - z1;
    const Scalar z10 = z8 * z9;
    const Scalar z11 = z6 * z7;
    const Scalar z12 = v_e_omega_y * s_alpha - z1;
    const Scalar z13 = v_e_omega_x * z6;
    const Scalar z14 = n0_4 * z11;  // moment on blade_3, x
    const Scalar z15 = n0_4 * z10;  // moment on blade_4, x
    const Scalar z16 = v_e_omega_x * c_alpha - z0;
    const Scalar z17 = v_e_omega_x * s_alpha + z1;
    const Scalar z18 = v_e_omega_y * z8;
    const Scalar z19 = z5 * z12;
    const Scalar z20 = n0_4 * z13;  // moment on blade_3, z
    const Scalar z21 = z16 * z17;
    const Scalar z22 = v_e_omega_y * z16;
    const Scalar z23 = v_e_omega_x * z5;
    const Scalar z24 = n0_4 * z18;  // moment on blade_4, z
    const Scalar z25 = s_alpha * z20;
    const Scalar z26 = n0_4 * z19;  // moment on blade_1, x
    const Scalar z27 = s_alpha * z24;
    const Scalar z28 = n0_4 * z21;  // moment on blade_2, x
    const Scalar z29 = n0_4 * z22;  // moment on blade_2, z
    const Scalar z30 = n0_4 * z23;  // moment on blade_1, z
    const Scalar z31 = s_alpha * z29;
    const Scalar z32 = s_alpha * z30;
    const Scalar z33 = n665 * z2 + z14 - z26 - z27 + z31;  // moment on rotor, x
    const Scalar z34 = n665 * z3 - z15 + z25 + z28 - z32;  // moment on rotor, y
    const Scalar z35 = a_e_omega_x * m2 + z33;
    const Scalar z36 = a_e_omega_y * m3 + z34;
    forces.e_omega_x = z35;
    forces.e_omega_y = -z36;
    forces.e_omega_z = -z4;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_a8fa4f8e;
    const Scalar m3 = precomputed.m_b375ffd8;
    const Scalar m4 = precomputed.m_71a5253a;
    const Scalar m5 = precomputed.m_f4f2deb3;
    const Scalar m6 = precomputed.m_a02f74de;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * v_e_omega_z;
    const Scalar z3 = v_e_omega_x * v_e_omega_z;
    const Scalar z4 = v_e_omega_y * c_alpha + z0;
    const Scalar z5 = v_e_omega_y * s_alpha - z1;
    const Scalar z6 = v_e_omega_x * c_alpha + z0;
    const Scalar z7 = v_e_omega_x * s_alpha - z1;
    const Scalar z8 = v_e_omega_x * c_alpha - z0;
    const Scalar z9 = z6 * z7;
    const Scalar z10 = z4 * z5;
    const Scalar z11 = v_e_omega_x * s_alpha + z1;
    const Scalar z12 = v_e_omega_y * c_alpha - z0;
    const Scalar z13 = v_e_omega_y * s_alpha + z1;
    const Scalar z14 = n0_4 * z9;
    const Scalar z15 = n0_4 * z10;
    const Scalar z16 = v_e_omega_y * z6;
    const Scalar z17 = z12 * z13;
    const Scalar z18 = v_e_omega_x * z12;
    const Scalar z19 = z8 * z11;
    const Scalar z20 = n0_4 * z16;
    const Scalar z21 = n0_4 * z17;
    const Scalar z22 = n0_4 * z18;
    const Scalar z23 = v_e_omega_y * z8;
    const Scalar z24 = n0_4 * z19;
    const Scalar z25 = v_e_omega_x * z4;
    const Scalar z26 = s_alpha * z20;
    const Scalar z27 = s_alpha * z22;
    const Scalar z28 = n0_4 * z23;
    const Scalar z29 = n0_4 * z25;
    const Scalar z30 = s_alpha * z28;
    const Scalar z31 = s_alpha * z29;
    const Scalar z32 = z15 - n665 * z2 - z21 + z26 - z30;
    const Scalar z33 = z14 - n665 * z3 - z24 - z27 + z31;
    const Scalar z34 = m5 * z33;
    const Scalar z35 = m6 * z32;
    accelerations.e_omega_x = z35;
    accelerations.e_omega_y = z34;
    accelerations.e_omega_z = n0;
    if (!(traits::regular(-m4, -m4) && traits::regular(-m3, -m3) && traits::regular(m2,
        m2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.e_omega_x * accelerations.e_omega_y;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n166_25 = traits::constant(166.25, 166.25f, "665/4");
    const Scalar n166_45 = traits::constant(166.45, 166.45f, "3329/20");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * c_alpha + z0;
    const Scalar z3 = v_e_omega_y * s_alpha - z1;
    const Scalar z4 = v_e_omega_x * c_alpha - z0;
    const Scalar z5 = v_e_omega_x * s_alpha + z1;
    const Scalar z6 = v_e_omega_y * c_alpha - z0;
    const Scalar z7 = v_e_omega_y * s_alpha + z1;
    const Scalar z8 = v_e_omega_x * c_alpha + z0;
    const Scalar z9 = v_e_omega_x * s_alpha - z1;
    result.kinetic = n0_4 * (v_e_omega_x * v_e_omega_x + v_e_omega_y * v_e_omega_y) + n166_25 * (z2 * z2 + z4 * z4 + z6
        * z6 + z8 * z8) + n166_45 * (z3 * z3 + z5 * z5 + z7 * z7 + z9 * z9);
    result.force_function = n0;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n166_25 = traits::constant(166.25, 166.25f, "665/4");
    const Scalar n166_45 = traits::constant(166.45, 166.45f, "3329/20");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_71a5253a;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * c_alpha + z0;
    const Scalar z3 = v_e_omega_y * s_alpha - z1;
    const Scalar z4 = v_e_omega_x * c_alpha - z0;
    const Scalar z5 = v_e_omega_x * s_alpha + z1;
    const Scalar z6 = v_e_omega_y * c_alpha - z0;
    const Scalar z7 = v_e_omega_y * s_alpha + z1;
    const Scalar z8 = v_e_omega_x * c_alpha + z0;
    const Scalar z9 = v_e_omega_x * s_alpha - z1;
    result.energy = n0_4 * (v_e_omega_x * v_e_omega_x + v_e_omega_y * v_e_omega_y) + n166_25 * (z2 * z2 + z4 * z4 + z6
        * z6 + z8 * z8) + n166_45 * (z3 * z3 + z5 * z5 + z7 * z7 + z9 * z9);
    result.momentum_e_omega_z = -v_e_omega_z * m2;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  /// Along an attitude e is a turn in its moving axes, e' stands for w, the deviation of the angular velocity
  /// omega, and w = de/dt + omega x e: A says so.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar a_e_omega_x = accelerations.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar a_e_omega_y = accelerations.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar a_e_omega_z = accelerations.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_a8fa4f8e;
    const Scalar m3 = precomputed.m_b375ffd8;
    const Scalar m4 = precomputed.m_71a5253a;
    const Scalar m5 = precomputed.m_f4f2deb3;
    const Scalar m6 = precomputed.m_a02f74de;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_y * s_alpha;
    const Scalar z2 = v_e_omega_z * c_alpha;
    const Scalar z3 = v_e_omega_x * s_alpha;
    const Scalar z4 = v_e_omega_y * v_e_omega_z;
    const Scalar z5 = v_e_omega_x * v_e_omega_z;
    const Scalar z6 = z1 + z2;
    const Scalar z7 = z2 - z3;
    const Scalar z8 = v_e_omega_y * c_alpha - z0;
    const Scalar z9 = v_e_omega_x * c_alpha + z0;
    const Scalar z10 = v_e_omega_y * c_alpha + z0;
    const Scalar z11 = z9 * z7;
    const Scalar z12 = z8 * z6;
    const Scalar z13 = z1 - z2;
    const Scalar z14 = z2 + z3;
    const Scalar z15 = v_e_omega_x * z8;
    const Scalar z16 = n0_4 * z8;
    const Scalar z17 = n0_4 * z9;
    const Scalar z18 = n0_4 * z11;  // moment on blade_4, x
    const Scalar z19 = n0_4 * z12;  // moment on blade_3, x
    const Scalar z20 = s_alpha * z6 - c_alpha * z8;
    const Scalar z21 = s_alpha * z7 + c_alpha * z9;
    const Scalar z22 = v_e_omega_x * c_alpha - z0;
    const Scalar z23 = v_e_omega_y * z9;
    const Scalar z24 = c_alpha * z6 + s_alpha * z8;
    const Scalar z25 = z10 * z13;
    const Scalar z26 = s_alpha * z9 - c_alpha * z7;
    const Scalar z27 = n0_4 * z15;  // moment on blade_3, z
    const Scalar z28 = s_alpha * z16;
    const Scalar z29 = s_alpha * z17;
    const Scalar z30 = n0_4 * z10;
    const Scalar z31 = n0_4 * z20;
    const Scalar z32 = n0_4 * z21;
    const Scalar z33 = n0_4 * z23;  // moment on blade_4, z
    const Scalar z34 = s_alpha * z27;
    const Scalar z35 = n0_4 * z25;  // moment on blade_1, x
    const Scalar z36 = n0_4 * z1;
    const Scalar z37 = n0_4 * z3;
    const Scalar z38 = s_alpha * z30;
    const Scalar z39 = n0_4 * z24;
    const Scalar z40 = s_alpha * z33;
    const Scalar z41 = s_alpha * z36;
    const Scalar z42 = s_alpha * z37;
    const Scalar z43 = n0_4 * z26;
    const Scalar z44 = a_e_omega_z * m4;
    const Scalar z45 = z22 * z14;
    const Scalar z46 = n0_4 * z45;  // moment on blade_2, x
    const Scalar z47 = v_e_omega_y * z22;
    const Scalar z48 = n0_4 * z47;  // moment on blade_2, z
    const Scalar z49 = v_e_omega_x * z10;
    const Scalar z50 = n0_4 * z49;  // moment on blade_1, z
    const Scalar z51 = c_alpha * z14 + s_alpha * z22;
    const Scalar z52 = n0_4 * z51;
    const Scalar z53 = s_alpha * z14 - c_alpha * z22;
    const Scalar z54 = n0_4 * z22;
    const Scalar z55 = s_alpha * z54;
    const Scalar z56 = n665 * v_e_omega_z + z28 - z38 + z52 - z43;
    const Scalar z57 = s_alpha * z48;
    const Scalar z58 = n665 * z4 + z19 - z35 - z40 + z57;  // moment on rotor, x
    const Scalar z59 = c_alpha * z13 + s_alpha * z10;
    const Scalar z60 = s_alpha * z13 - c_alpha * z10;
    const Scalar z61 = s_alpha * z50;
    const Scalar z62 = n0_4 * z59;
    const Scalar z63 = n0_4 * z60;
    const Scalar z64 = n0_4 * z53;
    const Scalar z65 = n665 * z5 + z18 + z34 + z46 - z61;  // moment on rotor, y
    const Scalar z66 = n665 * v_e_omega_z - z29 + z39 + z55 - z62;
    const Scalar z67 = n665 * v_e_omega_y - z31 - n2 * z41 - z63;
    const Scalar z68 = n665 * v_e_omega_x + z32 - n2 * z42 - z64;
    const Scalar z69 = a_e_omega_x * m2 + z58;
    const Scalar z70 = a_e_omega_y * m3 + z65;
    const Scalar z71 = m5 * z56;
    const Scalar z72 = m6 * z66;
    const Scalar z73 = m6 * z67;
    const Scalar z74 = m5 * z68;
    result.M[0] = m2;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = -m3;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = -m4;
    result.C[0] = n0;
    result.C[1] = -z56;
    result.C[2] = n0;
    result.C[3] = z66;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = z67;
    result.C[7] = -z68;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.F[0] = -z69;
    result.F[1] = z70;
    result.F[2] = z44;
    result.A[0] = n0;
    result.A[1] = -v_e_omega_z;
    result.A[2] = v_e_omega_y;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = v_e_omega_z;
    result.A[7] = n0;
    result.A[8] = -v_e_omega_x;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = -v_e_omega_y;
    result.A[13] = v_e_omega_x;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = -z71;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = -z72;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = -z73;
    result.A[34] = -z74;
    result.A[35] = n0;
    if (!(traits::regular(m2, m2) && traits::regular(-m3, -m3) && traits::regular(-m4,
        -m4))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.M[4] * result.M[8] * result.C[1] * result.C[3] * result.C[6]
        * result.C[7] * result.F[0] * result.F[1] * result.F[2]) * (n0 * result.A[1] * result.A[2] * result.A[6]
        * result.A[8] * result.A[12] * result.A[13] * result.A[22] * result.A[27] * result.A[33] * result.A[34]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace four_blade_rotor
