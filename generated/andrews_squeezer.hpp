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
//   forward_dynamics         241              345         12             1                  7       0    613     667
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
  static constexpr unsigned long long fingerprint = 0xa06a708c076d60acULL;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;
  static constexpr int first_integral_count = 0;

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
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
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
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
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
    const Scalar z669 = k0 * s_Omega;
    const Scalar z677 = k1 * c_Theta;
    const Scalar z716 = n0_028 * c_Theta;
    const Scalar z717 = n0_028 * s_Theta;
    const Scalar z673 = k0 * s_Phi;
    const Scalar z663 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z664 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z667 = n0_035 * s_gamma;
    const Scalar z660 = v_beta + v_Theta;
    const Scalar z711 = z660 * z660;
    const Scalar z694 = v_beta * v_beta;
    const Scalar z695 = n0_175 * z694;
    const Scalar z668 = n0_035 * c_gamma;
    const Scalar z661 = v_delta + v_Phi;
    const Scalar z662 = v_epsilon + v_Omega;
    const Scalar z724 = v_beta * c_beta;
    const Scalar z712 = k1 * z711;  // force on K2, times 0.04 m, x
    const Scalar z696 = s_Theta * z695;
    const Scalar z697 = v_delta * v_delta;
    const Scalar z699 = v_epsilon * v_epsilon;
    const Scalar z701 = z662 * z662;
    const Scalar z714 = s_Theta * z712;
    const Scalar z706 = z661 * z661;
    const Scalar z698 = c_Phi * z697;
    const Scalar z700 = c_Omega * z699;
    const Scalar z702 = k0 * z701;  // force on K6, times 0.04 m, x
    const Scalar z707 = k0 * z706;  // force on K4, times 0.04 m, y
    const Scalar z723 = v_gamma * c_gamma;
    const Scalar z683 = k7 * s_gamma + k8 * c_gamma;
    const Scalar z704 = c_Omega * z702;
    const Scalar z709 = c_Phi * z707;
    const Scalar z684 = k8 * s_gamma - k7 * c_gamma;
    const Scalar z670 = k9 - z669;
    const Scalar z671 = k9 - n2 * z669;
    const Scalar z674 = k9 + z673;
    const Scalar z675 = k9 + n2 * z673;
    const Scalar z678 = k11 - n0_175 * z677;
    const Scalar z679 = k11 - n0_35 * z677;
    const Scalar z703 = k0 * z700;  // moment on K6, z
    const Scalar z708 = k0 * z698;  // moment on K4, z
    const Scalar z713 = k1 * z696;  // moment on K2, z
    const Scalar z718 = n0_007 - z716;
    const Scalar z719 = s_beta * z717;
    const Scalar z721 = c_beta * z717;
    const Scalar z705 = z703 - z704;  // moment on K7, z
    const Scalar z710 = z708 - z709;  // moment on K5, z
    const Scalar z715 = n0_033 - n0_175 * z714 + z713;  // moment on K1, z
    const Scalar z720 = c_beta * z718 + z719;
    const Scalar z722 = s_beta * z718 - z721;
    const Scalar z665 = k15 - z663;
    const Scalar z725 = v_Theta * c_Theta;
    const Scalar z666 = k16 + z664;
    const Scalar z730 = s_beta * z716 + z721;
    const Scalar z727 = v_beta * s_beta;
    const Scalar z728 = v_Theta * s_Theta;
    const Scalar z726 = n0_028 * z725;
    const Scalar z731 = v_gamma * s_gamma;
    const Scalar z729 = n0_028 * z728;
    const Scalar z672 = k17 + z671;
    const Scalar z734 = v_Theta * z728;
    const Scalar z732 = v_gamma * z731;
    const Scalar z733 = n0_035 * z732;
    const Scalar z735 = n0_028 * z734;
    const Scalar z676 = k18 + z675;
    const Scalar z736 = v_Theta * z725;
    const Scalar z738 = v_beta * z727;
    const Scalar z739 = v_beta * z724;
    const Scalar z737 = n0_028 * z736;
    const Scalar z680 = k19 + z679;
    const Scalar z685 = n0_02 - z683;
    const Scalar z686 = n0_018 - z684;
    const Scalar z740 = z717 * z738 + z718 * z739 + s_beta * z735 - c_beta * z737 - n2 * (z724 * z726 - z727 * z729);
    const Scalar z681 = n0_014 + z665;
    const Scalar z682 = n0_072 - z666;
    const Scalar z745 = z717 * z739 - z718 * z738 + s_beta * z737 + c_beta * z735 + n2 * (z724 * z729 + z726 * z727);
    const Scalar z742 = c_beta * z716 - z719;
    const Scalar z687 = z681 * z681 + z682 * z682;
    const Scalar z743 = v_gamma * z723;
    const Scalar z744 = n0_035 * z743;
    const Scalar z747 = n0_02 * s_Phi;
    const Scalar z688 = traits::sqrt(z687);
    const Scalar z748 = n0_02 * c_Phi;
    const Scalar z741 = z733 - z740;
    const Scalar z746 = z744 - z745;
    const Scalar z689 = n1 / z688;
    const Scalar z749 = n0_04 + z747;
    const Scalar z690 = n4530 - n352_6605 * z689;
    const Scalar z750 = s_delta * z748;
    const Scalar z691 = z685 * z690;
    const Scalar z751 = c_delta * z749 + z750;
    const Scalar z692 = z686 * z690;
    const Scalar z752 = c_delta * z748;
    const Scalar z693 = n0_018 * z691 - n0_02 * z692;
    const Scalar z797 = n1 / z672;
    const Scalar z801 = n1 / z676;
    const Scalar z769 = c_delta * z747 + z750;
    const Scalar z760 = s_delta * z747 - z752;
    const Scalar z753 = s_delta * z749 - z752;
    const Scalar z805 = k26 * z678;
    const Scalar z806 = z678 * z805 - z680;
    const Scalar z798 = z670 * z797;
    const Scalar z799 = k9 - z670 * z798;
    const Scalar z772 = n0_02 * c_Omega;
    const Scalar z773 = n0_02 * s_Omega;
    const Scalar z774 = n0_04 - z773;
    const Scalar z807 = n1 / z806;
    const Scalar z775 = c_epsilon * z772;
    const Scalar z812 = z720 + z742 * z805;
    const Scalar z800 = n1 / z799;
    const Scalar z776 = s_epsilon * z774 + z775;
    const Scalar z794 = s_epsilon * z773 - z775;
    const Scalar z777 = s_epsilon * z772;
    const Scalar z785 = c_epsilon * z773 + z777;
    const Scalar z778 = c_epsilon * z774 - z777;
    const Scalar z808 = z722 + z730 * z805;
    const Scalar z802 = z674 * z801;
    const Scalar z803 = k9 - z674 * z802;
    const Scalar z783 = v_Omega * s_Omega;
    const Scalar z757 = v_delta * s_delta;
    const Scalar z782 = v_epsilon * s_epsilon;
    const Scalar z786 = v_Omega * z783;
    const Scalar z784 = n0_02 * z783;
    const Scalar z754 = v_delta * c_delta;
    const Scalar z804 = n1 / z803;
    const Scalar z813 = z807 * z812;
    const Scalar z809 = z807 * z808;
    const Scalar z787 = n0_02 * z786;
    const Scalar z765 = v_delta * z757;
    const Scalar z779 = v_epsilon * c_epsilon;
    const Scalar z791 = v_epsilon * z782;
    const Scalar z814 = k26 * z742 - z805 * z813;
    const Scalar z810 = k26 * z730 - z805 * z809;
    const Scalar z755 = v_Phi * s_Phi;
    const Scalar z815 = k27 * z667;
    const Scalar z758 = v_Phi * c_Phi;
    const Scalar z780 = v_Omega * c_Omega;
    const Scalar z766 = v_delta * z754;
    const Scalar z790 = v_epsilon * z779;
    const Scalar z761 = v_Phi * z758;
    const Scalar z759 = n0_02 * z758;
    const Scalar z763 = v_Phi * z755;
    const Scalar z762 = n0_02 * z761;
    const Scalar z764 = n0_02 * z763;
    const Scalar z756 = n0_02 * z755;
    const Scalar z825 = z776 * z798 + z794;
    const Scalar z826 = z800 * z825;
    const Scalar z822 = z778 * z798 + z785;
    const Scalar z823 = z800 * z822;
    const Scalar z819 = z751 * z802 - z769;
    const Scalar z820 = z804 * z819;
    const Scalar z816 = z753 * z802 - z760;
    const Scalar z817 = z804 * z816;
    const Scalar z824 = z778 * z797 + z798 * z823;
    const Scalar z821 = z751 * z801 + z802 * z820;
    const Scalar z818 = z753 * z801 + z802 * z817;
    const Scalar z788 = v_Omega * z780;
    const Scalar z789 = n0_02 * z788;
    const Scalar z781 = n0_02 * z780;
    const Scalar z811 = k27 * z668;
    const Scalar z767 = z748 * z765 + z749 * z766 + s_delta * z762 + c_delta * z764 + n2 * (z754 * z756 + z757 * z759);
    const Scalar z770 = z749 * z765 - z748 * z766 + s_delta * z764 - c_delta * z762 - n2 * (z754 * z759 - z756 * z757);
    const Scalar z768 = z740 - z767;
    const Scalar z771 = z745 + z770;
    const Scalar z837 = z720 * z813;
    const Scalar z827 = z776 * z797 + z798 * z826;
    const Scalar z843 = z742 * z814 - z837 + z794 * z826 + z776 * z827;
    const Scalar z835 = z720 * z809;
    const Scalar z831 = z722 * z809;
    const Scalar z842 = z742 * z810 - z835 - z794 * z823 - z776 * z824;
    const Scalar z841 = z730 * z810 - z831 + z785 * z823 + z778 * z824;
    const Scalar z833 = z722 * z813 - z730 * z814;
    const Scalar z844 = n1 / z843;
    const Scalar z838 = z742 * z814 - z837;
    const Scalar z840 = z742 * z814 - z837 - z769 * z820 + z751 * z821;
    const Scalar z832 = z730 * z810 - z831;
    const Scalar z834 = z730 * z810 - z831 - z760 * z817 + z753 * z818;
    const Scalar z836 = z742 * z810 - z835;
    const Scalar z839 = z742 * z810 - z835 - z769 * z817 + z751 * z818;
    const Scalar z847 = z842 * z844;
    const Scalar z846 = z838 * z844;
    const Scalar z845 = z836 * z844;
    const Scalar z830 = z667 * z815 - z720 * z813 + z742 * z814;
    const Scalar z850 = z830 - z838 * z846;
    const Scalar z792 = s_epsilon * z787 - z772 * z790 - z774 * z791 - c_epsilon * z789 - n2 * (z779 * z781 - z782
        * z784);
    const Scalar z795 = z772 * z791 - z774 * z790 + s_epsilon * z789 + c_epsilon * z787 + n2 * (z779 * z784 + z781
        * z782);
    const Scalar z793 = z740 + z792;
    const Scalar z796 = z745 + z795;
    const Scalar z860 = z841 - z842 * z847;
    const Scalar z861 = n1 / z860;
    const Scalar z856 = z836 * z846 - z839;
    const Scalar z859 = z833 + z838 * z847;
    const Scalar z852 = z833 + z838 * z845;
    const Scalar z857 = z838 * z846 - z840;
    const Scalar z855 = z838 * (n1 - z846);
    const Scalar z858 = z832 - z836 * z847;
    const Scalar z851 = z832 - z836 * z845;
    const Scalar z853 = z834 - z836 * z845;
    const Scalar z829 = z667 * z811 + z720 * z809 - z742 * z810;
    const Scalar z849 = z829 + z836 * z846;
    const Scalar z828 = z668 * z811 - z722 * z809 + z730 * z810;
    const Scalar z896 = z713 * z805 - z715;
    const Scalar z897 = z807 * z896;
    const Scalar z894 = z703 - z705 * z798;
    const Scalar z902 = z800 * z894;
    const Scalar z895 = z708 - z710 * z802;
    const Scalar z898 = k26 * z713 - z805 * z897;
    const Scalar z903 = z705 * z797 - z798 * z902;
    const Scalar z900 = z804 * z895;
    const Scalar z901 = z710 * z801 - z802 * z900;
    const Scalar z899 = k27 * z693;
    const Scalar z904 = z741 - z722 * z897 + z730 * z898 + z668 * z899;
    const Scalar z906 = z722 * z897 + z768 - z730 * z898 - z760 * z900 - z753 * z901;
    const Scalar z907 = z720 * z897 + z771 - z742 * z898 - z769 * z900 - z751 * z901;
    const Scalar z905 = z720 * z897 - z746 - z742 * z898 + z667 * z899;
    const Scalar z863 = z859 * z861;
    const Scalar z873 = z857 + z859 * z863;
    const Scalar z872 = z856 - z858 * z863;
    const Scalar z871 = z855 - z859 * z863;
    const Scalar z866 = z850 - z859 * z863;
    const Scalar z874 = n1 / z873;
    const Scalar z865 = z849 - z858 * z863;
    const Scalar z862 = z858 * z861;
    const Scalar z868 = z852 - z859 * z862;
    const Scalar z869 = z853 - z858 * z862;
    const Scalar z867 = z851 - z858 * z862;
    const Scalar z854 = z836 * (n1 - z846);
    const Scalar z848 = z828 - z836 * z845;
    const Scalar z921 = z828 + z830 + z834 + z840 + z841 + z843;
    const Scalar z908 = z722 * z897 + z793 - z730 * z898 + z785 * z902 - z778 * z903;
    const Scalar z909 = z720 * z897 + z796 - z742 * z898 - z794 * z902 + z776 * z903;
    const Scalar z922 = n4096 * z921;
    const Scalar z870 = z854 + z858 * z863;
    const Scalar z864 = z848 - z858 * z862;
    const Scalar z910 = z847 * z909 - z908;
    const Scalar z877 = z872 * z874;
    const Scalar z883 = z869 + z872 * z877;
    const Scalar z882 = z868 + z871 * z877;
    const Scalar z881 = z867 - z870 * z877;
    const Scalar z911 = z846 * z909 - z907 + z863 * z910;
    const Scalar z884 = n1 / z883;
    const Scalar z912 = z845 * z909 - z906 - z862 * z910 - z877 * z911;
    const Scalar z876 = z871 * z874;
    const Scalar z880 = z866 + z871 * z876;
    const Scalar z879 = z865 - z870 * z876;
    const Scalar z875 = z870 * z874;
    const Scalar z878 = z864 + z870 * z875;
    const Scalar z885 = z881 * z884;
    const Scalar z886 = z882 * z884;
    const Scalar z887 = z878 - z881 * z885;
    const Scalar z888 = z879 - z881 * z886;
    const Scalar z889 = z880 - z882 * z886;
    const Scalar z913 = z846 * z909 - z905 + z863 * z910 + z876 * z911 + z886 * z912;
    const Scalar z890 = n1 / z889;
    const Scalar z891 = z888 * z890;
    const Scalar z892 = z887 - z888 * z891;
    const Scalar z914 = z845 * z909 + z904 - z862 * z910 + z875 * z911 - z885 * z912 + z891 * z913;
    const Scalar z893 = n1 / z892;
    const Scalar z915 = z893 * z914;
    const Scalar z916 = z890 * z913 + z891 * z915;
    const Scalar z917 = z884 * z912 - z885 * z915 + z886 * z916;
    const Scalar z925 = z811 * z915 - z899 - z815 * z916;
    const Scalar z918 = z874 * z911 - z875 * z915 - z876 * z916 + z877 * z917;
    const Scalar z919 = z861 * z910 - z862 * (z915 + z917) + z863 * (z916 - z918);
    const Scalar z926 = z900 + z817 * z917 - z820 * z918;
    const Scalar z927 = z818 * z917 - z901 - z821 * z918;
    const Scalar z920 = z844 * z909 + z845 * (z915 + z917) + z846 * (z916 - z918) + z847 * z919;
    const Scalar z923 = z809 * (z915 + z917 + z919) - z897 + z813 * (z916 - z918 - z920);
    const Scalar z924 = z810 * (z915 + z917 + z919) - z898 + z814 * (z916 - z918 - z920);
    const Scalar z928 = z902 + z823 * z919 + z826 * z920;
    const Scalar z929 = z824 * z919 - z903 + z827 * z920;
    accelerations.beta = -z923;
    accelerations.Theta = -z924;
    accelerations.gamma = z925;
    accelerations.Phi = z926;
    accelerations.delta = -z927;
    accelerations.Omega = -z928;
    accelerations.epsilon = z929;
    multipliers.lambda_E3_x = -z915;
    multipliers.lambda_E3_y = z916;
    multipliers.lambda_E4_x = -z917;
    multipliers.lambda_E4_y = -z918;
    multipliers.lambda_E6_x = -z919;
    multipliers.lambda_E6_y = -z920;
    if (!(traits::regular(-z806, z680) && traits::regular(z803, k9) && traits::regular(z676, z676)
        && traits::regular(z799, k9) && traits::regular(z672, z672) && traits::regular(z892, z922)
        && traits::regular(z889, z922) && traits::regular(z883, z922) && traits::regular(-z873, z922)
        && traits::regular(z860, z922) && traits::regular(z843, z922))) return torsor::Status::singular;
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
    const Scalar z930 = k4 * z41 - k5 * z207;
    const Scalar z931 = k6 * z41 - k4 * z207;
    const Scalar z932 = k7 * z52 + k8 * z208;
    const Scalar z933 = k9 * z52 + k7 * z208;
    const Scalar z934 = k7 * z63 - k8 * z211;
    const Scalar z935 = k9 * z63 - k7 * z211;
    const Scalar z122 = k10 - z116;
    const Scalar z123 = k11 + z117;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z222 = k14 - z219;
    result.kinetic = k15 * v_beta * v_beta + k16 * v_gamma * v_gamma + k17 * v_delta * v_delta + k18 * v_epsilon
        * v_epsilon + k19 * z206 * z206 + k20 * (z209 * z209 + z210 * z210) + n0_5 * (z41 * z931 + z52 * z933 + z63
        * z935 - z207 * z930 + z208 * z932 - z211 * z934);
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
    const Scalar z1002 = v_beta * c_beta;
    const Scalar z1005 = v_beta * s_beta;
    const Scalar z1030 = n0_02 * s_Phi;
    const Scalar z1044 = v_delta * s_delta;
    const Scalar z991 = n0_028 * c_Theta;
    const Scalar z992 = n0_028 * s_Theta;
    const Scalar z1031 = n0_02 * c_Phi;
    const Scalar z1041 = v_delta * c_delta;
    const Scalar z1003 = v_Theta * c_Theta;
    const Scalar z1006 = v_Theta * s_Theta;
    const Scalar z1042 = v_Phi * s_Phi;
    const Scalar z1045 = v_Phi * c_Phi;
    const Scalar z1000 = v_gamma * c_gamma;
    const Scalar z1011 = v_gamma * s_gamma;
    const Scalar z987 = n0_035 * s_gamma;
    const Scalar z988 = n0_035 * c_gamma;
    const Scalar z989 = k3 - z987;
    const Scalar z990 = k4 - z988;
    const Scalar z993 = n0_007 - z991;
    const Scalar z994 = s_beta * z992;
    const Scalar z996 = c_beta * z992;
    const Scalar z1001 = n0_035 * z1000;
    const Scalar z1004 = n0_028 * z1003;
    const Scalar z1007 = n0_028 * z1006;
    const Scalar z1012 = v_gamma * z1011;
    const Scalar z1014 = v_Theta * z1006;
    const Scalar z1016 = v_Theta * z1003;
    const Scalar z1018 = v_beta * z1005;
    const Scalar z1019 = v_beta * z1002;
    const Scalar z1022 = n0_035 * z1011;
    const Scalar z1026 = v_gamma * z1000;
    const Scalar z1032 = n0_04 + z1030;
    const Scalar z1033 = s_delta * z1031;
    const Scalar z1035 = c_delta * z1031;
    const Scalar z1043 = n0_02 * z1042;
    const Scalar z1046 = n0_02 * z1045;
    const Scalar z1050 = v_Phi * z1045;
    const Scalar z1052 = v_Phi * z1042;
    const Scalar z1054 = v_delta * z1044;
    const Scalar z995 = c_beta * z993 + z994;
    const Scalar z1055 = v_delta * z1041;
    const Scalar z997 = s_beta * z993 - z996;
    const Scalar z1008 = z992 * z1002 + s_beta * z1004 + c_beta * z1007 - z993 * z1005;
    const Scalar z1010 = s_beta * z991 + z996;
    const Scalar z1013 = n0_035 * z1012;
    const Scalar z1015 = n0_028 * z1014;
    const Scalar z1017 = n0_028 * z1016;
    const Scalar z1023 = z992 * z1005 + s_beta * z1007 - c_beta * z1004 + z993 * z1002;
    const Scalar z1025 = c_beta * z991 - z994;
    const Scalar z1027 = n0_035 * z1026;
    const Scalar z1034 = c_delta * z1032 + z1033;
    const Scalar z1036 = s_delta * z1032 - z1035;
    const Scalar z1047 = s_delta * z1043 - c_delta * z1046 - z1031 * z1041 + z1032 * z1044;
    const Scalar z1049 = s_delta * z1030 - z1035;
    const Scalar z1051 = n0_02 * z1050;
    const Scalar z1053 = n0_02 * z1052;
    const Scalar z1020 = z992 * z1018 + z993 * z1019 + s_beta * z1015 - c_beta * z1017 - n2 * (z1002 * z1004 - z1005
        * z1007);
    const Scalar z1028 = z992 * z1019 - z993 * z1018 + s_beta * z1017 + c_beta * z1015 + n2 * (z1002 * z1007 + z1004
        * z1005);
    const Scalar z998 = z989 + z995;
    const Scalar z999 = z990 - z997;
    const Scalar z1060 = c_delta * z1030 + z1033;
    const Scalar z1009 = z1001 - z1008;
    const Scalar z1024 = z1022 - z1023;
    const Scalar z1037 = k8 - z1034;
    const Scalar z1039 = z995 + z1037;
    const Scalar z1048 = z1008 + z1047;
    const Scalar z1078 = v_Omega * s_Omega;
    const Scalar z1038 = k9 - z1036;
    const Scalar z1040 = z997 + z1038;
    const Scalar z1077 = v_epsilon * s_epsilon;
    const Scalar z1063 = n0_02 * c_Omega;
    const Scalar z1064 = n0_02 * s_Omega;
    const Scalar z1021 = z1013 - z1020;
    const Scalar z1029 = z1027 - z1028;
    const Scalar z1083 = v_Omega * z1078;
    const Scalar z1084 = n0_02 * z1083;
    const Scalar z1079 = n0_02 * z1078;
    const Scalar z1074 = v_epsilon * c_epsilon;
    const Scalar z1088 = v_epsilon * z1077;
    const Scalar z1075 = v_Omega * c_Omega;
    const Scalar z1065 = n0_04 - z1064;
    const Scalar z1087 = v_epsilon * z1074;
    const Scalar z1085 = v_Omega * z1075;
    const Scalar z1076 = n0_02 * z1075;
    const Scalar z1066 = c_epsilon * z1063;
    const Scalar z1093 = s_epsilon * z1064 - z1066;
    const Scalar z1086 = n0_02 * z1085;
    const Scalar z1067 = s_epsilon * z1065 + z1066;
    const Scalar z1068 = s_epsilon * z1063;
    const Scalar z1082 = c_epsilon * z1064 + z1068;
    const Scalar z1069 = c_epsilon * z1065 - z1068;
    const Scalar z1070 = k8 - z1067;
    const Scalar z1056 = z1031 * z1054 + z1032 * z1055 + s_delta * z1051 + c_delta * z1053 + n2 * (z1041 * z1043 + z1044
        * z1046);
    const Scalar z1061 = z1032 * z1054 - z1031 * z1055 + s_delta * z1053 - c_delta * z1051 - n2 * (z1041 * z1046 - z1043
        * z1044);
    const Scalar z1058 = z1031 * z1044 + s_delta * z1046 + c_delta * z1043 + z1032 * z1041;
    const Scalar z1072 = z995 + z1070;
    const Scalar z1071 = k9 + z1069;
    const Scalar z1080 = z1063 * z1077 + s_epsilon * z1076 + c_epsilon * z1079 - z1065 * z1074;
    const Scalar z1073 = z997 + z1071;
    const Scalar z1089 = s_epsilon * z1084 - z1063 * z1087 - z1065 * z1088 - c_epsilon * z1086 - n2 * (z1074 * z1076
        - z1077 * z1079);
    const Scalar z1091 = s_epsilon * z1079 - c_epsilon * z1076 - z1063 * z1074 - z1065 * z1077;
    const Scalar z1094 = z1063 * z1088 - z1065 * z1087 + s_epsilon * z1086 + c_epsilon * z1084 + n2 * (z1074 * z1079
        + z1076 * z1077);
    const Scalar z1057 = z1020 - z1056;
    const Scalar z1059 = z1023 - z1058;
    const Scalar z1062 = z1028 + z1061;
    const Scalar z1081 = z1008 + z1080;
    const Scalar z1090 = z1020 + z1089;
    const Scalar z1092 = z1023 + z1091;
    const Scalar z1095 = z1028 + z1094;
    result.value[0] = z998;
    result.rate[0] = -z1009;
    result.gamma[0] = z1021;
    result.value[1] = -z999;
    result.rate[1] = -z1024;
    result.gamma[1] = -z1029;
    result.value[2] = z1039;
    result.rate[2] = z1048;
    result.gamma[2] = -z1057;
    result.value[3] = z1040;
    result.rate[3] = z1059;
    result.gamma[3] = z1062;
    result.value[4] = z1072;
    result.rate[4] = z1081;
    result.gamma[4] = -z1090;
    result.value[5] = z1073;
    result.rate[5] = z1092;
    result.gamma[5] = z1095;
    result.jacobian[0] = -z997;
    result.jacobian[1] = z995;
    result.jacobian[2] = -z997;
    result.jacobian[3] = z995;
    result.jacobian[4] = -z997;
    result.jacobian[5] = z995;
    result.jacobian[6] = z1010;
    result.jacobian[7] = -z1025;
    result.jacobian[8] = z1010;
    result.jacobian[9] = -z1025;
    result.jacobian[10] = z1010;
    result.jacobian[11] = -z1025;
    result.jacobian[12] = -z988;
    result.jacobian[13] = -z987;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z1049;
    result.jacobian[21] = -z1060;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = z1036;
    result.jacobian[27] = -z1034;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = z1082;
    result.jacobian[35] = z1093;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = -z1069;
    result.jacobian[41] = -z1067;
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
    const Scalar z1500 = n0_035 * c_gamma;
    const Scalar z1499 = n0_035 * s_gamma;
    const Scalar z1495 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1496 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z1492 = v_beta + v_Theta;
    const Scalar z1526 = v_beta * v_beta;
    const Scalar z1536 = n0_175 * a_beta;
    const Scalar z1539 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z1527 = n0_175 * z1526;
    const Scalar z1534 = z1492 * z1492;
    const Scalar z1509 = k4 * c_Theta;
    const Scalar z1535 = k4 * z1534;  // force on K2, times 0.04 m, x
    const Scalar z1537 = s_Theta * z1536 - c_Theta * z1527;
    const Scalar z1493 = v_delta + v_Phi;
    const Scalar z1542 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z1528 = v_delta * v_delta;
    const Scalar z1505 = k5 * s_Phi;
    const Scalar z1532 = z1493 * z1493;
    const Scalar z1538 = s_Theta * z1527 + c_Theta * z1536;
    const Scalar z1551 = k5 * z1542;  // force on K4, times 0.04 m, x
    const Scalar z1494 = v_epsilon + v_Omega;
    const Scalar z1545 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z1529 = v_epsilon * v_epsilon;
    const Scalar z1541 = a_delta * c_Phi + s_Phi * z1528;
    const Scalar z1533 = k5 * z1532;  // force on K4, times 0.04 m, y
    const Scalar z1540 = a_delta * s_Phi - c_Phi * z1528;
    const Scalar z1501 = k5 * s_Omega;
    const Scalar z1530 = z1494 * z1494;
    const Scalar z1531 = k5 * z1530;  // force on K6, times 0.04 m, x
    const Scalar z1546 = k5 * z1545;  // force on K6, times 0.04 m, y
    const Scalar z1543 = a_epsilon * c_Omega + s_Omega * z1529;
    const Scalar z1544 = a_epsilon * s_Omega - c_Omega * z1529;
    const Scalar z1554 = s_Phi * z1551 + c_Phi * z1533;
    const Scalar z1553 = s_Phi * z1533 - c_Phi * z1551;
    const Scalar z1515 = k6 * s_gamma + k7 * c_gamma;
    const Scalar z1516 = k7 * s_gamma - k6 * c_gamma;
    const Scalar z1548 = s_Omega * z1546 + c_Omega * z1531;
    const Scalar z1549 = s_Omega * z1531 - c_Omega * z1546;
    const Scalar z1502 = k8 - z1501;
    const Scalar z1503 = k8 - n2 * z1501;
    const Scalar z1506 = k8 + z1505;
    const Scalar z1507 = k8 + n2 * z1505;
    const Scalar z1510 = k10 - n0_175 * z1509;
    const Scalar z1511 = k10 - n0_35 * z1509;
    const Scalar z1497 = k12 - z1495;
    const Scalar z1557 = k4 * z1539;  // force on K2, times 0.04 m, y
    const Scalar z1498 = k13 + z1496;
    const Scalar z1563 = n0_028 * s_Theta;
    const Scalar z1562 = n0_028 * c_Theta;
    const Scalar z1559 = s_Theta * z1557 + c_Theta * z1535;
    const Scalar z1560 = s_Theta * z1535 - c_Theta * z1557;
    const Scalar z1504 = k15 + z1503;
    const Scalar z1565 = s_beta * z1563;
    const Scalar z1567 = c_beta * z1563;
    const Scalar z1564 = n0_007 - z1562;
    const Scalar z1566 = c_beta * z1564 + z1565;
    const Scalar z1508 = k17 + z1507;
    const Scalar z1571 = v_beta * c_beta;
    const Scalar z1568 = s_beta * z1564 - z1567;
    const Scalar z1569 = v_gamma * c_gamma;
    const Scalar z1570 = n0_035 * z1569;
    const Scalar z1512 = k18 + z1511;
    const Scalar z1572 = v_Theta * c_Theta;
    const Scalar z1517 = n0_02 - z1515;
    const Scalar z1518 = n0_018 - z1516;
    const Scalar z1547 = k5 * z1544 - k8 * z1545;  // moment on K6, z
    const Scalar z1558 = k4 * z1538 - k10 * z1539;  // moment on K2, z
    const Scalar z1552 = k8 * z1542 + k5 * z1540;  // moment on K4, z
    const Scalar z1513 = n0_014 + z1497;
    const Scalar z1514 = n0_072 - z1498;
    const Scalar z1555 = k17 * a_delta + z1554 + z1552;  // moment on K5, z
    const Scalar z1574 = v_beta * s_beta;
    const Scalar z1561 = n0_033 - k18 * a_beta - n0_175 * z1560 + z1558;  // moment on K1, z
    const Scalar z1550 = k15 * a_epsilon - z1548 - z1547;  // moment on K7, z
    const Scalar z1575 = v_Theta * s_Theta;
    const Scalar z1576 = n0_028 * z1575;
    const Scalar z1578 = z1563 * z1571;
    const Scalar z1519 = z1513 * z1513 + z1514 * z1514;
    const Scalar z1520 = traits::sqrt(z1519);
    const Scalar z1580 = s_beta * z1562 + z1567;
    const Scalar z1573 = n0_028 * z1572;
    const Scalar z1577 = s_beta * z1573;
    const Scalar z1579 = z1578 + c_beta * z1576 - z1564 * z1574 + z1577;
    const Scalar z1521 = n1 / z1520;
    const Scalar z1581 = v_gamma * s_gamma;
    const Scalar z1522 = n4530 - n352_6605 * z1521;
    const Scalar z1582 = v_gamma * z1581;
    const Scalar z1523 = z1517 * z1522;
    const Scalar z1583 = n0_035 * z1582;
    const Scalar z1524 = z1518 * z1522;
    const Scalar z1584 = v_Theta * z1575;
    const Scalar z1525 = n0_018 * z1523 - n0_02 * z1524;
    const Scalar z1598 = c_beta * z1562 - z1565;
    const Scalar z1585 = n0_028 * z1584;
    const Scalar z1606 = n0_02 * c_Phi;
    const Scalar z1605 = n0_02 * s_Phi;
    const Scalar z1610 = c_delta * z1606;
    const Scalar z1608 = s_delta * z1606;
    const Scalar z1607 = n0_04 + z1605;
    const Scalar z1596 = z1563 * z1574;
    const Scalar z1612 = v_delta * c_delta;
    const Scalar z1613 = v_Phi * s_Phi;
    const Scalar z1609 = c_delta * z1607 + z1608;
    const Scalar z1611 = s_delta * z1607 - z1610;
    const Scalar z1615 = v_delta * s_delta;
    const Scalar z1586 = v_Theta * z1572;
    const Scalar z1587 = n0_028 * z1586;
    const Scalar z1588 = v_beta * z1574;
    const Scalar z1589 = v_beta * z1571;
    const Scalar z1614 = n0_02 * z1613;
    const Scalar z1590 = z1563 * z1588;
    const Scalar z1601 = z1563 * z1589;
    const Scalar z1595 = c_beta * z1573;
    const Scalar z1597 = z1596 + s_beta * z1576 + z1564 * z1571 - z1595;
    const Scalar z1591 = z1574 * z1576;
    const Scalar z1602 = z1571 * z1576;
    const Scalar z1594 = n0_035 * z1581;
    const Scalar z1592 = z1590 + z1564 * z1589 + s_beta * z1585 - c_beta * z1587 - n2 * (z1571 * z1573 - z1591);
    const Scalar z1603 = z1601 + s_beta * z1587 - z1564 * z1588 + c_beta * z1585 + n2 * (z1573 * z1574 + z1602);
    const Scalar z1599 = v_gamma * z1569;
    const Scalar z1600 = n0_035 * z1599;
    const Scalar z1593 = z1583 - z1592;
    const Scalar z1604 = z1600 - z1603;
    const Scalar z1556 = k26 * a_gamma + z1525;  // moment on K3, z
    const Scalar z1621 = s_delta * z1605 - z1610;
    const Scalar z1635 = c_delta * z1605 + z1608;
    const Scalar z1640 = n0_02 * c_Omega;
    const Scalar z1641 = n0_02 * s_Omega;
    const Scalar z1645 = s_epsilon * z1640;
    const Scalar z1643 = c_epsilon * z1640;
    const Scalar z1642 = n0_04 - z1641;
    const Scalar z1647 = v_epsilon * c_epsilon;
    const Scalar z1650 = v_epsilon * s_epsilon;
    const Scalar z1656 = c_epsilon * z1641 + z1645;
    const Scalar z1646 = c_epsilon * z1642 - z1645;
    const Scalar z1670 = s_epsilon * z1641 - z1643;
    const Scalar z1644 = s_epsilon * z1642 + z1643;
    const Scalar z1651 = v_Omega * s_Omega;
    const Scalar z1619 = z1606 * z1612;
    const Scalar z1633 = z1606 * z1615;
    const Scalar z1652 = n0_02 * z1651;
    const Scalar z1654 = z1640 * z1650;
    const Scalar z1668 = z1640 * z1647;
    const Scalar z1616 = v_Phi * c_Phi;
    const Scalar z1648 = v_Omega * c_Omega;
    const Scalar z1617 = n0_02 * z1616;
    const Scalar z1649 = n0_02 * z1648;
    const Scalar z1626 = v_delta * z1615;
    const Scalar z1627 = v_delta * z1612;
    const Scalar z1628 = z1606 * z1626;
    const Scalar z1618 = c_delta * z1617;
    const Scalar z1679 = n2 * z1492;
    const Scalar z1632 = s_delta * z1617;
    const Scalar z1653 = s_epsilon * z1649;
    const Scalar z1667 = c_epsilon * z1649;
    const Scalar z1622 = v_Phi * z1616;
    const Scalar z1623 = n0_02 * z1622;
    const Scalar z1657 = v_Omega * z1651;
    const Scalar z1658 = n0_02 * z1657;
    const Scalar z1659 = v_Omega * z1648;
    const Scalar z1660 = n0_02 * z1659;
    const Scalar z1661 = v_epsilon * z1647;
    const Scalar z1662 = v_epsilon * z1650;
    const Scalar z1620 = s_delta * z1614 - z1619 + z1607 * z1615 - z1618;
    const Scalar z1680 = k4 * z1679;
    const Scalar z1681 = s_Theta * z1680;
    const Scalar z1634 = z1633 + c_delta * z1614 + z1607 * z1612 + z1632;
    const Scalar z1682 = n0_175 * z1681;
    const Scalar z1655 = z1654 + c_epsilon * z1652 - z1642 * z1647 + z1653;
    const Scalar z1669 = s_epsilon * z1652 - z1668 - z1642 * z1650 - z1667;
    const Scalar z1636 = z1606 * z1627;
    const Scalar z1663 = z1640 * z1661;
    const Scalar z1671 = z1640 * z1662;
    const Scalar z1624 = v_Phi * z1613;
    const Scalar z1625 = n0_02 * z1624;
    const Scalar z1686 = k4 * z1537;
    const Scalar z1687 = n0_175 * z1559 + z1686;
    const Scalar z1629 = z1612 * z1614;
    const Scalar z1689 = z1580 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z1686 + z1598 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z1688 = z1580 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z1687 + z1598 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z1637 = z1614 * z1615;
    const Scalar z1664 = z1650 * z1652;
    const Scalar z1672 = z1647 * z1652;
    const Scalar z1630 = z1628 + z1607 * z1627 + s_delta * z1623 + c_delta * z1625 + n2 * (z1615 * z1617 + z1629);
    const Scalar z1690 = n2 * (z1495 * z1514 - z1496 * z1513);
    const Scalar z1638 = z1607 * z1626 - z1636 + s_delta * z1625 - c_delta * z1623 - n2 * (z1612 * z1617 - z1637);
    const Scalar z1665 = s_epsilon * z1658 - z1663 - z1642 * z1662 - c_epsilon * z1660 - n2 * (z1647 * z1649 - z1664);
    const Scalar z1673 = z1671 + s_epsilon * z1660 - z1642 * z1661 + c_epsilon * z1658 + n2 * (z1649 * z1650 + z1672);
    const Scalar z1675 = n2 * v_beta;
    const Scalar z1676 = n0_175 * z1675;
    const Scalar z1684 = z1566 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z1568 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z1677 = s_Theta * z1676;
    const Scalar z1685 = z1580 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z1598 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z1678 = k4 * z1677;
    const Scalar z1631 = z1592 - z1630;
    const Scalar z1691 = n0_5 * z1690 / z1520;
    const Scalar z1692 = z1691 / (z1520 * z1520);
    const Scalar z1698 = k5 * z1541;
    const Scalar z1639 = z1603 + z1638;
    const Scalar z1701 = n2 * z1493;
    const Scalar z1712 = k5 * z1543;
    const Scalar z1702 = k5 * z1701;
    const Scalar z1715 = n2 * z1494;
    const Scalar z1704 = z1553 - z1698;
    const Scalar z1716 = k5 * z1715;
    const Scalar z1718 = z1549 - z1712;
    const Scalar z1703 = c_Phi * z1702;
    const Scalar z1699 = l_lambda_E4_y * z1621;
    const Scalar z1700 = l_lambda_E4_x * z1635 - z1698 + z1699;
    const Scalar z1705 = l_lambda_E4_x * z1635 + z1699 + z1704;
    const Scalar z1709 = l_lambda_E4_x * z1635 + z1699;
    const Scalar z1717 = c_Omega * z1716;
    const Scalar z1706 = n2 * v_delta;
    const Scalar z1707 = c_Phi * z1706;
    const Scalar z1713 = l_lambda_E6_y * z1656;
    const Scalar z1714 = l_lambda_E6_x * z1670 - z1712 - z1713;
    const Scalar z1693 = n352_6605 * z1692;
    const Scalar z1708 = k5 * z1707;
    const Scalar z1719 = l_lambda_E6_x * z1670 - z1713 + z1718;
    const Scalar z1694 = z1516 * z1522 - z1517 * z1693;
    const Scalar z1695 = z1515 * z1522 + z1518 * z1693;
    const Scalar z1723 = l_lambda_E6_x * z1670 - z1713;
    const Scalar z1696 = n0_018 * z1694 + n0_02 * z1695;
    const Scalar z1720 = n2 * v_epsilon;
    const Scalar z1721 = c_Omega * z1720;
    const Scalar z1683 = z1678 - z1682;
    const Scalar z1666 = z1592 + z1665;
    const Scalar z1728 = a_beta * z1568 - a_Theta * z1580 + a_gamma * z1500 - z1593;
    const Scalar z1729 = a_beta * z1566 - a_Theta * z1598 - a_gamma * z1499 - z1604;
    const Scalar z1727 = a_beta * z1568 - a_Theta * z1580 - a_delta * z1611 - a_Phi * z1621 + z1631;
    const Scalar z1731 = a_beta * z1566 - a_Theta * z1598 - a_delta * z1609 - a_Phi * z1635 + z1639;
    const Scalar z1722 = k5 * z1721;
    const Scalar z1726 = a_beta * z1568 - a_Theta * z1580 + a_epsilon * z1646 - a_Omega * z1656 + z1666;
    const Scalar z1697 = l_lambda_E3_x * z1499 - z1696 - l_lambda_E3_y * z1500;
    const Scalar z1732 = n2 * z1574;
    const Scalar z1733 = n2 * z1571;
    const Scalar z1674 = z1603 + z1673;
    const Scalar z1744 = z1601 + z1562 * z1588 + s_beta * z1587 + c_beta * z1585 + n2 * (z1573 * z1574 + z1602);
    const Scalar z1748 = z1590 + s_beta * z1585 - z1562 * z1589 - c_beta * z1587 - n2 * (z1571 * z1573 - z1591);
    const Scalar z1766 = z1628 + z1605 * z1627 + s_delta * z1623 + c_delta * z1625 + n2 * (z1615 * z1617 + z1629);
    const Scalar z1762 = z1605 * z1626 - z1636 + s_delta * z1625 - c_delta * z1623 - n2 * (z1612 * z1617 - z1637);
    const Scalar z1739 = n2 * z1575;
    const Scalar z1741 = n2 * z1572;
    const Scalar z1740 = n0_028 * z1739;
    const Scalar z1742 = n0_028 * z1741;
    const Scalar z1759 = n2 * z1613;
    const Scalar z1735 = z1603 + a_beta * z1566 - a_Theta * z1598;
    const Scalar z1737 = z1592 + a_beta * z1568 - a_Theta * z1580;
    const Scalar z1745 = z1598 * (a_beta + a_Theta) - z1744;
    const Scalar z1749 = z1580 * (a_beta + a_Theta) - z1748;
    const Scalar z1757 = n2 * z1616;
    const Scalar z1760 = n0_02 * z1759;
    const Scalar z1750 = n2 * z1581;
    const Scalar z1753 = n2 * z1569;
    const Scalar z1758 = n0_02 * z1757;
    const Scalar z1751 = n0_035 * z1750;
    const Scalar z1752 = a_gamma * z1499 + z1600;
    const Scalar z1754 = n0_035 * z1753;
    const Scalar z1755 = a_gamma * z1500 - z1583;
    const Scalar z1767 = z1621 * (a_delta + a_Phi) + z1766;
    const Scalar z1763 = z1635 * (a_delta + a_Phi) - z1762;
    const Scalar z1730 = a_beta * z1566 - a_Theta * z1598 - a_epsilon * z1644 + a_Omega * z1670 + z1674;
    const Scalar z1738 = z1596 + s_beta * z1576 - z1562 * z1571 - z1595;
    const Scalar z1743 = s_beta * z1740 - n2 * (z1562 * z1571 - z1596) - c_beta * z1742;
    const Scalar z1747 = s_beta * z1742 + c_beta * z1740 + n2 * (z1562 * z1574 + z1578);
    const Scalar z1746 = z1578 + z1562 * z1574 + c_beta * z1576 + z1577;
    const Scalar z1734 = z1563 * z1732 + z1564 * z1733 + n2 * (s_beta * z1576 - z1595);
    const Scalar z1736 = z1563 * z1733 - z1564 * z1732 + n2 * (c_beta * z1576 + z1577);
    const Scalar z1756 = z1633 + z1605 * z1612 + c_delta * z1614 + z1632;
    const Scalar z1761 = s_delta * z1758 + c_delta * z1760 + n2 * (z1605 * z1612 + z1633);
    const Scalar z1765 = s_delta * z1760 - c_delta * z1758 + n2 * (z1605 * z1615 - z1619);
    const Scalar z1764 = z1605 * z1615 - z1619 + s_delta * z1614 - z1618;
    const Scalar z1768 = n2 * z1615;
    const Scalar z1769 = n2 * z1612;
    const Scalar z1710 = z1703 - z1708;
    const Scalar z1770 = z1606 * z1768 + z1607 * z1769 + n2 * (c_delta * z1614 + z1632);
    const Scalar z1711 = l_lambda_E4_x * z1609 + l_lambda_E4_y * z1611;
    const Scalar z1772 = z1607 * z1768 - z1606 * z1769 + n2 * (s_delta * z1614 - z1618);
    const Scalar z1781 = z1671 + z1641 * z1661 + s_epsilon * z1660 + c_epsilon * z1658 + n2 * (z1649 * z1650 + z1672);
    const Scalar z1776 = n2 * z1651;
    const Scalar z1778 = n2 * z1648;
    const Scalar z1777 = n0_02 * z1776;
    const Scalar z1779 = n0_02 * z1778;
    const Scalar z1773 = z1630 + a_delta * z1611 + a_Phi * z1621;
    const Scalar z1771 = a_delta * z1609 - z1638 + a_Phi * z1635;
    const Scalar z1782 = z1670 * (a_epsilon + a_Omega) + z1781;
    const Scalar z1774 = z1641 * z1650;
    const Scalar z1775 = s_epsilon * z1652 - z1668 + z1774 - z1667;
    const Scalar z1780 = s_epsilon * z1777 - n2 * (z1668 - z1774) - c_epsilon * z1779;
    const Scalar z1783 = z1654 + z1641 * z1647 + c_epsilon * z1652 + z1653;
    const Scalar z1724 = z1717 - z1722;
    const Scalar z1784 = s_epsilon * z1779 + c_epsilon * z1777 + n2 * (z1641 * z1647 + z1654);
    const Scalar z1725 = l_lambda_E6_x * z1644 - l_lambda_E6_y * z1646;
    const Scalar z1785 = z1641 * z1662 - z1663 + s_epsilon * z1658 - c_epsilon * z1660 - n2 * (z1647 * z1649 - z1664);
    const Scalar z1788 = n2 * z1650;
    const Scalar z1787 = n2 * z1647;
    const Scalar z1790 = a_epsilon * z1644 - z1673 - a_Omega * z1670;
    const Scalar z1792 = z1665 + a_epsilon * z1646 - a_Omega * z1656;
    const Scalar z1789 = n2 * (s_epsilon * z1652 - z1667) - z1640 * z1787 - z1642 * z1788;
    const Scalar z1791 = z1640 * z1788 - z1642 * z1787 + n2 * (c_epsilon * z1652 + z1653);
    const Scalar z1786 = z1656 * (a_epsilon + a_Omega) - z1785;
    const Scalar z1801 = n1 / z1500;
    const Scalar z1802 = z1499 * z1801;
    const Scalar z1793 = n1 / z1656;
    const Scalar z1797 = n1 / z1621;
    const Scalar z1794 = z1670 * z1793;
    const Scalar z1798 = z1635 * z1797;
    const Scalar z1810 = z1568 * z1568;
    const Scalar z1803 = z1580 * z1802 + z1598;
    const Scalar z1796 = z1644 - z1646 * z1794;
    const Scalar z1800 = z1609 - z1611 * z1798;
    const Scalar z1795 = z1580 * z1794 + z1598;
    const Scalar z1820 = z1803 * z1803;
    const Scalar z1804 = n1 / z1803;
    const Scalar z1825 = z1796 * z1796;
    const Scalar z1807 = n1 / z1796;
    const Scalar z1828 = z1800 * z1800;
    const Scalar z1808 = n1 / z1800;
    const Scalar z1799 = z1580 * z1798 - z1598;
    const Scalar z1831 = z1566 + z1568 * z1802;
    const Scalar z1821 = z1566 * z1566;
    const Scalar z1811 = k28 * z1580;
    const Scalar z1822 = k28 * z1598;
    const Scalar z1809 = z1656 * z1656;
    const Scalar z1812 = z1646 * z1646 / z1504 + z1810 / z1512 + z1580 * z1811 + k29 * z1809;
    const Scalar z1814 = z1621 * z1621;
    const Scalar z1815 = z1611 * z1611 / z1508 + z1810 / z1512 + z1580 * z1811 + k29 * z1814;
    const Scalar z1805 = z1795 * z1804;
    const Scalar z1806 = z1799 * z1804;
    const Scalar z1836 = z1804 * z1831;
    const Scalar z1832 = z1566 + z1568 * z1794 - z1805 * z1831;
    const Scalar z1833 = z1566 - z1568 * z1798 + z1806 * z1831;
    const Scalar z1813 = k8 * z1812;
    const Scalar z1816 = k8 * z1815;
    const Scalar z1834 = z1808 * z1833;
    const Scalar z1835 = z1807 * z1832;
    const Scalar z1837 = z1568 - z1580 * z1836;
    const Scalar z1838 = z1801 * z1837;
    const Scalar z1839 = z1568 - z1580 * z1836 - z1611 * z1834;
    const Scalar z1841 = z1568 - z1580 * z1836 + z1646 * z1835;
    const Scalar z1840 = z1797 * z1839;
    const Scalar z1842 = z1793 * z1841;
    const Scalar z1843 = z1597 + z1738 * z1836 + z1594 * z1838;
    const Scalar z1845 = z1597 + z1738 * z1836 - z1634 * z1834 - z1756 * z1840;
    const Scalar z1847 = z1597 + z1738 * z1836 + z1669 * z1835 + z1775 * z1842;
    const Scalar z1846 = z1579 + z1746 * z1836 + z1620 * z1834 + z1764 * z1840;
    const Scalar z1848 = z1579 + z1746 * z1836 + z1655 * z1835 + z1783 * z1842;
    const Scalar z1844 = z1579 + z1746 * z1836 + z1570 * z1838;
    const Scalar z1849 = z1802 * z1843 + z1844;
    const Scalar z1861 = z1734 + z1743 * z1836 + z1751 * z1838;
    const Scalar z1862 = z1736 + z1747 * z1836 + z1754 * z1838;
    const Scalar z1850 = z1848 + z1794 * z1847 - z1805 * z1849;
    const Scalar z1851 = z1798 * z1845 - z1846 - z1806 * z1849;
    const Scalar z1854 = z1804 * z1849;
    const Scalar z1855 = z1580 * z1854 - z1843;
    const Scalar z1852 = z1808 * z1851;
    const Scalar z1853 = z1807 * z1850;
    const Scalar z1859 = z1580 * z1854 - z1847 - z1646 * z1853;
    const Scalar z1856 = z1801 * z1855;
    const Scalar z1857 = z1580 * z1854 - z1845 - z1611 * z1852;
    const Scalar z1867 = z1802 * z1861 + z1862;
    const Scalar z1872 = z1804 * z1867;
    const Scalar z1858 = z1797 * z1857;
    const Scalar z1860 = z1793 * z1859;
    const Scalar z1863 = z1734 + z1743 * z1836 - z1770 * z1834 - z1761 * z1840;
    const Scalar z1873 = z1580 * z1872 - z1861;
    const Scalar z1865 = z1734 + z1743 * z1836 + z1789 * z1835 + z1780 * z1842;
    const Scalar z1874 = z1801 * z1873;
    const Scalar z1864 = z1736 + z1747 * z1836 + z1772 * z1834 + z1765 * z1840;
    const Scalar z1866 = z1736 + z1747 * z1836 + z1791 * z1835 + z1784 * z1842;
    const Scalar z1869 = z1798 * z1863 - z1864 - z1806 * z1867;
    const Scalar z1868 = z1866 + z1794 * z1865 - z1805 * z1867;
    const Scalar z1817 = z1500 * z1500;
    const Scalar z1818 = z1810 / z1512 + z1580 * z1811 + k30 * z1817;
    const Scalar z1870 = z1808 * z1869;
    const Scalar z1823 = k30 * z1499 * z1499 + z1821 / z1512 + z1598 * z1822;
    const Scalar z1819 = k26 * z1818;
    const Scalar z1824 = k10 * z1823;
    const Scalar z1879 = z1743 * z1854;
    const Scalar z1883 = z1879 + z1770 * z1852 + z1761 * z1858;
    const Scalar z1885 = z1780 * z1860 - z1879 - z1789 * z1853;
    const Scalar z1880 = z1751 * z1856 - z1879;
    const Scalar z1881 = z1747 * z1854;
    const Scalar z1882 = z1754 * z1856 - z1881;
    const Scalar z1884 = z1772 * z1852 - z1881 + z1765 * z1858;
    const Scalar z1871 = z1807 * z1868;
    const Scalar z1875 = z1580 * z1872 - z1863 - z1611 * z1870;
    const Scalar z1876 = z1797 * z1875;
    const Scalar z1877 = z1580 * z1872 - z1865 - z1646 * z1871;
    const Scalar z1878 = z1793 * z1877;
    const Scalar z1826 = z1644 * z1644 / z1504 + z1821 / z1512 + z1598 * z1822 + k29 * z1670 * z1670;
    const Scalar z1886 = z1784 * z1860 - z1881 - z1791 * z1853;
    const Scalar z1829 = z1609 * z1609 / z1508 + z1821 / z1512 + z1598 * z1822 + k29 * z1635 * z1635;
    const Scalar z1827 = z1504 * z1826;
    const Scalar z1889 = z1735 - z1745 * z1836 - z1771 * z1834 - z1763 * z1840;
    const Scalar z1830 = z1508 * z1829;
    const Scalar z1890 = z1737 - z1749 * z1836 - z1773 * z1834 - z1767 * z1840;
    const Scalar z1896 = z1884 + z1890;
    const Scalar z1945 = z1684 - z1688 * z1836;
    const Scalar z1891 = z1735 - z1745 * z1836 - z1790 * z1835 + z1782 * z1842;
    const Scalar z1887 = z1735 - z1745 * z1836 + z1752 * z1838;
    const Scalar z1893 = z1880 - z1887;
    const Scalar z1892 = z1737 - z1749 * z1836 + z1792 * z1835 - z1786 * z1842;
    const Scalar z1888 = z1737 - z1749 * z1836 - z1755 * z1838;
    const Scalar z1894 = z1882 + z1888;
    const Scalar z1946 = z1685 + z1689 * z1836;
    const Scalar z1895 = z1883 + z1889;
    const Scalar z1897 = z1885 - z1891;
    const Scalar z1898 = z1886 + z1892;
    const Scalar z1948 = z1709 * z1834 + z1700 * z1840;
    const Scalar z1950 = z1723 * z1835 + z1714 * z1842;
    const Scalar z1949 = z1711 * z1834 + z1705 * z1840;
    const Scalar z1951 = z1719 * z1842 - z1725 * z1835;
    const Scalar z1923 = z1510 * z1836 + z1512;
    const Scalar z1924 = z1510 + k10 * z1836;
    const Scalar z1899 = z1802 * z1893 + z1894;
    const Scalar z1911 = z1728 * z1802 + z1729;
    const Scalar z1959 = z1558 + z1580 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z1598 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z1940 = z1682 * z1854;
    const Scalar z1952 = z1940 + z1945;
    const Scalar z1932 = z1682 * z1836 - z1683;
    const Scalar z1927 = z1508 * z1834 + z1506 * z1840;
    const Scalar z1929 = z1504 * z1835 + z1502 * z1842;
    const Scalar z1901 = z1896 + z1806 * z1899 + z1798 * z1895;
    const Scalar z1913 = z1727 * z1798 - z1731 - z1806 * z1911;
    const Scalar z1926 = z1506 * z1834 + k8 * z1840;
    const Scalar z1902 = z1808 * z1901;
    const Scalar z1914 = z1808 * z1913;
    const Scalar z1900 = z1898 + z1794 * z1897 - z1805 * z1899;
    const Scalar z1912 = z1726 * z1794 + z1730 - z1805 * z1911;
    const Scalar z1961 = l_lambda_E4_x * z1621 - z1552 - l_lambda_E4_y * z1635;
    const Scalar z1960 = z1556 + l_lambda_E3_x * z1500 + l_lambda_E3_y * z1499;
    const Scalar z1962 = l_lambda_E4_x * z1611 - z1555 - l_lambda_E4_y * z1609;
    const Scalar z1904 = z1804 * z1899;
    const Scalar z1916 = z1804 * z1911;
    const Scalar z1905 = z1580 * z1904 - z1893;
    const Scalar z1917 = z1580 * z1916 - z1728;
    const Scalar z1942 = z1710 * z1852 + z1703 * z1858;
    const Scalar z1954 = z1942 + z1949;
    const Scalar z1934 = z1710 * z1834 + z1703 * z1840;
    const Scalar z1941 = z1708 * z1852;
    const Scalar z1953 = z1941 - z1948;
    const Scalar z1906 = z1801 * z1905;
    const Scalar z1918 = z1801 * z1917;
    const Scalar z1933 = z1708 * z1834;
    const Scalar z1928 = z1502 * z1835 + k8 * z1842;
    const Scalar z1903 = z1807 * z1900;
    const Scalar z1963 = z1547 + l_lambda_E6_x * z1656 + l_lambda_E6_y * z1670;
    const Scalar z1964 = z1550 + l_lambda_E6_x * z1646 + l_lambda_E6_y * z1644;
    const Scalar z1965 = z1568 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z1561 - z1566 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y) - z1836 * z1959 - z1834 * z1962 + z1835 * z1964 - z1840 * z1961 - z1842 * z1963
        - z1838 * z1960;
    const Scalar z1915 = z1807 * z1912;
    const Scalar z1907 = z1580 * z1904 + z1895 + z1611 * z1902;
    const Scalar z1919 = z1580 * z1916 - z1727 - z1611 * z1914;
    const Scalar z1944 = z1717 * z1860 - z1724 * z1853;
    const Scalar z1956 = z1944 + z1951;
    const Scalar z1936 = z1724 * z1835 + z1717 * z1842;
    const Scalar z1943 = z1722 * z1853;
    const Scalar z1955 = z1943 + z1950;
    const Scalar z1935 = z1722 * z1835;
    const Scalar z1937 = z1678 * z1836 - z1932 + z1840 * z1933 - z1842 * z1935 - z1834 * z1934 + z1835 * z1936;
    const Scalar z1908 = z1797 * z1907;
    const Scalar z1920 = z1797 * z1919;
    const Scalar z1909 = z1580 * z1904 - z1897 - z1646 * z1903;
    const Scalar z1921 = z1580 * z1916 - z1726 - z1646 * z1915;
    const Scalar z1910 = z1793 * z1909;
    const Scalar z1922 = z1793 * z1921;
    const Scalar z1947 = z1697 * z1838;
    const Scalar z1957 = z1836 * z1946 - z1952 - z1840 * z1953 - z1842 * z1955 + z1834 * z1954 - z1835 * z1956 + z1838
        * z1947;
    const Scalar z1925 = k26 * z1838;
    const Scalar z1930 = z1836 * z1924 + z1923 + z1838 * z1925 + z1834 * z1927 + z1835 * z1929 + z1840 * z1926 + z1842
        * z1928;
    const Scalar z1931 = z1874 * z1925 - z1872 * z1924 + z1870 * z1927 - z1871 * z1929 + z1876 * z1926 + z1878 * z1928;
    const Scalar z1939 = z1904 * z1924 - z1906 * z1925 + z1902 * z1927 + z1903 * z1929 - z1908 * z1926 - z1910 * z1928;
    const Scalar z1966 = z1918 * z1925 - z1916 * z1924 + z1914 * z1927 - z1915 * z1929 + z1920 * z1926 + z1922 * z1928;
    const Scalar z1958 = z1939 + z1957;
    const Scalar z1938 = z1931 + z1937;
    const Scalar z1968 = n1 / z1930;
    const Scalar z1967 = z1965 - z1966;
    const Scalar z1969 = z1958 * z1968;
    const Scalar z1970 = z1938 * z1968;
    result.M[0] = z1512;
    result.M[1] = z1510;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = z1510;
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
    result.M[25] = z1506;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = n0;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = z1506;
    result.M[32] = z1508;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n0;
    result.M[36] = n0;
    result.M[37] = n0;
    result.M[38] = n0;
    result.M[39] = n0;
    result.M[40] = k8;
    result.M[41] = z1502;
    result.M[42] = n0;
    result.M[43] = n0;
    result.M[44] = n0;
    result.M[45] = n0;
    result.M[46] = n0;
    result.M[47] = z1502;
    result.M[48] = z1504;
    result.C[0] = -z1683;
    result.C[1] = -z1678;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z1682;
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
    result.C[25] = z1703;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z1708;
    result.C[32] = z1710;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z1717;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z1722;
    result.C[48] = -z1724;
    result.K[0] = z1684;
    result.K[1] = -z1685;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z1688;
    result.K[8] = -z1689;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z1697;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z1700;
    result.K[25] = -z1705;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z1709;
    result.K[32] = -z1711;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = z1714;
    result.K[41] = z1719;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = z1723;
    result.K[48] = -z1725;
    result.F[0] = -z1568 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z1561 + z1566 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    result.F[1] = z1558 + z1580 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z1598 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    result.F[2] = -z1556 - l_lambda_E3_x * z1500 - l_lambda_E3_y * z1499;
    result.F[3] = l_lambda_E4_x * z1621 - z1552 - l_lambda_E4_y * z1635;
    result.F[4] = l_lambda_E4_x * z1611 - z1555 - l_lambda_E4_y * z1609;
    result.F[5] = z1547 + l_lambda_E6_x * z1656 + l_lambda_E6_y * z1670;
    result.F[6] = -z1550 - l_lambda_E6_x * z1646 - l_lambda_E6_y * z1644;
    result.M_r[0] = z1930;
    result.C_r[0] = -z1938;
    result.K_r[0] = -z1958;
    result.F_r[0] = -z1967;
    result.A[0] = n0;
    result.A[1] = z1969;
    result.A[2] = n1;
    result.A[3] = z1970;
    if (!(traits::regular(z1809, z1813) && traits::regular(z1814, z1816) && traits::regular(z1817, z1819)
        && traits::regular(z1820, z1824) && traits::regular(z1825, z1827) && traits::regular(z1828, z1830)
        && traits::regular(z1930, z1930))) return torsor::Status::singular;
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
    const Scalar z1984 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1985 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2033 = n0_028 * c_Theta;
    const Scalar z2034 = n0_028 * s_Theta;
    const Scalar z1981 = v_beta + v_Theta;
    const Scalar z2041 = v_beta * c_beta;
    const Scalar z2003 = v_beta * v_beta;
    const Scalar z1982 = v_delta + v_Phi;
    const Scalar z2042 = v_Theta * c_Theta;
    const Scalar z1983 = v_epsilon + v_Omega;
    const Scalar z2044 = v_beta * s_beta;
    const Scalar z2045 = v_Theta * s_Theta;
    const Scalar z1992 = k3 * s_gamma + k4 * c_gamma;
    const Scalar z2004 = n0_175 * z2003;
    const Scalar z2011 = z1981 * z1981;
    const Scalar z2017 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z2019 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z1993 = k4 * s_gamma - k3 * c_gamma;
    const Scalar z2006 = v_epsilon * v_epsilon;
    const Scalar z2007 = z1983 * z1983;
    const Scalar z2009 = z1982 * z1982;
    const Scalar z2012 = k6 * z2011;  // force on K2, times 0.04 m, x
    const Scalar z2013 = n0_175 * a_beta;
    const Scalar z2015 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z2020 = k7 * z2019;  // force on K6, times 0.04 m, y
    const Scalar z2014 = s_Theta * z2004 + c_Theta * z2013;
    const Scalar z2024 = k7 * z2017;  // force on K4, times 0.04 m, x
    const Scalar z2008 = k7 * z2007;  // force on K6, times 0.04 m, x
    const Scalar z2022 = s_Omega * z2020 + c_Omega * z2008;
    const Scalar z2040 = v_gamma * c_gamma;
    const Scalar z2010 = k7 * z2009;  // force on K4, times 0.04 m, y
    const Scalar z2026 = s_Phi * z2024 + c_Phi * z2010;
    const Scalar z2005 = v_delta * v_delta;
    const Scalar z2018 = a_epsilon * s_Omega - c_Omega * z2006;
    const Scalar z2016 = a_delta * s_Phi - c_Phi * z2005;
    const Scalar z2029 = k6 * z2015;  // force on K2, times 0.04 m, y
    const Scalar z2031 = s_Theta * z2012 - c_Theta * z2029;
    const Scalar z1988 = n0_035 * s_gamma;
    const Scalar z1989 = n0_035 * c_gamma;
    const Scalar z2035 = n0_007 - z2033;
    const Scalar z2036 = s_beta * z2034;
    const Scalar z2038 = c_beta * z2034;
    const Scalar z2043 = n0_028 * z2042;
    const Scalar z2037 = c_beta * z2035 + z2036;
    const Scalar z2039 = s_beta * z2035 - z2038;
    const Scalar z1986 = k10 - z1984;
    const Scalar z2046 = n0_028 * z2045;
    const Scalar z1987 = k11 + z1985;
    const Scalar z2047 = s_beta * z2033 + z2038;
    const Scalar z2048 = v_gamma * s_gamma;
    const Scalar z2049 = v_gamma * z2048;
    const Scalar z1994 = n0_02 - z1992;
    const Scalar z1995 = n0_018 - z1993;
    const Scalar z2021 = k7 * z2018 - k12 * z2019;  // moment on K6, z
    const Scalar z2025 = k12 * z2017 + k7 * z2016;  // moment on K4, z
    const Scalar z2030 = k6 * z2014 - k13 * z2015;  // moment on K2, z
    const Scalar z1990 = n0_014 + z1986;
    const Scalar z2050 = n0_035 * z2049;
    const Scalar z1991 = n0_072 - z1987;
    const Scalar z2051 = v_Theta * z2045;
    const Scalar z2053 = v_Theta * z2042;
    const Scalar z2055 = v_beta * z2044;
    const Scalar z2052 = n0_028 * z2051;
    const Scalar z2054 = n0_028 * z2053;
    const Scalar z2027 = k16 * a_delta + z2026 + z2025;  // moment on K5, z
    const Scalar z1996 = z1990 * z1990 + z1991 * z1991;
    const Scalar z2056 = v_beta * z2041;
    const Scalar z2023 = k17 * a_epsilon - z2022 - z2021;  // moment on K7, z
    const Scalar z2032 = n0_033 - k19 * a_beta - n0_175 * z2031 + z2030;  // moment on K1, z
    const Scalar z1997 = traits::sqrt(z1996);
    const Scalar z2057 = z2034 * z2055 + z2035 * z2056 + s_beta * z2052 - c_beta * z2054 - n2 * (z2041 * z2043 - z2044
        * z2046);
    const Scalar z1998 = n1 / z1997;
    const Scalar z2058 = z2050 - z2057;
    const Scalar z1999 = n4530 - n352_6605 * z1998;
    const Scalar z2059 = c_beta * z2033 - z2036;
    const Scalar z2000 = z1994 * z1999;
    const Scalar z2060 = v_gamma * z2040;
    const Scalar z2001 = z1995 * z1999;
    const Scalar z2061 = n0_035 * z2060;
    const Scalar z2002 = n0_018 * z2000 - n0_02 * z2001;
    const Scalar z2062 = z2034 * z2056 - z2035 * z2055 + s_beta * z2054 + c_beta * z2052 + n2 * (z2041 * z2046 + z2043
        * z2044);
    const Scalar z2064 = n0_02 * s_Phi;
    const Scalar z2074 = v_delta * s_delta;
    const Scalar z2065 = n0_02 * c_Phi;
    const Scalar z2066 = n0_04 + z2064;
    const Scalar z2071 = v_delta * c_delta;
    const Scalar z2082 = v_delta * z2074;
    const Scalar z2072 = v_Phi * s_Phi;
    const Scalar z2075 = v_Phi * c_Phi;
    const Scalar z2083 = v_delta * z2071;
    const Scalar z2063 = z2061 - z2062;
    const Scalar z2078 = v_Phi * z2075;
    const Scalar z2076 = n0_02 * z2075;
    const Scalar z2080 = v_Phi * z2072;
    const Scalar z2081 = n0_02 * z2080;
    const Scalar z2079 = n0_02 * z2078;
    const Scalar z2073 = n0_02 * z2072;
    const Scalar z2067 = s_delta * z2065;
    const Scalar z2069 = c_delta * z2065;
    const Scalar z2068 = c_delta * z2066 + z2067;
    const Scalar z2086 = c_delta * z2064 + z2067;
    const Scalar z2077 = s_delta * z2064 - z2069;
    const Scalar z2070 = s_delta * z2066 - z2069;
    const Scalar z2084 = z2065 * z2082 + z2066 * z2083 + s_delta * z2079 + c_delta * z2081 + n2 * (z2071 * z2073 + z2074
        * z2076);
    const Scalar z2087 = z2066 * z2082 - z2065 * z2083 + s_delta * z2081 - c_delta * z2079 - n2 * (z2071 * z2076 - z2073
        * z2074);
    const Scalar z2085 = z2057 - z2084;
    const Scalar z2028 = k25 * a_gamma + z2002;  // moment on K3, z
    const Scalar z2100 = v_Omega * s_Omega;
    const Scalar z2099 = v_epsilon * s_epsilon;
    const Scalar z2103 = v_Omega * z2100;
    const Scalar z2089 = n0_02 * c_Omega;
    const Scalar z2115 = a_beta * z2039 - a_Theta * z2047 - a_delta * z2070 - a_Phi * z2077 + z2085;
    const Scalar z2090 = n0_02 * s_Omega;
    const Scalar z2096 = v_epsilon * c_epsilon;
    const Scalar z2104 = n0_02 * z2103;
    const Scalar z2108 = v_epsilon * z2099;
    const Scalar z2116 = a_beta * z2039 - a_Theta * z2047 + a_gamma * z1989 - z2058;
    const Scalar z2097 = v_Omega * c_Omega;
    const Scalar z2091 = n0_04 - z2090;
    const Scalar z2117 = a_beta * z2037 - a_Theta * z2059 - a_gamma * z1988 - z2063;
    const Scalar z2107 = v_epsilon * z2096;
    const Scalar z2105 = v_Omega * z2097;
    const Scalar z2106 = n0_02 * z2105;
    const Scalar z2098 = n0_02 * z2097;
    const Scalar z2101 = n0_02 * z2100;
    const Scalar z2088 = z2062 + z2087;
    const Scalar z2119 = a_beta * z2037 - a_Theta * z2059 - a_delta * z2068 - a_Phi * z2086 + z2088;
    const Scalar z2092 = c_epsilon * z2089;
    const Scalar z2094 = s_epsilon * z2089;
    const Scalar z2093 = s_epsilon * z2091 + z2092;
    const Scalar z2111 = s_epsilon * z2090 - z2092;
    const Scalar z2102 = c_epsilon * z2090 + z2094;
    const Scalar z2095 = c_epsilon * z2091 - z2094;
    const Scalar z2109 = s_epsilon * z2104 - z2089 * z2107 - z2091 * z2108 - c_epsilon * z2106 - n2 * (z2096 * z2098
        - z2099 * z2101);
    const Scalar z2112 = z2089 * z2108 - z2091 * z2107 + s_epsilon * z2106 + c_epsilon * z2104 + n2 * (z2096 * z2101
        + z2098 * z2099);
    const Scalar z2110 = z2057 + z2109;
    const Scalar z2113 = z2062 + z2112;
    const Scalar z2114 = a_beta * z2039 - a_Theta * z2047 + a_epsilon * z2095 - a_Omega * z2102 + z2110;
    const Scalar z2118 = a_beta * z2037 - a_Theta * z2059 - a_epsilon * z2093 + a_Omega * z2111 + z2113;
    residual[0] = z2039 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z2032 - z2037 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    residual[1] = -z2030 - z2047 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z2059 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    residual[2] = z2028 + l_lambda_E3_x * z1989 + l_lambda_E3_y * z1988;
    residual[3] = -l_lambda_E4_x * z2077 + z2025 + l_lambda_E4_y * z2086;
    residual[4] = -l_lambda_E4_x * z2070 + z2027 + l_lambda_E4_y * z2068;
    residual[5] = -z2021 - l_lambda_E6_x * z2102 - l_lambda_E6_y * z2111;
    residual[6] = z2023 + l_lambda_E6_x * z2095 + l_lambda_E6_y * z2093;
    residual[7] = -z2116;
    residual[8] = z2117;
    residual[9] = -z2115;
    residual[10] = z2119;
    residual[11] = -z2114;
    residual[12] = z2118;
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
    const Scalar z2163 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z2164 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2214 = n0_028 * c_Theta;
    const Scalar z2215 = n0_028 * s_Theta;
    const Scalar z2160 = v_beta + v_Theta;
    const Scalar z2183 = k3 * s_gamma + k4 * c_gamma;
    const Scalar z2184 = k4 * s_gamma - k3 * c_gamma;
    const Scalar z2191 = v_beta * v_beta;
    const Scalar z2201 = n0_175 * a_beta;
    const Scalar z2203 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z2161 = v_delta + v_Phi;
    const Scalar z2162 = v_epsilon + v_Omega;
    const Scalar z2222 = v_beta * c_beta;
    const Scalar z2223 = v_Theta * c_Theta;
    const Scalar z2192 = n0_175 * z2191;
    const Scalar z2199 = z2160 * z2160;
    const Scalar z2212 = k6 * z2203;  // force on K2, times 0.04 m, y
    const Scalar z2195 = z2162 * z2162;
    const Scalar z2197 = z2161 * z2161;
    const Scalar z2200 = k6 * z2199;  // force on K2, times 0.04 m, x
    const Scalar z2202 = s_Theta * z2201 - c_Theta * z2192;
    const Scalar z2193 = v_delta * v_delta;
    const Scalar z2194 = v_epsilon * v_epsilon;
    const Scalar z2196 = k7 * z2195;  // force on K6, times 0.04 m, x
    const Scalar z2198 = k7 * z2197;  // force on K4, times 0.04 m, y
    const Scalar z2205 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z2207 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z2213 = s_Theta * z2212 + c_Theta * z2200;
    const Scalar z2204 = a_delta * c_Phi + s_Phi * z2193;
    const Scalar z2206 = a_epsilon * c_Omega + s_Omega * z2194;
    const Scalar z2208 = k7 * z2207;  // force on K6, times 0.04 m, y
    const Scalar z2210 = k7 * z2205;  // force on K4, times 0.04 m, x
    const Scalar z2221 = v_gamma * c_gamma;
    const Scalar z2209 = s_Omega * z2196 - c_Omega * z2208;
    const Scalar z2167 = n0_035 * s_gamma;
    const Scalar z2211 = s_Phi * z2198 - c_Phi * z2210;
    const Scalar z2169 = k7 * s_Omega;
    const Scalar z2173 = k7 * s_Phi;
    const Scalar z2177 = k6 * c_Theta;
    const Scalar z2168 = n0_035 * c_gamma;
    const Scalar z2170 = k9 - z2169;
    const Scalar z2171 = k9 - n2 * z2169;
    const Scalar z2174 = k9 + z2173;
    const Scalar z2175 = k9 + n2 * z2173;
    const Scalar z2178 = k11 - n0_175 * z2177;
    const Scalar z2179 = k11 - n0_35 * z2177;
    const Scalar z2216 = n0_007 - z2214;
    const Scalar z2217 = s_beta * z2215;
    const Scalar z2219 = c_beta * z2215;
    const Scalar z2224 = n0_028 * z2223;
    const Scalar z2218 = c_beta * z2216 + z2217;
    const Scalar z2220 = s_beta * z2216 - z2219;
    const Scalar z2165 = k14 - z2163;
    const Scalar z2225 = v_beta * s_beta;
    const Scalar z2166 = k15 + z2164;
    const Scalar z2228 = s_beta * z2214 + z2219;
    const Scalar z2226 = v_Theta * s_Theta;
    const Scalar z2229 = v_gamma * s_gamma;
    const Scalar z2227 = n0_028 * z2226;
    const Scalar z2230 = v_gamma * z2229;
    const Scalar z2231 = n0_035 * z2230;
    const Scalar z2172 = k16 + z2171;
    const Scalar z2234 = v_Theta * z2223;
    const Scalar z2232 = v_Theta * z2226;
    const Scalar z2233 = n0_028 * z2232;
    const Scalar z2235 = n0_028 * z2234;
    const Scalar z2176 = k17 + z2175;
    const Scalar z2236 = v_beta * z2225;
    const Scalar z2237 = v_beta * z2222;
    const Scalar z2239 = z2225 * z2227;
    const Scalar z2238 = z2215 * z2236;
    const Scalar z2180 = k18 + z2179;
    const Scalar z2185 = n0_02 - z2183;
    const Scalar z2186 = n0_018 - z2184;
    const Scalar z2240 = z2238 + z2216 * z2237 + s_beta * z2233 - c_beta * z2235 - n2 * (z2222 * z2224 - z2239);
    const Scalar z2181 = n0_014 + z2165;
    const Scalar z2182 = n0_072 - z2166;
    const Scalar z2241 = c_beta * z2214 - z2217;
    const Scalar z2244 = z2215 * z2237;
    const Scalar z2187 = z2181 * z2181 + z2182 * z2182;
    const Scalar z2247 = n0_02 * s_Phi;
    const Scalar z2245 = z2222 * z2227;
    const Scalar z2246 = z2244 + s_beta * z2235 - z2216 * z2236 + c_beta * z2233 + n2 * (z2224 * z2225 + z2245);
    const Scalar z2188 = traits::sqrt(z2187);
    const Scalar z2248 = n0_02 * c_Phi;
    const Scalar z2242 = v_gamma * z2221;
    const Scalar z2243 = n0_035 * z2242;
    const Scalar z2189 = n1 / z2188;
    const Scalar z2249 = n0_04 + z2247;
    const Scalar z2190 = n4530 - n352_6605 * z2189;
    const Scalar z2305 = n2 * z2160;
    const Scalar z2306 = k6 * z2305;
    const Scalar z2254 = v_delta * c_delta;
    const Scalar z2257 = v_delta * s_delta;
    const Scalar z2281 = v_epsilon * c_epsilon;
    const Scalar z2282 = v_Omega * c_Omega;
    const Scalar z2284 = v_epsilon * s_epsilon;
    const Scalar z2307 = s_Theta * z2306;
    const Scalar z2285 = v_Omega * s_Omega;
    const Scalar z2265 = v_delta * z2257;
    const Scalar z2266 = v_delta * z2254;
    const Scalar z2274 = n0_02 * c_Omega;
    const Scalar z2288 = v_Omega * z2285;
    const Scalar z2308 = n0_175 * z2307;
    const Scalar z2290 = v_Omega * z2282;
    const Scalar z2289 = n0_02 * z2288;
    const Scalar z2291 = n0_02 * z2290;
    const Scalar z2292 = v_epsilon * z2281;
    const Scalar z2293 = v_epsilon * z2284;
    const Scalar z2255 = v_Phi * s_Phi;
    const Scalar z2258 = v_Phi * c_Phi;
    const Scalar z2267 = z2248 * z2265;
    const Scalar z2271 = z2248 * z2266;
    const Scalar z2294 = z2274 * z2292;
    const Scalar z2298 = z2274 * z2293;
    const Scalar z2261 = v_Phi * z2258;
    const Scalar z2263 = v_Phi * z2255;
    const Scalar z2262 = n0_02 * z2261;
    const Scalar z2264 = n0_02 * z2263;
    const Scalar z2275 = n0_02 * s_Omega;
    const Scalar z2276 = n0_04 - z2275;
    const Scalar z2256 = n0_02 * z2255;
    const Scalar z2286 = n0_02 * z2285;
    const Scalar z2259 = n0_02 * z2258;
    const Scalar z2268 = z2254 * z2256;
    const Scalar z2272 = z2256 * z2257;
    const Scalar z2283 = n0_02 * z2282;
    const Scalar z2295 = z2284 * z2286;
    const Scalar z2299 = z2281 * z2286;
    const Scalar z2252 = c_delta * z2248;
    const Scalar z2279 = s_epsilon * z2274;
    const Scalar z2250 = s_delta * z2248;
    const Scalar z2310 = z2218 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z2220 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z2277 = c_epsilon * z2274;
    const Scalar z2301 = n2 * v_beta;
    const Scalar z2302 = n0_175 * z2301;
    const Scalar z2260 = s_delta * z2247 - z2252;
    const Scalar z2253 = s_delta * z2249 - z2252;
    const Scalar z2287 = c_epsilon * z2275 + z2279;
    const Scalar z2280 = c_epsilon * z2276 - z2279;
    const Scalar z2303 = s_Theta * z2302;
    const Scalar z2251 = c_delta * z2249 + z2250;
    const Scalar z2316 = n2 * (z2163 * z2182 - z2164 * z2181);
    const Scalar z2317 = n0_5 * z2316 / z2188;
    const Scalar z2312 = k6 * z2202;
    const Scalar z2327 = n2 * z2161;
    const Scalar z2313 = n0_175 * z2213 + z2312;
    const Scalar z2315 = z2228 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z2312 + z2241 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z2314 = z2228 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z2313 + z2241 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z2270 = c_delta * z2247 + z2250;
    const Scalar z2324 = k7 * z2204;
    const Scalar z2328 = k7 * z2327;
    const Scalar z2304 = k6 * z2303;
    const Scalar z2309 = z2304 - z2308;
    const Scalar z2311 = z2228 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z2241 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z2318 = z2317 / (z2188 * z2188);
    const Scalar z2269 = z2267 + z2249 * z2266 + s_delta * z2262 + c_delta * z2264 + n2 * (z2257 * z2259 + z2268);
    const Scalar z2329 = c_Phi * z2328;
    const Scalar z2330 = z2211 - z2324;
    const Scalar z2332 = n2 * v_delta;
    const Scalar z2273 = z2249 * z2265 - z2271 + s_delta * z2264 - c_delta * z2262 - n2 * (z2254 * z2259 - z2272);
    const Scalar z2319 = n352_6605 * z2318;
    const Scalar z2333 = c_Phi * z2332;
    const Scalar z2334 = k7 * z2333;
    const Scalar z2337 = l_lambda_E4_x * z2251 + l_lambda_E4_y * z2253;
    const Scalar z2320 = z2184 * z2190 - z2185 * z2319;
    const Scalar z2321 = z2183 * z2190 + z2186 * z2319;
    const Scalar z2336 = z2329 - z2334;
    const Scalar z2322 = n0_018 * z2320 + n0_02 * z2321;
    const Scalar z2278 = s_epsilon * z2276 + z2277;
    const Scalar z2355 = z2246 + a_beta * z2218 - a_Theta * z2241;
    const Scalar z2341 = n2 * z2162;
    const Scalar z2297 = s_epsilon * z2275 - z2277;
    const Scalar z2338 = k7 * z2206;
    const Scalar z2323 = l_lambda_E3_x * z2167 - z2322 - l_lambda_E3_y * z2168;
    const Scalar z2342 = k7 * z2341;
    const Scalar z2343 = c_Omega * z2342;
    const Scalar z2344 = z2209 - z2338;
    const Scalar z2351 = l_lambda_E6_x * z2278 - l_lambda_E6_y * z2280;
    const Scalar z2352 = n2 * z2225;
    const Scalar z2353 = n2 * z2222;
    const Scalar z2354 = z2215 * z2352 + z2216 * z2353 + n2 * (s_beta * z2227 - c_beta * z2224);
    const Scalar z2346 = n2 * v_epsilon;
    const Scalar z2347 = c_Omega * z2346;
    const Scalar z2296 = s_epsilon * z2289 - z2294 - z2276 * z2293 - c_epsilon * z2291 - n2 * (z2281 * z2283 - z2295);
    const Scalar z2356 = z2215 * z2353 - z2216 * z2352 + n2 * (s_beta * z2224 + c_beta * z2227);
    const Scalar z2357 = z2240 + a_beta * z2220 - a_Theta * z2228;
    const Scalar z2358 = n2 * z2226;
    const Scalar z2359 = n0_028 * z2358;
    const Scalar z2348 = k7 * z2347;
    const Scalar z2350 = z2343 - z2348;
    const Scalar z2300 = z2298 + s_epsilon * z2291 - z2276 * z2292 + c_epsilon * z2289 + n2 * (z2283 * z2284 + z2299);
    const Scalar z2363 = z2244 + z2214 * z2236 + s_beta * z2235 + c_beta * z2233 + n2 * (z2224 * z2225 + z2245);
    const Scalar z2366 = z2238 + s_beta * z2233 - z2214 * z2237 - c_beta * z2235 - n2 * (z2222 * z2224 - z2239);
    const Scalar z2379 = z2247 * z2265 - z2271 + s_delta * z2264 - c_delta * z2262 - n2 * (z2254 * z2259 - z2272);
    const Scalar z2382 = z2267 + z2247 * z2266 + s_delta * z2262 + c_delta * z2264 + n2 * (z2257 * z2259 + z2268);
    const Scalar z2364 = z2241 * (a_beta + a_Theta) - z2363;
    const Scalar z2367 = z2228 * (a_beta + a_Theta) - z2366;
    const Scalar z2370 = a_gamma * z2167 + z2243;
    const Scalar z2373 = a_gamma * z2168 - z2231;
    const Scalar z2380 = z2270 * (a_delta + a_Phi) - z2379;
    const Scalar z2383 = z2260 * (a_delta + a_Phi) + z2382;
    const Scalar z2360 = n2 * z2223;
    const Scalar z2374 = n2 * z2258;
    const Scalar z2376 = n2 * z2255;
    const Scalar z2361 = n0_028 * z2360;
    const Scalar z2375 = n0_02 * z2374;
    const Scalar z2377 = n0_02 * z2376;
    const Scalar z2368 = n2 * z2229;
    const Scalar z2369 = n0_035 * z2368;
    const Scalar z2371 = n2 * z2221;
    const Scalar z2372 = n0_035 * z2371;
    const Scalar z2362 = s_beta * z2359 - n2 * (z2214 * z2222 - z2215 * z2225) - c_beta * z2361;
    const Scalar z2365 = s_beta * z2361 + c_beta * z2359 + n2 * (z2214 * z2225 + z2215 * z2222);
    const Scalar z2378 = s_delta * z2375 + c_delta * z2377 + n2 * (z2247 * z2254 + z2248 * z2257);
    const Scalar z2381 = s_delta * z2377 - c_delta * z2375 + n2 * (z2247 * z2257 - z2248 * z2254);
    const Scalar z2384 = n2 * z2257;
    const Scalar z2325 = l_lambda_E4_y * z2260;
    const Scalar z2326 = l_lambda_E4_x * z2270 - z2324 + z2325;
    const Scalar z2389 = z2269 + a_delta * z2253 + a_Phi * z2260;
    const Scalar z2387 = a_delta * z2251 - z2273 + a_Phi * z2270;
    const Scalar z2331 = l_lambda_E4_x * z2270 + z2325 + z2330;
    const Scalar z2335 = l_lambda_E4_x * z2270 + z2325;
    const Scalar z2395 = z2298 + z2275 * z2292 + s_epsilon * z2291 + c_epsilon * z2289 + n2 * (z2283 * z2284 + z2299);
    const Scalar z2398 = z2275 * z2293 - z2294 + s_epsilon * z2289 - c_epsilon * z2291 - n2 * (z2281 * z2283 - z2295);
    const Scalar z2396 = z2297 * (a_epsilon + a_Omega) + z2395;
    const Scalar z2390 = n2 * z2285;
    const Scalar z2392 = n2 * z2282;
    const Scalar z2391 = n0_02 * z2390;
    const Scalar z2393 = n0_02 * z2392;
    const Scalar z2385 = n2 * z2254;
    const Scalar z2386 = z2248 * z2384 + z2249 * z2385 + n2 * (s_delta * z2259 + c_delta * z2256);
    const Scalar z2388 = z2249 * z2384 - z2248 * z2385 + n2 * (s_delta * z2256 - c_delta * z2259);
    const Scalar z2339 = l_lambda_E6_y * z2287;
    const Scalar z2340 = l_lambda_E6_x * z2297 - z2338 - z2339;
    const Scalar z2401 = n2 * z2284;
    const Scalar z2400 = n2 * z2281;
    const Scalar z2403 = a_epsilon * z2278 - z2300 - a_Omega * z2297;
    const Scalar z2345 = l_lambda_E6_x * z2297 - z2339 + z2344;
    const Scalar z2349 = l_lambda_E6_x * z2297 - z2339;
    const Scalar z2394 = s_epsilon * z2391 - n2 * (z2274 * z2281 - z2275 * z2284) - c_epsilon * z2393;
    const Scalar z2397 = s_epsilon * z2393 + c_epsilon * z2391 + n2 * (z2274 * z2284 + z2275 * z2281);
    const Scalar z2399 = z2287 * (a_epsilon + a_Omega) - z2398;
    const Scalar z2402 = n2 * (s_epsilon * z2286 - c_epsilon * z2283) - z2274 * z2400 - z2276 * z2401;
    const Scalar z2404 = z2274 * z2401 - z2276 * z2400 + n2 * (s_epsilon * z2283 + c_epsilon * z2286);
    const Scalar z2405 = z2296 + a_epsilon * z2280 - a_Omega * z2287;
    result.values[0] = z2310;
    result.values[1] = -z2314;
    result.values[2] = -z2309;
    result.values[3] = z2308;
    result.values[4] = z2180;
    result.values[5] = z2178;
    result.values[6] = z2220;
    result.values[7] = -z2218;
    result.values[8] = z2220;
    result.values[9] = -z2218;
    result.values[10] = z2220;
    result.values[11] = -z2218;
    result.values[12] = -z2311;
    result.values[13] = -z2315;
    result.values[14] = -z2304;
    result.values[15] = z2178;
    result.values[16] = k11;
    result.values[17] = -z2228;
    result.values[18] = z2241;
    result.values[19] = -z2228;
    result.values[20] = z2241;
    result.values[21] = -z2228;
    result.values[22] = z2241;
    result.values[23] = -z2323;
    result.values[24] = k26;
    result.values[25] = z2168;
    result.values[26] = z2167;
    result.values[27] = -z2326;
    result.values[28] = -z2335;
    result.values[29] = -z2334;
    result.values[30] = k9;
    result.values[31] = z2174;
    result.values[32] = -z2260;
    result.values[33] = z2270;
    result.values[34] = -z2331;
    result.values[35] = -z2337;
    result.values[36] = z2329;
    result.values[37] = z2336;
    result.values[38] = z2174;
    result.values[39] = z2176;
    result.values[40] = -z2253;
    result.values[41] = z2251;
    result.values[42] = z2340;
    result.values[43] = z2349;
    result.values[44] = z2348;
    result.values[45] = k9;
    result.values[46] = z2170;
    result.values[47] = -z2287;
    result.values[48] = -z2297;
    result.values[49] = z2345;
    result.values[50] = -z2351;
    result.values[51] = -z2343;
    result.values[52] = -z2350;
    result.values[53] = z2170;
    result.values[54] = z2172;
    result.values[55] = z2280;
    result.values[56] = z2278;
    result.values[57] = -z2355;
    result.values[58] = z2364;
    result.values[59] = z2370;
    result.values[60] = -z2354;
    result.values[61] = -z2362;
    result.values[62] = z2369;
    result.values[63] = -z2220;
    result.values[64] = z2228;
    result.values[65] = -z2168;
    result.values[66] = -z2357;
    result.values[67] = z2367;
    result.values[68] = -z2373;
    result.values[69] = z2356;
    result.values[70] = z2365;
    result.values[71] = -z2372;
    result.values[72] = z2218;
    result.values[73] = -z2241;
    result.values[74] = -z2167;
    result.values[75] = -z2355;
    result.values[76] = z2364;
    result.values[77] = z2380;
    result.values[78] = z2387;
    result.values[79] = -z2354;
    result.values[80] = -z2362;
    result.values[81] = z2378;
    result.values[82] = z2386;
    result.values[83] = -z2220;
    result.values[84] = z2228;
    result.values[85] = z2260;
    result.values[86] = z2253;
    result.values[87] = -z2357;
    result.values[88] = z2367;
    result.values[89] = z2383;
    result.values[90] = z2389;
    result.values[91] = z2356;
    result.values[92] = z2365;
    result.values[93] = z2381;
    result.values[94] = z2388;
    result.values[95] = z2218;
    result.values[96] = -z2241;
    result.values[97] = -z2270;
    result.values[98] = -z2251;
    result.values[99] = -z2355;
    result.values[100] = z2364;
    result.values[101] = -z2396;
    result.values[102] = z2403;
    result.values[103] = -z2354;
    result.values[104] = -z2362;
    result.values[105] = -z2394;
    result.values[106] = -z2402;
    result.values[107] = -z2220;
    result.values[108] = z2228;
    result.values[109] = z2287;
    result.values[110] = -z2280;
    result.values[111] = -z2357;
    result.values[112] = z2367;
    result.values[113] = z2399;
    result.values[114] = -z2405;
    result.values[115] = z2356;
    result.values[116] = z2365;
    result.values[117] = z2397;
    result.values[118] = z2404;
    result.values[119] = z2218;
    result.values[120] = -z2241;
    result.values[121] = z2297;
    result.values[122] = -z2278;
  }
};

}  // namespace andrews_squeezer
