// SPDX-License-Identifier: MIT
// four_wheel_vehicle: Four-wheel vehicle whose wheels roll without slipping
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               32               51          0             0                  5       0     93      95
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                4          0             0                  0       0      4       4
//   inverse_dynamics         36               38          0             0                  1       0     76      83
//   forward_dynamics         68               97          0             0                  1       0    167     174
//   energy                   40               68          0             0                  5       0    118     142
//   constraints              32               49          0             0                  1       0     83      88
//
// Not computed because this mechanism does not need it:
//   kinematics: of 198 results 91 vanish identically, 30 repeat another up to sign
//   mass_matrix: of 49 results 42 vanish identically
//   bias: of 7 results 3 vanish identically
//   forward_dynamics: of 15 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 80 results 36 vanish identically, 13 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: wheel_3_x, wheel_4_x.
//   Indeterminate, as they are shared with those in a way that no motion tells: lambda_wheel_1_x, lambda_wheel_2_x.
//
// To write this file again:
//   four_wheel_vehicle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output four_wheel_vehicle.hpp
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

namespace four_wheel_vehicle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x023380f3439c94a2ULL;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 2;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 8;
  static constexpr int first_integral_count = 0;
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 2;
  static constexpr int redundant_multipliers[] = {4, 6};

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar phi_1;  ///< coordinate [rad or 1]
    Scalar phi_2;  ///< coordinate [rad or 1]
    Scalar phi_3;  ///< coordinate [rad or 1]
    Scalar phi_4;  ///< coordinate [rad or 1]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar phi_1;  ///< its rate [rad/s]
    Scalar phi_2;  ///< its rate [rad/s]
    Scalar phi_3;  ///< its rate [rad/s]
    Scalar phi_4;  ///< its rate [rad/s]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar phi_1;  ///< its second rate [rad/s^2]
    Scalar phi_2;  ///< its second rate [rad/s^2]
    Scalar phi_3;  ///< its second rate [rad/s^2]
    Scalar phi_4;  ///< its second rate [rad/s^2]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar phi_1;  ///< works with the rate of phi_1 [N m]
    Scalar phi_2;  ///< works with the rate of phi_2 [N m]
    Scalar phi_3;  ///< works with the rate of phi_3 [N m]
    Scalar phi_4;  ///< works with the rate of phi_4 [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C3;  ///< motor [N m]
    Scalar C4;  ///< motor [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C3, &Inputs::C4};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< indeterminate, of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< indeterminate, of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< indeterminate, of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< indeterminate, of the constraint wheel_4_x [N]
    Scalar lambda_wheel_4_y;  ///< of the constraint wheel_4_y [N]
    static constexpr int size = 8;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_wheel_1_x, &Multipliers::lambda_wheel_1_y,
          &Multipliers::lambda_wheel_2_x, &Multipliers::lambda_wheel_2_y, &Multipliers::lambda_wheel_3_x,
          &Multipliers::lambda_wheel_3_y, &Multipliers::lambda_wheel_4_x, &Multipliers::lambda_wheel_4_y};
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
    const Scalar k2 = traits::constant(2.732050807568877, 2.732051f, "1;0;1;0");
    const Scalar k3 = traits::constant(9.428090415820634, 9.42809f, "0;20/3;0;0");
    const Scalar n40_over_3 = traits::constant(13.333333333333334, 13.333333f, "40/3");
    const Scalar k5 = traits::constant(11.547005383792515, 11.547006f, "0;0;20/3;0");
    const Scalar n20_over_3 = traits::constant(6.666666666666667, 6.6666665f, "20/3");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.psi = n0;
    state.q.phi_1 = n0;
    state.q.phi_2 = n0;
    state.q.phi_3 = n0;
    state.q.phi_4 = n0;
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> chassis_position;  ///< centre of mass of chassis [m]
    std::array<Scalar, 9> chassis_rotation;  ///< from the axes of chassis to the ground's (3 x 3)
    std::array<Scalar, 3> chassis_velocity;  ///< velocity of the centre of mass of chassis [m/s]
    std::array<Scalar, 3> chassis_angular_velocity;  ///< angular velocity of chassis [rad/s]
    std::array<Scalar, 3> wheel_1_position;  ///< centre of mass of wheel_1 [m]
    std::array<Scalar, 9> wheel_1_rotation;  ///< from the axes of wheel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_1_velocity;  ///< velocity of the centre of mass of wheel_1 [m/s]
    std::array<Scalar, 3> wheel_1_angular_velocity;  ///< angular velocity of wheel_1 [rad/s]
    std::array<Scalar, 3> wheel_2_position;  ///< centre of mass of wheel_2 [m]
    std::array<Scalar, 9> wheel_2_rotation;  ///< from the axes of wheel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_2_velocity;  ///< velocity of the centre of mass of wheel_2 [m/s]
    std::array<Scalar, 3> wheel_2_angular_velocity;  ///< angular velocity of wheel_2 [rad/s]
    std::array<Scalar, 3> wheel_3_position;  ///< centre of mass of wheel_3 [m]
    std::array<Scalar, 9> wheel_3_rotation;  ///< from the axes of wheel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_3_velocity;  ///< velocity of the centre of mass of wheel_3 [m/s]
    std::array<Scalar, 3> wheel_3_angular_velocity;  ///< angular velocity of wheel_3 [rad/s]
    std::array<Scalar, 3> wheel_4_position;  ///< centre of mass of wheel_4 [m]
    std::array<Scalar, 9> wheel_4_rotation;  ///< from the axes of wheel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_4_velocity;  ///< velocity of the centre of mass of wheel_4 [m/s]
    std::array<Scalar, 3> wheel_4_angular_velocity;  ///< angular velocity of wheel_4 [rad/s]
    std::array<Scalar, 3> P1_position;  ///< position of P1 [m]
    std::array<Scalar, 3> P1_velocity;  ///< velocity of the material point at P1 [m/s]
    std::array<Scalar, 21> P1_jacobian;  ///< partial velocities of P1 (3 x 7)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 21> P2_jacobian;  ///< partial velocities of P2 (3 x 7)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 21> P3_jacobian;  ///< partial velocities of P3 (3 x 7)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 21> P4_jacobian;  ///< partial velocities of P4 (3 x 7)
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
    std::array<Scalar, 8> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 8> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 56> jacobian;  ///< A, stored column by column (8 x 7)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k1 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z0 = k0 * v_psi;
    const Scalar z1 = k1 * (s_psi + c_psi);
    const Scalar z2 = k1 * (s_psi - c_psi);
    const Scalar z3 = s_psi - k0 * c_psi;
    const Scalar z4 = k0 * s_psi + c_psi;
    const Scalar z5 = n0_5 * s_psi + k3 * c_psi;
    const Scalar z6 = k3 * s_psi - n0_5 * c_psi;
    const Scalar z7 = s_psi + k0 * c_psi;
    const Scalar z8 = k0 * s_psi - c_psi;
    const Scalar z9 = v_x - v_psi * c_psi - s_psi * z0;  // velocity of steered_1, x
    const Scalar z10 = v_y - v_psi * s_psi + c_psi * z0;  // velocity of steered_1, y
    const Scalar z11 = v_x - v_psi * c_psi + s_psi * z0;  // velocity of steered_2, x
    const Scalar z12 = v_y - v_psi * s_psi - c_psi * z0;  // velocity of steered_2, y
    const Scalar z13 = v_x + v_psi * c_psi + s_psi * z0;  // velocity of steered_3, x
    const Scalar z14 = v_y + v_psi * s_psi - c_psi * z0;  // velocity of steered_3, y
    const Scalar z15 = s_psi * c_phi_3;
    const Scalar z16 = s_psi * s_phi_3;
    const Scalar z17 = c_psi * c_phi_3;
    const Scalar z18 = c_psi * s_phi_3;
    const Scalar z19 = c_psi * v_phi_3;  // angular velocity of wheel_3, x
    const Scalar z20 = s_psi * v_phi_3;  // angular velocity of wheel_3, y
    const Scalar z21 = v_x + v_psi * c_psi - s_psi * z0;  // velocity of steered_4, x
    const Scalar z22 = v_y + v_psi * s_psi + c_psi * z0;  // velocity of steered_4, y
    const Scalar z23 = s_psi * c_phi_4;
    const Scalar z24 = s_psi * s_phi_4;
    const Scalar z25 = c_psi * c_phi_4;
    const Scalar z26 = c_psi * s_phi_4;
    const Scalar z27 = c_psi * v_phi_4;  // angular velocity of wheel_4, x
    const Scalar z28 = s_psi * v_phi_4;  // angular velocity of wheel_4, y
    const Scalar z29 = q_x - z3;  // place of steered_1, x
    const Scalar z30 = q_y + z4;  // place of steered_1, y
    const Scalar z31 = q_x - z7;  // place of steered_2, x
    const Scalar z32 = q_y - z8;  // place of steered_2, y
    const Scalar z33 = q_x + z3;  // place of steered_3, x
    const Scalar z34 = q_y - z4;  // place of steered_3, y
    const Scalar z35 = q_x + z7;  // place of steered_4, x
    const Scalar z36 = q_y + z8;  // place of steered_4, y
    const Scalar z37 = c_phi_1 * z2;
    const Scalar z38 = s_phi_1 * z2;
    const Scalar z39 = c_phi_1 * z1;
    const Scalar z40 = s_phi_1 * z1;
    const Scalar z41 = v_phi_1 * z1;  // angular velocity of wheel_1, x
    const Scalar z42 = v_phi_1 * z2;  // angular velocity of wheel_1, y
    const Scalar z43 = c_phi_2 * z6;
    const Scalar z44 = s_phi_2 * z6;
    const Scalar z45 = c_phi_2 * z5;
    const Scalar z46 = s_phi_2 * z5;
    const Scalar z47 = v_phi_2 * z5;  // angular velocity of wheel_2, x
    const Scalar z48 = v_phi_2 * z6;  // angular velocity of wheel_2, y
    result.chassis_position[0] = q_x;
    result.chassis_position[1] = q_y;
    result.chassis_position[2] = n0_3;
    result.chassis_rotation[0] = c_psi;
    result.chassis_rotation[1] = s_psi;
    result.chassis_rotation[2] = n0;
    result.chassis_rotation[3] = -s_psi;
    result.chassis_rotation[4] = c_psi;
    result.chassis_rotation[5] = n0;
    result.chassis_rotation[6] = n0;
    result.chassis_rotation[7] = n0;
    result.chassis_rotation[8] = n1;
    result.chassis_velocity[0] = v_x;
    result.chassis_velocity[1] = v_y;
    result.chassis_velocity[2] = n0;
    result.chassis_angular_velocity[0] = n0;
    result.chassis_angular_velocity[1] = n0;
    result.chassis_angular_velocity[2] = v_psi;
    result.wheel_1_position[0] = z29;
    result.wheel_1_position[1] = z30;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z1;
    result.wheel_1_rotation[1] = z2;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z37;
    result.wheel_1_rotation[4] = z39;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z38;
    result.wheel_1_rotation[7] = -z40;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z9;
    result.wheel_1_velocity[1] = z10;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z41;
    result.wheel_1_angular_velocity[1] = z42;
    result.wheel_1_angular_velocity[2] = v_psi;
    result.wheel_2_position[0] = z31;
    result.wheel_2_position[1] = z32;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z5;
    result.wheel_2_rotation[1] = z6;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z43;
    result.wheel_2_rotation[4] = z45;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z44;
    result.wheel_2_rotation[7] = -z46;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = z11;
    result.wheel_2_velocity[1] = z12;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z47;
    result.wheel_2_angular_velocity[1] = z48;
    result.wheel_2_angular_velocity[2] = v_psi;
    result.wheel_3_position[0] = z33;
    result.wheel_3_position[1] = z34;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = c_psi;
    result.wheel_3_rotation[1] = s_psi;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z15;
    result.wheel_3_rotation[4] = z17;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z16;
    result.wheel_3_rotation[7] = -z18;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = z13;
    result.wheel_3_velocity[1] = z14;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z19;
    result.wheel_3_angular_velocity[1] = z20;
    result.wheel_3_angular_velocity[2] = v_psi;
    result.wheel_4_position[0] = z35;
    result.wheel_4_position[1] = z36;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = c_psi;
    result.wheel_4_rotation[1] = s_psi;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z23;
    result.wheel_4_rotation[4] = z25;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z24;
    result.wheel_4_rotation[7] = -z26;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z21;
    result.wheel_4_velocity[1] = z22;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z27;
    result.wheel_4_angular_velocity[1] = z28;
    result.wheel_4_angular_velocity[2] = v_psi;
    result.P1_position[0] = z29;
    result.P1_position[1] = z30;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z9;
    result.P1_velocity[1] = z10;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = -z4;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z3;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P2_position[0] = z31;
    result.P2_position[1] = z32;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = z11;
    result.P2_velocity[1] = z12;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z8;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z7;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P3_position[0] = z33;
    result.P3_position[1] = z34;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = z13;
    result.P3_velocity[1] = z14;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z4;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = z3;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P4_position[0] = z35;
    result.P4_position[1] = z36;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z21;
    result.P4_velocity[1] = z22;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = -z8;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = z7;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 49>& mass) noexcept {
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k2 = traits::constant(1024.8718707889795, 1024.8718f, "1302;0;-160;0");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n880;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k2;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_9;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0_9;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0_9;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z0 = n3 * v_phi_1;
    const Scalar z1 = n3 * v_phi_2;
    const Scalar z2 = n3 * v_phi_3;
    const Scalar z3 = n3 * v_phi_4;
    forces.x = n0;
    forces.y = n0;
    forces.psi = n0;
    forces.phi_1 = z0;
    forces.phi_2 = z1;
    forces.phi_3 = z2;
    forces.phi_4 = z3;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar k2 = traits::constant(1024.8718707889795, 1024.8718f, "1302;0;-160;0");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar k4 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k6 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar k7 = traits::constant(1.224744871391589, 1.2247449f, "0;0;0;1/2");
    const Scalar k8 = traits::constant(0.189468690981506, 0.1894687f, "0;1;0;-1/2");
    const Scalar k9 = traits::constant(1.1339745962155614, 1.1339746f, "2;0;-1/2;0");
    const Scalar k10 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = n3 * v_phi_1;
    const Scalar z1 = n3 * v_phi_2;
    const Scalar z2 = n3 * v_phi_3;
    const Scalar z3 = n3 * v_phi_4;
    const Scalar z4 = n880 * a_x;  // force on S.y, x
    const Scalar z5 = n880 * a_y;  // force on S.y, y
    const Scalar z6 = k2 * a_psi;
    const Scalar z7 = n0_9 * a_phi_1 + z0;
    const Scalar z8 = n0_9 * a_phi_2 + z1;
    const Scalar z9 = n0_9 * a_phi_3 + z2;
    const Scalar z10 = n0_9 * a_phi_4 + z3;
    const Scalar z11 = k4 * (s_psi + c_psi);
    const Scalar z12 = k4 * (s_psi - c_psi);
    const Scalar z13 = n0_5 * s_psi + k6 * c_psi;
    const Scalar z14 = k6 * s_psi - n0_5 * c_psi;
    forces.x = z4 + s_psi * (l_lambda_wheel_3_y + l_lambda_wheel_4_y) - c_psi * (l_lambda_wheel_3_x
        + l_lambda_wheel_4_x) - z11 * l_lambda_wheel_1_x + z12 * l_lambda_wheel_1_y - z13 * l_lambda_wheel_2_x + z14
        * l_lambda_wheel_2_y;
    forces.y = -s_psi * (l_lambda_wheel_3_x + l_lambda_wheel_4_x) + z5 - c_psi * (l_lambda_wheel_3_y
        + l_lambda_wheel_4_y) - z11 * l_lambda_wheel_1_y - z12 * l_lambda_wheel_1_x - z13 * l_lambda_wheel_2_y - z14
        * l_lambda_wheel_2_x;
    forces.psi = k7 * l_lambda_wheel_1_x - l_lambda_wheel_3_x + k8 * l_lambda_wheel_1_y + n0_5 * l_lambda_wheel_2_x + k9
        * l_lambda_wheel_2_y - l_lambda_wheel_4_x + k10 * (l_lambda_wheel_3_y - l_lambda_wheel_4_y) + z6;
    forces.phi_1 = z7 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z8 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z9 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z10 - n0_3 * l_lambda_wheel_4_y;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n10_over_9 = traits::constant(1.1111111111111112, 1.1111112f, "10/9");
    const Scalar k2 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k4 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n1_over_880 = traits::constant(0.0011363636363636363, 0.0011363636f, "1/880");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar k7 = traits::constant(0.006034576682862498, 0.006034577f,
        "-47006191/3371970601;0;38887200/3371970601;0");
    const Scalar k8 = traits::constant(0.0017129626287467768, 0.0017129626f,
        "66184580/3371970601;0;-69753751/6743941202;0");
    const Scalar k9 = traits::constant(0.017638487147502033, 0.017638488f, "-16685/894962;0;1687231/80546580;0");
    const Scalar k10 = traits::constant(0.009102215061268836, 0.009102215f,
        "21236489/6743941202;0;11589820/3371970601;0");
    const Scalar k11 = traits::constant(0.0020210924874408953, 0.0020210925f, "623431/80546580;0;-2955/894962;0");
    const Scalar k12 = traits::constant(0.005455658513429925, 0.0054556583f,
        "89114018400/13518896323201;0;-26603497741/40556688969603;0");
    const Scalar k13 = traits::constant(0.006572896294694327, 0.006572896f,
        "0;136601849/6743941202;0;-30385300/3371970601");
    const Scalar k14 = traits::constant(0.009196082194860185, 0.009196082f, "0;-702269/80546580;0;7865/894962");
    const Scalar k15 = traits::constant(0.01259924664742195, 0.012599247f,
        "0;245195815485/13518896323201;0;-216083377004/40556688969603");
    const Scalar k16 = traits::constant(0.28316279903238994, 0.2831628f,
        "0;25702471/42235382402;0;4867601651/42235382402");
    const Scalar k17 = traits::constant(0.01650954001858063, 0.01650954f,
        "0;105186729/6743941202;0;-7637740/3371970601");
    const Scalar k18 = traits::constant(0.0008008890184089598, 0.00080088904f, "0;350369/80546580;0;-1955/894962");
    const Scalar k19 = traits::constant(0.010379644993220454, 0.010379645f,
        "0;6781705485/13518896323201;0;160111588604/40556688969603");
    const Scalar k20 = traits::constant(1.223495166781618, 1.2234951f,
        "0;10617284129/42235382402;0;14966251291/42235382402");
    const Scalar k21 = traits::constant(0.002482053887386035, 0.0024820538f,
        "966041444/89519463013;0;-429461601/89519463013;0");
    const Scalar k22 = traits::constant(1952.7227294153192, 1952.7228f, "3168704970/2462867;0;2841587660/7388601;0");
    const Scalar k23 = traits::constant(9.897811768073788, 9.897812f,
        "869737739680/89519463013;0;9416037180/89519463013;0");
    const Scalar k24 = traits::constant(730.7739671779823, 730.774f,
        "16040869583970/21117691201;0;-351381498000/21117691201;0");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar k26 = traits::constant(9.76952417527508, 9.769525f,
        "129883377835200/13518896323201;0;1264285440000/13518896323201;0");
    const Scalar k27 = traits::constant(9.837140758022175, 9.837141f, "38852009/4027329;0;49100/447481;0");
    const Scalar k28 = traits::constant(9.836782527565767, 9.836782f,
        "32510763120/3371970601;0;380230400/3371970601;0");
    const Scalar k29 = traits::constant(0.0011950224279731092, 0.0011950224f, "0;20/134867;0;217/539468");
    const Scalar k30 = traits::constant(0.0001848706129827203, 0.00018487062f, "0;177/269734;0;-491/1618404");
    const Scalar k31 = traits::constant(0.0004878658632859967, 0.00048786585f, "217/539468;0;20/404601;0");
    const Scalar k32 = traits::constant(0.0011064549906541887, 0.001106455f, "197/134867;0;-331/1618404;0");
    const Scalar k33 = traits::constant(0.0007142851984076027, 0.0007142852f, "-137/269734;0;571/809202;0");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = v_psi * c_psi;
    const Scalar z1 = v_psi * s_psi;
    const Scalar z2 = n3 * v_phi_3;
    const Scalar z3 = n3 * v_phi_4;
    const Scalar z4 = n3 * v_phi_1;
    const Scalar z5 = n3 * v_phi_2;
    const Scalar z6 = u_C3 - z2;
    const Scalar z7 = u_C4 - z3;
    const Scalar z8 = n10_over_9 * z4;
    const Scalar z9 = n10_over_9 * z5;
    const Scalar z10 = k2 * (s_psi + c_psi);
    const Scalar z11 = n10_over_9 * z6;
    const Scalar z12 = n10_over_9 * z7;
    const Scalar z13 = k2 * (s_psi - c_psi);
    const Scalar z14 = n0_5 * s_psi + k4 * c_psi;
    const Scalar z15 = k4 * s_psi - n0_5 * c_psi;
    const Scalar z16 = n1_over_880 * s_psi;
    const Scalar z17 = n1_over_880 * c_psi;
    const Scalar z18 = k2 * (z0 - z1);
    const Scalar z19 = k2 * (z0 + z1);
    const Scalar z20 = n0_5 * z0 - k4 * z1;
    const Scalar z21 = k4 * z0 + n0_5 * z1;
    const Scalar z22 = v_x * z0 + v_y * z1;
    const Scalar z23 = n1_over_880 * z10;
    const Scalar z24 = n1_over_880 * z13;
    const Scalar z25 = n1_over_880 * z14;
    const Scalar z26 = n1_over_880 * z15;
    const Scalar z27 = v_x * z18 + v_y * z19;
    const Scalar z28 = v_x * z19 - v_y * z18;
    const Scalar z29 = v_x * z20 + v_y * z21;
    const Scalar z30 = v_x * z21 - v_y * z20;
    const Scalar z31 = z22 - n0_3 * z11;
    const Scalar z32 = z22 - n0_3 * z12;
    const Scalar z33 = z31 - k7 * z32;
    const Scalar z34 = z28 + n0_3 * z8;
    const Scalar z35 = z30 + n0_3 * z9;
    const Scalar z36 = z35 - k8 * z32 - k9 * z33;
    const Scalar z37 = z29 - k10 * z32 - k11 * z33 + k12 * z36;
    const Scalar z38 = z34 - k13 * z32 - k14 * z33 - k15 * z36 + k16 * z37;
    const Scalar z39 = z27 - k17 * z32 + k18 * z33 + k19 * z36 - k20 * z37 - k21 * z38;
    const Scalar z40 = k22 * z39;
    const Scalar z41 = k23 * z38 - k21 * z40;
    const Scalar z42 = k24 * z37 - k20 * z40 + k16 * z41;
    const Scalar z43 = z8 - n1_over_3 * z41;
    const Scalar z44 = k26 * z36 + k19 * z40 - k15 * z41 + k12 * z42;
    const Scalar z45 = k27 * z33 + k18 * z40 - k14 * z41 - k11 * z42 - k9 * z44;
    const Scalar z46 = z9 - n1_over_3 * z44;
    const Scalar z47 = k28 * z32 - k17 * z40 - k13 * z41 - k10 * z42 - k8 * z44 - k7 * z45;
    const Scalar z48 = z11 + n1_over_3 * z45;
    const Scalar z49 = z23 * z40 + z24 * z41 + z25 * z42 + z26 * z44 + z16 * (z45 + z47);
    const Scalar z50 = z23 * z41 - z24 * z40 - z26 * z42 + z25 * z44 + z17 * (z45 + z47);
    const Scalar z51 = k29 * z40 - k30 * z41 + k31 * z42 - k32 * z44 - k33 * (z45 - z47);
    const Scalar z52 = z12 + n1_over_3 * z47;
    accelerations.x = -z49;
    accelerations.y = z50;
    accelerations.psi = z51;
    accelerations.phi_1 = -z43;
    accelerations.phi_2 = -z46;
    accelerations.phi_3 = z48;
    accelerations.phi_4 = z52;
    multipliers.lambda_wheel_1_x = -z40;
    multipliers.lambda_wheel_1_y = z41;
    multipliers.lambda_wheel_2_x = -z42;
    multipliers.lambda_wheel_2_y = z44;
    multipliers.lambda_wheel_3_x = n0;
    multipliers.lambda_wheel_3_y = z45;
    multipliers.lambda_wheel_4_x = n0;
    multipliers.lambda_wheel_4_y = z47;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.phi_1
        * accelerations.phi_2 * accelerations.phi_3 * accelerations.phi_4 * multipliers.lambda_wheel_1_x
        * multipliers.lambda_wheel_1_y * multipliers.lambda_wheel_2_x * multipliers.lambda_wheel_2_y
        * multipliers.lambda_wheel_3_y * multipliers.lambda_wheel_4_y;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k2 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar k3 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z0 = v_x * c_psi + v_y * s_psi;
    const Scalar z1 = v_x * s_psi - v_y * c_psi;
    const Scalar z2 = v_psi * s_phi_1;
    const Scalar z3 = v_psi * c_phi_1;
    const Scalar z4 = v_psi * s_phi_2;
    const Scalar z5 = v_psi * c_phi_2;
    const Scalar z6 = v_psi * s_phi_3;
    const Scalar z7 = v_psi * c_phi_3;
    const Scalar z8 = v_psi * s_phi_4;
    const Scalar z9 = v_psi * c_phi_4;
    const Scalar z10 = n3 * v_phi_1;
    const Scalar z11 = n3 * v_phi_2;
    const Scalar z12 = n3 * v_phi_3;
    const Scalar z13 = n3 * v_phi_4;
    const Scalar z14 = v_psi - z0;
    const Scalar z15 = k1 * v_psi - z1;
    const Scalar z16 = k1 * v_psi + z1;
    const Scalar z17 = v_psi + z0;
    const Scalar z18 = k2 * (z14 + z15);
    const Scalar z19 = k2 * (z14 - z15);
    const Scalar z20 = k3 * z14 - n0_5 * z16;
    const Scalar z21 = n0_5 * z14 + k3 * z16;
    const Scalar z22 = c_phi_3 * z16;
    const Scalar z23 = s_phi_3 * z16;
    const Scalar z24 = c_phi_4 * z15;
    const Scalar z25 = s_phi_4 * z15;
    const Scalar z26 = c_phi_1 * z19;
    const Scalar z27 = s_phi_1 * z19;
    const Scalar z28 = c_phi_2 * z21;
    const Scalar z29 = s_phi_2 * z21;
    result.kinetic = n450 * v_psi * v_psi + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3 * v_phi_3 + v_phi_4
        * v_phi_4) + n20 * z17 * z17 + n400 * (z0 * z0 + z1 * z1) + n0_25 * (z2 * z2 + z3 * z3 + z4 * z4 + z5 * z5 + z6
        * z6 + z7 * z7 + z8 * z8 + z9 * z9) + n10 * (z22 * z22 + z23 * z23 + z24 * z24 + z25 * z25 + z18 * z18 + z20
        * z20 + z26 * z26 + z27 * z27 + z28 * z28 + z29 * z29);
    result.force_function = n0;
    result.power = -v_phi_1 * z10 + v_phi_3 * (u_C3 - z12) + v_phi_4 * (u_C4 - z13) - v_phi_2 * z11;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar k0 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar k4 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k5 = traits::constant(1.224744871391589, 1.2247449f, "0;0;0;1/2");
    const Scalar k6 = traits::constant(0.189468690981506, 0.1894687f, "0;1;0;-1/2");
    const Scalar k7 = traits::constant(1.1339745962155614, 1.1339746f, "2;0;-1/2;0");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = v_psi * c_psi;
    const Scalar z1 = v_psi * s_psi;
    const Scalar z2 = k0 * (s_psi + c_psi);
    const Scalar z3 = n0_5 * s_psi + k2 * c_psi;
    const Scalar z4 = k0 * (s_psi - c_psi);
    const Scalar z5 = k2 * s_psi - n0_5 * c_psi;
    const Scalar z6 = v_x * s_psi;
    const Scalar z7 = v_psi + v_x * c_psi + v_y * s_psi;
    const Scalar z8 = k0 * (z0 - z1);
    const Scalar z9 = k0 * (z0 + z1);
    const Scalar z10 = n0_5 * z0 - k2 * z1;
    const Scalar z11 = k2 * z0 + n0_5 * z1;
    const Scalar z12 = v_x * z1 - v_y * z0;
    const Scalar z13 = n0_3 * v_phi_3 - k4 * v_psi + v_y * c_psi - z6;
    const Scalar z14 = v_x * z0 + v_y * z1;
    const Scalar z15 = k4 * v_psi + n0_3 * v_phi_4 + v_y * c_psi - z6;
    const Scalar z16 = v_x * z2 + v_y * z4 - k5 * v_psi;
    const Scalar z17 = k6 * v_psi - n0_3 * v_phi_1 + v_x * z4 - v_y * z2;
    const Scalar z18 = v_x * z3 + v_y * z5 - n0_5 * v_psi;
    const Scalar z19 = k7 * v_psi - n0_3 * v_phi_2 + v_x * z5 - v_y * z3;
    const Scalar z20 = v_x * z8 + v_y * z9;
    const Scalar z21 = v_x * z9 - v_y * z8;
    const Scalar z22 = v_x * z10 + v_y * z11;
    const Scalar z23 = v_x * z11 - v_y * z10;
    result.value[0] = n0;
    result.rate[0] = z16;
    result.gamma[0] = z20;
    result.value[1] = n0;
    result.rate[1] = -z17;
    result.gamma[1] = -z21;
    result.value[2] = n0;
    result.rate[2] = z18;
    result.gamma[2] = z22;
    result.value[3] = n0;
    result.rate[3] = -z19;
    result.gamma[3] = -z23;
    result.value[4] = n0;
    result.rate[4] = z7;
    result.gamma[4] = -z12;
    result.value[5] = n0;
    result.rate[5] = z13;
    result.gamma[5] = -z14;
    result.value[6] = n0;
    result.rate[6] = z7;
    result.gamma[6] = -z12;
    result.value[7] = n0;
    result.rate[7] = z15;
    result.gamma[7] = -z14;
    result.jacobian[0] = z2;
    result.jacobian[1] = -z4;
    result.jacobian[2] = z3;
    result.jacobian[3] = -z5;
    result.jacobian[4] = c_psi;
    result.jacobian[5] = -s_psi;
    result.jacobian[6] = c_psi;
    result.jacobian[7] = -s_psi;
    result.jacobian[8] = z4;
    result.jacobian[9] = z2;
    result.jacobian[10] = z5;
    result.jacobian[11] = z3;
    result.jacobian[12] = s_psi;
    result.jacobian[13] = c_psi;
    result.jacobian[14] = s_psi;
    result.jacobian[15] = c_psi;
    result.jacobian[16] = -k5;
    result.jacobian[17] = -k6;
    result.jacobian[18] = -n0_5;
    result.jacobian[19] = -k7;
    result.jacobian[20] = n1;
    result.jacobian[21] = -k4;
    result.jacobian[22] = n1;
    result.jacobian[23] = k4;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0_3;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = n0;
    result.jacobian[35] = n0_3;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = n0_3;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0_3;
  }
};

}  // namespace four_wheel_vehicle
