// SPDX-License-Identifier: MIT
// falling_plate: A plate falls with its edge on a smooth plane
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: b, A, B, F
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                9                4          0             0                  0       0     13       -
//   kinematics               12               28          0             0                  2       0     44      46
//   mass_matrix               3                7          0             0                  1       0     12      21
//   bias                     14               39          0             0                  1       0     55      66
//   inverse_dynamics         21               48          0             0                  1       0     71      86
//   forward_dynamics         20               50          2             0                  1       0     74      89
//   energy                   15               30          0             0                  2       0     49      59
//   first_integrals          19               36          0             0                  2       0     59      70
//   reactions                16               30          0             0                  2       0     50      61
//   linearisation            73              149          2             0                  1       0    226     255
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 1 vanish identically
//   mass_matrix: of 16 results 10 vanish identically, 1 repeat another up to sign
//   bias: of 4 results 2 vanish identically
//   forward_dynamics: of 4 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 116 results 90 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   falling_plate_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output falling_plate.hpp
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

namespace falling_plate {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "falling_plate";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x17772a8c8b911377ULL;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 4;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 4;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar b;  ///< parameter [m]
    Scalar A;  ///< parameter [kg m^2]
    Scalar B;  ///< parameter [kg m^2]
    Scalar F;  ///< parameter [kg m^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::b, &Parameters::A, &Parameters::B, &Parameters::F};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar alpha;  ///< coordinate [rad or 1]
    Scalar beta;  ///< coordinate [rad or 1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::alpha,
          &Coordinates::beta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar alpha;  ///< its rate [rad/s]
    Scalar beta;  ///< its rate [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::alpha,
          &Velocities::beta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar alpha;  ///< its second rate [rad/s^2]
    Scalar beta;  ///< its second rate [rad/s^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::alpha,
          &Accelerations::beta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar alpha;  ///< works with the rate of alpha [N m]
    Scalar beta;  ///< works with the rate of beta [N m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::alpha, &GeneralizedForces::beta};
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
    Scalar m_de226596;
    Scalar m_a8188141;
    Scalar m_b5f0de83;
    Scalar m_c70c1f0e;
    Scalar m_8204775b;
    Scalar m_6f102224;
    Scalar m_96015fcf;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_045 = traits::constant(0.045, 0.045f, "9/200");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_015 = traits::constant(0.015, 0.015f, "3/200");
    parameters.b = n0_3;
    parameters.A = n0_045;
    parameters.B = n0_02;
    parameters.F = n0_015;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_b = parameters.b;
    const Scalar p_A = parameters.A;
    const Scalar p_B = parameters.B;
    const Scalar z0 = p_b * p_b + p_A;
    const Scalar z1 = p_b * p_b + p_A + p_B;
    const Scalar z2 = p_B - z1;
    const Scalar z3 = p_B - z0 + z1;
    const Scalar z4 = n0_5 * z3;
    const Scalar z5 = p_B - z4;
    const Scalar z6 = z1 - z4;
    const Scalar z7 = z5 - z6;
    const Scalar z8 = n2 * p_b;
    precomputed.m_de226596 = z0;
    precomputed.m_a8188141 = z1;
    precomputed.m_b5f0de83 = z2;
    precomputed.m_c70c1f0e = z5;
    precomputed.m_8204775b = z6;
    precomputed.m_6f102224 = z7;
    precomputed.m_96015fcf = z8;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_4 = traits::constant(1.4, 1.4f, "7/5");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.alpha = n0;
    state.q.beta = n1_4;
    state.v.x = n0;
    state.v.y = n0;
    state.v.alpha = n0;
    state.v.beta = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> plate_position;  ///< centre of mass of plate [m]
    std::array<Scalar, 9> plate_rotation;  ///< from the axes of plate to the ground's (3 x 3)
    std::array<Scalar, 3> plate_velocity;  ///< velocity of the centre of mass of plate [m/s]
    std::array<Scalar, 3> plate_angular_velocity;  ///< angular velocity of plate [rad/s]
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
    Scalar momentum_x;  ///< dT/dx' of the cyclic coordinate 'x' [kg m s^-1]
    Scalar momentum_y;  ///< dT/dy' of the cyclic coordinate 'y' [kg m s^-1]
    Scalar momentum_alpha;  ///< dT/dalpha' of the cyclic coordinate 'alpha' [kg m^2 s^-1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_x,
          &FirstIntegrals::momentum_y, &FirstIntegrals::momentum_alpha};
      return members_[i_];
    }
  };

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar N;  ///< reaction along 'N' [kg m s^-2]
    Scalar moment;  ///< reaction along 'moment' [kg m^2 s^-2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::N, &Reactions::moment};
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

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = p_b * c_beta;
    const Scalar z2 = v_alpha * c_beta;
    const Scalar z3 = s_alpha * c_beta;
    const Scalar z4 = c_alpha * c_beta;
    const Scalar z5 = s_alpha * s_beta;
    const Scalar z6 = c_alpha * s_beta;
    const Scalar z7 = p_b * v_beta;
    const Scalar z8 = p_b * s_beta;
    const Scalar z9 = c_alpha * v_beta;  // angular velocity of plate, x
    const Scalar z10 = s_alpha * v_beta;  // angular velocity of plate, y
    const Scalar z11 = c_beta * z7;
    const Scalar z12 = s_alpha * z1;
    const Scalar z13 = c_alpha * z1;
    const Scalar z14 = v_alpha * z1;
    const Scalar z15 = p_b * z3;
    const Scalar z16 = p_b * z4;
    const Scalar z17 = p_b * z2;
    const Scalar z18 = q_x + z12;  // place of foot, x
    const Scalar z19 = q_y - z13;  // place of foot, y
    const Scalar z20 = v_x - s_alpha * p_b * z0 + c_alpha * z14;  // velocity of foot, x
    const Scalar z21 = v_y + c_alpha * p_b * z0 + s_alpha * z14;  // velocity of foot, y
    const Scalar z22 = z18 - z15;
    const Scalar z23 = z19 + z16;
    const Scalar z24 = c_alpha * z17 - z20 - z5 * z7;
    const Scalar z25 = s_alpha * z17 - z21 + z6 * z7;
    result.plate_position[0] = z22;
    result.plate_position[1] = z23;
    result.plate_position[2] = z8;
    result.plate_rotation[0] = c_alpha;
    result.plate_rotation[1] = s_alpha;
    result.plate_rotation[2] = n0;
    result.plate_rotation[3] = -z3;
    result.plate_rotation[4] = z4;
    result.plate_rotation[5] = s_beta;
    result.plate_rotation[6] = z5;
    result.plate_rotation[7] = -z6;
    result.plate_rotation[8] = c_beta;
    result.plate_velocity[0] = -z24;
    result.plate_velocity[1] = -z25;
    result.plate_velocity[2] = z11;
    result.plate_angular_velocity[0] = z9;
    result.plate_angular_velocity[1] = z10;
    result.plate_angular_velocity[2] = v_alpha;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 16>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar m2 = precomputed.m_b5f0de83;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = s_beta * m2;
    const Scalar z1 = p_b * s_beta;
    const Scalar z2 = p_b * c_beta;
    const Scalar z3 = s_beta * p_F;
    const Scalar z4 = s_beta * z0;
    const Scalar z5 = z1 * z1;
    const Scalar z6 = m1 + z4;
    const Scalar z7 = m0 - z5;
    const Scalar z8 = z2 * z2 - z6;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n1;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = -z8;
    mass[11] = z3;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = z3;
    mass[15] = z7;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_c70c1f0e;
    const Scalar m1 = precomputed.m_8204775b;
    const Scalar m2 = precomputed.m_6f102224;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = c_beta * v_beta;
    const Scalar z2 = p_b * c_beta;
    const Scalar z3 = v_alpha * v_alpha;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = v_beta * v_beta;
    const Scalar z7 = p_b * s_beta;
    const Scalar z8 = v_beta * z1;
    const Scalar z9 = n2 * v_alpha * p_b * z0;
    const Scalar z10 = v_beta * z5;  // angular acceleration of plate, y
    const Scalar z11 = v_beta * z4;  // angular acceleration of plate, z
    const Scalar z12 = z5 * z5;
    const Scalar z13 = z4 * z5;
    const Scalar z14 = z4 * z4;
    const Scalar z15 = z2 * z3 + p_b * z8;
    const Scalar z16 = n2 * z11;
    const Scalar z17 = z12 + z6;
    const Scalar z18 = n2 * z10;
    const Scalar z19 = z6 - z14;
    const Scalar z20 = p_b * z13;  // force on plate, z
    const Scalar z21 = p_b * z16;  // force on plate, x
    const Scalar z22 = p_b * z17;  // force on plate, y
    const Scalar z23 = p_F * z13 + m0 * z18;  // moment on plate, y
    const Scalar z24 = p_b * z9 + p_F * z19 - m1 * z16;  // moment on plate, z
    const Scalar z25 = n9_81 * c_beta - s_beta * z15;
    const Scalar z26 = s_beta * z20 + c_beta * z22;
    const Scalar z27 = z9 - z21;  // force on foot, x
    const Scalar z28 = p_b * z25 - z13 * m2;  // moment on plate, x
    const Scalar z29 = z15 - z26;  // force on foot, y
    const Scalar z30 = s_beta * z23 + c_beta * z24;
    const Scalar z31 = z2 * z27 - z30;  // moment on turned, z
    const Scalar z32 = z7 * z29 + z28;
    forces.x = n0;
    forces.y = n0;
    forces.alpha = -z31;
    forces.beta = z32;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar m2 = precomputed.m_b5f0de83;
    const Scalar m3 = precomputed.m_c70c1f0e;
    const Scalar m4 = precomputed.m_8204775b;
    const Scalar m5 = precomputed.m_6f102224;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = c_beta * v_beta;
    const Scalar z2 = p_b * c_beta;
    const Scalar z3 = v_alpha * v_alpha;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = v_beta * v_beta;
    const Scalar z7 = s_beta * m2;
    const Scalar z8 = p_b * s_beta;
    const Scalar z9 = s_beta * p_F;
    const Scalar z10 = v_beta * z4;
    const Scalar z11 = z5 * z5;
    const Scalar z12 = z4 * z5;
    const Scalar z13 = v_beta * z5;
    const Scalar z14 = z4 * z4;
    const Scalar z15 = s_beta * z7;
    const Scalar z16 = z8 * z8;
    const Scalar z17 = v_beta * z1;
    const Scalar z18 = n2 * v_alpha * p_b * z0;
    const Scalar z19 = z11 + z6;
    const Scalar z20 = z6 - z14;
    const Scalar z21 = m1 + z15;
    const Scalar z22 = m0 - z16;
    const Scalar z23 = z2 * z3 + p_b * z17;
    const Scalar z24 = n2 * z10;
    const Scalar z25 = n2 * z13;
    const Scalar z26 = p_b * z12;  // force on plate, z
    const Scalar z27 = p_b * z19;  // force on plate, y
    const Scalar z28 = z2 * z2 - z21;
    const Scalar z29 = p_b * z24;  // force on plate, x
    const Scalar z30 = p_F * z12 + m3 * z25;  // moment on plate, y
    const Scalar z31 = p_b * z18 + p_F * z20 - m4 * z24;  // moment on plate, z
    const Scalar z32 = n9_81 * c_beta - s_beta * z23;
    const Scalar z33 = s_beta * z26 + c_beta * z27;
    const Scalar z34 = z18 - z29;  // force on foot, x
    const Scalar z35 = p_b * z32 - m5 * z12;  // moment on plate, x
    const Scalar z36 = z23 - z33;  // force on foot, y
    const Scalar z37 = s_beta * z30 + c_beta * z31;
    const Scalar z38 = z2 * z34 - z37;  // moment on turned, z
    const Scalar z39 = z8 * z36 + z35;
    const Scalar z40 = z38 + a_alpha * z28 - a_beta * z9;
    const Scalar z41 = z39 + a_alpha * z9 + a_beta * z22;
    forces.x = a_x;
    forces.y = a_y;
    forces.alpha = -z40;
    forces.beta = z41;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar m2 = precomputed.m_b5f0de83;
    const Scalar m3 = precomputed.m_c70c1f0e;
    const Scalar m4 = precomputed.m_8204775b;
    const Scalar m5 = precomputed.m_6f102224;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = p_b * s_beta;
    const Scalar z1 = s_beta * m2;
    const Scalar z2 = s_beta * v_beta;
    const Scalar z3 = c_beta * v_beta;
    const Scalar z4 = p_b * c_beta;
    const Scalar z5 = v_alpha * v_alpha;
    const Scalar z6 = v_alpha * s_beta;
    const Scalar z7 = v_alpha * c_beta;
    const Scalar z8 = v_beta * v_beta;
    const Scalar z9 = s_beta * p_F;
    const Scalar z10 = v_beta * z3;
    const Scalar z11 = n2 * v_alpha * p_b * z2;
    const Scalar z12 = v_beta * z7;  // angular acceleration of plate, y
    const Scalar z13 = v_beta * z6;  // angular acceleration of plate, z
    const Scalar z14 = z7 * z7;
    const Scalar z15 = z6 * z7;
    const Scalar z16 = z6 * z6;
    const Scalar z17 = s_beta * z1;
    const Scalar z18 = z0 * z0;
    const Scalar z19 = z4 * z5 + p_b * z10;
    const Scalar z20 = n2 * z13;
    const Scalar z21 = z14 + z8;
    const Scalar z22 = n2 * z12;
    const Scalar z23 = z8 - z16;
    const Scalar z24 = p_b * z15;  // force on plate, z
    const Scalar z25 = m1 + z17;
    const Scalar z26 = m0 - z18;
    const Scalar z27 = p_b * z20;  // force on plate, x
    const Scalar z28 = p_b * z21;  // force on plate, y
    const Scalar z29 = p_F * z15 + m3 * z22;  // moment on plate, y
    const Scalar z30 = p_b * z11 + p_F * z23 - m4 * z20;  // moment on plate, z
    const Scalar z31 = z4 * z4 - z25;
    const Scalar z32 = n1 / z26;
    const Scalar z33 = n9_81 * c_beta - s_beta * z19;
    const Scalar z34 = s_beta * z24 + c_beta * z28;
    const Scalar z35 = z11 - z27;  // force on foot, x
    const Scalar z36 = p_b * z33 - m5 * z15;  // moment on plate, x
    const Scalar z37 = z19 - z34;  // force on foot, y
    const Scalar z38 = s_beta * z29 + c_beta * z30;
    const Scalar z39 = z4 * z35 - z38;  // moment on turned, z
    const Scalar z40 = z0 * z37 + z36;
    const Scalar z41 = z9 * z32;
    const Scalar z42 = z9 * z41 + z31;
    const Scalar z43 = z39 + z40 * z41;
    const Scalar z44 = n1 / z42;
    const Scalar z45 = z44 * z43;
    const Scalar z46 = z40 * z32 - z41 * z45;
    accelerations.x = n0;
    accelerations.y = n0;
    accelerations.alpha = -z45;
    accelerations.beta = -z46;
    if (!(traits::regular(-z42, -z31) && traits::regular(z26, z26))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.alpha * accelerations.beta;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = v_x * s_alpha - v_y * c_alpha;
    const Scalar z2 = v_x * c_alpha + v_y * s_alpha;
    const Scalar z3 = p_b * c_beta;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = p_b * s_beta;
    const Scalar z7 = v_beta * p_F + p_B * z4;
    const Scalar z8 = v_alpha * z3 + z2;
    const Scalar z9 = p_b * z0 - z1;  // velocity of foot, y
    const Scalar z10 = c_beta * z9;
    const Scalar z11 = s_beta * z9;
    const Scalar z12 = p_b * z5 - z8;
    const Scalar z13 = p_b * z8 - m1 * z5;
    const Scalar z14 = p_b * v_beta - z11;
    const Scalar z15 = p_b * z11 - v_beta * m0 - p_F * z4;
    result.kinetic = -n0_5 * (z8 * z12 - z4 * z7 - z10 * z10 + z5 * z13 + z11 * z14 + v_beta * z15);
    result.force_function = -n9_81 * z6;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar m2 = precomputed.m_b5f0de83;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = v_x * s_alpha - v_y * c_alpha;
    const Scalar z2 = v_x * c_alpha + v_y * s_alpha;
    const Scalar z3 = p_b * c_beta;
    const Scalar z4 = s_beta * m2;
    const Scalar z5 = v_alpha * s_beta;
    const Scalar z6 = v_alpha * c_beta;
    const Scalar z7 = p_b * s_beta;
    const Scalar z8 = s_beta * p_F;
    const Scalar z9 = v_beta * p_F + p_B * z5;
    const Scalar z10 = s_beta * z4;
    const Scalar z11 = m1 + z10;
    const Scalar z12 = v_alpha * z3 + z2;
    const Scalar z13 = p_b * z0 - z1;  // velocity of foot, y
    const Scalar z14 = z3 * z3 - z11;
    const Scalar z15 = c_beta * z13;
    const Scalar z16 = s_beta * z13;
    const Scalar z17 = p_b * z6 - z12;
    const Scalar z18 = p_b * z12 - m1 * z6;
    const Scalar z19 = p_b * v_beta - z16;
    const Scalar z20 = p_b * z16 - v_beta * m0 - p_F * z5;
    result.energy = -n0_5 * (z12 * z17 - z5 * z9 - z15 * z15 + z6 * z18 + z16 * z19 + v_beta * z20) + n9_81 * z7;
    result.momentum_x = v_x;
    result.momentum_y = v_y;
    result.momentum_alpha = -v_alpha * z14 + v_beta * z8;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_c70c1f0e;
    const Scalar m1 = precomputed.m_8204775b;
    const Scalar m2 = precomputed.m_96015fcf;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * s_beta;
    const Scalar z1 = v_alpha * c_beta;
    const Scalar z2 = a_alpha * c_beta;
    const Scalar z3 = a_alpha * s_beta;
    const Scalar z4 = v_beta * v_beta;
    const Scalar z5 = s_beta * v_beta;
    const Scalar z6 = a_x * c_alpha + a_y * s_alpha;
    const Scalar z7 = p_b * c_beta;
    const Scalar z8 = v_beta * z1 + z3;  // angular acceleration of plate, y
    const Scalar z9 = v_beta * z0 - z2;  // angular acceleration of plate, z
    const Scalar z10 = v_beta * z0;
    const Scalar z11 = z1 * z1;
    const Scalar z12 = z0 * z1;
    const Scalar z13 = v_beta * z1;
    const Scalar z14 = z0 * z0;
    const Scalar z15 = z11 + z4;
    const Scalar z16 = a_beta + z12;
    const Scalar z17 = z4 - z14;
    const Scalar z18 = v_alpha * m2 * z5 - z6 - a_alpha * z7;
    const Scalar z19 = z9 + z10;
    const Scalar z20 = z8 + z13;
    const Scalar z21 = p_b * z15;  // force on plate, y
    const Scalar z22 = p_b * z16;  // force on plate, z
    const Scalar z23 = p_F * z16 + m0 * z20;  // moment on plate, y
    const Scalar z24 = c_beta * z22 - s_beta * z21;
    const Scalar z25 = p_F * z17 - m1 * z19 + p_b * z18;  // moment on plate, z
    const Scalar z26 = n9_81 + z24;  // force on foot, z
    const Scalar z27 = c_beta * z23 - s_beta * z25;
    result.N = z26;
    result.moment = z27;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar m2 = precomputed.m_b5f0de83;
    const Scalar m3 = precomputed.m_c70c1f0e;
    const Scalar m4 = precomputed.m_8204775b;
    const Scalar m5 = precomputed.m_6f102224;
    const Scalar m6 = precomputed.m_96015fcf;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = c_beta * v_beta;
    const Scalar z1 = v_alpha * s_beta;
    const Scalar z2 = s_beta * v_beta;
    const Scalar z3 = v_alpha * c_beta;
    const Scalar z4 = p_b * s_beta;
    const Scalar z5 = p_b * c_beta;
    const Scalar z6 = v_alpha * v_alpha;
    const Scalar z7 = v_beta * v_beta;
    const Scalar z8 = s_beta * m2;
    const Scalar z9 = n2 * v_alpha;
    const Scalar z10 = s_beta * p_F;
    const Scalar z11 = n2 * v_alpha * p_b * s_beta;
    const Scalar z12 = c_beta * m2;
    const Scalar z13 = c_beta * p_F;
    const Scalar z14 = v_beta * z1;
    const Scalar z15 = z3 * z3;
    const Scalar z16 = n2 * v_beta;
    const Scalar z17 = z1 * z3;
    const Scalar z18 = v_beta * z3;
    const Scalar z19 = z1 * z1;
    const Scalar z20 = s_beta * z8;
    const Scalar z21 = z4 * z4;
    const Scalar z22 = v_beta * z0;
    const Scalar z23 = n2 * v_alpha * p_b * z2;
    const Scalar z24 = m6 * z2;
    const Scalar z25 = n2 * z2;
    const Scalar z26 = n2 * s_beta * z1;
    const Scalar z27 = c_beta * z1 + s_beta * z3;
    const Scalar z28 = n2 * z0;
    const Scalar z29 = z5 * z9;
    const Scalar z30 = n2 * c_beta * z3;
    const Scalar z31 = n2 * z1;
    const Scalar z32 = z15 + z7;
    const Scalar z33 = n2 * z3;
    const Scalar z34 = z7 - z19;
    const Scalar z35 = m1 + z20;
    const Scalar z36 = m0 - z21;
    const Scalar z37 = z5 * z6 + p_b * z22;
    const Scalar z38 = n2 * z14;
    const Scalar z39 = n2 * z18;
    const Scalar z40 = p_b * z17;  // force on plate, z
    const Scalar z41 = p_b * z25;
    const Scalar z42 = p_b * z24 - p_F * z26 - m4 * z25;
    const Scalar z43 = p_b * z30;
    const Scalar z44 = s_beta * z29;
    const Scalar z45 = p_b * z31;
    const Scalar z46 = p_F * z16 + p_b * z11 - m4 * z31;
    const Scalar z47 = m3 * z33;
    const Scalar z48 = p_b * z32;  // force on plate, y
    const Scalar z49 = c_beta * z8 + s_beta * z12;
    const Scalar z50 = n2 * v_alpha * p_b * z0;
    const Scalar z51 = z4 * z5;
    const Scalar z52 = n2 * z51;
    const Scalar z53 = z5 * z5 - z35;
    const Scalar z54 = z3 * z31;
    const Scalar z55 = z15 - z19;
    const Scalar z56 = p_b * z38;  // force on plate, x
    const Scalar z57 = p_F * z17 + m3 * z39;  // moment on plate, y
    const Scalar z58 = p_b * z23 + p_F * z34 - m4 * z38;  // moment on plate, z
    const Scalar z59 = z24 - z41;
    const Scalar z60 = z11 - z45;
    const Scalar z61 = p_F * z55 - m3 * z38;
    const Scalar z62 = s_beta * z47 + c_beta * z46;
    const Scalar z63 = z23 - z56;  // force on foot, x
    const Scalar z64 = p_b * z44 + m5 * z27;
    const Scalar z65 = z49 + z52;
    const Scalar z66 = p_b * z50 - p_F * z54 - m4 * z39;
    const Scalar z67 = c_beta * (z57 + z66) - s_beta * (z58 - z61);
    const Scalar z68 = s_beta * z57 + c_beta * z58;
    const Scalar z69 = z5 * z60 - z62;
    const Scalar z70 = p_b * z39;
    const Scalar z71 = z50 - z70;
    const Scalar z72 = z5 * z63 - z68;  // moment on turned, z
    const Scalar z73 = s_beta * z40 + c_beta * z48;
    const Scalar z74 = z72 + a_alpha * z53 - a_beta * z10;
    const Scalar z75 = z67 + z4 * z63 - z5 * z71;
    const Scalar z76 = z37 - z73;  // force on foot, y
    const Scalar z77 = m3 * z28 + p_F * z27;
    const Scalar z78 = s_beta * z77 + c_beta * z42;
    const Scalar z79 = p_b * z27;
    const Scalar z80 = c_beta * z43 + s_beta * z79;
    const Scalar z81 = n9_81 * c_beta - s_beta * z37;
    const Scalar z82 = p_b * z81 - m5 * z17;  // moment on plate, x
    const Scalar z83 = z29 - z80;
    const Scalar z84 = z5 * z59 - z78;
    const Scalar z85 = z75 + a_beta * z13 + a_alpha * z65;
    const Scalar z86 = z4 * z83 - z64;
    const Scalar z87 = v_beta * z2;
    const Scalar z88 = z4 * z6 + p_b * z87;
    const Scalar z89 = p_b * z54;
    const Scalar z90 = p_b * z28;
    const Scalar z91 = p_b * z16;
    const Scalar z92 = c_beta * z91;
    const Scalar z93 = n2 * (z4 * z5 - z52);
    const Scalar z94 = z4 * z76 + z82;
    const Scalar z95 = z94 + a_alpha * z10 + a_beta * z36;
    const Scalar z96 = c_beta * z37 + s_beta * (n9_81 - z88);
    const Scalar z97 = n1 / z36;
    const Scalar z98 = z90 - z92;
    const Scalar z99 = m5 * z55 + p_b * z96;
    const Scalar z100 = p_b * z55;
    const Scalar z101 = c_beta * (z40 - z89) - s_beta * (z48 - z100);
    const Scalar z102 = z10 * z97;
    const Scalar z103 = z10 * z102 + z53;
    const Scalar z104 = s_beta * z90;
    const Scalar z105 = p_b * z104;
    const Scalar z106 = z84 + z86 * z102;
    const Scalar z107 = z88 + z101;
    const Scalar z108 = n1 / z103;
    const Scalar z109 = z4 * z98 - z105;
    const Scalar z110 = z99 - z5 * z76 + z4 * z107;
    const Scalar z111 = z69 + z109 * z102;
    const Scalar z112 = a_alpha * z13 - z110 + a_beta * z93;
    const Scalar z113 = z108 * z106;
    const Scalar z114 = z108 * z111;
    const Scalar z115 = z85 - z112 * z102;
    const Scalar z116 = z86 * z97 - z102 * z113;
    const Scalar z117 = z109 * z97 - z102 * z114;
    const Scalar z118 = z108 * z115;
    const Scalar z119 = z112 * z97 + z102 * z118;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n1;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = -z53;
    result.M[11] = z10;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = z10;
    result.M[15] = z36;
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
    result.C[10] = -z84;
    result.C[11] = z86;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = -z69;
    result.C[15] = z109;
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
    result.K[14] = z85;
    result.K[15] = z112;
    result.F[0] = -a_x;
    result.F[1] = -a_y;
    result.F[2] = z74;
    result.F[3] = -z95;
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
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = n0;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = z118;
    result.A[31] = -z119;
    result.A[32] = n1;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = -z113;
    result.A[55] = -z116;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n1;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = -z114;
    result.A[63] = -z117;
    if (!(traits::regular(-z103, -z53) && traits::regular(z36, z36))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[10] * result.M[11] * result.M[14] * result.M[15] * result.C[10] * result.C[11]
        * result.C[14] * result.C[15] * result.K[14] * result.K[15]) * (n0 * result.F[0] * result.F[1] * result.F[2]
        * result.F[3] * result.A[30] * result.A[31] * result.A[54] * result.A[55] * result.A[62] * result.A[63]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace falling_plate
