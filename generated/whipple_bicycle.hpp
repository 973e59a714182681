// SPDX-License-Identifier: MIT
// whipple_bicycle: Whipple's bicycle: two rolling wheels, benchmark of 2007
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: mass_matrix, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix              88              131          0             0                  4       0    227     232
//   forward_dynamics       1098             1467         26             2                  4       0   2601    2785
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             339              520         14             2                  4       0    883     941
//   linearisation          2887             3784        107             2                  6       0   6792    7263
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
  static constexpr unsigned long long fingerprint = 0xfdade6addd8fb2bcULL;
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
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z57 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z58 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z31 - k4 * z32;
    });
    const Scalar z59 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z31 - k5 * z32;
    });
    const Scalar z195 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z58 - z32 * z59;
    });
    const Scalar z200 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z204 = -z200 * (n1 - c_steer);
    const Scalar z205 = z31 * s_steer;
    const Scalar z206 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z202 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z203 = z32 * s_steer;
    const Scalar z239 = n2_8467 * c_steer;
    const Scalar z214 = c_steer * z57;
    const Scalar z208 = n0_28 * c_steer;
    const Scalar z263 = n0_12 * s_roll;
    const Scalar z207 = n0_28 * z203;
    const Scalar z209 = n0_28 * z205;
    const Scalar z213 = z57 * z203;
    const Scalar z215 = z57 * z205;
    const Scalar z217 = z58 * z203 + z59 * z205;
    const Scalar z232 = n1_04 * z203 - n3_85 * z205;
    const Scalar z236 = n2_8467 * z203;
    const Scalar z238 = k3 * z203 + k4 * z205;
    const Scalar z240 = k4 * z203 + k5 * z205;
    const Scalar z242 = n2_8467 * z205;
    const Scalar z210 = s_pitch * z209 - c_pitch * z207;
    const Scalar z211 = s_pitch * z207 + c_pitch * z209;
    const Scalar z222 = s_pitch * z215 - c_pitch * z213;
    const Scalar z223 = s_pitch * z213 + c_pitch * z215;
    const Scalar z234 = k4 * z204;
    const Scalar z216 = z59 * z204 + z58 * z202;
    const Scalar z218 = z58 * z204 + z59 * z206;
    const Scalar z231 = n1_04 * z202 - n3_85 * z204;
    const Scalar z233 = n1_04 * z204 - n3_85 * z206;
    const Scalar z237 = k5 * z204 + k4 * z202;
    const Scalar z241 = k3 * z204 + k4 * z206;
    const Scalar z235 = k3 * z202 + z234;
    const Scalar z243 = k5 * z206 + z234;
    const Scalar z220 = n0_3 * z213 - z217 + n1_1 * z215;
    const Scalar z245 = z202 * z238 - z203 * z239 + z204 * z240;
    const Scalar z246 = c_steer * z239 + z203 * z238 + z205 * z240;
    const Scalar z212 = s_roll * z208 + c_roll * z211;
    const Scalar z219 = n0_3 * z214 - z216;
    const Scalar z221 = n1_1 * z214 - z218;
    const Scalar z226 = s_roll * z223 - c_roll * z214;
    const Scalar z227 = s_roll * z214 + c_roll * z223;
    const Scalar z244 = z203 * z236 + z202 * z235 + z204 * z237;
    const Scalar z249 = z205 * z242 + z204 * z241 + z206 * z243;
    const Scalar z247 = z203 * z242 + z202 * z241 + z204 * z243;
    const Scalar z252 = n9_1 + n0_6 * z233 - n2_2 * z231 + z246;
    const Scalar z255 = n8_47 - n2_2 * z231 + z249;
    const Scalar z250 = n0_63 + n0_6 * z233 + z244;
    const Scalar z253 = n2_31 + n1_1 * z233 - n0_3 * z231 + z247;
    const Scalar z262 = n29_35 - z255;
    const Scalar z261 = n17_7 - z253;
    const Scalar z274 = z250 + z262;
    const Scalar z260 = n49_25 + z252;
    const Scalar z248 = c_steer * z242 - z203 * z241 - z205 * z243;
    const Scalar z275 = n2 * z261;
    const Scalar z251 = n1_1 * z232 + z245;
    const Scalar z276 = s_pitch * z274 - c_pitch * z275;
    const Scalar z264 = n0_12 + z260;
    const Scalar z257 = n2_1 + z233;
    const Scalar z254 = n0_3 * z232 + z248;
    const Scalar z282 = n39_8603 - z264;
    const Scalar z256 = n7_7 - z231;
    const Scalar z277 = s_pitch * z276;
    const Scalar z259 = n51 - z257;
    const Scalar z268 = s_pitch * z251 - c_pitch * z254;
    const Scalar z258 = n25_5 + z256;
    const Scalar z278 = z262 - z277;
    const Scalar z265 = c_pitch * z259 + s_pitch * z258;
    const Scalar z266 = s_pitch * z259 - c_pitch * z258;
    const Scalar z267 = s_pitch * z254 + c_pitch * z251;
    const Scalar z269 = s_roll * z266;
    const Scalar z225 = s_pitch * z219 + c_pitch * z221;
    const Scalar z280 = c_pitch * z276 + z261;
    const Scalar z279 = z250 - z277;
    const Scalar z283 = s_roll * z232 + c_roll * z265;
    const Scalar z224 = s_pitch * z221 - c_pitch * z219;
    const Scalar z284 = s_roll * z265 - c_roll * z232;
    const Scalar z228 = s_roll * z220 - c_roll * z225;
    const Scalar z288 = z278 - z282;
    const Scalar z229 = c_yaw * z222 + s_yaw * z226;
    const Scalar z289 = n2 * z268;
    const Scalar z230 = s_yaw * z222 - c_yaw * z226;
    const Scalar z290 = s_roll * z288 - c_roll * z289;
    const Scalar z270 = c_roll * z266;
    const Scalar z271 = s_roll * z264 - c_roll * z268;
    const Scalar z291 = s_roll * z290;
    const Scalar z272 = s_yaw * z269 - c_yaw * z265;
    const Scalar z273 = s_yaw * z265 + c_yaw * z269;
    const Scalar z292 = z278 - z291;
    const Scalar z281 = n39_8603 + z279;
    const Scalar z285 = s_roll * z267 - c_roll * z280;
    const Scalar z286 = s_yaw * z283;
    const Scalar z287 = c_yaw * z283;
    const Scalar z293 = n39_8603 - z292;
    const Scalar z294 = s_yaw * z266 - c_yaw * z284;
    const Scalar z295 = c_yaw * z266 + s_yaw * z284;
    mass[0] = n94;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z294;
    mass[4] = -z286;
    mass[5] = z272;
    mass[6] = z229;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n94;
    mass[11] = n0;
    mass[12] = -z295;
    mass[13] = z287;
    mass[14] = -z273;
    mass[15] = z230;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n94;
    mass[21] = n0;
    mass[22] = z284;
    mass[23] = z270;
    mass[24] = z227;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = z294;
    mass[28] = -z295;
    mass[29] = n0;
    mass[30] = z293;
    mass[31] = z285;
    mass[32] = z271;
    mass[33] = -z228;
    mass[34] = z263;
    mass[35] = z212;
    mass[36] = -z286;
    mass[37] = z287;
    mass[38] = z284;
    mass[39] = z285;
    mass[40] = z281;
    mass[41] = z267;
    mass[42] = z224;
    mass[43] = n0;
    mass[44] = z210;
    mass[45] = z272;
    mass[46] = -z273;
    mass[47] = z270;
    mass[48] = z271;
    mass[49] = z267;
    mass[50] = z264;
    mass[51] = -z220;
    mass[52] = n0_12;
    mass[53] = z208;
    mass[54] = z229;
    mass[55] = z230;
    mass[56] = z227;
    mass[57] = -z228;
    mass[58] = z224;
    mass[59] = -z220;
    mass[60] = z195;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = z263;
    mass[67] = n0;
    mass[68] = n0_12;
    mass[69] = n0;
    mass[70] = n0_12;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = z212;
    mass[76] = z210;
    mass[77] = z208;
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
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar k34 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k35 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar k36 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n9_95 = traits::constant(9.95, 9.95f, "199/20");
    const Scalar n39_3 = traits::constant(39.3, 39.3f, "393/10");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n0_5603 = traits::constant(0.5603, 0.5603f, "5603/10000");
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
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z57 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z58 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z31 - k4 * z32;
    });
    const Scalar z59 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z31 - k5 * z32;
    });
    const Scalar z195 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z58 - z32 * z59;
    });
    const Scalar z199 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z200 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z201 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z701 = traits::formula(6.497839117007668, 6.497839f, [&]() -> Scalar {
      return n1 / z195;
    });
    const Scalar z1004 = -z200 * (n1 - c_steer);
    const Scalar z1005 = z31 * s_steer;
    const Scalar z1006 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1002 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1003 = z32 * s_steer;
    const Scalar z1039 = n2_8467 * c_steer;
    const Scalar z1008 = n0_28 * c_steer;
    const Scalar z1014 = c_steer * z57;
    const Scalar z1063 = n0_12 * s_roll;
    const Scalar z1007 = n0_28 * z1003;
    const Scalar z1009 = n0_28 * z1005;
    const Scalar z1013 = z57 * z1003;
    const Scalar z1015 = z57 * z1005;
    const Scalar z1017 = z58 * z1003 + z59 * z1005;
    const Scalar z1032 = n1_04 * z1003 - n3_85 * z1005;
    const Scalar z1036 = n2_8467 * z1003;
    const Scalar z1038 = k3 * z1003 + k4 * z1005;
    const Scalar z1040 = k4 * z1003 + k5 * z1005;
    const Scalar z1042 = n2_8467 * z1005;
    const Scalar z1010 = s_pitch * z1009 - c_pitch * z1007;
    const Scalar z1011 = s_pitch * z1007 + c_pitch * z1009;
    const Scalar z1022 = s_pitch * z1015 - c_pitch * z1013;
    const Scalar z1023 = s_pitch * z1013 + c_pitch * z1015;
    const Scalar z1034 = k4 * z1004;
    const Scalar z1016 = z59 * z1004 + z58 * z1002;
    const Scalar z1018 = z58 * z1004 + z59 * z1006;
    const Scalar z1031 = n1_04 * z1002 - n3_85 * z1004;
    const Scalar z1033 = n1_04 * z1004 - n3_85 * z1006;
    const Scalar z1037 = k5 * z1004 + k4 * z1002;
    const Scalar z1041 = k3 * z1004 + k4 * z1006;
    const Scalar z1035 = k3 * z1002 + z1034;
    const Scalar z1043 = k5 * z1006 + z1034;
    const Scalar z1020 = n0_3 * z1013 - z1017 + n1_1 * z1015;
    const Scalar z1045 = z1002 * z1038 - z1003 * z1039 + z1004 * z1040;
    const Scalar z1046 = c_steer * z1039 + z1003 * z1038 + z1005 * z1040;
    const Scalar z1012 = s_roll * z1008 + c_roll * z1011;
    const Scalar z1019 = n0_3 * z1014 - z1016;
    const Scalar z1021 = n1_1 * z1014 - z1018;
    const Scalar z1026 = s_roll * z1023 - c_roll * z1014;
    const Scalar z1027 = s_roll * z1014 + c_roll * z1023;
    const Scalar z1044 = z1003 * z1036 + z1002 * z1035 + z1004 * z1037;
    const Scalar z1049 = z1005 * z1042 + z1004 * z1041 + z1006 * z1043;
    const Scalar z1052 = n9_1 + n0_6 * z1033 - n2_2 * z1031 + z1046;
    const Scalar z1047 = z1003 * z1042 + z1002 * z1041 + z1004 * z1043;
    const Scalar z1048 = c_steer * z1042 - z1003 * z1041 - z1005 * z1043;
    const Scalar z1055 = n8_47 - n2_2 * z1031 + z1049;
    const Scalar z1050 = n0_63 + n0_6 * z1033 + z1044;
    const Scalar z1053 = n2_31 + n1_1 * z1033 - n0_3 * z1031 + z1047;
    const Scalar z1062 = n29_35 - z1055;
    const Scalar z1061 = n17_7 - z1053;
    const Scalar z1060 = n49_25 + z1052;
    const Scalar z1051 = n1_1 * z1032 + z1045;
    const Scalar z1054 = n0_3 * z1032 + z1048;
    const Scalar z1057 = n2_1 + z1033;
    const Scalar z1056 = n7_7 - z1031;
    const Scalar z1059 = n51 - z1057;
    const Scalar z1058 = n25_5 + z1056;
    const Scalar z1074 = z1050 + z1062;
    const Scalar z1075 = n2 * z1061;
    const Scalar z1076 = s_pitch * z1074 - c_pitch * z1075;
    const Scalar z1064 = n0_12 + z1060;
    const Scalar z1082 = n39_8603 - z1064;
    const Scalar z1068 = s_pitch * z1051 - c_pitch * z1054;
    const Scalar z1067 = s_pitch * z1054 + c_pitch * z1051;
    const Scalar z1071 = s_roll * z1064 - c_roll * z1068;
    const Scalar z1080 = c_pitch * z1076 + z1061;
    const Scalar z1077 = s_pitch * z1076;
    const Scalar z1024 = s_pitch * z1021 - c_pitch * z1019;
    const Scalar z1025 = s_pitch * z1019 + c_pitch * z1021;
    const Scalar z1078 = z1062 - z1077;
    const Scalar z1079 = z1050 - z1077;
    const Scalar z1081 = n39_8603 + z1079;
    const Scalar z1085 = s_roll * z1067 - c_roll * z1080;
    const Scalar z1028 = s_roll * z1020 - c_roll * z1025;
    const Scalar z1088 = z1078 - z1082;
    const Scalar z1065 = c_pitch * z1059 + s_pitch * z1058;
    const Scalar z1066 = s_pitch * z1059 - c_pitch * z1058;
    const Scalar z1070 = c_roll * z1066;
    const Scalar z1084 = s_roll * z1065 - c_roll * z1032;
    const Scalar z1083 = s_roll * z1032 + c_roll * z1065;
    const Scalar z1069 = s_roll * z1066;
    const Scalar z1030 = s_yaw * z1022 - c_yaw * z1026;
    const Scalar z1029 = c_yaw * z1022 + s_yaw * z1026;
    const Scalar z1089 = n2 * z1068;
    const Scalar z1090 = s_roll * z1088 - c_roll * z1089;
    const Scalar z1073 = s_yaw * z1065 + c_yaw * z1069;
    const Scalar z1072 = s_yaw * z1069 - c_yaw * z1065;
    const Scalar z1091 = s_roll * z1090;
    const Scalar z1141 = n0_08 * z1002 - n0_35 * z1004;
    const Scalar z1144 = n1_1 - z1141;
    const Scalar z1092 = z1078 - z1091;
    const Scalar z1143 = n0_08 * z1004 - n0_35 * z1006;
    const Scalar z1145 = n0_3 + z1143;
    const Scalar z1087 = c_yaw * z1083;
    const Scalar z1093 = n39_8603 - z1092;
    const Scalar z1086 = s_yaw * z1083;
    const Scalar z1095 = c_yaw * z1066 + s_yaw * z1084;
    const Scalar z1094 = s_yaw * z1066 - c_yaw * z1084;
    const Scalar z1155 = s_pitch * z1005 - c_pitch * z1003;
    const Scalar z1147 = s_pitch * z1144 - c_pitch * z1145;
    const Scalar z1142 = n0_08 * z1003 - n0_35 * z1005;
    const Scalar z1148 = s_roll * z1147 - c_roll * z1142;
    const Scalar z1146 = s_pitch * z1145 + c_pitch * z1144;
    const Scalar z1149 = s_roll * z1142 + c_roll * z1147;
    const Scalar z1096 = s_yaw * c_roll;
    const Scalar z1156 = s_pitch * z1003 + c_pitch * z1005;
    const Scalar z1150 = s_yaw * z1148 - c_yaw * z1146;
    const Scalar z1152 = q_z - z1149;
    const Scalar z1100 = n1 - s_roll * s_roll;
    const Scalar z1098 = s_roll * z1096;
    const Scalar z1097 = c_yaw * c_roll;
    const Scalar z1157 = s_roll * z1156 - c_roll * c_steer;
    const Scalar z1158 = s_roll * c_steer + c_roll * z1156;
    const Scalar z1154 = q_x - z1150;
    const Scalar z1099 = s_roll * z1097;
    const Scalar z1159 = c_yaw * z1155 + s_yaw * z1157;
    const Scalar z1160 = s_yaw * z1155 - c_yaw * z1157;
    const Scalar z1151 = s_yaw * z1146 + c_yaw * z1148;
    const Scalar z1153 = q_y + z1151;
    const Scalar z1101 = z1100 * z1100 + z1098 * z1098 + z1099 * z1099;
    const Scalar z1102 = traits::sqrt(z1101);
    const Scalar z1161 = z1158 * z1159;
    const Scalar z1162 = z1158 * z1160;
    const Scalar z1109 = v_roll * s_roll;
    const Scalar z1108 = v_yaw * c_yaw;
    const Scalar z1107 = v_roll * c_roll;
    const Scalar z1112 = v_yaw * s_yaw;
    const Scalar z1119 = s_yaw * s_roll;
    const Scalar z1120 = s_roll * z1119 - c_roll * z1096;
    const Scalar z1115 = n2 * s_roll;
    const Scalar z1121 = c_yaw * s_roll;
    const Scalar z1122 = s_roll * z1121 - c_roll * z1097;
    const Scalar z1123 = c_roll * z1115;
    const Scalar z1116 = z1107 * z1115;
    const Scalar z1131 = v_roll * z1109;
    const Scalar z1110 = s_yaw * z1109 - c_roll * z1108;
    const Scalar z1128 = v_yaw * z1112;
    const Scalar z1127 = v_roll * z1107;
    const Scalar z1134 = v_yaw * z1108;
    const Scalar z1113 = c_yaw * z1109 + c_roll * z1112;
    const Scalar z1124 = n2 * (z1100 * z1123 + z1098 * z1120 + z1099 * z1122);
    const Scalar z1111 = s_roll * z1110 - z1096 * z1107;
    const Scalar z1103 = n0_3 / z1102;
    const Scalar z1163 = n1 - z1158 * z1158;
    const Scalar z1114 = s_roll * z1113 - z1097 * z1107;
    const Scalar z1117 = n2 * (z1100 * z1116 + z1098 * z1111 + z1099 * z1114);
    const Scalar z1125 = n0_5 * z1124 / z1102;
    const Scalar z1129 = n2 * z1109;
    const Scalar z1132 = n2 * z1107;
    const Scalar z1130 = s_yaw * z1127 + c_roll * z1128 + z1108 * z1129;
    const Scalar z1135 = c_yaw * z1127 + c_roll * z1134 - z1112 * z1129;
    const Scalar z1133 = z1096 * z1131 + z1110 * z1132 + s_roll * z1130;
    const Scalar z1136 = z1097 * z1131 + z1113 * z1132 + s_roll * z1135;
    const Scalar z1106 = q_z + z1100 * z1103;
    const Scalar z1104 = q_x + z1098 * z1103;
    const Scalar z1164 = z1163 * z1163 + z1161 * z1161 + z1162 * z1162;
    const Scalar z1126 = n0_3 * z1125;
    const Scalar z1105 = q_y - z1099 * z1103;
    const Scalar z1165 = traits::sqrt(z1164);
    const Scalar z1174 = v_pitch * c_pitch;
    const Scalar z1170 = v_steer * c_steer;
    const Scalar z1175 = v_steer * s_steer;
    const Scalar z1171 = z32 * z1170;
    const Scalar z1172 = z31 * z1170;
    const Scalar z1177 = z200 * z1175;
    const Scalar z1176 = -z1175 * (n1 - z199);
    const Scalar z1173 = n0_08 * z1171 - n0_35 * z1172;
    const Scalar z1118 = n0_5 * z1117 / z1102;
    const Scalar z1178 = n0_35 * z1177 + n0_08 * z1176;
    const Scalar z1193 = n2 * z1158;
    const Scalar z1179 = v_pitch * s_pitch;
    const Scalar z1185 = z1003 * z1174 - z1005 * z1179 + s_pitch * z1171 + c_pitch * z1172;
    const Scalar z1188 = z1003 * z1179 + z1005 * z1174 + s_pitch * z1172 - c_pitch * z1171;
    const Scalar z1166 = n0_35 / z1165;
    const Scalar z1180 = -z1175 * (n1 - z201);
    const Scalar z1181 = n0_08 * z1177 + n0_35 * z1180;
    const Scalar z1137 = n2 * (s_roll * z1131 - z1107 * z1107);
    const Scalar z1138 = n2 * (z1098 * z1133 + z1099 * z1136 - z1100 * z1137 - z1111 * z1111 - z1114 * z1114 - z1116
        * z1116);
    const Scalar z1197 = s_yaw * z1158;
    const Scalar z1198 = z1157 * z1159 - z1158 * z1197;
    const Scalar z1167 = z1154 - z1161 * z1166;
    const Scalar z1169 = z1152 + z1163 * z1166;
    const Scalar z1168 = z1153 - z1162 * z1166;
    const Scalar z1187 = c_roll * z1175 + c_steer * z1109 + z1107 * z1156 + s_roll * z1185;
    const Scalar z1191 = z1108 * z1155 + z1112 * z1157 + s_yaw * z1188 - c_yaw * z1187;
    const Scalar z1186 = s_roll * z1175 - c_steer * z1107 + z1109 * z1156 - c_roll * z1185;
    const Scalar z1139 = n0_5 * (z1117 * z1118 / (z1102 * z1102) + z1138 / z1102);
    const Scalar z1199 = c_yaw * z1158;
    const Scalar z1189 = z1108 * z1157 - z1112 * z1155 + c_yaw * z1188 + s_yaw * z1187;
    const Scalar z1194 = z1186 * z1193;
    const Scalar z1192 = z1158 * z1191 - z1160 * z1186;
    const Scalar z1190 = z1158 * z1189 - z1159 * z1186;
    const Scalar z1182 = s_pitch * z1178 - c_pitch * z1181 - z1144 * z1174 - z1145 * z1179;
    const Scalar z1195 = n2 * (z1163 * z1194 + z1162 * z1192 + z1161 * z1190);
    const Scalar z1140 = n0_3 * z1139;
    const Scalar z1200 = z1158 * z1199 + z1157 * z1160;
    const Scalar z1242 = v_steer * z1170;
    const Scalar z1216 = z32 * c_steer;
    const Scalar z1217 = z31 * c_steer;
    const Scalar z1207 = s_roll * z1155;
    const Scalar z1226 = s_pitch * z1216 + c_pitch * z1217;
    const Scalar z1229 = s_pitch * z1217 - c_pitch * z1216;
    const Scalar z1218 = n0_08 * z1216 - n0_35 * z1217;
    const Scalar z1208 = s_yaw * z1207 - c_yaw * z1156;
    const Scalar z1210 = s_yaw * z1156 + c_yaw * z1207;
    const Scalar z1228 = c_roll * s_steer + s_roll * z1226;
    const Scalar z1227 = s_roll * s_steer - c_roll * z1226;
    const Scalar z1206 = c_roll * z1155;
    const Scalar z1209 = z1158 * z1208 + z1159 * z1206;
    const Scalar z1211 = z1158 * z1210 - z1160 * z1206;
    const Scalar z1212 = z1193 * z1206;
    const Scalar z1230 = c_yaw * z1229 + s_yaw * z1228;
    const Scalar z1213 = n2 * (z1161 * z1209 - z1162 * z1211 - z1163 * z1212);
    const Scalar z1232 = s_yaw * z1229 - c_yaw * z1228;
    const Scalar z1231 = z1158 * z1230 - z1159 * z1227;
    const Scalar z1233 = z1158 * z1232 - z1160 * z1227;
    const Scalar z1234 = z1193 * z1227;
    const Scalar z1201 = z1157 * z1193;
    const Scalar z1202 = n2 * (z1162 * z1200 - z1163 * z1201 + z1161 * z1198);
    const Scalar z1235 = n2 * (z1163 * z1234 + z1161 * z1231 + z1162 * z1233);
    const Scalar z1214 = n0_5 * z1213 / z1165;
    const Scalar z1220 = s_steer * z200;
    const Scalar z1219 = s_steer * (n1 - z199);
    const Scalar z1221 = n0_08 * z1219 - n0_35 * z1220;
    const Scalar z1222 = s_steer * (n1 - z201);
    const Scalar z1223 = n0_08 * z1220 - n0_35 * z1222;
    const Scalar z1203 = n0_5 * z1202 / z1165;
    const Scalar z1236 = n0_5 * z1235 / z1165;
    const Scalar z1205 = c_roll * z1146;
    const Scalar z1238 = v_steer * z1175;
    const Scalar z1224 = c_pitch * z1223 + s_pitch * z1221;
    const Scalar z1239 = z32 * z1238;
    const Scalar z1240 = z31 * z1238;
    const Scalar z1196 = n0_5 * z1195 / z1165;
    const Scalar z1183 = z1107 * z1142 + s_roll * z1173 - z1109 * z1147 - c_roll * z1182;
    const Scalar z1225 = s_roll * z1218 + c_roll * z1224;
    const Scalar z1215 = z1205 + n0_35 * z1214;
    const Scalar z1184 = v_z - z1183;
    const Scalar z1248 = v_pitch * z1179;
    const Scalar z1249 = v_pitch * z1174;
    const Scalar z1252 = z1003 * z1248 + z1005 * z1249 + s_pitch * z1239 + c_pitch * z1240 - n2 * (z1171 * z1174 - z1172
        * z1179);
    const Scalar z1237 = z1225 - n0_35 * z1236;
    const Scalar z1254 = z1005 * z1248 - z1003 * z1249 + s_pitch * z1240 - c_pitch * z1239 - n2 * (z1171 * z1179 + z1172
        * z1174);
    const Scalar z1241 = n0_08 * z1239 - n0_35 * z1240;
    const Scalar z1204 = z1148 - n0_35 * z1203;
    const Scalar z1272 = n0_3 * z1118 / (z1102 * z1102);
    const Scalar z1275 = v_z - z1103 * z1116 + z1100 * z1272;
    const Scalar z1273 = v_y + z1103 * z1114 - z1099 * z1272;
    const Scalar z1280 = v_x - z1103 * z1111 + z1098 * z1272;
    const Scalar z1267 = q_z - z1106;
    const Scalar z1265 = q_x - z1104;
    const Scalar z1266 = q_y - z1105;
    const Scalar z1276 = v_z - z1275;
    const Scalar z1274 = v_y - z1273;
    const Scalar z1281 = v_x - z1280;
    const Scalar z1299 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1300 = s_roll * z1299;
    const Scalar z1298 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z1293 = s_pitch * z31 - c_pitch * z32;
    const Scalar z1302 = s_yaw * z1300 - c_yaw * z1298;
    const Scalar z1294 = s_roll * z1293;
    const Scalar z1301 = c_roll * z1299;
    const Scalar z1292 = s_pitch * z32 + c_pitch * z31;
    const Scalar z1285 = q_x - z1167;
    const Scalar z1295 = c_roll * z1293;
    const Scalar z1287 = q_z - z1169;
    const Scalar z1296 = s_yaw * z1294 - c_yaw * z1292;
    const Scalar z1289 = c_yaw * z1287;
    const Scalar z1291 = s_roll * z1285 + z1096 * z1287;
    const Scalar z1286 = q_y - z1168;
    const Scalar z1297 = s_yaw * z1292 + c_yaw * z1294;
    const Scalar z1288 = s_yaw * z1287;
    const Scalar z1290 = s_roll * z1286 - z1097 * z1287;
    const Scalar z1269 = c_yaw * z1267;
    const Scalar z1268 = s_yaw * z1267;
    const Scalar z1271 = s_roll * z1265 + z1096 * z1267;
    const Scalar z1257 = n2 * z1186;
    const Scalar z1253 = z1131 * z1156 - c_roll * z1242 - c_steer * z1127 - n2 * (z1107 * z1185 - z1109 * z1175)
        + s_roll * z1252;
    const Scalar z1256 = s_roll * z1242 + c_steer * z1131 + z1127 * z1156 + n2 * (z1107 * z1175 + z1109 * z1185)
        + c_roll * z1252;
    const Scalar z1259 = z1128 * z1155 - z1134 * z1157 - n2 * (z1108 * z1188 + z1112 * z1187) + s_yaw * z1254 - c_yaw
        * z1253;
    const Scalar z1255 = z1134 * z1155 + z1128 * z1157 - n2 * (z1108 * z1187 - z1112 * z1188) + c_yaw * z1254 + s_yaw
        * z1253;
    const Scalar z1260 = z1191 * z1257 + z1160 * z1256 + z1158 * z1259;
    const Scalar z1258 = z1189 * z1257 + z1159 * z1256 + z1158 * z1255;
    const Scalar z1261 = n2 * (z1158 * z1256 - z1186 * z1186);
    const Scalar z1262 = n2 * (z1162 * z1260 - z1194 * z1194 - z1192 * z1192 - z1190 * z1190 - z1163 * z1261 + z1161
        * z1258);
    const Scalar z1270 = s_roll * z1266 - z1097 * z1267;
    const Scalar z1244 = z200 * z1242;
    const Scalar z1243 = -z1242 * (n1 - z199);
    const Scalar z1304 = q_z - z1301;
    const Scalar z1245 = n0_35 * z1244 + n0_08 * z1243;
    const Scalar z1246 = -z1242 * (n1 - z201);
    const Scalar z1247 = n0_08 * z1244 + n0_35 * z1246;
    const Scalar z1306 = q_x - z1302;
    const Scalar z1307 = z1167 - z1306;
    const Scalar z1309 = z1169 - z1304;
    const Scalar z1303 = s_yaw * z1298 + c_yaw * z1300;
    const Scalar z1250 = s_pitch * z1245 - z1145 * z1249 - c_pitch * z1247 + z1144 * z1248 + n2 * (z1174 * z1178 + z1179
        * z1181);
    const Scalar z1263 = n0_5 * (z1195 * z1196 / (z1165 * z1165) + z1262 / z1165);
    const Scalar z1305 = q_y + z1303;
    const Scalar z1308 = z1168 - z1305;
    const Scalar z1277 = z1108 * z1267 + s_yaw * z1276;
    const Scalar z1282 = c_yaw * z1276 - z1112 * z1267;
    const Scalar z1310 = z1295 * z1308 + z1297 * z1309;
    const Scalar z1278 = z1107 * z1266 + z1113 * z1267 + s_roll * z1274 - z1097 * z1276;
    const Scalar z1251 = z1131 * z1142 + s_roll * z1241 + z1127 * z1147 - n2 * (z1107 * z1173 + z1109 * z1182) + c_roll
        * z1250;
    const Scalar z1318 = c_roll * z1173 - z1109 * z1142 - z1107 * z1147 + s_roll * z1182;
    const Scalar z1317 = s_pitch * z1181 + c_pitch * z1178 + z1144 * z1179 - z1145 * z1174;
    const Scalar z1279 = v_yaw * z1274 - v_roll * z1277 + z1278 * (v_pitch + v_rear);
    const Scalar z1312 = z1154 - z1167;
    const Scalar z1314 = z1152 - z1169;
    const Scalar z1313 = z1153 - z1168;
    const Scalar z1321 = n0_35 * z1196 / (z1165 * z1165);
    const Scalar z1283 = z1107 * z1265 - z1110 * z1267 + s_roll * z1281 + z1096 * z1276;
    const Scalar z1284 = v_yaw * z1281 - v_roll * z1282 + z1283 * (v_pitch + v_rear);
    const Scalar z1264 = z1251 - n0_35 * z1263;
    const Scalar z1324 = z1163 * z1321 - z1184 - z1166 * z1194;
    const Scalar z1344 = z1184 + z1324;
    const Scalar z1311 = z1295 * z1307 - z1296 * z1309;
    const Scalar z1316 = z1158 * z1312 - z1159 * z1314;
    const Scalar z1315 = z1158 * z1313 - z1160 * z1314;
    const Scalar z1361 = v_yaw * s_roll;
    const Scalar z1362 = v_yaw * c_roll;
    const Scalar z1373 = v_pitch + z1361;  // angular velocity of frame, y
    const Scalar z1366 = v_roll * z1361;  // angular acceleration of frame.2, z
    const Scalar z1367 = v_roll * c_pitch - s_pitch * z1362;
    const Scalar z1368 = v_roll * s_pitch + c_pitch * z1362;
    const Scalar z1369 = s_pitch * z1366;
    const Scalar z1370 = c_pitch * z1366;
    const Scalar z1364 = n9_81 * c_roll;
    const Scalar z1374 = v_pitch * z1368 - z1369;  // angular acceleration of frame, x
    const Scalar z1375 = v_pitch * z1367 - z1370;  // angular acceleration of frame, z
    const Scalar z1365 = v_roll * z1362;  // angular acceleration of frame.2, y
    const Scalar z1377 = z1373 * z1373;
    const Scalar z1378 = z1368 * z1368;
    const Scalar z1371 = s_pitch * z1364;
    const Scalar z1372 = c_pitch * z1364;
    const Scalar z1363 = n9_81 * s_roll;
    const Scalar z1376 = v_rear + z1373;  // angular velocity of rear_wheel, y
    const Scalar z1330 = n0_3 * z1174 - n1_1 * z1179;
    const Scalar z1347 = s_yaw * z1318 - c_yaw * z1317 - z1108 * z1148 - z1112 * z1146;
    const Scalar z1319 = s_yaw * z1317 - z1108 * z1146 + z1112 * z1148 + c_yaw * z1318;
    const Scalar z1348 = v_x + z1347;
    const Scalar z1349 = z1348 - z1166 * z1190 + z1161 * z1321;
    const Scalar z1320 = v_y - z1319;
    const Scalar z1322 = z1320 - z1166 * z1192 + z1162 * z1321;
    const Scalar z1379 = z1377 + z1378;
    const Scalar z1380 = z1367 * z1368;
    const Scalar z1382 = z1367 * z1373;
    const Scalar z1381 = z1365 + z1380;
    const Scalar z1336 = z31 * z1179 - z32 * z1174;
    const Scalar z1358 = z1348 - z1349;
    const Scalar z1328 = z31 * z1174 + z32 * z1179;
    const Scalar z1331 = n1_1 * z1174 + n0_3 * z1179;
    const Scalar z1359 = z1158 * z1358 - z1186 * z1312 - z1189 * z1314 - z1159 * z1344;
    const Scalar z1343 = z1320 - z1322;
    const Scalar z1345 = z1158 * z1343 - z1186 * z1313 - z1191 * z1314 - z1160 * z1344;
    const Scalar z1332 = z1107 * z1299 + s_roll * z1331;
    const Scalar z1339 = c_roll * z1331 - z1109 * z1299;
    const Scalar z1329 = c_roll * z1328 - z1109 * z1293;
    const Scalar z1337 = z1107 * z1293 + s_roll * z1328;
    const Scalar z1340 = v_z - z1339;
    const Scalar z1341 = z1324 + z1340;
    const Scalar z1325 = v_z + z1324;
    const Scalar z1353 = z1112 * z1298 - c_yaw * z1330 + z1108 * z1300 + s_yaw * z1332;
    const Scalar z1333 = z1108 * z1298 + s_yaw * z1330 - z1112 * z1300 + c_yaw * z1332;
    const Scalar z1354 = v_x - z1353;
    const Scalar z1355 = z1349 - z1354;
    const Scalar z1350 = v_x - z1349;
    const Scalar z1352 = z1107 * z1285 - z1110 * z1287 + s_roll * z1350 + z1096 * z1325;
    const Scalar z1334 = v_y + z1333;
    const Scalar z1335 = z1322 - z1334;
    const Scalar z1323 = v_y - z1322;
    const Scalar z1327 = z1107 * z1286 + z1113 * z1287 + s_roll * z1323 - z1097 * z1325;
    const Scalar z1383 = z1375 + z1382;
    const Scalar z1384 = z1368 * z1373;
    const Scalar z1385 = z1374 + z1384;
    const Scalar z1356 = z1112 * z1292 + c_yaw * z1336 + z1108 * z1294 + s_yaw * z1337;
    const Scalar z1338 = s_yaw * z1336 - z1108 * z1292 + z1112 * z1294 - c_yaw * z1337;
    const Scalar z1357 = z1307 * z1329 - z1309 * z1356 + z1295 * z1355 + z1296 * z1341;
    const Scalar z1342 = z1308 * z1329 - z1309 * z1338 + z1295 * z1335 - z1297 * z1341;
    const Scalar z1326 = z1108 * z1287 + s_yaw * z1325;
    const Scalar z1351 = c_yaw * z1325 - z1112 * z1287;
    const Scalar z1360 = v_yaw * z1350 + v_pitch * z1352 + v_steer * z1357 - v_roll * z1351 + v_front * z1359;
    const Scalar z1346 = v_yaw * z1323 - v_roll * z1326 + v_pitch * z1327 + v_steer * z1342 + v_front * z1345;
    const Scalar z1391 = z1005 * z1373 + z1004 * z1367 - z1006 * z1368;
    const Scalar z1386 = z1365 - z1380;
    const Scalar z1404 = z32 * v_steer;
    const Scalar z1387 = z1367 * z1367;
    const Scalar z1388 = z1377 + z1387;
    const Scalar z1445 = z1378 - z1387;
    const Scalar z1389 = z1003 * z1373 - z1004 * z1368 + z1002 * z1367;
    const Scalar z1390 = c_steer * z1373 - z1003 * z1367 + z1005 * z1368;
    const Scalar z1441 = z1367 * z1376;
    const Scalar z1440 = z1368 * z1376;
    const Scalar z1444 = n0_12 * z1441;  // moment on rear_wheel, z
    const Scalar z1442 = n0_12 * z1440;  // moment on rear_wheel, x
    const Scalar z1402 = z31 * v_steer;
    const Scalar z1405 = z1391 - z1404;  // angular velocity of fork, z
    const Scalar z1401 = z31 * z1391 + z32 * z1389;
    const Scalar z1403 = z1389 + z1402;  // angular velocity of fork, x
    const Scalar z1393 = c_steer * z1365 + z1003 * z1374 + z1005 * z1375;
    const Scalar z1407 = v_steer * z1401 - z1393;  // angular acceleration of fork, y
    const Scalar z1395 = z1371 - n1_1 * z1379 + n0_3 * z1381;
    const Scalar z1409 = z1390 * z1390;
    const Scalar z1410 = z1405 * z1405;
    const Scalar z1396 = z1363 - n1_1 * z1383 - n0_3 * z1385;
    const Scalar z1397 = z1372 + n1_1 * z1386 + n0_3 * z1388;
    const Scalar z1411 = z1409 + z1410;
    const Scalar z1412 = z1403 * z1405;
    const Scalar z1394 = z1004 * z1374 - z1005 * z1365 + z1006 * z1375;
    const Scalar z1392 = z1002 * z1374 - z1003 * z1365 + z1004 * z1375;
    const Scalar z1408 = z1390 * z1402 - z1394;  // angular acceleration of fork, z
    const Scalar z1406 = z1390 * z1404 - z1392;  // angular acceleration of fork, x
    const Scalar z1456 = z1361 * z1362;
    const Scalar z1457 = n2 * z1366;
    const Scalar z1413 = z1407 + z1412;
    const Scalar z1418 = z1407 - z1412;
    const Scalar z1419 = z1403 * z1403;
    const Scalar z1420 = z1409 + z1419;
    const Scalar z1427 = z1410 - z1419;
    const Scalar z1421 = v_front + z1390;  // angular velocity of front_wheel, y
    const Scalar z1398 = z1002 * z1395 - z1003 * z1396 + z1004 * z1397;
    const Scalar z1428 = n1_04 * z1411 + n3_85 * z1413 + n7 * z1398;  // force on fork, x
    const Scalar z1399 = z1003 * z1395 + z1005 * z1397 + c_steer * z1396;
    const Scalar z1400 = z1004 * z1395 - z1005 * z1396 + z1006 * z1397;
    const Scalar z1430 = n1_04 * z1418 - n3_85 * z1420 + n7 * z1400;  // force on fork, z
    const Scalar z1469 = n25_over_7 * z1008;
    const Scalar z1473 = z1012 * z1469 - z1071;
    const Scalar z1468 = n25_over_7 * z1010;
    const Scalar z1472 = z1010 * z1468 - z1081;
    const Scalar z1471 = z1012 * z1468 - z1085;
    const Scalar z1467 = n25_over_7 * z1012;
    const Scalar z1470 = z1012 * z1467 - z1093;
    const Scalar z1414 = z1390 * z1403;
    const Scalar z1474 = z1010 * z1469 - z1067;
    const Scalar z1423 = z1403 * z1421;
    const Scalar z1416 = z1390 * z1405;
    const Scalar z1422 = z1405 * z1421;
    const Scalar z1426 = n0_28 * z1423;  // moment on front_wheel, z
    const Scalar z1424 = n0_28 * z1422;  // moment on front_wheel, x
    const Scalar z1415 = z1408 - z1414;
    const Scalar z1475 = n25_over_3 * z1063;
    const Scalar z1476 = z1063 * z1475 + z1470;
    const Scalar z1431 = n3_85 * z1399 - z1424 - k34 * z1416 - k3 * z1406 - k4 * z1415;  // moment on fork, x
    const Scalar z1417 = z1406 + z1416;
    const Scalar z1433 = k35 * z1414 + z1426 - k5 * z1408 - k4 * z1417 + n1_04 * z1399;  // moment on fork, z
    const Scalar z1429 = n7 * z1399 - n1_04 * z1415 - n3_85 * z1417;  // force on fork, y
    const Scalar z1478 = c_steer * z1008 - z1060;
    const Scalar z1477 = z1063 + z1473;
    const Scalar z1484 = z701 * z1020;
    const Scalar z1483 = z701 * z1024;
    const Scalar z1482 = z701 * z1028;
    const Scalar z1481 = z701 * z1027;
    const Scalar z1480 = z701 * z1030;
    const Scalar z1479 = z701 * z1029;
    const Scalar z1425 = n0_28 * z1407;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z1432 = z1425 + k36 * z1412 + k4 * z1427 + n2_5667 * z1407 + n3_85 * z1398 + n1_04 * z1400;
    const Scalar z1492 = z1030 * z1482 - z1095;
    const Scalar z1491 = z1029 * z1482 + z1094;
    const Scalar z1493 = z1027 * z1482;
    const Scalar z1490 = n94 - z1027 * z1481;
    const Scalar z1489 = z1030 * z1481;
    const Scalar z1487 = n94 - z1030 * z1480;
    const Scalar z1486 = z1029 * z1480;
    const Scalar z1488 = z1029 * z1481;
    const Scalar z1485 = n94 - z1029 * z1479;
    const Scalar z1443 = n0_12 * z1365;  // moment on rear_wheel, y
    const Scalar z1434 = z1002 * z1428 + z1004 * z1430 + z1003 * z1429;
    const Scalar z1446 = n25_5 * z1379 - z1434 + n51 * z1381;  // force on frame, x
    const Scalar z1494 = z1028 * z1482 + z1476;
    const Scalar z1436 = z1004 * z1428 + z1006 * z1430 + z1005 * z1429;
    const Scalar z1435 = c_steer * z1429 - z1003 * z1428 - z1005 * z1430;
    const Scalar z1448 = z1436 + n25_5 * z1386 - n51 * z1388;  // force on frame, z
    const Scalar z1496 = z1030 * z1483 - z1087;
    const Scalar z1495 = z1029 * z1483 + z1086;
    const Scalar z1439 = z1006 * z1433 + z1004 * z1431 - z1005 * z1432;
    const Scalar z1437 = z1004 * z1433 + z1002 * z1431 - z1003 * z1432;
    const Scalar z1438 = z1005 * z1433 + z1003 * z1431 + c_steer * z1432;
    // moment on frame, y
    const Scalar z1450 = z1443 + n49_25 * z1365 - n51 * z1371 + n25_5 * z1372 + n29_35 * z1380 + n17_7 * z1445 + n0_3
        * z1434 + n1_1 * z1436 - z1438;
    const Scalar z1505 = z1020 * z1484 + z1478;
    const Scalar z1501 = z1030 * z1484 - z1073;
    const Scalar z1500 = z1029 * z1484 + z1072;
    // moment on frame, z
    const Scalar z1451 = n25_5 * z1363 - z1444 - n9_95 * z1383 + n17_7 * z1385 + n1_1 * z1435 - z1439;
    // moment on frame, x
    const Scalar z1449 = n51 * z1363 + z1442 - n17_7 * z1383 + n39_3 * z1385 - n0_3 * z1435 + z1437;
    const Scalar z1447 = n25_5 * z1383 - z1435 - n51 * z1385;  // force on frame, y
    const Scalar z1466 = z31 * z1431 - z32 * z1433;
    const Scalar z1504 = z1024 * z1484 - z1474;
    const Scalar z1499 = z1024 * z1483 + z1472;
    const Scalar z1506 = n1 / z1505;
    const Scalar z1498 = z1028 * z1483 - z1471;
    const Scalar z1503 = z1028 * z1484 + z1477;
    const Scalar z1497 = z1027 * z1483 - z1084;
    const Scalar z1502 = z1027 * z1484 + z1070;
    const Scalar z1511 = z1504 * z1506;
    const Scalar z1510 = z1503 * z1506;
    const Scalar z1509 = z1502 * z1506;
    const Scalar z1508 = z1501 * z1506;
    const Scalar z1507 = z1500 * z1506;
    const Scalar z1453 = s_pitch * z1446 - c_pitch * z1448;
    const Scalar z1452 = s_pitch * z1448 + c_pitch * z1446;
    const Scalar z1513 = z1486 - z1500 * z1508;
    const Scalar z1512 = z1485 + z1500 * z1507;
    const Scalar z1460 = s_roll * z1453 - c_roll * z1447;
    const Scalar z1461 = s_roll * z1447 + c_roll * z1453;
    const Scalar z1465 = n853_47 - z1461;  // force on frame.z, z
    const Scalar z1454 = s_pitch * z1451 + c_pitch * z1449;
    const Scalar z1455 = s_pitch * z1449 - c_pitch * z1451;
    const Scalar z1458 = z1454 - n0_5603 * z1456;  // moment on frame.2, x
    const Scalar z1459 = z1455 - n0_5603 * z1457;  // moment on frame.2, z
    const Scalar z1521 = z1494 - z1503 * z1510;
    const Scalar z1520 = z1493 - z1502 * z1510;
    const Scalar z1517 = z1490 + z1502 * z1509;
    const Scalar z1516 = z1489 - z1501 * z1509;
    const Scalar z1519 = z1492 - z1501 * z1510;
    const Scalar z1514 = z1487 + z1501 * z1508;
    const Scalar z1515 = z1488 - z1500 * z1509;
    const Scalar z1518 = z1491 - z1500 * z1510;
    const Scalar z1462 = s_roll * z1450 + c_roll * z1459;
    const Scalar z1522 = z1495 - z1500 * z1511;
    const Scalar z1463 = s_yaw * z1460 - c_yaw * z1452;
    const Scalar z1523 = z1496 - z1501 * z1511;
    const Scalar z1464 = s_yaw * z1452 + c_yaw * z1460;
    const Scalar z1526 = z1499 - z1504 * z1511;
    const Scalar z1525 = z1498 - z1503 * z1511;
    const Scalar z1524 = z1497 - z1502 * z1511;
    const Scalar z1527 = n1 / z1526;
    const Scalar z1575 = z1215 + z1237 * z1484;
    const Scalar z1576 = z1204 + z1237 * z1483 - z1511 * z1575;
    const Scalar z1528 = z1522 * z1527;
    const Scalar z1529 = z1523 * z1527;
    const Scalar z1530 = z1524 * z1527;
    const Scalar z1531 = z1525 * z1527;
    const Scalar z1532 = z1512 + z1522 * z1528;
    const Scalar z1533 = z1513 - z1522 * z1529;
    const Scalar z1534 = z1514 + z1523 * z1529;
    const Scalar z1535 = z1515 - z1522 * z1530;
    const Scalar z1536 = z1516 - z1523 * z1530;
    const Scalar z1537 = z1517 + z1524 * z1530;
    const Scalar z1538 = z1518 - z1522 * z1531;
    const Scalar z1539 = z1519 - z1523 * z1531;
    const Scalar z1540 = z1520 - z1524 * z1531;
    const Scalar z1541 = z1521 - z1525 * z1531;
    const Scalar z1590 = z1268 * z1531;
    const Scalar z1577 = z1237 * z1482 - z1510 * z1575 - z1531 * z1576;
    const Scalar z1542 = n1 / z1541;
    const Scalar z1562 = z1126 * z1531;
    const Scalar z1543 = z1538 * z1542;
    const Scalar z1603 = z1269 * z1531;
    const Scalar z1544 = z1539 * z1542;
    const Scalar z1545 = z1540 * z1542;
    const Scalar z1546 = z1532 + z1538 * z1543;
    const Scalar z1547 = z1533 - z1538 * z1544;
    const Scalar z1548 = z1534 + z1539 * z1544;
    const Scalar z1549 = z1535 - z1538 * z1545;
    const Scalar z1550 = z1536 - z1539 * z1545;
    const Scalar z1551 = z1537 + z1540 * z1545;
    const Scalar z1563 = n1 + z1126 * z1530 - z1545 * z1562;
    const Scalar z1578 = n1 + z1237 * z1481 - z1509 * z1575 - z1530 * z1576 - z1545 * z1577;
    const Scalar z1591 = z1268 * z1530 - z1545 * z1590;
    const Scalar z1604 = z1269 * z1530 - z1545 * z1603;
    const Scalar z1552 = n1 / z1551;
    const Scalar z1553 = z1549 * z1552;
    const Scalar z1554 = z1550 * z1552;
    const Scalar z1555 = z1546 - z1549 * z1553;
    const Scalar z1556 = z1547 + z1549 * z1554;
    const Scalar z1616 = z1290 + z1310 * z1484 - z1315 * z1469;
    const Scalar z1557 = z1548 - z1550 * z1554;
    const Scalar z1617 = z1288 + z1310 * z1483 + z1315 * z1468 - z1511 * z1616;
    const Scalar z1564 = z1126 * z1529 - z1544 * z1562 + z1554 * z1563;
    const Scalar z1579 = z1237 * z1480 - z1508 * z1575 - z1529 * z1576 - z1544 * z1577 + z1554 * z1578;
    const Scalar z1592 = z1268 * z1529 - z1544 * z1590 + z1554 * z1591;
    const Scalar z1605 = n1 - z1269 * z1529 + z1544 * z1603 - z1554 * z1604;
    const Scalar z1558 = n1 / z1557;
    const Scalar z1618 = z1286 + z1310 * z1482 - z1315 * z1467 - z1510 * z1616 - z1531 * z1617;
    const Scalar z1559 = z1556 * z1558;
    const Scalar z1619 = z1310 * z1481 - z1509 * z1616 - z1530 * z1617 - z1545 * z1618;
    const Scalar z1560 = z1555 - z1556 * z1559;
    const Scalar z1620 = z1310 * z1480 - z1508 * z1616 - z1529 * z1617 - z1544 * z1618 + z1554 * z1619;
    const Scalar z1565 = z1126 * z1528 - z1543 * z1562 + z1553 * z1563 + z1559 * z1564;
    const Scalar z1606 = z1269 * z1528 - z1543 * z1603 + z1553 * z1604 - z1559 * z1605;
    const Scalar z1561 = n1 / z1560;
    const Scalar z1621 = n1 - z1310 * z1479 + z1507 * z1616 + z1528 * z1617 + z1543 * z1618 - z1553 * z1619 - z1559
        * z1620;
    const Scalar z1593 = n1 + z1268 * z1528 - z1543 * z1590 + z1553 * z1591 + z1559 * z1592;
    const Scalar z1580 = z1237 * z1479 - z1507 * z1575 - z1528 * z1576 - z1543 * z1577 + z1553 * z1578 + z1559 * z1579;
    const Scalar z1622 = z1561 * z1621;
    const Scalar z1623 = z1558 * z1620 - z1559 * z1622;
    const Scalar z1607 = z1561 * z1606;
    const Scalar z1608 = z1558 * z1605 - z1559 * z1607;
    const Scalar z1594 = z1561 * z1593;
    const Scalar z1624 = z1552 * z1619 - z1553 * z1622 + z1554 * z1623;
    const Scalar z1609 = z1552 * z1604 + z1553 * z1607 - z1554 * z1608;
    const Scalar z1625 = z1542 * z1618 - z1543 * z1622 + z1544 * z1623 + z1545 * z1624;
    const Scalar z1610 = z1542 * z1603 + z1543 * z1607 - z1544 * z1608 + z1545 * z1609;
    const Scalar z1595 = z1558 * z1592 + z1559 * z1594;
    const Scalar z1596 = z1552 * z1591 + z1553 * z1594 + z1554 * z1595;
    const Scalar z1581 = z1561 * z1580;
    const Scalar z1582 = z1558 * z1579 + z1559 * z1581;
    const Scalar z1597 = z1542 * z1590 + z1543 * z1594 + z1544 * z1595 + z1545 * z1596;
    const Scalar z1583 = z1552 * z1578 + z1553 * z1581 + z1554 * z1582;
    const Scalar z1566 = z1561 * z1565;
    const Scalar z1626 = z1527 * z1617 - z1528 * z1622 + z1529 * z1623 + z1530 * z1624 - z1531 * z1625;
    const Scalar z1584 = z1542 * z1577 + z1543 * z1581 + z1544 * z1582 + z1545 * z1583;
    const Scalar z1585 = z1527 * z1576 + z1528 * z1581 + z1529 * z1582 + z1530 * z1583 - z1531 * z1584;
    const Scalar z1567 = z1558 * z1564 + z1559 * z1566;
    const Scalar z1627 = z1506 * z1616 - z1507 * z1622 + z1508 * z1623 + z1509 * z1624 - z1510 * z1625 - z1511 * z1626;
    const Scalar z1586 = z1506 * z1575 + z1507 * z1581 + z1508 * z1582 + z1509 * z1583 - z1510 * z1584 - z1511 * z1585;
    const Scalar z1568 = z1552 * z1563 + z1553 * z1566 + z1554 * z1567;
    const Scalar z1569 = z1542 * z1562 + z1543 * z1566 + z1544 * z1567 + z1545 * z1568;
    const Scalar z1628 = z701 * z1310 - z1479 * z1622 + z1480 * z1623 + z1481 * z1624 - z1482 * z1625 - z1483 * z1626
        - z1484 * z1627;
    const Scalar z1611 = z1269 * z1527 - z1528 * z1607 + z1529 * z1608 - z1530 * z1609 + z1531 * z1610;
    const Scalar z1612 = z1507 * z1607 - z1508 * z1608 + z1509 * z1609 - z1510 * z1610 + z1511 * z1611;
    const Scalar z1613 = z1479 * z1607 - z1480 * z1608 + z1481 * z1609 - z1482 * z1610 + z1483 * z1611 - z1484 * z1612;
    const Scalar z1614 = n25_over_3 * z1271 - z1612 - z1475 * z1610;
    const Scalar z1615 = z1467 * z1610 + z1468 * z1611 + z1469 * z1612;
    const Scalar z1598 = z1268 * z1527 - z1528 * z1594 - z1529 * z1595 - z1530 * z1596 + z1531 * z1597;
    const Scalar z1599 = z1507 * z1594 + z1508 * z1595 + z1509 * z1596 - z1510 * z1597 + z1511 * z1598;
    const Scalar z1600 = z1479 * z1594 + z1480 * z1595 + z1481 * z1596 - z1482 * z1597 + z1483 * z1598 - z1484 * z1599;
    const Scalar z1601 = n25_over_3 * z1270 - z1599 - z1475 * z1597;
    const Scalar z1602 = z1467 * z1597 + z1468 * z1598 + z1469 * z1599;
    const Scalar z1587 = z701 * z1237 + z1479 * z1581 + z1480 * z1582 + z1481 * z1583 - z1482 * z1584 - z1483 * z1585
        - z1484 * z1586;
    const Scalar z1588 = z1475 * z1584 + z1586;
    const Scalar z1589 = z1467 * z1584 - z1468 * z1585 + z1469 * z1586;
    const Scalar z1570 = z1126 * z1527 - z1528 * z1566 - z1529 * z1567 - z1530 * z1568 + z1531 * z1569;
    const Scalar z1630 = n25_over_7 * z1315 + z1467 * z1625 - z1468 * z1626 + z1469 * z1627;
    const Scalar z1571 = z1507 * z1566 + z1508 * z1567 + z1509 * z1568 - z1510 * z1569 + z1511 * z1570;
    const Scalar z1631 = z1291 + z1311 * z1484 - z1316 * z1469;
    const Scalar z1572 = z1479 * z1566 + z1480 * z1567 + z1481 * z1568 - z1482 * z1569 + z1483 * z1570 - z1484 * z1571;
    const Scalar z1632 = z1289 + z1311 * z1483 + z1316 * z1468 - z1511 * z1631;
    const Scalar z1573 = z1475 * z1569 + z1571;
    const Scalar z1633 = z1285 + z1311 * z1482 - z1316 * z1467 - z1510 * z1631 - z1531 * z1632;
    const Scalar z1574 = z1467 * z1569 + z1468 * z1570 + z1469 * z1571;
    const Scalar z1634 = z1311 * z1481 - z1509 * z1631 - z1530 * z1632 - z1545 * z1633;
    const Scalar z1635 = n1 + z1311 * z1480 - z1508 * z1631 - z1529 * z1632 - z1544 * z1633 + z1554 * z1634;
    const Scalar z1636 = z1311 * z1479 - z1507 * z1631 - z1528 * z1632 - z1543 * z1633 + z1553 * z1634 + z1559 * z1635;
    const Scalar z1637 = z1561 * z1636;
    const Scalar z1665 = z1285 * z1625 - z1623 + z1289 * z1626 + z1291 * z1627 - z1311 * z1628 - z1316 * z1630;
    const Scalar z1638 = z1558 * z1635 + z1559 * z1637;
    const Scalar z1639 = z1552 * z1634 + z1553 * z1637 + z1554 * z1638;
    const Scalar z1660 = z1286 * z1625 - z1622 + z1288 * z1626 + z1290 * z1627 - z1310 * z1628 - z1315 * z1630;
    const Scalar z1640 = z1542 * z1633 + z1543 * z1637 + z1544 * z1638 + z1545 * z1639;
    const Scalar z1641 = z1527 * z1632 + z1528 * z1637 + z1529 * z1638 + z1530 * z1639 - z1531 * z1640;
    const Scalar z1642 = z1506 * z1631 + z1507 * z1637 + z1508 * z1638 + z1509 * z1639 - z1510 * z1640 - z1511 * z1641;
    const Scalar z1643 = z701 * z1311 + z1479 * z1637 + z1480 * z1638 + z1481 * z1639 - z1482 * z1640 - z1483 * z1641
        - z1484 * z1642;
    const Scalar z1645 = n25_over_7 * z1316 + z1467 * z1640 - z1468 * z1641 + z1469 * z1642;
    const Scalar z1666 = z1285 * z1640 - z1638 + z1289 * z1641 + z1291 * z1642 - z1311 * z1643 - z1316 * z1645;
    const Scalar z1667 = n1 / z1666;
    const Scalar z1659 = z1607 + z1286 * z1610 - z1288 * z1611 + z1290 * z1612 - z1310 * z1613 - z1315 * z1615;
    const Scalar z1664 = z1608 + z1285 * z1610 - z1289 * z1611 + z1291 * z1612 - z1311 * z1613 - z1316 * z1615;
    const Scalar z1655 = z1608 + z1265 * z1610 - z1269 * z1611 + z1271 * (z1612 + z1614);
    const Scalar z1672 = z1665 * z1667;
    const Scalar z1671 = z1664 * z1667;
    const Scalar z1654 = z1265 * z1597 - z1595 - z1269 * z1598 + z1271 * (z1599 + z1601);
    const Scalar z1687 = z1660 - z1665 * z1672;
    const Scalar z1686 = z1659 - z1664 * z1672;
    const Scalar z1688 = n1 / z1687;
    const Scalar z1682 = z1655 + z1664 * z1671;
    const Scalar z1658 = z1594 + z1286 * z1597 - z1288 * z1598 + z1290 * z1599 - z1310 * z1600 - z1315 * z1602;
    const Scalar z1663 = z1285 * z1597 - z1595 - z1289 * z1598 + z1291 * z1599 - z1311 * z1600 - z1316 * z1602;
    const Scalar z1681 = z1654 + z1663 * z1671;
    const Scalar z1685 = z1658 - z1663 * z1672;
    const Scalar z1651 = z1594 + z1266 * z1597 - z1268 * z1598 + z1270 * (z1599 + z1601);
    const Scalar z1670 = z1663 * z1667;
    const Scalar z1678 = z1651 + z1663 * z1670;
    const Scalar z1650 = z1581 + z1266 * z1584 + z1268 * z1585 + z1270 * (z1586 - z1588);
    const Scalar z1653 = z1265 * z1584 - z1582 + z1269 * z1585 + z1271 * (z1586 - z1588);
    const Scalar z1657 = z1581 + z1286 * z1584 + z1288 * z1585 + z1290 * z1586 - z1310 * z1587 - z1315 * z1589;
    const Scalar z1662 = z1285 * z1584 - z1582 + z1289 * z1585 + z1291 * z1586 - z1311 * z1587 - z1316 * z1589;
    const Scalar z1677 = z1650 + z1662 * z1670;
    const Scalar z1680 = z1653 + z1662 * z1671;
    const Scalar z1684 = z1657 - z1662 * z1672;
    const Scalar z1648 = z1204 * z1585 - z1583 + z1215 * z1586 - z1237 * z1587;
    const Scalar z1669 = z1662 * z1667;
    const Scalar z1675 = z1648 - z1662 * z1669;
    const Scalar z1647 = z1568 + z1204 * z1570 - z1215 * z1571 + z1237 * z1572;
    const Scalar z1649 = z1566 + z1266 * z1569 - z1268 * z1570 + z1270 * (z1571 - z1573);
    const Scalar z1652 = z1265 * z1569 - z1567 - z1269 * z1570 + z1271 * (z1571 - z1573);
    const Scalar z1656 = z1566 + z1286 * z1569 - z1288 * z1570 + z1290 * z1571 - z1310 * z1572 - z1315 * z1574;
    const Scalar z1661 = z1285 * z1569 - z1567 - z1289 * z1570 + z1291 * z1571 - z1311 * z1572 - z1316 * z1574;
    const Scalar z1674 = z1647 + z1661 * z1669;
    const Scalar z1676 = z1649 + z1661 * z1670;
    const Scalar z1679 = z1652 + z1661 * z1671;
    const Scalar z1683 = z1656 - z1661 * z1672;
    const Scalar z1646 = z1126 * z1570 - z1568;
    const Scalar z1668 = z1661 * z1667;
    const Scalar z1673 = z1646 - z1661 * z1668;
    const Scalar z1629 = z1475 * z1625 + z1627;
    const Scalar z1692 = z1686 * z1688;
    const Scalar z1702 = z1682 + z1686 * z1692;
    const Scalar z1701 = z1681 + z1685 * z1692;
    const Scalar z1700 = z1680 + z1684 * z1692;
    const Scalar z1699 = z1679 + z1683 * z1692;
    const Scalar z1703 = n1 / z1702;
    const Scalar z1691 = z1685 * z1688;
    const Scalar z1698 = z1678 + z1685 * z1691;
    const Scalar z1697 = z1677 + z1684 * z1691;
    const Scalar z1696 = z1676 + z1683 * z1691;
    const Scalar z1690 = z1684 * z1688;
    const Scalar z1695 = z1675 - z1684 * z1690;
    const Scalar z1694 = z1674 + z1683 * z1690;
    const Scalar z1689 = z1683 * z1688;
    const Scalar z1693 = z1673 - z1683 * z1689;
    const Scalar z1644 = z1475 * z1640 + z1642;
    const Scalar z1755 = z1646 + z1648 - z1651 - z1655 + z1660 + z1666;
    const Scalar z1756 = n4096 * z1755;
    const Scalar z1723 = z1425 * z1469 - z1443 - z1466 * z1484 + z1450;
    const Scalar z1724 = z1425 * z1468 + z1466 * z1483 + z1511 * z1723 - z1458;
    const Scalar z1706 = z1701 * z1703;
    const Scalar z1712 = z1698 - z1701 * z1706;
    const Scalar z1711 = z1697 - z1700 * z1706;
    const Scalar z1710 = z1696 - z1699 * z1706;
    const Scalar z1705 = z1700 * z1703;
    const Scalar z1709 = z1695 + z1700 * z1705;
    const Scalar z1725 = z1425 * z1467 - z1443 * z1475 - z1466 * z1482 - z1510 * z1723 + z1531 * z1724 + z1462;
    const Scalar z1713 = n1 / z1712;
    const Scalar z1708 = z1694 - z1699 * z1705;
    const Scalar z1726 = z1465 - z1466 * z1481 - z1509 * z1723 + z1530 * z1724 - z1545 * z1725;
    const Scalar z1727 = z1464 - z1466 * z1480 - z1508 * z1723 + z1529 * z1724 - z1544 * z1725 + z1554 * z1726;
    const Scalar z1728 = z1463 + z1466 * z1479 + z1507 * z1723 - z1528 * z1724 + z1543 * z1725 - z1553 * z1726 - z1559
        * z1727;
    const Scalar z1729 = z1561 * z1728;
    const Scalar z1715 = z1711 * z1713;
    const Scalar z1718 = z1709 + z1711 * z1715;
    const Scalar z1717 = z1708 - z1710 * z1715;
    const Scalar z1730 = z1558 * z1727 - z1559 * z1729;
    const Scalar z1704 = z1699 * z1703;
    const Scalar z1707 = z1693 + z1699 * z1704;
    const Scalar z1719 = n1 / z1718;
    const Scalar z1714 = z1710 * z1713;
    const Scalar z1731 = z1552 * z1726 - z1553 * z1729 + z1554 * z1730;
    const Scalar z1716 = z1707 + z1710 * z1714;
    const Scalar z1732 = z1542 * z1725 - z1543 * z1729 + z1544 * z1730 + z1545 * z1731;
    const Scalar z1733 = z1527 * z1724 + z1528 * z1729 - z1529 * z1730 - z1530 * z1731 + z1531 * z1732;
    const Scalar z1720 = z1717 * z1719;
    const Scalar z1734 = z1506 * z1723 - z1507 * z1729 + z1508 * z1730 + z1509 * z1731 - z1510 * z1732 + z1511 * z1733;
    const Scalar z1735 = z701 * z1466 + z1479 * z1729 - z1480 * z1730 - z1481 * z1731 + z1482 * z1732 - z1483 * z1733
        + z1484 * z1734;
    const Scalar z1737 = n25_over_7 * z1425 - z1467 * z1732 - z1468 * z1733 - z1469 * z1734;
    const Scalar z1742 = z1346 - z1729 + z1286 * z1732 - z1288 * z1733 + z1290 * z1734 + z1310 * z1735 + z1315 * z1737;
    const Scalar z1743 = z1360 - z1730 + z1285 * z1732 - z1289 * z1733 + z1291 * z1734 + z1311 * z1735 + z1316 * z1737;
    const Scalar z1739 = z1264 + z1731 + z1204 * z1733 - z1215 * z1734 - z1237 * z1735;
    const Scalar z1736 = z1734 + n25_over_3 * z1443 + z1475 * z1732;
    const Scalar z1740 = z1279 - z1729 + z1266 * z1732 - z1268 * z1733 + z1270 * (z1734 - z1736);
    const Scalar z1741 = z1284 - z1730 + z1265 * z1732 - z1269 * z1733 + z1271 * (z1734 - z1736);
    const Scalar z1738 = z1140 - z1731 + z1126 * z1733;
    const Scalar z1721 = z1716 - z1717 * z1720;
    const Scalar z1744 = z1672 * z1743 - z1742;
    const Scalar z1745 = z1741 + z1671 * z1743 - z1692 * z1744;
    const Scalar z1722 = n1 / z1721;
    const Scalar z1746 = z1740 + z1670 * z1743 - z1691 * z1744 - z1706 * z1745;
    const Scalar z1747 = z1739 + z1669 * z1743 - z1690 * z1744 - z1705 * z1745 - z1715 * z1746;
    const Scalar z1748 = z1668 * z1743 - z1738 - z1689 * z1744 - z1704 * z1745 - z1714 * z1746 + z1720 * z1747;
    const Scalar z1749 = z1722 * z1748;
    const Scalar z1750 = z1719 * z1747 + z1720 * z1749;
    const Scalar z1751 = z1713 * z1746 + z1714 * z1749 + z1715 * z1750;
    const Scalar z1752 = z1703 * z1745 + z1704 * z1749 + z1705 * z1750 - z1706 * z1751;
    const Scalar z1753 = z1688 * z1744 - z1689 * z1749 - z1690 * z1750 + z1691 * z1751 + z1692 * z1752;
    const Scalar z1754 = z1667 * z1743 + z1668 * z1749 + z1669 * z1750 - z1670 * z1751 - z1671 * z1752 + z1672 * z1753;
    const Scalar z1757 = z1566 * z1749 - z1729 + z1581 * z1750 - z1594 * z1751 - z1607 * z1752 - z1622 * z1753 - z1637
        * z1754;
    const Scalar z1758 = z1730 + z1567 * z1749 + z1582 * z1750 - z1595 * z1751 + z1608 * z1752 + z1623 * z1753 - z1638
        * z1754;
    const Scalar z1759 = z1731 + z1568 * z1749 + z1583 * z1750 - z1596 * z1751 - z1609 * z1752 + z1624 * z1753 - z1639
        * z1754;
    const Scalar z1760 = z1732 + z1569 * z1749 + z1584 * z1750 - z1597 * z1751 - z1610 * z1752 + z1625 * z1753 - z1640
        * z1754;
    const Scalar z1761 = z1733 + z1570 * z1749 - z1585 * z1750 - z1598 * z1751 - z1611 * z1752 - z1626 * z1753 + z1641
        * z1754;
    const Scalar z1762 = z1734 + z1571 * z1749 + z1586 * z1750 - z1599 * z1751 - z1612 * z1752 + z1627 * z1753 - z1642
        * z1754;
    const Scalar z1763 = z1572 * z1749 - z1735 + z1587 * z1750 - z1600 * z1751 - z1613 * z1752 + z1628 * z1753 - z1643
        * z1754;
    const Scalar z1764 = z1736 + z1573 * z1749 + z1588 * z1750 + z1601 * z1751 + z1614 * z1752 + z1629 * z1753 - z1644
        * z1754;
    const Scalar z1765 = z1574 * z1749 - z1737 + z1589 * z1750 - z1602 * z1751 - z1615 * z1752 + z1630 * z1753 - z1645
        * z1754;
    accelerations.x = z1757;
    accelerations.y = z1758;
    accelerations.z = z1759;
    accelerations.yaw = z1760;
    accelerations.roll = z1761;
    accelerations.pitch = z1762;
    accelerations.steer = -z1763;
    accelerations.rear = -z1764;
    accelerations.front = -z1765;
    multipliers.lambda_rear_touches = -z1749;
    multipliers.lambda_front_touches = -z1750;
    multipliers.lambda_rear_rolls_x = -z1751;
    multipliers.lambda_rear_rolls_y = -z1752;
    multipliers.lambda_front_rolls_x = -z1753;
    multipliers.lambda_front_rolls_y = z1754;
    if (!(traits::regular(z1560, n94) && traits::regular(z1557, n94) && traits::regular(z1551, n94)
        && traits::regular(-z1541, z1093) && traits::regular(-z1526, z1081) && traits::regular(-z1505, z1064)
        && traits::regular(z195, z195) && traits::regular(-z1721, -z1756) && traits::regular(-z1718, -z1756)
        && traits::regular(z1712, -z1756) && traits::regular(z1702, -z1756) && traits::regular(-z1687, -z1756)
        && traits::regular(-z1666, -z1756))) return torsor::Status::singular;
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
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
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
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z200 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z1848 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z1847 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z1836 = v_yaw * c_roll;
    const Scalar z1835 = v_yaw * s_roll;
    const Scalar z1820 = z32 * s_steer;
    const Scalar z1819 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1821 = -z200 * (n1 - c_steer);
    const Scalar z1822 = z31 * s_steer;
    const Scalar z1823 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1832 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1882 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z1825 = n0_08 * z1820 - n0_35 * z1822;
    const Scalar z1837 = v_roll * c_pitch - s_pitch * z1836;
    const Scalar z1838 = v_roll * s_pitch + c_pitch * z1836;
    const Scalar z1839 = v_pitch + z1835;  // angular velocity of frame, y
    const Scalar z1840 = v_rear + z1839;  // angular velocity of rear_wheel, y
    const Scalar z1824 = n0_08 * z1819 - n0_35 * z1821;
    const Scalar z1885 = n0_8 * z1820 - n2_8 * z1822;
    const Scalar z1826 = n0_08 * z1821 - n0_35 * z1823;
    const Scalar z1833 = c_roll * z1832;
    const Scalar z1841 = z1820 * z1839 - z1821 * z1838 + z1819 * z1837;
    const Scalar z1842 = c_steer * z1839 - z1820 * z1837 + z1822 * z1838;
    const Scalar z1843 = z1822 * z1839 + z1821 * z1837 - z1823 * z1838;
    const Scalar z1849 = v_z * s_roll - c_roll * z1848;
    const Scalar z1850 = v_z * c_roll + s_roll * z1848;
    const Scalar z1853 = s_rear * z1838 - c_rear * z1837;
    const Scalar z1854 = s_rear * z1837 + c_rear * z1838;
    const Scalar z1883 = c_roll * z1882;
    const Scalar z1884 = n0_8 * z1819 - n2_8 * z1821;
    const Scalar z1886 = n0_8 * z1821 - n2_8 * z1823;
    const Scalar z1834 = q_z - z1833;
    const Scalar z1851 = s_pitch * z1850 - c_pitch * z1847;
    const Scalar z1852 = s_pitch * z1847 + c_pitch * z1850;
    const Scalar z1858 = n0_3 * z1837 - z1849 - n1_1 * z1838;
    const Scalar z1871 = n51 * z1837 + n25_5 * z1838 + n85 * z1849;
    const Scalar z1873 = n39_8 * z1837 + n17_7 * z1838 + n51 * z1849;
    const Scalar z1875 = n17_7 * z1837 + n10_45 * z1838 + n25_5 * z1849;
    const Scalar z1828 = n0_3 + z1826;
    const Scalar z1827 = n1_1 - z1824;
    const Scalar z1887 = c_pitch * z1886 + s_pitch * z1884;
    const Scalar z1859 = n1_1 * z1839 - z1852;
    const Scalar z1844 = z31 * v_steer + z1841;  // angular velocity of fork, x
    const Scalar z1857 = n0_3 * z1839 - z1851;
    const Scalar z1845 = z32 * v_steer - z1843;  // angular velocity of fork, z
    const Scalar z1829 = s_pitch * z1827 - c_pitch * z1828;
    const Scalar z1846 = v_front + z1842;  // angular velocity of front_wheel, y
    const Scalar z1860 = z1821 * z1859 - z1820 * z1858 + z1819 * z1857;
    const Scalar z1862 = z1823 * z1859 - z1822 * z1858 + z1821 * z1857;
    const Scalar z1861 = c_steer * z1858 + z1820 * z1857 + z1822 * z1859;
    const Scalar z1830 = s_roll * z1825 + c_roll * z1829;
    const Scalar z1863 = n0_35 * z1842 - z1860;
    const Scalar z1865 = n0_08 * z1842 - z1862;
    const Scalar z1831 = q_z - z1830;
    const Scalar z1855 = s_rear * z1852 + c_rear * z1851;
    const Scalar z1856 = s_rear * z1851 - c_rear * z1852;
    const Scalar z1864 = n0_35 * z1844 - z1861 - n0_08 * z1845;
    const Scalar z1866 = s_front * z1845 - c_front * z1844;
    const Scalar z1867 = s_front * z1844 + c_front * z1845;
    const Scalar z1868 = s_front * z1865 + c_front * z1863;
    const Scalar z1869 = s_front * z1863 - c_front * z1865;
    const Scalar z1870 = n51 * z1839 + n85 * z1851;
    const Scalar z1872 = n25_5 * z1839 - n85 * z1852;
    const Scalar z1874 = n49_25 * z1839 - n25_5 * z1852 + n51 * z1851;
    const Scalar z1876 = n2_8 * z1842 - n4 * z1860;
    const Scalar z1877 = n2_8 * z1844 - n0_8 * z1845 - n4 * z1861;
    const Scalar z1878 = n0_8 * z1842 - n4 * z1862;
    const Scalar z1879 = k16 * z1844 - k17 * z1845 - n2_8 * z1861;
    const Scalar z1880 = n2_18 * z1842 - n2_8 * z1860 - n0_8 * z1862;
    const Scalar z1881 = k17 * z1844 - k19 * z1845 - n0_8 * z1861;
    const Scalar z1888 = s_roll * z1885 - c_roll * z1887;
    result.kinetic = z1849 * z1849 + n0_06 * z1840 * z1840 + k21 * (z1853 * z1853 + z1854 * z1854) + z1855 * z1855
        + n0_14 * z1846 * z1846 + z1856 * z1856 + k23 * (z1866 * z1866 + z1867 * z1867) + n1_5 * (z1864 * z1864 + z1868
        * z1868 + z1869 * z1869) + n0_5 * (z1837 * z1873 + z1838 * z1875 + z1849 * z1871 - z1852 * z1872 + z1851 * z1870
        + z1839 * z1874 + z1844 * z1879 - z1845 * z1881 - z1860 * z1876 - z1861 * z1877 - z1862 * z1878 + z1842
        * z1880);
    result.force_function = n853_47 * q_z + n39_24 * z1834 - n9_81 * (z1883 + z1888) + n29_43 * z1831;
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
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
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
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z200 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z1993 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z1992 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z1981 = v_yaw * c_roll;
    const Scalar z1980 = v_yaw * s_roll;
    const Scalar z1965 = z32 * s_steer;
    const Scalar z1964 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1966 = -z200 * (n1 - c_steer);
    const Scalar z1967 = z31 * s_steer;
    const Scalar z1968 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1977 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z2027 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z1970 = n0_08 * z1965 - n0_35 * z1967;
    const Scalar z1982 = v_roll * c_pitch - s_pitch * z1981;
    const Scalar z1983 = v_roll * s_pitch + c_pitch * z1981;
    const Scalar z1984 = v_pitch + z1980;  // angular velocity of frame, y
    const Scalar z1985 = v_rear + z1984;  // angular velocity of rear_wheel, y
    const Scalar z1969 = n0_08 * z1964 - n0_35 * z1966;
    const Scalar z2030 = n0_8 * z1965 - n2_8 * z1967;
    const Scalar z1971 = n0_08 * z1966 - n0_35 * z1968;
    const Scalar z1978 = c_roll * z1977;
    const Scalar z1986 = z1965 * z1984 - z1966 * z1983 + z1964 * z1982;
    const Scalar z1987 = c_steer * z1984 - z1965 * z1982 + z1967 * z1983;
    const Scalar z1988 = z1967 * z1984 + z1966 * z1982 - z1968 * z1983;
    const Scalar z1994 = v_z * s_roll - c_roll * z1993;
    const Scalar z1995 = v_z * c_roll + s_roll * z1993;
    const Scalar z1998 = s_rear * z1983 - c_rear * z1982;
    const Scalar z1999 = s_rear * z1982 + c_rear * z1983;
    const Scalar z2028 = c_roll * z2027;
    const Scalar z2029 = n0_8 * z1964 - n2_8 * z1966;
    const Scalar z2031 = n0_8 * z1966 - n2_8 * z1968;
    const Scalar z1979 = q_z - z1978;
    const Scalar z1996 = s_pitch * z1995 - c_pitch * z1992;
    const Scalar z1997 = s_pitch * z1992 + c_pitch * z1995;
    const Scalar z2003 = n0_3 * z1982 - z1994 - n1_1 * z1983;
    const Scalar z2016 = n51 * z1982 + n25_5 * z1983 + n85 * z1994;
    const Scalar z2018 = n39_8 * z1982 + n17_7 * z1983 + n51 * z1994;
    const Scalar z2020 = n17_7 * z1982 + n10_45 * z1983 + n25_5 * z1994;
    const Scalar z1973 = n0_3 + z1971;
    const Scalar z1972 = n1_1 - z1969;
    const Scalar z2032 = c_pitch * z2031 + s_pitch * z2029;
    const Scalar z2004 = n1_1 * z1984 - z1997;
    const Scalar z1989 = z31 * v_steer + z1986;  // angular velocity of fork, x
    const Scalar z2002 = n0_3 * z1984 - z1996;
    const Scalar z1990 = z32 * v_steer - z1988;  // angular velocity of fork, z
    const Scalar z1974 = s_pitch * z1972 - c_pitch * z1973;
    const Scalar z1991 = v_front + z1987;  // angular velocity of front_wheel, y
    const Scalar z2005 = z1966 * z2004 - z1965 * z2003 + z1964 * z2002;
    const Scalar z2007 = z1968 * z2004 - z1967 * z2003 + z1966 * z2002;
    const Scalar z2006 = c_steer * z2003 + z1965 * z2002 + z1967 * z2004;
    const Scalar z1975 = s_roll * z1970 + c_roll * z1974;
    const Scalar z2008 = n0_35 * z1987 - z2005;
    const Scalar z2010 = n0_08 * z1987 - z2007;
    const Scalar z1976 = q_z - z1975;
    const Scalar z2000 = s_rear * z1997 + c_rear * z1996;
    const Scalar z2001 = s_rear * z1996 - c_rear * z1997;
    const Scalar z2009 = n0_35 * z1989 - z2006 - n0_08 * z1990;
    const Scalar z2011 = s_front * z1990 - c_front * z1989;
    const Scalar z2012 = s_front * z1989 + c_front * z1990;
    const Scalar z2013 = s_front * z2010 + c_front * z2008;
    const Scalar z2014 = s_front * z2008 - c_front * z2010;
    const Scalar z2015 = n51 * z1984 + n85 * z1996;
    const Scalar z2017 = n25_5 * z1984 - n85 * z1997;
    const Scalar z2019 = n49_25 * z1984 - n25_5 * z1997 + n51 * z1996;
    const Scalar z2021 = n2_8 * z1987 - n4 * z2005;
    const Scalar z2022 = n2_8 * z1989 - n0_8 * z1990 - n4 * z2006;
    const Scalar z2023 = n0_8 * z1987 - n4 * z2007;
    const Scalar z2024 = k16 * z1989 - k17 * z1990 - n2_8 * z2006;
    const Scalar z2025 = n2_18 * z1987 - n2_8 * z2005 - n0_8 * z2007;
    const Scalar z2026 = k17 * z1989 - k19 * z1990 - n0_8 * z2006;
    const Scalar z2033 = s_roll * z2030 - c_roll * z2032;
    result.energy = -n853_47 * q_z + z1994 * z1994 + n0_06 * z1985 * z1985 - n39_24 * z1979 + k23 * (z1998 * z1998
        + z1999 * z1999) + z2000 * z2000 + n0_14 * z1991 * z1991 + z2001 * z2001 + n9_81 * (z2028 + z2033) - n29_43
        * z1976 + k27 * (z2011 * z2011 + z2012 * z2012) + n1_5 * (z2009 * z2009 + z2013 * z2013 + z2014 * z2014) + n0_5
        * (z1982 * z2018 + z1983 * z2020 + z1994 * z2016 - z1997 * z2017 + z1996 * z2015 + z1984 * z2019 + z1989 * z2024
        - z1990 * z2026 - z2005 * z2021 - z2006 * z2022 - z2007 * z2023 + z1987 * z2025);
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
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z199 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z200 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z201 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z2044 = z32 * s_steer;
    const Scalar z2046 = z31 * s_steer;
    const Scalar z2062 = v_roll * s_roll;
    const Scalar z2061 = v_yaw * c_yaw;
    const Scalar z2060 = v_roll * c_roll;
    const Scalar z2065 = v_yaw * s_yaw;
    const Scalar z2048 = s_yaw * c_roll;
    const Scalar z2052 = n1 - s_roll * s_roll;
    const Scalar z2043 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z2049 = c_yaw * c_roll;
    const Scalar z2045 = -z200 * (n1 - c_steer);
    const Scalar z2047 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z2068 = n2 * s_roll;
    const Scalar z2073 = s_yaw * s_roll;
    const Scalar z2075 = c_yaw * s_roll;
    const Scalar z2050 = s_roll * z2048;
    const Scalar z2051 = s_roll * z2049;
    const Scalar z2063 = s_yaw * z2062 - c_roll * z2061;
    const Scalar z2066 = c_yaw * z2062 + c_roll * z2065;
    const Scalar z2069 = z2060 * z2068;
    const Scalar z2074 = s_roll * z2073 - c_roll * z2048;
    const Scalar z2076 = s_roll * z2075 - c_roll * z2049;
    const Scalar z2077 = c_roll * z2068;
    const Scalar z2081 = v_roll * z2060;
    const Scalar z2082 = v_yaw * z2065;
    const Scalar z2083 = n2 * z2062;
    const Scalar z2085 = v_roll * z2062;
    const Scalar z2086 = n2 * z2060;
    const Scalar z2088 = v_yaw * z2061;
    const Scalar z2096 = n0_08 * z2044 - n0_35 * z2046;
    const Scalar z2109 = s_pitch * z2046 - c_pitch * z2044;
    const Scalar z2110 = s_pitch * z2044 + c_pitch * z2046;
    const Scalar z2053 = z2052 * z2052 + z2050 * z2050 + z2051 * z2051;
    const Scalar z2084 = s_yaw * z2081 + c_roll * z2082 + z2061 * z2083;
    const Scalar z2089 = c_yaw * z2081 + c_roll * z2088 - z2065 * z2083;
    const Scalar z2091 = n2 * (s_roll * z2085 - z2060 * z2060);
    const Scalar z2095 = n0_08 * z2043 - n0_35 * z2045;
    const Scalar z2097 = n0_08 * z2045 - n0_35 * z2047;
    const Scalar z2064 = s_roll * z2063 - z2048 * z2060;
    const Scalar z2067 = s_roll * z2066 - z2049 * z2060;
    const Scalar z2078 = n2 * (z2052 * z2077 + z2050 * z2074 + z2051 * z2076);
    const Scalar z2111 = s_roll * z2110 - c_roll * c_steer;
    const Scalar z2112 = s_roll * c_steer + c_roll * z2110;
    const Scalar z2099 = n0_3 + z2097;
    const Scalar z2098 = n1_1 - z2095;
    const Scalar z2054 = traits::sqrt(z2053);
    const Scalar z2070 = n2 * (z2052 * z2069 + z2050 * z2064 + z2051 * z2067);
    const Scalar z2087 = z2048 * z2085 + z2063 * z2086 + s_roll * z2084;
    const Scalar z2090 = z2049 * z2085 + z2066 * z2086 + s_roll * z2089;
    const Scalar z2113 = c_yaw * z2109 + s_yaw * z2111;
    const Scalar z2092 = n2 * (z2050 * z2087 + z2051 * z2090 - z2052 * z2091 - z2064 * z2064 - z2067 * z2067 - z2069
        * z2069);
    const Scalar z2114 = s_yaw * z2109 - c_yaw * z2111;
    const Scalar z2101 = s_pitch * z2098 - c_pitch * z2099;
    const Scalar z2102 = s_roll * z2101 - c_roll * z2096;
    const Scalar z2100 = s_pitch * z2099 + c_pitch * z2098;
    const Scalar z2079 = n0_5 * z2078 / z2054;
    const Scalar z2059 = q_z + n0_3 * z2054;
    const Scalar z2071 = n0_5 * z2070 / z2054;
    const Scalar z2103 = s_roll * z2096 + c_roll * z2101;
    const Scalar z2106 = q_z - z2103;
    const Scalar z2104 = s_yaw * z2102 - c_yaw * z2100;
    const Scalar z2105 = s_yaw * z2100 + c_yaw * z2102;
    const Scalar z2107 = q_y + z2105;
    const Scalar z2055 = n0_3 / z2054;
    const Scalar z2115 = z2112 * z2113;
    const Scalar z2108 = q_x - z2104;
    const Scalar z2056 = q_x + z2050 * z2055;
    const Scalar z2116 = z2112 * z2114;
    const Scalar z2057 = q_y - z2051 * z2055;
    const Scalar z2117 = n1 - z2112 * z2112;
    const Scalar z2080 = n0_3 * z2079;
    const Scalar z2093 = n0_5 * (z2070 * z2071 / (z2054 * z2054) + z2092 / z2054);
    const Scalar z2072 = v_z - n0_3 * z2071;
    const Scalar z2058 = q_z + z2052 * z2055;
    const Scalar z2129 = v_pitch * c_pitch;
    const Scalar z2134 = v_pitch * s_pitch;
    const Scalar z2125 = v_steer * c_steer;
    const Scalar z2130 = v_steer * s_steer;
    const Scalar z2126 = z32 * z2125;
    const Scalar z2127 = z31 * z2125;
    const Scalar z2148 = n2 * z2112;
    const Scalar z2132 = z200 * z2130;
    const Scalar z2118 = z2117 * z2117 + z2115 * z2115 + z2116 * z2116;
    const Scalar z2119 = traits::sqrt(z2118);
    const Scalar z2140 = z2044 * z2129 - z2046 * z2134 + s_pitch * z2126 + c_pitch * z2127;
    const Scalar z2143 = z2044 * z2134 + z2046 * z2129 + s_pitch * z2127 - c_pitch * z2126;
    const Scalar z2131 = -z2130 * (n1 - z199);
    const Scalar z2133 = n0_35 * z2132 + n0_08 * z2131;
    const Scalar z2094 = n0_3 * z2093;
    const Scalar z2142 = c_roll * z2130 + c_steer * z2062 + z2060 * z2110 + s_roll * z2140;
    const Scalar z2146 = z2061 * z2109 + z2065 * z2111 + s_yaw * z2143 - c_yaw * z2142;
    const Scalar z2141 = s_roll * z2130 - c_steer * z2060 + z2062 * z2110 - c_roll * z2140;
    const Scalar z2124 = z2106 + n0_35 * z2119;
    const Scalar z2144 = z2061 * z2111 - z2065 * z2109 + c_yaw * z2143 + s_yaw * z2142;
    const Scalar z2149 = z2141 * z2148;
    const Scalar z2147 = z2112 * z2146 - z2114 * z2141;
    const Scalar z2135 = -z2130 * (n1 - z201);
    const Scalar z2136 = n0_08 * z2132 + n0_35 * z2135;
    const Scalar z2145 = z2112 * z2144 - z2113 * z2141;
    const Scalar z2128 = n0_08 * z2126 - n0_35 * z2127;
    const Scalar z2150 = n2 * (z2117 * z2149 + z2116 * z2147 + z2115 * z2145);
    const Scalar z2137 = s_pitch * z2133 - c_pitch * z2136 - z2098 * z2129 - z2099 * z2134;
    const Scalar z2172 = z32 * c_steer;
    const Scalar z2173 = z31 * c_steer;
    const Scalar z2163 = s_roll * z2109;
    const Scalar z2151 = n0_5 * z2150 / z2119;
    const Scalar z2155 = c_yaw * z2112;
    const Scalar z2156 = z2112 * z2155 + z2111 * z2114;
    const Scalar z2164 = s_yaw * z2163 - c_yaw * z2110;
    const Scalar z2166 = s_yaw * z2110 + c_yaw * z2163;
    const Scalar z2120 = n0_35 / z2119;
    const Scalar z2162 = c_roll * z2109;
    const Scalar z2165 = z2112 * z2164 + z2113 * z2162;
    const Scalar z2167 = z2112 * z2166 - z2114 * z2162;
    const Scalar z2168 = z2148 * z2162;
    const Scalar z2121 = z2108 - z2115 * z2120;
    const Scalar z2138 = z2060 * z2096 + s_roll * z2128 - z2062 * z2101 - c_roll * z2137;
    const Scalar z2169 = n2 * (z2115 * z2165 - z2116 * z2167 - z2117 * z2168);
    const Scalar z2139 = v_z - z2138;
    const Scalar z2152 = z2139 + n0_35 * z2151;
    const Scalar z2123 = z2106 + z2117 * z2120;
    const Scalar z2153 = s_yaw * z2112;
    const Scalar z2154 = z2111 * z2113 - z2112 * z2153;
    const Scalar z2157 = z2111 * z2148;
    const Scalar z2122 = z2107 - z2116 * z2120;
    const Scalar z2198 = v_steer * z2125;
    const Scalar z2204 = v_pitch * z2134;
    const Scalar z2158 = n2 * (z2116 * z2156 - z2117 * z2157 + z2115 * z2154);
    const Scalar z2170 = n0_5 * z2169 / z2119;
    const Scalar z2205 = v_pitch * z2129;
    const Scalar z2194 = v_steer * z2130;
    const Scalar z2195 = z32 * z2194;
    const Scalar z2196 = z31 * z2194;
    const Scalar z2213 = n2 * z2141;
    const Scalar z2182 = s_pitch * z2172 + c_pitch * z2173;
    const Scalar z2208 = z2044 * z2204 + z2046 * z2205 + s_pitch * z2195 + c_pitch * z2196 - n2 * (z2126 * z2129 - z2127
        * z2134);
    const Scalar z2210 = z2046 * z2204 - z2044 * z2205 + s_pitch * z2196 - c_pitch * z2195 - n2 * (z2126 * z2134 + z2127
        * z2129);
    const Scalar z2197 = n0_08 * z2195 - n0_35 * z2196;
    const Scalar z2159 = n0_5 * z2158 / z2119;
    const Scalar z2209 = z2085 * z2110 - c_roll * z2198 - c_steer * z2081 - n2 * (z2060 * z2140 - z2062 * z2130)
        + s_roll * z2208;
    const Scalar z2212 = s_roll * z2198 + c_steer * z2085 + z2081 * z2110 + n2 * (z2060 * z2130 + z2062 * z2140)
        + c_roll * z2208;
    const Scalar z2160 = z2102 - n0_35 * z2159;
    const Scalar z2215 = z2082 * z2109 - z2088 * z2111 - n2 * (z2061 * z2143 + z2065 * z2142) + s_yaw * z2210 - c_yaw
        * z2209;
    const Scalar z2211 = z2088 * z2109 + z2082 * z2111 - n2 * (z2061 * z2142 - z2065 * z2143) + c_yaw * z2210 + s_yaw
        * z2209;
    const Scalar z2216 = z2146 * z2213 + z2114 * z2212 + z2112 * z2215;
    const Scalar z2214 = z2144 * z2213 + z2113 * z2212 + z2112 * z2211;
    const Scalar z2217 = n2 * (z2112 * z2212 - z2141 * z2141);
    const Scalar z2218 = n2 * (z2116 * z2216 - z2149 * z2149 - z2147 * z2147 - z2145 * z2145 - z2117 * z2217 + z2115
        * z2214);
    const Scalar z2185 = s_pitch * z2173 - c_pitch * z2172;
    const Scalar z2174 = n0_08 * z2172 - n0_35 * z2173;
    const Scalar z2184 = c_roll * s_steer + s_roll * z2182;
    const Scalar z2183 = s_roll * s_steer - c_roll * z2182;
    const Scalar z2190 = z2148 * z2183;
    const Scalar z2186 = c_yaw * z2185 + s_yaw * z2184;
    const Scalar z2188 = s_yaw * z2185 - c_yaw * z2184;
    const Scalar z2187 = z2112 * z2186 - z2113 * z2183;
    const Scalar z2189 = z2112 * z2188 - z2114 * z2183;
    const Scalar z2200 = z200 * z2198;
    const Scalar z2199 = -z2198 * (n1 - z199);
    const Scalar z2201 = n0_35 * z2200 + n0_08 * z2199;
    const Scalar z2219 = n0_5 * (z2150 * z2151 / (z2119 * z2119) + z2218 / z2119);
    const Scalar z2191 = n2 * (z2117 * z2190 + z2115 * z2187 + z2116 * z2189);
    const Scalar z2202 = -z2198 * (n1 - z201);
    const Scalar z2203 = n0_08 * z2200 + n0_35 * z2202;
    const Scalar z2176 = s_steer * z200;
    const Scalar z2175 = s_steer * (n1 - z199);
    const Scalar z2177 = n0_08 * z2175 - n0_35 * z2176;
    const Scalar z2206 = s_pitch * z2201 - z2099 * z2205 - c_pitch * z2203 + z2098 * z2204 + n2 * (z2129 * z2133 + z2134
        * z2136);
    const Scalar z2192 = n0_5 * z2191 / z2119;
    const Scalar z2178 = s_steer * (n1 - z201);
    const Scalar z2179 = n0_08 * z2176 - n0_35 * z2178;
    const Scalar z2161 = c_roll * z2100;
    const Scalar z2171 = z2161 + n0_35 * z2170;
    const Scalar z2229 = n0_3 * z2071 / (z2054 * z2054);
    const Scalar z2207 = z2085 * z2096 + s_roll * z2197 + z2081 * z2101 - n2 * (z2060 * z2128 + z2062 * z2137) + c_roll
        * z2206;
    const Scalar z2220 = z2207 - n0_35 * z2219;
    const Scalar z2232 = v_z - z2055 * z2069 + z2052 * z2229;
    const Scalar z2230 = v_y + z2055 * z2067 - z2051 * z2229;
    const Scalar z2238 = v_x - z2055 * z2064 + z2050 * z2229;
    const Scalar z2180 = c_pitch * z2179 + s_pitch * z2177;
    const Scalar z2181 = s_roll * z2174 + c_roll * z2180;
    const Scalar z2221 = q_x - z2056;
    const Scalar z2222 = q_y - z2057;
    const Scalar z2223 = q_z - z2058;
    const Scalar z2233 = v_z - z2232;
    const Scalar z2231 = v_y - z2230;
    const Scalar z2193 = z2181 - n0_35 * z2192;
    const Scalar z2277 = c_roll * z2128 - z2062 * z2096 - z2060 * z2101 + s_roll * z2137;
    const Scalar z2276 = s_pitch * z2136 + c_pitch * z2133 + z2098 * z2134 - z2099 * z2129;
    const Scalar z2280 = n0_35 * z2151 / (z2119 * z2119);
    const Scalar z2283 = z2117 * z2280 - z2139 - z2120 * z2149;
    const Scalar z2270 = z2108 - z2121;
    const Scalar z2271 = z2107 - z2122;
    const Scalar z2239 = v_x - z2238;
    const Scalar z2272 = z2106 - z2123;
    const Scalar z2257 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z2256 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z2258 = s_roll * z2257;
    const Scalar z2250 = s_pitch * z32 + c_pitch * z31;
    const Scalar z2251 = s_pitch * z31 - c_pitch * z32;
    const Scalar z2278 = s_yaw * z2276 - z2061 * z2100 + z2065 * z2102 + c_yaw * z2277;
    const Scalar z2279 = v_y - z2278;
    const Scalar z2260 = s_yaw * z2258 - c_yaw * z2256;
    const Scalar z2264 = q_x - z2260;
    const Scalar z2252 = s_roll * z2251;
    const Scalar z2281 = z2279 - z2120 * z2147 + z2116 * z2280;
    const Scalar z2265 = z2121 - z2264;
    const Scalar z2243 = q_x - z2121;
    const Scalar z2259 = c_roll * z2257;
    const Scalar z2262 = q_z - z2259;
    const Scalar z2261 = s_yaw * z2256 + c_yaw * z2258;
    const Scalar z2263 = q_y + z2261;
    const Scalar z2245 = q_z - z2123;
    const Scalar z2267 = z2123 - z2262;
    const Scalar z2244 = q_y - z2122;
    const Scalar z2253 = c_roll * z2251;
    const Scalar z2282 = v_y - z2281;
    const Scalar z2266 = z2122 - z2263;
    const Scalar z2246 = s_yaw * z2245;
    const Scalar z2247 = c_yaw * z2245;
    const Scalar z2254 = s_yaw * z2252 - c_yaw * z2250;
    const Scalar z2248 = s_roll * z2244 - z2049 * z2245;
    const Scalar z2249 = s_roll * z2243 + z2048 * z2245;
    const Scalar z2255 = s_yaw * z2250 + c_yaw * z2252;
    const Scalar z2224 = s_yaw * z2223;
    const Scalar z2284 = v_z + z2283;
    const Scalar z2225 = c_yaw * z2223;
    const Scalar z2285 = z2061 * z2245 + s_yaw * z2284;
    const Scalar z2234 = z2061 * z2223 + s_yaw * z2233;
    const Scalar z2240 = c_yaw * z2233 - z2065 * z2223;
    const Scalar z2268 = z2253 * z2266 + z2255 * z2267;
    const Scalar z2269 = z2253 * z2265 - z2254 * z2267;
    const Scalar z2226 = s_roll * z2222 - z2049 * z2223;
    const Scalar z2228 = v_x + v_yaw * z2222 - v_roll * z2224 + z2226 * (v_pitch + v_rear);
    const Scalar z2235 = z2060 * z2222 + z2066 * z2223 + s_roll * z2231 - z2049 * z2233;
    const Scalar z2236 = v_yaw * z2231 - v_roll * z2234 + z2235 * (v_pitch + v_rear);
    const Scalar z2286 = z2060 * z2244 + z2066 * z2245 + s_roll * z2282 - z2049 * z2284;
    const Scalar z2241 = z2060 * z2221 - z2063 * z2223 + s_roll * z2239 + z2048 * z2233;
    const Scalar z2242 = v_yaw * z2239 - v_roll * z2240 + z2241 * (v_pitch + v_rear);
    const Scalar z2227 = s_roll * z2221 + z2048 * z2223;
    const Scalar z2237 = v_y - v_yaw * z2221 + v_roll * z2225 - z2227 * (v_pitch + v_rear);
    const Scalar z2307 = s_yaw * z2277 - c_yaw * z2276 - z2061 * z2102 - z2065 * z2100;
    const Scalar z2308 = v_x + z2307;
    const Scalar z2302 = z2279 - z2281;
    const Scalar z2303 = z2139 + z2283;
    const Scalar z2304 = z2112 * z2302 - z2141 * z2271 - z2146 * z2272 - z2114 * z2303;
    const Scalar z2309 = z2308 - z2120 * z2145 + z2115 * z2280;
    const Scalar z2273 = z2112 * z2271 - z2114 * z2272;
    const Scalar z2275 = v_x + v_yaw * z2244 - v_roll * z2246 + v_pitch * z2248 + v_steer * z2268 + v_front * z2273;
    const Scalar z2318 = z2308 - z2309;
    const Scalar z2319 = z2112 * z2318 - z2141 * z2270 - z2144 * z2272 - z2113 * z2303;
    const Scalar z2274 = z2112 * z2270 - z2113 * z2272;
    const Scalar z2306 = v_y - v_yaw * z2243 + v_roll * z2247 - v_pitch * z2249 - v_steer * z2269 - v_front * z2274;
    const Scalar z2289 = n0_3 * z2129 - n1_1 * z2134;
    const Scalar z2295 = z31 * z2134 - z32 * z2129;
    const Scalar z2287 = z31 * z2129 + z32 * z2134;
    const Scalar z2290 = n1_1 * z2129 + n0_3 * z2134;
    const Scalar z2291 = z2060 * z2257 + s_roll * z2290;
    const Scalar z2298 = c_roll * z2290 - z2062 * z2257;
    const Scalar z2288 = c_roll * z2287 - z2062 * z2251;
    const Scalar z2296 = z2060 * z2251 + s_roll * z2287;
    const Scalar z2313 = z2065 * z2256 - c_yaw * z2289 + z2061 * z2258 + s_yaw * z2291;
    const Scalar z2292 = z2061 * z2256 + s_yaw * z2289 - z2065 * z2258 + c_yaw * z2291;
    const Scalar z2314 = v_x - z2313;
    const Scalar z2315 = z2309 - z2314;
    const Scalar z2310 = v_x - z2309;
    const Scalar z2312 = z2060 * z2243 - z2063 * z2245 + s_roll * z2310 + z2048 * z2284;
    const Scalar z2311 = c_yaw * z2284 - z2065 * z2245;
    const Scalar z2293 = v_y + z2292;
    const Scalar z2294 = z2281 - z2293;
    const Scalar z2299 = v_z - z2298;
    const Scalar z2300 = z2283 + z2299;
    const Scalar z2316 = z2065 * z2250 + c_yaw * z2295 + z2061 * z2252 + s_yaw * z2296;
    const Scalar z2297 = s_yaw * z2295 - z2061 * z2250 + z2065 * z2252 - c_yaw * z2296;
    const Scalar z2317 = z2265 * z2288 - z2267 * z2316 + z2253 * z2315 + z2254 * z2300;
    const Scalar z2301 = z2266 * z2288 - z2267 * z2297 + z2253 * z2294 - z2255 * z2300;
    const Scalar z2320 = v_yaw * z2310 + v_pitch * z2312 + v_steer * z2317 - v_roll * z2311 + v_front * z2319;
    const Scalar z2305 = v_yaw * z2282 - v_roll * z2285 + v_pitch * z2286 + v_steer * z2301 + v_front * z2304;
    result.value[0] = -z2059;
    result.rate[0] = -z2072;
    result.gamma[0] = z2094;
    result.value[1] = -z2124;
    result.rate[1] = -z2152;
    result.gamma[1] = -z2220;
    result.value[2] = n0;
    result.rate[2] = z2228;
    result.gamma[2] = z2236;
    result.value[3] = n0;
    result.rate[3] = -z2237;
    result.gamma[3] = z2242;
    result.value[4] = n0;
    result.rate[4] = z2275;
    result.gamma[4] = z2305;
    result.value[5] = n0;
    result.rate[5] = -z2306;
    result.gamma[5] = z2320;
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
    result.jacobian[20] = z2222;
    result.jacobian[21] = z2221;
    result.jacobian[22] = z2244;
    result.jacobian[23] = z2243;
    result.jacobian[24] = z2080;
    result.jacobian[25] = -z2160;
    result.jacobian[26] = -z2224;
    result.jacobian[27] = -z2225;
    result.jacobian[28] = -z2246;
    result.jacobian[29] = -z2247;
    result.jacobian[30] = n0;
    result.jacobian[31] = z2171;
    result.jacobian[32] = z2226;
    result.jacobian[33] = z2227;
    result.jacobian[34] = z2248;
    result.jacobian[35] = z2249;
    result.jacobian[36] = n0;
    result.jacobian[37] = z2193;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z2268;
    result.jacobian[41] = z2269;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z2226;
    result.jacobian[45] = z2227;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z2273;
    result.jacobian[53] = z2274;
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
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k31 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k33 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar k35 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n78_6 = traits::constant(78.6, 78.6f, "393/5");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k39 = traits::constant(0.18328, 0.18328f, "2291/12500");
    const Scalar k40 = traits::constant(2.38342, 2.38342f, "119171/50000");
    const Scalar n79_7206 = traits::constant(79.7206, 79.7206f, "398603/5000");
    const Scalar n87 = traits::constant(87.0, 87.0f, "87/1");
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
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z57 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z58 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z31 - k4 * z32;
    });
    const Scalar z59 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z31 - k5 * z32;
    });
    const Scalar z195 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z58 - z32 * z59;
    });
    const Scalar z199 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z200 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z201 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z4207 = z32 * s_steer;
    const Scalar z4209 = z31 * s_steer;
    const Scalar z4206 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z4208 = -z200 * (n1 - c_steer);
    const Scalar z4210 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z4243 = n2_8467 * c_steer;
    const Scalar z4218 = c_steer * z57;
    const Scalar z4212 = n0_28 * c_steer;
    const Scalar z4267 = n0_12 * s_roll;
    const Scalar z4211 = n0_28 * z4207;
    const Scalar z4213 = n0_28 * z4209;
    const Scalar z4217 = z57 * z4207;
    const Scalar z4219 = z57 * z4209;
    const Scalar z4221 = z58 * z4207 + z59 * z4209;
    const Scalar z4236 = n1_04 * z4207 - n3_85 * z4209;
    const Scalar z4240 = n2_8467 * z4207;
    const Scalar z4242 = k3 * z4207 + k4 * z4209;
    const Scalar z4244 = k4 * z4207 + k5 * z4209;
    const Scalar z4246 = n2_8467 * z4209;
    const Scalar z4214 = s_pitch * z4213 - c_pitch * z4211;
    const Scalar z4215 = s_pitch * z4211 + c_pitch * z4213;
    const Scalar z4226 = s_pitch * z4219 - c_pitch * z4217;
    const Scalar z4227 = s_pitch * z4217 + c_pitch * z4219;
    const Scalar z4238 = k4 * z4208;
    const Scalar z4220 = z59 * z4208 + z58 * z4206;
    const Scalar z4222 = z58 * z4208 + z59 * z4210;
    const Scalar z4235 = n1_04 * z4206 - n3_85 * z4208;
    const Scalar z4237 = n1_04 * z4208 - n3_85 * z4210;
    const Scalar z4241 = k5 * z4208 + k4 * z4206;
    const Scalar z4245 = k3 * z4208 + k4 * z4210;
    const Scalar z4239 = k3 * z4206 + z4238;
    const Scalar z4247 = k5 * z4210 + z4238;
    const Scalar z4224 = n0_3 * z4217 - z4221 + n1_1 * z4219;
    const Scalar z4249 = z4206 * z4242 - z4207 * z4243 + z4208 * z4244;
    const Scalar z4250 = c_steer * z4243 + z4207 * z4242 + z4209 * z4244;
    const Scalar z4216 = s_roll * z4212 + c_roll * z4215;
    const Scalar z4223 = n0_3 * z4218 - z4220;
    const Scalar z4225 = n1_1 * z4218 - z4222;
    const Scalar z4230 = s_roll * z4227 - c_roll * z4218;
    const Scalar z4231 = s_roll * z4218 + c_roll * z4227;
    const Scalar z4248 = z4207 * z4240 + z4206 * z4239 + z4208 * z4241;
    const Scalar z4253 = z4209 * z4246 + z4208 * z4245 + z4210 * z4247;
    const Scalar z4256 = n9_1 + n0_6 * z4237 - n2_2 * z4235 + z4250;
    const Scalar z4251 = z4207 * z4246 + z4206 * z4245 + z4208 * z4247;
    const Scalar z4252 = c_steer * z4246 - z4207 * z4245 - z4209 * z4247;
    const Scalar z4259 = n8_47 - n2_2 * z4235 + z4253;
    const Scalar z4254 = n0_63 + n0_6 * z4237 + z4248;
    const Scalar z4257 = n2_31 + n1_1 * z4237 - n0_3 * z4235 + z4251;
    const Scalar z4266 = n29_35 - z4259;
    const Scalar z4265 = n17_7 - z4257;
    const Scalar z4264 = n49_25 + z4256;
    const Scalar z4255 = n1_1 * z4236 + z4249;
    const Scalar z4268 = n0_12 + z4264;
    const Scalar z4258 = n0_3 * z4236 + z4252;
    const Scalar z4278 = z4254 + z4266;
    const Scalar z4279 = n2 * z4265;
    const Scalar z4261 = n2_1 + z4237;
    const Scalar z4263 = n51 - z4261;
    const Scalar z4280 = s_pitch * z4278 - c_pitch * z4279;
    const Scalar z4260 = n7_7 - z4235;
    const Scalar z4262 = n25_5 + z4260;
    const Scalar z4286 = n39_8603 - z4268;
    const Scalar z4272 = s_pitch * z4255 - c_pitch * z4258;
    const Scalar z4229 = s_pitch * z4223 + c_pitch * z4225;
    const Scalar z4281 = s_pitch * z4280;
    const Scalar z4284 = c_pitch * z4280 + z4265;
    const Scalar z4269 = c_pitch * z4263 + s_pitch * z4262;
    const Scalar z4282 = z4266 - z4281;
    const Scalar z4283 = z4254 - z4281;
    const Scalar z4270 = s_pitch * z4263 - c_pitch * z4262;
    const Scalar z4285 = n39_8603 + z4283;
    const Scalar z4273 = s_roll * z4270;
    const Scalar z4233 = c_yaw * z4226 + s_yaw * z4230;
    const Scalar z4234 = s_yaw * z4226 - c_yaw * z4230;
    const Scalar z4277 = s_yaw * z4269 + c_yaw * z4273;
    const Scalar z4276 = s_yaw * z4273 - c_yaw * z4269;
    const Scalar z4232 = s_roll * z4224 - c_roll * z4229;
    const Scalar z4228 = s_pitch * z4225 - c_pitch * z4223;
    const Scalar z4313 = v_roll * s_roll;
    const Scalar z4312 = v_yaw * c_yaw;
    const Scalar z4311 = v_roll * c_roll;
    const Scalar z4316 = v_yaw * s_yaw;
    const Scalar z4300 = s_yaw * c_roll;
    const Scalar z4304 = n1 - s_roll * s_roll;
    const Scalar z4302 = s_roll * z4300;
    const Scalar z4301 = c_yaw * c_roll;
    const Scalar z4303 = s_roll * z4301;
    const Scalar z4323 = s_yaw * s_roll;
    const Scalar z4319 = n2 * s_roll;
    const Scalar z4325 = c_yaw * s_roll;
    const Scalar z4314 = s_yaw * z4313 - c_roll * z4312;
    const Scalar z4305 = z4304 * z4304 + z4302 * z4302 + z4303 * z4303;
    const Scalar z4327 = c_roll * z4319;
    const Scalar z4324 = s_roll * z4323 - c_roll * z4300;
    const Scalar z4317 = c_yaw * z4313 + c_roll * z4316;
    const Scalar z4315 = s_roll * z4314 - z4300 * z4311;
    const Scalar z4306 = traits::sqrt(z4305);
    const Scalar z4326 = s_roll * z4325 - c_roll * z4301;
    const Scalar z4320 = z4311 * z4319;
    const Scalar z4328 = n2 * (z4304 * z4327 + z4302 * z4324 + z4303 * z4326);
    const Scalar z4318 = s_roll * z4317 - z4301 * z4311;
    const Scalar z4321 = n2 * (z4304 * z4320 + z4302 * z4315 + z4303 * z4318);
    const Scalar z4292 = z4282 - z4286;
    const Scalar z4293 = n2 * z4272;
    const Scalar z4294 = s_roll * z4292 - c_roll * z4293;
    const Scalar z4288 = s_roll * z4269 - c_roll * z4236;
    const Scalar z4298 = s_yaw * z4270 - c_yaw * z4288;
    const Scalar z4299 = c_yaw * z4270 + s_yaw * z4288;
    const Scalar z4307 = n0_3 / z4306;
    const Scalar z4295 = s_roll * z4294;
    const Scalar z4329 = n0_5 * z4328 / z4306;
    const Scalar z4322 = n0_5 * z4321 / z4306;
    const Scalar z4275 = s_roll * z4268 - c_roll * z4272;
    const Scalar z4296 = z4282 - z4295;
    const Scalar z4287 = s_roll * z4236 + c_roll * z4269;
    const Scalar z4297 = n39_8603 - z4296;
    const Scalar z4271 = s_pitch * z4258 + c_pitch * z4255;
    const Scalar z4331 = v_roll * z4311;
    const Scalar z4332 = v_yaw * z4316;
    const Scalar z4333 = n2 * z4313;
    const Scalar z4274 = c_roll * z4270;
    const Scalar z4345 = n0_08 * z4206 - n0_35 * z4208;
    const Scalar z4348 = n1_1 - z4345;
    const Scalar z4347 = n0_08 * z4208 - n0_35 * z4210;
    const Scalar z4346 = n0_08 * z4207 - n0_35 * z4209;
    const Scalar z4335 = v_roll * z4313;
    const Scalar z4338 = v_yaw * z4312;
    const Scalar z4336 = n2 * z4311;
    const Scalar z4308 = q_x + z4302 * z4307;
    const Scalar z4334 = s_yaw * z4331 + c_roll * z4332 + z4312 * z4333;
    const Scalar z4330 = n0_3 * z4329;
    const Scalar z4339 = c_yaw * z4331 + c_roll * z4338 - z4316 * z4333;
    const Scalar z4337 = z4300 * z4335 + z4314 * z4336 + s_roll * z4334;
    const Scalar z4340 = z4301 * z4335 + z4317 * z4336 + s_roll * z4339;
    const Scalar z4310 = q_z + z4304 * z4307;
    const Scalar z4341 = n2 * (s_roll * z4335 - z4311 * z4311);
    const Scalar z4309 = q_y - z4303 * z4307;
    const Scalar z4342 = n2 * (z4302 * z4337 + z4303 * z4340 - z4304 * z4341 - z4315 * z4315 - z4318 * z4318 - z4320
        * z4320);
    const Scalar z4290 = s_yaw * z4287;
    const Scalar z4291 = c_yaw * z4287;
    const Scalar z4289 = s_roll * z4271 - c_roll * z4284;
    const Scalar z4349 = n0_3 + z4347;
    const Scalar z4361 = s_pitch * z4207 + c_pitch * z4209;
    const Scalar z4362 = s_roll * z4361;
    const Scalar z4360 = s_pitch * z4209 - c_pitch * z4207;
    const Scalar z4364 = s_roll * c_steer + c_roll * z4361;
    const Scalar z4363 = c_roll * c_steer - z4362;
    const Scalar z4365 = c_yaw * z4360;
    const Scalar z4367 = s_yaw * z4360;
    const Scalar z4371 = n1 - z4364 * z4364;
    const Scalar z4382 = v_pitch * c_pitch;
    const Scalar z4366 = s_yaw * z4363 - z4365;
    const Scalar z4368 = c_yaw * z4363 + z4367;
    const Scalar z4387 = v_pitch * s_pitch;
    const Scalar z4378 = v_steer * c_steer;
    const Scalar z4383 = v_steer * s_steer;
    const Scalar z4379 = z32 * z4378;
    const Scalar z4369 = z4364 * z4366;
    const Scalar z4370 = z4364 * z4368;
    const Scalar z4380 = z31 * z4378;
    const Scalar z4395 = c_roll * z4383;
    const Scalar z4393 = z4207 * z4382 - z4209 * z4387 + s_pitch * z4379 + c_pitch * z4380;
    const Scalar z4372 = z4371 * z4371 + z4369 * z4369 + z4370 * z4370;
    const Scalar z4397 = z4207 * z4387 + z4209 * z4382 + s_pitch * z4380 - c_pitch * z4379;
    const Scalar z4373 = traits::sqrt(z4372);
    const Scalar z4351 = s_pitch * z4348 - c_pitch * z4349;
    const Scalar z4396 = c_steer * z4313 + z4395 + z4311 * z4361 + s_roll * z4393;
    const Scalar z4402 = n2 * z4364;
    const Scalar z4350 = s_pitch * z4349 + c_pitch * z4348;
    const Scalar z4353 = s_roll * z4346;
    const Scalar z4400 = z4312 * z4360 - z4316 * z4363 + s_yaw * z4397 - c_yaw * z4396;
    const Scalar z4352 = s_roll * z4351 - c_roll * z4346;
    const Scalar z4394 = s_roll * z4383 - c_steer * z4311 + z4313 * z4361 - c_roll * z4393;
    const Scalar z4354 = c_roll * z4351 + z4353;
    const Scalar z4356 = s_yaw * z4350 + c_yaw * z4352;
    const Scalar z4357 = q_z - z4354;
    const Scalar z4374 = n0_35 / z4373;
    const Scalar z4401 = z4364 * z4400 - z4368 * z4394;
    const Scalar z4358 = q_y + z4356;
    const Scalar z4398 = c_yaw * z4397 - z4316 * z4360 - z4312 * z4363 + s_yaw * z4396;
    const Scalar z4399 = z4366 * z4394 + z4364 * z4398;
    const Scalar z4385 = z200 * z4383;
    const Scalar z4355 = s_yaw * z4352 - c_yaw * z4350;
    const Scalar z4388 = -z4383 * (n1 - z201);
    const Scalar z4389 = n0_08 * z4385 + n0_35 * z4388;
    const Scalar z4377 = z4357 + z4371 * z4374;
    const Scalar z4376 = z4358 - z4370 * z4374;
    const Scalar z4359 = q_x - z4355;
    const Scalar z4384 = -z4383 * (n1 - z199);
    const Scalar z4386 = n0_35 * z4385 + n0_08 * z4384;
    const Scalar z4375 = z4359 + z4369 * z4374;
    const Scalar z4381 = n0_08 * z4379 - n0_35 * z4380;
    const Scalar z4390 = s_pitch * z4386 - c_pitch * z4389 - z4348 * z4382 - z4349 * z4387;
    const Scalar z4343 = n0_5 * (z4321 * z4322 / (z4306 * z4306) + z4342 / z4306);
    const Scalar z4344 = n0_3 * z4343;
    const Scalar z4425 = z32 * c_steer;
    const Scalar z4426 = z31 * c_steer;
    const Scalar z4435 = s_pitch * z4425 + c_pitch * z4426;
    const Scalar z4438 = s_pitch * z4426 - c_pitch * z4425;
    const Scalar z4416 = s_roll * z4360;
    const Scalar z4419 = s_yaw * z4361 + c_yaw * z4416;
    const Scalar z4415 = c_roll * z4360;
    const Scalar z4406 = s_yaw * z4364;
    const Scalar z4417 = s_yaw * z4416 - c_yaw * z4361;
    const Scalar z4437 = c_roll * s_steer + s_roll * z4435;
    const Scalar z4436 = s_roll * s_steer - c_roll * z4435;
    const Scalar z4439 = c_yaw * z4438 + s_yaw * z4437;
    const Scalar z4441 = s_yaw * z4438 - c_yaw * z4437;
    const Scalar z4421 = z4402 * z4415;
    const Scalar z4408 = c_yaw * z4364;
    const Scalar z4407 = z4363 * z4366 - z4364 * z4406;
    const Scalar z4420 = z4364 * z4419 - z4368 * z4415;
    const Scalar z4440 = z4364 * z4439 + z4366 * z4436;
    const Scalar z4409 = z4363 * z4368 - z4364 * z4408;
    const Scalar z4447 = v_steer * z4383;
    const Scalar z4442 = z4364 * z4441 - z4368 * z4436;
    const Scalar z4418 = z4364 * z4417 - z4366 * z4415;
    const Scalar z4448 = z32 * z4447;
    const Scalar z4410 = z4363 * z4402;
    const Scalar z4403 = z4394 * z4402;
    const Scalar z4443 = z4402 * z4436;
    const Scalar z4449 = z31 * z4447;
    const Scalar z4422 = n2 * (z4371 * z4421 + z4370 * z4420 + z4369 * z4418);
    const Scalar z4411 = n2 * (z4369 * z4407 + z4370 * z4409 - z4371 * z4410);
    const Scalar z4444 = n2 * (z4369 * z4440 - z4370 * z4442 - z4371 * z4443);
    const Scalar z4429 = s_steer * z200;
    const Scalar z4428 = s_steer * (n1 - z199);
    const Scalar z4430 = n0_08 * z4428 - n0_35 * z4429;
    const Scalar z4431 = s_steer * (n1 - z201);
    const Scalar z4432 = n0_08 * z4429 - n0_35 * z4431;
    const Scalar z4404 = n2 * (z4369 * z4399 - z4370 * z4401 - z4371 * z4403);
    const Scalar z4423 = n0_5 * z4422 / z4373;
    const Scalar z4412 = n0_5 * z4411 / z4373;
    const Scalar z4445 = n0_5 * z4444 / z4373;
    const Scalar z4433 = c_pitch * z4432 + s_pitch * z4430;
    const Scalar z4427 = n0_08 * z4425 - n0_35 * z4426;
    const Scalar z4414 = c_roll * z4350;
    const Scalar z4434 = s_roll * z4427 + c_roll * z4433;
    const Scalar z4405 = n0_5 * z4404 / z4373;
    const Scalar z4424 = z4414 - n0_35 * z4423;
    const Scalar z4413 = z4352 + n0_35 * z4412;
    const Scalar z4391 = z4311 * z4346 + s_roll * z4381 - z4313 * z4351 - c_roll * z4390;
    const Scalar z4451 = v_steer * z4378;
    const Scalar z4446 = z4434 + n0_35 * z4445;
    const Scalar z4392 = v_z - z4391;
    const Scalar z4475 = q_x - z4308;
    const Scalar z4477 = q_z - z4310;
    const Scalar z4476 = q_y - z4309;
    const Scalar z4457 = v_pitch * z4387;
    const Scalar z4458 = v_pitch * z4382;
    const Scalar z4461 = z4207 * z4457 + z4209 * z4458 + s_pitch * z4448 + c_pitch * z4449 - n2 * (z4379 * z4382 - z4380
        * z4387);
    const Scalar z4463 = z4209 * z4457 - z4207 * z4458 + s_pitch * z4449 - c_pitch * z4448 - n2 * (z4379 * z4387 + z4380
        * z4382);
    const Scalar z4450 = n0_08 * z4448 - n0_35 * z4449;
    const Scalar z4466 = n2 * z4394;
    const Scalar z4499 = q_x - z4375;
    const Scalar z4500 = q_y - z4376;
    const Scalar z4507 = s_pitch * z31 - c_pitch * z32;
    const Scalar z4506 = s_pitch * z32 + c_pitch * z31;
    const Scalar z4508 = s_roll * z4507;
    const Scalar z4465 = s_roll * z4451 + c_steer * z4335 + z4331 * z4361 + n2 * (z4311 * z4383 + z4313 * z4393)
        + c_roll * z4461;
    const Scalar z4462 = z4335 * z4361 - c_roll * z4451 - c_steer * z4331 - n2 * (z4311 * z4393 - z4313 * z4383)
        + s_roll * z4461;
    const Scalar z4468 = z4332 * z4360 + z4338 * z4363 - n2 * (z4312 * z4397 + z4316 * z4396) + s_yaw * z4463 - c_yaw
        * z4462;
    const Scalar z4470 = n2 * (z4364 * z4465 - z4394 * z4394);
    const Scalar z4464 = z4338 * z4360 - z4332 * z4363 - n2 * (z4312 * z4396 - z4316 * z4397) + c_yaw * z4463 + s_yaw
        * z4462;
    const Scalar z4469 = z4400 * z4466 + z4368 * z4465 + z4364 * z4468;
    const Scalar z4509 = c_roll * z4507;
    const Scalar z4467 = z4398 * z4466 - z4366 * z4465 + z4364 * z4464;
    const Scalar z4501 = q_z - z4377;
    const Scalar z4511 = s_yaw * z4506 + c_yaw * z4508;
    const Scalar z4453 = z200 * z4451;
    const Scalar z4471 = n2 * (z4403 * z4403 + z4401 * z4401 + z4399 * z4399 + z4371 * z4470 - z4370 * z4469 + z4369
        * z4467);
    const Scalar z4502 = s_yaw * z4501;
    const Scalar z4510 = s_yaw * z4508 - c_yaw * z4506;
    const Scalar z4452 = -z4451 * (n1 - z199);
    const Scalar z4454 = n0_35 * z4453 + n0_08 * z4452;
    const Scalar z4512 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z4513 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z4514 = s_roll * z4513;
    const Scalar z4492 = z4307 * z4315;
    const Scalar z4503 = c_yaw * z4501;
    const Scalar z4455 = -z4451 * (n1 - z201);
    const Scalar z4456 = n0_08 * z4453 + n0_35 * z4455;
    const Scalar z4517 = s_yaw * z4512 + c_yaw * z4514;
    const Scalar z4515 = c_roll * z4513;
    const Scalar z4516 = s_yaw * z4514 - c_yaw * z4512;
    const Scalar z4518 = q_z - z4515;
    const Scalar z4482 = n0_3 * z4322 / (z4306 * z4306);
    const Scalar z4505 = s_roll * z4499 + z4300 * z4501;
    const Scalar z4481 = s_roll * z4475 + z4300 * z4477;
    const Scalar z4504 = s_roll * z4500 - z4301 * z4501;
    const Scalar z4472 = z4404 * z4405;
    const Scalar z4478 = s_yaw * z4477;
    const Scalar z4493 = v_x - z4492 + z4302 * z4482;
    const Scalar z4494 = v_x - z4493;
    const Scalar z4480 = s_roll * z4476 - z4301 * z4477;
    const Scalar z4483 = z4307 * z4318;
    const Scalar z4479 = c_yaw * z4477;
    const Scalar z4484 = v_y + z4483 - z4303 * z4482;
    const Scalar z4486 = v_z - z4307 * z4320 + z4304 * z4482;
    const Scalar z4487 = v_z - z4486;
    const Scalar z4459 = s_pitch * z4454 - z4349 * z4458 - c_pitch * z4456 + z4348 * z4457 + n2 * (z4382 * z4386 + z4387
        * z4389);
    const Scalar z4485 = v_y - z4484;
    const Scalar z4519 = q_y + z4517;
    const Scalar z4495 = c_yaw * z4487 - z4316 * z4477;
    const Scalar z4496 = z4300 * z4487;
    const Scalar z4497 = z4311 * z4475 - z4314 * z4477 + s_roll * z4494 + z4496;
    const Scalar z4488 = z4312 * z4477 + s_yaw * z4487;
    const Scalar z4489 = z4301 * z4487;
    const Scalar z4460 = z4335 * z4346 + s_roll * z4450 + z4331 * z4351 - n2 * (z4311 * z4381 + z4313 * z4390) + c_roll
        * z4459;
    const Scalar z4530 = z4357 - z4377;
    const Scalar z4523 = z4377 - z4518;
    const Scalar z4529 = z4358 - z4376;
    const Scalar z4522 = z4376 - z4519;
    const Scalar z4528 = z4359 - z4375;
    const Scalar z4531 = z4368 * z4530;
    const Scalar z4520 = q_x - z4516;
    const Scalar z4521 = z4375 - z4520;
    const Scalar z4532 = z4364 * z4529 - z4531;
    const Scalar z4526 = z4510 * z4523;
    const Scalar z4524 = z4511 * z4523;
    const Scalar z4525 = z4509 * z4522 + z4524;
    const Scalar z4527 = z4509 * z4521 - z4526;
    const Scalar z4473 = n0_5 * (z4472 / (z4373 * z4373) - z4471 / z4373);
    const Scalar z4474 = z4460 - n0_35 * z4473;
    const Scalar z4535 = s_pitch * z4389;
    const Scalar z4533 = z4366 * z4530;
    const Scalar z4534 = z4364 * z4528 + z4533;
    const Scalar z4537 = c_roll * z4381;
    const Scalar z4536 = z4535 + c_pitch * z4386 - z4349 * z4382 + z4348 * z4387;
    const Scalar z4538 = z4537 - z4313 * z4346 - z4311 * z4351 + s_roll * z4390;
    const Scalar z4549 = z31 * z4382 + z32 * z4387;
    const Scalar z4541 = n0_35 * z4405 / (z4373 * z4373);
    const Scalar z4544 = z4392 + z4374 * z4403 + z4371 * z4541;
    const Scalar z4547 = z4317 * z4501;
    const Scalar z4490 = z4311 * z4476 + z4317 * z4477 + s_roll * z4485 - z4489;
    const Scalar z4539 = s_yaw * z4536 - z4312 * z4350 + z4316 * z4352 + c_yaw * z4538;
    const Scalar z4550 = c_roll * z4549 - z4313 * z4507;
    const Scalar z4545 = v_z - z4544;
    const Scalar z4546 = z4312 * z4501 + s_yaw * z4545;
    const Scalar z4498 = v_yaw * z4494 + z4497 * (v_pitch + v_rear) - v_roll * z4495;
    const Scalar z4491 = v_yaw * z4485 - v_roll * z4488 + z4490 * (v_pitch + v_rear);
    const Scalar z4566 = z4392 - z4544;
    const Scalar z4587 = v_yaw * s_roll;
    const Scalar z4588 = v_yaw * c_roll;
    const Scalar z4593 = v_pitch + z4587;  // angular velocity of frame, y
    const Scalar z4591 = v_roll * c_pitch - s_pitch * z4588;
    const Scalar z4592 = v_roll * s_pitch + c_pitch * z4588;
    const Scalar z4557 = z31 * z4387 - z32 * z4382;
    const Scalar z4599 = z4591 * z4593;
    const Scalar z4595 = z4593 * z4593;
    const Scalar z4596 = z4592 * z4592;
    const Scalar z4598 = z4591 * z4592;
    const Scalar z4597 = z4595 + z4596;
    const Scalar z4540 = v_y - z4539;
    const Scalar z4601 = z4591 * z4591;
    const Scalar z4600 = z4592 * z4593;
    const Scalar z4551 = n0_3 * z4382 - n1_1 * z4387;
    const Scalar z4594 = v_rear + z4593;  // angular velocity of rear_wheel, y
    const Scalar z4558 = z4311 * z4507 + s_roll * z4549;
    const Scalar z4552 = n1_1 * z4382 + n0_3 * z4387;
    const Scalar z4570 = s_yaw * z4538 - c_yaw * z4536 - z4312 * z4352 - z4316 * z4350;
    const Scalar z4559 = s_yaw * z4557 - z4312 * z4506 + z4316 * z4508 - c_yaw * z4558;
    const Scalar z4542 = z4374 * z4401 - z4540 + z4370 * z4541;
    const Scalar z4602 = z4595 + z4601;
    const Scalar z4565 = z4540 + z4542;
    const Scalar z4553 = z4311 * z4513 + s_roll * z4552;
    const Scalar z4571 = v_x + z4570;
    const Scalar z4554 = z4312 * z4512 + s_yaw * z4551 - z4316 * z4514 + c_yaw * z4553;
    const Scalar z4555 = v_y + z4554;
    const Scalar z4560 = c_roll * z4552 - z4313 * z4513;
    const Scalar z4572 = z4571 - z4374 * z4399 + z4369 * z4541;
    const Scalar z4556 = z4542 + z4555;
    const Scalar z4543 = v_y + z4542;
    const Scalar z4583 = z4571 - z4572;
    const Scalar z4605 = z4209 * z4593 + z4208 * z4591 - z4210 * z4592;
    const Scalar z4603 = z4207 * z4593 - z4208 * z4592 + z4206 * z4591;
    const Scalar z4607 = z31 * v_steer;
    const Scalar z4604 = c_steer * z4593 - z4207 * z4591 + z4209 * z4592;
    const Scalar z4606 = z31 * z4605 + z32 * z4603;
    const Scalar z4577 = z4316 * z4512 - c_yaw * z4551 + z4312 * z4514 + s_yaw * z4553;
    const Scalar z4561 = v_z - z4560;
    const Scalar z4562 = z4544 - z4561;
    const Scalar z4573 = v_x - z4572;
    const Scalar z4580 = z4316 * z4506 + c_yaw * z4557 + z4312 * z4508 + s_yaw * z4558;
    const Scalar z4578 = v_x - z4577;
    const Scalar z4579 = z4572 - z4578;
    const Scalar z4575 = z4314 * z4501;
    const Scalar z4563 = z4523 * z4559;
    const Scalar z4581 = z4523 * z4580;
    const Scalar z4590 = v_roll * z4587;  // angular acceleration of frame.2, z
    const Scalar z4589 = v_roll * z4588;  // angular acceleration of frame.2, y
    const Scalar z4584 = z4398 * z4530;
    const Scalar z4567 = z4400 * z4530;
    const Scalar z4574 = c_yaw * z4545 - z4316 * z4501;
    const Scalar z4548 = z4311 * z4500 + z4547 + s_roll * z4543 - z4301 * z4545;
    const Scalar z4608 = z4603 + z4607;  // angular velocity of fork, x
    const Scalar z4609 = z32 * v_steer;
    const Scalar z4610 = z4605 - z4609;  // angular velocity of fork, z
    const Scalar z4619 = v_front + z4604;  // angular velocity of front_wheel, y
    const Scalar z4611 = z4604 * z4604;
    const Scalar z4617 = z4608 * z4608;
    const Scalar z4615 = z4604 * z4608;
    const Scalar z4618 = z4611 + z4617;
    const Scalar z4612 = z4610 * z4610;
    const Scalar z4614 = z4608 * z4610;
    const Scalar z4616 = z4604 * z4610;
    const Scalar z4620 = z4610 * z4619;
    const Scalar z4621 = z4608 * z4619;
    const Scalar z4623 = n0_28 * z4621;  // moment on front_wheel, z
    const Scalar z4613 = z4611 + z4612;
    const Scalar z4622 = n0_28 * z4620;  // moment on front_wheel, x
    const Scalar z4576 = z4311 * z4499 - z4575 + s_roll * z4573 + z4300 * z4545;
    const Scalar z4564 = z4563 - z4522 * z4550 + z4509 * z4556 - z4511 * z4562;
    const Scalar z4624 = z4612 - z4617;
    const Scalar z4626 = z4591 * z4594;
    const Scalar z4625 = z4592 * z4594;
    const Scalar z4627 = n0_12 * z4625;  // moment on rear_wheel, x
    const Scalar z4582 = z4521 * z4550 - z4581 + z4509 * z4579 - z4510 * z4562;
    const Scalar z4568 = z4364 * z4565 - z4567 - z4394 * z4529 - z4368 * z4566;
    const Scalar z4628 = n0_12 * z4626;  // moment on rear_wheel, z
    const Scalar z4585 = z4364 * z4583 - z4584 - z4394 * z4528 + z4366 * z4566;
    const Scalar z4569 = v_yaw * z4543 - v_roll * z4546 + v_pitch * z4548 - v_steer * z4564 + v_front * z4568;
    const Scalar z4639 = a_yaw * c_roll;
    const Scalar z4643 = v_roll * z4587 - z4639;  // angular acceleration of frame.2, z
    const Scalar z4637 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z4638 = a_yaw * s_roll;
    const Scalar z4642 = v_roll * z4588 + z4638;  // angular acceleration of frame.2, y
    const Scalar z4635 = n9_81 - a_z;
    const Scalar z4633 = s_front * z4610 + c_front * z4608;
    const Scalar z4645 = a_roll * s_pitch - c_pitch * z4643;
    const Scalar z4634 = s_front * z4608 - c_front * z4610;
    const Scalar z4636 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z4641 = s_roll * z4637 - c_roll * z4635;
    const Scalar z4644 = a_roll * c_pitch + s_pitch * z4643;
    const Scalar z4640 = s_roll * z4635 + c_roll * z4637;
    const Scalar z4632 = s_rear * z4591 + c_rear * z4592;
    const Scalar z4631 = s_rear * z4592 - c_rear * z4591;
    const Scalar z4629 = z4596 - z4601;
    const Scalar z4630 = z4587 * z4588;
    const Scalar z4586 = v_yaw * z4573 - v_roll * z4574 + v_pitch * z4576 + v_steer * z4582 + v_front * z4585;
    const Scalar z4650 = v_pitch * z4591 + z4645;  // angular acceleration of frame, z
    const Scalar z4648 = v_pitch * z4592 - z4644;  // angular acceleration of frame, x
    const Scalar z4649 = a_pitch + z4642;  // angular acceleration of frame, y
    const Scalar z4653 = z4599 + z4650;
    const Scalar z4646 = s_pitch * z4641 - c_pitch * z4636;
    const Scalar z4647 = s_pitch * z4636 + c_pitch * z4641;
    const Scalar z4654 = z4600 + z4648;
    const Scalar z4652 = z4598 + z4649;
    const Scalar z4655 = z4598 - z4649;
    const Scalar z4657 = c_steer * z4649 + z4207 * z4648 + z4209 * z4650;
    const Scalar z4660 = z4640 - n1_1 * z4653 - n0_3 * z4654;
    const Scalar z4674 = z4619 * z4633;
    const Scalar z4677 = n0_28 * z4674;  // moment on front_wheel, z
    const Scalar z4651 = a_rear + z4649;  // angular acceleration of rear_wheel, y
    const Scalar z4666 = v_steer * z4606 - z4657;  // angular acceleration of fork, y
    const Scalar z4696 = n0_12 * z4651;  // moment on rear_wheel, y
    const Scalar z4658 = z4208 * z4648 - z4209 * z4649 + z4210 * z4650;
    const Scalar z4667 = z4658 + z32 * a_steer - z4604 * z4607;  // angular acceleration of fork, z
    const Scalar z4659 = n1_1 * z4597 + z4646 - n0_3 * z4652;
    const Scalar z4661 = n0_3 * z4602 - z4647 - n1_1 * z4655;
    const Scalar z4673 = z4619 * z4634;
    const Scalar z4675 = n0_28 * z4673;  // moment on front_wheel, x
    const Scalar z4693 = z4594 * z4632;
    const Scalar z4695 = n0_12 * z4693;  // moment on rear_wheel, x
    const Scalar z4656 = z4206 * z4648 - z4207 * z4649 + z4208 * z4650;
    const Scalar z4665 = z31 * a_steer - z4656 + z4604 * z4609;  // angular acceleration of fork, x
    const Scalar z4668 = z4614 + z4666;
    const Scalar z4694 = z4594 * z4631;
    const Scalar z4697 = n0_12 * z4694;  // moment on rear_wheel, z
    const Scalar z4672 = a_front - z4666;  // angular acceleration of front_wheel, y
    const Scalar z4676 = n0_28 * z4672;  // moment on front_wheel, y
    const Scalar z4671 = z4614 - z4666;
    const Scalar z4678 = s_front * z4677 - c_front * z4675;
    const Scalar z4679 = s_front * z4675 + c_front * z4677;
    const Scalar z4662 = z4207 * z4660 - z4208 * z4661 + z4206 * z4659;
    const Scalar z4663 = c_steer * z4660 - z4207 * z4659 + z4209 * z4661;
    const Scalar z4664 = z4209 * z4660 - z4210 * z4661 + z4208 * z4659;
    // moment on fork, y
    const Scalar z4684 = k31 * z4614 + k4 * z4624 + n2_5667 * z4666 - z4676 - n3_85 * z4662 - n1_04 * z4664;
    const Scalar z4727 = z4596 + z4601;
    const Scalar z4728 = z4600 - z4648;
    const Scalar z4669 = z4615 + z4667;
    const Scalar z4683 = z4678 + k33 * z4616 + k3 * z4665 - n3_85 * z4663 - k4 * z4669;  // moment on fork, x
    const Scalar z4699 = s_rear * z4695 - c_rear * z4697;
    const Scalar z4698 = s_rear * z4697 + c_rear * z4695;
    const Scalar z4680 = n1_04 * z4613 + n3_85 * z4668 - n7 * z4662;  // force on fork, x
    const Scalar z4670 = z4616 + z4665;
    const Scalar z4730 = n2 * z4593;
    const Scalar z4734 = n2 * z4632;
    const Scalar z4732 = n2 * z4631;
    const Scalar z4733 = n2 * z4594;
    const Scalar z4739 = z31 * z4664 + z32 * z4662;
    const Scalar z4682 = n3_85 * z4618 + n1_04 * z4671 + n7 * z4664;  // force on fork, z
    const Scalar z4685 = z4679 + k35 * z4615 + k5 * z4667 + n1_04 * z4663 - k4 * z4670;  // moment on fork, z
    const Scalar z4735 = z32 * z4604;
    const Scalar z4737 = z31 * z4604;
    const Scalar z4736 = z31 * z4610 + z32 * z4608;
    const Scalar z4729 = n2 * z4591;
    const Scalar z4738 = z32 * z4663;
    const Scalar z4731 = n2 * z4592;
    const Scalar z4681 = n7 * z4663 + n1_04 * z4669 - n3_85 * z4670;  // force on fork, y
    const Scalar z4741 = z31 * z4613 + z32 * z4668;
    const Scalar z4743 = z32 * z4618 + z31 * z4671;
    const Scalar z4745 = n2 * z4604;
    const Scalar z4744 = n2 * z4608;
    const Scalar z4742 = z31 * z4669 - z32 * z4670;
    const Scalar z4740 = z31 * z4663;
    const Scalar z4686 = z4206 * z4680 - z4208 * z4682 + z4207 * z4681;
    const Scalar z4700 = n25_5 * z4597 - z4686 + n51 * z4652;  // force on frame, x
    const Scalar z4746 = n2 * z4610;
    const Scalar z4690 = c_steer * z4684;
    const Scalar z4718 = z4587 * z4587;
    const Scalar z4719 = z4588 * z4588;
    const Scalar z4720 = z4718 + z4719;
    const Scalar z4726 = z4599 - z4650;
    const Scalar z4687 = z4209 * z4682 - z4207 * z4680 + c_steer * z4681;
    const Scalar z4747 = z32 * z4745;
    const Scalar z4688 = z4208 * z4680 - z4210 * z4682 + z4209 * z4681;
    const Scalar z4702 = n51 * z4602 - z4688 + n25_5 * z4655;  // force on frame, z
    const Scalar z4748 = z31 * z4746 + z32 * z4744;
    const Scalar z4721 = z4590 - z4643;
    const Scalar z4691 = z4207 * z4683 - z4690 - z4209 * z4685;
    // moment on frame, y
    const Scalar z4704 = z4696 + n29_35 * z4598 + n49_25 * z4649 + n17_7 * z4629 - n25_5 * z4647 + n51 * z4646 + n0_3
        * z4686 + n1_1 * z4688 + z4691;
    const Scalar z4709 = n39_8603 * (z4589 - z4642) + z4704;  // moment on frame.2, y
    const Scalar z4722 = z4589 - z4642;
    const Scalar z4692 = z4209 * z4684 + z4208 * z4683 - z4210 * z4685;
    // moment on frame, z
    const Scalar z4705 = z4699 + n49_25 * z4599 - n25_5 * z4640 - n29_35 * z4650 - n17_7 * z4654 - n1_1 * z4687 - z4692;
    const Scalar z4689 = z4207 * z4684 + z4206 * z4683 - z4208 * z4685;
    // moment on frame, x
    const Scalar z4703 = z4698 + n78_6 * z4600 + n51 * z4640 - n17_7 * z4653 - n0_3 * z4687 - z4689;
    const Scalar z4750 = n2 * z4633;
    const Scalar z4752 = n2 * z4634;
    const Scalar z4755 = n0_14 * z4750;
    const Scalar z4753 = n0_14 * z4752;
    const Scalar z4751 = n2 * z4619;
    const Scalar z4754 = n0_14 * z4751;
    const Scalar z4758 = k4 * z4745;
    const Scalar z4759 = n3_85 * z4745;
    const Scalar z4756 = s_front * z4755 - c_front * z4753;
    const Scalar z4757 = s_front * z4753 + c_front * z4755;
    const Scalar z4760 = n3_85 * z4744 + n1_04 * z4746;
    const Scalar z4749 = z31 * z4745;
    const Scalar z4725 = n2 * z4588;
    const Scalar z4724 = n2 * z4587;
    const Scalar z4701 = n25_5 * z4653 - z4687 - n51 * z4654;  // force on frame, y
    const Scalar z4761 = n1_04 * z4745;
    const Scalar z4762 = n0_1435 * z4746 - z4756;
    const Scalar z4764 = z4756 + k4 * z4744 + k39 * z4746;
    const Scalar z4765 = z4757 + k40 * z4744 + k4 * z4746;
    const Scalar z4763 = k40 * z4745 + z4754;
    const Scalar z4707 = s_pitch * z4700 + c_pitch * z4702;
    const Scalar z4723 = n2 * v_roll;
    const Scalar z4708 = s_pitch * z4703 + c_pitch * z4705;
    const Scalar z4710 = n79_7206 * z4590 - z4708;  // moment on frame.2, z
    const Scalar z4706 = s_pitch * z4702 - c_pitch * z4700;
    const Scalar z4766 = k39 * z4745 + z4754;
    const Scalar z4767 = n0_1435 * z4744 - z4757;
    const Scalar z4768 = n0_3 * z4730;
    const Scalar z4770 = n1_1 * z4730;
    const Scalar z4769 = n0_3 * z4729 - n1_1 * z4731;
    const Scalar z4711 = s_roll * z4707 - c_roll * z4701;
    const Scalar z4771 = z4206 * z4759 + z4208 * z4761 + z4207 * z4760;
    const Scalar z4712 = s_roll * z4701 + c_roll * z4707;
    const Scalar z4717 = n87 * z4635 - z4712;  // force on frame.z, z
    const Scalar z4772 = c_steer * z4760 - z4207 * z4759 - z4209 * z4761;
    const Scalar z4713 = c_yaw * z4706 + s_yaw * z4711;
    const Scalar z4715 = n87 * a_x + z4713;  // force on frame.z, x
    const Scalar z4773 = z4208 * z4759 + z4210 * z4761 + z4209 * z4760;
    const Scalar z4714 = s_yaw * z4706 - c_yaw * z4711;
    const Scalar z4774 = n7 * z4768 - z4771;
    const Scalar z4775 = n7 * z4769 - z4772;
    const Scalar z4716 = n87 * a_y + z4714;  // force on frame.z, y
    const Scalar z4776 = n7 * z4770 - z4773;
    const Scalar z4805 = n0_06 * z4734;
    const Scalar z4807 = n0_06 * z4732;
    const Scalar z4806 = n0_06 * z4733;
    const Scalar z4779 = z4208 * z4758;
    const Scalar z4777 = z4206 * z4758 + z4208 * z4766 + z4207 * z4764;
    const Scalar z4784 = z4779 + z4210 * z4766 + z4209 * z4764;
    const Scalar z4780 = z4779 + z4206 * z4763 + z4207 * z4765;
    const Scalar z4778 = z4206 * z4762 - z4208 * z4767;
    const Scalar z4785 = z4208 * z4762 - z4210 * z4767;
    const Scalar z4782 = z4207 * z4762 - z4209 * z4767;
    const Scalar z4781 = c_steer * z4764 - z4207 * z4758 - z4209 * z4766;
    const Scalar z4786 = z4210 * z4758 + z4208 * z4763 + z4209 * z4765;
    const Scalar z4783 = c_steer * z4765 - z4207 * z4763 - z4209 * z4758;
    const Scalar z4789 = z4208 * z4777 - z4209 * z4778 - z4210 * z4780;
    const Scalar z4798 = z4237 * z4768 - z4789 + n0_3 * z4774;
    const Scalar z4793 = z4206 * z4784 - z4207 * z4785 - z4208 * z4786;
    const Scalar z4802 = z4235 * z4770 - z4793 - n1_1 * z4776;
    const Scalar z4787 = z4206 * z4777 - z4207 * z4778 - z4208 * z4780;
    const Scalar z4788 = c_steer * z4778 + z4207 * z4777 - z4209 * z4780;
    const Scalar z4796 = z4235 * z4768 - z4787 - n1_1 * z4774;
    const Scalar z4811 = z4798 + z4806;
    const Scalar z4814 = z4802 - z4806;
    const Scalar z4817 = n51 * z4730 - z4774;
    const Scalar z4797 = z4236 * z4768 - z4788;
    const Scalar z4822 = n39_3 * z4730 + z4811;
    const Scalar z4825 = n9_95 * z4730 - z4814;
    const Scalar z4795 = z4208 * z4784 - z4209 * z4785 - z4210 * z4786;
    const Scalar z4794 = c_steer * z4785 + z4207 * z4784 - z4209 * z4786;
    const Scalar z4804 = z4237 * z4770 - z4795 + n0_3 * z4776;
    const Scalar z4819 = n25_5 * z4730 + z4776;
    const Scalar z4816 = n17_7 * z4730;
    const Scalar z4820 = z4796 + z4816;
    const Scalar z4803 = z4236 * z4770 - z4794;
    const Scalar z4792 = z4209 * z4782 + z4208 * z4781 - z4210 * z4783;
    const Scalar z4801 = z4237 * z4769 - z4792 + n0_3 * z4775;
    const Scalar z4827 = z4804 - z4816;
    const Scalar z4790 = z4207 * z4782 + z4206 * z4781 - z4208 * z4783;
    const Scalar z4791 = c_steer * z4782 - z4207 * z4781 + z4209 * z4783;
    const Scalar z4799 = z4235 * z4769 - z4790 - n1_1 * z4775;
    const Scalar z4818 = n51 * z4729 - z4775 + n25_5 * z4731;
    const Scalar z4800 = z4236 * z4769 + z4791;
    const Scalar z4858 = n7 * z4636 - z4706;
    const Scalar z4857 = n7 * z4637 - z4711;
    const Scalar z4866 = z4287 * z4636;
    const Scalar z4809 = s_rear * z4805 - c_rear * z4807;
    const Scalar z4808 = s_rear * z4807 + c_rear * z4805;
    const Scalar z4813 = z4801 + z4809;
    const Scalar z4810 = z4797 - z4808;
    const Scalar z4812 = z4799 + z4808;
    const Scalar z4815 = z4803 - z4809;
    const Scalar z4826 = n39_3 * z4729 - z4815;
    const Scalar z4821 = n39_3 * z4731 - z4810;
    const Scalar z4824 = z4813 + n39_3 * z4729 + n17_7 * z4731;
    const Scalar z4823 = z4812 + n17_7 * z4729 + n9_95 * z4731;
    const Scalar z4830 = z4820 - z4827;
    const Scalar z4828 = s_pitch * z4819 + c_pitch * z4817;
    const Scalar z4869 = z4236 * z4720 + z4270 * z4721 + z4588 * z4828 + n7 * z4640 + z4701;
    const Scalar z4868 = z4269 * z4720 + z4270 * z4722 - z4587 * z4828 - n7 * z4641 + z4707;
    const Scalar z4831 = z4822 - z4825;
    const Scalar z4836 = s_pitch * z4830 + c_pitch * z4831;
    const Scalar z4829 = s_pitch * z4817 - c_pitch * z4819;
    const Scalar z4880 = z4270 * z4725 + z4818;
    const Scalar z4870 = z4270 * z4640;
    const Scalar z4837 = s_pitch * z4836;
    const Scalar z4879 = z4270 * z4724 - z4829;
    const Scalar z4832 = s_pitch * z4826 - c_pitch * z4821;
    const Scalar z4842 = n39_8603 * z4725 + z4832;
    const Scalar z4833 = s_pitch * z4821 + c_pitch * z4826;
    const Scalar z4845 = n39_8603 * z4723 - z4833;
    const Scalar z4838 = z4827 + z4837;
    const Scalar z4839 = z4820 - z4837;
    const Scalar z4834 = s_pitch * z4824 - c_pitch * z4823;
    const Scalar z4883 = s_roll * z4880 - c_roll * z4879;
    const Scalar z4884 = s_roll * z4879 + c_roll * z4880;
    const Scalar z4835 = s_pitch * z4823 + c_pitch * z4824;
    const Scalar z4891 = z4255 * z4726 + z4258 * z4728 + z4262 * z4646 + z4263 * z4647 - z4268 * z4727 + z4591 * z4824
        + z4592 * z4823;
    const Scalar z4897 = z4236 * z4728 + z4263 * z4727 - n7 * z4647 - z4591 * z4818 + z4702;
    const Scalar z4899 = z4236 * z4726 - z4262 * z4727 + n7 * z4646 + z4592 * z4818 - z4700;
    const Scalar z4896 = z4269 * z4637 + z4273 * z4636;
    const Scalar z4898 = z4262 * z4728 + z4263 * z4726 - z4591 * z4817 - z4592 * z4819;
    const Scalar z4846 = s_roll * z4829 - c_roll * z4818;
    const Scalar z4867 = z4236 * z4722 - z4269 * z4721 + z4588 * z4829 + z4587 * z4818;
    const Scalar z4847 = z4800 + z4838;
    const Scalar z4889 = z4820 + z4827;
    const Scalar z4888 = z4800 - z4827;
    const Scalar z4890 = z4800 - z4820;
    const Scalar z4840 = c_pitch * z4836 - z4822;
    const Scalar z4900 = z4705 + z4236 * z4646 + z4254 * z4726 - z4255 * z4727 + z4265 * z4728 - z4592 * z4888 - z4591
        * z4822;
    const Scalar z4841 = c_pitch * z4836 + z4825;
    const Scalar z4901 = z4236 * z4647 - z4703 + z4258 * z4727 - z4265 * z4726 + z4266 * z4728 - z4591 * z4890 + z4592
        * z4825;
    const Scalar z4892 = z4889 + z4255 * z4731 - z4258 * z4729;
    const Scalar z4844 = n39_8603 * z4724 + z4840;
    const Scalar z4882 = z4844 + z4272 * z4725 - z4282 * z4724;
    const Scalar z4902 = s_pitch * z4899 - c_pitch * z4897;
    const Scalar z4878 = z4236 * z4724 + z4269 * z4725;
    const Scalar z4864 = z4236 * z4640 - z4269 * z4641 - z4271 * z4721 + z4284 * z4722 + z4285 * z4720 - z4588 * z4842
        - z4587 * z4841;
    const Scalar z4849 = s_roll * z4842 - c_roll * z4841;
    const Scalar z4843 = n39_8603 * z4725 + z4834;
    const Scalar z4903 = s_pitch * z4897 + c_pitch * z4899;
    const Scalar z4881 = z4843 + z4272 * z4724 - z4286 * z4725;
    const Scalar z4894 = z4834 + z4268 * z4725 + z4272 * z4724;
    const Scalar z4848 = z4835 - z4845;
    const Scalar z4850 = s_roll * z4847 - c_roll * z4848;
    const Scalar z4873 = s_roll * z4869 + c_roll * z4868;
    const Scalar z4874 = s_roll * z4868 - c_roll * z4869;
    const Scalar z4885 = s_roll * z4881 - c_roll * z4882;
    const Scalar z4851 = s_roll * z4850;
    const Scalar z4911 = z4236 * z4729 - z4819;
    const Scalar z4852 = z4800 - z4851;
    const Scalar z4912 = z4262 * z4729 - z4263 * z4731;
    const Scalar z4906 = c_roll * z4898 + s_roll * z4903;
    const Scalar z4907 = s_roll * z4898 - c_roll * z4903;
    const Scalar z4855 = z4839 - z4852;
    const Scalar z4886 = s_yaw * z4883 - c_yaw * z4878;
    const Scalar z4887 = s_yaw * z4878 + c_yaw * z4883;
    const Scalar z4853 = s_yaw * z4846 - c_yaw * z4828;
    const Scalar z4913 = z4236 * z4731 + z4817;
    const Scalar z4854 = s_yaw * z4828 + c_yaw * z4846;
    const Scalar z4914 = z4821 + z4254 * z4731 - z4265 * z4729;
    const Scalar z4915 = z4265 * z4731 - z4826 + z4266 * z4729;
    const Scalar z4877 = s_yaw * z4867 - c_yaw * z4873;
    const Scalar z4876 = c_yaw * z4867 + s_yaw * z4873;
    const Scalar z4895 = s_roll * z4889 - c_roll * z4835;
    const Scalar z4893 = z4870 + z4268 * z4721 - z4271 * z4720 - z4272 * z4722 - z4588 * z4889 - z4587 * z4835;
    const Scalar z4910 = s_yaw * z4902 - c_yaw * z4906;
    const Scalar z4909 = c_yaw * z4902 + s_yaw * z4906;
    const Scalar z4863 = z4800 - z4839;
    const Scalar z4872 = z4270 * z4641 - z4709 + z4272 * z4721 - z4284 * z4720 + z4282 * z4722 + z4588 * z4845 + z4587
        * z4863;
    const Scalar z4862 = z4838 + z4839;
    const Scalar z4871 = z4271 * z4720 - z4870 + z4272 * z4722 + z4286 * z4721 - z4710 + z4587 * z4835 + z4588 * z4862;
    const Scalar z4861 = z4800 - z4838;
    const Scalar z4875 = c_roll * z4872 + s_roll * z4871;
    const Scalar z4865 = z4861 + z4271 * z4725 + z4284 * z4724;
    const Scalar z4856 = z4270 * z4636 + z4288 * z4637;
    const Scalar z4917 = s_pitch * z4911 - c_pitch * z4913;
    const Scalar z4916 = s_pitch * z4913 + c_pitch * z4911;
    const Scalar z4859 = s_yaw * z4858 - c_yaw * z4857;
    const Scalar z4860 = c_yaw * z4858 + s_yaw * z4857;
    const Scalar z4949 = z4226 * z4637 - z4230 * z4636;
    const Scalar z4951 = z4735 * z4761 - z4737 * z4759 + n3_85 * z4741 - n1_04 * z4743 + z31 * z4682 - z32 * z4680 - n7
        * z4739;
    const Scalar z4954 = z4737 * z4765 - n3_85 * z4738 - n1_04 * z4740 - n2_8467 * z4742 - z4735 * z4764 + z31 * z4685
        - z32 * z4683;
    const Scalar z4950 = z4737 * z4760 - z4736 * z4761 - n7 * z4738 - n3_85 * z4742 + z32 * z4681;
    const Scalar z4952 = z4736 * z4759 - z4735 * z4760 - n7 * z4740 - n1_04 * z4742 + z31 * z4681;
    const Scalar z4930 = z31 * z4758;
    const Scalar z4933 = z32 * z4758;
    const Scalar z4931 = z32 * z4766 - z4930;
    const Scalar z4934 = z31 * z4763 - z4933;
    const Scalar z4932 = z31 * z4762 + z32 * z4767;
    const Scalar z4955 = z4737 * z4758 - z4735 * z4766 - k4 * z4741 + k5 * z4743 - z4736 * z4767 + n1_04 * z4739 + z31
        * z4684;
    const Scalar z4953 = z4737 * z4763 - z4735 * z4758 - k3 * z4741 + k4 * z4743 + z4736 * z4762 + n3_85 * z4739 + z32
        * z4684;
    const Scalar z4935 = z4735 * z4931 + z4737 * z4934 - z58 * z4741 + z59 * z4743 + z57 * z4739 + z4736 * z4932;
    const Scalar z4938 = z4208 * z4931 + z4210 * z4934 + z4209 * z4932;
    const Scalar z4941 = z4938 + z4217 * z4769 - z4218 * z4768;
    const Scalar z4936 = z4206 * z4931 + z4208 * z4934 + z4207 * z4932;
    const Scalar z4937 = c_steer * z4932 - z4207 * z4931 - z4209 * z4934;
    const Scalar z4939 = z4936 + z4218 * z4770 - z4219 * z4769;
    const Scalar z4940 = z4217 * z4770 - z4937 - z4219 * z4768;
    const Scalar z4956 = z4206 * z4950 + z4207 * z4951 + z4208 * z4952;
    const Scalar z4942 = z4217 * z4647 - z4219 * z4646 - z4223 * z4726 + z4224 * z4727 + z4225 * z4728 - z4591 * z4941
        - z4592 * z4939;
    const Scalar z4943 = z4940 + z4223 * z4731 + z4225 * z4729;
    const Scalar z4958 = z4208 * z4950 + z4209 * z4951 + z4210 * z4952;
    const Scalar z4957 = c_steer * z4951 - z4207 * z4950 - z4209 * z4952;
    const Scalar z4944 = s_pitch * z4941 - c_pitch * z4939;
    const Scalar z4945 = s_pitch * z4939 + c_pitch * z4941;
    const Scalar z4946 = z4218 * z4641 - z4224 * z4721 + z4227 * z4640 - z4228 * z4720 + z4229 * z4722 + z4587 * z4945
        + z4588 * z4940;
    const Scalar z4947 = z4944 + z4224 * z4725 + z4229 * z4724;
    const Scalar z4948 = s_roll * z4940 - c_roll * z4945;
    const Scalar z4920 = c_roll * z4912 + s_roll * z4917;
    const Scalar z4921 = s_roll * z4912 - c_roll * z4917;
    const Scalar z4924 = s_yaw * z4916 + c_yaw * z4920;
    const Scalar z4923 = s_yaw * z4920 - c_yaw * z4916;
    const Scalar z4959 = z4208 * z4955 + z4206 * z4953 + z4207 * z4954;
    const Scalar z4962 = n0_3 * z4957 + z4959;
    const Scalar z4960 = c_steer * z4954 - z4207 * z4953 - z4209 * z4955;
    const Scalar z4961 = z4210 * z4955 + z4208 * z4953 + z4209 * z4954;
    const Scalar z4963 = n0_3 * z4956 - z4960 + n1_1 * z4958;
    const Scalar z4926 = s_pitch * z4808 + c_pitch * z4809;
    const Scalar z4925 = s_pitch * z4809 - c_pitch * z4808;
    const Scalar z4919 = s_pitch * z4914 - c_pitch * z4915;
    const Scalar z4918 = s_pitch * z4915 + c_pitch * z4914;
    const Scalar z4922 = s_roll * z4892 - c_roll * z4919;
    const Scalar z4927 = z4587 * z4926 - n0_12 * z4721;
    const Scalar z4929 = c_roll * z4926;
    const Scalar z4905 = s_pitch * z4900 + c_pitch * z4901;
    const Scalar z4904 = s_pitch * z4901 - c_pitch * z4900;
    const Scalar z4964 = n1_1 * z4957 + z4961;
    const Scalar z4908 = s_roll * z4891 - c_roll * z4905;
    const Scalar z4975 = z31 * z4761 + z32 * z4759 - n3_85 * z4747 - n1_04 * z4749;
    const Scalar z4977 = z4930 - k3 * z4747 - k4 * z4749 + z32 * z4763;
    const Scalar z4979 = z4933 - k4 * z4747 - k5 * z4749 + z31 * z4766;
    const Scalar z4978 = z31 * z4764 + z32 * z4765 - n2_8467 * z4748;
    const Scalar z4974 = z32 * z4760 - n3_85 * z4748;
    const Scalar z4976 = z31 * z4760 - n1_04 * z4748;
    const Scalar z4980 = z4206 * z4974 - z4207 * z4975 + z4208 * z4976;
    const Scalar z4982 = z4208 * z4974 - z4209 * z4975 + z4210 * z4976;
    const Scalar z4981 = z4207 * z4974 + z4209 * z4976 + c_steer * z4975;
    const Scalar z4966 = s_pitch * z4956 + c_pitch * z4958;
    const Scalar z4965 = s_pitch * z4958 - c_pitch * z4956;
    const Scalar z4983 = z4206 * z4977 + z4208 * z4979 + z4207 * z4978;
    const Scalar z4986 = n0_3 * z4981 - z4983;
    const Scalar z4969 = s_roll * z4966 - c_roll * z4957;
    const Scalar z4970 = s_roll * z4957 + c_roll * z4966;
    const Scalar z4985 = z4208 * z4977 + z4210 * z4979 + z4209 * z4978;
    const Scalar z4984 = c_steer * z4978 - z4207 * z4977 - z4209 * z4979;
    const Scalar z4987 = n0_3 * z4980 - z4984 + n1_1 * z4982;
    const Scalar z4973 = s_yaw * z4965 - c_yaw * z4969;
    const Scalar z4972 = c_yaw * z4965 + s_yaw * z4969;
    const Scalar z4968 = s_pitch * z4962 + c_pitch * z4964;
    const Scalar z4967 = s_pitch * z4964 - c_pitch * z4962;
    const Scalar z4971 = s_roll * z4963 - c_roll * z4968;
    const Scalar z4928 = n0_12 * z4725 + z4925;
    const Scalar z4998 = z4735 * z4756 - z4737 * z4757 + n0_28 * z4742;
    const Scalar z4988 = n1_1 * z4981 - z4985;
    const Scalar z5045 = c_yaw * z4354;
    const Scalar z5042 = s_yaw * z4354;
    const Scalar z5043 = n0_35 * z4412 / (z4373 * z4373);
    const Scalar z5046 = z5045 - z4374 * z4409 + z4370 * z5043;
    const Scalar z5039 = z4330 / (z4306 * z4306);
    const Scalar z5044 = z5042 - z4374 * z4407 + z4369 * z5043;
    const Scalar z5014 = z4356 - z4370 * z4374;
    const Scalar z5029 = z4517 - z5014;
    const Scalar z5036 = z4356 - z5014;
    const Scalar z5040 = z4302 * z5039 - z4307 * z4324;
    const Scalar z5015 = z4355 - z4369 * z4374;
    const Scalar z5027 = z4516 - z5015;
    const Scalar z5030 = z4509 * z5029 - z4524;
    const Scalar z5034 = z4355 - z5015;
    const Scalar z5037 = z4364 * z5036 - z4531;
    const Scalar z5028 = z4509 * z5027 - z4526;
    const Scalar z5035 = z4364 * z5034 - z4533;
    const Scalar z5023 = s_roll * z5014 + z4301 * z4501;
    const Scalar z5012 = z4303 * z4307;
    const Scalar z5022 = s_roll * z5015 + z4300 * z4501;
    const Scalar z5041 = z4303 * z5039 - z4307 * z4326;
    const Scalar z5013 = z4302 * z4307;
    const Scalar z5021 = s_roll * z5012 - z4301 * z4477;
    const Scalar z5020 = s_roll * z5013 - z4300 * z4477;
    const Scalar z5001 = z4206 * z4756 - z4208 * z4757;
    const Scalar z4990 = s_pitch * z4980 + c_pitch * z4982;
    const Scalar z4989 = s_pitch * z4982 - c_pitch * z4980;
    const Scalar z5049 = n2 * (c_roll * z4323 + z4302);
    const Scalar z5050 = n2 * (c_roll * z4325 + z4303);
    const Scalar z5002 = z4207 * z4756 - z4209 * z4757;
    const Scalar z5005 = z5002 + z4211 * z4731 + z4213 * z4729;
    const Scalar z5003 = z4208 * z4756 - z4210 * z4757;
    const Scalar z5004 = z4211 * z4726 + z4212 * z4727 - z4213 * z4728 + z4591 * z5003 + z4592 * z5001;
    const Scalar z4999 = z31 * z4756;
    const Scalar z5000 = z4999 + z32 * z4757 - n0_28 * z4748;
    const Scalar z5011 = z32 * z4757 + z4999;
    const Scalar z5024 = l_lambda_rear_rolls_x * z5020;
    const Scalar z4993 = c_roll * z4981 + s_roll * z4990;
    const Scalar z4994 = s_roll * z4981 - c_roll * z4990;
    const Scalar z5007 = s_pitch * z5001 + c_pitch * z5003;
    const Scalar z5008 = z4212 * z4721 - z4214 * z4720 + z4215 * z4722 + z4588 * z5002 + z4587 * z5007;
    const Scalar z5006 = s_pitch * z5003 - c_pitch * z5001;
    const Scalar z5009 = z4212 * z4725 - z5006 - z4215 * z4724;
    const Scalar z5010 = s_roll * z5002 - c_roll * z5007;
    const Scalar z4997 = s_yaw * z4989 - c_yaw * z4993;
    const Scalar z4996 = c_yaw * z4989 + s_yaw * z4993;
    const Scalar z4992 = s_pitch * z4986 + c_pitch * z4988;
    const Scalar z4991 = s_pitch * z4988 - c_pitch * z4986;
    const Scalar z4995 = c_roll * z4992 + s_roll * z4987;
    const Scalar z5060 = n2 * (z4363 * z4363 - z4364 * z4364);
    const Scalar z5073 = s_yaw * z4415;
    const Scalar z5074 = z4364 * z5073 + z4406 * z4415 + z4363 * z4417 + z4366 * z4416;
    const Scalar z5075 = c_yaw * z4415;
    const Scalar z5072 = s_roll * z4350;
    const Scalar z5055 = s_yaw * z4363;
    const Scalar z5056 = n2 * z4363;
    const Scalar z5057 = z4406 * z5056 + z4364 * (z4366 + z5055);
    const Scalar z5058 = c_yaw * z4363;
    const Scalar z5059 = z4408 * z5056 + z4364 * (z4368 + z5058);
    const Scalar z5067 = z4352 - z4374 * z4410 - z4371 * z5043;
    const Scalar z5068 = s_yaw * z5067;
    const Scalar z5051 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z5052 = n2 * (z4302 * z5049 + z4303 * z5050 - z4304 * z5051 - z4324 * z4324 - z4326 * z4326 - z4327
        * z4327);
    const Scalar z5061 = n2 * (z4371 * z5060 - z4410 * z4410 - z4407 * z4407 - z4409 * z4409 + z4369 * z5057 + z4370
        * z5059);
    const Scalar z5062 = n0_5 * (z4411 * z4412 / (z4373 * z4373) + z5061 / z4373);
    const Scalar z5069 = c_yaw * z5067;
    const Scalar z5064 = z4304 * z5039 - z4307 * z4327;
    const Scalar z5066 = c_yaw * z5064;
    const Scalar z5065 = s_yaw * z5064;
    const Scalar z5018 = l_lambda_rear_rolls_x * z4479 - l_lambda_rear_rolls_y * z4478 + l_lambda_front_rolls_x * z4503
        - l_lambda_front_rolls_y * z4502;
    const Scalar z5019 = z4866 - z5018;
    const Scalar z5053 = n0_5 * (z4328 * z4329 / (z4306 * z4306) + z5052 / z4306);
    const Scalar z5025 = l_lambda_front_rolls_x * z5022 - z5024 - l_lambda_rear_rolls_y * z5021 + l_lambda_front_rolls_y
        * z5023;
    const Scalar z5026 = z4896 - z5025;
    const Scalar z5033 = l_lambda_rear_rolls_y * z5021 + z5024;
    const Scalar z5031 = l_lambda_front_rolls_x * z5028 + l_lambda_front_rolls_y * z5030;
    const Scalar z5032 = z4949 + z5031;
    const Scalar z5063 = z4354 - n0_35 * z5062;
    const Scalar z5047 = l_lambda_rear_rolls_x * z5041 - l_lambda_rear_rolls_y * z5040 - l_lambda_front_rolls_x * z5046
        + l_lambda_front_rolls_y * z5044;
    const Scalar z5048 = z4875 + z5047;
    const Scalar z5038 = l_lambda_front_rolls_x * z5035 + l_lambda_front_rolls_y * z5037;
    const Scalar z5054 = n0_3 * z5053;
    const Scalar z5016 = l_lambda_rear_rolls_x * z5013 + l_lambda_rear_rolls_y * z5012 - l_lambda_front_rolls_x * z5015
        - l_lambda_front_rolls_y * z5014;
    const Scalar z5017 = z4856 + z5016;
    const Scalar z5076 = z4364 * z5075 + z4363 * z4419 + z4408 * z4415 + z4368 * z4416;
    const Scalar z5100 = z4514 - z5067;
    const Scalar z5110 = z5045 - z5046;
    const Scalar z5111 = z4352 - z5067;
    const Scalar z5113 = z5042 - z5044;
    const Scalar z5077 = n2 * (z4363 * z4415 - z4364 * z4416);
    const Scalar z5078 = n2 * (z4371 * z5077 - z4410 * z4421 + z4407 * z4418 + z4409 * z4420 + z4369 * z5074 + z4370
        * z5076);
    const Scalar z5091 = c_yaw * z4436;
    const Scalar z5092 = z4364 * z5091 + z4408 * z4436 + z4363 * z4441 - z4368 * z4437;
    const Scalar z5093 = n2 * (z4364 * z4437 + z4363 * z4436);
    const Scalar z5088 = s_roll * z4433 - c_roll * z4427;
    const Scalar z5089 = s_yaw * z4436;
    const Scalar z5090 = z4363 * z4439 - z4364 * z5089 + z4366 * z4437 - z4406 * z4436;
    const Scalar z5118 = n0_35 * z4423 / (z4373 * z4373);
    const Scalar z5120 = s_yaw * z4351 - c_yaw * z5072;
    const Scalar z5117 = s_yaw * z5072 + c_yaw * z4351;
    const Scalar z5099 = c_yaw * z4509;
    const Scalar z5097 = c_yaw * z4515;
    const Scalar z5098 = z5046 - z5097;
    const Scalar z5104 = s_yaw * z4509;
    const Scalar z5121 = z4370 * z5118 - z5120 - z4374 * z4420;
    const Scalar z5094 = n2 * (z4410 * z4443 - z4371 * z5093 + z4407 * z4440 - z4409 * z4442 - z4370 * z5092 + z4369
        * z5090);
    const Scalar z5126 = z4414 - z4374 * z4421 + z4371 * z5118;
    const Scalar z5102 = s_yaw * z4515;
    const Scalar z5103 = z5044 - z5102;
    const Scalar z5119 = z5117 - z4374 * z4418 + z4369 * z5118;
    const Scalar z5127 = s_yaw * z5126;
    const Scalar z5128 = c_yaw * z5126;
    const Scalar z5101 = z4508 * z4522 - z4523 * z5099 - z4509 * z5098 + z4511 * z5100;
    const Scalar z5084 = c_roll * z4499 - z4323 * z4501 + s_roll * z5044 - z4300 * z5067;
    const Scalar z5112 = z4363 * z4529 + z4408 * z4530 + z4364 * z5110 - z4368 * z5111;
    const Scalar z5082 = z4323 * z4477 - c_roll * z4475 + s_roll * z5040 + z4300 * z5064;
    const Scalar z5105 = z4508 * z4521 + z4523 * z5104 + z4509 * z5103 - z4510 * z5100;
    const Scalar z5083 = s_roll * z5046 - c_roll * z4500 - z4301 * z5067 - z4325 * z4501;
    const Scalar z5114 = z4363 * z4528 - z4406 * z4530 - z4364 * z5113 + z4366 * z5111;
    const Scalar z5081 = c_roll * z4476 + z4325 * z4477 + s_roll * z5041 + z4301 * z5064;
    const Scalar z5124 = n0_5 * (z4411 * z4423 / (z4373 * z4373) - z5078 / z4373);
    const Scalar z5079 = n0_5 * (z4412 * z4422 / (z4373 * z4373) - z5078 / z4373);
    const Scalar z5125 = z5072 - n0_35 * z5124;
    const Scalar z5080 = z5072 - n0_35 * z5079;
    const Scalar z5095 = n0_5 * (z4412 * z4444 / (z4373 * z4373) - z5094 / z4373);
    const Scalar z5096 = z5088 + n0_35 * z5095;
    const Scalar z5085 = l_lambda_rear_rolls_x * z5081;
    const Scalar z5115 = l_lambda_front_rolls_x * z5112 + l_lambda_front_rolls_y * z5114;
    const Scalar z5116 = z5008 - z5115;
    const Scalar z5108 = l_lambda_rear_rolls_y * z5082 - z5085;
    const Scalar z5086 = l_lambda_rear_rolls_y * z5082 - z5085 + l_lambda_front_touches * z5080 - l_lambda_front_rolls_y
        * z5084 + l_lambda_front_rolls_x * z5083;
    const Scalar z5109 = z4927 - z5108;
    const Scalar z5106 = l_lambda_front_touches * z5096 + l_lambda_front_rolls_x * z5101 + l_lambda_front_rolls_y
        * z5105;
    const Scalar z5122 = l_lambda_front_rolls_x * z5121 - l_lambda_front_rolls_y * z5119;
    const Scalar z5123 = z4908 + z5122;
    const Scalar z5070 = l_lambda_rear_touches * z5054 + l_lambda_rear_rolls_x * z5065 + l_lambda_rear_rolls_y * z5066
        + l_lambda_front_rolls_x * z5068 + l_lambda_front_rolls_y * z5069 - l_lambda_front_touches * z5063;
    const Scalar z5107 = z4946 + z5106;
    const Scalar z5087 = z4893 + z5086;
    const Scalar z5071 = z4864 + z5070;
    const Scalar z5132 = s_yaw * z4362 + z4365;
    const Scalar z5136 = c_yaw * z4362 - z4367;
    const Scalar z5174 = z4414 - z5126;
    const Scalar z5176 = z5117 - z5119;
    const Scalar z5173 = z5120 + z5121;
    const Scalar z5187 = n0_5 * (z4411 * z4445 / (z4373 * z4373) - z5094 / z4373);
    const Scalar z5188 = z5088 + n0_35 * z5187;
    const Scalar z5133 = c_roll * z4361;
    const Scalar z5150 = c_roll * z4438;
    const Scalar z5148 = s_roll * z4438;
    const Scalar z5138 = n2 * (z4364 * z5133 - z4415 * z4415);
    const Scalar z5146 = s_pitch * z4432 - c_pitch * z4430;
    const Scalar z5152 = s_yaw * z4435 + c_yaw * z5148;
    const Scalar z5149 = s_yaw * z5148 - c_yaw * z4435;
    const Scalar z5153 = z4364 * z5152 - z4419 * z4436 - z4415 * z4441 - z4368 * z5150;
    const Scalar z5151 = z4415 * z4439 + z4364 * z5149 - z4417 * z4436 - z4366 * z5150;
    const Scalar z5154 = n2 * (z4364 * z5150 - z4415 * z4436);
    const Scalar z5134 = n2 * z4415;
    const Scalar z5135 = z4364 * z5132 - z4417 * z5134 - z4366 * z5133;
    const Scalar z5137 = z4364 * z5136 - z4419 * z5134 - z4368 * z5133;
    const Scalar z5155 = n2 * (z4421 * z4443 + z4371 * z5154 + z4420 * z4442 - z4418 * z4440 + z4370 * z5153 + z4369
        * z5151);
    const Scalar z5139 = n2 * (z4421 * z4421 + z4371 * z5138 + z4420 * z4420 + z4418 * z4418 + z4369 * z5135 + z4370
        * z5137);
    const Scalar z5183 = s_yaw * z5146 - c_yaw * z5088;
    const Scalar z5162 = s_roll * z4506;
    const Scalar z5140 = n0_5 * (z4422 * z4423 / (z4373 * z4373) - z5139 / z4373);
    const Scalar z5180 = c_yaw * z5146 + s_yaw * z5088;
    const Scalar z5181 = n0_35 * z4445 / (z4373 * z4373);
    const Scalar z5158 = c_roll * z4506;
    const Scalar z5159 = s_roll * z4512;
    const Scalar z5169 = c_yaw * z4507 + s_yaw * z5162;
    const Scalar z5163 = s_yaw * z4507 - c_yaw * z5162;
    const Scalar z5164 = c_roll * z4512;
    const Scalar z5165 = z5126 - z5164;
    const Scalar z5184 = z5183 + z4374 * z4442 + z4370 * z5181;
    const Scalar z5167 = c_yaw * z4513 + s_yaw * z5159;
    const Scalar z5168 = z5119 - z5167;
    const Scalar z5182 = z4369 * z5181 - z5180 - z4374 * z4440;
    const Scalar z5160 = s_yaw * z4513 - c_yaw * z5159;
    const Scalar z5161 = z5121 + z5160;
    const Scalar z5142 = z4301 * z5126 + s_roll * z5121;
    const Scalar z5143 = s_roll * z5119 + z4300 * z5126;
    const Scalar z5166 = z4522 * z5158 - z4523 * z5163 - z4511 * z5165 + z4509 * z5161;
    const Scalar z5170 = z4523 * z5169 - z4521 * z5158 + z4509 * z5168 - z4510 * z5165;
    const Scalar z5175 = z4415 * z4529 + z4419 * z4530 - z4368 * z5174 + z4364 * z5173;
    const Scalar z5177 = z4415 * z4528 - z4417 * z4530 + z4364 * z5176 + z4366 * z5174;
    const Scalar z5131 = c_roll * z4351;
    const Scalar z5141 = z5131 - n0_35 * z5140;
    const Scalar z5147 = c_roll * z5146;
    const Scalar z5156 = n0_5 * (z4423 * z4444 / (z4373 * z4373) + z5155 / z4373);
    const Scalar z5157 = z5147 + n0_35 * z5156;
    const Scalar z5178 = l_lambda_front_rolls_x * z5175 + l_lambda_front_rolls_y * z5177;
    const Scalar z5179 = z5004 - z5178;
    const Scalar z5144 = l_lambda_front_touches * z5141 - l_lambda_front_rolls_y * z5143 + l_lambda_front_rolls_x
        * z5142;
    const Scalar z5171 = l_lambda_front_rolls_x * z5166 - l_lambda_front_rolls_y * z5170 - l_lambda_front_touches
        * z5157;
    const Scalar z5172 = z4942 - z5171;
    const Scalar z5185 = l_lambda_front_rolls_x * z5184 - l_lambda_front_rolls_y * z5182;
    const Scalar z5186 = z4971 - z5185;
    const Scalar z5145 = z4891 + z5144;
    const Scalar z5129 = l_lambda_front_rolls_x * z5127 + l_lambda_front_rolls_y * z5128 + l_lambda_front_touches
        * z5125;
    const Scalar z5130 = z4904 - z5129;
    const Scalar z5224 = k33 * z4616 + z4622 + k3 * z4665 - n3_85 * z4663 - k4 * z4669;  // moment on fork, x
    const Scalar z5225 = k35 * z4615 + z4623 + k5 * z4667 + n1_04 * z4663 - k4 * z4670;  // moment on fork, z
    const Scalar z5234 = z4590 + z4643;
    const Scalar z5217 = z5183 - z5184;
    const Scalar z5220 = z5180 + z5182;
    const Scalar z5194 = n0_5 * (z4422 * z4445 / (z4373 * z4373) + z5155 / z4373);
    const Scalar z5195 = z5147 + n0_35 * z5194;
    const Scalar z5228 = z4209 * z4684 + z4208 * z5224 - z4210 * z5225;
    const Scalar z5226 = z4207 * z4684 + z4206 * z5224 - z4208 * z5225;
    // moment on frame, z
    const Scalar z5231 = z4628 - n25_5 * z4640 + n9_95 * z4653 - n17_7 * z4654 - n1_1 * z4687 - z5228;
    // moment on frame, x
    const Scalar z5229 = z4627 + n51 * z4640 - n17_7 * z4653 + n39_3 * z4654 - n0_3 * z4687 - z5226;
    const Scalar z5239 = a_z - a_roll * z4330 - z4344;
    const Scalar z5240 = a_z + a_roll * z4413 - a_pitch * z4424 - a_steer * z4446 + z4474;
    const Scalar z5242 = a_y - z4481 * (a_pitch + a_rear) - a_yaw * z4475 + a_roll * z4479 - z4498;
    const Scalar z5227 = z4207 * z5224 - z4690 - z4209 * z5225;
    // moment on frame, y
    const Scalar z5230 = z4696 + n29_35 * z4598 + n49_25 * z4649 + n17_7 * z4629 - n25_5 * z4647 + n51 * z4646 + n0_3
        * z4686 + n1_1 * z4688 + z5227;
    const Scalar z5238 = z31 * z5224 + z32 * z5225;
    const Scalar z5241 = a_x + a_yaw * z4500 - a_roll * z4502 + a_pitch * z4504 + a_steer * z4525 + a_front * z4532
        + z4569;
    const Scalar z5243 = a_y - a_yaw * z4499 + a_roll * z4503 - a_pitch * z4505 - a_steer * z4527 - a_front * z4534
        - z4586;
    const Scalar z5244 = z4480 * (a_pitch + a_rear) + a_x + a_yaw * z4476 - a_roll * z4478 + z4491;
    const Scalar z5208 = n2 * (z4436 * z4441 + z4364 * z4368);
    const Scalar z5209 = n2 * (z4364 * z4364 - z4436 * z4436);
    const Scalar z5189 = z4374 * z4443 - z4434 + z4371 * z5181;
    const Scalar z5218 = z4434 + z5189;
    const Scalar z5190 = s_yaw * z5189;
    const Scalar z5191 = c_yaw * z5189;
    const Scalar z5196 = s_roll * z5184 + z4301 * z5189;
    const Scalar z5197 = z4300 * z5189 + s_roll * z5182;
    const Scalar z5207 = n2 * (z4364 * z4366 - z4436 * z4439);
    const Scalar z5210 = n2 * (z4370 * z5208 - z4443 * z4443 - z4371 * z5209 - z4440 * z4440 - z4442 * z4442 + z4369
        * z5207);
    const Scalar z5245 = v_yaw * z5015;
    const Scalar z5213 = z4509 * z5184 - z4511 * z5189;
    const Scalar z5214 = z4509 * z5182 - z4510 * z5189;
    const Scalar z5219 = z4436 * z4529 + z4441 * z4530 + z4364 * z5217 - z4368 * z5218;
    const Scalar z5201 = c_steer * z200;
    const Scalar z5221 = z4436 * z4528 + z4439 * z4530 + z4366 * z5218 + z4364 * z5220;
    const Scalar z5211 = n0_5 * (z4444 * z4445 / (z4373 * z4373) + z5210 / z4373);
    const Scalar z5200 = c_steer * (n1 - z199);
    const Scalar z5202 = n0_08 * z5200 - n0_35 * z5201;
    const Scalar z5203 = c_steer * (n1 - z201);
    const Scalar z5204 = n0_08 * z5201 - n0_35 * z5203;
    const Scalar z5246 = v_roll * z4503 - z5245 - v_pitch * z5022 - v_steer * z5028 + v_front * z5035;
    const Scalar z5205 = c_pitch * z5204 + s_pitch * z5202;
    const Scalar z5247 = v_roll * z4503 - z5245 - v_pitch * z5022 - v_steer * z5028 + v_front * z5035 - z4543;
    const Scalar z5206 = c_roll * z5205 - z4353;
    const Scalar z5248 = z4570 - z4374 * z4399 + z4369 * z4541;
    const Scalar z5249 = z4575 - z4311 * z5015 + s_roll * z5248 - z4300 * z4545;
    const Scalar z5212 = z5206 + n0_35 * z5211;
    const Scalar z5250 = z4577 + z5248;
    const Scalar z5251 = z4550 * z5027 - z4581 + z4509 * z5250 - z4510 * z4562;
    const Scalar z5215 = l_lambda_front_rolls_x * z5213 - l_lambda_front_touches * z5212 - l_lambda_front_rolls_y
        * z5214;
    const Scalar z5222 = l_lambda_front_rolls_x * z5219 + l_lambda_front_rolls_y * z5221;
    const Scalar z5223 = z4998 + z5222;
    const Scalar z5232 = s_pitch * z5231 - c_pitch * z5229;
    const Scalar z5216 = z4935 + z5215;
    const Scalar z5235 = n0_5603 * (a_roll + z4630) + z5232;  // moment on frame.2, x
    const Scalar z5233 = s_pitch * z5229 + c_pitch * z5231;
    const Scalar z5236 = z5233 - n0_5603 * z5234;  // moment on frame.2, z
    const Scalar z5198 = l_lambda_front_rolls_x * z5196 - l_lambda_front_rolls_y * z5197 - l_lambda_front_touches
        * z5195;
    const Scalar z5199 = z4963 - z5198;
    const Scalar z5237 = s_roll * z5230 + c_roll * z5236;
    const Scalar z5192 = l_lambda_front_rolls_x * z5190 + l_lambda_front_rolls_y * z5191 - l_lambda_front_touches
        * z5188;
    const Scalar z5193 = z4967 + z5192;
    const Scalar z5252 = z4570 - z5248;
    const Scalar z5253 = z4394 * z5034 - z4584 + z4364 * z5252 + z4366 * z4566;
    const Scalar z5259 = z4303 * z4482 - z4483;
    const Scalar z5277 = z4302 * z4482 - z4492;
    const Scalar z5260 = z4311 * z5012 + z4317 * z4477 + s_roll * z5259 - z4489;
    const Scalar z5254 = v_yaw * z5248 + v_pitch * z5249 + v_roll * z4574 - v_steer * z5251 - v_front * z5253;
    const Scalar z5255 = a_yaw * z5015 - a_roll * z4503 + a_pitch * z5022 + a_steer * z5028 - a_front * z5035 - z5254;
    const Scalar z5261 = v_yaw * z5259 - v_roll * z4488 + z5260 * (v_pitch + v_rear);
    const Scalar z5278 = z4311 * z5013 + z4314 * z4477 + s_roll * z5277 - z4496;
    const Scalar z5279 = v_yaw * z5277 + z5278 * (v_pitch + v_rear) + v_roll * z4495;
    const Scalar z5262 = z5021 * (a_pitch + a_rear) + a_yaw * z5012 - a_roll * z4478 + z5261;
    const Scalar z5256 = v_yaw * z5012;
    const Scalar z5284 = c_yaw * z4311 - s_roll * z4316;
    const Scalar z5280 = z5020 * (a_pitch + a_rear) + a_yaw * z5013 + a_roll * z4479 + z5279;
    const Scalar z5274 = v_yaw * z5013;
    const Scalar z5285 = c_roll * z4317;
    const Scalar z5312 = z4394 * z4406;
    const Scalar z5286 = z4301 * z4313 + z4311 * z4325 + s_roll * z5284 + z5285;
    const Scalar z5289 = z4315 * z4324;
    const Scalar z5287 = c_roll * z4311;
    const Scalar z5311 = s_yaw * z4394 - z4312 * z4364;
    const Scalar z5315 = z4394 * z4408;
    const Scalar z5282 = z4311 * z4323;
    const Scalar z5314 = z4316 * z4364 + c_yaw * z4394;
    const Scalar z5281 = s_yaw * z4311 + s_roll * z4312;
    const Scalar z5288 = n2 * (s_roll * z4313 - z5287);
    const Scalar z5298 = z4319 * z4333 - n4 * z5287;
    const Scalar z5313 = z4366 * z4396 - z5312 - z4364 * z5311 + z4363 * z4398;
    const Scalar z5316 = z5315 - z4368 * z4396 + z4364 * z5314 + z4363 * z4400;
    const Scalar z5283 = z4300 * z4313 + z5282 + s_roll * z5281 + c_roll * z4314;
    const Scalar z5290 = n2 * (z4303 * z5286 - z5289 - z4320 * z4327 - z4304 * z5288 - z4318 * z4326 + z4302 * z5283);
    const Scalar z5291 = z4321 * z4329;
    const Scalar z5306 = n4 * z4311 * z4313 + n2 * (s_roll * z4331 + c_roll * z4335);
    const Scalar z5302 = s_yaw * z4335 + s_roll * z4332 - z4312 * z4336;
    const Scalar z5303 = z4323 * z4335 - z4300 * z4331 - n2 * (z4311 * z5281 - z4313 * z4314) + s_roll * z5302 - c_roll
        * z4334;
    const Scalar z5292 = n0_5 * (z5291 / (z4306 * z4306) + z5290 / z4306);
    const Scalar z5294 = z4312 * z4319 + s_yaw * z4336;
    const Scalar z5295 = z4300 * z4333 + s_roll * z5294 + n2 * (c_roll * z4314 + z5282);
    const Scalar z5296 = c_yaw * z4336 - z4316 * z4319;
    const Scalar z5297 = z4301 * z4333 + s_roll * z5296 + n2 * (z4311 * z4325 + z5285);
    const Scalar z5304 = c_yaw * z4335 + s_roll * z4338 + z4316 * z4336;
    const Scalar z5305 = z4325 * z4335 - z4301 * z4331 - n2 * (z4311 * z5284 - z4313 * z4317) + s_roll * z5304 - c_roll
        * z4339;
    const Scalar z5299 = n2 * (z4302 * z5295 + z4303 * z5297 - z4304 * z5298) - n4 * (z5289 + z4320 * z4327 + z4318
        * z4326);
    const Scalar z5307 = n4 * (z4318 * z5286 - z4320 * z5288 + z4315 * z5283) + n2 * (z4304 * z5306 - z4327 * z4341
        + z4324 * z4337 + z4326 * z4340 + z4302 * z5303 + z4303 * z5305);
    const Scalar z5308 = n0_5 * (z4322 * z5290 / (z4306 * z4306) + z4329 * z4342 / (z4306 * z4306) - z5307 / z4306
        + z4321 * z5292 / (z4306 * z4306)) + z4322 * z5291 / (z4306 * z4306 * z4306);
    const Scalar z5300 = n0_5 * (z4322 * z4328 / (z4306 * z4306) + z5291 / (z4306 * z4306) + z5299 / z4306);
    const Scalar z5293 = n0_3 * z5292;
    const Scalar z5301 = n0_3 * z5300;
    const Scalar z5263 = v_yaw * z5014;
    const Scalar z5257 = v_roll * z4478 - z5256 - z5021 * (v_pitch + v_rear);
    const Scalar z5258 = v_roll * z4478 - z5256 - z5021 * (v_pitch + v_rear) + z4494;
    const Scalar z5323 = n2 * (s_roll * z4390 + z4537) - z4333 * z4346 - z4336 * z4351;
    const Scalar z5309 = n0_3 * z5308;
    const Scalar z5317 = n2 * (z4363 * z4394 + z4364 * z4396);
    const Scalar z5310 = a_roll * z5054 + z5309;
    const Scalar z5318 = z4403 * z4410;
    const Scalar z5319 = n2 * (z5318 - z4371 * z5317 - z4401 * z4409 + z4369 * z5313 - z4370 * z5316 + z4399 * z4407);
    const Scalar z5320 = z4404 * z4412;
    const Scalar z5264 = z5263 + v_roll * z4502 + v_pitch * z5023 + v_steer * z5030 - v_front * z5037;
    const Scalar z5265 = z5263 + v_roll * z4502 + v_pitch * z5023 + v_steer * z5030 - v_front * z5037 + z4573;
    const Scalar z5324 = z4333 * z4361 - c_steer * z4336 + n2 * (s_roll * z4383 - c_roll * z4393);
    const Scalar z5325 = s_yaw * z5324 - z4312 * z4402;
    const Scalar z5275 = z5274 + v_roll * z4479 + z5020 * (v_pitch + v_rear);
    const Scalar z5276 = z5274 + v_roll * z4479 + z5020 * (v_pitch + v_rear) - z4485;
    const Scalar z5321 = n0_5 * (z5320 / (z4373 * z4373) - z5319 / z4373);
    const Scalar z5266 = z4539 + z4374 * z4401 + z4370 * z4541;
    const Scalar z5326 = c_steer * z4333 + z4336 * z4361 + n2 * (s_roll * z4393 + z4395);
    const Scalar z5268 = z4554 + z5266;
    const Scalar z5269 = z4550 * z5029 + z4563 + z4509 * z5268 - z4511 * z4562;
    const Scalar z5267 = z4547 - z4311 * z5014 + s_roll * z5266 - z4301 * z4545;
    const Scalar z5327 = z4366 * z5326 - z4364 * z5325 + n2 * (z4363 * z4398 - z5312);
    const Scalar z5328 = z4316 * z4402 + c_yaw * z5324;
    const Scalar z5329 = z4364 * z5328 - z4368 * z5326 + n2 * (z4363 * z4400 + z5315);
    const Scalar z5270 = z4539 - z5266;
    const Scalar z5271 = z4394 * z5036 + z4567 + z4364 * z5270 + z4368 * z4566;
    const Scalar z5330 = n4 * z4363 * z4394 + z4402 * z5326;
    const Scalar z5322 = z4538 - n0_35 * z5321;
    const Scalar z5331 = n4 * (z5318 - z4401 * z4409 + z4399 * z4407) + n2 * (z4369 * z5327 - z4370 * z5329 - z4371
        * z5330);
    const Scalar z5272 = v_yaw * z5266 - v_roll * z4546 + v_pitch * z5267 - v_steer * z5269 - v_front * z5271;
    const Scalar z5273 = a_yaw * z5014 + a_roll * z4502 + a_pitch * z5023 + a_steer * z5030 - a_front * z5037 - z5272;
    const Scalar z5334 = z4335 * z4351 - z4331 * z4346 - c_roll * z4450 + n2 * (z4311 * z4390 - z4313 * z4381) + s_roll
        * z4459;
    const Scalar z5368 = n0_6 * z4322 * z4329 / (z4306 * z4306 * z4306) + z5293 / (z4306 * z4306);
    const Scalar z5370 = z4307 * z5288 - z4320 * z5039 - z4327 * z4482 + z4304 * z5368;
    const Scalar z5369 = z4302 * z5368 - z4307 * z5283 - z4315 * z5039 - z4324 * z4482;
    const Scalar z5332 = n0_5 * (z5320 / (z4373 * z4373) - z5331 / z4373 + z4405 * z4411 / (z4373 * z4373));
    const Scalar z5333 = z5323 - n0_35 * z5332;
    const Scalar z5393 = z4303 * z5368 - z4307 * z5286 - z4318 * z5039 - z4326 * z4482;
    const Scalar z5372 = z4313 * z4475 + z4477 * z5281 - c_roll * z4494 + z4311 * z5040 - z4314 * z5064 + z4323 * z4487
        + z4300 * z5370 + s_roll * z5369;
    const Scalar z5339 = n4 * z4394;
    const Scalar z5340 = n2 * (z4363 * z4465 - z4364 * z4462) - z4396 * z5339;
    const Scalar z5337 = z4338 * z4364 - z4316 * z4466 + c_yaw * z4465;
    const Scalar z5335 = z4332 * z4364 + z4312 * z4466 + s_yaw * z4465;
    const Scalar z5395 = z4477 * z5284 - z4313 * z4476 + c_roll * z4485 + z4311 * z5041 - z4317 * z5064 + z4325 * z4487
        + z4301 * z5370 + s_roll * z5393;
    const Scalar z5338 = n2 * (z4394 * z5314 + z4396 * z4400) - z4368 * z4462 - z4408 * z4465 + z4363 * z4468 - z4364
        * z5337;
    const Scalar z5336 = z4366 * z4462 + z4406 * z4465 - n2 * (z4394 * z5311 - z4396 * z4398) + z4363 * z4464 + z4364
        * z5335;
    const Scalar z5341 = n4 * (z4403 * z5317 + z4399 * z5313 + z4401 * z5316) + n2 * (z4371 * z5340 - z4410 * z4470
        - z4409 * z4469 + z4407 * z4467 - z4370 * z5338 + z4369 * z5336);
    const Scalar z5342 = n0_5 * (z5341 / z4373 - z4412 * z4471 / (z4373 * z4373) - z4405 * z5319 / (z4373 * z4373)
        + z4404 * z5321 / (z4373 * z4373)) + z4412 * z4472 / (z4373 * z4373 * z4373);
    const Scalar z5400 = z4316 * z4361;
    const Scalar z5402 = c_roll * z4397 - z4313 * z4360;
    const Scalar z5399 = z4311 * z4360 + s_roll * z4397;
    const Scalar z5401 = z4312 * z4416 + z5400 - c_yaw * z4393 + s_yaw * z5399;
    const Scalar z5348 = n0_7 * z4405;
    const Scalar z5349 = z4412 * z5348 / (z4373 * z4373 * z4373) + n0_35 * z5321 / (z4373 * z4373);
    const Scalar z5345 = v_roll * z5068;
    const Scalar z5347 = v_yaw * z5046 - z5345 + z4546 + v_steer * z5101 - v_front * z5112 + v_pitch * z5083;
    const Scalar z5346 = v_yaw * z5046 - z5345 + v_steer * z5101 - v_front * z5112 + v_pitch * z5083;
    const Scalar z5343 = z5334 - n0_35 * z5342;
    const Scalar z5344 = a_roll * z5063 + a_pitch * z5080 + a_steer * z5096 - z5343;
    const Scalar z5404 = z4312 * z4361 - z4316 * z4416 + s_yaw * z4393 + c_yaw * z5399;
    const Scalar z5352 = z4538 - z4374 * z5317 + z4403 * z5043 + z4410 * z4541 + z4371 * z5349;
    const Scalar z5357 = z4553 + z5352;
    const Scalar z5361 = z4538 - z5352;
    const Scalar z5405 = z4394 * z4419;
    const Scalar z5408 = z4401 * z4420;
    const Scalar z5407 = n2 * (z4364 * z5402 - z4394 * z4415);
    const Scalar z5406 = z4364 * z5404 - z5405 - z4368 * z5402 - z4400 * z4415;
    const Scalar z5403 = z4364 * z5401 - z4366 * z5402 - z4394 * z4417 + z4398 * z4415;
    const Scalar z5375 = v_yaw * z5044;
    const Scalar z5377 = v_roll * z5069 + z5375 + v_pitch * z5084 - v_steer * z5105 + v_front * z5114 - z4574;
    const Scalar z5376 = v_roll * z5069 + z5375 + v_pitch * z5084 - v_steer * z5105 + v_front * z5114;
    const Scalar z5409 = n2 * (z5408 + z4403 * z4421 + z4371 * z5407 - z4399 * z4418 + z4370 * z5406 + z4369 * z5403);
    const Scalar z5398 = z4313 * z4350 + c_roll * z4536;
    const Scalar z5365 = v_yaw * z5040;
    const Scalar z5367 = v_roll * z5066 - z5365 - z4495 - z5082 * (v_pitch + v_rear);
    const Scalar z5366 = v_roll * z5066 - z5365 - z5082 * (v_pitch + v_rear);
    const Scalar z5358 = c_yaw * z4550 - z4316 * z4509;
    const Scalar z5350 = c_yaw * z4391 - z4316 * z4354;
    const Scalar z5378 = z4312 * z4354 + s_yaw * z4391;
    const Scalar z5351 = z5350 - z4374 * z5316 + z4401 * z5043 - z4409 * z4541 + z4370 * z5349;
    const Scalar z5379 = z5378 + z4374 * z5313 - z4399 * z5043 - z4407 * z4541 + z4369 * z5349;
    const Scalar z5410 = z4404 * z4423;
    const Scalar z5411 = n0_5 * (z5410 / (z4373 * z4373) + z5409 / z4373);
    const Scalar z5384 = z4312 * z4509 + s_yaw * z4550;
    const Scalar z5390 = v_yaw * z5041;
    const Scalar z5392 = v_roll * z5065 + z5390 - z4488 + z5081 * (v_pitch + v_rear);
    const Scalar z5354 = z4313 * z4500 - z4501 * z5284 + z4311 * z5046 + z4317 * z5067 - c_roll * z4543 - z4325 * z4545
        + s_roll * z5351 + z4301 * z5352;
    const Scalar z5381 = z4311 * z5044 - z4313 * z4499 - z4501 * z5281 + z4314 * z5067 + c_roll * z4573 - z4323 * z4545
        + s_roll * z5379 + z4300 * z5352;
    const Scalar z5391 = v_roll * z5065 + z5390 + z5081 * (v_pitch + v_rear);
    const Scalar z5360 = z5350 - z5351;
    const Scalar z5362 = z4363 * z4565 - z4396 * z4529 - z4530 * z5314 - z4394 * z5110 - z4400 * z5111 + z4408 * z4566
        + z4364 * z5360 + z4368 * z5361;
    const Scalar z5386 = z5378 - z5379;
    const Scalar z5387 = z4530 * z5311 - z4396 * z4528 + z4394 * z5113 - z4398 * z5111 + z4363 * z4583 - z4406 * z4566
        - z4364 * z5386 - z4366 * z5361;
    const Scalar z5412 = z5398 + n0_35 * z5411;
    const Scalar z5355 = c_yaw * z4560 - z4316 * z4515;
    const Scalar z5382 = z4312 * z4515 + s_yaw * z4560;
    const Scalar z5356 = z5351 - z5355;
    const Scalar z5383 = z5379 - z5382;
    const Scalar z5353 = s_yaw * z5352 - z4312 * z5067;
    const Scalar z5359 = z4523 * z5358 - z4522 * z4558 + z4550 * z5098 + z4559 * z5100 + z4508 * z4556 + z4562 * z5099
        + z4509 * z5356 - z4511 * z5357;
    const Scalar z5385 = z4521 * z4558 + z4523 * z5384 + z4550 * z5103 - z4580 * z5100 + z4508 * z4579 + z4562 * z5104
        + z4509 * z5383 - z4510 * z5357;
    const Scalar z5363 = v_yaw * z5351 + v_roll * z5353 + v_pitch * z5354 - v_steer * z5359 - v_front * z5362;
    const Scalar z5364 = a_yaw * z5046 - a_roll * z5068 + a_pitch * z5083 + a_steer * z5101 - a_front * z5112 + z5363;
    const Scalar z5429 = z4349 * z4457 + s_pitch * z4456 + c_pitch * z4454 + z4348 * z4458 + n2 * (z4382 * z4389 - z4386
        * z4387);
    const Scalar z5380 = z4316 * z5067 + c_yaw * z5352;
    const Scalar z5388 = v_yaw * z5379 - v_roll * z5380 + v_pitch * z5381 - v_steer * z5385 + v_front * z5387;
    const Scalar z5430 = z4331 * z4350 - z4333 * z4536 + c_roll * z5429;
    const Scalar z5413 = n2 * z4387;
    const Scalar z5414 = n2 * z4382;
    const Scalar z5415 = z4348 * z5413 - z4349 * z5414 + n2 * (c_pitch * z4386 + z4535);
    const Scalar z5417 = z4207 * z5413 + z4209 * z5414 + n2 * (s_pitch * z4380 - c_pitch * z4379);
    const Scalar z5419 = z4207 * z5414 - z4209 * z5413 + n2 * (s_pitch * z4379 + c_pitch * z4380);
    const Scalar z5389 = a_yaw * z5044 + a_roll * z5069 + a_pitch * z5084 - a_steer * z5105 + a_front * z5114 + z5388;
    const Scalar z5416 = z4333 * z4350 + c_roll * z5415;
    const Scalar z5418 = z4336 * z4360 + s_roll * z5417;
    const Scalar z5420 = n2 * (z4312 * z4416 + z5400) - c_yaw * z5419 + s_yaw * z5418;
    const Scalar z5423 = n2 * (z4312 * z4361 - z4316 * z4416) + s_yaw * z5419 + c_yaw * z5418;
    const Scalar z5421 = c_roll * z5417 - z4333 * z4360;
    const Scalar z5424 = z4364 * z5423 - z4368 * z5421 - n2 * (z4400 * z4415 + z5405);
    const Scalar z5422 = z4364 * z5420 - z4366 * z5421 - n2 * (z4394 * z4417 - z4398 * z4415);
    const Scalar z5425 = z4402 * z5421 - z4415 * z5339;
    const Scalar z5371 = c_yaw * z5370 - z4316 * z5064;
    const Scalar z5426 = n2 * (z4371 * z5425 + z4369 * z5422 + z4370 * z5424) - n4 * (z4399 * z4418 - z5408 - z4403
        * z4421);
    const Scalar z5373 = v_yaw * z5369 - v_roll * z5371 + z5372 * (v_pitch + v_rear);
    const Scalar z5374 = z5082 * (a_pitch + a_rear) + a_yaw * z5040 - a_roll * z5066 + z5373;
    const Scalar z5446 = s_roll * z4536 - z4311 * z4350;
    const Scalar z5394 = z4312 * z5064 + s_yaw * z5370;
    const Scalar z5396 = v_roll * z5394 + v_yaw * z5393 + z5395 * (v_pitch + v_rear);
    const Scalar z5427 = n0_5 * (z5426 / z4373 + z5410 / (z4373 * z4373) + z4405 * z4422 / (z4373 * z4373));
    const Scalar z5433 = z4331 * z4360 + z4333 * z4397 + c_roll * z4463;
    const Scalar z5431 = z4335 * z4360 - z4336 * z4397 + s_roll * z4463;
    const Scalar z5397 = z5081 * (a_pitch + a_rear) + a_yaw * z5041 + a_roll * z5065 + z5396;
    const Scalar z5481 = z32 * z4383;
    const Scalar z5482 = z31 * z4383;
    const Scalar z5485 = z200 * z4378;
    const Scalar z5484 = -z4378 * (n1 - z199);
    const Scalar z5486 = n0_35 * z5485 + n0_08 * z5484;
    const Scalar z5437 = z5339 * z5402 + n2 * (z4364 * z5433 + z4415 * z4465);
    const Scalar z5428 = z5416 + n0_35 * z5427;
    const Scalar z5489 = z4382 * z4430;
    const Scalar z5487 = -z4378 * (n1 - z201);
    const Scalar z5488 = n0_08 * z5485 + n0_35 * z5487;
    const Scalar z5435 = z4332 * z4361 + z4338 * z4416 - n2 * (z4312 * z4393 - z4316 * z5399) + s_yaw * z4461 + c_yaw
        * z5431;
    const Scalar z5432 = z4332 * z4416 - z4338 * z4361 - n2 * (z4316 * z4393 + z4312 * z5399) - c_yaw * z4461 + s_yaw
        * z5431;
    const Scalar z5436 = n2 * (z4394 * z5404 + z4400 * z5402) - z4368 * z5433 + z4419 * z4465 + z4364 * z5435 - z4415
        * z4468;
    const Scalar z5434 = z4417 * z4465 - z4366 * z5433 + n2 * (z4394 * z5401 - z4398 * z5402) + z4364 * z5432 + z4415
        * z4464;
    const Scalar z5438 = n4 * (z4399 * z5403 - z4401 * z5406 - z4403 * z5407) + n2 * (z4371 * z5437 - z4421 * z4470
        + z4420 * z4469 - z4418 * z4467 + z4370 * z5436 + z4369 * z5434);
    const Scalar z5439 = n0_5 * (z4405 * z5409 / (z4373 * z4373) - z4423 * z4471 / (z4373 * z4373) - z5438 / z4373
        + z4404 * z5411 / (z4373 * z4373)) + z4423 * z4472 / (z4373 * z4373 * z4373);
    const Scalar z5445 = z4423 * z5348 / (z4373 * z4373 * z4373) + n0_35 * z5411 / (z4373 * z4373);
    const Scalar z5449 = z4403 * z5118 - z5398 - z4374 * z5407 - z4421 * z4541 + z4371 * z5445;
    const Scalar z5462 = z5398 + z5449;
    const Scalar z5493 = z4387 * z4426;
    const Scalar z5496 = z4382 * z4426;
    const Scalar z5498 = z4316 * z4438;
    const Scalar z5494 = z5493 + s_pitch * z5481 - z4382 * z4425 + c_pitch * z5482;
    const Scalar z5497 = s_pitch * z5482 - z5496 - z4387 * z4425 - c_pitch * z5481;
    const Scalar z5440 = z5430 + n0_35 * z5439;
    const Scalar z5500 = s_steer * z4311;
    const Scalar z5441 = a_roll * z5125 + a_pitch * z5141 + a_steer * z5157 + z5440;
    const Scalar z5490 = z4387 * z4432 - z5489 + s_pitch * z5486 - c_pitch * z5488;
    const Scalar z5501 = s_roll * z4378 + z5500 + z4313 * z4435 + c_roll * z5494;
    const Scalar z5495 = s_steer * z4313 - c_roll * z4378 - z4311 * z4435 + s_roll * z5494;
    const Scalar z5499 = z5498 - z4312 * z4437 + c_yaw * z5497 + s_yaw * z5495;
    const Scalar z5483 = n0_08 * z5481 - n0_35 * z5482;
    const Scalar z5491 = z4311 * z4427;
    const Scalar z5442 = v_yaw * z5121;
    const Scalar z5444 = v_roll * z5127 + z5442 + v_pitch * z5142 - v_steer * z5166 + v_front * z5175 - z4548;
    const Scalar z5443 = v_roll * z5127 + z5442 + v_pitch * z5142 - v_steer * z5166 + v_front * z5175;
    const Scalar z5502 = z4394 * z4439;
    const Scalar z5504 = z4312 * z4438;
    const Scalar z5506 = z4394 * z4441;
    const Scalar z5503 = z5502 - z4366 * z5501 + z4364 * z5499 + z4398 * z4436;
    const Scalar z5505 = s_yaw * z5497 - z5504 - z4316 * z4437 - c_yaw * z5495;
    const Scalar z5466 = v_yaw * z5119;
    const Scalar z5468 = v_roll * z5128 - z5466 - v_pitch * z5143 + v_steer * z5170 + v_front * z5177 - z4576;
    const Scalar z5467 = v_roll * z5128 - z5466 - v_pitch * z5143 + v_steer * z5170 + v_front * z5177;
    const Scalar z5492 = s_roll * z5483 - z5491 + z4313 * z4433 + c_roll * z5490;
    const Scalar z5458 = s_roll * z4557 - z4311 * z4506;
    const Scalar z5457 = z4313 * z4506 + c_roll * z4557;
    const Scalar z5447 = s_yaw * z4390 - z4312 * z4351 - z4316 * z5072 - c_yaw * z5446;
    const Scalar z5469 = z4316 * z4351 - z4312 * z5072 + c_yaw * z4390 + s_yaw * z5446;
    const Scalar z5448 = z5447 - z4374 * z5406 + z4401 * z5118 - z4420 * z4541 + z4370 * z5445;
    const Scalar z5470 = z4369 * z5445 - z5469 - z4374 * z5403 - z4399 * z5118 - z4418 * z4541;
    const Scalar z5509 = z4401 * z4442;
    const Scalar z5508 = n2 * (z4364 * z5501 - z4394 * z4436);
    const Scalar z5507 = z4368 * z5501 + z5506 + z4400 * z4436 + z4364 * z5505;
    const Scalar z5461 = z5447 - z5448;
    const Scalar z5475 = z4316 * z4507 - c_yaw * z4549 - z4312 * z5162 + s_yaw * z5458;
    const Scalar z5459 = z4312 * z4507 + s_yaw * z4549 + z4316 * z5162 + c_yaw * z5458;
    const Scalar z5463 = z4400 * z5174 - z4529 * z5402 - z4530 * z5404 - z4415 * z4565 - z4419 * z4566 + z4394 * z5173
        + z4364 * z5461 - z4368 * z5462;
    const Scalar z5477 = z5469 + z5470;
    const Scalar z5478 = z4530 * z5401 - z4528 * z5402 + z4394 * z5176 + z4398 * z5174 - z4415 * z4583 + z4417 * z4566
        + z4366 * z5462 + z4364 * z5477;
    const Scalar z5452 = z4311 * z4512 + s_roll * z4551;
    const Scalar z5455 = c_roll * z4551 - z4313 * z4512;
    const Scalar z5456 = z5449 - z5455;
    const Scalar z5453 = z4312 * z4513 + s_yaw * z4552 + z4316 * z5159 - c_yaw * z5452;
    const Scalar z5473 = c_yaw * z4552 - z4316 * z4513 + z4312 * z5159 + s_yaw * z5452;
    const Scalar z5454 = z5448 + z5453;
    const Scalar z5460 = z4559 * z5165 - z4522 * z5457 - z4523 * z5459 - z4556 * z5158 - z4562 * z5163 + z4550 * z5161
        + z4509 * z5454 - z4511 * z5456;
    const Scalar z5474 = z5470 - z5473;
    const Scalar z5476 = z4521 * z5457 - z4523 * z5475 + z4550 * z5168 - z4580 * z5165 + z4562 * z5169 - z4579 * z5158
        - z4510 * z5456 + z4509 * z5474;
    const Scalar z5450 = z4312 * z5126 + s_yaw * z5449;
    const Scalar z5510 = n2 * (z5509 + z4403 * z4443 + z4371 * z5508 + z4369 * z5503 - z4370 * z5507 + z4399 * z4440);
    const Scalar z5471 = c_yaw * z5449 - z4316 * z5126;
    const Scalar z5451 = z4311 * z5121 - z4317 * z5126 + s_roll * z5448 + z4301 * z5449;
    const Scalar z5464 = v_yaw * z5448 + v_roll * z5450 + v_pitch * z5451 - v_steer * z5460 - v_front * z5463;
    const Scalar z5472 = z4311 * z5119 - z4314 * z5126 + z4300 * z5449 + s_roll * z5470;
    const Scalar z5479 = v_yaw * z5470 - v_roll * z5471 + v_pitch * z5472 - v_steer * z5476 + v_front * z5478;
    const Scalar z5465 = a_yaw * z5121 + a_roll * z5127 + a_pitch * z5142 - a_steer * z5166 + a_front * z5175 + z5464;
    const Scalar z5514 = n2 * z4383;
    const Scalar z5538 = z32 * z4451;
    const Scalar z5539 = z31 * z4451;
    const Scalar z5516 = z31 * z5514;
    const Scalar z5515 = z32 * z5514;
    const Scalar z5480 = a_yaw * z5119 - a_roll * z5128 + a_pitch * z5143 - a_steer * z5170 - a_front * z5177 + z5479;
    const Scalar z5528 = s_pitch * z5516 - n2 * (z4387 * z4425 + z5496) - c_pitch * z5515;
    const Scalar z5526 = s_pitch * z5515 - n2 * (z4382 * z4425 - z5493) + c_pitch * z5516;
    const Scalar z5517 = n0_08 * z5515 - n0_35 * z5516;
    const Scalar z5548 = z4425 * z4457 + z4426 * z4458 + s_pitch * z5538 + c_pitch * z5539 + n2 * (z4382 * z5481 - z4387
        * z5482);
    const Scalar z5550 = z4426 * z4457 - z4425 * z4458 + s_pitch * z5539 - c_pitch * z5538 + n2 * (z4382 * z5482 + z4387
        * z5481);
    const Scalar z5540 = n0_08 * z5538 - n0_35 * z5539;
    const Scalar z5552 = s_roll * z4447 + s_steer * z4335 - z4331 * z4435 - n2 * (z4311 * z4378 - z4313 * z5494)
        - c_roll * z5548;
    const Scalar z5549 = c_roll * z4447 + s_steer * z4331 + z4335 * z4435 + n2 * (z4313 * z4378 + z4311 * z5494)
        + s_roll * z5548;
    const Scalar z5518 = n2 * z4378;
    const Scalar z5530 = n2 * (z4313 * z4435 + z5500) + s_roll * z5518 + c_roll * z5526;
    const Scalar z5527 = n2 * (s_steer * z4313 - z4311 * z4435) - c_roll * z5518 + s_roll * z5526;
    const Scalar z5511 = z4404 * z4445;
    const Scalar z5529 = c_yaw * z5528 - n2 * (z4312 * z4437 - z5498) + s_yaw * z5527;
    const Scalar z5532 = s_yaw * z5528 - n2 * (z4316 * z4437 + z5504) - c_yaw * z5527;
    const Scalar z5531 = z4364 * z5529 - z4366 * z5530 + n2 * (z4398 * z4436 + z5502);
    const Scalar z5533 = z4368 * z5530 + n2 * (z4400 * z4436 + z5506) + z4364 * z5532;
    const Scalar z5534 = z4402 * z5530 - z4436 * z5339;
    const Scalar z5535 = n4 * (z5509 + z4403 * z4443 + z4399 * z4440) + n2 * (z4371 * z5534 + z4369 * z5531 - z4370
        * z5533);
    const Scalar z5556 = z5339 * z5501 + n2 * (z4364 * z5552 + z4436 * z4465);
    const Scalar z5554 = z4332 * z4438 - z4338 * z4437 + n2 * (z4312 * z5497 + z4316 * z5495) + s_yaw * z5550 - c_yaw
        * z5549;
    const Scalar z5551 = z4338 * z4438 + z4332 * z4437 + n2 * (z4312 * z5495 - z4316 * z5497) + c_yaw * z5550 + s_yaw
        * z5549;
    const Scalar z5555 = z4441 * z4465 - z4368 * z5552 - n2 * (z4394 * z5505 - z4400 * z5501) + z4364 * z5554 - z4436
        * z4468;
    const Scalar z5553 = z4366 * z5552 + z4439 * z4465 - n2 * (z4394 * z5499 - z4398 * z5501) + z4364 * z5551 - z4436
        * z4464;
    const Scalar z5557 = n2 * (z4443 * z4470 - z4371 * z5556 - z4442 * z4469 - z4440 * z4467 - z4370 * z5555 + z4369
        * z5553) - n4 * (z4399 * z5503 + z4401 * z5507 - z4403 * z5508);
    const Scalar z5536 = n0_5 * (z5511 / (z4373 * z4373) - z5535 / z4373 + z4405 * z4444 / (z4373 * z4373));
    const Scalar z5512 = n0_5 * (z5511 / (z4373 * z4373) - z5510 / z4373);
    const Scalar z5558 = n0_5 * (z4404 * z5512 / (z4373 * z4373) - z4405 * z5510 / (z4373 * z4373) - z4445 * z4471
        / (z4373 * z4373) - z5557 / z4373) + z4445 * z4472 / (z4373 * z4373 * z4373);
    const Scalar z5564 = z4445 * z5348 / (z4373 * z4373 * z4373) + n0_35 * z5512 / (z4373 * z4373);
    const Scalar z5513 = z5492 - n0_35 * z5512;
    const Scalar z5561 = v_roll * z5190;
    const Scalar z5563 = v_yaw * z5184 + z5561 + v_pitch * z5196 - v_steer * z5213 - v_front * z5219 - z4564;
    const Scalar z5569 = z5492 + z4374 * z5508 + z4403 * z5181 + z4443 * z4541 + z4371 * z5564;
    const Scalar z5562 = v_yaw * z5184 + z5561 + v_pitch * z5196 - v_steer * z5213 - v_front * z5219;
    const Scalar z5574 = z5492 - z5569;
    const Scalar z5578 = v_yaw * z5182;
    const Scalar z5565 = z4382 * z4432 + z4387 * z4430 + s_pitch * z5488 + c_pitch * z5486;
    const Scalar z5542 = z200 * z4447;
    const Scalar z5566 = s_roll * z5490 - c_roll * z5483 - z4311 * z4433 - z4313 * z4427;
    const Scalar z5541 = -z4447 * (n1 - z199);
    const Scalar z5543 = n0_35 * z5542 + n0_08 * z5541;
    const Scalar z5544 = -z4447 * (n1 - z201);
    const Scalar z5545 = n0_08 * z5542 + n0_35 * z5544;
    const Scalar z5567 = z4312 * z5146 + z4316 * z5088 + s_yaw * z5565 + c_yaw * z5566;
    const Scalar z5546 = s_pitch * z5543 - z4432 * z4458 - z4430 * z4457 - c_pitch * z5545 - n2 * (z4382 * z5486 + z4387
        * z5488);
    const Scalar z5568 = z5567 - z4374 * z5507 + z4401 * z5181 + z4442 * z4541 + z4370 * z5564;
    const Scalar z5520 = z200 * z5518;
    const Scalar z5519 = -z5518 * (n1 - z199);
    const Scalar z5522 = -z5518 * (n1 - z201);
    const Scalar z5521 = n0_35 * z5520 + n0_08 * z5519;
    const Scalar z5581 = z4316 * z5146 - z4312 * z5088 - c_yaw * z5565 + s_yaw * z5566;
    const Scalar z5582 = z5581 + z4374 * z5503 - z4399 * z5181 - z4440 * z4541 + z4369 * z5564;
    const Scalar z5547 = z4335 * z4427 + s_roll * z5540 + z4331 * z4433 + n2 * (z4311 * z5483 - z4313 * z5490) - c_roll
        * z5546;
    const Scalar z5523 = n0_08 * z5520 + n0_35 * z5522;
    const Scalar z5524 = s_pitch * z5521 - c_pitch * z5523 + n2 * (z4387 * z4432 - z5489);
    const Scalar z5571 = z4311 * z5184 - z4317 * z5189 + s_roll * z5568 + z4301 * z5569;
    const Scalar z5584 = z4311 * z5182 - z4314 * z5189 + s_roll * z5582 + z4300 * z5569;
    const Scalar z5525 = s_roll * z5517 + n2 * (z4313 * z4433 - z5491) + c_roll * z5524;
    const Scalar z5572 = z4550 * z5184 + z4559 * z5189 + z4509 * z5568 - z4511 * z5569;
    const Scalar z5585 = z4550 * z5182 - z4580 * z5189 + z4509 * z5582 - z4510 * z5569;
    const Scalar z5559 = z5547 - n0_35 * z5558;
    const Scalar z5560 = a_roll * z5188 + a_pitch * z5195 - a_steer * z5212 + z5559;
    const Scalar z5537 = z5525 - n0_35 * z5536;
    const Scalar z5570 = z4312 * z5189 + s_yaw * z5569;
    const Scalar z5583 = c_yaw * z5569 - z4316 * z5189;
    const Scalar z5573 = z5567 - z5568;
    const Scalar z5575 = z4529 * z5501 - z4530 * z5505 - z4394 * z5217 - z4400 * z5218 + z4436 * z4565 + z4441 * z4566
        + z4364 * z5573 + z4368 * z5574;
    const Scalar z5586 = z5581 - z5582;
    const Scalar z5587 = z4530 * z5499 - z4528 * z5501 + z4398 * z5218 - z4436 * z4583 - z4439 * z4566 + z4394 * z5220
        + z4364 * z5586 + z4366 * z5574;
    const Scalar z5576 = v_yaw * z5568 + v_roll * z5570 + v_pitch * z5571 - v_steer * z5572 - v_front * z5575;
    const Scalar z5577 = a_yaw * z5184 + a_roll * z5190 + a_pitch * z5196 - a_steer * z5213 - a_front * z5219 + z5576;
    const Scalar z5588 = v_yaw * z5582 - v_roll * z5583 + v_pitch * z5584 - v_steer * z5585 - v_front * z5587;
    const Scalar z5589 = a_yaw * z5182 - a_roll * z5191 + a_pitch * z5197 - a_steer * z5214 + a_front * z5221 + z5588;
    const Scalar z5580 = v_roll * z5191 - z5578 - v_pitch * z5197 + v_steer * z5214 - v_front * z5221 + z4582;
    const Scalar z5579 = v_roll * z5191 - z5578 - v_pitch * z5197 + v_steer * z5214 - v_front * z5221;
    const Scalar z5595 = n1 / z4532;
    const Scalar z5596 = z4534 * z5595;
    const Scalar z5590 = n1 / z4424;
    const Scalar z5615 = z4330 + z4413;
    const Scalar z5616 = z5590 * z5615;
    const Scalar z5617 = z4446 * z5590;
    const Scalar z5593 = z4505 * z5590;
    const Scalar z5597 = z4499 - z4500 * z5596;
    const Scalar z5646 = z5412 * z5617 - z5513;
    const Scalar z5645 = z5322 - z5412 * z5616;
    const Scalar z5647 = z5346 + z5443 * z5616;
    const Scalar z5648 = z5443 * z5617 + z5562;
    const Scalar z5598 = z4475 - z5597;
    const Scalar z5649 = z5376 - z5467 * z5616;
    const Scalar z5650 = z5467 * z5617 + z5579;
    const Scalar z5609 = z5598 * z5598;
    const Scalar z5599 = n1 / z5598;
    const Scalar z5592 = z4481 * z5590;
    const Scalar z5591 = z4504 * z5590;
    const Scalar z5651 = z5264 - z5257 + z5246 * z5596;
    const Scalar z5629 = z4446 * z5592;
    const Scalar z5628 = z4446 * z5591 - z4525;
    const Scalar z5594 = z4480 * z5590;
    const Scalar z5659 = z5293 - z5645;
    const Scalar z5630 = z4446 * z5593 - z4527 - z5629 - z5596 * z5628;
    const Scalar z5619 = z4479 - z5592 * z5615;
    const Scalar z5618 = z4502 - z5591 * z5615;
    const Scalar z5620 = z4503 - z5593 * z5615 - z5619 - z5596 * z5618;
    const Scalar z5600 = z4476 * z5599;
    const Scalar z5660 = z5591 * z5659 - z5647;
    const Scalar z5603 = z4424 * z4424;
    const Scalar z5604 = n1_over_94 + z4446 * z4446 / z195 + z5603 / z4268 + z4413 * z4413 / z4285;
    const Scalar z5652 = z5275 - z5600 * z5651;
    const Scalar z5621 = z4478 - z5594 * z5615 + z5600 * z5620;
    const Scalar z5601 = n1 - z5596 * z5600;
    const Scalar z5661 = z5366 + z5592 * z5659;
    const Scalar z5612 = z5601 * z5601;
    const Scalar z5602 = n1 / z5601;
    const Scalar z5662 = z5593 * z5659 - z5661 + z5649 - z5596 * z5660;
    const Scalar z5638 = z4480 - z4481 * z5600;
    const Scalar z5631 = z4446 * z5594 + z5600 * z5630;
    const Scalar z5606 = z4532 * z4532;
    const Scalar z5607 = n1_over_94 + n25_over_7 * z5606 + z4500 * z4500 / z4297 + z4502 * z4502 / z4285 + z4525 * z4525
        / z195 + z4504 * z4504 / z4268;
    const Scalar z5605 = z4268 * z5604;
    const Scalar z5639 = z5602 * z5638;
    const Scalar z5632 = z5602 * z5631;
    const Scalar z5663 = z5391 + z5594 * z5659 + z5600 * z5662;
    const Scalar z5633 = z5596 * z5632 + z5630;
    const Scalar z5653 = z5602 * z5652;
    const Scalar z5664 = z5602 * z5663;
    const Scalar z5634 = z5599 * z5633;
    const Scalar z5622 = z5602 * z5621;
    const Scalar z5654 = z5596 * z5653 - z5651;
    const Scalar z5665 = z5596 * z5664 + z5662;
    const Scalar z5635 = z4475 * z5634 + z5629;
    const Scalar z5608 = n0_28 * z5607;
    const Scalar z5623 = z5596 * z5622 + z5620;
    const Scalar z5655 = z5599 * z5654;
    const Scalar z5666 = z5599 * z5665;
    const Scalar z5657 = z5246 - z5653 + z4500 * z5655;
    const Scalar z5668 = z5660 - z5664 + z4500 * z5666;
    const Scalar z5656 = z4475 * z5655 - z5257;
    const Scalar z5667 = z4475 * z5666 + z5661;
    const Scalar z5624 = z5599 * z5623;
    const Scalar z5636 = z5628 - z5632 + z4500 * z5634;
    const Scalar z5637 = z5595 * z5636;
    const Scalar z5658 = z5595 * z5657;
    const Scalar z5626 = z5618 - z5622 + z4500 * z5624;
    const Scalar z5669 = z5595 * z5668;
    const Scalar z5627 = z5595 * z5626;
    const Scalar z5625 = z4475 * z5624 + z5619;
    const Scalar z5640 = z4481 - z5596 * z5639;
    const Scalar z5641 = z5599 * z5640;
    const Scalar z5610 = n1_over_94 + n25_over_7 * z4534 * z4534 + z4499 * z4499 / z4297 + z4503 * z4503 / z4285 + z4527
        * z4527 / z195 + z4505 * z4505 / z4268;
    const Scalar z5611 = z4297 * z5610;
    const Scalar z5671 = z5591 * z5646 - z5648;
    const Scalar z5670 = z5590 * z5659;
    const Scalar z5672 = z5592 * z5646;
    const Scalar z5642 = z4475 * z5641 - z4481;
    const Scalar z5643 = z4500 * z5641 + z5639;
    const Scalar z5644 = z5595 * z5643;
    const Scalar z5613 = z4480 * z4480 * (n25_over_3 + n1 / z4268) + n1_over_94 + z4478 * z4478 / z4285 + z4476 * z4476
        / z4297;
    const Scalar z5614 = n94 * z5613;
    const Scalar z5673 = z5593 * z5646 - z5672 - z5650 - z5596 * z5671;
    const Scalar z5682 = z5333 - z5428 * z5616;
    const Scalar z5683 = z5428 * z5617 - z5537;
    const Scalar z5687 = z4497 * z5616 + z5367 - z5258 * z5624;
    const Scalar z5696 = z5301 - z5682;
    const Scalar z5698 = z5592 * z5696 + z5687;
    const Scalar z5690 = z5247 * z5624 - z5347 - z5444 * z5616 + z4568 * z5627;
    const Scalar z5691 = z5563 + z5444 * z5617 + z5247 * z5634 + z4568 * z5637;
    const Scalar z5693 = z5377 - z5468 * z5616 - z5265 * z5624 + z4585 * z5627;
    const Scalar z5694 = z5468 * z5617 + z5580 - z5265 * z5634 + z4585 * z5637;
    const Scalar z5684 = z4490 * z5616 + z5392 + z5276 * z5624;
    const Scalar z5697 = z5591 * z5696 + z5690;
    const Scalar z5708 = z5591 * z5683 - z5691;
    const Scalar z5699 = z5593 * z5696 - z5698 + z5693 - z5596 * z5697;
    const Scalar z5674 = z5594 * z5646 + z5600 * z5673;
    const Scalar z5675 = z5602 * z5674;
    const Scalar z5681 = z5590 * z5646;
    const Scalar z5700 = z5594 * z5696 + z5684 + z5600 * z5699;
    const Scalar z5676 = z5596 * z5675 + z5673;
    const Scalar z5707 = z5590 * z5696;
    const Scalar z5701 = z5602 * z5700;
    const Scalar z5727 = z5428 * z5670;
    const Scalar z5728 = z5428 * z5681;
    const Scalar z5702 = z5596 * z5701 + z5699;
    const Scalar z5677 = z5599 * z5676;
    const Scalar z5733 = z4497 * z5670 + z5258 * z5666;
    const Scalar z5688 = z4497 * z5617 + z5258 * z5634;
    const Scalar z5679 = z5671 - z5675 + z4500 * z5677;
    const Scalar z5678 = z4475 * z5677 + z5672;
    const Scalar z5709 = z5592 * z5683 + z5688;
    const Scalar z5680 = z5595 * z5679;
    const Scalar z5741 = z5344 + z5441 * z5616;
    const Scalar z5742 = z5441 * z5617 - z5560;
    const Scalar z5743 = z5364 + z5465 * z5616;
    const Scalar z5744 = z5465 * z5617 + z5577;
    const Scalar z5710 = z5593 * z5683 - z5709 - z5694 - z5596 * z5708;
    const Scalar z5703 = z5599 * z5702;
    const Scalar z5704 = z4475 * z5703 + z5698;
    const Scalar z5705 = z5697 - z5701 + z4500 * z5703;
    const Scalar z5734 = z4497 * z5681 + z5258 * z5677;
    const Scalar z5689 = z4497 - z5258 * z5641;
    const Scalar z5732 = z5258 * z5655;
    const Scalar z5706 = z5595 * z5705;
    const Scalar z5735 = z5247 * z5655 + z4568 * z5658;
    const Scalar z5736 = z5444 * z5670 + z5247 * z5666 + z4568 * z5669;
    const Scalar z5737 = z5444 * z5681 + z5247 * z5677 + z4568 * z5680;
    const Scalar z5692 = z5247 * z5641 + z4568 * z5644;
    const Scalar z5739 = z5468 * z5670 - z5265 * z5666 + z4585 * z5669;
    const Scalar z5740 = z5468 * z5681 - z5265 * z5677 + z4585 * z5680;
    const Scalar z5738 = z4585 * z5658 - z5265 * z5655;
    const Scalar z5695 = z4585 * z5644 - z5265 * z5641;
    const Scalar z5719 = z5596 * z5692 + z5689 - z5695;
    const Scalar z5730 = z4490 * z5670 - z5276 * z5666;
    const Scalar z5729 = z5276 * z5655;
    const Scalar z5685 = z4490 * z5617 - z5276 * z5634;
    const Scalar z5745 = z5389 + z5480 * z5616;
    const Scalar z5711 = z5594 * z5683 + z5685 + z5600 * z5710;
    const Scalar z5718 = z5590 * z5683;
    const Scalar z5731 = z4490 * z5681 - z5276 * z5677;
    const Scalar z5686 = z4490 + z5276 * z5641;
    const Scalar z5747 = z5727 + z5741;
    const Scalar z5748 = z5728 + z5742;
    const Scalar z5752 = z5374 - z5733;
    const Scalar z5746 = z5480 * z5617 + z5589;
    const Scalar z5751 = z5262 + z5732;
    const Scalar z5753 = z5255 + z5735;
    const Scalar z5754 = z5736 + z5743;
    const Scalar z5755 = z5737 + z5744;
    const Scalar z5757 = z5739 - z5745;
    const Scalar z5758 = z5740 - z5746;
    const Scalar z5756 = z5273 + z5738;
    const Scalar z5750 = z5397 + z5730;
    const Scalar z5749 = z5280 - z5729;
    const Scalar z5767 = z5310 + z5747;
    const Scalar z5769 = z5592 * z5767 - z5752;
    const Scalar z5768 = z5591 * z5767 - z5754;
    const Scalar z5759 = z5596 * z5753 - z5751 - z5756;
    const Scalar z5720 = z5600 * z5719 - z5686;
    const Scalar z5770 = z5593 * z5767 - z5769 - z5757 - z5596 * z5768;
    const Scalar z5760 = z5600 * z5759 + z5749;
    const Scalar z5721 = z5602 * z5720;
    const Scalar z5761 = z5602 * z5760;
    const Scalar z5712 = z5602 * z5711;
    const Scalar z5722 = z5596 * z5721 + z5719;
    const Scalar z5713 = z5596 * z5712 + z5710;
    const Scalar z5762 = z5596 * z5761 + z5759;
    const Scalar z5723 = z5599 * z5722;
    const Scalar z5714 = z5599 * z5713;
    const Scalar z5763 = z5599 * z5762;
    const Scalar z5771 = z5594 * z5767 + z5750 + z5600 * z5770;
    const Scalar z5724 = z4475 * z5723 - z5689;
    const Scalar z5715 = z4475 * z5714 + z5709;
    const Scalar z5764 = z4475 * z5763 + z5751;
    const Scalar z5772 = z5602 * z5771;
    const Scalar z5716 = z5708 - z5712 + z4500 * z5714;
    const Scalar z5725 = z4500 * z5723 - z5692 - z5721;
    const Scalar z5773 = z5596 * z5772 + z5770;
    const Scalar z5765 = z4500 * z5763 - z5753 - z5761;
    const Scalar z5717 = z5595 * z5716;
    const Scalar z5780 = z5592 * z5748 + z5734;
    const Scalar z5779 = z5591 * z5748 - z5755;
    const Scalar z5781 = z5593 * z5748 - z5780 - z5758 - z5596 * z5779;
    const Scalar z5778 = z5590 * z5767;
    const Scalar z5774 = z5599 * z5773;
    const Scalar z5775 = z4475 * z5774 + z5769;
    const Scalar z5776 = z5768 - z5772 + z4500 * z5774;
    const Scalar z5726 = z5595 * z5725;
    const Scalar z5808 = z4224 * z5616 - z4228 - z4231 * z4330 - z4233 * z5622 - z4232 * z5624 + z4234 * z5625;
    const Scalar z5790 = z5239 - z5240;
    const Scalar z5792 = z5242 + z5592 * z5790;
    const Scalar z5791 = z5241 - z5591 * z5790;
    const Scalar z5813 = z4231 - z4274 * z5617;
    const Scalar z5782 = z5594 * z5748 + z5731 + z5600 * z5781;
    const Scalar z5793 = z5593 * z5790 - z5792 + z5243 + z5596 * z5791;
    const Scalar z5783 = z5602 * z5782;
    const Scalar z5789 = z5590 * z5748;
    const Scalar z5784 = z5596 * z5783 + z5781;
    const Scalar z5806 = z4285 + z4288 * z4330 + z4271 * z5616 - z4290 * z5622 - z4289 * z5624 - z4291 * z5625 + z4214
        * z5627;
    const Scalar z5794 = z5244 - z5594 * z5790 - z5600 * z5793;
    const Scalar z5801 = z5590 * z5790;
    const Scalar z5804 = z4288 + n94 * z4330 + z4274 * z5616;
    const Scalar z5807 = z4271 + z4274 * z4330 + z4268 * z5616 + z4276 * z5622 - z4275 * z5624 + z4277 * z5625 + z4212
        * z5627;
    const Scalar z5795 = z5602 * z5794;
    const Scalar z5796 = z5596 * z5795 - z5793;
    const Scalar z5815 = z4276 * z5632 - z4224 - z4268 * z5617 - z4275 * z5634 + z4277 * z5635 + z4212 * z5637;
    const Scalar z5816 = z195 + z4224 * z5617 + z4233 * z5632 + z4232 * z5634 - z4234 * z5635;
    const Scalar z5812 = z4234 + z4277 * z5617 + z4299 * z5634 - n94 * z5635;
    const Scalar z5811 = z4233 - z4276 * z5617 + n94 * z5632 - z4298 * z5634;
    const Scalar z5802 = z4276 * z5616 - z4290 + n94 * z5622 - z4298 * z5624;
    const Scalar z5814 = z4298 * z5632 - z4232 - z4275 * z5617 - z4297 * z5634 + z4299 * z5635 + z4216 * z5637;
    const Scalar z5803 = z4277 * z5616 - z4291 - z4299 * z5624 + n94 * z5625;
    const Scalar z5822 = n0_12 - z4276 * z5639 - z4275 * z5641 + z4277 * z5642 + z4212 * z5644;
    const Scalar z5805 = z4289 + z4275 * z5616 + z4298 * z5622 - z4297 * z5624 + z4299 * z5625 + z4216 * z5627;
    const Scalar z5821 = z4267 - z4298 * z5639 - z4297 * z5641 + z4299 * z5642 + z4216 * z5644;
    const Scalar z5819 = n94 * z5639 + z4298 * z5641;
    const Scalar z5820 = z4299 * z5641 - n94 * z5642;
    const Scalar z5810 = z4212 * z5616 + z4214 - z4216 * z5624 + n0_28 * z5627;
    const Scalar z5818 = z4212 * z5617 + z4216 * z5634 - n0_28 * z5637;
    const Scalar z5824 = z4216 * z5641 - n0_28 * z5644;
    const Scalar z5785 = z5599 * z5784;
    const Scalar z5797 = z5599 * z5796;
    const Scalar z5825 = z4330 * z5804 + z5622 * z5802 + z5625 * z5803 + z5627 * z5810 + z5616 * z5807 - z5624 * z5805
        + z5806;
    const Scalar z5786 = z4475 * z5785 + z5780;
    const Scalar z5787 = z5779 - z5783 + z4500 * z5785;
    const Scalar z5766 = z5595 * z5765;
    const Scalar z5828 = z5635 * z5812 - z5816 - z5632 * z5811 + z5637 * z5818 + z5617 * z5815 + z5634 * z5814;
    const Scalar z5826 = z5808 - z5632 * z5802 - z5635 * z5803 - z5637 * z5810 + z5617 * z5807 + z5634 * z5805;
    const Scalar z5777 = z5595 * z5776;
    const Scalar z5846 = z4884 + z4921 * z5616;
    const Scalar z5847 = z4921 * z5617 + z4994;
    const Scalar z5840 = z4923 * z5616 - z4886 + z4854 * z5624;
    const Scalar z5844 = z4924 * z5617 - z4997 + z4853 * z5634;
    const Scalar z5841 = z4854 * z5634 - z4996 - z4923 * z5617;
    const Scalar z5843 = z4887 - z4924 * z5616 + z4853 * z5624;
    const Scalar z5788 = z5595 * z5787;
    const Scalar z5853 = z4849 * z5641 - z4925 + z5006 * z5644;
    const Scalar z5857 = z4943 * z5616 - z4947 - z4948 * z5624 + z5011 * z5627;
    const Scalar z5854 = z4892 * z5616 - z4894 - z4895 * z5624 - z5002 * z5627;
    const Scalar z5855 = z4892 * z5617 - z4987 + z4895 * z5634 + z5002 * z5637;
    const Scalar z5848 = z4885 - z4922 * z5616 + z4855 * z5624 + z5010 * z5627;
    const Scalar z5849 = z4922 * z5617 - z4995 + z4855 * z5634 + z5010 * z5637;
    const Scalar z5851 = z4918 * z5616 - z4865 + z4849 * z5624 + z5006 * z5627;
    const Scalar z5852 = z4991 - z4918 * z5617 + z4849 * z5634 + z5006 * z5637;
    const Scalar z5798 = z4475 * z5797 - z5792;
    const Scalar z5799 = z5791 - z5795 + z4500 * z5797;
    const Scalar z5800 = z5595 * z5799;
    const Scalar z5864 = z5000 - z5005 * z5617 - z5010 * z5634;
    const Scalar z5867 = z4330 * z5847 - z5625 * z5844 - z5627 * z5864 + z5622 * z5841 - z5616 * z5855 + z5624 * z5849
        + z5852;
    const Scalar z5860 = z4928 - z4929 * z5624;
    const Scalar z5863 = z5005 * z5616 + z5009 - z5010 * z5624;
    const Scalar z5866 = z4330 * z5846 - z5622 * z5840 + z5625 * z5843 + z5627 * z5863 - z5616 * z5854 - z5624 * z5848
        - z5851;
    const Scalar z5823 = n0_12 - z4267 * z5641;
    const Scalar z5830 = z5639 * z5819 + z5823 - z5642 * z5820 - z5644 * z5824 - z5641 * z5821;
    const Scalar z5817 = n0_12 * z5617 + z4267 * z5634;
    const Scalar z5809 = z4267 * z5624 - n0_12 * z5616;
    const Scalar z5869 = z5857 + z5635 * z5843 - z5632 * z5840 + z5637 * z5863 + z5617 * z5854 - z5634 * z5848;
    const Scalar z5872 = z5860 + z5639 * z5840 + z5642 * z5843 + z5644 * z5863 - z5641 * z5848;
    const Scalar z5829 = z5639 * z5811 + z5817 + z5642 * z5812 + z5644 * z5818 + z5641 * z5814;
    const Scalar z5827 = z5639 * z5802 + z5809 - z5642 * z5803 - z5644 * z5810 + z5641 * z5805;
    const Scalar z5842 = z4854 * z5641;
    const Scalar z5845 = z4853 * z5641;
    const Scalar z5858 = z4943 * z5617 + z4948 * z5634 - z5011 * z5637;
    const Scalar z5870 = z5858 + z5632 * z5841 - z5635 * z5844 - z5637 * z5864 + z5617 * z5855 + z5634 * z5849;
    const Scalar z5859 = z4948 * z5641 - z5011 * z5644;
    const Scalar z5861 = z4929 * z5634;
    const Scalar z5873 = z5642 * z5844 - z5861 + z5644 * z5864 + z5639 * z5841 - z5641 * z5849;
    const Scalar z5862 = z4929 * z5641;
    const Scalar z5865 = z5010 * z5641;
    const Scalar z5856 = z4895 * z5641 + z5002 * z5644;
    const Scalar z5850 = z4855 * z5641 + z4929 + z5010 * z5644;
    const Scalar z5868 = z5625 * z5845 - z5853 - z5622 * z5842 - z5627 * z5865 + z5616 * z5856 - z5624 * z5850;
    const Scalar z5871 = z5859 + z5632 * z5842 - z5635 * z5845 + z5637 * z5865 + z5617 * z5856 + z5634 * z5850;
    const Scalar z5874 = z5639 * z5842 - z5862 + z5642 * z5845 - z5644 * z5865 - z5641 * z5850;
    const Scalar z5831 = z5301 * z5804 + z5707 * z5807 - z5701 * z5802 + z5703 * z5805 - z5704 * z5803 - z5706 * z5810;
    const Scalar z5875 = z5831 + z5866;
    const Scalar z5834 = z5301 * z5813 + z5707 * z5815 - z5701 * z5811 + z5703 * z5814 + z5704 * z5812 + z5706 * z5818;
    const Scalar z5837 = z5707 * z5822 + z5701 * z5819 + z5703 * z5821 + z5704 * z5820 + z5706 * z5824;
    const Scalar z5878 = z5834 + z5869;
    const Scalar z5881 = z5837 + z5872;
    const Scalar z5832 = z5712 * z5802 - z5718 * z5807 - z5714 * z5805 + z5715 * z5803 + z5717 * z5810;
    const Scalar z5876 = z5832 - z5867;
    const Scalar z5833 = z5721 * z5802 - z5723 * z5805 + z5724 * z5803 + z5726 * z5810;
    const Scalar z5877 = z5833 + z5868;
    const Scalar z5893 = z4854 * z5655;
    const Scalar z5894 = z4854 * z5666 - z4923 * z5670;
    const Scalar z5835 = z5712 * z5811 - z5718 * z5815 - z5714 * z5814 - z5715 * z5812 - z5717 * z5818;
    const Scalar z5838 = z5718 * z5822 + z5712 * z5819 + z5714 * z5821 + z5715 * z5820 + z5717 * z5824;
    const Scalar z5895 = z4854 * z5677 - z4923 * z5681;
    const Scalar z5879 = z5835 - z5870;
    const Scalar z5882 = z5838 - z5873;
    const Scalar z5836 = z5721 * z5811 - z5723 * z5814 - z5724 * z5812 - z5726 * z5818;
    const Scalar z5839 = z5721 * z5819 + z5723 * z5821 + z5724 * z5820 + z5726 * z5824;
    const Scalar z5935 = z4859 - z5893;
    const Scalar z5880 = z5836 - z5871;
    const Scalar z5883 = z5839 - z5874;
    const Scalar z5923 = z4874 - z4907 * z5616;
    const Scalar z5924 = z4907 * z5617 + z4970;
    const Scalar z5921 = z4877 - z4910 * z5616;
    const Scalar z5922 = z4910 * z5617 - z4973;
    const Scalar z5931 = z5107 + z5172 * z5616;
    const Scalar z5932 = z5172 * z5617 - z5216;
    const Scalar z5933 = z5116 - z5179 * z5616;
    const Scalar z5934 = z5179 * z5617 + z5223;
    const Scalar z5919 = z4876 - z4909 * z5616;
    const Scalar z5920 = z4909 * z5617 - z4972;
    const Scalar z5936 = z5894 + z5919;
    const Scalar z5937 = z5895 - z5920;
    const Scalar z5929 = z5087 + z5145 * z5616;
    const Scalar z5930 = z5145 * z5617 - z5199;
    const Scalar z5925 = z5048 - z5123 * z5616;
    const Scalar z5926 = z5123 * z5617 - z5186;
    const Scalar z5927 = z5071 + z5130 * z5616;
    const Scalar z5928 = z5130 * z5617 - z5193;
    const Scalar z5899 = z4921 * z5670;
    const Scalar z5941 = z5899 - z5923;
    const Scalar z5900 = z4921 * z5681;
    const Scalar z5942 = z5900 + z5924;
    const Scalar z5897 = z4924 * z5670 + z4853 * z5666;
    const Scalar z5939 = z5897 + z5921;
    const Scalar z5898 = z4924 * z5681 + z4853 * z5677;
    const Scalar z5940 = z5898 - z5922;
    const Scalar z5896 = z4853 * z5655;
    const Scalar z5938 = z4860 + z5896;
    const Scalar z5904 = z4849 * z5655 + z5006 * z5658;
    const Scalar z5907 = z4895 * z5655 + z5002 * z5658;
    const Scalar z5910 = z4948 * z5655 - z5011 * z5658;
    const Scalar z5901 = z4855 * z5655 + z5010 * z5658;
    const Scalar z5943 = z5017 + z5901;
    const Scalar z5911 = z4943 * z5670 + z4948 * z5666 - z5011 * z5669;
    const Scalar z5912 = z4943 * z5681 + z4948 * z5677 - z5011 * z5680;
    const Scalar z5917 = z5005 * z5670 + z5010 * z5666;
    const Scalar z5918 = z5005 * z5681 + z5010 * z5677;
    const Scalar z5913 = z4929 * z5655;
    const Scalar z5916 = z5010 * z5655;
    const Scalar z5914 = z4929 * z5666;
    const Scalar z5915 = z4929 * z5677;
    const Scalar z5908 = z4892 * z5670 + z4895 * z5666 + z5002 * z5669;
    const Scalar z5909 = z4892 * z5681 + z4895 * z5677 + z5002 * z5680;
    const Scalar z5902 = z4855 * z5666 + z4922 * z5670 + z5010 * z5669;
    const Scalar z5903 = z4855 * z5677 + z4922 * z5681 + z5010 * z5680;
    const Scalar z5905 = z4849 * z5666 - z4918 * z5670 + z5006 * z5669;
    const Scalar z5906 = z4849 * z5677 - z4918 * z5681 + z5006 * z5680;
    const Scalar z5884 = z5761 * z5802 - z5763 * z5805 + z5764 * z5803 + z5766 * z5810;
    const Scalar z5944 = z5902 + z5925;
    const Scalar z5885 = z5310 * z5804 + z5778 * z5807 - z5772 * z5802 + z5774 * z5805 - z5775 * z5803 - z5777 * z5810;
    const Scalar z5945 = z5903 - z5926;
    const Scalar z5888 = z5310 * z5813 + z5778 * z5815 - z5772 * z5811 + z5774 * z5814 + z5775 * z5812 + z5777 * z5818;
    const Scalar z5891 = z5778 * z5822 + z5772 * z5819 + z5774 * z5821 + z5775 * z5820 + z5777 * z5824;
    const Scalar z5886 = z5783 * z5802 - z5789 * z5807 - z5785 * z5805 + z5786 * z5803 + z5788 * z5810;
    const Scalar z5946 = z5019 + z5904;
    const Scalar z5887 = z5761 * z5811 - z5763 * z5814 - z5764 * z5812 - z5766 * z5818;
    const Scalar z5890 = z5761 * z5819 + z5763 * z5821 + z5764 * z5820 + z5766 * z5824;
    const Scalar z5947 = z5905 - z5927;
    const Scalar z5948 = z5906 - z5928;
    const Scalar z5889 = z5783 * z5811 - z5789 * z5815 - z5785 * z5814 - z5786 * z5812 - z5788 * z5818;
    const Scalar z5892 = z5789 * z5822 + z5783 * z5819 + z5785 * z5821 + z5786 * z5820 + z5788 * z5824;
    const Scalar z5987 = z5239 * z5804 + z5795 * z5802 + z5798 * z5803 + z5800 * z5810 - z5797 * z5805 + z5801 * z5807;
    const Scalar z5988 = z5239 * z5813 + z5795 * z5811 - z5798 * z5812 - z5800 * z5818 - z5797 * z5814 + z5801 * z5815;
    const Scalar z5989 = z5795 * z5819 + z5798 * z5820 + z5800 * z5824 + z5797 * z5821 - z5801 * z5822;
    const Scalar z5981 = l_lambda_rear_rolls_x * z4476 + l_lambda_rear_rolls_y * z4475 + l_lambda_front_rolls_x * z4500
        + l_lambda_front_rolls_y * z4499 - z5237;
    const Scalar z5982 = l_lambda_rear_rolls_x * z4480 - z5230 + l_lambda_rear_rolls_y * z4481 + l_lambda_front_touches
        * z4424 + l_lambda_front_rolls_x * z4504 + l_lambda_front_rolls_y * z4505;
    const Scalar z5983 = l_lambda_front_rolls_x * z4532 - z4676 + l_lambda_front_rolls_y * z4534;
    const Scalar z5949 = z5026 + z5907;
    const Scalar z5952 = z5032 + z5910;
    const Scalar z5953 = z5911 + z5931;
    const Scalar z5954 = z5912 + z5932;
    const Scalar z5958 = z5917 + z5933;
    const Scalar z5959 = z5918 - z5934;
    const Scalar z5955 = z5033 - z5913;
    const Scalar z5956 = z5109 - z5914;
    const Scalar z5957 = z5038 - z5916;
    const Scalar z5950 = z5908 - z5929;
    const Scalar z5951 = z5909 - z5930;
    const Scalar z5961 = z4330 * z5941 - z5625 * z5939 + z5627 * z5958 + z5622 * z5936 - z5616 * z5950 + z5624 * z5944
        + z5947;
    const Scalar z5962 = z4330 * z5942 - z5625 * z5940 + z5627 * z5959 + z5622 * z5937 - z5616 * z5951 + z5624 * z5945
        + z5948;
    const Scalar z5964 = z5953 + z5637 * z5958 - z5635 * z5939 + z5632 * z5936 + z5617 * z5950 + z5634 * z5944;
    const Scalar z5967 = z5956 + z5642 * z5939 - z5644 * z5958 + z5639 * z5936 - z5641 * z5944;
    const Scalar z5965 = z5954 + z5637 * z5959 - z5635 * z5940 + z5632 * z5937 + z5617 * z5951 + z5634 * z5945;
    const Scalar z5968 = z5642 * z5940 - z5915 - z5644 * z5959 + z5639 * z5937 - z5641 * z5945;
    const Scalar z5970 = z5885 + z5961;
    const Scalar z5971 = z5886 - z5962;
    const Scalar z5973 = z5888 + z5964;
    const Scalar z5974 = z5889 - z5965;
    const Scalar z5976 = z5891 - z5967;
    const Scalar z5977 = z5892 - z5968;
    const Scalar z5993 = n1 / z5830;
    const Scalar z5980 = l_lambda_rear_touches + l_lambda_front_touches - z4717;
    const Scalar z5960 = z5622 * z5935 - z5946 + z5625 * z5938 + z5627 * z5957 + z5616 * z5949 - z5624 * z5943;
    const Scalar z5963 = z5952 + z5617 * z5949 - z5632 * z5935 - z5635 * z5938 - z5637 * z5957 + z5634 * z5943;
    const Scalar z5966 = z5639 * z5935 - z5955 - z5642 * z5938 - z5644 * z5957 + z5641 * z5943;
    const Scalar z5969 = z5884 + z5960;
    const Scalar z5972 = z5887 - z5963;
    const Scalar z5975 = z5890 + z5966;
    const Scalar z5978 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z4715;
    const Scalar z5979 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z4716;
    const Scalar z5984 = z5235 + l_lambda_rear_rolls_x * z4478 + l_lambda_rear_rolls_y * z4479 + l_lambda_front_touches
        * z4413 + l_lambda_front_rolls_x * z4502 + l_lambda_front_rolls_y * z4503 - z4330 * (l_lambda_rear_touches
        - z5980) - z5616 * z5982 - z5622 * z5978 + z5624 * z5981 - z5625 * z5979 - z5627 * z5983;
    const Scalar z5985 = l_lambda_front_touches * z4446 - z5238 + l_lambda_front_rolls_x * z4525
        + l_lambda_front_rolls_y * z4527 - z5617 * z5982 + z5632 * z5978 - z5634 * z5981 + z5635 * z5979 + z5637
        * z5983;
    const Scalar z5986 = l_lambda_rear_rolls_x * z4480 - z4696 + l_lambda_rear_rolls_y * z4481 - z5639 * z5978 - z5641
        * z5981 + z5642 * z5979 + z5644 * z5983;
    const Scalar z5990 = z5984 - z5987;
    const Scalar z5991 = z5985 + z5988;
    const Scalar z5992 = z5986 - z5989;
    const Scalar z5995 = z5829 * z5993;
    const Scalar z5998 = z5828 + z5829 * z5995;
    const Scalar z5997 = z5826 + z5827 * z5995;
    const Scalar z6003 = z5878 + z5881 * z5995;
    const Scalar z6008 = z5879 - z5882 * z5995;
    const Scalar z5999 = n1 / z5998;
    const Scalar z6013 = z5972 - z5975 * z5995;
    const Scalar z6018 = z5880 - z5883 * z5995;
    const Scalar z6023 = z5973 + z5976 * z5995;
    const Scalar z6028 = z5974 - z5977 * z5995;
    const Scalar z5994 = z5827 * z5993;
    const Scalar z5996 = z5825 - z5827 * z5994;
    const Scalar z6000 = z5997 * z5999;
    const Scalar z6001 = z5996 + z5997 * z6000;
    const Scalar z6004 = z5875 + z5881 * z5994 - z6000 * z6003;
    const Scalar z6009 = z5876 - z5882 * z5994 - z6000 * z6008;
    const Scalar z6014 = z5969 - z5975 * z5994 - z6000 * z6013;
    const Scalar z6019 = z5877 - z5883 * z5994 - z6000 * z6018;
    const Scalar z6024 = z5970 + z5976 * z5994 - z6000 * z6023;
    const Scalar z6029 = z5971 - z5977 * z5994 - z6000 * z6028;
    const Scalar z6002 = n1 / z6001;
    const Scalar z6005 = z6002 * z6004;
    const Scalar z6010 = z6002 * z6009;
    const Scalar z6015 = z6002 * z6014;
    const Scalar z6020 = z6002 * z6019;
    const Scalar z6025 = z6002 * z6024;
    const Scalar z6030 = z6002 * z6029;
    const Scalar z6006 = z5999 * z6003 + z6000 * z6005;
    const Scalar z6011 = z5999 * z6008 + z6000 * z6010;
    const Scalar z6016 = z5999 * z6013 + z6000 * z6015;
    const Scalar z6021 = z5999 * z6018 + z6000 * z6020;
    const Scalar z6026 = z5999 * z6023 + z6000 * z6025;
    const Scalar z6031 = z5999 * z6028 + z6000 * z6030;
    const Scalar z6007 = z5881 * z5993 + z5994 * z6005 - z5995 * z6006;
    const Scalar z6012 = z5882 * z5993 - z5994 * z6010 + z5995 * z6011;
    const Scalar z6017 = z5975 * z5993 - z5994 * z6015 + z5995 * z6016;
    const Scalar z6022 = z5883 * z5993 - z5994 * z6020 + z5995 * z6021;
    const Scalar z6027 = z5976 * z5993 + z5994 * z6025 - z5995 * z6026;
    const Scalar z6032 = z5977 * z5993 - z5994 * z6030 + z5995 * z6031;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z4298;
    result.M[4] = -z4290;
    result.M[5] = z4276;
    result.M[6] = z4233;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z4299;
    result.M[13] = z4291;
    result.M[14] = -z4277;
    result.M[15] = z4234;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z4288;
    result.M[23] = z4274;
    result.M[24] = z4231;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z4298;
    result.M[28] = -z4299;
    result.M[29] = n0;
    result.M[30] = z4297;
    result.M[31] = z4289;
    result.M[32] = z4275;
    result.M[33] = -z4232;
    result.M[34] = z4267;
    result.M[35] = z4216;
    result.M[36] = -z4290;
    result.M[37] = z4291;
    result.M[38] = z4288;
    result.M[39] = z4289;
    result.M[40] = z4285;
    result.M[41] = z4271;
    result.M[42] = z4228;
    result.M[43] = n0;
    result.M[44] = z4214;
    result.M[45] = z4276;
    result.M[46] = -z4277;
    result.M[47] = z4274;
    result.M[48] = z4275;
    result.M[49] = z4271;
    result.M[50] = z4268;
    result.M[51] = -z4224;
    result.M[52] = n0_12;
    result.M[53] = z4212;
    result.M[54] = z4233;
    result.M[55] = z4234;
    result.M[56] = z4231;
    result.M[57] = -z4232;
    result.M[58] = z4228;
    result.M[59] = -z4224;
    result.M[60] = z195;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z4267;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z4216;
    result.M[76] = z4214;
    result.M[77] = z4212;
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
    result.C[27] = z4854;
    result.C[28] = z4853;
    result.C[29] = n0;
    result.C[30] = -z4855;
    result.C[31] = z4849;
    result.C[32] = -z4895;
    result.C[33] = z4948;
    result.C[34] = z4929;
    result.C[35] = z5010;
    result.C[36] = z4886;
    result.C[37] = -z4887;
    result.C[38] = z4884;
    result.C[39] = z4885;
    result.C[40] = z4865;
    result.C[41] = z4894;
    result.C[42] = -z4947;
    result.C[43] = z4928;
    result.C[44] = z5009;
    result.C[45] = -z4923;
    result.C[46] = z4924;
    result.C[47] = z4921;
    result.C[48] = -z4922;
    result.C[49] = -z4918;
    result.C[50] = -z4892;
    result.C[51] = z4943;
    result.C[52] = n0;
    result.C[53] = z5005;
    result.C[54] = z4996;
    result.C[55] = z4997;
    result.C[56] = -z4994;
    result.C[57] = -z4995;
    result.C[58] = -z4991;
    result.C[59] = -z4987;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z5000;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z4929;
    result.C[67] = z4925;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = z5010;
    result.C[76] = -z5006;
    result.C[77] = z5002;
    result.C[78] = z5011;
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
    result.K[27] = z4859;
    result.K[28] = -z4860;
    result.K[29] = n0;
    result.K[30] = z5017;
    result.K[31] = -z5019;
    result.K[32] = z5026;
    result.K[33] = -z5032;
    result.K[34] = z5033;
    result.K[35] = z5038;
    result.K[36] = z4876;
    result.K[37] = z4877;
    result.K[38] = -z4874;
    result.K[39] = -z5048;
    result.K[40] = -z5071;
    result.K[41] = z5087;
    result.K[42] = z5107;
    result.K[43] = -z5109;
    result.K[44] = z5116;
    result.K[45] = -z4909;
    result.K[46] = -z4910;
    result.K[47] = z4907;
    result.K[48] = z5123;
    result.K[49] = -z5130;
    result.K[50] = z5145;
    result.K[51] = z5172;
    result.K[52] = n0;
    result.K[53] = -z5179;
    result.K[54] = -z4972;
    result.K[55] = -z4973;
    result.K[56] = -z4970;
    result.K[57] = z5186;
    result.K[58] = -z5193;
    result.K[59] = z5199;
    result.K[60] = z5216;
    result.K[61] = n0;
    result.K[62] = z5223;
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
    result.F[0] = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z4715;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z4716;
    result.F[2] = -l_lambda_rear_touches - l_lambda_front_touches + z4717;
    result.F[3] = l_lambda_rear_rolls_x * z4476 + l_lambda_rear_rolls_y * z4475 + l_lambda_front_rolls_x * z4500
        + l_lambda_front_rolls_y * z4499 - z5237;
    result.F[4] = -l_lambda_rear_rolls_x * z4478 + l_lambda_rear_touches * z4330 - l_lambda_rear_rolls_y * z4479
        - l_lambda_front_touches * z4413 - l_lambda_front_rolls_x * z4502 - l_lambda_front_rolls_y * z4503 - z5235;
    result.F[5] = l_lambda_rear_rolls_x * z4480 - z5230 + l_lambda_rear_rolls_y * z4481 + l_lambda_front_touches * z4424
        + l_lambda_front_rolls_x * z4504 + l_lambda_front_rolls_y * z4505;
    result.F[6] = l_lambda_front_touches * z4446 - z5238 + l_lambda_front_rolls_x * z4525 + l_lambda_front_rolls_y
        * z4527;
    result.F[7] = l_lambda_rear_rolls_x * z4480 - z4696 + l_lambda_rear_rolls_y * z4481;
    result.F[8] = l_lambda_front_rolls_x * z4532 - z4676 + l_lambda_front_rolls_y * z4534;
    result.M_r[0] = z5825;
    result.M_r[1] = -z5826;
    result.M_r[2] = -z5827;
    result.M_r[3] = -z5826;
    result.M_r[4] = -z5828;
    result.M_r[5] = -z5829;
    result.M_r[6] = -z5827;
    result.M_r[7] = -z5829;
    result.M_r[8] = z5830;
    result.C_r[0] = z5875;
    result.C_r[1] = z5878;
    result.C_r[2] = z5881;
    result.C_r[3] = z5876;
    result.C_r[4] = z5879;
    result.C_r[5] = -z5882;
    result.C_r[6] = z5877;
    result.C_r[7] = z5880;
    result.C_r[8] = -z5883;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z5969;
    result.K_r[7] = z5972;
    result.K_r[8] = -z5975;
    result.K_r[9] = z5970;
    result.K_r[10] = z5973;
    result.K_r[11] = z5976;
    result.K_r[12] = z5971;
    result.K_r[13] = z5974;
    result.K_r[14] = -z5977;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = -z5990;
    result.F_r[1] = z5991;
    result.F_r[2] = z5992;
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
    result.A[20] = z5653;
    result.A[21] = -z5656;
    result.A[22] = -z5655;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z5658;
    result.A[27] = -z6015;
    result.A[28] = z6016;
    result.A[29] = z6017;
    result.A[30] = -z5664;
    result.A[31] = z5667;
    result.A[32] = z5666;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z5669;
    result.A[37] = -z6025;
    result.A[38] = z6026;
    result.A[39] = -z6027;
    result.A[40] = z5675;
    result.A[41] = -z5678;
    result.A[42] = -z5677;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z5680;
    result.A[47] = -z6030;
    result.A[48] = z6031;
    result.A[49] = z6032;
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
    result.A[70] = z5622;
    result.A[71] = -z5625;
    result.A[72] = -z5624;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z6005;
    result.A[78] = z6006;
    result.A[79] = -z6007;
    result.A[80] = z5632;
    result.A[81] = -z5635;
    result.A[82] = -z5634;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z5637;
    result.A[87] = -z6010;
    result.A[88] = z6011;
    result.A[89] = z6012;
    result.A[90] = -z5639;
    result.A[91] = -z5642;
    result.A[92] = -z5641;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z5644;
    result.A[97] = -z6020;
    result.A[98] = z6021;
    result.A[99] = z6022;
    if (!(traits::regular(z5603, z5605) && traits::regular(z5606, z5608) && traits::regular(z5609, z5611)
        && traits::regular(z5612, z5614) && traits::regular(z6001, z5825) && traits::regular(-z5998, -z5828)
        && traits::regular(z5830, z5830))) return torsor::Status::singular;
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
