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
//   forward_dynamics       1093             1466         26             2                  4       0   2595    2779
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
  static constexpr unsigned long long fingerprint = 0xac43502690cd9728ULL;
  static constexpr int coordinate_count = 9;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;

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
  static constexpr int first_integral_count = 1;

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
  /// positive relative to its diagonal entry.
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
    const Scalar z887 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z888 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z889 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z905 = -z888 * (n1 - c_steer);
    const Scalar z906 = z31 * s_steer;
    const Scalar z907 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z903 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z904 = z32 * s_steer;
    const Scalar z908 = s_yaw * c_roll;
    const Scalar z912 = n1 - s_roll * s_roll;
    const Scalar z909 = c_yaw * c_roll;
    const Scalar z921 = v_roll * s_roll;
    const Scalar z920 = v_yaw * c_yaw;
    const Scalar z919 = v_roll * c_roll;
    const Scalar z924 = v_yaw * s_yaw;
    const Scalar z931 = s_yaw * s_roll;
    const Scalar z927 = n2 * s_roll;
    const Scalar z933 = c_yaw * s_roll;
    const Scalar z910 = s_roll * z908;
    const Scalar z911 = s_roll * z909;
    const Scalar z922 = s_yaw * z921 - c_roll * z920;
    const Scalar z925 = c_yaw * z921 + c_roll * z924;
    const Scalar z928 = z919 * z927;
    const Scalar z932 = s_roll * z931 - c_roll * z908;
    const Scalar z934 = s_roll * z933 - c_roll * z909;
    const Scalar z935 = c_roll * z927;
    const Scalar z939 = v_roll * z919;
    const Scalar z940 = v_yaw * z924;
    const Scalar z941 = n2 * z921;
    const Scalar z943 = v_roll * z921;
    const Scalar z944 = n2 * z919;
    const Scalar z946 = v_yaw * z920;
    const Scalar z954 = n0_08 * z904 - n0_35 * z906;
    const Scalar z967 = s_pitch * z906 - c_pitch * z904;
    const Scalar z968 = s_pitch * z904 + c_pitch * z906;
    const Scalar z913 = z912 * z912 + z910 * z910 + z911 * z911;
    const Scalar z942 = s_yaw * z939 + c_roll * z940 + z920 * z941;
    const Scalar z947 = c_yaw * z939 + c_roll * z946 - z924 * z941;
    const Scalar z949 = n2 * (s_roll * z943 - z919 * z919);
    const Scalar z953 = n0_08 * z903 - n0_35 * z905;
    const Scalar z955 = n0_08 * z905 - n0_35 * z907;
    const Scalar z923 = s_roll * z922 - z908 * z919;
    const Scalar z926 = s_roll * z925 - z909 * z919;
    const Scalar z936 = n2 * (z912 * z935 + z910 * z932 + z911 * z934);
    const Scalar z969 = s_roll * z968 - c_roll * c_steer;
    const Scalar z970 = s_roll * c_steer + c_roll * z968;
    const Scalar z957 = n0_3 + z955;
    const Scalar z956 = n1_1 - z953;
    const Scalar z914 = traits::sqrt(z913);
    const Scalar z929 = n2 * (z912 * z928 + z910 * z923 + z911 * z926);
    const Scalar z945 = z908 * z943 + z922 * z944 + s_roll * z942;
    const Scalar z948 = z909 * z943 + z925 * z944 + s_roll * z947;
    const Scalar z971 = c_yaw * z967 + s_yaw * z969;
    const Scalar z950 = n2 * (z910 * z945 + z911 * z948 - z912 * z949 - z923 * z923 - z926 * z926 - z928 * z928);
    const Scalar z973 = z970 * z971;
    const Scalar z972 = s_yaw * z967 - c_yaw * z969;
    const Scalar z974 = z970 * z972;
    const Scalar z959 = s_pitch * z956 - c_pitch * z957;
    const Scalar z960 = s_roll * z959 - c_roll * z954;
    const Scalar z958 = s_pitch * z957 + c_pitch * z956;
    const Scalar z937 = n0_5 * z936 / z914;
    const Scalar z961 = s_roll * z954 + c_roll * z959;
    const Scalar z964 = q_z - z961;
    const Scalar z915 = n0_3 / z914;
    const Scalar z975 = n1 - z970 * z970;
    const Scalar z962 = s_yaw * z960 - c_yaw * z958;
    const Scalar z963 = s_yaw * z958 + c_yaw * z960;
    const Scalar z930 = n0_5 * z929 / z914;
    const Scalar z965 = q_y + z963;
    const Scalar z966 = q_x - z962;
    const Scalar z916 = q_x + z910 * z915;
    const Scalar z976 = z975 * z975 + z973 * z973 + z974 * z974;
    const Scalar z951 = n0_5 * (z929 * z930 / (z914 * z914) + z950 / z914);
    const Scalar z938 = n0_3 * z937;
    const Scalar z918 = q_z + z912 * z915;
    const Scalar z917 = q_y - z911 * z915;
    const Scalar z977 = traits::sqrt(z976);
    const Scalar z1011 = c_yaw * z970;
    const Scalar z1005 = n2 * z970;
    const Scalar z986 = v_pitch * c_pitch;
    const Scalar z991 = v_pitch * s_pitch;
    const Scalar z982 = v_steer * c_steer;
    const Scalar z987 = v_steer * s_steer;
    const Scalar z1009 = s_yaw * z970;
    const Scalar z1010 = z969 * z971 - z970 * z1009;
    const Scalar z983 = z32 * z982;
    const Scalar z984 = z31 * z982;
    const Scalar z997 = z904 * z986 - z906 * z991 + s_pitch * z983 + c_pitch * z984;
    const Scalar z1000 = z904 * z991 + z906 * z986 + s_pitch * z984 - c_pitch * z983;
    const Scalar z989 = z888 * z987;
    const Scalar z988 = -z987 * (n1 - z887);
    const Scalar z990 = n0_35 * z989 + n0_08 * z988;
    const Scalar z952 = n0_3 * z951;
    const Scalar z1012 = z970 * z1011 + z969 * z972;
    const Scalar z978 = n0_35 / z977;
    const Scalar z1028 = z32 * c_steer;
    const Scalar z1029 = z31 * c_steer;
    const Scalar z1019 = s_roll * z967;
    const Scalar z1038 = s_pitch * z1028 + c_pitch * z1029;
    const Scalar z1020 = s_yaw * z1019 - c_yaw * z968;
    const Scalar z1022 = s_yaw * z968 + c_yaw * z1019;
    const Scalar z1018 = c_roll * z967;
    const Scalar z1023 = z970 * z1022 - z972 * z1018;
    const Scalar z1013 = z969 * z1005;
    const Scalar z1014 = n2 * (z974 * z1012 - z975 * z1013 + z973 * z1010);
    const Scalar z1021 = z970 * z1020 + z971 * z1018;
    const Scalar z1024 = z1005 * z1018;
    const Scalar z979 = z966 - z973 * z978;
    const Scalar z981 = z964 + z975 * z978;
    const Scalar z1025 = n2 * (z973 * z1021 - z974 * z1023 - z975 * z1024);
    const Scalar z980 = z965 - z974 * z978;
    const Scalar z1015 = n0_5 * z1014 / z977;
    const Scalar z1041 = s_pitch * z1029 - c_pitch * z1028;
    const Scalar z1030 = n0_08 * z1028 - n0_35 * z1029;
    const Scalar z1040 = c_roll * s_steer + s_roll * z1038;
    const Scalar z1039 = s_roll * s_steer - c_roll * z1038;
    const Scalar z1042 = c_yaw * z1041 + s_yaw * z1040;
    const Scalar z1044 = s_yaw * z1041 - c_yaw * z1040;
    const Scalar z1043 = z970 * z1042 - z971 * z1039;
    const Scalar z1026 = n0_5 * z1025 / z977;
    const Scalar z1032 = s_steer * z888;
    const Scalar z1031 = s_steer * (n1 - z887);
    const Scalar z1033 = n0_08 * z1031 - n0_35 * z1032;
    const Scalar z1034 = s_steer * (n1 - z889);
    const Scalar z1035 = n0_08 * z1032 - n0_35 * z1034;
    const Scalar z1016 = z960 - n0_35 * z1015;
    const Scalar z999 = c_roll * z987 + c_steer * z921 + z919 * z968 + s_roll * z997;
    const Scalar z1036 = c_pitch * z1035 + s_pitch * z1033;
    const Scalar z1003 = z920 * z967 + z924 * z969 + s_yaw * z1000 - c_yaw * z999;
    const Scalar z1037 = s_roll * z1030 + c_roll * z1036;
    const Scalar z998 = s_roll * z987 - c_steer * z919 + z921 * z968 - c_roll * z997;
    const Scalar z1001 = z920 * z969 - z924 * z967 + c_yaw * z1000 + s_yaw * z999;
    const Scalar z1006 = z998 * z1005;
    const Scalar z1004 = z970 * z1003 - z972 * z998;
    const Scalar z992 = -z987 * (n1 - z889);
    const Scalar z993 = n0_08 * z989 + n0_35 * z992;
    const Scalar z1017 = c_roll * z958;
    const Scalar z1027 = z1017 + n0_35 * z1026;
    const Scalar z1002 = z970 * z1001 - z971 * z998;
    const Scalar z985 = n0_08 * z983 - n0_35 * z984;
    const Scalar z1046 = z1005 * z1039;
    const Scalar z1045 = z970 * z1044 - z972 * z1039;
    const Scalar z1047 = n2 * (z975 * z1046 + z973 * z1043 + z974 * z1045);
    const Scalar z1050 = v_steer * z987;
    const Scalar z1051 = z32 * z1050;
    const Scalar z1052 = z31 * z1050;
    const Scalar z1007 = n2 * (z975 * z1006 + z974 * z1004 + z973 * z1002);
    const Scalar z994 = s_pitch * z990 - c_pitch * z993 - z956 * z986 - z957 * z991;
    const Scalar z1054 = v_steer * z982;
    const Scalar z1008 = n0_5 * z1007 / z977;
    const Scalar z1048 = n0_5 * z1047 / z977;
    const Scalar z995 = z919 * z954 + s_roll * z985 - z921 * z959 - c_roll * z994;
    const Scalar z996 = v_z - z995;
    const Scalar z1084 = n0_3 * z930 / (z914 * z914);
    const Scalar z1087 = v_z - z915 * z928 + z912 * z1084;
    const Scalar z1085 = v_y + z915 * z926 - z911 * z1084;
    const Scalar z1092 = v_x - z915 * z923 + z910 * z1084;
    const Scalar z1079 = q_z - z918;
    const Scalar z1077 = q_x - z916;
    const Scalar z1078 = q_y - z917;
    const Scalar z1088 = v_z - z1087;
    const Scalar z1086 = v_y - z1085;
    const Scalar z1093 = v_x - z1092;
    const Scalar z1105 = s_pitch * z31 - c_pitch * z32;
    const Scalar z1049 = z1037 - n0_35 * z1048;
    const Scalar z1111 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1112 = s_roll * z1111;
    const Scalar z1110 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z1106 = s_roll * z1105;
    const Scalar z1104 = s_pitch * z32 + c_pitch * z31;
    const Scalar z1097 = q_x - z979;
    const Scalar z1107 = c_roll * z1105;
    const Scalar z1099 = q_z - z981;
    const Scalar z1108 = s_yaw * z1106 - c_yaw * z1104;
    const Scalar z1101 = c_yaw * z1099;
    const Scalar z1103 = s_roll * z1097 + z908 * z1099;
    const Scalar z1098 = q_y - z980;
    const Scalar z1109 = s_yaw * z1104 + c_yaw * z1106;
    const Scalar z1100 = s_yaw * z1099;
    const Scalar z1102 = s_roll * z1098 - z909 * z1099;
    const Scalar z1081 = c_yaw * z1079;
    const Scalar z1080 = s_yaw * z1079;
    const Scalar z1060 = v_pitch * z991;
    const Scalar z1061 = v_pitch * z986;
    const Scalar z1064 = z904 * z1060 + z906 * z1061 + s_pitch * z1051 + c_pitch * z1052 - n2 * (z983 * z986 - z984
        * z991);
    const Scalar z1066 = z906 * z1060 - z904 * z1061 + s_pitch * z1052 - c_pitch * z1051 - n2 * (z983 * z991 + z984
        * z986);
    const Scalar z1053 = n0_08 * z1051 - n0_35 * z1052;
    const Scalar z1114 = s_yaw * z1112 - c_yaw * z1110;
    const Scalar z1113 = c_roll * z1111;
    const Scalar z1083 = s_roll * z1077 + z908 * z1079;
    const Scalar z1069 = n2 * z998;
    const Scalar z1082 = s_roll * z1078 - z909 * z1079;
    const Scalar z1065 = z943 * z968 - c_roll * z1054 - c_steer * z939 - n2 * (z919 * z997 - z921 * z987) + s_roll
        * z1064;
    const Scalar z1068 = s_roll * z1054 + c_steer * z943 + z939 * z968 + n2 * (z919 * z987 + z921 * z997) + c_roll
        * z1064;
    const Scalar z1071 = z940 * z967 - z946 * z969 - n2 * (z920 * z1000 + z924 * z999) + s_yaw * z1066 - c_yaw * z1065;
    const Scalar z1067 = z946 * z967 + z940 * z969 - n2 * (z920 * z999 - z924 * z1000) + c_yaw * z1066 + s_yaw * z1065;
    const Scalar z1072 = z1003 * z1069 + z972 * z1068 + z970 * z1071;
    const Scalar z1070 = z1001 * z1069 + z971 * z1068 + z970 * z1067;
    const Scalar z1073 = n2 * (z970 * z1068 - z998 * z998);
    const Scalar z1074 = n2 * (z974 * z1072 - z1006 * z1006 - z1004 * z1004 - z1002 * z1002 - z975 * z1073 + z973
        * z1070);
    const Scalar z1056 = z888 * z1054;
    const Scalar z1055 = -z1054 * (n1 - z887);
    const Scalar z1116 = q_z - z1113;
    const Scalar z1057 = n0_35 * z1056 + n0_08 * z1055;
    const Scalar z1058 = -z1054 * (n1 - z889);
    const Scalar z1059 = n0_08 * z1056 + n0_35 * z1058;
    const Scalar z1118 = q_x - z1114;
    const Scalar z1119 = z979 - z1118;
    const Scalar z1121 = z981 - z1116;
    const Scalar z1115 = s_yaw * z1110 + c_yaw * z1112;
    const Scalar z1062 = s_pitch * z1057 - z957 * z1061 - c_pitch * z1059 + z956 * z1060 + n2 * (z986 * z990 + z991
        * z993);
    const Scalar z1117 = q_y + z1115;
    const Scalar z1075 = n0_5 * (z1007 * z1008 / (z977 * z977) + z1074 / z977);
    const Scalar z1120 = z980 - z1117;
    const Scalar z1122 = z1107 * z1120 + z1109 * z1121;
    const Scalar z1089 = z920 * z1079 + s_yaw * z1088;
    const Scalar z1094 = c_yaw * z1088 - z924 * z1079;
    const Scalar z1090 = z919 * z1078 + z925 * z1079 + s_roll * z1086 - z909 * z1088;
    const Scalar z1063 = z943 * z954 + s_roll * z1053 + z939 * z959 - n2 * (z919 * z985 + z921 * z994) + c_roll * z1062;
    const Scalar z1130 = c_roll * z985 - z921 * z954 - z919 * z959 + s_roll * z994;
    const Scalar z1129 = s_pitch * z993 + c_pitch * z990 + z956 * z991 - z957 * z986;
    const Scalar z1091 = v_yaw * z1086 - v_roll * z1089 + z1090 * (v_pitch + v_rear);
    const Scalar z1124 = z966 - z979;
    const Scalar z1126 = z964 - z981;
    const Scalar z1125 = z965 - z980;
    const Scalar z1133 = n0_35 * z1008 / (z977 * z977);
    const Scalar z1095 = z919 * z1077 - z922 * z1079 + s_roll * z1093 + z908 * z1088;
    const Scalar z1096 = v_yaw * z1093 - v_roll * z1094 + z1095 * (v_pitch + v_rear);
    const Scalar z1076 = z1063 - n0_35 * z1075;
    const Scalar z1136 = z975 * z1133 - z996 - z978 * z1006;
    const Scalar z1156 = z996 + z1136;
    const Scalar z1123 = z1107 * z1119 - z1108 * z1121;
    const Scalar z1128 = z970 * z1124 - z971 * z1126;
    const Scalar z1127 = z970 * z1125 - z972 * z1126;
    const Scalar z1173 = v_yaw * s_roll;
    const Scalar z1174 = v_yaw * c_roll;
    const Scalar z1185 = v_pitch + z1173;  // angular velocity of frame, y
    const Scalar z1178 = v_roll * z1173;  // angular acceleration of frame.2, z
    const Scalar z1179 = v_roll * c_pitch - s_pitch * z1174;
    const Scalar z1180 = v_roll * s_pitch + c_pitch * z1174;
    const Scalar z1181 = s_pitch * z1178;
    const Scalar z1182 = c_pitch * z1178;
    const Scalar z1176 = n9_81 * c_roll;
    const Scalar z1186 = v_pitch * z1180 - z1181;  // angular acceleration of frame, x
    const Scalar z1187 = v_pitch * z1179 - z1182;  // angular acceleration of frame, z
    const Scalar z1177 = v_roll * z1174;  // angular acceleration of frame.2, y
    const Scalar z1189 = z1185 * z1185;
    const Scalar z1190 = z1180 * z1180;
    const Scalar z1183 = s_pitch * z1176;
    const Scalar z1184 = c_pitch * z1176;
    const Scalar z1175 = n9_81 * s_roll;
    const Scalar z1188 = v_rear + z1185;  // angular velocity of rear_wheel, y
    const Scalar z1142 = n0_3 * z986 - n1_1 * z991;
    const Scalar z1159 = s_yaw * z1130 - c_yaw * z1129 - z920 * z960 - z924 * z958;
    const Scalar z1131 = s_yaw * z1129 - z920 * z958 + z924 * z960 + c_yaw * z1130;
    const Scalar z1160 = v_x + z1159;
    const Scalar z1161 = z1160 - z978 * z1002 + z973 * z1133;
    const Scalar z1132 = v_y - z1131;
    const Scalar z1134 = z1132 - z978 * z1004 + z974 * z1133;
    const Scalar z1191 = z1189 + z1190;
    const Scalar z1192 = z1179 * z1180;
    const Scalar z1194 = z1179 * z1185;
    const Scalar z1193 = z1177 + z1192;
    const Scalar z1148 = z31 * z991 - z32 * z986;
    const Scalar z1170 = z1160 - z1161;
    const Scalar z1140 = z31 * z986 + z32 * z991;
    const Scalar z1143 = n1_1 * z986 + n0_3 * z991;
    const Scalar z1171 = z970 * z1170 - z998 * z1124 - z1001 * z1126 - z971 * z1156;
    const Scalar z1155 = z1132 - z1134;
    const Scalar z1157 = z970 * z1155 - z998 * z1125 - z1003 * z1126 - z972 * z1156;
    const Scalar z1144 = z919 * z1111 + s_roll * z1143;
    const Scalar z1151 = c_roll * z1143 - z921 * z1111;
    const Scalar z1141 = c_roll * z1140 - z921 * z1105;
    const Scalar z1149 = z919 * z1105 + s_roll * z1140;
    const Scalar z1152 = v_z - z1151;
    const Scalar z1153 = z1136 + z1152;
    const Scalar z1137 = v_z + z1136;
    const Scalar z1165 = z924 * z1110 - c_yaw * z1142 + z920 * z1112 + s_yaw * z1144;
    const Scalar z1145 = z920 * z1110 + s_yaw * z1142 - z924 * z1112 + c_yaw * z1144;
    const Scalar z1166 = v_x - z1165;
    const Scalar z1167 = z1161 - z1166;
    const Scalar z1162 = v_x - z1161;
    const Scalar z1164 = z919 * z1097 - z922 * z1099 + s_roll * z1162 + z908 * z1137;
    const Scalar z1146 = v_y + z1145;
    const Scalar z1147 = z1134 - z1146;
    const Scalar z1135 = v_y - z1134;
    const Scalar z1139 = z919 * z1098 + z925 * z1099 + s_roll * z1135 - z909 * z1137;
    const Scalar z1195 = z1187 + z1194;
    const Scalar z1196 = z1180 * z1185;
    const Scalar z1197 = z1186 + z1196;
    const Scalar z1168 = z924 * z1104 + c_yaw * z1148 + z920 * z1106 + s_yaw * z1149;
    const Scalar z1150 = s_yaw * z1148 - z920 * z1104 + z924 * z1106 - c_yaw * z1149;
    const Scalar z1169 = z1119 * z1141 - z1121 * z1168 + z1107 * z1167 + z1108 * z1153;
    const Scalar z1154 = z1120 * z1141 - z1121 * z1150 + z1107 * z1147 - z1109 * z1153;
    const Scalar z1138 = z920 * z1099 + s_yaw * z1137;
    const Scalar z1163 = c_yaw * z1137 - z924 * z1099;
    const Scalar z1172 = v_yaw * z1162 + v_pitch * z1164 + v_steer * z1169 - v_roll * z1163 + v_front * z1171;
    const Scalar z1158 = v_yaw * z1135 - v_roll * z1138 + v_pitch * z1139 + v_steer * z1154 + v_front * z1157;
    const Scalar z1203 = z906 * z1185 + z905 * z1179 - z907 * z1180;
    const Scalar z1198 = z1177 - z1192;
    const Scalar z1216 = z32 * v_steer;
    const Scalar z1199 = z1179 * z1179;
    const Scalar z1200 = z1189 + z1199;
    const Scalar z1257 = z1190 - z1199;
    const Scalar z1201 = z904 * z1185 - z905 * z1180 + z903 * z1179;
    const Scalar z1202 = c_steer * z1185 - z904 * z1179 + z906 * z1180;
    const Scalar z1253 = z1179 * z1188;
    const Scalar z1252 = z1180 * z1188;
    const Scalar z1256 = n0_12 * z1253;  // moment on rear_wheel, z
    const Scalar z1254 = n0_12 * z1252;  // moment on rear_wheel, x
    const Scalar z1214 = z31 * v_steer;
    const Scalar z1217 = z1203 - z1216;  // angular velocity of fork, z
    const Scalar z1213 = z31 * z1203 + z32 * z1201;
    const Scalar z1215 = z1201 + z1214;  // angular velocity of fork, x
    const Scalar z1205 = c_steer * z1177 + z904 * z1186 + z906 * z1187;
    const Scalar z1219 = v_steer * z1213 - z1205;  // angular acceleration of fork, y
    const Scalar z1207 = z1183 - n1_1 * z1191 + n0_3 * z1193;
    const Scalar z1221 = z1202 * z1202;
    const Scalar z1222 = z1217 * z1217;
    const Scalar z1208 = z1175 - n1_1 * z1195 - n0_3 * z1197;
    const Scalar z1209 = z1184 + n1_1 * z1198 + n0_3 * z1200;
    const Scalar z1223 = z1221 + z1222;
    const Scalar z1224 = z1215 * z1217;
    const Scalar z1206 = z905 * z1186 - z906 * z1177 + z907 * z1187;
    const Scalar z1204 = z903 * z1186 - z904 * z1177 + z905 * z1187;
    const Scalar z1220 = z1202 * z1214 - z1206;  // angular acceleration of fork, z
    const Scalar z1218 = z1202 * z1216 - z1204;  // angular acceleration of fork, x
    const Scalar z1268 = z1173 * z1174;
    const Scalar z1269 = n2 * z1178;
    const Scalar z1225 = z1219 + z1224;
    const Scalar z1230 = z1219 - z1224;
    const Scalar z1231 = z1215 * z1215;
    const Scalar z1232 = z1221 + z1231;
    const Scalar z1239 = z1222 - z1231;
    const Scalar z1233 = v_front + z1202;  // angular velocity of front_wheel, y
    const Scalar z1210 = z903 * z1207 - z904 * z1208 + z905 * z1209;
    const Scalar z1240 = n1_04 * z1223 + n3_85 * z1225 + n7 * z1210;  // force on fork, x
    const Scalar z1211 = z904 * z1207 + z906 * z1209 + c_steer * z1208;
    const Scalar z1212 = z905 * z1207 - z906 * z1208 + z907 * z1209;
    const Scalar z1242 = n1_04 * z1230 - n3_85 * z1232 + n7 * z1212;  // force on fork, z
    const Scalar z1285 = z449 * z904;
    const Scalar z1280 = n0_28 * c_steer;
    const Scalar z1281 = n0_28 * z906;
    const Scalar z1279 = n0_28 * z904;
    const Scalar z1282 = s_pitch * z1281 - c_pitch * z1279;
    const Scalar z1283 = s_pitch * z1279 + c_pitch * z1281;
    const Scalar z1226 = z1202 * z1215;
    const Scalar z1235 = z1215 * z1233;
    const Scalar z1228 = z1202 * z1217;
    const Scalar z1234 = z1217 * z1233;
    const Scalar z1238 = n0_28 * z1235;  // moment on front_wheel, z
    const Scalar z1236 = n0_28 * z1234;  // moment on front_wheel, x
    const Scalar z1286 = c_steer * z449;
    const Scalar z1227 = z1220 - z1226;
    const Scalar z1284 = s_roll * z1280 + c_roll * z1283;
    const Scalar z1243 = n3_85 * z1211 - z1236 - k17 * z1228 - k3 * z1218 - k4 * z1227;  // moment on fork, x
    const Scalar z1229 = z1218 + z1228;
    const Scalar z1245 = k18 * z1226 + z1238 - k5 * z1220 - k4 * z1229 + n1_04 * z1211;  // moment on fork, z
    const Scalar z1241 = n7 * z1211 - n1_04 * z1227 - n3_85 * z1229;  // force on fork, y
    const Scalar z1289 = z450 * z904 + z451 * z906;
    const Scalar z1287 = z449 * z906;
    const Scalar z1292 = n0_3 * z1285 - z1289 + n1_1 * z1287;
    const Scalar z1290 = z450 * z905 + z451 * z907;
    const Scalar z1293 = n1_1 * z1286 - z1290;
    const Scalar z1288 = z451 * z905 + z450 * z903;
    const Scalar z1291 = n0_3 * z1286 - z1288;
    const Scalar z1295 = s_pitch * z1285 + c_pitch * z1287;
    const Scalar z1294 = s_pitch * z1287 - c_pitch * z1285;
    const Scalar z1296 = s_pitch * z1293 - c_pitch * z1291;
    const Scalar z1237 = n0_28 * z1219;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z1244 = z1237 + k19 * z1224 + k4 * z1239 + n2_5667 * z1219 + n3_85 * z1210 + n1_04 * z1212;
    const Scalar z1297 = s_pitch * z1291 + c_pitch * z1293;
    const Scalar z1300 = s_roll * z1292 - c_roll * z1297;
    const Scalar z1305 = n1_04 * z905 - n3_85 * z907;
    const Scalar z1303 = n1_04 * z903 - n3_85 * z905;
    const Scalar z1304 = n1_04 * z904 - n3_85 * z906;
    const Scalar z1299 = s_roll * z1286 + c_roll * z1295;
    const Scalar z1298 = s_roll * z1295 - c_roll * z1286;
    const Scalar z1302 = s_yaw * z1294 - c_yaw * z1298;
    const Scalar z1301 = c_yaw * z1294 + s_yaw * z1298;
    const Scalar z1255 = n0_12 * z1177;  // moment on rear_wheel, y
    const Scalar z1246 = z903 * z1240 + z905 * z1242 + z904 * z1241;
    const Scalar z1258 = n25_5 * z1191 - z1246 + n51 * z1193;  // force on frame, x
    const Scalar z1306 = k4 * z905;
    const Scalar z1248 = z905 * z1240 + z907 * z1242 + z906 * z1241;
    const Scalar z1247 = c_steer * z1241 - z904 * z1240 - z906 * z1242;
    const Scalar z1260 = z1248 + n25_5 * z1198 - n51 * z1200;  // force on frame, z
    const Scalar z1308 = n2_8467 * z904;
    const Scalar z1307 = k3 * z903 + z1306;
    const Scalar z1251 = z907 * z1245 + z905 * z1243 - z906 * z1244;
    // moment on frame, z
    const Scalar z1263 = n25_5 * z1175 - z1256 - n9_95 * z1195 + n17_7 * z1197 + n1_1 * z1247 - z1251;
    const Scalar z1265 = s_pitch * z1258 - c_pitch * z1260;
    const Scalar z1264 = s_pitch * z1260 + c_pitch * z1258;
    const Scalar z1259 = n25_5 * z1195 - z1247 - n51 * z1197;  // force on frame, y
    const Scalar z1249 = z905 * z1245 + z903 * z1243 - z904 * z1244;
    // moment on frame, x
    const Scalar z1261 = n51 * z1175 + z1254 - n17_7 * z1195 + n39_3 * z1197 - n0_3 * z1247 + z1249;
    const Scalar z1250 = z906 * z1245 + z904 * z1243 + c_steer * z1244;
    // moment on frame, y
    const Scalar z1262 = z1255 + n49_25 * z1177 - n51 * z1183 + n25_5 * z1184 + n29_35 * z1192 + n17_7 * z1257 + n0_3
        * z1246 + n1_1 * z1248 - z1250;
    const Scalar z1278 = z31 * z1243 - z32 * z1245;
    const Scalar z1315 = k5 * z907 + z1306;
    const Scalar z1314 = n2_8467 * z906;
    const Scalar z1313 = k3 * z905 + k4 * z907;
    const Scalar z1321 = z906 * z1314 + z905 * z1313 + z907 * z1315;
    const Scalar z1311 = n2_8467 * c_steer;
    const Scalar z1309 = k5 * z905 + k4 * z903;
    const Scalar z1316 = z904 * z1308 + z903 * z1307 + z905 * z1309;
    const Scalar z1310 = k3 * z904 + k4 * z906;
    const Scalar z1322 = n0_63 + n0_6 * z1305 + z1316;
    const Scalar z1312 = k4 * z904 + k5 * z906;
    const Scalar z1319 = z904 * z1314 + z903 * z1313 + z905 * z1315;
    const Scalar z1320 = c_steer * z1314 - z904 * z1313 - z906 * z1315;
    const Scalar z1317 = z903 * z1310 - z904 * z1311 + z905 * z1312;
    const Scalar z1318 = c_steer * z1311 + z904 * z1310 + z906 * z1312;
    const Scalar z1325 = n2_31 + n1_1 * z1305 - n0_3 * z1303 + z1319;
    const Scalar z1324 = n9_1 + n0_6 * z1305 - n2_2 * z1303 + z1318;
    const Scalar z1323 = n1_1 * z1304 + z1317;
    const Scalar z1272 = s_roll * z1265 - c_roll * z1259;
    const Scalar z1273 = s_roll * z1259 + c_roll * z1265;
    const Scalar z1277 = n853_47 - z1273;  // force on frame.z, z
    const Scalar z1266 = s_pitch * z1263 + c_pitch * z1261;
    const Scalar z1267 = s_pitch * z1261 - c_pitch * z1263;
    const Scalar z1270 = z1266 - n0_5603 * z1268;  // moment on frame.2, x
    const Scalar z1271 = z1267 - n0_5603 * z1269;  // moment on frame.2, z
    const Scalar z1327 = n8_47 - n2_2 * z1303 + z1321;
    const Scalar z1333 = n17_7 - z1325;
    const Scalar z1332 = n49_25 + z1324;
    const Scalar z1326 = n0_3 * z1304 + z1320;
    const Scalar z1329 = n2_1 + z1305;
    const Scalar z1328 = n7_7 - z1303;
    const Scalar z1331 = n51 - z1329;
    const Scalar z1330 = n25_5 + z1328;
    const Scalar z1274 = s_roll * z1262 + c_roll * z1271;
    const Scalar z1334 = n29_35 - z1327;
    const Scalar z1275 = s_yaw * z1272 - c_yaw * z1264;
    const Scalar z1276 = s_yaw * z1264 + c_yaw * z1272;
    const Scalar z1346 = z1322 + z1334;
    const Scalar z1347 = n2 * z1333;
    const Scalar z1348 = s_pitch * z1346 - c_pitch * z1347;
    const Scalar z1379 = c_steer * z1280 - z1332;
    const Scalar z1336 = n0_12 + z1332;
    const Scalar z1370 = n25_over_7 * z1280;
    const Scalar z1385 = z601 * z1292;
    const Scalar z1354 = n39_8603 - z1336;
    const Scalar z1340 = s_pitch * z1323 - c_pitch * z1326;
    const Scalar z1339 = s_pitch * z1326 + c_pitch * z1323;
    const Scalar z1352 = c_pitch * z1348 + z1333;
    const Scalar z1349 = s_pitch * z1348;
    const Scalar z1343 = s_roll * z1336 - c_roll * z1340;
    const Scalar z1350 = z1334 - z1349;
    const Scalar z1351 = z1322 - z1349;
    const Scalar z1361 = n2 * z1340;
    const Scalar z1357 = s_roll * z1339 - c_roll * z1352;
    const Scalar z1360 = z1350 - z1354;
    const Scalar z1353 = n39_8603 + z1351;
    const Scalar z1375 = z1282 * z1370 - z1339;
    const Scalar z1362 = s_roll * z1360 - c_roll * z1361;
    const Scalar z1374 = z1284 * z1370 - z1343;
    const Scalar z1369 = n25_over_7 * z1282;
    const Scalar z1373 = z1282 * z1369 - z1353;
    const Scalar z1372 = z1284 * z1369 - z1357;
    const Scalar z1384 = z601 * z1296;
    const Scalar z1368 = n25_over_7 * z1284;
    const Scalar z1335 = n0_12 * s_roll;
    const Scalar z1378 = z1335 + z1374;
    const Scalar z1363 = s_roll * z1362;
    const Scalar z1376 = n25_over_3 * z1335;
    const Scalar z1383 = z601 * z1300;
    const Scalar z1337 = c_pitch * z1331 + s_pitch * z1330;
    const Scalar z1364 = z1350 - z1363;
    const Scalar z1338 = s_pitch * z1331 - c_pitch * z1330;
    const Scalar z1400 = z1296 * z1384 + z1373;
    const Scalar z1365 = n39_8603 - z1364;
    const Scalar z1399 = z1300 * z1384 - z1372;
    const Scalar z1342 = c_roll * z1338;
    const Scalar z1356 = s_roll * z1337 - c_roll * z1304;
    const Scalar z1371 = z1284 * z1368 - z1365;
    const Scalar z1355 = s_roll * z1304 + c_roll * z1337;
    const Scalar z1382 = z601 * z1299;
    const Scalar z1394 = z1299 * z1383;
    const Scalar z1377 = z1335 * z1376 + z1371;
    const Scalar z1398 = z1299 * z1384 - z1356;
    const Scalar z1391 = n94 - z1299 * z1382;
    const Scalar z1341 = s_roll * z1338;
    const Scalar z1403 = z1299 * z1385 + z1342;
    const Scalar z1395 = z1300 * z1383 + z1377;
    const Scalar z1345 = s_yaw * z1337 + c_yaw * z1341;
    const Scalar z1344 = s_yaw * z1341 - c_yaw * z1337;
    const Scalar z1406 = z1292 * z1385 + z1379;
    const Scalar z1405 = z1296 * z1385 - z1375;
    const Scalar z1404 = z1300 * z1385 + z1378;
    const Scalar z1407 = n1 / z1406;
    const Scalar z1402 = z1302 * z1385 - z1345;
    const Scalar z1401 = z1301 * z1385 + z1344;
    const Scalar z1359 = c_yaw * z1355;
    const Scalar z1397 = z1302 * z1384 - z1359;
    const Scalar z1358 = s_yaw * z1355;
    const Scalar z1396 = z1301 * z1384 + z1358;
    const Scalar z1367 = c_yaw * z1338 + s_yaw * z1356;
    const Scalar z1366 = s_yaw * z1338 - c_yaw * z1356;
    const Scalar z1393 = z1302 * z1383 - z1367;
    const Scalar z1392 = z1301 * z1383 + z1366;
    const Scalar z1381 = z601 * z1302;
    const Scalar z1412 = z1405 * z1407;
    const Scalar z1411 = z1404 * z1407;
    const Scalar z1410 = z1403 * z1407;
    const Scalar z1390 = z1302 * z1382;
    const Scalar z1388 = n94 - z1302 * z1381;
    const Scalar z1427 = z1400 - z1405 * z1412;
    const Scalar z1426 = z1399 - z1404 * z1412;
    const Scalar z1422 = z1395 - z1404 * z1411;
    const Scalar z1421 = z1394 - z1403 * z1411;
    const Scalar z1428 = n1 / z1427;
    const Scalar z1425 = z1398 - z1403 * z1412;
    const Scalar z1418 = z1391 + z1403 * z1410;
    const Scalar z1417 = z1390 - z1402 * z1410;
    const Scalar z1420 = z1393 - z1402 * z1411;
    const Scalar z1424 = z1397 - z1402 * z1412;
    const Scalar z1419 = z1392 - z1401 * z1411;
    const Scalar z1423 = z1396 - z1401 * z1412;
    const Scalar z1409 = z1402 * z1407;
    const Scalar z1415 = z1388 + z1402 * z1409;
    const Scalar z1380 = z601 * z1301;
    const Scalar z1387 = z1301 * z1381;
    const Scalar z1414 = z1387 - z1401 * z1409;
    const Scalar z1389 = z1301 * z1382;
    const Scalar z1386 = n94 - z1301 * z1380;
    const Scalar z1416 = z1389 - z1401 * z1410;
    const Scalar z1432 = z1426 * z1428;
    const Scalar z1431 = z1425 * z1428;
    const Scalar z1430 = z1424 * z1428;
    const Scalar z1408 = z1401 * z1407;
    const Scalar z1413 = z1386 + z1401 * z1408;
    const Scalar z1442 = z1422 - z1426 * z1432;
    const Scalar z1441 = z1421 - z1425 * z1432;
    const Scalar z1438 = z1418 + z1425 * z1431;
    const Scalar z1437 = z1417 - z1424 * z1431;
    const Scalar z1443 = n1 / z1442;
    const Scalar z1440 = z1420 - z1424 * z1432;
    const Scalar z1435 = z1415 + z1424 * z1430;
    const Scalar z1434 = z1414 - z1423 * z1430;
    const Scalar z1436 = z1416 - z1423 * z1431;
    const Scalar z1439 = z1419 - z1423 * z1432;
    const Scalar z1429 = z1423 * z1428;
    const Scalar z1433 = z1413 + z1423 * z1429;
    const Scalar z1491 = z1080 * z1432;
    const Scalar z1476 = z1027 + z1049 * z1385;
    const Scalar z1477 = z1016 + z1049 * z1384 - z1412 * z1476;
    const Scalar z1463 = z938 * z1432;
    const Scalar z1444 = z1439 * z1443;
    const Scalar z1504 = z1081 * z1432;
    const Scalar z1445 = z1440 * z1443;
    const Scalar z1446 = z1441 * z1443;
    const Scalar z1478 = z1049 * z1383 - z1411 * z1476 - z1432 * z1477;
    const Scalar z1452 = z1438 + z1441 * z1446;
    const Scalar z1451 = z1437 - z1440 * z1446;
    const Scalar z1449 = z1435 + z1440 * z1445;
    const Scalar z1448 = z1434 - z1439 * z1445;
    const Scalar z1453 = n1 / z1452;
    const Scalar z1450 = z1436 - z1439 * z1446;
    const Scalar z1447 = z1433 + z1439 * z1444;
    const Scalar z1505 = z1081 * z1431 - z1446 * z1504;
    const Scalar z1492 = z1080 * z1431 - z1446 * z1491;
    const Scalar z1479 = n1 + z1049 * z1382 - z1410 * z1476 - z1431 * z1477 - z1446 * z1478;
    const Scalar z1464 = n1 + z938 * z1431 - z1446 * z1463;
    const Scalar z1454 = z1450 * z1453;
    const Scalar z1455 = z1451 * z1453;
    const Scalar z1456 = z1447 - z1450 * z1454;
    const Scalar z1457 = z1448 + z1450 * z1455;
    const Scalar z1517 = z1102 + z1122 * z1385 - z1127 * z1370;
    const Scalar z1458 = z1449 - z1451 * z1455;
    const Scalar z1518 = z1100 + z1122 * z1384 + z1127 * z1369 - z1412 * z1517;
    const Scalar z1459 = n1 / z1458;
    const Scalar z1519 = z1098 + z1122 * z1383 - z1127 * z1368 - z1411 * z1517 - z1432 * z1518;
    const Scalar z1506 = n1 - z1081 * z1430 + z1445 * z1504 - z1455 * z1505;
    const Scalar z1493 = z1080 * z1430 - z1445 * z1491 + z1455 * z1492;
    const Scalar z1480 = z1049 * z1381 - z1409 * z1476 - z1430 * z1477 - z1445 * z1478 + z1455 * z1479;
    const Scalar z1460 = z1457 * z1459;
    const Scalar z1520 = z1122 * z1382 - z1410 * z1517 - z1431 * z1518 - z1446 * z1519;
    const Scalar z1461 = z1456 - z1457 * z1460;
    const Scalar z1462 = n1 / z1461;
    const Scalar z1521 = z1122 * z1381 - z1409 * z1517 - z1430 * z1518 - z1445 * z1519 + z1455 * z1520;
    const Scalar z1522 = n1 - z1122 * z1380 + z1408 * z1517 + z1429 * z1518 + z1444 * z1519 - z1454 * z1520 - z1460
        * z1521;
    const Scalar z1507 = z1081 * z1429 - z1444 * z1504 + z1454 * z1505 - z1460 * z1506;
    const Scalar z1523 = z1462 * z1522;
    const Scalar z1508 = z1462 * z1507;
    const Scalar z1494 = n1 + z1080 * z1429 - z1444 * z1491 + z1454 * z1492 + z1460 * z1493;
    const Scalar z1524 = z1459 * z1521 - z1460 * z1523;
    const Scalar z1509 = z1459 * z1506 - z1460 * z1508;
    const Scalar z1510 = z1453 * z1505 + z1454 * z1508 - z1455 * z1509;
    const Scalar z1495 = z1462 * z1494;
    const Scalar z1496 = z1459 * z1493 + z1460 * z1495;
    const Scalar z1511 = z1443 * z1504 + z1444 * z1508 - z1445 * z1509 + z1446 * z1510;
    const Scalar z1497 = z1453 * z1492 + z1454 * z1495 + z1455 * z1496;
    const Scalar z1512 = z1081 * z1428 - z1429 * z1508 + z1430 * z1509 - z1431 * z1510 + z1432 * z1511;
    const Scalar z1498 = z1443 * z1491 + z1444 * z1495 + z1445 * z1496 + z1446 * z1497;
    const Scalar z1513 = z1408 * z1508 - z1409 * z1509 + z1410 * z1510 - z1411 * z1511 + z1412 * z1512;
    const Scalar z1514 = z1380 * z1508 - z1381 * z1509 + z1382 * z1510 - z1383 * z1511 + z1384 * z1512 - z1385 * z1513;
    const Scalar z1515 = n25_over_3 * z1083 - z1513 - z1376 * z1511;
    const Scalar z1516 = z1368 * z1511 + z1369 * z1512 + z1370 * z1513;
    const Scalar z1481 = z1049 * z1380 - z1408 * z1476 - z1429 * z1477 - z1444 * z1478 + z1454 * z1479 + z1460 * z1480;
    const Scalar z1482 = z1462 * z1481;
    const Scalar z1499 = z1080 * z1428 - z1429 * z1495 - z1430 * z1496 - z1431 * z1497 + z1432 * z1498;
    const Scalar z1483 = z1459 * z1480 + z1460 * z1482;
    const Scalar z1500 = z1408 * z1495 + z1409 * z1496 + z1410 * z1497 - z1411 * z1498 + z1412 * z1499;
    const Scalar z1484 = z1453 * z1479 + z1454 * z1482 + z1455 * z1483;
    const Scalar z1485 = z1443 * z1478 + z1444 * z1482 + z1445 * z1483 + z1446 * z1484;
    const Scalar z1501 = z1380 * z1495 + z1381 * z1496 + z1382 * z1497 - z1383 * z1498 + z1384 * z1499 - z1385 * z1500;
    const Scalar z1486 = z1428 * z1477 + z1429 * z1482 + z1430 * z1483 + z1431 * z1484 - z1432 * z1485;
    const Scalar z1487 = z1407 * z1476 + z1408 * z1482 + z1409 * z1483 + z1410 * z1484 - z1411 * z1485 - z1412 * z1486;
    const Scalar z1465 = z938 * z1430 - z1445 * z1463 + z1455 * z1464;
    const Scalar z1525 = z1453 * z1520 - z1454 * z1523 + z1455 * z1524;
    const Scalar z1502 = n25_over_3 * z1082 - z1500 - z1376 * z1498;
    const Scalar z1503 = z1368 * z1498 + z1369 * z1499 + z1370 * z1500;
    const Scalar z1466 = z938 * z1429 - z1444 * z1463 + z1454 * z1464 + z1460 * z1465;
    const Scalar z1526 = z1443 * z1519 - z1444 * z1523 + z1445 * z1524 + z1446 * z1525;
    const Scalar z1467 = z1462 * z1466;
    const Scalar z1527 = z1428 * z1518 - z1429 * z1523 + z1430 * z1524 + z1431 * z1525 - z1432 * z1526;
    const Scalar z1468 = z1459 * z1465 + z1460 * z1467;
    const Scalar z1528 = z1407 * z1517 - z1408 * z1523 + z1409 * z1524 + z1410 * z1525 - z1411 * z1526 - z1412 * z1527;
    const Scalar z1469 = z1453 * z1464 + z1454 * z1467 + z1455 * z1468;
    const Scalar z1470 = z1443 * z1463 + z1444 * z1467 + z1445 * z1468 + z1446 * z1469;
    const Scalar z1529 = z601 * z1122 - z1380 * z1523 + z1381 * z1524 + z1382 * z1525 - z1383 * z1526 - z1384 * z1527
        - z1385 * z1528;
    const Scalar z1488 = z601 * z1049 + z1380 * z1482 + z1381 * z1483 + z1382 * z1484 - z1383 * z1485 - z1384 * z1486
        - z1385 * z1487;
    const Scalar z1489 = z1376 * z1485 + z1487;
    const Scalar z1490 = z1368 * z1485 - z1369 * z1486 + z1370 * z1487;
    const Scalar z1471 = z938 * z1428 - z1429 * z1467 - z1430 * z1468 - z1431 * z1469 + z1432 * z1470;
    const Scalar z1531 = n25_over_7 * z1127 + z1368 * z1526 - z1369 * z1527 + z1370 * z1528;
    const Scalar z1472 = z1408 * z1467 + z1409 * z1468 + z1410 * z1469 - z1411 * z1470 + z1412 * z1471;
    const Scalar z1532 = z1103 + z1123 * z1385 - z1128 * z1370;
    const Scalar z1473 = z1380 * z1467 + z1381 * z1468 + z1382 * z1469 - z1383 * z1470 + z1384 * z1471 - z1385 * z1472;
    const Scalar z1533 = z1101 + z1123 * z1384 + z1128 * z1369 - z1412 * z1532;
    const Scalar z1474 = z1376 * z1470 + z1472;
    const Scalar z1534 = z1097 + z1123 * z1383 - z1128 * z1368 - z1411 * z1532 - z1432 * z1533;
    const Scalar z1475 = z1368 * z1470 + z1369 * z1471 + z1370 * z1472;
    const Scalar z1535 = z1123 * z1382 - z1410 * z1532 - z1431 * z1533 - z1446 * z1534;
    const Scalar z1536 = n1 + z1123 * z1381 - z1409 * z1532 - z1430 * z1533 - z1445 * z1534 + z1455 * z1535;
    const Scalar z1537 = z1123 * z1380 - z1408 * z1532 - z1429 * z1533 - z1444 * z1534 + z1454 * z1535 + z1460 * z1536;
    const Scalar z1538 = z1462 * z1537;
    const Scalar z1566 = z1097 * z1526 - z1524 + z1101 * z1527 + z1103 * z1528 - z1123 * z1529 - z1128 * z1531;
    const Scalar z1539 = z1459 * z1536 + z1460 * z1538;
    const Scalar z1540 = z1453 * z1535 + z1454 * z1538 + z1455 * z1539;
    const Scalar z1561 = z1098 * z1526 - z1523 + z1100 * z1527 + z1102 * z1528 - z1122 * z1529 - z1127 * z1531;
    const Scalar z1541 = z1443 * z1534 + z1444 * z1538 + z1445 * z1539 + z1446 * z1540;
    const Scalar z1542 = z1428 * z1533 + z1429 * z1538 + z1430 * z1539 + z1431 * z1540 - z1432 * z1541;
    const Scalar z1543 = z1407 * z1532 + z1408 * z1538 + z1409 * z1539 + z1410 * z1540 - z1411 * z1541 - z1412 * z1542;
    const Scalar z1544 = z601 * z1123 + z1380 * z1538 + z1381 * z1539 + z1382 * z1540 - z1383 * z1541 - z1384 * z1542
        - z1385 * z1543;
    const Scalar z1546 = n25_over_7 * z1128 + z1368 * z1541 - z1369 * z1542 + z1370 * z1543;
    const Scalar z1567 = z1097 * z1541 - z1539 + z1101 * z1542 + z1103 * z1543 - z1123 * z1544 - z1128 * z1546;
    const Scalar z1568 = n1 / z1567;
    const Scalar z1560 = z1508 + z1098 * z1511 - z1100 * z1512 + z1102 * z1513 - z1122 * z1514 - z1127 * z1516;
    const Scalar z1565 = z1509 + z1097 * z1511 - z1101 * z1512 + z1103 * z1513 - z1123 * z1514 - z1128 * z1516;
    const Scalar z1556 = z1509 + z1077 * z1511 - z1081 * z1512 + z1083 * (z1513 + z1515);
    const Scalar z1573 = z1566 * z1568;
    const Scalar z1572 = z1565 * z1568;
    const Scalar z1555 = z1077 * z1498 - z1496 - z1081 * z1499 + z1083 * (z1500 + z1502);
    const Scalar z1588 = z1561 - z1566 * z1573;
    const Scalar z1587 = z1560 - z1565 * z1573;
    const Scalar z1583 = z1556 + z1565 * z1572;
    const Scalar z1589 = n1 / z1588;
    const Scalar z1559 = z1495 + z1098 * z1498 - z1100 * z1499 + z1102 * z1500 - z1122 * z1501 - z1127 * z1503;
    const Scalar z1564 = z1097 * z1498 - z1496 - z1101 * z1499 + z1103 * z1500 - z1123 * z1501 - z1128 * z1503;
    const Scalar z1582 = z1555 + z1564 * z1572;
    const Scalar z1586 = z1559 - z1564 * z1573;
    const Scalar z1552 = z1495 + z1078 * z1498 - z1080 * z1499 + z1082 * (z1500 + z1502);
    const Scalar z1571 = z1564 * z1568;
    const Scalar z1579 = z1552 + z1564 * z1571;
    const Scalar z1551 = z1482 + z1078 * z1485 + z1080 * z1486 + z1082 * (z1487 - z1489);
    const Scalar z1554 = z1077 * z1485 - z1483 + z1081 * z1486 + z1083 * (z1487 - z1489);
    const Scalar z1558 = z1482 + z1098 * z1485 + z1100 * z1486 + z1102 * z1487 - z1122 * z1488 - z1127 * z1490;
    const Scalar z1563 = z1097 * z1485 - z1483 + z1101 * z1486 + z1103 * z1487 - z1123 * z1488 - z1128 * z1490;
    const Scalar z1578 = z1551 + z1563 * z1571;
    const Scalar z1581 = z1554 + z1563 * z1572;
    const Scalar z1585 = z1558 - z1563 * z1573;
    const Scalar z1549 = z1016 * z1486 - z1484 + z1027 * z1487 - z1049 * z1488;
    const Scalar z1570 = z1563 * z1568;
    const Scalar z1576 = z1549 - z1563 * z1570;
    const Scalar z1548 = z1469 + z1016 * z1471 - z1027 * z1472 + z1049 * z1473;
    const Scalar z1550 = z1467 + z1078 * z1470 - z1080 * z1471 + z1082 * (z1472 - z1474);
    const Scalar z1553 = z1077 * z1470 - z1468 - z1081 * z1471 + z1083 * (z1472 - z1474);
    const Scalar z1557 = z1467 + z1098 * z1470 - z1100 * z1471 + z1102 * z1472 - z1122 * z1473 - z1127 * z1475;
    const Scalar z1562 = z1097 * z1470 - z1468 - z1101 * z1471 + z1103 * z1472 - z1123 * z1473 - z1128 * z1475;
    const Scalar z1575 = z1548 + z1562 * z1570;
    const Scalar z1577 = z1550 + z1562 * z1571;
    const Scalar z1580 = z1553 + z1562 * z1572;
    const Scalar z1584 = z1557 - z1562 * z1573;
    const Scalar z1547 = z938 * z1471 - z1469;
    const Scalar z1569 = z1562 * z1568;
    const Scalar z1574 = z1547 - z1562 * z1569;
    const Scalar z1530 = z1376 * z1526 + z1528;
    const Scalar z1593 = z1587 * z1589;
    const Scalar z1603 = z1583 + z1587 * z1593;
    const Scalar z1602 = z1582 + z1586 * z1593;
    const Scalar z1601 = z1581 + z1585 * z1593;
    const Scalar z1600 = z1580 + z1584 * z1593;
    const Scalar z1604 = n1 / z1603;
    const Scalar z1592 = z1586 * z1589;
    const Scalar z1599 = z1579 + z1586 * z1592;
    const Scalar z1598 = z1578 + z1585 * z1592;
    const Scalar z1597 = z1577 + z1584 * z1592;
    const Scalar z1591 = z1585 * z1589;
    const Scalar z1596 = z1576 - z1585 * z1591;
    const Scalar z1595 = z1575 + z1584 * z1591;
    const Scalar z1590 = z1584 * z1589;
    const Scalar z1594 = z1574 - z1584 * z1590;
    const Scalar z1545 = z1376 * z1541 + z1543;
    const Scalar z1624 = z1237 * z1370 - z1255 - z1278 * z1385 + z1262;
    const Scalar z1625 = z1237 * z1369 + z1278 * z1384 + z1412 * z1624 - z1270;
    const Scalar z1607 = z1602 * z1604;
    const Scalar z1606 = z1601 * z1604;
    const Scalar z1605 = z1600 * z1604;
    const Scalar z1613 = z1599 - z1602 * z1607;
    const Scalar z1612 = z1598 - z1601 * z1607;
    const Scalar z1610 = z1596 + z1601 * z1606;
    const Scalar z1626 = z1237 * z1368 - z1255 * z1376 - z1278 * z1383 - z1411 * z1624 + z1432 * z1625 + z1274;
    const Scalar z1614 = n1 / z1613;
    const Scalar z1609 = z1595 - z1600 * z1606;
    const Scalar z1627 = z1277 - z1278 * z1382 - z1410 * z1624 + z1431 * z1625 - z1446 * z1626;
    const Scalar z1628 = z1276 - z1278 * z1381 - z1409 * z1624 + z1430 * z1625 - z1445 * z1626 + z1455 * z1627;
    const Scalar z1629 = z1275 + z1278 * z1380 + z1408 * z1624 - z1429 * z1625 + z1444 * z1626 - z1454 * z1627 - z1460
        * z1628;
    const Scalar z1630 = z1462 * z1629;
    const Scalar z1611 = z1597 - z1600 * z1607;
    const Scalar z1608 = z1594 + z1600 * z1605;
    const Scalar z1616 = z1612 * z1614;
    const Scalar z1631 = z1459 * z1628 - z1460 * z1630;
    const Scalar z1619 = z1610 + z1612 * z1616;
    const Scalar z1618 = z1609 - z1611 * z1616;
    const Scalar z1615 = z1611 * z1614;
    const Scalar z1632 = z1453 * z1627 - z1454 * z1630 + z1455 * z1631;
    const Scalar z1617 = z1608 + z1611 * z1615;
    const Scalar z1620 = n1 / z1619;
    const Scalar z1633 = z1443 * z1626 - z1444 * z1630 + z1445 * z1631 + z1446 * z1632;
    const Scalar z1634 = z1428 * z1625 + z1429 * z1630 - z1430 * z1631 - z1431 * z1632 + z1432 * z1633;
    const Scalar z1635 = z1407 * z1624 - z1408 * z1630 + z1409 * z1631 + z1410 * z1632 - z1411 * z1633 + z1412 * z1634;
    const Scalar z1636 = z601 * z1278 + z1380 * z1630 - z1381 * z1631 - z1382 * z1632 + z1383 * z1633 - z1384 * z1634
        + z1385 * z1635;
    const Scalar z1638 = n25_over_7 * z1237 - z1368 * z1633 - z1369 * z1634 - z1370 * z1635;
    const Scalar z1643 = z1158 - z1630 + z1098 * z1633 - z1100 * z1634 + z1102 * z1635 + z1122 * z1636 + z1127 * z1638;
    const Scalar z1644 = z1172 - z1631 + z1097 * z1633 - z1101 * z1634 + z1103 * z1635 + z1123 * z1636 + z1128 * z1638;
    const Scalar z1640 = z1076 + z1632 + z1016 * z1634 - z1027 * z1635 - z1049 * z1636;
    const Scalar z1637 = z1635 + n25_over_3 * z1255 + z1376 * z1633;
    const Scalar z1641 = z1091 - z1630 + z1078 * z1633 - z1080 * z1634 + z1082 * (z1635 - z1637);
    const Scalar z1642 = z1096 - z1631 + z1077 * z1633 - z1081 * z1634 + z1083 * (z1635 - z1637);
    const Scalar z1639 = z952 - z1632 + z938 * z1634;
    const Scalar z1645 = z1573 * z1644 - z1643;
    const Scalar z1646 = z1642 + z1572 * z1644 - z1593 * z1645;
    const Scalar z1621 = z1618 * z1620;
    const Scalar z1622 = z1617 - z1618 * z1621;
    const Scalar z1647 = z1641 + z1571 * z1644 - z1592 * z1645 - z1607 * z1646;
    const Scalar z1623 = n1 / z1622;
    const Scalar z1648 = z1640 + z1570 * z1644 - z1591 * z1645 - z1606 * z1646 - z1616 * z1647;
    const Scalar z1649 = z1569 * z1644 - z1639 - z1590 * z1645 - z1605 * z1646 - z1615 * z1647 + z1621 * z1648;
    const Scalar z1650 = z1623 * z1649;
    const Scalar z1651 = z1620 * z1648 + z1621 * z1650;
    const Scalar z1652 = z1614 * z1647 + z1615 * z1650 + z1616 * z1651;
    const Scalar z1653 = z1604 * z1646 + z1605 * z1650 + z1606 * z1651 - z1607 * z1652;
    const Scalar z1654 = z1589 * z1645 - z1590 * z1650 - z1591 * z1651 + z1592 * z1652 + z1593 * z1653;
    const Scalar z1655 = z1568 * z1644 + z1569 * z1650 + z1570 * z1651 - z1571 * z1652 - z1572 * z1653 + z1573 * z1654;
    const Scalar z1656 = z1467 * z1650 - z1630 + z1482 * z1651 - z1495 * z1652 - z1508 * z1653 - z1523 * z1654 - z1538
        * z1655;
    const Scalar z1657 = z1631 + z1468 * z1650 + z1483 * z1651 - z1496 * z1652 + z1509 * z1653 + z1524 * z1654 - z1539
        * z1655;
    const Scalar z1658 = z1632 + z1469 * z1650 + z1484 * z1651 - z1497 * z1652 - z1510 * z1653 + z1525 * z1654 - z1540
        * z1655;
    const Scalar z1659 = z1633 + z1470 * z1650 + z1485 * z1651 - z1498 * z1652 - z1511 * z1653 + z1526 * z1654 - z1541
        * z1655;
    const Scalar z1660 = z1634 + z1471 * z1650 - z1486 * z1651 - z1499 * z1652 - z1512 * z1653 - z1527 * z1654 + z1542
        * z1655;
    const Scalar z1661 = z1635 + z1472 * z1650 + z1487 * z1651 - z1500 * z1652 - z1513 * z1653 + z1528 * z1654 - z1543
        * z1655;
    const Scalar z1662 = z1473 * z1650 - z1636 + z1488 * z1651 - z1501 * z1652 - z1514 * z1653 + z1529 * z1654 - z1544
        * z1655;
    const Scalar z1663 = z1637 + z1474 * z1650 + z1489 * z1651 + z1502 * z1652 + z1515 * z1653 + z1530 * z1654 - z1545
        * z1655;
    const Scalar z1664 = z1475 * z1650 - z1638 + z1490 * z1651 - z1503 * z1652 - z1516 * z1653 + z1531 * z1654 - z1546
        * z1655;
    accelerations.x = z1656;
    accelerations.y = z1657;
    accelerations.z = z1658;
    accelerations.yaw = z1659;
    accelerations.roll = z1660;
    accelerations.pitch = z1661;
    accelerations.steer = -z1662;
    accelerations.rear = -z1663;
    accelerations.front = -z1664;
    multipliers.lambda_rear_touches = -z1650;
    multipliers.lambda_front_touches = -z1651;
    multipliers.lambda_rear_rolls_x = -z1652;
    multipliers.lambda_rear_rolls_y = -z1653;
    multipliers.lambda_front_rolls_x = -z1654;
    multipliers.lambda_front_rolls_y = z1655;
    if (!(traits::regular(z1461, n94) && traits::regular(z1458, n94) && traits::regular(z1452, n94)
        && traits::regular(-z1442, z1365) && traits::regular(-z1427, z1353) && traits::regular(-z1406, z1336)
        && traits::regular(z587, z587) && traits::regular(-z1622, -z1547) && traits::regular(-z1619, -z1549)
        && traits::regular(z1613, z1552) && traits::regular(z1603, z1556) && traits::regular(-z1588, -z1561)
        && traits::regular(-z1567, -z1567))) return torsor::Status::singular;
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
    const Scalar z888 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z1747 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z1746 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z1735 = v_yaw * c_roll;
    const Scalar z1734 = v_yaw * s_roll;
    const Scalar z1719 = z32 * s_steer;
    const Scalar z1718 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1720 = -z888 * (n1 - c_steer);
    const Scalar z1721 = z31 * s_steer;
    const Scalar z1722 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1731 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1781 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z1724 = n0_08 * z1719 - n0_35 * z1721;
    const Scalar z1736 = v_roll * c_pitch - s_pitch * z1735;
    const Scalar z1737 = v_roll * s_pitch + c_pitch * z1735;
    const Scalar z1738 = v_pitch + z1734;  // angular velocity of frame, y
    const Scalar z1739 = v_rear + z1738;  // angular velocity of rear_wheel, y
    const Scalar z1723 = n0_08 * z1718 - n0_35 * z1720;
    const Scalar z1784 = n0_8 * z1719 - n2_8 * z1721;
    const Scalar z1725 = n0_08 * z1720 - n0_35 * z1722;
    const Scalar z1732 = c_roll * z1731;
    const Scalar z1740 = z1719 * z1738 - z1720 * z1737 + z1718 * z1736;
    const Scalar z1741 = c_steer * z1738 - z1719 * z1736 + z1721 * z1737;
    const Scalar z1742 = z1721 * z1738 + z1720 * z1736 - z1722 * z1737;
    const Scalar z1748 = v_z * s_roll - c_roll * z1747;
    const Scalar z1749 = v_z * c_roll + s_roll * z1747;
    const Scalar z1752 = s_rear * z1737 - c_rear * z1736;
    const Scalar z1753 = s_rear * z1736 + c_rear * z1737;
    const Scalar z1782 = c_roll * z1781;
    const Scalar z1783 = n0_8 * z1718 - n2_8 * z1720;
    const Scalar z1785 = n0_8 * z1720 - n2_8 * z1722;
    const Scalar z1733 = q_z - z1732;
    const Scalar z1750 = s_pitch * z1749 - c_pitch * z1746;
    const Scalar z1751 = s_pitch * z1746 + c_pitch * z1749;
    const Scalar z1757 = n0_3 * z1736 - z1748 - n1_1 * z1737;
    const Scalar z1770 = n51 * z1736 + n25_5 * z1737 + n85 * z1748;
    const Scalar z1772 = n39_8 * z1736 + n17_7 * z1737 + n51 * z1748;
    const Scalar z1774 = n17_7 * z1736 + n10_45 * z1737 + n25_5 * z1748;
    const Scalar z1727 = n0_3 + z1725;
    const Scalar z1726 = n1_1 - z1723;
    const Scalar z1786 = c_pitch * z1785 + s_pitch * z1783;
    const Scalar z1758 = n1_1 * z1738 - z1751;
    const Scalar z1743 = z31 * v_steer + z1740;  // angular velocity of fork, x
    const Scalar z1756 = n0_3 * z1738 - z1750;
    const Scalar z1744 = z32 * v_steer - z1742;  // angular velocity of fork, z
    const Scalar z1728 = s_pitch * z1726 - c_pitch * z1727;
    const Scalar z1745 = v_front + z1741;  // angular velocity of front_wheel, y
    const Scalar z1759 = z1720 * z1758 - z1719 * z1757 + z1718 * z1756;
    const Scalar z1761 = z1722 * z1758 - z1721 * z1757 + z1720 * z1756;
    const Scalar z1760 = c_steer * z1757 + z1719 * z1756 + z1721 * z1758;
    const Scalar z1729 = s_roll * z1724 + c_roll * z1728;
    const Scalar z1762 = n0_35 * z1741 - z1759;
    const Scalar z1764 = n0_08 * z1741 - z1761;
    const Scalar z1730 = q_z - z1729;
    const Scalar z1754 = s_rear * z1751 + c_rear * z1750;
    const Scalar z1755 = s_rear * z1750 - c_rear * z1751;
    const Scalar z1763 = n0_35 * z1743 - z1760 - n0_08 * z1744;
    const Scalar z1765 = s_front * z1744 - c_front * z1743;
    const Scalar z1766 = s_front * z1743 + c_front * z1744;
    const Scalar z1767 = s_front * z1764 + c_front * z1762;
    const Scalar z1768 = s_front * z1762 - c_front * z1764;
    const Scalar z1769 = n51 * z1738 + n85 * z1750;
    const Scalar z1771 = n25_5 * z1738 - n85 * z1751;
    const Scalar z1773 = n49_25 * z1738 - n25_5 * z1751 + n51 * z1750;
    const Scalar z1775 = n2_8 * z1741 - n4 * z1759;
    const Scalar z1776 = n2_8 * z1743 - n0_8 * z1744 - n4 * z1760;
    const Scalar z1777 = n0_8 * z1741 - n4 * z1761;
    const Scalar z1778 = k16 * z1743 - k17 * z1744 - n2_8 * z1760;
    const Scalar z1779 = n2_18 * z1741 - n2_8 * z1759 - n0_8 * z1761;
    const Scalar z1780 = k17 * z1743 - k19 * z1744 - n0_8 * z1760;
    const Scalar z1787 = s_roll * z1784 - c_roll * z1786;
    result.kinetic = z1748 * z1748 + n0_06 * z1739 * z1739 + k21 * (z1752 * z1752 + z1753 * z1753) + z1754 * z1754
        + n0_14 * z1745 * z1745 + z1755 * z1755 + k23 * (z1765 * z1765 + z1766 * z1766) + n1_5 * (z1763 * z1763 + z1767
        * z1767 + z1768 * z1768) + n0_5 * (z1736 * z1772 + z1737 * z1774 + z1748 * z1770 - z1751 * z1771 + z1750 * z1769
        + z1738 * z1773 + z1743 * z1778 - z1744 * z1780 - z1759 * z1775 - z1760 * z1776 - z1761 * z1777 + z1741
        * z1779);
    result.force_function = n853_47 * q_z + n39_24 * z1733 - n9_81 * (z1782 + z1787) + n29_43 * z1730;
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
    const Scalar z888 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z1892 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z1891 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z1880 = v_yaw * c_roll;
    const Scalar z1879 = v_yaw * s_roll;
    const Scalar z1864 = z32 * s_steer;
    const Scalar z1863 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1865 = -z888 * (n1 - c_steer);
    const Scalar z1866 = z31 * s_steer;
    const Scalar z1867 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1876 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z1926 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z1869 = n0_08 * z1864 - n0_35 * z1866;
    const Scalar z1881 = v_roll * c_pitch - s_pitch * z1880;
    const Scalar z1882 = v_roll * s_pitch + c_pitch * z1880;
    const Scalar z1883 = v_pitch + z1879;  // angular velocity of frame, y
    const Scalar z1884 = v_rear + z1883;  // angular velocity of rear_wheel, y
    const Scalar z1868 = n0_08 * z1863 - n0_35 * z1865;
    const Scalar z1929 = n0_8 * z1864 - n2_8 * z1866;
    const Scalar z1870 = n0_08 * z1865 - n0_35 * z1867;
    const Scalar z1877 = c_roll * z1876;
    const Scalar z1885 = z1864 * z1883 - z1865 * z1882 + z1863 * z1881;
    const Scalar z1886 = c_steer * z1883 - z1864 * z1881 + z1866 * z1882;
    const Scalar z1887 = z1866 * z1883 + z1865 * z1881 - z1867 * z1882;
    const Scalar z1893 = v_z * s_roll - c_roll * z1892;
    const Scalar z1894 = v_z * c_roll + s_roll * z1892;
    const Scalar z1897 = s_rear * z1882 - c_rear * z1881;
    const Scalar z1898 = s_rear * z1881 + c_rear * z1882;
    const Scalar z1927 = c_roll * z1926;
    const Scalar z1928 = n0_8 * z1863 - n2_8 * z1865;
    const Scalar z1930 = n0_8 * z1865 - n2_8 * z1867;
    const Scalar z1878 = q_z - z1877;
    const Scalar z1895 = s_pitch * z1894 - c_pitch * z1891;
    const Scalar z1896 = s_pitch * z1891 + c_pitch * z1894;
    const Scalar z1902 = n0_3 * z1881 - z1893 - n1_1 * z1882;
    const Scalar z1915 = n51 * z1881 + n25_5 * z1882 + n85 * z1893;
    const Scalar z1917 = n39_8 * z1881 + n17_7 * z1882 + n51 * z1893;
    const Scalar z1919 = n17_7 * z1881 + n10_45 * z1882 + n25_5 * z1893;
    const Scalar z1872 = n0_3 + z1870;
    const Scalar z1871 = n1_1 - z1868;
    const Scalar z1931 = c_pitch * z1930 + s_pitch * z1928;
    const Scalar z1903 = n1_1 * z1883 - z1896;
    const Scalar z1888 = z31 * v_steer + z1885;  // angular velocity of fork, x
    const Scalar z1901 = n0_3 * z1883 - z1895;
    const Scalar z1889 = z32 * v_steer - z1887;  // angular velocity of fork, z
    const Scalar z1873 = s_pitch * z1871 - c_pitch * z1872;
    const Scalar z1890 = v_front + z1886;  // angular velocity of front_wheel, y
    const Scalar z1904 = z1865 * z1903 - z1864 * z1902 + z1863 * z1901;
    const Scalar z1906 = z1867 * z1903 - z1866 * z1902 + z1865 * z1901;
    const Scalar z1905 = c_steer * z1902 + z1864 * z1901 + z1866 * z1903;
    const Scalar z1874 = s_roll * z1869 + c_roll * z1873;
    const Scalar z1907 = n0_35 * z1886 - z1904;
    const Scalar z1909 = n0_08 * z1886 - z1906;
    const Scalar z1875 = q_z - z1874;
    const Scalar z1899 = s_rear * z1896 + c_rear * z1895;
    const Scalar z1900 = s_rear * z1895 - c_rear * z1896;
    const Scalar z1908 = n0_35 * z1888 - z1905 - n0_08 * z1889;
    const Scalar z1910 = s_front * z1889 - c_front * z1888;
    const Scalar z1911 = s_front * z1888 + c_front * z1889;
    const Scalar z1912 = s_front * z1909 + c_front * z1907;
    const Scalar z1913 = s_front * z1907 - c_front * z1909;
    const Scalar z1914 = n51 * z1883 + n85 * z1895;
    const Scalar z1916 = n25_5 * z1883 - n85 * z1896;
    const Scalar z1918 = n49_25 * z1883 - n25_5 * z1896 + n51 * z1895;
    const Scalar z1920 = n2_8 * z1886 - n4 * z1904;
    const Scalar z1921 = n2_8 * z1888 - n0_8 * z1889 - n4 * z1905;
    const Scalar z1922 = n0_8 * z1886 - n4 * z1906;
    const Scalar z1923 = k16 * z1888 - k17 * z1889 - n2_8 * z1905;
    const Scalar z1924 = n2_18 * z1886 - n2_8 * z1904 - n0_8 * z1906;
    const Scalar z1925 = k17 * z1888 - k19 * z1889 - n0_8 * z1905;
    const Scalar z1932 = s_roll * z1929 - c_roll * z1931;
    result.energy = -n853_47 * q_z + z1893 * z1893 + n0_06 * z1884 * z1884 - n39_24 * z1878 + k23 * (z1897 * z1897
        + z1898 * z1898) + z1899 * z1899 + n0_14 * z1890 * z1890 + z1900 * z1900 + n9_81 * (z1927 + z1932) - n29_43
        * z1875 + k27 * (z1910 * z1910 + z1911 * z1911) + n1_5 * (z1908 * z1908 + z1912 * z1912 + z1913 * z1913) + n0_5
        * (z1881 * z1917 + z1882 * z1919 + z1893 * z1915 - z1896 * z1916 + z1895 * z1914 + z1883 * z1918 + z1888 * z1923
        - z1889 * z1925 - z1904 * z1920 - z1905 * z1921 - z1906 * z1922 + z1886 * z1924);
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
    const Scalar z887 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z888 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z889 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z1943 = z32 * s_steer;
    const Scalar z1945 = z31 * s_steer;
    const Scalar z1961 = v_roll * s_roll;
    const Scalar z1960 = v_yaw * c_yaw;
    const Scalar z1959 = v_roll * c_roll;
    const Scalar z1964 = v_yaw * s_yaw;
    const Scalar z1947 = s_yaw * c_roll;
    const Scalar z1951 = n1 - s_roll * s_roll;
    const Scalar z1942 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z1948 = c_yaw * c_roll;
    const Scalar z1944 = -z888 * (n1 - c_steer);
    const Scalar z1946 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z1967 = n2 * s_roll;
    const Scalar z1972 = s_yaw * s_roll;
    const Scalar z1974 = c_yaw * s_roll;
    const Scalar z1949 = s_roll * z1947;
    const Scalar z1950 = s_roll * z1948;
    const Scalar z1962 = s_yaw * z1961 - c_roll * z1960;
    const Scalar z1965 = c_yaw * z1961 + c_roll * z1964;
    const Scalar z1968 = z1959 * z1967;
    const Scalar z1973 = s_roll * z1972 - c_roll * z1947;
    const Scalar z1975 = s_roll * z1974 - c_roll * z1948;
    const Scalar z1976 = c_roll * z1967;
    const Scalar z1980 = v_roll * z1959;
    const Scalar z1981 = v_yaw * z1964;
    const Scalar z1982 = n2 * z1961;
    const Scalar z1984 = v_roll * z1961;
    const Scalar z1985 = n2 * z1959;
    const Scalar z1987 = v_yaw * z1960;
    const Scalar z1995 = n0_08 * z1943 - n0_35 * z1945;
    const Scalar z2008 = s_pitch * z1945 - c_pitch * z1943;
    const Scalar z2009 = s_pitch * z1943 + c_pitch * z1945;
    const Scalar z1952 = z1951 * z1951 + z1949 * z1949 + z1950 * z1950;
    const Scalar z1983 = s_yaw * z1980 + c_roll * z1981 + z1960 * z1982;
    const Scalar z1988 = c_yaw * z1980 + c_roll * z1987 - z1964 * z1982;
    const Scalar z1990 = n2 * (s_roll * z1984 - z1959 * z1959);
    const Scalar z1994 = n0_08 * z1942 - n0_35 * z1944;
    const Scalar z1996 = n0_08 * z1944 - n0_35 * z1946;
    const Scalar z1963 = s_roll * z1962 - z1947 * z1959;
    const Scalar z1966 = s_roll * z1965 - z1948 * z1959;
    const Scalar z1977 = n2 * (z1951 * z1976 + z1949 * z1973 + z1950 * z1975);
    const Scalar z2010 = s_roll * z2009 - c_roll * c_steer;
    const Scalar z2011 = s_roll * c_steer + c_roll * z2009;
    const Scalar z1998 = n0_3 + z1996;
    const Scalar z1997 = n1_1 - z1994;
    const Scalar z1953 = traits::sqrt(z1952);
    const Scalar z1969 = n2 * (z1951 * z1968 + z1949 * z1963 + z1950 * z1966);
    const Scalar z1986 = z1947 * z1984 + z1962 * z1985 + s_roll * z1983;
    const Scalar z1989 = z1948 * z1984 + z1965 * z1985 + s_roll * z1988;
    const Scalar z2012 = c_yaw * z2008 + s_yaw * z2010;
    const Scalar z1991 = n2 * (z1949 * z1986 + z1950 * z1989 - z1951 * z1990 - z1963 * z1963 - z1966 * z1966 - z1968
        * z1968);
    const Scalar z2013 = s_yaw * z2008 - c_yaw * z2010;
    const Scalar z2000 = s_pitch * z1997 - c_pitch * z1998;
    const Scalar z2001 = s_roll * z2000 - c_roll * z1995;
    const Scalar z1999 = s_pitch * z1998 + c_pitch * z1997;
    const Scalar z1978 = n0_5 * z1977 / z1953;
    const Scalar z1958 = q_z + n0_3 * z1953;
    const Scalar z1970 = n0_5 * z1969 / z1953;
    const Scalar z2002 = s_roll * z1995 + c_roll * z2000;
    const Scalar z2005 = q_z - z2002;
    const Scalar z2003 = s_yaw * z2001 - c_yaw * z1999;
    const Scalar z2004 = s_yaw * z1999 + c_yaw * z2001;
    const Scalar z2006 = q_y + z2004;
    const Scalar z1954 = n0_3 / z1953;
    const Scalar z2014 = z2011 * z2012;
    const Scalar z2007 = q_x - z2003;
    const Scalar z1955 = q_x + z1949 * z1954;
    const Scalar z2015 = z2011 * z2013;
    const Scalar z1956 = q_y - z1950 * z1954;
    const Scalar z2016 = n1 - z2011 * z2011;
    const Scalar z1979 = n0_3 * z1978;
    const Scalar z1992 = n0_5 * (z1969 * z1970 / (z1953 * z1953) + z1991 / z1953);
    const Scalar z1971 = v_z - n0_3 * z1970;
    const Scalar z1957 = q_z + z1951 * z1954;
    const Scalar z2028 = v_pitch * c_pitch;
    const Scalar z2033 = v_pitch * s_pitch;
    const Scalar z2024 = v_steer * c_steer;
    const Scalar z2029 = v_steer * s_steer;
    const Scalar z2025 = z32 * z2024;
    const Scalar z2026 = z31 * z2024;
    const Scalar z2047 = n2 * z2011;
    const Scalar z2031 = z888 * z2029;
    const Scalar z2017 = z2016 * z2016 + z2014 * z2014 + z2015 * z2015;
    const Scalar z2018 = traits::sqrt(z2017);
    const Scalar z2039 = z1943 * z2028 - z1945 * z2033 + s_pitch * z2025 + c_pitch * z2026;
    const Scalar z2042 = z1943 * z2033 + z1945 * z2028 + s_pitch * z2026 - c_pitch * z2025;
    const Scalar z2030 = -z2029 * (n1 - z887);
    const Scalar z2032 = n0_35 * z2031 + n0_08 * z2030;
    const Scalar z1993 = n0_3 * z1992;
    const Scalar z2041 = c_roll * z2029 + c_steer * z1961 + z1959 * z2009 + s_roll * z2039;
    const Scalar z2045 = z1960 * z2008 + z1964 * z2010 + s_yaw * z2042 - c_yaw * z2041;
    const Scalar z2040 = s_roll * z2029 - c_steer * z1959 + z1961 * z2009 - c_roll * z2039;
    const Scalar z2023 = z2005 + n0_35 * z2018;
    const Scalar z2043 = z1960 * z2010 - z1964 * z2008 + c_yaw * z2042 + s_yaw * z2041;
    const Scalar z2048 = z2040 * z2047;
    const Scalar z2046 = z2011 * z2045 - z2013 * z2040;
    const Scalar z2034 = -z2029 * (n1 - z889);
    const Scalar z2035 = n0_08 * z2031 + n0_35 * z2034;
    const Scalar z2044 = z2011 * z2043 - z2012 * z2040;
    const Scalar z2027 = n0_08 * z2025 - n0_35 * z2026;
    const Scalar z2049 = n2 * (z2016 * z2048 + z2015 * z2046 + z2014 * z2044);
    const Scalar z2036 = s_pitch * z2032 - c_pitch * z2035 - z1997 * z2028 - z1998 * z2033;
    const Scalar z2071 = z32 * c_steer;
    const Scalar z2072 = z31 * c_steer;
    const Scalar z2062 = s_roll * z2008;
    const Scalar z2050 = n0_5 * z2049 / z2018;
    const Scalar z2054 = c_yaw * z2011;
    const Scalar z2055 = z2011 * z2054 + z2010 * z2013;
    const Scalar z2063 = s_yaw * z2062 - c_yaw * z2009;
    const Scalar z2065 = s_yaw * z2009 + c_yaw * z2062;
    const Scalar z2019 = n0_35 / z2018;
    const Scalar z2061 = c_roll * z2008;
    const Scalar z2064 = z2011 * z2063 + z2012 * z2061;
    const Scalar z2066 = z2011 * z2065 - z2013 * z2061;
    const Scalar z2067 = z2047 * z2061;
    const Scalar z2020 = z2007 - z2014 * z2019;
    const Scalar z2037 = z1959 * z1995 + s_roll * z2027 - z1961 * z2000 - c_roll * z2036;
    const Scalar z2068 = n2 * (z2014 * z2064 - z2015 * z2066 - z2016 * z2067);
    const Scalar z2038 = v_z - z2037;
    const Scalar z2051 = z2038 + n0_35 * z2050;
    const Scalar z2022 = z2005 + z2016 * z2019;
    const Scalar z2052 = s_yaw * z2011;
    const Scalar z2053 = z2010 * z2012 - z2011 * z2052;
    const Scalar z2056 = z2010 * z2047;
    const Scalar z2021 = z2006 - z2015 * z2019;
    const Scalar z2097 = v_steer * z2024;
    const Scalar z2103 = v_pitch * z2033;
    const Scalar z2057 = n2 * (z2015 * z2055 - z2016 * z2056 + z2014 * z2053);
    const Scalar z2069 = n0_5 * z2068 / z2018;
    const Scalar z2104 = v_pitch * z2028;
    const Scalar z2093 = v_steer * z2029;
    const Scalar z2094 = z32 * z2093;
    const Scalar z2095 = z31 * z2093;
    const Scalar z2112 = n2 * z2040;
    const Scalar z2081 = s_pitch * z2071 + c_pitch * z2072;
    const Scalar z2107 = z1943 * z2103 + z1945 * z2104 + s_pitch * z2094 + c_pitch * z2095 - n2 * (z2025 * z2028 - z2026
        * z2033);
    const Scalar z2109 = z1945 * z2103 - z1943 * z2104 + s_pitch * z2095 - c_pitch * z2094 - n2 * (z2025 * z2033 + z2026
        * z2028);
    const Scalar z2096 = n0_08 * z2094 - n0_35 * z2095;
    const Scalar z2058 = n0_5 * z2057 / z2018;
    const Scalar z2108 = z1984 * z2009 - c_roll * z2097 - c_steer * z1980 - n2 * (z1959 * z2039 - z1961 * z2029)
        + s_roll * z2107;
    const Scalar z2111 = s_roll * z2097 + c_steer * z1984 + z1980 * z2009 + n2 * (z1959 * z2029 + z1961 * z2039)
        + c_roll * z2107;
    const Scalar z2059 = z2001 - n0_35 * z2058;
    const Scalar z2114 = z1981 * z2008 - z1987 * z2010 - n2 * (z1960 * z2042 + z1964 * z2041) + s_yaw * z2109 - c_yaw
        * z2108;
    const Scalar z2110 = z1987 * z2008 + z1981 * z2010 - n2 * (z1960 * z2041 - z1964 * z2042) + c_yaw * z2109 + s_yaw
        * z2108;
    const Scalar z2115 = z2045 * z2112 + z2013 * z2111 + z2011 * z2114;
    const Scalar z2113 = z2043 * z2112 + z2012 * z2111 + z2011 * z2110;
    const Scalar z2116 = n2 * (z2011 * z2111 - z2040 * z2040);
    const Scalar z2117 = n2 * (z2015 * z2115 - z2048 * z2048 - z2046 * z2046 - z2044 * z2044 - z2016 * z2116 + z2014
        * z2113);
    const Scalar z2084 = s_pitch * z2072 - c_pitch * z2071;
    const Scalar z2073 = n0_08 * z2071 - n0_35 * z2072;
    const Scalar z2083 = c_roll * s_steer + s_roll * z2081;
    const Scalar z2082 = s_roll * s_steer - c_roll * z2081;
    const Scalar z2089 = z2047 * z2082;
    const Scalar z2085 = c_yaw * z2084 + s_yaw * z2083;
    const Scalar z2087 = s_yaw * z2084 - c_yaw * z2083;
    const Scalar z2086 = z2011 * z2085 - z2012 * z2082;
    const Scalar z2088 = z2011 * z2087 - z2013 * z2082;
    const Scalar z2099 = z888 * z2097;
    const Scalar z2098 = -z2097 * (n1 - z887);
    const Scalar z2100 = n0_35 * z2099 + n0_08 * z2098;
    const Scalar z2118 = n0_5 * (z2049 * z2050 / (z2018 * z2018) + z2117 / z2018);
    const Scalar z2090 = n2 * (z2016 * z2089 + z2014 * z2086 + z2015 * z2088);
    const Scalar z2101 = -z2097 * (n1 - z889);
    const Scalar z2102 = n0_08 * z2099 + n0_35 * z2101;
    const Scalar z2075 = s_steer * z888;
    const Scalar z2074 = s_steer * (n1 - z887);
    const Scalar z2076 = n0_08 * z2074 - n0_35 * z2075;
    const Scalar z2105 = s_pitch * z2100 - z1998 * z2104 - c_pitch * z2102 + z1997 * z2103 + n2 * (z2028 * z2032 + z2033
        * z2035);
    const Scalar z2091 = n0_5 * z2090 / z2018;
    const Scalar z2077 = s_steer * (n1 - z889);
    const Scalar z2078 = n0_08 * z2075 - n0_35 * z2077;
    const Scalar z2060 = c_roll * z1999;
    const Scalar z2070 = z2060 + n0_35 * z2069;
    const Scalar z2128 = n0_3 * z1970 / (z1953 * z1953);
    const Scalar z2106 = z1984 * z1995 + s_roll * z2096 + z1980 * z2000 - n2 * (z1959 * z2027 + z1961 * z2036) + c_roll
        * z2105;
    const Scalar z2119 = z2106 - n0_35 * z2118;
    const Scalar z2131 = v_z - z1954 * z1968 + z1951 * z2128;
    const Scalar z2129 = v_y + z1954 * z1966 - z1950 * z2128;
    const Scalar z2137 = v_x - z1954 * z1963 + z1949 * z2128;
    const Scalar z2079 = c_pitch * z2078 + s_pitch * z2076;
    const Scalar z2080 = s_roll * z2073 + c_roll * z2079;
    const Scalar z2120 = q_x - z1955;
    const Scalar z2121 = q_y - z1956;
    const Scalar z2122 = q_z - z1957;
    const Scalar z2132 = v_z - z2131;
    const Scalar z2130 = v_y - z2129;
    const Scalar z2092 = z2080 - n0_35 * z2091;
    const Scalar z2176 = c_roll * z2027 - z1961 * z1995 - z1959 * z2000 + s_roll * z2036;
    const Scalar z2175 = s_pitch * z2035 + c_pitch * z2032 + z1997 * z2033 - z1998 * z2028;
    const Scalar z2179 = n0_35 * z2050 / (z2018 * z2018);
    const Scalar z2182 = z2016 * z2179 - z2038 - z2019 * z2048;
    const Scalar z2169 = z2007 - z2020;
    const Scalar z2170 = z2006 - z2021;
    const Scalar z2138 = v_x - z2137;
    const Scalar z2171 = z2005 - z2022;
    const Scalar z2156 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z2155 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z2157 = s_roll * z2156;
    const Scalar z2149 = s_pitch * z32 + c_pitch * z31;
    const Scalar z2150 = s_pitch * z31 - c_pitch * z32;
    const Scalar z2177 = s_yaw * z2175 - z1960 * z1999 + z1964 * z2001 + c_yaw * z2176;
    const Scalar z2178 = v_y - z2177;
    const Scalar z2159 = s_yaw * z2157 - c_yaw * z2155;
    const Scalar z2163 = q_x - z2159;
    const Scalar z2151 = s_roll * z2150;
    const Scalar z2180 = z2178 - z2019 * z2046 + z2015 * z2179;
    const Scalar z2164 = z2020 - z2163;
    const Scalar z2142 = q_x - z2020;
    const Scalar z2158 = c_roll * z2156;
    const Scalar z2161 = q_z - z2158;
    const Scalar z2160 = s_yaw * z2155 + c_yaw * z2157;
    const Scalar z2162 = q_y + z2160;
    const Scalar z2144 = q_z - z2022;
    const Scalar z2166 = z2022 - z2161;
    const Scalar z2143 = q_y - z2021;
    const Scalar z2152 = c_roll * z2150;
    const Scalar z2181 = v_y - z2180;
    const Scalar z2165 = z2021 - z2162;
    const Scalar z2145 = s_yaw * z2144;
    const Scalar z2146 = c_yaw * z2144;
    const Scalar z2153 = s_yaw * z2151 - c_yaw * z2149;
    const Scalar z2147 = s_roll * z2143 - z1948 * z2144;
    const Scalar z2148 = s_roll * z2142 + z1947 * z2144;
    const Scalar z2154 = s_yaw * z2149 + c_yaw * z2151;
    const Scalar z2123 = s_yaw * z2122;
    const Scalar z2183 = v_z + z2182;
    const Scalar z2124 = c_yaw * z2122;
    const Scalar z2184 = z1960 * z2144 + s_yaw * z2183;
    const Scalar z2133 = z1960 * z2122 + s_yaw * z2132;
    const Scalar z2139 = c_yaw * z2132 - z1964 * z2122;
    const Scalar z2167 = z2152 * z2165 + z2154 * z2166;
    const Scalar z2168 = z2152 * z2164 - z2153 * z2166;
    const Scalar z2125 = s_roll * z2121 - z1948 * z2122;
    const Scalar z2127 = v_x + v_yaw * z2121 - v_roll * z2123 + z2125 * (v_pitch + v_rear);
    const Scalar z2134 = z1959 * z2121 + z1965 * z2122 + s_roll * z2130 - z1948 * z2132;
    const Scalar z2135 = v_yaw * z2130 - v_roll * z2133 + z2134 * (v_pitch + v_rear);
    const Scalar z2185 = z1959 * z2143 + z1965 * z2144 + s_roll * z2181 - z1948 * z2183;
    const Scalar z2140 = z1959 * z2120 - z1962 * z2122 + s_roll * z2138 + z1947 * z2132;
    const Scalar z2141 = v_yaw * z2138 - v_roll * z2139 + z2140 * (v_pitch + v_rear);
    const Scalar z2126 = s_roll * z2120 + z1947 * z2122;
    const Scalar z2136 = v_y - v_yaw * z2120 + v_roll * z2124 - z2126 * (v_pitch + v_rear);
    const Scalar z2206 = s_yaw * z2176 - c_yaw * z2175 - z1960 * z2001 - z1964 * z1999;
    const Scalar z2207 = v_x + z2206;
    const Scalar z2201 = z2178 - z2180;
    const Scalar z2202 = z2038 + z2182;
    const Scalar z2203 = z2011 * z2201 - z2040 * z2170 - z2045 * z2171 - z2013 * z2202;
    const Scalar z2208 = z2207 - z2019 * z2044 + z2014 * z2179;
    const Scalar z2172 = z2011 * z2170 - z2013 * z2171;
    const Scalar z2174 = v_x + v_yaw * z2143 - v_roll * z2145 + v_pitch * z2147 + v_steer * z2167 + v_front * z2172;
    const Scalar z2217 = z2207 - z2208;
    const Scalar z2218 = z2011 * z2217 - z2040 * z2169 - z2043 * z2171 - z2012 * z2202;
    const Scalar z2173 = z2011 * z2169 - z2012 * z2171;
    const Scalar z2205 = v_y - v_yaw * z2142 + v_roll * z2146 - v_pitch * z2148 - v_steer * z2168 - v_front * z2173;
    const Scalar z2188 = n0_3 * z2028 - n1_1 * z2033;
    const Scalar z2194 = z31 * z2033 - z32 * z2028;
    const Scalar z2186 = z31 * z2028 + z32 * z2033;
    const Scalar z2189 = n1_1 * z2028 + n0_3 * z2033;
    const Scalar z2190 = z1959 * z2156 + s_roll * z2189;
    const Scalar z2197 = c_roll * z2189 - z1961 * z2156;
    const Scalar z2187 = c_roll * z2186 - z1961 * z2150;
    const Scalar z2195 = z1959 * z2150 + s_roll * z2186;
    const Scalar z2212 = z1964 * z2155 - c_yaw * z2188 + z1960 * z2157 + s_yaw * z2190;
    const Scalar z2191 = z1960 * z2155 + s_yaw * z2188 - z1964 * z2157 + c_yaw * z2190;
    const Scalar z2213 = v_x - z2212;
    const Scalar z2214 = z2208 - z2213;
    const Scalar z2209 = v_x - z2208;
    const Scalar z2211 = z1959 * z2142 - z1962 * z2144 + s_roll * z2209 + z1947 * z2183;
    const Scalar z2210 = c_yaw * z2183 - z1964 * z2144;
    const Scalar z2192 = v_y + z2191;
    const Scalar z2193 = z2180 - z2192;
    const Scalar z2198 = v_z - z2197;
    const Scalar z2199 = z2182 + z2198;
    const Scalar z2215 = z1964 * z2149 + c_yaw * z2194 + z1960 * z2151 + s_yaw * z2195;
    const Scalar z2196 = s_yaw * z2194 - z1960 * z2149 + z1964 * z2151 - c_yaw * z2195;
    const Scalar z2216 = z2164 * z2187 - z2166 * z2215 + z2152 * z2214 + z2153 * z2199;
    const Scalar z2200 = z2165 * z2187 - z2166 * z2196 + z2152 * z2193 - z2154 * z2199;
    const Scalar z2219 = v_yaw * z2209 + v_pitch * z2211 + v_steer * z2216 - v_roll * z2210 + v_front * z2218;
    const Scalar z2204 = v_yaw * z2181 - v_roll * z2184 + v_pitch * z2185 + v_steer * z2200 + v_front * z2203;
    result.value[0] = -z1958;
    result.rate[0] = -z1971;
    result.gamma[0] = z1993;
    result.value[1] = -z2023;
    result.rate[1] = -z2051;
    result.gamma[1] = -z2119;
    result.value[2] = n0;
    result.rate[2] = z2127;
    result.gamma[2] = z2135;
    result.value[3] = n0;
    result.rate[3] = -z2136;
    result.gamma[3] = z2141;
    result.value[4] = n0;
    result.rate[4] = z2174;
    result.gamma[4] = z2204;
    result.value[5] = n0;
    result.rate[5] = -z2205;
    result.gamma[5] = z2219;
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
    result.jacobian[20] = z2121;
    result.jacobian[21] = z2120;
    result.jacobian[22] = z2143;
    result.jacobian[23] = z2142;
    result.jacobian[24] = z1979;
    result.jacobian[25] = -z2059;
    result.jacobian[26] = -z2123;
    result.jacobian[27] = -z2124;
    result.jacobian[28] = -z2145;
    result.jacobian[29] = -z2146;
    result.jacobian[30] = n0;
    result.jacobian[31] = z2070;
    result.jacobian[32] = z2125;
    result.jacobian[33] = z2126;
    result.jacobian[34] = z2147;
    result.jacobian[35] = z2148;
    result.jacobian[36] = n0;
    result.jacobian[37] = z2092;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z2167;
    result.jacobian[41] = z2168;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z2125;
    result.jacobian[45] = z2126;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z2172;
    result.jacobian[53] = z2173;
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
    const Scalar z887 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z31 * z31;
    });
    const Scalar z888 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z31 * z32;
    });
    const Scalar z889 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z32 * z32;
    });
    const Scalar z4106 = z32 * s_steer;
    const Scalar z4108 = z31 * s_steer;
    const Scalar z4105 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z4107 = -z888 * (n1 - c_steer);
    const Scalar z4123 = v_roll * s_roll;
    const Scalar z4109 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z4122 = v_yaw * c_yaw;
    const Scalar z4121 = v_roll * c_roll;
    const Scalar z4126 = v_yaw * s_yaw;
    const Scalar z4110 = s_yaw * c_roll;
    const Scalar z4114 = n1 - s_roll * s_roll;
    const Scalar z4111 = c_yaw * c_roll;
    const Scalar z4133 = s_yaw * s_roll;
    const Scalar z4129 = n2 * s_roll;
    const Scalar z4135 = c_yaw * s_roll;
    const Scalar z4112 = s_roll * z4110;
    const Scalar z4113 = s_roll * z4111;
    const Scalar z4124 = s_yaw * z4123 - c_roll * z4122;
    const Scalar z4127 = c_yaw * z4123 + c_roll * z4126;
    const Scalar z4130 = z4121 * z4129;
    const Scalar z4134 = s_roll * z4133 - c_roll * z4110;
    const Scalar z4136 = s_roll * z4135 - c_roll * z4111;
    const Scalar z4137 = c_roll * z4129;
    const Scalar z4141 = v_roll * z4121;
    const Scalar z4142 = v_yaw * z4126;
    const Scalar z4143 = n2 * z4123;
    const Scalar z4145 = v_roll * z4123;
    const Scalar z4146 = n2 * z4121;
    const Scalar z4148 = v_yaw * z4122;
    const Scalar z4156 = n0_08 * z4106 - n0_35 * z4108;
    const Scalar z4170 = s_pitch * z4108 - c_pitch * z4106;
    const Scalar z4171 = s_pitch * z4106 + c_pitch * z4108;
    const Scalar z4115 = z4114 * z4114 + z4112 * z4112 + z4113 * z4113;
    const Scalar z4144 = s_yaw * z4141 + c_roll * z4142 + z4122 * z4143;
    const Scalar z4149 = c_yaw * z4141 + c_roll * z4148 - z4126 * z4143;
    const Scalar z4151 = n2 * (s_roll * z4145 - z4121 * z4121);
    const Scalar z4155 = n0_08 * z4105 - n0_35 * z4107;
    const Scalar z4157 = n0_08 * z4107 - n0_35 * z4109;
    const Scalar z4125 = s_roll * z4124 - z4110 * z4121;
    const Scalar z4128 = s_roll * z4127 - z4111 * z4121;
    const Scalar z4138 = n2 * (z4114 * z4137 + z4112 * z4134 + z4113 * z4136);
    const Scalar z4163 = s_roll * z4156;
    const Scalar z4172 = s_roll * z4171;
    const Scalar z4174 = s_roll * c_steer + c_roll * z4171;
    const Scalar z4175 = c_yaw * z4170;
    const Scalar z4159 = n0_3 + z4157;
    const Scalar z4173 = c_roll * c_steer - z4172;
    const Scalar z4158 = n1_1 - z4155;
    const Scalar z4116 = traits::sqrt(z4115);
    const Scalar z4131 = n2 * (z4114 * z4130 + z4112 * z4125 + z4113 * z4128);
    const Scalar z4147 = z4110 * z4145 + z4124 * z4146 + s_roll * z4144;
    const Scalar z4176 = s_yaw * z4173 - z4175;
    const Scalar z4161 = s_pitch * z4158 - c_pitch * z4159;
    const Scalar z4160 = s_pitch * z4159 + c_pitch * z4158;
    const Scalar z4150 = z4111 * z4145 + z4127 * z4146 + s_roll * z4149;
    const Scalar z4162 = s_roll * z4161 - c_roll * z4156;
    const Scalar z4164 = c_roll * z4161 + z4163;
    const Scalar z4152 = n2 * (z4112 * z4147 + z4113 * z4150 - z4114 * z4151 - z4125 * z4125 - z4128 * z4128 - z4130
        * z4130);
    const Scalar z4166 = s_yaw * z4160 + c_yaw * z4162;
    const Scalar z4167 = q_z - z4164;
    const Scalar z4168 = q_y + z4166;
    const Scalar z4165 = s_yaw * z4162 - c_yaw * z4160;
    const Scalar z4117 = n0_3 / z4116;
    const Scalar z4177 = s_yaw * z4170;
    const Scalar z4169 = q_x - z4165;
    const Scalar z4139 = n0_5 * z4138 / z4116;
    const Scalar z4132 = n0_5 * z4131 / z4116;
    const Scalar z4118 = q_x + z4112 * z4117;
    const Scalar z4178 = c_yaw * z4173 + z4177;
    const Scalar z4119 = q_y - z4113 * z4117;
    const Scalar z4179 = z4174 * z4176;
    const Scalar z4120 = q_z + z4114 * z4117;
    const Scalar z4181 = n1 - z4174 * z4174;
    const Scalar z4180 = z4174 * z4178;
    const Scalar z4182 = z4181 * z4181 + z4179 * z4179 + z4180 * z4180;
    const Scalar z4192 = v_pitch * c_pitch;
    const Scalar z4197 = v_pitch * s_pitch;
    const Scalar z4188 = v_steer * c_steer;
    const Scalar z4193 = v_steer * s_steer;
    const Scalar z4189 = z32 * z4188;
    const Scalar z4190 = z31 * z4188;
    const Scalar z4195 = z888 * z4193;
    const Scalar z4198 = -z4193 * (n1 - z889);
    const Scalar z4194 = -z4193 * (n1 - z887);
    const Scalar z4199 = n0_08 * z4195 + n0_35 * z4198;
    const Scalar z4196 = n0_35 * z4195 + n0_08 * z4194;
    const Scalar z4183 = traits::sqrt(z4182);
    const Scalar z4191 = n0_08 * z4189 - n0_35 * z4190;
    const Scalar z4140 = n0_3 * z4139;
    const Scalar z4205 = c_roll * z4193;
    const Scalar z4203 = z4106 * z4192 - z4108 * z4197 + s_pitch * z4189 + c_pitch * z4190;
    const Scalar z4207 = z4106 * z4197 + z4108 * z4192 + s_pitch * z4190 - c_pitch * z4189;
    const Scalar z4206 = c_steer * z4123 + z4205 + z4121 * z4171 + s_roll * z4203;
    const Scalar z4212 = n2 * z4174;
    const Scalar z4204 = s_roll * z4193 - c_steer * z4121 + z4123 * z4171 - c_roll * z4203;
    const Scalar z4210 = z4122 * z4170 - z4126 * z4173 + s_yaw * z4207 - c_yaw * z4206;
    const Scalar z4184 = n0_35 / z4183;
    const Scalar z4211 = z4174 * z4210 - z4178 * z4204;
    const Scalar z4208 = c_yaw * z4207 - z4126 * z4170 - z4122 * z4173 + s_yaw * z4206;
    const Scalar z4209 = z4176 * z4204 + z4174 * z4208;
    const Scalar z4200 = s_pitch * z4196 - c_pitch * z4199 - z4158 * z4192 - z4159 * z4197;
    const Scalar z4187 = z4167 + z4181 * z4184;
    const Scalar z4186 = z4168 - z4180 * z4184;
    const Scalar z4185 = z4169 + z4179 * z4184;
    const Scalar z4201 = z4121 * z4156 + s_roll * z4191 - z4123 * z4161 - c_roll * z4200;
    const Scalar z4202 = v_z - z4201;
    const Scalar z4153 = n0_5 * (z4131 * z4132 / (z4116 * z4116) + z4152 / z4116);
    const Scalar z4154 = n0_3 * z4153;
    const Scalar z4235 = z32 * c_steer;
    const Scalar z4236 = z31 * c_steer;
    const Scalar z4245 = s_pitch * z4235 + c_pitch * z4236;
    const Scalar z4248 = s_pitch * z4236 - c_pitch * z4235;
    const Scalar z4226 = s_roll * z4170;
    const Scalar z4229 = s_yaw * z4171 + c_yaw * z4226;
    const Scalar z4225 = c_roll * z4170;
    const Scalar z4216 = s_yaw * z4174;
    const Scalar z4227 = s_yaw * z4226 - c_yaw * z4171;
    const Scalar z4247 = c_roll * s_steer + s_roll * z4245;
    const Scalar z4246 = s_roll * s_steer - c_roll * z4245;
    const Scalar z4249 = c_yaw * z4248 + s_yaw * z4247;
    const Scalar z4251 = s_yaw * z4248 - c_yaw * z4247;
    const Scalar z4231 = z4212 * z4225;
    const Scalar z4218 = c_yaw * z4174;
    const Scalar z4267 = v_pitch * z4197;
    const Scalar z4217 = z4173 * z4176 - z4174 * z4216;
    const Scalar z4230 = z4174 * z4229 - z4178 * z4225;
    const Scalar z4250 = z4174 * z4249 + z4176 * z4246;
    const Scalar z4268 = v_pitch * z4192;
    const Scalar z4219 = z4173 * z4178 - z4174 * z4218;
    const Scalar z4257 = v_steer * z4193;
    const Scalar z4261 = v_steer * z4188;
    const Scalar z4252 = z4174 * z4251 - z4178 * z4246;
    const Scalar z4228 = z4174 * z4227 - z4176 * z4225;
    const Scalar z4258 = z32 * z4257;
    const Scalar z4220 = z4173 * z4212;
    const Scalar z4213 = z4204 * z4212;
    const Scalar z4253 = z4212 * z4246;
    const Scalar z4259 = z31 * z4257;
    const Scalar z4232 = n2 * (z4181 * z4231 + z4180 * z4230 + z4179 * z4228);
    const Scalar z4221 = n2 * (z4179 * z4217 + z4180 * z4219 - z4181 * z4220);
    const Scalar z4254 = n2 * (z4179 * z4250 - z4180 * z4252 - z4181 * z4253);
    const Scalar z4271 = z4106 * z4267 + z4108 * z4268 + s_pitch * z4258 + c_pitch * z4259 - n2 * (z4189 * z4192 - z4190
        * z4197);
    const Scalar z4239 = s_steer * z888;
    const Scalar z4238 = s_steer * (n1 - z887);
    const Scalar z4240 = n0_08 * z4238 - n0_35 * z4239;
    const Scalar z4241 = s_steer * (n1 - z889);
    const Scalar z4242 = n0_08 * z4239 - n0_35 * z4241;
    const Scalar z4273 = z4108 * z4267 - z4106 * z4268 + s_pitch * z4259 - c_pitch * z4258 - n2 * (z4189 * z4197 + z4190
        * z4192);
    const Scalar z4260 = n0_08 * z4258 - n0_35 * z4259;
    const Scalar z4272 = z4145 * z4171 - c_roll * z4261 - c_steer * z4141 - n2 * (z4121 * z4203 - z4123 * z4193)
        + s_roll * z4271;
    const Scalar z4214 = n2 * (z4179 * z4209 - z4180 * z4211 - z4181 * z4213);
    const Scalar z4233 = n0_5 * z4232 / z4183;
    const Scalar z4222 = n0_5 * z4221 / z4183;
    const Scalar z4255 = n0_5 * z4254 / z4183;
    const Scalar z4243 = c_pitch * z4242 + s_pitch * z4240;
    const Scalar z4237 = n0_08 * z4235 - n0_35 * z4236;
    const Scalar z4224 = c_roll * z4160;
    const Scalar z4244 = s_roll * z4237 + c_roll * z4243;
    const Scalar z4274 = z4148 * z4170 - z4142 * z4173 - n2 * (z4122 * z4206 - z4126 * z4207) + c_yaw * z4273 + s_yaw
        * z4272;
    const Scalar z4215 = n0_5 * z4214 / z4183;
    const Scalar z4275 = s_roll * z4261 + c_steer * z4145 + z4141 * z4171 + n2 * (z4121 * z4193 + z4123 * z4203)
        + c_roll * z4271;
    const Scalar z4276 = n2 * z4204;
    const Scalar z4278 = z4142 * z4170 + z4148 * z4173 - n2 * (z4122 * z4207 + z4126 * z4206) + s_yaw * z4273 - c_yaw
        * z4272;
    const Scalar z4280 = n2 * (z4174 * z4275 - z4204 * z4204);
    const Scalar z4279 = z4210 * z4276 + z4178 * z4275 + z4174 * z4278;
    const Scalar z4234 = z4224 - n0_35 * z4233;
    const Scalar z4277 = z4208 * z4276 - z4176 * z4275 + z4174 * z4274;
    const Scalar z4223 = z4162 + n0_35 * z4222;
    const Scalar z4285 = q_x - z4118;
    const Scalar z4287 = q_z - z4120;
    const Scalar z4286 = q_y - z4119;
    const Scalar z4309 = q_x - z4185;
    const Scalar z4310 = q_y - z4186;
    const Scalar z4311 = q_z - z4187;
    const Scalar z4263 = z888 * z4261;
    const Scalar z4281 = n2 * (z4213 * z4213 + z4211 * z4211 + z4209 * z4209 + z4181 * z4280 - z4180 * z4279 + z4179
        * z4277);
    const Scalar z4312 = s_yaw * z4311;
    const Scalar z4262 = -z4261 * (n1 - z887);
    const Scalar z4264 = n0_35 * z4263 + n0_08 * z4262;
    const Scalar z4302 = z4117 * z4125;
    const Scalar z4256 = z4244 + n0_35 * z4255;
    const Scalar z4322 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z4323 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z4324 = s_roll * z4323;
    const Scalar z4317 = s_pitch * z31 - c_pitch * z32;
    const Scalar z4316 = s_pitch * z32 + c_pitch * z31;
    const Scalar z4318 = s_roll * z4317;
    const Scalar z4319 = c_roll * z4317;
    const Scalar z4313 = c_yaw * z4311;
    const Scalar z4321 = s_yaw * z4316 + c_yaw * z4318;
    const Scalar z4320 = s_yaw * z4318 - c_yaw * z4316;
    const Scalar z4265 = -z4261 * (n1 - z889);
    const Scalar z4266 = n0_08 * z4263 + n0_35 * z4265;
    const Scalar z4327 = s_yaw * z4322 + c_yaw * z4324;
    const Scalar z4325 = c_roll * z4323;
    const Scalar z4326 = s_yaw * z4324 - c_yaw * z4322;
    const Scalar z4328 = q_z - z4325;
    const Scalar z4292 = n0_3 * z4132 / (z4116 * z4116);
    const Scalar z4315 = s_roll * z4309 + z4110 * z4311;
    const Scalar z4291 = s_roll * z4285 + z4110 * z4287;
    const Scalar z4314 = s_roll * z4310 - z4111 * z4311;
    const Scalar z4282 = z4214 * z4215;
    const Scalar z4288 = s_yaw * z4287;
    const Scalar z4303 = v_x - z4302 + z4112 * z4292;
    const Scalar z4304 = v_x - z4303;
    const Scalar z4290 = s_roll * z4286 - z4111 * z4287;
    const Scalar z4293 = z4117 * z4128;
    const Scalar z4289 = c_yaw * z4287;
    const Scalar z4294 = v_y + z4293 - z4113 * z4292;
    const Scalar z4296 = v_z - z4117 * z4130 + z4114 * z4292;
    const Scalar z4297 = v_z - z4296;
    const Scalar z4269 = s_pitch * z4264 - z4159 * z4268 - c_pitch * z4266 + z4158 * z4267 + n2 * (z4192 * z4196 + z4197
        * z4199);
    const Scalar z4295 = v_y - z4294;
    const Scalar z4329 = q_y + z4327;
    const Scalar z4305 = c_yaw * z4297 - z4126 * z4287;
    const Scalar z4306 = z4110 * z4297;
    const Scalar z4307 = z4121 * z4285 - z4124 * z4287 + s_roll * z4304 + z4306;
    const Scalar z4298 = z4122 * z4287 + s_yaw * z4297;
    const Scalar z4299 = z4111 * z4297;
    const Scalar z4270 = z4145 * z4156 + s_roll * z4260 + z4141 * z4161 - n2 * (z4121 * z4191 + z4123 * z4200) + c_roll
        * z4269;
    const Scalar z4340 = z4167 - z4187;
    const Scalar z4333 = z4187 - z4328;
    const Scalar z4339 = z4168 - z4186;
    const Scalar z4332 = z4186 - z4329;
    const Scalar z4338 = z4169 - z4185;
    const Scalar z4341 = z4178 * z4340;
    const Scalar z4330 = q_x - z4326;
    const Scalar z4331 = z4185 - z4330;
    const Scalar z4342 = z4174 * z4339 - z4341;
    const Scalar z4336 = z4320 * z4333;
    const Scalar z4334 = z4321 * z4333;
    const Scalar z4335 = z4319 * z4332 + z4334;
    const Scalar z4337 = z4319 * z4331 - z4336;
    const Scalar z4283 = n0_5 * (z4282 / (z4183 * z4183) - z4281 / z4183);
    const Scalar z4284 = z4270 - n0_35 * z4283;
    const Scalar z4345 = s_pitch * z4199;
    const Scalar z4343 = z4176 * z4340;
    const Scalar z4344 = z4174 * z4338 + z4343;
    const Scalar z4347 = c_roll * z4191;
    const Scalar z4346 = z4345 + c_pitch * z4196 - z4159 * z4192 + z4158 * z4197;
    const Scalar z4348 = z4347 - z4123 * z4156 - z4121 * z4161 + s_roll * z4200;
    const Scalar z4359 = z31 * z4192 + z32 * z4197;
    const Scalar z4351 = n0_35 * z4215 / (z4183 * z4183);
    const Scalar z4354 = z4202 + z4184 * z4213 + z4181 * z4351;
    const Scalar z4357 = z4127 * z4311;
    const Scalar z4300 = z4121 * z4286 + z4127 * z4287 + s_roll * z4295 - z4299;
    const Scalar z4349 = s_yaw * z4346 - z4122 * z4160 + z4126 * z4162 + c_yaw * z4348;
    const Scalar z4360 = c_roll * z4359 - z4123 * z4317;
    const Scalar z4355 = v_z - z4354;
    const Scalar z4356 = z4122 * z4311 + s_yaw * z4355;
    const Scalar z4308 = v_yaw * z4304 + z4307 * (v_pitch + v_rear) - v_roll * z4305;
    const Scalar z4301 = v_yaw * z4295 - v_roll * z4298 + z4300 * (v_pitch + v_rear);
    const Scalar z4376 = z4202 - z4354;
    const Scalar z4397 = v_yaw * s_roll;
    const Scalar z4398 = v_yaw * c_roll;
    const Scalar z4403 = v_pitch + z4397;  // angular velocity of frame, y
    const Scalar z4401 = v_roll * c_pitch - s_pitch * z4398;
    const Scalar z4402 = v_roll * s_pitch + c_pitch * z4398;
    const Scalar z4367 = z31 * z4197 - z32 * z4192;
    const Scalar z4409 = z4401 * z4403;
    const Scalar z4405 = z4403 * z4403;
    const Scalar z4406 = z4402 * z4402;
    const Scalar z4408 = z4401 * z4402;
    const Scalar z4407 = z4405 + z4406;
    const Scalar z4350 = v_y - z4349;
    const Scalar z4411 = z4401 * z4401;
    const Scalar z4410 = z4402 * z4403;
    const Scalar z4361 = n0_3 * z4192 - n1_1 * z4197;
    const Scalar z4404 = v_rear + z4403;  // angular velocity of rear_wheel, y
    const Scalar z4368 = z4121 * z4317 + s_roll * z4359;
    const Scalar z4362 = n1_1 * z4192 + n0_3 * z4197;
    const Scalar z4380 = s_yaw * z4348 - c_yaw * z4346 - z4122 * z4162 - z4126 * z4160;
    const Scalar z4369 = s_yaw * z4367 - z4122 * z4316 + z4126 * z4318 - c_yaw * z4368;
    const Scalar z4352 = z4184 * z4211 - z4350 + z4180 * z4351;
    const Scalar z4412 = z4405 + z4411;
    const Scalar z4375 = z4350 + z4352;
    const Scalar z4363 = z4121 * z4323 + s_roll * z4362;
    const Scalar z4381 = v_x + z4380;
    const Scalar z4364 = z4122 * z4322 + s_yaw * z4361 - z4126 * z4324 + c_yaw * z4363;
    const Scalar z4365 = v_y + z4364;
    const Scalar z4370 = c_roll * z4362 - z4123 * z4323;
    const Scalar z4382 = z4381 - z4184 * z4209 + z4179 * z4351;
    const Scalar z4366 = z4352 + z4365;
    const Scalar z4353 = v_y + z4352;
    const Scalar z4393 = z4381 - z4382;
    const Scalar z4415 = z4108 * z4403 + z4107 * z4401 - z4109 * z4402;
    const Scalar z4413 = z4106 * z4403 - z4107 * z4402 + z4105 * z4401;
    const Scalar z4417 = z31 * v_steer;
    const Scalar z4414 = c_steer * z4403 - z4106 * z4401 + z4108 * z4402;
    const Scalar z4416 = z31 * z4415 + z32 * z4413;
    const Scalar z4387 = z4126 * z4322 - c_yaw * z4361 + z4122 * z4324 + s_yaw * z4363;
    const Scalar z4371 = v_z - z4370;
    const Scalar z4372 = z4354 - z4371;
    const Scalar z4383 = v_x - z4382;
    const Scalar z4390 = z4126 * z4316 + c_yaw * z4367 + z4122 * z4318 + s_yaw * z4368;
    const Scalar z4388 = v_x - z4387;
    const Scalar z4389 = z4382 - z4388;
    const Scalar z4385 = z4124 * z4311;
    const Scalar z4373 = z4333 * z4369;
    const Scalar z4391 = z4333 * z4390;
    const Scalar z4394 = z4208 * z4340;
    const Scalar z4399 = v_roll * z4398;  // angular acceleration of frame.2, y
    const Scalar z4400 = v_roll * z4397;  // angular acceleration of frame.2, z
    const Scalar z4377 = z4210 * z4340;
    const Scalar z4384 = c_yaw * z4355 - z4126 * z4311;
    const Scalar z4358 = z4121 * z4310 + z4357 + s_roll * z4353 - z4111 * z4355;
    const Scalar z4418 = z4413 + z4417;  // angular velocity of fork, x
    const Scalar z4419 = z32 * v_steer;
    const Scalar z4420 = z4415 - z4419;  // angular velocity of fork, z
    const Scalar z4429 = v_front + z4414;  // angular velocity of front_wheel, y
    const Scalar z4421 = z4414 * z4414;
    const Scalar z4427 = z4418 * z4418;
    const Scalar z4425 = z4414 * z4418;
    const Scalar z4428 = z4421 + z4427;
    const Scalar z4422 = z4420 * z4420;
    const Scalar z4424 = z4418 * z4420;
    const Scalar z4426 = z4414 * z4420;
    const Scalar z4430 = z4420 * z4429;
    const Scalar z4431 = z4418 * z4429;
    const Scalar z4433 = n0_28 * z4431;  // moment on front_wheel, z
    const Scalar z4423 = z4421 + z4422;
    const Scalar z4432 = n0_28 * z4430;  // moment on front_wheel, x
    const Scalar z4386 = z4121 * z4309 - z4385 + s_roll * z4383 + z4110 * z4355;
    const Scalar z4374 = z4373 - z4332 * z4360 + z4319 * z4366 - z4321 * z4372;
    const Scalar z4434 = z4422 - z4427;
    const Scalar z4436 = z4401 * z4404;
    const Scalar z4435 = z4402 * z4404;
    const Scalar z4437 = n0_12 * z4435;  // moment on rear_wheel, x
    const Scalar z4392 = z4331 * z4360 - z4391 + z4319 * z4389 - z4320 * z4372;
    const Scalar z4378 = z4174 * z4375 - z4377 - z4204 * z4339 - z4178 * z4376;
    const Scalar z4438 = n0_12 * z4436;  // moment on rear_wheel, z
    const Scalar z4395 = z4174 * z4393 - z4394 - z4204 * z4338 + z4176 * z4376;
    const Scalar z4379 = v_yaw * z4353 - v_roll * z4356 + v_pitch * z4358 - v_steer * z4374 + v_front * z4378;
    const Scalar z4447 = z449 * z4106;
    const Scalar z4439 = z4406 - z4411;
    const Scalar z4449 = z449 * z4108;
    const Scalar z4451 = z450 * z4106 + z451 * z4108;
    const Scalar z4454 = n0_3 * z4447 - z4451 + n1_1 * z4449;
    const Scalar z4448 = c_steer * z449;
    const Scalar z4450 = z451 * z4107 + z450 * z4105;
    const Scalar z4453 = n0_3 * z4448 - z4450;
    const Scalar z4441 = n0_28 * z4106;
    const Scalar z4452 = z450 * z4107 + z451 * z4109;
    const Scalar z4455 = n1_1 * z4448 - z4452;
    const Scalar z4443 = n0_28 * z4108;
    const Scalar z4442 = n0_28 * c_steer;
    const Scalar z4445 = s_pitch * z4441 + c_pitch * z4443;
    const Scalar z4444 = s_pitch * z4443 - c_pitch * z4441;
    const Scalar z4440 = z4397 * z4398;
    const Scalar z4446 = s_roll * z4442 + c_roll * z4445;
    const Scalar z4396 = v_yaw * z4383 - v_roll * z4384 + v_pitch * z4386 + v_steer * z4392 + v_front * z4395;
    const Scalar z4476 = n2_8467 * z4108;
    const Scalar z4468 = k4 * z4107;
    const Scalar z4470 = n2_8467 * z4106;
    const Scalar z4475 = k3 * z4107 + k4 * z4109;
    const Scalar z4467 = n1_04 * z4107 - n3_85 * z4109;
    const Scalar z4469 = k3 * z4105 + z4468;
    const Scalar z4477 = k5 * z4109 + z4468;
    const Scalar z4465 = n1_04 * z4105 - n3_85 * z4107;
    const Scalar z4471 = k5 * z4107 + k4 * z4105;
    const Scalar z4478 = z4106 * z4470 + z4105 * z4469 + z4107 * z4471;
    const Scalar z4473 = n2_8467 * c_steer;
    const Scalar z4483 = z4108 * z4476 + z4107 * z4475 + z4109 * z4477;
    const Scalar z4489 = n8_47 - n2_2 * z4465 + z4483;
    const Scalar z4484 = n0_63 + n0_6 * z4467 + z4478;
    const Scalar z4496 = n29_35 - z4489;
    const Scalar z4472 = k3 * z4106 + k4 * z4108;
    const Scalar z4481 = z4106 * z4476 + z4105 * z4475 + z4107 * z4477;
    const Scalar z4482 = c_steer * z4476 - z4106 * z4475 - z4108 * z4477;
    const Scalar z4487 = n2_31 + n1_1 * z4467 - n0_3 * z4465 + z4481;
    const Scalar z4495 = n17_7 - z4487;
    const Scalar z4474 = k4 * z4106 + k5 * z4108;
    const Scalar z4508 = z4484 + z4496;
    const Scalar z4480 = c_steer * z4473 + z4106 * z4472 + z4108 * z4474;
    const Scalar z4479 = z4105 * z4472 - z4106 * z4473 + z4107 * z4474;
    const Scalar z4486 = n9_1 + n0_6 * z4467 - n2_2 * z4465 + z4480;
    const Scalar z4494 = n49_25 + z4486;
    const Scalar z4509 = n2 * z4495;
    const Scalar z4510 = s_pitch * z4508 - c_pitch * z4509;
    const Scalar z4466 = n1_04 * z4106 - n3_85 * z4108;
    const Scalar z4485 = n1_1 * z4466 + z4479;
    const Scalar z4498 = n0_12 + z4494;
    const Scalar z4488 = n0_3 * z4466 + z4482;
    const Scalar z4491 = n2_1 + z4467;
    const Scalar z4493 = n51 - z4491;
    const Scalar z4490 = n7_7 - z4465;
    const Scalar z4492 = n25_5 + z4490;
    const Scalar z4511 = s_pitch * z4510;
    const Scalar z4514 = c_pitch * z4510 + z4495;
    const Scalar z4512 = z4496 - z4511;
    const Scalar z4513 = z4484 - z4511;
    const Scalar z4502 = s_pitch * z4485 - c_pitch * z4488;
    const Scalar z4515 = n39_8603 + z4513;
    const Scalar z4499 = c_pitch * z4493 + s_pitch * z4492;
    const Scalar z4457 = s_pitch * z4447 + c_pitch * z4449;
    const Scalar z4500 = s_pitch * z4493 - c_pitch * z4492;
    const Scalar z4456 = s_pitch * z4449 - c_pitch * z4447;
    const Scalar z4516 = n39_8603 - z4498;
    const Scalar z4503 = s_roll * z4500;
    const Scalar z4460 = s_roll * z4457 - c_roll * z4448;
    const Scalar z4497 = n0_12 * s_roll;
    const Scalar z4459 = s_pitch * z4453 + c_pitch * z4455;
    const Scalar z4463 = c_yaw * z4456 + s_yaw * z4460;
    const Scalar z4464 = s_yaw * z4456 - c_yaw * z4460;
    const Scalar z4507 = s_yaw * z4499 + c_yaw * z4503;
    const Scalar z4501 = s_pitch * z4488 + c_pitch * z4485;
    const Scalar z4504 = c_roll * z4500;
    const Scalar z4506 = s_yaw * z4503 - c_yaw * z4499;
    const Scalar z4462 = s_roll * z4454 - c_roll * z4459;
    const Scalar z4458 = s_pitch * z4455 - c_pitch * z4453;
    const Scalar z4518 = s_roll * z4499 - c_roll * z4466;
    const Scalar z4461 = s_roll * z4448 + c_roll * z4457;
    const Scalar z4538 = a_yaw * c_roll;
    const Scalar z4542 = v_roll * z4397 - z4538;  // angular acceleration of frame.2, z
    const Scalar z4536 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z4537 = a_yaw * s_roll;
    const Scalar z4541 = v_roll * z4398 + z4537;  // angular acceleration of frame.2, y
    const Scalar z4534 = n9_81 - a_z;
    const Scalar z4532 = s_front * z4420 + c_front * z4418;
    const Scalar z4544 = a_roll * s_pitch - c_pitch * z4542;
    const Scalar z4533 = s_front * z4418 - c_front * z4420;
    const Scalar z4549 = v_pitch * z4401 + z4544;  // angular acceleration of frame, z
    const Scalar z4535 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z4540 = s_roll * z4536 - c_roll * z4534;
    const Scalar z4543 = a_roll * c_pitch + s_pitch * z4542;
    const Scalar z4547 = v_pitch * z4402 - z4543;  // angular acceleration of frame, x
    const Scalar z4548 = a_pitch + z4541;  // angular acceleration of frame, y
    const Scalar z4539 = s_roll * z4534 + c_roll * z4536;
    const Scalar z4552 = z4409 + z4549;
    const Scalar z4545 = s_pitch * z4540 - c_pitch * z4535;
    const Scalar z4546 = s_pitch * z4535 + c_pitch * z4540;
    const Scalar z4553 = z4410 + z4547;
    const Scalar z4551 = z4408 + z4548;
    const Scalar z4554 = z4408 - z4548;
    const Scalar z4556 = c_steer * z4548 + z4106 * z4547 + z4108 * z4549;
    const Scalar z4559 = z4539 - n1_1 * z4552 - n0_3 * z4553;
    const Scalar z4531 = s_rear * z4401 + c_rear * z4402;
    const Scalar z4550 = a_rear + z4548;  // angular acceleration of rear_wheel, y
    const Scalar z4557 = z4107 * z4547 - z4108 * z4548 + z4109 * z4549;
    const Scalar z4558 = n1_1 * z4407 + z4545 - n0_3 * z4551;
    const Scalar z4560 = n0_3 * z4412 - z4546 - n1_1 * z4554;
    const Scalar z4530 = s_rear * z4402 - c_rear * z4401;
    const Scalar z4555 = z4105 * z4547 - z4106 * z4548 + z4107 * z4549;
    const Scalar z4564 = z31 * a_steer - z4555 + z4414 * z4419;  // angular acceleration of fork, x
    const Scalar z4561 = z4106 * z4559 - z4107 * z4560 + z4105 * z4558;
    const Scalar z4562 = c_steer * z4559 - z4106 * z4558 + z4108 * z4560;
    const Scalar z4563 = z4108 * z4559 - z4109 * z4560 + z4107 * z4558;
    const Scalar z4522 = z4512 - z4516;
    const Scalar z4523 = n2 * z4502;
    const Scalar z4524 = s_roll * z4522 - c_roll * z4523;
    const Scalar z4528 = s_yaw * z4500 - c_yaw * z4518;
    const Scalar z4529 = c_yaw * z4500 + s_yaw * z4518;
    const Scalar z4505 = s_roll * z4498 - c_roll * z4502;
    const Scalar z4565 = v_steer * z4416 - z4556;  // angular acceleration of fork, y
    const Scalar z4566 = z4557 + z32 * a_steer - z4414 * z4417;  // angular acceleration of fork, z
    const Scalar z4525 = s_roll * z4524;
    const Scalar z4526 = z4512 - z4525;
    const Scalar z4573 = z4429 * z4532;
    const Scalar z4576 = n0_28 * z4573;  // moment on front_wheel, z
    const Scalar z4572 = z4429 * z4533;
    const Scalar z4574 = n0_28 * z4572;  // moment on front_wheel, x
    const Scalar z4567 = z4424 + z4565;
    const Scalar z4527 = n39_8603 - z4526;
    const Scalar z4571 = a_front - z4565;  // angular acceleration of front_wheel, y
    const Scalar z4575 = n0_28 * z4571;  // moment on front_wheel, y
    const Scalar z4570 = z4424 - z4565;
    const Scalar z4568 = z4425 + z4566;
    const Scalar z4569 = z4426 + z4564;
    const Scalar z4517 = s_roll * z4466 + c_roll * z4499;
    const Scalar z4577 = s_front * z4576 - c_front * z4574;
    const Scalar z4578 = s_front * z4574 + c_front * z4576;
    const Scalar z4520 = s_yaw * z4517;
    const Scalar z4521 = c_yaw * z4517;
    const Scalar z4519 = s_roll * z4501 - c_roll * z4514;
    // moment on fork, y
    const Scalar z4583 = k31 * z4424 + k4 * z4434 + n2_5667 * z4565 - z4575 - n3_85 * z4561 - n1_04 * z4563;
    const Scalar z4626 = z4406 + z4411;
    const Scalar z4595 = n0_12 * z4550;  // moment on rear_wheel, y
    const Scalar z4629 = n2 * z4403;
    const Scalar z4582 = z4577 + k33 * z4426 + k3 * z4564 - n3_85 * z4562 - k4 * z4568;  // moment on fork, x
    const Scalar z4627 = z4410 - z4547;
    const Scalar z4584 = z4578 + k34 * z4425 + k5 * z4566 + n1_04 * z4562 - k4 * z4569;  // moment on fork, z
    const Scalar z4592 = z4404 * z4531;
    const Scalar z4594 = n0_12 * z4592;  // moment on rear_wheel, x
    const Scalar z4633 = n2 * z4531;
    const Scalar z4634 = z32 * z4414;
    const Scalar z4593 = z4404 * z4530;
    const Scalar z4596 = n0_12 * z4593;  // moment on rear_wheel, z
    const Scalar z4631 = n2 * z4530;
    const Scalar z4632 = n2 * z4404;
    const Scalar z4636 = z31 * z4414;
    const Scalar z4635 = z31 * z4420 + z32 * z4418;
    const Scalar z4598 = s_rear * z4594 - c_rear * z4596;
    const Scalar z4597 = s_rear * z4596 + c_rear * z4594;
    const Scalar z4579 = n1_04 * z4423 + n3_85 * z4567 - n7 * z4561;  // force on fork, x
    const Scalar z4638 = z31 * z4563 + z32 * z4561;
    const Scalar z4581 = n3_85 * z4428 + n1_04 * z4570 + n7 * z4563;  // force on fork, z
    const Scalar z4628 = n2 * z4401;
    const Scalar z4637 = z32 * z4562;
    const Scalar z4630 = n2 * z4402;
    const Scalar z4580 = n7 * z4562 + n1_04 * z4568 - n3_85 * z4569;  // force on fork, y
    const Scalar z4640 = z31 * z4423 + z32 * z4567;
    const Scalar z4642 = z32 * z4428 + z31 * z4570;
    const Scalar z4644 = n2 * z4414;
    const Scalar z4643 = n2 * z4418;
    const Scalar z4641 = z31 * z4568 - z32 * z4569;
    const Scalar z4639 = z31 * z4562;
    const Scalar z4585 = z4105 * z4579 - z4107 * z4581 + z4106 * z4580;
    const Scalar z4599 = n25_5 * z4407 - z4585 + n51 * z4551;  // force on frame, x
    const Scalar z4645 = n2 * z4420;
    const Scalar z4589 = c_steer * z4583;
    const Scalar z4617 = z4397 * z4397;
    const Scalar z4618 = z4398 * z4398;
    const Scalar z4619 = z4617 + z4618;
    const Scalar z4625 = z4409 - z4549;
    const Scalar z4586 = z4108 * z4581 - z4106 * z4579 + c_steer * z4580;
    const Scalar z4646 = z32 * z4644;
    const Scalar z4587 = z4107 * z4579 - z4109 * z4581 + z4108 * z4580;
    const Scalar z4601 = n51 * z4412 - z4587 + n25_5 * z4554;  // force on frame, z
    const Scalar z4647 = z31 * z4645 + z32 * z4643;
    const Scalar z4590 = z4106 * z4582 - z4589 - z4108 * z4584;
    // moment on frame, y
    const Scalar z4603 = z4595 + n29_35 * z4408 + n49_25 * z4548 + n17_7 * z4439 - n25_5 * z4546 + n51 * z4545 + n0_3
        * z4585 + n1_1 * z4587 + z4590;
    const Scalar z4608 = n39_8603 * (z4399 - z4541) + z4603;  // moment on frame.2, y
    const Scalar z4621 = z4399 - z4541;
    const Scalar z4591 = z4108 * z4583 + z4107 * z4582 - z4109 * z4584;
    // moment on frame, z
    const Scalar z4604 = z4598 + n49_25 * z4409 - n25_5 * z4539 - n29_35 * z4549 - n17_7 * z4553 - n1_1 * z4586 - z4591;
    const Scalar z4588 = z4106 * z4583 + z4105 * z4582 - z4107 * z4584;
    // moment on frame, x
    const Scalar z4602 = z4597 + n78_6 * z4410 + n51 * z4539 - n17_7 * z4552 - n0_3 * z4586 - z4588;
    const Scalar z4649 = n2 * z4532;
    const Scalar z4651 = n2 * z4533;
    const Scalar z4654 = n0_14 * z4649;
    const Scalar z4652 = n0_14 * z4651;
    const Scalar z4650 = n2 * z4429;
    const Scalar z4653 = n0_14 * z4650;
    const Scalar z4657 = k4 * z4644;
    const Scalar z4658 = n3_85 * z4644;
    const Scalar z4655 = s_front * z4654 - c_front * z4652;
    const Scalar z4656 = s_front * z4652 + c_front * z4654;
    const Scalar z4659 = n3_85 * z4643 + n1_04 * z4645;
    const Scalar z4648 = z31 * z4644;
    const Scalar z4620 = z4400 - z4542;
    const Scalar z4624 = n2 * z4398;
    const Scalar z4623 = n2 * z4397;
    const Scalar z4600 = n25_5 * z4552 - z4586 - n51 * z4553;  // force on frame, y
    const Scalar z4660 = n1_04 * z4644;
    const Scalar z4661 = n0_1435 * z4645 - z4655;
    const Scalar z4663 = z4655 + k4 * z4643 + k39 * z4645;
    const Scalar z4664 = z4656 + k40 * z4643 + k4 * z4645;
    const Scalar z4662 = k40 * z4644 + z4653;
    const Scalar z4606 = s_pitch * z4599 + c_pitch * z4601;
    const Scalar z4622 = n2 * v_roll;
    const Scalar z4607 = s_pitch * z4602 + c_pitch * z4604;
    const Scalar z4609 = n79_7206 * z4400 - z4607;  // moment on frame.2, z
    const Scalar z4605 = s_pitch * z4601 - c_pitch * z4599;
    const Scalar z4665 = k39 * z4644 + z4653;
    const Scalar z4666 = n0_1435 * z4643 - z4656;
    const Scalar z4669 = n1_1 * z4629;
    const Scalar z4667 = n0_3 * z4629;
    const Scalar z4668 = n0_3 * z4628 - n1_1 * z4630;
    const Scalar z4610 = s_roll * z4606 - c_roll * z4600;
    const Scalar z4670 = z4105 * z4658 + z4107 * z4660 + z4106 * z4659;
    const Scalar z4611 = s_roll * z4600 + c_roll * z4606;
    const Scalar z4616 = n87 * z4534 - z4611;  // force on frame.z, z
    const Scalar z4671 = c_steer * z4659 - z4106 * z4658 - z4108 * z4660;
    const Scalar z4612 = c_yaw * z4605 + s_yaw * z4610;
    const Scalar z4614 = n87 * a_x + z4612;  // force on frame.z, x
    const Scalar z4672 = z4107 * z4658 + z4109 * z4660 + z4108 * z4659;
    const Scalar z4613 = s_yaw * z4605 - c_yaw * z4610;
    const Scalar z4673 = n7 * z4667 - z4670;
    const Scalar z4674 = n7 * z4668 - z4671;
    const Scalar z4615 = n87 * a_y + z4613;  // force on frame.z, y
    const Scalar z4675 = n7 * z4669 - z4672;
    const Scalar z4704 = n0_06 * z4633;
    const Scalar z4706 = n0_06 * z4631;
    const Scalar z4705 = n0_06 * z4632;
    const Scalar z4678 = z4107 * z4657;
    const Scalar z4676 = z4105 * z4657 + z4107 * z4665 + z4106 * z4663;
    const Scalar z4683 = z4678 + z4109 * z4665 + z4108 * z4663;
    const Scalar z4679 = z4678 + z4105 * z4662 + z4106 * z4664;
    const Scalar z4677 = z4105 * z4661 - z4107 * z4666;
    const Scalar z4684 = z4107 * z4661 - z4109 * z4666;
    const Scalar z4681 = z4106 * z4661 - z4108 * z4666;
    const Scalar z4680 = c_steer * z4663 - z4106 * z4657 - z4108 * z4665;
    const Scalar z4685 = z4109 * z4657 + z4107 * z4662 + z4108 * z4664;
    const Scalar z4682 = c_steer * z4664 - z4106 * z4662 - z4108 * z4657;
    const Scalar z4688 = z4107 * z4676 - z4108 * z4677 - z4109 * z4679;
    const Scalar z4697 = z4467 * z4667 - z4688 + n0_3 * z4673;
    const Scalar z4692 = z4105 * z4683 - z4106 * z4684 - z4107 * z4685;
    const Scalar z4701 = z4465 * z4669 - z4692 - n1_1 * z4675;
    const Scalar z4686 = z4105 * z4676 - z4106 * z4677 - z4107 * z4679;
    const Scalar z4687 = c_steer * z4677 + z4106 * z4676 - z4108 * z4679;
    const Scalar z4695 = z4465 * z4667 - z4686 - n1_1 * z4673;
    const Scalar z4716 = n51 * z4629 - z4673;
    const Scalar z4710 = z4697 + z4705;
    const Scalar z4713 = z4701 - z4705;
    const Scalar z4696 = z4466 * z4667 - z4687;
    const Scalar z4721 = n39_3 * z4629 + z4710;
    const Scalar z4724 = n9_95 * z4629 - z4713;
    const Scalar z4694 = z4107 * z4683 - z4108 * z4684 - z4109 * z4685;
    const Scalar z4693 = c_steer * z4684 + z4106 * z4683 - z4108 * z4685;
    const Scalar z4703 = z4467 * z4669 - z4694 + n0_3 * z4675;
    const Scalar z4718 = n25_5 * z4629 + z4675;
    const Scalar z4715 = n17_7 * z4629;
    const Scalar z4719 = z4695 + z4715;
    const Scalar z4702 = z4466 * z4669 - z4693;
    const Scalar z4691 = z4108 * z4681 + z4107 * z4680 - z4109 * z4682;
    const Scalar z4700 = z4467 * z4668 - z4691 + n0_3 * z4674;
    const Scalar z4726 = z4703 - z4715;
    const Scalar z4689 = z4106 * z4681 + z4105 * z4680 - z4107 * z4682;
    const Scalar z4690 = c_steer * z4681 - z4106 * z4680 + z4108 * z4682;
    const Scalar z4698 = z4465 * z4668 - z4689 - n1_1 * z4674;
    const Scalar z4717 = n51 * z4628 - z4674 + n25_5 * z4630;
    const Scalar z4699 = z4466 * z4668 + z4690;
    const Scalar z4757 = n7 * z4535 - z4605;
    const Scalar z4756 = n7 * z4536 - z4610;
    const Scalar z4765 = z4517 * z4535;
    const Scalar z4708 = s_rear * z4704 - c_rear * z4706;
    const Scalar z4707 = s_rear * z4706 + c_rear * z4704;
    const Scalar z4712 = z4700 + z4708;
    const Scalar z4709 = z4696 - z4707;
    const Scalar z4711 = z4698 + z4707;
    const Scalar z4714 = z4702 - z4708;
    const Scalar z4725 = n39_3 * z4628 - z4714;
    const Scalar z4720 = n39_3 * z4630 - z4709;
    const Scalar z4723 = z4712 + n39_3 * z4628 + n17_7 * z4630;
    const Scalar z4722 = z4711 + n17_7 * z4628 + n9_95 * z4630;
    const Scalar z4727 = s_pitch * z4718 + c_pitch * z4716;
    const Scalar z4768 = z4466 * z4619 + n7 * z4539 + z4500 * z4620 + z4398 * z4727 + z4600;
    const Scalar z4767 = z4397 * z4727 - z4499 * z4619 - z4500 * z4621 + n7 * z4540 - z4606;
    const Scalar z4729 = z4719 - z4726;
    const Scalar z4730 = z4721 - z4724;
    const Scalar z4735 = s_pitch * z4729 + c_pitch * z4730;
    const Scalar z4728 = s_pitch * z4716 - c_pitch * z4718;
    const Scalar z4779 = z4500 * z4624 + z4717;
    const Scalar z4769 = z4500 * z4539;
    const Scalar z4778 = z4500 * z4623 - z4728;
    const Scalar z4731 = s_pitch * z4725 - c_pitch * z4720;
    const Scalar z4741 = n39_8603 * z4624 + z4731;
    const Scalar z4736 = s_pitch * z4735;
    const Scalar z4732 = s_pitch * z4720 + c_pitch * z4725;
    const Scalar z4744 = n39_8603 * z4622 - z4732;
    const Scalar z4737 = z4726 + z4736;
    const Scalar z4738 = z4719 - z4736;
    const Scalar z4733 = s_pitch * z4723 - c_pitch * z4722;
    const Scalar z4782 = s_roll * z4779 - c_roll * z4778;
    const Scalar z4783 = s_roll * z4778 + c_roll * z4779;
    const Scalar z4734 = s_pitch * z4722 + c_pitch * z4723;
    const Scalar z4790 = z4493 * z4546 + z4492 * z4545 + z4488 * z4627 + z4485 * z4625 - z4498 * z4626 + z4401 * z4723
        + z4402 * z4722;
    const Scalar z4796 = n7 * z4546 - z4466 * z4627 - z4493 * z4626 + z4401 * z4717 - z4601;
    const Scalar z4798 = z4466 * z4625 - z4492 * z4626 + n7 * z4545 + z4402 * z4717 - z4599;
    const Scalar z4795 = z4499 * z4536 + z4503 * z4535;
    const Scalar z4797 = z4401 * z4716 + z4402 * z4718 - z4492 * z4627 - z4493 * z4625;
    const Scalar z4745 = s_roll * z4728 - c_roll * z4717;
    const Scalar z4766 = z4466 * z4621 - z4499 * z4620 + z4398 * z4728 + z4397 * z4717;
    const Scalar z4746 = z4699 + z4737;
    const Scalar z4788 = z4719 + z4726;
    const Scalar z4787 = z4699 - z4726;
    const Scalar z4789 = z4699 - z4719;
    const Scalar z4739 = c_pitch * z4735 - z4721;
    const Scalar z4799 = z4485 * z4626 - z4604 - z4466 * z4545 - z4484 * z4625 - z4495 * z4627 + z4402 * z4787 + z4401
        * z4721;
    const Scalar z4740 = c_pitch * z4735 + z4724;
    const Scalar z4800 = z4602 + z4495 * z4625 - z4466 * z4546 - z4488 * z4626 - z4496 * z4627 + z4401 * z4789 - z4402
        * z4724;
    const Scalar z4791 = z4788 + z4485 * z4630 - z4488 * z4628;
    const Scalar z4743 = n39_8603 * z4623 + z4739;
    const Scalar z4781 = z4743 + z4502 * z4624 - z4512 * z4623;
    const Scalar z4801 = s_pitch * z4798 + c_pitch * z4796;
    const Scalar z4777 = z4466 * z4623 + z4499 * z4624;
    const Scalar z4763 = z4499 * z4540 - z4466 * z4539 + z4501 * z4620 - z4514 * z4621 - z4515 * z4619 + z4398 * z4741
        + z4397 * z4740;
    const Scalar z4748 = s_roll * z4741 - c_roll * z4740;
    const Scalar z4742 = n39_8603 * z4624 + z4733;
    const Scalar z4802 = s_pitch * z4796 - c_pitch * z4798;
    const Scalar z4780 = z4742 + z4502 * z4623 - z4516 * z4624;
    const Scalar z4793 = z4733 + z4498 * z4624 + z4502 * z4623;
    const Scalar z4747 = z4734 - z4744;
    const Scalar z4749 = s_roll * z4746 - c_roll * z4747;
    const Scalar z4772 = s_roll * z4768 - c_roll * z4767;
    const Scalar z4773 = c_roll * z4768 + s_roll * z4767;
    const Scalar z4784 = s_roll * z4780 - c_roll * z4781;
    const Scalar z4750 = s_roll * z4749;
    const Scalar z4810 = z4466 * z4628 - z4718;
    const Scalar z4751 = z4699 - z4750;
    const Scalar z4811 = z4492 * z4628 - z4493 * z4630;
    const Scalar z4805 = c_roll * z4797 + s_roll * z4802;
    const Scalar z4806 = s_roll * z4797 - c_roll * z4802;
    const Scalar z4754 = z4738 - z4751;
    const Scalar z4785 = s_yaw * z4782 - c_yaw * z4777;
    const Scalar z4786 = s_yaw * z4777 + c_yaw * z4782;
    const Scalar z4752 = s_yaw * z4745 - c_yaw * z4727;
    const Scalar z4812 = z4466 * z4630 + z4716;
    const Scalar z4753 = s_yaw * z4727 + c_yaw * z4745;
    const Scalar z4813 = z4720 + z4484 * z4630 - z4495 * z4628;
    const Scalar z4814 = z4495 * z4630 - z4725 + z4496 * z4628;
    const Scalar z4776 = s_yaw * z4766 - c_yaw * z4772;
    const Scalar z4775 = c_yaw * z4766 + s_yaw * z4772;
    const Scalar z4794 = s_roll * z4788 - c_roll * z4734;
    const Scalar z4792 = z4501 * z4619 - z4769 - z4498 * z4620 + z4502 * z4621 + z4398 * z4788 + z4397 * z4734;
    const Scalar z4809 = s_yaw * z4801 + c_yaw * z4805;
    const Scalar z4808 = s_yaw * z4805 - c_yaw * z4801;
    const Scalar z4762 = z4699 - z4738;
    const Scalar z4771 = z4500 * z4540 - z4608 + z4502 * z4620 - z4514 * z4619 + z4512 * z4621 + z4398 * z4744 + z4397
        * z4762;
    const Scalar z4761 = z4737 + z4738;
    const Scalar z4770 = z4501 * z4619 - z4769 + z4502 * z4621 + z4516 * z4620 - z4609 + z4397 * z4734 + z4398 * z4761;
    const Scalar z4760 = z4699 - z4737;
    const Scalar z4774 = c_roll * z4771 + s_roll * z4770;
    const Scalar z4764 = z4760 + z4501 * z4624 + z4514 * z4623;
    const Scalar z4755 = z4500 * z4535 + z4518 * z4536;
    const Scalar z4816 = s_pitch * z4810 - c_pitch * z4812;
    const Scalar z4815 = s_pitch * z4812 + c_pitch * z4810;
    const Scalar z4758 = s_yaw * z4757 - c_yaw * z4756;
    const Scalar z4759 = c_yaw * z4757 + s_yaw * z4756;
    const Scalar z4848 = z4456 * z4536 - z4460 * z4535;
    const Scalar z4850 = z4634 * z4660 - z4636 * z4658 + n3_85 * z4640 - n1_04 * z4642 + z31 * z4581 - z32 * z4579 - n7
        * z4638;
    const Scalar z4853 = z4636 * z4664 - n3_85 * z4637 - n1_04 * z4639 - n2_8467 * z4641 - z4634 * z4663 + z31 * z4584
        - z32 * z4582;
    const Scalar z4849 = z4636 * z4659 - z4635 * z4660 - n7 * z4637 - n3_85 * z4641 + z32 * z4580;
    const Scalar z4851 = z4635 * z4658 - z4634 * z4659 - n7 * z4639 - n1_04 * z4641 + z31 * z4580;
    const Scalar z4829 = z31 * z4657;
    const Scalar z4832 = z32 * z4657;
    const Scalar z4830 = z32 * z4665 - z4829;
    const Scalar z4833 = z31 * z4662 - z4832;
    const Scalar z4831 = z31 * z4661 + z32 * z4666;
    const Scalar z4854 = z4636 * z4657 - z4634 * z4665 - k4 * z4640 + k5 * z4642 - z4635 * z4666 + n1_04 * z4638 + z31
        * z4583;
    const Scalar z4852 = z4636 * z4662 - z4634 * z4657 - k3 * z4640 + k4 * z4642 + z4635 * z4661 + n3_85 * z4638 + z32
        * z4583;
    const Scalar z4834 = z4634 * z4830 + z4636 * z4833 - z450 * z4640 + z451 * z4642 + z449 * z4638 + z4635 * z4831;
    const Scalar z4837 = z4107 * z4830 + z4109 * z4833 + z4108 * z4831;
    const Scalar z4840 = z4837 + z4447 * z4668 - z4448 * z4667;
    const Scalar z4835 = z4105 * z4830 + z4107 * z4833 + z4106 * z4831;
    const Scalar z4836 = c_steer * z4831 - z4106 * z4830 - z4108 * z4833;
    const Scalar z4838 = z4835 + z4448 * z4669 - z4449 * z4668;
    const Scalar z4839 = z4447 * z4669 - z4836 - z4449 * z4667;
    const Scalar z4855 = z4105 * z4849 + z4106 * z4850 + z4107 * z4851;
    const Scalar z4841 = z4453 * z4625 - z4447 * z4546 - z4454 * z4626 - z4455 * z4627 + z4449 * z4545 + z4401 * z4840
        + z4402 * z4838;
    const Scalar z4842 = z4839 + z4453 * z4630 + z4455 * z4628;
    const Scalar z4857 = z4107 * z4849 + z4108 * z4850 + z4109 * z4851;
    const Scalar z4856 = c_steer * z4850 - z4106 * z4849 - z4108 * z4851;
    const Scalar z4843 = s_pitch * z4840 - c_pitch * z4838;
    const Scalar z4844 = s_pitch * z4838 + c_pitch * z4840;
    const Scalar z4845 = z4457 * z4539 + z4448 * z4540 - z4454 * z4620 - z4458 * z4619 + z4459 * z4621 + z4397 * z4844
        + z4398 * z4839;
    const Scalar z4846 = z4843 + z4454 * z4624 + z4459 * z4623;
    const Scalar z4847 = s_roll * z4839 - c_roll * z4844;
    const Scalar z4819 = c_roll * z4811 + s_roll * z4816;
    const Scalar z4820 = s_roll * z4811 - c_roll * z4816;
    const Scalar z4823 = s_yaw * z4815 + c_yaw * z4819;
    const Scalar z4822 = s_yaw * z4819 - c_yaw * z4815;
    const Scalar z4858 = z4107 * z4854 + z4105 * z4852 + z4106 * z4853;
    const Scalar z4861 = n0_3 * z4856 + z4858;
    const Scalar z4859 = c_steer * z4853 - z4106 * z4852 - z4108 * z4854;
    const Scalar z4860 = z4109 * z4854 + z4107 * z4852 + z4108 * z4853;
    const Scalar z4862 = n0_3 * z4855 - z4859 + n1_1 * z4857;
    const Scalar z4825 = s_pitch * z4707 + c_pitch * z4708;
    const Scalar z4824 = s_pitch * z4708 - c_pitch * z4707;
    const Scalar z4818 = s_pitch * z4813 - c_pitch * z4814;
    const Scalar z4817 = s_pitch * z4814 + c_pitch * z4813;
    const Scalar z4821 = s_roll * z4791 - c_roll * z4818;
    const Scalar z4826 = z4397 * z4825 - n0_12 * z4620;
    const Scalar z4828 = c_roll * z4825;
    const Scalar z4804 = s_pitch * z4799 + c_pitch * z4800;
    const Scalar z4803 = s_pitch * z4800 - c_pitch * z4799;
    const Scalar z4863 = n1_1 * z4856 + z4860;
    const Scalar z4807 = s_roll * z4790 + c_roll * z4804;
    const Scalar z4874 = z31 * z4660 + z32 * z4658 - n3_85 * z4646 - n1_04 * z4648;
    const Scalar z4876 = z4829 - k3 * z4646 - k4 * z4648 + z32 * z4662;
    const Scalar z4878 = z4832 - k4 * z4646 - k5 * z4648 + z31 * z4665;
    const Scalar z4877 = z31 * z4663 + z32 * z4664 - n2_8467 * z4647;
    const Scalar z4873 = z32 * z4659 - n3_85 * z4647;
    const Scalar z4875 = z31 * z4659 - n1_04 * z4647;
    const Scalar z4879 = z4105 * z4873 - z4106 * z4874 + z4107 * z4875;
    const Scalar z4881 = z4107 * z4873 - z4108 * z4874 + z4109 * z4875;
    const Scalar z4880 = z4106 * z4873 + z4108 * z4875 + c_steer * z4874;
    const Scalar z4865 = s_pitch * z4855 + c_pitch * z4857;
    const Scalar z4864 = s_pitch * z4857 - c_pitch * z4855;
    const Scalar z4882 = z4105 * z4876 + z4107 * z4878 + z4106 * z4877;
    const Scalar z4885 = n0_3 * z4880 - z4882;
    const Scalar z4868 = s_roll * z4865 - c_roll * z4856;
    const Scalar z4869 = s_roll * z4856 + c_roll * z4865;
    const Scalar z4884 = z4107 * z4876 + z4109 * z4878 + z4108 * z4877;
    const Scalar z4883 = c_steer * z4877 - z4106 * z4876 - z4108 * z4878;
    const Scalar z4886 = n0_3 * z4879 - z4883 + n1_1 * z4881;
    const Scalar z4872 = s_yaw * z4864 - c_yaw * z4868;
    const Scalar z4871 = c_yaw * z4864 + s_yaw * z4868;
    const Scalar z4867 = s_pitch * z4861 + c_pitch * z4863;
    const Scalar z4866 = s_pitch * z4863 - c_pitch * z4861;
    const Scalar z4870 = s_roll * z4862 - c_roll * z4867;
    const Scalar z4827 = n0_12 * z4624 + z4824;
    const Scalar z4897 = z4634 * z4655 - z4636 * z4656 + n0_28 * z4641;
    const Scalar z4887 = n1_1 * z4880 - z4884;
    const Scalar z4944 = c_yaw * z4164;
    const Scalar z4941 = s_yaw * z4164;
    const Scalar z4942 = n0_35 * z4222 / (z4183 * z4183);
    const Scalar z4945 = z4944 - z4184 * z4219 + z4180 * z4942;
    const Scalar z4938 = z4140 / (z4116 * z4116);
    const Scalar z4943 = z4941 - z4184 * z4217 + z4179 * z4942;
    const Scalar z4913 = z4166 - z4180 * z4184;
    const Scalar z4928 = z4327 - z4913;
    const Scalar z4935 = z4166 - z4913;
    const Scalar z4939 = z4112 * z4938 - z4117 * z4134;
    const Scalar z4914 = z4165 - z4179 * z4184;
    const Scalar z4926 = z4326 - z4914;
    const Scalar z4929 = z4319 * z4928 - z4334;
    const Scalar z4933 = z4165 - z4914;
    const Scalar z4936 = z4174 * z4935 - z4341;
    const Scalar z4927 = z4319 * z4926 - z4336;
    const Scalar z4934 = z4174 * z4933 - z4343;
    const Scalar z4922 = s_roll * z4913 + z4111 * z4311;
    const Scalar z4911 = z4113 * z4117;
    const Scalar z4921 = s_roll * z4914 + z4110 * z4311;
    const Scalar z4940 = z4113 * z4938 - z4117 * z4136;
    const Scalar z4912 = z4112 * z4117;
    const Scalar z4920 = s_roll * z4911 - z4111 * z4287;
    const Scalar z4919 = s_roll * z4912 - z4110 * z4287;
    const Scalar z4900 = z4105 * z4655 - z4107 * z4656;
    const Scalar z4889 = s_pitch * z4879 + c_pitch * z4881;
    const Scalar z4888 = s_pitch * z4881 - c_pitch * z4879;
    const Scalar z4948 = n2 * (c_roll * z4133 + z4112);
    const Scalar z4949 = n2 * (c_roll * z4135 + z4113);
    const Scalar z4901 = z4106 * z4655 - z4108 * z4656;
    const Scalar z4904 = z4901 + z4441 * z4630 + z4443 * z4628;
    const Scalar z4902 = z4107 * z4655 - z4109 * z4656;
    const Scalar z4903 = z4442 * z4626 + z4441 * z4625 - z4443 * z4627 + z4401 * z4902 + z4402 * z4900;
    const Scalar z4898 = z31 * z4655;
    const Scalar z4899 = z4898 + z32 * z4656 - n0_28 * z4647;
    const Scalar z4910 = z32 * z4656 + z4898;
    const Scalar z4923 = l_lambda_rear_rolls_x * z4919;
    const Scalar z4892 = c_roll * z4880 + s_roll * z4889;
    const Scalar z4893 = s_roll * z4880 - c_roll * z4889;
    const Scalar z4906 = s_pitch * z4900 + c_pitch * z4902;
    const Scalar z4907 = z4442 * z4620 - z4444 * z4619 + z4445 * z4621 + z4398 * z4901 + z4397 * z4906;
    const Scalar z4905 = s_pitch * z4902 - c_pitch * z4900;
    const Scalar z4908 = z4442 * z4624 - z4905 - z4445 * z4623;
    const Scalar z4909 = s_roll * z4901 - c_roll * z4906;
    const Scalar z4896 = s_yaw * z4888 - c_yaw * z4892;
    const Scalar z4895 = c_yaw * z4888 + s_yaw * z4892;
    const Scalar z4891 = s_pitch * z4885 + c_pitch * z4887;
    const Scalar z4890 = s_pitch * z4887 - c_pitch * z4885;
    const Scalar z4894 = c_roll * z4891 + s_roll * z4886;
    const Scalar z4959 = n2 * (z4173 * z4173 - z4174 * z4174);
    const Scalar z4972 = s_yaw * z4225;
    const Scalar z4973 = z4174 * z4972 + z4216 * z4225 + z4173 * z4227 + z4176 * z4226;
    const Scalar z4974 = c_yaw * z4225;
    const Scalar z4971 = s_roll * z4160;
    const Scalar z4954 = s_yaw * z4173;
    const Scalar z4955 = n2 * z4173;
    const Scalar z4956 = z4216 * z4955 + z4174 * (z4176 + z4954);
    const Scalar z4957 = c_yaw * z4173;
    const Scalar z4958 = z4218 * z4955 + z4174 * (z4178 + z4957);
    const Scalar z4966 = z4162 - z4184 * z4220 - z4181 * z4942;
    const Scalar z4967 = s_yaw * z4966;
    const Scalar z4950 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z4951 = n2 * (z4112 * z4948 + z4113 * z4949 - z4114 * z4950 - z4134 * z4134 - z4136 * z4136 - z4137
        * z4137);
    const Scalar z4960 = n2 * (z4181 * z4959 - z4220 * z4220 - z4217 * z4217 - z4219 * z4219 + z4179 * z4956 + z4180
        * z4958);
    const Scalar z4961 = n0_5 * (z4221 * z4222 / (z4183 * z4183) + z4960 / z4183);
    const Scalar z4968 = c_yaw * z4966;
    const Scalar z4963 = z4114 * z4938 - z4117 * z4137;
    const Scalar z4965 = c_yaw * z4963;
    const Scalar z4964 = s_yaw * z4963;
    const Scalar z4917 = l_lambda_rear_rolls_x * z4289 - l_lambda_rear_rolls_y * z4288 + l_lambda_front_rolls_x * z4313
        - l_lambda_front_rolls_y * z4312;
    const Scalar z4918 = z4765 - z4917;
    const Scalar z4952 = n0_5 * (z4138 * z4139 / (z4116 * z4116) + z4951 / z4116);
    const Scalar z4924 = l_lambda_front_rolls_x * z4921 - z4923 - l_lambda_rear_rolls_y * z4920 + l_lambda_front_rolls_y
        * z4922;
    const Scalar z4925 = z4795 - z4924;
    const Scalar z4932 = l_lambda_rear_rolls_y * z4920 + z4923;
    const Scalar z4930 = l_lambda_front_rolls_x * z4927 + l_lambda_front_rolls_y * z4929;
    const Scalar z4931 = z4848 + z4930;
    const Scalar z4962 = z4164 - n0_35 * z4961;
    const Scalar z4946 = l_lambda_rear_rolls_x * z4940 - l_lambda_rear_rolls_y * z4939 - l_lambda_front_rolls_x * z4945
        + l_lambda_front_rolls_y * z4943;
    const Scalar z4947 = z4774 + z4946;
    const Scalar z4937 = l_lambda_front_rolls_x * z4934 + l_lambda_front_rolls_y * z4936;
    const Scalar z4953 = n0_3 * z4952;
    const Scalar z4915 = l_lambda_rear_rolls_x * z4912 + l_lambda_rear_rolls_y * z4911 - l_lambda_front_rolls_x * z4914
        - l_lambda_front_rolls_y * z4913;
    const Scalar z4916 = z4755 + z4915;
    const Scalar z4975 = z4174 * z4974 + z4173 * z4229 + z4218 * z4225 + z4178 * z4226;
    const Scalar z4999 = z4324 - z4966;
    const Scalar z5009 = z4944 - z4945;
    const Scalar z5010 = z4162 - z4966;
    const Scalar z5012 = z4941 - z4943;
    const Scalar z4976 = n2 * (z4173 * z4225 - z4174 * z4226);
    const Scalar z4977 = n2 * (z4181 * z4976 - z4220 * z4231 + z4217 * z4228 + z4219 * z4230 + z4179 * z4973 + z4180
        * z4975);
    const Scalar z4990 = c_yaw * z4246;
    const Scalar z4991 = z4174 * z4990 + z4218 * z4246 + z4173 * z4251 - z4178 * z4247;
    const Scalar z4992 = n2 * (z4174 * z4247 + z4173 * z4246);
    const Scalar z4987 = s_roll * z4243 - c_roll * z4237;
    const Scalar z4988 = s_yaw * z4246;
    const Scalar z4989 = z4173 * z4249 - z4174 * z4988 + z4176 * z4247 - z4216 * z4246;
    const Scalar z5017 = n0_35 * z4233 / (z4183 * z4183);
    const Scalar z5019 = s_yaw * z4161 - c_yaw * z4971;
    const Scalar z5016 = s_yaw * z4971 + c_yaw * z4161;
    const Scalar z4998 = c_yaw * z4319;
    const Scalar z4996 = c_yaw * z4325;
    const Scalar z4997 = z4945 - z4996;
    const Scalar z5003 = s_yaw * z4319;
    const Scalar z5020 = z4180 * z5017 - z5019 - z4184 * z4230;
    const Scalar z4993 = n2 * (z4220 * z4253 - z4181 * z4992 + z4217 * z4250 - z4219 * z4252 - z4180 * z4991 + z4179
        * z4989);
    const Scalar z5025 = z4224 - z4184 * z4231 + z4181 * z5017;
    const Scalar z5001 = s_yaw * z4325;
    const Scalar z5002 = z4943 - z5001;
    const Scalar z5018 = z5016 - z4184 * z4228 + z4179 * z5017;
    const Scalar z5026 = s_yaw * z5025;
    const Scalar z5027 = c_yaw * z5025;
    const Scalar z5000 = z4318 * z4332 - z4333 * z4998 - z4319 * z4997 + z4321 * z4999;
    const Scalar z4983 = c_roll * z4309 - z4133 * z4311 + s_roll * z4943 - z4110 * z4966;
    const Scalar z5011 = z4173 * z4339 + z4218 * z4340 + z4174 * z5009 - z4178 * z5010;
    const Scalar z4981 = z4133 * z4287 - c_roll * z4285 + s_roll * z4939 + z4110 * z4963;
    const Scalar z5004 = z4318 * z4331 + z4333 * z5003 + z4319 * z5002 - z4320 * z4999;
    const Scalar z4982 = s_roll * z4945 - c_roll * z4310 - z4111 * z4966 - z4135 * z4311;
    const Scalar z5013 = z4173 * z4338 - z4216 * z4340 - z4174 * z5012 + z4176 * z5010;
    const Scalar z4980 = c_roll * z4286 + z4135 * z4287 + s_roll * z4940 + z4111 * z4963;
    const Scalar z5023 = n0_5 * (z4221 * z4233 / (z4183 * z4183) - z4977 / z4183);
    const Scalar z4978 = n0_5 * (z4222 * z4232 / (z4183 * z4183) - z4977 / z4183);
    const Scalar z5024 = z4971 - n0_35 * z5023;
    const Scalar z4979 = z4971 - n0_35 * z4978;
    const Scalar z4994 = n0_5 * (z4222 * z4254 / (z4183 * z4183) - z4993 / z4183);
    const Scalar z4995 = z4987 + n0_35 * z4994;
    const Scalar z4984 = l_lambda_rear_rolls_x * z4980;
    const Scalar z5014 = l_lambda_front_rolls_x * z5011 + l_lambda_front_rolls_y * z5013;
    const Scalar z5015 = z4907 - z5014;
    const Scalar z5007 = l_lambda_rear_rolls_y * z4981 - z4984;
    const Scalar z4985 = l_lambda_rear_rolls_y * z4981 - z4984 + l_lambda_front_touches * z4979 - l_lambda_front_rolls_y
        * z4983 + l_lambda_front_rolls_x * z4982;
    const Scalar z5008 = z4826 - z5007;
    const Scalar z5005 = l_lambda_front_touches * z4995 + l_lambda_front_rolls_x * z5000 + l_lambda_front_rolls_y
        * z5004;
    const Scalar z5021 = l_lambda_front_rolls_x * z5020 - l_lambda_front_rolls_y * z5018;
    const Scalar z5022 = z4807 + z5021;
    const Scalar z4969 = l_lambda_rear_touches * z4953 + l_lambda_rear_rolls_x * z4964 + l_lambda_rear_rolls_y * z4965
        + l_lambda_front_rolls_x * z4967 + l_lambda_front_rolls_y * z4968 - l_lambda_front_touches * z4962;
    const Scalar z5006 = z4845 + z5005;
    const Scalar z4986 = z4792 - z4985;
    const Scalar z4970 = z4763 - z4969;
    const Scalar z5031 = s_yaw * z4172 + z4175;
    const Scalar z5035 = c_yaw * z4172 - z4177;
    const Scalar z5073 = z4224 - z5025;
    const Scalar z5075 = z5016 - z5018;
    const Scalar z5072 = z5019 + z5020;
    const Scalar z5086 = n0_5 * (z4221 * z4255 / (z4183 * z4183) - z4993 / z4183);
    const Scalar z5087 = z4987 + n0_35 * z5086;
    const Scalar z5032 = c_roll * z4171;
    const Scalar z5049 = c_roll * z4248;
    const Scalar z5047 = s_roll * z4248;
    const Scalar z5037 = n2 * (z4174 * z5032 - z4225 * z4225);
    const Scalar z5045 = s_pitch * z4242 - c_pitch * z4240;
    const Scalar z5051 = s_yaw * z4245 + c_yaw * z5047;
    const Scalar z5048 = s_yaw * z5047 - c_yaw * z4245;
    const Scalar z5052 = z4174 * z5051 - z4229 * z4246 - z4225 * z4251 - z4178 * z5049;
    const Scalar z5050 = z4225 * z4249 + z4174 * z5048 - z4227 * z4246 - z4176 * z5049;
    const Scalar z5053 = n2 * (z4174 * z5049 - z4225 * z4246);
    const Scalar z5033 = n2 * z4225;
    const Scalar z5034 = z4174 * z5031 - z4227 * z5033 - z4176 * z5032;
    const Scalar z5036 = z4174 * z5035 - z4229 * z5033 - z4178 * z5032;
    const Scalar z5054 = n2 * (z4231 * z4253 + z4181 * z5053 + z4230 * z4252 - z4228 * z4250 + z4180 * z5052 + z4179
        * z5050);
    const Scalar z5038 = n2 * (z4231 * z4231 + z4181 * z5037 + z4230 * z4230 + z4228 * z4228 + z4179 * z5034 + z4180
        * z5036);
    const Scalar z5082 = s_yaw * z5045 - c_yaw * z4987;
    const Scalar z5061 = s_roll * z4316;
    const Scalar z5039 = n0_5 * (z4232 * z4233 / (z4183 * z4183) - z5038 / z4183);
    const Scalar z5079 = c_yaw * z5045 + s_yaw * z4987;
    const Scalar z5080 = n0_35 * z4255 / (z4183 * z4183);
    const Scalar z5057 = c_roll * z4316;
    const Scalar z5058 = s_roll * z4322;
    const Scalar z5068 = c_yaw * z4317 + s_yaw * z5061;
    const Scalar z5062 = s_yaw * z4317 - c_yaw * z5061;
    const Scalar z5063 = c_roll * z4322;
    const Scalar z5064 = z5025 - z5063;
    const Scalar z5083 = z5082 + z4184 * z4252 + z4180 * z5080;
    const Scalar z5066 = c_yaw * z4323 + s_yaw * z5058;
    const Scalar z5067 = z5018 - z5066;
    const Scalar z5081 = z4179 * z5080 - z5079 - z4184 * z4250;
    const Scalar z5059 = s_yaw * z4323 - c_yaw * z5058;
    const Scalar z5060 = z5020 + z5059;
    const Scalar z5041 = z4111 * z5025 + s_roll * z5020;
    const Scalar z5042 = s_roll * z5018 + z4110 * z5025;
    const Scalar z5065 = z4332 * z5057 - z4333 * z5062 - z4321 * z5064 + z4319 * z5060;
    const Scalar z5069 = z4333 * z5068 - z4331 * z5057 + z4319 * z5067 - z4320 * z5064;
    const Scalar z5074 = z4225 * z4339 + z4229 * z4340 - z4178 * z5073 + z4174 * z5072;
    const Scalar z5076 = z4225 * z4338 - z4227 * z4340 + z4174 * z5075 + z4176 * z5073;
    const Scalar z5030 = c_roll * z4161;
    const Scalar z5040 = z5030 - n0_35 * z5039;
    const Scalar z5046 = c_roll * z5045;
    const Scalar z5055 = n0_5 * (z4233 * z4254 / (z4183 * z4183) + z5054 / z4183);
    const Scalar z5056 = z5046 + n0_35 * z5055;
    const Scalar z5077 = l_lambda_front_rolls_x * z5074 + l_lambda_front_rolls_y * z5076;
    const Scalar z5078 = z4903 - z5077;
    const Scalar z5043 = l_lambda_front_touches * z5040 - l_lambda_front_rolls_y * z5042 + l_lambda_front_rolls_x
        * z5041;
    const Scalar z5070 = l_lambda_front_rolls_x * z5065 - l_lambda_front_rolls_y * z5069 - l_lambda_front_touches
        * z5056;
    const Scalar z5071 = z4841 + z5070;
    const Scalar z5084 = l_lambda_front_rolls_x * z5083 - l_lambda_front_rolls_y * z5081;
    const Scalar z5085 = z4870 - z5084;
    const Scalar z5044 = z4790 + z5043;
    const Scalar z5028 = l_lambda_front_rolls_x * z5026 + l_lambda_front_rolls_y * z5027 + l_lambda_front_touches
        * z5024;
    const Scalar z5029 = z4803 + z5028;
    const Scalar z5123 = k33 * z4426 + z4432 + k3 * z4564 - n3_85 * z4562 - k4 * z4568;  // moment on fork, x
    const Scalar z5124 = k34 * z4425 + z4433 + k5 * z4566 + n1_04 * z4562 - k4 * z4569;  // moment on fork, z
    const Scalar z5133 = z4400 + z4542;
    const Scalar z5116 = z5082 - z5083;
    const Scalar z5119 = z5079 + z5081;
    const Scalar z5093 = n0_5 * (z4232 * z4255 / (z4183 * z4183) + z5054 / z4183);
    const Scalar z5094 = z5046 + n0_35 * z5093;
    const Scalar z5127 = z4108 * z4583 + z4107 * z5123 - z4109 * z5124;
    const Scalar z5125 = z4106 * z4583 + z4105 * z5123 - z4107 * z5124;
    // moment on frame, z
    const Scalar z5130 = z4438 - n25_5 * z4539 + n9_95 * z4552 - n17_7 * z4553 - n1_1 * z4586 - z5127;
    // moment on frame, x
    const Scalar z5128 = z4437 + n51 * z4539 - n17_7 * z4552 + n39_3 * z4553 - n0_3 * z4586 - z5125;
    const Scalar z5138 = a_z - a_roll * z4140 - z4154;
    const Scalar z5139 = a_z + a_roll * z4223 - a_pitch * z4234 - a_steer * z4256 + z4284;
    const Scalar z5141 = a_y - z4291 * (a_pitch + a_rear) - a_yaw * z4285 + a_roll * z4289 - z4308;
    const Scalar z5126 = z4106 * z5123 - z4589 - z4108 * z5124;
    // moment on frame, y
    const Scalar z5129 = z4595 + n29_35 * z4408 + n49_25 * z4548 + n17_7 * z4439 - n25_5 * z4546 + n51 * z4545 + n0_3
        * z4585 + n1_1 * z4587 + z5126;
    const Scalar z5137 = z31 * z5123 + z32 * z5124;
    const Scalar z5140 = a_x + a_yaw * z4310 - a_roll * z4312 + a_pitch * z4314 + a_steer * z4335 + a_front * z4342
        + z4379;
    const Scalar z5142 = a_y - a_yaw * z4309 + a_roll * z4313 - a_pitch * z4315 - a_steer * z4337 - a_front * z4344
        - z4396;
    const Scalar z5143 = z4290 * (a_pitch + a_rear) + a_x + a_yaw * z4286 - a_roll * z4288 + z4301;
    const Scalar z5107 = n2 * (z4246 * z4251 + z4174 * z4178);
    const Scalar z5108 = n2 * (z4174 * z4174 - z4246 * z4246);
    const Scalar z5088 = z4184 * z4253 - z4244 + z4181 * z5080;
    const Scalar z5117 = z4244 + z5088;
    const Scalar z5089 = s_yaw * z5088;
    const Scalar z5090 = c_yaw * z5088;
    const Scalar z5095 = s_roll * z5083 + z4111 * z5088;
    const Scalar z5096 = z4110 * z5088 + s_roll * z5081;
    const Scalar z5106 = n2 * (z4174 * z4176 - z4246 * z4249);
    const Scalar z5109 = n2 * (z4180 * z5107 - z4253 * z4253 - z4181 * z5108 - z4250 * z4250 - z4252 * z4252 + z4179
        * z5106);
    const Scalar z5144 = v_yaw * z4914;
    const Scalar z5112 = z4319 * z5083 - z4321 * z5088;
    const Scalar z5113 = z4319 * z5081 - z4320 * z5088;
    const Scalar z5118 = z4246 * z4339 + z4251 * z4340 + z4174 * z5116 - z4178 * z5117;
    const Scalar z5100 = c_steer * z888;
    const Scalar z5120 = z4246 * z4338 + z4249 * z4340 + z4176 * z5117 + z4174 * z5119;
    const Scalar z5110 = n0_5 * (z4254 * z4255 / (z4183 * z4183) + z5109 / z4183);
    const Scalar z5099 = c_steer * (n1 - z887);
    const Scalar z5101 = n0_08 * z5099 - n0_35 * z5100;
    const Scalar z5102 = c_steer * (n1 - z889);
    const Scalar z5103 = n0_08 * z5100 - n0_35 * z5102;
    const Scalar z5145 = v_roll * z4313 - z5144 - v_pitch * z4921 - v_steer * z4927 + v_front * z4934;
    const Scalar z5104 = c_pitch * z5103 + s_pitch * z5101;
    const Scalar z5146 = v_roll * z4313 - z5144 - v_pitch * z4921 - v_steer * z4927 + v_front * z4934 - z4353;
    const Scalar z5105 = c_roll * z5104 - z4163;
    const Scalar z5147 = z4380 - z4184 * z4209 + z4179 * z4351;
    const Scalar z5148 = z4385 - z4121 * z4914 + s_roll * z5147 - z4110 * z4355;
    const Scalar z5111 = z5105 + n0_35 * z5110;
    const Scalar z5149 = z4387 + z5147;
    const Scalar z5150 = z4360 * z4926 - z4391 + z4319 * z5149 - z4320 * z4372;
    const Scalar z5114 = l_lambda_front_rolls_x * z5112 - l_lambda_front_touches * z5111 - l_lambda_front_rolls_y
        * z5113;
    const Scalar z5121 = l_lambda_front_rolls_x * z5118 + l_lambda_front_rolls_y * z5120;
    const Scalar z5122 = z4897 + z5121;
    const Scalar z5131 = s_pitch * z5130 - c_pitch * z5128;
    const Scalar z5115 = z4834 + z5114;
    const Scalar z5134 = n0_5603 * (a_roll + z4440) + z5131;  // moment on frame.2, x
    const Scalar z5132 = s_pitch * z5128 + c_pitch * z5130;
    const Scalar z5135 = z5132 - n0_5603 * z5133;  // moment on frame.2, z
    const Scalar z5097 = l_lambda_front_rolls_x * z5095 - l_lambda_front_rolls_y * z5096 - l_lambda_front_touches
        * z5094;
    const Scalar z5098 = z4862 - z5097;
    const Scalar z5136 = s_roll * z5129 + c_roll * z5135;
    const Scalar z5091 = l_lambda_front_rolls_x * z5089 + l_lambda_front_rolls_y * z5090 - l_lambda_front_touches
        * z5087;
    const Scalar z5092 = z4866 + z5091;
    const Scalar z5151 = z4380 - z5147;
    const Scalar z5152 = z4204 * z4933 - z4394 + z4174 * z5151 + z4176 * z4376;
    const Scalar z5158 = z4113 * z4292 - z4293;
    const Scalar z5176 = z4112 * z4292 - z4302;
    const Scalar z5159 = z4121 * z4911 + z4127 * z4287 + s_roll * z5158 - z4299;
    const Scalar z5153 = v_yaw * z5147 + v_pitch * z5148 + v_roll * z4384 - v_steer * z5150 - v_front * z5152;
    const Scalar z5154 = a_yaw * z4914 - a_roll * z4313 + a_pitch * z4921 + a_steer * z4927 - a_front * z4934 - z5153;
    const Scalar z5160 = v_yaw * z5158 - v_roll * z4298 + z5159 * (v_pitch + v_rear);
    const Scalar z5177 = z4121 * z4912 + z4124 * z4287 + s_roll * z5176 - z4306;
    const Scalar z5178 = v_yaw * z5176 + z5177 * (v_pitch + v_rear) + v_roll * z4305;
    const Scalar z5161 = z4920 * (a_pitch + a_rear) + a_yaw * z4911 - a_roll * z4288 + z5160;
    const Scalar z5155 = v_yaw * z4911;
    const Scalar z5183 = c_yaw * z4121 - s_roll * z4126;
    const Scalar z5179 = z4919 * (a_pitch + a_rear) + a_yaw * z4912 + a_roll * z4289 + z5178;
    const Scalar z5173 = v_yaw * z4912;
    const Scalar z5184 = c_roll * z4127;
    const Scalar z5211 = z4204 * z4216;
    const Scalar z5185 = z4111 * z4123 + z4121 * z4135 + s_roll * z5183 + z5184;
    const Scalar z5188 = z4125 * z4134;
    const Scalar z5186 = c_roll * z4121;
    const Scalar z5210 = s_yaw * z4204 - z4122 * z4174;
    const Scalar z5214 = z4204 * z4218;
    const Scalar z5181 = z4121 * z4133;
    const Scalar z5213 = z4126 * z4174 + c_yaw * z4204;
    const Scalar z5180 = s_yaw * z4121 + s_roll * z4122;
    const Scalar z5187 = n2 * (s_roll * z4123 - z5186);
    const Scalar z5197 = z4129 * z4143 - n4 * z5186;
    const Scalar z5212 = z4176 * z4206 - z5211 - z4174 * z5210 + z4173 * z4208;
    const Scalar z5215 = z5214 - z4178 * z4206 + z4174 * z5213 + z4173 * z4210;
    const Scalar z5182 = z4110 * z4123 + z5181 + s_roll * z5180 + c_roll * z4124;
    const Scalar z5189 = n2 * (z4113 * z5185 - z5188 - z4130 * z4137 - z4114 * z5187 - z4128 * z4136 + z4112 * z5182);
    const Scalar z5190 = z4131 * z4139;
    const Scalar z5205 = n4 * z4121 * z4123 + n2 * (s_roll * z4141 + c_roll * z4145);
    const Scalar z5201 = s_yaw * z4145 + s_roll * z4142 - z4122 * z4146;
    const Scalar z5202 = z4133 * z4145 - z4110 * z4141 - n2 * (z4121 * z5180 - z4123 * z4124) + s_roll * z5201 - c_roll
        * z4144;
    const Scalar z5191 = n0_5 * (z5190 / (z4116 * z4116) + z5189 / z4116);
    const Scalar z5193 = z4122 * z4129 + s_yaw * z4146;
    const Scalar z5194 = z4110 * z4143 + s_roll * z5193 + n2 * (c_roll * z4124 + z5181);
    const Scalar z5195 = c_yaw * z4146 - z4126 * z4129;
    const Scalar z5196 = z4111 * z4143 + s_roll * z5195 + n2 * (z4121 * z4135 + z5184);
    const Scalar z5203 = c_yaw * z4145 + s_roll * z4148 + z4126 * z4146;
    const Scalar z5204 = z4135 * z4145 - z4111 * z4141 - n2 * (z4121 * z5183 - z4123 * z4127) + s_roll * z5203 - c_roll
        * z4149;
    const Scalar z5198 = n2 * (z4112 * z5194 + z4113 * z5196 - z4114 * z5197) - n4 * (z5188 + z4130 * z4137 + z4128
        * z4136);
    const Scalar z5206 = n4 * (z4128 * z5185 - z4130 * z5187 + z4125 * z5182) + n2 * (z4114 * z5205 - z4137 * z4151
        + z4134 * z4147 + z4136 * z4150 + z4112 * z5202 + z4113 * z5204);
    const Scalar z5207 = n0_5 * (z4132 * z5189 / (z4116 * z4116) + z4139 * z4152 / (z4116 * z4116) - z5206 / z4116
        + z4131 * z5191 / (z4116 * z4116)) + z4132 * z5190 / (z4116 * z4116 * z4116);
    const Scalar z5199 = n0_5 * (z4132 * z4138 / (z4116 * z4116) + z5190 / (z4116 * z4116) + z5198 / z4116);
    const Scalar z5192 = n0_3 * z5191;
    const Scalar z5200 = n0_3 * z5199;
    const Scalar z5162 = v_yaw * z4913;
    const Scalar z5156 = v_roll * z4288 - z5155 - z4920 * (v_pitch + v_rear);
    const Scalar z5157 = v_roll * z4288 - z5155 - z4920 * (v_pitch + v_rear) + z4304;
    const Scalar z5222 = n2 * (s_roll * z4200 + z4347) - z4143 * z4156 - z4146 * z4161;
    const Scalar z5208 = n0_3 * z5207;
    const Scalar z5216 = n2 * (z4173 * z4204 + z4174 * z4206);
    const Scalar z5209 = a_roll * z4953 + z5208;
    const Scalar z5217 = z4213 * z4220;
    const Scalar z5218 = n2 * (z5217 - z4181 * z5216 - z4211 * z4219 + z4179 * z5212 - z4180 * z5215 + z4209 * z4217);
    const Scalar z5219 = z4214 * z4222;
    const Scalar z5163 = z5162 + v_roll * z4312 + v_pitch * z4922 + v_steer * z4929 - v_front * z4936;
    const Scalar z5164 = z5162 + v_roll * z4312 + v_pitch * z4922 + v_steer * z4929 - v_front * z4936 + z4383;
    const Scalar z5223 = z4143 * z4171 - c_steer * z4146 + n2 * (s_roll * z4193 - c_roll * z4203);
    const Scalar z5224 = s_yaw * z5223 - z4122 * z4212;
    const Scalar z5174 = z5173 + v_roll * z4289 + z4919 * (v_pitch + v_rear);
    const Scalar z5175 = z5173 + v_roll * z4289 + z4919 * (v_pitch + v_rear) - z4295;
    const Scalar z5220 = n0_5 * (z5219 / (z4183 * z4183) - z5218 / z4183);
    const Scalar z5165 = z4349 + z4184 * z4211 + z4180 * z4351;
    const Scalar z5225 = c_steer * z4143 + z4146 * z4171 + n2 * (s_roll * z4203 + z4205);
    const Scalar z5167 = z4364 + z5165;
    const Scalar z5168 = z4360 * z4928 + z4373 + z4319 * z5167 - z4321 * z4372;
    const Scalar z5166 = z4357 - z4121 * z4913 + s_roll * z5165 - z4111 * z4355;
    const Scalar z5226 = z4176 * z5225 - z4174 * z5224 + n2 * (z4173 * z4208 - z5211);
    const Scalar z5227 = z4126 * z4212 + c_yaw * z5223;
    const Scalar z5228 = z4174 * z5227 - z4178 * z5225 + n2 * (z4173 * z4210 + z5214);
    const Scalar z5169 = z4349 - z5165;
    const Scalar z5170 = z4204 * z4935 + z4377 + z4174 * z5169 + z4178 * z4376;
    const Scalar z5229 = n4 * z4173 * z4204 + z4212 * z5225;
    const Scalar z5221 = z4348 - n0_35 * z5220;
    const Scalar z5230 = n4 * (z5217 - z4211 * z4219 + z4209 * z4217) + n2 * (z4179 * z5226 - z4180 * z5228 - z4181
        * z5229);
    const Scalar z5171 = v_yaw * z5165 - v_roll * z4356 + v_pitch * z5166 - v_steer * z5168 - v_front * z5170;
    const Scalar z5172 = a_yaw * z4913 + a_roll * z4312 + a_pitch * z4922 + a_steer * z4929 - a_front * z4936 - z5171;
    const Scalar z5233 = z4145 * z4161 - z4141 * z4156 - c_roll * z4260 + n2 * (z4121 * z4200 - z4123 * z4191) + s_roll
        * z4269;
    const Scalar z5267 = n0_6 * z4132 * z4139 / (z4116 * z4116 * z4116) + z5192 / (z4116 * z4116);
    const Scalar z5269 = z4117 * z5187 - z4130 * z4938 - z4137 * z4292 + z4114 * z5267;
    const Scalar z5268 = z4112 * z5267 - z4117 * z5182 - z4125 * z4938 - z4134 * z4292;
    const Scalar z5231 = n0_5 * (z5219 / (z4183 * z4183) - z5230 / z4183 + z4215 * z4221 / (z4183 * z4183));
    const Scalar z5232 = z5222 - n0_35 * z5231;
    const Scalar z5292 = z4113 * z5267 - z4117 * z5185 - z4128 * z4938 - z4136 * z4292;
    const Scalar z5271 = z4123 * z4285 + z4287 * z5180 - c_roll * z4304 + z4121 * z4939 - z4124 * z4963 + z4133 * z4297
        + z4110 * z5269 + s_roll * z5268;
    const Scalar z5238 = n4 * z4204;
    const Scalar z5239 = n2 * (z4173 * z4275 - z4174 * z4272) - z4206 * z5238;
    const Scalar z5236 = z4148 * z4174 - z4126 * z4276 + c_yaw * z4275;
    const Scalar z5234 = z4142 * z4174 + z4122 * z4276 + s_yaw * z4275;
    const Scalar z5294 = z4287 * z5183 - z4123 * z4286 + c_roll * z4295 + z4121 * z4940 - z4127 * z4963 + z4135 * z4297
        + z4111 * z5269 + s_roll * z5292;
    const Scalar z5237 = n2 * (z4204 * z5213 + z4206 * z4210) - z4178 * z4272 - z4218 * z4275 + z4173 * z4278 - z4174
        * z5236;
    const Scalar z5235 = z4176 * z4272 + z4216 * z4275 - n2 * (z4204 * z5210 - z4206 * z4208) + z4173 * z4274 + z4174
        * z5234;
    const Scalar z5240 = n4 * (z4213 * z5216 + z4209 * z5212 + z4211 * z5215) + n2 * (z4181 * z5239 - z4220 * z4280
        - z4219 * z4279 + z4217 * z4277 - z4180 * z5237 + z4179 * z5235);
    const Scalar z5241 = n0_5 * (z5240 / z4183 - z4222 * z4281 / (z4183 * z4183) - z4215 * z5218 / (z4183 * z4183)
        + z4214 * z5220 / (z4183 * z4183)) + z4222 * z4282 / (z4183 * z4183 * z4183);
    const Scalar z5299 = z4126 * z4171;
    const Scalar z5301 = c_roll * z4207 - z4123 * z4170;
    const Scalar z5298 = z4121 * z4170 + s_roll * z4207;
    const Scalar z5300 = z4122 * z4226 + z5299 - c_yaw * z4203 + s_yaw * z5298;
    const Scalar z5247 = n0_7 * z4215;
    const Scalar z5248 = z4222 * z5247 / (z4183 * z4183 * z4183) + n0_35 * z5220 / (z4183 * z4183);
    const Scalar z5244 = v_roll * z4967;
    const Scalar z5246 = v_yaw * z4945 - z5244 + z4356 + v_steer * z5000 - v_front * z5011 + v_pitch * z4982;
    const Scalar z5245 = v_yaw * z4945 - z5244 + v_steer * z5000 - v_front * z5011 + v_pitch * z4982;
    const Scalar z5242 = z5233 - n0_35 * z5241;
    const Scalar z5243 = a_roll * z4962 + a_pitch * z4979 + a_steer * z4995 - z5242;
    const Scalar z5303 = z4122 * z4171 - z4126 * z4226 + s_yaw * z4203 + c_yaw * z5298;
    const Scalar z5251 = z4348 - z4184 * z5216 + z4213 * z4942 + z4220 * z4351 + z4181 * z5248;
    const Scalar z5256 = z4363 + z5251;
    const Scalar z5260 = z4348 - z5251;
    const Scalar z5304 = z4204 * z4229;
    const Scalar z5307 = z4211 * z4230;
    const Scalar z5306 = n2 * (z4174 * z5301 - z4204 * z4225);
    const Scalar z5305 = z4174 * z5303 - z5304 - z4178 * z5301 - z4210 * z4225;
    const Scalar z5302 = z4174 * z5300 - z4176 * z5301 - z4204 * z4227 + z4208 * z4225;
    const Scalar z5274 = v_yaw * z4943;
    const Scalar z5276 = v_roll * z4968 + z5274 + v_pitch * z4983 - v_steer * z5004 + v_front * z5013 - z4384;
    const Scalar z5275 = v_roll * z4968 + z5274 + v_pitch * z4983 - v_steer * z5004 + v_front * z5013;
    const Scalar z5308 = n2 * (z5307 + z4213 * z4231 + z4181 * z5306 - z4209 * z4228 + z4180 * z5305 + z4179 * z5302);
    const Scalar z5297 = z4123 * z4160 + c_roll * z4346;
    const Scalar z5264 = v_yaw * z4939;
    const Scalar z5266 = v_roll * z4965 - z5264 - z4305 - z4981 * (v_pitch + v_rear);
    const Scalar z5265 = v_roll * z4965 - z5264 - z4981 * (v_pitch + v_rear);
    const Scalar z5257 = c_yaw * z4360 - z4126 * z4319;
    const Scalar z5249 = c_yaw * z4201 - z4126 * z4164;
    const Scalar z5277 = z4122 * z4164 + s_yaw * z4201;
    const Scalar z5250 = z5249 - z4184 * z5215 + z4211 * z4942 - z4219 * z4351 + z4180 * z5248;
    const Scalar z5278 = z5277 + z4184 * z5212 - z4209 * z4942 - z4217 * z4351 + z4179 * z5248;
    const Scalar z5309 = z4214 * z4233;
    const Scalar z5310 = n0_5 * (z5309 / (z4183 * z4183) + z5308 / z4183);
    const Scalar z5283 = z4122 * z4319 + s_yaw * z4360;
    const Scalar z5289 = v_yaw * z4940;
    const Scalar z5291 = v_roll * z4964 + z5289 - z4298 + z4980 * (v_pitch + v_rear);
    const Scalar z5253 = z4123 * z4310 - z4311 * z5183 + z4121 * z4945 + z4127 * z4966 - c_roll * z4353 - z4135 * z4355
        + s_roll * z5250 + z4111 * z5251;
    const Scalar z5280 = z4121 * z4943 - z4123 * z4309 - z4311 * z5180 + z4124 * z4966 + c_roll * z4383 - z4133 * z4355
        + s_roll * z5278 + z4110 * z5251;
    const Scalar z5290 = v_roll * z4964 + z5289 + z4980 * (v_pitch + v_rear);
    const Scalar z5259 = z5249 - z5250;
    const Scalar z5261 = z4173 * z4375 - z4206 * z4339 - z4340 * z5213 - z4204 * z5009 - z4210 * z5010 + z4218 * z4376
        + z4174 * z5259 + z4178 * z5260;
    const Scalar z5285 = z5277 - z5278;
    const Scalar z5286 = z4340 * z5210 - z4206 * z4338 + z4204 * z5012 - z4208 * z5010 + z4173 * z4393 - z4216 * z4376
        - z4174 * z5285 - z4176 * z5260;
    const Scalar z5311 = z5297 + n0_35 * z5310;
    const Scalar z5254 = c_yaw * z4370 - z4126 * z4325;
    const Scalar z5281 = z4122 * z4325 + s_yaw * z4370;
    const Scalar z5255 = z5250 - z5254;
    const Scalar z5282 = z5278 - z5281;
    const Scalar z5252 = s_yaw * z5251 - z4122 * z4966;
    const Scalar z5258 = z4333 * z5257 - z4332 * z4368 + z4360 * z4997 + z4369 * z4999 + z4318 * z4366 + z4372 * z4998
        + z4319 * z5255 - z4321 * z5256;
    const Scalar z5284 = z4331 * z4368 + z4333 * z5283 + z4360 * z5002 - z4390 * z4999 + z4318 * z4389 + z4372 * z5003
        + z4319 * z5282 - z4320 * z5256;
    const Scalar z5262 = v_yaw * z5250 + v_roll * z5252 + v_pitch * z5253 - v_steer * z5258 - v_front * z5261;
    const Scalar z5263 = a_yaw * z4945 - a_roll * z4967 + a_pitch * z4982 + a_steer * z5000 - a_front * z5011 + z5262;
    const Scalar z5328 = z4159 * z4267 + s_pitch * z4266 + c_pitch * z4264 + z4158 * z4268 + n2 * (z4192 * z4199 - z4196
        * z4197);
    const Scalar z5279 = z4126 * z4966 + c_yaw * z5251;
    const Scalar z5287 = v_yaw * z5278 - v_roll * z5279 + v_pitch * z5280 - v_steer * z5284 + v_front * z5286;
    const Scalar z5329 = z4141 * z4160 - z4143 * z4346 + c_roll * z5328;
    const Scalar z5312 = n2 * z4197;
    const Scalar z5313 = n2 * z4192;
    const Scalar z5314 = z4158 * z5312 - z4159 * z5313 + n2 * (c_pitch * z4196 + z4345);
    const Scalar z5316 = z4106 * z5312 + z4108 * z5313 + n2 * (s_pitch * z4190 - c_pitch * z4189);
    const Scalar z5318 = z4106 * z5313 - z4108 * z5312 + n2 * (s_pitch * z4189 + c_pitch * z4190);
    const Scalar z5288 = a_yaw * z4943 + a_roll * z4968 + a_pitch * z4983 - a_steer * z5004 + a_front * z5013 + z5287;
    const Scalar z5315 = z4143 * z4160 + c_roll * z5314;
    const Scalar z5317 = z4146 * z4170 + s_roll * z5316;
    const Scalar z5319 = n2 * (z4122 * z4226 + z5299) - c_yaw * z5318 + s_yaw * z5317;
    const Scalar z5322 = n2 * (z4122 * z4171 - z4126 * z4226) + s_yaw * z5318 + c_yaw * z5317;
    const Scalar z5320 = c_roll * z5316 - z4143 * z4170;
    const Scalar z5323 = z4174 * z5322 - z4178 * z5320 - n2 * (z4210 * z4225 + z5304);
    const Scalar z5321 = z4174 * z5319 - z4176 * z5320 - n2 * (z4204 * z4227 - z4208 * z4225);
    const Scalar z5324 = z4212 * z5320 - z4225 * z5238;
    const Scalar z5270 = c_yaw * z5269 - z4126 * z4963;
    const Scalar z5325 = n2 * (z4181 * z5324 + z4179 * z5321 + z4180 * z5323) - n4 * (z4209 * z4228 - z5307 - z4213
        * z4231);
    const Scalar z5272 = v_yaw * z5268 - v_roll * z5270 + z5271 * (v_pitch + v_rear);
    const Scalar z5273 = z4981 * (a_pitch + a_rear) + a_yaw * z4939 - a_roll * z4965 + z5272;
    const Scalar z5345 = s_roll * z4346 - z4121 * z4160;
    const Scalar z5293 = z4122 * z4963 + s_yaw * z5269;
    const Scalar z5295 = v_roll * z5293 + v_yaw * z5292 + z5294 * (v_pitch + v_rear);
    const Scalar z5326 = n0_5 * (z5325 / z4183 + z5309 / (z4183 * z4183) + z4215 * z4232 / (z4183 * z4183));
    const Scalar z5332 = z4141 * z4170 + z4143 * z4207 + c_roll * z4273;
    const Scalar z5330 = z4145 * z4170 - z4146 * z4207 + s_roll * z4273;
    const Scalar z5296 = z4980 * (a_pitch + a_rear) + a_yaw * z4940 + a_roll * z4964 + z5295;
    const Scalar z5380 = z32 * z4193;
    const Scalar z5381 = z31 * z4193;
    const Scalar z5384 = z888 * z4188;
    const Scalar z5383 = -z4188 * (n1 - z887);
    const Scalar z5385 = n0_35 * z5384 + n0_08 * z5383;
    const Scalar z5336 = z5238 * z5301 + n2 * (z4174 * z5332 + z4225 * z4275);
    const Scalar z5327 = z5315 + n0_35 * z5326;
    const Scalar z5388 = z4192 * z4240;
    const Scalar z5386 = -z4188 * (n1 - z889);
    const Scalar z5387 = n0_08 * z5384 + n0_35 * z5386;
    const Scalar z5334 = z4142 * z4171 + z4148 * z4226 - n2 * (z4122 * z4203 - z4126 * z5298) + s_yaw * z4271 + c_yaw
        * z5330;
    const Scalar z5331 = z4142 * z4226 - z4148 * z4171 - n2 * (z4126 * z4203 + z4122 * z5298) - c_yaw * z4271 + s_yaw
        * z5330;
    const Scalar z5335 = n2 * (z4204 * z5303 + z4210 * z5301) - z4178 * z5332 + z4229 * z4275 + z4174 * z5334 - z4225
        * z4278;
    const Scalar z5333 = z4227 * z4275 - z4176 * z5332 + n2 * (z4204 * z5300 - z4208 * z5301) + z4174 * z5331 + z4225
        * z4274;
    const Scalar z5337 = n4 * (z4209 * z5302 - z4211 * z5305 - z4213 * z5306) + n2 * (z4181 * z5336 - z4231 * z4280
        + z4230 * z4279 - z4228 * z4277 + z4180 * z5335 + z4179 * z5333);
    const Scalar z5338 = n0_5 * (z4215 * z5308 / (z4183 * z4183) - z4233 * z4281 / (z4183 * z4183) - z5337 / z4183
        + z4214 * z5310 / (z4183 * z4183)) + z4233 * z4282 / (z4183 * z4183 * z4183);
    const Scalar z5344 = z4233 * z5247 / (z4183 * z4183 * z4183) + n0_35 * z5310 / (z4183 * z4183);
    const Scalar z5348 = z4213 * z5017 - z5297 - z4184 * z5306 - z4231 * z4351 + z4181 * z5344;
    const Scalar z5361 = z5297 + z5348;
    const Scalar z5392 = z4197 * z4236;
    const Scalar z5395 = z4192 * z4236;
    const Scalar z5397 = z4126 * z4248;
    const Scalar z5393 = z5392 + s_pitch * z5380 - z4192 * z4235 + c_pitch * z5381;
    const Scalar z5396 = s_pitch * z5381 - z5395 - z4197 * z4235 - c_pitch * z5380;
    const Scalar z5339 = z5329 + n0_35 * z5338;
    const Scalar z5399 = s_steer * z4121;
    const Scalar z5340 = a_roll * z5024 + a_pitch * z5040 + a_steer * z5056 + z5339;
    const Scalar z5389 = z4197 * z4242 - z5388 + s_pitch * z5385 - c_pitch * z5387;
    const Scalar z5400 = s_roll * z4188 + z5399 + z4123 * z4245 + c_roll * z5393;
    const Scalar z5394 = s_steer * z4123 - c_roll * z4188 - z4121 * z4245 + s_roll * z5393;
    const Scalar z5398 = z5397 - z4122 * z4247 + c_yaw * z5396 + s_yaw * z5394;
    const Scalar z5382 = n0_08 * z5380 - n0_35 * z5381;
    const Scalar z5390 = z4121 * z4237;
    const Scalar z5341 = v_yaw * z5020;
    const Scalar z5343 = v_roll * z5026 + z5341 + v_pitch * z5041 - v_steer * z5065 + v_front * z5074 - z4358;
    const Scalar z5342 = v_roll * z5026 + z5341 + v_pitch * z5041 - v_steer * z5065 + v_front * z5074;
    const Scalar z5401 = z4204 * z4249;
    const Scalar z5403 = z4122 * z4248;
    const Scalar z5405 = z4204 * z4251;
    const Scalar z5402 = z5401 - z4176 * z5400 + z4174 * z5398 + z4208 * z4246;
    const Scalar z5404 = s_yaw * z5396 - z5403 - z4126 * z4247 - c_yaw * z5394;
    const Scalar z5365 = v_yaw * z5018;
    const Scalar z5367 = v_roll * z5027 - z5365 - v_pitch * z5042 + v_steer * z5069 + v_front * z5076 - z4386;
    const Scalar z5366 = v_roll * z5027 - z5365 - v_pitch * z5042 + v_steer * z5069 + v_front * z5076;
    const Scalar z5391 = s_roll * z5382 - z5390 + z4123 * z4243 + c_roll * z5389;
    const Scalar z5357 = s_roll * z4367 - z4121 * z4316;
    const Scalar z5356 = z4123 * z4316 + c_roll * z4367;
    const Scalar z5346 = s_yaw * z4200 - z4122 * z4161 - z4126 * z4971 - c_yaw * z5345;
    const Scalar z5368 = z4126 * z4161 - z4122 * z4971 + c_yaw * z4200 + s_yaw * z5345;
    const Scalar z5347 = z5346 - z4184 * z5305 + z4211 * z5017 - z4230 * z4351 + z4180 * z5344;
    const Scalar z5369 = z4179 * z5344 - z5368 - z4184 * z5302 - z4209 * z5017 - z4228 * z4351;
    const Scalar z5408 = z4211 * z4252;
    const Scalar z5407 = n2 * (z4174 * z5400 - z4204 * z4246);
    const Scalar z5406 = z4178 * z5400 + z5405 + z4210 * z4246 + z4174 * z5404;
    const Scalar z5360 = z5346 - z5347;
    const Scalar z5374 = z4126 * z4317 - c_yaw * z4359 - z4122 * z5061 + s_yaw * z5357;
    const Scalar z5358 = z4122 * z4317 + s_yaw * z4359 + z4126 * z5061 + c_yaw * z5357;
    const Scalar z5362 = z4210 * z5073 - z4339 * z5301 - z4340 * z5303 - z4225 * z4375 - z4229 * z4376 + z4204 * z5072
        + z4174 * z5360 - z4178 * z5361;
    const Scalar z5376 = z5368 + z5369;
    const Scalar z5377 = z4340 * z5300 - z4338 * z5301 + z4204 * z5075 + z4208 * z5073 - z4225 * z4393 + z4227 * z4376
        + z4176 * z5361 + z4174 * z5376;
    const Scalar z5351 = z4121 * z4322 + s_roll * z4361;
    const Scalar z5354 = c_roll * z4361 - z4123 * z4322;
    const Scalar z5355 = z5348 - z5354;
    const Scalar z5352 = z4122 * z4323 + s_yaw * z4362 + z4126 * z5058 - c_yaw * z5351;
    const Scalar z5372 = c_yaw * z4362 - z4126 * z4323 + z4122 * z5058 + s_yaw * z5351;
    const Scalar z5353 = z5347 + z5352;
    const Scalar z5359 = z4369 * z5064 - z4332 * z5356 - z4333 * z5358 - z4366 * z5057 - z4372 * z5062 + z4360 * z5060
        + z4319 * z5353 - z4321 * z5355;
    const Scalar z5373 = z5369 - z5372;
    const Scalar z5375 = z4331 * z5356 - z4333 * z5374 + z4360 * z5067 - z4390 * z5064 + z4372 * z5068 - z4389 * z5057
        - z4320 * z5355 + z4319 * z5373;
    const Scalar z5349 = z4122 * z5025 + s_yaw * z5348;
    const Scalar z5409 = n2 * (z5408 + z4213 * z4253 + z4181 * z5407 + z4179 * z5402 - z4180 * z5406 + z4209 * z4250);
    const Scalar z5370 = c_yaw * z5348 - z4126 * z5025;
    const Scalar z5350 = z4121 * z5020 - z4127 * z5025 + s_roll * z5347 + z4111 * z5348;
    const Scalar z5363 = v_yaw * z5347 + v_roll * z5349 + v_pitch * z5350 - v_steer * z5359 - v_front * z5362;
    const Scalar z5371 = z4121 * z5018 - z4124 * z5025 + z4110 * z5348 + s_roll * z5369;
    const Scalar z5378 = v_yaw * z5369 - v_roll * z5370 + v_pitch * z5371 - v_steer * z5375 + v_front * z5377;
    const Scalar z5364 = a_yaw * z5020 + a_roll * z5026 + a_pitch * z5041 - a_steer * z5065 + a_front * z5074 + z5363;
    const Scalar z5413 = n2 * z4193;
    const Scalar z5437 = z32 * z4261;
    const Scalar z5438 = z31 * z4261;
    const Scalar z5415 = z31 * z5413;
    const Scalar z5414 = z32 * z5413;
    const Scalar z5379 = a_yaw * z5018 - a_roll * z5027 + a_pitch * z5042 - a_steer * z5069 - a_front * z5076 + z5378;
    const Scalar z5427 = s_pitch * z5415 - n2 * (z4197 * z4235 + z5395) - c_pitch * z5414;
    const Scalar z5425 = s_pitch * z5414 - n2 * (z4192 * z4235 - z5392) + c_pitch * z5415;
    const Scalar z5416 = n0_08 * z5414 - n0_35 * z5415;
    const Scalar z5447 = z4235 * z4267 + z4236 * z4268 + s_pitch * z5437 + c_pitch * z5438 + n2 * (z4192 * z5380 - z4197
        * z5381);
    const Scalar z5449 = z4236 * z4267 - z4235 * z4268 + s_pitch * z5438 - c_pitch * z5437 + n2 * (z4192 * z5381 + z4197
        * z5380);
    const Scalar z5439 = n0_08 * z5437 - n0_35 * z5438;
    const Scalar z5451 = s_roll * z4257 + s_steer * z4145 - z4141 * z4245 - n2 * (z4121 * z4188 - z4123 * z5393)
        - c_roll * z5447;
    const Scalar z5448 = c_roll * z4257 + s_steer * z4141 + z4145 * z4245 + n2 * (z4123 * z4188 + z4121 * z5393)
        + s_roll * z5447;
    const Scalar z5417 = n2 * z4188;
    const Scalar z5429 = n2 * (z4123 * z4245 + z5399) + s_roll * z5417 + c_roll * z5425;
    const Scalar z5426 = n2 * (s_steer * z4123 - z4121 * z4245) - c_roll * z5417 + s_roll * z5425;
    const Scalar z5410 = z4214 * z4255;
    const Scalar z5428 = c_yaw * z5427 - n2 * (z4122 * z4247 - z5397) + s_yaw * z5426;
    const Scalar z5431 = s_yaw * z5427 - n2 * (z4126 * z4247 + z5403) - c_yaw * z5426;
    const Scalar z5430 = z4174 * z5428 - z4176 * z5429 + n2 * (z4208 * z4246 + z5401);
    const Scalar z5432 = z4178 * z5429 + n2 * (z4210 * z4246 + z5405) + z4174 * z5431;
    const Scalar z5433 = z4212 * z5429 - z4246 * z5238;
    const Scalar z5434 = n4 * (z5408 + z4213 * z4253 + z4209 * z4250) + n2 * (z4181 * z5433 + z4179 * z5430 - z4180
        * z5432);
    const Scalar z5455 = z5238 * z5400 + n2 * (z4174 * z5451 + z4246 * z4275);
    const Scalar z5453 = z4142 * z4248 - z4148 * z4247 + n2 * (z4122 * z5396 + z4126 * z5394) + s_yaw * z5449 - c_yaw
        * z5448;
    const Scalar z5450 = z4148 * z4248 + z4142 * z4247 + n2 * (z4122 * z5394 - z4126 * z5396) + c_yaw * z5449 + s_yaw
        * z5448;
    const Scalar z5454 = z4251 * z4275 - z4178 * z5451 - n2 * (z4204 * z5404 - z4210 * z5400) + z4174 * z5453 - z4246
        * z4278;
    const Scalar z5452 = z4176 * z5451 + z4249 * z4275 - n2 * (z4204 * z5398 - z4208 * z5400) + z4174 * z5450 - z4246
        * z4274;
    const Scalar z5456 = n2 * (z4253 * z4280 - z4181 * z5455 - z4252 * z4279 - z4250 * z4277 - z4180 * z5454 + z4179
        * z5452) - n4 * (z4209 * z5402 + z4211 * z5406 - z4213 * z5407);
    const Scalar z5435 = n0_5 * (z5410 / (z4183 * z4183) - z5434 / z4183 + z4215 * z4254 / (z4183 * z4183));
    const Scalar z5411 = n0_5 * (z5410 / (z4183 * z4183) - z5409 / z4183);
    const Scalar z5457 = n0_5 * (z4214 * z5411 / (z4183 * z4183) - z4215 * z5409 / (z4183 * z4183) - z4255 * z4281
        / (z4183 * z4183) - z5456 / z4183) + z4255 * z4282 / (z4183 * z4183 * z4183);
    const Scalar z5463 = z4255 * z5247 / (z4183 * z4183 * z4183) + n0_35 * z5411 / (z4183 * z4183);
    const Scalar z5412 = z5391 - n0_35 * z5411;
    const Scalar z5460 = v_roll * z5089;
    const Scalar z5462 = v_yaw * z5083 + z5460 + v_pitch * z5095 - v_steer * z5112 - v_front * z5118 - z4374;
    const Scalar z5468 = z5391 + z4184 * z5407 + z4213 * z5080 + z4253 * z4351 + z4181 * z5463;
    const Scalar z5461 = v_yaw * z5083 + z5460 + v_pitch * z5095 - v_steer * z5112 - v_front * z5118;
    const Scalar z5473 = z5391 - z5468;
    const Scalar z5477 = v_yaw * z5081;
    const Scalar z5464 = z4192 * z4242 + z4197 * z4240 + s_pitch * z5387 + c_pitch * z5385;
    const Scalar z5441 = z888 * z4257;
    const Scalar z5465 = s_roll * z5389 - c_roll * z5382 - z4121 * z4243 - z4123 * z4237;
    const Scalar z5440 = -z4257 * (n1 - z887);
    const Scalar z5442 = n0_35 * z5441 + n0_08 * z5440;
    const Scalar z5443 = -z4257 * (n1 - z889);
    const Scalar z5444 = n0_08 * z5441 + n0_35 * z5443;
    const Scalar z5466 = z4122 * z5045 + z4126 * z4987 + s_yaw * z5464 + c_yaw * z5465;
    const Scalar z5445 = s_pitch * z5442 - z4242 * z4268 - z4240 * z4267 - c_pitch * z5444 - n2 * (z4192 * z5385 + z4197
        * z5387);
    const Scalar z5467 = z5466 - z4184 * z5406 + z4211 * z5080 + z4252 * z4351 + z4180 * z5463;
    const Scalar z5419 = z888 * z5417;
    const Scalar z5418 = -z5417 * (n1 - z887);
    const Scalar z5421 = -z5417 * (n1 - z889);
    const Scalar z5420 = n0_35 * z5419 + n0_08 * z5418;
    const Scalar z5480 = z4126 * z5045 - z4122 * z4987 - c_yaw * z5464 + s_yaw * z5465;
    const Scalar z5481 = z5480 + z4184 * z5402 - z4209 * z5080 - z4250 * z4351 + z4179 * z5463;
    const Scalar z5446 = z4145 * z4237 + s_roll * z5439 + z4141 * z4243 + n2 * (z4121 * z5382 - z4123 * z5389) - c_roll
        * z5445;
    const Scalar z5422 = n0_08 * z5419 + n0_35 * z5421;
    const Scalar z5423 = s_pitch * z5420 - c_pitch * z5422 + n2 * (z4197 * z4242 - z5388);
    const Scalar z5470 = z4121 * z5083 - z4127 * z5088 + s_roll * z5467 + z4111 * z5468;
    const Scalar z5483 = z4121 * z5081 - z4124 * z5088 + s_roll * z5481 + z4110 * z5468;
    const Scalar z5424 = s_roll * z5416 + n2 * (z4123 * z4243 - z5390) + c_roll * z5423;
    const Scalar z5471 = z4360 * z5083 + z4369 * z5088 + z4319 * z5467 - z4321 * z5468;
    const Scalar z5484 = z4360 * z5081 - z4390 * z5088 + z4319 * z5481 - z4320 * z5468;
    const Scalar z5458 = z5446 - n0_35 * z5457;
    const Scalar z5459 = a_roll * z5087 + a_pitch * z5094 - a_steer * z5111 + z5458;
    const Scalar z5436 = z5424 - n0_35 * z5435;
    const Scalar z5469 = z4122 * z5088 + s_yaw * z5468;
    const Scalar z5482 = c_yaw * z5468 - z4126 * z5088;
    const Scalar z5472 = z5466 - z5467;
    const Scalar z5474 = z4339 * z5400 - z4340 * z5404 - z4204 * z5116 - z4210 * z5117 + z4246 * z4375 + z4251 * z4376
        + z4174 * z5472 + z4178 * z5473;
    const Scalar z5485 = z5480 - z5481;
    const Scalar z5486 = z4340 * z5398 - z4338 * z5400 + z4208 * z5117 - z4246 * z4393 - z4249 * z4376 + z4204 * z5119
        + z4174 * z5485 + z4176 * z5473;
    const Scalar z5475 = v_yaw * z5467 + v_roll * z5469 + v_pitch * z5470 - v_steer * z5471 - v_front * z5474;
    const Scalar z5476 = a_yaw * z5083 + a_roll * z5089 + a_pitch * z5095 - a_steer * z5112 - a_front * z5118 + z5475;
    const Scalar z5487 = v_yaw * z5481 - v_roll * z5482 + v_pitch * z5483 - v_steer * z5484 - v_front * z5486;
    const Scalar z5488 = a_yaw * z5081 - a_roll * z5090 + a_pitch * z5096 - a_steer * z5113 + a_front * z5120 + z5487;
    const Scalar z5479 = v_roll * z5090 - z5477 - v_pitch * z5096 + v_steer * z5113 - v_front * z5120 + z4392;
    const Scalar z5478 = v_roll * z5090 - z5477 - v_pitch * z5096 + v_steer * z5113 - v_front * z5120;
    const Scalar z5494 = n1 / z4342;
    const Scalar z5495 = z4344 * z5494;
    const Scalar z5489 = n1 / z4234;
    const Scalar z5514 = z4140 + z4223;
    const Scalar z5515 = z5489 * z5514;
    const Scalar z5516 = z4256 * z5489;
    const Scalar z5492 = z4315 * z5489;
    const Scalar z5496 = z4309 - z4310 * z5495;
    const Scalar z5545 = z5311 * z5516 - z5412;
    const Scalar z5544 = z5221 - z5311 * z5515;
    const Scalar z5546 = z5245 + z5342 * z5515;
    const Scalar z5547 = z5342 * z5516 + z5461;
    const Scalar z5497 = z4285 - z5496;
    const Scalar z5548 = z5275 - z5366 * z5515;
    const Scalar z5549 = z5366 * z5516 + z5478;
    const Scalar z5508 = z5497 * z5497;
    const Scalar z5498 = n1 / z5497;
    const Scalar z5491 = z4291 * z5489;
    const Scalar z5490 = z4314 * z5489;
    const Scalar z5550 = z5163 - z5156 + z5145 * z5495;
    const Scalar z5528 = z4256 * z5491;
    const Scalar z5527 = z4256 * z5490 - z4335;
    const Scalar z5493 = z4290 * z5489;
    const Scalar z5558 = z5192 - z5544;
    const Scalar z5529 = z4256 * z5492 - z4337 - z5528 - z5495 * z5527;
    const Scalar z5518 = z4289 - z5491 * z5514;
    const Scalar z5517 = z4312 - z5490 * z5514;
    const Scalar z5519 = z4313 - z5492 * z5514 - z5518 - z5495 * z5517;
    const Scalar z5499 = z4286 * z5498;
    const Scalar z5559 = z5490 * z5558 - z5546;
    const Scalar z5502 = z4234 * z4234;
    const Scalar z5503 = n1_over_94 + z4256 * z4256 / z587 + z4223 * z4223 / z4515 + z5502 / z4498;
    const Scalar z5551 = z5174 - z5499 * z5550;
    const Scalar z5520 = z4288 - z5493 * z5514 + z5499 * z5519;
    const Scalar z5500 = n1 - z5495 * z5499;
    const Scalar z5560 = z5265 + z5491 * z5558;
    const Scalar z5511 = z5500 * z5500;
    const Scalar z5501 = n1 / z5500;
    const Scalar z5561 = z5492 * z5558 - z5560 + z5548 - z5495 * z5559;
    const Scalar z5537 = z4290 - z4291 * z5499;
    const Scalar z5530 = z4256 * z5493 + z5499 * z5529;
    const Scalar z5505 = z4342 * z4342;
    const Scalar z5506 = n1_over_94 + n25_over_7 * z5505 + z4310 * z4310 / z4527 + z4312 * z4312 / z4515 + z4335 * z4335
        / z587 + z4314 * z4314 / z4498;
    const Scalar z5504 = z4498 * z5503;
    const Scalar z5538 = z5501 * z5537;
    const Scalar z5531 = z5501 * z5530;
    const Scalar z5562 = z5290 + z5493 * z5558 + z5499 * z5561;
    const Scalar z5532 = z5495 * z5531 + z5529;
    const Scalar z5552 = z5501 * z5551;
    const Scalar z5563 = z5501 * z5562;
    const Scalar z5533 = z5498 * z5532;
    const Scalar z5521 = z5501 * z5520;
    const Scalar z5553 = z5495 * z5552 - z5550;
    const Scalar z5564 = z5495 * z5563 + z5561;
    const Scalar z5534 = z4285 * z5533 + z5528;
    const Scalar z5507 = n0_28 * z5506;
    const Scalar z5522 = z5495 * z5521 + z5519;
    const Scalar z5554 = z5498 * z5553;
    const Scalar z5565 = z5498 * z5564;
    const Scalar z5556 = z5145 - z5552 + z4310 * z5554;
    const Scalar z5567 = z5559 - z5563 + z4310 * z5565;
    const Scalar z5555 = z4285 * z5554 - z5156;
    const Scalar z5566 = z4285 * z5565 + z5560;
    const Scalar z5523 = z5498 * z5522;
    const Scalar z5535 = z5527 - z5531 + z4310 * z5533;
    const Scalar z5536 = z5494 * z5535;
    const Scalar z5557 = z5494 * z5556;
    const Scalar z5524 = z4285 * z5523 + z5518;
    const Scalar z5525 = z5517 - z5521 + z4310 * z5523;
    const Scalar z5568 = z5494 * z5567;
    const Scalar z5526 = z5494 * z5525;
    const Scalar z5539 = z4291 - z5495 * z5538;
    const Scalar z5540 = z5498 * z5539;
    const Scalar z5509 = n1_over_94 + n25_over_7 * z4344 * z4344 + z4309 * z4309 / z4527 + z4313 * z4313 / z4515 + z4337
        * z4337 / z587 + z4315 * z4315 / z4498;
    const Scalar z5510 = z4527 * z5509;
    const Scalar z5570 = z5490 * z5545 - z5547;
    const Scalar z5569 = z5489 * z5558;
    const Scalar z5571 = z5491 * z5545;
    const Scalar z5541 = z4285 * z5540 - z4291;
    const Scalar z5542 = z4310 * z5540 + z5538;
    const Scalar z5543 = z5494 * z5542;
    const Scalar z5512 = n1_over_94 + z4290 * z4290 * (n25_over_3 + n1 / z4498) + z4288 * z4288 / z4515 + z4286 * z4286
        / z4527;
    const Scalar z5513 = n94 * z5512;
    const Scalar z5572 = z5492 * z5545 - z5571 - z5549 - z5495 * z5570;
    const Scalar z5581 = z5232 - z5327 * z5515;
    const Scalar z5582 = z5327 * z5516 - z5436;
    const Scalar z5586 = z4307 * z5515 + z5266 - z5157 * z5523;
    const Scalar z5595 = z5200 - z5581;
    const Scalar z5597 = z5491 * z5595 + z5586;
    const Scalar z5589 = z5146 * z5523 - z5246 - z5343 * z5515 + z4378 * z5526;
    const Scalar z5590 = z5462 + z5343 * z5516 + z5146 * z5533 + z4378 * z5536;
    const Scalar z5592 = z5276 - z5367 * z5515 - z5164 * z5523 + z4395 * z5526;
    const Scalar z5593 = z5367 * z5516 + z5479 - z5164 * z5533 + z4395 * z5536;
    const Scalar z5583 = z4300 * z5515 + z5291 + z5175 * z5523;
    const Scalar z5596 = z5490 * z5595 + z5589;
    const Scalar z5607 = z5490 * z5582 - z5590;
    const Scalar z5598 = z5492 * z5595 - z5597 + z5592 - z5495 * z5596;
    const Scalar z5573 = z5493 * z5545 + z5499 * z5572;
    const Scalar z5574 = z5501 * z5573;
    const Scalar z5580 = z5489 * z5545;
    const Scalar z5599 = z5493 * z5595 + z5583 + z5499 * z5598;
    const Scalar z5575 = z5495 * z5574 + z5572;
    const Scalar z5606 = z5489 * z5595;
    const Scalar z5600 = z5501 * z5599;
    const Scalar z5626 = z5327 * z5569;
    const Scalar z5627 = z5327 * z5580;
    const Scalar z5601 = z5495 * z5600 + z5598;
    const Scalar z5576 = z5498 * z5575;
    const Scalar z5632 = z4307 * z5569 + z5157 * z5565;
    const Scalar z5587 = z4307 * z5516 + z5157 * z5533;
    const Scalar z5578 = z5570 - z5574 + z4310 * z5576;
    const Scalar z5577 = z4285 * z5576 + z5571;
    const Scalar z5608 = z5491 * z5582 + z5587;
    const Scalar z5579 = z5494 * z5578;
    const Scalar z5640 = z5243 + z5340 * z5515;
    const Scalar z5641 = z5340 * z5516 - z5459;
    const Scalar z5642 = z5263 + z5364 * z5515;
    const Scalar z5643 = z5364 * z5516 + z5476;
    const Scalar z5609 = z5492 * z5582 - z5608 - z5593 - z5495 * z5607;
    const Scalar z5602 = z5498 * z5601;
    const Scalar z5603 = z4285 * z5602 + z5597;
    const Scalar z5604 = z5596 - z5600 + z4310 * z5602;
    const Scalar z5633 = z4307 * z5580 + z5157 * z5576;
    const Scalar z5588 = z4307 - z5157 * z5540;
    const Scalar z5631 = z5157 * z5554;
    const Scalar z5605 = z5494 * z5604;
    const Scalar z5634 = z5146 * z5554 + z4378 * z5557;
    const Scalar z5635 = z5343 * z5569 + z5146 * z5565 + z4378 * z5568;
    const Scalar z5636 = z5343 * z5580 + z5146 * z5576 + z4378 * z5579;
    const Scalar z5591 = z5146 * z5540 + z4378 * z5543;
    const Scalar z5638 = z5367 * z5569 - z5164 * z5565 + z4395 * z5568;
    const Scalar z5639 = z5367 * z5580 - z5164 * z5576 + z4395 * z5579;
    const Scalar z5637 = z4395 * z5557 - z5164 * z5554;
    const Scalar z5594 = z4395 * z5543 - z5164 * z5540;
    const Scalar z5618 = z5495 * z5591 + z5588 - z5594;
    const Scalar z5629 = z4300 * z5569 - z5175 * z5565;
    const Scalar z5628 = z5175 * z5554;
    const Scalar z5584 = z4300 * z5516 - z5175 * z5533;
    const Scalar z5644 = z5288 + z5379 * z5515;
    const Scalar z5610 = z5493 * z5582 + z5584 + z5499 * z5609;
    const Scalar z5617 = z5489 * z5582;
    const Scalar z5630 = z4300 * z5580 - z5175 * z5576;
    const Scalar z5585 = z4300 + z5175 * z5540;
    const Scalar z5646 = z5626 + z5640;
    const Scalar z5647 = z5627 + z5641;
    const Scalar z5651 = z5273 - z5632;
    const Scalar z5645 = z5379 * z5516 + z5488;
    const Scalar z5650 = z5161 + z5631;
    const Scalar z5652 = z5154 + z5634;
    const Scalar z5653 = z5635 + z5642;
    const Scalar z5654 = z5636 + z5643;
    const Scalar z5656 = z5638 - z5644;
    const Scalar z5657 = z5639 - z5645;
    const Scalar z5655 = z5172 + z5637;
    const Scalar z5649 = z5296 + z5629;
    const Scalar z5648 = z5179 - z5628;
    const Scalar z5666 = z5209 + z5646;
    const Scalar z5668 = z5491 * z5666 - z5651;
    const Scalar z5667 = z5490 * z5666 - z5653;
    const Scalar z5658 = z5495 * z5652 - z5650 - z5655;
    const Scalar z5619 = z5499 * z5618 - z5585;
    const Scalar z5669 = z5492 * z5666 - z5668 - z5656 - z5495 * z5667;
    const Scalar z5659 = z5499 * z5658 + z5648;
    const Scalar z5620 = z5501 * z5619;
    const Scalar z5660 = z5501 * z5659;
    const Scalar z5611 = z5501 * z5610;
    const Scalar z5621 = z5495 * z5620 + z5618;
    const Scalar z5612 = z5495 * z5611 + z5609;
    const Scalar z5661 = z5495 * z5660 + z5658;
    const Scalar z5622 = z5498 * z5621;
    const Scalar z5613 = z5498 * z5612;
    const Scalar z5662 = z5498 * z5661;
    const Scalar z5670 = z5493 * z5666 + z5649 + z5499 * z5669;
    const Scalar z5623 = z4285 * z5622 - z5588;
    const Scalar z5614 = z4285 * z5613 + z5608;
    const Scalar z5663 = z4285 * z5662 + z5650;
    const Scalar z5671 = z5501 * z5670;
    const Scalar z5615 = z5607 - z5611 + z4310 * z5613;
    const Scalar z5624 = z4310 * z5622 - z5591 - z5620;
    const Scalar z5672 = z5495 * z5671 + z5669;
    const Scalar z5664 = z4310 * z5662 - z5652 - z5660;
    const Scalar z5616 = z5494 * z5615;
    const Scalar z5679 = z5491 * z5647 + z5633;
    const Scalar z5678 = z5490 * z5647 - z5654;
    const Scalar z5680 = z5492 * z5647 - z5679 - z5657 - z5495 * z5678;
    const Scalar z5677 = z5489 * z5666;
    const Scalar z5673 = z5498 * z5672;
    const Scalar z5674 = z4285 * z5673 + z5668;
    const Scalar z5675 = z5667 - z5671 + z4310 * z5673;
    const Scalar z5625 = z5494 * z5624;
    const Scalar z5707 = z4458 + z4140 * z4461 - z4454 * z5515 + z4463 * z5521 + z4462 * z5523 - z4464 * z5524;
    const Scalar z5689 = z5138 - z5139;
    const Scalar z5691 = z5141 + z5491 * z5689;
    const Scalar z5690 = z5140 - z5490 * z5689;
    const Scalar z5712 = z4461 - z4504 * z5516;
    const Scalar z5681 = z5493 * z5647 + z5630 + z5499 * z5680;
    const Scalar z5692 = z5492 * z5689 - z5691 + z5142 + z5495 * z5690;
    const Scalar z5682 = z5501 * z5681;
    const Scalar z5688 = z5489 * z5647;
    const Scalar z5683 = z5495 * z5682 + z5680;
    const Scalar z5705 = z4515 + z4140 * z4518 + z4501 * z5515 - z4520 * z5521 - z4519 * z5523 - z4521 * z5524 + z4444
        * z5526;
    const Scalar z5693 = z5143 - z5493 * z5689 - z5499 * z5692;
    const Scalar z5700 = z5489 * z5689;
    const Scalar z5703 = z4518 + n94 * z4140 + z4504 * z5515;
    const Scalar z5706 = z4501 + z4140 * z4504 + z4498 * z5515 + z4506 * z5521 - z4505 * z5523 + z4507 * z5524 + z4442
        * z5526;
    const Scalar z5694 = z5501 * z5693;
    const Scalar z5695 = z5495 * z5694 - z5692;
    const Scalar z5714 = z4506 * z5531 - z4454 - z4498 * z5516 - z4505 * z5533 + z4507 * z5534 + z4442 * z5536;
    const Scalar z5715 = z587 + z4454 * z5516 + z4463 * z5531 + z4462 * z5533 - z4464 * z5534;
    const Scalar z5711 = z4464 + z4507 * z5516 + z4529 * z5533 - n94 * z5534;
    const Scalar z5710 = z4463 - z4506 * z5516 + n94 * z5531 - z4528 * z5533;
    const Scalar z5701 = z4506 * z5515 - z4520 + n94 * z5521 - z4528 * z5523;
    const Scalar z5713 = z4528 * z5531 - z4462 - z4505 * z5516 - z4527 * z5533 + z4529 * z5534 + z4446 * z5536;
    const Scalar z5702 = z4507 * z5515 - z4521 - z4529 * z5523 + n94 * z5524;
    const Scalar z5721 = n0_12 - z4506 * z5538 - z4505 * z5540 + z4507 * z5541 + z4442 * z5543;
    const Scalar z5704 = z4519 + z4505 * z5515 + z4528 * z5521 - z4527 * z5523 + z4529 * z5524 + z4446 * z5526;
    const Scalar z5720 = z4497 - z4528 * z5538 - z4527 * z5540 + z4529 * z5541 + z4446 * z5543;
    const Scalar z5718 = n94 * z5538 + z4528 * z5540;
    const Scalar z5719 = z4529 * z5540 - n94 * z5541;
    const Scalar z5709 = z4442 * z5515 + z4444 - z4446 * z5523 + n0_28 * z5526;
    const Scalar z5717 = z4442 * z5516 + z4446 * z5533 - n0_28 * z5536;
    const Scalar z5723 = z4446 * z5540 - n0_28 * z5543;
    const Scalar z5684 = z5498 * z5683;
    const Scalar z5696 = z5498 * z5695;
    const Scalar z5724 = z4140 * z5703 + z5521 * z5701 + z5524 * z5702 + z5526 * z5709 + z5515 * z5706 - z5523 * z5704
        + z5705;
    const Scalar z5685 = z4285 * z5684 + z5679;
    const Scalar z5686 = z5678 - z5682 + z4310 * z5684;
    const Scalar z5665 = z5494 * z5664;
    const Scalar z5727 = z5534 * z5711 - z5715 - z5531 * z5710 + z5536 * z5717 + z5516 * z5714 + z5533 * z5713;
    const Scalar z5725 = z5516 * z5706 - z5707 - z5531 * z5701 - z5534 * z5702 - z5536 * z5709 + z5533 * z5704;
    const Scalar z5676 = z5494 * z5675;
    const Scalar z5745 = z4783 + z4820 * z5515;
    const Scalar z5746 = z4820 * z5516 + z4893;
    const Scalar z5739 = z4822 * z5515 - z4785 + z4753 * z5523;
    const Scalar z5743 = z4823 * z5516 - z4896 + z4752 * z5533;
    const Scalar z5740 = z4753 * z5533 - z4895 - z4822 * z5516;
    const Scalar z5742 = z4786 - z4823 * z5515 + z4752 * z5523;
    const Scalar z5687 = z5494 * z5686;
    const Scalar z5752 = z4748 * z5540 - z4824 + z4905 * z5543;
    const Scalar z5756 = z4842 * z5515 - z4846 - z4847 * z5523 + z4910 * z5526;
    const Scalar z5753 = z4791 * z5515 - z4793 - z4794 * z5523 - z4901 * z5526;
    const Scalar z5754 = z4791 * z5516 - z4886 + z4794 * z5533 + z4901 * z5536;
    const Scalar z5747 = z4784 - z4821 * z5515 + z4754 * z5523 + z4909 * z5526;
    const Scalar z5748 = z4821 * z5516 - z4894 + z4754 * z5533 + z4909 * z5536;
    const Scalar z5750 = z4817 * z5515 - z4764 + z4748 * z5523 + z4905 * z5526;
    const Scalar z5751 = z4890 - z4817 * z5516 + z4748 * z5533 + z4905 * z5536;
    const Scalar z5697 = z4285 * z5696 - z5691;
    const Scalar z5698 = z5690 - z5694 + z4310 * z5696;
    const Scalar z5699 = z5494 * z5698;
    const Scalar z5763 = z4899 - z4904 * z5516 - z4909 * z5533;
    const Scalar z5766 = z4140 * z5746 - z5524 * z5743 - z5526 * z5763 + z5521 * z5740 - z5515 * z5754 + z5523 * z5748
        + z5751;
    const Scalar z5759 = z4827 - z4828 * z5523;
    const Scalar z5762 = z4904 * z5515 + z4908 - z4909 * z5523;
    const Scalar z5765 = z4140 * z5745 - z5521 * z5739 + z5524 * z5742 + z5526 * z5762 - z5515 * z5753 - z5523 * z5747
        - z5750;
    const Scalar z5722 = n0_12 - z4497 * z5540;
    const Scalar z5729 = z5538 * z5718 + z5722 - z5541 * z5719 - z5543 * z5723 - z5540 * z5720;
    const Scalar z5716 = n0_12 * z5516 + z4497 * z5533;
    const Scalar z5708 = z4497 * z5523 - n0_12 * z5515;
    const Scalar z5768 = z5756 + z5534 * z5742 - z5531 * z5739 + z5536 * z5762 + z5516 * z5753 - z5533 * z5747;
    const Scalar z5771 = z5759 + z5538 * z5739 + z5541 * z5742 + z5543 * z5762 - z5540 * z5747;
    const Scalar z5728 = z5538 * z5710 + z5716 + z5541 * z5711 + z5543 * z5717 + z5540 * z5713;
    const Scalar z5726 = z5538 * z5701 + z5708 - z5541 * z5702 - z5543 * z5709 + z5540 * z5704;
    const Scalar z5741 = z4753 * z5540;
    const Scalar z5744 = z4752 * z5540;
    const Scalar z5757 = z4842 * z5516 + z4847 * z5533 - z4910 * z5536;
    const Scalar z5769 = z5757 + z5531 * z5740 - z5534 * z5743 - z5536 * z5763 + z5516 * z5754 + z5533 * z5748;
    const Scalar z5758 = z4847 * z5540 - z4910 * z5543;
    const Scalar z5760 = z4828 * z5533;
    const Scalar z5772 = z5541 * z5743 - z5760 + z5543 * z5763 + z5538 * z5740 - z5540 * z5748;
    const Scalar z5761 = z4828 * z5540;
    const Scalar z5764 = z4909 * z5540;
    const Scalar z5755 = z4794 * z5540 + z4901 * z5543;
    const Scalar z5749 = z4754 * z5540 + z4828 + z4909 * z5543;
    const Scalar z5767 = z5524 * z5744 - z5752 - z5521 * z5741 - z5526 * z5764 + z5515 * z5755 - z5523 * z5749;
    const Scalar z5770 = z5758 + z5531 * z5741 - z5534 * z5744 + z5536 * z5764 + z5516 * z5755 + z5533 * z5749;
    const Scalar z5773 = z5538 * z5741 - z5761 + z5541 * z5744 - z5543 * z5764 - z5540 * z5749;
    const Scalar z5730 = z5200 * z5703 + z5606 * z5706 - z5600 * z5701 + z5602 * z5704 - z5603 * z5702 - z5605 * z5709;
    const Scalar z5774 = z5730 + z5765;
    const Scalar z5733 = z5200 * z5712 + z5606 * z5714 - z5600 * z5710 + z5602 * z5713 + z5603 * z5711 + z5605 * z5717;
    const Scalar z5736 = z5606 * z5721 + z5600 * z5718 + z5602 * z5720 + z5603 * z5719 + z5605 * z5723;
    const Scalar z5777 = z5733 + z5768;
    const Scalar z5780 = z5736 + z5771;
    const Scalar z5731 = z5611 * z5701 - z5617 * z5706 - z5613 * z5704 + z5614 * z5702 + z5616 * z5709;
    const Scalar z5775 = z5731 - z5766;
    const Scalar z5732 = z5620 * z5701 - z5622 * z5704 + z5623 * z5702 + z5625 * z5709;
    const Scalar z5776 = z5732 + z5767;
    const Scalar z5792 = z4753 * z5554;
    const Scalar z5793 = z4753 * z5565 - z4822 * z5569;
    const Scalar z5734 = z5611 * z5710 - z5617 * z5714 - z5613 * z5713 - z5614 * z5711 - z5616 * z5717;
    const Scalar z5737 = z5617 * z5721 + z5611 * z5718 + z5613 * z5720 + z5614 * z5719 + z5616 * z5723;
    const Scalar z5794 = z4753 * z5576 - z4822 * z5580;
    const Scalar z5778 = z5734 - z5769;
    const Scalar z5781 = z5737 - z5772;
    const Scalar z5735 = z5620 * z5710 - z5622 * z5713 - z5623 * z5711 - z5625 * z5717;
    const Scalar z5738 = z5620 * z5718 + z5622 * z5720 + z5623 * z5719 + z5625 * z5723;
    const Scalar z5834 = z4758 - z5792;
    const Scalar z5779 = z5735 - z5770;
    const Scalar z5782 = z5738 - z5773;
    const Scalar z5822 = z4773 - z4806 * z5515;
    const Scalar z5823 = z4806 * z5516 - z4869;
    const Scalar z5820 = z4776 - z4809 * z5515;
    const Scalar z5821 = z4809 * z5516 - z4872;
    const Scalar z5830 = z5006 - z5071 * z5515;
    const Scalar z5831 = z5071 * z5516 + z5115;
    const Scalar z5832 = z5015 - z5078 * z5515;
    const Scalar z5833 = z5078 * z5516 + z5122;
    const Scalar z5818 = z4775 + z4808 * z5515;
    const Scalar z5819 = z4808 * z5516 + z4871;
    const Scalar z5835 = z5793 + z5818;
    const Scalar z5836 = z5794 + z5819;
    const Scalar z5828 = z4986 - z5044 * z5515;
    const Scalar z5829 = z5044 * z5516 - z5098;
    const Scalar z5824 = z4947 - z5022 * z5515;
    const Scalar z5825 = z5022 * z5516 - z5085;
    const Scalar z5826 = z4970 + z5029 * z5515;
    const Scalar z5827 = z5029 * z5516 + z5092;
    const Scalar z5798 = z4820 * z5569;
    const Scalar z5840 = z5798 + z5822;
    const Scalar z5799 = z4820 * z5580;
    const Scalar z5841 = z5799 - z5823;
    const Scalar z5796 = z4823 * z5569 + z4752 * z5565;
    const Scalar z5838 = z5796 + z5820;
    const Scalar z5797 = z4823 * z5580 + z4752 * z5576;
    const Scalar z5839 = z5797 - z5821;
    const Scalar z5795 = z4752 * z5554;
    const Scalar z5837 = z4759 + z5795;
    const Scalar z5803 = z4748 * z5554 + z4905 * z5557;
    const Scalar z5806 = z4794 * z5554 + z4901 * z5557;
    const Scalar z5809 = z4847 * z5554 - z4910 * z5557;
    const Scalar z5800 = z4754 * z5554 + z4909 * z5557;
    const Scalar z5842 = z4916 + z5800;
    const Scalar z5810 = z4842 * z5569 + z4847 * z5565 - z4910 * z5568;
    const Scalar z5811 = z4842 * z5580 + z4847 * z5576 - z4910 * z5579;
    const Scalar z5816 = z4904 * z5569 + z4909 * z5565;
    const Scalar z5817 = z4904 * z5580 + z4909 * z5576;
    const Scalar z5812 = z4828 * z5554;
    const Scalar z5815 = z4909 * z5554;
    const Scalar z5813 = z4828 * z5565;
    const Scalar z5814 = z4828 * z5576;
    const Scalar z5807 = z4791 * z5569 + z4794 * z5565 + z4901 * z5568;
    const Scalar z5808 = z4791 * z5580 + z4794 * z5576 + z4901 * z5579;
    const Scalar z5801 = z4754 * z5565 + z4821 * z5569 + z4909 * z5568;
    const Scalar z5802 = z4754 * z5576 + z4821 * z5580 + z4909 * z5579;
    const Scalar z5804 = z4748 * z5565 - z4817 * z5569 + z4905 * z5568;
    const Scalar z5805 = z4748 * z5576 - z4817 * z5580 + z4905 * z5579;
    const Scalar z5783 = z5660 * z5701 - z5662 * z5704 + z5663 * z5702 + z5665 * z5709;
    const Scalar z5843 = z5801 + z5824;
    const Scalar z5784 = z5209 * z5703 + z5677 * z5706 - z5671 * z5701 + z5673 * z5704 - z5674 * z5702 - z5676 * z5709;
    const Scalar z5844 = z5802 - z5825;
    const Scalar z5787 = z5209 * z5712 + z5677 * z5714 - z5671 * z5710 + z5673 * z5713 + z5674 * z5711 + z5676 * z5717;
    const Scalar z5790 = z5677 * z5721 + z5671 * z5718 + z5673 * z5720 + z5674 * z5719 + z5676 * z5723;
    const Scalar z5785 = z5682 * z5701 - z5688 * z5706 - z5684 * z5704 + z5685 * z5702 + z5687 * z5709;
    const Scalar z5845 = z4918 + z5803;
    const Scalar z5786 = z5660 * z5710 - z5662 * z5713 - z5663 * z5711 - z5665 * z5717;
    const Scalar z5789 = z5660 * z5718 + z5662 * z5720 + z5663 * z5719 + z5665 * z5723;
    const Scalar z5846 = z5804 + z5826;
    const Scalar z5847 = z5805 + z5827;
    const Scalar z5788 = z5682 * z5710 - z5688 * z5714 - z5684 * z5713 - z5685 * z5711 - z5687 * z5717;
    const Scalar z5791 = z5688 * z5721 + z5682 * z5718 + z5684 * z5720 + z5685 * z5719 + z5687 * z5723;
    const Scalar z5886 = z5138 * z5703 + z5694 * z5701 + z5697 * z5702 + z5699 * z5709 - z5696 * z5704 + z5700 * z5706;
    const Scalar z5887 = z5138 * z5712 + z5694 * z5710 - z5697 * z5711 - z5699 * z5717 - z5696 * z5713 + z5700 * z5714;
    const Scalar z5888 = z5694 * z5718 + z5697 * z5719 + z5699 * z5723 + z5696 * z5720 - z5700 * z5721;
    const Scalar z5880 = l_lambda_rear_rolls_x * z4286 + l_lambda_rear_rolls_y * z4285 + l_lambda_front_rolls_x * z4310
        + l_lambda_front_rolls_y * z4309 - z5136;
    const Scalar z5881 = l_lambda_rear_rolls_x * z4290 - z5129 + l_lambda_rear_rolls_y * z4291 + l_lambda_front_touches
        * z4234 + l_lambda_front_rolls_x * z4314 + l_lambda_front_rolls_y * z4315;
    const Scalar z5882 = l_lambda_front_rolls_x * z4342 - z4575 + l_lambda_front_rolls_y * z4344;
    const Scalar z5848 = z4925 + z5806;
    const Scalar z5851 = z4931 + z5809;
    const Scalar z5852 = z5810 + z5830;
    const Scalar z5853 = z5811 - z5831;
    const Scalar z5857 = z5816 + z5832;
    const Scalar z5858 = z5817 - z5833;
    const Scalar z5854 = z4932 - z5812;
    const Scalar z5855 = z5008 - z5813;
    const Scalar z5856 = z4937 - z5815;
    const Scalar z5849 = z5807 + z5828;
    const Scalar z5850 = z5808 - z5829;
    const Scalar z5860 = z4140 * z5840 - z5524 * z5838 + z5526 * z5857 + z5521 * z5835 - z5515 * z5849 + z5523 * z5843
        + z5846;
    const Scalar z5861 = z4140 * z5841 - z5524 * z5839 + z5526 * z5858 + z5521 * z5836 - z5515 * z5850 + z5523 * z5844
        + z5847;
    const Scalar z5863 = z5852 + z5536 * z5857 - z5534 * z5838 + z5531 * z5835 + z5516 * z5849 + z5533 * z5843;
    const Scalar z5866 = z5855 + z5541 * z5838 - z5543 * z5857 + z5538 * z5835 - z5540 * z5843;
    const Scalar z5864 = z5853 + z5536 * z5858 - z5534 * z5839 + z5531 * z5836 + z5516 * z5850 + z5533 * z5844;
    const Scalar z5867 = z5541 * z5839 - z5814 - z5543 * z5858 + z5538 * z5836 - z5540 * z5844;
    const Scalar z5869 = z5784 + z5860;
    const Scalar z5870 = z5785 - z5861;
    const Scalar z5872 = z5787 + z5863;
    const Scalar z5873 = z5788 - z5864;
    const Scalar z5875 = z5790 - z5866;
    const Scalar z5876 = z5791 - z5867;
    const Scalar z5892 = n1 / z5729;
    const Scalar z5879 = l_lambda_rear_touches + l_lambda_front_touches - z4616;
    const Scalar z5859 = z5521 * z5834 - z5845 + z5524 * z5837 + z5526 * z5856 + z5515 * z5848 - z5523 * z5842;
    const Scalar z5862 = z5851 + z5516 * z5848 - z5531 * z5834 - z5534 * z5837 - z5536 * z5856 + z5533 * z5842;
    const Scalar z5865 = z5538 * z5834 - z5854 - z5541 * z5837 - z5543 * z5856 + z5540 * z5842;
    const Scalar z5868 = z5783 + z5859;
    const Scalar z5871 = z5786 - z5862;
    const Scalar z5874 = z5789 + z5865;
    const Scalar z5877 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z4614;
    const Scalar z5878 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z4615;
    const Scalar z5883 = z5134 + l_lambda_rear_rolls_x * z4288 + l_lambda_rear_rolls_y * z4289 + l_lambda_front_touches
        * z4223 + l_lambda_front_rolls_x * z4312 + l_lambda_front_rolls_y * z4313 - z4140 * (l_lambda_rear_touches
        - z5879) - z5515 * z5881 - z5521 * z5877 + z5523 * z5880 - z5524 * z5878 - z5526 * z5882;
    const Scalar z5884 = l_lambda_front_touches * z4256 - z5137 + l_lambda_front_rolls_x * z4335
        + l_lambda_front_rolls_y * z4337 - z5516 * z5881 + z5531 * z5877 - z5533 * z5880 + z5534 * z5878 + z5536
        * z5882;
    const Scalar z5885 = l_lambda_rear_rolls_x * z4290 - z4595 + l_lambda_rear_rolls_y * z4291 - z5538 * z5877 - z5540
        * z5880 + z5541 * z5878 + z5543 * z5882;
    const Scalar z5889 = z5883 - z5886;
    const Scalar z5890 = z5884 + z5887;
    const Scalar z5891 = z5885 - z5888;
    const Scalar z5894 = z5728 * z5892;
    const Scalar z5897 = z5727 + z5728 * z5894;
    const Scalar z5896 = z5725 + z5726 * z5894;
    const Scalar z5902 = z5777 + z5780 * z5894;
    const Scalar z5907 = z5778 - z5781 * z5894;
    const Scalar z5898 = n1 / z5897;
    const Scalar z5912 = z5871 - z5874 * z5894;
    const Scalar z5917 = z5779 - z5782 * z5894;
    const Scalar z5922 = z5872 + z5875 * z5894;
    const Scalar z5927 = z5873 - z5876 * z5894;
    const Scalar z5893 = z5726 * z5892;
    const Scalar z5895 = z5724 - z5726 * z5893;
    const Scalar z5899 = z5896 * z5898;
    const Scalar z5900 = z5895 + z5896 * z5899;
    const Scalar z5903 = z5774 + z5780 * z5893 - z5899 * z5902;
    const Scalar z5908 = z5775 - z5781 * z5893 - z5899 * z5907;
    const Scalar z5913 = z5868 - z5874 * z5893 - z5899 * z5912;
    const Scalar z5918 = z5776 - z5782 * z5893 - z5899 * z5917;
    const Scalar z5923 = z5869 + z5875 * z5893 - z5899 * z5922;
    const Scalar z5928 = z5870 - z5876 * z5893 - z5899 * z5927;
    const Scalar z5901 = n1 / z5900;
    const Scalar z5904 = z5901 * z5903;
    const Scalar z5909 = z5901 * z5908;
    const Scalar z5914 = z5901 * z5913;
    const Scalar z5919 = z5901 * z5918;
    const Scalar z5924 = z5901 * z5923;
    const Scalar z5929 = z5901 * z5928;
    const Scalar z5905 = z5898 * z5902 + z5899 * z5904;
    const Scalar z5910 = z5898 * z5907 + z5899 * z5909;
    const Scalar z5915 = z5898 * z5912 + z5899 * z5914;
    const Scalar z5920 = z5898 * z5917 + z5899 * z5919;
    const Scalar z5925 = z5898 * z5922 + z5899 * z5924;
    const Scalar z5930 = z5898 * z5927 + z5899 * z5929;
    const Scalar z5906 = z5780 * z5892 + z5893 * z5904 - z5894 * z5905;
    const Scalar z5911 = z5781 * z5892 - z5893 * z5909 + z5894 * z5910;
    const Scalar z5916 = z5874 * z5892 - z5893 * z5914 + z5894 * z5915;
    const Scalar z5921 = z5782 * z5892 - z5893 * z5919 + z5894 * z5920;
    const Scalar z5926 = z5875 * z5892 + z5893 * z5924 - z5894 * z5925;
    const Scalar z5931 = z5876 * z5892 - z5893 * z5929 + z5894 * z5930;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z4528;
    result.M[4] = -z4520;
    result.M[5] = z4506;
    result.M[6] = z4463;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z4529;
    result.M[13] = z4521;
    result.M[14] = -z4507;
    result.M[15] = z4464;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z4518;
    result.M[23] = z4504;
    result.M[24] = z4461;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z4528;
    result.M[28] = -z4529;
    result.M[29] = n0;
    result.M[30] = z4527;
    result.M[31] = z4519;
    result.M[32] = z4505;
    result.M[33] = -z4462;
    result.M[34] = z4497;
    result.M[35] = z4446;
    result.M[36] = -z4520;
    result.M[37] = z4521;
    result.M[38] = z4518;
    result.M[39] = z4519;
    result.M[40] = z4515;
    result.M[41] = z4501;
    result.M[42] = z4458;
    result.M[43] = n0;
    result.M[44] = z4444;
    result.M[45] = z4506;
    result.M[46] = -z4507;
    result.M[47] = z4504;
    result.M[48] = z4505;
    result.M[49] = z4501;
    result.M[50] = z4498;
    result.M[51] = -z4454;
    result.M[52] = n0_12;
    result.M[53] = z4442;
    result.M[54] = z4463;
    result.M[55] = z4464;
    result.M[56] = z4461;
    result.M[57] = -z4462;
    result.M[58] = z4458;
    result.M[59] = -z4454;
    result.M[60] = z587;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z4497;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z4446;
    result.M[76] = z4444;
    result.M[77] = z4442;
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
    result.C[27] = z4753;
    result.C[28] = z4752;
    result.C[29] = n0;
    result.C[30] = -z4754;
    result.C[31] = z4748;
    result.C[32] = -z4794;
    result.C[33] = z4847;
    result.C[34] = z4828;
    result.C[35] = z4909;
    result.C[36] = z4785;
    result.C[37] = -z4786;
    result.C[38] = z4783;
    result.C[39] = z4784;
    result.C[40] = z4764;
    result.C[41] = z4793;
    result.C[42] = -z4846;
    result.C[43] = z4827;
    result.C[44] = z4908;
    result.C[45] = -z4822;
    result.C[46] = z4823;
    result.C[47] = z4820;
    result.C[48] = -z4821;
    result.C[49] = -z4817;
    result.C[50] = -z4791;
    result.C[51] = z4842;
    result.C[52] = n0;
    result.C[53] = z4904;
    result.C[54] = z4895;
    result.C[55] = z4896;
    result.C[56] = -z4893;
    result.C[57] = -z4894;
    result.C[58] = -z4890;
    result.C[59] = -z4886;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z4899;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z4828;
    result.C[67] = z4824;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = z4909;
    result.C[76] = -z4905;
    result.C[77] = z4901;
    result.C[78] = z4910;
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
    result.K[27] = z4758;
    result.K[28] = -z4759;
    result.K[29] = n0;
    result.K[30] = z4916;
    result.K[31] = -z4918;
    result.K[32] = z4925;
    result.K[33] = -z4931;
    result.K[34] = z4932;
    result.K[35] = z4937;
    result.K[36] = z4775;
    result.K[37] = z4776;
    result.K[38] = z4773;
    result.K[39] = -z4947;
    result.K[40] = z4970;
    result.K[41] = -z4986;
    result.K[42] = z5006;
    result.K[43] = -z5008;
    result.K[44] = z5015;
    result.K[45] = z4808;
    result.K[46] = -z4809;
    result.K[47] = -z4806;
    result.K[48] = z5022;
    result.K[49] = z5029;
    result.K[50] = z5044;
    result.K[51] = -z5071;
    result.K[52] = n0;
    result.K[53] = -z5078;
    result.K[54] = -z4871;
    result.K[55] = -z4872;
    result.K[56] = -z4869;
    result.K[57] = z5085;
    result.K[58] = -z5092;
    result.K[59] = z5098;
    result.K[60] = z5115;
    result.K[61] = n0;
    result.K[62] = z5122;
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
    result.F[0] = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z4614;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z4615;
    result.F[2] = -l_lambda_rear_touches - l_lambda_front_touches + z4616;
    result.F[3] = l_lambda_rear_rolls_x * z4286 + l_lambda_rear_rolls_y * z4285 + l_lambda_front_rolls_x * z4310
        + l_lambda_front_rolls_y * z4309 - z5136;
    result.F[4] = -l_lambda_rear_rolls_x * z4288 + l_lambda_rear_touches * z4140 - l_lambda_rear_rolls_y * z4289
        - l_lambda_front_touches * z4223 - l_lambda_front_rolls_x * z4312 - l_lambda_front_rolls_y * z4313 - z5134;
    result.F[5] = l_lambda_rear_rolls_x * z4290 - z5129 + l_lambda_rear_rolls_y * z4291 + l_lambda_front_touches * z4234
        + l_lambda_front_rolls_x * z4314 + l_lambda_front_rolls_y * z4315;
    result.F[6] = l_lambda_front_touches * z4256 - z5137 + l_lambda_front_rolls_x * z4335 + l_lambda_front_rolls_y
        * z4337;
    result.F[7] = l_lambda_rear_rolls_x * z4290 - z4595 + l_lambda_rear_rolls_y * z4291;
    result.F[8] = l_lambda_front_rolls_x * z4342 - z4575 + l_lambda_front_rolls_y * z4344;
    result.M_r[0] = z5724;
    result.M_r[1] = -z5725;
    result.M_r[2] = -z5726;
    result.M_r[3] = -z5725;
    result.M_r[4] = -z5727;
    result.M_r[5] = -z5728;
    result.M_r[6] = -z5726;
    result.M_r[7] = -z5728;
    result.M_r[8] = z5729;
    result.C_r[0] = z5774;
    result.C_r[1] = z5777;
    result.C_r[2] = z5780;
    result.C_r[3] = z5775;
    result.C_r[4] = z5778;
    result.C_r[5] = -z5781;
    result.C_r[6] = z5776;
    result.C_r[7] = z5779;
    result.C_r[8] = -z5782;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z5868;
    result.K_r[7] = z5871;
    result.K_r[8] = -z5874;
    result.K_r[9] = z5869;
    result.K_r[10] = z5872;
    result.K_r[11] = z5875;
    result.K_r[12] = z5870;
    result.K_r[13] = z5873;
    result.K_r[14] = -z5876;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = -z5889;
    result.F_r[1] = z5890;
    result.F_r[2] = z5891;
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
    result.A[20] = z5552;
    result.A[21] = -z5555;
    result.A[22] = -z5554;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z5557;
    result.A[27] = -z5914;
    result.A[28] = z5915;
    result.A[29] = z5916;
    result.A[30] = -z5563;
    result.A[31] = z5566;
    result.A[32] = z5565;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z5568;
    result.A[37] = -z5924;
    result.A[38] = z5925;
    result.A[39] = -z5926;
    result.A[40] = z5574;
    result.A[41] = -z5577;
    result.A[42] = -z5576;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z5579;
    result.A[47] = -z5929;
    result.A[48] = z5930;
    result.A[49] = z5931;
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
    result.A[70] = z5521;
    result.A[71] = -z5524;
    result.A[72] = -z5523;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z5904;
    result.A[78] = z5905;
    result.A[79] = -z5906;
    result.A[80] = z5531;
    result.A[81] = -z5534;
    result.A[82] = -z5533;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z5536;
    result.A[87] = -z5909;
    result.A[88] = z5910;
    result.A[89] = z5911;
    result.A[90] = -z5538;
    result.A[91] = -z5541;
    result.A[92] = -z5540;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z5543;
    result.A[97] = -z5919;
    result.A[98] = z5920;
    result.A[99] = z5921;
    if (!(traits::regular(z5502, z5504) && traits::regular(z5505, z5507) && traits::regular(z5508, z5510)
        && traits::regular(z5511, z5513) && traits::regular(z5900, z5724) && traits::regular(-z5897, -z5727)
        && traits::regular(z5729, z5729))) return torsor::Status::singular;
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
