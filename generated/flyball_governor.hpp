// SPDX-License-Identifier: MIT
// flyball_governor: Stiff flyball governor (IFToMM benchmark A05)
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation, residual, residual_jacobian
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function           additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                30               57          0             0                  3       0     93      93
//   mass_matrix                4                8          0             0                  2       0     16      21
//   bias                      34               79          4             2                  2       0    123     126
//   inverse_dynamics          42               91          4             2                  2       0    143     151
//   forward_dynamics          38               91          5             2                  2       0    140     148
//   energy                    32               64          2             2                  2       0    104     116
//   first_integrals            4                9          0             0                  2       0     17      22
//   linearisation            119              293         25             2                  2       0    443     482
//   residual                  42               91          4             2                  2       0    143     151
//   residual_jacobian         98              241         24             2                  2       0    369     403
//
// Not computed because this mechanism does not need it:
//   kinematics: of 180 results 57 vanish identically, 63 repeat another up to sign
//   mass_matrix: of 16 results 12 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 116 results 62 vanish identically
//
// To write this file again:
//   flyball_governor_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,residual,residual_jacobian --output flyball_governor.hpp
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

namespace flyball_governor {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "flyball_governor";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xec72f646c207d023ULL;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 4;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar s;  ///< coordinate [m]
    Scalar beta_1;  ///< coordinate [rad or 1]
    Scalar beta_2;  ///< coordinate [rad or 1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::psi, &Coordinates::s, &Coordinates::beta_1,
          &Coordinates::beta_2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar psi;  ///< its rate [rad/s]
    Scalar s;  ///< its rate [m/s]
    Scalar beta_1;  ///< its rate [rad/s]
    Scalar beta_2;  ///< its rate [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::psi, &Velocities::s, &Velocities::beta_1,
          &Velocities::beta_2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar s;  ///< its second rate [m/s^2]
    Scalar beta_1;  ///< its second rate [rad/s^2]
    Scalar beta_2;  ///< its second rate [rad/s^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::psi, &Accelerations::s, &Accelerations::beta_1,
          &Accelerations::beta_2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar s;  ///< works with the rate of s [N]
    Scalar beta_1;  ///< works with the rate of beta_1 [N m]
    Scalar beta_2;  ///< works with the rate of beta_2 [N m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::psi, &GeneralizedForces::s,
          &GeneralizedForces::beta_1, &GeneralizedForces::beta_2};
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar pi = traits::pi();
    state.time = n0;
    state.q.psi = n0;
    state.q.s = n0_5;
    state.q.beta_1 = n1_over_6 * pi;
    state.q.beta_2 = state.q.beta_1;
    state.v.psi = n2 * pi;
    state.v.s = n0;
    state.v.beta_1 = n0;
    state.v.beta_2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> shaft_position;  ///< centre of mass of shaft [m]
    std::array<Scalar, 9> shaft_rotation;  ///< from the axes of shaft to the ground's (3 x 3)
    std::array<Scalar, 3> shaft_velocity;  ///< velocity of the centre of mass of shaft [m/s]
    std::array<Scalar, 3> shaft_angular_velocity;  ///< angular velocity of shaft [rad/s]
    std::array<Scalar, 3> slider_position;  ///< centre of mass of slider [m]
    std::array<Scalar, 9> slider_rotation;  ///< from the axes of slider to the ground's (3 x 3)
    std::array<Scalar, 3> slider_velocity;  ///< velocity of the centre of mass of slider [m/s]
    std::array<Scalar, 3> slider_angular_velocity;  ///< angular velocity of slider [rad/s]
    std::array<Scalar, 3> rod_1_position;  ///< centre of mass of rod_1 [m]
    std::array<Scalar, 9> rod_1_rotation;  ///< from the axes of rod_1 to the ground's (3 x 3)
    std::array<Scalar, 3> rod_1_velocity;  ///< velocity of the centre of mass of rod_1 [m/s]
    std::array<Scalar, 3> rod_1_angular_velocity;  ///< angular velocity of rod_1 [rad/s]
    std::array<Scalar, 3> ball_1_position;  ///< centre of mass of ball_1 [m]
    std::array<Scalar, 9> ball_1_rotation;  ///< from the axes of ball_1 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_1_velocity;  ///< velocity of the centre of mass of ball_1 [m/s]
    std::array<Scalar, 3> ball_1_angular_velocity;  ///< angular velocity of ball_1 [rad/s]
    std::array<Scalar, 3> rod_2_position;  ///< centre of mass of rod_2 [m]
    std::array<Scalar, 9> rod_2_rotation;  ///< from the axes of rod_2 to the ground's (3 x 3)
    std::array<Scalar, 3> rod_2_velocity;  ///< velocity of the centre of mass of rod_2 [m/s]
    std::array<Scalar, 3> rod_2_angular_velocity;  ///< angular velocity of rod_2 [rad/s]
    std::array<Scalar, 3> ball_2_position;  ///< centre of mass of ball_2 [m]
    std::array<Scalar, 9> ball_2_rotation;  ///< from the axes of ball_2 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_2_velocity;  ///< velocity of the centre of mass of ball_2 [m/s]
    std::array<Scalar, 3> ball_2_angular_velocity;  ///< angular velocity of ball_2 [rad/s]
    std::array<Scalar, 3> middle_1_position;  ///< position of middle_1 [m]
    std::array<Scalar, 3> middle_1_velocity;  ///< velocity of the material point at middle_1 [m/s]
    std::array<Scalar, 12> middle_1_jacobian;  ///< partial velocities of middle_1 (3 x 4)
    std::array<Scalar, 3> ear_1_position;  ///< position of ear_1 [m]
    std::array<Scalar, 3> ear_1_velocity;  ///< velocity of the material point at ear_1 [m/s]
    std::array<Scalar, 12> ear_1_jacobian;  ///< partial velocities of ear_1 (3 x 4)
    std::array<Scalar, 3> middle_2_position;  ///< position of middle_2 [m]
    std::array<Scalar, 3> middle_2_velocity;  ///< velocity of the material point at middle_2 [m/s]
    std::array<Scalar, 12> middle_2_jacobian;  ///< partial velocities of middle_2 (3 x 4)
    std::array<Scalar, 3> ear_2_position;  ///< position of ear_2 [m]
    std::array<Scalar, 3> ear_2_velocity;  ///< velocity of the material point at ear_2 [m/s]
    std::array<Scalar, 12> ear_2_jacobian;  ///< partial velocities of ear_2 (3 x 4)
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
    Scalar momentum_psi;  ///< dT/dpsi' of the cyclic coordinate 'psi' [kg m^2 s^-1]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::momentum_psi};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 16> M;  ///< mass matrix (4 x 4)
    std::array<Scalar, 16> C;  ///< damping and gyroscopic terms (4 x 4)
    std::array<Scalar, 16> K;  ///< stiffness (4 x 4)
    std::array<Scalar, 4> F;  ///< right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, e'): x' = A x + B du (8 x 8)
  };

  /// Derivatives of the residual in compressed rows.
  struct ResidualJacobian {
    std::array<Scalar, 25> values;  ///< entries, row by row
  };
  /// Where the values of ResidualJacobian stand: those of row i from row_start[i] to row_start[i + 1], each in its
  /// column: of unknown j by position j, by velocity n + j, by acceleration 2 n + j, by multiplier k 3 n + k.
  static constexpr int residual_jacobian_nonzeros = 25;
  static constexpr int residual_jacobian_row_start[] = {0, 6, 13, 19, 25};
  static constexpr int residual_jacobian_column[] = {2, 3, 4, 6, 7, 8, 1, 2, 3, 5, 6, 7, 9, 1, 2, 4, 5, 6, 10, 1, 3, 4,
      5, 7, 11};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_psi, q_beta_1, q_beta_2};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_beta_1 = sines_[1], c_beta_1 = cosines_[1];
    const Scalar s_beta_2 = sines_[2], c_beta_2 = cosines_[2];
    const Scalar z24 = n0_05 * v_psi;
    const Scalar z20 = s_psi * c_beta_1;
    const Scalar z33 = s_psi * c_beta_2;
    const Scalar z19 = c_psi * s_beta_1;
    const Scalar z21 = s_psi * s_beta_1;
    const Scalar z26 = v_psi * c_beta_1;
    const Scalar z29 = s_psi * z24;  // velocity of rod_1, x
    const Scalar z30 = c_psi * z24;  // velocity of rod_1, y
    const Scalar z32 = c_psi * s_beta_2;
    const Scalar z34 = s_psi * s_beta_2;
    const Scalar z36 = v_psi * c_beta_2;
    const Scalar z46 = n0_5 * v_beta_1;
    const Scalar z63 = n0_5 * v_beta_2;
    const Scalar z18 = c_psi * c_beta_1;
    const Scalar z31 = c_psi * c_beta_2;
    const Scalar z22 = n0_05 * c_psi;
    const Scalar z23 = n0_05 * s_psi;
    const Scalar z41 = n0_5 * s_beta_1;
    const Scalar z58 = n0_5 * s_beta_2;
    const Scalar z27 = s_psi * v_beta_1;  // angular velocity of rod_1, x
    const Scalar z28 = c_psi * v_beta_1;  // angular velocity of rod_1, y
    const Scalar z37 = s_psi * v_beta_2;  // angular velocity of rod_2, x
    const Scalar z38 = c_psi * v_beta_2;  // angular velocity of rod_2, y
    const Scalar z49 = c_beta_1 * z46;
    const Scalar z52 = n1 - s_beta_1;
    const Scalar z55 = v_beta_1 * c_beta_1;
    const Scalar z66 = c_beta_2 * z63;
    const Scalar z69 = n1 - s_beta_2;
    const Scalar z72 = v_beta_2 * c_beta_2;
    const Scalar z39 = n0_5 * z18;
    const Scalar z40 = n0_5 * z20;
    const Scalar z44 = n1 - z41;
    const Scalar z45 = n0_5 * z26;
    const Scalar z50 = z18 + z22;
    const Scalar z51 = z20 + z23;
    const Scalar z53 = z29 + s_psi * z26 + v_beta_1 * z19;
    const Scalar z54 = z30 + c_psi * z26 - v_beta_1 * z21;
    const Scalar z56 = n0_5 * z31;
    const Scalar z57 = n0_5 * z33;
    const Scalar z61 = n1 - z58;
    const Scalar z62 = n0_5 * z36;
    const Scalar z67 = z22 + z31;
    const Scalar z68 = z23 + z33;
    const Scalar z70 = z29 + s_psi * z36 + v_beta_2 * z32;
    const Scalar z71 = z30 + c_psi * z36 - v_beta_2 * z34;
    const Scalar z73 = c_psi * z41;
    const Scalar z74 = s_psi * z41;
    const Scalar z76 = c_psi * z58;
    const Scalar z77 = s_psi * z58;
    const Scalar z42 = z22 + z39;
    const Scalar z43 = z23 + z40;
    const Scalar z47 = z19 * z46 + z29 + s_psi * z45;
    const Scalar z48 = z30 - z21 * z46 + c_psi * z45;
    const Scalar z59 = z22 + z56;
    const Scalar z60 = z23 + z57;
    const Scalar z64 = z29 + z32 * z63 + s_psi * z62;
    const Scalar z65 = z30 - z34 * z63 + c_psi * z62;
    const Scalar z75 = s_psi * z40 + c_psi * z39;
    const Scalar z78 = s_psi * z57 + c_psi * z56;
    result.shaft_position[0] = n0;
    result.shaft_position[1] = n0;
    result.shaft_position[2] = n0_5;
    result.shaft_rotation[0] = c_psi;
    result.shaft_rotation[1] = s_psi;
    result.shaft_rotation[2] = n0;
    result.shaft_rotation[3] = -s_psi;
    result.shaft_rotation[4] = c_psi;
    result.shaft_rotation[5] = n0;
    result.shaft_rotation[6] = n0;
    result.shaft_rotation[7] = n0;
    result.shaft_rotation[8] = n1;
    result.shaft_velocity[0] = n0;
    result.shaft_velocity[1] = n0;
    result.shaft_velocity[2] = n0;
    result.shaft_angular_velocity[0] = n0;
    result.shaft_angular_velocity[1] = n0;
    result.shaft_angular_velocity[2] = v_psi;
    result.slider_position[0] = n0;
    result.slider_position[1] = n0;
    result.slider_position[2] = q_s;
    result.slider_rotation[0] = c_psi;
    result.slider_rotation[1] = s_psi;
    result.slider_rotation[2] = n0;
    result.slider_rotation[3] = -s_psi;
    result.slider_rotation[4] = c_psi;
    result.slider_rotation[5] = n0;
    result.slider_rotation[6] = n0;
    result.slider_rotation[7] = n0;
    result.slider_rotation[8] = n1;
    result.slider_velocity[0] = n0;
    result.slider_velocity[1] = n0;
    result.slider_velocity[2] = v_s;
    result.slider_angular_velocity[0] = n0;
    result.slider_angular_velocity[1] = n0;
    result.slider_angular_velocity[2] = v_psi;
    result.rod_1_position[0] = z42;
    result.rod_1_position[1] = z43;
    result.rod_1_position[2] = z44;
    result.rod_1_rotation[0] = z18;
    result.rod_1_rotation[1] = z20;
    result.rod_1_rotation[2] = -s_beta_1;
    result.rod_1_rotation[3] = -s_psi;
    result.rod_1_rotation[4] = c_psi;
    result.rod_1_rotation[5] = n0;
    result.rod_1_rotation[6] = z19;
    result.rod_1_rotation[7] = z21;
    result.rod_1_rotation[8] = c_beta_1;
    result.rod_1_velocity[0] = -z47;
    result.rod_1_velocity[1] = z48;
    result.rod_1_velocity[2] = -z49;
    result.rod_1_angular_velocity[0] = -z27;
    result.rod_1_angular_velocity[1] = z28;
    result.rod_1_angular_velocity[2] = v_psi;
    result.ball_1_position[0] = z50;
    result.ball_1_position[1] = z51;
    result.ball_1_position[2] = z52;
    result.ball_1_rotation[0] = z18;
    result.ball_1_rotation[1] = z20;
    result.ball_1_rotation[2] = -s_beta_1;
    result.ball_1_rotation[3] = -s_psi;
    result.ball_1_rotation[4] = c_psi;
    result.ball_1_rotation[5] = n0;
    result.ball_1_rotation[6] = z19;
    result.ball_1_rotation[7] = z21;
    result.ball_1_rotation[8] = c_beta_1;
    result.ball_1_velocity[0] = -z53;
    result.ball_1_velocity[1] = z54;
    result.ball_1_velocity[2] = -z55;
    result.ball_1_angular_velocity[0] = -z27;
    result.ball_1_angular_velocity[1] = z28;
    result.ball_1_angular_velocity[2] = v_psi;
    result.rod_2_position[0] = -z59;
    result.rod_2_position[1] = -z60;
    result.rod_2_position[2] = z61;
    result.rod_2_rotation[0] = z31;
    result.rod_2_rotation[1] = z33;
    result.rod_2_rotation[2] = s_beta_2;
    result.rod_2_rotation[3] = -s_psi;
    result.rod_2_rotation[4] = c_psi;
    result.rod_2_rotation[5] = n0;
    result.rod_2_rotation[6] = -z32;
    result.rod_2_rotation[7] = -z34;
    result.rod_2_rotation[8] = c_beta_2;
    result.rod_2_velocity[0] = z64;
    result.rod_2_velocity[1] = -z65;
    result.rod_2_velocity[2] = -z66;
    result.rod_2_angular_velocity[0] = z37;
    result.rod_2_angular_velocity[1] = -z38;
    result.rod_2_angular_velocity[2] = v_psi;
    result.ball_2_position[0] = -z67;
    result.ball_2_position[1] = -z68;
    result.ball_2_position[2] = z69;
    result.ball_2_rotation[0] = z31;
    result.ball_2_rotation[1] = z33;
    result.ball_2_rotation[2] = s_beta_2;
    result.ball_2_rotation[3] = -s_psi;
    result.ball_2_rotation[4] = c_psi;
    result.ball_2_rotation[5] = n0;
    result.ball_2_rotation[6] = -z32;
    result.ball_2_rotation[7] = -z34;
    result.ball_2_rotation[8] = c_beta_2;
    result.ball_2_velocity[0] = z70;
    result.ball_2_velocity[1] = -z71;
    result.ball_2_velocity[2] = -z72;
    result.ball_2_angular_velocity[0] = z37;
    result.ball_2_angular_velocity[1] = -z38;
    result.ball_2_angular_velocity[2] = v_psi;
    result.middle_1_position[0] = z42;
    result.middle_1_position[1] = z43;
    result.middle_1_position[2] = z44;
    result.middle_1_velocity[0] = -z47;
    result.middle_1_velocity[1] = z48;
    result.middle_1_velocity[2] = -z49;
    result.middle_1_jacobian[0] = -z43;
    result.middle_1_jacobian[3] = n0;
    result.middle_1_jacobian[6] = -z73;
    result.middle_1_jacobian[9] = n0;
    result.middle_1_jacobian[1] = z42;
    result.middle_1_jacobian[4] = n0;
    result.middle_1_jacobian[7] = -z74;
    result.middle_1_jacobian[10] = n0;
    result.middle_1_jacobian[2] = n0;
    result.middle_1_jacobian[5] = n0;
    result.middle_1_jacobian[8] = -z75;
    result.middle_1_jacobian[11] = n0;
    result.ear_1_position[0] = z22;
    result.ear_1_position[1] = z23;
    result.ear_1_position[2] = q_s;
    result.ear_1_velocity[0] = -z29;
    result.ear_1_velocity[1] = z30;
    result.ear_1_velocity[2] = v_s;
    result.ear_1_jacobian[0] = -z23;
    result.ear_1_jacobian[3] = n0;
    result.ear_1_jacobian[6] = n0;
    result.ear_1_jacobian[9] = n0;
    result.ear_1_jacobian[1] = z22;
    result.ear_1_jacobian[4] = n0;
    result.ear_1_jacobian[7] = n0;
    result.ear_1_jacobian[10] = n0;
    result.ear_1_jacobian[2] = n0;
    result.ear_1_jacobian[5] = n1;
    result.ear_1_jacobian[8] = n0;
    result.ear_1_jacobian[11] = n0;
    result.middle_2_position[0] = -z59;
    result.middle_2_position[1] = -z60;
    result.middle_2_position[2] = z61;
    result.middle_2_velocity[0] = z64;
    result.middle_2_velocity[1] = -z65;
    result.middle_2_velocity[2] = -z66;
    result.middle_2_jacobian[0] = z60;
    result.middle_2_jacobian[3] = n0;
    result.middle_2_jacobian[6] = n0;
    result.middle_2_jacobian[9] = z76;
    result.middle_2_jacobian[1] = -z59;
    result.middle_2_jacobian[4] = n0;
    result.middle_2_jacobian[7] = n0;
    result.middle_2_jacobian[10] = z77;
    result.middle_2_jacobian[2] = n0;
    result.middle_2_jacobian[5] = n0;
    result.middle_2_jacobian[8] = n0;
    result.middle_2_jacobian[11] = -z78;
    result.ear_2_position[0] = -z22;
    result.ear_2_position[1] = -z23;
    result.ear_2_position[2] = q_s;
    result.ear_2_velocity[0] = z29;
    result.ear_2_velocity[1] = -z30;
    result.ear_2_velocity[2] = v_s;
    result.ear_2_jacobian[0] = z23;
    result.ear_2_jacobian[3] = n0;
    result.ear_2_jacobian[6] = n0;
    result.ear_2_jacobian[9] = n0;
    result.ear_2_jacobian[1] = -z22;
    result.ear_2_jacobian[4] = n0;
    result.ear_2_jacobian[7] = n0;
    result.ear_2_jacobian[10] = n0;
    result.ear_2_jacobian[2] = n0;
    result.ear_2_jacobian[5] = n1;
    result.ear_2_jacobian[8] = n0;
    result.ear_2_jacobian[11] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 16>& mass) noexcept {
    const Scalar k0 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k3 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k6 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_beta_1 = cosines_[0];
    const Scalar c_beta_2 = cosines_[1];
    const Scalar z83 = k0 * c_beta_2;
    const Scalar z80 = n5_15 * c_beta_2;
    const Scalar z97 = k0 * c_beta_1;
    const Scalar z94 = n5_15 * c_beta_1;
    const Scalar z84 = c_beta_2 * z83;
    const Scalar z98 = c_beta_1 * z97;
    const Scalar z90 = n0_1 * z80 + z84;
    const Scalar z104 = n0_1 * z94 + z98;
    const Scalar z92 = k3 + z90;
    const Scalar z110 = z92 + z104;
    mass[0] = z110;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n3;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = k6;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = k6;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar k6 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar n5_1 = traits::constant(5.1, 5.1f, "51/10");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar k11 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z116 = n1 - q_s;
    const Scalar z133 = v_beta_1 * s_beta_1;
    const Scalar z159 = v_beta_2 * s_beta_2;
    const Scalar z55 = v_beta_1 * c_beta_1;
    const Scalar z72 = v_beta_2 * c_beta_2;
    const Scalar z36 = v_psi * c_beta_2;
    const Scalar z117 = s_beta_1 * z116;
    const Scalar z118 = c_beta_1 * z116;
    const Scalar z143 = s_beta_2 * z116;
    const Scalar z144 = c_beta_2 * z116;
    const Scalar z41 = n0_5 * s_beta_1;
    const Scalar z35 = v_psi * s_beta_2;
    const Scalar z25 = v_psi * s_beta_1;
    const Scalar z26 = v_psi * c_beta_1;
    const Scalar z58 = n0_5 * s_beta_2;
    const Scalar z178 = v_psi * v_psi;
    const Scalar z179 = n0_05 * z178;
    const Scalar z181 = s_beta_1 * z179 - n9_81 * c_beta_1;
    const Scalar z185 = s_beta_2 * z179 - n9_81 * c_beta_2;
    const Scalar z44 = n1 - z41;
    const Scalar z61 = n1 - z58;
    const Scalar z119 = n0_5 - z117;
    const Scalar z134 = v_s * c_beta_1 + z116 * z133;
    const Scalar z135 = v_s * s_beta_1 - z55 * z116;
    const Scalar z145 = n0_5 - z143;
    const Scalar z160 = v_s * c_beta_2 + z116 * z159;
    const Scalar z161 = v_s * s_beta_2 - z72 * z116;
    const Scalar z182 = v_beta_1 * z26;  // angular acceleration of rod_1, x
    const Scalar z183 = v_beta_1 * z25;  // angular acceleration of rod_1, z
    const Scalar z186 = v_beta_2 * z36;  // angular acceleration of rod_2, x
    const Scalar z187 = v_beta_2 * z35;  // angular acceleration of rod_2, z
    const Scalar z192 = z35 * z36;
    const Scalar z208 = z25 * z26;
    const Scalar z122 = q_s - z44;
    const Scalar z124 = z118 * z118 + z119 * z119;
    const Scalar z148 = q_s - z61;
    const Scalar z150 = z144 * z144 + z145 * z145;
    const Scalar z191 = n2 * z187;
    const Scalar z193 = n2 * z186;
    const Scalar z207 = n2 * z183;
    const Scalar z209 = n2 * z182;
    const Scalar z136 = n2 * (z118 * z134 - z119 * z135);
    const Scalar z162 = n2 * (z144 * z160 - z145 * z161);
    const Scalar z195 = n5_15 * z191;  // force on rod_2, y
    const Scalar z197 = k6 * z193;  // moment on rod_2, x
    const Scalar z199 = n5_1 * z191;  // moment on rod_2, z
    const Scalar z211 = n5_15 * z207;  // force on rod_1, y
    const Scalar z213 = k6 * z209;  // moment on rod_1, x
    const Scalar z215 = n5_1 * z207;  // moment on rod_1, z
    const Scalar z125 = traits::sqrt(z124);
    const Scalar z151 = traits::sqrt(z150);
    const Scalar z203 = s_beta_2 * z197 - c_beta_2 * z199;
    const Scalar z219 = s_beta_1 * z213 - c_beta_1 * z215;
    const Scalar z137 = n0_5 * z136;
    const Scalar z163 = n0_5 * z162;
    const Scalar z226 = n0_05 * (z195 + z211) - z203 - z219;  // moment on shaft, z
    const Scalar z138 = n40000 * z137 / z124;
    const Scalar z164 = n40000 * z163 / z150;
    const Scalar z126 = n1 / z125;
    const Scalar z152 = n1 / z151;
    const Scalar z140 = z118 * z138;
    const Scalar z142 = z122 * z138;
    const Scalar z166 = z144 * z164;
    const Scalar z168 = z148 * z164;
    const Scalar z127 = n800000 - n400000 * z126;
    const Scalar z153 = n800000 - n400000 * z152;
    const Scalar z130 = z118 * z127;
    const Scalar z132 = z122 * z127;
    const Scalar z156 = z144 * z153;
    const Scalar z158 = z148 * z153;
    const Scalar z170 = z132 - z142 + z158 - z168;
    const Scalar z174 = n0_5 * (z130 - z140);
    const Scalar z177 = n0_5 * (z156 - z166);
    const Scalar z198 = z177 - n5_15 * z185 - k11 * z192;  // moment on rod_2, y
    const Scalar z214 = z174 - n5_15 * z181 - k11 * z208;  // moment on rod_1, y
    const Scalar z220 = n29_43 + z170;  // force on slider, z
    forces.psi = -z226;
    forces.s = z220;
    forces.beta_1 = -z214;
    forces.beta_2 = -z198;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k3 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar k9 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n5_1 = traits::constant(5.1, 5.1f, "51/10");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k16 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar a_s = accelerations.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z116 = n1 - q_s;
    const Scalar z133 = v_beta_1 * s_beta_1;
    const Scalar z159 = v_beta_2 * s_beta_2;
    const Scalar z55 = v_beta_1 * c_beta_1;
    const Scalar z72 = v_beta_2 * c_beta_2;
    const Scalar z36 = v_psi * c_beta_2;
    const Scalar z117 = s_beta_1 * z116;
    const Scalar z118 = c_beta_1 * z116;
    const Scalar z143 = s_beta_2 * z116;
    const Scalar z144 = c_beta_2 * z116;
    const Scalar z41 = n0_5 * s_beta_1;
    const Scalar z35 = v_psi * s_beta_2;
    const Scalar z25 = v_psi * s_beta_1;
    const Scalar z26 = v_psi * c_beta_1;
    const Scalar z58 = n0_5 * s_beta_2;
    const Scalar z178 = v_psi * v_psi;
    const Scalar z179 = n0_05 * z178;
    const Scalar z83 = k3 * c_beta_2;
    const Scalar z80 = n5_15 * c_beta_2;
    const Scalar z97 = k3 * c_beta_1;
    const Scalar z94 = n5_15 * c_beta_1;
    const Scalar z181 = s_beta_1 * z179 - n9_81 * c_beta_1;
    const Scalar z44 = n1 - z41;
    const Scalar z185 = s_beta_2 * z179 - n9_81 * c_beta_2;
    const Scalar z61 = n1 - z58;
    const Scalar z84 = c_beta_2 * z83;
    const Scalar z98 = c_beta_1 * z97;
    const Scalar z119 = n0_5 - z117;
    const Scalar z134 = v_s * c_beta_1 + z116 * z133;
    const Scalar z135 = v_s * s_beta_1 - z55 * z116;
    const Scalar z145 = n0_5 - z143;
    const Scalar z160 = v_s * c_beta_2 + z116 * z159;
    const Scalar z161 = v_s * s_beta_2 - z72 * z116;
    const Scalar z182 = v_beta_1 * z26;  // angular acceleration of rod_1, x
    const Scalar z183 = v_beta_1 * z25;  // angular acceleration of rod_1, z
    const Scalar z186 = v_beta_2 * z36;  // angular acceleration of rod_2, x
    const Scalar z187 = v_beta_2 * z35;  // angular acceleration of rod_2, z
    const Scalar z192 = z35 * z36;
    const Scalar z90 = n0_1 * z80 + z84;
    const Scalar z104 = n0_1 * z94 + z98;
    const Scalar z122 = q_s - z44;
    const Scalar z124 = z118 * z118 + z119 * z119;
    const Scalar z148 = q_s - z61;
    const Scalar z150 = z144 * z144 + z145 * z145;
    const Scalar z191 = n2 * z187;
    const Scalar z193 = n2 * z186;
    const Scalar z136 = n2 * (z118 * z134 - z119 * z135);
    const Scalar z162 = n2 * (z144 * z160 - z145 * z161);
    const Scalar z195 = n5_15 * z191;  // force on rod_2, y
    const Scalar z197 = k8 * z193;  // moment on rod_2, x
    const Scalar z92 = k9 + z90;
    const Scalar z208 = z25 * z26;
    const Scalar z207 = n2 * z183;
    const Scalar z209 = n2 * z182;
    const Scalar z199 = n5_1 * z191;  // moment on rod_2, z
    const Scalar z125 = traits::sqrt(z124);
    const Scalar z151 = traits::sqrt(z150);
    const Scalar z203 = s_beta_2 * z197 - c_beta_2 * z199;
    const Scalar z110 = z92 + z104;
    const Scalar z211 = n5_15 * z207;  // force on rod_1, y
    const Scalar z213 = k8 * z209;  // moment on rod_1, x
    const Scalar z215 = n5_1 * z207;  // moment on rod_1, z
    const Scalar z219 = s_beta_1 * z213 - c_beta_1 * z215;
    const Scalar z137 = n0_5 * z136;
    const Scalar z163 = n0_5 * z162;
    const Scalar z226 = n0_05 * (z195 + z211) - z203 - z219;  // moment on shaft, z
    const Scalar z138 = n40000 * z137 / z124;
    const Scalar z164 = n40000 * z163 / z150;
    const Scalar z268 = a_psi * z110 - z226;
    const Scalar z126 = n1 / z125;
    const Scalar z152 = n1 / z151;
    const Scalar z140 = z118 * z138;
    const Scalar z142 = z122 * z138;
    const Scalar z166 = z144 * z164;
    const Scalar z168 = z148 * z164;
    const Scalar z127 = n800000 - n400000 * z126;
    const Scalar z153 = n800000 - n400000 * z152;
    const Scalar z130 = z118 * z127;
    const Scalar z132 = z122 * z127;
    const Scalar z156 = z144 * z153;
    const Scalar z158 = z148 * z153;
    const Scalar z170 = z132 - z142 + z158 - z168;
    const Scalar z174 = n0_5 * (z130 - z140);
    const Scalar z177 = n0_5 * (z156 - z166);
    const Scalar z198 = z177 - n5_15 * z185 - k3 * z192;  // moment on rod_2, y
    const Scalar z214 = z174 - n5_15 * z181 - k3 * z208;  // moment on rod_1, y
    const Scalar z220 = n29_43 + z170;  // force on slider, z
    const Scalar z269 = n3 * a_s + z220;
    const Scalar z270 = k16 * a_beta_1 - z214;
    const Scalar z271 = k16 * a_beta_2 - z198;
    forces.psi = z268;
    forces.s = z269;
    forces.beta_1 = z270;
    forces.beta_2 = z271;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k1 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar k9 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n5_1 = traits::constant(5.1, 5.1f, "51/10");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar k16 = traits::constant(0.19607833525571802, 0.19607833f, "400000/2040001");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z116 = n1 - q_s;
    const Scalar z133 = v_beta_1 * s_beta_1;
    const Scalar z159 = v_beta_2 * s_beta_2;
    const Scalar z55 = v_beta_1 * c_beta_1;
    const Scalar z72 = v_beta_2 * c_beta_2;
    const Scalar z83 = k1 * c_beta_2;
    const Scalar z117 = s_beta_1 * z116;
    const Scalar z118 = c_beta_1 * z116;
    const Scalar z143 = s_beta_2 * z116;
    const Scalar z144 = c_beta_2 * z116;
    const Scalar z36 = v_psi * c_beta_2;
    const Scalar z80 = n5_15 * c_beta_2;
    const Scalar z97 = k1 * c_beta_1;
    const Scalar z41 = n0_5 * s_beta_1;
    const Scalar z35 = v_psi * s_beta_2;
    const Scalar z94 = n5_15 * c_beta_1;
    const Scalar z25 = v_psi * s_beta_1;
    const Scalar z26 = v_psi * c_beta_1;
    const Scalar z58 = n0_5 * s_beta_2;
    const Scalar z178 = v_psi * v_psi;
    const Scalar z179 = n0_05 * z178;
    const Scalar z181 = s_beta_1 * z179 - n9_81 * c_beta_1;
    const Scalar z44 = n1 - z41;
    const Scalar z185 = s_beta_2 * z179 - n9_81 * c_beta_2;
    const Scalar z61 = n1 - z58;
    const Scalar z84 = c_beta_2 * z83;
    const Scalar z98 = c_beta_1 * z97;
    const Scalar z119 = n0_5 - z117;
    const Scalar z134 = v_s * c_beta_1 + z116 * z133;
    const Scalar z135 = v_s * s_beta_1 - z55 * z116;
    const Scalar z145 = n0_5 - z143;
    const Scalar z160 = v_s * c_beta_2 + z116 * z159;
    const Scalar z161 = v_s * s_beta_2 - z72 * z116;
    const Scalar z182 = v_beta_1 * z26;  // angular acceleration of rod_1, x
    const Scalar z183 = v_beta_1 * z25;  // angular acceleration of rod_1, z
    const Scalar z186 = v_beta_2 * z36;  // angular acceleration of rod_2, x
    const Scalar z187 = v_beta_2 * z35;  // angular acceleration of rod_2, z
    const Scalar z192 = z35 * z36;
    const Scalar z90 = n0_1 * z80 + z84;
    const Scalar z104 = n0_1 * z94 + z98;
    const Scalar z122 = q_s - z44;
    const Scalar z124 = z118 * z118 + z119 * z119;
    const Scalar z148 = q_s - z61;
    const Scalar z150 = z144 * z144 + z145 * z145;
    const Scalar z191 = n2 * z187;
    const Scalar z193 = n2 * z186;
    const Scalar z136 = n2 * (z118 * z134 - z119 * z135);
    const Scalar z162 = n2 * (z144 * z160 - z145 * z161);
    const Scalar z195 = n5_15 * z191;  // force on rod_2, y
    const Scalar z197 = k8 * z193;  // moment on rod_2, x
    const Scalar z92 = k9 + z90;
    const Scalar z208 = z25 * z26;
    const Scalar z207 = n2 * z183;
    const Scalar z209 = n2 * z182;
    const Scalar z199 = n5_1 * z191;  // moment on rod_2, z
    const Scalar z125 = traits::sqrt(z124);
    const Scalar z151 = traits::sqrt(z150);
    const Scalar z203 = s_beta_2 * z197 - c_beta_2 * z199;
    const Scalar z110 = z92 + z104;
    const Scalar z211 = n5_15 * z207;  // force on rod_1, y
    const Scalar z213 = k8 * z209;  // moment on rod_1, x
    const Scalar z215 = n5_1 * z207;  // moment on rod_1, z
    const Scalar z219 = s_beta_1 * z213 - c_beta_1 * z215;
    const Scalar z299 = n1 / z110;
    const Scalar z137 = n0_5 * z136;
    const Scalar z163 = n0_5 * z162;
    const Scalar z226 = n0_05 * (z195 + z211) - z203 - z219;  // moment on shaft, z
    const Scalar z138 = n40000 * z137 / z124;
    const Scalar z164 = n40000 * z163 / z150;
    const Scalar z126 = n1 / z125;
    const Scalar z152 = n1 / z151;
    const Scalar z140 = z118 * z138;
    const Scalar z142 = z122 * z138;
    const Scalar z166 = z144 * z164;
    const Scalar z168 = z148 * z164;
    const Scalar z127 = n800000 - n400000 * z126;
    const Scalar z153 = n800000 - n400000 * z152;
    const Scalar z130 = z118 * z127;
    const Scalar z132 = z122 * z127;
    const Scalar z314 = z226 * z299;
    const Scalar z156 = z144 * z153;
    const Scalar z158 = z148 * z153;
    const Scalar z170 = z132 - z142 + z158 - z168;
    const Scalar z174 = n0_5 * (z130 - z140);
    const Scalar z177 = n0_5 * (z156 - z166);
    const Scalar z198 = z177 - n5_15 * z185 - k1 * z192;  // moment on rod_2, y
    const Scalar z214 = z174 - n5_15 * z181 - k1 * z208;  // moment on rod_1, y
    const Scalar z220 = n29_43 + z170;  // force on slider, z
    const Scalar z310 = n1_over_3 * z220;
    const Scalar z302 = k16 * z198;
    const Scalar z306 = k16 * z214;
    accelerations.psi = z314;
    accelerations.s = -z310;
    accelerations.beta_1 = z306;
    accelerations.beta_2 = z302;
    if (!(traits::regular(z110, z110))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.psi * accelerations.s * accelerations.beta_1 * accelerations.beta_2;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5_3 = traits::constant(5.3, 5.3f, "53/10");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k5 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar k8 = traits::constant(0.0025025, 0.0025025f, "1001/400000");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar k10 = traits::constant(2.55000125, 2.5500011f, "2040001/800000");
    const Scalar k11 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar n105_4575 = traits::constant(105.4575, 105.4575f, "42183/400");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z341 = n1 - q_s;
    const Scalar z348 = v_beta_1 * s_beta_1;
    const Scalar z360 = v_beta_2 * s_beta_2;
    const Scalar z337 = v_beta_1 * c_beta_1;
    const Scalar z338 = v_beta_2 * c_beta_2;
    const Scalar z332 = n0_05 * v_psi;
    const Scalar z342 = s_beta_1 * z341;
    const Scalar z343 = c_beta_1 * z341;
    const Scalar z354 = s_beta_2 * z341;
    const Scalar z355 = c_beta_2 * z341;
    const Scalar z334 = v_psi * c_beta_1;
    const Scalar z336 = v_psi * c_beta_2;
    const Scalar z366 = n5_3 * z332;
    const Scalar z368 = n5_15 * z332;
    const Scalar z333 = v_psi * s_beta_1;
    const Scalar z335 = v_psi * s_beta_2;
    const Scalar z339 = n5_15 * s_beta_2;
    const Scalar z340 = n5_15 * s_beta_1;
    const Scalar z344 = n0_5 - z342;
    const Scalar z349 = v_s * c_beta_1 + z341 * z348;
    const Scalar z350 = v_s * s_beta_1 - z337 * z341;
    const Scalar z356 = n0_5 - z354;
    const Scalar z361 = v_s * c_beta_2 + z341 * z360;
    const Scalar z362 = v_s * s_beta_2 - z338 * z341;
    const Scalar z367 = n5_15 * z334 + z366;
    const Scalar z369 = k5 * z334 + z368;
    const Scalar z370 = n5_15 * z336 + z366;
    const Scalar z371 = k5 * z336 + z368;
    const Scalar z345 = z343 * z343 + z344 * z344;
    const Scalar z357 = z355 * z355 + z356 * z356;
    const Scalar z351 = n2 * (z343 * z349 - z344 * z350);
    const Scalar z363 = n2 * (z355 * z361 - z356 * z362);
    const Scalar z346 = traits::sqrt(z345);
    const Scalar z358 = traits::sqrt(z357);
    const Scalar z352 = n0_5 * z351;
    const Scalar z364 = n0_5 * z363;
    const Scalar z353 = n40000 * z352 / z345;
    const Scalar z365 = n40000 * z364 / z357;
    const Scalar z347 = n0_5 - z346;
    const Scalar z359 = n0_5 - z358;
    result.kinetic = k8 * v_psi * v_psi + n1_5 * v_s * v_s + k10 * (v_beta_1 * v_beta_1 + v_beta_2 * v_beta_2) + k11
        * (z333 * z333 + z335 * z335) + n0_5 * (z334 * z369 + z336 * z371 + z332 * (z367 + z370));
    result.force_function = -n105_4575 - n29_43 * q_s + n9_81 * (z339 + z340) - n400000 * (z347 * z347 + z359 * z359);
    result.power = -z352 * z353 - z364 * z365;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar k0 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k3 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar v_psi = state.v.psi;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_beta_1 = cosines_[0];
    const Scalar c_beta_2 = cosines_[1];
    const Scalar z83 = k0 * c_beta_2;
    const Scalar z80 = n5_15 * c_beta_2;
    const Scalar z97 = k0 * c_beta_1;
    const Scalar z94 = n5_15 * c_beta_1;
    const Scalar z84 = c_beta_2 * z83;
    const Scalar z98 = c_beta_1 * z97;
    const Scalar z90 = n0_1 * z80 + z84;
    const Scalar z104 = n0_1 * z94 + z98;
    const Scalar z92 = k3 + z90;
    const Scalar z110 = z92 + z104;
    result.momentum_psi = v_psi * z110;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k1 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar k9 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar n5_1 = traits::constant(5.1, 5.1f, "51/10");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar k14 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k17 = traits::constant(0.19607833525571802, 0.19607833f, "400000/2040001");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar a_s = accelerations.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z564 = n1 - q_s;
    const Scalar z576 = v_beta_1 * s_beta_1;
    const Scalar z595 = v_beta_2 * s_beta_2;
    const Scalar z546 = v_beta_1 * c_beta_1;
    const Scalar z549 = v_beta_2 * c_beta_2;
    const Scalar z540 = v_psi * s_beta_1;
    const Scalar z565 = s_beta_1 * z564;
    const Scalar z566 = c_beta_1 * z564;
    const Scalar z584 = s_beta_2 * z564;
    const Scalar z585 = c_beta_2 * z564;
    const Scalar z542 = v_psi * s_beta_2;
    const Scalar z553 = k1 * c_beta_2;
    const Scalar z541 = v_psi * c_beta_1;
    const Scalar z543 = v_psi * c_beta_2;
    const Scalar z551 = n5_15 * c_beta_2;
    const Scalar z560 = k1 * c_beta_1;
    const Scalar z544 = n0_5 * s_beta_1;
    const Scalar z558 = n5_15 * c_beta_1;
    const Scalar z547 = n0_5 * s_beta_2;
    const Scalar z552 = k1 * s_beta_2;
    const Scalar z559 = k1 * s_beta_1;
    const Scalar z568 = n0_5 * c_beta_1;
    const Scalar z587 = n0_5 * c_beta_2;
    const Scalar z550 = n5_15 * s_beta_2;
    const Scalar z557 = n5_15 * s_beta_1;
    const Scalar z545 = n1 - z544;
    const Scalar z606 = v_psi * v_psi;
    const Scalar z607 = n0_05 * z606;
    const Scalar z548 = n1 - z547;
    const Scalar z609 = s_beta_1 * z607 - n9_81 * c_beta_1;
    const Scalar z613 = s_beta_2 * z607 - n9_81 * c_beta_2;
    const Scalar z608 = n9_81 * s_beta_1 + c_beta_1 * z607;
    const Scalar z612 = n9_81 * s_beta_2 + c_beta_2 * z607;
    const Scalar z554 = c_beta_2 * z553;
    const Scalar z561 = c_beta_1 * z560;
    const Scalar z567 = n0_5 - z565;
    const Scalar z577 = v_s * c_beta_1 + z564 * z576;
    const Scalar z578 = v_s * s_beta_1 - z546 * z564;
    const Scalar z586 = n0_5 - z584;
    const Scalar z596 = v_s * c_beta_2 + z564 * z595;
    const Scalar z597 = v_s * s_beta_2 - z549 * z564;
    const Scalar z610 = v_beta_1 * z541;  // angular acceleration of rod_1, x
    const Scalar z611 = v_beta_1 * z540;  // angular acceleration of rod_1, z
    const Scalar z614 = v_beta_2 * z543;  // angular acceleration of rod_2, x
    const Scalar z555 = n0_1 * z551 + z554;
    const Scalar z615 = v_beta_2 * z542;  // angular acceleration of rod_2, z
    const Scalar z562 = n0_1 * z558 + z561;
    const Scalar z569 = q_s - z545;
    const Scalar z570 = z566 * z566 + z567 * z567;
    const Scalar z588 = q_s - z548;
    const Scalar z589 = z585 * z585 + z586 * z586;
    const Scalar z579 = n2 * (z566 * z577 - z567 * z578);
    const Scalar z598 = n2 * (z585 * z596 - z586 * z597);
    const Scalar z556 = k8 + z555;
    const Scalar z616 = n2 * z615;
    const Scalar z618 = n2 * z614;
    const Scalar z617 = z542 * z543;
    const Scalar z619 = n5_15 * z616;  // force on rod_2, y
    const Scalar z620 = k9 * z618;  // moment on rod_2, x
    const Scalar z622 = n5_1 * z616;  // moment on rod_2, z
    const Scalar z571 = traits::sqrt(z570);
    const Scalar z590 = traits::sqrt(z589);
    const Scalar z563 = z556 + z562;
    const Scalar z624 = n2 * z611;
    const Scalar z626 = n2 * z610;
    const Scalar z623 = s_beta_2 * z620 - c_beta_2 * z622;
    const Scalar z625 = z540 * z541;
    const Scalar z630 = n5_1 * z624;  // moment on rod_1, z
    const Scalar z628 = k9 * z626;  // moment on rod_1, x
    const Scalar z627 = n5_15 * z624;  // force on rod_1, y
    const Scalar z631 = s_beta_1 * z628 - c_beta_1 * z630;
    const Scalar z580 = n0_5 * z579;
    const Scalar z599 = n0_5 * z598;
    const Scalar z581 = n40000 * z580 / z570;
    const Scalar z600 = n40000 * z599 / z589;
    const Scalar z572 = n1 / z571;
    const Scalar z591 = n1 / z590;
    const Scalar z582 = z566 * z581;
    const Scalar z583 = z569 * z581;
    const Scalar z601 = z585 * z600;
    const Scalar z602 = z588 * z600;
    const Scalar z573 = n800000 - n400000 * z572;
    const Scalar z633 = n0_05 * (z619 + z627) - z623 - z631;  // moment on shaft, z
    const Scalar z592 = n800000 - n400000 * z591;
    const Scalar z574 = z566 * z573;
    const Scalar z634 = a_psi * z563 - z633;
    const Scalar z575 = z569 * z573;
    const Scalar z638 = n1 / z563;
    const Scalar z641 = n2 * z549;
    const Scalar z642 = k9 * z641;
    const Scalar z639 = n2 * z595;
    const Scalar z645 = n2 * z576;
    const Scalar z647 = n2 * z546;
    const Scalar z648 = k9 * z647;
    const Scalar z652 = n2 * v_psi;
    const Scalar z643 = n5_1 * z639;
    const Scalar z640 = n5_15 * z639;
    const Scalar z644 = s_beta_2 * z642 - c_beta_2 * z643;
    const Scalar z646 = n5_15 * z645;
    const Scalar z649 = n5_1 * z645;
    const Scalar z650 = s_beta_1 * z648 - c_beta_1 * z649;
    const Scalar z651 = n0_05 * (z640 + z646) - z644 - z650;
    const Scalar z593 = z585 * z592;
    const Scalar z653 = n0_05 * z652;
    const Scalar z594 = z588 * z592;
    const Scalar z660 = n2 * (s_beta_1 * z567 - c_beta_1 * z566);
    const Scalar z661 = n0_5 * z660;
    const Scalar z654 = s_beta_1 * z653;
    const Scalar z657 = s_beta_2 * z653;
    const Scalar z655 = s_beta_1 * z541 + c_beta_1 * z540;
    const Scalar z656 = n5_15 * z654 + k1 * z655;
    const Scalar z662 = n40000 * z661 / z570;
    const Scalar z658 = s_beta_2 * z543 + c_beta_2 * z542;
    const Scalar z659 = n5_15 * z657 + k1 * z658;
    const Scalar z603 = z575 - z583 + z594 - z602;
    const Scalar z604 = n0_5 * (z574 - z582);
    const Scalar z605 = n0_5 * (z593 - z601);
    const Scalar z673 = n2 * (z566 * z576 + z546 * z567 + s_beta_1 * z578 + c_beta_1 * z577);
    const Scalar z621 = z605 - n5_15 * z613 - k1 * z617;  // moment on rod_2, y
    const Scalar z681 = n2 * (z585 * z595 + z549 * z586 + s_beta_2 * z597 + c_beta_2 * z596);
    const Scalar z629 = z604 - n5_15 * z609 - k1 * z625;  // moment on rod_1, y
    const Scalar z636 = k14 * a_beta_1 - z629;
    const Scalar z637 = k14 * a_beta_2 - z621;
    const Scalar z674 = n0_5 * z673;
    const Scalar z675 = n40000 * (z580 * z660 / (z570 * z570) + z674 / z570);
    const Scalar z682 = n0_5 * z681;
    const Scalar z669 = z661 / z571;
    const Scalar z670 = z669 / (z571 * z571);
    const Scalar z632 = n29_43 + z603;  // force on slider, z
    const Scalar z635 = n3 * a_s + z632;
    const Scalar z703 = s_beta_1 * z560 + c_beta_1 * z559;
    const Scalar z704 = n0_1 * z557 + z703;
    const Scalar z719 = z577 * n2 * (z565 + z567);
    const Scalar z711 = z566 * n2 * (z565 + z567);
    const Scalar z720 = n0_5 * z719;
    const Scalar z706 = k9 * z624;
    const Scalar z712 = n0_5 * z711;
    const Scalar z721 = n40000 * (z580 * z711 / (z570 * z570) - z720 / z570);
    const Scalar z713 = n40000 * z712 / z570;
    const Scalar z715 = z712 / z571;
    const Scalar z671 = n400000 * z670;
    const Scalar z664 = n2 * (s_beta_2 * z586 - c_beta_2 * z585);
    const Scalar z683 = n40000 * (z599 * z664 / (z589 * z589) + z682 / z589);
    const Scalar z665 = n0_5 * z664;
    const Scalar z677 = z665 / z590;
    const Scalar z666 = n40000 * z665 / z589;
    const Scalar z707 = n5_1 * z626;
    const Scalar z708 = s_beta_1 * (z630 - z706) + c_beta_1 * (z628 - z707);
    const Scalar z716 = z715 / (z571 * z571);
    const Scalar z705 = n5_15 * z626;
    const Scalar z698 = n2 * z541;
    const Scalar z699 = k9 * z698;
    const Scalar z696 = n2 * z540;
    const Scalar z676 = z569 * z675 - z581;
    const Scalar z689 = c_beta_1 * z581 + z566 * z675;
    const Scalar z709 = n0_05 * z705 - z708;
    const Scalar z700 = n5_1 * z696;
    const Scalar z701 = s_beta_1 * z699 - c_beta_1 * z700;
    const Scalar z710 = a_psi * z704 + z709;
    const Scalar z678 = z677 / (z590 * z590);
    const Scalar z697 = n5_15 * z696;
    const Scalar z672 = z569 * z671 + z573;
    const Scalar z702 = n0_05 * z697 - z701;
    const Scalar z717 = n400000 * z716;
    const Scalar z688 = c_beta_1 * z573 - z566 * z671;
    const Scalar z690 = n0_5 * (z688 - z689);
    const Scalar z684 = z588 * z683 - z600;
    const Scalar z694 = c_beta_2 * z600 + z585 * z683;
    const Scalar z663 = z569 * z662;
    const Scalar z686 = z566 * z662;
    const Scalar z687 = n0_5 * z686;
    const Scalar z726 = z565 * z573 + z566 * z717;
    const Scalar z718 = z568 * z573 - z569 * z717;
    const Scalar z679 = n400000 * z678;
    const Scalar z722 = z568 * z581 + z569 * z721;
    const Scalar z723 = z718 - z722;
    const Scalar z714 = z569 * z713;
    const Scalar z724 = z566 * z713;
    const Scalar z725 = n0_5 * z724;
    const Scalar z693 = c_beta_2 * z592 - z585 * z679;
    const Scalar z695 = n0_5 * (z693 - z694);
    const Scalar z680 = z588 * z679 + z592;
    const Scalar z685 = z676 + z684 + z672 + z680;
    const Scalar z667 = z588 * z666;
    const Scalar z727 = z565 * z581 - z566 * z721;
    const Scalar z668 = z663 + z667;
    const Scalar z728 = n0_5 * (z726 - z727);
    const Scalar z738 = s_beta_2 * z553 + c_beta_2 * z552;
    const Scalar z729 = z540 * z540 - z541 * z541;
    const Scalar z739 = n0_1 * z550 + z738;
    const Scalar z741 = k9 * z616;
    const Scalar z730 = n5_15 * z608 + z728 - k1 * z729;
    const Scalar z691 = z585 * z666;
    const Scalar z692 = n0_5 * z691;
    const Scalar z766 = z638 * z651;
    const Scalar z767 = k17 * z656;
    const Scalar z768 = k17 * z659;
    const Scalar z769 = n1_over_3 * z685;
    const Scalar z770 = k17 * z690;
    const Scalar z771 = k17 * z695;
    const Scalar z772 = n1_over_3 * z668;
    const Scalar z773 = k17 * z687;
    const Scalar z774 = k17 * z692;
    const Scalar z775 = z638 * z710;
    const Scalar z776 = n1_over_3 * z723;
    const Scalar z777 = k17 * z730;
    const Scalar z778 = z638 * z702;
    const Scalar z779 = n1_over_3 * z714;
    const Scalar z780 = k17 * z725;
    const Scalar z754 = z596 * n2 * (z584 + z586);
    const Scalar z746 = z585 * n2 * (z584 + z586);
    const Scalar z755 = n0_5 * z754;
    const Scalar z747 = n0_5 * z746;
    const Scalar z742 = n5_1 * z618;
    const Scalar z743 = s_beta_2 * (z622 - z741) + c_beta_2 * (z620 - z742);
    const Scalar z750 = z747 / z590;
    const Scalar z756 = n40000 * (z599 * z746 / (z589 * z589) - z755 / z589);
    const Scalar z733 = n2 * z543;
    const Scalar z731 = n2 * z542;
    const Scalar z748 = n40000 * z747 / z589;
    const Scalar z734 = k9 * z733;
    const Scalar z735 = n5_1 * z731;
    const Scalar z764 = z542 * z542 - z543 * z543;
    const Scalar z740 = n5_15 * z618;
    const Scalar z732 = n5_15 * z731;
    const Scalar z736 = s_beta_2 * z734 - c_beta_2 * z735;
    const Scalar z744 = n0_05 * z740 - z743;
    const Scalar z751 = z750 / (z590 * z590);
    const Scalar z745 = a_psi * z739 + z744;
    const Scalar z737 = n0_05 * z732 - z736;
    const Scalar z749 = z588 * z748;
    const Scalar z759 = z585 * z748;
    const Scalar z781 = z638 * z745;
    const Scalar z757 = z587 * z600 + z588 * z756;
    const Scalar z760 = n0_5 * z759;
    const Scalar z762 = z584 * z600 - z585 * z756;
    const Scalar z784 = z638 * z737;
    const Scalar z785 = n1_over_3 * z749;
    const Scalar z786 = k17 * z760;
    const Scalar z752 = n400000 * z751;
    const Scalar z753 = z587 * z592 - z588 * z752;
    const Scalar z761 = z584 * z592 + z585 * z752;
    const Scalar z758 = z753 - z757;
    const Scalar z763 = n0_5 * (z761 - z762);
    const Scalar z782 = n1_over_3 * z758;
    const Scalar z765 = n5_15 * z612 + z763 - k1 * z764;
    const Scalar z783 = k17 * z765;
    result.M[0] = z563;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n3;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = k14;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = k14;
    result.C[0] = -z651;
    result.C[1] = n0;
    result.C[2] = z656;
    result.C[3] = z659;
    result.C[4] = n0;
    result.C[5] = z668;
    result.C[6] = -z687;
    result.C[7] = -z692;
    result.C[8] = -z702;
    result.C[9] = -z714;
    result.C[10] = z725;
    result.C[11] = n0;
    result.C[12] = -z737;
    result.C[13] = -z749;
    result.C[14] = n0;
    result.C[15] = z760;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = z685;
    result.K[6] = z690;
    result.K[7] = z695;
    result.K[8] = -z710;
    result.K[9] = z723;
    result.K[10] = z730;
    result.K[11] = n0;
    result.K[12] = -z745;
    result.K[13] = z758;
    result.K[14] = n0;
    result.K[15] = z765;
    result.F[0] = -z634;
    result.F[1] = -z635;
    result.F[2] = -z636;
    result.F[3] = -z637;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = -z769;
    result.A[14] = -z770;
    result.A[15] = -z771;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = n0;
    result.A[20] = z775;
    result.A[21] = -z776;
    result.A[22] = -z777;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = z781;
    result.A[29] = -z782;
    result.A[30] = n0;
    result.A[31] = -z783;
    result.A[32] = n1;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = z766;
    result.A[37] = n0;
    result.A[38] = -z767;
    result.A[39] = -z768;
    result.A[40] = n0;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = -z772;
    result.A[46] = z773;
    result.A[47] = z774;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = n0;
    result.A[52] = z778;
    result.A[53] = z779;
    result.A[54] = -z780;
    result.A[55] = n0;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n1;
    result.A[60] = z784;
    result.A[61] = z785;
    result.A[62] = n0;
    result.A[63] = -z786;
    if (!(traits::regular(z563, z563))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[0] * result.C[0] * result.C[2] * result.C[3] * result.C[5] * result.C[6]
        * result.C[7] * result.C[8] * result.C[9] * result.C[10] * result.C[12]) * (n0 * result.C[13] * result.C[15]
        * result.K[5] * result.K[6] * result.K[7] * result.K[8] * result.K[9] * result.K[10] * result.K[12]
        * result.K[13] * result.K[15] * result.F[0])) * ((n0 * result.F[1] * result.F[2] * result.F[3] * result.A[13]
        * result.A[14] * result.A[15] * result.A[20] * result.A[21] * result.A[22] * result.A[28] * result.A[29]
        * result.A[31]) * (n0 * result.A[36] * result.A[38] * result.A[39] * result.A[45] * result.A[46] * result.A[47]
        * result.A[52] * result.A[53] * result.A[54] * result.A[60] * result.A[61] * result.A[63]));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Residual of the equations of motion, zero along motions:
  /// r = M a + h - E u.
  TORSOR_DEVICE static void residual(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, const Inputs&, std::array<Scalar, 4>& residual) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k3 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar k9 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n5_1 = traits::constant(5.1, 5.1f, "51/10");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k16 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar a_s = accelerations.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z116 = n1 - q_s;
    const Scalar z133 = v_beta_1 * s_beta_1;
    const Scalar z159 = v_beta_2 * s_beta_2;
    const Scalar z55 = v_beta_1 * c_beta_1;
    const Scalar z72 = v_beta_2 * c_beta_2;
    const Scalar z36 = v_psi * c_beta_2;
    const Scalar z117 = s_beta_1 * z116;
    const Scalar z118 = c_beta_1 * z116;
    const Scalar z143 = s_beta_2 * z116;
    const Scalar z144 = c_beta_2 * z116;
    const Scalar z41 = n0_5 * s_beta_1;
    const Scalar z35 = v_psi * s_beta_2;
    const Scalar z25 = v_psi * s_beta_1;
    const Scalar z26 = v_psi * c_beta_1;
    const Scalar z58 = n0_5 * s_beta_2;
    const Scalar z178 = v_psi * v_psi;
    const Scalar z179 = n0_05 * z178;
    const Scalar z83 = k3 * c_beta_2;
    const Scalar z80 = n5_15 * c_beta_2;
    const Scalar z97 = k3 * c_beta_1;
    const Scalar z94 = n5_15 * c_beta_1;
    const Scalar z181 = s_beta_1 * z179 - n9_81 * c_beta_1;
    const Scalar z44 = n1 - z41;
    const Scalar z185 = s_beta_2 * z179 - n9_81 * c_beta_2;
    const Scalar z61 = n1 - z58;
    const Scalar z84 = c_beta_2 * z83;
    const Scalar z98 = c_beta_1 * z97;
    const Scalar z119 = n0_5 - z117;
    const Scalar z134 = v_s * c_beta_1 + z116 * z133;
    const Scalar z135 = v_s * s_beta_1 - z55 * z116;
    const Scalar z145 = n0_5 - z143;
    const Scalar z160 = v_s * c_beta_2 + z116 * z159;
    const Scalar z161 = v_s * s_beta_2 - z72 * z116;
    const Scalar z182 = v_beta_1 * z26;  // angular acceleration of rod_1, x
    const Scalar z183 = v_beta_1 * z25;  // angular acceleration of rod_1, z
    const Scalar z186 = v_beta_2 * z36;  // angular acceleration of rod_2, x
    const Scalar z187 = v_beta_2 * z35;  // angular acceleration of rod_2, z
    const Scalar z192 = z35 * z36;
    const Scalar z90 = n0_1 * z80 + z84;
    const Scalar z104 = n0_1 * z94 + z98;
    const Scalar z122 = q_s - z44;
    const Scalar z124 = z118 * z118 + z119 * z119;
    const Scalar z148 = q_s - z61;
    const Scalar z150 = z144 * z144 + z145 * z145;
    const Scalar z191 = n2 * z187;
    const Scalar z193 = n2 * z186;
    const Scalar z136 = n2 * (z118 * z134 - z119 * z135);
    const Scalar z162 = n2 * (z144 * z160 - z145 * z161);
    const Scalar z195 = n5_15 * z191;  // force on rod_2, y
    const Scalar z197 = k8 * z193;  // moment on rod_2, x
    const Scalar z92 = k9 + z90;
    const Scalar z208 = z25 * z26;
    const Scalar z207 = n2 * z183;
    const Scalar z209 = n2 * z182;
    const Scalar z199 = n5_1 * z191;  // moment on rod_2, z
    const Scalar z125 = traits::sqrt(z124);
    const Scalar z151 = traits::sqrt(z150);
    const Scalar z203 = s_beta_2 * z197 - c_beta_2 * z199;
    const Scalar z110 = z92 + z104;
    const Scalar z211 = n5_15 * z207;  // force on rod_1, y
    const Scalar z213 = k8 * z209;  // moment on rod_1, x
    const Scalar z215 = n5_1 * z207;  // moment on rod_1, z
    const Scalar z219 = s_beta_1 * z213 - c_beta_1 * z215;
    const Scalar z137 = n0_5 * z136;
    const Scalar z163 = n0_5 * z162;
    const Scalar z226 = n0_05 * (z195 + z211) - z203 - z219;  // moment on shaft, z
    const Scalar z138 = n40000 * z137 / z124;
    const Scalar z164 = n40000 * z163 / z150;
    const Scalar z268 = a_psi * z110 - z226;
    const Scalar z126 = n1 / z125;
    const Scalar z152 = n1 / z151;
    const Scalar z140 = z118 * z138;
    const Scalar z142 = z122 * z138;
    const Scalar z166 = z144 * z164;
    const Scalar z168 = z148 * z164;
    const Scalar z127 = n800000 - n400000 * z126;
    const Scalar z153 = n800000 - n400000 * z152;
    const Scalar z130 = z118 * z127;
    const Scalar z132 = z122 * z127;
    const Scalar z156 = z144 * z153;
    const Scalar z158 = z148 * z153;
    const Scalar z170 = z132 - z142 + z158 - z168;
    const Scalar z174 = n0_5 * (z130 - z140);
    const Scalar z177 = n0_5 * (z156 - z166);
    const Scalar z198 = z177 - n5_15 * z185 - k3 * z192;  // moment on rod_2, y
    const Scalar z214 = z174 - n5_15 * z181 - k3 * z208;  // moment on rod_1, y
    const Scalar z220 = n29_43 + z170;  // force on slider, z
    const Scalar z269 = n3 * a_s + z220;
    const Scalar z270 = k16 * a_beta_1 - z214;
    const Scalar z271 = k16 * a_beta_2 - z198;
    residual[0] = z268;
    residual[1] = z269;
    residual[2] = z270;
    residual[3] = z271;
  }

  /// Derivatives of residual by (q, v, a, lambda) without those that vanish identically: `values` of
  /// compressed rows. r = M a + h - E u.
  TORSOR_DEVICE static void residual_jacobian(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, ResidualJacobian& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k8 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar n5_1 = traits::constant(5.1, 5.1f, "51/10");
    const Scalar k10 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k15 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z815 = n1 - q_s;
    const Scalar z825 = v_beta_1 * s_beta_1;
    const Scalar z840 = v_beta_2 * s_beta_2;
    const Scalar z797 = v_beta_1 * c_beta_1;
    const Scalar z800 = v_beta_2 * c_beta_2;
    const Scalar z791 = v_psi * s_beta_1;
    const Scalar z816 = s_beta_1 * z815;
    const Scalar z817 = c_beta_1 * z815;
    const Scalar z831 = s_beta_2 * z815;
    const Scalar z832 = c_beta_2 * z815;
    const Scalar z793 = v_psi * s_beta_2;
    const Scalar z792 = v_psi * c_beta_1;
    const Scalar z794 = v_psi * c_beta_2;
    const Scalar z795 = n0_5 * s_beta_1;
    const Scalar z798 = n0_5 * s_beta_2;
    const Scalar z804 = k2 * c_beta_2;
    const Scalar z811 = k2 * c_beta_1;
    const Scalar z846 = v_psi * v_psi;
    const Scalar z803 = k2 * s_beta_2;
    const Scalar z810 = k2 * s_beta_1;
    const Scalar z847 = n0_05 * z846;
    const Scalar z802 = n5_15 * c_beta_2;
    const Scalar z819 = n0_5 * c_beta_1;
    const Scalar z834 = n0_5 * c_beta_2;
    const Scalar z801 = n5_15 * s_beta_2;
    const Scalar z808 = n5_15 * s_beta_1;
    const Scalar z848 = n9_81 * s_beta_1 + c_beta_1 * z847;
    const Scalar z851 = n9_81 * s_beta_2 + c_beta_2 * z847;
    const Scalar z809 = n5_15 * c_beta_1;
    const Scalar z796 = n1 - z795;
    const Scalar z799 = n1 - z798;
    const Scalar z805 = c_beta_2 * z804;
    const Scalar z812 = c_beta_1 * z811;
    const Scalar z818 = n0_5 - z816;
    const Scalar z826 = v_s * c_beta_1 + z815 * z825;
    const Scalar z827 = v_s * s_beta_1 - z797 * z815;
    const Scalar z833 = n0_5 - z831;
    const Scalar z841 = v_s * c_beta_2 + z815 * z840;
    const Scalar z842 = v_s * s_beta_2 - z800 * z815;
    const Scalar z849 = v_beta_1 * z792;  // angular acceleration of rod_1, x
    const Scalar z850 = v_beta_1 * z791;  // angular acceleration of rod_1, z
    const Scalar z852 = v_beta_2 * z794;  // angular acceleration of rod_2, x
    const Scalar z853 = v_beta_2 * z793;  // angular acceleration of rod_2, z
    const Scalar z862 = n2 * z840;
    const Scalar z864 = n2 * z800;
    const Scalar z806 = n0_1 * z802 + z805;
    const Scalar z813 = n0_1 * z809 + z812;
    const Scalar z820 = q_s - z796;
    const Scalar z821 = z817 * z817 + z818 * z818;
    const Scalar z835 = q_s - z799;
    const Scalar z836 = z832 * z832 + z833 * z833;
    const Scalar z854 = n2 * z853;
    const Scalar z855 = n2 * z852;
    const Scalar z858 = n2 * z850;
    const Scalar z859 = n2 * z849;
    const Scalar z863 = n5_15 * z862;
    const Scalar z865 = k8 * z864;
    const Scalar z866 = n5_1 * z862;
    const Scalar z828 = n2 * (z817 * z826 - z818 * z827);
    const Scalar z843 = n2 * (z832 * z841 - z833 * z842);
    const Scalar z856 = k8 * z855;  // moment on rod_2, x
    const Scalar z857 = n5_1 * z854;  // moment on rod_2, z
    const Scalar z860 = k8 * z859;  // moment on rod_1, x
    const Scalar z861 = n5_1 * z858;  // moment on rod_1, z
    const Scalar z807 = k10 + z806;
    const Scalar z867 = s_beta_2 * z865 - c_beta_2 * z866;
    const Scalar z868 = n2 * z825;
    const Scalar z870 = n2 * z797;
    const Scalar z869 = n5_15 * z868;
    const Scalar z871 = k8 * z870;
    const Scalar z872 = n5_1 * z868;
    const Scalar z873 = s_beta_1 * z871 - c_beta_1 * z872;
    const Scalar z822 = traits::sqrt(z821);
    const Scalar z837 = traits::sqrt(z836);
    const Scalar z814 = z807 + z813;
    const Scalar z875 = n2 * v_psi;
    const Scalar z876 = n0_05 * z875;
    const Scalar z878 = s_beta_1 * z792 + c_beta_1 * z791;
    const Scalar z881 = s_beta_2 * z794 + c_beta_2 * z793;
    const Scalar z877 = s_beta_1 * z876;
    const Scalar z880 = s_beta_2 * z876;
    const Scalar z879 = n5_15 * z877 + k2 * z878;
    const Scalar z882 = n5_15 * z880 + k2 * z881;
    const Scalar z874 = n0_05 * (z863 + z869) - z867 - z873;
    const Scalar z829 = n0_5 * z828;
    const Scalar z844 = n0_5 * z843;
    const Scalar z830 = n40000 * z829 / z821;
    const Scalar z845 = n40000 * z844 / z836;
    const Scalar z823 = n1 / z822;
    const Scalar z883 = n2 * (s_beta_1 * z818 - c_beta_1 * z817);
    const Scalar z838 = n1 / z837;
    const Scalar z824 = n800000 - n400000 * z823;
    const Scalar z896 = n2 * (z817 * z825 + z797 * z818 + s_beta_1 * z827 + c_beta_1 * z826);
    const Scalar z897 = n0_5 * z896;
    const Scalar z887 = n2 * (s_beta_2 * z833 - c_beta_2 * z832);
    const Scalar z884 = n0_5 * z883;
    const Scalar z898 = n40000 * (z829 * z883 / (z821 * z821) + z897 / z821);
    const Scalar z888 = n0_5 * z887;
    const Scalar z892 = z884 / z822;
    const Scalar z885 = n40000 * z884 / z821;
    const Scalar z889 = n40000 * z888 / z836;
    const Scalar z839 = n800000 - n400000 * z838;
    const Scalar z904 = n2 * (z832 * z840 + z800 * z833 + s_beta_2 * z842 + c_beta_2 * z841);
    const Scalar z926 = s_beta_1 * z811 + c_beta_1 * z810;
    const Scalar z927 = n0_1 * z808 + z926;
    const Scalar z942 = z826 * n2 * (z816 + z818);
    const Scalar z934 = z817 * n2 * (z816 + z818);
    const Scalar z943 = n0_5 * z942;
    const Scalar z905 = n0_5 * z904;
    const Scalar z906 = n40000 * (z844 * z887 / (z836 * z836) + z905 / z836);
    const Scalar z944 = n40000 * (z829 * z934 / (z821 * z821) - z943 / z821);
    const Scalar z935 = n0_5 * z934;
    const Scalar z900 = z888 / z837;
    const Scalar z929 = k8 * z858;
    const Scalar z893 = z892 / (z822 * z822);
    const Scalar z901 = z900 / (z837 * z837);
    const Scalar z894 = n400000 * z893;
    const Scalar z936 = n40000 * z935 / z821;
    const Scalar z938 = z935 / z822;
    const Scalar z930 = n5_1 * z859;
    const Scalar z931 = s_beta_1 * (z861 - z929) + c_beta_1 * (z860 - z930);
    const Scalar z928 = n5_15 * z859;
    const Scalar z921 = n2 * z792;
    const Scalar z922 = k8 * z921;
    const Scalar z919 = n2 * z791;
    const Scalar z899 = z820 * z898 - z830;
    const Scalar z912 = c_beta_1 * z830 + z817 * z898;
    const Scalar z932 = n0_05 * z928 - z931;
    const Scalar z939 = z938 / (z822 * z822);
    const Scalar z902 = n400000 * z901;
    const Scalar z907 = z835 * z906 - z845;
    const Scalar z917 = c_beta_2 * z845 + z832 * z906;
    const Scalar z933 = a_psi * z927 + z932;
    const Scalar z937 = z820 * z936;
    const Scalar z923 = n5_1 * z919;
    const Scalar z924 = s_beta_1 * z922 - c_beta_1 * z923;
    const Scalar z920 = n5_15 * z919;
    const Scalar z895 = z820 * z894 + z824;
    const Scalar z911 = c_beta_1 * z824 - z817 * z894;
    const Scalar z913 = n0_5 * (z911 - z912);
    const Scalar z925 = n0_05 * z920 - z924;
    const Scalar z940 = n400000 * z939;
    const Scalar z916 = c_beta_2 * z839 - z832 * z902;
    const Scalar z918 = n0_5 * (z916 - z917);
    const Scalar z903 = z835 * z902 + z839;
    const Scalar z908 = z899 + z907 + z895 + z903;
    const Scalar z886 = z820 * z885;
    const Scalar z909 = z817 * z885;
    const Scalar z910 = n0_5 * z909;
    const Scalar z947 = z817 * z936;
    const Scalar z948 = n0_5 * z947;
    const Scalar z949 = z816 * z824 + z817 * z940;
    const Scalar z941 = z819 * z824 - z820 * z940;
    const Scalar z945 = z819 * z830 + z820 * z944;
    const Scalar z946 = z941 - z945;
    const Scalar z890 = z835 * z889;
    const Scalar z950 = z816 * z830 - z817 * z944;
    const Scalar z891 = z886 + z890;
    const Scalar z951 = n0_5 * (z949 - z950);
    const Scalar z961 = s_beta_2 * z804 + c_beta_2 * z803;
    const Scalar z952 = z791 * z791 - z792 * z792;
    const Scalar z962 = n0_1 * z801 + z961;
    const Scalar z964 = k8 * z854;
    const Scalar z953 = n5_15 * z848 + z951 - k2 * z952;
    const Scalar z914 = z832 * z889;
    const Scalar z915 = n0_5 * z914;
    const Scalar z969 = z832 * n2 * (z831 + z833);
    const Scalar z977 = z841 * n2 * (z831 + z833);
    const Scalar z970 = n0_5 * z969;
    const Scalar z978 = n0_5 * z977;
    const Scalar z965 = n5_1 * z855;
    const Scalar z966 = s_beta_2 * (z857 - z964) + c_beta_2 * (z856 - z965);
    const Scalar z973 = z970 / z837;
    const Scalar z979 = n40000 * (z844 * z969 / (z836 * z836) - z978 / z836);
    const Scalar z956 = n2 * z794;
    const Scalar z954 = n2 * z793;
    const Scalar z957 = k8 * z956;
    const Scalar z958 = n5_1 * z954;
    const Scalar z971 = n40000 * z970 / z836;
    const Scalar z963 = n5_15 * z855;
    const Scalar z955 = n5_15 * z954;
    const Scalar z959 = s_beta_2 * z957 - c_beta_2 * z958;
    const Scalar z967 = n0_05 * z963 - z966;
    const Scalar z987 = z793 * z793 - z794 * z794;
    const Scalar z974 = z973 / (z837 * z837);
    const Scalar z968 = a_psi * z962 + z967;
    const Scalar z982 = z832 * z971;
    const Scalar z960 = n0_05 * z955 - z959;
    const Scalar z972 = z835 * z971;
    const Scalar z983 = n0_5 * z982;
    const Scalar z980 = z834 * z845 + z835 * z979;
    const Scalar z985 = z831 * z845 - z832 * z979;
    const Scalar z975 = n400000 * z974;
    const Scalar z976 = z834 * z839 - z835 * z975;
    const Scalar z984 = z831 * z839 + z832 * z975;
    const Scalar z981 = z976 - z980;
    const Scalar z986 = n0_5 * (z984 - z985);
    const Scalar z988 = n5_15 * z851 + z986 - k2 * z987;
    result.values[0] = -z933;
    result.values[1] = -z968;
    result.values[2] = -z874;
    result.values[3] = -z925;
    result.values[4] = -z960;
    result.values[5] = z814;
    result.values[6] = z908;
    result.values[7] = z946;
    result.values[8] = z981;
    result.values[9] = z891;
    result.values[10] = -z937;
    result.values[11] = -z972;
    result.values[12] = n3;
    result.values[13] = z913;
    result.values[14] = z953;
    result.values[15] = z879;
    result.values[16] = -z910;
    result.values[17] = z948;
    result.values[18] = k15;
    result.values[19] = z918;
    result.values[20] = z988;
    result.values[21] = z882;
    result.values[22] = -z915;
    result.values[23] = z983;
    result.values[24] = k15;
  }
};

}  // namespace flyball_governor
