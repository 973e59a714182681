// SPDX-License-Identifier: MIT
// rolling_hoop: Hoop rolling without slipping: five coordinates, two multipliers
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, constraints, linearisation, inverse_dynamics_derivatives, forward_dynamics_derivatives, jets, sparse_constraint_jacobian, inverse_dynamics_sensitivities, forward_dynamics_sensitivities
// Parameters set at run time: A, C
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function                        additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                              6                5          4             0                  0       0     15       -
//   kinematics                             13               25          0             0                  3       0     44      44
//   mass_matrix                             2                4          0             0                  1       0      8       9
//   bias                                    6               18          0             0                  1       0     26      55
//   inverse_dynamics                       19               27          0             0                  2       0     50      86
//   forward_dynamics                       21               50          3             0                  2       0     78     110
//   energy                                 14               29          0             0                  3       0     49      55
//   first_integrals                        15               29          0             0                  3       0     50      56
//   constraints                             9               15          0             0                  2       0     28      29
//   linearisation                         202              290         14             0                  2       0    510     654
//   inverse_dynamics_derivatives           30               57          0             0                  2       0     91     212
//   forward_dynamics_derivatives           83              180          4             0                  2       0    271     400
//   jets                                   94              122          9             0                  2       0    229       -
//   sparse_constraint_jacobian              0                0          0             0                  2       0      4       4
//   inverse_dynamics_sensitivities          7               13          0             0                  1       0     22      54
//   forward_dynamics_sensitivities         33               74          3             0                  2       0    114     157
//
// Not computed because this mechanism does not need it:
//   kinematics: of 39 results 11 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 25 results 18 vanish identically, 1 repeat another up to sign
//   bias: of 5 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 16 results 5 vanish identically, 2 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 180 results 100 vanish identically, 5 repeat another up to sign
//   inverse_dynamics_derivatives: of 50 results 37 vanish identically, 1 repeat another up to sign
//   forward_dynamics_derivatives: of 105 results 40 vanish identically, 6 repeat another up to sign
//   sparse_constraint_jacobian: of 7 results 2 repeat another up to sign
//   inverse_dynamics_sensitivities: of 10 results 5 vanish identically
//   forward_dynamics_sensitivities: of 14 results 1 vanish identically
//
// To write this file again:
//   rolling_hoop_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,inverse_dynamics_derivatives,forward_dynamics_derivatives,jets,sparse_constraint_jacobian,inverse_dynamics_sensitivities,forward_dynamics_sensitivities --output rolling_hoop.hpp
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

#ifndef TORSOR_JET_SUPPORT
#define TORSOR_JET_SUPPORT 1

namespace torsor {

/// Numbers that are treated alike. float and double fill a vector register where the compiler has a type for it.
template <class Scalar>
struct Lanes {
  static constexpr int width = 1;
  struct Vector {
    Scalar lane[width];
    TORSOR_DEVICE Scalar& operator[](int i) noexcept { return lane[i]; }
    TORSOR_DEVICE const Scalar& operator[](int i) const noexcept { return lane[i]; }
  };
  TORSOR_DEVICE TORSOR_INLINED static void add_product(Vector& sum, const Vector& a, const Vector& b) noexcept {
    for (int i = 0; i < width; ++i) sum[i] = sum[i] + a[i] * b[i];
  }
};
#if defined(__GNUC__) && !defined(__CUDACC__)
template <class Number>
struct RegisterLanes {
#if defined(__AVX__)
  static constexpr int width = 32 / static_cast<int>(sizeof(Number));
#else
  static constexpr int width = 16 / static_cast<int>(sizeof(Number));
#endif
  typedef Number Vector __attribute__((vector_size(width * sizeof(Number))));
  TORSOR_INLINED static void add_product(Vector& sum, const Vector& a, const Vector& b) noexcept { sum += a * b; }
};
template <>
struct Lanes<double> : RegisterLanes<double> {};
template <>
struct Lanes<float> : RegisterLanes<float> {};
#endif

/// Pairs of Taylor series and their convolutions, side by side in vectors. Coefficients of order 0 are not kept: whoever
/// asks for a sum adds the terms with them.
template <class Scalar, int count>
class Convolutions {
  using Vector = typename Lanes<Scalar>::Vector;
  static constexpr int width = Lanes<Scalar>::width;
  static constexpr int vectors = (count + width - 1) / width;
  static constexpr int block = 4, blocks = vectors / block, rest = vectors % block;
  static constexpr int order_max = 30;

 public:
  class Sums {
   public:
    TORSOR_DEVICE TORSOR_INLINED Scalar operator[](int i) const noexcept { return vector_[i / width][i % width]; }

   private:
    friend class Convolutions;
    Vector vector_[vectors];
  };

  /// The terms a_i b_(k-i), i = 1..k-1, of each pair, summed.
  TORSOR_DEVICE TORSOR_INLINED void sum(int k, Sums& sums) const noexcept {
    for (int i = 0; i < blocks; ++i) sum_block<block>(k, i, sums);
    if constexpr (rest > 0) sum_block<rest>(k, blocks, sums);
  }

  /// The coefficients of order k.
  TORSOR_DEVICE TORSOR_INLINED void keep(int k, const Scalar (&left)[count], const Scalar (&right)[count]) noexcept {
    for (int i = 0; i < blocks; ++i) keep_block<block>(k, i, left, right);
    if constexpr (rest > 0) keep_block<rest>(k, blocks, left, right);
  }

 private:
  /// As many vectors as there are chains of additions that a processor works on at once. The coefficients of order
  /// k - 1, which have only just been computed, come last.
  template <int size>
  TORSOR_DEVICE TORSOR_INLINED void sum_block(int k, int index, Sums& sums) const noexcept {
    Vector a = {}, b = {}, c = {}, d = {};
    const Vector* const all_left = left_ + index * block * order_max;
    const Vector* const all_right = right_ + index * block * order_max;
    const auto add = [&](int i) {
      const Vector* left = all_left + i * size;
      const Vector* right = all_right + (k - i) * size;
      Lanes<Scalar>::add_product(a, left[0], right[0]);
      if constexpr (size > 1) Lanes<Scalar>::add_product(b, left[1], right[1]);
      if constexpr (size > 2) Lanes<Scalar>::add_product(c, left[2], right[2]);
      if constexpr (size > 3) Lanes<Scalar>::add_product(d, left[3], right[3]);
    };
    for (int i = 2; i < k - 1; ++i) add(i);
    if (k > 1) add(1);
    if (k > 2) add(k - 1);
    Vector* result = sums.vector_ + index * block;
    result[0] = a;
    if constexpr (size > 1) result[1] = b;
    if constexpr (size > 2) result[2] = c;
    if constexpr (size > 3) result[3] = d;
  }

  template <int size>
  TORSOR_DEVICE TORSOR_INLINED void keep_block(int k, int index, const Scalar (&left)[count],
                                               const Scalar (&right)[count]) noexcept {
    const Scalar zero = scalar_traits<Scalar>::constant(0.0, 0.0f, "0/1");
    const int first = index * block * order_max + k * size;
    for (int v = 0; v < size; ++v) {
      for (int i = 0; i < width; ++i) {
        const int place = (index * block + v) * width + i;
        left_[first + v][i] = place < count ? left[place] : zero;
        right_[first + v][i] = place < count ? right[place] : zero;
      }
    }
  }

  /// Block after block, of one block order after order.
  Vector left_[vectors * order_max], right_[vectors * order_max];
};

}  // namespace torsor
#endif

namespace rolling_hoop {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "rolling_hoop";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xcd1a5a309f3a7d85ULL;
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 2;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar A;  ///< parameter [kg m^2]
    Scalar C;  ///< parameter [kg m^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::A, &Parameters::C};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar theta;  ///< coordinate [rad or 1]
    Scalar phi;  ///< coordinate [rad or 1]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::theta,
          &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::theta, &GeneralizedForces::phi};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_along_x1;  ///< of the constraint along_x1 [N]
    Scalar lambda_along_y1;  ///< of the constraint along_y1 [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_along_x1, &Multipliers::lambda_along_y1};
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
    Scalar z59;
    Scalar z138;
    Scalar z144;
    Scalar z147;
    Scalar z850;
    Scalar z864;
    Scalar y0;
    Scalar y1;
    Scalar y2;
    Scalar y3;
    Scalar y4;
    Scalar y5;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    parameters.A = n0_5;
    parameters.C = n1;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_A = parameters.A;
    const Scalar p_C = parameters.C;
    const Scalar z59 = p_A - p_C;
    const Scalar z138 = n1 / p_C;
    const Scalar z144 = n1 + z138;
    const Scalar z147 = n1 / z144;
    const Scalar z850 = z138 * z147;
    const Scalar z864 = z138 * z850;
    precomputed.z59 = z59;
    precomputed.z138 = z138;
    precomputed.z144 = z144;
    precomputed.z147 = z147;
    precomputed.z850 = z850;
    precomputed.z864 = z864;
    precomputed.y0 = n1 + p_A;
    precomputed.y1 = p_C / p_A;
    precomputed.y2 = n2 - p_C / p_A;
    precomputed.y3 = p_A - p_C;
    precomputed.y4 = p_C * z138;
    precomputed.y5 = -z147 * (n1 - p_C * z138);
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar z0 = n1_2;
    const Scalar z1 = traits::formula(0.36235775447667357, 0.36235777f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z2 = traits::formula(0.9320390859672264, 0.9320391f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    state.time = n0;
    state.q.x = n0;
    state.q.y = z1;
    state.q.psi = n0;
    state.q.theta = n1_2;
    state.q.phi = n0;
    state.v.x = n4 - n0_5 * z1;
    state.v.y = n0_3 * z2;
    state.v.psi = n0_5;
    state.v.theta = -n0_3;
    state.v.phi = -n4;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> hoop_position;  ///< centre of mass of hoop [m]
    std::array<Scalar, 9> hoop_rotation;  ///< from the axes of hoop to the ground's (3 x 3)
    std::array<Scalar, 3> hoop_velocity;  ///< velocity of the centre of mass of hoop [m/s]
    std::array<Scalar, 3> hoop_angular_velocity;  ///< angular velocity of hoop [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 15> I_jacobian;  ///< partial velocities of I (3 x 5)
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
    std::array<Scalar, 2> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 2> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 10> jacobian;  ///< A, stored column by column (2 x 5)
    std::array<Scalar, 2> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 25> M;  ///< mass matrix (5 x 5)
    std::array<Scalar, 25> C;  ///< damping and gyroscopic terms (5 x 5)
    std::array<Scalar, 25> K;  ///< stiffness (5 x 5)
    std::array<Scalar, 5> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 15> K_r;  ///< reduced stiffness (3 x 5)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, w): x' = A x + B du (8 x 8)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 5;
  static constexpr int independent_coordinates[] = {0, 1, 2, 3, 4};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[] = {1, 2, 4};

  /// Derivatives of generalised forces, stored column by column.
  struct InverseDynamicsDerivatives {
    std::array<Scalar, 25> by_position;  ///< df_i/dq_j (5 x 5)
    std::array<Scalar, 25> by_velocity;  ///< df_i/dv_j (5 x 5)
  };

  /// Derivatives of accelerations and multipliers, stored column by column.
  struct ForwardDynamicsDerivatives {
    std::array<Scalar, 25> by_position;  ///< da_i/dq_j (5 x 5)
    std::array<Scalar, 25> by_velocity;  ///< da_i/dv_j (5 x 5)
    std::array<Scalar, 25> by_force;  ///< da_i/df_j, f generalised forces added to E u (5 x 5)
    std::array<Scalar, 10> multipliers_by_position;  ///< dlambda_i/dq_j (2 x 5)
    std::array<Scalar, 10> multipliers_by_velocity;  ///< dlambda_i/dv_j (2 x 5)
    std::array<Scalar, 10> multipliers_by_force;  ///< dlambda_i/df_j, f generalised forces added to E u (2 x 5)
  };

  /// Entries of A in compressed rows.
  struct SparseConstraintJacobian {
    std::array<Scalar, 7> values;  ///< entries of A, row by row
  };
  /// Where the values of SparseConstraintJacobian stand: those of row i, in the order of the multipliers, from
  /// row_start[i] to row_start[i + 1], each in its column, an index in v.
  static constexpr int constraint_jacobian_nonzeros = 7;
  static constexpr int constraint_jacobian_row_start[] = {0, 4, 7};
  static constexpr int constraint_jacobian_column[] = {0, 1, 2, 4, 0, 1, 3};

  /// Derivatives by the run-time parameters, a column for each, in the order of Parameters.
  struct InverseDynamicsSensitivities {
    std::array<Scalar, 10> by_parameter;  ///< df_i/dp_k (5 x 2)
  };

  /// Derivatives by the run-time parameters, a column for each, in the order of Parameters.
  struct ForwardDynamicsSensitivities {
    std::array<Scalar, 10> by_parameter;  ///< da_i/dp_k (5 x 2)
    std::array<Scalar, 4> multipliers_by_parameter;  ///< dlambda_i/dp_k (2 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z27 = s_theta * s_psi;
    const Scalar z29 = s_theta * c_psi;
    const Scalar z26 = c_theta * s_psi;
    const Scalar z28 = c_theta * c_psi;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z32 = v_theta * c_psi;  // angular velocity of hoop.2, x
    const Scalar z33 = v_theta * s_psi;  // angular velocity of hoop.2, y
    const Scalar z10 = c_theta * v_theta;
    const Scalar z38 = s_theta * s_phi;
    const Scalar z39 = s_theta * c_phi;
    const Scalar z45 = c_theta * v_phi + v_psi;  // angular velocity of hoop, z
    const Scalar z34 = c_psi * c_phi - s_phi * z26;
    const Scalar z35 = c_psi * s_phi + c_phi * z26;
    const Scalar z36 = s_psi * c_phi + s_phi * z28;
    const Scalar z37 = s_psi * s_phi - c_phi * z28;
    const Scalar z43 = v_phi * z27 + z32;  // angular velocity of hoop, x
    const Scalar z44 = v_phi * z29 - z33;  // angular velocity of hoop, y
    const Scalar z46 = v_x - v_theta * z27 + c_psi * z31;
    const Scalar z47 = v_y + v_theta * z29 + s_psi * z31;
    const Scalar z49 = q_x + z26;
    const Scalar z50 = q_y - z28;
    result.hoop_position[0] = q_x;
    result.hoop_position[1] = q_y;
    result.hoop_position[2] = s_theta;
    result.hoop_rotation[0] = z34;
    result.hoop_rotation[1] = z36;
    result.hoop_rotation[2] = z38;
    result.hoop_rotation[3] = -z35;
    result.hoop_rotation[4] = -z37;
    result.hoop_rotation[5] = z39;
    result.hoop_rotation[6] = z27;
    result.hoop_rotation[7] = -z29;
    result.hoop_rotation[8] = c_theta;
    result.hoop_velocity[0] = v_x;
    result.hoop_velocity[1] = v_y;
    result.hoop_velocity[2] = z10;
    result.hoop_angular_velocity[0] = z43;
    result.hoop_angular_velocity[1] = -z44;
    result.hoop_angular_velocity[2] = z45;
    result.I_position[0] = z49;
    result.I_position[1] = z50;
    result.I_position[2] = n0;
    result.I_velocity[0] = z46;
    result.I_velocity[1] = z47;
    result.I_velocity[2] = n0;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = z28;
    result.I_jacobian[9] = -z27;
    result.I_jacobian[12] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = z26;
    result.I_jacobian[10] = z29;
    result.I_jacobian[13] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n0;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 25>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z61 = c_theta * z59;
    const Scalar z54 = c_theta * p_C;
    const Scalar z78 = c_theta * c_theta + p_A;
    const Scalar z62 = c_theta * z61 - p_A;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n1;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = -z62;
    mass[13] = n0;
    mass[14] = z54;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z78;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = z54;
    mass[23] = n0;
    mass[24] = p_C;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z31 = c_theta * v_psi;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z42 = v_phi + z31;
    const Scalar z79 = v_theta * z11;
    const Scalar z83 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z84 = v_theta * z30;  // angular acceleration of hoop.2, z
    const Scalar z92 = z30 * z31;
    const Scalar z80 = n9_81 - z79;
    const Scalar z87 = z30 * z42;
    const Scalar z88 = v_theta * z42;
    const Scalar z91 = p_C * z84;  // moment on hoop, z
    const Scalar z93 = n2 * z83;
    const Scalar z89 = p_C * z87;  // moment on hoop, x
    const Scalar z90 = p_C * z88;  // moment on hoop, y
    const Scalar z94 = p_A * z92 - z89;  // moment on hoop.2, x
    const Scalar z95 = p_A * z93 - z90;  // moment on hoop.2, y
    const Scalar z97 = s_theta * z95 - c_theta * z91;
    const Scalar z101 = c_theta * z80 - z94;
    forces.x = n0;
    forces.y = n0;
    forces.psi = z97;
    forces.theta = z101;
    forces.phi = -z91;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z30 = s_theta * v_psi;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z106 = c_theta * a_psi;
    const Scalar z105 = s_theta * a_psi;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z13 = c_theta * a_theta - v_theta * z11;
    const Scalar z42 = v_phi + z31;
    const Scalar z83 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z92 = z30 * z31;
    const Scalar z109 = v_theta * z31 + z105;  // angular acceleration of hoop.2, y
    const Scalar z110 = v_theta * z30 - z106;  // angular acceleration of hoop.2, z
    const Scalar z87 = z30 * z42;
    const Scalar z88 = v_theta * z42;
    const Scalar z102 = n9_81 + z13;
    const Scalar z113 = a_phi - z110;  // angular acceleration of hoop, z
    const Scalar z115 = z83 + z109;
    const Scalar z89 = p_C * z87;  // moment on hoop, x
    const Scalar z90 = p_C * z88;  // moment on hoop, y
    const Scalar z114 = p_C * z113;  // moment on hoop, z
    const Scalar z116 = p_A * (a_theta - z92) + z89;  // moment on hoop.2, x
    const Scalar z117 = p_A * z115 - z90;  // moment on hoop.2, y
    const Scalar z119 = c_theta * z114 + s_theta * z117;
    const Scalar z126 = c_theta * z102 + z116;
    forces.x = a_x + s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    forces.y = a_y - s_psi * l_lambda_along_x1 - c_psi * l_lambda_along_y1;
    forces.psi = -c_theta * l_lambda_along_x1 + z119;
    forces.theta = -s_theta * l_lambda_along_y1 + z126;
    forces.phi = z114 - l_lambda_along_x1;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    const Scalar z138 = precomputed.z138;
    const Scalar z144 = precomputed.z144;
    const Scalar z147 = precomputed.z147;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z78 = c_theta * c_theta + p_A;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z140 = s_theta * s_theta * p_A;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z131 = v_psi * s_psi;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z132 = v_psi * c_psi;
    const Scalar z54 = c_theta * p_C;
    const Scalar z10 = c_theta * v_theta;
    const Scalar z61 = c_theta * z59;
    const Scalar z42 = v_phi + z31;
    const Scalar z62 = c_theta * z61 - p_A;
    const Scalar z79 = v_theta * z11;
    const Scalar z83 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z84 = v_theta * z30;  // angular acceleration of hoop.2, z
    const Scalar z92 = z30 * z31;
    const Scalar z133 = v_x * z131 - v_y * z132 + z11 * v_psi;
    const Scalar z135 = v_x * z132 + v_y * z131 - v_theta * z10;
    const Scalar z139 = z54 * z138;
    const Scalar z141 = n1 / z78;
    const Scalar z80 = n9_81 - z79;
    const Scalar z87 = z30 * z42;
    const Scalar z88 = v_theta * z42;
    const Scalar z91 = p_C * z84;  // moment on hoop, z
    const Scalar z93 = n2 * z83;
    const Scalar z142 = n1 / z140;
    const Scalar z89 = p_C * z87;  // moment on hoop, x
    const Scalar z90 = p_C * z88;  // moment on hoop, y
    const Scalar z94 = p_A * z92 - z89;  // moment on hoop.2, x
    const Scalar z95 = p_A * z93 - z90;  // moment on hoop.2, y
    const Scalar z101 = c_theta * z80 - z94;
    const Scalar z148 = s_theta * z95;
    const Scalar z143 = s_theta * z141;
    const Scalar z149 = z142 * z148;
    const Scalar z145 = n1 + s_theta * z143;
    const Scalar z150 = z101 * z141;
    const Scalar z151 = z91 * z138 + z139 * z149;
    const Scalar z153 = s_theta * z150 + z135;
    const Scalar z146 = n1 / z145;
    const Scalar z156 = z144 + z145;
    const Scalar z152 = c_theta * z149 + z133 - z151;
    const Scalar z157 = n4096 * z156;
    const Scalar z154 = z147 * z152;
    const Scalar z161 = z138 * z154 + z151;
    const Scalar z155 = z146 * z153;
    const Scalar z158 = s_psi * z155 - c_psi * z154;
    const Scalar z159 = s_psi * z154 + c_psi * z155;
    const Scalar z160 = z143 * z155 - z150;
    accelerations.x = -z158;
    accelerations.y = z159;
    accelerations.psi = -z149;
    accelerations.theta = z160;
    accelerations.phi = z161;
    multipliers.lambda_along_x1 = z154;
    multipliers.lambda_along_y1 = z155;
    if (!(traits::regular(z140, -z62) && traits::regular(z78, z78) && traits::regular(p_C, p_C) && traits::regular(z144,
        z157) && traits::regular(z145, z157))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.theta
        * accelerations.phi * multipliers.lambda_along_x1 * multipliers.lambda_along_y1;
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
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z163 = v_x * s_psi - v_y * c_psi;
    const Scalar z162 = v_x * c_psi + v_y * s_psi;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z40 = v_theta * c_phi + s_phi * z30;
    const Scalar z41 = v_theta * s_phi - c_phi * z30;
    const Scalar z42 = v_phi + z31;
    const Scalar z164 = s_theta * z10 - c_theta * z163;
    const Scalar z165 = c_theta * z10 + s_theta * z163;
    const Scalar z166 = c_phi * z162 + s_phi * z164;
    const Scalar z167 = s_phi * z162 - c_phi * z164;
    result.kinetic = n0_5 * (p_C * z42 * z42 + z165 * z165 + p_A * (z40 * z40 + z41 * z41) + z166 * z166 + z167 * z167);
    result.force_function = -n9_81 * s_theta;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z163 = v_x * s_psi - v_y * c_psi;
    const Scalar z162 = v_x * c_psi + v_y * s_psi;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z40 = v_theta * c_phi + s_phi * z30;
    const Scalar z41 = v_theta * s_phi - c_phi * z30;
    const Scalar z42 = v_phi + z31;
    const Scalar z164 = s_theta * z10 - c_theta * z163;
    const Scalar z165 = c_theta * z10 + s_theta * z163;
    const Scalar z166 = c_phi * z162 + s_phi * z164;
    const Scalar z167 = s_phi * z162 - c_phi * z164;
    result.energy = n9_81 * s_theta + n0_5 * (p_C * z42 * z42 + z165 * z165 + p_A * (z40 * z40 + z41 * z41) + z166
        * z166 + z167 * z167);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z194 = v_psi * s_psi;
    const Scalar z195 = v_psi * c_psi;
    const Scalar z192 = s_theta * v_theta;
    const Scalar z191 = c_theta * v_theta;
    const Scalar z193 = v_phi + v_x * c_psi + v_y * s_psi + c_theta * v_psi;
    const Scalar z196 = v_x * z194 - v_y * z195 + v_psi * z192;
    const Scalar z197 = v_x * s_psi - z192 - v_y * c_psi;
    const Scalar z198 = v_x * z195 + v_y * z194 - v_theta * z191;
    result.value[0] = n0;
    result.rate[0] = z193;
    result.gamma[0] = -z196;
    result.value[1] = n0;
    result.rate[1] = -z197;
    result.gamma[1] = -z198;
    result.jacobian[0] = c_psi;
    result.jacobian[1] = -s_psi;
    result.jacobian[2] = s_psi;
    result.jacobian[3] = c_psi;
    result.jacobian[4] = c_theta;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = s_theta;
    result.jacobian[8] = n1;
    result.jacobian[9] = n0;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, psi, theta, phi,
  /// w those of the rates of y, psi, phi;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar z59 = precomputed.z59;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z447 = c_theta * c_theta + p_A;
    const Scalar z445 = c_theta * z59;
    const Scalar z444 = c_theta * p_C;
    const Scalar z441 = s_theta * v_psi;
    const Scalar z442 = c_theta * v_psi;
    const Scalar z459 = c_theta * a_psi;
    const Scalar z438 = s_theta * v_theta;
    const Scalar z458 = s_theta * a_psi;
    const Scalar z469 = v_psi * s_psi;
    const Scalar z437 = c_theta * v_theta;
    const Scalar z476 = v_x * s_psi;
    const Scalar z470 = v_psi * c_psi;
    const Scalar z439 = c_theta * a_theta;
    const Scalar z475 = v_x * c_psi + v_y * s_psi;
    const Scalar z479 = s_psi * l_lambda_along_x1;
    const Scalar z481 = s_psi * l_lambda_along_y1;
    const Scalar z440 = v_theta * z438 - z439;
    const Scalar z443 = v_phi + z442;
    const Scalar z504 = s_theta * a_theta;
    const Scalar z446 = c_theta * z445 - p_A;
    const Scalar z448 = v_theta * z438;
    const Scalar z449 = v_theta * z442;  // angular acceleration of hoop.2, y
    const Scalar z450 = v_theta * z441;  // angular acceleration of hoop.2, z
    const Scalar z456 = z441 * z442;
    const Scalar z460 = v_theta * z442 + z458;  // angular acceleration of hoop.2, y
    const Scalar z461 = v_theta * z441 - z459;  // angular acceleration of hoop.2, z
    const Scalar z471 = v_x * z469;
    const Scalar z473 = v_x * z470;
    const Scalar z477 = v_y * c_psi - z476;
    const Scalar z480 = c_psi * l_lambda_along_y1 + z479;
    const Scalar z482 = c_psi * l_lambda_along_x1 - z481;
    const Scalar z483 = n2 * z437;
    const Scalar z484 = p_C * z437;
    const Scalar z486 = p_C * z438;
    const Scalar z488 = c_theta * z441;
    const Scalar z493 = n2 * z442;
    const Scalar z495 = p_C * z441;
    const Scalar z502 = n2 * z438;
    const Scalar z505 = v_theta * z437 + z504;
    const Scalar z506 = z441 * z441;
    const Scalar z451 = z441 * z443;
    const Scalar z452 = v_theta * z443;
    const Scalar z455 = p_C * z450;  // moment on hoop, z
    const Scalar z472 = v_y * z470 - z471 - v_psi * z438;
    const Scalar z474 = z473 + v_y * z469 - v_theta * z437;
    const Scalar z478 = p_C * z443;
    const Scalar z485 = p_A * z483 - z484;
    const Scalar z489 = s_theta * z442 + z488;
    const Scalar z490 = s_theta * z443 + z488;
    const Scalar z503 = c_theta * z502;
    const Scalar z507 = z442 * z442 - z506;
    const Scalar z508 = z442 * z443 - z506;
    const Scalar z457 = n9_81 - z440;
    const Scalar z462 = a_phi - z461;  // angular acceleration of hoop, z
    const Scalar z464 = z449 + z460;
    const Scalar z497 = z450 + z461;
    const Scalar z499 = p_C * z460;
    const Scalar z453 = p_C * z451;  // moment on hoop, x
    const Scalar z513 = v_theta * p_C;
    const Scalar z454 = p_C * z452;  // moment on hoop, y
    const Scalar z520 = v_y * c_psi - z438 - z476;
    const Scalar z518 = v_y * z470 - z471;
    const Scalar z521 = v_y * z469 + z473;
    const Scalar z514 = s_theta * z513;
    const Scalar z515 = a_x * s_psi;
    const Scalar z494 = p_A * z493 - z478;
    const Scalar z498 = p_A * z497 - z455;
    const Scalar z509 = p_C * z508;
    const Scalar z463 = p_C * z462;  // moment on hoop, z
    const Scalar z466 = p_A * z464 - z454;  // moment on hoop.2, y
    const Scalar z510 = p_A * z507 - z509;
    const Scalar z523 = z439 - z448;
    const Scalar z465 = p_A * (a_theta - z456) + z453;  // moment on hoop.2, x
    const Scalar z517 = a_phi + a_x * c_psi + a_y * s_psi + z459 + z472;
    const Scalar z511 = z510 + c_theta * z505 + s_theta * z457;
    const Scalar z468 = c_theta * z457 + z465;
    const Scalar z516 = a_y * c_psi + z504 - z515 - z474;
    const Scalar z522 = a_y * c_psi - z515 - z521;
    const Scalar z519 = z518 + a_x * c_psi + a_y * s_psi;
    const Scalar z491 = p_C * z490;
    const Scalar z492 = p_A * z489 - z491;
    const Scalar z496 = s_theta * z494 - c_theta * z495;
    const Scalar z500 = s_theta * (z463 + z498) - c_theta * (z466 - z499);
    const Scalar z487 = s_theta * z485 - c_theta * z486;
    const Scalar z501 = s_theta * l_lambda_along_x1 - z500;
    const Scalar z512 = c_theta * l_lambda_along_y1 + z511;
    const Scalar z467 = c_theta * z463 + s_theta * z466;
    const Scalar z531 = c_psi * c_psi;
    const Scalar z532 = n1 + n1 / p_C - c_theta * c_theta / z446;
    const Scalar z527 = n1 / c_psi;
    const Scalar z539 = z477 * z527;
    const Scalar z575 = z517 * z527;
    const Scalar z526 = n1 / s_theta;
    const Scalar z533 = s_psi * z527;
    const Scalar z535 = c_theta * z527;
    const Scalar z545 = n2 * v_psi;
    const Scalar z576 = s_psi * z575 + z516;
    const Scalar z538 = z526 * z533;
    const Scalar z536 = s_psi * z535;
    const Scalar z542 = z441 * z527;
    const Scalar z540 = v_x / c_psi;
    const Scalar z537 = z526 * z536;
    const Scalar z541 = z526 * z540;
    const Scalar z577 = z526 * z576;
    const Scalar z580 = z447 * z538;
    const Scalar z543 = s_psi * z542 - z437;
    const Scalar z524 = v_psi * z437;
    const Scalar z525 = z458 + z524;
    const Scalar z544 = z526 * z543;
    const Scalar z547 = z520 + z469 * z535 + z441 * z537;
    const Scalar z550 = z470 * z535 - z475 - z483 * z537;
    const Scalar z555 = z527 * z547;
    const Scalar z586 = p_C + z527 * z527 + z538 * z580;
    const Scalar z556 = s_psi * z555 + z550;
    const Scalar z579 = z447 * z537;
    const Scalar z585 = z444 + z527 * z535 + z538 * z579;
    const Scalar z584 = z446 - z535 * z535 - z537 * z579;
    const Scalar z557 = z526 * z556;
    const Scalar z534 = z526 * z527;
    const Scalar z561 = z441 * z541 - z469 * z539;
    const Scalar z562 = z469 * z542 + z441 * z544;
    const Scalar z565 = z522 - z561;
    const Scalar z566 = z525 + z562;
    const Scalar z563 = z470 * z539 + z483 * z541;
    const Scalar z567 = z519 - z563;
    const Scalar z564 = z470 * z542 - z483 * z544;
    const Scalar z568 = z523 - z564;
    const Scalar z551 = z470 * z527 - z483 * z538;
    const Scalar z549 = z483 / (s_theta * c_psi);
    const Scalar z569 = z527 * z565;
    const Scalar z572 = z527 * z566;
    const Scalar z570 = s_psi * z569 - z567;
    const Scalar z573 = s_psi * z572 - z568;
    const Scalar z578 = z447 * z534;
    const Scalar z546 = z545 / c_psi;
    const Scalar z548 = s_psi * z545 / c_psi;
    const Scalar z552 = z527 * z546;
    const Scalar z558 = z527 * z548;
    const Scalar z571 = z526 * z570;
    const Scalar z574 = z526 * z573;
    const Scalar z553 = s_psi * z552 - z549;
    const Scalar z559 = s_psi * z558 + z551;
    const Scalar z582 = z533 * z535 + z537 * z578;
    const Scalar z583 = z527 * z533 + z538 * z578;
    const Scalar z554 = z526 * z553;
    const Scalar z560 = z526 * z559;
    const Scalar z581 = n1 + z533 * z533 + z534 * z578;
    const Scalar z587 = z533 * z552 + z554 * z578;
    const Scalar z528 = s_theta * s_theta;
    const Scalar z529 = n1 + z528 / z447;
    const Scalar z588 = z533 * z555 + z557 * z578;
    const Scalar z589 = z533 * z558 + z560 * z578;
    const Scalar z530 = z447 * z529;
    const Scalar z597 = z487 - z496 * z537;
    const Scalar z598 = z496 * z538 + z514;
    const Scalar z600 = z492 - z503 * z537;
    const Scalar z603 = z486 - z495 * z537;
    const Scalar z609 = z537 * z600 + z597;
    const Scalar z612 = z538 * z600 - z603;
    const Scalar z606 = z534 * z600;
    const Scalar z615 = z588 + z606;
    const Scalar z629 = z496 * z541;
    const Scalar z633 = z495 * z541;
    const Scalar z631 = z503 * z541;
    const Scalar z638 = z480 * z533 + z482 - z534 * z631;
    const Scalar z640 = z480 * z535 - z629 - z537 * z631;
    const Scalar z642 = z633 + z480 * z527 - z538 * z631;
    const Scalar z630 = z496 * z544;
    const Scalar z635 = z501 + z630;
    const Scalar z596 = z496 * z534;
    const Scalar z632 = z503 * z544;
    const Scalar z636 = z512 + z632;
    const Scalar z634 = z495 * z544;
    const Scalar z637 = z499 + z634;
    const Scalar z599 = z503 * z534;
    const Scalar z601 = z495 + z503 * z538;
    const Scalar z608 = z537 * z599 + z596;
    const Scalar z610 = z537 * z601 + z598;
    const Scalar z641 = z537 * z636 + z635;
    const Scalar z643 = z538 * z636 - z637;
    const Scalar z639 = z534 * z636;
    const Scalar z602 = z495 * z534;
    const Scalar z604 = z495 * z538;
    const Scalar z611 = z538 * z599 - z602;
    const Scalar z605 = z534 * z599;
    const Scalar z614 = z587 - z605;
    const Scalar z607 = z534 * z601;
    const Scalar z613 = z538 * z601 - z604;
    const Scalar z616 = z589 - z607;
    const Scalar z590 = z535 * z552 + z554 * z579;
    const Scalar z593 = z527 * z552 + z554 * z580;
    const Scalar z617 = z590 - z608;
    const Scalar z620 = z593 - z611;
    const Scalar z650 = a_x - c_psi * l_lambda_along_x1 + z481;
    const Scalar z591 = z535 * z555 + z557 * z579;
    const Scalar z594 = z527 * z555 + z557 * z580;
    const Scalar z618 = z591 + z609;
    const Scalar z621 = z594 + z612;
    const Scalar z592 = z535 * z558 + z560 * z579;
    const Scalar z595 = z527 * z558 + z560 * z580;
    const Scalar z619 = z592 - z610;
    const Scalar z622 = z595 - z613;
    const Scalar z661 = n1 / z586;
    const Scalar z652 = a_y - z515 / c_psi - z468 / (s_theta * c_psi);
    const Scalar z651 = s_theta * l_lambda_along_y1 - z468;
    const Scalar z653 = c_theta * l_lambda_along_x1 - z467 + z535 * z650 - z537 * z651;
    const Scalar z654 = l_lambda_along_x1 - z463 + z527 * z650 - z538 * z651;
    const Scalar z663 = z585 * z661;
    const Scalar z666 = z584 + z585 * z663;
    const Scalar z665 = z582 - z583 * z663;
    const Scalar z671 = z617 - z620 * z663;
    const Scalar z676 = z618 - z621 * z663;
    const Scalar z667 = n1 / z666;
    const Scalar z662 = z583 * z661;
    const Scalar z664 = z581 - z583 * z662;
    const Scalar z623 = z533 * z569 + z571 * z578;
    const Scalar z644 = z623 - z638;
    const Scalar z624 = z533 * z572 + z574 * z578;
    const Scalar z645 = z624 - z639;
    const Scalar z655 = z533 * z575 + z577 * z578;
    const Scalar z658 = z652 + z655;
    const Scalar z625 = z535 * z569 + z571 * z579;
    const Scalar z627 = z527 * z569 + z571 * z580;
    const Scalar z646 = z625 - z640;
    const Scalar z648 = z627 - z642;
    const Scalar z626 = z535 * z572 + z574 * z579;
    const Scalar z628 = z527 * z572 + z574 * z580;
    const Scalar z647 = z626 - z641;
    const Scalar z649 = z628 - z643;
    const Scalar z656 = z535 * z575 + z577 * z579;
    const Scalar z657 = z527 * z575 + z577 * z580;
    const Scalar z659 = z653 - z656;
    const Scalar z660 = z654 - z657;
    const Scalar z681 = z646 - z648 * z663;
    const Scalar z686 = z619 - z622 * z663;
    const Scalar z691 = z647 - z649 * z663;
    const Scalar z668 = z665 * z667;
    const Scalar z669 = z664 + z665 * z668;
    const Scalar z672 = z614 - z620 * z662 + z668 * z671;
    const Scalar z677 = z615 - z621 * z662 + z668 * z676;
    const Scalar z670 = n1 / z669;
    const Scalar z682 = z644 - z648 * z662 + z668 * z681;
    const Scalar z687 = z616 - z622 * z662 + z668 * z686;
    const Scalar z692 = z645 - z649 * z662 + z668 * z691;
    const Scalar z673 = z670 * z672;
    const Scalar z678 = z670 * z677;
    const Scalar z683 = z670 * z682;
    const Scalar z688 = z670 * z687;
    const Scalar z693 = z670 * z692;
    const Scalar z674 = z667 * z671 - z668 * z673;
    const Scalar z679 = z667 * z676 - z668 * z678;
    const Scalar z684 = z667 * z681 - z668 * z683;
    const Scalar z689 = z667 * z686 - z668 * z688;
    const Scalar z694 = z667 * z691 - z668 * z693;
    const Scalar z675 = z620 * z661 - z662 * z673 + z663 * z674;
    const Scalar z680 = z621 * z661 - z662 * z678 + z663 * z679;
    const Scalar z685 = z648 * z661 - z662 * z683 + z663 * z684;
    const Scalar z690 = z622 * z661 - z662 * z688 + z663 * z689;
    const Scalar z695 = z649 * z661 - z662 * z693 + z663 * z694;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n1;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = -z446;
    result.M[13] = n0;
    result.M[14] = z444;
    result.M[15] = n0;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = z447;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = z444;
    result.M[23] = n0;
    result.M[24] = p_C;
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
    result.C[12] = z487;
    result.C[13] = -z492;
    result.C[14] = -z486;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = z496;
    result.C[18] = -z503;
    result.C[19] = -z495;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = -z514;
    result.C[23] = z495;
    result.C[24] = n0;
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
    result.K[10] = z480;
    result.K[11] = -z482;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = z501;
    result.K[18] = -z512;
    result.K[19] = -z499;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.F[0] = -a_x + c_psi * l_lambda_along_x1 - z481;
    result.F[1] = -a_y + c_psi * l_lambda_along_y1 + z479;
    result.F[2] = c_theta * l_lambda_along_x1 - z467;
    result.F[3] = s_theta * l_lambda_along_y1 - z468;
    result.F[4] = l_lambda_along_x1 - z463;
    result.M_r[0] = z581;
    result.M_r[1] = z582;
    result.M_r[2] = z583;
    result.M_r[3] = z582;
    result.M_r[4] = -z584;
    result.M_r[5] = z585;
    result.M_r[6] = z583;
    result.M_r[7] = z585;
    result.M_r[8] = z586;
    result.C_r[0] = z614;
    result.C_r[1] = z617;
    result.C_r[2] = z620;
    result.C_r[3] = z615;
    result.C_r[4] = z618;
    result.C_r[5] = z621;
    result.C_r[6] = z616;
    result.C_r[7] = z619;
    result.C_r[8] = z622;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z644;
    result.K_r[7] = z646;
    result.K_r[8] = z648;
    result.K_r[9] = -z645;
    result.K_r[10] = -z647;
    result.K_r[11] = -z649;
    result.K_r[12] = n0;
    result.K_r[13] = n0;
    result.K_r[14] = n0;
    result.F_r[0] = -z658;
    result.F_r[1] = z659;
    result.F_r[2] = z660;
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
    result.A[16] = -z539;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = z541;
    result.A[20] = n0;
    result.A[21] = -z683;
    result.A[22] = z684;
    result.A[23] = -z685;
    result.A[24] = z542;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = z544;
    result.A[28] = n0;
    result.A[29] = z693;
    result.A[30] = -z694;
    result.A[31] = z695;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = -z533;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = -z534;
    result.A[44] = n0;
    result.A[45] = -z673;
    result.A[46] = z674;
    result.A[47] = -z675;
    result.A[48] = -z535;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = -z537;
    result.A[52] = n0;
    result.A[53] = -z678;
    result.A[54] = z679;
    result.A[55] = -z680;
    result.A[56] = -z527;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = -z538;
    result.A[60] = n1;
    result.A[61] = -z688;
    result.A[62] = z689;
    result.A[63] = -z690;
    if (!(traits::regular(z528, z530) && traits::regular(z531, z532) && traits::regular(z669, z581)
        && traits::regular(-z666, -z584) && traits::regular(z586, z586))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((n0 * result.M[12] * result.M[14] * result.M[18] * result.M[22] * result.M[24] * result.C[12]
        * result.C[13] * result.C[14] * result.C[17]) * (n0 * result.C[18] * result.C[19] * result.C[22] * result.C[23]
        * result.K[10] * result.K[11] * result.K[17] * result.K[18] * result.K[19])) * ((n0 * result.F[0] * result.F[1]
        * result.F[2] * result.F[3] * result.F[4] * result.M_r[0] * result.M_r[1] * result.M_r[2] * result.M_r[3]) * (n0
        * result.M_r[4] * result.M_r[5] * result.M_r[6] * result.M_r[7] * result.M_r[8] * result.C_r[0] * result.C_r[1]
        * result.C_r[2] * result.C_r[3] * result.C_r[4]))) * (((n0 * result.C_r[5] * result.C_r[6] * result.C_r[7]
        * result.C_r[8] * result.K_r[6] * result.K_r[7] * result.K_r[8] * result.K_r[9] * result.K_r[10]) * (n0
        * result.K_r[11] * result.F_r[0] * result.F_r[1] * result.F_r[2] * result.A[16] * result.A[19] * result.A[21]
        * result.A[22] * result.A[23] * result.A[24])) * ((n0 * result.A[27] * result.A[29] * result.A[30]
        * result.A[31] * result.A[40] * result.A[43] * result.A[45] * result.A[46] * result.A[47]) * (n0 * result.A[48]
        * result.A[51] * result.A[53] * result.A[54] * result.A[55] * result.A[56] * result.A[59] * result.A[61]
        * result.A[62] * result.A[63])));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Derivatives of inverse_dynamics at (q, v, a, lambda). That by accelerations is the mass matrix.
  TORSOR_DEVICE static void inverse_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, InverseDynamicsDerivatives& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z701 = s_theta * v_psi;
    const Scalar z702 = c_theta * v_psi;
    const Scalar z711 = c_theta * a_psi;
    const Scalar z710 = s_theta * a_psi;
    const Scalar z698 = c_theta * v_theta;
    const Scalar z699 = s_theta * v_theta;
    const Scalar z750 = v_theta * p_C;
    const Scalar z719 = s_psi * l_lambda_along_x1 + c_psi * l_lambda_along_y1;
    const Scalar z720 = s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    const Scalar z751 = s_theta * z750;
    const Scalar z700 = c_theta * a_theta - v_theta * z699;
    const Scalar z703 = v_phi + z702;
    const Scalar z704 = v_theta * z702;  // angular acceleration of hoop.2, y
    const Scalar z705 = v_theta * z701;  // angular acceleration of hoop.2, z
    const Scalar z712 = v_theta * z702 + z710;  // angular acceleration of hoop.2, y
    const Scalar z713 = v_theta * z701 - z711;  // angular acceleration of hoop.2, z
    const Scalar z721 = n2 * z698;
    const Scalar z722 = p_C * z698;
    const Scalar z724 = p_C * z699;
    const Scalar z726 = c_theta * z701;
    const Scalar z731 = n2 * z702;
    const Scalar z733 = p_C * z701;
    const Scalar z740 = n2 * z699;
    const Scalar z742 = s_theta * a_theta + v_theta * z698;
    const Scalar z743 = z701 * z701;
    const Scalar z706 = v_theta * z703;
    const Scalar z708 = p_C * z705;  // moment on hoop, z
    const Scalar z718 = p_C * z703;
    const Scalar z723 = p_A * z721 - z722;
    const Scalar z727 = s_theta * z702 + z726;
    const Scalar z728 = s_theta * z703 + z726;
    const Scalar z741 = c_theta * z740;
    const Scalar z744 = z702 * z702 - z743;
    const Scalar z745 = z702 * z703 - z743;
    const Scalar z709 = n9_81 + z700;
    const Scalar z714 = a_phi - z713;  // angular acceleration of hoop, z
    const Scalar z716 = z704 + z712;
    const Scalar z735 = z705 + z713;
    const Scalar z737 = p_C * z712;
    const Scalar z707 = p_C * z706;  // moment on hoop, y
    const Scalar z732 = p_A * z731 - z718;
    const Scalar z715 = p_C * z714;  // moment on hoop, z
    const Scalar z725 = s_theta * z723 - c_theta * z724;
    const Scalar z729 = p_C * z728;
    const Scalar z736 = p_A * z735 - z708;
    const Scalar z746 = p_C * z745;
    const Scalar z717 = p_A * z716 - z707;  // moment on hoop.2, y
    const Scalar z730 = p_A * z727 - z729;
    const Scalar z734 = s_theta * z732 - c_theta * z733;
    const Scalar z747 = p_A * z744 - z746;
    const Scalar z738 = s_theta * (z715 + z736) - c_theta * (z717 - z737);
    const Scalar z748 = z747 + c_theta * z742 + s_theta * z709;
    const Scalar z739 = s_theta * l_lambda_along_x1 - z738;
    const Scalar z749 = c_theta * l_lambda_along_y1 + z748;
    result.by_position[0] = n0;
    result.by_position[1] = n0;
    result.by_position[2] = n0;
    result.by_position[3] = n0;
    result.by_position[4] = n0;
    result.by_position[5] = n0;
    result.by_position[6] = n0;
    result.by_position[7] = n0;
    result.by_position[8] = n0;
    result.by_position[9] = n0;
    result.by_position[10] = z719;
    result.by_position[11] = z720;
    result.by_position[12] = n0;
    result.by_position[13] = n0;
    result.by_position[14] = n0;
    result.by_position[15] = n0;
    result.by_position[16] = n0;
    result.by_position[17] = z739;
    result.by_position[18] = -z749;
    result.by_position[19] = -z737;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = n0;
    result.by_velocity[1] = n0;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = n0;
    result.by_velocity[4] = n0;
    result.by_velocity[5] = n0;
    result.by_velocity[6] = n0;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = n0;
    result.by_velocity[9] = n0;
    result.by_velocity[10] = n0;
    result.by_velocity[11] = n0;
    result.by_velocity[12] = z725;
    result.by_velocity[13] = -z730;
    result.by_velocity[14] = -z724;
    result.by_velocity[15] = n0;
    result.by_velocity[16] = n0;
    result.by_velocity[17] = z734;
    result.by_velocity[18] = -z741;
    result.by_velocity[19] = -z733;
    result.by_velocity[20] = n0;
    result.by_velocity[21] = n0;
    result.by_velocity[22] = -z751;
    result.by_velocity[23] = z733;
    result.by_velocity[24] = n0;
  }

  /// Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by
  /// solving with the factorisation of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsDerivatives& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    const Scalar z138 = precomputed.z138;
    const Scalar z144 = precomputed.z144;
    const Scalar z147 = precomputed.z147;
    const Scalar z850 = precomputed.z850;
    const Scalar z864 = precomputed.z864;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z873 = c_theta * c_theta + p_A;
    const Scalar z868 = c_theta * v_psi;
    const Scalar z895 = s_theta * s_theta * p_A;
    const Scalar z867 = s_theta * v_psi;
    const Scalar z888 = v_psi * s_psi;
    const Scalar z866 = s_theta * v_theta;
    const Scalar z889 = v_psi * c_psi;
    const Scalar z870 = c_theta * p_C;
    const Scalar z865 = c_theta * v_theta;
    const Scalar z916 = v_y * c_psi;
    const Scalar z915 = v_x * c_psi + v_y * s_psi;
    const Scalar z871 = c_theta * z59;
    const Scalar z869 = v_phi + z868;
    const Scalar z872 = c_theta * z871 - p_A;
    const Scalar z874 = v_theta * z866;
    const Scalar z876 = v_theta * z868;  // angular acceleration of hoop.2, y
    const Scalar z877 = v_theta * z867;  // angular acceleration of hoop.2, z
    const Scalar z883 = z867 * z868;
    const Scalar z890 = v_x * z888 - v_y * z889 + v_psi * z866;
    const Scalar z891 = v_x * z889;
    const Scalar z892 = v_theta * z865;
    const Scalar z894 = z138 * z870;
    const Scalar z917 = v_x * s_psi - z916;
    const Scalar z919 = n2 * z865;
    const Scalar z920 = p_C * z865;
    const Scalar z922 = p_C * z866;
    const Scalar z923 = c_theta * z867;
    const Scalar z928 = n2 * z868;
    const Scalar z930 = p_C * z867;
    const Scalar z931 = n2 * z866;
    const Scalar z933 = z867 * z867;
    const Scalar z896 = n1 / z873;
    const Scalar z875 = n9_81 - z874;
    const Scalar z878 = z867 * z869;
    const Scalar z938 = v_theta * p_C;
    const Scalar z879 = v_theta * z869;
    const Scalar z939 = s_theta * z938;
    const Scalar z882 = p_C * z877;  // moment on hoop, z
    const Scalar z884 = n2 * z876;
    const Scalar z893 = v_y * z888 + z891 - z892;
    const Scalar z897 = n1 / z895;
    const Scalar z918 = p_C * z869;
    const Scalar z921 = p_A * z919 - z920;
    const Scalar z924 = s_theta * z868 + z923;
    const Scalar z925 = s_theta * z869 + z923;
    const Scalar z932 = c_theta * z931;
    const Scalar z934 = z868 * z868 - z933;
    const Scalar z935 = z868 * z869 - z933;
    const Scalar z880 = p_C * z878;  // moment on hoop, x
    const Scalar z940 = v_y * z888 + z891;
    const Scalar z881 = p_C * z879;  // moment on hoop, y
    const Scalar z941 = z147 * z888;
    const Scalar z929 = p_A * z928 - z918;
    const Scalar z926 = p_C * z925;
    const Scalar z936 = p_C * z935;
    const Scalar z885 = p_A * z883 - z880;  // moment on hoop.2, x
    const Scalar z886 = p_A * z884 - z881;  // moment on hoop.2, y
    const Scalar z946 = z138 * z941;
    const Scalar z927 = p_A * z924 - z926;
    const Scalar z937 = p_A * z934 - z936;
    const Scalar z887 = c_theta * z875 - z885;
    const Scalar z947 = c_psi * z147;
    const Scalar z956 = s_psi * z147;
    const Scalar z950 = z147 * z889;
    const Scalar z955 = z138 * z950;
    const Scalar z901 = s_theta * z886;
    const Scalar z898 = s_theta * z896;
    const Scalar z902 = z897 * z901;
    const Scalar z899 = n1 + s_theta * z898;
    const Scalar z903 = z887 * z896;
    const Scalar z904 = z138 * z882 + z894 * z902;
    const Scalar z906 = s_theta * z903 + z893;
    const Scalar z900 = n1 / z899;
    const Scalar z962 = v_psi * (v_x * s_psi - z916);
    const Scalar z909 = z144 + z899;
    const Scalar z905 = c_theta * z902 + z890 - z904;
    const Scalar z910 = n4096 * z909;
    const Scalar z907 = z147 * z905;
    const Scalar z914 = z138 * z907 + z904;
    const Scalar z908 = z900 * z906;
    const Scalar z969 = s_theta * z921;
    const Scalar z970 = z897 * z969;
    const Scalar z942 = z889 * z900;
    const Scalar z948 = s_psi * z900;
    const Scalar z951 = z888 * z900;
    const Scalar z957 = c_psi * z900;
    const Scalar z964 = z900 * z962;
    const Scalar z911 = s_psi * z908 - c_psi * z907;
    const Scalar z971 = z896 * z927;
    const Scalar z912 = s_psi * z907 + c_psi * z908;
    const Scalar z972 = z138 * z922 + z894 * z970;
    const Scalar z913 = z898 * z908 - z903;
    const Scalar z973 = s_theta * z971 - z915;
    const Scalar z974 = z147 * z917;
    const Scalar z979 = z138 * z974 + z972;
    const Scalar z982 = c_theta * z902;
    const Scalar z983 = z877 + z982;  // angular acceleration of hoop.2, z
    const Scalar z988 = s_theta * z902;
    const Scalar z989 = z876 - z988;  // angular acceleration of hoop.2, y
    const Scalar z980 = z894 * z897;
    const Scalar z975 = z900 * z973;
    const Scalar z984 = z914 - z983;  // angular acceleration of hoop, z
    const Scalar z986 = z877 + z983;
    const Scalar z990 = z876 + z989;
    const Scalar z992 = p_C * z989;
    const Scalar z943 = s_psi * z942 - c_psi * z941;
    const Scalar z949 = n1 - c_psi * z947 - s_psi * z948;
    const Scalar z987 = p_A * z986 - z882;
    const Scalar z991 = p_A * z990 - z881;  // moment on hoop.2, y
    const Scalar z944 = s_psi * z941 + c_psi * z942;
    const Scalar z945 = z898 * z942;
    const Scalar z978 = z898 * z975 - z971;
    const Scalar z996 = s_theta * z913 + z892;
    const Scalar z981 = c_theta * z913 - z874;
    const Scalar z985 = p_C * z984;  // moment on hoop, z
    const Scalar z993 = s_theta * (z985 + z987) - c_theta * (z991 - z992);
    const Scalar z960 = c_psi * z912 - z940 + s_psi * z911;
    const Scalar z961 = c_psi * z912 - z960 + s_psi * z911;
    const Scalar z1010 = z896 * z932;
    const Scalar z1008 = s_theta * z929;
    const Scalar z1009 = z897 * z1008;
    const Scalar z952 = c_psi * z950 + s_psi * z951;
    const Scalar z1012 = s_theta * z1010 + z919;
    const Scalar z994 = s_theta * z907 - z993;
    const Scalar z953 = s_psi * z950 - c_psi * z951;
    const Scalar z954 = z898 * z951;
    const Scalar z1011 = z138 * z930 + z894 * z1009;
    const Scalar z963 = z147 * z961;
    const Scalar z965 = s_psi * z964 - z912 + c_psi * z963;
    const Scalar z966 = s_psi * z963 - z911 - c_psi * z964;
    const Scalar z967 = z898 * z964;
    const Scalar z968 = z138 * z963;
    const Scalar z999 = z894 * z992 + z994;
    const Scalar z1016 = s_theta / z873;
    const Scalar z1000 = z897 * z999;
    const Scalar z1017 = z900 * z1016;
    const Scalar z1013 = z900 * z1012;
    const Scalar z958 = s_psi * z957 - c_psi * z956;
    const Scalar z959 = n1 - s_psi * z956 - c_psi * z957;
    const Scalar z995 = n9_81 + z981;
    const Scalar z997 = z937 + c_theta * z996 + s_theta * z995;
    const Scalar z1022 = z896 * z930;
    const Scalar z1024 = s_theta * z1022;
    const Scalar z1021 = z897 * z939;
    const Scalar z1029 = z138 + z894 * z980;
    const Scalar z998 = c_theta * z908 + z997;
    const Scalar z1025 = z900 * z1024;
    const Scalar z976 = c_psi * z974 + s_psi * z975;
    const Scalar z977 = s_psi * z974 - c_psi * z975;
    const Scalar z1001 = z896 * z998;
    const Scalar z1002 = z138 * z992 + z894 * z1000;
    const Scalar z1003 = s_theta * z1001 + z981;
    const Scalar z1014 = s_psi * z1013;
    const Scalar z1015 = c_psi * z1013;
    const Scalar z1018 = s_psi * z1017;
    const Scalar z1019 = c_psi * z1017;
    const Scalar z1020 = z896 - z898 * z1017;
    const Scalar z1004 = z900 * z1003;
    const Scalar z1023 = z894 * z1021;
    const Scalar z1026 = s_psi * z1025;
    const Scalar z1027 = c_psi * z1025;
    const Scalar z1028 = z898 * z1025 - z1022;
    const Scalar z1005 = s_psi * z1004;
    const Scalar z1006 = c_psi * z1004;
    const Scalar z1007 = z898 * z1004 - z1001;
    const Scalar z1030 = c_psi * z850;
    const Scalar z1031 = s_psi * z850;
    const Scalar z1032 = z864 - z1029;
    result.by_position[0] = n0;
    result.by_position[1] = n0;
    result.by_position[2] = n0;
    result.by_position[3] = n0;
    result.by_position[4] = n0;
    result.by_position[5] = n0;
    result.by_position[6] = n0;
    result.by_position[7] = n0;
    result.by_position[8] = n0;
    result.by_position[9] = n0;
    result.by_position[10] = z965;
    result.by_position[11] = z966;
    result.by_position[12] = n0;
    result.by_position[13] = -z967;
    result.by_position[14] = z968;
    result.by_position[15] = z1005;
    result.by_position[16] = -z1006;
    result.by_position[17] = -z1000;
    result.by_position[18] = -z1007;
    result.by_position[19] = z1002;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = -z943;
    result.by_velocity[1] = z944;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = z945;
    result.by_velocity[4] = z946;
    result.by_velocity[5] = -z952;
    result.by_velocity[6] = -z953;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = z954;
    result.by_velocity[9] = -z955;
    result.by_velocity[10] = z976;
    result.by_velocity[11] = z977;
    result.by_velocity[12] = -z970;
    result.by_velocity[13] = -z978;
    result.by_velocity[14] = z979;
    result.by_velocity[15] = z1014;
    result.by_velocity[16] = -z1015;
    result.by_velocity[17] = -z1009;
    result.by_velocity[18] = n0;
    result.by_velocity[19] = z1011;
    result.by_velocity[20] = -z1026;
    result.by_velocity[21] = z1027;
    result.by_velocity[22] = z1021;
    result.by_velocity[23] = z1028;
    result.by_velocity[24] = -z1023;
    result.by_force[0] = z949;
    result.by_force[1] = z958;
    result.by_force[2] = n0;
    result.by_force[3] = z1018;
    result.by_force[4] = -z1030;
    result.by_force[5] = z958;
    result.by_force[6] = z959;
    result.by_force[7] = n0;
    result.by_force[8] = -z1019;
    result.by_force[9] = -z1031;
    result.by_force[10] = n0;
    result.by_force[11] = n0;
    result.by_force[12] = z897;
    result.by_force[13] = n0;
    result.by_force[14] = -z980;
    result.by_force[15] = z1018;
    result.by_force[16] = -z1019;
    result.by_force[17] = n0;
    result.by_force[18] = z1020;
    result.by_force[19] = n0;
    result.by_force[20] = -z1030;
    result.by_force[21] = -z1031;
    result.by_force[22] = -z980;
    result.by_force[23] = n0;
    result.by_force[24] = -z1032;
    result.multipliers_by_position[0] = n0;
    result.multipliers_by_position[1] = n0;
    result.multipliers_by_position[2] = n0;
    result.multipliers_by_position[3] = n0;
    result.multipliers_by_position[4] = z963;
    result.multipliers_by_position[5] = -z964;
    result.multipliers_by_position[6] = n0;
    result.multipliers_by_position[7] = -z1004;
    result.multipliers_by_position[8] = n0;
    result.multipliers_by_position[9] = n0;
    result.multipliers_by_velocity[0] = z941;
    result.multipliers_by_velocity[1] = z942;
    result.multipliers_by_velocity[2] = -z950;
    result.multipliers_by_velocity[3] = z951;
    result.multipliers_by_velocity[4] = z974;
    result.multipliers_by_velocity[5] = -z975;
    result.multipliers_by_velocity[6] = n0;
    result.multipliers_by_velocity[7] = -z1013;
    result.multipliers_by_velocity[8] = n0;
    result.multipliers_by_velocity[9] = z1025;
    result.multipliers_by_force[0] = -z947;
    result.multipliers_by_force[1] = z948;
    result.multipliers_by_force[2] = -z956;
    result.multipliers_by_force[3] = -z957;
    result.multipliers_by_force[4] = n0;
    result.multipliers_by_force[5] = n0;
    result.multipliers_by_force[6] = n0;
    result.multipliers_by_force[7] = -z1017;
    result.multipliers_by_force[8] = -z850;
    result.multipliers_by_force[9] = n0;
    if (!(traits::regular(z895, -z872) && traits::regular(z873, z873) && traits::regular(p_C, p_C)
        && traits::regular(z144, z910) && traits::regular(z899, z910))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.by_position[10] * result.by_position[11] * result.by_position[13]
        * result.by_position[14] * result.by_position[15] * result.by_position[16] * result.by_position[17]
        * result.by_position[18] * result.by_position[19] * result.by_velocity[0] * result.by_velocity[1]
        * result.by_velocity[3] * result.by_velocity[4] * result.by_velocity[5] * result.by_velocity[6]
        * result.by_velocity[8]) * (n0 * result.by_velocity[9] * result.by_velocity[10] * result.by_velocity[11]
        * result.by_velocity[12] * result.by_velocity[13] * result.by_velocity[14] * result.by_velocity[15]
        * result.by_velocity[16] * result.by_velocity[17] * result.by_velocity[19] * result.by_velocity[20]
        * result.by_velocity[21] * result.by_velocity[22] * result.by_velocity[23] * result.by_velocity[24]
        * result.by_force[0])) * ((n0 * result.by_force[1] * result.by_force[3] * result.by_force[4]
        * result.by_force[5] * result.by_force[6] * result.by_force[8] * result.by_force[9] * result.by_force[12]
        * result.by_force[14] * result.by_force[15] * result.by_force[16] * result.by_force[18] * result.by_force[20]
        * result.by_force[21] * result.by_force[22] * result.by_force[24]) * ((n0 * result.multipliers_by_position[4]
        * result.multipliers_by_position[5] * result.multipliers_by_position[7] * result.multipliers_by_velocity[0]
        * result.multipliers_by_velocity[1] * result.multipliers_by_velocity[2] * result.multipliers_by_velocity[3]
        * result.multipliers_by_velocity[4]) * (n0 * result.multipliers_by_velocity[5]
        * result.multipliers_by_velocity[7] * result.multipliers_by_velocity[9] * result.multipliers_by_force[0]
        * result.multipliers_by_force[1] * result.multipliers_by_force[2] * result.multipliers_by_force[3]
        * result.multipliers_by_force[7] * result.multipliers_by_force[8])));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 32 operations take a convolution at each order.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, const Inputs&, int order,
      std::array<Scalar, 10>* coefficients) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    const Scalar z138 = precomputed.z138;
    const Scalar z144 = precomputed.z144;
    const Scalar z147 = precomputed.z147;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z78 = c_theta * c_theta + p_A;
    const Scalar z61 = c_theta * z59;
    const Scalar z140 = s_theta * s_theta * p_A;
    const Scalar z62 = c_theta * z61 - p_A;
    const Scalar z141 = n1 / z78;
    const Scalar z143 = s_theta * z141;
    const Scalar z145 = n1 + s_theta * z143;
    const Scalar z156 = z144 + z145;
    const Scalar z157 = n4096 * z156;
    const Scalar b5 = state.v.theta;
    const Scalar b9 = state.v.psi;
    const Scalar b16 = c_theta * c_theta;
    const Scalar b17 = p_A + b16;
    const Scalar i18 = n1 / b17;
    const Scalar i19 = n1 / b17;
    const Scalar f0 = precomputed.y0;
    const Scalar f1 = precomputed.y1;
    const Scalar f2 = precomputed.y2;
    const Scalar b12 = state.v.phi;
    const Scalar b13 = c_theta * b9;
    const Scalar b21 = f1 * b12 - f2 * b13;
    const Scalar b22 = b5 * b21;
    const Scalar b23 = b22 / s_theta;
    const Scalar i23 = n1 / s_theta;
    const Scalar f3 = precomputed.y3;
    const Scalar b24 = p_C * b12 - f3 * b13;
    const Scalar b25 = b9 * b24;
    const Scalar b6 = c_theta * b5;
    const Scalar b7 = s_theta * b5;
    const Scalar b27 = b6 * b7;
    const Scalar b26 = s_theta * b25;
    const Scalar b28 = n9_81 * c_theta - b27 + b26;
    const Scalar b29 = b28 / b17;
    const Scalar i29 = n1 / b17;
    const Scalar f4 = precomputed.y4;
    const Scalar b14 = b9 * s_psi;
    const Scalar b0 = state.v.x;
    const Scalar b15 = b9 * c_psi;
    const Scalar b1 = state.v.y;
    const Scalar b36 = b0 * b15;
    const Scalar b37 = b1 * b14;
    const Scalar b38 = b5 * b6;
    const Scalar b35 = s_theta * b29;
    const Scalar b39 = b36 + b37 - b38 + b35;
    const Scalar b20 = f0 * z141;
    const Scalar b40 = b39 / b20;
    const Scalar i40 = n1 / b20;
    const Scalar f5 = precomputed.y5;
    const Scalar b30 = b7 * b9;
    const Scalar b33 = b0 * b14;
    const Scalar b34 = b1 * b15;
    const Scalar b31 = c_theta * b23;
    const Scalar b41 = f5 * b30 - z147 * b33 + z147 * b34 - f5 * b31;
    const Scalar b43 = c_psi * b41;
    const Scalar b42 = s_psi * b40;
    const Scalar b44 = s_psi * b41;
    const Scalar b45 = c_psi * b40;
    const Scalar b46 = z143 * b40;
    const Scalar b32 = f4 * b30 - f4 * b31;
    coefficients[0][0] = state.q.x;
    coefficients[0][1] = state.q.y;
    coefficients[0][2] = state.q.psi;
    coefficients[0][3] = state.q.theta;
    coefficients[0][4] = state.q.phi;
    coefficients[0][5] = state.v.x;
    coefficients[0][6] = state.v.y;
    coefficients[0][7] = state.v.psi;
    coefficients[0][8] = state.v.theta;
    coefficients[0][9] = state.v.phi;
    coefficients[1][0] = b0;
    coefficients[1][1] = b1;
    coefficients[1][2] = b9;
    coefficients[1][3] = b5;
    coefficients[1][4] = b12;
    coefficients[1][5] = -b43 - b42;
    coefficients[1][6] = -b44 + b45;
    coefficients[1][7] = b23;
    coefficients[1][8] = -b29 + b46;
    coefficients[1][9] = b32 - z138 * b41;
    torsor::Convolutions<Scalar, 32> operations_;
    typename torsor::Convolutions<Scalar, 32>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][5];
      const Scalar x1 = coefficients[k_][6];
      const Scalar x2 = coefficients[k_][3];
      const Scalar x3 = inverse_ * sums_[0] + c_theta * x2;
      const Scalar w2 = number_ * x2;
      const Scalar x4 = -inverse_ * sums_[1] - s_theta * x2;
      const Scalar x5 = coefficients[k_][8];
      const Scalar x6 = sums_[2] + c_theta * x5 + b5 * x4;
      const Scalar x7 = sums_[3] + s_theta * x5 + b5 * x3;
      const Scalar x8 = coefficients[k_][2];
      const Scalar x9 = coefficients[k_][7];
      const Scalar x10 = inverse_ * sums_[4] + c_psi * x8;
      const Scalar w8 = number_ * x8;
      const Scalar x11 = -inverse_ * sums_[5] - s_psi * x8;
      const Scalar x12 = coefficients[k_][9];
      const Scalar x13 = sums_[6] + c_theta * x9 + b9 * x4;
      const Scalar x14 = sums_[7] + s_psi * x9 + b9 * x10;
      const Scalar x15 = sums_[8] + c_psi * x9 + b9 * x11;
      const Scalar x16 = sums_[9] + (c_theta + c_theta) * x4;
      const Scalar x17 = x16;
      const Scalar x18 = -(sums_[10] + z141 * x17) * i18;
      const Scalar x19 = (x3 - sums_[11] - z143 * x17) * i19;
      const Scalar x20 = f0 * x18;
      const Scalar x21 = f1 * x12 - f2 * x13;
      const Scalar x22 = sums_[12] + b21 * x5 + b5 * x21;
      const Scalar x23 = (x22 - (sums_[13] + b23 * x3)) * i23;
      const Scalar x24 = p_C * x12 - f3 * x13;
      const Scalar x25 = sums_[14] + b24 * x9 + b9 * x24;
      const Scalar x26 = sums_[15] + b25 * x3 + s_theta * x25;
      const Scalar x27 = sums_[16] + b6 * x7 + b7 * x6;
      const Scalar x28 = n9_81 * x4 - x27 + x26;
      const Scalar x29 = (x28 - (sums_[17] + b29 * x17)) * i29;
      const Scalar x30 = sums_[18] + b7 * x9 + b9 * x7;
      const Scalar x31 = sums_[19] + b23 * x4 + c_theta * x23;
      const Scalar x32 = f4 * x30 - f4 * x31;
      const Scalar x33 = sums_[20] + b14 * x0 + b0 * x14;
      const Scalar x34 = sums_[21] + b15 * x1 + b1 * x15;
      const Scalar x35 = sums_[22] + b29 * x3 + s_theta * x29;
      const Scalar x36 = sums_[23] + b15 * x0 + b0 * x15;
      const Scalar x37 = sums_[24] + b14 * x1 + b1 * x14;
      const Scalar x38 = sums_[25] + b6 * x5 + b5 * x6;
      const Scalar x39 = x36 + x37 - x38 + x35;
      const Scalar x40 = (x39 - (sums_[26] + b40 * x20)) * i40;
      const Scalar x41 = f5 * x30 - z147 * x33 + z147 * x34 - f5 * x31;
      const Scalar x42 = sums_[27] + b40 * x10 + s_psi * x40;
      const Scalar x43 = sums_[28] + b41 * x11 + c_psi * x41;
      const Scalar x44 = sums_[29] + b41 * x10 + s_psi * x41;
      const Scalar x45 = sums_[30] + b40 * x11 + c_psi * x40;
      const Scalar x46 = sums_[31] + b40 * x19 + z143 * x40;
      coefficients[k_ + 1][0] = next_ * x0;
      coefficients[k_ + 1][1] = next_ * x1;
      coefficients[k_ + 1][2] = next_ * x9;
      coefficients[k_ + 1][3] = next_ * x5;
      coefficients[k_ + 1][4] = next_ * x12;
      coefficients[k_ + 1][5] = next_ * (-x43 - x42);
      coefficients[k_ + 1][6] = next_ * (-x44 + x45);
      coefficients[k_ + 1][7] = next_ * x23;
      coefficients[k_ + 1][8] = next_ * (-x29 + x46);
      coefficients[k_ + 1][9] = next_ * (x32 - z138 * x41);
      const Scalar left_[] = {w2, w2, x4, x3, w8, w8, x4, x9, x9, x4, x18, x19, x5, x23, x9, x3, x6, x29, x7, x4, x0,
        x1, x3, x0, x1, x5, x40, x10, x11, x10, x11, x19};
      const Scalar right_[] = {x4, x3, x5, x5, x11, x10, x9, x10, x11, x4, x17, x17, x21, x3, x24, x25, x7, x17, x9,
        x23, x14, x15, x29, x15, x14, x6, x20, x40, x41, x41, x40, x40};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    if (!(traits::regular(z140, -z62) && traits::regular(z78, z78) && traits::regular(p_C, p_C) && traits::regular(z144,
        z157) && traits::regular(z145, z157))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * coefficients[order][0] * coefficients[order][1] * coefficients[order][2]
        * coefficients[order][3] * coefficients[order][4] * coefficients[order][5] * coefficients[order][6]
        * coefficients[order][7] * coefficients[order][8] * coefficients[order][9];
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Jacobian A(q, t) of the constraints without the entries that vanish identically: `values` of compressed rows.
  TORSOR_DEVICE static void sparse_constraint_jacobian(const Precomputed&, const State& state,
      SparseConstraintJacobian& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta = state.q.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    result.values[0] = c_psi;
    result.values[1] = s_psi;
    result.values[2] = c_theta;
    result.values[3] = n1;
    result.values[4] = -s_psi;
    result.values[5] = c_psi;
    result.values[6] = s_theta;
  }

  /// Derivatives of inverse_dynamics by the run-time parameters p at fixed (q, v, a, lambda).
  TORSOR_DEVICE static void inverse_dynamics_sensitivities(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsSensitivities& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z31 = c_theta * v_psi;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z106 = c_theta * a_psi;
    const Scalar z105 = s_theta * a_psi;
    const Scalar z42 = v_phi + z31;
    const Scalar z83 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z92 = z30 * z31;
    const Scalar z109 = v_theta * z31 + z105;  // angular acceleration of hoop.2, y
    const Scalar z110 = v_theta * z30 - z106;  // angular acceleration of hoop.2, z
    const Scalar z87 = z30 * z42;
    const Scalar z88 = v_theta * z42;
    const Scalar z1034 = a_theta - z92;
    const Scalar z113 = a_phi - z110;  // angular acceleration of hoop, z
    const Scalar z115 = z83 + z109;
    const Scalar z1033 = s_theta * z115;
    const Scalar z1035 = s_theta * z88 - c_theta * z113;
    result.by_parameter[0] = n0;
    result.by_parameter[1] = n0;
    result.by_parameter[2] = z1033;
    result.by_parameter[3] = z1034;
    result.by_parameter[4] = n0;
    result.by_parameter[5] = n0;
    result.by_parameter[6] = n0;
    result.by_parameter[7] = -z1035;
    result.by_parameter[8] = z87;
    result.by_parameter[9] = z113;
  }

  /// Derivatives of forward_dynamics by the run-time parameters p at fixed (q, v, u), the accelerations and
  /// multipliers being those of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_sensitivities(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsSensitivities& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    const Scalar z138 = precomputed.z138;
    const Scalar z144 = precomputed.z144;
    const Scalar z147 = precomputed.z147;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z1065 = c_theta * v_psi;
    const Scalar z1090 = s_theta * s_theta * p_A;
    const Scalar z1085 = v_psi * s_psi;
    const Scalar z1070 = c_theta * c_theta + p_A;
    const Scalar z1064 = s_theta * v_psi;
    const Scalar z1086 = v_psi * c_psi;
    const Scalar z1063 = s_theta * v_theta;
    const Scalar z1067 = c_theta * p_C;
    const Scalar z1062 = c_theta * v_theta;
    const Scalar z1068 = c_theta * z59;
    const Scalar z1066 = v_phi + z1065;
    const Scalar z1069 = c_theta * z1068 - p_A;
    const Scalar z1071 = v_theta * z1063;
    const Scalar z1073 = v_theta * z1065;  // angular acceleration of hoop.2, y
    const Scalar z1074 = v_theta * z1064;  // angular acceleration of hoop.2, z
    const Scalar z1080 = z1064 * z1065;
    const Scalar z1087 = v_x * z1085 - v_y * z1086 + v_psi * z1063;
    const Scalar z1088 = v_x * z1086 + v_y * z1085 - v_theta * z1062;
    const Scalar z1089 = z138 * z1067;
    const Scalar z1091 = n1 / z1070;
    const Scalar z1072 = n9_81 - z1071;
    const Scalar z1075 = z1064 * z1066;
    const Scalar z1076 = v_theta * z1066;
    const Scalar z1079 = p_C * z1074;  // moment on hoop, z
    const Scalar z1081 = n2 * z1073;
    const Scalar z1092 = n1 / z1090;
    const Scalar z1077 = p_C * z1075;  // moment on hoop, x
    const Scalar z1078 = p_C * z1076;  // moment on hoop, y
    const Scalar z1082 = p_A * z1080 - z1077;  // moment on hoop.2, x
    const Scalar z1083 = p_A * z1081 - z1078;  // moment on hoop.2, y
    const Scalar z1084 = c_theta * z1072 - z1082;
    const Scalar z1096 = s_theta * z1083;
    const Scalar z1093 = s_theta * z1091;
    const Scalar z1127 = z1075 * z1091;
    const Scalar z1097 = z1092 * z1096;
    const Scalar z1094 = n1 + s_theta * z1093;
    const Scalar z1098 = z1084 * z1091;
    const Scalar z1130 = s_theta * z1127;
    const Scalar z1099 = z138 * z1079 + z1089 * z1097;
    const Scalar z1108 = c_theta * z1097;
    const Scalar z1111 = s_theta * z1097;
    const Scalar z1101 = s_theta * z1098 + z1088;
    const Scalar z1095 = n1 / z1094;
    const Scalar z1104 = z144 + z1094;
    const Scalar z1109 = z1074 + z1108;  // angular acceleration of hoop.2, z
    const Scalar z1112 = z1073 - z1111;  // angular acceleration of hoop.2, y
    const Scalar z1100 = c_theta * z1097 + z1087 - z1099;
    const Scalar z1105 = n4096 * z1104;
    const Scalar z1113 = z1073 + z1112;
    const Scalar z1102 = z147 * z1100;
    const Scalar z1114 = s_theta * z1113;
    const Scalar z1107 = z138 * z1102 + z1099;
    const Scalar z1116 = z1092 * z1114;
    const Scalar z1110 = z1107 - z1109;  // angular acceleration of hoop, z
    const Scalar z1103 = z1095 * z1101;
    const Scalar z1118 = z1089 * z1116;
    const Scalar z1132 = z1095 * z1130;
    const Scalar z1124 = s_theta * z1076 - c_theta * z1110;
    const Scalar z1106 = z1093 * z1103 - z1098;
    const Scalar z1135 = z1093 * z1132 - z1127;
    const Scalar z1125 = z1089 * z1110 + z1124;
    const Scalar z1115 = z1080 - z1106;
    const Scalar z1117 = z1091 * z1115;
    const Scalar z1126 = z1092 * z1125;
    const Scalar z1119 = s_theta * z1117;
    const Scalar z1128 = z138 * z1110 + z1089 * z1126;
    const Scalar z1120 = z1095 * z1119;
    const Scalar z1129 = c_theta * z1126 - z1128;
    const Scalar z1121 = s_psi * z1120;
    const Scalar z1122 = c_psi * z1120;
    const Scalar z1123 = z1093 * z1120 - z1117;
    const Scalar z1131 = z147 * z1129;
    const Scalar z1133 = s_psi * z1132 + c_psi * z1131;
    const Scalar z1134 = s_psi * z1131 - c_psi * z1132;
    const Scalar z1136 = z138 * z1131 + z1128;
    result.by_parameter[0] = z1121;
    result.by_parameter[1] = -z1122;
    result.by_parameter[2] = -z1116;
    result.by_parameter[3] = -z1123;
    result.by_parameter[4] = z1118;
    result.by_parameter[5] = -z1133;
    result.by_parameter[6] = -z1134;
    result.by_parameter[7] = z1126;
    result.by_parameter[8] = z1135;
    result.by_parameter[9] = -z1136;
    result.multipliers_by_parameter[0] = n0;
    result.multipliers_by_parameter[1] = -z1120;
    result.multipliers_by_parameter[2] = -z1131;
    result.multipliers_by_parameter[3] = z1132;
    if (!(traits::regular(z1090, -z1069) && traits::regular(z1070, z1070) && traits::regular(p_C, p_C)
        && traits::regular(z144, z1105) && traits::regular(z1094, z1105))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.by_parameter[0] * result.by_parameter[1] * result.by_parameter[2]
        * result.by_parameter[3] * result.by_parameter[4] * result.by_parameter[5] * result.by_parameter[6]
        * result.by_parameter[7] * result.by_parameter[8] * result.by_parameter[9] * result.multipliers_by_parameter[1]
        * result.multipliers_by_parameter[2] * result.multipliers_by_parameter[3];
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace rolling_hoop
