// SPDX-License-Identifier: MIT
// four_wheel_vehicle_all_wheels: Four-wheel vehicle: the eight conditions of its four wheels
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               12               24          0             0                  4       0     44       -
//   kinematics               64               73          0             0                  9       0    155     155
//   mass_matrix              44               48          0             0                  1       0     94     118
//   bias                     43               63          0             0                  1       0    108     191
//   inverse_dynamics        116              117          0             0                  5       0    243     374
//   forward_dynamics        592              739         11             0                  5       0   1352    1471
//   energy                   48               74          0             0                  5       0    132     162
//   constraints              44               56          0             0                  4       0    108     132
//
// Not computed because this mechanism does not need it:
//   kinematics: of 246 results 131 vanish identically, 30 repeat another up to sign
//   mass_matrix: of 121 results 82 vanish identically, 14 repeat another up to sign
//   bias: of 11 results 4 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 112 results 64 vanish identically, 8 repeat another up to sign
//
// To write this file again:
//   four_wheel_vehicle_all_wheels_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output four_wheel_vehicle_all_wheels.hpp
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

namespace four_wheel_vehicle_all_wheels {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle_all_wheels";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xc04f86c8fc14e982ULL;
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 11;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 8;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha_1;  ///< parameter [rad or 1]
    Scalar alpha_2;  ///< parameter [rad or 1]
    Scalar alpha_3;  ///< parameter [rad or 1]
    Scalar alpha_4;  ///< parameter [rad or 1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::alpha_1, &Parameters::alpha_2, &Parameters::alpha_3,
          &Parameters::alpha_4};
      return members_[i_];
    }
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
    Scalar s_1;  ///< coordinate [m]
    Scalar s_2;  ///< coordinate [m]
    Scalar s_3;  ///< coordinate [m]
    Scalar s_4;  ///< coordinate [m]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4, &Coordinates::s_1,
          &Coordinates::s_2, &Coordinates::s_3, &Coordinates::s_4};
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
    Scalar s_1;  ///< its rate [m/s]
    Scalar s_2;  ///< its rate [m/s]
    Scalar s_3;  ///< its rate [m/s]
    Scalar s_4;  ///< its rate [m/s]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4, &Velocities::s_1, &Velocities::s_2,
          &Velocities::s_3, &Velocities::s_4};
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
    Scalar s_1;  ///< its second rate [m/s^2]
    Scalar s_2;  ///< its second rate [m/s^2]
    Scalar s_3;  ///< its second rate [m/s^2]
    Scalar s_4;  ///< its second rate [m/s^2]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4,
          &Accelerations::s_1, &Accelerations::s_2, &Accelerations::s_3, &Accelerations::s_4};
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
    Scalar s_1;  ///< works with the rate of s_1 [N]
    Scalar s_2;  ///< works with the rate of s_2 [N]
    Scalar s_3;  ///< works with the rate of s_3 [N]
    Scalar s_4;  ///< works with the rate of s_4 [N]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4, &GeneralizedForces::s_1, &GeneralizedForces::s_2, &GeneralizedForces::s_3,
          &GeneralizedForces::s_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< of the constraint wheel_4_x [N]
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
    Scalar s_alpha_1;
    Scalar c_alpha_1;
    Scalar s_alpha_2;
    Scalar c_alpha_2;
    Scalar s_alpha_3;
    Scalar c_alpha_3;
    Scalar s_alpha_4;
    Scalar c_alpha_4;
    Scalar z168;
    Scalar z169;
    Scalar z170;
    Scalar z200;
    Scalar z201;
    Scalar z202;
    Scalar z237;
    Scalar z238;
    Scalar z239;
    Scalar z274;
    Scalar z275;
    Scalar z276;
    Scalar z462;
    Scalar z463;
    Scalar z471;
    Scalar z472;
    Scalar z480;
    Scalar z481;
    Scalar z489;
    Scalar z490;
    Scalar z508;
    Scalar z517;
    Scalar z526;
    Scalar z535;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar pi = traits::pi();
    parameters.alpha_1 = -n0_25 * pi;
    parameters.alpha_2 = -n1_over_6 * pi;
    parameters.alpha_3 = n0;
    parameters.alpha_4 = n0;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar p_alpha_1 = parameters.alpha_1;
    const Scalar p_alpha_2 = parameters.alpha_2;
    const Scalar p_alpha_3 = parameters.alpha_3;
    const Scalar p_alpha_4 = parameters.alpha_4;
    const Scalar angles_[] = {p_alpha_1, p_alpha_2, p_alpha_3, p_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha_1 = sines_[0], c_alpha_1 = cosines_[0];
    const Scalar s_alpha_2 = sines_[1], c_alpha_2 = cosines_[1];
    const Scalar s_alpha_3 = sines_[2], c_alpha_3 = cosines_[2];
    const Scalar s_alpha_4 = sines_[3], c_alpha_4 = cosines_[3];
    const Scalar z168 = n20 * c_alpha_4;
    const Scalar z169 = n20 * s_alpha_4;
    const Scalar z170 = z168 + k1 * z169;
    const Scalar z200 = n20 * c_alpha_3;
    const Scalar z201 = n20 * s_alpha_3;
    const Scalar z202 = z200 - k1 * z201;
    const Scalar z237 = n20 * c_alpha_2;
    const Scalar z238 = n20 * s_alpha_2;
    const Scalar z239 = z237 + k1 * z238;
    const Scalar z274 = n20 * c_alpha_1;
    const Scalar z275 = n20 * s_alpha_1;
    const Scalar z276 = z274 - k1 * z275;
    const Scalar z462 = s_alpha_1 + k1 * c_alpha_1;
    const Scalar z463 = k1 * s_alpha_1 - c_alpha_1;
    const Scalar z471 = s_alpha_2 - k1 * c_alpha_2;
    const Scalar z472 = k1 * s_alpha_2 + c_alpha_2;
    const Scalar z480 = s_alpha_3 + k1 * c_alpha_3;
    const Scalar z481 = k1 * s_alpha_3 - c_alpha_3;
    const Scalar z489 = s_alpha_4 - k1 * c_alpha_4;
    const Scalar z490 = k1 * s_alpha_4 + c_alpha_4;
    const Scalar z508 = n0_05 * z170;
    const Scalar z517 = n0_05 * z202;
    const Scalar z526 = n0_05 * z239;
    const Scalar z535 = n0_05 * z276;
    precomputed.s_alpha_1 = s_alpha_1;
    precomputed.c_alpha_1 = c_alpha_1;
    precomputed.s_alpha_2 = s_alpha_2;
    precomputed.c_alpha_2 = c_alpha_2;
    precomputed.s_alpha_3 = s_alpha_3;
    precomputed.c_alpha_3 = c_alpha_3;
    precomputed.s_alpha_4 = s_alpha_4;
    precomputed.c_alpha_4 = c_alpha_4;
    precomputed.z168 = z168;
    precomputed.z169 = z169;
    precomputed.z170 = z170;
    precomputed.z200 = z200;
    precomputed.z201 = z201;
    precomputed.z202 = z202;
    precomputed.z237 = z237;
    precomputed.z238 = z238;
    precomputed.z239 = z239;
    precomputed.z274 = z274;
    precomputed.z275 = z275;
    precomputed.z276 = z276;
    precomputed.z462 = z462;
    precomputed.z463 = z463;
    precomputed.z471 = z471;
    precomputed.z472 = z472;
    precomputed.z480 = z480;
    precomputed.z481 = z481;
    precomputed.z489 = z489;
    precomputed.z490 = z490;
    precomputed.z508 = z508;
    precomputed.z517 = z517;
    precomputed.z526 = z526;
    precomputed.z535 = z535;
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
    state.q.s_1 = n0;
    state.q.s_2 = n0;
    state.q.s_3 = n0;
    state.q.s_4 = n0;
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
    state.v.s_1 = n0;
    state.v.s_2 = n0;
    state.v.s_3 = n0;
    state.v.s_4 = n0;
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
    std::array<Scalar, 33> P1_jacobian;  ///< partial velocities of P1 (3 x 11)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 33> P2_jacobian;  ///< partial velocities of P2 (3 x 11)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 33> P3_jacobian;  ///< partial velocities of P3 (3 x 11)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 33> P4_jacobian;  ///< partial velocities of P4 (3 x 11)
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
    std::array<Scalar, 88> jacobian;  ///< A, stored column by column (8 x 11)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z55 = q_psi + p_alpha_1;
    const Scalar z80 = q_psi + p_alpha_2;
    const Scalar z104 = q_psi + p_alpha_3;
    const Scalar z126 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4, z55, z80, z104, z126};
    Scalar sines_[9], cosines_[9];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z56 = sines_[5], z57 = cosines_[5];
    const Scalar z81 = sines_[6], z82 = cosines_[6];
    const Scalar z105 = sines_[7], z106 = cosines_[7];
    const Scalar z127 = sines_[8], z128 = cosines_[8];
    const Scalar z62 = k0 * v_psi;
    const Scalar z58 = s_psi - k0 * c_psi;
    const Scalar z59 = k0 * s_psi + c_psi;
    const Scalar z83 = s_psi + k0 * c_psi;
    const Scalar z63 = v_x - v_psi * c_psi - s_psi * z62;  // velocity of steered_1, x
    const Scalar z64 = v_y - v_psi * s_psi + c_psi * z62;  // velocity of steered_1, y
    const Scalar z87 = v_x - v_psi * c_psi + s_psi * z62;  // velocity of steered_2, x
    const Scalar z88 = v_y - v_psi * s_psi - c_psi * z62;  // velocity of steered_2, y
    const Scalar z109 = v_x + v_psi * c_psi + s_psi * z62;  // velocity of steered_3, x
    const Scalar z110 = v_y + v_psi * s_psi - c_psi * z62;  // velocity of steered_3, y
    const Scalar z131 = v_x + v_psi * c_psi - s_psi * z62;  // velocity of steered_4, x
    const Scalar z132 = v_y + v_psi * s_psi + c_psi * z62;  // velocity of steered_4, y
    const Scalar z84 = k0 * s_psi - c_psi;
    const Scalar z69 = v_psi * q_s_1;
    const Scalar z93 = v_psi * q_s_2;
    const Scalar z115 = v_psi * q_s_3;
    const Scalar z65 = q_s_1 * z57;
    const Scalar z66 = q_s_1 * z56;
    const Scalar z89 = q_s_2 * z82;
    const Scalar z90 = q_s_2 * z81;
    const Scalar z111 = q_s_3 * z106;
    const Scalar z72 = c_phi_1 * z56;
    const Scalar z73 = s_phi_1 * z56;
    const Scalar z74 = c_phi_1 * z57;
    const Scalar z75 = s_phi_1 * z57;
    const Scalar z78 = v_phi_1 * z57;  // angular velocity of wheel_1, x
    const Scalar z79 = v_phi_1 * z56;  // angular velocity of wheel_1, y
    const Scalar z96 = c_phi_2 * z81;
    const Scalar z97 = s_phi_2 * z81;
    const Scalar z98 = c_phi_2 * z82;
    const Scalar z99 = s_phi_2 * z82;
    const Scalar z102 = v_phi_2 * z82;  // angular velocity of wheel_2, x
    const Scalar z103 = v_phi_2 * z81;  // angular velocity of wheel_2, y
    const Scalar z118 = c_phi_3 * z105;
    const Scalar z119 = s_phi_3 * z105;
    const Scalar z120 = c_phi_3 * z106;
    const Scalar z121 = s_phi_3 * z106;
    const Scalar z124 = v_phi_3 * z106;  // angular velocity of wheel_3, x
    const Scalar z125 = v_phi_3 * z105;  // angular velocity of wheel_3, y
    const Scalar z112 = q_s_3 * z105;
    const Scalar z133 = q_s_4 * z128;
    const Scalar z134 = q_s_4 * z127;
    const Scalar z60 = q_x - z58;  // place of steered_1, x
    const Scalar z61 = q_y + z59;  // place of steered_1, y
    const Scalar z140 = c_phi_4 * z127;
    const Scalar z141 = s_phi_4 * z127;
    const Scalar z137 = v_psi * q_s_4;
    const Scalar z85 = q_x - z83;  // place of steered_2, x
    const Scalar z86 = q_y - z84;  // place of steered_2, y
    const Scalar z107 = q_x + z58;  // place of steered_3, x
    const Scalar z108 = q_y - z59;  // place of steered_3, y
    const Scalar z129 = q_x + z83;  // place of steered_4, x
    const Scalar z130 = q_y + z84;  // place of steered_4, y
    const Scalar z67 = z60 + z65;  // place of axle_1, x
    const Scalar z142 = c_phi_4 * z128;
    const Scalar z68 = z61 + z66;  // place of axle_1, y
    const Scalar z143 = s_phi_4 * z128;
    const Scalar z146 = v_phi_4 * z128;  // angular velocity of wheel_4, x
    const Scalar z91 = z85 + z89;  // place of axle_2, x
    const Scalar z92 = z86 + z90;  // place of axle_2, y
    const Scalar z113 = z107 + z111;  // place of axle_3, x
    const Scalar z114 = z108 + z112;  // place of axle_3, y
    const Scalar z135 = z129 + z133;  // place of axle_4, x
    const Scalar z136 = z130 + z134;  // place of axle_4, y
    const Scalar z70 = z63 + v_s_1 * z57 - z56 * z69;  // velocity of axle_1, x
    const Scalar z147 = v_phi_4 * z127;  // angular velocity of wheel_4, y
    const Scalar z71 = z64 + v_s_1 * z56 + z57 * z69;  // velocity of axle_1, y
    const Scalar z148 = z58 - z65;
    const Scalar z156 = z58 + z111;
    const Scalar z149 = z59 + z66;
    const Scalar z152 = z83 - z89;
    const Scalar z153 = z84 - z90;
    const Scalar z94 = z87 + v_s_2 * z82 - z81 * z93;  // velocity of axle_2, x
    const Scalar z95 = z88 + v_s_2 * z81 + z82 * z93;  // velocity of axle_2, y
    const Scalar z116 = z109 + v_s_3 * z106 - z105 * z115;  // velocity of axle_3, x
    const Scalar z117 = z110 + v_s_3 * z105 + z106 * z115;  // velocity of axle_3, y
    const Scalar z138 = z131 + v_s_4 * z128 - z127 * z137;  // velocity of axle_4, x
    const Scalar z139 = z132 + v_s_4 * z127 + z128 * z137;  // velocity of axle_4, y
    const Scalar z157 = z59 - z112;
    const Scalar z160 = z83 + z133;
    const Scalar z161 = z84 + z134;
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
    result.wheel_1_position[0] = z67;
    result.wheel_1_position[1] = z68;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z57;
    result.wheel_1_rotation[1] = z56;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z72;
    result.wheel_1_rotation[4] = z74;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z73;
    result.wheel_1_rotation[7] = -z75;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z70;
    result.wheel_1_velocity[1] = z71;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z78;
    result.wheel_1_angular_velocity[1] = z79;
    result.wheel_1_angular_velocity[2] = v_psi;
    result.wheel_2_position[0] = z91;
    result.wheel_2_position[1] = z92;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z82;
    result.wheel_2_rotation[1] = z81;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z96;
    result.wheel_2_rotation[4] = z98;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z97;
    result.wheel_2_rotation[7] = -z99;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = z94;
    result.wheel_2_velocity[1] = z95;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z102;
    result.wheel_2_angular_velocity[1] = z103;
    result.wheel_2_angular_velocity[2] = v_psi;
    result.wheel_3_position[0] = z113;
    result.wheel_3_position[1] = z114;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = z106;
    result.wheel_3_rotation[1] = z105;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z118;
    result.wheel_3_rotation[4] = z120;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z119;
    result.wheel_3_rotation[7] = -z121;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = z116;
    result.wheel_3_velocity[1] = z117;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z124;
    result.wheel_3_angular_velocity[1] = z125;
    result.wheel_3_angular_velocity[2] = v_psi;
    result.wheel_4_position[0] = z135;
    result.wheel_4_position[1] = z136;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = z128;
    result.wheel_4_rotation[1] = z127;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z140;
    result.wheel_4_rotation[4] = z142;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z141;
    result.wheel_4_rotation[7] = -z143;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z138;
    result.wheel_4_velocity[1] = z139;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z146;
    result.wheel_4_angular_velocity[1] = z147;
    result.wheel_4_angular_velocity[2] = v_psi;
    result.P1_position[0] = z67;
    result.P1_position[1] = z68;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z70;
    result.P1_velocity[1] = z71;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = -z149;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[21] = z57;
    result.P1_jacobian[24] = n0;
    result.P1_jacobian[27] = n0;
    result.P1_jacobian[30] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z148;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[22] = z56;
    result.P1_jacobian[25] = n0;
    result.P1_jacobian[28] = n0;
    result.P1_jacobian[31] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P1_jacobian[23] = n0;
    result.P1_jacobian[26] = n0;
    result.P1_jacobian[29] = n0;
    result.P1_jacobian[32] = n0;
    result.P2_position[0] = z91;
    result.P2_position[1] = z92;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = z94;
    result.P2_velocity[1] = z95;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z153;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[21] = n0;
    result.P2_jacobian[24] = z82;
    result.P2_jacobian[27] = n0;
    result.P2_jacobian[30] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z152;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[22] = n0;
    result.P2_jacobian[25] = z81;
    result.P2_jacobian[28] = n0;
    result.P2_jacobian[31] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P2_jacobian[23] = n0;
    result.P2_jacobian[26] = n0;
    result.P2_jacobian[29] = n0;
    result.P2_jacobian[32] = n0;
    result.P3_position[0] = z113;
    result.P3_position[1] = z114;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = z116;
    result.P3_velocity[1] = z117;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z157;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[21] = n0;
    result.P3_jacobian[24] = n0;
    result.P3_jacobian[27] = z106;
    result.P3_jacobian[30] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = z156;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[22] = n0;
    result.P3_jacobian[25] = n0;
    result.P3_jacobian[28] = z105;
    result.P3_jacobian[31] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P3_jacobian[23] = n0;
    result.P3_jacobian[26] = n0;
    result.P3_jacobian[29] = n0;
    result.P3_jacobian[32] = n0;
    result.P4_position[0] = z135;
    result.P4_position[1] = z136;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z138;
    result.P4_velocity[1] = z139;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = -z161;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[21] = n0;
    result.P4_jacobian[24] = n0;
    result.P4_jacobian[27] = n0;
    result.P4_jacobian[30] = z128;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = z160;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[22] = n0;
    result.P4_jacobian[25] = n0;
    result.P4_jacobian[28] = n0;
    result.P4_jacobian[31] = z127;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
    result.P4_jacobian[23] = n0;
    result.P4_jacobian[26] = n0;
    result.P4_jacobian[29] = n0;
    result.P4_jacobian[32] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 121>& mass) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k5 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar q_psi = state.q.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z168 = precomputed.z168;
    const Scalar z169 = precomputed.z169;
    const Scalar z170 = precomputed.z170;
    const Scalar z200 = precomputed.z200;
    const Scalar z201 = precomputed.z201;
    const Scalar z202 = precomputed.z202;
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z274 = precomputed.z274;
    const Scalar z275 = precomputed.z275;
    const Scalar z276 = precomputed.z276;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z175 = n20 * q_s_4;
    const Scalar z207 = n20 * q_s_3;
    const Scalar z244 = n20 * q_s_2;
    const Scalar z174 = n20 * q_s_4 * q_s_4;
    const Scalar z281 = n20 * q_s_1;
    const Scalar z177 = s_alpha_4 * z175;
    const Scalar z209 = s_alpha_3 * z207;
    const Scalar z178 = c_alpha_4 * z175;
    const Scalar z210 = c_alpha_3 * z207;
    const Scalar z246 = s_alpha_2 * z244;
    const Scalar z247 = c_alpha_2 * z244;
    const Scalar z193 = k1 + z178;
    const Scalar z194 = n20 - z177;
    const Scalar z225 = k1 - z210;
    const Scalar z226 = n20 - z209;
    const Scalar z176 = n0_5 + z174;
    const Scalar z206 = n20 * q_s_3 * q_s_3;
    const Scalar z283 = s_alpha_1 * z281;
    const Scalar z227 = z193 - z225;
    const Scalar z228 = z194 + z226;
    const Scalar z262 = k1 - z247;
    const Scalar z263 = n20 + z246;
    const Scalar z284 = c_alpha_1 * z281;
    const Scalar z192 = k3 - n2 * z177 + k5 * z178 + z176;
    const Scalar z208 = n0_5 + z206;
    const Scalar z243 = n20 * q_s_2 * q_s_2;
    const Scalar z264 = z227 - z262;
    const Scalar z265 = z228 - z263;
    const Scalar z299 = k1 + z284;
    const Scalar z300 = n20 + z283;
    const Scalar z195 = n900 + z192;
    const Scalar z224 = k3 - n2 * z209 - k5 * z210 + z208;
    const Scalar z245 = n0_5 + z243;
    const Scalar z280 = n20 * q_s_1 * q_s_1;
    const Scalar z301 = z264 + z299;
    const Scalar z302 = z265 - z300;
    const Scalar z232 = z195 + z224;
    const Scalar z261 = k3 + n2 * z246 - k5 * z247 + z245;
    const Scalar z282 = n0_5 + z280;
    const Scalar z269 = z232 + z261;
    const Scalar z298 = k3 + n2 * z283 + k5 * z284 + z282;
    const Scalar z171 = s_psi * z169 - c_psi * z168;
    const Scalar z172 = s_psi * z168 + c_psi * z169;
    const Scalar z203 = s_psi * z201 - c_psi * z200;
    const Scalar z204 = s_psi * z200 + c_psi * z201;
    const Scalar z240 = s_psi * z238 - c_psi * z237;
    const Scalar z241 = s_psi * z237 + c_psi * z238;
    const Scalar z277 = s_psi * z275 - c_psi * z274;
    const Scalar z278 = s_psi * z274 + c_psi * z275;
    const Scalar z306 = z269 + z298;
    const Scalar z307 = s_psi * z301 - c_psi * z302;
    const Scalar z308 = s_psi * z302 + c_psi * z301;
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = -z307;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = -z277;
    mass[8] = -z240;
    mass[9] = -z203;
    mass[10] = -z171;
    mass[11] = n0;
    mass[12] = n880;
    mass[13] = z308;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z278;
    mass[19] = z241;
    mass[20] = z204;
    mass[21] = z172;
    mass[22] = -z307;
    mass[23] = z308;
    mass[24] = z306;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = -z276;
    mass[30] = -z239;
    mass[31] = z202;
    mass[32] = z170;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0_9;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
    mass[49] = n0;
    mass[50] = n0;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = n0;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = n0_9;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = n0;
    mass[71] = n0;
    mass[72] = n0_9;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = -z277;
    mass[78] = z278;
    mass[79] = -z276;
    mass[80] = n0;
    mass[81] = n0;
    mass[82] = n0;
    mass[83] = n0;
    mass[84] = n20;
    mass[85] = n0;
    mass[86] = n0;
    mass[87] = n0;
    mass[88] = -z240;
    mass[89] = z241;
    mass[90] = -z239;
    mass[91] = n0;
    mass[92] = n0;
    mass[93] = n0;
    mass[94] = n0;
    mass[95] = n0;
    mass[96] = n20;
    mass[97] = n0;
    mass[98] = n0;
    mass[99] = -z203;
    mass[100] = z204;
    mass[101] = z202;
    mass[102] = n0;
    mass[103] = n0;
    mass[104] = n0;
    mass[105] = n0;
    mass[106] = n0;
    mass[107] = n0;
    mass[108] = n20;
    mass[109] = n0;
    mass[110] = -z171;
    mass[111] = z172;
    mass[112] = z170;
    mass[113] = n0;
    mass[114] = n0;
    mass[115] = n0;
    mass[116] = n0;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n20;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z321 = v_psi * v_psi;
    const Scalar z322 = k0 * z321;
    const Scalar z323 = s_alpha_1 * z321 + c_alpha_1 * z322;
    const Scalar z324 = s_alpha_1 * z322 - c_alpha_1 * z321;
    const Scalar z328 = s_alpha_2 * z321 - c_alpha_2 * z322;
    const Scalar z329 = c_alpha_2 * z321 + s_alpha_2 * z322;
    const Scalar z339 = c_alpha_4 * z321 + s_alpha_4 * z322;
    const Scalar z334 = s_alpha_3 * z322 - c_alpha_3 * z321;
    const Scalar z331 = n2 * v_psi * v_s_2 - z329;
    const Scalar z341 = n2 * v_psi * v_s_4 + z339;
    const Scalar z333 = s_alpha_3 * z321 + c_alpha_3 * z322;
    const Scalar z338 = s_alpha_4 * z321 - c_alpha_4 * z322;
    const Scalar z336 = n2 * v_psi * v_s_3 - z334;
    const Scalar z345 = n20 * z341;  // force on axle_4, y
    const Scalar z361 = n20 * z331;  // force on axle_2, y
    const Scalar z335 = q_s_3 * z321 - z333;
    const Scalar z340 = q_s_4 * z321 - z338;
    const Scalar z326 = n2 * v_psi * v_s_1 + z324;
    const Scalar z346 = q_s_4 * z345;  // moment on steered_4, z
    const Scalar z353 = n20 * z336;  // force on axle_3, y
    const Scalar z362 = q_s_2 * z361;  // moment on steered_2, z
    const Scalar z330 = q_s_2 * z321 + z328;
    const Scalar z344 = n20 * z340;  // force on axle_4, x
    const Scalar z352 = n20 * z335;  // force on axle_3, x
    const Scalar z354 = q_s_3 * z353;  // moment on steered_3, z
    const Scalar z369 = n20 * z326;  // force on axle_1, y
    const Scalar z325 = q_s_1 * z321 + z323;
    const Scalar z360 = n20 * z330;  // force on axle_2, x
    const Scalar z370 = q_s_1 * z369;  // moment on steered_1, z
    const Scalar z368 = n20 * z325;  // force on axle_1, x
    const Scalar z347 = s_alpha_4 * z345 + c_alpha_4 * z344;
    const Scalar z348 = s_alpha_4 * z344 - c_alpha_4 * z345;
    const Scalar z355 = c_alpha_3 * z352 + s_alpha_3 * z353;
    const Scalar z356 = s_alpha_3 * z352 - c_alpha_3 * z353;
    const Scalar z363 = s_alpha_2 * z361 + c_alpha_2 * z360;
    const Scalar z364 = s_alpha_2 * z360 - c_alpha_2 * z361;
    const Scalar z371 = c_alpha_1 * z368 + s_alpha_1 * z369;
    const Scalar z372 = s_alpha_1 * z368 - c_alpha_1 * z369;
    const Scalar z375 = z347 + z355 + z363 + z371;  // force on S, x
    const Scalar z376 = z348 + z356 + z364 + z372;  // force on S, y
    // moment on S, z
    const Scalar z379 = z346 + z362 + z354 + z370 - z347 - z355 + z363 + z371 - k0 * (z348 - z356 - z364 + z372);
    const Scalar z380 = s_psi * z376 - c_psi * z375;
    const Scalar z381 = s_psi * z375 + c_psi * z376;
    forces.x = z380;
    forces.y = -z381;
    forces.psi = z379;
    forces.phi_1 = n0;
    forces.phi_2 = n0;
    forces.phi_3 = n0;
    forces.phi_4 = n0;
    forces.s_1 = -z368;
    forces.s_2 = -z360;
    forces.s_3 = -z352;
    forces.s_4 = -z344;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar a_s_1 = accelerations.s_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar a_s_2 = accelerations.s_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar a_s_3 = accelerations.s_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar a_s_4 = accelerations.s_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z462 = precomputed.z462;
    const Scalar z463 = precomputed.z463;
    const Scalar z471 = precomputed.z471;
    const Scalar z472 = precomputed.z472;
    const Scalar z480 = precomputed.z480;
    const Scalar z481 = precomputed.z481;
    const Scalar z489 = precomputed.z489;
    const Scalar z490 = precomputed.z490;
    const Scalar z55 = q_psi + p_alpha_1;
    const Scalar z80 = q_psi + p_alpha_2;
    const Scalar z104 = q_psi + p_alpha_3;
    const Scalar z126 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z55, z80, z104, z126};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z56 = sines_[1], z57 = cosines_[1];
    const Scalar z81 = sines_[2], z82 = cosines_[2];
    const Scalar z105 = sines_[3], z106 = cosines_[3];
    const Scalar z127 = sines_[4], z128 = cosines_[4];
    const Scalar z321 = v_psi * v_psi;
    const Scalar z385 = a_x * c_psi + a_y * s_psi;
    const Scalar z386 = a_x * s_psi - a_y * c_psi;
    const Scalar z411 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z419 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z427 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z435 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z464 = q_s_1 + z462;
    const Scalar z473 = q_s_2 + z471;
    const Scalar z482 = q_s_3 - z480;
    const Scalar z491 = q_s_4 - z489;
    const Scalar z387 = a_psi + k1 * z321 - z385;
    const Scalar z388 = k1 * a_psi - z321 - z386;
    const Scalar z393 = a_psi - k1 * z321 - z385;
    const Scalar z394 = k1 * a_psi + z321 + z386;
    const Scalar z399 = a_psi + k1 * z321 + z385;
    const Scalar z400 = k1 * a_psi - z321 + z386;
    const Scalar z405 = a_psi - k1 * z321 + z385;
    const Scalar z406 = k1 * a_psi + z321 - z386;
    const Scalar z389 = s_alpha_1 * z388 - c_alpha_1 * z387;
    const Scalar z390 = s_alpha_1 * z387 + c_alpha_1 * z388;
    const Scalar z395 = s_alpha_2 * z394 + c_alpha_2 * z393;
    const Scalar z396 = s_alpha_2 * z393 - c_alpha_2 * z394;
    const Scalar z401 = s_alpha_3 * z400 - c_alpha_3 * z399;
    const Scalar z402 = s_alpha_3 * z399 + c_alpha_3 * z400;
    const Scalar z407 = s_alpha_4 * z406 + c_alpha_4 * z405;
    const Scalar z408 = s_alpha_4 * z405 - c_alpha_4 * z406;
    const Scalar z391 = q_s_1 * z321 - a_s_1 - z389;
    const Scalar z392 = z390 + a_psi * q_s_1 + n2 * v_psi * v_s_1;
    const Scalar z397 = q_s_2 * z321 - a_s_2 + z395;
    const Scalar z398 = z396 + a_psi * q_s_2 + n2 * v_psi * v_s_2;
    const Scalar z403 = q_s_3 * z321 - a_s_3 + z401;
    const Scalar z404 = a_psi * q_s_3 - z402 + n2 * v_psi * v_s_3;
    const Scalar z409 = q_s_4 * z321 - a_s_4 - z407;
    const Scalar z410 = a_psi * q_s_4 - z408 + n2 * v_psi * v_s_4;
    const Scalar z412 = n20 * z409;  // force on axle_4, x
    const Scalar z420 = n20 * z403;  // force on axle_3, x
    const Scalar z428 = n20 * z397;  // force on axle_2, x
    const Scalar z436 = n20 * z391;  // force on axle_1, x
    const Scalar z413 = n20 * z410;  // force on axle_4, y
    const Scalar z421 = n20 * z404;  // force on axle_3, y
    const Scalar z429 = n20 * z398;  // force on axle_2, y
    const Scalar z437 = n20 * z392;  // force on axle_1, y
    const Scalar z414 = n0_5 * a_psi + q_s_4 * z413;  // moment on steered_4, z
    const Scalar z415 = c_alpha_4 * z412 + s_alpha_4 * z413;
    const Scalar z416 = s_alpha_4 * z412 - c_alpha_4 * z413;
    const Scalar z422 = n0_5 * a_psi + q_s_3 * z421;  // moment on steered_3, z
    const Scalar z423 = c_alpha_3 * z420 + s_alpha_3 * z421;
    const Scalar z424 = s_alpha_3 * z420 - c_alpha_3 * z421;
    const Scalar z431 = c_alpha_2 * z428 + s_alpha_2 * z429;
    const Scalar z432 = s_alpha_2 * z428 - c_alpha_2 * z429;
    const Scalar z430 = n0_5 * a_psi + q_s_2 * z429;  // moment on steered_2, z
    const Scalar z439 = c_alpha_1 * z436 + s_alpha_1 * z437;
    const Scalar z440 = s_alpha_1 * z436 - c_alpha_1 * z437;
    const Scalar z443 = z415 + z423 + z431 + z439;  // force on S, x
    const Scalar z444 = z416 + z424 + z432 + z440;  // force on S, y
    const Scalar z438 = n0_5 * a_psi + q_s_1 * z437;  // moment on steered_1, z
    const Scalar z448 = s_psi * z444 - c_psi * z443;
    const Scalar z449 = s_psi * z443 + c_psi * z444;
    // moment on S, z
    const Scalar z447 = n900 * a_psi + z414 - z415 + z422 - z423 + z430 + z431 + z438 + z439 - k1 * (z416 - z424 - z432
        + z440);
    const Scalar z452 = n800 * a_x + z448;  // force on S.y, x
    const Scalar z453 = n800 * a_y - z449;  // force on S.y, y
    forces.x = z56 * l_lambda_wheel_1_y - z57 * l_lambda_wheel_1_x + z81 * l_lambda_wheel_2_y - z82 * l_lambda_wheel_2_x
        + z105 * l_lambda_wheel_3_y - z106 * l_lambda_wheel_3_x + z127 * l_lambda_wheel_4_y - z128 * l_lambda_wheel_4_x
        + z452;
    forces.y = -z56 * l_lambda_wheel_1_x - z57 * l_lambda_wheel_1_y - z81 * l_lambda_wheel_2_x - z82
        * l_lambda_wheel_2_y - z105 * l_lambda_wheel_3_x - z106 * l_lambda_wheel_3_y - z127 * l_lambda_wheel_4_x - z128
        * l_lambda_wheel_4_y + z453;
    forces.psi = z472 * l_lambda_wheel_2_x - z463 * l_lambda_wheel_1_x + z481 * l_lambda_wheel_3_x - z490
        * l_lambda_wheel_4_x - z464 * l_lambda_wheel_1_y - z473 * l_lambda_wheel_2_y - z482 * l_lambda_wheel_3_y - z491
        * l_lambda_wheel_4_y + z447;
    forces.phi_1 = z435 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z427 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z419 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z411 - n0_3 * l_lambda_wheel_4_y;
    forces.s_1 = -z436 - l_lambda_wheel_1_x;
    forces.s_2 = -z428 - l_lambda_wheel_2_x;
    forces.s_3 = -z420 - l_lambda_wheel_3_x;
    forces.s_4 = -z412 - l_lambda_wheel_4_x;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k4 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar k6 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar k7 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z168 = precomputed.z168;
    const Scalar z169 = precomputed.z169;
    const Scalar z170 = precomputed.z170;
    const Scalar z200 = precomputed.z200;
    const Scalar z201 = precomputed.z201;
    const Scalar z202 = precomputed.z202;
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z274 = precomputed.z274;
    const Scalar z275 = precomputed.z275;
    const Scalar z276 = precomputed.z276;
    const Scalar z462 = precomputed.z462;
    const Scalar z463 = precomputed.z463;
    const Scalar z471 = precomputed.z471;
    const Scalar z472 = precomputed.z472;
    const Scalar z480 = precomputed.z480;
    const Scalar z481 = precomputed.z481;
    const Scalar z489 = precomputed.z489;
    const Scalar z490 = precomputed.z490;
    const Scalar z508 = precomputed.z508;
    const Scalar z517 = precomputed.z517;
    const Scalar z526 = precomputed.z526;
    const Scalar z535 = precomputed.z535;
    const Scalar z55 = q_psi + p_alpha_1;
    const Scalar z80 = q_psi + p_alpha_2;
    const Scalar z104 = q_psi + p_alpha_3;
    const Scalar z126 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z55, z80, z104, z126};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z56 = sines_[1], z57 = cosines_[1];
    const Scalar z81 = sines_[2], z82 = cosines_[2];
    const Scalar z105 = sines_[3], z106 = cosines_[3];
    const Scalar z127 = sines_[4], z128 = cosines_[4];
    const Scalar z175 = n20 * q_s_4;
    const Scalar z207 = n20 * q_s_3;
    const Scalar z244 = n20 * q_s_2;
    const Scalar z174 = n20 * q_s_4 * q_s_4;
    const Scalar z281 = n20 * q_s_1;
    const Scalar z177 = s_alpha_4 * z175;
    const Scalar z209 = s_alpha_3 * z207;
    const Scalar z178 = c_alpha_4 * z175;
    const Scalar z246 = s_alpha_2 * z244;
    const Scalar z210 = c_alpha_3 * z207;
    const Scalar z206 = n20 * q_s_3 * q_s_3;
    const Scalar z176 = n0_5 + z174;
    const Scalar z283 = s_alpha_1 * z281;
    const Scalar z247 = c_alpha_2 * z244;
    const Scalar z208 = n0_5 + z206;
    const Scalar z243 = n20 * q_s_2 * q_s_2;
    const Scalar z192 = k2 - n2 * z177 + k4 * z178 + z176;
    const Scalar z284 = c_alpha_1 * z281;
    const Scalar z224 = k2 - n2 * z209 - k4 * z210 + z208;
    const Scalar z245 = n0_5 + z243;
    const Scalar z280 = n20 * q_s_1 * q_s_1;
    const Scalar z261 = k2 + n2 * z246 - k4 * z247 + z245;
    const Scalar z195 = n900 + z192;
    const Scalar z282 = n0_5 + z280;
    const Scalar z232 = z195 + z224;
    const Scalar z194 = n20 - z177;
    const Scalar z226 = n20 - z209;
    const Scalar z298 = k2 + n2 * z283 + k4 * z284 + z282;
    const Scalar z269 = z232 + z261;
    const Scalar z193 = k6 + z178;
    const Scalar z225 = k6 - z210;
    const Scalar z228 = z194 + z226;
    const Scalar z263 = n20 + z246;
    const Scalar z306 = z269 + z298;
    const Scalar z227 = z193 - z225;
    const Scalar z262 = k6 - z247;
    const Scalar z265 = z228 - z263;
    const Scalar z300 = n20 + z283;
    const Scalar z264 = z227 - z262;
    const Scalar z299 = k6 + z284;
    const Scalar z302 = z265 - z300;
    const Scalar z172 = s_psi * z168 + c_psi * z169;
    const Scalar z301 = z264 + z299;
    const Scalar z204 = s_psi * z200 + c_psi * z201;
    const Scalar z241 = s_psi * z237 + c_psi * z238;
    const Scalar z308 = s_psi * z302 + c_psi * z301;
    const Scalar z278 = s_psi * z274 + c_psi * z275;
    const Scalar z171 = s_psi * z169 - c_psi * z168;
    const Scalar z307 = s_psi * z301 - c_psi * z302;
    const Scalar z203 = s_psi * z201 - c_psi * z200;
    const Scalar z240 = s_psi * z238 - c_psi * z237;
    const Scalar z277 = s_psi * z275 - c_psi * z274;
    const Scalar z491 = q_s_4 - z489;
    const Scalar z482 = q_s_3 - z480;
    const Scalar z473 = q_s_2 + z471;
    const Scalar z321 = v_psi * v_psi;
    const Scalar z322 = k7 * z321;
    const Scalar z464 = q_s_1 + z462;
    const Scalar z467 = v_psi * z57;
    const Scalar z476 = v_psi * z82;
    const Scalar z485 = v_psi * z106;
    const Scalar z494 = v_psi * z128;
    const Scalar z333 = s_alpha_3 * z321 + c_alpha_3 * z322;
    const Scalar z338 = s_alpha_4 * z321 - c_alpha_4 * z322;
    const Scalar z339 = c_alpha_4 * z321 + s_alpha_4 * z322;
    const Scalar z335 = q_s_3 * z321 - z333;
    const Scalar z340 = q_s_4 * z321 - z338;
    const Scalar z341 = n2 * v_psi * v_s_4 + z339;
    const Scalar z344 = n20 * z340;  // force on axle_4, x
    const Scalar z345 = n20 * z341;  // force on axle_4, y
    const Scalar z352 = n20 * z335;  // force on axle_3, x
    const Scalar z328 = s_alpha_2 * z321 - c_alpha_2 * z322;
    const Scalar z330 = q_s_2 * z321 + z328;
    const Scalar z329 = c_alpha_2 * z321 + s_alpha_2 * z322;
    const Scalar z331 = n2 * v_psi * v_s_2 - z329;
    const Scalar z360 = n20 * z330;  // force on axle_2, x
    const Scalar z334 = s_alpha_3 * z322 - c_alpha_3 * z321;
    const Scalar z336 = n2 * v_psi * v_s_3 - z334;
    const Scalar z361 = n20 * z331;  // force on axle_2, y
    const Scalar z323 = s_alpha_1 * z321 + c_alpha_1 * z322;
    const Scalar z324 = s_alpha_1 * z322 - c_alpha_1 * z321;
    const Scalar z325 = q_s_1 * z321 + z323;
    const Scalar z353 = n20 * z336;  // force on axle_3, y
    const Scalar z326 = n2 * v_psi * v_s_1 + z324;
    const Scalar z514 = z170 * z508 - z306;
    const Scalar z523 = z202 * z517 + z514;
    const Scalar z513 = z172 * z508 - z308;
    const Scalar z522 = z204 * z517 + z513;
    const Scalar z512 = z171 * z508 - z307;
    const Scalar z521 = z203 * z517 + z512;
    const Scalar z368 = n20 * z325;  // force on axle_1, x
    const Scalar z369 = n20 * z326;  // force on axle_1, y
    const Scalar z507 = n0_05 * z172;
    const Scalar z511 = n880 - z172 * z507;
    const Scalar z516 = n0_05 * z204;
    const Scalar z506 = n0_05 * z171;
    const Scalar z510 = z171 * z507;
    const Scalar z509 = n880 - z171 * z506;
    const Scalar z519 = z203 * z516 + z510;
    const Scalar z520 = z204 * z516 - z511;
    const Scalar z515 = n0_05 * z203;
    const Scalar z518 = z203 * z515 - z509;
    const Scalar z524 = n0_05 * z240;
    const Scalar z347 = s_alpha_4 * z345 + c_alpha_4 * z344;
    const Scalar z348 = s_alpha_4 * z344 - c_alpha_4 * z345;
    const Scalar z346 = q_s_4 * z345;  // moment on steered_4, z
    const Scalar z530 = z240 * z526 - z521;
    const Scalar z527 = z240 * z524 + z518;
    const Scalar z525 = n0_05 * z241;
    const Scalar z528 = z240 * z525 + z519;
    const Scalar z529 = z241 * z525 + z520;
    const Scalar z355 = c_alpha_3 * z352 + s_alpha_3 * z353;
    const Scalar z356 = s_alpha_3 * z352 - c_alpha_3 * z353;
    const Scalar z354 = q_s_3 * z353;  // moment on steered_3, z
    const Scalar z531 = z241 * z526 - z522;
    const Scalar z532 = z239 * z526 + z523;
    const Scalar z534 = n0_05 * z278;
    const Scalar z533 = n0_05 * z277;
    const Scalar z536 = z277 * z533 + z527;
    const Scalar z363 = s_alpha_2 * z361 + c_alpha_2 * z360;
    const Scalar z364 = s_alpha_2 * z360 - c_alpha_2 * z361;
    const Scalar z362 = q_s_2 * z361;  // moment on steered_2, z
    const Scalar z541 = z276 * z535 + z532;
    const Scalar z540 = z278 * z535 + z531;
    const Scalar z538 = z278 * z534 + z529;
    const Scalar z537 = z277 * z534 + z528;
    const Scalar z539 = z277 * z535 + z530;
    const Scalar z371 = c_alpha_1 * z368 + s_alpha_1 * z369;
    const Scalar z372 = s_alpha_1 * z368 - c_alpha_1 * z369;
    const Scalar z370 = q_s_1 * z369;  // moment on steered_1, z
    // moment on S, z
    const Scalar z379 = z346 + z362 + z354 + z370 - z347 - z355 + z363 + z371 - k7 * (z348 - z356 - z364 + z372);
    const Scalar z375 = z347 + z355 + z363 + z371;  // force on S, x
    const Scalar z376 = z348 + z356 + z364 + z372;  // force on S, y
    const Scalar z542 = n1 / z541;
    const Scalar z544 = z540 * z542;
    const Scalar z543 = z539 * z542;
    const Scalar z380 = s_psi * z376 - c_psi * z375;
    const Scalar z381 = s_psi * z375 + c_psi * z376;
    const Scalar z547 = z538 - z540 * z544;
    const Scalar z546 = z537 - z539 * z544;
    const Scalar z545 = z536 - z539 * z543;
    const Scalar z548 = n1 / z547;
    const Scalar z466 = v_psi * z56;
    const Scalar z552 = z56 - z534;
    const Scalar z475 = v_psi * z81;
    const Scalar z484 = v_psi * z105;
    const Scalar z493 = v_psi * z127;
    const Scalar z468 = v_x * z466 - v_y * z467;
    const Scalar z470 = v_x * z467 + v_y * z466 - v_psi * v_s_1;
    const Scalar z477 = v_x * z475 - v_y * z476;
    const Scalar z479 = v_x * z476 + v_y * z475 - v_psi * v_s_2;
    const Scalar z561 = z57 + z464 * z544;
    const Scalar z486 = v_x * z484 - v_y * z485;
    const Scalar z488 = v_x * z485 + v_y * z484 - v_psi * v_s_3;
    const Scalar z549 = z546 * z548;
    const Scalar z550 = z545 - z546 * z549;
    const Scalar z562 = z56 + z464 * z543 - z549 * z561;
    const Scalar z553 = z57 + z533 + z549 * z552;
    const Scalar z551 = n1 / z550;
    const Scalar z495 = v_x * z493 - v_y * z494;
    const Scalar z497 = v_x * z494 + v_y * z493 - v_psi * v_s_4;
    const Scalar z606 = z127 - z507;
    const Scalar z597 = z106 + z482 * z544;
    const Scalar z607 = z128 + z506 + z549 * z606;
    const Scalar z598 = z105 + z482 * z543 - z549 * z597;
    const Scalar z588 = z105 - z516;
    const Scalar z589 = z106 + z515 + z549 * z588;
    const Scalar z579 = z82 + z473 * z544;
    const Scalar z608 = z551 * z607;
    const Scalar z599 = z551 * z598;
    const Scalar z563 = z551 * z562;
    const Scalar z590 = z551 * z589;
    const Scalar z554 = z551 * z553;
    const Scalar z580 = z81 + z473 * z543 - z549 * z579;
    const Scalar z609 = z548 * z606 + z549 * z608;
    const Scalar z600 = z548 * z597 - z549 * z599;
    const Scalar z591 = z548 * z588 + z549 * z590;
    const Scalar z581 = z551 * z580;
    const Scalar z582 = z548 * z579 - z549 * z581;
    const Scalar z564 = z548 * z561 - z549 * z563;
    const Scalar z555 = z548 * z552 + z549 * z554;
    const Scalar z615 = z128 + z491 * z544;
    const Scalar z610 = z543 * z608 - z544 * z609;
    const Scalar z601 = z482 * z542 + z543 * z599 + z544 * z600;
    const Scalar z614 = n0_05 - z506 * z608 + z507 * z609 - z508 * z610;
    const Scalar z605 = z506 * z599 + z507 * z600 + z508 * z601;
    const Scalar z592 = z543 * z590 - z544 * z591;
    const Scalar z596 = z506 * z590 - z507 * z591 + z508 * z592;
    const Scalar z583 = z473 * z542 + z543 * z581 + z544 * z582;
    const Scalar z595 = n0_05 - z515 * z590 + z516 * z591 - z517 * z592;
    const Scalar z586 = z515 * z581 + z516 * z582 + z517 * z583;
    const Scalar z587 = z506 * z581 + z507 * z582 + z508 * z583;
    const Scalar z570 = z81 - z525;
    const Scalar z571 = z82 + z524 + z549 * z570;
    const Scalar z565 = z464 * z542 + z543 * z563 + z544 * z564;
    const Scalar z572 = z551 * z571;
    const Scalar z567 = z524 * z563 + z525 * z564 - z526 * z565;
    const Scalar z573 = z548 * z570 + z549 * z572;
    const Scalar z568 = z515 * z563 + z516 * z564 + z517 * z565;
    const Scalar z574 = z543 * z572 - z544 * z573;
    const Scalar z569 = z506 * z563 + z507 * z564 + z508 * z565;
    const Scalar z577 = z515 * z572 - z516 * z573 + z517 * z574;
    const Scalar z578 = z506 * z572 - z507 * z573 + z508 * z574;
    const Scalar z576 = n0_05 - z524 * z572 + z525 * z573 + z526 * z574;
    const Scalar z556 = z543 * z554 - z544 * z555;
    const Scalar z616 = z127 + z491 * z543 - z549 * z615;
    const Scalar z558 = z524 * z554 - z525 * z555 - z526 * z556;
    const Scalar z559 = z515 * z554 - z516 * z555 + z517 * z556;
    const Scalar z560 = z506 * z554 - z507 * z555 + z508 * z556;
    const Scalar z557 = n0_05 - z533 * z554 + z534 * z555 + z535 * z556;
    const Scalar z617 = z551 * z616;
    const Scalar z618 = z548 * z615 - z549 * z617;
    const Scalar z625 = z56 * z554 - z57 * z555 + z464 * z556;
    const Scalar z619 = z491 * z542 + z543 * z617 + z544 * z618;
    const Scalar z624 = z57 * z554 + z56 * z555 - z463 * z556 - z557;
    const Scalar z566 = z533 * z563 + z534 * z564 - z535 * z565;
    const Scalar z633 = n0_1 - z81 * z581 - z82 * z582 - z473 * z583;
    const Scalar z632 = z81 * z572 - z82 * z573 + z473 * z574;
    const Scalar z629 = z82 * z572 + z81 * z573 + z472 * z574 - z576;
    const Scalar z628 = z81 * z564 - z567 - z82 * z563 - z472 * z565;
    const Scalar z631 = z81 * z563 + z82 * z564 + z473 * z565;
    const Scalar z626 = n0_1 - z56 * z563 - z57 * z564 - z464 * z565;
    const Scalar z627 = z82 * z554 + z81 * z555 + z472 * z556 + z558;
    const Scalar z630 = z81 * z554 - z82 * z555 + z473 * z556;
    const Scalar z634 = z106 * z554 + z105 * z555 + z481 * z556 + z559;
    const Scalar z575 = z533 * z572 - z534 * z573 - z535 * z574;
    const Scalar z643 = z105 * z590 - z106 * z591 + z482 * z592;
    const Scalar z638 = z106 * z590 + z105 * z591 + z481 * z592 - z595;
    const Scalar z637 = z105 * z582 - z586 - z106 * z581 - z481 * z583;
    const Scalar z642 = z105 * z581 + z106 * z582 + z482 * z583;
    const Scalar z636 = z106 * z572 + z105 * z573 + z481 * z574 + z577;
    const Scalar z641 = z105 * z572 - z106 * z573 + z482 * z574;
    const Scalar z635 = z105 * z564 - z568 - z106 * z563 - z481 * z565;
    const Scalar z640 = z105 * z563 + z106 * z564 + z482 * z565;
    const Scalar z639 = z105 * z554 - z106 * z555 + z482 * z556;
    const Scalar z584 = z533 * z581 + z534 * z582 - z535 * z583;
    const Scalar z644 = n0_1 - z105 * z599 - z106 * z600 - z482 * z601;
    const Scalar z585 = z524 * z581 + z525 * z582 - z526 * z583;
    const Scalar z651 = z128 * z608 + z127 * z609 - z490 * z610 - z614;
    const Scalar z650 = z127 * z600 - z605 - z128 * z599 + z490 * z601;
    const Scalar z649 = z128 * z590 + z127 * z591 - z490 * z592 + z596;
    const Scalar z648 = z127 * z582 - z587 - z128 * z581 + z490 * z583;
    const Scalar z647 = z128 * z572 + z127 * z573 - z490 * z574 + z578;
    const Scalar z646 = z127 * z564 - z569 - z128 * z563 + z490 * z565;
    const Scalar z645 = z128 * z554 + z127 * z555 - z490 * z556 + z560;
    const Scalar z652 = z127 * z554 - z128 * z555 + z491 * z556;
    const Scalar z593 = z533 * z590 - z534 * z591 - z535 * z592;
    const Scalar z653 = z127 * z563 + z128 * z564 + z491 * z565;
    const Scalar z594 = z524 * z590 - z525 * z591 - z526 * z592;
    const Scalar z659 = n0_1 - z127 * z617 - z128 * z618 - z491 * z619;
    const Scalar z660 = n1 / z659;
    const Scalar z658 = z127 * z608 - z128 * z609 + z491 * z610;
    const Scalar z657 = z127 * z599 + z128 * z600 + z491 * z601;
    const Scalar z656 = z127 * z590 - z128 * z591 + z491 * z592;
    const Scalar z655 = z127 * z581 + z128 * z582 + z491 * z583;
    const Scalar z654 = z127 * z572 - z128 * z573 + z491 * z574;
    const Scalar z661 = z652 * z660;
    const Scalar z602 = z533 * z599 + z534 * z600 - z535 * z601;
    const Scalar z662 = z653 * z660;
    const Scalar z603 = z524 * z599 + z525 * z600 - z526 * z601;
    const Scalar z663 = z654 * z660;
    const Scalar z604 = z515 * z599 + z516 * z600 + z517 * z601;
    const Scalar z670 = z626 - z653 * z662;
    const Scalar z669 = z625 + z652 * z662;
    const Scalar z668 = z624 + z652 * z661;
    const Scalar z667 = z658 * z660;
    const Scalar z666 = z657 * z660;
    const Scalar z665 = z656 * z660;
    const Scalar z664 = z655 * z660;
    const Scalar z611 = z533 * z608 - z534 * z609 - z535 * z610;
    const Scalar z671 = z627 + z652 * z663;
    const Scalar z612 = z524 * z608 - z525 * z609 - z526 * z610;
    const Scalar z672 = z628 - z653 * z663;
    const Scalar z613 = z515 * z608 - z516 * z609 + z517 * z610;
    const Scalar z677 = z633 - z655 * z664;
    const Scalar z676 = z632 + z654 * z664;
    const Scalar z673 = z629 + z654 * z663;
    const Scalar z675 = z631 + z653 * z664;
    const Scalar z679 = z635 - z653 * z665;
    const Scalar z674 = z630 + z652 * z664;
    const Scalar z678 = z634 + z652 * z665;
    const Scalar z620 = z533 * z617 + z534 * z618 - z535 * z619;
    const Scalar z680 = z636 + z654 * z665;
    const Scalar z621 = z524 * z617 + z525 * z618 - z526 * z619;
    const Scalar z681 = z637 - z655 * z665;
    const Scalar z622 = z515 * z617 + z516 * z618 + z517 * z619;
    const Scalar z682 = z638 + z656 * z665;
    const Scalar z623 = z506 * z617 + z507 * z618 + z508 * z619;
    const Scalar z695 = z651 + z658 * z667;
    const Scalar z694 = z650 - z657 * z667;
    const Scalar z688 = z644 - z657 * z666;
    const Scalar z696 = n1 / z695;
    const Scalar z687 = z643 + z656 * z666;
    const Scalar z693 = z649 + z656 * z667;
    const Scalar z686 = z642 + z655 * z666;
    const Scalar z692 = z648 - z655 * z667;
    const Scalar z685 = z641 + z654 * z666;
    const Scalar z691 = z647 + z654 * z667;
    const Scalar z684 = z640 + z653 * z666;
    const Scalar z690 = z646 - z653 * z667;
    const Scalar z683 = z639 + z652 * z666;
    const Scalar z689 = z645 + z652 * z667;
    const Scalar z697 = z689 * z696;
    const Scalar z702 = z694 * z696;
    const Scalar z701 = z693 * z696;
    const Scalar z700 = z692 * z696;
    const Scalar z699 = z691 * z696;
    const Scalar z698 = z690 * z696;
    const Scalar z703 = z668 - z689 * z697;
    const Scalar z723 = z688 + z694 * z702;
    const Scalar z722 = z687 + z693 * z702;
    const Scalar z717 = z682 - z693 * z701;
    const Scalar z716 = z681 - z692 * z701;
    const Scalar z724 = n1 / z723;
    const Scalar z721 = z686 - z692 * z702;
    const Scalar z712 = z677 + z692 * z700;
    const Scalar z711 = z676 + z691 * z700;
    const Scalar z715 = z680 - z691 * z701;
    const Scalar z720 = z685 + z691 * z702;
    const Scalar z708 = z673 - z691 * z699;
    const Scalar z707 = z672 - z690 * z699;
    const Scalar z710 = z675 - z690 * z700;
    const Scalar z714 = z679 - z690 * z701;
    const Scalar z719 = z684 - z690 * z702;
    const Scalar z705 = z670 + z690 * z698;
    const Scalar z704 = z669 + z689 * z698;
    const Scalar z706 = z671 - z689 * z699;
    const Scalar z709 = z674 + z689 * z700;
    const Scalar z713 = z678 - z689 * z701;
    const Scalar z718 = z683 + z689 * z702;
    const Scalar z780 = z344 * z508 + z352 * z517 - z360 * z526 - z368 * z535 + z379;
    const Scalar z781 = z344 * z507 - z381 + z352 * z516 + z360 * z525 + z368 * z534 + z544 * z780;
    const Scalar z782 = z344 * z506 - z380 + z352 * z515 + z360 * z524 + z368 * z533 + z543 * z780 - z549 * z781;
    const Scalar z783 = z551 * z782;
    const Scalar z729 = z722 * z724;
    const Scalar z744 = z717 + z722 * z729;
    const Scalar z743 = z716 - z721 * z729;
    const Scalar z784 = z548 * z781 - z549 * z783;
    const Scalar z742 = z715 + z720 * z729;
    const Scalar z745 = n1 / z744;
    const Scalar z741 = z714 - z719 * z729;
    const Scalar z740 = z713 + z718 * z729;
    const Scalar z728 = z721 * z724;
    const Scalar z739 = z712 - z721 * z728;
    const Scalar z738 = z711 + z720 * z728;
    const Scalar z737 = z710 + z719 * z728;
    const Scalar z736 = z709 + z718 * z728;
    const Scalar z727 = z720 * z724;
    const Scalar z735 = z708 + z720 * z727;
    const Scalar z734 = z707 - z719 * z727;
    const Scalar z733 = z706 + z718 * z727;
    const Scalar z726 = z719 * z724;
    const Scalar z732 = z705 - z719 * z726;
    const Scalar z731 = z704 + z718 * z726;
    const Scalar z749 = z743 * z745;
    const Scalar z748 = z742 * z745;
    const Scalar z747 = z741 * z745;
    const Scalar z725 = z718 * z724;
    const Scalar z785 = z542 * z780 + z543 * z783 + z544 * z784;
    const Scalar z786 = n0_05 * z368 - z533 * z783 - z534 * z784 + z535 * z785;
    const Scalar z787 = n0_05 * z360 - z524 * z783 - z525 * z784 + z526 * z785;
    const Scalar z788 = n0_05 * z352 - z515 * z783 - z516 * z784 - z517 * z785;
    const Scalar z789 = n0_05 * z344 - z506 * z783 - z507 * z784 - z508 * z785;
    const Scalar z759 = z739 + z743 * z749;
    const Scalar z730 = z703 + z718 * z725;
    const Scalar z791 = z56 * z783 - z470 + z57 * z784 + z464 * z785;
    const Scalar z793 = z81 * z783 - z479 + z82 * z784 + z473 * z785;
    const Scalar z795 = z105 * z783 - z488 + z106 * z784 + z482 * z785;
    const Scalar z797 = z127 * z783 - z497 + z128 * z784 + z491 * z785;
    const Scalar z758 = z738 + z742 * z749;
    const Scalar z755 = z735 - z742 * z748;
    const Scalar z760 = n1 / z759;
    const Scalar z754 = z734 - z741 * z748;
    const Scalar z757 = z737 - z741 * z749;
    const Scalar z752 = z732 + z741 * z747;
    const Scalar z751 = z731 + z740 * z747;
    const Scalar z753 = z733 - z740 * z748;
    const Scalar z756 = z736 + z740 * z749;
    const Scalar z790 = z56 * z784 - z468 - z57 * z783 + z463 * z785 + z786;
    const Scalar z792 = z81 * z784 - z477 - z82 * z783 - z472 * z785 + z787;
    const Scalar z794 = z105 * z784 - z486 - z106 * z783 - z481 * z785 + z788;
    const Scalar z796 = z127 * z784 - z495 - z128 * z783 + z490 * z785 + z789;
    const Scalar z798 = z667 * z797 - z796;
    const Scalar z763 = z758 * z760;
    const Scalar z769 = z755 + z758 * z763;
    const Scalar z768 = z754 - z757 * z763;
    const Scalar z767 = z753 + z756 * z763;
    const Scalar z799 = z795 + z666 * z797 + z702 * z798;
    const Scalar z770 = n1 / z769;
    const Scalar z762 = z757 * z760;
    const Scalar z766 = z752 - z757 * z762;
    const Scalar z765 = z751 + z756 * z762;
    const Scalar z800 = z665 * z797 - z794 - z701 * z798 + z729 * z799;
    const Scalar z801 = z793 + z664 * z797 + z700 * z798 + z728 * z799 + z749 * z800;
    const Scalar z802 = z663 * z797 - z792 - z699 * z798 + z727 * z799 - z748 * z800 + z763 * z801;
    const Scalar z772 = z768 * z770;
    const Scalar z775 = z766 + z768 * z772;
    const Scalar z774 = z765 + z767 * z772;
    const Scalar z803 = z791 + z662 * z797 + z698 * z798 + z726 * z799 + z747 * z800 + z762 * z801 + z772 * z802;
    const Scalar z776 = n1 / z775;
    const Scalar z746 = z740 * z745;
    const Scalar z750 = z730 - z740 * z746;
    const Scalar z761 = z756 * z760;
    const Scalar z771 = z767 * z770;
    const Scalar z764 = z750 + z756 * z761;
    const Scalar z773 = z764 - z767 * z771;
    const Scalar z777 = z774 * z776;
    const Scalar z804 = z661 * z797 - z790 - z697 * z798 + z725 * z799 - z746 * z800 + z761 * z801 - z771 * z802 + z777
        * z803;
    const Scalar z778 = z773 + z774 * z777;
    const Scalar z779 = n1 / z778;
    const Scalar z805 = z779 * z804;
    const Scalar z806 = z776 * z803 - z777 * z805;
    const Scalar z807 = z770 * z802 - z771 * z805 - z772 * z806;
    const Scalar z816 = n1_over_3 * z806;
    const Scalar z808 = z760 * z801 - z761 * z805 + z762 * z806 - z763 * z807;
    const Scalar z809 = z745 * z800 - z746 * z805 - z747 * z806 - z748 * z807 - z749 * z808;
    const Scalar z817 = n1_over_3 * z808;
    const Scalar z810 = z724 * z799 - z725 * z805 + z726 * z806 - z727 * z807 + z728 * z808 - z729 * z809;
    const Scalar z811 = z696 * z798 - z697 * z805 - z698 * z806 - z699 * z807 - z700 * z808 - z701 * z809 - z702 * z810;
    const Scalar z818 = n1_over_3 * z810;
    const Scalar z812 = z660 * z797 - z661 * z805 + z662 * z806 - z663 * z807 + z664 * z808 - z665 * z809 + z666 * z810
        - z667 * z811;
    const Scalar z813 = z554 * z805 - z783 - z563 * z806 + z572 * z807 - z581 * z808 + z590 * z809 - z599 * z810 + z608
        * z811 - z617 * z812;
    const Scalar z814 = z784 + z555 * z805 + z564 * z806 + z573 * z807 + z582 * z808 + z591 * z809 + z600 * z810 + z609
        * z811 + z618 * z812;
    const Scalar z815 = z556 * z805 - z785 - z565 * z806 + z574 * z807 - z583 * z808 + z592 * z809 - z601 * z810 + z610
        * z811 - z619 * z812;
    const Scalar z820 = z557 * z805 - z786 + z566 * z806 - z575 * z807 + z584 * z808 - z593 * z809 + z602 * z810 - z611
        * z811 + z620 * z812;
    const Scalar z821 = z787 + z558 * z805 - z567 * z806 - z576 * z807 - z585 * z808 + z594 * z809 - z603 * z810 + z612
        * z811 - z621 * z812;
    const Scalar z822 = z788 + z559 * z805 - z568 * z806 + z577 * z807 - z586 * z808 - z595 * z809 - z604 * z810 + z613
        * z811 - z622 * z812;
    const Scalar z819 = n1_over_3 * z812;
    const Scalar z823 = z789 + z560 * z805 - z569 * z806 + z578 * z807 - z587 * z808 + z596 * z809 - z605 * z810 - z614
        * z811 - z623 * z812;
    accelerations.x = z813;
    accelerations.y = z814;
    accelerations.psi = -z815;
    accelerations.phi_1 = -z816;
    accelerations.phi_2 = -z817;
    accelerations.phi_3 = -z818;
    accelerations.phi_4 = -z819;
    accelerations.s_1 = -z820;
    accelerations.s_2 = z821;
    accelerations.s_3 = z822;
    accelerations.s_4 = z823;
    multipliers.lambda_wheel_1_x = -z805;
    multipliers.lambda_wheel_1_y = -z806;
    multipliers.lambda_wheel_2_x = -z807;
    multipliers.lambda_wheel_2_y = -z808;
    multipliers.lambda_wheel_3_x = -z809;
    multipliers.lambda_wheel_3_y = -z810;
    multipliers.lambda_wheel_4_x = -z811;
    multipliers.lambda_wheel_4_y = -z812;
    if (!(traits::regular(-z550, n880) && traits::regular(-z547, n880) && traits::regular(-z541, z306)
        && traits::regular(-z778, -z624) && traits::regular(z775, z626) && traits::regular(-z769, -z629)
        && traits::regular(z759, z633) && traits::regular(-z744, -z638) && traits::regular(z723, z644)
        && traits::regular(-z695, -z651) && traits::regular(z659, z659))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.phi_1
        * accelerations.phi_2 * accelerations.phi_3 * accelerations.phi_4 * accelerations.s_1 * accelerations.s_2) * (n0
        * accelerations.s_3 * accelerations.s_4 * multipliers.lambda_wheel_1_x * multipliers.lambda_wheel_1_y
        * multipliers.lambda_wheel_2_x * multipliers.lambda_wheel_2_y * multipliers.lambda_wheel_3_x
        * multipliers.lambda_wheel_3_y * multipliers.lambda_wheel_4_x * multipliers.lambda_wheel_4_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z824 = v_x * c_psi + v_y * s_psi;
    const Scalar z825 = v_x * s_psi - v_y * c_psi;
    const Scalar z76 = v_psi * s_phi_1;
    const Scalar z77 = v_psi * c_phi_1;
    const Scalar z100 = v_psi * s_phi_2;
    const Scalar z101 = v_psi * c_phi_2;
    const Scalar z122 = v_psi * s_phi_3;
    const Scalar z123 = v_psi * c_phi_3;
    const Scalar z144 = v_psi * s_phi_4;
    const Scalar z145 = v_psi * c_phi_4;
    const Scalar z826 = v_psi - z824;
    const Scalar z827 = k0 * v_psi - z825;
    const Scalar z834 = k0 * v_psi + z825;
    const Scalar z841 = v_psi + z824;
    const Scalar z828 = s_alpha_1 * z827 - c_alpha_1 * z826;
    const Scalar z829 = s_alpha_1 * z826 + c_alpha_1 * z827;
    const Scalar z835 = c_alpha_2 * z826 + s_alpha_2 * z834;
    const Scalar z836 = s_alpha_2 * z826 - c_alpha_2 * z834;
    const Scalar z842 = s_alpha_3 * z834 - c_alpha_3 * z841;
    const Scalar z843 = s_alpha_3 * z841 + c_alpha_3 * z834;
    const Scalar z848 = c_alpha_4 * z841 + s_alpha_4 * z827;
    const Scalar z849 = s_alpha_4 * z841 - c_alpha_4 * z827;
    const Scalar z830 = v_psi * q_s_1 + z829;
    const Scalar z837 = v_psi * q_s_2 + z836;
    const Scalar z838 = v_s_2 - z835;  // velocity of axle_2, x
    const Scalar z844 = v_psi * q_s_3 - z843;
    const Scalar z850 = v_psi * q_s_4 - z849;
    const Scalar z851 = v_s_4 + z848;  // velocity of axle_4, x
    const Scalar z831 = v_s_1 + z828;  // velocity of axle_1, x
    const Scalar z845 = v_s_3 - z842;  // velocity of axle_3, x
    const Scalar z832 = c_phi_1 * z830;
    const Scalar z833 = s_phi_1 * z830;
    const Scalar z839 = c_phi_2 * z837;
    const Scalar z840 = s_phi_2 * z837;
    const Scalar z846 = c_phi_3 * z844;
    const Scalar z847 = s_phi_3 * z844;
    const Scalar z852 = c_phi_4 * z850;
    const Scalar z853 = s_phi_4 * z850;
    result.kinetic = n450 * v_psi * v_psi + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3 * v_phi_3 + v_phi_4
        * v_phi_4) + n400 * (z824 * z824 + z825 * z825) + n0_25 * (z76 * z76 + z77 * z77 + z100 * z100 + z101 * z101
        + z122 * z122 + z123 * z123 + z144 * z144 + z145 * z145) + n10 * (z838 * z838 + z851 * z851 + z831 * z831 + z845
        * z845 + z832 * z832 + z833 * z833 + z839 * z839 + z840 * z840 + z846 * z846 + z847 * z847 + z852 * z852 + z853
        * z853);
    result.force_function = n0;
    result.power = n0;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z462 = precomputed.z462;
    const Scalar z463 = precomputed.z463;
    const Scalar z471 = precomputed.z471;
    const Scalar z472 = precomputed.z472;
    const Scalar z480 = precomputed.z480;
    const Scalar z481 = precomputed.z481;
    const Scalar z489 = precomputed.z489;
    const Scalar z490 = precomputed.z490;
    const Scalar z55 = q_psi + p_alpha_1;
    const Scalar z80 = q_psi + p_alpha_2;
    const Scalar z104 = q_psi + p_alpha_3;
    const Scalar z126 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z55, z80, z104, z126};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z56 = sines_[0], z57 = cosines_[0];
    const Scalar z81 = sines_[1], z82 = cosines_[1];
    const Scalar z105 = sines_[2], z106 = cosines_[2];
    const Scalar z127 = sines_[3], z128 = cosines_[3];
    const Scalar z467 = v_psi * z57;
    const Scalar z476 = v_psi * z82;
    const Scalar z485 = v_psi * z106;
    const Scalar z494 = v_psi * z128;
    const Scalar z464 = q_s_1 + z462;
    const Scalar z466 = v_psi * z56;
    const Scalar z473 = q_s_2 + z471;
    const Scalar z475 = v_psi * z81;
    const Scalar z482 = q_s_3 - z480;
    const Scalar z484 = v_psi * z105;
    const Scalar z491 = q_s_4 - z489;
    const Scalar z493 = v_psi * z127;
    const Scalar z465 = v_psi * z463 + v_s_1 + v_x * z57 + v_y * z56;
    const Scalar z469 = v_x * z56 - v_y * z57 - v_psi * z464 - n0_3 * v_phi_1;
    const Scalar z474 = v_s_2 - v_psi * z472 + v_x * z82 + v_y * z81;
    const Scalar z478 = v_x * z81 - v_y * z82 - v_psi * z473 - n0_3 * v_phi_2;
    const Scalar z483 = v_s_3 - v_psi * z481 + v_x * z106 + v_y * z105;
    const Scalar z487 = v_x * z105 - v_y * z106 - v_psi * z482 - n0_3 * v_phi_3;
    const Scalar z492 = v_psi * z490 + v_s_4 + v_x * z128 + v_y * z127;
    const Scalar z496 = v_x * z127 - v_y * z128 - v_psi * z491 - n0_3 * v_phi_4;
    const Scalar z468 = v_x * z466 - v_y * z467;
    const Scalar z470 = v_x * z467 + v_y * z466 - v_psi * v_s_1;
    const Scalar z477 = v_x * z475 - v_y * z476;
    const Scalar z479 = v_x * z476 + v_y * z475 - v_psi * v_s_2;
    const Scalar z486 = v_x * z484 - v_y * z485;
    const Scalar z488 = v_x * z485 + v_y * z484 - v_psi * v_s_3;
    const Scalar z495 = v_x * z493 - v_y * z494;
    const Scalar z497 = v_x * z494 + v_y * z493 - v_psi * v_s_4;
    result.value[0] = n0;
    result.rate[0] = z465;
    result.gamma[0] = -z468;
    result.value[1] = n0;
    result.rate[1] = -z469;
    result.gamma[1] = -z470;
    result.value[2] = n0;
    result.rate[2] = z474;
    result.gamma[2] = -z477;
    result.value[3] = n0;
    result.rate[3] = -z478;
    result.gamma[3] = -z479;
    result.value[4] = n0;
    result.rate[4] = z483;
    result.gamma[4] = -z486;
    result.value[5] = n0;
    result.rate[5] = -z487;
    result.gamma[5] = -z488;
    result.value[6] = n0;
    result.rate[6] = z492;
    result.gamma[6] = -z495;
    result.value[7] = n0;
    result.rate[7] = -z496;
    result.gamma[7] = -z497;
    result.jacobian[0] = z57;
    result.jacobian[1] = -z56;
    result.jacobian[2] = z82;
    result.jacobian[3] = -z81;
    result.jacobian[4] = z106;
    result.jacobian[5] = -z105;
    result.jacobian[6] = z128;
    result.jacobian[7] = -z127;
    result.jacobian[8] = z56;
    result.jacobian[9] = z57;
    result.jacobian[10] = z81;
    result.jacobian[11] = z82;
    result.jacobian[12] = z105;
    result.jacobian[13] = z106;
    result.jacobian[14] = z127;
    result.jacobian[15] = z128;
    result.jacobian[16] = z463;
    result.jacobian[17] = z464;
    result.jacobian[18] = -z472;
    result.jacobian[19] = z473;
    result.jacobian[20] = -z481;
    result.jacobian[21] = z482;
    result.jacobian[22] = z490;
    result.jacobian[23] = z491;
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
    result.jacobian[56] = n1;
    result.jacobian[57] = n0;
    result.jacobian[58] = n0;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n1;
    result.jacobian[67] = n0;
    result.jacobian[68] = n0;
    result.jacobian[69] = n0;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n1;
    result.jacobian[77] = n0;
    result.jacobian[78] = n0;
    result.jacobian[79] = n0;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = n0;
    result.jacobian[85] = n0;
    result.jacobian[86] = n1;
    result.jacobian[87] = n0;
  }
};

}  // namespace four_wheel_vehicle_all_wheels
