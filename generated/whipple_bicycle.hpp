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
  static constexpr unsigned long long fingerprint = 0x1d571fa26dff5d13ULL;
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
    const Scalar z10 = traits::formula(6.497839117007668, 6.497839f, [&]() -> Scalar {
      return n1 / z6;
    });
    const Scalar z11 = -z8 * (n1 - c_steer);
    const Scalar z12 = z1 * s_steer;
    const Scalar z13 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z14 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z15 = z2 * s_steer;
    const Scalar z16 = n2_8467 * c_steer;
    const Scalar z17 = n0_28 * c_steer;
    const Scalar z18 = c_steer * z3;
    const Scalar z19 = n0_12 * s_roll;
    const Scalar z20 = n0_28 * z15;
    const Scalar z21 = n0_28 * z12;
    const Scalar z22 = z3 * z15;
    const Scalar z23 = z3 * z12;
    const Scalar z24 = z4 * z15 + z5 * z12;
    const Scalar z25 = n1_04 * z15 - n3_85 * z12;
    const Scalar z26 = n2_8467 * z15;
    const Scalar z27 = k3 * z15 + k4 * z12;
    const Scalar z28 = k4 * z15 + k5 * z12;
    const Scalar z29 = n2_8467 * z12;
    const Scalar z30 = s_pitch * z21 - c_pitch * z20;
    const Scalar z31 = s_pitch * z20 + c_pitch * z21;
    const Scalar z32 = s_pitch * z23 - c_pitch * z22;
    const Scalar z33 = s_pitch * z22 + c_pitch * z23;
    const Scalar z34 = k4 * z11;
    const Scalar z35 = z5 * z11 + z4 * z14;
    const Scalar z36 = z4 * z11 + z5 * z13;
    const Scalar z37 = n1_04 * z14 - n3_85 * z11;
    const Scalar z38 = n1_04 * z11 - n3_85 * z13;
    const Scalar z39 = k5 * z11 + k4 * z14;
    const Scalar z40 = k3 * z11 + k4 * z13;
    const Scalar z41 = k3 * z14 + z34;
    const Scalar z42 = k5 * z13 + z34;
    const Scalar z43 = n0_3 * z22 - z24 + n1_1 * z23;
    const Scalar z44 = z14 * z27 - z15 * z16 + z11 * z28;
    const Scalar z45 = c_steer * z16 + z15 * z27 + z12 * z28;
    const Scalar z46 = s_roll * z17 + c_roll * z31;
    const Scalar z47 = n0_3 * z18 - z35;
    const Scalar z48 = n1_1 * z18 - z36;
    const Scalar z49 = s_roll * z33 - c_roll * z18;
    const Scalar z50 = s_roll * z18 + c_roll * z33;
    const Scalar z51 = z15 * z26 + z14 * z41 + z11 * z39;
    const Scalar z52 = z12 * z29 + z11 * z40 + z13 * z42;
    const Scalar z53 = n9_1 + n0_6 * z38 - n2_2 * z37 + z45;
    const Scalar z54 = z15 * z29 + z14 * z40 + z11 * z42;
    const Scalar z55 = c_steer * z29 - z15 * z40 - z12 * z42;
    const Scalar z56 = n8_47 - n2_2 * z37 + z52;
    const Scalar z57 = n0_63 + n0_6 * z38 + z51;
    const Scalar z58 = n2_31 + n1_1 * z38 - n0_3 * z37 + z54;
    const Scalar z59 = n29_35 - z56;
    const Scalar z60 = n17_7 - z58;
    const Scalar z61 = n49_25 + z53;
    const Scalar z62 = n1_1 * z25 + z44;
    const Scalar z63 = n0_3 * z25 + z55;
    const Scalar z64 = n2_1 + z38;
    const Scalar z65 = n7_7 - z37;
    const Scalar z66 = n51 - z64;
    const Scalar z67 = n25_5 + z65;
    const Scalar z68 = z57 + z59;
    const Scalar z69 = n2 * z60;
    const Scalar z70 = s_pitch * z68 - c_pitch * z69;
    const Scalar z71 = n0_12 + z61;
    const Scalar z72 = n39_8603 - z71;
    const Scalar z73 = s_pitch * z62 - c_pitch * z63;
    const Scalar z74 = s_pitch * z63 + c_pitch * z62;
    const Scalar z75 = s_roll * z71 - c_roll * z73;
    const Scalar z76 = c_pitch * z70 + z60;
    const Scalar z77 = s_pitch * z70;
    const Scalar z78 = s_pitch * z48 - c_pitch * z47;
    const Scalar z79 = s_pitch * z47 + c_pitch * z48;
    const Scalar z80 = z59 - z77;
    const Scalar z81 = z57 - z77;
    const Scalar z82 = n39_8603 + z81;
    const Scalar z83 = s_roll * z74 - c_roll * z76;
    const Scalar z84 = s_roll * z43 - c_roll * z79;
    const Scalar z85 = z80 - z72;
    const Scalar z86 = c_pitch * z66 + s_pitch * z67;
    const Scalar z87 = s_pitch * z66 - c_pitch * z67;
    const Scalar z88 = c_roll * z87;
    const Scalar z89 = s_roll * z86 - c_roll * z25;
    const Scalar z90 = s_roll * z25 + c_roll * z86;
    const Scalar z91 = s_roll * z87;
    const Scalar z92 = s_yaw * z32 - c_yaw * z49;
    const Scalar z93 = c_yaw * z32 + s_yaw * z49;
    const Scalar z94 = n2 * z73;
    const Scalar z95 = s_roll * z85 - c_roll * z94;
    const Scalar z96 = s_yaw * z86 + c_yaw * z91;
    const Scalar z97 = s_yaw * z91 - c_yaw * z86;
    const Scalar z98 = s_roll * z95;
    const Scalar z99 = n0_08 * z14 - n0_35 * z11;
    const Scalar z100 = n1_1 - z99;
    const Scalar z101 = z80 - z98;
    const Scalar z102 = n0_08 * z11 - n0_35 * z13;
    const Scalar z103 = n0_3 + z102;
    const Scalar z104 = c_yaw * z90;
    const Scalar z105 = n39_8603 - z101;
    const Scalar z106 = s_yaw * z90;
    const Scalar z107 = c_yaw * z87 + s_yaw * z89;
    const Scalar z108 = s_yaw * z87 - c_yaw * z89;
    const Scalar z109 = s_pitch * z12 - c_pitch * z15;
    const Scalar z110 = s_pitch * z100 - c_pitch * z103;
    const Scalar z111 = n0_08 * z15 - n0_35 * z12;
    const Scalar z112 = s_roll * z110 - c_roll * z111;
    const Scalar z113 = s_pitch * z103 + c_pitch * z100;
    const Scalar z114 = s_roll * z111 + c_roll * z110;
    const Scalar z115 = s_yaw * c_roll;
    const Scalar z116 = s_pitch * z15 + c_pitch * z12;
    const Scalar z117 = s_yaw * z112 - c_yaw * z113;
    const Scalar z118 = q_z - z114;
    const Scalar z119 = n1 - s_roll * s_roll;
    const Scalar z120 = s_roll * z115;
    const Scalar z121 = c_yaw * c_roll;
    const Scalar z122 = s_roll * z116 - c_roll * c_steer;
    const Scalar z123 = s_roll * c_steer + c_roll * z116;
    const Scalar z124 = q_x - z117;
    const Scalar z125 = s_roll * z121;
    const Scalar z126 = c_yaw * z109 + s_yaw * z122;
    const Scalar z127 = s_yaw * z109 - c_yaw * z122;
    const Scalar z128 = s_yaw * z113 + c_yaw * z112;
    const Scalar z129 = q_y + z128;
    const Scalar z130 = z119 * z119 + z120 * z120 + z125 * z125;
    const Scalar z131 = traits::sqrt(z130);
    const Scalar z132 = z123 * z126;
    const Scalar z133 = z123 * z127;
    const Scalar z134 = v_roll * s_roll;
    const Scalar z135 = v_yaw * c_yaw;
    const Scalar z136 = v_roll * c_roll;
    const Scalar z137 = v_yaw * s_yaw;
    const Scalar z138 = s_yaw * s_roll;
    const Scalar z139 = s_roll * z138 - c_roll * z115;
    const Scalar z140 = n2 * s_roll;
    const Scalar z141 = c_yaw * s_roll;
    const Scalar z142 = s_roll * z141 - c_roll * z121;
    const Scalar z143 = c_roll * z140;
    const Scalar z144 = z136 * z140;
    const Scalar z145 = v_roll * z134;
    const Scalar z146 = s_yaw * z134 - c_roll * z135;
    const Scalar z147 = v_yaw * z137;
    const Scalar z148 = v_roll * z136;
    const Scalar z149 = v_yaw * z135;
    const Scalar z150 = c_yaw * z134 + c_roll * z137;
    const Scalar z151 = n2 * (z119 * z143 + z120 * z139 + z125 * z142);
    const Scalar z152 = s_roll * z146 - z115 * z136;
    const Scalar z153 = n0_3 / z131;
    const Scalar z154 = n1 - z123 * z123;
    const Scalar z155 = s_roll * z150 - z121 * z136;
    const Scalar z156 = n2 * (z119 * z144 + z120 * z152 + z125 * z155);
    const Scalar z157 = n0_5 * z151 / z131;
    const Scalar z158 = n2 * z134;
    const Scalar z159 = n2 * z136;
    const Scalar z160 = s_yaw * z148 + c_roll * z147 + z135 * z158;
    const Scalar z161 = c_yaw * z148 + c_roll * z149 - z137 * z158;
    const Scalar z162 = z115 * z145 + z146 * z159 + s_roll * z160;
    const Scalar z163 = z121 * z145 + z150 * z159 + s_roll * z161;
    const Scalar z164 = q_z + z119 * z153;
    const Scalar z165 = q_x + z120 * z153;
    const Scalar z166 = z154 * z154 + z132 * z132 + z133 * z133;
    const Scalar z167 = n0_3 * z157;
    const Scalar z168 = q_y - z125 * z153;
    const Scalar z169 = traits::sqrt(z166);
    const Scalar z170 = v_pitch * c_pitch;
    const Scalar z171 = v_steer * c_steer;
    const Scalar z172 = v_steer * s_steer;
    const Scalar z173 = z2 * z171;
    const Scalar z174 = z1 * z171;
    const Scalar z175 = z8 * z172;
    const Scalar z176 = -z172 * (n1 - z7);
    const Scalar z177 = n0_08 * z173 - n0_35 * z174;
    const Scalar z178 = n0_5 * z156 / z131;
    const Scalar z179 = n0_35 * z175 + n0_08 * z176;
    const Scalar z180 = n2 * z123;
    const Scalar z181 = v_pitch * s_pitch;
    const Scalar z182 = z15 * z170 - z12 * z181 + s_pitch * z173 + c_pitch * z174;
    const Scalar z183 = z15 * z181 + z12 * z170 + s_pitch * z174 - c_pitch * z173;
    const Scalar z184 = n0_35 / z169;
    const Scalar z185 = -z172 * (n1 - z9);
    const Scalar z186 = n0_08 * z175 + n0_35 * z185;
    const Scalar z187 = n2 * (s_roll * z145 - z136 * z136);
    const Scalar z188 = n2 * (z120 * z162 + z125 * z163 - z119 * z187 - z152 * z152 - z155 * z155 - z144 * z144);
    const Scalar z189 = s_yaw * z123;
    const Scalar z190 = z122 * z126 - z123 * z189;
    const Scalar z191 = z124 - z132 * z184;
    const Scalar z192 = z118 + z154 * z184;
    const Scalar z193 = z129 - z133 * z184;
    const Scalar z194 = c_roll * z172 + c_steer * z134 + z136 * z116 + s_roll * z182;
    const Scalar z195 = z135 * z109 + z137 * z122 + s_yaw * z183 - c_yaw * z194;
    const Scalar z196 = s_roll * z172 - c_steer * z136 + z134 * z116 - c_roll * z182;
    const Scalar z197 = n0_5 * (z156 * z178 / (z131 * z131) + z188 / z131);
    const Scalar z198 = c_yaw * z123;
    const Scalar z199 = z135 * z122 - z137 * z109 + c_yaw * z183 + s_yaw * z194;
    const Scalar z200 = z196 * z180;
    const Scalar z201 = z123 * z195 - z127 * z196;
    const Scalar z202 = z123 * z199 - z126 * z196;
    const Scalar z203 = s_pitch * z179 - c_pitch * z186 - z100 * z170 - z103 * z181;
    const Scalar z204 = n2 * (z154 * z200 + z133 * z201 + z132 * z202);
    const Scalar z205 = n0_3 * z197;
    const Scalar z206 = z123 * z198 + z122 * z127;
    const Scalar z207 = v_steer * z171;
    const Scalar z208 = z2 * c_steer;
    const Scalar z209 = z1 * c_steer;
    const Scalar z210 = s_roll * z109;
    const Scalar z211 = s_pitch * z208 + c_pitch * z209;
    const Scalar z212 = s_pitch * z209 - c_pitch * z208;
    const Scalar z213 = n0_08 * z208 - n0_35 * z209;
    const Scalar z214 = s_yaw * z210 - c_yaw * z116;
    const Scalar z215 = s_yaw * z116 + c_yaw * z210;
    const Scalar z216 = c_roll * s_steer + s_roll * z211;
    const Scalar z217 = s_roll * s_steer - c_roll * z211;
    const Scalar z218 = c_roll * z109;
    const Scalar z219 = z123 * z214 + z126 * z218;
    const Scalar z220 = z123 * z215 - z127 * z218;
    const Scalar z221 = z180 * z218;
    const Scalar z222 = c_yaw * z212 + s_yaw * z216;
    const Scalar z223 = n2 * (z132 * z219 - z133 * z220 - z154 * z221);
    const Scalar z224 = s_yaw * z212 - c_yaw * z216;
    const Scalar z225 = z123 * z222 - z126 * z217;
    const Scalar z226 = z123 * z224 - z127 * z217;
    const Scalar z227 = z180 * z217;
    const Scalar z228 = z122 * z180;
    const Scalar z229 = n2 * (z133 * z206 - z154 * z228 + z132 * z190);
    const Scalar z230 = n2 * (z154 * z227 + z132 * z225 + z133 * z226);
    const Scalar z231 = n0_5 * z223 / z169;
    const Scalar z232 = s_steer * z8;
    const Scalar z233 = s_steer * (n1 - z7);
    const Scalar z234 = n0_08 * z233 - n0_35 * z232;
    const Scalar z235 = s_steer * (n1 - z9);
    const Scalar z236 = n0_08 * z232 - n0_35 * z235;
    const Scalar z237 = n0_5 * z229 / z169;
    const Scalar z238 = n0_5 * z230 / z169;
    const Scalar z239 = c_roll * z113;
    const Scalar z240 = v_steer * z172;
    const Scalar z241 = c_pitch * z236 + s_pitch * z234;
    const Scalar z242 = z2 * z240;
    const Scalar z243 = z1 * z240;
    const Scalar z244 = n0_5 * z204 / z169;
    const Scalar z245 = z136 * z111 + s_roll * z177 - z134 * z110 - c_roll * z203;
    const Scalar z246 = s_roll * z213 + c_roll * z241;
    const Scalar z247 = z239 + n0_35 * z231;
    const Scalar z248 = v_z - z245;
    const Scalar z249 = v_pitch * z181;
    const Scalar z250 = v_pitch * z170;
    const Scalar z251 = z15 * z249 + z12 * z250 + s_pitch * z242 + c_pitch * z243 - n2 * (z173 * z170 - z174 * z181);
    const Scalar z252 = z246 - n0_35 * z238;
    const Scalar z253 = z12 * z249 - z15 * z250 + s_pitch * z243 - c_pitch * z242 - n2 * (z173 * z181 + z174 * z170);
    const Scalar z254 = n0_08 * z242 - n0_35 * z243;
    const Scalar z255 = z112 - n0_35 * z237;
    const Scalar z256 = n0_3 * z178 / (z131 * z131);
    const Scalar z257 = v_z - z153 * z144 + z119 * z256;
    const Scalar z258 = v_y + z153 * z155 - z125 * z256;
    const Scalar z259 = v_x - z153 * z152 + z120 * z256;
    const Scalar z260 = q_z - z164;
    const Scalar z261 = q_x - z165;
    const Scalar z262 = q_y - z168;
    const Scalar z263 = v_z - z257;
    const Scalar z264 = v_y - z258;
    const Scalar z265 = v_x - z259;
    const Scalar z266 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z267 = s_roll * z266;
    const Scalar z268 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z269 = s_pitch * z1 - c_pitch * z2;
    const Scalar z270 = s_yaw * z267 - c_yaw * z268;
    const Scalar z271 = s_roll * z269;
    const Scalar z272 = c_roll * z266;
    const Scalar z273 = s_pitch * z2 + c_pitch * z1;
    const Scalar z274 = q_x - z191;
    const Scalar z275 = c_roll * z269;
    const Scalar z276 = q_z - z192;
    const Scalar z277 = s_yaw * z271 - c_yaw * z273;
    const Scalar z278 = c_yaw * z276;
    const Scalar z279 = s_roll * z274 + z115 * z276;
    const Scalar z280 = q_y - z193;
    const Scalar z281 = s_yaw * z273 + c_yaw * z271;
    const Scalar z282 = s_yaw * z276;
    const Scalar z283 = s_roll * z280 - z121 * z276;
    const Scalar z284 = c_yaw * z260;
    const Scalar z285 = s_yaw * z260;
    const Scalar z286 = s_roll * z261 + z115 * z260;
    const Scalar z287 = n2 * z196;
    const Scalar z288 = z145 * z116 - c_roll * z207 - c_steer * z148 - n2 * (z136 * z182 - z134 * z172) + s_roll * z251;
    const Scalar z289 = s_roll * z207 + c_steer * z145 + z148 * z116 + n2 * (z136 * z172 + z134 * z182) + c_roll * z251;
    const Scalar z290 = z147 * z109 - z149 * z122 - n2 * (z135 * z183 + z137 * z194) + s_yaw * z253 - c_yaw * z288;
    const Scalar z291 = z149 * z109 + z147 * z122 - n2 * (z135 * z194 - z137 * z183) + c_yaw * z253 + s_yaw * z288;
    const Scalar z292 = z195 * z287 + z127 * z289 + z123 * z290;
    const Scalar z293 = z199 * z287 + z126 * z289 + z123 * z291;
    const Scalar z294 = n2 * (z123 * z289 - z196 * z196);
    const Scalar z295 = n2 * (z133 * z292 - z200 * z200 - z201 * z201 - z202 * z202 - z154 * z294 + z132 * z293);
    const Scalar z296 = s_roll * z262 - z121 * z260;
    const Scalar z297 = z8 * z207;
    const Scalar z298 = -z207 * (n1 - z7);
    const Scalar z299 = q_z - z272;
    const Scalar z300 = n0_35 * z297 + n0_08 * z298;
    const Scalar z301 = -z207 * (n1 - z9);
    const Scalar z302 = n0_08 * z297 + n0_35 * z301;
    const Scalar z303 = q_x - z270;
    const Scalar z304 = z191 - z303;
    const Scalar z305 = z192 - z299;
    const Scalar z306 = s_yaw * z268 + c_yaw * z267;
    const Scalar z307 = s_pitch * z300 - z103 * z250 - c_pitch * z302 + z100 * z249 + n2 * (z170 * z179 + z181 * z186);
    const Scalar z308 = n0_5 * (z204 * z244 / (z169 * z169) + z295 / z169);
    const Scalar z309 = q_y + z306;
    const Scalar z310 = z193 - z309;
    const Scalar z311 = z135 * z260 + s_yaw * z263;
    const Scalar z312 = c_yaw * z263 - z137 * z260;
    const Scalar z313 = z275 * z310 + z281 * z305;
    const Scalar z314 = z136 * z262 + z150 * z260 + s_roll * z264 - z121 * z263;
    const Scalar z315 = z145 * z111 + s_roll * z254 + z148 * z110 - n2 * (z136 * z177 + z134 * z203) + c_roll * z307;
    const Scalar z316 = c_roll * z177 - z134 * z111 - z136 * z110 + s_roll * z203;
    const Scalar z317 = s_pitch * z186 + c_pitch * z179 + z100 * z181 - z103 * z170;
    const Scalar z318 = v_yaw * z264 - v_roll * z311 + z314 * (v_pitch + v_rear);
    const Scalar z319 = z124 - z191;
    const Scalar z320 = z118 - z192;
    const Scalar z321 = z129 - z193;
    const Scalar z322 = n0_35 * z244 / (z169 * z169);
    const Scalar z323 = z136 * z261 - z146 * z260 + s_roll * z265 + z115 * z263;
    const Scalar z324 = v_yaw * z265 - v_roll * z312 + z323 * (v_pitch + v_rear);
    const Scalar z325 = z315 - n0_35 * z308;
    const Scalar z326 = z154 * z322 - z248 - z184 * z200;
    const Scalar z327 = z248 + z326;
    const Scalar z328 = z275 * z304 - z277 * z305;
    const Scalar z329 = z123 * z319 - z126 * z320;
    const Scalar z330 = z123 * z321 - z127 * z320;
    const Scalar z331 = v_yaw * s_roll;
    const Scalar z332 = v_yaw * c_roll;
    const Scalar z333 = v_pitch + z331;  // angular velocity of frame, y
    const Scalar z334 = v_roll * z331;  // angular acceleration of frame.2, z
    const Scalar z335 = v_roll * c_pitch - s_pitch * z332;
    const Scalar z336 = v_roll * s_pitch + c_pitch * z332;
    const Scalar z337 = s_pitch * z334;
    const Scalar z338 = c_pitch * z334;
    const Scalar z339 = n9_81 * c_roll;
    const Scalar z340 = v_pitch * z336 - z337;  // angular acceleration of frame, x
    const Scalar z341 = v_pitch * z335 - z338;  // angular acceleration of frame, z
    const Scalar z342 = v_roll * z332;  // angular acceleration of frame.2, y
    const Scalar z343 = z333 * z333;
    const Scalar z344 = z336 * z336;
    const Scalar z345 = s_pitch * z339;
    const Scalar z346 = c_pitch * z339;
    const Scalar z347 = n9_81 * s_roll;
    const Scalar z348 = v_rear + z333;  // angular velocity of rear_wheel, y
    const Scalar z349 = n0_3 * z170 - n1_1 * z181;
    const Scalar z350 = s_yaw * z316 - c_yaw * z317 - z135 * z112 - z137 * z113;
    const Scalar z351 = s_yaw * z317 - z135 * z113 + z137 * z112 + c_yaw * z316;
    const Scalar z352 = v_x + z350;
    const Scalar z353 = z352 - z184 * z202 + z132 * z322;
    const Scalar z354 = v_y - z351;
    const Scalar z355 = z354 - z184 * z201 + z133 * z322;
    const Scalar z356 = z343 + z344;
    const Scalar z357 = z335 * z336;
    const Scalar z358 = z335 * z333;
    const Scalar z359 = z342 + z357;
    const Scalar z360 = z1 * z181 - z2 * z170;
    const Scalar z361 = z352 - z353;
    const Scalar z362 = z1 * z170 + z2 * z181;
    const Scalar z363 = n1_1 * z170 + n0_3 * z181;
    const Scalar z364 = z123 * z361 - z196 * z319 - z199 * z320 - z126 * z327;
    const Scalar z365 = z354 - z355;
    const Scalar z366 = z123 * z365 - z196 * z321 - z195 * z320 - z127 * z327;
    const Scalar z367 = z136 * z266 + s_roll * z363;
    const Scalar z368 = c_roll * z363 - z134 * z266;
    const Scalar z369 = c_roll * z362 - z134 * z269;
    const Scalar z370 = z136 * z269 + s_roll * z362;
    const Scalar z371 = v_z - z368;
    const Scalar z372 = z326 + z371;
    const Scalar z373 = v_z + z326;
    const Scalar z374 = z137 * z268 - c_yaw * z349 + z135 * z267 + s_yaw * z367;
    const Scalar z375 = z135 * z268 + s_yaw * z349 - z137 * z267 + c_yaw * z367;
    const Scalar z376 = v_x - z374;
    const Scalar z377 = z353 - z376;
    const Scalar z378 = v_x - z353;
    const Scalar z379 = z136 * z274 - z146 * z276 + s_roll * z378 + z115 * z373;
    const Scalar z380 = v_y + z375;
    const Scalar z381 = z355 - z380;
    const Scalar z382 = v_y - z355;
    const Scalar z383 = z136 * z280 + z150 * z276 + s_roll * z382 - z121 * z373;
    const Scalar z384 = z341 + z358;
    const Scalar z385 = z336 * z333;
    const Scalar z386 = z340 + z385;
    const Scalar z387 = z137 * z273 + c_yaw * z360 + z135 * z271 + s_yaw * z370;
    const Scalar z388 = s_yaw * z360 - z135 * z273 + z137 * z271 - c_yaw * z370;
    const Scalar z389 = z304 * z369 - z305 * z387 + z275 * z377 + z277 * z372;
    const Scalar z390 = z310 * z369 - z305 * z388 + z275 * z381 - z281 * z372;
    const Scalar z391 = z135 * z276 + s_yaw * z373;
    const Scalar z392 = c_yaw * z373 - z137 * z276;
    const Scalar z393 = v_yaw * z378 + v_pitch * z379 + v_steer * z389 - v_roll * z392 + v_front * z364;
    const Scalar z394 = v_yaw * z382 - v_roll * z391 + v_pitch * z383 + v_steer * z390 + v_front * z366;
    const Scalar z395 = z12 * z333 + z11 * z335 - z13 * z336;
    const Scalar z396 = z342 - z357;
    const Scalar z397 = z2 * v_steer;
    const Scalar z398 = z335 * z335;
    const Scalar z399 = z343 + z398;
    const Scalar z400 = z344 - z398;
    const Scalar z401 = z15 * z333 - z11 * z336 + z14 * z335;
    const Scalar z402 = c_steer * z333 - z15 * z335 + z12 * z336;
    const Scalar z403 = z335 * z348;
    const Scalar z404 = z336 * z348;
    const Scalar z405 = n0_12 * z403;  // moment on rear_wheel, z
    const Scalar z406 = n0_12 * z404;  // moment on rear_wheel, x
    const Scalar z407 = z1 * v_steer;
    const Scalar z408 = z395 - z397;  // angular velocity of fork, z
    const Scalar z409 = z1 * z395 + z2 * z401;
    const Scalar z410 = z401 + z407;  // angular velocity of fork, x
    const Scalar z411 = c_steer * z342 + z15 * z340 + z12 * z341;
    const Scalar z412 = v_steer * z409 - z411;  // angular acceleration of fork, y
    const Scalar z413 = z345 - n1_1 * z356 + n0_3 * z359;
    const Scalar z414 = z402 * z402;
    const Scalar z415 = z408 * z408;
    const Scalar z416 = z347 - n1_1 * z384 - n0_3 * z386;
    const Scalar z417 = z346 + n1_1 * z396 + n0_3 * z399;
    const Scalar z418 = z414 + z415;
    const Scalar z419 = z410 * z408;
    const Scalar z420 = z11 * z340 - z12 * z342 + z13 * z341;
    const Scalar z421 = z14 * z340 - z15 * z342 + z11 * z341;
    const Scalar z422 = z402 * z407 - z420;  // angular acceleration of fork, z
    const Scalar z423 = z402 * z397 - z421;  // angular acceleration of fork, x
    const Scalar z424 = z331 * z332;
    const Scalar z425 = n2 * z334;
    const Scalar z426 = z412 + z419;
    const Scalar z427 = z412 - z419;
    const Scalar z428 = z410 * z410;
    const Scalar z429 = z414 + z428;
    const Scalar z430 = z415 - z428;
    const Scalar z431 = v_front + z402;  // angular velocity of front_wheel, y
    const Scalar z432 = z14 * z413 - z15 * z416 + z11 * z417;
    const Scalar z433 = n1_04 * z418 + n3_85 * z426 + n7 * z432;  // force on fork, x
    const Scalar z434 = z15 * z413 + z12 * z417 + c_steer * z416;
    const Scalar z435 = z11 * z413 - z12 * z416 + z13 * z417;
    const Scalar z436 = n1_04 * z427 - n3_85 * z429 + n7 * z435;  // force on fork, z
    const Scalar z437 = n25_over_7 * z17;
    const Scalar z438 = z46 * z437 - z75;
    const Scalar z439 = n25_over_7 * z30;
    const Scalar z440 = z30 * z439 - z82;
    const Scalar z441 = z46 * z439 - z83;
    const Scalar z442 = n25_over_7 * z46;
    const Scalar z443 = z46 * z442 - z105;
    const Scalar z444 = z402 * z410;
    const Scalar z445 = z30 * z437 - z74;
    const Scalar z446 = z410 * z431;
    const Scalar z447 = z402 * z408;
    const Scalar z448 = z408 * z431;
    const Scalar z449 = n0_28 * z446;  // moment on front_wheel, z
    const Scalar z450 = n0_28 * z448;  // moment on front_wheel, x
    const Scalar z451 = z422 - z444;
    const Scalar z452 = n25_over_3 * z19;
    const Scalar z453 = z19 * z452 + z443;
    const Scalar z454 = n3_85 * z434 - z450 - k34 * z447 - k3 * z423 - k4 * z451;  // moment on fork, x
    const Scalar z455 = z423 + z447;
    const Scalar z456 = k35 * z444 + z449 - k5 * z422 - k4 * z455 + n1_04 * z434;  // moment on fork, z
    const Scalar z457 = n7 * z434 - n1_04 * z451 - n3_85 * z455;  // force on fork, y
    const Scalar z458 = c_steer * z17 - z61;
    const Scalar z459 = z19 + z438;
    const Scalar z460 = z10 * z43;
    const Scalar z461 = z10 * z78;
    const Scalar z462 = z10 * z84;
    const Scalar z463 = z10 * z50;
    const Scalar z464 = z10 * z92;
    const Scalar z465 = z10 * z93;
    const Scalar z466 = n0_28 * z412;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z467 = z466 + k36 * z419 + k4 * z430 + n2_5667 * z412 + n3_85 * z432 + n1_04 * z435;
    const Scalar z468 = z92 * z462 - z107;
    const Scalar z469 = z93 * z462 + z108;
    const Scalar z470 = z50 * z462;
    const Scalar z471 = n94 - z50 * z463;
    const Scalar z472 = z92 * z463;
    const Scalar z473 = n94 - z92 * z464;
    const Scalar z474 = z93 * z464;
    const Scalar z475 = z93 * z463;
    const Scalar z476 = n94 - z93 * z465;
    const Scalar z477 = n0_12 * z342;  // moment on rear_wheel, y
    const Scalar z478 = z14 * z433 + z11 * z436 + z15 * z457;
    const Scalar z479 = n25_5 * z356 - z478 + n51 * z359;  // force on frame, x
    const Scalar z480 = z84 * z462 + z453;
    const Scalar z481 = z11 * z433 + z13 * z436 + z12 * z457;
    const Scalar z482 = c_steer * z457 - z15 * z433 - z12 * z436;
    const Scalar z483 = z481 + n25_5 * z396 - n51 * z399;  // force on frame, z
    const Scalar z484 = z92 * z461 - z104;
    const Scalar z485 = z93 * z461 + z106;
    const Scalar z486 = z13 * z456 + z11 * z454 - z12 * z467;
    const Scalar z487 = z11 * z456 + z14 * z454 - z15 * z467;
    const Scalar z488 = z12 * z456 + z15 * z454 + c_steer * z467;
    // moment on frame, y
    const Scalar z489 = z477 + n49_25 * z342 - n51 * z345 + n25_5 * z346 + n29_35 * z357 + n17_7 * z400 + n0_3 * z478
        + n1_1 * z481 - z488;
    const Scalar z490 = z43 * z460 + z458;
    const Scalar z491 = z92 * z460 - z96;
    const Scalar z492 = z93 * z460 + z97;
    const Scalar z493 = n25_5 * z347 - z405 - n9_95 * z384 + n17_7 * z386 + n1_1 * z482 - z486;  // moment on frame, z
    const Scalar z494 = n51 * z347 + z406 - n17_7 * z384 + n39_3 * z386 - n0_3 * z482 + z487;  // moment on frame, x
    const Scalar z495 = n25_5 * z384 - z482 - n51 * z386;  // force on frame, y
    const Scalar z496 = z1 * z454 - z2 * z456;
    const Scalar z497 = z78 * z460 - z445;
    const Scalar z498 = z78 * z461 + z440;
    const Scalar z499 = n1 / z490;
    const Scalar z500 = z84 * z461 - z441;
    const Scalar z501 = z84 * z460 + z459;
    const Scalar z502 = z50 * z461 - z89;
    const Scalar z503 = z50 * z460 + z88;
    const Scalar z504 = z497 * z499;
    const Scalar z505 = z501 * z499;
    const Scalar z506 = z503 * z499;
    const Scalar z507 = z491 * z499;
    const Scalar z508 = z492 * z499;
    const Scalar z509 = s_pitch * z479 - c_pitch * z483;
    const Scalar z510 = s_pitch * z483 + c_pitch * z479;
    const Scalar z511 = z474 - z492 * z507;
    const Scalar z512 = z476 + z492 * z508;
    const Scalar z513 = s_roll * z509 - c_roll * z495;
    const Scalar z514 = s_roll * z495 + c_roll * z509;
    const Scalar z515 = n853_47 - z514;  // force on frame.z, z
    const Scalar z516 = s_pitch * z493 + c_pitch * z494;
    const Scalar z517 = s_pitch * z494 - c_pitch * z493;
    const Scalar z518 = z516 - n0_5603 * z424;  // moment on frame.2, x
    const Scalar z519 = z517 - n0_5603 * z425;  // moment on frame.2, z
    const Scalar z520 = z480 - z501 * z505;
    const Scalar z521 = z470 - z503 * z505;
    const Scalar z522 = z471 + z503 * z506;
    const Scalar z523 = z472 - z491 * z506;
    const Scalar z524 = z468 - z491 * z505;
    const Scalar z525 = z473 + z491 * z507;
    const Scalar z526 = z475 - z492 * z506;
    const Scalar z527 = z469 - z492 * z505;
    const Scalar z528 = s_roll * z489 + c_roll * z519;
    const Scalar z529 = z485 - z492 * z504;
    const Scalar z530 = s_yaw * z513 - c_yaw * z510;
    const Scalar z531 = z484 - z491 * z504;
    const Scalar z532 = s_yaw * z510 + c_yaw * z513;
    const Scalar z533 = z498 - z497 * z504;
    const Scalar z534 = z500 - z501 * z504;
    const Scalar z535 = z502 - z503 * z504;
    const Scalar z536 = n1 / z533;
    const Scalar z537 = z247 + z252 * z460;
    const Scalar z538 = z255 + z252 * z461 - z504 * z537;
    const Scalar z539 = z529 * z536;
    const Scalar z540 = z531 * z536;
    const Scalar z541 = z535 * z536;
    const Scalar z542 = z534 * z536;
    const Scalar z543 = z512 + z529 * z539;
    const Scalar z544 = z511 - z529 * z540;
    const Scalar z545 = z525 + z531 * z540;
    const Scalar z546 = z526 - z529 * z541;
    const Scalar z547 = z523 - z531 * z541;
    const Scalar z548 = z522 + z535 * z541;
    const Scalar z549 = z527 - z529 * z542;
    const Scalar z550 = z524 - z531 * z542;
    const Scalar z551 = z521 - z535 * z542;
    const Scalar z552 = z520 - z534 * z542;
    const Scalar z553 = z285 * z542;
    const Scalar z554 = z252 * z462 - z505 * z537 - z542 * z538;
    const Scalar z555 = n1 / z552;
    const Scalar z556 = z167 * z542;
    const Scalar z557 = z549 * z555;
    const Scalar z558 = z284 * z542;
    const Scalar z559 = z550 * z555;
    const Scalar z560 = z551 * z555;
    const Scalar z561 = z543 + z549 * z557;
    const Scalar z562 = z544 - z549 * z559;
    const Scalar z563 = z545 + z550 * z559;
    const Scalar z564 = z546 - z549 * z560;
    const Scalar z565 = z547 - z550 * z560;
    const Scalar z566 = z548 + z551 * z560;
    const Scalar z567 = n1 + z167 * z541 - z560 * z556;
    const Scalar z568 = n1 + z252 * z463 - z506 * z537 - z541 * z538 - z560 * z554;
    const Scalar z569 = z285 * z541 - z560 * z553;
    const Scalar z570 = z284 * z541 - z560 * z558;
    const Scalar z571 = n1 / z566;
    const Scalar z572 = z564 * z571;
    const Scalar z573 = z565 * z571;
    const Scalar z574 = z561 - z564 * z572;
    const Scalar z575 = z562 + z564 * z573;
    const Scalar z576 = z283 + z313 * z460 - z330 * z437;
    const Scalar z577 = z563 - z565 * z573;
    const Scalar z578 = z282 + z313 * z461 + z330 * z439 - z504 * z576;
    const Scalar z579 = z167 * z540 - z559 * z556 + z573 * z567;
    const Scalar z580 = z252 * z464 - z507 * z537 - z540 * z538 - z559 * z554 + z573 * z568;
    const Scalar z581 = z285 * z540 - z559 * z553 + z573 * z569;
    const Scalar z582 = n1 - z284 * z540 + z559 * z558 - z573 * z570;
    const Scalar z583 = n1 / z577;
    const Scalar z584 = z280 + z313 * z462 - z330 * z442 - z505 * z576 - z542 * z578;
    const Scalar z585 = z575 * z583;
    const Scalar z586 = z313 * z463 - z506 * z576 - z541 * z578 - z560 * z584;
    const Scalar z587 = z574 - z575 * z585;
    const Scalar z588 = z313 * z464 - z507 * z576 - z540 * z578 - z559 * z584 + z573 * z586;
    const Scalar z589 = z167 * z539 - z557 * z556 + z572 * z567 + z585 * z579;
    const Scalar z590 = z284 * z539 - z557 * z558 + z572 * z570 - z585 * z582;
    const Scalar z591 = n1 / z587;
    const Scalar z592 = n1 - z313 * z465 + z508 * z576 + z539 * z578 + z557 * z584 - z572 * z586 - z585 * z588;
    const Scalar z593 = n1 + z285 * z539 - z557 * z553 + z572 * z569 + z585 * z581;
    const Scalar z594 = z252 * z465 - z508 * z537 - z539 * z538 - z557 * z554 + z572 * z568 + z585 * z580;
    const Scalar z595 = z591 * z592;
    const Scalar z596 = z583 * z588 - z585 * z595;
    const Scalar z597 = z591 * z590;
    const Scalar z598 = z583 * z582 - z585 * z597;
    const Scalar z599 = z591 * z593;
    const Scalar z600 = z571 * z586 - z572 * z595 + z573 * z596;
    const Scalar z601 = z571 * z570 + z572 * z597 - z573 * z598;
    const Scalar z602 = z555 * z584 - z557 * z595 + z559 * z596 + z560 * z600;
    const Scalar z603 = z555 * z558 + z557 * z597 - z559 * z598 + z560 * z601;
    const Scalar z604 = z583 * z581 + z585 * z599;
    const Scalar z605 = z571 * z569 + z572 * z599 + z573 * z604;
    const Scalar z606 = z591 * z594;
    const Scalar z607 = z583 * z580 + z585 * z606;
    const Scalar z608 = z555 * z553 + z557 * z599 + z559 * z604 + z560 * z605;
    const Scalar z609 = z571 * z568 + z572 * z606 + z573 * z607;
    const Scalar z610 = z591 * z589;
    const Scalar z611 = z536 * z578 - z539 * z595 + z540 * z596 + z541 * z600 - z542 * z602;
    const Scalar z612 = z555 * z554 + z557 * z606 + z559 * z607 + z560 * z609;
    const Scalar z613 = z536 * z538 + z539 * z606 + z540 * z607 + z541 * z609 - z542 * z612;
    const Scalar z614 = z583 * z579 + z585 * z610;
    const Scalar z615 = z499 * z576 - z508 * z595 + z507 * z596 + z506 * z600 - z505 * z602 - z504 * z611;
    const Scalar z616 = z499 * z537 + z508 * z606 + z507 * z607 + z506 * z609 - z505 * z612 - z504 * z613;
    const Scalar z617 = z571 * z567 + z572 * z610 + z573 * z614;
    const Scalar z618 = z555 * z556 + z557 * z610 + z559 * z614 + z560 * z617;
    const Scalar z619 = z10 * z313 - z465 * z595 + z464 * z596 + z463 * z600 - z462 * z602 - z461 * z611 - z460 * z615;
    const Scalar z620 = z284 * z536 - z539 * z597 + z540 * z598 - z541 * z601 + z542 * z603;
    const Scalar z621 = z508 * z597 - z507 * z598 + z506 * z601 - z505 * z603 + z504 * z620;
    const Scalar z622 = z465 * z597 - z464 * z598 + z463 * z601 - z462 * z603 + z461 * z620 - z460 * z621;
    const Scalar z623 = n25_over_3 * z286 - z621 - z452 * z603;
    const Scalar z624 = z442 * z603 + z439 * z620 + z437 * z621;
    const Scalar z625 = z285 * z536 - z539 * z599 - z540 * z604 - z541 * z605 + z542 * z608;
    const Scalar z626 = z508 * z599 + z507 * z604 + z506 * z605 - z505 * z608 + z504 * z625;
    const Scalar z627 = z465 * z599 + z464 * z604 + z463 * z605 - z462 * z608 + z461 * z625 - z460 * z626;
    const Scalar z628 = n25_over_3 * z296 - z626 - z452 * z608;
    const Scalar z629 = z442 * z608 + z439 * z625 + z437 * z626;
    const Scalar z630 = z10 * z252 + z465 * z606 + z464 * z607 + z463 * z609 - z462 * z612 - z461 * z613 - z460 * z616;
    const Scalar z631 = z452 * z612 + z616;
    const Scalar z632 = z442 * z612 - z439 * z613 + z437 * z616;
    const Scalar z633 = z167 * z536 - z539 * z610 - z540 * z614 - z541 * z617 + z542 * z618;
    const Scalar z634 = n25_over_7 * z330 + z442 * z602 - z439 * z611 + z437 * z615;
    const Scalar z635 = z508 * z610 + z507 * z614 + z506 * z617 - z505 * z618 + z504 * z633;
    const Scalar z636 = z279 + z328 * z460 - z329 * z437;
    const Scalar z637 = z465 * z610 + z464 * z614 + z463 * z617 - z462 * z618 + z461 * z633 - z460 * z635;
    const Scalar z638 = z278 + z328 * z461 + z329 * z439 - z504 * z636;
    const Scalar z639 = z452 * z618 + z635;
    const Scalar z640 = z274 + z328 * z462 - z329 * z442 - z505 * z636 - z542 * z638;
    const Scalar z641 = z442 * z618 + z439 * z633 + z437 * z635;
    const Scalar z642 = z328 * z463 - z506 * z636 - z541 * z638 - z560 * z640;
    const Scalar z643 = n1 + z328 * z464 - z507 * z636 - z540 * z638 - z559 * z640 + z573 * z642;
    const Scalar z644 = z328 * z465 - z508 * z636 - z539 * z638 - z557 * z640 + z572 * z642 + z585 * z643;
    const Scalar z645 = z591 * z644;
    const Scalar z646 = z274 * z602 - z596 + z278 * z611 + z279 * z615 - z328 * z619 - z329 * z634;
    const Scalar z647 = z583 * z643 + z585 * z645;
    const Scalar z648 = z571 * z642 + z572 * z645 + z573 * z647;
    const Scalar z649 = z280 * z602 - z595 + z282 * z611 + z283 * z615 - z313 * z619 - z330 * z634;
    const Scalar z650 = z555 * z640 + z557 * z645 + z559 * z647 + z560 * z648;
    const Scalar z651 = z536 * z638 + z539 * z645 + z540 * z647 + z541 * z648 - z542 * z650;
    const Scalar z652 = z499 * z636 + z508 * z645 + z507 * z647 + z506 * z648 - z505 * z650 - z504 * z651;
    const Scalar z653 = z10 * z328 + z465 * z645 + z464 * z647 + z463 * z648 - z462 * z650 - z461 * z651 - z460 * z652;
    const Scalar z654 = n25_over_7 * z329 + z442 * z650 - z439 * z651 + z437 * z652;
    const Scalar z655 = z274 * z650 - z647 + z278 * z651 + z279 * z652 - z328 * z653 - z329 * z654;
    const Scalar z656 = n1 / z655;
    const Scalar z657 = z597 + z280 * z603 - z282 * z620 + z283 * z621 - z313 * z622 - z330 * z624;
    const Scalar z658 = z598 + z274 * z603 - z278 * z620 + z279 * z621 - z328 * z622 - z329 * z624;
    const Scalar z659 = z598 + z261 * z603 - z284 * z620 + z286 * (z621 + z623);
    const Scalar z660 = z646 * z656;
    const Scalar z661 = z658 * z656;
    const Scalar z662 = z261 * z608 - z604 - z284 * z625 + z286 * (z626 + z628);
    const Scalar z663 = z649 - z646 * z660;
    const Scalar z664 = z657 - z658 * z660;
    const Scalar z665 = n1 / z663;
    const Scalar z666 = z659 + z658 * z661;
    const Scalar z667 = z599 + z280 * z608 - z282 * z625 + z283 * z626 - z313 * z627 - z330 * z629;
    const Scalar z668 = z274 * z608 - z604 - z278 * z625 + z279 * z626 - z328 * z627 - z329 * z629;
    const Scalar z669 = z662 + z668 * z661;
    const Scalar z670 = z667 - z668 * z660;
    const Scalar z671 = z599 + z262 * z608 - z285 * z625 + z296 * (z626 + z628);
    const Scalar z672 = z668 * z656;
    const Scalar z673 = z671 + z668 * z672;
    const Scalar z674 = z606 + z262 * z612 + z285 * z613 + z296 * (z616 - z631);
    const Scalar z675 = z261 * z612 - z607 + z284 * z613 + z286 * (z616 - z631);
    const Scalar z676 = z606 + z280 * z612 + z282 * z613 + z283 * z616 - z313 * z630 - z330 * z632;
    const Scalar z677 = z274 * z612 - z607 + z278 * z613 + z279 * z616 - z328 * z630 - z329 * z632;
    const Scalar z678 = z674 + z677 * z672;
    const Scalar z679 = z675 + z677 * z661;
    const Scalar z680 = z676 - z677 * z660;
    const Scalar z681 = z255 * z613 - z609 + z247 * z616 - z252 * z630;
    const Scalar z682 = z677 * z656;
    const Scalar z683 = z681 - z677 * z682;
    const Scalar z684 = z617 + z255 * z633 - z247 * z635 + z252 * z637;
    const Scalar z685 = z610 + z262 * z618 - z285 * z633 + z296 * (z635 - z639);
    const Scalar z686 = z261 * z618 - z614 - z284 * z633 + z286 * (z635 - z639);
    const Scalar z687 = z610 + z280 * z618 - z282 * z633 + z283 * z635 - z313 * z637 - z330 * z641;
    const Scalar z688 = z274 * z618 - z614 - z278 * z633 + z279 * z635 - z328 * z637 - z329 * z641;
    const Scalar z689 = z684 + z688 * z682;
    const Scalar z690 = z685 + z688 * z672;
    const Scalar z691 = z686 + z688 * z661;
    const Scalar z692 = z687 - z688 * z660;
    const Scalar z693 = z167 * z633 - z617;
    const Scalar z694 = z688 * z656;
    const Scalar z695 = z693 - z688 * z694;
    const Scalar z696 = z452 * z602 + z615;
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
    const Scalar z712 = z452 * z650 + z652;
    const Scalar z713 = z693 + z681 - z671 - z659 + z649 + z655;
    const Scalar z714 = n4096 * z713;
    const Scalar z715 = z466 * z437 - z477 - z496 * z460 + z489;
    const Scalar z716 = z466 * z439 + z496 * z461 + z504 * z715 - z518;
    const Scalar z717 = z699 * z702;
    const Scalar z718 = z704 - z699 * z717;
    const Scalar z719 = z705 - z700 * z717;
    const Scalar z720 = z706 - z701 * z717;
    const Scalar z721 = z700 * z702;
    const Scalar z722 = z708 + z700 * z721;
    const Scalar z723 = z466 * z442 - z477 * z452 - z496 * z462 - z505 * z715 + z542 * z716 + z528;
    const Scalar z724 = n1 / z718;
    const Scalar z725 = z709 - z701 * z721;
    const Scalar z726 = z515 - z496 * z463 - z506 * z715 + z541 * z716 - z560 * z723;
    const Scalar z727 = z532 - z496 * z464 - z507 * z715 + z540 * z716 - z559 * z723 + z573 * z726;
    const Scalar z728 = z530 + z496 * z465 + z508 * z715 - z539 * z716 + z557 * z723 - z572 * z726 - z585 * z727;
    const Scalar z729 = z591 * z728;
    const Scalar z730 = z719 * z724;
    const Scalar z731 = z722 + z719 * z730;
    const Scalar z732 = z725 - z720 * z730;
    const Scalar z733 = z583 * z727 - z585 * z729;
    const Scalar z734 = z701 * z702;
    const Scalar z735 = z711 + z701 * z734;
    const Scalar z736 = n1 / z731;
    const Scalar z737 = z720 * z724;
    const Scalar z738 = z571 * z726 - z572 * z729 + z573 * z733;
    const Scalar z739 = z735 + z720 * z737;
    const Scalar z740 = z555 * z723 - z557 * z729 + z559 * z733 + z560 * z738;
    const Scalar z741 = z536 * z716 + z539 * z729 - z540 * z733 - z541 * z738 + z542 * z740;
    const Scalar z742 = z732 * z736;
    const Scalar z743 = z499 * z715 - z508 * z729 + z507 * z733 + z506 * z738 - z505 * z740 + z504 * z741;
    const Scalar z744 = z10 * z496 + z465 * z729 - z464 * z733 - z463 * z738 + z462 * z740 - z461 * z741 + z460 * z743;
    const Scalar z745 = n25_over_7 * z466 - z442 * z740 - z439 * z741 - z437 * z743;
    const Scalar z746 = z394 - z729 + z280 * z740 - z282 * z741 + z283 * z743 + z313 * z744 + z330 * z745;
    const Scalar z747 = z393 - z733 + z274 * z740 - z278 * z741 + z279 * z743 + z328 * z744 + z329 * z745;
    const Scalar z748 = z325 + z738 + z255 * z741 - z247 * z743 - z252 * z744;
    const Scalar z749 = z743 + n25_over_3 * z477 + z452 * z740;
    const Scalar z750 = z318 - z729 + z262 * z740 - z285 * z741 + z296 * (z743 - z749);
    const Scalar z751 = z324 - z733 + z261 * z740 - z284 * z741 + z286 * (z743 - z749);
    const Scalar z752 = z205 - z738 + z167 * z741;
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
    const Scalar z766 = z610 * z760 - z729 + z606 * z761 - z599 * z762 - z597 * z763 - z595 * z764 - z645 * z765;
    const Scalar z767 = z733 + z614 * z760 + z607 * z761 - z604 * z762 + z598 * z763 + z596 * z764 - z647 * z765;
    const Scalar z768 = z738 + z617 * z760 + z609 * z761 - z605 * z762 - z601 * z763 + z600 * z764 - z648 * z765;
    const Scalar z769 = z740 + z618 * z760 + z612 * z761 - z608 * z762 - z603 * z763 + z602 * z764 - z650 * z765;
    const Scalar z770 = z741 + z633 * z760 - z613 * z761 - z625 * z762 - z620 * z763 - z611 * z764 + z651 * z765;
    const Scalar z771 = z743 + z635 * z760 + z616 * z761 - z626 * z762 - z621 * z763 + z615 * z764 - z652 * z765;
    const Scalar z772 = z637 * z760 - z744 + z630 * z761 - z627 * z762 - z622 * z763 + z619 * z764 - z653 * z765;
    const Scalar z773 = z749 + z639 * z760 + z631 * z761 + z628 * z762 + z623 * z763 + z696 * z764 - z712 * z765;
    const Scalar z774 = z641 * z760 - z745 + z632 * z761 - z629 * z762 - z624 * z763 + z634 * z764 - z654 * z765;
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
    if (!(traits::regular(z587, n94) && traits::regular(z577, n94) && traits::regular(z566, n94)
        && traits::regular(-z552, z105) && traits::regular(-z533, z82) && traits::regular(-z490, z71)
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
    const Scalar z15 = n0_08 * z8 - n0_35 * z11;
    const Scalar z16 = v_roll * c_pitch - s_pitch * z6;
    const Scalar z17 = v_roll * s_pitch + c_pitch * z6;
    const Scalar z18 = v_pitch + z7;  // angular velocity of frame, y
    const Scalar z19 = v_rear + z18;  // angular velocity of rear_wheel, y
    const Scalar z20 = n0_08 * z9 - n0_35 * z10;
    const Scalar z21 = n0_8 * z8 - n2_8 * z11;
    const Scalar z22 = n0_08 * z10 - n0_35 * z12;
    const Scalar z23 = c_roll * z13;
    const Scalar z24 = z8 * z18 - z10 * z17 + z9 * z16;
    const Scalar z25 = c_steer * z18 - z8 * z16 + z11 * z17;
    const Scalar z26 = z11 * z18 + z10 * z16 - z12 * z17;
    const Scalar z27 = v_z * s_roll - c_roll * z4;
    const Scalar z28 = v_z * c_roll + s_roll * z4;
    const Scalar z29 = s_rear * z17 - c_rear * z16;
    const Scalar z30 = s_rear * z16 + c_rear * z17;
    const Scalar z31 = c_roll * z14;
    const Scalar z32 = n0_8 * z9 - n2_8 * z10;
    const Scalar z33 = n0_8 * z10 - n2_8 * z12;
    const Scalar z34 = q_z - z23;
    const Scalar z35 = s_pitch * z28 - c_pitch * z5;
    const Scalar z36 = s_pitch * z5 + c_pitch * z28;
    const Scalar z37 = n0_3 * z16 - z27 - n1_1 * z17;
    const Scalar z38 = n51 * z16 + n25_5 * z17 + n85 * z27;
    const Scalar z39 = n39_8 * z16 + n17_7 * z17 + n51 * z27;
    const Scalar z40 = n17_7 * z16 + n10_45 * z17 + n25_5 * z27;
    const Scalar z41 = n0_3 + z22;
    const Scalar z42 = n1_1 - z20;
    const Scalar z43 = c_pitch * z33 + s_pitch * z32;
    const Scalar z44 = n1_1 * z18 - z36;
    const Scalar z45 = z1 * v_steer + z24;  // angular velocity of fork, x
    const Scalar z46 = n0_3 * z18 - z35;
    const Scalar z47 = z2 * v_steer - z26;  // angular velocity of fork, z
    const Scalar z48 = s_pitch * z42 - c_pitch * z41;
    const Scalar z49 = v_front + z25;  // angular velocity of front_wheel, y
    const Scalar z50 = z10 * z44 - z8 * z37 + z9 * z46;
    const Scalar z51 = z12 * z44 - z11 * z37 + z10 * z46;
    const Scalar z52 = c_steer * z37 + z8 * z46 + z11 * z44;
    const Scalar z53 = s_roll * z15 + c_roll * z48;
    const Scalar z54 = n0_35 * z25 - z50;
    const Scalar z55 = n0_08 * z25 - z51;
    const Scalar z56 = q_z - z53;
    const Scalar z57 = s_rear * z36 + c_rear * z35;
    const Scalar z58 = s_rear * z35 - c_rear * z36;
    const Scalar z59 = n0_35 * z45 - z52 - n0_08 * z47;
    const Scalar z60 = s_front * z47 - c_front * z45;
    const Scalar z61 = s_front * z45 + c_front * z47;
    const Scalar z62 = s_front * z55 + c_front * z54;
    const Scalar z63 = s_front * z54 - c_front * z55;
    const Scalar z64 = n51 * z18 + n85 * z35;
    const Scalar z65 = n25_5 * z18 - n85 * z36;
    const Scalar z66 = n49_25 * z18 - n25_5 * z36 + n51 * z35;
    const Scalar z67 = n2_8 * z25 - n4 * z50;
    const Scalar z68 = n2_8 * z45 - n0_8 * z47 - n4 * z52;
    const Scalar z69 = n0_8 * z25 - n4 * z51;
    const Scalar z70 = k16 * z45 - k17 * z47 - n2_8 * z52;
    const Scalar z71 = n2_18 * z25 - n2_8 * z50 - n0_8 * z51;
    const Scalar z72 = k17 * z45 - k19 * z47 - n0_8 * z52;
    const Scalar z73 = s_roll * z21 - c_roll * z43;
    result.kinetic = z27 * z27 + n0_06 * z19 * z19 + k21 * (z29 * z29 + z30 * z30) + z57 * z57 + n0_14 * z49 * z49 + z58
        * z58 + k23 * (z60 * z60 + z61 * z61) + n1_5 * (z59 * z59 + z62 * z62 + z63 * z63) + n0_5 * (z16 * z39 + z17
        * z40 + z27 * z38 - z36 * z65 + z35 * z64 + z18 * z66 + z45 * z70 - z47 * z72 - z50 * z67 - z52 * z68 - z51
        * z69 + z25 * z71);
    result.force_function = n853_47 * q_z + n39_24 * z34 - n9_81 * (z31 + z73) + n29_43 * z56;
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
    const Scalar z15 = n0_08 * z8 - n0_35 * z11;
    const Scalar z16 = v_roll * c_pitch - s_pitch * z6;
    const Scalar z17 = v_roll * s_pitch + c_pitch * z6;
    const Scalar z18 = v_pitch + z7;  // angular velocity of frame, y
    const Scalar z19 = v_rear + z18;  // angular velocity of rear_wheel, y
    const Scalar z20 = n0_08 * z9 - n0_35 * z10;
    const Scalar z21 = n0_8 * z8 - n2_8 * z11;
    const Scalar z22 = n0_08 * z10 - n0_35 * z12;
    const Scalar z23 = c_roll * z13;
    const Scalar z24 = z8 * z18 - z10 * z17 + z9 * z16;
    const Scalar z25 = c_steer * z18 - z8 * z16 + z11 * z17;
    const Scalar z26 = z11 * z18 + z10 * z16 - z12 * z17;
    const Scalar z27 = v_z * s_roll - c_roll * z4;
    const Scalar z28 = v_z * c_roll + s_roll * z4;
    const Scalar z29 = s_rear * z17 - c_rear * z16;
    const Scalar z30 = s_rear * z16 + c_rear * z17;
    const Scalar z31 = c_roll * z14;
    const Scalar z32 = n0_8 * z9 - n2_8 * z10;
    const Scalar z33 = n0_8 * z10 - n2_8 * z12;
    const Scalar z34 = q_z - z23;
    const Scalar z35 = s_pitch * z28 - c_pitch * z5;
    const Scalar z36 = s_pitch * z5 + c_pitch * z28;
    const Scalar z37 = n0_3 * z16 - z27 - n1_1 * z17;
    const Scalar z38 = n51 * z16 + n25_5 * z17 + n85 * z27;
    const Scalar z39 = n39_8 * z16 + n17_7 * z17 + n51 * z27;
    const Scalar z40 = n17_7 * z16 + n10_45 * z17 + n25_5 * z27;
    const Scalar z41 = n0_3 + z22;
    const Scalar z42 = n1_1 - z20;
    const Scalar z43 = c_pitch * z33 + s_pitch * z32;
    const Scalar z44 = n1_1 * z18 - z36;
    const Scalar z45 = z1 * v_steer + z24;  // angular velocity of fork, x
    const Scalar z46 = n0_3 * z18 - z35;
    const Scalar z47 = z2 * v_steer - z26;  // angular velocity of fork, z
    const Scalar z48 = s_pitch * z42 - c_pitch * z41;
    const Scalar z49 = v_front + z25;  // angular velocity of front_wheel, y
    const Scalar z50 = z10 * z44 - z8 * z37 + z9 * z46;
    const Scalar z51 = z12 * z44 - z11 * z37 + z10 * z46;
    const Scalar z52 = c_steer * z37 + z8 * z46 + z11 * z44;
    const Scalar z53 = s_roll * z15 + c_roll * z48;
    const Scalar z54 = n0_35 * z25 - z50;
    const Scalar z55 = n0_08 * z25 - z51;
    const Scalar z56 = q_z - z53;
    const Scalar z57 = s_rear * z36 + c_rear * z35;
    const Scalar z58 = s_rear * z35 - c_rear * z36;
    const Scalar z59 = n0_35 * z45 - z52 - n0_08 * z47;
    const Scalar z60 = s_front * z47 - c_front * z45;
    const Scalar z61 = s_front * z45 + c_front * z47;
    const Scalar z62 = s_front * z55 + c_front * z54;
    const Scalar z63 = s_front * z54 - c_front * z55;
    const Scalar z64 = n51 * z18 + n85 * z35;
    const Scalar z65 = n25_5 * z18 - n85 * z36;
    const Scalar z66 = n49_25 * z18 - n25_5 * z36 + n51 * z35;
    const Scalar z67 = n2_8 * z25 - n4 * z50;
    const Scalar z68 = n2_8 * z45 - n0_8 * z47 - n4 * z52;
    const Scalar z69 = n0_8 * z25 - n4 * z51;
    const Scalar z70 = k16 * z45 - k17 * z47 - n2_8 * z52;
    const Scalar z71 = n2_18 * z25 - n2_8 * z50 - n0_8 * z51;
    const Scalar z72 = k17 * z45 - k19 * z47 - n0_8 * z52;
    const Scalar z73 = s_roll * z21 - c_roll * z43;
    result.energy = -n853_47 * q_z + z27 * z27 + n0_06 * z19 * z19 - n39_24 * z34 + k23 * (z29 * z29 + z30 * z30) + z57
        * z57 + n0_14 * z49 * z49 + z58 * z58 + n9_81 * (z31 + z73) - n29_43 * z56 + k27 * (z60 * z60 + z61 * z61)
        + n1_5 * (z59 * z59 + z62 * z62 + z63 * z63) + n0_5 * (z16 * z39 + z17 * z40 + z27 * z38 - z36 * z65 + z35 * z64
        + z18 * z66 + z45 * z70 - z47 * z72 - z50 * z67 - z52 * z68 - z51 * z69 + z25 * z71);
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
    const Scalar z14 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z15 = n2_8467 * c_steer;
    const Scalar z16 = c_steer * z3;
    const Scalar z17 = n0_28 * c_steer;
    const Scalar z18 = n0_12 * s_roll;
    const Scalar z19 = n0_28 * z10;
    const Scalar z20 = n0_28 * z11;
    const Scalar z21 = z3 * z10;
    const Scalar z22 = z3 * z11;
    const Scalar z23 = z4 * z10 + z5 * z11;
    const Scalar z24 = n1_04 * z10 - n3_85 * z11;
    const Scalar z25 = n2_8467 * z10;
    const Scalar z26 = k3 * z10 + k4 * z11;
    const Scalar z27 = k4 * z10 + k5 * z11;
    const Scalar z28 = n2_8467 * z11;
    const Scalar z29 = s_pitch * z20 - c_pitch * z19;
    const Scalar z30 = s_pitch * z19 + c_pitch * z20;
    const Scalar z31 = s_pitch * z22 - c_pitch * z21;
    const Scalar z32 = s_pitch * z21 + c_pitch * z22;
    const Scalar z33 = k4 * z13;
    const Scalar z34 = z5 * z13 + z4 * z12;
    const Scalar z35 = z4 * z13 + z5 * z14;
    const Scalar z36 = n1_04 * z12 - n3_85 * z13;
    const Scalar z37 = n1_04 * z13 - n3_85 * z14;
    const Scalar z38 = k5 * z13 + k4 * z12;
    const Scalar z39 = k3 * z13 + k4 * z14;
    const Scalar z40 = k3 * z12 + z33;
    const Scalar z41 = k5 * z14 + z33;
    const Scalar z42 = n0_3 * z21 - z23 + n1_1 * z22;
    const Scalar z43 = z12 * z26 - z10 * z15 + z13 * z27;
    const Scalar z44 = c_steer * z15 + z10 * z26 + z11 * z27;
    const Scalar z45 = s_roll * z17 + c_roll * z30;
    const Scalar z46 = n0_3 * z16 - z34;
    const Scalar z47 = n1_1 * z16 - z35;
    const Scalar z48 = s_roll * z32 - c_roll * z16;
    const Scalar z49 = s_roll * z16 + c_roll * z32;
    const Scalar z50 = z10 * z25 + z12 * z40 + z13 * z38;
    const Scalar z51 = z11 * z28 + z13 * z39 + z14 * z41;
    const Scalar z52 = n9_1 + n0_6 * z37 - n2_2 * z36 + z44;
    const Scalar z53 = z10 * z28 + z12 * z39 + z13 * z41;
    const Scalar z54 = c_steer * z28 - z10 * z39 - z11 * z41;
    const Scalar z55 = n8_47 - n2_2 * z36 + z51;
    const Scalar z56 = n0_63 + n0_6 * z37 + z50;
    const Scalar z57 = n2_31 + n1_1 * z37 - n0_3 * z36 + z53;
    const Scalar z58 = n29_35 - z55;
    const Scalar z59 = n17_7 - z57;
    const Scalar z60 = n49_25 + z52;
    const Scalar z61 = n1_1 * z24 + z43;
    const Scalar z62 = n0_12 + z60;
    const Scalar z63 = n0_3 * z24 + z54;
    const Scalar z64 = z56 + z58;
    const Scalar z65 = n2 * z59;
    const Scalar z66 = n2_1 + z37;
    const Scalar z67 = n51 - z66;
    const Scalar z68 = s_pitch * z64 - c_pitch * z65;
    const Scalar z69 = n7_7 - z36;
    const Scalar z70 = n25_5 + z69;
    const Scalar z71 = n39_8603 - z62;
    const Scalar z72 = s_pitch * z61 - c_pitch * z63;
    const Scalar z73 = s_pitch * z46 + c_pitch * z47;
    const Scalar z74 = s_pitch * z68;
    const Scalar z75 = c_pitch * z68 + z59;
    const Scalar z76 = c_pitch * z67 + s_pitch * z70;
    const Scalar z77 = z58 - z74;
    const Scalar z78 = z56 - z74;
    const Scalar z79 = s_pitch * z67 - c_pitch * z70;
    const Scalar z80 = n39_8603 + z78;
    const Scalar z81 = s_roll * z79;
    const Scalar z82 = c_yaw * z31 + s_yaw * z48;
    const Scalar z83 = s_yaw * z31 - c_yaw * z48;
    const Scalar z84 = s_yaw * z76 + c_yaw * z81;
    const Scalar z85 = s_yaw * z81 - c_yaw * z76;
    const Scalar z86 = s_roll * z42 - c_roll * z73;
    const Scalar z87 = s_pitch * z47 - c_pitch * z46;
    const Scalar z88 = v_roll * s_roll;
    const Scalar z89 = v_yaw * c_yaw;
    const Scalar z90 = v_roll * c_roll;
    const Scalar z91 = v_yaw * s_yaw;
    const Scalar z92 = s_yaw * c_roll;
    const Scalar z93 = n1 - s_roll * s_roll;
    const Scalar z94 = s_roll * z92;
    const Scalar z95 = c_yaw * c_roll;
    const Scalar z96 = s_roll * z95;
    const Scalar z97 = s_yaw * s_roll;
    const Scalar z98 = n2 * s_roll;
    const Scalar z99 = c_yaw * s_roll;
    const Scalar z100 = s_yaw * z88 - c_roll * z89;
    const Scalar z101 = z93 * z93 + z94 * z94 + z96 * z96;
    const Scalar z102 = c_roll * z98;
    const Scalar z103 = s_roll * z97 - c_roll * z92;
    const Scalar z104 = c_yaw * z88 + c_roll * z91;
    const Scalar z105 = s_roll * z100 - z92 * z90;
    const Scalar z106 = traits::sqrt(z101);
    const Scalar z107 = s_roll * z99 - c_roll * z95;
    const Scalar z108 = z90 * z98;
    const Scalar z109 = n2 * (z93 * z102 + z94 * z103 + z96 * z107);
    const Scalar z110 = s_roll * z104 - z95 * z90;
    const Scalar z111 = n2 * (z93 * z108 + z94 * z105 + z96 * z110);
    const Scalar z112 = z77 - z71;
    const Scalar z113 = n2 * z72;
    const Scalar z114 = s_roll * z112 - c_roll * z113;
    const Scalar z115 = s_roll * z76 - c_roll * z24;
    const Scalar z116 = s_yaw * z79 - c_yaw * z115;
    const Scalar z117 = c_yaw * z79 + s_yaw * z115;
    const Scalar z118 = n0_3 / z106;
    const Scalar z119 = s_roll * z114;
    const Scalar z120 = n0_5 * z109 / z106;
    const Scalar z121 = n0_5 * z111 / z106;
    const Scalar z122 = s_roll * z62 - c_roll * z72;
    const Scalar z123 = z77 - z119;
    const Scalar z124 = s_roll * z24 + c_roll * z76;
    const Scalar z125 = n39_8603 - z123;
    const Scalar z126 = s_pitch * z63 + c_pitch * z61;
    const Scalar z127 = v_roll * z90;
    const Scalar z128 = v_yaw * z91;
    const Scalar z129 = n2 * z88;
    const Scalar z130 = c_roll * z79;
    const Scalar z131 = n0_08 * z12 - n0_35 * z13;
    const Scalar z132 = n1_1 - z131;
    const Scalar z133 = n0_08 * z13 - n0_35 * z14;
    const Scalar z134 = n0_08 * z10 - n0_35 * z11;
    const Scalar z135 = v_roll * z88;
    const Scalar z136 = v_yaw * z89;
    const Scalar z137 = n2 * z90;
    const Scalar z138 = q_x + z94 * z118;
    const Scalar z139 = s_yaw * z127 + c_roll * z128 + z89 * z129;
    const Scalar z140 = n0_3 * z120;
    const Scalar z141 = c_yaw * z127 + c_roll * z136 - z91 * z129;
    const Scalar z142 = z92 * z135 + z100 * z137 + s_roll * z139;
    const Scalar z143 = z95 * z135 + z104 * z137 + s_roll * z141;
    const Scalar z144 = q_z + z93 * z118;
    const Scalar z145 = n2 * (s_roll * z135 - z90 * z90);
    const Scalar z146 = q_y - z96 * z118;
    const Scalar z147 = n2 * (z94 * z142 + z96 * z143 - z93 * z145 - z105 * z105 - z110 * z110 - z108 * z108);
    const Scalar z148 = s_yaw * z124;
    const Scalar z149 = c_yaw * z124;
    const Scalar z150 = s_roll * z126 - c_roll * z75;
    const Scalar z151 = n0_3 + z133;
    const Scalar z152 = s_pitch * z10 + c_pitch * z11;
    const Scalar z153 = s_roll * z152;
    const Scalar z154 = s_pitch * z11 - c_pitch * z10;
    const Scalar z155 = s_roll * c_steer + c_roll * z152;
    const Scalar z156 = c_roll * c_steer - z153;
    const Scalar z157 = c_yaw * z154;
    const Scalar z158 = s_yaw * z154;
    const Scalar z159 = n1 - z155 * z155;
    const Scalar z160 = v_pitch * c_pitch;
    const Scalar z161 = s_yaw * z156 - z157;
    const Scalar z162 = c_yaw * z156 + z158;
    const Scalar z163 = v_pitch * s_pitch;
    const Scalar z164 = v_steer * c_steer;
    const Scalar z165 = v_steer * s_steer;
    const Scalar z166 = z2 * z164;
    const Scalar z167 = z155 * z161;
    const Scalar z168 = z155 * z162;
    const Scalar z169 = z1 * z164;
    const Scalar z170 = c_roll * z165;
    const Scalar z171 = z10 * z160 - z11 * z163 + s_pitch * z166 + c_pitch * z169;
    const Scalar z172 = z159 * z159 + z167 * z167 + z168 * z168;
    const Scalar z173 = z10 * z163 + z11 * z160 + s_pitch * z169 - c_pitch * z166;
    const Scalar z174 = traits::sqrt(z172);
    const Scalar z175 = s_pitch * z132 - c_pitch * z151;
    const Scalar z176 = c_steer * z88 + z170 + z90 * z152 + s_roll * z171;
    const Scalar z177 = n2 * z155;
    const Scalar z178 = s_pitch * z151 + c_pitch * z132;
    const Scalar z179 = s_roll * z134;
    const Scalar z180 = z89 * z154 - z91 * z156 + s_yaw * z173 - c_yaw * z176;
    const Scalar z181 = s_roll * z175 - c_roll * z134;
    const Scalar z182 = s_roll * z165 - c_steer * z90 + z88 * z152 - c_roll * z171;
    const Scalar z183 = c_roll * z175 + z179;
    const Scalar z184 = s_yaw * z178 + c_yaw * z181;
    const Scalar z185 = q_z - z183;
    const Scalar z186 = n0_35 / z174;
    const Scalar z187 = z155 * z180 - z162 * z182;
    const Scalar z188 = q_y + z184;
    const Scalar z189 = c_yaw * z173 - z91 * z154 - z89 * z156 + s_yaw * z176;
    const Scalar z190 = z161 * z182 + z155 * z189;
    const Scalar z191 = z8 * z165;
    const Scalar z192 = s_yaw * z181 - c_yaw * z178;
    const Scalar z193 = -z165 * (n1 - z9);
    const Scalar z194 = n0_08 * z191 + n0_35 * z193;
    const Scalar z195 = z185 + z159 * z186;
    const Scalar z196 = z188 - z168 * z186;
    const Scalar z197 = q_x - z192;
    const Scalar z198 = -z165 * (n1 - z7);
    const Scalar z199 = n0_35 * z191 + n0_08 * z198;
    const Scalar z200 = z197 + z167 * z186;
    const Scalar z201 = n0_08 * z166 - n0_35 * z169;
    const Scalar z202 = s_pitch * z199 - c_pitch * z194 - z132 * z160 - z151 * z163;
    const Scalar z203 = n0_5 * (z111 * z121 / (z106 * z106) + z147 / z106);
    const Scalar z204 = n0_3 * z203;
    const Scalar z205 = z2 * c_steer;
    const Scalar z206 = z1 * c_steer;
    const Scalar z207 = s_pitch * z205 + c_pitch * z206;
    const Scalar z208 = s_pitch * z206 - c_pitch * z205;
    const Scalar z209 = s_roll * z154;
    const Scalar z210 = s_yaw * z152 + c_yaw * z209;
    const Scalar z211 = c_roll * z154;
    const Scalar z212 = s_yaw * z155;
    const Scalar z213 = s_yaw * z209 - c_yaw * z152;
    const Scalar z214 = c_roll * s_steer + s_roll * z207;
    const Scalar z215 = s_roll * s_steer - c_roll * z207;
    const Scalar z216 = c_yaw * z208 + s_yaw * z214;
    const Scalar z217 = s_yaw * z208 - c_yaw * z214;
    const Scalar z218 = z177 * z211;
    const Scalar z219 = c_yaw * z155;
    const Scalar z220 = z156 * z161 - z155 * z212;
    const Scalar z221 = z155 * z210 - z162 * z211;
    const Scalar z222 = z155 * z216 + z161 * z215;
    const Scalar z223 = z156 * z162 - z155 * z219;
    const Scalar z224 = v_steer * z165;
    const Scalar z225 = z155 * z217 - z162 * z215;
    const Scalar z226 = z155 * z213 - z161 * z211;
    const Scalar z227 = z2 * z224;
    const Scalar z228 = z156 * z177;
    const Scalar z229 = z182 * z177;
    const Scalar z230 = z177 * z215;
    const Scalar z231 = z1 * z224;
    const Scalar z232 = n2 * (z159 * z218 + z168 * z221 + z167 * z226);
    const Scalar z233 = n2 * (z167 * z220 + z168 * z223 - z159 * z228);
    const Scalar z234 = n2 * (z167 * z222 - z168 * z225 - z159 * z230);
    const Scalar z235 = s_steer * z8;
    const Scalar z236 = s_steer * (n1 - z7);
    const Scalar z237 = n0_08 * z236 - n0_35 * z235;
    const Scalar z238 = s_steer * (n1 - z9);
    const Scalar z239 = n0_08 * z235 - n0_35 * z238;
    const Scalar z240 = n2 * (z167 * z190 - z168 * z187 - z159 * z229);
    const Scalar z241 = n0_5 * z232 / z174;
    const Scalar z242 = n0_5 * z233 / z174;
    const Scalar z243 = n0_5 * z234 / z174;
    const Scalar z244 = c_pitch * z239 + s_pitch * z237;
    const Scalar z245 = n0_08 * z205 - n0_35 * z206;
    const Scalar z246 = c_roll * z178;
    const Scalar z247 = s_roll * z245 + c_roll * z244;
    const Scalar z248 = n0_5 * z240 / z174;
    const Scalar z249 = z246 - n0_35 * z241;
    const Scalar z250 = z181 + n0_35 * z242;
    const Scalar z251 = z90 * z134 + s_roll * z201 - z88 * z175 - c_roll * z202;
    const Scalar z252 = v_steer * z164;
    const Scalar z253 = z247 + n0_35 * z243;
    const Scalar z254 = v_z - z251;
    const Scalar z255 = q_x - z138;
    const Scalar z256 = q_z - z144;
    const Scalar z257 = q_y - z146;
    const Scalar z258 = v_pitch * z163;
    const Scalar z259 = v_pitch * z160;
    const Scalar z260 = z10 * z258 + z11 * z259 + s_pitch * z227 + c_pitch * z231 - n2 * (z166 * z160 - z169 * z163);
    const Scalar z261 = z11 * z258 - z10 * z259 + s_pitch * z231 - c_pitch * z227 - n2 * (z166 * z163 + z169 * z160);
    const Scalar z262 = n0_08 * z227 - n0_35 * z231;
    const Scalar z263 = n2 * z182;
    const Scalar z264 = q_x - z200;
    const Scalar z265 = q_y - z196;
    const Scalar z266 = s_pitch * z1 - c_pitch * z2;
    const Scalar z267 = s_pitch * z2 + c_pitch * z1;
    const Scalar z268 = s_roll * z266;
    const Scalar z269 = s_roll * z252 + c_steer * z135 + z127 * z152 + n2 * (z90 * z165 + z88 * z171) + c_roll * z260;
    const Scalar z270 = z135 * z152 - c_roll * z252 - c_steer * z127 - n2 * (z90 * z171 - z88 * z165) + s_roll * z260;
    const Scalar z271 = z128 * z154 + z136 * z156 - n2 * (z89 * z173 + z91 * z176) + s_yaw * z261 - c_yaw * z270;
    const Scalar z272 = n2 * (z155 * z269 - z182 * z182);
    const Scalar z273 = z136 * z154 - z128 * z156 - n2 * (z89 * z176 - z91 * z173) + c_yaw * z261 + s_yaw * z270;
    const Scalar z274 = z180 * z263 + z162 * z269 + z155 * z271;
    const Scalar z275 = c_roll * z266;
    const Scalar z276 = z189 * z263 - z161 * z269 + z155 * z273;
    const Scalar z277 = q_z - z195;
    const Scalar z278 = s_yaw * z267 + c_yaw * z268;
    const Scalar z279 = z8 * z252;
    const Scalar z280 = n2 * (z229 * z229 + z187 * z187 + z190 * z190 + z159 * z272 - z168 * z274 + z167 * z276);
    const Scalar z281 = s_yaw * z277;
    const Scalar z282 = s_yaw * z268 - c_yaw * z267;
    const Scalar z283 = -z252 * (n1 - z7);
    const Scalar z284 = n0_35 * z279 + n0_08 * z283;
    const Scalar z285 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z286 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z287 = s_roll * z286;
    const Scalar z288 = z118 * z105;
    const Scalar z289 = c_yaw * z277;
    const Scalar z290 = -z252 * (n1 - z9);
    const Scalar z291 = n0_08 * z279 + n0_35 * z290;
    const Scalar z292 = s_yaw * z285 + c_yaw * z287;
    const Scalar z293 = c_roll * z286;
    const Scalar z294 = s_yaw * z287 - c_yaw * z285;
    const Scalar z295 = q_z - z293;
    const Scalar z296 = n0_3 * z121 / (z106 * z106);
    const Scalar z297 = s_roll * z264 + z92 * z277;
    const Scalar z298 = s_roll * z255 + z92 * z256;
    const Scalar z299 = s_roll * z265 - z95 * z277;
    const Scalar z300 = z240 * z248;
    const Scalar z301 = s_yaw * z256;
    const Scalar z302 = v_x - z288 + z94 * z296;
    const Scalar z303 = v_x - z302;
    const Scalar z304 = s_roll * z257 - z95 * z256;
    const Scalar z305 = z118 * z110;
    const Scalar z306 = c_yaw * z256;
    const Scalar z307 = v_y + z305 - z96 * z296;
    const Scalar z308 = v_z - z118 * z108 + z93 * z296;
    const Scalar z309 = v_z - z308;
    const Scalar z310 = s_pitch * z284 - z151 * z259 - c_pitch * z291 + z132 * z258 + n2 * (z160 * z199 + z163 * z194);
    const Scalar z311 = v_y - z307;
    const Scalar z312 = q_y + z292;
    const Scalar z313 = c_yaw * z309 - z91 * z256;
    const Scalar z314 = z92 * z309;
    const Scalar z315 = z90 * z255 - z100 * z256 + s_roll * z303 + z314;
    const Scalar z316 = z89 * z256 + s_yaw * z309;
    const Scalar z317 = z95 * z309;
    const Scalar z318 = z135 * z134 + s_roll * z262 + z127 * z175 - n2 * (z90 * z201 + z88 * z202) + c_roll * z310;
    const Scalar z319 = z185 - z195;
    const Scalar z320 = z195 - z295;
    const Scalar z321 = z188 - z196;
    const Scalar z322 = z196 - z312;
    const Scalar z323 = z197 - z200;
    const Scalar z324 = z162 * z319;
    const Scalar z325 = q_x - z294;
    const Scalar z326 = z200 - z325;
    const Scalar z327 = z155 * z321 - z324;
    const Scalar z328 = z282 * z320;
    const Scalar z329 = z278 * z320;
    const Scalar z330 = z275 * z322 + z329;
    const Scalar z331 = z275 * z326 - z328;
    const Scalar z332 = n0_5 * (z300 / (z174 * z174) - z280 / z174);
    const Scalar z333 = z318 - n0_35 * z332;
    const Scalar z334 = s_pitch * z194;
    const Scalar z335 = z161 * z319;
    const Scalar z336 = z155 * z323 + z335;
    const Scalar z337 = c_roll * z201;
    const Scalar z338 = z334 + c_pitch * z199 - z151 * z160 + z132 * z163;
    const Scalar z339 = z337 - z88 * z134 - z90 * z175 + s_roll * z202;
    const Scalar z340 = z1 * z160 + z2 * z163;
    const Scalar z341 = n0_35 * z248 / (z174 * z174);
    const Scalar z342 = z254 + z186 * z229 + z159 * z341;
    const Scalar z343 = z104 * z277;
    const Scalar z344 = z90 * z257 + z104 * z256 + s_roll * z311 - z317;
    const Scalar z345 = s_yaw * z338 - z89 * z178 + z91 * z181 + c_yaw * z339;
    const Scalar z346 = c_roll * z340 - z88 * z266;
    const Scalar z347 = v_z - z342;
    const Scalar z348 = z89 * z277 + s_yaw * z347;
    const Scalar z349 = v_yaw * z303 + z315 * (v_pitch + v_rear) - v_roll * z313;
    const Scalar z350 = v_yaw * z311 - v_roll * z316 + z344 * (v_pitch + v_rear);
    const Scalar z351 = z254 - z342;
    const Scalar z352 = v_yaw * s_roll;
    const Scalar z353 = v_yaw * c_roll;
    const Scalar z354 = v_pitch + z352;  // angular velocity of frame, y
    const Scalar z355 = v_roll * c_pitch - s_pitch * z353;
    const Scalar z356 = v_roll * s_pitch + c_pitch * z353;
    const Scalar z357 = z1 * z163 - z2 * z160;
    const Scalar z358 = z355 * z354;
    const Scalar z359 = z354 * z354;
    const Scalar z360 = z356 * z356;
    const Scalar z361 = z355 * z356;
    const Scalar z362 = z359 + z360;
    const Scalar z363 = v_y - z345;
    const Scalar z364 = z355 * z355;
    const Scalar z365 = z356 * z354;
    const Scalar z366 = n0_3 * z160 - n1_1 * z163;
    const Scalar z367 = v_rear + z354;  // angular velocity of rear_wheel, y
    const Scalar z368 = z90 * z266 + s_roll * z340;
    const Scalar z369 = n1_1 * z160 + n0_3 * z163;
    const Scalar z370 = s_yaw * z339 - c_yaw * z338 - z89 * z181 - z91 * z178;
    const Scalar z371 = s_yaw * z357 - z89 * z267 + z91 * z268 - c_yaw * z368;
    const Scalar z372 = z186 * z187 - z363 + z168 * z341;
    const Scalar z373 = z359 + z364;
    const Scalar z374 = z363 + z372;
    const Scalar z375 = z90 * z286 + s_roll * z369;
    const Scalar z376 = v_x + z370;
    const Scalar z377 = z89 * z285 + s_yaw * z366 - z91 * z287 + c_yaw * z375;
    const Scalar z378 = v_y + z377;
    const Scalar z379 = c_roll * z369 - z88 * z286;
    const Scalar z380 = z376 - z186 * z190 + z167 * z341;
    const Scalar z381 = z372 + z378;
    const Scalar z382 = v_y + z372;
    const Scalar z383 = z376 - z380;
    const Scalar z384 = z11 * z354 + z13 * z355 - z14 * z356;
    const Scalar z385 = z10 * z354 - z13 * z356 + z12 * z355;
    const Scalar z386 = z1 * v_steer;
    const Scalar z387 = c_steer * z354 - z10 * z355 + z11 * z356;
    const Scalar z388 = z1 * z384 + z2 * z385;
    const Scalar z389 = z91 * z285 - c_yaw * z366 + z89 * z287 + s_yaw * z375;
    const Scalar z390 = v_z - z379;
    const Scalar z391 = z342 - z390;
    const Scalar z392 = v_x - z380;
    const Scalar z393 = z91 * z267 + c_yaw * z357 + z89 * z268 + s_yaw * z368;
    const Scalar z394 = v_x - z389;
    const Scalar z395 = z380 - z394;
    const Scalar z396 = z100 * z277;
    const Scalar z397 = z320 * z371;
    const Scalar z398 = z320 * z393;
    const Scalar z399 = v_roll * z352;  // angular acceleration of frame.2, z
    const Scalar z400 = v_roll * z353;  // angular acceleration of frame.2, y
    const Scalar z401 = z189 * z319;
    const Scalar z402 = z180 * z319;
    const Scalar z403 = c_yaw * z347 - z91 * z277;
    const Scalar z404 = z90 * z265 + z343 + s_roll * z382 - z95 * z347;
    const Scalar z405 = z385 + z386;  // angular velocity of fork, x
    const Scalar z406 = z2 * v_steer;
    const Scalar z407 = z384 - z406;  // angular velocity of fork, z
    const Scalar z408 = v_front + z387;  // angular velocity of front_wheel, y
    const Scalar z409 = z387 * z387;
    const Scalar z410 = z405 * z405;
    const Scalar z411 = z387 * z405;
    const Scalar z412 = z409 + z410;
    const Scalar z413 = z407 * z407;
    const Scalar z414 = z405 * z407;
    const Scalar z415 = z387 * z407;
    const Scalar z416 = z407 * z408;
    const Scalar z417 = z405 * z408;
    const Scalar z418 = n0_28 * z417;  // moment on front_wheel, z
    const Scalar z419 = z409 + z413;
    const Scalar z420 = n0_28 * z416;  // moment on front_wheel, x
    const Scalar z421 = z90 * z264 - z396 + s_roll * z392 + z92 * z347;
    const Scalar z422 = z397 - z322 * z346 + z275 * z381 - z278 * z391;
    const Scalar z423 = z413 - z410;
    const Scalar z424 = z355 * z367;
    const Scalar z425 = z356 * z367;
    const Scalar z426 = n0_12 * z425;  // moment on rear_wheel, x
    const Scalar z427 = z326 * z346 - z398 + z275 * z395 - z282 * z391;
    const Scalar z428 = z155 * z374 - z402 - z182 * z321 - z162 * z351;
    const Scalar z429 = n0_12 * z424;  // moment on rear_wheel, z
    const Scalar z430 = z155 * z383 - z401 - z182 * z323 + z161 * z351;
    const Scalar z431 = v_yaw * z382 - v_roll * z348 + v_pitch * z404 - v_steer * z422 + v_front * z428;
    const Scalar z432 = a_yaw * c_roll;
    const Scalar z433 = v_roll * z352 - z432;  // angular acceleration of frame.2, z
    const Scalar z434 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z435 = a_yaw * s_roll;
    const Scalar z436 = v_roll * z353 + z435;  // angular acceleration of frame.2, y
    const Scalar z437 = n9_81 - a_z;
    const Scalar z438 = s_front * z407 + c_front * z405;
    const Scalar z439 = a_roll * s_pitch - c_pitch * z433;
    const Scalar z440 = s_front * z405 - c_front * z407;
    const Scalar z441 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z442 = s_roll * z434 - c_roll * z437;
    const Scalar z443 = a_roll * c_pitch + s_pitch * z433;
    const Scalar z444 = s_roll * z437 + c_roll * z434;
    const Scalar z445 = s_rear * z355 + c_rear * z356;
    const Scalar z446 = s_rear * z356 - c_rear * z355;
    const Scalar z447 = z360 - z364;
    const Scalar z448 = z352 * z353;
    const Scalar z449 = v_yaw * z392 - v_roll * z403 + v_pitch * z421 + v_steer * z427 + v_front * z430;
    const Scalar z450 = v_pitch * z355 + z439;  // angular acceleration of frame, z
    const Scalar z451 = v_pitch * z356 - z443;  // angular acceleration of frame, x
    const Scalar z452 = a_pitch + z436;  // angular acceleration of frame, y
    const Scalar z453 = z358 + z450;
    const Scalar z454 = s_pitch * z442 - c_pitch * z441;
    const Scalar z455 = s_pitch * z441 + c_pitch * z442;
    const Scalar z456 = z365 + z451;
    const Scalar z457 = z361 + z452;
    const Scalar z458 = z361 - z452;
    const Scalar z459 = c_steer * z452 + z10 * z451 + z11 * z450;
    const Scalar z460 = z444 - n1_1 * z453 - n0_3 * z456;
    const Scalar z461 = z408 * z438;
    const Scalar z462 = n0_28 * z461;  // moment on front_wheel, z
    const Scalar z463 = a_rear + z452;  // angular acceleration of rear_wheel, y
    const Scalar z464 = v_steer * z388 - z459;  // angular acceleration of fork, y
    const Scalar z465 = n0_12 * z463;  // moment on rear_wheel, y
    const Scalar z466 = z13 * z451 - z11 * z452 + z14 * z450;
    const Scalar z467 = z466 + z2 * a_steer - z387 * z386;  // angular acceleration of fork, z
    const Scalar z468 = n1_1 * z362 + z454 - n0_3 * z457;
    const Scalar z469 = n0_3 * z373 - z455 - n1_1 * z458;
    const Scalar z470 = z408 * z440;
    const Scalar z471 = n0_28 * z470;  // moment on front_wheel, x
    const Scalar z472 = z367 * z445;
    const Scalar z473 = n0_12 * z472;  // moment on rear_wheel, x
    const Scalar z474 = z12 * z451 - z10 * z452 + z13 * z450;
    const Scalar z475 = z1 * a_steer - z474 + z387 * z406;  // angular acceleration of fork, x
    const Scalar z476 = z414 + z464;
    const Scalar z477 = z367 * z446;
    const Scalar z478 = n0_12 * z477;  // moment on rear_wheel, z
    const Scalar z479 = a_front - z464;  // angular acceleration of front_wheel, y
    const Scalar z480 = n0_28 * z479;  // moment on front_wheel, y
    const Scalar z481 = z414 - z464;
    const Scalar z482 = s_front * z462 - c_front * z471;
    const Scalar z483 = s_front * z471 + c_front * z462;
    const Scalar z484 = z10 * z460 - z13 * z469 + z12 * z468;
    const Scalar z485 = c_steer * z460 - z10 * z468 + z11 * z469;
    const Scalar z486 = z11 * z460 - z14 * z469 + z13 * z468;
    // moment on fork, y
    const Scalar z487 = k31 * z414 + k4 * z423 + n2_5667 * z464 - z480 - n3_85 * z484 - n1_04 * z486;
    const Scalar z488 = z360 + z364;
    const Scalar z489 = z365 - z451;
    const Scalar z490 = z411 + z467;
    const Scalar z491 = z482 + k33 * z415 + k3 * z475 - n3_85 * z485 - k4 * z490;  // moment on fork, x
    const Scalar z492 = s_rear * z473 - c_rear * z478;
    const Scalar z493 = s_rear * z478 + c_rear * z473;
    const Scalar z494 = n1_04 * z419 + n3_85 * z476 - n7 * z484;  // force on fork, x
    const Scalar z495 = z415 + z475;
    const Scalar z496 = n2 * z354;
    const Scalar z497 = n2 * z445;
    const Scalar z498 = n2 * z446;
    const Scalar z499 = n2 * z367;
    const Scalar z500 = z1 * z486 + z2 * z484;
    const Scalar z501 = n3_85 * z412 + n1_04 * z481 + n7 * z486;  // force on fork, z
    const Scalar z502 = z483 + k35 * z411 + k5 * z467 + n1_04 * z485 - k4 * z495;  // moment on fork, z
    const Scalar z503 = z2 * z387;
    const Scalar z504 = z1 * z387;
    const Scalar z505 = z1 * z407 + z2 * z405;
    const Scalar z506 = n2 * z355;
    const Scalar z507 = z2 * z485;
    const Scalar z508 = n2 * z356;
    const Scalar z509 = n7 * z485 + n1_04 * z490 - n3_85 * z495;  // force on fork, y
    const Scalar z510 = z1 * z419 + z2 * z476;
    const Scalar z511 = z2 * z412 + z1 * z481;
    const Scalar z512 = n2 * z387;
    const Scalar z513 = n2 * z405;
    const Scalar z514 = z1 * z490 - z2 * z495;
    const Scalar z515 = z1 * z485;
    const Scalar z516 = z12 * z494 - z13 * z501 + z10 * z509;
    const Scalar z517 = n25_5 * z362 - z516 + n51 * z457;  // force on frame, x
    const Scalar z518 = n2 * z407;
    const Scalar z519 = c_steer * z487;
    const Scalar z520 = z352 * z352;
    const Scalar z521 = z353 * z353;
    const Scalar z522 = z520 + z521;
    const Scalar z523 = z358 - z450;
    const Scalar z524 = z11 * z501 - z10 * z494 + c_steer * z509;
    const Scalar z525 = z2 * z512;
    const Scalar z526 = z13 * z494 - z14 * z501 + z11 * z509;
    const Scalar z527 = n51 * z373 - z526 + n25_5 * z458;  // force on frame, z
    const Scalar z528 = z1 * z518 + z2 * z513;
    const Scalar z529 = z399 - z433;
    const Scalar z530 = z10 * z491 - z519 - z11 * z502;
    // moment on frame, y
    const Scalar z531 = z465 + n29_35 * z361 + n49_25 * z452 + n17_7 * z447 - n25_5 * z455 + n51 * z454 + n0_3 * z516
        + n1_1 * z526 + z530;
    const Scalar z532 = n39_8603 * (z400 - z436) + z531;  // moment on frame.2, y
    const Scalar z533 = z400 - z436;
    const Scalar z534 = z11 * z487 + z13 * z491 - z14 * z502;
    // moment on frame, z
    const Scalar z535 = z492 + n49_25 * z358 - n25_5 * z444 - n29_35 * z450 - n17_7 * z456 - n1_1 * z524 - z534;
    const Scalar z536 = z10 * z487 + z12 * z491 - z13 * z502;
    const Scalar z537 = z493 + n78_6 * z365 + n51 * z444 - n17_7 * z453 - n0_3 * z524 - z536;  // moment on frame, x
    const Scalar z538 = n2 * z438;
    const Scalar z539 = n2 * z440;
    const Scalar z540 = n0_14 * z538;
    const Scalar z541 = n0_14 * z539;
    const Scalar z542 = n2 * z408;
    const Scalar z543 = n0_14 * z542;
    const Scalar z544 = k4 * z512;
    const Scalar z545 = n3_85 * z512;
    const Scalar z546 = s_front * z540 - c_front * z541;
    const Scalar z547 = s_front * z541 + c_front * z540;
    const Scalar z548 = n3_85 * z513 + n1_04 * z518;
    const Scalar z549 = z1 * z512;
    const Scalar z550 = n2 * z353;
    const Scalar z551 = n2 * z352;
    const Scalar z552 = n25_5 * z453 - z524 - n51 * z456;  // force on frame, y
    const Scalar z553 = n1_04 * z512;
    const Scalar z554 = n0_1435 * z518 - z546;
    const Scalar z555 = z546 + k4 * z513 + k39 * z518;
    const Scalar z556 = z547 + k40 * z513 + k4 * z518;
    const Scalar z557 = k40 * z512 + z543;
    const Scalar z558 = s_pitch * z517 + c_pitch * z527;
    const Scalar z559 = n2 * v_roll;
    const Scalar z560 = s_pitch * z537 + c_pitch * z535;
    const Scalar z561 = n79_7206 * z399 - z560;  // moment on frame.2, z
    const Scalar z562 = s_pitch * z527 - c_pitch * z517;
    const Scalar z563 = k39 * z512 + z543;
    const Scalar z564 = n0_1435 * z513 - z547;
    const Scalar z565 = n0_3 * z496;
    const Scalar z566 = n1_1 * z496;
    const Scalar z567 = n0_3 * z506 - n1_1 * z508;
    const Scalar z568 = s_roll * z558 - c_roll * z552;
    const Scalar z569 = z12 * z545 + z13 * z553 + z10 * z548;
    const Scalar z570 = s_roll * z552 + c_roll * z558;
    const Scalar z571 = n87 * z437 - z570;  // force on frame.z, z
    const Scalar z572 = c_steer * z548 - z10 * z545 - z11 * z553;
    const Scalar z573 = c_yaw * z562 + s_yaw * z568;
    const Scalar z574 = n87 * a_x + z573;  // force on frame.z, x
    const Scalar z575 = z13 * z545 + z14 * z553 + z11 * z548;
    const Scalar z576 = s_yaw * z562 - c_yaw * z568;
    const Scalar z577 = n7 * z565 - z569;
    const Scalar z578 = n7 * z567 - z572;
    const Scalar z579 = n87 * a_y + z576;  // force on frame.z, y
    const Scalar z580 = n7 * z566 - z575;
    const Scalar z581 = n0_06 * z497;
    const Scalar z582 = n0_06 * z498;
    const Scalar z583 = n0_06 * z499;
    const Scalar z584 = z13 * z544;
    const Scalar z585 = z12 * z544 + z13 * z563 + z10 * z555;
    const Scalar z586 = z584 + z14 * z563 + z11 * z555;
    const Scalar z587 = z584 + z12 * z557 + z10 * z556;
    const Scalar z588 = z12 * z554 - z13 * z564;
    const Scalar z589 = z13 * z554 - z14 * z564;
    const Scalar z590 = z10 * z554 - z11 * z564;
    const Scalar z591 = c_steer * z555 - z10 * z544 - z11 * z563;
    const Scalar z592 = z14 * z544 + z13 * z557 + z11 * z556;
    const Scalar z593 = c_steer * z556 - z10 * z557 - z11 * z544;
    const Scalar z594 = z13 * z585 - z11 * z588 - z14 * z587;
    const Scalar z595 = z37 * z565 - z594 + n0_3 * z577;
    const Scalar z596 = z12 * z586 - z10 * z589 - z13 * z592;
    const Scalar z597 = z36 * z566 - z596 - n1_1 * z580;
    const Scalar z598 = z12 * z585 - z10 * z588 - z13 * z587;
    const Scalar z599 = c_steer * z588 + z10 * z585 - z11 * z587;
    const Scalar z600 = z36 * z565 - z598 - n1_1 * z577;
    const Scalar z601 = z595 + z583;
    const Scalar z602 = z597 - z583;
    const Scalar z603 = n51 * z496 - z577;
    const Scalar z604 = z24 * z565 - z599;
    const Scalar z605 = n39_3 * z496 + z601;
    const Scalar z606 = n9_95 * z496 - z602;
    const Scalar z607 = z13 * z586 - z11 * z589 - z14 * z592;
    const Scalar z608 = c_steer * z589 + z10 * z586 - z11 * z592;
    const Scalar z609 = z37 * z566 - z607 + n0_3 * z580;
    const Scalar z610 = n25_5 * z496 + z580;
    const Scalar z611 = n17_7 * z496;
    const Scalar z612 = z600 + z611;
    const Scalar z613 = z24 * z566 - z608;
    const Scalar z614 = z11 * z590 + z13 * z591 - z14 * z593;
    const Scalar z615 = z37 * z567 - z614 + n0_3 * z578;
    const Scalar z616 = z609 - z611;
    const Scalar z617 = z10 * z590 + z12 * z591 - z13 * z593;
    const Scalar z618 = c_steer * z590 - z10 * z591 + z11 * z593;
    const Scalar z619 = z36 * z567 - z617 - n1_1 * z578;
    const Scalar z620 = n51 * z506 - z578 + n25_5 * z508;
    const Scalar z621 = z24 * z567 + z618;
    const Scalar z622 = n7 * z441 - z562;
    const Scalar z623 = n7 * z434 - z568;
    const Scalar z624 = z124 * z441;
    const Scalar z625 = s_rear * z581 - c_rear * z582;
    const Scalar z626 = s_rear * z582 + c_rear * z581;
    const Scalar z627 = z615 + z625;
    const Scalar z628 = z604 - z626;
    const Scalar z629 = z619 + z626;
    const Scalar z630 = z613 - z625;
    const Scalar z631 = n39_3 * z506 - z630;
    const Scalar z632 = n39_3 * z508 - z628;
    const Scalar z633 = z627 + n39_3 * z506 + n17_7 * z508;
    const Scalar z634 = z629 + n17_7 * z506 + n9_95 * z508;
    const Scalar z635 = z612 - z616;
    const Scalar z636 = s_pitch * z610 + c_pitch * z603;
    const Scalar z637 = z24 * z522 + z79 * z529 + z353 * z636 + n7 * z444 + z552;
    const Scalar z638 = z76 * z522 + z79 * z533 - z352 * z636 - n7 * z442 + z558;
    const Scalar z639 = z605 - z606;
    const Scalar z640 = s_pitch * z635 + c_pitch * z639;
    const Scalar z641 = s_pitch * z603 - c_pitch * z610;
    const Scalar z642 = z79 * z550 + z620;
    const Scalar z643 = z79 * z444;
    const Scalar z644 = s_pitch * z640;
    const Scalar z645 = z79 * z551 - z641;
    const Scalar z646 = s_pitch * z631 - c_pitch * z632;
    const Scalar z647 = n39_8603 * z550 + z646;
    const Scalar z648 = s_pitch * z632 + c_pitch * z631;
    const Scalar z649 = n39_8603 * z559 - z648;
    const Scalar z650 = z616 + z644;
    const Scalar z651 = z612 - z644;
    const Scalar z652 = s_pitch * z633 - c_pitch * z634;
    const Scalar z653 = s_roll * z642 - c_roll * z645;
    const Scalar z654 = s_roll * z645 + c_roll * z642;
    const Scalar z655 = s_pitch * z634 + c_pitch * z633;
    const Scalar z656 = z61 * z523 + z63 * z489 + z70 * z454 + z67 * z455 - z62 * z488 + z355 * z633 + z356 * z634;
    const Scalar z657 = z24 * z489 + z67 * z488 - n7 * z455 - z355 * z620 + z527;
    const Scalar z658 = z24 * z523 - z70 * z488 + n7 * z454 + z356 * z620 - z517;
    const Scalar z659 = z76 * z434 + z81 * z441;
    const Scalar z660 = z70 * z489 + z67 * z523 - z355 * z603 - z356 * z610;
    const Scalar z661 = s_roll * z641 - c_roll * z620;
    const Scalar z662 = z24 * z533 - z76 * z529 + z353 * z641 + z352 * z620;
    const Scalar z663 = z621 + z650;
    const Scalar z664 = z612 + z616;
    const Scalar z665 = z621 - z616;
    const Scalar z666 = z621 - z612;
    const Scalar z667 = c_pitch * z640 - z605;
    const Scalar z668 = z535 + z24 * z454 + z56 * z523 - z61 * z488 + z59 * z489 - z356 * z665 - z355 * z605;
    const Scalar z669 = c_pitch * z640 + z606;
    const Scalar z670 = z24 * z455 - z537 + z63 * z488 - z59 * z523 + z58 * z489 - z355 * z666 + z356 * z606;
    const Scalar z671 = z664 + z61 * z508 - z63 * z506;
    const Scalar z672 = n39_8603 * z551 + z667;
    const Scalar z673 = z672 + z72 * z550 - z77 * z551;
    const Scalar z674 = s_pitch * z658 - c_pitch * z657;
    const Scalar z675 = z24 * z551 + z76 * z550;
    const Scalar z676 = z24 * z444 - z76 * z442 - z126 * z529 + z75 * z533 + z80 * z522 - z353 * z647 - z352 * z669;
    const Scalar z677 = s_roll * z647 - c_roll * z669;
    const Scalar z678 = n39_8603 * z550 + z652;
    const Scalar z679 = s_pitch * z657 + c_pitch * z658;
    const Scalar z680 = z678 + z72 * z551 - z71 * z550;
    const Scalar z681 = z652 + z62 * z550 + z72 * z551;
    const Scalar z682 = z655 - z649;
    const Scalar z683 = s_roll * z663 - c_roll * z682;
    const Scalar z684 = s_roll * z637 + c_roll * z638;
    const Scalar z685 = s_roll * z638 - c_roll * z637;
    const Scalar z686 = s_roll * z680 - c_roll * z673;
    const Scalar z687 = s_roll * z683;
    const Scalar z688 = z24 * z506 - z610;
    const Scalar z689 = z621 - z687;
    const Scalar z690 = z70 * z506 - z67 * z508;
    const Scalar z691 = c_roll * z660 + s_roll * z679;
    const Scalar z692 = s_roll * z660 - c_roll * z679;
    const Scalar z693 = z651 - z689;
    const Scalar z694 = s_yaw * z653 - c_yaw * z675;
    const Scalar z695 = s_yaw * z675 + c_yaw * z653;
    const Scalar z696 = s_yaw * z661 - c_yaw * z636;
    const Scalar z697 = z24 * z508 + z603;
    const Scalar z698 = s_yaw * z636 + c_yaw * z661;
    const Scalar z699 = z632 + z56 * z508 - z59 * z506;
    const Scalar z700 = z59 * z508 - z631 + z58 * z506;
    const Scalar z701 = s_yaw * z662 - c_yaw * z684;
    const Scalar z702 = c_yaw * z662 + s_yaw * z684;
    const Scalar z703 = s_roll * z664 - c_roll * z655;
    const Scalar z704 = z643 + z62 * z529 - z126 * z522 - z72 * z533 - z353 * z664 - z352 * z655;
    const Scalar z705 = s_yaw * z674 - c_yaw * z691;
    const Scalar z706 = c_yaw * z674 + s_yaw * z691;
    const Scalar z707 = z621 - z651;
    const Scalar z708 = z79 * z442 - z532 + z72 * z529 - z75 * z522 + z77 * z533 + z353 * z649 + z352 * z707;
    const Scalar z709 = z650 + z651;
    const Scalar z710 = z126 * z522 - z643 + z72 * z533 + z71 * z529 - z561 + z352 * z655 + z353 * z709;
    const Scalar z711 = z621 - z650;
    const Scalar z712 = c_roll * z708 + s_roll * z710;
    const Scalar z713 = z711 + z126 * z550 + z75 * z551;
    const Scalar z714 = z79 * z441 + z115 * z434;
    const Scalar z715 = s_pitch * z688 - c_pitch * z697;
    const Scalar z716 = s_pitch * z697 + c_pitch * z688;
    const Scalar z717 = s_yaw * z622 - c_yaw * z623;
    const Scalar z718 = c_yaw * z622 + s_yaw * z623;
    const Scalar z719 = z31 * z434 - z48 * z441;
    const Scalar z720 = z503 * z553 - z504 * z545 + n3_85 * z510 - n1_04 * z511 + z1 * z501 - z2 * z494 - n7 * z500;
    const Scalar z721 = z504 * z556 - n3_85 * z507 - n1_04 * z515 - n2_8467 * z514 - z503 * z555 + z1 * z502 - z2
        * z491;
    const Scalar z722 = z504 * z548 - z505 * z553 - n7 * z507 - n3_85 * z514 + z2 * z509;
    const Scalar z723 = z505 * z545 - z503 * z548 - n7 * z515 - n1_04 * z514 + z1 * z509;
    const Scalar z724 = z1 * z544;
    const Scalar z725 = z2 * z544;
    const Scalar z726 = z2 * z563 - z724;
    const Scalar z727 = z1 * z557 - z725;
    const Scalar z728 = z1 * z554 + z2 * z564;
    const Scalar z729 = z504 * z544 - z503 * z563 - k4 * z510 + k5 * z511 - z505 * z564 + n1_04 * z500 + z1 * z487;
    const Scalar z730 = z504 * z557 - z503 * z544 - k3 * z510 + k4 * z511 + z505 * z554 + n3_85 * z500 + z2 * z487;
    const Scalar z731 = z503 * z726 + z504 * z727 - z4 * z510 + z5 * z511 + z3 * z500 + z505 * z728;
    const Scalar z732 = z13 * z726 + z14 * z727 + z11 * z728;
    const Scalar z733 = z732 + z21 * z567 - z16 * z565;
    const Scalar z734 = z12 * z726 + z13 * z727 + z10 * z728;
    const Scalar z735 = c_steer * z728 - z10 * z726 - z11 * z727;
    const Scalar z736 = z734 + z16 * z566 - z22 * z567;
    const Scalar z737 = z21 * z566 - z735 - z22 * z565;
    const Scalar z738 = z12 * z722 + z10 * z720 + z13 * z723;
    const Scalar z739 = z21 * z455 - z22 * z454 - z46 * z523 + z42 * z488 + z47 * z489 - z355 * z733 - z356 * z736;
    const Scalar z740 = z737 + z46 * z508 + z47 * z506;
    const Scalar z741 = z13 * z722 + z11 * z720 + z14 * z723;
    const Scalar z742 = c_steer * z720 - z10 * z722 - z11 * z723;
    const Scalar z743 = s_pitch * z733 - c_pitch * z736;
    const Scalar z744 = s_pitch * z736 + c_pitch * z733;
    const Scalar z745 = z16 * z442 - z42 * z529 + z32 * z444 - z87 * z522 + z73 * z533 + z352 * z744 + z353 * z737;
    const Scalar z746 = z743 + z42 * z550 + z73 * z551;
    const Scalar z747 = s_roll * z737 - c_roll * z744;
    const Scalar z748 = c_roll * z690 + s_roll * z715;
    const Scalar z749 = s_roll * z690 - c_roll * z715;
    const Scalar z750 = s_yaw * z716 + c_yaw * z748;
    const Scalar z751 = s_yaw * z748 - c_yaw * z716;
    const Scalar z752 = z13 * z729 + z12 * z730 + z10 * z721;
    const Scalar z753 = n0_3 * z742 + z752;
    const Scalar z754 = c_steer * z721 - z10 * z730 - z11 * z729;
    const Scalar z755 = z14 * z729 + z13 * z730 + z11 * z721;
    const Scalar z756 = n0_3 * z738 - z754 + n1_1 * z741;
    const Scalar z757 = s_pitch * z626 + c_pitch * z625;
    const Scalar z758 = s_pitch * z625 - c_pitch * z626;
    const Scalar z759 = s_pitch * z699 - c_pitch * z700;
    const Scalar z760 = s_pitch * z700 + c_pitch * z699;
    const Scalar z761 = s_roll * z671 - c_roll * z759;
    const Scalar z762 = z352 * z757 - n0_12 * z529;
    const Scalar z763 = c_roll * z757;
    const Scalar z764 = s_pitch * z668 + c_pitch * z670;
    const Scalar z765 = s_pitch * z670 - c_pitch * z668;
    const Scalar z766 = n1_1 * z742 + z755;
    const Scalar z767 = s_roll * z656 - c_roll * z764;
    const Scalar z768 = z1 * z553 + z2 * z545 - n3_85 * z525 - n1_04 * z549;
    const Scalar z769 = z724 - k3 * z525 - k4 * z549 + z2 * z557;
    const Scalar z770 = z725 - k4 * z525 - k5 * z549 + z1 * z563;
    const Scalar z771 = z1 * z555 + z2 * z556 - n2_8467 * z528;
    const Scalar z772 = z2 * z548 - n3_85 * z528;
    const Scalar z773 = z1 * z548 - n1_04 * z528;
    const Scalar z774 = z12 * z772 - z10 * z768 + z13 * z773;
    const Scalar z775 = z13 * z772 - z11 * z768 + z14 * z773;
    const Scalar z776 = z10 * z772 + z11 * z773 + c_steer * z768;
    const Scalar z777 = s_pitch * z738 + c_pitch * z741;
    const Scalar z778 = s_pitch * z741 - c_pitch * z738;
    const Scalar z779 = z12 * z769 + z13 * z770 + z10 * z771;
    const Scalar z780 = n0_3 * z776 - z779;
    const Scalar z781 = s_roll * z777 - c_roll * z742;
    const Scalar z782 = s_roll * z742 + c_roll * z777;
    const Scalar z783 = z13 * z769 + z14 * z770 + z11 * z771;
    const Scalar z784 = c_steer * z771 - z10 * z769 - z11 * z770;
    const Scalar z785 = n0_3 * z774 - z784 + n1_1 * z775;
    const Scalar z786 = s_yaw * z778 - c_yaw * z781;
    const Scalar z787 = c_yaw * z778 + s_yaw * z781;
    const Scalar z788 = s_pitch * z753 + c_pitch * z766;
    const Scalar z789 = s_pitch * z766 - c_pitch * z753;
    const Scalar z790 = s_roll * z756 - c_roll * z788;
    const Scalar z791 = n0_12 * z550 + z758;
    const Scalar z792 = z503 * z546 - z504 * z547 + n0_28 * z514;
    const Scalar z793 = n1_1 * z776 - z783;
    const Scalar z794 = c_yaw * z183;
    const Scalar z795 = s_yaw * z183;
    const Scalar z796 = n0_35 * z242 / (z174 * z174);
    const Scalar z797 = z794 - z186 * z223 + z168 * z796;
    const Scalar z798 = z140 / (z106 * z106);
    const Scalar z799 = z795 - z186 * z220 + z167 * z796;
    const Scalar z800 = z184 - z168 * z186;
    const Scalar z801 = z292 - z800;
    const Scalar z802 = z184 - z800;
    const Scalar z803 = z94 * z798 - z118 * z103;
    const Scalar z804 = z192 - z167 * z186;
    const Scalar z805 = z294 - z804;
    const Scalar z806 = z275 * z801 - z329;
    const Scalar z807 = z192 - z804;
    const Scalar z808 = z155 * z802 - z324;
    const Scalar z809 = z275 * z805 - z328;
    const Scalar z810 = z155 * z807 - z335;
    const Scalar z811 = s_roll * z800 + z95 * z277;
    const Scalar z812 = z96 * z118;
    const Scalar z813 = s_roll * z804 + z92 * z277;
    const Scalar z814 = z96 * z798 - z118 * z107;
    const Scalar z815 = z94 * z118;
    const Scalar z816 = s_roll * z812 - z95 * z256;
    const Scalar z817 = s_roll * z815 - z92 * z256;
    const Scalar z818 = z12 * z546 - z13 * z547;
    const Scalar z819 = s_pitch * z774 + c_pitch * z775;
    const Scalar z820 = s_pitch * z775 - c_pitch * z774;
    const Scalar z821 = n2 * (c_roll * z97 + z94);
    const Scalar z822 = n2 * (c_roll * z99 + z96);
    const Scalar z823 = z10 * z546 - z11 * z547;
    const Scalar z824 = z823 + z19 * z508 + z20 * z506;
    const Scalar z825 = z13 * z546 - z14 * z547;
    const Scalar z826 = z19 * z523 + z17 * z488 - z20 * z489 + z355 * z825 + z356 * z818;
    const Scalar z827 = z1 * z546;
    const Scalar z828 = z827 + z2 * z547 - n0_28 * z528;
    const Scalar z829 = z2 * z547 + z827;
    const Scalar z830 = l_lambda_rear_rolls_x * z817;
    const Scalar z831 = c_roll * z776 + s_roll * z819;
    const Scalar z832 = s_roll * z776 - c_roll * z819;
    const Scalar z833 = s_pitch * z818 + c_pitch * z825;
    const Scalar z834 = z17 * z529 - z29 * z522 + z30 * z533 + z353 * z823 + z352 * z833;
    const Scalar z835 = s_pitch * z825 - c_pitch * z818;
    const Scalar z836 = z17 * z550 - z835 - z30 * z551;
    const Scalar z837 = s_roll * z823 - c_roll * z833;
    const Scalar z838 = s_yaw * z820 - c_yaw * z831;
    const Scalar z839 = c_yaw * z820 + s_yaw * z831;
    const Scalar z840 = s_pitch * z780 + c_pitch * z793;
    const Scalar z841 = s_pitch * z793 - c_pitch * z780;
    const Scalar z842 = c_roll * z840 + s_roll * z785;
    const Scalar z843 = n2 * (z156 * z156 - z155 * z155);
    const Scalar z844 = s_yaw * z211;
    const Scalar z845 = z155 * z844 + z212 * z211 + z156 * z213 + z161 * z209;
    const Scalar z846 = c_yaw * z211;
    const Scalar z847 = s_roll * z178;
    const Scalar z848 = s_yaw * z156;
    const Scalar z849 = n2 * z156;
    const Scalar z850 = z212 * z849 + z155 * (z161 + z848);
    const Scalar z851 = c_yaw * z156;
    const Scalar z852 = z219 * z849 + z155 * (z162 + z851);
    const Scalar z853 = z181 - z186 * z228 - z159 * z796;
    const Scalar z854 = s_yaw * z853;
    const Scalar z855 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z856 = n2 * (z94 * z821 + z96 * z822 - z93 * z855 - z103 * z103 - z107 * z107 - z102 * z102);
    const Scalar z857 = n2 * (z159 * z843 - z228 * z228 - z220 * z220 - z223 * z223 + z167 * z850 + z168 * z852);
    const Scalar z858 = n0_5 * (z233 * z242 / (z174 * z174) + z857 / z174);
    const Scalar z859 = c_yaw * z853;
    const Scalar z860 = z93 * z798 - z118 * z102;
    const Scalar z861 = c_yaw * z860;
    const Scalar z862 = s_yaw * z860;
    const Scalar z863 = l_lambda_rear_rolls_x * z306 - l_lambda_rear_rolls_y * z301 + l_lambda_front_rolls_x * z289
        - l_lambda_front_rolls_y * z281;
    const Scalar z864 = z624 - z863;
    const Scalar z865 = n0_5 * (z109 * z120 / (z106 * z106) + z856 / z106);
    const Scalar z866 = l_lambda_front_rolls_x * z813 - z830 - l_lambda_rear_rolls_y * z816 + l_lambda_front_rolls_y
        * z811;
    const Scalar z867 = z659 - z866;
    const Scalar z868 = l_lambda_rear_rolls_y * z816 + z830;
    const Scalar z869 = l_lambda_front_rolls_x * z809 + l_lambda_front_rolls_y * z806;
    const Scalar z870 = z719 + z869;
    const Scalar z871 = z183 - n0_35 * z858;
    const Scalar z872 = l_lambda_rear_rolls_x * z814 - l_lambda_rear_rolls_y * z803 - l_lambda_front_rolls_x * z797
        + l_lambda_front_rolls_y * z799;
    const Scalar z873 = z712 + z872;
    const Scalar z874 = l_lambda_front_rolls_x * z810 + l_lambda_front_rolls_y * z808;
    const Scalar z875 = n0_3 * z865;
    const Scalar z876 = l_lambda_rear_rolls_x * z815 + l_lambda_rear_rolls_y * z812 - l_lambda_front_rolls_x * z804
        - l_lambda_front_rolls_y * z800;
    const Scalar z877 = z714 + z876;
    const Scalar z878 = z155 * z846 + z156 * z210 + z219 * z211 + z162 * z209;
    const Scalar z879 = z287 - z853;
    const Scalar z880 = z794 - z797;
    const Scalar z881 = z181 - z853;
    const Scalar z882 = z795 - z799;
    const Scalar z883 = n2 * (z156 * z211 - z155 * z209);
    const Scalar z884 = n2 * (z159 * z883 - z228 * z218 + z220 * z226 + z223 * z221 + z167 * z845 + z168 * z878);
    const Scalar z885 = c_yaw * z215;
    const Scalar z886 = z155 * z885 + z219 * z215 + z156 * z217 - z162 * z214;
    const Scalar z887 = n2 * (z155 * z214 + z156 * z215);
    const Scalar z888 = s_roll * z244 - c_roll * z245;
    const Scalar z889 = s_yaw * z215;
    const Scalar z890 = z156 * z216 - z155 * z889 + z161 * z214 - z212 * z215;
    const Scalar z891 = n0_35 * z241 / (z174 * z174);
    const Scalar z892 = s_yaw * z175 - c_yaw * z847;
    const Scalar z893 = s_yaw * z847 + c_yaw * z175;
    const Scalar z894 = c_yaw * z275;
    const Scalar z895 = c_yaw * z293;
    const Scalar z896 = z797 - z895;
    const Scalar z897 = s_yaw * z275;
    const Scalar z898 = z168 * z891 - z892 - z186 * z221;
    const Scalar z899 = n2 * (z228 * z230 - z159 * z887 + z220 * z222 - z223 * z225 - z168 * z886 + z167 * z890);
    const Scalar z900 = z246 - z186 * z218 + z159 * z891;
    const Scalar z901 = s_yaw * z293;
    const Scalar z902 = z799 - z901;
    const Scalar z903 = z893 - z186 * z226 + z167 * z891;
    const Scalar z904 = s_yaw * z900;
    const Scalar z905 = c_yaw * z900;
    const Scalar z906 = z268 * z322 - z320 * z894 - z275 * z896 + z278 * z879;
    const Scalar z907 = c_roll * z264 - z97 * z277 + s_roll * z799 - z92 * z853;
    const Scalar z908 = z156 * z321 + z219 * z319 + z155 * z880 - z162 * z881;
    const Scalar z909 = z97 * z256 - c_roll * z255 + s_roll * z803 + z92 * z860;
    const Scalar z910 = z268 * z326 + z320 * z897 + z275 * z902 - z282 * z879;
    const Scalar z911 = s_roll * z797 - c_roll * z265 - z95 * z853 - z99 * z277;
    const Scalar z912 = z156 * z323 - z212 * z319 - z155 * z882 + z161 * z881;
    const Scalar z913 = c_roll * z257 + z99 * z256 + s_roll * z814 + z95 * z860;
    const Scalar z914 = n0_5 * (z233 * z241 / (z174 * z174) - z884 / z174);
    const Scalar z915 = n0_5 * (z242 * z232 / (z174 * z174) - z884 / z174);
    const Scalar z916 = z847 - n0_35 * z914;
    const Scalar z917 = z847 - n0_35 * z915;
    const Scalar z918 = n0_5 * (z242 * z234 / (z174 * z174) - z899 / z174);
    const Scalar z919 = z888 + n0_35 * z918;
    const Scalar z920 = l_lambda_rear_rolls_x * z913;
    const Scalar z921 = l_lambda_front_rolls_x * z908 + l_lambda_front_rolls_y * z912;
    const Scalar z922 = z834 - z921;
    const Scalar z923 = l_lambda_rear_rolls_y * z909 - z920;
    const Scalar z924 = l_lambda_rear_rolls_y * z909 - z920 + l_lambda_front_touches * z917 - l_lambda_front_rolls_y
        * z907 + l_lambda_front_rolls_x * z911;
    const Scalar z925 = z762 - z923;
    const Scalar z926 = l_lambda_front_touches * z919 + l_lambda_front_rolls_x * z906 + l_lambda_front_rolls_y * z910;
    const Scalar z927 = l_lambda_front_rolls_x * z898 - l_lambda_front_rolls_y * z903;
    const Scalar z928 = z767 + z927;
    const Scalar z929 = l_lambda_rear_touches * z875 + l_lambda_rear_rolls_x * z862 + l_lambda_rear_rolls_y * z861
        + l_lambda_front_rolls_x * z854 + l_lambda_front_rolls_y * z859 - l_lambda_front_touches * z871;
    const Scalar z930 = z745 + z926;
    const Scalar z931 = z704 + z924;
    const Scalar z932 = z676 + z929;
    const Scalar z933 = s_yaw * z153 + z157;
    const Scalar z934 = c_yaw * z153 - z158;
    const Scalar z935 = z246 - z900;
    const Scalar z936 = z893 - z903;
    const Scalar z937 = z892 + z898;
    const Scalar z938 = n0_5 * (z233 * z243 / (z174 * z174) - z899 / z174);
    const Scalar z939 = z888 + n0_35 * z938;
    const Scalar z940 = c_roll * z152;
    const Scalar z941 = c_roll * z208;
    const Scalar z942 = s_roll * z208;
    const Scalar z943 = n2 * (z155 * z940 - z211 * z211);
    const Scalar z944 = s_pitch * z239 - c_pitch * z237;
    const Scalar z945 = s_yaw * z207 + c_yaw * z942;
    const Scalar z946 = s_yaw * z942 - c_yaw * z207;
    const Scalar z947 = z155 * z945 - z210 * z215 - z211 * z217 - z162 * z941;
    const Scalar z948 = z211 * z216 + z155 * z946 - z213 * z215 - z161 * z941;
    const Scalar z949 = n2 * (z155 * z941 - z211 * z215);
    const Scalar z950 = n2 * z211;
    const Scalar z951 = z155 * z933 - z213 * z950 - z161 * z940;
    const Scalar z952 = z155 * z934 - z210 * z950 - z162 * z940;
    const Scalar z953 = n2 * (z218 * z230 + z159 * z949 + z221 * z225 - z226 * z222 + z168 * z947 + z167 * z948);
    const Scalar z954 = n2 * (z218 * z218 + z159 * z943 + z221 * z221 + z226 * z226 + z167 * z951 + z168 * z952);
    const Scalar z955 = s_yaw * z944 - c_yaw * z888;
    const Scalar z956 = s_roll * z267;
    const Scalar z957 = n0_5 * (z232 * z241 / (z174 * z174) - z954 / z174);
    const Scalar z958 = c_yaw * z944 + s_yaw * z888;
    const Scalar z959 = n0_35 * z243 / (z174 * z174);
    const Scalar z960 = c_roll * z267;
    const Scalar z961 = s_roll * z285;
    const Scalar z962 = c_yaw * z266 + s_yaw * z956;
    const Scalar z963 = s_yaw * z266 - c_yaw * z956;
    const Scalar z964 = c_roll * z285;
    const Scalar z965 = z900 - z964;
    const Scalar z966 = z955 + z186 * z225 + z168 * z959;
    const Scalar z967 = c_yaw * z286 + s_yaw * z961;
    const Scalar z968 = z903 - z967;
    const Scalar z969 = z167 * z959 - z958 - z186 * z222;
    const Scalar z970 = s_yaw * z286 - c_yaw * z961;
    const Scalar z971 = z898 + z970;
    const Scalar z972 = z95 * z900 + s_roll * z898;
    const Scalar z973 = s_roll * z903 + z92 * z900;
    const Scalar z974 = z322 * z960 - z320 * z963 - z278 * z965 + z275 * z971;
    const Scalar z975 = z320 * z962 - z326 * z960 + z275 * z968 - z282 * z965;
    const Scalar z976 = z211 * z321 + z210 * z319 - z162 * z935 + z155 * z937;
    const Scalar z977 = z211 * z323 - z213 * z319 + z155 * z936 + z161 * z935;
    const Scalar z978 = c_roll * z175;
    const Scalar z979 = z978 - n0_35 * z957;
    const Scalar z980 = c_roll * z944;
    const Scalar z981 = n0_5 * (z241 * z234 / (z174 * z174) + z953 / z174);
    const Scalar z982 = z980 + n0_35 * z981;
    const Scalar z983 = l_lambda_front_rolls_x * z976 + l_lambda_front_rolls_y * z977;
    const Scalar z984 = z826 - z983;
    const Scalar z985 = l_lambda_front_touches * z979 - l_lambda_front_rolls_y * z973 + l_lambda_front_rolls_x * z972;
    const Scalar z986 = l_lambda_front_rolls_x * z974 - l_lambda_front_rolls_y * z975 - l_lambda_front_touches * z982;
    const Scalar z987 = z739 - z986;
    const Scalar z988 = l_lambda_front_rolls_x * z966 - l_lambda_front_rolls_y * z969;
    const Scalar z989 = z790 - z988;
    const Scalar z990 = z656 + z985;
    const Scalar z991 = l_lambda_front_rolls_x * z904 + l_lambda_front_rolls_y * z905 + l_lambda_front_touches * z916;
    const Scalar z992 = z765 - z991;
    const Scalar z993 = k33 * z415 + z420 + k3 * z475 - n3_85 * z485 - k4 * z490;  // moment on fork, x
    const Scalar z994 = k35 * z411 + z418 + k5 * z467 + n1_04 * z485 - k4 * z495;  // moment on fork, z
    const Scalar z995 = z399 + z433;
    const Scalar z996 = z955 - z966;
    const Scalar z997 = z958 + z969;
    const Scalar z998 = n0_5 * (z232 * z243 / (z174 * z174) + z953 / z174);
    const Scalar z999 = z980 + n0_35 * z998;
    const Scalar z1000 = z11 * z487 + z13 * z993 - z14 * z994;
    const Scalar z1001 = z10 * z487 + z12 * z993 - z13 * z994;
    const Scalar z1002 = z429 - n25_5 * z444 + n9_95 * z453 - n17_7 * z456 - n1_1 * z524 - z1000;  // moment on frame, z
    const Scalar z1003 = z426 + n51 * z444 - n17_7 * z453 + n39_3 * z456 - n0_3 * z524 - z1001;  // moment on frame, x
    const Scalar z1004 = a_z - a_roll * z140 - z204;
    const Scalar z1005 = a_z + a_roll * z250 - a_pitch * z249 - a_steer * z253 + z333;
    const Scalar z1006 = a_y - z298 * (a_pitch + a_rear) - a_yaw * z255 + a_roll * z306 - z349;
    const Scalar z1007 = z10 * z993 - z519 - z11 * z994;
    // moment on frame, y
    const Scalar z1008 = z465 + n29_35 * z361 + n49_25 * z452 + n17_7 * z447 - n25_5 * z455 + n51 * z454 + n0_3 * z516
        + n1_1 * z526 + z1007;
    const Scalar z1009 = z1 * z993 + z2 * z994;
    const Scalar z1010 = a_x + a_yaw * z265 - a_roll * z281 + a_pitch * z299 + a_steer * z330 + a_front * z327 + z431;
    const Scalar z1011 = a_y - a_yaw * z264 + a_roll * z289 - a_pitch * z297 - a_steer * z331 - a_front * z336 - z449;
    const Scalar z1012 = z304 * (a_pitch + a_rear) + a_x + a_yaw * z257 - a_roll * z301 + z350;
    const Scalar z1013 = n2 * (z215 * z217 + z155 * z162);
    const Scalar z1014 = n2 * (z155 * z155 - z215 * z215);
    const Scalar z1015 = z186 * z230 - z247 + z159 * z959;
    const Scalar z1016 = z247 + z1015;
    const Scalar z1017 = s_yaw * z1015;
    const Scalar z1018 = c_yaw * z1015;
    const Scalar z1019 = s_roll * z966 + z95 * z1015;
    const Scalar z1020 = z92 * z1015 + s_roll * z969;
    const Scalar z1021 = n2 * (z155 * z161 - z215 * z216);
    const Scalar z1022 = n2 * (z168 * z1013 - z230 * z230 - z159 * z1014 - z222 * z222 - z225 * z225 + z167 * z1021);
    const Scalar z1023 = v_yaw * z804;
    const Scalar z1024 = z275 * z966 - z278 * z1015;
    const Scalar z1025 = z275 * z969 - z282 * z1015;
    const Scalar z1026 = z215 * z321 + z217 * z319 + z155 * z996 - z162 * z1016;
    const Scalar z1027 = c_steer * z8;
    const Scalar z1028 = z215 * z323 + z216 * z319 + z161 * z1016 + z155 * z997;
    const Scalar z1029 = n0_5 * (z234 * z243 / (z174 * z174) + z1022 / z174);
    const Scalar z1030 = c_steer * (n1 - z7);
    const Scalar z1031 = n0_08 * z1030 - n0_35 * z1027;
    const Scalar z1032 = c_steer * (n1 - z9);
    const Scalar z1033 = n0_08 * z1027 - n0_35 * z1032;
    const Scalar z1034 = v_roll * z289 - z1023 - v_pitch * z813 - v_steer * z809 + v_front * z810;
    const Scalar z1035 = c_pitch * z1033 + s_pitch * z1031;
    const Scalar z1036 = v_roll * z289 - z1023 - v_pitch * z813 - v_steer * z809 + v_front * z810 - z382;
    const Scalar z1037 = c_roll * z1035 - z179;
    const Scalar z1038 = z370 - z186 * z190 + z167 * z341;
    const Scalar z1039 = z396 - z90 * z804 + s_roll * z1038 - z92 * z347;
    const Scalar z1040 = z1037 + n0_35 * z1029;
    const Scalar z1041 = z389 + z1038;
    const Scalar z1042 = z346 * z805 - z398 + z275 * z1041 - z282 * z391;
    const Scalar z1043 = l_lambda_front_rolls_x * z1024 - l_lambda_front_touches * z1040 - l_lambda_front_rolls_y
        * z1025;
    const Scalar z1044 = l_lambda_front_rolls_x * z1026 + l_lambda_front_rolls_y * z1028;
    const Scalar z1045 = z792 + z1044;
    const Scalar z1046 = s_pitch * z1002 - c_pitch * z1003;
    const Scalar z1047 = z731 + z1043;
    const Scalar z1048 = n0_5603 * (a_roll + z448) + z1046;  // moment on frame.2, x
    const Scalar z1049 = s_pitch * z1003 + c_pitch * z1002;
    const Scalar z1050 = z1049 - n0_5603 * z995;  // moment on frame.2, z
    const Scalar z1051 = l_lambda_front_rolls_x * z1019 - l_lambda_front_rolls_y * z1020 - l_lambda_front_touches
        * z999;
    const Scalar z1052 = z756 - z1051;
    const Scalar z1053 = s_roll * z1008 + c_roll * z1050;
    const Scalar z1054 = l_lambda_front_rolls_x * z1017 + l_lambda_front_rolls_y * z1018 - l_lambda_front_touches
        * z939;
    const Scalar z1055 = z789 + z1054;
    const Scalar z1056 = z370 - z1038;
    const Scalar z1057 = z182 * z807 - z401 + z155 * z1056 + z161 * z351;
    const Scalar z1058 = z96 * z296 - z305;
    const Scalar z1059 = z94 * z296 - z288;
    const Scalar z1060 = z90 * z812 + z104 * z256 + s_roll * z1058 - z317;
    const Scalar z1061 = v_yaw * z1038 + v_pitch * z1039 + v_roll * z403 - v_steer * z1042 - v_front * z1057;
    const Scalar z1062 = a_yaw * z804 - a_roll * z289 + a_pitch * z813 + a_steer * z809 - a_front * z810 - z1061;
    const Scalar z1063 = v_yaw * z1058 - v_roll * z316 + z1060 * (v_pitch + v_rear);
    const Scalar z1064 = z90 * z815 + z100 * z256 + s_roll * z1059 - z314;
    const Scalar z1065 = v_yaw * z1059 + z1064 * (v_pitch + v_rear) + v_roll * z313;
    const Scalar z1066 = z816 * (a_pitch + a_rear) + a_yaw * z812 - a_roll * z301 + z1063;
    const Scalar z1067 = v_yaw * z812;
    const Scalar z1068 = c_yaw * z90 - s_roll * z91;
    const Scalar z1069 = z817 * (a_pitch + a_rear) + a_yaw * z815 + a_roll * z306 + z1065;
    const Scalar z1070 = v_yaw * z815;
    const Scalar z1071 = c_roll * z104;
    const Scalar z1072 = z182 * z212;
    const Scalar z1073 = z95 * z88 + z90 * z99 + s_roll * z1068 + z1071;
    const Scalar z1074 = z105 * z103;
    const Scalar z1075 = c_roll * z90;
    const Scalar z1076 = s_yaw * z182 - z89 * z155;
    const Scalar z1077 = z182 * z219;
    const Scalar z1078 = z90 * z97;
    const Scalar z1079 = z91 * z155 + c_yaw * z182;
    const Scalar z1080 = s_yaw * z90 + s_roll * z89;
    const Scalar z1081 = n2 * (s_roll * z88 - z1075);
    const Scalar z1082 = z98 * z129 - n4 * z1075;
    const Scalar z1083 = z161 * z176 - z1072 - z155 * z1076 + z156 * z189;
    const Scalar z1084 = z1077 - z162 * z176 + z155 * z1079 + z156 * z180;
    const Scalar z1085 = z92 * z88 + z1078 + s_roll * z1080 + c_roll * z100;
    const Scalar z1086 = n2 * (z96 * z1073 - z1074 - z108 * z102 - z93 * z1081 - z110 * z107 + z94 * z1085);
    const Scalar z1087 = z111 * z120;
    const Scalar z1088 = n4 * z90 * z88 + n2 * (s_roll * z127 + c_roll * z135);
    const Scalar z1089 = s_yaw * z135 + s_roll * z128 - z89 * z137;
    const Scalar z1090 = z97 * z135 - z92 * z127 - n2 * (z90 * z1080 - z88 * z100) + s_roll * z1089 - c_roll * z139;
    const Scalar z1091 = n0_5 * (z1087 / (z106 * z106) + z1086 / z106);
    const Scalar z1092 = z89 * z98 + s_yaw * z137;
    const Scalar z1093 = z92 * z129 + s_roll * z1092 + n2 * (c_roll * z100 + z1078);
    const Scalar z1094 = c_yaw * z137 - z91 * z98;
    const Scalar z1095 = z95 * z129 + s_roll * z1094 + n2 * (z90 * z99 + z1071);
    const Scalar z1096 = c_yaw * z135 + s_roll * z136 + z91 * z137;
    const Scalar z1097 = z99 * z135 - z95 * z127 - n2 * (z90 * z1068 - z88 * z104) + s_roll * z1096 - c_roll * z141;
    const Scalar z1098 = n2 * (z94 * z1093 + z96 * z1095 - z93 * z1082) - n4 * (z1074 + z108 * z102 + z110 * z107);
    const Scalar z1099 = n4 * (z110 * z1073 - z108 * z1081 + z105 * z1085) + n2 * (z93 * z1088 - z102 * z145 + z103
        * z142 + z107 * z143 + z94 * z1090 + z96 * z1097);
    const Scalar z1100 = n0_5 * (z121 * z1086 / (z106 * z106) + z120 * z147 / (z106 * z106) - z1099 / z106 + z111
        * z1091 / (z106 * z106)) + z121 * z1087 / (z106 * z106 * z106);
    const Scalar z1101 = n0_5 * (z121 * z109 / (z106 * z106) + z1087 / (z106 * z106) + z1098 / z106);
    const Scalar z1102 = n0_3 * z1091;
    const Scalar z1103 = n0_3 * z1101;
    const Scalar z1104 = v_yaw * z800;
    const Scalar z1105 = v_roll * z301 - z1067 - z816 * (v_pitch + v_rear);
    const Scalar z1106 = v_roll * z301 - z1067 - z816 * (v_pitch + v_rear) + z303;
    const Scalar z1107 = n2 * (s_roll * z202 + z337) - z129 * z134 - z137 * z175;
    const Scalar z1108 = n0_3 * z1100;
    const Scalar z1109 = n2 * (z156 * z182 + z155 * z176);
    const Scalar z1110 = a_roll * z875 + z1108;
    const Scalar z1111 = z229 * z228;
    const Scalar z1112 = n2 * (z1111 - z159 * z1109 - z187 * z223 + z167 * z1083 - z168 * z1084 + z190 * z220);
    const Scalar z1113 = z240 * z242;
    const Scalar z1114 = z1104 + v_roll * z281 + v_pitch * z811 + v_steer * z806 - v_front * z808;
    const Scalar z1115 = z1104 + v_roll * z281 + v_pitch * z811 + v_steer * z806 - v_front * z808 + z392;
    const Scalar z1116 = z129 * z152 - c_steer * z137 + n2 * (s_roll * z165 - c_roll * z171);
    const Scalar z1117 = s_yaw * z1116 - z89 * z177;
    const Scalar z1118 = z1070 + v_roll * z306 + z817 * (v_pitch + v_rear);
    const Scalar z1119 = z1070 + v_roll * z306 + z817 * (v_pitch + v_rear) - z311;
    const Scalar z1120 = n0_5 * (z1113 / (z174 * z174) - z1112 / z174);
    const Scalar z1121 = z345 + z186 * z187 + z168 * z341;
    const Scalar z1122 = c_steer * z129 + z137 * z152 + n2 * (s_roll * z171 + z170);
    const Scalar z1123 = z377 + z1121;
    const Scalar z1124 = z346 * z801 + z397 + z275 * z1123 - z278 * z391;
    const Scalar z1125 = z343 - z90 * z800 + s_roll * z1121 - z95 * z347;
    const Scalar z1126 = z161 * z1122 - z155 * z1117 + n2 * (z156 * z189 - z1072);
    const Scalar z1127 = z91 * z177 + c_yaw * z1116;
    const Scalar z1128 = z155 * z1127 - z162 * z1122 + n2 * (z156 * z180 + z1077);
    const Scalar z1129 = z345 - z1121;
    const Scalar z1130 = z182 * z802 + z402 + z155 * z1129 + z162 * z351;
    const Scalar z1131 = n4 * z156 * z182 + z177 * z1122;
    const Scalar z1132 = z339 - n0_35 * z1120;
    const Scalar z1133 = n4 * (z1111 - z187 * z223 + z190 * z220) + n2 * (z167 * z1126 - z168 * z1128 - z159 * z1131);
    const Scalar z1134 = v_yaw * z1121 - v_roll * z348 + v_pitch * z1125 - v_steer * z1124 - v_front * z1130;
    const Scalar z1135 = a_yaw * z800 + a_roll * z281 + a_pitch * z811 + a_steer * z806 - a_front * z808 - z1134;
    const Scalar z1136 = z135 * z175 - z127 * z134 - c_roll * z262 + n2 * (z90 * z202 - z88 * z201) + s_roll * z310;
    const Scalar z1137 = n0_6 * z121 * z120 / (z106 * z106 * z106) + z1102 / (z106 * z106);
    const Scalar z1138 = z118 * z1081 - z108 * z798 - z102 * z296 + z93 * z1137;
    const Scalar z1139 = z94 * z1137 - z118 * z1085 - z105 * z798 - z103 * z296;
    const Scalar z1140 = n0_5 * (z1113 / (z174 * z174) - z1133 / z174 + z248 * z233 / (z174 * z174));
    const Scalar z1141 = z1107 - n0_35 * z1140;
    const Scalar z1142 = z96 * z1137 - z118 * z1073 - z110 * z798 - z107 * z296;
    const Scalar z1143 = z88 * z255 + z256 * z1080 - c_roll * z303 + z90 * z803 - z100 * z860 + z97 * z309 + z92 * z1138
        + s_roll * z1139;
    const Scalar z1144 = n4 * z182;
    const Scalar z1145 = n2 * (z156 * z269 - z155 * z270) - z176 * z1144;
    const Scalar z1146 = z136 * z155 - z91 * z263 + c_yaw * z269;
    const Scalar z1147 = z128 * z155 + z89 * z263 + s_yaw * z269;
    const Scalar z1148 = z256 * z1068 - z88 * z257 + c_roll * z311 + z90 * z814 - z104 * z860 + z99 * z309 + z95 * z1138
        + s_roll * z1142;
    const Scalar z1149 = n2 * (z182 * z1079 + z176 * z180) - z162 * z270 - z219 * z269 + z156 * z271 - z155 * z1146;
    const Scalar z1150 = z161 * z270 + z212 * z269 - n2 * (z182 * z1076 - z176 * z189) + z156 * z273 + z155 * z1147;
    const Scalar z1151 = n4 * (z229 * z1109 + z190 * z1083 + z187 * z1084) + n2 * (z159 * z1145 - z228 * z272 - z223
        * z274 + z220 * z276 - z168 * z1149 + z167 * z1150);
    const Scalar z1152 = n0_5 * (z1151 / z174 - z242 * z280 / (z174 * z174) - z248 * z1112 / (z174 * z174) + z240
        * z1120 / (z174 * z174)) + z242 * z300 / (z174 * z174 * z174);
    const Scalar z1153 = z91 * z152;
    const Scalar z1154 = c_roll * z173 - z88 * z154;
    const Scalar z1155 = z90 * z154 + s_roll * z173;
    const Scalar z1156 = z89 * z209 + z1153 - c_yaw * z171 + s_yaw * z1155;
    const Scalar z1157 = n0_7 * z248;
    const Scalar z1158 = z242 * z1157 / (z174 * z174 * z174) + n0_35 * z1120 / (z174 * z174);
    const Scalar z1159 = v_roll * z854;
    const Scalar z1160 = v_yaw * z797 - z1159 + z348 + v_steer * z906 - v_front * z908 + v_pitch * z911;
    const Scalar z1161 = v_yaw * z797 - z1159 + v_steer * z906 - v_front * z908 + v_pitch * z911;
    const Scalar z1162 = z1136 - n0_35 * z1152;
    const Scalar z1163 = a_roll * z871 + a_pitch * z917 + a_steer * z919 - z1162;
    const Scalar z1164 = z89 * z152 - z91 * z209 + s_yaw * z171 + c_yaw * z1155;
    const Scalar z1165 = z339 - z186 * z1109 + z229 * z796 + z228 * z341 + z159 * z1158;
    const Scalar z1166 = z375 + z1165;
    const Scalar z1167 = z339 - z1165;
    const Scalar z1168 = z182 * z210;
    const Scalar z1169 = z187 * z221;
    const Scalar z1170 = n2 * (z155 * z1154 - z182 * z211);
    const Scalar z1171 = z155 * z1164 - z1168 - z162 * z1154 - z180 * z211;
    const Scalar z1172 = z155 * z1156 - z161 * z1154 - z182 * z213 + z189 * z211;
    const Scalar z1173 = v_yaw * z799;
    const Scalar z1174 = v_roll * z859 + z1173 + v_pitch * z907 - v_steer * z910 + v_front * z912 - z403;
    const Scalar z1175 = v_roll * z859 + z1173 + v_pitch * z907 - v_steer * z910 + v_front * z912;
    const Scalar z1176 = n2 * (z1169 + z229 * z218 + z159 * z1170 - z190 * z226 + z168 * z1171 + z167 * z1172);
    const Scalar z1177 = z88 * z178 + c_roll * z338;
    const Scalar z1178 = v_yaw * z803;
    const Scalar z1179 = v_roll * z861 - z1178 - z313 - z909 * (v_pitch + v_rear);
    const Scalar z1180 = v_roll * z861 - z1178 - z909 * (v_pitch + v_rear);
    const Scalar z1181 = c_yaw * z346 - z91 * z275;
    const Scalar z1182 = c_yaw * z251 - z91 * z183;
    const Scalar z1183 = z89 * z183 + s_yaw * z251;
    const Scalar z1184 = z1182 - z186 * z1084 + z187 * z796 - z223 * z341 + z168 * z1158;
    const Scalar z1185 = z1183 + z186 * z1083 - z190 * z796 - z220 * z341 + z167 * z1158;
    const Scalar z1186 = z240 * z241;
    const Scalar z1187 = n0_5 * (z1186 / (z174 * z174) + z1176 / z174);
    const Scalar z1188 = z89 * z275 + s_yaw * z346;
    const Scalar z1189 = v_yaw * z814;
    const Scalar z1190 = v_roll * z862 + z1189 - z316 + z913 * (v_pitch + v_rear);
    const Scalar z1191 = z88 * z265 - z277 * z1068 + z90 * z797 + z104 * z853 - c_roll * z382 - z99 * z347 + s_roll
        * z1184 + z95 * z1165;
    const Scalar z1192 = z90 * z799 - z88 * z264 - z277 * z1080 + z100 * z853 + c_roll * z392 - z97 * z347 + s_roll
        * z1185 + z92 * z1165;
    const Scalar z1193 = v_roll * z862 + z1189 + z913 * (v_pitch + v_rear);
    const Scalar z1194 = z1182 - z1184;
    const Scalar z1195 = z156 * z374 - z176 * z321 - z319 * z1079 - z182 * z880 - z180 * z881 + z219 * z351 + z155
        * z1194 + z162 * z1167;
    const Scalar z1196 = z1183 - z1185;
    const Scalar z1197 = z319 * z1076 - z176 * z323 + z182 * z882 - z189 * z881 + z156 * z383 - z212 * z351 - z155
        * z1196 - z161 * z1167;
    const Scalar z1198 = z1177 + n0_35 * z1187;
    const Scalar z1199 = c_yaw * z379 - z91 * z293;
    const Scalar z1200 = z89 * z293 + s_yaw * z379;
    const Scalar z1201 = z1184 - z1199;
    const Scalar z1202 = z1185 - z1200;
    const Scalar z1203 = s_yaw * z1165 - z89 * z853;
    const Scalar z1204 = z320 * z1181 - z322 * z368 + z346 * z896 + z371 * z879 + z268 * z381 + z391 * z894 + z275
        * z1201 - z278 * z1166;
    const Scalar z1205 = z326 * z368 + z320 * z1188 + z346 * z902 - z393 * z879 + z268 * z395 + z391 * z897 + z275
        * z1202 - z282 * z1166;
    const Scalar z1206 = v_yaw * z1184 + v_roll * z1203 + v_pitch * z1191 - v_steer * z1204 - v_front * z1195;
    const Scalar z1207 = a_yaw * z797 - a_roll * z854 + a_pitch * z911 + a_steer * z906 - a_front * z908 + z1206;
    const Scalar z1208 = z151 * z258 + s_pitch * z291 + c_pitch * z284 + z132 * z259 + n2 * (z160 * z194 - z199 * z163);
    const Scalar z1209 = z91 * z853 + c_yaw * z1165;
    const Scalar z1210 = v_yaw * z1185 - v_roll * z1209 + v_pitch * z1192 - v_steer * z1205 + v_front * z1197;
    const Scalar z1211 = z127 * z178 - z129 * z338 + c_roll * z1208;
    const Scalar z1212 = n2 * z163;
    const Scalar z1213 = n2 * z160;
    const Scalar z1214 = z132 * z1212 - z151 * z1213 + n2 * (c_pitch * z199 + z334);
    const Scalar z1215 = z10 * z1212 + z11 * z1213 + n2 * (s_pitch * z169 - c_pitch * z166);
    const Scalar z1216 = z10 * z1213 - z11 * z1212 + n2 * (s_pitch * z166 + c_pitch * z169);
    const Scalar z1217 = a_yaw * z799 + a_roll * z859 + a_pitch * z907 - a_steer * z910 + a_front * z912 + z1210;
    const Scalar z1218 = z129 * z178 + c_roll * z1214;
    const Scalar z1219 = z137 * z154 + s_roll * z1215;
    const Scalar z1220 = n2 * (z89 * z209 + z1153) - c_yaw * z1216 + s_yaw * z1219;
    const Scalar z1221 = n2 * (z89 * z152 - z91 * z209) + s_yaw * z1216 + c_yaw * z1219;
    const Scalar z1222 = c_roll * z1215 - z129 * z154;
    const Scalar z1223 = z155 * z1221 - z162 * z1222 - n2 * (z180 * z211 + z1168);
    const Scalar z1224 = z155 * z1220 - z161 * z1222 - n2 * (z182 * z213 - z189 * z211);
    const Scalar z1225 = z177 * z1222 - z211 * z1144;
    const Scalar z1226 = c_yaw * z1138 - z91 * z860;
    const Scalar z1227 = n2 * (z159 * z1225 + z167 * z1224 + z168 * z1223) - n4 * (z190 * z226 - z1169 - z229 * z218);
    const Scalar z1228 = v_yaw * z1139 - v_roll * z1226 + z1143 * (v_pitch + v_rear);
    const Scalar z1229 = z909 * (a_pitch + a_rear) + a_yaw * z803 - a_roll * z861 + z1228;
    const Scalar z1230 = s_roll * z338 - z90 * z178;
    const Scalar z1231 = z89 * z860 + s_yaw * z1138;
    const Scalar z1232 = v_roll * z1231 + v_yaw * z1142 + z1148 * (v_pitch + v_rear);
    const Scalar z1233 = n0_5 * (z1227 / z174 + z1186 / (z174 * z174) + z248 * z232 / (z174 * z174));
    const Scalar z1234 = z127 * z154 + z129 * z173 + c_roll * z261;
    const Scalar z1235 = z135 * z154 - z137 * z173 + s_roll * z261;
    const Scalar z1236 = z913 * (a_pitch + a_rear) + a_yaw * z814 + a_roll * z862 + z1232;
    const Scalar z1237 = z2 * z165;
    const Scalar z1238 = z1 * z165;
    const Scalar z1239 = z8 * z164;
    const Scalar z1240 = -z164 * (n1 - z7);
    const Scalar z1241 = n0_35 * z1239 + n0_08 * z1240;
    const Scalar z1242 = z1144 * z1154 + n2 * (z155 * z1234 + z211 * z269);
    const Scalar z1243 = z1218 + n0_35 * z1233;
    const Scalar z1244 = z160 * z237;
    const Scalar z1245 = -z164 * (n1 - z9);
    const Scalar z1246 = n0_08 * z1239 + n0_35 * z1245;
    const Scalar z1247 = z128 * z152 + z136 * z209 - n2 * (z89 * z171 - z91 * z1155) + s_yaw * z260 + c_yaw * z1235;
    const Scalar z1248 = z128 * z209 - z136 * z152 - n2 * (z91 * z171 + z89 * z1155) - c_yaw * z260 + s_yaw * z1235;
    const Scalar z1249 = n2 * (z182 * z1164 + z180 * z1154) - z162 * z1234 + z210 * z269 + z155 * z1247 - z211 * z271;
    const Scalar z1250 = z213 * z269 - z161 * z1234 + n2 * (z182 * z1156 - z189 * z1154) + z155 * z1248 + z211 * z273;
    const Scalar z1251 = n4 * (z190 * z1172 - z187 * z1171 - z229 * z1170) + n2 * (z159 * z1242 - z218 * z272 + z221
        * z274 - z226 * z276 + z168 * z1249 + z167 * z1250);
    const Scalar z1252 = n0_5 * (z248 * z1176 / (z174 * z174) - z241 * z280 / (z174 * z174) - z1251 / z174 + z240
        * z1187 / (z174 * z174)) + z241 * z300 / (z174 * z174 * z174);
    const Scalar z1253 = z241 * z1157 / (z174 * z174 * z174) + n0_35 * z1187 / (z174 * z174);
    const Scalar z1254 = z229 * z891 - z1177 - z186 * z1170 - z218 * z341 + z159 * z1253;
    const Scalar z1255 = z1177 + z1254;
    const Scalar z1256 = z163 * z206;
    const Scalar z1257 = z160 * z206;
    const Scalar z1258 = z91 * z208;
    const Scalar z1259 = z1256 + s_pitch * z1237 - z160 * z205 + c_pitch * z1238;
    const Scalar z1260 = s_pitch * z1238 - z1257 - z163 * z205 - c_pitch * z1237;
    const Scalar z1261 = z1211 + n0_35 * z1252;
    const Scalar z1262 = s_steer * z90;
    const Scalar z1263 = a_roll * z916 + a_pitch * z979 + a_steer * z982 + z1261;
    const Scalar z1264 = z163 * z239 - z1244 + s_pitch * z1241 - c_pitch * z1246;
    const Scalar z1265 = s_roll * z164 + z1262 + z88 * z207 + c_roll * z1259;
    const Scalar z1266 = s_steer * z88 - c_roll * z164 - z90 * z207 + s_roll * z1259;
    const Scalar z1267 = z1258 - z89 * z214 + c_yaw * z1260 + s_yaw * z1266;
    const Scalar z1268 = n0_08 * z1237 - n0_35 * z1238;
    const Scalar z1269 = z90 * z245;
    const Scalar z1270 = v_yaw * z898;
    const Scalar z1271 = v_roll * z904 + z1270 + v_pitch * z972 - v_steer * z974 + v_front * z976 - z404;
    const Scalar z1272 = v_roll * z904 + z1270 + v_pitch * z972 - v_steer * z974 + v_front * z976;
    const Scalar z1273 = z182 * z216;
    const Scalar z1274 = z89 * z208;
    const Scalar z1275 = z182 * z217;
    const Scalar z1276 = z1273 - z161 * z1265 + z155 * z1267 + z189 * z215;
    const Scalar z1277 = s_yaw * z1260 - z1274 - z91 * z214 - c_yaw * z1266;
    const Scalar z1278 = v_yaw * z903;
    const Scalar z1279 = v_roll * z905 - z1278 - v_pitch * z973 + v_steer * z975 + v_front * z977 - z421;
    const Scalar z1280 = v_roll * z905 - z1278 - v_pitch * z973 + v_steer * z975 + v_front * z977;
    const Scalar z1281 = s_roll * z1268 - z1269 + z88 * z244 + c_roll * z1264;
    const Scalar z1282 = s_roll * z357 - z90 * z267;
    const Scalar z1283 = z88 * z267 + c_roll * z357;
    const Scalar z1284 = s_yaw * z202 - z89 * z175 - z91 * z847 - c_yaw * z1230;
    const Scalar z1285 = z91 * z175 - z89 * z847 + c_yaw * z202 + s_yaw * z1230;
    const Scalar z1286 = z1284 - z186 * z1171 + z187 * z891 - z221 * z341 + z168 * z1253;
    const Scalar z1287 = z167 * z1253 - z1285 - z186 * z1172 - z190 * z891 - z226 * z341;
    const Scalar z1288 = z187 * z225;
    const Scalar z1289 = n2 * (z155 * z1265 - z182 * z215);
    const Scalar z1290 = z162 * z1265 + z1275 + z180 * z215 + z155 * z1277;
    const Scalar z1291 = z1284 - z1286;
    const Scalar z1292 = z91 * z266 - c_yaw * z340 - z89 * z956 + s_yaw * z1282;
    const Scalar z1293 = z89 * z266 + s_yaw * z340 + z91 * z956 + c_yaw * z1282;
    const Scalar z1294 = z180 * z935 - z321 * z1154 - z319 * z1164 - z211 * z374 - z210 * z351 + z182 * z937 + z155
        * z1291 - z162 * z1255;
    const Scalar z1295 = z1285 + z1287;
    const Scalar z1296 = z319 * z1156 - z323 * z1154 + z182 * z936 + z189 * z935 - z211 * z383 + z213 * z351 + z161
        * z1255 + z155 * z1295;
    const Scalar z1297 = z90 * z285 + s_roll * z366;
    const Scalar z1298 = c_roll * z366 - z88 * z285;
    const Scalar z1299 = z1254 - z1298;
    const Scalar z1300 = z89 * z286 + s_yaw * z369 + z91 * z961 - c_yaw * z1297;
    const Scalar z1301 = c_yaw * z369 - z91 * z286 + z89 * z961 + s_yaw * z1297;
    const Scalar z1302 = z1286 + z1300;
    const Scalar z1303 = z371 * z965 - z322 * z1283 - z320 * z1293 - z381 * z960 - z391 * z963 + z346 * z971 + z275
        * z1302 - z278 * z1299;
    const Scalar z1304 = z1287 - z1301;
    const Scalar z1305 = z326 * z1283 - z320 * z1292 + z346 * z968 - z393 * z965 + z391 * z962 - z395 * z960 - z282
        * z1299 + z275 * z1304;
    const Scalar z1306 = z89 * z900 + s_yaw * z1254;
    const Scalar z1307 = n2 * (z1288 + z229 * z230 + z159 * z1289 + z167 * z1276 - z168 * z1290 + z190 * z222);
    const Scalar z1308 = c_yaw * z1254 - z91 * z900;
    const Scalar z1309 = z90 * z898 - z104 * z900 + s_roll * z1286 + z95 * z1254;
    const Scalar z1310 = v_yaw * z1286 + v_roll * z1306 + v_pitch * z1309 - v_steer * z1303 - v_front * z1294;
    const Scalar z1311 = z90 * z903 - z100 * z900 + z92 * z1254 + s_roll * z1287;
    const Scalar z1312 = v_yaw * z1287 - v_roll * z1308 + v_pitch * z1311 - v_steer * z1305 + v_front * z1296;
    const Scalar z1313 = a_yaw * z898 + a_roll * z904 + a_pitch * z972 - a_steer * z974 + a_front * z976 + z1310;
    const Scalar z1314 = n2 * z165;
    const Scalar z1315 = z2 * z252;
    const Scalar z1316 = z1 * z252;
    const Scalar z1317 = z1 * z1314;
    const Scalar z1318 = z2 * z1314;
    const Scalar z1319 = a_yaw * z903 - a_roll * z905 + a_pitch * z973 - a_steer * z975 - a_front * z977 + z1312;
    const Scalar z1320 = s_pitch * z1317 - n2 * (z163 * z205 + z1257) - c_pitch * z1318;
    const Scalar z1321 = s_pitch * z1318 - n2 * (z160 * z205 - z1256) + c_pitch * z1317;
    const Scalar z1322 = n0_08 * z1318 - n0_35 * z1317;
    const Scalar z1323 = z205 * z258 + z206 * z259 + s_pitch * z1315 + c_pitch * z1316 + n2 * (z160 * z1237 - z163
        * z1238);
    const Scalar z1324 = z206 * z258 - z205 * z259 + s_pitch * z1316 - c_pitch * z1315 + n2 * (z160 * z1238 + z163
        * z1237);
    const Scalar z1325 = n0_08 * z1315 - n0_35 * z1316;
    const Scalar z1326 = s_roll * z224 + s_steer * z135 - z127 * z207 - n2 * (z90 * z164 - z88 * z1259) - c_roll
        * z1323;
    const Scalar z1327 = c_roll * z224 + s_steer * z127 + z135 * z207 + n2 * (z88 * z164 + z90 * z1259) + s_roll
        * z1323;
    const Scalar z1328 = n2 * z164;
    const Scalar z1329 = n2 * (z88 * z207 + z1262) + s_roll * z1328 + c_roll * z1321;
    const Scalar z1330 = n2 * (s_steer * z88 - z90 * z207) - c_roll * z1328 + s_roll * z1321;
    const Scalar z1331 = z240 * z243;
    const Scalar z1332 = c_yaw * z1320 - n2 * (z89 * z214 - z1258) + s_yaw * z1330;
    const Scalar z1333 = s_yaw * z1320 - n2 * (z91 * z214 + z1274) - c_yaw * z1330;
    const Scalar z1334 = z155 * z1332 - z161 * z1329 + n2 * (z189 * z215 + z1273);
    const Scalar z1335 = z162 * z1329 + n2 * (z180 * z215 + z1275) + z155 * z1333;
    const Scalar z1336 = z177 * z1329 - z215 * z1144;
    const Scalar z1337 = n4 * (z1288 + z229 * z230 + z190 * z222) + n2 * (z159 * z1336 + z167 * z1334 - z168 * z1335);
    const Scalar z1338 = z1144 * z1265 + n2 * (z155 * z1326 + z215 * z269);
    const Scalar z1339 = z128 * z208 - z136 * z214 + n2 * (z89 * z1260 + z91 * z1266) + s_yaw * z1324 - c_yaw * z1327;
    const Scalar z1340 = z136 * z208 + z128 * z214 + n2 * (z89 * z1266 - z91 * z1260) + c_yaw * z1324 + s_yaw * z1327;
    const Scalar z1341 = z217 * z269 - z162 * z1326 - n2 * (z182 * z1277 - z180 * z1265) + z155 * z1339 - z215 * z271;
    const Scalar z1342 = z161 * z1326 + z216 * z269 - n2 * (z182 * z1267 - z189 * z1265) + z155 * z1340 - z215 * z273;
    const Scalar z1343 = n2 * (z230 * z272 - z159 * z1338 - z225 * z274 - z222 * z276 - z168 * z1341 + z167 * z1342)
        - n4 * (z190 * z1276 + z187 * z1290 - z229 * z1289);
    const Scalar z1344 = n0_5 * (z1331 / (z174 * z174) - z1337 / z174 + z248 * z234 / (z174 * z174));
    const Scalar z1345 = n0_5 * (z1331 / (z174 * z174) - z1307 / z174);
    const Scalar z1346 = n0_5 * (z240 * z1345 / (z174 * z174) - z248 * z1307 / (z174 * z174) - z243 * z280 / (z174
        * z174) - z1343 / z174) + z243 * z300 / (z174 * z174 * z174);
    const Scalar z1347 = z243 * z1157 / (z174 * z174 * z174) + n0_35 * z1345 / (z174 * z174);
    const Scalar z1348 = z1281 - n0_35 * z1345;
    const Scalar z1349 = v_roll * z1017;
    const Scalar z1350 = v_yaw * z966 + z1349 + v_pitch * z1019 - v_steer * z1024 - v_front * z1026 - z422;
    const Scalar z1351 = z1281 + z186 * z1289 + z229 * z959 + z230 * z341 + z159 * z1347;
    const Scalar z1352 = v_yaw * z966 + z1349 + v_pitch * z1019 - v_steer * z1024 - v_front * z1026;
    const Scalar z1353 = z1281 - z1351;
    const Scalar z1354 = v_yaw * z969;
    const Scalar z1355 = z160 * z239 + z163 * z237 + s_pitch * z1246 + c_pitch * z1241;
    const Scalar z1356 = z8 * z224;
    const Scalar z1357 = s_roll * z1264 - c_roll * z1268 - z90 * z244 - z88 * z245;
    const Scalar z1358 = -z224 * (n1 - z7);
    const Scalar z1359 = n0_35 * z1356 + n0_08 * z1358;
    const Scalar z1360 = -z224 * (n1 - z9);
    const Scalar z1361 = n0_08 * z1356 + n0_35 * z1360;
    const Scalar z1362 = z89 * z944 + z91 * z888 + s_yaw * z1355 + c_yaw * z1357;
    const Scalar z1363 = s_pitch * z1359 - z239 * z259 - z237 * z258 - c_pitch * z1361 - n2 * (z160 * z1241 + z163
        * z1246);
    const Scalar z1364 = z1362 - z186 * z1290 + z187 * z959 + z225 * z341 + z168 * z1347;
    const Scalar z1365 = z8 * z1328;
    const Scalar z1366 = -z1328 * (n1 - z7);
    const Scalar z1367 = -z1328 * (n1 - z9);
    const Scalar z1368 = n0_35 * z1365 + n0_08 * z1366;
    const Scalar z1369 = z91 * z944 - z89 * z888 - c_yaw * z1355 + s_yaw * z1357;
    const Scalar z1370 = z1369 + z186 * z1276 - z190 * z959 - z222 * z341 + z167 * z1347;
    const Scalar z1371 = z135 * z245 + s_roll * z1325 + z127 * z244 + n2 * (z90 * z1268 - z88 * z1264) - c_roll * z1363;
    const Scalar z1372 = n0_08 * z1365 + n0_35 * z1367;
    const Scalar z1373 = s_pitch * z1368 - c_pitch * z1372 + n2 * (z163 * z239 - z1244);
    const Scalar z1374 = z90 * z966 - z104 * z1015 + s_roll * z1364 + z95 * z1351;
    const Scalar z1375 = z90 * z969 - z100 * z1015 + s_roll * z1370 + z92 * z1351;
    const Scalar z1376 = s_roll * z1322 + n2 * (z88 * z244 - z1269) + c_roll * z1373;
    const Scalar z1377 = z346 * z966 + z371 * z1015 + z275 * z1364 - z278 * z1351;
    const Scalar z1378 = z346 * z969 - z393 * z1015 + z275 * z1370 - z282 * z1351;
    const Scalar z1379 = z1371 - n0_35 * z1346;
    const Scalar z1380 = a_roll * z939 + a_pitch * z999 - a_steer * z1040 + z1379;
    const Scalar z1381 = z1376 - n0_35 * z1344;
    const Scalar z1382 = z89 * z1015 + s_yaw * z1351;
    const Scalar z1383 = c_yaw * z1351 - z91 * z1015;
    const Scalar z1384 = z1362 - z1364;
    const Scalar z1385 = z321 * z1265 - z319 * z1277 - z182 * z996 - z180 * z1016 + z215 * z374 + z217 * z351 + z155
        * z1384 + z162 * z1353;
    const Scalar z1386 = z1369 - z1370;
    const Scalar z1387 = z319 * z1267 - z323 * z1265 + z189 * z1016 - z215 * z383 - z216 * z351 + z182 * z997 + z155
        * z1386 + z161 * z1353;
    const Scalar z1388 = v_yaw * z1364 + v_roll * z1382 + v_pitch * z1374 - v_steer * z1377 - v_front * z1385;
    const Scalar z1389 = a_yaw * z966 + a_roll * z1017 + a_pitch * z1019 - a_steer * z1024 - a_front * z1026 + z1388;
    const Scalar z1390 = v_yaw * z1370 - v_roll * z1383 + v_pitch * z1375 - v_steer * z1378 - v_front * z1387;
    const Scalar z1391 = a_yaw * z969 - a_roll * z1018 + a_pitch * z1020 - a_steer * z1025 + a_front * z1028 + z1390;
    const Scalar z1392 = v_roll * z1018 - z1354 - v_pitch * z1020 + v_steer * z1025 - v_front * z1028 + z427;
    const Scalar z1393 = v_roll * z1018 - z1354 - v_pitch * z1020 + v_steer * z1025 - v_front * z1028;
    const Scalar z1394 = n1 / z327;
    const Scalar z1395 = z336 * z1394;
    const Scalar z1396 = n1 / z249;
    const Scalar z1397 = z140 + z250;
    const Scalar z1398 = z1396 * z1397;
    const Scalar z1399 = z253 * z1396;
    const Scalar z1400 = z297 * z1396;
    const Scalar z1401 = z264 - z265 * z1395;
    const Scalar z1402 = z1198 * z1399 - z1348;
    const Scalar z1403 = z1132 - z1198 * z1398;
    const Scalar z1404 = z1161 + z1272 * z1398;
    const Scalar z1405 = z1272 * z1399 + z1352;
    const Scalar z1406 = z255 - z1401;
    const Scalar z1407 = z1175 - z1280 * z1398;
    const Scalar z1408 = z1280 * z1399 + z1393;
    const Scalar z1409 = z1406 * z1406;
    const Scalar z1410 = n1 / z1406;
    const Scalar z1411 = z298 * z1396;
    const Scalar z1412 = z299 * z1396;
    const Scalar z1413 = z1114 - z1105 + z1034 * z1395;
    const Scalar z1414 = z253 * z1411;
    const Scalar z1415 = z253 * z1412 - z330;
    const Scalar z1416 = z304 * z1396;
    const Scalar z1417 = z1102 - z1403;
    const Scalar z1418 = z253 * z1400 - z331 - z1414 - z1395 * z1415;
    const Scalar z1419 = z306 - z1411 * z1397;
    const Scalar z1420 = z281 - z1412 * z1397;
    const Scalar z1421 = z289 - z1400 * z1397 - z1419 - z1395 * z1420;
    const Scalar z1422 = z257 * z1410;
    const Scalar z1423 = z1412 * z1417 - z1404;
    const Scalar z1424 = z249 * z249;
    const Scalar z1425 = n1_over_94 + z253 * z253 / z6 + z1424 / z62 + z250 * z250 / z80;
    const Scalar z1426 = z1118 - z1422 * z1413;
    const Scalar z1427 = z301 - z1416 * z1397 + z1422 * z1421;
    const Scalar z1428 = n1 - z1395 * z1422;
    const Scalar z1429 = z1180 + z1411 * z1417;
    const Scalar z1430 = z1428 * z1428;
    const Scalar z1431 = n1 / z1428;
    const Scalar z1432 = z1400 * z1417 - z1429 + z1407 - z1395 * z1423;
    const Scalar z1433 = z304 - z298 * z1422;
    const Scalar z1434 = z253 * z1416 + z1422 * z1418;
    const Scalar z1435 = z327 * z327;
    const Scalar z1436 = n1_over_94 + n25_over_7 * z1435 + z265 * z265 / z125 + z281 * z281 / z80 + z330 * z330 / z6
        + z299 * z299 / z62;
    const Scalar z1437 = z62 * z1425;
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
    const Scalar z1448 = z255 * z1444 + z1414;
    const Scalar z1449 = n0_28 * z1436;
    const Scalar z1450 = z1395 * z1445 + z1421;
    const Scalar z1451 = z1410 * z1446;
    const Scalar z1452 = z1410 * z1447;
    const Scalar z1453 = z1034 - z1442 + z265 * z1451;
    const Scalar z1454 = z1423 - z1443 + z265 * z1452;
    const Scalar z1455 = z255 * z1451 - z1105;
    const Scalar z1456 = z255 * z1452 + z1429;
    const Scalar z1457 = z1410 * z1450;
    const Scalar z1458 = z1415 - z1439 + z265 * z1444;
    const Scalar z1459 = z1394 * z1458;
    const Scalar z1460 = z1394 * z1453;
    const Scalar z1461 = z1420 - z1445 + z265 * z1457;
    const Scalar z1462 = z1394 * z1454;
    const Scalar z1463 = z1394 * z1461;
    const Scalar z1464 = z255 * z1457 + z1419;
    const Scalar z1465 = z298 - z1395 * z1438;
    const Scalar z1466 = z1410 * z1465;
    const Scalar z1467 = n1_over_94 + n25_over_7 * z336 * z336 + z264 * z264 / z125 + z289 * z289 / z80 + z331 * z331
        / z6 + z297 * z297 / z62;
    const Scalar z1468 = z125 * z1467;
    const Scalar z1469 = z1412 * z1402 - z1405;
    const Scalar z1470 = z1396 * z1417;
    const Scalar z1471 = z1411 * z1402;
    const Scalar z1472 = z255 * z1466 - z298;
    const Scalar z1473 = z265 * z1466 + z1438;
    const Scalar z1474 = z1394 * z1473;
    const Scalar z1475 = z304 * z304 * (n25_over_3 + n1 / z62) + n1_over_94 + z301 * z301 / z80 + z257 * z257 / z125;
    const Scalar z1476 = n94 * z1475;
    const Scalar z1477 = z1400 * z1402 - z1471 - z1408 - z1395 * z1469;
    const Scalar z1478 = z1141 - z1243 * z1398;
    const Scalar z1479 = z1243 * z1399 - z1381;
    const Scalar z1480 = z315 * z1398 + z1179 - z1106 * z1457;
    const Scalar z1481 = z1103 - z1478;
    const Scalar z1482 = z1411 * z1481 + z1480;
    const Scalar z1483 = z1036 * z1457 - z1160 - z1271 * z1398 + z428 * z1463;
    const Scalar z1484 = z1350 + z1271 * z1399 + z1036 * z1444 + z428 * z1459;
    const Scalar z1485 = z1174 - z1279 * z1398 - z1115 * z1457 + z430 * z1463;
    const Scalar z1486 = z1279 * z1399 + z1392 - z1115 * z1444 + z430 * z1459;
    const Scalar z1487 = z344 * z1398 + z1190 + z1119 * z1457;
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
    const Scalar z1502 = z315 * z1470 + z1106 * z1452;
    const Scalar z1503 = z315 * z1399 + z1106 * z1444;
    const Scalar z1504 = z1469 - z1492 + z265 * z1501;
    const Scalar z1505 = z255 * z1501 + z1471;
    const Scalar z1506 = z1411 * z1479 + z1503;
    const Scalar z1507 = z1394 * z1504;
    const Scalar z1508 = z1163 + z1263 * z1398;
    const Scalar z1509 = z1263 * z1399 - z1380;
    const Scalar z1510 = z1207 + z1313 * z1398;
    const Scalar z1511 = z1313 * z1399 + z1389;
    const Scalar z1512 = z1400 * z1479 - z1506 - z1486 - z1395 * z1489;
    const Scalar z1513 = z1410 * z1500;
    const Scalar z1514 = z255 * z1513 + z1482;
    const Scalar z1515 = z1488 - z1497 + z265 * z1513;
    const Scalar z1516 = z315 * z1493 + z1106 * z1501;
    const Scalar z1517 = z315 - z1106 * z1466;
    const Scalar z1518 = z1106 * z1451;
    const Scalar z1519 = z1394 * z1515;
    const Scalar z1520 = z1036 * z1451 + z428 * z1460;
    const Scalar z1521 = z1271 * z1470 + z1036 * z1452 + z428 * z1462;
    const Scalar z1522 = z1271 * z1493 + z1036 * z1501 + z428 * z1507;
    const Scalar z1523 = z1036 * z1466 + z428 * z1474;
    const Scalar z1524 = z1279 * z1470 - z1115 * z1452 + z430 * z1462;
    const Scalar z1525 = z1279 * z1493 - z1115 * z1501 + z430 * z1507;
    const Scalar z1526 = z430 * z1460 - z1115 * z1451;
    const Scalar z1527 = z430 * z1474 - z1115 * z1466;
    const Scalar z1528 = z1395 * z1523 + z1517 - z1527;
    const Scalar z1529 = z344 * z1470 - z1119 * z1452;
    const Scalar z1530 = z1119 * z1451;
    const Scalar z1531 = z344 * z1399 - z1119 * z1444;
    const Scalar z1532 = z1217 + z1319 * z1398;
    const Scalar z1533 = z1416 * z1479 + z1531 + z1422 * z1512;
    const Scalar z1534 = z1396 * z1479;
    const Scalar z1535 = z344 * z1493 - z1119 * z1501;
    const Scalar z1536 = z344 + z1119 * z1466;
    const Scalar z1537 = z1498 + z1508;
    const Scalar z1538 = z1499 + z1509;
    const Scalar z1539 = z1229 - z1502;
    const Scalar z1540 = z1319 * z1399 + z1391;
    const Scalar z1541 = z1066 + z1518;
    const Scalar z1542 = z1062 + z1520;
    const Scalar z1543 = z1521 + z1510;
    const Scalar z1544 = z1522 + z1511;
    const Scalar z1545 = z1524 - z1532;
    const Scalar z1546 = z1525 - z1540;
    const Scalar z1547 = z1135 + z1526;
    const Scalar z1548 = z1236 + z1529;
    const Scalar z1549 = z1069 - z1530;
    const Scalar z1550 = z1110 + z1537;
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
    const Scalar z1567 = z255 * z1563 - z1517;
    const Scalar z1568 = z255 * z1564 + z1506;
    const Scalar z1569 = z255 * z1565 + z1541;
    const Scalar z1570 = z1431 * z1566;
    const Scalar z1571 = z1489 - z1559 + z265 * z1564;
    const Scalar z1572 = z265 * z1563 - z1523 - z1557;
    const Scalar z1573 = z1395 * z1570 + z1555;
    const Scalar z1574 = z265 * z1565 - z1542 - z1558;
    const Scalar z1575 = z1394 * z1571;
    const Scalar z1576 = z1411 * z1538 + z1516;
    const Scalar z1577 = z1412 * z1538 - z1544;
    const Scalar z1578 = z1400 * z1538 - z1576 - z1546 - z1395 * z1577;
    const Scalar z1579 = z1396 * z1550;
    const Scalar z1580 = z1410 * z1573;
    const Scalar z1581 = z255 * z1580 + z1551;
    const Scalar z1582 = z1552 - z1570 + z265 * z1580;
    const Scalar z1583 = z1394 * z1572;
    const Scalar z1584 = z42 * z1398 - z87 - z49 * z140 - z82 * z1445 - z86 * z1457 + z83 * z1464;
    const Scalar z1585 = z1004 - z1005;
    const Scalar z1586 = z1006 + z1411 * z1585;
    const Scalar z1587 = z1010 - z1412 * z1585;
    const Scalar z1588 = z49 - z130 * z1399;
    const Scalar z1589 = z1416 * z1538 + z1535 + z1422 * z1578;
    const Scalar z1590 = z1400 * z1585 - z1586 + z1011 + z1395 * z1587;
    const Scalar z1591 = z1431 * z1589;
    const Scalar z1592 = z1396 * z1538;
    const Scalar z1593 = z1395 * z1591 + z1578;
    const Scalar z1594 = z80 + z115 * z140 + z126 * z1398 - z148 * z1445 - z150 * z1457 - z149 * z1464 + z29 * z1463;
    const Scalar z1595 = z1012 - z1416 * z1585 - z1422 * z1590;
    const Scalar z1596 = z1396 * z1585;
    const Scalar z1597 = z115 + n94 * z140 + z130 * z1398;
    const Scalar z1598 = z126 + z130 * z140 + z62 * z1398 + z85 * z1445 - z122 * z1457 + z84 * z1464 + z17 * z1463;
    const Scalar z1599 = z1431 * z1595;
    const Scalar z1600 = z1395 * z1599 - z1590;
    const Scalar z1601 = z85 * z1439 - z42 - z62 * z1399 - z122 * z1444 + z84 * z1448 + z17 * z1459;
    const Scalar z1602 = z6 + z42 * z1399 + z82 * z1439 + z86 * z1444 - z83 * z1448;
    const Scalar z1603 = z83 + z84 * z1399 + z117 * z1444 - n94 * z1448;
    const Scalar z1604 = z82 - z85 * z1399 + n94 * z1439 - z116 * z1444;
    const Scalar z1605 = z85 * z1398 - z148 + n94 * z1445 - z116 * z1457;
    const Scalar z1606 = z116 * z1439 - z86 - z122 * z1399 - z125 * z1444 + z117 * z1448 + z45 * z1459;
    const Scalar z1607 = z84 * z1398 - z149 - z117 * z1457 + n94 * z1464;
    const Scalar z1608 = n0_12 - z85 * z1438 - z122 * z1466 + z84 * z1472 + z17 * z1474;
    const Scalar z1609 = z150 + z122 * z1398 + z116 * z1445 - z125 * z1457 + z117 * z1464 + z45 * z1463;
    const Scalar z1610 = z18 - z116 * z1438 - z125 * z1466 + z117 * z1472 + z45 * z1474;
    const Scalar z1611 = n94 * z1438 + z116 * z1466;
    const Scalar z1612 = z117 * z1466 - n94 * z1472;
    const Scalar z1613 = z17 * z1398 + z29 - z45 * z1457 + n0_28 * z1463;
    const Scalar z1614 = z17 * z1399 + z45 * z1444 - n0_28 * z1459;
    const Scalar z1615 = z45 * z1466 - n0_28 * z1474;
    const Scalar z1616 = z1410 * z1593;
    const Scalar z1617 = z1410 * z1600;
    const Scalar z1618 = z140 * z1597 + z1445 * z1605 + z1464 * z1607 + z1463 * z1613 + z1398 * z1598 - z1457 * z1609
        + z1594;
    const Scalar z1619 = z255 * z1616 + z1576;
    const Scalar z1620 = z1577 - z1591 + z265 * z1616;
    const Scalar z1621 = z1394 * z1574;
    const Scalar z1622 = z1448 * z1603 - z1602 - z1439 * z1604 + z1459 * z1614 + z1399 * z1601 + z1444 * z1606;
    const Scalar z1623 = z1584 - z1439 * z1605 - z1448 * z1607 - z1459 * z1613 + z1399 * z1598 + z1444 * z1609;
    const Scalar z1624 = z1394 * z1582;
    const Scalar z1625 = z654 + z749 * z1398;
    const Scalar z1626 = z749 * z1399 + z832;
    const Scalar z1627 = z751 * z1398 - z694 + z698 * z1457;
    const Scalar z1628 = z750 * z1399 - z838 + z696 * z1444;
    const Scalar z1629 = z698 * z1444 - z839 - z751 * z1399;
    const Scalar z1630 = z695 - z750 * z1398 + z696 * z1457;
    const Scalar z1631 = z1394 * z1620;
    const Scalar z1632 = z677 * z1466 - z758 + z835 * z1474;
    const Scalar z1633 = z740 * z1398 - z746 - z747 * z1457 + z829 * z1463;
    const Scalar z1634 = z671 * z1398 - z681 - z703 * z1457 - z823 * z1463;
    const Scalar z1635 = z671 * z1399 - z785 + z703 * z1444 + z823 * z1459;
    const Scalar z1636 = z686 - z761 * z1398 + z693 * z1457 + z837 * z1463;
    const Scalar z1637 = z761 * z1399 - z842 + z693 * z1444 + z837 * z1459;
    const Scalar z1638 = z760 * z1398 - z713 + z677 * z1457 + z835 * z1463;
    const Scalar z1639 = z841 - z760 * z1399 + z677 * z1444 + z835 * z1459;
    const Scalar z1640 = z255 * z1617 - z1586;
    const Scalar z1641 = z1587 - z1599 + z265 * z1617;
    const Scalar z1642 = z1394 * z1641;
    const Scalar z1643 = z828 - z824 * z1399 - z837 * z1444;
    const Scalar z1644 = z140 * z1626 - z1464 * z1628 - z1463 * z1643 + z1445 * z1629 - z1398 * z1635 + z1457 * z1637
        + z1639;
    const Scalar z1645 = z791 - z763 * z1457;
    const Scalar z1646 = z824 * z1398 + z836 - z837 * z1457;
    const Scalar z1647 = z140 * z1625 - z1445 * z1627 + z1464 * z1630 + z1463 * z1646 - z1398 * z1634 - z1457 * z1636
        - z1638;
    const Scalar z1648 = n0_12 - z18 * z1466;
    const Scalar z1649 = z1438 * z1611 + z1648 - z1472 * z1612 - z1474 * z1615 - z1466 * z1610;
    const Scalar z1650 = n0_12 * z1399 + z18 * z1444;
    const Scalar z1651 = z18 * z1457 - n0_12 * z1398;
    const Scalar z1652 = z1633 + z1448 * z1630 - z1439 * z1627 + z1459 * z1646 + z1399 * z1634 - z1444 * z1636;
    const Scalar z1653 = z1645 + z1438 * z1627 + z1472 * z1630 + z1474 * z1646 - z1466 * z1636;
    const Scalar z1654 = z1438 * z1604 + z1650 + z1472 * z1603 + z1474 * z1614 + z1466 * z1606;
    const Scalar z1655 = z1438 * z1605 + z1651 - z1472 * z1607 - z1474 * z1613 + z1466 * z1609;
    const Scalar z1656 = z698 * z1466;
    const Scalar z1657 = z696 * z1466;
    const Scalar z1658 = z740 * z1399 + z747 * z1444 - z829 * z1459;
    const Scalar z1659 = z1658 + z1439 * z1629 - z1448 * z1628 - z1459 * z1643 + z1399 * z1635 + z1444 * z1637;
    const Scalar z1660 = z747 * z1466 - z829 * z1474;
    const Scalar z1661 = z763 * z1444;
    const Scalar z1662 = z1472 * z1628 - z1661 + z1474 * z1643 + z1438 * z1629 - z1466 * z1637;
    const Scalar z1663 = z763 * z1466;
    const Scalar z1664 = z837 * z1466;
    const Scalar z1665 = z703 * z1466 + z823 * z1474;
    const Scalar z1666 = z693 * z1466 + z763 + z837 * z1474;
    const Scalar z1667 = z1464 * z1657 - z1632 - z1445 * z1656 - z1463 * z1664 + z1398 * z1665 - z1457 * z1666;
    const Scalar z1668 = z1660 + z1439 * z1656 - z1448 * z1657 + z1459 * z1664 + z1399 * z1665 + z1444 * z1666;
    const Scalar z1669 = z1438 * z1656 - z1663 + z1472 * z1657 - z1474 * z1664 - z1466 * z1666;
    const Scalar z1670 = z1103 * z1597 + z1496 * z1598 - z1497 * z1605 + z1513 * z1609 - z1514 * z1607 - z1519 * z1613;
    const Scalar z1671 = z1670 + z1647;
    const Scalar z1672 = z1103 * z1588 + z1496 * z1601 - z1497 * z1604 + z1513 * z1606 + z1514 * z1603 + z1519 * z1614;
    const Scalar z1673 = z1496 * z1608 + z1497 * z1611 + z1513 * z1610 + z1514 * z1612 + z1519 * z1615;
    const Scalar z1674 = z1672 + z1652;
    const Scalar z1675 = z1673 + z1653;
    const Scalar z1676 = z1559 * z1605 - z1534 * z1598 - z1564 * z1609 + z1568 * z1607 + z1575 * z1613;
    const Scalar z1677 = z1676 - z1644;
    const Scalar z1678 = z1557 * z1605 - z1563 * z1609 + z1567 * z1607 + z1583 * z1613;
    const Scalar z1679 = z1678 + z1667;
    const Scalar z1680 = z698 * z1451;
    const Scalar z1681 = z698 * z1452 - z751 * z1470;
    const Scalar z1682 = z1559 * z1604 - z1534 * z1601 - z1564 * z1606 - z1568 * z1603 - z1575 * z1614;
    const Scalar z1683 = z1534 * z1608 + z1559 * z1611 + z1564 * z1610 + z1568 * z1612 + z1575 * z1615;
    const Scalar z1684 = z698 * z1501 - z751 * z1493;
    const Scalar z1685 = z1682 - z1659;
    const Scalar z1686 = z1683 - z1662;
    const Scalar z1687 = z1557 * z1604 - z1563 * z1606 - z1567 * z1603 - z1583 * z1614;
    const Scalar z1688 = z1557 * z1611 + z1563 * z1610 + z1567 * z1612 + z1583 * z1615;
    const Scalar z1689 = z717 - z1680;
    const Scalar z1690 = z1687 - z1668;
    const Scalar z1691 = z1688 - z1669;
    const Scalar z1692 = z685 - z692 * z1398;
    const Scalar z1693 = z692 * z1399 + z782;
    const Scalar z1694 = z701 - z705 * z1398;
    const Scalar z1695 = z705 * z1399 - z786;
    const Scalar z1696 = z930 + z987 * z1398;
    const Scalar z1697 = z987 * z1399 - z1047;
    const Scalar z1698 = z922 - z984 * z1398;
    const Scalar z1699 = z984 * z1399 + z1045;
    const Scalar z1700 = z702 - z706 * z1398;
    const Scalar z1701 = z706 * z1399 - z787;
    const Scalar z1702 = z1681 + z1700;
    const Scalar z1703 = z1684 - z1701;
    const Scalar z1704 = z931 + z990 * z1398;
    const Scalar z1705 = z990 * z1399 - z1052;
    const Scalar z1706 = z873 - z928 * z1398;
    const Scalar z1707 = z928 * z1399 - z989;
    const Scalar z1708 = z932 + z992 * z1398;
    const Scalar z1709 = z992 * z1399 - z1055;
    const Scalar z1710 = z749 * z1470;
    const Scalar z1711 = z1710 - z1692;
    const Scalar z1712 = z749 * z1493;
    const Scalar z1713 = z1712 + z1693;
    const Scalar z1714 = z750 * z1470 + z696 * z1452;
    const Scalar z1715 = z1714 + z1694;
    const Scalar z1716 = z750 * z1493 + z696 * z1501;
    const Scalar z1717 = z1716 - z1695;
    const Scalar z1718 = z696 * z1451;
    const Scalar z1719 = z718 + z1718;
    const Scalar z1720 = z677 * z1451 + z835 * z1460;
    const Scalar z1721 = z703 * z1451 + z823 * z1460;
    const Scalar z1722 = z747 * z1451 - z829 * z1460;
    const Scalar z1723 = z693 * z1451 + z837 * z1460;
    const Scalar z1724 = z877 + z1723;
    const Scalar z1725 = z740 * z1470 + z747 * z1452 - z829 * z1462;
    const Scalar z1726 = z740 * z1493 + z747 * z1501 - z829 * z1507;
    const Scalar z1727 = z824 * z1470 + z837 * z1452;
    const Scalar z1728 = z824 * z1493 + z837 * z1501;
    const Scalar z1729 = z763 * z1451;
    const Scalar z1730 = z837 * z1451;
    const Scalar z1731 = z763 * z1452;
    const Scalar z1732 = z763 * z1501;
    const Scalar z1733 = z671 * z1470 + z703 * z1452 + z823 * z1462;
    const Scalar z1734 = z671 * z1493 + z703 * z1501 + z823 * z1507;
    const Scalar z1735 = z693 * z1452 + z761 * z1470 + z837 * z1462;
    const Scalar z1736 = z693 * z1501 + z761 * z1493 + z837 * z1507;
    const Scalar z1737 = z677 * z1452 - z760 * z1470 + z835 * z1462;
    const Scalar z1738 = z677 * z1501 - z760 * z1493 + z835 * z1507;
    const Scalar z1739 = z1558 * z1605 - z1565 * z1609 + z1569 * z1607 + z1621 * z1613;
    const Scalar z1740 = z1735 + z1706;
    const Scalar z1741 = z1110 * z1597 + z1579 * z1598 - z1570 * z1605 + z1580 * z1609 - z1581 * z1607 - z1624 * z1613;
    const Scalar z1742 = z1736 - z1707;
    const Scalar z1743 = z1110 * z1588 + z1579 * z1601 - z1570 * z1604 + z1580 * z1606 + z1581 * z1603 + z1624 * z1614;
    const Scalar z1744 = z1579 * z1608 + z1570 * z1611 + z1580 * z1610 + z1581 * z1612 + z1624 * z1615;
    const Scalar z1745 = z1591 * z1605 - z1592 * z1598 - z1616 * z1609 + z1619 * z1607 + z1631 * z1613;
    const Scalar z1746 = z864 + z1720;
    const Scalar z1747 = z1558 * z1604 - z1565 * z1606 - z1569 * z1603 - z1621 * z1614;
    const Scalar z1748 = z1558 * z1611 + z1565 * z1610 + z1569 * z1612 + z1621 * z1615;
    const Scalar z1749 = z1737 - z1708;
    const Scalar z1750 = z1738 - z1709;
    const Scalar z1751 = z1591 * z1604 - z1592 * z1601 - z1616 * z1606 - z1619 * z1603 - z1631 * z1614;
    const Scalar z1752 = z1592 * z1608 + z1591 * z1611 + z1616 * z1610 + z1619 * z1612 + z1631 * z1615;
    const Scalar z1753 = z1004 * z1597 + z1599 * z1605 + z1640 * z1607 + z1642 * z1613 - z1617 * z1609 + z1596 * z1598;
    const Scalar z1754 = z1004 * z1588 + z1599 * z1604 - z1640 * z1603 - z1642 * z1614 - z1617 * z1606 + z1596 * z1601;
    const Scalar z1755 = z1599 * z1611 + z1640 * z1612 + z1642 * z1615 + z1617 * z1610 - z1596 * z1608;
    const Scalar z1756 = l_lambda_rear_rolls_x * z257 + l_lambda_rear_rolls_y * z255 + l_lambda_front_rolls_x * z265
        + l_lambda_front_rolls_y * z264 - z1053;
    const Scalar z1757 = l_lambda_rear_rolls_x * z304 - z1008 + l_lambda_rear_rolls_y * z298 + l_lambda_front_touches
        * z249 + l_lambda_front_rolls_x * z299 + l_lambda_front_rolls_y * z297;
    const Scalar z1758 = l_lambda_front_rolls_x * z327 - z480 + l_lambda_front_rolls_y * z336;
    const Scalar z1759 = z867 + z1721;
    const Scalar z1760 = z870 + z1722;
    const Scalar z1761 = z1725 + z1696;
    const Scalar z1762 = z1726 + z1697;
    const Scalar z1763 = z1727 + z1698;
    const Scalar z1764 = z1728 - z1699;
    const Scalar z1765 = z868 - z1729;
    const Scalar z1766 = z925 - z1731;
    const Scalar z1767 = z874 - z1730;
    const Scalar z1768 = z1733 - z1704;
    const Scalar z1769 = z1734 - z1705;
    const Scalar z1770 = z140 * z1711 - z1464 * z1715 + z1463 * z1763 + z1445 * z1702 - z1398 * z1768 + z1457 * z1740
        + z1749;
    const Scalar z1771 = z140 * z1713 - z1464 * z1717 + z1463 * z1764 + z1445 * z1703 - z1398 * z1769 + z1457 * z1742
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
    const Scalar z1783 = l_lambda_rear_touches + l_lambda_front_touches - z571;
    const Scalar z1784 = z1445 * z1689 - z1746 + z1464 * z1719 + z1463 * z1767 + z1398 * z1759 - z1457 * z1724;
    const Scalar z1785 = z1760 + z1399 * z1759 - z1439 * z1689 - z1448 * z1719 - z1459 * z1767 + z1444 * z1724;
    const Scalar z1786 = z1438 * z1689 - z1765 - z1472 * z1719 - z1474 * z1767 + z1466 * z1724;
    const Scalar z1787 = z1739 + z1784;
    const Scalar z1788 = z1747 - z1785;
    const Scalar z1789 = z1748 + z1786;
    const Scalar z1790 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z574;
    const Scalar z1791 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z579;
    const Scalar z1792 = z1048 + l_lambda_rear_rolls_x * z301 + l_lambda_rear_rolls_y * z306 + l_lambda_front_touches
        * z250 + l_lambda_front_rolls_x * z281 + l_lambda_front_rolls_y * z289 - z140 * (l_lambda_rear_touches - z1783)
        - z1398 * z1757 - z1445 * z1790 + z1457 * z1756 - z1464 * z1791 - z1463 * z1758;
    const Scalar z1793 = l_lambda_front_touches * z253 - z1009 + l_lambda_front_rolls_x * z330 + l_lambda_front_rolls_y
        * z331 - z1399 * z1757 + z1439 * z1790 - z1444 * z1756 + z1448 * z1791 + z1459 * z1758;
    const Scalar z1794 = l_lambda_rear_rolls_x * z304 - z465 + l_lambda_rear_rolls_y * z298 - z1438 * z1790 - z1466
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
    result.M[3] = z116;
    result.M[4] = -z148;
    result.M[5] = z85;
    result.M[6] = z82;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z117;
    result.M[13] = z149;
    result.M[14] = -z84;
    result.M[15] = z83;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z115;
    result.M[23] = z130;
    result.M[24] = z49;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z116;
    result.M[28] = -z117;
    result.M[29] = n0;
    result.M[30] = z125;
    result.M[31] = z150;
    result.M[32] = z122;
    result.M[33] = -z86;
    result.M[34] = z18;
    result.M[35] = z45;
    result.M[36] = -z148;
    result.M[37] = z149;
    result.M[38] = z115;
    result.M[39] = z150;
    result.M[40] = z80;
    result.M[41] = z126;
    result.M[42] = z87;
    result.M[43] = n0;
    result.M[44] = z29;
    result.M[45] = z85;
    result.M[46] = -z84;
    result.M[47] = z130;
    result.M[48] = z122;
    result.M[49] = z126;
    result.M[50] = z62;
    result.M[51] = -z42;
    result.M[52] = n0_12;
    result.M[53] = z17;
    result.M[54] = z82;
    result.M[55] = z83;
    result.M[56] = z49;
    result.M[57] = -z86;
    result.M[58] = z87;
    result.M[59] = -z42;
    result.M[60] = z6;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z18;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z45;
    result.M[76] = z29;
    result.M[77] = z17;
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
    result.C[27] = z698;
    result.C[28] = z696;
    result.C[29] = n0;
    result.C[30] = -z693;
    result.C[31] = z677;
    result.C[32] = -z703;
    result.C[33] = z747;
    result.C[34] = z763;
    result.C[35] = z837;
    result.C[36] = z694;
    result.C[37] = -z695;
    result.C[38] = z654;
    result.C[39] = z686;
    result.C[40] = z713;
    result.C[41] = z681;
    result.C[42] = -z746;
    result.C[43] = z791;
    result.C[44] = z836;
    result.C[45] = -z751;
    result.C[46] = z750;
    result.C[47] = z749;
    result.C[48] = -z761;
    result.C[49] = -z760;
    result.C[50] = -z671;
    result.C[51] = z740;
    result.C[52] = n0;
    result.C[53] = z824;
    result.C[54] = z839;
    result.C[55] = z838;
    result.C[56] = -z832;
    result.C[57] = -z842;
    result.C[58] = -z841;
    result.C[59] = -z785;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z828;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z763;
    result.C[67] = z758;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = z837;
    result.C[76] = -z835;
    result.C[77] = z823;
    result.C[78] = z829;
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
    result.K[27] = z717;
    result.K[28] = -z718;
    result.K[29] = n0;
    result.K[30] = z877;
    result.K[31] = -z864;
    result.K[32] = z867;
    result.K[33] = -z870;
    result.K[34] = z868;
    result.K[35] = z874;
    result.K[36] = z702;
    result.K[37] = z701;
    result.K[38] = -z685;
    result.K[39] = -z873;
    result.K[40] = -z932;
    result.K[41] = z931;
    result.K[42] = z930;
    result.K[43] = -z925;
    result.K[44] = z922;
    result.K[45] = -z706;
    result.K[46] = -z705;
    result.K[47] = z692;
    result.K[48] = z928;
    result.K[49] = -z992;
    result.K[50] = z990;
    result.K[51] = z987;
    result.K[52] = n0;
    result.K[53] = -z984;
    result.K[54] = -z787;
    result.K[55] = -z786;
    result.K[56] = -z782;
    result.K[57] = z989;
    result.K[58] = -z1055;
    result.K[59] = z1052;
    result.K[60] = z1047;
    result.K[61] = n0;
    result.K[62] = z1045;
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
    result.F[0] = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z574;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z579;
    result.F[2] = -l_lambda_rear_touches - l_lambda_front_touches + z571;
    result.F[3] = l_lambda_rear_rolls_x * z257 + l_lambda_rear_rolls_y * z255 + l_lambda_front_rolls_x * z265
        + l_lambda_front_rolls_y * z264 - z1053;
    result.F[4] = -l_lambda_rear_rolls_x * z301 + l_lambda_rear_touches * z140 - l_lambda_rear_rolls_y * z306
        - l_lambda_front_touches * z250 - l_lambda_front_rolls_x * z281 - l_lambda_front_rolls_y * z289 - z1048;
    result.F[5] = l_lambda_rear_rolls_x * z304 - z1008 + l_lambda_rear_rolls_y * z298 + l_lambda_front_touches * z249
        + l_lambda_front_rolls_x * z299 + l_lambda_front_rolls_y * z297;
    result.F[6] = l_lambda_front_touches * z253 - z1009 + l_lambda_front_rolls_x * z330 + l_lambda_front_rolls_y * z331;
    result.F[7] = l_lambda_rear_rolls_x * z304 - z465 + l_lambda_rear_rolls_y * z298;
    result.F[8] = l_lambda_front_rolls_x * z327 - z480 + l_lambda_front_rolls_y * z336;
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
    result.A[36] = -z1462;
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
    result.A[71] = -z1464;
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
