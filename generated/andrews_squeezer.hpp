// SPDX-License-Identifier: MIT
// andrews_squeezer: Andrews' squeezing mechanism: seven bodies, three loops
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation, residual, residual_jacobian
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function           additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                64               95          0             0                  7       0    173     173
//   mass_matrix                9                7          0             0                  3       0     22      24
//   bias                      20               35          1             1                  4       0     65      87
//   inverse_dynamics          73               92          1             1                  7       0    181     222
//   forward_dynamics         236              344         12             1                  7       0    607     661
//   energy                    29               50          0             1                  4       0     88      94
//   constraints               87              136          0             0                  7       0    237     249
//   linearisation            540              710         20             1                  7       0   1285    1495
//   residual                 131              198          1             1                  7       0    345     392
//   residual_jacobian        216              344          3             1                  7       0    578     739
//
// Not computed because this mechanism does not need it:
//   kinematics: of 315 results 201 vanish identically, 18 repeat another up to sign
//   mass_matrix: of 49 results 36 vanish identically, 3 repeat another up to sign
//   first_integrals: left out, 'motor' has no force function
//   constraints: of 60 results 20 vanish identically, 8 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 162 results 113 vanish identically, 3 repeat another up to sign
//   residual_jacobian: of 123 results 49 repeat another up to sign
//
// To write this file again:
//   andrews_squeezer_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,residual,residual_jacobian --output andrews_squeezer.hpp
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

namespace andrews_squeezer {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "andrews_squeezer";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x20e2854ab6e963baULL;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar beta;  ///< coordinate [rad or 1]
    Scalar Theta;  ///< coordinate [rad or 1]
    Scalar gamma;  ///< coordinate [rad or 1]
    Scalar Phi;  ///< coordinate [rad or 1]
    Scalar delta;  ///< coordinate [rad or 1]
    Scalar Omega;  ///< coordinate [rad or 1]
    Scalar epsilon;  ///< coordinate [rad or 1]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::beta, &Coordinates::Theta, &Coordinates::gamma,
          &Coordinates::Phi, &Coordinates::delta, &Coordinates::Omega, &Coordinates::epsilon};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar beta;  ///< its rate [rad/s]
    Scalar Theta;  ///< its rate [rad/s]
    Scalar gamma;  ///< its rate [rad/s]
    Scalar Phi;  ///< its rate [rad/s]
    Scalar delta;  ///< its rate [rad/s]
    Scalar Omega;  ///< its rate [rad/s]
    Scalar epsilon;  ///< its rate [rad/s]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::beta, &Velocities::Theta, &Velocities::gamma,
          &Velocities::Phi, &Velocities::delta, &Velocities::Omega, &Velocities::epsilon};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar beta;  ///< its second rate [rad/s^2]
    Scalar Theta;  ///< its second rate [rad/s^2]
    Scalar gamma;  ///< its second rate [rad/s^2]
    Scalar Phi;  ///< its second rate [rad/s^2]
    Scalar delta;  ///< its second rate [rad/s^2]
    Scalar Omega;  ///< its second rate [rad/s^2]
    Scalar epsilon;  ///< its second rate [rad/s^2]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::beta, &Accelerations::Theta, &Accelerations::gamma,
          &Accelerations::Phi, &Accelerations::delta, &Accelerations::Omega, &Accelerations::epsilon};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar beta;  ///< works with the rate of beta [N m]
    Scalar Theta;  ///< works with the rate of Theta [N m]
    Scalar gamma;  ///< works with the rate of gamma [N m]
    Scalar Phi;  ///< works with the rate of Phi [N m]
    Scalar delta;  ///< works with the rate of delta [N m]
    Scalar Omega;  ///< works with the rate of Omega [N m]
    Scalar epsilon;  ///< works with the rate of epsilon [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::beta, &GeneralizedForces::Theta,
          &GeneralizedForces::gamma, &GeneralizedForces::Phi, &GeneralizedForces::delta, &GeneralizedForces::Omega,
          &GeneralizedForces::epsilon};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_E3_x;  ///< of the constraint E3_x [N]
    Scalar lambda_E3_y;  ///< of the constraint E3_y [N]
    Scalar lambda_E4_x;  ///< of the constraint E4_x [N]
    Scalar lambda_E4_y;  ///< of the constraint E4_y [N]
    Scalar lambda_E6_x;  ///< of the constraint E6_x [N]
    Scalar lambda_E6_y;  ///< of the constraint E6_y [N]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_E3_x, &Multipliers::lambda_E3_y,
          &Multipliers::lambda_E4_x, &Multipliers::lambda_E4_y, &Multipliers::lambda_E6_x, &Multipliers::lambda_E6_y};
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
    const Scalar k1 = traits::constant(0.06171389001427645, 0.06171389f,
        "6171389001427644963589484580009627/100000000000000000000000000000000000");
    const Scalar k2 = traits::constant(0.45527981916307037, 0.45527983f,
        "4552798191630703802559123824490657/10000000000000000000000000000000000");
    const Scalar k3 = traits::constant(0.22266839016588588, 0.2226684f,
        "445336780331771769348946371218709/2000000000000000000000000000000000");
    const Scalar k4 = traits::constant(0.48736497954384256, 0.48736498f,
        "2436824897719212751127994767649241/5000000000000000000000000000000000");
    const Scalar k5 = traits::constant(0.22266839016588588, 0.2226684f,
        "2226683901658858846744731856093549/10000000000000000000000000000000000");
    const Scalar k6 = traits::constant(1.2305474445498212, 1.2305474f,
        "1230547444549821192497350155677741/1000000000000000000000000000000000");
    state.time = n0;
    state.q.beta = -k1;
    state.q.Theta = n0;
    state.q.gamma = k2;
    state.q.Phi = k3;
    state.q.delta = k4;
    state.q.Omega = -k5;
    state.q.epsilon = k6;
    state.v.beta = n0;
    state.v.Theta = n0;
    state.v.gamma = n0;
    state.v.Phi = n0;
    state.v.delta = n0;
    state.v.Omega = n0;
    state.v.epsilon = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> S1_position;  ///< centre of mass of S1 [m]
    std::array<Scalar, 9> S1_rotation;  ///< from the axes of S1 to the ground's (3 x 3)
    std::array<Scalar, 3> S1_velocity;  ///< velocity of the centre of mass of S1 [m/s]
    std::array<Scalar, 3> S1_angular_velocity;  ///< angular velocity of S1 [rad/s]
    std::array<Scalar, 3> S2_position;  ///< centre of mass of S2 [m]
    std::array<Scalar, 9> S2_rotation;  ///< from the axes of S2 to the ground's (3 x 3)
    std::array<Scalar, 3> S2_velocity;  ///< velocity of the centre of mass of S2 [m/s]
    std::array<Scalar, 3> S2_angular_velocity;  ///< angular velocity of S2 [rad/s]
    std::array<Scalar, 3> S3_position;  ///< centre of mass of S3 [m]
    std::array<Scalar, 9> S3_rotation;  ///< from the axes of S3 to the ground's (3 x 3)
    std::array<Scalar, 3> S3_velocity;  ///< velocity of the centre of mass of S3 [m/s]
    std::array<Scalar, 3> S3_angular_velocity;  ///< angular velocity of S3 [rad/s]
    std::array<Scalar, 3> S4_position;  ///< centre of mass of S4 [m]
    std::array<Scalar, 9> S4_rotation;  ///< from the axes of S4 to the ground's (3 x 3)
    std::array<Scalar, 3> S4_velocity;  ///< velocity of the centre of mass of S4 [m/s]
    std::array<Scalar, 3> S4_angular_velocity;  ///< angular velocity of S4 [rad/s]
    std::array<Scalar, 3> S5_position;  ///< centre of mass of S5 [m]
    std::array<Scalar, 9> S5_rotation;  ///< from the axes of S5 to the ground's (3 x 3)
    std::array<Scalar, 3> S5_velocity;  ///< velocity of the centre of mass of S5 [m/s]
    std::array<Scalar, 3> S5_angular_velocity;  ///< angular velocity of S5 [rad/s]
    std::array<Scalar, 3> S6_position;  ///< centre of mass of S6 [m]
    std::array<Scalar, 9> S6_rotation;  ///< from the axes of S6 to the ground's (3 x 3)
    std::array<Scalar, 3> S6_velocity;  ///< velocity of the centre of mass of S6 [m/s]
    std::array<Scalar, 3> S6_angular_velocity;  ///< angular velocity of S6 [rad/s]
    std::array<Scalar, 3> S7_position;  ///< centre of mass of S7 [m]
    std::array<Scalar, 9> S7_rotation;  ///< from the axes of S7 to the ground's (3 x 3)
    std::array<Scalar, 3> S7_velocity;  ///< velocity of the centre of mass of S7 [m/s]
    std::array<Scalar, 3> S7_angular_velocity;  ///< angular velocity of S7 [rad/s]
    std::array<Scalar, 3> C_position;  ///< position of C [m]
    std::array<Scalar, 3> C_velocity;  ///< velocity of the material point at C [m/s]
    std::array<Scalar, 21> C_jacobian;  ///< partial velocities of C (3 x 7)
    std::array<Scalar, 3> D_position;  ///< position of D [m]
    std::array<Scalar, 3> D_velocity;  ///< velocity of the material point at D [m/s]
    std::array<Scalar, 21> D_jacobian;  ///< partial velocities of D (3 x 7)
    std::array<Scalar, 3> E2_position;  ///< position of E2 [m]
    std::array<Scalar, 3> E2_velocity;  ///< velocity of the material point at E2 [m/s]
    std::array<Scalar, 21> E2_jacobian;  ///< partial velocities of E2 (3 x 7)
    std::array<Scalar, 3> E3_position;  ///< position of E3 [m]
    std::array<Scalar, 3> E3_velocity;  ///< velocity of the material point at E3 [m/s]
    std::array<Scalar, 21> E3_jacobian;  ///< partial velocities of E3 (3 x 7)
    std::array<Scalar, 3> E4_position;  ///< position of E4 [m]
    std::array<Scalar, 3> E4_velocity;  ///< velocity of the material point at E4 [m/s]
    std::array<Scalar, 21> E4_jacobian;  ///< partial velocities of E4 (3 x 7)
    std::array<Scalar, 3> E6_position;  ///< position of E6 [m]
    std::array<Scalar, 3> E6_velocity;  ///< velocity of the material point at E6 [m/s]
    std::array<Scalar, 21> E6_jacobian;  ///< partial velocities of E6 (3 x 7)
    std::array<Scalar, 3> F_position;  ///< position of F [m]
    std::array<Scalar, 3> F_velocity;  ///< velocity of the material point at F [m/s]
    std::array<Scalar, 21> F_jacobian;  ///< partial velocities of F (3 x 7)
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
    std::array<Scalar, 6> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 6> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 42> jacobian;  ///< A, stored column by column (6 x 7)
    std::array<Scalar, 6> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 49> M;  ///< mass matrix (7 x 7)
    std::array<Scalar, 49> C;  ///< damping and gyroscopic terms (7 x 7)
    std::array<Scalar, 49> K;  ///< stiffness (7 x 7)
    std::array<Scalar, 7> F;  ///< right-hand side
    std::array<Scalar, 1> M_r;  ///< reduced mass matrix
    std::array<Scalar, 1> C_r;  ///< reduced damping and gyroscopic terms
    std::array<Scalar, 1> K_r;  ///< reduced stiffness
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, w): x' = A x + B du (2 x 2)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 1;
  static constexpr int independent_coordinates[] = {0};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[] = {0};

  /// Derivatives of the residual in compressed rows.
  struct ResidualJacobian {
    std::array<Scalar, 123> values;  ///< entries, row by row
  };
  /// Where the values of ResidualJacobian stand: those of row i from row_start[i] to row_start[i + 1], each in its
  /// column: of unknown j by position j, by velocity n + j, by acceleration 2 n + j, by multiplier k 3 n + k.
  static constexpr int residual_jacobian_nonzeros = 123;
  static constexpr int residual_jacobian_row_start[] = {0, 12, 23, 27, 34, 42, 49, 57, 66, 75, 87, 99, 111, 123};
  static constexpr int residual_jacobian_column[] = {0, 1, 7, 8, 14, 15, 21, 22, 23, 24, 25, 26, 0, 1, 7, 14, 15, 21,
      22, 23, 24, 25, 26, 2, 16, 21, 22, 3, 4, 11, 17, 18, 23, 24, 3, 4, 10, 11, 17, 18, 23, 24, 5, 6, 13, 19, 20, 25,
      26, 5, 6, 12, 13, 19, 20, 25, 26, 0, 1, 2, 7, 8, 9, 14, 15, 16, 0, 1, 2, 7, 8, 9, 14, 15, 16, 0, 1, 3, 4, 7, 8,
      10, 11, 14, 15, 17, 18, 0, 1, 3, 4, 7, 8, 10, 11, 14, 15, 17, 18, 0, 1, 5, 6, 7, 8, 12, 13, 14, 15, 19, 20, 0, 1,
      5, 6, 7, 8, 12, 13, 14, 15, 19, 20};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k2 = traits::constant(0.01874, 0.01874f, "937/50000");
    const Scalar k3 = traits::constant(0.01043, 0.01043f, "1043/100000");
    const Scalar k4 = traits::constant(0.00916, 0.00916f, "229/25000");
    const Scalar k5 = traits::constant(0.02308, 0.02308f, "577/25000");
    const Scalar n0_0115 = traits::constant(0.0115, 0.0115f, "23/2000");
    const Scalar k7 = traits::constant(0.00579, 0.00579f, "579/100000");
    const Scalar k8 = traits::constant(0.00092, 0.00092f, "23/25000");
    const Scalar k9 = traits::constant(0.01228, 0.01228f, "307/25000");
    const Scalar k10 = traits::constant(0.00449, 0.00449f, "449/100000");
    const Scalar k11 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k12 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k17 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k18 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar z35 = q_beta + q_Theta;
    const Scalar z44 = q_delta + q_Phi;
    const Scalar z55 = q_epsilon + q_Omega;
    const Scalar angles_[] = {q_beta, q_gamma, q_delta, q_epsilon, z35, z44, z55};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar s_delta = sines_[2], c_delta = cosines_[2];
    const Scalar s_epsilon = sines_[3], c_epsilon = cosines_[3];
    const Scalar z36 = sines_[4], z37 = cosines_[4];
    const Scalar z45 = sines_[5], z46 = cosines_[5];
    const Scalar z56 = sines_[6], z57 = cosines_[6];
    const Scalar z40 = n0_007 * v_beta;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z51 = n0_04 * v_delta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z62 = n0_04 * v_epsilon;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z82 = k2 * v_gamma;
    const Scalar z83 = k3 * v_gamma;
    const Scalar z97 = k4 * v_delta;
    const Scalar z98 = k5 * v_delta;
    const Scalar z47 = n0_04 * c_delta;
    const Scalar z48 = n0_04 * s_delta;
    const Scalar z58 = n0_04 * s_epsilon;
    const Scalar z59 = n0_04 * c_epsilon;
    const Scalar z42 = s_beta * z40;  // velocity of K2, x
    const Scalar z43 = c_beta * z40;  // velocity of K2, y
    const Scalar z53 = s_delta * z51;  // velocity of K4, x
    const Scalar z54 = c_delta * z51;  // velocity of K4, y
    const Scalar z64 = c_epsilon * z62;  // velocity of K6, x
    const Scalar z65 = s_epsilon * z62;  // velocity of K6, y
    const Scalar z75 = n0_0115 * z41;
    const Scalar z90 = k7 * z52;
    const Scalar z38 = n0_007 * c_beta;
    const Scalar z66 = k8 * c_beta;
    const Scalar z67 = k8 * s_beta;
    const Scalar z84 = s_gamma * z83 - c_gamma * z82;
    const Scalar z85 = s_gamma * z82 + c_gamma * z83;
    const Scalar z39 = n0_007 * s_beta;
    const Scalar z105 = k7 * z63;
    const Scalar z99 = s_delta * z98 + c_delta * z97;
    const Scalar z100 = s_delta * z97 - c_delta * z98;
    const Scalar z68 = k8 * v_beta;
    const Scalar z71 = n0_0115 * z37;
    const Scalar z69 = s_beta * z68;
    const Scalar z70 = c_beta * z68;
    const Scalar z72 = n0_0115 * z36;
    const Scalar z78 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z79 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z86 = k7 * z45;
    const Scalar z87 = k7 * z46;
    const Scalar z93 = k4 * s_delta - k5 * c_delta;
    const Scalar z94 = k5 * s_delta + k4 * c_delta;
    const Scalar z101 = k7 * z57;
    const Scalar z102 = k7 * z56;
    const Scalar z108 = k9 * s_epsilon - k10 * c_epsilon;
    const Scalar z109 = k10 * s_epsilon + k9 * c_epsilon;
    const Scalar z49 = k11 - z47;  // place of K4, x
    const Scalar z112 = k9 * v_epsilon;
    const Scalar z50 = k12 - z48;  // place of K4, y
    const Scalar z113 = k10 * v_epsilon;
    const Scalar z114 = s_epsilon * z113 + c_epsilon * z112;
    const Scalar z115 = s_epsilon * z112 - c_epsilon * z113;
    const Scalar z118 = n0_018 * v_gamma;
    const Scalar z119 = n0_02 * v_gamma;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z60 = k11 - z58;  // place of K6, x
    const Scalar z120 = s_gamma * z119 - c_gamma * z118;
    const Scalar z61 = k12 + z59;  // place of K6, y
    const Scalar z121 = s_gamma * z118 + c_gamma * z119;
    const Scalar z126 = n0_028 * z41;
    const Scalar z124 = n0_028 * z37;
    const Scalar z125 = n0_028 * z36;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z76 = z36 * z75 - z42;
    const Scalar z77 = z37 * z75 - z43;
    const Scalar z127 = z36 * z126 - z42;
    const Scalar z128 = z37 * z126 - z43;
    const Scalar z73 = z38 - z71;
    const Scalar z129 = z38 - z124;
    const Scalar z74 = z39 - z72;
    const Scalar z130 = z39 - z125;
    const Scalar z80 = k17 - z78;
    const Scalar z81 = k18 + z79;
    const Scalar z88 = z49 - z86;
    const Scalar z89 = z50 + z87;
    const Scalar z95 = k11 + z93;
    const Scalar z96 = k12 - z94;
    const Scalar z103 = z60 - z101;
    const Scalar z104 = z61 - z102;
    const Scalar z110 = k11 - z108;
    const Scalar z111 = k12 + z109;
    const Scalar z140 = n0_02 * z52;
    const Scalar z151 = n0_02 * z63;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z122 = k17 - z116;
    const Scalar z133 = n0_035 * v_gamma;
    const Scalar z123 = k18 + z117;
    const Scalar z138 = n0_02 * z45;
    const Scalar z136 = k17 - z131;
    const Scalar z139 = n0_02 * z46;
    const Scalar z137 = k18 - z132;
    const Scalar z149 = n0_02 * z57;
    const Scalar z143 = z49 - z138;
    const Scalar z150 = n0_02 * z56;
    const Scalar z145 = z47 + z138;
    const Scalar z91 = z46 * z90 - z53;
    const Scalar z92 = z45 * z90 + z54;
    const Scalar z106 = z56 * z105 - z64;
    const Scalar z107 = z57 * z105 + z65;
    const Scalar z134 = c_gamma * z133;
    const Scalar z135 = s_gamma * z133;
    const Scalar z141 = z46 * z140 - z53;
    const Scalar z142 = z45 * z140 + z54;
    const Scalar z144 = z50 + z139;
    const Scalar z146 = z48 - z139;
    const Scalar z152 = z56 * z151 - z64;
    const Scalar z153 = z57 * z151 + z65;
    const Scalar z154 = z60 - z149;
    const Scalar z155 = z61 - z150;
    const Scalar z156 = z58 + z149;
    const Scalar z157 = z59 - z150;
    result.S1_position[0] = z66;
    result.S1_position[1] = z67;
    result.S1_position[2] = n0;
    result.S1_rotation[0] = c_beta;
    result.S1_rotation[1] = s_beta;
    result.S1_rotation[2] = n0;
    result.S1_rotation[3] = -s_beta;
    result.S1_rotation[4] = c_beta;
    result.S1_rotation[5] = n0;
    result.S1_rotation[6] = n0;
    result.S1_rotation[7] = n0;
    result.S1_rotation[8] = n1;
    result.S1_velocity[0] = -z69;
    result.S1_velocity[1] = z70;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_beta;
    result.S2_position[0] = z73;
    result.S2_position[1] = z74;
    result.S2_position[2] = n0;
    result.S2_rotation[0] = z37;
    result.S2_rotation[1] = z36;
    result.S2_rotation[2] = n0;
    result.S2_rotation[3] = -z36;
    result.S2_rotation[4] = z37;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = n0;
    result.S2_rotation[7] = n0;
    result.S2_rotation[8] = n1;
    result.S2_velocity[0] = z76;
    result.S2_velocity[1] = -z77;
    result.S2_velocity[2] = n0;
    result.S2_angular_velocity[0] = n0;
    result.S2_angular_velocity[1] = n0;
    result.S2_angular_velocity[2] = z41;
    result.S3_position[0] = -z80;
    result.S3_position[1] = z81;
    result.S3_position[2] = n0;
    result.S3_rotation[0] = c_gamma;
    result.S3_rotation[1] = s_gamma;
    result.S3_rotation[2] = n0;
    result.S3_rotation[3] = -s_gamma;
    result.S3_rotation[4] = c_gamma;
    result.S3_rotation[5] = n0;
    result.S3_rotation[6] = n0;
    result.S3_rotation[7] = n0;
    result.S3_rotation[8] = n1;
    result.S3_velocity[0] = -z84;
    result.S3_velocity[1] = z85;
    result.S3_velocity[2] = n0;
    result.S3_angular_velocity[0] = n0;
    result.S3_angular_velocity[1] = n0;
    result.S3_angular_velocity[2] = v_gamma;
    result.S4_position[0] = -z88;
    result.S4_position[1] = -z89;
    result.S4_position[2] = n0;
    result.S4_rotation[0] = z46;
    result.S4_rotation[1] = z45;
    result.S4_rotation[2] = n0;
    result.S4_rotation[3] = -z45;
    result.S4_rotation[4] = z46;
    result.S4_rotation[5] = n0;
    result.S4_rotation[6] = n0;
    result.S4_rotation[7] = n0;
    result.S4_rotation[8] = n1;
    result.S4_velocity[0] = z91;
    result.S4_velocity[1] = z92;
    result.S4_velocity[2] = n0;
    result.S4_angular_velocity[0] = n0;
    result.S4_angular_velocity[1] = n0;
    result.S4_angular_velocity[2] = z52;
    result.S5_position[0] = -z95;
    result.S5_position[1] = -z96;
    result.S5_position[2] = n0;
    result.S5_rotation[0] = c_delta;
    result.S5_rotation[1] = s_delta;
    result.S5_rotation[2] = n0;
    result.S5_rotation[3] = -s_delta;
    result.S5_rotation[4] = c_delta;
    result.S5_rotation[5] = n0;
    result.S5_rotation[6] = n0;
    result.S5_rotation[7] = n0;
    result.S5_rotation[8] = n1;
    result.S5_velocity[0] = -z99;
    result.S5_velocity[1] = -z100;
    result.S5_velocity[2] = n0;
    result.S5_angular_velocity[0] = n0;
    result.S5_angular_velocity[1] = n0;
    result.S5_angular_velocity[2] = v_delta;
    result.S6_position[0] = -z103;
    result.S6_position[1] = -z104;
    result.S6_position[2] = n0;
    result.S6_rotation[0] = z57;
    result.S6_rotation[1] = z56;
    result.S6_rotation[2] = n0;
    result.S6_rotation[3] = -z56;
    result.S6_rotation[4] = z57;
    result.S6_rotation[5] = n0;
    result.S6_rotation[6] = n0;
    result.S6_rotation[7] = n0;
    result.S6_rotation[8] = n1;
    result.S6_velocity[0] = -z106;
    result.S6_velocity[1] = z107;
    result.S6_velocity[2] = n0;
    result.S6_angular_velocity[0] = n0;
    result.S6_angular_velocity[1] = n0;
    result.S6_angular_velocity[2] = z63;
    result.S7_position[0] = -z110;
    result.S7_position[1] = -z111;
    result.S7_position[2] = n0;
    result.S7_rotation[0] = c_epsilon;
    result.S7_rotation[1] = s_epsilon;
    result.S7_rotation[2] = n0;
    result.S7_rotation[3] = -s_epsilon;
    result.S7_rotation[4] = c_epsilon;
    result.S7_rotation[5] = n0;
    result.S7_rotation[6] = n0;
    result.S7_rotation[7] = n0;
    result.S7_rotation[8] = n1;
    result.S7_velocity[0] = z114;
    result.S7_velocity[1] = z115;
    result.S7_velocity[2] = n0;
    result.S7_angular_velocity[0] = n0;
    result.S7_angular_velocity[1] = n0;
    result.S7_angular_velocity[2] = v_epsilon;
    result.C_position[0] = n0_014;
    result.C_position[1] = n0_072;
    result.C_position[2] = n0;
    result.C_velocity[0] = n0;
    result.C_velocity[1] = n0;
    result.C_velocity[2] = n0;
    result.C_jacobian[0] = n0;
    result.C_jacobian[3] = n0;
    result.C_jacobian[6] = n0;
    result.C_jacobian[9] = n0;
    result.C_jacobian[12] = n0;
    result.C_jacobian[15] = n0;
    result.C_jacobian[18] = n0;
    result.C_jacobian[1] = n0;
    result.C_jacobian[4] = n0;
    result.C_jacobian[7] = n0;
    result.C_jacobian[10] = n0;
    result.C_jacobian[13] = n0;
    result.C_jacobian[16] = n0;
    result.C_jacobian[19] = n0;
    result.C_jacobian[2] = n0;
    result.C_jacobian[5] = n0;
    result.C_jacobian[8] = n0;
    result.C_jacobian[11] = n0;
    result.C_jacobian[14] = n0;
    result.C_jacobian[17] = n0;
    result.C_jacobian[20] = n0;
    result.D_position[0] = -z122;
    result.D_position[1] = z123;
    result.D_position[2] = n0;
    result.D_velocity[0] = -z120;
    result.D_velocity[1] = z121;
    result.D_velocity[2] = n0;
    result.D_jacobian[0] = n0;
    result.D_jacobian[3] = n0;
    result.D_jacobian[6] = -z117;
    result.D_jacobian[9] = n0;
    result.D_jacobian[12] = n0;
    result.D_jacobian[15] = n0;
    result.D_jacobian[18] = n0;
    result.D_jacobian[1] = n0;
    result.D_jacobian[4] = n0;
    result.D_jacobian[7] = z116;
    result.D_jacobian[10] = n0;
    result.D_jacobian[13] = n0;
    result.D_jacobian[16] = n0;
    result.D_jacobian[19] = n0;
    result.D_jacobian[2] = n0;
    result.D_jacobian[5] = n0;
    result.D_jacobian[8] = n0;
    result.D_jacobian[11] = n0;
    result.D_jacobian[14] = n0;
    result.D_jacobian[17] = n0;
    result.D_jacobian[20] = n0;
    result.E2_position[0] = z129;
    result.E2_position[1] = z130;
    result.E2_position[2] = n0;
    result.E2_velocity[0] = z127;
    result.E2_velocity[1] = -z128;
    result.E2_velocity[2] = n0;
    result.E2_jacobian[0] = -z130;
    result.E2_jacobian[3] = z125;
    result.E2_jacobian[6] = n0;
    result.E2_jacobian[9] = n0;
    result.E2_jacobian[12] = n0;
    result.E2_jacobian[15] = n0;
    result.E2_jacobian[18] = n0;
    result.E2_jacobian[1] = z129;
    result.E2_jacobian[4] = -z124;
    result.E2_jacobian[7] = n0;
    result.E2_jacobian[10] = n0;
    result.E2_jacobian[13] = n0;
    result.E2_jacobian[16] = n0;
    result.E2_jacobian[19] = n0;
    result.E2_jacobian[2] = n0;
    result.E2_jacobian[5] = n0;
    result.E2_jacobian[8] = n0;
    result.E2_jacobian[11] = n0;
    result.E2_jacobian[14] = n0;
    result.E2_jacobian[17] = n0;
    result.E2_jacobian[20] = n0;
    result.E3_position[0] = -z136;
    result.E3_position[1] = z137;
    result.E3_position[2] = n0;
    result.E3_velocity[0] = z134;
    result.E3_velocity[1] = z135;
    result.E3_velocity[2] = n0;
    result.E3_jacobian[0] = n0;
    result.E3_jacobian[3] = n0;
    result.E3_jacobian[6] = z132;
    result.E3_jacobian[9] = n0;
    result.E3_jacobian[12] = n0;
    result.E3_jacobian[15] = n0;
    result.E3_jacobian[18] = n0;
    result.E3_jacobian[1] = n0;
    result.E3_jacobian[4] = n0;
    result.E3_jacobian[7] = z131;
    result.E3_jacobian[10] = n0;
    result.E3_jacobian[13] = n0;
    result.E3_jacobian[16] = n0;
    result.E3_jacobian[19] = n0;
    result.E3_jacobian[2] = n0;
    result.E3_jacobian[5] = n0;
    result.E3_jacobian[8] = n0;
    result.E3_jacobian[11] = n0;
    result.E3_jacobian[14] = n0;
    result.E3_jacobian[17] = n0;
    result.E3_jacobian[20] = n0;
    result.E4_position[0] = -z143;
    result.E4_position[1] = -z144;
    result.E4_position[2] = n0;
    result.E4_velocity[0] = z141;
    result.E4_velocity[1] = z142;
    result.E4_velocity[2] = n0;
    result.E4_jacobian[0] = n0;
    result.E4_jacobian[3] = n0;
    result.E4_jacobian[6] = n0;
    result.E4_jacobian[9] = z139;
    result.E4_jacobian[12] = -z146;
    result.E4_jacobian[15] = n0;
    result.E4_jacobian[18] = n0;
    result.E4_jacobian[1] = n0;
    result.E4_jacobian[4] = n0;
    result.E4_jacobian[7] = n0;
    result.E4_jacobian[10] = z138;
    result.E4_jacobian[13] = z145;
    result.E4_jacobian[16] = n0;
    result.E4_jacobian[19] = n0;
    result.E4_jacobian[2] = n0;
    result.E4_jacobian[5] = n0;
    result.E4_jacobian[8] = n0;
    result.E4_jacobian[11] = n0;
    result.E4_jacobian[14] = n0;
    result.E4_jacobian[17] = n0;
    result.E4_jacobian[20] = n0;
    result.E6_position[0] = -z154;
    result.E6_position[1] = -z155;
    result.E6_position[2] = n0;
    result.E6_velocity[0] = -z152;
    result.E6_velocity[1] = z153;
    result.E6_velocity[2] = n0;
    result.E6_jacobian[0] = n0;
    result.E6_jacobian[3] = n0;
    result.E6_jacobian[6] = n0;
    result.E6_jacobian[9] = n0;
    result.E6_jacobian[12] = n0;
    result.E6_jacobian[15] = -z150;
    result.E6_jacobian[18] = z157;
    result.E6_jacobian[1] = n0;
    result.E6_jacobian[4] = n0;
    result.E6_jacobian[7] = n0;
    result.E6_jacobian[10] = n0;
    result.E6_jacobian[13] = n0;
    result.E6_jacobian[16] = z149;
    result.E6_jacobian[19] = z156;
    result.E6_jacobian[2] = n0;
    result.E6_jacobian[5] = n0;
    result.E6_jacobian[8] = n0;
    result.E6_jacobian[11] = n0;
    result.E6_jacobian[14] = n0;
    result.E6_jacobian[17] = n0;
    result.E6_jacobian[20] = n0;
    result.F_position[0] = z38;
    result.F_position[1] = z39;
    result.F_position[2] = n0;
    result.F_velocity[0] = -z42;
    result.F_velocity[1] = z43;
    result.F_velocity[2] = n0;
    result.F_jacobian[0] = -z39;
    result.F_jacobian[3] = n0;
    result.F_jacobian[6] = n0;
    result.F_jacobian[9] = n0;
    result.F_jacobian[12] = n0;
    result.F_jacobian[15] = n0;
    result.F_jacobian[18] = n0;
    result.F_jacobian[1] = z38;
    result.F_jacobian[4] = n0;
    result.F_jacobian[7] = n0;
    result.F_jacobian[10] = n0;
    result.F_jacobian[13] = n0;
    result.F_jacobian[16] = n0;
    result.F_jacobian[19] = n0;
    result.F_jacobian[2] = n0;
    result.F_jacobian[5] = n0;
    result.F_jacobian[8] = n0;
    result.F_jacobian[11] = n0;
    result.F_jacobian[14] = n0;
    result.F_jacobian[17] = n0;
    result.F_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 49>& mass) noexcept {
    const Scalar k0 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k1 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k2 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k4 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k7 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k8 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k9 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k11 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_Theta = state.q.Theta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar q_Omega = state.q.Omega;
    const Scalar angles_[] = {q_Theta, q_Phi, q_Omega};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_Theta = cosines_[0];
    const Scalar s_Phi = sines_[1];
    const Scalar s_Omega = sines_[2];
    const Scalar z160 = k0 * s_Omega;
    const Scalar z177 = k0 * s_Phi;
    const Scalar z193 = k1 * c_Theta;
    const Scalar z162 = k2 - z160;
    const Scalar z170 = k2 - n2 * z160;
    const Scalar z178 = k2 + z177;
    const Scalar z186 = k2 + n2 * z177;
    const Scalar z194 = k4 - n0_175 * z193;
    const Scalar z202 = k4 - n0_35 * z193;
    const Scalar z175 = k7 + z170;
    const Scalar z191 = k8 + z186;
    const Scalar z205 = k9 + z202;
    mass[0] = z205;
    mass[1] = z194;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = z194;
    mass[8] = k4;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k11;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = k2;
    mass[25] = z178;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = z178;
    mass[32] = z191;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k2;
    mass[41] = z162;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = z162;
    mass[48] = z175;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k3 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar k4 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k6 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k8 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k9 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_Theta, q_gamma, q_Phi, q_Omega};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_Theta = sines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar c_Phi = cosines_[2];
    const Scalar c_Omega = cosines_[3];
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z214 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z255 = z41 * z41;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z215 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z256 = k4 * z255;  // force on K2, times 0.04 m, x
    const Scalar z227 = n0_175 * z226;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z236 = z63 * z63;
    const Scalar z244 = z52 * z52;
    const Scalar z259 = s_Theta * z256;
    const Scalar z229 = s_Theta * z227;
    const Scalar z231 = c_Phi * z230;
    const Scalar z235 = c_Omega * z233;
    const Scalar z237 = k6 * z236;  // force on K6, times 0.04 m, x
    const Scalar z245 = k6 * z244;  // force on K4, times 0.04 m, y
    const Scalar z239 = c_Omega * z237;
    const Scalar z248 = c_Phi * z245;
    const Scalar z238 = k6 * z235;  // moment on K6, z
    const Scalar z246 = k6 * z231;  // moment on K4, z
    const Scalar z257 = k4 * z229;  // moment on K2, z
    const Scalar z243 = z238 - z239;  // moment on K7, z
    const Scalar z251 = z246 - z248;  // moment on K5, z
    const Scalar z261 = n0_033 - n0_175 * z259 + z257;  // moment on K1, z
    const Scalar z122 = k8 - z116;
    const Scalar z123 = k9 + z117;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z220 = n1 / z219;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z223 = z216 * z221;
    const Scalar z224 = z217 * z221;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    forces.beta = -z261;
    forces.Theta = -z257;
    forces.gamma = z225;
    forces.Phi = -z246;
    forces.delta = -z251;
    forces.Omega = z238;
    forces.epsilon = z243;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k3 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k5 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k6 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k11 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k12 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k13 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k14 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k17 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k18 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k20 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k24 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z428 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z429 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z425 = v_beta + v_Theta;
    const Scalar z447 = v_beta * v_beta;
    const Scalar z426 = v_delta + v_Phi;
    const Scalar z427 = v_epsilon + v_Omega;
    const Scalar z436 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z448 = n0_175 * z447;
    const Scalar z455 = z425 * z425;
    const Scalar z461 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z463 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z437 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z450 = v_epsilon * v_epsilon;
    const Scalar z451 = z427 * z427;
    const Scalar z453 = z426 * z426;
    const Scalar z456 = k5 * z455;  // force on K2, times 0.04 m, x
    const Scalar z457 = n0_175 * a_beta;
    const Scalar z459 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z464 = k6 * z463;  // force on K6, times 0.04 m, y
    const Scalar z468 = k6 * z461;  // force on K4, times 0.04 m, x
    const Scalar z449 = v_delta * v_delta;
    const Scalar z452 = k6 * z451;  // force on K6, times 0.04 m, x
    const Scalar z454 = k6 * z453;  // force on K4, times 0.04 m, y
    const Scalar z473 = k5 * z459;  // force on K2, times 0.04 m, y
    const Scalar z458 = s_Theta * z448 + c_Theta * z457;
    const Scalar z462 = a_epsilon * s_Omega - c_Omega * z450;
    const Scalar z460 = a_delta * s_Phi - c_Phi * z449;
    const Scalar z466 = s_Omega * z464 + c_Omega * z452;
    const Scalar z470 = s_Phi * z468 + c_Phi * z454;
    const Scalar z475 = s_Theta * z456 - c_Theta * z473;
    const Scalar z477 = n0_028 * c_Theta;
    const Scalar z478 = n0_028 * s_Theta;
    const Scalar z486 = n0_02 * s_Phi;
    const Scalar z487 = n0_02 * c_Phi;
    const Scalar z432 = n0_035 * s_gamma;
    const Scalar z433 = n0_035 * c_gamma;
    const Scalar z479 = n0_007 - z477;
    const Scalar z480 = s_beta * z478;
    const Scalar z482 = c_beta * z478;
    const Scalar z488 = n0_04 + z486;
    const Scalar z489 = s_delta * z487;
    const Scalar z481 = c_beta * z479 + z480;
    const Scalar z483 = s_beta * z479 - z482;
    const Scalar z484 = s_beta * z477 + z482;
    const Scalar z485 = c_beta * z477 - z480;
    const Scalar z430 = k11 - z428;
    const Scalar z490 = c_delta * z488 + z489;
    const Scalar z431 = k12 + z429;
    const Scalar z491 = c_delta * z487;
    const Scalar z492 = s_delta * z488 - z491;
    const Scalar z493 = s_delta * z486 - z491;
    const Scalar z438 = n0_02 - z436;
    const Scalar z439 = n0_018 - z437;
    const Scalar z465 = k6 * z462 - k13 * z463;  // moment on K6, z
    const Scalar z469 = k13 * z461 + k6 * z460;  // moment on K4, z
    const Scalar z474 = k5 * z458 - k14 * z459;  // moment on K2, z
    const Scalar z434 = n0_014 + z430;
    const Scalar z494 = c_delta * z486 + z489;
    const Scalar z435 = n0_072 - z431;
    const Scalar z495 = n0_02 * c_Omega;
    const Scalar z496 = n0_02 * s_Omega;
    const Scalar z497 = n0_04 - z496;
    const Scalar z498 = c_epsilon * z495;
    const Scalar z499 = s_epsilon * z497 + z498;
    const Scalar z471 = k17 * a_delta + z470 + z469;  // moment on K5, z
    const Scalar z440 = z434 * z434 + z435 * z435;
    const Scalar z500 = s_epsilon * z495;
    const Scalar z467 = k18 * a_epsilon - z466 - z465;  // moment on K7, z
    const Scalar z476 = n0_033 - k20 * a_beta - n0_175 * z475 + z474;  // moment on K1, z
    const Scalar z441 = traits::sqrt(z440);
    const Scalar z501 = c_epsilon * z497 - z500;
    const Scalar z442 = n1 / z441;
    const Scalar z502 = c_epsilon * z496 + z500;
    const Scalar z443 = n4530 - n352_6605 * z442;
    const Scalar z503 = s_epsilon * z496 - z498;
    const Scalar z444 = z438 * z443;
    const Scalar z445 = z439 * z443;
    const Scalar z446 = n0_018 * z444 - n0_02 * z445;
    const Scalar z472 = k24 * a_gamma + z446;  // moment on K3, z
    forces.beta = z483 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z476 - z481 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    forces.Theta = -z474 - z484 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z485 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    forces.gamma = z472 + l_lambda_E3_x * z433 + l_lambda_E3_y * z432;
    forces.Phi = -l_lambda_E4_x * z493 + z469 + l_lambda_E4_y * z494;
    forces.delta = -l_lambda_E4_x * z492 + z471 + l_lambda_E4_y * z490;
    forces.Omega = -z465 - l_lambda_E6_x * z502 - l_lambda_E6_y * z503;
    forces.epsilon = z467 + l_lambda_E6_x * z501 + l_lambda_E6_y * z499;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar k0 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k1 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k7 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k8 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k11 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k15 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k16 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k17 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k18 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k19 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k26 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k27 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z667 = k0 * s_Omega;
    const Scalar z675 = k1 * c_Theta;
    const Scalar z714 = n0_028 * c_Theta;
    const Scalar z715 = n0_028 * s_Theta;
    const Scalar z671 = k0 * s_Phi;
    const Scalar z661 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z662 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z665 = n0_035 * s_gamma;
    const Scalar z658 = v_beta + v_Theta;
    const Scalar z709 = z658 * z658;
    const Scalar z692 = v_beta * v_beta;
    const Scalar z693 = n0_175 * z692;
    const Scalar z666 = n0_035 * c_gamma;
    const Scalar z659 = v_delta + v_Phi;
    const Scalar z660 = v_epsilon + v_Omega;
    const Scalar z722 = v_beta * c_beta;
    const Scalar z710 = k1 * z709;  // force on K2, times 0.04 m, x
    const Scalar z694 = s_Theta * z693;
    const Scalar z695 = v_delta * v_delta;
    const Scalar z697 = v_epsilon * v_epsilon;
    const Scalar z699 = z660 * z660;
    const Scalar z712 = s_Theta * z710;
    const Scalar z704 = z659 * z659;
    const Scalar z696 = c_Phi * z695;
    const Scalar z698 = c_Omega * z697;
    const Scalar z700 = k0 * z699;  // force on K6, times 0.04 m, x
    const Scalar z705 = k0 * z704;  // force on K4, times 0.04 m, y
    const Scalar z721 = v_gamma * c_gamma;
    const Scalar z681 = k7 * s_gamma + k8 * c_gamma;
    const Scalar z702 = c_Omega * z700;
    const Scalar z707 = c_Phi * z705;
    const Scalar z682 = k8 * s_gamma - k7 * c_gamma;
    const Scalar z668 = k9 - z667;
    const Scalar z669 = k9 - n2 * z667;
    const Scalar z672 = k9 + z671;
    const Scalar z673 = k9 + n2 * z671;
    const Scalar z676 = k11 - n0_175 * z675;
    const Scalar z677 = k11 - n0_35 * z675;
    const Scalar z701 = k0 * z698;  // moment on K6, z
    const Scalar z706 = k0 * z696;  // moment on K4, z
    const Scalar z711 = k1 * z694;  // moment on K2, z
    const Scalar z716 = n0_007 - z714;
    const Scalar z717 = s_beta * z715;
    const Scalar z719 = c_beta * z715;
    const Scalar z703 = z701 - z702;  // moment on K7, z
    const Scalar z708 = z706 - z707;  // moment on K5, z
    const Scalar z713 = n0_033 - n0_175 * z712 + z711;  // moment on K1, z
    const Scalar z718 = c_beta * z716 + z717;
    const Scalar z720 = s_beta * z716 - z719;
    const Scalar z663 = k15 - z661;
    const Scalar z723 = v_Theta * c_Theta;
    const Scalar z664 = k16 + z662;
    const Scalar z728 = s_beta * z714 + z719;
    const Scalar z725 = v_beta * s_beta;
    const Scalar z726 = v_Theta * s_Theta;
    const Scalar z724 = n0_028 * z723;
    const Scalar z729 = v_gamma * s_gamma;
    const Scalar z727 = n0_028 * z726;
    const Scalar z670 = k17 + z669;
    const Scalar z732 = v_Theta * z726;
    const Scalar z730 = v_gamma * z729;
    const Scalar z731 = n0_035 * z730;
    const Scalar z733 = n0_028 * z732;
    const Scalar z674 = k18 + z673;
    const Scalar z734 = v_Theta * z723;
    const Scalar z736 = v_beta * z725;
    const Scalar z737 = v_beta * z722;
    const Scalar z735 = n0_028 * z734;
    const Scalar z678 = k19 + z677;
    const Scalar z683 = n0_02 - z681;
    const Scalar z684 = n0_018 - z682;
    const Scalar z738 = z715 * z736 + z716 * z737 + s_beta * z733 - c_beta * z735 - n2 * (z722 * z724 - z725 * z727);
    const Scalar z679 = n0_014 + z663;
    const Scalar z680 = n0_072 - z664;
    const Scalar z743 = z715 * z737 - z716 * z736 + s_beta * z735 + c_beta * z733 + n2 * (z722 * z727 + z724 * z725);
    const Scalar z740 = c_beta * z714 - z717;
    const Scalar z685 = z679 * z679 + z680 * z680;
    const Scalar z741 = v_gamma * z721;
    const Scalar z742 = n0_035 * z741;
    const Scalar z745 = n0_02 * s_Phi;
    const Scalar z686 = traits::sqrt(z685);
    const Scalar z746 = n0_02 * c_Phi;
    const Scalar z739 = z731 - z738;
    const Scalar z744 = z742 - z743;
    const Scalar z687 = n1 / z686;
    const Scalar z747 = n0_04 + z745;
    const Scalar z688 = n4530 - n352_6605 * z687;
    const Scalar z748 = s_delta * z746;
    const Scalar z689 = z683 * z688;
    const Scalar z749 = c_delta * z747 + z748;
    const Scalar z690 = z684 * z688;
    const Scalar z750 = c_delta * z746;
    const Scalar z691 = n0_018 * z689 - n0_02 * z690;
    const Scalar z795 = n1 / z670;
    const Scalar z799 = n1 / z674;
    const Scalar z767 = c_delta * z745 + z748;
    const Scalar z758 = s_delta * z745 - z750;
    const Scalar z751 = s_delta * z747 - z750;
    const Scalar z803 = k26 * z676;
    const Scalar z804 = z676 * z803 - z678;
    const Scalar z796 = z668 * z795;
    const Scalar z797 = k9 - z668 * z796;
    const Scalar z770 = n0_02 * c_Omega;
    const Scalar z771 = n0_02 * s_Omega;
    const Scalar z772 = n0_04 - z771;
    const Scalar z805 = n1 / z804;
    const Scalar z773 = c_epsilon * z770;
    const Scalar z810 = z718 + z740 * z803;
    const Scalar z798 = n1 / z797;
    const Scalar z774 = s_epsilon * z772 + z773;
    const Scalar z792 = s_epsilon * z771 - z773;
    const Scalar z775 = s_epsilon * z770;
    const Scalar z783 = c_epsilon * z771 + z775;
    const Scalar z776 = c_epsilon * z772 - z775;
    const Scalar z806 = z720 + z728 * z803;
    const Scalar z800 = z672 * z799;
    const Scalar z801 = k9 - z672 * z800;
    const Scalar z781 = v_Omega * s_Omega;
    const Scalar z755 = v_delta * s_delta;
    const Scalar z780 = v_epsilon * s_epsilon;
    const Scalar z784 = v_Omega * z781;
    const Scalar z782 = n0_02 * z781;
    const Scalar z752 = v_delta * c_delta;
    const Scalar z802 = n1 / z801;
    const Scalar z811 = z805 * z810;
    const Scalar z807 = z805 * z806;
    const Scalar z785 = n0_02 * z784;
    const Scalar z763 = v_delta * z755;
    const Scalar z777 = v_epsilon * c_epsilon;
    const Scalar z789 = v_epsilon * z780;
    const Scalar z812 = k26 * z740 - z803 * z811;
    const Scalar z808 = k26 * z728 - z803 * z807;
    const Scalar z753 = v_Phi * s_Phi;
    const Scalar z813 = k27 * z665;
    const Scalar z756 = v_Phi * c_Phi;
    const Scalar z778 = v_Omega * c_Omega;
    const Scalar z764 = v_delta * z752;
    const Scalar z788 = v_epsilon * z777;
    const Scalar z759 = v_Phi * z756;
    const Scalar z757 = n0_02 * z756;
    const Scalar z761 = v_Phi * z753;
    const Scalar z760 = n0_02 * z759;
    const Scalar z762 = n0_02 * z761;
    const Scalar z754 = n0_02 * z753;
    const Scalar z823 = z774 * z796 + z792;
    const Scalar z824 = z798 * z823;
    const Scalar z820 = z776 * z796 + z783;
    const Scalar z821 = z798 * z820;
    const Scalar z817 = z749 * z800 - z767;
    const Scalar z818 = z802 * z817;
    const Scalar z814 = z751 * z800 - z758;
    const Scalar z815 = z802 * z814;
    const Scalar z822 = z776 * z795 + z796 * z821;
    const Scalar z819 = z749 * z799 + z800 * z818;
    const Scalar z816 = z751 * z799 + z800 * z815;
    const Scalar z786 = v_Omega * z778;
    const Scalar z787 = n0_02 * z786;
    const Scalar z779 = n0_02 * z778;
    const Scalar z809 = k27 * z666;
    const Scalar z765 = z746 * z763 + z747 * z764 + s_delta * z760 + c_delta * z762 + n2 * (z752 * z754 + z755 * z757);
    const Scalar z768 = z747 * z763 - z746 * z764 + s_delta * z762 - c_delta * z760 - n2 * (z752 * z757 - z754 * z755);
    const Scalar z766 = z738 - z765;
    const Scalar z769 = z743 + z768;
    const Scalar z835 = z718 * z811;
    const Scalar z825 = z774 * z795 + z796 * z824;
    const Scalar z841 = z740 * z812 - z835 + z792 * z824 + z774 * z825;
    const Scalar z833 = z718 * z807;
    const Scalar z829 = z720 * z807;
    const Scalar z840 = z740 * z808 - z833 - z792 * z821 - z774 * z822;
    const Scalar z839 = z728 * z808 - z829 + z783 * z821 + z776 * z822;
    const Scalar z831 = z720 * z811 - z728 * z812;
    const Scalar z842 = n1 / z841;
    const Scalar z836 = z740 * z812 - z835;
    const Scalar z838 = z740 * z812 - z835 - z767 * z818 + z749 * z819;
    const Scalar z830 = z728 * z808 - z829;
    const Scalar z832 = z728 * z808 - z829 - z758 * z815 + z751 * z816;
    const Scalar z834 = z740 * z808 - z833;
    const Scalar z837 = z740 * z808 - z833 - z767 * z815 + z749 * z816;
    const Scalar z845 = z840 * z842;
    const Scalar z844 = z836 * z842;
    const Scalar z843 = z834 * z842;
    const Scalar z828 = z665 * z813 - z718 * z811 + z740 * z812;
    const Scalar z848 = z828 - z836 * z844;
    const Scalar z790 = s_epsilon * z785 - z770 * z788 - z772 * z789 - c_epsilon * z787 - n2 * (z777 * z779 - z780
        * z782);
    const Scalar z793 = z770 * z789 - z772 * z788 + s_epsilon * z787 + c_epsilon * z785 + n2 * (z777 * z782 + z779
        * z780);
    const Scalar z791 = z738 + z790;
    const Scalar z794 = z743 + z793;
    const Scalar z858 = z839 - z840 * z845;
    const Scalar z859 = n1 / z858;
    const Scalar z855 = z836 * z844 - z838;
    const Scalar z854 = z834 * z844 - z837;
    const Scalar z851 = z832 - z834 * z843;
    const Scalar z857 = z831 + z836 * z845;
    const Scalar z850 = z831 + z836 * z843;
    const Scalar z853 = z836 * (n1 - z844);
    const Scalar z856 = z830 - z834 * z845;
    const Scalar z849 = z830 - z834 * z843;
    const Scalar z827 = z665 * z809 + z718 * z807 - z740 * z808;
    const Scalar z847 = z827 + z834 * z844;
    const Scalar z826 = z666 * z809 - z720 * z807 + z728 * z808;
    const Scalar z894 = z711 * z803 - z713;
    const Scalar z895 = z805 * z894;
    const Scalar z892 = z701 - z703 * z796;
    const Scalar z900 = z798 * z892;
    const Scalar z893 = z706 - z708 * z800;
    const Scalar z896 = k26 * z711 - z803 * z895;
    const Scalar z901 = z703 * z795 - z796 * z900;
    const Scalar z898 = z802 * z893;
    const Scalar z899 = z708 * z799 - z800 * z898;
    const Scalar z846 = z826 - z834 * z843;
    const Scalar z906 = z720 * z895 + z791 - z728 * z896 + z783 * z900 - z776 * z901;
    const Scalar z904 = z720 * z895 + z766 - z728 * z896 - z758 * z898 - z751 * z899;
    const Scalar z905 = z718 * z895 + z769 - z740 * z896 - z767 * z898 - z749 * z899;
    const Scalar z907 = z718 * z895 + z794 - z740 * z896 - z792 * z900 + z774 * z901;
    const Scalar z852 = z834 * (n1 - z844);
    const Scalar z897 = k27 * z691;
    const Scalar z902 = z739 - z720 * z895 + z728 * z896 + z666 * z897;
    const Scalar z903 = z718 * z895 - z744 - z740 * z896 + z665 * z897;
    const Scalar z908 = z845 * z907 - z906;
    const Scalar z861 = z857 * z859;
    const Scalar z871 = z855 + z857 * z861;
    const Scalar z870 = z854 - z856 * z861;
    const Scalar z869 = z853 - z857 * z861;
    const Scalar z864 = z848 - z857 * z861;
    const Scalar z872 = n1 / z871;
    const Scalar z863 = z847 - z856 * z861;
    const Scalar z868 = z852 + z856 * z861;
    const Scalar z909 = z844 * z907 - z905 + z861 * z908;
    const Scalar z860 = z856 * z859;
    const Scalar z866 = z850 - z857 * z860;
    const Scalar z867 = z851 - z856 * z860;
    const Scalar z865 = z849 - z856 * z860;
    const Scalar z862 = z846 - z856 * z860;
    const Scalar z873 = z868 * z872;
    const Scalar z874 = z869 * z872;
    const Scalar z875 = z870 * z872;
    const Scalar z876 = z862 + z868 * z873;
    const Scalar z877 = z863 - z868 * z874;
    const Scalar z878 = z864 + z869 * z874;
    const Scalar z879 = z865 - z868 * z875;
    const Scalar z880 = z866 + z869 * z875;
    const Scalar z881 = z867 + z870 * z875;
    const Scalar z910 = z843 * z907 - z904 - z860 * z908 - z875 * z909;
    const Scalar z882 = n1 / z881;
    const Scalar z883 = z879 * z882;
    const Scalar z884 = z880 * z882;
    const Scalar z885 = z876 - z879 * z883;
    const Scalar z886 = z877 - z879 * z884;
    const Scalar z887 = z878 - z880 * z884;
    const Scalar z911 = z844 * z907 - z903 + z861 * z908 + z874 * z909 + z884 * z910;
    const Scalar z888 = n1 / z887;
    const Scalar z889 = z886 * z888;
    const Scalar z890 = z885 - z886 * z889;
    const Scalar z912 = z843 * z907 + z902 - z860 * z908 + z873 * z909 - z883 * z910 + z889 * z911;
    const Scalar z891 = n1 / z890;
    const Scalar z913 = z891 * z912;
    const Scalar z914 = z888 * z911 + z889 * z913;
    const Scalar z915 = z882 * z910 - z883 * z913 + z884 * z914;
    const Scalar z921 = z809 * z913 - z897 - z813 * z914;
    const Scalar z916 = z872 * z909 - z873 * z913 - z874 * z914 + z875 * z915;
    const Scalar z917 = z859 * z908 - z860 * (z913 + z915) + z861 * (z914 - z916);
    const Scalar z922 = z898 + z815 * z915 - z818 * z916;
    const Scalar z923 = z816 * z915 - z899 - z819 * z916;
    const Scalar z918 = z842 * z907 + z843 * (z913 + z915) + z844 * (z914 - z916) + z845 * z917;
    const Scalar z919 = z807 * (z913 + z915 + z917) - z895 + z811 * (z914 - z916 - z918);
    const Scalar z920 = z808 * (z913 + z915 + z917) - z896 + z812 * (z914 - z916 - z918);
    const Scalar z924 = z900 + z821 * z917 + z824 * z918;
    const Scalar z925 = z822 * z917 - z901 + z825 * z918;
    accelerations.beta = -z919;
    accelerations.Theta = -z920;
    accelerations.gamma = z921;
    accelerations.Phi = z922;
    accelerations.delta = -z923;
    accelerations.Omega = -z924;
    accelerations.epsilon = z925;
    multipliers.lambda_E3_x = -z913;
    multipliers.lambda_E3_y = z914;
    multipliers.lambda_E4_x = -z915;
    multipliers.lambda_E4_y = -z916;
    multipliers.lambda_E6_x = -z917;
    multipliers.lambda_E6_y = -z918;
    if (!(traits::regular(-z804, z678) && traits::regular(z801, k9) && traits::regular(z674, z674)
        && traits::regular(z797, k9) && traits::regular(z670, z670) && traits::regular(z890, z826)
        && traits::regular(z887, z828) && traits::regular(z881, z832) && traits::regular(-z871, z838)
        && traits::regular(z858, z839) && traits::regular(z841, z841))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.beta * accelerations.Theta * accelerations.gamma * accelerations.Phi
        * accelerations.delta * accelerations.Omega * accelerations.epsilon * multipliers.lambda_E3_x
        * multipliers.lambda_E3_y * multipliers.lambda_E4_x * multipliers.lambda_E4_y * multipliers.lambda_E6_x
        * multipliers.lambda_E6_y;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k4 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k5 = traits::constant(0.00365, 0.00365f, "73/20000");
    const Scalar k6 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar k7 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k8 = traits::constant(0.00706, 0.00706f, "353/50000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k10 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k11 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k14 = traits::constant(0.07785, 0.07785f, "1557/20000");
    const Scalar k15 = traits::constant(1.1153034e-06, 1.1153033e-06f, "5576517/5000000000000");
    const Scalar k16 = traits::constant(8.0850737125e-06, 8.085074e-06f, "646805897/80000000000000");
    const Scalar k17 = traits::constant(2.7579868e-05, 2.7579868e-05f, "6894967/250000000000");
    const Scalar k18 = traits::constant(1.4259649165e-05, 1.4259649e-05f, "2851929833/200000000000000");
    const Scalar k19 = traits::constant(0.001825, 0.001825f, "73/40000");
    const Scalar k20 = traits::constant(0.00353, 0.00353f, "353/100000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2265 = traits::constant(2265.0, 2265.0f, "2265/1");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_Theta, q_gamma, q_Phi, q_Omega};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_Theta = sines_[0], c_Theta = cosines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar s_Phi = sines_[2], c_Phi = cosines_[2];
    const Scalar s_Omega = sines_[3], c_Omega = cosines_[3];
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z40 = n0_007 * v_beta;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z51 = n0_04 * v_delta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z62 = n0_04 * v_epsilon;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z207 = c_Theta * z40;
    const Scalar z208 = s_Phi * z51;
    const Scalar z211 = s_Omega * z62;
    const Scalar z206 = s_Theta * z40;
    const Scalar z209 = c_Phi * z51;
    const Scalar z210 = c_Omega * z62;
    const Scalar z926 = k4 * z41 - k5 * z207;
    const Scalar z927 = k6 * z41 - k4 * z207;
    const Scalar z928 = k7 * z52 + k8 * z208;
    const Scalar z929 = k9 * z52 + k7 * z208;
    const Scalar z930 = k7 * z63 - k8 * z211;
    const Scalar z931 = k9 * z63 - k7 * z211;
    const Scalar z122 = k10 - z116;
    const Scalar z123 = k11 + z117;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z222 = k14 - z219;
    result.kinetic = k15 * v_beta * v_beta + k16 * v_gamma * v_gamma + k17 * v_delta * v_delta + k18 * v_epsilon
        * v_epsilon + k19 * z206 * z206 + k20 * (z209 * z209 + z210 * z210) + n0_5 * (z41 * z927 + z52 * z929 + z63
        * z931 - z207 * z926 + z208 * z928 - z211 * z930);
    result.force_function = -n2265 * z222 * z222;
    result.power = n0_033 * v_beta;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k3 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k4 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k9 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z998 = v_beta * c_beta;
    const Scalar z1001 = v_beta * s_beta;
    const Scalar z1026 = n0_02 * s_Phi;
    const Scalar z1040 = v_delta * s_delta;
    const Scalar z987 = n0_028 * c_Theta;
    const Scalar z988 = n0_028 * s_Theta;
    const Scalar z1027 = n0_02 * c_Phi;
    const Scalar z1037 = v_delta * c_delta;
    const Scalar z999 = v_Theta * c_Theta;
    const Scalar z1002 = v_Theta * s_Theta;
    const Scalar z1038 = v_Phi * s_Phi;
    const Scalar z1041 = v_Phi * c_Phi;
    const Scalar z996 = v_gamma * c_gamma;
    const Scalar z1007 = v_gamma * s_gamma;
    const Scalar z983 = n0_035 * s_gamma;
    const Scalar z984 = n0_035 * c_gamma;
    const Scalar z985 = k3 - z983;
    const Scalar z986 = k4 - z984;
    const Scalar z989 = n0_007 - z987;
    const Scalar z990 = s_beta * z988;
    const Scalar z992 = c_beta * z988;
    const Scalar z997 = n0_035 * z996;
    const Scalar z1000 = n0_028 * z999;
    const Scalar z1003 = n0_028 * z1002;
    const Scalar z1008 = v_gamma * z1007;
    const Scalar z1010 = v_Theta * z1002;
    const Scalar z1012 = v_Theta * z999;
    const Scalar z1014 = v_beta * z1001;
    const Scalar z1015 = v_beta * z998;
    const Scalar z1018 = n0_035 * z1007;
    const Scalar z1022 = v_gamma * z996;
    const Scalar z1028 = n0_04 + z1026;
    const Scalar z1029 = s_delta * z1027;
    const Scalar z1031 = c_delta * z1027;
    const Scalar z1039 = n0_02 * z1038;
    const Scalar z1042 = n0_02 * z1041;
    const Scalar z1046 = v_Phi * z1041;
    const Scalar z1048 = v_Phi * z1038;
    const Scalar z1050 = v_delta * z1040;
    const Scalar z991 = c_beta * z989 + z990;
    const Scalar z1051 = v_delta * z1037;
    const Scalar z993 = s_beta * z989 - z992;
    const Scalar z1004 = z988 * z998 + s_beta * z1000 + c_beta * z1003 - z989 * z1001;
    const Scalar z1006 = s_beta * z987 + z992;
    const Scalar z1009 = n0_035 * z1008;
    const Scalar z1011 = n0_028 * z1010;
    const Scalar z1013 = n0_028 * z1012;
    const Scalar z1019 = z988 * z1001 + s_beta * z1003 - c_beta * z1000 + z989 * z998;
    const Scalar z1021 = c_beta * z987 - z990;
    const Scalar z1023 = n0_035 * z1022;
    const Scalar z1030 = c_delta * z1028 + z1029;
    const Scalar z1032 = s_delta * z1028 - z1031;
    const Scalar z1043 = s_delta * z1039 - c_delta * z1042 - z1027 * z1037 + z1028 * z1040;
    const Scalar z1045 = s_delta * z1026 - z1031;
    const Scalar z1047 = n0_02 * z1046;
    const Scalar z1049 = n0_02 * z1048;
    const Scalar z1016 = z988 * z1014 + z989 * z1015 + s_beta * z1011 - c_beta * z1013 - n2 * (z998 * z1000 - z1001
        * z1003);
    const Scalar z1024 = z988 * z1015 - z989 * z1014 + s_beta * z1013 + c_beta * z1011 + n2 * (z998 * z1003 + z1000
        * z1001);
    const Scalar z994 = z985 + z991;
    const Scalar z995 = z986 - z993;
    const Scalar z1056 = c_delta * z1026 + z1029;
    const Scalar z1005 = z997 - z1004;
    const Scalar z1020 = z1018 - z1019;
    const Scalar z1033 = k8 - z1030;
    const Scalar z1035 = z991 + z1033;
    const Scalar z1044 = z1004 + z1043;
    const Scalar z1074 = v_Omega * s_Omega;
    const Scalar z1034 = k9 - z1032;
    const Scalar z1036 = z993 + z1034;
    const Scalar z1073 = v_epsilon * s_epsilon;
    const Scalar z1059 = n0_02 * c_Omega;
    const Scalar z1060 = n0_02 * s_Omega;
    const Scalar z1017 = z1009 - z1016;
    const Scalar z1025 = z1023 - z1024;
    const Scalar z1079 = v_Omega * z1074;
    const Scalar z1080 = n0_02 * z1079;
    const Scalar z1075 = n0_02 * z1074;
    const Scalar z1070 = v_epsilon * c_epsilon;
    const Scalar z1084 = v_epsilon * z1073;
    const Scalar z1071 = v_Omega * c_Omega;
    const Scalar z1061 = n0_04 - z1060;
    const Scalar z1083 = v_epsilon * z1070;
    const Scalar z1081 = v_Omega * z1071;
    const Scalar z1072 = n0_02 * z1071;
    const Scalar z1062 = c_epsilon * z1059;
    const Scalar z1089 = s_epsilon * z1060 - z1062;
    const Scalar z1082 = n0_02 * z1081;
    const Scalar z1063 = s_epsilon * z1061 + z1062;
    const Scalar z1064 = s_epsilon * z1059;
    const Scalar z1078 = c_epsilon * z1060 + z1064;
    const Scalar z1065 = c_epsilon * z1061 - z1064;
    const Scalar z1066 = k8 - z1063;
    const Scalar z1052 = z1027 * z1050 + z1028 * z1051 + s_delta * z1047 + c_delta * z1049 + n2 * (z1037 * z1039 + z1040
        * z1042);
    const Scalar z1057 = z1028 * z1050 - z1027 * z1051 + s_delta * z1049 - c_delta * z1047 - n2 * (z1037 * z1042 - z1039
        * z1040);
    const Scalar z1054 = z1027 * z1040 + s_delta * z1042 + c_delta * z1039 + z1028 * z1037;
    const Scalar z1068 = z991 + z1066;
    const Scalar z1067 = k9 + z1065;
    const Scalar z1076 = z1059 * z1073 + s_epsilon * z1072 + c_epsilon * z1075 - z1061 * z1070;
    const Scalar z1069 = z993 + z1067;
    const Scalar z1085 = s_epsilon * z1080 - z1059 * z1083 - z1061 * z1084 - c_epsilon * z1082 - n2 * (z1070 * z1072
        - z1073 * z1075);
    const Scalar z1087 = s_epsilon * z1075 - c_epsilon * z1072 - z1059 * z1070 - z1061 * z1073;
    const Scalar z1090 = z1059 * z1084 - z1061 * z1083 + s_epsilon * z1082 + c_epsilon * z1080 + n2 * (z1070 * z1075
        + z1072 * z1073);
    const Scalar z1053 = z1016 - z1052;
    const Scalar z1055 = z1019 - z1054;
    const Scalar z1058 = z1024 + z1057;
    const Scalar z1077 = z1004 + z1076;
    const Scalar z1086 = z1016 + z1085;
    const Scalar z1088 = z1019 + z1087;
    const Scalar z1091 = z1024 + z1090;
    result.value[0] = z994;
    result.rate[0] = -z1005;
    result.gamma[0] = z1017;
    result.value[1] = -z995;
    result.rate[1] = -z1020;
    result.gamma[1] = -z1025;
    result.value[2] = z1035;
    result.rate[2] = z1044;
    result.gamma[2] = -z1053;
    result.value[3] = z1036;
    result.rate[3] = z1055;
    result.gamma[3] = z1058;
    result.value[4] = z1068;
    result.rate[4] = z1077;
    result.gamma[4] = -z1086;
    result.value[5] = z1069;
    result.rate[5] = z1088;
    result.gamma[5] = z1091;
    result.jacobian[0] = -z993;
    result.jacobian[1] = z991;
    result.jacobian[2] = -z993;
    result.jacobian[3] = z991;
    result.jacobian[4] = -z993;
    result.jacobian[5] = z991;
    result.jacobian[6] = z1006;
    result.jacobian[7] = -z1021;
    result.jacobian[8] = z1006;
    result.jacobian[9] = -z1021;
    result.jacobian[10] = z1006;
    result.jacobian[11] = -z1021;
    result.jacobian[12] = -z984;
    result.jacobian[13] = -z983;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z1045;
    result.jacobian[21] = -z1056;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = z1032;
    result.jacobian[27] = -z1030;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = z1078;
    result.jacobian[35] = z1089;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = -z1065;
    result.jacobian[41] = -z1063;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of beta,
  /// w those of the rates of beta;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k4 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k5 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k6 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k7 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar k8 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k10 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k12 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k13 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar k15 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar k17 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k18 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k26 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k28 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k29 = traits::constant(1244740.7431948162, 1244740.8f, "500000000000000/401690073");
    const Scalar k30 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z1496 = n0_035 * c_gamma;
    const Scalar z1495 = n0_035 * s_gamma;
    const Scalar z1491 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1492 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z1488 = v_beta + v_Theta;
    const Scalar z1522 = v_beta * v_beta;
    const Scalar z1532 = n0_175 * a_beta;
    const Scalar z1535 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z1523 = n0_175 * z1522;
    const Scalar z1530 = z1488 * z1488;
    const Scalar z1505 = k4 * c_Theta;
    const Scalar z1531 = k4 * z1530;  // force on K2, times 0.04 m, x
    const Scalar z1533 = s_Theta * z1532 - c_Theta * z1523;
    const Scalar z1489 = v_delta + v_Phi;
    const Scalar z1538 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z1524 = v_delta * v_delta;
    const Scalar z1501 = k5 * s_Phi;
    const Scalar z1528 = z1489 * z1489;
    const Scalar z1534 = s_Theta * z1523 + c_Theta * z1532;
    const Scalar z1547 = k5 * z1538;  // force on K4, times 0.04 m, x
    const Scalar z1490 = v_epsilon + v_Omega;
    const Scalar z1541 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z1525 = v_epsilon * v_epsilon;
    const Scalar z1537 = a_delta * c_Phi + s_Phi * z1524;
    const Scalar z1529 = k5 * z1528;  // force on K4, times 0.04 m, y
    const Scalar z1536 = a_delta * s_Phi - c_Phi * z1524;
    const Scalar z1497 = k5 * s_Omega;
    const Scalar z1526 = z1490 * z1490;
    const Scalar z1527 = k5 * z1526;  // force on K6, times 0.04 m, x
    const Scalar z1542 = k5 * z1541;  // force on K6, times 0.04 m, y
    const Scalar z1539 = a_epsilon * c_Omega + s_Omega * z1525;
    const Scalar z1540 = a_epsilon * s_Omega - c_Omega * z1525;
    const Scalar z1550 = s_Phi * z1547 + c_Phi * z1529;
    const Scalar z1549 = s_Phi * z1529 - c_Phi * z1547;
    const Scalar z1511 = k6 * s_gamma + k7 * c_gamma;
    const Scalar z1512 = k7 * s_gamma - k6 * c_gamma;
    const Scalar z1544 = s_Omega * z1542 + c_Omega * z1527;
    const Scalar z1545 = s_Omega * z1527 - c_Omega * z1542;
    const Scalar z1498 = k8 - z1497;
    const Scalar z1499 = k8 - n2 * z1497;
    const Scalar z1502 = k8 + z1501;
    const Scalar z1503 = k8 + n2 * z1501;
    const Scalar z1506 = k10 - n0_175 * z1505;
    const Scalar z1507 = k10 - n0_35 * z1505;
    const Scalar z1493 = k12 - z1491;
    const Scalar z1553 = k4 * z1535;  // force on K2, times 0.04 m, y
    const Scalar z1494 = k13 + z1492;
    const Scalar z1559 = n0_028 * s_Theta;
    const Scalar z1558 = n0_028 * c_Theta;
    const Scalar z1555 = s_Theta * z1553 + c_Theta * z1531;
    const Scalar z1556 = s_Theta * z1531 - c_Theta * z1553;
    const Scalar z1500 = k15 + z1499;
    const Scalar z1561 = s_beta * z1559;
    const Scalar z1563 = c_beta * z1559;
    const Scalar z1560 = n0_007 - z1558;
    const Scalar z1562 = c_beta * z1560 + z1561;
    const Scalar z1504 = k17 + z1503;
    const Scalar z1567 = v_beta * c_beta;
    const Scalar z1564 = s_beta * z1560 - z1563;
    const Scalar z1565 = v_gamma * c_gamma;
    const Scalar z1566 = n0_035 * z1565;
    const Scalar z1508 = k18 + z1507;
    const Scalar z1568 = v_Theta * c_Theta;
    const Scalar z1513 = n0_02 - z1511;
    const Scalar z1514 = n0_018 - z1512;
    const Scalar z1543 = k5 * z1540 - k8 * z1541;  // moment on K6, z
    const Scalar z1554 = k4 * z1534 - k10 * z1535;  // moment on K2, z
    const Scalar z1548 = k8 * z1538 + k5 * z1536;  // moment on K4, z
    const Scalar z1509 = n0_014 + z1493;
    const Scalar z1510 = n0_072 - z1494;
    const Scalar z1551 = k17 * a_delta + z1550 + z1548;  // moment on K5, z
    const Scalar z1570 = v_beta * s_beta;
    const Scalar z1557 = n0_033 - k18 * a_beta - n0_175 * z1556 + z1554;  // moment on K1, z
    const Scalar z1546 = k15 * a_epsilon - z1544 - z1543;  // moment on K7, z
    const Scalar z1571 = v_Theta * s_Theta;
    const Scalar z1572 = n0_028 * z1571;
    const Scalar z1574 = z1559 * z1567;
    const Scalar z1515 = z1509 * z1509 + z1510 * z1510;
    const Scalar z1516 = traits::sqrt(z1515);
    const Scalar z1576 = s_beta * z1558 + z1563;
    const Scalar z1569 = n0_028 * z1568;
    const Scalar z1573 = s_beta * z1569;
    const Scalar z1575 = z1574 + c_beta * z1572 - z1560 * z1570 + z1573;
    const Scalar z1517 = n1 / z1516;
    const Scalar z1577 = v_gamma * s_gamma;
    const Scalar z1518 = n4530 - n352_6605 * z1517;
    const Scalar z1578 = v_gamma * z1577;
    const Scalar z1519 = z1513 * z1518;
    const Scalar z1579 = n0_035 * z1578;
    const Scalar z1520 = z1514 * z1518;
    const Scalar z1580 = v_Theta * z1571;
    const Scalar z1521 = n0_018 * z1519 - n0_02 * z1520;
    const Scalar z1594 = c_beta * z1558 - z1561;
    const Scalar z1581 = n0_028 * z1580;
    const Scalar z1602 = n0_02 * c_Phi;
    const Scalar z1601 = n0_02 * s_Phi;
    const Scalar z1606 = c_delta * z1602;
    const Scalar z1604 = s_delta * z1602;
    const Scalar z1603 = n0_04 + z1601;
    const Scalar z1592 = z1559 * z1570;
    const Scalar z1608 = v_delta * c_delta;
    const Scalar z1609 = v_Phi * s_Phi;
    const Scalar z1605 = c_delta * z1603 + z1604;
    const Scalar z1607 = s_delta * z1603 - z1606;
    const Scalar z1611 = v_delta * s_delta;
    const Scalar z1582 = v_Theta * z1568;
    const Scalar z1583 = n0_028 * z1582;
    const Scalar z1584 = v_beta * z1570;
    const Scalar z1585 = v_beta * z1567;
    const Scalar z1610 = n0_02 * z1609;
    const Scalar z1586 = z1559 * z1584;
    const Scalar z1597 = z1559 * z1585;
    const Scalar z1591 = c_beta * z1569;
    const Scalar z1593 = z1592 + s_beta * z1572 + z1560 * z1567 - z1591;
    const Scalar z1587 = z1570 * z1572;
    const Scalar z1598 = z1567 * z1572;
    const Scalar z1590 = n0_035 * z1577;
    const Scalar z1588 = z1586 + z1560 * z1585 + s_beta * z1581 - c_beta * z1583 - n2 * (z1567 * z1569 - z1587);
    const Scalar z1599 = z1597 + s_beta * z1583 - z1560 * z1584 + c_beta * z1581 + n2 * (z1569 * z1570 + z1598);
    const Scalar z1595 = v_gamma * z1565;
    const Scalar z1596 = n0_035 * z1595;
    const Scalar z1589 = z1579 - z1588;
    const Scalar z1600 = z1596 - z1599;
    const Scalar z1552 = k26 * a_gamma + z1521;  // moment on K3, z
    const Scalar z1617 = s_delta * z1601 - z1606;
    const Scalar z1631 = c_delta * z1601 + z1604;
    const Scalar z1636 = n0_02 * c_Omega;
    const Scalar z1637 = n0_02 * s_Omega;
    const Scalar z1641 = s_epsilon * z1636;
    const Scalar z1639 = c_epsilon * z1636;
    const Scalar z1638 = n0_04 - z1637;
    const Scalar z1643 = v_epsilon * c_epsilon;
    const Scalar z1646 = v_epsilon * s_epsilon;
    const Scalar z1652 = c_epsilon * z1637 + z1641;
    const Scalar z1642 = c_epsilon * z1638 - z1641;
    const Scalar z1666 = s_epsilon * z1637 - z1639;
    const Scalar z1640 = s_epsilon * z1638 + z1639;
    const Scalar z1647 = v_Omega * s_Omega;
    const Scalar z1615 = z1602 * z1608;
    const Scalar z1629 = z1602 * z1611;
    const Scalar z1648 = n0_02 * z1647;
    const Scalar z1650 = z1636 * z1646;
    const Scalar z1664 = z1636 * z1643;
    const Scalar z1612 = v_Phi * c_Phi;
    const Scalar z1644 = v_Omega * c_Omega;
    const Scalar z1613 = n0_02 * z1612;
    const Scalar z1645 = n0_02 * z1644;
    const Scalar z1622 = v_delta * z1611;
    const Scalar z1623 = v_delta * z1608;
    const Scalar z1624 = z1602 * z1622;
    const Scalar z1614 = c_delta * z1613;
    const Scalar z1675 = n2 * z1488;
    const Scalar z1628 = s_delta * z1613;
    const Scalar z1649 = s_epsilon * z1645;
    const Scalar z1663 = c_epsilon * z1645;
    const Scalar z1618 = v_Phi * z1612;
    const Scalar z1619 = n0_02 * z1618;
    const Scalar z1653 = v_Omega * z1647;
    const Scalar z1654 = n0_02 * z1653;
    const Scalar z1655 = v_Omega * z1644;
    const Scalar z1656 = n0_02 * z1655;
    const Scalar z1657 = v_epsilon * z1643;
    const Scalar z1658 = v_epsilon * z1646;
    const Scalar z1616 = s_delta * z1610 - z1615 + z1603 * z1611 - z1614;
    const Scalar z1676 = k4 * z1675;
    const Scalar z1677 = s_Theta * z1676;
    const Scalar z1630 = z1629 + c_delta * z1610 + z1603 * z1608 + z1628;
    const Scalar z1678 = n0_175 * z1677;
    const Scalar z1651 = z1650 + c_epsilon * z1648 - z1638 * z1643 + z1649;
    const Scalar z1665 = s_epsilon * z1648 - z1664 - z1638 * z1646 - z1663;
    const Scalar z1632 = z1602 * z1623;
    const Scalar z1659 = z1636 * z1657;
    const Scalar z1667 = z1636 * z1658;
    const Scalar z1620 = v_Phi * z1609;
    const Scalar z1621 = n0_02 * z1620;
    const Scalar z1682 = k4 * z1533;
    const Scalar z1683 = n0_175 * z1555 + z1682;
    const Scalar z1625 = z1608 * z1610;
    const Scalar z1685 = z1576 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z1682 + z1594 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z1684 = z1576 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z1683 + z1594 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z1633 = z1610 * z1611;
    const Scalar z1660 = z1646 * z1648;
    const Scalar z1668 = z1643 * z1648;
    const Scalar z1626 = z1624 + z1603 * z1623 + s_delta * z1619 + c_delta * z1621 + n2 * (z1611 * z1613 + z1625);
    const Scalar z1686 = n2 * (z1491 * z1510 - z1492 * z1509);
    const Scalar z1634 = z1603 * z1622 - z1632 + s_delta * z1621 - c_delta * z1619 - n2 * (z1608 * z1613 - z1633);
    const Scalar z1661 = s_epsilon * z1654 - z1659 - z1638 * z1658 - c_epsilon * z1656 - n2 * (z1643 * z1645 - z1660);
    const Scalar z1669 = z1667 + s_epsilon * z1656 - z1638 * z1657 + c_epsilon * z1654 + n2 * (z1645 * z1646 + z1668);
    const Scalar z1671 = n2 * v_beta;
    const Scalar z1672 = n0_175 * z1671;
    const Scalar z1680 = z1562 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z1564 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z1673 = s_Theta * z1672;
    const Scalar z1681 = z1576 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z1594 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z1674 = k4 * z1673;
    const Scalar z1627 = z1588 - z1626;
    const Scalar z1687 = n0_5 * z1686 / z1516;
    const Scalar z1688 = z1687 / (z1516 * z1516);
    const Scalar z1694 = k5 * z1537;
    const Scalar z1635 = z1599 + z1634;
    const Scalar z1697 = n2 * z1489;
    const Scalar z1708 = k5 * z1539;
    const Scalar z1698 = k5 * z1697;
    const Scalar z1711 = n2 * z1490;
    const Scalar z1700 = z1549 - z1694;
    const Scalar z1712 = k5 * z1711;
    const Scalar z1714 = z1545 - z1708;
    const Scalar z1699 = c_Phi * z1698;
    const Scalar z1695 = l_lambda_E4_y * z1617;
    const Scalar z1696 = l_lambda_E4_x * z1631 - z1694 + z1695;
    const Scalar z1701 = l_lambda_E4_x * z1631 + z1695 + z1700;
    const Scalar z1705 = l_lambda_E4_x * z1631 + z1695;
    const Scalar z1713 = c_Omega * z1712;
    const Scalar z1702 = n2 * v_delta;
    const Scalar z1703 = c_Phi * z1702;
    const Scalar z1709 = l_lambda_E6_y * z1652;
    const Scalar z1710 = l_lambda_E6_x * z1666 - z1708 - z1709;
    const Scalar z1689 = n352_6605 * z1688;
    const Scalar z1704 = k5 * z1703;
    const Scalar z1715 = l_lambda_E6_x * z1666 - z1709 + z1714;
    const Scalar z1690 = z1512 * z1518 - z1513 * z1689;
    const Scalar z1691 = z1511 * z1518 + z1514 * z1689;
    const Scalar z1719 = l_lambda_E6_x * z1666 - z1709;
    const Scalar z1692 = n0_018 * z1690 + n0_02 * z1691;
    const Scalar z1716 = n2 * v_epsilon;
    const Scalar z1717 = c_Omega * z1716;
    const Scalar z1679 = z1674 - z1678;
    const Scalar z1662 = z1588 + z1661;
    const Scalar z1724 = a_beta * z1564 - a_Theta * z1576 + a_gamma * z1496 - z1589;
    const Scalar z1725 = a_beta * z1562 - a_Theta * z1594 - a_gamma * z1495 - z1600;
    const Scalar z1723 = a_beta * z1564 - a_Theta * z1576 - a_delta * z1607 - a_Phi * z1617 + z1627;
    const Scalar z1727 = a_beta * z1562 - a_Theta * z1594 - a_delta * z1605 - a_Phi * z1631 + z1635;
    const Scalar z1718 = k5 * z1717;
    const Scalar z1722 = a_beta * z1564 - a_Theta * z1576 + a_epsilon * z1642 - a_Omega * z1652 + z1662;
    const Scalar z1693 = l_lambda_E3_x * z1495 - z1692 - l_lambda_E3_y * z1496;
    const Scalar z1728 = n2 * z1570;
    const Scalar z1729 = n2 * z1567;
    const Scalar z1670 = z1599 + z1669;
    const Scalar z1740 = z1597 + z1558 * z1584 + s_beta * z1583 + c_beta * z1581 + n2 * (z1569 * z1570 + z1598);
    const Scalar z1744 = z1586 + s_beta * z1581 - z1558 * z1585 - c_beta * z1583 - n2 * (z1567 * z1569 - z1587);
    const Scalar z1762 = z1624 + z1601 * z1623 + s_delta * z1619 + c_delta * z1621 + n2 * (z1611 * z1613 + z1625);
    const Scalar z1758 = z1601 * z1622 - z1632 + s_delta * z1621 - c_delta * z1619 - n2 * (z1608 * z1613 - z1633);
    const Scalar z1735 = n2 * z1571;
    const Scalar z1737 = n2 * z1568;
    const Scalar z1736 = n0_028 * z1735;
    const Scalar z1738 = n0_028 * z1737;
    const Scalar z1755 = n2 * z1609;
    const Scalar z1731 = z1599 + a_beta * z1562 - a_Theta * z1594;
    const Scalar z1733 = z1588 + a_beta * z1564 - a_Theta * z1576;
    const Scalar z1741 = z1594 * (a_beta + a_Theta) - z1740;
    const Scalar z1745 = z1576 * (a_beta + a_Theta) - z1744;
    const Scalar z1753 = n2 * z1612;
    const Scalar z1756 = n0_02 * z1755;
    const Scalar z1746 = n2 * z1577;
    const Scalar z1749 = n2 * z1565;
    const Scalar z1754 = n0_02 * z1753;
    const Scalar z1747 = n0_035 * z1746;
    const Scalar z1748 = a_gamma * z1495 + z1596;
    const Scalar z1750 = n0_035 * z1749;
    const Scalar z1751 = a_gamma * z1496 - z1579;
    const Scalar z1763 = z1617 * (a_delta + a_Phi) + z1762;
    const Scalar z1759 = z1631 * (a_delta + a_Phi) - z1758;
    const Scalar z1726 = a_beta * z1562 - a_Theta * z1594 - a_epsilon * z1640 + a_Omega * z1666 + z1670;
    const Scalar z1734 = z1592 + s_beta * z1572 - z1558 * z1567 - z1591;
    const Scalar z1739 = s_beta * z1736 - n2 * (z1558 * z1567 - z1592) - c_beta * z1738;
    const Scalar z1743 = s_beta * z1738 + c_beta * z1736 + n2 * (z1558 * z1570 + z1574);
    const Scalar z1742 = z1574 + z1558 * z1570 + c_beta * z1572 + z1573;
    const Scalar z1730 = z1559 * z1728 + z1560 * z1729 + n2 * (s_beta * z1572 - z1591);
    const Scalar z1732 = z1559 * z1729 - z1560 * z1728 + n2 * (c_beta * z1572 + z1573);
    const Scalar z1752 = z1629 + z1601 * z1608 + c_delta * z1610 + z1628;
    const Scalar z1757 = s_delta * z1754 + c_delta * z1756 + n2 * (z1601 * z1608 + z1629);
    const Scalar z1761 = s_delta * z1756 - c_delta * z1754 + n2 * (z1601 * z1611 - z1615);
    const Scalar z1760 = z1601 * z1611 - z1615 + s_delta * z1610 - z1614;
    const Scalar z1764 = n2 * z1611;
    const Scalar z1765 = n2 * z1608;
    const Scalar z1706 = z1699 - z1704;
    const Scalar z1766 = z1602 * z1764 + z1603 * z1765 + n2 * (c_delta * z1610 + z1628);
    const Scalar z1707 = l_lambda_E4_x * z1605 + l_lambda_E4_y * z1607;
    const Scalar z1768 = z1603 * z1764 - z1602 * z1765 + n2 * (s_delta * z1610 - z1614);
    const Scalar z1777 = z1667 + z1637 * z1657 + s_epsilon * z1656 + c_epsilon * z1654 + n2 * (z1645 * z1646 + z1668);
    const Scalar z1772 = n2 * z1647;
    const Scalar z1774 = n2 * z1644;
    const Scalar z1773 = n0_02 * z1772;
    const Scalar z1775 = n0_02 * z1774;
    const Scalar z1769 = z1626 + a_delta * z1607 + a_Phi * z1617;
    const Scalar z1767 = a_delta * z1605 - z1634 + a_Phi * z1631;
    const Scalar z1778 = z1666 * (a_epsilon + a_Omega) + z1777;
    const Scalar z1770 = z1637 * z1646;
    const Scalar z1771 = s_epsilon * z1648 - z1664 + z1770 - z1663;
    const Scalar z1776 = s_epsilon * z1773 - n2 * (z1664 - z1770) - c_epsilon * z1775;
    const Scalar z1779 = z1650 + z1637 * z1643 + c_epsilon * z1648 + z1649;
    const Scalar z1720 = z1713 - z1718;
    const Scalar z1780 = s_epsilon * z1775 + c_epsilon * z1773 + n2 * (z1637 * z1643 + z1650);
    const Scalar z1721 = l_lambda_E6_x * z1640 - l_lambda_E6_y * z1642;
    const Scalar z1781 = z1637 * z1658 - z1659 + s_epsilon * z1654 - c_epsilon * z1656 - n2 * (z1643 * z1645 - z1660);
    const Scalar z1784 = n2 * z1646;
    const Scalar z1783 = n2 * z1643;
    const Scalar z1786 = a_epsilon * z1640 - z1669 - a_Omega * z1666;
    const Scalar z1788 = z1661 + a_epsilon * z1642 - a_Omega * z1652;
    const Scalar z1785 = n2 * (s_epsilon * z1648 - z1663) - z1636 * z1783 - z1638 * z1784;
    const Scalar z1787 = z1636 * z1784 - z1638 * z1783 + n2 * (c_epsilon * z1648 + z1649);
    const Scalar z1782 = z1652 * (a_epsilon + a_Omega) - z1781;
    const Scalar z1797 = n1 / z1496;
    const Scalar z1798 = z1495 * z1797;
    const Scalar z1789 = n1 / z1652;
    const Scalar z1793 = n1 / z1617;
    const Scalar z1790 = z1666 * z1789;
    const Scalar z1794 = z1631 * z1793;
    const Scalar z1806 = z1564 * z1564;
    const Scalar z1799 = z1576 * z1798 + z1594;
    const Scalar z1792 = z1640 - z1642 * z1790;
    const Scalar z1796 = z1605 - z1607 * z1794;
    const Scalar z1791 = z1576 * z1790 + z1594;
    const Scalar z1816 = z1799 * z1799;
    const Scalar z1800 = n1 / z1799;
    const Scalar z1821 = z1792 * z1792;
    const Scalar z1803 = n1 / z1792;
    const Scalar z1824 = z1796 * z1796;
    const Scalar z1804 = n1 / z1796;
    const Scalar z1795 = z1576 * z1794 - z1594;
    const Scalar z1827 = z1562 + z1564 * z1798;
    const Scalar z1817 = z1562 * z1562;
    const Scalar z1807 = k28 * z1576;
    const Scalar z1818 = k28 * z1594;
    const Scalar z1805 = z1652 * z1652;
    const Scalar z1808 = z1642 * z1642 / z1500 + z1806 / z1508 + z1576 * z1807 + k29 * z1805;
    const Scalar z1810 = z1617 * z1617;
    const Scalar z1811 = z1607 * z1607 / z1504 + z1806 / z1508 + z1576 * z1807 + k29 * z1810;
    const Scalar z1801 = z1791 * z1800;
    const Scalar z1802 = z1795 * z1800;
    const Scalar z1832 = z1800 * z1827;
    const Scalar z1828 = z1562 + z1564 * z1790 - z1801 * z1827;
    const Scalar z1829 = z1562 - z1564 * z1794 + z1802 * z1827;
    const Scalar z1809 = k8 * z1808;
    const Scalar z1812 = k8 * z1811;
    const Scalar z1830 = z1804 * z1829;
    const Scalar z1831 = z1803 * z1828;
    const Scalar z1833 = z1564 - z1576 * z1832;
    const Scalar z1834 = z1797 * z1833;
    const Scalar z1835 = z1564 - z1576 * z1832 - z1607 * z1830;
    const Scalar z1837 = z1564 - z1576 * z1832 + z1642 * z1831;
    const Scalar z1836 = z1793 * z1835;
    const Scalar z1838 = z1789 * z1837;
    const Scalar z1839 = z1593 + z1734 * z1832 + z1590 * z1834;
    const Scalar z1841 = z1593 + z1734 * z1832 - z1630 * z1830 - z1752 * z1836;
    const Scalar z1843 = z1593 + z1734 * z1832 + z1665 * z1831 + z1771 * z1838;
    const Scalar z1842 = z1575 + z1742 * z1832 + z1616 * z1830 + z1760 * z1836;
    const Scalar z1844 = z1575 + z1742 * z1832 + z1651 * z1831 + z1779 * z1838;
    const Scalar z1840 = z1575 + z1742 * z1832 + z1566 * z1834;
    const Scalar z1845 = z1798 * z1839 + z1840;
    const Scalar z1857 = z1730 + z1739 * z1832 + z1747 * z1834;
    const Scalar z1858 = z1732 + z1743 * z1832 + z1750 * z1834;
    const Scalar z1846 = z1844 + z1790 * z1843 - z1801 * z1845;
    const Scalar z1847 = z1794 * z1841 - z1842 - z1802 * z1845;
    const Scalar z1850 = z1800 * z1845;
    const Scalar z1851 = z1576 * z1850 - z1839;
    const Scalar z1848 = z1804 * z1847;
    const Scalar z1849 = z1803 * z1846;
    const Scalar z1855 = z1576 * z1850 - z1843 - z1642 * z1849;
    const Scalar z1852 = z1797 * z1851;
    const Scalar z1853 = z1576 * z1850 - z1841 - z1607 * z1848;
    const Scalar z1863 = z1798 * z1857 + z1858;
    const Scalar z1868 = z1800 * z1863;
    const Scalar z1854 = z1793 * z1853;
    const Scalar z1856 = z1789 * z1855;
    const Scalar z1859 = z1730 + z1739 * z1832 - z1766 * z1830 - z1757 * z1836;
    const Scalar z1869 = z1576 * z1868 - z1857;
    const Scalar z1861 = z1730 + z1739 * z1832 + z1785 * z1831 + z1776 * z1838;
    const Scalar z1870 = z1797 * z1869;
    const Scalar z1860 = z1732 + z1743 * z1832 + z1768 * z1830 + z1761 * z1836;
    const Scalar z1862 = z1732 + z1743 * z1832 + z1787 * z1831 + z1780 * z1838;
    const Scalar z1865 = z1794 * z1859 - z1860 - z1802 * z1863;
    const Scalar z1864 = z1862 + z1790 * z1861 - z1801 * z1863;
    const Scalar z1813 = z1496 * z1496;
    const Scalar z1814 = z1806 / z1508 + z1576 * z1807 + k30 * z1813;
    const Scalar z1866 = z1804 * z1865;
    const Scalar z1819 = k30 * z1495 * z1495 + z1817 / z1508 + z1594 * z1818;
    const Scalar z1815 = k26 * z1814;
    const Scalar z1820 = k10 * z1819;
    const Scalar z1875 = z1739 * z1850;
    const Scalar z1879 = z1875 + z1766 * z1848 + z1757 * z1854;
    const Scalar z1881 = z1776 * z1856 - z1875 - z1785 * z1849;
    const Scalar z1876 = z1747 * z1852 - z1875;
    const Scalar z1877 = z1743 * z1850;
    const Scalar z1878 = z1750 * z1852 - z1877;
    const Scalar z1880 = z1768 * z1848 - z1877 + z1761 * z1854;
    const Scalar z1867 = z1803 * z1864;
    const Scalar z1871 = z1576 * z1868 - z1859 - z1607 * z1866;
    const Scalar z1872 = z1793 * z1871;
    const Scalar z1873 = z1576 * z1868 - z1861 - z1642 * z1867;
    const Scalar z1874 = z1789 * z1873;
    const Scalar z1822 = z1640 * z1640 / z1500 + z1817 / z1508 + z1594 * z1818 + k29 * z1666 * z1666;
    const Scalar z1882 = z1780 * z1856 - z1877 - z1787 * z1849;
    const Scalar z1825 = z1605 * z1605 / z1504 + z1817 / z1508 + z1594 * z1818 + k29 * z1631 * z1631;
    const Scalar z1823 = z1500 * z1822;
    const Scalar z1885 = z1731 - z1741 * z1832 - z1767 * z1830 - z1759 * z1836;
    const Scalar z1826 = z1504 * z1825;
    const Scalar z1886 = z1733 - z1745 * z1832 - z1769 * z1830 - z1763 * z1836;
    const Scalar z1892 = z1880 + z1886;
    const Scalar z1941 = z1680 - z1684 * z1832;
    const Scalar z1887 = z1731 - z1741 * z1832 - z1786 * z1831 + z1778 * z1838;
    const Scalar z1883 = z1731 - z1741 * z1832 + z1748 * z1834;
    const Scalar z1889 = z1876 - z1883;
    const Scalar z1888 = z1733 - z1745 * z1832 + z1788 * z1831 - z1782 * z1838;
    const Scalar z1884 = z1733 - z1745 * z1832 - z1751 * z1834;
    const Scalar z1890 = z1878 + z1884;
    const Scalar z1942 = z1681 + z1685 * z1832;
    const Scalar z1891 = z1879 + z1885;
    const Scalar z1893 = z1881 - z1887;
    const Scalar z1894 = z1882 + z1888;
    const Scalar z1944 = z1705 * z1830 + z1696 * z1836;
    const Scalar z1946 = z1719 * z1831 + z1710 * z1838;
    const Scalar z1945 = z1707 * z1830 + z1701 * z1836;
    const Scalar z1947 = z1715 * z1838 - z1721 * z1831;
    const Scalar z1919 = z1506 * z1832 + z1508;
    const Scalar z1920 = z1506 + k10 * z1832;
    const Scalar z1895 = z1798 * z1889 + z1890;
    const Scalar z1907 = z1724 * z1798 + z1725;
    const Scalar z1955 = z1554 + z1576 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z1594 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z1936 = z1678 * z1850;
    const Scalar z1948 = z1936 + z1941;
    const Scalar z1928 = z1678 * z1832 - z1679;
    const Scalar z1923 = z1504 * z1830 + z1502 * z1836;
    const Scalar z1925 = z1500 * z1831 + z1498 * z1838;
    const Scalar z1897 = z1892 + z1802 * z1895 + z1794 * z1891;
    const Scalar z1909 = z1723 * z1794 - z1727 - z1802 * z1907;
    const Scalar z1922 = z1502 * z1830 + k8 * z1836;
    const Scalar z1898 = z1804 * z1897;
    const Scalar z1910 = z1804 * z1909;
    const Scalar z1896 = z1894 + z1790 * z1893 - z1801 * z1895;
    const Scalar z1908 = z1722 * z1790 + z1726 - z1801 * z1907;
    const Scalar z1957 = l_lambda_E4_x * z1617 - z1548 - l_lambda_E4_y * z1631;
    const Scalar z1956 = z1552 + l_lambda_E3_x * z1496 + l_lambda_E3_y * z1495;
    const Scalar z1958 = l_lambda_E4_x * z1607 - z1551 - l_lambda_E4_y * z1605;
    const Scalar z1900 = z1800 * z1895;
    const Scalar z1912 = z1800 * z1907;
    const Scalar z1901 = z1576 * z1900 - z1889;
    const Scalar z1913 = z1576 * z1912 - z1724;
    const Scalar z1938 = z1706 * z1848 + z1699 * z1854;
    const Scalar z1950 = z1938 + z1945;
    const Scalar z1930 = z1706 * z1830 + z1699 * z1836;
    const Scalar z1937 = z1704 * z1848;
    const Scalar z1949 = z1937 - z1944;
    const Scalar z1902 = z1797 * z1901;
    const Scalar z1914 = z1797 * z1913;
    const Scalar z1929 = z1704 * z1830;
    const Scalar z1924 = z1498 * z1831 + k8 * z1838;
    const Scalar z1899 = z1803 * z1896;
    const Scalar z1959 = z1543 + l_lambda_E6_x * z1652 + l_lambda_E6_y * z1666;
    const Scalar z1960 = z1546 + l_lambda_E6_x * z1642 + l_lambda_E6_y * z1640;
    const Scalar z1961 = z1564 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z1557 - z1562 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y) - z1832 * z1955 - z1830 * z1958 + z1831 * z1960 - z1836 * z1957 - z1838 * z1959
        - z1834 * z1956;
    const Scalar z1911 = z1803 * z1908;
    const Scalar z1903 = z1576 * z1900 + z1891 + z1607 * z1898;
    const Scalar z1915 = z1576 * z1912 - z1723 - z1607 * z1910;
    const Scalar z1940 = z1713 * z1856 - z1720 * z1849;
    const Scalar z1952 = z1940 + z1947;
    const Scalar z1932 = z1720 * z1831 + z1713 * z1838;
    const Scalar z1939 = z1718 * z1849;
    const Scalar z1951 = z1939 + z1946;
    const Scalar z1931 = z1718 * z1831;
    const Scalar z1933 = z1674 * z1832 - z1928 + z1836 * z1929 - z1838 * z1931 - z1830 * z1930 + z1831 * z1932;
    const Scalar z1904 = z1793 * z1903;
    const Scalar z1916 = z1793 * z1915;
    const Scalar z1905 = z1576 * z1900 - z1893 - z1642 * z1899;
    const Scalar z1917 = z1576 * z1912 - z1722 - z1642 * z1911;
    const Scalar z1906 = z1789 * z1905;
    const Scalar z1918 = z1789 * z1917;
    const Scalar z1943 = z1693 * z1834;
    const Scalar z1953 = z1832 * z1942 - z1948 - z1836 * z1949 - z1838 * z1951 + z1830 * z1950 - z1831 * z1952 + z1834
        * z1943;
    const Scalar z1921 = k26 * z1834;
    const Scalar z1926 = z1832 * z1920 + z1919 + z1834 * z1921 + z1830 * z1923 + z1831 * z1925 + z1836 * z1922 + z1838
        * z1924;
    const Scalar z1927 = z1870 * z1921 - z1868 * z1920 + z1866 * z1923 - z1867 * z1925 + z1872 * z1922 + z1874 * z1924;
    const Scalar z1935 = z1900 * z1920 - z1902 * z1921 + z1898 * z1923 + z1899 * z1925 - z1904 * z1922 - z1906 * z1924;
    const Scalar z1962 = z1914 * z1921 - z1912 * z1920 + z1910 * z1923 - z1911 * z1925 + z1916 * z1922 + z1918 * z1924;
    const Scalar z1954 = z1935 + z1953;
    const Scalar z1934 = z1927 + z1933;
    const Scalar z1964 = n1 / z1926;
    const Scalar z1963 = z1961 - z1962;
    const Scalar z1965 = z1954 * z1964;
    const Scalar z1966 = z1934 * z1964;
    result.M[0] = z1508;
    result.M[1] = z1506;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = z1506;
    result.M[8] = k10;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = n0;
    result.M[16] = k26;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = n0;
    result.M[23] = n0;
    result.M[24] = k8;
    result.M[25] = z1502;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = n0;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = z1502;
    result.M[32] = z1504;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n0;
    result.M[36] = n0;
    result.M[37] = n0;
    result.M[38] = n0;
    result.M[39] = n0;
    result.M[40] = k8;
    result.M[41] = z1498;
    result.M[42] = n0;
    result.M[43] = n0;
    result.M[44] = n0;
    result.M[45] = n0;
    result.M[46] = n0;
    result.M[47] = z1498;
    result.M[48] = z1500;
    result.C[0] = -z1679;
    result.C[1] = -z1674;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z1678;
    result.C[8] = n0;
    result.C[9] = n0;
    result.C[10] = n0;
    result.C[11] = n0;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = n0;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = n0;
    result.C[18] = n0;
    result.C[19] = n0;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = n0;
    result.C[23] = n0;
    result.C[24] = n0;
    result.C[25] = z1699;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z1704;
    result.C[32] = z1706;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z1713;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z1718;
    result.C[48] = -z1720;
    result.K[0] = z1680;
    result.K[1] = -z1681;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z1684;
    result.K[8] = -z1685;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z1693;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z1696;
    result.K[25] = -z1701;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z1705;
    result.K[32] = -z1707;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = z1710;
    result.K[41] = z1715;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = z1719;
    result.K[48] = -z1721;
    result.F[0] = -z1564 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z1557 + z1562 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    result.F[1] = z1554 + z1576 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z1594 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    result.F[2] = -z1552 - l_lambda_E3_x * z1496 - l_lambda_E3_y * z1495;
    result.F[3] = l_lambda_E4_x * z1617 - z1548 - l_lambda_E4_y * z1631;
    result.F[4] = l_lambda_E4_x * z1607 - z1551 - l_lambda_E4_y * z1605;
    result.F[5] = z1543 + l_lambda_E6_x * z1652 + l_lambda_E6_y * z1666;
    result.F[6] = -z1546 - l_lambda_E6_x * z1642 - l_lambda_E6_y * z1640;
    result.M_r[0] = z1926;
    result.C_r[0] = -z1934;
    result.K_r[0] = -z1954;
    result.F_r[0] = -z1963;
    result.A[0] = n0;
    result.A[1] = z1965;
    result.A[2] = n1;
    result.A[3] = z1966;
    if (!(traits::regular(z1805, z1809) && traits::regular(z1810, z1812) && traits::regular(z1813, z1815)
        && traits::regular(z1816, z1820) && traits::regular(z1821, z1823) && traits::regular(z1824, z1826)
        && traits::regular(z1926, z1926))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[0] * result.M[1] * result.M[7] * result.M[25] * result.M[31] * result.M[32]
        * result.M[41] * result.M[47] * result.M[48] * result.C[0] * result.C[1]) * (n0 * result.C[7] * result.C[25]
        * result.C[31] * result.C[32] * result.C[41] * result.C[47] * result.C[48] * result.K[0] * result.K[1]
        * result.K[7] * result.K[8])) * ((n0 * result.K[16] * result.K[24] * result.K[25] * result.K[31] * result.K[32]
        * result.K[40] * result.K[41] * result.K[47] * result.K[48] * result.F[0] * result.F[1]) * (n0 * result.F[2]
        * result.F[3] * result.F[4] * result.F[5] * result.F[6] * result.M_r[0] * result.C_r[0] * result.K_r[0]
        * result.F_r[0] * result.A[1] * result.A[3]));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Residual of the equations of motion, zero along motions:
  /// r = (M a + h - A' lambda - E u, A a + gamma).
  TORSOR_DEVICE static void residual(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, const Inputs&, std::array<Scalar, 13>& residual) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar k3 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k4 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k6 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k7 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar k10 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k11 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k12 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k13 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k16 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k17 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k19 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k25 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z1980 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1981 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2029 = n0_028 * c_Theta;
    const Scalar z2030 = n0_028 * s_Theta;
    const Scalar z1977 = v_beta + v_Theta;
    const Scalar z2037 = v_beta * c_beta;
    const Scalar z1999 = v_beta * v_beta;
    const Scalar z1978 = v_delta + v_Phi;
    const Scalar z2038 = v_Theta * c_Theta;
    const Scalar z1979 = v_epsilon + v_Omega;
    const Scalar z2040 = v_beta * s_beta;
    const Scalar z2041 = v_Theta * s_Theta;
    const Scalar z1988 = k3 * s_gamma + k4 * c_gamma;
    const Scalar z2000 = n0_175 * z1999;
    const Scalar z2007 = z1977 * z1977;
    const Scalar z2013 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z2015 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z1989 = k4 * s_gamma - k3 * c_gamma;
    const Scalar z2002 = v_epsilon * v_epsilon;
    const Scalar z2003 = z1979 * z1979;
    const Scalar z2005 = z1978 * z1978;
    const Scalar z2008 = k6 * z2007;  // force on K2, times 0.04 m, x
    const Scalar z2009 = n0_175 * a_beta;
    const Scalar z2011 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z2016 = k7 * z2015;  // force on K6, times 0.04 m, y
    const Scalar z2010 = s_Theta * z2000 + c_Theta * z2009;
    const Scalar z2020 = k7 * z2013;  // force on K4, times 0.04 m, x
    const Scalar z2004 = k7 * z2003;  // force on K6, times 0.04 m, x
    const Scalar z2018 = s_Omega * z2016 + c_Omega * z2004;
    const Scalar z2036 = v_gamma * c_gamma;
    const Scalar z2006 = k7 * z2005;  // force on K4, times 0.04 m, y
    const Scalar z2022 = s_Phi * z2020 + c_Phi * z2006;
    const Scalar z2001 = v_delta * v_delta;
    const Scalar z2014 = a_epsilon * s_Omega - c_Omega * z2002;
    const Scalar z2012 = a_delta * s_Phi - c_Phi * z2001;
    const Scalar z2025 = k6 * z2011;  // force on K2, times 0.04 m, y
    const Scalar z2027 = s_Theta * z2008 - c_Theta * z2025;
    const Scalar z1984 = n0_035 * s_gamma;
    const Scalar z1985 = n0_035 * c_gamma;
    const Scalar z2031 = n0_007 - z2029;
    const Scalar z2032 = s_beta * z2030;
    const Scalar z2034 = c_beta * z2030;
    const Scalar z2039 = n0_028 * z2038;
    const Scalar z2033 = c_beta * z2031 + z2032;
    const Scalar z2035 = s_beta * z2031 - z2034;
    const Scalar z1982 = k10 - z1980;
    const Scalar z2042 = n0_028 * z2041;
    const Scalar z1983 = k11 + z1981;
    const Scalar z2043 = s_beta * z2029 + z2034;
    const Scalar z2044 = v_gamma * s_gamma;
    const Scalar z2045 = v_gamma * z2044;
    const Scalar z1990 = n0_02 - z1988;
    const Scalar z1991 = n0_018 - z1989;
    const Scalar z2017 = k7 * z2014 - k12 * z2015;  // moment on K6, z
    const Scalar z2021 = k12 * z2013 + k7 * z2012;  // moment on K4, z
    const Scalar z2026 = k6 * z2010 - k13 * z2011;  // moment on K2, z
    const Scalar z1986 = n0_014 + z1982;
    const Scalar z2046 = n0_035 * z2045;
    const Scalar z1987 = n0_072 - z1983;
    const Scalar z2047 = v_Theta * z2041;
    const Scalar z2049 = v_Theta * z2038;
    const Scalar z2051 = v_beta * z2040;
    const Scalar z2048 = n0_028 * z2047;
    const Scalar z2050 = n0_028 * z2049;
    const Scalar z2023 = k16 * a_delta + z2022 + z2021;  // moment on K5, z
    const Scalar z1992 = z1986 * z1986 + z1987 * z1987;
    const Scalar z2052 = v_beta * z2037;
    const Scalar z2019 = k17 * a_epsilon - z2018 - z2017;  // moment on K7, z
    const Scalar z2028 = n0_033 - k19 * a_beta - n0_175 * z2027 + z2026;  // moment on K1, z
    const Scalar z1993 = traits::sqrt(z1992);
    const Scalar z2053 = z2030 * z2051 + z2031 * z2052 + s_beta * z2048 - c_beta * z2050 - n2 * (z2037 * z2039 - z2040
        * z2042);
    const Scalar z1994 = n1 / z1993;
    const Scalar z2054 = z2046 - z2053;
    const Scalar z1995 = n4530 - n352_6605 * z1994;
    const Scalar z2055 = c_beta * z2029 - z2032;
    const Scalar z1996 = z1990 * z1995;
    const Scalar z2056 = v_gamma * z2036;
    const Scalar z1997 = z1991 * z1995;
    const Scalar z2057 = n0_035 * z2056;
    const Scalar z1998 = n0_018 * z1996 - n0_02 * z1997;
    const Scalar z2058 = z2030 * z2052 - z2031 * z2051 + s_beta * z2050 + c_beta * z2048 + n2 * (z2037 * z2042 + z2039
        * z2040);
    const Scalar z2060 = n0_02 * s_Phi;
    const Scalar z2070 = v_delta * s_delta;
    const Scalar z2061 = n0_02 * c_Phi;
    const Scalar z2062 = n0_04 + z2060;
    const Scalar z2067 = v_delta * c_delta;
    const Scalar z2078 = v_delta * z2070;
    const Scalar z2068 = v_Phi * s_Phi;
    const Scalar z2071 = v_Phi * c_Phi;
    const Scalar z2079 = v_delta * z2067;
    const Scalar z2059 = z2057 - z2058;
    const Scalar z2074 = v_Phi * z2071;
    const Scalar z2072 = n0_02 * z2071;
    const Scalar z2076 = v_Phi * z2068;
    const Scalar z2077 = n0_02 * z2076;
    const Scalar z2075 = n0_02 * z2074;
    const Scalar z2069 = n0_02 * z2068;
    const Scalar z2063 = s_delta * z2061;
    const Scalar z2065 = c_delta * z2061;
    const Scalar z2064 = c_delta * z2062 + z2063;
    const Scalar z2082 = c_delta * z2060 + z2063;
    const Scalar z2073 = s_delta * z2060 - z2065;
    const Scalar z2066 = s_delta * z2062 - z2065;
    const Scalar z2080 = z2061 * z2078 + z2062 * z2079 + s_delta * z2075 + c_delta * z2077 + n2 * (z2067 * z2069 + z2070
        * z2072);
    const Scalar z2083 = z2062 * z2078 - z2061 * z2079 + s_delta * z2077 - c_delta * z2075 - n2 * (z2067 * z2072 - z2069
        * z2070);
    const Scalar z2081 = z2053 - z2080;
    const Scalar z2024 = k25 * a_gamma + z1998;  // moment on K3, z
    const Scalar z2096 = v_Omega * s_Omega;
    const Scalar z2095 = v_epsilon * s_epsilon;
    const Scalar z2099 = v_Omega * z2096;
    const Scalar z2085 = n0_02 * c_Omega;
    const Scalar z2111 = a_beta * z2035 - a_Theta * z2043 - a_delta * z2066 - a_Phi * z2073 + z2081;
    const Scalar z2086 = n0_02 * s_Omega;
    const Scalar z2092 = v_epsilon * c_epsilon;
    const Scalar z2100 = n0_02 * z2099;
    const Scalar z2104 = v_epsilon * z2095;
    const Scalar z2112 = a_beta * z2035 - a_Theta * z2043 + a_gamma * z1985 - z2054;
    const Scalar z2093 = v_Omega * c_Omega;
    const Scalar z2087 = n0_04 - z2086;
    const Scalar z2113 = a_beta * z2033 - a_Theta * z2055 - a_gamma * z1984 - z2059;
    const Scalar z2103 = v_epsilon * z2092;
    const Scalar z2101 = v_Omega * z2093;
    const Scalar z2102 = n0_02 * z2101;
    const Scalar z2094 = n0_02 * z2093;
    const Scalar z2097 = n0_02 * z2096;
    const Scalar z2084 = z2058 + z2083;
    const Scalar z2115 = a_beta * z2033 - a_Theta * z2055 - a_delta * z2064 - a_Phi * z2082 + z2084;
    const Scalar z2088 = c_epsilon * z2085;
    const Scalar z2090 = s_epsilon * z2085;
    const Scalar z2089 = s_epsilon * z2087 + z2088;
    const Scalar z2107 = s_epsilon * z2086 - z2088;
    const Scalar z2098 = c_epsilon * z2086 + z2090;
    const Scalar z2091 = c_epsilon * z2087 - z2090;
    const Scalar z2105 = s_epsilon * z2100 - z2085 * z2103 - z2087 * z2104 - c_epsilon * z2102 - n2 * (z2092 * z2094
        - z2095 * z2097);
    const Scalar z2108 = z2085 * z2104 - z2087 * z2103 + s_epsilon * z2102 + c_epsilon * z2100 + n2 * (z2092 * z2097
        + z2094 * z2095);
    const Scalar z2106 = z2053 + z2105;
    const Scalar z2109 = z2058 + z2108;
    const Scalar z2110 = a_beta * z2035 - a_Theta * z2043 + a_epsilon * z2091 - a_Omega * z2098 + z2106;
    const Scalar z2114 = a_beta * z2033 - a_Theta * z2055 - a_epsilon * z2089 + a_Omega * z2107 + z2109;
    residual[0] = z2035 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z2028 - z2033 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    residual[1] = -z2026 - z2043 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z2055 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    residual[2] = z2024 + l_lambda_E3_x * z1985 + l_lambda_E3_y * z1984;
    residual[3] = -l_lambda_E4_x * z2073 + z2021 + l_lambda_E4_y * z2082;
    residual[4] = -l_lambda_E4_x * z2066 + z2023 + l_lambda_E4_y * z2064;
    residual[5] = -z2017 - l_lambda_E6_x * z2098 - l_lambda_E6_y * z2107;
    residual[6] = z2019 + l_lambda_E6_x * z2091 + l_lambda_E6_y * z2089;
    residual[7] = -z2112;
    residual[8] = z2113;
    residual[9] = -z2111;
    residual[10] = z2115;
    residual[11] = -z2110;
    residual[12] = z2114;
  }

  /// Derivatives of residual by (q, v, a, lambda) without those that vanish identically: `values` of
  /// compressed rows. r = (M a + h - A' lambda - E u, A a + gamma).
  TORSOR_DEVICE static void residual_jacobian(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      ResidualJacobian& result) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar k3 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k4 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k6 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k7 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k11 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar k14 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k15 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k16 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k17 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k18 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k26 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z2159 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z2160 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2210 = n0_028 * c_Theta;
    const Scalar z2211 = n0_028 * s_Theta;
    const Scalar z2156 = v_beta + v_Theta;
    const Scalar z2179 = k3 * s_gamma + k4 * c_gamma;
    const Scalar z2180 = k4 * s_gamma - k3 * c_gamma;
    const Scalar z2187 = v_beta * v_beta;
    const Scalar z2197 = n0_175 * a_beta;
    const Scalar z2199 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z2157 = v_delta + v_Phi;
    const Scalar z2158 = v_epsilon + v_Omega;
    const Scalar z2218 = v_beta * c_beta;
    const Scalar z2219 = v_Theta * c_Theta;
    const Scalar z2188 = n0_175 * z2187;
    const Scalar z2195 = z2156 * z2156;
    const Scalar z2208 = k6 * z2199;  // force on K2, times 0.04 m, y
    const Scalar z2191 = z2158 * z2158;
    const Scalar z2193 = z2157 * z2157;
    const Scalar z2196 = k6 * z2195;  // force on K2, times 0.04 m, x
    const Scalar z2198 = s_Theta * z2197 - c_Theta * z2188;
    const Scalar z2189 = v_delta * v_delta;
    const Scalar z2190 = v_epsilon * v_epsilon;
    const Scalar z2192 = k7 * z2191;  // force on K6, times 0.04 m, x
    const Scalar z2194 = k7 * z2193;  // force on K4, times 0.04 m, y
    const Scalar z2201 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z2203 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z2209 = s_Theta * z2208 + c_Theta * z2196;
    const Scalar z2200 = a_delta * c_Phi + s_Phi * z2189;
    const Scalar z2202 = a_epsilon * c_Omega + s_Omega * z2190;
    const Scalar z2204 = k7 * z2203;  // force on K6, times 0.04 m, y
    const Scalar z2206 = k7 * z2201;  // force on K4, times 0.04 m, x
    const Scalar z2217 = v_gamma * c_gamma;
    const Scalar z2205 = s_Omega * z2192 - c_Omega * z2204;
    const Scalar z2163 = n0_035 * s_gamma;
    const Scalar z2207 = s_Phi * z2194 - c_Phi * z2206;
    const Scalar z2165 = k7 * s_Omega;
    const Scalar z2169 = k7 * s_Phi;
    const Scalar z2173 = k6 * c_Theta;
    const Scalar z2164 = n0_035 * c_gamma;
    const Scalar z2166 = k9 - z2165;
    const Scalar z2167 = k9 - n2 * z2165;
    const Scalar z2170 = k9 + z2169;
    const Scalar z2171 = k9 + n2 * z2169;
    const Scalar z2174 = k11 - n0_175 * z2173;
    const Scalar z2175 = k11 - n0_35 * z2173;
    const Scalar z2212 = n0_007 - z2210;
    const Scalar z2213 = s_beta * z2211;
    const Scalar z2215 = c_beta * z2211;
    const Scalar z2220 = n0_028 * z2219;
    const Scalar z2214 = c_beta * z2212 + z2213;
    const Scalar z2216 = s_beta * z2212 - z2215;
    const Scalar z2161 = k14 - z2159;
    const Scalar z2221 = v_beta * s_beta;
    const Scalar z2162 = k15 + z2160;
    const Scalar z2224 = s_beta * z2210 + z2215;
    const Scalar z2222 = v_Theta * s_Theta;
    const Scalar z2225 = v_gamma * s_gamma;
    const Scalar z2223 = n0_028 * z2222;
    const Scalar z2226 = v_gamma * z2225;
    const Scalar z2227 = n0_035 * z2226;
    const Scalar z2168 = k16 + z2167;
    const Scalar z2230 = v_Theta * z2219;
    const Scalar z2228 = v_Theta * z2222;
    const Scalar z2229 = n0_028 * z2228;
    const Scalar z2231 = n0_028 * z2230;
    const Scalar z2172 = k17 + z2171;
    const Scalar z2232 = v_beta * z2221;
    const Scalar z2233 = v_beta * z2218;
    const Scalar z2235 = z2221 * z2223;
    const Scalar z2234 = z2211 * z2232;
    const Scalar z2176 = k18 + z2175;
    const Scalar z2181 = n0_02 - z2179;
    const Scalar z2182 = n0_018 - z2180;
    const Scalar z2236 = z2234 + z2212 * z2233 + s_beta * z2229 - c_beta * z2231 - n2 * (z2218 * z2220 - z2235);
    const Scalar z2177 = n0_014 + z2161;
    const Scalar z2178 = n0_072 - z2162;
    const Scalar z2237 = c_beta * z2210 - z2213;
    const Scalar z2240 = z2211 * z2233;
    const Scalar z2183 = z2177 * z2177 + z2178 * z2178;
    const Scalar z2243 = n0_02 * s_Phi;
    const Scalar z2241 = z2218 * z2223;
    const Scalar z2242 = z2240 + s_beta * z2231 - z2212 * z2232 + c_beta * z2229 + n2 * (z2220 * z2221 + z2241);
    const Scalar z2184 = traits::sqrt(z2183);
    const Scalar z2244 = n0_02 * c_Phi;
    const Scalar z2238 = v_gamma * z2217;
    const Scalar z2239 = n0_035 * z2238;
    const Scalar z2185 = n1 / z2184;
    const Scalar z2245 = n0_04 + z2243;
    const Scalar z2186 = n4530 - n352_6605 * z2185;
    const Scalar z2301 = n2 * z2156;
    const Scalar z2302 = k6 * z2301;
    const Scalar z2250 = v_delta * c_delta;
    const Scalar z2253 = v_delta * s_delta;
    const Scalar z2277 = v_epsilon * c_epsilon;
    const Scalar z2278 = v_Omega * c_Omega;
    const Scalar z2280 = v_epsilon * s_epsilon;
    const Scalar z2303 = s_Theta * z2302;
    const Scalar z2281 = v_Omega * s_Omega;
    const Scalar z2261 = v_delta * z2253;
    const Scalar z2262 = v_delta * z2250;
    const Scalar z2270 = n0_02 * c_Omega;
    const Scalar z2284 = v_Omega * z2281;
    const Scalar z2304 = n0_175 * z2303;
    const Scalar z2286 = v_Omega * z2278;
    const Scalar z2285 = n0_02 * z2284;
    const Scalar z2287 = n0_02 * z2286;
    const Scalar z2288 = v_epsilon * z2277;
    const Scalar z2289 = v_epsilon * z2280;
    const Scalar z2251 = v_Phi * s_Phi;
    const Scalar z2254 = v_Phi * c_Phi;
    const Scalar z2263 = z2244 * z2261;
    const Scalar z2267 = z2244 * z2262;
    const Scalar z2290 = z2270 * z2288;
    const Scalar z2294 = z2270 * z2289;
    const Scalar z2257 = v_Phi * z2254;
    const Scalar z2259 = v_Phi * z2251;
    const Scalar z2258 = n0_02 * z2257;
    const Scalar z2260 = n0_02 * z2259;
    const Scalar z2271 = n0_02 * s_Omega;
    const Scalar z2272 = n0_04 - z2271;
    const Scalar z2252 = n0_02 * z2251;
    const Scalar z2282 = n0_02 * z2281;
    const Scalar z2255 = n0_02 * z2254;
    const Scalar z2264 = z2250 * z2252;
    const Scalar z2268 = z2252 * z2253;
    const Scalar z2279 = n0_02 * z2278;
    const Scalar z2291 = z2280 * z2282;
    const Scalar z2295 = z2277 * z2282;
    const Scalar z2248 = c_delta * z2244;
    const Scalar z2275 = s_epsilon * z2270;
    const Scalar z2246 = s_delta * z2244;
    const Scalar z2306 = z2214 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z2216 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z2273 = c_epsilon * z2270;
    const Scalar z2297 = n2 * v_beta;
    const Scalar z2298 = n0_175 * z2297;
    const Scalar z2256 = s_delta * z2243 - z2248;
    const Scalar z2249 = s_delta * z2245 - z2248;
    const Scalar z2283 = c_epsilon * z2271 + z2275;
    const Scalar z2276 = c_epsilon * z2272 - z2275;
    const Scalar z2299 = s_Theta * z2298;
    const Scalar z2247 = c_delta * z2245 + z2246;
    const Scalar z2312 = n2 * (z2159 * z2178 - z2160 * z2177);
    const Scalar z2313 = n0_5 * z2312 / z2184;
    const Scalar z2308 = k6 * z2198;
    const Scalar z2323 = n2 * z2157;
    const Scalar z2309 = n0_175 * z2209 + z2308;
    const Scalar z2311 = z2224 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z2308 + z2237 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z2310 = z2224 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z2309 + z2237 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z2266 = c_delta * z2243 + z2246;
    const Scalar z2320 = k7 * z2200;
    const Scalar z2324 = k7 * z2323;
    const Scalar z2300 = k6 * z2299;
    const Scalar z2305 = z2300 - z2304;
    const Scalar z2307 = z2224 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z2237 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z2314 = z2313 / (z2184 * z2184);
    const Scalar z2265 = z2263 + z2245 * z2262 + s_delta * z2258 + c_delta * z2260 + n2 * (z2253 * z2255 + z2264);
    const Scalar z2325 = c_Phi * z2324;
    const Scalar z2326 = z2207 - z2320;
    const Scalar z2328 = n2 * v_delta;
    const Scalar z2269 = z2245 * z2261 - z2267 + s_delta * z2260 - c_delta * z2258 - n2 * (z2250 * z2255 - z2268);
    const Scalar z2315 = n352_6605 * z2314;
    const Scalar z2329 = c_Phi * z2328;
    const Scalar z2330 = k7 * z2329;
    const Scalar z2333 = l_lambda_E4_x * z2247 + l_lambda_E4_y * z2249;
    const Scalar z2316 = z2180 * z2186 - z2181 * z2315;
    const Scalar z2317 = z2179 * z2186 + z2182 * z2315;
    const Scalar z2332 = z2325 - z2330;
    const Scalar z2318 = n0_018 * z2316 + n0_02 * z2317;
    const Scalar z2274 = s_epsilon * z2272 + z2273;
    const Scalar z2351 = z2242 + a_beta * z2214 - a_Theta * z2237;
    const Scalar z2337 = n2 * z2158;
    const Scalar z2293 = s_epsilon * z2271 - z2273;
    const Scalar z2334 = k7 * z2202;
    const Scalar z2319 = l_lambda_E3_x * z2163 - z2318 - l_lambda_E3_y * z2164;
    const Scalar z2338 = k7 * z2337;
    const Scalar z2339 = c_Omega * z2338;
    const Scalar z2340 = z2205 - z2334;
    const Scalar z2347 = l_lambda_E6_x * z2274 - l_lambda_E6_y * z2276;
    const Scalar z2348 = n2 * z2221;
    const Scalar z2349 = n2 * z2218;
    const Scalar z2350 = z2211 * z2348 + z2212 * z2349 + n2 * (s_beta * z2223 - c_beta * z2220);
    const Scalar z2342 = n2 * v_epsilon;
    const Scalar z2343 = c_Omega * z2342;
    const Scalar z2292 = s_epsilon * z2285 - z2290 - z2272 * z2289 - c_epsilon * z2287 - n2 * (z2277 * z2279 - z2291);
    const Scalar z2352 = z2211 * z2349 - z2212 * z2348 + n2 * (s_beta * z2220 + c_beta * z2223);
    const Scalar z2353 = z2236 + a_beta * z2216 - a_Theta * z2224;
    const Scalar z2354 = n2 * z2222;
    const Scalar z2355 = n0_028 * z2354;
    const Scalar z2344 = k7 * z2343;
    const Scalar z2346 = z2339 - z2344;
    const Scalar z2296 = z2294 + s_epsilon * z2287 - z2272 * z2288 + c_epsilon * z2285 + n2 * (z2279 * z2280 + z2295);
    const Scalar z2359 = z2240 + z2210 * z2232 + s_beta * z2231 + c_beta * z2229 + n2 * (z2220 * z2221 + z2241);
    const Scalar z2362 = z2234 + s_beta * z2229 - z2210 * z2233 - c_beta * z2231 - n2 * (z2218 * z2220 - z2235);
    const Scalar z2375 = z2243 * z2261 - z2267 + s_delta * z2260 - c_delta * z2258 - n2 * (z2250 * z2255 - z2268);
    const Scalar z2378 = z2263 + z2243 * z2262 + s_delta * z2258 + c_delta * z2260 + n2 * (z2253 * z2255 + z2264);
    const Scalar z2360 = z2237 * (a_beta + a_Theta) - z2359;
    const Scalar z2363 = z2224 * (a_beta + a_Theta) - z2362;
    const Scalar z2366 = a_gamma * z2163 + z2239;
    const Scalar z2369 = a_gamma * z2164 - z2227;
    const Scalar z2376 = z2266 * (a_delta + a_Phi) - z2375;
    const Scalar z2379 = z2256 * (a_delta + a_Phi) + z2378;
    const Scalar z2356 = n2 * z2219;
    const Scalar z2370 = n2 * z2254;
    const Scalar z2372 = n2 * z2251;
    const Scalar z2357 = n0_028 * z2356;
    const Scalar z2371 = n0_02 * z2370;
    const Scalar z2373 = n0_02 * z2372;
    const Scalar z2364 = n2 * z2225;
    const Scalar z2365 = n0_035 * z2364;
    const Scalar z2367 = n2 * z2217;
    const Scalar z2368 = n0_035 * z2367;
    const Scalar z2358 = s_beta * z2355 - n2 * (z2210 * z2218 - z2211 * z2221) - c_beta * z2357;
    const Scalar z2361 = s_beta * z2357 + c_beta * z2355 + n2 * (z2210 * z2221 + z2211 * z2218);
    const Scalar z2374 = s_delta * z2371 + c_delta * z2373 + n2 * (z2243 * z2250 + z2244 * z2253);
    const Scalar z2377 = s_delta * z2373 - c_delta * z2371 + n2 * (z2243 * z2253 - z2244 * z2250);
    const Scalar z2380 = n2 * z2253;
    const Scalar z2321 = l_lambda_E4_y * z2256;
    const Scalar z2322 = l_lambda_E4_x * z2266 - z2320 + z2321;
    const Scalar z2385 = z2265 + a_delta * z2249 + a_Phi * z2256;
    const Scalar z2383 = a_delta * z2247 - z2269 + a_Phi * z2266;
    const Scalar z2327 = l_lambda_E4_x * z2266 + z2321 + z2326;
    const Scalar z2331 = l_lambda_E4_x * z2266 + z2321;
    const Scalar z2391 = z2294 + z2271 * z2288 + s_epsilon * z2287 + c_epsilon * z2285 + n2 * (z2279 * z2280 + z2295);
    const Scalar z2394 = z2271 * z2289 - z2290 + s_epsilon * z2285 - c_epsilon * z2287 - n2 * (z2277 * z2279 - z2291);
    const Scalar z2392 = z2293 * (a_epsilon + a_Omega) + z2391;
    const Scalar z2386 = n2 * z2281;
    const Scalar z2388 = n2 * z2278;
    const Scalar z2387 = n0_02 * z2386;
    const Scalar z2389 = n0_02 * z2388;
    const Scalar z2381 = n2 * z2250;
    const Scalar z2382 = z2244 * z2380 + z2245 * z2381 + n2 * (s_delta * z2255 + c_delta * z2252);
    const Scalar z2384 = z2245 * z2380 - z2244 * z2381 + n2 * (s_delta * z2252 - c_delta * z2255);
    const Scalar z2335 = l_lambda_E6_y * z2283;
    const Scalar z2336 = l_lambda_E6_x * z2293 - z2334 - z2335;
    const Scalar z2397 = n2 * z2280;
    const Scalar z2396 = n2 * z2277;
    const Scalar z2399 = a_epsilon * z2274 - z2296 - a_Omega * z2293;
    const Scalar z2341 = l_lambda_E6_x * z2293 - z2335 + z2340;
    const Scalar z2345 = l_lambda_E6_x * z2293 - z2335;
    const Scalar z2390 = s_epsilon * z2387 - n2 * (z2270 * z2277 - z2271 * z2280) - c_epsilon * z2389;
    const Scalar z2393 = s_epsilon * z2389 + c_epsilon * z2387 + n2 * (z2270 * z2280 + z2271 * z2277);
    const Scalar z2395 = z2283 * (a_epsilon + a_Omega) - z2394;
    const Scalar z2398 = n2 * (s_epsilon * z2282 - c_epsilon * z2279) - z2270 * z2396 - z2272 * z2397;
    const Scalar z2400 = z2270 * z2397 - z2272 * z2396 + n2 * (s_epsilon * z2279 + c_epsilon * z2282);
    const Scalar z2401 = z2292 + a_epsilon * z2276 - a_Omega * z2283;
    result.values[0] = z2306;
    result.values[1] = -z2310;
    result.values[2] = -z2305;
    result.values[3] = z2304;
    result.values[4] = z2176;
    result.values[5] = z2174;
    result.values[6] = z2216;
    result.values[7] = -z2214;
    result.values[8] = z2216;
    result.values[9] = -z2214;
    result.values[10] = z2216;
    result.values[11] = -z2214;
    result.values[12] = -z2307;
    result.values[13] = -z2311;
    result.values[14] = -z2300;
    result.values[15] = z2174;
    result.values[16] = k11;
    result.values[17] = -z2224;
    result.values[18] = z2237;
    result.values[19] = -z2224;
    result.values[20] = z2237;
    result.values[21] = -z2224;
    result.values[22] = z2237;
    result.values[23] = -z2319;
    result.values[24] = k26;
    result.values[25] = z2164;
    result.values[26] = z2163;
    result.values[27] = -z2322;
    result.values[28] = -z2331;
    result.values[29] = -z2330;
    result.values[30] = k9;
    result.values[31] = z2170;
    result.values[32] = -z2256;
    result.values[33] = z2266;
    result.values[34] = -z2327;
    result.values[35] = -z2333;
    result.values[36] = z2325;
    result.values[37] = z2332;
    result.values[38] = z2170;
    result.values[39] = z2172;
    result.values[40] = -z2249;
    result.values[41] = z2247;
    result.values[42] = z2336;
    result.values[43] = z2345;
    result.values[44] = z2344;
    result.values[45] = k9;
    result.values[46] = z2166;
    result.values[47] = -z2283;
    result.values[48] = -z2293;
    result.values[49] = z2341;
    result.values[50] = -z2347;
    result.values[51] = -z2339;
    result.values[52] = -z2346;
    result.values[53] = z2166;
    result.values[54] = z2168;
    result.values[55] = z2276;
    result.values[56] = z2274;
    result.values[57] = -z2351;
    result.values[58] = z2360;
    result.values[59] = z2366;
    result.values[60] = -z2350;
    result.values[61] = -z2358;
    result.values[62] = z2365;
    result.values[63] = -z2216;
    result.values[64] = z2224;
    result.values[65] = -z2164;
    result.values[66] = -z2353;
    result.values[67] = z2363;
    result.values[68] = -z2369;
    result.values[69] = z2352;
    result.values[70] = z2361;
    result.values[71] = -z2368;
    result.values[72] = z2214;
    result.values[73] = -z2237;
    result.values[74] = -z2163;
    result.values[75] = -z2351;
    result.values[76] = z2360;
    result.values[77] = z2376;
    result.values[78] = z2383;
    result.values[79] = -z2350;
    result.values[80] = -z2358;
    result.values[81] = z2374;
    result.values[82] = z2382;
    result.values[83] = -z2216;
    result.values[84] = z2224;
    result.values[85] = z2256;
    result.values[86] = z2249;
    result.values[87] = -z2353;
    result.values[88] = z2363;
    result.values[89] = z2379;
    result.values[90] = z2385;
    result.values[91] = z2352;
    result.values[92] = z2361;
    result.values[93] = z2377;
    result.values[94] = z2384;
    result.values[95] = z2214;
    result.values[96] = -z2237;
    result.values[97] = -z2266;
    result.values[98] = -z2247;
    result.values[99] = -z2351;
    result.values[100] = z2360;
    result.values[101] = -z2392;
    result.values[102] = z2399;
    result.values[103] = -z2350;
    result.values[104] = -z2358;
    result.values[105] = -z2390;
    result.values[106] = -z2398;
    result.values[107] = -z2216;
    result.values[108] = z2224;
    result.values[109] = z2283;
    result.values[110] = -z2276;
    result.values[111] = -z2353;
    result.values[112] = z2363;
    result.values[113] = z2395;
    result.values[114] = -z2401;
    result.values[115] = z2352;
    result.values[116] = z2361;
    result.values[117] = z2393;
    result.values[118] = z2400;
    result.values[119] = z2214;
    result.values[120] = -z2237;
    result.values[121] = z2293;
    result.values[122] = -z2274;
  }
};

}  // namespace andrews_squeezer
