// SPDX-License-Identifier: MIT
// helicopter_on_a_circle_pitching_blades: The helicopter's rotor with blades of variable pitch
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions
// Parameters set at run time: theta, omega, alpha, alpha_c, k, c
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                9          0             0                  1       0     11       -
//   kinematics               68              113          0             0                  6       0    193     198
//   mass_matrix               4                8          0             0                  4       0     20      20
//   bias                     56               69          0             0                  5       0    135     160
//   inverse_dynamics         65               74          0             0                  5       0    149     174
//   forward_dynamics         61               82          1             0                  5       0    154     179
//   energy                   40               53          0             0                  5       0    103     124
//   reactions                48               65          0             0                  5       0    123     153
//
// Not computed because this mechanism does not need it:
//   kinematics: of 165 results 25 vanish identically, 68 repeat another up to sign
//   mass_matrix: of 25 results 20 vanish identically
//   reactions: of 6 results 2 vanish identically
//
// To write this file again:
//   helicopter_on_a_circle_pitching_blades_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,reactions --output helicopter_on_a_circle_pitching_blades.hpp
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

namespace helicopter_on_a_circle_pitching_blades {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "helicopter_on_a_circle_pitching_blades";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xeaec143920cfa1f4ULL;
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 6;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar theta;  ///< parameter [rad or 1]
    Scalar omega;  ///< parameter [rad/s]
    Scalar alpha;  ///< parameter [rad or 1]
    Scalar alpha_c;  ///< parameter [rad or 1]
    Scalar k;  ///< parameter [N m]
    Scalar c;  ///< parameter [N m s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::theta, &Parameters::omega, &Parameters::alpha,
          &Parameters::alpha_c, &Parameters::k, &Parameters::c};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar phi;  ///< coordinate [rad or 1]
    Scalar alpha_1;  ///< coordinate [rad or 1]
    Scalar alpha_2;  ///< coordinate [rad or 1]
    Scalar alpha_3;  ///< coordinate [rad or 1]
    Scalar alpha_4;  ///< coordinate [rad or 1]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::phi, &Coordinates::alpha_1, &Coordinates::alpha_2,
          &Coordinates::alpha_3, &Coordinates::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar phi;  ///< its rate [rad/s]
    Scalar alpha_1;  ///< its rate [rad/s]
    Scalar alpha_2;  ///< its rate [rad/s]
    Scalar alpha_3;  ///< its rate [rad/s]
    Scalar alpha_4;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::phi, &Velocities::alpha_1, &Velocities::alpha_2,
          &Velocities::alpha_3, &Velocities::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar phi;  ///< its second rate [rad/s^2]
    Scalar alpha_1;  ///< its second rate [rad/s^2]
    Scalar alpha_2;  ///< its second rate [rad/s^2]
    Scalar alpha_3;  ///< its second rate [rad/s^2]
    Scalar alpha_4;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::phi, &Accelerations::alpha_1,
          &Accelerations::alpha_2, &Accelerations::alpha_3, &Accelerations::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar phi;  ///< works with the rate of phi [N m]
    Scalar alpha_1;  ///< works with the rate of alpha_1 [N m]
    Scalar alpha_2;  ///< works with the rate of alpha_2 [N m]
    Scalar alpha_3;  ///< works with the rate of alpha_3 [N m]
    Scalar alpha_4;  ///< works with the rate of alpha_4 [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::phi, &GeneralizedForces::alpha_1,
          &GeneralizedForces::alpha_2, &GeneralizedForces::alpha_3, &GeneralizedForces::alpha_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C;  ///< motor [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C};
      return members_[i_];
    }
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
    Scalar s_theta;
    Scalar c_theta;
    Scalar z35;
    Scalar z42;
    Scalar z43;
    Scalar z312;  ///< force on upwards, x
    Scalar z409;
    Scalar z437;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4000 = traits::constant(4000.0, 4000.0f, "4000/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    parameters.theta = n0_3;
    parameters.omega = n0_2;
    parameters.alpha = n0_2;
    parameters.alpha_c = n0_1;
    parameters.k = n4000;
    parameters.c = n8;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n120 = traits::constant(120.0, 120.0f, "120/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar p_omega = parameters.omega;
    const Scalar p_theta = parameters.theta;
    const Scalar p_k = parameters.k;
    Scalar s_theta, c_theta;
    traits::sincos(p_theta, s_theta, c_theta);
    const Scalar z35 = n100 * p_omega;
    const Scalar z42 = p_omega * s_theta;
    const Scalar z43 = p_omega * c_theta;
    const Scalar z241 = p_omega * p_omega;
    const Scalar z242 = n100 * z241;
    const Scalar z308 = z42 * z43;
    const Scalar z312 = n120 * z242;  // force on upwards, x
    const Scalar z409 = n0_5 * p_k;
    const Scalar z437 = n665 * z308;
    precomputed.s_theta = s_theta;
    precomputed.c_theta = c_theta;
    precomputed.z35 = z35;
    precomputed.z42 = z42;
    precomputed.z43 = z43;
    precomputed.z312 = z312;
    precomputed.z409 = z409;
    precomputed.z437 = z437;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar p_alpha = parameters.alpha;
    const Scalar p_alpha_c = parameters.alpha_c;
    state.time = n0;
    state.q.phi = n0;
    state.q.alpha_1 = p_alpha + p_alpha_c;
    state.q.alpha_2 = p_alpha;
    state.q.alpha_3 = p_alpha - p_alpha_c;
    state.q.alpha_4 = p_alpha;
    state.v.phi = n30;
    state.v.alpha_1 = n0;
    state.v.alpha_2 = -n30 * p_alpha_c;
    state.v.alpha_3 = n0;
    state.v.alpha_4 = -state.v.alpha_2;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> span_1_position;  ///< centre of mass of span_1 [m]
    std::array<Scalar, 9> span_1_rotation;  ///< from the axes of span_1 to the ground's (3 x 3)
    std::array<Scalar, 3> span_1_velocity;  ///< velocity of the centre of mass of span_1 [m/s]
    std::array<Scalar, 3> span_1_angular_velocity;  ///< angular velocity of span_1 [rad/s]
    std::array<Scalar, 3> blade_1_position;  ///< centre of mass of blade_1 [m]
    std::array<Scalar, 9> blade_1_rotation;  ///< from the axes of blade_1 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_1_velocity;  ///< velocity of the centre of mass of blade_1 [m/s]
    std::array<Scalar, 3> blade_1_angular_velocity;  ///< angular velocity of blade_1 [rad/s]
    std::array<Scalar, 3> span_2_position;  ///< centre of mass of span_2 [m]
    std::array<Scalar, 9> span_2_rotation;  ///< from the axes of span_2 to the ground's (3 x 3)
    std::array<Scalar, 3> span_2_velocity;  ///< velocity of the centre of mass of span_2 [m/s]
    std::array<Scalar, 3> span_2_angular_velocity;  ///< angular velocity of span_2 [rad/s]
    std::array<Scalar, 3> blade_2_position;  ///< centre of mass of blade_2 [m]
    std::array<Scalar, 9> blade_2_rotation;  ///< from the axes of blade_2 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_2_velocity;  ///< velocity of the centre of mass of blade_2 [m/s]
    std::array<Scalar, 3> blade_2_angular_velocity;  ///< angular velocity of blade_2 [rad/s]
    std::array<Scalar, 3> span_3_position;  ///< centre of mass of span_3 [m]
    std::array<Scalar, 9> span_3_rotation;  ///< from the axes of span_3 to the ground's (3 x 3)
    std::array<Scalar, 3> span_3_velocity;  ///< velocity of the centre of mass of span_3 [m/s]
    std::array<Scalar, 3> span_3_angular_velocity;  ///< angular velocity of span_3 [rad/s]
    std::array<Scalar, 3> blade_3_position;  ///< centre of mass of blade_3 [m]
    std::array<Scalar, 9> blade_3_rotation;  ///< from the axes of blade_3 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_3_velocity;  ///< velocity of the centre of mass of blade_3 [m/s]
    std::array<Scalar, 3> blade_3_angular_velocity;  ///< angular velocity of blade_3 [rad/s]
    std::array<Scalar, 3> span_4_position;  ///< centre of mass of span_4 [m]
    std::array<Scalar, 9> span_4_rotation;  ///< from the axes of span_4 to the ground's (3 x 3)
    std::array<Scalar, 3> span_4_velocity;  ///< velocity of the centre of mass of span_4 [m/s]
    std::array<Scalar, 3> span_4_angular_velocity;  ///< angular velocity of span_4 [rad/s]
    std::array<Scalar, 3> blade_4_position;  ///< centre of mass of blade_4 [m]
    std::array<Scalar, 9> blade_4_rotation;  ///< from the axes of blade_4 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_4_velocity;  ///< velocity of the centre of mass of blade_4 [m/s]
    std::array<Scalar, 3> blade_4_angular_velocity;  ///< angular velocity of blade_4 [rad/s]
    std::array<Scalar, 3> A_position;  ///< position of A [m]
    std::array<Scalar, 3> A_velocity;  ///< velocity of the material point at A [m/s]
    std::array<Scalar, 15> A_jacobian;  ///< partial velocities of A (3 x 5)
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

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar X;  ///< reaction along 'X' [kg m s^-2]
    Scalar Y;  ///< reaction along 'Y' [kg m s^-2]
    Scalar Z;  ///< reaction along 'Z' [kg m s^-2]
    Scalar M_x;  ///< reaction along 'M_x' [kg m^2 s^-2]
    Scalar M_y;  ///< reaction along 'M_y' [kg m^2 s^-2]
    Scalar M_z;  ///< reaction along 'M_z' [kg m^2 s^-2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::X, &Reactions::Y, &Reactions::Z, &Reactions::M_x,
          &Reactions::M_y, &Reactions::M_z};
      return members_[i_];
    }
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar s_theta = precomputed.s_theta;
    const Scalar c_theta = precomputed.c_theta;
    const Scalar z35 = precomputed.z35;
    const Scalar z42 = precomputed.z42;
    const Scalar z43 = precomputed.z43;
    const Scalar z2 = p_omega * t;
    const Scalar angles_[] = {z2, q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z3 = sines_[0], z4 = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar s_alpha_1 = sines_[2], c_alpha_1 = cosines_[2];
    const Scalar s_alpha_2 = sines_[3], c_alpha_2 = cosines_[3];
    const Scalar s_alpha_3 = sines_[4], c_alpha_3 = cosines_[4];
    const Scalar s_alpha_4 = sines_[5], c_alpha_4 = cosines_[5];
    const Scalar z38 = z4 * c_theta;
    const Scalar z40 = z3 * c_theta;
    const Scalar z50 = c_phi * z42;
    const Scalar z51 = s_phi * z42;
    const Scalar z36 = z3 * z35;  // velocity of outwards, x
    const Scalar z37 = z4 * z35;  // velocity of outwards, y
    const Scalar z39 = z4 * s_theta;
    const Scalar z41 = z3 * s_theta;
    const Scalar z52 = v_phi + z43;
    const Scalar z48 = s_theta * c_phi;
    const Scalar z49 = s_theta * s_phi;
    const Scalar z55 = p_omega + c_theta * v_phi;  // angular velocity of rotor, z
    const Scalar z33 = n100 * z4;
    const Scalar z34 = n100 * z3;
    const Scalar z109 = n3 * z52;
    const Scalar z60 = c_theta * s_alpha_1 - c_alpha_1 * z49;
    const Scalar z61 = c_theta * c_alpha_1 + s_alpha_1 * z49;
    const Scalar z67 = v_alpha_1 * z48 + z55;  // angular velocity of blade_1, z
    const Scalar z72 = c_theta * s_alpha_2 - c_alpha_2 * z48;
    const Scalar z73 = c_theta * c_alpha_2 + s_alpha_2 * z48;
    const Scalar z79 = v_alpha_2 * z49 - z55;  // angular velocity of blade_2, z
    const Scalar z84 = c_theta * s_alpha_3 + c_alpha_3 * z49;
    const Scalar z85 = c_theta * c_alpha_3 - s_alpha_3 * z49;
    const Scalar z91 = v_alpha_3 * z48 - z55;  // angular velocity of blade_3, z
    const Scalar z96 = c_theta * s_alpha_4 + c_alpha_4 * z48;
    const Scalar z97 = c_theta * c_alpha_4 - s_alpha_4 * z48;
    const Scalar z103 = v_alpha_4 * z49 + z55;  // angular velocity of blade_4, z
    const Scalar z106 = n3 * z48;
    const Scalar z110 = n3 * z51;
    const Scalar z44 = z3 * s_phi - c_phi * z38;
    const Scalar z116 = n3 * z49;
    const Scalar z45 = z3 * c_phi + s_phi * z38;
    const Scalar z46 = z4 * s_phi + c_phi * z40;
    const Scalar z47 = z4 * c_phi - s_phi * z40;
    const Scalar z119 = n3 * z50;
    const Scalar z53 = v_phi * z39;  // angular velocity of rotor, x
    const Scalar z54 = v_phi * z41;  // angular velocity of rotor, y
    const Scalar z113 = c_theta * z110 - z49 * z109;
    const Scalar z122 = c_theta * z119 - z48 * z109;
    const Scalar z56 = s_alpha_1 * z39 + c_alpha_1 * z45;
    const Scalar z57 = s_alpha_1 * z45 - c_alpha_1 * z39;
    const Scalar z58 = s_alpha_1 * z41 - c_alpha_1 * z47;
    const Scalar z59 = c_alpha_1 * z41 + s_alpha_1 * z47;
    const Scalar z65 = v_alpha_1 * z44 + z53;  // angular velocity of blade_1, x
    const Scalar z66 = v_alpha_1 * z46 - z54;  // angular velocity of blade_1, y
    const Scalar z68 = s_alpha_2 * z39 - c_alpha_2 * z44;
    const Scalar z104 = n3 * z44;
    const Scalar z105 = n3 * z46;
    const Scalar z114 = n3 * z45;
    const Scalar z115 = n3 * z47;
    const Scalar z69 = c_alpha_2 * z39 + s_alpha_2 * z44;
    const Scalar z70 = s_alpha_2 * z41 + c_alpha_2 * z46;
    const Scalar z71 = s_alpha_2 * z46 - c_alpha_2 * z41;
    const Scalar z77 = v_alpha_2 * z45 + z53;  // angular velocity of blade_2, x
    const Scalar z78 = v_alpha_2 * z47 - z54;  // angular velocity of blade_2, y
    const Scalar z80 = s_alpha_3 * z39 - c_alpha_3 * z45;
    const Scalar z81 = c_alpha_3 * z39 + s_alpha_3 * z45;
    const Scalar z82 = s_alpha_3 * z41 + c_alpha_3 * z47;
    const Scalar z83 = s_alpha_3 * z47 - c_alpha_3 * z41;
    const Scalar z89 = v_alpha_3 * z44 - z53;  // angular velocity of blade_3, x
    const Scalar z90 = v_alpha_3 * z46 + z54;  // angular velocity of blade_3, y
    const Scalar z92 = s_alpha_4 * z39 + c_alpha_4 * z44;
    const Scalar z93 = s_alpha_4 * z44 - c_alpha_4 * z39;
    const Scalar z94 = s_alpha_4 * z41 - c_alpha_4 * z46;
    const Scalar z95 = c_alpha_4 * z41 + s_alpha_4 * z46;
    const Scalar z101 = v_alpha_4 * z45 - z53;  // angular velocity of blade_4, x
    const Scalar z102 = v_alpha_4 * z47 + z54;  // angular velocity of blade_4, y
    const Scalar z107 = z33 - z104;
    const Scalar z108 = z34 + z105;
    const Scalar z111 = z36 + z39 * z110 + z45 * z109;
    const Scalar z112 = z37 - z41 * z110 + z47 * z109;
    const Scalar z117 = z33 - z114;
    const Scalar z118 = z34 + z115;
    const Scalar z120 = z36 + z39 * z119 - z44 * z109;
    const Scalar z121 = z37 - z41 * z119 - z46 * z109;
    const Scalar z123 = z33 + z104;
    const Scalar z124 = z34 - z105;
    const Scalar z125 = z36 - z39 * z110 - z45 * z109;
    const Scalar z126 = z37 + z41 * z110 - z47 * z109;
    const Scalar z127 = z33 + z114;
    const Scalar z128 = z34 - z115;
    const Scalar z129 = z36 - z39 * z119 + z44 * z109;
    const Scalar z130 = z37 + z41 * z119 + z46 * z109;
    result.span_1_position[0] = z107;
    result.span_1_position[1] = z108;
    result.span_1_position[2] = z106;
    result.span_1_rotation[0] = -z44;
    result.span_1_rotation[1] = z46;
    result.span_1_rotation[2] = z48;
    result.span_1_rotation[3] = -z45;
    result.span_1_rotation[4] = z47;
    result.span_1_rotation[5] = -z49;
    result.span_1_rotation[6] = -z39;
    result.span_1_rotation[7] = -z41;
    result.span_1_rotation[8] = c_theta;
    result.span_1_velocity[0] = -z111;
    result.span_1_velocity[1] = z112;
    result.span_1_velocity[2] = z113;
    result.span_1_angular_velocity[0] = -z53;
    result.span_1_angular_velocity[1] = -z54;
    result.span_1_angular_velocity[2] = z55;
    result.blade_1_position[0] = z33;
    result.blade_1_position[1] = z34;
    result.blade_1_position[2] = n0;
    result.blade_1_rotation[0] = -z44;
    result.blade_1_rotation[1] = z46;
    result.blade_1_rotation[2] = z48;
    result.blade_1_rotation[3] = -z56;
    result.blade_1_rotation[4] = -z58;
    result.blade_1_rotation[5] = z60;
    result.blade_1_rotation[6] = z57;
    result.blade_1_rotation[7] = -z59;
    result.blade_1_rotation[8] = z61;
    result.blade_1_velocity[0] = -z36;
    result.blade_1_velocity[1] = z37;
    result.blade_1_velocity[2] = n0;
    result.blade_1_angular_velocity[0] = -z65;
    result.blade_1_angular_velocity[1] = z66;
    result.blade_1_angular_velocity[2] = z67;
    result.span_2_position[0] = z117;
    result.span_2_position[1] = z118;
    result.span_2_position[2] = -z116;
    result.span_2_rotation[0] = -z45;
    result.span_2_rotation[1] = z47;
    result.span_2_rotation[2] = -z49;
    result.span_2_rotation[3] = z44;
    result.span_2_rotation[4] = -z46;
    result.span_2_rotation[5] = -z48;
    result.span_2_rotation[6] = -z39;
    result.span_2_rotation[7] = -z41;
    result.span_2_rotation[8] = c_theta;
    result.span_2_velocity[0] = -z120;
    result.span_2_velocity[1] = z121;
    result.span_2_velocity[2] = z122;
    result.span_2_angular_velocity[0] = -z53;
    result.span_2_angular_velocity[1] = -z54;
    result.span_2_angular_velocity[2] = z55;
    result.blade_2_position[0] = z33;
    result.blade_2_position[1] = z34;
    result.blade_2_position[2] = n0;
    result.blade_2_rotation[0] = -z45;
    result.blade_2_rotation[1] = z47;
    result.blade_2_rotation[2] = -z49;
    result.blade_2_rotation[3] = -z68;
    result.blade_2_rotation[4] = -z70;
    result.blade_2_rotation[5] = z72;
    result.blade_2_rotation[6] = -z69;
    result.blade_2_rotation[7] = z71;
    result.blade_2_rotation[8] = z73;
    result.blade_2_velocity[0] = -z36;
    result.blade_2_velocity[1] = z37;
    result.blade_2_velocity[2] = n0;
    result.blade_2_angular_velocity[0] = -z77;
    result.blade_2_angular_velocity[1] = z78;
    result.blade_2_angular_velocity[2] = -z79;
    result.span_3_position[0] = z123;
    result.span_3_position[1] = z124;
    result.span_3_position[2] = -z106;
    result.span_3_rotation[0] = z44;
    result.span_3_rotation[1] = -z46;
    result.span_3_rotation[2] = -z48;
    result.span_3_rotation[3] = z45;
    result.span_3_rotation[4] = -z47;
    result.span_3_rotation[5] = z49;
    result.span_3_rotation[6] = -z39;
    result.span_3_rotation[7] = -z41;
    result.span_3_rotation[8] = c_theta;
    result.span_3_velocity[0] = -z125;
    result.span_3_velocity[1] = z126;
    result.span_3_velocity[2] = -z113;
    result.span_3_angular_velocity[0] = -z53;
    result.span_3_angular_velocity[1] = -z54;
    result.span_3_angular_velocity[2] = z55;
    result.blade_3_position[0] = z33;
    result.blade_3_position[1] = z34;
    result.blade_3_position[2] = n0;
    result.blade_3_rotation[0] = z44;
    result.blade_3_rotation[1] = -z46;
    result.blade_3_rotation[2] = -z48;
    result.blade_3_rotation[3] = -z80;
    result.blade_3_rotation[4] = -z82;
    result.blade_3_rotation[5] = z84;
    result.blade_3_rotation[6] = -z81;
    result.blade_3_rotation[7] = z83;
    result.blade_3_rotation[8] = z85;
    result.blade_3_velocity[0] = -z36;
    result.blade_3_velocity[1] = z37;
    result.blade_3_velocity[2] = n0;
    result.blade_3_angular_velocity[0] = z89;
    result.blade_3_angular_velocity[1] = -z90;
    result.blade_3_angular_velocity[2] = -z91;
    result.span_4_position[0] = z127;
    result.span_4_position[1] = z128;
    result.span_4_position[2] = z116;
    result.span_4_rotation[0] = z45;
    result.span_4_rotation[1] = -z47;
    result.span_4_rotation[2] = z49;
    result.span_4_rotation[3] = -z44;
    result.span_4_rotation[4] = z46;
    result.span_4_rotation[5] = z48;
    result.span_4_rotation[6] = -z39;
    result.span_4_rotation[7] = -z41;
    result.span_4_rotation[8] = c_theta;
    result.span_4_velocity[0] = -z129;
    result.span_4_velocity[1] = z130;
    result.span_4_velocity[2] = -z122;
    result.span_4_angular_velocity[0] = -z53;
    result.span_4_angular_velocity[1] = -z54;
    result.span_4_angular_velocity[2] = z55;
    result.blade_4_position[0] = z33;
    result.blade_4_position[1] = z34;
    result.blade_4_position[2] = n0;
    result.blade_4_rotation[0] = z45;
    result.blade_4_rotation[1] = -z47;
    result.blade_4_rotation[2] = z49;
    result.blade_4_rotation[3] = -z92;
    result.blade_4_rotation[4] = -z94;
    result.blade_4_rotation[5] = z96;
    result.blade_4_rotation[6] = z93;
    result.blade_4_rotation[7] = -z95;
    result.blade_4_rotation[8] = z97;
    result.blade_4_velocity[0] = -z36;
    result.blade_4_velocity[1] = z37;
    result.blade_4_velocity[2] = n0;
    result.blade_4_angular_velocity[0] = z101;
    result.blade_4_angular_velocity[1] = -z102;
    result.blade_4_angular_velocity[2] = z103;
    result.A_position[0] = z33;
    result.A_position[1] = z34;
    result.A_position[2] = n0;
    result.A_velocity[0] = -z36;
    result.A_velocity[1] = z37;
    result.A_velocity[2] = n0;
    result.A_jacobian[0] = n0;
    result.A_jacobian[3] = n0;
    result.A_jacobian[6] = n0;
    result.A_jacobian[9] = n0;
    result.A_jacobian[12] = n0;
    result.A_jacobian[1] = n0;
    result.A_jacobian[4] = n0;
    result.A_jacobian[7] = n0;
    result.A_jacobian[10] = n0;
    result.A_jacobian[13] = n0;
    result.A_jacobian[2] = n0;
    result.A_jacobian[5] = n0;
    result.A_jacobian[8] = n0;
    result.A_jacobian[11] = n0;
    result.A_jacobian[14] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 25>& mass) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1331_6 = traits::constant(1331.6, 1331.6f, "6658/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar angles_[] = {q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha_1 = sines_[0];
    const Scalar s_alpha_2 = sines_[1];
    const Scalar s_alpha_3 = sines_[2];
    const Scalar s_alpha_4 = sines_[3];
    const Scalar z143 = n0_4 * s_alpha_4;
    const Scalar z151 = n0_4 * s_alpha_3;
    const Scalar z159 = n0_4 * s_alpha_2;
    const Scalar z168 = n0_4 * s_alpha_1;
    const Scalar z146 = s_alpha_4 * z143;
    const Scalar z154 = s_alpha_3 * z151;
    const Scalar z162 = s_alpha_2 * z159;
    const Scalar z171 = s_alpha_1 * z168;
    const Scalar z148 = n1331_6 - z146;
    const Scalar z158 = z148 - z154;
    const Scalar z167 = z158 - z162;
    const Scalar z176 = z167 - z171;
    mass[0] = z176;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0_4;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0_4;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0_4;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z42 = precomputed.z42;
    const Scalar z43 = precomputed.z43;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z52 = v_phi + z43;
    const Scalar z50 = c_phi * z42;
    const Scalar z51 = s_phi * z42;
    const Scalar z224 = v_phi * s_phi;
    const Scalar z222 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z233 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z230 = v_phi * c_phi;
    const Scalar z228 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z237 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z62 = s_alpha_1 * z52 - c_alpha_1 * z51;
    const Scalar z63 = c_alpha_1 * z52 + s_alpha_1 * z51;
    const Scalar z64 = v_alpha_1 + z50;
    const Scalar z74 = s_alpha_2 * z52 - c_alpha_2 * z50;
    const Scalar z75 = c_alpha_2 * z52 + s_alpha_2 * z50;
    const Scalar z76 = v_alpha_2 - z51;
    const Scalar z86 = s_alpha_3 * z52 + c_alpha_3 * z51;
    const Scalar z87 = s_alpha_3 * z51 - c_alpha_3 * z52;
    const Scalar z88 = v_alpha_3 - z50;
    const Scalar z98 = s_alpha_4 * z52 + c_alpha_4 * z50;
    const Scalar z99 = s_alpha_4 * z50 - c_alpha_4 * z52;
    const Scalar z100 = v_alpha_4 + z51;
    const Scalar z225 = v_alpha_1 + p_alpha_c * z224;
    const Scalar z231 = v_alpha_2 + p_alpha_c * z230;
    const Scalar z235 = v_alpha_3 - p_alpha_c * z224;
    const Scalar z239 = v_alpha_4 - p_alpha_c * z230;
    const Scalar z247 = v_phi * z51;  // angular acceleration of rotor, x
    const Scalar z248 = v_phi * z50;  // angular acceleration of rotor, y
    const Scalar z223 = p_k * z222;
    const Scalar z229 = p_k * z228;
    const Scalar z234 = p_k * z233;
    const Scalar z238 = p_k * z237;
    const Scalar z250 = s_alpha_1 * z248;
    const Scalar z256 = s_alpha_2 * z247;
    const Scalar z262 = s_alpha_3 * z248;
    const Scalar z268 = s_alpha_4 * z247;
    const Scalar z227 = z225 * p_c;
    const Scalar z232 = p_c * z231;
    const Scalar z236 = p_c * z235;
    const Scalar z240 = p_c * z239;
    const Scalar z274 = z98 * z100;
    const Scalar z281 = z86 * z88;
    const Scalar z287 = z74 * z75;
    const Scalar z288 = z74 * z76;
    const Scalar z294 = z62 * z63;
    const Scalar z295 = z62 * z64;
    const Scalar z254 = v_alpha_1 * z62 - z250;  // angular acceleration of blade_1, z
    const Scalar z260 = v_alpha_2 * z74 + z256;  // angular acceleration of blade_2, z
    const Scalar z266 = v_alpha_3 * z86 + z262;  // angular acceleration of blade_3, z
    const Scalar z272 = v_alpha_4 * z98 - z268;  // angular acceleration of blade_4, z
    const Scalar z273 = z98 * z99;
    const Scalar z280 = z86 * z87;
    const Scalar z290 = n0_4 * (z248 - z287);  // moment on blade_2, x
    const Scalar z297 = n0_4 * (z247 - z294);  // moment on blade_1, x
    const Scalar z275 = z272 + z274;
    const Scalar z276 = n0_4 * (z248 - z273);  // moment on blade_4, x
    const Scalar z282 = z266 + z281;
    const Scalar z283 = n0_4 * (z247 - z280);  // moment on blade_3, x
    const Scalar z289 = z260 + z288;
    const Scalar z296 = z254 + z295;
    const Scalar z277 = n0_4 * z275;  // moment on blade_4, z
    const Scalar z284 = n0_4 * z282;  // moment on blade_3, z
    const Scalar z291 = n0_4 * z289;  // moment on blade_2, z
    const Scalar z298 = n0_4 * z296;  // moment on blade_1, z
    const Scalar z314 = z223 - z227 + z297;
    const Scalar z315 = z229 + z232 - z290;
    const Scalar z279 = c_alpha_4 * z277;
    const Scalar z286 = c_alpha_3 * z284;
    const Scalar z293 = c_alpha_2 * z291;
    const Scalar z300 = c_alpha_1 * z298;
    const Scalar z316 = z234 + z236 + z283;
    const Scalar z317 = z238 - z240 - z276;
    const Scalar z305 = z279 + z286 + z293 + z300;  // moment on rotor, z
    const Scalar z313 = p_alpha_c * (s_phi * (z223 + z234 - z227 + z236) - c_phi * (z229 + z238 + z232 - z240)) + z305;
    forces.phi = -z313;
    forces.alpha_1 = -z314;
    forces.alpha_2 = z315;
    forces.alpha_3 = z316;
    forces.alpha_4 = -z317;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar a_alpha_1 = accelerations.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar a_alpha_2 = accelerations.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar a_alpha_3 = accelerations.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar a_alpha_4 = accelerations.alpha_4;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z42 = precomputed.z42;
    const Scalar z43 = precomputed.z43;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z51 = s_phi * z42;
    const Scalar z52 = v_phi + z43;
    const Scalar z50 = c_phi * z42;
    const Scalar z224 = v_phi * s_phi;
    const Scalar z222 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z233 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z230 = v_phi * c_phi;
    const Scalar z228 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z237 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z62 = s_alpha_1 * z52 - c_alpha_1 * z51;
    const Scalar z63 = c_alpha_1 * z52 + s_alpha_1 * z51;
    const Scalar z64 = v_alpha_1 + z50;
    const Scalar z74 = s_alpha_2 * z52 - c_alpha_2 * z50;
    const Scalar z75 = c_alpha_2 * z52 + s_alpha_2 * z50;
    const Scalar z76 = v_alpha_2 - z51;
    const Scalar z86 = s_alpha_3 * z52 + c_alpha_3 * z51;
    const Scalar z87 = s_alpha_3 * z51 - c_alpha_3 * z52;
    const Scalar z88 = v_alpha_3 - z50;
    const Scalar z98 = s_alpha_4 * z52 + c_alpha_4 * z50;
    const Scalar z99 = s_alpha_4 * z50 - c_alpha_4 * z52;
    const Scalar z100 = v_alpha_4 + z51;
    const Scalar z225 = v_alpha_1 + p_alpha_c * z224;
    const Scalar z231 = v_alpha_2 + p_alpha_c * z230;
    const Scalar z235 = v_alpha_3 - p_alpha_c * z224;
    const Scalar z239 = v_alpha_4 - p_alpha_c * z230;
    const Scalar z247 = v_phi * z51;  // angular acceleration of rotor, x
    const Scalar z248 = v_phi * z50;  // angular acceleration of rotor, y
    const Scalar z223 = p_k * z222;
    const Scalar z229 = p_k * z228;
    const Scalar z234 = p_k * z233;
    const Scalar z238 = p_k * z237;
    const Scalar z323 = a_phi * c_alpha_1 + s_alpha_1 * z248;
    const Scalar z324 = a_alpha_1 - z247;  // angular acceleration of blade_1, x
    const Scalar z328 = a_phi * c_alpha_2 - s_alpha_2 * z247;
    const Scalar z329 = a_alpha_2 - z248;  // angular acceleration of blade_2, x
    const Scalar z333 = a_phi * c_alpha_3 - s_alpha_3 * z248;
    const Scalar z334 = a_alpha_3 + z247;  // angular acceleration of blade_3, x
    const Scalar z338 = a_phi * c_alpha_4 + s_alpha_4 * z247;
    const Scalar z339 = a_alpha_4 + z248;  // angular acceleration of blade_4, x
    const Scalar z227 = z225 * p_c;
    const Scalar z232 = p_c * z231;
    const Scalar z236 = p_c * z235;
    const Scalar z240 = p_c * z239;
    const Scalar z274 = z98 * z100;
    const Scalar z281 = z86 * z88;
    const Scalar z287 = z74 * z75;
    const Scalar z288 = z74 * z76;
    const Scalar z294 = z62 * z63;
    const Scalar z295 = z62 * z64;
    const Scalar z273 = z98 * z99;
    const Scalar z280 = z86 * z87;
    const Scalar z326 = v_alpha_1 * z62 - z323;  // angular acceleration of blade_1, z
    const Scalar z331 = v_alpha_2 * z74 - z328;  // angular acceleration of blade_2, z
    const Scalar z341 = v_alpha_4 * z98 - z338;  // angular acceleration of blade_4, z
    const Scalar z336 = v_alpha_3 * z86 - z333;  // angular acceleration of blade_3, z
    const Scalar z353 = n0_4 * (z287 + z329);  // moment on blade_2, x
    const Scalar z343 = n0_4 * (z273 - z339);  // moment on blade_4, x
    const Scalar z342 = z274 + z341;
    const Scalar z347 = z281 + z336;
    const Scalar z352 = z288 + z331;
    const Scalar z357 = z295 + z326;
    const Scalar z348 = n0_4 * (z280 - z334);  // moment on blade_3, x
    const Scalar z344 = n0_4 * z342;  // moment on blade_4, z
    const Scalar z349 = n0_4 * z347;  // moment on blade_3, z
    const Scalar z354 = n0_4 * z352;  // moment on blade_2, z
    const Scalar z359 = n0_4 * z357;  // moment on blade_1, z
    const Scalar z358 = n0_4 * (z294 + z324);  // moment on blade_1, x
    const Scalar z346 = c_alpha_4 * z344;
    const Scalar z351 = c_alpha_3 * z349;
    const Scalar z356 = c_alpha_2 * z354;
    const Scalar z361 = c_alpha_1 * z359;
    const Scalar z371 = z223 - z227 - z358;
    const Scalar z364 = n1330 * a_phi - z346 - z351 - z356 - z361;  // moment on rotor, z
    const Scalar z372 = z229 + z232 + z353;
    const Scalar z373 = z234 + z236 - z348;
    const Scalar z374 = z238 - z240 + z343;
    const Scalar z370 = p_alpha_c * (s_phi * (z223 + z234 - z227 + z236) - c_phi * (z229 + z238 + z232 - z240)) - z364;
    forces.phi = -z370;
    forces.alpha_1 = -z371;
    forces.alpha_2 = z372;
    forces.alpha_3 = z373;
    forces.alpha_4 = -z374;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1331_6 = traits::constant(1331.6, 1331.6f, "6658/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar u_C = inputs.C;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z42 = precomputed.z42;
    const Scalar z43 = precomputed.z43;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z52 = v_phi + z43;
    const Scalar z50 = c_phi * z42;
    const Scalar z51 = s_phi * z42;
    const Scalar z143 = n0_4 * s_alpha_4;
    const Scalar z224 = v_phi * s_phi;
    const Scalar z222 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z233 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z151 = n0_4 * s_alpha_3;
    const Scalar z230 = v_phi * c_phi;
    const Scalar z228 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z237 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z159 = n0_4 * s_alpha_2;
    const Scalar z168 = n0_4 * s_alpha_1;
    const Scalar z62 = s_alpha_1 * z52 - c_alpha_1 * z51;
    const Scalar z63 = c_alpha_1 * z52 + s_alpha_1 * z51;
    const Scalar z64 = v_alpha_1 + z50;
    const Scalar z74 = s_alpha_2 * z52 - c_alpha_2 * z50;
    const Scalar z75 = c_alpha_2 * z52 + s_alpha_2 * z50;
    const Scalar z76 = v_alpha_2 - z51;
    const Scalar z86 = s_alpha_3 * z52 + c_alpha_3 * z51;
    const Scalar z87 = s_alpha_3 * z51 - c_alpha_3 * z52;
    const Scalar z88 = v_alpha_3 - z50;
    const Scalar z98 = s_alpha_4 * z52 + c_alpha_4 * z50;
    const Scalar z99 = s_alpha_4 * z50 - c_alpha_4 * z52;
    const Scalar z100 = v_alpha_4 + z51;
    const Scalar z146 = s_alpha_4 * z143;
    const Scalar z154 = s_alpha_3 * z151;
    const Scalar z162 = s_alpha_2 * z159;
    const Scalar z171 = s_alpha_1 * z168;
    const Scalar z225 = v_alpha_1 + p_alpha_c * z224;
    const Scalar z231 = v_alpha_2 + p_alpha_c * z230;
    const Scalar z235 = v_alpha_3 - p_alpha_c * z224;
    const Scalar z239 = v_alpha_4 - p_alpha_c * z230;
    const Scalar z247 = v_phi * z51;  // angular acceleration of rotor, x
    const Scalar z248 = v_phi * z50;  // angular acceleration of rotor, y
    const Scalar z223 = p_k * z222;
    const Scalar z229 = p_k * z228;
    const Scalar z234 = p_k * z233;
    const Scalar z238 = p_k * z237;
    const Scalar z148 = n1331_6 - z146;
    const Scalar z250 = s_alpha_1 * z248;
    const Scalar z256 = s_alpha_2 * z247;
    const Scalar z262 = s_alpha_3 * z248;
    const Scalar z268 = s_alpha_4 * z247;
    const Scalar z227 = z225 * p_c;
    const Scalar z232 = p_c * z231;
    const Scalar z236 = p_c * z235;
    const Scalar z240 = p_c * z239;
    const Scalar z274 = z98 * z100;
    const Scalar z281 = z86 * z88;
    const Scalar z287 = z74 * z75;
    const Scalar z288 = z74 * z76;
    const Scalar z294 = z62 * z63;
    const Scalar z295 = z62 * z64;
    const Scalar z158 = z148 - z154;
    const Scalar z254 = v_alpha_1 * z62 - z250;  // angular acceleration of blade_1, z
    const Scalar z260 = v_alpha_2 * z74 + z256;  // angular acceleration of blade_2, z
    const Scalar z266 = v_alpha_3 * z86 + z262;  // angular acceleration of blade_3, z
    const Scalar z272 = v_alpha_4 * z98 - z268;  // angular acceleration of blade_4, z
    const Scalar z273 = z98 * z99;
    const Scalar z280 = z86 * z87;
    const Scalar z290 = n0_4 * (z248 - z287);  // moment on blade_2, x
    const Scalar z297 = n0_4 * (z247 - z294);  // moment on blade_1, x
    const Scalar z167 = z158 - z162;
    const Scalar z275 = z272 + z274;
    const Scalar z276 = n0_4 * (z248 - z273);  // moment on blade_4, x
    const Scalar z282 = z266 + z281;
    const Scalar z289 = z260 + z288;
    const Scalar z296 = z254 + z295;
    const Scalar z283 = n0_4 * (z247 - z280);  // moment on blade_3, x
    const Scalar z176 = z167 - z171;
    const Scalar z277 = n0_4 * z275;  // moment on blade_4, z
    const Scalar z284 = n0_4 * z282;  // moment on blade_3, z
    const Scalar z291 = n0_4 * z289;  // moment on blade_2, z
    const Scalar z298 = n0_4 * z296;  // moment on blade_1, z
    const Scalar z314 = z223 - z227 + z297;
    const Scalar z279 = c_alpha_4 * z277;
    const Scalar z286 = c_alpha_3 * z284;
    const Scalar z293 = c_alpha_2 * z291;
    const Scalar z300 = c_alpha_1 * z298;
    const Scalar z315 = z229 + z232 - z290;
    const Scalar z305 = z279 + z286 + z293 + z300;  // moment on rotor, z
    const Scalar z316 = z234 + z236 + z283;
    const Scalar z317 = z238 - z240 - z276;
    const Scalar z385 = n1 / z176;
    const Scalar z387 = n2_5 * z314;
    const Scalar z388 = n2_5 * z315;
    const Scalar z389 = n2_5 * z316;
    const Scalar z390 = n2_5 * z317;
    const Scalar z313 = p_alpha_c * (s_phi * (z223 + z234 - z227 + z236) - c_phi * (z229 + z238 + z232 - z240)) + z305;
    const Scalar z384 = u_C + z313;
    const Scalar z386 = z384 * z385;
    accelerations.phi = z386;
    accelerations.alpha_1 = z387;
    accelerations.alpha_2 = -z388;
    accelerations.alpha_3 = -z389;
    accelerations.alpha_4 = z390;
    if (!(traits::regular(z176, z176))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.phi * accelerations.alpha_1 * accelerations.alpha_2 * accelerations.alpha_3
        * accelerations.alpha_4;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n332_5 = traits::constant(332.5, 332.5f, "665/2");
    const Scalar n60 = traits::constant(60.0, 60.0f, "60/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar u_C = inputs.C;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z35 = precomputed.z35;
    const Scalar z42 = precomputed.z42;
    const Scalar z43 = precomputed.z43;
    const Scalar z409 = precomputed.z409;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z410 = c_phi * z42;
    const Scalar z411 = s_phi * z42;
    const Scalar z412 = v_phi + z43;
    const Scalar z422 = v_phi * s_phi;
    const Scalar z426 = v_phi * c_phi;
    const Scalar z421 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z425 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z429 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z432 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z435 = s_phi * z35;
    const Scalar z436 = c_phi * z35;
    const Scalar z413 = c_alpha_1 * z412 + s_alpha_1 * z411;
    const Scalar z414 = v_alpha_1 + z410;
    const Scalar z415 = c_alpha_2 * z412 + s_alpha_2 * z410;
    const Scalar z416 = v_alpha_2 - z411;
    const Scalar z417 = s_alpha_3 * z411 - c_alpha_3 * z412;
    const Scalar z418 = v_alpha_3 - z410;
    const Scalar z419 = s_alpha_4 * z410 - c_alpha_4 * z412;
    const Scalar z420 = v_alpha_4 + z411;
    const Scalar z423 = v_alpha_1 + p_alpha_c * z422;
    const Scalar z427 = v_alpha_2 + p_alpha_c * z426;
    const Scalar z430 = v_alpha_3 - p_alpha_c * z422;
    const Scalar z433 = v_alpha_4 - p_alpha_c * z426;
    const Scalar z424 = p_c * z423;
    const Scalar z428 = p_c * z427;
    const Scalar z431 = p_c * z430;
    const Scalar z434 = p_c * z433;
    result.kinetic = n665 * z412 * z412 + n332_5 * (z410 * z410 + z411 * z411) + n60 * (z435 * z435 + z436 * z436)
        + n0_2 * (z414 * z414 + z416 * z416 + z418 * z418 + z420 * z420 + z413 * z413 + z415 * z415 + z417 * z417 + z419
        * z419);
    result.force_function = -z409 * (z421 * z421 + z425 * z425 + z429 * z429 + z432 * z432);
    result.power = v_phi * u_C - z423 * z424 - z427 * z428 - z430 * z431 - z433 * z434;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar a_alpha_1 = accelerations.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar a_alpha_2 = accelerations.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar a_alpha_3 = accelerations.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar a_alpha_4 = accelerations.alpha_4;
    const Scalar z42 = precomputed.z42;
    const Scalar z43 = precomputed.z43;
    const Scalar z312 = precomputed.z312;
    const Scalar z437 = precomputed.z437;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z440 = v_phi + z43;
    const Scalar z439 = s_phi * z42;
    const Scalar z438 = c_phi * z42;
    const Scalar z441 = s_alpha_1 * z440 - c_alpha_1 * z439;
    const Scalar z442 = c_alpha_1 * z440 + s_alpha_1 * z439;
    const Scalar z443 = v_alpha_1 + z438;
    const Scalar z444 = s_alpha_2 * z440 - c_alpha_2 * z438;
    const Scalar z445 = c_alpha_2 * z440 + s_alpha_2 * z438;
    const Scalar z446 = v_alpha_2 - z439;
    const Scalar z447 = s_alpha_3 * z440 + c_alpha_3 * z439;
    const Scalar z448 = s_alpha_3 * z439 - c_alpha_3 * z440;
    const Scalar z449 = v_alpha_3 - z438;
    const Scalar z450 = s_alpha_4 * z440 + c_alpha_4 * z438;
    const Scalar z451 = s_alpha_4 * z438 - c_alpha_4 * z440;
    const Scalar z452 = v_alpha_4 + z439;
    const Scalar z453 = v_phi * z439;  // angular acceleration of rotor, x
    const Scalar z454 = v_phi * z438;  // angular acceleration of rotor, y
    const Scalar z463 = z439 * z440;
    const Scalar z464 = z438 * z440;
    const Scalar z465 = a_phi * c_alpha_1 + s_alpha_1 * z454;
    const Scalar z466 = a_alpha_1 - z453;  // angular acceleration of blade_1, x
    const Scalar z468 = a_phi * c_alpha_2 - s_alpha_2 * z453;
    const Scalar z469 = a_alpha_2 - z454;  // angular acceleration of blade_2, x
    const Scalar z471 = a_phi * c_alpha_3 - s_alpha_3 * z454;
    const Scalar z472 = a_alpha_3 + z453;  // angular acceleration of blade_3, x
    const Scalar z474 = a_phi * c_alpha_4 + s_alpha_4 * z453;
    const Scalar z475 = a_alpha_4 + z454;  // angular acceleration of blade_4, x
    const Scalar z456 = z450 * z452;
    const Scalar z458 = z447 * z449;
    const Scalar z459 = z444 * z445;
    const Scalar z460 = z444 * z446;
    const Scalar z461 = z441 * z442;
    const Scalar z462 = z441 * z443;
    const Scalar z455 = z450 * z451;
    const Scalar z457 = z447 * z448;
    const Scalar z467 = v_alpha_1 * z441 - z465;  // angular acceleration of blade_1, z
    const Scalar z470 = v_alpha_2 * z444 - z468;  // angular acceleration of blade_2, z
    const Scalar z473 = v_alpha_3 * z447 - z471;  // angular acceleration of blade_3, z
    const Scalar z476 = v_alpha_4 * z450 - z474;  // angular acceleration of blade_4, z
    const Scalar z488 = n0_4 * (z459 + z469);  // moment on blade_2, x
    const Scalar z493 = n0_4 * (z461 + z466);  // moment on blade_1, x
    const Scalar z478 = n0_4 * (z455 - z475);  // moment on blade_4, x
    const Scalar z483 = n0_4 * (z457 - z472);  // moment on blade_3, x
    const Scalar z477 = z456 + z476;
    const Scalar z482 = z458 + z473;
    const Scalar z487 = z460 + z470;
    const Scalar z492 = z462 + z467;
    const Scalar z479 = n0_4 * z477;  // moment on blade_4, z
    const Scalar z484 = n0_4 * z482;  // moment on blade_3, z
    const Scalar z489 = n0_4 * z487;  // moment on blade_2, z
    const Scalar z494 = n0_4 * z492;  // moment on blade_1, z
    const Scalar z480 = s_alpha_4 * z479;
    const Scalar z481 = c_alpha_4 * z479;
    const Scalar z485 = s_alpha_3 * z484;
    const Scalar z486 = c_alpha_3 * z484;
    const Scalar z490 = s_alpha_2 * z489;
    const Scalar z491 = c_alpha_2 * z489;
    const Scalar z495 = s_alpha_1 * z494;
    const Scalar z496 = c_alpha_1 * z494;
    const Scalar z497 = n1330 * z463 - z493 - z483 - z480 + z490;  // moment on rotor, x
    const Scalar z498 = n1330 * z464 - z488 - z478 + z485 - z495;  // moment on rotor, y
    const Scalar z499 = n1330 * a_phi - z481 - z486 - z491 - z496;  // moment on rotor, z
    const Scalar z500 = s_phi * z498 - c_phi * z497;
    const Scalar z501 = s_phi * z497 + c_phi * z498;
    const Scalar z502 = z437 - z501;  // moment on pitch, y
    result.X = -z312;
    result.Y = n0;
    result.Z = n0;
    result.M_x = z500;
    result.M_y = z502;
    result.M_z = z499;
  }
};

}  // namespace helicopter_on_a_circle_pitching_blades
