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
// joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   forward_dynamics       1093             1487         26             2                  4       0   2616    2779
//   energy                  109              162          0             0                  6       0    283     302
//   first_integrals         110              162          0             0                  6       0    284     303
//   constraints             339              537         14             2                  4       0    900     941
//   linearisation          2893             3919        107             2                  6       0   6933    7263
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

namespace whipple_bicycle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "whipple_bicycle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe066f36c4b7b9329ULL;
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
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
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
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
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
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z41 = z31 * s_steer;
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z39 = z32 * s_steer;
    const Scalar z48 = s_yaw * c_roll;
    const Scalar z52 = n1 - s_roll * s_roll;
    const Scalar z49 = c_yaw * c_roll;
    const Scalar z62 = v_roll * s_roll;
    const Scalar z61 = v_yaw * c_yaw;
    const Scalar z60 = v_roll * c_roll;
    const Scalar z65 = v_yaw * s_yaw;
    const Scalar z72 = s_yaw * s_roll;
    const Scalar z74 = c_yaw * s_roll;
    const Scalar z76 = n2 * s_roll * c_roll;
    const Scalar z50 = s_roll * z48;
    const Scalar z51 = s_roll * z49;
    const Scalar z63 = s_yaw * z62 - c_roll * z61;
    const Scalar z66 = c_yaw * z62 + c_roll * z65;
    const Scalar z68 = n2 * s_roll * z60;
    const Scalar z73 = s_roll * z72 - c_roll * z48;
    const Scalar z75 = s_roll * z74 - c_roll * z49;
    const Scalar z80 = v_roll * z60;
    const Scalar z81 = v_yaw * z65;
    const Scalar z83 = v_roll * z62;
    const Scalar z85 = v_yaw * z61;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z106 = s_pitch * z41 - c_pitch * z39;
    const Scalar z107 = s_pitch * z39 + c_pitch * z41;
    const Scalar z53 = z52 * z52 + z50 * z50 + z51 * z51;
    const Scalar z82 = s_yaw * z80 + c_roll * z81 + n2 * z61 * z62;
    const Scalar z86 = c_yaw * z80 + c_roll * z85 - n2 * z62 * z65;
    const Scalar z88 = n2 * (s_roll * z83 - z60 * z60);
    const Scalar z92 = n0_35 * z40 + n0_08 * z38;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z64 = s_roll * z63 - z48 * z60;
    const Scalar z67 = s_roll * z66 - z49 * z60;
    const Scalar z77 = n2 * (z52 * z76 + z50 * z73 + z51 * z75);
    const Scalar z108 = s_roll * z107 - c_roll * c_steer;
    const Scalar z109 = s_roll * c_steer + c_roll * z107;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z114 = n1 - z109 * z109;
    const Scalar z54 = traits::sqrt(z53);
    const Scalar z97 = s_pitch * z96 + c_pitch * z95;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z69 = n2 * (z52 * z68 + z50 * z64 + z51 * z67);
    const Scalar z84 = z48 * z83 + n2 * z60 * z63 + s_roll * z82;
    const Scalar z87 = z49 * z83 + n2 * z60 * z66 + s_roll * z86;
    const Scalar z89 = n2 * (z50 * z84 + z51 * z87 - z52 * z88 - z64 * z64 - z67 * z67 - z68 * z68);
    const Scalar z110 = c_yaw * z106 + s_yaw * z108;
    const Scalar z112 = z109 * z110;
    const Scalar z111 = s_yaw * z106 - c_yaw * z108;
    const Scalar z78 = n0_5 * z77 / z54;
    const Scalar z113 = z109 * z111;
    const Scalar z99 = s_roll * z98 - c_roll * z93;
    const Scalar z115 = z114 * z114 + z112 * z112 + z113 * z113;
    const Scalar z101 = s_yaw * z99 - c_yaw * z97;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z103 = q_z - z100;
    const Scalar z116 = traits::sqrt(z115);
    const Scalar z102 = s_yaw * z97 + c_yaw * z99;
    const Scalar z105 = q_x - z101;
    const Scalar z104 = q_y + z102;
    const Scalar z79 = n0_3 * z78;
    const Scalar z55 = n0_3 / z54;
    const Scalar z58 = q_z + z52 * z55;
    const Scalar z56 = q_x + z50 * z55;
    const Scalar z57 = q_y - z51 * z55;
    const Scalar z126 = v_pitch * c_pitch;
    const Scalar z131 = v_pitch * s_pitch;
    const Scalar z122 = v_steer * c_steer;
    const Scalar z127 = v_steer * s_steer;
    const Scalar z123 = z32 * z122;
    const Scalar z124 = z31 * z122;
    const Scalar z129 = z31 * z32 * z127;
    const Scalar z128 = -z127 * (n1 - z31 * z31);
    const Scalar z130 = n0_35 * z129 + n0_08 * z128;
    const Scalar z125 = n0_08 * z123 - n0_35 * z124;
    const Scalar z70 = n0_5 * z69 / z54;
    const Scalar z90 = n0_5 * (z69 * z70 / (z54 * z54) + z89 / z54);
    const Scalar z117 = n0_35 / z116;
    const Scalar z151 = c_yaw * z109;
    const Scalar z152 = z109 * z151 + z108 * z111;
    const Scalar z149 = s_yaw * z109;
    const Scalar z150 = z108 * z110 - z109 * z149;
    const Scalar z137 = z39 * z126 - z41 * z131 + s_pitch * z123 + c_pitch * z124;
    const Scalar z140 = z39 * z131 + z41 * z126 + s_pitch * z124 - c_pitch * z123;
    const Scalar z118 = z105 - z112 * z117;
    const Scalar z120 = z103 + z114 * z117;
    const Scalar z119 = z104 - z113 * z117;
    const Scalar z139 = c_roll * z127 + c_steer * z62 + z60 * z107 + s_roll * z137;
    const Scalar z143 = z61 * z106 + z65 * z108 + s_yaw * z140 - c_yaw * z139;
    const Scalar z91 = n0_3 * z90;
    const Scalar z168 = z32 * c_steer;
    const Scalar z169 = z31 * c_steer;
    const Scalar z159 = s_roll * z106;
    const Scalar z178 = s_pitch * z168 + c_pitch * z169;
    const Scalar z181 = s_pitch * z169 - c_pitch * z168;
    const Scalar z170 = n0_08 * z168 - n0_35 * z169;
    const Scalar z160 = s_yaw * z159 - c_yaw * z107;
    const Scalar z162 = s_yaw * z107 + c_yaw * z159;
    const Scalar z180 = c_roll * s_steer + s_roll * z178;
    const Scalar z179 = s_roll * s_steer - c_roll * z178;
    const Scalar z158 = c_roll * z106;
    const Scalar z161 = z109 * z160 + z110 * z158;
    const Scalar z163 = z109 * z162 - z111 * z158;
    const Scalar z164 = n2 * z109 * z158;
    const Scalar z165 = n2 * (z112 * z161 - z113 * z163 - z114 * z164);
    const Scalar z182 = c_yaw * z181 + s_yaw * z180;
    const Scalar z184 = s_yaw * z181 - c_yaw * z180;
    const Scalar z183 = z109 * z182 - z110 * z179;
    const Scalar z185 = z109 * z184 - z111 * z179;
    const Scalar z186 = n2 * z109 * z179;
    const Scalar z153 = n2 * z108 * z109;
    const Scalar z154 = n2 * (z113 * z152 - z114 * z153 + z112 * z150);
    const Scalar z187 = n2 * (z114 * z186 + z112 * z183 + z113 * z185);
    const Scalar z166 = n0_5 * z165 / z116;
    const Scalar z172 = z31 * z32 * s_steer;
    const Scalar z171 = -s_steer * (n1 - z31 * z31);
    const Scalar z173 = n0_35 * z172 + n0_08 * z171;
    const Scalar z155 = n0_5 * z154 / z116;
    const Scalar z174 = -s_steer * (n1 - z32 * z32);
    const Scalar z175 = n0_08 * z172 + n0_35 * z174;
    const Scalar z188 = n0_5 * z187 / z116;
    const Scalar z138 = s_roll * z127 - c_steer * z60 + z62 * z107 - c_roll * z137;
    const Scalar z176 = s_pitch * z173 - c_pitch * z175;
    const Scalar z141 = z61 * z108 - z65 * z106 + c_yaw * z140 + s_yaw * z139;
    const Scalar z177 = s_roll * z170 - c_roll * z176;
    const Scalar z145 = n2 * z109 * z138;
    const Scalar z156 = z99 - n0_35 * z155;
    const Scalar z144 = z109 * z143 - z111 * z138;
    const Scalar z189 = z177 - n0_35 * z188;
    const Scalar z132 = -z127 * (n1 - z32 * z32);
    const Scalar z133 = n0_08 * z129 + n0_35 * z132;
    const Scalar z194 = v_steer * z122;
    const Scalar z157 = c_roll * z97;
    const Scalar z167 = z157 + n0_35 * z166;
    const Scalar z142 = z109 * z141 - z110 * z138;
    const Scalar z190 = v_steer * z127;
    const Scalar z191 = z32 * z190;
    const Scalar z192 = z31 * z190;
    const Scalar z146 = n2 * (z114 * z145 + z113 * z144 + z112 * z142);
    const Scalar z134 = s_pitch * z130 - c_pitch * z133 - z95 * z126 - z96 * z131;
    const Scalar z147 = n0_5 * z146 / z116;
    const Scalar z195 = -z194 * (n1 - z31 * z31);
    const Scalar z193 = n0_08 * z191 - n0_35 * z192;
    const Scalar z135 = z60 * z93 + s_roll * z125 - z62 * z98 - c_roll * z134;
    const Scalar z136 = v_z - z135;
    const Scalar z226 = n0_3 * z70 / (z54 * z54);
    const Scalar z229 = v_z - z55 * z68 + z52 * z226;
    const Scalar z227 = v_y + z55 * z67 - z51 * z226;
    const Scalar z235 = v_x - z55 * z64 + z50 * z226;
    const Scalar z218 = q_z - z58;
    const Scalar z216 = q_x - z56;
    const Scalar z217 = q_y - z57;
    const Scalar z230 = v_z - z229;
    const Scalar z228 = v_y - z227;
    const Scalar z236 = v_x - z235;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z257 = s_roll * z256;
    const Scalar z255 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z250 = s_pitch * z31 - c_pitch * z32;
    const Scalar z259 = s_yaw * z257 - c_yaw * z255;
    const Scalar z251 = s_roll * z250;
    const Scalar z258 = c_roll * z256;
    const Scalar z261 = q_z - z258;
    const Scalar z249 = s_pitch * z32 + c_pitch * z31;
    const Scalar z240 = q_x - z118;
    const Scalar z252 = c_roll * z250;
    const Scalar z242 = q_z - z120;
    const Scalar z253 = s_yaw * z251 - c_yaw * z249;
    const Scalar z244 = c_yaw * z242;
    const Scalar z247 = s_roll * z240 + z48 * z242;
    const Scalar z260 = s_yaw * z255 + c_yaw * z257;
    const Scalar z241 = q_y - z119;
    const Scalar z254 = s_yaw * z249 + c_yaw * z251;
    const Scalar z243 = s_yaw * z242;
    const Scalar z246 = s_roll * z241 - z49 * z242;
    const Scalar z220 = c_yaw * z218;
    const Scalar z219 = s_yaw * z218;
    const Scalar z200 = v_pitch * z131;
    const Scalar z201 = v_pitch * z126;
    const Scalar z204 = z39 * z200 + z41 * z201 + s_pitch * z191 + c_pitch * z192 - n2 * (z123 * z126 - z124 * z131);
    const Scalar z206 = z41 * z200 - z39 * z201 + s_pitch * z192 - c_pitch * z191 - n2 * (z123 * z131 + z124 * z126);
    const Scalar z223 = s_roll * z216 + z48 * z218;
    const Scalar z222 = s_roll * z217 - z49 * z218;
    const Scalar z196 = z31 * z32 * z194;
    const Scalar z262 = q_y + z260;
    const Scalar z197 = n0_35 * z196 + n0_08 * z195;
    const Scalar z263 = q_x - z259;
    const Scalar z205 = z83 * z107 - c_roll * z194 - c_steer * z80 - n2 * (z60 * z137 - z62 * z127) + s_roll * z204;
    const Scalar z208 = s_roll * z194 + c_steer * z83 + z80 * z107 + n2 * (z60 * z127 + z62 * z137) + c_roll * z204;
    const Scalar z198 = -z194 * (n1 - z32 * z32);
    const Scalar z199 = n0_08 * z196 + n0_35 * z198;
    const Scalar z264 = z118 - z263;
    const Scalar z266 = z120 - z261;
    const Scalar z265 = z119 - z262;
    const Scalar z267 = z252 * z265 + z254 * z266;
    const Scalar z202 = z95 * z200 - z96 * z201 + s_pitch * z197 - c_pitch * z199 + n2 * (z126 * z130 + z131 * z133);
    const Scalar z268 = z252 * z264 - z253 * z266;
    const Scalar z203 = z83 * z93 + s_roll * z193 + z80 * z98 - n2 * (z60 * z125 + z62 * z134) + c_roll * z202;
    const Scalar z270 = z105 - z118;
    const Scalar z272 = z103 - z120;
    const Scalar z271 = z104 - z119;
    const Scalar z273 = z109 * z271 - z111 * z272;
    const Scalar z210 = z81 * z106 - z85 * z108 - n2 * (z61 * z140 + z65 * z139) + s_yaw * z206 - c_yaw * z205;
    const Scalar z207 = z85 * z106 + z81 * z108 - n2 * (z61 * z139 - z65 * z140) + c_yaw * z206 + s_yaw * z205;
    const Scalar z277 = s_pitch * z133 + c_pitch * z130 + z95 * z131 - z96 * z126;
    const Scalar z211 = n2 * z138 * z143 + z111 * z208 + z109 * z210;
    const Scalar z209 = n2 * z138 * z141 + z110 * z208 + z109 * z207;
    const Scalar z278 = c_roll * z125 - z62 * z93 - z60 * z98 + s_roll * z134;
    const Scalar z212 = n2 * (z109 * z208 - z138 * z138);
    const Scalar z213 = n2 * (z113 * z211 - z145 * z145 - z144 * z144 - z142 * z142 - z114 * z212 + z112 * z209);
    const Scalar z274 = z109 * z270 - z110 * z272;
    const Scalar z279 = s_yaw * z277 - z61 * z97 + z65 * z99 + c_yaw * z278;
    const Scalar z280 = v_y - z279;
    const Scalar z281 = n0_35 * z147 / (z116 * z116);
    const Scalar z231 = z61 * z218 + s_yaw * z230;
    const Scalar z282 = z280 - z117 * z144 + z113 * z281;
    const Scalar z237 = c_yaw * z230 - z65 * z218;
    const Scalar z214 = n0_5 * (z146 * z147 / (z116 * z116) + z213 / z116);
    const Scalar z232 = z60 * z217 + z66 * z218 + s_roll * z228 - z49 * z230;
    const Scalar z233 = v_yaw * z228 - v_roll * z231 + z232 * (v_pitch + v_rear);
    const Scalar z238 = z60 * z216 - z63 * z218 + s_roll * z236 + z48 * z230;
    const Scalar z239 = v_yaw * z236 - v_roll * z237 + z238 * (v_pitch + v_rear);
    const Scalar z283 = v_y - z282;
    const Scalar z215 = z203 - n0_35 * z214;
    const Scalar z308 = s_yaw * z278 - c_yaw * z277 - z61 * z99 - z65 * z97;
    const Scalar z284 = z114 * z281 - z136 - z117 * z145;
    const Scalar z309 = v_x + z308;
    const Scalar z303 = z280 - z282;
    const Scalar z310 = z309 - z117 * z142 + z112 * z281;
    const Scalar z304 = z136 + z284;
    const Scalar z305 = z109 * z303 - z138 * z271 - z143 * z272 - z111 * z304;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z327 = v_roll * z322;  // angular acceleration of frame.2, z
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z319 = z309 - z310;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z320 = z109 * z319 - z138 * z270 - z141 * z272 - z110 * z304;
    const Scalar z331 = c_pitch * z327;
    const Scalar z336 = v_pitch * z328 - z331;  // angular acceleration of frame, z
    const Scalar z325 = n9_81 * c_roll;
    const Scalar z340 = z334 * z334;
    const Scalar z341 = z329 * z329;
    const Scalar z326 = v_roll * z323;  // angular acceleration of frame.2, y
    const Scalar z330 = s_pitch * z327;
    const Scalar z335 = v_pitch * z329 - z330;  // angular acceleration of frame, x
    const Scalar z332 = s_pitch * z325;
    const Scalar z333 = c_pitch * z325;
    const Scalar z342 = z340 + z341;
    const Scalar z343 = z328 * z329;
    const Scalar z345 = z328 * z334;
    const Scalar z346 = z336 + z345;
    const Scalar z324 = n9_81 * s_roll;
    const Scalar z344 = z326 + z343;
    const Scalar z347 = z329 * z334;
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z290 = n0_3 * z126 - n1_1 * z131;
    const Scalar z296 = z31 * z131 - z32 * z126;
    const Scalar z288 = z31 * z126 + z32 * z131;
    const Scalar z291 = n1_1 * z126 + n0_3 * z131;
    const Scalar z292 = z60 * z256 + s_roll * z291;
    const Scalar z299 = c_roll * z291 - z62 * z256;
    const Scalar z289 = c_roll * z288 - z62 * z250;
    const Scalar z297 = z60 * z250 + s_roll * z288;
    const Scalar z314 = z65 * z255 - c_yaw * z290 + z61 * z257 + s_yaw * z292;
    const Scalar z293 = z61 * z255 + s_yaw * z290 - z65 * z257 + c_yaw * z292;
    const Scalar z315 = v_x - z314;
    const Scalar z316 = z310 - z315;
    const Scalar z311 = v_x - z310;
    const Scalar z294 = v_y + z293;
    const Scalar z300 = v_z - z299;
    const Scalar z301 = z284 + z300;
    const Scalar z295 = z282 - z294;
    const Scalar z285 = v_z + z284;
    const Scalar z313 = z60 * z240 - z63 * z242 + s_roll * z311 + z48 * z285;
    const Scalar z287 = z60 * z241 + z66 * z242 + s_roll * z283 - z49 * z285;
    const Scalar z348 = z335 + z347;
    const Scalar z317 = z65 * z249 + c_yaw * z296 + z61 * z251 + s_yaw * z297;
    const Scalar z298 = s_yaw * z296 - z61 * z249 + z65 * z251 - c_yaw * z297;
    const Scalar z318 = z264 * z289 - z266 * z317 + z252 * z316 + z253 * z301;
    const Scalar z302 = z265 * z289 - z266 * z298 + z252 * z295 - z254 * z301;
    const Scalar z286 = z61 * z242 + s_yaw * z285;
    const Scalar z312 = c_yaw * z285 - z65 * z242;
    const Scalar z321 = v_yaw * z311 + v_pitch * z313 + v_steer * z318 - v_roll * z312 + v_front * z320;
    const Scalar z306 = v_yaw * z283 - v_roll * z286 + v_pitch * z287 + v_steer * z302 + v_front * z305;
    const Scalar z349 = z326 - z343;
    const Scalar z350 = z328 * z328;
    const Scalar z351 = z340 + z350;
    const Scalar z411 = z341 - z350;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z358 = z332 - n1_1 * z342 + n0_3 * z344;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z352 = z39 * z334 + z40 * z329 + z38 * z328;
    const Scalar z407 = z328 * z337;
    const Scalar z406 = z329 * z337;
    const Scalar z410 = n0_12 * z407;  // moment on rear_wheel, z
    const Scalar z408 = n0_12 * z406;  // moment on rear_wheel, x
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z364 = z31 * z354 - z32 * z352;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z359 = z324 - n1_1 * z346 - n0_3 * z348;
    const Scalar z360 = z333 + n1_1 * z349 + n0_3 * z351;
    const Scalar z370 = z353 * z353;
    const Scalar z371 = z366 * z366;
    const Scalar z357 = z41 * z326 + z40 * z335 - z42 * z336;
    const Scalar z369 = z31 * v_steer * z353 + z357;  // angular acceleration of fork, z
    const Scalar z356 = c_steer * z326 + z39 * z335 + z41 * z336;
    const Scalar z355 = z38 * z335 - z39 * z326 - z40 * z336;
    const Scalar z368 = v_steer * z364 + z356;  // angular acceleration of fork, y
    const Scalar z422 = z322 * z323;
    const Scalar z367 = z32 * v_steer * z353 - z355;  // angular acceleration of fork, x
    const Scalar z423 = n2 * z327;
    const Scalar z372 = z370 + z371;
    const Scalar z361 = z38 * z358 - z39 * z359 - z40 * z360;
    const Scalar z362 = z39 * z358 + z41 * z360 + c_steer * z359;
    const Scalar z363 = z40 * z358 + z41 * z359 - z42 * z360;
    const Scalar z442 = n0_28 * z41;
    const Scalar z440 = n0_28 * z39;
    const Scalar z441 = n0_28 * c_steer;
    const Scalar z443 = s_pitch * z442 - c_pitch * z440;
    const Scalar z444 = s_pitch * z440 + c_pitch * z442;
    const Scalar z375 = z353 * z365;
    const Scalar z373 = z365 * z366;
    const Scalar z380 = z365 * z365;
    const Scalar z381 = z370 + z380;
    const Scalar z393 = z371 - z380;
    const Scalar z376 = z369 - z375;
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z446 = s_roll * z441 + c_roll * z444;
    const Scalar z377 = z353 * z366;
    const Scalar z388 = z366 * z385;
    const Scalar z389 = z365 * z385;
    const Scalar z390 = n0_28 * z388;  // moment on front_wheel, x
    const Scalar z392 = n0_28 * z389;  // moment on front_wheel, z
    const Scalar z374 = z368 + z373;
    const Scalar z394 = n1_04 * z372 + n7 * z361 - n3_85 * z374;  // force on fork, x
    const Scalar z397 = z390 + k17 * z377 - k3 * z367 - k4 * z376 + n3_85 * z362;  // moment on fork, x
    const Scalar z378 = z367 - z377;
    const Scalar z399 = z392 + k18 * z375 - k5 * z369 - k4 * z378 + n1_04 * z362;  // moment on fork, z
    const Scalar z395 = n7 * z362 - n1_04 * z376 - n3_85 * z378;  // force on fork, y
    const Scalar z452 = z39 * z449;
    const Scalar z456 = z39 * z450 + z41 * z451;
    const Scalar z454 = z41 * z449;
    const Scalar z453 = c_steer * z449;
    const Scalar z455 = z38 * z450 - z40 * z451;
    const Scalar z379 = z368 - z373;
    const Scalar z396 = n3_85 * z381 + n7 * z363 + n1_04 * z379;  // force on fork, z
    const Scalar z459 = n0_3 * z452 - z456 + n1_1 * z454;
    const Scalar z458 = n0_3 * z453 - z455;
    const Scalar z457 = z40 * z450 - z42 * z451;
    const Scalar z460 = n1_1 * z453 + z457;
    const Scalar z462 = s_pitch * z452 + c_pitch * z454;
    const Scalar z461 = s_pitch * z454 - c_pitch * z452;
    const Scalar z463 = s_pitch * z460 - c_pitch * z458;
    const Scalar z391 = n0_28 * z368;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z398 = k4 * z393 - z391 - k19 * z373 - n2_5667 * z368 + n3_85 * z361 - n1_04 * z363;
    const Scalar z464 = c_pitch * z460 + s_pitch * z458;
    const Scalar z468 = s_roll * z459 - c_roll * z464;
    const Scalar z477 = n3_85 * z40 + n1_04 * z38;
    const Scalar z479 = n1_04 * z40 + n3_85 * z42;
    const Scalar z478 = n1_04 * z39 - n3_85 * z41;
    const Scalar z466 = s_roll * z453 + c_roll * z462;
    const Scalar z465 = s_roll * z462 - c_roll * z453;
    const Scalar z470 = s_yaw * z461 - c_yaw * z465;
    const Scalar z469 = c_yaw * z461 + s_yaw * z465;
    const Scalar z409 = n0_12 * z326;  // moment on rear_wheel, y
    const Scalar z400 = z38 * z394 + z39 * z395 + z40 * z396;
    const Scalar z412 = n25_5 * z342 - z400 + n51 * z344;  // force on frame, x
    const Scalar z480 = k3 * z38 - k4 * z40;
    const Scalar z402 = z40 * z394 - z41 * z395 + z42 * z396;
    const Scalar z401 = z41 * z396 - z39 * z394 + c_steer * z395;
    const Scalar z414 = n25_5 * z349 - z402 - n51 * z351;  // force on frame, z
    const Scalar z481 = n2_8467 * z39;
    const Scalar z482 = k4 * z38 - k5 * z40;
    const Scalar z405 = z40 * z397 - z42 * z399 + z41 * z398;
    const Scalar z417 = n25_5 * z324 - z410 - n9_95 * z346 + n17_7 * z348 + n1_1 * z401 + z405;  // moment on frame, z
    const Scalar z419 = s_pitch * z412 - c_pitch * z414;
    const Scalar z418 = s_pitch * z414 + c_pitch * z412;
    const Scalar z413 = n25_5 * z346 - z401 - n51 * z348;  // force on frame, y
    const Scalar z403 = z38 * z397 - z40 * z399 - z39 * z398;
    const Scalar z415 = n51 * z324 + z408 - n17_7 * z346 + n39_3 * z348 - n0_3 * z401 + z403;  // moment on frame, x
    const Scalar z404 = z41 * z399 + z39 * z397 + c_steer * z398;
    // moment on frame, y
    const Scalar z416 = z409 + n49_25 * z326 - n51 * z332 + n25_5 * z333 + n29_35 * z343 + n17_7 * z411 + n0_3 * z400
        - n1_1 * z402 - z404;
    const Scalar z489 = z39 * z481 + z38 * z480 - z40 * z482;
    const Scalar z439 = z31 * z397 - z32 * z399;
    const Scalar z498 = n0_63 - n0_6 * z479 + z489;
    const Scalar z487 = n2_8467 * z41;
    const Scalar z486 = k3 * z40 - k4 * z42;
    const Scalar z484 = n2_8467 * c_steer;
    const Scalar z488 = k4 * z40 - k5 * z42;
    const Scalar z497 = z41 * z487 + z40 * z486 - z42 * z488;
    const Scalar z483 = k3 * z39 + k4 * z41;
    const Scalar z485 = k4 * z39 + k5 * z41;
    const Scalar z495 = z38 * z486 - z39 * z487 - z40 * z488;
    const Scalar z496 = c_steer * z487 + z39 * z486 + z41 * z488;
    const Scalar z492 = z38 * z483 - z39 * z484 - z40 * z485;
    const Scalar z493 = c_steer * z484 + z39 * z483 + z41 * z485;
    const Scalar z504 = n2_31 - n0_3 * z477 - n1_1 * z479 - z495;
    const Scalar z502 = n9_1 - n2_2 * z477 - n0_6 * z479 + z493;
    const Scalar z501 = n1_1 * z478 + z492;
    const Scalar z505 = n0_3 * z478 + z496;
    const Scalar z426 = s_roll * z419 - c_roll * z413;
    const Scalar z427 = s_roll * z413 + c_roll * z419;
    const Scalar z434 = n853_47 - z427;  // force on frame.z, z
    const Scalar z420 = s_pitch * z417 + c_pitch * z415;
    const Scalar z421 = s_pitch * z415 - c_pitch * z417;
    const Scalar z424 = z420 - n0_5603 * z422;  // moment on frame.2, x
    const Scalar z425 = z421 - n0_5603 * z423;  // moment on frame.2, z
    const Scalar z506 = n8_47 - n2_2 * z477 + z497;
    const Scalar z513 = n29_35 - z506;
    const Scalar z512 = n17_7 - z504;
    const Scalar z511 = n49_25 + z502;
    const Scalar z507 = n7_7 - z477;
    const Scalar z508 = n2_1 - z479;
    const Scalar z509 = n25_5 + z507;
    const Scalar z510 = n51 - z508;
    const Scalar z429 = s_roll * z416 + c_roll * z425;
    const Scalar z515 = n0_12 * s_roll;
    const Scalar z430 = s_yaw * z426 - c_yaw * z418;
    const Scalar z431 = s_yaw * z418 + c_yaw * z426;
    const Scalar z590 = n25_over_7 * z441;
    const Scalar z535 = z498 + z513;
    const Scalar z536 = n2 * z512;
    const Scalar z537 = s_pitch * z535 - c_pitch * z536;
    const Scalar z600 = n0_28 * c_steer * c_steer - z511;
    const Scalar z518 = n0_12 + z511;
    const Scalar z607 = z459 * z601;
    const Scalar z543 = n39_8603 - z518;
    const Scalar z522 = s_pitch * z501 - c_pitch * z505;
    const Scalar z521 = s_pitch * z505 + c_pitch * z501;
    const Scalar z541 = c_pitch * z537 + z512;
    const Scalar z538 = s_pitch * z537;
    const Scalar z526 = s_roll * z518 - c_roll * z522;
    const Scalar z539 = z513 - z538;
    const Scalar z540 = z498 - z538;
    const Scalar z557 = n2 * z522;
    const Scalar z547 = s_roll * z521 - c_roll * z541;
    const Scalar z556 = z539 - z543;
    const Scalar z542 = n39_8603 + z540;
    const Scalar z595 = z443 * z590 - z521;
    const Scalar z558 = s_roll * z556 - c_roll * z557;
    const Scalar z594 = z446 * z590 - z526;
    const Scalar z599 = z515 + z594;
    const Scalar z589 = n25_over_7 * z443;
    const Scalar z593 = z443 * z589 - z542;
    const Scalar z592 = z446 * z589 - z547;
    const Scalar z606 = z463 * z601;
    const Scalar z588 = n25_over_7 * z446;
    const Scalar z597 = n25_over_3 * z515;
    const Scalar z559 = s_roll * z558;
    const Scalar z605 = z468 * z601;
    const Scalar z519 = s_pitch * z509 + c_pitch * z510;
    const Scalar z520 = s_pitch * z510 - c_pitch * z509;
    const Scalar z561 = z539 - z559;
    const Scalar z622 = z463 * z606 + z593;
    const Scalar z621 = z468 * z606 - z592;
    const Scalar z564 = n39_8603 - z561;
    const Scalar z524 = c_roll * z520;
    const Scalar z545 = s_roll * z519 - c_roll * z478;
    const Scalar z591 = z446 * z588 - z564;
    const Scalar z544 = s_roll * z478 + c_roll * z519;
    const Scalar z604 = z466 * z601;
    const Scalar z616 = z466 * z605;
    const Scalar z620 = z466 * z606 - z545;
    const Scalar z598 = z515 * z597 + z591;
    const Scalar z613 = n94 - z466 * z604;
    const Scalar z523 = s_roll * z520;
    const Scalar z625 = z466 * z607 + z524;
    const Scalar z617 = z468 * z605 + z598;
    const Scalar z528 = s_yaw * z519 + c_yaw * z523;
    const Scalar z527 = s_yaw * z523 - c_yaw * z519;
    const Scalar z628 = z459 * z607 + z600;
    const Scalar z627 = z463 * z607 - z595;
    const Scalar z626 = z468 * z607 + z599;
    const Scalar z629 = n1 / z628;
    const Scalar z624 = z470 * z607 - z528;
    const Scalar z623 = z469 * z607 + z527;
    const Scalar z549 = c_yaw * z544;
    const Scalar z619 = z470 * z606 - z549;
    const Scalar z548 = s_yaw * z544;
    const Scalar z618 = z469 * z606 + z548;
    const Scalar z566 = c_yaw * z520 + s_yaw * z545;
    const Scalar z565 = s_yaw * z520 - c_yaw * z545;
    const Scalar z615 = z470 * z605 - z566;
    const Scalar z614 = z469 * z605 + z565;
    const Scalar z603 = z470 * z601;
    const Scalar z634 = z627 * z629;
    const Scalar z633 = z626 * z629;
    const Scalar z632 = z625 * z629;
    const Scalar z612 = z470 * z604;
    const Scalar z610 = n94 - z470 * z603;
    const Scalar z649 = z622 - z627 * z634;
    const Scalar z648 = z621 - z626 * z634;
    const Scalar z644 = z617 - z626 * z633;
    const Scalar z643 = z616 - z625 * z633;
    const Scalar z650 = n1 / z649;
    const Scalar z647 = z620 - z625 * z634;
    const Scalar z640 = z613 + z625 * z632;
    const Scalar z639 = z612 - z624 * z632;
    const Scalar z642 = z615 - z624 * z633;
    const Scalar z646 = z619 - z624 * z634;
    const Scalar z641 = z614 - z623 * z633;
    const Scalar z645 = z618 - z623 * z634;
    const Scalar z631 = z624 * z629;
    const Scalar z637 = z610 + z624 * z631;
    const Scalar z602 = z469 * z601;
    const Scalar z609 = z469 * z603;
    const Scalar z636 = z609 - z623 * z631;
    const Scalar z611 = z469 * z604;
    const Scalar z608 = n94 - z469 * z602;
    const Scalar z638 = z611 - z623 * z632;
    const Scalar z654 = z648 * z650;
    const Scalar z653 = z647 * z650;
    const Scalar z652 = z646 * z650;
    const Scalar z630 = z623 * z629;
    const Scalar z635 = z608 + z623 * z630;
    const Scalar z664 = z644 - z648 * z654;
    const Scalar z663 = z643 - z647 * z654;
    const Scalar z660 = z640 + z647 * z653;
    const Scalar z659 = z639 - z646 * z653;
    const Scalar z665 = n1 / z664;
    const Scalar z662 = z642 - z646 * z654;
    const Scalar z657 = z637 + z646 * z652;
    const Scalar z656 = z636 - z645 * z652;
    const Scalar z658 = z638 - z645 * z653;
    const Scalar z661 = z641 - z645 * z654;
    const Scalar z651 = z645 * z650;
    const Scalar z655 = z635 + z645 * z651;
    const Scalar z713 = z219 * z654;
    const Scalar z698 = z167 + z189 * z607;
    const Scalar z699 = z156 + z189 * z606 - z634 * z698;
    const Scalar z685 = z79 * z654;
    const Scalar z666 = z661 * z665;
    const Scalar z726 = z220 * z654;
    const Scalar z667 = z662 * z665;
    const Scalar z668 = z663 * z665;
    const Scalar z700 = z189 * z605 - z633 * z698 - z654 * z699;
    const Scalar z674 = z660 + z663 * z668;
    const Scalar z673 = z659 - z662 * z668;
    const Scalar z671 = z657 + z662 * z667;
    const Scalar z670 = z656 - z661 * z667;
    const Scalar z675 = n1 / z674;
    const Scalar z672 = z658 - z661 * z668;
    const Scalar z669 = z655 + z661 * z666;
    const Scalar z727 = z220 * z653 - z668 * z726;
    const Scalar z714 = z219 * z653 - z668 * z713;
    const Scalar z701 = n1 + z189 * z604 - z632 * z698 - z653 * z699 - z668 * z700;
    const Scalar z686 = n1 + z79 * z653 - z668 * z685;
    const Scalar z676 = z672 * z675;
    const Scalar z677 = z673 * z675;
    const Scalar z678 = z669 - z672 * z676;
    const Scalar z679 = z670 + z672 * z677;
    const Scalar z739 = z246 + z267 * z607 - z273 * z590;
    const Scalar z680 = z671 - z673 * z677;
    const Scalar z740 = z243 + z267 * z606 + z273 * z589 - z634 * z739;
    const Scalar z681 = n1 / z680;
    const Scalar z741 = z241 + z267 * z605 - z273 * z588 - z633 * z739 - z654 * z740;
    const Scalar z728 = n1 - z220 * z652 + z667 * z726 - z677 * z727;
    const Scalar z715 = z219 * z652 - z667 * z713 + z677 * z714;
    const Scalar z702 = z189 * z603 - z631 * z698 - z652 * z699 - z667 * z700 + z677 * z701;
    const Scalar z682 = z679 * z681;
    const Scalar z742 = z267 * z604 - z632 * z739 - z653 * z740 - z668 * z741;
    const Scalar z683 = z678 - z679 * z682;
    const Scalar z684 = n1 / z683;
    const Scalar z743 = z267 * z603 - z631 * z739 - z652 * z740 - z667 * z741 + z677 * z742;
    const Scalar z744 = n1 - z267 * z602 + z630 * z739 + z651 * z740 + z666 * z741 - z676 * z742 - z682 * z743;
    const Scalar z729 = z220 * z651 - z666 * z726 + z676 * z727 - z682 * z728;
    const Scalar z745 = z684 * z744;
    const Scalar z730 = z684 * z729;
    const Scalar z716 = n1 + z219 * z651 - z666 * z713 + z676 * z714 + z682 * z715;
    const Scalar z746 = z681 * z743 - z682 * z745;
    const Scalar z731 = z681 * z728 - z682 * z730;
    const Scalar z732 = z675 * z727 + z676 * z730 - z677 * z731;
    const Scalar z717 = z684 * z716;
    const Scalar z718 = z681 * z715 + z682 * z717;
    const Scalar z733 = z665 * z726 + z666 * z730 - z667 * z731 + z668 * z732;
    const Scalar z719 = z675 * z714 + z676 * z717 + z677 * z718;
    const Scalar z734 = z220 * z650 - z651 * z730 + z652 * z731 - z653 * z732 + z654 * z733;
    const Scalar z720 = z665 * z713 + z666 * z717 + z667 * z718 + z668 * z719;
    const Scalar z735 = z630 * z730 - z631 * z731 + z632 * z732 - z633 * z733 + z634 * z734;
    const Scalar z736 = z602 * z730 - z603 * z731 + z604 * z732 - z605 * z733 + z606 * z734 - z607 * z735;
    const Scalar z737 = n25_over_3 * z223 - z735 - z597 * z733;
    const Scalar z738 = z588 * z733 + z589 * z734 + z590 * z735;
    const Scalar z703 = z189 * z602 - z630 * z698 - z651 * z699 - z666 * z700 + z676 * z701 + z682 * z702;
    const Scalar z704 = z684 * z703;
    const Scalar z721 = z219 * z650 - z651 * z717 - z652 * z718 - z653 * z719 + z654 * z720;
    const Scalar z705 = z681 * z702 + z682 * z704;
    const Scalar z722 = z630 * z717 + z631 * z718 + z632 * z719 - z633 * z720 + z634 * z721;
    const Scalar z706 = z675 * z701 + z676 * z704 + z677 * z705;
    const Scalar z707 = z665 * z700 + z666 * z704 + z667 * z705 + z668 * z706;
    const Scalar z723 = z602 * z717 + z603 * z718 + z604 * z719 - z605 * z720 + z606 * z721 - z607 * z722;
    const Scalar z708 = z650 * z699 + z651 * z704 + z652 * z705 + z653 * z706 - z654 * z707;
    const Scalar z709 = z629 * z698 + z630 * z704 + z631 * z705 + z632 * z706 - z633 * z707 - z634 * z708;
    const Scalar z687 = z79 * z652 - z667 * z685 + z677 * z686;
    const Scalar z747 = z675 * z742 - z676 * z745 + z677 * z746;
    const Scalar z724 = n25_over_3 * z222 - z722 - z597 * z720;
    const Scalar z725 = z588 * z720 + z589 * z721 + z590 * z722;
    const Scalar z688 = z79 * z651 - z666 * z685 + z676 * z686 + z682 * z687;
    const Scalar z748 = z665 * z741 - z666 * z745 + z667 * z746 + z668 * z747;
    const Scalar z689 = z684 * z688;
    const Scalar z749 = z650 * z740 - z651 * z745 + z652 * z746 + z653 * z747 - z654 * z748;
    const Scalar z690 = z681 * z687 + z682 * z689;
    const Scalar z750 = z629 * z739 - z630 * z745 + z631 * z746 + z632 * z747 - z633 * z748 - z634 * z749;
    const Scalar z691 = z675 * z686 + z676 * z689 + z677 * z690;
    const Scalar z692 = z665 * z685 + z666 * z689 + z667 * z690 + z668 * z691;
    const Scalar z751 = z267 * z601 - z602 * z745 + z603 * z746 + z604 * z747 - z605 * z748 - z606 * z749 - z607 * z750;
    const Scalar z710 = z189 * z601 + z602 * z704 + z603 * z705 + z604 * z706 - z605 * z707 - z606 * z708 - z607 * z709;
    const Scalar z711 = z597 * z707 + z709;
    const Scalar z712 = z588 * z707 - z589 * z708 + z590 * z709;
    const Scalar z693 = z79 * z650 - z651 * z689 - z652 * z690 - z653 * z691 + z654 * z692;
    const Scalar z753 = n25_over_7 * z273 + z588 * z748 - z589 * z749 + z590 * z750;
    const Scalar z694 = z630 * z689 + z631 * z690 + z632 * z691 - z633 * z692 + z634 * z693;
    const Scalar z754 = z247 + z268 * z607 - z274 * z590;
    const Scalar z695 = z602 * z689 + z603 * z690 + z604 * z691 - z605 * z692 + z606 * z693 - z607 * z694;
    const Scalar z755 = z244 + z268 * z606 + z274 * z589 - z634 * z754;
    const Scalar z696 = z597 * z692 + z694;
    const Scalar z756 = z240 + z268 * z605 - z274 * z588 - z633 * z754 - z654 * z755;
    const Scalar z697 = z588 * z692 + z589 * z693 + z590 * z694;
    const Scalar z757 = z268 * z604 - z632 * z754 - z653 * z755 - z668 * z756;
    const Scalar z758 = n1 + z268 * z603 - z631 * z754 - z652 * z755 - z667 * z756 + z677 * z757;
    const Scalar z759 = z268 * z602 - z630 * z754 - z651 * z755 - z666 * z756 + z676 * z757 + z682 * z758;
    const Scalar z760 = z684 * z759;
    const Scalar z788 = z240 * z748 - z746 + z244 * z749 + z247 * z750 - z268 * z751 - z274 * z753;
    const Scalar z761 = z681 * z758 + z682 * z760;
    const Scalar z762 = z675 * z757 + z676 * z760 + z677 * z761;
    const Scalar z783 = z241 * z748 - z745 + z243 * z749 + z246 * z750 - z267 * z751 - z273 * z753;
    const Scalar z763 = z665 * z756 + z666 * z760 + z667 * z761 + z668 * z762;
    const Scalar z764 = z650 * z755 + z651 * z760 + z652 * z761 + z653 * z762 - z654 * z763;
    const Scalar z765 = z629 * z754 + z630 * z760 + z631 * z761 + z632 * z762 - z633 * z763 - z634 * z764;
    const Scalar z766 = z268 * z601 + z602 * z760 + z603 * z761 + z604 * z762 - z605 * z763 - z606 * z764 - z607 * z765;
    const Scalar z768 = n25_over_7 * z274 + z588 * z763 - z589 * z764 + z590 * z765;
    const Scalar z789 = z240 * z763 - z761 + z244 * z764 + z247 * z765 - z268 * z766 - z274 * z768;
    const Scalar z790 = n1 / z789;
    const Scalar z782 = z730 + z241 * z733 - z243 * z734 + z246 * z735 - z267 * z736 - z273 * z738;
    const Scalar z787 = z731 + z240 * z733 - z244 * z734 + z247 * z735 - z268 * z736 - z274 * z738;
    const Scalar z778 = z731 + z216 * z733 - z220 * z734 + z223 * (z735 + z737);
    const Scalar z795 = z788 * z790;
    const Scalar z794 = z787 * z790;
    const Scalar z777 = z216 * z720 - z718 - z220 * z721 + z223 * (z722 + z724);
    const Scalar z810 = z783 - z788 * z795;
    const Scalar z809 = z782 - z787 * z795;
    const Scalar z805 = z778 + z787 * z794;
    const Scalar z811 = n1 / z810;
    const Scalar z781 = z717 + z241 * z720 - z243 * z721 + z246 * z722 - z267 * z723 - z273 * z725;
    const Scalar z786 = z240 * z720 - z718 - z244 * z721 + z247 * z722 - z268 * z723 - z274 * z725;
    const Scalar z804 = z777 + z786 * z794;
    const Scalar z808 = z781 - z786 * z795;
    const Scalar z774 = z717 + z217 * z720 - z219 * z721 + z222 * (z722 + z724);
    const Scalar z793 = z786 * z790;
    const Scalar z801 = z774 + z786 * z793;
    const Scalar z773 = z704 + z217 * z707 + z219 * z708 + z222 * (z709 - z711);
    const Scalar z776 = z216 * z707 - z705 + z220 * z708 + z223 * (z709 - z711);
    const Scalar z780 = z704 + z241 * z707 + z243 * z708 + z246 * z709 - z267 * z710 - z273 * z712;
    const Scalar z785 = z240 * z707 - z705 + z244 * z708 + z247 * z709 - z268 * z710 - z274 * z712;
    const Scalar z800 = z773 + z785 * z793;
    const Scalar z803 = z776 + z785 * z794;
    const Scalar z807 = z780 - z785 * z795;
    const Scalar z771 = z156 * z708 - z706 + z167 * z709 - z189 * z710;
    const Scalar z792 = z785 * z790;
    const Scalar z798 = z771 - z785 * z792;
    const Scalar z770 = z691 + z156 * z693 - z167 * z694 + z189 * z695;
    const Scalar z772 = z689 + z217 * z692 - z219 * z693 + z222 * (z694 - z696);
    const Scalar z775 = z216 * z692 - z690 - z220 * z693 + z223 * (z694 - z696);
    const Scalar z779 = z689 + z241 * z692 - z243 * z693 + z246 * z694 - z267 * z695 - z273 * z697;
    const Scalar z784 = z240 * z692 - z690 - z244 * z693 + z247 * z694 - z268 * z695 - z274 * z697;
    const Scalar z797 = z770 + z784 * z792;
    const Scalar z799 = z772 + z784 * z793;
    const Scalar z802 = z775 + z784 * z794;
    const Scalar z806 = z779 - z784 * z795;
    const Scalar z769 = z79 * z693 - z691;
    const Scalar z791 = z784 * z790;
    const Scalar z796 = z769 - z784 * z791;
    const Scalar z752 = z597 * z748 + z750;
    const Scalar z815 = z809 * z811;
    const Scalar z825 = z805 + z809 * z815;
    const Scalar z824 = z804 + z808 * z815;
    const Scalar z823 = z803 + z807 * z815;
    const Scalar z822 = z802 + z806 * z815;
    const Scalar z826 = n1 / z825;
    const Scalar z814 = z808 * z811;
    const Scalar z821 = z801 + z808 * z814;
    const Scalar z820 = z800 + z807 * z814;
    const Scalar z819 = z799 + z806 * z814;
    const Scalar z813 = z807 * z811;
    const Scalar z818 = z798 - z807 * z813;
    const Scalar z817 = z797 + z806 * z813;
    const Scalar z812 = z806 * z811;
    const Scalar z816 = z796 - z806 * z812;
    const Scalar z767 = z597 * z763 + z765;
    const Scalar z846 = z409 + z391 * z590 + z439 * z607 - z416;
    const Scalar z847 = z391 * z589 - z439 * z606 + z634 * z846 + z424;
    const Scalar z829 = z824 * z826;
    const Scalar z828 = z823 * z826;
    const Scalar z827 = z822 * z826;
    const Scalar z835 = z821 - z824 * z829;
    const Scalar z834 = z820 - z823 * z829;
    const Scalar z832 = z818 + z823 * z828;
    const Scalar z848 = z409 * z597 + z391 * z588 + z439 * z605 - z633 * z846 + z654 * z847 - z429;
    const Scalar z836 = n1 / z835;
    const Scalar z831 = z817 - z822 * z828;
    const Scalar z849 = z434 - z439 * z604 + z632 * z846 - z653 * z847 + z668 * z848;
    const Scalar z850 = z431 - z439 * z603 + z631 * z846 - z652 * z847 + z667 * z848 + z677 * z849;
    const Scalar z851 = z430 + z439 * z602 - z630 * z846 + z651 * z847 - z666 * z848 - z676 * z849 - z682 * z850;
    const Scalar z852 = z684 * z851;
    const Scalar z833 = z819 - z822 * z829;
    const Scalar z830 = z816 + z822 * z827;
    const Scalar z838 = z834 * z836;
    const Scalar z853 = z681 * z850 - z682 * z852;
    const Scalar z841 = z832 + z834 * z838;
    const Scalar z840 = z831 - z833 * z838;
    const Scalar z837 = z833 * z836;
    const Scalar z854 = z675 * z849 - z676 * z852 + z677 * z853;
    const Scalar z839 = z830 + z833 * z837;
    const Scalar z842 = n1 / z841;
    const Scalar z855 = z665 * z848 + z666 * z852 - z667 * z853 - z668 * z854;
    const Scalar z856 = z650 * z847 - z651 * z852 + z652 * z853 + z653 * z854 + z654 * z855;
    const Scalar z857 = z629 * z846 + z630 * z852 - z631 * z853 - z632 * z854 - z633 * z855 + z634 * z856;
    const Scalar z858 = z439 * z601 + z602 * z852 - z603 * z853 - z604 * z854 - z605 * z855 + z606 * z856 - z607 * z857;
    const Scalar z860 = n25_over_7 * z391 - z588 * z855 - z589 * z856 - z590 * z857;
    const Scalar z865 = z852 - z306 + z241 * z855 - z243 * z856 + z246 * z857 - z267 * z858 + z273 * z860;
    const Scalar z866 = z853 - z321 + z240 * z855 - z244 * z856 + z247 * z857 - z268 * z858 + z274 * z860;
    const Scalar z862 = z156 * z856 - z215 - z854 - z167 * z857 + z189 * z858;
    const Scalar z859 = n25_over_3 * z409 - z857 - z597 * z855;
    const Scalar z863 = z852 - z233 + z217 * z855 - z219 * z856 + z222 * (z857 + z859);
    const Scalar z864 = z853 - z239 + z216 * z855 - z220 * z856 + z223 * (z857 + z859);
    const Scalar z861 = z854 - z91 + z79 * z856;
    const Scalar z867 = z795 * z866 - z865;
    const Scalar z868 = z864 + z794 * z866 - z815 * z867;
    const Scalar z843 = z840 * z842;
    const Scalar z844 = z839 - z840 * z843;
    const Scalar z869 = z863 + z793 * z866 - z814 * z867 - z829 * z868;
    const Scalar z845 = n1 / z844;
    const Scalar z870 = z862 + z792 * z866 - z813 * z867 - z828 * z868 - z838 * z869;
    const Scalar z871 = z791 * z866 - z861 - z812 * z867 - z827 * z868 - z837 * z869 + z843 * z870;
    const Scalar z872 = z845 * z871;
    const Scalar z873 = z842 * z870 + z843 * z872;
    const Scalar z874 = z836 * z869 + z837 * z872 + z838 * z873;
    const Scalar z875 = z826 * z868 + z827 * z872 + z828 * z873 - z829 * z874;
    const Scalar z876 = z811 * z867 - z812 * z872 - z813 * z873 + z814 * z874 + z815 * z875;
    const Scalar z877 = z790 * z866 + z791 * z872 + z792 * z873 - z793 * z874 - z794 * z875 + z795 * z876;
    const Scalar z878 = z852 + z689 * z872 + z704 * z873 - z717 * z874 - z730 * z875 - z745 * z876 - z760 * z877;
    const Scalar z879 = z690 * z872 - z853 + z705 * z873 - z718 * z874 + z731 * z875 + z746 * z876 - z761 * z877;
    const Scalar z880 = z691 * z872 - z854 + z706 * z873 - z719 * z874 - z732 * z875 + z747 * z876 - z762 * z877;
    const Scalar z881 = z855 + z692 * z872 + z707 * z873 - z720 * z874 - z733 * z875 + z748 * z876 - z763 * z877;
    const Scalar z882 = z856 + z693 * z872 - z708 * z873 - z721 * z874 - z734 * z875 - z749 * z876 + z764 * z877;
    const Scalar z883 = z857 + z694 * z872 + z709 * z873 - z722 * z874 - z735 * z875 + z750 * z876 - z765 * z877;
    const Scalar z884 = z858 + z695 * z872 + z710 * z873 - z723 * z874 - z736 * z875 + z751 * z876 - z766 * z877;
    const Scalar z885 = z696 * z872 - z859 + z711 * z873 + z724 * z874 + z737 * z875 + z752 * z876 - z767 * z877;
    const Scalar z886 = z697 * z872 - z860 + z712 * z873 - z725 * z874 - z738 * z875 + z753 * z876 - z768 * z877;
    accelerations.x = -z878;
    accelerations.y = -z879;
    accelerations.z = -z880;
    accelerations.yaw = -z881;
    accelerations.roll = -z882;
    accelerations.pitch = -z883;
    accelerations.steer = z884;
    accelerations.rear = z885;
    accelerations.front = z886;
    multipliers.lambda_rear_touches = z872;
    multipliers.lambda_front_touches = z873;
    multipliers.lambda_rear_rolls_x = z874;
    multipliers.lambda_rear_rolls_y = z875;
    multipliers.lambda_front_rolls_x = z876;
    multipliers.lambda_front_rolls_y = -z877;
    if (!(traits::regular(z683, n94) && traits::regular(z680, n94) && traits::regular(z674, n94)
        && traits::regular(-z664, z564) && traits::regular(-z649, z542) && traits::regular(-z628, z518)
        && traits::regular(z587, z587) && traits::regular(-z844, -z769) && traits::regular(-z841, -z771)
        && traits::regular(z835, z774) && traits::regular(z825, z778) && traits::regular(-z810, -z783)
        && traits::regular(-z789, -z789))) return torsor::Status::singular;
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
    const Scalar z888 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z887 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z923 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z92 = n0_35 * z40 + n0_08 * z38;
    const Scalar z932 = n0_8 * z39 - n2_8 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z258 = c_roll * z256;
    const Scalar z352 = z39 * z334 + z40 * z329 + z38 * z328;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z889 = v_z * s_roll - c_roll * z888;
    const Scalar z890 = v_z * c_roll + s_roll * z888;
    const Scalar z893 = s_rear * z329 - c_rear * z328;
    const Scalar z894 = s_rear * z328 + c_rear * z329;
    const Scalar z925 = c_roll * z923;
    const Scalar z931 = n2_8 * z40 + n0_8 * z38;
    const Scalar z933 = n0_8 * z40 + n2_8 * z42;
    const Scalar z261 = q_z - z258;
    const Scalar z891 = s_pitch * z890 - c_pitch * z887;
    const Scalar z892 = s_pitch * z887 + c_pitch * z890;
    const Scalar z898 = n0_3 * z328 - z889 - n1_1 * z329;
    const Scalar z911 = n51 * z328 + n25_5 * z329 + n85 * z889;
    const Scalar z913 = n39_8 * z328 + n17_7 * z329 + n51 * z889;
    const Scalar z915 = n17_7 * z328 + n10_45 * z329 + n25_5 * z889;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z935 = s_pitch * z931 - c_pitch * z933;
    const Scalar z899 = n1_1 * z334 - z892;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z897 = n0_3 * z334 - z891;
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z900 = z38 * z897 - z39 * z898 - z40 * z899;
    const Scalar z902 = z41 * z898 - z42 * z899 + z40 * z897;
    const Scalar z901 = c_steer * z898 + z39 * z897 + z41 * z899;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z905 = n0_08 * z353 + z902;
    const Scalar z103 = q_z - z100;
    const Scalar z895 = s_rear * z892 + c_rear * z891;
    const Scalar z903 = n0_35 * z353 - z900;
    const Scalar z896 = s_rear * z891 - c_rear * z892;
    const Scalar z904 = n0_35 * z365 - z901 - n0_08 * z366;
    const Scalar z906 = s_front * z366 - c_front * z365;
    const Scalar z907 = s_front * z365 + c_front * z366;
    const Scalar z908 = s_front * z905 + c_front * z903;
    const Scalar z909 = s_front * z903 - c_front * z905;
    const Scalar z910 = n51 * z334 + n85 * z891;
    const Scalar z912 = n25_5 * z334 - n85 * z892;
    const Scalar z914 = n49_25 * z334 - n25_5 * z892 + n51 * z891;
    const Scalar z916 = n2_8 * z353 - n4 * z900;
    const Scalar z917 = n2_8 * z365 - n0_8 * z366 - n4 * z901;
    const Scalar z918 = n0_8 * z353 + n4 * z902;
    const Scalar z919 = k16 * z365 - k17 * z366 - n2_8 * z901;
    const Scalar z920 = n2_18 * z353 + n0_8 * z902 - n2_8 * z900;
    const Scalar z921 = k17 * z365 - k19 * z366 - n0_8 * z901;
    const Scalar z937 = s_roll * z932 - c_roll * z935;
    result.kinetic = z889 * z889 + n0_06 * z337 * z337 + k21 * (z893 * z893 + z894 * z894) + z895 * z895 + n0_14 * z385
        * z385 + z896 * z896 + k23 * (z907 * z907 + z906 * z906) + n1_5 * (z904 * z904 + z908 * z908 + z909 * z909)
        + n0_5 * (z328 * z913 + z329 * z915 + z889 * z911 - z892 * z912 + z891 * z910 + z334 * z914 + z365 * z919 - z366
        * z921 - z901 * z917 + z902 * z918 - z900 * z916 + z353 * z920);
    result.force_function = n853_47 * q_z + n39_24 * z261 - n9_81 * (z925 + z937) + n29_43 * z103;
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
    const Scalar z888 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z887 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z923 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z92 = n0_35 * z40 + n0_08 * z38;
    const Scalar z932 = n0_8 * z39 - n2_8 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z258 = c_roll * z256;
    const Scalar z352 = z39 * z334 + z40 * z329 + z38 * z328;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z889 = v_z * s_roll - c_roll * z888;
    const Scalar z890 = v_z * c_roll + s_roll * z888;
    const Scalar z893 = s_rear * z329 - c_rear * z328;
    const Scalar z894 = s_rear * z328 + c_rear * z329;
    const Scalar z925 = c_roll * z923;
    const Scalar z931 = n2_8 * z40 + n0_8 * z38;
    const Scalar z933 = n0_8 * z40 + n2_8 * z42;
    const Scalar z261 = q_z - z258;
    const Scalar z891 = s_pitch * z890 - c_pitch * z887;
    const Scalar z892 = s_pitch * z887 + c_pitch * z890;
    const Scalar z898 = n0_3 * z328 - z889 - n1_1 * z329;
    const Scalar z911 = n51 * z328 + n25_5 * z329 + n85 * z889;
    const Scalar z913 = n39_8 * z328 + n17_7 * z329 + n51 * z889;
    const Scalar z915 = n17_7 * z328 + n10_45 * z329 + n25_5 * z889;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z935 = s_pitch * z931 - c_pitch * z933;
    const Scalar z899 = n1_1 * z334 - z892;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z897 = n0_3 * z334 - z891;
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z900 = z38 * z897 - z39 * z898 - z40 * z899;
    const Scalar z902 = z41 * z898 - z42 * z899 + z40 * z897;
    const Scalar z901 = c_steer * z898 + z39 * z897 + z41 * z899;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z905 = n0_08 * z353 + z902;
    const Scalar z103 = q_z - z100;
    const Scalar z895 = s_rear * z892 + c_rear * z891;
    const Scalar z903 = n0_35 * z353 - z900;
    const Scalar z896 = s_rear * z891 - c_rear * z892;
    const Scalar z904 = n0_35 * z365 - z901 - n0_08 * z366;
    const Scalar z906 = s_front * z366 - c_front * z365;
    const Scalar z907 = s_front * z365 + c_front * z366;
    const Scalar z908 = s_front * z905 + c_front * z903;
    const Scalar z909 = s_front * z903 - c_front * z905;
    const Scalar z910 = n51 * z334 + n85 * z891;
    const Scalar z912 = n25_5 * z334 - n85 * z892;
    const Scalar z914 = n49_25 * z334 - n25_5 * z892 + n51 * z891;
    const Scalar z916 = n2_8 * z353 - n4 * z900;
    const Scalar z917 = n2_8 * z365 - n0_8 * z366 - n4 * z901;
    const Scalar z918 = n0_8 * z353 + n4 * z902;
    const Scalar z919 = k16 * z365 - k17 * z366 - n2_8 * z901;
    const Scalar z920 = n2_18 * z353 + n0_8 * z902 - n2_8 * z900;
    const Scalar z921 = k17 * z365 - k19 * z366 - n0_8 * z901;
    const Scalar z937 = s_roll * z932 - c_roll * z935;
    result.energy = -n853_47 * q_z + z889 * z889 + n0_06 * z337 * z337 - n39_24 * z261 + k23 * (z893 * z893 + z894
        * z894) + z895 * z895 + n0_14 * z385 * z385 + z896 * z896 + n9_81 * (z925 + z937) - n29_43 * z103 + k27 * (z907
        * z907 + z906 * z906) + n1_5 * (z904 * z904 + z908 * z908 + z909 * z909) + n0_5 * (z328 * z913 + z329 * z915
        + z889 * z911 - z892 * z912 + z891 * z910 + z334 * z914 + z365 * z919 - z366 * z921 - z901 * z917 + z902 * z918
        - z900 * z916 + z353 * z920);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
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
    const Scalar z39 = z32 * s_steer;
    const Scalar z41 = z31 * s_steer;
    const Scalar z62 = v_roll * s_roll;
    const Scalar z61 = v_yaw * c_yaw;
    const Scalar z60 = v_roll * c_roll;
    const Scalar z65 = v_yaw * s_yaw;
    const Scalar z48 = s_yaw * c_roll;
    const Scalar z52 = n1 - s_roll * s_roll;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z49 = c_yaw * c_roll;
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z72 = s_yaw * s_roll;
    const Scalar z74 = c_yaw * s_roll;
    const Scalar z76 = n2 * s_roll * c_roll;
    const Scalar z50 = s_roll * z48;
    const Scalar z51 = s_roll * z49;
    const Scalar z63 = s_yaw * z62 - c_roll * z61;
    const Scalar z66 = c_yaw * z62 + c_roll * z65;
    const Scalar z68 = n2 * s_roll * z60;
    const Scalar z73 = s_roll * z72 - c_roll * z48;
    const Scalar z75 = s_roll * z74 - c_roll * z49;
    const Scalar z80 = v_roll * z60;
    const Scalar z81 = v_yaw * z65;
    const Scalar z83 = v_roll * z62;
    const Scalar z85 = v_yaw * z61;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z106 = s_pitch * z41 - c_pitch * z39;
    const Scalar z107 = s_pitch * z39 + c_pitch * z41;
    const Scalar z53 = z52 * z52 + z50 * z50 + z51 * z51;
    const Scalar z82 = s_yaw * z80 + c_roll * z81 + n2 * z61 * z62;
    const Scalar z86 = c_yaw * z80 + c_roll * z85 - n2 * z62 * z65;
    const Scalar z88 = n2 * (s_roll * z83 - z60 * z60);
    const Scalar z92 = n0_35 * z40 + n0_08 * z38;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z64 = s_roll * z63 - z48 * z60;
    const Scalar z67 = s_roll * z66 - z49 * z60;
    const Scalar z77 = n2 * (z52 * z76 + z50 * z73 + z51 * z75);
    const Scalar z108 = s_roll * z107 - c_roll * c_steer;
    const Scalar z109 = s_roll * c_steer + c_roll * z107;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z54 = traits::sqrt(z53);
    const Scalar z114 = n1 - z109 * z109;
    const Scalar z97 = s_pitch * z96 + c_pitch * z95;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z69 = n2 * (z52 * z68 + z50 * z64 + z51 * z67);
    const Scalar z84 = z48 * z83 + n2 * z60 * z63 + s_roll * z82;
    const Scalar z87 = z49 * z83 + n2 * z60 * z66 + s_roll * z86;
    const Scalar z89 = n2 * (z50 * z84 + z51 * z87 - z52 * z88 - z64 * z64 - z67 * z67 - z68 * z68);
    const Scalar z110 = c_yaw * z106 + s_yaw * z108;
    const Scalar z112 = z109 * z110;
    const Scalar z111 = s_yaw * z106 - c_yaw * z108;
    const Scalar z78 = n0_5 * z77 / z54;
    const Scalar z59 = q_z + n0_3 * z54;
    const Scalar z113 = z109 * z111;
    const Scalar z99 = s_roll * z98 - c_roll * z93;
    const Scalar z101 = s_yaw * z99 - c_yaw * z97;
    const Scalar z70 = n0_5 * z69 / z54;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z103 = q_z - z100;
    const Scalar z102 = s_yaw * z97 + c_yaw * z99;
    const Scalar z104 = q_y + z102;
    const Scalar z55 = n0_3 / z54;
    const Scalar z105 = q_x - z101;
    const Scalar z115 = z114 * z114 + z112 * z112 + z113 * z113;
    const Scalar z90 = n0_5 * (z69 * z70 / (z54 * z54) + z89 / z54);
    const Scalar z79 = n0_3 * z78;
    const Scalar z71 = v_z - n0_3 * z70;
    const Scalar z56 = q_x + z50 * z55;
    const Scalar z116 = traits::sqrt(z115);
    const Scalar z57 = q_y - z51 * z55;
    const Scalar z58 = q_z + z52 * z55;
    const Scalar z126 = v_pitch * c_pitch;
    const Scalar z131 = v_pitch * s_pitch;
    const Scalar z122 = v_steer * c_steer;
    const Scalar z127 = v_steer * s_steer;
    const Scalar z123 = z32 * z122;
    const Scalar z124 = z31 * z122;
    const Scalar z129 = z31 * z32 * z127;
    const Scalar z128 = -z127 * (n1 - z31 * z31);
    const Scalar z130 = n0_35 * z129 + n0_08 * z128;
    const Scalar z137 = z39 * z126 - z41 * z131 + s_pitch * z123 + c_pitch * z124;
    const Scalar z121 = z103 + n0_35 * z116;
    const Scalar z140 = z39 * z131 + z41 * z126 + s_pitch * z124 - c_pitch * z123;
    const Scalar z91 = n0_3 * z90;
    const Scalar z139 = c_roll * z127 + c_steer * z62 + z60 * z107 + s_roll * z137;
    const Scalar z138 = s_roll * z127 - c_steer * z60 + z62 * z107 - c_roll * z137;
    const Scalar z143 = z61 * z106 + z65 * z108 + s_yaw * z140 - c_yaw * z139;
    const Scalar z141 = z61 * z108 - z65 * z106 + c_yaw * z140 + s_yaw * z139;
    const Scalar z145 = n2 * z109 * z138;
    const Scalar z144 = z109 * z143 - z111 * z138;
    const Scalar z132 = -z127 * (n1 - z32 * z32);
    const Scalar z133 = n0_08 * z129 + n0_35 * z132;
    const Scalar z142 = z109 * z141 - z110 * z138;
    const Scalar z125 = n0_08 * z123 - n0_35 * z124;
    const Scalar z146 = n2 * (z114 * z145 + z113 * z144 + z112 * z142);
    const Scalar z134 = s_pitch * z130 - c_pitch * z133 - z95 * z126 - z96 * z131;
    const Scalar z168 = z32 * c_steer;
    const Scalar z169 = z31 * c_steer;
    const Scalar z159 = s_roll * z106;
    const Scalar z147 = n0_5 * z146 / z116;
    const Scalar z151 = c_yaw * z109;
    const Scalar z152 = z109 * z151 + z108 * z111;
    const Scalar z160 = s_yaw * z159 - c_yaw * z107;
    const Scalar z162 = s_yaw * z107 + c_yaw * z159;
    const Scalar z117 = n0_35 / z116;
    const Scalar z158 = c_roll * z106;
    const Scalar z161 = z109 * z160 + z110 * z158;
    const Scalar z163 = z109 * z162 - z111 * z158;
    const Scalar z164 = n2 * z109 * z158;
    const Scalar z118 = z105 - z112 * z117;
    const Scalar z178 = s_pitch * z168 + c_pitch * z169;
    const Scalar z135 = z60 * z93 + s_roll * z125 - z62 * z98 - c_roll * z134;
    const Scalar z165 = n2 * (z112 * z161 - z113 * z163 - z114 * z164);
    const Scalar z136 = v_z - z135;
    const Scalar z148 = z136 + n0_35 * z147;
    const Scalar z120 = z103 + z114 * z117;
    const Scalar z149 = s_yaw * z109;
    const Scalar z150 = z108 * z110 - z109 * z149;
    const Scalar z153 = n2 * z108 * z109;
    const Scalar z119 = z104 - z113 * z117;
    const Scalar z194 = v_steer * z122;
    const Scalar z154 = n2 * (z113 * z152 - z114 * z153 + z112 * z150);
    const Scalar z166 = n0_5 * z165 / z116;
    const Scalar z200 = v_pitch * z131;
    const Scalar z201 = v_pitch * z126;
    const Scalar z190 = v_steer * z127;
    const Scalar z191 = z32 * z190;
    const Scalar z192 = z31 * z190;
    const Scalar z181 = s_pitch * z169 - c_pitch * z168;
    const Scalar z170 = n0_08 * z168 - n0_35 * z169;
    const Scalar z155 = n0_5 * z154 / z116;
    const Scalar z204 = z39 * z200 + z41 * z201 + s_pitch * z191 + c_pitch * z192 - n2 * (z123 * z126 - z124 * z131);
    const Scalar z206 = z41 * z200 - z39 * z201 + s_pitch * z192 - c_pitch * z191 - n2 * (z123 * z131 + z124 * z126);
    const Scalar z193 = n0_08 * z191 - n0_35 * z192;
    const Scalar z205 = z83 * z107 - c_roll * z194 - c_steer * z80 - n2 * (z60 * z137 - z62 * z127) + s_roll * z204;
    const Scalar z208 = s_roll * z194 + c_steer * z83 + z80 * z107 + n2 * (z60 * z127 + z62 * z137) + c_roll * z204;
    const Scalar z156 = z99 - n0_35 * z155;
    const Scalar z216 = q_x - z56;
    const Scalar z210 = z81 * z106 - z85 * z108 - n2 * (z61 * z140 + z65 * z139) + s_yaw * z206 - c_yaw * z205;
    const Scalar z207 = z85 * z106 + z81 * z108 - n2 * (z61 * z139 - z65 * z140) + c_yaw * z206 + s_yaw * z205;
    const Scalar z211 = n2 * z138 * z143 + z111 * z208 + z109 * z210;
    const Scalar z209 = n2 * z138 * z141 + z110 * z208 + z109 * z207;
    const Scalar z212 = n2 * (z109 * z208 - z138 * z138);
    const Scalar z213 = n2 * (z113 * z211 - z145 * z145 - z144 * z144 - z142 * z142 - z114 * z212 + z112 * z209);
    const Scalar z180 = c_roll * s_steer + s_roll * z178;
    const Scalar z179 = s_roll * s_steer - c_roll * z178;
    const Scalar z182 = c_yaw * z181 + s_yaw * z180;
    const Scalar z184 = s_yaw * z181 - c_yaw * z180;
    const Scalar z183 = z109 * z182 - z110 * z179;
    const Scalar z185 = z109 * z184 - z111 * z179;
    const Scalar z186 = n2 * z109 * z179;
    const Scalar z196 = z31 * z32 * z194;
    const Scalar z195 = -z194 * (n1 - z31 * z31);
    const Scalar z197 = n0_35 * z196 + n0_08 * z195;
    const Scalar z187 = n2 * (z114 * z186 + z112 * z183 + z113 * z185);
    const Scalar z214 = n0_5 * (z146 * z147 / (z116 * z116) + z213 / z116);
    const Scalar z198 = -z194 * (n1 - z32 * z32);
    const Scalar z199 = n0_08 * z196 + n0_35 * z198;
    const Scalar z172 = z31 * z32 * s_steer;
    const Scalar z188 = n0_5 * z187 / z116;
    const Scalar z171 = -s_steer * (n1 - z31 * z31);
    const Scalar z202 = z95 * z200 - z96 * z201 + s_pitch * z197 - c_pitch * z199 + n2 * (z126 * z130 + z131 * z133);
    const Scalar z173 = n0_35 * z172 + n0_08 * z171;
    const Scalar z203 = z83 * z93 + s_roll * z193 + z80 * z98 - n2 * (z60 * z125 + z62 * z134) + c_roll * z202;
    const Scalar z215 = z203 - n0_35 * z214;
    const Scalar z174 = -s_steer * (n1 - z32 * z32);
    const Scalar z175 = n0_08 * z172 + n0_35 * z174;
    const Scalar z157 = c_roll * z97;
    const Scalar z167 = z157 + n0_35 * z166;
    const Scalar z226 = n0_3 * z70 / (z54 * z54);
    const Scalar z229 = v_z - z55 * z68 + z52 * z226;
    const Scalar z227 = v_y + z55 * z67 - z51 * z226;
    const Scalar z235 = v_x - z55 * z64 + z50 * z226;
    const Scalar z176 = s_pitch * z173 - c_pitch * z175;
    const Scalar z177 = s_roll * z170 - c_roll * z176;
    const Scalar z217 = q_y - z57;
    const Scalar z218 = q_z - z58;
    const Scalar z230 = v_z - z229;
    const Scalar z228 = v_y - z227;
    const Scalar z236 = v_x - z235;
    const Scalar z189 = z177 - n0_35 * z188;
    const Scalar z278 = c_roll * z125 - z62 * z93 - z60 * z98 + s_roll * z134;
    const Scalar z277 = s_pitch * z133 + c_pitch * z130 + z95 * z131 - z96 * z126;
    const Scalar z281 = n0_35 * z147 / (z116 * z116);
    const Scalar z284 = z114 * z281 - z136 - z117 * z145;
    const Scalar z270 = z105 - z118;
    const Scalar z271 = z104 - z119;
    const Scalar z272 = z103 - z120;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z255 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z257 = s_roll * z256;
    const Scalar z249 = s_pitch * z32 + c_pitch * z31;
    const Scalar z250 = s_pitch * z31 - c_pitch * z32;
    const Scalar z279 = s_yaw * z277 - z61 * z97 + z65 * z99 + c_yaw * z278;
    const Scalar z280 = v_y - z279;
    const Scalar z259 = s_yaw * z257 - c_yaw * z255;
    const Scalar z263 = q_x - z259;
    const Scalar z251 = s_roll * z250;
    const Scalar z282 = z280 - z117 * z144 + z113 * z281;
    const Scalar z264 = z118 - z263;
    const Scalar z240 = q_x - z118;
    const Scalar z258 = c_roll * z256;
    const Scalar z261 = q_z - z258;
    const Scalar z260 = s_yaw * z255 + c_yaw * z257;
    const Scalar z262 = q_y + z260;
    const Scalar z242 = q_z - z120;
    const Scalar z266 = z120 - z261;
    const Scalar z241 = q_y - z119;
    const Scalar z252 = c_roll * z250;
    const Scalar z283 = v_y - z282;
    const Scalar z265 = z119 - z262;
    const Scalar z243 = s_yaw * z242;
    const Scalar z244 = c_yaw * z242;
    const Scalar z253 = s_yaw * z251 - c_yaw * z249;
    const Scalar z246 = s_roll * z241 - z49 * z242;
    const Scalar z247 = s_roll * z240 + z48 * z242;
    const Scalar z254 = s_yaw * z249 + c_yaw * z251;
    const Scalar z219 = s_yaw * z218;
    const Scalar z285 = v_z + z284;
    const Scalar z220 = c_yaw * z218;
    const Scalar z286 = z61 * z242 + s_yaw * z285;
    const Scalar z231 = z61 * z218 + s_yaw * z230;
    const Scalar z237 = c_yaw * z230 - z65 * z218;
    const Scalar z267 = z252 * z265 + z254 * z266;
    const Scalar z268 = z252 * z264 - z253 * z266;
    const Scalar z222 = s_roll * z217 - z49 * z218;
    const Scalar z225 = v_x + v_yaw * z217 - v_roll * z219 + z222 * (v_pitch + v_rear);
    const Scalar z232 = z60 * z217 + z66 * z218 + s_roll * z228 - z49 * z230;
    const Scalar z233 = v_yaw * z228 - v_roll * z231 + z232 * (v_pitch + v_rear);
    const Scalar z287 = z60 * z241 + z66 * z242 + s_roll * z283 - z49 * z285;
    const Scalar z238 = z60 * z216 - z63 * z218 + s_roll * z236 + z48 * z230;
    const Scalar z239 = v_yaw * z236 - v_roll * z237 + z238 * (v_pitch + v_rear);
    const Scalar z223 = s_roll * z216 + z48 * z218;
    const Scalar z234 = v_y - v_yaw * z216 + v_roll * z220 - z223 * (v_pitch + v_rear);
    const Scalar z308 = s_yaw * z278 - c_yaw * z277 - z61 * z99 - z65 * z97;
    const Scalar z309 = v_x + z308;
    const Scalar z303 = z280 - z282;
    const Scalar z304 = z136 + z284;
    const Scalar z305 = z109 * z303 - z138 * z271 - z143 * z272 - z111 * z304;
    const Scalar z310 = z309 - z117 * z142 + z112 * z281;
    const Scalar z273 = z109 * z271 - z111 * z272;
    const Scalar z276 = v_x + v_yaw * z241 - v_roll * z243 + v_pitch * z246 + v_steer * z267 + v_front * z273;
    const Scalar z319 = z309 - z310;
    const Scalar z320 = z109 * z319 - z138 * z270 - z141 * z272 - z110 * z304;
    const Scalar z274 = z109 * z270 - z110 * z272;
    const Scalar z307 = v_y - v_yaw * z240 + v_roll * z244 - v_pitch * z247 - v_steer * z268 - v_front * z274;
    const Scalar z290 = n0_3 * z126 - n1_1 * z131;
    const Scalar z296 = z31 * z131 - z32 * z126;
    const Scalar z288 = z31 * z126 + z32 * z131;
    const Scalar z291 = n1_1 * z126 + n0_3 * z131;
    const Scalar z292 = z60 * z256 + s_roll * z291;
    const Scalar z299 = c_roll * z291 - z62 * z256;
    const Scalar z289 = c_roll * z288 - z62 * z250;
    const Scalar z297 = z60 * z250 + s_roll * z288;
    const Scalar z314 = z65 * z255 - c_yaw * z290 + z61 * z257 + s_yaw * z292;
    const Scalar z293 = z61 * z255 + s_yaw * z290 - z65 * z257 + c_yaw * z292;
    const Scalar z315 = v_x - z314;
    const Scalar z316 = z310 - z315;
    const Scalar z311 = v_x - z310;
    const Scalar z313 = z60 * z240 - z63 * z242 + s_roll * z311 + z48 * z285;
    const Scalar z312 = c_yaw * z285 - z65 * z242;
    const Scalar z294 = v_y + z293;
    const Scalar z295 = z282 - z294;
    const Scalar z300 = v_z - z299;
    const Scalar z301 = z284 + z300;
    const Scalar z317 = z65 * z249 + c_yaw * z296 + z61 * z251 + s_yaw * z297;
    const Scalar z298 = s_yaw * z296 - z61 * z249 + z65 * z251 - c_yaw * z297;
    const Scalar z318 = z264 * z289 - z266 * z317 + z252 * z316 + z253 * z301;
    const Scalar z302 = z265 * z289 - z266 * z298 + z252 * z295 - z254 * z301;
    const Scalar z321 = v_yaw * z311 + v_pitch * z313 + v_steer * z318 - v_roll * z312 + v_front * z320;
    const Scalar z306 = v_yaw * z283 - v_roll * z286 + v_pitch * z287 + v_steer * z302 + v_front * z305;
    result.value[0] = -z59;
    result.rate[0] = -z71;
    result.gamma[0] = z91;
    result.value[1] = -z121;
    result.rate[1] = -z148;
    result.gamma[1] = -z215;
    result.value[2] = n0;
    result.rate[2] = z225;
    result.gamma[2] = z233;
    result.value[3] = n0;
    result.rate[3] = -z234;
    result.gamma[3] = z239;
    result.value[4] = n0;
    result.rate[4] = z276;
    result.gamma[4] = z306;
    result.value[5] = n0;
    result.rate[5] = -z307;
    result.gamma[5] = z321;
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
    result.jacobian[20] = z217;
    result.jacobian[21] = z216;
    result.jacobian[22] = z241;
    result.jacobian[23] = z240;
    result.jacobian[24] = z79;
    result.jacobian[25] = -z156;
    result.jacobian[26] = -z219;
    result.jacobian[27] = -z220;
    result.jacobian[28] = -z243;
    result.jacobian[29] = -z244;
    result.jacobian[30] = n0;
    result.jacobian[31] = z167;
    result.jacobian[32] = z222;
    result.jacobian[33] = z223;
    result.jacobian[34] = z246;
    result.jacobian[35] = z247;
    result.jacobian[36] = n0;
    result.jacobian[37] = z189;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z267;
    result.jacobian[41] = z268;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z222;
    result.jacobian[45] = z223;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z273;
    result.jacobian[53] = z274;
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
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
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
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k31 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k33 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k34 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar n78_6 = traits::constant(78.6, 78.6f, "393/5");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar n79_7206 = traits::constant(79.7206, 79.7206f, "398603/5000");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k40 = traits::constant(2.38342, 2.38342f, "119171/50000");
    const Scalar k41 = traits::constant(0.18328, 0.18328f, "2291/12500");
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
    const Scalar z39 = z32 * s_steer;
    const Scalar z41 = z31 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z62 = v_roll * s_roll;
    const Scalar z60 = v_roll * c_roll;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z65 = v_yaw * s_yaw;
    const Scalar z61 = v_yaw * c_yaw;
    const Scalar z48 = s_yaw * c_roll;
    const Scalar z52 = n1 - s_roll * s_roll;
    const Scalar z49 = c_yaw * c_roll;
    const Scalar z72 = s_yaw * s_roll;
    const Scalar z74 = c_yaw * s_roll;
    const Scalar z76 = n2 * s_roll * c_roll;
    const Scalar z50 = s_roll * z48;
    const Scalar z51 = s_roll * z49;
    const Scalar z63 = s_yaw * z62 - c_roll * z61;
    const Scalar z66 = c_yaw * z62 + c_roll * z65;
    const Scalar z68 = n2 * s_roll * z60;
    const Scalar z73 = s_roll * z72 - c_roll * z48;
    const Scalar z75 = s_roll * z74 - c_roll * z49;
    const Scalar z80 = v_roll * z60;
    const Scalar z81 = v_yaw * z65;
    const Scalar z83 = v_roll * z62;
    const Scalar z85 = v_yaw * z61;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z106 = s_pitch * z41 - c_pitch * z39;
    const Scalar z107 = s_pitch * z39 + c_pitch * z41;
    const Scalar z53 = z52 * z52 + z50 * z50 + z51 * z51;
    const Scalar z82 = s_yaw * z80 + c_roll * z81 + n2 * z61 * z62;
    const Scalar z86 = c_yaw * z80 + c_roll * z85 - n2 * z62 * z65;
    const Scalar z88 = n2 * (s_roll * z83 - z60 * z60);
    const Scalar z92 = n0_35 * z40 + n0_08 * z38;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z64 = s_roll * z63 - z48 * z60;
    const Scalar z67 = s_roll * z66 - z49 * z60;
    const Scalar z77 = n2 * (z52 * z76 + z50 * z73 + z51 * z75);
    const Scalar z108 = s_roll * z107 - c_roll * c_steer;
    const Scalar z109 = s_roll * c_steer + c_roll * z107;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z114 = n1 - z109 * z109;
    const Scalar z54 = traits::sqrt(z53);
    const Scalar z97 = s_pitch * z96 + c_pitch * z95;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z69 = n2 * (z52 * z68 + z50 * z64 + z51 * z67);
    const Scalar z110 = c_yaw * z106 + s_yaw * z108;
    const Scalar z111 = s_yaw * z106 - c_yaw * z108;
    const Scalar z112 = z109 * z110;
    const Scalar z113 = z109 * z111;
    const Scalar z84 = z48 * z83 + n2 * z60 * z63 + s_roll * z82;
    const Scalar z115 = z114 * z114 + z112 * z112 + z113 * z113;
    const Scalar z99 = s_roll * z98 - c_roll * z93;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z102 = s_yaw * z97 + c_yaw * z99;
    const Scalar z116 = traits::sqrt(z115);
    const Scalar z103 = q_z - z100;
    const Scalar z101 = s_yaw * z99 - c_yaw * z97;
    const Scalar z104 = q_y + z102;
    const Scalar z78 = n0_5 * z77 / z54;
    const Scalar z55 = n0_3 / z54;
    const Scalar z105 = q_x - z101;
    const Scalar z87 = z49 * z83 + n2 * z60 * z66 + s_roll * z86;
    const Scalar z70 = n0_5 * z69 / z54;
    const Scalar z89 = n2 * (z50 * z84 + z51 * z87 - z52 * z88 - z64 * z64 - z67 * z67 - z68 * z68);
    const Scalar z56 = q_x + z50 * z55;
    const Scalar z58 = q_z + z52 * z55;
    const Scalar z79 = n0_3 * z78;
    const Scalar z117 = n0_35 / z116;
    const Scalar z57 = q_y - z51 * z55;
    const Scalar z127 = v_steer * s_steer;
    const Scalar z131 = v_pitch * s_pitch;
    const Scalar z126 = v_pitch * c_pitch;
    const Scalar z122 = v_steer * c_steer;
    const Scalar z123 = z32 * z122;
    const Scalar z124 = z31 * z122;
    const Scalar z151 = c_yaw * z109;
    const Scalar z149 = s_yaw * z109;
    const Scalar z150 = z108 * z110 - z109 * z149;
    const Scalar z137 = z39 * z126 - z41 * z131 + s_pitch * z123 + c_pitch * z124;
    const Scalar z140 = z39 * z131 + z41 * z126 + s_pitch * z124 - c_pitch * z123;
    const Scalar z119 = z104 - z113 * z117;
    const Scalar z120 = z103 + z114 * z117;
    const Scalar z129 = z31 * z32 * z127;
    const Scalar z132 = -z127 * (n1 - z32 * z32);
    const Scalar z133 = n0_08 * z129 + n0_35 * z132;
    const Scalar z138 = s_roll * z127 - c_steer * z60 + z62 * z107 - c_roll * z137;
    const Scalar z139 = c_roll * z127 + c_steer * z62 + z60 * z107 + s_roll * z137;
    const Scalar z141 = z61 * z108 - z65 * z106 + c_yaw * z140 + s_yaw * z139;
    const Scalar z143 = z61 * z106 + z65 * z108 + s_yaw * z140 - c_yaw * z139;
    const Scalar z142 = z109 * z141 - z110 * z138;
    const Scalar z145 = n2 * z109 * z138;
    const Scalar z144 = z109 * z143 - z111 * z138;
    const Scalar z128 = -z127 * (n1 - z31 * z31);
    const Scalar z130 = n0_35 * z129 + n0_08 * z128;
    const Scalar z118 = z105 - z112 * z117;
    const Scalar z146 = n2 * (z114 * z145 + z113 * z144 + z112 * z142);
    const Scalar z125 = n0_08 * z123 - n0_35 * z124;
    const Scalar z134 = s_pitch * z130 - c_pitch * z133 - z95 * z126 - z96 * z131;
    const Scalar z90 = n0_5 * (z69 * z70 / (z54 * z54) + z89 / z54);
    const Scalar z91 = n0_3 * z90;
    const Scalar z169 = z31 * c_steer;
    const Scalar z168 = z32 * c_steer;
    const Scalar z178 = s_pitch * z168 + c_pitch * z169;
    const Scalar z181 = s_pitch * z169 - c_pitch * z168;
    const Scalar z159 = s_roll * z106;
    const Scalar z160 = s_yaw * z159 - c_yaw * z107;
    const Scalar z158 = c_roll * z106;
    const Scalar z162 = s_yaw * z107 + c_yaw * z159;
    const Scalar z180 = c_roll * s_steer + s_roll * z178;
    const Scalar z179 = s_roll * s_steer - c_roll * z178;
    const Scalar z152 = z109 * z151 + z108 * z111;
    const Scalar z182 = c_yaw * z181 + s_yaw * z180;
    const Scalar z184 = s_yaw * z181 - c_yaw * z180;
    const Scalar z186 = n2 * z109 * z179;
    const Scalar z153 = n2 * z108 * z109;
    const Scalar z161 = z109 * z160 + z110 * z158;
    const Scalar z183 = z109 * z182 - z110 * z179;
    const Scalar z163 = z109 * z162 - z111 * z158;
    const Scalar z185 = z109 * z184 - z111 * z179;
    const Scalar z164 = n2 * z109 * z158;
    const Scalar z190 = v_steer * z127;
    const Scalar z194 = v_steer * z122;
    const Scalar z154 = n2 * (z113 * z152 - z114 * z153 + z112 * z150);
    const Scalar z187 = n2 * (z114 * z186 + z112 * z183 + z113 * z185);
    const Scalar z191 = z32 * z190;
    const Scalar z192 = z31 * z190;
    const Scalar z165 = n2 * (z112 * z161 - z113 * z163 - z114 * z164);
    const Scalar z172 = z31 * z32 * s_steer;
    const Scalar z171 = -s_steer * (n1 - z31 * z31);
    const Scalar z173 = n0_35 * z172 + n0_08 * z171;
    const Scalar z174 = -s_steer * (n1 - z32 * z32);
    const Scalar z175 = n0_08 * z172 + n0_35 * z174;
    const Scalar z170 = n0_08 * z168 - n0_35 * z169;
    const Scalar z155 = n0_5 * z154 / z116;
    const Scalar z188 = n0_5 * z187 / z116;
    const Scalar z176 = s_pitch * z173 - c_pitch * z175;
    const Scalar z166 = n0_5 * z165 / z116;
    const Scalar z157 = c_roll * z97;
    const Scalar z147 = n0_5 * z146 / z116;
    const Scalar z156 = z99 - n0_35 * z155;
    const Scalar z177 = s_roll * z170 - c_roll * z176;
    const Scalar z167 = z157 + n0_35 * z166;
    const Scalar z135 = z60 * z93 + s_roll * z125 - z62 * z98 - c_roll * z134;
    const Scalar z189 = z177 - n0_35 * z188;
    const Scalar z136 = v_z - z135;
    const Scalar z216 = q_x - z56;
    const Scalar z218 = q_z - z58;
    const Scalar z217 = q_y - z57;
    const Scalar z200 = v_pitch * z131;
    const Scalar z201 = v_pitch * z126;
    const Scalar z204 = z39 * z200 + z41 * z201 + s_pitch * z191 + c_pitch * z192 - n2 * (z123 * z126 - z124 * z131);
    const Scalar z206 = z41 * z200 - z39 * z201 + s_pitch * z192 - c_pitch * z191 - n2 * (z123 * z131 + z124 * z126);
    const Scalar z193 = n0_08 * z191 - n0_35 * z192;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z255 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z257 = s_roll * z256;
    const Scalar z240 = q_x - z118;
    const Scalar z241 = q_y - z119;
    const Scalar z249 = s_pitch * z32 + c_pitch * z31;
    const Scalar z205 = z83 * z107 - c_roll * z194 - c_steer * z80 - n2 * (z60 * z137 - z62 * z127) + s_roll * z204;
    const Scalar z208 = s_roll * z194 + c_steer * z83 + z80 * z107 + n2 * (z60 * z127 + z62 * z137) + c_roll * z204;
    const Scalar z210 = z81 * z106 - z85 * z108 - n2 * (z61 * z140 + z65 * z139) + s_yaw * z206 - c_yaw * z205;
    const Scalar z211 = n2 * z138 * z143 + z111 * z208 + z109 * z210;
    const Scalar z212 = n2 * (z109 * z208 - z138 * z138);
    const Scalar z250 = s_pitch * z31 - c_pitch * z32;
    const Scalar z258 = c_roll * z256;
    const Scalar z260 = s_yaw * z255 + c_yaw * z257;
    const Scalar z259 = s_yaw * z257 - c_yaw * z255;
    const Scalar z242 = q_z - z120;
    const Scalar z207 = z85 * z106 + z81 * z108 - n2 * (z61 * z139 - z65 * z140) + c_yaw * z206 + s_yaw * z205;
    const Scalar z251 = s_roll * z250;
    const Scalar z252 = c_roll * z250;
    const Scalar z209 = n2 * z138 * z141 + z110 * z208 + z109 * z207;
    const Scalar z254 = s_yaw * z249 + c_yaw * z251;
    const Scalar z244 = c_yaw * z242;
    const Scalar z253 = s_yaw * z251 - c_yaw * z249;
    const Scalar z243 = s_yaw * z242;
    const Scalar z213 = n2 * (z113 * z211 - z145 * z145 - z144 * z144 - z142 * z142 - z114 * z212 + z112 * z209);
    const Scalar z223 = s_roll * z216 + z48 * z218;
    const Scalar z219 = s_yaw * z218;
    const Scalar z247 = s_roll * z240 + z48 * z242;
    const Scalar z226 = n0_3 * z70 / (z54 * z54);
    const Scalar z196 = z31 * z32 * z194;
    const Scalar z246 = s_roll * z241 - z49 * z242;
    const Scalar z195 = -z194 * (n1 - z31 * z31);
    const Scalar z197 = n0_35 * z196 + n0_08 * z195;
    const Scalar z261 = q_z - z258;
    const Scalar z262 = q_y + z260;
    const Scalar z263 = q_x - z259;
    const Scalar z198 = -z194 * (n1 - z32 * z32);
    const Scalar z199 = n0_08 * z196 + n0_35 * z198;
    const Scalar z265 = z119 - z262;
    const Scalar z266 = z120 - z261;
    const Scalar z264 = z118 - z263;
    const Scalar z235 = v_x - z55 * z64 + z50 * z226;
    const Scalar z236 = v_x - z235;
    const Scalar z220 = c_yaw * z218;
    const Scalar z222 = s_roll * z217 - z49 * z218;
    const Scalar z267 = z252 * z265 + z254 * z266;
    const Scalar z229 = v_z - z55 * z68 + z52 * z226;
    const Scalar z230 = v_z - z229;
    const Scalar z227 = v_y + z55 * z67 - z51 * z226;
    const Scalar z228 = v_y - z227;
    const Scalar z202 = z95 * z200 - z96 * z201 + s_pitch * z197 - c_pitch * z199 + n2 * (z126 * z130 + z131 * z133);
    const Scalar z268 = z252 * z264 - z253 * z266;
    const Scalar z237 = c_yaw * z230 - z65 * z218;
    const Scalar z238 = z60 * z216 - z63 * z218 + s_roll * z236 + z48 * z230;
    const Scalar z231 = z61 * z218 + s_yaw * z230;
    const Scalar z203 = z83 * z93 + s_roll * z193 + z80 * z98 - n2 * (z60 * z125 + z62 * z134) + c_roll * z202;
    const Scalar z271 = z104 - z119;
    const Scalar z272 = z103 - z120;
    const Scalar z270 = z105 - z118;
    const Scalar z273 = z109 * z271 - z111 * z272;
    const Scalar z274 = z109 * z270 - z110 * z272;
    const Scalar z277 = s_pitch * z133 + c_pitch * z130 + z95 * z131 - z96 * z126;
    const Scalar z278 = c_roll * z125 - z62 * z93 - z60 * z98 + s_roll * z134;
    const Scalar z279 = s_yaw * z277 - z61 * z97 + z65 * z99 + c_yaw * z278;
    const Scalar z281 = n0_35 * z147 / (z116 * z116);
    const Scalar z214 = n0_5 * (z146 * z147 / (z116 * z116) + z213 / z116);
    const Scalar z215 = z203 - n0_35 * z214;
    const Scalar z290 = n0_3 * z126 - n1_1 * z131;
    const Scalar z288 = z31 * z126 + z32 * z131;
    const Scalar z291 = n1_1 * z126 + n0_3 * z131;
    const Scalar z296 = z31 * z131 - z32 * z126;
    const Scalar z280 = v_y - z279;
    const Scalar z292 = z60 * z256 + s_roll * z291;
    const Scalar z289 = c_roll * z288 - z62 * z250;
    const Scalar z293 = z61 * z255 + s_yaw * z290 - z65 * z257 + c_yaw * z292;
    const Scalar z282 = z280 - z117 * z144 + z113 * z281;
    const Scalar z294 = v_y + z293;
    const Scalar z297 = z60 * z250 + s_roll * z288;
    const Scalar z295 = z282 - z294;
    const Scalar z283 = v_y - z282;
    const Scalar z284 = z114 * z281 - z136 - z117 * z145;
    const Scalar z285 = v_z + z284;
    const Scalar z232 = z60 * z217 + z66 * z218 + s_roll * z228 - z49 * z230;
    const Scalar z298 = s_yaw * z296 - z61 * z249 + z65 * z251 - c_yaw * z297;
    const Scalar z286 = z61 * z242 + s_yaw * z285;
    const Scalar z287 = z60 * z241 + z66 * z242 + s_roll * z283 - z49 * z285;
    const Scalar z239 = v_yaw * z236 - v_roll * z237 + z238 * (v_pitch + v_rear);
    const Scalar z233 = v_yaw * z228 - v_roll * z231 + z232 * (v_pitch + v_rear);
    const Scalar z303 = z280 - z282;
    const Scalar z304 = z136 + z284;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z340 = z334 * z334;
    const Scalar z352 = z39 * z334 + z40 * z329 + z38 * z328;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z345 = z328 * z334;
    const Scalar z350 = z328 * z328;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z341 = z329 * z329;
    const Scalar z347 = z329 * z334;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z351 = z340 + z350;
    const Scalar z342 = z340 + z341;
    const Scalar z364 = z31 * z354 - z32 * z352;
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z343 = z328 * z329;
    const Scalar z371 = z366 * z366;
    const Scalar z373 = z365 * z366;
    const Scalar z380 = z365 * z365;
    const Scalar z308 = s_yaw * z278 - c_yaw * z277 - z61 * z99 - z65 * z97;
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z393 = z371 - z380;
    const Scalar z370 = z353 * z353;
    const Scalar z372 = z370 + z371;
    const Scalar z381 = z370 + z380;
    const Scalar z309 = v_x + z308;
    const Scalar z375 = z353 * z365;
    const Scalar z377 = z353 * z366;
    const Scalar z314 = z65 * z255 - c_yaw * z290 + z61 * z257 + s_yaw * z292;
    const Scalar z310 = z309 - z117 * z142 + z112 * z281;
    const Scalar z315 = v_x - z314;
    const Scalar z299 = c_roll * z291 - z62 * z256;
    const Scalar z316 = z310 - z315;
    const Scalar z319 = z309 - z310;
    const Scalar z311 = v_x - z310;
    const Scalar z300 = v_z - z299;
    const Scalar z317 = z65 * z249 + c_yaw * z296 + z61 * z251 + s_yaw * z297;
    const Scalar z301 = z284 + z300;
    const Scalar z411 = z341 - z350;
    const Scalar z388 = z366 * z385;
    const Scalar z390 = n0_28 * z388;  // moment on front_wheel, x
    const Scalar z302 = z265 * z289 - z266 * z298 + z252 * z295 - z254 * z301;
    const Scalar z440 = n0_28 * z39;
    const Scalar z441 = n0_28 * c_steer;
    const Scalar z389 = z365 * z385;
    const Scalar z392 = n0_28 * z389;  // moment on front_wheel, z
    const Scalar z407 = z328 * z337;
    const Scalar z410 = n0_12 * z407;  // moment on rear_wheel, z
    const Scalar z326 = v_roll * z323;  // angular acceleration of frame.2, y
    const Scalar z327 = v_roll * z322;  // angular acceleration of frame.2, z
    const Scalar z406 = z329 * z337;
    const Scalar z408 = n0_12 * z406;  // moment on rear_wheel, x
    const Scalar z318 = z264 * z289 - z266 * z317 + z252 * z316 + z253 * z301;
    const Scalar z305 = z109 * z303 - z138 * z271 - z143 * z272 - z111 * z304;
    const Scalar z442 = n0_28 * z41;
    const Scalar z312 = c_yaw * z285 - z65 * z242;
    const Scalar z313 = z60 * z240 - z63 * z242 + s_roll * z311 + z48 * z285;
    const Scalar z320 = z109 * z319 - z138 * z270 - z141 * z272 - z110 * z304;
    const Scalar z422 = z322 * z323;
    const Scalar z306 = v_yaw * z283 - v_roll * z286 + v_pitch * z287 + v_steer * z302 + v_front * z305;
    const Scalar z452 = z39 * z449;
    const Scalar z454 = z41 * z449;
    const Scalar z456 = z39 * z450 + z41 * z451;
    const Scalar z459 = n0_3 * z452 - z456 + n1_1 * z454;
    const Scalar z453 = c_steer * z449;
    const Scalar z457 = z40 * z450 - z42 * z451;
    const Scalar z460 = n1_1 * z453 + z457;
    const Scalar z462 = s_pitch * z452 + c_pitch * z454;
    const Scalar z455 = z38 * z450 - z40 * z451;
    const Scalar z458 = n0_3 * z453 - z455;
    const Scalar z461 = s_pitch * z454 - c_pitch * z452;
    const Scalar z444 = s_pitch * z440 + c_pitch * z442;
    const Scalar z446 = s_roll * z441 + c_roll * z444;
    const Scalar z443 = s_pitch * z442 - c_pitch * z440;
    const Scalar z321 = v_yaw * z311 + v_pitch * z313 + v_steer * z318 - v_roll * z312 + v_front * z320;
    const Scalar z487 = n2_8467 * z41;
    const Scalar z481 = n2_8467 * z39;
    const Scalar z486 = k3 * z40 - k4 * z42;
    const Scalar z477 = n3_85 * z40 + n1_04 * z38;
    const Scalar z480 = k3 * z38 - k4 * z40;
    const Scalar z488 = k4 * z40 - k5 * z42;
    const Scalar z479 = n1_04 * z40 + n3_85 * z42;
    const Scalar z482 = k4 * z38 - k5 * z40;
    const Scalar z489 = z39 * z481 + z38 * z480 - z40 * z482;
    const Scalar z484 = n2_8467 * c_steer;
    const Scalar z497 = z41 * z487 + z40 * z486 - z42 * z488;
    const Scalar z506 = n8_47 - n2_2 * z477 + z497;
    const Scalar z498 = n0_63 - n0_6 * z479 + z489;
    const Scalar z513 = n29_35 - z506;
    const Scalar z483 = k3 * z39 + k4 * z41;
    const Scalar z495 = z38 * z486 - z39 * z487 - z40 * z488;
    const Scalar z496 = c_steer * z487 + z39 * z486 + z41 * z488;
    const Scalar z504 = n2_31 - n0_3 * z477 - n1_1 * z479 - z495;
    const Scalar z512 = n17_7 - z504;
    const Scalar z485 = k4 * z39 + k5 * z41;
    const Scalar z535 = z498 + z513;
    const Scalar z493 = c_steer * z484 + z39 * z483 + z41 * z485;
    const Scalar z492 = z38 * z483 - z39 * z484 - z40 * z485;
    const Scalar z502 = n9_1 - n2_2 * z477 - n0_6 * z479 + z493;
    const Scalar z511 = n49_25 + z502;
    const Scalar z536 = n2 * z512;
    const Scalar z537 = s_pitch * z535 - c_pitch * z536;
    const Scalar z478 = n1_04 * z39 - n3_85 * z41;
    const Scalar z501 = n1_1 * z478 + z492;
    const Scalar z518 = n0_12 + z511;
    const Scalar z505 = n0_3 * z478 + z496;
    const Scalar z507 = n7_7 - z477;
    const Scalar z509 = n25_5 + z507;
    const Scalar z508 = n2_1 - z479;
    const Scalar z510 = n51 - z508;
    const Scalar z538 = s_pitch * z537;
    const Scalar z541 = c_pitch * z537 + z512;
    const Scalar z539 = z513 - z538;
    const Scalar z540 = z498 - z538;
    const Scalar z543 = n39_8603 - z518;
    const Scalar z522 = s_pitch * z501 - c_pitch * z505;
    const Scalar z542 = n39_8603 + z540;
    const Scalar z519 = s_pitch * z509 + c_pitch * z510;
    const Scalar z520 = s_pitch * z510 - c_pitch * z509;
    const Scalar z465 = s_roll * z462 - c_roll * z453;
    const Scalar z545 = s_roll * z519 - c_roll * z478;
    const Scalar z523 = s_roll * z520;
    const Scalar z515 = n0_12 * s_roll;
    const Scalar z464 = c_pitch * z460 + s_pitch * z458;
    const Scalar z469 = c_yaw * z461 + s_yaw * z465;
    const Scalar z470 = s_yaw * z461 - c_yaw * z465;
    const Scalar z528 = s_yaw * z519 + c_yaw * z523;
    const Scalar z521 = s_pitch * z505 + c_pitch * z501;
    const Scalar z524 = c_roll * z520;
    const Scalar z527 = s_yaw * z523 - c_yaw * z519;
    const Scalar z468 = s_roll * z459 - c_roll * z464;
    const Scalar z463 = s_pitch * z460 - c_pitch * z458;
    const Scalar z466 = s_roll * z453 + c_roll * z462;
    const Scalar z1019 = a_yaw * c_roll;
    const Scalar z1023 = v_roll * z322 - z1019;  // angular acceleration of frame.2, z
    const Scalar z1018 = a_yaw * s_roll;
    const Scalar z1022 = v_roll * z323 + z1018;  // angular acceleration of frame.2, y
    const Scalar z1017 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z1015 = n9_81 - a_z;
    const Scalar z1024 = a_roll * c_pitch + s_pitch * z1023;
    const Scalar z1025 = a_roll * s_pitch - c_pitch * z1023;
    const Scalar z907 = s_front * z365 + c_front * z366;
    const Scalar z1028 = v_pitch * z329 - z1024;  // angular acceleration of frame, x
    const Scalar z1030 = v_pitch * z328 + z1025;  // angular acceleration of frame, z
    const Scalar z1016 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z1029 = a_pitch + z1022;  // angular acceleration of frame, y
    const Scalar z1021 = s_roll * z1017 - c_roll * z1015;
    const Scalar z906 = s_front * z366 - c_front * z365;
    const Scalar z1020 = s_roll * z1015 + c_roll * z1017;
    const Scalar z1039 = z345 + z1030;
    const Scalar z1027 = s_pitch * z1016 + c_pitch * z1021;
    const Scalar z1026 = s_pitch * z1021 - c_pitch * z1016;
    const Scalar z1040 = z347 + z1028;
    const Scalar z1041 = z343 - z1029;
    const Scalar z1044 = z41 * z1029 + z40 * z1028 - z42 * z1030;
    const Scalar z1038 = z343 + z1029;
    const Scalar z1043 = c_steer * z1029 + z39 * z1028 + z41 * z1030;
    const Scalar z1042 = z38 * z1028 - z39 * z1029 - z40 * z1030;
    const Scalar z1051 = z31 * a_steer - z1042 + z32 * v_steer * z353;  // angular acceleration of fork, x
    const Scalar z1046 = z1020 - n1_1 * z1039 - n0_3 * z1040;
    const Scalar z894 = s_rear * z328 + c_rear * z329;
    const Scalar z1047 = n0_3 * z351 - z1027 - n1_1 * z1041;
    const Scalar z893 = s_rear * z329 - c_rear * z328;
    const Scalar z1045 = n1_1 * z342 + z1026 - n0_3 * z1038;
    const Scalar z1036 = a_rear + z1029;  // angular acceleration of rear_wheel, y
    const Scalar z1049 = c_steer * z1046 - z39 * z1045 + z41 * z1047;
    const Scalar z1048 = z39 * z1046 + z40 * z1047 + z38 * z1045;
    const Scalar z1050 = z42 * z1047 - z41 * z1046 + z40 * z1045;
    const Scalar z556 = z539 - z543;
    const Scalar z557 = n2 * z522;
    const Scalar z558 = s_roll * z556 - c_roll * z557;
    const Scalar z565 = s_yaw * z520 - c_yaw * z545;
    const Scalar z566 = c_yaw * z520 + s_yaw * z545;
    const Scalar z526 = s_roll * z518 - c_roll * z522;
    const Scalar z1052 = v_steer * z364 + z1043;  // angular acceleration of fork, y
    const Scalar z1053 = z1044 + z31 * v_steer * z353 - z32 * a_steer;  // angular acceleration of fork, z
    const Scalar z559 = s_roll * z558;
    const Scalar z561 = z539 - z559;
    const Scalar z1066 = a_front + z1052;  // angular acceleration of front_wheel, y
    const Scalar z1071 = n0_28 * z1066;  // moment on front_wheel, y
    const Scalar z1054 = z373 + z1052;
    const Scalar z1055 = z375 - z1053;
    const Scalar z1057 = z373 - z1052;
    const Scalar z564 = n39_8603 - z561;
    const Scalar z1068 = z385 * z907;
    const Scalar z1070 = n0_28 * z1068;  // moment on front_wheel, x
    const Scalar z1069 = z385 * z906;
    const Scalar z1072 = n0_28 * z1069;  // moment on front_wheel, z
    const Scalar z1056 = z377 - z1051;
    const Scalar z544 = s_roll * z478 + c_roll * z519;
    const Scalar z548 = s_yaw * z544;
    const Scalar z1073 = c_front * z1070 + s_front * z1072;
    const Scalar z1074 = s_front * z1070 - c_front * z1072;
    const Scalar z549 = c_yaw * z544;
    const Scalar z547 = s_roll * z521 - c_roll * z541;
    // moment on fork, y
    const Scalar z1079 = k31 * z373 - k4 * z393 + n2_5667 * z1052 + z1071 + n3_85 * z1048 - n1_04 * z1050;
    const Scalar z1133 = z341 + z350;
    const Scalar z1090 = n0_12 * z1036;  // moment on rear_wheel, y
    const Scalar z1136 = n2 * z334;
    const Scalar z1078 = k33 * z377 - k3 * z1051 + k4 * z1055 + n3_85 * z1049 + z1073;  // moment on fork, x
    const Scalar z1080 = k34 * z375 - k5 * z1053 + n1_04 * z1049 + k4 * z1056 + z1074;  // moment on fork, z
    const Scalar z1134 = z347 - z1028;
    const Scalar z1087 = z337 * z894;
    const Scalar z1089 = n0_12 * z1087;  // moment on rear_wheel, x
    const Scalar z1145 = n2 * z894;
    const Scalar z1088 = z337 * z893;
    const Scalar z1091 = n0_12 * z1088;  // moment on rear_wheel, z
    const Scalar z1143 = n2 * z893;
    const Scalar z1144 = n2 * z337;
    const Scalar z1146 = z32 * z353;
    const Scalar z1148 = z31 * z353;
    const Scalar z1147 = z31 * z366 - z32 * z365;
    const Scalar z1093 = s_rear * z1089 - c_rear * z1091;
    const Scalar z1092 = s_rear * z1091 + c_rear * z1089;
    const Scalar z1075 = n1_04 * z372 - n3_85 * z1054 - n7 * z1048;  // force on fork, x
    const Scalar z1152 = z31 * z372 - z32 * z1054;
    const Scalar z1150 = z31 * z1050 - z32 * z1048;
    const Scalar z1077 = n3_85 * z381 - n1_04 * z1057 - n7 * z1050;  // force on fork, z
    const Scalar z1076 = n1_04 * z1055 + n7 * z1049 + n3_85 * z1056;  // force on fork, y
    const Scalar z1154 = z31 * z1057 - z32 * z381;
    const Scalar z1156 = n2 * z353;
    const Scalar z1155 = n2 * z365;
    const Scalar z1157 = n2 * z366;
    const Scalar z1135 = n2 * z328;
    const Scalar z1149 = z32 * z1049;
    const Scalar z1137 = n2 * z329;
    const Scalar z1153 = z31 * z1055 + z32 * z1056;
    const Scalar z1081 = z38 * z1075 + z40 * z1077 + z39 * z1076;
    const Scalar z1094 = n25_5 * z342 - z1081 + n51 * z1038;  // force on frame, x
    const Scalar z1082 = z41 * z1077 - z39 * z1075 + c_steer * z1076;
    const Scalar z1124 = z322 * z322;
    const Scalar z1125 = z323 * z323;
    const Scalar z1126 = z1124 + z1125;
    const Scalar z1132 = z345 - z1030;
    const Scalar z1158 = z32 * z1156;
    const Scalar z1159 = z31 * z1157 - z32 * z1155;
    const Scalar z1151 = z31 * z1049;
    const Scalar z1083 = z40 * z1075 + z42 * z1077 - z41 * z1076;
    const Scalar z1096 = z1083 + n51 * z351 + n25_5 * z1041;  // force on frame, z
    const Scalar z1084 = z39 * z1079 - z40 * z1080 + z38 * z1078;
    // moment on frame, x
    const Scalar z1097 = z1092 + n78_6 * z347 + n51 * z1020 - n17_7 * z1039 - n0_3 * z1082 + z1084;
    const Scalar z1166 = n2 * z906;
    const Scalar z1160 = z31 * z1156;
    const Scalar z1086 = z40 * z1078 - z41 * z1079 - z42 * z1080;
    // moment on frame, z
    const Scalar z1099 = z1093 + n49_25 * z345 - n25_5 * z1020 - n29_35 * z1030 - n17_7 * z1040 - n1_1 * z1082 - z1086;
    const Scalar z1085 = c_steer * z1079 - z39 * z1078 - z41 * z1080;
    const Scalar z1168 = n2 * z907;
    const Scalar z1169 = n0_14 * z1168;
    const Scalar z1171 = n0_14 * z1166;
    const Scalar z1167 = n2 * z385;
    const Scalar z1170 = n0_14 * z1167;
    // moment on frame, y
    const Scalar z1098 = z1090 + n29_35 * z343 + n49_25 * z1029 + n17_7 * z411 - n25_5 * z1027 + n51 * z1026 + n0_3
        * z1081 - n1_1 * z1083 + z1085;
    const Scalar z1105 = n39_8603 * (z326 - z1022) + z1098;  // moment on frame.2, y
    const Scalar z1128 = z326 - z1022;
    const Scalar z1175 = c_front * z1169 + s_front * z1171;
    const Scalar z1176 = s_front * z1169 - c_front * z1171;
    const Scalar z1177 = k4 * z1156;
    const Scalar z1178 = n3_85 * z1156;
    const Scalar z1179 = n3_85 * z1155 - n1_04 * z1157;
    const Scalar z1127 = z327 - z1023;
    const Scalar z1103 = s_pitch * z1097 + c_pitch * z1099;
    const Scalar z1106 = n79_7206 * z327 - z1103;  // moment on frame.2, z
    const Scalar z1131 = n2 * z323;
    const Scalar z1130 = n2 * z322;
    const Scalar z1095 = n25_5 * z1039 - z1082 - n51 * z1040;  // force on frame, y
    const Scalar z1181 = n0_1435 * z1157 - z1175;
    const Scalar z1180 = n1_04 * z1156;
    const Scalar z1182 = k40 * z1156 + z1170;
    const Scalar z1183 = k4 * z1155 - z1175 - k41 * z1157;
    const Scalar z1184 = z1176 + k40 * z1155 - k4 * z1157;
    const Scalar z1101 = s_pitch * z1094 + c_pitch * z1096;
    const Scalar z1129 = n2 * v_roll;
    const Scalar z1108 = s_roll * z1095 + c_roll * z1101;
    const Scalar z1100 = s_pitch * z1096 - c_pitch * z1094;
    const Scalar z1185 = k41 * z1156 + z1170;
    const Scalar z1118 = n87 * z1015 - z1108;  // force on frame.z, z
    const Scalar z1186 = n0_1435 * z1155 - z1176;
    const Scalar z1189 = n1_1 * z1136;
    const Scalar z1187 = n0_3 * z1136;
    const Scalar z1188 = n0_3 * z1135 - n1_1 * z1137;
    const Scalar z1107 = s_roll * z1101 - c_roll * z1095;
    const Scalar z1190 = z38 * z1178 - z40 * z1180 + z39 * z1179;
    const Scalar z1191 = c_steer * z1179 - z39 * z1178 - z41 * z1180;
    const Scalar z1112 = c_yaw * z1100 + s_yaw * z1107;
    const Scalar z1116 = n87 * a_x + z1112;  // force on frame.z, x
    const Scalar z1192 = z40 * z1178 - z42 * z1180 - z41 * z1179;
    const Scalar z1113 = s_yaw * z1100 - c_yaw * z1107;
    const Scalar z1193 = n7 * z1187 - z1190;
    const Scalar z1194 = n7 * z1188 - z1191;
    const Scalar z1117 = n87 * a_y + z1113;  // force on frame.z, y
    const Scalar z1195 = n7 * z1189 + z1192;
    const Scalar z1223 = n0_06 * z1145;
    const Scalar z1225 = n0_06 * z1143;
    const Scalar z1224 = n0_06 * z1144;
    const Scalar z1196 = z38 * z1177 - z40 * z1185 + z39 * z1183;
    const Scalar z1203 = z40 * z1181 - z42 * z1186;
    const Scalar z1197 = z38 * z1181 - z40 * z1186;
    const Scalar z1202 = z40 * z1177 - z42 * z1185 - z41 * z1183;
    const Scalar z1200 = z39 * z1181 + z41 * z1186;
    const Scalar z1198 = z38 * z1182 - z40 * z1177 + z39 * z1184;
    const Scalar z1199 = c_steer * z1183 - z39 * z1177 - z41 * z1185;
    const Scalar z1204 = z40 * z1182 - z42 * z1177 - z41 * z1184;
    const Scalar z1201 = c_steer * z1184 - z39 * z1182 - z41 * z1177;
    const Scalar z1207 = z40 * z1196 - z41 * z1197 + z42 * z1198;
    const Scalar z1216 = z479 * z1187 - z1207 - n0_3 * z1193;
    const Scalar z1211 = z39 * z1203 + z38 * z1202 + z40 * z1204;
    const Scalar z1220 = z1211 + z477 * z1189 - n1_1 * z1195;
    const Scalar z1205 = z39 * z1197 + z38 * z1196 + z40 * z1198;
    const Scalar z1206 = c_steer * z1197 - z39 * z1196 + z41 * z1198;
    const Scalar z1214 = z477 * z1187 - z1205 - n1_1 * z1193;
    const Scalar z1235 = n51 * z1136 - z1193;
    const Scalar z1229 = z1216 - z1224;
    const Scalar z1232 = z1220 - z1224;
    const Scalar z1215 = z478 * z1187 + z1206;
    const Scalar z1240 = n39_3 * z1136 - z1229;
    const Scalar z1243 = n9_95 * z1136 - z1232;
    const Scalar z1213 = z40 * z1202 - z41 * z1203 + z42 * z1204;
    const Scalar z1212 = c_steer * z1203 - z39 * z1202 + z41 * z1204;
    const Scalar z1222 = z1213 + z479 * z1189 - n0_3 * z1195;
    const Scalar z1237 = n25_5 * z1136 + z1195;
    const Scalar z1234 = n17_7 * z1136;
    const Scalar z1238 = z1214 + z1234;
    const Scalar z1221 = z478 * z1189 - z1212;
    const Scalar z1210 = z41 * z1200 + z40 * z1199 + z42 * z1201;
    const Scalar z1219 = z479 * z1188 - z1210 - n0_3 * z1194;
    const Scalar z1245 = z1222 + z1234;
    const Scalar z1208 = z38 * z1199 - z39 * z1200 + z40 * z1201;
    const Scalar z1209 = c_steer * z1200 + z39 * z1199 - z41 * z1201;
    const Scalar z1217 = z477 * z1188 - z1208 - n1_1 * z1194;
    const Scalar z1236 = n51 * z1135 - z1194 + n25_5 * z1137;
    const Scalar z1218 = z478 * z1188 - z1209;
    const Scalar z1318 = n7 * z1016 - z1100;
    const Scalar z1317 = n7 * z1017 - z1107;
    const Scalar z1334 = z544 * z1016;
    const Scalar z1227 = s_rear * z1223 - c_rear * z1225;
    const Scalar z1226 = s_rear * z1225 + c_rear * z1223;
    const Scalar z1231 = z1219 - z1227;
    const Scalar z1228 = z1215 - z1226;
    const Scalar z1230 = z1217 + z1226;
    const Scalar z1233 = z1221 - z1227;
    const Scalar z1244 = n39_3 * z1135 - z1233;
    const Scalar z1239 = n39_3 * z1137 - z1228;
    const Scalar z1242 = n39_3 * z1135 - z1231 + n17_7 * z1137;
    const Scalar z1241 = z1230 + n17_7 * z1135 + n9_95 * z1137;
    const Scalar z1246 = s_pitch * z1237 + c_pitch * z1235;
    const Scalar z1343 = z478 * z1126 + n7 * z1020 + z520 * z1127 + z323 * z1246 + z1095;
    const Scalar z1342 = z322 * z1246 - z519 * z1126 - z520 * z1128 + n7 * z1021 - z1101;
    const Scalar z1248 = z1238 + z1245;
    const Scalar z1249 = z1240 - z1243;
    const Scalar z1254 = s_pitch * z1248 + c_pitch * z1249;
    const Scalar z1247 = s_pitch * z1235 - c_pitch * z1237;
    const Scalar z1360 = z520 * z1131 + z1236;
    const Scalar z1359 = z520 * z1130 - z1247;
    const Scalar z1251 = s_pitch * z1239 + c_pitch * z1244;
    const Scalar z1263 = n39_8603 * z1129 - z1251;
    const Scalar z1255 = s_pitch * z1254;
    const Scalar z1250 = s_pitch * z1244 - c_pitch * z1239;
    const Scalar z1260 = n39_8603 * z1131 + z1250;
    const Scalar z1256 = z1245 - z1255;
    const Scalar z1257 = z1238 - z1255;
    const Scalar z1377 = z1218 - z1238;
    const Scalar z1376 = z1238 - z1245;
    const Scalar z1375 = z1218 + z1245;
    const Scalar z1252 = s_pitch * z1242 - c_pitch * z1241;
    const Scalar z1363 = s_roll * z1360 - c_roll * z1359;
    const Scalar z1364 = s_roll * z1359 + c_roll * z1360;
    const Scalar z1253 = c_pitch * z1242 + s_pitch * z1241;
    const Scalar z1394 = z501 * z1133 - z1099 - z478 * z1026 - z498 * z1132 - z512 * z1134 + z329 * z1375 + z328
        * z1240;
    const Scalar z1378 = z510 * z1027 + z509 * z1026 + z505 * z1134 + z501 * z1132 - z518 * z1133 + z328 * z1242 + z329
        * z1241;
    const Scalar z1391 = n7 * z1027 - z478 * z1134 - z510 * z1133 + z328 * z1236 - z1096;
    const Scalar z1393 = z478 * z1132 - z509 * z1133 + n7 * z1026 + z329 * z1236 - z1094;
    const Scalar z1258 = c_pitch * z1254 - z1240;
    const Scalar z1395 = z1097 + z512 * z1132 - z478 * z1027 - z505 * z1133 - z513 * z1134 + z328 * z1377 - z329
        * z1243;
    const Scalar z1259 = c_pitch * z1254 + z1243;
    const Scalar z1379 = z1376 + z501 * z1137 - z505 * z1135;
    const Scalar z1262 = n39_8603 * z1130 + z1258;
    const Scalar z1384 = z519 * z1017 + z523 * z1016;
    const Scalar z1362 = z1262 + z522 * z1131 - z539 * z1130;
    const Scalar z1392 = z328 * z1235 + z329 * z1237 - z509 * z1134 - z510 * z1132;
    const Scalar z1397 = s_pitch * z1391 - c_pitch * z1393;
    const Scalar z1396 = s_pitch * z1393 + c_pitch * z1391;
    const Scalar z1264 = s_roll * z1247 - c_roll * z1236;
    const Scalar z1341 = z478 * z1128 - z519 * z1127 + z323 * z1247 + z322 * z1236;
    const Scalar z1266 = z1218 - z1256;
    const Scalar z1358 = z478 * z1130 + z519 * z1131;
    const Scalar z1332 = z519 * z1021 - z478 * z1020 + z521 * z1127 - z541 * z1128 - z542 * z1126 + z323 * z1260 + z322
        * z1259;
    const Scalar z1271 = s_roll * z1260 - c_roll * z1259;
    const Scalar z1261 = n39_8603 * z1131 + z1252;
    const Scalar z1361 = z1261 + z522 * z1130 - z543 * z1131;
    const Scalar z1381 = z1252 + z518 * z1131 + z522 * z1130;
    const Scalar z1267 = z1253 - z1263;
    const Scalar z1272 = s_roll * z1266 - c_roll * z1267;
    const Scalar z1412 = z478 * z1135 - z1237;
    const Scalar z1346 = s_roll * z1343 - c_roll * z1342;
    const Scalar z1347 = c_roll * z1343 + s_roll * z1342;
    const Scalar z1366 = s_roll * z1361 - c_roll * z1362;
    const Scalar z1273 = s_roll * z1272;
    const Scalar z1413 = z509 * z1135 - z510 * z1137;
    const Scalar z1274 = z1218 - z1273;
    const Scalar z1414 = z478 * z1137 + z1235;
    const Scalar z1314 = z1257 - z1274;
    const Scalar z1400 = c_roll * z1392 + s_roll * z1397;
    const Scalar z1401 = s_roll * z1392 - c_roll * z1397;
    const Scalar z1367 = s_yaw * z1363 - c_yaw * z1358;
    const Scalar z1368 = s_yaw * z1358 + c_yaw * z1363;
    const Scalar z1279 = s_yaw * z1264 - c_yaw * z1246;
    const Scalar z1415 = z1239 + z498 * z1137 - z512 * z1135;
    const Scalar z1280 = s_yaw * z1246 + c_yaw * z1264;
    const Scalar z1416 = z513 * z1135 - z1244 + z512 * z1137;
    const Scalar z1417 = s_pitch * z1414 + c_pitch * z1412;
    const Scalar z1351 = s_yaw * z1341 - c_yaw * z1346;
    const Scalar z1350 = c_yaw * z1341 + s_yaw * z1346;
    const Scalar z1383 = s_roll * z1376 - c_roll * z1253;
    const Scalar z1380 = z521 * z1126 - z520 * z1020 - z518 * z1127 + z522 * z1128 + z323 * z1376 + z322 * z1253;
    const Scalar z1405 = s_yaw * z1396 + c_yaw * z1400;
    const Scalar z1404 = s_yaw * z1400 - c_yaw * z1396;
    const Scalar z1331 = z1218 - z1257;
    const Scalar z1345 = z520 * z1021 - z1105 + z522 * z1127 - z541 * z1126 + z539 * z1128 + z323 * z1263 + z322
        * z1331;
    const Scalar z1330 = z1256 - z1257;
    const Scalar z1344 = z521 * z1126 - z1106 - z520 * z1020 + z522 * z1128 + z543 * z1127 + z322 * z1253 - z323
        * z1330;
    const Scalar z1329 = z1218 + z1256;
    const Scalar z1349 = c_roll * z1345 + s_roll * z1344;
    const Scalar z1333 = z1329 + z521 * z1131 + z541 * z1130;
    const Scalar z1315 = z520 * z1016 + z545 * z1017;
    const Scalar z1418 = s_pitch * z1412 - c_pitch * z1414;
    const Scalar z1321 = s_yaw * z1318 - c_yaw * z1317;
    const Scalar z1322 = c_yaw * z1318 + s_yaw * z1317;
    const Scalar z1472 = z461 * z1017 - z465 * z1016;
    const Scalar z1480 = z1146 * z1180 - z1148 * z1178 + n3_85 * z1152 + n1_04 * z1154 + z31 * z1077 - z32 * z1075 + n7
        * z1150;
    const Scalar z1483 = z31 * z1080 + z32 * z1078 - z1146 * z1183 + z1148 * z1184 - n3_85 * z1149 - n1_04 * z1151
        - n2_8467 * z1153;
    const Scalar z1479 = z1147 * z1180 + z1148 * z1179 - n7 * z1149 - n3_85 * z1153 + z32 * z1076;
    const Scalar z1481 = z31 * z1076 - z1146 * z1179 - z1147 * z1178 - n7 * z1151 - n1_04 * z1153;
    const Scalar z1453 = z31 * z1177 - z32 * z1185;
    const Scalar z1455 = z31 * z1182 - z32 * z1177;
    const Scalar z1454 = z31 * z1181 - z32 * z1186;
    const Scalar z1482 = z1146 * z1177 - z1148 * z1182 + k3 * z1152 + k4 * z1154 + n3_85 * z1150 - z1147 * z1181 + z32
        * z1079;
    const Scalar z1484 = z1146 * z1185 - z1148 * z1177 + k4 * z1152 + k5 * z1154 + n1_04 * z1150 - z1147 * z1186 + z31
        * z1079;
    const Scalar z1456 = z1146 * z1453 + z450 * z1152 - z1148 * z1455 + z451 * z1154 + z449 * z1150 - z1147 * z1454;
    const Scalar z1460 = z40 * z1453 + z42 * z1455 - z41 * z1454;
    const Scalar z1463 = z1460 + z452 * z1188 - z453 * z1187;
    const Scalar z1458 = z38 * z1453 + z40 * z1455 + z39 * z1454;
    const Scalar z1459 = z41 * z1455 - z39 * z1453 + c_steer * z1454;
    const Scalar z1461 = z453 * z1189 - z1458 - z454 * z1188;
    const Scalar z1462 = z1459 + z452 * z1189 - z454 * z1187;
    const Scalar z1485 = z38 * z1479 + z39 * z1480 - z40 * z1481;
    const Scalar z1464 = z458 * z1132 - z452 * z1027 - z459 * z1133 - z460 * z1134 + z454 * z1026 + z328 * z1463 + z329
        * z1461;
    const Scalar z1465 = z1462 + z460 * z1135 + z458 * z1137;
    const Scalar z1487 = z40 * z1479 - z41 * z1480 - z42 * z1481;
    const Scalar z1486 = c_steer * z1480 - z39 * z1479 - z41 * z1481;
    const Scalar z1466 = s_pitch * z1463 - c_pitch * z1461;
    const Scalar z1467 = s_pitch * z1461 + c_pitch * z1463;
    const Scalar z1468 = z462 * z1020 + z453 * z1021 - z459 * z1127 - z463 * z1126 + z464 * z1128 + z323 * z1462 + z322
        * z1467;
    const Scalar z1469 = z1466 + z459 * z1131 + z464 * z1130;
    const Scalar z1471 = s_roll * z1462 - c_roll * z1467;
    const Scalar z1421 = c_roll * z1413 + s_roll * z1418;
    const Scalar z1422 = s_roll * z1413 - c_roll * z1418;
    const Scalar z1494 = s_pitch * z1487 + c_pitch * z1485;
    const Scalar z1426 = s_yaw * z1417 + c_yaw * z1421;
    const Scalar z1425 = s_yaw * z1421 - c_yaw * z1417;
    const Scalar z1488 = z38 * z1482 - z40 * z1484 - z39 * z1483;
    const Scalar z1491 = n0_3 * z1486 - z1488;
    const Scalar z1489 = z39 * z1482 + z41 * z1484 + c_steer * z1483;
    const Scalar z1490 = z40 * z1482 - z42 * z1484 + z41 * z1483;
    const Scalar z1493 = n1_1 * z1486 + z1490;
    const Scalar z1492 = n0_3 * z1485 - z1489 - n1_1 * z1487;
    const Scalar z1436 = s_pitch * z1226 + c_pitch * z1227;
    const Scalar z1435 = s_pitch * z1227 - c_pitch * z1226;
    const Scalar z1399 = c_pitch * z1395 + s_pitch * z1394;
    const Scalar z1398 = s_pitch * z1395 - c_pitch * z1394;
    const Scalar z1495 = s_pitch * z1485 - c_pitch * z1487;
    const Scalar z1403 = c_roll * z1399 + s_roll * z1378;
    const Scalar z1511 = z31 * z1180 + z32 * z1178 - n3_85 * z1158 - n1_04 * z1160;
    const Scalar z1514 = n2_8467 * z1159 + z31 * z1183 + z32 * z1184;
    const Scalar z1513 = z31 * z1177 - k3 * z1158 - k4 * z1160 + z32 * z1182;
    const Scalar z1515 = z32 * z1177 - k4 * z1158 - k5 * z1160 + z31 * z1185;
    const Scalar z1510 = z32 * z1179 + n3_85 * z1159;
    const Scalar z1512 = z31 * z1179 + n1_04 * z1159;
    const Scalar z1498 = s_roll * z1495 - c_roll * z1486;
    const Scalar z1499 = s_roll * z1486 + c_roll * z1495;
    const Scalar z1503 = s_yaw * z1494 + c_yaw * z1498;
    const Scalar z1502 = s_yaw * z1498 - c_yaw * z1494;
    const Scalar z1420 = s_pitch * z1415 - c_pitch * z1416;
    const Scalar z1419 = s_pitch * z1416 + c_pitch * z1415;
    const Scalar z1424 = s_roll * z1379 - c_roll * z1420;
    const Scalar z1516 = z38 * z1510 - z39 * z1511 - z40 * z1512;
    const Scalar z1518 = z40 * z1510 + z41 * z1511 - z42 * z1512;
    const Scalar z1517 = c_steer * z1511 + z39 * z1510 + z41 * z1512;
    const Scalar z1519 = z38 * z1513 - z40 * z1515 + z39 * z1514;
    const Scalar z1522 = n0_3 * z1517 - z1519;
    const Scalar z1521 = z40 * z1513 - z42 * z1515 - z41 * z1514;
    const Scalar z1520 = c_steer * z1514 - z39 * z1513 - z41 * z1515;
    const Scalar z1524 = n1_1 * z1517 + z1521;
    const Scalar z1523 = n0_3 * z1516 - z1520 - n1_1 * z1518;
    const Scalar z1437 = z322 * z1436 - n0_12 * z1127;
    const Scalar z1440 = c_roll * z1436;
    const Scalar z1525 = s_pitch * z1518 + c_pitch * z1516;
    const Scalar z1497 = s_pitch * z1491 + c_pitch * z1493;
    const Scalar z1496 = s_pitch * z1493 - c_pitch * z1491;
    const Scalar z1501 = s_roll * z1492 - c_roll * z1497;
    const Scalar z1438 = n0_12 * z1131 + z1435;
    const Scalar z1542 = z1146 * z1175 + z1148 * z1176 - n0_28 * z1153;
    const Scalar z1526 = s_pitch * z1516 - c_pitch * z1518;
    const Scalar z1543 = z31 * z1175 - z32 * z1176 - n0_28 * z1159;
    const Scalar z1616 = s_yaw * z100;
    const Scalar z1617 = n0_35 * z155 / (z116 * z116);
    const Scalar z1619 = c_yaw * z100;
    const Scalar z1613 = n0_3 * z78 / (z54 * z54);
    const Scalar z1618 = z1616 - z117 * z150 + z112 * z1617;
    const Scalar z1620 = z113 * z1617 - z1619 - z117 * z152;
    const Scalar z1614 = z50 * z1613 - z55 * z73;
    const Scalar z1623 = n2 * (s_roll * z48 + c_roll * z72);
    const Scalar z1590 = z101 + z112 * z117;
    const Scalar z1601 = z259 - z1590;
    const Scalar z1608 = z101 - z1590;
    const Scalar z1624 = n2 * (s_roll * z49 + c_roll * z74);
    const Scalar z1589 = z102 - z113 * z117;
    const Scalar z1603 = z260 - z1589;
    const Scalar z1610 = z102 - z1589;
    const Scalar z1625 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z1626 = n2 * (z50 * z1623 + z51 * z1624 - z52 * z1625 - z73 * z73 - z75 * z75 - z76 * z76);
    const Scalar z1597 = s_roll * z1590 + z48 * z242;
    const Scalar z1587 = z51 * z55;
    const Scalar z1615 = z51 * z1613 - z55 * z75;
    const Scalar z1598 = s_roll * z1589 + z49 * z242;
    const Scalar z1602 = z252 * z1601 - z253 * z266;
    const Scalar z1588 = z50 * z55;
    const Scalar z1596 = s_roll * z1587 - z49 * z218;
    const Scalar z1604 = z252 * z1603 - z254 * z266;
    const Scalar z1609 = z109 * z1608 + z110 * z272;
    const Scalar z1611 = z109 * z1610 - z111 * z272;
    const Scalar z1595 = s_roll * z1588 - z48 * z218;
    const Scalar z1544 = z38 * z1175 - z40 * z1176;
    const Scalar z1545 = z39 * z1175 + z41 * z1176;
    const Scalar z1548 = z440 * z1137 - z1545 + z442 * z1135;
    const Scalar z1546 = z40 * z1175 - z42 * z1176;
    const Scalar z1547 = z441 * z1133 + z440 * z1132 - z442 * z1134 + z328 * z1546 - z329 * z1544;
    const Scalar z1571 = z31 * z1175 - z32 * z1176;
    const Scalar z1529 = c_roll * z1517 + s_roll * z1526;
    const Scalar z1530 = s_roll * z1517 - c_roll * z1526;
    const Scalar z1550 = s_pitch * z1544 - c_pitch * z1546;
    const Scalar z1551 = z443 * z1126 - z441 * z1127 - z444 * z1128 + z323 * z1545 + z322 * z1550;
    const Scalar z1549 = s_pitch * z1546 + c_pitch * z1544;
    const Scalar z1552 = z441 * z1131 - z1549 - z444 * z1130;
    const Scalar z1554 = s_roll * z1545 - c_roll * z1550;
    const Scalar z1534 = s_yaw * z1525 + c_yaw * z1529;
    const Scalar z1533 = s_yaw * z1529 - c_yaw * z1525;
    const Scalar z1528 = s_pitch * z1522 + c_pitch * z1524;
    const Scalar z1527 = s_pitch * z1524 - c_pitch * z1522;
    const Scalar z1627 = n0_5 * (z77 * z78 / (z54 * z54) + z1626 / z54);
    const Scalar z1628 = n0_3 * z1627;
    const Scalar z1532 = c_roll * z1528 + s_roll * z1523;
    const Scalar z1633 = n2 * (z108 * z108 - z109 * z109);
    const Scalar z1645 = s_roll * z97;
    const Scalar z1648 = c_yaw * z158;
    const Scalar z1649 = z108 * z162 - z109 * z1648 - z111 * z159 - z151 * z158;
    const Scalar z1650 = n2 * (z109 * z159 + z108 * z158);
    const Scalar z1646 = s_yaw * z158;
    const Scalar z1647 = z108 * z160 - z109 * z1646 + z110 * z159 - z149 * z158;
    const Scalar z1629 = s_yaw * z108;
    const Scalar z1630 = n2 * z108 * z149 + z109 * (z110 + z1629);
    const Scalar z1640 = z99 + z117 * z153 + z114 * z1617;
    const Scalar z1631 = c_yaw * z108;
    const Scalar z1632 = n2 * z108 * z151 - z109 * (z111 - z1631);
    const Scalar z1641 = s_yaw * z1640;
    const Scalar z1642 = c_yaw * z1640;
    const Scalar z1637 = z52 * z1613 - z55 * z76;
    const Scalar z1639 = c_yaw * z1637;
    const Scalar z1638 = s_yaw * z1637;
    const Scalar z1599 = l_lambda_rear_rolls_x * z1595 + l_lambda_rear_rolls_y * z1596 - l_lambda_front_rolls_x * z1597
        - l_lambda_front_rolls_y * z1598;
    const Scalar z1634 = n2 * (z114 * z1633 - z153 * z153 - z152 * z152 - z150 * z150 + z112 * z1630 - z113 * z1632);
    const Scalar z1600 = z1384 + z1599;
    const Scalar z1635 = n0_5 * (z154 * z155 / (z116 * z116) + z1634 / z116);
    const Scalar z1605 = l_lambda_front_rolls_x * z1602 + l_lambda_front_rolls_y * z1604;
    const Scalar z1606 = z1472 + z1605;
    const Scalar z1607 = l_lambda_rear_rolls_x * z1595 + l_lambda_rear_rolls_y * z1596;
    const Scalar z1612 = l_lambda_front_rolls_x * z1609 + l_lambda_front_rolls_y * z1611;
    const Scalar z1621 = l_lambda_rear_rolls_x * z1615 - l_lambda_rear_rolls_y * z1614 + l_lambda_front_rolls_y * z1618
        + l_lambda_front_rolls_x * z1620;
    const Scalar z1622 = z1349 + z1621;
    const Scalar z1591 = l_lambda_rear_rolls_x * z1588 + l_lambda_rear_rolls_y * z1587 - l_lambda_front_rolls_x * z1590
        - l_lambda_front_rolls_y * z1589;
    const Scalar z1651 = n2 * (z153 * z164 - z114 * z1650 - z152 * z163 + z150 * z161 - z113 * z1649 + z112 * z1647);
    const Scalar z1592 = z1315 + z1591;
    const Scalar z1636 = z100 - n0_35 * z1635;
    const Scalar z1652 = n0_5 * (z155 * z165 / (z116 * z116) - z1651 / z116);
    const Scalar z1643 = l_lambda_rear_touches * z1628 + l_lambda_rear_rolls_x * z1638 + l_lambda_rear_rolls_y * z1639
        + l_lambda_front_rolls_x * z1641 + l_lambda_front_rolls_y * z1642 - l_lambda_front_touches * z1636;
    const Scalar z1644 = z1332 - z1643;
    const Scalar z1593 = z219 * l_lambda_rear_rolls_y - z220 * l_lambda_rear_rolls_x + z243 * l_lambda_front_rolls_y
        - z244 * l_lambda_front_rolls_x;
    const Scalar z1594 = z1334 + z1593;
    const Scalar z1672 = z257 - z1640;
    const Scalar z1683 = z99 - z1640;
    const Scalar z1685 = z1616 - z1618;
    const Scalar z1682 = z1619 + z1620;
    const Scalar z1696 = n0_5 * (z154 * z166 / (z116 * z116) - z1651 / z116);
    const Scalar z1697 = z1645 - n0_35 * z1696;
    const Scalar z1653 = z1645 - n0_35 * z1652;
    const Scalar z1704 = s_roll * z107;
    const Scalar z1705 = c_yaw * z106 + s_yaw * z1704;
    const Scalar z1708 = s_yaw * z106 - c_yaw * z1704;
    const Scalar z1660 = c_roll * z170 + s_roll * z176;
    const Scalar z1706 = c_roll * z107;
    const Scalar z1707 = z109 * z1705 - n2 * z158 * z160 + z110 * z1706;
    const Scalar z1709 = z109 * z1708 + n2 * z158 * z162 + z111 * z1706;
    const Scalar z1710 = n2 * (z109 * z1706 - z158 * z158);
    const Scalar z1661 = s_yaw * z179;
    const Scalar z1662 = z109 * z1661 + z149 * z179 + z108 * z182 + z110 * z180;
    const Scalar z1711 = n2 * (z112 * z1707 + z113 * z1709 - z114 * z1710 - z161 * z161 - z163 * z163 - z164 * z164);
    const Scalar z1692 = s_yaw * z98 - c_yaw * z1645;
    const Scalar z1689 = c_yaw * z98 + s_yaw * z1645;
    const Scalar z1663 = c_yaw * z179;
    const Scalar z1664 = z108 * z184 - z109 * z1663 + z111 * z180 - z151 * z179;
    const Scalar z1665 = n2 * (z108 * z179 - z109 * z180);
    const Scalar z1690 = n0_35 * z166 / (z116 * z116);
    const Scalar z1671 = c_yaw * z252;
    const Scalar z1676 = s_yaw * z252;
    const Scalar z1693 = z1692 + z117 * z163 + z113 * z1690;
    const Scalar z1698 = z117 * z164 - z157 + z114 * z1690;
    const Scalar z1666 = n2 * (z152 * z185 - z153 * z186 + z114 * z1665 + z150 * z183 + z112 * z1662 + z113 * z1664);
    const Scalar z1712 = n0_5 * (z165 * z166 / (z116 * z116) + z1711 / z116);
    const Scalar z1674 = s_yaw * z258;
    const Scalar z1675 = z1618 - z1674;
    const Scalar z1691 = z1689 - z117 * z161 + z112 * z1690;
    const Scalar z1699 = s_yaw * z1698;
    const Scalar z1669 = c_yaw * z258;
    const Scalar z1670 = z1620 + z1669;
    const Scalar z1700 = c_yaw * z1698;
    const Scalar z1656 = c_roll * z241 + z74 * z242 + z49 * z1640 + s_roll * z1620;
    const Scalar z1657 = c_roll * z240 - z72 * z242 + s_roll * z1618 - z48 * z1640;
    const Scalar z1673 = z251 * z265 - z266 * z1671 + z254 * z1672 + z252 * z1670;
    const Scalar z1655 = z72 * z218 - c_roll * z216 + s_roll * z1614 + z48 * z1637;
    const Scalar z1677 = z251 * z264 + z266 * z1676 + z252 * z1675 - z253 * z1672;
    const Scalar z1684 = z108 * z271 - z151 * z272 + z111 * z1683 - z109 * z1682;
    const Scalar z1686 = z108 * z270 + z149 * z272 + z109 * z1685 + z110 * z1683;
    const Scalar z1654 = c_roll * z217 + z74 * z218 + s_roll * z1615 + z49 * z1637;
    const Scalar z1714 = s_roll * z1693 + z49 * z1698;
    const Scalar z1715 = s_roll * z1691 - z48 * z1698;
    const Scalar z1703 = c_roll * z98;
    const Scalar z1713 = z1703 - n0_35 * z1712;
    const Scalar z1667 = n0_5 * (z155 * z187 / (z116 * z116) - z1666 / z116);
    const Scalar z1668 = z1660 - n0_35 * z1667;
    const Scalar z1687 = l_lambda_front_rolls_x * z1684 + l_lambda_front_rolls_y * z1686;
    const Scalar z1688 = z1551 - z1687;
    const Scalar z1680 = l_lambda_rear_rolls_x * z1654 - l_lambda_rear_rolls_y * z1655;
    const Scalar z1681 = z1437 + z1680;
    const Scalar z1678 = l_lambda_front_rolls_x * z1673 + l_lambda_front_rolls_y * z1677 - l_lambda_front_touches
        * z1668;
    const Scalar z1658 = l_lambda_rear_rolls_x * z1654 - l_lambda_rear_rolls_y * z1655 - l_lambda_front_touches * z1653
        + l_lambda_front_rolls_x * z1656 + l_lambda_front_rolls_y * z1657;
    const Scalar z1679 = z1468 + z1678;
    const Scalar z1659 = z1380 + z1658;
    const Scalar z1745 = z1692 - z1693;
    const Scalar z1748 = z1689 - z1691;
    const Scalar z1746 = z157 + z1698;
    const Scalar z1718 = s_pitch * z175 + c_pitch * z173;
    const Scalar z1720 = s_roll * z181;
    const Scalar z1722 = c_roll * z181;
    const Scalar z1752 = s_yaw * z1660 - c_yaw * z1718;
    const Scalar z1724 = s_yaw * z178 + c_yaw * z1720;
    const Scalar z1721 = s_yaw * z1720 - c_yaw * z178;
    const Scalar z1725 = z109 * z1724 - z162 * z179 - z158 * z184 - z111 * z1722;
    const Scalar z1723 = z158 * z182 + z109 * z1721 - z160 * z179 + z110 * z1722;
    const Scalar z1726 = n2 * (z109 * z1722 - z158 * z179);
    const Scalar z1734 = s_roll * z249;
    const Scalar z1753 = n0_35 * z188 / (z116 * z116);
    const Scalar z1731 = s_roll * z255;
    const Scalar z1735 = s_yaw * z250 - c_yaw * z1734;
    const Scalar z1741 = c_yaw * z250 + s_yaw * z1734;
    const Scalar z1727 = n2 * (z161 * z183 - z164 * z186 - z114 * z1726 - z163 * z185 - z113 * z1725 + z112 * z1723);
    const Scalar z1730 = c_roll * z249;
    const Scalar z1732 = s_yaw * z256 - c_yaw * z1731;
    const Scalar z1733 = z1693 - z1732;
    const Scalar z1739 = c_yaw * z256 + s_yaw * z1731;
    const Scalar z1740 = z1691 - z1739;
    const Scalar z1736 = c_roll * z255;
    const Scalar z1737 = z1698 + z1736;
    const Scalar z1747 = z158 * z271 + z162 * z272 + z109 * z1745 - z111 * z1746;
    const Scalar z1738 = z266 * z1735 - z265 * z1730 + z252 * z1733 - z254 * z1737;
    const Scalar z1742 = z266 * z1741 - z264 * z1730 + z252 * z1740 + z253 * z1737;
    const Scalar z1749 = z158 * z270 - z160 * z272 + z109 * z1748 - z110 * z1746;
    const Scalar z1719 = c_roll * z1718;
    const Scalar z1728 = n0_5 * (z166 * z187 / (z116 * z116) - z1727 / z116);
    const Scalar z1750 = l_lambda_front_rolls_x * z1747 + l_lambda_front_rolls_y * z1749;
    const Scalar z1751 = z1547 - z1750;
    const Scalar z1716 = l_lambda_front_rolls_x * z1714 + l_lambda_front_rolls_y * z1715 - l_lambda_front_touches
        * z1713;
    const Scalar z1717 = z1378 - z1716;
    const Scalar z1729 = z1719 + n0_35 * z1728;
    const Scalar z1694 = l_lambda_front_rolls_x * z1693 + l_lambda_front_rolls_y * z1691;
    const Scalar z1695 = z1403 - z1694;
    const Scalar z1759 = n0_5 * (z154 * z188 / (z116 * z116) - z1666 / z116);
    const Scalar z1760 = z1660 - n0_35 * z1759;
    const Scalar z1755 = s_yaw * z1718 + c_yaw * z1660;
    const Scalar z1754 = z1752 - z117 * z183 + z112 * z1753;
    const Scalar z1756 = z113 * z1753 - z1755 - z117 * z185;
    const Scalar z1743 = l_lambda_front_touches * z1729 + l_lambda_front_rolls_x * z1738 + l_lambda_front_rolls_y
        * z1742;
    const Scalar z1744 = z1464 - z1743;
    const Scalar z1701 = l_lambda_front_rolls_x * z1699 + l_lambda_front_rolls_y * z1700 - l_lambda_front_touches
        * z1697;
    const Scalar z1702 = z1398 - z1701;
    const Scalar z1800 = k33 * z377 + z390 - k3 * z1051 + k4 * z1055 + n3_85 * z1049;  // moment on fork, x
    const Scalar z1801 = k34 * z375 + z392 - k5 * z1053 + n1_04 * z1049 + k4 * z1056;  // moment on fork, z
    const Scalar z1810 = z327 + z1023;
    const Scalar z1792 = z1752 - z1754;
    const Scalar z1789 = z1755 + z1756;
    const Scalar z1766 = n0_5 * (z165 * z188 / (z116 * z116) - z1727 / z116);
    const Scalar z1767 = z1719 + n0_35 * z1766;
    const Scalar z1804 = z40 * z1800 - z41 * z1079 - z42 * z1801;
    const Scalar z1802 = z38 * z1800 + z39 * z1079 - z40 * z1801;
    // moment on frame, z
    const Scalar z1807 = z410 - n25_5 * z1020 + n9_95 * z1039 - n17_7 * z1040 - n1_1 * z1082 - z1804;
    // moment on frame, x
    const Scalar z1805 = z408 + n51 * z1020 - n17_7 * z1039 + n39_3 * z1040 - n0_3 * z1082 + z1802;
    const Scalar z1856 = a_z - a_roll * z79 - z91;
    const Scalar z1857 = a_z + a_roll * z156 - a_pitch * z167 - a_steer * z189 + z215;
    const Scalar z1859 = a_y - z223 * (a_pitch + a_rear) - a_yaw * z216 + a_roll * z220 - z239;
    const Scalar z1803 = c_steer * z1079 - z39 * z1800 - z41 * z1801;
    // moment on frame, y
    const Scalar z1806 = z1090 + n29_35 * z343 + n49_25 * z1029 + n17_7 * z411 - n25_5 * z1027 + n51 * z1026 + n0_3
        * z1081 - n1_1 * z1083 + z1803;
    const Scalar z1821 = z31 * z1800 - z32 * z1801;
    const Scalar z1858 = a_x + a_yaw * z241 - a_roll * z243 + a_pitch * z246 + a_steer * z267 + a_front * z273 + z306;
    const Scalar z1860 = a_y - a_yaw * z240 + a_roll * z244 - a_pitch * z247 - a_steer * z268 - a_front * z274 - z321;
    const Scalar z1861 = z222 * (a_pitch + a_rear) + a_x + a_yaw * z217 - a_roll * z219 + z233;
    const Scalar z1779 = n2 * (z179 * z182 + z109 * z110);
    const Scalar z1761 = z177 - z117 * z186 + z114 * z1753;
    const Scalar z1790 = z177 - z1761;
    const Scalar z1780 = n2 * (z179 * z184 + z109 * z111);
    const Scalar z1762 = s_yaw * z1761;
    const Scalar z1781 = n2 * (z109 * z109 - z179 * z179);
    const Scalar z1782 = n2 * (z112 * z1779 + z113 * z1780 - z114 * z1781 - z183 * z183 - z185 * z185 - z186 * z186);
    const Scalar z1763 = c_yaw * z1761;
    const Scalar z1768 = z49 * z1761 + s_roll * z1756;
    const Scalar z1769 = s_roll * z1754 - z48 * z1761;
    const Scalar z1785 = z252 * z1756 - z254 * z1761;
    const Scalar z1786 = z252 * z1754 + z253 * z1761;
    const Scalar z1791 = z179 * z271 + z184 * z272 - z111 * z1790 + z109 * z1789;
    const Scalar z1793 = z109 * z1792 + z110 * z1790 - z179 * z270 - z182 * z272;
    const Scalar z1773 = z31 * z32 * c_steer;
    const Scalar z1783 = n0_5 * (z187 * z188 / (z116 * z116) + z1782 / z116);
    const Scalar z1772 = -c_steer * (n1 - z31 * z31);
    const Scalar z1774 = n0_35 * z1773 + n0_08 * z1772;
    const Scalar z1775 = -c_steer * (n1 - z32 * z32);
    const Scalar z1776 = n0_08 * z1773 + n0_35 * z1775;
    const Scalar z1794 = l_lambda_front_rolls_x * z1791 - l_lambda_front_rolls_y * z1793;
    const Scalar z1795 = z1542 - z1794;
    const Scalar z1808 = s_pitch * z1807 - c_pitch * z1805;
    const Scalar z1777 = s_pitch * z1774 - c_pitch * z1776;
    const Scalar z1811 = n0_5603 * (a_roll + z422) + z1808;  // moment on frame.2, x
    const Scalar z1809 = s_pitch * z1805 + c_pitch * z1807;
    const Scalar z1812 = z1809 - n0_5603 * z1810;  // moment on frame.2, z
    const Scalar z1778 = s_roll * z93 + c_roll * z1777;
    const Scalar z1784 = z1778 - n0_35 * z1783;
    const Scalar z1770 = l_lambda_front_touches * z1767 + l_lambda_front_rolls_y * z1769 + l_lambda_front_rolls_x
        * z1768;
    const Scalar z1771 = z1492 + z1770;
    const Scalar z1814 = s_roll * z1806 + c_roll * z1812;
    const Scalar z1787 = l_lambda_front_rolls_y * z1786 - l_lambda_front_touches * z1784 + l_lambda_front_rolls_x
        * z1785;
    const Scalar z1757 = l_lambda_front_rolls_y * z1754 + l_lambda_front_rolls_x * z1756;
    const Scalar z1758 = z1501 + z1757;
    const Scalar z1878 = v_yaw * z1590 - v_roll * z244 + v_pitch * z1597 + v_steer * z1602 - v_front * z1609;
    const Scalar z1788 = z1456 + z1787;
    const Scalar z1880 = z308 - z117 * z142 + z112 * z281;
    const Scalar z1882 = z314 + z1880;
    const Scalar z1884 = z308 - z1880;
    const Scalar z1881 = z63 * z242 - z60 * z1590 + s_roll * z1880 - z48 * z285;
    const Scalar z1883 = z289 * z1601 - z266 * z317 + z252 * z1882 + z253 * z301;
    const Scalar z1879 = v_yaw * z1590 - v_roll * z244 + v_pitch * z1597 + v_steer * z1602 - v_front * z1609 + z283;
    const Scalar z1764 = l_lambda_front_rolls_x * z1762 + l_lambda_front_rolls_y * z1763 - l_lambda_front_touches
        * z1760;
    const Scalar z1885 = z138 * z1608 - z141 * z272 + z109 * z1884 - z110 * z304;
    const Scalar z1765 = z1496 - z1764;
    const Scalar z1886 = v_yaw * z1880 + v_pitch * z1881 - v_steer * z1883 - v_front * z1885 + v_roll * z312;
    const Scalar z1910 = s_yaw * z60 + s_roll * z61;
    const Scalar z1912 = c_yaw * z60 - s_roll * z65;
    const Scalar z1887 = a_yaw * z1590 - a_roll * z244 + a_pitch * z1597 + a_steer * z1602 - a_front * z1609 - z1886;
    const Scalar z1941 = n2 * (z108 * z138 - z109 * z139);
    const Scalar z1911 = z48 * z62 + z60 * z72 + s_roll * z1910 + c_roll * z63;
    const Scalar z1937 = s_yaw * z138 - z61 * z109;
    const Scalar z1913 = z49 * z62 + z60 * z74 + s_roll * z1912 + c_roll * z66;
    const Scalar z1939 = z65 * z109 + c_yaw * z138;
    const Scalar z1914 = n2 * (s_roll * z62 - c_roll * z60);
    const Scalar z1938 = z110 * z139 + z138 * z149 + z109 * z1937 + z108 * z141;
    const Scalar z1940 = z111 * z139 - z138 * z151 - z109 * z1939 + z108 * z143;
    const Scalar z1942 = n2 * (z114 * z1941 - z145 * z153 + z144 * z152 + z112 * z1938 + z113 * z1940 + z142 * z150);
    const Scalar z1920 = v_roll * s_roll + z62;
    const Scalar z1915 = n2 * (z50 * z1911 + z51 * z1913 - z52 * z1914 - z64 * z73 - z67 * z75 - z68 * z76);
    const Scalar z1918 = v_roll * c_roll + z60;
    const Scalar z1932 = n4 * z60 * z62 + n2 * (s_roll * z80 + c_roll * z83);
    const Scalar z1946 = z107 * z1920 - c_steer * z1918 + n2 * (s_roll * z127 - c_roll * z137);
    const Scalar z1943 = n0_5 * (z146 * z155 / (z116 * z116) - z1942 / z116);
    const Scalar z1928 = s_yaw * z83 + s_roll * z81 - n2 * z60 * z61;
    const Scalar z1929 = z72 * z83 - z48 * z80 - n2 * (z60 * z1910 - z62 * z63) + s_roll * z1928 - c_roll * z82;
    const Scalar z1947 = s_yaw * z1946 - n2 * z61 * z109;
    const Scalar z1916 = n0_5 * (z69 * z78 / (z54 * z54) + z1915 / z54);
    const Scalar z1919 = n2 * s_roll * z61 + s_yaw * z1918;
    const Scalar z1921 = z48 * z1920 + s_roll * z1919 + n2 * (z60 * z72 + c_roll * z63);
    const Scalar z1944 = z278 - n0_35 * z1943;
    const Scalar z1930 = c_yaw * z83 + s_roll * z85 + n2 * z60 * z65;
    const Scalar z1931 = z74 * z83 - z49 * z80 - n2 * (z60 * z1912 - z62 * z66) + s_roll * z1930 - c_roll * z86;
    const Scalar z1917 = n0_3 * z1916;
    const Scalar z1922 = c_yaw * z1918 - n2 * s_roll * z65;
    const Scalar z1933 = n4 * (z64 * z1911 + z67 * z1913 - z68 * z1914) + n2 * (z52 * z1932 - z76 * z88 + z73 * z84
        + z75 * z87 + z50 * z1929 + z51 * z1931);
    const Scalar z1934 = n0_5 * (z70 * z1915 / (z54 * z54) + z78 * z89 / (z54 * z54) - z1933 / z54 + z69 * z1916 / (z54
        * z54)) + z69 * z70 * z78 / (z54 * z54 * z54);
    const Scalar z1923 = z49 * z1920 + n2 * (z60 * z74 + c_roll * z66) + s_roll * z1922;
    const Scalar z1924 = n2 * s_roll * z1920 - n4 * c_roll * z60;
    const Scalar z1925 = n2 * (z50 * z1921 + z51 * z1923 - z52 * z1924) - n4 * (z68 * z76 + z64 * z73 + z67 * z75);
    const Scalar z1935 = n0_3 * z1934;
    const Scalar z1888 = v_yaw * z1587 - v_roll * z219 + z1596 * (v_pitch + v_rear);
    const Scalar z1936 = a_roll * z1628 + z1935;
    const Scalar z1948 = c_steer * z1920 + z107 * z1918 + n2 * (c_roll * z127 + s_roll * z137);
    const Scalar z1926 = n0_5 * (z69 * z78 / (z54 * z54) + z70 * z77 / (z54 * z54) + z1925 / z54);
    const Scalar z1945 = n2 * (c_roll * z125 + s_roll * z134) - z93 * z1920 - z98 * z1918;
    const Scalar z1894 = v_yaw * z1589 + v_roll * z243 + v_pitch * z1598 + v_steer * z1604 - v_front * z1611;
    const Scalar z1904 = v_yaw * z1588 + v_roll * z220 + z1595 * (v_pitch + v_rear);
    const Scalar z1927 = n0_3 * z1926;
    const Scalar z1896 = z113 * z281 - z279 - z117 * z144;
    const Scalar z1898 = z293 - z1896;
    const Scalar z1900 = z279 + z1896;
    const Scalar z1890 = z51 * z226 - z55 * z67;
    const Scalar z1897 = z60 * z1589 - z66 * z242 + s_roll * z1896 + z49 * z285;
    const Scalar z1899 = z266 * z298 + z289 * z1603 + z252 * z1898 + z254 * z301;
    const Scalar z1901 = z138 * z1610 + z143 * z272 + z109 * z1900 + z111 * z304;
    const Scalar z1902 = v_yaw * z1896 + v_roll * z286 + v_pitch * z1897 + v_steer * z1899 + v_front * z1901;
    const Scalar z1889 = z1596 * (v_pitch + v_rear) + v_yaw * z1587 - v_roll * z219 - z236;
    const Scalar z1950 = n2 * z65 * z109 + c_yaw * z1946;
    const Scalar z1949 = z110 * z1948 + z109 * z1947 + n2 * (z138 * z149 + z108 * z141);
    const Scalar z1903 = a_yaw * z1589 + a_roll * z243 + a_pitch * z1598 + a_steer * z1604 - a_front * z1611 + z1902;
    const Scalar z1895 = v_yaw * z1589 + v_roll * z243 + v_pitch * z1598 + v_steer * z1604 - v_front * z1611 + z311;
    const Scalar z1906 = z50 * z226 - z55 * z64;
    const Scalar z1891 = z60 * z1587 + z66 * z218 + s_roll * z1890 - z49 * z230;
    const Scalar z1892 = v_yaw * z1890 - v_roll * z231 + z1891 * (v_pitch + v_rear);
    const Scalar z1951 = z111 * z1948 - z109 * z1950 + n2 * (z108 * z143 - z138 * z151);
    const Scalar z1893 = z1596 * (a_pitch + a_rear) + a_yaw * z1587 - a_roll * z219 + z1892;
    const Scalar z1956 = z83 * z98 - z80 * z93 - c_roll * z193 + n2 * (z60 * z134 - z62 * z125) + s_roll * z202;
    const Scalar z1952 = n4 * z108 * z138 - n2 * z109 * z1948;
    const Scalar z1953 = n2 * (z114 * z1952 + z112 * z1949 + z113 * z1951) + n4 * (z144 * z152 - z145 * z153 + z142
        * z150);
    const Scalar z1961 = n4 * z138 * z139 + n2 * (z108 * z208 + z109 * z205);
    const Scalar z1957 = z81 * z109 + n2 * z61 * z138 + s_yaw * z208;
    const Scalar z1958 = z110 * z205 - z149 * z208 + n2 * (z138 * z1937 - z139 * z141) + z108 * z207 - z109 * z1957;
    const Scalar z1954 = n0_5 * (z146 * z155 / (z116 * z116) + z147 * z154 / (z116 * z116) - z1953 / z116);
    const Scalar z1959 = z85 * z109 - n2 * z65 * z138 + c_yaw * z208;
    const Scalar z1960 = z111 * z205 - n2 * (z138 * z1939 + z139 * z143) + z151 * z208 + z108 * z210 + z109 * z1959;
    const Scalar z1962 = n2 * (z153 * z212 - z114 * z1961 + z152 * z211 + z150 * z209 + z112 * z1958 + z113 * z1960)
        - n4 * (z145 * z1941 + z144 * z1940 + z142 * z1938);
    const Scalar z1955 = z1945 - n0_35 * z1954;
    const Scalar z1907 = z60 * z1588 + z63 * z218 + s_roll * z1906 - z48 * z230;
    const Scalar z1963 = n0_5 * (z155 * z213 / (z116 * z116) - z147 * z1942 / (z116 * z116) - z1962 / z116 + z146
        * z1943 / (z116 * z116)) + z146 * z147 * z155 / (z116 * z116 * z116);
    const Scalar z1908 = v_yaw * z1906 + v_roll * z237 + z1907 * (v_pitch + v_rear);
    const Scalar z1909 = z1595 * (a_pitch + a_rear) + a_yaw * z1588 + a_roll * z220 + z1908;
    const Scalar z1905 = z1595 * (v_pitch + v_rear) + v_yaw * z1588 + v_roll * z220 - z228;
    const Scalar z1986 = n0_6 * z70 * z78 / (z54 * z54 * z54) + n0_3 * z1916 / (z54 * z54);
    const Scalar z1988 = z55 * z1914 - z68 * z1613 - z76 * z226 + z52 * z1986;
    const Scalar z1987 = z50 * z1986 - z55 * z1911 - z64 * z1613 - z73 * z226;
    const Scalar z2009 = z51 * z1986 - z55 * z1913 - z67 * z1613 - z75 * z226;
    const Scalar z1968 = n0_7 * z147 * z155 / (z116 * z116 * z116) + n0_35 * z1943 / (z116 * z116);
    const Scalar z1971 = z278 + z117 * z1941 - z145 * z1617 + z153 * z281 + z114 * z1968;
    const Scalar z1964 = z1956 + n0_35 * z1963;
    const Scalar z1965 = a_roll * z1636 + a_pitch * z1653 - a_steer * z1668 - z1964;
    const Scalar z1976 = z292 + z1971;
    const Scalar z1980 = z278 - z1971;
    const Scalar z1990 = z62 * z216 + z218 * z1910 - c_roll * z236 + z60 * z1614 - z63 * z1637 + z72 * z230 + z48
        * z1988 + s_roll * z1987;
    const Scalar z2011 = z218 * z1912 - z62 * z217 + c_roll * z228 + z60 * z1615 - z66 * z1637 + z74 * z230 + z49
        * z1988 + s_roll * z2009;
    const Scalar z1985 = z237 + v_yaw * z1614 - v_roll * z1639 + z1655 * (v_pitch + v_rear);
    const Scalar z1967 = v_roll * z1641 - z286 + v_yaw * z1620 + v_pitch * z1656 - v_steer * z1673 - v_front * z1684;
    const Scalar z1994 = v_yaw * z1618 + v_roll * z1642 + v_pitch * z1657 - v_steer * z1677 - v_front * z1686 - z312;
    const Scalar z2008 = v_yaw * z1615 - z231 + v_roll * z1638 + z1654 * (v_pitch + v_rear);
    const Scalar z2017 = c_roll * z140 - z62 * z106;
    const Scalar z2015 = z60 * z106 + s_roll * z140;
    const Scalar z2019 = z61 * z107 - z65 * z159 + s_yaw * z137 + c_yaw * z2015;
    const Scalar z2016 = z65 * z107 + z61 * z159 - c_yaw * z137 + s_yaw * z2015;
    const Scalar z2021 = n2 * (z109 * z2017 - z138 * z158);
    const Scalar z2018 = z110 * z2017 - z138 * z160 + z109 * z2016 + z141 * z158;
    const Scalar z2020 = z109 * z2019 - z111 * z2017 - z138 * z162 - z143 * z158;
    const Scalar z2025 = v_pitch * s_pitch + z131;
    const Scalar z2014 = z62 * z97 + c_roll * z277;
    const Scalar z1984 = v_yaw * z1614 - v_roll * z1639 + z1655 * (v_pitch + v_rear);
    const Scalar z2022 = n2 * (z142 * z161 - z145 * z164 - z114 * z2021 - z144 * z163 + z112 * z2018 - z113 * z2020);
    const Scalar z1966 = v_roll * z1641 + v_yaw * z1620 + v_pitch * z1656 - v_steer * z1673 - v_front * z1684;
    const Scalar z2026 = v_pitch * c_pitch + z126;
    const Scalar z2023 = n0_5 * (z146 * z166 / (z116 * z116) - z2022 / z116);
    const Scalar z1969 = c_yaw * z135 - z65 * z100;
    const Scalar z1995 = z61 * z100 + s_yaw * z135;
    const Scalar z1970 = z1969 + z117 * z1940 - z144 * z1617 - z152 * z281 + z113 * z1968;
    const Scalar z1996 = z117 * z1938 - z1995 - z142 * z1617 - z150 * z281 + z112 * z1968;
    const Scalar z2029 = z39 * z2025 + z41 * z2026 + n2 * (s_pitch * z124 - c_pitch * z123);
    const Scalar z2031 = z39 * z2026 - z41 * z2025 + n2 * (s_pitch * z123 + c_pitch * z124);
    const Scalar z1973 = z62 * z241 - z242 * z1912 + z66 * z1640 - c_roll * z283 - z60 * z1620 - z74 * z285 + s_roll
        * z1970 + z49 * z1971;
    const Scalar z1998 = z62 * z240 + z242 * z1910 - z60 * z1618 - z63 * z1640 - c_roll * z311 + z72 * z285 + s_roll
        * z1996 - z48 * z1971;
    const Scalar z2027 = z95 * z2025 - z96 * z2026 + n2 * (s_pitch * z133 + c_pitch * z130);
    const Scalar z1979 = z1969 - z1970;
    const Scalar z1981 = z139 * z271 + z272 * z1939 + z108 * z303 + z143 * z1683 + z138 * z1682 - z151 * z304 - z109
        * z1979 - z111 * z1980;
    const Scalar z2003 = z1995 + z1996;
    const Scalar z2004 = z139 * z270 - z272 * z1937 + z108 * z319 - z138 * z1685 + z141 * z1683 + z149 * z304 + z109
        * z2003 - z110 * z1980;
    const Scalar z2028 = n2 * z62 * z97 + c_roll * z2027;
    const Scalar z2030 = n2 * z60 * z106 + s_roll * z2029;
    const Scalar z2024 = z2014 + n0_35 * z2023;
    const Scalar z1977 = c_yaw * z289 - z65 * z252;
    const Scalar z1993 = v_yaw * z1618 + v_roll * z1642 + v_pitch * z1657 - v_steer * z1677 - v_front * z1686;
    const Scalar z2001 = z61 * z252 + s_yaw * z289;
    const Scalar z2007 = v_yaw * z1615 + v_roll * z1638 + z1654 * (v_pitch + v_rear);
    const Scalar z1974 = c_yaw * z299 - z65 * z258;
    const Scalar z1999 = z61 * z258 + s_yaw * z299;
    const Scalar z1975 = z1970 - z1974;
    const Scalar z2000 = z1996 + z1999;
    const Scalar z1972 = s_yaw * z1971 - z61 * z1640;
    const Scalar z1978 = z265 * z297 - z266 * z1977 + z251 * z295 - z298 * z1672 + z289 * z1670 + z301 * z1671 - z252
        * z1975 + z254 * z1976;
    const Scalar z2002 = z264 * z297 + z266 * z2001 + z251 * z316 + z289 * z1675 - z317 * z1672 - z301 * z1676 - z252
        * z2000 - z253 * z1976;
    const Scalar z2041 = z95 * z201 + z96 * z200 + s_pitch * z199 + c_pitch * z197 + n2 * (z126 * z133 - z130 * z131);
    const Scalar z1982 = v_yaw * z1970 + v_roll * z1972 + v_pitch * z1973 + v_steer * z1978 + v_front * z1981;
    const Scalar z1983 = a_yaw * z1620 + a_roll * z1641 + a_pitch * z1656 - a_steer * z1673 - a_front * z1684 - z1982;
    const Scalar z1997 = z65 * z1640 + c_yaw * z1971;
    const Scalar z2005 = v_yaw * z1996 + v_roll * z1997 + v_pitch * z1998 + v_steer * z2002 + v_front * z2004;
    const Scalar z2033 = c_roll * z2029 - n2 * z62 * z106;
    const Scalar z2042 = z80 * z97 - n2 * z62 * z277 + c_roll * z2041;
    const Scalar z2045 = z80 * z106 + n2 * z62 * z140 + c_roll * z206;
    const Scalar z2043 = z83 * z106 - n2 * z60 * z140 + s_roll * z206;
    const Scalar z2047 = z81 * z107 + z85 * z159 - n2 * (z61 * z137 - z65 * z2015) + s_yaw * z204 + c_yaw * z2043;
    const Scalar z2006 = a_yaw * z1618 + a_roll * z1642 + a_pitch * z1657 - a_steer * z1677 - a_front * z1686 - z2005;
    const Scalar z2044 = z81 * z159 - z85 * z107 - n2 * (z65 * z137 + z61 * z2015) - c_yaw * z204 + s_yaw * z2043;
    const Scalar z2048 = n2 * (z138 * z2019 + z143 * z2017) - z111 * z2045 + z162 * z208 + z109 * z2047 - z158 * z210;
    const Scalar z2046 = z110 * z2045 + z160 * z208 + n2 * (z138 * z2016 - z141 * z2017) + z109 * z2044 + z158 * z207;
    const Scalar z2032 = n2 * (z65 * z107 + z61 * z159) - c_yaw * z2031 + s_yaw * z2030;
    const Scalar z2035 = n2 * (z61 * z107 - z65 * z159) + s_yaw * z2031 + c_yaw * z2030;
    const Scalar z2034 = z110 * z2033 + z109 * z2032 - n2 * (z138 * z160 - z141 * z158);
    const Scalar z2036 = z109 * z2035 - z111 * z2033 - n2 * (z138 * z162 + z143 * z158);
    const Scalar z2037 = n2 * z109 * z2033 - n4 * z138 * z158;
    const Scalar z1989 = c_yaw * z1988 - z65 * z1637;
    const Scalar z2038 = n4 * (z142 * z161 - z144 * z163 - z145 * z164) + n2 * (z112 * z2034 - z113 * z2036 - z114
        * z2037);
    const Scalar z1991 = v_yaw * z1987 - v_roll * z1989 + z1990 * (v_pitch + v_rear);
    const Scalar z1992 = z1655 * (a_pitch + a_rear) + a_yaw * z1614 - a_roll * z1639 + z1991;
    const Scalar z2057 = s_roll * z277 - z60 * z97;
    const Scalar z2039 = n0_5 * (z146 * z166 / (z116 * z116) + z147 * z165 / (z116 * z116) - z2038 / z116);
    const Scalar z2010 = z61 * z1637 + s_yaw * z1988;
    const Scalar z2012 = v_roll * z2010 + v_yaw * z2009 + z2011 * (v_pitch + v_rear);
    const Scalar z2049 = n4 * z138 * z2017 + n2 * (z109 * z2045 + z158 * z208);
    const Scalar z2050 = n2 * (z164 * z212 - z114 * z2049 - z163 * z211 + z161 * z209 - z113 * z2048 + z112 * z2046)
        - n4 * (z142 * z2018 - z144 * z2020 - z145 * z2021);
    const Scalar z2013 = z1654 * (a_pitch + a_rear) + a_yaw * z1615 + a_roll * z1638 + z2012;
    const Scalar z2040 = z2028 + n0_35 * z2039;
    const Scalar z2055 = v_yaw * z1693 + v_roll * z1699 + v_pitch * z1714 - v_steer * z1738 - v_front * z1747 + z287;
    const Scalar z2078 = v_yaw * z1691 + v_roll * z1700 + v_pitch * z1715 - v_steer * z1742 - v_front * z1749 + z313;
    const Scalar z2092 = z31 * z127;
    const Scalar z2091 = z32 * z127;
    const Scalar z2101 = z131 * z169 - z126 * z168 + s_pitch * z2091 + c_pitch * z2092;
    const Scalar z2051 = n0_5 * (z166 * z213 / (z116 * z116) - z147 * z2022 / (z116 * z116) - z2050 / z116 + z146
        * z2023 / (z116 * z116)) + z146 * z147 * z166 / (z116 * z116 * z116);
    const Scalar z2056 = n0_7 * z147 * z166 / (z116 * z116 * z116) + n0_35 * z2023 / (z116 * z116);
    const Scalar z2060 = z164 * z281 - z2014 - z117 * z2021 - z145 * z1690 + z114 * z2056;
    const Scalar z2073 = z2014 + z2060;
    const Scalar z2103 = s_pitch * z2092 - c_pitch * z2091 - z126 * z169 - z131 * z168;
    const Scalar z2052 = z2042 - n0_35 * z2051;
    const Scalar z2105 = s_roll * z122 + s_steer * z60 + z62 * z178 + c_roll * z2101;
    const Scalar z2053 = a_roll * z1697 + a_pitch * z1713 + a_steer * z1729 + z2052;
    const Scalar z2113 = v_steer * s_steer + z127;
    const Scalar z2102 = s_steer * z62 - c_roll * z122 - z60 * z178 + s_roll * z2101;
    const Scalar z2104 = z65 * z181 - z61 * z180 + c_yaw * z2103 + s_yaw * z2102;
    const Scalar z2107 = s_yaw * z2103 - c_yaw * z2102 - z61 * z181 - z65 * z180;
    const Scalar z2106 = z110 * z2105 + z138 * z182 + z109 * z2104 + z141 * z179;
    const Scalar z2109 = n2 * (z109 * z2105 - z138 * z179);
    const Scalar z2108 = z111 * z2105 + z138 * z184 + z143 * z179 + z109 * z2107;
    const Scalar z2110 = n2 * (z112 * z2106 + z113 * z2108 - z114 * z2109 - z142 * z183 - z144 * z185 - z145 * z186);
    const Scalar z2095 = z31 * z32 * z122;
    const Scalar z2094 = -z122 * (n1 - z31 * z31);
    const Scalar z2096 = n0_35 * z2095 + n0_08 * z2094;
    const Scalar z2093 = n0_08 * z2091 - n0_35 * z2092;
    const Scalar z2097 = -z122 * (n1 - z32 * z32);
    const Scalar z2098 = n0_08 * z2095 + n0_35 * z2097;
    const Scalar z2069 = s_roll * z296 - z60 * z249;
    const Scalar z2068 = z62 * z249 + c_roll * z296;
    const Scalar z2099 = z126 * z173 + z131 * z175 + s_pitch * z2096 - c_pitch * z2098;
    const Scalar z2085 = z65 * z250 - c_yaw * z288 - z61 * z1734 + s_yaw * z2069;
    const Scalar z2070 = z61 * z250 + s_yaw * z288 + z65 * z1734 + c_yaw * z2069;
    const Scalar z2111 = n0_5 * (z146 * z188 / (z116 * z116) + z2110 / z116);
    const Scalar z2100 = s_roll * z2093 - z60 * z170 - z62 * z176 + c_roll * z2099;
    const Scalar z2079 = z65 * z98 - z61 * z1645 + c_yaw * z134 + s_yaw * z2057;
    const Scalar z2058 = s_yaw * z134 - z61 * z98 - z65 * z1645 - c_yaw * z2057;
    const Scalar z2080 = z2079 + z117 * z2018 - z142 * z1690 - z161 * z281 + z112 * z2056;
    const Scalar z2059 = z2058 - z117 * z2020 - z144 * z1690 + z163 * z281 + z113 * z2056;
    const Scalar z2112 = z2100 - n0_35 * z2111;
    const Scalar z2054 = v_yaw * z1693 + v_roll * z1699 + v_pitch * z1714 - v_steer * z1738 - v_front * z1747;
    const Scalar z2087 = z2079 - z2080;
    const Scalar z2114 = z32 * z2113;
    const Scalar z2115 = z31 * z2113;
    const Scalar z2117 = v_steer * c_steer + z122;
    const Scalar z2088 = z272 * z2016 - z270 * z2017 + z138 * z1748 + z141 * z1746 - z158 * z319 + z160 * z304 + z109
        * z2087 - z110 * z2073;
    const Scalar z2072 = z2058 - z2059;
    const Scalar z2074 = z138 * z1745 - z271 * z2017 - z272 * z2019 + z143 * z1746 - z158 * z303 - z162 * z304 + z109
        * z2072 - z111 * z2073;
    const Scalar z2077 = v_yaw * z1691 + v_roll * z1700 + v_pitch * z1715 - v_steer * z1742 - v_front * z1749;
    const Scalar z2063 = z60 * z255 + s_roll * z290;
    const Scalar z2066 = c_roll * z290 - z62 * z255;
    const Scalar z2067 = z2060 - z2066;
    const Scalar z2119 = z31 * z32 * z2117;
    const Scalar z2083 = c_yaw * z291 - z65 * z256 + z61 * z1731 + s_yaw * z2063;
    const Scalar z2064 = z61 * z256 + s_yaw * z291 + z65 * z1731 - c_yaw * z2063;
    const Scalar z2084 = z2080 + z2083;
    const Scalar z2086 = z266 * z2085 - z264 * z2068 - z289 * z1740 + z316 * z1730 - z317 * z1737 + z301 * z1741 + z252
        * z2084 + z253 * z2067;
    const Scalar z2065 = z2059 + z2064;
    const Scalar z2071 = z295 * z1730 - z265 * z2068 - z266 * z2070 - z289 * z1733 - z298 * z1737 + z301 * z1735 + z252
        * z2065 - z254 * z2067;
    const Scalar z2118 = -z2117 * (n1 - z31 * z31);
    const Scalar z2120 = n0_35 * z2119 + n0_08 * z2118;
    const Scalar z2061 = s_yaw * z2060 - z61 * z1698;
    const Scalar z2121 = -z2117 * (n1 - z32 * z32);
    const Scalar z2116 = n0_08 * z2114 - n0_35 * z2115;
    const Scalar z2081 = z65 * z1698 + c_yaw * z2060;
    const Scalar z2062 = z66 * z1698 - z60 * z1693 + s_roll * z2059 + z49 * z2060;
    const Scalar z2075 = v_yaw * z2059 + v_roll * z2061 + v_pitch * z2062 - v_steer * z2071 - v_front * z2074;
    const Scalar z2122 = n0_08 * z2119 + n0_35 * z2121;
    const Scalar z2123 = n2 * (z126 * z173 + z131 * z175) + s_pitch * z2120 - c_pitch * z2122;
    const Scalar z2124 = s_roll * z2116 - n2 * (z60 * z170 + z62 * z176) + c_roll * z2123;
    const Scalar z2076 = a_yaw * z1693 + a_roll * z1699 + a_pitch * z1714 - a_steer * z1738 - a_front * z1747 - z2075;
    const Scalar z2082 = s_roll * z2080 - z48 * z2060 - z60 * z1691 - z63 * z1698;
    const Scalar z2089 = v_yaw * z2080 + v_roll * z2081 - v_steer * z2086 - v_front * z2088 + v_pitch * z2082;
    const Scalar z2090 = a_yaw * z1691 + a_roll * z1700 + a_pitch * z1715 - a_steer * z1742 - a_front * z1749 - z2089;
    const Scalar z2161 = v_roll * z1762 - z302 + v_yaw * z1756 + v_pitch * z1768 - v_steer * z1785 + v_front * z1791;
    const Scalar z2177 = v_yaw * z1754 + v_roll * z1763 + v_pitch * z1769 - v_steer * z1786 - z318 - v_front * z1793;
    const Scalar z2137 = z32 * z194;
    const Scalar z2138 = z31 * z194;
    const Scalar z2147 = z168 * z200 + z169 * z201 + s_pitch * z2137 + c_pitch * z2138 + n2 * (z126 * z2091 - z131
        * z2092);
    const Scalar z2149 = z169 * z200 - z168 * z201 + s_pitch * z2138 - c_pitch * z2137 + n2 * (z126 * z2092 + z131
        * z2091);
    const Scalar z2139 = n0_08 * z2137 - n0_35 * z2138;
    const Scalar z2151 = s_roll * z190 + s_steer * z83 - z80 * z178 - n2 * (z60 * z122 - z62 * z2101) - c_roll * z2147;
    const Scalar z2148 = c_roll * z190 + s_steer * z80 + z83 * z178 + n2 * (z62 * z122 + z60 * z2101) + s_roll * z2147;
    const Scalar z2125 = s_pitch * z2114 - n2 * (z126 * z168 - z131 * z169) + c_pitch * z2115;
    const Scalar z2127 = s_pitch * z2115 - n2 * (z126 * z169 + z131 * z168) - c_pitch * z2114;
    const Scalar z2126 = n2 * (s_steer * z62 - z60 * z178) - c_roll * z2117 + s_roll * z2125;
    const Scalar z2129 = n2 * (s_steer * z60 + z62 * z178) + s_roll * z2117 + c_roll * z2125;
    const Scalar z2155 = n4 * z138 * z2105 + n2 * (z109 * z2151 + z179 * z208);
    const Scalar z2153 = z81 * z181 - z85 * z180 + n2 * (z61 * z2103 + z65 * z2102) + s_yaw * z2149 - c_yaw * z2148;
    const Scalar z2150 = z85 * z181 + z81 * z180 + n2 * (z61 * z2102 - z65 * z2103) + c_yaw * z2149 + s_yaw * z2148;
    const Scalar z2154 = z184 * z208 - z111 * z2151 + z109 * z2153 - z179 * z210 - n2 * (z138 * z2107 - z143 * z2105);
    const Scalar z2152 = z182 * z208 - z110 * z2151 - n2 * (z138 * z2104 - z141 * z2105) + z109 * z2150 - z179 * z207;
    const Scalar z2156 = n4 * (z142 * z2106 + z144 * z2108 - z145 * z2109) + n2 * (z114 * z2155 - z186 * z212 + z185
        * z211 + z183 * z209 + z113 * z2154 + z112 * z2152);
    const Scalar z2157 = n0_5 * (z147 * z2110 / (z116 * z116) + z188 * z213 / (z116 * z116) - z2156 / z116 + z146
        * z2111 / (z116 * z116)) + z146 * z147 * z188 / (z116 * z116 * z116);
    const Scalar z2162 = n0_7 * z147 * z188 / (z116 * z116 * z116) + n0_35 * z2111 / (z116 * z116);
    const Scalar z2167 = z2100 + z117 * z2109 - z145 * z1753 - z186 * z281 + z114 * z2162;
    const Scalar z2172 = z2100 - z2167;
    const Scalar z2128 = s_yaw * z2126 - n2 * (z61 * z180 - z65 * z181) + c_yaw * z2127;
    const Scalar z2131 = s_yaw * z2127 - n2 * (z61 * z181 + z65 * z180) - c_yaw * z2126;
    const Scalar z2130 = z110 * z2129 + z109 * z2128 + n2 * (z138 * z182 + z141 * z179);
    const Scalar z2132 = z111 * z2129 + n2 * (z138 * z184 + z143 * z179) + z109 * z2131;
    const Scalar z2133 = n2 * z109 * z2129 - n4 * z138 * z179;
    const Scalar z2134 = n2 * (z112 * z2130 + z113 * z2132 - z114 * z2133) - n4 * (z145 * z186 + z144 * z185 + z142
        * z183);
    const Scalar z2192 = n1 / z273;
    const Scalar z2193 = z274 * z2192;
    const Scalar z2187 = n1 / z167;
    const Scalar z2163 = z126 * z175 - z131 * z173 + s_pitch * z2098 + c_pitch * z2096;
    const Scalar z2194 = z240 - z241 * z2193;
    const Scalar z2135 = n0_5 * (z146 * z188 / (z116 * z116) + z147 * z187 / (z116 * z116) + z2134 / z116);
    const Scalar z2195 = z216 - z2194;
    const Scalar z2164 = z60 * z176 - z62 * z170 - c_roll * z2093 + s_roll * z2099;
    const Scalar z2189 = z223 * z2187;
    const Scalar z2165 = z61 * z1718 - z65 * z1660 + s_yaw * z2163 + c_yaw * z2164;
    const Scalar z2178 = z65 * z1718 + z61 * z1660 - c_yaw * z2163 + s_yaw * z2164;
    const Scalar z2166 = z2165 - z117 * z2108 - z144 * z1753 - z185 * z281 + z113 * z2162;
    const Scalar z2179 = z112 * z2162 - z2178 - z117 * z2106 - z142 * z1753 - z183 * z281;
    const Scalar z2136 = z2124 - n0_35 * z2135;
    const Scalar z2180 = z65 * z1761 + c_yaw * z2167;
    const Scalar z2168 = s_yaw * z2167 - z61 * z1761;
    const Scalar z2196 = n1 / z2195;
    const Scalar z2169 = z66 * z1761 - z60 * z1756 + s_roll * z2166 + z49 * z2167;
    const Scalar z2182 = z253 * z2167 - z289 * z1754 - z317 * z1761 + z252 * z2179;
    const Scalar z2170 = z252 * z2166 - z254 * z2167 - z289 * z1756 - z298 * z1761;
    const Scalar z2181 = s_roll * z2179 - z48 * z2167 - z60 * z1754 - z63 * z1761;
    const Scalar z2171 = z2165 - z2166;
    const Scalar z2173 = z271 * z2105 - z272 * z2107 - z143 * z1790 + z179 * z303 - z138 * z1789 + z184 * z304 + z109
        * z2171 + z111 * z2172;
    const Scalar z2183 = z2178 + z2179;
    const Scalar z2184 = z272 * z2104 - z270 * z2105 - z138 * z1792 + z141 * z1790 - z179 * z319 - z182 * z304 - z110
        * z2172 + z109 * z2183;
    const Scalar z2174 = v_yaw * z2166 + v_roll * z2168 + v_pitch * z2169 - v_steer * z2170 - v_front * z2173;
    const Scalar z2185 = v_roll * z2180 + v_yaw * z2179 - v_steer * z2182 + v_front * z2184 + v_pitch * z2181;
    const Scalar z2175 = a_yaw * z1756 + a_roll * z1762 + a_pitch * z1768 - a_steer * z1785 + a_front * z1791 - z2174;
    const Scalar z2160 = v_roll * z1762 + v_yaw * z1756 + v_pitch * z1768 - v_steer * z1785 + v_front * z1791;
    const Scalar z2186 = a_yaw * z1754 + a_roll * z1763 + a_pitch * z1769 - a_steer * z1786 - a_front * z1793 - z2185;
    const Scalar z2176 = v_yaw * z1754 + v_roll * z1763 + v_pitch * z1769 - v_steer * z1786 - v_front * z1793;
    const Scalar z2197 = z217 * z2196;
    const Scalar z2198 = n1 - z2193 * z2197;
    const Scalar z2190 = z247 * z2187;
    const Scalar z2141 = z31 * z32 * z190;
    const Scalar z2188 = z246 * z2187;
    const Scalar z2140 = -z190 * (n1 - z31 * z31);
    const Scalar z2142 = n0_35 * z2141 + n0_08 * z2140;
    const Scalar z2143 = -z190 * (n1 - z32 * z32);
    const Scalar z2144 = n0_08 * z2141 + n0_35 * z2143;
    const Scalar z2200 = z167 * z167;
    const Scalar z2203 = z273 * z273;
    const Scalar z2191 = z222 * z2187;
    const Scalar z2199 = n1 / z2198;
    const Scalar z2201 = n1_over_94 + z156 * z156 / z542 + z167 * z167 / z518 + z189 * z189 / z587;
    const Scalar z2145 = z173 * z200 - z175 * z201 + s_pitch * z2142 - c_pitch * z2144 - n2 * (z126 * z2096 + z131
        * z2098);
    const Scalar z2146 = z83 * z170 + s_roll * z2139 - z80 * z176 + n2 * (z60 * z2093 - z62 * z2099) - c_roll * z2145;
    const Scalar z2158 = z2146 + n0_35 * z2157;
    const Scalar z2202 = z518 * z2201;
    const Scalar z2206 = z2195 * z2195;
    const Scalar z2209 = z2198 * z2198;
    const Scalar z2212 = z79 + z156;
    const Scalar z2213 = z2187 * z2212;
    const Scalar z2214 = z189 * z2187;
    const Scalar z2159 = a_roll * z1760 - a_pitch * z1767 - a_steer * z1784 - z2158;
    const Scalar z2242 = z1944 - z2024 * z2213;
    const Scalar z2243 = z2024 * z2214 - z2112;
    const Scalar z2244 = z1966 + z2054 * z2213;
    const Scalar z2256 = z1917 - z2242;
    const Scalar z2245 = z2054 * z2214 + z2160;
    const Scalar z2246 = z1993 + z2077 * z2213;
    const Scalar z2247 = z2077 * z2214 + z2176;
    const Scalar z2258 = z1984 - z2189 * z2256;
    const Scalar z2257 = z2188 * z2256 + z2244;
    const Scalar z2248 = z1878 * z2193 - z1888 - z1894;
    const Scalar z2259 = z2190 * z2256 + z2258 + z2246 - z2193 * z2257;
    const Scalar z2249 = z1904 + z2197 * z2248;
    const Scalar z2226 = z189 * z2189;
    const Scalar z2250 = z2199 * z2249;
    const Scalar z2225 = z189 * z2188 - z267;
    const Scalar z2235 = z222 - z223 * z2197;
    const Scalar z2236 = z2199 * z2235;
    const Scalar z2251 = z2193 * z2250 + z2248;
    const Scalar z2227 = z189 * z2190 - z268 - z2226 - z2193 * z2225;
    const Scalar z2216 = z220 - z2189 * z2212;
    const Scalar z2260 = z2007 + z2191 * z2256 + z2197 * z2259;
    const Scalar z2252 = z2196 * z2251;
    const Scalar z2254 = z241 * z2252 - z1878 - z2250;
    const Scalar z2253 = z216 * z2252 + z1888;
    const Scalar z2261 = z2199 * z2260;
    const Scalar z2237 = z223 - z2193 * z2236;
    const Scalar z2238 = z2196 * z2237;
    const Scalar z2262 = z2193 * z2261 + z2259;
    const Scalar z2228 = z189 * z2191 + z2197 * z2227;
    const Scalar z2229 = z2199 * z2228;
    const Scalar z2255 = z2192 * z2254;
    const Scalar z2263 = z2196 * z2262;
    const Scalar z2215 = z243 - z2188 * z2212;
    const Scalar z2217 = z244 - z2190 * z2212 - z2216 - z2193 * z2215;
    const Scalar z2230 = z2193 * z2229 + z2227;
    const Scalar z2239 = z216 * z2238 - z223;
    const Scalar z2218 = z219 - z2191 * z2212 + z2197 * z2217;
    const Scalar z2231 = z2196 * z2230;
    const Scalar z2240 = z241 * z2238 + z2236;
    const Scalar z2241 = z2192 * z2240;
    const Scalar z2219 = z2199 * z2218;
    const Scalar z2232 = z216 * z2231 + z2226;
    const Scalar z2233 = z2225 - z2229 + z241 * z2231;
    const Scalar z2220 = z2193 * z2219 + z2217;
    const Scalar z2234 = z2192 * z2233;
    const Scalar z2204 = n1_over_94 + n25_over_7 * z273 * z273 + z241 * z241 / z564 + z243 * z243 / z542 + z246 * z246
        / z518 + z267 * z267 / z587;
    const Scalar z2205 = n0_28 * z2204;
    const Scalar z2265 = z2257 - z2261 + z241 * z2263;
    const Scalar z2264 = z216 * z2263 - z2258;
    const Scalar z2266 = z2192 * z2265;
    const Scalar z2221 = z2196 * z2220;
    const Scalar z2222 = z216 * z2221 + z2216;
    const Scalar z2223 = z2215 - z2219 + z241 * z2221;
    const Scalar z2207 = n1_over_94 + n25_over_7 * z274 * z274 + z240 * z240 / z564 + z244 * z244 / z542 + z247 * z247
        / z518 + z268 * z268 / z587;
    const Scalar z2208 = z564 * z2207;
    const Scalar z2268 = z2188 * z2243 + z2245;
    const Scalar z2267 = z2187 * z2256;
    const Scalar z2224 = z2192 * z2223;
    const Scalar z2269 = z2189 * z2243;
    const Scalar z2210 = n1_over_94 + z222 * z222 * (n25_over_3 + n1 / z518) + z219 * z219 / z542 + z217 * z217 / z564;
    const Scalar z2211 = n94 * z2210;
    const Scalar z2270 = z2190 * z2243 - z2269 + z2247 - z2193 * z2268;
    const Scalar z2279 = z1955 - z2040 * z2213;
    const Scalar z2280 = z2040 * z2214 - z2136;
    const Scalar z2284 = z238 * z2213 - z1985 + z1889 * z2221;
    const Scalar z2293 = z1927 - z2279;
    const Scalar z2295 = z2189 * z2293 + z2284;
    const Scalar z2287 = z2055 * z2213 + z1967 - z1879 * z2221 + z305 * z2224;
    const Scalar z2288 = z305 * z2234 - z2161 - z2055 * z2214 - z1879 * z2231;
    const Scalar z2290 = z2078 * z2213 + z1994 - z1895 * z2221 + z320 * z2224;
    const Scalar z2291 = z320 * z2234 - z2177 - z2078 * z2214 - z1895 * z2231;
    const Scalar z2281 = z232 * z2213 + z2008 + z1905 * z2221;
    const Scalar z2294 = z2188 * z2293 + z2287;
    const Scalar z2305 = z2188 * z2280 - z2288;
    const Scalar z2296 = z2190 * z2293 - z2295 + z2290 - z2193 * z2294;
    const Scalar z2271 = z2191 * z2243 + z2197 * z2270;
    const Scalar z2272 = z2199 * z2271;
    const Scalar z2278 = z2187 * z2243;
    const Scalar z2297 = z2191 * z2293 + z2281 + z2197 * z2296;
    const Scalar z2273 = z2193 * z2272 + z2270;
    const Scalar z2304 = z2187 * z2293;
    const Scalar z2298 = z2199 * z2297;
    const Scalar z2324 = z2040 * z2267;
    const Scalar z2325 = z2040 * z2278;
    const Scalar z2299 = z2193 * z2298 + z2296;
    const Scalar z2274 = z2196 * z2273;
    const Scalar z2330 = z238 * z2267 - z1889 * z2263;
    const Scalar z2285 = z238 * z2214 - z1889 * z2231;
    const Scalar z2276 = z2268 - z2272 + z241 * z2274;
    const Scalar z2275 = z216 * z2274 + z2269;
    const Scalar z2306 = z2189 * z2280 + z2285;
    const Scalar z2277 = z2192 * z2276;
    const Scalar z2338 = z1965 + z2053 * z2213;
    const Scalar z2339 = z2053 * z2214 + z2159;
    const Scalar z2340 = z1983 + z2076 * z2213;
    const Scalar z2341 = z2076 * z2214 + z2175;
    const Scalar z2307 = z2190 * z2280 - z2306 - z2291 - z2193 * z2305;
    const Scalar z2300 = z2196 * z2299;
    const Scalar z2301 = z216 * z2300 + z2295;
    const Scalar z2302 = z2294 - z2298 + z241 * z2300;
    const Scalar z2331 = z238 * z2278 - z1889 * z2274;
    const Scalar z2286 = z238 + z1889 * z2238;
    const Scalar z2329 = z1889 * z2252;
    const Scalar z2303 = z2192 * z2302;
    const Scalar z2332 = z305 * z2255 - z1879 * z2252;
    const Scalar z2333 = z305 * z2266 - z1879 * z2263 - z2055 * z2267;
    const Scalar z2334 = z305 * z2277 - z1879 * z2274 - z2055 * z2278;
    const Scalar z2289 = z305 * z2241 - z1879 * z2238;
    const Scalar z2336 = z320 * z2266 - z1895 * z2263 - z2078 * z2267;
    const Scalar z2337 = z320 * z2277 - z1895 * z2274 - z2078 * z2278;
    const Scalar z2335 = z320 * z2255 - z1895 * z2252;
    const Scalar z2292 = z320 * z2241 - z1895 * z2238;
    const Scalar z2316 = z2193 * z2289 + z2286 - z2292;
    const Scalar z2327 = z232 * z2267 - z1905 * z2263;
    const Scalar z2326 = z1905 * z2252;
    const Scalar z2282 = z232 * z2214 - z1905 * z2231;
    const Scalar z2342 = z2006 + z2090 * z2213;
    const Scalar z2308 = z2191 * z2280 + z2282 + z2197 * z2307;
    const Scalar z2315 = z2187 * z2280;
    const Scalar z2328 = z232 * z2278 - z1905 * z2274;
    const Scalar z2283 = z232 + z1905 * z2238;
    const Scalar z2344 = z2324 + z2338;
    const Scalar z2345 = z2325 + z2339;
    const Scalar z2349 = z1992 - z2330;
    const Scalar z2343 = z2090 * z2214 + z2186;
    const Scalar z2348 = z1893 - z2329;
    const Scalar z2350 = z1887 + z2332;
    const Scalar z2351 = z2333 - z2340;
    const Scalar z2352 = z2334 - z2341;
    const Scalar z2354 = z2336 - z2342;
    const Scalar z2355 = z2337 - z2343;
    const Scalar z2353 = z1903 + z2335;
    const Scalar z2347 = z2013 + z2327;
    const Scalar z2346 = z1909 - z2326;
    const Scalar z2364 = z1936 + z2344;
    const Scalar z2366 = z2189 * z2364 - z2349;
    const Scalar z2365 = z2188 * z2364 - z2351;
    const Scalar z2356 = z2193 * z2350 - z2348 - z2353;
    const Scalar z2317 = z2197 * z2316 - z2283;
    const Scalar z2367 = z2190 * z2364 - z2366 - z2354 - z2193 * z2365;
    const Scalar z2357 = z2197 * z2356 + z2346;
    const Scalar z2318 = z2199 * z2317;
    const Scalar z2358 = z2199 * z2357;
    const Scalar z2309 = z2199 * z2308;
    const Scalar z2319 = z2193 * z2318 + z2316;
    const Scalar z2310 = z2193 * z2309 + z2307;
    const Scalar z2359 = z2193 * z2358 + z2356;
    const Scalar z2320 = z2196 * z2319;
    const Scalar z2311 = z2196 * z2310;
    const Scalar z2360 = z2196 * z2359;
    const Scalar z2368 = z2191 * z2364 + z2347 + z2197 * z2367;
    const Scalar z2321 = z216 * z2320 - z2286;
    const Scalar z2312 = z216 * z2311 + z2306;
    const Scalar z2361 = z216 * z2360 + z2348;
    const Scalar z2369 = z2199 * z2368;
    const Scalar z2313 = z2305 - z2309 + z241 * z2311;
    const Scalar z2322 = z241 * z2320 - z2289 - z2318;
    const Scalar z2370 = z2193 * z2369 + z2367;
    const Scalar z2362 = z241 * z2360 - z2350 - z2358;
    const Scalar z2314 = z2192 * z2313;
    const Scalar z2377 = z2189 * z2345 + z2331;
    const Scalar z2376 = z2188 * z2345 - z2352;
    const Scalar z2378 = z2190 * z2345 - z2377 - z2355 - z2193 * z2376;
    const Scalar z2375 = z2187 * z2364;
    const Scalar z2371 = z2196 * z2370;
    const Scalar z2372 = z216 * z2371 + z2366;
    const Scalar z2373 = z2365 - z2369 + z241 * z2371;
    const Scalar z2323 = z2192 * z2322;
    const Scalar z2405 = z463 + z79 * z466 - z459 * z2213 + z469 * z2219 + z468 * z2221 - z470 * z2222;
    const Scalar z2387 = z1856 - z1857;
    const Scalar z2389 = z1859 + z2189 * z2387;
    const Scalar z2388 = z1858 - z2188 * z2387;
    const Scalar z2410 = z466 - z524 * z2214;
    const Scalar z2379 = z2191 * z2345 + z2328 + z2197 * z2378;
    const Scalar z2390 = z2190 * z2387 - z2389 + z1860 + z2193 * z2388;
    const Scalar z2380 = z2199 * z2379;
    const Scalar z2386 = z2187 * z2345;
    const Scalar z2381 = z2193 * z2380 + z2378;
    const Scalar z2403 = z542 + z79 * z545 + z521 * z2213 - z548 * z2219 - z547 * z2221 - z549 * z2222 + z443 * z2224;
    const Scalar z2391 = z1861 - z2191 * z2387 - z2197 * z2390;
    const Scalar z2398 = z2187 * z2387;
    const Scalar z2401 = z545 + n94 * z79 + z524 * z2213;
    const Scalar z2404 = z521 + z79 * z524 + z518 * z2213 + z527 * z2219 - z526 * z2221 + z528 * z2222 + z441 * z2224;
    const Scalar z2392 = z2199 * z2391;
    const Scalar z2393 = z2193 * z2392 - z2390;
    const Scalar z2413 = z527 * z2229 - z459 - z518 * z2214 - z526 * z2231 + z528 * z2232 + z441 * z2234;
    const Scalar z2414 = z587 + z459 * z2214 + z469 * z2229 + z468 * z2231 - z470 * z2232;
    const Scalar z2409 = z470 + z528 * z2214 + z566 * z2231 - n94 * z2232;
    const Scalar z2408 = z469 - z527 * z2214 + n94 * z2229 - z565 * z2231;
    const Scalar z2399 = z527 * z2213 - z548 + n94 * z2219 - z565 * z2221;
    const Scalar z2411 = z565 * z2229 - z468 - z526 * z2214 - z564 * z2231 + z566 * z2232 + z446 * z2234;
    const Scalar z2400 = z528 * z2213 - z549 - z566 * z2221 + n94 * z2222;
    const Scalar z2421 = n0_12 - z527 * z2236 - z526 * z2238 + z528 * z2239 + z441 * z2241;
    const Scalar z2402 = z547 + z526 * z2213 + z565 * z2219 - z564 * z2221 + z566 * z2222 + z446 * z2224;
    const Scalar z2419 = z515 - z565 * z2236 - z564 * z2238 + z566 * z2239 + z446 * z2241;
    const Scalar z2417 = n94 * z2236 + z565 * z2238;
    const Scalar z2418 = z566 * z2238 - n94 * z2239;
    const Scalar z2407 = z441 * z2213 + z443 - z446 * z2221 + n0_28 * z2224;
    const Scalar z2416 = z441 * z2214 + z446 * z2231 - n0_28 * z2234;
    const Scalar z2424 = z446 * z2238 - n0_28 * z2241;
    const Scalar z2382 = z2196 * z2381;
    const Scalar z2394 = z2196 * z2393;
    const Scalar z2425 = z79 * z2401 + z2219 * z2399 + z2222 * z2400 + z2224 * z2407 + z2213 * z2404 - z2221 * z2402
        + z2403;
    const Scalar z2383 = z216 * z2382 + z2377;
    const Scalar z2384 = z2376 - z2380 + z241 * z2382;
    const Scalar z2363 = z2192 * z2362;
    const Scalar z2429 = z2232 * z2409 - z2414 - z2229 * z2408 + z2234 * z2416 + z2214 * z2413 + z2231 * z2411;
    const Scalar z2426 = z2214 * z2404 - z2405 - z2229 * z2399 - z2232 * z2400 - z2234 * z2407 + z2231 * z2402;
    const Scalar z2374 = z2192 * z2373;
    const Scalar z2449 = z1364 + z1422 * z2213;
    const Scalar z2450 = z1422 * z2214 + z1530;
    const Scalar z2443 = z1425 * z2213 - z1367 + z1280 * z2221;
    const Scalar z2447 = z1534 + z1426 * z2214 + z1279 * z2231;
    const Scalar z2446 = z1368 - z1426 * z2213 + z1279 * z2221;
    const Scalar z2444 = z1280 * z2231 - z1533 - z1425 * z2214;
    const Scalar z2385 = z2192 * z2384;
    const Scalar z2456 = z1271 * z2238 - z1435 + z1549 * z2241;
    const Scalar z2460 = z1465 * z2213 - z1469 - z1471 * z2221 - z1571 * z2224;
    const Scalar z2457 = z1379 * z2213 - z1381 - z1383 * z2221 + z1545 * z2224;
    const Scalar z2458 = z1379 * z2214 - z1523 + z1383 * z2231 - z1545 * z2234;
    const Scalar z2451 = z1366 - z1424 * z2213 + z1314 * z2221 - z1554 * z2224;
    const Scalar z2452 = z1424 * z2214 - z1532 + z1314 * z2231 - z1554 * z2234;
    const Scalar z2454 = z1419 * z2213 - z1333 + z1271 * z2221 + z1549 * z2224;
    const Scalar z2455 = z1527 - z1419 * z2214 + z1271 * z2231 + z1549 * z2234;
    const Scalar z2395 = z216 * z2394 - z2389;
    const Scalar z2396 = z2388 - z2392 + z241 * z2394;
    const Scalar z2397 = z2192 * z2396;
    const Scalar z2467 = z1543 + z1548 * z2214 - z1554 * z2231;
    const Scalar z2470 = z79 * z2450 - z2222 * z2447 + z2224 * z2467 + z2219 * z2444 - z2213 * z2458 + z2221 * z2452
        + z2455;
    const Scalar z2463 = z1438 - z1440 * z2221;
    const Scalar z2466 = z1548 * z2213 + z1552 + z1554 * z2221;
    const Scalar z2469 = z79 * z2449 - z2219 * z2443 + z2222 * z2446 + z2224 * z2466 - z2213 * z2457 - z2221 * z2451
        - z2454;
    const Scalar z2423 = n0_12 - z515 * z2238;
    const Scalar z2433 = z2236 * z2417 + z2423 - z2239 * z2418 - z2241 * z2424 - z2238 * z2419;
    const Scalar z2415 = n0_12 * z2214 + z515 * z2231;
    const Scalar z2406 = z515 * z2221 - n0_12 * z2213;
    const Scalar z2472 = z2460 + z2232 * z2446 - z2229 * z2443 + z2234 * z2466 + z2214 * z2457 - z2231 * z2451;
    const Scalar z2475 = z2463 + z2236 * z2443 + z2239 * z2446 + z2241 * z2466 - z2238 * z2451;
    const Scalar z2430 = z2236 * z2408 + z2415 + z2239 * z2409 + z2241 * z2416 + z2238 * z2411;
    const Scalar z2427 = z2236 * z2399 + z2406 - z2239 * z2400 - z2241 * z2407 + z2238 * z2402;
    const Scalar z2445 = z1280 * z2238;
    const Scalar z2448 = z1279 * z2238;
    const Scalar z2461 = z1465 * z2214 + z1471 * z2231 + z1571 * z2234;
    const Scalar z2473 = z2461 + z2234 * z2467 - z2232 * z2447 + z2229 * z2444 + z2214 * z2458 + z2231 * z2452;
    const Scalar z2462 = z1471 * z2238 + z1571 * z2241;
    const Scalar z2464 = z1440 * z2231;
    const Scalar z2476 = z2239 * z2447 - z2464 - z2241 * z2467 + z2236 * z2444 - z2238 * z2452;
    const Scalar z2465 = z1440 * z2238;
    const Scalar z2468 = z1554 * z2238;
    const Scalar z2459 = z1383 * z2238 - z1545 * z2241;
    const Scalar z2453 = z1314 * z2238 + z1440 - z1554 * z2241;
    const Scalar z2471 = z2222 * z2448 - z2456 - z2219 * z2445 + z2224 * z2468 + z2213 * z2459 - z2221 * z2453;
    const Scalar z2474 = z2462 + z2229 * z2445 - z2232 * z2448 - z2234 * z2468 + z2214 * z2459 + z2231 * z2453;
    const Scalar z2477 = z2236 * z2445 - z2465 + z2239 * z2448 + z2241 * z2468 - z2238 * z2453;
    const Scalar z2434 = z1927 * z2401 + z2304 * z2404 - z2298 * z2399 + z2300 * z2402 - z2301 * z2400 - z2303 * z2407;
    const Scalar z2478 = z2434 + z2469;
    const Scalar z2437 = z1927 * z2410 + z2304 * z2413 - z2298 * z2408 + z2300 * z2411 + z2301 * z2409 + z2303 * z2416;
    const Scalar z2440 = z2304 * z2421 + z2298 * z2417 + z2300 * z2419 + z2301 * z2418 + z2303 * z2424;
    const Scalar z2481 = z2437 + z2472;
    const Scalar z2484 = z2440 + z2475;
    const Scalar z2435 = z2309 * z2399 - z2315 * z2404 - z2311 * z2402 + z2312 * z2400 + z2314 * z2407;
    const Scalar z2479 = z2435 - z2470;
    const Scalar z2436 = z2318 * z2399 - z2320 * z2402 + z2321 * z2400 + z2323 * z2407;
    const Scalar z2480 = z2436 + z2471;
    const Scalar z2496 = z1280 * z2252;
    const Scalar z2497 = z1280 * z2263 - z1425 * z2267;
    const Scalar z2438 = z2309 * z2408 - z2315 * z2413 - z2311 * z2411 - z2312 * z2409 - z2314 * z2416;
    const Scalar z2441 = z2315 * z2421 + z2309 * z2417 + z2311 * z2419 + z2312 * z2418 + z2314 * z2424;
    const Scalar z2498 = z1280 * z2274 - z1425 * z2278;
    const Scalar z2482 = z2438 - z2473;
    const Scalar z2485 = z2441 - z2476;
    const Scalar z2439 = z2318 * z2408 - z2320 * z2411 - z2321 * z2409 - z2323 * z2416;
    const Scalar z2442 = z2318 * z2417 + z2320 * z2419 + z2321 * z2418 + z2323 * z2424;
    const Scalar z2538 = z1321 - z2496;
    const Scalar z2483 = z2439 - z2474;
    const Scalar z2486 = z2442 - z2477;
    const Scalar z2526 = z1347 - z1401 * z2213;
    const Scalar z2527 = z1401 * z2214 - z1499;
    const Scalar z2524 = z1351 - z1405 * z2213;
    const Scalar z2525 = z1405 * z2214 + z1503;
    const Scalar z2534 = z1679 - z1744 * z2213;
    const Scalar z2535 = z1744 * z2214 - z1788;
    const Scalar z2536 = z1688 + z1751 * z2213;
    const Scalar z2537 = z1751 * z2214 - z1795;
    const Scalar z2522 = z1350 + z1404 * z2213;
    const Scalar z2523 = z1404 * z2214 + z1502;
    const Scalar z2539 = z2497 + z2522;
    const Scalar z2540 = z2498 + z2523;
    const Scalar z2532 = z1659 - z1717 * z2213;
    const Scalar z2533 = z1717 * z2214 - z1771;
    const Scalar z2528 = z1622 - z1695 * z2213;
    const Scalar z2529 = z1695 * z2214 - z1758;
    const Scalar z2530 = z1644 + z1702 * z2213;
    const Scalar z2531 = z1702 * z2214 + z1765;
    const Scalar z2502 = z1422 * z2267;
    const Scalar z2544 = z2502 + z2526;
    const Scalar z2503 = z1422 * z2278;
    const Scalar z2545 = z2503 - z2527;
    const Scalar z2500 = z1426 * z2267 + z1279 * z2263;
    const Scalar z2542 = z2500 + z2524;
    const Scalar z2501 = z1426 * z2278 + z1279 * z2274;
    const Scalar z2543 = z2501 - z2525;
    const Scalar z2499 = z1279 * z2252;
    const Scalar z2541 = z1322 + z2499;
    const Scalar z2510 = z1383 * z2252 - z1545 * z2255;
    const Scalar z2513 = z1471 * z2252 + z1571 * z2255;
    const Scalar z2514 = z1465 * z2267 + z1471 * z2263 + z1571 * z2266;
    const Scalar z2515 = z1465 * z2278 + z1471 * z2274 + z1571 * z2277;
    const Scalar z2520 = z1548 * z2267 - z1554 * z2263;
    const Scalar z2521 = z1548 * z2278 - z1554 * z2274;
    const Scalar z2516 = z1440 * z2252;
    const Scalar z2517 = z1440 * z2263;
    const Scalar z2518 = z1440 * z2274;
    const Scalar z2519 = z1554 * z2252;
    const Scalar z2511 = z1379 * z2267 + z1383 * z2263 - z1545 * z2266;
    const Scalar z2512 = z1379 * z2278 + z1383 * z2274 - z1545 * z2277;
    const Scalar z2504 = z1314 * z2252 - z1554 * z2255;
    const Scalar z2546 = z1592 + z2504;
    const Scalar z2507 = z1271 * z2252 + z1549 * z2255;
    const Scalar z2505 = z1314 * z2263 + z1424 * z2267 - z1554 * z2266;
    const Scalar z2506 = z1314 * z2274 + z1424 * z2278 - z1554 * z2277;
    const Scalar z2508 = z1271 * z2263 - z1419 * z2267 + z1549 * z2266;
    const Scalar z2509 = z1271 * z2274 - z1419 * z2278 + z1549 * z2277;
    const Scalar z2487 = z2358 * z2399 - z2360 * z2402 + z2361 * z2400 + z2363 * z2407;
    const Scalar z2547 = z2505 + z2528;
    const Scalar z2488 = z1936 * z2401 + z2375 * z2404 - z2369 * z2399 + z2371 * z2402 - z2372 * z2400 - z2374 * z2407;
    const Scalar z2548 = z2506 - z2529;
    const Scalar z2491 = z1936 * z2410 + z2375 * z2413 - z2369 * z2408 + z2371 * z2411 + z2372 * z2409 + z2374 * z2416;
    const Scalar z2494 = z2375 * z2421 + z2369 * z2417 + z2371 * z2419 + z2372 * z2418 + z2374 * z2424;
    const Scalar z2489 = z2380 * z2399 - z2386 * z2404 - z2382 * z2402 + z2383 * z2400 + z2385 * z2407;
    const Scalar z2549 = z1594 + z2507;
    const Scalar z2490 = z2358 * z2408 - z2360 * z2411 - z2361 * z2409 - z2363 * z2416;
    const Scalar z2493 = z2358 * z2417 + z2360 * z2419 + z2361 * z2418 + z2363 * z2424;
    const Scalar z2550 = z2508 + z2530;
    const Scalar z2551 = z2509 + z2531;
    const Scalar z2492 = z2380 * z2408 - z2386 * z2413 - z2382 * z2411 - z2383 * z2409 - z2385 * z2416;
    const Scalar z2495 = z2386 * z2421 + z2380 * z2417 + z2382 * z2419 + z2383 * z2418 + z2385 * z2424;
    const Scalar z2590 = z1856 * z2401 + z2392 * z2399 + z2395 * z2400 + z2397 * z2407 - z2394 * z2402 + z2398 * z2404;
    const Scalar z2591 = z1856 * z2410 + z2392 * z2408 - z2395 * z2409 - z2397 * z2416 - z2394 * z2411 + z2398 * z2413;
    const Scalar z2592 = z2392 * z2417 + z2395 * z2418 + z2397 * z2424 + z2394 * z2419 - z2398 * z2421;
    const Scalar z2584 = z216 * l_lambda_rear_rolls_y + z217 * l_lambda_rear_rolls_x + z240 * l_lambda_front_rolls_y
        + z241 * l_lambda_front_rolls_x - z1814;
    const Scalar z2585 = z222 * l_lambda_rear_rolls_x - z1806 + z223 * l_lambda_rear_rolls_y + z167
        * l_lambda_front_touches + z246 * l_lambda_front_rolls_x + z247 * l_lambda_front_rolls_y;
    const Scalar z2586 = z273 * l_lambda_front_rolls_x - z1071 + z274 * l_lambda_front_rolls_y;
    const Scalar z2552 = z1600 + z2510;
    const Scalar z2555 = z1606 + z2513;
    const Scalar z2556 = z2514 + z2534;
    const Scalar z2557 = z2515 - z2535;
    const Scalar z2561 = z2520 - z2536;
    const Scalar z2562 = z2521 - z2537;
    const Scalar z2558 = z1607 - z2516;
    const Scalar z2559 = z1681 - z2517;
    const Scalar z2560 = z1612 + z2519;
    const Scalar z2553 = z2511 + z2532;
    const Scalar z2554 = z2512 - z2533;
    const Scalar z2564 = z79 * z2544 - z2222 * z2542 + z2224 * z2561 + z2219 * z2539 - z2213 * z2553 + z2221 * z2547
        + z2550;
    const Scalar z2565 = z79 * z2545 - z2222 * z2543 + z2224 * z2562 + z2219 * z2540 - z2213 * z2554 + z2221 * z2548
        + z2551;
    const Scalar z2567 = z2556 + z2234 * z2561 - z2232 * z2542 + z2229 * z2539 + z2214 * z2553 + z2231 * z2547;
    const Scalar z2570 = z2559 + z2239 * z2542 - z2241 * z2561 + z2236 * z2539 - z2238 * z2547;
    const Scalar z2568 = z2557 + z2234 * z2562 - z2232 * z2543 + z2229 * z2540 + z2214 * z2554 + z2231 * z2548;
    const Scalar z2571 = z2239 * z2543 - z2518 - z2241 * z2562 + z2236 * z2540 - z2238 * z2548;
    const Scalar z2573 = z2488 + z2564;
    const Scalar z2574 = z2489 - z2565;
    const Scalar z2576 = z2491 + z2567;
    const Scalar z2577 = z2492 - z2568;
    const Scalar z2579 = z2494 - z2570;
    const Scalar z2580 = z2495 - z2571;
    const Scalar z2596 = n1 / z2433;
    const Scalar z2583 = z1118 - l_lambda_rear_touches - l_lambda_front_touches;
    const Scalar z2563 = z2219 * z2538 + z2222 * z2541 + z2224 * z2560 + z2213 * z2552 - z2221 * z2546 - z2549;
    const Scalar z2566 = z2555 + z2214 * z2552 - z2229 * z2538 - z2232 * z2541 - z2234 * z2560 + z2231 * z2546;
    const Scalar z2569 = z2236 * z2538 - z2558 - z2239 * z2541 - z2241 * z2560 + z2238 * z2546;
    const Scalar z2572 = z2487 + z2563;
    const Scalar z2575 = z2490 - z2566;
    const Scalar z2578 = z2493 + z2569;
    const Scalar z2581 = z1116 - l_lambda_rear_rolls_x - l_lambda_front_rolls_x;
    const Scalar z2582 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z1117;
    const Scalar z2587 = z79 * (l_lambda_rear_touches + z2583) - z1811 - z219 * l_lambda_rear_rolls_x - z220
        * l_lambda_rear_rolls_y - z156 * l_lambda_front_touches - z243 * l_lambda_front_rolls_x - z244
        * l_lambda_front_rolls_y + z2213 * z2585 - z2219 * z2581 - z2221 * z2584 + z2222 * z2582 + z2224 * z2586;
    const Scalar z2588 = z1821 + z189 * l_lambda_front_touches + z267 * l_lambda_front_rolls_x + z268
        * l_lambda_front_rolls_y - z2214 * z2585 - z2229 * z2581 - z2231 * z2584 + z2232 * z2582 + z2234 * z2586;
    const Scalar z2589 = z222 * l_lambda_rear_rolls_x - z1090 + z223 * l_lambda_rear_rolls_y + z2236 * z2581 - z2238
        * z2584 + z2239 * z2582 + z2241 * z2586;
    const Scalar z2594 = z2588 + z2591;
    const Scalar z2595 = z2589 - z2592;
    const Scalar z2598 = z2430 * z2596;
    const Scalar z2601 = z2429 + z2430 * z2598;
    const Scalar z2600 = z2426 + z2427 * z2598;
    const Scalar z2606 = z2481 + z2484 * z2598;
    const Scalar z2593 = z2587 + z2590;
    const Scalar z2611 = z2482 - z2485 * z2598;
    const Scalar z2602 = n1 / z2601;
    const Scalar z2616 = z2575 - z2578 * z2598;
    const Scalar z2621 = z2483 - z2486 * z2598;
    const Scalar z2626 = z2576 + z2579 * z2598;
    const Scalar z2631 = z2577 - z2580 * z2598;
    const Scalar z2597 = z2427 * z2596;
    const Scalar z2599 = z2425 - z2427 * z2597;
    const Scalar z2603 = z2600 * z2602;
    const Scalar z2604 = z2599 + z2600 * z2603;
    const Scalar z2607 = z2478 + z2484 * z2597 - z2603 * z2606;
    const Scalar z2612 = z2479 - z2485 * z2597 - z2603 * z2611;
    const Scalar z2617 = z2572 - z2578 * z2597 - z2603 * z2616;
    const Scalar z2622 = z2480 - z2486 * z2597 - z2603 * z2621;
    const Scalar z2627 = z2573 + z2579 * z2597 - z2603 * z2626;
    const Scalar z2632 = z2574 - z2580 * z2597 - z2603 * z2631;
    const Scalar z2605 = n1 / z2604;
    const Scalar z2608 = z2605 * z2607;
    const Scalar z2613 = z2605 * z2612;
    const Scalar z2618 = z2605 * z2617;
    const Scalar z2623 = z2605 * z2622;
    const Scalar z2628 = z2605 * z2627;
    const Scalar z2633 = z2605 * z2632;
    const Scalar z2609 = z2602 * z2606 + z2603 * z2608;
    const Scalar z2614 = z2602 * z2611 + z2603 * z2613;
    const Scalar z2619 = z2602 * z2616 + z2603 * z2618;
    const Scalar z2624 = z2602 * z2621 + z2603 * z2623;
    const Scalar z2629 = z2602 * z2626 + z2603 * z2628;
    const Scalar z2634 = z2602 * z2631 + z2603 * z2633;
    const Scalar z2610 = z2484 * z2596 + z2597 * z2608 - z2598 * z2609;
    const Scalar z2615 = z2485 * z2596 - z2597 * z2613 + z2598 * z2614;
    const Scalar z2620 = z2578 * z2596 - z2597 * z2618 + z2598 * z2619;
    const Scalar z2625 = z2486 * z2596 - z2597 * z2623 + z2598 * z2624;
    const Scalar z2630 = z2579 * z2596 + z2597 * z2628 - z2598 * z2629;
    const Scalar z2635 = z2580 * z2596 - z2597 * z2633 + z2598 * z2634;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z565;
    result.M[4] = -z548;
    result.M[5] = z527;
    result.M[6] = z469;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z566;
    result.M[13] = z549;
    result.M[14] = -z528;
    result.M[15] = z470;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z545;
    result.M[23] = z524;
    result.M[24] = z466;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z565;
    result.M[28] = -z566;
    result.M[29] = n0;
    result.M[30] = z564;
    result.M[31] = z547;
    result.M[32] = z526;
    result.M[33] = -z468;
    result.M[34] = z515;
    result.M[35] = z446;
    result.M[36] = -z548;
    result.M[37] = z549;
    result.M[38] = z545;
    result.M[39] = z547;
    result.M[40] = z542;
    result.M[41] = z521;
    result.M[42] = z463;
    result.M[43] = n0;
    result.M[44] = z443;
    result.M[45] = z527;
    result.M[46] = -z528;
    result.M[47] = z524;
    result.M[48] = z526;
    result.M[49] = z521;
    result.M[50] = z518;
    result.M[51] = -z459;
    result.M[52] = n0_12;
    result.M[53] = z441;
    result.M[54] = z469;
    result.M[55] = z470;
    result.M[56] = z466;
    result.M[57] = -z468;
    result.M[58] = z463;
    result.M[59] = -z459;
    result.M[60] = z587;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z515;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z446;
    result.M[76] = z443;
    result.M[77] = z441;
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
    result.C[27] = z1280;
    result.C[28] = z1279;
    result.C[29] = n0;
    result.C[30] = -z1314;
    result.C[31] = z1271;
    result.C[32] = -z1383;
    result.C[33] = z1471;
    result.C[34] = z1440;
    result.C[35] = -z1554;
    result.C[36] = z1367;
    result.C[37] = -z1368;
    result.C[38] = z1364;
    result.C[39] = z1366;
    result.C[40] = z1333;
    result.C[41] = z1381;
    result.C[42] = -z1469;
    result.C[43] = z1438;
    result.C[44] = z1552;
    result.C[45] = -z1425;
    result.C[46] = z1426;
    result.C[47] = z1422;
    result.C[48] = -z1424;
    result.C[49] = -z1419;
    result.C[50] = -z1379;
    result.C[51] = z1465;
    result.C[52] = n0;
    result.C[53] = z1548;
    result.C[54] = z1533;
    result.C[55] = -z1534;
    result.C[56] = -z1530;
    result.C[57] = -z1532;
    result.C[58] = -z1527;
    result.C[59] = -z1523;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = -z1543;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z1440;
    result.C[67] = z1435;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = -z1554;
    result.C[76] = -z1549;
    result.C[77] = -z1545;
    result.C[78] = -z1571;
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
    result.K[27] = z1321;
    result.K[28] = -z1322;
    result.K[29] = n0;
    result.K[30] = z1592;
    result.K[31] = -z1594;
    result.K[32] = z1600;
    result.K[33] = -z1606;
    result.K[34] = z1607;
    result.K[35] = z1612;
    result.K[36] = z1350;
    result.K[37] = z1351;
    result.K[38] = z1347;
    result.K[39] = -z1622;
    result.K[40] = z1644;
    result.K[41] = -z1659;
    result.K[42] = z1679;
    result.K[43] = -z1681;
    result.K[44] = -z1688;
    result.K[45] = z1404;
    result.K[46] = -z1405;
    result.K[47] = -z1401;
    result.K[48] = z1695;
    result.K[49] = z1702;
    result.K[50] = z1717;
    result.K[51] = -z1744;
    result.K[52] = n0;
    result.K[53] = -z1751;
    result.K[54] = -z1502;
    result.K[55] = z1503;
    result.K[56] = -z1499;
    result.K[57] = z1758;
    result.K[58] = -z1765;
    result.K[59] = z1771;
    result.K[60] = -z1788;
    result.K[61] = n0;
    result.K[62] = -z1795;
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
    result.F[0] = -z1116 + l_lambda_rear_rolls_x + l_lambda_front_rolls_x;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z1117;
    result.F[2] = z1118 - l_lambda_rear_touches - l_lambda_front_touches;
    result.F[3] = z216 * l_lambda_rear_rolls_y + z217 * l_lambda_rear_rolls_x + z240 * l_lambda_front_rolls_y + z241
        * l_lambda_front_rolls_x - z1814;
    result.F[4] = z79 * l_lambda_rear_touches - z219 * l_lambda_rear_rolls_x - z220 * l_lambda_rear_rolls_y - z156
        * l_lambda_front_touches - z243 * l_lambda_front_rolls_x - z244 * l_lambda_front_rolls_y - z1811;
    result.F[5] = z222 * l_lambda_rear_rolls_x - z1806 + z223 * l_lambda_rear_rolls_y + z167 * l_lambda_front_touches
        + z246 * l_lambda_front_rolls_x + z247 * l_lambda_front_rolls_y;
    result.F[6] = z1821 + z189 * l_lambda_front_touches + z267 * l_lambda_front_rolls_x + z268 * l_lambda_front_rolls_y;
    result.F[7] = z222 * l_lambda_rear_rolls_x - z1090 + z223 * l_lambda_rear_rolls_y;
    result.F[8] = z273 * l_lambda_front_rolls_x - z1071 + z274 * l_lambda_front_rolls_y;
    result.M_r[0] = z2425;
    result.M_r[1] = -z2426;
    result.M_r[2] = -z2427;
    result.M_r[3] = -z2426;
    result.M_r[4] = -z2429;
    result.M_r[5] = -z2430;
    result.M_r[6] = -z2427;
    result.M_r[7] = -z2430;
    result.M_r[8] = z2433;
    result.C_r[0] = z2478;
    result.C_r[1] = z2481;
    result.C_r[2] = z2484;
    result.C_r[3] = z2479;
    result.C_r[4] = z2482;
    result.C_r[5] = -z2485;
    result.C_r[6] = z2480;
    result.C_r[7] = z2483;
    result.C_r[8] = -z2486;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z2572;
    result.K_r[7] = z2575;
    result.K_r[8] = -z2578;
    result.K_r[9] = z2573;
    result.K_r[10] = z2576;
    result.K_r[11] = z2579;
    result.K_r[12] = z2574;
    result.K_r[13] = z2577;
    result.K_r[14] = -z2580;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = z2593;
    result.F_r[1] = z2594;
    result.F_r[2] = z2595;
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
    result.A[20] = z2250;
    result.A[21] = -z2253;
    result.A[22] = -z2252;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z2255;
    result.A[27] = -z2618;
    result.A[28] = z2619;
    result.A[29] = z2620;
    result.A[30] = -z2261;
    result.A[31] = z2264;
    result.A[32] = z2263;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z2266;
    result.A[37] = -z2628;
    result.A[38] = z2629;
    result.A[39] = -z2630;
    result.A[40] = z2272;
    result.A[41] = -z2275;
    result.A[42] = -z2274;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z2277;
    result.A[47] = -z2633;
    result.A[48] = z2634;
    result.A[49] = z2635;
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
    result.A[70] = z2219;
    result.A[71] = -z2222;
    result.A[72] = -z2221;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z2608;
    result.A[78] = z2609;
    result.A[79] = -z2610;
    result.A[80] = z2229;
    result.A[81] = -z2232;
    result.A[82] = -z2231;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z2234;
    result.A[87] = -z2613;
    result.A[88] = z2614;
    result.A[89] = z2615;
    result.A[90] = -z2236;
    result.A[91] = -z2239;
    result.A[92] = -z2238;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z2241;
    result.A[97] = -z2623;
    result.A[98] = z2624;
    result.A[99] = z2625;
    if (!(traits::regular(z2200, z2202) && traits::regular(z2203, z2205) && traits::regular(z2206, z2208)
        && traits::regular(z2209, z2211) && traits::regular(z2604, z2425) && traits::regular(-z2601, -z2429)
        && traits::regular(z2433, z2433))) return torsor::Status::singular;
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
