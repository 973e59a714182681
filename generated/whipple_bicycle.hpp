// SPDX-License-Identifier: MIT
// whipple_bicycle: Whipple's bicycle: two rolling wheels, benchmark of 2007
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   forward_dynamics       1098             1467         26             2                  4       0   2601    2785
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             339              520         14             2                  4       0    883     941
//   linearisation          2887             3784        107             2                  6       0   6792    7263
//
// Not computed because this mechanism does not need it:
//   energy: of 3 results 1 vanish identically
//   constraints: of 72 results 30 vanish identically, 2 repeat another up to sign
//   linearisation: of 394 results 187 vanish identically, 26 repeat another up to sign
//
// To write this file again:
//   whipple_bicycle_scene generate --kernels forward_dynamics,energy,first_integrals,constraints,linearisation --output whipple_bicycle.hpp
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
  static constexpr unsigned long long fingerprint = 0xa9fd5eed3fcf6651ULL;
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
    const Scalar z449 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z450 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z31 - k4 * z32;
    });
    const Scalar z451 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z31 - k5 * z32;
    });
    const Scalar z587 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z450 - z32 * z451;
    });
    const Scalar z601 = traits::formula(6.497839117007668, 6.497839f, [&]() -> Scalar {
      return n1 / z587;
    });
    const Scalar z889 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z890 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z891 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z907 = -z890 * (n1 - c_steer);
    const Scalar z908 = z31 * s_steer;
    const Scalar z909 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z905 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z906 = z32 * s_steer;
    const Scalar z910 = s_yaw * c_roll;
    const Scalar z914 = n1 - s_roll * s_roll;
    const Scalar z911 = c_yaw * c_roll;
    const Scalar z923 = v_roll * s_roll;
    const Scalar z922 = v_yaw * c_yaw;
    const Scalar z921 = v_roll * c_roll;
    const Scalar z926 = v_yaw * s_yaw;
    const Scalar z933 = s_yaw * s_roll;
    const Scalar z929 = n2 * s_roll;
    const Scalar z935 = c_yaw * s_roll;
    const Scalar z912 = s_roll * z910;
    const Scalar z913 = s_roll * z911;
    const Scalar z924 = s_yaw * z923 - c_roll * z922;
    const Scalar z927 = c_yaw * z923 + c_roll * z926;
    const Scalar z930 = z921 * z929;
    const Scalar z934 = s_roll * z933 - c_roll * z910;
    const Scalar z936 = s_roll * z935 - c_roll * z911;
    const Scalar z937 = c_roll * z929;
    const Scalar z941 = v_roll * z921;
    const Scalar z942 = v_yaw * z926;
    const Scalar z943 = n2 * z923;
    const Scalar z945 = v_roll * z923;
    const Scalar z946 = n2 * z921;
    const Scalar z948 = v_yaw * z922;
    const Scalar z956 = n0_08 * z906 - n0_35 * z908;
    const Scalar z969 = s_pitch * z908 - c_pitch * z906;
    const Scalar z970 = s_pitch * z906 + c_pitch * z908;
    const Scalar z915 = z914 * z914 + z912 * z912 + z913 * z913;
    const Scalar z944 = s_yaw * z941 + c_roll * z942 + z922 * z943;
    const Scalar z949 = c_yaw * z941 + c_roll * z948 - z926 * z943;
    const Scalar z951 = n2 * (s_roll * z945 - z921 * z921);
    const Scalar z955 = n0_08 * z905 - n0_35 * z907;
    const Scalar z957 = n0_08 * z907 - n0_35 * z909;
    const Scalar z925 = s_roll * z924 - z910 * z921;
    const Scalar z928 = s_roll * z927 - z911 * z921;
    const Scalar z938 = n2 * (z914 * z937 + z912 * z934 + z913 * z936);
    const Scalar z971 = s_roll * z970 - c_roll * c_steer;
    const Scalar z972 = s_roll * c_steer + c_roll * z970;
    const Scalar z959 = n0_3 + z957;
    const Scalar z958 = n1_1 - z955;
    const Scalar z916 = traits::sqrt(z915);
    const Scalar z931 = n2 * (z914 * z930 + z912 * z925 + z913 * z928);
    const Scalar z947 = z910 * z945 + z924 * z946 + s_roll * z944;
    const Scalar z950 = z911 * z945 + z927 * z946 + s_roll * z949;
    const Scalar z973 = c_yaw * z969 + s_yaw * z971;
    const Scalar z952 = n2 * (z912 * z947 + z913 * z950 - z914 * z951 - z925 * z925 - z928 * z928 - z930 * z930);
    const Scalar z975 = z972 * z973;
    const Scalar z974 = s_yaw * z969 - c_yaw * z971;
    const Scalar z976 = z972 * z974;
    const Scalar z961 = s_pitch * z958 - c_pitch * z959;
    const Scalar z962 = s_roll * z961 - c_roll * z956;
    const Scalar z960 = s_pitch * z959 + c_pitch * z958;
    const Scalar z939 = n0_5 * z938 / z916;
    const Scalar z963 = s_roll * z956 + c_roll * z961;
    const Scalar z966 = q_z - z963;
    const Scalar z917 = n0_3 / z916;
    const Scalar z977 = n1 - z972 * z972;
    const Scalar z964 = s_yaw * z962 - c_yaw * z960;
    const Scalar z965 = s_yaw * z960 + c_yaw * z962;
    const Scalar z932 = n0_5 * z931 / z916;
    const Scalar z967 = q_y + z965;
    const Scalar z968 = q_x - z964;
    const Scalar z918 = q_x + z912 * z917;
    const Scalar z978 = z977 * z977 + z975 * z975 + z976 * z976;
    const Scalar z953 = n0_5 * (z931 * z932 / (z916 * z916) + z952 / z916);
    const Scalar z940 = n0_3 * z939;
    const Scalar z920 = q_z + z914 * z917;
    const Scalar z919 = q_y - z913 * z917;
    const Scalar z979 = traits::sqrt(z978);
    const Scalar z1013 = c_yaw * z972;
    const Scalar z1007 = n2 * z972;
    const Scalar z988 = v_pitch * c_pitch;
    const Scalar z993 = v_pitch * s_pitch;
    const Scalar z984 = v_steer * c_steer;
    const Scalar z989 = v_steer * s_steer;
    const Scalar z1011 = s_yaw * z972;
    const Scalar z1012 = z971 * z973 - z972 * z1011;
    const Scalar z985 = z32 * z984;
    const Scalar z986 = z31 * z984;
    const Scalar z999 = z906 * z988 - z908 * z993 + s_pitch * z985 + c_pitch * z986;
    const Scalar z1002 = z906 * z993 + z908 * z988 + s_pitch * z986 - c_pitch * z985;
    const Scalar z991 = z890 * z989;
    const Scalar z990 = -z989 * (n1 - z889);
    const Scalar z992 = n0_35 * z991 + n0_08 * z990;
    const Scalar z954 = n0_3 * z953;
    const Scalar z1014 = z972 * z1013 + z971 * z974;
    const Scalar z980 = n0_35 / z979;
    const Scalar z1030 = z32 * c_steer;
    const Scalar z1031 = z31 * c_steer;
    const Scalar z1021 = s_roll * z969;
    const Scalar z1040 = s_pitch * z1030 + c_pitch * z1031;
    const Scalar z1022 = s_yaw * z1021 - c_yaw * z970;
    const Scalar z1024 = s_yaw * z970 + c_yaw * z1021;
    const Scalar z1020 = c_roll * z969;
    const Scalar z1025 = z972 * z1024 - z974 * z1020;
    const Scalar z1015 = z971 * z1007;
    const Scalar z1016 = n2 * (z976 * z1014 - z977 * z1015 + z975 * z1012);
    const Scalar z1023 = z972 * z1022 + z973 * z1020;
    const Scalar z1026 = z1007 * z1020;
    const Scalar z981 = z968 - z975 * z980;
    const Scalar z983 = z966 + z977 * z980;
    const Scalar z1027 = n2 * (z975 * z1023 - z976 * z1025 - z977 * z1026);
    const Scalar z982 = z967 - z976 * z980;
    const Scalar z1017 = n0_5 * z1016 / z979;
    const Scalar z1043 = s_pitch * z1031 - c_pitch * z1030;
    const Scalar z1032 = n0_08 * z1030 - n0_35 * z1031;
    const Scalar z1042 = c_roll * s_steer + s_roll * z1040;
    const Scalar z1041 = s_roll * s_steer - c_roll * z1040;
    const Scalar z1044 = c_yaw * z1043 + s_yaw * z1042;
    const Scalar z1046 = s_yaw * z1043 - c_yaw * z1042;
    const Scalar z1045 = z972 * z1044 - z973 * z1041;
    const Scalar z1028 = n0_5 * z1027 / z979;
    const Scalar z1034 = s_steer * z890;
    const Scalar z1033 = s_steer * (n1 - z889);
    const Scalar z1035 = n0_08 * z1033 - n0_35 * z1034;
    const Scalar z1036 = s_steer * (n1 - z891);
    const Scalar z1037 = n0_08 * z1034 - n0_35 * z1036;
    const Scalar z1018 = z962 - n0_35 * z1017;
    const Scalar z1001 = c_roll * z989 + c_steer * z923 + z921 * z970 + s_roll * z999;
    const Scalar z1038 = c_pitch * z1037 + s_pitch * z1035;
    const Scalar z1005 = z922 * z969 + z926 * z971 + s_yaw * z1002 - c_yaw * z1001;
    const Scalar z1039 = s_roll * z1032 + c_roll * z1038;
    const Scalar z1000 = s_roll * z989 - c_steer * z921 + z923 * z970 - c_roll * z999;
    const Scalar z1003 = z922 * z971 - z926 * z969 + c_yaw * z1002 + s_yaw * z1001;
    const Scalar z1008 = z1000 * z1007;
    const Scalar z1006 = z972 * z1005 - z974 * z1000;
    const Scalar z994 = -z989 * (n1 - z891);
    const Scalar z995 = n0_08 * z991 + n0_35 * z994;
    const Scalar z1019 = c_roll * z960;
    const Scalar z1029 = z1019 + n0_35 * z1028;
    const Scalar z1004 = z972 * z1003 - z973 * z1000;
    const Scalar z987 = n0_08 * z985 - n0_35 * z986;
    const Scalar z1048 = z1007 * z1041;
    const Scalar z1047 = z972 * z1046 - z974 * z1041;
    const Scalar z1049 = n2 * (z977 * z1048 + z975 * z1045 + z976 * z1047);
    const Scalar z1052 = v_steer * z989;
    const Scalar z1053 = z32 * z1052;
    const Scalar z1054 = z31 * z1052;
    const Scalar z1009 = n2 * (z977 * z1008 + z976 * z1006 + z975 * z1004);
    const Scalar z996 = s_pitch * z992 - c_pitch * z995 - z958 * z988 - z959 * z993;
    const Scalar z1056 = v_steer * z984;
    const Scalar z1010 = n0_5 * z1009 / z979;
    const Scalar z1050 = n0_5 * z1049 / z979;
    const Scalar z997 = z921 * z956 + s_roll * z987 - z923 * z961 - c_roll * z996;
    const Scalar z998 = v_z - z997;
    const Scalar z1086 = n0_3 * z932 / (z916 * z916);
    const Scalar z1089 = v_z - z917 * z930 + z914 * z1086;
    const Scalar z1087 = v_y + z917 * z928 - z913 * z1086;
    const Scalar z1094 = v_x - z917 * z925 + z912 * z1086;
    const Scalar z1081 = q_z - z920;
    const Scalar z1079 = q_x - z918;
    const Scalar z1080 = q_y - z919;
    const Scalar z1090 = v_z - z1089;
    const Scalar z1088 = v_y - z1087;
    const Scalar z1095 = v_x - z1094;
    const Scalar z1107 = s_pitch * z31 - c_pitch * z32;
    const Scalar z1051 = z1039 - n0_35 * z1050;
    const Scalar z1113 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1114 = s_roll * z1113;
    const Scalar z1112 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z1108 = s_roll * z1107;
    const Scalar z1106 = s_pitch * z32 + c_pitch * z31;
    const Scalar z1099 = q_x - z981;
    const Scalar z1109 = c_roll * z1107;
    const Scalar z1101 = q_z - z983;
    const Scalar z1110 = s_yaw * z1108 - c_yaw * z1106;
    const Scalar z1103 = c_yaw * z1101;
    const Scalar z1105 = s_roll * z1099 + z910 * z1101;
    const Scalar z1100 = q_y - z982;
    const Scalar z1111 = s_yaw * z1106 + c_yaw * z1108;
    const Scalar z1102 = s_yaw * z1101;
    const Scalar z1104 = s_roll * z1100 - z911 * z1101;
    const Scalar z1083 = c_yaw * z1081;
    const Scalar z1082 = s_yaw * z1081;
    const Scalar z1062 = v_pitch * z993;
    const Scalar z1063 = v_pitch * z988;
    const Scalar z1066 = z906 * z1062 + z908 * z1063 + s_pitch * z1053 + c_pitch * z1054 - n2 * (z985 * z988 - z986
        * z993);
    const Scalar z1068 = z908 * z1062 - z906 * z1063 + s_pitch * z1054 - c_pitch * z1053 - n2 * (z985 * z993 + z986
        * z988);
    const Scalar z1055 = n0_08 * z1053 - n0_35 * z1054;
    const Scalar z1116 = s_yaw * z1114 - c_yaw * z1112;
    const Scalar z1115 = c_roll * z1113;
    const Scalar z1085 = s_roll * z1079 + z910 * z1081;
    const Scalar z1071 = n2 * z1000;
    const Scalar z1084 = s_roll * z1080 - z911 * z1081;
    const Scalar z1067 = z945 * z970 - c_roll * z1056 - c_steer * z941 - n2 * (z921 * z999 - z923 * z989) + s_roll
        * z1066;
    const Scalar z1070 = s_roll * z1056 + c_steer * z945 + z941 * z970 + n2 * (z921 * z989 + z923 * z999) + c_roll
        * z1066;
    const Scalar z1073 = z942 * z969 - z948 * z971 - n2 * (z922 * z1002 + z926 * z1001) + s_yaw * z1068 - c_yaw * z1067;
    const Scalar z1069 = z948 * z969 + z942 * z971 - n2 * (z922 * z1001 - z926 * z1002) + c_yaw * z1068 + s_yaw * z1067;
    const Scalar z1074 = z1005 * z1071 + z974 * z1070 + z972 * z1073;
    const Scalar z1072 = z1003 * z1071 + z973 * z1070 + z972 * z1069;
    const Scalar z1075 = n2 * (z972 * z1070 - z1000 * z1000);
    const Scalar z1076 = n2 * (z976 * z1074 - z1008 * z1008 - z1006 * z1006 - z1004 * z1004 - z977 * z1075 + z975
        * z1072);
    const Scalar z1058 = z890 * z1056;
    const Scalar z1057 = -z1056 * (n1 - z889);
    const Scalar z1118 = q_z - z1115;
    const Scalar z1059 = n0_35 * z1058 + n0_08 * z1057;
    const Scalar z1060 = -z1056 * (n1 - z891);
    const Scalar z1061 = n0_08 * z1058 + n0_35 * z1060;
    const Scalar z1120 = q_x - z1116;
    const Scalar z1121 = z981 - z1120;
    const Scalar z1123 = z983 - z1118;
    const Scalar z1117 = s_yaw * z1112 + c_yaw * z1114;
    const Scalar z1064 = s_pitch * z1059 - z959 * z1063 - c_pitch * z1061 + z958 * z1062 + n2 * (z988 * z992 + z993
        * z995);
    const Scalar z1119 = q_y + z1117;
    const Scalar z1077 = n0_5 * (z1009 * z1010 / (z979 * z979) + z1076 / z979);
    const Scalar z1122 = z982 - z1119;
    const Scalar z1124 = z1109 * z1122 + z1111 * z1123;
    const Scalar z1091 = z922 * z1081 + s_yaw * z1090;
    const Scalar z1096 = c_yaw * z1090 - z926 * z1081;
    const Scalar z1092 = z921 * z1080 + z927 * z1081 + s_roll * z1088 - z911 * z1090;
    const Scalar z1065 = z945 * z956 + s_roll * z1055 + z941 * z961 - n2 * (z921 * z987 + z923 * z996) + c_roll * z1064;
    const Scalar z1132 = c_roll * z987 - z923 * z956 - z921 * z961 + s_roll * z996;
    const Scalar z1131 = s_pitch * z995 + c_pitch * z992 + z958 * z993 - z959 * z988;
    const Scalar z1093 = v_yaw * z1088 - v_roll * z1091 + z1092 * (v_pitch + v_rear);
    const Scalar z1126 = z968 - z981;
    const Scalar z1128 = z966 - z983;
    const Scalar z1127 = z967 - z982;
    const Scalar z1135 = n0_35 * z1010 / (z979 * z979);
    const Scalar z1097 = z921 * z1079 - z924 * z1081 + s_roll * z1095 + z910 * z1090;
    const Scalar z1098 = v_yaw * z1095 - v_roll * z1096 + z1097 * (v_pitch + v_rear);
    const Scalar z1078 = z1065 - n0_35 * z1077;
    const Scalar z1138 = z977 * z1135 - z998 - z980 * z1008;
    const Scalar z1158 = z998 + z1138;
    const Scalar z1125 = z1109 * z1121 - z1110 * z1123;
    const Scalar z1130 = z972 * z1126 - z973 * z1128;
    const Scalar z1129 = z972 * z1127 - z974 * z1128;
    const Scalar z1175 = v_yaw * s_roll;
    const Scalar z1176 = v_yaw * c_roll;
    const Scalar z1187 = v_pitch + z1175;  // angular velocity of frame, y
    const Scalar z1180 = v_roll * z1175;  // angular acceleration of frame.2, z
    const Scalar z1181 = v_roll * c_pitch - s_pitch * z1176;
    const Scalar z1182 = v_roll * s_pitch + c_pitch * z1176;
    const Scalar z1183 = s_pitch * z1180;
    const Scalar z1184 = c_pitch * z1180;
    const Scalar z1178 = n9_81 * c_roll;
    const Scalar z1188 = v_pitch * z1182 - z1183;  // angular acceleration of frame, x
    const Scalar z1189 = v_pitch * z1181 - z1184;  // angular acceleration of frame, z
    const Scalar z1179 = v_roll * z1176;  // angular acceleration of frame.2, y
    const Scalar z1191 = z1187 * z1187;
    const Scalar z1192 = z1182 * z1182;
    const Scalar z1185 = s_pitch * z1178;
    const Scalar z1186 = c_pitch * z1178;
    const Scalar z1177 = n9_81 * s_roll;
    const Scalar z1190 = v_rear + z1187;  // angular velocity of rear_wheel, y
    const Scalar z1144 = n0_3 * z988 - n1_1 * z993;
    const Scalar z1161 = s_yaw * z1132 - c_yaw * z1131 - z922 * z962 - z926 * z960;
    const Scalar z1133 = s_yaw * z1131 - z922 * z960 + z926 * z962 + c_yaw * z1132;
    const Scalar z1162 = v_x + z1161;
    const Scalar z1163 = z1162 - z980 * z1004 + z975 * z1135;
    const Scalar z1134 = v_y - z1133;
    const Scalar z1136 = z1134 - z980 * z1006 + z976 * z1135;
    const Scalar z1193 = z1191 + z1192;
    const Scalar z1194 = z1181 * z1182;
    const Scalar z1196 = z1181 * z1187;
    const Scalar z1195 = z1179 + z1194;
    const Scalar z1150 = z31 * z993 - z32 * z988;
    const Scalar z1172 = z1162 - z1163;
    const Scalar z1142 = z31 * z988 + z32 * z993;
    const Scalar z1145 = n1_1 * z988 + n0_3 * z993;
    const Scalar z1173 = z972 * z1172 - z1000 * z1126 - z1003 * z1128 - z973 * z1158;
    const Scalar z1157 = z1134 - z1136;
    const Scalar z1159 = z972 * z1157 - z1000 * z1127 - z1005 * z1128 - z974 * z1158;
    const Scalar z1146 = z921 * z1113 + s_roll * z1145;
    const Scalar z1153 = c_roll * z1145 - z923 * z1113;
    const Scalar z1143 = c_roll * z1142 - z923 * z1107;
    const Scalar z1151 = z921 * z1107 + s_roll * z1142;
    const Scalar z1154 = v_z - z1153;
    const Scalar z1155 = z1138 + z1154;
    const Scalar z1139 = v_z + z1138;
    const Scalar z1167 = z926 * z1112 - c_yaw * z1144 + z922 * z1114 + s_yaw * z1146;
    const Scalar z1147 = z922 * z1112 + s_yaw * z1144 - z926 * z1114 + c_yaw * z1146;
    const Scalar z1168 = v_x - z1167;
    const Scalar z1169 = z1163 - z1168;
    const Scalar z1164 = v_x - z1163;
    const Scalar z1166 = z921 * z1099 - z924 * z1101 + s_roll * z1164 + z910 * z1139;
    const Scalar z1148 = v_y + z1147;
    const Scalar z1149 = z1136 - z1148;
    const Scalar z1137 = v_y - z1136;
    const Scalar z1141 = z921 * z1100 + z927 * z1101 + s_roll * z1137 - z911 * z1139;
    const Scalar z1197 = z1189 + z1196;
    const Scalar z1198 = z1182 * z1187;
    const Scalar z1199 = z1188 + z1198;
    const Scalar z1170 = z926 * z1106 + c_yaw * z1150 + z922 * z1108 + s_yaw * z1151;
    const Scalar z1152 = s_yaw * z1150 - z922 * z1106 + z926 * z1108 - c_yaw * z1151;
    const Scalar z1171 = z1121 * z1143 - z1123 * z1170 + z1109 * z1169 + z1110 * z1155;
    const Scalar z1156 = z1122 * z1143 - z1123 * z1152 + z1109 * z1149 - z1111 * z1155;
    const Scalar z1140 = z922 * z1101 + s_yaw * z1139;
    const Scalar z1165 = c_yaw * z1139 - z926 * z1101;
    const Scalar z1174 = v_yaw * z1164 + v_pitch * z1166 + v_steer * z1171 - v_roll * z1165 + v_front * z1173;
    const Scalar z1160 = v_yaw * z1137 - v_roll * z1140 + v_pitch * z1141 + v_steer * z1156 + v_front * z1159;
    const Scalar z1205 = z908 * z1187 + z907 * z1181 - z909 * z1182;
    const Scalar z1200 = z1179 - z1194;
    const Scalar z1218 = z32 * v_steer;
    const Scalar z1201 = z1181 * z1181;
    const Scalar z1202 = z1191 + z1201;
    const Scalar z1259 = z1192 - z1201;
    const Scalar z1203 = z906 * z1187 - z907 * z1182 + z905 * z1181;
    const Scalar z1204 = c_steer * z1187 - z906 * z1181 + z908 * z1182;
    const Scalar z1255 = z1181 * z1190;
    const Scalar z1254 = z1182 * z1190;
    const Scalar z1258 = n0_12 * z1255;  // moment on rear_wheel, z
    const Scalar z1256 = n0_12 * z1254;  // moment on rear_wheel, x
    const Scalar z1216 = z31 * v_steer;
    const Scalar z1219 = z1205 - z1218;  // angular velocity of fork, z
    const Scalar z1215 = z31 * z1205 + z32 * z1203;
    const Scalar z1217 = z1203 + z1216;  // angular velocity of fork, x
    const Scalar z1207 = c_steer * z1179 + z906 * z1188 + z908 * z1189;
    const Scalar z1221 = v_steer * z1215 - z1207;  // angular acceleration of fork, y
    const Scalar z1209 = z1185 - n1_1 * z1193 + n0_3 * z1195;
    const Scalar z1223 = z1204 * z1204;
    const Scalar z1224 = z1219 * z1219;
    const Scalar z1210 = z1177 - n1_1 * z1197 - n0_3 * z1199;
    const Scalar z1211 = z1186 + n1_1 * z1200 + n0_3 * z1202;
    const Scalar z1225 = z1223 + z1224;
    const Scalar z1226 = z1217 * z1219;
    const Scalar z1208 = z907 * z1188 - z908 * z1179 + z909 * z1189;
    const Scalar z1206 = z905 * z1188 - z906 * z1179 + z907 * z1189;
    const Scalar z1222 = z1204 * z1216 - z1208;  // angular acceleration of fork, z
    const Scalar z1220 = z1204 * z1218 - z1206;  // angular acceleration of fork, x
    const Scalar z1270 = z1175 * z1176;
    const Scalar z1271 = n2 * z1180;
    const Scalar z1227 = z1221 + z1226;
    const Scalar z1232 = z1221 - z1226;
    const Scalar z1233 = z1217 * z1217;
    const Scalar z1234 = z1223 + z1233;
    const Scalar z1241 = z1224 - z1233;
    const Scalar z1235 = v_front + z1204;  // angular velocity of front_wheel, y
    const Scalar z1212 = z905 * z1209 - z906 * z1210 + z907 * z1211;
    const Scalar z1242 = n1_04 * z1225 + n3_85 * z1227 + n7 * z1212;  // force on fork, x
    const Scalar z1213 = z906 * z1209 + z908 * z1211 + c_steer * z1210;
    const Scalar z1214 = z907 * z1209 - z908 * z1210 + z909 * z1211;
    const Scalar z1244 = n1_04 * z1232 - n3_85 * z1234 + n7 * z1214;  // force on fork, z
    const Scalar z1287 = z449 * z906;
    const Scalar z1282 = n0_28 * c_steer;
    const Scalar z1283 = n0_28 * z908;
    const Scalar z1281 = n0_28 * z906;
    const Scalar z1284 = s_pitch * z1283 - c_pitch * z1281;
    const Scalar z1285 = s_pitch * z1281 + c_pitch * z1283;
    const Scalar z1228 = z1204 * z1217;
    const Scalar z1237 = z1217 * z1235;
    const Scalar z1230 = z1204 * z1219;
    const Scalar z1236 = z1219 * z1235;
    const Scalar z1240 = n0_28 * z1237;  // moment on front_wheel, z
    const Scalar z1238 = n0_28 * z1236;  // moment on front_wheel, x
    const Scalar z1288 = c_steer * z449;
    const Scalar z1229 = z1222 - z1228;
    const Scalar z1286 = s_roll * z1282 + c_roll * z1285;
    const Scalar z1245 = n3_85 * z1213 - z1238 - k17 * z1230 - k3 * z1220 - k4 * z1229;  // moment on fork, x
    const Scalar z1231 = z1220 + z1230;
    const Scalar z1247 = k18 * z1228 + z1240 - k5 * z1222 - k4 * z1231 + n1_04 * z1213;  // moment on fork, z
    const Scalar z1243 = n7 * z1213 - n1_04 * z1229 - n3_85 * z1231;  // force on fork, y
    const Scalar z1291 = z450 * z906 + z451 * z908;
    const Scalar z1289 = z449 * z908;
    const Scalar z1294 = n0_3 * z1287 - z1291 + n1_1 * z1289;
    const Scalar z1292 = z450 * z907 + z451 * z909;
    const Scalar z1295 = n1_1 * z1288 - z1292;
    const Scalar z1290 = z451 * z907 + z450 * z905;
    const Scalar z1293 = n0_3 * z1288 - z1290;
    const Scalar z1297 = s_pitch * z1287 + c_pitch * z1289;
    const Scalar z1296 = s_pitch * z1289 - c_pitch * z1287;
    const Scalar z1298 = s_pitch * z1295 - c_pitch * z1293;
    const Scalar z1239 = n0_28 * z1221;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z1246 = z1239 + k19 * z1226 + k4 * z1241 + n2_5667 * z1221 + n3_85 * z1212 + n1_04 * z1214;
    const Scalar z1299 = s_pitch * z1293 + c_pitch * z1295;
    const Scalar z1302 = s_roll * z1294 - c_roll * z1299;
    const Scalar z1307 = n1_04 * z907 - n3_85 * z909;
    const Scalar z1305 = n1_04 * z905 - n3_85 * z907;
    const Scalar z1306 = n1_04 * z906 - n3_85 * z908;
    const Scalar z1301 = s_roll * z1288 + c_roll * z1297;
    const Scalar z1300 = s_roll * z1297 - c_roll * z1288;
    const Scalar z1304 = s_yaw * z1296 - c_yaw * z1300;
    const Scalar z1303 = c_yaw * z1296 + s_yaw * z1300;
    const Scalar z1257 = n0_12 * z1179;  // moment on rear_wheel, y
    const Scalar z1248 = z905 * z1242 + z907 * z1244 + z906 * z1243;
    const Scalar z1260 = n25_5 * z1193 - z1248 + n51 * z1195;  // force on frame, x
    const Scalar z1308 = k4 * z907;
    const Scalar z1250 = z907 * z1242 + z909 * z1244 + z908 * z1243;
    const Scalar z1249 = c_steer * z1243 - z906 * z1242 - z908 * z1244;
    const Scalar z1262 = z1250 + n25_5 * z1200 - n51 * z1202;  // force on frame, z
    const Scalar z1310 = n2_8467 * z906;
    const Scalar z1309 = k3 * z905 + z1308;
    const Scalar z1253 = z909 * z1247 + z907 * z1245 - z908 * z1246;
    // moment on frame, z
    const Scalar z1265 = n25_5 * z1177 - z1258 - n9_95 * z1197 + n17_7 * z1199 + n1_1 * z1249 - z1253;
    const Scalar z1267 = s_pitch * z1260 - c_pitch * z1262;
    const Scalar z1266 = s_pitch * z1262 + c_pitch * z1260;
    const Scalar z1261 = n25_5 * z1197 - z1249 - n51 * z1199;  // force on frame, y
    const Scalar z1251 = z907 * z1247 + z905 * z1245 - z906 * z1246;
    // moment on frame, x
    const Scalar z1263 = n51 * z1177 + z1256 - n17_7 * z1197 + n39_3 * z1199 - n0_3 * z1249 + z1251;
    const Scalar z1252 = z908 * z1247 + z906 * z1245 + c_steer * z1246;
    // moment on frame, y
    const Scalar z1264 = z1257 + n49_25 * z1179 - n51 * z1185 + n25_5 * z1186 + n29_35 * z1194 + n17_7 * z1259 + n0_3
        * z1248 + n1_1 * z1250 - z1252;
    const Scalar z1280 = z31 * z1245 - z32 * z1247;
    const Scalar z1317 = k5 * z909 + z1308;
    const Scalar z1316 = n2_8467 * z908;
    const Scalar z1315 = k3 * z907 + k4 * z909;
    const Scalar z1323 = z908 * z1316 + z907 * z1315 + z909 * z1317;
    const Scalar z1313 = n2_8467 * c_steer;
    const Scalar z1311 = k5 * z907 + k4 * z905;
    const Scalar z1318 = z906 * z1310 + z905 * z1309 + z907 * z1311;
    const Scalar z1312 = k3 * z906 + k4 * z908;
    const Scalar z1324 = n0_63 + n0_6 * z1307 + z1318;
    const Scalar z1314 = k4 * z906 + k5 * z908;
    const Scalar z1321 = z906 * z1316 + z905 * z1315 + z907 * z1317;
    const Scalar z1322 = c_steer * z1316 - z906 * z1315 - z908 * z1317;
    const Scalar z1319 = z905 * z1312 - z906 * z1313 + z907 * z1314;
    const Scalar z1320 = c_steer * z1313 + z906 * z1312 + z908 * z1314;
    const Scalar z1327 = n2_31 + n1_1 * z1307 - n0_3 * z1305 + z1321;
    const Scalar z1326 = n9_1 + n0_6 * z1307 - n2_2 * z1305 + z1320;
    const Scalar z1325 = n1_1 * z1306 + z1319;
    const Scalar z1274 = s_roll * z1267 - c_roll * z1261;
    const Scalar z1275 = s_roll * z1261 + c_roll * z1267;
    const Scalar z1279 = n853_47 - z1275;  // force on frame.z, z
    const Scalar z1268 = s_pitch * z1265 + c_pitch * z1263;
    const Scalar z1269 = s_pitch * z1263 - c_pitch * z1265;
    const Scalar z1272 = z1268 - n0_5603 * z1270;  // moment on frame.2, x
    const Scalar z1273 = z1269 - n0_5603 * z1271;  // moment on frame.2, z
    const Scalar z1329 = n8_47 - n2_2 * z1305 + z1323;
    const Scalar z1335 = n17_7 - z1327;
    const Scalar z1334 = n49_25 + z1326;
    const Scalar z1328 = n0_3 * z1306 + z1322;
    const Scalar z1331 = n2_1 + z1307;
    const Scalar z1330 = n7_7 - z1305;
    const Scalar z1333 = n51 - z1331;
    const Scalar z1332 = n25_5 + z1330;
    const Scalar z1276 = s_roll * z1264 + c_roll * z1273;
    const Scalar z1336 = n29_35 - z1329;
    const Scalar z1277 = s_yaw * z1274 - c_yaw * z1266;
    const Scalar z1278 = s_yaw * z1266 + c_yaw * z1274;
    const Scalar z1348 = z1324 + z1336;
    const Scalar z1349 = n2 * z1335;
    const Scalar z1350 = s_pitch * z1348 - c_pitch * z1349;
    const Scalar z1381 = c_steer * z1282 - z1334;
    const Scalar z1338 = n0_12 + z1334;
    const Scalar z1372 = n25_over_7 * z1282;
    const Scalar z1387 = z601 * z1294;
    const Scalar z1356 = n39_8603 - z1338;
    const Scalar z1342 = s_pitch * z1325 - c_pitch * z1328;
    const Scalar z1341 = s_pitch * z1328 + c_pitch * z1325;
    const Scalar z1354 = c_pitch * z1350 + z1335;
    const Scalar z1351 = s_pitch * z1350;
    const Scalar z1345 = s_roll * z1338 - c_roll * z1342;
    const Scalar z1352 = z1336 - z1351;
    const Scalar z1353 = z1324 - z1351;
    const Scalar z1363 = n2 * z1342;
    const Scalar z1359 = s_roll * z1341 - c_roll * z1354;
    const Scalar z1362 = z1352 - z1356;
    const Scalar z1355 = n39_8603 + z1353;
    const Scalar z1377 = z1284 * z1372 - z1341;
    const Scalar z1364 = s_roll * z1362 - c_roll * z1363;
    const Scalar z1376 = z1286 * z1372 - z1345;
    const Scalar z1371 = n25_over_7 * z1284;
    const Scalar z1375 = z1284 * z1371 - z1355;
    const Scalar z1374 = z1286 * z1371 - z1359;
    const Scalar z1386 = z601 * z1298;
    const Scalar z1370 = n25_over_7 * z1286;
    const Scalar z1337 = n0_12 * s_roll;
    const Scalar z1380 = z1337 + z1376;
    const Scalar z1365 = s_roll * z1364;
    const Scalar z1378 = n25_over_3 * z1337;
    const Scalar z1385 = z601 * z1302;
    const Scalar z1339 = c_pitch * z1333 + s_pitch * z1332;
    const Scalar z1366 = z1352 - z1365;
    const Scalar z1340 = s_pitch * z1333 - c_pitch * z1332;
    const Scalar z1402 = z1298 * z1386 + z1375;
    const Scalar z1367 = n39_8603 - z1366;
    const Scalar z1401 = z1302 * z1386 - z1374;
    const Scalar z1344 = c_roll * z1340;
    const Scalar z1358 = s_roll * z1339 - c_roll * z1306;
    const Scalar z1373 = z1286 * z1370 - z1367;
    const Scalar z1357 = s_roll * z1306 + c_roll * z1339;
    const Scalar z1384 = z601 * z1301;
    const Scalar z1396 = z1301 * z1385;
    const Scalar z1379 = z1337 * z1378 + z1373;
    const Scalar z1400 = z1301 * z1386 - z1358;
    const Scalar z1393 = n94 - z1301 * z1384;
    const Scalar z1343 = s_roll * z1340;
    const Scalar z1405 = z1301 * z1387 + z1344;
    const Scalar z1397 = z1302 * z1385 + z1379;
    const Scalar z1347 = s_yaw * z1339 + c_yaw * z1343;
    const Scalar z1346 = s_yaw * z1343 - c_yaw * z1339;
    const Scalar z1408 = z1294 * z1387 + z1381;
    const Scalar z1407 = z1298 * z1387 - z1377;
    const Scalar z1406 = z1302 * z1387 + z1380;
    const Scalar z1409 = n1 / z1408;
    const Scalar z1404 = z1304 * z1387 - z1347;
    const Scalar z1403 = z1303 * z1387 + z1346;
    const Scalar z1361 = c_yaw * z1357;
    const Scalar z1399 = z1304 * z1386 - z1361;
    const Scalar z1360 = s_yaw * z1357;
    const Scalar z1398 = z1303 * z1386 + z1360;
    const Scalar z1369 = c_yaw * z1340 + s_yaw * z1358;
    const Scalar z1368 = s_yaw * z1340 - c_yaw * z1358;
    const Scalar z1395 = z1304 * z1385 - z1369;
    const Scalar z1394 = z1303 * z1385 + z1368;
    const Scalar z1383 = z601 * z1304;
    const Scalar z1414 = z1407 * z1409;
    const Scalar z1413 = z1406 * z1409;
    const Scalar z1412 = z1405 * z1409;
    const Scalar z1392 = z1304 * z1384;
    const Scalar z1390 = n94 - z1304 * z1383;
    const Scalar z1429 = z1402 - z1407 * z1414;
    const Scalar z1428 = z1401 - z1406 * z1414;
    const Scalar z1424 = z1397 - z1406 * z1413;
    const Scalar z1423 = z1396 - z1405 * z1413;
    const Scalar z1430 = n1 / z1429;
    const Scalar z1427 = z1400 - z1405 * z1414;
    const Scalar z1420 = z1393 + z1405 * z1412;
    const Scalar z1419 = z1392 - z1404 * z1412;
    const Scalar z1422 = z1395 - z1404 * z1413;
    const Scalar z1426 = z1399 - z1404 * z1414;
    const Scalar z1421 = z1394 - z1403 * z1413;
    const Scalar z1425 = z1398 - z1403 * z1414;
    const Scalar z1411 = z1404 * z1409;
    const Scalar z1417 = z1390 + z1404 * z1411;
    const Scalar z1382 = z601 * z1303;
    const Scalar z1389 = z1303 * z1383;
    const Scalar z1416 = z1389 - z1403 * z1411;
    const Scalar z1391 = z1303 * z1384;
    const Scalar z1388 = n94 - z1303 * z1382;
    const Scalar z1418 = z1391 - z1403 * z1412;
    const Scalar z1434 = z1428 * z1430;
    const Scalar z1433 = z1427 * z1430;
    const Scalar z1432 = z1426 * z1430;
    const Scalar z1410 = z1403 * z1409;
    const Scalar z1415 = z1388 + z1403 * z1410;
    const Scalar z1444 = z1424 - z1428 * z1434;
    const Scalar z1443 = z1423 - z1427 * z1434;
    const Scalar z1440 = z1420 + z1427 * z1433;
    const Scalar z1439 = z1419 - z1426 * z1433;
    const Scalar z1445 = n1 / z1444;
    const Scalar z1442 = z1422 - z1426 * z1434;
    const Scalar z1437 = z1417 + z1426 * z1432;
    const Scalar z1436 = z1416 - z1425 * z1432;
    const Scalar z1438 = z1418 - z1425 * z1433;
    const Scalar z1441 = z1421 - z1425 * z1434;
    const Scalar z1431 = z1425 * z1430;
    const Scalar z1435 = z1415 + z1425 * z1431;
    const Scalar z1493 = z1082 * z1434;
    const Scalar z1478 = z1029 + z1051 * z1387;
    const Scalar z1479 = z1018 + z1051 * z1386 - z1414 * z1478;
    const Scalar z1465 = z940 * z1434;
    const Scalar z1446 = z1441 * z1445;
    const Scalar z1506 = z1083 * z1434;
    const Scalar z1447 = z1442 * z1445;
    const Scalar z1448 = z1443 * z1445;
    const Scalar z1480 = z1051 * z1385 - z1413 * z1478 - z1434 * z1479;
    const Scalar z1454 = z1440 + z1443 * z1448;
    const Scalar z1453 = z1439 - z1442 * z1448;
    const Scalar z1451 = z1437 + z1442 * z1447;
    const Scalar z1450 = z1436 - z1441 * z1447;
    const Scalar z1455 = n1 / z1454;
    const Scalar z1452 = z1438 - z1441 * z1448;
    const Scalar z1449 = z1435 + z1441 * z1446;
    const Scalar z1507 = z1083 * z1433 - z1448 * z1506;
    const Scalar z1494 = z1082 * z1433 - z1448 * z1493;
    const Scalar z1481 = n1 + z1051 * z1384 - z1412 * z1478 - z1433 * z1479 - z1448 * z1480;
    const Scalar z1466 = n1 + z940 * z1433 - z1448 * z1465;
    const Scalar z1456 = z1452 * z1455;
    const Scalar z1457 = z1453 * z1455;
    const Scalar z1458 = z1449 - z1452 * z1456;
    const Scalar z1459 = z1450 + z1452 * z1457;
    const Scalar z1519 = z1104 + z1124 * z1387 - z1129 * z1372;
    const Scalar z1460 = z1451 - z1453 * z1457;
    const Scalar z1520 = z1102 + z1124 * z1386 + z1129 * z1371 - z1414 * z1519;
    const Scalar z1461 = n1 / z1460;
    const Scalar z1521 = z1100 + z1124 * z1385 - z1129 * z1370 - z1413 * z1519 - z1434 * z1520;
    const Scalar z1508 = n1 - z1083 * z1432 + z1447 * z1506 - z1457 * z1507;
    const Scalar z1495 = z1082 * z1432 - z1447 * z1493 + z1457 * z1494;
    const Scalar z1482 = z1051 * z1383 - z1411 * z1478 - z1432 * z1479 - z1447 * z1480 + z1457 * z1481;
    const Scalar z1462 = z1459 * z1461;
    const Scalar z1522 = z1124 * z1384 - z1412 * z1519 - z1433 * z1520 - z1448 * z1521;
    const Scalar z1463 = z1458 - z1459 * z1462;
    const Scalar z1464 = n1 / z1463;
    const Scalar z1523 = z1124 * z1383 - z1411 * z1519 - z1432 * z1520 - z1447 * z1521 + z1457 * z1522;
    const Scalar z1524 = n1 - z1124 * z1382 + z1410 * z1519 + z1431 * z1520 + z1446 * z1521 - z1456 * z1522 - z1462
        * z1523;
    const Scalar z1509 = z1083 * z1431 - z1446 * z1506 + z1456 * z1507 - z1462 * z1508;
    const Scalar z1525 = z1464 * z1524;
    const Scalar z1510 = z1464 * z1509;
    const Scalar z1496 = n1 + z1082 * z1431 - z1446 * z1493 + z1456 * z1494 + z1462 * z1495;
    const Scalar z1526 = z1461 * z1523 - z1462 * z1525;
    const Scalar z1511 = z1461 * z1508 - z1462 * z1510;
    const Scalar z1512 = z1455 * z1507 + z1456 * z1510 - z1457 * z1511;
    const Scalar z1497 = z1464 * z1496;
    const Scalar z1498 = z1461 * z1495 + z1462 * z1497;
    const Scalar z1513 = z1445 * z1506 + z1446 * z1510 - z1447 * z1511 + z1448 * z1512;
    const Scalar z1499 = z1455 * z1494 + z1456 * z1497 + z1457 * z1498;
    const Scalar z1514 = z1083 * z1430 - z1431 * z1510 + z1432 * z1511 - z1433 * z1512 + z1434 * z1513;
    const Scalar z1500 = z1445 * z1493 + z1446 * z1497 + z1447 * z1498 + z1448 * z1499;
    const Scalar z1515 = z1410 * z1510 - z1411 * z1511 + z1412 * z1512 - z1413 * z1513 + z1414 * z1514;
    const Scalar z1516 = z1382 * z1510 - z1383 * z1511 + z1384 * z1512 - z1385 * z1513 + z1386 * z1514 - z1387 * z1515;
    const Scalar z1517 = n25_over_3 * z1085 - z1515 - z1378 * z1513;
    const Scalar z1518 = z1370 * z1513 + z1371 * z1514 + z1372 * z1515;
    const Scalar z1483 = z1051 * z1382 - z1410 * z1478 - z1431 * z1479 - z1446 * z1480 + z1456 * z1481 + z1462 * z1482;
    const Scalar z1484 = z1464 * z1483;
    const Scalar z1501 = z1082 * z1430 - z1431 * z1497 - z1432 * z1498 - z1433 * z1499 + z1434 * z1500;
    const Scalar z1485 = z1461 * z1482 + z1462 * z1484;
    const Scalar z1502 = z1410 * z1497 + z1411 * z1498 + z1412 * z1499 - z1413 * z1500 + z1414 * z1501;
    const Scalar z1486 = z1455 * z1481 + z1456 * z1484 + z1457 * z1485;
    const Scalar z1487 = z1445 * z1480 + z1446 * z1484 + z1447 * z1485 + z1448 * z1486;
    const Scalar z1503 = z1382 * z1497 + z1383 * z1498 + z1384 * z1499 - z1385 * z1500 + z1386 * z1501 - z1387 * z1502;
    const Scalar z1488 = z1430 * z1479 + z1431 * z1484 + z1432 * z1485 + z1433 * z1486 - z1434 * z1487;
    const Scalar z1489 = z1409 * z1478 + z1410 * z1484 + z1411 * z1485 + z1412 * z1486 - z1413 * z1487 - z1414 * z1488;
    const Scalar z1467 = z940 * z1432 - z1447 * z1465 + z1457 * z1466;
    const Scalar z1527 = z1455 * z1522 - z1456 * z1525 + z1457 * z1526;
    const Scalar z1504 = n25_over_3 * z1084 - z1502 - z1378 * z1500;
    const Scalar z1505 = z1370 * z1500 + z1371 * z1501 + z1372 * z1502;
    const Scalar z1468 = z940 * z1431 - z1446 * z1465 + z1456 * z1466 + z1462 * z1467;
    const Scalar z1528 = z1445 * z1521 - z1446 * z1525 + z1447 * z1526 + z1448 * z1527;
    const Scalar z1469 = z1464 * z1468;
    const Scalar z1529 = z1430 * z1520 - z1431 * z1525 + z1432 * z1526 + z1433 * z1527 - z1434 * z1528;
    const Scalar z1470 = z1461 * z1467 + z1462 * z1469;
    const Scalar z1530 = z1409 * z1519 - z1410 * z1525 + z1411 * z1526 + z1412 * z1527 - z1413 * z1528 - z1414 * z1529;
    const Scalar z1471 = z1455 * z1466 + z1456 * z1469 + z1457 * z1470;
    const Scalar z1472 = z1445 * z1465 + z1446 * z1469 + z1447 * z1470 + z1448 * z1471;
    const Scalar z1531 = z601 * z1124 - z1382 * z1525 + z1383 * z1526 + z1384 * z1527 - z1385 * z1528 - z1386 * z1529
        - z1387 * z1530;
    const Scalar z1490 = z601 * z1051 + z1382 * z1484 + z1383 * z1485 + z1384 * z1486 - z1385 * z1487 - z1386 * z1488
        - z1387 * z1489;
    const Scalar z1491 = z1378 * z1487 + z1489;
    const Scalar z1492 = z1370 * z1487 - z1371 * z1488 + z1372 * z1489;
    const Scalar z1473 = z940 * z1430 - z1431 * z1469 - z1432 * z1470 - z1433 * z1471 + z1434 * z1472;
    const Scalar z1533 = n25_over_7 * z1129 + z1370 * z1528 - z1371 * z1529 + z1372 * z1530;
    const Scalar z1474 = z1410 * z1469 + z1411 * z1470 + z1412 * z1471 - z1413 * z1472 + z1414 * z1473;
    const Scalar z1534 = z1105 + z1125 * z1387 - z1130 * z1372;
    const Scalar z1475 = z1382 * z1469 + z1383 * z1470 + z1384 * z1471 - z1385 * z1472 + z1386 * z1473 - z1387 * z1474;
    const Scalar z1535 = z1103 + z1125 * z1386 + z1130 * z1371 - z1414 * z1534;
    const Scalar z1476 = z1378 * z1472 + z1474;
    const Scalar z1536 = z1099 + z1125 * z1385 - z1130 * z1370 - z1413 * z1534 - z1434 * z1535;
    const Scalar z1477 = z1370 * z1472 + z1371 * z1473 + z1372 * z1474;
    const Scalar z1537 = z1125 * z1384 - z1412 * z1534 - z1433 * z1535 - z1448 * z1536;
    const Scalar z1538 = n1 + z1125 * z1383 - z1411 * z1534 - z1432 * z1535 - z1447 * z1536 + z1457 * z1537;
    const Scalar z1539 = z1125 * z1382 - z1410 * z1534 - z1431 * z1535 - z1446 * z1536 + z1456 * z1537 + z1462 * z1538;
    const Scalar z1540 = z1464 * z1539;
    const Scalar z1568 = z1099 * z1528 - z1526 + z1103 * z1529 + z1105 * z1530 - z1125 * z1531 - z1130 * z1533;
    const Scalar z1541 = z1461 * z1538 + z1462 * z1540;
    const Scalar z1542 = z1455 * z1537 + z1456 * z1540 + z1457 * z1541;
    const Scalar z1563 = z1100 * z1528 - z1525 + z1102 * z1529 + z1104 * z1530 - z1124 * z1531 - z1129 * z1533;
    const Scalar z1543 = z1445 * z1536 + z1446 * z1540 + z1447 * z1541 + z1448 * z1542;
    const Scalar z1544 = z1430 * z1535 + z1431 * z1540 + z1432 * z1541 + z1433 * z1542 - z1434 * z1543;
    const Scalar z1545 = z1409 * z1534 + z1410 * z1540 + z1411 * z1541 + z1412 * z1542 - z1413 * z1543 - z1414 * z1544;
    const Scalar z1546 = z601 * z1125 + z1382 * z1540 + z1383 * z1541 + z1384 * z1542 - z1385 * z1543 - z1386 * z1544
        - z1387 * z1545;
    const Scalar z1548 = n25_over_7 * z1130 + z1370 * z1543 - z1371 * z1544 + z1372 * z1545;
    const Scalar z1569 = z1099 * z1543 - z1541 + z1103 * z1544 + z1105 * z1545 - z1125 * z1546 - z1130 * z1548;
    const Scalar z1570 = n1 / z1569;
    const Scalar z1562 = z1510 + z1100 * z1513 - z1102 * z1514 + z1104 * z1515 - z1124 * z1516 - z1129 * z1518;
    const Scalar z1567 = z1511 + z1099 * z1513 - z1103 * z1514 + z1105 * z1515 - z1125 * z1516 - z1130 * z1518;
    const Scalar z1558 = z1511 + z1079 * z1513 - z1083 * z1514 + z1085 * (z1515 + z1517);
    const Scalar z1575 = z1568 * z1570;
    const Scalar z1574 = z1567 * z1570;
    const Scalar z1557 = z1079 * z1500 - z1498 - z1083 * z1501 + z1085 * (z1502 + z1504);
    const Scalar z1590 = z1563 - z1568 * z1575;
    const Scalar z1589 = z1562 - z1567 * z1575;
    const Scalar z1591 = n1 / z1590;
    const Scalar z1585 = z1558 + z1567 * z1574;
    const Scalar z1561 = z1497 + z1100 * z1500 - z1102 * z1501 + z1104 * z1502 - z1124 * z1503 - z1129 * z1505;
    const Scalar z1566 = z1099 * z1500 - z1498 - z1103 * z1501 + z1105 * z1502 - z1125 * z1503 - z1130 * z1505;
    const Scalar z1584 = z1557 + z1566 * z1574;
    const Scalar z1588 = z1561 - z1566 * z1575;
    const Scalar z1554 = z1497 + z1080 * z1500 - z1082 * z1501 + z1084 * (z1502 + z1504);
    const Scalar z1573 = z1566 * z1570;
    const Scalar z1581 = z1554 + z1566 * z1573;
    const Scalar z1553 = z1484 + z1080 * z1487 + z1082 * z1488 + z1084 * (z1489 - z1491);
    const Scalar z1556 = z1079 * z1487 - z1485 + z1083 * z1488 + z1085 * (z1489 - z1491);
    const Scalar z1560 = z1484 + z1100 * z1487 + z1102 * z1488 + z1104 * z1489 - z1124 * z1490 - z1129 * z1492;
    const Scalar z1565 = z1099 * z1487 - z1485 + z1103 * z1488 + z1105 * z1489 - z1125 * z1490 - z1130 * z1492;
    const Scalar z1580 = z1553 + z1565 * z1573;
    const Scalar z1583 = z1556 + z1565 * z1574;
    const Scalar z1587 = z1560 - z1565 * z1575;
    const Scalar z1551 = z1018 * z1488 - z1486 + z1029 * z1489 - z1051 * z1490;
    const Scalar z1572 = z1565 * z1570;
    const Scalar z1578 = z1551 - z1565 * z1572;
    const Scalar z1550 = z1471 + z1018 * z1473 - z1029 * z1474 + z1051 * z1475;
    const Scalar z1552 = z1469 + z1080 * z1472 - z1082 * z1473 + z1084 * (z1474 - z1476);
    const Scalar z1555 = z1079 * z1472 - z1470 - z1083 * z1473 + z1085 * (z1474 - z1476);
    const Scalar z1559 = z1469 + z1100 * z1472 - z1102 * z1473 + z1104 * z1474 - z1124 * z1475 - z1129 * z1477;
    const Scalar z1564 = z1099 * z1472 - z1470 - z1103 * z1473 + z1105 * z1474 - z1125 * z1475 - z1130 * z1477;
    const Scalar z1577 = z1550 + z1564 * z1572;
    const Scalar z1579 = z1552 + z1564 * z1573;
    const Scalar z1582 = z1555 + z1564 * z1574;
    const Scalar z1586 = z1559 - z1564 * z1575;
    const Scalar z1549 = z940 * z1473 - z1471;
    const Scalar z1571 = z1564 * z1570;
    const Scalar z1576 = z1549 - z1564 * z1571;
    const Scalar z1532 = z1378 * z1528 + z1530;
    const Scalar z1595 = z1589 * z1591;
    const Scalar z1605 = z1585 + z1589 * z1595;
    const Scalar z1604 = z1584 + z1588 * z1595;
    const Scalar z1603 = z1583 + z1587 * z1595;
    const Scalar z1602 = z1582 + z1586 * z1595;
    const Scalar z1606 = n1 / z1605;
    const Scalar z1594 = z1588 * z1591;
    const Scalar z1601 = z1581 + z1588 * z1594;
    const Scalar z1600 = z1580 + z1587 * z1594;
    const Scalar z1599 = z1579 + z1586 * z1594;
    const Scalar z1593 = z1587 * z1591;
    const Scalar z1598 = z1578 - z1587 * z1593;
    const Scalar z1597 = z1577 + z1586 * z1593;
    const Scalar z1592 = z1586 * z1591;
    const Scalar z1596 = z1576 - z1586 * z1592;
    const Scalar z1547 = z1378 * z1543 + z1545;
    const Scalar z1658 = z1549 + z1551 - z1554 - z1558 + z1563 + z1569;
    const Scalar z1659 = n4096 * z1658;
    const Scalar z1626 = z1239 * z1372 - z1257 - z1280 * z1387 + z1264;
    const Scalar z1627 = z1239 * z1371 + z1280 * z1386 + z1414 * z1626 - z1272;
    const Scalar z1609 = z1604 * z1606;
    const Scalar z1615 = z1601 - z1604 * z1609;
    const Scalar z1614 = z1600 - z1603 * z1609;
    const Scalar z1613 = z1599 - z1602 * z1609;
    const Scalar z1608 = z1603 * z1606;
    const Scalar z1612 = z1598 + z1603 * z1608;
    const Scalar z1628 = z1239 * z1370 - z1257 * z1378 - z1280 * z1385 - z1413 * z1626 + z1434 * z1627 + z1276;
    const Scalar z1616 = n1 / z1615;
    const Scalar z1611 = z1597 - z1602 * z1608;
    const Scalar z1629 = z1279 - z1280 * z1384 - z1412 * z1626 + z1433 * z1627 - z1448 * z1628;
    const Scalar z1630 = z1278 - z1280 * z1383 - z1411 * z1626 + z1432 * z1627 - z1447 * z1628 + z1457 * z1629;
    const Scalar z1631 = z1277 + z1280 * z1382 + z1410 * z1626 - z1431 * z1627 + z1446 * z1628 - z1456 * z1629 - z1462
        * z1630;
    const Scalar z1632 = z1464 * z1631;
    const Scalar z1618 = z1614 * z1616;
    const Scalar z1621 = z1612 + z1614 * z1618;
    const Scalar z1620 = z1611 - z1613 * z1618;
    const Scalar z1633 = z1461 * z1630 - z1462 * z1632;
    const Scalar z1607 = z1602 * z1606;
    const Scalar z1610 = z1596 + z1602 * z1607;
    const Scalar z1622 = n1 / z1621;
    const Scalar z1617 = z1613 * z1616;
    const Scalar z1634 = z1455 * z1629 - z1456 * z1632 + z1457 * z1633;
    const Scalar z1619 = z1610 + z1613 * z1617;
    const Scalar z1635 = z1445 * z1628 - z1446 * z1632 + z1447 * z1633 + z1448 * z1634;
    const Scalar z1636 = z1430 * z1627 + z1431 * z1632 - z1432 * z1633 - z1433 * z1634 + z1434 * z1635;
    const Scalar z1623 = z1620 * z1622;
    const Scalar z1637 = z1409 * z1626 - z1410 * z1632 + z1411 * z1633 + z1412 * z1634 - z1413 * z1635 + z1414 * z1636;
    const Scalar z1638 = z601 * z1280 + z1382 * z1632 - z1383 * z1633 - z1384 * z1634 + z1385 * z1635 - z1386 * z1636
        + z1387 * z1637;
    const Scalar z1640 = n25_over_7 * z1239 - z1370 * z1635 - z1371 * z1636 - z1372 * z1637;
    const Scalar z1645 = z1160 - z1632 + z1100 * z1635 - z1102 * z1636 + z1104 * z1637 + z1124 * z1638 + z1129 * z1640;
    const Scalar z1646 = z1174 - z1633 + z1099 * z1635 - z1103 * z1636 + z1105 * z1637 + z1125 * z1638 + z1130 * z1640;
    const Scalar z1642 = z1078 + z1634 + z1018 * z1636 - z1029 * z1637 - z1051 * z1638;
    const Scalar z1639 = z1637 + n25_over_3 * z1257 + z1378 * z1635;
    const Scalar z1643 = z1093 - z1632 + z1080 * z1635 - z1082 * z1636 + z1084 * (z1637 - z1639);
    const Scalar z1644 = z1098 - z1633 + z1079 * z1635 - z1083 * z1636 + z1085 * (z1637 - z1639);
    const Scalar z1641 = z954 - z1634 + z940 * z1636;
    const Scalar z1624 = z1619 - z1620 * z1623;
    const Scalar z1647 = z1575 * z1646 - z1645;
    const Scalar z1648 = z1644 + z1574 * z1646 - z1595 * z1647;
    const Scalar z1625 = n1 / z1624;
    const Scalar z1649 = z1643 + z1573 * z1646 - z1594 * z1647 - z1609 * z1648;
    const Scalar z1650 = z1642 + z1572 * z1646 - z1593 * z1647 - z1608 * z1648 - z1618 * z1649;
    const Scalar z1651 = z1571 * z1646 - z1641 - z1592 * z1647 - z1607 * z1648 - z1617 * z1649 + z1623 * z1650;
    const Scalar z1652 = z1625 * z1651;
    const Scalar z1653 = z1622 * z1650 + z1623 * z1652;
    const Scalar z1654 = z1616 * z1649 + z1617 * z1652 + z1618 * z1653;
    const Scalar z1655 = z1606 * z1648 + z1607 * z1652 + z1608 * z1653 - z1609 * z1654;
    const Scalar z1656 = z1591 * z1647 - z1592 * z1652 - z1593 * z1653 + z1594 * z1654 + z1595 * z1655;
    const Scalar z1657 = z1570 * z1646 + z1571 * z1652 + z1572 * z1653 - z1573 * z1654 - z1574 * z1655 + z1575 * z1656;
    const Scalar z1660 = z1469 * z1652 - z1632 + z1484 * z1653 - z1497 * z1654 - z1510 * z1655 - z1525 * z1656 - z1540
        * z1657;
    const Scalar z1661 = z1633 + z1470 * z1652 + z1485 * z1653 - z1498 * z1654 + z1511 * z1655 + z1526 * z1656 - z1541
        * z1657;
    const Scalar z1662 = z1634 + z1471 * z1652 + z1486 * z1653 - z1499 * z1654 - z1512 * z1655 + z1527 * z1656 - z1542
        * z1657;
    const Scalar z1663 = z1635 + z1472 * z1652 + z1487 * z1653 - z1500 * z1654 - z1513 * z1655 + z1528 * z1656 - z1543
        * z1657;
    const Scalar z1664 = z1636 + z1473 * z1652 - z1488 * z1653 - z1501 * z1654 - z1514 * z1655 - z1529 * z1656 + z1544
        * z1657;
    const Scalar z1665 = z1637 + z1474 * z1652 + z1489 * z1653 - z1502 * z1654 - z1515 * z1655 + z1530 * z1656 - z1545
        * z1657;
    const Scalar z1666 = z1475 * z1652 - z1638 + z1490 * z1653 - z1503 * z1654 - z1516 * z1655 + z1531 * z1656 - z1546
        * z1657;
    const Scalar z1667 = z1639 + z1476 * z1652 + z1491 * z1653 + z1504 * z1654 + z1517 * z1655 + z1532 * z1656 - z1547
        * z1657;
    const Scalar z1668 = z1477 * z1652 - z1640 + z1492 * z1653 - z1505 * z1654 - z1518 * z1655 + z1533 * z1656 - z1548
        * z1657;
    accelerations.x = z1660;
    accelerations.y = z1661;
    accelerations.z = z1662;
    accelerations.yaw = z1663;
    accelerations.roll = z1664;
    accelerations.pitch = z1665;
    accelerations.steer = -z1666;
    accelerations.rear = -z1667;
    accelerations.front = -z1668;
    multipliers.lambda_rear_touches = -z1652;
    multipliers.lambda_front_touches = -z1653;
    multipliers.lambda_rear_rolls_x = -z1654;
    multipliers.lambda_rear_rolls_y = -z1655;
    multipliers.lambda_front_rolls_x = -z1656;
    multipliers.lambda_front_rolls_y = z1657;
    if (!(traits::regular(z1463, n94) && traits::regular(z1460, n94) && traits::regular(z1454, n94)
        && traits::regular(-z1444, z1367) && traits::regular(-z1429, z1355) && traits::regular(-z1408, z1338)
        && traits::regular(z587, z587) && traits::regular(-z1624, -z1659) && traits::regular(-z1621, -z1659)
        && traits::regular(z1615, -z1659) && traits::regular(z1605, -z1659) && traits::regular(-z1590, -z1659)
        && traits::regular(-z1569, -z1659))) return torsor::Status::singular;
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
    const Scalar z890 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z1751 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z1750 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z1739 = v_yaw * c_roll;
    const Scalar z1738 = v_yaw * s_roll;
    const Scalar z1723 = z32 * s_steer;
    const Scalar z1722 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1724 = -z890 * (n1 - c_steer);
    const Scalar z1725 = z31 * s_steer;
    const Scalar z1726 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1735 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1785 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z1728 = n0_08 * z1723 - n0_35 * z1725;
    const Scalar z1740 = v_roll * c_pitch - s_pitch * z1739;
    const Scalar z1741 = v_roll * s_pitch + c_pitch * z1739;
    const Scalar z1742 = v_pitch + z1738;  // angular velocity of frame, y
    const Scalar z1743 = v_rear + z1742;  // angular velocity of rear_wheel, y
    const Scalar z1727 = n0_08 * z1722 - n0_35 * z1724;
    const Scalar z1788 = n0_8 * z1723 - n2_8 * z1725;
    const Scalar z1729 = n0_08 * z1724 - n0_35 * z1726;
    const Scalar z1736 = c_roll * z1735;
    const Scalar z1744 = z1723 * z1742 - z1724 * z1741 + z1722 * z1740;
    const Scalar z1745 = c_steer * z1742 - z1723 * z1740 + z1725 * z1741;
    const Scalar z1746 = z1725 * z1742 + z1724 * z1740 - z1726 * z1741;
    const Scalar z1752 = v_z * s_roll - c_roll * z1751;
    const Scalar z1753 = v_z * c_roll + s_roll * z1751;
    const Scalar z1756 = s_rear * z1741 - c_rear * z1740;
    const Scalar z1757 = s_rear * z1740 + c_rear * z1741;
    const Scalar z1786 = c_roll * z1785;
    const Scalar z1787 = n0_8 * z1722 - n2_8 * z1724;
    const Scalar z1789 = n0_8 * z1724 - n2_8 * z1726;
    const Scalar z1737 = q_z - z1736;
    const Scalar z1754 = s_pitch * z1753 - c_pitch * z1750;
    const Scalar z1755 = s_pitch * z1750 + c_pitch * z1753;
    const Scalar z1761 = n0_3 * z1740 - z1752 - n1_1 * z1741;
    const Scalar z1774 = n51 * z1740 + n25_5 * z1741 + n85 * z1752;
    const Scalar z1776 = n39_8 * z1740 + n17_7 * z1741 + n51 * z1752;
    const Scalar z1778 = n17_7 * z1740 + n10_45 * z1741 + n25_5 * z1752;
    const Scalar z1731 = n0_3 + z1729;
    const Scalar z1730 = n1_1 - z1727;
    const Scalar z1790 = c_pitch * z1789 + s_pitch * z1787;
    const Scalar z1762 = n1_1 * z1742 - z1755;
    const Scalar z1747 = z31 * v_steer + z1744;  // angular velocity of fork, x
    const Scalar z1760 = n0_3 * z1742 - z1754;
    const Scalar z1748 = z32 * v_steer - z1746;  // angular velocity of fork, z
    const Scalar z1732 = s_pitch * z1730 - c_pitch * z1731;
    const Scalar z1749 = v_front + z1745;  // angular velocity of front_wheel, y
    const Scalar z1763 = z1724 * z1762 - z1723 * z1761 + z1722 * z1760;
    const Scalar z1765 = z1726 * z1762 - z1725 * z1761 + z1724 * z1760;
    const Scalar z1764 = c_steer * z1761 + z1723 * z1760 + z1725 * z1762;
    const Scalar z1733 = s_roll * z1728 + c_roll * z1732;
    const Scalar z1766 = n0_35 * z1745 - z1763;
    const Scalar z1768 = n0_08 * z1745 - z1765;
    const Scalar z1734 = q_z - z1733;
    const Scalar z1758 = s_rear * z1755 + c_rear * z1754;
    const Scalar z1759 = s_rear * z1754 - c_rear * z1755;
    const Scalar z1767 = n0_35 * z1747 - z1764 - n0_08 * z1748;
    const Scalar z1769 = s_front * z1748 - c_front * z1747;
    const Scalar z1770 = s_front * z1747 + c_front * z1748;
    const Scalar z1771 = s_front * z1768 + c_front * z1766;
    const Scalar z1772 = s_front * z1766 - c_front * z1768;
    const Scalar z1773 = n51 * z1742 + n85 * z1754;
    const Scalar z1775 = n25_5 * z1742 - n85 * z1755;
    const Scalar z1777 = n49_25 * z1742 - n25_5 * z1755 + n51 * z1754;
    const Scalar z1779 = n2_8 * z1745 - n4 * z1763;
    const Scalar z1780 = n2_8 * z1747 - n0_8 * z1748 - n4 * z1764;
    const Scalar z1781 = n0_8 * z1745 - n4 * z1765;
    const Scalar z1782 = k16 * z1747 - k17 * z1748 - n2_8 * z1764;
    const Scalar z1783 = n2_18 * z1745 - n2_8 * z1763 - n0_8 * z1765;
    const Scalar z1784 = k17 * z1747 - k19 * z1748 - n0_8 * z1764;
    const Scalar z1791 = s_roll * z1788 - c_roll * z1790;
    result.kinetic = z1752 * z1752 + n0_06 * z1743 * z1743 + k21 * (z1756 * z1756 + z1757 * z1757) + z1758 * z1758
        + n0_14 * z1749 * z1749 + z1759 * z1759 + k23 * (z1769 * z1769 + z1770 * z1770) + n1_5 * (z1767 * z1767 + z1771
        * z1771 + z1772 * z1772) + n0_5 * (z1740 * z1776 + z1741 * z1778 + z1752 * z1774 - z1755 * z1775 + z1754 * z1773
        + z1742 * z1777 + z1747 * z1782 - z1748 * z1784 - z1763 * z1779 - z1764 * z1780 - z1765 * z1781 + z1745
        * z1783);
    result.force_function = n853_47 * q_z + n39_24 * z1737 - n9_81 * (z1786 + z1791) + n29_43 * z1734;
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
    const Scalar z890 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z1896 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z1895 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z1884 = v_yaw * c_roll;
    const Scalar z1883 = v_yaw * s_roll;
    const Scalar z1868 = z32 * s_steer;
    const Scalar z1867 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1869 = -z890 * (n1 - c_steer);
    const Scalar z1870 = z31 * s_steer;
    const Scalar z1871 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1880 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1930 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z1873 = n0_08 * z1868 - n0_35 * z1870;
    const Scalar z1885 = v_roll * c_pitch - s_pitch * z1884;
    const Scalar z1886 = v_roll * s_pitch + c_pitch * z1884;
    const Scalar z1887 = v_pitch + z1883;  // angular velocity of frame, y
    const Scalar z1888 = v_rear + z1887;  // angular velocity of rear_wheel, y
    const Scalar z1872 = n0_08 * z1867 - n0_35 * z1869;
    const Scalar z1933 = n0_8 * z1868 - n2_8 * z1870;
    const Scalar z1874 = n0_08 * z1869 - n0_35 * z1871;
    const Scalar z1881 = c_roll * z1880;
    const Scalar z1889 = z1868 * z1887 - z1869 * z1886 + z1867 * z1885;
    const Scalar z1890 = c_steer * z1887 - z1868 * z1885 + z1870 * z1886;
    const Scalar z1891 = z1870 * z1887 + z1869 * z1885 - z1871 * z1886;
    const Scalar z1897 = v_z * s_roll - c_roll * z1896;
    const Scalar z1898 = v_z * c_roll + s_roll * z1896;
    const Scalar z1901 = s_rear * z1886 - c_rear * z1885;
    const Scalar z1902 = s_rear * z1885 + c_rear * z1886;
    const Scalar z1931 = c_roll * z1930;
    const Scalar z1932 = n0_8 * z1867 - n2_8 * z1869;
    const Scalar z1934 = n0_8 * z1869 - n2_8 * z1871;
    const Scalar z1882 = q_z - z1881;
    const Scalar z1899 = s_pitch * z1898 - c_pitch * z1895;
    const Scalar z1900 = s_pitch * z1895 + c_pitch * z1898;
    const Scalar z1906 = n0_3 * z1885 - z1897 - n1_1 * z1886;
    const Scalar z1919 = n51 * z1885 + n25_5 * z1886 + n85 * z1897;
    const Scalar z1921 = n39_8 * z1885 + n17_7 * z1886 + n51 * z1897;
    const Scalar z1923 = n17_7 * z1885 + n10_45 * z1886 + n25_5 * z1897;
    const Scalar z1876 = n0_3 + z1874;
    const Scalar z1875 = n1_1 - z1872;
    const Scalar z1935 = c_pitch * z1934 + s_pitch * z1932;
    const Scalar z1907 = n1_1 * z1887 - z1900;
    const Scalar z1892 = z31 * v_steer + z1889;  // angular velocity of fork, x
    const Scalar z1905 = n0_3 * z1887 - z1899;
    const Scalar z1893 = z32 * v_steer - z1891;  // angular velocity of fork, z
    const Scalar z1877 = s_pitch * z1875 - c_pitch * z1876;
    const Scalar z1894 = v_front + z1890;  // angular velocity of front_wheel, y
    const Scalar z1908 = z1869 * z1907 - z1868 * z1906 + z1867 * z1905;
    const Scalar z1910 = z1871 * z1907 - z1870 * z1906 + z1869 * z1905;
    const Scalar z1909 = c_steer * z1906 + z1868 * z1905 + z1870 * z1907;
    const Scalar z1878 = s_roll * z1873 + c_roll * z1877;
    const Scalar z1911 = n0_35 * z1890 - z1908;
    const Scalar z1913 = n0_08 * z1890 - z1910;
    const Scalar z1879 = q_z - z1878;
    const Scalar z1903 = s_rear * z1900 + c_rear * z1899;
    const Scalar z1904 = s_rear * z1899 - c_rear * z1900;
    const Scalar z1912 = n0_35 * z1892 - z1909 - n0_08 * z1893;
    const Scalar z1914 = s_front * z1893 - c_front * z1892;
    const Scalar z1915 = s_front * z1892 + c_front * z1893;
    const Scalar z1916 = s_front * z1913 + c_front * z1911;
    const Scalar z1917 = s_front * z1911 - c_front * z1913;
    const Scalar z1918 = n51 * z1887 + n85 * z1899;
    const Scalar z1920 = n25_5 * z1887 - n85 * z1900;
    const Scalar z1922 = n49_25 * z1887 - n25_5 * z1900 + n51 * z1899;
    const Scalar z1924 = n2_8 * z1890 - n4 * z1908;
    const Scalar z1925 = n2_8 * z1892 - n0_8 * z1893 - n4 * z1909;
    const Scalar z1926 = n0_8 * z1890 - n4 * z1910;
    const Scalar z1927 = k16 * z1892 - k17 * z1893 - n2_8 * z1909;
    const Scalar z1928 = n2_18 * z1890 - n2_8 * z1908 - n0_8 * z1910;
    const Scalar z1929 = k17 * z1892 - k19 * z1893 - n0_8 * z1909;
    const Scalar z1936 = s_roll * z1933 - c_roll * z1935;
    result.energy = -n853_47 * q_z + z1897 * z1897 + n0_06 * z1888 * z1888 - n39_24 * z1882 + k23 * (z1901 * z1901
        + z1902 * z1902) + z1903 * z1903 + n0_14 * z1894 * z1894 + z1904 * z1904 + n9_81 * (z1931 + z1936) - n29_43
        * z1879 + k27 * (z1914 * z1914 + z1915 * z1915) + n1_5 * (z1912 * z1912 + z1916 * z1916 + z1917 * z1917) + n0_5
        * (z1885 * z1921 + z1886 * z1923 + z1897 * z1919 - z1900 * z1920 + z1899 * z1918 + z1887 * z1922 + z1892 * z1927
        - z1893 * z1929 - z1908 * z1924 - z1909 * z1925 - z1910 * z1926 + z1890 * z1928);
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
    const Scalar z889 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z890 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z891 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z1947 = z32 * s_steer;
    const Scalar z1949 = z31 * s_steer;
    const Scalar z1965 = v_roll * s_roll;
    const Scalar z1964 = v_yaw * c_yaw;
    const Scalar z1963 = v_roll * c_roll;
    const Scalar z1968 = v_yaw * s_yaw;
    const Scalar z1951 = s_yaw * c_roll;
    const Scalar z1955 = n1 - s_roll * s_roll;
    const Scalar z1946 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1952 = c_yaw * c_roll;
    const Scalar z1948 = -z890 * (n1 - c_steer);
    const Scalar z1950 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1971 = n2 * s_roll;
    const Scalar z1976 = s_yaw * s_roll;
    const Scalar z1978 = c_yaw * s_roll;
    const Scalar z1953 = s_roll * z1951;
    const Scalar z1954 = s_roll * z1952;
    const Scalar z1966 = s_yaw * z1965 - c_roll * z1964;
    const Scalar z1969 = c_yaw * z1965 + c_roll * z1968;
    const Scalar z1972 = z1963 * z1971;
    const Scalar z1977 = s_roll * z1976 - c_roll * z1951;
    const Scalar z1979 = s_roll * z1978 - c_roll * z1952;
    const Scalar z1980 = c_roll * z1971;
    const Scalar z1984 = v_roll * z1963;
    const Scalar z1985 = v_yaw * z1968;
    const Scalar z1986 = n2 * z1965;
    const Scalar z1988 = v_roll * z1965;
    const Scalar z1989 = n2 * z1963;
    const Scalar z1991 = v_yaw * z1964;
    const Scalar z1999 = n0_08 * z1947 - n0_35 * z1949;
    const Scalar z2012 = s_pitch * z1949 - c_pitch * z1947;
    const Scalar z2013 = s_pitch * z1947 + c_pitch * z1949;
    const Scalar z1956 = z1955 * z1955 + z1953 * z1953 + z1954 * z1954;
    const Scalar z1987 = s_yaw * z1984 + c_roll * z1985 + z1964 * z1986;
    const Scalar z1992 = c_yaw * z1984 + c_roll * z1991 - z1968 * z1986;
    const Scalar z1994 = n2 * (s_roll * z1988 - z1963 * z1963);
    const Scalar z1998 = n0_08 * z1946 - n0_35 * z1948;
    const Scalar z2000 = n0_08 * z1948 - n0_35 * z1950;
    const Scalar z1967 = s_roll * z1966 - z1951 * z1963;
    const Scalar z1970 = s_roll * z1969 - z1952 * z1963;
    const Scalar z1981 = n2 * (z1955 * z1980 + z1953 * z1977 + z1954 * z1979);
    const Scalar z2014 = s_roll * z2013 - c_roll * c_steer;
    const Scalar z2015 = s_roll * c_steer + c_roll * z2013;
    const Scalar z2002 = n0_3 + z2000;
    const Scalar z2001 = n1_1 - z1998;
    const Scalar z1957 = traits::sqrt(z1956);
    const Scalar z1973 = n2 * (z1955 * z1972 + z1953 * z1967 + z1954 * z1970);
    const Scalar z1990 = z1951 * z1988 + z1966 * z1989 + s_roll * z1987;
    const Scalar z1993 = z1952 * z1988 + z1969 * z1989 + s_roll * z1992;
    const Scalar z2016 = c_yaw * z2012 + s_yaw * z2014;
    const Scalar z1995 = n2 * (z1953 * z1990 + z1954 * z1993 - z1955 * z1994 - z1967 * z1967 - z1970 * z1970 - z1972
        * z1972);
    const Scalar z2017 = s_yaw * z2012 - c_yaw * z2014;
    const Scalar z2004 = s_pitch * z2001 - c_pitch * z2002;
    const Scalar z2005 = s_roll * z2004 - c_roll * z1999;
    const Scalar z2003 = s_pitch * z2002 + c_pitch * z2001;
    const Scalar z1982 = n0_5 * z1981 / z1957;
    const Scalar z1962 = q_z + n0_3 * z1957;
    const Scalar z1974 = n0_5 * z1973 / z1957;
    const Scalar z2006 = s_roll * z1999 + c_roll * z2004;
    const Scalar z2009 = q_z - z2006;
    const Scalar z2007 = s_yaw * z2005 - c_yaw * z2003;
    const Scalar z2008 = s_yaw * z2003 + c_yaw * z2005;
    const Scalar z2010 = q_y + z2008;
    const Scalar z1958 = n0_3 / z1957;
    const Scalar z2018 = z2015 * z2016;
    const Scalar z2011 = q_x - z2007;
    const Scalar z1959 = q_x + z1953 * z1958;
    const Scalar z2019 = z2015 * z2017;
    const Scalar z1960 = q_y - z1954 * z1958;
    const Scalar z2020 = n1 - z2015 * z2015;
    const Scalar z1983 = n0_3 * z1982;
    const Scalar z1996 = n0_5 * (z1973 * z1974 / (z1957 * z1957) + z1995 / z1957);
    const Scalar z1975 = v_z - n0_3 * z1974;
    const Scalar z1961 = q_z + z1955 * z1958;
    const Scalar z2032 = v_pitch * c_pitch;
    const Scalar z2037 = v_pitch * s_pitch;
    const Scalar z2028 = v_steer * c_steer;
    const Scalar z2033 = v_steer * s_steer;
    const Scalar z2029 = z32 * z2028;
    const Scalar z2030 = z31 * z2028;
    const Scalar z2051 = n2 * z2015;
    const Scalar z2035 = z890 * z2033;
    const Scalar z2021 = z2020 * z2020 + z2018 * z2018 + z2019 * z2019;
    const Scalar z2022 = traits::sqrt(z2021);
    const Scalar z2043 = z1947 * z2032 - z1949 * z2037 + s_pitch * z2029 + c_pitch * z2030;
    const Scalar z2046 = z1947 * z2037 + z1949 * z2032 + s_pitch * z2030 - c_pitch * z2029;
    const Scalar z2034 = -z2033 * (n1 - z889);
    const Scalar z2036 = n0_35 * z2035 + n0_08 * z2034;
    const Scalar z1997 = n0_3 * z1996;
    const Scalar z2045 = c_roll * z2033 + c_steer * z1965 + z1963 * z2013 + s_roll * z2043;
    const Scalar z2049 = z1964 * z2012 + z1968 * z2014 + s_yaw * z2046 - c_yaw * z2045;
    const Scalar z2044 = s_roll * z2033 - c_steer * z1963 + z1965 * z2013 - c_roll * z2043;
    const Scalar z2027 = z2009 + n0_35 * z2022;
    const Scalar z2047 = z1964 * z2014 - z1968 * z2012 + c_yaw * z2046 + s_yaw * z2045;
    const Scalar z2052 = z2044 * z2051;
    const Scalar z2050 = z2015 * z2049 - z2017 * z2044;
    const Scalar z2038 = -z2033 * (n1 - z891);
    const Scalar z2039 = n0_08 * z2035 + n0_35 * z2038;
    const Scalar z2048 = z2015 * z2047 - z2016 * z2044;
    const Scalar z2031 = n0_08 * z2029 - n0_35 * z2030;
    const Scalar z2053 = n2 * (z2020 * z2052 + z2019 * z2050 + z2018 * z2048);
    const Scalar z2040 = s_pitch * z2036 - c_pitch * z2039 - z2001 * z2032 - z2002 * z2037;
    const Scalar z2075 = z32 * c_steer;
    const Scalar z2076 = z31 * c_steer;
    const Scalar z2066 = s_roll * z2012;
    const Scalar z2054 = n0_5 * z2053 / z2022;
    const Scalar z2058 = c_yaw * z2015;
    const Scalar z2059 = z2015 * z2058 + z2014 * z2017;
    const Scalar z2067 = s_yaw * z2066 - c_yaw * z2013;
    const Scalar z2069 = s_yaw * z2013 + c_yaw * z2066;
    const Scalar z2023 = n0_35 / z2022;
    const Scalar z2065 = c_roll * z2012;
    const Scalar z2068 = z2015 * z2067 + z2016 * z2065;
    const Scalar z2070 = z2015 * z2069 - z2017 * z2065;
    const Scalar z2071 = z2051 * z2065;
    const Scalar z2024 = z2011 - z2018 * z2023;
    const Scalar z2041 = z1963 * z1999 + s_roll * z2031 - z1965 * z2004 - c_roll * z2040;
    const Scalar z2072 = n2 * (z2018 * z2068 - z2019 * z2070 - z2020 * z2071);
    const Scalar z2042 = v_z - z2041;
    const Scalar z2055 = z2042 + n0_35 * z2054;
    const Scalar z2026 = z2009 + z2020 * z2023;
    const Scalar z2056 = s_yaw * z2015;
    const Scalar z2057 = z2014 * z2016 - z2015 * z2056;
    const Scalar z2060 = z2014 * z2051;
    const Scalar z2025 = z2010 - z2019 * z2023;
    const Scalar z2101 = v_steer * z2028;
    const Scalar z2107 = v_pitch * z2037;
    const Scalar z2061 = n2 * (z2019 * z2059 - z2020 * z2060 + z2018 * z2057);
    const Scalar z2073 = n0_5 * z2072 / z2022;
    const Scalar z2108 = v_pitch * z2032;
    const Scalar z2097 = v_steer * z2033;
    const Scalar z2098 = z32 * z2097;
    const Scalar z2099 = z31 * z2097;
    const Scalar z2116 = n2 * z2044;
    const Scalar z2085 = s_pitch * z2075 + c_pitch * z2076;
    const Scalar z2111 = z1947 * z2107 + z1949 * z2108 + s_pitch * z2098 + c_pitch * z2099 - n2 * (z2029 * z2032 - z2030
        * z2037);
    const Scalar z2113 = z1949 * z2107 - z1947 * z2108 + s_pitch * z2099 - c_pitch * z2098 - n2 * (z2029 * z2037 + z2030
        * z2032);
    const Scalar z2100 = n0_08 * z2098 - n0_35 * z2099;
    const Scalar z2062 = n0_5 * z2061 / z2022;
    const Scalar z2112 = z1988 * z2013 - c_roll * z2101 - c_steer * z1984 - n2 * (z1963 * z2043 - z1965 * z2033)
        + s_roll * z2111;
    const Scalar z2115 = s_roll * z2101 + c_steer * z1988 + z1984 * z2013 + n2 * (z1963 * z2033 + z1965 * z2043)
        + c_roll * z2111;
    const Scalar z2063 = z2005 - n0_35 * z2062;
    const Scalar z2118 = z1985 * z2012 - z1991 * z2014 - n2 * (z1964 * z2046 + z1968 * z2045) + s_yaw * z2113 - c_yaw
        * z2112;
    const Scalar z2114 = z1991 * z2012 + z1985 * z2014 - n2 * (z1964 * z2045 - z1968 * z2046) + c_yaw * z2113 + s_yaw
        * z2112;
    const Scalar z2119 = z2049 * z2116 + z2017 * z2115 + z2015 * z2118;
    const Scalar z2117 = z2047 * z2116 + z2016 * z2115 + z2015 * z2114;
    const Scalar z2120 = n2 * (z2015 * z2115 - z2044 * z2044);
    const Scalar z2121 = n2 * (z2019 * z2119 - z2052 * z2052 - z2050 * z2050 - z2048 * z2048 - z2020 * z2120 + z2018
        * z2117);
    const Scalar z2088 = s_pitch * z2076 - c_pitch * z2075;
    const Scalar z2077 = n0_08 * z2075 - n0_35 * z2076;
    const Scalar z2087 = c_roll * s_steer + s_roll * z2085;
    const Scalar z2086 = s_roll * s_steer - c_roll * z2085;
    const Scalar z2093 = z2051 * z2086;
    const Scalar z2089 = c_yaw * z2088 + s_yaw * z2087;
    const Scalar z2091 = s_yaw * z2088 - c_yaw * z2087;
    const Scalar z2090 = z2015 * z2089 - z2016 * z2086;
    const Scalar z2092 = z2015 * z2091 - z2017 * z2086;
    const Scalar z2103 = z890 * z2101;
    const Scalar z2102 = -z2101 * (n1 - z889);
    const Scalar z2104 = n0_35 * z2103 + n0_08 * z2102;
    const Scalar z2122 = n0_5 * (z2053 * z2054 / (z2022 * z2022) + z2121 / z2022);
    const Scalar z2094 = n2 * (z2020 * z2093 + z2018 * z2090 + z2019 * z2092);
    const Scalar z2105 = -z2101 * (n1 - z891);
    const Scalar z2106 = n0_08 * z2103 + n0_35 * z2105;
    const Scalar z2079 = s_steer * z890;
    const Scalar z2078 = s_steer * (n1 - z889);
    const Scalar z2080 = n0_08 * z2078 - n0_35 * z2079;
    const Scalar z2109 = s_pitch * z2104 - z2002 * z2108 - c_pitch * z2106 + z2001 * z2107 + n2 * (z2032 * z2036 + z2037
        * z2039);
    const Scalar z2095 = n0_5 * z2094 / z2022;
    const Scalar z2081 = s_steer * (n1 - z891);
    const Scalar z2082 = n0_08 * z2079 - n0_35 * z2081;
    const Scalar z2064 = c_roll * z2003;
    const Scalar z2074 = z2064 + n0_35 * z2073;
    const Scalar z2132 = n0_3 * z1974 / (z1957 * z1957);
    const Scalar z2110 = z1988 * z1999 + s_roll * z2100 + z1984 * z2004 - n2 * (z1963 * z2031 + z1965 * z2040) + c_roll
        * z2109;
    const Scalar z2123 = z2110 - n0_35 * z2122;
    const Scalar z2135 = v_z - z1958 * z1972 + z1955 * z2132;
    const Scalar z2133 = v_y + z1958 * z1970 - z1954 * z2132;
    const Scalar z2141 = v_x - z1958 * z1967 + z1953 * z2132;
    const Scalar z2083 = c_pitch * z2082 + s_pitch * z2080;
    const Scalar z2084 = s_roll * z2077 + c_roll * z2083;
    const Scalar z2124 = q_x - z1959;
    const Scalar z2125 = q_y - z1960;
    const Scalar z2126 = q_z - z1961;
    const Scalar z2136 = v_z - z2135;
    const Scalar z2134 = v_y - z2133;
    const Scalar z2096 = z2084 - n0_35 * z2095;
    const Scalar z2180 = c_roll * z2031 - z1965 * z1999 - z1963 * z2004 + s_roll * z2040;
    const Scalar z2179 = s_pitch * z2039 + c_pitch * z2036 + z2001 * z2037 - z2002 * z2032;
    const Scalar z2183 = n0_35 * z2054 / (z2022 * z2022);
    const Scalar z2186 = z2020 * z2183 - z2042 - z2023 * z2052;
    const Scalar z2173 = z2011 - z2024;
    const Scalar z2174 = z2010 - z2025;
    const Scalar z2142 = v_x - z2141;
    const Scalar z2175 = z2009 - z2026;
    const Scalar z2160 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z2159 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z2161 = s_roll * z2160;
    const Scalar z2153 = s_pitch * z32 + c_pitch * z31;
    const Scalar z2154 = s_pitch * z31 - c_pitch * z32;
    const Scalar z2181 = s_yaw * z2179 - z1964 * z2003 + z1968 * z2005 + c_yaw * z2180;
    const Scalar z2182 = v_y - z2181;
    const Scalar z2163 = s_yaw * z2161 - c_yaw * z2159;
    const Scalar z2167 = q_x - z2163;
    const Scalar z2155 = s_roll * z2154;
    const Scalar z2184 = z2182 - z2023 * z2050 + z2019 * z2183;
    const Scalar z2168 = z2024 - z2167;
    const Scalar z2146 = q_x - z2024;
    const Scalar z2162 = c_roll * z2160;
    const Scalar z2165 = q_z - z2162;
    const Scalar z2164 = s_yaw * z2159 + c_yaw * z2161;
    const Scalar z2166 = q_y + z2164;
    const Scalar z2148 = q_z - z2026;
    const Scalar z2170 = z2026 - z2165;
    const Scalar z2147 = q_y - z2025;
    const Scalar z2156 = c_roll * z2154;
    const Scalar z2185 = v_y - z2184;
    const Scalar z2169 = z2025 - z2166;
    const Scalar z2149 = s_yaw * z2148;
    const Scalar z2150 = c_yaw * z2148;
    const Scalar z2157 = s_yaw * z2155 - c_yaw * z2153;
    const Scalar z2151 = s_roll * z2147 - z1952 * z2148;
    const Scalar z2152 = s_roll * z2146 + z1951 * z2148;
    const Scalar z2158 = s_yaw * z2153 + c_yaw * z2155;
    const Scalar z2127 = s_yaw * z2126;
    const Scalar z2187 = v_z + z2186;
    const Scalar z2128 = c_yaw * z2126;
    const Scalar z2188 = z1964 * z2148 + s_yaw * z2187;
    const Scalar z2137 = z1964 * z2126 + s_yaw * z2136;
    const Scalar z2143 = c_yaw * z2136 - z1968 * z2126;
    const Scalar z2171 = z2156 * z2169 + z2158 * z2170;
    const Scalar z2172 = z2156 * z2168 - z2157 * z2170;
    const Scalar z2129 = s_roll * z2125 - z1952 * z2126;
    const Scalar z2131 = v_x + v_yaw * z2125 - v_roll * z2127 + z2129 * (v_pitch + v_rear);
    const Scalar z2138 = z1963 * z2125 + z1969 * z2126 + s_roll * z2134 - z1952 * z2136;
    const Scalar z2139 = v_yaw * z2134 - v_roll * z2137 + z2138 * (v_pitch + v_rear);
    const Scalar z2189 = z1963 * z2147 + z1969 * z2148 + s_roll * z2185 - z1952 * z2187;
    const Scalar z2144 = z1963 * z2124 - z1966 * z2126 + s_roll * z2142 + z1951 * z2136;
    const Scalar z2145 = v_yaw * z2142 - v_roll * z2143 + z2144 * (v_pitch + v_rear);
    const Scalar z2130 = s_roll * z2124 + z1951 * z2126;
    const Scalar z2140 = v_y - v_yaw * z2124 + v_roll * z2128 - z2130 * (v_pitch + v_rear);
    const Scalar z2210 = s_yaw * z2180 - c_yaw * z2179 - z1964 * z2005 - z1968 * z2003;
    const Scalar z2211 = v_x + z2210;
    const Scalar z2205 = z2182 - z2184;
    const Scalar z2206 = z2042 + z2186;
    const Scalar z2207 = z2015 * z2205 - z2044 * z2174 - z2049 * z2175 - z2017 * z2206;
    const Scalar z2212 = z2211 - z2023 * z2048 + z2018 * z2183;
    const Scalar z2176 = z2015 * z2174 - z2017 * z2175;
    const Scalar z2178 = v_x + v_yaw * z2147 - v_roll * z2149 + v_pitch * z2151 + v_steer * z2171 + v_front * z2176;
    const Scalar z2221 = z2211 - z2212;
    const Scalar z2222 = z2015 * z2221 - z2044 * z2173 - z2047 * z2175 - z2016 * z2206;
    const Scalar z2177 = z2015 * z2173 - z2016 * z2175;
    const Scalar z2209 = v_y - v_yaw * z2146 + v_roll * z2150 - v_pitch * z2152 - v_steer * z2172 - v_front * z2177;
    const Scalar z2192 = n0_3 * z2032 - n1_1 * z2037;
    const Scalar z2198 = z31 * z2037 - z32 * z2032;
    const Scalar z2190 = z31 * z2032 + z32 * z2037;
    const Scalar z2193 = n1_1 * z2032 + n0_3 * z2037;
    const Scalar z2194 = z1963 * z2160 + s_roll * z2193;
    const Scalar z2201 = c_roll * z2193 - z1965 * z2160;
    const Scalar z2191 = c_roll * z2190 - z1965 * z2154;
    const Scalar z2199 = z1963 * z2154 + s_roll * z2190;
    const Scalar z2216 = z1968 * z2159 - c_yaw * z2192 + z1964 * z2161 + s_yaw * z2194;
    const Scalar z2195 = z1964 * z2159 + s_yaw * z2192 - z1968 * z2161 + c_yaw * z2194;
    const Scalar z2217 = v_x - z2216;
    const Scalar z2218 = z2212 - z2217;
    const Scalar z2213 = v_x - z2212;
    const Scalar z2215 = z1963 * z2146 - z1966 * z2148 + s_roll * z2213 + z1951 * z2187;
    const Scalar z2214 = c_yaw * z2187 - z1968 * z2148;
    const Scalar z2196 = v_y + z2195;
    const Scalar z2197 = z2184 - z2196;
    const Scalar z2202 = v_z - z2201;
    const Scalar z2203 = z2186 + z2202;
    const Scalar z2219 = z1968 * z2153 + c_yaw * z2198 + z1964 * z2155 + s_yaw * z2199;
    const Scalar z2200 = s_yaw * z2198 - z1964 * z2153 + z1968 * z2155 - c_yaw * z2199;
    const Scalar z2220 = z2168 * z2191 - z2170 * z2219 + z2156 * z2218 + z2157 * z2203;
    const Scalar z2204 = z2169 * z2191 - z2170 * z2200 + z2156 * z2197 - z2158 * z2203;
    const Scalar z2223 = v_yaw * z2213 + v_pitch * z2215 + v_steer * z2220 - v_roll * z2214 + v_front * z2222;
    const Scalar z2208 = v_yaw * z2185 - v_roll * z2188 + v_pitch * z2189 + v_steer * z2204 + v_front * z2207;
    result.value[0] = -z1962;
    result.rate[0] = -z1975;
    result.gamma[0] = z1997;
    result.value[1] = -z2027;
    result.rate[1] = -z2055;
    result.gamma[1] = -z2123;
    result.value[2] = n0;
    result.rate[2] = z2131;
    result.gamma[2] = z2139;
    result.value[3] = n0;
    result.rate[3] = -z2140;
    result.gamma[3] = z2145;
    result.value[4] = n0;
    result.rate[4] = z2178;
    result.gamma[4] = z2208;
    result.value[5] = n0;
    result.rate[5] = -z2209;
    result.gamma[5] = z2223;
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
    result.jacobian[20] = z2125;
    result.jacobian[21] = z2124;
    result.jacobian[22] = z2147;
    result.jacobian[23] = z2146;
    result.jacobian[24] = z1983;
    result.jacobian[25] = -z2063;
    result.jacobian[26] = -z2127;
    result.jacobian[27] = -z2128;
    result.jacobian[28] = -z2149;
    result.jacobian[29] = -z2150;
    result.jacobian[30] = n0;
    result.jacobian[31] = z2074;
    result.jacobian[32] = z2129;
    result.jacobian[33] = z2130;
    result.jacobian[34] = z2151;
    result.jacobian[35] = z2152;
    result.jacobian[36] = n0;
    result.jacobian[37] = z2096;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z2171;
    result.jacobian[41] = z2172;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z2129;
    result.jacobian[45] = z2130;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z2176;
    result.jacobian[53] = z2177;
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
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k31 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k33 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k34 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
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
    const Scalar z449 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z450 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z31 - k4 * z32;
    });
    const Scalar z451 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z31 - k5 * z32;
    });
    const Scalar z587 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z450 - z32 * z451;
    });
    const Scalar z889 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z890 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z891 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z4110 = z32 * s_steer;
    const Scalar z4112 = z31 * s_steer;
    const Scalar z4109 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z4111 = -z890 * (n1 - c_steer);
    const Scalar z4127 = v_roll * s_roll;
    const Scalar z4113 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z4126 = v_yaw * c_yaw;
    const Scalar z4125 = v_roll * c_roll;
    const Scalar z4130 = v_yaw * s_yaw;
    const Scalar z4114 = s_yaw * c_roll;
    const Scalar z4118 = n1 - s_roll * s_roll;
    const Scalar z4115 = c_yaw * c_roll;
    const Scalar z4137 = s_yaw * s_roll;
    const Scalar z4133 = n2 * s_roll;
    const Scalar z4139 = c_yaw * s_roll;
    const Scalar z4116 = s_roll * z4114;
    const Scalar z4117 = s_roll * z4115;
    const Scalar z4128 = s_yaw * z4127 - c_roll * z4126;
    const Scalar z4131 = c_yaw * z4127 + c_roll * z4130;
    const Scalar z4134 = z4125 * z4133;
    const Scalar z4138 = s_roll * z4137 - c_roll * z4114;
    const Scalar z4140 = s_roll * z4139 - c_roll * z4115;
    const Scalar z4141 = c_roll * z4133;
    const Scalar z4145 = v_roll * z4125;
    const Scalar z4146 = v_yaw * z4130;
    const Scalar z4147 = n2 * z4127;
    const Scalar z4149 = v_roll * z4127;
    const Scalar z4150 = n2 * z4125;
    const Scalar z4152 = v_yaw * z4126;
    const Scalar z4160 = n0_08 * z4110 - n0_35 * z4112;
    const Scalar z4174 = s_pitch * z4112 - c_pitch * z4110;
    const Scalar z4175 = s_pitch * z4110 + c_pitch * z4112;
    const Scalar z4119 = z4118 * z4118 + z4116 * z4116 + z4117 * z4117;
    const Scalar z4148 = s_yaw * z4145 + c_roll * z4146 + z4126 * z4147;
    const Scalar z4153 = c_yaw * z4145 + c_roll * z4152 - z4130 * z4147;
    const Scalar z4155 = n2 * (s_roll * z4149 - z4125 * z4125);
    const Scalar z4159 = n0_08 * z4109 - n0_35 * z4111;
    const Scalar z4161 = n0_08 * z4111 - n0_35 * z4113;
    const Scalar z4129 = s_roll * z4128 - z4114 * z4125;
    const Scalar z4132 = s_roll * z4131 - z4115 * z4125;
    const Scalar z4142 = n2 * (z4118 * z4141 + z4116 * z4138 + z4117 * z4140);
    const Scalar z4167 = s_roll * z4160;
    const Scalar z4176 = s_roll * z4175;
    const Scalar z4178 = s_roll * c_steer + c_roll * z4175;
    const Scalar z4179 = c_yaw * z4174;
    const Scalar z4163 = n0_3 + z4161;
    const Scalar z4177 = c_roll * c_steer - z4176;
    const Scalar z4162 = n1_1 - z4159;
    const Scalar z4120 = traits::sqrt(z4119);
    const Scalar z4135 = n2 * (z4118 * z4134 + z4116 * z4129 + z4117 * z4132);
    const Scalar z4151 = z4114 * z4149 + z4128 * z4150 + s_roll * z4148;
    const Scalar z4180 = s_yaw * z4177 - z4179;
    const Scalar z4165 = s_pitch * z4162 - c_pitch * z4163;
    const Scalar z4164 = s_pitch * z4163 + c_pitch * z4162;
    const Scalar z4154 = z4115 * z4149 + z4131 * z4150 + s_roll * z4153;
    const Scalar z4166 = s_roll * z4165 - c_roll * z4160;
    const Scalar z4168 = c_roll * z4165 + z4167;
    const Scalar z4156 = n2 * (z4116 * z4151 + z4117 * z4154 - z4118 * z4155 - z4129 * z4129 - z4132 * z4132 - z4134
        * z4134);
    const Scalar z4170 = s_yaw * z4164 + c_yaw * z4166;
    const Scalar z4171 = q_z - z4168;
    const Scalar z4172 = q_y + z4170;
    const Scalar z4169 = s_yaw * z4166 - c_yaw * z4164;
    const Scalar z4121 = n0_3 / z4120;
    const Scalar z4181 = s_yaw * z4174;
    const Scalar z4173 = q_x - z4169;
    const Scalar z4143 = n0_5 * z4142 / z4120;
    const Scalar z4136 = n0_5 * z4135 / z4120;
    const Scalar z4122 = q_x + z4116 * z4121;
    const Scalar z4182 = c_yaw * z4177 + z4181;
    const Scalar z4123 = q_y - z4117 * z4121;
    const Scalar z4183 = z4178 * z4180;
    const Scalar z4124 = q_z + z4118 * z4121;
    const Scalar z4185 = n1 - z4178 * z4178;
    const Scalar z4184 = z4178 * z4182;
    const Scalar z4186 = z4185 * z4185 + z4183 * z4183 + z4184 * z4184;
    const Scalar z4196 = v_pitch * c_pitch;
    const Scalar z4201 = v_pitch * s_pitch;
    const Scalar z4192 = v_steer * c_steer;
    const Scalar z4197 = v_steer * s_steer;
    const Scalar z4193 = z32 * z4192;
    const Scalar z4194 = z31 * z4192;
    const Scalar z4199 = z890 * z4197;
    const Scalar z4202 = -z4197 * (n1 - z891);
    const Scalar z4198 = -z4197 * (n1 - z889);
    const Scalar z4203 = n0_08 * z4199 + n0_35 * z4202;
    const Scalar z4200 = n0_35 * z4199 + n0_08 * z4198;
    const Scalar z4187 = traits::sqrt(z4186);
    const Scalar z4195 = n0_08 * z4193 - n0_35 * z4194;
    const Scalar z4144 = n0_3 * z4143;
    const Scalar z4209 = c_roll * z4197;
    const Scalar z4207 = z4110 * z4196 - z4112 * z4201 + s_pitch * z4193 + c_pitch * z4194;
    const Scalar z4211 = z4110 * z4201 + z4112 * z4196 + s_pitch * z4194 - c_pitch * z4193;
    const Scalar z4210 = c_steer * z4127 + z4209 + z4125 * z4175 + s_roll * z4207;
    const Scalar z4216 = n2 * z4178;
    const Scalar z4208 = s_roll * z4197 - c_steer * z4125 + z4127 * z4175 - c_roll * z4207;
    const Scalar z4214 = z4126 * z4174 - z4130 * z4177 + s_yaw * z4211 - c_yaw * z4210;
    const Scalar z4188 = n0_35 / z4187;
    const Scalar z4215 = z4178 * z4214 - z4182 * z4208;
    const Scalar z4212 = c_yaw * z4211 - z4130 * z4174 - z4126 * z4177 + s_yaw * z4210;
    const Scalar z4213 = z4180 * z4208 + z4178 * z4212;
    const Scalar z4204 = s_pitch * z4200 - c_pitch * z4203 - z4162 * z4196 - z4163 * z4201;
    const Scalar z4191 = z4171 + z4185 * z4188;
    const Scalar z4190 = z4172 - z4184 * z4188;
    const Scalar z4189 = z4173 + z4183 * z4188;
    const Scalar z4205 = z4125 * z4160 + s_roll * z4195 - z4127 * z4165 - c_roll * z4204;
    const Scalar z4206 = v_z - z4205;
    const Scalar z4157 = n0_5 * (z4135 * z4136 / (z4120 * z4120) + z4156 / z4120);
    const Scalar z4158 = n0_3 * z4157;
    const Scalar z4239 = z32 * c_steer;
    const Scalar z4240 = z31 * c_steer;
    const Scalar z4249 = s_pitch * z4239 + c_pitch * z4240;
    const Scalar z4252 = s_pitch * z4240 - c_pitch * z4239;
    const Scalar z4230 = s_roll * z4174;
    const Scalar z4233 = s_yaw * z4175 + c_yaw * z4230;
    const Scalar z4229 = c_roll * z4174;
    const Scalar z4220 = s_yaw * z4178;
    const Scalar z4231 = s_yaw * z4230 - c_yaw * z4175;
    const Scalar z4251 = c_roll * s_steer + s_roll * z4249;
    const Scalar z4250 = s_roll * s_steer - c_roll * z4249;
    const Scalar z4253 = c_yaw * z4252 + s_yaw * z4251;
    const Scalar z4255 = s_yaw * z4252 - c_yaw * z4251;
    const Scalar z4235 = z4216 * z4229;
    const Scalar z4222 = c_yaw * z4178;
    const Scalar z4271 = v_pitch * z4201;
    const Scalar z4221 = z4177 * z4180 - z4178 * z4220;
    const Scalar z4234 = z4178 * z4233 - z4182 * z4229;
    const Scalar z4254 = z4178 * z4253 + z4180 * z4250;
    const Scalar z4272 = v_pitch * z4196;
    const Scalar z4223 = z4177 * z4182 - z4178 * z4222;
    const Scalar z4261 = v_steer * z4197;
    const Scalar z4265 = v_steer * z4192;
    const Scalar z4256 = z4178 * z4255 - z4182 * z4250;
    const Scalar z4232 = z4178 * z4231 - z4180 * z4229;
    const Scalar z4262 = z32 * z4261;
    const Scalar z4224 = z4177 * z4216;
    const Scalar z4217 = z4208 * z4216;
    const Scalar z4257 = z4216 * z4250;
    const Scalar z4263 = z31 * z4261;
    const Scalar z4236 = n2 * (z4185 * z4235 + z4184 * z4234 + z4183 * z4232);
    const Scalar z4225 = n2 * (z4183 * z4221 + z4184 * z4223 - z4185 * z4224);
    const Scalar z4258 = n2 * (z4183 * z4254 - z4184 * z4256 - z4185 * z4257);
    const Scalar z4275 = z4110 * z4271 + z4112 * z4272 + s_pitch * z4262 + c_pitch * z4263 - n2 * (z4193 * z4196 - z4194
        * z4201);
    const Scalar z4243 = s_steer * z890;
    const Scalar z4242 = s_steer * (n1 - z889);
    const Scalar z4244 = n0_08 * z4242 - n0_35 * z4243;
    const Scalar z4245 = s_steer * (n1 - z891);
    const Scalar z4246 = n0_08 * z4243 - n0_35 * z4245;
    const Scalar z4277 = z4112 * z4271 - z4110 * z4272 + s_pitch * z4263 - c_pitch * z4262 - n2 * (z4193 * z4201 + z4194
        * z4196);
    const Scalar z4264 = n0_08 * z4262 - n0_35 * z4263;
    const Scalar z4276 = z4149 * z4175 - c_roll * z4265 - c_steer * z4145 - n2 * (z4125 * z4207 - z4127 * z4197)
        + s_roll * z4275;
    const Scalar z4218 = n2 * (z4183 * z4213 - z4184 * z4215 - z4185 * z4217);
    const Scalar z4237 = n0_5 * z4236 / z4187;
    const Scalar z4226 = n0_5 * z4225 / z4187;
    const Scalar z4259 = n0_5 * z4258 / z4187;
    const Scalar z4247 = c_pitch * z4246 + s_pitch * z4244;
    const Scalar z4241 = n0_08 * z4239 - n0_35 * z4240;
    const Scalar z4228 = c_roll * z4164;
    const Scalar z4248 = s_roll * z4241 + c_roll * z4247;
    const Scalar z4278 = z4152 * z4174 - z4146 * z4177 - n2 * (z4126 * z4210 - z4130 * z4211) + c_yaw * z4277 + s_yaw
        * z4276;
    const Scalar z4219 = n0_5 * z4218 / z4187;
    const Scalar z4279 = s_roll * z4265 + c_steer * z4149 + z4145 * z4175 + n2 * (z4125 * z4197 + z4127 * z4207)
        + c_roll * z4275;
    const Scalar z4280 = n2 * z4208;
    const Scalar z4282 = z4146 * z4174 + z4152 * z4177 - n2 * (z4126 * z4211 + z4130 * z4210) + s_yaw * z4277 - c_yaw
        * z4276;
    const Scalar z4284 = n2 * (z4178 * z4279 - z4208 * z4208);
    const Scalar z4283 = z4214 * z4280 + z4182 * z4279 + z4178 * z4282;
    const Scalar z4238 = z4228 - n0_35 * z4237;
    const Scalar z4281 = z4212 * z4280 - z4180 * z4279 + z4178 * z4278;
    const Scalar z4227 = z4166 + n0_35 * z4226;
    const Scalar z4289 = q_x - z4122;
    const Scalar z4291 = q_z - z4124;
    const Scalar z4290 = q_y - z4123;
    const Scalar z4313 = q_x - z4189;
    const Scalar z4314 = q_y - z4190;
    const Scalar z4315 = q_z - z4191;
    const Scalar z4267 = z890 * z4265;
    const Scalar z4285 = n2 * (z4217 * z4217 + z4215 * z4215 + z4213 * z4213 + z4185 * z4284 - z4184 * z4283 + z4183
        * z4281);
    const Scalar z4316 = s_yaw * z4315;
    const Scalar z4266 = -z4265 * (n1 - z889);
    const Scalar z4268 = n0_35 * z4267 + n0_08 * z4266;
    const Scalar z4306 = z4121 * z4129;
    const Scalar z4260 = z4248 + n0_35 * z4259;
    const Scalar z4326 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z4327 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z4328 = s_roll * z4327;
    const Scalar z4321 = s_pitch * z31 - c_pitch * z32;
    const Scalar z4320 = s_pitch * z32 + c_pitch * z31;
    const Scalar z4322 = s_roll * z4321;
    const Scalar z4323 = c_roll * z4321;
    const Scalar z4317 = c_yaw * z4315;
    const Scalar z4325 = s_yaw * z4320 + c_yaw * z4322;
    const Scalar z4324 = s_yaw * z4322 - c_yaw * z4320;
    const Scalar z4269 = -z4265 * (n1 - z891);
    const Scalar z4270 = n0_08 * z4267 + n0_35 * z4269;
    const Scalar z4331 = s_yaw * z4326 + c_yaw * z4328;
    const Scalar z4329 = c_roll * z4327;
    const Scalar z4330 = s_yaw * z4328 - c_yaw * z4326;
    const Scalar z4332 = q_z - z4329;
    const Scalar z4296 = n0_3 * z4136 / (z4120 * z4120);
    const Scalar z4319 = s_roll * z4313 + z4114 * z4315;
    const Scalar z4295 = s_roll * z4289 + z4114 * z4291;
    const Scalar z4318 = s_roll * z4314 - z4115 * z4315;
    const Scalar z4286 = z4218 * z4219;
    const Scalar z4292 = s_yaw * z4291;
    const Scalar z4307 = v_x - z4306 + z4116 * z4296;
    const Scalar z4308 = v_x - z4307;
    const Scalar z4294 = s_roll * z4290 - z4115 * z4291;
    const Scalar z4297 = z4121 * z4132;
    const Scalar z4293 = c_yaw * z4291;
    const Scalar z4298 = v_y + z4297 - z4117 * z4296;
    const Scalar z4300 = v_z - z4121 * z4134 + z4118 * z4296;
    const Scalar z4301 = v_z - z4300;
    const Scalar z4273 = s_pitch * z4268 - z4163 * z4272 - c_pitch * z4270 + z4162 * z4271 + n2 * (z4196 * z4200 + z4201
        * z4203);
    const Scalar z4299 = v_y - z4298;
    const Scalar z4333 = q_y + z4331;
    const Scalar z4309 = c_yaw * z4301 - z4130 * z4291;
    const Scalar z4310 = z4114 * z4301;
    const Scalar z4311 = z4125 * z4289 - z4128 * z4291 + s_roll * z4308 + z4310;
    const Scalar z4302 = z4126 * z4291 + s_yaw * z4301;
    const Scalar z4303 = z4115 * z4301;
    const Scalar z4274 = z4149 * z4160 + s_roll * z4264 + z4145 * z4165 - n2 * (z4125 * z4195 + z4127 * z4204) + c_roll
        * z4273;
    const Scalar z4344 = z4171 - z4191;
    const Scalar z4337 = z4191 - z4332;
    const Scalar z4343 = z4172 - z4190;
    const Scalar z4336 = z4190 - z4333;
    const Scalar z4342 = z4173 - z4189;
    const Scalar z4345 = z4182 * z4344;
    const Scalar z4334 = q_x - z4330;
    const Scalar z4335 = z4189 - z4334;
    const Scalar z4346 = z4178 * z4343 - z4345;
    const Scalar z4340 = z4324 * z4337;
    const Scalar z4338 = z4325 * z4337;
    const Scalar z4339 = z4323 * z4336 + z4338;
    const Scalar z4341 = z4323 * z4335 - z4340;
    const Scalar z4287 = n0_5 * (z4286 / (z4187 * z4187) - z4285 / z4187);
    const Scalar z4288 = z4274 - n0_35 * z4287;
    const Scalar z4349 = s_pitch * z4203;
    const Scalar z4347 = z4180 * z4344;
    const Scalar z4348 = z4178 * z4342 + z4347;
    const Scalar z4351 = c_roll * z4195;
    const Scalar z4350 = z4349 + c_pitch * z4200 - z4163 * z4196 + z4162 * z4201;
    const Scalar z4352 = z4351 - z4127 * z4160 - z4125 * z4165 + s_roll * z4204;
    const Scalar z4363 = z31 * z4196 + z32 * z4201;
    const Scalar z4355 = n0_35 * z4219 / (z4187 * z4187);
    const Scalar z4358 = z4206 + z4188 * z4217 + z4185 * z4355;
    const Scalar z4361 = z4131 * z4315;
    const Scalar z4304 = z4125 * z4290 + z4131 * z4291 + s_roll * z4299 - z4303;
    const Scalar z4353 = s_yaw * z4350 - z4126 * z4164 + z4130 * z4166 + c_yaw * z4352;
    const Scalar z4364 = c_roll * z4363 - z4127 * z4321;
    const Scalar z4359 = v_z - z4358;
    const Scalar z4360 = z4126 * z4315 + s_yaw * z4359;
    const Scalar z4312 = v_yaw * z4308 + z4311 * (v_pitch + v_rear) - v_roll * z4309;
    const Scalar z4305 = v_yaw * z4299 - v_roll * z4302 + z4304 * (v_pitch + v_rear);
    const Scalar z4380 = z4206 - z4358;
    const Scalar z4401 = v_yaw * s_roll;
    const Scalar z4402 = v_yaw * c_roll;
    const Scalar z4407 = v_pitch + z4401;  // angular velocity of frame, y
    const Scalar z4405 = v_roll * c_pitch - s_pitch * z4402;
    const Scalar z4406 = v_roll * s_pitch + c_pitch * z4402;
    const Scalar z4371 = z31 * z4201 - z32 * z4196;
    const Scalar z4413 = z4405 * z4407;
    const Scalar z4409 = z4407 * z4407;
    const Scalar z4410 = z4406 * z4406;
    const Scalar z4412 = z4405 * z4406;
    const Scalar z4411 = z4409 + z4410;
    const Scalar z4354 = v_y - z4353;
    const Scalar z4415 = z4405 * z4405;
    const Scalar z4414 = z4406 * z4407;
    const Scalar z4365 = n0_3 * z4196 - n1_1 * z4201;
    const Scalar z4408 = v_rear + z4407;  // angular velocity of rear_wheel, y
    const Scalar z4372 = z4125 * z4321 + s_roll * z4363;
    const Scalar z4366 = n1_1 * z4196 + n0_3 * z4201;
    const Scalar z4384 = s_yaw * z4352 - c_yaw * z4350 - z4126 * z4166 - z4130 * z4164;
    const Scalar z4373 = s_yaw * z4371 - z4126 * z4320 + z4130 * z4322 - c_yaw * z4372;
    const Scalar z4356 = z4188 * z4215 - z4354 + z4184 * z4355;
    const Scalar z4416 = z4409 + z4415;
    const Scalar z4379 = z4354 + z4356;
    const Scalar z4367 = z4125 * z4327 + s_roll * z4366;
    const Scalar z4385 = v_x + z4384;
    const Scalar z4368 = z4126 * z4326 + s_yaw * z4365 - z4130 * z4328 + c_yaw * z4367;
    const Scalar z4369 = v_y + z4368;
    const Scalar z4374 = c_roll * z4366 - z4127 * z4327;
    const Scalar z4386 = z4385 - z4188 * z4213 + z4183 * z4355;
    const Scalar z4370 = z4356 + z4369;
    const Scalar z4357 = v_y + z4356;
    const Scalar z4397 = z4385 - z4386;
    const Scalar z4419 = z4112 * z4407 + z4111 * z4405 - z4113 * z4406;
    const Scalar z4417 = z4110 * z4407 - z4111 * z4406 + z4109 * z4405;
    const Scalar z4421 = z31 * v_steer;
    const Scalar z4418 = c_steer * z4407 - z4110 * z4405 + z4112 * z4406;
    const Scalar z4420 = z31 * z4419 + z32 * z4417;
    const Scalar z4391 = z4130 * z4326 - c_yaw * z4365 + z4126 * z4328 + s_yaw * z4367;
    const Scalar z4375 = v_z - z4374;
    const Scalar z4376 = z4358 - z4375;
    const Scalar z4387 = v_x - z4386;
    const Scalar z4394 = z4130 * z4320 + c_yaw * z4371 + z4126 * z4322 + s_yaw * z4372;
    const Scalar z4392 = v_x - z4391;
    const Scalar z4393 = z4386 - z4392;
    const Scalar z4389 = z4128 * z4315;
    const Scalar z4377 = z4337 * z4373;
    const Scalar z4395 = z4337 * z4394;
    const Scalar z4398 = z4212 * z4344;
    const Scalar z4403 = v_roll * z4402;  // angular acceleration of frame.2, y
    const Scalar z4404 = v_roll * z4401;  // angular acceleration of frame.2, z
    const Scalar z4381 = z4214 * z4344;
    const Scalar z4388 = c_yaw * z4359 - z4130 * z4315;
    const Scalar z4362 = z4125 * z4314 + z4361 + s_roll * z4357 - z4115 * z4359;
    const Scalar z4422 = z4417 + z4421;  // angular velocity of fork, x
    const Scalar z4423 = z32 * v_steer;
    const Scalar z4424 = z4419 - z4423;  // angular velocity of fork, z
    const Scalar z4433 = v_front + z4418;  // angular velocity of front_wheel, y
    const Scalar z4425 = z4418 * z4418;
    const Scalar z4431 = z4422 * z4422;
    const Scalar z4429 = z4418 * z4422;
    const Scalar z4432 = z4425 + z4431;
    const Scalar z4426 = z4424 * z4424;
    const Scalar z4428 = z4422 * z4424;
    const Scalar z4430 = z4418 * z4424;
    const Scalar z4434 = z4424 * z4433;
    const Scalar z4435 = z4422 * z4433;
    const Scalar z4437 = n0_28 * z4435;  // moment on front_wheel, z
    const Scalar z4427 = z4425 + z4426;
    const Scalar z4436 = n0_28 * z4434;  // moment on front_wheel, x
    const Scalar z4390 = z4125 * z4313 - z4389 + s_roll * z4387 + z4114 * z4359;
    const Scalar z4378 = z4377 - z4336 * z4364 + z4323 * z4370 - z4325 * z4376;
    const Scalar z4438 = z4426 - z4431;
    const Scalar z4440 = z4405 * z4408;
    const Scalar z4439 = z4406 * z4408;
    const Scalar z4441 = n0_12 * z4439;  // moment on rear_wheel, x
    const Scalar z4396 = z4335 * z4364 - z4395 + z4323 * z4393 - z4324 * z4376;
    const Scalar z4382 = z4178 * z4379 - z4381 - z4208 * z4343 - z4182 * z4380;
    const Scalar z4442 = n0_12 * z4440;  // moment on rear_wheel, z
    const Scalar z4399 = z4178 * z4397 - z4398 - z4208 * z4342 + z4180 * z4380;
    const Scalar z4383 = v_yaw * z4357 - v_roll * z4360 + v_pitch * z4362 - v_steer * z4378 + v_front * z4382;
    const Scalar z4451 = z449 * z4110;
    const Scalar z4443 = z4410 - z4415;
    const Scalar z4453 = z449 * z4112;
    const Scalar z4455 = z450 * z4110 + z451 * z4112;
    const Scalar z4458 = n0_3 * z4451 - z4455 + n1_1 * z4453;
    const Scalar z4452 = c_steer * z449;
    const Scalar z4454 = z451 * z4111 + z450 * z4109;
    const Scalar z4457 = n0_3 * z4452 - z4454;
    const Scalar z4445 = n0_28 * z4110;
    const Scalar z4456 = z450 * z4111 + z451 * z4113;
    const Scalar z4459 = n1_1 * z4452 - z4456;
    const Scalar z4447 = n0_28 * z4112;
    const Scalar z4446 = n0_28 * c_steer;
    const Scalar z4449 = s_pitch * z4445 + c_pitch * z4447;
    const Scalar z4448 = s_pitch * z4447 - c_pitch * z4445;
    const Scalar z4444 = z4401 * z4402;
    const Scalar z4450 = s_roll * z4446 + c_roll * z4449;
    const Scalar z4400 = v_yaw * z4387 - v_roll * z4388 + v_pitch * z4390 + v_steer * z4396 + v_front * z4399;
    const Scalar z4480 = n2_8467 * z4112;
    const Scalar z4472 = k4 * z4111;
    const Scalar z4474 = n2_8467 * z4110;
    const Scalar z4479 = k3 * z4111 + k4 * z4113;
    const Scalar z4471 = n1_04 * z4111 - n3_85 * z4113;
    const Scalar z4473 = k3 * z4109 + z4472;
    const Scalar z4481 = k5 * z4113 + z4472;
    const Scalar z4469 = n1_04 * z4109 - n3_85 * z4111;
    const Scalar z4475 = k5 * z4111 + k4 * z4109;
    const Scalar z4482 = z4110 * z4474 + z4109 * z4473 + z4111 * z4475;
    const Scalar z4477 = n2_8467 * c_steer;
    const Scalar z4487 = z4112 * z4480 + z4111 * z4479 + z4113 * z4481;
    const Scalar z4493 = n8_47 - n2_2 * z4469 + z4487;
    const Scalar z4488 = n0_63 + n0_6 * z4471 + z4482;
    const Scalar z4500 = n29_35 - z4493;
    const Scalar z4476 = k3 * z4110 + k4 * z4112;
    const Scalar z4485 = z4110 * z4480 + z4109 * z4479 + z4111 * z4481;
    const Scalar z4486 = c_steer * z4480 - z4110 * z4479 - z4112 * z4481;
    const Scalar z4491 = n2_31 + n1_1 * z4471 - n0_3 * z4469 + z4485;
    const Scalar z4499 = n17_7 - z4491;
    const Scalar z4478 = k4 * z4110 + k5 * z4112;
    const Scalar z4512 = z4488 + z4500;
    const Scalar z4484 = c_steer * z4477 + z4110 * z4476 + z4112 * z4478;
    const Scalar z4483 = z4109 * z4476 - z4110 * z4477 + z4111 * z4478;
    const Scalar z4490 = n9_1 + n0_6 * z4471 - n2_2 * z4469 + z4484;
    const Scalar z4498 = n49_25 + z4490;
    const Scalar z4513 = n2 * z4499;
    const Scalar z4514 = s_pitch * z4512 - c_pitch * z4513;
    const Scalar z4470 = n1_04 * z4110 - n3_85 * z4112;
    const Scalar z4489 = n1_1 * z4470 + z4483;
    const Scalar z4502 = n0_12 + z4498;
    const Scalar z4492 = n0_3 * z4470 + z4486;
    const Scalar z4495 = n2_1 + z4471;
    const Scalar z4497 = n51 - z4495;
    const Scalar z4494 = n7_7 - z4469;
    const Scalar z4496 = n25_5 + z4494;
    const Scalar z4515 = s_pitch * z4514;
    const Scalar z4518 = c_pitch * z4514 + z4499;
    const Scalar z4516 = z4500 - z4515;
    const Scalar z4517 = z4488 - z4515;
    const Scalar z4506 = s_pitch * z4489 - c_pitch * z4492;
    const Scalar z4519 = n39_8603 + z4517;
    const Scalar z4503 = c_pitch * z4497 + s_pitch * z4496;
    const Scalar z4461 = s_pitch * z4451 + c_pitch * z4453;
    const Scalar z4504 = s_pitch * z4497 - c_pitch * z4496;
    const Scalar z4460 = s_pitch * z4453 - c_pitch * z4451;
    const Scalar z4520 = n39_8603 - z4502;
    const Scalar z4507 = s_roll * z4504;
    const Scalar z4464 = s_roll * z4461 - c_roll * z4452;
    const Scalar z4501 = n0_12 * s_roll;
    const Scalar z4463 = s_pitch * z4457 + c_pitch * z4459;
    const Scalar z4467 = c_yaw * z4460 + s_yaw * z4464;
    const Scalar z4468 = s_yaw * z4460 - c_yaw * z4464;
    const Scalar z4511 = s_yaw * z4503 + c_yaw * z4507;
    const Scalar z4505 = s_pitch * z4492 + c_pitch * z4489;
    const Scalar z4508 = c_roll * z4504;
    const Scalar z4510 = s_yaw * z4507 - c_yaw * z4503;
    const Scalar z4466 = s_roll * z4458 - c_roll * z4463;
    const Scalar z4462 = s_pitch * z4459 - c_pitch * z4457;
    const Scalar z4522 = s_roll * z4503 - c_roll * z4470;
    const Scalar z4465 = s_roll * z4452 + c_roll * z4461;
    const Scalar z4542 = a_yaw * c_roll;
    const Scalar z4546 = v_roll * z4401 - z4542;  // angular acceleration of frame.2, z
    const Scalar z4540 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z4541 = a_yaw * s_roll;
    const Scalar z4545 = v_roll * z4402 + z4541;  // angular acceleration of frame.2, y
    const Scalar z4538 = n9_81 - a_z;
    const Scalar z4536 = s_front * z4424 + c_front * z4422;
    const Scalar z4548 = a_roll * s_pitch - c_pitch * z4546;
    const Scalar z4537 = s_front * z4422 - c_front * z4424;
    const Scalar z4553 = v_pitch * z4405 + z4548;  // angular acceleration of frame, z
    const Scalar z4539 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z4544 = s_roll * z4540 - c_roll * z4538;
    const Scalar z4547 = a_roll * c_pitch + s_pitch * z4546;
    const Scalar z4551 = v_pitch * z4406 - z4547;  // angular acceleration of frame, x
    const Scalar z4552 = a_pitch + z4545;  // angular acceleration of frame, y
    const Scalar z4543 = s_roll * z4538 + c_roll * z4540;
    const Scalar z4556 = z4413 + z4553;
    const Scalar z4549 = s_pitch * z4544 - c_pitch * z4539;
    const Scalar z4550 = s_pitch * z4539 + c_pitch * z4544;
    const Scalar z4557 = z4414 + z4551;
    const Scalar z4555 = z4412 + z4552;
    const Scalar z4558 = z4412 - z4552;
    const Scalar z4560 = c_steer * z4552 + z4110 * z4551 + z4112 * z4553;
    const Scalar z4563 = z4543 - n1_1 * z4556 - n0_3 * z4557;
    const Scalar z4535 = s_rear * z4405 + c_rear * z4406;
    const Scalar z4554 = a_rear + z4552;  // angular acceleration of rear_wheel, y
    const Scalar z4561 = z4111 * z4551 - z4112 * z4552 + z4113 * z4553;
    const Scalar z4562 = n1_1 * z4411 + z4549 - n0_3 * z4555;
    const Scalar z4564 = n0_3 * z4416 - z4550 - n1_1 * z4558;
    const Scalar z4534 = s_rear * z4406 - c_rear * z4405;
    const Scalar z4559 = z4109 * z4551 - z4110 * z4552 + z4111 * z4553;
    const Scalar z4568 = z31 * a_steer - z4559 + z4418 * z4423;  // angular acceleration of fork, x
    const Scalar z4565 = z4110 * z4563 - z4111 * z4564 + z4109 * z4562;
    const Scalar z4566 = c_steer * z4563 - z4110 * z4562 + z4112 * z4564;
    const Scalar z4567 = z4112 * z4563 - z4113 * z4564 + z4111 * z4562;
    const Scalar z4526 = z4516 - z4520;
    const Scalar z4527 = n2 * z4506;
    const Scalar z4528 = s_roll * z4526 - c_roll * z4527;
    const Scalar z4532 = s_yaw * z4504 - c_yaw * z4522;
    const Scalar z4533 = c_yaw * z4504 + s_yaw * z4522;
    const Scalar z4509 = s_roll * z4502 - c_roll * z4506;
    const Scalar z4569 = v_steer * z4420 - z4560;  // angular acceleration of fork, y
    const Scalar z4570 = z4561 + z32 * a_steer - z4418 * z4421;  // angular acceleration of fork, z
    const Scalar z4529 = s_roll * z4528;
    const Scalar z4530 = z4516 - z4529;
    const Scalar z4577 = z4433 * z4536;
    const Scalar z4580 = n0_28 * z4577;  // moment on front_wheel, z
    const Scalar z4576 = z4433 * z4537;
    const Scalar z4578 = n0_28 * z4576;  // moment on front_wheel, x
    const Scalar z4571 = z4428 + z4569;
    const Scalar z4531 = n39_8603 - z4530;
    const Scalar z4575 = a_front - z4569;  // angular acceleration of front_wheel, y
    const Scalar z4579 = n0_28 * z4575;  // moment on front_wheel, y
    const Scalar z4574 = z4428 - z4569;
    const Scalar z4572 = z4429 + z4570;
    const Scalar z4573 = z4430 + z4568;
    const Scalar z4521 = s_roll * z4470 + c_roll * z4503;
    const Scalar z4581 = s_front * z4580 - c_front * z4578;
    const Scalar z4582 = s_front * z4578 + c_front * z4580;
    const Scalar z4524 = s_yaw * z4521;
    const Scalar z4525 = c_yaw * z4521;
    const Scalar z4523 = s_roll * z4505 - c_roll * z4518;
    // moment on fork, y
    const Scalar z4587 = k31 * z4428 + k4 * z4438 + n2_5667 * z4569 - z4579 - n3_85 * z4565 - n1_04 * z4567;
    const Scalar z4630 = z4410 + z4415;
    const Scalar z4599 = n0_12 * z4554;  // moment on rear_wheel, y
    const Scalar z4633 = n2 * z4407;
    const Scalar z4586 = z4581 + k33 * z4430 + k3 * z4568 - n3_85 * z4566 - k4 * z4572;  // moment on fork, x
    const Scalar z4631 = z4414 - z4551;
    const Scalar z4588 = z4582 + k34 * z4429 + k5 * z4570 + n1_04 * z4566 - k4 * z4573;  // moment on fork, z
    const Scalar z4596 = z4408 * z4535;
    const Scalar z4598 = n0_12 * z4596;  // moment on rear_wheel, x
    const Scalar z4637 = n2 * z4535;
    const Scalar z4638 = z32 * z4418;
    const Scalar z4597 = z4408 * z4534;
    const Scalar z4600 = n0_12 * z4597;  // moment on rear_wheel, z
    const Scalar z4635 = n2 * z4534;
    const Scalar z4636 = n2 * z4408;
    const Scalar z4640 = z31 * z4418;
    const Scalar z4639 = z31 * z4424 + z32 * z4422;
    const Scalar z4602 = s_rear * z4598 - c_rear * z4600;
    const Scalar z4601 = s_rear * z4600 + c_rear * z4598;
    const Scalar z4583 = n1_04 * z4427 + n3_85 * z4571 - n7 * z4565;  // force on fork, x
    const Scalar z4642 = z31 * z4567 + z32 * z4565;
    const Scalar z4585 = n3_85 * z4432 + n1_04 * z4574 + n7 * z4567;  // force on fork, z
    const Scalar z4632 = n2 * z4405;
    const Scalar z4641 = z32 * z4566;
    const Scalar z4634 = n2 * z4406;
    const Scalar z4584 = n7 * z4566 + n1_04 * z4572 - n3_85 * z4573;  // force on fork, y
    const Scalar z4644 = z31 * z4427 + z32 * z4571;
    const Scalar z4646 = z32 * z4432 + z31 * z4574;
    const Scalar z4648 = n2 * z4418;
    const Scalar z4647 = n2 * z4422;
    const Scalar z4645 = z31 * z4572 - z32 * z4573;
    const Scalar z4643 = z31 * z4566;
    const Scalar z4589 = z4109 * z4583 - z4111 * z4585 + z4110 * z4584;
    const Scalar z4603 = n25_5 * z4411 - z4589 + n51 * z4555;  // force on frame, x
    const Scalar z4649 = n2 * z4424;
    const Scalar z4593 = c_steer * z4587;
    const Scalar z4621 = z4401 * z4401;
    const Scalar z4622 = z4402 * z4402;
    const Scalar z4623 = z4621 + z4622;
    const Scalar z4629 = z4413 - z4553;
    const Scalar z4590 = z4112 * z4585 - z4110 * z4583 + c_steer * z4584;
    const Scalar z4650 = z32 * z4648;
    const Scalar z4591 = z4111 * z4583 - z4113 * z4585 + z4112 * z4584;
    const Scalar z4605 = n51 * z4416 - z4591 + n25_5 * z4558;  // force on frame, z
    const Scalar z4651 = z31 * z4649 + z32 * z4647;
    const Scalar z4594 = z4110 * z4586 - z4593 - z4112 * z4588;
    // moment on frame, y
    const Scalar z4607 = z4599 + n29_35 * z4412 + n49_25 * z4552 + n17_7 * z4443 - n25_5 * z4550 + n51 * z4549 + n0_3
        * z4589 + n1_1 * z4591 + z4594;
    const Scalar z4612 = n39_8603 * (z4403 - z4545) + z4607;  // moment on frame.2, y
    const Scalar z4625 = z4403 - z4545;
    const Scalar z4595 = z4112 * z4587 + z4111 * z4586 - z4113 * z4588;
    // moment on frame, z
    const Scalar z4608 = z4602 + n49_25 * z4413 - n25_5 * z4543 - n29_35 * z4553 - n17_7 * z4557 - n1_1 * z4590 - z4595;
    const Scalar z4592 = z4110 * z4587 + z4109 * z4586 - z4111 * z4588;
    // moment on frame, x
    const Scalar z4606 = z4601 + n78_6 * z4414 + n51 * z4543 - n17_7 * z4556 - n0_3 * z4590 - z4592;
    const Scalar z4653 = n2 * z4536;
    const Scalar z4655 = n2 * z4537;
    const Scalar z4658 = n0_14 * z4653;
    const Scalar z4656 = n0_14 * z4655;
    const Scalar z4654 = n2 * z4433;
    const Scalar z4657 = n0_14 * z4654;
    const Scalar z4661 = k4 * z4648;
    const Scalar z4662 = n3_85 * z4648;
    const Scalar z4659 = s_front * z4658 - c_front * z4656;
    const Scalar z4660 = s_front * z4656 + c_front * z4658;
    const Scalar z4663 = n3_85 * z4647 + n1_04 * z4649;
    const Scalar z4652 = z31 * z4648;
    const Scalar z4624 = z4404 - z4546;
    const Scalar z4628 = n2 * z4402;
    const Scalar z4627 = n2 * z4401;
    const Scalar z4604 = n25_5 * z4556 - z4590 - n51 * z4557;  // force on frame, y
    const Scalar z4664 = n1_04 * z4648;
    const Scalar z4665 = n0_1435 * z4649 - z4659;
    const Scalar z4667 = z4659 + k4 * z4647 + k39 * z4649;
    const Scalar z4668 = z4660 + k40 * z4647 + k4 * z4649;
    const Scalar z4666 = k40 * z4648 + z4657;
    const Scalar z4610 = s_pitch * z4603 + c_pitch * z4605;
    const Scalar z4626 = n2 * v_roll;
    const Scalar z4611 = s_pitch * z4606 + c_pitch * z4608;
    const Scalar z4613 = n79_7206 * z4404 - z4611;  // moment on frame.2, z
    const Scalar z4609 = s_pitch * z4605 - c_pitch * z4603;
    const Scalar z4669 = k39 * z4648 + z4657;
    const Scalar z4670 = n0_1435 * z4647 - z4660;
    const Scalar z4673 = n1_1 * z4633;
    const Scalar z4671 = n0_3 * z4633;
    const Scalar z4672 = n0_3 * z4632 - n1_1 * z4634;
    const Scalar z4614 = s_roll * z4610 - c_roll * z4604;
    const Scalar z4674 = z4109 * z4662 + z4111 * z4664 + z4110 * z4663;
    const Scalar z4615 = s_roll * z4604 + c_roll * z4610;
    const Scalar z4620 = n87 * z4538 - z4615;  // force on frame.z, z
    const Scalar z4675 = c_steer * z4663 - z4110 * z4662 - z4112 * z4664;
    const Scalar z4616 = c_yaw * z4609 + s_yaw * z4614;
    const Scalar z4618 = n87 * a_x + z4616;  // force on frame.z, x
    const Scalar z4676 = z4111 * z4662 + z4113 * z4664 + z4112 * z4663;
    const Scalar z4617 = s_yaw * z4609 - c_yaw * z4614;
    const Scalar z4677 = n7 * z4671 - z4674;
    const Scalar z4678 = n7 * z4672 - z4675;
    const Scalar z4619 = n87 * a_y + z4617;  // force on frame.z, y
    const Scalar z4679 = n7 * z4673 - z4676;
    const Scalar z4708 = n0_06 * z4637;
    const Scalar z4710 = n0_06 * z4635;
    const Scalar z4709 = n0_06 * z4636;
    const Scalar z4682 = z4111 * z4661;
    const Scalar z4680 = z4109 * z4661 + z4111 * z4669 + z4110 * z4667;
    const Scalar z4687 = z4682 + z4113 * z4669 + z4112 * z4667;
    const Scalar z4683 = z4682 + z4109 * z4666 + z4110 * z4668;
    const Scalar z4681 = z4109 * z4665 - z4111 * z4670;
    const Scalar z4688 = z4111 * z4665 - z4113 * z4670;
    const Scalar z4685 = z4110 * z4665 - z4112 * z4670;
    const Scalar z4684 = c_steer * z4667 - z4110 * z4661 - z4112 * z4669;
    const Scalar z4689 = z4113 * z4661 + z4111 * z4666 + z4112 * z4668;
    const Scalar z4686 = c_steer * z4668 - z4110 * z4666 - z4112 * z4661;
    const Scalar z4692 = z4111 * z4680 - z4112 * z4681 - z4113 * z4683;
    const Scalar z4701 = z4471 * z4671 - z4692 + n0_3 * z4677;
    const Scalar z4696 = z4109 * z4687 - z4110 * z4688 - z4111 * z4689;
    const Scalar z4705 = z4469 * z4673 - z4696 - n1_1 * z4679;
    const Scalar z4690 = z4109 * z4680 - z4110 * z4681 - z4111 * z4683;
    const Scalar z4691 = c_steer * z4681 + z4110 * z4680 - z4112 * z4683;
    const Scalar z4699 = z4469 * z4671 - z4690 - n1_1 * z4677;
    const Scalar z4720 = n51 * z4633 - z4677;
    const Scalar z4714 = z4701 + z4709;
    const Scalar z4717 = z4705 - z4709;
    const Scalar z4700 = z4470 * z4671 - z4691;
    const Scalar z4725 = n39_3 * z4633 + z4714;
    const Scalar z4728 = n9_95 * z4633 - z4717;
    const Scalar z4698 = z4111 * z4687 - z4112 * z4688 - z4113 * z4689;
    const Scalar z4697 = c_steer * z4688 + z4110 * z4687 - z4112 * z4689;
    const Scalar z4707 = z4471 * z4673 - z4698 + n0_3 * z4679;
    const Scalar z4722 = n25_5 * z4633 + z4679;
    const Scalar z4719 = n17_7 * z4633;
    const Scalar z4723 = z4699 + z4719;
    const Scalar z4706 = z4470 * z4673 - z4697;
    const Scalar z4695 = z4112 * z4685 + z4111 * z4684 - z4113 * z4686;
    const Scalar z4704 = z4471 * z4672 - z4695 + n0_3 * z4678;
    const Scalar z4730 = z4707 - z4719;
    const Scalar z4693 = z4110 * z4685 + z4109 * z4684 - z4111 * z4686;
    const Scalar z4694 = c_steer * z4685 - z4110 * z4684 + z4112 * z4686;
    const Scalar z4702 = z4469 * z4672 - z4693 - n1_1 * z4678;
    const Scalar z4721 = n51 * z4632 - z4678 + n25_5 * z4634;
    const Scalar z4703 = z4470 * z4672 + z4694;
    const Scalar z4761 = n7 * z4539 - z4609;
    const Scalar z4760 = n7 * z4540 - z4614;
    const Scalar z4769 = z4521 * z4539;
    const Scalar z4712 = s_rear * z4708 - c_rear * z4710;
    const Scalar z4711 = s_rear * z4710 + c_rear * z4708;
    const Scalar z4716 = z4704 + z4712;
    const Scalar z4713 = z4700 - z4711;
    const Scalar z4715 = z4702 + z4711;
    const Scalar z4718 = z4706 - z4712;
    const Scalar z4729 = n39_3 * z4632 - z4718;
    const Scalar z4724 = n39_3 * z4634 - z4713;
    const Scalar z4727 = z4716 + n39_3 * z4632 + n17_7 * z4634;
    const Scalar z4726 = z4715 + n17_7 * z4632 + n9_95 * z4634;
    const Scalar z4731 = s_pitch * z4722 + c_pitch * z4720;
    const Scalar z4772 = z4470 * z4623 + n7 * z4543 + z4504 * z4624 + z4402 * z4731 + z4604;
    const Scalar z4771 = z4401 * z4731 - z4503 * z4623 - z4504 * z4625 + n7 * z4544 - z4610;
    const Scalar z4733 = z4723 - z4730;
    const Scalar z4734 = z4725 - z4728;
    const Scalar z4739 = s_pitch * z4733 + c_pitch * z4734;
    const Scalar z4732 = s_pitch * z4720 - c_pitch * z4722;
    const Scalar z4783 = z4504 * z4628 + z4721;
    const Scalar z4773 = z4504 * z4543;
    const Scalar z4782 = z4504 * z4627 - z4732;
    const Scalar z4735 = s_pitch * z4729 - c_pitch * z4724;
    const Scalar z4745 = n39_8603 * z4628 + z4735;
    const Scalar z4740 = s_pitch * z4739;
    const Scalar z4736 = s_pitch * z4724 + c_pitch * z4729;
    const Scalar z4748 = n39_8603 * z4626 - z4736;
    const Scalar z4741 = z4730 + z4740;
    const Scalar z4742 = z4723 - z4740;
    const Scalar z4737 = s_pitch * z4727 - c_pitch * z4726;
    const Scalar z4786 = s_roll * z4783 - c_roll * z4782;
    const Scalar z4787 = s_roll * z4782 + c_roll * z4783;
    const Scalar z4738 = s_pitch * z4726 + c_pitch * z4727;
    const Scalar z4794 = z4497 * z4550 + z4496 * z4549 + z4492 * z4631 + z4489 * z4629 - z4502 * z4630 + z4405 * z4727
        + z4406 * z4726;
    const Scalar z4800 = n7 * z4550 - z4470 * z4631 - z4497 * z4630 + z4405 * z4721 - z4605;
    const Scalar z4802 = z4470 * z4629 - z4496 * z4630 + n7 * z4549 + z4406 * z4721 - z4603;
    const Scalar z4799 = z4503 * z4540 + z4507 * z4539;
    const Scalar z4801 = z4405 * z4720 + z4406 * z4722 - z4496 * z4631 - z4497 * z4629;
    const Scalar z4749 = s_roll * z4732 - c_roll * z4721;
    const Scalar z4770 = z4470 * z4625 - z4503 * z4624 + z4402 * z4732 + z4401 * z4721;
    const Scalar z4750 = z4703 + z4741;
    const Scalar z4792 = z4723 + z4730;
    const Scalar z4791 = z4703 - z4730;
    const Scalar z4793 = z4703 - z4723;
    const Scalar z4743 = c_pitch * z4739 - z4725;
    const Scalar z4803 = z4489 * z4630 - z4608 - z4470 * z4549 - z4488 * z4629 - z4499 * z4631 + z4406 * z4791 + z4405
        * z4725;
    const Scalar z4744 = c_pitch * z4739 + z4728;
    const Scalar z4804 = z4606 + z4499 * z4629 - z4470 * z4550 - z4492 * z4630 - z4500 * z4631 + z4405 * z4793 - z4406
        * z4728;
    const Scalar z4795 = z4792 + z4489 * z4634 - z4492 * z4632;
    const Scalar z4747 = n39_8603 * z4627 + z4743;
    const Scalar z4785 = z4747 + z4506 * z4628 - z4516 * z4627;
    const Scalar z4805 = s_pitch * z4802 + c_pitch * z4800;
    const Scalar z4781 = z4470 * z4627 + z4503 * z4628;
    const Scalar z4767 = z4503 * z4544 - z4470 * z4543 + z4505 * z4624 - z4518 * z4625 - z4519 * z4623 + z4402 * z4745
        + z4401 * z4744;
    const Scalar z4752 = s_roll * z4745 - c_roll * z4744;
    const Scalar z4746 = n39_8603 * z4628 + z4737;
    const Scalar z4806 = s_pitch * z4800 - c_pitch * z4802;
    const Scalar z4784 = z4746 + z4506 * z4627 - z4520 * z4628;
    const Scalar z4797 = z4737 + z4502 * z4628 + z4506 * z4627;
    const Scalar z4751 = z4738 - z4748;
    const Scalar z4753 = s_roll * z4750 - c_roll * z4751;
    const Scalar z4776 = s_roll * z4772 - c_roll * z4771;
    const Scalar z4777 = c_roll * z4772 + s_roll * z4771;
    const Scalar z4788 = s_roll * z4784 - c_roll * z4785;
    const Scalar z4754 = s_roll * z4753;
    const Scalar z4814 = z4470 * z4632 - z4722;
    const Scalar z4755 = z4703 - z4754;
    const Scalar z4815 = z4496 * z4632 - z4497 * z4634;
    const Scalar z4809 = c_roll * z4801 + s_roll * z4806;
    const Scalar z4810 = s_roll * z4801 - c_roll * z4806;
    const Scalar z4758 = z4742 - z4755;
    const Scalar z4789 = s_yaw * z4786 - c_yaw * z4781;
    const Scalar z4790 = s_yaw * z4781 + c_yaw * z4786;
    const Scalar z4756 = s_yaw * z4749 - c_yaw * z4731;
    const Scalar z4816 = z4470 * z4634 + z4720;
    const Scalar z4757 = s_yaw * z4731 + c_yaw * z4749;
    const Scalar z4817 = z4724 + z4488 * z4634 - z4499 * z4632;
    const Scalar z4818 = z4499 * z4634 - z4729 + z4500 * z4632;
    const Scalar z4780 = s_yaw * z4770 - c_yaw * z4776;
    const Scalar z4779 = c_yaw * z4770 + s_yaw * z4776;
    const Scalar z4798 = s_roll * z4792 - c_roll * z4738;
    const Scalar z4796 = z4505 * z4623 - z4773 - z4502 * z4624 + z4506 * z4625 + z4402 * z4792 + z4401 * z4738;
    const Scalar z4813 = s_yaw * z4805 + c_yaw * z4809;
    const Scalar z4812 = s_yaw * z4809 - c_yaw * z4805;
    const Scalar z4766 = z4703 - z4742;
    const Scalar z4775 = z4504 * z4544 - z4612 + z4506 * z4624 - z4518 * z4623 + z4516 * z4625 + z4402 * z4748 + z4401
        * z4766;
    const Scalar z4765 = z4741 + z4742;
    const Scalar z4774 = z4505 * z4623 - z4773 + z4506 * z4625 + z4520 * z4624 - z4613 + z4401 * z4738 + z4402 * z4765;
    const Scalar z4764 = z4703 - z4741;
    const Scalar z4778 = c_roll * z4775 + s_roll * z4774;
    const Scalar z4768 = z4764 + z4505 * z4628 + z4518 * z4627;
    const Scalar z4759 = z4504 * z4539 + z4522 * z4540;
    const Scalar z4820 = s_pitch * z4814 - c_pitch * z4816;
    const Scalar z4819 = s_pitch * z4816 + c_pitch * z4814;
    const Scalar z4762 = s_yaw * z4761 - c_yaw * z4760;
    const Scalar z4763 = c_yaw * z4761 + s_yaw * z4760;
    const Scalar z4852 = z4460 * z4540 - z4464 * z4539;
    const Scalar z4854 = z4638 * z4664 - z4640 * z4662 + n3_85 * z4644 - n1_04 * z4646 + z31 * z4585 - z32 * z4583 - n7
        * z4642;
    const Scalar z4857 = z4640 * z4668 - n3_85 * z4641 - n1_04 * z4643 - n2_8467 * z4645 - z4638 * z4667 + z31 * z4588
        - z32 * z4586;
    const Scalar z4853 = z4640 * z4663 - z4639 * z4664 - n7 * z4641 - n3_85 * z4645 + z32 * z4584;
    const Scalar z4855 = z4639 * z4662 - z4638 * z4663 - n7 * z4643 - n1_04 * z4645 + z31 * z4584;
    const Scalar z4833 = z31 * z4661;
    const Scalar z4836 = z32 * z4661;
    const Scalar z4834 = z32 * z4669 - z4833;
    const Scalar z4837 = z31 * z4666 - z4836;
    const Scalar z4835 = z31 * z4665 + z32 * z4670;
    const Scalar z4858 = z4640 * z4661 - z4638 * z4669 - k4 * z4644 + k5 * z4646 - z4639 * z4670 + n1_04 * z4642 + z31
        * z4587;
    const Scalar z4856 = z4640 * z4666 - z4638 * z4661 - k3 * z4644 + k4 * z4646 + z4639 * z4665 + n3_85 * z4642 + z32
        * z4587;
    const Scalar z4838 = z4638 * z4834 + z4640 * z4837 - z450 * z4644 + z451 * z4646 + z449 * z4642 + z4639 * z4835;
    const Scalar z4841 = z4111 * z4834 + z4113 * z4837 + z4112 * z4835;
    const Scalar z4844 = z4841 + z4451 * z4672 - z4452 * z4671;
    const Scalar z4839 = z4109 * z4834 + z4111 * z4837 + z4110 * z4835;
    const Scalar z4840 = c_steer * z4835 - z4110 * z4834 - z4112 * z4837;
    const Scalar z4842 = z4839 + z4452 * z4673 - z4453 * z4672;
    const Scalar z4843 = z4451 * z4673 - z4840 - z4453 * z4671;
    const Scalar z4859 = z4109 * z4853 + z4110 * z4854 + z4111 * z4855;
    const Scalar z4845 = z4457 * z4629 - z4451 * z4550 - z4458 * z4630 - z4459 * z4631 + z4453 * z4549 + z4405 * z4844
        + z4406 * z4842;
    const Scalar z4846 = z4843 + z4457 * z4634 + z4459 * z4632;
    const Scalar z4861 = z4111 * z4853 + z4112 * z4854 + z4113 * z4855;
    const Scalar z4860 = c_steer * z4854 - z4110 * z4853 - z4112 * z4855;
    const Scalar z4847 = s_pitch * z4844 - c_pitch * z4842;
    const Scalar z4848 = s_pitch * z4842 + c_pitch * z4844;
    const Scalar z4849 = z4461 * z4543 + z4452 * z4544 - z4458 * z4624 - z4462 * z4623 + z4463 * z4625 + z4401 * z4848
        + z4402 * z4843;
    const Scalar z4850 = z4847 + z4458 * z4628 + z4463 * z4627;
    const Scalar z4851 = s_roll * z4843 - c_roll * z4848;
    const Scalar z4823 = c_roll * z4815 + s_roll * z4820;
    const Scalar z4824 = s_roll * z4815 - c_roll * z4820;
    const Scalar z4827 = s_yaw * z4819 + c_yaw * z4823;
    const Scalar z4826 = s_yaw * z4823 - c_yaw * z4819;
    const Scalar z4862 = z4111 * z4858 + z4109 * z4856 + z4110 * z4857;
    const Scalar z4865 = n0_3 * z4860 + z4862;
    const Scalar z4863 = c_steer * z4857 - z4110 * z4856 - z4112 * z4858;
    const Scalar z4864 = z4113 * z4858 + z4111 * z4856 + z4112 * z4857;
    const Scalar z4866 = n0_3 * z4859 - z4863 + n1_1 * z4861;
    const Scalar z4829 = s_pitch * z4711 + c_pitch * z4712;
    const Scalar z4828 = s_pitch * z4712 - c_pitch * z4711;
    const Scalar z4822 = s_pitch * z4817 - c_pitch * z4818;
    const Scalar z4821 = s_pitch * z4818 + c_pitch * z4817;
    const Scalar z4825 = s_roll * z4795 - c_roll * z4822;
    const Scalar z4830 = z4401 * z4829 - n0_12 * z4624;
    const Scalar z4832 = c_roll * z4829;
    const Scalar z4808 = s_pitch * z4803 + c_pitch * z4804;
    const Scalar z4807 = s_pitch * z4804 - c_pitch * z4803;
    const Scalar z4867 = n1_1 * z4860 + z4864;
    const Scalar z4811 = s_roll * z4794 + c_roll * z4808;
    const Scalar z4878 = z31 * z4664 + z32 * z4662 - n3_85 * z4650 - n1_04 * z4652;
    const Scalar z4880 = z4833 - k3 * z4650 - k4 * z4652 + z32 * z4666;
    const Scalar z4882 = z4836 - k4 * z4650 - k5 * z4652 + z31 * z4669;
    const Scalar z4881 = z31 * z4667 + z32 * z4668 - n2_8467 * z4651;
    const Scalar z4877 = z32 * z4663 - n3_85 * z4651;
    const Scalar z4879 = z31 * z4663 - n1_04 * z4651;
    const Scalar z4883 = z4109 * z4877 - z4110 * z4878 + z4111 * z4879;
    const Scalar z4885 = z4111 * z4877 - z4112 * z4878 + z4113 * z4879;
    const Scalar z4884 = z4110 * z4877 + z4112 * z4879 + c_steer * z4878;
    const Scalar z4869 = s_pitch * z4859 + c_pitch * z4861;
    const Scalar z4868 = s_pitch * z4861 - c_pitch * z4859;
    const Scalar z4886 = z4109 * z4880 + z4111 * z4882 + z4110 * z4881;
    const Scalar z4889 = n0_3 * z4884 - z4886;
    const Scalar z4872 = s_roll * z4869 - c_roll * z4860;
    const Scalar z4873 = s_roll * z4860 + c_roll * z4869;
    const Scalar z4888 = z4111 * z4880 + z4113 * z4882 + z4112 * z4881;
    const Scalar z4887 = c_steer * z4881 - z4110 * z4880 - z4112 * z4882;
    const Scalar z4890 = n0_3 * z4883 - z4887 + n1_1 * z4885;
    const Scalar z4876 = s_yaw * z4868 - c_yaw * z4872;
    const Scalar z4875 = c_yaw * z4868 + s_yaw * z4872;
    const Scalar z4871 = s_pitch * z4865 + c_pitch * z4867;
    const Scalar z4870 = s_pitch * z4867 - c_pitch * z4865;
    const Scalar z4874 = s_roll * z4866 - c_roll * z4871;
    const Scalar z4831 = n0_12 * z4628 + z4828;
    const Scalar z4901 = z4638 * z4659 - z4640 * z4660 + n0_28 * z4645;
    const Scalar z4891 = n1_1 * z4884 - z4888;
    const Scalar z4948 = c_yaw * z4168;
    const Scalar z4945 = s_yaw * z4168;
    const Scalar z4946 = n0_35 * z4226 / (z4187 * z4187);
    const Scalar z4949 = z4948 - z4188 * z4223 + z4184 * z4946;
    const Scalar z4942 = z4144 / (z4120 * z4120);
    const Scalar z4947 = z4945 - z4188 * z4221 + z4183 * z4946;
    const Scalar z4917 = z4170 - z4184 * z4188;
    const Scalar z4932 = z4331 - z4917;
    const Scalar z4939 = z4170 - z4917;
    const Scalar z4943 = z4116 * z4942 - z4121 * z4138;
    const Scalar z4918 = z4169 - z4183 * z4188;
    const Scalar z4930 = z4330 - z4918;
    const Scalar z4933 = z4323 * z4932 - z4338;
    const Scalar z4937 = z4169 - z4918;
    const Scalar z4940 = z4178 * z4939 - z4345;
    const Scalar z4931 = z4323 * z4930 - z4340;
    const Scalar z4938 = z4178 * z4937 - z4347;
    const Scalar z4926 = s_roll * z4917 + z4115 * z4315;
    const Scalar z4915 = z4117 * z4121;
    const Scalar z4925 = s_roll * z4918 + z4114 * z4315;
    const Scalar z4944 = z4117 * z4942 - z4121 * z4140;
    const Scalar z4916 = z4116 * z4121;
    const Scalar z4924 = s_roll * z4915 - z4115 * z4291;
    const Scalar z4923 = s_roll * z4916 - z4114 * z4291;
    const Scalar z4904 = z4109 * z4659 - z4111 * z4660;
    const Scalar z4893 = s_pitch * z4883 + c_pitch * z4885;
    const Scalar z4892 = s_pitch * z4885 - c_pitch * z4883;
    const Scalar z4952 = n2 * (c_roll * z4137 + z4116);
    const Scalar z4953 = n2 * (c_roll * z4139 + z4117);
    const Scalar z4905 = z4110 * z4659 - z4112 * z4660;
    const Scalar z4908 = z4905 + z4445 * z4634 + z4447 * z4632;
    const Scalar z4906 = z4111 * z4659 - z4113 * z4660;
    const Scalar z4907 = z4446 * z4630 + z4445 * z4629 - z4447 * z4631 + z4405 * z4906 + z4406 * z4904;
    const Scalar z4902 = z31 * z4659;
    const Scalar z4903 = z4902 + z32 * z4660 - n0_28 * z4651;
    const Scalar z4914 = z32 * z4660 + z4902;
    const Scalar z4927 = l_lambda_rear_rolls_x * z4923;
    const Scalar z4896 = c_roll * z4884 + s_roll * z4893;
    const Scalar z4897 = s_roll * z4884 - c_roll * z4893;
    const Scalar z4910 = s_pitch * z4904 + c_pitch * z4906;
    const Scalar z4911 = z4446 * z4624 - z4448 * z4623 + z4449 * z4625 + z4402 * z4905 + z4401 * z4910;
    const Scalar z4909 = s_pitch * z4906 - c_pitch * z4904;
    const Scalar z4912 = z4446 * z4628 - z4909 - z4449 * z4627;
    const Scalar z4913 = s_roll * z4905 - c_roll * z4910;
    const Scalar z4900 = s_yaw * z4892 - c_yaw * z4896;
    const Scalar z4899 = c_yaw * z4892 + s_yaw * z4896;
    const Scalar z4895 = s_pitch * z4889 + c_pitch * z4891;
    const Scalar z4894 = s_pitch * z4891 - c_pitch * z4889;
    const Scalar z4898 = c_roll * z4895 + s_roll * z4890;
    const Scalar z4963 = n2 * (z4177 * z4177 - z4178 * z4178);
    const Scalar z4976 = s_yaw * z4229;
    const Scalar z4977 = z4178 * z4976 + z4220 * z4229 + z4177 * z4231 + z4180 * z4230;
    const Scalar z4978 = c_yaw * z4229;
    const Scalar z4975 = s_roll * z4164;
    const Scalar z4958 = s_yaw * z4177;
    const Scalar z4959 = n2 * z4177;
    const Scalar z4960 = z4220 * z4959 + z4178 * (z4180 + z4958);
    const Scalar z4961 = c_yaw * z4177;
    const Scalar z4962 = z4222 * z4959 + z4178 * (z4182 + z4961);
    const Scalar z4970 = z4166 - z4188 * z4224 - z4185 * z4946;
    const Scalar z4971 = s_yaw * z4970;
    const Scalar z4954 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z4955 = n2 * (z4116 * z4952 + z4117 * z4953 - z4118 * z4954 - z4138 * z4138 - z4140 * z4140 - z4141
        * z4141);
    const Scalar z4964 = n2 * (z4185 * z4963 - z4224 * z4224 - z4221 * z4221 - z4223 * z4223 + z4183 * z4960 + z4184
        * z4962);
    const Scalar z4965 = n0_5 * (z4225 * z4226 / (z4187 * z4187) + z4964 / z4187);
    const Scalar z4972 = c_yaw * z4970;
    const Scalar z4967 = z4118 * z4942 - z4121 * z4141;
    const Scalar z4969 = c_yaw * z4967;
    const Scalar z4968 = s_yaw * z4967;
    const Scalar z4921 = l_lambda_rear_rolls_x * z4293 - l_lambda_rear_rolls_y * z4292 + l_lambda_front_rolls_x * z4317
        - l_lambda_front_rolls_y * z4316;
    const Scalar z4922 = z4769 - z4921;
    const Scalar z4956 = n0_5 * (z4142 * z4143 / (z4120 * z4120) + z4955 / z4120);
    const Scalar z4928 = l_lambda_front_rolls_x * z4925 - z4927 - l_lambda_rear_rolls_y * z4924 + l_lambda_front_rolls_y
        * z4926;
    const Scalar z4929 = z4799 - z4928;
    const Scalar z4936 = l_lambda_rear_rolls_y * z4924 + z4927;
    const Scalar z4934 = l_lambda_front_rolls_x * z4931 + l_lambda_front_rolls_y * z4933;
    const Scalar z4935 = z4852 + z4934;
    const Scalar z4966 = z4168 - n0_35 * z4965;
    const Scalar z4950 = l_lambda_rear_rolls_x * z4944 - l_lambda_rear_rolls_y * z4943 - l_lambda_front_rolls_x * z4949
        + l_lambda_front_rolls_y * z4947;
    const Scalar z4951 = z4778 + z4950;
    const Scalar z4941 = l_lambda_front_rolls_x * z4938 + l_lambda_front_rolls_y * z4940;
    const Scalar z4957 = n0_3 * z4956;
    const Scalar z4919 = l_lambda_rear_rolls_x * z4916 + l_lambda_rear_rolls_y * z4915 - l_lambda_front_rolls_x * z4918
        - l_lambda_front_rolls_y * z4917;
    const Scalar z4920 = z4759 + z4919;
    const Scalar z4979 = z4178 * z4978 + z4177 * z4233 + z4222 * z4229 + z4182 * z4230;
    const Scalar z5003 = z4328 - z4970;
    const Scalar z5013 = z4948 - z4949;
    const Scalar z5014 = z4166 - z4970;
    const Scalar z5016 = z4945 - z4947;
    const Scalar z4980 = n2 * (z4177 * z4229 - z4178 * z4230);
    const Scalar z4981 = n2 * (z4185 * z4980 - z4224 * z4235 + z4221 * z4232 + z4223 * z4234 + z4183 * z4977 + z4184
        * z4979);
    const Scalar z4994 = c_yaw * z4250;
    const Scalar z4995 = z4178 * z4994 + z4222 * z4250 + z4177 * z4255 - z4182 * z4251;
    const Scalar z4996 = n2 * (z4178 * z4251 + z4177 * z4250);
    const Scalar z4991 = s_roll * z4247 - c_roll * z4241;
    const Scalar z4992 = s_yaw * z4250;
    const Scalar z4993 = z4177 * z4253 - z4178 * z4992 + z4180 * z4251 - z4220 * z4250;
    const Scalar z5021 = n0_35 * z4237 / (z4187 * z4187);
    const Scalar z5023 = s_yaw * z4165 - c_yaw * z4975;
    const Scalar z5020 = s_yaw * z4975 + c_yaw * z4165;
    const Scalar z5002 = c_yaw * z4323;
    const Scalar z5000 = c_yaw * z4329;
    const Scalar z5001 = z4949 - z5000;
    const Scalar z5007 = s_yaw * z4323;
    const Scalar z5024 = z4184 * z5021 - z5023 - z4188 * z4234;
    const Scalar z4997 = n2 * (z4224 * z4257 - z4185 * z4996 + z4221 * z4254 - z4223 * z4256 - z4184 * z4995 + z4183
        * z4993);
    const Scalar z5029 = z4228 - z4188 * z4235 + z4185 * z5021;
    const Scalar z5005 = s_yaw * z4329;
    const Scalar z5006 = z4947 - z5005;
    const Scalar z5022 = z5020 - z4188 * z4232 + z4183 * z5021;
    const Scalar z5030 = s_yaw * z5029;
    const Scalar z5031 = c_yaw * z5029;
    const Scalar z5004 = z4322 * z4336 - z4337 * z5002 - z4323 * z5001 + z4325 * z5003;
    const Scalar z4987 = c_roll * z4313 - z4137 * z4315 + s_roll * z4947 - z4114 * z4970;
    const Scalar z5015 = z4177 * z4343 + z4222 * z4344 + z4178 * z5013 - z4182 * z5014;
    const Scalar z4985 = z4137 * z4291 - c_roll * z4289 + s_roll * z4943 + z4114 * z4967;
    const Scalar z5008 = z4322 * z4335 + z4337 * z5007 + z4323 * z5006 - z4324 * z5003;
    const Scalar z4986 = s_roll * z4949 - c_roll * z4314 - z4115 * z4970 - z4139 * z4315;
    const Scalar z5017 = z4177 * z4342 - z4220 * z4344 - z4178 * z5016 + z4180 * z5014;
    const Scalar z4984 = c_roll * z4290 + z4139 * z4291 + s_roll * z4944 + z4115 * z4967;
    const Scalar z5027 = n0_5 * (z4225 * z4237 / (z4187 * z4187) - z4981 / z4187);
    const Scalar z4982 = n0_5 * (z4226 * z4236 / (z4187 * z4187) - z4981 / z4187);
    const Scalar z5028 = z4975 - n0_35 * z5027;
    const Scalar z4983 = z4975 - n0_35 * z4982;
    const Scalar z4998 = n0_5 * (z4226 * z4258 / (z4187 * z4187) - z4997 / z4187);
    const Scalar z4999 = z4991 + n0_35 * z4998;
    const Scalar z4988 = l_lambda_rear_rolls_x * z4984;
    const Scalar z5018 = l_lambda_front_rolls_x * z5015 + l_lambda_front_rolls_y * z5017;
    const Scalar z5019 = z4911 - z5018;
    const Scalar z5011 = l_lambda_rear_rolls_y * z4985 - z4988;
    const Scalar z4989 = l_lambda_rear_rolls_y * z4985 - z4988 + l_lambda_front_touches * z4983 - l_lambda_front_rolls_y
        * z4987 + l_lambda_front_rolls_x * z4986;
    const Scalar z5012 = z4830 - z5011;
    const Scalar z5009 = l_lambda_front_touches * z4999 + l_lambda_front_rolls_x * z5004 + l_lambda_front_rolls_y
        * z5008;
    const Scalar z5025 = l_lambda_front_rolls_x * z5024 - l_lambda_front_rolls_y * z5022;
    const Scalar z5026 = z4811 + z5025;
    const Scalar z4973 = l_lambda_rear_touches * z4957 + l_lambda_rear_rolls_x * z4968 + l_lambda_rear_rolls_y * z4969
        + l_lambda_front_rolls_x * z4971 + l_lambda_front_rolls_y * z4972 - l_lambda_front_touches * z4966;
    const Scalar z5010 = z4849 + z5009;
    const Scalar z4990 = z4796 - z4989;
    const Scalar z4974 = z4767 - z4973;
    const Scalar z5035 = s_yaw * z4176 + z4179;
    const Scalar z5039 = c_yaw * z4176 - z4181;
    const Scalar z5077 = z4228 - z5029;
    const Scalar z5079 = z5020 - z5022;
    const Scalar z5076 = z5023 + z5024;
    const Scalar z5090 = n0_5 * (z4225 * z4259 / (z4187 * z4187) - z4997 / z4187);
    const Scalar z5091 = z4991 + n0_35 * z5090;
    const Scalar z5036 = c_roll * z4175;
    const Scalar z5053 = c_roll * z4252;
    const Scalar z5051 = s_roll * z4252;
    const Scalar z5041 = n2 * (z4178 * z5036 - z4229 * z4229);
    const Scalar z5049 = s_pitch * z4246 - c_pitch * z4244;
    const Scalar z5055 = s_yaw * z4249 + c_yaw * z5051;
    const Scalar z5052 = s_yaw * z5051 - c_yaw * z4249;
    const Scalar z5056 = z4178 * z5055 - z4233 * z4250 - z4229 * z4255 - z4182 * z5053;
    const Scalar z5054 = z4229 * z4253 + z4178 * z5052 - z4231 * z4250 - z4180 * z5053;
    const Scalar z5057 = n2 * (z4178 * z5053 - z4229 * z4250);
    const Scalar z5037 = n2 * z4229;
    const Scalar z5038 = z4178 * z5035 - z4231 * z5037 - z4180 * z5036;
    const Scalar z5040 = z4178 * z5039 - z4233 * z5037 - z4182 * z5036;
    const Scalar z5058 = n2 * (z4235 * z4257 + z4185 * z5057 + z4234 * z4256 - z4232 * z4254 + z4184 * z5056 + z4183
        * z5054);
    const Scalar z5042 = n2 * (z4235 * z4235 + z4185 * z5041 + z4234 * z4234 + z4232 * z4232 + z4183 * z5038 + z4184
        * z5040);
    const Scalar z5086 = s_yaw * z5049 - c_yaw * z4991;
    const Scalar z5065 = s_roll * z4320;
    const Scalar z5043 = n0_5 * (z4236 * z4237 / (z4187 * z4187) - z5042 / z4187);
    const Scalar z5083 = c_yaw * z5049 + s_yaw * z4991;
    const Scalar z5084 = n0_35 * z4259 / (z4187 * z4187);
    const Scalar z5061 = c_roll * z4320;
    const Scalar z5062 = s_roll * z4326;
    const Scalar z5072 = c_yaw * z4321 + s_yaw * z5065;
    const Scalar z5066 = s_yaw * z4321 - c_yaw * z5065;
    const Scalar z5067 = c_roll * z4326;
    const Scalar z5068 = z5029 - z5067;
    const Scalar z5087 = z5086 + z4188 * z4256 + z4184 * z5084;
    const Scalar z5070 = c_yaw * z4327 + s_yaw * z5062;
    const Scalar z5071 = z5022 - z5070;
    const Scalar z5085 = z4183 * z5084 - z5083 - z4188 * z4254;
    const Scalar z5063 = s_yaw * z4327 - c_yaw * z5062;
    const Scalar z5064 = z5024 + z5063;
    const Scalar z5045 = z4115 * z5029 + s_roll * z5024;
    const Scalar z5046 = s_roll * z5022 + z4114 * z5029;
    const Scalar z5069 = z4336 * z5061 - z4337 * z5066 - z4325 * z5068 + z4323 * z5064;
    const Scalar z5073 = z4337 * z5072 - z4335 * z5061 + z4323 * z5071 - z4324 * z5068;
    const Scalar z5078 = z4229 * z4343 + z4233 * z4344 - z4182 * z5077 + z4178 * z5076;
    const Scalar z5080 = z4229 * z4342 - z4231 * z4344 + z4178 * z5079 + z4180 * z5077;
    const Scalar z5034 = c_roll * z4165;
    const Scalar z5044 = z5034 - n0_35 * z5043;
    const Scalar z5050 = c_roll * z5049;
    const Scalar z5059 = n0_5 * (z4237 * z4258 / (z4187 * z4187) + z5058 / z4187);
    const Scalar z5060 = z5050 + n0_35 * z5059;
    const Scalar z5081 = l_lambda_front_rolls_x * z5078 + l_lambda_front_rolls_y * z5080;
    const Scalar z5082 = z4907 - z5081;
    const Scalar z5047 = l_lambda_front_touches * z5044 - l_lambda_front_rolls_y * z5046 + l_lambda_front_rolls_x
        * z5045;
    const Scalar z5074 = l_lambda_front_rolls_x * z5069 - l_lambda_front_rolls_y * z5073 - l_lambda_front_touches
        * z5060;
    const Scalar z5075 = z4845 + z5074;
    const Scalar z5088 = l_lambda_front_rolls_x * z5087 - l_lambda_front_rolls_y * z5085;
    const Scalar z5089 = z4874 - z5088;
    const Scalar z5048 = z4794 + z5047;
    const Scalar z5032 = l_lambda_front_rolls_x * z5030 + l_lambda_front_rolls_y * z5031 + l_lambda_front_touches
        * z5028;
    const Scalar z5033 = z4807 + z5032;
    const Scalar z5127 = k33 * z4430 + z4436 + k3 * z4568 - n3_85 * z4566 - k4 * z4572;  // moment on fork, x
    const Scalar z5128 = k34 * z4429 + z4437 + k5 * z4570 + n1_04 * z4566 - k4 * z4573;  // moment on fork, z
    const Scalar z5137 = z4404 + z4546;
    const Scalar z5120 = z5086 - z5087;
    const Scalar z5123 = z5083 + z5085;
    const Scalar z5097 = n0_5 * (z4236 * z4259 / (z4187 * z4187) + z5058 / z4187);
    const Scalar z5098 = z5050 + n0_35 * z5097;
    const Scalar z5131 = z4112 * z4587 + z4111 * z5127 - z4113 * z5128;
    const Scalar z5129 = z4110 * z4587 + z4109 * z5127 - z4111 * z5128;
    // moment on frame, z
    const Scalar z5134 = z4442 - n25_5 * z4543 + n9_95 * z4556 - n17_7 * z4557 - n1_1 * z4590 - z5131;
    // moment on frame, x
    const Scalar z5132 = z4441 + n51 * z4543 - n17_7 * z4556 + n39_3 * z4557 - n0_3 * z4590 - z5129;
    const Scalar z5142 = a_z - a_roll * z4144 - z4158;
    const Scalar z5143 = a_z + a_roll * z4227 - a_pitch * z4238 - a_steer * z4260 + z4288;
    const Scalar z5145 = a_y - z4295 * (a_pitch + a_rear) - a_yaw * z4289 + a_roll * z4293 - z4312;
    const Scalar z5130 = z4110 * z5127 - z4593 - z4112 * z5128;
    // moment on frame, y
    const Scalar z5133 = z4599 + n29_35 * z4412 + n49_25 * z4552 + n17_7 * z4443 - n25_5 * z4550 + n51 * z4549 + n0_3
        * z4589 + n1_1 * z4591 + z5130;
    const Scalar z5141 = z31 * z5127 + z32 * z5128;
    const Scalar z5144 = a_x + a_yaw * z4314 - a_roll * z4316 + a_pitch * z4318 + a_steer * z4339 + a_front * z4346
        + z4383;
    const Scalar z5146 = a_y - a_yaw * z4313 + a_roll * z4317 - a_pitch * z4319 - a_steer * z4341 - a_front * z4348
        - z4400;
    const Scalar z5147 = z4294 * (a_pitch + a_rear) + a_x + a_yaw * z4290 - a_roll * z4292 + z4305;
    const Scalar z5111 = n2 * (z4250 * z4255 + z4178 * z4182);
    const Scalar z5112 = n2 * (z4178 * z4178 - z4250 * z4250);
    const Scalar z5092 = z4188 * z4257 - z4248 + z4185 * z5084;
    const Scalar z5121 = z4248 + z5092;
    const Scalar z5093 = s_yaw * z5092;
    const Scalar z5094 = c_yaw * z5092;
    const Scalar z5099 = s_roll * z5087 + z4115 * z5092;
    const Scalar z5100 = z4114 * z5092 + s_roll * z5085;
    const Scalar z5110 = n2 * (z4178 * z4180 - z4250 * z4253);
    const Scalar z5113 = n2 * (z4184 * z5111 - z4257 * z4257 - z4185 * z5112 - z4254 * z4254 - z4256 * z4256 + z4183
        * z5110);
    const Scalar z5148 = v_yaw * z4918;
    const Scalar z5116 = z4323 * z5087 - z4325 * z5092;
    const Scalar z5117 = z4323 * z5085 - z4324 * z5092;
    const Scalar z5122 = z4250 * z4343 + z4255 * z4344 + z4178 * z5120 - z4182 * z5121;
    const Scalar z5104 = c_steer * z890;
    const Scalar z5124 = z4250 * z4342 + z4253 * z4344 + z4180 * z5121 + z4178 * z5123;
    const Scalar z5114 = n0_5 * (z4258 * z4259 / (z4187 * z4187) + z5113 / z4187);
    const Scalar z5103 = c_steer * (n1 - z889);
    const Scalar z5105 = n0_08 * z5103 - n0_35 * z5104;
    const Scalar z5106 = c_steer * (n1 - z891);
    const Scalar z5107 = n0_08 * z5104 - n0_35 * z5106;
    const Scalar z5149 = v_roll * z4317 - z5148 - v_pitch * z4925 - v_steer * z4931 + v_front * z4938;
    const Scalar z5108 = c_pitch * z5107 + s_pitch * z5105;
    const Scalar z5150 = v_roll * z4317 - z5148 - v_pitch * z4925 - v_steer * z4931 + v_front * z4938 - z4357;
    const Scalar z5109 = c_roll * z5108 - z4167;
    const Scalar z5151 = z4384 - z4188 * z4213 + z4183 * z4355;
    const Scalar z5152 = z4389 - z4125 * z4918 + s_roll * z5151 - z4114 * z4359;
    const Scalar z5115 = z5109 + n0_35 * z5114;
    const Scalar z5153 = z4391 + z5151;
    const Scalar z5154 = z4364 * z4930 - z4395 + z4323 * z5153 - z4324 * z4376;
    const Scalar z5118 = l_lambda_front_rolls_x * z5116 - l_lambda_front_touches * z5115 - l_lambda_front_rolls_y
        * z5117;
    const Scalar z5125 = l_lambda_front_rolls_x * z5122 + l_lambda_front_rolls_y * z5124;
    const Scalar z5126 = z4901 + z5125;
    const Scalar z5135 = s_pitch * z5134 - c_pitch * z5132;
    const Scalar z5119 = z4838 + z5118;
    const Scalar z5138 = n0_5603 * (a_roll + z4444) + z5135;  // moment on frame.2, x
    const Scalar z5136 = s_pitch * z5132 + c_pitch * z5134;
    const Scalar z5139 = z5136 - n0_5603 * z5137;  // moment on frame.2, z
    const Scalar z5101 = l_lambda_front_rolls_x * z5099 - l_lambda_front_rolls_y * z5100 - l_lambda_front_touches
        * z5098;
    const Scalar z5102 = z4866 - z5101;
    const Scalar z5140 = s_roll * z5133 + c_roll * z5139;
    const Scalar z5095 = l_lambda_front_rolls_x * z5093 + l_lambda_front_rolls_y * z5094 - l_lambda_front_touches
        * z5091;
    const Scalar z5096 = z4870 + z5095;
    const Scalar z5155 = z4384 - z5151;
    const Scalar z5156 = z4208 * z4937 - z4398 + z4178 * z5155 + z4180 * z4380;
    const Scalar z5162 = z4117 * z4296 - z4297;
    const Scalar z5180 = z4116 * z4296 - z4306;
    const Scalar z5163 = z4125 * z4915 + z4131 * z4291 + s_roll * z5162 - z4303;
    const Scalar z5157 = v_yaw * z5151 + v_pitch * z5152 + v_roll * z4388 - v_steer * z5154 - v_front * z5156;
    const Scalar z5158 = a_yaw * z4918 - a_roll * z4317 + a_pitch * z4925 + a_steer * z4931 - a_front * z4938 - z5157;
    const Scalar z5164 = v_yaw * z5162 - v_roll * z4302 + z5163 * (v_pitch + v_rear);
    const Scalar z5181 = z4125 * z4916 + z4128 * z4291 + s_roll * z5180 - z4310;
    const Scalar z5182 = v_yaw * z5180 + z5181 * (v_pitch + v_rear) + v_roll * z4309;
    const Scalar z5165 = z4924 * (a_pitch + a_rear) + a_yaw * z4915 - a_roll * z4292 + z5164;
    const Scalar z5159 = v_yaw * z4915;
    const Scalar z5187 = c_yaw * z4125 - s_roll * z4130;
    const Scalar z5183 = z4923 * (a_pitch + a_rear) + a_yaw * z4916 + a_roll * z4293 + z5182;
    const Scalar z5177 = v_yaw * z4916;
    const Scalar z5188 = c_roll * z4131;
    const Scalar z5215 = z4208 * z4220;
    const Scalar z5189 = z4115 * z4127 + z4125 * z4139 + s_roll * z5187 + z5188;
    const Scalar z5192 = z4129 * z4138;
    const Scalar z5190 = c_roll * z4125;
    const Scalar z5214 = s_yaw * z4208 - z4126 * z4178;
    const Scalar z5218 = z4208 * z4222;
    const Scalar z5185 = z4125 * z4137;
    const Scalar z5217 = z4130 * z4178 + c_yaw * z4208;
    const Scalar z5184 = s_yaw * z4125 + s_roll * z4126;
    const Scalar z5191 = n2 * (s_roll * z4127 - z5190);
    const Scalar z5201 = z4133 * z4147 - n4 * z5190;
    const Scalar z5216 = z4180 * z4210 - z5215 - z4178 * z5214 + z4177 * z4212;
    const Scalar z5219 = z5218 - z4182 * z4210 + z4178 * z5217 + z4177 * z4214;
    const Scalar z5186 = z4114 * z4127 + z5185 + s_roll * z5184 + c_roll * z4128;
    const Scalar z5193 = n2 * (z4117 * z5189 - z5192 - z4134 * z4141 - z4118 * z5191 - z4132 * z4140 + z4116 * z5186);
    const Scalar z5194 = z4135 * z4143;
    const Scalar z5209 = n4 * z4125 * z4127 + n2 * (s_roll * z4145 + c_roll * z4149);
    const Scalar z5205 = s_yaw * z4149 + s_roll * z4146 - z4126 * z4150;
    const Scalar z5206 = z4137 * z4149 - z4114 * z4145 - n2 * (z4125 * z5184 - z4127 * z4128) + s_roll * z5205 - c_roll
        * z4148;
    const Scalar z5195 = n0_5 * (z5194 / (z4120 * z4120) + z5193 / z4120);
    const Scalar z5197 = z4126 * z4133 + s_yaw * z4150;
    const Scalar z5198 = z4114 * z4147 + s_roll * z5197 + n2 * (c_roll * z4128 + z5185);
    const Scalar z5199 = c_yaw * z4150 - z4130 * z4133;
    const Scalar z5200 = z4115 * z4147 + s_roll * z5199 + n2 * (z4125 * z4139 + z5188);
    const Scalar z5207 = c_yaw * z4149 + s_roll * z4152 + z4130 * z4150;
    const Scalar z5208 = z4139 * z4149 - z4115 * z4145 - n2 * (z4125 * z5187 - z4127 * z4131) + s_roll * z5207 - c_roll
        * z4153;
    const Scalar z5202 = n2 * (z4116 * z5198 + z4117 * z5200 - z4118 * z5201) - n4 * (z5192 + z4134 * z4141 + z4132
        * z4140);
    const Scalar z5210 = n4 * (z4132 * z5189 - z4134 * z5191 + z4129 * z5186) + n2 * (z4118 * z5209 - z4141 * z4155
        + z4138 * z4151 + z4140 * z4154 + z4116 * z5206 + z4117 * z5208);
    const Scalar z5211 = n0_5 * (z4136 * z5193 / (z4120 * z4120) + z4143 * z4156 / (z4120 * z4120) - z5210 / z4120
        + z4135 * z5195 / (z4120 * z4120)) + z4136 * z5194 / (z4120 * z4120 * z4120);
    const Scalar z5203 = n0_5 * (z4136 * z4142 / (z4120 * z4120) + z5194 / (z4120 * z4120) + z5202 / z4120);
    const Scalar z5196 = n0_3 * z5195;
    const Scalar z5204 = n0_3 * z5203;
    const Scalar z5166 = v_yaw * z4917;
    const Scalar z5160 = v_roll * z4292 - z5159 - z4924 * (v_pitch + v_rear);
    const Scalar z5161 = v_roll * z4292 - z5159 - z4924 * (v_pitch + v_rear) + z4308;
    const Scalar z5226 = n2 * (s_roll * z4204 + z4351) - z4147 * z4160 - z4150 * z4165;
    const Scalar z5212 = n0_3 * z5211;
    const Scalar z5220 = n2 * (z4177 * z4208 + z4178 * z4210);
    const Scalar z5213 = a_roll * z4957 + z5212;
    const Scalar z5221 = z4217 * z4224;
    const Scalar z5222 = n2 * (z5221 - z4185 * z5220 - z4215 * z4223 + z4183 * z5216 - z4184 * z5219 + z4213 * z4221);
    const Scalar z5223 = z4218 * z4226;
    const Scalar z5167 = z5166 + v_roll * z4316 + v_pitch * z4926 + v_steer * z4933 - v_front * z4940;
    const Scalar z5168 = z5166 + v_roll * z4316 + v_pitch * z4926 + v_steer * z4933 - v_front * z4940 + z4387;
    const Scalar z5227 = z4147 * z4175 - c_steer * z4150 + n2 * (s_roll * z4197 - c_roll * z4207);
    const Scalar z5228 = s_yaw * z5227 - z4126 * z4216;
    const Scalar z5178 = z5177 + v_roll * z4293 + z4923 * (v_pitch + v_rear);
    const Scalar z5179 = z5177 + v_roll * z4293 + z4923 * (v_pitch + v_rear) - z4299;
    const Scalar z5224 = n0_5 * (z5223 / (z4187 * z4187) - z5222 / z4187);
    const Scalar z5169 = z4353 + z4188 * z4215 + z4184 * z4355;
    const Scalar z5229 = c_steer * z4147 + z4150 * z4175 + n2 * (s_roll * z4207 + z4209);
    const Scalar z5171 = z4368 + z5169;
    const Scalar z5172 = z4364 * z4932 + z4377 + z4323 * z5171 - z4325 * z4376;
    const Scalar z5170 = z4361 - z4125 * z4917 + s_roll * z5169 - z4115 * z4359;
    const Scalar z5230 = z4180 * z5229 - z4178 * z5228 + n2 * (z4177 * z4212 - z5215);
    const Scalar z5231 = z4130 * z4216 + c_yaw * z5227;
    const Scalar z5232 = z4178 * z5231 - z4182 * z5229 + n2 * (z4177 * z4214 + z5218);
    const Scalar z5173 = z4353 - z5169;
    const Scalar z5174 = z4208 * z4939 + z4381 + z4178 * z5173 + z4182 * z4380;
    const Scalar z5233 = n4 * z4177 * z4208 + z4216 * z5229;
    const Scalar z5225 = z4352 - n0_35 * z5224;
    const Scalar z5234 = n4 * (z5221 - z4215 * z4223 + z4213 * z4221) + n2 * (z4183 * z5230 - z4184 * z5232 - z4185
        * z5233);
    const Scalar z5175 = v_yaw * z5169 - v_roll * z4360 + v_pitch * z5170 - v_steer * z5172 - v_front * z5174;
    const Scalar z5176 = a_yaw * z4917 + a_roll * z4316 + a_pitch * z4926 + a_steer * z4933 - a_front * z4940 - z5175;
    const Scalar z5237 = z4149 * z4165 - z4145 * z4160 - c_roll * z4264 + n2 * (z4125 * z4204 - z4127 * z4195) + s_roll
        * z4273;
    const Scalar z5271 = n0_6 * z4136 * z4143 / (z4120 * z4120 * z4120) + z5196 / (z4120 * z4120);
    const Scalar z5273 = z4121 * z5191 - z4134 * z4942 - z4141 * z4296 + z4118 * z5271;
    const Scalar z5272 = z4116 * z5271 - z4121 * z5186 - z4129 * z4942 - z4138 * z4296;
    const Scalar z5235 = n0_5 * (z5223 / (z4187 * z4187) - z5234 / z4187 + z4219 * z4225 / (z4187 * z4187));
    const Scalar z5236 = z5226 - n0_35 * z5235;
    const Scalar z5296 = z4117 * z5271 - z4121 * z5189 - z4132 * z4942 - z4140 * z4296;
    const Scalar z5275 = z4127 * z4289 + z4291 * z5184 - c_roll * z4308 + z4125 * z4943 - z4128 * z4967 + z4137 * z4301
        + z4114 * z5273 + s_roll * z5272;
    const Scalar z5242 = n4 * z4208;
    const Scalar z5243 = n2 * (z4177 * z4279 - z4178 * z4276) - z4210 * z5242;
    const Scalar z5240 = z4152 * z4178 - z4130 * z4280 + c_yaw * z4279;
    const Scalar z5238 = z4146 * z4178 + z4126 * z4280 + s_yaw * z4279;
    const Scalar z5298 = z4291 * z5187 - z4127 * z4290 + c_roll * z4299 + z4125 * z4944 - z4131 * z4967 + z4139 * z4301
        + z4115 * z5273 + s_roll * z5296;
    const Scalar z5241 = n2 * (z4208 * z5217 + z4210 * z4214) - z4182 * z4276 - z4222 * z4279 + z4177 * z4282 - z4178
        * z5240;
    const Scalar z5239 = z4180 * z4276 + z4220 * z4279 - n2 * (z4208 * z5214 - z4210 * z4212) + z4177 * z4278 + z4178
        * z5238;
    const Scalar z5244 = n4 * (z4217 * z5220 + z4213 * z5216 + z4215 * z5219) + n2 * (z4185 * z5243 - z4224 * z4284
        - z4223 * z4283 + z4221 * z4281 - z4184 * z5241 + z4183 * z5239);
    const Scalar z5245 = n0_5 * (z5244 / z4187 - z4226 * z4285 / (z4187 * z4187) - z4219 * z5222 / (z4187 * z4187)
        + z4218 * z5224 / (z4187 * z4187)) + z4226 * z4286 / (z4187 * z4187 * z4187);
    const Scalar z5303 = z4130 * z4175;
    const Scalar z5305 = c_roll * z4211 - z4127 * z4174;
    const Scalar z5302 = z4125 * z4174 + s_roll * z4211;
    const Scalar z5304 = z4126 * z4230 + z5303 - c_yaw * z4207 + s_yaw * z5302;
    const Scalar z5251 = n0_7 * z4219;
    const Scalar z5252 = z4226 * z5251 / (z4187 * z4187 * z4187) + n0_35 * z5224 / (z4187 * z4187);
    const Scalar z5248 = v_roll * z4971;
    const Scalar z5250 = v_yaw * z4949 - z5248 + z4360 + v_steer * z5004 - v_front * z5015 + v_pitch * z4986;
    const Scalar z5249 = v_yaw * z4949 - z5248 + v_steer * z5004 - v_front * z5015 + v_pitch * z4986;
    const Scalar z5246 = z5237 - n0_35 * z5245;
    const Scalar z5247 = a_roll * z4966 + a_pitch * z4983 + a_steer * z4999 - z5246;
    const Scalar z5307 = z4126 * z4175 - z4130 * z4230 + s_yaw * z4207 + c_yaw * z5302;
    const Scalar z5255 = z4352 - z4188 * z5220 + z4217 * z4946 + z4224 * z4355 + z4185 * z5252;
    const Scalar z5260 = z4367 + z5255;
    const Scalar z5264 = z4352 - z5255;
    const Scalar z5308 = z4208 * z4233;
    const Scalar z5311 = z4215 * z4234;
    const Scalar z5310 = n2 * (z4178 * z5305 - z4208 * z4229);
    const Scalar z5309 = z4178 * z5307 - z5308 - z4182 * z5305 - z4214 * z4229;
    const Scalar z5306 = z4178 * z5304 - z4180 * z5305 - z4208 * z4231 + z4212 * z4229;
    const Scalar z5278 = v_yaw * z4947;
    const Scalar z5280 = v_roll * z4972 + z5278 + v_pitch * z4987 - v_steer * z5008 + v_front * z5017 - z4388;
    const Scalar z5279 = v_roll * z4972 + z5278 + v_pitch * z4987 - v_steer * z5008 + v_front * z5017;
    const Scalar z5312 = n2 * (z5311 + z4217 * z4235 + z4185 * z5310 - z4213 * z4232 + z4184 * z5309 + z4183 * z5306);
    const Scalar z5301 = z4127 * z4164 + c_roll * z4350;
    const Scalar z5268 = v_yaw * z4943;
    const Scalar z5270 = v_roll * z4969 - z5268 - z4309 - z4985 * (v_pitch + v_rear);
    const Scalar z5269 = v_roll * z4969 - z5268 - z4985 * (v_pitch + v_rear);
    const Scalar z5261 = c_yaw * z4364 - z4130 * z4323;
    const Scalar z5253 = c_yaw * z4205 - z4130 * z4168;
    const Scalar z5281 = z4126 * z4168 + s_yaw * z4205;
    const Scalar z5254 = z5253 - z4188 * z5219 + z4215 * z4946 - z4223 * z4355 + z4184 * z5252;
    const Scalar z5282 = z5281 + z4188 * z5216 - z4213 * z4946 - z4221 * z4355 + z4183 * z5252;
    const Scalar z5313 = z4218 * z4237;
    const Scalar z5314 = n0_5 * (z5313 / (z4187 * z4187) + z5312 / z4187);
    const Scalar z5287 = z4126 * z4323 + s_yaw * z4364;
    const Scalar z5293 = v_yaw * z4944;
    const Scalar z5295 = v_roll * z4968 + z5293 - z4302 + z4984 * (v_pitch + v_rear);
    const Scalar z5257 = z4127 * z4314 - z4315 * z5187 + z4125 * z4949 + z4131 * z4970 - c_roll * z4357 - z4139 * z4359
        + s_roll * z5254 + z4115 * z5255;
    const Scalar z5284 = z4125 * z4947 - z4127 * z4313 - z4315 * z5184 + z4128 * z4970 + c_roll * z4387 - z4137 * z4359
        + s_roll * z5282 + z4114 * z5255;
    const Scalar z5294 = v_roll * z4968 + z5293 + z4984 * (v_pitch + v_rear);
    const Scalar z5263 = z5253 - z5254;
    const Scalar z5265 = z4177 * z4379 - z4210 * z4343 - z4344 * z5217 - z4208 * z5013 - z4214 * z5014 + z4222 * z4380
        + z4178 * z5263 + z4182 * z5264;
    const Scalar z5289 = z5281 - z5282;
    const Scalar z5290 = z4344 * z5214 - z4210 * z4342 + z4208 * z5016 - z4212 * z5014 + z4177 * z4397 - z4220 * z4380
        - z4178 * z5289 - z4180 * z5264;
    const Scalar z5315 = z5301 + n0_35 * z5314;
    const Scalar z5258 = c_yaw * z4374 - z4130 * z4329;
    const Scalar z5285 = z4126 * z4329 + s_yaw * z4374;
    const Scalar z5259 = z5254 - z5258;
    const Scalar z5286 = z5282 - z5285;
    const Scalar z5256 = s_yaw * z5255 - z4126 * z4970;
    const Scalar z5262 = z4337 * z5261 - z4336 * z4372 + z4364 * z5001 + z4373 * z5003 + z4322 * z4370 + z4376 * z5002
        + z4323 * z5259 - z4325 * z5260;
    const Scalar z5288 = z4335 * z4372 + z4337 * z5287 + z4364 * z5006 - z4394 * z5003 + z4322 * z4393 + z4376 * z5007
        + z4323 * z5286 - z4324 * z5260;
    const Scalar z5266 = v_yaw * z5254 + v_roll * z5256 + v_pitch * z5257 - v_steer * z5262 - v_front * z5265;
    const Scalar z5267 = a_yaw * z4949 - a_roll * z4971 + a_pitch * z4986 + a_steer * z5004 - a_front * z5015 + z5266;
    const Scalar z5332 = z4163 * z4271 + s_pitch * z4270 + c_pitch * z4268 + z4162 * z4272 + n2 * (z4196 * z4203 - z4200
        * z4201);
    const Scalar z5283 = z4130 * z4970 + c_yaw * z5255;
    const Scalar z5291 = v_yaw * z5282 - v_roll * z5283 + v_pitch * z5284 - v_steer * z5288 + v_front * z5290;
    const Scalar z5333 = z4145 * z4164 - z4147 * z4350 + c_roll * z5332;
    const Scalar z5316 = n2 * z4201;
    const Scalar z5317 = n2 * z4196;
    const Scalar z5318 = z4162 * z5316 - z4163 * z5317 + n2 * (c_pitch * z4200 + z4349);
    const Scalar z5320 = z4110 * z5316 + z4112 * z5317 + n2 * (s_pitch * z4194 - c_pitch * z4193);
    const Scalar z5322 = z4110 * z5317 - z4112 * z5316 + n2 * (s_pitch * z4193 + c_pitch * z4194);
    const Scalar z5292 = a_yaw * z4947 + a_roll * z4972 + a_pitch * z4987 - a_steer * z5008 + a_front * z5017 + z5291;
    const Scalar z5319 = z4147 * z4164 + c_roll * z5318;
    const Scalar z5321 = z4150 * z4174 + s_roll * z5320;
    const Scalar z5323 = n2 * (z4126 * z4230 + z5303) - c_yaw * z5322 + s_yaw * z5321;
    const Scalar z5326 = n2 * (z4126 * z4175 - z4130 * z4230) + s_yaw * z5322 + c_yaw * z5321;
    const Scalar z5324 = c_roll * z5320 - z4147 * z4174;
    const Scalar z5327 = z4178 * z5326 - z4182 * z5324 - n2 * (z4214 * z4229 + z5308);
    const Scalar z5325 = z4178 * z5323 - z4180 * z5324 - n2 * (z4208 * z4231 - z4212 * z4229);
    const Scalar z5328 = z4216 * z5324 - z4229 * z5242;
    const Scalar z5274 = c_yaw * z5273 - z4130 * z4967;
    const Scalar z5329 = n2 * (z4185 * z5328 + z4183 * z5325 + z4184 * z5327) - n4 * (z4213 * z4232 - z5311 - z4217
        * z4235);
    const Scalar z5276 = v_yaw * z5272 - v_roll * z5274 + z5275 * (v_pitch + v_rear);
    const Scalar z5277 = z4985 * (a_pitch + a_rear) + a_yaw * z4943 - a_roll * z4969 + z5276;
    const Scalar z5349 = s_roll * z4350 - z4125 * z4164;
    const Scalar z5297 = z4126 * z4967 + s_yaw * z5273;
    const Scalar z5299 = v_roll * z5297 + v_yaw * z5296 + z5298 * (v_pitch + v_rear);
    const Scalar z5330 = n0_5 * (z5329 / z4187 + z5313 / (z4187 * z4187) + z4219 * z4236 / (z4187 * z4187));
    const Scalar z5336 = z4145 * z4174 + z4147 * z4211 + c_roll * z4277;
    const Scalar z5334 = z4149 * z4174 - z4150 * z4211 + s_roll * z4277;
    const Scalar z5300 = z4984 * (a_pitch + a_rear) + a_yaw * z4944 + a_roll * z4968 + z5299;
    const Scalar z5384 = z32 * z4197;
    const Scalar z5385 = z31 * z4197;
    const Scalar z5388 = z890 * z4192;
    const Scalar z5387 = -z4192 * (n1 - z889);
    const Scalar z5389 = n0_35 * z5388 + n0_08 * z5387;
    const Scalar z5340 = z5242 * z5305 + n2 * (z4178 * z5336 + z4229 * z4279);
    const Scalar z5331 = z5319 + n0_35 * z5330;
    const Scalar z5392 = z4196 * z4244;
    const Scalar z5390 = -z4192 * (n1 - z891);
    const Scalar z5391 = n0_08 * z5388 + n0_35 * z5390;
    const Scalar z5338 = z4146 * z4175 + z4152 * z4230 - n2 * (z4126 * z4207 - z4130 * z5302) + s_yaw * z4275 + c_yaw
        * z5334;
    const Scalar z5335 = z4146 * z4230 - z4152 * z4175 - n2 * (z4130 * z4207 + z4126 * z5302) - c_yaw * z4275 + s_yaw
        * z5334;
    const Scalar z5339 = n2 * (z4208 * z5307 + z4214 * z5305) - z4182 * z5336 + z4233 * z4279 + z4178 * z5338 - z4229
        * z4282;
    const Scalar z5337 = z4231 * z4279 - z4180 * z5336 + n2 * (z4208 * z5304 - z4212 * z5305) + z4178 * z5335 + z4229
        * z4278;
    const Scalar z5341 = n4 * (z4213 * z5306 - z4215 * z5309 - z4217 * z5310) + n2 * (z4185 * z5340 - z4235 * z4284
        + z4234 * z4283 - z4232 * z4281 + z4184 * z5339 + z4183 * z5337);
    const Scalar z5342 = n0_5 * (z4219 * z5312 / (z4187 * z4187) - z4237 * z4285 / (z4187 * z4187) - z5341 / z4187
        + z4218 * z5314 / (z4187 * z4187)) + z4237 * z4286 / (z4187 * z4187 * z4187);
    const Scalar z5348 = z4237 * z5251 / (z4187 * z4187 * z4187) + n0_35 * z5314 / (z4187 * z4187);
    const Scalar z5352 = z4217 * z5021 - z5301 - z4188 * z5310 - z4235 * z4355 + z4185 * z5348;
    const Scalar z5365 = z5301 + z5352;
    const Scalar z5396 = z4201 * z4240;
    const Scalar z5399 = z4196 * z4240;
    const Scalar z5401 = z4130 * z4252;
    const Scalar z5397 = z5396 + s_pitch * z5384 - z4196 * z4239 + c_pitch * z5385;
    const Scalar z5400 = s_pitch * z5385 - z5399 - z4201 * z4239 - c_pitch * z5384;
    const Scalar z5343 = z5333 + n0_35 * z5342;
    const Scalar z5403 = s_steer * z4125;
    const Scalar z5344 = a_roll * z5028 + a_pitch * z5044 + a_steer * z5060 + z5343;
    const Scalar z5393 = z4201 * z4246 - z5392 + s_pitch * z5389 - c_pitch * z5391;
    const Scalar z5404 = s_roll * z4192 + z5403 + z4127 * z4249 + c_roll * z5397;
    const Scalar z5398 = s_steer * z4127 - c_roll * z4192 - z4125 * z4249 + s_roll * z5397;
    const Scalar z5402 = z5401 - z4126 * z4251 + c_yaw * z5400 + s_yaw * z5398;
    const Scalar z5386 = n0_08 * z5384 - n0_35 * z5385;
    const Scalar z5394 = z4125 * z4241;
    const Scalar z5345 = v_yaw * z5024;
    const Scalar z5347 = v_roll * z5030 + z5345 + v_pitch * z5045 - v_steer * z5069 + v_front * z5078 - z4362;
    const Scalar z5346 = v_roll * z5030 + z5345 + v_pitch * z5045 - v_steer * z5069 + v_front * z5078;
    const Scalar z5405 = z4208 * z4253;
    const Scalar z5407 = z4126 * z4252;
    const Scalar z5409 = z4208 * z4255;
    const Scalar z5406 = z5405 - z4180 * z5404 + z4178 * z5402 + z4212 * z4250;
    const Scalar z5408 = s_yaw * z5400 - z5407 - z4130 * z4251 - c_yaw * z5398;
    const Scalar z5369 = v_yaw * z5022;
    const Scalar z5371 = v_roll * z5031 - z5369 - v_pitch * z5046 + v_steer * z5073 + v_front * z5080 - z4390;
    const Scalar z5370 = v_roll * z5031 - z5369 - v_pitch * z5046 + v_steer * z5073 + v_front * z5080;
    const Scalar z5395 = s_roll * z5386 - z5394 + z4127 * z4247 + c_roll * z5393;
    const Scalar z5361 = s_roll * z4371 - z4125 * z4320;
    const Scalar z5360 = z4127 * z4320 + c_roll * z4371;
    const Scalar z5350 = s_yaw * z4204 - z4126 * z4165 - z4130 * z4975 - c_yaw * z5349;
    const Scalar z5372 = z4130 * z4165 - z4126 * z4975 + c_yaw * z4204 + s_yaw * z5349;
    const Scalar z5351 = z5350 - z4188 * z5309 + z4215 * z5021 - z4234 * z4355 + z4184 * z5348;
    const Scalar z5373 = z4183 * z5348 - z5372 - z4188 * z5306 - z4213 * z5021 - z4232 * z4355;
    const Scalar z5412 = z4215 * z4256;
    const Scalar z5411 = n2 * (z4178 * z5404 - z4208 * z4250);
    const Scalar z5410 = z4182 * z5404 + z5409 + z4214 * z4250 + z4178 * z5408;
    const Scalar z5364 = z5350 - z5351;
    const Scalar z5378 = z4130 * z4321 - c_yaw * z4363 - z4126 * z5065 + s_yaw * z5361;
    const Scalar z5362 = z4126 * z4321 + s_yaw * z4363 + z4130 * z5065 + c_yaw * z5361;
    const Scalar z5366 = z4214 * z5077 - z4343 * z5305 - z4344 * z5307 - z4229 * z4379 - z4233 * z4380 + z4208 * z5076
        + z4178 * z5364 - z4182 * z5365;
    const Scalar z5380 = z5372 + z5373;
    const Scalar z5381 = z4344 * z5304 - z4342 * z5305 + z4208 * z5079 + z4212 * z5077 - z4229 * z4397 + z4231 * z4380
        + z4180 * z5365 + z4178 * z5380;
    const Scalar z5355 = z4125 * z4326 + s_roll * z4365;
    const Scalar z5358 = c_roll * z4365 - z4127 * z4326;
    const Scalar z5359 = z5352 - z5358;
    const Scalar z5356 = z4126 * z4327 + s_yaw * z4366 + z4130 * z5062 - c_yaw * z5355;
    const Scalar z5376 = c_yaw * z4366 - z4130 * z4327 + z4126 * z5062 + s_yaw * z5355;
    const Scalar z5357 = z5351 + z5356;
    const Scalar z5363 = z4373 * z5068 - z4336 * z5360 - z4337 * z5362 - z4370 * z5061 - z4376 * z5066 + z4364 * z5064
        + z4323 * z5357 - z4325 * z5359;
    const Scalar z5377 = z5373 - z5376;
    const Scalar z5379 = z4335 * z5360 - z4337 * z5378 + z4364 * z5071 - z4394 * z5068 + z4376 * z5072 - z4393 * z5061
        - z4324 * z5359 + z4323 * z5377;
    const Scalar z5353 = z4126 * z5029 + s_yaw * z5352;
    const Scalar z5413 = n2 * (z5412 + z4217 * z4257 + z4185 * z5411 + z4183 * z5406 - z4184 * z5410 + z4213 * z4254);
    const Scalar z5374 = c_yaw * z5352 - z4130 * z5029;
    const Scalar z5354 = z4125 * z5024 - z4131 * z5029 + s_roll * z5351 + z4115 * z5352;
    const Scalar z5367 = v_yaw * z5351 + v_roll * z5353 + v_pitch * z5354 - v_steer * z5363 - v_front * z5366;
    const Scalar z5375 = z4125 * z5022 - z4128 * z5029 + z4114 * z5352 + s_roll * z5373;
    const Scalar z5382 = v_yaw * z5373 - v_roll * z5374 + v_pitch * z5375 - v_steer * z5379 + v_front * z5381;
    const Scalar z5368 = a_yaw * z5024 + a_roll * z5030 + a_pitch * z5045 - a_steer * z5069 + a_front * z5078 + z5367;
    const Scalar z5417 = n2 * z4197;
    const Scalar z5441 = z32 * z4265;
    const Scalar z5442 = z31 * z4265;
    const Scalar z5419 = z31 * z5417;
    const Scalar z5418 = z32 * z5417;
    const Scalar z5383 = a_yaw * z5022 - a_roll * z5031 + a_pitch * z5046 - a_steer * z5073 - a_front * z5080 + z5382;
    const Scalar z5431 = s_pitch * z5419 - n2 * (z4201 * z4239 + z5399) - c_pitch * z5418;
    const Scalar z5429 = s_pitch * z5418 - n2 * (z4196 * z4239 - z5396) + c_pitch * z5419;
    const Scalar z5420 = n0_08 * z5418 - n0_35 * z5419;
    const Scalar z5451 = z4239 * z4271 + z4240 * z4272 + s_pitch * z5441 + c_pitch * z5442 + n2 * (z4196 * z5384 - z4201
        * z5385);
    const Scalar z5453 = z4240 * z4271 - z4239 * z4272 + s_pitch * z5442 - c_pitch * z5441 + n2 * (z4196 * z5385 + z4201
        * z5384);
    const Scalar z5443 = n0_08 * z5441 - n0_35 * z5442;
    const Scalar z5455 = s_roll * z4261 + s_steer * z4149 - z4145 * z4249 - n2 * (z4125 * z4192 - z4127 * z5397)
        - c_roll * z5451;
    const Scalar z5452 = c_roll * z4261 + s_steer * z4145 + z4149 * z4249 + n2 * (z4127 * z4192 + z4125 * z5397)
        + s_roll * z5451;
    const Scalar z5421 = n2 * z4192;
    const Scalar z5433 = n2 * (z4127 * z4249 + z5403) + s_roll * z5421 + c_roll * z5429;
    const Scalar z5430 = n2 * (s_steer * z4127 - z4125 * z4249) - c_roll * z5421 + s_roll * z5429;
    const Scalar z5414 = z4218 * z4259;
    const Scalar z5432 = c_yaw * z5431 - n2 * (z4126 * z4251 - z5401) + s_yaw * z5430;
    const Scalar z5435 = s_yaw * z5431 - n2 * (z4130 * z4251 + z5407) - c_yaw * z5430;
    const Scalar z5434 = z4178 * z5432 - z4180 * z5433 + n2 * (z4212 * z4250 + z5405);
    const Scalar z5436 = z4182 * z5433 + n2 * (z4214 * z4250 + z5409) + z4178 * z5435;
    const Scalar z5437 = z4216 * z5433 - z4250 * z5242;
    const Scalar z5438 = n4 * (z5412 + z4217 * z4257 + z4213 * z4254) + n2 * (z4185 * z5437 + z4183 * z5434 - z4184
        * z5436);
    const Scalar z5459 = z5242 * z5404 + n2 * (z4178 * z5455 + z4250 * z4279);
    const Scalar z5457 = z4146 * z4252 - z4152 * z4251 + n2 * (z4126 * z5400 + z4130 * z5398) + s_yaw * z5453 - c_yaw
        * z5452;
    const Scalar z5454 = z4152 * z4252 + z4146 * z4251 + n2 * (z4126 * z5398 - z4130 * z5400) + c_yaw * z5453 + s_yaw
        * z5452;
    const Scalar z5458 = z4255 * z4279 - z4182 * z5455 - n2 * (z4208 * z5408 - z4214 * z5404) + z4178 * z5457 - z4250
        * z4282;
    const Scalar z5456 = z4180 * z5455 + z4253 * z4279 - n2 * (z4208 * z5402 - z4212 * z5404) + z4178 * z5454 - z4250
        * z4278;
    const Scalar z5460 = n2 * (z4257 * z4284 - z4185 * z5459 - z4256 * z4283 - z4254 * z4281 - z4184 * z5458 + z4183
        * z5456) - n4 * (z4213 * z5406 + z4215 * z5410 - z4217 * z5411);
    const Scalar z5439 = n0_5 * (z5414 / (z4187 * z4187) - z5438 / z4187 + z4219 * z4258 / (z4187 * z4187));
    const Scalar z5415 = n0_5 * (z5414 / (z4187 * z4187) - z5413 / z4187);
    const Scalar z5461 = n0_5 * (z4218 * z5415 / (z4187 * z4187) - z4219 * z5413 / (z4187 * z4187) - z4259 * z4285
        / (z4187 * z4187) - z5460 / z4187) + z4259 * z4286 / (z4187 * z4187 * z4187);
    const Scalar z5467 = z4259 * z5251 / (z4187 * z4187 * z4187) + n0_35 * z5415 / (z4187 * z4187);
    const Scalar z5416 = z5395 - n0_35 * z5415;
    const Scalar z5464 = v_roll * z5093;
    const Scalar z5466 = v_yaw * z5087 + z5464 + v_pitch * z5099 - v_steer * z5116 - v_front * z5122 - z4378;
    const Scalar z5472 = z5395 + z4188 * z5411 + z4217 * z5084 + z4257 * z4355 + z4185 * z5467;
    const Scalar z5465 = v_yaw * z5087 + z5464 + v_pitch * z5099 - v_steer * z5116 - v_front * z5122;
    const Scalar z5477 = z5395 - z5472;
    const Scalar z5481 = v_yaw * z5085;
    const Scalar z5468 = z4196 * z4246 + z4201 * z4244 + s_pitch * z5391 + c_pitch * z5389;
    const Scalar z5445 = z890 * z4261;
    const Scalar z5469 = s_roll * z5393 - c_roll * z5386 - z4125 * z4247 - z4127 * z4241;
    const Scalar z5444 = -z4261 * (n1 - z889);
    const Scalar z5446 = n0_35 * z5445 + n0_08 * z5444;
    const Scalar z5447 = -z4261 * (n1 - z891);
    const Scalar z5448 = n0_08 * z5445 + n0_35 * z5447;
    const Scalar z5470 = z4126 * z5049 + z4130 * z4991 + s_yaw * z5468 + c_yaw * z5469;
    const Scalar z5449 = s_pitch * z5446 - z4246 * z4272 - z4244 * z4271 - c_pitch * z5448 - n2 * (z4196 * z5389 + z4201
        * z5391);
    const Scalar z5471 = z5470 - z4188 * z5410 + z4215 * z5084 + z4256 * z4355 + z4184 * z5467;
    const Scalar z5423 = z890 * z5421;
    const Scalar z5422 = -z5421 * (n1 - z889);
    const Scalar z5425 = -z5421 * (n1 - z891);
    const Scalar z5424 = n0_35 * z5423 + n0_08 * z5422;
    const Scalar z5484 = z4130 * z5049 - z4126 * z4991 - c_yaw * z5468 + s_yaw * z5469;
    const Scalar z5485 = z5484 + z4188 * z5406 - z4213 * z5084 - z4254 * z4355 + z4183 * z5467;
    const Scalar z5450 = z4149 * z4241 + s_roll * z5443 + z4145 * z4247 + n2 * (z4125 * z5386 - z4127 * z5393) - c_roll
        * z5449;
    const Scalar z5426 = n0_08 * z5423 + n0_35 * z5425;
    const Scalar z5427 = s_pitch * z5424 - c_pitch * z5426 + n2 * (z4201 * z4246 - z5392);
    const Scalar z5474 = z4125 * z5087 - z4131 * z5092 + s_roll * z5471 + z4115 * z5472;
    const Scalar z5487 = z4125 * z5085 - z4128 * z5092 + s_roll * z5485 + z4114 * z5472;
    const Scalar z5428 = s_roll * z5420 + n2 * (z4127 * z4247 - z5394) + c_roll * z5427;
    const Scalar z5475 = z4364 * z5087 + z4373 * z5092 + z4323 * z5471 - z4325 * z5472;
    const Scalar z5488 = z4364 * z5085 - z4394 * z5092 + z4323 * z5485 - z4324 * z5472;
    const Scalar z5462 = z5450 - n0_35 * z5461;
    const Scalar z5463 = a_roll * z5091 + a_pitch * z5098 - a_steer * z5115 + z5462;
    const Scalar z5440 = z5428 - n0_35 * z5439;
    const Scalar z5473 = z4126 * z5092 + s_yaw * z5472;
    const Scalar z5486 = c_yaw * z5472 - z4130 * z5092;
    const Scalar z5476 = z5470 - z5471;
    const Scalar z5478 = z4343 * z5404 - z4344 * z5408 - z4208 * z5120 - z4214 * z5121 + z4250 * z4379 + z4255 * z4380
        + z4178 * z5476 + z4182 * z5477;
    const Scalar z5489 = z5484 - z5485;
    const Scalar z5490 = z4344 * z5402 - z4342 * z5404 + z4212 * z5121 - z4250 * z4397 - z4253 * z4380 + z4208 * z5123
        + z4178 * z5489 + z4180 * z5477;
    const Scalar z5479 = v_yaw * z5471 + v_roll * z5473 + v_pitch * z5474 - v_steer * z5475 - v_front * z5478;
    const Scalar z5480 = a_yaw * z5087 + a_roll * z5093 + a_pitch * z5099 - a_steer * z5116 - a_front * z5122 + z5479;
    const Scalar z5491 = v_yaw * z5485 - v_roll * z5486 + v_pitch * z5487 - v_steer * z5488 - v_front * z5490;
    const Scalar z5492 = a_yaw * z5085 - a_roll * z5094 + a_pitch * z5100 - a_steer * z5117 + a_front * z5124 + z5491;
    const Scalar z5483 = v_roll * z5094 - z5481 - v_pitch * z5100 + v_steer * z5117 - v_front * z5124 + z4396;
    const Scalar z5482 = v_roll * z5094 - z5481 - v_pitch * z5100 + v_steer * z5117 - v_front * z5124;
    const Scalar z5498 = n1 / z4346;
    const Scalar z5499 = z4348 * z5498;
    const Scalar z5493 = n1 / z4238;
    const Scalar z5518 = z4144 + z4227;
    const Scalar z5519 = z5493 * z5518;
    const Scalar z5520 = z4260 * z5493;
    const Scalar z5496 = z4319 * z5493;
    const Scalar z5500 = z4313 - z4314 * z5499;
    const Scalar z5549 = z5315 * z5520 - z5416;
    const Scalar z5548 = z5225 - z5315 * z5519;
    const Scalar z5550 = z5249 + z5346 * z5519;
    const Scalar z5551 = z5346 * z5520 + z5465;
    const Scalar z5501 = z4289 - z5500;
    const Scalar z5552 = z5279 - z5370 * z5519;
    const Scalar z5553 = z5370 * z5520 + z5482;
    const Scalar z5512 = z5501 * z5501;
    const Scalar z5502 = n1 / z5501;
    const Scalar z5495 = z4295 * z5493;
    const Scalar z5494 = z4318 * z5493;
    const Scalar z5554 = z5167 - z5160 + z5149 * z5499;
    const Scalar z5532 = z4260 * z5495;
    const Scalar z5531 = z4260 * z5494 - z4339;
    const Scalar z5497 = z4294 * z5493;
    const Scalar z5562 = z5196 - z5548;
    const Scalar z5533 = z4260 * z5496 - z4341 - z5532 - z5499 * z5531;
    const Scalar z5522 = z4293 - z5495 * z5518;
    const Scalar z5521 = z4316 - z5494 * z5518;
    const Scalar z5523 = z4317 - z5496 * z5518 - z5522 - z5499 * z5521;
    const Scalar z5503 = z4290 * z5502;
    const Scalar z5563 = z5494 * z5562 - z5550;
    const Scalar z5506 = z4238 * z4238;
    const Scalar z5507 = n1_over_94 + z4260 * z4260 / z587 + z4227 * z4227 / z4519 + z5506 / z4502;
    const Scalar z5555 = z5178 - z5503 * z5554;
    const Scalar z5524 = z4292 - z5497 * z5518 + z5503 * z5523;
    const Scalar z5504 = n1 - z5499 * z5503;
    const Scalar z5564 = z5269 + z5495 * z5562;
    const Scalar z5515 = z5504 * z5504;
    const Scalar z5505 = n1 / z5504;
    const Scalar z5565 = z5496 * z5562 - z5564 + z5552 - z5499 * z5563;
    const Scalar z5541 = z4294 - z4295 * z5503;
    const Scalar z5534 = z4260 * z5497 + z5503 * z5533;
    const Scalar z5509 = z4346 * z4346;
    const Scalar z5510 = n1_over_94 + n25_over_7 * z5509 + z4314 * z4314 / z4531 + z4316 * z4316 / z4519 + z4339 * z4339
        / z587 + z4318 * z4318 / z4502;
    const Scalar z5508 = z4502 * z5507;
    const Scalar z5542 = z5505 * z5541;
    const Scalar z5535 = z5505 * z5534;
    const Scalar z5566 = z5294 + z5497 * z5562 + z5503 * z5565;
    const Scalar z5536 = z5499 * z5535 + z5533;
    const Scalar z5556 = z5505 * z5555;
    const Scalar z5567 = z5505 * z5566;
    const Scalar z5537 = z5502 * z5536;
    const Scalar z5525 = z5505 * z5524;
    const Scalar z5557 = z5499 * z5556 - z5554;
    const Scalar z5568 = z5499 * z5567 + z5565;
    const Scalar z5538 = z4289 * z5537 + z5532;
    const Scalar z5511 = n0_28 * z5510;
    const Scalar z5526 = z5499 * z5525 + z5523;
    const Scalar z5558 = z5502 * z5557;
    const Scalar z5569 = z5502 * z5568;
    const Scalar z5560 = z5149 - z5556 + z4314 * z5558;
    const Scalar z5571 = z5563 - z5567 + z4314 * z5569;
    const Scalar z5559 = z4289 * z5558 - z5160;
    const Scalar z5570 = z4289 * z5569 + z5564;
    const Scalar z5527 = z5502 * z5526;
    const Scalar z5539 = z5531 - z5535 + z4314 * z5537;
    const Scalar z5540 = z5498 * z5539;
    const Scalar z5561 = z5498 * z5560;
    const Scalar z5528 = z4289 * z5527 + z5522;
    const Scalar z5529 = z5521 - z5525 + z4314 * z5527;
    const Scalar z5572 = z5498 * z5571;
    const Scalar z5530 = z5498 * z5529;
    const Scalar z5543 = z4295 - z5499 * z5542;
    const Scalar z5544 = z5502 * z5543;
    const Scalar z5513 = n1_over_94 + n25_over_7 * z4348 * z4348 + z4313 * z4313 / z4531 + z4317 * z4317 / z4519 + z4341
        * z4341 / z587 + z4319 * z4319 / z4502;
    const Scalar z5514 = z4531 * z5513;
    const Scalar z5574 = z5494 * z5549 - z5551;
    const Scalar z5573 = z5493 * z5562;
    const Scalar z5575 = z5495 * z5549;
    const Scalar z5545 = z4289 * z5544 - z4295;
    const Scalar z5546 = z4314 * z5544 + z5542;
    const Scalar z5547 = z5498 * z5546;
    const Scalar z5516 = n1_over_94 + z4294 * z4294 * (n25_over_3 + n1 / z4502) + z4292 * z4292 / z4519 + z4290 * z4290
        / z4531;
    const Scalar z5517 = n94 * z5516;
    const Scalar z5576 = z5496 * z5549 - z5575 - z5553 - z5499 * z5574;
    const Scalar z5585 = z5236 - z5331 * z5519;
    const Scalar z5586 = z5331 * z5520 - z5440;
    const Scalar z5590 = z4311 * z5519 + z5270 - z5161 * z5527;
    const Scalar z5599 = z5204 - z5585;
    const Scalar z5601 = z5495 * z5599 + z5590;
    const Scalar z5593 = z5150 * z5527 - z5250 - z5347 * z5519 + z4382 * z5530;
    const Scalar z5594 = z5466 + z5347 * z5520 + z5150 * z5537 + z4382 * z5540;
    const Scalar z5596 = z5280 - z5371 * z5519 - z5168 * z5527 + z4399 * z5530;
    const Scalar z5597 = z5371 * z5520 + z5483 - z5168 * z5537 + z4399 * z5540;
    const Scalar z5587 = z4304 * z5519 + z5295 + z5179 * z5527;
    const Scalar z5600 = z5494 * z5599 + z5593;
    const Scalar z5611 = z5494 * z5586 - z5594;
    const Scalar z5602 = z5496 * z5599 - z5601 + z5596 - z5499 * z5600;
    const Scalar z5577 = z5497 * z5549 + z5503 * z5576;
    const Scalar z5578 = z5505 * z5577;
    const Scalar z5584 = z5493 * z5549;
    const Scalar z5603 = z5497 * z5599 + z5587 + z5503 * z5602;
    const Scalar z5579 = z5499 * z5578 + z5576;
    const Scalar z5610 = z5493 * z5599;
    const Scalar z5604 = z5505 * z5603;
    const Scalar z5630 = z5331 * z5573;
    const Scalar z5631 = z5331 * z5584;
    const Scalar z5605 = z5499 * z5604 + z5602;
    const Scalar z5580 = z5502 * z5579;
    const Scalar z5636 = z4311 * z5573 + z5161 * z5569;
    const Scalar z5591 = z4311 * z5520 + z5161 * z5537;
    const Scalar z5582 = z5574 - z5578 + z4314 * z5580;
    const Scalar z5581 = z4289 * z5580 + z5575;
    const Scalar z5612 = z5495 * z5586 + z5591;
    const Scalar z5583 = z5498 * z5582;
    const Scalar z5644 = z5247 + z5344 * z5519;
    const Scalar z5645 = z5344 * z5520 - z5463;
    const Scalar z5646 = z5267 + z5368 * z5519;
    const Scalar z5647 = z5368 * z5520 + z5480;
    const Scalar z5613 = z5496 * z5586 - z5612 - z5597 - z5499 * z5611;
    const Scalar z5606 = z5502 * z5605;
    const Scalar z5607 = z4289 * z5606 + z5601;
    const Scalar z5608 = z5600 - z5604 + z4314 * z5606;
    const Scalar z5637 = z4311 * z5584 + z5161 * z5580;
    const Scalar z5592 = z4311 - z5161 * z5544;
    const Scalar z5635 = z5161 * z5558;
    const Scalar z5609 = z5498 * z5608;
    const Scalar z5638 = z5150 * z5558 + z4382 * z5561;
    const Scalar z5639 = z5347 * z5573 + z5150 * z5569 + z4382 * z5572;
    const Scalar z5640 = z5347 * z5584 + z5150 * z5580 + z4382 * z5583;
    const Scalar z5595 = z5150 * z5544 + z4382 * z5547;
    const Scalar z5642 = z5371 * z5573 - z5168 * z5569 + z4399 * z5572;
    const Scalar z5643 = z5371 * z5584 - z5168 * z5580 + z4399 * z5583;
    const Scalar z5641 = z4399 * z5561 - z5168 * z5558;
    const Scalar z5598 = z4399 * z5547 - z5168 * z5544;
    const Scalar z5622 = z5499 * z5595 + z5592 - z5598;
    const Scalar z5633 = z4304 * z5573 - z5179 * z5569;
    const Scalar z5632 = z5179 * z5558;
    const Scalar z5588 = z4304 * z5520 - z5179 * z5537;
    const Scalar z5648 = z5292 + z5383 * z5519;
    const Scalar z5614 = z5497 * z5586 + z5588 + z5503 * z5613;
    const Scalar z5621 = z5493 * z5586;
    const Scalar z5634 = z4304 * z5584 - z5179 * z5580;
    const Scalar z5589 = z4304 + z5179 * z5544;
    const Scalar z5650 = z5630 + z5644;
    const Scalar z5651 = z5631 + z5645;
    const Scalar z5655 = z5277 - z5636;
    const Scalar z5649 = z5383 * z5520 + z5492;
    const Scalar z5654 = z5165 + z5635;
    const Scalar z5656 = z5158 + z5638;
    const Scalar z5657 = z5639 + z5646;
    const Scalar z5658 = z5640 + z5647;
    const Scalar z5660 = z5642 - z5648;
    const Scalar z5661 = z5643 - z5649;
    const Scalar z5659 = z5176 + z5641;
    const Scalar z5653 = z5300 + z5633;
    const Scalar z5652 = z5183 - z5632;
    const Scalar z5670 = z5213 + z5650;
    const Scalar z5672 = z5495 * z5670 - z5655;
    const Scalar z5671 = z5494 * z5670 - z5657;
    const Scalar z5662 = z5499 * z5656 - z5654 - z5659;
    const Scalar z5623 = z5503 * z5622 - z5589;
    const Scalar z5673 = z5496 * z5670 - z5672 - z5660 - z5499 * z5671;
    const Scalar z5663 = z5503 * z5662 + z5652;
    const Scalar z5624 = z5505 * z5623;
    const Scalar z5664 = z5505 * z5663;
    const Scalar z5615 = z5505 * z5614;
    const Scalar z5625 = z5499 * z5624 + z5622;
    const Scalar z5616 = z5499 * z5615 + z5613;
    const Scalar z5665 = z5499 * z5664 + z5662;
    const Scalar z5626 = z5502 * z5625;
    const Scalar z5617 = z5502 * z5616;
    const Scalar z5666 = z5502 * z5665;
    const Scalar z5674 = z5497 * z5670 + z5653 + z5503 * z5673;
    const Scalar z5627 = z4289 * z5626 - z5592;
    const Scalar z5618 = z4289 * z5617 + z5612;
    const Scalar z5667 = z4289 * z5666 + z5654;
    const Scalar z5675 = z5505 * z5674;
    const Scalar z5619 = z5611 - z5615 + z4314 * z5617;
    const Scalar z5628 = z4314 * z5626 - z5595 - z5624;
    const Scalar z5676 = z5499 * z5675 + z5673;
    const Scalar z5668 = z4314 * z5666 - z5656 - z5664;
    const Scalar z5620 = z5498 * z5619;
    const Scalar z5683 = z5495 * z5651 + z5637;
    const Scalar z5682 = z5494 * z5651 - z5658;
    const Scalar z5684 = z5496 * z5651 - z5683 - z5661 - z5499 * z5682;
    const Scalar z5681 = z5493 * z5670;
    const Scalar z5677 = z5502 * z5676;
    const Scalar z5678 = z4289 * z5677 + z5672;
    const Scalar z5679 = z5671 - z5675 + z4314 * z5677;
    const Scalar z5629 = z5498 * z5628;
    const Scalar z5711 = z4462 + z4144 * z4465 - z4458 * z5519 + z4467 * z5525 + z4466 * z5527 - z4468 * z5528;
    const Scalar z5693 = z5142 - z5143;
    const Scalar z5695 = z5145 + z5495 * z5693;
    const Scalar z5694 = z5144 - z5494 * z5693;
    const Scalar z5716 = z4465 - z4508 * z5520;
    const Scalar z5685 = z5497 * z5651 + z5634 + z5503 * z5684;
    const Scalar z5696 = z5496 * z5693 - z5695 + z5146 + z5499 * z5694;
    const Scalar z5686 = z5505 * z5685;
    const Scalar z5692 = z5493 * z5651;
    const Scalar z5687 = z5499 * z5686 + z5684;
    const Scalar z5709 = z4519 + z4144 * z4522 + z4505 * z5519 - z4524 * z5525 - z4523 * z5527 - z4525 * z5528 + z4448
        * z5530;
    const Scalar z5697 = z5147 - z5497 * z5693 - z5503 * z5696;
    const Scalar z5704 = z5493 * z5693;
    const Scalar z5707 = z4522 + n94 * z4144 + z4508 * z5519;
    const Scalar z5710 = z4505 + z4144 * z4508 + z4502 * z5519 + z4510 * z5525 - z4509 * z5527 + z4511 * z5528 + z4446
        * z5530;
    const Scalar z5698 = z5505 * z5697;
    const Scalar z5699 = z5499 * z5698 - z5696;
    const Scalar z5718 = z4510 * z5535 - z4458 - z4502 * z5520 - z4509 * z5537 + z4511 * z5538 + z4446 * z5540;
    const Scalar z5719 = z587 + z4458 * z5520 + z4467 * z5535 + z4466 * z5537 - z4468 * z5538;
    const Scalar z5715 = z4468 + z4511 * z5520 + z4533 * z5537 - n94 * z5538;
    const Scalar z5714 = z4467 - z4510 * z5520 + n94 * z5535 - z4532 * z5537;
    const Scalar z5705 = z4510 * z5519 - z4524 + n94 * z5525 - z4532 * z5527;
    const Scalar z5717 = z4532 * z5535 - z4466 - z4509 * z5520 - z4531 * z5537 + z4533 * z5538 + z4450 * z5540;
    const Scalar z5706 = z4511 * z5519 - z4525 - z4533 * z5527 + n94 * z5528;
    const Scalar z5725 = n0_12 - z4510 * z5542 - z4509 * z5544 + z4511 * z5545 + z4446 * z5547;
    const Scalar z5708 = z4523 + z4509 * z5519 + z4532 * z5525 - z4531 * z5527 + z4533 * z5528 + z4450 * z5530;
    const Scalar z5724 = z4501 - z4532 * z5542 - z4531 * z5544 + z4533 * z5545 + z4450 * z5547;
    const Scalar z5722 = n94 * z5542 + z4532 * z5544;
    const Scalar z5723 = z4533 * z5544 - n94 * z5545;
    const Scalar z5713 = z4446 * z5519 + z4448 - z4450 * z5527 + n0_28 * z5530;
    const Scalar z5721 = z4446 * z5520 + z4450 * z5537 - n0_28 * z5540;
    const Scalar z5727 = z4450 * z5544 - n0_28 * z5547;
    const Scalar z5688 = z5502 * z5687;
    const Scalar z5700 = z5502 * z5699;
    const Scalar z5728 = z4144 * z5707 + z5525 * z5705 + z5528 * z5706 + z5530 * z5713 + z5519 * z5710 - z5527 * z5708
        + z5709;
    const Scalar z5689 = z4289 * z5688 + z5683;
    const Scalar z5690 = z5682 - z5686 + z4314 * z5688;
    const Scalar z5669 = z5498 * z5668;
    const Scalar z5731 = z5538 * z5715 - z5719 - z5535 * z5714 + z5540 * z5721 + z5520 * z5718 + z5537 * z5717;
    const Scalar z5729 = z5520 * z5710 - z5711 - z5535 * z5705 - z5538 * z5706 - z5540 * z5713 + z5537 * z5708;
    const Scalar z5680 = z5498 * z5679;
    const Scalar z5749 = z4787 + z4824 * z5519;
    const Scalar z5750 = z4824 * z5520 + z4897;
    const Scalar z5743 = z4826 * z5519 - z4789 + z4757 * z5527;
    const Scalar z5747 = z4827 * z5520 - z4900 + z4756 * z5537;
    const Scalar z5744 = z4757 * z5537 - z4899 - z4826 * z5520;
    const Scalar z5746 = z4790 - z4827 * z5519 + z4756 * z5527;
    const Scalar z5691 = z5498 * z5690;
    const Scalar z5756 = z4752 * z5544 - z4828 + z4909 * z5547;
    const Scalar z5760 = z4846 * z5519 - z4850 - z4851 * z5527 + z4914 * z5530;
    const Scalar z5757 = z4795 * z5519 - z4797 - z4798 * z5527 - z4905 * z5530;
    const Scalar z5758 = z4795 * z5520 - z4890 + z4798 * z5537 + z4905 * z5540;
    const Scalar z5751 = z4788 - z4825 * z5519 + z4758 * z5527 + z4913 * z5530;
    const Scalar z5752 = z4825 * z5520 - z4898 + z4758 * z5537 + z4913 * z5540;
    const Scalar z5754 = z4821 * z5519 - z4768 + z4752 * z5527 + z4909 * z5530;
    const Scalar z5755 = z4894 - z4821 * z5520 + z4752 * z5537 + z4909 * z5540;
    const Scalar z5701 = z4289 * z5700 - z5695;
    const Scalar z5702 = z5694 - z5698 + z4314 * z5700;
    const Scalar z5703 = z5498 * z5702;
    const Scalar z5767 = z4903 - z4908 * z5520 - z4913 * z5537;
    const Scalar z5770 = z4144 * z5750 - z5528 * z5747 - z5530 * z5767 + z5525 * z5744 - z5519 * z5758 + z5527 * z5752
        + z5755;
    const Scalar z5763 = z4831 - z4832 * z5527;
    const Scalar z5766 = z4908 * z5519 + z4912 - z4913 * z5527;
    const Scalar z5769 = z4144 * z5749 - z5525 * z5743 + z5528 * z5746 + z5530 * z5766 - z5519 * z5757 - z5527 * z5751
        - z5754;
    const Scalar z5726 = n0_12 - z4501 * z5544;
    const Scalar z5733 = z5542 * z5722 + z5726 - z5545 * z5723 - z5547 * z5727 - z5544 * z5724;
    const Scalar z5720 = n0_12 * z5520 + z4501 * z5537;
    const Scalar z5712 = z4501 * z5527 - n0_12 * z5519;
    const Scalar z5772 = z5760 + z5538 * z5746 - z5535 * z5743 + z5540 * z5766 + z5520 * z5757 - z5537 * z5751;
    const Scalar z5775 = z5763 + z5542 * z5743 + z5545 * z5746 + z5547 * z5766 - z5544 * z5751;
    const Scalar z5732 = z5542 * z5714 + z5720 + z5545 * z5715 + z5547 * z5721 + z5544 * z5717;
    const Scalar z5730 = z5542 * z5705 + z5712 - z5545 * z5706 - z5547 * z5713 + z5544 * z5708;
    const Scalar z5745 = z4757 * z5544;
    const Scalar z5748 = z4756 * z5544;
    const Scalar z5761 = z4846 * z5520 + z4851 * z5537 - z4914 * z5540;
    const Scalar z5773 = z5761 + z5535 * z5744 - z5538 * z5747 - z5540 * z5767 + z5520 * z5758 + z5537 * z5752;
    const Scalar z5762 = z4851 * z5544 - z4914 * z5547;
    const Scalar z5764 = z4832 * z5537;
    const Scalar z5776 = z5545 * z5747 - z5764 + z5547 * z5767 + z5542 * z5744 - z5544 * z5752;
    const Scalar z5765 = z4832 * z5544;
    const Scalar z5768 = z4913 * z5544;
    const Scalar z5759 = z4798 * z5544 + z4905 * z5547;
    const Scalar z5753 = z4758 * z5544 + z4832 + z4913 * z5547;
    const Scalar z5771 = z5528 * z5748 - z5756 - z5525 * z5745 - z5530 * z5768 + z5519 * z5759 - z5527 * z5753;
    const Scalar z5774 = z5762 + z5535 * z5745 - z5538 * z5748 + z5540 * z5768 + z5520 * z5759 + z5537 * z5753;
    const Scalar z5777 = z5542 * z5745 - z5765 + z5545 * z5748 - z5547 * z5768 - z5544 * z5753;
    const Scalar z5734 = z5204 * z5707 + z5610 * z5710 - z5604 * z5705 + z5606 * z5708 - z5607 * z5706 - z5609 * z5713;
    const Scalar z5778 = z5734 + z5769;
    const Scalar z5737 = z5204 * z5716 + z5610 * z5718 - z5604 * z5714 + z5606 * z5717 + z5607 * z5715 + z5609 * z5721;
    const Scalar z5740 = z5610 * z5725 + z5604 * z5722 + z5606 * z5724 + z5607 * z5723 + z5609 * z5727;
    const Scalar z5781 = z5737 + z5772;
    const Scalar z5784 = z5740 + z5775;
    const Scalar z5735 = z5615 * z5705 - z5621 * z5710 - z5617 * z5708 + z5618 * z5706 + z5620 * z5713;
    const Scalar z5779 = z5735 - z5770;
    const Scalar z5736 = z5624 * z5705 - z5626 * z5708 + z5627 * z5706 + z5629 * z5713;
    const Scalar z5780 = z5736 + z5771;
    const Scalar z5796 = z4757 * z5558;
    const Scalar z5797 = z4757 * z5569 - z4826 * z5573;
    const Scalar z5738 = z5615 * z5714 - z5621 * z5718 - z5617 * z5717 - z5618 * z5715 - z5620 * z5721;
    const Scalar z5741 = z5621 * z5725 + z5615 * z5722 + z5617 * z5724 + z5618 * z5723 + z5620 * z5727;
    const Scalar z5798 = z4757 * z5580 - z4826 * z5584;
    const Scalar z5782 = z5738 - z5773;
    const Scalar z5785 = z5741 - z5776;
    const Scalar z5739 = z5624 * z5714 - z5626 * z5717 - z5627 * z5715 - z5629 * z5721;
    const Scalar z5742 = z5624 * z5722 + z5626 * z5724 + z5627 * z5723 + z5629 * z5727;
    const Scalar z5838 = z4762 - z5796;
    const Scalar z5783 = z5739 - z5774;
    const Scalar z5786 = z5742 - z5777;
    const Scalar z5826 = z4777 - z4810 * z5519;
    const Scalar z5827 = z4810 * z5520 - z4873;
    const Scalar z5824 = z4780 - z4813 * z5519;
    const Scalar z5825 = z4813 * z5520 - z4876;
    const Scalar z5834 = z5010 - z5075 * z5519;
    const Scalar z5835 = z5075 * z5520 + z5119;
    const Scalar z5836 = z5019 - z5082 * z5519;
    const Scalar z5837 = z5082 * z5520 + z5126;
    const Scalar z5822 = z4779 + z4812 * z5519;
    const Scalar z5823 = z4812 * z5520 + z4875;
    const Scalar z5839 = z5797 + z5822;
    const Scalar z5840 = z5798 + z5823;
    const Scalar z5832 = z4990 - z5048 * z5519;
    const Scalar z5833 = z5048 * z5520 - z5102;
    const Scalar z5828 = z4951 - z5026 * z5519;
    const Scalar z5829 = z5026 * z5520 - z5089;
    const Scalar z5830 = z4974 + z5033 * z5519;
    const Scalar z5831 = z5033 * z5520 + z5096;
    const Scalar z5802 = z4824 * z5573;
    const Scalar z5844 = z5802 + z5826;
    const Scalar z5803 = z4824 * z5584;
    const Scalar z5845 = z5803 - z5827;
    const Scalar z5800 = z4827 * z5573 + z4756 * z5569;
    const Scalar z5842 = z5800 + z5824;
    const Scalar z5801 = z4827 * z5584 + z4756 * z5580;
    const Scalar z5843 = z5801 - z5825;
    const Scalar z5799 = z4756 * z5558;
    const Scalar z5841 = z4763 + z5799;
    const Scalar z5807 = z4752 * z5558 + z4909 * z5561;
    const Scalar z5810 = z4798 * z5558 + z4905 * z5561;
    const Scalar z5813 = z4851 * z5558 - z4914 * z5561;
    const Scalar z5804 = z4758 * z5558 + z4913 * z5561;
    const Scalar z5846 = z4920 + z5804;
    const Scalar z5814 = z4846 * z5573 + z4851 * z5569 - z4914 * z5572;
    const Scalar z5815 = z4846 * z5584 + z4851 * z5580 - z4914 * z5583;
    const Scalar z5820 = z4908 * z5573 + z4913 * z5569;
    const Scalar z5821 = z4908 * z5584 + z4913 * z5580;
    const Scalar z5816 = z4832 * z5558;
    const Scalar z5819 = z4913 * z5558;
    const Scalar z5817 = z4832 * z5569;
    const Scalar z5818 = z4832 * z5580;
    const Scalar z5811 = z4795 * z5573 + z4798 * z5569 + z4905 * z5572;
    const Scalar z5812 = z4795 * z5584 + z4798 * z5580 + z4905 * z5583;
    const Scalar z5805 = z4758 * z5569 + z4825 * z5573 + z4913 * z5572;
    const Scalar z5806 = z4758 * z5580 + z4825 * z5584 + z4913 * z5583;
    const Scalar z5808 = z4752 * z5569 - z4821 * z5573 + z4909 * z5572;
    const Scalar z5809 = z4752 * z5580 - z4821 * z5584 + z4909 * z5583;
    const Scalar z5787 = z5664 * z5705 - z5666 * z5708 + z5667 * z5706 + z5669 * z5713;
    const Scalar z5847 = z5805 + z5828;
    const Scalar z5788 = z5213 * z5707 + z5681 * z5710 - z5675 * z5705 + z5677 * z5708 - z5678 * z5706 - z5680 * z5713;
    const Scalar z5848 = z5806 - z5829;
    const Scalar z5791 = z5213 * z5716 + z5681 * z5718 - z5675 * z5714 + z5677 * z5717 + z5678 * z5715 + z5680 * z5721;
    const Scalar z5794 = z5681 * z5725 + z5675 * z5722 + z5677 * z5724 + z5678 * z5723 + z5680 * z5727;
    const Scalar z5789 = z5686 * z5705 - z5692 * z5710 - z5688 * z5708 + z5689 * z5706 + z5691 * z5713;
    const Scalar z5849 = z4922 + z5807;
    const Scalar z5790 = z5664 * z5714 - z5666 * z5717 - z5667 * z5715 - z5669 * z5721;
    const Scalar z5793 = z5664 * z5722 + z5666 * z5724 + z5667 * z5723 + z5669 * z5727;
    const Scalar z5850 = z5808 + z5830;
    const Scalar z5851 = z5809 + z5831;
    const Scalar z5792 = z5686 * z5714 - z5692 * z5718 - z5688 * z5717 - z5689 * z5715 - z5691 * z5721;
    const Scalar z5795 = z5692 * z5725 + z5686 * z5722 + z5688 * z5724 + z5689 * z5723 + z5691 * z5727;
    const Scalar z5890 = z5142 * z5707 + z5698 * z5705 + z5701 * z5706 + z5703 * z5713 - z5700 * z5708 + z5704 * z5710;
    const Scalar z5891 = z5142 * z5716 + z5698 * z5714 - z5701 * z5715 - z5703 * z5721 - z5700 * z5717 + z5704 * z5718;
    const Scalar z5892 = z5698 * z5722 + z5701 * z5723 + z5703 * z5727 + z5700 * z5724 - z5704 * z5725;
    const Scalar z5884 = l_lambda_rear_rolls_x * z4290 + l_lambda_rear_rolls_y * z4289 + l_lambda_front_rolls_x * z4314
        + l_lambda_front_rolls_y * z4313 - z5140;
    const Scalar z5885 = l_lambda_rear_rolls_x * z4294 - z5133 + l_lambda_rear_rolls_y * z4295 + l_lambda_front_touches
        * z4238 + l_lambda_front_rolls_x * z4318 + l_lambda_front_rolls_y * z4319;
    const Scalar z5886 = l_lambda_front_rolls_x * z4346 - z4579 + l_lambda_front_rolls_y * z4348;
    const Scalar z5852 = z4929 + z5810;
    const Scalar z5855 = z4935 + z5813;
    const Scalar z5856 = z5814 + z5834;
    const Scalar z5857 = z5815 - z5835;
    const Scalar z5861 = z5820 + z5836;
    const Scalar z5862 = z5821 - z5837;
    const Scalar z5858 = z4936 - z5816;
    const Scalar z5859 = z5012 - z5817;
    const Scalar z5860 = z4941 - z5819;
    const Scalar z5853 = z5811 + z5832;
    const Scalar z5854 = z5812 - z5833;
    const Scalar z5864 = z4144 * z5844 - z5528 * z5842 + z5530 * z5861 + z5525 * z5839 - z5519 * z5853 + z5527 * z5847
        + z5850;
    const Scalar z5865 = z4144 * z5845 - z5528 * z5843 + z5530 * z5862 + z5525 * z5840 - z5519 * z5854 + z5527 * z5848
        + z5851;
    const Scalar z5867 = z5856 + z5540 * z5861 - z5538 * z5842 + z5535 * z5839 + z5520 * z5853 + z5537 * z5847;
    const Scalar z5870 = z5859 + z5545 * z5842 - z5547 * z5861 + z5542 * z5839 - z5544 * z5847;
    const Scalar z5868 = z5857 + z5540 * z5862 - z5538 * z5843 + z5535 * z5840 + z5520 * z5854 + z5537 * z5848;
    const Scalar z5871 = z5545 * z5843 - z5818 - z5547 * z5862 + z5542 * z5840 - z5544 * z5848;
    const Scalar z5873 = z5788 + z5864;
    const Scalar z5874 = z5789 - z5865;
    const Scalar z5876 = z5791 + z5867;
    const Scalar z5877 = z5792 - z5868;
    const Scalar z5879 = z5794 - z5870;
    const Scalar z5880 = z5795 - z5871;
    const Scalar z5896 = n1 / z5733;
    const Scalar z5883 = l_lambda_rear_touches + l_lambda_front_touches - z4620;
    const Scalar z5863 = z5525 * z5838 - z5849 + z5528 * z5841 + z5530 * z5860 + z5519 * z5852 - z5527 * z5846;
    const Scalar z5866 = z5855 + z5520 * z5852 - z5535 * z5838 - z5538 * z5841 - z5540 * z5860 + z5537 * z5846;
    const Scalar z5869 = z5542 * z5838 - z5858 - z5545 * z5841 - z5547 * z5860 + z5544 * z5846;
    const Scalar z5872 = z5787 + z5863;
    const Scalar z5875 = z5790 - z5866;
    const Scalar z5878 = z5793 + z5869;
    const Scalar z5881 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z4618;
    const Scalar z5882 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z4619;
    const Scalar z5887 = z5138 + l_lambda_rear_rolls_x * z4292 + l_lambda_rear_rolls_y * z4293 + l_lambda_front_touches
        * z4227 + l_lambda_front_rolls_x * z4316 + l_lambda_front_rolls_y * z4317 - z4144 * (l_lambda_rear_touches
        - z5883) - z5519 * z5885 - z5525 * z5881 + z5527 * z5884 - z5528 * z5882 - z5530 * z5886;
    const Scalar z5888 = l_lambda_front_touches * z4260 - z5141 + l_lambda_front_rolls_x * z4339
        + l_lambda_front_rolls_y * z4341 - z5520 * z5885 + z5535 * z5881 - z5537 * z5884 + z5538 * z5882 + z5540
        * z5886;
    const Scalar z5889 = l_lambda_rear_rolls_x * z4294 - z4599 + l_lambda_rear_rolls_y * z4295 - z5542 * z5881 - z5544
        * z5884 + z5545 * z5882 + z5547 * z5886;
    const Scalar z5893 = z5887 - z5890;
    const Scalar z5894 = z5888 + z5891;
    const Scalar z5895 = z5889 - z5892;
    const Scalar z5898 = z5732 * z5896;
    const Scalar z5901 = z5731 + z5732 * z5898;
    const Scalar z5900 = z5729 + z5730 * z5898;
    const Scalar z5906 = z5781 + z5784 * z5898;
    const Scalar z5911 = z5782 - z5785 * z5898;
    const Scalar z5902 = n1 / z5901;
    const Scalar z5916 = z5875 - z5878 * z5898;
    const Scalar z5921 = z5783 - z5786 * z5898;
    const Scalar z5926 = z5876 + z5879 * z5898;
    const Scalar z5931 = z5877 - z5880 * z5898;
    const Scalar z5897 = z5730 * z5896;
    const Scalar z5899 = z5728 - z5730 * z5897;
    const Scalar z5903 = z5900 * z5902;
    const Scalar z5904 = z5899 + z5900 * z5903;
    const Scalar z5907 = z5778 + z5784 * z5897 - z5903 * z5906;
    const Scalar z5912 = z5779 - z5785 * z5897 - z5903 * z5911;
    const Scalar z5917 = z5872 - z5878 * z5897 - z5903 * z5916;
    const Scalar z5922 = z5780 - z5786 * z5897 - z5903 * z5921;
    const Scalar z5927 = z5873 + z5879 * z5897 - z5903 * z5926;
    const Scalar z5932 = z5874 - z5880 * z5897 - z5903 * z5931;
    const Scalar z5905 = n1 / z5904;
    const Scalar z5908 = z5905 * z5907;
    const Scalar z5913 = z5905 * z5912;
    const Scalar z5918 = z5905 * z5917;
    const Scalar z5923 = z5905 * z5922;
    const Scalar z5928 = z5905 * z5927;
    const Scalar z5933 = z5905 * z5932;
    const Scalar z5909 = z5902 * z5906 + z5903 * z5908;
    const Scalar z5914 = z5902 * z5911 + z5903 * z5913;
    const Scalar z5919 = z5902 * z5916 + z5903 * z5918;
    const Scalar z5924 = z5902 * z5921 + z5903 * z5923;
    const Scalar z5929 = z5902 * z5926 + z5903 * z5928;
    const Scalar z5934 = z5902 * z5931 + z5903 * z5933;
    const Scalar z5910 = z5784 * z5896 + z5897 * z5908 - z5898 * z5909;
    const Scalar z5915 = z5785 * z5896 - z5897 * z5913 + z5898 * z5914;
    const Scalar z5920 = z5878 * z5896 - z5897 * z5918 + z5898 * z5919;
    const Scalar z5925 = z5786 * z5896 - z5897 * z5923 + z5898 * z5924;
    const Scalar z5930 = z5879 * z5896 + z5897 * z5928 - z5898 * z5929;
    const Scalar z5935 = z5880 * z5896 - z5897 * z5933 + z5898 * z5934;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z4532;
    result.M[4] = -z4524;
    result.M[5] = z4510;
    result.M[6] = z4467;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z4533;
    result.M[13] = z4525;
    result.M[14] = -z4511;
    result.M[15] = z4468;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z4522;
    result.M[23] = z4508;
    result.M[24] = z4465;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z4532;
    result.M[28] = -z4533;
    result.M[29] = n0;
    result.M[30] = z4531;
    result.M[31] = z4523;
    result.M[32] = z4509;
    result.M[33] = -z4466;
    result.M[34] = z4501;
    result.M[35] = z4450;
    result.M[36] = -z4524;
    result.M[37] = z4525;
    result.M[38] = z4522;
    result.M[39] = z4523;
    result.M[40] = z4519;
    result.M[41] = z4505;
    result.M[42] = z4462;
    result.M[43] = n0;
    result.M[44] = z4448;
    result.M[45] = z4510;
    result.M[46] = -z4511;
    result.M[47] = z4508;
    result.M[48] = z4509;
    result.M[49] = z4505;
    result.M[50] = z4502;
    result.M[51] = -z4458;
    result.M[52] = n0_12;
    result.M[53] = z4446;
    result.M[54] = z4467;
    result.M[55] = z4468;
    result.M[56] = z4465;
    result.M[57] = -z4466;
    result.M[58] = z4462;
    result.M[59] = -z4458;
    result.M[60] = z587;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z4501;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z4450;
    result.M[76] = z4448;
    result.M[77] = z4446;
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
    result.C[27] = z4757;
    result.C[28] = z4756;
    result.C[29] = n0;
    result.C[30] = -z4758;
    result.C[31] = z4752;
    result.C[32] = -z4798;
    result.C[33] = z4851;
    result.C[34] = z4832;
    result.C[35] = z4913;
    result.C[36] = z4789;
    result.C[37] = -z4790;
    result.C[38] = z4787;
    result.C[39] = z4788;
    result.C[40] = z4768;
    result.C[41] = z4797;
    result.C[42] = -z4850;
    result.C[43] = z4831;
    result.C[44] = z4912;
    result.C[45] = -z4826;
    result.C[46] = z4827;
    result.C[47] = z4824;
    result.C[48] = -z4825;
    result.C[49] = -z4821;
    result.C[50] = -z4795;
    result.C[51] = z4846;
    result.C[52] = n0;
    result.C[53] = z4908;
    result.C[54] = z4899;
    result.C[55] = z4900;
    result.C[56] = -z4897;
    result.C[57] = -z4898;
    result.C[58] = -z4894;
    result.C[59] = -z4890;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z4903;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z4832;
    result.C[67] = z4828;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = z4913;
    result.C[76] = -z4909;
    result.C[77] = z4905;
    result.C[78] = z4914;
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
    result.K[27] = z4762;
    result.K[28] = -z4763;
    result.K[29] = n0;
    result.K[30] = z4920;
    result.K[31] = -z4922;
    result.K[32] = z4929;
    result.K[33] = -z4935;
    result.K[34] = z4936;
    result.K[35] = z4941;
    result.K[36] = z4779;
    result.K[37] = z4780;
    result.K[38] = z4777;
    result.K[39] = -z4951;
    result.K[40] = z4974;
    result.K[41] = -z4990;
    result.K[42] = z5010;
    result.K[43] = -z5012;
    result.K[44] = z5019;
    result.K[45] = z4812;
    result.K[46] = -z4813;
    result.K[47] = -z4810;
    result.K[48] = z5026;
    result.K[49] = z5033;
    result.K[50] = z5048;
    result.K[51] = -z5075;
    result.K[52] = n0;
    result.K[53] = -z5082;
    result.K[54] = -z4875;
    result.K[55] = -z4876;
    result.K[56] = -z4873;
    result.K[57] = z5089;
    result.K[58] = -z5096;
    result.K[59] = z5102;
    result.K[60] = z5119;
    result.K[61] = n0;
    result.K[62] = z5126;
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
    result.F[0] = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z4618;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z4619;
    result.F[2] = -l_lambda_rear_touches - l_lambda_front_touches + z4620;
    result.F[3] = l_lambda_rear_rolls_x * z4290 + l_lambda_rear_rolls_y * z4289 + l_lambda_front_rolls_x * z4314
        + l_lambda_front_rolls_y * z4313 - z5140;
    result.F[4] = -l_lambda_rear_rolls_x * z4292 + l_lambda_rear_touches * z4144 - l_lambda_rear_rolls_y * z4293
        - l_lambda_front_touches * z4227 - l_lambda_front_rolls_x * z4316 - l_lambda_front_rolls_y * z4317 - z5138;
    result.F[5] = l_lambda_rear_rolls_x * z4294 - z5133 + l_lambda_rear_rolls_y * z4295 + l_lambda_front_touches * z4238
        + l_lambda_front_rolls_x * z4318 + l_lambda_front_rolls_y * z4319;
    result.F[6] = l_lambda_front_touches * z4260 - z5141 + l_lambda_front_rolls_x * z4339 + l_lambda_front_rolls_y
        * z4341;
    result.F[7] = l_lambda_rear_rolls_x * z4294 - z4599 + l_lambda_rear_rolls_y * z4295;
    result.F[8] = l_lambda_front_rolls_x * z4346 - z4579 + l_lambda_front_rolls_y * z4348;
    result.M_r[0] = z5728;
    result.M_r[1] = -z5729;
    result.M_r[2] = -z5730;
    result.M_r[3] = -z5729;
    result.M_r[4] = -z5731;
    result.M_r[5] = -z5732;
    result.M_r[6] = -z5730;
    result.M_r[7] = -z5732;
    result.M_r[8] = z5733;
    result.C_r[0] = z5778;
    result.C_r[1] = z5781;
    result.C_r[2] = z5784;
    result.C_r[3] = z5779;
    result.C_r[4] = z5782;
    result.C_r[5] = -z5785;
    result.C_r[6] = z5780;
    result.C_r[7] = z5783;
    result.C_r[8] = -z5786;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z5872;
    result.K_r[7] = z5875;
    result.K_r[8] = -z5878;
    result.K_r[9] = z5873;
    result.K_r[10] = z5876;
    result.K_r[11] = z5879;
    result.K_r[12] = z5874;
    result.K_r[13] = z5877;
    result.K_r[14] = -z5880;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = -z5893;
    result.F_r[1] = z5894;
    result.F_r[2] = z5895;
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
    result.A[20] = z5556;
    result.A[21] = -z5559;
    result.A[22] = -z5558;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z5561;
    result.A[27] = -z5918;
    result.A[28] = z5919;
    result.A[29] = z5920;
    result.A[30] = -z5567;
    result.A[31] = z5570;
    result.A[32] = z5569;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z5572;
    result.A[37] = -z5928;
    result.A[38] = z5929;
    result.A[39] = -z5930;
    result.A[40] = z5578;
    result.A[41] = -z5581;
    result.A[42] = -z5580;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z5583;
    result.A[47] = -z5933;
    result.A[48] = z5934;
    result.A[49] = z5935;
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
    result.A[70] = z5525;
    result.A[71] = -z5528;
    result.A[72] = -z5527;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z5908;
    result.A[78] = z5909;
    result.A[79] = -z5910;
    result.A[80] = z5535;
    result.A[81] = -z5538;
    result.A[82] = -z5537;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z5540;
    result.A[87] = -z5913;
    result.A[88] = z5914;
    result.A[89] = z5915;
    result.A[90] = -z5542;
    result.A[91] = -z5545;
    result.A[92] = -z5544;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z5547;
    result.A[97] = -z5923;
    result.A[98] = z5924;
    result.A[99] = z5925;
    if (!(traits::regular(z5506, z5508) && traits::regular(z5509, z5511) && traits::regular(z5512, z5514)
        && traits::regular(z5515, z5517) && traits::regular(z5904, z5728) && traits::regular(-z5901, -z5731)
        && traits::regular(z5733, z5733))) return torsor::Status::singular;
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
