// SPDX-License-Identifier: MIT
// turning_slot: Bead in a slot that turns in a vertical plane
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation
// Parameters set at run time: omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                1          0             0                  0       0      1       -
//   kinematics                0                0          0             0                  0       0      0       0
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                0          0             0                  0       0      0       0
//   inverse_dynamics          3                5          0             0                  1       0     10      10
//   forward_dynamics          5               16          0             0                  1       0     23      24
//   energy                    1                3          0             0                  0       0      4       4
//   constraints               7               16          0             0                  1       0     25      26
//   linearisation            10               33          6             0                  1       0     51      54
//
// Not computed because this mechanism does not need it:
//   kinematics: of 30 results 17 vanish identically, 4 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   bias: of 2 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, constraint 'slot' imposes a velocity (b is not zero)
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 22 results 11 vanish identically
//
// To write this file again:
//   turning_slot_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output turning_slot.hpp
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

namespace turning_slot {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "turning_slot";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x4f3d0be64b5f57e6ULL;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 1;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar N;  ///< of the constraint slot [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::N};
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
    Scalar m_e71b311a;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    parameters.omega = n2;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = parameters.omega;
    const Scalar z0 = n2 * p_omega;
    precomputed.m_e71b311a = z0;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar p_omega = parameters.omega;
    state.time = n0;
    state.q.x = n0_5;
    state.q.y = n0;
    state.v.x = n0;
    state.v.y = n0_5 * p_omega;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> bead_position;  ///< centre of mass of bead [m]
    std::array<Scalar, 9> bead_rotation;  ///< from the axes of bead to the ground's (3 x 3)
    std::array<Scalar, 3> bead_velocity;  ///< velocity of the centre of mass of bead [m/s]
    std::array<Scalar, 3> bead_angular_velocity;  ///< angular velocity of bead [rad/s]
    std::array<Scalar, 3> center_position;  ///< position of center [m]
    std::array<Scalar, 3> center_velocity;  ///< velocity of the material point at center [m/s]
    std::array<Scalar, 6> center_jacobian;  ///< partial velocities of center (3 x 2)
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
    std::array<Scalar, 1> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 1> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 2> jacobian;  ///< A, stored column by column (1 x 2)
    std::array<Scalar, 1> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 4> M;  ///< mass matrix (2 x 2)
    std::array<Scalar, 4> C;  ///< damping and gyroscopic terms (2 x 2)
    std::array<Scalar, 4> K;  ///< stiffness (2 x 2)
    std::array<Scalar, 2> F;  ///< right-hand side
    std::array<Scalar, 1> M_r;  ///< reduced mass matrix
    std::array<Scalar, 1> C_r;  ///< reduced damping and gyroscopic terms
    std::array<Scalar, 1> K_r;  ///< reduced stiffness
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, w): x' = A x + B du (2 x 2)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 1;
  static constexpr int independent_coordinates[] = {0};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[] = {0};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    result.bead_position[0] = q_x;
    result.bead_position[1] = q_y;
    result.bead_position[2] = n0;
    result.bead_rotation[0] = n1;
    result.bead_rotation[1] = n0;
    result.bead_rotation[2] = n0;
    result.bead_rotation[3] = n0;
    result.bead_rotation[4] = n1;
    result.bead_rotation[5] = n0;
    result.bead_rotation[6] = n0;
    result.bead_rotation[7] = n0;
    result.bead_rotation[8] = n1;
    result.bead_velocity[0] = v_x;
    result.bead_velocity[1] = v_y;
    result.bead_velocity[2] = n0;
    result.bead_angular_velocity[0] = n0;
    result.bead_angular_velocity[1] = n0;
    result.bead_angular_velocity[2] = n0;
    result.center_position[0] = q_x;
    result.center_position[1] = q_y;
    result.center_position[2] = n0;
    result.center_velocity[0] = v_x;
    result.center_velocity[1] = v_y;
    result.center_velocity[2] = n0;
    result.center_jacobian[0] = n1;
    result.center_jacobian[3] = n0;
    result.center_jacobian[1] = n0;
    result.center_jacobian[4] = n1;
    result.center_jacobian[2] = n0;
    result.center_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    mass[0] = n2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State&, GeneralizedForces& forces) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    forces.x = n0;
    forces.y = n19_62;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar l_N = multipliers.N;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = n9_81 + a_y;
    const Scalar z4 = n2 * a_x;  // force on bead, x
    const Scalar z5 = n2 * z3;  // force on bead, y
    forces.x = z4 + z1 * l_N;
    forces.y = z5 - z2 * l_N;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z2;
    const Scalar z5 = n0_5 * z2;
    const Scalar z6 = n0_5 * z1;
    const Scalar z7 = p_omega * z3;
    const Scalar z8 = p_omega * z4;
    const Scalar z9 = q_x * z7 - q_y * z8 - n2 * (v_x * z4 + v_y * z3);
    const Scalar z10 = n9_81 * z2 - z9;
    const Scalar z11 = n2 * z10;
    const Scalar z12 = z6 * z11;
    const Scalar z13 = n9_81 - z5 * z11;
    accelerations.x = -z12;
    accelerations.y = -z13;
    multipliers.N = z11;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * multipliers.N;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    result.kinetic = v_x * v_x + v_y * v_y;
    result.force_function = -n19_62 * q_y;
    result.power = n0;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z2;
    const Scalar z5 = q_x * z1 - q_y * z2;
    const Scalar z6 = v_x * z1 - v_y * z2 + q_x * z4 + q_y * z3;
    const Scalar z7 = p_omega * z3;
    const Scalar z8 = p_omega * z4;
    const Scalar z9 = q_x * z7 - q_y * z8 - n2 * (v_x * z4 + v_y * z3);
    result.value[0] = -z5;
    result.rate[0] = -z6;
    result.gamma[0] = z9;
    result.jacobian[0] = -z1;
    result.jacobian[1] = z2;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x,
  /// w those of the rates of x;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar l_N = multipliers.N;
    const Scalar m0 = precomputed.m_e71b311a;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z2;
    const Scalar z5 = n9_81 + a_y;
    const Scalar z6 = n2 / (z2 * z2);
    const Scalar z7 = n1 / z2;
    const Scalar z8 = p_omega / z2;
    const Scalar z9 = m0 / z2;
    const Scalar z10 = n2 * (a_x + z1 * z5 / z2);
    const Scalar z11 = n2 * a_x;  // force on bead, x
    const Scalar z12 = n2 * z5;  // force on bead, y
    const Scalar z13 = z2 * z2;
    const Scalar z14 = p_omega * z3;
    const Scalar z15 = p_omega * z4;
    const Scalar z16 = n2 * z3;
    const Scalar z17 = q_x * z14 - q_y * z15 - n2 * (v_x * z4 + v_y * z3);
    const Scalar z18 = z1 * z7;
    const Scalar z19 = z7 * z8;
    const Scalar z20 = z7 * z9;
    const Scalar z21 = z16 * z19;
    const Scalar z22 = n2 * z18;
    const Scalar z23 = n1 / z6;
    const Scalar z24 = a_x * z1 - z17 - a_y * z2;
    const Scalar z25 = z7 * z21;
    const Scalar z26 = z20 * z22;
    const Scalar z27 = z25 * z22;
    const Scalar z28 = z24 * z7;
    const Scalar z29 = z28 * z22;
    const Scalar z30 = z27 * z23;
    const Scalar z31 = z26 * z23;
    const Scalar z32 = z10 + z29;
    result.M[0] = n2;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n2;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.F[0] = -l_N * z1 - z11;
    result.F[1] = l_N * z2 - z12;
    result.M_r[0] = z6;
    result.C_r[0] = z26;
    result.K_r[0] = z27;
    result.F_r[0] = -z32;
    result.A[0] = n0;
    result.A[1] = -z30;
    result.A[2] = n1;
    result.A[3] = -z31;
    if (!(traits::regular(z13, n1) && traits::regular(z6, z6))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.F[0] * result.F[1] * result.M_r[0] * result.C_r[0] * result.K_r[0] * result.F_r[0]
        * result.A[1] * result.A[3];
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace turning_slot
