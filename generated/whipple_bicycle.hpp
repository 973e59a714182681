// SPDX-License-Identifier: MIT
// whipple_bicycle: Whipple's bicycle: two rolling wheels, benchmark of 2007
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: mass_matrix, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix              88              131          0             0                  4       0    227     232
//   forward_dynamics       1098             1467         26             2                  4       0   2601    2670
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             339              520         14             2                  4       0    883     941
//   linearisation          2887             3784        107             2                  6       0   6792    7192
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 81 results 28 vanish identically, 21 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: of 72 results 30 vanish identically, 2 repeat another up to sign
//   linearisation: of 394 results 187 vanish identically, 26 repeat another up to sign
//
// To write this file again:
//   whipple_bicycle_scene generate --kernels mass_matrix,forward_dynamics,energy,first_integrals,constraints,linearisation --output whipple_bicycle.hpp
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

namespace whipple_bicycle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "whipple_bicycle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x596ffdc3ba98913dULL;
  static constexpr int coordinate_count = 9;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar yaw;  ///< coordinate [rad or 1]
    Scalar roll;  ///< coordinate [rad or 1]
    Scalar pitch;  ///< coordinate [rad or 1]
    Scalar steer;  ///< coordinate [rad or 1]
    Scalar rear;  ///< coordinate [rad or 1]
    Scalar front;  ///< coordinate [rad or 1]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z, &Coordinates::yaw,
          &Coordinates::roll, &Coordinates::pitch, &Coordinates::steer, &Coordinates::rear, &Coordinates::front};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar yaw;  ///< its rate [rad/s]
    Scalar roll;  ///< its rate [rad/s]
    Scalar pitch;  ///< its rate [rad/s]
    Scalar steer;  ///< its rate [rad/s]
    Scalar rear;  ///< its rate [rad/s]
    Scalar front;  ///< its rate [rad/s]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z, &Velocities::yaw,
          &Velocities::roll, &Velocities::pitch, &Velocities::steer, &Velocities::rear, &Velocities::front};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar yaw;  ///< its second rate [rad/s^2]
    Scalar roll;  ///< its second rate [rad/s^2]
    Scalar pitch;  ///< its second rate [rad/s^2]
    Scalar steer;  ///< its second rate [rad/s^2]
    Scalar rear;  ///< its second rate [rad/s^2]
    Scalar front;  ///< its second rate [rad/s^2]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::yaw, &Accelerations::roll, &Accelerations::pitch, &Accelerations::steer, &Accelerations::rear,
          &Accelerations::front};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar yaw;  ///< works with the rate of yaw [N m]
    Scalar roll;  ///< works with the rate of roll [N m]
    Scalar pitch;  ///< works with the rate of pitch [N m]
    Scalar steer;  ///< works with the rate of steer [N m]
    Scalar rear;  ///< works with the rate of rear [N m]
    Scalar front;  ///< works with the rate of front [N m]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::yaw, &GeneralizedForces::roll, &GeneralizedForces::pitch,
          &GeneralizedForces::steer, &GeneralizedForces::rear, &GeneralizedForces::front};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_rear_touches;  ///< of the constraint rear_touches [N]
    Scalar lambda_front_touches;  ///< of the constraint front_touches [N]
    Scalar lambda_rear_rolls_x;  ///< of the constraint rear_rolls_x [N]
    Scalar lambda_rear_rolls_y;  ///< of the constraint rear_rolls_y [N]
    Scalar lambda_front_rolls_x;  ///< of the constraint front_rolls_x [N]
    Scalar lambda_front_rolls_y;  ///< of the constraint front_rolls_y [N]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_rear_touches,
          &Multipliers::lambda_front_touches, &Multipliers::lambda_rear_rolls_x, &Multipliers::lambda_rear_rolls_y,
          &Multipliers::lambda_front_rolls_x, &Multipliers::lambda_front_rolls_y};
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n4_6 = traits::constant(4.6, 4.6f, "23/5");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n46_over_3 = traits::constant(15.333333333333334, 15.333333f, "46/3");
    const Scalar n92_over_7 = traits::constant(13.142857142857142, 13.142858f, "92/7");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.z = -n0_3;
    state.q.yaw = n0;
    state.q.roll = n0;
    state.q.pitch = n0;
    state.q.steer = n0;
    state.q.rear = n0;
    state.q.front = n0;
    state.v.x = n4_6;
    state.v.y = n0_15;
    state.v.z = n0;
    state.v.yaw = n0;
    state.v.roll = n0_5;
    state.v.pitch = n0;
    state.v.steer = n0;
    state.v.rear = -n46_over_3;
    state.v.front = -n92_over_7;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

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
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy};
      return members_[i_];
    }
  };

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 6> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 6> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 54> jacobian;  ///< A, stored column by column (6 x 9)
    std::array<Scalar, 6> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 81> M;  ///< mass matrix (9 x 9)
    std::array<Scalar, 81> C;  ///< damping and gyroscopic terms (9 x 9)
    std::array<Scalar, 81> K;  ///< stiffness (9 x 9)
    std::array<Scalar, 9> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 21> K_r;  ///< reduced stiffness (3 x 7)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 100> A;  ///< state matrix of x = (e, w): x' = A x + B du (10 x 10)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 7;
  static constexpr int independent_coordinates[] = {0, 1, 3, 4, 6, 7, 8};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[] = {4, 6, 7};

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 81>& mass) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar k3 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k4 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k5 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_yaw = state.q.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar q_steer = state.q.steer;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z1 - n1_04 * z2;
    });
    const Scalar z4 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z1 - k4 * z2;
    });
    const Scalar z5 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z1 - k5 * z2;
    });
    const Scalar z6 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z1 * z4 - z2 * z5;
    });
    const Scalar z7 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z8 = -z7 * (n1 - c_steer);
    const Scalar z9 = z1 * s_steer;
    const Scalar z10 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z11 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z12 = z2 * s_steer;
    const Scalar z13 = n2_8467 * c_steer;
    const Scalar z14 = c_steer * z3;
    const Scalar z15 = n0_28 * c_steer;
    const Scalar z16 = n0_12 * s_roll;
    const Scalar z17 = n0_28 * z12;
    const Scalar z18 = n0_28 * z9;
    const Scalar z19 = z3 * z12;
    const Scalar z20 = z3 * z9;
    const Scalar z21 = z4 * z12 + z5 * z9;
    const Scalar z22 = n1_04 * z12 - n3_85 * z9;
    const Scalar z23 = n2_8467 * z12;
    const Scalar z24 = k3 * z12 + k4 * z9;
    const Scalar z25 = k4 * z12 + k5 * z9;
    const Scalar z26 = n2_8467 * z9;
    const Scalar z27 = s_pitch * z18 - c_pitch * z17;
    const Scalar z28 = s_pitch * z17 + c_pitch * z18;
    const Scalar z29 = s_pitch * z20 - c_pitch * z19;
    const Scalar z30 = s_pitch * z19 + c_pitch * z20;
    const Scalar z31 = k4 * z8;
    const Scalar z32 = z5 * z8 + z4 * z11;
    const Scalar z33 = z4 * z8 + z5 * z10;
    const Scalar z34 = n1_04 * z11 - n3_85 * z8;
    const Scalar z35 = n1_04 * z8 - n3_85 * z10;
    const Scalar z36 = k5 * z8 + k4 * z11;
    const Scalar z37 = k3 * z8 + k4 * z10;
    const Scalar z38 = k3 * z11 + z31;
    const Scalar z39 = k5 * z10 + z31;
    const Scalar z40 = n0_3 * z19 - z21 + n1_1 * z20;
    const Scalar z41 = z11 * z24 - z12 * z13 + z8 * z25;
    const Scalar z42 = c_steer * z13 + z12 * z24 + z9 * z25;
    const Scalar z43 = s_roll * z15 + c_roll * z28;
    const Scalar z44 = n0_3 * z14 - z32;
    const Scalar z45 = n1_1 * z14 - z33;
    const Scalar z46 = s_roll * z30 - c_roll * z14;
    const Scalar z47 = s_roll * z14 + c_roll * z30;
    const Scalar z48 = z12 * z23 + z11 * z38 + z8 * z36;
    const Scalar z49 = z9 * z26 + z8 * z37 + z10 * z39;
    const Scalar z50 = z12 * z26 + z11 * z37 + z8 * z39;
    const Scalar z51 = n9_1 + n0_6 * z35 - n2_2 * z34 + z42;
    const Scalar z52 = n8_47 - n2_2 * z34 + z49;
    const Scalar z53 = n0_63 + n0_6 * z35 + z48;
    const Scalar z54 = n2_31 + n1_1 * z35 - n0_3 * z34 + z50;
    const Scalar z55 = n29_35 - z52;
    const Scalar z56 = n17_7 - z54;
    const Scalar z57 = z53 + z55;
    const Scalar z58 = n49_25 + z51;
    const Scalar z59 = c_steer * z26 - z12 * z37 - z9 * z39;
    const Scalar z60 = n2 * z56;
    const Scalar z61 = n1_1 * z22 + z41;
    const Scalar z62 = s_pitch * z57 - c_pitch * z60;
    const Scalar z63 = n0_12 + z58;
    const Scalar z64 = n2_1 + z35;
    const Scalar z65 = n0_3 * z22 + z59;
    const Scalar z66 = n39_8603 - z63;
    const Scalar z67 = n7_7 - z34;
    const Scalar z68 = s_pitch * z62;
    const Scalar z69 = n51 - z64;
    const Scalar z70 = s_pitch * z61 - c_pitch * z65;
    const Scalar z71 = n25_5 + z67;
    const Scalar z72 = z55 - z68;
    const Scalar z73 = c_pitch * z69 + s_pitch * z71;
    const Scalar z74 = s_pitch * z69 - c_pitch * z71;
    const Scalar z75 = s_pitch * z65 + c_pitch * z61;
    const Scalar z76 = s_roll * z74;
    const Scalar z77 = s_pitch * z44 + c_pitch * z45;
    const Scalar z78 = c_pitch * z62 + z56;
    const Scalar z79 = z53 - z68;
    const Scalar z80 = s_roll * z22 + c_roll * z73;
    const Scalar z81 = s_pitch * z45 - c_pitch * z44;
    const Scalar z82 = s_roll * z73 - c_roll * z22;
    const Scalar z83 = s_roll * z40 - c_roll * z77;
    const Scalar z84 = z72 - z66;
    const Scalar z85 = c_yaw * z29 + s_yaw * z46;
    const Scalar z86 = n2 * z70;
    const Scalar z87 = s_yaw * z29 - c_yaw * z46;
    const Scalar z88 = s_roll * z84 - c_roll * z86;
    const Scalar z89 = c_roll * z74;
    const Scalar z90 = s_roll * z63 - c_roll * z70;
    const Scalar z91 = s_roll * z88;
    const Scalar z92 = s_yaw * z76 - c_yaw * z73;
    const Scalar z93 = s_yaw * z73 + c_yaw * z76;
    const Scalar z94 = z72 - z91;
    const Scalar z95 = n39_8603 + z79;
    const Scalar z96 = s_roll * z75 - c_roll * z78;
    const Scalar z97 = s_yaw * z80;
    const Scalar z98 = c_yaw * z80;
    const Scalar z99 = n39_8603 - z94;
    const Scalar z100 = s_yaw * z74 - c_yaw * z82;
    const Scalar z101 = c_yaw * z74 + s_yaw * z82;
    mass[0] = n94;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z100;
    mass[4] = -z97;
    mass[5] = z92;
    mass[6] = z85;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n94;
    mass[11] = n0;
    mass[12] = -z101;
    mass[13] = z98;
    mass[14] = -z93;
    mass[15] = z87;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n94;
    mass[21] = n0;
    mass[22] = z82;
    mass[23] = z89;
    mass[24] = z47;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = z100;
    mass[28] = -z101;
    mass[29] = n0;
    mass[30] = z99;
    mass[31] = z96;
    mass[32] = z90;
    mass[33] = -z83;
    mass[34] = z16;
    mass[35] = z43;
    mass[36] = -z97;
    mass[37] = z98;
    mass[38] = z82;
    mass[39] = z96;
    mass[40] = z95;
    mass[41] = z75;
    mass[42] = z81;
    mass[43] = n0;
    mass[44] = z27;
    mass[45] = z92;
    mass[46] = -z93;
    mass[47] = z89;
    mass[48] = z90;
    mass[49] = z75;
    mass[50] = z63;
    mass[51] = -z40;
    mass[52] = n0_12;
    mass[53] = z15;
    mass[54] = z85;
    mass[55] = z87;
    mass[56] = z47;
    mass[57] = -z83;
    mass[58] = z81;
    mass[59] = -z40;
    mass[60] = z6;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = z16;
    mass[67] = n0;
    mass[68] = n0_12;
    mass[69] = n0;
    mass[70] = n0_12;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = z43;
    mass[76] = z27;
    mass[77] = z15;
    mass[78] = n0;
    mass[79] = n0;
    mass[80] = n0_28;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar k3 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k4 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k5 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k17 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k18 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar k19 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n9_95 = traits::constant(9.95, 9.95f, "199/20");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n39_3 = traits::constant(39.3, 39.3f, "393/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n0_5603 = traits::constant(0.5603, 0.5603f, "5603/10000");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z1 - n1_04 * z2;
    });
    const Scalar z4 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z1 - k4 * z2;
    });
    const Scalar z5 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z1 - k5 * z2;
    });
    const Scalar z6 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z1 * z4 - z2 * z5;
    });
    const Scalar z7 = traits::formula(6.497839117007668, 6.497839f, [&]() -> Scalar {
      return n1 / z6;
    });
    const Scalar z8 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z1 * z1;
    });
    const Scalar z9 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z10 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z2 * z2;
    });
    const Scalar z11 = -z9 * (n1 - c_steer);
    const Scalar z12 = z1 * s_steer;
    const Scalar z13 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z14 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z15 = z2 * s_steer;
    const Scalar z16 = s_yaw * c_roll;
    const Scalar z17 = n1 - s_roll * s_roll;
    const Scalar z18 = c_yaw * c_roll;
    const Scalar z19 = v_roll * s_roll;
    const Scalar z20 = v_yaw * c_yaw;
    const Scalar z21 = v_roll * c_roll;
    const Scalar z22 = v_yaw * s_yaw;
    const Scalar z23 = s_yaw * s_roll;
    const Scalar z24 = n2 * s_roll;
    const Scalar z25 = c_yaw * s_roll;
    const Scalar z26 = s_roll * z16;
    const Scalar z27 = s_roll * z18;
    const Scalar z28 = s_yaw * z19 - c_roll * z20;
    const Scalar z29 = c_yaw * z19 + c_roll * z22;
    const Scalar z30 = z21 * z24;
    const Scalar z31 = s_roll * z23 - c_roll * z16;
    const Scalar z32 = s_roll * z25 - c_roll * z18;
    const Scalar z33 = c_roll * z24;
    const Scalar z34 = v_roll * z21;
    const Scalar z35 = v_yaw * z22;
    const Scalar z36 = n2 * z19;
    const Scalar z37 = v_roll * z19;
    const Scalar z38 = n2 * z21;
    const Scalar z39 = v_yaw * z20;
    const Scalar z40 = n0_08 * z15 - n0_35 * z12;
    const Scalar z41 = s_pitch * z12 - c_pitch * z15;
    const Scalar z42 = s_pitch * z15 + c_pitch * z12;
    const Scalar z43 = z17 * z17 + z26 * z26 + z27 * z27;
    const Scalar z44 = s_yaw * z34 + c_roll * z35 + z20 * z36;
    const Scalar z45 = c_yaw * z34 + c_roll * z39 - z22 * z36;
    const Scalar z46 = n2 * (s_roll * z37 - z21 * z21);
    const Scalar z47 = n0_08 * z14 - n0_35 * z11;
    const Scalar z48 = n0_08 * z11 - n0_35 * z13;
    const Scalar z49 = s_roll * z28 - z16 * z21;
    const Scalar z50 = s_roll * z29 - z18 * z21;
    const Scalar z51 = n2 * (z17 * z33 + z26 * z31 + z27 * z32);
    const Scalar z52 = s_roll * z42 - c_roll * c_steer;
    const Scalar z53 = s_roll * c_steer + c_roll * z42;
    const Scalar z54 = n0_3 + z48;
    const Scalar z55 = n1_1 - z47;
    const Scalar z56 = traits::sqrt(z43);
    const Scalar z57 = n2 * (z17 * z30 + z26 * z49 + z27 * z50);
    const Scalar z58 = z16 * z37 + z28 * z38 + s_roll * z44;
    const Scalar z59 = z18 * z37 + z29 * z38 + s_roll * z45;
    const Scalar z60 = c_yaw * z41 + s_yaw * z52;
    const Scalar z61 = n2 * (z26 * z58 + z27 * z59 - z17 * z46 - z49 * z49 - z50 * z50 - z30 * z30);
    const Scalar z62 = z53 * z60;
    const Scalar z63 = s_yaw * z41 - c_yaw * z52;
    const Scalar z64 = z53 * z63;
    const Scalar z65 = s_pitch * z55 - c_pitch * z54;
    const Scalar z66 = s_roll * z65 - c_roll * z40;
    const Scalar z67 = s_pitch * z54 + c_pitch * z55;
    const Scalar z68 = n0_5 * z51 / z56;
    const Scalar z69 = s_roll * z40 + c_roll * z65;
    const Scalar z70 = q_z - z69;
    const Scalar z71 = n0_3 / z56;
    const Scalar z72 = n1 - z53 * z53;
    const Scalar z73 = s_yaw * z66 - c_yaw * z67;
    const Scalar z74 = s_yaw * z67 + c_yaw * z66;
    const Scalar z75 = n0_5 * z57 / z56;
    const Scalar z76 = q_y + z74;
    const Scalar z77 = q_x - z73;
    const Scalar z78 = q_x + z26 * z71;
    const Scalar z79 = z72 * z72 + z62 * z62 + z64 * z64;
    const Scalar z80 = n0_5 * (z57 * z75 / (z56 * z56) + z61 / z56);
    const Scalar z81 = n0_3 * z68;
    const Scalar z82 = q_z + z17 * z71;
    const Scalar z83 = q_y - z27 * z71;
    const Scalar z84 = traits::sqrt(z79);
    const Scalar z85 = c_yaw * z53;
    const Scalar z86 = n2 * z53;
    const Scalar z87 = v_pitch * c_pitch;
    const Scalar z88 = v_pitch * s_pitch;
    const Scalar z89 = v_steer * c_steer;
    const Scalar z90 = v_steer * s_steer;
    const Scalar z91 = s_yaw * z53;
    const Scalar z92 = z52 * z60 - z53 * z91;
    const Scalar z93 = z2 * z89;
    const Scalar z94 = z1 * z89;
    const Scalar z95 = z15 * z87 - z12 * z88 + s_pitch * z93 + c_pitch * z94;
    const Scalar z96 = z15 * z88 + z12 * z87 + s_pitch * z94 - c_pitch * z93;
    const Scalar z97 = z9 * z90;
    const Scalar z98 = -z90 * (n1 - z8);
    const Scalar z99 = n0_35 * z97 + n0_08 * z98;
    const Scalar z100 = n0_3 * z80;
    const Scalar z101 = z53 * z85 + z52 * z63;
    const Scalar z102 = n0_35 / z84;
    const Scalar z103 = z2 * c_steer;
    const Scalar z104 = z1 * c_steer;
    const Scalar z105 = s_roll * z41;
    const Scalar z106 = s_pitch * z103 + c_pitch * z104;
    const Scalar z107 = s_yaw * z105 - c_yaw * z42;
    const Scalar z108 = s_yaw * z42 + c_yaw * z105;
    const Scalar z109 = c_roll * z41;
    const Scalar z110 = z53 * z108 - z63 * z109;
    const Scalar z111 = z52 * z86;
    const Scalar z112 = n2 * (z64 * z101 - z72 * z111 + z62 * z92);
    const Scalar z113 = z53 * z107 + z60 * z109;
    const Scalar z114 = z86 * z109;
    const Scalar z115 = z77 - z62 * z102;
    const Scalar z116 = z70 + z72 * z102;
    const Scalar z117 = n2 * (z62 * z113 - z64 * z110 - z72 * z114);
    const Scalar z118 = z76 - z64 * z102;
    const Scalar z119 = n0_5 * z112 / z84;
    const Scalar z120 = s_pitch * z104 - c_pitch * z103;
    const Scalar z121 = n0_08 * z103 - n0_35 * z104;
    const Scalar z122 = c_roll * s_steer + s_roll * z106;
    const Scalar z123 = s_roll * s_steer - c_roll * z106;
    const Scalar z124 = c_yaw * z120 + s_yaw * z122;
    const Scalar z125 = s_yaw * z120 - c_yaw * z122;
    const Scalar z126 = z53 * z124 - z60 * z123;
    const Scalar z127 = n0_5 * z117 / z84;
    const Scalar z128 = s_steer * z9;
    const Scalar z129 = s_steer * (n1 - z8);
    const Scalar z130 = n0_08 * z129 - n0_35 * z128;
    const Scalar z131 = s_steer * (n1 - z10);
    const Scalar z132 = n0_08 * z128 - n0_35 * z131;
    const Scalar z133 = z66 - n0_35 * z119;
    const Scalar z134 = c_roll * z90 + c_steer * z19 + z21 * z42 + s_roll * z95;
    const Scalar z135 = c_pitch * z132 + s_pitch * z130;
    const Scalar z136 = z20 * z41 + z22 * z52 + s_yaw * z96 - c_yaw * z134;
    const Scalar z137 = s_roll * z121 + c_roll * z135;
    const Scalar z138 = s_roll * z90 - c_steer * z21 + z19 * z42 - c_roll * z95;
    const Scalar z139 = z20 * z52 - z22 * z41 + c_yaw * z96 + s_yaw * z134;
    const Scalar z140 = z138 * z86;
    const Scalar z141 = z53 * z136 - z63 * z138;
    const Scalar z142 = -z90 * (n1 - z10);
    const Scalar z143 = n0_08 * z97 + n0_35 * z142;
    const Scalar z144 = c_roll * z67;
    const Scalar z145 = z144 + n0_35 * z127;
    const Scalar z146 = z53 * z139 - z60 * z138;
    const Scalar z147 = n0_08 * z93 - n0_35 * z94;
    const Scalar z148 = z86 * z123;
    const Scalar z149 = z53 * z125 - z63 * z123;
    const Scalar z150 = n2 * (z72 * z148 + z62 * z126 + z64 * z149);
    const Scalar z151 = v_steer * z90;
    const Scalar z152 = z2 * z151;
    const Scalar z153 = z1 * z151;
    const Scalar z154 = n2 * (z72 * z140 + z64 * z141 + z62 * z146);
    const Scalar z155 = s_pitch * z99 - c_pitch * z143 - z55 * z87 - z54 * z88;
    const Scalar z156 = v_steer * z89;
    const Scalar z157 = n0_5 * z154 / z84;
    const Scalar z158 = n0_5 * z150 / z84;
    const Scalar z159 = z21 * z40 + s_roll * z147 - z19 * z65 - c_roll * z155;
    const Scalar z160 = v_z - z159;
    const Scalar z161 = n0_3 * z75 / (z56 * z56);
    const Scalar z162 = v_z - z71 * z30 + z17 * z161;
    const Scalar z163 = v_y + z71 * z50 - z27 * z161;
    const Scalar z164 = v_x - z71 * z49 + z26 * z161;
    const Scalar z165 = q_z - z82;
    const Scalar z166 = q_x - z78;
    const Scalar z167 = q_y - z83;
    const Scalar z168 = v_z - z162;
    const Scalar z169 = v_y - z163;
    const Scalar z170 = v_x - z164;
    const Scalar z171 = s_pitch * z1 - c_pitch * z2;
    const Scalar z172 = z137 - n0_35 * z158;
    const Scalar z173 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z174 = s_roll * z173;
    const Scalar z175 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z176 = s_roll * z171;
    const Scalar z177 = s_pitch * z2 + c_pitch * z1;
    const Scalar z178 = q_x - z115;
    const Scalar z179 = c_roll * z171;
    const Scalar z180 = q_z - z116;
    const Scalar z181 = s_yaw * z176 - c_yaw * z177;
    const Scalar z182 = c_yaw * z180;
    const Scalar z183 = s_roll * z178 + z16 * z180;
    const Scalar z184 = q_y - z118;
    const Scalar z185 = s_yaw * z177 + c_yaw * z176;
    const Scalar z186 = s_yaw * z180;
    const Scalar z187 = s_roll * z184 - z18 * z180;
    const Scalar z188 = c_yaw * z165;
    const Scalar z189 = s_yaw * z165;
    const Scalar z190 = v_pitch * z88;
    const Scalar z191 = v_pitch * z87;
    const Scalar z192 = z15 * z190 + z12 * z191 + s_pitch * z152 + c_pitch * z153 - n2 * (z93 * z87 - z94 * z88);
    const Scalar z193 = z12 * z190 - z15 * z191 + s_pitch * z153 - c_pitch * z152 - n2 * (z93 * z88 + z94 * z87);
    const Scalar z194 = n0_08 * z152 - n0_35 * z153;
    const Scalar z195 = s_yaw * z174 - c_yaw * z175;
    const Scalar z196 = c_roll * z173;
    const Scalar z197 = s_roll * z166 + z16 * z165;
    const Scalar z198 = n2 * z138;
    const Scalar z199 = s_roll * z167 - z18 * z165;
    const Scalar z200 = z37 * z42 - c_roll * z156 - c_steer * z34 - n2 * (z21 * z95 - z19 * z90) + s_roll * z192;
    const Scalar z201 = s_roll * z156 + c_steer * z37 + z34 * z42 + n2 * (z21 * z90 + z19 * z95) + c_roll * z192;
    const Scalar z202 = z35 * z41 - z39 * z52 - n2 * (z20 * z96 + z22 * z134) + s_yaw * z193 - c_yaw * z200;
    const Scalar z203 = z39 * z41 + z35 * z52 - n2 * (z20 * z134 - z22 * z96) + c_yaw * z193 + s_yaw * z200;
    const Scalar z204 = z136 * z198 + z63 * z201 + z53 * z202;
    const Scalar z205 = z139 * z198 + z60 * z201 + z53 * z203;
    const Scalar z206 = n2 * (z53 * z201 - z138 * z138);
    const Scalar z207 = n2 * (z64 * z204 - z140 * z140 - z141 * z141 - z146 * z146 - z72 * z206 + z62 * z205);
    const Scalar z208 = z9 * z156;
    const Scalar z209 = -z156 * (n1 - z8);
    const Scalar z210 = q_z - z196;
    const Scalar z211 = n0_35 * z208 + n0_08 * z209;
    const Scalar z212 = -z156 * (n1 - z10);
    const Scalar z213 = n0_08 * z208 + n0_35 * z212;
    const Scalar z214 = q_x - z195;
    const Scalar z215 = z115 - z214;
    const Scalar z216 = z116 - z210;
    const Scalar z217 = s_yaw * z175 + c_yaw * z174;
    const Scalar z218 = s_pitch * z211 - z54 * z191 - c_pitch * z213 + z55 * z190 + n2 * (z87 * z99 + z88 * z143);
    const Scalar z219 = q_y + z217;
    const Scalar z220 = n0_5 * (z154 * z157 / (z84 * z84) + z207 / z84);
    const Scalar z221 = z118 - z219;
    const Scalar z222 = z179 * z221 + z185 * z216;
    const Scalar z223 = z20 * z165 + s_yaw * z168;
    const Scalar z224 = c_yaw * z168 - z22 * z165;
    const Scalar z225 = z21 * z167 + z29 * z165 + s_roll * z169 - z18 * z168;
    const Scalar z226 = z37 * z40 + s_roll * z194 + z34 * z65 - n2 * (z21 * z147 + z19 * z155) + c_roll * z218;
    const Scalar z227 = c_roll * z147 - z19 * z40 - z21 * z65 + s_roll * z155;
    const Scalar z228 = s_pitch * z143 + c_pitch * z99 + z55 * z88 - z54 * z87;
    const Scalar z229 = v_yaw * z169 - v_roll * z223 + z225 * (v_pitch + v_rear);
    const Scalar z230 = z77 - z115;
    const Scalar z231 = z70 - z116;
    const Scalar z232 = z76 - z118;
    const Scalar z233 = n0_35 * z157 / (z84 * z84);
    const Scalar z234 = z21 * z166 - z28 * z165 + s_roll * z170 + z16 * z168;
    const Scalar z235 = v_yaw * z170 - v_roll * z224 + z234 * (v_pitch + v_rear);
    const Scalar z236 = z226 - n0_35 * z220;
    const Scalar z237 = z72 * z233 - z160 - z102 * z140;
    const Scalar z238 = z160 + z237;
    const Scalar z239 = z179 * z215 - z181 * z216;
    const Scalar z240 = z53 * z230 - z60 * z231;
    const Scalar z241 = z53 * z232 - z63 * z231;
    const Scalar z242 = v_yaw * s_roll;
    const Scalar z243 = v_yaw * c_roll;
    const Scalar z244 = v_pitch + z242;  // angular velocity of frame, y
    const Scalar z245 = v_roll * z242;  // angular acceleration of frame.2, z
    const Scalar z246 = v_roll * c_pitch - s_pitch * z243;
    const Scalar z247 = v_roll * s_pitch + c_pitch * z243;
    const Scalar z248 = s_pitch * z245;
    const Scalar z249 = c_pitch * z245;
    const Scalar z250 = n9_81 * c_roll;
    const Scalar z251 = v_pitch * z247 - z248;  // angular acceleration of frame, x
    const Scalar z252 = v_pitch * z246 - z249;  // angular acceleration of frame, z
    const Scalar z253 = v_roll * z243;  // angular acceleration of frame.2, y
    const Scalar z254 = z244 * z244;
    const Scalar z255 = z247 * z247;
    const Scalar z256 = s_pitch * z250;
    const Scalar z257 = c_pitch * z250;
    const Scalar z258 = n9_81 * s_roll;
    const Scalar z259 = v_rear + z244;  // angular velocity of rear_wheel, y
    const Scalar z260 = n0_3 * z87 - n1_1 * z88;
    const Scalar z261 = s_yaw * z227 - c_yaw * z228 - z20 * z66 - z22 * z67;
    const Scalar z262 = s_yaw * z228 - z20 * z67 + z22 * z66 + c_yaw * z227;
    const Scalar z263 = v_x + z261;
    const Scalar z264 = z263 - z102 * z146 + z62 * z233;
    const Scalar z265 = v_y - z262;
    const Scalar z266 = z265 - z102 * z141 + z64 * z233;
    const Scalar z267 = z254 + z255;
    const Scalar z268 = z246 * z247;
    const Scalar z269 = z246 * z244;
    const Scalar z270 = z253 + z268;
    const Scalar z271 = z1 * z88 - z2 * z87;
    const Scalar z272 = z263 - z264;
    const Scalar z273 = z1 * z87 + z2 * z88;
    const Scalar z274 = n1_1 * z87 + n0_3 * z88;
    const Scalar z275 = z53 * z272 - z138 * z230 - z139 * z231 - z60 * z238;
    const Scalar z276 = z265 - z266;
    const Scalar z277 = z53 * z276 - z138 * z232 - z136 * z231 - z63 * z238;
    const Scalar z278 = z21 * z173 + s_roll * z274;
    const Scalar z279 = c_roll * z274 - z19 * z173;
    const Scalar z280 = c_roll * z273 - z19 * z171;
    const Scalar z281 = z21 * z171 + s_roll * z273;
    const Scalar z282 = v_z - z279;
    const Scalar z283 = z237 + z282;
    const Scalar z284 = v_z + z237;
    const Scalar z285 = z22 * z175 - c_yaw * z260 + z20 * z174 + s_yaw * z278;
    const Scalar z286 = z20 * z175 + s_yaw * z260 - z22 * z174 + c_yaw * z278;
    const Scalar z287 = v_x - z285;
    const Scalar z288 = z264 - z287;
    const Scalar z289 = v_x - z264;
    const Scalar z290 = z21 * z178 - z28 * z180 + s_roll * z289 + z16 * z284;
    const Scalar z291 = v_y + z286;
    const Scalar z292 = z266 - z291;
    const Scalar z293 = v_y - z266;
    const Scalar z294 = z21 * z184 + z29 * z180 + s_roll * z293 - z18 * z284;
    const Scalar z295 = z252 + z269;
    const Scalar z296 = z247 * z244;
    const Scalar z297 = z251 + z296;
    const Scalar z298 = z22 * z177 + c_yaw * z271 + z20 * z176 + s_yaw * z281;
    const Scalar z299 = s_yaw * z271 - z20 * z177 + z22 * z176 - c_yaw * z281;
    const Scalar z300 = z215 * z280 - z216 * z298 + z179 * z288 + z181 * z283;
    const Scalar z301 = z221 * z280 - z216 * z299 + z179 * z292 - z185 * z283;
    const Scalar z302 = z20 * z180 + s_yaw * z284;
    const Scalar z303 = c_yaw * z284 - z22 * z180;
    const Scalar z304 = v_yaw * z289 + v_pitch * z290 + v_steer * z300 - v_roll * z303 + v_front * z275;
    const Scalar z305 = v_yaw * z293 - v_roll * z302 + v_pitch * z294 + v_steer * z301 + v_front * z277;
    const Scalar z306 = z12 * z244 + z11 * z246 - z13 * z247;
    const Scalar z307 = z253 - z268;
    const Scalar z308 = z2 * v_steer;
    const Scalar z309 = z246 * z246;
    const Scalar z310 = z254 + z309;
    const Scalar z311 = z255 - z309;
    const Scalar z312 = z15 * z244 - z11 * z247 + z14 * z246;
    const Scalar z313 = c_steer * z244 - z15 * z246 + z12 * z247;
    const Scalar z314 = z246 * z259;
    const Scalar z315 = z247 * z259;
    const Scalar z316 = n0_12 * z314;  // moment on rear_wheel, z
    const Scalar z317 = n0_12 * z315;  // moment on rear_wheel, x
    const Scalar z318 = z1 * v_steer;
    const Scalar z319 = z306 - z308;  // angular velocity of fork, z
    const Scalar z320 = z1 * z306 + z2 * z312;
    const Scalar z321 = z312 + z318;  // angular velocity of fork, x
    const Scalar z322 = c_steer * z253 + z15 * z251 + z12 * z252;
    const Scalar z323 = v_steer * z320 - z322;  // angular acceleration of fork, y
    const Scalar z324 = z256 - n1_1 * z267 + n0_3 * z270;
    const Scalar z325 = z313 * z313;
    const Scalar z326 = z319 * z319;
    const Scalar z327 = z258 - n1_1 * z295 - n0_3 * z297;
    const Scalar z328 = z257 + n1_1 * z307 + n0_3 * z310;
    const Scalar z329 = z325 + z326;
    const Scalar z330 = z321 * z319;
    const Scalar z331 = z11 * z251 - z12 * z253 + z13 * z252;
    const Scalar z332 = z14 * z251 - z15 * z253 + z11 * z252;
    const Scalar z333 = z313 * z318 - z331;  // angular acceleration of fork, z
    const Scalar z334 = z313 * z308 - z332;  // angular acceleration of fork, x
    const Scalar z335 = z242 * z243;
    const Scalar z336 = n2 * z245;
    const Scalar z337 = z323 + z330;
    const Scalar z338 = z323 - z330;
    const Scalar z339 = z321 * z321;
    const Scalar z340 = z325 + z339;
    const Scalar z341 = z326 - z339;
    const Scalar z342 = v_front + z313;  // angular velocity of front_wheel, y
    const Scalar z343 = z14 * z324 - z15 * z327 + z11 * z328;
    const Scalar z344 = n1_04 * z329 + n3_85 * z337 + n7 * z343;  // force on fork, x
    const Scalar z345 = z15 * z324 + z12 * z328 + c_steer * z327;
    const Scalar z346 = z11 * z324 - z12 * z327 + z13 * z328;
    const Scalar z347 = n1_04 * z338 - n3_85 * z340 + n7 * z346;  // force on fork, z
    const Scalar z348 = z3 * z15;
    const Scalar z349 = n0_28 * c_steer;
    const Scalar z350 = n0_28 * z12;
    const Scalar z351 = n0_28 * z15;
    const Scalar z352 = s_pitch * z350 - c_pitch * z351;
    const Scalar z353 = s_pitch * z351 + c_pitch * z350;
    const Scalar z354 = z313 * z321;
    const Scalar z355 = z321 * z342;
    const Scalar z356 = z313 * z319;
    const Scalar z357 = z319 * z342;
    const Scalar z358 = n0_28 * z355;  // moment on front_wheel, z
    const Scalar z359 = n0_28 * z357;  // moment on front_wheel, x
    const Scalar z360 = c_steer * z3;
    const Scalar z361 = z333 - z354;
    const Scalar z362 = s_roll * z349 + c_roll * z353;
    const Scalar z363 = n3_85 * z345 - z359 - k17 * z356 - k3 * z334 - k4 * z361;  // moment on fork, x
    const Scalar z364 = z334 + z356;
    const Scalar z365 = k18 * z354 + z358 - k5 * z333 - k4 * z364 + n1_04 * z345;  // moment on fork, z
    const Scalar z366 = n7 * z345 - n1_04 * z361 - n3_85 * z364;  // force on fork, y
    const Scalar z367 = z4 * z15 + z5 * z12;
    const Scalar z368 = z3 * z12;
    const Scalar z369 = n0_3 * z348 - z367 + n1_1 * z368;
    const Scalar z370 = z4 * z11 + z5 * z13;
    const Scalar z371 = n1_1 * z360 - z370;
    const Scalar z372 = z5 * z11 + z4 * z14;
    const Scalar z373 = n0_3 * z360 - z372;
    const Scalar z374 = s_pitch * z348 + c_pitch * z368;
    const Scalar z375 = s_pitch * z368 - c_pitch * z348;
    const Scalar z376 = s_pitch * z371 - c_pitch * z373;
    const Scalar z377 = n0_28 * z323;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z378 = z377 + k19 * z330 + k4 * z341 + n2_5667 * z323 + n3_85 * z343 + n1_04 * z346;
    const Scalar z379 = s_pitch * z373 + c_pitch * z371;
    const Scalar z380 = s_roll * z369 - c_roll * z379;
    const Scalar z381 = n1_04 * z11 - n3_85 * z13;
    const Scalar z382 = n1_04 * z14 - n3_85 * z11;
    const Scalar z383 = n1_04 * z15 - n3_85 * z12;
    const Scalar z384 = s_roll * z360 + c_roll * z374;
    const Scalar z385 = s_roll * z374 - c_roll * z360;
    const Scalar z386 = s_yaw * z375 - c_yaw * z385;
    const Scalar z387 = c_yaw * z375 + s_yaw * z385;
    const Scalar z388 = n0_12 * z253;  // moment on rear_wheel, y
    const Scalar z389 = z14 * z344 + z11 * z347 + z15 * z366;
    const Scalar z390 = n25_5 * z267 - z389 + n51 * z270;  // force on frame, x
    const Scalar z391 = k4 * z11;
    const Scalar z392 = z11 * z344 + z13 * z347 + z12 * z366;
    const Scalar z393 = c_steer * z366 - z15 * z344 - z12 * z347;
    const Scalar z394 = z392 + n25_5 * z307 - n51 * z310;  // force on frame, z
    const Scalar z395 = n2_8467 * z15;
    const Scalar z396 = k3 * z14 + z391;
    const Scalar z397 = z13 * z365 + z11 * z363 - z12 * z378;
    const Scalar z398 = n25_5 * z258 - z316 - n9_95 * z295 + n17_7 * z297 + n1_1 * z393 - z397;  // moment on frame, z
    const Scalar z399 = s_pitch * z390 - c_pitch * z394;
    const Scalar z400 = s_pitch * z394 + c_pitch * z390;
    const Scalar z401 = n25_5 * z295 - z393 - n51 * z297;  // force on frame, y
    const Scalar z402 = z11 * z365 + z14 * z363 - z15 * z378;
    const Scalar z403 = n51 * z258 + z317 - n17_7 * z295 + n39_3 * z297 - n0_3 * z393 + z402;  // moment on frame, x
    const Scalar z404 = z12 * z365 + z15 * z363 + c_steer * z378;
    // moment on frame, y
    const Scalar z405 = z388 + n49_25 * z253 - n51 * z256 + n25_5 * z257 + n29_35 * z268 + n17_7 * z311 + n0_3 * z389
        + n1_1 * z392 - z404;
    const Scalar z406 = z1 * z363 - z2 * z365;
    const Scalar z407 = k5 * z13 + z391;
    const Scalar z408 = n2_8467 * z12;
    const Scalar z409 = k3 * z11 + k4 * z13;
    const Scalar z410 = z12 * z408 + z11 * z409 + z13 * z407;
    const Scalar z411 = n2_8467 * c_steer;
    const Scalar z412 = k5 * z11 + k4 * z14;
    const Scalar z413 = z15 * z395 + z14 * z396 + z11 * z412;
    const Scalar z414 = k3 * z15 + k4 * z12;
    const Scalar z415 = n0_63 + n0_6 * z381 + z413;
    const Scalar z416 = k4 * z15 + k5 * z12;
    const Scalar z417 = z15 * z408 + z14 * z409 + z11 * z407;
    const Scalar z418 = c_steer * z408 - z15 * z409 - z12 * z407;
    const Scalar z419 = z14 * z414 - z15 * z411 + z11 * z416;
    const Scalar z420 = c_steer * z411 + z15 * z414 + z12 * z416;
    const Scalar z421 = n2_31 + n1_1 * z381 - n0_3 * z382 + z417;
    const Scalar z422 = n9_1 + n0_6 * z381 - n2_2 * z382 + z420;
    const Scalar z423 = n1_1 * z383 + z419;
    const Scalar z424 = s_roll * z399 - c_roll * z401;
    const Scalar z425 = s_roll * z401 + c_roll * z399;
    const Scalar z426 = n853_47 - z425;  // force on frame.z, z
    const Scalar z427 = s_pitch * z398 + c_pitch * z403;
    const Scalar z428 = s_pitch * z403 - c_pitch * z398;
    const Scalar z429 = z427 - n0_5603 * z335;  // moment on frame.2, x
    const Scalar z430 = z428 - n0_5603 * z336;  // moment on frame.2, z
    const Scalar z431 = n8_47 - n2_2 * z382 + z410;
    const Scalar z432 = n17_7 - z421;
    const Scalar z433 = n49_25 + z422;
    const Scalar z434 = n0_3 * z383 + z418;
    const Scalar z435 = n2_1 + z381;
    const Scalar z436 = n7_7 - z382;
    const Scalar z437 = n51 - z435;
    const Scalar z438 = n25_5 + z436;
    const Scalar z439 = s_roll * z405 + c_roll * z430;
    const Scalar z440 = n29_35 - z431;
    const Scalar z441 = s_yaw * z424 - c_yaw * z400;
    const Scalar z442 = s_yaw * z400 + c_yaw * z424;
    const Scalar z443 = z415 + z440;
    const Scalar z444 = n2 * z432;
    const Scalar z445 = s_pitch * z443 - c_pitch * z444;
    const Scalar z446 = c_steer * z349 - z433;
    const Scalar z447 = n0_12 + z433;
    const Scalar z448 = n25_over_7 * z349;
    const Scalar z449 = z7 * z369;
    const Scalar z450 = n39_8603 - z447;
    const Scalar z451 = s_pitch * z423 - c_pitch * z434;
    const Scalar z452 = s_pitch * z434 + c_pitch * z423;
    const Scalar z453 = c_pitch * z445 + z432;
    const Scalar z454 = s_pitch * z445;
    const Scalar z455 = s_roll * z447 - c_roll * z451;
    const Scalar z456 = z440 - z454;
    const Scalar z457 = z415 - z454;
    const Scalar z458 = n2 * z451;
    const Scalar z459 = s_roll * z452 - c_roll * z453;
    const Scalar z460 = z456 - z450;
    const Scalar z461 = n39_8603 + z457;
    const Scalar z462 = z352 * z448 - z452;
    const Scalar z463 = s_roll * z460 - c_roll * z458;
    const Scalar z464 = z362 * z448 - z455;
    const Scalar z465 = n25_over_7 * z352;
    const Scalar z466 = z352 * z465 - z461;
    const Scalar z467 = z362 * z465 - z459;
    const Scalar z468 = z7 * z376;
    const Scalar z469 = n25_over_7 * z362;
    const Scalar z470 = n0_12 * s_roll;
    const Scalar z471 = z470 + z464;
    const Scalar z472 = s_roll * z463;
    const Scalar z473 = n25_over_3 * z470;
    const Scalar z474 = z7 * z380;
    const Scalar z475 = c_pitch * z437 + s_pitch * z438;
    const Scalar z476 = z456 - z472;
    const Scalar z477 = s_pitch * z437 - c_pitch * z438;
    const Scalar z478 = z376 * z468 + z466;
    const Scalar z479 = n39_8603 - z476;
    const Scalar z480 = z380 * z468 - z467;
    const Scalar z481 = c_roll * z477;
    const Scalar z482 = s_roll * z475 - c_roll * z383;
    const Scalar z483 = z362 * z469 - z479;
    const Scalar z484 = s_roll * z383 + c_roll * z475;
    const Scalar z485 = z7 * z384;
    const Scalar z486 = z384 * z474;
    const Scalar z487 = z470 * z473 + z483;
    const Scalar z488 = z384 * z468 - z482;
    const Scalar z489 = n94 - z384 * z485;
    const Scalar z490 = s_roll * z477;
    const Scalar z491 = z384 * z449 + z481;
    const Scalar z492 = z380 * z474 + z487;
    const Scalar z493 = s_yaw * z475 + c_yaw * z490;
    const Scalar z494 = s_yaw * z490 - c_yaw * z475;
    const Scalar z495 = z369 * z449 + z446;
    const Scalar z496 = z376 * z449 - z462;
    const Scalar z497 = z380 * z449 + z471;
    const Scalar z498 = n1 / z495;
    const Scalar z499 = z386 * z449 - z493;
    const Scalar z500 = z387 * z449 + z494;
    const Scalar z501 = c_yaw * z484;
    const Scalar z502 = z386 * z468 - z501;
    const Scalar z503 = s_yaw * z484;
    const Scalar z504 = z387 * z468 + z503;
    const Scalar z505 = c_yaw * z477 + s_yaw * z482;
    const Scalar z506 = s_yaw * z477 - c_yaw * z482;
    const Scalar z507 = z386 * z474 - z505;
    const Scalar z508 = z387 * z474 + z506;
    const Scalar z509 = z7 * z386;
    const Scalar z510 = z496 * z498;
    const Scalar z511 = z497 * z498;
    const Scalar z512 = z491 * z498;
    const Scalar z513 = z386 * z485;
    const Scalar z514 = n94 - z386 * z509;
    const Scalar z515 = z478 - z496 * z510;
    const Scalar z516 = z480 - z497 * z510;
    const Scalar z517 = z492 - z497 * z511;
    const Scalar z518 = z486 - z491 * z511;
    const Scalar z519 = n1 / z515;
    const Scalar z520 = z488 - z491 * z510;
    const Scalar z521 = z489 + z491 * z512;
    const Scalar z522 = z513 - z499 * z512;
    const Scalar z523 = z507 - z499 * z511;
    const Scalar z524 = z502 - z499 * z510;
    const Scalar z525 = z508 - z500 * z511;
    const Scalar z526 = z504 - z500 * z510;
    const Scalar z527 = z499 * z498;
    const Scalar z528 = z514 + z499 * z527;
    const Scalar z529 = z7 * z387;
    const Scalar z530 = z387 * z509;
    const Scalar z531 = z530 - z500 * z527;
    const Scalar z532 = z387 * z485;
    const Scalar z533 = n94 - z387 * z529;
    const Scalar z534 = z532 - z500 * z512;
    const Scalar z535 = z516 * z519;
    const Scalar z536 = z520 * z519;
    const Scalar z537 = z524 * z519;
    const Scalar z538 = z500 * z498;
    const Scalar z539 = z533 + z500 * z538;
    const Scalar z540 = z517 - z516 * z535;
    const Scalar z541 = z518 - z520 * z535;
    const Scalar z542 = z521 + z520 * z536;
    const Scalar z543 = z522 - z524 * z536;
    const Scalar z544 = n1 / z540;
    const Scalar z545 = z523 - z524 * z535;
    const Scalar z546 = z528 + z524 * z537;
    const Scalar z547 = z531 - z526 * z537;
    const Scalar z548 = z534 - z526 * z536;
    const Scalar z549 = z525 - z526 * z535;
    const Scalar z550 = z526 * z519;
    const Scalar z551 = z539 + z526 * z550;
    const Scalar z552 = z189 * z535;
    const Scalar z553 = z145 + z172 * z449;
    const Scalar z554 = z133 + z172 * z468 - z510 * z553;
    const Scalar z555 = z81 * z535;
    const Scalar z556 = z549 * z544;
    const Scalar z557 = z188 * z535;
    const Scalar z558 = z545 * z544;
    const Scalar z559 = z541 * z544;
    const Scalar z560 = z172 * z474 - z511 * z553 - z535 * z554;
    const Scalar z561 = z542 + z541 * z559;
    const Scalar z562 = z543 - z545 * z559;
    const Scalar z563 = z546 + z545 * z558;
    const Scalar z564 = z547 - z549 * z558;
    const Scalar z565 = n1 / z561;
    const Scalar z566 = z548 - z549 * z559;
    const Scalar z567 = z551 + z549 * z556;
    const Scalar z568 = z188 * z536 - z559 * z557;
    const Scalar z569 = z189 * z536 - z559 * z552;
    const Scalar z570 = n1 + z172 * z485 - z512 * z553 - z536 * z554 - z559 * z560;
    const Scalar z571 = n1 + z81 * z536 - z559 * z555;
    const Scalar z572 = z566 * z565;
    const Scalar z573 = z562 * z565;
    const Scalar z574 = z567 - z566 * z572;
    const Scalar z575 = z564 + z566 * z573;
    const Scalar z576 = z187 + z222 * z449 - z241 * z448;
    const Scalar z577 = z563 - z562 * z573;
    const Scalar z578 = z186 + z222 * z468 + z241 * z465 - z510 * z576;
    const Scalar z579 = n1 / z577;
    const Scalar z580 = z184 + z222 * z474 - z241 * z469 - z511 * z576 - z535 * z578;
    const Scalar z581 = n1 - z188 * z537 + z558 * z557 - z573 * z568;
    const Scalar z582 = z189 * z537 - z558 * z552 + z573 * z569;
    const Scalar z583 = z172 * z509 - z527 * z553 - z537 * z554 - z558 * z560 + z573 * z570;
    const Scalar z584 = z575 * z579;
    const Scalar z585 = z222 * z485 - z512 * z576 - z536 * z578 - z559 * z580;
    const Scalar z586 = z574 - z575 * z584;
    const Scalar z587 = n1 / z586;
    const Scalar z588 = z222 * z509 - z527 * z576 - z537 * z578 - z558 * z580 + z573 * z585;
    const Scalar z589 = n1 - z222 * z529 + z538 * z576 + z550 * z578 + z556 * z580 - z572 * z585 - z584 * z588;
    const Scalar z590 = z188 * z550 - z556 * z557 + z572 * z568 - z584 * z581;
    const Scalar z591 = z587 * z589;
    const Scalar z592 = z587 * z590;
    const Scalar z593 = n1 + z189 * z550 - z556 * z552 + z572 * z569 + z584 * z582;
    const Scalar z594 = z579 * z588 - z584 * z591;
    const Scalar z595 = z579 * z581 - z584 * z592;
    const Scalar z596 = z565 * z568 + z572 * z592 - z573 * z595;
    const Scalar z597 = z587 * z593;
    const Scalar z598 = z579 * z582 + z584 * z597;
    const Scalar z599 = z544 * z557 + z556 * z592 - z558 * z595 + z559 * z596;
    const Scalar z600 = z565 * z569 + z572 * z597 + z573 * z598;
    const Scalar z601 = z188 * z519 - z550 * z592 + z537 * z595 - z536 * z596 + z535 * z599;
    const Scalar z602 = z544 * z552 + z556 * z597 + z558 * z598 + z559 * z600;
    const Scalar z603 = z538 * z592 - z527 * z595 + z512 * z596 - z511 * z599 + z510 * z601;
    const Scalar z604 = z529 * z592 - z509 * z595 + z485 * z596 - z474 * z599 + z468 * z601 - z449 * z603;
    const Scalar z605 = n25_over_3 * z197 - z603 - z473 * z599;
    const Scalar z606 = z469 * z599 + z465 * z601 + z448 * z603;
    const Scalar z607 = z172 * z529 - z538 * z553 - z550 * z554 - z556 * z560 + z572 * z570 + z584 * z583;
    const Scalar z608 = z587 * z607;
    const Scalar z609 = z189 * z519 - z550 * z597 - z537 * z598 - z536 * z600 + z535 * z602;
    const Scalar z610 = z579 * z583 + z584 * z608;
    const Scalar z611 = z538 * z597 + z527 * z598 + z512 * z600 - z511 * z602 + z510 * z609;
    const Scalar z612 = z565 * z570 + z572 * z608 + z573 * z610;
    const Scalar z613 = z544 * z560 + z556 * z608 + z558 * z610 + z559 * z612;
    const Scalar z614 = z529 * z597 + z509 * z598 + z485 * z600 - z474 * z602 + z468 * z609 - z449 * z611;
    const Scalar z615 = z519 * z554 + z550 * z608 + z537 * z610 + z536 * z612 - z535 * z613;
    const Scalar z616 = z498 * z553 + z538 * z608 + z527 * z610 + z512 * z612 - z511 * z613 - z510 * z615;
    const Scalar z617 = z81 * z537 - z558 * z555 + z573 * z571;
    const Scalar z618 = z565 * z585 - z572 * z591 + z573 * z594;
    const Scalar z619 = n25_over_3 * z199 - z611 - z473 * z602;
    const Scalar z620 = z469 * z602 + z465 * z609 + z448 * z611;
    const Scalar z621 = z81 * z550 - z556 * z555 + z572 * z571 + z584 * z617;
    const Scalar z622 = z544 * z580 - z556 * z591 + z558 * z594 + z559 * z618;
    const Scalar z623 = z587 * z621;
    const Scalar z624 = z519 * z578 - z550 * z591 + z537 * z594 + z536 * z618 - z535 * z622;
    const Scalar z625 = z579 * z617 + z584 * z623;
    const Scalar z626 = z498 * z576 - z538 * z591 + z527 * z594 + z512 * z618 - z511 * z622 - z510 * z624;
    const Scalar z627 = z565 * z571 + z572 * z623 + z573 * z625;
    const Scalar z628 = z544 * z555 + z556 * z623 + z558 * z625 + z559 * z627;
    const Scalar z629 = z7 * z222 - z529 * z591 + z509 * z594 + z485 * z618 - z474 * z622 - z468 * z624 - z449 * z626;
    const Scalar z630 = z7 * z172 + z529 * z608 + z509 * z610 + z485 * z612 - z474 * z613 - z468 * z615 - z449 * z616;
    const Scalar z631 = z473 * z613 + z616;
    const Scalar z632 = z469 * z613 - z465 * z615 + z448 * z616;
    const Scalar z633 = z81 * z519 - z550 * z623 - z537 * z625 - z536 * z627 + z535 * z628;
    const Scalar z634 = n25_over_7 * z241 + z469 * z622 - z465 * z624 + z448 * z626;
    const Scalar z635 = z538 * z623 + z527 * z625 + z512 * z627 - z511 * z628 + z510 * z633;
    const Scalar z636 = z183 + z239 * z449 - z240 * z448;
    const Scalar z637 = z529 * z623 + z509 * z625 + z485 * z627 - z474 * z628 + z468 * z633 - z449 * z635;
    const Scalar z638 = z182 + z239 * z468 + z240 * z465 - z510 * z636;
    const Scalar z639 = z473 * z628 + z635;
    const Scalar z640 = z178 + z239 * z474 - z240 * z469 - z511 * z636 - z535 * z638;
    const Scalar z641 = z469 * z628 + z465 * z633 + z448 * z635;
    const Scalar z642 = z239 * z485 - z512 * z636 - z536 * z638 - z559 * z640;
    const Scalar z643 = n1 + z239 * z509 - z527 * z636 - z537 * z638 - z558 * z640 + z573 * z642;
    const Scalar z644 = z239 * z529 - z538 * z636 - z550 * z638 - z556 * z640 + z572 * z642 + z584 * z643;
    const Scalar z645 = z587 * z644;
    const Scalar z646 = z178 * z622 - z594 + z182 * z624 + z183 * z626 - z239 * z629 - z240 * z634;
    const Scalar z647 = z579 * z643 + z584 * z645;
    const Scalar z648 = z565 * z642 + z572 * z645 + z573 * z647;
    const Scalar z649 = z184 * z622 - z591 + z186 * z624 + z187 * z626 - z222 * z629 - z241 * z634;
    const Scalar z650 = z544 * z640 + z556 * z645 + z558 * z647 + z559 * z648;
    const Scalar z651 = z519 * z638 + z550 * z645 + z537 * z647 + z536 * z648 - z535 * z650;
    const Scalar z652 = z498 * z636 + z538 * z645 + z527 * z647 + z512 * z648 - z511 * z650 - z510 * z651;
    const Scalar z653 = z7 * z239 + z529 * z645 + z509 * z647 + z485 * z648 - z474 * z650 - z468 * z651 - z449 * z652;
    const Scalar z654 = n25_over_7 * z240 + z469 * z650 - z465 * z651 + z448 * z652;
    const Scalar z655 = z178 * z650 - z647 + z182 * z651 + z183 * z652 - z239 * z653 - z240 * z654;
    const Scalar z656 = n1 / z655;
    const Scalar z657 = z592 + z184 * z599 - z186 * z601 + z187 * z603 - z222 * z604 - z241 * z606;
    const Scalar z658 = z595 + z178 * z599 - z182 * z601 + z183 * z603 - z239 * z604 - z240 * z606;
    const Scalar z659 = z595 + z166 * z599 - z188 * z601 + z197 * (z603 + z605);
    const Scalar z660 = z646 * z656;
    const Scalar z661 = z658 * z656;
    const Scalar z662 = z166 * z602 - z598 - z188 * z609 + z197 * (z611 + z619);
    const Scalar z663 = z649 - z646 * z660;
    const Scalar z664 = z657 - z658 * z660;
    const Scalar z665 = n1 / z663;
    const Scalar z666 = z659 + z658 * z661;
    const Scalar z667 = z597 + z184 * z602 - z186 * z609 + z187 * z611 - z222 * z614 - z241 * z620;
    const Scalar z668 = z178 * z602 - z598 - z182 * z609 + z183 * z611 - z239 * z614 - z240 * z620;
    const Scalar z669 = z662 + z668 * z661;
    const Scalar z670 = z667 - z668 * z660;
    const Scalar z671 = z597 + z167 * z602 - z189 * z609 + z199 * (z611 + z619);
    const Scalar z672 = z668 * z656;
    const Scalar z673 = z671 + z668 * z672;
    const Scalar z674 = z608 + z167 * z613 + z189 * z615 + z199 * (z616 - z631);
    const Scalar z675 = z166 * z613 - z610 + z188 * z615 + z197 * (z616 - z631);
    const Scalar z676 = z608 + z184 * z613 + z186 * z615 + z187 * z616 - z222 * z630 - z241 * z632;
    const Scalar z677 = z178 * z613 - z610 + z182 * z615 + z183 * z616 - z239 * z630 - z240 * z632;
    const Scalar z678 = z674 + z677 * z672;
    const Scalar z679 = z675 + z677 * z661;
    const Scalar z680 = z676 - z677 * z660;
    const Scalar z681 = z133 * z615 - z612 + z145 * z616 - z172 * z630;
    const Scalar z682 = z677 * z656;
    const Scalar z683 = z681 - z677 * z682;
    const Scalar z684 = z627 + z133 * z633 - z145 * z635 + z172 * z637;
    const Scalar z685 = z623 + z167 * z628 - z189 * z633 + z199 * (z635 - z639);
    const Scalar z686 = z166 * z628 - z625 - z188 * z633 + z197 * (z635 - z639);
    const Scalar z687 = z623 + z184 * z628 - z186 * z633 + z187 * z635 - z222 * z637 - z241 * z641;
    const Scalar z688 = z178 * z628 - z625 - z182 * z633 + z183 * z635 - z239 * z637 - z240 * z641;
    const Scalar z689 = z684 + z688 * z682;
    const Scalar z690 = z685 + z688 * z672;
    const Scalar z691 = z686 + z688 * z661;
    const Scalar z692 = z687 - z688 * z660;
    const Scalar z693 = z81 * z633 - z627;
    const Scalar z694 = z688 * z656;
    const Scalar z695 = z693 - z688 * z694;
    const Scalar z696 = z473 * z622 + z626;
    const Scalar z697 = z664 * z665;
    const Scalar z698 = z666 + z664 * z697;
    const Scalar z699 = z669 + z670 * z697;
    const Scalar z700 = z679 + z680 * z697;
    const Scalar z701 = z691 + z692 * z697;
    const Scalar z702 = n1 / z698;
    const Scalar z703 = z670 * z665;
    const Scalar z704 = z673 + z670 * z703;
    const Scalar z705 = z678 + z680 * z703;
    const Scalar z706 = z690 + z692 * z703;
    const Scalar z707 = z680 * z665;
    const Scalar z708 = z683 - z680 * z707;
    const Scalar z709 = z689 + z692 * z707;
    const Scalar z710 = z692 * z665;
    const Scalar z711 = z695 - z692 * z710;
    const Scalar z712 = z473 * z650 + z652;
    const Scalar z713 = z693 + z681 - z671 - z659 + z649 + z655;
    const Scalar z714 = n4096 * z713;
    const Scalar z715 = z377 * z448 - z388 - z406 * z449 + z405;
    const Scalar z716 = z377 * z465 + z406 * z468 + z510 * z715 - z429;
    const Scalar z717 = z699 * z702;
    const Scalar z718 = z704 - z699 * z717;
    const Scalar z719 = z705 - z700 * z717;
    const Scalar z720 = z706 - z701 * z717;
    const Scalar z721 = z700 * z702;
    const Scalar z722 = z708 + z700 * z721;
    const Scalar z723 = z377 * z469 - z388 * z473 - z406 * z474 - z511 * z715 + z535 * z716 + z439;
    const Scalar z724 = n1 / z718;
    const Scalar z725 = z709 - z701 * z721;
    const Scalar z726 = z426 - z406 * z485 - z512 * z715 + z536 * z716 - z559 * z723;
    const Scalar z727 = z442 - z406 * z509 - z527 * z715 + z537 * z716 - z558 * z723 + z573 * z726;
    const Scalar z728 = z441 + z406 * z529 + z538 * z715 - z550 * z716 + z556 * z723 - z572 * z726 - z584 * z727;
    const Scalar z729 = z587 * z728;
    const Scalar z730 = z719 * z724;
    const Scalar z731 = z722 + z719 * z730;
    const Scalar z732 = z725 - z720 * z730;
    const Scalar z733 = z579 * z727 - z584 * z729;
    const Scalar z734 = z701 * z702;
    const Scalar z735 = z711 + z701 * z734;
    const Scalar z736 = n1 / z731;
    const Scalar z737 = z720 * z724;
    const Scalar z738 = z565 * z726 - z572 * z729 + z573 * z733;
    const Scalar z739 = z735 + z720 * z737;
    const Scalar z740 = z544 * z723 - z556 * z729 + z558 * z733 + z559 * z738;
    const Scalar z741 = z519 * z716 + z550 * z729 - z537 * z733 - z536 * z738 + z535 * z740;
    const Scalar z742 = z732 * z736;
    const Scalar z743 = z498 * z715 - z538 * z729 + z527 * z733 + z512 * z738 - z511 * z740 + z510 * z741;
    const Scalar z744 = z7 * z406 + z529 * z729 - z509 * z733 - z485 * z738 + z474 * z740 - z468 * z741 + z449 * z743;
    const Scalar z745 = n25_over_7 * z377 - z469 * z740 - z465 * z741 - z448 * z743;
    const Scalar z746 = z305 - z729 + z184 * z740 - z186 * z741 + z187 * z743 + z222 * z744 + z241 * z745;
    const Scalar z747 = z304 - z733 + z178 * z740 - z182 * z741 + z183 * z743 + z239 * z744 + z240 * z745;
    const Scalar z748 = z236 + z738 + z133 * z741 - z145 * z743 - z172 * z744;
    const Scalar z749 = z743 + n25_over_3 * z388 + z473 * z740;
    const Scalar z750 = z229 - z729 + z167 * z740 - z189 * z741 + z199 * (z743 - z749);
    const Scalar z751 = z235 - z733 + z166 * z740 - z188 * z741 + z197 * (z743 - z749);
    const Scalar z752 = z100 - z738 + z81 * z741;
    const Scalar z753 = z739 - z732 * z742;
    const Scalar z754 = z660 * z747 - z746;
    const Scalar z755 = z751 + z661 * z747 - z697 * z754;
    const Scalar z756 = n1 / z753;
    const Scalar z757 = z750 + z672 * z747 - z703 * z754 - z717 * z755;
    const Scalar z758 = z748 + z682 * z747 - z707 * z754 - z721 * z755 - z730 * z757;
    const Scalar z759 = z694 * z747 - z752 - z710 * z754 - z734 * z755 - z737 * z757 + z742 * z758;
    const Scalar z760 = z756 * z759;
    const Scalar z761 = z736 * z758 + z742 * z760;
    const Scalar z762 = z724 * z757 + z737 * z760 + z730 * z761;
    const Scalar z763 = z702 * z755 + z734 * z760 + z721 * z761 - z717 * z762;
    const Scalar z764 = z665 * z754 - z710 * z760 - z707 * z761 + z703 * z762 + z697 * z763;
    const Scalar z765 = z656 * z747 + z694 * z760 + z682 * z761 - z672 * z762 - z661 * z763 + z660 * z764;
    const Scalar z766 = z623 * z760 - z729 + z608 * z761 - z597 * z762 - z592 * z763 - z591 * z764 - z645 * z765;
    const Scalar z767 = z733 + z625 * z760 + z610 * z761 - z598 * z762 + z595 * z763 + z594 * z764 - z647 * z765;
    const Scalar z768 = z738 + z627 * z760 + z612 * z761 - z600 * z762 - z596 * z763 + z618 * z764 - z648 * z765;
    const Scalar z769 = z740 + z628 * z760 + z613 * z761 - z602 * z762 - z599 * z763 + z622 * z764 - z650 * z765;
    const Scalar z770 = z741 + z633 * z760 - z615 * z761 - z609 * z762 - z601 * z763 - z624 * z764 + z651 * z765;
    const Scalar z771 = z743 + z635 * z760 + z616 * z761 - z611 * z762 - z603 * z763 + z626 * z764 - z652 * z765;
    const Scalar z772 = z637 * z760 - z744 + z630 * z761 - z614 * z762 - z604 * z763 + z629 * z764 - z653 * z765;
    const Scalar z773 = z749 + z639 * z760 + z631 * z761 + z619 * z762 + z605 * z763 + z696 * z764 - z712 * z765;
    const Scalar z774 = z641 * z760 - z745 + z632 * z761 - z620 * z762 - z606 * z763 + z634 * z764 - z654 * z765;
    accelerations.x = z766;
    accelerations.y = z767;
    accelerations.z = z768;
    accelerations.yaw = z769;
    accelerations.roll = z770;
    accelerations.pitch = z771;
    accelerations.steer = -z772;
    accelerations.rear = -z773;
    accelerations.front = -z774;
    multipliers.lambda_rear_touches = -z760;
    multipliers.lambda_front_touches = -z761;
    multipliers.lambda_rear_rolls_x = -z762;
    multipliers.lambda_rear_rolls_y = -z763;
    multipliers.lambda_front_rolls_x = -z764;
    multipliers.lambda_front_rolls_y = z765;
    if (!(traits::regular(z586, n94) && traits::regular(z577, n94) && traits::regular(z561, n94)
        && traits::regular(-z540, z479) && traits::regular(-z515, z461) && traits::regular(-z495, z447)
        && traits::regular(z6, z6) && traits::regular(-z753, -z714) && traits::regular(-z731, -z714)
        && traits::regular(z718, -z714) && traits::regular(z698, -z714) && traits::regular(-z663, -z714)
        && traits::regular(-z655, -z714))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.z * accelerations.yaw
        * accelerations.roll * accelerations.pitch * accelerations.steer * accelerations.rear * accelerations.front
        * multipliers.lambda_rear_touches * multipliers.lambda_front_touches * multipliers.lambda_rear_rolls_x
        * multipliers.lambda_rear_rolls_y * multipliers.lambda_front_rolls_x * multipliers.lambda_front_rolls_y;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n85 = traits::constant(85.0, 85.0f, "85/1");
    const Scalar n39_8 = traits::constant(39.8, 39.8f, "199/5");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n10_45 = traits::constant(10.45, 10.45f, "209/20");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar k16 = traits::constant(2.01892, 2.01892f, "50473/25000");
    const Scalar k17 = traits::constant(0.56756, 0.56756f, "14189/25000");
    const Scalar n2_18 = traits::constant(2.18, 2.18f, "109/50");
    const Scalar k19 = traits::constant(0.16708, 0.16708f, "4177/25000");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar k21 = traits::constant(0.03015, 0.03015f, "603/20000");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar k23 = traits::constant(0.07025, 0.07025f, "281/4000");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n39_24 = traits::constant(39.24, 39.24f, "981/25");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z4 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z5 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z6 = v_yaw * c_roll;
    const Scalar z7 = v_yaw * s_roll;
    const Scalar z8 = z2 * s_steer;
    const Scalar z9 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z10 = -z3 * (n1 - c_steer);
    const Scalar z11 = z1 * s_steer;
    const Scalar z12 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z13 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z14 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z15 = v_roll * c_pitch - s_pitch * z6;
    const Scalar z16 = v_roll * s_pitch + c_pitch * z6;
    const Scalar z17 = v_pitch + z7;  // angular velocity of frame, y
    const Scalar z18 = n0_8 * z8 - n2_8 * z11;
    const Scalar z19 = n0_08 * z8 - n0_35 * z11;
    const Scalar z20 = v_rear + z17;  // angular velocity of rear_wheel, y
    const Scalar z21 = v_z * s_roll - c_roll * z4;
    const Scalar z22 = v_z * c_roll + s_roll * z4;
    const Scalar z23 = s_rear * z16 - c_rear * z15;
    const Scalar z24 = s_rear * z15 + c_rear * z16;
    const Scalar z25 = z8 * z17 - z10 * z16 + z9 * z15;
    const Scalar z26 = c_steer * z17 - z8 * z15 + z11 * z16;
    const Scalar z27 = z11 * z17 + z10 * z15 - z12 * z16;
    const Scalar z28 = c_roll * z14;
    const Scalar z29 = c_roll * z13;
    const Scalar z30 = n0_8 * z9 - n2_8 * z10;
    const Scalar z31 = n0_8 * z10 - n2_8 * z12;
    const Scalar z32 = n0_08 * z9 - n0_35 * z10;
    const Scalar z33 = n0_08 * z10 - n0_35 * z12;
    const Scalar z34 = q_z - z29;
    const Scalar z35 = s_pitch * z22 - c_pitch * z5;
    const Scalar z36 = s_pitch * z5 + c_pitch * z22;
    const Scalar z37 = z21 - n0_3 * z15 + n1_1 * z16;
    const Scalar z38 = n51 * z15 + n25_5 * z16 + n85 * z21;
    const Scalar z39 = n39_8 * z15 + n17_7 * z16 + n51 * z21;
    const Scalar z40 = n17_7 * z15 + n10_45 * z16 + n25_5 * z21;
    const Scalar z41 = n0_3 + z33;
    const Scalar z42 = n1_1 - z32;
    const Scalar z43 = c_pitch * z31 + s_pitch * z30;
    const Scalar z44 = z36 - n1_1 * z17;
    const Scalar z45 = z1 * v_steer + z25;  // angular velocity of fork, x
    const Scalar z46 = z35 - n0_3 * z17;
    const Scalar z47 = z2 * v_steer - z27;  // angular velocity of fork, z
    const Scalar z48 = s_pitch * z42 - c_pitch * z41;
    const Scalar z49 = s_rear * z36 + c_rear * z35;
    const Scalar z50 = z10 * z44 - z8 * z37 + z9 * z46;
    const Scalar z51 = z12 * z44 - z11 * z37 + z10 * z46;
    const Scalar z52 = c_steer * z37 + z8 * z46 + z11 * z44;
    const Scalar z53 = n0_35 * z26 + z50;
    const Scalar z54 = n0_08 * z26 + z51;
    const Scalar z55 = s_roll * z19 + c_roll * z48;
    const Scalar z56 = s_rear * z35 - c_rear * z36;
    const Scalar z57 = z52 + n0_35 * z45 - n0_08 * z47;
    const Scalar z58 = s_front * z47 - c_front * z45;
    const Scalar z59 = s_front * z45 + c_front * z47;
    const Scalar z60 = s_front * z54 + c_front * z53;
    const Scalar z61 = s_front * z53 - c_front * z54;
    const Scalar z62 = v_front + z26;  // angular velocity of front_wheel, y
    const Scalar z63 = n51 * z17 + n85 * z35;
    const Scalar z64 = n85 * z36 - n25_5 * z17;
    const Scalar z65 = n49_25 * z17 - n25_5 * z36 + n51 * z35;
    const Scalar z66 = n2_8 * z26 + n4 * z50;
    const Scalar z67 = n2_8 * z45 - n0_8 * z47 + n4 * z52;
    const Scalar z68 = n0_8 * z26 + n4 * z51;
    const Scalar z69 = k16 * z45 - k17 * z47 + n2_8 * z52;
    const Scalar z70 = n2_18 * z26 + n2_8 * z50 + n0_8 * z51;
    const Scalar z71 = k17 * z45 - k19 * z47 + n0_8 * z52;
    const Scalar z72 = s_roll * z18 - c_roll * z43;
    const Scalar z73 = q_z - z55;
    result.kinetic = z21 * z21 + n0_06 * z20 * z20 + k21 * (z23 * z23 + z24 * z24) + z49 * z49 + n0_14 * z62 * z62 + z56
        * z56 + k23 * (z58 * z58 + z59 * z59) + n1_5 * (z57 * z57 + z60 * z60 + z61 * z61) + n0_5 * (z21 * z38 + z15
        * z39 + z16 * z40 + z35 * z63 + z36 * z64 + z17 * z65 + z26 * z70 + z50 * z66 + z52 * z67 + z51 * z68 + z45
        * z69 - z47 * z71);
    result.force_function = n853_47 * q_z + n39_24 * z34 - n9_81 * (z28 + z72) + n29_43 * z73;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n85 = traits::constant(85.0, 85.0f, "85/1");
    const Scalar n39_8 = traits::constant(39.8, 39.8f, "199/5");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n10_45 = traits::constant(10.45, 10.45f, "209/20");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar k16 = traits::constant(2.01892, 2.01892f, "50473/25000");
    const Scalar k17 = traits::constant(0.56756, 0.56756f, "14189/25000");
    const Scalar n2_18 = traits::constant(2.18, 2.18f, "109/50");
    const Scalar k19 = traits::constant(0.16708, 0.16708f, "4177/25000");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n39_24 = traits::constant(39.24, 39.24f, "981/25");
    const Scalar k23 = traits::constant(0.03015, 0.03015f, "603/20000");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar k27 = traits::constant(0.07025, 0.07025f, "281/4000");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z4 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z5 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z6 = v_yaw * c_roll;
    const Scalar z7 = v_yaw * s_roll;
    const Scalar z8 = z2 * s_steer;
    const Scalar z9 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z10 = -z3 * (n1 - c_steer);
    const Scalar z11 = z1 * s_steer;
    const Scalar z12 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z13 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z14 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z15 = v_roll * c_pitch - s_pitch * z6;
    const Scalar z16 = v_roll * s_pitch + c_pitch * z6;
    const Scalar z17 = v_pitch + z7;  // angular velocity of frame, y
    const Scalar z18 = n0_8 * z8 - n2_8 * z11;
    const Scalar z19 = n0_08 * z8 - n0_35 * z11;
    const Scalar z20 = v_rear + z17;  // angular velocity of rear_wheel, y
    const Scalar z21 = v_z * s_roll - c_roll * z4;
    const Scalar z22 = v_z * c_roll + s_roll * z4;
    const Scalar z23 = s_rear * z16 - c_rear * z15;
    const Scalar z24 = s_rear * z15 + c_rear * z16;
    const Scalar z25 = z8 * z17 - z10 * z16 + z9 * z15;
    const Scalar z26 = c_steer * z17 - z8 * z15 + z11 * z16;
    const Scalar z27 = z11 * z17 + z10 * z15 - z12 * z16;
    const Scalar z28 = c_roll * z14;
    const Scalar z29 = c_roll * z13;
    const Scalar z30 = n0_8 * z9 - n2_8 * z10;
    const Scalar z31 = n0_8 * z10 - n2_8 * z12;
    const Scalar z32 = n0_08 * z9 - n0_35 * z10;
    const Scalar z33 = n0_08 * z10 - n0_35 * z12;
    const Scalar z34 = q_z - z29;
    const Scalar z35 = s_pitch * z22 - c_pitch * z5;
    const Scalar z36 = s_pitch * z5 + c_pitch * z22;
    const Scalar z37 = z21 - n0_3 * z15 + n1_1 * z16;
    const Scalar z38 = n51 * z15 + n25_5 * z16 + n85 * z21;
    const Scalar z39 = n39_8 * z15 + n17_7 * z16 + n51 * z21;
    const Scalar z40 = n17_7 * z15 + n10_45 * z16 + n25_5 * z21;
    const Scalar z41 = n0_3 + z33;
    const Scalar z42 = n1_1 - z32;
    const Scalar z43 = c_pitch * z31 + s_pitch * z30;
    const Scalar z44 = z36 - n1_1 * z17;
    const Scalar z45 = z1 * v_steer + z25;  // angular velocity of fork, x
    const Scalar z46 = z35 - n0_3 * z17;
    const Scalar z47 = z2 * v_steer - z27;  // angular velocity of fork, z
    const Scalar z48 = s_pitch * z42 - c_pitch * z41;
    const Scalar z49 = s_rear * z36 + c_rear * z35;
    const Scalar z50 = z10 * z44 - z8 * z37 + z9 * z46;
    const Scalar z51 = z12 * z44 - z11 * z37 + z10 * z46;
    const Scalar z52 = c_steer * z37 + z8 * z46 + z11 * z44;
    const Scalar z53 = n0_35 * z26 + z50;
    const Scalar z54 = n0_08 * z26 + z51;
    const Scalar z55 = s_roll * z19 + c_roll * z48;
    const Scalar z56 = s_rear * z35 - c_rear * z36;
    const Scalar z57 = z52 + n0_35 * z45 - n0_08 * z47;
    const Scalar z58 = s_front * z47 - c_front * z45;
    const Scalar z59 = s_front * z45 + c_front * z47;
    const Scalar z60 = s_front * z54 + c_front * z53;
    const Scalar z61 = s_front * z53 - c_front * z54;
    const Scalar z62 = v_front + z26;  // angular velocity of front_wheel, y
    const Scalar z63 = n51 * z17 + n85 * z35;
    const Scalar z64 = n85 * z36 - n25_5 * z17;
    const Scalar z65 = n49_25 * z17 - n25_5 * z36 + n51 * z35;
    const Scalar z66 = n2_8 * z26 + n4 * z50;
    const Scalar z67 = n2_8 * z45 - n0_8 * z47 + n4 * z52;
    const Scalar z68 = n0_8 * z26 + n4 * z51;
    const Scalar z69 = k16 * z45 - k17 * z47 + n2_8 * z52;
    const Scalar z70 = n2_18 * z26 + n2_8 * z50 + n0_8 * z51;
    const Scalar z71 = k17 * z45 - k19 * z47 + n0_8 * z52;
    const Scalar z72 = s_roll * z18 - c_roll * z43;
    const Scalar z73 = q_z - z55;
    result.energy = -n853_47 * q_z + z21 * z21 + n0_06 * z20 * z20 - n39_24 * z34 + k23 * (z23 * z23 + z24 * z24) + z49
        * z49 + n0_14 * z62 * z62 + z56 * z56 + n9_81 * (z28 + z72) - n29_43 * z73 + k27 * (z58 * z58 + z59 * z59)
        + n1_5 * (z57 * z57 + z60 * z60 + z61 * z61) + n0_5 * (z21 * z38 + z15 * z39 + z16 * z40 + z35 * z63 + z36 * z64
        + z17 * z65 + z26 * z70 + z50 * z66 + z52 * z67 + z51 * z68 + z45 * z69 - z47 * z71);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z1 * z1;
    });
    const Scalar z4 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z5 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z2 * z2;
    });
    const Scalar z6 = z2 * s_steer;
    const Scalar z7 = z1 * s_steer;
    const Scalar z8 = v_roll * s_roll;
    const Scalar z9 = v_yaw * c_yaw;
    const Scalar z10 = v_roll * c_roll;
    const Scalar z11 = v_yaw * s_yaw;
    const Scalar z12 = s_yaw * c_roll;
    const Scalar z13 = n1 - s_roll * s_roll;
    const Scalar z14 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z15 = c_yaw * c_roll;
    const Scalar z16 = -z4 * (n1 - c_steer);
    const Scalar z17 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z18 = n2 * s_roll;
    const Scalar z19 = s_yaw * s_roll;
    const Scalar z20 = c_yaw * s_roll;
    const Scalar z21 = s_roll * z12;
    const Scalar z22 = s_roll * z15;
    const Scalar z23 = s_yaw * z8 - c_roll * z9;
    const Scalar z24 = c_yaw * z8 + c_roll * z11;
    const Scalar z25 = z10 * z18;
    const Scalar z26 = s_roll * z19 - c_roll * z12;
    const Scalar z27 = s_roll * z20 - c_roll * z15;
    const Scalar z28 = c_roll * z18;
    const Scalar z29 = v_roll * z10;
    const Scalar z30 = v_yaw * z11;
    const Scalar z31 = n2 * z8;
    const Scalar z32 = v_roll * z8;
    const Scalar z33 = n2 * z10;
    const Scalar z34 = v_yaw * z9;
    const Scalar z35 = n0_08 * z6 - n0_35 * z7;
    const Scalar z36 = s_pitch * z7 - c_pitch * z6;
    const Scalar z37 = s_pitch * z6 + c_pitch * z7;
    const Scalar z38 = z13 * z13 + z21 * z21 + z22 * z22;
    const Scalar z39 = s_yaw * z29 + c_roll * z30 + z9 * z31;
    const Scalar z40 = c_yaw * z29 + c_roll * z34 - z11 * z31;
    const Scalar z41 = n2 * (s_roll * z32 - z10 * z10);
    const Scalar z42 = n0_08 * z14 - n0_35 * z16;
    const Scalar z43 = n0_08 * z16 - n0_35 * z17;
    const Scalar z44 = s_roll * z23 - z12 * z10;
    const Scalar z45 = s_roll * z24 - z15 * z10;
    const Scalar z46 = n2 * (z13 * z28 + z21 * z26 + z22 * z27);
    const Scalar z47 = s_roll * z37 - c_roll * c_steer;
    const Scalar z48 = s_roll * c_steer + c_roll * z37;
    const Scalar z49 = n0_3 + z43;
    const Scalar z50 = n1_1 - z42;
    const Scalar z51 = traits::sqrt(z38);
    const Scalar z52 = n2 * (z13 * z25 + z21 * z44 + z22 * z45);
    const Scalar z53 = z12 * z32 + z23 * z33 + s_roll * z39;
    const Scalar z54 = z15 * z32 + z24 * z33 + s_roll * z40;
    const Scalar z55 = c_yaw * z36 + s_yaw * z47;
    const Scalar z56 = n2 * (z21 * z53 + z22 * z54 - z13 * z41 - z44 * z44 - z45 * z45 - z25 * z25);
    const Scalar z57 = s_yaw * z36 - c_yaw * z47;
    const Scalar z58 = s_pitch * z50 - c_pitch * z49;
    const Scalar z59 = s_roll * z58 - c_roll * z35;
    const Scalar z60 = s_pitch * z49 + c_pitch * z50;
    const Scalar z61 = n0_5 * z46 / z51;
    const Scalar z62 = q_z + n0_3 * z51;
    const Scalar z63 = n0_5 * z52 / z51;
    const Scalar z64 = s_roll * z35 + c_roll * z58;
    const Scalar z65 = q_z - z64;
    const Scalar z66 = s_yaw * z59 - c_yaw * z60;
    const Scalar z67 = s_yaw * z60 + c_yaw * z59;
    const Scalar z68 = q_y + z67;
    const Scalar z69 = n0_3 / z51;
    const Scalar z70 = z48 * z55;
    const Scalar z71 = q_x - z66;
    const Scalar z72 = q_x + z21 * z69;
    const Scalar z73 = z48 * z57;
    const Scalar z74 = q_y - z22 * z69;
    const Scalar z75 = n1 - z48 * z48;
    const Scalar z76 = n0_3 * z61;
    const Scalar z77 = n0_5 * (z52 * z63 / (z51 * z51) + z56 / z51);
    const Scalar z78 = v_z - n0_3 * z63;
    const Scalar z79 = q_z + z13 * z69;
    const Scalar z80 = v_pitch * c_pitch;
    const Scalar z81 = v_pitch * s_pitch;
    const Scalar z82 = v_steer * c_steer;
    const Scalar z83 = v_steer * s_steer;
    const Scalar z84 = z2 * z82;
    const Scalar z85 = z1 * z82;
    const Scalar z86 = n2 * z48;
    const Scalar z87 = z4 * z83;
    const Scalar z88 = z75 * z75 + z70 * z70 + z73 * z73;
    const Scalar z89 = traits::sqrt(z88);
    const Scalar z90 = z6 * z80 - z7 * z81 + s_pitch * z84 + c_pitch * z85;
    const Scalar z91 = z6 * z81 + z7 * z80 + s_pitch * z85 - c_pitch * z84;
    const Scalar z92 = -z83 * (n1 - z3);
    const Scalar z93 = n0_35 * z87 + n0_08 * z92;
    const Scalar z94 = n0_3 * z77;
    const Scalar z95 = c_roll * z83 + c_steer * z8 + z10 * z37 + s_roll * z90;
    const Scalar z96 = z9 * z36 + z11 * z47 + s_yaw * z91 - c_yaw * z95;
    const Scalar z97 = s_roll * z83 - c_steer * z10 + z8 * z37 - c_roll * z90;
    const Scalar z98 = z65 + n0_35 * z89;
    const Scalar z99 = z9 * z47 - z11 * z36 + c_yaw * z91 + s_yaw * z95;
    const Scalar z100 = z97 * z86;
    const Scalar z101 = z48 * z96 - z57 * z97;
    const Scalar z102 = -z83 * (n1 - z5);
    const Scalar z103 = n0_08 * z87 + n0_35 * z102;
    const Scalar z104 = z48 * z99 - z55 * z97;
    const Scalar z105 = n0_08 * z84 - n0_35 * z85;
    const Scalar z106 = n2 * (z75 * z100 + z73 * z101 + z70 * z104);
    const Scalar z107 = s_pitch * z93 - c_pitch * z103 - z50 * z80 - z49 * z81;
    const Scalar z108 = z2 * c_steer;
    const Scalar z109 = z1 * c_steer;
    const Scalar z110 = s_roll * z36;
    const Scalar z111 = n0_5 * z106 / z89;
    const Scalar z112 = c_yaw * z48;
    const Scalar z113 = z48 * z112 + z47 * z57;
    const Scalar z114 = s_yaw * z110 - c_yaw * z37;
    const Scalar z115 = s_yaw * z37 + c_yaw * z110;
    const Scalar z116 = n0_35 / z89;
    const Scalar z117 = c_roll * z36;
    const Scalar z118 = z48 * z114 + z55 * z117;
    const Scalar z119 = z48 * z115 - z57 * z117;
    const Scalar z120 = z86 * z117;
    const Scalar z121 = z71 - z70 * z116;
    const Scalar z122 = z10 * z35 + s_roll * z105 - z8 * z58 - c_roll * z107;
    const Scalar z123 = n2 * (z70 * z118 - z73 * z119 - z75 * z120);
    const Scalar z124 = v_z - z122;
    const Scalar z125 = z124 + n0_35 * z111;
    const Scalar z126 = z65 + z75 * z116;
    const Scalar z127 = s_yaw * z48;
    const Scalar z128 = z47 * z55 - z48 * z127;
    const Scalar z129 = z47 * z86;
    const Scalar z130 = z68 - z73 * z116;
    const Scalar z131 = v_steer * z82;
    const Scalar z132 = v_pitch * z81;
    const Scalar z133 = n2 * (z73 * z113 - z75 * z129 + z70 * z128);
    const Scalar z134 = n0_5 * z123 / z89;
    const Scalar z135 = v_pitch * z80;
    const Scalar z136 = v_steer * z83;
    const Scalar z137 = z2 * z136;
    const Scalar z138 = z1 * z136;
    const Scalar z139 = n2 * z97;
    const Scalar z140 = s_pitch * z108 + c_pitch * z109;
    const Scalar z141 = z6 * z132 + z7 * z135 + s_pitch * z137 + c_pitch * z138 - n2 * (z84 * z80 - z85 * z81);
    const Scalar z142 = z7 * z132 - z6 * z135 + s_pitch * z138 - c_pitch * z137 - n2 * (z84 * z81 + z85 * z80);
    const Scalar z143 = n0_08 * z137 - n0_35 * z138;
    const Scalar z144 = n0_5 * z133 / z89;
    const Scalar z145 = z32 * z37 - c_roll * z131 - c_steer * z29 - n2 * (z10 * z90 - z8 * z83) + s_roll * z141;
    const Scalar z146 = s_roll * z131 + c_steer * z32 + z29 * z37 + n2 * (z10 * z83 + z8 * z90) + c_roll * z141;
    const Scalar z147 = z59 - n0_35 * z144;
    const Scalar z148 = z30 * z36 - z34 * z47 - n2 * (z9 * z91 + z11 * z95) + s_yaw * z142 - c_yaw * z145;
    const Scalar z149 = z34 * z36 + z30 * z47 - n2 * (z9 * z95 - z11 * z91) + c_yaw * z142 + s_yaw * z145;
    const Scalar z150 = z96 * z139 + z57 * z146 + z48 * z148;
    const Scalar z151 = z99 * z139 + z55 * z146 + z48 * z149;
    const Scalar z152 = n2 * (z48 * z146 - z97 * z97);
    const Scalar z153 = n2 * (z73 * z150 - z100 * z100 - z101 * z101 - z104 * z104 - z75 * z152 + z70 * z151);
    const Scalar z154 = s_pitch * z109 - c_pitch * z108;
    const Scalar z155 = n0_08 * z108 - n0_35 * z109;
    const Scalar z156 = c_roll * s_steer + s_roll * z140;
    const Scalar z157 = s_roll * s_steer - c_roll * z140;
    const Scalar z158 = z86 * z157;
    const Scalar z159 = c_yaw * z154 + s_yaw * z156;
    const Scalar z160 = s_yaw * z154 - c_yaw * z156;
    const Scalar z161 = z48 * z159 - z55 * z157;
    const Scalar z162 = z48 * z160 - z57 * z157;
    const Scalar z163 = z4 * z131;
    const Scalar z164 = -z131 * (n1 - z3);
    const Scalar z165 = n0_35 * z163 + n0_08 * z164;
    const Scalar z166 = n0_5 * (z106 * z111 / (z89 * z89) + z153 / z89);
    const Scalar z167 = n2 * (z75 * z158 + z70 * z161 + z73 * z162);
    const Scalar z168 = -z131 * (n1 - z5);
    const Scalar z169 = n0_08 * z163 + n0_35 * z168;
    const Scalar z170 = s_steer * z4;
    const Scalar z171 = s_steer * (n1 - z3);
    const Scalar z172 = n0_08 * z171 - n0_35 * z170;
    const Scalar z173 = s_pitch * z165 - z49 * z135 - c_pitch * z169 + z50 * z132 + n2 * (z80 * z93 + z81 * z103);
    const Scalar z174 = n0_5 * z167 / z89;
    const Scalar z175 = s_steer * (n1 - z5);
    const Scalar z176 = n0_08 * z170 - n0_35 * z175;
    const Scalar z177 = c_roll * z60;
    const Scalar z178 = z177 + n0_35 * z134;
    const Scalar z179 = n0_3 * z63 / (z51 * z51);
    const Scalar z180 = z32 * z35 + s_roll * z143 + z29 * z58 - n2 * (z10 * z105 + z8 * z107) + c_roll * z173;
    const Scalar z181 = z180 - n0_35 * z166;
    const Scalar z182 = v_z - z69 * z25 + z13 * z179;
    const Scalar z183 = v_y + z69 * z45 - z22 * z179;
    const Scalar z184 = v_x - z69 * z44 + z21 * z179;
    const Scalar z185 = c_pitch * z176 + s_pitch * z172;
    const Scalar z186 = s_roll * z155 + c_roll * z185;
    const Scalar z187 = q_x - z72;
    const Scalar z188 = q_y - z74;
    const Scalar z189 = q_z - z79;
    const Scalar z190 = v_z - z182;
    const Scalar z191 = v_y - z183;
    const Scalar z192 = z186 - n0_35 * z174;
    const Scalar z193 = c_roll * z105 - z8 * z35 - z10 * z58 + s_roll * z107;
    const Scalar z194 = s_pitch * z103 + c_pitch * z93 + z50 * z81 - z49 * z80;
    const Scalar z195 = n0_35 * z111 / (z89 * z89);
    const Scalar z196 = z75 * z195 - z124 - z116 * z100;
    const Scalar z197 = z71 - z121;
    const Scalar z198 = z68 - z130;
    const Scalar z199 = v_x - z184;
    const Scalar z200 = z65 - z126;
    const Scalar z201 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z202 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z203 = s_roll * z201;
    const Scalar z204 = s_pitch * z2 + c_pitch * z1;
    const Scalar z205 = s_pitch * z1 - c_pitch * z2;
    const Scalar z206 = s_yaw * z194 - z9 * z60 + z11 * z59 + c_yaw * z193;
    const Scalar z207 = v_y - z206;
    const Scalar z208 = s_yaw * z203 - c_yaw * z202;
    const Scalar z209 = q_x - z208;
    const Scalar z210 = s_roll * z205;
    const Scalar z211 = z207 - z116 * z101 + z73 * z195;
    const Scalar z212 = z121 - z209;
    const Scalar z213 = q_x - z121;
    const Scalar z214 = c_roll * z201;
    const Scalar z215 = q_z - z214;
    const Scalar z216 = s_yaw * z202 + c_yaw * z203;
    const Scalar z217 = q_y + z216;
    const Scalar z218 = q_z - z126;
    const Scalar z219 = z126 - z215;
    const Scalar z220 = q_y - z130;
    const Scalar z221 = c_roll * z205;
    const Scalar z222 = v_y - z211;
    const Scalar z223 = z130 - z217;
    const Scalar z224 = s_yaw * z218;
    const Scalar z225 = c_yaw * z218;
    const Scalar z226 = s_yaw * z210 - c_yaw * z204;
    const Scalar z227 = s_roll * z220 - z15 * z218;
    const Scalar z228 = s_roll * z213 + z12 * z218;
    const Scalar z229 = s_yaw * z204 + c_yaw * z210;
    const Scalar z230 = s_yaw * z189;
    const Scalar z231 = v_z + z196;
    const Scalar z232 = c_yaw * z189;
    const Scalar z233 = z9 * z218 + s_yaw * z231;
    const Scalar z234 = z9 * z189 + s_yaw * z190;
    const Scalar z235 = c_yaw * z190 - z11 * z189;
    const Scalar z236 = z221 * z223 + z229 * z219;
    const Scalar z237 = z221 * z212 - z226 * z219;
    const Scalar z238 = s_roll * z188 - z15 * z189;
    const Scalar z239 = v_x + v_yaw * z188 - v_roll * z230 + z238 * (v_pitch + v_rear);
    const Scalar z240 = z10 * z188 + z24 * z189 + s_roll * z191 - z15 * z190;
    const Scalar z241 = v_yaw * z191 - v_roll * z234 + z240 * (v_pitch + v_rear);
    const Scalar z242 = z10 * z220 + z24 * z218 + s_roll * z222 - z15 * z231;
    const Scalar z243 = z10 * z187 - z23 * z189 + s_roll * z199 + z12 * z190;
    const Scalar z244 = v_yaw * z199 - v_roll * z235 + z243 * (v_pitch + v_rear);
    const Scalar z245 = s_roll * z187 + z12 * z189;
    const Scalar z246 = v_y - v_yaw * z187 + v_roll * z232 - z245 * (v_pitch + v_rear);
    const Scalar z247 = s_yaw * z193 - c_yaw * z194 - z9 * z59 - z11 * z60;
    const Scalar z248 = v_x + z247;
    const Scalar z249 = z207 - z211;
    const Scalar z250 = z124 + z196;
    const Scalar z251 = z48 * z249 - z97 * z198 - z96 * z200 - z57 * z250;
    const Scalar z252 = z248 - z116 * z104 + z70 * z195;
    const Scalar z253 = z48 * z198 - z57 * z200;
    const Scalar z254 = v_x + v_yaw * z220 - v_roll * z224 + v_pitch * z227 + v_steer * z236 + v_front * z253;
    const Scalar z255 = z248 - z252;
    const Scalar z256 = z48 * z255 - z97 * z197 - z99 * z200 - z55 * z250;
    const Scalar z257 = z48 * z197 - z55 * z200;
    const Scalar z258 = v_y - v_yaw * z213 + v_roll * z225 - v_pitch * z228 - v_steer * z237 - v_front * z257;
    const Scalar z259 = n0_3 * z80 - n1_1 * z81;
    const Scalar z260 = z1 * z81 - z2 * z80;
    const Scalar z261 = z1 * z80 + z2 * z81;
    const Scalar z262 = n1_1 * z80 + n0_3 * z81;
    const Scalar z263 = z10 * z201 + s_roll * z262;
    const Scalar z264 = c_roll * z262 - z8 * z201;
    const Scalar z265 = c_roll * z261 - z8 * z205;
    const Scalar z266 = z10 * z205 + s_roll * z261;
    const Scalar z267 = z11 * z202 - c_yaw * z259 + z9 * z203 + s_yaw * z263;
    const Scalar z268 = z9 * z202 + s_yaw * z259 - z11 * z203 + c_yaw * z263;
    const Scalar z269 = v_x - z267;
    const Scalar z270 = z252 - z269;
    const Scalar z271 = v_x - z252;
    const Scalar z272 = z10 * z213 - z23 * z218 + s_roll * z271 + z12 * z231;
    const Scalar z273 = c_yaw * z231 - z11 * z218;
    const Scalar z274 = v_y + z268;
    const Scalar z275 = z211 - z274;
    const Scalar z276 = v_z - z264;
    const Scalar z277 = z196 + z276;
    const Scalar z278 = z11 * z204 + c_yaw * z260 + z9 * z210 + s_yaw * z266;
    const Scalar z279 = s_yaw * z260 - z9 * z204 + z11 * z210 - c_yaw * z266;
    const Scalar z280 = z212 * z265 - z219 * z278 + z221 * z270 + z226 * z277;
    const Scalar z281 = z223 * z265 - z219 * z279 + z221 * z275 - z229 * z277;
    const Scalar z282 = v_yaw * z271 + v_pitch * z272 + v_steer * z280 - v_roll * z273 + v_front * z256;
    const Scalar z283 = v_yaw * z222 - v_roll * z233 + v_pitch * z242 + v_steer * z281 + v_front * z251;
    result.value[0] = -z62;
    result.rate[0] = -z78;
    result.gamma[0] = z94;
    result.value[1] = -z98;
    result.rate[1] = -z125;
    result.gamma[1] = -z181;
    result.value[2] = n0;
    result.rate[2] = z239;
    result.gamma[2] = z241;
    result.value[3] = n0;
    result.rate[3] = -z246;
    result.gamma[3] = z244;
    result.value[4] = n0;
    result.rate[4] = z254;
    result.gamma[4] = z283;
    result.value[5] = n0;
    result.rate[5] = -z258;
    result.gamma[5] = z282;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n1;
    result.jacobian[3] = n0;
    result.jacobian[4] = n1;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = -n1;
    result.jacobian[10] = n0;
    result.jacobian[11] = -n1;
    result.jacobian[12] = -n1;
    result.jacobian[13] = -n1;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z188;
    result.jacobian[21] = z187;
    result.jacobian[22] = z220;
    result.jacobian[23] = z213;
    result.jacobian[24] = z76;
    result.jacobian[25] = -z147;
    result.jacobian[26] = -z230;
    result.jacobian[27] = -z232;
    result.jacobian[28] = -z224;
    result.jacobian[29] = -z225;
    result.jacobian[30] = n0;
    result.jacobian[31] = z178;
    result.jacobian[32] = z238;
    result.jacobian[33] = z245;
    result.jacobian[34] = z227;
    result.jacobian[35] = z228;
    result.jacobian[36] = n0;
    result.jacobian[37] = z192;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z236;
    result.jacobian[41] = z237;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z238;
    result.jacobian[45] = z245;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z253;
    result.jacobian[53] = z257;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, yaw, roll, steer, rear, front,
  /// w those of the rates of roll, steer, rear;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar k3 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k4 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k5 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k16 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k18 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar k20 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n78_6 = traits::constant(78.6, 78.6f, "393/5");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n79_7206 = traits::constant(79.7206, 79.7206f, "398603/5000");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n87 = traits::constant(87.0, 87.0f, "87/1");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar k40 = traits::constant(2.38342, 2.38342f, "119171/50000");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k42 = traits::constant(0.18328, 0.18328f, "2291/12500");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n39_3 = traits::constant(39.3, 39.3f, "393/10");
    const Scalar n9_95 = traits::constant(9.95, 9.95f, "199/20");
    const Scalar n0_5603 = traits::constant(0.5603, 0.5603f, "5603/10000");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n1_over_94 = traits::constant(0.010638297872340425, 0.010638298f, "1/94");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar a_z = accelerations.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar a_yaw = accelerations.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar a_roll = accelerations.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar a_pitch = accelerations.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar a_rear = accelerations.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar a_steer = accelerations.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar a_front = accelerations.front;
    const Scalar l_lambda_rear_rolls_x = multipliers.lambda_rear_rolls_x;
    const Scalar l_lambda_front_rolls_x = multipliers.lambda_front_rolls_x;
    const Scalar l_lambda_rear_rolls_y = multipliers.lambda_rear_rolls_y;
    const Scalar l_lambda_front_rolls_y = multipliers.lambda_front_rolls_y;
    const Scalar l_lambda_rear_touches = multipliers.lambda_rear_touches;
    const Scalar l_lambda_front_touches = multipliers.lambda_front_touches;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z1 - n1_04 * z2;
    });
    const Scalar z4 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z1 - k4 * z2;
    });
    const Scalar z5 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z1 - k5 * z2;
    });
    const Scalar z6 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z1 * z4 - z2 * z5;
    });
    const Scalar z7 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z1 * z1;
    });
    const Scalar z8 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z9 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z2 * z2;
    });
    const Scalar z10 = z2 * s_steer;
    const Scalar z11 = z1 * s_steer;
    const Scalar z12 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z13 = -z8 * (n1 - c_steer);
    const Scalar z14 = v_roll * s_roll;
    const Scalar z15 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z16 = v_yaw * c_yaw;
    const Scalar z17 = v_roll * c_roll;
    const Scalar z18 = v_yaw * s_yaw;
    const Scalar z19 = s_yaw * c_roll;
    const Scalar z20 = n1 - s_roll * s_roll;
    const Scalar z21 = c_yaw * c_roll;
    const Scalar z22 = s_yaw * s_roll;
    const Scalar z23 = n2 * s_roll;
    const Scalar z24 = c_yaw * s_roll;
    const Scalar z25 = s_roll * z19;
    const Scalar z26 = s_roll * z21;
    const Scalar z27 = s_yaw * z14 - c_roll * z16;
    const Scalar z28 = c_yaw * z14 + c_roll * z18;
    const Scalar z29 = z17 * z23;
    const Scalar z30 = s_roll * z22 - c_roll * z19;
    const Scalar z31 = s_roll * z24 - c_roll * z21;
    const Scalar z32 = c_roll * z23;
    const Scalar z33 = v_roll * z17;
    const Scalar z34 = v_yaw * z18;
    const Scalar z35 = n2 * z14;
    const Scalar z36 = v_roll * z14;
    const Scalar z37 = n2 * z17;
    const Scalar z38 = v_yaw * z16;
    const Scalar z39 = n0_08 * z10 - n0_35 * z11;
    const Scalar z40 = s_pitch * z11 - c_pitch * z10;
    const Scalar z41 = s_pitch * z10 + c_pitch * z11;
    const Scalar z42 = z20 * z20 + z25 * z25 + z26 * z26;
    const Scalar z43 = s_yaw * z33 + c_roll * z34 + z16 * z35;
    const Scalar z44 = c_yaw * z33 + c_roll * z38 - z18 * z35;
    const Scalar z45 = n2 * (s_roll * z36 - z17 * z17);
    const Scalar z46 = n0_08 * z12 - n0_35 * z13;
    const Scalar z47 = n0_08 * z13 - n0_35 * z15;
    const Scalar z48 = s_roll * z27 - z19 * z17;
    const Scalar z49 = s_roll * z28 - z21 * z17;
    const Scalar z50 = n2 * (z20 * z32 + z25 * z30 + z26 * z31);
    const Scalar z51 = s_roll * z39;
    const Scalar z52 = s_roll * z41;
    const Scalar z53 = s_roll * c_steer + c_roll * z41;
    const Scalar z54 = c_yaw * z40;
    const Scalar z55 = n0_3 + z47;
    const Scalar z56 = c_roll * c_steer - z52;
    const Scalar z57 = n1_1 - z46;
    const Scalar z58 = traits::sqrt(z42);
    const Scalar z59 = n2 * (z20 * z29 + z25 * z48 + z26 * z49);
    const Scalar z60 = z19 * z36 + z27 * z37 + s_roll * z43;
    const Scalar z61 = s_yaw * z56 - z54;
    const Scalar z62 = s_pitch * z57 - c_pitch * z55;
    const Scalar z63 = s_pitch * z55 + c_pitch * z57;
    const Scalar z64 = z21 * z36 + z28 * z37 + s_roll * z44;
    const Scalar z65 = s_roll * z62 - c_roll * z39;
    const Scalar z66 = c_roll * z62 + z51;
    const Scalar z67 = n2 * (z25 * z60 + z26 * z64 - z20 * z45 - z48 * z48 - z49 * z49 - z29 * z29);
    const Scalar z68 = s_yaw * z63 + c_yaw * z65;
    const Scalar z69 = q_z - z66;
    const Scalar z70 = q_y + z68;
    const Scalar z71 = s_yaw * z65 - c_yaw * z63;
    const Scalar z72 = n0_3 / z58;
    const Scalar z73 = s_yaw * z40;
    const Scalar z74 = q_x - z71;
    const Scalar z75 = n0_5 * z50 / z58;
    const Scalar z76 = n0_5 * z59 / z58;
    const Scalar z77 = q_x + z25 * z72;
    const Scalar z78 = c_yaw * z56 + z73;
    const Scalar z79 = q_y - z26 * z72;
    const Scalar z80 = z53 * z61;
    const Scalar z81 = q_z + z20 * z72;
    const Scalar z82 = n1 - z53 * z53;
    const Scalar z83 = z53 * z78;
    const Scalar z84 = z82 * z82 + z80 * z80 + z83 * z83;
    const Scalar z85 = v_pitch * c_pitch;
    const Scalar z86 = v_pitch * s_pitch;
    const Scalar z87 = v_steer * c_steer;
    const Scalar z88 = v_steer * s_steer;
    const Scalar z89 = z2 * z87;
    const Scalar z90 = z1 * z87;
    const Scalar z91 = z8 * z88;
    const Scalar z92 = -z88 * (n1 - z9);
    const Scalar z93 = -z88 * (n1 - z7);
    const Scalar z94 = n0_08 * z91 + n0_35 * z92;
    const Scalar z95 = n0_35 * z91 + n0_08 * z93;
    const Scalar z96 = traits::sqrt(z84);
    const Scalar z97 = n0_08 * z89 - n0_35 * z90;
    const Scalar z98 = n0_3 * z75;
    const Scalar z99 = c_roll * z88;
    const Scalar z100 = z10 * z85 - z11 * z86 + s_pitch * z89 + c_pitch * z90;
    const Scalar z101 = z10 * z86 + z11 * z85 + s_pitch * z90 - c_pitch * z89;
    const Scalar z102 = c_steer * z14 + z99 + z17 * z41 + s_roll * z100;
    const Scalar z103 = n2 * z53;
    const Scalar z104 = s_roll * z88 - c_steer * z17 + z14 * z41 - c_roll * z100;
    const Scalar z105 = z16 * z40 - z18 * z56 + s_yaw * z101 - c_yaw * z102;
    const Scalar z106 = n0_35 / z96;
    const Scalar z107 = z53 * z105 - z78 * z104;
    const Scalar z108 = c_yaw * z101 - z18 * z40 - z16 * z56 + s_yaw * z102;
    const Scalar z109 = z61 * z104 + z53 * z108;
    const Scalar z110 = s_pitch * z95 - c_pitch * z94 - z57 * z85 - z55 * z86;
    const Scalar z111 = z69 + z82 * z106;
    const Scalar z112 = z70 - z83 * z106;
    const Scalar z113 = z74 + z80 * z106;
    const Scalar z114 = z17 * z39 + s_roll * z97 - z14 * z62 - c_roll * z110;
    const Scalar z115 = v_z - z114;
    const Scalar z116 = n0_5 * (z59 * z76 / (z58 * z58) + z67 / z58);
    const Scalar z117 = n0_3 * z116;
    const Scalar z118 = z2 * c_steer;
    const Scalar z119 = z1 * c_steer;
    const Scalar z120 = s_pitch * z118 + c_pitch * z119;
    const Scalar z121 = s_pitch * z119 - c_pitch * z118;
    const Scalar z122 = s_roll * z40;
    const Scalar z123 = s_yaw * z41 + c_yaw * z122;
    const Scalar z124 = c_roll * z40;
    const Scalar z125 = s_yaw * z53;
    const Scalar z126 = s_yaw * z122 - c_yaw * z41;
    const Scalar z127 = c_roll * s_steer + s_roll * z120;
    const Scalar z128 = s_roll * s_steer - c_roll * z120;
    const Scalar z129 = c_yaw * z121 + s_yaw * z127;
    const Scalar z130 = s_yaw * z121 - c_yaw * z127;
    const Scalar z131 = z103 * z124;
    const Scalar z132 = c_yaw * z53;
    const Scalar z133 = v_pitch * z86;
    const Scalar z134 = z56 * z61 - z53 * z125;
    const Scalar z135 = z53 * z123 - z78 * z124;
    const Scalar z136 = z53 * z129 + z61 * z128;
    const Scalar z137 = v_pitch * z85;
    const Scalar z138 = z56 * z78 - z53 * z132;
    const Scalar z139 = v_steer * z88;
    const Scalar z140 = v_steer * z87;
    const Scalar z141 = z53 * z130 - z78 * z128;
    const Scalar z142 = z53 * z126 - z61 * z124;
    const Scalar z143 = z2 * z139;
    const Scalar z144 = z56 * z103;
    const Scalar z145 = z104 * z103;
    const Scalar z146 = z103 * z128;
    const Scalar z147 = z1 * z139;
    const Scalar z148 = n2 * (z82 * z131 + z83 * z135 + z80 * z142);
    const Scalar z149 = n2 * (z80 * z134 + z83 * z138 - z82 * z144);
    const Scalar z150 = n2 * (z80 * z136 - z83 * z141 - z82 * z146);
    const Scalar z151 = z10 * z133 + z11 * z137 + s_pitch * z143 + c_pitch * z147 - n2 * (z89 * z85 - z90 * z86);
    const Scalar z152 = s_steer * z8;
    const Scalar z153 = s_steer * (n1 - z7);
    const Scalar z154 = n0_08 * z153 - n0_35 * z152;
    const Scalar z155 = s_steer * (n1 - z9);
    const Scalar z156 = n0_08 * z152 - n0_35 * z155;
    const Scalar z157 = z11 * z133 - z10 * z137 + s_pitch * z147 - c_pitch * z143 - n2 * (z89 * z86 + z90 * z85);
    const Scalar z158 = n0_08 * z143 - n0_35 * z147;
    const Scalar z159 = z36 * z41 - c_roll * z140 - c_steer * z33 - n2 * (z17 * z100 - z14 * z88) + s_roll * z151;
    const Scalar z160 = n2 * (z80 * z109 - z83 * z107 - z82 * z145);
    const Scalar z161 = n0_5 * z148 / z96;
    const Scalar z162 = n0_5 * z149 / z96;
    const Scalar z163 = n0_5 * z150 / z96;
    const Scalar z164 = c_pitch * z156 + s_pitch * z154;
    const Scalar z165 = n0_08 * z118 - n0_35 * z119;
    const Scalar z166 = c_roll * z63;
    const Scalar z167 = s_roll * z165 + c_roll * z164;
    const Scalar z168 = z38 * z40 - z34 * z56 - n2 * (z16 * z102 - z18 * z101) + c_yaw * z157 + s_yaw * z159;
    const Scalar z169 = n0_5 * z160 / z96;
    const Scalar z170 = s_roll * z140 + c_steer * z36 + z33 * z41 + n2 * (z17 * z88 + z14 * z100) + c_roll * z151;
    const Scalar z171 = n2 * z104;
    const Scalar z172 = z34 * z40 + z38 * z56 - n2 * (z16 * z101 + z18 * z102) + s_yaw * z157 - c_yaw * z159;
    const Scalar z173 = n2 * (z53 * z170 - z104 * z104);
    const Scalar z174 = z105 * z171 + z78 * z170 + z53 * z172;
    const Scalar z175 = z166 - n0_35 * z161;
    const Scalar z176 = z108 * z171 - z61 * z170 + z53 * z168;
    const Scalar z177 = z65 + n0_35 * z162;
    const Scalar z178 = q_x - z77;
    const Scalar z179 = q_z - z81;
    const Scalar z180 = q_y - z79;
    const Scalar z181 = q_x - z113;
    const Scalar z182 = q_y - z112;
    const Scalar z183 = q_z - z111;
    const Scalar z184 = z8 * z140;
    const Scalar z185 = n2 * (z145 * z145 + z107 * z107 + z109 * z109 + z82 * z173 - z83 * z174 + z80 * z176);
    const Scalar z186 = s_yaw * z183;
    const Scalar z187 = -z140 * (n1 - z7);
    const Scalar z188 = n0_35 * z184 + n0_08 * z187;
    const Scalar z189 = z72 * z48;
    const Scalar z190 = z167 + n0_35 * z163;
    const Scalar z191 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z192 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z193 = s_roll * z192;
    const Scalar z194 = s_pitch * z1 - c_pitch * z2;
    const Scalar z195 = s_pitch * z2 + c_pitch * z1;
    const Scalar z196 = s_roll * z194;
    const Scalar z197 = c_roll * z194;
    const Scalar z198 = c_yaw * z183;
    const Scalar z199 = s_yaw * z195 + c_yaw * z196;
    const Scalar z200 = s_yaw * z196 - c_yaw * z195;
    const Scalar z201 = -z140 * (n1 - z9);
    const Scalar z202 = n0_08 * z184 + n0_35 * z201;
    const Scalar z203 = s_yaw * z191 + c_yaw * z193;
    const Scalar z204 = c_roll * z192;
    const Scalar z205 = s_yaw * z193 - c_yaw * z191;
    const Scalar z206 = q_z - z204;
    const Scalar z207 = n0_3 * z76 / (z58 * z58);
    const Scalar z208 = s_roll * z181 + z19 * z183;
    const Scalar z209 = s_roll * z178 + z19 * z179;
    const Scalar z210 = s_roll * z182 - z21 * z183;
    const Scalar z211 = z160 * z169;
    const Scalar z212 = s_yaw * z179;
    const Scalar z213 = v_x - z189 + z25 * z207;
    const Scalar z214 = v_x - z213;
    const Scalar z215 = s_roll * z180 - z21 * z179;
    const Scalar z216 = z72 * z49;
    const Scalar z217 = c_yaw * z179;
    const Scalar z218 = v_y + z216 - z26 * z207;
    const Scalar z219 = v_z - z72 * z29 + z20 * z207;
    const Scalar z220 = v_z - z219;
    const Scalar z221 = s_pitch * z188 - z55 * z137 - c_pitch * z202 + z57 * z133 + n2 * (z85 * z95 + z86 * z94);
    const Scalar z222 = v_y - z218;
    const Scalar z223 = q_y + z203;
    const Scalar z224 = c_yaw * z220 - z18 * z179;
    const Scalar z225 = z19 * z220;
    const Scalar z226 = z17 * z178 - z27 * z179 + s_roll * z214 + z225;
    const Scalar z227 = z16 * z179 + s_yaw * z220;
    const Scalar z228 = z21 * z220;
    const Scalar z229 = z36 * z39 + s_roll * z158 + z33 * z62 - n2 * (z17 * z97 + z14 * z110) + c_roll * z221;
    const Scalar z230 = z69 - z111;
    const Scalar z231 = z111 - z206;
    const Scalar z232 = z70 - z112;
    const Scalar z233 = z112 - z223;
    const Scalar z234 = z74 - z113;
    const Scalar z235 = z78 * z230;
    const Scalar z236 = q_x - z205;
    const Scalar z237 = z113 - z236;
    const Scalar z238 = z53 * z232 - z235;
    const Scalar z239 = z200 * z231;
    const Scalar z240 = z199 * z231;
    const Scalar z241 = z197 * z233 + z240;
    const Scalar z242 = z197 * z237 - z239;
    const Scalar z243 = n0_5 * (z211 / (z96 * z96) - z185 / z96);
    const Scalar z244 = z229 - n0_35 * z243;
    const Scalar z245 = s_pitch * z94;
    const Scalar z246 = z61 * z230;
    const Scalar z247 = z53 * z234 + z246;
    const Scalar z248 = c_roll * z97;
    const Scalar z249 = z245 + c_pitch * z95 - z55 * z85 + z57 * z86;
    const Scalar z250 = z248 - z14 * z39 - z17 * z62 + s_roll * z110;
    const Scalar z251 = z1 * z85 + z2 * z86;
    const Scalar z252 = n0_35 * z169 / (z96 * z96);
    const Scalar z253 = z115 + z106 * z145 + z82 * z252;
    const Scalar z254 = z28 * z183;
    const Scalar z255 = z17 * z180 + z28 * z179 + s_roll * z222 - z228;
    const Scalar z256 = s_yaw * z249 - z16 * z63 + z18 * z65 + c_yaw * z250;
    const Scalar z257 = c_roll * z251 - z14 * z194;
    const Scalar z258 = v_z - z253;
    const Scalar z259 = z16 * z183 + s_yaw * z258;
    const Scalar z260 = v_yaw * z214 + z226 * (v_pitch + v_rear) - v_roll * z224;
    const Scalar z261 = v_yaw * z222 - v_roll * z227 + z255 * (v_pitch + v_rear);
    const Scalar z262 = z115 - z253;
    const Scalar z263 = v_yaw * s_roll;
    const Scalar z264 = v_yaw * c_roll;
    const Scalar z265 = v_roll * c_pitch - s_pitch * z264;
    const Scalar z266 = v_roll * s_pitch + c_pitch * z264;
    const Scalar z267 = a_yaw * c_roll;
    const Scalar z268 = v_roll * z263 - z267;  // angular acceleration of frame.2, z
    const Scalar z269 = a_yaw * s_roll;
    const Scalar z270 = v_roll * z264 + z269;  // angular acceleration of frame.2, y
    const Scalar z271 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z272 = n9_81 - a_z;
    const Scalar z273 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z274 = s_roll * z271 - c_roll * z272;
    const Scalar z275 = s_roll * z272 + c_roll * z271;
    const Scalar z276 = z1 * z86 - z2 * z85;
    const Scalar z277 = v_y - z256;
    const Scalar z278 = a_roll * c_pitch + s_pitch * z268;
    const Scalar z279 = a_roll * s_pitch - c_pitch * z268;
    const Scalar z280 = n0_3 * z85 - n1_1 * z86;
    const Scalar z281 = z17 * z194 + s_roll * z251;
    const Scalar z282 = n1_1 * z85 + n0_3 * z86;
    const Scalar z283 = s_yaw * z250 - c_yaw * z249 - z16 * z65 - z18 * z63;
    const Scalar z284 = s_yaw * z276 - z16 * z195 + z18 * z196 - c_yaw * z281;
    const Scalar z285 = z106 * z107 - z277 + z83 * z252;
    const Scalar z286 = z277 + z285;
    const Scalar z287 = s_pitch * z274 - c_pitch * z273;
    const Scalar z288 = z17 * z192 + s_roll * z282;
    const Scalar z289 = v_x + z283;
    const Scalar z290 = z16 * z191 + s_yaw * z280 - z18 * z193 + c_yaw * z288;
    const Scalar z291 = v_y + z290;
    const Scalar z292 = c_roll * z282 - z14 * z192;
    const Scalar z293 = z289 - z106 * z109 + z80 * z252;
    const Scalar z294 = z285 + z291;
    const Scalar z295 = v_y + z285;
    const Scalar z296 = v_pitch * z266 - z278;  // angular acceleration of frame, x
    const Scalar z297 = v_pitch * z265 + z279;  // angular acceleration of frame, z
    const Scalar z298 = z289 - z293;
    const Scalar z299 = v_pitch + z263;  // angular velocity of frame, y
    const Scalar z300 = a_pitch + z270;  // angular acceleration of frame, y
    const Scalar z301 = s_pitch * z273 + c_pitch * z274;
    const Scalar z302 = z18 * z191 - c_yaw * z280 + z16 * z193 + s_yaw * z288;
    const Scalar z303 = v_z - z292;
    const Scalar z304 = z253 - z303;
    const Scalar z305 = v_x - z293;
    const Scalar z306 = z18 * z195 + c_yaw * z276 + z16 * z196 + s_yaw * z281;
    const Scalar z307 = v_x - z302;
    const Scalar z308 = z293 - z307;
    const Scalar z309 = z27 * z183;
    const Scalar z310 = z231 * z284;
    const Scalar z311 = z231 * z306;
    const Scalar z312 = z108 * z230;
    const Scalar z313 = z105 * z230;
    const Scalar z314 = c_yaw * z258 - z18 * z183;
    const Scalar z315 = z17 * z182 + z254 + s_roll * z295 - z21 * z258;
    const Scalar z316 = z265 * z299;
    const Scalar z317 = z265 * z266;
    const Scalar z318 = z297 + z316;
    const Scalar z319 = z266 * z299;
    const Scalar z320 = z299 * z299;
    const Scalar z321 = z266 * z266;
    const Scalar z322 = z300 - z317;
    const Scalar z323 = z296 + z319;
    const Scalar z324 = z265 * z265;
    const Scalar z325 = z320 + z321;
    const Scalar z326 = z320 + z324;
    const Scalar z327 = z300 + z317;
    const Scalar z328 = s_rear * z265 + c_rear * z266;
    const Scalar z329 = v_rear + z299;  // angular velocity of rear_wheel, y
    const Scalar z330 = a_rear + z300;  // angular acceleration of rear_wheel, y
    const Scalar z331 = s_rear * z266 - c_rear * z265;
    const Scalar z332 = z17 * z181 - z309 + s_roll * z305 + z19 * z258;
    const Scalar z333 = z310 - z233 * z257 + z197 * z294 - z199 * z304;
    const Scalar z334 = z11 * z299 + z13 * z265 - z15 * z266;
    const Scalar z335 = z10 * z299 - z13 * z266 + z12 * z265;
    const Scalar z336 = c_steer * z299 - z10 * z265 + z11 * z266;
    const Scalar z337 = z12 * z296 - z10 * z300 + z13 * z297;
    const Scalar z338 = z237 * z257 - z311 + z197 * z308 - z200 * z304;
    const Scalar z339 = z53 * z286 - z313 - z104 * z232 - z78 * z262;
    const Scalar z340 = c_steer * z300 + z10 * z296 + z11 * z297;
    const Scalar z341 = z53 * z298 - z312 - z104 * z234 + z61 * z262;
    const Scalar z342 = v_yaw * z295 - v_roll * z259 + v_pitch * z315 - v_steer * z333 + v_front * z339;
    const Scalar z343 = z2 * v_steer;
    const Scalar z344 = z1 * a_steer - z337 + z336 * z343;  // angular acceleration of fork, x
    const Scalar z345 = z334 - z343;  // angular velocity of fork, z
    const Scalar z346 = z1 * z334 + z2 * z335;
    const Scalar z347 = v_steer * z346 - z340;  // angular acceleration of fork, y
    const Scalar z348 = z1 * v_steer;
    const Scalar z349 = z335 + z348;  // angular velocity of fork, x
    const Scalar z350 = z275 - n1_1 * z318 - n0_3 * z323;
    const Scalar z351 = z301 - n1_1 * z322 - n0_3 * z326;
    const Scalar z352 = z336 * z336;
    const Scalar z353 = z287 + n1_1 * z325 - n0_3 * z327;
    const Scalar z354 = z13 * z296 - z11 * z300 + z15 * z297;
    const Scalar z355 = z354 + z2 * a_steer - z336 * z348;  // angular acceleration of fork, z
    const Scalar z356 = z345 * z345;
    const Scalar z357 = z10 * z350 + z13 * z351 + z12 * z353;
    const Scalar z358 = c_steer * z350 - z10 * z353 - z11 * z351;
    const Scalar z359 = z11 * z350 + z15 * z351 + z13 * z353;
    const Scalar z360 = v_yaw * z305 - v_roll * z314 + v_pitch * z332 + v_steer * z338 + v_front * z341;
    const Scalar z361 = n0_12 * z330;  // moment on rear_wheel, y
    const Scalar z362 = s_front * z345 + c_front * z349;
    const Scalar z363 = s_front * z349 - c_front * z345;
    const Scalar z364 = v_front + z336;  // angular velocity of front_wheel, y
    const Scalar z365 = a_front - z347;  // angular acceleration of front_wheel, y
    const Scalar z366 = n0_28 * z365;  // moment on front_wheel, y
    const Scalar z367 = z362 * z364;
    const Scalar z368 = z349 * z349;
    const Scalar z369 = z349 * z345;
    const Scalar z370 = z363 * z364;
    const Scalar z371 = n0_28 * z367;  // moment on front_wheel, z
    const Scalar z372 = n0_28 * z370;  // moment on front_wheel, x
    const Scalar z373 = z352 + z368;
    const Scalar z374 = z352 + z356;
    const Scalar z375 = z356 - z368;
    // moment on fork, y
    const Scalar z376 = z366 - k16 * z369 - k4 * z375 - n2_5667 * z347 + n3_85 * z357 + n1_04 * z359;
    const Scalar z377 = z328 * z329;
    const Scalar z378 = n0_12 * z377;  // moment on rear_wheel, x
    const Scalar z379 = z347 - z369;
    const Scalar z380 = z347 + z369;
    const Scalar z381 = z331 * z329;
    const Scalar z382 = n0_12 * z381;  // moment on rear_wheel, z
    const Scalar z383 = s_front * z371 - c_front * z372;
    const Scalar z384 = s_front * z372 + c_front * z371;
    const Scalar z385 = z336 * z349;
    const Scalar z386 = z355 + z385;
    const Scalar z387 = z336 * z345;
    const Scalar z388 = s_rear * z378 - c_rear * z382;
    const Scalar z389 = s_rear * z382 + c_rear * z378;
    const Scalar z390 = n3_85 * z358 - z383 - k18 * z387 - k3 * z344 + k4 * z386;  // moment on fork, x
    const Scalar z391 = z321 - z324;
    const Scalar z392 = n3_85 * z373 - n1_04 * z379 + n7 * z359;  // force on fork, z
    const Scalar z393 = z344 + z387;
    const Scalar z394 = z384 + k20 * z385 + k5 * z355 + n1_04 * z358 - k4 * z393;  // moment on fork, z
    const Scalar z395 = z3 * z10;
    const Scalar z396 = z3 * z11;
    const Scalar z397 = n7 * z357 - n1_04 * z374 - n3_85 * z380;  // force on fork, x
    const Scalar z398 = z4 * z10 + z5 * z11;
    const Scalar z399 = n0_3 * z395 - z398 + n1_1 * z396;
    const Scalar z400 = c_steer * z3;
    const Scalar z401 = z5 * z13 + z4 * z12;
    const Scalar z402 = n0_3 * z400 - z401;
    const Scalar z403 = s_pitch * z395 + c_pitch * z396;
    const Scalar z404 = n0_28 * z10;
    const Scalar z405 = n7 * z358 + n1_04 * z386 - n3_85 * z393;  // force on fork, y
    const Scalar z406 = z4 * z13 + z5 * z15;
    const Scalar z407 = n1_1 * z400 - z406;
    const Scalar z408 = n0_28 * z11;
    const Scalar z409 = s_pitch * z396 - c_pitch * z395;
    const Scalar z410 = n0_28 * c_steer;
    const Scalar z411 = z13 * z392 + z12 * z397 - z10 * z405;
    const Scalar z412 = z411 + n25_5 * z325 + n51 * z327;  // force on frame, x
    const Scalar z413 = n1_04 * z12 - n3_85 * z13;
    const Scalar z414 = c_steer * z376;
    const Scalar z415 = s_roll * z403 - c_roll * z400;
    const Scalar z416 = s_pitch * z404 + c_pitch * z408;
    const Scalar z417 = z11 * z392 + c_steer * z405 + z10 * z397;
    const Scalar z418 = n1_04 * z10 - n3_85 * z11;
    const Scalar z419 = z15 * z392 + z13 * z397 - z11 * z405;
    const Scalar z420 = n25_5 * z322 - z419 - n51 * z326;  // force on frame, z
    const Scalar z421 = n1_04 * z13 - n3_85 * z15;
    const Scalar z422 = s_pitch * z402 + c_pitch * z407;
    const Scalar z423 = c_yaw * z409 + s_yaw * z415;
    const Scalar z424 = s_yaw * z409 - c_yaw * z415;
    const Scalar z425 = s_roll * z410 + c_roll * z416;
    const Scalar z426 = z10 * z390 - z414 + z11 * z394;
    // moment on frame, y
    const Scalar z427 = z361 + n49_25 * z300 + n29_35 * z317 + n17_7 * z391 - n25_5 * z301 + n51 * z287 - n0_3 * z411
        - n1_1 * z419 - z426;
    const Scalar z428 = z11 * z376 + z13 * z390 + z15 * z394;
    // moment on frame, z
    const Scalar z429 = n25_5 * z275 - z388 - n49_25 * z316 + n29_35 * z297 + n17_7 * z323 + n1_1 * z417 - z428;
    const Scalar z430 = v_roll * z264;
    const Scalar z431 = n39_8603 * (z270 - z430) - z427;  // moment on frame.2, y
    const Scalar z432 = v_roll * z263;
    const Scalar z433 = s_roll * z399 - c_roll * z422;
    const Scalar z434 = s_pitch * z407 - c_pitch * z402;
    const Scalar z435 = s_roll * z400 + c_roll * z403;
    const Scalar z436 = z10 * z376 + z12 * z390 + z13 * z394;
    const Scalar z437 = z389 + n78_6 * z319 + n51 * z275 - n17_7 * z318 - n0_3 * z417 + z436;  // moment on frame, x
    const Scalar z438 = n2_8467 * z11;
    const Scalar z439 = k4 * z13;
    const Scalar z440 = n2_8467 * z10;
    const Scalar z441 = k3 * z13 + k4 * z15;
    const Scalar z442 = k3 * z12 + z439;
    const Scalar z443 = k5 * z15 + z439;
    const Scalar z444 = k5 * z13 + k4 * z12;
    const Scalar z445 = z10 * z440 + z12 * z442 + z13 * z444;
    const Scalar z446 = n2_8467 * c_steer;
    const Scalar z447 = k3 * z10 + k4 * z11;
    const Scalar z448 = k4 * z10 + k5 * z11;
    const Scalar z449 = c_steer * z446 + z10 * z447 + z11 * z448;
    const Scalar z450 = z12 * z447 - z10 * z446 + z13 * z448;
    const Scalar z451 = n25_5 * z318 - z417 - n51 * z323;  // force on frame, y
    const Scalar z452 = n0_63 + n0_6 * z421 + z445;
    const Scalar z453 = z11 * z438 + z13 * z441 + z15 * z443;
    const Scalar z454 = n1_1 * z418 + z450;
    const Scalar z455 = z10 * z438 + z12 * z441 + z13 * z443;
    const Scalar z456 = c_steer * z438 - z10 * z441 - z11 * z443;
    const Scalar z457 = s_pitch * z408 - c_pitch * z404;
    const Scalar z458 = s_pitch * z412 - c_pitch * z420;
    const Scalar z459 = s_pitch * z437 - c_pitch * z429;
    const Scalar z460 = z459 - n79_7206 * z432;  // moment on frame.2, z
    const Scalar z461 = s_pitch * z420 + c_pitch * z412;
    const Scalar z462 = n2_31 + n1_1 * z421 - n0_3 * z413 + z455;
    const Scalar z463 = n9_1 + n0_6 * z421 - n2_2 * z413 + z449;
    const Scalar z464 = n0_3 * z418 + z456;
    const Scalar z465 = z263 * z264;
    const Scalar z466 = n8_47 - n2_2 * z413 + z453;
    const Scalar z467 = n2_1 + z421;
    const Scalar z468 = n51 - z467;
    const Scalar z469 = n7_7 - z413;
    const Scalar z470 = n25_5 + z469;
    const Scalar z471 = s_roll * z458 - c_roll * z451;
    const Scalar z472 = n49_25 + z463;
    const Scalar z473 = s_roll * z451 + c_roll * z458;
    const Scalar z474 = n87 * z272 - z473;  // force on frame.z, z
    const Scalar z475 = n17_7 - z462;
    const Scalar z476 = s_yaw * z471 - c_yaw * z461;
    const Scalar z477 = n29_35 - z466;
    const Scalar z478 = s_yaw * z461 + c_yaw * z471;
    const Scalar z479 = n87 * a_x + z476;  // force on frame.z, x
    const Scalar z480 = n0_12 + z472;
    const Scalar z481 = n87 * a_y - z478;  // force on frame.z, y
    const Scalar z482 = z1 * z374 + z2 * z380;
    const Scalar z483 = z1 * z379 - z2 * z373;
    const Scalar z484 = z1 * z359 + z2 * z357;
    const Scalar z485 = z296 - z319;
    const Scalar z486 = z297 - z316;
    const Scalar z487 = z321 + z324;
    const Scalar z488 = z270 - z430;
    const Scalar z489 = n2 * z299;
    const Scalar z490 = n2 * z328;
    const Scalar z491 = n2 * z331;
    const Scalar z492 = n2 * z349;
    const Scalar z493 = z452 + z477;
    const Scalar z494 = n2 * z475;
    const Scalar z495 = s_pitch * z493 - c_pitch * z494;
    const Scalar z496 = z2 * z336;
    const Scalar z497 = z1 * z336;
    const Scalar z498 = n39_8603 - z480;
    const Scalar z499 = z1 * z345 + z2 * z349;
    const Scalar z500 = s_pitch * z454 - c_pitch * z464;
    const Scalar z501 = c_pitch * z468 + s_pitch * z470;
    const Scalar z502 = s_pitch * z495;
    const Scalar z503 = c_pitch * z495 + z475;
    const Scalar z504 = n2 * z500;
    const Scalar z505 = z477 - z502;
    const Scalar z506 = z452 - z502;
    const Scalar z507 = n2 * z265;
    const Scalar z508 = z2 * z358;
    const Scalar z509 = s_pitch * z468 - c_pitch * z470;
    const Scalar z510 = n39_8603 + z506;
    const Scalar z511 = z505 - z498;
    const Scalar z512 = n2 * z266;
    const Scalar z513 = z1 * z386 - z2 * z393;
    const Scalar z514 = s_roll * z511 - c_roll * z504;
    const Scalar z515 = s_roll * z501 - c_roll * z418;
    const Scalar z516 = s_roll * z509;
    const Scalar z517 = z1 * z358;
    const Scalar z518 = n2 * z329;
    const Scalar z519 = n0_12 * s_roll;
    const Scalar z520 = n2 * z336;
    const Scalar z521 = n2 * z345;
    const Scalar z522 = s_yaw * z509 - c_yaw * z515;
    const Scalar z523 = s_roll * z514;
    const Scalar z524 = z263 * z263;
    const Scalar z525 = z264 * z264;
    const Scalar z526 = z524 + z525;
    const Scalar z527 = z505 - z523;
    const Scalar z528 = z2 * z520;
    const Scalar z529 = c_yaw * z509 + s_yaw * z515;
    const Scalar z530 = z1 * z521 + z2 * z492;
    const Scalar z531 = n39_8603 - z527;
    const Scalar z532 = s_yaw * z501 + c_yaw * z516;
    const Scalar z533 = s_pitch * z464 + c_pitch * z454;
    const Scalar z534 = n2 * z362;
    const Scalar z535 = n2 * z364;
    const Scalar z536 = z1 * z520;
    const Scalar z537 = c_roll * z509;
    const Scalar z538 = n2 * z363;
    const Scalar z539 = s_yaw * z516 - c_yaw * z501;
    const Scalar z540 = z268 - z432;
    const Scalar z541 = s_roll * z480 - c_roll * z500;
    const Scalar z542 = n0_14 * z534;
    const Scalar z543 = n0_14 * z538;
    const Scalar z544 = n0_14 * z535;
    const Scalar z545 = s_front * z542 - c_front * z543;
    const Scalar z546 = s_front * z543 + c_front * z542;
    const Scalar z547 = k4 * z520;
    const Scalar z548 = n1_04 * z520;
    const Scalar z549 = n3_85 * z520;
    const Scalar z550 = k40 * z520 + z544;
    const Scalar z551 = n3_85 * z492 + n1_04 * z521;
    const Scalar z552 = n0_1435 * z521 - z545;
    const Scalar z553 = z545 + k4 * z492 + k42 * z521;
    const Scalar z554 = n2 * z264;
    const Scalar z555 = s_roll * z418 + c_roll * z501;
    const Scalar z556 = k42 * z520 + z544;
    const Scalar z557 = z546 + k40 * z492 + k4 * z521;
    const Scalar z558 = n2 * z263;
    const Scalar z559 = s_yaw * z555;
    const Scalar z560 = c_yaw * z555;
    const Scalar z561 = n2 * v_roll;
    const Scalar z562 = s_roll * z533 - c_roll * z503;
    const Scalar z563 = n0_1435 * z492 - z546;
    const Scalar z564 = n0_06 * z490;
    const Scalar z565 = n0_06 * z491;
    const Scalar z566 = n0_06 * z518;
    const Scalar z567 = z13 * z547;
    const Scalar z568 = z12 * z547 + z13 * z556 + z10 * z553;
    const Scalar z569 = z567 + z15 * z556 + z11 * z553;
    const Scalar z570 = z567 + z12 * z550 + z10 * z557;
    const Scalar z571 = z12 * z552 - z13 * z563;
    const Scalar z572 = z13 * z552 - z15 * z563;
    const Scalar z573 = z10 * z552 - z11 * z563;
    const Scalar z574 = c_steer * z553 - z10 * z547 - z11 * z556;
    const Scalar z575 = z15 * z547 + z13 * z550 + z11 * z557;
    const Scalar z576 = n0_3 * z489;
    const Scalar z577 = n1_1 * z489;
    const Scalar z578 = z12 * z549 + z13 * z548 + z10 * z551;
    const Scalar z579 = n7 * z576 - z578;
    const Scalar z580 = z13 * z549 + z15 * z548 + z11 * z551;
    const Scalar z581 = n7 * z577 - z580;
    const Scalar z582 = c_steer * z557 - z10 * z550 - z11 * z547;
    const Scalar z583 = z13 * z568 - z11 * z571 - z15 * z570;
    const Scalar z584 = z421 * z576 - z583 + n0_3 * z579;
    const Scalar z585 = z12 * z569 - z10 * z572 - z13 * z575;
    const Scalar z586 = z413 * z577 - z585 - n1_1 * z581;
    const Scalar z587 = z12 * z568 - z10 * z571 - z13 * z570;
    const Scalar z588 = c_steer * z571 + z10 * z568 - z11 * z570;
    const Scalar z589 = z413 * z576 - z587 - n1_1 * z579;
    const Scalar z590 = z584 + z566;
    const Scalar z591 = z586 - z566;
    const Scalar z592 = z418 * z576 - z588;
    const Scalar z593 = n51 * z489 - z579;
    const Scalar z594 = n39_3 * z489 + z590;
    const Scalar z595 = n9_95 * z489 - z591;
    const Scalar z596 = z13 * z569 - z11 * z572 - z15 * z575;
    const Scalar z597 = c_steer * z572 + z10 * z569 - z11 * z575;
    const Scalar z598 = z421 * z577 - z596 + n0_3 * z581;
    const Scalar z599 = z418 * z577 - z597;
    const Scalar z600 = n25_5 * z489 + z581;
    const Scalar z601 = n17_7 * z489;
    const Scalar z602 = z589 + z601;
    const Scalar z603 = n0_3 * z507 - n1_1 * z512;
    const Scalar z604 = z598 - z601;
    const Scalar z605 = c_steer * z551 - z10 * z549 - z11 * z548;
    const Scalar z606 = n7 * z603 - z605;
    const Scalar z607 = z11 * z573 + z13 * z574 - z15 * z582;
    const Scalar z608 = z10 * z573 + z12 * z574 - z13 * z582;
    const Scalar z609 = c_steer * z573 - z10 * z574 + z11 * z582;
    const Scalar z610 = z421 * z603 - z607 + n0_3 * z606;
    const Scalar z611 = z413 * z603 - z608 - n1_1 * z606;
    const Scalar z612 = n51 * z507 - z606 + n25_5 * z512;
    const Scalar z613 = z418 * z603 + z609;
    const Scalar z614 = n7 * z273 + z461;
    const Scalar z615 = n7 * z271 - z471;
    const Scalar z616 = z273 * z555;
    const Scalar z617 = s_rear * z564 - c_rear * z565;
    const Scalar z618 = s_rear * z565 + c_rear * z564;
    const Scalar z619 = z610 + z617;
    const Scalar z620 = z592 - z618;
    const Scalar z621 = z611 + z618;
    const Scalar z622 = z599 - z617;
    const Scalar z623 = n39_3 * z507 - z622;
    const Scalar z624 = n39_3 * z512 - z620;
    const Scalar z625 = z619 + n39_3 * z507 + n17_7 * z512;
    const Scalar z626 = z621 + n17_7 * z507 + n9_95 * z512;
    const Scalar z627 = z602 - z604;
    const Scalar z628 = z594 - z595;
    const Scalar z629 = s_pitch * z627 + c_pitch * z628;
    const Scalar z630 = s_pitch * z600 + c_pitch * z593;
    const Scalar z631 = z418 * z526 + n7 * z275 - z509 * z540 + z264 * z630 + z451;
    const Scalar z632 = n7 * z274 - z501 * z526 + z509 * z488 + z263 * z630 - z458;
    const Scalar z633 = s_pitch * z593 - c_pitch * z600;
    const Scalar z634 = z509 * z554 + z612;
    const Scalar z635 = z275 * z509;
    const Scalar z636 = s_pitch * z629;
    const Scalar z637 = z509 * z558 - z633;
    const Scalar z638 = s_pitch * z623 - c_pitch * z624;
    const Scalar z639 = n39_8603 * z554 + z638;
    const Scalar z640 = s_pitch * z624 + c_pitch * z623;
    const Scalar z641 = n39_8603 * z561 - z640;
    const Scalar z642 = z604 + z636;
    const Scalar z643 = z602 - z636;
    const Scalar z644 = s_pitch * z625 - c_pitch * z626;
    const Scalar z645 = s_roll * z634 - c_roll * z637;
    const Scalar z646 = s_roll * z637 + c_roll * z634;
    const Scalar z647 = s_pitch * z626 + c_pitch * z625;
    const Scalar z648 = z301 * z468 + z287 * z470 - z464 * z485 - z454 * z486 - z480 * z487 + z265 * z625 + z266 * z626;
    const Scalar z649 = n7 * z301 + z418 * z485 - z468 * z487 + z265 * z612 + z420;
    const Scalar z650 = n7 * z287 - z418 * z486 - z470 * z487 + z266 * z612 - z412;
    const Scalar z651 = z271 * z501 + z273 * z516;
    const Scalar z652 = z468 * z486 + z470 * z485 + z265 * z593 + z266 * z600;
    const Scalar z653 = s_roll * z633 - c_roll * z612;
    const Scalar z654 = z501 * z540 - z418 * z488 + z264 * z633 + z263 * z612;
    const Scalar z655 = z613 + z642;
    const Scalar z656 = z602 + z604;
    const Scalar z657 = z613 - z604;
    const Scalar z658 = z613 - z602;
    const Scalar z659 = c_pitch * z629 - z594;
    const Scalar z660 = z429 + z452 * z486 - z287 * z418 + z454 * z487 + z475 * z485 + z266 * z657 + z265 * z594;
    const Scalar z661 = c_pitch * z629 + z595;
    const Scalar z662 = z437 + z477 * z485 - z301 * z418 - z464 * z487 - z475 * z486 + z265 * z658 - z266 * z595;
    const Scalar z663 = z656 + z454 * z512 - z464 * z507;
    const Scalar z664 = n39_8603 * z558 + z659;
    const Scalar z665 = z664 + z500 * z554 - z505 * z558;
    const Scalar z666 = s_pitch * z650 + c_pitch * z649;
    const Scalar z667 = z418 * z558 + z501 * z554;
    const Scalar z668 = z274 * z501 - z275 * z418 - z533 * z540 + z503 * z488 - z510 * z526 + z264 * z639 + z263 * z661;
    const Scalar z669 = s_roll * z639 - c_roll * z661;
    const Scalar z670 = n39_8603 * z554 + z644;
    const Scalar z671 = s_pitch * z649 - c_pitch * z650;
    const Scalar z672 = z670 + z500 * z558 - z498 * z554;
    const Scalar z673 = z644 + z480 * z554 + z500 * z558;
    const Scalar z674 = z647 - z641;
    const Scalar z675 = s_roll * z655 - c_roll * z674;
    const Scalar z676 = s_roll * z631 - c_roll * z632;
    const Scalar z677 = c_roll * z631 + s_roll * z632;
    const Scalar z678 = s_roll * z672 - c_roll * z665;
    const Scalar z679 = s_roll * z675;
    const Scalar z680 = z418 * z507 - z600;
    const Scalar z681 = z613 - z679;
    const Scalar z682 = z470 * z507 - z468 * z512;
    const Scalar z683 = c_roll * z652 + s_roll * z671;
    const Scalar z684 = s_roll * z652 - c_roll * z671;
    const Scalar z685 = z643 - z681;
    const Scalar z686 = s_yaw * z645 - c_yaw * z667;
    const Scalar z687 = s_yaw * z667 + c_yaw * z645;
    const Scalar z688 = s_yaw * z653 - c_yaw * z630;
    const Scalar z689 = z418 * z512 + z593;
    const Scalar z690 = s_yaw * z630 + c_yaw * z653;
    const Scalar z691 = z624 + z452 * z512 - z475 * z507;
    const Scalar z692 = z475 * z512 - z623 + z477 * z507;
    const Scalar z693 = s_yaw * z654 - c_yaw * z676;
    const Scalar z694 = c_yaw * z654 + s_yaw * z676;
    const Scalar z695 = s_roll * z656 - c_roll * z647;
    const Scalar z696 = z480 * z540 - z635 + z533 * z526 - z500 * z488 + z264 * z656 + z263 * z647;
    const Scalar z697 = s_yaw * z666 + c_yaw * z683;
    const Scalar z698 = s_yaw * z683 - c_yaw * z666;
    const Scalar z699 = z613 - z643;
    const Scalar z700 = z431 + z274 * z509 - z500 * z540 - z503 * z526 - z505 * z488 + z264 * z641 + z263 * z699;
    const Scalar z701 = z642 + z643;
    const Scalar z702 = z533 * z526 - z635 - z500 * z488 - z498 * z540 + z460 + z263 * z647 + z264 * z701;
    const Scalar z703 = z613 - z642;
    const Scalar z704 = c_roll * z700 + s_roll * z702;
    const Scalar z705 = z703 + z533 * z554 + z503 * z558;
    const Scalar z706 = z273 * z509 + z271 * z515;
    const Scalar z707 = s_pitch * z680 - c_pitch * z689;
    const Scalar z708 = s_pitch * z689 + c_pitch * z680;
    const Scalar z709 = s_yaw * z614 - c_yaw * z615;
    const Scalar z710 = c_yaw * z614 + s_yaw * z615;
    const Scalar z711 = z273 * z415 - z271 * z409;
    const Scalar z712 = z496 * z548 - z497 * z549 + n3_85 * z482 + n1_04 * z483 + z1 * z392 - n7 * z484 + z2 * z397;
    const Scalar z713 = z497 * z557 - n3_85 * z508 - n1_04 * z517 - n2_8467 * z513 - z496 * z553 + z1 * z394 + z2
        * z390;
    const Scalar z714 = z497 * z551 - z499 * z548 - n7 * z508 - n3_85 * z513 + z2 * z405;
    const Scalar z715 = z499 * z549 - z496 * z551 - n7 * z517 - n1_04 * z513 + z1 * z405;
    const Scalar z716 = z1 * z547;
    const Scalar z717 = z2 * z547;
    const Scalar z718 = z2 * z556 - z716;
    const Scalar z719 = z1 * z550 - z717;
    const Scalar z720 = z1 * z552 + z2 * z563;
    const Scalar z721 = z496 * z547 - z497 * z550 + k3 * z482 + k4 * z483 - z499 * z552 - n3_85 * z484 + z2 * z376;
    const Scalar z722 = z496 * z556 - z497 * z547 + k4 * z482 + k5 * z483 + z499 * z563 - n1_04 * z484 + z1 * z376;
    const Scalar z723 = z496 * z718 + z497 * z719 - z4 * z482 - z5 * z483 + z3 * z484 + z499 * z720;
    const Scalar z724 = z13 * z718 + z15 * z719 + z11 * z720;
    const Scalar z725 = z724 + z395 * z603 - z400 * z576;
    const Scalar z726 = z12 * z718 + z13 * z719 + z10 * z720;
    const Scalar z727 = c_steer * z720 - z10 * z718 - z11 * z719;
    const Scalar z728 = z726 + z400 * z577 - z396 * z603;
    const Scalar z729 = z395 * z577 - z727 - z396 * z576;
    const Scalar z730 = z12 * z714 + z10 * z712 + z13 * z715;
    const Scalar z731 = z407 * z485 - z301 * z395 - z402 * z486 - z399 * z487 + z287 * z396 + z265 * z725 + z266 * z728;
    const Scalar z732 = z729 + z402 * z512 + z407 * z507;
    const Scalar z733 = z13 * z714 + z11 * z712 + z15 * z715;
    const Scalar z734 = c_steer * z712 - z10 * z714 - z11 * z715;
    const Scalar z735 = s_pitch * z725 - c_pitch * z728;
    const Scalar z736 = s_pitch * z728 + c_pitch * z725;
    const Scalar z737 = z275 * z403 + z274 * z400 + z399 * z540 - z434 * z526 - z422 * z488 + z263 * z736 + z264 * z729;
    const Scalar z738 = z735 + z399 * z554 + z422 * z558;
    const Scalar z739 = s_roll * z729 - c_roll * z736;
    const Scalar z740 = c_roll * z682 + s_roll * z707;
    const Scalar z741 = s_roll * z682 - c_roll * z707;
    const Scalar z742 = s_yaw * z708 + c_yaw * z740;
    const Scalar z743 = s_yaw * z740 - c_yaw * z708;
    const Scalar z744 = z12 * z721 + z13 * z722 - z10 * z713;
    const Scalar z745 = n0_3 * z734 - z744;
    const Scalar z746 = z10 * z721 + z11 * z722 + c_steer * z713;
    const Scalar z747 = z13 * z721 + z15 * z722 - z11 * z713;
    const Scalar z748 = n0_3 * z730 - z746 + n1_1 * z733;
    const Scalar z749 = s_pitch * z617 - c_pitch * z618;
    const Scalar z750 = s_pitch * z618 + c_pitch * z617;
    const Scalar z751 = s_pitch * z691 - c_pitch * z692;
    const Scalar z752 = s_pitch * z692 + c_pitch * z691;
    const Scalar z753 = s_roll * z663 - c_roll * z751;
    const Scalar z754 = n0_12 * z540 + z263 * z750;
    const Scalar z755 = c_roll * z750;
    const Scalar z756 = s_pitch * z660 + c_pitch * z662;
    const Scalar z757 = s_pitch * z662 - c_pitch * z660;
    const Scalar z758 = n1_1 * z734 - z747;
    const Scalar z759 = s_roll * z648 + c_roll * z756;
    const Scalar z760 = z1 * z548 + z2 * z549 - n3_85 * z528 - n1_04 * z536;
    const Scalar z761 = z716 - k3 * z528 - k4 * z536 + z2 * z550;
    const Scalar z762 = z717 - k4 * z528 - k5 * z536 + z1 * z556;
    const Scalar z763 = z1 * z553 + z2 * z557 - n2_8467 * z530;
    const Scalar z764 = z2 * z551 - n3_85 * z530;
    const Scalar z765 = z1 * z551 - n1_04 * z530;
    const Scalar z766 = z12 * z764 - z10 * z760 + z13 * z765;
    const Scalar z767 = z13 * z764 - z11 * z760 + z15 * z765;
    const Scalar z768 = z10 * z764 + z11 * z765 + c_steer * z760;
    const Scalar z769 = s_pitch * z730 + c_pitch * z733;
    const Scalar z770 = s_pitch * z733 - c_pitch * z730;
    const Scalar z771 = z12 * z761 + z13 * z762 + z10 * z763;
    const Scalar z772 = n0_3 * z768 - z771;
    const Scalar z773 = s_roll * z769 - c_roll * z734;
    const Scalar z774 = s_roll * z734 + c_roll * z769;
    const Scalar z775 = z13 * z761 + z15 * z762 + z11 * z763;
    const Scalar z776 = c_steer * z763 - z10 * z761 - z11 * z762;
    const Scalar z777 = n0_3 * z766 - z776 + n1_1 * z767;
    const Scalar z778 = s_yaw * z770 - c_yaw * z773;
    const Scalar z779 = c_yaw * z770 + s_yaw * z773;
    const Scalar z780 = s_pitch * z745 + c_pitch * z758;
    const Scalar z781 = s_pitch * z758 - c_pitch * z745;
    const Scalar z782 = s_roll * z748 - c_roll * z780;
    const Scalar z783 = n0_12 * z554 + z749;
    const Scalar z784 = z496 * z545 - z497 * z546 + n0_28 * z513;
    const Scalar z785 = n1_1 * z768 - z775;
    const Scalar z786 = c_yaw * z66;
    const Scalar z787 = s_yaw * z66;
    const Scalar z788 = n0_35 * z162 / (z96 * z96);
    const Scalar z789 = z786 - z106 * z138 + z83 * z788;
    const Scalar z790 = z98 / (z58 * z58);
    const Scalar z791 = z787 - z106 * z134 + z80 * z788;
    const Scalar z792 = z68 - z83 * z106;
    const Scalar z793 = z203 - z792;
    const Scalar z794 = z68 - z792;
    const Scalar z795 = z25 * z790 - z72 * z30;
    const Scalar z796 = z71 - z80 * z106;
    const Scalar z797 = z205 - z796;
    const Scalar z798 = z197 * z793 - z240;
    const Scalar z799 = z71 - z796;
    const Scalar z800 = z53 * z794 - z235;
    const Scalar z801 = z197 * z797 - z239;
    const Scalar z802 = z53 * z799 - z246;
    const Scalar z803 = s_roll * z792 + z21 * z183;
    const Scalar z804 = z26 * z72;
    const Scalar z805 = s_roll * z796 + z19 * z183;
    const Scalar z806 = z26 * z790 - z72 * z31;
    const Scalar z807 = z25 * z72;
    const Scalar z808 = s_roll * z804 - z21 * z179;
    const Scalar z809 = s_roll * z807 - z19 * z179;
    const Scalar z810 = z10 * z545 - z11 * z546;
    const Scalar z811 = z810 + z404 * z512 + z408 * z507;
    const Scalar z812 = z12 * z545 - z13 * z546;
    const Scalar z813 = s_pitch * z766 + c_pitch * z767;
    const Scalar z814 = s_pitch * z767 - c_pitch * z766;
    const Scalar z815 = n2 * (c_roll * z22 + z25);
    const Scalar z816 = n2 * (c_roll * z24 + z26);
    const Scalar z817 = z13 * z545 - z15 * z546;
    const Scalar z818 = z410 * z487 - z404 * z486 + z408 * z485 + z265 * z817 + z266 * z812;
    const Scalar z819 = z1 * z545;
    const Scalar z820 = z819 + z2 * z546 - n0_28 * z530;
    const Scalar z821 = z2 * z546 + z819;
    const Scalar z822 = l_lambda_rear_rolls_x * z809;
    const Scalar z823 = c_roll * z768 + s_roll * z813;
    const Scalar z824 = s_roll * z768 - c_roll * z813;
    const Scalar z825 = s_pitch * z812 + c_pitch * z817;
    const Scalar z826 = z264 * z810 - z410 * z540 - z457 * z526 - z416 * z488 + z263 * z825;
    const Scalar z827 = s_pitch * z817 - c_pitch * z812;
    const Scalar z828 = z410 * z554 - z827 - z416 * z558;
    const Scalar z829 = s_roll * z810 - c_roll * z825;
    const Scalar z830 = s_yaw * z814 - c_yaw * z823;
    const Scalar z831 = c_yaw * z814 + s_yaw * z823;
    const Scalar z832 = s_pitch * z772 + c_pitch * z785;
    const Scalar z833 = s_pitch * z785 - c_pitch * z772;
    const Scalar z834 = c_roll * z832 + s_roll * z777;
    const Scalar z835 = n2 * (z56 * z56 - z53 * z53);
    const Scalar z836 = s_yaw * z124;
    const Scalar z837 = z53 * z836 + z125 * z124 + z56 * z126 + z61 * z122;
    const Scalar z838 = c_yaw * z124;
    const Scalar z839 = s_roll * z63;
    const Scalar z840 = s_yaw * z56;
    const Scalar z841 = n2 * z56;
    const Scalar z842 = z125 * z841 + z53 * (z61 + z840);
    const Scalar z843 = c_yaw * z56;
    const Scalar z844 = z132 * z841 + z53 * (z78 + z843);
    const Scalar z845 = z65 - z106 * z144 - z82 * z788;
    const Scalar z846 = s_yaw * z845;
    const Scalar z847 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z848 = n2 * (z25 * z815 + z26 * z816 - z20 * z847 - z30 * z30 - z31 * z31 - z32 * z32);
    const Scalar z849 = n2 * (z82 * z835 - z144 * z144 - z134 * z134 - z138 * z138 + z80 * z842 + z83 * z844);
    const Scalar z850 = n0_5 * (z149 * z162 / (z96 * z96) + z849 / z96);
    const Scalar z851 = c_yaw * z845;
    const Scalar z852 = z20 * z790 - z72 * z32;
    const Scalar z853 = c_yaw * z852;
    const Scalar z854 = s_yaw * z852;
    const Scalar z855 = l_lambda_rear_rolls_x * z217 - l_lambda_rear_rolls_y * z212 + l_lambda_front_rolls_x * z198
        - l_lambda_front_rolls_y * z186;
    const Scalar z856 = z616 - z855;
    const Scalar z857 = n0_5 * (z50 * z75 / (z58 * z58) + z848 / z58);
    const Scalar z858 = l_lambda_front_rolls_x * z805 - z822 - l_lambda_rear_rolls_y * z808 + l_lambda_front_rolls_y
        * z803;
    const Scalar z859 = z651 - z858;
    const Scalar z860 = l_lambda_rear_rolls_y * z808 + z822;
    const Scalar z861 = l_lambda_front_rolls_x * z801 + l_lambda_front_rolls_y * z798;
    const Scalar z862 = z711 - z861;
    const Scalar z863 = z66 - n0_35 * z850;
    const Scalar z864 = l_lambda_rear_rolls_x * z806 - l_lambda_rear_rolls_y * z795 - l_lambda_front_rolls_x * z789
        + l_lambda_front_rolls_y * z791;
    const Scalar z865 = z704 + z864;
    const Scalar z866 = l_lambda_front_rolls_x * z802 + l_lambda_front_rolls_y * z800;
    const Scalar z867 = n0_3 * z857;
    const Scalar z868 = l_lambda_rear_rolls_x * z807 + l_lambda_rear_rolls_y * z804 - l_lambda_front_rolls_x * z796
        - l_lambda_front_rolls_y * z792;
    const Scalar z869 = z706 + z868;
    const Scalar z870 = z53 * z838 + z56 * z123 + z132 * z124 + z78 * z122;
    const Scalar z871 = z193 - z845;
    const Scalar z872 = z786 - z789;
    const Scalar z873 = z65 - z845;
    const Scalar z874 = z787 - z791;
    const Scalar z875 = n2 * (z56 * z124 - z53 * z122);
    const Scalar z876 = n2 * (z82 * z875 - z144 * z131 + z134 * z142 + z138 * z135 + z80 * z837 + z83 * z870);
    const Scalar z877 = c_yaw * z128;
    const Scalar z878 = z53 * z877 + z132 * z128 + z56 * z130 - z78 * z127;
    const Scalar z879 = n2 * (z53 * z127 + z56 * z128);
    const Scalar z880 = s_roll * z164 - c_roll * z165;
    const Scalar z881 = s_yaw * z128;
    const Scalar z882 = z56 * z129 - z53 * z881 + z61 * z127 - z125 * z128;
    const Scalar z883 = n0_35 * z161 / (z96 * z96);
    const Scalar z884 = s_yaw * z62 - c_yaw * z839;
    const Scalar z885 = s_yaw * z839 + c_yaw * z62;
    const Scalar z886 = c_yaw * z197;
    const Scalar z887 = c_yaw * z204;
    const Scalar z888 = z789 - z887;
    const Scalar z889 = s_yaw * z197;
    const Scalar z890 = z83 * z883 - z884 - z106 * z135;
    const Scalar z891 = n2 * (z144 * z146 - z82 * z879 + z134 * z136 - z138 * z141 - z83 * z878 + z80 * z882);
    const Scalar z892 = z166 - z106 * z131 + z82 * z883;
    const Scalar z893 = s_yaw * z204;
    const Scalar z894 = z791 - z893;
    const Scalar z895 = z885 - z106 * z142 + z80 * z883;
    const Scalar z896 = s_yaw * z892;
    const Scalar z897 = c_yaw * z892;
    const Scalar z898 = z196 * z233 - z231 * z886 - z197 * z888 + z199 * z871;
    const Scalar z899 = c_roll * z181 - z22 * z183 + s_roll * z791 - z19 * z845;
    const Scalar z900 = z56 * z232 + z132 * z230 + z53 * z872 - z78 * z873;
    const Scalar z901 = z22 * z179 - c_roll * z178 + s_roll * z795 + z19 * z852;
    const Scalar z902 = z196 * z237 + z231 * z889 + z197 * z894 - z200 * z871;
    const Scalar z903 = s_roll * z789 - c_roll * z182 - z21 * z845 - z24 * z183;
    const Scalar z904 = z56 * z234 - z125 * z230 - z53 * z874 + z61 * z873;
    const Scalar z905 = c_roll * z180 + z24 * z179 + s_roll * z806 + z21 * z852;
    const Scalar z906 = n0_5 * (z149 * z161 / (z96 * z96) - z876 / z96);
    const Scalar z907 = n0_5 * (z162 * z148 / (z96 * z96) - z876 / z96);
    const Scalar z908 = z839 - n0_35 * z906;
    const Scalar z909 = z839 - n0_35 * z907;
    const Scalar z910 = n0_5 * (z162 * z150 / (z96 * z96) - z891 / z96);
    const Scalar z911 = z880 + n0_35 * z910;
    const Scalar z912 = l_lambda_rear_rolls_x * z905;
    const Scalar z913 = l_lambda_front_rolls_x * z900 + l_lambda_front_rolls_y * z904;
    const Scalar z914 = z826 - z913;
    const Scalar z915 = l_lambda_rear_rolls_y * z901 - z912;
    const Scalar z916 = l_lambda_rear_rolls_y * z901 - z912 + l_lambda_front_touches * z909 - l_lambda_front_rolls_y
        * z899 + l_lambda_front_rolls_x * z903;
    const Scalar z917 = z754 - z915;
    const Scalar z918 = l_lambda_front_touches * z911 + l_lambda_front_rolls_x * z898 + l_lambda_front_rolls_y * z902;
    const Scalar z919 = l_lambda_front_rolls_x * z890 - l_lambda_front_rolls_y * z895;
    const Scalar z920 = z759 + z919;
    const Scalar z921 = l_lambda_rear_touches * z867 + l_lambda_rear_rolls_x * z854 + l_lambda_rear_rolls_y * z853
        + l_lambda_front_rolls_x * z846 + l_lambda_front_rolls_y * z851 - l_lambda_front_touches * z863;
    const Scalar z922 = z737 + z918;
    const Scalar z923 = z696 - z916;
    const Scalar z924 = z668 - z921;
    const Scalar z925 = s_yaw * z52 + z54;
    const Scalar z926 = c_yaw * z52 - z73;
    const Scalar z927 = z166 - z892;
    const Scalar z928 = z885 - z895;
    const Scalar z929 = z884 + z890;
    const Scalar z930 = n0_5 * (z149 * z163 / (z96 * z96) - z891 / z96);
    const Scalar z931 = z880 + n0_35 * z930;
    const Scalar z932 = c_roll * z41;
    const Scalar z933 = c_roll * z121;
    const Scalar z934 = s_roll * z121;
    const Scalar z935 = n2 * (z53 * z932 - z124 * z124);
    const Scalar z936 = s_pitch * z156 - c_pitch * z154;
    const Scalar z937 = s_yaw * z120 + c_yaw * z934;
    const Scalar z938 = s_yaw * z934 - c_yaw * z120;
    const Scalar z939 = z53 * z937 - z123 * z128 - z124 * z130 - z78 * z933;
    const Scalar z940 = z124 * z129 + z53 * z938 - z126 * z128 - z61 * z933;
    const Scalar z941 = n2 * (z53 * z933 - z124 * z128);
    const Scalar z942 = n2 * z124;
    const Scalar z943 = z53 * z925 - z126 * z942 - z61 * z932;
    const Scalar z944 = z53 * z926 - z123 * z942 - z78 * z932;
    const Scalar z945 = n2 * (z131 * z146 + z82 * z941 + z135 * z141 - z142 * z136 + z83 * z939 + z80 * z940);
    const Scalar z946 = n2 * (z131 * z131 + z82 * z935 + z135 * z135 + z142 * z142 + z80 * z943 + z83 * z944);
    const Scalar z947 = s_yaw * z936 - c_yaw * z880;
    const Scalar z948 = s_roll * z195;
    const Scalar z949 = n0_5 * (z148 * z161 / (z96 * z96) - z946 / z96);
    const Scalar z950 = c_yaw * z936 + s_yaw * z880;
    const Scalar z951 = n0_35 * z163 / (z96 * z96);
    const Scalar z952 = c_roll * z195;
    const Scalar z953 = s_roll * z191;
    const Scalar z954 = c_yaw * z194 + s_yaw * z948;
    const Scalar z955 = s_yaw * z194 - c_yaw * z948;
    const Scalar z956 = c_roll * z191;
    const Scalar z957 = z892 - z956;
    const Scalar z958 = z947 + z106 * z141 + z83 * z951;
    const Scalar z959 = c_yaw * z192 + s_yaw * z953;
    const Scalar z960 = z895 - z959;
    const Scalar z961 = z80 * z951 - z950 - z106 * z136;
    const Scalar z962 = s_yaw * z192 - c_yaw * z953;
    const Scalar z963 = z890 + z962;
    const Scalar z964 = z21 * z892 + s_roll * z890;
    const Scalar z965 = s_roll * z895 + z19 * z892;
    const Scalar z966 = z233 * z952 - z231 * z955 - z199 * z957 + z197 * z963;
    const Scalar z967 = z231 * z954 - z237 * z952 + z197 * z960 - z200 * z957;
    const Scalar z968 = z124 * z232 + z123 * z230 - z78 * z927 + z53 * z929;
    const Scalar z969 = z124 * z234 - z126 * z230 + z53 * z928 + z61 * z927;
    const Scalar z970 = c_roll * z62;
    const Scalar z971 = z970 - n0_35 * z949;
    const Scalar z972 = c_roll * z936;
    const Scalar z973 = n0_5 * (z161 * z150 / (z96 * z96) + z945 / z96);
    const Scalar z974 = z972 + n0_35 * z973;
    const Scalar z975 = l_lambda_front_rolls_x * z968 + l_lambda_front_rolls_y * z969;
    const Scalar z976 = z818 - z975;
    const Scalar z977 = l_lambda_front_touches * z971 - l_lambda_front_rolls_y * z965 + l_lambda_front_rolls_x * z964;
    const Scalar z978 = l_lambda_front_rolls_x * z966 - l_lambda_front_rolls_y * z967 - l_lambda_front_touches * z974;
    const Scalar z979 = z731 + z978;
    const Scalar z980 = l_lambda_front_rolls_x * z958 - l_lambda_front_rolls_y * z961;
    const Scalar z981 = z782 - z980;
    const Scalar z982 = z648 + z977;
    const Scalar z983 = l_lambda_front_rolls_x * z896 + l_lambda_front_rolls_y * z897 + l_lambda_front_touches * z908;
    const Scalar z984 = z757 + z983;
    const Scalar z985 = z268 + z432;
    const Scalar z986 = z947 - z958;
    const Scalar z987 = z950 + z961;
    const Scalar z988 = z349 * z364;
    const Scalar z989 = z345 * z364;
    const Scalar z990 = n0_28 * z988;  // moment on front_wheel, z
    const Scalar z991 = n0_5 * (z148 * z163 / (z96 * z96) + z945 / z96);
    const Scalar z992 = k20 * z385 + z990 + k5 * z355 + n1_04 * z358 - k4 * z393;  // moment on fork, z
    const Scalar z993 = z972 + n0_35 * z991;
    const Scalar z994 = n0_28 * z989;  // moment on front_wheel, x
    const Scalar z995 = n3_85 * z358 - z994 - k18 * z387 - k3 * z344 + k4 * z386;  // moment on fork, x
    const Scalar z996 = z265 * z329;
    const Scalar z997 = z266 * z329;
    const Scalar z998 = n0_12 * z996;  // moment on rear_wheel, z
    const Scalar z999 = n0_12 * z997;  // moment on rear_wheel, x
    const Scalar z1000 = a_z - a_roll * z98 - z117;
    const Scalar z1001 = a_z + a_roll * z177 - a_pitch * z175 - a_steer * z190 + z244;
    const Scalar z1002 = n2 * (z128 * z130 + z53 * z78);
    const Scalar z1003 = n2 * (z53 * z53 - z128 * z128);
    const Scalar z1004 = z106 * z146 - z167 + z82 * z951;
    const Scalar z1005 = z167 + z1004;
    const Scalar z1006 = z15 * z992 + z13 * z995 + z11 * z376;
    const Scalar z1007 = z13 * z992 + z12 * z995 + z10 * z376;
    const Scalar z1008 = z11 * z992 - z414 + z10 * z995;
    // moment on frame, y
    const Scalar z1009 = z361 + n49_25 * z300 + n29_35 * z317 + n17_7 * z391 - n25_5 * z301 + n51 * z287 - n0_3 * z411
        - n1_1 * z419 - z1008;
    const Scalar z1010 = n25_5 * z275 - z998 - n9_95 * z318 + n17_7 * z323 + n1_1 * z417 - z1006;  // moment on frame, z
    const Scalar z1011 = n51 * z275 + z999 - n17_7 * z318 + n39_3 * z323 - n0_3 * z417 + z1007;  // moment on frame, x
    const Scalar z1012 = z1 * z995 - z2 * z992;
    const Scalar z1013 = a_x + a_yaw * z182 - a_roll * z186 + a_pitch * z210 + a_steer * z241 + a_front * z238 + z342;
    const Scalar z1014 = s_yaw * z1004;
    const Scalar z1015 = a_y - z209 * (a_pitch + a_rear) - a_yaw * z178 + a_roll * z217 - z260;
    const Scalar z1016 = c_yaw * z1004;
    const Scalar z1017 = a_y - a_yaw * z181 + a_roll * z198 - a_pitch * z208 - a_steer * z242 - a_front * z247 - z360;
    const Scalar z1018 = s_roll * z958 + z21 * z1004;
    const Scalar z1019 = z19 * z1004 + s_roll * z961;
    const Scalar z1020 = n2 * (z53 * z61 - z128 * z129);
    const Scalar z1021 = n2 * (z83 * z1002 - z146 * z146 - z82 * z1003 - z136 * z136 - z141 * z141 + z80 * z1020);
    const Scalar z1022 = z197 * z958 - z199 * z1004;
    const Scalar z1023 = n0_5 * (z150 * z163 / (z96 * z96) + z1021 / z96);
    const Scalar z1024 = z197 * z961 - z200 * z1004;
    const Scalar z1025 = z128 * z232 + z130 * z230 + z53 * z986 - z78 * z1005;
    const Scalar z1026 = c_steer * z8;
    const Scalar z1027 = z128 * z234 + z129 * z230 + z61 * z1005 + z53 * z987;
    const Scalar z1028 = c_steer * (n1 - z7);
    const Scalar z1029 = n0_08 * z1028 - n0_35 * z1026;
    const Scalar z1030 = c_steer * (n1 - z9);
    const Scalar z1031 = n0_08 * z1026 - n0_35 * z1030;
    const Scalar z1032 = l_lambda_front_rolls_x * z1025 + l_lambda_front_rolls_y * z1027;
    const Scalar z1033 = z784 + z1032;
    const Scalar z1034 = s_pitch * z1010 + c_pitch * z1011;
    const Scalar z1035 = c_pitch * z1031 + s_pitch * z1029;
    const Scalar z1036 = n0_5603 * (a_roll + z465) - z1034;  // moment on frame.2, x
    const Scalar z1037 = s_pitch * z1011 - c_pitch * z1010;
    const Scalar z1038 = z1037 - n0_5603 * z985;  // moment on frame.2, z
    const Scalar z1039 = l_lambda_front_rolls_x * z1018 - l_lambda_front_rolls_y * z1019 - l_lambda_front_touches
        * z993;
    const Scalar z1040 = c_roll * z1035 - z51;
    const Scalar z1041 = z748 - z1039;
    const Scalar z1042 = s_roll * z1009 + c_roll * z1038;
    const Scalar z1043 = z1040 + n0_35 * z1023;
    const Scalar z1044 = l_lambda_front_rolls_x * z1014 + l_lambda_front_rolls_y * z1016 - l_lambda_front_touches
        * z931;
    const Scalar z1045 = z781 + z1044;
    const Scalar z1046 = z26 * z207 - z216;
    const Scalar z1047 = z17 * z804 + z28 * z179 + s_roll * z1046 - z228;
    const Scalar z1048 = z215 * (a_pitch + a_rear) + a_x + a_yaw * z180 - a_roll * z212 + z261;
    const Scalar z1049 = v_yaw * z1046 - v_roll * z227 + z1047 * (v_pitch + v_rear);
    const Scalar z1050 = v_yaw * z792;
    const Scalar z1051 = v_yaw * z796;
    const Scalar z1052 = z808 * (a_pitch + a_rear) + a_yaw * z804 - a_roll * z212 + z1049;
    const Scalar z1053 = v_yaw * z804;
    const Scalar z1054 = v_roll * z212 - z1053 - z808 * (v_pitch + v_rear);
    const Scalar z1055 = v_roll * z212 - z1053 - z808 * (v_pitch + v_rear) + z214;
    const Scalar z1056 = z1050 + v_roll * z186 + v_pitch * z803 + v_steer * z798 - v_front * z800;
    const Scalar z1057 = z1050 + v_roll * z186 + v_pitch * z803 + v_steer * z798 - v_front * z800 + z305;
    const Scalar z1058 = v_roll * z198 - z1051 - v_pitch * z805 - v_steer * z801 + v_front * z802;
    const Scalar z1059 = v_roll * z198 - z1051 - v_pitch * z805 - v_steer * z801 + v_front * z802 - z295;
    const Scalar z1060 = z283 - z106 * z109 + z80 * z252;
    const Scalar z1061 = z309 - z17 * z796 + s_roll * z1060 - z19 * z258;
    const Scalar z1062 = z302 + z1060;
    const Scalar z1063 = z257 * z797 - z311 + z197 * z1062 - z200 * z304;
    const Scalar z1064 = z283 - z1060;
    const Scalar z1065 = z104 * z799 - z312 + z53 * z1064 + z61 * z262;
    const Scalar z1066 = z256 + z106 * z107 + z83 * z252;
    const Scalar z1067 = l_lambda_front_rolls_x * z1022 - l_lambda_front_touches * z1043 - l_lambda_front_rolls_y
        * z1024;
    const Scalar z1068 = z723 + z1067;
    const Scalar z1069 = v_yaw * z1060 + v_pitch * z1061 + v_roll * z314 - v_steer * z1063 - v_front * z1065;
    const Scalar z1070 = z290 + z1066;
    const Scalar z1071 = z257 * z793 + z310 + z197 * z1070 - z199 * z304;
    const Scalar z1072 = z254 - z17 * z792 + s_roll * z1066 - z21 * z258;
    const Scalar z1073 = a_yaw * z796 - a_roll * z198 + a_pitch * z805 + a_steer * z801 - a_front * z802 - z1069;
    const Scalar z1074 = c_steer * z35 + z37 * z41 + n2 * (s_roll * z100 + z99);
    const Scalar z1075 = n2 * (s_roll * z110 + z248) - z35 * z39 - z37 * z62;
    const Scalar z1076 = z256 - z1066;
    const Scalar z1077 = z104 * z794 + z313 + z53 * z1076 + z78 * z262;
    const Scalar z1078 = z25 * z207 - z189;
    const Scalar z1079 = z17 * z807 + z27 * z179 + s_roll * z1078 - z225;
    const Scalar z1080 = c_yaw * z17 - s_roll * z18;
    const Scalar z1081 = v_yaw * z1066 - v_roll * z259 + v_pitch * z1072 - v_steer * z1071 - v_front * z1077;
    const Scalar z1082 = a_yaw * z792 + a_roll * z186 + a_pitch * z803 + a_steer * z798 - a_front * z800 - z1081;
    const Scalar z1083 = v_yaw * z1078 + z1079 * (v_pitch + v_rear) + v_roll * z224;
    const Scalar z1084 = z809 * (a_pitch + a_rear) + a_yaw * z807 + a_roll * z217 + z1083;
    const Scalar z1085 = v_yaw * z807;
    const Scalar z1086 = z36 * z62 - z33 * z39 - c_roll * z158 + n2 * (z17 * z110 - z14 * z97) + s_roll * z221;
    const Scalar z1087 = c_roll * z28;
    const Scalar z1088 = z104 * z125;
    const Scalar z1089 = z21 * z14 + z17 * z24 + s_roll * z1080 + z1087;
    const Scalar z1090 = z48 * z30;
    const Scalar z1091 = c_roll * z17;
    const Scalar z1092 = s_yaw * z104 - z16 * z53;
    const Scalar z1093 = z104 * z132;
    const Scalar z1094 = n2 * (z56 * z104 + z53 * z102);
    const Scalar z1095 = z145 * z144;
    const Scalar z1096 = z17 * z22;
    const Scalar z1097 = z18 * z53 + c_yaw * z104;
    const Scalar z1098 = s_yaw * z17 + s_roll * z16;
    const Scalar z1099 = n2 * (s_roll * z14 - z1091);
    const Scalar z1100 = z23 * z35 - n4 * z1091;
    const Scalar z1101 = z61 * z102 - z1088 - z53 * z1092 + z56 * z108;
    const Scalar z1102 = z1093 - z78 * z102 + z53 * z1097 + z56 * z105;
    const Scalar z1103 = z19 * z14 + z1096 + s_roll * z1098 + c_roll * z27;
    const Scalar z1104 = n2 * (z26 * z1089 - z1090 - z29 * z32 - z20 * z1099 - z49 * z31 + z25 * z1103);
    const Scalar z1105 = z59 * z75;
    const Scalar z1106 = n2 * (z1095 - z82 * z1094 - z107 * z138 + z80 * z1101 - z83 * z1102 + z109 * z134);
    const Scalar z1107 = z160 * z162;
    const Scalar z1108 = z35 * z41 - c_steer * z37 + n2 * (s_roll * z88 - c_roll * z100);
    const Scalar z1109 = n4 * z17 * z14 + n2 * (s_roll * z33 + c_roll * z36);
    const Scalar z1110 = s_yaw * z1108 - z16 * z103;
    const Scalar z1111 = z18 * z103 + c_yaw * z1108;
    const Scalar z1112 = z53 * z1111 - z78 * z1074 + n2 * (z56 * z105 + z1093);
    const Scalar z1113 = z61 * z1074 - z53 * z1110 + n2 * (z56 * z108 - z1088);
    const Scalar z1114 = n4 * z56 * z104 + z103 * z1074;
    const Scalar z1115 = s_yaw * z36 + s_roll * z34 - z16 * z37;
    const Scalar z1116 = n4 * (z1095 - z107 * z138 + z109 * z134) + n2 * (z80 * z1113 - z83 * z1112 - z82 * z1114);
    const Scalar z1117 = z22 * z36 - z19 * z33 - n2 * (z17 * z1098 - z14 * z27) + s_roll * z1115 - c_roll * z43;
    const Scalar z1118 = n0_5 * (z1107 / (z96 * z96) - z1116 / z96 + z169 * z149 / (z96 * z96));
    const Scalar z1119 = n0_5 * (z1107 / (z96 * z96) - z1106 / z96);
    const Scalar z1120 = n0_5 * (z1105 / (z58 * z58) + z1104 / z58);
    const Scalar z1121 = z16 * z23 + s_yaw * z37;
    const Scalar z1122 = z19 * z35 + s_roll * z1121 + n2 * (c_roll * z27 + z1096);
    const Scalar z1123 = c_yaw * z37 - z18 * z23;
    const Scalar z1124 = z21 * z35 + s_roll * z1123 + n2 * (z17 * z24 + z1087);
    const Scalar z1125 = c_yaw * z36 + s_roll * z38 + z18 * z37;
    const Scalar z1126 = z24 * z36 - z21 * z33 - n2 * (z17 * z1080 - z14 * z28) + s_roll * z1125 - c_roll * z44;
    const Scalar z1127 = n2 * (z25 * z1122 + z26 * z1124 - z20 * z1100) - n4 * (z1090 + z29 * z32 + z49 * z31);
    const Scalar z1128 = n4 * (z49 * z1089 - z29 * z1099 + z48 * z1103) + n2 * (z20 * z1109 - z32 * z45 + z30 * z60
        + z31 * z64 + z25 * z1117 + z26 * z1126);
    const Scalar z1129 = n0_5 * (z76 * z1104 / (z58 * z58) + z75 * z67 / (z58 * z58) - z1128 / z58 + z59 * z1120 / (z58
        * z58)) + z76 * z1105 / (z58 * z58 * z58);
    const Scalar z1130 = n0_5 * (z76 * z50 / (z58 * z58) + z1105 / (z58 * z58) + z1127 / z58);
    const Scalar z1131 = z1075 - n0_35 * z1118;
    const Scalar z1132 = n0_3 * z1120;
    const Scalar z1133 = n0_3 * z1130;
    const Scalar z1134 = z250 - n0_35 * z1119;
    const Scalar z1135 = z1085 + v_roll * z217 + z809 * (v_pitch + v_rear);
    const Scalar z1136 = z1085 + v_roll * z217 + z809 * (v_pitch + v_rear) - z222;
    const Scalar z1137 = n0_6 * z76 * z75 / (z58 * z58 * z58) + z1132 / (z58 * z58);
    const Scalar z1138 = n0_3 * z1129;
    const Scalar z1139 = a_roll * z867 + z1138;
    const Scalar z1140 = n4 * z104;
    const Scalar z1141 = n2 * (z56 * z170 - z53 * z159) - z102 * z1140;
    const Scalar z1142 = z72 * z1099 - z29 * z790 - z32 * z207 + z20 * z1137;
    const Scalar z1143 = z25 * z1137 - z72 * z1103 - z48 * z790 - z30 * z207;
    const Scalar z1144 = z26 * z1137 - z72 * z1089 - z49 * z790 - z31 * z207;
    const Scalar z1145 = z38 * z53 - z18 * z171 + c_yaw * z170;
    const Scalar z1146 = z34 * z53 + z16 * z171 + s_yaw * z170;
    const Scalar z1147 = n2 * (z104 * z1097 + z102 * z105) - z78 * z159 - z132 * z170 + z56 * z172 - z53 * z1145;
    const Scalar z1148 = z61 * z159 + z125 * z170 - n2 * (z104 * z1092 - z102 * z108) + z56 * z168 + z53 * z1146;
    const Scalar z1149 = n4 * (z145 * z1094 + z109 * z1101 + z107 * z1102) + n2 * (z82 * z1141 - z144 * z173 - z138
        * z174 + z134 * z176 - z83 * z1147 + z80 * z1148);
    const Scalar z1150 = n0_5 * (z1149 / z96 - z162 * z185 / (z96 * z96) - z169 * z1106 / (z96 * z96) + z160 * z1119
        / (z96 * z96)) + z162 * z211 / (z96 * z96 * z96);
    const Scalar z1151 = z14 * z178 + z179 * z1098 - c_roll * z214 + z17 * z795 - z27 * z852 + z22 * z220 + z19 * z1142
        + s_roll * z1143;
    const Scalar z1152 = z179 * z1080 - z14 * z180 + c_roll * z222 + z17 * z806 - z28 * z852 + z24 * z220 + z21 * z1142
        + s_roll * z1144;
    const Scalar z1153 = z18 * z41;
    const Scalar z1154 = c_roll * z101 - z14 * z40;
    const Scalar z1155 = z1086 - n0_35 * z1150;
    const Scalar z1156 = z17 * z40 + s_roll * z101;
    const Scalar z1157 = z16 * z122 + z1153 - c_yaw * z100 + s_yaw * z1156;
    const Scalar z1158 = a_roll * z863 + a_pitch * z909 + a_steer * z911 - z1155;
    const Scalar z1159 = z16 * z41 - z18 * z122 + s_yaw * z100 + c_yaw * z1156;
    const Scalar z1160 = z53 * z1157 - z61 * z1154 - z104 * z126 + z108 * z124;
    const Scalar z1161 = n0_7 * z169;
    const Scalar z1162 = z162 * z1161 / (z96 * z96 * z96) + n0_35 * z1119 / (z96 * z96);
    const Scalar z1163 = v_roll * z846;
    const Scalar z1164 = v_yaw * z789 - z1163 + z259 + v_steer * z898 - v_front * z900 + v_pitch * z903;
    const Scalar z1165 = v_yaw * z789 - z1163 + v_steer * z898 - v_front * z900 + v_pitch * z903;
    const Scalar z1166 = z104 * z123;
    const Scalar z1167 = z107 * z135;
    const Scalar z1168 = n2 * (z53 * z1154 - z104 * z124);
    const Scalar z1169 = z53 * z1159 - z1166 - z78 * z1154 - z105 * z124;
    const Scalar z1170 = z250 - z106 * z1094 + z145 * z788 + z144 * z252 + z82 * z1162;
    const Scalar z1171 = z288 + z1170;
    const Scalar z1172 = z250 - z1170;
    const Scalar z1173 = v_yaw * z791;
    const Scalar z1174 = v_roll * z851 + z1173 + v_pitch * z899 - v_steer * z902 + v_front * z904 - z314;
    const Scalar z1175 = v_roll * z851 + z1173 + v_pitch * z899 - v_steer * z902 + v_front * z904;
    const Scalar z1176 = n2 * (z1167 + z145 * z131 + z82 * z1168 - z109 * z142 + z83 * z1169 + z80 * z1160);
    const Scalar z1177 = z14 * z63 + c_roll * z249;
    const Scalar z1178 = v_yaw * z795;
    const Scalar z1179 = v_roll * z853 - z1178 - z224 - z901 * (v_pitch + v_rear);
    const Scalar z1180 = v_roll * z853 - z1178 - z901 * (v_pitch + v_rear);
    const Scalar z1181 = c_yaw * z257 - z18 * z197;
    const Scalar z1182 = c_yaw * z114 - z18 * z66;
    const Scalar z1183 = z16 * z66 + s_yaw * z114;
    const Scalar z1184 = z1182 - z106 * z1102 + z107 * z788 - z138 * z252 + z83 * z1162;
    const Scalar z1185 = z1183 + z106 * z1101 - z109 * z788 - z134 * z252 + z80 * z1162;
    const Scalar z1186 = z160 * z161;
    const Scalar z1187 = n0_5 * (z1186 / (z96 * z96) + z1176 / z96);
    const Scalar z1188 = z16 * z197 + s_yaw * z257;
    const Scalar z1189 = v_yaw * z806;
    const Scalar z1190 = v_roll * z854 + z1189 - z227 + z905 * (v_pitch + v_rear);
    const Scalar z1191 = z14 * z182 - z183 * z1080 + z17 * z789 + z28 * z845 - c_roll * z295 - z24 * z258 + s_roll
        * z1184 + z21 * z1170;
    const Scalar z1192 = z17 * z791 - z14 * z181 - z183 * z1098 + z27 * z845 + c_roll * z305 - z22 * z258 + s_roll
        * z1185 + z19 * z1170;
    const Scalar z1193 = v_roll * z854 + z1189 + z905 * (v_pitch + v_rear);
    const Scalar z1194 = z1182 - z1184;
    const Scalar z1195 = z56 * z286 - z102 * z232 - z230 * z1097 - z104 * z872 - z105 * z873 + z132 * z262 + z53 * z1194
        + z78 * z1172;
    const Scalar z1196 = z1183 - z1185;
    const Scalar z1197 = z230 * z1092 - z102 * z234 + z104 * z874 - z108 * z873 + z56 * z298 - z125 * z262 - z53 * z1196
        - z61 * z1172;
    const Scalar z1198 = z1177 + n0_35 * z1187;
    const Scalar z1199 = c_yaw * z292 - z18 * z204;
    const Scalar z1200 = z16 * z204 + s_yaw * z292;
    const Scalar z1201 = z1184 - z1199;
    const Scalar z1202 = z1185 - z1200;
    const Scalar z1203 = s_yaw * z1170 - z16 * z845;
    const Scalar z1204 = z231 * z1181 - z233 * z281 + z257 * z888 + z284 * z871 + z196 * z294 + z304 * z886 + z197
        * z1201 - z199 * z1171;
    const Scalar z1205 = z237 * z281 + z231 * z1188 + z257 * z894 - z306 * z871 + z196 * z308 + z304 * z889 + z197
        * z1202 - z200 * z1171;
    const Scalar z1206 = v_yaw * z1184 + v_roll * z1203 + v_pitch * z1191 - v_steer * z1204 - v_front * z1195;
    const Scalar z1207 = a_yaw * z789 - a_roll * z846 + a_pitch * z903 + a_steer * z898 - a_front * z900 + z1206;
    const Scalar z1208 = z55 * z133 + s_pitch * z202 + c_pitch * z188 + z57 * z137 + n2 * (z85 * z94 - z95 * z86);
    const Scalar z1209 = z18 * z845 + c_yaw * z1170;
    const Scalar z1210 = v_yaw * z1185 - v_roll * z1209 + v_pitch * z1192 - v_steer * z1205 + v_front * z1197;
    const Scalar z1211 = z33 * z63 - z35 * z249 + c_roll * z1208;
    const Scalar z1212 = n2 * z86;
    const Scalar z1213 = n2 * z85;
    const Scalar z1214 = z57 * z1212 - z55 * z1213 + n2 * (c_pitch * z95 + z245);
    const Scalar z1215 = z10 * z1212 + z11 * z1213 + n2 * (s_pitch * z90 - c_pitch * z89);
    const Scalar z1216 = z10 * z1213 - z11 * z1212 + n2 * (s_pitch * z89 + c_pitch * z90);
    const Scalar z1217 = a_yaw * z791 + a_roll * z851 + a_pitch * z899 - a_steer * z902 + a_front * z904 + z1210;
    const Scalar z1218 = z35 * z63 + c_roll * z1214;
    const Scalar z1219 = z37 * z40 + s_roll * z1215;
    const Scalar z1220 = n2 * (z16 * z122 + z1153) - c_yaw * z1216 + s_yaw * z1219;
    const Scalar z1221 = n2 * (z16 * z41 - z18 * z122) + s_yaw * z1216 + c_yaw * z1219;
    const Scalar z1222 = c_roll * z1215 - z35 * z40;
    const Scalar z1223 = z53 * z1221 - z78 * z1222 - n2 * (z105 * z124 + z1166);
    const Scalar z1224 = z53 * z1220 - z61 * z1222 - n2 * (z104 * z126 - z108 * z124);
    const Scalar z1225 = z103 * z1222 - z124 * z1140;
    const Scalar z1226 = c_yaw * z1142 - z18 * z852;
    const Scalar z1227 = n2 * (z82 * z1225 + z80 * z1224 + z83 * z1223) - n4 * (z109 * z142 - z1167 - z145 * z131);
    const Scalar z1228 = v_yaw * z1143 - v_roll * z1226 + z1151 * (v_pitch + v_rear);
    const Scalar z1229 = z901 * (a_pitch + a_rear) + a_yaw * z795 - a_roll * z853 + z1228;
    const Scalar z1230 = s_roll * z249 - z17 * z63;
    const Scalar z1231 = z16 * z852 + s_yaw * z1142;
    const Scalar z1232 = v_roll * z1231 + v_yaw * z1144 + z1152 * (v_pitch + v_rear);
    const Scalar z1233 = n0_5 * (z1227 / z96 + z1186 / (z96 * z96) + z169 * z148 / (z96 * z96));
    const Scalar z1234 = z33 * z40 + z35 * z101 + c_roll * z157;
    const Scalar z1235 = z36 * z40 - z37 * z101 + s_roll * z157;
    const Scalar z1236 = z905 * (a_pitch + a_rear) + a_yaw * z806 + a_roll * z854 + z1232;
    const Scalar z1237 = z2 * z88;
    const Scalar z1238 = z1 * z88;
    const Scalar z1239 = z8 * z87;
    const Scalar z1240 = -z87 * (n1 - z7);
    const Scalar z1241 = n0_35 * z1239 + n0_08 * z1240;
    const Scalar z1242 = z1140 * z1154 + n2 * (z53 * z1234 + z124 * z170);
    const Scalar z1243 = z1218 + n0_35 * z1233;
    const Scalar z1244 = z85 * z154;
    const Scalar z1245 = -z87 * (n1 - z9);
    const Scalar z1246 = n0_08 * z1239 + n0_35 * z1245;
    const Scalar z1247 = z34 * z41 + z38 * z122 - n2 * (z16 * z100 - z18 * z1156) + s_yaw * z151 + c_yaw * z1235;
    const Scalar z1248 = z34 * z122 - z38 * z41 - n2 * (z18 * z100 + z16 * z1156) - c_yaw * z151 + s_yaw * z1235;
    const Scalar z1249 = n2 * (z104 * z1159 + z105 * z1154) - z78 * z1234 + z123 * z170 + z53 * z1247 - z124 * z172;
    const Scalar z1250 = z126 * z170 - z61 * z1234 + n2 * (z104 * z1157 - z108 * z1154) + z53 * z1248 + z124 * z168;
    const Scalar z1251 = n4 * (z109 * z1160 - z107 * z1169 - z145 * z1168) + n2 * (z82 * z1242 - z131 * z173 + z135
        * z174 - z142 * z176 + z83 * z1249 + z80 * z1250);
    const Scalar z1252 = n0_5 * (z169 * z1176 / (z96 * z96) - z161 * z185 / (z96 * z96) - z1251 / z96 + z160 * z1187
        / (z96 * z96)) + z161 * z211 / (z96 * z96 * z96);
    const Scalar z1253 = z161 * z1161 / (z96 * z96 * z96) + n0_35 * z1187 / (z96 * z96);
    const Scalar z1254 = z145 * z883 - z1177 - z106 * z1168 - z131 * z252 + z82 * z1253;
    const Scalar z1255 = z1177 + z1254;
    const Scalar z1256 = z86 * z119;
    const Scalar z1257 = z85 * z119;
    const Scalar z1258 = z18 * z121;
    const Scalar z1259 = z1256 + s_pitch * z1237 - z85 * z118 + c_pitch * z1238;
    const Scalar z1260 = s_pitch * z1238 - z1257 - z86 * z118 - c_pitch * z1237;
    const Scalar z1261 = z1211 + n0_35 * z1252;
    const Scalar z1262 = s_steer * z17;
    const Scalar z1263 = a_roll * z908 + a_pitch * z971 + a_steer * z974 + z1261;
    const Scalar z1264 = z86 * z156 - z1244 + s_pitch * z1241 - c_pitch * z1246;
    const Scalar z1265 = s_roll * z87 + z1262 + z14 * z120 + c_roll * z1259;
    const Scalar z1266 = s_steer * z14 - c_roll * z87 - z17 * z120 + s_roll * z1259;
    const Scalar z1267 = z1258 - z16 * z127 + c_yaw * z1260 + s_yaw * z1266;
    const Scalar z1268 = n0_08 * z1237 - n0_35 * z1238;
    const Scalar z1269 = z17 * z165;
    const Scalar z1270 = v_yaw * z890;
    const Scalar z1271 = v_roll * z896 + z1270 + v_pitch * z964 - v_steer * z966 + v_front * z968 - z315;
    const Scalar z1272 = v_roll * z896 + z1270 + v_pitch * z964 - v_steer * z966 + v_front * z968;
    const Scalar z1273 = z104 * z129;
    const Scalar z1274 = z16 * z121;
    const Scalar z1275 = z104 * z130;
    const Scalar z1276 = z1273 - z61 * z1265 + z53 * z1267 + z108 * z128;
    const Scalar z1277 = s_yaw * z1260 - z1274 - z18 * z127 - c_yaw * z1266;
    const Scalar z1278 = v_yaw * z895;
    const Scalar z1279 = v_roll * z897 - z1278 - v_pitch * z965 + v_steer * z967 + v_front * z969 - z332;
    const Scalar z1280 = v_roll * z897 - z1278 - v_pitch * z965 + v_steer * z967 + v_front * z969;
    const Scalar z1281 = s_roll * z1268 - z1269 + z14 * z164 + c_roll * z1264;
    const Scalar z1282 = s_roll * z276 - z17 * z195;
    const Scalar z1283 = z14 * z195 + c_roll * z276;
    const Scalar z1284 = s_yaw * z110 - z16 * z62 - z18 * z839 - c_yaw * z1230;
    const Scalar z1285 = z18 * z62 - z16 * z839 + c_yaw * z110 + s_yaw * z1230;
    const Scalar z1286 = z1284 - z106 * z1169 + z107 * z883 - z135 * z252 + z83 * z1253;
    const Scalar z1287 = z80 * z1253 - z1285 - z106 * z1160 - z109 * z883 - z142 * z252;
    const Scalar z1288 = z107 * z141;
    const Scalar z1289 = n2 * (z53 * z1265 - z104 * z128);
    const Scalar z1290 = z78 * z1265 + z1275 + z105 * z128 + z53 * z1277;
    const Scalar z1291 = z1284 - z1286;
    const Scalar z1292 = z18 * z194 - c_yaw * z251 - z16 * z948 + s_yaw * z1282;
    const Scalar z1293 = z16 * z194 + s_yaw * z251 + z18 * z948 + c_yaw * z1282;
    const Scalar z1294 = z105 * z927 - z232 * z1154 - z230 * z1159 - z124 * z286 - z123 * z262 + z104 * z929 + z53
        * z1291 - z78 * z1255;
    const Scalar z1295 = z1285 + z1287;
    const Scalar z1296 = z230 * z1157 - z234 * z1154 + z104 * z928 + z108 * z927 - z124 * z298 + z126 * z262 + z61
        * z1255 + z53 * z1295;
    const Scalar z1297 = z17 * z191 + s_roll * z280;
    const Scalar z1298 = c_roll * z280 - z14 * z191;
    const Scalar z1299 = z1254 - z1298;
    const Scalar z1300 = z16 * z192 + s_yaw * z282 + z18 * z953 - c_yaw * z1297;
    const Scalar z1301 = c_yaw * z282 - z18 * z192 + z16 * z953 + s_yaw * z1297;
    const Scalar z1302 = z1286 + z1300;
    const Scalar z1303 = z284 * z957 - z233 * z1283 - z231 * z1293 - z294 * z952 - z304 * z955 + z257 * z963 + z197
        * z1302 - z199 * z1299;
    const Scalar z1304 = z1287 - z1301;
    const Scalar z1305 = z237 * z1283 - z231 * z1292 + z257 * z960 - z306 * z957 + z304 * z954 - z308 * z952 - z200
        * z1299 + z197 * z1304;
    const Scalar z1306 = z16 * z892 + s_yaw * z1254;
    const Scalar z1307 = n2 * (z1288 + z145 * z146 + z82 * z1289 + z80 * z1276 - z83 * z1290 + z109 * z136);
    const Scalar z1308 = c_yaw * z1254 - z18 * z892;
    const Scalar z1309 = z17 * z890 - z28 * z892 + s_roll * z1286 + z21 * z1254;
    const Scalar z1310 = v_yaw * z1286 + v_roll * z1306 + v_pitch * z1309 - v_steer * z1303 - v_front * z1294;
    const Scalar z1311 = z17 * z895 - z27 * z892 + z19 * z1254 + s_roll * z1287;
    const Scalar z1312 = v_yaw * z1287 - v_roll * z1308 + v_pitch * z1311 - v_steer * z1305 + v_front * z1296;
    const Scalar z1313 = a_yaw * z890 + a_roll * z896 + a_pitch * z964 - a_steer * z966 + a_front * z968 + z1310;
    const Scalar z1314 = n2 * z88;
    const Scalar z1315 = z2 * z140;
    const Scalar z1316 = z1 * z140;
    const Scalar z1317 = z1 * z1314;
    const Scalar z1318 = z2 * z1314;
    const Scalar z1319 = a_yaw * z895 - a_roll * z897 + a_pitch * z965 - a_steer * z967 - a_front * z969 + z1312;
    const Scalar z1320 = s_pitch * z1317 - n2 * (z86 * z118 + z1257) - c_pitch * z1318;
    const Scalar z1321 = s_pitch * z1318 - n2 * (z85 * z118 - z1256) + c_pitch * z1317;
    const Scalar z1322 = n0_08 * z1318 - n0_35 * z1317;
    const Scalar z1323 = z118 * z133 + z119 * z137 + s_pitch * z1315 + c_pitch * z1316 + n2 * (z85 * z1237 - z86
        * z1238);
    const Scalar z1324 = z119 * z133 - z118 * z137 + s_pitch * z1316 - c_pitch * z1315 + n2 * (z85 * z1238 + z86
        * z1237);
    const Scalar z1325 = n0_08 * z1315 - n0_35 * z1316;
    const Scalar z1326 = s_roll * z139 + s_steer * z36 - z33 * z120 - n2 * (z17 * z87 - z14 * z1259) - c_roll * z1323;
    const Scalar z1327 = c_roll * z139 + s_steer * z33 + z36 * z120 + n2 * (z14 * z87 + z17 * z1259) + s_roll * z1323;
    const Scalar z1328 = n2 * z87;
    const Scalar z1329 = n2 * (z14 * z120 + z1262) + s_roll * z1328 + c_roll * z1321;
    const Scalar z1330 = n2 * (s_steer * z14 - z17 * z120) - c_roll * z1328 + s_roll * z1321;
    const Scalar z1331 = z160 * z163;
    const Scalar z1332 = c_yaw * z1320 - n2 * (z16 * z127 - z1258) + s_yaw * z1330;
    const Scalar z1333 = s_yaw * z1320 - n2 * (z18 * z127 + z1274) - c_yaw * z1330;
    const Scalar z1334 = z53 * z1332 - z61 * z1329 + n2 * (z108 * z128 + z1273);
    const Scalar z1335 = z78 * z1329 + n2 * (z105 * z128 + z1275) + z53 * z1333;
    const Scalar z1336 = z103 * z1329 - z128 * z1140;
    const Scalar z1337 = n4 * (z1288 + z145 * z146 + z109 * z136) + n2 * (z82 * z1336 + z80 * z1334 - z83 * z1335);
    const Scalar z1338 = z1140 * z1265 + n2 * (z53 * z1326 + z128 * z170);
    const Scalar z1339 = z34 * z121 - z38 * z127 + n2 * (z16 * z1260 + z18 * z1266) + s_yaw * z1324 - c_yaw * z1327;
    const Scalar z1340 = z38 * z121 + z34 * z127 + n2 * (z16 * z1266 - z18 * z1260) + c_yaw * z1324 + s_yaw * z1327;
    const Scalar z1341 = z130 * z170 - z78 * z1326 - n2 * (z104 * z1277 - z105 * z1265) + z53 * z1339 - z128 * z172;
    const Scalar z1342 = z61 * z1326 + z129 * z170 - n2 * (z104 * z1267 - z108 * z1265) + z53 * z1340 - z128 * z168;
    const Scalar z1343 = n2 * (z146 * z173 - z82 * z1338 - z141 * z174 - z136 * z176 - z83 * z1341 + z80 * z1342) - n4
        * (z109 * z1276 + z107 * z1290 - z145 * z1289);
    const Scalar z1344 = n0_5 * (z1331 / (z96 * z96) - z1337 / z96 + z169 * z150 / (z96 * z96));
    const Scalar z1345 = n0_5 * (z1331 / (z96 * z96) - z1307 / z96);
    const Scalar z1346 = n0_5 * (z160 * z1345 / (z96 * z96) - z169 * z1307 / (z96 * z96) - z163 * z185 / (z96 * z96)
        - z1343 / z96) + z163 * z211 / (z96 * z96 * z96);
    const Scalar z1347 = z163 * z1161 / (z96 * z96 * z96) + n0_35 * z1345 / (z96 * z96);
    const Scalar z1348 = z1281 - n0_35 * z1345;
    const Scalar z1349 = v_roll * z1014;
    const Scalar z1350 = v_yaw * z958 + z1349 + v_pitch * z1018 - v_steer * z1022 - v_front * z1025 - z333;
    const Scalar z1351 = z1281 + z106 * z1289 + z145 * z951 + z146 * z252 + z82 * z1347;
    const Scalar z1352 = v_yaw * z958 + z1349 + v_pitch * z1018 - v_steer * z1022 - v_front * z1025;
    const Scalar z1353 = z1281 - z1351;
    const Scalar z1354 = v_yaw * z961;
    const Scalar z1355 = z85 * z156 + z86 * z154 + s_pitch * z1246 + c_pitch * z1241;
    const Scalar z1356 = z8 * z139;
    const Scalar z1357 = s_roll * z1264 - c_roll * z1268 - z17 * z164 - z14 * z165;
    const Scalar z1358 = -z139 * (n1 - z7);
    const Scalar z1359 = n0_35 * z1356 + n0_08 * z1358;
    const Scalar z1360 = -z139 * (n1 - z9);
    const Scalar z1361 = n0_08 * z1356 + n0_35 * z1360;
    const Scalar z1362 = z16 * z936 + z18 * z880 + s_yaw * z1355 + c_yaw * z1357;
    const Scalar z1363 = s_pitch * z1359 - z156 * z137 - z154 * z133 - c_pitch * z1361 - n2 * (z85 * z1241 + z86
        * z1246);
    const Scalar z1364 = z1362 - z106 * z1290 + z107 * z951 + z141 * z252 + z83 * z1347;
    const Scalar z1365 = z8 * z1328;
    const Scalar z1366 = -z1328 * (n1 - z7);
    const Scalar z1367 = -z1328 * (n1 - z9);
    const Scalar z1368 = n0_35 * z1365 + n0_08 * z1366;
    const Scalar z1369 = z18 * z936 - z16 * z880 - c_yaw * z1355 + s_yaw * z1357;
    const Scalar z1370 = z1369 + z106 * z1276 - z109 * z951 - z136 * z252 + z80 * z1347;
    const Scalar z1371 = z36 * z165 + s_roll * z1325 + z33 * z164 + n2 * (z17 * z1268 - z14 * z1264) - c_roll * z1363;
    const Scalar z1372 = n0_08 * z1365 + n0_35 * z1367;
    const Scalar z1373 = s_pitch * z1368 - c_pitch * z1372 + n2 * (z86 * z156 - z1244);
    const Scalar z1374 = z17 * z958 - z28 * z1004 + s_roll * z1364 + z21 * z1351;
    const Scalar z1375 = z17 * z961 - z27 * z1004 + s_roll * z1370 + z19 * z1351;
    const Scalar z1376 = s_roll * z1322 + n2 * (z14 * z164 - z1269) + c_roll * z1373;
    const Scalar z1377 = z257 * z958 + z284 * z1004 + z197 * z1364 - z199 * z1351;
    const Scalar z1378 = z257 * z961 - z306 * z1004 + z197 * z1370 - z200 * z1351;
    const Scalar z1379 = z1371 - n0_35 * z1346;
    const Scalar z1380 = a_roll * z931 + a_pitch * z993 - a_steer * z1043 + z1379;
    const Scalar z1381 = z1376 - n0_35 * z1344;
    const Scalar z1382 = z16 * z1004 + s_yaw * z1351;
    const Scalar z1383 = c_yaw * z1351 - z18 * z1004;
    const Scalar z1384 = z1362 - z1364;
    const Scalar z1385 = z232 * z1265 - z230 * z1277 - z104 * z986 - z105 * z1005 + z128 * z286 + z130 * z262 + z53
        * z1384 + z78 * z1353;
    const Scalar z1386 = z1369 - z1370;
    const Scalar z1387 = z230 * z1267 - z234 * z1265 + z108 * z1005 - z128 * z298 - z129 * z262 + z104 * z987 + z53
        * z1386 + z61 * z1353;
    const Scalar z1388 = v_yaw * z1364 + v_roll * z1382 + v_pitch * z1374 - v_steer * z1377 - v_front * z1385;
    const Scalar z1389 = a_yaw * z958 + a_roll * z1014 + a_pitch * z1018 - a_steer * z1022 - a_front * z1025 + z1388;
    const Scalar z1390 = v_yaw * z1370 - v_roll * z1383 + v_pitch * z1375 - v_steer * z1378 - v_front * z1387;
    const Scalar z1391 = a_yaw * z961 - a_roll * z1016 + a_pitch * z1019 - a_steer * z1024 + a_front * z1027 + z1390;
    const Scalar z1392 = v_roll * z1016 - z1354 - v_pitch * z1019 + v_steer * z1024 - v_front * z1027 + z338;
    const Scalar z1393 = v_roll * z1016 - z1354 - v_pitch * z1019 + v_steer * z1024 - v_front * z1027;
    const Scalar z1394 = n1 / z238;
    const Scalar z1395 = z247 * z1394;
    const Scalar z1396 = n1 / z175;
    const Scalar z1397 = z98 + z177;
    const Scalar z1398 = z1396 * z1397;
    const Scalar z1399 = z190 * z1396;
    const Scalar z1400 = z208 * z1396;
    const Scalar z1401 = z181 - z182 * z1395;
    const Scalar z1402 = z1198 * z1399 - z1348;
    const Scalar z1403 = z1134 - z1198 * z1398;
    const Scalar z1404 = z1165 + z1272 * z1398;
    const Scalar z1405 = z1272 * z1399 + z1352;
    const Scalar z1406 = z178 - z1401;
    const Scalar z1407 = z1175 - z1280 * z1398;
    const Scalar z1408 = z1280 * z1399 + z1393;
    const Scalar z1409 = z1406 * z1406;
    const Scalar z1410 = n1 / z1406;
    const Scalar z1411 = z209 * z1396;
    const Scalar z1412 = z210 * z1396;
    const Scalar z1413 = z1056 - z1054 + z1058 * z1395;
    const Scalar z1414 = z190 * z1411;
    const Scalar z1415 = z190 * z1412 - z241;
    const Scalar z1416 = z215 * z1396;
    const Scalar z1417 = z1132 - z1403;
    const Scalar z1418 = z190 * z1400 - z242 - z1414 - z1395 * z1415;
    const Scalar z1419 = z217 - z1411 * z1397;
    const Scalar z1420 = z186 - z1412 * z1397;
    const Scalar z1421 = z198 - z1400 * z1397 - z1419 - z1395 * z1420;
    const Scalar z1422 = z180 * z1410;
    const Scalar z1423 = z1412 * z1417 - z1404;
    const Scalar z1424 = z175 * z175;
    const Scalar z1425 = n1_over_94 + z190 * z190 / z6 + z177 * z177 / z510 + z1424 / z480;
    const Scalar z1426 = z1135 - z1422 * z1413;
    const Scalar z1427 = z212 - z1416 * z1397 + z1422 * z1421;
    const Scalar z1428 = n1 - z1395 * z1422;
    const Scalar z1429 = z1180 + z1411 * z1417;
    const Scalar z1430 = z1428 * z1428;
    const Scalar z1431 = n1 / z1428;
    const Scalar z1432 = z1400 * z1417 - z1429 + z1407 - z1395 * z1423;
    const Scalar z1433 = z215 - z209 * z1422;
    const Scalar z1434 = z190 * z1416 + z1422 * z1418;
    const Scalar z1435 = z238 * z238;
    const Scalar z1436 = n1_over_94 + n25_over_7 * z1435 + z182 * z182 / z531 + z186 * z186 / z510 + z241 * z241 / z6
        + z210 * z210 / z480;
    const Scalar z1437 = z480 * z1425;
    const Scalar z1438 = z1431 * z1433;
    const Scalar z1439 = z1431 * z1434;
    const Scalar z1440 = z1193 + z1416 * z1417 + z1422 * z1432;
    const Scalar z1441 = z1395 * z1439 + z1418;
    const Scalar z1442 = z1431 * z1426;
    const Scalar z1443 = z1431 * z1440;
    const Scalar z1444 = z1410 * z1441;
    const Scalar z1445 = z1431 * z1427;
    const Scalar z1446 = z1395 * z1442 - z1413;
    const Scalar z1447 = z1395 * z1443 + z1432;
    const Scalar z1448 = z178 * z1444 + z1414;
    const Scalar z1449 = n0_28 * z1436;
    const Scalar z1450 = z1395 * z1445 + z1421;
    const Scalar z1451 = z1410 * z1446;
    const Scalar z1452 = z1410 * z1447;
    const Scalar z1453 = z1058 - z1442 + z182 * z1451;
    const Scalar z1454 = z1423 - z1443 + z182 * z1452;
    const Scalar z1455 = z178 * z1451 - z1054;
    const Scalar z1456 = z178 * z1452 + z1429;
    const Scalar z1457 = z1410 * z1450;
    const Scalar z1458 = z1415 - z1439 + z182 * z1444;
    const Scalar z1459 = z1394 * z1458;
    const Scalar z1460 = z1394 * z1453;
    const Scalar z1461 = z178 * z1457 + z1419;
    const Scalar z1462 = z1420 - z1445 + z182 * z1457;
    const Scalar z1463 = z1394 * z1454;
    const Scalar z1464 = z1394 * z1462;
    const Scalar z1465 = z209 - z1395 * z1438;
    const Scalar z1466 = z1410 * z1465;
    const Scalar z1467 = n1_over_94 + n25_over_7 * z247 * z247 + z181 * z181 / z531 + z198 * z198 / z510 + z242 * z242
        / z6 + z208 * z208 / z480;
    const Scalar z1468 = z531 * z1467;
    const Scalar z1469 = z1412 * z1402 - z1405;
    const Scalar z1470 = z1396 * z1417;
    const Scalar z1471 = z1411 * z1402;
    const Scalar z1472 = z178 * z1466 - z209;
    const Scalar z1473 = z182 * z1466 + z1438;
    const Scalar z1474 = z1394 * z1473;
    const Scalar z1475 = n1_over_94 + z215 * z215 * (n25_over_3 + n1 / z480) + z212 * z212 / z510 + z180 * z180 / z531;
    const Scalar z1476 = n94 * z1475;
    const Scalar z1477 = z1400 * z1402 - z1471 - z1408 - z1395 * z1469;
    const Scalar z1478 = z1131 - z1243 * z1398;
    const Scalar z1479 = z1243 * z1399 - z1381;
    const Scalar z1480 = z226 * z1398 + z1179 - z1055 * z1457;
    const Scalar z1481 = z1133 - z1478;
    const Scalar z1482 = z1411 * z1481 + z1480;
    const Scalar z1483 = z1059 * z1457 - z1164 - z1271 * z1398 + z339 * z1464;
    const Scalar z1484 = z1350 + z1271 * z1399 + z1059 * z1444 + z339 * z1459;
    const Scalar z1485 = z1174 - z1279 * z1398 - z1057 * z1457 + z341 * z1464;
    const Scalar z1486 = z1279 * z1399 + z1392 - z1057 * z1444 + z341 * z1459;
    const Scalar z1487 = z255 * z1398 + z1190 + z1136 * z1457;
    const Scalar z1488 = z1412 * z1481 + z1483;
    const Scalar z1489 = z1412 * z1479 - z1484;
    const Scalar z1490 = z1400 * z1481 - z1482 + z1485 - z1395 * z1488;
    const Scalar z1491 = z1416 * z1402 + z1422 * z1477;
    const Scalar z1492 = z1431 * z1491;
    const Scalar z1493 = z1396 * z1402;
    const Scalar z1494 = z1416 * z1481 + z1487 + z1422 * z1490;
    const Scalar z1495 = z1395 * z1492 + z1477;
    const Scalar z1496 = z1396 * z1481;
    const Scalar z1497 = z1431 * z1494;
    const Scalar z1498 = z1243 * z1470;
    const Scalar z1499 = z1243 * z1493;
    const Scalar z1500 = z1395 * z1497 + z1490;
    const Scalar z1501 = z1410 * z1495;
    const Scalar z1502 = z226 * z1470 + z1055 * z1452;
    const Scalar z1503 = z226 * z1399 + z1055 * z1444;
    const Scalar z1504 = z1469 - z1492 + z182 * z1501;
    const Scalar z1505 = z178 * z1501 + z1471;
    const Scalar z1506 = z1411 * z1479 + z1503;
    const Scalar z1507 = z1394 * z1504;
    const Scalar z1508 = z1158 + z1263 * z1398;
    const Scalar z1509 = z1263 * z1399 - z1380;
    const Scalar z1510 = z1207 + z1313 * z1398;
    const Scalar z1511 = z1313 * z1399 + z1389;
    const Scalar z1512 = z1400 * z1479 - z1506 - z1486 - z1395 * z1489;
    const Scalar z1513 = z1410 * z1500;
    const Scalar z1514 = z178 * z1513 + z1482;
    const Scalar z1515 = z1488 - z1497 + z182 * z1513;
    const Scalar z1516 = z226 * z1493 + z1055 * z1501;
    const Scalar z1517 = z226 - z1055 * z1466;
    const Scalar z1518 = z1055 * z1451;
    const Scalar z1519 = z1394 * z1515;
    const Scalar z1520 = z1059 * z1451 + z339 * z1460;
    const Scalar z1521 = z1271 * z1470 + z1059 * z1452 + z339 * z1463;
    const Scalar z1522 = z1271 * z1493 + z1059 * z1501 + z339 * z1507;
    const Scalar z1523 = z1059 * z1466 + z339 * z1474;
    const Scalar z1524 = z1279 * z1470 - z1057 * z1452 + z341 * z1463;
    const Scalar z1525 = z1279 * z1493 - z1057 * z1501 + z341 * z1507;
    const Scalar z1526 = z341 * z1460 - z1057 * z1451;
    const Scalar z1527 = z341 * z1474 - z1057 * z1466;
    const Scalar z1528 = z1395 * z1523 + z1517 - z1527;
    const Scalar z1529 = z255 * z1470 - z1136 * z1452;
    const Scalar z1530 = z1136 * z1451;
    const Scalar z1531 = z255 * z1399 - z1136 * z1444;
    const Scalar z1532 = z1217 + z1319 * z1398;
    const Scalar z1533 = z1416 * z1479 + z1531 + z1422 * z1512;
    const Scalar z1534 = z1396 * z1479;
    const Scalar z1535 = z255 * z1493 - z1136 * z1501;
    const Scalar z1536 = z255 + z1136 * z1466;
    const Scalar z1537 = z1498 + z1508;
    const Scalar z1538 = z1499 + z1509;
    const Scalar z1539 = z1229 - z1502;
    const Scalar z1540 = z1319 * z1399 + z1391;
    const Scalar z1541 = z1052 + z1518;
    const Scalar z1542 = z1073 + z1520;
    const Scalar z1543 = z1521 + z1510;
    const Scalar z1544 = z1522 + z1511;
    const Scalar z1545 = z1524 - z1532;
    const Scalar z1546 = z1525 - z1540;
    const Scalar z1547 = z1082 + z1526;
    const Scalar z1548 = z1236 + z1529;
    const Scalar z1549 = z1084 - z1530;
    const Scalar z1550 = z1139 + z1537;
    const Scalar z1551 = z1411 * z1550 - z1539;
    const Scalar z1552 = z1412 * z1550 - z1543;
    const Scalar z1553 = z1395 * z1542 - z1541 - z1547;
    const Scalar z1554 = z1422 * z1528 - z1536;
    const Scalar z1555 = z1400 * z1550 - z1551 - z1545 - z1395 * z1552;
    const Scalar z1556 = z1422 * z1553 + z1549;
    const Scalar z1557 = z1431 * z1554;
    const Scalar z1558 = z1431 * z1556;
    const Scalar z1559 = z1431 * z1533;
    const Scalar z1560 = z1395 * z1557 + z1528;
    const Scalar z1561 = z1395 * z1559 + z1512;
    const Scalar z1562 = z1395 * z1558 + z1553;
    const Scalar z1563 = z1410 * z1560;
    const Scalar z1564 = z1410 * z1561;
    const Scalar z1565 = z1410 * z1562;
    const Scalar z1566 = z1416 * z1550 + z1548 + z1422 * z1555;
    const Scalar z1567 = z178 * z1563 - z1517;
    const Scalar z1568 = z178 * z1564 + z1506;
    const Scalar z1569 = z178 * z1565 + z1541;
    const Scalar z1570 = z1431 * z1566;
    const Scalar z1571 = z1489 - z1559 + z182 * z1564;
    const Scalar z1572 = z182 * z1563 - z1523 - z1557;
    const Scalar z1573 = z1395 * z1570 + z1555;
    const Scalar z1574 = z182 * z1565 - z1542 - z1558;
    const Scalar z1575 = z1394 * z1571;
    const Scalar z1576 = z1411 * z1538 + z1516;
    const Scalar z1577 = z1412 * z1538 - z1544;
    const Scalar z1578 = z1400 * z1538 - z1576 - z1546 - z1395 * z1577;
    const Scalar z1579 = z1396 * z1550;
    const Scalar z1580 = z1410 * z1573;
    const Scalar z1581 = z178 * z1580 + z1551;
    const Scalar z1582 = z1552 - z1570 + z182 * z1580;
    const Scalar z1583 = z1394 * z1572;
    const Scalar z1584 = z434 + z98 * z435 - z399 * z1398 + z423 * z1445 + z433 * z1457 - z424 * z1461;
    const Scalar z1585 = z1000 - z1001;
    const Scalar z1586 = z1015 + z1411 * z1585;
    const Scalar z1587 = z1013 - z1412 * z1585;
    const Scalar z1588 = z435 - z537 * z1399;
    const Scalar z1589 = z1416 * z1538 + z1535 + z1422 * z1578;
    const Scalar z1590 = z1400 * z1585 - z1586 + z1017 + z1395 * z1587;
    const Scalar z1591 = z1431 * z1589;
    const Scalar z1592 = z1396 * z1538;
    const Scalar z1593 = z1395 * z1591 + z1578;
    const Scalar z1594 = z510 + z98 * z515 + z533 * z1398 - z559 * z1445 - z562 * z1457 - z560 * z1461 + z457 * z1464;
    const Scalar z1595 = z1048 - z1416 * z1585 - z1422 * z1590;
    const Scalar z1596 = z1396 * z1585;
    const Scalar z1597 = z515 + n94 * z98 + z537 * z1398;
    const Scalar z1598 = z533 + z98 * z537 + z480 * z1398 + z539 * z1445 - z541 * z1457 + z532 * z1461 + z410 * z1464;
    const Scalar z1599 = z1431 * z1595;
    const Scalar z1600 = z1395 * z1599 - z1590;
    const Scalar z1601 = z539 * z1439 - z399 - z480 * z1399 - z541 * z1444 + z532 * z1448 + z410 * z1459;
    const Scalar z1602 = z6 + z399 * z1399 + z423 * z1439 + z433 * z1444 - z424 * z1448;
    const Scalar z1603 = z424 + z532 * z1399 + z529 * z1444 - n94 * z1448;
    const Scalar z1604 = z423 - z539 * z1399 + n94 * z1439 - z522 * z1444;
    const Scalar z1605 = z539 * z1398 - z559 + n94 * z1445 - z522 * z1457;
    const Scalar z1606 = z522 * z1439 - z433 - z541 * z1399 - z531 * z1444 + z529 * z1448 + z425 * z1459;
    const Scalar z1607 = z532 * z1398 - z560 - z529 * z1457 + n94 * z1461;
    const Scalar z1608 = n0_12 - z539 * z1438 - z541 * z1466 + z532 * z1472 + z410 * z1474;
    const Scalar z1609 = z562 + z541 * z1398 + z522 * z1445 - z531 * z1457 + z529 * z1461 + z425 * z1464;
    const Scalar z1610 = z519 - z522 * z1438 - z531 * z1466 + z529 * z1472 + z425 * z1474;
    const Scalar z1611 = n94 * z1438 + z522 * z1466;
    const Scalar z1612 = z529 * z1466 - n94 * z1472;
    const Scalar z1613 = z410 * z1398 + z457 - z425 * z1457 + n0_28 * z1464;
    const Scalar z1614 = z410 * z1399 + z425 * z1444 - n0_28 * z1459;
    const Scalar z1615 = z425 * z1466 - n0_28 * z1474;
    const Scalar z1616 = z1410 * z1593;
    const Scalar z1617 = z1410 * z1600;
    const Scalar z1618 = z98 * z1597 + z1445 * z1605 + z1461 * z1607 + z1464 * z1613 + z1398 * z1598 - z1457 * z1609
        + z1594;
    const Scalar z1619 = z178 * z1616 + z1576;
    const Scalar z1620 = z1577 - z1591 + z182 * z1616;
    const Scalar z1621 = z1394 * z1574;
    const Scalar z1622 = z1448 * z1603 - z1602 - z1439 * z1604 + z1459 * z1614 + z1399 * z1601 + z1444 * z1606;
    const Scalar z1623 = z1399 * z1598 - z1584 - z1439 * z1605 - z1448 * z1607 - z1459 * z1613 + z1444 * z1609;
    const Scalar z1624 = z1394 * z1582;
    const Scalar z1625 = z646 + z741 * z1398;
    const Scalar z1626 = z741 * z1399 + z824;
    const Scalar z1627 = z743 * z1398 - z686 + z690 * z1457;
    const Scalar z1628 = z742 * z1399 - z830 + z688 * z1444;
    const Scalar z1629 = z690 * z1444 - z831 - z743 * z1399;
    const Scalar z1630 = z687 - z742 * z1398 + z688 * z1457;
    const Scalar z1631 = z1394 * z1620;
    const Scalar z1632 = z669 * z1466 - z749 + z827 * z1474;
    const Scalar z1633 = z732 * z1398 - z738 - z739 * z1457 + z821 * z1464;
    const Scalar z1634 = z663 * z1398 - z673 - z695 * z1457 - z810 * z1464;
    const Scalar z1635 = z663 * z1399 - z777 + z695 * z1444 + z810 * z1459;
    const Scalar z1636 = z678 - z753 * z1398 + z685 * z1457 + z829 * z1464;
    const Scalar z1637 = z753 * z1399 - z834 + z685 * z1444 + z829 * z1459;
    const Scalar z1638 = z752 * z1398 - z705 + z669 * z1457 + z827 * z1464;
    const Scalar z1639 = z833 - z752 * z1399 + z669 * z1444 + z827 * z1459;
    const Scalar z1640 = z178 * z1617 - z1586;
    const Scalar z1641 = z1587 - z1599 + z182 * z1617;
    const Scalar z1642 = z1394 * z1641;
    const Scalar z1643 = z820 - z811 * z1399 - z829 * z1444;
    const Scalar z1644 = z98 * z1626 - z1461 * z1628 - z1464 * z1643 + z1445 * z1629 - z1398 * z1635 + z1457 * z1637
        + z1639;
    const Scalar z1645 = z783 - z755 * z1457;
    const Scalar z1646 = z811 * z1398 + z828 - z829 * z1457;
    const Scalar z1647 = z98 * z1625 - z1445 * z1627 + z1461 * z1630 + z1464 * z1646 - z1398 * z1634 - z1457 * z1636
        - z1638;
    const Scalar z1648 = n0_12 - z519 * z1466;
    const Scalar z1649 = z1438 * z1611 + z1648 - z1472 * z1612 - z1474 * z1615 - z1466 * z1610;
    const Scalar z1650 = n0_12 * z1399 + z519 * z1444;
    const Scalar z1651 = z519 * z1457 - n0_12 * z1398;
    const Scalar z1652 = z1633 + z1448 * z1630 - z1439 * z1627 + z1459 * z1646 + z1399 * z1634 - z1444 * z1636;
    const Scalar z1653 = z1645 + z1438 * z1627 + z1472 * z1630 + z1474 * z1646 - z1466 * z1636;
    const Scalar z1654 = z1438 * z1604 + z1650 + z1472 * z1603 + z1474 * z1614 + z1466 * z1606;
    const Scalar z1655 = z1438 * z1605 + z1651 - z1472 * z1607 - z1474 * z1613 + z1466 * z1609;
    const Scalar z1656 = z690 * z1466;
    const Scalar z1657 = z688 * z1466;
    const Scalar z1658 = z732 * z1399 + z739 * z1444 - z821 * z1459;
    const Scalar z1659 = z1658 + z1439 * z1629 - z1448 * z1628 - z1459 * z1643 + z1399 * z1635 + z1444 * z1637;
    const Scalar z1660 = z739 * z1466 - z821 * z1474;
    const Scalar z1661 = z755 * z1444;
    const Scalar z1662 = z1472 * z1628 - z1661 + z1474 * z1643 + z1438 * z1629 - z1466 * z1637;
    const Scalar z1663 = z755 * z1466;
    const Scalar z1664 = z829 * z1466;
    const Scalar z1665 = z695 * z1466 + z810 * z1474;
    const Scalar z1666 = z685 * z1466 + z755 + z829 * z1474;
    const Scalar z1667 = z1461 * z1657 - z1632 - z1445 * z1656 - z1464 * z1664 + z1398 * z1665 - z1457 * z1666;
    const Scalar z1668 = z1660 + z1439 * z1656 - z1448 * z1657 + z1459 * z1664 + z1399 * z1665 + z1444 * z1666;
    const Scalar z1669 = z1438 * z1656 - z1663 + z1472 * z1657 - z1474 * z1664 - z1466 * z1666;
    const Scalar z1670 = z1133 * z1597 + z1496 * z1598 - z1497 * z1605 + z1513 * z1609 - z1514 * z1607 - z1519 * z1613;
    const Scalar z1671 = z1670 + z1647;
    const Scalar z1672 = z1133 * z1588 + z1496 * z1601 - z1497 * z1604 + z1513 * z1606 + z1514 * z1603 + z1519 * z1614;
    const Scalar z1673 = z1496 * z1608 + z1497 * z1611 + z1513 * z1610 + z1514 * z1612 + z1519 * z1615;
    const Scalar z1674 = z1672 + z1652;
    const Scalar z1675 = z1673 + z1653;
    const Scalar z1676 = z1559 * z1605 - z1534 * z1598 - z1564 * z1609 + z1568 * z1607 + z1575 * z1613;
    const Scalar z1677 = z1676 - z1644;
    const Scalar z1678 = z1557 * z1605 - z1563 * z1609 + z1567 * z1607 + z1583 * z1613;
    const Scalar z1679 = z1678 + z1667;
    const Scalar z1680 = z690 * z1451;
    const Scalar z1681 = z690 * z1452 - z743 * z1470;
    const Scalar z1682 = z1559 * z1604 - z1534 * z1601 - z1564 * z1606 - z1568 * z1603 - z1575 * z1614;
    const Scalar z1683 = z1534 * z1608 + z1559 * z1611 + z1564 * z1610 + z1568 * z1612 + z1575 * z1615;
    const Scalar z1684 = z690 * z1501 - z743 * z1493;
    const Scalar z1685 = z1682 - z1659;
    const Scalar z1686 = z1683 - z1662;
    const Scalar z1687 = z1557 * z1604 - z1563 * z1606 - z1567 * z1603 - z1583 * z1614;
    const Scalar z1688 = z1557 * z1611 + z1563 * z1610 + z1567 * z1612 + z1583 * z1615;
    const Scalar z1689 = z709 - z1680;
    const Scalar z1690 = z1687 - z1668;
    const Scalar z1691 = z1688 - z1669;
    const Scalar z1692 = z677 - z684 * z1398;
    const Scalar z1693 = z684 * z1399 - z774;
    const Scalar z1694 = z693 - z697 * z1398;
    const Scalar z1695 = z697 * z1399 - z778;
    const Scalar z1696 = z922 - z979 * z1398;
    const Scalar z1697 = z979 * z1399 + z1068;
    const Scalar z1698 = z914 - z976 * z1398;
    const Scalar z1699 = z976 * z1399 + z1033;
    const Scalar z1700 = z694 + z698 * z1398;
    const Scalar z1701 = z698 * z1399 + z779;
    const Scalar z1702 = z1681 + z1700;
    const Scalar z1703 = z1684 + z1701;
    const Scalar z1704 = z923 - z982 * z1398;
    const Scalar z1705 = z982 * z1399 - z1041;
    const Scalar z1706 = z865 - z920 * z1398;
    const Scalar z1707 = z920 * z1399 - z981;
    const Scalar z1708 = z924 + z984 * z1398;
    const Scalar z1709 = z984 * z1399 + z1045;
    const Scalar z1710 = z741 * z1470;
    const Scalar z1711 = z1710 + z1692;
    const Scalar z1712 = z741 * z1493;
    const Scalar z1713 = z1712 - z1693;
    const Scalar z1714 = z742 * z1470 + z688 * z1452;
    const Scalar z1715 = z1714 + z1694;
    const Scalar z1716 = z742 * z1493 + z688 * z1501;
    const Scalar z1717 = z1716 - z1695;
    const Scalar z1718 = z688 * z1451;
    const Scalar z1719 = z710 + z1718;
    const Scalar z1720 = z669 * z1451 + z827 * z1460;
    const Scalar z1721 = z695 * z1451 + z810 * z1460;
    const Scalar z1722 = z739 * z1451 - z821 * z1460;
    const Scalar z1723 = z685 * z1451 + z829 * z1460;
    const Scalar z1724 = z869 + z1723;
    const Scalar z1725 = z732 * z1470 + z739 * z1452 - z821 * z1463;
    const Scalar z1726 = z732 * z1493 + z739 * z1501 - z821 * z1507;
    const Scalar z1727 = z811 * z1470 + z829 * z1452;
    const Scalar z1728 = z811 * z1493 + z829 * z1501;
    const Scalar z1729 = z755 * z1451;
    const Scalar z1730 = z829 * z1451;
    const Scalar z1731 = z755 * z1452;
    const Scalar z1732 = z755 * z1501;
    const Scalar z1733 = z663 * z1470 + z695 * z1452 + z810 * z1463;
    const Scalar z1734 = z663 * z1493 + z695 * z1501 + z810 * z1507;
    const Scalar z1735 = z685 * z1452 + z753 * z1470 + z829 * z1463;
    const Scalar z1736 = z685 * z1501 + z753 * z1493 + z829 * z1507;
    const Scalar z1737 = z669 * z1452 - z752 * z1470 + z827 * z1463;
    const Scalar z1738 = z669 * z1501 - z752 * z1493 + z827 * z1507;
    const Scalar z1739 = z1558 * z1605 - z1565 * z1609 + z1569 * z1607 + z1621 * z1613;
    const Scalar z1740 = z1735 + z1706;
    const Scalar z1741 = z1139 * z1597 + z1579 * z1598 - z1570 * z1605 + z1580 * z1609 - z1581 * z1607 - z1624 * z1613;
    const Scalar z1742 = z1736 - z1707;
    const Scalar z1743 = z1139 * z1588 + z1579 * z1601 - z1570 * z1604 + z1580 * z1606 + z1581 * z1603 + z1624 * z1614;
    const Scalar z1744 = z1579 * z1608 + z1570 * z1611 + z1580 * z1610 + z1581 * z1612 + z1624 * z1615;
    const Scalar z1745 = z1591 * z1605 - z1592 * z1598 - z1616 * z1609 + z1619 * z1607 + z1631 * z1613;
    const Scalar z1746 = z856 + z1720;
    const Scalar z1747 = z1558 * z1604 - z1565 * z1606 - z1569 * z1603 - z1621 * z1614;
    const Scalar z1748 = z1558 * z1611 + z1565 * z1610 + z1569 * z1612 + z1621 * z1615;
    const Scalar z1749 = z1737 + z1708;
    const Scalar z1750 = z1738 + z1709;
    const Scalar z1751 = z1591 * z1604 - z1592 * z1601 - z1616 * z1606 - z1619 * z1603 - z1631 * z1614;
    const Scalar z1752 = z1592 * z1608 + z1591 * z1611 + z1616 * z1610 + z1619 * z1612 + z1631 * z1615;
    const Scalar z1753 = z1000 * z1597 + z1599 * z1605 + z1640 * z1607 + z1642 * z1613 - z1617 * z1609 + z1596 * z1598;
    const Scalar z1754 = z1000 * z1588 + z1599 * z1604 - z1640 * z1603 - z1642 * z1614 - z1617 * z1606 + z1596 * z1601;
    const Scalar z1755 = z1599 * z1611 + z1640 * z1612 + z1642 * z1615 + z1617 * z1610 - z1596 * z1608;
    const Scalar z1756 = l_lambda_rear_rolls_x * z180 + l_lambda_rear_rolls_y * z178 + l_lambda_front_rolls_x * z182
        + l_lambda_front_rolls_y * z181 - z1042;
    const Scalar z1757 = l_lambda_rear_rolls_x * z215 - z1009 + l_lambda_rear_rolls_y * z209 + l_lambda_front_touches
        * z175 + l_lambda_front_rolls_x * z210 + l_lambda_front_rolls_y * z208;
    const Scalar z1758 = l_lambda_front_rolls_x * z238 - z366 + l_lambda_front_rolls_y * z247;
    const Scalar z1759 = z859 + z1721;
    const Scalar z1760 = z862 - z1722;
    const Scalar z1761 = z1725 + z1696;
    const Scalar z1762 = z1726 - z1697;
    const Scalar z1763 = z1727 + z1698;
    const Scalar z1764 = z1728 - z1699;
    const Scalar z1765 = z860 - z1729;
    const Scalar z1766 = z917 - z1731;
    const Scalar z1767 = z866 - z1730;
    const Scalar z1768 = z1733 + z1704;
    const Scalar z1769 = z1734 - z1705;
    const Scalar z1770 = z98 * z1711 - z1461 * z1715 + z1464 * z1763 + z1445 * z1702 - z1398 * z1768 + z1457 * z1740
        + z1749;
    const Scalar z1771 = z98 * z1713 - z1461 * z1717 + z1464 * z1764 + z1445 * z1703 - z1398 * z1769 + z1457 * z1742
        + z1750;
    const Scalar z1772 = z1761 + z1459 * z1763 - z1448 * z1715 + z1439 * z1702 + z1399 * z1768 + z1444 * z1740;
    const Scalar z1773 = z1766 + z1472 * z1715 - z1474 * z1763 + z1438 * z1702 - z1466 * z1740;
    const Scalar z1774 = z1762 + z1459 * z1764 - z1448 * z1717 + z1439 * z1703 + z1399 * z1769 + z1444 * z1742;
    const Scalar z1775 = z1472 * z1717 - z1732 - z1474 * z1764 + z1438 * z1703 - z1466 * z1742;
    const Scalar z1776 = z1741 + z1770;
    const Scalar z1777 = z1745 - z1771;
    const Scalar z1778 = z1743 + z1772;
    const Scalar z1779 = z1751 - z1774;
    const Scalar z1780 = z1744 - z1773;
    const Scalar z1781 = z1752 - z1775;
    const Scalar z1782 = n1 / z1649;
    const Scalar z1783 = l_lambda_rear_touches + l_lambda_front_touches - z474;
    const Scalar z1784 = z1445 * z1689 - z1746 + z1461 * z1719 + z1464 * z1767 + z1398 * z1759 - z1457 * z1724;
    const Scalar z1785 = z1399 * z1759 - z1760 - z1439 * z1689 - z1448 * z1719 - z1459 * z1767 + z1444 * z1724;
    const Scalar z1786 = z1438 * z1689 - z1765 - z1472 * z1719 - z1474 * z1767 + z1466 * z1724;
    const Scalar z1787 = z1739 + z1784;
    const Scalar z1788 = z1747 - z1785;
    const Scalar z1789 = z1748 + z1786;
    const Scalar z1790 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z479;
    const Scalar z1791 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z481;
    const Scalar z1792 = z1036 + l_lambda_rear_rolls_x * z212 + l_lambda_rear_rolls_y * z217 + l_lambda_front_touches
        * z177 + l_lambda_front_rolls_x * z186 + l_lambda_front_rolls_y * z198 - z98 * (l_lambda_rear_touches - z1783)
        - z1398 * z1757 - z1445 * z1790 + z1457 * z1756 - z1461 * z1791 - z1464 * z1758;
    const Scalar z1793 = z1012 + l_lambda_front_touches * z190 + l_lambda_front_rolls_x * z241 + l_lambda_front_rolls_y
        * z242 - z1399 * z1757 + z1439 * z1790 - z1444 * z1756 + z1448 * z1791 + z1459 * z1758;
    const Scalar z1794 = l_lambda_rear_rolls_x * z215 - z361 + l_lambda_rear_rolls_y * z209 - z1438 * z1790 - z1466
        * z1756 + z1472 * z1791 + z1474 * z1758;
    const Scalar z1795 = z1792 - z1753;
    const Scalar z1796 = z1793 + z1754;
    const Scalar z1797 = z1794 - z1755;
    const Scalar z1798 = z1654 * z1782;
    const Scalar z1799 = z1622 + z1654 * z1798;
    const Scalar z1800 = z1623 + z1655 * z1798;
    const Scalar z1801 = z1674 + z1675 * z1798;
    const Scalar z1802 = z1685 - z1686 * z1798;
    const Scalar z1803 = n1 / z1799;
    const Scalar z1804 = z1788 - z1789 * z1798;
    const Scalar z1805 = z1690 - z1691 * z1798;
    const Scalar z1806 = z1778 + z1780 * z1798;
    const Scalar z1807 = z1779 - z1781 * z1798;
    const Scalar z1808 = z1655 * z1782;
    const Scalar z1809 = z1618 - z1655 * z1808;
    const Scalar z1810 = z1800 * z1803;
    const Scalar z1811 = z1809 + z1800 * z1810;
    const Scalar z1812 = z1671 + z1675 * z1808 - z1810 * z1801;
    const Scalar z1813 = z1677 - z1686 * z1808 - z1810 * z1802;
    const Scalar z1814 = z1787 - z1789 * z1808 - z1810 * z1804;
    const Scalar z1815 = z1679 - z1691 * z1808 - z1810 * z1805;
    const Scalar z1816 = z1776 + z1780 * z1808 - z1810 * z1806;
    const Scalar z1817 = z1777 - z1781 * z1808 - z1810 * z1807;
    const Scalar z1818 = n1 / z1811;
    const Scalar z1819 = z1818 * z1812;
    const Scalar z1820 = z1818 * z1813;
    const Scalar z1821 = z1818 * z1814;
    const Scalar z1822 = z1818 * z1815;
    const Scalar z1823 = z1818 * z1816;
    const Scalar z1824 = z1818 * z1817;
    const Scalar z1825 = z1803 * z1801 + z1810 * z1819;
    const Scalar z1826 = z1803 * z1802 + z1810 * z1820;
    const Scalar z1827 = z1803 * z1804 + z1810 * z1821;
    const Scalar z1828 = z1803 * z1805 + z1810 * z1822;
    const Scalar z1829 = z1803 * z1806 + z1810 * z1823;
    const Scalar z1830 = z1803 * z1807 + z1810 * z1824;
    const Scalar z1831 = z1675 * z1782 + z1808 * z1819 - z1798 * z1825;
    const Scalar z1832 = z1686 * z1782 - z1808 * z1820 + z1798 * z1826;
    const Scalar z1833 = z1789 * z1782 - z1808 * z1821 + z1798 * z1827;
    const Scalar z1834 = z1691 * z1782 - z1808 * z1822 + z1798 * z1828;
    const Scalar z1835 = z1780 * z1782 + z1808 * z1823 - z1798 * z1829;
    const Scalar z1836 = z1781 * z1782 - z1808 * z1824 + z1798 * z1830;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z522;
    result.M[4] = -z559;
    result.M[5] = z539;
    result.M[6] = z423;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z529;
    result.M[13] = z560;
    result.M[14] = -z532;
    result.M[15] = z424;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z515;
    result.M[23] = z537;
    result.M[24] = z435;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z522;
    result.M[28] = -z529;
    result.M[29] = n0;
    result.M[30] = z531;
    result.M[31] = z562;
    result.M[32] = z541;
    result.M[33] = -z433;
    result.M[34] = z519;
    result.M[35] = z425;
    result.M[36] = -z559;
    result.M[37] = z560;
    result.M[38] = z515;
    result.M[39] = z562;
    result.M[40] = z510;
    result.M[41] = z533;
    result.M[42] = z434;
    result.M[43] = n0;
    result.M[44] = z457;
    result.M[45] = z539;
    result.M[46] = -z532;
    result.M[47] = z537;
    result.M[48] = z541;
    result.M[49] = z533;
    result.M[50] = z480;
    result.M[51] = -z399;
    result.M[52] = n0_12;
    result.M[53] = z410;
    result.M[54] = z423;
    result.M[55] = z424;
    result.M[56] = z435;
    result.M[57] = -z433;
    result.M[58] = z434;
    result.M[59] = -z399;
    result.M[60] = z6;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z519;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z425;
    result.M[76] = z457;
    result.M[77] = z410;
    result.M[78] = n0;
    result.M[79] = n0;
    result.M[80] = n0_28;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = n0;
    result.C[8] = n0;
    result.C[9] = n0;
    result.C[10] = n0;
    result.C[11] = n0;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = n0;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = n0;
    result.C[18] = n0;
    result.C[19] = n0;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = n0;
    result.C[23] = n0;
    result.C[24] = n0;
    result.C[25] = n0;
    result.C[26] = n0;
    result.C[27] = z690;
    result.C[28] = z688;
    result.C[29] = n0;
    result.C[30] = -z685;
    result.C[31] = z669;
    result.C[32] = -z695;
    result.C[33] = z739;
    result.C[34] = z755;
    result.C[35] = z829;
    result.C[36] = z686;
    result.C[37] = -z687;
    result.C[38] = z646;
    result.C[39] = z678;
    result.C[40] = z705;
    result.C[41] = z673;
    result.C[42] = -z738;
    result.C[43] = z783;
    result.C[44] = z828;
    result.C[45] = -z743;
    result.C[46] = z742;
    result.C[47] = z741;
    result.C[48] = -z753;
    result.C[49] = -z752;
    result.C[50] = -z663;
    result.C[51] = z732;
    result.C[52] = n0;
    result.C[53] = z811;
    result.C[54] = z831;
    result.C[55] = z830;
    result.C[56] = -z824;
    result.C[57] = -z834;
    result.C[58] = -z833;
    result.C[59] = -z777;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z820;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z755;
    result.C[67] = z749;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = z829;
    result.C[76] = -z827;
    result.C[77] = z810;
    result.C[78] = z821;
    result.C[79] = n0;
    result.C[80] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.K[25] = n0;
    result.K[26] = n0;
    result.K[27] = z709;
    result.K[28] = -z710;
    result.K[29] = n0;
    result.K[30] = z869;
    result.K[31] = -z856;
    result.K[32] = z859;
    result.K[33] = z862;
    result.K[34] = z860;
    result.K[35] = z866;
    result.K[36] = z694;
    result.K[37] = z693;
    result.K[38] = z677;
    result.K[39] = -z865;
    result.K[40] = z924;
    result.K[41] = -z923;
    result.K[42] = z922;
    result.K[43] = -z917;
    result.K[44] = z914;
    result.K[45] = z698;
    result.K[46] = -z697;
    result.K[47] = -z684;
    result.K[48] = z920;
    result.K[49] = z984;
    result.K[50] = z982;
    result.K[51] = -z979;
    result.K[52] = n0;
    result.K[53] = -z976;
    result.K[54] = -z779;
    result.K[55] = -z778;
    result.K[56] = -z774;
    result.K[57] = z981;
    result.K[58] = -z1045;
    result.K[59] = z1041;
    result.K[60] = z1068;
    result.K[61] = n0;
    result.K[62] = z1033;
    result.K[63] = n0;
    result.K[64] = n0;
    result.K[65] = n0;
    result.K[66] = n0;
    result.K[67] = n0;
    result.K[68] = n0;
    result.K[69] = n0;
    result.K[70] = n0;
    result.K[71] = n0;
    result.K[72] = n0;
    result.K[73] = n0;
    result.K[74] = n0;
    result.K[75] = n0;
    result.K[76] = n0;
    result.K[77] = n0;
    result.K[78] = n0;
    result.K[79] = n0;
    result.K[80] = n0;
    result.F[0] = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z479;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z481;
    result.F[2] = -l_lambda_rear_touches - l_lambda_front_touches + z474;
    result.F[3] = l_lambda_rear_rolls_x * z180 + l_lambda_rear_rolls_y * z178 + l_lambda_front_rolls_x * z182
        + l_lambda_front_rolls_y * z181 - z1042;
    result.F[4] = -l_lambda_rear_rolls_x * z212 + l_lambda_rear_touches * z98 - l_lambda_rear_rolls_y * z217
        - l_lambda_front_touches * z177 - l_lambda_front_rolls_x * z186 - l_lambda_front_rolls_y * z198 - z1036;
    result.F[5] = l_lambda_rear_rolls_x * z215 - z1009 + l_lambda_rear_rolls_y * z209 + l_lambda_front_touches * z175
        + l_lambda_front_rolls_x * z210 + l_lambda_front_rolls_y * z208;
    result.F[6] = z1012 + l_lambda_front_touches * z190 + l_lambda_front_rolls_x * z241 + l_lambda_front_rolls_y * z242;
    result.F[7] = l_lambda_rear_rolls_x * z215 - z361 + l_lambda_rear_rolls_y * z209;
    result.F[8] = l_lambda_front_rolls_x * z238 - z366 + l_lambda_front_rolls_y * z247;
    result.M_r[0] = z1618;
    result.M_r[1] = -z1623;
    result.M_r[2] = -z1655;
    result.M_r[3] = -z1623;
    result.M_r[4] = -z1622;
    result.M_r[5] = -z1654;
    result.M_r[6] = -z1655;
    result.M_r[7] = -z1654;
    result.M_r[8] = z1649;
    result.C_r[0] = z1671;
    result.C_r[1] = z1674;
    result.C_r[2] = z1675;
    result.C_r[3] = z1677;
    result.C_r[4] = z1685;
    result.C_r[5] = -z1686;
    result.C_r[6] = z1679;
    result.C_r[7] = z1690;
    result.C_r[8] = -z1691;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z1787;
    result.K_r[7] = z1788;
    result.K_r[8] = -z1789;
    result.K_r[9] = z1776;
    result.K_r[10] = z1778;
    result.K_r[11] = z1780;
    result.K_r[12] = z1777;
    result.K_r[13] = z1779;
    result.K_r[14] = -z1781;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = -z1795;
    result.F_r[1] = z1796;
    result.F_r[2] = z1797;
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
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = n0;
    result.A[20] = z1442;
    result.A[21] = -z1455;
    result.A[22] = -z1451;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z1460;
    result.A[27] = -z1821;
    result.A[28] = z1827;
    result.A[29] = z1833;
    result.A[30] = -z1443;
    result.A[31] = z1456;
    result.A[32] = z1452;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z1463;
    result.A[37] = -z1823;
    result.A[38] = z1829;
    result.A[39] = -z1835;
    result.A[40] = z1492;
    result.A[41] = -z1505;
    result.A[42] = -z1501;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z1507;
    result.A[47] = -z1824;
    result.A[48] = z1830;
    result.A[49] = z1836;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = n0;
    result.A[55] = n0;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = n0;
    result.A[67] = n0;
    result.A[68] = n0;
    result.A[69] = n0;
    result.A[70] = z1445;
    result.A[71] = -z1461;
    result.A[72] = -z1457;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z1819;
    result.A[78] = z1825;
    result.A[79] = -z1831;
    result.A[80] = z1439;
    result.A[81] = -z1448;
    result.A[82] = -z1444;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z1459;
    result.A[87] = -z1820;
    result.A[88] = z1826;
    result.A[89] = z1832;
    result.A[90] = -z1438;
    result.A[91] = -z1472;
    result.A[92] = -z1466;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z1474;
    result.A[97] = -z1822;
    result.A[98] = z1828;
    result.A[99] = z1834;
    if (!(traits::regular(z1424, z1437) && traits::regular(z1435, z1449) && traits::regular(z1409, z1468)
        && traits::regular(z1430, z1476) && traits::regular(z1811, z1618) && traits::regular(-z1799, -z1622)
        && traits::regular(z1649, z1649))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((n0 * result.M[3] * result.M[4] * result.M[5] * result.M[6] * result.M[12] * result.M[13]
        * result.M[14] * result.M[15] * result.M[22] * result.M[23] * result.M[24] * result.M[27]) * (n0 * result.M[28]
        * result.M[30] * result.M[31] * result.M[32] * result.M[33] * result.M[34] * result.M[35] * result.M[36]
        * result.M[37] * result.M[38] * result.M[39] * result.M[40])) * ((n0 * result.M[41] * result.M[42]
        * result.M[44] * result.M[45] * result.M[46] * result.M[47] * result.M[48] * result.M[49] * result.M[50]
        * result.M[51] * result.M[53] * result.M[54]) * (n0 * result.M[55] * result.M[56] * result.M[57] * result.M[58]
        * result.M[59] * result.M[60] * result.M[66] * result.M[75] * result.M[76] * result.M[77] * result.C[27]
        * result.C[28] * result.C[30]))) * (((n0 * result.C[31] * result.C[32] * result.C[33] * result.C[34]
        * result.C[35] * result.C[36] * result.C[37] * result.C[38] * result.C[39] * result.C[40] * result.C[41]
        * result.C[42]) * (n0 * result.C[43] * result.C[44] * result.C[45] * result.C[46] * result.C[47] * result.C[48]
        * result.C[49] * result.C[50] * result.C[51] * result.C[53] * result.C[54] * result.C[55])) * ((n0
        * result.C[56] * result.C[57] * result.C[58] * result.C[59] * result.C[62] * result.C[66] * result.C[67]
        * result.C[75] * result.C[76] * result.C[77] * result.C[78] * result.K[27]) * (n0 * result.K[28] * result.K[30]
        * result.K[31] * result.K[32] * result.K[33] * result.K[34] * result.K[35] * result.K[36] * result.K[37]
        * result.K[38] * result.K[39] * result.K[40] * result.K[41])))) * ((((n0 * result.K[42] * result.K[43]
        * result.K[44] * result.K[45] * result.K[46] * result.K[47] * result.K[48] * result.K[49] * result.K[50]
        * result.K[51] * result.K[53] * result.K[54]) * (n0 * result.K[55] * result.K[56] * result.K[57] * result.K[58]
        * result.K[59] * result.K[60] * result.K[62] * result.F[0] * result.F[1] * result.F[2] * result.F[3]
        * result.F[4])) * ((n0 * result.F[5] * result.F[6] * result.F[7] * result.F[8] * result.M_r[0] * result.M_r[1]
        * result.M_r[2] * result.M_r[3] * result.M_r[4] * result.M_r[5] * result.M_r[6] * result.M_r[7]) * (n0
        * result.M_r[8] * result.C_r[0] * result.C_r[1] * result.C_r[2] * result.C_r[3] * result.C_r[4] * result.C_r[5]
        * result.C_r[6] * result.C_r[7] * result.C_r[8] * result.K_r[6] * result.K_r[7] * result.K_r[8]))) * (((n0
        * result.K_r[9] * result.K_r[10] * result.K_r[11] * result.K_r[12] * result.K_r[13] * result.K_r[14]
        * result.F_r[0] * result.F_r[1] * result.F_r[2] * result.A[20] * result.A[21] * result.A[22]) * (n0
        * result.A[26] * result.A[27] * result.A[28] * result.A[29] * result.A[30] * result.A[31] * result.A[32]
        * result.A[36] * result.A[37] * result.A[38] * result.A[39] * result.A[40] * result.A[41])) * ((n0
        * result.A[42] * result.A[46] * result.A[47] * result.A[48] * result.A[49] * result.A[70] * result.A[71]
        * result.A[72] * result.A[77] * result.A[78] * result.A[79] * result.A[80]) * (n0 * result.A[81] * result.A[82]
        * result.A[86] * result.A[87] * result.A[88] * result.A[89] * result.A[90] * result.A[91] * result.A[92]
        * result.A[96] * result.A[97] * result.A[98] * result.A[99]))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace whipple_bicycle
