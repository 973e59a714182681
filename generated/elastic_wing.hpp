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
// joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               60               45          0             0                  5       0    115     115
//   mass_matrix              35               45          0             0                  5       0     90      96
//   bias                     55               67          0             0                  8       0    138     162
//   inverse_dynamics         79               89          0             0                  8       0    184     211
//   forward_dynamics        120              159          4             0                  8       0    299     330
//   energy                   66              105          0             0                  8       0    187     199
//   linearisation           471              608          4             0                  8       0   1099    1329
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

namespace elastic_wing {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "elastic_wing";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe18da647cdccbb8fULL;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;

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
    const Scalar z142 = n500 * s_beta_4;
    const Scalar z143 = n500 * c_beta_4;
    const Scalar z126 = n2400 * c_gamma;
    const Scalar z127 = n2400 * s_gamma;
    const Scalar z128 = n3580 + n4 * z127;
    const Scalar z130 = s_beta_1 * z126 + c_beta_1 * z127;
    const Scalar z136 = n3580 + n8 * z127;
    const Scalar z139 = n16600 + z127;
    const Scalar z144 = k6 + n4 * z143;
    const Scalar z145 = s_beta_3 * z143 + c_beta_3 * z142;
    const Scalar z146 = s_beta_3 * z142 - c_beta_3 * z143;
    const Scalar z158 = k6 + n8 * z143;
    const Scalar z161 = n1900 + z143;
    const Scalar z164 = c_beta_3 * z142 + s_beta_3 * z161;
    const Scalar z165 = s_beta_3 * z142 - c_beta_3 * z161;
    const Scalar z140 = k8 + z136;
    const Scalar z162 = n6400 + z158;
    const Scalar z147 = z144 - n4 * z146;
    const Scalar z148 = s_beta_2 * z146 - c_beta_2 * z145;
    const Scalar z149 = s_beta_2 * z145 + c_beta_2 * z146;
    const Scalar z166 = z162 - n4 * z165;
    const Scalar z167 = s_beta_2 * z165 - c_beta_2 * z164;
    const Scalar z168 = s_beta_2 * z164 + c_beta_2 * z165;
    const Scalar z179 = z162 - n8 * z165;
    const Scalar z182 = n4400 - z165;
    const Scalar z185 = c_beta_2 * z164 + s_beta_2 * z182;
    const Scalar z186 = s_beta_2 * z164 - c_beta_2 * z182;
    const Scalar z183 = k11 + z179;
    const Scalar z150 = z147 - n4 * z149;
    const Scalar z152 = s_beta_1 * z148 - c_beta_1 * z149;
    const Scalar z169 = z166 - n4 * z168;
    const Scalar z171 = s_beta_1 * z167 - c_beta_1 * z168;
    const Scalar z187 = z183 - n4 * z186;
    const Scalar z189 = s_beta_1 * z185 + c_beta_1 * z186;
    const Scalar z197 = z183 - n8 * z186;
    const Scalar z200 = z139 - z186;
    const Scalar z201 = z126 - z185;
    const Scalar z207 = s_beta_1 * z201 + c_beta_1 * z200;
    const Scalar z202 = z140 + z197;
    mass[0] = n20500;
    mass[1] = z207;
    mass[2] = -z189;
    mass[3] = z171;
    mass[4] = z152;
    mass[5] = z130;
    mass[6] = z207;
    mass[7] = z202;
    mass[8] = z187;
    mass[9] = z169;
    mass[10] = z150;
    mass[11] = z128;
    mass[12] = -z189;
    mass[13] = z187;
    mass[14] = z183;
    mass[15] = z166;
    mass[16] = z147;
    mass[17] = n0;
    mass[18] = z171;
    mass[19] = z169;
    mass[20] = z166;
    mass[21] = z162;
    mass[22] = z144;
    mass[23] = n0;
    mass[24] = z152;
    mass[25] = z150;
    mass[26] = z147;
    mass[27] = z144;
    mass[28] = k6;
    mass[29] = n0;
    mass[30] = z130;
    mass[31] = z128;
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
    const Scalar z251 = v_beta_1 * v_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z241 = z50 * p_gust;
    const Scalar z242 = z51 * p_gust;
    const Scalar z237 = z39 * p_gust;
    const Scalar z238 = z40 * p_gust;
    const Scalar z252 = n4 * z251;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z255 = z35 * z35;
    const Scalar z233 = z29 * p_gust;
    const Scalar z234 = z30 * p_gust;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z253 = c_beta_2 * z252;
    const Scalar z254 = s_beta_2 * z252;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z259 = z46 * z46;
    const Scalar z265 = z63 * z63;
    const Scalar z216 = s_beta_1 * p_gust;
    const Scalar z270 = z57 * z57;
    const Scalar z217 = c_beta_1 * p_gust;
    const Scalar z263 = c_gamma * z252;
    const Scalar z266 = n2400 * z265;  // force on engine, z
    const Scalar z231 = k2 * q_beta_1;
    const Scalar z232 = n60000 * v_beta_1;
    const Scalar z268 = s_gamma * z266;
    const Scalar z269 = c_gamma * z266;
    const Scalar z235 = k4 * q_beta_2;
    const Scalar z236 = n28000 * v_beta_2;
    const Scalar z239 = k6 * q_beta_3;
    const Scalar z240 = n12000 * v_beta_3;
    const Scalar z243 = k8 * q_beta_4;
    const Scalar z244 = n5000 * v_beta_4;
    const Scalar z245 = n600000 * q_gamma;
    const Scalar z246 = n1200 * v_gamma;
    const Scalar z247 = n2 * z217;
    const Scalar z256 = z253 + n4 * z255;
    const Scalar z267 = n2400 * z263;  // moment on engine, x
    const Scalar z248 = n2 * z234;
    const Scalar z294 = z245 + z246 - z267;
    const Scalar z257 = s_beta_3 * z254 - c_beta_3 * z256;
    const Scalar z258 = c_beta_3 * z254 + s_beta_3 * z256;
    const Scalar z249 = n2 * z238;
    const Scalar z260 = z257 - n4 * z259;
    const Scalar z250 = n2 * z242;
    const Scalar z271 = z241 + n500 * z270;  // force on panel_4, y
    const Scalar z262 = s_beta_4 * z260 - c_beta_4 * z258;
    const Scalar z273 = s_beta_4 * z242 - c_beta_4 * z271;
    const Scalar z274 = c_beta_4 * z242 + s_beta_4 * z271;
    const Scalar z275 = z237 + n1900 * z259 - z273;  // force on panel_3, y
    const Scalar z276 = z238 + z274;  // force on panel_3, z
    const Scalar z272 = z250 + n500 * z262;  // moment on panel_4, x
    const Scalar z278 = s_beta_3 * z276 - c_beta_3 * z275;
    const Scalar z279 = s_beta_3 * z275 + c_beta_3 * z276;
    const Scalar z277 = z249 - n1900 * z258 + n4 * z274 + z272;  // moment on panel_3, x
    const Scalar z293 = z243 + z244 - z272;
    const Scalar z292 = z239 + z240 - z277;
    const Scalar z280 = z233 + n4400 * z255 - z278;  // force on panel_2, y
    const Scalar z281 = z234 + z279;  // force on panel_2, z
    const Scalar z282 = z248 - n4400 * z254 + z277 + n4 * z279;  // moment on panel_2, x
    const Scalar z283 = s_beta_2 * z281 - c_beta_2 * z280;
    const Scalar z284 = s_beta_2 * z280 + c_beta_2 * z281;
    const Scalar z291 = z235 + z236 - z282;
    const Scalar z285 = z216 + n16600 * z251 + z268 - z283;  // force on panel_1, y
    const Scalar z286 = z217 - z269 + z284;  // force on panel_1, z
    const Scalar z287 = z247 + z267 + z282 - n4 * (z269 - z284);  // moment on panel_1, x
    const Scalar z289 = s_beta_1 * z285 + c_beta_1 * z286;
    const Scalar z290 = z231 + z232 - z287;
    forces.z = -z289;
    forces.beta_1 = z290;
    forces.beta_2 = z291;
    forces.beta_3 = z292;
    forces.beta_4 = z293;
    forces.gamma = z294;
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
    const Scalar z301 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z251 = v_beta_1 * v_beta_1;
    const Scalar z295 = a_z * s_beta_1;
    const Scalar z296 = a_z * c_beta_1;
    const Scalar z242 = z51 * p_gust;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z306 = a_beta_3 + z301;  // angular acceleration of panel_3, x
    const Scalar z241 = z50 * p_gust;
    const Scalar z237 = z39 * p_gust;
    const Scalar z238 = z40 * p_gust;
    const Scalar z255 = z35 * z35;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z311 = a_beta_4 + z306;  // angular acceleration of panel_4, x
    const Scalar z259 = z46 * z46;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z234 = z30 * p_gust;
    const Scalar z233 = z29 * p_gust;
    const Scalar z270 = z57 * z57;
    const Scalar z265 = z63 * z63;
    const Scalar z217 = c_beta_1 * p_gust;
    const Scalar z314 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z266 = n2400 * z265;  // force on engine, z
    const Scalar z216 = s_beta_1 * p_gust;
    const Scalar z315 = n2400 * z314;  // force on engine, y
    const Scalar z231 = k1 * q_beta_1;
    const Scalar z232 = n60000 * v_beta_1;
    const Scalar z235 = k3 * q_beta_2;
    const Scalar z317 = s_gamma * z266 - c_gamma * z315;
    const Scalar z318 = s_gamma * z315 + c_gamma * z266;
    const Scalar z236 = n28000 * v_beta_2;
    const Scalar z239 = k5 * q_beta_3;
    const Scalar z240 = n12000 * v_beta_3;
    const Scalar z243 = k7 * q_beta_4;
    const Scalar z244 = n5000 * v_beta_4;
    const Scalar z245 = n600000 * q_gamma;
    const Scalar z246 = n1200 * v_gamma;
    const Scalar z247 = n2 * z217;
    const Scalar z297 = n4 * z251 - z295;
    const Scalar z298 = n4 * a_beta_1 + z296;
    const Scalar z248 = n2 * z234;
    const Scalar z299 = s_beta_2 * z298 - c_beta_2 * z297;
    const Scalar z300 = s_beta_2 * z297 + c_beta_2 * z298;
    const Scalar z312 = s_gamma * z298 - c_gamma * z297;
    const Scalar z249 = n2 * z238;
    const Scalar z250 = n2 * z242;
    const Scalar z271 = z241 + n500 * z270;  // force on panel_4, y
    const Scalar z319 = z242 - n500 * z311;  // force on panel_4, z
    const Scalar z302 = n4 * z255 - z299;
    const Scalar z303 = z300 + n4 * z301;
    const Scalar z316 = n3580 * z314 + n2400 * z312;  // moment on engine, x
    const Scalar z321 = s_beta_4 * z319 - c_beta_4 * z271;
    const Scalar z322 = s_beta_4 * z271 + c_beta_4 * z319;
    const Scalar z304 = s_beta_3 * z303 - c_beta_3 * z302;
    const Scalar z305 = s_beta_3 * z302 + c_beta_3 * z303;
    const Scalar z343 = z245 + z246 + z316;
    const Scalar z323 = z237 + n1900 * z259 - z321;  // force on panel_3, y
    const Scalar z324 = z238 - n1900 * z306 + z322;  // force on panel_3, z
    const Scalar z307 = n4 * z259 - z304;
    const Scalar z308 = z305 + n4 * z306;
    const Scalar z326 = s_beta_3 * z324 - c_beta_3 * z323;
    const Scalar z327 = s_beta_3 * z323 + c_beta_3 * z324;
    const Scalar z310 = s_beta_4 * z307 + c_beta_4 * z308;
    const Scalar z328 = z233 + n4400 * z255 - z326;  // force on panel_2, y
    const Scalar z329 = z234 - n4400 * z301 + z327;  // force on panel_2, z
    const Scalar z320 = z250 - k17 * z311 - n500 * z310;  // moment on panel_4, x
    const Scalar z331 = s_beta_2 * z329 - c_beta_2 * z328;
    const Scalar z332 = s_beta_2 * z328 + c_beta_2 * z329;
    const Scalar z325 = z249 - n6400 * z306 + n4 * z322 - n1900 * z305 + z320;  // moment on panel_3, x
    const Scalar z342 = z243 + z244 - z320;
    const Scalar z330 = z248 - k19 * z301 - n4400 * z300 + n4 * z327 + z325;  // moment on panel_2, x
    const Scalar z333 = z216 + n16600 * z251 + z317 - z331;  // force on panel_1, y
    const Scalar z334 = n16600 * a_beta_1 - z217 + z318 - z332;  // force on panel_1, z
    const Scalar z341 = z239 + z240 - z325;
    // moment on panel_1, x
    const Scalar z335 = k21 * a_beta_1 - z247 + n16600 * z296 + z316 + n4 * (z318 - z332) - z330;
    const Scalar z337 = s_beta_1 * z333 - c_beta_1 * z334;
    const Scalar z340 = z235 + z236 - z330;
    const Scalar z338 = n20500 * a_z - z337;  // force on fuselage, z
    const Scalar z339 = z231 + z232 + z335;
    forces.z = z338;
    forces.beta_1 = z339;
    forces.beta_2 = z340;
    forces.beta_3 = z341;
    forces.beta_4 = z342;
    forces.gamma = z343;
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
    const Scalar z365 = n187_5 * s_beta_4;
    const Scalar z251 = v_beta_1 * v_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z366 = n187_5 * c_beta_4;
    const Scalar z242 = z51 * p_gust;
    const Scalar z243 = k1 * q_beta_4;
    const Scalar z252 = n4 * z251;
    const Scalar z255 = z35 * z35;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z244 = n5000 * v_beta_4;
    const Scalar z241 = z50 * p_gust;
    const Scalar z353 = z243 + z244;
    const Scalar z253 = c_beta_2 * z252;
    const Scalar z254 = s_beta_2 * z252;
    const Scalar z259 = z46 * z46;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z238 = z40 * p_gust;
    const Scalar z355 = k4 * s_gamma;
    const Scalar z270 = z57 * z57;
    const Scalar z237 = z39 * p_gust;
    const Scalar z239 = k5 * q_beta_3;
    const Scalar z240 = n12000 * v_beta_3;
    const Scalar z352 = z239 + z240;
    const Scalar z234 = z30 * p_gust;
    const Scalar z356 = k4 * c_gamma;
    const Scalar z233 = z29 * p_gust;
    const Scalar z235 = k7 * q_beta_2;
    const Scalar z263 = c_gamma * z252;
    const Scalar z236 = n28000 * v_beta_2;
    const Scalar z351 = z235 + z236;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z265 = z63 * z63;
    const Scalar z245 = n600000 * q_gamma;
    const Scalar z246 = n1200 * v_gamma;
    const Scalar z354 = z245 + z246;
    const Scalar z217 = c_beta_1 * p_gust;
    const Scalar z216 = s_beta_1 * p_gust;
    const Scalar z266 = n2400 * z265;  // force on engine, z
    const Scalar z231 = k12 * q_beta_1;
    const Scalar z232 = n60000 * v_beta_1;
    const Scalar z350 = z231 + z232;
    const Scalar z247 = n2 * z217;
    const Scalar z256 = z253 + n4 * z255;
    const Scalar z267 = n2400 * z263;  // moment on engine, x
    const Scalar z357 = c_gamma * z356;
    const Scalar z358 = s_gamma * z355;
    const Scalar z359 = s_gamma * z356;
    const Scalar z367 = c_beta_4 * z366;
    const Scalar z368 = s_beta_4 * z365;
    const Scalar z369 = s_beta_4 * z366;
    const Scalar z248 = n2 * z234;
    const Scalar z360 = n4 * z359;
    const Scalar z361 = n4 * z358;
    const Scalar z370 = n4 * z369;
    const Scalar z371 = n4 * z367;
    const Scalar z257 = s_beta_3 * z254 - c_beta_3 * z256;
    const Scalar z258 = c_beta_3 * z254 + s_beta_3 * z256;
    const Scalar z249 = n2 * z238;
    const Scalar z362 = n4 * z361;
    const Scalar z364 = n16600 - z361;
    const Scalar z372 = n4 * z371;
    const Scalar z374 = n1900 - z371;
    const Scalar z260 = z257 - n4 * z259;
    const Scalar z250 = n2 * z242;
    const Scalar z271 = z241 + n500 * z270;  // force on panel_4, y
    const Scalar z363 = k18 - z362;
    const Scalar z373 = n6400 - z372;
    const Scalar z262 = s_beta_4 * z260 - c_beta_4 * z258;
    const Scalar z375 = n1 / z373;
    const Scalar z272 = z250 + n500 * z262;  // moment on panel_4, x
    const Scalar z432 = z267 - z354;
    const Scalar z433 = k21 * z432;
    const Scalar z434 = n120_over_179 * z432;
    const Scalar z435 = s_gamma * z266 - c_gamma * z434;
    const Scalar z436 = c_gamma * z266 + s_gamma * z434;
    const Scalar z437 = z272 - z353;
    const Scalar z376 = z370 * z375;
    const Scalar z377 = z374 * z375;
    const Scalar z438 = k23 * z437;
    const Scalar z439 = z242 - n0_375 * z437;
    const Scalar z378 = z368 + z370 * z376;
    const Scalar z379 = z369 - z370 * z377;
    const Scalar z380 = z367 + z374 * z377;
    const Scalar z440 = s_beta_4 * z439 - c_beta_4 * z271;
    const Scalar z441 = s_beta_4 * z271 + c_beta_4 * z439;
    const Scalar z381 = z378 - z380;
    const Scalar z382 = n2 * z379;
    const Scalar z443 = z238 + z441;
    const Scalar z444 = z249 - n1900 * z258 + z353 + n4 * z441;
    const Scalar z383 = s_beta_3 * z381 - c_beta_3 * z382;
    const Scalar z442 = z237 + n1900 * z259 - z440;
    const Scalar z445 = z352 - z444;
    const Scalar z446 = z375 * z445;
    const Scalar z447 = z376 * z445 + z442;
    const Scalar z384 = s_beta_3 * z383;
    const Scalar z448 = z377 * z445 + z443;
    const Scalar z387 = c_beta_3 * z383 + z379;
    const Scalar z385 = z378 - z384;
    const Scalar z386 = z380 + z384;
    const Scalar z449 = s_beta_3 * z448 - c_beta_3 * z447;
    const Scalar z450 = s_beta_3 * z447 + c_beta_3 * z448;
    const Scalar z388 = n4 * z387;
    const Scalar z389 = n4 * z386;
    const Scalar z390 = n4 * z389;
    const Scalar z392 = n4400 - z389;
    const Scalar z451 = z233 + n4400 * z255 - z449;
    const Scalar z452 = z234 + z450;
    const Scalar z453 = z248 - n4400 * z254 + z352 + n4 * z450;
    const Scalar z391 = k26 - z390;
    const Scalar z454 = z351 - z453;
    const Scalar z393 = n1 / z391;
    const Scalar z394 = z388 * z393;
    const Scalar z395 = z392 * z393;
    const Scalar z455 = z393 * z454;
    const Scalar z396 = z385 + z388 * z394;
    const Scalar z397 = z387 - z388 * z395;
    const Scalar z398 = z386 + z392 * z395;
    const Scalar z456 = z394 * z454 - z451;
    const Scalar z457 = z395 * z454 + z452;
    const Scalar z399 = z396 - z398;
    const Scalar z400 = n2 * z397;
    const Scalar z458 = s_beta_2 * z457 + c_beta_2 * z456;
    const Scalar z459 = s_beta_2 * z456 - c_beta_2 * z457;
    const Scalar z401 = s_beta_2 * z399 + c_beta_2 * z400;
    const Scalar z460 = z216 + n16600 * z251 + z435 - z458;
    const Scalar z461 = z217 - z436 - z459;
    const Scalar z462 = z351 + z354 + z247 - n4 * (z436 + z459);
    const Scalar z402 = s_beta_2 * z401;
    const Scalar z405 = c_beta_2 * z401 - z397;
    const Scalar z403 = z396 - z402;
    const Scalar z404 = z398 + z402;
    const Scalar z406 = n4 * z405;
    const Scalar z413 = z359 + z405;
    const Scalar z463 = z350 - z462;
    const Scalar z407 = n4 * z404;
    const Scalar z412 = z357 + z403;
    const Scalar z414 = z358 + z404;
    const Scalar z410 = z360 + z406;
    const Scalar z408 = n4 * z407;
    const Scalar z411 = z364 - z407;
    const Scalar z409 = z363 - z408;
    const Scalar z415 = n1 / z409;
    const Scalar z416 = z410 * z415;
    const Scalar z417 = z411 * z415;
    const Scalar z464 = z415 * z463;
    const Scalar z418 = z410 * z416 + z412;
    const Scalar z419 = z410 * z417 - z413;
    const Scalar z420 = z411 * z417 + z414;
    const Scalar z465 = z416 * z463 - z460;
    const Scalar z466 = z417 * z463 + z461;
    const Scalar z421 = z418 - z420;
    const Scalar z422 = n2 * z419;
    const Scalar z468 = s_beta_1 * z465 - c_beta_1 * z466;
    const Scalar z423 = s_beta_1 * z421 - c_beta_1 * z422;
    const Scalar z424 = s_beta_1 * z423;
    const Scalar z426 = z420 + z424;
    const Scalar z429 = n20500 - z426;
    const Scalar z430 = n1 / z429;
    const Scalar z469 = z430 * z468;
    const Scalar z471 = s_beta_1 * z469;
    const Scalar z472 = c_beta_1 * z469;
    const Scalar z473 = z464 + z416 * z471 - z417 * z472;
    const Scalar z474 = z472 + n4 * z473;
    const Scalar z475 = c_beta_2 * z471 + s_beta_2 * z474;
    const Scalar z476 = s_beta_2 * z471 - c_beta_2 * z474;
    const Scalar z489 = c_gamma * z471 + s_gamma * z474;
    const Scalar z477 = z455 + z394 * z475 + z395 * z476;
    const Scalar z491 = z433 + n120_over_179 * z489;
    const Scalar z492 = z473 + z491;
    const Scalar z478 = z473 - z477;
    const Scalar z479 = z476 - n4 * z477;
    const Scalar z480 = s_beta_3 * z479 - c_beta_3 * z475;
    const Scalar z481 = s_beta_3 * z475 + c_beta_3 * z479;
    const Scalar z482 = z446 + z377 * z481 + z376 * z480;
    const Scalar z483 = z477 - z482;
    const Scalar z484 = z481 - n4 * z482;
    const Scalar z486 = s_beta_4 * z480 - c_beta_4 * z484;
    const Scalar z487 = z438 + n0_375 * z486;
    const Scalar z488 = z482 + z487;
    accelerations.z = -z469;
    accelerations.beta_1 = -z473;
    accelerations.beta_2 = z478;
    accelerations.beta_3 = z483;
    accelerations.beta_4 = z488;
    accelerations.gamma = z492;
    if (!(traits::regular(z373, z373) && traits::regular(z391, z391) && traits::regular(z409, z409)
        && traits::regular(z429, z429))) return torsor::Status::singular;
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
    const Scalar z219 = v_z * c_beta_1;
    const Scalar z218 = v_z * s_beta_1;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z216 = s_beta_1 * p_gust;
    const Scalar z217 = c_beta_1 * p_gust;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z232 = n60000 * v_beta_1;
    const Scalar z233 = z29 * p_gust;
    const Scalar z234 = z30 * p_gust;
    const Scalar z236 = n28000 * v_beta_2;
    const Scalar z237 = z39 * p_gust;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z238 = z40 * p_gust;
    const Scalar z240 = n12000 * v_beta_3;
    const Scalar z241 = z50 * p_gust;
    const Scalar z242 = z51 * p_gust;
    const Scalar z244 = n5000 * v_beta_4;
    const Scalar z246 = n1200 * v_gamma;
    const Scalar z220 = n4 * v_beta_1 + z219;
    const Scalar z555 = n2600 * v_beta_1 + n1300 * z219;
    const Scalar z556 = k8 * v_beta_1 + n2600 * z219;
    const Scalar z221 = c_beta_2 * z218 + s_beta_2 * z220;
    const Scalar z222 = s_beta_2 * z218 - c_beta_2 * z220;
    const Scalar z229 = c_gamma * z218 + s_gamma * z220;
    const Scalar z230 = s_gamma * z218 - c_gamma * z220;
    const Scalar z223 = n4 * z35 - z222;
    const Scalar z557 = n1600 * z35 - n800 * z222;
    const Scalar z558 = k11 * z35 - n1600 * z222;
    const Scalar z563 = n2400 * z63 + n2000 * z229;
    const Scalar z564 = n3580 * z63 + n2400 * z229;
    const Scalar z224 = c_beta_3 * z221 + s_beta_3 * z223;
    const Scalar z225 = s_beta_3 * z221 - c_beta_3 * z223;
    const Scalar z226 = n4 * z46 - z225;
    const Scalar z559 = n900 * z46 - n450 * z225;
    const Scalar z560 = n2400 * z46 - n900 * z225;
    const Scalar z227 = c_beta_4 * z224 + s_beta_4 * z226;
    const Scalar z228 = s_beta_4 * z224 - c_beta_4 * z226;
    const Scalar z561 = n500 * z57 - n250 * z228;
    const Scalar z562 = k19 * z57 - n500 * z228;
    result.kinetic = n7850 * v_z * v_z + n650 * z218 * z218 + n400 * z221 * z221 + n1000 * z230 * z230 + n225 * z224
        * z224 + n125 * z227 * z227 + n0_5 * (v_beta_1 * z556 + z219 * z555 + z35 * z558 + z63 * z564 - z222 * z557
        + z229 * z563 + z46 * z560 - z225 * z559 + z57 * z562 - z228 * z561);
    result.force_function = -k27 * q_beta_1 * q_beta_1 - k28 * q_beta_2 * q_beta_2 - k29 * q_beta_3 * q_beta_3 - k30
        * q_beta_4 * q_beta_4 - n300000 * q_gamma * q_gamma;
    result.power = z216 * z218 - v_beta_1 * z232 - v_beta_2 * z236 - v_beta_3 * z240 - v_beta_4 * z244 - v_gamma * z246
        + z217 * z219 + z221 * z233 - z222 * z234 + n2 * (v_beta_1 * z217 + z35 * z234 + z46 * z238 + z57 * z242) + z224
        * z237 - z225 * z238 + z227 * z241 - z228 * z242;
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
    const Scalar z143 = n500 * c_beta_4;
    const Scalar z142 = n500 * s_beta_4;
    const Scalar z35 = v_beta_1 + v_beta_2;
    const Scalar z67 = n2 * v_beta_1;
    const Scalar z241 = z50 * p_gust;
    const Scalar z127 = n2400 * s_gamma;
    const Scalar z46 = v_beta_3 + z35;
    const Scalar z74 = n2 * z35;
    const Scalar z242 = z51 * p_gust;
    const Scalar z238 = z40 * p_gust;
    const Scalar z237 = z39 * p_gust;
    const Scalar z126 = n2400 * c_gamma;
    const Scalar z57 = v_beta_4 + z46;
    const Scalar z81 = n2 * z46;
    const Scalar z233 = z29 * p_gust;
    const Scalar z63 = v_beta_1 + v_gamma;
    const Scalar z234 = z30 * p_gust;
    const Scalar z217 = c_beta_1 * p_gust;
    const Scalar z88 = n2 * z57;
    const Scalar z251 = v_beta_1 * v_beta_1;
    const Scalar z216 = s_beta_1 * p_gust;
    const Scalar z231 = k3 * q_beta_1;
    const Scalar z232 = n60000 * v_beta_1;
    const Scalar z235 = k5 * q_beta_2;
    const Scalar z236 = n28000 * v_beta_2;
    const Scalar z239 = k7 * q_beta_3;
    const Scalar z240 = n12000 * v_beta_3;
    const Scalar z243 = k9 * q_beta_4;
    const Scalar z244 = n5000 * v_beta_4;
    const Scalar z245 = n600000 * q_gamma;
    const Scalar z246 = n1200 * v_gamma;
    const Scalar z128 = n3580 + n4 * z127;
    const Scalar z255 = z35 * z35;
    const Scalar z130 = s_beta_1 * z126 + c_beta_1 * z127;
    const Scalar z259 = z46 * z46;
    const Scalar z136 = n3580 + n8 * z127;
    const Scalar z265 = z63 * z63;
    const Scalar z139 = n16600 + z127;
    const Scalar z266 = n2400 * z265;  // force on engine, z
    const Scalar z144 = k17 + n4 * z143;
    const Scalar z145 = s_beta_3 * z143 + c_beta_3 * z142;
    const Scalar z146 = s_beta_3 * z142 - c_beta_3 * z143;
    const Scalar z158 = k17 + n8 * z143;
    const Scalar z161 = n1900 + z143;
    const Scalar z247 = n2 * z217;
    const Scalar z164 = c_beta_3 * z142 + s_beta_3 * z161;
    const Scalar z165 = s_beta_3 * z142 - c_beta_3 * z161;
    const Scalar z248 = n2 * z234;
    const Scalar z140 = k19 + z136;
    const Scalar z270 = z57 * z57;
    const Scalar z296 = a_z * c_beta_1;
    const Scalar z295 = a_z * s_beta_1;
    const Scalar z297 = n4 * z251 - z295;
    const Scalar z298 = n4 * a_beta_1 + z296;
    const Scalar z162 = n6400 + z158;
    const Scalar z249 = n2 * z238;
    const Scalar z147 = z144 - n4 * z146;
    const Scalar z299 = s_beta_2 * z298 - c_beta_2 * z297;
    const Scalar z148 = s_beta_2 * z146 - c_beta_2 * z145;
    const Scalar z300 = s_beta_2 * z297 + c_beta_2 * z298;
    const Scalar z149 = s_beta_2 * z145 + c_beta_2 * z146;
    const Scalar z301 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z166 = z162 - n4 * z165;
    const Scalar z167 = s_beta_2 * z165 - c_beta_2 * z164;
    const Scalar z168 = s_beta_2 * z164 + c_beta_2 * z165;
    const Scalar z179 = z162 - n8 * z165;
    const Scalar z182 = n4400 - z165;
    const Scalar z250 = n2 * z242;
    const Scalar z271 = z241 + n500 * z270;  // force on panel_4, y
    const Scalar z185 = c_beta_2 * z164 + s_beta_2 * z182;
    const Scalar z186 = s_beta_2 * z164 - c_beta_2 * z182;
    const Scalar z183 = k22 + z179;
    const Scalar z150 = z147 - n4 * z149;
    const Scalar z302 = n4 * z255 - z299;
    const Scalar z152 = s_beta_1 * z148 - c_beta_1 * z149;
    const Scalar z306 = a_beta_3 + z301;  // angular acceleration of panel_3, x
    const Scalar z311 = a_beta_4 + z306;  // angular acceleration of panel_4, x
    const Scalar z303 = z300 + n4 * z301;
    const Scalar z201 = z126 - z185;
    const Scalar z200 = z139 - z186;
    const Scalar z171 = s_beta_1 * z167 - c_beta_1 * z168;
    const Scalar z169 = z166 - n4 * z168;
    const Scalar z207 = s_beta_1 * z201 + c_beta_1 * z200;
    const Scalar z189 = s_beta_1 * z185 + c_beta_1 * z186;
    const Scalar z197 = z183 - n8 * z186;
    const Scalar z202 = z140 + z197;
    const Scalar z187 = z183 - n4 * z186;
    const Scalar z501 = k23 * z144;
    const Scalar z511 = z144 * z501 - z162;
    const Scalar z510 = z147 * z501 - z166;
    const Scalar z509 = z150 * z501 - z169;
    const Scalar z508 = z152 * z501 - z171;
    const Scalar z512 = n1 / z511;
    const Scalar z500 = k23 * z147;
    const Scalar z507 = z147 * z500 - z183;
    const Scalar z506 = z150 * z500 - z187;
    const Scalar z505 = z152 * z500 + z189;
    const Scalar z319 = z242 - n500 * z311;  // force on panel_4, z
    const Scalar z322 = s_beta_4 * z271 + c_beta_4 * z319;
    const Scalar z494 = k25 * z128;
    const Scalar z497 = z128 * z494 - z202;
    const Scalar z496 = z130 * z494 - z207;
    const Scalar z321 = s_beta_4 * z319 - c_beta_4 * z271;
    const Scalar z324 = z238 - n1900 * z306 + z322;  // force on panel_3, z
    const Scalar z323 = z237 + n1900 * z259 - z321;  // force on panel_3, y
    const Scalar z499 = k23 * z150;
    const Scalar z504 = z150 * z499 + z497;
    const Scalar z503 = z152 * z499 + z496;
    const Scalar z305 = s_beta_3 * z302 + c_beta_3 * z303;
    const Scalar z304 = s_beta_3 * z303 - c_beta_3 * z302;
    const Scalar z307 = n4 * z259 - z304;
    const Scalar z515 = z510 * z512;
    const Scalar z314 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z514 = z509 * z512;
    const Scalar z517 = z503 - z508 * z514;
    const Scalar z315 = n2400 * z314;  // force on engine, y
    const Scalar z326 = s_beta_3 * z324 - c_beta_3 * z323;
    const Scalar z328 = z233 + n4400 * z255 - z326;  // force on panel_2, y
    const Scalar z308 = z305 + n4 * z306;
    const Scalar z518 = z504 - z509 * z514;
    const Scalar z327 = s_beta_3 * z323 + c_beta_3 * z324;
    const Scalar z329 = z234 - n4400 * z301 + z327;  // force on panel_2, z
    const Scalar z318 = s_gamma * z315 + c_gamma * z266;
    const Scalar z317 = s_gamma * z266 - c_gamma * z315;
    const Scalar z493 = k25 * z130;
    const Scalar z495 = n20500 - z130 * z493;
    const Scalar z309 = s_beta_4 * z308 - c_beta_4 * z307;
    const Scalar z310 = s_beta_4 * z307 + c_beta_4 * z308;
    const Scalar z320 = z250 - k17 * z311 - n500 * z310;  // moment on panel_4, x
    const Scalar z521 = z507 - z510 * z515;
    const Scalar z520 = z506 - z509 * z515;
    const Scalar z325 = z249 - n6400 * z306 + n4 * z322 - n1900 * z305 + z320;  // moment on panel_3, x
    const Scalar z342 = z243 + z244 - z320;
    const Scalar z330 = z248 - k22 * z301 - n4400 * z300 + n4 * z327 + z325;  // moment on panel_2, x
    const Scalar z341 = z239 + z240 - z325;
    const Scalar z340 = z235 + z236 - z330;
    const Scalar z519 = z505 - z508 * z515;
    const Scalar z332 = s_beta_2 * z328 + c_beta_2 * z329;
    const Scalar z498 = k23 * z152;
    const Scalar z502 = z152 * z498 - z495;
    const Scalar z331 = s_beta_2 * z329 - c_beta_2 * z328;
    const Scalar z333 = z216 + n16600 * z251 + z317 - z331;  // force on panel_1, y
    const Scalar z334 = n16600 * a_beta_1 - z217 + z318 - z332;  // force on panel_1, z
    const Scalar z513 = z508 * z512;
    const Scalar z516 = z502 - z508 * z513;
    const Scalar z313 = s_gamma * z297 + c_gamma * z298;
    const Scalar z312 = s_gamma * z298 - c_gamma * z297;
    const Scalar z316 = n3580 * z314 + n2400 * z312;  // moment on engine, x
    const Scalar z652 = n500 * z88;
    const Scalar z522 = n1 / z521;
    const Scalar z649 = n2 * z63;
    const Scalar z650 = n2400 * z649;
    const Scalar z653 = c_beta_4 * z652;
    // moment on panel_1, x
    const Scalar z335 = k19 * a_beta_1 - z247 + n16600 * z296 + z316 + n4 * (z318 - z332) - z330;
    const Scalar z343 = z245 + z246 + z316;
    const Scalar z655 = s_beta_4 * z652;
    const Scalar z654 = n1900 * z81 + z653;
    const Scalar z657 = s_beta_3 * z655 - c_beta_3 * z654;
    const Scalar z656 = c_beta_3 * z655 + s_beta_3 * z654;
    const Scalar z339 = z231 + z232 + z335;
    const Scalar z524 = z520 * z522;
    const Scalar z527 = z518 - z520 * z524;
    const Scalar z526 = z517 - z519 * z524;
    const Scalar z658 = n4400 * z74 - z657;
    const Scalar z651 = s_gamma * z650;
    const Scalar z661 = c_gamma * z650;
    const Scalar z528 = n1 / z527;
    const Scalar z523 = z519 * z522;
    const Scalar z525 = z516 - z519 * z523;
    const Scalar z662 = c_beta_2 * z656 + s_beta_2 * z658;
    const Scalar z659 = s_beta_2 * z656 - c_beta_2 * z658;
    const Scalar z337 = s_beta_1 * z333 - c_beta_1 * z334;
    const Scalar z338 = n20500 * a_z - z337;  // force on fuselage, z
    const Scalar z678 = n4 * z67;
    const Scalar z660 = n16600 * z67 + z651 - z659;
    const Scalar z682 = c_beta_2 * z678;
    const Scalar z681 = s_beta_2 * z678;
    const Scalar z679 = c_gamma * z678;
    const Scalar z683 = n4 * z74 + z682;
    const Scalar z680 = n2400 * z679;
    const Scalar z665 = s_beta_4 * z241 + c_beta_4 * z242;
    const Scalar z666 = z238 + z665;
    const Scalar z667 = s_beta_4 * z242 - c_beta_4 * z241;
    const Scalar z685 = s_beta_3 * z681 - c_beta_3 * z683;
    const Scalar z684 = c_beta_3 * z681 + s_beta_3 * z683;
    const Scalar z686 = n4 * z81 - z685;
    const Scalar z668 = z237 - z667;
    const Scalar z698 = n2 * z237;
    const Scalar z697 = s_beta_2 * z296 + c_beta_2 * z295;
    const Scalar z669 = s_beta_3 * z666 - c_beta_3 * z668;
    const Scalar z687 = c_beta_4 * z684 + s_beta_4 * z686;
    const Scalar z699 = s_beta_2 * z295 - c_beta_2 * z296;
    const Scalar z688 = n500 * z687;
    const Scalar z694 = s_gamma * z295 - c_gamma * z296;
    const Scalar z695 = n2400 * z694;
    const Scalar z670 = z233 - z669;
    const Scalar z689 = n4 * z655 - z688 - n1900 * z684;
    const Scalar z696 = n2 * z233;
    const Scalar z671 = s_beta_3 * z668 + c_beta_3 * z666;
    const Scalar z672 = z234 + z671;
    const Scalar z702 = s_beta_3 * z697 + c_beta_3 * z699;
    const Scalar z700 = s_beta_3 * z699 - c_beta_3 * z697;
    const Scalar z703 = s_beta_4 * z702 + c_beta_4 * z700;
    const Scalar z690 = z689 + n4 * z656 - n4400 * z681;
    const Scalar z701 = n2 * z241;
    const Scalar z673 = s_beta_2 * z670 + c_beta_2 * z672;
    const Scalar z674 = z217 + z673;
    const Scalar z704 = z701 + n500 * z703;
    const Scalar z675 = s_beta_2 * z672 - c_beta_2 * z670;
    const Scalar z693 = n2 * z216;
    const Scalar z676 = z216 - z675;
    const Scalar z705 = n4 * z667 - z698 - n1900 * z700 - z704;
    const Scalar z677 = s_beta_1 * (z334 + z674) + c_beta_1 * (z333 - z676);
    const Scalar z663 = z661 - z662;
    const Scalar z664 = s_beta_1 * z660 - c_beta_1 * z663;
    const Scalar z691 = n4 * (z661 - z662) - z680 - z690;
    const Scalar z692 = n60000 + z691;
    const Scalar z529 = z526 * z528;
    const Scalar z530 = z525 - z526 * z529;
    const Scalar z706 = n4400 * z697 - z696 + n4 * z669 + z705;
    const Scalar z707 = n16600 * z295 - z693 + z695 + z706 + n4 * z675;
    const Scalar z531 = n1 / z530;
    const Scalar z713 = n4 * z74;
    const Scalar z745 = s_beta_4 * z305 + c_beta_4 * z304;
    const Scalar z767 = n500 * z309 - z701;
    const Scalar z746 = z701 - n500 * z745;
    const Scalar z709 = s_beta_1 * z659 - c_beta_1 * z662;
    const Scalar z708 = k3 - z707;
    const Scalar z747 = n4 * z667 - z698 + n1900 * z304 - z746;
    const Scalar z715 = c_beta_3 * z713;
    const Scalar z714 = s_beta_3 * z713;
    const Scalar z716 = n4 * z81 + z715;
    const Scalar z739 = n4 * z81;
    const Scalar z740 = s_beta_4 * z739;
    const Scalar z723 = s_beta_3 * z299 - c_beta_3 * z300;
    const Scalar z717 = c_beta_4 * z714 + s_beta_4 * z716;
    const Scalar z722 = s_beta_3 * z300 + c_beta_3 * z299;
    const Scalar z724 = s_beta_4 * z723 - c_beta_4 * z722;
    const Scalar z718 = n500 * z717;
    const Scalar z741 = n500 * z740;
    const Scalar z757 = s_beta_4 * (z241 - z271) + c_beta_4 * (z242 - z319);
    const Scalar z758 = s_beta_4 * (z242 - z319) - c_beta_4 * (z241 - z271);
    const Scalar z725 = z701 + n500 * z724;
    const Scalar z726 = n4 * z667 - z698 + n1900 * z722 - z725;
    const Scalar z719 = n4 * z655 - z718 - n1900 * z714;
    const Scalar z727 = n4400 * z299 - z696 + n4 * z669 + z726;
    const Scalar z734 = s_beta_3 * (z324 - z666) - c_beta_3 * (z323 - z668);
    const Scalar z735 = s_beta_3 * (z323 - z668) + c_beta_3 * (z324 - z666);
    const Scalar z759 = s_beta_3 * z757 + c_beta_3 * z758;
    const Scalar z760 = s_beta_3 * z758 - c_beta_3 * z757;
    const Scalar z768 = n4 * z758 + z767;
    const Scalar z752 = s_beta_3 * z653 + c_beta_3 * z655;
    const Scalar z753 = s_beta_3 * z655 - c_beta_3 * z653;
    const Scalar z742 = n4 * z655 - z741;
    const Scalar z764 = n4 * z655;
    const Scalar z711 = s_beta_2 * (z329 - z672) - c_beta_2 * (z328 - z670);
    const Scalar z710 = s_beta_2 * (z328 - z670) + c_beta_2 * (z329 - z672);
    const Scalar z712 = c_beta_1 * z711 + s_beta_1 * z710;
    const Scalar z728 = n4 * z711 - z727;
    const Scalar z730 = k5 - z727;
    const Scalar z771 = k9 - z767;
    const Scalar z778 = z501 * z704 + z705;
    const Scalar z775 = n2400 * z313;
    const Scalar z772 = s_beta_1 * z651 - c_beta_1 * z661;
    const Scalar z773 = s_beta_1 * z318 + c_beta_1 * z317;
    const Scalar z774 = n4 * z661;
    const Scalar z776 = n4 * z317 - z775;
    const Scalar z777 = n600000 + z775;
    const Scalar z779 = z706 + z500 * z704 - z515 * z778;
    const Scalar z731 = s_beta_2 * z656 + c_beta_2 * z657;
    const Scalar z732 = s_beta_2 * z657 - c_beta_2 * z656;
    const Scalar z733 = s_beta_1 * z731 + c_beta_1 * z732;
    const Scalar z736 = s_beta_2 * z734 - c_beta_2 * z735;
    const Scalar z737 = c_beta_2 * z734 + s_beta_2 * z735;
    const Scalar z748 = n4 * z734 - z747;
    const Scalar z738 = s_beta_1 * z736 - c_beta_1 * z737;
    const Scalar z749 = n4 * z737 + z748;
    const Scalar z751 = k7 - z747;
    const Scalar z761 = s_beta_2 * z759 + c_beta_2 * z760;
    const Scalar z762 = s_beta_2 * z760 - c_beta_2 * z759;
    const Scalar z769 = n4 * z759 + z768;
    const Scalar z763 = s_beta_1 * z761 + c_beta_1 * z762;
    const Scalar z770 = n4 * z762 - z769;
    const Scalar z720 = n4 * z656 + z719;
    const Scalar z743 = n4 * z656 + z742;
    const Scalar z721 = n4 * z662 + z720;
    const Scalar z729 = n28000 - z720;
    const Scalar z744 = n4 * z732 - z743;
    const Scalar z750 = n12000 - z742;
    const Scalar z798 = z501 * z725 + z726;
    const Scalar z808 = z501 * z718 + z719;
    const Scalar z788 = z501 * z688 + z689;
    const Scalar z799 = z500 * z725 - z730 - z515 * z798;
    const Scalar z809 = z500 * z718 - z729 - z515 * z808;
    const Scalar z789 = z690 + z500 * z688 - z515 * z788;
    const Scalar z800 = z499 * z725 - z728 - z514 * z798 - z524 * z799;
    const Scalar z810 = z721 + z499 * z718 - z514 * z808 - z524 * z809;
    const Scalar z780 = z494 * z695 - z499 * z704 + z514 * z778 + z708 + z524 * z779;
    const Scalar z790 = z692 + z494 * z680 - z499 * z688 + z514 * z788 + z524 * z789;
    const Scalar z801 = z498 * z725 - z712 - z513 * z798 - z523 * z799 - z529 * z800;
    const Scalar z811 = z498 * z718 - z709 - z513 * z808 - z523 * z809 - z529 * z810;
    const Scalar z781 = z493 * z695 - z677 - z498 * z704 + z513 * z778 + z523 * z779 - z529 * z780;
    const Scalar z791 = z493 * z680 - z664 - z498 * z688 + z513 * z788 + z523 * z789 - z529 * z790;
    const Scalar z802 = z531 * z801;
    const Scalar z812 = z531 * z811;
    const Scalar z782 = z531 * z781;
    const Scalar z792 = z531 * z791;
    const Scalar z783 = z528 * z780 - z529 * z782;
    const Scalar z793 = z528 * z790 - z529 * z792;
    const Scalar z803 = z528 * z800 - z529 * z802;
    const Scalar z787 = z493 * z782 - k25 * z695 + z494 * z783;
    const Scalar z797 = z493 * z792 - k25 * z680 + z494 * z793;
    const Scalar z813 = z528 * z810 - z529 * z812;
    const Scalar z784 = z522 * z779 + z523 * z782 + z524 * z783;
    const Scalar z794 = z522 * z789 + z523 * z792 + z524 * z793;
    const Scalar z804 = z522 * z799 - z523 * z802 - z524 * z803;
    const Scalar z785 = z512 * z778 + z513 * z782 + z514 * z783 - z515 * z784;
    const Scalar z786 = k23 * z704 + z498 * z782 + z499 * z783 - z500 * z784 - z501 * z785;
    const Scalar z795 = z512 * z788 + z513 * z792 + z514 * z793 - z515 * z794;
    const Scalar z796 = k23 * z688 + z498 * z792 + z499 * z793 - z500 * z794 - z501 * z795;
    const Scalar z805 = z512 * z798 - z513 * z802 - z514 * z803 - z515 * z804;
    const Scalar z806 = z498 * z802 - k23 * z725 + z499 * z803 + z500 * z804 + z501 * z805;
    const Scalar z807 = z493 * z802 + z494 * z803;
    const Scalar z754 = s_beta_2 * z752 + c_beta_2 * z753;
    const Scalar z755 = s_beta_2 * z753 - c_beta_2 * z752;
    const Scalar z765 = n4 * z752 + z764;
    const Scalar z756 = s_beta_1 * z754 + c_beta_1 * z755;
    const Scalar z766 = n4 * z755 - z765;
    const Scalar z818 = z501 * z746 - z751;
    const Scalar z828 = z501 * z741 - z750;
    const Scalar z838 = z501 * z771 + z768;
    const Scalar z848 = n5000 * z501 + z764;
    const Scalar z819 = z500 * z746 - z748 - z515 * z818;
    const Scalar z829 = z743 + z500 * z741 - z515 * z828;
    const Scalar z839 = z769 + z500 * z771 - z515 * z838;
    const Scalar z849 = z765 + n5000 * z500 - z515 * z848;
    const Scalar z820 = z499 * z746 - z749 - z514 * z818 - z524 * z819;
    const Scalar z830 = z499 * z741 - z744 - z514 * z828 - z524 * z829;
    const Scalar z840 = z499 * z771 - z770 - z514 * z838 - z524 * z839;
    const Scalar z850 = n5000 * z499 - z766 - z514 * z848 - z524 * z849;
    const Scalar z858 = z494 * z777 + z776;
    const Scalar z866 = n1200 * z494 - z774;
    const Scalar z821 = z738 + z498 * z746 - z513 * z818 - z523 * z819 - z529 * z820;
    const Scalar z831 = z498 * z741 - z733 - z513 * z828 - z523 * z829 - z529 * z830;
    const Scalar z841 = z498 * z771 - z763 - z513 * z838 - z523 * z839 - z529 * z840;
    const Scalar z822 = z531 * z821;
    const Scalar z832 = z531 * z831;
    const Scalar z842 = z531 * z841;
    const Scalar z851 = n5000 * z498 - z756 - z513 * z848 - z523 * z849 - z529 * z850;
    const Scalar z859 = z773 + z493 * z777 - z529 * z858;
    const Scalar z867 = z772 + n1200 * z493 - z529 * z866;
    const Scalar z852 = z531 * z851;
    const Scalar z860 = z531 * z859;
    const Scalar z868 = z531 * z867;
    const Scalar z823 = z528 * z820 - z529 * z822;
    const Scalar z833 = z528 * z830 - z529 * z832;
    const Scalar z843 = z528 * z840 - z529 * z842;
    const Scalar z853 = z528 * z850 - z529 * z852;
    const Scalar z861 = z528 * z858 - z529 * z860;
    const Scalar z869 = z528 * z866 - z529 * z868;
    const Scalar z865 = z493 * z860 - k25 * z777 + z494 * z861;
    const Scalar z814 = z522 * z809 - z523 * z812 - z524 * z813;
    const Scalar z824 = z522 * z819 - z523 * z822 - z524 * z823;
    const Scalar z834 = z522 * z829 - z523 * z832 - z524 * z833;
    const Scalar z844 = z522 * z839 - z523 * z842 - z524 * z843;
    const Scalar z854 = z522 * z849 - z523 * z852 - z524 * z853;
    const Scalar z815 = z512 * z808 - z513 * z812 - z514 * z813 - z515 * z814;
    const Scalar z816 = z498 * z812 - k23 * z718 + z499 * z813 + z500 * z814 + z501 * z815;
    const Scalar z817 = z493 * z812 + z494 * z813;
    const Scalar z825 = z512 * z818 - z513 * z822 - z514 * z823 - z515 * z824;
    const Scalar z826 = z498 * z822 - k23 * z746 + z499 * z823 + z500 * z824 + z501 * z825;
    const Scalar z827 = z493 * z822 + z494 * z823;
    const Scalar z835 = z512 * z828 - z513 * z832 - z514 * z833 - z515 * z834;
    const Scalar z836 = z498 * z832 - k23 * z741 + z499 * z833 + z500 * z834 + z501 * z835;
    const Scalar z837 = z493 * z832 + z494 * z833;
    const Scalar z845 = z512 * z838 - z513 * z842 - z514 * z843 - z515 * z844;
    const Scalar z846 = z498 * z842 - k23 * z771 + z499 * z843 + z500 * z844 + z501 * z845;
    const Scalar z847 = z493 * z842 + z494 * z843;
    const Scalar z855 = z512 * z848 - z513 * z852 - z514 * z853 - z515 * z854;
    const Scalar z862 = z523 * z860 + z524 * z861;
    const Scalar z856 = n3_75 - z498 * z852 - z499 * z853 - z500 * z854 - z501 * z855;
    const Scalar z870 = z523 * z868 + z524 * z869;
    const Scalar z863 = z513 * z860 + z514 * z861 - z515 * z862;
    const Scalar z871 = z513 * z868 + z514 * z869 - z515 * z870;
    const Scalar z857 = z493 * z852 + z494 * z853;
    const Scalar z864 = z498 * z860 + z499 * z861 - z500 * z862 - z501 * z863;
    const Scalar z872 = z498 * z868 + z499 * z869 - z500 * z870 - z501 * z871;
    const Scalar z873 = n60_over_179 - z493 * z868 - z494 * z869;
    result.M[0] = n20500;
    result.M[1] = z207;
    result.M[2] = -z189;
    result.M[3] = z171;
    result.M[4] = z152;
    result.M[5] = z130;
    result.M[6] = z207;
    result.M[7] = z202;
    result.M[8] = z187;
    result.M[9] = z169;
    result.M[10] = z150;
    result.M[11] = z128;
    result.M[12] = -z189;
    result.M[13] = z187;
    result.M[14] = z183;
    result.M[15] = z166;
    result.M[16] = z147;
    result.M[17] = n0;
    result.M[18] = z171;
    result.M[19] = z169;
    result.M[20] = z166;
    result.M[21] = z162;
    result.M[22] = z144;
    result.M[23] = n0;
    result.M[24] = z152;
    result.M[25] = z150;
    result.M[26] = z147;
    result.M[27] = z144;
    result.M[28] = k17;
    result.M[29] = n0;
    result.M[30] = z130;
    result.M[31] = z128;
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
    result.C[6] = -z664;
    result.C[7] = z692;
    result.C[8] = -z690;
    result.C[9] = -z689;
    result.C[10] = z688;
    result.C[11] = -z680;
    result.C[12] = z709;
    result.C[13] = -z721;
    result.C[14] = z729;
    result.C[15] = -z719;
    result.C[16] = z718;
    result.C[17] = n0;
    result.C[18] = z733;
    result.C[19] = z744;
    result.C[20] = -z743;
    result.C[21] = z750;
    result.C[22] = z741;
    result.C[23] = n0;
    result.C[24] = z756;
    result.C[25] = z766;
    result.C[26] = -z765;
    result.C[27] = -z764;
    result.C[28] = n5000;
    result.C[29] = n0;
    result.C[30] = -z772;
    result.C[31] = z774;
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
    result.K[6] = -z677;
    result.K[7] = z708;
    result.K[8] = -z706;
    result.K[9] = -z705;
    result.K[10] = z704;
    result.K[11] = -z695;
    result.K[12] = z712;
    result.K[13] = z728;
    result.K[14] = z730;
    result.K[15] = -z726;
    result.K[16] = z725;
    result.K[17] = n0;
    result.K[18] = -z738;
    result.K[19] = z749;
    result.K[20] = z748;
    result.K[21] = z751;
    result.K[22] = z746;
    result.K[23] = n0;
    result.K[24] = z763;
    result.K[25] = z770;
    result.K[26] = -z769;
    result.K[27] = -z768;
    result.K[28] = z771;
    result.K[29] = n0;
    result.K[30] = -z773;
    result.K[31] = -z776;
    result.K[32] = n0;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = z777;
    result.F[0] = -z338;
    result.F[1] = -z339;
    result.F[2] = -z340;
    result.F[3] = -z341;
    result.F[4] = -z342;
    result.F[5] = -z343;
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
    result.A[18] = z782;
    result.A[19] = z783;
    result.A[20] = -z784;
    result.A[21] = -z785;
    result.A[22] = -z786;
    result.A[23] = -z787;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = -z802;
    result.A[31] = -z803;
    result.A[32] = -z804;
    result.A[33] = -z805;
    result.A[34] = z806;
    result.A[35] = z807;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n0;
    result.A[42] = -z822;
    result.A[43] = -z823;
    result.A[44] = -z824;
    result.A[45] = -z825;
    result.A[46] = z826;
    result.A[47] = z827;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = -z842;
    result.A[55] = -z843;
    result.A[56] = -z844;
    result.A[57] = -z845;
    result.A[58] = z846;
    result.A[59] = z847;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = -z860;
    result.A[67] = -z861;
    result.A[68] = z862;
    result.A[69] = z863;
    result.A[70] = z864;
    result.A[71] = z865;
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
    result.A[90] = z792;
    result.A[91] = z793;
    result.A[92] = -z794;
    result.A[93] = -z795;
    result.A[94] = -z796;
    result.A[95] = -z797;
    result.A[96] = n0;
    result.A[97] = n0;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = -z812;
    result.A[103] = -z813;
    result.A[104] = -z814;
    result.A[105] = -z815;
    result.A[106] = z816;
    result.A[107] = z817;
    result.A[108] = n0;
    result.A[109] = n0;
    result.A[110] = n0;
    result.A[111] = n1;
    result.A[112] = n0;
    result.A[113] = n0;
    result.A[114] = -z832;
    result.A[115] = -z833;
    result.A[116] = -z834;
    result.A[117] = -z835;
    result.A[118] = z836;
    result.A[119] = z837;
    result.A[120] = n0;
    result.A[121] = n0;
    result.A[122] = n0;
    result.A[123] = n0;
    result.A[124] = n1;
    result.A[125] = n0;
    result.A[126] = -z852;
    result.A[127] = -z853;
    result.A[128] = -z854;
    result.A[129] = -z855;
    result.A[130] = -z856;
    result.A[131] = z857;
    result.A[132] = n0;
    result.A[133] = n0;
    result.A[134] = n0;
    result.A[135] = n0;
    result.A[136] = n0;
    result.A[137] = n1;
    result.A[138] = -z868;
    result.A[139] = -z869;
    result.A[140] = z870;
    result.A[141] = z871;
    result.A[142] = z872;
    result.A[143] = -z873;
    if (!(traits::regular(-z530, n20500) && traits::regular(-z527, z202) && traits::regular(-z521, z183)
        && traits::regular(-z511, z162))) return torsor::Status::singular;
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
