// SPDX-License-Identifier: MIT
// arm7: Arm with seven revolute joints
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              252              343          0             0                  7       0    609     609
//   mass_matrix             162              181          0             0                  6       0    355     395
//   bias                    266              292          0             0                  6       0    570     684
//   inverse_dynamics        285              300          0             0                  6       0    597     715
//   forward_dynamics        515              586          6             0                  6       0   1119    1273
//   energy                  221              306          0             0                  6       0    539     577
//   linearisation          2054             2386          6             0                  6       0   4458    4732
//
// Not computed because this mechanism does not need it:
//   kinematics: of 153 results 12 vanish identically, 20 repeat another up to sign
//   mass_matrix: of 49 results 21 repeat another up to sign
//   first_integrals: left out, 'tau1', 'tau2', 'tau3', 'tau4', 'tau5', 'tau6', 'tau7' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 497 results 197 vanish identically, 22 repeat another up to sign
//
// To write this file again:
//   arm7_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output arm7.hpp
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

namespace arm7 {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "arm7";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x76f9345f689d87f0ULL;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 7;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar q1;  ///< coordinate [rad or 1]
    Scalar q2;  ///< coordinate [rad or 1]
    Scalar q3;  ///< coordinate [rad or 1]
    Scalar q4;  ///< coordinate [rad or 1]
    Scalar q5;  ///< coordinate [rad or 1]
    Scalar q6;  ///< coordinate [rad or 1]
    Scalar q7;  ///< coordinate [rad or 1]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::q1, &Coordinates::q2, &Coordinates::q3,
          &Coordinates::q4, &Coordinates::q5, &Coordinates::q6, &Coordinates::q7};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar q1;  ///< its rate [rad/s]
    Scalar q2;  ///< its rate [rad/s]
    Scalar q3;  ///< its rate [rad/s]
    Scalar q4;  ///< its rate [rad/s]
    Scalar q5;  ///< its rate [rad/s]
    Scalar q6;  ///< its rate [rad/s]
    Scalar q7;  ///< its rate [rad/s]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::q1, &Velocities::q2, &Velocities::q3, &Velocities::q4,
          &Velocities::q5, &Velocities::q6, &Velocities::q7};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar q1;  ///< its second rate [rad/s^2]
    Scalar q2;  ///< its second rate [rad/s^2]
    Scalar q3;  ///< its second rate [rad/s^2]
    Scalar q4;  ///< its second rate [rad/s^2]
    Scalar q5;  ///< its second rate [rad/s^2]
    Scalar q6;  ///< its second rate [rad/s^2]
    Scalar q7;  ///< its second rate [rad/s^2]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::q1, &Accelerations::q2, &Accelerations::q3,
          &Accelerations::q4, &Accelerations::q5, &Accelerations::q6, &Accelerations::q7};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar q1;  ///< works with the rate of q1 [N m]
    Scalar q2;  ///< works with the rate of q2 [N m]
    Scalar q3;  ///< works with the rate of q3 [N m]
    Scalar q4;  ///< works with the rate of q4 [N m]
    Scalar q5;  ///< works with the rate of q5 [N m]
    Scalar q6;  ///< works with the rate of q6 [N m]
    Scalar q7;  ///< works with the rate of q7 [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::q1, &GeneralizedForces::q2,
          &GeneralizedForces::q3, &GeneralizedForces::q4, &GeneralizedForces::q5, &GeneralizedForces::q6,
          &GeneralizedForces::q7};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar tau1;  ///< motor [N m]
    Scalar tau2;  ///< motor [N m]
    Scalar tau3;  ///< motor [N m]
    Scalar tau4;  ///< motor [N m]
    Scalar tau5;  ///< motor [N m]
    Scalar tau6;  ///< motor [N m]
    Scalar tau7;  ///< motor [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::tau1, &Inputs::tau2, &Inputs::tau3, &Inputs::tau4, &Inputs::tau5,
          &Inputs::tau6, &Inputs::tau7};
      return members_[i_];
    }
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1_9 = traits::constant(1.9, 1.9f, "19/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    state.time = n0;
    state.q.q1 = n0_3;
    state.q.q2 = -n0_7;
    state.q.q3 = n0_4;
    state.q.q4 = -n1_9;
    state.q.q5 = n0_2;
    state.q.q6 = n1_6;
    state.q.q7 = -n0_5;
    state.v.q1 = n0;
    state.v.q2 = n0;
    state.v.q3 = n0;
    state.v.q4 = n0;
    state.v.q5 = n0;
    state.v.q6 = n0;
    state.v.q7 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> link1_position;  ///< centre of mass of link1 [m]
    std::array<Scalar, 9> link1_rotation;  ///< from the axes of link1 to the ground's (3 x 3)
    std::array<Scalar, 3> link1_velocity;  ///< velocity of the centre of mass of link1 [m/s]
    std::array<Scalar, 3> link1_angular_velocity;  ///< angular velocity of link1 [rad/s]
    std::array<Scalar, 3> link2_position;  ///< centre of mass of link2 [m]
    std::array<Scalar, 9> link2_rotation;  ///< from the axes of link2 to the ground's (3 x 3)
    std::array<Scalar, 3> link2_velocity;  ///< velocity of the centre of mass of link2 [m/s]
    std::array<Scalar, 3> link2_angular_velocity;  ///< angular velocity of link2 [rad/s]
    std::array<Scalar, 3> link3_position;  ///< centre of mass of link3 [m]
    std::array<Scalar, 9> link3_rotation;  ///< from the axes of link3 to the ground's (3 x 3)
    std::array<Scalar, 3> link3_velocity;  ///< velocity of the centre of mass of link3 [m/s]
    std::array<Scalar, 3> link3_angular_velocity;  ///< angular velocity of link3 [rad/s]
    std::array<Scalar, 3> link4_position;  ///< centre of mass of link4 [m]
    std::array<Scalar, 9> link4_rotation;  ///< from the axes of link4 to the ground's (3 x 3)
    std::array<Scalar, 3> link4_velocity;  ///< velocity of the centre of mass of link4 [m/s]
    std::array<Scalar, 3> link4_angular_velocity;  ///< angular velocity of link4 [rad/s]
    std::array<Scalar, 3> link5_position;  ///< centre of mass of link5 [m]
    std::array<Scalar, 9> link5_rotation;  ///< from the axes of link5 to the ground's (3 x 3)
    std::array<Scalar, 3> link5_velocity;  ///< velocity of the centre of mass of link5 [m/s]
    std::array<Scalar, 3> link5_angular_velocity;  ///< angular velocity of link5 [rad/s]
    std::array<Scalar, 3> link6_position;  ///< centre of mass of link6 [m]
    std::array<Scalar, 9> link6_rotation;  ///< from the axes of link6 to the ground's (3 x 3)
    std::array<Scalar, 3> link6_velocity;  ///< velocity of the centre of mass of link6 [m/s]
    std::array<Scalar, 3> link6_angular_velocity;  ///< angular velocity of link6 [rad/s]
    std::array<Scalar, 3> link7_position;  ///< centre of mass of link7 [m]
    std::array<Scalar, 9> link7_rotation;  ///< from the axes of link7 to the ground's (3 x 3)
    std::array<Scalar, 3> link7_velocity;  ///< velocity of the centre of mass of link7 [m/s]
    std::array<Scalar, 3> link7_angular_velocity;  ///< angular velocity of link7 [rad/s]
    std::array<Scalar, 3> tip_position;  ///< position of tip [m]
    std::array<Scalar, 3> tip_velocity;  ///< velocity of the material point at tip [m/s]
    std::array<Scalar, 21> tip_jacobian;  ///< partial velocities of tip (3 x 7)
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
    std::array<Scalar, 49> M;  ///< mass matrix (7 x 7)
    std::array<Scalar, 49> C;  ///< damping and gyroscopic terms (7 x 7)
    std::array<Scalar, 49> K;  ///< stiffness (7 x 7)
    std::array<Scalar, 7> F;  ///< right-hand side
    std::array<Scalar, 49> E;  ///< effect of the inputs (7 x 7)
    std::array<Scalar, 196> A;  ///< state matrix of x = (e, e'): x' = A x + B du (14 x 14)
    std::array<Scalar, 98> B;  ///< input matrix (14 x 7)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k5 = traits::constant(0.002081, 0.002081f, "2081/1000000");
    const Scalar k6 = traits::constant(0.003875, 0.003875f, "31/8000");
    const Scalar k7 = traits::constant(0.003495, 0.003495f, "699/200000");
    const Scalar k8 = traits::constant(0.003141, 0.003141f, "3141/1000000");
    const Scalar k9 = traits::constant(0.02872, 0.02872f, "359/12500");
    const Scalar k10 = traits::constant(0.039252, 0.039252f, "9813/250000");
    const Scalar k11 = traits::constant(0.066502, 0.066502f, "33251/500000");
    const Scalar k12 = traits::constant(0.027518, 0.027518f, "13759/500000");
    const Scalar k13 = traits::constant(0.104419, 0.104419f, "104419/1000000");
    const Scalar k14 = traits::constant(0.027454, 0.027454f, "13727/500000");
    const Scalar k15 = traits::constant(0.05317, 0.05317f, "5317/100000");
    const Scalar k16 = traits::constant(0.038437, 0.038437f, "38437/1000000");
    const Scalar k17 = traits::constant(0.041065, 0.041065f, "8213/200000");
    const Scalar k18 = traits::constant(0.011953, 0.011953f, "11953/1000000");
    const Scalar k19 = traits::constant(0.060149, 0.060149f, "60149/1000000");
    const Scalar k20 = traits::constant(0.010517, 0.010517f, "10517/1000000");
    const Scalar k21 = traits::constant(0.014117, 0.014117f, "14117/1000000");
    const Scalar n0_107 = traits::constant(0.107, 0.107f, "107/1000");
    const Scalar k23 = traits::constant(0.004252, 0.004252f, "1063/250000");
    const Scalar k24 = traits::constant(0.061597, 0.061597f, "61597/1000000");
    const Scalar n0_158 = traits::constant(0.158, 0.158f, "79/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_q1 = state.q.q1;
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar angles_[] = {q_q1, q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q1 = sines_[0], c_q1 = cosines_[0];
    const Scalar s_q2 = sines_[1], c_q2 = cosines_[1];
    const Scalar s_q3 = sines_[2], c_q3 = cosines_[2];
    const Scalar s_q4 = sines_[3], c_q4 = cosines_[3];
    const Scalar s_q5 = sines_[4], c_q5 = cosines_[4];
    const Scalar s_q6 = sines_[5], c_q6 = cosines_[5];
    const Scalar s_q7 = sines_[6], c_q7 = cosines_[6];
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z37 = s_q1 * c_q2;
    const Scalar z53 = n0_316 * v_q2;
    const Scalar z35 = c_q1 * c_q2;
    const Scalar z38 = s_q1 * s_q2;
    const Scalar z48 = s_q2 * s_q3;
    const Scalar z63 = s_q2 * z53;  // velocity of link3, z
    const Scalar z36 = c_q1 * s_q2;
    const Scalar z47 = s_q2 * c_q3;
    const Scalar z41 = s_q1 * v_q2;  // angular velocity of link2, x
    const Scalar z42 = c_q1 * v_q2;  // angular velocity of link2, y
    const Scalar z60 = v_q1 + c_q2 * v_q3;  // angular velocity of link3, z
    const Scalar z51 = n0_316 * c_q2;
    const Scalar z43 = s_q1 * s_q3 - c_q3 * z35;
    const Scalar z44 = s_q1 * c_q3 + s_q3 * z35;
    const Scalar z45 = c_q1 * s_q3 + c_q3 * z37;
    const Scalar z46 = c_q1 * c_q3 - s_q3 * z37;
    const Scalar z49 = n0_316 * z36;
    const Scalar z50 = n0_316 * z38;
    const Scalar z52 = n0_333 + z51;  // place of link3, z
    const Scalar z54 = n0_316 * z39;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z58 = v_q3 * z36 - z41;  // angular velocity of link3, x
    const Scalar z59 = v_q3 * z38 + z42;  // angular velocity of link3, y
    const Scalar z68 = c_q2 * s_q4 - c_q4 * z47;
    const Scalar z69 = c_q2 * c_q4 + s_q4 * z47;
    const Scalar z72 = n0_0825 * z47;
    const Scalar z83 = v_q4 * z48 - z60;  // angular velocity of link4, z
    const Scalar z61 = s_q1 * z54 - z35 * z53;  // velocity of link3, x
    const Scalar z62 = z37 * z53 + c_q1 * z54;  // velocity of link3, y
    const Scalar z75 = z52 - z72;  // place of link4, z
    const Scalar z76 = n0_0825 * z57;
    const Scalar z64 = s_q4 * z36 - c_q4 * z43;
    const Scalar z65 = c_q4 * z36 + s_q4 * z43;
    const Scalar z66 = s_q4 * z38 + c_q4 * z45;
    const Scalar z67 = s_q4 * z45 - c_q4 * z38;
    const Scalar z70 = n0_0825 * z43;
    const Scalar z71 = n0_0825 * z45;
    const Scalar z77 = n0_0825 * z56;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z81 = v_q4 * z44 + z58;  // angular velocity of link4, x
    const Scalar z82 = v_q4 * z46 - z59;  // angular velocity of link4, y
    const Scalar z107 = v_q5 * z69 - z83;  // angular velocity of link5, z
    const Scalar z91 = s_q5 * z48 + c_q5 * z68;
    const Scalar z85 = z38 * z77 - z62 - z46 * z76;  // velocity of link4, y
    const Scalar z105 = v_q5 * z65 + z81;  // angular velocity of link5, x
    const Scalar z84 = z61 + z44 * z76 + z36 * z77;  // velocity of link4, x
    const Scalar z86 = z63 - z48 * z76 + c_q2 * z77;  // velocity of link4, z
    const Scalar z106 = v_q5 * z67 + z82;  // angular velocity of link5, y
    const Scalar z99 = n0_384 * z80;
    const Scalar z101 = n0_384 * z78 - n0_0825 * z79;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z104 = v_q5 - z79;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z100 = n0_0825 * z80;
    const Scalar z87 = s_q5 * z44 - c_q5 * z64;
    const Scalar z119 = v_q6 + z103;
    const Scalar z89 = s_q5 * z46 + c_q5 * z66;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z111 = s_q6 * z65 - c_q6 * z87;
    const Scalar z112 = c_q6 * z65 + s_q6 * z87;
    const Scalar z88 = c_q5 * z44 + s_q5 * z64;
    const Scalar z120 = v_q6 * z88 + z105;  // angular velocity of link6, x
    const Scalar z90 = s_q5 * z66 - c_q5 * z46;
    const Scalar z121 = v_q6 * z90 - z106;  // angular velocity of link6, y
    const Scalar z92 = s_q5 * z68 - c_q5 * z48;
    const Scalar z122 = v_q6 * z92 + z107;  // angular velocity of link6, z
    const Scalar z108 = z44 * z101 - z84 - z64 * z99 - z65 * z100;  // velocity of link5, x
    const Scalar z109 = z85 + z66 * z99 - z67 * z100 + z46 * z101;  // velocity of link5, y
    const Scalar z110 = z86 + z68 * z99 + z69 * z100 + z48 * z101;  // velocity of link5, z
    const Scalar z113 = s_q6 * z67 - c_q6 * z89;
    const Scalar z114 = c_q6 * z67 + s_q6 * z89;
    const Scalar z115 = s_q6 * z69 + c_q6 * z91;
    const Scalar z116 = s_q6 * z91 - c_q6 * z69;
    const Scalar z129 = n0_088 * z111;
    const Scalar z93 = n0_0825 * z64 - n0_384 * z65;
    const Scalar z130 = n0_088 * z113;
    const Scalar z131 = n0_088 * z115;
    const Scalar z94 = n0_0825 * z66 + n0_384 * z67;
    const Scalar z95 = n0_0825 * z68 - n0_384 * z69;
    const Scalar z123 = s_q7 * z88 + c_q7 * z111;
    const Scalar z125 = s_q7 * z90 - c_q7 * z113;
    const Scalar z127 = s_q7 * z92 + c_q7 * z115;
    const Scalar z73 = z49 - z70;  // place of link4, x
    const Scalar z74 = z50 + z71;  // place of link4, y
    const Scalar z140 = v_q7 * z112 - z120;  // angular velocity of link7, x
    const Scalar z141 = v_q7 * z114 + z121;  // angular velocity of link7, y
    const Scalar z142 = v_q7 * z116 + z122;  // angular velocity of link7, z
    const Scalar z146 = k5 * s_q1 - k6 * c_q1;
    const Scalar z147 = k6 * s_q1 + k5 * c_q1;
    const Scalar z152 = k7 * s_q1 + k8 * z35 - k9 * z36;
    const Scalar z153 = k7 * c_q1 - k8 * z37 + k9 * z38;
    const Scalar z136 = n0_088 * z118;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z135 = n0_088 * z119;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z143 = z88 * z136 - z108 - z112 * z135;  // velocity of link7, x
    const Scalar z144 = z90 * z136 + z109 + z114 * z135;  // velocity of link7, y
    const Scalar z145 = z92 * z136 + z110 + z116 * z135;  // velocity of link7, z
    const Scalar z124 = s_q7 * z111 - c_q7 * z88;
    const Scalar z126 = c_q7 * z90 + s_q7 * z113;
    const Scalar z128 = s_q7 * z115 - c_q7 * z92;
    const Scalar z148 = k5 * v_q1;
    const Scalar z149 = k6 * v_q1;
    const Scalar z150 = s_q1 * z149 + c_q1 * z148;
    const Scalar z151 = s_q1 * z148 - c_q1 * z149;
    const Scalar z96 = z73 - z93;  // place of link5, x
    const Scalar z156 = k9 * v_q2 - k7 * z40;
    const Scalar z97 = z74 - z94;  // place of link5, y
    const Scalar z157 = k8 * v_q2 - k7 * z39;
    const Scalar z98 = z75 - z95;  // place of link5, z
    const Scalar z158 = k9 * z39 - k8 * z40;
    const Scalar z159 = s_q1 * z158 - z35 * z156 - z36 * z157;
    const Scalar z160 = z37 * z156 + z38 * z157 + c_q1 * z158;
    const Scalar z161 = s_q2 * z156 - c_q2 * z157;
    const Scalar z168 = k10 * z57 + k11 * z56;
    const Scalar z169 = k12 * z57 + k11 * z55;
    const Scalar z170 = k10 * z55 - k12 * z56;
    const Scalar z171 = z43 * z168 - z61 - z44 * z169 + z36 * z170;
    const Scalar z172 = z62 - z45 * z168 + z46 * z169 + z38 * z170;
    const Scalar z173 = z47 * z168 - z63 + z48 * z169 + c_q2 * z170;
    const Scalar z162 = k11 * z36 + k12 * z43 + k10 * z44;
    const Scalar z165 = z49 - z162;
    const Scalar z163 = k11 * z38 - k12 * z45 - k10 * z46;
    const Scalar z166 = z50 - z163;
    const Scalar z164 = k11 * c_q2 + k12 * z47 - k10 * z48;
    const Scalar z167 = z52 - z164;
    const Scalar z180 = k13 * z80 + k14 * z79;
    const Scalar z181 = k15 * z80 + k14 * z78;
    const Scalar z182 = k13 * z78 - k15 * z79;
    const Scalar z183 = z44 * z182 - z84 - z65 * z181 - z64 * z180;
    const Scalar z184 = z85 + z66 * z180 - z67 * z181 + z46 * z182;
    const Scalar z185 = z69 * z181 + z86 + z68 * z180 + z48 * z182;
    const Scalar z174 = k14 * z44 - k15 * z64 + k13 * z65;
    const Scalar z177 = z73 + z174;
    const Scalar z175 = k14 * z46 + k15 * z66 + k13 * z67;
    const Scalar z178 = z74 - z175;
    const Scalar z176 = k14 * z48 + k15 * z68 - k13 * z69;
    const Scalar z179 = z75 - z176;
    const Scalar z132 = z96 + z129;  // place of link7, x
    const Scalar z192 = k16 * z103 - k17 * z104;
    const Scalar z133 = z97 - z130;  // place of link7, y
    const Scalar z193 = k16 * z102 + k18 * z104;
    const Scalar z134 = z98 + z131;  // place of link7, z
    const Scalar z194 = k17 * z102 + k18 * z103;
    const Scalar z195 = z65 * z194 - z108 + z87 * z192 - z88 * z193;
    const Scalar z186 = k16 * z65 - k18 * z87 + k17 * z88;
    const Scalar z189 = z96 - z186;
    const Scalar z196 = z67 * z194 - z109 + z89 * z192 + z90 * z193;
    const Scalar z197 = z110 + z69 * z194 - z91 * z192 - z92 * z193;
    const Scalar z187 = k16 * z67 - k18 * z89 - k17 * z90;
    const Scalar z190 = z97 + z187;
    const Scalar z188 = k16 * z69 + k18 * z91 + k17 * z92;
    const Scalar z191 = z98 - z188;
    const Scalar z205 = k19 * z119 + k20 * z117;
    const Scalar z206 = k21 * z117 + k19 * z118;
    const Scalar z204 = k20 * z118 - k21 * z119;
    const Scalar z207 = z88 * z206 - z108 + z111 * z204 - z112 * z205;
    const Scalar z208 = z114 * z205 + z109 + z90 * z206 - z113 * z204;
    const Scalar z209 = z116 * z205 + z110 + z92 * z206 + z115 * z204;
    const Scalar z198 = k20 * z88 - k19 * z111 + k21 * z112;
    const Scalar z201 = z96 - z198;
    const Scalar z199 = k20 * z90 + k19 * z113 - k21 * z114;
    const Scalar z202 = z97 - z199;
    const Scalar z200 = k20 * z92 - k19 * z115 - k21 * z116;
    const Scalar z203 = z98 - z200;
    const Scalar z154 = k8 * s_q2 + k9 * c_q2;
    const Scalar z155 = n0_333 + z154;
    const Scalar z222 = n0_107 * z112;
    const Scalar z236 = z129 - z222;
    const Scalar z230 = z132 - z222;
    const Scalar z223 = n0_107 * z114;
    const Scalar z237 = z130 - z223;
    const Scalar z231 = z133 + z223;
    const Scalar z224 = n0_107 * z116;
    const Scalar z238 = z131 + z224;
    const Scalar z232 = z134 + z224;
    const Scalar z245 = z93 - z236;
    const Scalar z246 = z94 + z237;
    const Scalar z241 = z90 * z236 + z88 * z237;
    const Scalar z239 = z90 * z238 + z92 * z237;
    const Scalar z240 = z88 * z238 - z92 * z236;
    const Scalar z247 = z95 - z238;
    const Scalar z251 = z70 + z245;
    const Scalar z252 = z71 - z246;
    const Scalar z253 = z72 + z247;
    const Scalar z257 = z49 - z251;
    const Scalar z258 = z50 + z252;
    const Scalar z242 = z67 * z238 - z69 * z237;
    const Scalar z243 = z65 * z238 - z69 * z236;
    const Scalar z244 = z65 * z237 - z67 * z236;
    const Scalar z262 = c_q1 * z257 + s_q1 * z258;
    const Scalar z259 = z51 - z253;
    const Scalar z248 = z46 * z247 - z48 * z246;
    const Scalar z249 = z44 * z247 + z48 * z245;
    const Scalar z250 = z46 * z245 + z44 * z246;
    const Scalar z254 = z38 * z253 + c_q2 * z252;
    const Scalar z256 = z38 * z251 + z36 * z252;
    const Scalar z255 = c_q2 * z251 - z36 * z253;
    const Scalar z218 = k23 * z137 - k20 * z138;
    const Scalar z260 = c_q1 * z259;
    const Scalar z261 = s_q1 * z259;
    const Scalar z217 = k24 * z137 - k20 * z139;
    const Scalar z226 = n0_107 * z137;
    const Scalar z216 = k24 * z138 - k23 * z139;
    const Scalar z225 = n0_107 * z138;
    const Scalar z219 = z112 * z218 - z143 + z124 * z217 - z123 * z216;
    const Scalar z227 = z143 + z123 * z225 - z124 * z226;
    const Scalar z210 = k24 * z112 - k20 * z123 - k23 * z124;
    const Scalar z211 = k24 * z114 + k20 * z125 - k23 * z126;
    const Scalar z212 = k24 * z116 + k20 * z127 + k23 * z128;
    const Scalar z213 = z132 - z210;
    const Scalar z214 = z133 + z211;
    const Scalar z215 = z134 + z212;
    const Scalar z220 = z144 + z114 * z218 + z126 * z217 + z125 * z216;
    const Scalar z221 = z145 + z116 * z218 - z128 * z217 + z127 * z216;
    const Scalar z228 = z144 + z126 * z226 + z125 * z225;
    const Scalar z229 = z145 + z127 * z225 - z128 * z226;
    result.link1_position[0] = -z146;
    result.link1_position[1] = z147;
    result.link1_position[2] = n0_158;
    result.link1_rotation[0] = c_q1;
    result.link1_rotation[1] = s_q1;
    result.link1_rotation[2] = n0;
    result.link1_rotation[3] = -s_q1;
    result.link1_rotation[4] = c_q1;
    result.link1_rotation[5] = n0;
    result.link1_rotation[6] = n0;
    result.link1_rotation[7] = n0;
    result.link1_rotation[8] = n1;
    result.link1_velocity[0] = -z150;
    result.link1_velocity[1] = -z151;
    result.link1_velocity[2] = n0;
    result.link1_angular_velocity[0] = n0;
    result.link1_angular_velocity[1] = n0;
    result.link1_angular_velocity[2] = v_q1;
    result.link2_position[0] = -z152;
    result.link2_position[1] = z153;
    result.link2_position[2] = z155;
    result.link2_rotation[0] = z35;
    result.link2_rotation[1] = z37;
    result.link2_rotation[2] = -s_q2;
    result.link2_rotation[3] = -z36;
    result.link2_rotation[4] = -z38;
    result.link2_rotation[5] = -c_q2;
    result.link2_rotation[6] = -s_q1;
    result.link2_rotation[7] = c_q1;
    result.link2_rotation[8] = n0;
    result.link2_velocity[0] = -z159;
    result.link2_velocity[1] = z160;
    result.link2_velocity[2] = -z161;
    result.link2_angular_velocity[0] = -z41;
    result.link2_angular_velocity[1] = z42;
    result.link2_angular_velocity[2] = v_q1;
    result.link3_position[0] = z165;
    result.link3_position[1] = z166;
    result.link3_position[2] = z167;
    result.link3_rotation[0] = -z43;
    result.link3_rotation[1] = z45;
    result.link3_rotation[2] = -z47;
    result.link3_rotation[3] = -z44;
    result.link3_rotation[4] = z46;
    result.link3_rotation[5] = z48;
    result.link3_rotation[6] = z36;
    result.link3_rotation[7] = z38;
    result.link3_rotation[8] = c_q2;
    result.link3_velocity[0] = z171;
    result.link3_velocity[1] = z172;
    result.link3_velocity[2] = z173;
    result.link3_angular_velocity[0] = z58;
    result.link3_angular_velocity[1] = z59;
    result.link3_angular_velocity[2] = z60;
    result.link4_position[0] = z177;
    result.link4_position[1] = z178;
    result.link4_position[2] = z179;
    result.link4_rotation[0] = z64;
    result.link4_rotation[1] = z66;
    result.link4_rotation[2] = z68;
    result.link4_rotation[3] = z65;
    result.link4_rotation[4] = -z67;
    result.link4_rotation[5] = z69;
    result.link4_rotation[6] = z44;
    result.link4_rotation[7] = -z46;
    result.link4_rotation[8] = -z48;
    result.link4_velocity[0] = z183;
    result.link4_velocity[1] = -z184;
    result.link4_velocity[2] = -z185;
    result.link4_angular_velocity[0] = z81;
    result.link4_angular_velocity[1] = -z82;
    result.link4_angular_velocity[2] = -z83;
    result.link5_position[0] = z189;
    result.link5_position[1] = z190;
    result.link5_position[2] = z191;
    result.link5_rotation[0] = -z87;
    result.link5_rotation[1] = z89;
    result.link5_rotation[2] = z91;
    result.link5_rotation[3] = -z88;
    result.link5_rotation[4] = -z90;
    result.link5_rotation[5] = -z92;
    result.link5_rotation[6] = z65;
    result.link5_rotation[7] = -z67;
    result.link5_rotation[8] = z69;
    result.link5_velocity[0] = -z195;
    result.link5_velocity[1] = z196;
    result.link5_velocity[2] = -z197;
    result.link5_angular_velocity[0] = z105;
    result.link5_angular_velocity[1] = -z106;
    result.link5_angular_velocity[2] = z107;
    result.link6_position[0] = z201;
    result.link6_position[1] = z202;
    result.link6_position[2] = z203;
    result.link6_rotation[0] = z111;
    result.link6_rotation[1] = -z113;
    result.link6_rotation[2] = z115;
    result.link6_rotation[3] = z112;
    result.link6_rotation[4] = -z114;
    result.link6_rotation[5] = -z116;
    result.link6_rotation[6] = z88;
    result.link6_rotation[7] = z90;
    result.link6_rotation[8] = z92;
    result.link6_velocity[0] = -z207;
    result.link6_velocity[1] = -z208;
    result.link6_velocity[2] = -z209;
    result.link6_angular_velocity[0] = z120;
    result.link6_angular_velocity[1] = z121;
    result.link6_angular_velocity[2] = z122;
    result.link7_position[0] = z213;
    result.link7_position[1] = z214;
    result.link7_position[2] = z215;
    result.link7_rotation[0] = z123;
    result.link7_rotation[1] = z125;
    result.link7_rotation[2] = z127;
    result.link7_rotation[3] = -z124;
    result.link7_rotation[4] = z126;
    result.link7_rotation[5] = -z128;
    result.link7_rotation[6] = -z112;
    result.link7_rotation[7] = z114;
    result.link7_rotation[8] = z116;
    result.link7_velocity[0] = z219;
    result.link7_velocity[1] = -z220;
    result.link7_velocity[2] = -z221;
    result.link7_angular_velocity[0] = -z140;
    result.link7_angular_velocity[1] = z141;
    result.link7_angular_velocity[2] = z142;
    result.tip_position[0] = z230;
    result.tip_position[1] = z231;
    result.tip_position[2] = z232;
    result.tip_velocity[0] = -z227;
    result.tip_velocity[1] = -z228;
    result.tip_velocity[2] = -z229;
    result.tip_jacobian[0] = -z258;
    result.tip_jacobian[3] = z260;
    result.tip_jacobian[6] = -z254;
    result.tip_jacobian[9] = z248;
    result.tip_jacobian[12] = -z242;
    result.tip_jacobian[15] = z239;
    result.tip_jacobian[18] = n0;
    result.tip_jacobian[1] = z257;
    result.tip_jacobian[4] = z261;
    result.tip_jacobian[7] = -z255;
    result.tip_jacobian[10] = z249;
    result.tip_jacobian[13] = -z243;
    result.tip_jacobian[16] = -z240;
    result.tip_jacobian[19] = n0;
    result.tip_jacobian[2] = n0;
    result.tip_jacobian[5] = -z262;
    result.tip_jacobian[8] = z256;
    result.tip_jacobian[11] = -z250;
    result.tip_jacobian[14] = -z244;
    result.tip_jacobian[17] = -z241;
    result.tip_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 49>& mass) noexcept {
    const Scalar k0 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k1 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k2 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k3 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k4 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k5 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k6 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k10 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k11 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k12 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k15 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k16 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k17 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k19 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k22 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k23 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k24 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k25 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k27 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k28 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k38 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k43 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k44 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k47 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k48 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar q_q2 = state.q.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z296 = k0 * s_q7 - k1 * c_q7;
    const Scalar z265 = k2 * s_q7 + k3 * c_q7;
    const Scalar z266 = k4 * s_q7 - k5 * c_q7;
    const Scalar z264 = k3 * s_q7 - k2 * c_q7;
    const Scalar z267 = k5 * s_q7 + k4 * c_q7;
    const Scalar z268 = k6 + n16_over_15 * z265;
    const Scalar z269 = c_q6 * z264;
    const Scalar z270 = s_q6 * z264;
    const Scalar z297 = s_q7 * z296;
    const Scalar z299 = k8 + c_q7 * z296;
    const Scalar z301 = k6 + n32_over_15 * z265;
    const Scalar z303 = k10 + z265;
    const Scalar z305 = k11 - z266;
    const Scalar z307 = k12 + z267;
    const Scalar z273 = s_q5 * z265 - c_q5 * z269;
    const Scalar z274 = c_q5 * z265 + s_q5 * z269;
    const Scalar z298 = k0 - z297;
    const Scalar z302 = n32_over_15 * z265 + z297;
    const Scalar z309 = s_q6 * z303 - k13 * c_q6;
    const Scalar z310 = k13 * s_q6 + c_q6 * z303;
    const Scalar z271 = c_q6 * z266 + s_q6 * z268;
    const Scalar z337 = n2 * z305;
    const Scalar z272 = s_q6 * z266 - c_q6 * z268;
    const Scalar z300 = n16_over_15 * z264 - z299;
    const Scalar z304 = k15 - z298;
    const Scalar z280 = s_q4 * z270 + c_q4 * z273;
    const Scalar z281 = s_q4 * z273 - c_q4 * z270;
    const Scalar z308 = k16 + z302;
    const Scalar z275 = s_q5 * z267 - c_q5 * z271;
    const Scalar z276 = c_q5 * z267 + s_q5 * z271;
    const Scalar z278 = z272 + z274;
    const Scalar z306 = k17 + z300;
    const Scalar z336 = z301 + z304;
    const Scalar z313 = c_q5 * z309;
    const Scalar z314 = s_q5 * z309;
    const Scalar z286 = s_q3 * z274 + c_q3 * z280;
    const Scalar z287 = s_q3 * z280 - c_q3 * z274;
    const Scalar z311 = s_q6 * z307 + c_q6 * z306;
    const Scalar z312 = s_q6 * z306 - c_q6 * z307;
    const Scalar z277 = n256_over_55 * z274 - z275;
    const Scalar z344 = k19 - z264;
    const Scalar z343 = k20 - z310;
    const Scalar z279 = z270 - n256_over_55 * z273 - z276;
    const Scalar z338 = s_q6 * z336 - c_q6 * z337;
    const Scalar z320 = s_q4 * z310 + c_q4 * z313;
    const Scalar z321 = s_q4 * z313 - c_q4 * z310;
    const Scalar z284 = z279 + z281;
    const Scalar z315 = s_q5 * z308 - c_q5 * z311;
    const Scalar z316 = c_q5 * z308 + s_q5 * z311;
    const Scalar z346 = k21 - z311;
    const Scalar z282 = s_q4 * z278 - c_q4 * z277;
    const Scalar z283 = c_q4 * z278 + s_q4 * z277;
    const Scalar z348 = k22 + z312;
    const Scalar z319 = z310 - n256_over_55 * z313 - z316;
    const Scalar z285 = z274 - z283;
    const Scalar z342 = c_q6 * z338 + z305;
    const Scalar z324 = z319 + z321;
    const Scalar z339 = s_q6 * z338;
    const Scalar z340 = z304 - z339;
    const Scalar z341 = z301 - z339;
    const Scalar z347 = k23 + z342;
    const Scalar z351 = s_q5 * z344 + c_q5 * z343;
    const Scalar z350 = s_q5 * z343 - c_q5 * z344;
    const Scalar z345 = k24 - z340;
    const Scalar z349 = k25 + z341;
    const Scalar z353 = s_q5 * z347 - c_q5 * z348;
    const Scalar z352 = s_q5 * z348 + c_q5 * z347;
    const Scalar z318 = z312 - z314;
    const Scalar z317 = n256_over_55 * z314 + z315;
    const Scalar z322 = s_q4 * z318 + c_q4 * z317;
    const Scalar z323 = s_q4 * z317 - c_q4 * z318;
    const Scalar z288 = s_q3 * z284 - c_q3 * z282;
    const Scalar z290 = n632_over_165 * z287 - z288;
    const Scalar z354 = n256_over_55 * z351 - z352;
    const Scalar z289 = c_q3 * z284 + s_q3 * z282;
    const Scalar z356 = n256_over_55 * z350 - z353;
    const Scalar z355 = z349 + z351;
    const Scalar z291 = n632_over_165 * z286 - z289;
    const Scalar z357 = c_q4 * z350;
    const Scalar z327 = c_q3 * z314 + s_q3 * z320;
    const Scalar z295 = s_q2 * z290 - c_q2 * z285;
    const Scalar z374 = n2 * z346;
    const Scalar z373 = z308 - z345;
    const Scalar z375 = c_q5 * z374 + s_q5 * z373;
    const Scalar z381 = z309 + n256_over_55 * z351 - z352;
    const Scalar z383 = z349 + n2 * z351;
    const Scalar z388 = k27 + z381;
    const Scalar z390 = k28 + z356;
    const Scalar z325 = z314 - z323;
    const Scalar z326 = s_q3 * z314 - c_q3 * z320;
    const Scalar z376 = s_q5 * z375;
    const Scalar z379 = c_q5 * z375 - z346;
    const Scalar z386 = k29 + z309;
    const Scalar z385 = k30 + z351;
    const Scalar z377 = z345 + z376;
    const Scalar z378 = z308 - z376;
    const Scalar z382 = z350 + z379;
    const Scalar z393 = s_q4 * z386 + c_q4 * z385;
    const Scalar z392 = s_q4 * z385 - c_q4 * z386;
    const Scalar z380 = n512_over_55 * z309 + z377;
    const Scalar z384 = z378 + n512_over_55 * z309 + n2 * z351;
    const Scalar z387 = k32 + z380;
    const Scalar z389 = k33 + z382;
    const Scalar z358 = s_q4 * z350;
    const Scalar z361 = z356 - z358;
    const Scalar z359 = s_q4 * z355 - c_q4 * z354;
    const Scalar z360 = c_q4 * z355 + s_q4 * z354;
    const Scalar z391 = k34 + z384;
    const Scalar z364 = s_q3 * z357 - c_q3 * z351;
    const Scalar z362 = z351 - z360;
    const Scalar z363 = s_q3 * z351 + c_q3 * z357;
    const Scalar z365 = c_q3 * z359 + s_q3 * z361;
    const Scalar z367 = n632_over_165 * z364 + z365;
    const Scalar z328 = s_q3 * z324 - c_q3 * z322;
    const Scalar z329 = c_q3 * z324 + s_q3 * z322;
    const Scalar z394 = s_q4 * z390 + c_q4 * z389;
    const Scalar z331 = n632_over_165 * z326 + z329;
    const Scalar z395 = s_q4 * z389 - c_q4 * z390;
    const Scalar z330 = n632_over_165 * z327 - z328;
    const Scalar z396 = z391 - z393;
    const Scalar z366 = s_q3 * z359 - c_q3 * z361;
    const Scalar z397 = c_q3 * z392;
    const Scalar z335 = c_q2 * z325 + s_q2 * z330;
    const Scalar z407 = z383 - z387;
    const Scalar z408 = n2 * z388;
    const Scalar z409 = s_q4 * z407 - c_q4 * z408;
    const Scalar z414 = z350 - z394;
    const Scalar z421 = k35 - z414;
    const Scalar z416 = z391 - n2 * z393;
    const Scalar z419 = k36 - z350;
    const Scalar z423 = k37 + z395;
    const Scalar z418 = k38 - z393;
    const Scalar z436 = n2 * z421;
    const Scalar z368 = n632_over_165 * z363 - z366;
    const Scalar z410 = s_q4 * z409;
    const Scalar z413 = c_q4 * z409 + z388;
    const Scalar z426 = s_q3 * z419 - c_q3 * z418;
    const Scalar z411 = z387 + z410;
    const Scalar z412 = z383 - z410;
    const Scalar z415 = z392 - z413;
    const Scalar z425 = c_q3 * z419 + s_q3 * z418;
    const Scalar z420 = k39 + z411;
    const Scalar z417 = n2 * z393 - z412;
    const Scalar z422 = k40 - z415;
    const Scalar z398 = s_q3 * z392;
    const Scalar z399 = c_q3 * z394 + s_q3 * z396;
    const Scalar z435 = z416 - z420;
    const Scalar z427 = s_q3 * z423 - c_q3 * z422;
    const Scalar z372 = s_q2 * z367 - c_q2 * z362;
    const Scalar z437 = c_q3 * z436 + s_q3 * z435;
    const Scalar z429 = n632_over_165 * z426 + z427;
    const Scalar z438 = s_q3 * z437;
    const Scalar z424 = k41 - z417;
    const Scalar z428 = c_q3 * z423 + s_q3 * z422;
    const Scalar z447 = k42 + z429;
    const Scalar z439 = z420 + z438;
    const Scalar z430 = n632_over_165 * z425 + z428;
    const Scalar z440 = z416 - z438;
    const Scalar z456 = n2 * z447;
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z442 = k43 * z392 - z439;
    const Scalar z449 = k44 + z430;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z446 = k45 - z442;
    const Scalar z448 = k46 - z441;
    const Scalar z443 = k43 * z392 - z440;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z455 = z424 - z446;
    const Scalar z406 = c_q2 * z395 + s_q2 * z401;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z457 = c_q2 * z456 + s_q2 * z455;
    const Scalar z450 = k47 - z443;
    const Scalar z454 = c_q2 * z449 + s_q2 * z448;
    const Scalar z458 = s_q2 * z457;
    const Scalar z460 = z424 - z458;
    const Scalar z468 = k48 + z460;
    mass[0] = z468;
    mass[1] = -z454;
    mass[2] = -z434;
    mass[3] = z406;
    mass[4] = z372;
    mass[5] = -z335;
    mass[6] = z295;
    mass[7] = -z454;
    mass[8] = z450;
    mass[9] = -z430;
    mass[10] = z402;
    mass[11] = z368;
    mass[12] = z331;
    mass[13] = z291;
    mass[14] = -z434;
    mass[15] = -z430;
    mass[16] = z424;
    mass[17] = z395;
    mass[18] = -z362;
    mass[19] = -z325;
    mass[20] = -z285;
    mass[21] = z406;
    mass[22] = z402;
    mass[23] = z395;
    mass[24] = z391;
    mass[25] = -z356;
    mass[26] = -z319;
    mass[27] = z279;
    mass[28] = z372;
    mass[29] = z368;
    mass[30] = -z362;
    mass[31] = -z356;
    mass[32] = z349;
    mass[33] = -z312;
    mass[34] = z272;
    mass[35] = -z335;
    mass[36] = z331;
    mass[37] = -z325;
    mass[38] = -z319;
    mass[39] = -z312;
    mass[40] = z308;
    mass[41] = -z267;
    mass[42] = z295;
    mass[43] = z291;
    mass[44] = -z285;
    mass[45] = z279;
    mass[46] = z272;
    mass[47] = -z267;
    mass[48] = k6;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k4 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k5 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k7 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k8 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k9 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k11 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k12 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k15 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k19 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k22 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k23 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k24 = traits::constant(0.02914515311624745, 0.029145153f, "3643144139530931/125000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k28 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k29 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k30 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k31 = traits::constant(0.011496343893347959, 0.011496344f, "11496343893347959/1000000000000000000");
    const Scalar k32 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k33 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k37 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k38 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k39 = traits::constant(0.6310729011877872, 0.6310729f, "631072901187787269/1000000000000000000");
    const Scalar k40 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k41 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k42 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k45 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k46 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k47 = traits::constant(0.07860781999140594, 0.07860782f, "19651954997851483/250000000000000000");
    const Scalar k48 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k49 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k50 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k51 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k52 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k53 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k54 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k55 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k56 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k57 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z487 = v_q2 * v_q2;
    const Scalar z482 = k0 * s_q2;
    const Scalar z483 = k0 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z484 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z485 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z486 = z39 * z40;
    const Scalar z488 = z39 * z39;
    const Scalar z489 = z487 + z488;
    const Scalar z490 = n2 * z484;
    const Scalar z491 = c_q3 * z484;
    const Scalar z492 = s_q3 * z484;
    const Scalar z493 = z482 + n632_over_165 * z486;
    const Scalar z501 = z57 * z57;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z500 = z56 * z56;
    const Scalar z503 = z55 * z56;
    const Scalar z505 = z55 * z57;
    const Scalar z494 = z483 - n632_over_165 * z489;
    const Scalar z495 = n632_over_165 * z490;
    const Scalar z498 = v_q3 * z56 - z491;  // angular acceleration of link3, x
    const Scalar z499 = v_q3 * z55 - z492;  // angular acceleration of link3, y
    const Scalar z502 = z500 + z501;
    const Scalar z504 = z485 - z503;
    const Scalar z517 = z80 * z80;
    const Scalar z496 = s_q3 * z495 - c_q3 * z493;
    const Scalar z497 = s_q3 * z493 + c_q3 * z495;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z506 = z499 + z505;
    const Scalar z507 = s_q4 * z485 - c_q4 * z498;
    const Scalar z508 = c_q4 * z485 + s_q4 * z498;
    const Scalar z522 = z78 * z78;
    const Scalar z524 = z78 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z516 = z79 * z79;
    const Scalar z519 = z78 * z79;
    const Scalar z526 = z79 * z80;
    const Scalar z511 = z494 + z506;
    const Scalar z523 = z517 + z522;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z510 = z497 - z504;
    const Scalar z514 = v_q4 * z79 + z507;  // angular acceleration of link4, x
    const Scalar z515 = v_q4 * z78 + z508;  // angular acceleration of link4, y
    const Scalar z518 = z516 + z517;
    const Scalar z520 = z499 + z519;
    const Scalar z521 = z499 - z519;
    const Scalar z509 = z496 - z502;
    const Scalar z525 = z515 + z524;
    const Scalar z527 = z514 + z526;
    const Scalar z528 = s_q5 * z499 + c_q5 * z514;
    const Scalar z529 = s_q5 * z514 - c_q5 * z499;
    const Scalar z512 = s_q4 * z511 + c_q4 * z509;
    const Scalar z513 = s_q4 * z509 - c_q4 * z511;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z543 = z118 * z118;
    const Scalar z587 = z117 * z117;
    const Scalar z535 = v_q5 * z103 + z528;  // angular acceleration of link5, x
    const Scalar z530 = z518 - n256_over_55 * z520 + z512;
    const Scalar z532 = z510 + z525 + n256_over_55 * z527;
    const Scalar z536 = v_q5 * z102 + z529;  // angular acceleration of link5, y
    const Scalar z537 = s_q6 * z515 + c_q6 * z535;
    const Scalar z531 = n256_over_55 * z523 + z521 + z513;
    const Scalar z541 = v_q6 * z118 - z537;  // angular acceleration of link6, x
    const Scalar z538 = s_q6 * z535 - c_q6 * z515;
    const Scalar z559 = z138 * z138;
    const Scalar z542 = v_q6 * z117 - z538;  // angular acceleration of link6, y
    const Scalar z562 = z137 * z138;
    const Scalar z565 = z137 * z137;
    const Scalar z544 = z119 * z119;
    const Scalar z551 = c_q7 * z536 + s_q7 * z541;
    const Scalar z560 = z139 * z139;
    const Scalar z533 = c_q5 * z530 + s_q5 * z532;
    const Scalar z534 = s_q5 * z530 - c_q5 * z532;
    const Scalar z558 = v_q7 * z137 + z551;  // angular acceleration of link7, y
    const Scalar z567 = z137 * z139;
    const Scalar z569 = z138 * z139;
    const Scalar z595 = z543 - z587;
    const Scalar z546 = z117 * z118;
    const Scalar z548 = z117 * z119;
    const Scalar z589 = z118 * z119;
    const Scalar z575 = z559 - z565;
    const Scalar z550 = s_q7 * z536 - c_q7 * z541;
    const Scalar z557 = v_q7 * z138 + z550;  // angular acceleration of link7, x
    const Scalar z566 = z560 + z565;
    const Scalar z572 = z560 - z565;
    const Scalar z592 = z544 - z587;
    const Scalar z588 = z544 + z587;
    const Scalar z571 = z559 - z560;
    const Scalar z561 = z559 + z560;
    const Scalar z540 = c_q6 * z531 + s_q6 * z533;
    const Scalar z547 = z536 - z546;
    const Scalar z563 = z542 + z562;
    const Scalar z576 = k4 * z561 - k5 * z563;  // force on link7, times 0.0825 m, x
    const Scalar z564 = z542 - z562;
    const Scalar z577 = k5 * z566 + k4 * z564;  // force on link7, times 0.0825 m, y
    const Scalar z586 = z536 + z546;
    const Scalar z539 = s_q6 * z531 - c_q6 * z533;
    const Scalar z545 = z543 + z544;
    const Scalar z591 = z543 - z544;
    const Scalar z568 = z558 + z567;
    const Scalar z574 = z558 - z567;
    const Scalar z549 = z542 + z548;
    const Scalar z594 = z542 - z548;
    const Scalar z553 = z540 + n16_over_15 * z547;
    const Scalar z570 = z557 + z569;
    const Scalar z573 = z557 - z569;
    const Scalar z580 = k7 * z572 + k8 * z563 + k4 * z553 + k9 * z568 - k10 * z570;  // moment on link7, y
    const Scalar z579 = k8 * z571 + k7 * z564 + k5 * z553 - k10 * z568 + k11 * z570;  // moment on link7, x
    const Scalar z578 = k4 * z568 + k5 * z570;  // force on link7, times 0.0825 m, z
    const Scalar z597 = k12 * z547 + z578 - k13 * z588;  // force on link6, times 0.0825 m, y
    const Scalar z552 = z539 + n16_over_15 * z545;
    const Scalar z607 = z104 * z104;
    const Scalar z609 = z102 * z103;
    const Scalar z612 = z102 * z102;
    const Scalar z554 = z534 + n16_over_15 * z549;
    const Scalar z614 = z102 * z104;
    const Scalar z590 = z541 + z589;
    const Scalar z593 = z541 - z589;
    const Scalar z606 = z103 * z103;
    const Scalar z582 = s_q7 * z577 + c_q7 * z576;
    const Scalar z583 = s_q7 * z576 - c_q7 * z577;
    const Scalar z596 = k12 * z545 + z582 + k13 * z586;  // force on link6, times 0.0825 m, x
    const Scalar z610 = z515 + z609;
    const Scalar z556 = s_q7 * z552 + c_q7 * z554;
    const Scalar z555 = s_q7 * z554 - c_q7 * z552;
    // moment on link7, z
    const Scalar z581 = k14 * z562 + k10 * z575 + k15 * z542 + k7 * z573 + k8 * z574 + k4 * z556 + k5 * z555;
    // moment on link6, y
    const Scalar z600 = k16 * z592 + k17 * z586 + k12 * z534 - k18 * z590 + k19 * z549 - n16_over_15 * z583 + z581;
    const Scalar z616 = z103 * z104;
    const Scalar z635 = z514 - z526;
    const Scalar z598 = k12 * z549 - z583 - k13 * z590;  // force on link6, times 0.0825 m, z
    const Scalar z636 = z515 - z524;
    const Scalar z619 = z607 - z612;
    const Scalar z622 = z606 - z612;
    const Scalar z613 = z607 + z612;
    const Scalar z618 = z606 - z607;
    const Scalar z608 = z606 + z607;
    const Scalar z620 = z535 - z616;
    const Scalar z617 = z535 + z616;
    const Scalar z611 = z515 - z609;
    const Scalar z624 = z598 - k20 * z611 + k21 * z613;  // force on link5, times 0.0825 m, y
    const Scalar z637 = z516 - z522;
    const Scalar z634 = z517 - z522;
    const Scalar z633 = z516 - z517;
    const Scalar z621 = z536 - z614;
    const Scalar z615 = z536 + z614;
    const Scalar z584 = s_q7 * z580 - c_q7 * z579;
    const Scalar z599 = k13 * z534 - k17 * z591 - k16 * z547 - k22 * z590 + k18 * z549 - z584;  // moment on link6, x
    const Scalar z585 = s_q7 * z579 + c_q7 * z580;
    // moment on link6, z
    const Scalar z601 = k18 * z595 - k23 * z546 + k24 * z536 + k13 * z539 + k12 * z540 + k16 * z593 + k17 * z594
        + n16_over_15 * z578 + z585;
    const Scalar z627 = k25 * z619 + k26 * z610 + k20 * z531 - k27 * z617 - k28 * z615 - z601;  // moment on link5, y
    const Scalar z651 = z56 * z57;
    const Scalar z649 = z55 * z55;
    const Scalar z656 = z499 - z505;
    const Scalar z602 = s_q6 * z597 - c_q6 * z596;
    const Scalar z623 = z602 + k20 * z608 + k21 * z610;  // force on link5, times 0.0825 m, x
    const Scalar z603 = s_q6 * z596 + c_q6 * z597;
    const Scalar z625 = z603 - k20 * z615 + k21 * z617;  // force on link5, times 0.0825 m, z
    const Scalar z604 = s_q6 * z600 - c_q6 * z599;
    const Scalar z626 = k21 * z531 - k26 * z618 - k25 * z611 + k29 * z617 + k27 * z615 - z604;  // moment on link5, x
    const Scalar z605 = c_q6 * z600 + s_q6 * z599;
    // moment on link5, z
    const Scalar z628 = k30 * z609 + k31 * z515 - k27 * z622 - k25 * z620 - k26 * z621 + k21 * z533 - k20 * z534 + z605;
    const Scalar z639 = z625 + k32 * z523 + k33 * z521;  // force on link4, times 0.0825 m, y
    const Scalar z668 = z40 * z40;
    const Scalar z648 = z485 + z503;
    const Scalar z629 = s_q5 * z624 + c_q5 * z623;
    const Scalar z630 = s_q5 * z623 - c_q5 * z624;
    // moment on link4, y
    const Scalar z642 = k33 * z510 - k34 * z634 + k35 * z520 + k36 * z525 + k37 * z527 + z628 + z630;
    const Scalar z638 = z629 + k33 * z518 - k32 * z520;  // force on link4, times 0.0825 m, x
    const Scalar z653 = z500 - z501;
    const Scalar z657 = z500 - z649;
    const Scalar z654 = z501 - z649;
    const Scalar z650 = z501 + z649;
    const Scalar z631 = s_q5 * z627 - c_q5 * z626;
    // moment on link4, x
    const Scalar z641 = k32 * z510 - k34 * z521 + k35 * z633 + k37 * z525 + k38 * z527 - z631 + n256_over_55 * z630;
    const Scalar z640 = z630 + k33 * z525 + k32 * z527;  // force on link4, times 0.0825 m, z
    const Scalar z632 = c_q5 * z627 + s_q5 * z626;
    // moment on link4, z
    const Scalar z643 = k39 * z499 + k40 * z519 - k37 * z637 - k34 * z635 + k35 * z636 - k32 * z512 + k33 * z513 + z625
        + z632 - n256_over_55 * z629;
    const Scalar z659 = k41 * z504 - z640 + k42 * z650;  // force on link3, times 0.0825 m, y
    const Scalar z655 = z498 - z651;
    const Scalar z652 = z498 + z651;
    const Scalar z646 = s_q4 * z642 - c_q4 * z641;
    const Scalar z661 = k42 * z494 + k43 * z504 - k44 * z653 + k45 * z506 + k46 * z652 + z646;  // moment on link3, x
    const Scalar z647 = c_q4 * z642 + s_q4 * z641;
    // moment on link3, z
    const Scalar z663 = k47 * z485 - k48 * z503 - k45 * z657 + k43 * z655 - k44 * z656 - k41 * z497 + k42 * z496 - z640
        + z647;
    const Scalar z670 = n2 * z485;
    const Scalar z644 = s_q4 * z639 + c_q4 * z638;
    const Scalar z645 = s_q4 * z638 - c_q4 * z639;
    // moment on link3, y
    const Scalar z662 = k41 * z494 - k44 * z648 + k43 * z654 + k49 * z506 + k45 * z652 + z643 + z645;
    const Scalar z671 = z487 - z668;
    const Scalar z658 = k41 * z502 - z644 - k42 * z648;  // force on link3, times 0.0825 m, x
    const Scalar z666 = c_q3 * z661 + s_q3 * z662;
    const Scalar z665 = c_q3 * z659 + s_q3 * z658;
    const Scalar z672 = z487 - z488;
    const Scalar z673 = z488 - z668;
    const Scalar z667 = s_q3 * z661 - c_q3 * z662;
    // moment on link2, x
    const Scalar z677 = k50 * z486 - k51 * z490 - k52 * z670 - k53 * z671 + z666 + n632_over_165 * z665;
    const Scalar z664 = s_q3 * z659 - c_q3 * z658;
    const Scalar z678 = k53 * z486 - k52 * z490 - k54 * z670 - k50 * z672 - z663;  // moment on link2, y
    // moment on link2, z
    const Scalar z679 = k55 * z482 - k56 * z483 + k57 * z486 + k52 * z673 - z667 - n632_over_165 * z664;
    const Scalar z683 = s_q2 * z677 - c_q2 * z678;
    forces.q1 = -z683;
    forces.q2 = -z679;
    forces.q3 = -z663;
    forces.q4 = z643;
    forces.q5 = -z628;
    forces.q6 = -z601;
    forces.q7 = z581;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k4 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k5 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k6 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k7 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k8 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k9 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k10 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k11 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k12 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k15 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k18 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k19 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k22 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k23 = traits::constant(0.02914515311624745, 0.029145153f, "3643144139530931/125000000000000000");
    const Scalar k24 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k25 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k26 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k27 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k28 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k29 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k30 = traits::constant(0.011496343893347959, 0.011496344f, "11496343893347959/1000000000000000000");
    const Scalar k31 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k32 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k35 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k36 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k37 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k38 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k39 = traits::constant(0.6310729011877872, 0.6310729f, "631072901187787269/1000000000000000000");
    const Scalar k40 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k41 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k45 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k46 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k47 = traits::constant(0.07860781999140594, 0.07860782f, "19651954997851483/250000000000000000");
    const Scalar k48 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k49 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k50 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k51 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k52 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k53 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k54 = traits::constant(0.9793493837268126, 0.9793494f, "489674691863406311/500000000000000000");
    const Scalar k55 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k56 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k57 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
    const Scalar k58 = traits::constant(0.014259565994474374, 0.014259566f, "7129782997237187/500000000000000000");
    const Scalar v_q1 = state.v.q1;
    const Scalar a_q1 = accelerations.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar a_q2 = accelerations.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar a_q3 = accelerations.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar a_q4 = accelerations.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar a_q5 = accelerations.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar a_q6 = accelerations.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar a_q7 = accelerations.q7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z487 = v_q2 * v_q2;
    const Scalar z482 = k0 * s_q2;
    const Scalar z483 = k0 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z484 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z485 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z486 = z39 * z40;
    const Scalar z488 = z39 * z39;
    const Scalar z489 = z487 + z488;
    const Scalar z501 = z57 * z57;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z500 = z56 * z56;
    const Scalar z503 = z55 * z56;
    const Scalar z505 = z55 * z57;
    const Scalar z494 = z483 - n632_over_165 * z489;
    const Scalar z502 = z500 + z501;
    const Scalar z517 = z80 * z80;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z522 = z78 * z78;
    const Scalar z524 = z78 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z516 = z79 * z79;
    const Scalar z519 = z78 * z79;
    const Scalar z526 = z79 * z80;
    const Scalar z523 = z517 + z522;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z634 = z517 - z522;
    const Scalar z518 = z516 + z517;
    const Scalar z606 = z103 * z103;
    const Scalar z607 = z104 * z104;
    const Scalar z609 = z102 * z103;
    const Scalar z612 = z102 * z102;
    const Scalar z614 = z102 * z104;
    const Scalar z616 = z103 * z104;
    const Scalar z633 = z516 - z517;
    const Scalar z544 = z119 * z119;
    const Scalar z608 = z606 + z607;
    const Scalar z613 = z607 + z612;
    const Scalar z618 = z606 - z607;
    const Scalar z619 = z607 - z612;
    const Scalar z622 = z606 - z612;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z637 = z516 - z522;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z649 = z55 * z55;
    const Scalar z139 = v_q7 - z118;
    const Scalar z651 = z56 * z57;
    const Scalar z689 = a_q1 * s_q2;
    const Scalar z691 = v_q2 * z40 + z689;  // angular acceleration of link2, x
    const Scalar z668 = z40 * z40;
    const Scalar z690 = a_q1 * c_q2;
    const Scalar z692 = v_q2 * z39 - z690;  // angular acceleration of link2, y
    const Scalar z693 = a_q2 - z486;
    const Scalar z697 = z482 - n632_over_165 * z693;
    const Scalar z695 = a_q2 * s_q3 - c_q3 * z691;
    const Scalar z694 = z484 + z691;
    const Scalar z696 = a_q2 * c_q3 + s_q3 * z691;
    const Scalar z701 = v_q3 * z56 + z695;  // angular acceleration of link3, x
    const Scalar z702 = v_q3 * z55 - z696;  // angular acceleration of link3, y
    const Scalar z698 = n632_over_165 * z694;
    const Scalar z699 = s_q3 * z698 - c_q3 * z697;
    const Scalar z700 = s_q3 * z697 + c_q3 * z698;
    const Scalar z653 = z500 - z501;
    const Scalar z657 = z500 - z649;
    const Scalar z546 = z117 * z118;
    const Scalar z543 = z118 * z118;
    const Scalar z703 = a_q3 - z692;  // angular acceleration of link3, z
    const Scalar z704 = z503 + z703;
    const Scalar z587 = z117 * z117;
    const Scalar z548 = z117 * z119;
    const Scalar z589 = z118 * z119;
    const Scalar z560 = z139 * z139;
    const Scalar z565 = z137 * z137;
    const Scalar z595 = z543 - z587;
    const Scalar z545 = z543 + z544;
    const Scalar z591 = z543 - z544;
    const Scalar z705 = z505 + z702;
    const Scalar z706 = s_q4 * z703 + c_q4 * z701;
    const Scalar z707 = s_q4 * z701 - c_q4 * z703;
    const Scalar z559 = z138 * z138;
    const Scalar z708 = z502 - z699;
    const Scalar z709 = z700 + z704;
    const Scalar z562 = z137 * z138;
    const Scalar z566 = z560 + z565;
    const Scalar z572 = z560 - z565;
    const Scalar z575 = z559 - z565;
    const Scalar z561 = z559 + z560;
    const Scalar z713 = v_q4 * z79 - z706;  // angular acceleration of link4, x
    const Scalar z571 = z559 - z560;
    const Scalar z710 = z494 + z705;
    const Scalar z711 = s_q4 * z710 - c_q4 * z708;
    const Scalar z712 = c_q4 * z710 + s_q4 * z708;
    const Scalar z592 = z544 - z587;
    const Scalar z588 = z544 + z587;
    const Scalar z569 = z138 * z139;
    const Scalar z567 = z137 * z139;
    const Scalar z714 = v_q4 * z78 + z707;  // angular acceleration of link4, y
    const Scalar z715 = a_q4 + z702;  // angular acceleration of link4, z
    const Scalar z716 = z519 + z715;
    const Scalar z720 = s_q5 * z715 + c_q5 * z713;
    const Scalar z719 = z526 + z713;
    const Scalar z729 = a_q5 - z714;  // angular acceleration of link5, z
    const Scalar z717 = z519 - z715;
    const Scalar z721 = s_q5 * z713 - c_q5 * z715;
    const Scalar z728 = v_q5 * z102 + z721;  // angular acceleration of link5, y
    const Scalar z718 = z524 + z714;
    const Scalar z722 = z518 - n256_over_55 * z716 + z711;
    const Scalar z727 = v_q5 * z103 + z720;  // angular acceleration of link5, x
    const Scalar z724 = z709 + n256_over_55 * z719 + z718;
    const Scalar z723 = n256_over_55 * z523 - z717 - z712;
    const Scalar z731 = c_q6 * z729 + s_q6 * z727;
    const Scalar z730 = s_q6 * z729 - c_q6 * z727;
    const Scalar z735 = v_q6 * z117 - z731;  // angular acceleration of link6, y
    const Scalar z734 = v_q6 * z118 + z730;  // angular acceleration of link6, x
    const Scalar z736 = a_q6 - z728;  // angular acceleration of link6, z
    const Scalar z725 = c_q5 * z722 + s_q5 * z724;
    const Scalar z726 = s_q5 * z722 - c_q5 * z724;
    const Scalar z733 = c_q6 * z723 + s_q6 * z725;
    const Scalar z737 = z546 + z736;
    const Scalar z732 = s_q6 * z723 - c_q6 * z725;
    const Scalar z739 = s_q7 * z736 + c_q7 * z734;
    const Scalar z738 = z548 + z735;
    const Scalar z654 = z501 - z649;
    const Scalar z650 = z501 + z649;
    const Scalar z742 = z733 - n16_over_15 * z737;
    const Scalar z740 = s_q7 * z734 - c_q7 * z736;
    const Scalar z741 = n16_over_15 * z545 + z732;
    const Scalar z743 = z726 + n16_over_15 * z738;
    const Scalar z745 = s_q7 * z741 + c_q7 * z743;
    const Scalar z744 = s_q7 * z743 - c_q7 * z741;
    const Scalar z671 = z487 - z668;
    const Scalar z746 = v_q7 * z138 - z739;  // angular acceleration of link7, x
    const Scalar z672 = z487 - z488;
    const Scalar z747 = v_q7 * z137 + z740;  // angular acceleration of link7, y
    const Scalar z673 = z488 - z668;
    const Scalar z795 = z526 - z713;
    const Scalar z796 = z524 - z714;
    const Scalar z768 = z548 - z735;
    const Scalar z748 = a_q7 + z735;  // angular acceleration of link7, z
    const Scalar z750 = z562 - z748;
    const Scalar z749 = z562 + z748;
    const Scalar z810 = z505 - z702;
    const Scalar z752 = z569 + z746;
    const Scalar z753 = z569 - z746;
    const Scalar z765 = z546 - z736;
    const Scalar z756 = k4 * z566 - k5 * z750;  // force on link7, times 0.0825 m, y
    const Scalar z755 = k5 * z561 - k4 * z749;  // force on link7, times 0.0825 m, x
    const Scalar z751 = z567 + z747;
    const Scalar z759 = k6 * z572 + k5 * z742 + k7 * z749 + k8 * z751 - k9 * z752;  // moment on link7, y
    const Scalar z758 = k7 * z571 + k4 * z742 - k6 * z750 - k9 * z751 + k10 * z752;  // moment on link7, x
    const Scalar z757 = k4 * z752 + k5 * z751;  // force on link7, times 0.0825 m, z
    const Scalar z754 = z567 - z747;
    // moment on link7, z
    const Scalar z760 = k11 * z562 + k9 * z575 + k12 * z748 - k6 * z753 + k5 * z745 + k4 * z744 - k7 * z754;
    const Scalar z770 = k13 * z588 - z757 + k14 * z737;  // force on link6, times 0.0825 m, y
    const Scalar z761 = s_q7 * z756 + c_q7 * z755;
    const Scalar z762 = s_q7 * z755 - c_q7 * z756;
    const Scalar z769 = k14 * z545 + z761 + k13 * z765;  // force on link6, times 0.0825 m, x
    const Scalar z823 = z484 - z691;
    const Scalar z766 = z589 + z734;
    // moment on link6, y
    const Scalar z773 = k15 * z592 + k14 * z726 + k16 * z765 + k17 * z738 - k18 * z766 - n16_over_15 * z762 + z760;
    const Scalar z767 = z589 - z734;
    const Scalar z771 = k14 * z738 - z762 - k13 * z766;  // force on link6, times 0.0825 m, z
    const Scalar z779 = z609 - z729;
    const Scalar z783 = z616 - z727;
    const Scalar z782 = z616 + z727;
    const Scalar z780 = z609 + z729;
    const Scalar z786 = k19 * z613 + z771 + k20 * z780;  // force on link5, times 0.0825 m, y
    const Scalar z784 = z614 - z728;
    const Scalar z781 = z614 + z728;
    const Scalar z763 = s_q7 * z759 - c_q7 * z758;
    const Scalar z772 = k16 * z591 - k13 * z726 - k15 * z737 - k18 * z738 + k21 * z766 + z763;  // moment on link6, x
    const Scalar z764 = s_q7 * z758 + c_q7 * z759;
    // moment on link6, z
    const Scalar z774 = k22 * z546 - k18 * z595 + k23 * z736 - k13 * z732 - k14 * z733 + k15 * z767 + k16 * z768
        - n16_over_15 * z757 - z764;
    const Scalar z789 = k24 * z619 + k20 * z723 + k25 * z779 - k26 * z782 - k27 * z781 + z774;  // moment on link5, y
    const Scalar z775 = c_q6 * z769 + s_q6 * z770;
    const Scalar z785 = k20 * z608 - z775 + k19 * z779;  // force on link5, times 0.0825 m, x
    const Scalar z776 = s_q6 * z769 - c_q6 * z770;
    const Scalar z787 = z776 - k20 * z781 + k19 * z782;  // force on link5, times 0.0825 m, z
    const Scalar z777 = s_q6 * z773 + c_q6 * z772;
    const Scalar z788 = k25 * z618 - k19 * z723 - k24 * z780 - k28 * z782 - k26 * z781 + z777;  // moment on link5, x
    const Scalar z778 = s_q6 * z772 - c_q6 * z773;
    // moment on link5, z
    const Scalar z790 = k29 * z609 - k26 * z622 - k30 * z729 + k24 * z783 + k25 * z784 + k19 * z725 - k20 * z726 - z778;
    const Scalar z798 = z787 + k31 * z523 - k32 * z717;  // force on link4, times 0.0825 m, y
    const Scalar z791 = s_q5 * z786 + c_q5 * z785;
    const Scalar z792 = s_q5 * z785 - c_q5 * z786;
    // moment on link4, y
    const Scalar z801 = k33 * z634 - k32 * z709 - k34 * z716 - k35 * z718 - k36 * z719 - z790 - z792;
    const Scalar z797 = z791 + k32 * z518 - k31 * z716;  // force on link4, times 0.0825 m, x
    const Scalar z807 = z503 - z703;
    const Scalar z793 = s_q5 * z789 + c_q5 * z788;
    // moment on link4, x
    const Scalar z800 = k34 * z633 + k33 * z717 + k31 * z709 + k37 * z719 + k36 * z718 - z793 + n256_over_55 * z792;
    const Scalar z799 = z792 + k31 * z719 + k32 * z718;  // force on link4, times 0.0825 m, z
    const Scalar z794 = s_q5 * z788 - c_q5 * z789;
    // moment on link4, z
    const Scalar z802 = k38 * z519 + k39 * z715 - k36 * z637 + k33 * z795 - k31 * z711 - k32 * z712 - k34 * z796 + z787
        - n256_over_55 * z791 - z794;
    const Scalar z812 = k40 * z650 - z799 - k41 * z704;  // force on link3, times 0.0825 m, y
    const Scalar z809 = z651 - z701;
    const Scalar z808 = z651 + z701;
    const Scalar z821 = a_q2 + z486;
    const Scalar z805 = s_q4 * z801 + c_q4 * z800;
    const Scalar z814 = k40 * z494 - k42 * z653 - k43 * z704 + k44 * z705 + k45 * z808 - z805;  // moment on link3, x
    const Scalar z806 = s_q4 * z800 - c_q4 * z801;
    // moment on link3, z
    const Scalar z816 = k46 * z503 + k47 * z703 + k44 * z657 + k43 * z809 - k42 * z810 - k40 * z699 + k41 * z700 + z799
        - z806;
    const Scalar z803 = s_q4 * z798 + c_q4 * z797;
    const Scalar z804 = s_q4 * z797 - c_q4 * z798;
    // moment on link3, y
    const Scalar z815 = k41 * z494 + k43 * z654 - k42 * z807 + k48 * z705 + k44 * z808 + z802 + z804;
    const Scalar z822 = z485 + z692;
    const Scalar z811 = k41 * z502 - z803 - k40 * z807;  // force on link3, times 0.0825 m, x
    const Scalar z819 = c_q3 * z814 + s_q3 * z815;
    const Scalar z818 = c_q3 * z812 + s_q3 * z811;
    const Scalar z829 = k49 * z672 + k50 * z693 + k51 * z694 + k52 * z822 - z816;  // moment on link2, y
    const Scalar z824 = z485 - z692;
    // moment on link2, x
    const Scalar z828 = k50 * z671 - k49 * z821 + k53 * z694 + k51 * z822 - z819 - n632_over_165 * z818;
    const Scalar z820 = s_q3 * z814 - c_q3 * z815;
    const Scalar z817 = s_q3 * z812 - c_q3 * z811;
    const Scalar z834 = s_q2 * z828 - c_q2 * z829;
    // moment on link2, z
    const Scalar z830 = k54 * a_q2 - k55 * z482 + k56 * z483 - k57 * z486 - k51 * z673 + k49 * z823 - k50 * z824 + z820
        + n632_over_165 * z817;
    const Scalar z839 = k58 * a_q1 + z834;  // moment on link1, z
    forces.q1 = z839;
    forces.q2 = z830;
    forces.q3 = z816;
    forces.q4 = z802;
    forces.q5 = -z790;
    forces.q6 = z774;
    forces.q7 = z760;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k1 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k2 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k3 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k4 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k5 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k6 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k10 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k11 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k12 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k18 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k20 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k21 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k22 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k23 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k24 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k25 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k27 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k28 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k38 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar k43 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k44 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k45 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k46 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k47 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar k50 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k51 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k52 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k54 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k55 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k56 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k57 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k58 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k59 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k60 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k61 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k62 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k63 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k64 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k65 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k66 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k67 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k68 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k69 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k70 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar u_tau1 = inputs.tau1;
    const Scalar u_tau2 = inputs.tau2;
    const Scalar u_tau3 = inputs.tau3;
    const Scalar u_tau4 = inputs.tau4;
    const Scalar u_tau5 = inputs.tau5;
    const Scalar u_tau6 = inputs.tau6;
    const Scalar u_tau7 = inputs.tau7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z296 = k0 * s_q7 - k1 * c_q7;
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z265 = k2 * s_q7 + k3 * c_q7;
    const Scalar z266 = k4 * s_q7 - k5 * c_q7;
    const Scalar z264 = k3 * s_q7 - k2 * c_q7;
    const Scalar z267 = k5 * s_q7 + k4 * c_q7;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z268 = k6 + n16_over_15 * z265;
    const Scalar z269 = c_q6 * z264;
    const Scalar z270 = s_q6 * z264;
    const Scalar z297 = s_q7 * z296;
    const Scalar z299 = k8 + c_q7 * z296;
    const Scalar z301 = k6 + n32_over_15 * z265;
    const Scalar z303 = k10 + z265;
    const Scalar z305 = k11 - z266;
    const Scalar z307 = k12 + z267;
    const Scalar z273 = s_q5 * z265 - c_q5 * z269;
    const Scalar z274 = c_q5 * z265 + s_q5 * z269;
    const Scalar z298 = k0 - z297;
    const Scalar z302 = n32_over_15 * z265 + z297;
    const Scalar z309 = s_q6 * z303 - k13 * c_q6;
    const Scalar z310 = k13 * s_q6 + c_q6 * z303;
    const Scalar z271 = c_q6 * z266 + s_q6 * z268;
    const Scalar z272 = s_q6 * z266 - c_q6 * z268;
    const Scalar z300 = n16_over_15 * z264 - z299;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z304 = k14 - z298;
    const Scalar z104 = v_q5 - z79;
    const Scalar z280 = s_q4 * z270 + c_q4 * z273;
    const Scalar z281 = s_q4 * z273 - c_q4 * z270;
    const Scalar z308 = k15 + z302;
    const Scalar z275 = s_q5 * z267 - c_q5 * z271;
    const Scalar z276 = c_q5 * z267 + s_q5 * z271;
    const Scalar z278 = z272 + z274;
    const Scalar z306 = k16 + z300;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z313 = c_q5 * z309;
    const Scalar z314 = s_q5 * z309;
    const Scalar z286 = s_q3 * z274 + c_q3 * z280;
    const Scalar z287 = s_q3 * z280 - c_q3 * z274;
    const Scalar z311 = s_q6 * z307 + c_q6 * z306;
    const Scalar z312 = s_q6 * z306 - c_q6 * z307;
    const Scalar z279 = z270 - n256_over_55 * z273 - z276;
    const Scalar z277 = n256_over_55 * z274 - z275;
    const Scalar z284 = z279 + z281;
    const Scalar z316 = c_q5 * z308 + s_q5 * z311;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z319 = z310 - n256_over_55 * z313 - z316;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z344 = k18 - z264;
    const Scalar z336 = z301 + z304;
    const Scalar z337 = n2 * z305;
    const Scalar z338 = s_q6 * z336 - c_q6 * z337;
    const Scalar z346 = k20 - z311;
    const Scalar z315 = s_q5 * z308 - c_q5 * z311;
    const Scalar z317 = n256_over_55 * z314 + z315;
    const Scalar z343 = k21 - z310;
    const Scalar z318 = z312 - z314;
    const Scalar z283 = c_q4 * z278 + s_q4 * z277;
    const Scalar z285 = z274 - z283;
    const Scalar z282 = s_q4 * z278 - c_q4 * z277;
    const Scalar z342 = c_q6 * z338 + z305;
    const Scalar z339 = s_q6 * z338;
    const Scalar z340 = z304 - z339;
    const Scalar z341 = z301 - z339;
    const Scalar z347 = k22 + z342;
    const Scalar z348 = k23 + z312;
    const Scalar z351 = s_q5 * z344 + c_q5 * z343;
    const Scalar z350 = s_q5 * z343 - c_q5 * z344;
    const Scalar z345 = k24 - z340;
    const Scalar z349 = k25 + z341;
    const Scalar z353 = s_q5 * z347 - c_q5 * z348;
    const Scalar z352 = s_q5 * z348 + c_q5 * z347;
    const Scalar z323 = s_q4 * z317 - c_q4 * z318;
    const Scalar z322 = s_q4 * z318 + c_q4 * z317;
    const Scalar z325 = z314 - z323;
    const Scalar z321 = s_q4 * z313 - c_q4 * z310;
    const Scalar z320 = s_q4 * z310 + c_q4 * z313;
    const Scalar z324 = z319 + z321;
    const Scalar z289 = c_q3 * z284 + s_q3 * z282;
    const Scalar z291 = n632_over_165 * z286 - z289;
    const Scalar z288 = s_q3 * z284 - c_q3 * z282;
    const Scalar z290 = n632_over_165 * z287 - z288;
    const Scalar z356 = n256_over_55 * z350 - z353;
    const Scalar z355 = z349 + z351;
    const Scalar z354 = n256_over_55 * z351 - z352;
    const Scalar z357 = c_q4 * z350;
    const Scalar z295 = s_q2 * z290 - c_q2 * z285;
    const Scalar z381 = z309 + n256_over_55 * z351 - z352;
    const Scalar z388 = k27 + z381;
    const Scalar z374 = n2 * z346;
    const Scalar z373 = z308 - z345;
    const Scalar z375 = c_q5 * z374 + s_q5 * z373;
    const Scalar z383 = z349 + n2 * z351;
    const Scalar z390 = k28 + z356;
    const Scalar z386 = k29 + z309;
    const Scalar z385 = k30 + z351;
    const Scalar z360 = c_q4 * z355 + s_q4 * z354;
    const Scalar z359 = s_q4 * z355 - c_q4 * z354;
    const Scalar z379 = c_q5 * z375 - z346;
    const Scalar z376 = s_q5 * z375;
    const Scalar z362 = z351 - z360;
    const Scalar z358 = s_q4 * z350;
    const Scalar z377 = z345 + z376;
    const Scalar z378 = z308 - z376;
    const Scalar z382 = z350 + z379;
    const Scalar z361 = z356 - z358;
    const Scalar z326 = s_q3 * z314 - c_q3 * z320;
    const Scalar z327 = c_q3 * z314 + s_q3 * z320;
    const Scalar z380 = n512_over_55 * z309 + z377;
    const Scalar z384 = z378 + n512_over_55 * z309 + n2 * z351;
    const Scalar z387 = k32 + z380;
    const Scalar z389 = k33 + z382;
    const Scalar z393 = s_q4 * z386 + c_q4 * z385;
    const Scalar z392 = s_q4 * z385 - c_q4 * z386;
    const Scalar z391 = k34 + z384;
    const Scalar z329 = c_q3 * z324 + s_q3 * z322;
    const Scalar z331 = n632_over_165 * z326 + z329;
    const Scalar z328 = s_q3 * z324 - c_q3 * z322;
    const Scalar z330 = n632_over_165 * z327 - z328;
    const Scalar z394 = s_q4 * z390 + c_q4 * z389;
    const Scalar z395 = s_q4 * z389 - c_q4 * z390;
    const Scalar z335 = c_q2 * z325 + s_q2 * z330;
    const Scalar z407 = z383 - z387;
    const Scalar z408 = n2 * z388;
    const Scalar z409 = s_q4 * z407 - c_q4 * z408;
    const Scalar z414 = z350 - z394;
    const Scalar z421 = k35 - z414;
    const Scalar z419 = k36 - z350;
    const Scalar z416 = z391 - n2 * z393;
    const Scalar z423 = k37 + z395;
    const Scalar z418 = k38 - z393;
    const Scalar z396 = z391 - z393;
    const Scalar z426 = s_q3 * z419 - c_q3 * z418;
    const Scalar z425 = c_q3 * z419 + s_q3 * z418;
    const Scalar z413 = c_q4 * z409 + z388;
    const Scalar z410 = s_q4 * z409;
    const Scalar z411 = z387 + z410;
    const Scalar z412 = z383 - z410;
    const Scalar z415 = z392 - z413;
    const Scalar z363 = s_q3 * z351 + c_q3 * z357;
    const Scalar z417 = n2 * z393 - z412;
    const Scalar z364 = s_q3 * z357 - c_q3 * z351;
    const Scalar z420 = k39 + z411;
    const Scalar z422 = k40 - z415;
    const Scalar z427 = s_q3 * z423 - c_q3 * z422;
    const Scalar z428 = c_q3 * z423 + s_q3 * z422;
    const Scalar z424 = k41 - z417;
    const Scalar z366 = s_q3 * z359 - c_q3 * z361;
    const Scalar z429 = n632_over_165 * z426 + z427;
    const Scalar z368 = n632_over_165 * z363 - z366;
    const Scalar z430 = n632_over_165 * z425 + z428;
    const Scalar z365 = c_q3 * z359 + s_q3 * z361;
    const Scalar z367 = n632_over_165 * z364 + z365;
    const Scalar z436 = n2 * z421;
    const Scalar z435 = z416 - z420;
    const Scalar z437 = c_q3 * z436 + s_q3 * z435;
    const Scalar z397 = c_q3 * z392;
    const Scalar z372 = s_q2 * z367 - c_q2 * z362;
    const Scalar z484 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z487 = v_q2 * v_q2;
    const Scalar z488 = z39 * z39;
    const Scalar z482 = k42 * s_q2;
    const Scalar z486 = z39 * z40;
    const Scalar z485 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z438 = s_q3 * z437;
    const Scalar z483 = k42 * c_q2;
    const Scalar z489 = z487 + z488;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z399 = c_q3 * z394 + s_q3 * z396;
    const Scalar z439 = z420 + z438;
    const Scalar z440 = z416 - z438;
    const Scalar z442 = k43 * z392 - z439;
    const Scalar z443 = k43 * z392 - z440;
    const Scalar z398 = s_q3 * z392;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z494 = z483 - n632_over_165 * z489;
    const Scalar z446 = k44 - z442;
    const Scalar z450 = k45 - z443;
    const Scalar z448 = k46 - z441;
    const Scalar z491 = c_q3 * z484;
    const Scalar z455 = z424 - z446;
    const Scalar z406 = c_q2 * z395 + s_q2 * z401;
    const Scalar z498 = v_q3 * z56 - z491;  // angular acceleration of link3, x
    const Scalar z490 = n2 * z484;
    const Scalar z492 = s_q3 * z484;
    const Scalar z499 = v_q3 * z55 - z492;  // angular acceleration of link3, y
    const Scalar z495 = n632_over_165 * z490;
    const Scalar z505 = z55 * z57;
    const Scalar z493 = z482 + n632_over_165 * z486;
    const Scalar z500 = z56 * z56;
    const Scalar z501 = z57 * z57;
    const Scalar z506 = z499 + z505;
    const Scalar z496 = s_q3 * z495 - c_q3 * z493;
    const Scalar z497 = s_q3 * z493 + c_q3 * z495;
    const Scalar z502 = z500 + z501;
    const Scalar z511 = z494 + z506;
    const Scalar z516 = z79 * z79;
    const Scalar z517 = z80 * z80;
    const Scalar z503 = z55 * z56;
    const Scalar z509 = z496 - z502;
    const Scalar z518 = z516 + z517;
    const Scalar z519 = z78 * z79;
    const Scalar z524 = z78 * z80;
    const Scalar z526 = z79 * z80;
    const Scalar z522 = z78 * z78;
    const Scalar z512 = s_q4 * z511 + c_q4 * z509;
    const Scalar z513 = s_q4 * z509 - c_q4 * z511;
    const Scalar z523 = z517 + z522;
    const Scalar z543 = z118 * z118;
    const Scalar z544 = z119 * z119;
    const Scalar z447 = k47 + z429;
    const Scalar z456 = n2 * z447;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z559 = z138 * z138;
    const Scalar z560 = z139 * z139;
    const Scalar z457 = c_q2 * z456 + s_q2 * z455;
    const Scalar z562 = z137 * z138;
    const Scalar z565 = z137 * z137;
    const Scalar z561 = z559 + z560;
    const Scalar z566 = z560 + z565;
    const Scalar z546 = z117 * z118;
    const Scalar z567 = z137 * z139;
    const Scalar z569 = z138 * z139;
    const Scalar z548 = z117 * z119;
    const Scalar z572 = z560 - z565;
    const Scalar z571 = z559 - z560;
    const Scalar z545 = z543 + z544;
    const Scalar z458 = s_q2 * z457;
    const Scalar z449 = k48 + z430;
    const Scalar z575 = z559 - z565;
    const Scalar z454 = c_q2 * z449 + s_q2 * z448;
    const Scalar z589 = z118 * z119;
    const Scalar z460 = z424 - z458;
    const Scalar z587 = z117 * z117;
    const Scalar z592 = z544 - z587;
    const Scalar z595 = z543 - z587;
    const Scalar z591 = z543 - z544;
    const Scalar z588 = z544 + z587;
    const Scalar z468 = k49 + z460;
    const Scalar z651 = z56 * z57;
    const Scalar z649 = z55 * z55;
    const Scalar z656 = z499 - z505;
    const Scalar z668 = z40 * z40;
    const Scalar z1178 = c_q4 * z498;
    const Scalar z1181 = v_q4 * z79 - z1178;  // angular acceleration of link4, x
    const Scalar z1179 = s_q4 * z498;
    const Scalar z1182 = v_q4 * z78 + z1179;  // angular acceleration of link4, y
    const Scalar z1180 = z497 + z503;
    const Scalar z1187 = z518 - n256_over_55 * z519 + z512;
    const Scalar z1185 = c_q5 * z1181;
    const Scalar z1184 = z526 + z1181;
    const Scalar z1183 = z524 + z1182;
    const Scalar z1188 = n256_over_55 * z523 - z519 + z513;
    const Scalar z1192 = v_q5 * z103 + z1185;  // angular acceleration of link5, x
    const Scalar z1189 = z1180 + z1183 + n256_over_55 * z1184;
    const Scalar z607 = z104 * z104;
    const Scalar z609 = z102 * z103;
    const Scalar z1194 = c_q6 * z1192;
    const Scalar z1195 = s_q6 * z1192;
    const Scalar z612 = z102 * z102;
    const Scalar z606 = z103 * z103;
    const Scalar z616 = z103 * z104;
    const Scalar z614 = z102 * z104;
    const Scalar z1198 = v_q6 * z118 - z1194;  // angular acceleration of link6, x
    const Scalar z1199 = v_q6 * z117 - z1195;  // angular acceleration of link6, y
    const Scalar z1190 = c_q5 * z1187 + s_q5 * z1189;
    const Scalar z1191 = s_q5 * z1187 - c_q5 * z1189;
    const Scalar z1202 = s_q7 * z1198;
    const Scalar z1201 = c_q7 * z1198;
    const Scalar z1197 = c_q6 * z1188 + s_q6 * z1190;
    const Scalar z1209 = v_q7 * z137 + z1202;  // angular acceleration of link7, y
    const Scalar z1208 = v_q7 * z138 - z1201;  // angular acceleration of link7, x
    const Scalar z1200 = z548 + z1199;
    const Scalar z1196 = s_q6 * z1188 - c_q6 * z1190;
    const Scalar z1210 = z567 + z1209;
    const Scalar z1211 = z569 + z1208;
    const Scalar z1204 = n16_over_15 * z546 - z1197;
    const Scalar z1205 = z1191 + n16_over_15 * z1200;
    const Scalar z1203 = n16_over_15 * z545 + z1196;
    const Scalar z619 = z607 - z612;
    const Scalar z622 = z606 - z612;
    const Scalar z613 = z607 + z612;
    const Scalar z1186 = s_q5 * z1181;
    const Scalar z1193 = v_q5 * z102 + z1186;  // angular acceleration of link5, y
    const Scalar z1206 = s_q7 * z1205 - c_q7 * z1203;
    const Scalar z1207 = c_q7 * z1205 + s_q7 * z1203;
    const Scalar z618 = z606 - z607;
    const Scalar z608 = z606 + z607;
    const Scalar z1212 = z569 - z1208;
    const Scalar z1213 = z567 - z1209;
    const Scalar z1219 = k0 * z562 + k8 * z575 - k5 * z1212 - k4 * z1213 + k2 * z1206 + k3 * z1207;
    const Scalar z1215 = k3 * z562 - k2 * z566;
    const Scalar z1214 = k3 * z561 - k2 * z562;
    const Scalar z1218 = k4 * z562 + k5 * z572 - k3 * z1204 + k50 * z1210 - k8 * z1211;
    const Scalar z1217 = k5 * z562 - k4 * z571 + k2 * z1204 + k8 * z1210 - k51 * z1211;
    const Scalar z1216 = k3 * z1210 + k2 * z1211;
    const Scalar z634 = z517 - z522;
    const Scalar z637 = z516 - z522;
    const Scalar z633 = z516 - z517;
    const Scalar z1234 = k10 * z546 - z1216 + k13 * z588;
    const Scalar z1232 = z548 - z1199;
    const Scalar z1230 = z589 + z1198;
    const Scalar z1231 = z589 - z1198;
    const Scalar z652 = z498 + z651;
    const Scalar z655 = z498 - z651;
    const Scalar z654 = z501 - z649;
    const Scalar z653 = z500 - z501;
    const Scalar z650 = z501 + z649;
    const Scalar z1271 = z526 - z1181;
    const Scalar z657 = z500 - z649;
    const Scalar z1272 = z524 - z1182;
    const Scalar z1250 = z614 + z1193;
    const Scalar z1253 = z614 - z1193;
    const Scalar z1251 = z616 + z1192;
    const Scalar z1252 = z616 - z1192;
    const Scalar z1390 = k52 * z285;
    const Scalar z1389 = k52 * z291;
    const Scalar z670 = n2 * z485;
    const Scalar z1391 = k52 * z279;
    const Scalar z671 = z487 - z668;
    const Scalar z672 = z487 - z488;
    const Scalar z673 = z488 - z668;
    const Scalar z1403 = z279 * z1391 - z391;
    const Scalar z1402 = z285 * z1391 + z395;
    const Scalar z1399 = z285 * z1390 - z424;
    const Scalar z1398 = z291 * z1390 - z430;
    const Scalar z1401 = z291 * z1391 - z402;
    const Scalar z1396 = z291 * z1389 - z450;
    const Scalar z1395 = z295 * z1389 + z454;
    const Scalar z1397 = z295 * z1390 - z434;
    const Scalar z1400 = z295 * z1391 - z406;
    const Scalar z1393 = k52 * z267;
    const Scalar z1414 = z267 * z1393 - z308;
    const Scalar z1413 = z272 * z1393 - z312;
    const Scalar z1412 = z279 * z1393 - z319;
    const Scalar z1411 = z285 * z1393 + z325;
    const Scalar z1415 = n1 / z1414;
    const Scalar z1410 = z291 * z1393 + z331;
    const Scalar z1409 = z295 * z1393 - z335;
    const Scalar z1392 = k52 * z272;
    const Scalar z1408 = z272 * z1392 - z349;
    const Scalar z1407 = z279 * z1392 + z356;
    const Scalar z1406 = z285 * z1392 - z362;
    const Scalar z1405 = z291 * z1392 - z368;
    const Scalar z1404 = z295 * z1392 - z372;
    const Scalar z1388 = k52 * z295;
    const Scalar z1394 = z295 * z1388 - z468;
    const Scalar z1220 = u_tau7 - z1219;
    const Scalar z1484 = s_q7 * z1215 - c_q7 * z1214;
    const Scalar z1485 = c_q7 * z1215 + s_q7 * z1214;
    const Scalar z1488 = k13 * z546 - z1484 + k10 * z545;  // force on link6, times 0.0825 m, x
    const Scalar z1420 = z1413 * z1415;
    const Scalar z1419 = z1412 * z1415;
    const Scalar z1435 = z1408 - z1413 * z1420;
    const Scalar z1434 = z1407 - z1412 * z1420;
    const Scalar z1430 = z1403 - z1412 * z1419;
    const Scalar z1429 = z1402 - z1411 * z1419;
    const Scalar z1436 = n1 / z1435;
    const Scalar z1433 = z1406 - z1411 * z1420;
    const Scalar z1428 = z1401 - z1410 * z1419;
    const Scalar z1432 = z1405 - z1410 * z1420;
    const Scalar z1427 = z1400 - z1409 * z1419;
    const Scalar z1431 = z1404 - z1409 * z1420;
    const Scalar z1486 = s_q7 * z1218 + c_q7 * z1217;
    const Scalar z1487 = s_q7 * z1217 - c_q7 * z1218;
    const Scalar z1418 = z1411 * z1415;
    const Scalar z1426 = z1399 - z1411 * z1418;
    const Scalar z1425 = z1398 - z1410 * z1418;
    const Scalar z1424 = z1397 - z1409 * z1418;
    const Scalar z1417 = z1410 * z1415;
    const Scalar z1423 = z1396 - z1410 * z1417;
    const Scalar z1422 = z1395 - z1409 * z1417;
    const Scalar z1440 = z1434 * z1436;
    const Scalar z1439 = z1433 * z1436;
    const Scalar z1438 = z1432 * z1436;
    const Scalar z1450 = z1430 - z1434 * z1440;
    const Scalar z1449 = z1429 - z1433 * z1440;
    const Scalar z1446 = z1426 - z1433 * z1439;
    const Scalar z1445 = z1425 - z1432 * z1439;
    const Scalar z1451 = n1 / z1450;
    const Scalar z1448 = z1428 - z1432 * z1440;
    const Scalar z1443 = z1423 - z1432 * z1438;
    const Scalar z1442 = z1422 - z1431 * z1438;
    const Scalar z1444 = z1424 - z1431 * z1439;
    const Scalar z1447 = z1427 - z1431 * z1440;
    const Scalar z1416 = z1409 * z1415;
    // moment on link6, z
    const Scalar z1492 = k54 * z546 - k11 * z595 - k13 * z1196 - k10 * z1197 - n16_over_15 * z1216 + k16 * z1231 + k12
        * z1232 + z1487;
    // moment on link6, y
    const Scalar z1491 = k12 * z546 + k16 * z592 + k10 * z1191 + k55 * z1200 - k11 * z1230 - n16_over_15 * z1485
        + z1219;
    // moment on link6, x
    const Scalar z1490 = k16 * z546 - k12 * z591 + k13 * z1191 + k11 * z1200 - k56 * z1230 - z1486;
    const Scalar z1489 = k10 * z1200 - z1485 - k13 * z1230;  // force on link6, times 0.0825 m, z
    const Scalar z1421 = z1394 - z1409 * z1416;
    const Scalar z1498 = z1489 + k21 * z609 + k18 * z613;  // force on link5, times 0.0825 m, y
    // moment on link5, y
    const Scalar z1501 = k23 * z609 + k22 * z619 + k21 * z1188 - k57 * z1250 - k20 * z1251 + z1492;
    const Scalar z1493 = c_q6 * z1488 + s_q6 * z1234;
    const Scalar z1494 = s_q6 * z1488 - c_q6 * z1234;
    const Scalar z1497 = k18 * z609 - z1493 + k21 * z608;  // force on link5, times 0.0825 m, x
    const Scalar z1499 = k21 * z1250 - z1494 - k18 * z1251;  // force on link5, times 0.0825 m, z
    const Scalar z1495 = s_q6 * z1491 - c_q6 * z1490;
    // moment on link5, x
    const Scalar z1500 = k22 * z609 - k23 * z618 + k18 * z1188 + k20 * z1250 + k58 * z1251 - z1495;
    const Scalar z1496 = c_q6 * z1491 + s_q6 * z1490;
    // moment on link5, z
    const Scalar z1502 = k59 * z609 - k20 * z622 + k18 * z1190 - k21 * z1191 + k22 * z1252 + k23 * z1253 + z1496;
    const Scalar z1508 = z1499 + k30 * z519 - k29 * z523;  // force on link4, times 0.0825 m, y
    const Scalar z1503 = s_q5 * z1498 + c_q5 * z1497;
    const Scalar z1504 = s_q5 * z1497 - c_q5 * z1498;
    const Scalar z1507 = z1503 + k30 * z518 - k29 * z519;  // force on link4, times 0.0825 m, x
    const Scalar z1505 = s_q5 * z1501 - c_q5 * z1500;
    const Scalar z1506 = c_q5 * z1501 + s_q5 * z1500;
    const Scalar z1454 = z1449 * z1451;
    const Scalar z1460 = z1446 - z1449 * z1454;
    const Scalar z1459 = z1445 - z1448 * z1454;
    const Scalar z1458 = z1444 - z1447 * z1454;
    const Scalar z1509 = z1504 + k30 * z1183 + k29 * z1184;  // force on link4, times 0.0825 m, z
    const Scalar z1461 = n1 / z1460;
    const Scalar z1453 = z1448 * z1451;
    const Scalar z1457 = z1443 - z1448 * z1453;
    const Scalar z1456 = z1442 - z1447 * z1453;
    const Scalar z1437 = z1431 * z1436;
    // moment on link4, z
    const Scalar z1512 = k29 * z512 - k30 * z513 - k60 * z519 + k27 * z637 - k33 * z1271 + k28 * z1272 + z1499
        + n256_over_55 * z1503 - z1506;
    // moment on link4, x
    const Scalar z1510 = k33 * z519 + k28 * z633 + k29 * z1180 + k27 * z1183 + k61 * z1184 - z1505 + n256_over_55
        * z1504;
    // moment on link4, y
    const Scalar z1511 = k28 * z519 - k33 * z634 + k30 * z1180 + k62 * z1183 + k27 * z1184 + z1502 + z1504;
    const Scalar z1441 = z1421 - z1431 * z1437;
    const Scalar z1518 = z1509 + k38 * z503 - k36 * z650;  // force on link3, times 0.0825 m, y
    const Scalar z1513 = s_q4 * z1508 - c_q4 * z1507;
    const Scalar z1514 = c_q4 * z1508 + s_q4 * z1507;
    // moment on link3, y
    const Scalar z1521 = k38 * z494 - k37 * z503 + k63 * z506 + k35 * z652 + k40 * z654 - z1512 + z1514;
    const Scalar z1517 = z1513 + k38 * z502 - k36 * z503;  // force on link3, times 0.0825 m, x
    const Scalar z1515 = s_q4 * z1511 - c_q4 * z1510;
    const Scalar z1520 = k36 * z494 - k40 * z503 + k35 * z506 + k64 * z652 - k37 * z653 + z1515;  // moment on link3, x
    const Scalar z1516 = c_q4 * z1511 + s_q4 * z1510;
    // moment on link3, z
    const Scalar z1522 = k36 * z496 - k38 * z497 - k65 * z503 + k40 * z655 - k37 * z656 - k35 * z657 - z1509 + z1516;
    const Scalar z1525 = s_q3 * z1521 + c_q3 * z1520;
    const Scalar z1524 = s_q3 * z1517 - c_q3 * z1518;
    const Scalar z1523 = s_q3 * z1518 + c_q3 * z1517;
    const Scalar z1463 = z1459 * z1461;
    const Scalar z1466 = z1457 - z1459 * z1463;
    const Scalar z1465 = z1456 - z1458 * z1463;
    const Scalar z1452 = z1447 * z1451;
    // moment on link2, x
    const Scalar z1530 = k46 * z486 - k66 * z490 - k47 * z670 - k48 * z671 + z1525 + n632_over_165 * z1524;
    const Scalar z1531 = k48 * z486 - k47 * z490 - k67 * z670 - k46 * z672 - z1522;  // moment on link2, y
    const Scalar z1455 = z1441 - z1447 * z1452;
    const Scalar z1536 = s_q2 * z1530 - c_q2 * z1531;
    const Scalar z1526 = s_q3 * z1520 - c_q3 * z1521;
    // moment on link2, z
    const Scalar z1532 = k68 * z482 - k69 * z483 + k70 * z486 + k47 * z673 - z1526 + n632_over_165 * z1523;
    const Scalar z1544 = u_tau4 + z1512;
    const Scalar z1545 = u_tau5 + z1502;
    const Scalar z1541 = u_tau1 + z1536;
    const Scalar z1467 = n1 / z1466;
    const Scalar z1543 = u_tau3 + z1522;
    const Scalar z1542 = u_tau2 + z1532;
    const Scalar z1462 = z1458 * z1461;
    const Scalar z1464 = z1455 - z1458 * z1462;
    const Scalar z1546 = u_tau6 - z1492;
    const Scalar z1547 = z1220 * z1393 + z1546;
    const Scalar z1468 = z1465 * z1467;
    const Scalar z1469 = z1464 - z1465 * z1468;
    const Scalar z1548 = z1220 * z1392 - z1545 - z1420 * z1547;
    const Scalar z1470 = n1 / z1469;
    const Scalar z1549 = z1220 * z1391 - z1544 - z1419 * z1547 - z1440 * z1548;
    const Scalar z1550 = z1220 * z1390 - z1418 * z1547 - z1439 * z1548 + z1543 - z1454 * z1549;
    const Scalar z1551 = z1220 * z1389 - z1417 * z1547 - z1438 * z1548 - z1453 * z1549 - z1542 - z1463 * z1550;
    const Scalar z1552 = z1220 * z1388 - z1541 - z1416 * z1547 - z1437 * z1548 - z1452 * z1549 - z1462 * z1550 - z1468
        * z1551;
    const Scalar z1553 = z1470 * z1552;
    const Scalar z1554 = z1467 * z1551 - z1468 * z1553;
    const Scalar z1555 = z1461 * z1550 - z1462 * z1553 - z1463 * z1554;
    const Scalar z1556 = z1451 * z1549 - z1452 * z1553 - z1453 * z1554 - z1454 * z1555;
    const Scalar z1560 = z485 - z1555;
    const Scalar z1557 = z1436 * z1548 - z1437 * z1553 - z1438 * z1554 - z1439 * z1555 - z1440 * z1556;
    const Scalar z1561 = z499 - z1556;
    const Scalar z1558 = z1415 * z1547 - z1416 * z1553 - z1417 * z1554 - z1418 * z1555 - z1419 * z1556 - z1420 * z1557;
    const Scalar z1562 = z1182 + z1557;
    const Scalar z1559 = k52 * z1220 - z1388 * z1553 - z1389 * z1554 - z1390 * z1555 - z1391 * z1556 - z1392 * z1557
        - z1393 * z1558;
    const Scalar z1563 = z1193 - z1558;
    const Scalar z1564 = z1199 - z1559;
    accelerations.q1 = z1553;
    accelerations.q2 = z1554;
    accelerations.q3 = z1560;
    accelerations.q4 = -z1561;
    accelerations.q5 = z1562;
    accelerations.q6 = z1563;
    accelerations.q7 = -z1564;
    if (!(traits::regular(-z1469, z468) && traits::regular(-z1466, z450) && traits::regular(-z1460, z424)
        && traits::regular(-z1450, z391) && traits::regular(-z1435, z349) && traits::regular(-z1414,
        z308))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.q1 * accelerations.q2 * accelerations.q3 * accelerations.q4
        * accelerations.q5 * accelerations.q6 * accelerations.q7;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar k2 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k3 = traits::constant(0.00850351162402155, 0.008503512f, "170070232480431/20000000000000000");
    const Scalar k4 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k5 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k6 = traits::constant(0.028124284712194955, 0.028124284f, "7031071178048739/250000000000000000");
    const Scalar k7 = traits::constant(0.026534991901690206, 0.026534991f, "13267495950845103/500000000000000000");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar k9 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k10 = traits::constant(0.01857971472, 0.018579714f, "116123217/6250000000");
    const Scalar k11 = traits::constant(0.126729164208, 0.12672916f, "7920572763/62500000000");
    const Scalar k12 = traits::constant(0.088844724872, 0.088844724f, "11105590609/125000000000");
    const Scalar k13 = traits::constant(0.214708623208, 0.21470863f, "26838577901/125000000000");
    const Scalar k14 = traits::constant(3.228604, 3.228604f, "807151/250000");
    const Scalar k15 = traits::constant(0.05649492601407083, 0.056494925f, "3530932875879427/62500000000000000");
    const Scalar k16 = traits::constant(0.008248333140675744, 0.008248333f, "257760410646117/31250000000000000");
    const Scalar k17 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k18 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k19 = traits::constant(0.052878381999606115, 0.052878384f, "1652449437487691/31250000000000000");
    const Scalar k20 = traits::constant(0.01824920229252011, 0.018249203f, "1140575143282507/62500000000000000");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k23 = traits::constant(0.374644408005, 0.3746444f, "74928881601/200000000000");
    const Scalar k24 = traits::constant(0.09850206933, 0.09850207f, "9850206933/100000000000");
    const Scalar k25 = traits::constant(3.587895, 3.587895f, "717579/200000");
    const Scalar k26 = traits::constant(0.19076837715, 0.19076838f, "3815367543/20000000000");
    const Scalar k27 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k28 = traits::constant(0.06767727025085991, 0.06767727f, "13535454050171983/200000000000000000");
    const Scalar k29 = traits::constant(0.02771584317362585, 0.027715843f, "554316863472517/20000000000000000");
    const Scalar k30 = traits::constant(0.03239943042445132, 0.03239943f, "809985760611283/25000000000000000");
    const Scalar k31 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k32 = traits::constant(0.07758614905253959, 0.07758615f, "15517229810507919/200000000000000000");
    const Scalar k33 = traits::constant(0.023526756935, 0.023526756f, "4705351387/200000000000");
    const Scalar k34 = traits::constant(0.100241616695, 0.10024162f, "20048323339/200000000000");
    const Scalar k35 = traits::constant(0.05034347249, 0.050343473f, "5034347249/100000000000");
    const Scalar k36 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k37 = traits::constant(0.047121686402, 0.047121685f, "23560843201/500000000000");
    const Scalar k38 = traits::constant(1.225946, 1.225946f, "612973/500000");
    const Scalar k39 = traits::constant(0.03942757095803552, 0.03942757f, "9856892739508881/250000000000000000");
    const Scalar k40 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k41 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k42 = traits::constant(0.03146037232526039, 0.03146037f, "7865093081315097/250000000000000000");
    const Scalar k43 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k44 = traits::constant(0.010869510762828565, 0.0108695105f, "2717377690707141/250000000000000000");
    const Scalar k45 = traits::constant(0.017527158935, 0.01752716f, "3505431787/200000000000");
    const Scalar k46 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k47 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k48 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k49 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k50 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k51 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k52 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
    const Scalar k53 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k54 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k55 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k56 = traits::constant(0.735522, 0.735522f, "367761/500000");
    const Scalar k57 = traits::constant(0.015320008390949586, 0.015320009f, "7660004195474793/500000000000000000");
    const Scalar k58 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k59 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k60 = traits::constant(0.012899064612428356, 0.012899064f, "3224766153107089/250000000000000000");
    const Scalar k61 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k62 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k63 = traits::constant(0.004606581888605612, 0.0046065818f, "1151645472151403/250000000000000000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k65 = traits::constant(9.8177933583, 9.817793f, "98177933583/10000000000");
    const Scalar k66 = traits::constant(31.67260524, 31.672606f, "791815131/25000000");
    const Scalar k67 = traits::constant(35.19724995, 35.19725f, "703944999/20000000");
    const Scalar k68 = traits::constant(28.37543481, 28.375435f, "2837543481/100000000");
    const Scalar k69 = traits::constant(7.21547082, 7.215471f, "360773541/50000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar u_tau1 = inputs.tau1;
    const Scalar u_tau2 = inputs.tau2;
    const Scalar u_tau3 = inputs.tau3;
    const Scalar u_tau4 = inputs.tau4;
    const Scalar u_tau5 = inputs.tau5;
    const Scalar u_tau6 = inputs.tau6;
    const Scalar u_tau7 = inputs.tau7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z1713 = v_q1 * s_q2;
    const Scalar z1714 = v_q1 * c_q2;
    const Scalar z1717 = n0_316 * v_q2;
    const Scalar z1715 = n0_316 * c_q2;
    const Scalar z1716 = n0_333 + z1715;  // place of link3, z
    const Scalar z1718 = n0_316 * z1713;
    const Scalar z1719 = v_q2 * s_q3 - c_q3 * z1713;
    const Scalar z1720 = v_q2 * c_q3 + s_q3 * z1713;
    const Scalar z1721 = v_q3 + z1714;
    const Scalar z1751 = k2 * v_q2 - k3 * z1713 + k4 * z1714;
    const Scalar z1752 = k5 * v_q2 + k4 * z1713 - k6 * z1714;
    const Scalar z1753 = k7 * v_q2 - k2 * z1713 - k5 * z1714;
    const Scalar z1735 = c_q3 * z1717 + s_q3 * z1718;
    const Scalar z1736 = s_q3 * z1717 - c_q3 * z1718;
    const Scalar z1722 = n0_0825 * z1720;
    const Scalar z1723 = s_q4 * z1721 + c_q4 * z1719;
    const Scalar z1783 = k9 * s_q2 + k10 * c_q2;
    const Scalar z1724 = s_q4 * z1719 - c_q4 * z1721;
    const Scalar z1784 = k11 * s_q3 - k12 * c_q3;
    const Scalar z1725 = v_q4 - z1720;
    const Scalar z1785 = s_q2 * z1784 - k13 * c_q2;
    const Scalar z1737 = n0_0825 * z1721 - z1736;
    const Scalar z1738 = s_q4 * z1722 - c_q4 * z1735;
    const Scalar z1739 = s_q4 * z1735 + c_q4 * z1722;
    const Scalar z1754 = k11 * z1721 + k13 * z1720 - k14 * z1735;
    const Scalar z1755 = k12 * z1721 + k13 * z1719 - k14 * z1736;
    const Scalar z1756 = k15 * z1719 - k16 * z1720 - k17 * z1721 - k13 * z1736;
    const Scalar z1757 = k18 * z1721 + k16 * z1719 - k19 * z1720 + k13 * z1735;
    const Scalar z1758 = k17 * z1719 + k18 * z1720 - k20 * z1721 + k11 * z1735 + k12 * z1736;
    const Scalar z1728 = v_q5 - z1724;
    const Scalar z1727 = c_q5 * z1725 + s_q5 * z1723;
    const Scalar z1726 = s_q5 * z1725 - c_q5 * z1723;
    const Scalar z1731 = v_q6 + z1727;
    const Scalar z1740 = n0_384 * z1725 + z1738;
    const Scalar z1729 = s_q6 * z1728 - c_q6 * z1726;
    const Scalar z1742 = n0_384 * z1723 - z1737 - n0_0825 * z1724;
    const Scalar z1730 = s_q6 * z1726 + c_q6 * z1728;
    const Scalar z1732 = s_q7 * z1731 + c_q7 * z1729;
    const Scalar z1741 = n0_0825 * z1725 + z1739;
    const Scalar z1743 = c_q5 * z1740 + s_q5 * z1742;
    const Scalar z1744 = s_q5 * z1740 - c_q5 * z1742;
    const Scalar z1733 = s_q7 * z1729 - c_q7 * z1731;
    const Scalar z1793 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z1748 = n0_088 * z1730 + z1744;
    const Scalar z1759 = k23 * z1725 + k24 * z1724 + k25 * z1738;
    const Scalar z1760 = k26 * z1725 + k24 * z1723 + k25 * z1739;
    const Scalar z1761 = k23 * z1723 - k26 * z1724 - k25 * z1737;
    const Scalar z1762 = k27 * z1725 + k28 * z1723 - k29 * z1724 - k23 * z1737 + k24 * z1739;
    const Scalar z1763 = k29 * z1723 - k30 * z1724 - k31 * z1725 - k26 * z1737 - k24 * z1738;
    const Scalar z1734 = v_q7 - z1730;
    const Scalar z1764 = k32 * z1725 + k27 * z1723 + k31 * z1724 + k23 * z1738 + k26 * z1739;
    const Scalar z1795 = n0_0825 - z1793;
    const Scalar z1745 = s_q6 * z1741 + c_q6 * z1743;
    const Scalar z1746 = s_q6 * z1743 - c_q6 * z1741;
    const Scalar z1806 = k33 * s_q6 + k34 * c_q6;
    const Scalar z1800 = k35 * s_q5 + k36 * c_q5;
    const Scalar z1801 = k36 * s_q5 - k35 * c_q5;
    const Scalar z1796 = c_q3 * z1795;
    const Scalar z1765 = k37 * z1727 - k35 * z1728 - k38 * z1743;
    const Scalar z1766 = k37 * z1726 + k36 * z1728 - k38 * z1744;
    const Scalar z1767 = k35 * z1726 + k36 * z1727 + k38 * z1741;
    const Scalar z1768 = k39 * z1726 - k40 * z1727 + k41 * z1728 + k35 * z1741 - k37 * z1744;
    const Scalar z1769 = k40 * z1726 - k42 * z1727 + k43 * z1728 - k36 * z1741 + k37 * z1743;
    const Scalar z1794 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z1770 = k41 * z1726 - k43 * z1727 + k44 * z1728 + k35 * z1743 - k36 * z1744;
    const Scalar z1747 = n0_088 * z1731 + z1746;
    const Scalar z1807 = k34 * s_q6 - k33 * c_q6;
    const Scalar z1808 = k45 * s_q5 - c_q5 * z1806;
    const Scalar z1749 = s_q7 * z1748 + c_q7 * z1745;
    const Scalar z1809 = k45 * c_q5 + s_q5 * z1806;
    const Scalar z1797 = n0_316 - z1794;
    const Scalar z1798 = s_q2 * z1796 - c_q2 * z1797;
    const Scalar z1789 = k23 * s_q4 + k26 * c_q4;
    const Scalar z1750 = s_q7 * z1745 - c_q7 * z1748;
    const Scalar z1799 = n0_333 - z1798;
    const Scalar z1814 = n0_088 * c_q6;
    const Scalar z1791 = k24 * s_q3 - c_q3 * z1789;
    const Scalar z1771 = k45 * z1730 - k33 * z1731 + k46 * z1745;
    const Scalar z1772 = k45 * z1729 + k34 * z1731 + k46 * z1746;
    const Scalar z1773 = k33 * z1729 + k34 * z1730 + k46 * z1744;
    const Scalar z1774 = k47 * z1729 + k48 * z1730 - k49 * z1731 + k33 * z1744 + k45 * z1746;
    const Scalar z1775 = k50 * z1731 + k48 * z1729 + k51 * z1730 + k34 * z1744 + k45 * z1745;
    const Scalar z1815 = n0_088 * s_q6;
    const Scalar z1776 = k49 * z1729 - k50 * z1730 - k52 * z1731 + k33 * z1745 - k34 * z1746;
    const Scalar z1816 = c_q5 * z1814;
    const Scalar z1827 = k53 * s_q7 + k54 * c_q7;
    const Scalar z1819 = n0_384 + z1815;
    const Scalar z1818 = n0_0825 - z1816;
    const Scalar z1828 = k54 * s_q7 - k53 * c_q7;
    const Scalar z1829 = k55 * s_q6 + c_q6 * z1827;
    const Scalar z1830 = s_q6 * z1827 - k55 * c_q6;
    const Scalar z1817 = s_q5 * z1814;
    const Scalar z1820 = s_q4 * z1819 + c_q4 * z1818;
    const Scalar z1821 = s_q4 * z1818 - c_q4 * z1819;
    const Scalar z1831 = s_q5 * z1828 + c_q5 * z1829;
    const Scalar z1832 = s_q5 * z1829 - c_q5 * z1828;
    const Scalar z1810 = s_q4 * z1807 + c_q4 * z1808;
    const Scalar z1812 = s_q3 * z1809 + c_q3 * z1810;
    const Scalar z1822 = n0_0825 - z1820;
    const Scalar z1824 = n0_316 - z1821;
    const Scalar z1802 = k37 * s_q4 - c_q4 * z1800;
    const Scalar z1823 = s_q3 * z1817 - c_q3 * z1822;
    const Scalar z1833 = s_q4 * z1830 - c_q4 * z1831;
    const Scalar z1834 = c_q4 * z1830 + s_q4 * z1831;
    const Scalar z1786 = n0_0825 * c_q3;
    const Scalar z1804 = s_q3 * z1801 + c_q3 * z1802;
    const Scalar z1790 = k26 * s_q4 - k23 * c_q4;
    const Scalar z1792 = c_q2 * z1790 + s_q2 * z1791;
    const Scalar z1803 = k37 * c_q4 + s_q4 * z1800;
    const Scalar z1811 = s_q4 * z1808 - c_q4 * z1807;
    const Scalar z1835 = s_q3 * z1832 + c_q3 * z1833;
    const Scalar z1787 = s_q2 * z1786 - z1715;
    const Scalar z1825 = c_q2 * z1824 + s_q2 * z1823;
    const Scalar z1777 = k55 * z1733 - k53 * z1734 + k56 * z1749;
    const Scalar z1778 = k55 * z1732 - k54 * z1734 - k56 * z1750;
    const Scalar z1779 = k53 * z1732 - k54 * z1733 + k56 * z1747;
    const Scalar z1780 = k57 * z1732 + k58 * z1733 - k59 * z1734 + k53 * z1747 - k55 * z1750;
    const Scalar z1781 = k58 * z1732 + k60 * z1733 + k61 * z1734 - k54 * z1747 + k55 * z1749;
    const Scalar z1782 = k59 * z1732 - k61 * z1733 - k62 * z1734 + k53 * z1749 - k54 * z1750;
    const Scalar z1788 = n0_333 - z1787;
    const Scalar z1805 = c_q2 * z1803 + s_q2 * z1804;
    const Scalar z1813 = s_q2 * z1812 - c_q2 * z1811;
    const Scalar z1826 = n0_333 + z1825;
    const Scalar z1836 = c_q2 * z1834 + s_q2 * z1835;
    result.kinetic = k63 * v_q1 * v_q1 + n0_5 * (v_q2 * z1753 - z1713 * z1751 - z1714 * z1752 - z1735 * z1754 - z1736
        * z1755 - z1720 * z1757 + z1739 * z1760 + z1719 * z1756 + z1738 * z1759 - z1737 * z1761 - z1721 * z1758 + z1741
        * z1767 + z1723 * z1762 + z1725 * z1764 - z1724 * z1763 - z1743 * z1765 + z1726 * z1768 - z1727 * z1769 + z1728
        * z1770 + z1745 * z1771 - z1744 * (z1766 - z1773) + z1746 * z1772 + z1730 * z1775 + z1729 * z1774 - z1731
        * z1776 + z1747 * z1779 + z1749 * z1777 - z1750 * z1778 + z1732 * z1780 + z1733 * z1781 - z1734 * z1782);
    result.force_function = -k65 - k66 * z1716 - k67 * z1788 - k68 * z1799 - k69 * z1826 - n9_81 * (z1783 + z1785
        - z1792 - z1805 + z1813 + z1836);
    result.power = v_q1 * u_tau1 + v_q2 * u_tau2 + v_q3 * u_tau3 + v_q4 * u_tau4 + v_q5 * u_tau5 + v_q6 * u_tau6 + v_q7
        * u_tau7;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar k0 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k1 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k2 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k3 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k4 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k5 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k6 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k10 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k11 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k12 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k19 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k20 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k21 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k22 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k25 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k27 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k28 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k32 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k33 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k38 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar k43 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k44 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k45 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k46 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k47 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k48 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k49 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar k50 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k51 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k52 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k54 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k55 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k56 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k57 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k58 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k59 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k60 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k61 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k62 = traits::constant(0.01475269184007975, 0.014752692f, "14752691840079751/1000000000000000000");
    const Scalar k63 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k64 = traits::constant(0.0256820031989088, 0.025682002f, "8025625999659/312500000000000");
    const Scalar k65 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k66 = traits::constant(0.5866766710959985, 0.58667666f, "586676671095998483/1000000000000000000");
    const Scalar k67 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k68 = traits::constant(0.06802553512169374, 0.06802554f, "8503191890211717/125000000000000000");
    const Scalar k69 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k70 = traits::constant(0.0001790829744405, 0.00017908297f, "358165948881/2000000000000000");
    const Scalar k71 = traits::constant(1.0127011722584085, 1.0127012f, "15823455816537633/15625000000000000");
    const Scalar k72 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_q1 = state.v.q1;
    const Scalar a_q1 = accelerations.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar a_q2 = accelerations.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar a_q3 = accelerations.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar a_q4 = accelerations.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar a_q5 = accelerations.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar a_q6 = accelerations.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar a_q7 = accelerations.q7;
    const Scalar u_tau1 = inputs.tau1;
    const Scalar u_tau2 = inputs.tau2;
    const Scalar u_tau3 = inputs.tau3;
    const Scalar u_tau4 = inputs.tau4;
    const Scalar u_tau5 = inputs.tau5;
    const Scalar u_tau6 = inputs.tau6;
    const Scalar u_tau7 = inputs.tau7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z2883 = v_q1 * s_q2;
    const Scalar z2884 = v_q1 * c_q2;
    const Scalar z2929 = k0 * s_q7 - k1 * c_q7;
    const Scalar z2901 = k2 * s_q7 + k3 * c_q7;
    const Scalar z2902 = k4 * s_q7 - k5 * c_q7;
    const Scalar z2900 = k3 * s_q7 - k2 * c_q7;
    const Scalar z2903 = k5 * s_q7 + k4 * c_q7;
    const Scalar z2885 = v_q2 * s_q3 - c_q3 * z2883;
    const Scalar z2886 = v_q2 * c_q3 + s_q3 * z2883;
    const Scalar z2887 = v_q3 + z2884;
    const Scalar z2888 = s_q4 * z2887 + c_q4 * z2885;
    const Scalar z2889 = s_q4 * z2885 - c_q4 * z2887;
    const Scalar z2890 = v_q4 - z2886;
    const Scalar z2904 = k6 + n16_over_15 * z2901;
    const Scalar z2905 = c_q6 * z2900;
    const Scalar z2906 = s_q6 * z2900;
    const Scalar z2930 = s_q7 * z2929;
    const Scalar z2932 = k8 + c_q7 * z2929;
    const Scalar z2934 = k6 + n32_over_15 * z2901;
    const Scalar z2936 = k10 + z2901;
    const Scalar z2938 = k11 - z2902;
    const Scalar z2940 = k12 + z2903;
    const Scalar z2909 = s_q5 * z2901 - c_q5 * z2905;
    const Scalar z2910 = c_q5 * z2901 + s_q5 * z2905;
    const Scalar z2931 = k0 - z2930;
    const Scalar z2935 = n32_over_15 * z2901 + z2930;
    const Scalar z2942 = s_q6 * z2936 - k13 * c_q6;
    const Scalar z2943 = k13 * s_q6 + c_q6 * z2936;
    const Scalar z2907 = c_q6 * z2902 + s_q6 * z2904;
    const Scalar z2908 = s_q6 * z2902 - c_q6 * z2904;
    const Scalar z2933 = n16_over_15 * z2900 - z2932;
    const Scalar z2891 = s_q5 * z2890 - c_q5 * z2888;
    const Scalar z2892 = c_q5 * z2890 + s_q5 * z2888;
    const Scalar z2937 = k14 - z2931;
    const Scalar z2893 = v_q5 - z2889;
    const Scalar z2916 = s_q4 * z2906 + c_q4 * z2909;
    const Scalar z2917 = s_q4 * z2909 - c_q4 * z2906;
    const Scalar z2941 = k15 + z2935;
    const Scalar z2911 = s_q5 * z2903 - c_q5 * z2907;
    const Scalar z2912 = c_q5 * z2903 + s_q5 * z2907;
    const Scalar z2914 = z2908 + z2910;
    const Scalar z2939 = k16 + z2933;
    const Scalar z2894 = s_q6 * z2893 - c_q6 * z2891;
    const Scalar z2895 = s_q6 * z2891 + c_q6 * z2893;
    const Scalar z2896 = v_q6 + z2892;
    const Scalar z2946 = c_q5 * z2942;
    const Scalar z2947 = s_q5 * z2942;
    const Scalar z2922 = s_q3 * z2910 + c_q3 * z2916;
    const Scalar z2923 = s_q3 * z2916 - c_q3 * z2910;
    const Scalar z2944 = s_q6 * z2940 + c_q6 * z2939;
    const Scalar z2945 = s_q6 * z2939 - c_q6 * z2940;
    const Scalar z2915 = z2906 - n256_over_55 * z2909 - z2912;
    const Scalar z2913 = n256_over_55 * z2910 - z2911;
    const Scalar z2949 = c_q5 * z2941 + s_q5 * z2944;
    const Scalar z2897 = s_q7 * z2896 + c_q7 * z2894;
    const Scalar z2899 = v_q7 - z2895;
    const Scalar z2952 = z2943 - n256_over_55 * z2946 - z2949;
    const Scalar z2898 = s_q7 * z2894 - c_q7 * z2896;
    const Scalar z2966 = z2934 + z2937;
    const Scalar z2967 = n2 * z2938;
    const Scalar z2968 = s_q6 * z2966 - c_q6 * z2967;
    const Scalar z2976 = k19 - z2944;
    const Scalar z2974 = k20 - z2900;
    const Scalar z2973 = k21 - z2943;
    const Scalar z2948 = s_q5 * z2941 - c_q5 * z2944;
    const Scalar z2950 = n256_over_55 * z2947 + z2948;
    const Scalar z2951 = z2945 - z2947;
    const Scalar z2919 = c_q4 * z2914 + s_q4 * z2913;
    const Scalar z2921 = z2910 - z2919;
    const Scalar z2969 = s_q6 * z2968;
    const Scalar z2972 = c_q6 * z2968 + z2938;
    const Scalar z2970 = z2937 - z2969;
    const Scalar z2971 = z2934 - z2969;
    const Scalar z2977 = k22 + z2972;
    const Scalar z2956 = s_q4 * z2950 - c_q4 * z2951;
    const Scalar z2975 = k23 - z2970;
    const Scalar z2920 = z2915 + z2917;
    const Scalar z2954 = s_q4 * z2946 - c_q4 * z2943;
    const Scalar z2918 = s_q4 * z2914 - c_q4 * z2913;
    const Scalar z2979 = k24 + z2971;
    const Scalar z2958 = z2947 - z2956;
    const Scalar z2978 = k25 + z2945;
    const Scalar z2981 = s_q5 * z2974 + c_q5 * z2973;
    const Scalar z2980 = s_q5 * z2973 - c_q5 * z2974;
    const Scalar z2983 = s_q5 * z2977 - c_q5 * z2978;
    const Scalar z2982 = s_q5 * z2978 + c_q5 * z2977;
    const Scalar z2957 = z2952 + z2954;
    const Scalar z2924 = s_q3 * z2920 - c_q3 * z2918;
    const Scalar z2926 = n632_over_165 * z2923 - z2924;
    const Scalar z2984 = n256_over_55 * z2981 - z2982;
    const Scalar z2953 = s_q4 * z2943 + c_q4 * z2946;
    const Scalar z2955 = s_q4 * z2951 + c_q4 * z2950;
    const Scalar z2925 = c_q3 * z2920 + s_q3 * z2918;
    const Scalar z2986 = n256_over_55 * z2980 - z2983;
    const Scalar z2927 = n632_over_165 * z2922 - z2925;
    const Scalar z2985 = z2979 + z2981;
    const Scalar z2987 = c_q4 * z2980;
    const Scalar z2959 = s_q3 * z2947 - c_q3 * z2953;
    const Scalar z2962 = c_q3 * z2957 + s_q3 * z2955;
    const Scalar z2964 = n632_over_165 * z2959 + z2962;
    const Scalar z2960 = c_q3 * z2947 + s_q3 * z2953;
    const Scalar z2961 = s_q3 * z2957 - c_q3 * z2955;
    const Scalar z2963 = n632_over_165 * z2960 - z2961;
    const Scalar z2928 = s_q2 * z2926 - c_q2 * z2921;
    const Scalar z3008 = z2942 + n256_over_55 * z2981 - z2982;
    const Scalar z3015 = k27 + z3008;
    const Scalar z3001 = n2 * z2976;
    const Scalar z3000 = z2941 - z2975;
    const Scalar z3002 = c_q5 * z3001 + s_q5 * z3000;
    const Scalar z3010 = z2979 + n2 * z2981;
    const Scalar z3017 = k28 + z2986;
    const Scalar z3013 = k29 + z2942;
    const Scalar z3012 = k30 + z2981;
    const Scalar z3020 = s_q4 * z3013 + c_q4 * z3012;
    const Scalar z2990 = c_q4 * z2985 + s_q4 * z2984;
    const Scalar z2992 = z2981 - z2990;
    const Scalar z3003 = s_q5 * z3002;
    const Scalar z3006 = c_q5 * z3002 - z2976;
    const Scalar z3019 = s_q4 * z3012 - c_q4 * z3013;
    const Scalar z3009 = z2980 + z3006;
    const Scalar z3004 = z2975 + z3003;
    const Scalar z3005 = z2941 - z3003;
    const Scalar z2988 = s_q4 * z2980;
    const Scalar z3007 = n512_over_55 * z2942 + z3004;
    const Scalar z3011 = z3005 + n512_over_55 * z2942 + n2 * z2981;
    const Scalar z3016 = k32 + z3009;
    const Scalar z2989 = s_q4 * z2985 - c_q4 * z2984;
    const Scalar z3014 = k33 + z3007;
    const Scalar z3021 = s_q4 * z3017 + c_q4 * z3016;
    const Scalar z3022 = s_q4 * z3016 - c_q4 * z3017;
    const Scalar z3018 = k34 + z3011;
    const Scalar z2991 = z2986 - z2988;
    const Scalar z2994 = s_q3 * z2987 - c_q3 * z2981;
    const Scalar z2995 = c_q3 * z2989 + s_q3 * z2991;
    const Scalar z3023 = z3018 - z3020;
    const Scalar z2993 = s_q3 * z2981 + c_q3 * z2987;
    const Scalar z2997 = n632_over_165 * z2994 + z2995;
    const Scalar z2996 = s_q3 * z2989 - c_q3 * z2991;
    const Scalar z2998 = n632_over_165 * z2993 - z2996;
    const Scalar z3024 = c_q3 * z3019;
    const Scalar z2965 = c_q2 * z2958 + s_q2 * z2963;
    const Scalar z3031 = z3010 - z3014;
    const Scalar z3032 = n2 * z3015;
    const Scalar z3033 = s_q4 * z3031 - c_q4 * z3032;
    const Scalar z3038 = z2980 - z3021;
    const Scalar z3045 = k35 - z3038;
    const Scalar z3040 = z3018 - n2 * z3020;
    const Scalar z3043 = k36 - z2980;
    const Scalar z3047 = k37 + z3022;
    const Scalar z3042 = k38 - z3020;
    const Scalar z3057 = n2 * z3045;
    const Scalar z3050 = s_q3 * z3043 - c_q3 * z3042;
    const Scalar z3034 = s_q4 * z3033;
    const Scalar z3037 = c_q4 * z3033 + z3015;
    const Scalar z3027 = s_q3 * z3021 - c_q3 * z3023;
    const Scalar z3029 = n632_over_165 * z3024 + z3027;
    const Scalar z3039 = z3019 - z3037;
    const Scalar z3035 = z3014 + z3034;
    const Scalar z3036 = z3010 - z3034;
    const Scalar z3044 = k39 + z3035;
    const Scalar z3041 = n2 * z3020 - z3036;
    const Scalar z3046 = k40 - z3039;
    const Scalar z3049 = c_q3 * z3043 + s_q3 * z3042;
    const Scalar z3056 = z3040 - z3044;
    const Scalar z3048 = k41 - z3041;
    const Scalar z3051 = s_q3 * z3047 - c_q3 * z3046;
    const Scalar z3058 = c_q3 * z3057 + s_q3 * z3056;
    const Scalar z3052 = c_q3 * z3047 + s_q3 * z3046;
    const Scalar z3053 = n632_over_165 * z3050 + z3051;
    const Scalar z3054 = n632_over_165 * z3049 + z3052;
    const Scalar z3025 = s_q3 * z3019;
    const Scalar z3026 = c_q3 * z3021 + s_q3 * z3023;
    const Scalar z3028 = n632_over_165 * z3025 - z3026;
    const Scalar z2999 = s_q2 * z2997 - c_q2 * z2992;
    const Scalar z3081 = v_q2 * z2884;  // angular acceleration of link2, x
    const Scalar z3083 = z2883 * z2884;
    const Scalar z3084 = v_q2 * v_q2;
    const Scalar z3085 = z2883 * z2883;
    const Scalar z3079 = k42 * s_q2;
    const Scalar z3080 = k42 * c_q2;
    const Scalar z3086 = z3084 + z3085;
    const Scalar z3088 = z2886 * z2886;
    const Scalar z3089 = z2887 * z2887;
    const Scalar z3082 = v_q2 * z2883;  // angular acceleration of link2, y
    const Scalar z3087 = z3080 - n632_over_165 * z3086;
    const Scalar z3059 = s_q3 * z3058;
    const Scalar z3062 = c_q3 * z3058 - z3045;
    const Scalar z3069 = k43 - z3062;
    const Scalar z3060 = z3044 + z3059;
    const Scalar z3061 = z3040 - z3059;
    const Scalar z3068 = k44 + z3053;
    const Scalar z3063 = k45 * z3019 - z3060;
    const Scalar z3064 = k45 * z3019 - z3061;
    const Scalar z3074 = n2 * z3068;
    const Scalar z3070 = k46 + z3054;
    const Scalar z3030 = c_q2 * z3022 + s_q2 * z3028;
    const Scalar z3067 = k47 - z3063;
    const Scalar z3071 = k48 - z3064;
    const Scalar z3092 = z2885 * z2887;
    const Scalar z3090 = z3088 + z3089;
    const Scalar z3091 = z2885 * z2886;
    const Scalar z3093 = z2889 * z2889;
    const Scalar z3094 = z2890 * z2890;
    const Scalar z3096 = z2888 * z2889;
    const Scalar z3095 = z3093 + z3094;
    const Scalar z3100 = z2889 * z2890;
    const Scalar z3097 = z2888 * z2888;
    const Scalar z3098 = z3094 + z3097;
    const Scalar z3099 = z2888 * z2890;
    const Scalar z3107 = z2899 * z2899;
    const Scalar z3110 = z2897 * z2897;
    const Scalar z3101 = z2895 * z2895;
    const Scalar z3104 = z2894 * z2895;
    const Scalar z3106 = z2898 * z2898;
    const Scalar z3113 = z2898 * z2899;
    const Scalar z3109 = z2897 * z2898;
    const Scalar z3111 = z3107 + z3110;
    const Scalar z3112 = z2897 * z2899;
    const Scalar z3114 = z3106 - z3107;
    const Scalar z3102 = z2896 * z2896;
    const Scalar z3108 = z3106 + z3107;
    const Scalar z3103 = z3101 + z3102;
    const Scalar z3105 = z2894 * z2896;
    const Scalar z3073 = z3048 - z3067;
    const Scalar z3075 = c_q2 * z3074 + s_q2 * z3073;
    const Scalar z3055 = s_q2 * z3053 - c_q2 * z3048;
    const Scalar z3115 = z3107 - z3110;
    const Scalar z3117 = z2894 * z2894;
    const Scalar z3076 = s_q2 * z3075;
    const Scalar z3122 = z3101 - z3117;
    const Scalar z3119 = z2895 * z2896;
    const Scalar z3116 = z3106 - z3110;
    const Scalar z3120 = z3101 - z3102;
    const Scalar z3121 = z3102 - z3117;
    const Scalar z3118 = z3102 + z3117;
    const Scalar z3077 = z3048 - z3076;
    const Scalar z3123 = z2892 * z2892;
    const Scalar z3124 = z2893 * z2893;
    const Scalar z3072 = c_q2 * z3070 + s_q2 * z3069;
    const Scalar z3078 = k49 + z3077;
    const Scalar z3065 = k50 + z3050;
    const Scalar z3125 = z3123 + z3124;
    const Scalar z3066 = k51 - z3019;
    const Scalar z3147 = a_q1 * s_q2;
    const Scalar z3149 = v_q2 * z2884 + z3147;  // angular acceleration of link2, x
    const Scalar z3148 = a_q1 * c_q2;
    const Scalar z3150 = v_q2 * z2883 - z3148;  // angular acceleration of link2, y
    const Scalar z3151 = a_q2 - z3083;
    const Scalar z3155 = z3079 - n632_over_165 * z3151;
    const Scalar z3153 = a_q2 * s_q3 - c_q3 * z3149;
    const Scalar z3161 = a_q3 - z3150;  // angular acceleration of link3, z
    const Scalar z3152 = z3081 + z3149;
    const Scalar z3154 = a_q2 * c_q3 + s_q3 * z3149;
    const Scalar z3159 = v_q3 * z2886 + z3153;  // angular acceleration of link3, x
    const Scalar z3160 = v_q3 * z2885 - z3154;  // angular acceleration of link3, y
    const Scalar z3156 = n632_over_165 * z3152;
    const Scalar z3157 = s_q3 * z3156 - c_q3 * z3155;
    const Scalar z3158 = s_q3 * z3155 + c_q3 * z3156;
    const Scalar z3164 = s_q4 * z3161 + c_q4 * z3159;
    const Scalar z3163 = z3092 + z3160;
    const Scalar z3173 = a_q4 + z3160;  // angular acceleration of link4, z
    const Scalar z3171 = v_q4 * z2889 - z3164;  // angular acceleration of link4, x
    const Scalar z3165 = s_q4 * z3159 - c_q4 * z3161;
    const Scalar z3168 = z3087 + z3163;
    const Scalar z3172 = v_q4 * z2888 + z3165;  // angular acceleration of link4, y
    const Scalar z3162 = z3091 + z3161;
    const Scalar z3166 = z3090 - z3157;
    const Scalar z3174 = z3096 + z3173;
    const Scalar z3178 = s_q5 * z3173 + c_q5 * z3171;
    const Scalar z3167 = z3158 + z3162;
    const Scalar z3177 = z3100 + z3171;
    const Scalar z3185 = v_q5 * z2892 + z3178;  // angular acceleration of link5, x
    const Scalar z3169 = s_q4 * z3168 - c_q4 * z3166;
    const Scalar z3170 = c_q4 * z3168 + s_q4 * z3166;
    const Scalar z3175 = z3096 - z3173;
    const Scalar z3179 = s_q5 * z3171 - c_q5 * z3173;
    const Scalar z3176 = z3099 + z3172;
    const Scalar z3180 = z3095 - n256_over_55 * z3174 + z3169;
    const Scalar z3182 = z3167 + n256_over_55 * z3177 + z3176;
    const Scalar z3181 = n256_over_55 * z3098 - z3175 - z3170;
    const Scalar z3183 = c_q5 * z3180 + s_q5 * z3182;
    const Scalar z3184 = s_q5 * z3180 - c_q5 * z3182;
    const Scalar z3126 = z2891 * z2892;
    const Scalar z3186 = v_q5 * z2891 + z3179;  // angular acceleration of link5, y
    const Scalar z3127 = z2891 * z2891;
    const Scalar z3187 = a_q5 - z3172;  // angular acceleration of link5, z
    const Scalar z3130 = z2892 * z2893;
    const Scalar z3129 = z2891 * z2893;
    const Scalar z3133 = z3123 - z3127;
    const Scalar z3131 = z3123 - z3124;
    const Scalar z3132 = z3124 - z3127;
    const Scalar z3128 = z3124 + z3127;
    const Scalar z3189 = c_q6 * z3187 + s_q6 * z3185;
    const Scalar z3188 = s_q6 * z3187 - c_q6 * z3185;
    const Scalar z3191 = c_q6 * z3181 + s_q6 * z3183;
    const Scalar z3193 = v_q6 * z2894 - z3189;  // angular acceleration of link6, y
    const Scalar z3192 = v_q6 * z2895 + z3188;  // angular acceleration of link6, x
    const Scalar z3190 = s_q6 * z3181 - c_q6 * z3183;
    const Scalar z3134 = z3093 - z3094;
    const Scalar z3135 = z3094 - z3097;
    const Scalar z3194 = a_q6 - z3186;  // angular acceleration of link6, z
    const Scalar z3195 = z3104 + z3194;
    const Scalar z3136 = z3093 - z3097;
    const Scalar z3196 = z3105 + z3193;
    const Scalar z3137 = z2885 * z2885;
    const Scalar z3197 = s_q7 * z3194 + c_q7 * z3192;
    const Scalar z3142 = z3088 - z3137;
    const Scalar z3139 = z2886 * z2887;
    const Scalar z3140 = z3088 - z3089;
    const Scalar z3141 = z3089 - z3137;
    const Scalar z3138 = z3089 + z3137;
    const Scalar z3198 = s_q7 * z3192 - c_q7 * z3194;
    const Scalar z3200 = z3191 - n16_over_15 * z3195;
    const Scalar z3199 = n16_over_15 * z3103 + z3190;
    const Scalar z3201 = z3184 + n16_over_15 * z3196;
    const Scalar z3202 = s_q7 * z3201 - c_q7 * z3199;
    const Scalar z3145 = z3084 - z3085;
    const Scalar z3143 = z2884 * z2884;
    const Scalar z3203 = s_q7 * z3199 + c_q7 * z3201;
    const Scalar z3144 = z3084 - z3143;
    const Scalar z3204 = v_q7 * z2898 - z3197;  // angular acceleration of link7, x
    const Scalar z3205 = v_q7 * z2897 + z3198;  // angular acceleration of link7, y
    const Scalar z3146 = z3085 - z3143;
    const Scalar z3240 = z3099 - z3172;
    const Scalar z3249 = z3092 - z3160;
    const Scalar z3263 = k52 * z2903;
    const Scalar z3206 = a_q7 + z3193;  // angular acceleration of link7, z
    const Scalar z3222 = z3105 - z3193;
    const Scalar z3208 = z3109 - z3206;
    const Scalar z3207 = z3109 + z3206;
    const Scalar z3210 = z3113 + z3204;
    const Scalar z3262 = k52 * z2908;
    const Scalar z3209 = z3112 + z3205;
    const Scalar z3214 = k2 * z3111 - k3 * z3208;  // force on link7, times 0.0825 m, y
    const Scalar z3213 = k3 * z3108 - k2 * z3207;  // force on link7, times 0.0825 m, x
    const Scalar z3212 = z3112 - z3205;
    const Scalar z3211 = z3113 - z3204;
    // moment on link7, z
    const Scalar z3216 = k0 * z3109 + k8 * z3116 + k6 * z3206 - k5 * z3211 + k3 * z3203 + k2 * z3202 - k4 * z3212;
    const Scalar z3274 = z2928 * z3262 - z2999;
    const Scalar z3217 = s_q7 * z3214 + c_q7 * z3213;
    const Scalar z3215 = k2 * z3210 + k3 * z3209;  // force on link7, times 0.0825 m, z
    const Scalar z3224 = k13 * z3118 - z3215 + k10 * z3195;  // force on link6, times 0.0825 m, y
    const Scalar z3219 = z3104 - z3194;
    const Scalar z3223 = k10 * z3103 + z3217 + k13 * z3219;  // force on link6, times 0.0825 m, x
    const Scalar z3221 = z3119 - z3192;
    const Scalar z3218 = s_q7 * z3213 - c_q7 * z3214;
    const Scalar z3279 = z2928 * z3263 - z2965;
    const Scalar z3278 = z2908 * z3262 - z2979;
    const Scalar z3220 = z3119 + z3192;
    const Scalar z3284 = z2903 * z3263 - z2941;
    const Scalar z3283 = z2908 * z3263 - z2945;
    const Scalar z3228 = z3126 - z3187;
    const Scalar z3225 = k10 * z3196 - z3218 - k13 * z3220;  // force on link6, times 0.0825 m, z
    const Scalar z3285 = n1 / z3284;
    const Scalar z3229 = z3126 + z3187;
    const Scalar z3235 = k20 * z3128 + z3225 + k21 * z3229;  // force on link5, times 0.0825 m, y
    const Scalar z3239 = z3100 - z3171;
    const Scalar z3261 = k52 * z2915;
    const Scalar z3270 = z2928 * z3261 - z3030;
    const Scalar z3226 = c_q6 * z3223 + s_q6 * z3224;
    const Scalar z3234 = k21 * z3125 - z3226 + k20 * z3228;  // force on link5, times 0.0825 m, x
    const Scalar z3231 = z3130 + z3185;
    const Scalar z3277 = z2915 * z3262 + z2986;
    const Scalar z3282 = z2915 * z3263 - z2952;
    const Scalar z3232 = z3130 - z3185;
    const Scalar z3227 = s_q6 * z3223 - c_q6 * z3224;
    const Scalar z3230 = z3129 + z3186;
    const Scalar z3233 = z3129 - z3186;
    const Scalar z3236 = z3227 - k21 * z3230 + k20 * z3231;  // force on link5, times 0.0825 m, z
    const Scalar z3290 = z3283 * z3285;
    const Scalar z3273 = z2915 * z3261 - z3018;
    const Scalar z3289 = z3282 * z3285;
    const Scalar z3248 = z3139 - z3159;
    const Scalar z3237 = s_q5 * z3235 + c_q5 * z3234;
    const Scalar z3241 = z3237 + k30 * z3095 - k29 * z3174;  // force on link4, times 0.0825 m, x
    const Scalar z3242 = z3236 + k29 * z3098 - k30 * z3175;  // force on link4, times 0.0825 m, y
    const Scalar z3297 = z3270 - z3279 * z3289;
    const Scalar z3238 = s_q5 * z3234 - c_q5 * z3235;
    const Scalar z3300 = z3273 - z3282 * z3289;
    const Scalar z3301 = z3274 - z3279 * z3290;
    const Scalar z3260 = k52 * z2921;
    const Scalar z3267 = z2928 * z3260 - z3055;
    const Scalar z3272 = z2921 * z3261 + z3022;
    const Scalar z3276 = z2921 * z3262 - z2992;
    const Scalar z3281 = z2921 * z3263 + z2958;
    const Scalar z3299 = z3272 - z3281 * z3289;
    const Scalar z3246 = z3091 - z3161;
    const Scalar z3269 = z2921 * z3260 - z3048;
    const Scalar z3288 = z3281 * z3285;
    const Scalar z3296 = z3269 - z3281 * z3288;
    const Scalar z3294 = z3267 - z3279 * z3288;
    const Scalar z3247 = z3139 + z3159;
    const Scalar z3243 = z3238 + k29 * z3177 + k30 * z3176;  // force on link4, times 0.0825 m, z
    const Scalar z3303 = z3276 - z3281 * z3290;
    const Scalar z3251 = k36 * z3138 - z3243 - k38 * z3162;  // force on link3, times 0.0825 m, y
    const Scalar z3257 = z3082 - z3150;
    const Scalar z3255 = z3082 + z3150;
    const Scalar z3244 = s_q4 * z3242 + c_q4 * z3241;
    const Scalar z3304 = z3277 - z3282 * z3290;
    const Scalar z3250 = k38 * z3090 - z3244 - k36 * z3246;  // force on link3, times 0.0825 m, x
    const Scalar z3254 = a_q2 + z3083;
    const Scalar z3256 = z3081 - z3149;
    const Scalar z3245 = s_q4 * z3241 - c_q4 * z3242;
    const Scalar z3305 = z3278 - z3283 * z3290;
    const Scalar z3306 = n1 / z3305;
    const Scalar z3259 = k52 * z2927;
    const Scalar z3265 = z2928 * z3259 + z3072;
    const Scalar z3268 = z2927 * z3260 - z3054;
    const Scalar z3271 = z2927 * z3261 - z3029;
    const Scalar z3275 = z2927 * z3262 - z2998;
    const Scalar z3280 = z2927 * z3263 + z2964;
    const Scalar z3295 = z3268 - z3280 * z3288;
    const Scalar z3298 = z3271 - z3280 * z3289;
    const Scalar z3302 = z3275 - z3280 * z3290;
    const Scalar z3266 = z2927 * z3259 - z3071;
    const Scalar z3287 = z3280 * z3285;
    const Scalar z3293 = z3266 - z3280 * z3287;
    const Scalar z3292 = z3265 - z3279 * z3287;
    const Scalar z3253 = c_q3 * z3251 + s_q3 * z3250;
    const Scalar z3310 = z3304 * z3306;
    const Scalar z3309 = z3303 * z3306;
    const Scalar z3308 = z3302 * z3306;
    const Scalar z3258 = k52 * z2928;
    const Scalar z3264 = z2928 * z3258 - z3078;
    const Scalar z3286 = z3279 * z3285;
    const Scalar z3307 = z3301 * z3306;
    const Scalar z3252 = s_q3 * z3251 - c_q3 * z3250;
    // moment on link7, x
    const Scalar z3341 = k6 * z3113 + k4 * z3114 + k2 * z3200 + k0 * z3204 - k5 * z3208 - k8 * z3209;
    const Scalar z3342 = k54 * z3112 + k5 * z3115 + k3 * z3200 + k4 * z3207 - k8 * z3210;  // moment on link7, y
    // moment on link6, y
    const Scalar z3346 = k55 * z3105 + k16 * z3121 + k10 * z3184 + k12 * z3219 - k11 * z3220 - n16_over_15 * z3218
        + z3216;
    const Scalar z3320 = z3300 - z3304 * z3310;
    const Scalar z3291 = z3264 - z3279 * z3286;
    const Scalar z3319 = z3299 - z3303 * z3310;
    const Scalar z3316 = z3296 - z3303 * z3309;
    const Scalar z3321 = n1 / z3320;
    const Scalar z3315 = z3295 - z3302 * z3309;
    const Scalar z3318 = z3298 - z3302 * z3310;
    const Scalar z3313 = z3293 - z3302 * z3308;
    const Scalar z3312 = z3292 - z3301 * z3308;
    const Scalar z3314 = z3294 - z3301 * z3309;
    const Scalar z3317 = z3297 - z3301 * z3310;
    const Scalar z3311 = z3291 - z3301 * z3307;
    const Scalar z3379 = z3093 + z3097;
    const Scalar z3371 = z3085 + z3143;
    const Scalar z3375 = z3088 + z3137;
    const Scalar z3378 = n2 * z2887;
    const Scalar z3380 = n2 * z2888;
    const Scalar z3381 = n2 * z2889;
    const Scalar z3343 = s_q7 * z3342 - c_q7 * z3341;
    // moment on link6, x
    const Scalar z3345 = k15 * z3119 + k12 * z3120 - k13 * z3184 - k14 * z3192 - k16 * z3195 - k11 * z3196 + z3343;
    const Scalar z3344 = c_q7 * z3342 + s_q7 * z3341;
    // moment on link6, z
    const Scalar z3347 = k14 * z3104 - k11 * z3122 + k15 * z3194 - k13 * z3190 - k10 * z3191 + k16 * z3221 + k12 * z3222
        - n16_over_15 * z3215 - z3344;
    // moment on link5, y
    const Scalar z3351 = k56 * z3129 - k22 * z3132 - k21 * z3181 - k25 * z3228 + k19 * z3231 - z3347;
    const Scalar z3348 = c_q6 * z3345 + s_q6 * z3346;
    // moment on link5, x
    const Scalar z3350 = k24 * z3130 - k25 * z3131 + k20 * z3181 + k23 * z3185 + k22 * z3229 + k19 * z3230 - z3348;
    const Scalar z3349 = s_q6 * z3345 - c_q6 * z3346;
    // moment on link5, z
    const Scalar z3352 = k23 * z3126 - k19 * z3133 + k20 * z3183 - k21 * z3184 - k24 * z3187 + k22 * z3232 + k25 * z3233
        - z3349;
    // moment on link4, y
    const Scalar z3356 = k57 * z3099 - k32 * z3135 + k28 * z3174 + k30 * z3167 + k27 * z3177 + z3352 + z3238;
    const Scalar z3353 = s_q5 * z3351 + c_q5 * z3350;
    // moment on link4, x
    const Scalar z3355 = k34 * z3100 + k28 * z3134 + k32 * z3175 + k29 * z3167 + k33 * z3171 + k27 * z3176 + z3353
        + n256_over_55 * z3238;
    const Scalar z3376 = n2 * z2885;
    const Scalar z3377 = n2 * z2886;
    const Scalar z3354 = s_q5 * z3350 - c_q5 * z3351;
    // moment on link4, z
    const Scalar z3357 = k33 * z3096 + k34 * z3173 - k27 * z3136 + k32 * z3239 - k29 * z3169 - k30 * z3170 - k28 * z3240
        + z3236 - n256_over_55 * z3237 + z3354;
    // moment on link3, y
    const Scalar z3361 = k58 * z3092 + k38 * z3087 + k40 * z3141 - k37 * z3246 + k35 * z3247 + z3357 + z3245;
    const Scalar z3358 = s_q4 * z3356 - c_q4 * z3355;
    // moment on link3, x
    const Scalar z3360 = k36 * z3087 + k41 * z3139 - k37 * z3140 + k39 * z3159 - k40 * z3162 + k35 * z3163 + z3358;
    const Scalar z3359 = c_q4 * z3356 + s_q4 * z3355;
    // moment on link3, z
    const Scalar z3362 = k39 * z3091 - k41 * z3161 - k35 * z3142 - k40 * z3248 + k37 * z3249 + k36 * z3157 - k38 * z3158
        - z3243 + z3359;
    const Scalar z3366 = k59 * z3082 + k43 * z3145 + k46 * z3151 + k44 * z3152 + z3362;  // moment on link2, y
    const Scalar z3324 = z3319 * z3321;
    const Scalar z3330 = z3316 - z3319 * z3324;
    const Scalar z3329 = z3315 - z3318 * z3324;
    const Scalar z3328 = z3314 - z3317 * z3324;
    const Scalar z3374 = n2 * v_q2;
    const Scalar z3372 = n2 * z2883;
    const Scalar z3331 = n1 / z3330;
    const Scalar z3363 = c_q3 * z3360 + s_q3 * z3361;
    // moment on link2, x
    const Scalar z3365 = k48 * z3081 + k47 * z3149 + k46 * z3144 - k43 * z3254 + k44 * z3255 - z3363 - n632_over_165
        * z3253;
    const Scalar z3373 = n2 * z2884;
    const Scalar z3323 = z3318 * z3321;
    const Scalar z3327 = z3313 - z3318 * z3323;
    const Scalar z3326 = z3312 - z3317 * z3323;
    const Scalar z3322 = z3317 * z3321;
    const Scalar z3383 = z3123 + z3127;
    const Scalar z3325 = z3311 - z3317 * z3322;
    const Scalar z3391 = z3106 + z3110;
    const Scalar z3387 = z3101 + z3117;
    const Scalar z3390 = n2 * z2896;
    const Scalar z3386 = n2 * z2893;
    const Scalar z3382 = n2 * z2890;
    const Scalar z3389 = n2 * z2895;
    const Scalar z3388 = n2 * z2894;
    const Scalar z3384 = n2 * z2891;
    const Scalar z3385 = n2 * z2892;
    const Scalar z3333 = z3329 * z3331;
    const Scalar z3336 = z3327 - z3329 * z3333;
    const Scalar z3335 = z3326 - z3328 * z3333;
    const Scalar z3332 = z3328 * z3331;
    const Scalar z3334 = z3325 - z3328 * z3332;
    const Scalar z3394 = n2 * z2899;
    const Scalar z3337 = n1 / z3336;
    const Scalar z3392 = n2 * z2897;
    const Scalar z3393 = n2 * z2898;
    const Scalar z3395 = k4 * z3392;
    const Scalar z3396 = k5 * z3393;
    const Scalar z3397 = k8 * z3394;
    const Scalar z3370 = n2 * v_q1;
    const Scalar z3364 = s_q3 * z3360 - c_q3 * z3361;
    // moment on link2, z
    const Scalar z3367 = k48 * a_q2 - k51 * z3079 + k50 * z3080 - k47 * z3083 - k44 * z3146 + k43 * z3256 - k46 * z3257
        + z3364 + n632_over_165 * z3252;
    const Scalar z3338 = z3335 * z3337;
    const Scalar z3398 = k2 * z3394;
    const Scalar z3368 = s_q2 * z3365 - c_q2 * z3366;
    const Scalar z3369 = k49 * a_q1 + z3368;  // moment on link1, z
    const Scalar z3339 = z3334 - z3335 * z3338;
    const Scalar z3399 = k3 * z3394;
    const Scalar z3340 = n1 / z3339;
    const Scalar z3407 = k8 * z3392;
    const Scalar z3402 = k60 * z3394 + k4 * z3393;
    const Scalar z3404 = k5 * z3392 - k61 * z3394;
    const Scalar z3409 = k60 * z3392 + k8 * z3393;
    const Scalar z3401 = z3396 + z3397;
    const Scalar z3405 = z3395 - z3397;
    const Scalar z3408 = k61 * z3393 + z3407;
    const Scalar z3416 = z3402 + z3404;
    const Scalar z3415 = z3401 - z3405;
    const Scalar z3411 = n16_over_15 * z3390;
    const Scalar z3419 = s_q7 * z3409 - c_q7 * z3408;
    const Scalar z3421 = c_q7 * z3416 + s_q7 * z3415;
    const Scalar z3406 = k5 * z3394 + k61 * z3392;
    const Scalar z3403 = k61 * z3393 - k4 * z3394;
    const Scalar z3400 = k2 * z3392 - k3 * z3393;
    const Scalar z3422 = s_q7 * z3421;
    const Scalar z3412 = n16_over_15 * z3389;
    const Scalar z3417 = s_q7 * z3406 - c_q7 * z3403;
    const Scalar z3426 = c_q7 * z3421 - z3402;
    const Scalar z3425 = c_q7 * z3421 - z3404;
    const Scalar z3439 = k62 * z3390 - z3417 + k12 * z3389;
    const Scalar z3440 = z3425 + k63 * z3389 - k12 * z3390;
    const Scalar z3428 = z3419 + z2901 * z3411 + n16_over_15 * z3400;
    const Scalar z3441 = k16 * z3388 - z3428 - k63 * z3390;
    const Scalar z3413 = s_q7 * z3399 - c_q7 * z3398;
    const Scalar z3423 = z3401 - z3422;
    const Scalar z3427 = n16_over_15 * z3413 + z3423;
    const Scalar z3424 = z3405 + z3422;
    const Scalar z3431 = z2900 * z3412 + z3424;
    const Scalar z3420 = s_q7 * z3408 + c_q7 * z3409;
    const Scalar z3429 = z2900 * z3411 - z3420;
    const Scalar z3414 = s_q7 * z3398 + c_q7 * z3399;
    const Scalar z3430 = z3426 + z2901 * z3412 - n16_over_15 * z3414;
    const Scalar z3432 = k12 * z3388;
    const Scalar z3433 = k16 * z3389;
    const Scalar z3446 = z3432 + z3433 + z3431;
    const Scalar z3444 = z3430 + k11 * z3388 + k63 * z3389;
    const Scalar z3434 = k11 * z3390;
    const Scalar z3438 = z3427 - z3433 - z3434;
    const Scalar z3418 = c_q7 * z3406 + s_q7 * z3403;
    const Scalar z3445 = k62 * z3388 - z3418 + k11 * z3389;
    const Scalar z3410 = z3395 + z3396;
    const Scalar z3442 = z3432 - z3434 + z3410;
    const Scalar z3450 = z3439 + z3441;
    const Scalar z3443 = z3429 + k16 * z3390 + k63 * z3388;
    const Scalar z3449 = z3438 + z3442;
    const Scalar z3461 = k25 * z3384;
    const Scalar z3462 = k22 * z3385;
    const Scalar z3463 = k19 * z3386;
    const Scalar z3436 = k10 * z3390 + z3400;
    const Scalar z3455 = c_q6 * z3450 + s_q6 * z3449;
    const Scalar z3435 = k13 * z3390 - z3413;
    const Scalar z3451 = s_q6 * z3443 + c_q6 * z3440;
    const Scalar z3468 = z3451 + k25 * z3385 - k64 * z3386;
    const Scalar z3456 = s_q6 * z3455;
    const Scalar z3453 = s_q6 * z3445 + c_q6 * z3444;
    const Scalar z3454 = s_q6 * z3444 - c_q6 * z3445;
    const Scalar z3457 = z3438 - z3456;
    const Scalar z3467 = z3462 + z3463 + z3457;
    const Scalar z3471 = z3461 - z3463 + z3446;
    const Scalar z3458 = z3442 - z3456;
    const Scalar z3475 = z3461 + z3462 + z3458;
    const Scalar z3459 = c_q6 * z3455 - z3441;
    const Scalar z3460 = c_q6 * z3455 - z3439;
    const Scalar z3469 = k65 * z3385 - z3459 + k25 * z3386;
    const Scalar z3473 = z3460 + k19 * z3384 - k65 * z3385;
    const Scalar z3437 = k13 * z3388 - z3414 + k10 * z3389;
    const Scalar z3452 = s_q6 * z3440 - c_q6 * z3443;
    const Scalar z3474 = k64 * z3384 - z3452 - k19 * z3385;
    const Scalar z3447 = s_q6 * z3436 - c_q6 * z3435;
    const Scalar z3464 = k20 * z3386 + z3447;
    const Scalar z3465 = k21 * z3386 - z3437;
    const Scalar z3470 = z3453 + k22 * z3384 + k65 * z3386;
    const Scalar z3472 = k65 * z3384 - z3454 - k22 * z3386;
    const Scalar z3480 = z3467 - z3471;
    const Scalar z3448 = c_q6 * z3436 + s_q6 * z3435;
    const Scalar z3466 = k20 * z3384 - z3448 + k21 * z3385;
    const Scalar z3481 = z3468 + z3470;
    const Scalar z3486 = s_q5 * z3480 - c_q5 * z3481;
    const Scalar z3477 = n256_over_55 * z3380 - z3381;
    const Scalar z3479 = c_q5 * z3465 + s_q5 * z3464;
    const Scalar z3476 = n256_over_55 * z3382;
    const Scalar z3482 = s_q5 * z3472 + c_q5 * z3469;
    const Scalar z3483 = s_q5 * z3469 - c_q5 * z3472;
    const Scalar z3499 = z2942 * z3477 - z3483 + n256_over_55 * z3479;
    const Scalar z3478 = s_q5 * z3465 - c_q5 * z3464;
    const Scalar z3493 = z2942 * z3476 - z3482 - n256_over_55 * z3478;
    const Scalar z3491 = c_q5 * z3486 + z3468;
    const Scalar z3498 = z2981 * z3477 + z3479 - z3491;
    const Scalar z3508 = z3493 + k66 * z3382 + k28 * z3381;
    const Scalar z3513 = z3498 + k27 * z3380 - k67 * z3381;
    const Scalar z3506 = z3479 + k29 * z3380 - k30 * z3381;
    const Scalar z3514 = z3499 + k66 * z3380 - k27 * z3381;
    const Scalar z3487 = s_q5 * z3486;
    const Scalar z3490 = c_q5 * z3486 + z3470;
    const Scalar z3494 = z2980 * z3476 - z3490;
    const Scalar z3484 = s_q5 * z3474 - c_q5 * z3473;
    const Scalar z3485 = c_q5 * z3474 + s_q5 * z3473;
    const Scalar z3497 = z2980 * z3382 - z3485;
    const Scalar z3509 = k67 * z3381 - z3494 - k28 * z3382;
    const Scalar z3488 = z3467 - z3487;
    const Scalar z3492 = z2981 * z3476 - z3478 - z3488;
    const Scalar z3489 = z3471 + z3487;
    const Scalar z3504 = k29 * z3382 - z3478;
    const Scalar z3500 = z2980 * z3477 - z3489;
    const Scalar z3501 = k28 * z3380;
    const Scalar z3502 = k32 * z3381;
    const Scalar z3503 = k27 * z3382;
    const Scalar z3507 = z3503 + z3502 + z3492;
    const Scalar z3515 = z3501 - z3502 + z3500;
    const Scalar z3495 = z2981 * z3382 + z3466 + z3484;
    const Scalar z3510 = z3495 + k67 * z3382 + k32 * z3380;
    const Scalar z3496 = z2942 * z3382 - z3475 + n256_over_55 * z3466;
    const Scalar z3511 = z3503 + z3501 + z3496;
    const Scalar z3512 = k67 * z3380 - z3497 - k32 * z3382;
    const Scalar z3518 = z3507 + z3511;
    const Scalar z3505 = k30 * z3382 + z3466;
    const Scalar z3519 = z3508 - z3510;
    const Scalar z3522 = c_q4 * z3513 + s_q4 * z3514;
    const Scalar z3523 = s_q4 * z3513 - c_q4 * z3514;
    const Scalar z3524 = s_q4 * z3518 - c_q4 * z3519;
    const Scalar z3533 = z3019 * z3378 - z3523;
    const Scalar z3520 = s_q4 * z3512 - c_q4 * z3509;
    const Scalar z3544 = z3520 + k37 * z3377 - k68 * z3378;
    const Scalar z3531 = z3020 * z3378 + z3506 - z3522;
    const Scalar z3546 = z3531 + k40 * z3376 - k69 * z3378;
    const Scalar z3525 = s_q4 * z3524;
    const Scalar z3517 = c_q4 * z3505 + s_q4 * z3504;
    const Scalar z3521 = c_q4 * z3512 + s_q4 * z3509;
    const Scalar z3535 = z2980 * z3377 - z3521;
    const Scalar z3528 = c_q4 * z3524 - z3510;
    const Scalar z3529 = c_q4 * z3524 + z3508;
    const Scalar z3534 = z3020 * z3377 - z3517 + z3529;
    const Scalar z3545 = k37 * z3378 - z3528 + k69 * z3377;
    const Scalar z3550 = z3535 + k68 * z3376 - k35 * z3377;
    const Scalar z3549 = z3534 + k35 * z3376 - k69 * z3377;
    const Scalar z3542 = k36 * z3376 - z3517 - k38 * z3377;
    const Scalar z3516 = s_q4 * z3505 - c_q4 * z3504;
    const Scalar z3526 = z3507 - z3525;
    const Scalar z3530 = z3516 + z3526;
    const Scalar z3540 = k36 * z3378 - z3516;
    const Scalar z3527 = z3511 - z3525;
    const Scalar z3536 = z3019 * z3377 - z3527;
    const Scalar z3537 = k37 * z3376;
    const Scalar z3538 = k40 * z3377;
    const Scalar z3539 = k35 * z3378;
    const Scalar z3543 = z3538 - z3539 + z3530;
    const Scalar z3532 = z2980 * z3378 - z3515;
    const Scalar z3547 = z3537 - z3539 + z3532;
    const Scalar z3551 = z3537 - z3538 + z3536;
    const Scalar z3593 = k70 * z3370;
    const Scalar z3548 = k40 * z3378 - z3533 + k69 * z3376;
    const Scalar z3557 = z3544 - z3546;
    const Scalar z3541 = k38 * z3378 - z3506;
    const Scalar z3556 = z3543 + z3547;
    const Scalar z3603 = z3048 * z3256;
    const Scalar z3562 = c_q3 * z3557 + s_q3 * z3556;
    const Scalar z3552 = n632_over_165 * z3374;
    const Scalar z3558 = s_q3 * z3548 + c_q3 * z3545;
    const Scalar z3553 = n632_over_165 * z3372;
    const Scalar z3559 = s_q3 * z3545 - c_q3 * z3548;
    const Scalar z3554 = s_q3 * z3541 + c_q3 * z3540;
    const Scalar z3569 = z3558 + z3019 * z3552 + n632_over_165 * z3554;
    const Scalar z3563 = s_q3 * z3562;
    const Scalar z3560 = s_q3 * z3550 - c_q3 * z3549;
    const Scalar z3555 = s_q3 * z3540 - c_q3 * z3541;
    const Scalar z3573 = z3559 + z3019 * z3553 + n632_over_165 * z3555;
    const Scalar z3579 = z3569 + k46 * z3373 - k71 * z3374;
    const Scalar z3585 = k71 * z3372 - z3573 - k44 * z3373;
    const Scalar z3619 = z2886 * z3542 - z3019 * z3249 + z3042 * z3375 + z3250;
    const Scalar z3618 = z2885 * z3542 + z3019 * z3248 - z3043 * z3375 - z3251;
    const Scalar z3612 = z2885 * z3550 - z3043 * z3158 - z3042 * z3157 - z3047 * z3248 - z3046 * z3249 - z3048 * z3375
        - z2886 * z3549;
    const Scalar z3561 = c_q3 * z3550 + s_q3 * z3549;
    const Scalar z3571 = n632_over_165 * z3542 + z3551;
    const Scalar z3621 = z3019 * z3158;
    const Scalar z3564 = z3543 - z3563;
    const Scalar z3565 = z3547 - z3563;
    const Scalar z3568 = z3050 * z3552 - z3564;
    const Scalar z3574 = z3049 * z3553 - z3565;
    const Scalar z3575 = k46 * z3372;
    const Scalar z3576 = k43 * z3373;
    const Scalar z3577 = k44 * z3374;
    const Scalar z3578 = z3577 - z3576 + z3568;
    const Scalar z3586 = z3575 - z3576 + z3574;
    const Scalar z3582 = z3577 - z3575 + z3571;
    const Scalar z3567 = c_q3 * z3562 - z3544;
    const Scalar z3572 = z3050 * z3553 - z3567;
    const Scalar z3566 = c_q3 * z3562 + z3546;
    const Scalar z3570 = z3049 * z3552 + z3566;
    const Scalar z3630 = z3019 * z3376 - z3541;
    const Scalar z3584 = z3572 + k44 * z3372 - k72 * z3373;
    const Scalar z3631 = z3019 * z3377 - z3540;
    const Scalar z3632 = z3545 + z3045 * z3376 + z3044 * z3377;
    const Scalar z3633 = z3548 + z3045 * z3377 + z3040 * z3376;
    const Scalar z3580 = z3570 + k46 * z3374 + k72 * z3373;
    const Scalar z3600 = z2883 * z3585 - z2884 * z3584 - z3065 * z3079 - z3066 * z3080 - z3069 * z3257 - z3070 * z3256
        - z3071 * z3371;
    const Scalar z3589 = c_q2 * z3585 + s_q2 * z3584;
    const Scalar z3606 = z3580 + z3068 * z3372 + z3067 * z3373;
    const Scalar z3581 = k43 * z3372 - z3560 - k72 * z3374;
    const Scalar z3583 = z3561 + k43 * z3374 + k72 * z3372;
    const Scalar z3644 = z3012 * z3169 - z3013 * z3170 + z3017 * z3239 + z3016 * z3240 - z3018 * z3379 - z2889 * z3513
        + z2888 * z3514;
    const Scalar z3646 = z3020 * z3378 - z3522;
    const Scalar z3616 = z3561 + z3048 * z3372 + z3053 * z3373;
    const Scalar z3607 = z3583 + z3048 * z3372 + z3068 * z3373;
    const Scalar z3608 = s_q2 * z3606 - c_q2 * z3607;
    const Scalar z3643 = z3507 - z3511;
    const Scalar z3642 = z3507 + z3515;
    const Scalar z3641 = z3511 - z3515;
    const Scalar z3598 = z3578 - z3586;
    const Scalar z3604 = z3049 * z3080 + z3603 - z3068 * z3257 + z3070 * z3371 + z3365 + z2884 * z3581 + z2883 * z3598;
    const Scalar z3588 = z3579 - z3581;
    const Scalar z3597 = z3582 + z3586;
    const Scalar z3602 = z3366 + z3049 * z3079 - z3068 * z3256 + z3069 * z3371 + z3067 * z3257 + z2883 * z3579 + z2884
        * z3597;
    const Scalar z3605 = c_q2 * z3604 + s_q2 * z3602;
    const Scalar z3595 = z3586 + z3593;
    const Scalar z3609 = z3547 - z3551;
    const Scalar z3620 = z3361 + z3044 * z3249 - z3019 * z3157 - z3045 * z3248 + z3046 * z3375 + z2885 * z3544 - z2886
        * z3609;
    const Scalar z3611 = z3543 - z3547;
    const Scalar z3610 = z3543 + z3551;
    const Scalar z3622 = z3621 + z3045 * z3249 - z3047 * z3375 - z3040 * z3248 - z3360 - z2886 * z3546 + z2885 * z3610;
    const Scalar z3613 = z3046 * z3377 - z3611 - z3047 * z3376;
    const Scalar z3614 = z3611 + z3049 * z3553 - z3050 * z3552;
    const Scalar z3615 = z3053 * z3257 - z3603 - z3049 * z3080 - z3054 * z3371 + z2884 * z3560 + z2883 * z3614;
    const Scalar z3617 = s_q2 * z3560 - c_q2 * z3614;
    const Scalar z3645 = z3016 * z3381 - z3643 - z3017 * z3380;
    const Scalar z3587 = z3578 + z3582;
    const Scalar z3647 = z3019 * z3377 + z3643;
    const Scalar z3590 = s_q2 * z3587 - c_q2 * z3588;
    const Scalar z3648 = z3621 + z3021 * z3249 - z3022 * z3375 - z3023 * z3248 + z2885 * z3647 - z2886 * z3646;
    const Scalar z3649 = z3021 * z3377 - z3533 + z3023 * z3376;
    const Scalar z3599 = z3578 - z3582;
    const Scalar z3601 = z3599 + z3069 * z3373 - z3070 * z3372;
    const Scalar z3591 = s_q2 * z3590;
    const Scalar z3592 = z3578 - z3591;
    const Scalar z3653 = z3533 + z3024 * z3553 - z3025 * z3552;
    const Scalar z3651 = c_q3 * z3647 + s_q3 * z3646;
    const Scalar z3650 = s_q3 * z3647 - c_q3 * z3646;
    const Scalar z3594 = z3592 + z3593;
    const Scalar z3596 = z3594 - z3595;
    const Scalar z3661 = z3015 * z3239 - z3356 - z2980 * z3169 + z3016 * z3379 - z3014 * z3240 + z2888 * z3508 - z2889
        * z3641;
    const Scalar z3680 = z3509 + z3015 * z3380 + z3014 * z3381;
    const Scalar z3654 = z3020 * z3552 - z3651;
    const Scalar z3652 = z3020 * z3553 - z3650;
    const Scalar z3655 = z3020 * z3079 - z3024 * z3080 + z3022 * z3256 + z3028 * z3257 - z3029 * z3371 + z2883 * z3653
        + z2884 * z3652;
    const Scalar z3656 = z3022 * z3372 - z3654 - z3028 * z3373;
    const Scalar z3657 = s_q2 * z3652 - c_q2 * z3653;
    const Scalar z3658 = z2888 * z3506 + z2980 * z3239 - z3013 * z3379 - z3242;
    const Scalar z3659 = z2889 * z3506 - z2980 * z3240 + z3012 * z3379 + z3241;
    const Scalar z3681 = z3512 + z3010 * z3380 + z3015 * z3381;
    const Scalar z3662 = z2980 * z3170;
    const Scalar z3663 = z3010 * z3239 - z3662 - z3015 * z3240 - z3017 * z3379 + z3355 - z2889 * z3510 + z2888 * z3642;
    const Scalar z3677 = z2980 * z3380 - z3505;
    const Scalar z3660 = z3012 * z3239 - z3013 * z3240 - z2889 * z3505 + z2888 * z3504;
    const Scalar z3679 = z3013 * z3381 + z3012 * z3380;
    const Scalar z3678 = z2980 * z3381 - z3504;
    const Scalar z3665 = s_q4 * z3658 - c_q4 * z3659;
    const Scalar z3664 = c_q4 * z3658 + s_q4 * z3659;
    const Scalar z3668 = z3644 - z3665;
    const Scalar z3682 = c_q4 * z3677 + s_q4 * z3678;
    const Scalar z3623 = s_q3 * z3619 - c_q3 * z3618;
    const Scalar z3683 = s_q4 * z3677 - c_q4 * z3678;
    const Scalar z3624 = s_q3 * z3618 + c_q3 * z3619;
    const Scalar z3626 = s_q3 * z3620 - c_q3 * z3622;
    const Scalar z3625 = s_q3 * z3622 + c_q3 * z3620;
    const Scalar z3628 = n632_over_165 * z3623 + z3626;
    const Scalar z3627 = n632_over_165 * z3624 + z3625;
    const Scalar z3686 = z3645 + z3683;
    const Scalar z3666 = s_q4 * z3663 - c_q4 * z3661;
    const Scalar z3667 = c_q4 * z3663 + s_q4 * z3661;
    const Scalar z3669 = z3660 - z3667;
    const Scalar z3629 = s_q2 * z3627 - c_q2 * z3612;
    const Scalar z3685 = c_q4 * z3681 + s_q4 * z3680;
    const Scalar z3684 = s_q4 * z3681 - c_q4 * z3680;
    const Scalar z3687 = z3679 - z3685;
    const Scalar z3634 = s_q3 * z3631 - c_q3 * z3630;
    const Scalar z3635 = s_q3 * z3630 + c_q3 * z3631;
    const Scalar z3695 = z3471 - z3475;
    const Scalar z3636 = s_q3 * z3633 + c_q3 * z3632;
    const Scalar z3637 = s_q3 * z3632 - c_q3 * z3633;
    const Scalar z3638 = n632_over_165 * z3635 - z3636;
    const Scalar z3698 = z2977 * z3233 - z2978 * z3232 - z2979 * z3383 + z2973 * z3183 + z2974 * z3184 + z2891 * z3474
        - z2892 * z3473;
    const Scalar z3639 = n632_over_165 * z3634 - z3637;
    const Scalar z3697 = z3467 + z3471;
    const Scalar z3696 = z3467 - z3475;
    const Scalar z3640 = s_q2 * z3638 - c_q2 * z3613;
    const Scalar z3722 = z2975 * z3233 - z2977 * z3383 - z2976 * z3232 - z2942 * z3183 + z2891 * z3468 + z3351 - z2892
        * z3695;
    const Scalar z3701 = z2981 * z3476 - z3697 + z2980 * z3477;
    const Scalar z3699 = z2978 * z3384 - z3697 + z2977 * z3385;
    const Scalar z3700 = z2981 * z3382 + z3484;
    const Scalar z3702 = z2985 * z3239 - z3662 - z2984 * z3240 - z2986 * z3379 + z2888 * z3701 - z2889 * z3700;
    const Scalar z3703 = z2985 * z3380 - z3497 + z2984 * z3381;
    const Scalar z3720 = z2892 * z3466 - z2942 * z3233 - z2973 * z3383 - z3234;
    const Scalar z3719 = z2891 * z3466 + z2942 * z3232 - z2974 * z3383 - z3235;
    const Scalar z3707 = z2987 * z3377 + z3497;
    const Scalar z3723 = z2941 * z3232;
    const Scalar z3724 = z3723 + z2978 * z3383 - z2976 * z3233 + z2942 * z3184 + z3350 - z2892 * z3470 + z2891 * z3696;
    const Scalar z3704 = s_q4 * z3701 + c_q4 * z3700;
    const Scalar z3705 = s_q4 * z3700 - c_q4 * z3701;
    const Scalar z3708 = z2987 * z3378 + z3705;
    const Scalar z3706 = z3704 + z2981 * z3377 - z2988 * z3378;
    const Scalar z3721 = z2892 * z3465 - z2973 * z3232 - z2974 * z3233 + z2891 * z3464;
    const Scalar z3709 = z2981 * z3157 + z2987 * z3158 - z2989 * z3249 + z2991 * z3248 + z2992 * z3375 + z2885 * z3707
        - z2886 * z3706;
    const Scalar z3710 = z3708 + z2989 * z3377 + z2991 * z3376;
    const Scalar z3714 = z3708 + z2993 * z3553 - z2994 * z3552;
    const Scalar z3725 = s_q5 * z3720 - c_q5 * z3719;
    const Scalar z3726 = s_q5 * z3719 + c_q5 * z3720;
    const Scalar z3712 = c_q3 * z3707 + s_q3 * z3706;
    const Scalar z3711 = s_q3 * z3707 - c_q3 * z3706;
    const Scalar z3715 = z2988 * z3552 + z3712;
    const Scalar z3713 = z2988 * z3553 + z3711;
    const Scalar z3728 = s_q5 * z3722 + c_q5 * z3724;
    const Scalar z3727 = s_q5 * z3724 - c_q5 * z3722;
    const Scalar z3716 = z2997 * z3257 - z2988 * z3079 - z2993 * z3080 - z2992 * z3256 - z2998 * z3371 + z2883 * z3714
        - z2884 * z3713;
    const Scalar z3717 = z2992 * z3372 - z3715 + z2997 * z3373;
    const Scalar z3718 = c_q2 * z3714 + s_q2 * z3713;
    const Scalar z3729 = n256_over_55 * z3726 + z3727;
    const Scalar z3670 = s_q3 * z3660 + c_q3 * z3664;
    const Scalar z3671 = s_q3 * z3664 - c_q3 * z3660;
    const Scalar z3731 = z3721 + n256_over_55 * z3725 - z3728;
    const Scalar z3730 = z3698 + z3726;
    const Scalar z3672 = s_q3 * z3668 + c_q3 * z3666;
    const Scalar z3673 = s_q3 * z3666 - c_q3 * z3668;
    const Scalar z3674 = n632_over_165 * z3671 + z3672;
    const Scalar z3675 = n632_over_165 * z3670 - z3673;
    const Scalar z3733 = c_q4 * z3721 + s_q4 * z3725;
    const Scalar z3732 = s_q4 * z3721 - c_q4 * z3725;
    const Scalar z3676 = s_q2 * z3674 - c_q2 * z3669;
    const Scalar z3747 = z2973 * z3384 - z2974 * z3385;
    const Scalar z3746 = z2942 * z3385 - z3464;
    const Scalar z3736 = z3731 - z3733;
    const Scalar z3745 = z2942 * z3384 + z3465;
    const Scalar z3734 = s_q4 * z3730 - c_q4 * z3729;
    const Scalar z3735 = c_q4 * z3730 + s_q4 * z3729;
    const Scalar z3737 = z3726 - z3735;
    const Scalar z3739 = c_q3 * z3726 + s_q3 * z3732;
    const Scalar z3738 = s_q3 * z3726 - c_q3 * z3732;
    const Scalar z3740 = s_q3 * z3736 + c_q3 * z3734;
    const Scalar z3742 = n632_over_165 * z3739 - z3740;
    const Scalar z3741 = s_q3 * z3734 - c_q3 * z3736;
    const Scalar z3743 = n632_over_165 * z3738 - z3741;
    const Scalar z3688 = s_q3 * z3679 + c_q3 * z3682;
    const Scalar z3748 = z3469 + z2976 * z3384 + z2975 * z3385;
    const Scalar z3689 = s_q3 * z3682 - c_q3 * z3679;
    const Scalar z3749 = z3472 + z2941 * z3384 + z2976 * z3385;
    const Scalar z3744 = c_q2 * z3737 + s_q2 * z3742;
    const Scalar z3690 = s_q3 * z3686 - c_q3 * z3684;
    const Scalar z3691 = c_q3 * z3686 + s_q3 * z3684;
    const Scalar z3692 = n632_over_165 * z3689 - z3690;
    const Scalar z3693 = n632_over_165 * z3688 - z3691;
    const Scalar z3750 = s_q5 * z3746 - c_q5 * z3745;
    const Scalar z3751 = s_q5 * z3745 + c_q5 * z3746;
    const Scalar z3694 = s_q2 * z3692 - c_q2 * z3687;
    const Scalar z3773 = z2936 * z3190 - z2941 * z3387 - k13 * z3191 - z2939 * z3222 + z2940 * z3221 + z2894 * z3445
        + z2895 * z3444;
    const Scalar z3803 = z2900 * z3191;
    const Scalar z3800 = z2895 * z3437 - z2900 * z3222 - z2936 * z3387 - z3223;
    const Scalar z3799 = z2900 * z3221 - k13 * z3387 + z2894 * z3437 - z3224;
    const Scalar z3776 = z2941 * z3384 - z3454 - z2944 * z3385;
    const Scalar z3780 = z2946 * z3477 - z3454 - z2947 * z3476;
    const Scalar z3772 = z3438 - z3442;
    const Scalar z3775 = z3723 + z2945 * z3383 + z2944 * z3233 + z2942 * z3184 + z2891 * z3772 - z2892 * z3453;
    const Scalar z3770 = z3442 - z3446;
    const Scalar z3802 = z2900 * z3190 - z2939 * z3387 + z2937 * z3222 - z2938 * z3221 + z2894 * z3439 - z2895 * z3770
        - z3346;
    const Scalar z3771 = z3438 + z3446;
    const Scalar z3804 = z2934 * z3221 - z3803 - z2940 * z3387 + z2938 * z3222 + z2895 * z3441 + z2894 * z3771 + z3345;
    const Scalar z3774 = z3772 + z2939 * z3389 + z2940 * z3388;
    const Scalar z3777 = s_q5 * z3772 - c_q5 * z3453;
    const Scalar z3778 = c_q5 * z3772 + s_q5 * z3453;
    const Scalar z3779 = z3777 + z2947 * z3382 + z2943 * z3477;
    const Scalar z3781 = z3778 + z2943 * z3476 + z2946 * z3382;
    const Scalar z3801 = z2895 * z3436 - z2936 * z3221 - k13 * z3222 + z2894 * z3435;
    const Scalar z3782 = z2951 * z3239 - z2943 * z3169 - z2946 * z3170 + z2952 * z3379 + z2950 * z3240 + z2888 * z3780
        + z2889 * z3779;
    const Scalar z3783 = z3781 + z2950 * z3381 - z2951 * z3380;
    const Scalar z3787 = z2953 * z3377 + z3781;
    const Scalar z3784 = s_q4 * z3780 - c_q4 * z3779;
    const Scalar z3785 = c_q4 * z3780 + s_q4 * z3779;
    const Scalar z3786 = z2947 * z3377 - z3784 + z2954 * z3378;
    const Scalar z3788 = z2953 * z3378 - z3785;
    const Scalar z3805 = s_q6 * z3800 - c_q6 * z3799;
    const Scalar z3806 = c_q6 * z3800 + s_q6 * z3799;
    const Scalar z3794 = z2959 * z3553 - z3788 + z2960 * z3552;
    const Scalar z3789 = z2953 * z3158 - z2947 * z3157 - z2957 * z3248 - z2955 * z3249 - z2958 * z3375 + z2885 * z3787
        + z2886 * z3786;
    const Scalar z3790 = z3788 + z2955 * z3377 - z2957 * z3376;
    const Scalar z3807 = c_q6 * z3802 + s_q6 * z3804;
    const Scalar z3808 = s_q6 * z3802 - c_q6 * z3804;
    const Scalar z3809 = s_q5 * z3801 - c_q5 * z3805;
    const Scalar z3810 = c_q5 * z3801 + s_q5 * z3805;
    const Scalar z3791 = s_q3 * z3787 + c_q3 * z3786;
    const Scalar z3792 = s_q3 * z3786 - c_q3 * z3787;
    const Scalar z3793 = z2954 * z3553 + z3791;
    const Scalar z3795 = z2954 * z3552 - z3792;
    const Scalar z3811 = s_q5 * z3773 - c_q5 * z3807;
    const Scalar z3796 = z2954 * z3079 - z2959 * z3080 - z2958 * z3256 - z2963 * z3257 - z2964 * z3371 + z2883 * z3794
        + z2884 * z3793;
    const Scalar z3797 = z3795 + z2958 * z3372 - z2963 * z3373;
    const Scalar z3798 = s_q2 * z3793 - c_q2 * z3794;
    const Scalar z3752 = s_q5 * z3749 + c_q5 * z3748;
    const Scalar z3753 = s_q5 * z3748 - c_q5 * z3749;
    const Scalar z3812 = c_q5 * z3773 + s_q5 * z3807;
    const Scalar z3813 = n256_over_55 * z3810 + z3811;
    const Scalar z3754 = n256_over_55 * z3751 + z3752;
    const Scalar z3756 = z3747 - n256_over_55 * z3750 - z3753;
    const Scalar z3814 = z3808 - z3810;
    const Scalar z3755 = z3699 - z3751;
    const Scalar z3815 = z3806 + n256_over_55 * z3809 - z3812;
    const Scalar z3816 = s_q4 * z3806 - c_q4 * z3809;
    const Scalar z3758 = s_q4 * z3750 - c_q4 * z3747;
    const Scalar z3757 = s_q4 * z3747 + c_q4 * z3750;
    const Scalar z3817 = c_q4 * z3806 + s_q4 * z3809;
    const Scalar z3761 = z3756 + z3758;
    const Scalar z3818 = s_q4 * z3814 + c_q4 * z3813;
    const Scalar z3759 = s_q4 * z3755 + c_q4 * z3754;
    const Scalar z3819 = s_q4 * z3813 - c_q4 * z3814;
    const Scalar z3760 = s_q4 * z3754 - c_q4 * z3755;
    const Scalar z3820 = z3815 - z3817;
    const Scalar z3821 = z3810 - z3819;
    const Scalar z3762 = z3751 - z3760;
    const Scalar z3822 = s_q3 * z3810 - c_q3 * z3816;
    const Scalar z3764 = s_q3 * z3757 - c_q3 * z3751;
    const Scalar z3763 = s_q3 * z3751 + c_q3 * z3757;
    const Scalar z3823 = c_q3 * z3810 + s_q3 * z3816;
    const Scalar z3824 = s_q3 * z3820 - c_q3 * z3818;
    const Scalar z3765 = s_q3 * z3761 + c_q3 * z3759;
    const Scalar z3825 = c_q3 * z3820 + s_q3 * z3818;
    const Scalar z3766 = s_q3 * z3759 - c_q3 * z3761;
    const Scalar z3826 = n632_over_165 * z3823 - z3824;
    const Scalar z3767 = n632_over_165 * z3764 - z3765;
    const Scalar z3827 = n632_over_165 * z3822 + z3825;
    const Scalar z3768 = n632_over_165 * z3763 + z3766;
    const Scalar z3828 = c_q2 * z3821 + s_q2 * z3826;
    const Scalar z3769 = s_q2 * z3767 - c_q2 * z3762;
    const Scalar z3861 = z2897 * z3409 - k6 * z3391 + z2898 * z3408 + k4 * z3211 + k2 * z3203 - k3 * z3202 - k5 * z3212;
    const Scalar z3863 = z2901 * z3411 + z3419;
    const Scalar z3833 = z3443 + z2934 * z3388 - z2938 * z3389;
    const Scalar z3832 = z2937 * z3389 - z3440 + z2938 * z3388;
    const Scalar z3830 = z2900 * z3389 - z3435;
    const Scalar z3829 = z2900 * z3388 + z3436;
    const Scalar z3831 = z2936 * z3388 - k13 * z3389;
    const Scalar z3866 = z3429 + z2902 * z3389 + z2904 * z3388;
    const Scalar z3893 = z2897 * z3400 - z3214 - k2 * z3391;
    const Scalar z3860 = z3401 + z3405;
    const Scalar z3864 = z2900 * z3412 + z3860;
    const Scalar z3862 = z3395 + z3396 - z3860;
    const Scalar z3858 = z3405 - z3410;
    const Scalar z3859 = z3401 - z3410;
    const Scalar z3834 = s_q6 * z3830 - c_q6 * z3829;
    const Scalar z3865 = z2904 * z3221 - z3803 - z2903 * z3387 - z2902 * z3222 + z2894 * z3864 - z2895 * z3863;
    const Scalar z3894 = z2898 * z3400 + z3213 + k3 * z3391;
    const Scalar z3835 = s_q6 * z3829 + c_q6 * z3830;
    const Scalar z3895 = z2897 * z3398 - z2898 * z3399 + k3 * z3211 - k2 * z3212;
    const Scalar z3867 = s_q6 * z3864 - c_q6 * z3863;
    const Scalar z3869 = z2908 * z3383 + z2903 * z3232 + z2907 * z3233 - z2901 * z3183 - z2905 * z3184 + z2891 * z3429
        - z2892 * z3867;
    const Scalar z3868 = c_q6 * z3864 + s_q6 * z3863;
    const Scalar z3870 = z3868 + z2903 * z3384 - z2907 * z3385;
    const Scalar z3874 = z3868 + z2910 * z3476 + z2909 * z3477;
    const Scalar z3871 = s_q5 * z3429 - c_q5 * z3867;
    const Scalar z3872 = c_q5 * z3429 + s_q5 * z3867;
    const Scalar z3873 = z3871 + z2906 * z3477 - z2910 * z3382;
    const Scalar z3875 = z3872 + z2909 * z3382 + z2906 * z3476;
    const Scalar z3836 = s_q6 * z3833 - c_q6 * z3832;
    const Scalar z3896 = z2897 * z3402 - k5 * z3391 - z2898 * z3858 - k8 * z3211 - k0 * z3212 - z3342;
    const Scalar z3876 = z2915 * z3379 + z2914 * z3239 - z2906 * z3169 - z2909 * z3170 - z2913 * z3240 + z2888 * z3874
        + z2889 * z3873;
    const Scalar z3877 = z2914 * z3380 - z3875 + z2913 * z3381;
    const Scalar z3837 = c_q6 * z3833 + s_q6 * z3832;
    const Scalar z3897 = k4 * z3391 - z2898 * z3404 + z2897 * z3859 - k8 * z3212 - z3341;
    const Scalar z3881 = z2916 * z3377 + z3875;
    const Scalar z3878 = s_q4 * z3874 - c_q4 * z3873;
    const Scalar z3879 = c_q4 * z3874 + s_q4 * z3873;
    const Scalar z3882 = z2916 * z3378 - z3879;
    const Scalar z3880 = z3878 + z2910 * z3377 - z2917 * z3378;
    const Scalar z3838 = s_q5 * z3831 + c_q5 * z3834;
    const Scalar z3839 = s_q5 * z3834 - c_q5 * z3831;
    const Scalar z3884 = z3882 + z2918 * z3377 - z2920 * z3376;
    const Scalar z3883 = z2910 * z3157 + z2916 * z3158 - z2920 * z3248 - z2918 * z3249 + z2921 * z3375 + z2885 * z3881
        - z2886 * z3880;
    const Scalar z3888 = z3882 + z2922 * z3553 - z2923 * z3552;
    const Scalar z3899 = s_q7 * z3893 - c_q7 * z3894;
    const Scalar z3898 = s_q7 * z3894 + c_q7 * z3893;
    const Scalar z3841 = s_q5 * z3836 + c_q5 * z3774;
    const Scalar z3840 = s_q5 * z3774 - c_q5 * z3836;
    const Scalar z3844 = z3835 - n256_over_55 * z3838 - z3841;
    const Scalar z3842 = n256_over_55 * z3839 + z3840;
    const Scalar z3901 = s_q7 * z3896 - c_q7 * z3897;
    const Scalar z3900 = c_q7 * z3896 + s_q7 * z3897;
    const Scalar z3902 = z3861 + n16_over_15 * z3899;
    const Scalar z3886 = c_q3 * z3881 + s_q3 * z3880;
    const Scalar z3885 = s_q3 * z3881 - c_q3 * z3880;
    const Scalar z3889 = z2917 * z3552 + z3886;
    const Scalar z3887 = z2917 * z3553 + z3885;
    const Scalar z3843 = z3837 + z3839;
    const Scalar z3891 = z2921 * z3372 - z3889 + z2926 * z3373;
    const Scalar z3890 = z2926 * z3257 - z2917 * z3079 - z2922 * z3080 - z2921 * z3256 - z2927 * z3371 + z2883 * z3888
        - z2884 * z3887;
    const Scalar z3892 = c_q2 * z3888 + s_q2 * z3887;
    const Scalar z3903 = n16_over_15 * z3895 + z3901;
    const Scalar z3904 = s_q6 * z3895 + c_q6 * z3898;
    const Scalar z3846 = s_q4 * z3838 - c_q4 * z3835;
    const Scalar z3845 = s_q4 * z3835 + c_q4 * z3838;
    const Scalar z3905 = s_q6 * z3898 - c_q6 * z3895;
    const Scalar z3849 = z3844 + z3846;
    const Scalar z3906 = s_q6 * z3902 - c_q6 * z3900;
    const Scalar z3847 = s_q4 * z3843 - c_q4 * z3842;
    const Scalar z3907 = s_q6 * z3900 + c_q6 * z3902;
    const Scalar z3848 = c_q4 * z3843 + s_q4 * z3842;
    const Scalar z3850 = z3839 - z3848;
    const Scalar z3908 = s_q5 * z3899 + c_q5 * z3904;
    const Scalar z3909 = s_q5 * z3904 - c_q5 * z3899;
    const Scalar z3910 = s_q5 * z3903 - c_q5 * z3906;
    const Scalar z3852 = c_q3 * z3839 + s_q3 * z3845;
    const Scalar z3851 = s_q3 * z3839 - c_q3 * z3845;
    const Scalar z3911 = c_q5 * z3903 + s_q5 * z3906;
    const Scalar z3912 = n256_over_55 * z3909 + z3910;
    const Scalar z3853 = s_q3 * z3849 + c_q3 * z3847;
    const Scalar z3854 = s_q3 * z3847 - c_q3 * z3849;
    const Scalar z3855 = n632_over_165 * z3852 - z3853;
    const Scalar z3856 = n632_over_165 * z3851 - z3854;
    const Scalar z3914 = z3905 + n256_over_55 * z3908 + z3911;
    const Scalar z3857 = c_q2 * z3850 + s_q2 * z3855;
    const Scalar z3929 = k0 * z3393 - z3407 + z3403;
    const Scalar z3959 = u_tau1 - z3369;
    const Scalar z3960 = u_tau2 - z3367;
    const Scalar z3961 = u_tau3 + z3362;
    const Scalar z3962 = u_tau4 - z3357;
    const Scalar z3963 = u_tau5 + z3352;
    const Scalar z3964 = u_tau6 - z3347;
    const Scalar z3965 = u_tau7 - z3216;
    const Scalar z3930 = k8 * z3393 - z3406;
    const Scalar z3928 = k3 * z3392 + k2 * z3393;
    const Scalar z3966 = z3263 * z3892 - z3798;
    const Scalar z3967 = z3262 * z3892 - z3718 - z3290 * z3966;
    const Scalar z3931 = s_q7 * z3930 + c_q7 * z3929;
    const Scalar z3932 = s_q7 * z3929 - c_q7 * z3930;
    const Scalar z3934 = n16_over_15 * z3928 + z3932;
    const Scalar z3968 = z3261 * z3892 - z3289 * z3966 - z3310 * z3967 + z3657;
    const Scalar z3933 = n16_over_15 * z3413 - z3862;
    const Scalar z3935 = s_q6 * z3928 - c_q6 * z3414;
    const Scalar z3936 = c_q6 * z3928 + s_q6 * z3414;
    const Scalar z3969 = z3260 * z3892 - z3288 * z3966 - z3309 * z3967 - z3324 * z3968 + z3617;
    const Scalar z3937 = c_q6 * z3931 + s_q6 * z3933;
    const Scalar z3938 = s_q6 * z3931 - c_q6 * z3933;
    const Scalar z3970 = z3259 * z3892 - z3287 * z3966 - z3308 * z3967 - z3323 * z3968 - z3333 * z3969 - z3589;
    const Scalar z3971 = z3258 * z3892 - z3286 * z3966 - z3307 * z3967 - z3322 * z3968 - z3332 * z3969 - z3338 * z3970
        - z3596;
    const Scalar z3939 = s_q5 * z3413 - c_q5 * z3935;
    const Scalar z3940 = c_q5 * z3413 + s_q5 * z3935;
    const Scalar z3972 = z3340 * z3971;
    const Scalar z3913 = z3907 + z3909;
    const Scalar z3973 = z3337 * z3970 - z3338 * z3972;
    const Scalar z3916 = c_q4 * z3905 + s_q4 * z3908;
    const Scalar z3915 = s_q4 * z3905 - c_q4 * z3908;
    const Scalar z3919 = z3914 - z3916;
    const Scalar z3974 = z3331 * z3969 - z3332 * z3972 - z3333 * z3973;
    const Scalar z3942 = s_q5 * z3937 - c_q5 * z3934;
    const Scalar z3941 = s_q5 * z3934 + c_q5 * z3937;
    const Scalar z3945 = z3936 + n256_over_55 * z3939 + z3942;
    const Scalar z3943 = n256_over_55 * z3940 + z3941;
    const Scalar z3975 = z3321 * z3968 - z3322 * z3972 - z3323 * z3973 - z3324 * z3974;
    const Scalar z3976 = z3306 * z3967 - z3307 * z3972 - z3308 * z3973 - z3309 * z3974 - z3310 * z3975;
    const Scalar z3944 = z3938 + z3940;
    const Scalar z3947 = c_q4 * z3936 + s_q4 * z3939;
    const Scalar z3946 = s_q4 * z3936 - c_q4 * z3939;
    const Scalar z3950 = z3945 - z3947;
    const Scalar z3917 = s_q4 * z3913 - c_q4 * z3912;
    const Scalar z3918 = c_q4 * z3913 + s_q4 * z3912;
    const Scalar z3979 = z3263 * z3890 + z3796;
    const Scalar z3920 = z3909 - z3918;
    const Scalar z3980 = z3262 * z3890 - z3716 - z3290 * z3979;
    const Scalar z3977 = z3285 * z3966 - z3286 * z3972 - z3287 * z3973 - z3288 * z3974 - z3289 * z3975 - z3290 * z3976;
    const Scalar z3978 = z3258 * z3972 - k52 * z3892 + z3259 * z3973 + z3260 * z3974 + z3261 * z3975 + z3262 * z3976
        + z3263 * z3977;
    const Scalar z3948 = s_q4 * z3944 - c_q4 * z3943;
    const Scalar z3949 = c_q4 * z3944 + s_q4 * z3943;
    const Scalar z3951 = z3940 - z3949;
    const Scalar z3922 = s_q3 * z3915 - c_q3 * z3909;
    const Scalar z3921 = s_q3 * z3909 + c_q3 * z3915;
    const Scalar z3981 = z3261 * z3890 - z3289 * z3979 - z3310 * z3980 - z3655;
    const Scalar z3982 = z3260 * z3890 - z3288 * z3979 - z3309 * z3980 - z3324 * z3981 - z3615;
    const Scalar z3923 = s_q3 * z3919 - c_q3 * z3917;
    const Scalar z3925 = n632_over_165 * z3922 - z3923;
    const Scalar z3924 = c_q3 * z3919 + s_q3 * z3917;
    const Scalar z3926 = n632_over_165 * z3921 - z3924;
    const Scalar z3983 = z3259 * z3890 - z3287 * z3979 - z3308 * z3980 - z3323 * z3981 - z3333 * z3982 - z3600;
    const Scalar z3927 = s_q2 * z3925 - c_q2 * z3920;
    const Scalar z3992 = z3263 * z3891 + z3797;
    const Scalar z4005 = z3263 * z3883 - z3789;
    const Scalar z3993 = z3262 * z3891 - z3717 - z3290 * z3992;
    const Scalar z4006 = z3262 * z3883 - z3709 - z3290 * z4005;
    const Scalar z3994 = z3656 + z3261 * z3891 - z3289 * z3992 - z3310 * z3993;
    const Scalar z4007 = z3261 * z3883 - z3648 - z3289 * z4005 - z3310 * z4006;
    const Scalar z3995 = z3260 * z3891 - z3288 * z3992 - z3309 * z3993 - z3616 - z3324 * z3994;
    const Scalar z4008 = z3260 * z3883 - z3288 * z4005 - z3309 * z4006 - z3324 * z4007 + z3612;
    const Scalar z3996 = z3259 * z3891 - z3287 * z3992 - z3308 * z3993 - z3323 * z3994 - z3333 * z3995 + z3601;
    const Scalar z4009 = z3259 * z3883 - z3287 * z4005 - z3308 * z4006 - z3323 * z4007 - z3628 - z3333 * z4008;
    const Scalar z3984 = z3258 * z3890 - z3605 - z3286 * z3979 - z3307 * z3980 - z3322 * z3981 - z3332 * z3982 - z3338
        * z3983;
    const Scalar z3997 = z3258 * z3891 - z3286 * z3992 - z3307 * z3993 - z3322 * z3994 - z3332 * z3995 - z3338 * z3996
        - z3608;
    const Scalar z4010 = z3258 * z3883 - z3286 * z4005 - z3307 * z4006 - z3322 * z4007 - z3332 * z4008 - z3338 * z4009
        + z3629;
    const Scalar z3985 = z3340 * z3984;
    const Scalar z3998 = z3340 * z3997;
    const Scalar z4011 = z3340 * z4010;
    const Scalar z3986 = z3337 * z3983 - z3338 * z3985;
    const Scalar z3999 = z3337 * z3996 - z3338 * z3998;
    const Scalar z3987 = z3331 * z3982 - z3332 * z3985 - z3333 * z3986;
    const Scalar z4000 = z3331 * z3995 - z3332 * z3998 - z3333 * z3999;
    const Scalar z3988 = z3321 * z3981 - z3322 * z3985 - z3323 * z3986 - z3324 * z3987;
    const Scalar z4001 = z3321 * z3994 - z3322 * z3998 - z3323 * z3999 - z3324 * z4000;
    const Scalar z3989 = z3306 * z3980 - z3307 * z3985 - z3308 * z3986 - z3309 * z3987 - z3310 * z3988;
    const Scalar z4002 = z3306 * z3993 - z3307 * z3998 - z3308 * z3999 - z3309 * z4000 - z3310 * z4001;
    const Scalar z3990 = z3285 * z3979 - z3286 * z3985 - z3287 * z3986 - z3288 * z3987 - z3289 * z3988 - z3290 * z3989;
    const Scalar z3991 = z3258 * z3985 - k52 * z3890 + z3259 * z3986 + z3260 * z3987 + z3261 * z3988 + z3262 * z3989
        + z3263 * z3990;
    const Scalar z4003 = z3285 * z3992 - z3286 * z3998 - z3287 * z3999 - z3288 * z4000 - z3289 * z4001 - z3290 * z4002;
    const Scalar z4004 = z3258 * z3998 - k52 * z3891 + z3259 * z3999 + z3260 * z4000 + z3261 * z4001 + z3262 * z4002
        + z3263 * z4003;
    const Scalar z3953 = c_q3 * z3940 + s_q3 * z3946;
    const Scalar z3952 = s_q3 * z3940 - c_q3 * z3946;
    const Scalar z4012 = z3337 * z4009 - z3338 * z4011;
    const Scalar z4013 = z3331 * z4008 - z3332 * z4011 - z3333 * z4012;
    const Scalar z3954 = s_q3 * z3950 + c_q3 * z3948;
    const Scalar z3955 = s_q3 * z3948 - c_q3 * z3950;
    const Scalar z3956 = n632_over_165 * z3953 - z3954;
    const Scalar z3957 = n632_over_165 * z3952 - z3955;
    const Scalar z4014 = z3321 * z4007 - z3322 * z4011 - z3323 * z4012 - z3324 * z4013;
    const Scalar z3958 = c_q2 * z3951 + s_q2 * z3956;
    const Scalar z4018 = z3263 * z3884 - z3790;
    const Scalar z4031 = z3263 * z3876 - z3782;
    const Scalar z4044 = z3263 * z3877 + z3783;
    const Scalar z4019 = z3262 * z3884 - z3710 - z3290 * z4018;
    const Scalar z4032 = z3262 * z3876 - z3702 - z3290 * z4031;
    const Scalar z4045 = z3262 * z3877 - z3703 - z3290 * z4044;
    const Scalar z4057 = z3263 * z3869 - z3775;
    const Scalar z4070 = z3263 * z3870 - z3776;
    const Scalar z4058 = z3698 + z3262 * z3869 - z3290 * z4057;
    const Scalar z4071 = z3262 * z3870 - z3699 - z3290 * z4070;
    const Scalar z4020 = z3261 * z3884 - z3289 * z4018 - z3310 * z4019 + z3649;
    const Scalar z4033 = z3261 * z3876 - z3289 * z4031 - z3310 * z4032 + z3644;
    const Scalar z4046 = z3261 * z3877 - z3289 * z4044 - z3310 * z4045 - z3645;
    const Scalar z4059 = z3261 * z3869 - z3731 - z3289 * z4057 - z3310 * z4058;
    const Scalar z4072 = z3756 + z3261 * z3870 - z3289 * z4070 - z3310 * z4071;
    const Scalar z4021 = z3260 * z3884 - z3288 * z4018 - z3309 * z4019 - z3324 * z4020 + z3613;
    const Scalar z4034 = z3260 * z3876 - z3288 * z4031 - z3309 * z4032 - z3324 * z4033 - z3669;
    const Scalar z4047 = z3260 * z3877 - z3288 * z4044 - z3309 * z4045 - z3324 * z4046 - z3687;
    const Scalar z4060 = z3260 * z3869 - z3288 * z4057 - z3309 * z4058 + z3737 - z3324 * z4059;
    const Scalar z4073 = z3260 * z3870 - z3288 * z4070 - z3309 * z4071 + z3762 - z3324 * z4072;
    const Scalar z4022 = z3259 * z3884 - z3287 * z4018 - z3308 * z4019 - z3323 * z4020 - z3333 * z4021 - z3639;
    const Scalar z4035 = z3259 * z3876 - z3287 * z4031 - z3308 * z4032 - z3323 * z4033 - z3333 * z4034 - z3675;
    const Scalar z4048 = z3259 * z3877 - z3287 * z4044 - z3308 * z4045 - z3323 * z4046 - z3333 * z4047 - z3693;
    const Scalar z4061 = z3259 * z3869 - z3287 * z4057 - z3308 * z4058 - z3323 * z4059 - z3333 * z4060 + z3743;
    const Scalar z4074 = z3259 * z3870 - z3287 * z4070 - z3308 * z4071 - z3323 * z4072 + z3768 - z3333 * z4073;
    const Scalar z4023 = z3258 * z3884 - z3286 * z4018 - z3307 * z4019 - z3322 * z4020 - z3332 * z4021 - z3338 * z4022
        + z3640;
    const Scalar z4036 = z3258 * z3876 - z3286 * z4031 - z3307 * z4032 - z3322 * z4033 - z3332 * z4034 - z3338 * z4035
        - z3676;
    const Scalar z4049 = z3258 * z3877 - z3286 * z4044 - z3307 * z4045 - z3322 * z4046 - z3332 * z4047 - z3338 * z4048
        - z3694;
    const Scalar z4062 = z3258 * z3869 - z3744 - z3286 * z4057 - z3307 * z4058 - z3322 * z4059 - z3332 * z4060 - z3338
        * z4061;
    const Scalar z4024 = z3340 * z4023;
    const Scalar z4037 = z3340 * z4036;
    const Scalar z4050 = z3340 * z4049;
    const Scalar z4063 = z3340 * z4062;
    const Scalar z4025 = z3337 * z4022 - z3338 * z4024;
    const Scalar z4038 = z3337 * z4035 - z3338 * z4037;
    const Scalar z4051 = z3337 * z4048 - z3338 * z4050;
    const Scalar z4064 = z3337 * z4061 - z3338 * z4063;
    const Scalar z4026 = z3331 * z4021 - z3332 * z4024 - z3333 * z4025;
    const Scalar z4039 = z3331 * z4034 - z3332 * z4037 - z3333 * z4038;
    const Scalar z4052 = z3331 * z4047 - z3332 * z4050 - z3333 * z4051;
    const Scalar z4065 = z3331 * z4060 - z3332 * z4063 - z3333 * z4064;
    const Scalar z4027 = z3321 * z4020 - z3322 * z4024 - z3323 * z4025 - z3324 * z4026;
    const Scalar z4040 = z3321 * z4033 - z3322 * z4037 - z3323 * z4038 - z3324 * z4039;
    const Scalar z4053 = z3321 * z4046 - z3322 * z4050 - z3323 * z4051 - z3324 * z4052;
    const Scalar z4066 = z3321 * z4059 - z3322 * z4063 - z3323 * z4064 - z3324 * z4065;
    const Scalar z4015 = z3306 * z4006 - z3307 * z4011 - z3308 * z4012 - z3309 * z4013 - z3310 * z4014;
    const Scalar z4075 = z3258 * z3870 - z3286 * z4070 - z3307 * z4071 - z3322 * z4072 - z3332 * z4073 + z3769 - z3338
        * z4074;
    const Scalar z4028 = z3306 * z4019 - z3307 * z4024 - z3308 * z4025 - z3309 * z4026 - z3310 * z4027;
    const Scalar z4041 = z3306 * z4032 - z3307 * z4037 - z3308 * z4038 - z3309 * z4039 - z3310 * z4040;
    const Scalar z4054 = z3306 * z4045 - z3307 * z4050 - z3308 * z4051 - z3309 * z4052 - z3310 * z4053;
    const Scalar z4067 = z3306 * z4058 - z3307 * z4063 - z3308 * z4064 - z3309 * z4065 - z3310 * z4066;
    const Scalar z4016 = z3285 * z4005 - z3286 * z4011 - z3287 * z4012 - z3288 * z4013 - z3289 * z4014 - z3290 * z4015;
    const Scalar z4017 = z3258 * z4011 - k52 * z3883 + z3259 * z4012 + z3260 * z4013 + z3261 * z4014 + z3262 * z4015
        + z3263 * z4016;
    const Scalar z4083 = z3263 * z3865 - z3773;
    const Scalar z4084 = z3262 * z3865 - z3808 - z3290 * z4083;
    const Scalar z4076 = z3340 * z4075;
    const Scalar z4077 = z3337 * z4074 - z3338 * z4076;
    const Scalar z4085 = z3261 * z3865 - z3815 - z3289 * z4083 - z3310 * z4084;
    const Scalar z4078 = z3331 * z4073 - z3332 * z4076 - z3333 * z4077;
    const Scalar z4086 = z3260 * z3865 - z3288 * z4083 - z3309 * z4084 + z3821 - z3324 * z4085;
    const Scalar z4079 = z3321 * z4072 - z3322 * z4076 - z3323 * z4077 - z3324 * z4078;
    const Scalar z4087 = z3827 + z3259 * z3865 - z3287 * z4083 - z3308 * z4084 - z3323 * z4085 - z3333 * z4086;
    const Scalar z4088 = z3258 * z3865 - z3828 - z3286 * z4083 - z3307 * z4084 - z3322 * z4085 - z3332 * z4086 - z3338
        * z4087;
    const Scalar z4080 = z3306 * z4071 - z3307 * z4076 - z3308 * z4077 - z3309 * z4078 - z3310 * z4079;
    const Scalar z4029 = z3285 * z4018 - z3286 * z4024 - z3287 * z4025 - z3288 * z4026 - z3289 * z4027 - z3290 * z4028;
    const Scalar z4030 = z3258 * z4024 - k52 * z3884 + z3259 * z4025 + z3260 * z4026 + z3261 * z4027 + z3262 * z4028
        + z3263 * z4029;
    const Scalar z4096 = z3263 * z3866 - z3774;
    const Scalar z4097 = z3262 * z3866 + z3837 - z3290 * z4096;
    const Scalar z4089 = z3340 * z4088;
    const Scalar z4090 = z3337 * z4087 - z3338 * z4089;
    const Scalar z4098 = z3261 * z3866 - z3844 - z3289 * z4096 - z3310 * z4097;
    const Scalar z4091 = z3331 * z4086 - z3332 * z4089 - z3333 * z4090;
    const Scalar z4099 = z3260 * z3866 - z3288 * z4096 - z3309 * z4097 + z3850 - z3324 * z4098;
    const Scalar z4092 = z3321 * z4085 - z3322 * z4089 - z3323 * z4090 - z3324 * z4091;
    const Scalar z4100 = z3856 + z3259 * z3866 - z3287 * z4096 - z3308 * z4097 - z3323 * z4098 - z3333 * z4099;
    const Scalar z4101 = z3258 * z3866 - z3857 - z3286 * z4096 - z3307 * z4097 - z3322 * z4098 - z3332 * z4099 - z3338
        * z4100;
    const Scalar z4093 = z3306 * z4084 - z3307 * z4089 - z3308 * z4090 - z3309 * z4091 - z3310 * z4092;
    const Scalar z4042 = z3285 * z4031 - z3286 * z4037 - z3287 * z4038 - z3288 * z4039 - z3289 * z4040 - z3290 * z4041;
    const Scalar z4043 = z3258 * z4037 - k52 * z3876 + z3259 * z4038 + z3260 * z4039 + z3261 * z4040 + z3262 * z4041
        + z3263 * z4042;
    const Scalar z4109 = z3263 * z3861 - z3903;
    const Scalar z4110 = z3262 * z3861 + z3907 - z3290 * z4109;
    const Scalar z4102 = z3340 * z4101;
    const Scalar z4103 = z3337 * z4100 - z3338 * z4102;
    const Scalar z4111 = z3914 + z3261 * z3861 - z3289 * z4109 - z3310 * z4110;
    const Scalar z4104 = z3331 * z4099 - z3332 * z4102 - z3333 * z4103;
    const Scalar z4112 = z3260 * z3861 - z3288 * z4109 - z3309 * z4110 + z3920 - z3324 * z4111;
    const Scalar z4105 = z3321 * z4098 - z3322 * z4102 - z3323 * z4103 - z3324 * z4104;
    const Scalar z4113 = z3926 + z3259 * z3861 - z3287 * z4109 - z3308 * z4110 - z3323 * z4111 - z3333 * z4112;
    const Scalar z4114 = z3927 + z3258 * z3861 - z3286 * z4109 - z3307 * z4110 - z3322 * z4111 - z3332 * z4112 - z3338
        * z4113;
    const Scalar z4106 = z3306 * z4097 - z3307 * z4102 - z3308 * z4103 - z3309 * z4104 - z3310 * z4105;
    const Scalar z4055 = z3285 * z4044 - z3286 * z4050 - z3287 * z4051 - z3288 * z4052 - z3289 * z4053 - z3290 * z4054;
    const Scalar z4056 = z3258 * z4050 - k52 * z3877 + z3259 * z4051 + z3260 * z4052 + z3261 * z4053 + z3262 * z4054
        + z3263 * z4055;
    const Scalar z4122 = z3263 * z3862 - z3934;
    const Scalar z4123 = z3262 * z3862 + z3938 - z3290 * z4122;
    const Scalar z4115 = z3340 * z4114;
    const Scalar z4116 = z3337 * z4113 - z3338 * z4115;
    const Scalar z4124 = z3261 * z3862 - z3945 - z3289 * z4122 - z3310 * z4123;
    const Scalar z4117 = z3331 * z4112 - z3332 * z4115 - z3333 * z4116;
    const Scalar z4125 = z3951 + z3260 * z3862 - z3288 * z4122 - z3309 * z4123 - z3324 * z4124;
    const Scalar z4126 = z3957 + z3259 * z3862 - z3287 * z4122 - z3308 * z4123 - z3323 * z4124 - z3333 * z4125;
    const Scalar z4127 = z3258 * z3862 - z3958 - z3286 * z4122 - z3307 * z4123 - z3322 * z4124 - z3332 * z4125 - z3338
        * z4126;
    const Scalar z4118 = z3321 * z4111 - z3322 * z4115 - z3323 * z4116 - z3324 * z4117;
    const Scalar z4119 = z3306 * z4110 - z3307 * z4115 - z3308 * z4116 - z3309 * z4117 - z3310 * z4118;
    const Scalar z4068 = z3285 * z4057 - z3286 * z4063 - z3287 * z4064 - z3288 * z4065 - z3289 * z4066 - z3290 * z4067;
    const Scalar z4069 = z3258 * z4063 - k52 * z3869 + z3259 * z4064 + z3260 * z4065 + z3261 * z4066 + z3262 * z4067
        + z3263 * z4068;
    const Scalar z4128 = z3340 * z4127;
    const Scalar z4129 = z3337 * z4126 - z3338 * z4128;
    const Scalar z4081 = z3285 * z4070 - z3286 * z4076 - z3287 * z4077 - z3288 * z4078 - z3289 * z4079 - z3290 * z4080;
    const Scalar z4082 = z3258 * z4076 - k52 * z3870 + z3259 * z4077 + z3260 * z4078 + z3261 * z4079 + z3262 * z4080
        + z3263 * z4081;
    const Scalar z4130 = z3331 * z4125 - z3332 * z4128 - z3333 * z4129;
    const Scalar z4131 = z3321 * z4124 - z3322 * z4128 - z3323 * z4129 - z3324 * z4130;
    const Scalar z4094 = z3285 * z4083 - z3286 * z4089 - z3287 * z4090 - z3288 * z4091 - z3289 * z4092 - z3290 * z4093;
    const Scalar z4095 = z3258 * z4089 - k52 * z3865 + z3259 * z4090 + z3260 * z4091 + z3261 * z4092 + z3262 * z4093
        + z3263 * z4094;
    const Scalar z4132 = z3306 * z4123 - z3307 * z4128 - z3308 * z4129 - z3309 * z4130 - z3310 * z4131;
    const Scalar z4107 = z3285 * z4096 - z3286 * z4102 - z3287 * z4103 - z3288 * z4104 - z3289 * z4105 - z3290 * z4106;
    const Scalar z4108 = z3258 * z4102 - k52 * z3866 + z3259 * z4103 + z3260 * z4104 + z3261 * z4105 + z3262 * z4106
        + z3263 * z4107;
    const Scalar z4120 = z3285 * z4109 - z3286 * z4115 - z3287 * z4116 - z3288 * z4117 - z3289 * z4118 - z3290 * z4119;
    const Scalar z4121 = z3258 * z4115 - k52 * z3861 + z3259 * z4116 + z3260 * z4117 + z3261 * z4118 + z3262 * z4119
        + z3263 * z4120;
    const Scalar z4133 = z3285 * z4122 - z3286 * z4128 - z3287 * z4129 - z3288 * z4130 - z3289 * z4131 - z3290 * z4132;
    const Scalar z4134 = z3258 * z4128 - k52 * z3862 + z3259 * z4129 + z3260 * z4130 + z3261 * z4131 + z3262 * z4132
        + z3263 * z4133;
    const Scalar z4185 = z3262 - z3263 * z3290;
    const Scalar z4174 = z3289 - z3290 * z3310;
    const Scalar z4186 = z3261 - z3263 * z3289 - z3310 * z4185;
    const Scalar z4164 = z3309 - z3310 * z3324;
    const Scalar z4175 = z3288 - z3290 * z3309 - z3324 * z4174;
    const Scalar z4187 = z3260 - z3263 * z3288 - z3309 * z4185 - z3324 * z4186;
    const Scalar z4155 = z3323 - z3324 * z3333;
    const Scalar z4165 = z3308 - z3310 * z3323 - z3333 * z4164;
    const Scalar z4176 = z3287 - z3290 * z3308 - z3323 * z4174 - z3333 * z4175;
    const Scalar z4188 = z3259 - z3263 * z3287 - z3308 * z4185 - z3323 * z4186 - z3333 * z4187;
    const Scalar z4147 = z3332 - z3333 * z3338;
    const Scalar z4148 = z3340 * z4147;
    const Scalar z4156 = z3322 - z3324 * z3332 - z3338 * z4155;
    const Scalar z4157 = z3340 * z4156;
    const Scalar z4166 = z3307 - z3310 * z3322 - z3332 * z4164 - z3338 * z4165;
    const Scalar z4167 = z3340 * z4166;
    const Scalar z4158 = z3337 * z4155 - z3338 * z4157;
    const Scalar z4177 = z3286 - z3290 * z3307 - z3322 * z4174 - z3332 * z4175 - z3338 * z4176;
    const Scalar z4178 = z3340 * z4177;
    const Scalar z4168 = z3337 * z4165 - z3338 * z4167;
    const Scalar z4169 = z3331 * z4164 - z3332 * z4167 - z3333 * z4168;
    const Scalar z4179 = z3337 * z4176 - z3338 * z4178;
    const Scalar z4189 = z3258 - z3263 * z3286 - z3307 * z4185 - z3322 * z4186 - z3332 * z4187 - z3338 * z4188;
    const Scalar z4190 = z3340 * z4189;
    const Scalar z4180 = z3331 * z4175 - z3332 * z4178 - z3333 * z4179;
    const Scalar z4191 = z3337 * z4188 - z3338 * z4190;
    const Scalar z4181 = z3321 * z4174 - z3322 * z4178 - z3323 * z4179 - z3324 * z4180;
    const Scalar z4192 = z3331 * z4187 - z3332 * z4190 - z3333 * z4191;
    const Scalar z4135 = z3338 * z3340;
    const Scalar z4193 = z3321 * z4186 - z3322 * z4190 - z3323 * z4191 - z3324 * z4192;
    const Scalar z4141 = z3337 + z3338 * z4135;
    const Scalar z4149 = z3333 * z3337 - z3338 * z4148;
    const Scalar z4194 = z3306 * z4185 - z3307 * z4190 - z3308 * z4191 - z3309 * z4192 - z3310 * z4193;
    const Scalar z4136 = z3332 * z3340 - z3333 * z4135;
    const Scalar z4142 = z3332 * z4135 - z3333 * z4141;
    const Scalar z4150 = z3331 + z3332 * z4148 + z3333 * z4149;
    const Scalar z4159 = z3324 * z3331 - z3332 * z4157 - z3333 * z4158;
    const Scalar z4137 = z3322 * z3340 - z3323 * z4135 - z3324 * z4136;
    const Scalar z4143 = z3322 * z4135 - z3323 * z4141 - z3324 * z4142;
    const Scalar z4151 = z3322 * z4148 + z3323 * z4149 - z3324 * z4150;
    const Scalar z4160 = z3321 + z3322 * z4157 + z3323 * z4158 + z3324 * z4159;
    const Scalar z4170 = z3310 * z3321 - z3322 * z4167 - z3323 * z4168 - z3324 * z4169;
    const Scalar z4138 = z3307 * z3340 - z3308 * z4135 - z3309 * z4136 - z3310 * z4137;
    const Scalar z4144 = z3307 * z4135 - z3308 * z4141 - z3309 * z4142 - z3310 * z4143;
    const Scalar z4152 = z3307 * z4148 + z3308 * z4149 - z3309 * z4150 - z3310 * z4151;
    const Scalar z4161 = z3307 * z4157 + z3308 * z4158 + z3309 * z4159 - z3310 * z4160;
    const Scalar z4171 = z3306 + z3307 * z4167 + z3308 * z4168 + z3309 * z4169 + z3310 * z4170;
    const Scalar z4182 = z3290 * z3306 - z3307 * z4178 - z3308 * z4179 - z3309 * z4180 - z3310 * z4181;
    const Scalar z4139 = z3286 * z3340 - z3287 * z4135 - z3288 * z4136 - z3289 * z4137 - z3290 * z4138;
    const Scalar z4140 = z3258 * z3340 - z3259 * z4135 - z3260 * z4136 - z3261 * z4137 - z3262 * z4138 - z3263 * z4139;
    const Scalar z4145 = z3286 * z4135 - z3287 * z4141 - z3288 * z4142 - z3289 * z4143 - z3290 * z4144;
    const Scalar z4146 = z3258 * z4135 - z3259 * z4141 - z3260 * z4142 - z3261 * z4143 - z3262 * z4144 - z3263 * z4145;
    const Scalar z4153 = z3286 * z4148 + z3287 * z4149 - z3288 * z4150 - z3289 * z4151 - z3290 * z4152;
    const Scalar z4154 = z3258 * z4148 + z3259 * z4149 - z3260 * z4150 - z3261 * z4151 - z3262 * z4152 - z3263 * z4153;
    const Scalar z4162 = z3286 * z4157 + z3287 * z4158 + z3288 * z4159 - z3289 * z4160 - z3290 * z4161;
    const Scalar z4163 = z3258 * z4157 + z3259 * z4158 + z3260 * z4159 - z3261 * z4160 - z3262 * z4161 - z3263 * z4162;
    const Scalar z4172 = z3286 * z4167 + z3287 * z4168 + z3288 * z4169 + z3289 * z4170 - z3290 * z4171;
    const Scalar z4173 = z3258 * z4167 + z3259 * z4168 + z3260 * z4169 + z3261 * z4170 - z3262 * z4171 - z3263 * z4172;
    const Scalar z4183 = z3285 + z3286 * z4178 + z3287 * z4179 + z3288 * z4180 + z3289 * z4181 + z3290 * z4182;
    const Scalar z4184 = z3258 * z4178 + z3259 * z4179 + z3260 * z4180 + z3261 * z4181 + z3262 * z4182 - z3263 * z4183;
    const Scalar z4195 = z3263 * z3285 - z3286 * z4190 - z3287 * z4191 - z3288 * z4192 - z3289 * z4193 - z3290 * z4194;
    const Scalar z4196 = k52 - z3258 * z4190 - z3259 * z4191 - z3260 * z4192 - z3261 * z4193 - z3262 * z4194 - z3263
        * z4195;
    result.M[0] = z3078;
    result.M[1] = -z3072;
    result.M[2] = -z3055;
    result.M[3] = z3030;
    result.M[4] = z2999;
    result.M[5] = -z2965;
    result.M[6] = z2928;
    result.M[7] = -z3072;
    result.M[8] = z3071;
    result.M[9] = -z3054;
    result.M[10] = z3029;
    result.M[11] = z2998;
    result.M[12] = z2964;
    result.M[13] = z2927;
    result.M[14] = -z3055;
    result.M[15] = -z3054;
    result.M[16] = z3048;
    result.M[17] = z3022;
    result.M[18] = -z2992;
    result.M[19] = -z2958;
    result.M[20] = -z2921;
    result.M[21] = z3030;
    result.M[22] = z3029;
    result.M[23] = z3022;
    result.M[24] = z3018;
    result.M[25] = -z2986;
    result.M[26] = -z2952;
    result.M[27] = z2915;
    result.M[28] = z2999;
    result.M[29] = z2998;
    result.M[30] = -z2992;
    result.M[31] = -z2986;
    result.M[32] = z2979;
    result.M[33] = -z2945;
    result.M[34] = z2908;
    result.M[35] = -z2965;
    result.M[36] = z2964;
    result.M[37] = -z2958;
    result.M[38] = -z2952;
    result.M[39] = -z2945;
    result.M[40] = z2941;
    result.M[41] = -z2903;
    result.M[42] = z2928;
    result.M[43] = z2927;
    result.M[44] = -z2921;
    result.M[45] = z2915;
    result.M[46] = z2908;
    result.M[47] = -z2903;
    result.M[48] = k6;
    result.C[0] = -z3596;
    result.C[1] = -z3589;
    result.C[2] = -z3617;
    result.C[3] = z3657;
    result.C[4] = -z3718;
    result.C[5] = z3798;
    result.C[6] = -z3892;
    result.C[7] = z3608;
    result.C[8] = -z3601;
    result.C[9] = -z3616;
    result.C[10] = -z3656;
    result.C[11] = z3717;
    result.C[12] = z3797;
    result.C[13] = z3891;
    result.C[14] = z3640;
    result.C[15] = -z3639;
    result.C[16] = -z3613;
    result.C[17] = z3649;
    result.C[18] = -z3710;
    result.C[19] = z3790;
    result.C[20] = -z3884;
    result.C[21] = -z3694;
    result.C[22] = -z3693;
    result.C[23] = z3687;
    result.C[24] = -z3645;
    result.C[25] = -z3703;
    result.C[26] = -z3783;
    result.C[27] = -z3877;
    result.C[28] = -z3769;
    result.C[29] = -z3768;
    result.C[30] = z3762;
    result.C[31] = -z3756;
    result.C[32] = z3699;
    result.C[33] = -z3776;
    result.C[34] = z3870;
    result.C[35] = z3857;
    result.C[36] = -z3856;
    result.C[37] = z3850;
    result.C[38] = z3844;
    result.C[39] = -z3837;
    result.C[40] = -z3774;
    result.C[41] = z3866;
    result.C[42] = z3958;
    result.C[43] = -z3957;
    result.C[44] = z3951;
    result.C[45] = z3945;
    result.C[46] = -z3938;
    result.C[47] = -z3934;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z3605;
    result.K[8] = z3600;
    result.K[9] = -z3615;
    result.K[10] = z3655;
    result.K[11] = z3716;
    result.K[12] = z3796;
    result.K[13] = z3890;
    result.K[14] = -z3629;
    result.K[15] = z3628;
    result.K[16] = z3612;
    result.K[17] = z3648;
    result.K[18] = z3709;
    result.K[19] = -z3789;
    result.K[20] = z3883;
    result.K[21] = -z3676;
    result.K[22] = -z3675;
    result.K[23] = z3669;
    result.K[24] = z3644;
    result.K[25] = -z3702;
    result.K[26] = z3782;
    result.K[27] = -z3876;
    result.K[28] = -z3744;
    result.K[29] = z3743;
    result.K[30] = -z3737;
    result.K[31] = -z3731;
    result.K[32] = z3698;
    result.K[33] = z3775;
    result.K[34] = -z3869;
    result.K[35] = -z3828;
    result.K[36] = z3827;
    result.K[37] = -z3821;
    result.K[38] = -z3815;
    result.K[39] = -z3808;
    result.K[40] = z3773;
    result.K[41] = -z3865;
    result.K[42] = -z3927;
    result.K[43] = -z3926;
    result.K[44] = z3920;
    result.K[45] = -z3914;
    result.K[46] = -z3907;
    result.K[47] = -z3903;
    result.K[48] = z3861;
    result.F[0] = z3959;
    result.F[1] = z3960;
    result.F[2] = z3961;
    result.F[3] = z3962;
    result.F[4] = z3963;
    result.F[5] = z3964;
    result.F[6] = z3965;
    result.E[0] = n1;
    result.E[1] = n0;
    result.E[2] = n0;
    result.E[3] = n0;
    result.E[4] = n0;
    result.E[5] = n0;
    result.E[6] = n0;
    result.E[7] = n0;
    result.E[8] = n1;
    result.E[9] = n0;
    result.E[10] = n0;
    result.E[11] = n0;
    result.E[12] = n0;
    result.E[13] = n0;
    result.E[14] = n0;
    result.E[15] = n0;
    result.E[16] = n1;
    result.E[17] = n0;
    result.E[18] = n0;
    result.E[19] = n0;
    result.E[20] = n0;
    result.E[21] = n0;
    result.E[22] = n0;
    result.E[23] = n0;
    result.E[24] = n1;
    result.E[25] = n0;
    result.E[26] = n0;
    result.E[27] = n0;
    result.E[28] = n0;
    result.E[29] = n0;
    result.E[30] = n0;
    result.E[31] = n0;
    result.E[32] = n1;
    result.E[33] = n0;
    result.E[34] = n0;
    result.E[35] = n0;
    result.E[36] = n0;
    result.E[37] = n0;
    result.E[38] = n0;
    result.E[39] = n0;
    result.E[40] = n1;
    result.E[41] = n0;
    result.E[42] = n0;
    result.E[43] = n0;
    result.E[44] = n0;
    result.E[45] = n0;
    result.E[46] = n0;
    result.E[47] = n0;
    result.E[48] = n1;
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
    result.A[21] = -z3985;
    result.A[22] = -z3986;
    result.A[23] = z3987;
    result.A[24] = -z3988;
    result.A[25] = -z3989;
    result.A[26] = z3990;
    result.A[27] = z3991;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = -z4011;
    result.A[36] = -z4012;
    result.A[37] = z4013;
    result.A[38] = -z4014;
    result.A[39] = -z4015;
    result.A[40] = z4016;
    result.A[41] = z4017;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z4037;
    result.A[50] = z4038;
    result.A[51] = -z4039;
    result.A[52] = z4040;
    result.A[53] = z4041;
    result.A[54] = -z4042;
    result.A[55] = -z4043;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z4063;
    result.A[64] = z4064;
    result.A[65] = -z4065;
    result.A[66] = z4066;
    result.A[67] = z4067;
    result.A[68] = -z4068;
    result.A[69] = -z4069;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = z4089;
    result.A[78] = z4090;
    result.A[79] = -z4091;
    result.A[80] = z4092;
    result.A[81] = z4093;
    result.A[82] = -z4094;
    result.A[83] = -z4095;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = -z4115;
    result.A[92] = -z4116;
    result.A[93] = z4117;
    result.A[94] = -z4118;
    result.A[95] = -z4119;
    result.A[96] = z4120;
    result.A[97] = z4121;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = z3972;
    result.A[106] = z3973;
    result.A[107] = -z3974;
    result.A[108] = z3975;
    result.A[109] = z3976;
    result.A[110] = -z3977;
    result.A[111] = -z3978;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = -z3998;
    result.A[120] = -z3999;
    result.A[121] = z4000;
    result.A[122] = -z4001;
    result.A[123] = -z4002;
    result.A[124] = z4003;
    result.A[125] = z4004;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = z4024;
    result.A[134] = z4025;
    result.A[135] = -z4026;
    result.A[136] = z4027;
    result.A[137] = z4028;
    result.A[138] = -z4029;
    result.A[139] = -z4030;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z4050;
    result.A[148] = z4051;
    result.A[149] = -z4052;
    result.A[150] = z4053;
    result.A[151] = z4054;
    result.A[152] = -z4055;
    result.A[153] = -z4056;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z4076;
    result.A[162] = -z4077;
    result.A[163] = z4078;
    result.A[164] = -z4079;
    result.A[165] = -z4080;
    result.A[166] = z4081;
    result.A[167] = z4082;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z4102;
    result.A[176] = -z4103;
    result.A[177] = z4104;
    result.A[178] = -z4105;
    result.A[179] = -z4106;
    result.A[180] = z4107;
    result.A[181] = z4108;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z4128;
    result.A[190] = -z4129;
    result.A[191] = z4130;
    result.A[192] = -z4131;
    result.A[193] = -z4132;
    result.A[194] = z4133;
    result.A[195] = z4134;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z3340;
    result.B[8] = z4135;
    result.B[9] = -z4136;
    result.B[10] = z4137;
    result.B[11] = z4138;
    result.B[12] = -z4139;
    result.B[13] = z4140;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z4135;
    result.B[22] = -z4141;
    result.B[23] = z4142;
    result.B[24] = -z4143;
    result.B[25] = -z4144;
    result.B[26] = z4145;
    result.B[27] = -z4146;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z4148;
    result.B[36] = -z4149;
    result.B[37] = -z4150;
    result.B[38] = z4151;
    result.B[39] = z4152;
    result.B[40] = -z4153;
    result.B[41] = z4154;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z4157;
    result.B[50] = z4158;
    result.B[51] = -z4159;
    result.B[52] = -z4160;
    result.B[53] = -z4161;
    result.B[54] = z4162;
    result.B[55] = -z4163;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z4167;
    result.B[64] = z4168;
    result.B[65] = -z4169;
    result.B[66] = z4170;
    result.B[67] = -z4171;
    result.B[68] = z4172;
    result.B[69] = -z4173;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z4178;
    result.B[78] = -z4179;
    result.B[79] = z4180;
    result.B[80] = -z4181;
    result.B[81] = -z4182;
    result.B[82] = -z4183;
    result.B[83] = z4184;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z4190;
    result.B[92] = z4191;
    result.B[93] = -z4192;
    result.B[94] = z4193;
    result.B[95] = z4194;
    result.B[96] = -z4195;
    result.B[97] = z4196;
    if (!(traits::regular(-z3339, z3078) && traits::regular(-z3336, z3071) && traits::regular(-z3330, z3048)
        && traits::regular(-z3320, z3018) && traits::regular(-z3305, z2979) && traits::regular(-z3284,
        z2941))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((((n0 * result.M[0] * result.M[1] * result.M[2] * result.M[3] * result.M[4] * result.M[5]
        * result.M[6] * result.M[7]) * (n0 * result.M[8] * result.M[9] * result.M[10] * result.M[11] * result.M[12]
        * result.M[13] * result.M[14] * result.M[15] * result.M[16])) * ((n0 * result.M[17] * result.M[18]
        * result.M[19] * result.M[20] * result.M[21] * result.M[22] * result.M[23] * result.M[24] * result.M[25]) * (n0
        * result.M[26] * result.M[27] * result.M[28] * result.M[29] * result.M[30] * result.M[31] * result.M[32]
        * result.M[33] * result.M[34]))) * (((n0 * result.M[35] * result.M[36] * result.M[37] * result.M[38]
        * result.M[39] * result.M[40] * result.M[41] * result.M[42] * result.M[43]) * (n0 * result.M[44] * result.M[45]
        * result.M[46] * result.M[47] * result.C[0] * result.C[1] * result.C[2] * result.C[3] * result.C[4])) * ((n0
        * result.C[5] * result.C[6] * result.C[7] * result.C[8] * result.C[9] * result.C[10] * result.C[11]
        * result.C[12] * result.C[13]) * (n0 * result.C[14] * result.C[15] * result.C[16] * result.C[17] * result.C[18]
        * result.C[19] * result.C[20] * result.C[21] * result.C[22])))) * ((((n0 * result.C[23] * result.C[24]
        * result.C[25] * result.C[26] * result.C[27] * result.C[28] * result.C[29] * result.C[30]) * (n0 * result.C[31]
        * result.C[32] * result.C[33] * result.C[34] * result.C[35] * result.C[36] * result.C[37] * result.C[38]
        * result.C[39])) * ((n0 * result.C[40] * result.C[41] * result.C[42] * result.C[43] * result.C[44]
        * result.C[45] * result.C[46] * result.C[47] * result.K[7]) * (n0 * result.K[8] * result.K[9] * result.K[10]
        * result.K[11] * result.K[12] * result.K[13] * result.K[14] * result.K[15] * result.K[16]))) * (((n0
        * result.K[17] * result.K[18] * result.K[19] * result.K[20] * result.K[21] * result.K[22] * result.K[23]
        * result.K[24] * result.K[25]) * (n0 * result.K[26] * result.K[27] * result.K[28] * result.K[29] * result.K[30]
        * result.K[31] * result.K[32] * result.K[33] * result.K[34])) * ((n0 * result.K[35] * result.K[36]
        * result.K[37] * result.K[38] * result.K[39] * result.K[40] * result.K[41] * result.K[42] * result.K[43]) * (n0
        * result.K[44] * result.K[45] * result.K[46] * result.K[47] * result.K[48] * result.F[0] * result.F[1]
        * result.F[2] * result.F[3]))))) * (((((n0 * result.F[4] * result.F[5] * result.F[6] * result.A[21]
        * result.A[22] * result.A[23] * result.A[24] * result.A[25]) * (n0 * result.A[26] * result.A[27] * result.A[35]
        * result.A[36] * result.A[37] * result.A[38] * result.A[39] * result.A[40] * result.A[41])) * ((n0
        * result.A[49] * result.A[50] * result.A[51] * result.A[52] * result.A[53] * result.A[54] * result.A[55]
        * result.A[63] * result.A[64]) * (n0 * result.A[65] * result.A[66] * result.A[67] * result.A[68] * result.A[69]
        * result.A[77] * result.A[78] * result.A[79] * result.A[80]))) * (((n0 * result.A[81] * result.A[82]
        * result.A[83] * result.A[91] * result.A[92] * result.A[93] * result.A[94] * result.A[95] * result.A[96]) * (n0
        * result.A[97] * result.A[105] * result.A[106] * result.A[107] * result.A[108] * result.A[109] * result.A[110]
        * result.A[111] * result.A[119])) * ((n0 * result.A[120] * result.A[121] * result.A[122] * result.A[123]
        * result.A[124] * result.A[125] * result.A[133] * result.A[134] * result.A[135]) * (n0 * result.A[136]
        * result.A[137] * result.A[138] * result.A[139] * result.A[147] * result.A[148] * result.A[149] * result.A[150]
        * result.A[151])))) * ((((n0 * result.A[152] * result.A[153] * result.A[161] * result.A[162] * result.A[163]
        * result.A[164] * result.A[165] * result.A[166] * result.A[167]) * (n0 * result.A[175] * result.A[176]
        * result.A[177] * result.A[178] * result.A[179] * result.A[180] * result.A[181] * result.A[189]
        * result.A[190])) * ((n0 * result.A[191] * result.A[192] * result.A[193] * result.A[194] * result.A[195]
        * result.B[7] * result.B[8] * result.B[9] * result.B[10]) * (n0 * result.B[11] * result.B[12] * result.B[13]
        * result.B[21] * result.B[22] * result.B[23] * result.B[24] * result.B[25] * result.B[26]))) * (((n0
        * result.B[27] * result.B[35] * result.B[36] * result.B[37] * result.B[38] * result.B[39] * result.B[40]
        * result.B[41] * result.B[49]) * (n0 * result.B[50] * result.B[51] * result.B[52] * result.B[53] * result.B[54]
        * result.B[55] * result.B[63] * result.B[64] * result.B[65])) * ((n0 * result.B[66] * result.B[67]
        * result.B[68] * result.B[69] * result.B[77] * result.B[78] * result.B[79] * result.B[80] * result.B[81]) * (n0
        * result.B[82] * result.B[83] * result.B[91] * result.B[92] * result.B[93] * result.B[94] * result.B[95]
        * result.B[96] * result.B[97])))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace arm7
