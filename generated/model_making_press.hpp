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
  static constexpr unsigned long long fingerprint = 0x3dc8e65453560bf6ULL;
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
    const Scalar z572 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w
        * v_lower_omega_y);
    const Scalar z573 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w
        * v_lower_omega_z);
    const Scalar z575 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w
        * v_lower_omega_x);
    const Scalar z576 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z632 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z633 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z635 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z636 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    rates[0] = v_a_z;
    rates[1] = v_a;
    rates[2] = -z576;
    rates[3] = z575;
    rates[4] = z572;
    rates[5] = -z573;
    rates[6] = -z636;
    rates[7] = z635;
    rates[8] = z632;
    rates[9] = -z633;
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
    const Scalar z129 = n2 * q_lower_y;
    const Scalar z150 = n2 * q_upper_y;
    const Scalar z131 = n2 * q_lower_z;
    const Scalar z152 = n2 * q_upper_z;
    const Scalar z138 = n2 * q_lower_x;
    const Scalar z159 = n2 * q_upper_x;
    const Scalar z130 = q_lower_y * z129;
    const Scalar z151 = q_upper_y * z150;
    const Scalar z132 = q_lower_z * z131;
    const Scalar z133 = q_lower_x * z129;
    const Scalar z134 = q_lower_w * z131;
    const Scalar z153 = q_upper_z * z152;
    const Scalar z154 = q_upper_x * z150;
    const Scalar z155 = q_upper_w * z152;
    const Scalar z135 = n1 - z130 - z132;
    const Scalar z137 = z133 + z134;
    const Scalar z139 = q_lower_x * z138;
    const Scalar z156 = n1 - z151 - z153;
    const Scalar z158 = z154 + z155;
    const Scalar z160 = q_upper_x * z159;
    const Scalar z136 = z133 - z134;
    const Scalar z142 = n1 - z132 - z139;
    const Scalar z145 = q_lower_x * z131;
    const Scalar z146 = q_lower_w * z129;
    const Scalar z157 = z154 - z155;
    const Scalar z163 = n1 - z153 - z160;
    const Scalar z166 = q_upper_x * z152;
    const Scalar z167 = q_upper_w * z150;
    const Scalar z147 = n1 - z130 - z139;
    const Scalar z140 = q_lower_z * z129;
    const Scalar z141 = q_lower_w * z138;
    const Scalar z161 = q_upper_z * z150;
    const Scalar z162 = q_upper_w * z159;
    const Scalar z148 = z145 - z146;
    const Scalar z149 = z145 + z146;
    const Scalar z169 = z166 - z167;
    const Scalar z170 = z166 + z167;
    const Scalar z143 = z140 - z141;
    const Scalar z144 = z140 + z141;
    const Scalar z164 = z161 - z162;
    const Scalar z165 = z161 + z162;
    const Scalar z171 = s_a * z137 - c_a * z135;
    const Scalar z174 = s_a * z135 + c_a * z137;
    const Scalar z192 = s_a * z158 - c_a * z156;
    const Scalar z195 = s_a * z156 + c_a * z158;
    const Scalar z172 = s_a * z142 - c_a * z136;
    const Scalar z175 = s_a * z136 + c_a * z142;
    const Scalar z183 = v_a + v_lower_omega_x * z148;  // angular velocity of lower_omega_x, z
    const Scalar z193 = s_a * z163 - c_a * z157;
    const Scalar z196 = s_a * z157 + c_a * z163;
    const Scalar z200 = v_a + v_upper_omega_x * z169;  // angular velocity of upper_omega_x, z
    const Scalar z168 = n1 - z151 - z160;
    const Scalar z173 = s_a * z143 - c_a * z149;
    const Scalar z176 = s_a * z149 + c_a * z143;
    const Scalar z188 = v_lower_omega_y * z144 + z183;  // angular velocity of lower_omega_y, z
    const Scalar z194 = s_a * z164 - c_a * z170;
    const Scalar z197 = s_a * z170 + c_a * z164;
    const Scalar z203 = v_upper_omega_y * z165 + z200;  // angular velocity of upper_omega_y, z
    const Scalar z177 = n0_1 * c_a;
    const Scalar z180 = n0_1 * v_a;
    const Scalar z178 = n0_1 * s_a;
    const Scalar z184 = s_a * z180;  // velocity of lower_omega_x, x
    const Scalar z179 = n0_1 - z177;  // place of lower_omega_x, x
    const Scalar z185 = c_a * z180;  // velocity of lower_omega_x, y
    const Scalar z191 = v_lower_omega_z * z147 + z188;  // angular velocity of lower_cup, z
    const Scalar z206 = v_upper_omega_z * z168 + z203;  // angular velocity of upper_cup, z
    const Scalar z207 = n0_002 * q_omega_z / pi;
    const Scalar z181 = v_lower_omega_x * z171;  // angular velocity of lower_omega_x, x
    const Scalar z182 = v_lower_omega_x * z174;  // angular velocity of lower_omega_x, y
    const Scalar z198 = v_upper_omega_x * z192;  // angular velocity of upper_omega_x, x
    const Scalar z199 = v_upper_omega_x * z195;  // angular velocity of upper_omega_x, y
    const Scalar z208 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z186 = v_lower_omega_y * z172 + z181;  // angular velocity of lower_omega_y, x
    const Scalar z187 = v_lower_omega_y * z175 + z182;  // angular velocity of lower_omega_y, y
    const Scalar z201 = v_upper_omega_y * z193 + z198;  // angular velocity of upper_omega_y, x
    const Scalar z202 = v_upper_omega_y * z196 + z199;  // angular velocity of upper_omega_y, y
    const Scalar z189 = v_lower_omega_z * z173 + z186;  // angular velocity of lower_cup, x
    const Scalar z190 = v_lower_omega_z * z176 + z187;  // angular velocity of lower_cup, y
    const Scalar z204 = v_upper_omega_z * z194 + z201;  // angular velocity of upper_cup, x
    const Scalar z205 = v_upper_omega_z * z197 + z202;  // angular velocity of upper_cup, y
    result.traverse_position[0] = -z179;
    result.traverse_position[1] = z178;
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
    result.traverse_velocity[0] = -z184;
    result.traverse_velocity[1] = z185;
    result.traverse_velocity[2] = v_a_z;
    result.traverse_angular_velocity[0] = n0;
    result.traverse_angular_velocity[1] = n0;
    result.traverse_angular_velocity[2] = v_a;
    result.screw_position[0] = n0;
    result.screw_position[1] = n0;
    result.screw_position[2] = z207;
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
    result.screw_velocity[2] = z208;
    result.screw_angular_velocity[0] = n0;
    result.screw_angular_velocity[1] = n0;
    result.screw_angular_velocity[2] = v_omega_z;
    result.lower_cup_position[0] = -z179;
    result.lower_cup_position[1] = z178;
    result.lower_cup_position[2] = q_a_z;
    result.lower_cup_rotation[0] = -z171;
    result.lower_cup_rotation[1] = z174;
    result.lower_cup_rotation[2] = z148;
    result.lower_cup_rotation[3] = -z172;
    result.lower_cup_rotation[4] = z175;
    result.lower_cup_rotation[5] = z144;
    result.lower_cup_rotation[6] = -z173;
    result.lower_cup_rotation[7] = z176;
    result.lower_cup_rotation[8] = z147;
    result.lower_cup_velocity[0] = -z184;
    result.lower_cup_velocity[1] = z185;
    result.lower_cup_velocity[2] = v_a_z;
    result.lower_cup_angular_velocity[0] = -z189;
    result.lower_cup_angular_velocity[1] = z190;
    result.lower_cup_angular_velocity[2] = z191;
    result.upper_cup_position[0] = -z179;
    result.upper_cup_position[1] = z178;
    result.upper_cup_position[2] = q_a_z;
    result.upper_cup_rotation[0] = -z192;
    result.upper_cup_rotation[1] = z195;
    result.upper_cup_rotation[2] = z169;
    result.upper_cup_rotation[3] = -z193;
    result.upper_cup_rotation[4] = z196;
    result.upper_cup_rotation[5] = z165;
    result.upper_cup_rotation[6] = -z194;
    result.upper_cup_rotation[7] = z197;
    result.upper_cup_rotation[8] = z168;
    result.upper_cup_velocity[0] = -z184;
    result.upper_cup_velocity[1] = z185;
    result.upper_cup_velocity[2] = v_a_z;
    result.upper_cup_angular_velocity[0] = -z204;
    result.upper_cup_angular_velocity[1] = z205;
    result.upper_cup_angular_velocity[2] = z206;
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
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z280 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z68;
    });
    const Scalar z281 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z68 * z280;
    });
    const Scalar z301 = n2 * q_upper_y;
    const Scalar z303 = n2 * q_upper_x;
    const Scalar z290 = n2 * q_lower_y;
    const Scalar z292 = n2 * q_lower_x;
    const Scalar z291 = q_lower_y * z290;
    const Scalar z293 = q_lower_x * z292;
    const Scalar z302 = q_upper_y * z301;
    const Scalar z305 = q_upper_z * z301;
    const Scalar z306 = q_upper_w * z303;
    const Scalar z294 = q_lower_z * z290;
    const Scalar z295 = q_lower_w * z292;
    const Scalar z304 = q_upper_x * z303;
    const Scalar z307 = z305 + z306;
    const Scalar z296 = z294 + z295;
    const Scalar z310 = n1 - z302 - z304;
    const Scalar z308 = q_upper_z * z303;
    const Scalar z309 = q_upper_w * z301;
    const Scalar z313 = k5 * z307;
    const Scalar z299 = n1 - z291 - z293;
    const Scalar z319 = k5 * z296;
    const Scalar z297 = q_lower_z * z292;
    const Scalar z298 = q_lower_w * z290;
    const Scalar z312 = k5 * z310;
    const Scalar z311 = z308 - z309;
    const Scalar z318 = k5 * z299;
    const Scalar z300 = z297 - z298;
    const Scalar z314 = k5 * z311;
    const Scalar z320 = k5 * z300;
    const Scalar z315 = z307 * z313 + z310 * z312 + z311 * z314;
    const Scalar z321 = z296 * z319 + z299 * z318 + z300 * z320;
    const Scalar z316 = n0_0002 + z315;
    const Scalar z322 = n0_0002 + z321;
    const Scalar z317 = n0_01 + z316;
    const Scalar z323 = z317 + z322;
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
    mass[10] = z323;
    mass[11] = z320;
    mass[12] = z319;
    mass[13] = z318;
    mass[14] = z314;
    mass[15] = z313;
    mass[16] = z312;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = z320;
    mass[20] = k5;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = z319;
    mass[29] = n0;
    mass[30] = k5;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = z318;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k5;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = z314;
    mass[47] = n0;
    mass[48] = n0;
    mass[49] = n0;
    mass[50] = k5;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = z313;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = k5;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = z312;
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
    mass[80] = z281;
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
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z392 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z68;
    });
    const Scalar z393 = n2 * q_lower_y;
    const Scalar z395 = n2 * q_lower_z;
    const Scalar z411 = n2 * q_upper_y;
    const Scalar z413 = n2 * q_upper_z;
    const Scalar z401 = n2 * q_lower_x;
    const Scalar z419 = n2 * q_upper_x;
    const Scalar z394 = q_lower_y * z393;
    const Scalar z397 = q_lower_x * z393;
    const Scalar z398 = q_lower_w * z395;
    const Scalar z412 = q_upper_y * z411;
    const Scalar z415 = q_upper_x * z411;
    const Scalar z416 = q_upper_w * z413;
    const Scalar z437 = v_a * v_a;
    const Scalar z400 = z397 - z398;
    const Scalar z402 = q_lower_x * z401;
    const Scalar z403 = q_lower_z * z393;
    const Scalar z404 = q_lower_w * z401;
    const Scalar z418 = z415 - z416;
    const Scalar z420 = q_upper_x * z419;
    const Scalar z421 = q_upper_z * z411;
    const Scalar z422 = q_upper_w * z419;
    const Scalar z438 = n0_1 * z437;
    const Scalar z405 = z403 + z404;
    const Scalar z406 = q_lower_x * z395;
    const Scalar z407 = q_lower_w * z393;
    const Scalar z408 = n1 - z394 - z402;
    const Scalar z423 = z421 + z422;
    const Scalar z424 = q_upper_x * z413;
    const Scalar z425 = q_upper_w * z411;
    const Scalar z426 = n1 - z412 - z420;
    const Scalar z396 = q_lower_z * z395;
    const Scalar z414 = q_upper_z * z413;
    const Scalar z410 = z406 + z407;
    const Scalar z428 = z424 + z425;
    const Scalar z399 = n1 - z394 - z396;
    const Scalar z417 = n1 - z412 - z414;
    const Scalar z440 = z400 * z438 - n9_81 * z405;
    const Scalar z449 = z418 * z438 - n9_81 * z423;
    const Scalar z409 = z406 - z407;
    const Scalar z427 = z424 - z425;
    const Scalar z441 = n9_81 * z408 - z410 * z438;
    const Scalar z450 = n9_81 * z426 - z428 * z438;
    const Scalar z458 = n0_02 * z449;  // force on upper_cup, y
    const Scalar z465 = n0_02 * z440;  // force on lower_cup, y
    const Scalar z459 = n0_02 * z450;  // force on upper_cup, z
    const Scalar z466 = n0_02 * z441;  // force on lower_cup, z
    const Scalar z439 = z399 * z438 - n9_81 * z409;
    const Scalar z448 = z417 * z438 - n9_81 * z427;
    const Scalar z457 = n0_02 * z448;  // force on upper_cup, x
    const Scalar z464 = n0_02 * z439;  // force on lower_cup, x
    const Scalar z430 = v_a * z405;
    const Scalar z431 = v_a * z408;
    const Scalar z433 = v_a * z423;
    const Scalar z434 = v_a * z426;
    const Scalar z463 = z423 * z458 - z426 * z459 + z427 * z457;
    const Scalar z470 = z405 * z465 - z408 * z466 + z409 * z464;
    const Scalar z429 = v_a * z409;
    const Scalar z432 = v_a * z427;
    const Scalar z442 = v_lower_omega_x * z431;  // angular acceleration of lower_omega_x, y
    const Scalar z443 = v_lower_omega_x * z430;  // angular acceleration of lower_omega_x, z
    const Scalar z444 = v_lower_omega_y * z431;  // angular acceleration of lower_omega_y, x
    const Scalar z451 = v_upper_omega_x * z434;  // angular acceleration of upper_omega_x, y
    const Scalar z452 = v_upper_omega_x * z433;  // angular acceleration of upper_omega_x, z
    const Scalar z453 = v_upper_omega_y * z434;  // angular acceleration of upper_omega_y, x
    const Scalar z471 = z463 + z470;  // force on ring_A, z
    const Scalar z435 = n20000 * q_a_z;
    const Scalar z436 = n0_0005 * v_omega_z;
    const Scalar z445 = v_lower_omega_y * z429 - z443;  // angular acceleration of lower_omega_y, z
    const Scalar z446 = v_lower_omega_z * z430 - z444;  // angular acceleration of lower_cup, x
    const Scalar z447 = v_lower_omega_z * z429 - z442;  // angular acceleration of lower_cup, y
    const Scalar z454 = v_upper_omega_y * z432 - z452;  // angular acceleration of upper_omega_y, z
    const Scalar z455 = v_upper_omega_z * z433 - z453;  // angular acceleration of upper_cup, x
    const Scalar z456 = v_upper_omega_z * z432 - z451;  // angular acceleration of upper_cup, y
    const Scalar z472 = n7_848 - z471;  // force on ring_A.1, z
    const Scalar z460 = k10 * z455;  // moment on upper_cup, x
    const Scalar z461 = k10 * z456;  // moment on upper_cup, y
    const Scalar z462 = k10 * z454;  // moment on upper_cup, z
    const Scalar z467 = k10 * z446;  // moment on lower_cup, x
    const Scalar z468 = k10 * z447;  // moment on lower_cup, y
    const Scalar z469 = k10 * z445;  // moment on lower_cup, z
    const Scalar z473 = z435 + z472;
    const Scalar z474 = z392 + z436;
    forces.a_z = z473;
    forces.a = n0;
    forces.lower_omega_x = z467;
    forces.lower_omega_y = -z468;
    forces.lower_omega_z = z469;
    forces.upper_omega_x = z460;
    forces.upper_omega_y = -z461;
    forces.upper_omega_z = z462;
    forces.omega_z = z474;
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
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z280 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z68;
    });
    const Scalar z281 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z68 * z280;
    });
    const Scalar z392 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z68;
    });
    const Scalar z722 = n2 * q_lower_y;
    const Scalar z724 = n2 * q_lower_z;
    const Scalar z741 = n2 * q_upper_y;
    const Scalar z743 = n2 * q_upper_z;
    const Scalar z730 = n2 * q_lower_x;
    const Scalar z749 = n2 * q_upper_x;
    const Scalar z723 = q_lower_y * z722;
    const Scalar z726 = q_lower_x * z722;
    const Scalar z727 = q_lower_w * z724;
    const Scalar z742 = q_upper_y * z741;
    const Scalar z745 = q_upper_x * z741;
    const Scalar z746 = q_upper_w * z743;
    const Scalar z784 = v_a * v_a;
    const Scalar z729 = z726 - z727;
    const Scalar z731 = q_lower_x * z730;
    const Scalar z732 = q_lower_z * z722;
    const Scalar z733 = q_lower_w * z730;
    const Scalar z748 = z745 - z746;
    const Scalar z750 = q_upper_x * z749;
    const Scalar z751 = q_upper_z * z741;
    const Scalar z752 = q_upper_w * z749;
    const Scalar z736 = q_lower_x * z724;
    const Scalar z737 = q_lower_w * z722;
    const Scalar z735 = z732 + z733;
    const Scalar z738 = n1 - z723 - z731;
    const Scalar z754 = z751 + z752;
    const Scalar z755 = q_upper_x * z743;
    const Scalar z756 = q_upper_w * z741;
    const Scalar z757 = n1 - z742 - z750;
    const Scalar z725 = q_lower_z * z724;
    const Scalar z785 = n0_1 * z784;
    const Scalar z739 = z736 - z737;
    const Scalar z740 = z736 + z737;
    const Scalar z744 = q_upper_z * z743;
    const Scalar z759 = z755 + z756;
    const Scalar z728 = n1 - z723 - z725;
    const Scalar z747 = n1 - z742 - z744;
    const Scalar z778 = k7 * z739;
    const Scalar z787 = z729 * z785 - n9_81 * z735;
    const Scalar z758 = z755 - z756;
    const Scalar z771 = k7 * z754;
    const Scalar z777 = k7 * z735;
    const Scalar z734 = z732 - z733;
    const Scalar z796 = z748 * z785 - n9_81 * z754;
    const Scalar z788 = n9_81 * z738 - z740 * z785;
    const Scalar z753 = z751 - z752;
    const Scalar z797 = n9_81 * z757 - z759 * z785;
    const Scalar z805 = n0_02 * z796;  // force on upper_cup, y
    const Scalar z812 = n0_02 * z787;  // force on lower_cup, y
    const Scalar z806 = n0_02 * z797;  // force on upper_cup, z
    const Scalar z813 = n0_02 * z788;  // force on lower_cup, z
    const Scalar z786 = z728 * z785 - n9_81 * z739;
    const Scalar z795 = z747 * z785 - n9_81 * z758;
    const Scalar z770 = k7 * z757;
    const Scalar z804 = n0_02 * z795;  // force on upper_cup, x
    const Scalar z811 = n0_02 * z786;  // force on lower_cup, x
    const Scalar z817 = z735 * z812 - z738 * z813 + z739 * z811;
    const Scalar z772 = k7 * z758;
    const Scalar z764 = v_a * z735;
    const Scalar z810 = z754 * z805 - z757 * z806 + z758 * z804;
    const Scalar z765 = v_a * z738;
    const Scalar z767 = v_a * z754;
    const Scalar z818 = z810 + z817;  // force on ring_A, z
    const Scalar z768 = v_a * z757;
    const Scalar z776 = k7 * z738;
    const Scalar z763 = v_a * z739;
    const Scalar z819 = n7_848 - z818;  // force on ring_A.1, z
    const Scalar z766 = v_a * z758;
    const Scalar z789 = v_lower_omega_x * z765;  // angular acceleration of lower_omega_x, y
    const Scalar z791 = v_lower_omega_y * z765;  // angular acceleration of lower_omega_y, x
    const Scalar z793 = v_lower_omega_z * z764 - z791;  // angular acceleration of lower_cup, x
    const Scalar z790 = v_lower_omega_x * z764;  // angular acceleration of lower_omega_x, z
    const Scalar z792 = v_lower_omega_y * z763 - z790;  // angular acceleration of lower_omega_y, z
    const Scalar z794 = v_lower_omega_z * z763 - z789;  // angular acceleration of lower_cup, y
    const Scalar z815 = k7 * z794;  // moment on lower_cup, y
    const Scalar z814 = k7 * z793;  // moment on lower_cup, x
    const Scalar z798 = v_upper_omega_x * z768;  // angular acceleration of upper_omega_x, y
    const Scalar z800 = v_upper_omega_y * z768;  // angular acceleration of upper_omega_y, x
    const Scalar z802 = v_upper_omega_z * z767 - z800;  // angular acceleration of upper_cup, x
    const Scalar z799 = v_upper_omega_x * z767;  // angular acceleration of upper_omega_x, z
    const Scalar z801 = v_upper_omega_y * z766 - z799;  // angular acceleration of upper_omega_y, z
    const Scalar z803 = v_upper_omega_z * z766 - z798;  // angular acceleration of upper_cup, y
    const Scalar z808 = k7 * z803;  // moment on upper_cup, y
    const Scalar z807 = k7 * z802;  // moment on upper_cup, x
    const Scalar z816 = k7 * z792;  // moment on lower_cup, z
    const Scalar z769 = n0_002 * q_omega_z / pi;
    const Scalar z809 = k7 * z801;  // moment on upper_cup, z
    const Scalar z773 = z754 * z771 + z757 * z770 + z758 * z772;
    const Scalar z774 = n0_0002 + z773;
    const Scalar z779 = z735 * z777 + z738 * z776 + z739 * z778;
    const Scalar z775 = n0_01 + z774;
    const Scalar z780 = n0_0002 + z779;
    const Scalar z761 = n0_1 * s_a;
    const Scalar z760 = n0_1 * c_a;
    const Scalar z782 = n20000 * q_a_z;
    const Scalar z820 = z782 + z819;
    const Scalar z781 = z775 + z780;
    const Scalar z783 = n0_0005 * v_omega_z;
    const Scalar z821 = z392 + z783;
    const Scalar z762 = n0_1 - z760;  // place of lower_omega_x, x
    const Scalar z834 = z734 * z760 + z740 * z761;
    const Scalar z858 = z753 * z760 + z759 * z761;
    const Scalar z822 = n0_84 * a_a_z + z820;
    const Scalar z823 = a_lower_omega_x * z778 + a_lower_omega_y * z777 + a_upper_omega_x * z772 + a_upper_omega_y
        * z771 + a_lower_omega_z * z776 + a_upper_omega_z * z770 + a_a * z781;
    const Scalar z824 = z814 + k7 * a_lower_omega_x + a_a * z778;
    const Scalar z825 = k7 * a_lower_omega_y - z815 + a_a * z777;
    const Scalar z838 = q_lower_x * q_lower_x;
    const Scalar z841 = q_lower_y * q_lower_x;
    const Scalar z826 = z816 + k7 * a_lower_omega_z + a_a * z776;
    const Scalar z862 = q_upper_x * q_upper_x;
    const Scalar z865 = q_upper_y * q_upper_x;
    const Scalar z827 = z807 + k7 * a_upper_omega_x + a_a * z772;
    const Scalar z835 = q_lower_y * q_lower_y;
    const Scalar z836 = q_lower_z * q_lower_z;
    const Scalar z828 = k7 * a_upper_omega_y - z808 + a_a * z771;
    const Scalar z859 = q_upper_y * q_upper_y;
    const Scalar z860 = q_upper_z * q_upper_z;
    const Scalar z829 = z809 + k7 * a_upper_omega_z + a_a * z770;
    const Scalar z833 = q_a_z - z769;
    const Scalar z837 = z835 - z836;
    const Scalar z839 = q_lower_w * q_lower_w - z838;
    const Scalar z847 = z836 - z838;
    const Scalar z845 = q_lower_z * q_lower_w + z841;
    const Scalar z830 = a_omega_z * z281 + z821;
    const Scalar z861 = z859 - z860;
    const Scalar z853 = z68 * z738;
    const Scalar z863 = q_upper_w * q_upper_w - z862;
    const Scalar z871 = z860 - z862;
    const Scalar z869 = q_upper_z * q_upper_w + z865;
    const Scalar z877 = z68 * z757;
    const Scalar z840 = z837 + z839;
    const Scalar z854 = z837 - z839;
    const Scalar z846 = n2 * z845;
    const Scalar z864 = z861 + z863;
    const Scalar z870 = n2 * z869;
    const Scalar z842 = q_lower_z * q_lower_w - z841;
    const Scalar z848 = q_lower_w * q_lower_w - z835;
    const Scalar z866 = q_upper_z * q_upper_w - z865;
    const Scalar z872 = q_upper_w * q_upper_w - z859;
    const Scalar z843 = n2 * z842;
    const Scalar z849 = z847 - z848;
    const Scalar z844 = z735 * z833 + z761 * z840 - z762 * z843;
    const Scalar z867 = n2 * z866;
    const Scalar z873 = z871 - z872;
    const Scalar z851 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z852 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z850 = z739 * z833 + z761 * z846 - z762 * z849;
    const Scalar z875 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z876 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z831 = n0_2 * c_a;
    const Scalar z832 = n0_2 * s_a;
    const Scalar z855 = n2 * z851;
    const Scalar z856 = z847 + z848;
    const Scalar z857 = n2 * z852;
    const Scalar z868 = z754 * z833 + z761 * z864 - z762 * z867;
    const Scalar z874 = z758 * z833 + z761 * z870 - z762 * z873;
    const Scalar z878 = z861 - z863;
    const Scalar z879 = n2 * z875;
    const Scalar z880 = z871 + z872;
    const Scalar z881 = n2 * z876;
    forces.a_z = z822 + l_lambda_L3_z * z738 + l_lambda_L5_z * z757;
    forces.a = -l_lambda_L2_y * z831 + z823 - l_lambda_L2_z * z832 + l_lambda_L3_z * z834 + l_lambda_L5_z * z858;
    forces.lower_omega_x = -l_lambda_L3_rx * z854 + z824 - l_lambda_L3_z * z844;
    forces.lower_omega_y = l_lambda_L3_ry * z856 + z825 + l_lambda_L3_z * z850;
    forces.lower_omega_z = z826 + l_lambda_L3_rx * z855 - l_lambda_L3_ry * z857;
    forces.upper_omega_x = -l_lambda_L5_rx * z878 + z827 - l_lambda_L5_z * z868;
    forces.upper_omega_y = l_lambda_L5_ry * z880 + z828 + l_lambda_L5_z * z874;
    forces.upper_omega_z = z829 + l_lambda_L5_rx * z879 - l_lambda_L5_ry * z881;
    forces.omega_z = -l_lambda_L3_z * z853 + z830 - l_lambda_L5_z * z877;
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
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z280 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z68;
    });
    const Scalar z281 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z68 * z280;
    });
    const Scalar z392 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z68;
    });
    const Scalar z883 = traits::formula(9987.856223025203, 9987.856f, [&]() -> Scalar {
      return n1 / z281;
    });
    const Scalar z1113 = n2 * q_upper_y;
    const Scalar z1121 = n2 * q_upper_x;
    const Scalar z1094 = n2 * q_lower_y;
    const Scalar z1102 = n2 * q_lower_x;
    const Scalar z1115 = n2 * q_upper_z;
    const Scalar z1096 = n2 * q_lower_z;
    const Scalar z1114 = q_upper_y * z1113;
    const Scalar z1123 = q_upper_z * z1113;
    const Scalar z1124 = q_upper_w * z1121;
    const Scalar z1095 = q_lower_y * z1094;
    const Scalar z1104 = q_lower_z * z1094;
    const Scalar z1105 = q_lower_w * z1102;
    const Scalar z1122 = q_upper_x * z1121;
    const Scalar z1125 = z1123 + z1124;
    const Scalar z1103 = q_lower_x * z1102;
    const Scalar z1107 = z1104 + z1105;
    const Scalar z1128 = n1 - z1114 - z1122;
    const Scalar z1143 = k6 * z1125;
    const Scalar z1126 = q_upper_x * z1115;
    const Scalar z1127 = q_upper_w * z1113;
    const Scalar z1110 = n1 - z1095 - z1103;
    const Scalar z1149 = k6 * z1107;
    const Scalar z1142 = k6 * z1128;
    const Scalar z1108 = q_lower_x * z1096;
    const Scalar z1109 = q_lower_w * z1094;
    const Scalar z1129 = z1126 - z1127;
    const Scalar z1106 = z1104 - z1105;
    const Scalar z1148 = k6 * z1110;
    const Scalar z1130 = z1126 + z1127;
    const Scalar z1111 = z1108 - z1109;
    const Scalar z1112 = z1108 + z1109;
    const Scalar z1144 = k6 * z1129;
    const Scalar z1098 = q_lower_x * z1094;
    const Scalar z1117 = q_upper_x * z1113;
    const Scalar z1150 = k6 * z1111;
    const Scalar z1145 = z1125 * z1143 + z1128 * z1142 + z1129 * z1144;
    const Scalar z1151 = z1107 * z1149 + z1110 * z1148 + z1111 * z1150;
    const Scalar z1146 = n0_0002 + z1145;
    const Scalar z1152 = n0_0002 + z1151;
    const Scalar z1140 = n0_002 * q_omega_z / pi;
    const Scalar z1132 = n0_1 * s_a;
    const Scalar z1147 = n0_01 + z1146;
    const Scalar z1131 = n0_1 * c_a;
    const Scalar z1099 = q_lower_w * z1096;
    const Scalar z1101 = z1098 - z1099;
    const Scalar z1097 = q_lower_z * z1096;
    const Scalar z1100 = n1 - z1095 - z1097;
    const Scalar z1153 = z1147 + z1152;
    const Scalar z1118 = q_upper_w * z1115;
    const Scalar z1120 = z1117 - z1118;
    const Scalar z1116 = q_upper_z * z1115;
    const Scalar z1119 = n1 - z1114 - z1116;
    const Scalar z1156 = v_a * v_a;
    const Scalar z1157 = n0_1 * z1156;
    const Scalar z1136 = v_a * z1110;
    const Scalar z1135 = v_a * z1107;
    const Scalar z1163 = v_lower_omega_y * z1136;  // angular acceleration of lower_omega_y, x
    const Scalar z1161 = v_lower_omega_x * z1136;  // angular acceleration of lower_omega_x, y
    const Scalar z1154 = n20000 * q_a_z;
    const Scalar z1159 = z1101 * z1157 - n9_81 * z1107;
    const Scalar z1168 = z1120 * z1157 - n9_81 * z1125;
    const Scalar z1169 = n9_81 * z1128 - z1130 * z1157;
    const Scalar z1178 = n0_02 * z1169;  // force on upper_cup, z
    const Scalar z1158 = z1100 * z1157 - n9_81 * z1111;
    const Scalar z1167 = z1119 * z1157 - n9_81 * z1129;
    const Scalar z1160 = n9_81 * z1110 - z1112 * z1157;
    const Scalar z1177 = n0_02 * z1168;  // force on upper_cup, y
    const Scalar z1184 = n0_02 * z1159;  // force on lower_cup, y
    const Scalar z1185 = n0_02 * z1160;  // force on lower_cup, z
    const Scalar z1176 = n0_02 * z1167;  // force on upper_cup, x
    const Scalar z1182 = z1125 * z1177 - z1128 * z1178 + z1129 * z1176;
    const Scalar z1183 = n0_02 * z1158;  // force on lower_cup, x
    const Scalar z1189 = z1107 * z1184 - z1110 * z1185 + z1111 * z1183;
    const Scalar z1138 = v_a * z1125;
    const Scalar z1139 = v_a * z1128;
    const Scalar z1165 = v_lower_omega_z * z1135 - z1163;  // angular acceleration of lower_cup, x
    const Scalar z1137 = v_a * z1129;
    const Scalar z1162 = v_lower_omega_x * z1135;  // angular acceleration of lower_omega_x, z
    const Scalar z1186 = k6 * z1165;  // moment on lower_cup, x
    const Scalar z1133 = n0_1 - z1131;  // place of lower_omega_x, x
    const Scalar z1134 = v_a * z1111;
    const Scalar z1190 = z1182 + z1189;  // force on ring_A, z
    const Scalar z1200 = q_a_z - z1140;
    const Scalar z1166 = v_lower_omega_z * z1134 - z1161;  // angular acceleration of lower_cup, y
    const Scalar z1164 = v_lower_omega_y * z1134 - z1162;  // angular acceleration of lower_omega_y, z
    const Scalar z1191 = n7_848 - z1190;  // force on ring_A.1, z
    const Scalar z1194 = n0_2 * c_a;
    const Scalar z1187 = k6 * z1166;  // moment on lower_cup, y
    const Scalar z1188 = k6 * z1164;  // moment on lower_cup, z
    const Scalar z1141 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z1192 = z1154 + z1191;
    const Scalar z1212 = v_a_z - z1141;
    const Scalar z1201 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w
        * v_lower_omega_y);
    const Scalar z1204 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w
        * v_lower_omega_x);
    const Scalar z1202 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w
        * v_lower_omega_z);
    const Scalar z1205 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z1196 = v_a * s_a;
    const Scalar z1209 = n4 * q_lower_y * z1201;
    const Scalar z1210 = n4 * q_lower_x * z1204;
    const Scalar z1211 = z1209 + z1210;
    const Scalar z1171 = v_upper_omega_x * z1138;  // angular acceleration of upper_omega_x, z
    const Scalar z1173 = v_upper_omega_y * z1137 - z1171;  // angular acceleration of upper_omega_y, z
    const Scalar z1172 = v_upper_omega_y * z1139;  // angular acceleration of upper_omega_y, x
    const Scalar z1174 = v_upper_omega_z * z1138 - z1172;  // angular acceleration of upper_cup, x
    const Scalar z1170 = v_upper_omega_x * z1139;  // angular acceleration of upper_omega_x, y
    const Scalar z1175 = v_upper_omega_z * z1137 - z1170;  // angular acceleration of upper_cup, y
    const Scalar z1181 = k6 * z1173;  // moment on upper_cup, z
    const Scalar z1195 = v_a * c_a;
    const Scalar z1197 = v_a * z1196;
    const Scalar z1179 = k6 * z1174;  // moment on upper_cup, x
    const Scalar z1203 = n2 * (q_lower_y * z1202 - q_lower_z * z1201);
    const Scalar z1180 = k6 * z1175;  // moment on upper_cup, y
    const Scalar z1206 = n2 * (q_lower_x * z1205 - q_lower_w * z1204);
    const Scalar z1207 = z1203 - z1206;
    const Scalar z1155 = n0_0005 * v_omega_z;
    const Scalar z1217 = z1106 * z1131 + z1112 * z1132;
    const Scalar z1193 = z392 + z1155;
    const Scalar z1216 = n0_1 * z1196;
    const Scalar z1218 = q_lower_y * q_lower_y;
    const Scalar z1219 = q_lower_z * q_lower_z;
    const Scalar z1221 = q_lower_x * q_lower_x;
    const Scalar z1230 = z1219 - z1221;
    const Scalar z1220 = z1218 - z1219;
    const Scalar z1231 = q_lower_w * q_lower_w - z1218;
    const Scalar z1222 = q_lower_w * q_lower_w - z1221;
    const Scalar z1235 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z1234 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z1256 = n2 * z1234;
    const Scalar z1255 = z1220 - z1222;
    const Scalar z1223 = z1220 + z1222;
    const Scalar z1224 = q_lower_y * q_lower_x;
    const Scalar z1225 = q_lower_z * q_lower_w - z1224;
    const Scalar z1228 = q_lower_z * q_lower_w + z1224;
    const Scalar z1232 = z1230 - z1231;
    const Scalar z1236 = z68 * z1110;
    const Scalar z1239 = n0_5 * (v_lower_omega_x * z1201 - v_lower_omega_y * z1204 + v_lower_omega_z * z1205);
    const Scalar z1226 = n2 * z1225;
    const Scalar z1229 = n2 * z1228;
    const Scalar z1227 = z1107 * z1200 + z1132 * z1223 - z1133 * z1226;
    const Scalar z1233 = z1111 * z1200 + z1132 * z1229 - z1133 * z1232;
    const Scalar z1243 = n0_5 * (v_lower_omega_x * z1204 + v_lower_omega_y * z1201 - v_lower_omega_z * z1202);
    const Scalar z1240 = n0_5 * (v_lower_omega_x * z1202 + v_lower_omega_y * z1205 + v_lower_omega_z * z1204);
    const Scalar z1244 = n0_5 * (v_lower_omega_x * z1205 - v_lower_omega_y * z1202 - v_lower_omega_z * z1201);
    const Scalar z1241 = n4 * z1201;
    const Scalar z1245 = n4 * z1204;
    const Scalar z1242 = z1202 * z1241 + n2 * (q_lower_y * z1239 + q_lower_z * z1240);
    const Scalar z1248 = z1202 * z1245 + n2 * (q_lower_z * z1244 + q_lower_x * z1239);
    const Scalar z1246 = z1205 * z1245 + n2 * (q_lower_x * z1243 + q_lower_w * z1244);
    const Scalar z1249 = z1205 * z1241 + n2 * (q_lower_y * z1243 + q_lower_w * z1240);
    const Scalar z1251 = n4 * (q_lower_y * z1240 - z1201 * z1201);
    const Scalar z1214 = n2 * (q_lower_y * z1205 - q_lower_w * z1201);
    const Scalar z1252 = n4 * (q_lower_x * z1244 - z1204 * z1204);
    const Scalar z1253 = z1251 + z1252;
    const Scalar z1213 = n2 * (q_lower_z * z1204 - q_lower_x * z1202);
    const Scalar z1215 = z1213 - z1214;
    const Scalar z1247 = z1242 - z1246;
    const Scalar z1257 = z1242 + z1246;
    const Scalar z1250 = z1248 + z1249;
    const Scalar z1208 = n0_1 * z1195;
    const Scalar z1199 = v_a * z1195;
    const Scalar z1238 = n0_1 * z1199;
    const Scalar z1237 = n0_1 * z1197;
    const Scalar z1198 = n0_2 * z1197;
    const Scalar z1258 = z1230 + z1231;
    const Scalar z1260 = z1248 - z1249;
    const Scalar z1259 = n2 * z1235;
    const Scalar z1254 = z1132 * z1247 - z1200 * z1253 + z1133 * z1250 + z1106 * z1237 - z1112 * z1238 + n2 * (z1211
        * z1212 + z1207 * z1208 - z1215 * z1216);
    const Scalar z1290 = u_C - z1193;
    const Scalar z1291 = n100000 * z1142;
    const Scalar z1292 = z1142 * z1291 - z1153;
    const Scalar z1293 = n100000 * z1143;
    const Scalar z1295 = n100000 * z1144;
    const Scalar z1297 = n100000 * z1148;
    const Scalar z1299 = n100000 * z1149;
    const Scalar z1301 = n100000 * z1150;
    const Scalar z1265 = q_upper_y * q_upper_y;
    const Scalar z1294 = z1143 * z1293 + z1292;
    const Scalar z1266 = q_upper_z * q_upper_z;
    const Scalar z1268 = q_upper_x * q_upper_x;
    const Scalar z1270 = z1266 - z1268;
    const Scalar z1267 = z1265 - z1266;
    const Scalar z1271 = q_upper_w * q_upper_w - z1265;
    const Scalar z1296 = z1144 * z1295 + z1294;
    const Scalar z1287 = z1270 + z1271;
    const Scalar z1269 = q_upper_w * q_upper_w - z1268;
    const Scalar z1284 = z1267 - z1269;
    const Scalar z1273 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z1298 = z1148 * z1297 + z1296;
    const Scalar z1288 = n2 * z1273;
    const Scalar z1272 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z1285 = n2 * z1272;
    const Scalar z1300 = z1149 * z1299 + z1298;
    const Scalar z1312 = n25_over_21 * z1110;
    const Scalar z1311 = z1217 + z1227 * z1301 - z1233 * z1299;
    const Scalar z1320 = z883 * z1236;
    const Scalar z1302 = z1150 * z1301 + z1300;
    const Scalar z1261 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z1303 = n1 / z1302;
    const Scalar z1321 = z1255 * z1301 - z1256 * z1297;
    const Scalar z1263 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z1264 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z1262 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z1329 = z1258 * z1299 - z1259 * z1297;
    const Scalar z1274 = n0_5 * (v_upper_omega_x * z1261 - v_upper_omega_y * z1263 + v_upper_omega_z * z1264);
    const Scalar z1330 = z1303 * z1329;
    const Scalar z1322 = z1303 * z1321;
    const Scalar z1313 = z1303 * z1311;
    const Scalar z1334 = z1295 * z1330;
    const Scalar z1332 = n100000 * z1258 - z1299 * z1330;
    const Scalar z1333 = n100000 * z1259 + z1297 * z1330;
    const Scalar z1324 = z1299 * z1322;
    const Scalar z1326 = z1295 * z1322;
    const Scalar z1327 = z1293 * z1322;
    const Scalar z1323 = n100000 * z1255 - z1301 * z1322;
    const Scalar z1325 = n100000 * z1256 + z1297 * z1322;
    const Scalar z1328 = z1291 * z1322;
    const Scalar z1315 = n100000 * z1233 + z1299 * z1313;
    const Scalar z1316 = z1297 * z1313;
    const Scalar z1317 = z1295 * z1313;
    const Scalar z1318 = z1293 * z1313;
    const Scalar z1314 = n100000 * z1227 - z1301 * z1313;
    const Scalar z1319 = z1291 * z1313;
    const Scalar z1304 = z1194 * z1303;
    const Scalar z1305 = z1301 * z1304;
    const Scalar z1306 = z1299 * z1304;
    const Scalar z1308 = z1295 * z1304;
    const Scalar z1309 = z1293 * z1304;
    const Scalar z1278 = n0_5 * (v_upper_omega_x * z1263 + v_upper_omega_y * z1261 - v_upper_omega_z * z1262);
    const Scalar z1279 = n0_5 * (v_upper_omega_x * z1264 - v_upper_omega_y * z1262 - v_upper_omega_z * z1261);
    const Scalar z1276 = n4 * z1261;
    const Scalar z1307 = z1297 * z1304;
    const Scalar z1310 = z1291 * z1304;
    const Scalar z1275 = n0_5 * (v_upper_omega_x * z1262 + v_upper_omega_y * z1264 + v_upper_omega_z * z1263);
    const Scalar z1280 = n4 * z1263;
    const Scalar z1335 = z1293 * z1330;
    const Scalar z1336 = z1291 * z1330;
    const Scalar z1277 = z1262 * z1276 + n2 * (q_upper_y * z1274 + q_upper_z * z1275);
    const Scalar z1282 = z1262 * z1280 + n2 * (q_upper_z * z1279 + q_upper_x * z1274);
    const Scalar z1281 = z1264 * z1280 + n2 * (q_upper_x * z1278 + q_upper_w * z1279);
    const Scalar z1283 = z1264 * z1276 + n2 * (q_upper_y * z1278 + q_upper_w * z1275);
    const Scalar z1286 = z1277 + z1281;
    const Scalar z1289 = z1282 - z1283;
    const Scalar z1353 = z1194 * z1304;
    const Scalar z1345 = z1287 * z1293 - z1288 * z1291;
    const Scalar z1346 = z1303 * z1345;
    const Scalar z1337 = z1284 * z1295 - z1285 * z1291;
    const Scalar z1338 = z1303 * z1337;
    const Scalar z1366 = z1284 * z1334 - z1285 * z1336;
    const Scalar z1351 = n100000 * z1287 - z1293 * z1346;
    const Scalar z1343 = z1293 * z1338;
    const Scalar z1352 = n100000 * z1288 + z1291 * z1346;
    const Scalar z1344 = n100000 * z1285 + z1291 * z1338;
    const Scalar z1373 = z1287 * z1351 + z1288 * z1352;
    const Scalar z1342 = n100000 * z1284 - z1295 * z1338;
    const Scalar z1350 = z1295 * z1346;
    const Scalar z1372 = z1287 * z1343 - z1288 * z1344;
    const Scalar z1374 = n1 / z1373;
    const Scalar z1367 = z1284 * z1342 + z1285 * z1344;
    const Scalar z1371 = z1287 * z1335 - z1288 * z1336;
    const Scalar z1362 = z1258 * z1332 + z1259 * z1333;
    const Scalar z1361 = z1258 * z1324 - z1259 * z1325;
    const Scalar z1365 = z1284 * z1326 - z1285 * z1328;
    const Scalar z1370 = z1287 * z1327 - z1288 * z1328;
    const Scalar z1358 = z1255 * z1323 + z1256 * z1325;
    const Scalar z1357 = z1256 * z1316 + z1255 * z1314;
    const Scalar z1360 = z1258 * z1315 - z1259 * z1316;
    const Scalar z1379 = z1372 * z1374;
    const Scalar z1378 = z1371 * z1374;
    const Scalar z1377 = z1370 * z1374;
    const Scalar z1364 = z1284 * z1317 - z1285 * z1319;
    const Scalar z1388 = z1361 + z1370 * z1378;
    const Scalar z1389 = z1362 - z1371 * z1378;
    const Scalar z1385 = z1358 - z1370 * z1377;
    const Scalar z1369 = z1287 * z1318 - z1288 * z1319;
    const Scalar z1384 = z1357 - z1369 * z1377;
    const Scalar z1387 = z1360 + z1369 * z1378;
    const Scalar z1355 = z1110 * z1312 + z1236 * z1320 - z1217 * z1313 + z1227 * z1314 + z1233 * z1315;
    const Scalar z1354 = z1217 * z1304 + z1227 * z1305 - z1233 * z1306;
    const Scalar z1376 = z1369 * z1374;
    const Scalar z1382 = z1355 - z1369 * z1376;
    const Scalar z1356 = z1255 * z1305 - z1256 * z1307;
    const Scalar z1359 = z1258 * z1306 - z1259 * z1307;
    const Scalar z1363 = z1284 * z1308 - z1285 * z1310;
    const Scalar z1368 = z1287 * z1309 - z1288 * z1310;
    const Scalar z1381 = z1354 + z1368 * z1376;
    const Scalar z1383 = z1356 + z1368 * z1377;
    const Scalar z1386 = z1359 + z1368 * z1378;
    const Scalar z1390 = z1363 + z1368 * z1379;
    const Scalar z1375 = z1368 * z1374;
    const Scalar z1380 = z1353 + z1368 * z1375;
    const Scalar z1331 = z1301 * z1330;
    const Scalar z1393 = z1366 + z1371 * z1379;
    const Scalar z1392 = z1365 + z1370 * z1379;
    const Scalar z1391 = z1364 + z1369 * z1379;
    const Scalar z1394 = z1367 - z1372 * z1379;
    const Scalar z1395 = n1 / z1394;
    const Scalar z1339 = z1301 * z1338;
    const Scalar z1347 = z1301 * z1346;
    const Scalar z1340 = z1299 * z1338;
    const Scalar z1348 = z1299 * z1346;
    const Scalar z1341 = z1297 * z1338;
    const Scalar z1349 = z1297 * z1346;
    const Scalar z1454 = z1353 - z1355;
    const Scalar z1455 = n4096 * z1454;
    const Scalar z1430 = n25_over_21 * z1192;
    const Scalar z1431 = n100000 * z1186;
    const Scalar z1432 = n100000 * z1187;
    const Scalar z1433 = n100000 * z1188;
    const Scalar z1439 = z1255 * z1431 - z1257 - z1256 * z1433;
    const Scalar z1440 = z1260 + z1259 * z1433 + z1258 * z1432;
    const Scalar z1434 = n100000 * z1179;
    const Scalar z1436 = n100000 * z1181;
    const Scalar z1441 = z1284 * z1434 - z1286 - z1285 * z1436;
    const Scalar z1437 = z883 * z1290;
    const Scalar z1438 = z1110 * z1430 - z1227 * z1431 - z1233 * z1432 + z1236 * z1437 + z1254;
    const Scalar z1435 = n100000 * z1180;
    const Scalar z1442 = z1289 + z1288 * z1436 + z1287 * z1435;
    const Scalar z1399 = z1393 * z1395;
    const Scalar z1409 = z1389 - z1393 * z1399;
    const Scalar z1408 = z1388 + z1392 * z1399;
    const Scalar z1407 = z1387 + z1391 * z1399;
    const Scalar z1406 = z1386 + z1390 * z1399;
    const Scalar z1410 = n1 / z1409;
    const Scalar z1443 = z1379 * z1442 - z1441;
    const Scalar z1444 = z1440 + z1378 * z1442 + z1399 * z1443;
    const Scalar z1398 = z1392 * z1395;
    const Scalar z1405 = z1385 - z1392 * z1398;
    const Scalar z1404 = z1384 - z1391 * z1398;
    const Scalar z1403 = z1383 + z1390 * z1398;
    const Scalar z1397 = z1391 * z1395;
    const Scalar z1402 = z1382 - z1391 * z1397;
    const Scalar z1401 = z1381 + z1390 * z1397;
    const Scalar z1396 = z1390 * z1395;
    const Scalar z1456 = z1358 + z1362 + z1367 + z1373;
    const Scalar z1400 = z1380 + z1390 * z1396;
    const Scalar z1457 = n4096 * z1456;
    const Scalar z1413 = z1408 * z1410;
    const Scalar z1412 = z1407 * z1410;
    const Scalar z1411 = z1406 * z1410;
    const Scalar z1414 = z1400 + z1406 * z1411;
    const Scalar z1415 = z1401 + z1406 * z1412;
    const Scalar z1419 = z1405 - z1408 * z1413;
    const Scalar z1417 = z1403 + z1406 * z1413;
    const Scalar z1418 = z1404 - z1407 * z1413;
    const Scalar z1416 = z1402 - z1407 * z1412;
    const Scalar z1420 = n1 / z1419;
    const Scalar z1445 = z1377 * z1442 - z1439 + z1398 * z1443 + z1413 * z1444;
    const Scalar z1421 = z1417 * z1420;
    const Scalar z1422 = z1418 * z1420;
    const Scalar z1423 = z1414 + z1417 * z1421;
    const Scalar z1424 = z1415 - z1417 * z1422;
    const Scalar z1425 = z1416 - z1418 * z1422;
    const Scalar z1446 = z1438 + z1376 * z1442 + z1397 * z1443 + z1412 * z1444 - z1422 * z1445;
    const Scalar z1426 = n1 / z1425;
    const Scalar z1427 = z1424 * z1426;
    const Scalar z1428 = z1423 + z1424 * z1427;
    const Scalar z1447 = z1198 + z1375 * z1442 + z1396 * z1443 + z1411 * z1444 + z1421 * z1445 + z1427 * z1446;
    const Scalar z1429 = n1 / z1428;
    const Scalar z1448 = z1429 * z1447;
    const Scalar z1449 = z1426 * z1446 - z1427 * z1448;
    const Scalar z1450 = z1420 * z1445 - z1421 * z1448 - z1422 * z1449;
    const Scalar z1458 = z1312 * z1449 - z1430;
    const Scalar z1466 = z1320 * z1449 - z1437;
    const Scalar z1451 = z1410 * z1444 - z1411 * z1448 + z1412 * z1449 + z1413 * z1450;
    const Scalar z1452 = z1395 * z1443 - z1396 * z1448 + z1397 * z1449 + z1398 * z1450 + z1399 * z1451;
    const Scalar z1453 = z1374 * z1442 - z1375 * z1448 + z1376 * z1449 + z1377 * z1450 + z1378 * z1451 + z1379 * z1452;
    const Scalar z1459 = z1304 * z1448 - z1313 * z1449 - z1322 * z1450 - z1330 * z1451 - z1338 * z1452 - z1346 * z1453;
    const Scalar z1460 = z1431 + z1305 * z1448 + z1314 * z1449 + z1323 * z1450 - z1331 * z1451 - z1339 * z1452 - z1347
        * z1453;
    const Scalar z1461 = z1306 * z1448 - z1432 - z1315 * z1449 - z1324 * z1450 + z1332 * z1451 - z1340 * z1452 - z1348
        * z1453;
    const Scalar z1462 = z1433 + z1307 * z1448 - z1316 * z1449 - z1325 * z1450 - z1333 * z1451 - z1341 * z1452 - z1349
        * z1453;
    const Scalar z1463 = z1434 + z1308 * z1448 - z1317 * z1449 - z1326 * z1450 - z1334 * z1451 + z1342 * z1452 - z1350
        * z1453;
    const Scalar z1464 = z1309 * z1448 - z1435 - z1318 * z1449 - z1327 * z1450 - z1335 * z1451 - z1343 * z1452 + z1351
        * z1453;
    const Scalar z1465 = z1436 + z1310 * z1448 - z1319 * z1449 - z1328 * z1450 - z1336 * z1451 - z1344 * z1452 - z1352
        * z1453;
    accelerations.a_z = z1458;
    accelerations.a = z1459;
    accelerations.lower_omega_x = -z1460;
    accelerations.lower_omega_y = -z1461;
    accelerations.lower_omega_z = -z1462;
    accelerations.upper_omega_x = -z1463;
    accelerations.upper_omega_y = -z1464;
    accelerations.upper_omega_z = -z1465;
    accelerations.omega_z = -z1466;
    multipliers.lambda_L2_y = -z1448;
    multipliers.lambda_L2_z = n0;
    multipliers.lambda_L2_ry = n0;
    multipliers.lambda_L2_rz = n0;
    multipliers.lambda_L3_z = -z1449;
    multipliers.lambda_L3_rx = -z1450;
    multipliers.lambda_L3_ry = z1451;
    multipliers.lambda_L5_z = n0;
    multipliers.lambda_L5_rx = -z1452;
    multipliers.lambda_L5_ry = z1453;
    if (!(traits::regular(-z1302, z1153) && traits::regular(z281, z281) && traits::regular(-z1428, -z1455)
        && traits::regular(z1425, -z1455) && traits::regular(z1419, z1457) && traits::regular(z1409, z1457)
        && traits::regular(z1394, z1457) && traits::regular(z1373, z1457))) return torsor::Status::singular;
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
    const Scalar z1483 = n2 * q_lower_y;
    const Scalar z1501 = n2 * q_upper_y;
    const Scalar z1485 = n2 * q_lower_z;
    const Scalar z1490 = n2 * q_lower_x;
    const Scalar z1503 = n2 * q_upper_z;
    const Scalar z1508 = n2 * q_upper_x;
    const Scalar z1484 = q_lower_y * z1483;
    const Scalar z1502 = q_upper_y * z1501;
    const Scalar z1486 = q_lower_z * z1485;
    const Scalar z1492 = q_lower_z * z1483;
    const Scalar z1493 = q_lower_w * z1490;
    const Scalar z1497 = q_lower_x * z1485;
    const Scalar z1498 = q_lower_w * z1483;
    const Scalar z1504 = q_upper_z * z1503;
    const Scalar z1510 = q_upper_z * z1501;
    const Scalar z1511 = q_upper_w * z1508;
    const Scalar z1515 = q_upper_x * z1503;
    const Scalar z1516 = q_upper_w * z1501;
    const Scalar z1491 = q_lower_x * z1490;
    const Scalar z1509 = q_upper_x * z1508;
    const Scalar z1487 = q_lower_x * z1483;
    const Scalar z1488 = q_lower_w * z1485;
    const Scalar z1495 = z1492 - z1493;
    const Scalar z1496 = z1492 + z1493;
    const Scalar z1500 = z1497 - z1498;
    const Scalar z1505 = q_upper_x * z1501;
    const Scalar z1506 = q_upper_w * z1503;
    const Scalar z1513 = z1510 - z1511;
    const Scalar z1514 = z1510 + z1511;
    const Scalar z1518 = z1515 - z1516;
    const Scalar z1519 = n0_1 * v_a;
    const Scalar z1499 = n1 - z1484 - z1491;
    const Scalar z1517 = n1 - z1502 - z1509;
    const Scalar z1489 = z1487 + z1488;
    const Scalar z1494 = n1 - z1486 - z1491;
    const Scalar z1507 = z1505 + z1506;
    const Scalar z1512 = n1 - z1504 - z1509;
    const Scalar z1520 = v_a * z1500;
    const Scalar z1521 = v_a * z1496;
    const Scalar z1522 = v_a * z1499;
    const Scalar z1526 = v_a * z1518;
    const Scalar z1527 = v_a * z1514;
    const Scalar z1528 = v_a * z1517;
    const Scalar z1523 = v_lower_omega_x + z1520;
    const Scalar z1524 = v_lower_omega_y + z1521;
    const Scalar z1525 = v_lower_omega_z + z1522;
    const Scalar z1529 = v_upper_omega_x + z1526;
    const Scalar z1530 = v_upper_omega_y + z1527;
    const Scalar z1531 = v_upper_omega_z + z1528;
    const Scalar z1532 = n0_002 * q_omega_z / pi;
    const Scalar z1533 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z1534 = n0_0005 * v_omega_z;
    const Scalar z1535 = v_a_z * z1500 + z1489 * z1519;
    const Scalar z1536 = v_a_z * z1496 + z1494 * z1519;
    const Scalar z1537 = z1495 * z1519 + v_a_z * z1499;
    const Scalar z1538 = v_a_z * z1518 + z1507 * z1519;
    const Scalar z1539 = v_a_z * z1514 + z1512 * z1519;
    const Scalar z1540 = z1513 * z1519 + v_a_z * z1517;
    result.kinetic = n0_4 * v_a_z * v_a_z + n0_005 * v_a * v_a + k7 * v_omega_z * v_omega_z + n0_15 * z1533 * z1533 + k9
        * (z1523 * z1523 + z1524 * z1524 + z1525 * z1525 + z1529 * z1529 + z1530 * z1530 + z1531 * z1531) + n0_01
        * (z1535 * z1535 + z1536 * z1536 + z1537 * z1537 + z1538 * z1538 + z1539 * z1539 + z1540 * z1540);
    result.force_function = -q_a_z * (n8_2404 + n10000 * q_a_z) - n2_943 * z1532;
    result.power = v_omega_z * (u_C - z1534);
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
    const Scalar z68 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1622 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w
        * v_lower_omega_y);
    const Scalar z1625 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w
        * v_lower_omega_x);
    const Scalar z1623 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w
        * v_lower_omega_z);
    const Scalar z1626 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x
        * v_lower_omega_x);
    const Scalar z1577 = n2 * q_lower_y;
    const Scalar z1590 = n2 * q_upper_y;
    const Scalar z1578 = q_lower_y * z1577;
    const Scalar z1579 = n2 * q_lower_x;
    const Scalar z1591 = q_upper_y * z1590;
    const Scalar z1592 = n2 * q_upper_x;
    const Scalar z1580 = q_lower_x * z1579;
    const Scalar z1593 = q_upper_x * z1592;
    const Scalar z1607 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z1587 = n1 - z1578 - z1580;
    const Scalar z1600 = n1 - z1591 - z1593;
    const Scalar z1604 = n0_1 * s_a;
    const Scalar z1606 = n0_002 * q_omega_z / pi;
    const Scalar z1630 = n4 * q_lower_y * z1622;
    const Scalar z1631 = n4 * q_lower_x * z1625;
    const Scalar z1633 = v_a_z - z1607;
    const Scalar z1620 = q_a_z - z1606;
    const Scalar z1632 = z1630 + z1631;
    const Scalar z1603 = n0_1 * c_a;
    const Scalar z1624 = n2 * (q_lower_y * z1623 - q_lower_z * z1622);
    const Scalar z1627 = n2 * (q_lower_x * z1626 - q_lower_w * z1625);
    const Scalar z1614 = v_a * s_a;
    const Scalar z1628 = z1624 - z1627;
    const Scalar z1581 = q_lower_z * z1577;
    const Scalar z1586 = q_lower_w * z1577;
    const Scalar z1609 = n0_2 * s_a;
    const Scalar z1582 = q_lower_w * z1579;
    const Scalar z1585 = q_lower_z * z1579;
    const Scalar z1594 = q_upper_z * z1590;
    const Scalar z1599 = q_upper_w * z1590;
    const Scalar z1595 = q_upper_w * z1592;
    const Scalar z1598 = q_upper_z * z1592;
    const Scalar z1612 = v_a * c_a;
    const Scalar z1640 = q_lower_y * q_lower_y;
    const Scalar z1642 = q_lower_x * q_lower_x;
    const Scalar z1583 = z1581 - z1582;
    const Scalar z1584 = z1581 + z1582;
    const Scalar z1645 = q_lower_y * q_lower_x;
    const Scalar z1596 = z1594 - z1595;
    const Scalar z1597 = z1594 + z1595;
    const Scalar z1588 = z1585 - z1586;
    const Scalar z1589 = z1585 + z1586;
    const Scalar z1657 = z68 * z1587;
    const Scalar z1660 = n0_5 * (v_lower_omega_x * z1622 - v_lower_omega_y * z1625 + v_lower_omega_z * z1626);
    const Scalar z1601 = z1598 - z1599;
    const Scalar z1602 = z1598 + z1599;
    const Scalar z1664 = n0_5 * (v_lower_omega_x * z1625 + v_lower_omega_y * z1622 - v_lower_omega_z * z1623);
    const Scalar z1661 = n0_5 * (v_lower_omega_x * z1623 + v_lower_omega_y * z1626 + v_lower_omega_z * z1625);
    const Scalar z1613 = n0_2 * z1612;
    const Scalar z1617 = n0_2 * z1614;
    const Scalar z1639 = z1583 * z1603 + z1589 * z1604;
    const Scalar z1662 = n4 * z1622;
    const Scalar z1663 = z1623 * z1662 + n2 * (q_lower_y * z1660 + q_lower_z * z1661);
    const Scalar z1605 = n0_1 - z1603;  // place of lower_omega_x, x
    const Scalar z1621 = z1587 * z1620 + z1583 * z1604 + z1589 * z1605;
    const Scalar z1665 = n0_5 * (v_lower_omega_x * z1626 - v_lower_omega_y * z1623 - v_lower_omega_z * z1622);
    const Scalar z1666 = n4 * z1625;
    const Scalar z1667 = z1626 * z1666 + n2 * (q_lower_x * z1664 + q_lower_w * z1665);
    const Scalar z1615 = v_a * z1614;
    const Scalar z1637 = n0_1 * z1614;
    const Scalar z1616 = n0_2 * z1615;
    const Scalar z1658 = n0_1 * z1615;
    const Scalar z1629 = n0_1 * z1612;
    const Scalar z1618 = v_a * z1612;
    const Scalar z1619 = n0_2 * z1618;
    const Scalar z1659 = n0_1 * z1618;
    const Scalar z1634 = n2 * (q_lower_z * z1625 - q_lower_x * z1623);
    const Scalar z1635 = n2 * (q_lower_y * z1626 - q_lower_w * z1622);
    const Scalar z1641 = q_lower_z * q_lower_z - z1640;
    const Scalar z1652 = q_lower_w * q_lower_w - z1640;
    const Scalar z1643 = q_lower_w * q_lower_w - z1642;
    const Scalar z1651 = q_lower_z * q_lower_z - z1642;
    const Scalar z1649 = q_lower_z * q_lower_w + z1645;
    const Scalar z1650 = n2 * z1649;
    const Scalar z1646 = q_lower_z * q_lower_w - z1645;
    const Scalar z1647 = n2 * z1646;
    const Scalar z1636 = z1634 - z1635;
    const Scalar z1638 = z1587 * z1633 - z1620 * z1632 - z1604 * z1628 + z1583 * z1629 + z1589 * z1637 + z1605 * z1636;
    const Scalar z1644 = z1641 - z1643;
    const Scalar z1648 = z1584 * z1620 - z1604 * z1644 - z1605 * z1647;
    const Scalar z1608 = n0_2 * c_a;
    const Scalar z1669 = z1623 * z1666 + n2 * (q_lower_z * z1665 + q_lower_x * z1660);
    const Scalar z1610 = n0_1 - z1608;
    const Scalar z1670 = z1626 * z1662 + n2 * (q_lower_y * z1664 + q_lower_w * z1661);
    const Scalar z1611 = n0_1 + z1610;
    const Scalar z1676 = z1624 + z1627;
    const Scalar z1677 = z1641 + z1643;
    const Scalar z1680 = z1634 + z1635;
    const Scalar z1672 = n4 * (q_lower_y * z1661 - z1622 * z1622);
    const Scalar z1673 = n4 * (q_lower_x * z1665 - z1625 * z1625);
    const Scalar z1674 = z1672 + z1673;
    const Scalar z1699 = z1596 * z1603 + z1602 * z1604;
    const Scalar z1679 = z1663 + z1667;
    const Scalar z1668 = z1663 - z1667;
    const Scalar z1681 = z1651 + z1652;
    const Scalar z1653 = z1651 - z1652;
    const Scalar z1654 = z1588 * z1620 + z1604 * z1650 - z1605 * z1653;
    const Scalar z1683 = z1669 - z1670;
    const Scalar z1671 = z1669 + z1670;
    const Scalar z1675 = z1604 * z1668 - z1620 * z1674 + z1605 * z1671 + z1583 * z1658 - z1589 * z1659 + n2 * (z1632
        * z1633 + z1628 * z1629 - z1636 * z1637);
    const Scalar z1685 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z1688 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z1686 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z1689 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z1692 = n4 * q_upper_y * z1685;
    const Scalar z1693 = n4 * q_upper_x * z1688;
    const Scalar z1694 = z1692 + z1693;
    const Scalar z1687 = n2 * (q_upper_y * z1686 - q_upper_z * z1685);
    const Scalar z1690 = n2 * (q_upper_x * z1689 - q_upper_w * z1688);
    const Scalar z1684 = z1600 * z1620 + z1596 * z1604 + z1602 * z1605;
    const Scalar z1700 = q_upper_y * q_upper_y;
    const Scalar z1702 = q_upper_x * q_upper_x;
    const Scalar z1691 = z1687 - z1690;
    const Scalar z1705 = q_upper_y * q_upper_x;
    const Scalar z1695 = n2 * (q_upper_z * z1688 - q_upper_x * z1686);
    const Scalar z1696 = n2 * (q_upper_y * z1689 - q_upper_w * z1685);
    const Scalar z1701 = q_upper_z * q_upper_z - z1700;
    const Scalar z1712 = q_upper_w * q_upper_w - z1700;
    const Scalar z1703 = q_upper_w * q_upper_w - z1702;
    const Scalar z1711 = q_upper_z * q_upper_z - z1702;
    const Scalar z1709 = q_upper_z * q_upper_w + z1705;
    const Scalar z1710 = n2 * z1709;
    const Scalar z1706 = q_upper_z * q_upper_w - z1705;
    const Scalar z1707 = n2 * z1706;
    const Scalar z1697 = z1695 - z1696;
    const Scalar z1698 = z1600 * z1633 - z1620 * z1694 - z1604 * z1691 + z1596 * z1629 + z1602 * z1637 + z1605 * z1697;
    const Scalar z1704 = z1701 - z1703;
    const Scalar z1708 = z1597 * z1620 - z1604 * z1704 - z1605 * z1707;
    const Scalar z1713 = z1711 - z1712;
    const Scalar z1714 = z1601 * z1620 + z1604 * z1710 - z1605 * z1713;
    const Scalar z1655 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z1678 = n2 * z1655;
    const Scalar z1656 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z1734 = z1687 + z1690;
    const Scalar z1735 = z1701 + z1703;
    const Scalar z1738 = z1695 + z1696;
    const Scalar z1739 = z1711 + z1712;
    const Scalar z1718 = n0_5 * (v_upper_omega_x * z1685 - v_upper_omega_y * z1688 + v_upper_omega_z * z1689);
    const Scalar z1682 = n2 * z1656;
    const Scalar z1722 = n0_5 * (v_upper_omega_x * z1688 + v_upper_omega_y * z1685 - v_upper_omega_z * z1686);
    const Scalar z1717 = z68 * z1600;
    const Scalar z1719 = n0_5 * (v_upper_omega_x * z1686 + v_upper_omega_y * z1689 + v_upper_omega_z * z1688);
    const Scalar z1723 = n0_5 * (v_upper_omega_x * z1689 - v_upper_omega_y * z1686 - v_upper_omega_z * z1685);
    const Scalar z1720 = n4 * z1685;
    const Scalar z1730 = n4 * (q_upper_y * z1719 - z1685 * z1685);
    const Scalar z1724 = n4 * z1688;
    const Scalar z1731 = n4 * (q_upper_x * z1723 - z1688 * z1688);
    const Scalar z1721 = z1686 * z1720 + n2 * (q_upper_y * z1718 + q_upper_z * z1719);
    const Scalar z1727 = z1686 * z1724 + n2 * (q_upper_z * z1723 + q_upper_x * z1718);
    const Scalar z1725 = z1689 * z1724 + n2 * (q_upper_x * z1722 + q_upper_w * z1723);
    const Scalar z1728 = z1689 * z1720 + n2 * (q_upper_y * z1722 + q_upper_w * z1719);
    const Scalar z1726 = z1721 - z1725;
    const Scalar z1737 = z1721 + z1725;
    const Scalar z1732 = z1730 + z1731;
    const Scalar z1729 = z1727 + z1728;
    const Scalar z1715 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z1716 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z1733 = z1604 * z1726 - z1620 * z1732 + z1605 * z1729 + z1596 * z1658 - z1602 * z1659 + n2 * (z1633
        * z1694 + z1629 * z1691 - z1637 * z1697);
    const Scalar z1736 = n2 * z1715;
    const Scalar z1740 = n2 * z1716;
    const Scalar z1741 = z1727 - z1728;
    result.value[0] = z1609;
    result.rate[0] = z1613;
    result.gamma[0] = -z1616;
    result.value[1] = z1611;
    result.rate[1] = z1617;
    result.gamma[1] = z1619;
    result.value[2] = n0;
    result.rate[2] = n0;
    result.gamma[2] = n0;
    result.value[3] = n0;
    result.rate[3] = n0;
    result.gamma[3] = n0;
    result.value[4] = -z1621;
    result.rate[4] = -z1638;
    result.gamma[4] = z1675;
    result.value[5] = -z1584;
    result.rate[5] = z1676;
    result.gamma[5] = z1679;
    result.value[6] = z1588;
    result.rate[6] = z1680;
    result.gamma[6] = -z1683;
    result.value[7] = -z1684;
    result.rate[7] = -z1698;
    result.gamma[7] = z1733;
    result.value[8] = -z1597;
    result.rate[8] = z1734;
    result.gamma[8] = z1737;
    result.value[9] = z1601;
    result.rate[9] = z1738;
    result.gamma[9] = -z1741;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = -z1587;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = -z1600;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = z1608;
    result.jacobian[11] = z1609;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = -z1639;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = -z1699;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = n0;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = z1648;
    result.jacobian[25] = -z1677;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = -z1654;
    result.jacobian[35] = n0;
    result.jacobian[36] = -z1681;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = -z1678;
    result.jacobian[46] = z1682;
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
    result.jacobian[57] = z1708;
    result.jacobian[58] = -z1735;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n0;
    result.jacobian[67] = -z1714;
    result.jacobian[68] = n0;
    result.jacobian[69] = -z1739;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n0;
    result.jacobian[77] = n0;
    result.jacobian[78] = -z1736;
    result.jacobian[79] = z1740;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = z1657;
    result.jacobian[85] = n0;
    result.jacobian[86] = n0;
    result.jacobian[87] = z1717;
    result.jacobian[88] = n0;
    result.jacobian[89] = n0;
  }
};

}  // namespace model_making_press
