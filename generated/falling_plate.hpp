// SPDX-License-Identifier: MIT
// falling_plate: A plate falls with its edge on a smooth plane
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: b, A, B, F
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                9                4          0             0                  0       0     13       -
//   kinematics               12               28          0             0                  2       0     44      46
//   mass_matrix               3                7          0             0                  1       0     12      21
//   bias                     14               39          0             0                  1       0     55      70
//   inverse_dynamics         21               48          0             0                  1       0     71      89
//   forward_dynamics         20               50          2             0                  1       0     74      92
//   energy                   15               30          0             0                  2       0     49      59
//   first_integrals          19               36          0             0                  2       0     59      70
//   reactions                16               30          0             0                  2       0     50      79
//   linearisation            73              149          2             0                  1       0    226     280
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
  static constexpr unsigned long long fingerprint = 0xd13ef6e7c996d9acULL;
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
    Scalar z24;
    Scalar z25;
    Scalar z26;
    Scalar z29;
    Scalar z30;
    Scalar z148;
    Scalar z174;
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
    const Scalar z24 = p_b * p_b + p_A;
    const Scalar z25 = p_b * p_b + p_A + p_B;
    const Scalar z26 = p_B - z25;
    const Scalar z27 = p_B - z24 + z25;
    const Scalar z28 = n0_5 * z27;
    const Scalar z29 = p_B - z28;
    const Scalar z30 = z25 - z28;
    const Scalar z148 = z29 - z30;
    const Scalar z174 = n2 * p_b;
    precomputed.z24 = z24;
    precomputed.z25 = z25;
    precomputed.z26 = z26;
    precomputed.z29 = z29;
    precomputed.z30 = z30;
    precomputed.z148 = z148;
    precomputed.z174 = z174;
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
    const Scalar z59 = s_beta * v_beta;
    const Scalar z61 = p_b * c_beta;
    const Scalar z73 = v_alpha * c_beta;
    const Scalar z69 = s_alpha * c_beta;
    const Scalar z71 = c_alpha * c_beta;
    const Scalar z70 = s_alpha * s_beta;
    const Scalar z72 = c_alpha * s_beta;
    const Scalar z81 = p_b * v_beta;
    const Scalar z60 = p_b * s_beta;
    const Scalar z74 = c_alpha * v_beta;  // angular velocity of plate, x
    const Scalar z75 = s_alpha * v_beta;  // angular velocity of plate, y
    const Scalar z84 = c_beta * z81;
    const Scalar z62 = s_alpha * z61;
    const Scalar z63 = c_alpha * z61;
    const Scalar z66 = v_alpha * z61;
    const Scalar z76 = p_b * z69;
    const Scalar z77 = p_b * z71;
    const Scalar z80 = p_b * z73;
    const Scalar z64 = q_x + z62;  // place of foot, x
    const Scalar z65 = q_y - z63;  // place of foot, y
    const Scalar z67 = v_x - s_alpha * p_b * z59 + c_alpha * z66;  // velocity of foot, x
    const Scalar z68 = v_y + c_alpha * p_b * z59 + s_alpha * z66;  // velocity of foot, y
    const Scalar z78 = z64 - z76;
    const Scalar z79 = z65 + z77;
    const Scalar z82 = c_alpha * z80 - z67 - z70 * z81;
    const Scalar z83 = s_alpha * z80 - z68 + z72 * z81;
    result.plate_position[0] = z78;
    result.plate_position[1] = z79;
    result.plate_position[2] = z60;
    result.plate_rotation[0] = c_alpha;
    result.plate_rotation[1] = s_alpha;
    result.plate_rotation[2] = n0;
    result.plate_rotation[3] = -z69;
    result.plate_rotation[4] = z71;
    result.plate_rotation[5] = s_beta;
    result.plate_rotation[6] = z70;
    result.plate_rotation[7] = -z72;
    result.plate_rotation[8] = c_beta;
    result.plate_velocity[0] = -z82;
    result.plate_velocity[1] = -z83;
    result.plate_velocity[2] = z84;
    result.plate_angular_velocity[0] = z74;
    result.plate_angular_velocity[1] = z75;
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
    const Scalar z24 = precomputed.z24;
    const Scalar z25 = precomputed.z25;
    const Scalar z26 = precomputed.z26;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z129 = s_beta * z26;
    const Scalar z126 = p_b * s_beta;
    const Scalar z127 = p_b * c_beta;
    const Scalar z128 = s_beta * p_F;
    const Scalar z130 = s_beta * z129;
    const Scalar z133 = z126 * z126;
    const Scalar z131 = z25 + z130;
    const Scalar z134 = z24 - z133;
    const Scalar z132 = z127 * z127 - z131;
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
    mass[10] = -z132;
    mass[11] = z128;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = z128;
    mass[15] = z134;
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
    const Scalar z29 = precomputed.z29;
    const Scalar z30 = precomputed.z30;
    const Scalar z148 = precomputed.z148;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z16 = s_beta * v_beta;
    const Scalar z17 = c_beta * v_beta;
    const Scalar z35 = p_b * c_beta;
    const Scalar z43 = v_alpha * s_beta;
    const Scalar z136 = v_alpha * v_alpha;
    const Scalar z44 = v_alpha * c_beta;
    const Scalar z145 = v_beta * v_beta;
    const Scalar z20 = p_b * s_beta;
    const Scalar z135 = v_beta * z17;
    const Scalar z137 = n2 * v_alpha * p_b * z16;
    const Scalar z141 = v_beta * z44;  // angular acceleration of plate, y
    const Scalar z142 = v_beta * z43;  // angular acceleration of plate, z
    const Scalar z144 = z44 * z44;
    const Scalar z147 = z43 * z44;
    const Scalar z150 = z43 * z43;
    const Scalar z138 = z35 * z136 + p_b * z135;
    const Scalar z143 = n2 * z142;
    const Scalar z146 = z144 + z145;
    const Scalar z149 = n2 * z141;
    const Scalar z151 = z145 - z150;
    const Scalar z154 = p_b * z147;  // force on plate, z
    const Scalar z152 = p_b * z143;  // force on plate, x
    const Scalar z153 = p_b * z146;  // force on plate, y
    const Scalar z156 = p_F * z147 + z29 * z149;  // moment on plate, y
    const Scalar z157 = p_b * z137 + p_F * z151 - z30 * z143;  // moment on plate, z
    const Scalar z140 = n9_81 * c_beta - s_beta * z138;
    const Scalar z158 = s_beta * z154 + c_beta * z153;
    const Scalar z162 = z137 - z152;  // force on foot, x
    const Scalar z155 = p_b * z140 - z147 * z148;  // moment on plate, x
    const Scalar z163 = z138 - z158;  // force on foot, y
    const Scalar z161 = s_beta * z156 + c_beta * z157;
    const Scalar z166 = z35 * z162 - z161;  // moment on turned, z
    const Scalar z173 = z20 * z163 + z155;
    forces.x = n0;
    forces.y = n0;
    forces.alpha = -z166;
    forces.beta = z173;
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
    const Scalar z24 = precomputed.z24;
    const Scalar z25 = precomputed.z25;
    const Scalar z26 = precomputed.z26;
    const Scalar z29 = precomputed.z29;
    const Scalar z30 = precomputed.z30;
    const Scalar z148 = precomputed.z148;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z213 = s_beta * v_beta;
    const Scalar z214 = c_beta * v_beta;
    const Scalar z216 = p_b * c_beta;
    const Scalar z217 = v_alpha * s_beta;
    const Scalar z227 = v_alpha * v_alpha;
    const Scalar z218 = v_alpha * c_beta;
    const Scalar z235 = v_beta * v_beta;
    const Scalar z220 = s_beta * z26;
    const Scalar z215 = p_b * s_beta;
    const Scalar z219 = s_beta * p_F;
    const Scalar z221 = s_beta * z220;
    const Scalar z224 = z215 * z215;
    const Scalar z226 = v_beta * z214;
    const Scalar z228 = n2 * v_alpha * p_b * z213;
    const Scalar z231 = v_beta * z218;  // angular acceleration of plate, y
    const Scalar z232 = v_beta * z217;  // angular acceleration of plate, z
    const Scalar z234 = z218 * z218;
    const Scalar z237 = z217 * z218;
    const Scalar z239 = z217 * z217;
    const Scalar z222 = z25 + z221;
    const Scalar z225 = z24 - z224;
    const Scalar z229 = z216 * z227 + p_b * z226;
    const Scalar z233 = n2 * z232;
    const Scalar z236 = z234 + z235;
    const Scalar z238 = n2 * z231;
    const Scalar z240 = z235 - z239;
    const Scalar z243 = p_b * z237;  // force on plate, z
    const Scalar z223 = z216 * z216 - z222;
    const Scalar z241 = p_b * z233;  // force on plate, x
    const Scalar z242 = p_b * z236;  // force on plate, y
    const Scalar z245 = p_F * z237 + z29 * z238;  // moment on plate, y
    const Scalar z246 = p_b * z228 + p_F * z240 - z30 * z233;  // moment on plate, z
    const Scalar z230 = n9_81 * c_beta - s_beta * z229;
    const Scalar z247 = s_beta * z243 + c_beta * z242;
    const Scalar z249 = z228 - z241;  // force on foot, x
    const Scalar z244 = p_b * z230 - z148 * z237;  // moment on plate, x
    const Scalar z250 = z229 - z247;  // force on foot, y
    const Scalar z248 = s_beta * z245 + c_beta * z246;
    const Scalar z251 = z216 * z249 - z248;  // moment on turned, z
    const Scalar z252 = z215 * z250 + z244;
    const Scalar z253 = z251 + a_alpha * z223 - a_beta * z219;
    const Scalar z254 = z252 + a_alpha * z219 + a_beta * z225;
    forces.x = a_x;
    forces.y = a_y;
    forces.alpha = -z253;
    forces.beta = z254;
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
    const Scalar z24 = precomputed.z24;
    const Scalar z25 = precomputed.z25;
    const Scalar z26 = precomputed.z26;
    const Scalar z29 = precomputed.z29;
    const Scalar z30 = precomputed.z30;
    const Scalar z148 = precomputed.z148;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z264 = p_b * s_beta;
    const Scalar z269 = s_beta * z26;
    const Scalar z262 = s_beta * v_beta;
    const Scalar z263 = c_beta * v_beta;
    const Scalar z265 = p_b * c_beta;
    const Scalar z266 = v_alpha * s_beta;
    const Scalar z276 = v_alpha * v_alpha;
    const Scalar z267 = v_alpha * c_beta;
    const Scalar z284 = v_beta * v_beta;
    const Scalar z268 = s_beta * p_F;
    const Scalar z270 = s_beta * z269;
    const Scalar z273 = z264 * z264;
    const Scalar z275 = v_beta * z263;
    const Scalar z277 = n2 * v_alpha * p_b * z262;
    const Scalar z280 = v_beta * z267;  // angular acceleration of plate, y
    const Scalar z281 = v_beta * z266;  // angular acceleration of plate, z
    const Scalar z283 = z267 * z267;
    const Scalar z286 = z266 * z267;
    const Scalar z288 = z266 * z266;
    const Scalar z271 = z25 + z270;
    const Scalar z274 = z24 - z273;
    const Scalar z278 = z265 * z276 + p_b * z275;
    const Scalar z282 = n2 * z281;
    const Scalar z285 = z283 + z284;
    const Scalar z287 = n2 * z280;
    const Scalar z289 = z284 - z288;
    const Scalar z292 = p_b * z286;  // force on plate, z
    const Scalar z272 = z265 * z265 - z271;
    const Scalar z290 = p_b * z282;  // force on plate, x
    const Scalar z291 = p_b * z285;  // force on plate, y
    const Scalar z294 = p_F * z286 + z29 * z287;  // moment on plate, y
    const Scalar z295 = p_b * z277 + p_F * z289 - z30 * z282;  // moment on plate, z
    const Scalar z302 = n1 / z274;
    const Scalar z279 = n9_81 * c_beta - s_beta * z278;
    const Scalar z296 = s_beta * z292 + c_beta * z291;
    const Scalar z298 = z277 - z290;  // force on foot, x
    const Scalar z293 = p_b * z279 - z148 * z286;  // moment on plate, x
    const Scalar z299 = z278 - z296;  // force on foot, y
    const Scalar z297 = s_beta * z294 + c_beta * z295;
    const Scalar z300 = z265 * z298 - z297;  // moment on turned, z
    const Scalar z301 = z264 * z299 + z293;
    const Scalar z303 = z268 * z302;
    const Scalar z304 = z268 * z303 + z272;
    const Scalar z306 = z300 + z301 * z303;
    const Scalar z305 = n1 / z304;
    const Scalar z307 = z305 * z306;
    const Scalar z308 = z301 * z302 - z303 * z307;
    accelerations.x = n0;
    accelerations.y = n0;
    accelerations.alpha = -z307;
    accelerations.beta = -z308;
    if (!(traits::regular(-z304, -z272) && traits::regular(z274, z274))) return torsor::Status::singular;
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
    const Scalar z24 = precomputed.z24;
    const Scalar z25 = precomputed.z25;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = s_beta * v_beta;
    const Scalar z310 = v_x * s_alpha - v_y * c_alpha;
    const Scalar z35 = p_b * c_beta;
    const Scalar z309 = v_x * c_alpha + v_y * s_alpha;
    const Scalar z43 = v_alpha * s_beta;
    const Scalar z44 = v_alpha * c_beta;
    const Scalar z20 = p_b * s_beta;
    const Scalar z318 = v_beta * p_F + p_B * z43;
    const Scalar z311 = v_alpha * z35 + z309;
    const Scalar z312 = p_b * z16 - z310;  // velocity of foot, y
    const Scalar z313 = c_beta * z312;
    const Scalar z314 = s_beta * z312;
    const Scalar z315 = p_b * z44 - z311;
    const Scalar z319 = p_b * z311 - z25 * z44;
    const Scalar z316 = p_b * v_beta - z314;
    const Scalar z317 = p_b * z314 - v_beta * z24 - p_F * z43;
    result.kinetic = -n0_5 * (z311 * z315 - z43 * z318 - z313 * z313 + z44 * z319 + z314 * z316 + v_beta * z317);
    result.force_function = -n9_81 * z20;
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
    const Scalar z24 = precomputed.z24;
    const Scalar z25 = precomputed.z25;
    const Scalar z26 = precomputed.z26;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = s_beta * v_beta;
    const Scalar z310 = v_x * s_alpha - v_y * c_alpha;
    const Scalar z35 = p_b * c_beta;
    const Scalar z309 = v_x * c_alpha + v_y * s_alpha;
    const Scalar z94 = s_beta * z26;
    const Scalar z43 = v_alpha * s_beta;
    const Scalar z44 = v_alpha * c_beta;
    const Scalar z20 = p_b * s_beta;
    const Scalar z86 = s_beta * p_F;
    const Scalar z97 = s_beta * z94;
    const Scalar z318 = v_beta * p_F + p_B * z43;
    const Scalar z100 = z25 + z97;
    const Scalar z311 = v_alpha * z35 + z309;
    const Scalar z312 = p_b * z16 - z310;  // velocity of foot, y
    const Scalar z109 = z35 * z35 - z100;
    const Scalar z313 = c_beta * z312;
    const Scalar z314 = s_beta * z312;
    const Scalar z315 = p_b * z44 - z311;
    const Scalar z319 = p_b * z311 - z25 * z44;
    const Scalar z316 = p_b * v_beta - z314;
    const Scalar z317 = p_b * z314 - v_beta * z24 - p_F * z43;
    result.energy = -n0_5 * (z311 * z315 - z43 * z318 - z313 * z313 + z44 * z319 + z314 * z316 + v_beta * z317) + n9_81
        * z20;
    result.momentum_x = v_x;
    result.momentum_y = v_y;
    result.momentum_alpha = -v_alpha * z109 + v_beta * z86;
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
    const Scalar z29 = precomputed.z29;
    const Scalar z30 = precomputed.z30;
    const Scalar z174 = precomputed.z174;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z354 = v_alpha * s_beta;
    const Scalar z355 = v_alpha * c_beta;
    const Scalar z368 = a_alpha * c_beta;
    const Scalar z359 = v_beta * v_beta;
    const Scalar z367 = a_alpha * s_beta;
    const Scalar z352 = s_beta * v_beta;
    const Scalar z365 = a_x * c_alpha + a_y * s_alpha;
    const Scalar z353 = p_b * c_beta;
    const Scalar z356 = v_beta * z355;  // angular acceleration of plate, y
    const Scalar z357 = v_beta * z354;  // angular acceleration of plate, z
    const Scalar z358 = z355 * z355;
    const Scalar z361 = z354 * z355;
    const Scalar z362 = z354 * z354;
    const Scalar z369 = v_beta * z355 + z367;  // angular acceleration of plate, y
    const Scalar z370 = v_beta * z354 - z368;  // angular acceleration of plate, z
    const Scalar z360 = z358 + z359;
    const Scalar z363 = z359 - z362;
    const Scalar z372 = a_beta + z361;
    const Scalar z366 = v_alpha * z174 * z352 - z365 - a_alpha * z353;
    const Scalar z371 = z357 + z370;
    const Scalar z373 = z356 + z369;
    const Scalar z364 = p_b * z360;  // force on plate, y
    const Scalar z374 = p_b * z372;  // force on plate, z
    const Scalar z375 = p_F * z372 + z29 * z373;  // moment on plate, y
    const Scalar z377 = c_beta * z374 - s_beta * z364;
    const Scalar z376 = p_F * z363 - z30 * z371 + p_b * z366;  // moment on plate, z
    const Scalar z379 = n9_81 + z377;  // force on foot, z
    const Scalar z378 = c_beta * z375 - s_beta * z376;
    result.N = z379;
    result.moment = z378;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
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
    const Scalar z24 = precomputed.z24;
    const Scalar z25 = precomputed.z25;
    const Scalar z26 = precomputed.z26;
    const Scalar z29 = precomputed.z29;
    const Scalar z30 = precomputed.z30;
    const Scalar z148 = precomputed.z148;
    const Scalar z174 = precomputed.z174;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z460 = c_beta * v_beta;
    const Scalar z463 = v_alpha * s_beta;
    const Scalar z459 = s_beta * v_beta;
    const Scalar z464 = v_alpha * c_beta;
    const Scalar z461 = p_b * s_beta;
    const Scalar z462 = p_b * c_beta;
    const Scalar z475 = v_alpha * v_alpha;
    const Scalar z483 = v_beta * v_beta;
    const Scalar z467 = s_beta * z26;
    const Scalar z518 = n2 * v_alpha;
    const Scalar z466 = s_beta * p_F;
    const Scalar z468 = c_beta * z26;
    const Scalar z465 = c_beta * p_F;
    const Scalar z528 = n2 * v_alpha * p_b * s_beta;
    const Scalar z469 = s_beta * z467;
    const Scalar z472 = z461 * z461;
    const Scalar z474 = v_beta * z460;
    const Scalar z476 = n2 * v_alpha * p_b * z459;
    const Scalar z479 = v_beta * z464;  // angular acceleration of plate, y
    const Scalar z480 = v_beta * z463;  // angular acceleration of plate, z
    const Scalar z482 = z464 * z464;
    const Scalar z485 = z463 * z464;
    const Scalar z487 = z463 * z463;
    const Scalar z507 = z174 * z459;
    const Scalar z508 = n2 * z459;
    const Scalar z511 = n2 * s_beta * z463;
    const Scalar z513 = c_beta * z463 + s_beta * z464;
    const Scalar z514 = n2 * z460;
    const Scalar z519 = z462 * z518;
    const Scalar z520 = n2 * c_beta * z464;
    const Scalar z529 = n2 * z463;
    const Scalar z470 = z25 + z469;
    const Scalar z473 = z24 - z472;
    const Scalar z477 = z462 * z475 + p_b * z474;
    const Scalar z481 = n2 * z480;
    const Scalar z484 = z482 + z483;
    const Scalar z486 = n2 * z479;
    const Scalar z488 = z483 - z487;
    const Scalar z491 = p_b * z485;  // force on plate, z
    const Scalar z509 = p_b * z508;
    const Scalar z512 = p_b * z507 - p_F * z511 - z30 * z508;
    const Scalar z521 = p_b * z520;
    const Scalar z525 = s_beta * z519;
    const Scalar z530 = p_b * z529;
    const Scalar z471 = z462 * z462 - z470;
    const Scalar z532 = n2 * v_beta;
    const Scalar z534 = n2 * z464;
    const Scalar z533 = p_F * z532 + p_b * z528 - z30 * z529;
    const Scalar z535 = z29 * z534;
    const Scalar z489 = p_b * z481;  // force on plate, x
    const Scalar z490 = p_b * z484;  // force on plate, y
    const Scalar z493 = p_F * z485 + z29 * z486;  // moment on plate, y
    const Scalar z494 = p_b * z476 + p_F * z488 - z30 * z481;  // moment on plate, z
    const Scalar z503 = n1 / z473;
    const Scalar z510 = z507 - z509;
    const Scalar z531 = z528 - z530;
    const Scalar z478 = n9_81 * c_beta - s_beta * z477;
    const Scalar z545 = z464 * z529;
    const Scalar z547 = z482 - z487;
    const Scalar z538 = c_beta * z467 + s_beta * z468;
    const Scalar z542 = n2 * v_alpha * p_b * z460;
    const Scalar z536 = s_beta * z535 + c_beta * z533;
    const Scalar z497 = z476 - z489;  // force on foot, x
    const Scalar z548 = p_F * z547 - z29 * z481;
    const Scalar z492 = p_b * z478 - z148 * z485;  // moment on plate, x
    const Scalar z537 = z462 * z531 - z536;
    const Scalar z553 = p_b * z532;
    const Scalar z554 = c_beta * z553;
    const Scalar z526 = p_b * z525 + z148 * z513;
    const Scalar z546 = p_b * z542 - p_F * z545 - z30 * z486;
    const Scalar z549 = c_beta * (z493 + z546) - s_beta * (z494 - z548);
    const Scalar z496 = s_beta * z493 + c_beta * z494;
    const Scalar z543 = p_b * z486;
    const Scalar z544 = z542 - z543;
    const Scalar z499 = z462 * z497 - z496;  // moment on turned, z
    const Scalar z495 = s_beta * z491 + c_beta * z490;
    const Scalar z498 = z477 - z495;  // force on foot, y
    const Scalar z501 = z499 + a_alpha * z471 - a_beta * z466;
    const Scalar z550 = z549 + z461 * z497 - z462 * z544;
    const Scalar z500 = z461 * z498 + z492;
    const Scalar z560 = v_beta * z459;
    const Scalar z561 = z461 * z475 + p_b * z560;
    const Scalar z502 = z500 + a_alpha * z466 + a_beta * z473;
    const Scalar z562 = p_b * z545;
    const Scalar z563 = p_b * z547;
    const Scalar z539 = z461 * z462;
    const Scalar z540 = n2 * z539;
    const Scalar z504 = z466 * z503;
    const Scalar z564 = c_beta * (z491 - z562) - s_beta * (z490 - z563);
    const Scalar z505 = z466 * z504 + z471;
    const Scalar z541 = z538 + z540;
    const Scalar z559 = n2 * (z461 * z462 - z540);
    const Scalar z551 = z550 + a_beta * z465 + a_alpha * z541;
    const Scalar z506 = n1 / z505;
    const Scalar z566 = c_beta * z477 + s_beta * (n9_81 - z561);
    const Scalar z567 = z148 * z547 + p_b * z566;
    const Scalar z565 = z561 + z564;
    const Scalar z515 = z29 * z514 + p_F * z513;
    const Scalar z516 = s_beta * z515 + c_beta * z512;
    const Scalar z568 = z567 - z462 * z498 + z461 * z565;
    const Scalar z522 = p_b * z513;
    const Scalar z552 = p_b * z514;
    const Scalar z523 = c_beta * z521 + s_beta * z522;
    const Scalar z556 = s_beta * z552;
    const Scalar z555 = z552 - z554;
    const Scalar z517 = z462 * z510 - z516;
    const Scalar z524 = z519 - z523;
    const Scalar z557 = p_b * z556;
    const Scalar z569 = a_alpha * z465 - z568 + a_beta * z559;
    const Scalar z527 = z461 * z524 - z526;
    const Scalar z558 = z461 * z555 - z557;
    const Scalar z576 = z504 * z558 + z537;
    const Scalar z570 = z504 * z527 + z517;
    const Scalar z573 = z504 * z569 - z551;
    const Scalar z577 = z506 * z576;
    const Scalar z571 = z506 * z570;
    const Scalar z574 = z506 * z573;
    const Scalar z578 = z503 * z558 - z504 * z577;
    const Scalar z572 = z503 * z527 - z504 * z571;
    const Scalar z575 = z503 * z569 - z504 * z574;
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
    result.M[10] = -z471;
    result.M[11] = z466;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = z466;
    result.M[15] = z473;
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
    result.C[10] = -z517;
    result.C[11] = z527;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = -z537;
    result.C[15] = z558;
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
    result.K[14] = z551;
    result.K[15] = z569;
    result.F[0] = -a_x;
    result.F[1] = -a_y;
    result.F[2] = z501;
    result.F[3] = -z502;
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
    result.A[30] = -z574;
    result.A[31] = -z575;
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
    result.A[54] = -z571;
    result.A[55] = -z572;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n1;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = -z577;
    result.A[63] = -z578;
    if (!(traits::regular(-z505, -z471) && traits::regular(z473, z473))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[10] * result.M[11] * result.M[14] * result.M[15] * result.C[10] * result.C[11]
        * result.C[14] * result.C[15] * result.K[14] * result.K[15]) * (n0 * result.F[0] * result.F[1] * result.F[2]
        * result.F[3] * result.A[30] * result.A[31] * result.A[54] * result.A[55] * result.A[62] * result.A[63]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace falling_plate
