// SPDX-License-Identifier: MIT
// double_pendulum: Planar double pendulum with absolute angles
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation, inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor, jets, inverse_dynamics_second_derivatives, forward_dynamics_second_derivatives
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function                             additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                                   4                4          0             0                  2       0     12      12
//   mass_matrix                                  1                0          0             0                  1       0      3       3
//   bias                                         4                8          0             0                  2       0     16      16
//   inverse_dynamics                            10                9          0             0                  2       0     23      24
//   forward_dynamics                             7               12          1             0                  2       0     24      24
//   energy                                       6                8          0             0                  3       0     20      24
//   first_integrals                              7                8          0             0                  3       0     21      25
//   linearisation                               26               32          1             0                  2       0     63      66
//   inverse_dynamics_derivatives                13               15          0             0                  2       0     32      34
//   forward_dynamics_derivatives                24               36          1             0                  2       0     65      67
//   regressor                                    7               12          0             0                  2       0     23      23
//   jets                                        32               41          1             0                  2       0     78       -
//   inverse_dynamics_second_derivatives         15               16          0             0                  2       0     35      37
//   forward_dynamics_second_derivatives         56               72          1             0                  2       0    133     145
//
// Not computed because this mechanism does not need it:
//   kinematics: of 36 results 16 vanish identically, 6 repeat another up to sign
//   mass_matrix: of 4 results 1 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 8 vanish identically, 1 repeat another up to sign
//   inverse_dynamics_derivatives: of 8 results 2 vanish identically
//   forward_dynamics_derivatives: of 12 results 1 repeat another up to sign
//   regressor: of 12 results 4 vanish identically
//   inverse_dynamics_second_derivatives: of 32 results 14 vanish identically, 9 repeat another up to sign
//   forward_dynamics_second_derivatives: of 24 results 4 vanish identically, 6 repeat another up to sign
//
// To write this file again:
//   double_pendulum_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,inverse_dynamics_derivatives,forward_dynamics_derivatives,regressor,jets,inverse_dynamics_second_derivatives,forward_dynamics_second_derivatives --output double_pendulum.hpp
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

namespace double_pendulum {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "double_pendulum";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe10a64ea4ae07a8cULL;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar theta_1;  ///< coordinate [rad or 1]
    Scalar theta_2;  ///< coordinate [rad or 1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta_1, &Coordinates::theta_2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta_1;  ///< its rate [rad/s]
    Scalar theta_2;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta_1, &Velocities::theta_2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta_1;  ///< its second rate [rad/s^2]
    Scalar theta_2;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta_1, &Accelerations::theta_2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta_1;  ///< works with the rate of theta_1 [N m]
    Scalar theta_2;  ///< works with the rate of theta_2 [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta_1, &GeneralizedForces::theta_2};
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    state.time = n0;
    state.q.theta_1 = n2;
    state.q.theta_2 = n2_5;
    state.v.theta_1 = n0;
    state.v.theta_2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> first_mass_position;  ///< centre of mass of first_mass [m]
    std::array<Scalar, 9> first_mass_rotation;  ///< from the axes of first_mass to the ground's (3 x 3)
    std::array<Scalar, 3> first_mass_velocity;  ///< velocity of the centre of mass of first_mass [m/s]
    std::array<Scalar, 3> first_mass_angular_velocity;  ///< angular velocity of first_mass [rad/s]
    std::array<Scalar, 3> second_mass_position;  ///< centre of mass of second_mass [m]
    std::array<Scalar, 9> second_mass_rotation;  ///< from the axes of second_mass to the ground's (3 x 3)
    std::array<Scalar, 3> second_mass_velocity;  ///< velocity of the centre of mass of second_mass [m/s]
    std::array<Scalar, 3> second_mass_angular_velocity;  ///< angular velocity of second_mass [rad/s]
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

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 4> M;  ///< mass matrix (2 x 2)
    std::array<Scalar, 4> C;  ///< damping and gyroscopic terms (2 x 2)
    std::array<Scalar, 4> K;  ///< stiffness (2 x 2)
    std::array<Scalar, 2> F;  ///< right-hand side
    std::array<Scalar, 16> A;  ///< state matrix of x = (e, e'): x' = A x + B du (4 x 4)
  };

  /// Derivatives of generalised forces, stored column by column.
  struct InverseDynamicsDerivatives {
    std::array<Scalar, 4> by_position;  ///< df_i/dq_j (2 x 2)
    std::array<Scalar, 4> by_velocity;  ///< df_i/dv_j (2 x 2)
  };

  /// Derivatives of accelerations and multipliers, stored column by column.
  struct ForwardDynamicsDerivatives {
    std::array<Scalar, 4> by_position;  ///< da_i/dq_j (2 x 2)
    std::array<Scalar, 4> by_velocity;  ///< da_i/dv_j (2 x 2)
    std::array<Scalar, 4> by_force;  ///< da_i/df_j, f generalised forces added to E u (2 x 2)
  };

  /// What the generalised forces are linear in, stored column by column.
  struct Regressor {
    std::array<Scalar, 12> Y;  ///< forces of unit base parameters (2 x 6)
  };
  /// Standard inertial parameters of the links, ten each about the link's origin in its axes:
  ///   m h_x h_y h_z J_xx J_xy J_xz J_yy J_yz J_zz (J_xy = minus the integral of x y dm).
  /// 0 to 9: frame upper with body first_mass
  /// 10 to 19: frame lower with body second_mass
  static constexpr int inertial_parameter_count = 20;
  /// Base parameters pi_b, by their place in the list above; of the others those that have an effect are
  /// combined with them. First link to last: what a joint cannot tell apart goes towards the ground
  /// (Gautier & Khalil, 1990).
  static constexpr int base_parameter_count = 6;
  static constexpr int base_parameters[] = {1, 2, 9, 11, 12, 19};
  /// pi_base = pi_b + K pi_d: each pi_base[regrouped_to[k]], from pi[base_parameters[...]], gains
  /// regrouping_factors[k] * pi[regrouped_from[k]].
  static constexpr int regrouping_count = 2;
  static constexpr int regrouped_from[] = {10, 10};
  static constexpr int regrouped_to[] = {1, 2};
  static constexpr double regrouping_factors[] = {-1, 1};

  /// Second derivatives of generalised forces, page by page.
  struct InverseDynamicsSecondDerivatives {
    std::array<Scalar, 8> by_position_position;  ///< d2f_i/dq_j dq_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_position_velocity;  ///< d2f_i/dq_j dv_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_velocity_velocity;  ///< d2f_i/dv_j dv_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_acceleration_position;  ///< d2f_i/da_j dq_k = dM_ij/dq_k, 2 pages (2 x 4)
  };

  /// Second derivatives of accelerations and multipliers, page by page.
  struct ForwardDynamicsSecondDerivatives {
    std::array<Scalar, 8> by_position_position;  ///< d2a_i/dq_j dq_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_position_velocity;  ///< d2a_i/dq_j dv_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_velocity_velocity;  ///< d2a_i/dv_j dv_k, 2 pages (2 x 4)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = v_theta_1 * c_theta_1;  // velocity of lower, x
    const Scalar z1 = v_theta_1 * s_theta_1;  // velocity of lower, y
    const Scalar z2 = s_theta_1 + s_theta_2;
    const Scalar z3 = c_theta_1 + c_theta_2;
    const Scalar z4 = v_theta_2 * c_theta_2 + z0;
    const Scalar z5 = v_theta_2 * s_theta_2 + z1;
    result.first_mass_position[0] = s_theta_1;
    result.first_mass_position[1] = -c_theta_1;
    result.first_mass_position[2] = n0;
    result.first_mass_rotation[0] = c_theta_1;
    result.first_mass_rotation[1] = s_theta_1;
    result.first_mass_rotation[2] = n0;
    result.first_mass_rotation[3] = -s_theta_1;
    result.first_mass_rotation[4] = c_theta_1;
    result.first_mass_rotation[5] = n0;
    result.first_mass_rotation[6] = n0;
    result.first_mass_rotation[7] = n0;
    result.first_mass_rotation[8] = n1;
    result.first_mass_velocity[0] = z0;
    result.first_mass_velocity[1] = z1;
    result.first_mass_velocity[2] = n0;
    result.first_mass_angular_velocity[0] = n0;
    result.first_mass_angular_velocity[1] = n0;
    result.first_mass_angular_velocity[2] = v_theta_1;
    result.second_mass_position[0] = z2;
    result.second_mass_position[1] = -z3;
    result.second_mass_position[2] = n0;
    result.second_mass_rotation[0] = c_theta_2;
    result.second_mass_rotation[1] = s_theta_2;
    result.second_mass_rotation[2] = n0;
    result.second_mass_rotation[3] = -s_theta_2;
    result.second_mass_rotation[4] = c_theta_2;
    result.second_mass_rotation[5] = n0;
    result.second_mass_rotation[6] = n0;
    result.second_mass_rotation[7] = n0;
    result.second_mass_rotation[8] = n1;
    result.second_mass_velocity[0] = z4;
    result.second_mass_velocity[1] = z5;
    result.second_mass_velocity[2] = n0;
    result.second_mass_angular_velocity[0] = n0;
    result.second_mass_angular_velocity[1] = n0;
    result.second_mass_angular_velocity[2] = v_theta_2;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    mass[0] = n2;
    mass[1] = z2;
    mass[2] = z2;
    mass[3] = n1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = v_theta_2 * v_theta_2;
    const Scalar z6 = n9_81 * s_theta_1;
    const Scalar z7 = z1 * z5;
    const Scalar z8 = z3 + z4;
    const Scalar z9 = z1 * z8 - z2 * z6;
    const Scalar z10 = n2 * z6 + z7;
    forces.theta_1 = z10;
    forces.theta_2 = -z9;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n9_81 * s_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = a_theta_2 * z2 + z1 * z6;
    const Scalar z8 = a_theta_1 + z5;
    const Scalar z9 = z3 + z4;
    const Scalar z10 = z1 * z9 - z2 * z8;
    const Scalar z11 = a_theta_2 - z10;  // moment on lower, z
    const Scalar z12 = n2 * (a_theta_1 + z5) + z7 + z11;  // moment on upper, z
    const Scalar z13 = z11 - z12;
    forces.theta_1 = -z13;
    forces.theta_2 = z11;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = z3 + z4;
    const Scalar z10 = z1 * z9 - z2 * z7;
    const Scalar z11 = n2 * z7 + z8;
    const Scalar z12 = n1 / z5;
    const Scalar z13 = z2 * z10 + z11;
    const Scalar z14 = z12 * z13;
    const Scalar z15 = z2 * z14 + z10;
    accelerations.theta_1 = -z14;
    accelerations.theta_2 = z15;
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.theta_1 * accelerations.theta_2;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0, q_theta_2};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar c_theta_2 = cosines_[2];
    const Scalar z3 = v_theta_1 * z2;
    const Scalar z4 = v_theta_1 * z1;
    const Scalar z5 = v_theta_2 + z3;
    result.kinetic = n0_5 * (v_theta_1 * v_theta_1 + z4 * z4 + z5 * (v_theta_2 + z3));
    result.force_function = n19_62 * c_theta_1 + n9_81 * c_theta_2;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0, q_theta_2};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar c_theta_2 = cosines_[2];
    const Scalar z3 = v_theta_1 * z2;
    const Scalar z4 = v_theta_1 * z1;
    const Scalar z5 = v_theta_2 + z3;
    result.energy = n0_5 * (v_theta_1 * v_theta_1 + z4 * z4 + z5 * (v_theta_2 + z3)) - n19_62 * c_theta_1 - n9_81
        * c_theta_2;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = n9_81 * c_theta_1;
    const Scalar z5 = v_theta_1 * v_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n2 - z2 * z2;
    const Scalar z8 = a_theta_2 * z1 - z2 * z6;
    const Scalar z9 = n2 * v_theta_1;
    const Scalar z10 = a_theta_2 * z2 + z1 * z6;
    const Scalar z11 = z1 * z9;
    const Scalar z12 = n2 * v_theta_2;
    const Scalar z13 = z1 * z12;
    const Scalar z14 = a_theta_1 + z3;
    const Scalar z15 = z4 + z5;
    const Scalar z16 = z1 * z15 - z2 * z14;
    const Scalar z17 = z1 * z14 + z2 * z15;
    const Scalar z18 = z1 * (z3 - z14) + z2 * (z4 - z15);
    const Scalar z19 = z2 * z11;
    const Scalar z20 = n1 / z7;
    const Scalar z21 = a_theta_2 - z16;  // moment on lower, z
    const Scalar z22 = z17 + z8;
    const Scalar z23 = n2 * (a_theta_1 + z3) + z10 + z21;  // moment on upper, z
    const Scalar z24 = n2 * z4 - z8 + z18;
    const Scalar z25 = z17 - z22;
    const Scalar z26 = z21 - z23;
    const Scalar z27 = z18 - z24;
    const Scalar z28 = z2 * z17 + z25;
    const Scalar z29 = z20 * z19;
    const Scalar z30 = z13 * z20;
    const Scalar z31 = z2 * z18 + z27;
    const Scalar z32 = z2 * z29 + z11;
    const Scalar z33 = z20 * z28;
    const Scalar z34 = z2 * z30;
    const Scalar z35 = z20 * z31;
    const Scalar z36 = z2 * z33 + z17;
    const Scalar z37 = z2 * z35 + z18;
    result.M[0] = n2;
    result.M[1] = z2;
    result.M[2] = z2;
    result.M[3] = n1;
    result.C[0] = n0;
    result.C[1] = -z11;
    result.C[2] = z13;
    result.C[3] = n0;
    result.K[0] = -z27;
    result.K[1] = z18;
    result.K[2] = -z25;
    result.K[3] = z17;
    result.F[0] = z26;
    result.F[1] = -z21;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = z35;
    result.A[3] = -z37;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = z33;
    result.A[7] = -z36;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = -z29;
    result.A[11] = z32;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = -z30;
    result.A[15] = z34;
    if (!(traits::regular(z7, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[1] * result.M[2] * result.C[1] * result.C[2] * result.K[0] * result.K[1]
        * result.K[2] * result.K[3] * result.F[0]) * (n0 * result.F[1] * result.A[2] * result.A[3] * result.A[6]
        * result.A[7] * result.A[10] * result.A[11] * result.A[14] * result.A[15]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Derivatives of inverse_dynamics at (q, v, a, lambda). That by accelerations is the mass matrix.
  TORSOR_DEVICE static void inverse_dynamics_derivatives(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = n9_81 * c_theta_1;
    const Scalar z5 = v_theta_1 * v_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n2 * v_theta_1;
    const Scalar z8 = n2 * v_theta_2;
    const Scalar z9 = a_theta_2 * z1 - z2 * z6;
    const Scalar z10 = z1 * z7;
    const Scalar z11 = z1 * z8;
    const Scalar z12 = a_theta_1 + z3;
    const Scalar z13 = z4 + z5;
    const Scalar z14 = z1 * z12 + z2 * z13;
    const Scalar z15 = z1 * (z3 - z12) + z2 * (z4 - z13);
    const Scalar z16 = z14 + z9;
    const Scalar z17 = n2 * z4 - z9 + z15;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z15 - z17;
    result.by_position[0] = -z19;
    result.by_position[1] = z15;
    result.by_position[2] = -z18;
    result.by_position[3] = z14;
    result.by_velocity[0] = n0;
    result.by_velocity[1] = -z10;
    result.by_velocity[2] = z11;
    result.by_velocity[3] = n0;
  }

  /// Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by
  /// solving with the factorisation of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed&, const State& state,
      const Inputs&, ForwardDynamicsDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = n2 * v_theta_1;
    const Scalar z10 = z1 * z9;
    const Scalar z11 = n2 * v_theta_2;
    const Scalar z12 = z1 * z11;
    const Scalar z13 = z3 + z4;
    const Scalar z14 = z1 * z13 - z2 * z7;
    const Scalar z15 = n2 * z7 + z8;
    const Scalar z16 = z2 * z10;
    const Scalar z17 = n1 / z5;
    const Scalar z18 = z2 * z14 + z15;
    const Scalar z19 = z17 * z18;
    const Scalar z20 = z17 * z16;
    const Scalar z21 = z2 * z17;
    const Scalar z22 = z12 * z17;
    const Scalar z23 = z2 * z19 + z14;
    const Scalar z24 = z7 - z19;
    const Scalar z25 = z2 * z20 + z10;
    const Scalar z26 = z2 * z22;
    const Scalar z27 = n1 + z2 * z21;
    const Scalar z28 = z2 * (z3 - z13) + z1 * (z7 - z24);
    const Scalar z29 = z2 * z13 + z1 * z24;
    const Scalar z30 = z1 * z23 - z2 * z6;
    const Scalar z31 = n2 * z3 + z28 - z30;
    const Scalar z32 = z30 + z29;
    const Scalar z33 = z29 - z32;
    const Scalar z34 = z28 - z31;
    const Scalar z35 = z2 * z29 + z33;
    const Scalar z36 = z2 * z28 + z34;
    const Scalar z37 = z17 * z35;
    const Scalar z38 = z17 * z36;
    const Scalar z39 = z2 * z37 + z29;
    const Scalar z40 = z2 * z38 + z28;
    result.by_position[0] = z38;
    result.by_position[1] = -z40;
    result.by_position[2] = z37;
    result.by_position[3] = -z39;
    result.by_velocity[0] = -z20;
    result.by_velocity[1] = z25;
    result.by_velocity[2] = -z22;
    result.by_velocity[3] = z26;
    result.by_force[0] = z17;
    result.by_force[1] = -z21;
    result.by_force[2] = -z21;
    result.by_force[3] = z27;
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.by_position[0] * result.by_position[1] * result.by_position[2]
        * result.by_position[3] * result.by_velocity[0] * result.by_velocity[1] * result.by_velocity[2]
        * result.by_velocity[3] * result.by_force[0] * result.by_force[1] * result.by_force[2] * result.by_force[3];
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Regressor: Y pi_base are the generalised forces of inertia and gravity at (q, v, a), inverse_dynamics without
  /// other actions and multipliers. Y has the columns of base_parameters only: those of the other inertial
  /// parameters are combinations of them, no measurement tells them apart, and least squares with them are singular.
  TORSOR_DEVICE static void regressor(const Precomputed&, const State& state, const Accelerations& accelerations,
      Regressor& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = n9_81 * c_theta_1;
    const Scalar z5 = v_theta_1 * v_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = a_theta_2 * z1 - z2 * z6;
    const Scalar z8 = a_theta_2 * z2 + z1 * z6;
    const Scalar z9 = a_theta_1 + z3;
    const Scalar z10 = z4 + z5;
    const Scalar z11 = z1 * z10 - z2 * z9;
    const Scalar z12 = z1 * z9 + z2 * z10;
    result.Y[0] = z4;
    result.Y[1] = n0;
    result.Y[2] = -z3;
    result.Y[3] = n0;
    result.Y[4] = a_theta_1;
    result.Y[5] = n0;
    result.Y[6] = z7;
    result.Y[7] = z12;
    result.Y[8] = -z8;
    result.Y[9] = z11;
    result.Y[10] = n0;
    result.Y[11] = a_theta_2;
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 10 operations take a convolution at each order; accelerations
  /// are solved for, in the inverse dynamics, by the factors of M at the start.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed&, const State& state, const Inputs&, int order,
      std::array<Scalar, 4>* coefficients) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = z3 + z4;
    const Scalar z10 = z1 * z9 - z2 * z7;
    const Scalar z11 = n2 * z7 + z8;
    const Scalar z12 = n1 / z5;
    const Scalar z13 = z2 * z10 + z11;
    const Scalar z14 = z12 * z13;
    const Scalar z15 = z2 * z14 + z10;
    const Scalar b11 = v_theta_2 * v_theta_2;
    const Scalar b14 = v_theta_1 * v_theta_1;
    const Scalar b15 = n9_81 * c_theta_1 + b14;
    const Scalar b7 = z15;
    const Scalar b2 = -z14;
    const Scalar b17 = b2 + n9_81 * s_theta_1;
    coefficients[0][0] = state.q.theta_1;
    coefficients[0][1] = state.q.theta_2;
    coefficients[0][2] = state.v.theta_1;
    coefficients[0][3] = state.v.theta_2;
    coefficients[1][0] = v_theta_1;
    coefficients[1][1] = v_theta_2;
    coefficients[1][2] = -z14;
    coefficients[1][3] = z15;
    torsor::Convolutions<Scalar, 10> operations_;
    typename torsor::Convolutions<Scalar, 10>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][0];
      const Scalar x1 = coefficients[k_][2];
      const Scalar x3 = inverse_ * sums_[0] + c_theta_1 * x0;
      const Scalar w0 = number_ * x0;
      const Scalar x4 = -inverse_ * sums_[1] - s_theta_1 * x0;
      const Scalar x5 = coefficients[k_][1];
      const Scalar x6 = coefficients[k_][3];
      const Scalar x8 = x0 - x5;
      const Scalar x9 = inverse_ * sums_[2] + z2 * x8;
      const Scalar w8 = number_ * x8;
      const Scalar x10 = -inverse_ * sums_[3] - z1 * x8;
      const Scalar x11 = sums_[4] + (v_theta_2 + v_theta_2) * x6;
      const Scalar x12 = sums_[5] + z1 * x11 + b11 * x9;
      const Scalar x14 = sums_[7] + (v_theta_1 + v_theta_1) * x1;
      const Scalar x15 = n9_81 * x4 + x14;
      const Scalar x16 = sums_[8] + z1 * x15 + b15 * x9;
      const Scalar o13 = sums_[6] + b7 * x10;
      const Scalar o17 = n9_81 * x3;
      const Scalar o18 = sums_[9] + b17 * x10;
      const Scalar p18 = o18 + z2 * o17;
      const Scalar r1 = -(-x16 + p18);
      const Scalar r0 = -(n19_62 * x3 + x12 + o13) - z2 * r1;
      const Scalar a0 = z12 * r0;
      const Scalar a1 = r1 - z2 * a0;
      const Scalar x17 = o17 + a0;
      coefficients[k_ + 1][0] = next_ * x1;
      coefficients[k_ + 1][1] = next_ * x6;
      coefficients[k_ + 1][2] = next_ * a0;
      coefficients[k_ + 1][3] = next_ * a1;
      const Scalar left_[] = {w0, w0, w8, w8, x6, x9, a1, x1, x9, x10};
      const Scalar right_[] = {x4, x3, x10, x9, x6, x11, x10, x1, x15, x17};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * coefficients[order][0] * coefficients[order][1] * coefficients[order][2]
        * coefficients[order][3];
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Second derivatives of inverse_dynamics at (q, v, a, lambda). It is linear in a: d2f/da dq has the derivatives of
  /// the mass matrix, and what else has an a is zero.
  /// Each member x_by_y_z has one page for each z_k, the derivative of a matrix by z_k: the entry of row i and column
  /// j of page k is [i + rows * (j + columns * k)].
  TORSOR_DEVICE static void inverse_dynamics_second_derivatives(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsSecondDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n9_81 * s_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n2 * v_theta_1;
    const Scalar z8 = n2 * v_theta_2;
    const Scalar z9 = a_theta_2 * z2 + z1 * z6;
    const Scalar z10 = z2 * z7;
    const Scalar z11 = z2 * z8;
    const Scalar z12 = n2 * z1;
    const Scalar z13 = a_theta_1 + z5;
    const Scalar z14 = z3 + z4;
    const Scalar z15 = z1 * z14 - z2 * z13;
    const Scalar z16 = z1 * (z3 - z14) - z2 * (z5 - z13);
    const Scalar z17 = z15 - z9;
    const Scalar z18 = n2 * z5 + z9 + z16;
    const Scalar z19 = z9 + z16;
    const Scalar z20 = z15 - z17;
    const Scalar z21 = z16 - z18;
    const Scalar z22 = z16 - z19;
    result.by_position_position[0] = z21;
    result.by_position_position[1] = -z16;
    result.by_position_position[2] = -z22;
    result.by_position_position[3] = z16;
    result.by_position_position[4] = -z22;
    result.by_position_position[5] = z16;
    result.by_position_position[6] = -z20;
    result.by_position_position[7] = z15;
    result.by_position_velocity[0] = n0;
    result.by_position_velocity[1] = -z10;
    result.by_position_velocity[2] = n0;
    result.by_position_velocity[3] = z10;
    result.by_position_velocity[4] = z11;
    result.by_position_velocity[5] = n0;
    result.by_position_velocity[6] = -z11;
    result.by_position_velocity[7] = n0;
    result.by_velocity_velocity[0] = n0;
    result.by_velocity_velocity[1] = -z12;
    result.by_velocity_velocity[2] = n0;
    result.by_velocity_velocity[3] = n0;
    result.by_velocity_velocity[4] = n0;
    result.by_velocity_velocity[5] = n0;
    result.by_velocity_velocity[6] = z12;
    result.by_velocity_velocity[7] = n0;
    result.by_acceleration_position[0] = n0;
    result.by_acceleration_position[1] = -z1;
    result.by_acceleration_position[2] = -z1;
    result.by_acceleration_position[3] = n0;
    result.by_acceleration_position[4] = n0;
    result.by_acceleration_position[5] = z1;
    result.by_acceleration_position[6] = z1;
    result.by_acceleration_position[7] = n0;
  }

  /// Second derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion;
  /// it is linear in u. Returns singular where forward_dynamics does.
  /// Each member x_by_y_z has one page for each z_k, the derivative of a matrix by z_k: the entry of row i and column
  /// j of page k is [i + rows * (j + columns * k)].
  TORSOR_DEVICE static torsor::Status forward_dynamics_second_derivatives(const Precomputed&, const State& state,
      const Inputs&, ForwardDynamicsSecondDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = n2 * v_theta_1;
    const Scalar z10 = z1 * z9;
    const Scalar z11 = n2 * v_theta_2;
    const Scalar z12 = z1 * z11;
    const Scalar z13 = z2 * z9;
    const Scalar z14 = z2 * z11;
    const Scalar z15 = n2 * z1;
    const Scalar z16 = z3 + z4;
    const Scalar z17 = z1 * z16;
    const Scalar z18 = n2 * z7 + z8;
    const Scalar z19 = z2 * z10;
    const Scalar z20 = n1 / z5;
    const Scalar z21 = z2 * z7 - z17;
    const Scalar z22 = z2 * z21 - z18;
    const Scalar z23 = z20 * z22;
    const Scalar z24 = z20 * z19;
    const Scalar z25 = z20 * z12;
    const Scalar z26 = z2 * z23 + z21;
    const Scalar z27 = z2 * z15;
    const Scalar z28 = z20 * z15;
    const Scalar z29 = z20 * z27;
    const Scalar z30 = z7 + z23;
    const Scalar z31 = z2 * z24 + z10;
    const Scalar z32 = z2 * z25;
    const Scalar z33 = z1 * z24 - z13;
    const Scalar z34 = z1 * z25;
    const Scalar z35 = z2 * z28;
    const Scalar z36 = z2 * z29 + z15;
    const Scalar z37 = z2 * (z3 - z16) + z1 * (z7 - z30);
    const Scalar z38 = z2 * z16 + z1 * z30;
    const Scalar z39 = z1 * (z3 - z16) - z2 * (z7 - z30);
    const Scalar z40 = z2 * z30 - z17;
    const Scalar z41 = z1 * z32 - z14;
    const Scalar z42 = z2 * z6 + z1 * z26;
    const Scalar z43 = z2 * z26 - z8;
    const Scalar z44 = z1 * z31;
    const Scalar z45 = z2 * z33 + z44;
    const Scalar z46 = z2 * z34 + z41;
    const Scalar z47 = z42 - z38;
    const Scalar z48 = z43 - z40;
    const Scalar z49 = n2 * z3 + z37 + z42;
    const Scalar z50 = z39 - z43;
    const Scalar z51 = n2 * z7 + z39 - z43;
    const Scalar z52 = z38 + z47;
    const Scalar z53 = z40 + z48;
    const Scalar z54 = z20 * z45;
    const Scalar z55 = z20 * z46;
    const Scalar z56 = z39 - z50;
    const Scalar z57 = z2 * z38 + z52;
    const Scalar z58 = z2 * z54 + z33;
    const Scalar z59 = z2 * z55 + z34;
    const Scalar z60 = z37 - z49;
    const Scalar z61 = z39 - z51;
    const Scalar z62 = z20 * z57;
    const Scalar z63 = z2 * z37 + z60;
    const Scalar z64 = z2 * z62 + z38;
    const Scalar z65 = z62 * z15 - z40;
    const Scalar z66 = z20 * z63;
    const Scalar z67 = z64 * z15 - z53;
    const Scalar z68 = z2 * z66 + z37;
    const Scalar z69 = z1 * (z66 - z62) + z39;
    const Scalar z70 = z66 * z15 + z39;
    const Scalar z71 = z2 * z65 + z67;
    const Scalar z72 = z1 * (z68 - z64) + z56;
    const Scalar z73 = z68 * z15 + z61;
    const Scalar z74 = z20 * z71;
    const Scalar z75 = z2 * z70 + z73;
    const Scalar z76 = z2 * z74 + z65;
    const Scalar z77 = z2 * z69 + z72;
    const Scalar z78 = z20 * z75;
    const Scalar z79 = z20 * z77;
    const Scalar z80 = z2 * z78 + z70;
    const Scalar z81 = z2 * z79 + z69;
    result.by_position_position[0] = -z78;
    result.by_position_position[1] = z80;
    result.by_position_position[2] = z79;
    result.by_position_position[3] = -z81;
    result.by_position_position[4] = z79;
    result.by_position_position[5] = -z81;
    result.by_position_position[6] = z74;
    result.by_position_position[7] = -z76;
    result.by_position_velocity[0] = z54;
    result.by_position_velocity[1] = -z58;
    result.by_position_velocity[2] = -z54;
    result.by_position_velocity[3] = z58;
    result.by_position_velocity[4] = z55;
    result.by_position_velocity[5] = -z59;
    result.by_position_velocity[6] = -z55;
    result.by_position_velocity[7] = z59;
    result.by_velocity_velocity[0] = -z29;
    result.by_velocity_velocity[1] = z36;
    result.by_velocity_velocity[2] = n0;
    result.by_velocity_velocity[3] = n0;
    result.by_velocity_velocity[4] = n0;
    result.by_velocity_velocity[5] = n0;
    result.by_velocity_velocity[6] = -z28;
    result.by_velocity_velocity[7] = z35;
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.by_position_position[0] * result.by_position_position[1]
        * result.by_position_position[2] * result.by_position_position[3] * result.by_position_position[4]
        * result.by_position_position[5] * result.by_position_position[6] * result.by_position_position[7]
        * result.by_position_velocity[0] * result.by_position_velocity[1]) * (n0 * result.by_position_velocity[2]
        * result.by_position_velocity[3] * result.by_position_velocity[4] * result.by_position_velocity[5]
        * result.by_position_velocity[6] * result.by_position_velocity[7] * result.by_velocity_velocity[0]
        * result.by_velocity_velocity[1] * result.by_velocity_velocity[6] * result.by_velocity_velocity[7]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace double_pendulum
