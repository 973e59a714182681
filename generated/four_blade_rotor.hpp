// SPDX-License-Identifier: MIT
// four_blade_rotor: Rotor of four blades set at a pitch, turning about its centre
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation
// Parameters set at run time: alpha
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               11                4          2             0                  1       0     19       -
//   kinematics               62              101          0             0                  0       0    163     193
//   mass_matrix               0                0          0             0                  0       0      0      16
//   bias                     16               34          0             0                  0       0     50      68
//   inverse_dynamics         18               37          0             0                  0       0     55      87
//   forward_dynamics         16               36          0             0                  0       0     52      86
//   energy                   17               23          0             0                  0       0     40      55
//   first_integrals          17               24          0             0                  0       0     41      62
//   linearisation            40               81          0             0                  0       0    121     171
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
  static constexpr unsigned long long fingerprint = 0x7d2c12a163ba1a17ULL;
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
    Scalar s_alpha;
    Scalar c_alpha;
    Scalar z237;
    Scalar z238;
    Scalar z239;
    Scalar z387;
    Scalar z388;
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
    const Scalar z224 = n0_4 * s_alpha;
    const Scalar z225 = n0_4 * c_alpha;
    const Scalar z226 = c_alpha * z225;
    const Scalar z227 = s_alpha * z224;
    const Scalar z229 = n665_8 - z226;
    const Scalar z230 = n1331_6 - z227;
    const Scalar z231 = n0_4 + z229;
    const Scalar z232 = n666_2 - z226;
    const Scalar z233 = z227 - z230;
    const Scalar z234 = z226 - z231;
    const Scalar z235 = n0_4 + z232;
    const Scalar z236 = z227 + z233;
    const Scalar z237 = n0_4 - z234;
    const Scalar z238 = z226 - z235;
    const Scalar z239 = z227 + z236;
    const Scalar z387 = n1 / z238;
    const Scalar z388 = n1 / z237;
    precomputed.s_alpha = s_alpha;
    precomputed.c_alpha = c_alpha;
    precomputed.z237 = z237;
    precomputed.z238 = z238;
    precomputed.z239 = z239;
    precomputed.z387 = z387;
    precomputed.z388 = z388;
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
    const Scalar z717 = n0_5 * (q_e_y * v_e_omega_y + q_e_z * v_e_omega_z + q_e_x * v_e_omega_x);
    const Scalar z718 = n0_5 * (q_e_y * v_e_omega_z - q_e_z * v_e_omega_y + q_e_w * v_e_omega_x);
    const Scalar z719 = n0_5 * (q_e_z * v_e_omega_x - q_e_x * v_e_omega_z + q_e_w * v_e_omega_y);
    const Scalar z720 = n0_5 * (q_e_y * v_e_omega_x - q_e_x * v_e_omega_y - q_e_w * v_e_omega_z);
    rates[0] = -z717;
    rates[1] = z718;
    rates[2] = z719;
    rates[3] = -z720;
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z126 = n2 * q_e_y;
    const Scalar z128 = n2 * q_e_z;
    const Scalar z135 = n2 * q_e_x;
    const Scalar z170 = v_e_omega_z * c_alpha;
    const Scalar z168 = v_e_omega_z * s_alpha;
    const Scalar z127 = q_e_y * z126;
    const Scalar z129 = q_e_z * z128;
    const Scalar z137 = q_e_z * z126;
    const Scalar z138 = q_e_w * z135;
    const Scalar z142 = q_e_x * z128;
    const Scalar z143 = q_e_w * z126;
    const Scalar z130 = q_e_x * z126;
    const Scalar z131 = q_e_w * z128;
    const Scalar z136 = q_e_x * z135;
    const Scalar z140 = z137 - z138;
    const Scalar z141 = z137 + z138;
    const Scalar z145 = z142 - z143;
    const Scalar z146 = z142 + z143;
    const Scalar z132 = n1 - z127 - z129;
    const Scalar z133 = z130 - z131;
    const Scalar z134 = z130 + z131;
    const Scalar z139 = n1 - z129 - z136;
    const Scalar z144 = n1 - z127 - z136;
    const Scalar z156 = s_alpha * z146;
    const Scalar z160 = s_alpha * z140;
    const Scalar z164 = c_alpha * z141;
    const Scalar z176 = c_alpha * z145;
    const Scalar z171 = v_e_omega_y * s_alpha - z170;
    const Scalar z181 = v_e_omega_x * s_alpha + z170;
    const Scalar z189 = v_e_omega_y * s_alpha + z170;
    const Scalar z197 = v_e_omega_x * s_alpha - z170;
    const Scalar z147 = v_e_omega_x * z132;  // angular velocity of e_omega_x, x
    const Scalar z148 = v_e_omega_x * z134;  // angular velocity of e_omega_x, y
    const Scalar z201 = n3 * z171;
    const Scalar z150 = v_e_omega_y * z133 + z147;  // angular velocity of e_omega_y, x
    const Scalar z151 = v_e_omega_y * z139 + z148;  // angular velocity of e_omega_y, y
    const Scalar z198 = n3 * z132;
    const Scalar z199 = n3 * z134;
    const Scalar z153 = v_e_omega_z * z146 + z150;  // angular velocity of rotor, x
    const Scalar z149 = v_e_omega_x * z145;  // angular velocity of e_omega_x, z
    const Scalar z154 = v_e_omega_z * z140 + z151;  // angular velocity of rotor, y
    const Scalar z158 = c_alpha * z146;
    const Scalar z162 = c_alpha * z140;
    const Scalar z166 = s_alpha * z141;
    const Scalar z209 = n3 * z181;
    const Scalar z152 = v_e_omega_y * z141 + z149;  // angular velocity of e_omega_y, z
    const Scalar z155 = v_e_omega_z * z144 + z152;  // angular velocity of rotor, z
    const Scalar z178 = s_alpha * z145;
    const Scalar z200 = n3 * z145;
    const Scalar z157 = c_alpha * z133 + z156;
    const Scalar z208 = n3 * z141;
    const Scalar z161 = c_alpha * z139 + z160;
    const Scalar z214 = n3 * z189;
    const Scalar z206 = n3 * z133;
    const Scalar z207 = n3 * z139;
    const Scalar z165 = s_alpha * z144 + z164;
    const Scalar z186 = s_alpha * z144 - z164;
    const Scalar z169 = v_e_omega_y * c_alpha + z168;
    const Scalar z202 = n3 * z169;
    const Scalar z172 = c_alpha * z132 - z156;
    const Scalar z174 = c_alpha * z134 - z160;
    const Scalar z177 = s_alpha * z144 - z176;
    const Scalar z194 = s_alpha * z144 + z176;
    const Scalar z180 = v_e_omega_x * c_alpha - z168;
    const Scalar z210 = n3 * z180;
    const Scalar z182 = c_alpha * z133 - z156;
    const Scalar z190 = c_alpha * z132 + z156;
    const Scalar z184 = c_alpha * z139 - z160;
    const Scalar z192 = c_alpha * z134 + z160;
    const Scalar z188 = v_e_omega_y * c_alpha - z168;
    const Scalar z196 = v_e_omega_x * c_alpha + z168;
    const Scalar z215 = n3 * z188;
    const Scalar z159 = s_alpha * z133 - z158;
    const Scalar z203 = z157 * z201 - z159 * z202;
    const Scalar z219 = n3 * z197;
    const Scalar z183 = s_alpha * z133 + z158;
    const Scalar z216 = z182 * z214 - z183 * z215;
    const Scalar z220 = n3 * z196;
    const Scalar z163 = s_alpha * z139 - z162;
    const Scalar z204 = z161 * z201 - z163 * z202;
    const Scalar z185 = s_alpha * z139 + z162;
    const Scalar z217 = z184 * z214 - z185 * z215;
    const Scalar z167 = c_alpha * z144 - z166;
    const Scalar z205 = z165 * z201 + z167 * z202;
    const Scalar z187 = c_alpha * z144 + z166;
    const Scalar z218 = z186 * z214 + z187 * z215;
    const Scalar z173 = s_alpha * z132 + z158;
    const Scalar z175 = s_alpha * z134 + z162;
    const Scalar z179 = c_alpha * z144 + z178;
    const Scalar z191 = s_alpha * z132 - z158;
    const Scalar z193 = s_alpha * z134 - z162;
    const Scalar z195 = c_alpha * z144 - z178;
    const Scalar z211 = z172 * z209 - z173 * z210;
    const Scalar z212 = z174 * z209 - z175 * z210;
    const Scalar z213 = z177 * z209 + z179 * z210;
    const Scalar z221 = z190 * z219 - z191 * z220;
    const Scalar z222 = z192 * z219 - z193 * z220;
    const Scalar z223 = z194 * z219 + z195 * z220;
    result.blade_1_position[0] = z198;
    result.blade_1_position[1] = z199;
    result.blade_1_position[2] = z200;
    result.blade_1_rotation[0] = z132;
    result.blade_1_rotation[1] = z134;
    result.blade_1_rotation[2] = z145;
    result.blade_1_rotation[3] = z157;
    result.blade_1_rotation[4] = z161;
    result.blade_1_rotation[5] = z165;
    result.blade_1_rotation[6] = -z159;
    result.blade_1_rotation[7] = -z163;
    result.blade_1_rotation[8] = z167;
    result.blade_1_velocity[0] = -z203;
    result.blade_1_velocity[1] = -z204;
    result.blade_1_velocity[2] = -z205;
    result.blade_1_angular_velocity[0] = z153;
    result.blade_1_angular_velocity[1] = z154;
    result.blade_1_angular_velocity[2] = z155;
    result.blade_2_position[0] = z206;
    result.blade_2_position[1] = z207;
    result.blade_2_position[2] = z208;
    result.blade_2_rotation[0] = z133;
    result.blade_2_rotation[1] = z139;
    result.blade_2_rotation[2] = z141;
    result.blade_2_rotation[3] = -z172;
    result.blade_2_rotation[4] = -z174;
    result.blade_2_rotation[5] = z177;
    result.blade_2_rotation[6] = z173;
    result.blade_2_rotation[7] = z175;
    result.blade_2_rotation[8] = z179;
    result.blade_2_velocity[0] = -z211;
    result.blade_2_velocity[1] = -z212;
    result.blade_2_velocity[2] = z213;
    result.blade_2_angular_velocity[0] = z153;
    result.blade_2_angular_velocity[1] = z154;
    result.blade_2_angular_velocity[2] = z155;
    result.blade_3_position[0] = -z198;
    result.blade_3_position[1] = -z199;
    result.blade_3_position[2] = -z200;
    result.blade_3_rotation[0] = -z132;
    result.blade_3_rotation[1] = -z134;
    result.blade_3_rotation[2] = -z145;
    result.blade_3_rotation[3] = -z182;
    result.blade_3_rotation[4] = -z184;
    result.blade_3_rotation[5] = z186;
    result.blade_3_rotation[6] = z183;
    result.blade_3_rotation[7] = z185;
    result.blade_3_rotation[8] = z187;
    result.blade_3_velocity[0] = -z216;
    result.blade_3_velocity[1] = -z217;
    result.blade_3_velocity[2] = z218;
    result.blade_3_angular_velocity[0] = z153;
    result.blade_3_angular_velocity[1] = z154;
    result.blade_3_angular_velocity[2] = z155;
    result.blade_4_position[0] = -z206;
    result.blade_4_position[1] = -z207;
    result.blade_4_position[2] = -z208;
    result.blade_4_rotation[0] = -z133;
    result.blade_4_rotation[1] = -z139;
    result.blade_4_rotation[2] = -z141;
    result.blade_4_rotation[3] = z190;
    result.blade_4_rotation[4] = z192;
    result.blade_4_rotation[5] = z194;
    result.blade_4_rotation[6] = -z191;
    result.blade_4_rotation[7] = -z193;
    result.blade_4_rotation[8] = z195;
    result.blade_4_velocity[0] = -z221;
    result.blade_4_velocity[1] = -z222;
    result.blade_4_velocity[2] = -z223;
    result.blade_4_angular_velocity[0] = z153;
    result.blade_4_angular_velocity[1] = z154;
    result.blade_4_angular_velocity[2] = z155;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State&,
      std::array<Scalar, 9>& mass) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    mass[0] = z237;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = -z238;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = -z239;
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z275 = v_e_omega_z * s_alpha;
    const Scalar z277 = v_e_omega_z * c_alpha;
    const Scalar z305 = v_e_omega_y * v_e_omega_z;
    const Scalar z306 = v_e_omega_x * v_e_omega_z;
    const Scalar z276 = v_e_omega_y * c_alpha + z275;
    const Scalar z278 = v_e_omega_y * s_alpha - z277;
    const Scalar z283 = v_e_omega_x * c_alpha + z275;
    const Scalar z284 = v_e_omega_x * s_alpha - z277;
    const Scalar z279 = v_e_omega_x * c_alpha - z275;
    const Scalar z285 = z283 * z284;
    const Scalar z300 = z276 * z278;
    const Scalar z280 = v_e_omega_x * s_alpha + z277;
    const Scalar z281 = v_e_omega_y * c_alpha - z275;
    const Scalar z282 = v_e_omega_y * s_alpha + z277;
    const Scalar z287 = n0_4 * z285;  // moment on blade_4, x
    const Scalar z302 = n0_4 * z300;  // moment on blade_1, x
    const Scalar z286 = v_e_omega_y * z283;
    const Scalar z290 = z281 * z282;
    const Scalar z291 = v_e_omega_x * z281;
    const Scalar z295 = z279 * z280;
    const Scalar z288 = n0_4 * z286;  // moment on blade_4, z
    const Scalar z292 = n0_4 * z290;  // moment on blade_3, x
    const Scalar z293 = n0_4 * z291;  // moment on blade_3, z
    const Scalar z296 = v_e_omega_y * z279;
    const Scalar z297 = n0_4 * z295;  // moment on blade_2, x
    const Scalar z301 = v_e_omega_x * z276;
    const Scalar z289 = s_alpha * z288;
    const Scalar z294 = s_alpha * z293;
    const Scalar z298 = n0_4 * z296;  // moment on blade_2, z
    const Scalar z303 = n0_4 * z301;  // moment on blade_1, z
    const Scalar z299 = s_alpha * z298;
    const Scalar z304 = s_alpha * z303;
    const Scalar z307 = z302 - n665 * z305 - z292 + z289 - z299;  // moment on rotor, x
    const Scalar z308 = z287 - n665 * z306 - z297 - z294 + z304;  // moment on rotor, y
    forces.e_omega_x = -z307;
    forces.e_omega_y = z308;
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z349 = v_e_omega_z * s_alpha;
    const Scalar z351 = v_e_omega_z * c_alpha;
    const Scalar z379 = v_e_omega_y * v_e_omega_z;
    const Scalar z380 = v_e_omega_x * v_e_omega_z;
    const Scalar z385 = a_e_omega_z * z239;
    const Scalar z350 = v_e_omega_y * c_alpha + z349;
    const Scalar z352 = v_e_omega_y * s_alpha - z351;
    const Scalar z357 = v_e_omega_x * c_alpha + z349;
    const Scalar z358 = v_e_omega_x * s_alpha - z351;
    const Scalar z353 = v_e_omega_x * c_alpha - z349;
    const Scalar z359 = z357 * z358;
    const Scalar z374 = z350 * z352;
    const Scalar z354 = v_e_omega_x * s_alpha + z351;
    const Scalar z355 = v_e_omega_y * c_alpha - z349;
    const Scalar z356 = v_e_omega_y * s_alpha + z351;
    const Scalar z361 = n0_4 * z359;  // moment on blade_4, x
    const Scalar z376 = n0_4 * z374;  // moment on blade_1, x
    const Scalar z360 = v_e_omega_y * z357;
    const Scalar z364 = z355 * z356;
    const Scalar z365 = v_e_omega_x * z355;
    const Scalar z369 = z353 * z354;
    const Scalar z362 = n0_4 * z360;  // moment on blade_4, z
    const Scalar z366 = n0_4 * z364;  // moment on blade_3, x
    const Scalar z367 = n0_4 * z365;  // moment on blade_3, z
    const Scalar z370 = v_e_omega_y * z353;
    const Scalar z371 = n0_4 * z369;  // moment on blade_2, x
    const Scalar z375 = v_e_omega_x * z350;
    const Scalar z363 = s_alpha * z362;
    const Scalar z368 = s_alpha * z367;
    const Scalar z372 = n0_4 * z370;  // moment on blade_2, z
    const Scalar z377 = n0_4 * z375;  // moment on blade_1, z
    const Scalar z373 = s_alpha * z372;
    const Scalar z378 = s_alpha * z377;
    const Scalar z381 = z376 - n665 * z379 - z366 + z363 - z373;  // moment on rotor, x
    const Scalar z382 = z361 - n665 * z380 - z371 - z368 + z378;  // moment on rotor, y
    const Scalar z383 = a_e_omega_x * z237 - z381;
    const Scalar z384 = a_e_omega_y * z238 - z382;
    forces.e_omega_x = z383;
    forces.e_omega_y = -z384;
    forces.e_omega_z = -z385;
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z387 = precomputed.z387;
    const Scalar z388 = precomputed.z388;
    const Scalar z406 = v_e_omega_z * s_alpha;
    const Scalar z408 = v_e_omega_z * c_alpha;
    const Scalar z436 = v_e_omega_y * v_e_omega_z;
    const Scalar z437 = v_e_omega_x * v_e_omega_z;
    const Scalar z407 = v_e_omega_y * c_alpha + z406;
    const Scalar z409 = v_e_omega_y * s_alpha - z408;
    const Scalar z414 = v_e_omega_x * c_alpha + z406;
    const Scalar z415 = v_e_omega_x * s_alpha - z408;
    const Scalar z410 = v_e_omega_x * c_alpha - z406;
    const Scalar z416 = z414 * z415;
    const Scalar z431 = z407 * z409;
    const Scalar z411 = v_e_omega_x * s_alpha + z408;
    const Scalar z412 = v_e_omega_y * c_alpha - z406;
    const Scalar z413 = v_e_omega_y * s_alpha + z408;
    const Scalar z418 = n0_4 * z416;  // moment on blade_4, x
    const Scalar z433 = n0_4 * z431;  // moment on blade_1, x
    const Scalar z417 = v_e_omega_y * z414;
    const Scalar z421 = z412 * z413;
    const Scalar z422 = v_e_omega_x * z412;
    const Scalar z426 = z410 * z411;
    const Scalar z419 = n0_4 * z417;  // moment on blade_4, z
    const Scalar z423 = n0_4 * z421;  // moment on blade_3, x
    const Scalar z424 = n0_4 * z422;  // moment on blade_3, z
    const Scalar z427 = v_e_omega_y * z410;
    const Scalar z428 = n0_4 * z426;  // moment on blade_2, x
    const Scalar z432 = v_e_omega_x * z407;
    const Scalar z420 = s_alpha * z419;
    const Scalar z425 = s_alpha * z424;
    const Scalar z429 = n0_4 * z427;  // moment on blade_2, z
    const Scalar z434 = n0_4 * z432;  // moment on blade_1, z
    const Scalar z430 = s_alpha * z429;
    const Scalar z435 = s_alpha * z434;
    const Scalar z438 = z433 - n665 * z436 - z423 + z420 - z430;  // moment on rotor, x
    const Scalar z439 = z418 - n665 * z437 - z428 - z425 + z435;  // moment on rotor, y
    const Scalar z440 = z387 * z439;
    const Scalar z441 = z388 * z438;
    accelerations.e_omega_x = z441;
    accelerations.e_omega_y = z440;
    accelerations.e_omega_z = n0;
    if (!(traits::regular(-z239, -z239) && traits::regular(-z238, -z238) && traits::regular(z237,
        z237))) return torsor::Status::singular;
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z454 = v_e_omega_z * s_alpha;
    const Scalar z456 = v_e_omega_z * c_alpha;
    const Scalar z455 = v_e_omega_y * c_alpha + z454;
    const Scalar z457 = v_e_omega_y * s_alpha - z456;
    const Scalar z458 = v_e_omega_x * c_alpha - z454;
    const Scalar z459 = v_e_omega_x * s_alpha + z456;
    const Scalar z460 = v_e_omega_y * c_alpha - z454;
    const Scalar z461 = v_e_omega_y * s_alpha + z456;
    const Scalar z462 = v_e_omega_x * c_alpha + z454;
    const Scalar z463 = v_e_omega_x * s_alpha - z456;
    result.kinetic = n0_4 * (v_e_omega_x * v_e_omega_x + v_e_omega_y * v_e_omega_y) + n166_25 * (z455 * z455 + z458
        * z458 + z460 * z460 + z462 * z462) + n166_45 * (z457 * z457 + z459 * z459 + z461 * z461 + z463 * z463);
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z239 = precomputed.z239;
    const Scalar z484 = v_e_omega_z * s_alpha;
    const Scalar z486 = v_e_omega_z * c_alpha;
    const Scalar z485 = v_e_omega_y * c_alpha + z484;
    const Scalar z487 = v_e_omega_y * s_alpha - z486;
    const Scalar z488 = v_e_omega_x * c_alpha - z484;
    const Scalar z489 = v_e_omega_x * s_alpha + z486;
    const Scalar z490 = v_e_omega_y * c_alpha - z484;
    const Scalar z491 = v_e_omega_y * s_alpha + z486;
    const Scalar z492 = v_e_omega_x * c_alpha + z484;
    const Scalar z493 = v_e_omega_x * s_alpha - z486;
    result.energy = n0_4 * (v_e_omega_x * v_e_omega_x + v_e_omega_y * v_e_omega_y) + n166_25 * (z485 * z485 + z488
        * z488 + z490 * z490 + z492 * z492) + n166_45 * (z487 * z487 + z489 * z489 + z491 * z491 + z493 * z493);
    result.momentum_e_omega_z = -v_e_omega_z * z239;
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
    const Scalar s_alpha = precomputed.s_alpha;
    const Scalar c_alpha = precomputed.c_alpha;
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z387 = precomputed.z387;
    const Scalar z388 = precomputed.z388;
    const Scalar z642 = v_e_omega_z * s_alpha;
    const Scalar z644 = v_e_omega_y * s_alpha;
    const Scalar z645 = v_e_omega_z * c_alpha;
    const Scalar z648 = v_e_omega_x * s_alpha;
    const Scalar z674 = v_e_omega_y * v_e_omega_z;
    const Scalar z675 = v_e_omega_x * v_e_omega_z;
    const Scalar z651 = z644 + z645;
    const Scalar z653 = z645 - z648;
    const Scalar z643 = v_e_omega_y * c_alpha + z642;
    const Scalar z646 = z644 - z645;
    const Scalar z652 = v_e_omega_x * c_alpha + z642;
    const Scalar z650 = v_e_omega_y * c_alpha - z642;
    const Scalar z654 = z652 * z653;
    const Scalar z669 = z643 * z646;
    const Scalar z647 = v_e_omega_x * c_alpha - z642;
    const Scalar z649 = z645 + z648;
    const Scalar z683 = n0_4 * z650;
    const Scalar z690 = n0_4 * z652;
    const Scalar z656 = n0_4 * z654;  // moment on blade_4, x
    const Scalar z671 = n0_4 * z669;  // moment on blade_1, x
    const Scalar z701 = s_alpha * z651 - c_alpha * z650;
    const Scalar z706 = s_alpha * z653 + c_alpha * z652;
    const Scalar z655 = v_e_omega_y * z652;
    const Scalar z659 = z650 * z651;
    const Scalar z681 = s_alpha * z652 - c_alpha * z653;
    const Scalar z660 = v_e_omega_x * z650;
    const Scalar z692 = c_alpha * z651 + s_alpha * z650;
    const Scalar z664 = z647 * z649;
    const Scalar z684 = s_alpha * z683;
    const Scalar z691 = s_alpha * z690;
    const Scalar z702 = n0_4 * z701;
    const Scalar z707 = n0_4 * z706;
    const Scalar z657 = n0_4 * z655;  // moment on blade_4, z
    const Scalar z661 = n0_4 * z659;  // moment on blade_3, x
    const Scalar z662 = n0_4 * z660;  // moment on blade_3, z
    const Scalar z666 = n0_4 * z664;  // moment on blade_2, x
    const Scalar z699 = n0_4 * z644;
    const Scalar z708 = n0_4 * z648;
    const Scalar z693 = n0_4 * z692;
    const Scalar z658 = s_alpha * z657;
    const Scalar z663 = s_alpha * z662;
    const Scalar z700 = s_alpha * z699;
    const Scalar z709 = s_alpha * z708;
    const Scalar z682 = n0_4 * z681;
    const Scalar z680 = a_e_omega_z * z239;
    const Scalar z687 = n0_4 * z643;
    const Scalar z688 = s_alpha * z687;
    const Scalar z665 = v_e_omega_y * z647;
    const Scalar z667 = n0_4 * z665;  // moment on blade_2, z
    const Scalar z670 = v_e_omega_x * z643;
    const Scalar z672 = n0_4 * z670;  // moment on blade_1, z
    const Scalar z685 = c_alpha * z649 + s_alpha * z647;
    const Scalar z686 = n0_4 * z685;
    const Scalar z710 = s_alpha * z649 - c_alpha * z647;
    const Scalar z694 = n0_4 * z647;
    const Scalar z695 = s_alpha * z694;
    const Scalar z689 = n665 * v_e_omega_z + z684 - z688 + z686 - z682;
    const Scalar z668 = s_alpha * z667;
    const Scalar z676 = z671 - n665 * z674 - z661 + z658 - z668;  // moment on rotor, x
    const Scalar z696 = c_alpha * z646 + s_alpha * z643;
    const Scalar z703 = s_alpha * z646 - c_alpha * z643;
    const Scalar z673 = s_alpha * z672;
    const Scalar z697 = n0_4 * z696;
    const Scalar z704 = n0_4 * z703;
    const Scalar z711 = n0_4 * z710;
    const Scalar z677 = n665 * z675 + z656 + z666 + z663 - z673;  // moment on rotor, y
    const Scalar z698 = n665 * v_e_omega_z - z691 + z693 + z695 - z697;
    const Scalar z705 = n665 * v_e_omega_y - z702 - n2 * z700 - z704;
    const Scalar z712 = n665 * v_e_omega_x + z707 - n2 * z709 - z711;
    const Scalar z678 = a_e_omega_x * z237 - z676;
    const Scalar z679 = a_e_omega_y * z238 + z677;
    const Scalar z713 = z387 * z689;
    const Scalar z714 = z388 * z698;
    const Scalar z715 = z388 * z705;
    const Scalar z716 = z387 * z712;
    result.M[0] = z237;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = -z238;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = -z239;
    result.C[0] = n0;
    result.C[1] = -z689;
    result.C[2] = n0;
    result.C[3] = z698;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = z705;
    result.C[7] = -z712;
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
    result.F[0] = -z678;
    result.F[1] = z679;
    result.F[2] = z680;
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
    result.A[22] = -z713;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = -z714;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = -z715;
    result.A[34] = -z716;
    result.A[35] = n0;
    if (!(traits::regular(z237, z237) && traits::regular(-z238, -z238) && traits::regular(-z239,
        -z239))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.M[4] * result.M[8] * result.C[1] * result.C[3] * result.C[6]
        * result.C[7] * result.F[0] * result.F[1] * result.F[2]) * (n0 * result.A[1] * result.A[2] * result.A[6]
        * result.A[8] * result.A[12] * result.A[13] * result.A[22] * result.A[27] * result.A[33] * result.A[34]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace four_blade_rotor
