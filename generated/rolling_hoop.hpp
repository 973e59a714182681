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
//   forward_dynamics                       20               49          3             0                  2       0     76     108
//   energy                                 14               29          0             0                  3       0     49      55
//   first_integrals                        15               29          0             0                  3       0     50      56
//   constraints                             9               15          0             0                  2       0     28      29
//   linearisation                         202              290         14             0                  2       0    510     654
//   inverse_dynamics_derivatives           30               57          0             0                  2       0     91     212
//   forward_dynamics_derivatives           82              179          4             0                  2       0    269     398
//   jets                                   93              121          9             0                  2       0    227       -
//   sparse_constraint_jacobian              0                0          0             0                  2       0      4       4
//   inverse_dynamics_sensitivities          7               13          0             0                  1       0     22      54
//   forward_dynamics_sensitivities         32               73          3             0                  2       0    112     155
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
  static constexpr unsigned long long fingerprint = 0x00a9609388bc1041ULL;
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 2;

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
    Scalar z848;
    Scalar z862;
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
    const Scalar z848 = z138 * z147;
    const Scalar z862 = z138 * z848;
    precomputed.z59 = z59;
    precomputed.z138 = z138;
    precomputed.z144 = z144;
    precomputed.z147 = z147;
    precomputed.z848 = z848;
    precomputed.z862 = z862;
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
  static constexpr int first_integral_count = 1;

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
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
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
    const Scalar z152 = c_theta * z149 + z133 - z151;
    const Scalar z154 = z147 * z152;
    const Scalar z159 = z138 * z154 + z151;
    const Scalar z155 = z146 * z153;
    const Scalar z156 = s_psi * z155 - c_psi * z154;
    const Scalar z157 = s_psi * z154 + c_psi * z155;
    const Scalar z158 = z143 * z155 - z150;
    accelerations.x = -z156;
    accelerations.y = z157;
    accelerations.psi = -z149;
    accelerations.theta = z158;
    accelerations.phi = z159;
    multipliers.lambda_along_x1 = z154;
    multipliers.lambda_along_y1 = z155;
    if (!(traits::regular(z140, -z62) && traits::regular(z78, z78) && traits::regular(p_C, p_C) && traits::regular(z144,
        z144) && traits::regular(z145, z145))) return torsor::Status::singular;
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
    const Scalar z161 = v_x * s_psi - v_y * c_psi;
    const Scalar z160 = v_x * c_psi + v_y * s_psi;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z40 = v_theta * c_phi + s_phi * z30;
    const Scalar z41 = v_theta * s_phi - c_phi * z30;
    const Scalar z42 = v_phi + z31;
    const Scalar z162 = s_theta * z10 - c_theta * z161;
    const Scalar z163 = c_theta * z10 + s_theta * z161;
    const Scalar z164 = c_phi * z160 + s_phi * z162;
    const Scalar z165 = s_phi * z160 - c_phi * z162;
    result.kinetic = n0_5 * (p_C * z42 * z42 + z163 * z163 + p_A * (z40 * z40 + z41 * z41) + z164 * z164 + z165 * z165);
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
    const Scalar z161 = v_x * s_psi - v_y * c_psi;
    const Scalar z160 = v_x * c_psi + v_y * s_psi;
    const Scalar z30 = s_theta * v_psi;
    const Scalar z31 = c_theta * v_psi;
    const Scalar z40 = v_theta * c_phi + s_phi * z30;
    const Scalar z41 = v_theta * s_phi - c_phi * z30;
    const Scalar z42 = v_phi + z31;
    const Scalar z162 = s_theta * z10 - c_theta * z161;
    const Scalar z163 = c_theta * z10 + s_theta * z161;
    const Scalar z164 = c_phi * z160 + s_phi * z162;
    const Scalar z165 = s_phi * z160 - c_phi * z162;
    result.energy = n9_81 * s_theta + n0_5 * (p_C * z42 * z42 + z163 * z163 + p_A * (z40 * z40 + z41 * z41) + z164
        * z164 + z165 * z165);
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
    const Scalar z192 = v_psi * s_psi;
    const Scalar z193 = v_psi * c_psi;
    const Scalar z190 = s_theta * v_theta;
    const Scalar z189 = c_theta * v_theta;
    const Scalar z191 = v_phi + v_x * c_psi + v_y * s_psi + c_theta * v_psi;
    const Scalar z194 = v_x * z192 - v_y * z193 + v_psi * z190;
    const Scalar z195 = v_x * s_psi - z190 - v_y * c_psi;
    const Scalar z196 = v_x * z193 + v_y * z192 - v_theta * z189;
    result.value[0] = n0;
    result.rate[0] = z191;
    result.gamma[0] = -z194;
    result.value[1] = n0;
    result.rate[1] = -z195;
    result.gamma[1] = -z196;
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
    const Scalar z445 = c_theta * c_theta + p_A;
    const Scalar z443 = c_theta * z59;
    const Scalar z442 = c_theta * p_C;
    const Scalar z439 = s_theta * v_psi;
    const Scalar z440 = c_theta * v_psi;
    const Scalar z457 = c_theta * a_psi;
    const Scalar z436 = s_theta * v_theta;
    const Scalar z456 = s_theta * a_psi;
    const Scalar z467 = v_psi * s_psi;
    const Scalar z435 = c_theta * v_theta;
    const Scalar z474 = v_x * s_psi;
    const Scalar z468 = v_psi * c_psi;
    const Scalar z437 = c_theta * a_theta;
    const Scalar z473 = v_x * c_psi + v_y * s_psi;
    const Scalar z477 = s_psi * l_lambda_along_x1;
    const Scalar z479 = s_psi * l_lambda_along_y1;
    const Scalar z438 = v_theta * z436 - z437;
    const Scalar z441 = v_phi + z440;
    const Scalar z502 = s_theta * a_theta;
    const Scalar z444 = c_theta * z443 - p_A;
    const Scalar z446 = v_theta * z436;
    const Scalar z447 = v_theta * z440;  // angular acceleration of hoop.2, y
    const Scalar z448 = v_theta * z439;  // angular acceleration of hoop.2, z
    const Scalar z454 = z439 * z440;
    const Scalar z458 = v_theta * z440 + z456;  // angular acceleration of hoop.2, y
    const Scalar z459 = v_theta * z439 - z457;  // angular acceleration of hoop.2, z
    const Scalar z469 = v_x * z467;
    const Scalar z471 = v_x * z468;
    const Scalar z475 = v_y * c_psi - z474;
    const Scalar z478 = c_psi * l_lambda_along_y1 + z477;
    const Scalar z480 = c_psi * l_lambda_along_x1 - z479;
    const Scalar z481 = n2 * z435;
    const Scalar z482 = p_C * z435;
    const Scalar z484 = p_C * z436;
    const Scalar z486 = c_theta * z439;
    const Scalar z491 = n2 * z440;
    const Scalar z493 = p_C * z439;
    const Scalar z500 = n2 * z436;
    const Scalar z503 = v_theta * z435 + z502;
    const Scalar z504 = z439 * z439;
    const Scalar z449 = z439 * z441;
    const Scalar z450 = v_theta * z441;
    const Scalar z453 = p_C * z448;  // moment on hoop, z
    const Scalar z470 = v_y * z468 - z469 - v_psi * z436;
    const Scalar z472 = z471 + v_y * z467 - v_theta * z435;
    const Scalar z476 = p_C * z441;
    const Scalar z483 = p_A * z481 - z482;
    const Scalar z487 = s_theta * z440 + z486;
    const Scalar z488 = s_theta * z441 + z486;
    const Scalar z501 = c_theta * z500;
    const Scalar z505 = z440 * z440 - z504;
    const Scalar z506 = z440 * z441 - z504;
    const Scalar z455 = n9_81 - z438;
    const Scalar z460 = a_phi - z459;  // angular acceleration of hoop, z
    const Scalar z462 = z447 + z458;
    const Scalar z495 = z448 + z459;
    const Scalar z497 = p_C * z458;
    const Scalar z451 = p_C * z449;  // moment on hoop, x
    const Scalar z511 = v_theta * p_C;
    const Scalar z452 = p_C * z450;  // moment on hoop, y
    const Scalar z518 = v_y * c_psi - z436 - z474;
    const Scalar z516 = v_y * z468 - z469;
    const Scalar z519 = v_y * z467 + z471;
    const Scalar z512 = s_theta * z511;
    const Scalar z513 = a_x * s_psi;
    const Scalar z492 = p_A * z491 - z476;
    const Scalar z496 = p_A * z495 - z453;
    const Scalar z507 = p_C * z506;
    const Scalar z461 = p_C * z460;  // moment on hoop, z
    const Scalar z464 = p_A * z462 - z452;  // moment on hoop.2, y
    const Scalar z508 = p_A * z505 - z507;
    const Scalar z521 = z437 - z446;
    const Scalar z463 = p_A * (a_theta - z454) + z451;  // moment on hoop.2, x
    const Scalar z515 = a_phi + a_x * c_psi + a_y * s_psi + z457 + z470;
    const Scalar z509 = z508 + c_theta * z503 + s_theta * z455;
    const Scalar z466 = c_theta * z455 + z463;
    const Scalar z514 = a_y * c_psi + z502 - z513 - z472;
    const Scalar z520 = a_y * c_psi - z513 - z519;
    const Scalar z517 = z516 + a_x * c_psi + a_y * s_psi;
    const Scalar z489 = p_C * z488;
    const Scalar z490 = p_A * z487 - z489;
    const Scalar z494 = s_theta * z492 - c_theta * z493;
    const Scalar z498 = s_theta * (z461 + z496) - c_theta * (z464 - z497);
    const Scalar z485 = s_theta * z483 - c_theta * z484;
    const Scalar z499 = s_theta * l_lambda_along_x1 - z498;
    const Scalar z510 = c_theta * l_lambda_along_y1 + z509;
    const Scalar z465 = c_theta * z461 + s_theta * z464;
    const Scalar z529 = c_psi * c_psi;
    const Scalar z530 = n1 + n1 / p_C - c_theta * c_theta / z444;
    const Scalar z525 = n1 / c_psi;
    const Scalar z537 = z475 * z525;
    const Scalar z573 = z515 * z525;
    const Scalar z524 = n1 / s_theta;
    const Scalar z531 = s_psi * z525;
    const Scalar z533 = c_theta * z525;
    const Scalar z543 = n2 * v_psi;
    const Scalar z574 = s_psi * z573 + z514;
    const Scalar z536 = z524 * z531;
    const Scalar z534 = s_psi * z533;
    const Scalar z540 = z439 * z525;
    const Scalar z538 = v_x / c_psi;
    const Scalar z535 = z524 * z534;
    const Scalar z539 = z524 * z538;
    const Scalar z575 = z524 * z574;
    const Scalar z578 = z445 * z536;
    const Scalar z541 = s_psi * z540 - z435;
    const Scalar z522 = v_psi * z435;
    const Scalar z523 = z456 + z522;
    const Scalar z542 = z524 * z541;
    const Scalar z545 = z518 + z467 * z533 + z439 * z535;
    const Scalar z548 = z468 * z533 - z473 - z481 * z535;
    const Scalar z553 = z525 * z545;
    const Scalar z584 = p_C + z525 * z525 + z536 * z578;
    const Scalar z554 = s_psi * z553 + z548;
    const Scalar z577 = z445 * z535;
    const Scalar z583 = z442 + z525 * z533 + z536 * z577;
    const Scalar z582 = z444 - z533 * z533 - z535 * z577;
    const Scalar z555 = z524 * z554;
    const Scalar z532 = z524 * z525;
    const Scalar z559 = z439 * z539 - z467 * z537;
    const Scalar z560 = z467 * z540 + z439 * z542;
    const Scalar z563 = z520 - z559;
    const Scalar z564 = z523 + z560;
    const Scalar z561 = z468 * z537 + z481 * z539;
    const Scalar z565 = z517 - z561;
    const Scalar z562 = z468 * z540 - z481 * z542;
    const Scalar z566 = z521 - z562;
    const Scalar z549 = z468 * z525 - z481 * z536;
    const Scalar z547 = z481 / (s_theta * c_psi);
    const Scalar z567 = z525 * z563;
    const Scalar z570 = z525 * z564;
    const Scalar z568 = s_psi * z567 - z565;
    const Scalar z571 = s_psi * z570 - z566;
    const Scalar z576 = z445 * z532;
    const Scalar z544 = z543 / c_psi;
    const Scalar z546 = s_psi * z543 / c_psi;
    const Scalar z550 = z525 * z544;
    const Scalar z556 = z525 * z546;
    const Scalar z569 = z524 * z568;
    const Scalar z572 = z524 * z571;
    const Scalar z551 = s_psi * z550 - z547;
    const Scalar z557 = s_psi * z556 + z549;
    const Scalar z580 = z531 * z533 + z535 * z576;
    const Scalar z581 = z525 * z531 + z536 * z576;
    const Scalar z552 = z524 * z551;
    const Scalar z558 = z524 * z557;
    const Scalar z579 = n1 + z531 * z531 + z532 * z576;
    const Scalar z585 = z531 * z550 + z552 * z576;
    const Scalar z526 = s_theta * s_theta;
    const Scalar z527 = n1 + z526 / z445;
    const Scalar z586 = z531 * z553 + z555 * z576;
    const Scalar z587 = z531 * z556 + z558 * z576;
    const Scalar z528 = z445 * z527;
    const Scalar z595 = z485 - z494 * z535;
    const Scalar z596 = z494 * z536 + z512;
    const Scalar z598 = z490 - z501 * z535;
    const Scalar z601 = z484 - z493 * z535;
    const Scalar z607 = z535 * z598 + z595;
    const Scalar z610 = z536 * z598 - z601;
    const Scalar z604 = z532 * z598;
    const Scalar z613 = z586 + z604;
    const Scalar z627 = z494 * z539;
    const Scalar z631 = z493 * z539;
    const Scalar z629 = z501 * z539;
    const Scalar z636 = z478 * z531 + z480 - z532 * z629;
    const Scalar z638 = z478 * z533 - z627 - z535 * z629;
    const Scalar z640 = z631 + z478 * z525 - z536 * z629;
    const Scalar z628 = z494 * z542;
    const Scalar z633 = z499 + z628;
    const Scalar z594 = z494 * z532;
    const Scalar z630 = z501 * z542;
    const Scalar z634 = z510 + z630;
    const Scalar z632 = z493 * z542;
    const Scalar z635 = z497 + z632;
    const Scalar z597 = z501 * z532;
    const Scalar z599 = z493 + z501 * z536;
    const Scalar z606 = z535 * z597 + z594;
    const Scalar z608 = z535 * z599 + z596;
    const Scalar z639 = z535 * z634 + z633;
    const Scalar z641 = z536 * z634 - z635;
    const Scalar z637 = z532 * z634;
    const Scalar z600 = z493 * z532;
    const Scalar z602 = z493 * z536;
    const Scalar z609 = z536 * z597 - z600;
    const Scalar z603 = z532 * z597;
    const Scalar z612 = z585 - z603;
    const Scalar z605 = z532 * z599;
    const Scalar z611 = z536 * z599 - z602;
    const Scalar z614 = z587 - z605;
    const Scalar z588 = z533 * z550 + z552 * z577;
    const Scalar z591 = z525 * z550 + z552 * z578;
    const Scalar z615 = z588 - z606;
    const Scalar z618 = z591 - z609;
    const Scalar z648 = a_x - c_psi * l_lambda_along_x1 + z479;
    const Scalar z589 = z533 * z553 + z555 * z577;
    const Scalar z592 = z525 * z553 + z555 * z578;
    const Scalar z616 = z589 + z607;
    const Scalar z619 = z592 + z610;
    const Scalar z590 = z533 * z556 + z558 * z577;
    const Scalar z593 = z525 * z556 + z558 * z578;
    const Scalar z617 = z590 - z608;
    const Scalar z620 = z593 - z611;
    const Scalar z659 = n1 / z584;
    const Scalar z650 = a_y - z513 / c_psi - z466 / (s_theta * c_psi);
    const Scalar z649 = s_theta * l_lambda_along_y1 - z466;
    const Scalar z651 = c_theta * l_lambda_along_x1 - z465 + z533 * z648 - z535 * z649;
    const Scalar z652 = l_lambda_along_x1 - z461 + z525 * z648 - z536 * z649;
    const Scalar z661 = z583 * z659;
    const Scalar z664 = z582 + z583 * z661;
    const Scalar z663 = z580 - z581 * z661;
    const Scalar z669 = z615 - z618 * z661;
    const Scalar z674 = z616 - z619 * z661;
    const Scalar z665 = n1 / z664;
    const Scalar z660 = z581 * z659;
    const Scalar z662 = z579 - z581 * z660;
    const Scalar z621 = z531 * z567 + z569 * z576;
    const Scalar z642 = z621 - z636;
    const Scalar z622 = z531 * z570 + z572 * z576;
    const Scalar z643 = z622 - z637;
    const Scalar z653 = z531 * z573 + z575 * z576;
    const Scalar z656 = z650 + z653;
    const Scalar z623 = z533 * z567 + z569 * z577;
    const Scalar z625 = z525 * z567 + z569 * z578;
    const Scalar z644 = z623 - z638;
    const Scalar z646 = z625 - z640;
    const Scalar z624 = z533 * z570 + z572 * z577;
    const Scalar z626 = z525 * z570 + z572 * z578;
    const Scalar z645 = z624 - z639;
    const Scalar z647 = z626 - z641;
    const Scalar z654 = z533 * z573 + z575 * z577;
    const Scalar z655 = z525 * z573 + z575 * z578;
    const Scalar z657 = z651 - z654;
    const Scalar z658 = z652 - z655;
    const Scalar z679 = z644 - z646 * z661;
    const Scalar z684 = z617 - z620 * z661;
    const Scalar z689 = z645 - z647 * z661;
    const Scalar z666 = z663 * z665;
    const Scalar z667 = z662 + z663 * z666;
    const Scalar z670 = z612 - z618 * z660 + z666 * z669;
    const Scalar z675 = z613 - z619 * z660 + z666 * z674;
    const Scalar z668 = n1 / z667;
    const Scalar z680 = z642 - z646 * z660 + z666 * z679;
    const Scalar z685 = z614 - z620 * z660 + z666 * z684;
    const Scalar z690 = z643 - z647 * z660 + z666 * z689;
    const Scalar z671 = z668 * z670;
    const Scalar z676 = z668 * z675;
    const Scalar z681 = z668 * z680;
    const Scalar z686 = z668 * z685;
    const Scalar z691 = z668 * z690;
    const Scalar z672 = z665 * z669 - z666 * z671;
    const Scalar z677 = z665 * z674 - z666 * z676;
    const Scalar z682 = z665 * z679 - z666 * z681;
    const Scalar z687 = z665 * z684 - z666 * z686;
    const Scalar z692 = z665 * z689 - z666 * z691;
    const Scalar z673 = z618 * z659 - z660 * z671 + z661 * z672;
    const Scalar z678 = z619 * z659 - z660 * z676 + z661 * z677;
    const Scalar z683 = z646 * z659 - z660 * z681 + z661 * z682;
    const Scalar z688 = z620 * z659 - z660 * z686 + z661 * z687;
    const Scalar z693 = z647 * z659 - z660 * z691 + z661 * z692;
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
    result.M[12] = -z444;
    result.M[13] = n0;
    result.M[14] = z442;
    result.M[15] = n0;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = z445;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = z442;
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
    result.C[12] = z485;
    result.C[13] = -z490;
    result.C[14] = -z484;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = z494;
    result.C[18] = -z501;
    result.C[19] = -z493;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = -z512;
    result.C[23] = z493;
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
    result.K[10] = z478;
    result.K[11] = -z480;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = z499;
    result.K[18] = -z510;
    result.K[19] = -z497;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.F[0] = -a_x + c_psi * l_lambda_along_x1 - z479;
    result.F[1] = -a_y + c_psi * l_lambda_along_y1 + z477;
    result.F[2] = c_theta * l_lambda_along_x1 - z465;
    result.F[3] = s_theta * l_lambda_along_y1 - z466;
    result.F[4] = l_lambda_along_x1 - z461;
    result.M_r[0] = z579;
    result.M_r[1] = z580;
    result.M_r[2] = z581;
    result.M_r[3] = z580;
    result.M_r[4] = -z582;
    result.M_r[5] = z583;
    result.M_r[6] = z581;
    result.M_r[7] = z583;
    result.M_r[8] = z584;
    result.C_r[0] = z612;
    result.C_r[1] = z615;
    result.C_r[2] = z618;
    result.C_r[3] = z613;
    result.C_r[4] = z616;
    result.C_r[5] = z619;
    result.C_r[6] = z614;
    result.C_r[7] = z617;
    result.C_r[8] = z620;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z642;
    result.K_r[7] = z644;
    result.K_r[8] = z646;
    result.K_r[9] = -z643;
    result.K_r[10] = -z645;
    result.K_r[11] = -z647;
    result.K_r[12] = n0;
    result.K_r[13] = n0;
    result.K_r[14] = n0;
    result.F_r[0] = -z656;
    result.F_r[1] = z657;
    result.F_r[2] = z658;
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
    result.A[16] = -z537;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = z539;
    result.A[20] = n0;
    result.A[21] = -z681;
    result.A[22] = z682;
    result.A[23] = -z683;
    result.A[24] = z540;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = z542;
    result.A[28] = n0;
    result.A[29] = z691;
    result.A[30] = -z692;
    result.A[31] = z693;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = -z531;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = -z532;
    result.A[44] = n0;
    result.A[45] = -z671;
    result.A[46] = z672;
    result.A[47] = -z673;
    result.A[48] = -z533;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = -z535;
    result.A[52] = n0;
    result.A[53] = -z676;
    result.A[54] = z677;
    result.A[55] = -z678;
    result.A[56] = -z525;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = -z536;
    result.A[60] = n1;
    result.A[61] = -z686;
    result.A[62] = z687;
    result.A[63] = -z688;
    if (!(traits::regular(z526, z528) && traits::regular(z529, z530) && traits::regular(z667, z579)
        && traits::regular(-z664, -z582) && traits::regular(z584, z584))) return torsor::Status::singular;
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
    const Scalar z699 = s_theta * v_psi;
    const Scalar z700 = c_theta * v_psi;
    const Scalar z709 = c_theta * a_psi;
    const Scalar z708 = s_theta * a_psi;
    const Scalar z696 = c_theta * v_theta;
    const Scalar z697 = s_theta * v_theta;
    const Scalar z748 = v_theta * p_C;
    const Scalar z717 = s_psi * l_lambda_along_x1 + c_psi * l_lambda_along_y1;
    const Scalar z718 = s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    const Scalar z749 = s_theta * z748;
    const Scalar z698 = c_theta * a_theta - v_theta * z697;
    const Scalar z701 = v_phi + z700;
    const Scalar z702 = v_theta * z700;  // angular acceleration of hoop.2, y
    const Scalar z703 = v_theta * z699;  // angular acceleration of hoop.2, z
    const Scalar z710 = v_theta * z700 + z708;  // angular acceleration of hoop.2, y
    const Scalar z711 = v_theta * z699 - z709;  // angular acceleration of hoop.2, z
    const Scalar z719 = n2 * z696;
    const Scalar z720 = p_C * z696;
    const Scalar z722 = p_C * z697;
    const Scalar z724 = c_theta * z699;
    const Scalar z729 = n2 * z700;
    const Scalar z731 = p_C * z699;
    const Scalar z738 = n2 * z697;
    const Scalar z740 = s_theta * a_theta + v_theta * z696;
    const Scalar z741 = z699 * z699;
    const Scalar z704 = v_theta * z701;
    const Scalar z706 = p_C * z703;  // moment on hoop, z
    const Scalar z716 = p_C * z701;
    const Scalar z721 = p_A * z719 - z720;
    const Scalar z725 = s_theta * z700 + z724;
    const Scalar z726 = s_theta * z701 + z724;
    const Scalar z739 = c_theta * z738;
    const Scalar z742 = z700 * z700 - z741;
    const Scalar z743 = z700 * z701 - z741;
    const Scalar z707 = n9_81 + z698;
    const Scalar z712 = a_phi - z711;  // angular acceleration of hoop, z
    const Scalar z714 = z702 + z710;
    const Scalar z733 = z703 + z711;
    const Scalar z735 = p_C * z710;
    const Scalar z705 = p_C * z704;  // moment on hoop, y
    const Scalar z730 = p_A * z729 - z716;
    const Scalar z713 = p_C * z712;  // moment on hoop, z
    const Scalar z723 = s_theta * z721 - c_theta * z722;
    const Scalar z727 = p_C * z726;
    const Scalar z734 = p_A * z733 - z706;
    const Scalar z744 = p_C * z743;
    const Scalar z715 = p_A * z714 - z705;  // moment on hoop.2, y
    const Scalar z728 = p_A * z725 - z727;
    const Scalar z732 = s_theta * z730 - c_theta * z731;
    const Scalar z745 = p_A * z742 - z744;
    const Scalar z736 = s_theta * (z713 + z734) - c_theta * (z715 - z735);
    const Scalar z746 = z745 + c_theta * z740 + s_theta * z707;
    const Scalar z737 = s_theta * l_lambda_along_x1 - z736;
    const Scalar z747 = c_theta * l_lambda_along_y1 + z746;
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
    result.by_position[10] = z717;
    result.by_position[11] = z718;
    result.by_position[12] = n0;
    result.by_position[13] = n0;
    result.by_position[14] = n0;
    result.by_position[15] = n0;
    result.by_position[16] = n0;
    result.by_position[17] = z737;
    result.by_position[18] = -z747;
    result.by_position[19] = -z735;
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
    result.by_velocity[12] = z723;
    result.by_velocity[13] = -z728;
    result.by_velocity[14] = -z722;
    result.by_velocity[15] = n0;
    result.by_velocity[16] = n0;
    result.by_velocity[17] = z732;
    result.by_velocity[18] = -z739;
    result.by_velocity[19] = -z731;
    result.by_velocity[20] = n0;
    result.by_velocity[21] = n0;
    result.by_velocity[22] = -z749;
    result.by_velocity[23] = z731;
    result.by_velocity[24] = n0;
  }

  /// Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by
  /// solving with the factorisation of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsDerivatives& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
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
    const Scalar z848 = precomputed.z848;
    const Scalar z862 = precomputed.z862;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z871 = c_theta * c_theta + p_A;
    const Scalar z866 = c_theta * v_psi;
    const Scalar z893 = s_theta * s_theta * p_A;
    const Scalar z865 = s_theta * v_psi;
    const Scalar z886 = v_psi * s_psi;
    const Scalar z864 = s_theta * v_theta;
    const Scalar z887 = v_psi * c_psi;
    const Scalar z868 = c_theta * p_C;
    const Scalar z863 = c_theta * v_theta;
    const Scalar z912 = v_y * c_psi;
    const Scalar z911 = v_x * c_psi + v_y * s_psi;
    const Scalar z869 = c_theta * z59;
    const Scalar z867 = v_phi + z866;
    const Scalar z870 = c_theta * z869 - p_A;
    const Scalar z872 = v_theta * z864;
    const Scalar z874 = v_theta * z866;  // angular acceleration of hoop.2, y
    const Scalar z875 = v_theta * z865;  // angular acceleration of hoop.2, z
    const Scalar z881 = z865 * z866;
    const Scalar z888 = v_x * z886 - v_y * z887 + v_psi * z864;
    const Scalar z889 = v_x * z887;
    const Scalar z890 = v_theta * z863;
    const Scalar z892 = z138 * z868;
    const Scalar z913 = v_x * s_psi - z912;
    const Scalar z915 = n2 * z863;
    const Scalar z916 = p_C * z863;
    const Scalar z918 = p_C * z864;
    const Scalar z919 = c_theta * z865;
    const Scalar z924 = n2 * z866;
    const Scalar z926 = p_C * z865;
    const Scalar z927 = n2 * z864;
    const Scalar z929 = z865 * z865;
    const Scalar z894 = n1 / z871;
    const Scalar z873 = n9_81 - z872;
    const Scalar z934 = v_theta * p_C;
    const Scalar z935 = s_theta * z934;
    const Scalar z876 = z865 * z867;
    const Scalar z877 = v_theta * z867;
    const Scalar z937 = z147 * z886;
    const Scalar z880 = p_C * z875;  // moment on hoop, z
    const Scalar z882 = n2 * z874;
    const Scalar z891 = v_y * z886 + z889 - z890;
    const Scalar z895 = n1 / z893;
    const Scalar z914 = p_C * z867;
    const Scalar z917 = p_A * z915 - z916;
    const Scalar z920 = s_theta * z866 + z919;
    const Scalar z921 = s_theta * z867 + z919;
    const Scalar z928 = c_theta * z927;
    const Scalar z930 = z866 * z866 - z929;
    const Scalar z931 = z866 * z867 - z929;
    const Scalar z936 = v_y * z886 + z889;
    const Scalar z878 = p_C * z876;  // moment on hoop, x
    const Scalar z879 = p_C * z877;  // moment on hoop, y
    const Scalar z942 = z138 * z937;
    const Scalar z925 = p_A * z924 - z914;
    const Scalar z922 = p_C * z921;
    const Scalar z932 = p_C * z931;
    const Scalar z883 = p_A * z881 - z878;  // moment on hoop.2, x
    const Scalar z943 = c_psi * z147;
    const Scalar z884 = p_A * z882 - z879;  // moment on hoop.2, y
    const Scalar z923 = p_A * z920 - z922;
    const Scalar z933 = p_A * z930 - z932;
    const Scalar z885 = c_theta * z873 - z883;
    const Scalar z952 = s_psi * z147;
    const Scalar z946 = z147 * z887;
    const Scalar z951 = z138 * z946;
    const Scalar z899 = s_theta * z884;
    const Scalar z896 = s_theta * z894;
    const Scalar z900 = z895 * z899;
    const Scalar z897 = n1 + s_theta * z896;
    const Scalar z901 = z885 * z894;
    const Scalar z902 = z138 * z880 + z892 * z900;
    const Scalar z904 = s_theta * z901 + z891;
    const Scalar z898 = n1 / z897;
    const Scalar z958 = v_psi * (v_x * s_psi - z912);
    const Scalar z903 = c_theta * z900 + z888 - z902;
    const Scalar z905 = z147 * z903;
    const Scalar z965 = s_theta * z917;
    const Scalar z910 = z138 * z905 + z902;
    const Scalar z906 = z898 * z904;
    const Scalar z966 = z895 * z965;
    const Scalar z938 = z887 * z898;
    const Scalar z944 = s_psi * z898;
    const Scalar z947 = z886 * z898;
    const Scalar z953 = c_psi * z898;
    const Scalar z960 = z898 * z958;
    const Scalar z907 = s_psi * z906 - c_psi * z905;
    const Scalar z967 = z894 * z923;
    const Scalar z908 = s_psi * z905 + c_psi * z906;
    const Scalar z968 = z138 * z918 + z892 * z966;
    const Scalar z909 = z896 * z906 - z901;
    const Scalar z969 = s_theta * z967 - z911;
    const Scalar z970 = z147 * z913;
    const Scalar z975 = z138 * z970 + z968;
    const Scalar z978 = c_theta * z900;
    const Scalar z979 = z875 + z978;  // angular acceleration of hoop.2, z
    const Scalar z984 = s_theta * z900;
    const Scalar z985 = z874 - z984;  // angular acceleration of hoop.2, y
    const Scalar z976 = z892 * z895;
    const Scalar z980 = z910 - z979;  // angular acceleration of hoop, z
    const Scalar z982 = z875 + z979;
    const Scalar z971 = z898 * z969;
    const Scalar z986 = z874 + z985;
    const Scalar z988 = p_C * z985;
    const Scalar z981 = p_C * z980;  // moment on hoop, z
    const Scalar z983 = p_A * z982 - z880;
    const Scalar z939 = s_psi * z938 - c_psi * z937;
    const Scalar z945 = n1 - c_psi * z943 - s_psi * z944;
    const Scalar z987 = p_A * z986 - z879;  // moment on hoop.2, y
    const Scalar z940 = s_psi * z937 + c_psi * z938;
    const Scalar z989 = s_theta * (z981 + z983) - c_theta * (z987 - z988);
    const Scalar z941 = z896 * z938;
    const Scalar z974 = z896 * z971 - z967;
    const Scalar z992 = s_theta * z909 + z890;
    const Scalar z977 = c_theta * z909 - z872;
    const Scalar z956 = c_psi * z908 - z936 + s_psi * z907;
    const Scalar z990 = s_theta * z905 - z989;
    const Scalar z957 = c_psi * z908 - z956 + s_psi * z907;
    const Scalar z1006 = z894 * z928;
    const Scalar z1004 = s_theta * z925;
    const Scalar z995 = z892 * z988 + z990;
    const Scalar z1005 = z895 * z1004;
    const Scalar z948 = c_psi * z946 + s_psi * z947;
    const Scalar z1008 = s_theta * z1006 + z915;
    const Scalar z949 = s_psi * z946 - c_psi * z947;
    const Scalar z950 = z896 * z947;
    const Scalar z1007 = z138 * z926 + z892 * z1005;
    const Scalar z959 = z147 * z957;
    const Scalar z961 = s_psi * z960 - z908 + c_psi * z959;
    const Scalar z962 = s_psi * z959 - z907 - c_psi * z960;
    const Scalar z963 = z896 * z960;
    const Scalar z964 = z138 * z959;
    const Scalar z1012 = s_theta / z871;
    const Scalar z996 = z895 * z995;
    const Scalar z998 = z138 * z988 + z892 * z996;
    const Scalar z991 = n9_81 + z977;
    const Scalar z993 = z933 + c_theta * z992 + s_theta * z991;
    const Scalar z1013 = z898 * z1012;
    const Scalar z1009 = z898 * z1008;
    const Scalar z954 = s_psi * z953 - c_psi * z952;
    const Scalar z994 = c_theta * z906 + z993;
    const Scalar z955 = n1 - s_psi * z952 - c_psi * z953;
    const Scalar z1018 = z894 * z926;
    const Scalar z997 = z894 * z994;
    const Scalar z1020 = s_theta * z1018;
    const Scalar z1017 = z895 * z935;
    const Scalar z1025 = z138 + z892 * z976;
    const Scalar z972 = c_psi * z970 + s_psi * z971;
    const Scalar z999 = s_theta * z997 + z977;
    const Scalar z1021 = z898 * z1020;
    const Scalar z973 = s_psi * z970 - c_psi * z971;
    const Scalar z1000 = z898 * z999;
    const Scalar z1010 = s_psi * z1009;
    const Scalar z1011 = c_psi * z1009;
    const Scalar z1014 = s_psi * z1013;
    const Scalar z1015 = c_psi * z1013;
    const Scalar z1016 = z894 - z896 * z1013;
    const Scalar z1001 = s_psi * z1000;
    const Scalar z1002 = c_psi * z1000;
    const Scalar z1003 = z896 * z1000 - z997;
    const Scalar z1019 = z892 * z1017;
    const Scalar z1022 = s_psi * z1021;
    const Scalar z1023 = c_psi * z1021;
    const Scalar z1024 = z896 * z1021 - z1018;
    const Scalar z1026 = c_psi * z848;
    const Scalar z1027 = s_psi * z848;
    const Scalar z1028 = z862 - z1025;
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
    result.by_position[10] = z961;
    result.by_position[11] = z962;
    result.by_position[12] = n0;
    result.by_position[13] = -z963;
    result.by_position[14] = z964;
    result.by_position[15] = z1001;
    result.by_position[16] = -z1002;
    result.by_position[17] = -z996;
    result.by_position[18] = -z1003;
    result.by_position[19] = z998;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = -z939;
    result.by_velocity[1] = z940;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = z941;
    result.by_velocity[4] = z942;
    result.by_velocity[5] = -z948;
    result.by_velocity[6] = -z949;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = z950;
    result.by_velocity[9] = -z951;
    result.by_velocity[10] = z972;
    result.by_velocity[11] = z973;
    result.by_velocity[12] = -z966;
    result.by_velocity[13] = -z974;
    result.by_velocity[14] = z975;
    result.by_velocity[15] = z1010;
    result.by_velocity[16] = -z1011;
    result.by_velocity[17] = -z1005;
    result.by_velocity[18] = n0;
    result.by_velocity[19] = z1007;
    result.by_velocity[20] = -z1022;
    result.by_velocity[21] = z1023;
    result.by_velocity[22] = z1017;
    result.by_velocity[23] = z1024;
    result.by_velocity[24] = -z1019;
    result.by_force[0] = z945;
    result.by_force[1] = z954;
    result.by_force[2] = n0;
    result.by_force[3] = z1014;
    result.by_force[4] = -z1026;
    result.by_force[5] = z954;
    result.by_force[6] = z955;
    result.by_force[7] = n0;
    result.by_force[8] = -z1015;
    result.by_force[9] = -z1027;
    result.by_force[10] = n0;
    result.by_force[11] = n0;
    result.by_force[12] = z895;
    result.by_force[13] = n0;
    result.by_force[14] = -z976;
    result.by_force[15] = z1014;
    result.by_force[16] = -z1015;
    result.by_force[17] = n0;
    result.by_force[18] = z1016;
    result.by_force[19] = n0;
    result.by_force[20] = -z1026;
    result.by_force[21] = -z1027;
    result.by_force[22] = -z976;
    result.by_force[23] = n0;
    result.by_force[24] = -z1028;
    result.multipliers_by_position[0] = n0;
    result.multipliers_by_position[1] = n0;
    result.multipliers_by_position[2] = n0;
    result.multipliers_by_position[3] = n0;
    result.multipliers_by_position[4] = z959;
    result.multipliers_by_position[5] = -z960;
    result.multipliers_by_position[6] = n0;
    result.multipliers_by_position[7] = -z1000;
    result.multipliers_by_position[8] = n0;
    result.multipliers_by_position[9] = n0;
    result.multipliers_by_velocity[0] = z937;
    result.multipliers_by_velocity[1] = z938;
    result.multipliers_by_velocity[2] = -z946;
    result.multipliers_by_velocity[3] = z947;
    result.multipliers_by_velocity[4] = z970;
    result.multipliers_by_velocity[5] = -z971;
    result.multipliers_by_velocity[6] = n0;
    result.multipliers_by_velocity[7] = -z1009;
    result.multipliers_by_velocity[8] = n0;
    result.multipliers_by_velocity[9] = z1021;
    result.multipliers_by_force[0] = -z943;
    result.multipliers_by_force[1] = z944;
    result.multipliers_by_force[2] = -z952;
    result.multipliers_by_force[3] = -z953;
    result.multipliers_by_force[4] = n0;
    result.multipliers_by_force[5] = n0;
    result.multipliers_by_force[6] = n0;
    result.multipliers_by_force[7] = -z1013;
    result.multipliers_by_force[8] = -z848;
    result.multipliers_by_force[9] = n0;
    if (!(traits::regular(z893, -z870) && traits::regular(z871, z871) && traits::regular(p_C, p_C)
        && traits::regular(z144, z144) && traits::regular(z897, z897))) return torsor::Status::singular;
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
      const Scalar x18 = (sums_[10] + z141 * x17) * -i18;
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
        z144) && traits::regular(z145, z145))) return torsor::Status::singular;
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
    const Scalar z1030 = a_theta - z92;
    const Scalar z113 = a_phi - z110;  // angular acceleration of hoop, z
    const Scalar z115 = z83 + z109;
    const Scalar z1029 = s_theta * z115;
    const Scalar z1031 = s_theta * z88 - c_theta * z113;
    result.by_parameter[0] = n0;
    result.by_parameter[1] = n0;
    result.by_parameter[2] = z1029;
    result.by_parameter[3] = z1030;
    result.by_parameter[4] = n0;
    result.by_parameter[5] = n0;
    result.by_parameter[6] = n0;
    result.by_parameter[7] = -z1031;
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
    const Scalar z1061 = c_theta * v_psi;
    const Scalar z1086 = s_theta * s_theta * p_A;
    const Scalar z1081 = v_psi * s_psi;
    const Scalar z1066 = c_theta * c_theta + p_A;
    const Scalar z1060 = s_theta * v_psi;
    const Scalar z1082 = v_psi * c_psi;
    const Scalar z1059 = s_theta * v_theta;
    const Scalar z1063 = c_theta * p_C;
    const Scalar z1058 = c_theta * v_theta;
    const Scalar z1064 = c_theta * z59;
    const Scalar z1062 = v_phi + z1061;
    const Scalar z1065 = c_theta * z1064 - p_A;
    const Scalar z1067 = v_theta * z1059;
    const Scalar z1069 = v_theta * z1061;  // angular acceleration of hoop.2, y
    const Scalar z1070 = v_theta * z1060;  // angular acceleration of hoop.2, z
    const Scalar z1076 = z1060 * z1061;
    const Scalar z1083 = v_x * z1081 - v_y * z1082 + v_psi * z1059;
    const Scalar z1084 = v_x * z1082 + v_y * z1081 - v_theta * z1058;
    const Scalar z1085 = z138 * z1063;
    const Scalar z1087 = n1 / z1066;
    const Scalar z1068 = n9_81 - z1067;
    const Scalar z1071 = z1060 * z1062;
    const Scalar z1072 = v_theta * z1062;
    const Scalar z1075 = p_C * z1070;  // moment on hoop, z
    const Scalar z1077 = n2 * z1069;
    const Scalar z1088 = n1 / z1086;
    const Scalar z1073 = p_C * z1071;  // moment on hoop, x
    const Scalar z1074 = p_C * z1072;  // moment on hoop, y
    const Scalar z1078 = p_A * z1076 - z1073;  // moment on hoop.2, x
    const Scalar z1079 = p_A * z1077 - z1074;  // moment on hoop.2, y
    const Scalar z1080 = c_theta * z1068 - z1078;
    const Scalar z1092 = s_theta * z1079;
    const Scalar z1089 = s_theta * z1087;
    const Scalar z1121 = z1071 * z1087;
    const Scalar z1093 = z1088 * z1092;
    const Scalar z1090 = n1 + s_theta * z1089;
    const Scalar z1094 = z1080 * z1087;
    const Scalar z1124 = s_theta * z1121;
    const Scalar z1095 = z138 * z1075 + z1085 * z1093;
    const Scalar z1102 = c_theta * z1093;
    const Scalar z1105 = s_theta * z1093;
    const Scalar z1097 = s_theta * z1094 + z1084;
    const Scalar z1091 = n1 / z1090;
    const Scalar z1103 = z1070 + z1102;  // angular acceleration of hoop.2, z
    const Scalar z1106 = z1069 - z1105;  // angular acceleration of hoop.2, y
    const Scalar z1096 = c_theta * z1093 + z1083 - z1095;
    const Scalar z1107 = z1069 + z1106;
    const Scalar z1098 = z147 * z1096;
    const Scalar z1108 = s_theta * z1107;
    const Scalar z1101 = z138 * z1098 + z1095;
    const Scalar z1110 = z1088 * z1108;
    const Scalar z1104 = z1101 - z1103;  // angular acceleration of hoop, z
    const Scalar z1099 = z1091 * z1097;
    const Scalar z1112 = z1085 * z1110;
    const Scalar z1126 = z1091 * z1124;
    const Scalar z1118 = s_theta * z1072 - c_theta * z1104;
    const Scalar z1100 = z1089 * z1099 - z1094;
    const Scalar z1129 = z1089 * z1126 - z1121;
    const Scalar z1119 = z1085 * z1104 + z1118;
    const Scalar z1109 = z1076 - z1100;
    const Scalar z1111 = z1087 * z1109;
    const Scalar z1120 = z1088 * z1119;
    const Scalar z1113 = s_theta * z1111;
    const Scalar z1122 = z138 * z1104 + z1085 * z1120;
    const Scalar z1114 = z1091 * z1113;
    const Scalar z1123 = c_theta * z1120 - z1122;
    const Scalar z1115 = s_psi * z1114;
    const Scalar z1116 = c_psi * z1114;
    const Scalar z1117 = z1089 * z1114 - z1111;
    const Scalar z1125 = z147 * z1123;
    const Scalar z1127 = s_psi * z1126 + c_psi * z1125;
    const Scalar z1128 = s_psi * z1125 - c_psi * z1126;
    const Scalar z1130 = z138 * z1125 + z1122;
    result.by_parameter[0] = z1115;
    result.by_parameter[1] = -z1116;
    result.by_parameter[2] = -z1110;
    result.by_parameter[3] = -z1117;
    result.by_parameter[4] = z1112;
    result.by_parameter[5] = -z1127;
    result.by_parameter[6] = -z1128;
    result.by_parameter[7] = z1120;
    result.by_parameter[8] = z1129;
    result.by_parameter[9] = -z1130;
    result.multipliers_by_parameter[0] = n0;
    result.multipliers_by_parameter[1] = -z1114;
    result.multipliers_by_parameter[2] = -z1125;
    result.multipliers_by_parameter[3] = z1126;
    if (!(traits::regular(z1086, -z1065) && traits::regular(z1066, z1066) && traits::regular(p_C, p_C)
        && traits::regular(z144, z144) && traits::regular(z1090, z1090))) return torsor::Status::singular;
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
