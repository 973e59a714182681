// SPDX-License-Identifier: MIT
// model_making_press: Model-making press: two columns, a screw and two cups
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               51               73          2             0                  2       0    130     142
//   mass_matrix              16               28          0             0                  0       0     44      52
//   bias                     36               76          0             0                  0       0    112     125
//   inverse_dynamics        122              184          1             0                  1       0    309     330
//   forward_dynamics        315              542          9             0                  1       0    868     940
//   energy                   46               72          2             0                  0       0    120     144
//   constraints             159              266          2             0                  1       0    429     503
//
// Not computed because this mechanism does not need it:
//   kinematics: of 72 results 16 vanish identically, 16 repeat another up to sign
//   mass_matrix: of 81 results 60 vanish identically, 6 repeat another up to sign
//   bias: of 9 results 1 vanish identically
//   forward_dynamics: of 19 results 4 vanish identically
//   constraints: of 120 results 76 vanish identically, 1 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: L2_z, L2_ry, L2_rz, L5_z.
//   Indeterminate, as they are shared with those in a way that no motion tells: lambda_L3_z.
//
// To write this file again:
//   model_making_press_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output model_making_press.hpp
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

namespace model_making_press {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "model_making_press";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x9cd5d878241f040eULL;
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 10;
  static constexpr int first_integral_count = 0;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 2;
  static constexpr int quaternions[] = {2, 6};
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 4;
  static constexpr int redundant_multipliers[] = {1, 2, 3, 7};

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar a_z;  ///< coordinate [m]
    Scalar a;  ///< coordinate [rad or 1]
    Scalar lower_w;  ///< component of a unit quaternion [1]
    Scalar lower_x;  ///< component of a unit quaternion [1]
    Scalar lower_y;  ///< component of a unit quaternion [1]
    Scalar lower_z;  ///< component of a unit quaternion [1]
    Scalar upper_w;  ///< component of a unit quaternion [1]
    Scalar upper_x;  ///< component of a unit quaternion [1]
    Scalar upper_y;  ///< component of a unit quaternion [1]
    Scalar upper_z;  ///< component of a unit quaternion [1]
    Scalar omega_z;  ///< coordinate [rad or 1]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::a_z, &Coordinates::a, &Coordinates::lower_w,
          &Coordinates::lower_x, &Coordinates::lower_y, &Coordinates::lower_z, &Coordinates::upper_w,
          &Coordinates::upper_x, &Coordinates::upper_y, &Coordinates::upper_z, &Coordinates::omega_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar a_z;  ///< its rate [m/s]
    Scalar a;  ///< its rate [rad/s]
    Scalar lower_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar lower_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar lower_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar omega_z;  ///< its rate [rad/s]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::a_z, &Velocities::a, &Velocities::lower_omega_x,
          &Velocities::lower_omega_y, &Velocities::lower_omega_z, &Velocities::upper_omega_x,
          &Velocities::upper_omega_y, &Velocities::upper_omega_z, &Velocities::omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar a_z;  ///< its second rate [m/s^2]
    Scalar a;  ///< its second rate [rad/s^2]
    Scalar lower_omega_x;  ///< its rate [rad/s^2]
    Scalar lower_omega_y;  ///< its rate [rad/s^2]
    Scalar lower_omega_z;  ///< its rate [rad/s^2]
    Scalar upper_omega_x;  ///< its rate [rad/s^2]
    Scalar upper_omega_y;  ///< its rate [rad/s^2]
    Scalar upper_omega_z;  ///< its rate [rad/s^2]
    Scalar omega_z;  ///< its second rate [rad/s^2]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::a_z, &Accelerations::a,
          &Accelerations::lower_omega_x, &Accelerations::lower_omega_y, &Accelerations::lower_omega_z,
          &Accelerations::upper_omega_x, &Accelerations::upper_omega_y, &Accelerations::upper_omega_z,
          &Accelerations::omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar a_z;  ///< works with the rate of a_z [N]
    Scalar a;  ///< works with the rate of a [N m]
    Scalar lower_omega_x;  ///< works with lower_omega_x [N m]
    Scalar lower_omega_y;  ///< works with lower_omega_y [N m]
    Scalar lower_omega_z;  ///< works with lower_omega_z [N m]
    Scalar upper_omega_x;  ///< works with upper_omega_x [N m]
    Scalar upper_omega_y;  ///< works with upper_omega_y [N m]
    Scalar upper_omega_z;  ///< works with upper_omega_z [N m]
    Scalar omega_z;  ///< works with the rate of omega_z [N m]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::a_z, &GeneralizedForces::a,
          &GeneralizedForces::lower_omega_x, &GeneralizedForces::lower_omega_y, &GeneralizedForces::lower_omega_z,
          &GeneralizedForces::upper_omega_x, &GeneralizedForces::upper_omega_y, &GeneralizedForces::upper_omega_z,
          &GeneralizedForces::omega_z};
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
    Scalar lambda_L2_y;  ///< of the constraint L2_y [N]
    Scalar lambda_L2_z;  ///< indeterminate, of the constraint L2_z [N]
    Scalar lambda_L2_ry;  ///< indeterminate, of the constraint L2_ry [N m]
    Scalar lambda_L2_rz;  ///< indeterminate, of the constraint L2_rz [N m]
    Scalar lambda_L3_z;  ///< indeterminate, of the constraint L3_z [N]
    Scalar lambda_L3_rx;  ///< of the constraint L3_rx [N m]
    Scalar lambda_L3_ry;  ///< of the constraint L3_ry [N m]
    Scalar lambda_L5_z;  ///< indeterminate, of the constraint L5_z [N]
    Scalar lambda_L5_rx;  ///< of the constraint L5_rx [N m]
    Scalar lambda_L5_ry;  ///< of the constraint L5_ry [N m]
    static constexpr int size = 10;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_L2_y, &Multipliers::lambda_L2_z,
          &Multipliers::lambda_L2_ry, &Multipliers::lambda_L2_rz, &Multipliers::lambda_L3_z, &Multipliers::lambda_L3_rx,
          &Multipliers::lambda_L3_ry, &Multipliers::lambda_L5_z, &Multipliers::lambda_L5_rx,
          &Multipliers::lambda_L5_ry};
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.a_z = n0;
    state.q.a = n0;
    state.q.lower_w = n1;
    state.q.lower_x = n0;
    state.q.lower_y = n0;
    state.q.lower_z = n0;
    state.q.upper_w = n1;
    state.q.upper_x = n0;
    state.q.upper_y = n0;
    state.q.upper_z = n0;
    state.q.omega_z = n0;
    state.v.a_z = n0;
    state.v.a = n0;
    state.v.lower_omega_x = n0;
    state.v.lower_omega_y = n0;
    state.v.lower_omega_z = n0;
    state.v.upper_omega_x = n0;
    state.v.upper_omega_y = n0;
    state.v.upper_omega_z = n0;
    state.v.omega_z = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> traverse_position;  ///< centre of mass of traverse [m]
    std::array<Scalar, 9> traverse_rotation;  ///< from the axes of traverse to the ground's (3 x 3)
    std::array<Scalar, 3> traverse_velocity;  ///< velocity of the centre of mass of traverse [m/s]
    std::array<Scalar, 3> traverse_angular_velocity;  ///< angular velocity of traverse [rad/s]
    std::array<Scalar, 3> screw_position;  ///< centre of mass of screw [m]
    std::array<Scalar, 9> screw_rotation;  ///< from the axes of screw to the ground's (3 x 3)
    std::array<Scalar, 3> screw_velocity;  ///< velocity of the centre of mass of screw [m/s]
    std::array<Scalar, 3> screw_angular_velocity;  ///< angular velocity of screw [rad/s]
    std::array<Scalar, 3> lower_cup_position;  ///< centre of mass of lower_cup [m]
    std::array<Scalar, 9> lower_cup_rotation;  ///< from the axes of lower_cup to the ground's (3 x 3)
    std::array<Scalar, 3> lower_cup_velocity;  ///< velocity of the centre of mass of lower_cup [m/s]
    std::array<Scalar, 3> lower_cup_angular_velocity;  ///< angular velocity of lower_cup [rad/s]
    std::array<Scalar, 3> upper_cup_position;  ///< centre of mass of upper_cup [m]
    std::array<Scalar, 9> upper_cup_rotation;  ///< from the axes of upper_cup to the ground's (3 x 3)
    std::array<Scalar, 3> upper_cup_velocity;  ///< velocity of the centre of mass of upper_cup [m/s]
    std::array<Scalar, 3> upper_cup_angular_velocity;  ///< angular velocity of upper_cup [rad/s]
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

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 10> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 10> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 90> jacobian;  ///< A, stored column by column (10 x 9)
    std::array<Scalar, 10> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 11>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_a_z = state.v.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar z0 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w * v_lower_omega_y);
    const Scalar z1 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w * v_lower_omega_z);
    const Scalar z2 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w * v_lower_omega_x);
    const Scalar z3 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x * v_lower_omega_x);
    const Scalar z4 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w * v_upper_omega_y);
    const Scalar z5 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w * v_upper_omega_z);
    const Scalar z6 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w * v_upper_omega_x);
    const Scalar z7 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x * v_upper_omega_x);
    rates[0] = v_a_z;
    rates[1] = v_a;
    rates[2] = -z3;
    rates[3] = z2;
    rates[4] = z0;
    rates[5] = -z1;
    rates[6] = -z7;
    rates[7] = z6;
    rates[8] = z4;
    rates[9] = -z5;
    rates[10] = v_omega_z;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar angles_[] = {q_a, q_omega_z};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_a = sines_[0], c_a = cosines_[0];
    const Scalar s_omega_z = sines_[1], c_omega_z = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = n2 * q_lower_y;
    const Scalar z1 = n2 * q_upper_y;
    const Scalar z2 = n2 * q_lower_z;
    const Scalar z3 = n2 * q_upper_z;
    const Scalar z4 = n2 * q_lower_x;
    const Scalar z5 = n2 * q_upper_x;
    const Scalar z6 = q_lower_y * z0;
    const Scalar z7 = q_upper_y * z1;
    const Scalar z8 = q_lower_z * z2;
    const Scalar z9 = q_lower_x * z0;
    const Scalar z10 = q_lower_w * z2;
    const Scalar z11 = q_upper_z * z3;
    const Scalar z12 = q_upper_x * z1;
    const Scalar z13 = q_upper_w * z3;
    const Scalar z14 = n1 - z6 - z8;
    const Scalar z15 = z9 + z10;
    const Scalar z16 = q_lower_x * z4;
    const Scalar z17 = n1 - z7 - z11;
    const Scalar z18 = z12 + z13;
    const Scalar z19 = q_upper_x * z5;
    const Scalar z20 = z9 - z10;
    const Scalar z21 = n1 - z8 - z16;
    const Scalar z22 = q_lower_x * z2;
    const Scalar z23 = q_lower_w * z0;
    const Scalar z24 = z12 - z13;
    const Scalar z25 = n1 - z11 - z19;
    const Scalar z26 = q_upper_x * z3;
    const Scalar z27 = q_upper_w * z1;
    const Scalar z28 = n1 - z6 - z16;
    const Scalar z29 = q_lower_z * z0;
    const Scalar z30 = q_lower_w * z4;
    const Scalar z31 = q_upper_z * z1;
    const Scalar z32 = q_upper_w * z5;
    const Scalar z33 = z22 - z23;
    const Scalar z34 = z22 + z23;
    const Scalar z35 = z26 - z27;
    const Scalar z36 = z26 + z27;
    const Scalar z37 = z29 - z30;
    const Scalar z38 = z29 + z30;
    const Scalar z39 = z31 - z32;
    const Scalar z40 = z31 + z32;
    const Scalar z41 = s_a * z15 - c_a * z14;
    const Scalar z42 = s_a * z14 + c_a * z15;
    const Scalar z43 = s_a * z18 - c_a * z17;
    const Scalar z44 = s_a * z17 + c_a * z18;
    const Scalar z45 = s_a * z21 - c_a * z20;
    const Scalar z46 = s_a * z20 + c_a * z21;
    const Scalar z47 = v_a + v_lower_omega_x * z33;  // angular velocity of lower_omega_x, z
    const Scalar z48 = s_a * z25 - c_a * z24;
    const Scalar z49 = s_a * z24 + c_a * z25;
    const Scalar z50 = v_a + v_upper_omega_x * z35;  // angular velocity of upper_omega_x, z
    const Scalar z51 = n1 - z7 - z19;
    const Scalar z52 = s_a * z37 - c_a * z34;
    const Scalar z53 = s_a * z34 + c_a * z37;
    const Scalar z54 = v_lower_omega_y * z38 + z47;  // angular velocity of lower_omega_y, z
    const Scalar z55 = s_a * z39 - c_a * z36;
    const Scalar z56 = s_a * z36 + c_a * z39;
    const Scalar z57 = v_upper_omega_y * z40 + z50;  // angular velocity of upper_omega_y, z
    const Scalar z58 = n0_1 * c_a;
    const Scalar z59 = n0_1 * v_a;
    const Scalar z60 = n0_1 * s_a;
    const Scalar z61 = s_a * z59;  // velocity of lower_omega_x, x
    const Scalar z62 = n0_1 - z58;  // place of lower_omega_x, x
    const Scalar z63 = c_a * z59;  // velocity of lower_omega_x, y
    const Scalar z64 = v_lower_omega_z * z28 + z54;  // angular velocity of lower_cup, z
    const Scalar z65 = v_upper_omega_z * z51 + z57;  // angular velocity of upper_cup, z
    const Scalar z66 = n0_002 * q_omega_z / pi;
    const Scalar z67 = v_lower_omega_x * z41;  // angular velocity of lower_omega_x, x
    const Scalar z68 = v_lower_omega_x * z42;  // angular velocity of lower_omega_x, y
    const Scalar z69 = v_upper_omega_x * z43;  // angular velocity of upper_omega_x, x
    const Scalar z70 = v_upper_omega_x * z44;  // angular velocity of upper_omega_x, y
    const Scalar z71 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z72 = v_lower_omega_y * z45 + z67;  // angular velocity of lower_omega_y, x
    const Scalar z73 = v_lower_omega_y * z46 + z68;  // angular velocity of lower_omega_y, y
    const Scalar z74 = v_upper_omega_y * z48 + z69;  // angular velocity of upper_omega_y, x
    const Scalar z75 = v_upper_omega_y * z49 + z70;  // angular velocity of upper_omega_y, y
    const Scalar z76 = v_lower_omega_z * z52 + z72;  // angular velocity of lower_cup, x
    const Scalar z77 = v_lower_omega_z * z53 + z73;  // angular velocity of lower_cup, y
    const Scalar z78 = v_upper_omega_z * z55 + z74;  // angular velocity of upper_cup, x
    const Scalar z79 = v_upper_omega_z * z56 + z75;  // angular velocity of upper_cup, y
    result.traverse_position[0] = -z62;
    result.traverse_position[1] = z60;
    result.traverse_position[2] = q_a_z;
    result.traverse_rotation[0] = c_a;
    result.traverse_rotation[1] = s_a;
    result.traverse_rotation[2] = n0;
    result.traverse_rotation[3] = -s_a;
    result.traverse_rotation[4] = c_a;
    result.traverse_rotation[5] = n0;
    result.traverse_rotation[6] = n0;
    result.traverse_rotation[7] = n0;
    result.traverse_rotation[8] = n1;
    result.traverse_velocity[0] = -z61;
    result.traverse_velocity[1] = z63;
    result.traverse_velocity[2] = v_a_z;
    result.traverse_angular_velocity[0] = n0;
    result.traverse_angular_velocity[1] = n0;
    result.traverse_angular_velocity[2] = v_a;
    result.screw_position[0] = n0;
    result.screw_position[1] = n0;
    result.screw_position[2] = z66;
    result.screw_rotation[0] = c_omega_z;
    result.screw_rotation[1] = s_omega_z;
    result.screw_rotation[2] = n0;
    result.screw_rotation[3] = -s_omega_z;
    result.screw_rotation[4] = c_omega_z;
    result.screw_rotation[5] = n0;
    result.screw_rotation[6] = n0;
    result.screw_rotation[7] = n0;
    result.screw_rotation[8] = n1;
    result.screw_velocity[0] = n0;
    result.screw_velocity[1] = n0;
    result.screw_velocity[2] = z71;
    result.screw_angular_velocity[0] = n0;
    result.screw_angular_velocity[1] = n0;
    result.screw_angular_velocity[2] = v_omega_z;
    result.lower_cup_position[0] = -z62;
    result.lower_cup_position[1] = z60;
    result.lower_cup_position[2] = q_a_z;
    result.lower_cup_rotation[0] = -z41;
    result.lower_cup_rotation[1] = z42;
    result.lower_cup_rotation[2] = z33;
    result.lower_cup_rotation[3] = -z45;
    result.lower_cup_rotation[4] = z46;
    result.lower_cup_rotation[5] = z38;
    result.lower_cup_rotation[6] = -z52;
    result.lower_cup_rotation[7] = z53;
    result.lower_cup_rotation[8] = z28;
    result.lower_cup_velocity[0] = -z61;
    result.lower_cup_velocity[1] = z63;
    result.lower_cup_velocity[2] = v_a_z;
    result.lower_cup_angular_velocity[0] = -z76;
    result.lower_cup_angular_velocity[1] = z77;
    result.lower_cup_angular_velocity[2] = z64;
    result.upper_cup_position[0] = -z62;
    result.upper_cup_position[1] = z60;
    result.upper_cup_position[2] = q_a_z;
    result.upper_cup_rotation[0] = -z43;
    result.upper_cup_rotation[1] = z44;
    result.upper_cup_rotation[2] = z35;
    result.upper_cup_rotation[3] = -z48;
    result.upper_cup_rotation[4] = z49;
    result.upper_cup_rotation[5] = z40;
    result.upper_cup_rotation[6] = -z55;
    result.upper_cup_rotation[7] = z56;
    result.upper_cup_rotation[8] = z51;
    result.upper_cup_velocity[0] = -z61;
    result.upper_cup_velocity[1] = z63;
    result.upper_cup_velocity[2] = v_a_z;
    result.upper_cup_angular_velocity[0] = -z78;
    result.upper_cup_angular_velocity[1] = z79;
    result.upper_cup_angular_velocity[2] = z65;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 81>& mass) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k5 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z0;
    });
    const Scalar z2 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z0 * z1;
    });
    const Scalar z3 = n2 * q_upper_y;
    const Scalar z4 = n2 * q_upper_x;
    const Scalar z5 = n2 * q_lower_y;
    const Scalar z6 = n2 * q_lower_x;
    const Scalar z7 = q_lower_y * z5;
    const Scalar z8 = q_lower_x * z6;
    const Scalar z9 = q_upper_y * z3;
    const Scalar z10 = q_upper_z * z3;
    const Scalar z11 = q_upper_w * z4;
    const Scalar z12 = q_lower_z * z5;
    const Scalar z13 = q_lower_w * z6;
    const Scalar z14 = q_upper_x * z4;
    const Scalar z15 = z10 + z11;
    const Scalar z16 = z12 + z13;
    const Scalar z17 = n1 - z9 - z14;
    const Scalar z18 = q_upper_z * z4;
    const Scalar z19 = q_upper_w * z3;
    const Scalar z20 = k5 * z15;
    const Scalar z21 = n1 - z7 - z8;
    const Scalar z22 = k5 * z16;
    const Scalar z23 = q_lower_z * z6;
    const Scalar z24 = q_lower_w * z5;
    const Scalar z25 = k5 * z17;
    const Scalar z26 = z18 - z19;
    const Scalar z27 = k5 * z21;
    const Scalar z28 = z23 - z24;
    const Scalar z29 = k5 * z26;
    const Scalar z30 = k5 * z28;
    const Scalar z31 = z15 * z20 + z17 * z25 + z26 * z29;
    const Scalar z32 = z16 * z22 + z21 * z27 + z28 * z30;
    const Scalar z33 = n0_0002 + z31;
    const Scalar z34 = n0_0002 + z32;
    const Scalar z35 = n0_01 + z33;
    const Scalar z36 = z35 + z34;
    mass[0] = n0_84;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = z36;
    mass[11] = z30;
    mass[12] = z22;
    mass[13] = z27;
    mass[14] = z29;
    mass[15] = z20;
    mass[16] = z25;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = z30;
    mass[20] = k5;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = z22;
    mass[29] = n0;
    mass[30] = k5;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = z27;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k5;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = z29;
    mass[47] = n0;
    mass[48] = n0;
    mass[49] = n0;
    mass[50] = k5;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = z20;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = k5;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = z25;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = k5;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = n0;
    mass[78] = n0;
    mass[79] = n0;
    mass[80] = z2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar k10 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z2 = n2 * q_lower_y;
    const Scalar z3 = n2 * q_lower_z;
    const Scalar z4 = n2 * q_upper_y;
    const Scalar z5 = n2 * q_upper_z;
    const Scalar z6 = n2 * q_lower_x;
    const Scalar z7 = n2 * q_upper_x;
    const Scalar z8 = q_lower_y * z2;
    const Scalar z9 = q_lower_x * z2;
    const Scalar z10 = q_lower_w * z3;
    const Scalar z11 = q_upper_y * z4;
    const Scalar z12 = q_upper_x * z4;
    const Scalar z13 = q_upper_w * z5;
    const Scalar z14 = v_a * v_a;
    const Scalar z15 = z9 - z10;
    const Scalar z16 = q_lower_x * z6;
    const Scalar z17 = q_lower_z * z2;
    const Scalar z18 = q_lower_w * z6;
    const Scalar z19 = z12 - z13;
    const Scalar z20 = q_upper_x * z7;
    const Scalar z21 = q_upper_z * z4;
    const Scalar z22 = q_upper_w * z7;
    const Scalar z23 = n0_1 * z14;
    const Scalar z24 = z17 + z18;
    const Scalar z25 = q_lower_x * z3;
    const Scalar z26 = q_lower_w * z2;
    const Scalar z27 = n1 - z8 - z16;
    const Scalar z28 = z21 + z22;
    const Scalar z29 = q_upper_x * z5;
    const Scalar z30 = q_upper_w * z4;
    const Scalar z31 = n1 - z11 - z20;
    const Scalar z32 = q_lower_z * z3;
    const Scalar z33 = q_upper_z * z5;
    const Scalar z34 = z25 + z26;
    const Scalar z35 = z29 + z30;
    const Scalar z36 = n1 - z8 - z32;
    const Scalar z37 = n1 - z11 - z33;
    const Scalar z38 = z15 * z23 - n9_81 * z24;
    const Scalar z39 = z19 * z23 - n9_81 * z28;
    const Scalar z40 = z25 - z26;
    const Scalar z41 = z29 - z30;
    const Scalar z42 = n9_81 * z27 - z34 * z23;
    const Scalar z43 = n9_81 * z31 - z35 * z23;
    const Scalar z44 = n0_02 * z39;  // force on upper_cup, y
    const Scalar z45 = n0_02 * z38;  // force on lower_cup, y
    const Scalar z46 = n0_02 * z43;  // force on upper_cup, z
    const Scalar z47 = n0_02 * z42;  // force on lower_cup, z
    const Scalar z48 = z36 * z23 - n9_81 * z40;
    const Scalar z49 = z37 * z23 - n9_81 * z41;
    const Scalar z50 = n0_02 * z49;  // force on upper_cup, x
    const Scalar z51 = n0_02 * z48;  // force on lower_cup, x
    const Scalar z52 = v_a * z24;
    const Scalar z53 = v_a * z27;
    const Scalar z54 = v_a * z28;
    const Scalar z55 = v_a * z31;
    const Scalar z56 = z28 * z44 - z31 * z46 + z41 * z50;
    const Scalar z57 = z24 * z45 - z27 * z47 + z40 * z51;
    const Scalar z58 = v_a * z40;
    const Scalar z59 = v_a * z41;
    const Scalar z60 = v_lower_omega_x * z53;  // angular acceleration of lower_omega_x, y
    const Scalar z61 = v_lower_omega_x * z52;  // angular acceleration of lower_omega_x, z
    const Scalar z62 = v_lower_omega_y * z53;  // angular acceleration of lower_omega_y, x
    const Scalar z63 = v_upper_omega_x * z55;  // angular acceleration of upper_omega_x, y
    const Scalar z64 = v_upper_omega_x * z54;  // angular acceleration of upper_omega_x, z
    const Scalar z65 = v_upper_omega_y * z55;  // angular acceleration of upper_omega_y, x
    const Scalar z66 = z56 + z57;  // force on ring_A, z
    const Scalar z67 = n20000 * q_a_z;
    const Scalar z68 = n0_0005 * v_omega_z;
    const Scalar z69 = v_lower_omega_y * z58 - z61;  // angular acceleration of lower_omega_y, z
    const Scalar z70 = v_lower_omega_z * z52 - z62;  // angular acceleration of lower_cup, x
    const Scalar z71 = v_lower_omega_z * z58 - z60;  // angular acceleration of lower_cup, y
    const Scalar z72 = v_upper_omega_y * z59 - z64;  // angular acceleration of upper_omega_y, z
    const Scalar z73 = v_upper_omega_z * z54 - z65;  // angular acceleration of upper_cup, x
    const Scalar z74 = v_upper_omega_z * z59 - z63;  // angular acceleration of upper_cup, y
    const Scalar z75 = n7_848 - z66;  // force on ring_A.1, z
    const Scalar z76 = k10 * z73;  // moment on upper_cup, x
    const Scalar z77 = k10 * z74;  // moment on upper_cup, y
    const Scalar z78 = k10 * z72;  // moment on upper_cup, z
    const Scalar z79 = k10 * z70;  // moment on lower_cup, x
    const Scalar z80 = k10 * z71;  // moment on lower_cup, y
    const Scalar z81 = k10 * z69;  // moment on lower_cup, z
    const Scalar z82 = z67 + z75;
    const Scalar z83 = z1 + z68;
    forces.a_z = z82;
    forces.a = n0;
    forces.lower_omega_x = z79;
    forces.lower_omega_y = -z80;
    forces.lower_omega_z = z81;
    forces.upper_omega_x = z76;
    forces.upper_omega_y = -z77;
    forces.upper_omega_z = z78;
    forces.omega_z = z83;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k7 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar q_a_z = state.q.a_z;
    const Scalar a_a_z = accelerations.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar a_a = accelerations.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar a_lower_omega_x = accelerations.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar a_lower_omega_y = accelerations.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar a_lower_omega_z = accelerations.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar a_upper_omega_x = accelerations.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar a_upper_omega_y = accelerations.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar a_upper_omega_z = accelerations.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar a_omega_z = accelerations.omega_z;
    const Scalar l_lambda_L2_y = multipliers.lambda_L2_y;
    const Scalar l_lambda_L2_z = multipliers.lambda_L2_z;
    const Scalar l_lambda_L3_z = multipliers.lambda_L3_z;
    const Scalar l_lambda_L3_rx = multipliers.lambda_L3_rx;
    const Scalar l_lambda_L3_ry = multipliers.lambda_L3_ry;
    const Scalar l_lambda_L5_z = multipliers.lambda_L5_z;
    const Scalar l_lambda_L5_rx = multipliers.lambda_L5_rx;
    const Scalar l_lambda_L5_ry = multipliers.lambda_L5_ry;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z0;
    });
    const Scalar z2 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z0 * z1;
    });
    const Scalar z3 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z4 = n2 * q_lower_y;
    const Scalar z5 = n2 * q_lower_z;
    const Scalar z6 = n2 * q_upper_y;
    const Scalar z7 = n2 * q_upper_z;
    const Scalar z8 = n2 * q_lower_x;
    const Scalar z9 = n2 * q_upper_x;
    const Scalar z10 = q_lower_y * z4;
    const Scalar z11 = q_lower_x * z4;
    const Scalar z12 = q_lower_w * z5;
    const Scalar z13 = q_upper_y * z6;
    const Scalar z14 = q_upper_x * z6;
    const Scalar z15 = q_upper_w * z7;
    const Scalar z16 = v_a * v_a;
    const Scalar z17 = z11 - z12;
    const Scalar z18 = q_lower_x * z8;
    const Scalar z19 = q_lower_z * z4;
    const Scalar z20 = q_lower_w * z8;
    const Scalar z21 = z14 - z15;
    const Scalar z22 = q_upper_x * z9;
    const Scalar z23 = q_upper_z * z6;
    const Scalar z24 = q_upper_w * z9;
    const Scalar z25 = q_lower_x * z5;
    const Scalar z26 = q_lower_w * z4;
    const Scalar z27 = z19 + z20;
    const Scalar z28 = n1 - z10 - z18;
    const Scalar z29 = z23 + z24;
    const Scalar z30 = q_upper_x * z7;
    const Scalar z31 = q_upper_w * z6;
    const Scalar z32 = n1 - z13 - z22;
    const Scalar z33 = q_lower_z * z5;
    const Scalar z34 = n0_1 * z16;
    const Scalar z35 = z25 - z26;
    const Scalar z36 = z25 + z26;
    const Scalar z37 = q_upper_z * z7;
    const Scalar z38 = z30 + z31;
    const Scalar z39 = n1 - z10 - z33;
    const Scalar z40 = n1 - z13 - z37;
    const Scalar z41 = k7 * z35;
    const Scalar z42 = z17 * z34 - n9_81 * z27;
    const Scalar z43 = z30 - z31;
    const Scalar z44 = k7 * z29;
    const Scalar z45 = k7 * z27;
    const Scalar z46 = z19 - z20;
    const Scalar z47 = z21 * z34 - n9_81 * z29;
    const Scalar z48 = n9_81 * z28 - z36 * z34;
    const Scalar z49 = z23 - z24;
    const Scalar z50 = n9_81 * z32 - z38 * z34;
    const Scalar z51 = n0_02 * z47;  // force on upper_cup, y
    const Scalar z52 = n0_02 * z42;  // force on lower_cup, y
    const Scalar z53 = n0_02 * z50;  // force on upper_cup, z
    const Scalar z54 = n0_02 * z48;  // force on lower_cup, z
    const Scalar z55 = z39 * z34 - n9_81 * z35;
    const Scalar z56 = z40 * z34 - n9_81 * z43;
    const Scalar z57 = k7 * z32;
    const Scalar z58 = n0_02 * z56;  // force on upper_cup, x
    const Scalar z59 = n0_02 * z55;  // force on lower_cup, x
    const Scalar z60 = z27 * z52 - z28 * z54 + z35 * z59;
    const Scalar z61 = k7 * z43;
    const Scalar z62 = v_a * z27;
    const Scalar z63 = z29 * z51 - z32 * z53 + z43 * z58;
    const Scalar z64 = v_a * z28;
    const Scalar z65 = v_a * z29;
    const Scalar z66 = z63 + z60;  // force on ring_A, z
    const Scalar z67 = v_a * z32;
    const Scalar z68 = k7 * z28;
    const Scalar z69 = v_a * z35;
    const Scalar z70 = n7_848 - z66;  // force on ring_A.1, z
    const Scalar z71 = v_a * z43;
    const Scalar z72 = v_lower_omega_x * z64;  // angular acceleration of lower_omega_x, y
    const Scalar z73 = v_lower_omega_y * z64;  // angular acceleration of lower_omega_y, x
    const Scalar z74 = v_lower_omega_z * z62 - z73;  // angular acceleration of lower_cup, x
    const Scalar z75 = v_lower_omega_x * z62;  // angular acceleration of lower_omega_x, z
    const Scalar z76 = v_lower_omega_y * z69 - z75;  // angular acceleration of lower_omega_y, z
    const Scalar z77 = v_lower_omega_z * z69 - z72;  // angular acceleration of lower_cup, y
    const Scalar z78 = k7 * z77;  // moment on lower_cup, y
    const Scalar z79 = k7 * z74;  // moment on lower_cup, x
    const Scalar z80 = v_upper_omega_x * z67;  // angular acceleration of upper_omega_x, y
    const Scalar z81 = v_upper_omega_y * z67;  // angular acceleration of upper_omega_y, x
    const Scalar z82 = v_upper_omega_z * z65 - z81;  // angular acceleration of upper_cup, x
    const Scalar z83 = v_upper_omega_x * z65;  // angular acceleration of upper_omega_x, z
    const Scalar z84 = v_upper_omega_y * z71 - z83;  // angular acceleration of upper_omega_y, z
    const Scalar z85 = v_upper_omega_z * z71 - z80;  // angular acceleration of upper_cup, y
    const Scalar z86 = k7 * z85;  // moment on upper_cup, y
    const Scalar z87 = k7 * z82;  // moment on upper_cup, x
    const Scalar z88 = k7 * z76;  // moment on lower_cup, z
    const Scalar z89 = n0_002 * q_omega_z / pi;
    const Scalar z90 = k7 * z84;  // moment on upper_cup, z
    const Scalar z91 = z29 * z44 + z32 * z57 + z43 * z61;
    const Scalar z92 = n0_0002 + z91;
    const Scalar z93 = z27 * z45 + z28 * z68 + z35 * z41;
    const Scalar z94 = n0_01 + z92;
    const Scalar z95 = n0_0002 + z93;
    const Scalar z96 = n0_1 * s_a;
    const Scalar z97 = n0_1 * c_a;
    const Scalar z98 = n20000 * q_a_z;
    const Scalar z99 = z98 + z70;
    const Scalar z100 = z94 + z95;
    const Scalar z101 = n0_0005 * v_omega_z;
    const Scalar z102 = z3 + z101;
    const Scalar z103 = n0_1 - z97;  // place of lower_omega_x, x
    const Scalar z104 = z46 * z97 + z36 * z96;
    const Scalar z105 = z49 * z97 + z38 * z96;
    const Scalar z106 = n0_84 * a_a_z + z99;
    const Scalar z107 = a_lower_omega_x * z41 + a_lower_omega_y * z45 + a_upper_omega_x * z61 + a_upper_omega_y * z44
        + a_lower_omega_z * z68 + a_upper_omega_z * z57 + a_a * z100;
    const Scalar z108 = z79 + k7 * a_lower_omega_x + a_a * z41;
    const Scalar z109 = k7 * a_lower_omega_y - z78 + a_a * z45;
    const Scalar z110 = q_lower_x * q_lower_x;
    const Scalar z111 = q_lower_y * q_lower_x;
    const Scalar z112 = z88 + k7 * a_lower_omega_z + a_a * z68;
    const Scalar z113 = q_upper_x * q_upper_x;
    const Scalar z114 = q_upper_y * q_upper_x;
    const Scalar z115 = z87 + k7 * a_upper_omega_x + a_a * z61;
    const Scalar z116 = q_lower_y * q_lower_y;
    const Scalar z117 = q_lower_z * q_lower_z;
    const Scalar z118 = k7 * a_upper_omega_y - z86 + a_a * z44;
    const Scalar z119 = q_upper_y * q_upper_y;
    const Scalar z120 = q_upper_z * q_upper_z;
    const Scalar z121 = z90 + k7 * a_upper_omega_z + a_a * z57;
    const Scalar z122 = q_a_z - z89;
    const Scalar z123 = z116 - z117;
    const Scalar z124 = q_lower_w * q_lower_w - z110;
    const Scalar z125 = z117 - z110;
    const Scalar z126 = q_lower_z * q_lower_w + z111;
    const Scalar z127 = a_omega_z * z2 + z102;
    const Scalar z128 = z119 - z120;
    const Scalar z129 = z0 * z28;
    const Scalar z130 = q_upper_w * q_upper_w - z113;
    const Scalar z131 = z120 - z113;
    const Scalar z132 = q_upper_z * q_upper_w + z114;
    const Scalar z133 = z0 * z32;
    const Scalar z134 = z123 + z124;
    const Scalar z135 = z123 - z124;
    const Scalar z136 = n2 * z126;
    const Scalar z137 = z128 + z130;
    const Scalar z138 = n2 * z132;
    const Scalar z139 = q_lower_z * q_lower_w - z111;
    const Scalar z140 = q_lower_w * q_lower_w - z116;
    const Scalar z141 = q_upper_z * q_upper_w - z114;
    const Scalar z142 = q_upper_w * q_upper_w - z119;
    const Scalar z143 = n2 * z139;
    const Scalar z144 = z125 - z140;
    const Scalar z145 = z27 * z122 + z96 * z134 - z103 * z143;
    const Scalar z146 = n2 * z141;
    const Scalar z147 = z131 - z142;
    const Scalar z148 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z149 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z150 = z35 * z122 + z96 * z136 - z103 * z144;
    const Scalar z151 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z152 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z153 = n0_2 * c_a;
    const Scalar z154 = n0_2 * s_a;
    const Scalar z155 = n2 * z148;
    const Scalar z156 = z125 + z140;
    const Scalar z157 = n2 * z149;
    const Scalar z158 = z29 * z122 + z96 * z137 - z103 * z146;
    const Scalar z159 = z43 * z122 + z96 * z138 - z103 * z147;
    const Scalar z160 = z128 - z130;
    const Scalar z161 = n2 * z151;
    const Scalar z162 = z131 + z142;
    const Scalar z163 = n2 * z152;
    forces.a_z = z106 + l_lambda_L3_z * z28 + l_lambda_L5_z * z32;
    forces.a = -l_lambda_L2_y * z153 + z107 - l_lambda_L2_z * z154 + l_lambda_L3_z * z104 + l_lambda_L5_z * z105;
    forces.lower_omega_x = -l_lambda_L3_rx * z135 + z108 - l_lambda_L3_z * z145;
    forces.lower_omega_y = l_lambda_L3_ry * z156 + z109 + l_lambda_L3_z * z150;
    forces.lower_omega_z = z112 + l_lambda_L3_rx * z155 - l_lambda_L3_ry * z157;
    forces.upper_omega_x = -l_lambda_L5_rx * z160 + z115 - l_lambda_L5_z * z158;
    forces.upper_omega_y = l_lambda_L5_ry * z162 + z118 + l_lambda_L5_z * z159;
    forces.upper_omega_z = z121 + l_lambda_L5_rx * z161 - l_lambda_L5_ry * z163;
    forces.omega_z = -l_lambda_L3_z * z129 + z127 - l_lambda_L5_z * z133;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k6 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n100000 = traits::constant(1e+05, 1e+05f, "100000/1");
    const Scalar n25_over_21 = traits::constant(1.1904761904761905, 1.1904762f, "25/21");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z0;
    });
    const Scalar z2 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z0 * z1;
    });
    const Scalar z3 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z4 = traits::formula(9987.856223025203, 9987.856f, [&]() -> Scalar {
      return n1 / z2;
    });
    const Scalar z5 = n2 * q_upper_y;
    const Scalar z6 = n2 * q_upper_x;
    const Scalar z7 = n2 * q_lower_y;
    const Scalar z8 = n2 * q_lower_x;
    const Scalar z9 = n2 * q_upper_z;
    const Scalar z10 = n2 * q_lower_z;
    const Scalar z11 = q_upper_y * z5;
    const Scalar z12 = q_upper_z * z5;
    const Scalar z13 = q_upper_w * z6;
    const Scalar z14 = q_lower_y * z7;
    const Scalar z15 = q_lower_z * z7;
    const Scalar z16 = q_lower_w * z8;
    const Scalar z17 = q_upper_x * z6;
    const Scalar z18 = z12 + z13;
    const Scalar z19 = q_lower_x * z8;
    const Scalar z20 = z15 + z16;
    const Scalar z21 = n1 - z11 - z17;
    const Scalar z22 = k6 * z18;
    const Scalar z23 = q_upper_x * z9;
    const Scalar z24 = q_upper_w * z5;
    const Scalar z25 = n1 - z14 - z19;
    const Scalar z26 = k6 * z20;
    const Scalar z27 = k6 * z21;
    const Scalar z28 = q_lower_x * z10;
    const Scalar z29 = q_lower_w * z7;
    const Scalar z30 = z23 - z24;
    const Scalar z31 = z15 - z16;
    const Scalar z32 = k6 * z25;
    const Scalar z33 = z23 + z24;
    const Scalar z34 = z28 - z29;
    const Scalar z35 = z28 + z29;
    const Scalar z36 = k6 * z30;
    const Scalar z37 = q_lower_x * z7;
    const Scalar z38 = q_upper_x * z5;
    const Scalar z39 = k6 * z34;
    const Scalar z40 = z18 * z22 + z21 * z27 + z30 * z36;
    const Scalar z41 = z20 * z26 + z25 * z32 + z34 * z39;
    const Scalar z42 = n0_0002 + z40;
    const Scalar z43 = n0_0002 + z41;
    const Scalar z44 = n0_002 * q_omega_z / pi;
    const Scalar z45 = n0_1 * s_a;
    const Scalar z46 = n0_01 + z42;
    const Scalar z47 = n0_1 * c_a;
    const Scalar z48 = q_lower_w * z10;
    const Scalar z49 = z37 - z48;
    const Scalar z50 = q_lower_z * z10;
    const Scalar z51 = n1 - z14 - z50;
    const Scalar z52 = z46 + z43;
    const Scalar z53 = q_upper_w * z9;
    const Scalar z54 = z38 - z53;
    const Scalar z55 = q_upper_z * z9;
    const Scalar z56 = n1 - z11 - z55;
    const Scalar z57 = v_a * v_a;
    const Scalar z58 = n0_1 * z57;
    const Scalar z59 = v_a * z25;
    const Scalar z60 = v_a * z20;
    const Scalar z61 = v_lower_omega_y * z59;  // angular acceleration of lower_omega_y, x
    const Scalar z62 = v_lower_omega_x * z59;  // angular acceleration of lower_omega_x, y
    const Scalar z63 = n20000 * q_a_z;
    const Scalar z64 = z49 * z58 - n9_81 * z20;
    const Scalar z65 = z54 * z58 - n9_81 * z18;
    const Scalar z66 = n9_81 * z21 - z33 * z58;
    const Scalar z67 = n0_02 * z66;  // force on upper_cup, z
    const Scalar z68 = z51 * z58 - n9_81 * z34;
    const Scalar z69 = z56 * z58 - n9_81 * z30;
    const Scalar z70 = n9_81 * z25 - z35 * z58;
    const Scalar z71 = n0_02 * z65;  // force on upper_cup, y
    const Scalar z72 = n0_02 * z64;  // force on lower_cup, y
    const Scalar z73 = n0_02 * z70;  // force on lower_cup, z
    const Scalar z74 = n0_02 * z69;  // force on upper_cup, x
    const Scalar z75 = z18 * z71 - z21 * z67 + z30 * z74;
    const Scalar z76 = n0_02 * z68;  // force on lower_cup, x
    const Scalar z77 = z20 * z72 - z25 * z73 + z34 * z76;
    const Scalar z78 = v_a * z18;
    const Scalar z79 = v_a * z21;
    const Scalar z80 = v_lower_omega_z * z60 - z61;  // angular acceleration of lower_cup, x
    const Scalar z81 = v_a * z30;
    const Scalar z82 = v_lower_omega_x * z60;  // angular acceleration of lower_omega_x, z
    const Scalar z83 = k6 * z80;  // moment on lower_cup, x
    const Scalar z84 = n0_1 - z47;  // place of lower_omega_x, x
    const Scalar z85 = v_a * z34;
    const Scalar z86 = z75 + z77;  // force on ring_A, z
    const Scalar z87 = q_a_z - z44;
    const Scalar z88 = v_lower_omega_z * z85 - z62;  // angular acceleration of lower_cup, y
    const Scalar z89 = v_lower_omega_y * z85 - z82;  // angular acceleration of lower_omega_y, z
    const Scalar z90 = n7_848 - z86;  // force on ring_A.1, z
    const Scalar z91 = n0_2 * c_a;
    const Scalar z92 = k6 * z88;  // moment on lower_cup, y
    const Scalar z93 = k6 * z89;  // moment on lower_cup, z
    const Scalar z94 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z95 = z63 + z90;
    const Scalar z96 = v_a_z - z94;
    const Scalar z97 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w * v_lower_omega_y);
    const Scalar z98 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w * v_lower_omega_x);
    const Scalar z99 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w * v_lower_omega_z);
    const Scalar z100 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z101 = v_a * s_a;
    const Scalar z102 = n4 * q_lower_y * z97;
    const Scalar z103 = n4 * q_lower_x * z98;
    const Scalar z104 = z102 + z103;
    const Scalar z105 = v_upper_omega_x * z78;  // angular acceleration of upper_omega_x, z
    const Scalar z106 = v_upper_omega_y * z81 - z105;  // angular acceleration of upper_omega_y, z
    const Scalar z107 = v_upper_omega_y * z79;  // angular acceleration of upper_omega_y, x
    const Scalar z108 = v_upper_omega_z * z78 - z107;  // angular acceleration of upper_cup, x
    const Scalar z109 = v_upper_omega_x * z79;  // angular acceleration of upper_omega_x, y
    const Scalar z110 = v_upper_omega_z * z81 - z109;  // angular acceleration of upper_cup, y
    const Scalar z111 = k6 * z106;  // moment on upper_cup, z
    const Scalar z112 = v_a * c_a;
    const Scalar z113 = v_a * z101;
    const Scalar z114 = k6 * z108;  // moment on upper_cup, x
    const Scalar z115 = n2 * (q_lower_y * z99 - q_lower_z * z97);
    const Scalar z116 = k6 * z110;  // moment on upper_cup, y
    const Scalar z117 = n2 * (q_lower_x * z100 - q_lower_w * z98);
    const Scalar z118 = z115 - z117;
    const Scalar z119 = n0_0005 * v_omega_z;
    const Scalar z120 = z31 * z47 + z35 * z45;
    const Scalar z121 = z3 + z119;
    const Scalar z122 = n0_1 * z101;
    const Scalar z123 = q_lower_y * q_lower_y;
    const Scalar z124 = q_lower_z * q_lower_z;
    const Scalar z125 = q_lower_x * q_lower_x;
    const Scalar z126 = z124 - z125;
    const Scalar z127 = z123 - z124;
    const Scalar z128 = q_lower_w * q_lower_w - z123;
    const Scalar z129 = q_lower_w * q_lower_w - z125;
    const Scalar z130 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z131 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z132 = n2 * z131;
    const Scalar z133 = z127 - z129;
    const Scalar z134 = z127 + z129;
    const Scalar z135 = q_lower_y * q_lower_x;
    const Scalar z136 = q_lower_z * q_lower_w - z135;
    const Scalar z137 = q_lower_z * q_lower_w + z135;
    const Scalar z138 = z126 - z128;
    const Scalar z139 = z0 * z25;
    const Scalar z140 = n0_5 * (v_lower_omega_x * z97 - v_lower_omega_y * z98 + v_lower_omega_z * z100);
    const Scalar z141 = n2 * z136;
    const Scalar z142 = n2 * z137;
    const Scalar z143 = z20 * z87 + z45 * z134 - z84 * z141;
    const Scalar z144 = z34 * z87 + z45 * z142 - z84 * z138;
    const Scalar z145 = n0_5 * (v_lower_omega_x * z98 + v_lower_omega_y * z97 - v_lower_omega_z * z99);
    const Scalar z146 = n0_5 * (v_lower_omega_x * z99 + v_lower_omega_y * z100 + v_lower_omega_z * z98);
    const Scalar z147 = n0_5 * (v_lower_omega_x * z100 - v_lower_omega_y * z99 - v_lower_omega_z * z97);
    const Scalar z148 = n4 * z97;
    const Scalar z149 = n4 * z98;
    const Scalar z150 = z99 * z148 + n2 * (q_lower_y * z140 + q_lower_z * z146);
    const Scalar z151 = z99 * z149 + n2 * (q_lower_z * z147 + q_lower_x * z140);
    const Scalar z152 = z100 * z149 + n2 * (q_lower_x * z145 + q_lower_w * z147);
    const Scalar z153 = z100 * z148 + n2 * (q_lower_y * z145 + q_lower_w * z146);
    const Scalar z154 = n4 * (q_lower_y * z146 - z97 * z97);
    const Scalar z155 = n2 * (q_lower_y * z100 - q_lower_w * z97);
    const Scalar z156 = n4 * (q_lower_x * z147 - z98 * z98);
    const Scalar z157 = z154 + z156;
    const Scalar z158 = n2 * (q_lower_z * z98 - q_lower_x * z99);
    const Scalar z159 = z158 - z155;
    const Scalar z160 = z150 - z152;
    const Scalar z161 = z150 + z152;
    const Scalar z162 = z151 + z153;
    const Scalar z163 = n0_1 * z112;
    const Scalar z164 = v_a * z112;
    const Scalar z165 = n0_1 * z164;
    const Scalar z166 = n0_1 * z113;
    const Scalar z167 = n0_2 * z113;
    const Scalar z168 = z126 + z128;
    const Scalar z169 = z151 - z153;
    const Scalar z170 = n2 * z130;
    const Scalar z171 = z45 * z160 - z87 * z157 + z84 * z162 + z31 * z166 - z35 * z165 + n2 * (z104 * z96 + z118 * z163
        - z159 * z122);
    const Scalar z172 = u_C - z121;
    const Scalar z173 = n100000 * z27;
    const Scalar z174 = z27 * z173 - z52;
    const Scalar z175 = n100000 * z22;
    const Scalar z176 = n100000 * z36;
    const Scalar z177 = n100000 * z32;
    const Scalar z178 = n100000 * z26;
    const Scalar z179 = n100000 * z39;
    const Scalar z180 = q_upper_y * q_upper_y;
    const Scalar z181 = z22 * z175 + z174;
    const Scalar z182 = q_upper_z * q_upper_z;
    const Scalar z183 = q_upper_x * q_upper_x;
    const Scalar z184 = z182 - z183;
    const Scalar z185 = z180 - z182;
    const Scalar z186 = q_upper_w * q_upper_w - z180;
    const Scalar z187 = z36 * z176 + z181;
    const Scalar z188 = z184 + z186;
    const Scalar z189 = q_upper_w * q_upper_w - z183;
    const Scalar z190 = z185 - z189;
    const Scalar z191 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z192 = z32 * z177 + z187;
    const Scalar z193 = n2 * z191;
    const Scalar z194 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z195 = n2 * z194;
    const Scalar z196 = z26 * z178 + z192;
    const Scalar z197 = n25_over_21 * z25;
    const Scalar z198 = z120 + z143 * z179 - z144 * z178;
    const Scalar z199 = z4 * z139;
    const Scalar z200 = z39 * z179 + z196;
    const Scalar z201 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z202 = n1 / z200;
    const Scalar z203 = z133 * z179 - z132 * z177;
    const Scalar z204 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z205 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z206 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z207 = z168 * z178 - z170 * z177;
    const Scalar z208 = n0_5 * (v_upper_omega_x * z201 - v_upper_omega_y * z204 + v_upper_omega_z * z205);
    const Scalar z209 = z202 * z207;
    const Scalar z210 = z202 * z203;
    const Scalar z211 = z202 * z198;
    const Scalar z212 = z176 * z209;
    const Scalar z213 = n100000 * z168 - z178 * z209;
    const Scalar z214 = n100000 * z170 + z177 * z209;
    const Scalar z215 = z178 * z210;
    const Scalar z216 = z176 * z210;
    const Scalar z217 = z175 * z210;
    const Scalar z218 = n100000 * z133 - z179 * z210;
    const Scalar z219 = n100000 * z132 + z177 * z210;
    const Scalar z220 = z173 * z210;
    const Scalar z221 = n100000 * z144 + z178 * z211;
    const Scalar z222 = z177 * z211;
    const Scalar z223 = z176 * z211;
    const Scalar z224 = z175 * z211;
    const Scalar z225 = n100000 * z143 - z179 * z211;
    const Scalar z226 = z173 * z211;
    const Scalar z227 = z91 * z202;
    const Scalar z228 = z179 * z227;
    const Scalar z229 = z178 * z227;
    const Scalar z230 = z176 * z227;
    const Scalar z231 = z175 * z227;
    const Scalar z232 = n0_5 * (v_upper_omega_x * z204 + v_upper_omega_y * z201 - v_upper_omega_z * z206);
    const Scalar z233 = n0_5 * (v_upper_omega_x * z205 - v_upper_omega_y * z206 - v_upper_omega_z * z201);
    const Scalar z234 = n4 * z201;
    const Scalar z235 = z177 * z227;
    const Scalar z236 = z173 * z227;
    const Scalar z237 = n0_5 * (v_upper_omega_x * z206 + v_upper_omega_y * z205 + v_upper_omega_z * z204);
    const Scalar z238 = n4 * z204;
    const Scalar z239 = z175 * z209;
    const Scalar z240 = z173 * z209;
    const Scalar z241 = z206 * z234 + n2 * (q_upper_y * z208 + q_upper_z * z237);
    const Scalar z242 = z206 * z238 + n2 * (q_upper_z * z233 + q_upper_x * z208);
    const Scalar z243 = z205 * z238 + n2 * (q_upper_x * z232 + q_upper_w * z233);
    const Scalar z244 = z205 * z234 + n2 * (q_upper_y * z232 + q_upper_w * z237);
    const Scalar z245 = z241 + z243;
    const Scalar z246 = z242 - z244;
    const Scalar z247 = z91 * z227;
    const Scalar z248 = z188 * z175 - z193 * z173;
    const Scalar z249 = z202 * z248;
    const Scalar z250 = z190 * z176 - z195 * z173;
    const Scalar z251 = z202 * z250;
    const Scalar z252 = z190 * z212 - z195 * z240;
    const Scalar z253 = n100000 * z188 - z175 * z249;
    const Scalar z254 = z175 * z251;
    const Scalar z255 = n100000 * z193 + z173 * z249;
    const Scalar z256 = n100000 * z195 + z173 * z251;
    const Scalar z257 = z188 * z253 + z193 * z255;
    const Scalar z258 = n100000 * z190 - z176 * z251;
    const Scalar z259 = z176 * z249;
    const Scalar z260 = z188 * z254 - z193 * z256;
    const Scalar z261 = n1 / z257;
    const Scalar z262 = z190 * z258 + z195 * z256;
    const Scalar z263 = z188 * z239 - z193 * z240;
    const Scalar z264 = z168 * z213 + z170 * z214;
    const Scalar z265 = z168 * z215 - z170 * z219;
    const Scalar z266 = z190 * z216 - z195 * z220;
    const Scalar z267 = z188 * z217 - z193 * z220;
    const Scalar z268 = z133 * z218 + z132 * z219;
    const Scalar z269 = z132 * z222 + z133 * z225;
    const Scalar z270 = z168 * z221 - z170 * z222;
    const Scalar z271 = z260 * z261;
    const Scalar z272 = z263 * z261;
    const Scalar z273 = z267 * z261;
    const Scalar z274 = z190 * z223 - z195 * z226;
    const Scalar z275 = z265 + z267 * z272;
    const Scalar z276 = z264 - z263 * z272;
    const Scalar z277 = z268 - z267 * z273;
    const Scalar z278 = z188 * z224 - z193 * z226;
    const Scalar z279 = z269 - z278 * z273;
    const Scalar z280 = z270 + z278 * z272;
    const Scalar z281 = z25 * z197 + z139 * z199 - z120 * z211 + z143 * z225 + z144 * z221;
    const Scalar z282 = z120 * z227 + z143 * z228 - z144 * z229;
    const Scalar z283 = z278 * z261;
    const Scalar z284 = z281 - z278 * z283;
    const Scalar z285 = z133 * z228 - z132 * z235;
    const Scalar z286 = z168 * z229 - z170 * z235;
    const Scalar z287 = z190 * z230 - z195 * z236;
    const Scalar z288 = z188 * z231 - z193 * z236;
    const Scalar z289 = z282 + z288 * z283;
    const Scalar z290 = z285 + z288 * z273;
    const Scalar z291 = z286 + z288 * z272;
    const Scalar z292 = z287 + z288 * z271;
    const Scalar z293 = z288 * z261;
    const Scalar z294 = z247 + z288 * z293;
    const Scalar z295 = z179 * z209;
    const Scalar z296 = z252 + z263 * z271;
    const Scalar z297 = z266 + z267 * z271;
    const Scalar z298 = z274 + z278 * z271;
    const Scalar z299 = z262 - z260 * z271;
    const Scalar z300 = n1 / z299;
    const Scalar z301 = z179 * z251;
    const Scalar z302 = z179 * z249;
    const Scalar z303 = z178 * z251;
    const Scalar z304 = z178 * z249;
    const Scalar z305 = z177 * z251;
    const Scalar z306 = z177 * z249;
    const Scalar z307 = z247 - z281;
    const Scalar z308 = n4096 * z307;
    const Scalar z309 = n25_over_21 * z95;
    const Scalar z310 = n100000 * z83;
    const Scalar z311 = n100000 * z92;
    const Scalar z312 = n100000 * z93;
    const Scalar z313 = z133 * z310 - z161 - z132 * z312;
    const Scalar z314 = z169 + z170 * z312 + z168 * z311;
    const Scalar z315 = n100000 * z114;
    const Scalar z316 = n100000 * z111;
    const Scalar z317 = z190 * z315 - z245 - z195 * z316;
    const Scalar z318 = z4 * z172;
    const Scalar z319 = z25 * z309 - z143 * z310 - z144 * z311 + z139 * z318 + z171;
    const Scalar z320 = n100000 * z116;
    const Scalar z321 = z246 + z193 * z316 + z188 * z320;
    const Scalar z322 = z296 * z300;
    const Scalar z323 = z276 - z296 * z322;
    const Scalar z324 = z275 + z297 * z322;
    const Scalar z325 = z280 + z298 * z322;
    const Scalar z326 = z291 + z292 * z322;
    const Scalar z327 = n1 / z323;
    const Scalar z328 = z271 * z321 - z317;
    const Scalar z329 = z314 + z272 * z321 + z322 * z328;
    const Scalar z330 = z297 * z300;
    const Scalar z331 = z277 - z297 * z330;
    const Scalar z332 = z279 - z298 * z330;
    const Scalar z333 = z290 + z292 * z330;
    const Scalar z334 = z298 * z300;
    const Scalar z335 = z284 - z298 * z334;
    const Scalar z336 = z289 + z292 * z334;
    const Scalar z337 = z292 * z300;
    const Scalar z338 = z268 + z264 + z262 + z257;
    const Scalar z339 = z294 + z292 * z337;
    const Scalar z340 = n4096 * z338;
    const Scalar z341 = z324 * z327;
    const Scalar z342 = z325 * z327;
    const Scalar z343 = z326 * z327;
    const Scalar z344 = z339 + z326 * z343;
    const Scalar z345 = z336 + z326 * z342;
    const Scalar z346 = z331 - z324 * z341;
    const Scalar z347 = z333 + z326 * z341;
    const Scalar z348 = z332 - z325 * z341;
    const Scalar z349 = z335 - z325 * z342;
    const Scalar z350 = n1 / z346;
    const Scalar z351 = z273 * z321 - z313 + z330 * z328 + z341 * z329;
    const Scalar z352 = z347 * z350;
    const Scalar z353 = z348 * z350;
    const Scalar z354 = z344 + z347 * z352;
    const Scalar z355 = z345 - z347 * z353;
    const Scalar z356 = z349 - z348 * z353;
    const Scalar z357 = z319 + z283 * z321 + z334 * z328 + z342 * z329 - z353 * z351;
    const Scalar z358 = n1 / z356;
    const Scalar z359 = z355 * z358;
    const Scalar z360 = z354 + z355 * z359;
    const Scalar z361 = z167 + z293 * z321 + z337 * z328 + z343 * z329 + z352 * z351 + z359 * z357;
    const Scalar z362 = n1 / z360;
    const Scalar z363 = z362 * z361;
    const Scalar z364 = z358 * z357 - z359 * z363;
    const Scalar z365 = z350 * z351 - z352 * z363 - z353 * z364;
    const Scalar z366 = z197 * z364 - z309;
    const Scalar z367 = z199 * z364 - z318;
    const Scalar z368 = z327 * z329 - z343 * z363 + z342 * z364 + z341 * z365;
    const Scalar z369 = z300 * z328 - z337 * z363 + z334 * z364 + z330 * z365 + z322 * z368;
    const Scalar z370 = z261 * z321 - z293 * z363 + z283 * z364 + z273 * z365 + z272 * z368 + z271 * z369;
    const Scalar z371 = z227 * z363 - z211 * z364 - z210 * z365 - z209 * z368 - z251 * z369 - z249 * z370;
    const Scalar z372 = z310 + z228 * z363 + z225 * z364 + z218 * z365 - z295 * z368 - z301 * z369 - z302 * z370;
    const Scalar z373 = z229 * z363 - z311 - z221 * z364 - z215 * z365 + z213 * z368 - z303 * z369 - z304 * z370;
    const Scalar z374 = z312 + z235 * z363 - z222 * z364 - z219 * z365 - z214 * z368 - z305 * z369 - z306 * z370;
    const Scalar z375 = z315 + z230 * z363 - z223 * z364 - z216 * z365 - z212 * z368 + z258 * z369 - z259 * z370;
    const Scalar z376 = z231 * z363 - z320 - z224 * z364 - z217 * z365 - z239 * z368 - z254 * z369 + z253 * z370;
    const Scalar z377 = z316 + z236 * z363 - z226 * z364 - z220 * z365 - z240 * z368 - z256 * z369 - z255 * z370;
    accelerations.a_z = z366;
    accelerations.a = z371;
    accelerations.lower_omega_x = -z372;
    accelerations.lower_omega_y = -z373;
    accelerations.lower_omega_z = -z374;
    accelerations.upper_omega_x = -z375;
    accelerations.upper_omega_y = -z376;
    accelerations.upper_omega_z = -z377;
    accelerations.omega_z = -z367;
    multipliers.lambda_L2_y = -z363;
    multipliers.lambda_L2_z = n0;
    multipliers.lambda_L2_ry = n0;
    multipliers.lambda_L2_rz = n0;
    multipliers.lambda_L3_z = -z364;
    multipliers.lambda_L3_rx = -z365;
    multipliers.lambda_L3_ry = z368;
    multipliers.lambda_L5_z = n0;
    multipliers.lambda_L5_rx = -z369;
    multipliers.lambda_L5_ry = z370;
    if (!(traits::regular(-z200, z52) && traits::regular(z2, z2) && traits::regular(-z360, -z308)
        && traits::regular(z356, -z308) && traits::regular(z346, z340) && traits::regular(z323, z340)
        && traits::regular(z299, z340) && traits::regular(z257, z340))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.a_z * accelerations.a * accelerations.lower_omega_x
        * accelerations.lower_omega_y * accelerations.lower_omega_z * accelerations.upper_omega_x
        * accelerations.upper_omega_y * accelerations.upper_omega_z * accelerations.omega_z * multipliers.lambda_L2_y
        * multipliers.lambda_L3_z * multipliers.lambda_L3_rx * multipliers.lambda_L3_ry * multipliers.lambda_L5_rx
        * multipliers.lambda_L5_ry;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_005 = traits::constant(0.005, 0.005f, "1/200");
    const Scalar k7 = traits::constant(5e-05, 5e-05f, "1/20000");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar k9 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    const Scalar pi = traits::pi();
    const Scalar z0 = n2 * q_lower_y;
    const Scalar z1 = n2 * q_upper_y;
    const Scalar z2 = n2 * q_lower_z;
    const Scalar z3 = n2 * q_lower_x;
    const Scalar z4 = n2 * q_upper_z;
    const Scalar z5 = n2 * q_upper_x;
    const Scalar z6 = q_lower_y * z0;
    const Scalar z7 = q_upper_y * z1;
    const Scalar z8 = q_lower_z * z2;
    const Scalar z9 = q_lower_z * z0;
    const Scalar z10 = q_lower_w * z3;
    const Scalar z11 = q_lower_x * z2;
    const Scalar z12 = q_lower_w * z0;
    const Scalar z13 = q_upper_z * z4;
    const Scalar z14 = q_upper_z * z1;
    const Scalar z15 = q_upper_w * z5;
    const Scalar z16 = q_upper_x * z4;
    const Scalar z17 = q_upper_w * z1;
    const Scalar z18 = q_lower_x * z3;
    const Scalar z19 = q_upper_x * z5;
    const Scalar z20 = q_lower_x * z0;
    const Scalar z21 = q_lower_w * z2;
    const Scalar z22 = z9 - z10;
    const Scalar z23 = z9 + z10;
    const Scalar z24 = z11 - z12;
    const Scalar z25 = q_upper_x * z1;
    const Scalar z26 = q_upper_w * z4;
    const Scalar z27 = z14 - z15;
    const Scalar z28 = z14 + z15;
    const Scalar z29 = z16 - z17;
    const Scalar z30 = n0_1 * v_a;
    const Scalar z31 = n1 - z6 - z18;
    const Scalar z32 = n1 - z7 - z19;
    const Scalar z33 = z20 + z21;
    const Scalar z34 = n1 - z8 - z18;
    const Scalar z35 = z25 + z26;
    const Scalar z36 = n1 - z13 - z19;
    const Scalar z37 = v_a * z24;
    const Scalar z38 = v_a * z23;
    const Scalar z39 = v_a * z31;
    const Scalar z40 = v_a * z29;
    const Scalar z41 = v_a * z28;
    const Scalar z42 = v_a * z32;
    const Scalar z43 = v_lower_omega_x + z37;
    const Scalar z44 = v_lower_omega_y + z38;
    const Scalar z45 = v_lower_omega_z + z39;
    const Scalar z46 = v_upper_omega_x + z40;
    const Scalar z47 = v_upper_omega_y + z41;
    const Scalar z48 = v_upper_omega_z + z42;
    const Scalar z49 = n0_002 * q_omega_z / pi;
    const Scalar z50 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z51 = n0_0005 * v_omega_z;
    const Scalar z52 = v_a_z * z24 + z33 * z30;
    const Scalar z53 = v_a_z * z23 + z34 * z30;
    const Scalar z54 = z22 * z30 + v_a_z * z31;
    const Scalar z55 = v_a_z * z29 + z35 * z30;
    const Scalar z56 = v_a_z * z28 + z36 * z30;
    const Scalar z57 = z27 * z30 + v_a_z * z32;
    result.kinetic = n0_4 * v_a_z * v_a_z + n0_005 * v_a * v_a + k7 * v_omega_z * v_omega_z + n0_15 * z50 * z50 + k9
        * (z43 * z43 + z44 * z44 + z45 * z45 + z46 * z46 + z47 * z47 + z48 * z48) + n0_01 * (z52 * z52 + z53 * z53 + z54
        * z54 + z55 * z55 + z56 * z56 + z57 * z57);
    result.force_function = -q_a_z * (n8_2404 + n10000 * q_a_z) - n2_943 * z49;
    result.power = v_omega_z * (u_C - z51);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w * v_lower_omega_y);
    const Scalar z2 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w * v_lower_omega_x);
    const Scalar z3 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w * v_lower_omega_z);
    const Scalar z4 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x * v_lower_omega_x);
    const Scalar z5 = n2 * q_lower_y;
    const Scalar z6 = n2 * q_upper_y;
    const Scalar z7 = q_lower_y * z5;
    const Scalar z8 = n2 * q_lower_x;
    const Scalar z9 = q_upper_y * z6;
    const Scalar z10 = n2 * q_upper_x;
    const Scalar z11 = q_lower_x * z8;
    const Scalar z12 = q_upper_x * z10;
    const Scalar z13 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z14 = n1 - z7 - z11;
    const Scalar z15 = n1 - z9 - z12;
    const Scalar z16 = n0_1 * s_a;
    const Scalar z17 = n0_002 * q_omega_z / pi;
    const Scalar z18 = n4 * q_lower_y * z1;
    const Scalar z19 = n4 * q_lower_x * z2;
    const Scalar z20 = v_a_z - z13;
    const Scalar z21 = q_a_z - z17;
    const Scalar z22 = z18 + z19;
    const Scalar z23 = n0_1 * c_a;
    const Scalar z24 = n2 * (q_lower_y * z3 - q_lower_z * z1);
    const Scalar z25 = n2 * (q_lower_x * z4 - q_lower_w * z2);
    const Scalar z26 = v_a * s_a;
    const Scalar z27 = z24 - z25;
    const Scalar z28 = q_lower_z * z5;
    const Scalar z29 = q_lower_w * z5;
    const Scalar z30 = n0_2 * s_a;
    const Scalar z31 = q_lower_w * z8;
    const Scalar z32 = q_lower_z * z8;
    const Scalar z33 = q_upper_z * z6;
    const Scalar z34 = q_upper_w * z6;
    const Scalar z35 = q_upper_w * z10;
    const Scalar z36 = q_upper_z * z10;
    const Scalar z37 = v_a * c_a;
    const Scalar z38 = q_lower_y * q_lower_y;
    const Scalar z39 = q_lower_x * q_lower_x;
    const Scalar z40 = z28 - z31;
    const Scalar z41 = z28 + z31;
    const Scalar z42 = q_lower_y * q_lower_x;
    const Scalar z43 = z33 - z35;
    const Scalar z44 = z33 + z35;
    const Scalar z45 = z32 - z29;
    const Scalar z46 = z32 + z29;
    const Scalar z47 = z0 * z14;
    const Scalar z48 = n0_5 * (v_lower_omega_x * z1 - v_lower_omega_y * z2 + v_lower_omega_z * z4);
    const Scalar z49 = z36 - z34;
    const Scalar z50 = z36 + z34;
    const Scalar z51 = n0_5 * (v_lower_omega_x * z2 + v_lower_omega_y * z1 - v_lower_omega_z * z3);
    const Scalar z52 = n0_5 * (v_lower_omega_x * z3 + v_lower_omega_y * z4 + v_lower_omega_z * z2);
    const Scalar z53 = n0_2 * z37;
    const Scalar z54 = n0_2 * z26;
    const Scalar z55 = z40 * z23 + z46 * z16;
    const Scalar z56 = n4 * z1;
    const Scalar z57 = z3 * z56 + n2 * (q_lower_y * z48 + q_lower_z * z52);
    const Scalar z58 = n0_1 - z23;  // place of lower_omega_x, x
    const Scalar z59 = z14 * z21 + z40 * z16 + z46 * z58;
    const Scalar z60 = n0_5 * (v_lower_omega_x * z4 - v_lower_omega_y * z3 - v_lower_omega_z * z1);
    const Scalar z61 = n4 * z2;
    const Scalar z62 = z4 * z61 + n2 * (q_lower_x * z51 + q_lower_w * z60);
    const Scalar z63 = v_a * z26;
    const Scalar z64 = n0_1 * z26;
    const Scalar z65 = n0_2 * z63;
    const Scalar z66 = n0_1 * z63;
    const Scalar z67 = n0_1 * z37;
    const Scalar z68 = v_a * z37;
    const Scalar z69 = n0_2 * z68;
    const Scalar z70 = n0_1 * z68;
    const Scalar z71 = n2 * (q_lower_z * z2 - q_lower_x * z3);
    const Scalar z72 = n2 * (q_lower_y * z4 - q_lower_w * z1);
    const Scalar z73 = q_lower_z * q_lower_z - z38;
    const Scalar z74 = q_lower_w * q_lower_w - z38;
    const Scalar z75 = q_lower_w * q_lower_w - z39;
    const Scalar z76 = q_lower_z * q_lower_z - z39;
    const Scalar z77 = q_lower_z * q_lower_w + z42;
    const Scalar z78 = n2 * z77;
    const Scalar z79 = q_lower_z * q_lower_w - z42;
    const Scalar z80 = n2 * z79;
    const Scalar z81 = z71 - z72;
    const Scalar z82 = z14 * z20 - z21 * z22 - z16 * z27 + z40 * z67 + z46 * z64 + z58 * z81;
    const Scalar z83 = z73 - z75;
    const Scalar z84 = z41 * z21 - z16 * z83 - z58 * z80;
    const Scalar z85 = n0_2 * c_a;
    const Scalar z86 = z3 * z61 + n2 * (q_lower_z * z60 + q_lower_x * z48);
    const Scalar z87 = n0_1 - z85;
    const Scalar z88 = z4 * z56 + n2 * (q_lower_y * z51 + q_lower_w * z52);
    const Scalar z89 = n0_1 + z87;
    const Scalar z90 = z24 + z25;
    const Scalar z91 = z73 + z75;
    const Scalar z92 = z71 + z72;
    const Scalar z93 = n4 * (q_lower_y * z52 - z1 * z1);
    const Scalar z94 = n4 * (q_lower_x * z60 - z2 * z2);
    const Scalar z95 = z93 + z94;
    const Scalar z96 = z43 * z23 + z50 * z16;
    const Scalar z97 = z57 + z62;
    const Scalar z98 = z57 - z62;
    const Scalar z99 = z76 + z74;
    const Scalar z100 = z76 - z74;
    const Scalar z101 = z45 * z21 + z16 * z78 - z58 * z100;
    const Scalar z102 = z86 - z88;
    const Scalar z103 = z86 + z88;
    const Scalar z104 = z16 * z98 - z21 * z95 + z58 * z103 + z40 * z66 - z46 * z70 + n2 * (z22 * z20 + z27 * z67 - z81
        * z64);
    const Scalar z105 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z106 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z107 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z108 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z109 = n4 * q_upper_y * z105;
    const Scalar z110 = n4 * q_upper_x * z106;
    const Scalar z111 = z109 + z110;
    const Scalar z112 = n2 * (q_upper_y * z107 - q_upper_z * z105);
    const Scalar z113 = n2 * (q_upper_x * z108 - q_upper_w * z106);
    const Scalar z114 = z15 * z21 + z43 * z16 + z50 * z58;
    const Scalar z115 = q_upper_y * q_upper_y;
    const Scalar z116 = q_upper_x * q_upper_x;
    const Scalar z117 = z112 - z113;
    const Scalar z118 = q_upper_y * q_upper_x;
    const Scalar z119 = n2 * (q_upper_z * z106 - q_upper_x * z107);
    const Scalar z120 = n2 * (q_upper_y * z108 - q_upper_w * z105);
    const Scalar z121 = q_upper_z * q_upper_z - z115;
    const Scalar z122 = q_upper_w * q_upper_w - z115;
    const Scalar z123 = q_upper_w * q_upper_w - z116;
    const Scalar z124 = q_upper_z * q_upper_z - z116;
    const Scalar z125 = q_upper_z * q_upper_w + z118;
    const Scalar z126 = n2 * z125;
    const Scalar z127 = q_upper_z * q_upper_w - z118;
    const Scalar z128 = n2 * z127;
    const Scalar z129 = z119 - z120;
    const Scalar z130 = z15 * z20 - z21 * z111 - z16 * z117 + z43 * z67 + z50 * z64 + z58 * z129;
    const Scalar z131 = z121 - z123;
    const Scalar z132 = z44 * z21 - z16 * z131 - z58 * z128;
    const Scalar z133 = z124 - z122;
    const Scalar z134 = z49 * z21 + z16 * z126 - z58 * z133;
    const Scalar z135 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z136 = n2 * z135;
    const Scalar z137 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z138 = z112 + z113;
    const Scalar z139 = z121 + z123;
    const Scalar z140 = z119 + z120;
    const Scalar z141 = z124 + z122;
    const Scalar z142 = n0_5 * (v_upper_omega_x * z105 - v_upper_omega_y * z106 + v_upper_omega_z * z108);
    const Scalar z143 = n2 * z137;
    const Scalar z144 = n0_5 * (v_upper_omega_x * z106 + v_upper_omega_y * z105 - v_upper_omega_z * z107);
    const Scalar z145 = z0 * z15;
    const Scalar z146 = n0_5 * (v_upper_omega_x * z107 + v_upper_omega_y * z108 + v_upper_omega_z * z106);
    const Scalar z147 = n0_5 * (v_upper_omega_x * z108 - v_upper_omega_y * z107 - v_upper_omega_z * z105);
    const Scalar z148 = n4 * z105;
    const Scalar z149 = n4 * (q_upper_y * z146 - z105 * z105);
    const Scalar z150 = n4 * z106;
    const Scalar z151 = n4 * (q_upper_x * z147 - z106 * z106);
    const Scalar z152 = z107 * z148 + n2 * (q_upper_y * z142 + q_upper_z * z146);
    const Scalar z153 = z107 * z150 + n2 * (q_upper_z * z147 + q_upper_x * z142);
    const Scalar z154 = z108 * z150 + n2 * (q_upper_x * z144 + q_upper_w * z147);
    const Scalar z155 = z108 * z148 + n2 * (q_upper_y * z144 + q_upper_w * z146);
    const Scalar z156 = z152 - z154;
    const Scalar z157 = z152 + z154;
    const Scalar z158 = z149 + z151;
    const Scalar z159 = z153 + z155;
    const Scalar z160 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z161 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z162 = z16 * z156 - z21 * z158 + z58 * z159 + z43 * z66 - z50 * z70 + n2 * (z20 * z111 + z67 * z117
        - z64 * z129);
    const Scalar z163 = n2 * z160;
    const Scalar z164 = n2 * z161;
    const Scalar z165 = z153 - z155;
    result.value[0] = z30;
    result.rate[0] = z53;
    result.gamma[0] = -z65;
    result.value[1] = z89;
    result.rate[1] = z54;
    result.gamma[1] = z69;
    result.value[2] = n0;
    result.rate[2] = n0;
    result.gamma[2] = n0;
    result.value[3] = n0;
    result.rate[3] = n0;
    result.gamma[3] = n0;
    result.value[4] = -z59;
    result.rate[4] = -z82;
    result.gamma[4] = z104;
    result.value[5] = -z41;
    result.rate[5] = z90;
    result.gamma[5] = z97;
    result.value[6] = z45;
    result.rate[6] = z92;
    result.gamma[6] = -z102;
    result.value[7] = -z114;
    result.rate[7] = -z130;
    result.gamma[7] = z162;
    result.value[8] = -z44;
    result.rate[8] = z138;
    result.gamma[8] = z157;
    result.value[9] = z49;
    result.rate[9] = z140;
    result.gamma[9] = -z165;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = -z14;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = -z15;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = z85;
    result.jacobian[11] = z30;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = -z55;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = -z96;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = n0;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = z84;
    result.jacobian[25] = -z91;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = -z101;
    result.jacobian[35] = n0;
    result.jacobian[36] = -z99;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = -z136;
    result.jacobian[46] = z143;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0;
    result.jacobian[56] = n0;
    result.jacobian[57] = z132;
    result.jacobian[58] = -z139;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n0;
    result.jacobian[67] = -z134;
    result.jacobian[68] = n0;
    result.jacobian[69] = -z141;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n0;
    result.jacobian[77] = n0;
    result.jacobian[78] = -z163;
    result.jacobian[79] = z164;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = z47;
    result.jacobian[85] = n0;
    result.jacobian[86] = n0;
    result.jacobian[87] = z145;
    result.jacobian[88] = n0;
    result.jacobian[89] = n0;
  }
};

}  // namespace model_making_press
