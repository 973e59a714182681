// SPDX-License-Identifier: MIT
// elastic_wing: Half an aircraft with an elastic wing and an engine
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: gust
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               60               45          0             0                  5       0    115     115
//   mass_matrix              35               41          0             0                  5       0     86      96
//   bias                     55               67          0             0                  8       0    138     162
//   inverse_dynamics         79               89          0             0                  8       0    184     211
//   forward_dynamics        120              159          4             0                  8       0    299     330
//   energy                   66              105          0             0                  8       0    187     199
//   linearisation           471              594          4             0                  8       0   1085    1329
//
// Not computed because this mechanism does not need it:
//   kinematics: of 228 results 120 vanish identically, 28 repeat another up to sign
//   mass_matrix: of 36 results 6 vanish identically, 12 repeat another up to sign
//   first_integrals: left out, 'gust_1', 'friction_1', 'gust_2', 'friction_2', 'gust_3', 'friction_3', 'gust_4', 'friction_4', 'pylon_friction' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 258 results 108 vanish identically, 12 repeat another up to sign
//
// To write this file again:
//   elastic_wing_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output elastic_wing.hpp
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

namespace elastic_wing {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "elastic_wing";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x08698e183d092658ULL;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar gust;  ///< parameter [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::gust};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar z;  ///< coordinate [m]
    Scalar beta_1;  ///< coordinate [rad or 1]
    Scalar beta_2;  ///< coordinate [rad or 1]
    Scalar beta_3;  ///< coordinate [rad or 1]
    Scalar beta_4;  ///< coordinate [rad or 1]
    Scalar gamma;  ///< coordinate [rad or 1]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::z, &Coordinates::beta_1, &Coordinates::beta_2,
          &Coordinates::beta_3, &Coordinates::beta_4, &Coordinates::gamma};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar z;  ///< its rate [m/s]
    Scalar beta_1;  ///< its rate [rad/s]
    Scalar beta_2;  ///< its rate [rad/s]
    Scalar beta_3;  ///< its rate [rad/s]
    Scalar beta_4;  ///< its rate [rad/s]
    Scalar gamma;  ///< its rate [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::z, &Velocities::beta_1, &Velocities::beta_2,
          &Velocities::beta_3, &Velocities::beta_4, &Velocities::gamma};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar z;  ///< its second rate [m/s^2]
    Scalar beta_1;  ///< its second rate [rad/s^2]
    Scalar beta_2;  ///< its second rate [rad/s^2]
    Scalar beta_3;  ///< its second rate [rad/s^2]
    Scalar beta_4;  ///< its second rate [rad/s^2]
    Scalar gamma;  ///< its second rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::z, &Accelerations::beta_1, &Accelerations::beta_2,
          &Accelerations::beta_3, &Accelerations::beta_4, &Accelerations::gamma};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar z;  ///< works with the rate of z [N]
    Scalar beta_1;  ///< works with the rate of beta_1 [N m]
    Scalar beta_2;  ///< works with the rate of beta_2 [N m]
    Scalar beta_3;  ///< works with the rate of beta_3 [N m]
    Scalar beta_4;  ///< works with the rate of beta_4 [N m]
    Scalar gamma;  ///< works with the rate of gamma [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::z, &GeneralizedForces::beta_1,
          &GeneralizedForces::beta_2, &GeneralizedForces::beta_3, &GeneralizedForces::beta_4,
          &GeneralizedForces::gamma};
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
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    parameters.gust = n10000;
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
    state.time = n0;
    state.q.z = n0;
    state.q.beta_1 = n0;
    state.q.beta_2 = n0;
    state.q.beta_3 = n0;
    state.q.beta_4 = n0;
    state.q.gamma = n0;
    state.v.z = n0;
    state.v.beta_1 = n0;
    state.v.beta_2 = n0;
    state.v.beta_3 = n0;
    state.v.beta_4 = n0;
    state.v.gamma = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> fuselage_position;  ///< centre of mass of fuselage [m]
    std::array<Scalar, 9> fuselage_rotation;  ///< from the axes of fuselage to the ground's (3 x 3)
    std::array<Scalar, 3> fuselage_velocity;  ///< velocity of the centre of mass of fuselage [m/s]
    std::array<Scalar, 3> fuselage_angular_velocity;  ///< angular velocity of fuselage [rad/s]
    std::array<Scalar, 3> panel_1_position;  ///< centre of mass of panel_1 [m]
    std::array<Scalar, 9> panel_1_rotation;  ///< from the axes of panel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_1_velocity;  ///< velocity of the centre of mass of panel_1 [m/s]
    std::array<Scalar, 3> panel_1_angular_velocity;  ///< angular velocity of panel_1 [rad/s]
    std::array<Scalar, 3> panel_2_position;  ///< centre of mass of panel_2 [m]
    std::array<Scalar, 9> panel_2_rotation;  ///< from the axes of panel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_2_velocity;  ///< velocity of the centre of mass of panel_2 [m/s]
    std::array<Scalar, 3> panel_2_angular_velocity;  ///< angular velocity of panel_2 [rad/s]
    std::array<Scalar, 3> panel_3_position;  ///< centre of mass of panel_3 [m]
    std::array<Scalar, 9> panel_3_rotation;  ///< from the axes of panel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_3_velocity;  ///< velocity of the centre of mass of panel_3 [m/s]
    std::array<Scalar, 3> panel_3_angular_velocity;  ///< angular velocity of panel_3 [rad/s]
    std::array<Scalar, 3> panel_4_position;  ///< centre of mass of panel_4 [m]
    std::array<Scalar, 9> panel_4_rotation;  ///< from the axes of panel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_4_velocity;  ///< velocity of the centre of mass of panel_4 [m/s]
    std::array<Scalar, 3> panel_4_angular_velocity;  ///< angular velocity of panel_4 [rad/s]
    std::array<Scalar, 3> engine_position;  ///< centre of mass of engine [m]
    std::array<Scalar, 9> engine_rotation;  ///< from the axes of engine to the ground's (3 x 3)
    std::array<Scalar, 3> engine_velocity;  ///< velocity of the centre of mass of engine [m/s]
    std::array<Scalar, 3> engine_angular_velocity;  ///< angular velocity of engine [rad/s]
    std::array<Scalar, 3> middle_1_position;  ///< position of middle_1 [m]
    std::array<Scalar, 3> middle_1_velocity;  ///< velocity of the material point at middle_1 [m/s]
    std::array<Scalar, 18> middle_1_jacobian;  ///< partial velocities of middle_1 (3 x 6)
    std::array<Scalar, 3> middle_2_position;  ///< position of middle_2 [m]
    std::array<Scalar, 3> middle_2_velocity;  ///< velocity of the material point at middle_2 [m/s]
    std::array<Scalar, 18> middle_2_jacobian;  ///< partial velocities of middle_2 (3 x 6)
    std::array<Scalar, 3> middle_3_position;  ///< position of middle_3 [m]
    std::array<Scalar, 3> middle_3_velocity;  ///< velocity of the material point at middle_3 [m/s]
    std::array<Scalar, 18> middle_3_jacobian;  ///< partial velocities of middle_3 (3 x 6)
    std::array<Scalar, 3> middle_4_position;  ///< position of middle_4 [m]
    std::array<Scalar, 3> middle_4_velocity;  ///< velocity of the material point at middle_4 [m/s]
    std::array<Scalar, 18> middle_4_jacobian;  ///< partial velocities of middle_4 (3 x 6)
    std::array<Scalar, 3> tip_position;  ///< position of tip [m]
    std::array<Scalar, 3> tip_velocity;  ///< velocity of the material point at tip [m/s]
    std::array<Scalar, 18> tip_jacobian;  ///< partial velocities of tip (3 x 6)
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

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 36> M;  ///< mass matrix (6 x 6)
    std::array<Scalar, 36> C;  ///< damping and gyroscopic terms (6 x 6)
    std::array<Scalar, 36> K;  ///< stiffness (6 x 6)
    std::array<Scalar, 6> F;  ///< right-hand side
    std::array<Scalar, 144> A;  ///< state matrix of x = (e, e'): x' = A x + B du (12 x 12)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar z28 = q_beta_1 + q_beta_2;
    const Scalar z38 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z49 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar z60 = q_beta_1 + q_gamma;
    const Scalar angles_[] = {q_beta_1, z28, z38, z49, z60};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar z29 = sines_[1], z30 = cosines_[1];
    const Scalar z39 = sines_[2], z40 = cosines_[2];
    const Scalar z50 = sines_[3], z51 = cosines_[3];
    const Scalar z61 = sines_[4], z62 = cosines_[4];
    const Scalar z34 = n4 * v_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z32 = n4 * s_beta_1;
    const Scalar z31 = n4 * c_beta_1;
    const Scalar z41 = n4 * z30;
    const Scalar z42 = n4 * z29;
    const Scalar z36 = s_beta_1 * z34;  // velocity of panel_2, y
    const Scalar z37 = v_z + c_beta_1 * z34;  // velocity of panel_2, z
    const Scalar z45 = n4 * z35;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z52 = n4 * z40;
    const Scalar z53 = n4 * z39;
    const Scalar z84 = n2 * z51;
    const Scalar z85 = n2 * z50;
    const Scalar z56 = n4 * z46;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z77 = n2 * z40;
    const Scalar z78 = n2 * z39;
    const Scalar z67 = n2 * v_beta_1;
    const Scalar z74 = n2 * z35;
    const Scalar z81 = n2 * z46;
    const Scalar z88 = n2 * z57;
    const Scalar z95 = n1_2 * z63;
    const Scalar z64 = n2 * c_beta_1;
    const Scalar z68 = s_beta_1 * z67;
    const Scalar z69 = v_z + c_beta_1 * z67;
    const Scalar z65 = n2 * s_beta_1;
    const Scalar z70 = n2 * z30;
    const Scalar z71 = n2 * z29;
    const Scalar z91 = n1_2 * z61;
    const Scalar z92 = n1_2 * z62;
    const Scalar z33 = q_z + z32;  // place of panel_2, z
    const Scalar z47 = z29 * z45 + z36;  // velocity of panel_3, y
    const Scalar z66 = q_z + z65;
    const Scalar z75 = z29 * z74 + z36;
    const Scalar z96 = z36 - z62 * z95;
    const Scalar z48 = z30 * z45 + z37;  // velocity of panel_3, z
    const Scalar z76 = z30 * z74 + z37;
    const Scalar z97 = z37 + z61 * z95;
    const Scalar z43 = z31 + z41;  // place of panel_3, y
    const Scalar z112 = n4 * z51;
    const Scalar z44 = z33 + z42;  // place of panel_3, z
    const Scalar z114 = n4 * z57;
    const Scalar z113 = n4 * z50;
    const Scalar z72 = z31 + z70;
    const Scalar z73 = z33 + z71;
    const Scalar z93 = z31 + z91;
    const Scalar z94 = z33 - z92;
    const Scalar z98 = z32 + z71;
    const Scalar z58 = z39 * z56 + z47;  // velocity of panel_4, y
    const Scalar z82 = z39 * z81 + z47;
    const Scalar z59 = z40 * z56 + z48;  // velocity of panel_4, z
    const Scalar z83 = z40 * z81 + z48;
    const Scalar z54 = z43 + z52;  // place of panel_4, y
    const Scalar z55 = z44 + z53;  // place of panel_4, z
    const Scalar z79 = z43 + z77;
    const Scalar z80 = z44 + z78;
    const Scalar z100 = z41 + z77;
    const Scalar z101 = z42 + z78;
    const Scalar z89 = z50 * z88 + z58;
    const Scalar z115 = z50 * z114 + z58;
    const Scalar z86 = z54 + z84;
    const Scalar z87 = z55 + z85;
    const Scalar z90 = z51 * z88 + z59;
    const Scalar z102 = z31 + z100;
    const Scalar z103 = z32 + z101;
    const Scalar z105 = z52 + z84;
    const Scalar z106 = z53 + z85;
    const Scalar z116 = z51 * z114 + z59;
    const Scalar z117 = z54 + z112;
    const Scalar z118 = z55 + z113;
    const Scalar z119 = z52 + z112;
    const Scalar z120 = z53 + z113;
    const Scalar z107 = z41 + z105;
    const Scalar z108 = z42 + z106;
    const Scalar z121 = z41 + z119;
    const Scalar z122 = z42 + z120;
    const Scalar z109 = z31 + z107;
    const Scalar z110 = z32 + z108;
    const Scalar z123 = z31 + z121;
    const Scalar z124 = z32 + z122;
    result.fuselage_position[0] = n0;
    result.fuselage_position[1] = n0;
    result.fuselage_position[2] = q_z;
    result.fuselage_rotation[0] = n1;
    result.fuselage_rotation[1] = n0;
    result.fuselage_rotation[2] = n0;
    result.fuselage_rotation[3] = n0;
    result.fuselage_rotation[4] = n1;
    result.fuselage_rotation[5] = n0;
    result.fuselage_rotation[6] = n0;
    result.fuselage_rotation[7] = n0;
    result.fuselage_rotation[8] = n1;
    result.fuselage_velocity[0] = n0;
    result.fuselage_velocity[1] = n0;
    result.fuselage_velocity[2] = v_z;
    result.fuselage_angular_velocity[0] = n0;
    result.fuselage_angular_velocity[1] = n0;
    result.fuselage_angular_velocity[2] = n0;
    result.panel_1_position[0] = n0;
    result.panel_1_position[1] = z64;
    result.panel_1_position[2] = z66;
    result.panel_1_rotation[0] = n1;
    result.panel_1_rotation[1] = n0;
    result.panel_1_rotation[2] = n0;
    result.panel_1_rotation[3] = n0;
    result.panel_1_rotation[4] = c_beta_1;
    result.panel_1_rotation[5] = s_beta_1;
    result.panel_1_rotation[6] = n0;
    result.panel_1_rotation[7] = -s_beta_1;
    result.panel_1_rotation[8] = c_beta_1;
    result.panel_1_velocity[0] = n0;
    result.panel_1_velocity[1] = -z68;
    result.panel_1_velocity[2] = z69;
    result.panel_1_angular_velocity[0] = v_beta_1;
    result.panel_1_angular_velocity[1] = n0;
    result.panel_1_angular_velocity[2] = n0;
    result.panel_2_position[0] = n0;
    result.panel_2_position[1] = z72;
    result.panel_2_position[2] = z73;
    result.panel_2_rotation[0] = n1;
    result.panel_2_rotation[1] = n0;
    result.panel_2_rotation[2] = n0;
    result.panel_2_rotation[3] = n0;
    result.panel_2_rotation[4] = z30;
    result.panel_2_rotation[5] = z29;
    result.panel_2_rotation[6] = n0;
    result.panel_2_rotation[7] = -z29;
    result.panel_2_rotation[8] = z30;
    result.panel_2_velocity[0] = n0;
    result.panel_2_velocity[1] = -z75;
    result.panel_2_velocity[2] = z76;
    result.panel_2_angular_velocity[0] = z35;
    result.panel_2_angular_velocity[1] = n0;
    result.panel_2_angular_velocity[2] = n0;
    result.panel_3_position[0] = n0;
    result.panel_3_position[1] = z79;
    result.panel_3_position[2] = z80;
    result.panel_3_rotation[0] = n1;
    result.panel_3_rotation[1] = n0;
    result.panel_3_rotation[2] = n0;
    result.panel_3_rotation[3] = n0;
    result.panel_3_rotation[4] = z40;
    result.panel_3_rotation[5] = z39;
    result.panel_3_rotation[6] = n0;
    result.panel_3_rotation[7] = -z39;
    result.panel_3_rotation[8] = z40;
    result.panel_3_velocity[0] = n0;
    result.panel_3_velocity[1] = -z82;
    result.panel_3_velocity[2] = z83;
    result.panel_3_angular_velocity[0] = z46;
    result.panel_3_angular_velocity[1] = n0;
    result.panel_3_angular_velocity[2] = n0;
    result.panel_4_position[0] = n0;
    result.panel_4_position[1] = z86;
    result.panel_4_position[2] = z87;
    result.panel_4_rotation[0] = n1;
    result.panel_4_rotation[1] = n0;
    result.panel_4_rotation[2] = n0;
    result.panel_4_rotation[3] = n0;
    result.panel_4_rotation[4] = z51;
    result.panel_4_rotation[5] = z50;
    result.panel_4_rotation[6] = n0;
    result.panel_4_rotation[7] = -z50;
    result.panel_4_rotation[8] = z51;
    result.panel_4_velocity[0] = n0;
    result.panel_4_velocity[1] = -z89;
    result.panel_4_velocity[2] = z90;
    result.panel_4_angular_velocity[0] = z57;
    result.panel_4_angular_velocity[1] = n0;
    result.panel_4_angular_velocity[2] = n0;
    result.engine_position[0] = n0;
    result.engine_position[1] = z93;
    result.engine_position[2] = z94;
    result.engine_rotation[0] = n1;
    result.engine_rotation[1] = n0;
    result.engine_rotation[2] = n0;
    result.engine_rotation[3] = n0;
    result.engine_rotation[4] = z62;
    result.engine_rotation[5] = z61;
    result.engine_rotation[6] = n0;
    result.engine_rotation[7] = -z61;
    result.engine_rotation[8] = z62;
    result.engine_velocity[0] = n0;
    result.engine_velocity[1] = -z96;
    result.engine_velocity[2] = z97;
    result.engine_angular_velocity[0] = z63;
    result.engine_angular_velocity[1] = n0;
    result.engine_angular_velocity[2] = n0;
    result.middle_1_position[0] = n0;
    result.middle_1_position[1] = z64;
    result.middle_1_position[2] = z66;
    result.middle_1_velocity[0] = n0;
    result.middle_1_velocity[1] = -z68;
    result.middle_1_velocity[2] = z69;
    result.middle_1_jacobian[0] = n0;
    result.middle_1_jacobian[3] = n0;
    result.middle_1_jacobian[6] = n0;
    result.middle_1_jacobian[9] = n0;
    result.middle_1_jacobian[12] = n0;
    result.middle_1_jacobian[15] = n0;
    result.middle_1_jacobian[1] = n0;
    result.middle_1_jacobian[4] = -z65;
    result.middle_1_jacobian[7] = n0;
    result.middle_1_jacobian[10] = n0;
    result.middle_1_jacobian[13] = n0;
    result.middle_1_jacobian[16] = n0;
    result.middle_1_jacobian[2] = n1;
    result.middle_1_jacobian[5] = z64;
    result.middle_1_jacobian[8] = n0;
    result.middle_1_jacobian[11] = n0;
    result.middle_1_jacobian[14] = n0;
    result.middle_1_jacobian[17] = n0;
    result.middle_2_position[0] = n0;
    result.middle_2_position[1] = z72;
    result.middle_2_position[2] = z73;
    result.middle_2_velocity[0] = n0;
    result.middle_2_velocity[1] = -z75;
    result.middle_2_velocity[2] = z76;
    result.middle_2_jacobian[0] = n0;
    result.middle_2_jacobian[3] = n0;
    result.middle_2_jacobian[6] = n0;
    result.middle_2_jacobian[9] = n0;
    result.middle_2_jacobian[12] = n0;
    result.middle_2_jacobian[15] = n0;
    result.middle_2_jacobian[1] = n0;
    result.middle_2_jacobian[4] = -z98;
    result.middle_2_jacobian[7] = -z71;
    result.middle_2_jacobian[10] = n0;
    result.middle_2_jacobian[13] = n0;
    result.middle_2_jacobian[16] = n0;
    result.middle_2_jacobian[2] = n1;
    result.middle_2_jacobian[5] = z72;
    result.middle_2_jacobian[8] = z70;
    result.middle_2_jacobian[11] = n0;
    result.middle_2_jacobian[14] = n0;
    result.middle_2_jacobian[17] = n0;
    result.middle_3_position[0] = n0;
    result.middle_3_position[1] = z79;
    result.middle_3_position[2] = z80;
    result.middle_3_velocity[0] = n0;
    result.middle_3_velocity[1] = -z82;
    result.middle_3_velocity[2] = z83;
    result.middle_3_jacobian[0] = n0;
    result.middle_3_jacobian[3] = n0;
    result.middle_3_jacobian[6] = n0;
    result.middle_3_jacobian[9] = n0;
    result.middle_3_jacobian[12] = n0;
    result.middle_3_jacobian[15] = n0;
    result.middle_3_jacobian[1] = n0;
    result.middle_3_jacobian[4] = -z103;
    result.middle_3_jacobian[7] = -z101;
    result.middle_3_jacobian[10] = -z78;
    result.middle_3_jacobian[13] = n0;
    result.middle_3_jacobian[16] = n0;
    result.middle_3_jacobian[2] = n1;
    result.middle_3_jacobian[5] = z102;
    result.middle_3_jacobian[8] = z100;
    result.middle_3_jacobian[11] = z77;
    result.middle_3_jacobian[14] = n0;
    result.middle_3_jacobian[17] = n0;
    result.middle_4_position[0] = n0;
    result.middle_4_position[1] = z86;
    result.middle_4_position[2] = z87;
    result.middle_4_velocity[0] = n0;
    result.middle_4_velocity[1] = -z89;
    result.middle_4_velocity[2] = z90;
    result.middle_4_jacobian[0] = n0;
    result.middle_4_jacobian[3] = n0;
    result.middle_4_jacobian[6] = n0;
    result.middle_4_jacobian[9] = n0;
    result.middle_4_jacobian[12] = n0;
    result.middle_4_jacobian[15] = n0;
    result.middle_4_jacobian[1] = n0;
    result.middle_4_jacobian[4] = -z110;
    result.middle_4_jacobian[7] = -z108;
    result.middle_4_jacobian[10] = -z106;
    result.middle_4_jacobian[13] = -z85;
    result.middle_4_jacobian[16] = n0;
    result.middle_4_jacobian[2] = n1;
    result.middle_4_jacobian[5] = z109;
    result.middle_4_jacobian[8] = z107;
    result.middle_4_jacobian[11] = z105;
    result.middle_4_jacobian[14] = z84;
    result.middle_4_jacobian[17] = n0;
    result.tip_position[0] = n0;
    result.tip_position[1] = z117;
    result.tip_position[2] = z118;
    result.tip_velocity[0] = n0;
    result.tip_velocity[1] = -z115;
    result.tip_velocity[2] = z116;
    result.tip_jacobian[0] = n0;
    result.tip_jacobian[3] = n0;
    result.tip_jacobian[6] = n0;
    result.tip_jacobian[9] = n0;
    result.tip_jacobian[12] = n0;
    result.tip_jacobian[15] = n0;
    result.tip_jacobian[1] = n0;
    result.tip_jacobian[4] = -z124;
    result.tip_jacobian[7] = -z122;
    result.tip_jacobian[10] = -z120;
    result.tip_jacobian[13] = -z113;
    result.tip_jacobian[16] = n0;
    result.tip_jacobian[2] = n1;
    result.tip_jacobian[5] = z123;
    result.tip_jacobian[8] = z121;
    result.tip_jacobian[11] = z119;
    result.tip_jacobian[14] = z112;
    result.tip_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 36>& mass) noexcept {
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k6 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar k8 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k11 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z226 = n500 * s_beta_4;
    const Scalar z227 = n500 * c_beta_4;
    const Scalar z219 = n2400 * c_gamma;
    const Scalar z220 = n2400 * s_gamma;
    const Scalar z221 = n3580 + n4 * z220;
    const Scalar z222 = s_beta_1 * z219 + c_beta_1 * z220;
    const Scalar z223 = n3580 + n8 * z220;
    const Scalar z224 = n16600 + z220;
    const Scalar z228 = k6 + n4 * z227;
    const Scalar z229 = c_beta_3 * z226;
    const Scalar z231 = s_beta_3 * z226;
    const Scalar z238 = k6 + n8 * z227;
    const Scalar z239 = n1900 + z227;
    const Scalar z230 = s_beta_3 * z227 + z229;
    const Scalar z232 = c_beta_3 * z227 - z231;
    const Scalar z241 = s_beta_3 * z239 + z229;
    const Scalar z242 = c_beta_3 * z239 - z231;
    const Scalar z225 = k8 + z223;
    const Scalar z240 = n6400 + z238;
    const Scalar z233 = z228 + n4 * z232;
    const Scalar z234 = s_beta_2 * z232 + c_beta_2 * z230;
    const Scalar z235 = s_beta_2 * z230 - c_beta_2 * z232;
    const Scalar z243 = z240 + n4 * z242;
    const Scalar z244 = c_beta_2 * z241;
    const Scalar z246 = s_beta_2 * z241;
    const Scalar z250 = z240 + n8 * z242;
    const Scalar z251 = n4400 + z242;
    const Scalar z245 = s_beta_2 * z242 + z244;
    const Scalar z247 = c_beta_2 * z242 - z246;
    const Scalar z253 = s_beta_2 * z251 + z244;
    const Scalar z254 = c_beta_2 * z251 - z246;
    const Scalar z252 = k11 + z250;
    const Scalar z236 = z233 - n4 * z235;
    const Scalar z237 = s_beta_1 * z234 + c_beta_1 * z235;
    const Scalar z248 = z243 + n4 * z247;
    const Scalar z249 = s_beta_1 * z245 - c_beta_1 * z247;
    const Scalar z255 = z252 + n4 * z254;
    const Scalar z256 = s_beta_1 * z253 - c_beta_1 * z254;
    const Scalar z257 = z252 + n8 * z254;
    const Scalar z258 = z224 + z254;
    const Scalar z259 = z219 - z253;
    const Scalar z261 = s_beta_1 * z259 + c_beta_1 * z258;
    const Scalar z260 = z225 + z257;
    mass[0] = n20500;
    mass[1] = z261;
    mass[2] = -z256;
    mass[3] = -z249;
    mass[4] = -z237;
    mass[5] = z222;
    mass[6] = z261;
    mass[7] = z260;
    mass[8] = z255;
    mass[9] = z248;
    mass[10] = z236;
    mass[11] = z221;
    mass[12] = -z256;
    mass[13] = z255;
    mass[14] = z252;
    mass[15] = z243;
    mass[16] = z233;
    mass[17] = n0;
    mass[18] = -z249;
    mass[19] = z248;
    mass[20] = z243;
    mass[21] = z240;
    mass[22] = z228;
    mass[23] = n0;
    mass[24] = -z237;
    mass[25] = z236;
    mass[26] = z233;
    mass[27] = z228;
    mass[28] = k6;
    mass[29] = n0;
    mass[30] = z222;
    mass[31] = z221;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n3580;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k2 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k4 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k6 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k8 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z28 = q_beta_1 + q_beta_2;
    const Scalar z38 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z49 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z28, z38, z49};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z29 = sines_[5], z30 = cosines_[5];
    const Scalar z39 = sines_[6], z40 = cosines_[6];
    const Scalar z50 = sines_[7], z51 = cosines_[7];
    const Scalar z298 = v_beta_1 * v_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z288 = z50 * p_gust;
    const Scalar z289 = z51 * p_gust;
    const Scalar z284 = z39 * p_gust;
    const Scalar z285 = z40 * p_gust;
    const Scalar z299 = n4 * z298;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z302 = z35 * z35;
    const Scalar z280 = z29 * p_gust;
    const Scalar z281 = z30 * p_gust;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z300 = c_beta_2 * z299;
    const Scalar z301 = s_beta_2 * z299;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z306 = z46 * z46;
    const Scalar z312 = z63 * z63;
    const Scalar z263 = s_beta_1 * p_gust;
    const Scalar z317 = z57 * z57;
    const Scalar z264 = c_beta_1 * p_gust;
    const Scalar z310 = c_gamma * z299;
    const Scalar z313 = n2400 * z312;  // force on engine, z
    const Scalar z278 = k2 * q_beta_1;
    const Scalar z279 = n60000 * v_beta_1;
    const Scalar z315 = s_gamma * z313;
    const Scalar z316 = c_gamma * z313;
    const Scalar z282 = k4 * q_beta_2;
    const Scalar z283 = n28000 * v_beta_2;
    const Scalar z286 = k6 * q_beta_3;
    const Scalar z287 = n12000 * v_beta_3;
    const Scalar z290 = k8 * q_beta_4;
    const Scalar z291 = n5000 * v_beta_4;
    const Scalar z292 = n600000 * q_gamma;
    const Scalar z293 = n1200 * v_gamma;
    const Scalar z294 = n2 * z264;
    const Scalar z303 = z300 + n4 * z302;
    const Scalar z314 = n2400 * z310;  // moment on engine, x
    const Scalar z295 = n2 * z281;
    const Scalar z341 = z292 + z293 - z314;
    const Scalar z304 = s_beta_3 * z301 - c_beta_3 * z303;
    const Scalar z305 = c_beta_3 * z301 + s_beta_3 * z303;
    const Scalar z296 = n2 * z285;
    const Scalar z307 = z304 - n4 * z306;
    const Scalar z297 = n2 * z289;
    const Scalar z318 = z288 + n500 * z317;  // force on panel_4, y
    const Scalar z309 = s_beta_4 * z307 - c_beta_4 * z305;
    const Scalar z320 = s_beta_4 * z289 - c_beta_4 * z318;
    const Scalar z321 = c_beta_4 * z289 + s_beta_4 * z318;
    const Scalar z322 = z284 + n1900 * z306 - z320;  // force on panel_3, y
    const Scalar z323 = z285 + z321;  // force on panel_3, z
    const Scalar z319 = z297 + n500 * z309;  // moment on panel_4, x
    const Scalar z325 = s_beta_3 * z323 - c_beta_3 * z322;
    const Scalar z326 = s_beta_3 * z322 + c_beta_3 * z323;
    const Scalar z324 = z296 - n1900 * z305 + n4 * z321 + z319;  // moment on panel_3, x
    const Scalar z340 = z290 + z291 - z319;
    const Scalar z339 = z286 + z287 - z324;
    const Scalar z327 = z280 + n4400 * z302 - z325;  // force on panel_2, y
    const Scalar z328 = z281 + z326;  // force on panel_2, z
    const Scalar z329 = z295 - n4400 * z301 + z324 + n4 * z326;  // moment on panel_2, x
    const Scalar z330 = s_beta_2 * z328 - c_beta_2 * z327;
    const Scalar z331 = s_beta_2 * z327 + c_beta_2 * z328;
    const Scalar z338 = z282 + z283 - z329;
    const Scalar z332 = z263 + n16600 * z298 + z315 - z330;  // force on panel_1, y
    const Scalar z333 = z264 - z316 + z331;  // force on panel_1, z
    const Scalar z334 = z294 + z314 + z329 - n4 * (z316 - z331);  // moment on panel_1, x
    const Scalar z336 = s_beta_1 * z332 + c_beta_1 * z333;
    const Scalar z337 = z278 + z279 - z334;
    forces.z = -z336;
    forces.beta_1 = z337;
    forces.beta_2 = z338;
    forces.beta_3 = z339;
    forces.beta_4 = z340;
    forces.gamma = z341;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k1 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k3 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k5 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k7 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k17 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar k19 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k21 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar a_z = accelerations.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar a_beta_3 = accelerations.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar a_beta_4 = accelerations.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z28 = q_beta_1 + q_beta_2;
    const Scalar z38 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z49 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z28, z38, z49};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z29 = sines_[5], z30 = cosines_[5];
    const Scalar z39 = sines_[6], z40 = cosines_[6];
    const Scalar z50 = sines_[7], z51 = cosines_[7];
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z348 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z298 = v_beta_1 * v_beta_1;
    const Scalar z342 = a_z * s_beta_1;
    const Scalar z343 = a_z * c_beta_1;
    const Scalar z289 = z51 * p_gust;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z353 = a_beta_3 + z348;  // angular acceleration of panel_3, x
    const Scalar z288 = z50 * p_gust;
    const Scalar z284 = z39 * p_gust;
    const Scalar z285 = z40 * p_gust;
    const Scalar z302 = z35 * z35;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z358 = a_beta_4 + z353;  // angular acceleration of panel_4, x
    const Scalar z306 = z46 * z46;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z281 = z30 * p_gust;
    const Scalar z280 = z29 * p_gust;
    const Scalar z317 = z57 * z57;
    const Scalar z312 = z63 * z63;
    const Scalar z264 = c_beta_1 * p_gust;
    const Scalar z361 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z313 = n2400 * z312;  // force on engine, z
    const Scalar z263 = s_beta_1 * p_gust;
    const Scalar z362 = n2400 * z361;  // force on engine, y
    const Scalar z278 = k1 * q_beta_1;
    const Scalar z279 = n60000 * v_beta_1;
    const Scalar z282 = k3 * q_beta_2;
    const Scalar z364 = s_gamma * z313 - c_gamma * z362;
    const Scalar z365 = s_gamma * z362 + c_gamma * z313;
    const Scalar z283 = n28000 * v_beta_2;
    const Scalar z286 = k5 * q_beta_3;
    const Scalar z287 = n12000 * v_beta_3;
    const Scalar z290 = k7 * q_beta_4;
    const Scalar z291 = n5000 * v_beta_4;
    const Scalar z292 = n600000 * q_gamma;
    const Scalar z293 = n1200 * v_gamma;
    const Scalar z294 = n2 * z264;
    const Scalar z344 = n4 * z298 - z342;
    const Scalar z345 = n4 * a_beta_1 + z343;
    const Scalar z295 = n2 * z281;
    const Scalar z346 = s_beta_2 * z345 - c_beta_2 * z344;
    const Scalar z347 = s_beta_2 * z344 + c_beta_2 * z345;
    const Scalar z359 = s_gamma * z345 - c_gamma * z344;
    const Scalar z296 = n2 * z285;
    const Scalar z297 = n2 * z289;
    const Scalar z318 = z288 + n500 * z317;  // force on panel_4, y
    const Scalar z366 = z289 - n500 * z358;  // force on panel_4, z
    const Scalar z349 = n4 * z302 - z346;
    const Scalar z350 = z347 + n4 * z348;
    const Scalar z363 = n3580 * z361 + n2400 * z359;  // moment on engine, x
    const Scalar z368 = s_beta_4 * z366 - c_beta_4 * z318;
    const Scalar z369 = s_beta_4 * z318 + c_beta_4 * z366;
    const Scalar z351 = s_beta_3 * z350 - c_beta_3 * z349;
    const Scalar z352 = s_beta_3 * z349 + c_beta_3 * z350;
    const Scalar z390 = z292 + z293 + z363;
    const Scalar z370 = z284 + n1900 * z306 - z368;  // force on panel_3, y
    const Scalar z371 = z285 - n1900 * z353 + z369;  // force on panel_3, z
    const Scalar z354 = n4 * z306 - z351;
    const Scalar z355 = z352 + n4 * z353;
    const Scalar z373 = s_beta_3 * z371 - c_beta_3 * z370;
    const Scalar z374 = s_beta_3 * z370 + c_beta_3 * z371;
    const Scalar z357 = s_beta_4 * z354 + c_beta_4 * z355;
    const Scalar z375 = z280 + n4400 * z302 - z373;  // force on panel_2, y
    const Scalar z376 = z281 - n4400 * z348 + z374;  // force on panel_2, z
    const Scalar z367 = z297 - k17 * z358 - n500 * z357;  // moment on panel_4, x
    const Scalar z378 = s_beta_2 * z376 - c_beta_2 * z375;
    const Scalar z379 = s_beta_2 * z375 + c_beta_2 * z376;
    const Scalar z372 = z296 - n6400 * z353 + n4 * z369 - n1900 * z352 + z367;  // moment on panel_3, x
    const Scalar z389 = z290 + z291 - z367;
    const Scalar z377 = z295 - k19 * z348 - n4400 * z347 + n4 * z374 + z372;  // moment on panel_2, x
    const Scalar z380 = z263 + n16600 * z298 + z364 - z378;  // force on panel_1, y
    const Scalar z381 = n16600 * a_beta_1 - z264 + z365 - z379;  // force on panel_1, z
    const Scalar z388 = z286 + z287 - z372;
    // moment on panel_1, x
    const Scalar z382 = k21 * a_beta_1 - z294 + n16600 * z343 + z363 + n4 * (z365 - z379) - z377;
    const Scalar z384 = s_beta_1 * z380 - c_beta_1 * z381;
    const Scalar z387 = z282 + z283 - z377;
    const Scalar z385 = n20500 * a_z - z384;  // force on fuselage, z
    const Scalar z386 = z278 + z279 + z382;
    forces.z = z385;
    forces.beta_1 = z386;
    forces.beta_2 = z387;
    forces.beta_3 = z388;
    forces.beta_4 = z389;
    forces.gamma = z390;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n187_5 = traits::constant(187.5, 187.5f, "375/2");
    const Scalar k1 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar k4 = traits::constant(1608.9385474860335, 1608.9386f, "288000/179");
    const Scalar k5 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k7 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k12 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar k18 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k21 = traits::constant(0.00027932960893854746, 0.0002793296f, "1/3580");
    const Scalar n120_over_179 = traits::constant(0.6703910614525139, 0.6703911f, "120/179");
    const Scalar k23 = traits::constant(0.00075, 0.00075f, "3/4000");
    const Scalar n0_375 = traits::constant(0.375, 0.375f, "3/8");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k26 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z28 = q_beta_1 + q_beta_2;
    const Scalar z38 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z49 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z28, z38, z49};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z29 = sines_[5], z30 = cosines_[5];
    const Scalar z39 = sines_[6], z40 = cosines_[6];
    const Scalar z50 = sines_[7], z51 = cosines_[7];
    const Scalar z412 = n187_5 * s_beta_4;
    const Scalar z298 = v_beta_1 * v_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z413 = n187_5 * c_beta_4;
    const Scalar z289 = z51 * p_gust;
    const Scalar z290 = k1 * q_beta_4;
    const Scalar z299 = n4 * z298;
    const Scalar z302 = z35 * z35;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z291 = n5000 * v_beta_4;
    const Scalar z288 = z50 * p_gust;
    const Scalar z400 = z290 + z291;
    const Scalar z300 = c_beta_2 * z299;
    const Scalar z301 = s_beta_2 * z299;
    const Scalar z306 = z46 * z46;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z285 = z40 * p_gust;
    const Scalar z402 = k4 * s_gamma;
    const Scalar z317 = z57 * z57;
    const Scalar z284 = z39 * p_gust;
    const Scalar z286 = k5 * q_beta_3;
    const Scalar z287 = n12000 * v_beta_3;
    const Scalar z399 = z286 + z287;
    const Scalar z281 = z30 * p_gust;
    const Scalar z403 = k4 * c_gamma;
    const Scalar z280 = z29 * p_gust;
    const Scalar z282 = k7 * q_beta_2;
    const Scalar z310 = c_gamma * z299;
    const Scalar z283 = n28000 * v_beta_2;
    const Scalar z398 = z282 + z283;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z312 = z63 * z63;
    const Scalar z292 = n600000 * q_gamma;
    const Scalar z293 = n1200 * v_gamma;
    const Scalar z401 = z292 + z293;
    const Scalar z264 = c_beta_1 * p_gust;
    const Scalar z263 = s_beta_1 * p_gust;
    const Scalar z313 = n2400 * z312;  // force on engine, z
    const Scalar z278 = k12 * q_beta_1;
    const Scalar z279 = n60000 * v_beta_1;
    const Scalar z397 = z278 + z279;
    const Scalar z294 = n2 * z264;
    const Scalar z303 = z300 + n4 * z302;
    const Scalar z314 = n2400 * z310;  // moment on engine, x
    const Scalar z404 = c_gamma * z403;
    const Scalar z405 = s_gamma * z402;
    const Scalar z406 = s_gamma * z403;
    const Scalar z414 = c_beta_4 * z413;
    const Scalar z415 = s_beta_4 * z412;
    const Scalar z416 = s_beta_4 * z413;
    const Scalar z295 = n2 * z281;
    const Scalar z407 = n4 * z406;
    const Scalar z408 = n4 * z405;
    const Scalar z417 = n4 * z416;
    const Scalar z418 = n4 * z414;
    const Scalar z304 = s_beta_3 * z301 - c_beta_3 * z303;
    const Scalar z305 = c_beta_3 * z301 + s_beta_3 * z303;
    const Scalar z296 = n2 * z285;
    const Scalar z409 = n4 * z408;
    const Scalar z411 = n16600 - z408;
    const Scalar z419 = n4 * z418;
    const Scalar z421 = n1900 - z418;
    const Scalar z307 = z304 - n4 * z306;
    const Scalar z297 = n2 * z289;
    const Scalar z318 = z288 + n500 * z317;  // force on panel_4, y
    const Scalar z410 = k18 - z409;
    const Scalar z420 = n6400 - z419;
    const Scalar z309 = s_beta_4 * z307 - c_beta_4 * z305;
    const Scalar z422 = n1 / z420;
    const Scalar z319 = z297 + n500 * z309;  // moment on panel_4, x
    const Scalar z479 = z314 - z401;
    const Scalar z480 = k21 * z479;
    const Scalar z481 = n120_over_179 * z479;
    const Scalar z482 = s_gamma * z313 - c_gamma * z481;
    const Scalar z483 = c_gamma * z313 + s_gamma * z481;
    const Scalar z484 = z319 - z400;
    const Scalar z423 = z417 * z422;
    const Scalar z424 = z421 * z422;
    const Scalar z485 = k23 * z484;
    const Scalar z486 = z289 - n0_375 * z484;
    const Scalar z425 = z415 + z417 * z423;
    const Scalar z426 = z416 - z417 * z424;
    const Scalar z427 = z414 + z421 * z424;
    const Scalar z487 = s_beta_4 * z486 - c_beta_4 * z318;
    const Scalar z488 = s_beta_4 * z318 + c_beta_4 * z486;
    const Scalar z428 = z425 - z427;
    const Scalar z429 = n2 * z426;
    const Scalar z490 = z285 + z488;
    const Scalar z491 = z296 - n1900 * z305 + z400 + n4 * z488;
    const Scalar z430 = s_beta_3 * z428 - c_beta_3 * z429;
    const Scalar z489 = z284 + n1900 * z306 - z487;
    const Scalar z492 = z399 - z491;
    const Scalar z493 = z422 * z492;
    const Scalar z494 = z423 * z492 + z489;
    const Scalar z431 = s_beta_3 * z430;
    const Scalar z495 = z424 * z492 + z490;
    const Scalar z434 = c_beta_3 * z430 + z426;
    const Scalar z432 = z425 - z431;
    const Scalar z433 = z427 + z431;
    const Scalar z496 = s_beta_3 * z495 - c_beta_3 * z494;
    const Scalar z497 = s_beta_3 * z494 + c_beta_3 * z495;
    const Scalar z435 = n4 * z434;
    const Scalar z436 = n4 * z433;
    const Scalar z437 = n4 * z436;
    const Scalar z439 = n4400 - z436;
    const Scalar z498 = z280 + n4400 * z302 - z496;
    const Scalar z499 = z281 + z497;
    const Scalar z500 = z295 - n4400 * z301 + z399 + n4 * z497;
    const Scalar z438 = k26 - z437;
    const Scalar z501 = z398 - z500;
    const Scalar z440 = n1 / z438;
    const Scalar z441 = z435 * z440;
    const Scalar z442 = z439 * z440;
    const Scalar z502 = z440 * z501;
    const Scalar z443 = z432 + z435 * z441;
    const Scalar z444 = z434 - z435 * z442;
    const Scalar z445 = z433 + z439 * z442;
    const Scalar z503 = z441 * z501 - z498;
    const Scalar z504 = z442 * z501 + z499;
    const Scalar z446 = z443 - z445;
    const Scalar z447 = n2 * z444;
    const Scalar z505 = s_beta_2 * z504 + c_beta_2 * z503;
    const Scalar z506 = s_beta_2 * z503 - c_beta_2 * z504;
    const Scalar z448 = s_beta_2 * z446 + c_beta_2 * z447;
    const Scalar z507 = z263 + n16600 * z298 + z482 - z505;
    const Scalar z508 = z264 - z483 - z506;
    const Scalar z509 = z398 + z401 + z294 - n4 * (z483 + z506);
    const Scalar z449 = s_beta_2 * z448;
    const Scalar z452 = c_beta_2 * z448 - z444;
    const Scalar z450 = z443 - z449;
    const Scalar z451 = z445 + z449;
    const Scalar z453 = n4 * z452;
    const Scalar z460 = z406 + z452;
    const Scalar z510 = z397 - z509;
    const Scalar z454 = n4 * z451;
    const Scalar z459 = z404 + z450;
    const Scalar z461 = z405 + z451;
    const Scalar z457 = z407 + z453;
    const Scalar z455 = n4 * z454;
    const Scalar z458 = z411 - z454;
    const Scalar z456 = z410 - z455;
    const Scalar z462 = n1 / z456;
    const Scalar z463 = z457 * z462;
    const Scalar z464 = z458 * z462;
    const Scalar z511 = z462 * z510;
    const Scalar z465 = z457 * z463 + z459;
    const Scalar z466 = z457 * z464 - z460;
    const Scalar z467 = z458 * z464 + z461;
    const Scalar z512 = z463 * z510 - z507;
    const Scalar z513 = z464 * z510 + z508;
    const Scalar z468 = z465 - z467;
    const Scalar z469 = n2 * z466;
    const Scalar z515 = s_beta_1 * z512 - c_beta_1 * z513;
    const Scalar z470 = s_beta_1 * z468 - c_beta_1 * z469;
    const Scalar z471 = s_beta_1 * z470;
    const Scalar z473 = z467 + z471;
    const Scalar z476 = n20500 - z473;
    const Scalar z477 = n1 / z476;
    const Scalar z516 = z477 * z515;
    const Scalar z518 = s_beta_1 * z516;
    const Scalar z519 = c_beta_1 * z516;
    const Scalar z520 = z511 + z463 * z518 - z464 * z519;
    const Scalar z521 = z519 + n4 * z520;
    const Scalar z522 = c_beta_2 * z518 + s_beta_2 * z521;
    const Scalar z523 = s_beta_2 * z518 - c_beta_2 * z521;
    const Scalar z536 = c_gamma * z518 + s_gamma * z521;
    const Scalar z524 = z502 + z441 * z522 + z442 * z523;
    const Scalar z538 = z480 + n120_over_179 * z536;
    const Scalar z539 = z520 + z538;
    const Scalar z525 = z520 - z524;
    const Scalar z526 = z523 - n4 * z524;
    const Scalar z527 = s_beta_3 * z526 - c_beta_3 * z522;
    const Scalar z528 = s_beta_3 * z522 + c_beta_3 * z526;
    const Scalar z529 = z493 + z424 * z528 + z423 * z527;
    const Scalar z530 = z524 - z529;
    const Scalar z531 = z528 - n4 * z529;
    const Scalar z533 = s_beta_4 * z527 - c_beta_4 * z531;
    const Scalar z534 = z485 + n0_375 * z533;
    const Scalar z535 = z529 + z534;
    accelerations.z = -z516;
    accelerations.beta_1 = -z520;
    accelerations.beta_2 = z525;
    accelerations.beta_3 = z530;
    accelerations.beta_4 = z535;
    accelerations.gamma = z539;
    if (!(traits::regular(z420, z420) && traits::regular(z438, z438) && traits::regular(z456, z456)
        && traits::regular(z476, z476))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.z * accelerations.beta_1 * accelerations.beta_2 * accelerations.beta_3
        * accelerations.beta_4 * accelerations.gamma;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2600 = traits::constant(2600.0, 2600.0f, "2600/1");
    const Scalar n1300 = traits::constant(1300.0, 1300.0f, "1300/1");
    const Scalar k8 = traits::constant(6933.333333333333, 6933.3335f, "20800/3");
    const Scalar n1600 = traits::constant(1600.0, 1600.0f, "1600/1");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar k11 = traits::constant(4266.666666666667, 4266.6665f, "12800/3");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n2000 = traits::constant(2000.0, 2000.0f, "2000/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n250 = traits::constant(250.0, 250.0f, "250/1");
    const Scalar k19 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n7850 = traits::constant(7850.0, 7850.0f, "7850/1");
    const Scalar n650 = traits::constant(650.0, 650.0f, "650/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar n225 = traits::constant(225.0, 225.0f, "225/1");
    const Scalar n125 = traits::constant(125.0, 125.0f, "125/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k27 = traits::constant(1.5e+07, 1.5e+07f, "15000000/1");
    const Scalar k28 = traits::constant(7e+06, 7e+06f, "7000000/1");
    const Scalar k29 = traits::constant(3e+06, 3e+06f, "3000000/1");
    const Scalar k30 = traits::constant(1250000.0, 1250000.0f, "1250000/1");
    const Scalar n300000 = traits::constant(3e+05, 3e+05f, "300000/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar v_z = state.v.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z28 = q_beta_1 + q_beta_2;
    const Scalar z38 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z49 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z28, z38, z49};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z29 = sines_[5], z30 = cosines_[5];
    const Scalar z39 = sines_[6], z40 = cosines_[6];
    const Scalar z50 = sines_[7], z51 = cosines_[7];
    const Scalar z266 = v_z * c_beta_1;
    const Scalar z265 = v_z * s_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z263 = s_beta_1 * p_gust;
    const Scalar z264 = c_beta_1 * p_gust;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z279 = n60000 * v_beta_1;
    const Scalar z280 = z29 * p_gust;
    const Scalar z281 = z30 * p_gust;
    const Scalar z283 = n28000 * v_beta_2;
    const Scalar z284 = z39 * p_gust;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z285 = z40 * p_gust;
    const Scalar z287 = n12000 * v_beta_3;
    const Scalar z288 = z50 * p_gust;
    const Scalar z289 = z51 * p_gust;
    const Scalar z291 = n5000 * v_beta_4;
    const Scalar z293 = n1200 * v_gamma;
    const Scalar z267 = n4 * v_beta_1 + z266;
    const Scalar z602 = n2600 * v_beta_1 + n1300 * z266;
    const Scalar z603 = k8 * v_beta_1 + n2600 * z266;
    const Scalar z268 = c_beta_2 * z265 + s_beta_2 * z267;
    const Scalar z269 = s_beta_2 * z265 - c_beta_2 * z267;
    const Scalar z276 = c_gamma * z265 + s_gamma * z267;
    const Scalar z277 = s_gamma * z265 - c_gamma * z267;
    const Scalar z270 = n4 * z35 - z269;
    const Scalar z604 = n1600 * z35 - n800 * z269;
    const Scalar z605 = k11 * z35 - n1600 * z269;
    const Scalar z610 = n2400 * z63 + n2000 * z276;
    const Scalar z611 = n3580 * z63 + n2400 * z276;
    const Scalar z271 = c_beta_3 * z268 + s_beta_3 * z270;
    const Scalar z272 = s_beta_3 * z268 - c_beta_3 * z270;
    const Scalar z273 = n4 * z46 - z272;
    const Scalar z606 = n900 * z46 - n450 * z272;
    const Scalar z607 = n2400 * z46 - n900 * z272;
    const Scalar z274 = c_beta_4 * z271 + s_beta_4 * z273;
    const Scalar z275 = s_beta_4 * z271 - c_beta_4 * z273;
    const Scalar z608 = n500 * z57 - n250 * z275;
    const Scalar z609 = k19 * z57 - n500 * z275;
    result.kinetic = n7850 * v_z * v_z + n650 * z265 * z265 + n400 * z268 * z268 + n1000 * z277 * z277 + n225 * z271
        * z271 + n125 * z274 * z274 + n0_5 * (v_beta_1 * z603 + z266 * z602 + z35 * z605 + z63 * z611 - z269 * z604
        + z276 * z610 + z46 * z607 - z272 * z606 + z57 * z609 - z275 * z608);
    result.force_function = -k27 * q_beta_1 * q_beta_1 - k28 * q_beta_2 * q_beta_2 - k29 * q_beta_3 * q_beta_3 - k30
        * q_beta_4 * q_beta_4 - n300000 * q_gamma * q_gamma;
    result.power = z263 * z265 - v_beta_1 * z279 - v_beta_2 * z283 - v_beta_3 * z287 - v_beta_4 * z291 - v_gamma * z293
        + z264 * z266 + z268 * z280 - z269 * z281 + n2 * (v_beta_1 * z264 + z35 * z281 + z46 * z285 + z57 * z289) + z271
        * z284 - z272 * z285 + z274 * z288 - z275 * z289;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k3 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k5 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k7 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k9 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k17 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar k19 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k22 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar k23 = traits::constant(0.00075, 0.00075f, "3/4000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k25 = traits::constant(0.00027932960893854746, 0.0002793296f, "1/3580");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar n3_75 = traits::constant(3.75, 3.75f, "15/4");
    const Scalar n60_over_179 = traits::constant(0.33519553072625696, 0.33519554f, "60/179");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_z = accelerations.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar a_beta_3 = accelerations.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar a_beta_4 = accelerations.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z932 = q_beta_1 + q_beta_2;
    const Scalar z936 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z940 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z932, z936, z940};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z933 = sines_[5], z934 = cosines_[5];
    const Scalar z937 = sines_[6], z938 = cosines_[6];
    const Scalar z941 = sines_[7], z942 = cosines_[7];
    const Scalar z957 = n500 * c_beta_4;
    const Scalar z956 = n500 * s_beta_4;
    const Scalar z935 = v_beta_1 + v_beta_2;
    const Scalar z945 = n2 * v_beta_1;
    const Scalar z950 = n2400 * s_gamma;
    const Scalar z1001 = p_gust * z938;
    const Scalar z939 = v_beta_3 + z935;
    const Scalar z946 = n2 * z935;
    const Scalar z1000 = p_gust * z937;
    const Scalar z996 = p_gust * z933;
    const Scalar z944 = v_beta_1 + v_gamma;
    const Scalar z949 = n2400 * c_gamma;
    const Scalar z943 = v_beta_4 + z939;
    const Scalar z1004 = p_gust * z941;
    const Scalar z1005 = p_gust * z942;
    const Scalar z947 = n2 * z939;
    const Scalar z997 = p_gust * z934;
    const Scalar z993 = c_beta_1 * p_gust;
    const Scalar z948 = n2 * z943;
    const Scalar z992 = s_beta_1 * p_gust;
    const Scalar z994 = k3 * q_beta_1;
    const Scalar z995 = n60000 * v_beta_1;
    const Scalar z998 = k5 * q_beta_2;
    const Scalar z999 = n28000 * v_beta_2;
    const Scalar z1002 = k7 * q_beta_3;
    const Scalar z1003 = n12000 * v_beta_3;
    const Scalar z1006 = k9 * q_beta_4;
    const Scalar z1007 = n5000 * v_beta_4;
    const Scalar z1008 = n600000 * q_gamma;
    const Scalar z1009 = n1200 * v_gamma;
    const Scalar z951 = n3580 + n4 * z950;
    const Scalar z952 = s_beta_1 * z949 + c_beta_1 * z950;
    const Scalar z953 = n3580 + n8 * z950;
    const Scalar z954 = n16600 + z950;
    const Scalar z1014 = v_beta_1 * v_beta_1;
    const Scalar z958 = k17 + n4 * z957;
    const Scalar z959 = c_beta_3 * z956;
    const Scalar z961 = s_beta_3 * z956;
    const Scalar z968 = k17 + n8 * z957;
    const Scalar z969 = n1900 + z957;
    const Scalar z1010 = n2 * z993;
    const Scalar z960 = s_beta_3 * z957 + z959;
    const Scalar z962 = c_beta_3 * z957 - z961;
    const Scalar z971 = s_beta_3 * z969 + z959;
    const Scalar z972 = c_beta_3 * z969 - z961;
    const Scalar z1011 = n2 * z997;
    const Scalar z955 = k19 + z953;
    const Scalar z1019 = z943 * z943;
    const Scalar z1015 = z935 * z935;
    const Scalar z1016 = z939 * z939;
    const Scalar z1022 = a_z * c_beta_1;
    const Scalar z1021 = a_z * s_beta_1;
    const Scalar z1017 = z944 * z944;
    const Scalar z1018 = n2400 * z1017;  // force on engine, z
    const Scalar z970 = n6400 + z968;
    const Scalar z1012 = n2 * z1001;
    const Scalar z963 = z958 + n4 * z962;
    const Scalar z1023 = n4 * z1014 - z1021;
    const Scalar z964 = s_beta_2 * z962 + c_beta_2 * z960;
    const Scalar z1024 = n4 * a_beta_1 + z1022;
    const Scalar z965 = s_beta_2 * z960 - c_beta_2 * z962;
    const Scalar z1025 = s_beta_2 * z1024 - c_beta_2 * z1023;
    const Scalar z973 = z970 + n4 * z972;
    const Scalar z974 = c_beta_2 * z971;
    const Scalar z976 = s_beta_2 * z971;
    const Scalar z980 = z970 + n8 * z972;
    const Scalar z981 = n4400 + z972;
    const Scalar z1013 = n2 * z1005;
    const Scalar z1020 = z1004 + n500 * z1019;  // force on panel_4, y
    const Scalar z975 = s_beta_2 * z972 + z974;
    const Scalar z977 = c_beta_2 * z972 - z976;
    const Scalar z983 = s_beta_2 * z981 + z974;
    const Scalar z984 = c_beta_2 * z981 - z976;
    const Scalar z982 = k22 + z980;
    const Scalar z966 = z963 - n4 * z965;
    const Scalar z1026 = s_beta_2 * z1023 + c_beta_2 * z1024;
    const Scalar z967 = s_beta_1 * z964 + c_beta_1 * z965;
    const Scalar z1027 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z1032 = a_beta_3 + z1027;  // angular acceleration of panel_3, x
    const Scalar z1028 = n4 * z1015 - z1025;
    const Scalar z1029 = z1026 + n4 * z1027;
    const Scalar z1037 = a_beta_4 + z1032;  // angular acceleration of panel_4, x
    const Scalar z978 = z973 + n4 * z977;
    const Scalar z1038 = s_gamma * z1024 - c_gamma * z1023;
    const Scalar z979 = s_beta_1 * z975 - c_beta_1 * z977;
    const Scalar z1039 = s_gamma * z1023 + c_gamma * z1024;
    const Scalar z989 = z949 - z983;
    const Scalar z988 = z954 + z984;
    const Scalar z991 = s_beta_1 * z989 + c_beta_1 * z988;
    const Scalar z986 = s_beta_1 * z983 - c_beta_1 * z984;
    const Scalar z987 = z982 + n8 * z984;
    const Scalar z990 = z955 + z987;
    const Scalar z985 = z982 + n4 * z984;
    const Scalar z1077 = k23 * z958;
    const Scalar z1087 = z958 * z1077 - z970;
    const Scalar z1086 = z963 * z1077 - z973;
    const Scalar z1085 = z966 * z1077 - z978;
    const Scalar z1084 = z967 * z1077 - z979;
    const Scalar z1088 = n1 / z1087;
    const Scalar z1076 = k23 * z963;
    const Scalar z1083 = z963 * z1076 - z982;
    const Scalar z1082 = z966 * z1076 - z985;
    const Scalar z1081 = z967 * z1076 - z986;
    const Scalar z1045 = z1005 - n500 * z1037;  // force on panel_4, z
    const Scalar z1048 = s_beta_4 * z1020 + c_beta_4 * z1045;
    const Scalar z1047 = s_beta_4 * z1045 - c_beta_4 * z1020;
    const Scalar z1070 = k25 * z951;
    const Scalar z1073 = z951 * z1070 - z990;
    const Scalar z1072 = z952 * z1070 - z991;
    const Scalar z1050 = z1001 - n1900 * z1032 + z1048;  // force on panel_3, z
    const Scalar z1049 = z1000 + n1900 * z1016 - z1047;  // force on panel_3, y
    const Scalar z1040 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z1042 = n3580 * z1040 + n2400 * z1038;  // moment on engine, x
    const Scalar z1041 = n2400 * z1040;  // force on engine, y
    const Scalar z1075 = k23 * z966;
    const Scalar z1080 = z966 * z1075 + z1073;
    const Scalar z1079 = z967 * z1075 - z1072;
    const Scalar z1031 = s_beta_3 * z1028 + c_beta_3 * z1029;
    const Scalar z1030 = s_beta_3 * z1029 - c_beta_3 * z1028;
    const Scalar z1068 = z1008 + z1009 + z1042;
    const Scalar z1033 = n4 * z1016 - z1030;
    const Scalar z1091 = z1086 * z1088;
    const Scalar z1052 = s_beta_3 * z1050 - c_beta_3 * z1049;
    const Scalar z1054 = z996 + n4400 * z1015 - z1052;  // force on panel_2, y
    const Scalar z1090 = z1085 * z1088;
    const Scalar z1093 = z1079 - z1084 * z1090;
    const Scalar z1053 = s_beta_3 * z1049 + c_beta_3 * z1050;
    const Scalar z1034 = z1031 + n4 * z1032;
    const Scalar z1094 = z1080 - z1085 * z1090;
    const Scalar z1055 = z997 - n4400 * z1027 + z1053;  // force on panel_2, z
    const Scalar z1044 = s_gamma * z1041 + c_gamma * z1018;
    const Scalar z1043 = s_gamma * z1018 - c_gamma * z1041;
    const Scalar z1058 = s_beta_2 * z1054 + c_beta_2 * z1055;
    const Scalar z1069 = k25 * z952;
    const Scalar z1071 = n20500 - z952 * z1069;
    const Scalar z1035 = s_beta_4 * z1034 - c_beta_4 * z1033;
    const Scalar z1036 = s_beta_4 * z1033 + c_beta_4 * z1034;
    const Scalar z1046 = z1013 - k17 * z1037 - n500 * z1036;  // moment on panel_4, x
    const Scalar z1097 = z1083 - z1086 * z1091;
    const Scalar z1096 = z1082 - z1085 * z1091;
    const Scalar z1051 = z1012 - n6400 * z1032 + n4 * z1048 - n1900 * z1031 + z1046;  // moment on panel_3, x
    const Scalar z1067 = z1006 + z1007 - z1046;
    const Scalar z1056 = z1011 - k22 * z1027 - n4400 * z1026 + n4 * z1053 + z1051;  // moment on panel_2, x
    const Scalar z1066 = z1002 + z1003 - z1051;
    const Scalar z1065 = z998 + z999 - z1056;
    // moment on panel_1, x
    const Scalar z1061 = k19 * a_beta_1 - z1010 + n16600 * z1022 + z1042 + n4 * (z1044 - z1058) - z1056;
    const Scalar z1064 = z994 + z995 + z1061;
    const Scalar z1111 = n500 * z948;
    const Scalar z1098 = n1 / z1097;
    const Scalar z1108 = n2 * z944;
    const Scalar z1109 = n2400 * z1108;
    const Scalar z1060 = n16600 * a_beta_1 - z993 + z1044 - z1058;  // force on panel_1, z
    const Scalar z1095 = z1081 - z1084 * z1091;
    const Scalar z1112 = c_beta_4 * z1111;
    const Scalar z1114 = s_beta_4 * z1111;
    const Scalar z1113 = n1900 * z947 + z1112;
    const Scalar z1115 = c_beta_3 * z1114;
    const Scalar z1100 = z1096 * z1098;
    const Scalar z1103 = z1094 - z1096 * z1100;
    const Scalar z1102 = z1093 - z1095 * z1100;
    const Scalar z1116 = s_beta_3 * z1113 + z1115;
    const Scalar z1110 = s_gamma * z1109;
    const Scalar z1057 = s_beta_2 * z1055 - c_beta_2 * z1054;
    const Scalar z1059 = z992 + n16600 * z1014 + z1043 - z1057;  // force on panel_1, y
    const Scalar z1104 = n1 / z1103;
    const Scalar z1117 = s_beta_3 * z1114;
    const Scalar z1118 = c_beta_3 * z1113 - z1117;
    const Scalar z1120 = s_beta_2 * z1116;
    const Scalar z1074 = k23 * z967;
    const Scalar z1078 = z967 * z1074 - z1071;
    const Scalar z1089 = z1084 * z1088;
    const Scalar z1099 = z1095 * z1098;
    const Scalar z1119 = n4400 * z946 + z1118;
    const Scalar z1062 = s_beta_1 * z1059 - c_beta_1 * z1060;
    const Scalar z1092 = z1078 - z1084 * z1089;
    const Scalar z1063 = n20500 * a_z - z1062;  // force on fuselage, z
    const Scalar z1146 = n4 * z946;
    const Scalar z1150 = n4 * z947;
    const Scalar z1154 = n4 * z1114;
    const Scalar z1101 = z1092 - z1095 * z1099;
    const Scalar z1123 = c_gamma * z1109;
    const Scalar z1141 = n4 * z945;
    const Scalar z1144 = s_beta_2 * z1141;
    const Scalar z1145 = c_beta_2 * z1141;
    const Scalar z1142 = c_gamma * z1141;
    const Scalar z1128 = s_beta_4 * z1004 + c_beta_4 * z1005;
    const Scalar z1129 = z1001 + z1128;
    const Scalar z1147 = z1145 + z1146;
    const Scalar z1143 = n2400 * z1142;
    const Scalar z1130 = s_beta_4 * z1005 - c_beta_4 * z1004;
    const Scalar z1131 = z1000 - z1130;
    const Scalar z1164 = n2 * z1000;
    const Scalar z1149 = s_beta_3 * z1144 - c_beta_3 * z1147;
    const Scalar z1148 = c_beta_3 * z1144 + s_beta_3 * z1147;
    const Scalar z1151 = z1149 - z1150;
    const Scalar z1163 = s_beta_2 * z1022 + c_beta_2 * z1021;
    const Scalar z1132 = s_beta_3 * z1129 - c_beta_3 * z1131;
    const Scalar z1152 = s_beta_4 * z1151 - c_beta_4 * z1148;
    const Scalar z1133 = z996 - z1132;
    const Scalar z1162 = n2 * z996;
    const Scalar z1134 = s_beta_3 * z1131 + c_beta_3 * z1129;
    const Scalar z1135 = z997 + z1134;
    const Scalar z1124 = c_beta_2 * z1116;
    const Scalar z1125 = s_beta_2 * z1119 + z1124;
    const Scalar z1121 = c_beta_2 * z1119 - z1120;
    const Scalar z1153 = n500 * z1152;
    const Scalar z1122 = n16600 * z945 + z1110 + z1121;
    const Scalar z1136 = s_beta_2 * z1133 + c_beta_2 * z1135;
    const Scalar z1155 = n1900 * z1148 - z1154 - z1153;
    const Scalar z1137 = z993 + z1136;
    const Scalar z1156 = n4 * z1116 - z1155 - n4400 * z1144;
    const Scalar z1138 = s_beta_2 * z1135 - c_beta_2 * z1133;
    const Scalar z1159 = n2 * z992;
    const Scalar z1139 = z992 - z1138;
    const Scalar z1160 = s_gamma * z1021 - c_gamma * z1022;
    const Scalar z1161 = n2400 * z1160;
    const Scalar z1140 = s_beta_1 * (z1060 + z1137) + c_beta_1 * (z1059 - z1139);
    const Scalar z1126 = z1123 - z1125;
    const Scalar z1127 = s_beta_1 * z1122 - c_beta_1 * z1126;
    const Scalar z1157 = n4 * (z1123 - z1125) - z1143 - z1156;
    const Scalar z1158 = n60000 + z1157;
    const Scalar z1105 = z1102 * z1104;
    const Scalar z1106 = z1101 - z1102 * z1105;
    const Scalar z1165 = s_beta_2 * z1021 - c_beta_2 * z1022;
    const Scalar z1166 = s_beta_3 * z1165 - c_beta_3 * z1163;
    const Scalar z1107 = n1 / z1106;
    const Scalar z1168 = s_beta_3 * z1163 + c_beta_3 * z1165;
    const Scalar z1209 = s_beta_4 * z1031 + c_beta_4 * z1030;
    const Scalar z1216 = s_beta_3 * z1112 + z1115;
    const Scalar z1217 = c_beta_3 * z1112 - z1117;
    const Scalar z1169 = s_beta_4 * z1168 + c_beta_4 * z1166;
    const Scalar z1196 = c_beta_2 * z1118 - z1120;
    const Scalar z1197 = s_beta_2 * z1118 + z1124;
    const Scalar z1175 = s_beta_1 * z1121 + c_beta_1 * z1125;
    const Scalar z1198 = s_beta_1 * z1196 + c_beta_1 * z1197;
    const Scalar z1179 = s_beta_3 * z1146;
    const Scalar z1180 = c_beta_3 * z1146;
    const Scalar z1181 = z1150 + z1180;
    const Scalar z1204 = s_beta_4 * z1150;
    const Scalar z1205 = n500 * z1204;
    const Scalar z1188 = s_beta_3 * z1025 - c_beta_3 * z1026;
    const Scalar z1187 = s_beta_3 * z1026 + c_beta_3 * z1025;
    const Scalar z1182 = c_beta_4 * z1179 + s_beta_4 * z1181;
    const Scalar z1189 = s_beta_4 * z1188 - c_beta_4 * z1187;
    const Scalar z1183 = n500 * z1182;
    const Scalar z1221 = s_beta_4 * (z1004 - z1020) + c_beta_4 * (z1005 - z1045);
    const Scalar z1222 = s_beta_4 * (z1005 - z1045) - c_beta_4 * (z1004 - z1020);
    const Scalar z1167 = n2 * z1004;
    const Scalar z1170 = z1167 + n500 * z1169;
    const Scalar z1230 = n500 * z1035 - z1167;
    const Scalar z1210 = z1167 - n500 * z1209;
    const Scalar z1190 = z1167 + n500 * z1189;
    const Scalar z1171 = n4 * z1130 - z1164 - n1900 * z1166 - z1170;
    const Scalar z1184 = z1154 - n1900 * z1179 - z1183;
    const Scalar z1211 = n4 * z1130 - z1164 + n1900 * z1030 - z1210;
    const Scalar z1191 = n4 * z1130 - z1164 + n1900 * z1187 - z1190;
    const Scalar z1172 = n4400 * z1163 - z1162 + n4 * z1132 + z1171;
    const Scalar z1192 = n4400 * z1025 - z1162 + n4 * z1132 + z1191;
    const Scalar z1173 = n16600 * z1021 - z1159 + z1161 + z1172 + n4 * z1138;
    const Scalar z1199 = s_beta_3 * (z1050 - z1129) - c_beta_3 * (z1049 - z1131);
    const Scalar z1200 = s_beta_3 * (z1049 - z1131) + c_beta_3 * (z1050 - z1129);
    const Scalar z1174 = k3 - z1173;
    const Scalar z1235 = s_beta_1 * z1110 - c_beta_1 * z1123;
    const Scalar z1223 = s_beta_3 * z1221 + c_beta_3 * z1222;
    const Scalar z1224 = s_beta_3 * z1222 - c_beta_3 * z1221;
    const Scalar z1231 = n4 * z1222 + z1230;
    const Scalar z1234 = k9 - z1230;
    const Scalar z1206 = z1154 - z1205;
    const Scalar z1177 = s_beta_2 * (z1055 - z1135) - c_beta_2 * (z1054 - z1133);
    const Scalar z1176 = s_beta_2 * (z1054 - z1133) + c_beta_2 * (z1055 - z1135);
    const Scalar z1178 = c_beta_1 * z1177 + s_beta_1 * z1176;
    const Scalar z1193 = n4 * z1177 - z1192;
    const Scalar z1195 = k5 - z1192;
    const Scalar z1241 = z1077 * z1170 + z1171;
    const Scalar z1238 = n2400 * z1039;
    const Scalar z1242 = z1172 + z1076 * z1170 - z1091 * z1241;
    const Scalar z1236 = s_beta_1 * z1044 + c_beta_1 * z1043;
    const Scalar z1237 = n4 * z1123;
    const Scalar z1239 = n4 * z1043 - z1238;
    const Scalar z1240 = n600000 + z1238;
    const Scalar z1243 = z1070 * z1161 - z1075 * z1170 + z1090 * z1241 + z1174 + z1100 * z1242;
    const Scalar z1201 = s_beta_2 * z1199 - c_beta_2 * z1200;
    const Scalar z1202 = c_beta_2 * z1199 + s_beta_2 * z1200;
    const Scalar z1212 = n4 * z1199 - z1211;
    const Scalar z1203 = s_beta_1 * z1201 - c_beta_1 * z1202;
    const Scalar z1213 = n4 * z1202 + z1212;
    const Scalar z1215 = k7 - z1211;
    const Scalar z1244 = z1069 * z1161 - z1140 + z1074 * z1170 - z1089 * z1241 - z1099 * z1242 + z1105 * z1243;
    const Scalar z1225 = s_beta_2 * z1223 + c_beta_2 * z1224;
    const Scalar z1226 = s_beta_2 * z1224 - c_beta_2 * z1223;
    const Scalar z1232 = n4 * z1223 + z1231;
    const Scalar z1227 = s_beta_1 * z1225 + c_beta_1 * z1226;
    const Scalar z1233 = n4 * z1226 - z1232;
    const Scalar z1185 = n4 * z1116 + z1184;
    const Scalar z1207 = n4 * z1116 + z1206;
    const Scalar z1186 = n4 * z1125 + z1185;
    const Scalar z1194 = n28000 - z1185;
    const Scalar z1208 = n4 * z1197 + z1207;
    const Scalar z1214 = n12000 - z1206;
    const Scalar z1261 = z1077 * z1190 + z1191;
    const Scalar z1271 = z1077 * z1183 + z1184;
    const Scalar z1251 = z1077 * z1153 + z1155;
    const Scalar z1262 = z1076 * z1190 - z1195 - z1091 * z1261;
    const Scalar z1272 = z1076 * z1183 - z1194 - z1091 * z1271;
    const Scalar z1252 = z1076 * z1153 - z1156 - z1091 * z1251;
    const Scalar z1263 = z1075 * z1190 - z1193 - z1090 * z1261 - z1100 * z1262;
    const Scalar z1273 = z1075 * z1183 + z1186 - z1090 * z1271 - z1100 * z1272;
    const Scalar z1253 = z1158 + z1070 * z1143 + z1075 * z1153 - z1090 * z1251 - z1100 * z1252;
    const Scalar z1264 = z1178 + z1074 * z1190 - z1089 * z1261 - z1099 * z1262 - z1105 * z1263;
    const Scalar z1274 = z1074 * z1183 - z1175 - z1089 * z1271 - z1099 * z1272 - z1105 * z1273;
    const Scalar z1245 = z1107 * z1244;
    const Scalar z1254 = z1069 * z1143 - z1127 - z1074 * z1153 + z1089 * z1251 + z1099 * z1252 + z1105 * z1253;
    const Scalar z1265 = z1107 * z1264;
    const Scalar z1275 = z1107 * z1274;
    const Scalar z1255 = z1107 * z1254;
    const Scalar z1246 = z1104 * z1243 + z1105 * z1245;
    const Scalar z1250 = z1069 * z1245 - k25 * z1161 + z1070 * z1246;
    const Scalar z1256 = z1104 * z1253 + z1105 * z1255;
    const Scalar z1260 = z1069 * z1255 - k25 * z1143 + z1070 * z1256;
    const Scalar z1266 = z1104 * z1263 - z1105 * z1265;
    const Scalar z1276 = z1104 * z1273 - z1105 * z1275;
    const Scalar z1247 = z1098 * z1242 - z1099 * z1245 + z1100 * z1246;
    const Scalar z1257 = z1098 * z1252 + z1099 * z1255 - z1100 * z1256;
    const Scalar z1267 = z1098 * z1262 - z1099 * z1265 - z1100 * z1266;
    const Scalar z1277 = z1098 * z1272 - z1099 * z1275 - z1100 * z1276;
    const Scalar z1248 = z1088 * z1241 - z1089 * z1245 + z1090 * z1246 - z1091 * z1247;
    const Scalar z1249 = z1074 * z1245 - k23 * z1170 - z1075 * z1246 + z1076 * z1247 + z1077 * z1248;
    const Scalar z1258 = z1088 * z1251 + z1089 * z1255 - z1090 * z1256 - z1091 * z1257;
    const Scalar z1259 = k23 * z1153 + z1074 * z1255 - z1075 * z1256 - z1076 * z1257 - z1077 * z1258;
    const Scalar z1268 = z1088 * z1261 - z1089 * z1265 - z1090 * z1266 - z1091 * z1267;
    const Scalar z1269 = z1074 * z1265 - k23 * z1190 + z1075 * z1266 + z1076 * z1267 + z1077 * z1268;
    const Scalar z1270 = z1069 * z1265 - z1070 * z1266;
    const Scalar z1218 = s_beta_2 * z1216 - c_beta_2 * z1217;
    const Scalar z1219 = s_beta_2 * z1217 + c_beta_2 * z1216;
    const Scalar z1228 = z1154 + n4 * z1216;
    const Scalar z1220 = s_beta_1 * z1218 - c_beta_1 * z1219;
    const Scalar z1229 = n4 * z1219 + z1228;
    const Scalar z1281 = z1077 * z1210 - z1215;
    const Scalar z1291 = z1077 * z1205 - z1214;
    const Scalar z1301 = z1077 * z1234 + z1231;
    const Scalar z1311 = n5000 * z1077 + z1154;
    const Scalar z1282 = z1076 * z1210 - z1212 - z1091 * z1281;
    const Scalar z1292 = z1207 + z1076 * z1205 - z1091 * z1291;
    const Scalar z1302 = z1232 + z1076 * z1234 - z1091 * z1301;
    const Scalar z1312 = z1228 + n5000 * z1076 - z1091 * z1311;
    const Scalar z1283 = z1075 * z1210 - z1213 - z1090 * z1281 - z1100 * z1282;
    const Scalar z1293 = z1208 + z1075 * z1205 - z1090 * z1291 - z1100 * z1292;
    const Scalar z1303 = z1075 * z1234 - z1233 - z1090 * z1301 - z1100 * z1302;
    const Scalar z1313 = z1229 + n5000 * z1075 - z1090 * z1311 - z1100 * z1312;
    const Scalar z1321 = z1070 * z1240 + z1239;
    const Scalar z1329 = n1200 * z1070 - z1237;
    const Scalar z1284 = z1074 * z1210 - z1203 - z1089 * z1281 - z1099 * z1282 - z1105 * z1283;
    const Scalar z1294 = z1074 * z1205 - z1198 - z1089 * z1291 - z1099 * z1292 - z1105 * z1293;
    const Scalar z1304 = z1227 + z1074 * z1234 - z1089 * z1301 - z1099 * z1302 - z1105 * z1303;
    const Scalar z1285 = z1107 * z1284;
    const Scalar z1295 = z1107 * z1294;
    const Scalar z1305 = z1107 * z1304;
    const Scalar z1314 = z1220 + n5000 * z1074 - z1089 * z1311 - z1099 * z1312 - z1105 * z1313;
    const Scalar z1322 = z1236 + z1069 * z1240 + z1105 * z1321;
    const Scalar z1330 = z1235 + n1200 * z1069 + z1105 * z1329;
    const Scalar z1315 = z1107 * z1314;
    const Scalar z1323 = z1107 * z1322;
    const Scalar z1331 = z1107 * z1330;
    const Scalar z1286 = z1104 * z1283 - z1105 * z1285;
    const Scalar z1296 = z1104 * z1293 - z1105 * z1295;
    const Scalar z1306 = z1104 * z1303 - z1105 * z1305;
    const Scalar z1316 = z1104 * z1313 - z1105 * z1315;
    const Scalar z1324 = z1104 * z1321 + z1105 * z1323;
    const Scalar z1332 = z1104 * z1329 + z1105 * z1331;
    const Scalar z1328 = z1069 * z1323 - k25 * z1240 + z1070 * z1324;
    const Scalar z1287 = z1098 * z1282 - z1099 * z1285 - z1100 * z1286;
    const Scalar z1297 = z1098 * z1292 - z1099 * z1295 - z1100 * z1296;
    const Scalar z1307 = z1098 * z1302 - z1099 * z1305 - z1100 * z1306;
    const Scalar z1317 = z1098 * z1312 - z1099 * z1315 - z1100 * z1316;
    const Scalar z1278 = z1088 * z1271 - z1089 * z1275 - z1090 * z1276 - z1091 * z1277;
    const Scalar z1279 = z1074 * z1275 - k23 * z1183 + z1075 * z1276 + z1076 * z1277 + z1077 * z1278;
    const Scalar z1280 = z1069 * z1275 - z1070 * z1276;
    const Scalar z1288 = z1088 * z1281 - z1089 * z1285 - z1090 * z1286 - z1091 * z1287;
    const Scalar z1289 = z1074 * z1285 - k23 * z1210 + z1075 * z1286 + z1076 * z1287 + z1077 * z1288;
    const Scalar z1290 = z1069 * z1285 - z1070 * z1286;
    const Scalar z1298 = z1088 * z1291 - z1089 * z1295 - z1090 * z1296 - z1091 * z1297;
    const Scalar z1299 = z1074 * z1295 - k23 * z1205 + z1075 * z1296 + z1076 * z1297 + z1077 * z1298;
    const Scalar z1300 = z1069 * z1295 - z1070 * z1296;
    const Scalar z1308 = z1088 * z1301 - z1089 * z1305 - z1090 * z1306 - z1091 * z1307;
    const Scalar z1309 = z1074 * z1305 - k23 * z1234 + z1075 * z1306 + z1076 * z1307 + z1077 * z1308;
    const Scalar z1310 = z1069 * z1305 - z1070 * z1306;
    const Scalar z1318 = z1088 * z1311 - z1089 * z1315 - z1090 * z1316 - z1091 * z1317;
    const Scalar z1325 = z1099 * z1323 - z1100 * z1324;
    const Scalar z1319 = n3_75 - z1074 * z1315 - z1075 * z1316 - z1076 * z1317 - z1077 * z1318;
    const Scalar z1333 = z1099 * z1331 - z1100 * z1332;
    const Scalar z1326 = z1089 * z1323 - z1090 * z1324 - z1091 * z1325;
    const Scalar z1334 = z1089 * z1331 - z1090 * z1332 - z1091 * z1333;
    const Scalar z1320 = z1069 * z1315 - z1070 * z1316;
    const Scalar z1327 = z1074 * z1323 - z1075 * z1324 - z1076 * z1325 - z1077 * z1326;
    const Scalar z1335 = z1074 * z1331 - z1075 * z1332 - z1076 * z1333 - z1077 * z1334;
    const Scalar z1336 = n60_over_179 - z1069 * z1331 - z1070 * z1332;
    result.M[0] = n20500;
    result.M[1] = z991;
    result.M[2] = -z986;
    result.M[3] = -z979;
    result.M[4] = -z967;
    result.M[5] = z952;
    result.M[6] = z991;
    result.M[7] = z990;
    result.M[8] = z985;
    result.M[9] = z978;
    result.M[10] = z966;
    result.M[11] = z951;
    result.M[12] = -z986;
    result.M[13] = z985;
    result.M[14] = z982;
    result.M[15] = z973;
    result.M[16] = z963;
    result.M[17] = n0;
    result.M[18] = -z979;
    result.M[19] = z978;
    result.M[20] = z973;
    result.M[21] = z970;
    result.M[22] = z958;
    result.M[23] = n0;
    result.M[24] = -z967;
    result.M[25] = z966;
    result.M[26] = z963;
    result.M[27] = z958;
    result.M[28] = k17;
    result.M[29] = n0;
    result.M[30] = z952;
    result.M[31] = z951;
    result.M[32] = n0;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n3580;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = -z1127;
    result.C[7] = z1158;
    result.C[8] = -z1156;
    result.C[9] = z1155;
    result.C[10] = -z1153;
    result.C[11] = -z1143;
    result.C[12] = -z1175;
    result.C[13] = -z1186;
    result.C[14] = z1194;
    result.C[15] = -z1184;
    result.C[16] = z1183;
    result.C[17] = n0;
    result.C[18] = -z1198;
    result.C[19] = -z1208;
    result.C[20] = -z1207;
    result.C[21] = z1214;
    result.C[22] = z1205;
    result.C[23] = n0;
    result.C[24] = z1220;
    result.C[25] = -z1229;
    result.C[26] = -z1228;
    result.C[27] = -z1154;
    result.C[28] = n5000;
    result.C[29] = n0;
    result.C[30] = -z1235;
    result.C[31] = z1237;
    result.C[32] = n0;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n1200;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = -z1140;
    result.K[7] = z1174;
    result.K[8] = -z1172;
    result.K[9] = -z1171;
    result.K[10] = z1170;
    result.K[11] = -z1161;
    result.K[12] = z1178;
    result.K[13] = z1193;
    result.K[14] = z1195;
    result.K[15] = -z1191;
    result.K[16] = z1190;
    result.K[17] = n0;
    result.K[18] = -z1203;
    result.K[19] = z1213;
    result.K[20] = z1212;
    result.K[21] = z1215;
    result.K[22] = z1210;
    result.K[23] = n0;
    result.K[24] = z1227;
    result.K[25] = z1233;
    result.K[26] = -z1232;
    result.K[27] = -z1231;
    result.K[28] = z1234;
    result.K[29] = n0;
    result.K[30] = -z1236;
    result.K[31] = -z1239;
    result.K[32] = n0;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = z1240;
    result.F[0] = -z1063;
    result.F[1] = -z1064;
    result.F[2] = -z1065;
    result.F[3] = -z1066;
    result.F[4] = -z1067;
    result.F[5] = -z1068;
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
    result.A[18] = z1245;
    result.A[19] = z1246;
    result.A[20] = -z1247;
    result.A[21] = -z1248;
    result.A[22] = z1249;
    result.A[23] = -z1250;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = z1265;
    result.A[31] = -z1266;
    result.A[32] = -z1267;
    result.A[33] = -z1268;
    result.A[34] = z1269;
    result.A[35] = -z1270;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n0;
    result.A[42] = z1285;
    result.A[43] = -z1286;
    result.A[44] = -z1287;
    result.A[45] = -z1288;
    result.A[46] = z1289;
    result.A[47] = -z1290;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = z1305;
    result.A[55] = -z1306;
    result.A[56] = -z1307;
    result.A[57] = -z1308;
    result.A[58] = z1309;
    result.A[59] = -z1310;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = -z1323;
    result.A[67] = -z1324;
    result.A[68] = -z1325;
    result.A[69] = -z1326;
    result.A[70] = -z1327;
    result.A[71] = z1328;
    result.A[72] = n1;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = n0;
    result.A[78] = n0;
    result.A[79] = n0;
    result.A[80] = n0;
    result.A[81] = n0;
    result.A[82] = n0;
    result.A[83] = n0;
    result.A[84] = n0;
    result.A[85] = n1;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = z1255;
    result.A[91] = z1256;
    result.A[92] = z1257;
    result.A[93] = z1258;
    result.A[94] = z1259;
    result.A[95] = -z1260;
    result.A[96] = n0;
    result.A[97] = n0;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = z1275;
    result.A[103] = -z1276;
    result.A[104] = -z1277;
    result.A[105] = -z1278;
    result.A[106] = z1279;
    result.A[107] = -z1280;
    result.A[108] = n0;
    result.A[109] = n0;
    result.A[110] = n0;
    result.A[111] = n1;
    result.A[112] = n0;
    result.A[113] = n0;
    result.A[114] = z1295;
    result.A[115] = -z1296;
    result.A[116] = -z1297;
    result.A[117] = -z1298;
    result.A[118] = z1299;
    result.A[119] = -z1300;
    result.A[120] = n0;
    result.A[121] = n0;
    result.A[122] = n0;
    result.A[123] = n0;
    result.A[124] = n1;
    result.A[125] = n0;
    result.A[126] = z1315;
    result.A[127] = -z1316;
    result.A[128] = -z1317;
    result.A[129] = -z1318;
    result.A[130] = -z1319;
    result.A[131] = -z1320;
    result.A[132] = n0;
    result.A[133] = n0;
    result.A[134] = n0;
    result.A[135] = n0;
    result.A[136] = n0;
    result.A[137] = n1;
    result.A[138] = -z1331;
    result.A[139] = -z1332;
    result.A[140] = -z1333;
    result.A[141] = -z1334;
    result.A[142] = -z1335;
    result.A[143] = -z1336;
    if (!(traits::regular(-z1106, n20500) && traits::regular(-z1103, z990) && traits::regular(-z1097, z982)
        && traits::regular(-z1087, z970))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((n0 * result.M[1] * result.M[2] * result.M[3] * result.M[4] * result.M[5] * result.M[6]
        * result.M[7] * result.M[8]) * (n0 * result.M[9] * result.M[10] * result.M[11] * result.M[12] * result.M[13]
        * result.M[14] * result.M[15] * result.M[16] * result.M[18])) * ((n0 * result.M[19] * result.M[20]
        * result.M[21] * result.M[22] * result.M[24] * result.M[25] * result.M[26] * result.M[27]) * (n0 * result.M[30]
        * result.M[31] * result.C[6] * result.C[7] * result.C[8] * result.C[9] * result.C[10] * result.C[11]
        * result.C[12]))) * (((n0 * result.C[13] * result.C[14] * result.C[15] * result.C[16] * result.C[18]
        * result.C[19] * result.C[20] * result.C[21]) * (n0 * result.C[22] * result.C[24] * result.C[25] * result.C[26]
        * result.C[27] * result.C[30] * result.C[31] * result.K[6] * result.K[7])) * ((n0 * result.K[8] * result.K[9]
        * result.K[10] * result.K[11] * result.K[12] * result.K[13] * result.K[14] * result.K[15] * result.K[16]) * (n0
        * result.K[18] * result.K[19] * result.K[20] * result.K[21] * result.K[22] * result.K[24] * result.K[25]
        * result.K[26] * result.K[27])))) * ((((n0 * result.K[28] * result.K[30] * result.K[31] * result.K[35]
        * result.F[0] * result.F[1] * result.F[2] * result.F[3]) * (n0 * result.F[4] * result.F[5] * result.A[18]
        * result.A[19] * result.A[20] * result.A[21] * result.A[22] * result.A[23] * result.A[30])) * ((n0
        * result.A[31] * result.A[32] * result.A[33] * result.A[34] * result.A[35] * result.A[42] * result.A[43]
        * result.A[44] * result.A[45]) * (n0 * result.A[46] * result.A[47] * result.A[54] * result.A[55] * result.A[56]
        * result.A[57] * result.A[58] * result.A[59] * result.A[66]))) * (((n0 * result.A[67] * result.A[68]
        * result.A[69] * result.A[70] * result.A[71] * result.A[90] * result.A[91] * result.A[92]) * (n0 * result.A[93]
        * result.A[94] * result.A[95] * result.A[102] * result.A[103] * result.A[104] * result.A[105] * result.A[106]
        * result.A[107])) * ((n0 * result.A[114] * result.A[115] * result.A[116] * result.A[117] * result.A[118]
        * result.A[119] * result.A[126] * result.A[127] * result.A[128]) * (n0 * result.A[129] * result.A[130]
        * result.A[131] * result.A[138] * result.A[139] * result.A[140] * result.A[141] * result.A[142]
        * result.A[143]))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace elastic_wing
