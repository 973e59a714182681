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
  static constexpr unsigned long long fingerprint = 0x263a1d5bebb64c13ULL;
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
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = v_q1 * c_q2;
    const Scalar z2 = s_q1 * c_q2;
    const Scalar z3 = n0_316 * v_q2;
    const Scalar z4 = c_q1 * c_q2;
    const Scalar z5 = s_q1 * s_q2;
    const Scalar z6 = s_q2 * s_q3;
    const Scalar z7 = s_q2 * z3;  // velocity of link3, z
    const Scalar z8 = c_q1 * s_q2;
    const Scalar z9 = s_q2 * c_q3;
    const Scalar z10 = s_q1 * v_q2;  // angular velocity of link2, x
    const Scalar z11 = c_q1 * v_q2;  // angular velocity of link2, y
    const Scalar z12 = v_q1 + c_q2 * v_q3;  // angular velocity of link3, z
    const Scalar z13 = n0_316 * c_q2;
    const Scalar z14 = s_q1 * s_q3 - c_q3 * z4;
    const Scalar z15 = s_q1 * c_q3 + s_q3 * z4;
    const Scalar z16 = c_q1 * s_q3 + c_q3 * z2;
    const Scalar z17 = c_q1 * c_q3 - s_q3 * z2;
    const Scalar z18 = n0_316 * z8;
    const Scalar z19 = n0_316 * z5;
    const Scalar z20 = n0_333 + z13;  // place of link3, z
    const Scalar z21 = n0_316 * z0;
    const Scalar z22 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z23 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z24 = v_q3 + z1;
    const Scalar z25 = v_q3 * z8 - z10;  // angular velocity of link3, x
    const Scalar z26 = v_q3 * z5 + z11;  // angular velocity of link3, y
    const Scalar z27 = c_q2 * s_q4 - c_q4 * z9;
    const Scalar z28 = c_q2 * c_q4 + s_q4 * z9;
    const Scalar z29 = n0_0825 * z9;
    const Scalar z30 = v_q4 * z6 - z12;  // angular velocity of link4, z
    const Scalar z31 = s_q1 * z21 - z4 * z3;  // velocity of link3, x
    const Scalar z32 = z2 * z3 + c_q1 * z21;  // velocity of link3, y
    const Scalar z33 = z20 - z29;  // place of link4, z
    const Scalar z34 = n0_0825 * z24;
    const Scalar z35 = s_q4 * z8 - c_q4 * z14;
    const Scalar z36 = c_q4 * z8 + s_q4 * z14;
    const Scalar z37 = s_q4 * z5 + c_q4 * z16;
    const Scalar z38 = s_q4 * z16 - c_q4 * z5;
    const Scalar z39 = n0_0825 * z14;
    const Scalar z40 = n0_0825 * z16;
    const Scalar z41 = n0_0825 * z23;
    const Scalar z42 = s_q4 * z24 + c_q4 * z22;
    const Scalar z43 = s_q4 * z22 - c_q4 * z24;
    const Scalar z44 = v_q4 - z23;
    const Scalar z45 = v_q4 * z15 + z25;  // angular velocity of link4, x
    const Scalar z46 = v_q4 * z17 - z26;  // angular velocity of link4, y
    const Scalar z47 = v_q5 * z28 - z30;  // angular velocity of link5, z
    const Scalar z48 = s_q5 * z6 + c_q5 * z27;
    const Scalar z49 = z5 * z41 - z32 - z17 * z34;  // velocity of link4, y
    const Scalar z50 = v_q5 * z36 + z45;  // angular velocity of link5, x
    const Scalar z51 = z31 + z15 * z34 + z8 * z41;  // velocity of link4, x
    const Scalar z52 = z7 - z6 * z34 + c_q2 * z41;  // velocity of link4, z
    const Scalar z53 = v_q5 * z38 + z46;  // angular velocity of link5, y
    const Scalar z54 = n0_384 * z44;
    const Scalar z55 = n0_384 * z42 - n0_0825 * z43;
    const Scalar z56 = s_q5 * z44 - c_q5 * z42;
    const Scalar z57 = v_q5 - z43;
    const Scalar z58 = c_q5 * z44 + s_q5 * z42;
    const Scalar z59 = n0_0825 * z44;
    const Scalar z60 = s_q5 * z15 - c_q5 * z35;
    const Scalar z61 = v_q6 + z58;
    const Scalar z62 = s_q5 * z17 + c_q5 * z37;
    const Scalar z63 = s_q6 * z57 - c_q6 * z56;
    const Scalar z64 = s_q6 * z56 + c_q6 * z57;
    const Scalar z65 = s_q6 * z36 - c_q6 * z60;
    const Scalar z66 = c_q6 * z36 + s_q6 * z60;
    const Scalar z67 = c_q5 * z15 + s_q5 * z35;
    const Scalar z68 = v_q6 * z67 + z50;  // angular velocity of link6, x
    const Scalar z69 = s_q5 * z37 - c_q5 * z17;
    const Scalar z70 = v_q6 * z69 - z53;  // angular velocity of link6, y
    const Scalar z71 = s_q5 * z27 - c_q5 * z6;
    const Scalar z72 = v_q6 * z71 + z47;  // angular velocity of link6, z
    const Scalar z73 = z15 * z55 - z51 - z35 * z54 - z36 * z59;  // velocity of link5, x
    const Scalar z74 = z49 + z37 * z54 - z38 * z59 + z17 * z55;  // velocity of link5, y
    const Scalar z75 = z52 + z27 * z54 + z28 * z59 + z6 * z55;  // velocity of link5, z
    const Scalar z76 = s_q6 * z38 - c_q6 * z62;
    const Scalar z77 = c_q6 * z38 + s_q6 * z62;
    const Scalar z78 = s_q6 * z28 + c_q6 * z48;
    const Scalar z79 = s_q6 * z48 - c_q6 * z28;
    const Scalar z80 = n0_088 * z65;
    const Scalar z81 = n0_0825 * z35 - n0_384 * z36;
    const Scalar z82 = n0_088 * z76;
    const Scalar z83 = n0_088 * z78;
    const Scalar z84 = n0_0825 * z37 + n0_384 * z38;
    const Scalar z85 = n0_0825 * z27 - n0_384 * z28;
    const Scalar z86 = s_q7 * z67 + c_q7 * z65;
    const Scalar z87 = s_q7 * z69 - c_q7 * z76;
    const Scalar z88 = s_q7 * z71 + c_q7 * z78;
    const Scalar z89 = z18 - z39;  // place of link4, x
    const Scalar z90 = z19 + z40;  // place of link4, y
    const Scalar z91 = v_q7 * z66 - z68;  // angular velocity of link7, x
    const Scalar z92 = v_q7 * z77 + z70;  // angular velocity of link7, y
    const Scalar z93 = v_q7 * z79 + z72;  // angular velocity of link7, z
    const Scalar z94 = k5 * s_q1 - k6 * c_q1;
    const Scalar z95 = k6 * s_q1 + k5 * c_q1;
    const Scalar z96 = k7 * s_q1 + k8 * z4 - k9 * z8;
    const Scalar z97 = k7 * c_q1 - k8 * z2 + k9 * z5;
    const Scalar z98 = n0_088 * z64;
    const Scalar z99 = s_q7 * z61 + c_q7 * z63;
    const Scalar z100 = n0_088 * z61;
    const Scalar z101 = s_q7 * z63 - c_q7 * z61;
    const Scalar z102 = v_q7 - z64;
    const Scalar z103 = z67 * z98 - z73 - z66 * z100;  // velocity of link7, x
    const Scalar z104 = z69 * z98 + z74 + z77 * z100;  // velocity of link7, y
    const Scalar z105 = z71 * z98 + z75 + z79 * z100;  // velocity of link7, z
    const Scalar z106 = s_q7 * z65 - c_q7 * z67;
    const Scalar z107 = c_q7 * z69 + s_q7 * z76;
    const Scalar z108 = s_q7 * z78 - c_q7 * z71;
    const Scalar z109 = k5 * v_q1;
    const Scalar z110 = k6 * v_q1;
    const Scalar z111 = s_q1 * z110 + c_q1 * z109;
    const Scalar z112 = s_q1 * z109 - c_q1 * z110;
    const Scalar z113 = z89 - z81;  // place of link5, x
    const Scalar z114 = k9 * v_q2 - k7 * z1;
    const Scalar z115 = z90 - z84;  // place of link5, y
    const Scalar z116 = k8 * v_q2 - k7 * z0;
    const Scalar z117 = z33 - z85;  // place of link5, z
    const Scalar z118 = k9 * z0 - k8 * z1;
    const Scalar z119 = s_q1 * z118 - z4 * z114 - z8 * z116;
    const Scalar z120 = z2 * z114 + z5 * z116 + c_q1 * z118;
    const Scalar z121 = s_q2 * z114 - c_q2 * z116;
    const Scalar z122 = k10 * z24 + k11 * z23;
    const Scalar z123 = k12 * z24 + k11 * z22;
    const Scalar z124 = k10 * z22 - k12 * z23;
    const Scalar z125 = z14 * z122 - z31 - z15 * z123 + z8 * z124;
    const Scalar z126 = z32 - z16 * z122 + z17 * z123 + z5 * z124;
    const Scalar z127 = z9 * z122 - z7 + z6 * z123 + c_q2 * z124;
    const Scalar z128 = k11 * z8 + k12 * z14 + k10 * z15;
    const Scalar z129 = z18 - z128;
    const Scalar z130 = k11 * z5 - k12 * z16 - k10 * z17;
    const Scalar z131 = z19 - z130;
    const Scalar z132 = k11 * c_q2 + k12 * z9 - k10 * z6;
    const Scalar z133 = z20 - z132;
    const Scalar z134 = k13 * z44 + k14 * z43;
    const Scalar z135 = k15 * z44 + k14 * z42;
    const Scalar z136 = k13 * z42 - k15 * z43;
    const Scalar z137 = z15 * z136 - z51 - z36 * z135 - z35 * z134;
    const Scalar z138 = z49 + z37 * z134 - z38 * z135 + z17 * z136;
    const Scalar z139 = z28 * z135 + z52 + z27 * z134 + z6 * z136;
    const Scalar z140 = k14 * z15 - k15 * z35 + k13 * z36;
    const Scalar z141 = z89 + z140;
    const Scalar z142 = k14 * z17 + k15 * z37 + k13 * z38;
    const Scalar z143 = z90 - z142;
    const Scalar z144 = k14 * z6 + k15 * z27 - k13 * z28;
    const Scalar z145 = z33 - z144;
    const Scalar z146 = z113 + z80;  // place of link7, x
    const Scalar z147 = k16 * z58 - k17 * z57;
    const Scalar z148 = z115 - z82;  // place of link7, y
    const Scalar z149 = k16 * z56 + k18 * z57;
    const Scalar z150 = z117 + z83;  // place of link7, z
    const Scalar z151 = k17 * z56 + k18 * z58;
    const Scalar z152 = z36 * z151 - z73 + z60 * z147 - z67 * z149;
    const Scalar z153 = k16 * z36 - k18 * z60 + k17 * z67;
    const Scalar z154 = z113 - z153;
    const Scalar z155 = z38 * z151 - z74 + z62 * z147 + z69 * z149;
    const Scalar z156 = z75 + z28 * z151 - z48 * z147 - z71 * z149;
    const Scalar z157 = k16 * z38 - k18 * z62 - k17 * z69;
    const Scalar z158 = z115 + z157;
    const Scalar z159 = k16 * z28 + k18 * z48 + k17 * z71;
    const Scalar z160 = z117 - z159;
    const Scalar z161 = k19 * z61 + k20 * z63;
    const Scalar z162 = k21 * z63 + k19 * z64;
    const Scalar z163 = k20 * z64 - k21 * z61;
    const Scalar z164 = z67 * z162 - z73 + z65 * z163 - z66 * z161;
    const Scalar z165 = z77 * z161 + z74 + z69 * z162 - z76 * z163;
    const Scalar z166 = z79 * z161 + z75 + z71 * z162 + z78 * z163;
    const Scalar z167 = k20 * z67 - k19 * z65 + k21 * z66;
    const Scalar z168 = z113 - z167;
    const Scalar z169 = k20 * z69 + k19 * z76 - k21 * z77;
    const Scalar z170 = z115 - z169;
    const Scalar z171 = k20 * z71 - k19 * z78 - k21 * z79;
    const Scalar z172 = z117 - z171;
    const Scalar z173 = k8 * s_q2 + k9 * c_q2;
    const Scalar z174 = n0_333 + z173;
    const Scalar z175 = n0_107 * z66;
    const Scalar z176 = z80 - z175;
    const Scalar z177 = z146 - z175;
    const Scalar z178 = n0_107 * z77;
    const Scalar z179 = z82 - z178;
    const Scalar z180 = z148 + z178;
    const Scalar z181 = n0_107 * z79;
    const Scalar z182 = z83 + z181;
    const Scalar z183 = z150 + z181;
    const Scalar z184 = z81 - z176;
    const Scalar z185 = z84 + z179;
    const Scalar z186 = z69 * z176 + z67 * z179;
    const Scalar z187 = z69 * z182 + z71 * z179;
    const Scalar z188 = z67 * z182 - z71 * z176;
    const Scalar z189 = z85 - z182;
    const Scalar z190 = z39 + z184;
    const Scalar z191 = z40 - z185;
    const Scalar z192 = z29 + z189;
    const Scalar z193 = z18 - z190;
    const Scalar z194 = z19 + z191;
    const Scalar z195 = z38 * z182 - z28 * z179;
    const Scalar z196 = z36 * z182 - z28 * z176;
    const Scalar z197 = z36 * z179 - z38 * z176;
    const Scalar z198 = c_q1 * z193 + s_q1 * z194;
    const Scalar z199 = z13 - z192;
    const Scalar z200 = z17 * z189 - z6 * z185;
    const Scalar z201 = z15 * z189 + z6 * z184;
    const Scalar z202 = z17 * z184 + z15 * z185;
    const Scalar z203 = z5 * z192 + c_q2 * z191;
    const Scalar z204 = z5 * z190 + z8 * z191;
    const Scalar z205 = c_q2 * z190 - z8 * z192;
    const Scalar z206 = k23 * z99 - k20 * z101;
    const Scalar z207 = c_q1 * z199;
    const Scalar z208 = s_q1 * z199;
    const Scalar z209 = k24 * z99 - k20 * z102;
    const Scalar z210 = n0_107 * z99;
    const Scalar z211 = k24 * z101 - k23 * z102;
    const Scalar z212 = n0_107 * z101;
    const Scalar z213 = z66 * z206 - z103 + z106 * z209 - z86 * z211;
    const Scalar z214 = z103 + z86 * z212 - z106 * z210;
    const Scalar z215 = k24 * z66 - k20 * z86 - k23 * z106;
    const Scalar z216 = k24 * z77 + k20 * z87 - k23 * z107;
    const Scalar z217 = k24 * z79 + k20 * z88 + k23 * z108;
    const Scalar z218 = z146 - z215;
    const Scalar z219 = z148 + z216;
    const Scalar z220 = z150 + z217;
    const Scalar z221 = z104 + z77 * z206 + z107 * z209 + z87 * z211;
    const Scalar z222 = z105 + z79 * z206 - z108 * z209 + z88 * z211;
    const Scalar z223 = z104 + z107 * z210 + z87 * z212;
    const Scalar z224 = z105 + z88 * z212 - z108 * z210;
    result.link1_position[0] = -z94;
    result.link1_position[1] = z95;
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
    result.link1_velocity[0] = -z111;
    result.link1_velocity[1] = -z112;
    result.link1_velocity[2] = n0;
    result.link1_angular_velocity[0] = n0;
    result.link1_angular_velocity[1] = n0;
    result.link1_angular_velocity[2] = v_q1;
    result.link2_position[0] = -z96;
    result.link2_position[1] = z97;
    result.link2_position[2] = z174;
    result.link2_rotation[0] = z4;
    result.link2_rotation[1] = z2;
    result.link2_rotation[2] = -s_q2;
    result.link2_rotation[3] = -z8;
    result.link2_rotation[4] = -z5;
    result.link2_rotation[5] = -c_q2;
    result.link2_rotation[6] = -s_q1;
    result.link2_rotation[7] = c_q1;
    result.link2_rotation[8] = n0;
    result.link2_velocity[0] = -z119;
    result.link2_velocity[1] = z120;
    result.link2_velocity[2] = -z121;
    result.link2_angular_velocity[0] = -z10;
    result.link2_angular_velocity[1] = z11;
    result.link2_angular_velocity[2] = v_q1;
    result.link3_position[0] = z129;
    result.link3_position[1] = z131;
    result.link3_position[2] = z133;
    result.link3_rotation[0] = -z14;
    result.link3_rotation[1] = z16;
    result.link3_rotation[2] = -z9;
    result.link3_rotation[3] = -z15;
    result.link3_rotation[4] = z17;
    result.link3_rotation[5] = z6;
    result.link3_rotation[6] = z8;
    result.link3_rotation[7] = z5;
    result.link3_rotation[8] = c_q2;
    result.link3_velocity[0] = z125;
    result.link3_velocity[1] = z126;
    result.link3_velocity[2] = z127;
    result.link3_angular_velocity[0] = z25;
    result.link3_angular_velocity[1] = z26;
    result.link3_angular_velocity[2] = z12;
    result.link4_position[0] = z141;
    result.link4_position[1] = z143;
    result.link4_position[2] = z145;
    result.link4_rotation[0] = z35;
    result.link4_rotation[1] = z37;
    result.link4_rotation[2] = z27;
    result.link4_rotation[3] = z36;
    result.link4_rotation[4] = -z38;
    result.link4_rotation[5] = z28;
    result.link4_rotation[6] = z15;
    result.link4_rotation[7] = -z17;
    result.link4_rotation[8] = -z6;
    result.link4_velocity[0] = z137;
    result.link4_velocity[1] = -z138;
    result.link4_velocity[2] = -z139;
    result.link4_angular_velocity[0] = z45;
    result.link4_angular_velocity[1] = -z46;
    result.link4_angular_velocity[2] = -z30;
    result.link5_position[0] = z154;
    result.link5_position[1] = z158;
    result.link5_position[2] = z160;
    result.link5_rotation[0] = -z60;
    result.link5_rotation[1] = z62;
    result.link5_rotation[2] = z48;
    result.link5_rotation[3] = -z67;
    result.link5_rotation[4] = -z69;
    result.link5_rotation[5] = -z71;
    result.link5_rotation[6] = z36;
    result.link5_rotation[7] = -z38;
    result.link5_rotation[8] = z28;
    result.link5_velocity[0] = -z152;
    result.link5_velocity[1] = z155;
    result.link5_velocity[2] = -z156;
    result.link5_angular_velocity[0] = z50;
    result.link5_angular_velocity[1] = -z53;
    result.link5_angular_velocity[2] = z47;
    result.link6_position[0] = z168;
    result.link6_position[1] = z170;
    result.link6_position[2] = z172;
    result.link6_rotation[0] = z65;
    result.link6_rotation[1] = -z76;
    result.link6_rotation[2] = z78;
    result.link6_rotation[3] = z66;
    result.link6_rotation[4] = -z77;
    result.link6_rotation[5] = -z79;
    result.link6_rotation[6] = z67;
    result.link6_rotation[7] = z69;
    result.link6_rotation[8] = z71;
    result.link6_velocity[0] = -z164;
    result.link6_velocity[1] = -z165;
    result.link6_velocity[2] = -z166;
    result.link6_angular_velocity[0] = z68;
    result.link6_angular_velocity[1] = z70;
    result.link6_angular_velocity[2] = z72;
    result.link7_position[0] = z218;
    result.link7_position[1] = z219;
    result.link7_position[2] = z220;
    result.link7_rotation[0] = z86;
    result.link7_rotation[1] = z87;
    result.link7_rotation[2] = z88;
    result.link7_rotation[3] = -z106;
    result.link7_rotation[4] = z107;
    result.link7_rotation[5] = -z108;
    result.link7_rotation[6] = -z66;
    result.link7_rotation[7] = z77;
    result.link7_rotation[8] = z79;
    result.link7_velocity[0] = z213;
    result.link7_velocity[1] = -z221;
    result.link7_velocity[2] = -z222;
    result.link7_angular_velocity[0] = -z91;
    result.link7_angular_velocity[1] = z92;
    result.link7_angular_velocity[2] = z93;
    result.tip_position[0] = z177;
    result.tip_position[1] = z180;
    result.tip_position[2] = z183;
    result.tip_velocity[0] = -z214;
    result.tip_velocity[1] = -z223;
    result.tip_velocity[2] = -z224;
    result.tip_jacobian[0] = -z194;
    result.tip_jacobian[3] = z207;
    result.tip_jacobian[6] = -z203;
    result.tip_jacobian[9] = z200;
    result.tip_jacobian[12] = -z195;
    result.tip_jacobian[15] = z187;
    result.tip_jacobian[18] = n0;
    result.tip_jacobian[1] = z193;
    result.tip_jacobian[4] = z208;
    result.tip_jacobian[7] = -z205;
    result.tip_jacobian[10] = z201;
    result.tip_jacobian[13] = -z196;
    result.tip_jacobian[16] = -z188;
    result.tip_jacobian[19] = n0;
    result.tip_jacobian[2] = n0;
    result.tip_jacobian[5] = -z198;
    result.tip_jacobian[8] = z204;
    result.tip_jacobian[11] = -z202;
    result.tip_jacobian[14] = -z197;
    result.tip_jacobian[17] = -z186;
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
    const Scalar z0 = k0 * s_q7 - k1 * c_q7;
    const Scalar z1 = k2 * s_q7 + k3 * c_q7;
    const Scalar z2 = k4 * s_q7 - k5 * c_q7;
    const Scalar z3 = k3 * s_q7 - k2 * c_q7;
    const Scalar z4 = k5 * s_q7 + k4 * c_q7;
    const Scalar z5 = k6 + n16_over_15 * z1;
    const Scalar z6 = c_q6 * z3;
    const Scalar z7 = s_q6 * z3;
    const Scalar z8 = s_q7 * z0;
    const Scalar z9 = k8 + c_q7 * z0;
    const Scalar z10 = k6 + n32_over_15 * z1;
    const Scalar z11 = k10 + z1;
    const Scalar z12 = k11 - z2;
    const Scalar z13 = k12 + z4;
    const Scalar z14 = s_q5 * z1 - c_q5 * z6;
    const Scalar z15 = c_q5 * z1 + s_q5 * z6;
    const Scalar z16 = k0 - z8;
    const Scalar z17 = n32_over_15 * z1 + z8;
    const Scalar z18 = s_q6 * z11 - k13 * c_q6;
    const Scalar z19 = k13 * s_q6 + c_q6 * z11;
    const Scalar z20 = c_q6 * z2 + s_q6 * z5;
    const Scalar z21 = n2 * z12;
    const Scalar z22 = s_q6 * z2 - c_q6 * z5;
    const Scalar z23 = n16_over_15 * z3 - z9;
    const Scalar z24 = k15 - z16;
    const Scalar z25 = s_q4 * z7 + c_q4 * z14;
    const Scalar z26 = s_q4 * z14 - c_q4 * z7;
    const Scalar z27 = k16 + z17;
    const Scalar z28 = s_q5 * z4 - c_q5 * z20;
    const Scalar z29 = c_q5 * z4 + s_q5 * z20;
    const Scalar z30 = z22 + z15;
    const Scalar z31 = k17 + z23;
    const Scalar z32 = z10 + z24;
    const Scalar z33 = c_q5 * z18;
    const Scalar z34 = s_q5 * z18;
    const Scalar z35 = s_q3 * z15 + c_q3 * z25;
    const Scalar z36 = s_q3 * z25 - c_q3 * z15;
    const Scalar z37 = s_q6 * z13 + c_q6 * z31;
    const Scalar z38 = s_q6 * z31 - c_q6 * z13;
    const Scalar z39 = n256_over_55 * z15 - z28;
    const Scalar z40 = k19 - z3;
    const Scalar z41 = k20 - z19;
    const Scalar z42 = z7 - n256_over_55 * z14 - z29;
    const Scalar z43 = s_q6 * z32 - c_q6 * z21;
    const Scalar z44 = s_q4 * z19 + c_q4 * z33;
    const Scalar z45 = s_q4 * z33 - c_q4 * z19;
    const Scalar z46 = z42 + z26;
    const Scalar z47 = s_q5 * z27 - c_q5 * z37;
    const Scalar z48 = c_q5 * z27 + s_q5 * z37;
    const Scalar z49 = k21 - z37;
    const Scalar z50 = s_q4 * z30 - c_q4 * z39;
    const Scalar z51 = c_q4 * z30 + s_q4 * z39;
    const Scalar z52 = k22 + z38;
    const Scalar z53 = z19 - n256_over_55 * z33 - z48;
    const Scalar z54 = z15 - z51;
    const Scalar z55 = c_q6 * z43 + z12;
    const Scalar z56 = z53 + z45;
    const Scalar z57 = s_q6 * z43;
    const Scalar z58 = z24 - z57;
    const Scalar z59 = z10 - z57;
    const Scalar z60 = k23 + z55;
    const Scalar z61 = s_q5 * z40 + c_q5 * z41;
    const Scalar z62 = s_q5 * z41 - c_q5 * z40;
    const Scalar z63 = k24 - z58;
    const Scalar z64 = k25 + z59;
    const Scalar z65 = s_q5 * z60 - c_q5 * z52;
    const Scalar z66 = s_q5 * z52 + c_q5 * z60;
    const Scalar z67 = z38 - z34;
    const Scalar z68 = n256_over_55 * z34 + z47;
    const Scalar z69 = s_q4 * z67 + c_q4 * z68;
    const Scalar z70 = s_q4 * z68 - c_q4 * z67;
    const Scalar z71 = s_q3 * z46 - c_q3 * z50;
    const Scalar z72 = n632_over_165 * z36 - z71;
    const Scalar z73 = n256_over_55 * z61 - z66;
    const Scalar z74 = c_q3 * z46 + s_q3 * z50;
    const Scalar z75 = n256_over_55 * z62 - z65;
    const Scalar z76 = z64 + z61;
    const Scalar z77 = n632_over_165 * z35 - z74;
    const Scalar z78 = c_q4 * z62;
    const Scalar z79 = c_q3 * z34 + s_q3 * z44;
    const Scalar z80 = s_q2 * z72 - c_q2 * z54;
    const Scalar z81 = n2 * z49;
    const Scalar z82 = z27 - z63;
    const Scalar z83 = c_q5 * z81 + s_q5 * z82;
    const Scalar z84 = z18 + n256_over_55 * z61 - z66;
    const Scalar z85 = z64 + n2 * z61;
    const Scalar z86 = k27 + z84;
    const Scalar z87 = k28 + z75;
    const Scalar z88 = z34 - z70;
    const Scalar z89 = s_q3 * z34 - c_q3 * z44;
    const Scalar z90 = s_q5 * z83;
    const Scalar z91 = c_q5 * z83 - z49;
    const Scalar z92 = k29 + z18;
    const Scalar z93 = k30 + z61;
    const Scalar z94 = z63 + z90;
    const Scalar z95 = z27 - z90;
    const Scalar z96 = z62 + z91;
    const Scalar z97 = s_q4 * z92 + c_q4 * z93;
    const Scalar z98 = s_q4 * z93 - c_q4 * z92;
    const Scalar z99 = n512_over_55 * z18 + z94;
    const Scalar z100 = z95 + n512_over_55 * z18 + n2 * z61;
    const Scalar z101 = k32 + z99;
    const Scalar z102 = k33 + z96;
    const Scalar z103 = s_q4 * z62;
    const Scalar z104 = z75 - z103;
    const Scalar z105 = s_q4 * z76 - c_q4 * z73;
    const Scalar z106 = c_q4 * z76 + s_q4 * z73;
    const Scalar z107 = k34 + z100;
    const Scalar z108 = s_q3 * z78 - c_q3 * z61;
    const Scalar z109 = z61 - z106;
    const Scalar z110 = s_q3 * z61 + c_q3 * z78;
    const Scalar z111 = c_q3 * z105 + s_q3 * z104;
    const Scalar z112 = n632_over_165 * z108 + z111;
    const Scalar z113 = s_q3 * z56 - c_q3 * z69;
    const Scalar z114 = c_q3 * z56 + s_q3 * z69;
    const Scalar z115 = s_q4 * z87 + c_q4 * z102;
    const Scalar z116 = n632_over_165 * z89 + z114;
    const Scalar z117 = s_q4 * z102 - c_q4 * z87;
    const Scalar z118 = n632_over_165 * z79 - z113;
    const Scalar z119 = z107 - z97;
    const Scalar z120 = s_q3 * z105 - c_q3 * z104;
    const Scalar z121 = c_q3 * z98;
    const Scalar z122 = c_q2 * z88 + s_q2 * z118;
    const Scalar z123 = z85 - z101;
    const Scalar z124 = n2 * z86;
    const Scalar z125 = s_q4 * z123 - c_q4 * z124;
    const Scalar z126 = z62 - z115;
    const Scalar z127 = k35 - z126;
    const Scalar z128 = z107 - n2 * z97;
    const Scalar z129 = k36 - z62;
    const Scalar z130 = k37 + z117;
    const Scalar z131 = k38 - z97;
    const Scalar z132 = n2 * z127;
    const Scalar z133 = n632_over_165 * z110 - z120;
    const Scalar z134 = s_q4 * z125;
    const Scalar z135 = c_q4 * z125 + z86;
    const Scalar z136 = s_q3 * z129 - c_q3 * z131;
    const Scalar z137 = z101 + z134;
    const Scalar z138 = z85 - z134;
    const Scalar z139 = z98 - z135;
    const Scalar z140 = c_q3 * z129 + s_q3 * z131;
    const Scalar z141 = k39 + z137;
    const Scalar z142 = n2 * z97 - z138;
    const Scalar z143 = k40 - z139;
    const Scalar z144 = s_q3 * z98;
    const Scalar z145 = c_q3 * z115 + s_q3 * z119;
    const Scalar z146 = z128 - z141;
    const Scalar z147 = s_q3 * z130 - c_q3 * z143;
    const Scalar z148 = s_q2 * z112 - c_q2 * z109;
    const Scalar z149 = c_q3 * z132 + s_q3 * z146;
    const Scalar z150 = n632_over_165 * z136 + z147;
    const Scalar z151 = s_q3 * z149;
    const Scalar z152 = k41 - z142;
    const Scalar z153 = c_q3 * z130 + s_q3 * z143;
    const Scalar z154 = k42 + z150;
    const Scalar z155 = z141 + z151;
    const Scalar z156 = n632_over_165 * z140 + z153;
    const Scalar z157 = z128 - z151;
    const Scalar z158 = n2 * z154;
    const Scalar z159 = c_q3 * z149 - z127;
    const Scalar z160 = k43 * z98 - z155;
    const Scalar z161 = k44 + z156;
    const Scalar z162 = s_q3 * z115 - c_q3 * z119;
    const Scalar z163 = n632_over_165 * z144 - z145;
    const Scalar z164 = k45 - z160;
    const Scalar z165 = k46 - z159;
    const Scalar z166 = k43 * z98 - z157;
    const Scalar z167 = n632_over_165 * z121 + z162;
    const Scalar z168 = z152 - z164;
    const Scalar z169 = c_q2 * z117 + s_q2 * z163;
    const Scalar z170 = s_q2 * z150 - c_q2 * z152;
    const Scalar z171 = c_q2 * z158 + s_q2 * z168;
    const Scalar z172 = k47 - z166;
    const Scalar z173 = c_q2 * z161 + s_q2 * z165;
    const Scalar z174 = s_q2 * z171;
    const Scalar z175 = z152 - z174;
    const Scalar z176 = k48 + z175;
    mass[0] = z176;
    mass[1] = -z173;
    mass[2] = -z170;
    mass[3] = z169;
    mass[4] = z148;
    mass[5] = -z122;
    mass[6] = z80;
    mass[7] = -z173;
    mass[8] = z172;
    mass[9] = -z156;
    mass[10] = z167;
    mass[11] = z133;
    mass[12] = z116;
    mass[13] = z77;
    mass[14] = -z170;
    mass[15] = -z156;
    mass[16] = z152;
    mass[17] = z117;
    mass[18] = -z109;
    mass[19] = -z88;
    mass[20] = -z54;
    mass[21] = z169;
    mass[22] = z167;
    mass[23] = z117;
    mass[24] = z107;
    mass[25] = -z75;
    mass[26] = -z53;
    mass[27] = z42;
    mass[28] = z148;
    mass[29] = z133;
    mass[30] = -z109;
    mass[31] = -z75;
    mass[32] = z64;
    mass[33] = -z38;
    mass[34] = z22;
    mass[35] = -z122;
    mass[36] = z116;
    mass[37] = -z88;
    mass[38] = -z53;
    mass[39] = -z38;
    mass[40] = z27;
    mass[41] = -z4;
    mass[42] = z80;
    mass[43] = z77;
    mass[44] = -z54;
    mass[45] = z42;
    mass[46] = z22;
    mass[47] = -z4;
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
    const Scalar z0 = v_q1 * c_q2;
    const Scalar z1 = v_q1 * s_q2;
    const Scalar z2 = v_q2 * v_q2;
    const Scalar z3 = k0 * s_q2;
    const Scalar z4 = k0 * c_q2;
    const Scalar z5 = v_q2 * s_q3 - c_q3 * z1;
    const Scalar z6 = v_q2 * c_q3 + s_q3 * z1;
    const Scalar z7 = v_q3 + z0;
    const Scalar z8 = v_q2 * z0;  // angular acceleration of link2, x
    const Scalar z9 = v_q2 * z1;  // angular acceleration of link2, y
    const Scalar z10 = z1 * z0;
    const Scalar z11 = z1 * z1;
    const Scalar z12 = z2 + z11;
    const Scalar z13 = n2 * z8;
    const Scalar z14 = c_q3 * z8;
    const Scalar z15 = s_q3 * z8;
    const Scalar z16 = z3 + n632_over_165 * z10;
    const Scalar z17 = z7 * z7;
    const Scalar z18 = s_q4 * z7 + c_q4 * z5;
    const Scalar z19 = s_q4 * z5 - c_q4 * z7;
    const Scalar z20 = v_q4 - z6;
    const Scalar z21 = z6 * z6;
    const Scalar z22 = z5 * z6;
    const Scalar z23 = z5 * z7;
    const Scalar z24 = z4 - n632_over_165 * z12;
    const Scalar z25 = n632_over_165 * z13;
    const Scalar z26 = v_q3 * z6 - z14;  // angular acceleration of link3, x
    const Scalar z27 = v_q3 * z5 - z15;  // angular acceleration of link3, y
    const Scalar z28 = z21 + z17;
    const Scalar z29 = z9 - z22;
    const Scalar z30 = z20 * z20;
    const Scalar z31 = s_q3 * z25 - c_q3 * z16;
    const Scalar z32 = s_q3 * z16 + c_q3 * z25;
    const Scalar z33 = s_q5 * z20 - c_q5 * z18;
    const Scalar z34 = c_q5 * z20 + s_q5 * z18;
    const Scalar z35 = z27 + z23;
    const Scalar z36 = s_q4 * z9 - c_q4 * z26;
    const Scalar z37 = c_q4 * z9 + s_q4 * z26;
    const Scalar z38 = z18 * z18;
    const Scalar z39 = z18 * z20;
    const Scalar z40 = v_q5 - z19;
    const Scalar z41 = z19 * z19;
    const Scalar z42 = z18 * z19;
    const Scalar z43 = z19 * z20;
    const Scalar z44 = z24 + z35;
    const Scalar z45 = z30 + z38;
    const Scalar z46 = s_q6 * z40 - c_q6 * z33;
    const Scalar z47 = s_q6 * z33 + c_q6 * z40;
    const Scalar z48 = v_q6 + z34;
    const Scalar z49 = z32 - z29;
    const Scalar z50 = v_q4 * z19 + z36;  // angular acceleration of link4, x
    const Scalar z51 = v_q4 * z18 + z37;  // angular acceleration of link4, y
    const Scalar z52 = z41 + z30;
    const Scalar z53 = z27 + z42;
    const Scalar z54 = z27 - z42;
    const Scalar z55 = z31 - z28;
    const Scalar z56 = z51 + z39;
    const Scalar z57 = z50 + z43;
    const Scalar z58 = s_q5 * z27 + c_q5 * z50;
    const Scalar z59 = s_q5 * z50 - c_q5 * z27;
    const Scalar z60 = s_q4 * z44 + c_q4 * z55;
    const Scalar z61 = s_q4 * z55 - c_q4 * z44;
    const Scalar z62 = s_q7 * z48 + c_q7 * z46;
    const Scalar z63 = s_q7 * z46 - c_q7 * z48;
    const Scalar z64 = v_q7 - z47;
    const Scalar z65 = z47 * z47;
    const Scalar z66 = z46 * z46;
    const Scalar z67 = v_q5 * z34 + z58;  // angular acceleration of link5, x
    const Scalar z68 = z52 - n256_over_55 * z53 + z60;
    const Scalar z69 = z49 + z56 + n256_over_55 * z57;
    const Scalar z70 = v_q5 * z33 + z59;  // angular acceleration of link5, y
    const Scalar z71 = s_q6 * z51 + c_q6 * z67;
    const Scalar z72 = n256_over_55 * z45 + z54 + z61;
    const Scalar z73 = v_q6 * z47 - z71;  // angular acceleration of link6, x
    const Scalar z74 = s_q6 * z67 - c_q6 * z51;
    const Scalar z75 = z63 * z63;
    const Scalar z76 = v_q6 * z46 - z74;  // angular acceleration of link6, y
    const Scalar z77 = z62 * z63;
    const Scalar z78 = z62 * z62;
    const Scalar z79 = z48 * z48;
    const Scalar z80 = c_q7 * z70 + s_q7 * z73;
    const Scalar z81 = z64 * z64;
    const Scalar z82 = c_q5 * z68 + s_q5 * z69;
    const Scalar z83 = s_q5 * z68 - c_q5 * z69;
    const Scalar z84 = v_q7 * z62 + z80;  // angular acceleration of link7, y
    const Scalar z85 = z62 * z64;
    const Scalar z86 = z63 * z64;
    const Scalar z87 = z65 - z66;
    const Scalar z88 = z46 * z47;
    const Scalar z89 = z46 * z48;
    const Scalar z90 = z47 * z48;
    const Scalar z91 = z75 - z78;
    const Scalar z92 = s_q7 * z70 - c_q7 * z73;
    const Scalar z93 = v_q7 * z63 + z92;  // angular acceleration of link7, x
    const Scalar z94 = z81 + z78;
    const Scalar z95 = z81 - z78;
    const Scalar z96 = z79 - z66;
    const Scalar z97 = z79 + z66;
    const Scalar z98 = z75 - z81;
    const Scalar z99 = z75 + z81;
    const Scalar z100 = c_q6 * z72 + s_q6 * z82;
    const Scalar z101 = z70 - z88;
    const Scalar z102 = z76 + z77;
    const Scalar z103 = k4 * z99 - k5 * z102;  // force on link7, times 0.0825 m, x
    const Scalar z104 = z76 - z77;
    const Scalar z105 = k5 * z94 + k4 * z104;  // force on link7, times 0.0825 m, y
    const Scalar z106 = z70 + z88;
    const Scalar z107 = s_q6 * z72 - c_q6 * z82;
    const Scalar z108 = z65 + z79;
    const Scalar z109 = z65 - z79;
    const Scalar z110 = z84 + z85;
    const Scalar z111 = z84 - z85;
    const Scalar z112 = z76 + z89;
    const Scalar z113 = z76 - z89;
    const Scalar z114 = z100 + n16_over_15 * z101;
    const Scalar z115 = z93 + z86;
    const Scalar z116 = z93 - z86;
    const Scalar z117 = k7 * z95 + k8 * z102 + k4 * z114 + k9 * z110 - k10 * z115;  // moment on link7, y
    const Scalar z118 = k8 * z98 + k7 * z104 + k5 * z114 - k10 * z110 + k11 * z115;  // moment on link7, x
    const Scalar z119 = k4 * z110 + k5 * z115;  // force on link7, times 0.0825 m, z
    const Scalar z120 = k12 * z101 + z119 - k13 * z97;  // force on link6, times 0.0825 m, y
    const Scalar z121 = z107 + n16_over_15 * z108;
    const Scalar z122 = z40 * z40;
    const Scalar z123 = z33 * z34;
    const Scalar z124 = z33 * z33;
    const Scalar z125 = z83 + n16_over_15 * z112;
    const Scalar z126 = z33 * z40;
    const Scalar z127 = z73 + z90;
    const Scalar z128 = z73 - z90;
    const Scalar z129 = z34 * z34;
    const Scalar z130 = s_q7 * z105 + c_q7 * z103;
    const Scalar z131 = s_q7 * z103 - c_q7 * z105;
    const Scalar z132 = k12 * z108 + z130 + k13 * z106;  // force on link6, times 0.0825 m, x
    const Scalar z133 = z51 + z123;
    const Scalar z134 = s_q7 * z121 + c_q7 * z125;
    const Scalar z135 = s_q7 * z125 - c_q7 * z121;
    // moment on link7, z
    const Scalar z136 = k14 * z77 + k10 * z91 + k15 * z76 + k7 * z116 + k8 * z111 + k4 * z134 + k5 * z135;
    // moment on link6, y
    const Scalar z137 = k16 * z96 + k17 * z106 + k12 * z83 - k18 * z127 + k19 * z112 - n16_over_15 * z131 + z136;
    const Scalar z138 = z34 * z40;
    const Scalar z139 = z50 - z43;
    const Scalar z140 = k12 * z112 - z131 - k13 * z127;  // force on link6, times 0.0825 m, z
    const Scalar z141 = z51 - z39;
    const Scalar z142 = z122 - z124;
    const Scalar z143 = z129 - z124;
    const Scalar z144 = z122 + z124;
    const Scalar z145 = z129 - z122;
    const Scalar z146 = z129 + z122;
    const Scalar z147 = z67 - z138;
    const Scalar z148 = z67 + z138;
    const Scalar z149 = z51 - z123;
    const Scalar z150 = z140 - k20 * z149 + k21 * z144;  // force on link5, times 0.0825 m, y
    const Scalar z151 = z41 - z38;
    const Scalar z152 = z30 - z38;
    const Scalar z153 = z41 - z30;
    const Scalar z154 = z70 - z126;
    const Scalar z155 = z70 + z126;
    const Scalar z156 = s_q7 * z117 - c_q7 * z118;
    const Scalar z157 = k13 * z83 - k17 * z109 - k16 * z101 - k22 * z127 + k18 * z112 - z156;  // moment on link6, x
    const Scalar z158 = s_q7 * z118 + c_q7 * z117;
    // moment on link6, z
    const Scalar z159 = k18 * z87 - k23 * z88 + k24 * z70 + k13 * z107 + k12 * z100 + k16 * z128 + k17 * z113
        + n16_over_15 * z119 + z158;
    const Scalar z160 = k25 * z142 + k26 * z133 + k20 * z72 - k27 * z148 - k28 * z155 - z159;  // moment on link5, y
    const Scalar z161 = z6 * z7;
    const Scalar z162 = z5 * z5;
    const Scalar z163 = z27 - z23;
    const Scalar z164 = s_q6 * z120 - c_q6 * z132;
    const Scalar z165 = z164 + k20 * z146 + k21 * z133;  // force on link5, times 0.0825 m, x
    const Scalar z166 = s_q6 * z132 + c_q6 * z120;
    const Scalar z167 = z166 - k20 * z155 + k21 * z148;  // force on link5, times 0.0825 m, z
    const Scalar z168 = s_q6 * z137 - c_q6 * z157;
    const Scalar z169 = k21 * z72 - k26 * z145 - k25 * z149 + k29 * z148 + k27 * z155 - z168;  // moment on link5, x
    const Scalar z170 = c_q6 * z137 + s_q6 * z157;
    // moment on link5, z
    const Scalar z171 = k30 * z123 + k31 * z51 - k27 * z143 - k25 * z147 - k26 * z154 + k21 * z82 - k20 * z83 + z170;
    const Scalar z172 = z167 + k32 * z45 + k33 * z54;  // force on link4, times 0.0825 m, y
    const Scalar z173 = z0 * z0;
    const Scalar z174 = z9 + z22;
    const Scalar z175 = s_q5 * z150 + c_q5 * z165;
    const Scalar z176 = s_q5 * z165 - c_q5 * z150;
    const Scalar z177 = k33 * z49 - k34 * z152 + k35 * z53 + k36 * z56 + k37 * z57 + z171 + z176;  // moment on link4, y
    const Scalar z178 = z175 + k33 * z52 - k32 * z53;  // force on link4, times 0.0825 m, x
    const Scalar z179 = z21 - z17;
    const Scalar z180 = z21 - z162;
    const Scalar z181 = z17 - z162;
    const Scalar z182 = z17 + z162;
    const Scalar z183 = s_q5 * z160 - c_q5 * z169;
    // moment on link4, x
    const Scalar z184 = k32 * z49 - k34 * z54 + k35 * z153 + k37 * z56 + k38 * z57 - z183 + n256_over_55 * z176;
    const Scalar z185 = z176 + k33 * z56 + k32 * z57;  // force on link4, times 0.0825 m, z
    const Scalar z186 = c_q5 * z160 + s_q5 * z169;
    // moment on link4, z
    const Scalar z187 = k39 * z27 + k40 * z42 - k37 * z151 - k34 * z139 + k35 * z141 - k32 * z60 + k33 * z61 + z167
        + z186 - n256_over_55 * z175;
    const Scalar z188 = k41 * z29 - z185 + k42 * z182;  // force on link3, times 0.0825 m, y
    const Scalar z189 = z26 - z161;
    const Scalar z190 = z26 + z161;
    const Scalar z191 = s_q4 * z177 - c_q4 * z184;
    const Scalar z192 = k42 * z24 + k43 * z29 - k44 * z179 + k45 * z35 + k46 * z190 + z191;  // moment on link3, x
    const Scalar z193 = c_q4 * z177 + s_q4 * z184;
    // moment on link3, z
    const Scalar z194 = k47 * z9 - k48 * z22 - k45 * z180 + k43 * z189 - k44 * z163 - k41 * z32 + k42 * z31 - z185
        + z193;
    const Scalar z195 = n2 * z9;
    const Scalar z196 = s_q4 * z172 + c_q4 * z178;
    const Scalar z197 = s_q4 * z178 - c_q4 * z172;
    // moment on link3, y
    const Scalar z198 = k41 * z24 - k44 * z174 + k43 * z181 + k49 * z35 + k45 * z190 + z187 + z197;
    const Scalar z199 = z2 - z173;
    const Scalar z200 = k41 * z28 - z196 - k42 * z174;  // force on link3, times 0.0825 m, x
    const Scalar z201 = c_q3 * z192 + s_q3 * z198;
    const Scalar z202 = c_q3 * z188 + s_q3 * z200;
    const Scalar z203 = z2 - z11;
    const Scalar z204 = z11 - z173;
    const Scalar z205 = s_q3 * z192 - c_q3 * z198;
    // moment on link2, x
    const Scalar z206 = k50 * z10 - k51 * z13 - k52 * z195 - k53 * z199 + z201 + n632_over_165 * z202;
    const Scalar z207 = s_q3 * z188 - c_q3 * z200;
    const Scalar z208 = k53 * z10 - k52 * z13 - k54 * z195 - k50 * z203 - z194;  // moment on link2, y
    // moment on link2, z
    const Scalar z209 = k55 * z3 - k56 * z4 + k57 * z10 + k52 * z204 - z205 - n632_over_165 * z207;
    const Scalar z210 = s_q2 * z206 - c_q2 * z208;
    forces.q1 = -z210;
    forces.q2 = -z209;
    forces.q3 = -z194;
    forces.q4 = z187;
    forces.q5 = -z171;
    forces.q6 = -z159;
    forces.q7 = z136;
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
    const Scalar z0 = v_q1 * c_q2;
    const Scalar z1 = v_q1 * s_q2;
    const Scalar z2 = v_q2 * v_q2;
    const Scalar z3 = k0 * s_q2;
    const Scalar z4 = k0 * c_q2;
    const Scalar z5 = v_q2 * s_q3 - c_q3 * z1;
    const Scalar z6 = v_q2 * c_q3 + s_q3 * z1;
    const Scalar z7 = v_q3 + z0;
    const Scalar z8 = v_q2 * z0;  // angular acceleration of link2, x
    const Scalar z9 = v_q2 * z1;  // angular acceleration of link2, y
    const Scalar z10 = z1 * z0;
    const Scalar z11 = z1 * z1;
    const Scalar z12 = z2 + z11;
    const Scalar z13 = z7 * z7;
    const Scalar z14 = s_q4 * z7 + c_q4 * z5;
    const Scalar z15 = s_q4 * z5 - c_q4 * z7;
    const Scalar z16 = v_q4 - z6;
    const Scalar z17 = z6 * z6;
    const Scalar z18 = z5 * z6;
    const Scalar z19 = z5 * z7;
    const Scalar z20 = z4 - n632_over_165 * z12;
    const Scalar z21 = z17 + z13;
    const Scalar z22 = z16 * z16;
    const Scalar z23 = s_q5 * z16 - c_q5 * z14;
    const Scalar z24 = c_q5 * z16 + s_q5 * z14;
    const Scalar z25 = z14 * z14;
    const Scalar z26 = z14 * z16;
    const Scalar z27 = v_q5 - z15;
    const Scalar z28 = z15 * z15;
    const Scalar z29 = z14 * z15;
    const Scalar z30 = z15 * z16;
    const Scalar z31 = z22 + z25;
    const Scalar z32 = s_q6 * z27 - c_q6 * z23;
    const Scalar z33 = s_q6 * z23 + c_q6 * z27;
    const Scalar z34 = v_q6 + z24;
    const Scalar z35 = z22 - z25;
    const Scalar z36 = z28 + z22;
    const Scalar z37 = z24 * z24;
    const Scalar z38 = z27 * z27;
    const Scalar z39 = z23 * z24;
    const Scalar z40 = z23 * z23;
    const Scalar z41 = z23 * z27;
    const Scalar z42 = z24 * z27;
    const Scalar z43 = z28 - z22;
    const Scalar z44 = z34 * z34;
    const Scalar z45 = z37 + z38;
    const Scalar z46 = z38 + z40;
    const Scalar z47 = z37 - z38;
    const Scalar z48 = z38 - z40;
    const Scalar z49 = z37 - z40;
    const Scalar z50 = s_q7 * z34 + c_q7 * z32;
    const Scalar z51 = z28 - z25;
    const Scalar z52 = s_q7 * z32 - c_q7 * z34;
    const Scalar z53 = z5 * z5;
    const Scalar z54 = v_q7 - z33;
    const Scalar z55 = z6 * z7;
    const Scalar z56 = a_q1 * s_q2;
    const Scalar z57 = v_q2 * z0 + z56;  // angular acceleration of link2, x
    const Scalar z58 = z0 * z0;
    const Scalar z59 = a_q1 * c_q2;
    const Scalar z60 = v_q2 * z1 - z59;  // angular acceleration of link2, y
    const Scalar z61 = a_q2 - z10;
    const Scalar z62 = z3 - n632_over_165 * z61;
    const Scalar z63 = a_q2 * s_q3 - c_q3 * z57;
    const Scalar z64 = z8 + z57;
    const Scalar z65 = a_q2 * c_q3 + s_q3 * z57;
    const Scalar z66 = v_q3 * z6 + z63;  // angular acceleration of link3, x
    const Scalar z67 = v_q3 * z5 - z65;  // angular acceleration of link3, y
    const Scalar z68 = n632_over_165 * z64;
    const Scalar z69 = s_q3 * z68 - c_q3 * z62;
    const Scalar z70 = s_q3 * z62 + c_q3 * z68;
    const Scalar z71 = z17 - z13;
    const Scalar z72 = z17 - z53;
    const Scalar z73 = z32 * z33;
    const Scalar z74 = z33 * z33;
    const Scalar z75 = a_q3 - z60;  // angular acceleration of link3, z
    const Scalar z76 = z18 + z75;
    const Scalar z77 = z32 * z32;
    const Scalar z78 = z32 * z34;
    const Scalar z79 = z33 * z34;
    const Scalar z80 = z54 * z54;
    const Scalar z81 = z50 * z50;
    const Scalar z82 = z74 - z77;
    const Scalar z83 = z74 + z44;
    const Scalar z84 = z74 - z44;
    const Scalar z85 = z19 + z67;
    const Scalar z86 = s_q4 * z75 + c_q4 * z66;
    const Scalar z87 = s_q4 * z66 - c_q4 * z75;
    const Scalar z88 = z52 * z52;
    const Scalar z89 = z21 - z69;
    const Scalar z90 = z70 + z76;
    const Scalar z91 = z50 * z52;
    const Scalar z92 = z80 + z81;
    const Scalar z93 = z80 - z81;
    const Scalar z94 = z88 - z81;
    const Scalar z95 = z88 + z80;
    const Scalar z96 = v_q4 * z15 - z86;  // angular acceleration of link4, x
    const Scalar z97 = z88 - z80;
    const Scalar z98 = z20 + z85;
    const Scalar z99 = s_q4 * z98 - c_q4 * z89;
    const Scalar z100 = c_q4 * z98 + s_q4 * z89;
    const Scalar z101 = z44 - z77;
    const Scalar z102 = z44 + z77;
    const Scalar z103 = z52 * z54;
    const Scalar z104 = z50 * z54;
    const Scalar z105 = v_q4 * z14 + z87;  // angular acceleration of link4, y
    const Scalar z106 = a_q4 + z67;  // angular acceleration of link4, z
    const Scalar z107 = z29 + z106;
    const Scalar z108 = s_q5 * z106 + c_q5 * z96;
    const Scalar z109 = z30 + z96;
    const Scalar z110 = a_q5 - z105;  // angular acceleration of link5, z
    const Scalar z111 = z29 - z106;
    const Scalar z112 = s_q5 * z96 - c_q5 * z106;
    const Scalar z113 = v_q5 * z23 + z112;  // angular acceleration of link5, y
    const Scalar z114 = z26 + z105;
    const Scalar z115 = z36 - n256_over_55 * z107 + z99;
    const Scalar z116 = v_q5 * z24 + z108;  // angular acceleration of link5, x
    const Scalar z117 = z90 + n256_over_55 * z109 + z114;
    const Scalar z118 = n256_over_55 * z31 - z111 - z100;
    const Scalar z119 = c_q6 * z110 + s_q6 * z116;
    const Scalar z120 = s_q6 * z110 - c_q6 * z116;
    const Scalar z121 = v_q6 * z32 - z119;  // angular acceleration of link6, y
    const Scalar z122 = v_q6 * z33 + z120;  // angular acceleration of link6, x
    const Scalar z123 = a_q6 - z113;  // angular acceleration of link6, z
    const Scalar z124 = c_q5 * z115 + s_q5 * z117;
    const Scalar z125 = s_q5 * z115 - c_q5 * z117;
    const Scalar z126 = c_q6 * z118 + s_q6 * z124;
    const Scalar z127 = z73 + z123;
    const Scalar z128 = s_q6 * z118 - c_q6 * z124;
    const Scalar z129 = s_q7 * z123 + c_q7 * z122;
    const Scalar z130 = z78 + z121;
    const Scalar z131 = z13 - z53;
    const Scalar z132 = z13 + z53;
    const Scalar z133 = z126 - n16_over_15 * z127;
    const Scalar z134 = s_q7 * z122 - c_q7 * z123;
    const Scalar z135 = n16_over_15 * z83 + z128;
    const Scalar z136 = z125 + n16_over_15 * z130;
    const Scalar z137 = s_q7 * z135 + c_q7 * z136;
    const Scalar z138 = s_q7 * z136 - c_q7 * z135;
    const Scalar z139 = z2 - z58;
    const Scalar z140 = v_q7 * z52 - z129;  // angular acceleration of link7, x
    const Scalar z141 = z2 - z11;
    const Scalar z142 = v_q7 * z50 + z134;  // angular acceleration of link7, y
    const Scalar z143 = z11 - z58;
    const Scalar z144 = z30 - z96;
    const Scalar z145 = z26 - z105;
    const Scalar z146 = z78 - z121;
    const Scalar z147 = a_q7 + z121;  // angular acceleration of link7, z
    const Scalar z148 = z91 - z147;
    const Scalar z149 = z91 + z147;
    const Scalar z150 = z19 - z67;
    const Scalar z151 = z103 + z140;
    const Scalar z152 = z103 - z140;
    const Scalar z153 = z73 - z123;
    const Scalar z154 = k4 * z92 - k5 * z148;  // force on link7, times 0.0825 m, y
    const Scalar z155 = k5 * z95 - k4 * z149;  // force on link7, times 0.0825 m, x
    const Scalar z156 = z104 + z142;
    const Scalar z157 = k6 * z93 + k5 * z133 + k7 * z149 + k8 * z156 - k9 * z151;  // moment on link7, y
    const Scalar z158 = k7 * z97 + k4 * z133 - k6 * z148 - k9 * z156 + k10 * z151;  // moment on link7, x
    const Scalar z159 = k4 * z151 + k5 * z156;  // force on link7, times 0.0825 m, z
    const Scalar z160 = z104 - z142;
    // moment on link7, z
    const Scalar z161 = k11 * z91 + k9 * z94 + k12 * z147 - k6 * z152 + k5 * z137 + k4 * z138 - k7 * z160;
    const Scalar z162 = k13 * z102 - z159 + k14 * z127;  // force on link6, times 0.0825 m, y
    const Scalar z163 = s_q7 * z154 + c_q7 * z155;
    const Scalar z164 = s_q7 * z155 - c_q7 * z154;
    const Scalar z165 = k14 * z83 + z163 + k13 * z153;  // force on link6, times 0.0825 m, x
    const Scalar z166 = z8 - z57;
    const Scalar z167 = z79 + z122;
    // moment on link6, y
    const Scalar z168 = k15 * z101 + k14 * z125 + k16 * z153 + k17 * z130 - k18 * z167 - n16_over_15 * z164 + z161;
    const Scalar z169 = z79 - z122;
    const Scalar z170 = k14 * z130 - z164 - k13 * z167;  // force on link6, times 0.0825 m, z
    const Scalar z171 = z39 - z110;
    const Scalar z172 = z42 - z116;
    const Scalar z173 = z42 + z116;
    const Scalar z174 = z39 + z110;
    const Scalar z175 = k19 * z46 + z170 + k20 * z174;  // force on link5, times 0.0825 m, y
    const Scalar z176 = z41 - z113;
    const Scalar z177 = z41 + z113;
    const Scalar z178 = s_q7 * z157 - c_q7 * z158;
    const Scalar z179 = k16 * z84 - k13 * z125 - k15 * z127 - k18 * z130 + k21 * z167 + z178;  // moment on link6, x
    const Scalar z180 = s_q7 * z158 + c_q7 * z157;
    // moment on link6, z
    const Scalar z181 = k22 * z73 - k18 * z82 + k23 * z123 - k13 * z128 - k14 * z126 + k15 * z169 + k16 * z146
        - n16_over_15 * z159 - z180;
    const Scalar z182 = k24 * z48 + k20 * z118 + k25 * z171 - k26 * z173 - k27 * z177 + z181;  // moment on link5, y
    const Scalar z183 = c_q6 * z165 + s_q6 * z162;
    const Scalar z184 = k20 * z45 - z183 + k19 * z171;  // force on link5, times 0.0825 m, x
    const Scalar z185 = s_q6 * z165 - c_q6 * z162;
    const Scalar z186 = z185 - k20 * z177 + k19 * z173;  // force on link5, times 0.0825 m, z
    const Scalar z187 = s_q6 * z168 + c_q6 * z179;
    const Scalar z188 = k25 * z47 - k19 * z118 - k24 * z174 - k28 * z173 - k26 * z177 + z187;  // moment on link5, x
    const Scalar z189 = s_q6 * z179 - c_q6 * z168;
    // moment on link5, z
    const Scalar z190 = k29 * z39 - k26 * z49 - k30 * z110 + k24 * z172 + k25 * z176 + k19 * z124 - k20 * z125 - z189;
    const Scalar z191 = z186 + k31 * z31 - k32 * z111;  // force on link4, times 0.0825 m, y
    const Scalar z192 = s_q5 * z175 + c_q5 * z184;
    const Scalar z193 = s_q5 * z184 - c_q5 * z175;
    // moment on link4, y
    const Scalar z194 = k33 * z35 - k32 * z90 - k34 * z107 - k35 * z114 - k36 * z109 - z190 - z193;
    const Scalar z195 = z192 + k32 * z36 - k31 * z107;  // force on link4, times 0.0825 m, x
    const Scalar z196 = z18 - z75;
    const Scalar z197 = s_q5 * z182 + c_q5 * z188;
    // moment on link4, x
    const Scalar z198 = k34 * z43 + k33 * z111 + k31 * z90 + k37 * z109 + k36 * z114 - z197 + n256_over_55 * z193;
    const Scalar z199 = z193 + k31 * z109 + k32 * z114;  // force on link4, times 0.0825 m, z
    const Scalar z200 = s_q5 * z188 - c_q5 * z182;
    // moment on link4, z
    const Scalar z201 = k38 * z29 + k39 * z106 - k36 * z51 + k33 * z144 - k31 * z99 - k32 * z100 - k34 * z145 + z186
        - n256_over_55 * z192 - z200;
    const Scalar z202 = k40 * z132 - z199 - k41 * z76;  // force on link3, times 0.0825 m, y
    const Scalar z203 = z55 - z66;
    const Scalar z204 = z55 + z66;
    const Scalar z205 = a_q2 + z10;
    const Scalar z206 = s_q4 * z194 + c_q4 * z198;
    const Scalar z207 = k40 * z20 - k42 * z71 - k43 * z76 + k44 * z85 + k45 * z204 - z206;  // moment on link3, x
    const Scalar z208 = s_q4 * z198 - c_q4 * z194;
    // moment on link3, z
    const Scalar z209 = k46 * z18 + k47 * z75 + k44 * z72 + k43 * z203 - k42 * z150 - k40 * z69 + k41 * z70 + z199
        - z208;
    const Scalar z210 = s_q4 * z191 + c_q4 * z195;
    const Scalar z211 = s_q4 * z195 - c_q4 * z191;
    // moment on link3, y
    const Scalar z212 = k41 * z20 + k43 * z131 - k42 * z196 + k48 * z85 + k44 * z204 + z201 + z211;
    const Scalar z213 = z9 + z60;
    const Scalar z214 = k41 * z21 - z210 - k40 * z196;  // force on link3, times 0.0825 m, x
    const Scalar z215 = c_q3 * z207 + s_q3 * z212;
    const Scalar z216 = c_q3 * z202 + s_q3 * z214;
    const Scalar z217 = k49 * z141 + k50 * z61 + k51 * z64 + k52 * z213 - z209;  // moment on link2, y
    const Scalar z218 = z9 - z60;
    // moment on link2, x
    const Scalar z219 = k50 * z139 - k49 * z205 + k53 * z64 + k51 * z213 - z215 - n632_over_165 * z216;
    const Scalar z220 = s_q3 * z207 - c_q3 * z212;
    const Scalar z221 = s_q3 * z202 - c_q3 * z214;
    const Scalar z222 = s_q2 * z219 - c_q2 * z217;
    // moment on link2, z
    const Scalar z223 = k54 * a_q2 - k55 * z3 + k56 * z4 - k57 * z10 - k51 * z143 + k49 * z166 - k50 * z218 + z220
        + n632_over_165 * z221;
    const Scalar z224 = k58 * a_q1 + z222;  // moment on link1, z
    forces.q1 = z224;
    forces.q2 = z223;
    forces.q3 = z209;
    forces.q4 = z201;
    forces.q5 = -z190;
    forces.q6 = z181;
    forces.q7 = z161;
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
    const Scalar z0 = k0 * s_q7 - k1 * c_q7;
    const Scalar z1 = v_q1 * s_q2;
    const Scalar z2 = v_q1 * c_q2;
    const Scalar z3 = k2 * s_q7 + k3 * c_q7;
    const Scalar z4 = k4 * s_q7 - k5 * c_q7;
    const Scalar z5 = k3 * s_q7 - k2 * c_q7;
    const Scalar z6 = k5 * s_q7 + k4 * c_q7;
    const Scalar z7 = v_q2 * s_q3 - c_q3 * z1;
    const Scalar z8 = v_q2 * c_q3 + s_q3 * z1;
    const Scalar z9 = v_q3 + z2;
    const Scalar z10 = s_q4 * z9 + c_q4 * z7;
    const Scalar z11 = s_q4 * z7 - c_q4 * z9;
    const Scalar z12 = v_q4 - z8;
    const Scalar z13 = k6 + n16_over_15 * z3;
    const Scalar z14 = c_q6 * z5;
    const Scalar z15 = s_q6 * z5;
    const Scalar z16 = s_q7 * z0;
    const Scalar z17 = k8 + c_q7 * z0;
    const Scalar z18 = k6 + n32_over_15 * z3;
    const Scalar z19 = k10 + z3;
    const Scalar z20 = k11 - z4;
    const Scalar z21 = k12 + z6;
    const Scalar z22 = s_q5 * z3 - c_q5 * z14;
    const Scalar z23 = c_q5 * z3 + s_q5 * z14;
    const Scalar z24 = k0 - z16;
    const Scalar z25 = n32_over_15 * z3 + z16;
    const Scalar z26 = s_q6 * z19 - k13 * c_q6;
    const Scalar z27 = k13 * s_q6 + c_q6 * z19;
    const Scalar z28 = c_q6 * z4 + s_q6 * z13;
    const Scalar z29 = s_q6 * z4 - c_q6 * z13;
    const Scalar z30 = n16_over_15 * z5 - z17;
    const Scalar z31 = s_q5 * z12 - c_q5 * z10;
    const Scalar z32 = c_q5 * z12 + s_q5 * z10;
    const Scalar z33 = k14 - z24;
    const Scalar z34 = v_q5 - z11;
    const Scalar z35 = s_q4 * z15 + c_q4 * z22;
    const Scalar z36 = s_q4 * z22 - c_q4 * z15;
    const Scalar z37 = k15 + z25;
    const Scalar z38 = s_q5 * z6 - c_q5 * z28;
    const Scalar z39 = c_q5 * z6 + s_q5 * z28;
    const Scalar z40 = z29 + z23;
    const Scalar z41 = k16 + z30;
    const Scalar z42 = s_q6 * z34 - c_q6 * z31;
    const Scalar z43 = s_q6 * z31 + c_q6 * z34;
    const Scalar z44 = v_q6 + z32;
    const Scalar z45 = c_q5 * z26;
    const Scalar z46 = s_q5 * z26;
    const Scalar z47 = s_q3 * z23 + c_q3 * z35;
    const Scalar z48 = s_q3 * z35 - c_q3 * z23;
    const Scalar z49 = s_q6 * z21 + c_q6 * z41;
    const Scalar z50 = s_q6 * z41 - c_q6 * z21;
    const Scalar z51 = z15 - n256_over_55 * z22 - z39;
    const Scalar z52 = n256_over_55 * z23 - z38;
    const Scalar z53 = z51 + z36;
    const Scalar z54 = c_q5 * z37 + s_q5 * z49;
    const Scalar z55 = s_q7 * z44 + c_q7 * z42;
    const Scalar z56 = z27 - n256_over_55 * z45 - z54;
    const Scalar z57 = s_q7 * z42 - c_q7 * z44;
    const Scalar z58 = v_q7 - z43;
    const Scalar z59 = k18 - z5;
    const Scalar z60 = z18 + z33;
    const Scalar z61 = n2 * z20;
    const Scalar z62 = s_q6 * z60 - c_q6 * z61;
    const Scalar z63 = k20 - z49;
    const Scalar z64 = s_q5 * z37 - c_q5 * z49;
    const Scalar z65 = n256_over_55 * z46 + z64;
    const Scalar z66 = k21 - z27;
    const Scalar z67 = z50 - z46;
    const Scalar z68 = c_q4 * z40 + s_q4 * z52;
    const Scalar z69 = z23 - z68;
    const Scalar z70 = s_q4 * z40 - c_q4 * z52;
    const Scalar z71 = c_q6 * z62 + z20;
    const Scalar z72 = s_q6 * z62;
    const Scalar z73 = z33 - z72;
    const Scalar z74 = z18 - z72;
    const Scalar z75 = k22 + z71;
    const Scalar z76 = k23 + z50;
    const Scalar z77 = s_q5 * z59 + c_q5 * z66;
    const Scalar z78 = s_q5 * z66 - c_q5 * z59;
    const Scalar z79 = k24 - z73;
    const Scalar z80 = k25 + z74;
    const Scalar z81 = s_q5 * z75 - c_q5 * z76;
    const Scalar z82 = s_q5 * z76 + c_q5 * z75;
    const Scalar z83 = s_q4 * z65 - c_q4 * z67;
    const Scalar z84 = s_q4 * z67 + c_q4 * z65;
    const Scalar z85 = z46 - z83;
    const Scalar z86 = s_q4 * z45 - c_q4 * z27;
    const Scalar z87 = s_q4 * z27 + c_q4 * z45;
    const Scalar z88 = z56 + z86;
    const Scalar z89 = c_q3 * z53 + s_q3 * z70;
    const Scalar z90 = n632_over_165 * z47 - z89;
    const Scalar z91 = s_q3 * z53 - c_q3 * z70;
    const Scalar z92 = n632_over_165 * z48 - z91;
    const Scalar z93 = n256_over_55 * z78 - z81;
    const Scalar z94 = z80 + z77;
    const Scalar z95 = n256_over_55 * z77 - z82;
    const Scalar z96 = c_q4 * z78;
    const Scalar z97 = s_q2 * z92 - c_q2 * z69;
    const Scalar z98 = z26 + n256_over_55 * z77 - z82;
    const Scalar z99 = k27 + z98;
    const Scalar z100 = n2 * z63;
    const Scalar z101 = z37 - z79;
    const Scalar z102 = c_q5 * z100 + s_q5 * z101;
    const Scalar z103 = z80 + n2 * z77;
    const Scalar z104 = k28 + z93;
    const Scalar z105 = k29 + z26;
    const Scalar z106 = k30 + z77;
    const Scalar z107 = c_q4 * z94 + s_q4 * z95;
    const Scalar z108 = s_q4 * z94 - c_q4 * z95;
    const Scalar z109 = c_q5 * z102 - z63;
    const Scalar z110 = s_q5 * z102;
    const Scalar z111 = z77 - z107;
    const Scalar z112 = s_q4 * z78;
    const Scalar z113 = z79 + z110;
    const Scalar z114 = z37 - z110;
    const Scalar z115 = z78 + z109;
    const Scalar z116 = z93 - z112;
    const Scalar z117 = s_q3 * z46 - c_q3 * z87;
    const Scalar z118 = c_q3 * z46 + s_q3 * z87;
    const Scalar z119 = n512_over_55 * z26 + z113;
    const Scalar z120 = z114 + n512_over_55 * z26 + n2 * z77;
    const Scalar z121 = k32 + z119;
    const Scalar z122 = k33 + z115;
    const Scalar z123 = s_q4 * z105 + c_q4 * z106;
    const Scalar z124 = s_q4 * z106 - c_q4 * z105;
    const Scalar z125 = k34 + z120;
    const Scalar z126 = c_q3 * z88 + s_q3 * z84;
    const Scalar z127 = n632_over_165 * z117 + z126;
    const Scalar z128 = s_q3 * z88 - c_q3 * z84;
    const Scalar z129 = n632_over_165 * z118 - z128;
    const Scalar z130 = s_q4 * z104 + c_q4 * z122;
    const Scalar z131 = s_q4 * z122 - c_q4 * z104;
    const Scalar z132 = c_q2 * z85 + s_q2 * z129;
    const Scalar z133 = z103 - z121;
    const Scalar z134 = n2 * z99;
    const Scalar z135 = s_q4 * z133 - c_q4 * z134;
    const Scalar z136 = z78 - z130;
    const Scalar z137 = k35 - z136;
    const Scalar z138 = k36 - z78;
    const Scalar z139 = z125 - n2 * z123;
    const Scalar z140 = k37 + z131;
    const Scalar z141 = k38 - z123;
    const Scalar z142 = z125 - z123;
    const Scalar z143 = s_q3 * z138 - c_q3 * z141;
    const Scalar z144 = c_q3 * z138 + s_q3 * z141;
    const Scalar z145 = c_q4 * z135 + z99;
    const Scalar z146 = s_q4 * z135;
    const Scalar z147 = z121 + z146;
    const Scalar z148 = z103 - z146;
    const Scalar z149 = z124 - z145;
    const Scalar z150 = s_q3 * z77 + c_q3 * z96;
    const Scalar z151 = n2 * z123 - z148;
    const Scalar z152 = s_q3 * z96 - c_q3 * z77;
    const Scalar z153 = k39 + z147;
    const Scalar z154 = k40 - z149;
    const Scalar z155 = s_q3 * z140 - c_q3 * z154;
    const Scalar z156 = c_q3 * z140 + s_q3 * z154;
    const Scalar z157 = k41 - z151;
    const Scalar z158 = s_q3 * z108 - c_q3 * z116;
    const Scalar z159 = n632_over_165 * z143 + z155;
    const Scalar z160 = n632_over_165 * z150 - z158;
    const Scalar z161 = n632_over_165 * z144 + z156;
    const Scalar z162 = c_q3 * z108 + s_q3 * z116;
    const Scalar z163 = n632_over_165 * z152 + z162;
    const Scalar z164 = n2 * z137;
    const Scalar z165 = z139 - z153;
    const Scalar z166 = c_q3 * z164 + s_q3 * z165;
    const Scalar z167 = c_q3 * z124;
    const Scalar z168 = s_q2 * z163 - c_q2 * z111;
    const Scalar z169 = v_q2 * z2;  // angular acceleration of link2, x
    const Scalar z170 = v_q2 * v_q2;
    const Scalar z171 = z1 * z1;
    const Scalar z172 = k42 * s_q2;
    const Scalar z173 = z1 * z2;
    const Scalar z174 = v_q2 * z1;  // angular acceleration of link2, y
    const Scalar z175 = c_q3 * z166 - z137;
    const Scalar z176 = s_q3 * z166;
    const Scalar z177 = k42 * c_q2;
    const Scalar z178 = z170 + z171;
    const Scalar z179 = s_q3 * z130 - c_q3 * z142;
    const Scalar z180 = n632_over_165 * z167 + z179;
    const Scalar z181 = c_q3 * z130 + s_q3 * z142;
    const Scalar z182 = z153 + z176;
    const Scalar z183 = z139 - z176;
    const Scalar z184 = k43 * z124 - z182;
    const Scalar z185 = k43 * z124 - z183;
    const Scalar z186 = s_q3 * z124;
    const Scalar z187 = n632_over_165 * z186 - z181;
    const Scalar z188 = z177 - n632_over_165 * z178;
    const Scalar z189 = k44 - z184;
    const Scalar z190 = k45 - z185;
    const Scalar z191 = k46 - z175;
    const Scalar z192 = c_q3 * z169;
    const Scalar z193 = z157 - z189;
    const Scalar z194 = c_q2 * z131 + s_q2 * z187;
    const Scalar z195 = v_q3 * z8 - z192;  // angular acceleration of link3, x
    const Scalar z196 = n2 * z169;
    const Scalar z197 = s_q3 * z169;
    const Scalar z198 = v_q3 * z7 - z197;  // angular acceleration of link3, y
    const Scalar z199 = n632_over_165 * z196;
    const Scalar z200 = z7 * z9;
    const Scalar z201 = z172 + n632_over_165 * z173;
    const Scalar z202 = z8 * z8;
    const Scalar z203 = z9 * z9;
    const Scalar z204 = z198 + z200;
    const Scalar z205 = s_q3 * z199 - c_q3 * z201;
    const Scalar z206 = s_q3 * z201 + c_q3 * z199;
    const Scalar z207 = z202 + z203;
    const Scalar z208 = z188 + z204;
    const Scalar z209 = z11 * z11;
    const Scalar z210 = z12 * z12;
    const Scalar z211 = z7 * z8;
    const Scalar z212 = z205 - z207;
    const Scalar z213 = z209 + z210;
    const Scalar z214 = z10 * z11;
    const Scalar z215 = z10 * z12;
    const Scalar z216 = z11 * z12;
    const Scalar z217 = z10 * z10;
    const Scalar z218 = s_q4 * z208 + c_q4 * z212;
    const Scalar z219 = s_q4 * z212 - c_q4 * z208;
    const Scalar z220 = z210 + z217;
    const Scalar z221 = z43 * z43;
    const Scalar z222 = z44 * z44;
    const Scalar z223 = k47 + z159;
    const Scalar z224 = n2 * z223;
    const Scalar z225 = s_q2 * z159 - c_q2 * z157;
    const Scalar z226 = z57 * z57;
    const Scalar z227 = z58 * z58;
    const Scalar z228 = c_q2 * z224 + s_q2 * z193;
    const Scalar z229 = z55 * z57;
    const Scalar z230 = z55 * z55;
    const Scalar z231 = z226 + z227;
    const Scalar z232 = z227 + z230;
    const Scalar z233 = z42 * z43;
    const Scalar z234 = z55 * z58;
    const Scalar z235 = z57 * z58;
    const Scalar z236 = z42 * z44;
    const Scalar z237 = z227 - z230;
    const Scalar z238 = z226 - z227;
    const Scalar z239 = z221 + z222;
    const Scalar z240 = s_q2 * z228;
    const Scalar z241 = k48 + z161;
    const Scalar z242 = z226 - z230;
    const Scalar z243 = c_q2 * z241 + s_q2 * z191;
    const Scalar z244 = z43 * z44;
    const Scalar z245 = z157 - z240;
    const Scalar z246 = z42 * z42;
    const Scalar z247 = z222 - z246;
    const Scalar z248 = z221 - z246;
    const Scalar z249 = z221 - z222;
    const Scalar z250 = z222 + z246;
    const Scalar z251 = k49 + z245;
    const Scalar z252 = z8 * z9;
    const Scalar z253 = z7 * z7;
    const Scalar z254 = z198 - z200;
    const Scalar z255 = z2 * z2;
    const Scalar z256 = c_q4 * z195;
    const Scalar z257 = v_q4 * z11 - z256;  // angular acceleration of link4, x
    const Scalar z258 = s_q4 * z195;
    const Scalar z259 = v_q4 * z10 + z258;  // angular acceleration of link4, y
    const Scalar z260 = z206 + z211;
    const Scalar z261 = z213 - n256_over_55 * z214 + z218;
    const Scalar z262 = c_q5 * z257;
    const Scalar z263 = z216 + z257;
    const Scalar z264 = z215 + z259;
    const Scalar z265 = n256_over_55 * z220 - z214 + z219;
    const Scalar z266 = v_q5 * z32 + z262;  // angular acceleration of link5, x
    const Scalar z267 = z260 + z264 + n256_over_55 * z263;
    const Scalar z268 = z34 * z34;
    const Scalar z269 = z31 * z32;
    const Scalar z270 = c_q6 * z266;
    const Scalar z271 = s_q6 * z266;
    const Scalar z272 = z31 * z31;
    const Scalar z273 = z32 * z32;
    const Scalar z274 = z32 * z34;
    const Scalar z275 = z31 * z34;
    const Scalar z276 = v_q6 * z43 - z270;  // angular acceleration of link6, x
    const Scalar z277 = v_q6 * z42 - z271;  // angular acceleration of link6, y
    const Scalar z278 = c_q5 * z261 + s_q5 * z267;
    const Scalar z279 = s_q5 * z261 - c_q5 * z267;
    const Scalar z280 = s_q7 * z276;
    const Scalar z281 = c_q7 * z276;
    const Scalar z282 = c_q6 * z265 + s_q6 * z278;
    const Scalar z283 = v_q7 * z55 + z280;  // angular acceleration of link7, y
    const Scalar z284 = v_q7 * z57 - z281;  // angular acceleration of link7, x
    const Scalar z285 = z236 + z277;
    const Scalar z286 = s_q6 * z265 - c_q6 * z278;
    const Scalar z287 = z234 + z283;
    const Scalar z288 = z235 + z284;
    const Scalar z289 = n16_over_15 * z233 - z282;
    const Scalar z290 = z279 + n16_over_15 * z285;
    const Scalar z291 = n16_over_15 * z239 + z286;
    const Scalar z292 = z268 - z272;
    const Scalar z293 = z273 - z272;
    const Scalar z294 = z268 + z272;
    const Scalar z295 = s_q5 * z257;
    const Scalar z296 = v_q5 * z31 + z295;  // angular acceleration of link5, y
    const Scalar z297 = s_q7 * z290 - c_q7 * z291;
    const Scalar z298 = c_q7 * z290 + s_q7 * z291;
    const Scalar z299 = z273 - z268;
    const Scalar z300 = z273 + z268;
    const Scalar z301 = z235 - z284;
    const Scalar z302 = z234 - z283;
    const Scalar z303 = k0 * z229 + k8 * z242 - k5 * z301 - k4 * z302 + k2 * z297 + k3 * z298;
    const Scalar z304 = k3 * z229 - k2 * z232;
    const Scalar z305 = k3 * z231 - k2 * z229;
    const Scalar z306 = k4 * z229 + k5 * z237 - k3 * z289 + k50 * z287 - k8 * z288;
    const Scalar z307 = k5 * z229 - k4 * z238 + k2 * z289 + k8 * z287 - k51 * z288;
    const Scalar z308 = k3 * z287 + k2 * z288;
    const Scalar z309 = z210 - z217;
    const Scalar z310 = z209 - z217;
    const Scalar z311 = z209 - z210;
    const Scalar z312 = k10 * z233 - z308 + k13 * z250;
    const Scalar z313 = z236 - z277;
    const Scalar z314 = z244 + z276;
    const Scalar z315 = z244 - z276;
    const Scalar z316 = z195 + z252;
    const Scalar z317 = z195 - z252;
    const Scalar z318 = z203 - z253;
    const Scalar z319 = z202 - z203;
    const Scalar z320 = z203 + z253;
    const Scalar z321 = z216 - z257;
    const Scalar z322 = z202 - z253;
    const Scalar z323 = z215 - z259;
    const Scalar z324 = z275 + z296;
    const Scalar z325 = z275 - z296;
    const Scalar z326 = z274 + z266;
    const Scalar z327 = z274 - z266;
    const Scalar z328 = k52 * z69;
    const Scalar z329 = k52 * z90;
    const Scalar z330 = n2 * z174;
    const Scalar z331 = k52 * z51;
    const Scalar z332 = z170 - z255;
    const Scalar z333 = z170 - z171;
    const Scalar z334 = z171 - z255;
    const Scalar z335 = z51 * z331 - z125;
    const Scalar z336 = z69 * z331 + z131;
    const Scalar z337 = z69 * z328 - z157;
    const Scalar z338 = z90 * z328 - z161;
    const Scalar z339 = z90 * z331 - z180;
    const Scalar z340 = z90 * z329 - z190;
    const Scalar z341 = z97 * z329 + z243;
    const Scalar z342 = z97 * z328 - z225;
    const Scalar z343 = z97 * z331 - z194;
    const Scalar z344 = k52 * z6;
    const Scalar z345 = z6 * z344 - z37;
    const Scalar z346 = z29 * z344 - z50;
    const Scalar z347 = z51 * z344 - z56;
    const Scalar z348 = z69 * z344 + z85;
    const Scalar z349 = n1 / z345;
    const Scalar z350 = z90 * z344 + z127;
    const Scalar z351 = z97 * z344 - z132;
    const Scalar z352 = k52 * z29;
    const Scalar z353 = z29 * z352 - z80;
    const Scalar z354 = z51 * z352 + z93;
    const Scalar z355 = z69 * z352 - z111;
    const Scalar z356 = z90 * z352 - z160;
    const Scalar z357 = z97 * z352 - z168;
    const Scalar z358 = k52 * z97;
    const Scalar z359 = z97 * z358 - z251;
    const Scalar z360 = u_tau7 - z303;
    const Scalar z361 = s_q7 * z304 - c_q7 * z305;
    const Scalar z362 = c_q7 * z304 + s_q7 * z305;
    const Scalar z363 = k13 * z233 - z361 + k10 * z239;  // force on link6, times 0.0825 m, x
    const Scalar z364 = z346 * z349;
    const Scalar z365 = z347 * z349;
    const Scalar z366 = z353 - z346 * z364;
    const Scalar z367 = z354 - z347 * z364;
    const Scalar z368 = z335 - z347 * z365;
    const Scalar z369 = z336 - z348 * z365;
    const Scalar z370 = n1 / z366;
    const Scalar z371 = z355 - z348 * z364;
    const Scalar z372 = z339 - z350 * z365;
    const Scalar z373 = z356 - z350 * z364;
    const Scalar z374 = z343 - z351 * z365;
    const Scalar z375 = z357 - z351 * z364;
    const Scalar z376 = s_q7 * z306 + c_q7 * z307;
    const Scalar z377 = s_q7 * z307 - c_q7 * z306;
    const Scalar z378 = z348 * z349;
    const Scalar z379 = z337 - z348 * z378;
    const Scalar z380 = z338 - z350 * z378;
    const Scalar z381 = z342 - z351 * z378;
    const Scalar z382 = z350 * z349;
    const Scalar z383 = z340 - z350 * z382;
    const Scalar z384 = z341 - z351 * z382;
    const Scalar z385 = z367 * z370;
    const Scalar z386 = z371 * z370;
    const Scalar z387 = z373 * z370;
    const Scalar z388 = z368 - z367 * z385;
    const Scalar z389 = z369 - z371 * z385;
    const Scalar z390 = z379 - z371 * z386;
    const Scalar z391 = z380 - z373 * z386;
    const Scalar z392 = n1 / z388;
    const Scalar z393 = z372 - z373 * z385;
    const Scalar z394 = z383 - z373 * z387;
    const Scalar z395 = z384 - z375 * z387;
    const Scalar z396 = z381 - z375 * z386;
    const Scalar z397 = z374 - z375 * z385;
    const Scalar z398 = z351 * z349;
    // moment on link6, z
    const Scalar z399 = k54 * z233 - k11 * z248 - k13 * z286 - k10 * z282 - n16_over_15 * z308 + k16 * z315 + k12 * z313
        + z377;
    // moment on link6, y
    const Scalar z400 = k12 * z233 + k16 * z247 + k10 * z279 + k55 * z285 - k11 * z314 - n16_over_15 * z362 + z303;
    const Scalar z401 = k16 * z233 - k12 * z249 + k13 * z279 + k11 * z285 - k56 * z314 - z376;  // moment on link6, x
    const Scalar z402 = k10 * z285 - z362 - k13 * z314;  // force on link6, times 0.0825 m, z
    const Scalar z403 = z359 - z351 * z398;
    const Scalar z404 = z402 + k21 * z269 + k18 * z294;  // force on link5, times 0.0825 m, y
    const Scalar z405 = k23 * z269 + k22 * z292 + k21 * z265 - k57 * z324 - k20 * z326 + z399;  // moment on link5, y
    const Scalar z406 = c_q6 * z363 + s_q6 * z312;
    const Scalar z407 = s_q6 * z363 - c_q6 * z312;
    const Scalar z408 = k18 * z269 - z406 + k21 * z300;  // force on link5, times 0.0825 m, x
    const Scalar z409 = k21 * z324 - z407 - k18 * z326;  // force on link5, times 0.0825 m, z
    const Scalar z410 = s_q6 * z400 - c_q6 * z401;
    const Scalar z411 = k22 * z269 - k23 * z299 + k18 * z265 + k20 * z324 + k58 * z326 - z410;  // moment on link5, x
    const Scalar z412 = c_q6 * z400 + s_q6 * z401;
    // moment on link5, z
    const Scalar z413 = k59 * z269 - k20 * z293 + k18 * z278 - k21 * z279 + k22 * z327 + k23 * z325 + z412;
    const Scalar z414 = z409 + k30 * z214 - k29 * z220;  // force on link4, times 0.0825 m, y
    const Scalar z415 = s_q5 * z404 + c_q5 * z408;
    const Scalar z416 = s_q5 * z408 - c_q5 * z404;
    const Scalar z417 = z415 + k30 * z213 - k29 * z214;  // force on link4, times 0.0825 m, x
    const Scalar z418 = s_q5 * z405 - c_q5 * z411;
    const Scalar z419 = c_q5 * z405 + s_q5 * z411;
    const Scalar z420 = z389 * z392;
    const Scalar z421 = z390 - z389 * z420;
    const Scalar z422 = z391 - z393 * z420;
    const Scalar z423 = z396 - z397 * z420;
    const Scalar z424 = z416 + k30 * z264 + k29 * z263;  // force on link4, times 0.0825 m, z
    const Scalar z425 = n1 / z421;
    const Scalar z426 = z393 * z392;
    const Scalar z427 = z394 - z393 * z426;
    const Scalar z428 = z395 - z397 * z426;
    const Scalar z429 = z375 * z370;
    // moment on link4, z
    const Scalar z430 = k29 * z218 - k30 * z219 - k60 * z214 + k27 * z310 - k33 * z321 + k28 * z323 + z409
        + n256_over_55 * z415 - z419;
    // moment on link4, x
    const Scalar z431 = k33 * z214 + k28 * z311 + k29 * z260 + k27 * z264 + k61 * z263 - z418 + n256_over_55 * z416;
    // moment on link4, y
    const Scalar z432 = k28 * z214 - k33 * z309 + k30 * z260 + k62 * z264 + k27 * z263 + z413 + z416;
    const Scalar z433 = z403 - z375 * z429;
    const Scalar z434 = z424 + k38 * z211 - k36 * z320;  // force on link3, times 0.0825 m, y
    const Scalar z435 = s_q4 * z414 - c_q4 * z417;
    const Scalar z436 = c_q4 * z414 + s_q4 * z417;
    // moment on link3, y
    const Scalar z437 = k38 * z188 - k37 * z211 + k63 * z204 + k35 * z316 + k40 * z318 - z430 + z436;
    const Scalar z438 = z435 + k38 * z207 - k36 * z211;  // force on link3, times 0.0825 m, x
    const Scalar z439 = s_q4 * z432 - c_q4 * z431;
    const Scalar z440 = k36 * z188 - k40 * z211 + k35 * z204 + k64 * z316 - k37 * z319 + z439;  // moment on link3, x
    const Scalar z441 = c_q4 * z432 + s_q4 * z431;
    // moment on link3, z
    const Scalar z442 = k36 * z205 - k38 * z206 - k65 * z211 + k40 * z317 - k37 * z254 - k35 * z322 - z424 + z441;
    const Scalar z443 = s_q3 * z437 + c_q3 * z440;
    const Scalar z444 = s_q3 * z438 - c_q3 * z434;
    const Scalar z445 = s_q3 * z434 + c_q3 * z438;
    const Scalar z446 = z422 * z425;
    const Scalar z447 = z427 - z422 * z446;
    const Scalar z448 = z428 - z423 * z446;
    const Scalar z449 = z397 * z392;
    // moment on link2, x
    const Scalar z450 = k46 * z173 - k66 * z196 - k47 * z330 - k48 * z332 + z443 + n632_over_165 * z444;
    const Scalar z451 = k48 * z173 - k47 * z196 - k67 * z330 - k46 * z333 - z442;  // moment on link2, y
    const Scalar z452 = z433 - z397 * z449;
    const Scalar z453 = s_q2 * z450 - c_q2 * z451;
    const Scalar z454 = s_q3 * z440 - c_q3 * z437;
    // moment on link2, z
    const Scalar z455 = k68 * z172 - k69 * z177 + k70 * z173 + k47 * z334 - z454 + n632_over_165 * z445;
    const Scalar z456 = u_tau4 + z430;
    const Scalar z457 = u_tau5 + z413;
    const Scalar z458 = u_tau1 + z453;
    const Scalar z459 = n1 / z447;
    const Scalar z460 = u_tau3 + z442;
    const Scalar z461 = u_tau2 + z455;
    const Scalar z462 = z423 * z425;
    const Scalar z463 = z452 - z423 * z462;
    const Scalar z464 = u_tau6 - z399;
    const Scalar z465 = z360 * z344 + z464;
    const Scalar z466 = z448 * z459;
    const Scalar z467 = z463 - z448 * z466;
    const Scalar z468 = z360 * z352 - z457 - z364 * z465;
    const Scalar z469 = n1 / z467;
    const Scalar z470 = z360 * z331 - z456 - z365 * z465 - z385 * z468;
    const Scalar z471 = z360 * z328 - z378 * z465 - z386 * z468 + z460 - z420 * z470;
    const Scalar z472 = z360 * z329 - z382 * z465 - z387 * z468 - z426 * z470 - z461 - z446 * z471;
    const Scalar z473 = z360 * z358 - z458 - z398 * z465 - z429 * z468 - z449 * z470 - z462 * z471 - z466 * z472;
    const Scalar z474 = z469 * z473;
    const Scalar z475 = z459 * z472 - z466 * z474;
    const Scalar z476 = z425 * z471 - z462 * z474 - z446 * z475;
    const Scalar z477 = z392 * z470 - z449 * z474 - z426 * z475 - z420 * z476;
    const Scalar z478 = z174 - z476;
    const Scalar z479 = z370 * z468 - z429 * z474 - z387 * z475 - z386 * z476 - z385 * z477;
    const Scalar z480 = z198 - z477;
    const Scalar z481 = z349 * z465 - z398 * z474 - z382 * z475 - z378 * z476 - z365 * z477 - z364 * z479;
    const Scalar z482 = z259 + z479;
    const Scalar z483 = k52 * z360 - z358 * z474 - z329 * z475 - z328 * z476 - z331 * z477 - z352 * z479 - z344 * z481;
    const Scalar z484 = z296 - z481;
    const Scalar z485 = z277 - z483;
    accelerations.q1 = z474;
    accelerations.q2 = z475;
    accelerations.q3 = z478;
    accelerations.q4 = -z480;
    accelerations.q5 = z482;
    accelerations.q6 = z484;
    accelerations.q7 = -z485;
    if (!(traits::regular(-z467, z251) && traits::regular(-z447, z190) && traits::regular(-z421, z157)
        && traits::regular(-z388, z125) && traits::regular(-z366, z80) && traits::regular(-z345,
        z37))) return torsor::Status::singular;
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
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = v_q1 * c_q2;
    const Scalar z2 = n0_316 * v_q2;
    const Scalar z3 = n0_316 * c_q2;
    const Scalar z4 = n0_333 + z3;  // place of link3, z
    const Scalar z5 = n0_316 * z0;
    const Scalar z6 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z7 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z8 = v_q3 + z1;
    const Scalar z9 = k2 * v_q2 - k3 * z0 + k4 * z1;
    const Scalar z10 = k5 * v_q2 + k4 * z0 - k6 * z1;
    const Scalar z11 = k7 * v_q2 - k2 * z0 - k5 * z1;
    const Scalar z12 = c_q3 * z2 + s_q3 * z5;
    const Scalar z13 = s_q3 * z2 - c_q3 * z5;
    const Scalar z14 = n0_0825 * z7;
    const Scalar z15 = s_q4 * z8 + c_q4 * z6;
    const Scalar z16 = k9 * s_q2 + k10 * c_q2;
    const Scalar z17 = s_q4 * z6 - c_q4 * z8;
    const Scalar z18 = k11 * s_q3 - k12 * c_q3;
    const Scalar z19 = v_q4 - z7;
    const Scalar z20 = s_q2 * z18 - k13 * c_q2;
    const Scalar z21 = n0_0825 * z8 - z13;
    const Scalar z22 = s_q4 * z14 - c_q4 * z12;
    const Scalar z23 = s_q4 * z12 + c_q4 * z14;
    const Scalar z24 = k11 * z8 + k13 * z7 - k14 * z12;
    const Scalar z25 = k12 * z8 + k13 * z6 - k14 * z13;
    const Scalar z26 = k15 * z6 - k16 * z7 - k17 * z8 - k13 * z13;
    const Scalar z27 = k18 * z8 + k16 * z6 - k19 * z7 + k13 * z12;
    const Scalar z28 = k17 * z6 + k18 * z7 - k20 * z8 + k11 * z12 + k12 * z13;
    const Scalar z29 = v_q5 - z17;
    const Scalar z30 = c_q5 * z19 + s_q5 * z15;
    const Scalar z31 = s_q5 * z19 - c_q5 * z15;
    const Scalar z32 = v_q6 + z30;
    const Scalar z33 = n0_384 * z19 + z22;
    const Scalar z34 = s_q6 * z29 - c_q6 * z31;
    const Scalar z35 = n0_384 * z15 - z21 - n0_0825 * z17;
    const Scalar z36 = s_q6 * z31 + c_q6 * z29;
    const Scalar z37 = s_q7 * z32 + c_q7 * z34;
    const Scalar z38 = n0_0825 * z19 + z23;
    const Scalar z39 = c_q5 * z33 + s_q5 * z35;
    const Scalar z40 = s_q5 * z33 - c_q5 * z35;
    const Scalar z41 = s_q7 * z34 - c_q7 * z32;
    const Scalar z42 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z43 = n0_088 * z36 + z40;
    const Scalar z44 = k23 * z19 + k24 * z17 + k25 * z22;
    const Scalar z45 = k26 * z19 + k24 * z15 + k25 * z23;
    const Scalar z46 = k23 * z15 - k26 * z17 - k25 * z21;
    const Scalar z47 = k27 * z19 + k28 * z15 - k29 * z17 - k23 * z21 + k24 * z23;
    const Scalar z48 = k29 * z15 - k30 * z17 - k31 * z19 - k26 * z21 - k24 * z22;
    const Scalar z49 = v_q7 - z36;
    const Scalar z50 = k32 * z19 + k27 * z15 + k31 * z17 + k23 * z22 + k26 * z23;
    const Scalar z51 = n0_0825 - z42;
    const Scalar z52 = s_q6 * z38 + c_q6 * z39;
    const Scalar z53 = s_q6 * z39 - c_q6 * z38;
    const Scalar z54 = k33 * s_q6 + k34 * c_q6;
    const Scalar z55 = k35 * s_q5 + k36 * c_q5;
    const Scalar z56 = k36 * s_q5 - k35 * c_q5;
    const Scalar z57 = c_q3 * z51;
    const Scalar z58 = k37 * z30 - k35 * z29 - k38 * z39;
    const Scalar z59 = k37 * z31 + k36 * z29 - k38 * z40;
    const Scalar z60 = k35 * z31 + k36 * z30 + k38 * z38;
    const Scalar z61 = k39 * z31 - k40 * z30 + k41 * z29 + k35 * z38 - k37 * z40;
    const Scalar z62 = k40 * z31 - k42 * z30 + k43 * z29 - k36 * z38 + k37 * z39;
    const Scalar z63 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z64 = k41 * z31 - k43 * z30 + k44 * z29 + k35 * z39 - k36 * z40;
    const Scalar z65 = n0_088 * z32 + z53;
    const Scalar z66 = k34 * s_q6 - k33 * c_q6;
    const Scalar z67 = k45 * s_q5 - c_q5 * z54;
    const Scalar z68 = s_q7 * z43 + c_q7 * z52;
    const Scalar z69 = k45 * c_q5 + s_q5 * z54;
    const Scalar z70 = n0_316 - z63;
    const Scalar z71 = s_q2 * z57 - c_q2 * z70;
    const Scalar z72 = k23 * s_q4 + k26 * c_q4;
    const Scalar z73 = s_q7 * z52 - c_q7 * z43;
    const Scalar z74 = n0_333 - z71;
    const Scalar z75 = n0_088 * c_q6;
    const Scalar z76 = k24 * s_q3 - c_q3 * z72;
    const Scalar z77 = k45 * z36 - k33 * z32 + k46 * z52;
    const Scalar z78 = k45 * z34 + k34 * z32 + k46 * z53;
    const Scalar z79 = k33 * z34 + k34 * z36 + k46 * z40;
    const Scalar z80 = k47 * z34 + k48 * z36 - k49 * z32 + k33 * z40 + k45 * z53;
    const Scalar z81 = k50 * z32 + k48 * z34 + k51 * z36 + k34 * z40 + k45 * z52;
    const Scalar z82 = n0_088 * s_q6;
    const Scalar z83 = k49 * z34 - k50 * z36 - k52 * z32 + k33 * z52 - k34 * z53;
    const Scalar z84 = c_q5 * z75;
    const Scalar z85 = k53 * s_q7 + k54 * c_q7;
    const Scalar z86 = n0_384 + z82;
    const Scalar z87 = n0_0825 - z84;
    const Scalar z88 = k54 * s_q7 - k53 * c_q7;
    const Scalar z89 = k55 * s_q6 + c_q6 * z85;
    const Scalar z90 = s_q6 * z85 - k55 * c_q6;
    const Scalar z91 = s_q5 * z75;
    const Scalar z92 = s_q4 * z86 + c_q4 * z87;
    const Scalar z93 = s_q4 * z87 - c_q4 * z86;
    const Scalar z94 = s_q5 * z88 + c_q5 * z89;
    const Scalar z95 = s_q5 * z89 - c_q5 * z88;
    const Scalar z96 = s_q4 * z66 + c_q4 * z67;
    const Scalar z97 = s_q3 * z69 + c_q3 * z96;
    const Scalar z98 = n0_0825 - z92;
    const Scalar z99 = n0_316 - z93;
    const Scalar z100 = k37 * s_q4 - c_q4 * z55;
    const Scalar z101 = s_q3 * z91 - c_q3 * z98;
    const Scalar z102 = s_q4 * z90 - c_q4 * z94;
    const Scalar z103 = c_q4 * z90 + s_q4 * z94;
    const Scalar z104 = n0_0825 * c_q3;
    const Scalar z105 = s_q3 * z56 + c_q3 * z100;
    const Scalar z106 = k26 * s_q4 - k23 * c_q4;
    const Scalar z107 = c_q2 * z106 + s_q2 * z76;
    const Scalar z108 = k37 * c_q4 + s_q4 * z55;
    const Scalar z109 = s_q4 * z67 - c_q4 * z66;
    const Scalar z110 = s_q3 * z95 + c_q3 * z102;
    const Scalar z111 = s_q2 * z104 - z3;
    const Scalar z112 = c_q2 * z99 + s_q2 * z101;
    const Scalar z113 = k55 * z41 - k53 * z49 + k56 * z68;
    const Scalar z114 = k55 * z37 - k54 * z49 - k56 * z73;
    const Scalar z115 = k53 * z37 - k54 * z41 + k56 * z65;
    const Scalar z116 = k57 * z37 + k58 * z41 - k59 * z49 + k53 * z65 - k55 * z73;
    const Scalar z117 = k58 * z37 + k60 * z41 + k61 * z49 - k54 * z65 + k55 * z68;
    const Scalar z118 = k59 * z37 - k61 * z41 - k62 * z49 + k53 * z68 - k54 * z73;
    const Scalar z119 = n0_333 - z111;
    const Scalar z120 = c_q2 * z108 + s_q2 * z105;
    const Scalar z121 = s_q2 * z97 - c_q2 * z109;
    const Scalar z122 = n0_333 + z112;
    const Scalar z123 = c_q2 * z103 + s_q2 * z110;
    result.kinetic = k63 * v_q1 * v_q1 + n0_5 * (v_q2 * z11 - z0 * z9 - z1 * z10 - z12 * z24 - z13 * z25 - z7 * z27
        + z23 * z45 + z6 * z26 + z22 * z44 - z21 * z46 - z8 * z28 + z38 * z60 + z15 * z47 + z19 * z50 - z17 * z48 - z39
        * z58 + z31 * z61 - z30 * z62 + z29 * z64 + z52 * z77 - z40 * (z59 - z79) + z53 * z78 + z36 * z81 + z34 * z80
        - z32 * z83 + z65 * z115 + z68 * z113 - z73 * z114 + z37 * z116 + z41 * z117 - z49 * z118);
    result.force_function = -k65 - k66 * z4 - k67 * z119 - k68 * z74 - k69 * z122 - n9_81 * (z16 + z20 - z107 - z120
        + z121 + z123);
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
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = v_q1 * c_q2;
    const Scalar z2 = k0 * s_q7 - k1 * c_q7;
    const Scalar z3 = k2 * s_q7 + k3 * c_q7;
    const Scalar z4 = k4 * s_q7 - k5 * c_q7;
    const Scalar z5 = k3 * s_q7 - k2 * c_q7;
    const Scalar z6 = k5 * s_q7 + k4 * c_q7;
    const Scalar z7 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z8 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z9 = v_q3 + z1;
    const Scalar z10 = s_q4 * z9 + c_q4 * z7;
    const Scalar z11 = s_q4 * z7 - c_q4 * z9;
    const Scalar z12 = v_q4 - z8;
    const Scalar z13 = k6 + n16_over_15 * z3;
    const Scalar z14 = c_q6 * z5;
    const Scalar z15 = s_q6 * z5;
    const Scalar z16 = s_q7 * z2;
    const Scalar z17 = k8 + c_q7 * z2;
    const Scalar z18 = k6 + n32_over_15 * z3;
    const Scalar z19 = k10 + z3;
    const Scalar z20 = k11 - z4;
    const Scalar z21 = k12 + z6;
    const Scalar z22 = s_q5 * z3 - c_q5 * z14;
    const Scalar z23 = c_q5 * z3 + s_q5 * z14;
    const Scalar z24 = k0 - z16;
    const Scalar z25 = n32_over_15 * z3 + z16;
    const Scalar z26 = s_q6 * z19 - k13 * c_q6;
    const Scalar z27 = k13 * s_q6 + c_q6 * z19;
    const Scalar z28 = c_q6 * z4 + s_q6 * z13;
    const Scalar z29 = s_q6 * z4 - c_q6 * z13;
    const Scalar z30 = n16_over_15 * z5 - z17;
    const Scalar z31 = s_q5 * z12 - c_q5 * z10;
    const Scalar z32 = c_q5 * z12 + s_q5 * z10;
    const Scalar z33 = k14 - z24;
    const Scalar z34 = v_q5 - z11;
    const Scalar z35 = s_q4 * z15 + c_q4 * z22;
    const Scalar z36 = s_q4 * z22 - c_q4 * z15;
    const Scalar z37 = k15 + z25;
    const Scalar z38 = s_q5 * z6 - c_q5 * z28;
    const Scalar z39 = c_q5 * z6 + s_q5 * z28;
    const Scalar z40 = z29 + z23;
    const Scalar z41 = k16 + z30;
    const Scalar z42 = s_q6 * z34 - c_q6 * z31;
    const Scalar z43 = s_q6 * z31 + c_q6 * z34;
    const Scalar z44 = v_q6 + z32;
    const Scalar z45 = c_q5 * z26;
    const Scalar z46 = s_q5 * z26;
    const Scalar z47 = s_q3 * z23 + c_q3 * z35;
    const Scalar z48 = s_q3 * z35 - c_q3 * z23;
    const Scalar z49 = s_q6 * z21 + c_q6 * z41;
    const Scalar z50 = s_q6 * z41 - c_q6 * z21;
    const Scalar z51 = z15 - n256_over_55 * z22 - z39;
    const Scalar z52 = n256_over_55 * z23 - z38;
    const Scalar z53 = c_q5 * z37 + s_q5 * z49;
    const Scalar z54 = s_q7 * z44 + c_q7 * z42;
    const Scalar z55 = v_q7 - z43;
    const Scalar z56 = z27 - n256_over_55 * z45 - z53;
    const Scalar z57 = s_q7 * z42 - c_q7 * z44;
    const Scalar z58 = z18 + z33;
    const Scalar z59 = n2 * z20;
    const Scalar z60 = s_q6 * z58 - c_q6 * z59;
    const Scalar z61 = k19 - z49;
    const Scalar z62 = k20 - z5;
    const Scalar z63 = k21 - z27;
    const Scalar z64 = s_q5 * z37 - c_q5 * z49;
    const Scalar z65 = n256_over_55 * z46 + z64;
    const Scalar z66 = z50 - z46;
    const Scalar z67 = c_q4 * z40 + s_q4 * z52;
    const Scalar z68 = z23 - z67;
    const Scalar z69 = s_q6 * z60;
    const Scalar z70 = c_q6 * z60 + z20;
    const Scalar z71 = z33 - z69;
    const Scalar z72 = z18 - z69;
    const Scalar z73 = k22 + z70;
    const Scalar z74 = s_q4 * z65 - c_q4 * z66;
    const Scalar z75 = k23 - z71;
    const Scalar z76 = z51 + z36;
    const Scalar z77 = s_q4 * z45 - c_q4 * z27;
    const Scalar z78 = s_q4 * z40 - c_q4 * z52;
    const Scalar z79 = k24 + z72;
    const Scalar z80 = z46 - z74;
    const Scalar z81 = k25 + z50;
    const Scalar z82 = s_q5 * z62 + c_q5 * z63;
    const Scalar z83 = s_q5 * z63 - c_q5 * z62;
    const Scalar z84 = s_q5 * z73 - c_q5 * z81;
    const Scalar z85 = s_q5 * z81 + c_q5 * z73;
    const Scalar z86 = z56 + z77;
    const Scalar z87 = s_q3 * z76 - c_q3 * z78;
    const Scalar z88 = n632_over_165 * z48 - z87;
    const Scalar z89 = n256_over_55 * z82 - z85;
    const Scalar z90 = s_q4 * z27 + c_q4 * z45;
    const Scalar z91 = s_q4 * z66 + c_q4 * z65;
    const Scalar z92 = c_q3 * z76 + s_q3 * z78;
    const Scalar z93 = n256_over_55 * z83 - z84;
    const Scalar z94 = n632_over_165 * z47 - z92;
    const Scalar z95 = z79 + z82;
    const Scalar z96 = c_q4 * z83;
    const Scalar z97 = s_q3 * z46 - c_q3 * z90;
    const Scalar z98 = c_q3 * z86 + s_q3 * z91;
    const Scalar z99 = n632_over_165 * z97 + z98;
    const Scalar z100 = c_q3 * z46 + s_q3 * z90;
    const Scalar z101 = s_q3 * z86 - c_q3 * z91;
    const Scalar z102 = n632_over_165 * z100 - z101;
    const Scalar z103 = s_q2 * z88 - c_q2 * z68;
    const Scalar z104 = z26 + n256_over_55 * z82 - z85;
    const Scalar z105 = k27 + z104;
    const Scalar z106 = n2 * z61;
    const Scalar z107 = z37 - z75;
    const Scalar z108 = c_q5 * z106 + s_q5 * z107;
    const Scalar z109 = z79 + n2 * z82;
    const Scalar z110 = k28 + z93;
    const Scalar z111 = k29 + z26;
    const Scalar z112 = k30 + z82;
    const Scalar z113 = s_q4 * z111 + c_q4 * z112;
    const Scalar z114 = c_q4 * z95 + s_q4 * z89;
    const Scalar z115 = z82 - z114;
    const Scalar z116 = s_q5 * z108;
    const Scalar z117 = c_q5 * z108 - z61;
    const Scalar z118 = s_q4 * z112 - c_q4 * z111;
    const Scalar z119 = z83 + z117;
    const Scalar z120 = z75 + z116;
    const Scalar z121 = z37 - z116;
    const Scalar z122 = s_q4 * z83;
    const Scalar z123 = n512_over_55 * z26 + z120;
    const Scalar z124 = z121 + n512_over_55 * z26 + n2 * z82;
    const Scalar z125 = k32 + z119;
    const Scalar z126 = s_q4 * z95 - c_q4 * z89;
    const Scalar z127 = k33 + z123;
    const Scalar z128 = s_q4 * z110 + c_q4 * z125;
    const Scalar z129 = s_q4 * z125 - c_q4 * z110;
    const Scalar z130 = k34 + z124;
    const Scalar z131 = z93 - z122;
    const Scalar z132 = s_q3 * z96 - c_q3 * z82;
    const Scalar z133 = c_q3 * z126 + s_q3 * z131;
    const Scalar z134 = z130 - z113;
    const Scalar z135 = s_q3 * z82 + c_q3 * z96;
    const Scalar z136 = n632_over_165 * z132 + z133;
    const Scalar z137 = s_q3 * z126 - c_q3 * z131;
    const Scalar z138 = n632_over_165 * z135 - z137;
    const Scalar z139 = c_q3 * z118;
    const Scalar z140 = c_q2 * z80 + s_q2 * z102;
    const Scalar z141 = z109 - z127;
    const Scalar z142 = n2 * z105;
    const Scalar z143 = s_q4 * z141 - c_q4 * z142;
    const Scalar z144 = z83 - z128;
    const Scalar z145 = k35 - z144;
    const Scalar z146 = z130 - n2 * z113;
    const Scalar z147 = k36 - z83;
    const Scalar z148 = k37 + z129;
    const Scalar z149 = k38 - z113;
    const Scalar z150 = n2 * z145;
    const Scalar z151 = s_q3 * z147 - c_q3 * z149;
    const Scalar z152 = s_q4 * z143;
    const Scalar z153 = c_q4 * z143 + z105;
    const Scalar z154 = s_q3 * z128 - c_q3 * z134;
    const Scalar z155 = n632_over_165 * z139 + z154;
    const Scalar z156 = z118 - z153;
    const Scalar z157 = z127 + z152;
    const Scalar z158 = z109 - z152;
    const Scalar z159 = k39 + z157;
    const Scalar z160 = n2 * z113 - z158;
    const Scalar z161 = k40 - z156;
    const Scalar z162 = c_q3 * z147 + s_q3 * z149;
    const Scalar z163 = z146 - z159;
    const Scalar z164 = k41 - z160;
    const Scalar z165 = s_q3 * z148 - c_q3 * z161;
    const Scalar z166 = c_q3 * z150 + s_q3 * z163;
    const Scalar z167 = c_q3 * z148 + s_q3 * z161;
    const Scalar z168 = n632_over_165 * z151 + z165;
    const Scalar z169 = n632_over_165 * z162 + z167;
    const Scalar z170 = s_q3 * z118;
    const Scalar z171 = c_q3 * z128 + s_q3 * z134;
    const Scalar z172 = n632_over_165 * z170 - z171;
    const Scalar z173 = s_q2 * z136 - c_q2 * z115;
    const Scalar z174 = v_q2 * z1;  // angular acceleration of link2, x
    const Scalar z175 = z0 * z1;
    const Scalar z176 = v_q2 * v_q2;
    const Scalar z177 = z0 * z0;
    const Scalar z178 = k42 * s_q2;
    const Scalar z179 = k42 * c_q2;
    const Scalar z180 = z176 + z177;
    const Scalar z181 = z8 * z8;
    const Scalar z182 = z9 * z9;
    const Scalar z183 = v_q2 * z0;  // angular acceleration of link2, y
    const Scalar z184 = z179 - n632_over_165 * z180;
    const Scalar z185 = s_q3 * z166;
    const Scalar z186 = c_q3 * z166 - z145;
    const Scalar z187 = k43 - z186;
    const Scalar z188 = z159 + z185;
    const Scalar z189 = z146 - z185;
    const Scalar z190 = k44 + z168;
    const Scalar z191 = k45 * z118 - z188;
    const Scalar z192 = k45 * z118 - z189;
    const Scalar z193 = n2 * z190;
    const Scalar z194 = k46 + z169;
    const Scalar z195 = c_q2 * z129 + s_q2 * z172;
    const Scalar z196 = k47 - z191;
    const Scalar z197 = k48 - z192;
    const Scalar z198 = z7 * z9;
    const Scalar z199 = z181 + z182;
    const Scalar z200 = z7 * z8;
    const Scalar z201 = z11 * z11;
    const Scalar z202 = z12 * z12;
    const Scalar z203 = z10 * z11;
    const Scalar z204 = z201 + z202;
    const Scalar z205 = z11 * z12;
    const Scalar z206 = z10 * z10;
    const Scalar z207 = z202 + z206;
    const Scalar z208 = z10 * z12;
    const Scalar z209 = z55 * z55;
    const Scalar z210 = z54 * z54;
    const Scalar z211 = z43 * z43;
    const Scalar z212 = z42 * z43;
    const Scalar z213 = z57 * z57;
    const Scalar z214 = z57 * z55;
    const Scalar z215 = z54 * z57;
    const Scalar z216 = z209 + z210;
    const Scalar z217 = z54 * z55;
    const Scalar z218 = z213 - z209;
    const Scalar z219 = z44 * z44;
    const Scalar z220 = z213 + z209;
    const Scalar z221 = z211 + z219;
    const Scalar z222 = z42 * z44;
    const Scalar z223 = z164 - z196;
    const Scalar z224 = c_q2 * z193 + s_q2 * z223;
    const Scalar z225 = s_q2 * z168 - c_q2 * z164;
    const Scalar z226 = z209 - z210;
    const Scalar z227 = z42 * z42;
    const Scalar z228 = s_q2 * z224;
    const Scalar z229 = z211 - z227;
    const Scalar z230 = z43 * z44;
    const Scalar z231 = z213 - z210;
    const Scalar z232 = z211 - z219;
    const Scalar z233 = z219 - z227;
    const Scalar z234 = z219 + z227;
    const Scalar z235 = z164 - z228;
    const Scalar z236 = z32 * z32;
    const Scalar z237 = z34 * z34;
    const Scalar z238 = c_q2 * z194 + s_q2 * z187;
    const Scalar z239 = k49 + z235;
    const Scalar z240 = k50 + z151;
    const Scalar z241 = z236 + z237;
    const Scalar z242 = k51 - z118;
    const Scalar z243 = a_q1 * s_q2;
    const Scalar z244 = v_q2 * z1 + z243;  // angular acceleration of link2, x
    const Scalar z245 = a_q1 * c_q2;
    const Scalar z246 = v_q2 * z0 - z245;  // angular acceleration of link2, y
    const Scalar z247 = a_q2 - z175;
    const Scalar z248 = z178 - n632_over_165 * z247;
    const Scalar z249 = a_q2 * s_q3 - c_q3 * z244;
    const Scalar z250 = a_q3 - z246;  // angular acceleration of link3, z
    const Scalar z251 = z174 + z244;
    const Scalar z252 = a_q2 * c_q3 + s_q3 * z244;
    const Scalar z253 = v_q3 * z8 + z249;  // angular acceleration of link3, x
    const Scalar z254 = v_q3 * z7 - z252;  // angular acceleration of link3, y
    const Scalar z255 = n632_over_165 * z251;
    const Scalar z256 = s_q3 * z255 - c_q3 * z248;
    const Scalar z257 = s_q3 * z248 + c_q3 * z255;
    const Scalar z258 = s_q4 * z250 + c_q4 * z253;
    const Scalar z259 = z198 + z254;
    const Scalar z260 = a_q4 + z254;  // angular acceleration of link4, z
    const Scalar z261 = v_q4 * z11 - z258;  // angular acceleration of link4, x
    const Scalar z262 = s_q4 * z253 - c_q4 * z250;
    const Scalar z263 = z184 + z259;
    const Scalar z264 = v_q4 * z10 + z262;  // angular acceleration of link4, y
    const Scalar z265 = z200 + z250;
    const Scalar z266 = z199 - z256;
    const Scalar z267 = z203 + z260;
    const Scalar z268 = s_q5 * z260 + c_q5 * z261;
    const Scalar z269 = z257 + z265;
    const Scalar z270 = z205 + z261;
    const Scalar z271 = v_q5 * z32 + z268;  // angular acceleration of link5, x
    const Scalar z272 = s_q4 * z263 - c_q4 * z266;
    const Scalar z273 = c_q4 * z263 + s_q4 * z266;
    const Scalar z274 = z203 - z260;
    const Scalar z275 = s_q5 * z261 - c_q5 * z260;
    const Scalar z276 = z208 + z264;
    const Scalar z277 = z204 - n256_over_55 * z267 + z272;
    const Scalar z278 = z269 + n256_over_55 * z270 + z276;
    const Scalar z279 = n256_over_55 * z207 - z274 - z273;
    const Scalar z280 = c_q5 * z277 + s_q5 * z278;
    const Scalar z281 = s_q5 * z277 - c_q5 * z278;
    const Scalar z282 = z31 * z32;
    const Scalar z283 = v_q5 * z31 + z275;  // angular acceleration of link5, y
    const Scalar z284 = z31 * z31;
    const Scalar z285 = a_q5 - z264;  // angular acceleration of link5, z
    const Scalar z286 = z32 * z34;
    const Scalar z287 = z31 * z34;
    const Scalar z288 = z236 - z284;
    const Scalar z289 = z236 - z237;
    const Scalar z290 = z237 - z284;
    const Scalar z291 = z237 + z284;
    const Scalar z292 = c_q6 * z285 + s_q6 * z271;
    const Scalar z293 = s_q6 * z285 - c_q6 * z271;
    const Scalar z294 = c_q6 * z279 + s_q6 * z280;
    const Scalar z295 = v_q6 * z42 - z292;  // angular acceleration of link6, y
    const Scalar z296 = v_q6 * z43 + z293;  // angular acceleration of link6, x
    const Scalar z297 = s_q6 * z279 - c_q6 * z280;
    const Scalar z298 = z201 - z202;
    const Scalar z299 = z202 - z206;
    const Scalar z300 = a_q6 - z283;  // angular acceleration of link6, z
    const Scalar z301 = z212 + z300;
    const Scalar z302 = z201 - z206;
    const Scalar z303 = z222 + z295;
    const Scalar z304 = z7 * z7;
    const Scalar z305 = s_q7 * z300 + c_q7 * z296;
    const Scalar z306 = z181 - z304;
    const Scalar z307 = z8 * z9;
    const Scalar z308 = z181 - z182;
    const Scalar z309 = z182 - z304;
    const Scalar z310 = z182 + z304;
    const Scalar z311 = s_q7 * z296 - c_q7 * z300;
    const Scalar z312 = z294 - n16_over_15 * z301;
    const Scalar z313 = n16_over_15 * z221 + z297;
    const Scalar z314 = z281 + n16_over_15 * z303;
    const Scalar z315 = s_q7 * z314 - c_q7 * z313;
    const Scalar z316 = z176 - z177;
    const Scalar z317 = z1 * z1;
    const Scalar z318 = s_q7 * z313 + c_q7 * z314;
    const Scalar z319 = z176 - z317;
    const Scalar z320 = v_q7 * z57 - z305;  // angular acceleration of link7, x
    const Scalar z321 = v_q7 * z54 + z311;  // angular acceleration of link7, y
    const Scalar z322 = z177 - z317;
    const Scalar z323 = z208 - z264;
    const Scalar z324 = z198 - z254;
    const Scalar z325 = k52 * z6;
    const Scalar z326 = a_q7 + z295;  // angular acceleration of link7, z
    const Scalar z327 = z222 - z295;
    const Scalar z328 = z215 - z326;
    const Scalar z329 = z215 + z326;
    const Scalar z330 = z214 + z320;
    const Scalar z331 = k52 * z29;
    const Scalar z332 = z217 + z321;
    const Scalar z333 = k2 * z216 - k3 * z328;  // force on link7, times 0.0825 m, y
    const Scalar z334 = k3 * z220 - k2 * z329;  // force on link7, times 0.0825 m, x
    const Scalar z335 = z217 - z321;
    const Scalar z336 = z214 - z320;
    // moment on link7, z
    const Scalar z337 = k0 * z215 + k8 * z231 + k6 * z326 - k5 * z336 + k3 * z318 + k2 * z315 - k4 * z335;
    const Scalar z338 = z103 * z331 - z173;
    const Scalar z339 = s_q7 * z333 + c_q7 * z334;
    const Scalar z340 = k2 * z330 + k3 * z332;  // force on link7, times 0.0825 m, z
    const Scalar z341 = k13 * z234 - z340 + k10 * z301;  // force on link6, times 0.0825 m, y
    const Scalar z342 = z212 - z300;
    const Scalar z343 = k10 * z221 + z339 + k13 * z342;  // force on link6, times 0.0825 m, x
    const Scalar z344 = z230 - z296;
    const Scalar z345 = s_q7 * z334 - c_q7 * z333;
    const Scalar z346 = z103 * z325 - z140;
    const Scalar z347 = z29 * z331 - z79;
    const Scalar z348 = z230 + z296;
    const Scalar z349 = z6 * z325 - z37;
    const Scalar z350 = z29 * z325 - z50;
    const Scalar z351 = z282 - z285;
    const Scalar z352 = k10 * z303 - z345 - k13 * z348;  // force on link6, times 0.0825 m, z
    const Scalar z353 = n1 / z349;
    const Scalar z354 = z282 + z285;
    const Scalar z355 = k20 * z291 + z352 + k21 * z354;  // force on link5, times 0.0825 m, y
    const Scalar z356 = z205 - z261;
    const Scalar z357 = k52 * z51;
    const Scalar z358 = z103 * z357 - z195;
    const Scalar z359 = c_q6 * z343 + s_q6 * z341;
    const Scalar z360 = k21 * z241 - z359 + k20 * z351;  // force on link5, times 0.0825 m, x
    const Scalar z361 = z286 + z271;
    const Scalar z362 = z51 * z331 + z93;
    const Scalar z363 = z51 * z325 - z56;
    const Scalar z364 = z286 - z271;
    const Scalar z365 = s_q6 * z343 - c_q6 * z341;
    const Scalar z366 = z287 + z283;
    const Scalar z367 = z287 - z283;
    const Scalar z368 = z365 - k21 * z366 + k20 * z361;  // force on link5, times 0.0825 m, z
    const Scalar z369 = z350 * z353;
    const Scalar z370 = z51 * z357 - z130;
    const Scalar z371 = z363 * z353;
    const Scalar z372 = z307 - z253;
    const Scalar z373 = s_q5 * z355 + c_q5 * z360;
    const Scalar z374 = z373 + k30 * z204 - k29 * z267;  // force on link4, times 0.0825 m, x
    const Scalar z375 = z368 + k29 * z207 - k30 * z274;  // force on link4, times 0.0825 m, y
    const Scalar z376 = z358 - z346 * z371;
    const Scalar z377 = s_q5 * z360 - c_q5 * z355;
    const Scalar z378 = z370 - z363 * z371;
    const Scalar z379 = z338 - z346 * z369;
    const Scalar z380 = k52 * z68;
    const Scalar z381 = z103 * z380 - z225;
    const Scalar z382 = z68 * z357 + z129;
    const Scalar z383 = z68 * z331 - z115;
    const Scalar z384 = z68 * z325 + z80;
    const Scalar z385 = z382 - z384 * z371;
    const Scalar z386 = z200 - z250;
    const Scalar z387 = z68 * z380 - z164;
    const Scalar z388 = z384 * z353;
    const Scalar z389 = z387 - z384 * z388;
    const Scalar z390 = z381 - z346 * z388;
    const Scalar z391 = z307 + z253;
    const Scalar z392 = z377 + k29 * z270 + k30 * z276;  // force on link4, times 0.0825 m, z
    const Scalar z393 = z383 - z384 * z369;
    const Scalar z394 = k36 * z310 - z392 - k38 * z265;  // force on link3, times 0.0825 m, y
    const Scalar z395 = z183 - z246;
    const Scalar z396 = z183 + z246;
    const Scalar z397 = s_q4 * z375 + c_q4 * z374;
    const Scalar z398 = z362 - z363 * z369;
    const Scalar z399 = k38 * z199 - z397 - k36 * z386;  // force on link3, times 0.0825 m, x
    const Scalar z400 = a_q2 + z175;
    const Scalar z401 = z174 - z244;
    const Scalar z402 = s_q4 * z374 - c_q4 * z375;
    const Scalar z403 = z347 - z350 * z369;
    const Scalar z404 = n1 / z403;
    const Scalar z405 = k52 * z94;
    const Scalar z406 = z103 * z405 + z238;
    const Scalar z407 = z94 * z380 - z169;
    const Scalar z408 = z94 * z357 - z155;
    const Scalar z409 = z94 * z331 - z138;
    const Scalar z410 = z94 * z325 + z99;
    const Scalar z411 = z407 - z410 * z388;
    const Scalar z412 = z408 - z410 * z371;
    const Scalar z413 = z409 - z410 * z369;
    const Scalar z414 = z94 * z405 - z197;
    const Scalar z415 = z410 * z353;
    const Scalar z416 = z414 - z410 * z415;
    const Scalar z417 = z406 - z346 * z415;
    const Scalar z418 = c_q3 * z394 + s_q3 * z399;
    const Scalar z419 = z398 * z404;
    const Scalar z420 = z393 * z404;
    const Scalar z421 = z413 * z404;
    const Scalar z422 = k52 * z103;
    const Scalar z423 = z103 * z422 - z239;
    const Scalar z424 = z346 * z353;
    const Scalar z425 = z379 * z404;
    const Scalar z426 = s_q3 * z394 - c_q3 * z399;
    const Scalar z427 = k6 * z214 + k4 * z218 + k2 * z312 + k0 * z320 - k5 * z328 - k8 * z332;  // moment on link7, x
    const Scalar z428 = k54 * z217 + k5 * z226 + k3 * z312 + k4 * z329 - k8 * z330;  // moment on link7, y
    // moment on link6, y
    const Scalar z429 = k55 * z222 + k16 * z233 + k10 * z281 + k12 * z342 - k11 * z348 - n16_over_15 * z345 + z337;
    const Scalar z430 = z378 - z398 * z419;
    const Scalar z431 = z423 - z346 * z424;
    const Scalar z432 = z385 - z393 * z419;
    const Scalar z433 = z389 - z393 * z420;
    const Scalar z434 = n1 / z430;
    const Scalar z435 = z411 - z413 * z420;
    const Scalar z436 = z412 - z413 * z419;
    const Scalar z437 = z416 - z413 * z421;
    const Scalar z438 = z417 - z379 * z421;
    const Scalar z439 = z390 - z379 * z420;
    const Scalar z440 = z376 - z379 * z419;
    const Scalar z441 = z431 - z379 * z425;
    const Scalar z442 = z201 + z206;
    const Scalar z443 = z177 + z317;
    const Scalar z444 = z181 + z304;
    const Scalar z445 = n2 * z9;
    const Scalar z446 = n2 * z10;
    const Scalar z447 = n2 * z11;
    const Scalar z448 = s_q7 * z428 - c_q7 * z427;
    // moment on link6, x
    const Scalar z449 = k15 * z230 + k12 * z232 - k13 * z281 - k14 * z296 - k16 * z301 - k11 * z303 + z448;
    const Scalar z450 = c_q7 * z428 + s_q7 * z427;
    // moment on link6, z
    const Scalar z451 = k14 * z212 - k11 * z229 + k15 * z300 - k13 * z297 - k10 * z294 + k16 * z344 + k12 * z327
        - n16_over_15 * z340 - z450;
    const Scalar z452 = k56 * z287 - k22 * z290 - k21 * z279 - k25 * z351 + k19 * z361 - z451;  // moment on link5, y
    const Scalar z453 = c_q6 * z449 + s_q6 * z429;
    // moment on link5, x
    const Scalar z454 = k24 * z286 - k25 * z289 + k20 * z279 + k23 * z271 + k22 * z354 + k19 * z366 - z453;
    const Scalar z455 = s_q6 * z449 - c_q6 * z429;
    // moment on link5, z
    const Scalar z456 = k23 * z282 - k19 * z288 + k20 * z280 - k21 * z281 - k24 * z285 + k22 * z364 + k25 * z367 - z455;
    // moment on link4, y
    const Scalar z457 = k57 * z208 - k32 * z299 + k28 * z267 + k30 * z269 + k27 * z270 + z456 + z377;
    const Scalar z458 = s_q5 * z452 + c_q5 * z454;
    // moment on link4, x
    const Scalar z459 = k34 * z205 + k28 * z298 + k32 * z274 + k29 * z269 + k33 * z261 + k27 * z276 + z458
        + n256_over_55 * z377;
    const Scalar z460 = n2 * z7;
    const Scalar z461 = n2 * z8;
    const Scalar z462 = s_q5 * z454 - c_q5 * z452;
    // moment on link4, z
    const Scalar z463 = k33 * z203 + k34 * z260 - k27 * z302 + k32 * z356 - k29 * z272 - k30 * z273 - k28 * z323 + z368
        - n256_over_55 * z373 + z462;
    // moment on link3, y
    const Scalar z464 = k58 * z198 + k38 * z184 + k40 * z309 - k37 * z386 + k35 * z391 + z463 + z402;
    const Scalar z465 = s_q4 * z457 - c_q4 * z459;
    // moment on link3, x
    const Scalar z466 = k36 * z184 + k41 * z307 - k37 * z308 + k39 * z253 - k40 * z265 + k35 * z259 + z465;
    const Scalar z467 = c_q4 * z457 + s_q4 * z459;
    // moment on link3, z
    const Scalar z468 = k39 * z200 - k41 * z250 - k35 * z306 - k40 * z372 + k37 * z324 + k36 * z256 - k38 * z257 - z392
        + z467;
    const Scalar z469 = k59 * z183 + k43 * z316 + k46 * z247 + k44 * z251 + z468;  // moment on link2, y
    const Scalar z470 = z432 * z434;
    const Scalar z471 = z433 - z432 * z470;
    const Scalar z472 = z435 - z436 * z470;
    const Scalar z473 = z439 - z440 * z470;
    const Scalar z474 = n2 * v_q2;
    const Scalar z475 = n2 * z0;
    const Scalar z476 = n1 / z471;
    const Scalar z477 = c_q3 * z466 + s_q3 * z464;
    // moment on link2, x
    const Scalar z478 = k48 * z174 + k47 * z244 + k46 * z319 - k43 * z400 + k44 * z396 - z477 - n632_over_165 * z418;
    const Scalar z479 = n2 * z1;
    const Scalar z480 = z436 * z434;
    const Scalar z481 = z437 - z436 * z480;
    const Scalar z482 = z438 - z440 * z480;
    const Scalar z483 = z440 * z434;
    const Scalar z484 = z236 + z284;
    const Scalar z485 = z441 - z440 * z483;
    const Scalar z486 = z213 + z210;
    const Scalar z487 = z211 + z227;
    const Scalar z488 = n2 * z44;
    const Scalar z489 = n2 * z34;
    const Scalar z490 = n2 * z12;
    const Scalar z491 = n2 * z43;
    const Scalar z492 = n2 * z42;
    const Scalar z493 = n2 * z31;
    const Scalar z494 = n2 * z32;
    const Scalar z495 = z472 * z476;
    const Scalar z496 = z481 - z472 * z495;
    const Scalar z497 = z482 - z473 * z495;
    const Scalar z498 = z473 * z476;
    const Scalar z499 = z485 - z473 * z498;
    const Scalar z500 = n2 * z55;
    const Scalar z501 = n1 / z496;
    const Scalar z502 = n2 * z54;
    const Scalar z503 = n2 * z57;
    const Scalar z504 = k4 * z502;
    const Scalar z505 = k5 * z503;
    const Scalar z506 = k8 * z500;
    const Scalar z507 = n2 * v_q1;
    const Scalar z508 = s_q3 * z466 - c_q3 * z464;
    // moment on link2, z
    const Scalar z509 = k48 * a_q2 - k51 * z178 + k50 * z179 - k47 * z175 - k44 * z322 + k43 * z401 - k46 * z395 + z508
        + n632_over_165 * z426;
    const Scalar z510 = z497 * z501;
    const Scalar z511 = k2 * z500;
    const Scalar z512 = s_q2 * z478 - c_q2 * z469;
    const Scalar z513 = k49 * a_q1 + z512;  // moment on link1, z
    const Scalar z514 = z499 - z497 * z510;
    const Scalar z515 = k3 * z500;
    const Scalar z516 = n1 / z514;
    const Scalar z517 = k8 * z502;
    const Scalar z518 = k60 * z500 + k4 * z503;
    const Scalar z519 = k5 * z502 - k61 * z500;
    const Scalar z520 = k60 * z502 + k8 * z503;
    const Scalar z521 = z505 + z506;
    const Scalar z522 = z504 - z506;
    const Scalar z523 = k61 * z503 + z517;
    const Scalar z524 = z518 + z519;
    const Scalar z525 = z521 - z522;
    const Scalar z526 = n16_over_15 * z488;
    const Scalar z527 = s_q7 * z520 - c_q7 * z523;
    const Scalar z528 = c_q7 * z524 + s_q7 * z525;
    const Scalar z529 = k5 * z500 + k61 * z502;
    const Scalar z530 = k61 * z503 - k4 * z500;
    const Scalar z531 = k2 * z502 - k3 * z503;
    const Scalar z532 = s_q7 * z528;
    const Scalar z533 = n16_over_15 * z491;
    const Scalar z534 = s_q7 * z529 - c_q7 * z530;
    const Scalar z535 = c_q7 * z528 - z518;
    const Scalar z536 = c_q7 * z528 - z519;
    const Scalar z537 = k62 * z488 - z534 + k12 * z491;
    const Scalar z538 = z536 + k63 * z491 - k12 * z488;
    const Scalar z539 = z527 + z3 * z526 + n16_over_15 * z531;
    const Scalar z540 = k16 * z492 - z539 - k63 * z488;
    const Scalar z541 = s_q7 * z515 - c_q7 * z511;
    const Scalar z542 = z521 - z532;
    const Scalar z543 = n16_over_15 * z541 + z542;
    const Scalar z544 = z522 + z532;
    const Scalar z545 = z5 * z533 + z544;
    const Scalar z546 = s_q7 * z523 + c_q7 * z520;
    const Scalar z547 = z5 * z526 - z546;
    const Scalar z548 = s_q7 * z511 + c_q7 * z515;
    const Scalar z549 = z535 + z3 * z533 - n16_over_15 * z548;
    const Scalar z550 = k12 * z492;
    const Scalar z551 = k16 * z491;
    const Scalar z552 = z550 + z551 + z545;
    const Scalar z553 = z549 + k11 * z492 + k63 * z491;
    const Scalar z554 = k11 * z488;
    const Scalar z555 = z543 - z551 - z554;
    const Scalar z556 = c_q7 * z529 + s_q7 * z530;
    const Scalar z557 = k62 * z492 - z556 + k11 * z491;
    const Scalar z558 = z504 + z505;
    const Scalar z559 = z550 - z554 + z558;
    const Scalar z560 = z537 + z540;
    const Scalar z561 = z547 + k16 * z488 + k63 * z492;
    const Scalar z562 = z555 + z559;
    const Scalar z563 = k25 * z493;
    const Scalar z564 = k22 * z494;
    const Scalar z565 = k19 * z489;
    const Scalar z566 = k10 * z488 + z531;
    const Scalar z567 = c_q6 * z560 + s_q6 * z562;
    const Scalar z568 = k13 * z488 - z541;
    const Scalar z569 = s_q6 * z561 + c_q6 * z538;
    const Scalar z570 = z569 + k25 * z494 - k64 * z489;
    const Scalar z571 = s_q6 * z567;
    const Scalar z572 = s_q6 * z557 + c_q6 * z553;
    const Scalar z573 = s_q6 * z553 - c_q6 * z557;
    const Scalar z574 = z555 - z571;
    const Scalar z575 = z564 + z565 + z574;
    const Scalar z576 = z563 - z565 + z552;
    const Scalar z577 = z559 - z571;
    const Scalar z578 = z563 + z564 + z577;
    const Scalar z579 = c_q6 * z567 - z540;
    const Scalar z580 = c_q6 * z567 - z537;
    const Scalar z581 = k65 * z494 - z579 + k25 * z489;
    const Scalar z582 = z580 + k19 * z493 - k65 * z494;
    const Scalar z583 = k13 * z492 - z548 + k10 * z491;
    const Scalar z584 = s_q6 * z538 - c_q6 * z561;
    const Scalar z585 = k64 * z493 - z584 - k19 * z494;
    const Scalar z586 = s_q6 * z566 - c_q6 * z568;
    const Scalar z587 = k20 * z489 + z586;
    const Scalar z588 = k21 * z489 - z583;
    const Scalar z589 = z572 + k22 * z493 + k65 * z489;
    const Scalar z590 = k65 * z493 - z573 - k22 * z489;
    const Scalar z591 = z575 - z576;
    const Scalar z592 = c_q6 * z566 + s_q6 * z568;
    const Scalar z593 = k20 * z493 - z592 + k21 * z494;
    const Scalar z594 = z570 + z589;
    const Scalar z595 = s_q5 * z591 - c_q5 * z594;
    const Scalar z596 = n256_over_55 * z446 - z447;
    const Scalar z597 = c_q5 * z588 + s_q5 * z587;
    const Scalar z598 = n256_over_55 * z490;
    const Scalar z599 = s_q5 * z590 + c_q5 * z581;
    const Scalar z600 = s_q5 * z581 - c_q5 * z590;
    const Scalar z601 = z26 * z596 - z600 + n256_over_55 * z597;
    const Scalar z602 = s_q5 * z588 - c_q5 * z587;
    const Scalar z603 = z26 * z598 - z599 - n256_over_55 * z602;
    const Scalar z604 = c_q5 * z595 + z570;
    const Scalar z605 = z82 * z596 + z597 - z604;
    const Scalar z606 = z603 + k66 * z490 + k28 * z447;
    const Scalar z607 = z605 + k27 * z446 - k67 * z447;
    const Scalar z608 = z597 + k29 * z446 - k30 * z447;
    const Scalar z609 = z601 + k66 * z446 - k27 * z447;
    const Scalar z610 = s_q5 * z595;
    const Scalar z611 = c_q5 * z595 + z589;
    const Scalar z612 = z83 * z598 - z611;
    const Scalar z613 = s_q5 * z585 - c_q5 * z582;
    const Scalar z614 = c_q5 * z585 + s_q5 * z582;
    const Scalar z615 = z83 * z490 - z614;
    const Scalar z616 = k67 * z447 - z612 - k28 * z490;
    const Scalar z617 = z575 - z610;
    const Scalar z618 = z82 * z598 - z602 - z617;
    const Scalar z619 = z576 + z610;
    const Scalar z620 = k29 * z490 - z602;
    const Scalar z621 = z83 * z596 - z619;
    const Scalar z622 = k28 * z446;
    const Scalar z623 = k32 * z447;
    const Scalar z624 = k27 * z490;
    const Scalar z625 = z624 + z623 + z618;
    const Scalar z626 = z622 - z623 + z621;
    const Scalar z627 = z82 * z490 + z593 + z613;
    const Scalar z628 = z627 + k67 * z490 + k32 * z446;
    const Scalar z629 = z26 * z490 - z578 + n256_over_55 * z593;
    const Scalar z630 = z624 + z622 + z629;
    const Scalar z631 = k67 * z446 - z615 - k32 * z490;
    const Scalar z632 = z625 + z630;
    const Scalar z633 = k30 * z490 + z593;
    const Scalar z634 = z606 - z628;
    const Scalar z635 = c_q4 * z607 + s_q4 * z609;
    const Scalar z636 = s_q4 * z607 - c_q4 * z609;
    const Scalar z637 = s_q4 * z632 - c_q4 * z634;
    const Scalar z638 = z118 * z445 - z636;
    const Scalar z639 = s_q4 * z631 - c_q4 * z616;
    const Scalar z640 = z639 + k37 * z461 - k68 * z445;
    const Scalar z641 = z113 * z445 + z608 - z635;
    const Scalar z642 = z641 + k40 * z460 - k69 * z445;
    const Scalar z643 = s_q4 * z637;
    const Scalar z644 = c_q4 * z633 + s_q4 * z620;
    const Scalar z645 = c_q4 * z631 + s_q4 * z616;
    const Scalar z646 = z83 * z461 - z645;
    const Scalar z647 = c_q4 * z637 - z628;
    const Scalar z648 = c_q4 * z637 + z606;
    const Scalar z649 = z113 * z461 - z644 + z648;
    const Scalar z650 = k37 * z445 - z647 + k69 * z461;
    const Scalar z651 = z646 + k68 * z460 - k35 * z461;
    const Scalar z652 = z649 + k35 * z460 - k69 * z461;
    const Scalar z653 = k36 * z460 - z644 - k38 * z461;
    const Scalar z654 = s_q4 * z633 - c_q4 * z620;
    const Scalar z655 = z625 - z643;
    const Scalar z656 = z654 + z655;
    const Scalar z657 = k36 * z445 - z654;
    const Scalar z658 = z630 - z643;
    const Scalar z659 = z118 * z461 - z658;
    const Scalar z660 = k37 * z460;
    const Scalar z661 = k40 * z461;
    const Scalar z662 = k35 * z445;
    const Scalar z663 = z661 - z662 + z656;
    const Scalar z664 = z83 * z445 - z626;
    const Scalar z665 = z660 - z662 + z664;
    const Scalar z666 = z660 - z661 + z659;
    const Scalar z667 = k70 * z507;
    const Scalar z668 = k40 * z445 - z638 + k69 * z460;
    const Scalar z669 = z640 - z642;
    const Scalar z670 = k38 * z445 - z608;
    const Scalar z671 = z663 + z665;
    const Scalar z672 = z164 * z401;
    const Scalar z673 = c_q3 * z669 + s_q3 * z671;
    const Scalar z674 = n632_over_165 * z474;
    const Scalar z675 = s_q3 * z668 + c_q3 * z650;
    const Scalar z676 = n632_over_165 * z475;
    const Scalar z677 = s_q3 * z650 - c_q3 * z668;
    const Scalar z678 = s_q3 * z670 + c_q3 * z657;
    const Scalar z679 = z675 + z118 * z674 + n632_over_165 * z678;
    const Scalar z680 = s_q3 * z673;
    const Scalar z681 = s_q3 * z651 - c_q3 * z652;
    const Scalar z682 = s_q3 * z657 - c_q3 * z670;
    const Scalar z683 = z677 + z118 * z676 + n632_over_165 * z682;
    const Scalar z684 = z679 + k46 * z479 - k71 * z474;
    const Scalar z685 = k71 * z475 - z683 - k44 * z479;
    const Scalar z686 = z8 * z653 - z118 * z324 + z149 * z444 + z399;
    const Scalar z687 = z7 * z653 + z118 * z372 - z147 * z444 - z394;
    const Scalar z688 = z7 * z651 - z147 * z257 - z149 * z256 - z148 * z372 - z161 * z324 - z164 * z444 - z8 * z652;
    const Scalar z689 = c_q3 * z651 + s_q3 * z652;
    const Scalar z690 = n632_over_165 * z653 + z666;
    const Scalar z691 = z118 * z257;
    const Scalar z692 = z663 - z680;
    const Scalar z693 = z665 - z680;
    const Scalar z694 = z151 * z674 - z692;
    const Scalar z695 = z162 * z676 - z693;
    const Scalar z696 = k46 * z475;
    const Scalar z697 = k43 * z479;
    const Scalar z698 = k44 * z474;
    const Scalar z699 = z698 - z697 + z694;
    const Scalar z700 = z696 - z697 + z695;
    const Scalar z701 = z698 - z696 + z690;
    const Scalar z702 = c_q3 * z673 - z640;
    const Scalar z703 = z151 * z676 - z702;
    const Scalar z704 = c_q3 * z673 + z642;
    const Scalar z705 = z162 * z674 + z704;
    const Scalar z706 = z118 * z460 - z670;
    const Scalar z707 = z703 + k44 * z475 - k72 * z479;
    const Scalar z708 = z118 * z461 - z657;
    const Scalar z709 = z650 + z145 * z460 + z159 * z461;
    const Scalar z710 = z668 + z145 * z461 + z146 * z460;
    const Scalar z711 = z705 + k46 * z474 + k72 * z479;
    const Scalar z712 = z0 * z685 - z1 * z707 - z240 * z178 - z242 * z179 - z187 * z395 - z194 * z401 - z197 * z443;
    const Scalar z713 = c_q2 * z685 + s_q2 * z707;
    const Scalar z714 = z711 + z190 * z475 + z196 * z479;
    const Scalar z715 = k43 * z475 - z681 - k72 * z474;
    const Scalar z716 = z689 + k43 * z474 + k72 * z475;
    const Scalar z717 = z112 * z272 - z111 * z273 + z110 * z356 + z125 * z323 - z130 * z442 - z11 * z607 + z10 * z609;
    const Scalar z718 = z113 * z445 - z635;
    const Scalar z719 = z689 + z164 * z475 + z168 * z479;
    const Scalar z720 = z716 + z164 * z475 + z190 * z479;
    const Scalar z721 = s_q2 * z714 - c_q2 * z720;
    const Scalar z722 = z625 - z630;
    const Scalar z723 = z625 + z626;
    const Scalar z724 = z630 - z626;
    const Scalar z725 = z699 - z700;
    const Scalar z726 = z162 * z179 + z672 - z190 * z395 + z194 * z443 + z478 + z1 * z715 + z0 * z725;
    const Scalar z727 = z684 - z715;
    const Scalar z728 = z701 + z700;
    const Scalar z729 = z469 + z162 * z178 - z190 * z401 + z187 * z443 + z196 * z395 + z0 * z684 + z1 * z728;
    const Scalar z730 = c_q2 * z726 + s_q2 * z729;
    const Scalar z731 = z700 + z667;
    const Scalar z732 = z665 - z666;
    const Scalar z733 = z464 + z159 * z324 - z118 * z256 - z145 * z372 + z161 * z444 + z7 * z640 - z8 * z732;
    const Scalar z734 = z663 - z665;
    const Scalar z735 = z663 + z666;
    const Scalar z736 = z691 + z145 * z324 - z148 * z444 - z146 * z372 - z466 - z8 * z642 + z7 * z735;
    const Scalar z737 = z161 * z461 - z734 - z148 * z460;
    const Scalar z738 = z734 + z162 * z676 - z151 * z674;
    const Scalar z739 = z168 * z395 - z672 - z162 * z179 - z169 * z443 + z1 * z681 + z0 * z738;
    const Scalar z740 = s_q2 * z681 - c_q2 * z738;
    const Scalar z741 = z125 * z447 - z722 - z110 * z446;
    const Scalar z742 = z699 + z701;
    const Scalar z743 = z118 * z461 + z722;
    const Scalar z744 = s_q2 * z742 - c_q2 * z727;
    const Scalar z745 = z691 + z128 * z324 - z129 * z444 - z134 * z372 + z7 * z743 - z8 * z718;
    const Scalar z746 = z128 * z461 - z638 + z134 * z460;
    const Scalar z747 = z699 - z701;
    const Scalar z748 = z747 + z187 * z479 - z194 * z475;
    const Scalar z749 = s_q2 * z744;
    const Scalar z750 = z699 - z749;
    const Scalar z751 = z638 + z139 * z676 - z170 * z674;
    const Scalar z752 = c_q3 * z743 + s_q3 * z718;
    const Scalar z753 = s_q3 * z743 - c_q3 * z718;
    const Scalar z754 = z750 + z667;
    const Scalar z755 = z754 - z731;
    const Scalar z756 = z105 * z356 - z457 - z83 * z272 + z125 * z442 - z127 * z323 + z10 * z606 - z11 * z724;
    const Scalar z757 = z616 + z105 * z446 + z127 * z447;
    const Scalar z758 = z113 * z674 - z752;
    const Scalar z759 = z113 * z676 - z753;
    const Scalar z760 = z113 * z178 - z139 * z179 + z129 * z401 + z172 * z395 - z155 * z443 + z0 * z751 + z1 * z759;
    const Scalar z761 = z129 * z475 - z758 - z172 * z479;
    const Scalar z762 = s_q2 * z759 - c_q2 * z751;
    const Scalar z763 = z10 * z608 + z83 * z356 - z111 * z442 - z375;
    const Scalar z764 = z11 * z608 - z83 * z323 + z112 * z442 + z374;
    const Scalar z765 = z631 + z109 * z446 + z105 * z447;
    const Scalar z766 = z83 * z273;
    const Scalar z767 = z109 * z356 - z766 - z105 * z323 - z110 * z442 + z459 - z11 * z628 + z10 * z723;
    const Scalar z768 = z83 * z446 - z633;
    const Scalar z769 = z112 * z356 - z111 * z323 - z11 * z633 + z10 * z620;
    const Scalar z770 = z111 * z447 + z112 * z446;
    const Scalar z771 = z83 * z447 - z620;
    const Scalar z772 = s_q4 * z763 - c_q4 * z764;
    const Scalar z773 = c_q4 * z763 + s_q4 * z764;
    const Scalar z774 = z717 - z772;
    const Scalar z775 = c_q4 * z768 + s_q4 * z771;
    const Scalar z776 = s_q3 * z686 - c_q3 * z687;
    const Scalar z777 = s_q4 * z768 - c_q4 * z771;
    const Scalar z778 = s_q3 * z687 + c_q3 * z686;
    const Scalar z779 = s_q3 * z733 - c_q3 * z736;
    const Scalar z780 = s_q3 * z736 + c_q3 * z733;
    const Scalar z781 = n632_over_165 * z776 + z779;
    const Scalar z782 = n632_over_165 * z778 + z780;
    const Scalar z783 = z741 + z777;
    const Scalar z784 = s_q4 * z767 - c_q4 * z756;
    const Scalar z785 = c_q4 * z767 + s_q4 * z756;
    const Scalar z786 = z769 - z785;
    const Scalar z787 = s_q2 * z782 - c_q2 * z688;
    const Scalar z788 = c_q4 * z765 + s_q4 * z757;
    const Scalar z789 = s_q4 * z765 - c_q4 * z757;
    const Scalar z790 = z770 - z788;
    const Scalar z791 = s_q3 * z708 - c_q3 * z706;
    const Scalar z792 = s_q3 * z706 + c_q3 * z708;
    const Scalar z793 = z576 - z578;
    const Scalar z794 = s_q3 * z710 + c_q3 * z709;
    const Scalar z795 = s_q3 * z709 - c_q3 * z710;
    const Scalar z796 = n632_over_165 * z792 - z794;
    const Scalar z797 = z73 * z367 - z81 * z364 - z79 * z484 + z63 * z280 + z62 * z281 + z31 * z585 - z32 * z582;
    const Scalar z798 = n632_over_165 * z791 - z795;
    const Scalar z799 = z575 + z576;
    const Scalar z800 = z575 - z578;
    const Scalar z801 = s_q2 * z796 - c_q2 * z737;
    const Scalar z802 = z75 * z367 - z73 * z484 - z61 * z364 - z26 * z280 + z31 * z570 + z452 - z32 * z793;
    const Scalar z803 = z82 * z598 - z799 + z83 * z596;
    const Scalar z804 = z81 * z493 - z799 + z73 * z494;
    const Scalar z805 = z82 * z490 + z613;
    const Scalar z806 = z95 * z356 - z766 - z89 * z323 - z93 * z442 + z10 * z803 - z11 * z805;
    const Scalar z807 = z95 * z446 - z615 + z89 * z447;
    const Scalar z808 = z32 * z593 - z26 * z367 - z63 * z484 - z360;
    const Scalar z809 = z31 * z593 + z26 * z364 - z62 * z484 - z355;
    const Scalar z810 = z96 * z461 + z615;
    const Scalar z811 = z37 * z364;
    const Scalar z812 = z811 + z81 * z484 - z61 * z367 + z26 * z281 + z454 - z32 * z589 + z31 * z800;
    const Scalar z813 = s_q4 * z803 + c_q4 * z805;
    const Scalar z814 = s_q4 * z805 - c_q4 * z803;
    const Scalar z815 = z96 * z445 + z814;
    const Scalar z816 = z813 + z82 * z461 - z122 * z445;
    const Scalar z817 = z32 * z588 - z63 * z364 - z62 * z367 + z31 * z587;
    const Scalar z818 = z82 * z256 + z96 * z257 - z126 * z324 + z131 * z372 + z115 * z444 + z7 * z810 - z8 * z816;
    const Scalar z819 = z815 + z126 * z461 + z131 * z460;
    const Scalar z820 = z815 + z135 * z676 - z132 * z674;
    const Scalar z821 = s_q5 * z808 - c_q5 * z809;
    const Scalar z822 = s_q5 * z809 + c_q5 * z808;
    const Scalar z823 = c_q3 * z810 + s_q3 * z816;
    const Scalar z824 = s_q3 * z810 - c_q3 * z816;
    const Scalar z825 = z122 * z674 + z823;
    const Scalar z826 = z122 * z676 + z824;
    const Scalar z827 = s_q5 * z802 + c_q5 * z812;
    const Scalar z828 = s_q5 * z812 - c_q5 * z802;
    const Scalar z829 = z136 * z395 - z122 * z178 - z135 * z179 - z115 * z401 - z138 * z443 + z0 * z820 - z1 * z826;
    const Scalar z830 = z115 * z475 - z825 + z136 * z479;
    const Scalar z831 = c_q2 * z820 + s_q2 * z826;
    const Scalar z832 = n256_over_55 * z822 + z828;
    const Scalar z833 = s_q3 * z769 + c_q3 * z773;
    const Scalar z834 = s_q3 * z773 - c_q3 * z769;
    const Scalar z835 = z817 + n256_over_55 * z821 - z827;
    const Scalar z836 = z797 + z822;
    const Scalar z837 = s_q3 * z774 + c_q3 * z784;
    const Scalar z838 = s_q3 * z784 - c_q3 * z774;
    const Scalar z839 = n632_over_165 * z834 + z837;
    const Scalar z840 = n632_over_165 * z833 - z838;
    const Scalar z841 = c_q4 * z817 + s_q4 * z821;
    const Scalar z842 = s_q4 * z817 - c_q4 * z821;
    const Scalar z843 = s_q2 * z839 - c_q2 * z786;
    const Scalar z844 = z63 * z493 - z62 * z494;
    const Scalar z845 = z26 * z494 - z587;
    const Scalar z846 = z835 - z841;
    const Scalar z847 = z26 * z493 + z588;
    const Scalar z848 = s_q4 * z836 - c_q4 * z832;
    const Scalar z849 = c_q4 * z836 + s_q4 * z832;
    const Scalar z850 = z822 - z849;
    const Scalar z851 = c_q3 * z822 + s_q3 * z842;
    const Scalar z852 = s_q3 * z822 - c_q3 * z842;
    const Scalar z853 = s_q3 * z846 + c_q3 * z848;
    const Scalar z854 = n632_over_165 * z851 - z853;
    const Scalar z855 = s_q3 * z848 - c_q3 * z846;
    const Scalar z856 = n632_over_165 * z852 - z855;
    const Scalar z857 = s_q3 * z770 + c_q3 * z775;
    const Scalar z858 = z581 + z61 * z493 + z75 * z494;
    const Scalar z859 = s_q3 * z775 - c_q3 * z770;
    const Scalar z860 = z590 + z37 * z493 + z61 * z494;
    const Scalar z861 = c_q2 * z850 + s_q2 * z854;
    const Scalar z862 = s_q3 * z783 - c_q3 * z789;
    const Scalar z863 = c_q3 * z783 + s_q3 * z789;
    const Scalar z864 = n632_over_165 * z859 - z862;
    const Scalar z865 = n632_over_165 * z857 - z863;
    const Scalar z866 = s_q5 * z845 - c_q5 * z847;
    const Scalar z867 = s_q5 * z847 + c_q5 * z845;
    const Scalar z868 = s_q2 * z864 - c_q2 * z790;
    const Scalar z869 = z19 * z297 - z37 * z487 - k13 * z294 - z41 * z327 + z21 * z344 + z42 * z557 + z43 * z553;
    const Scalar z870 = z5 * z294;
    const Scalar z871 = z43 * z583 - z5 * z327 - z19 * z487 - z343;
    const Scalar z872 = z5 * z344 - k13 * z487 + z42 * z583 - z341;
    const Scalar z873 = z37 * z493 - z573 - z49 * z494;
    const Scalar z874 = z45 * z596 - z573 - z46 * z598;
    const Scalar z875 = z555 - z559;
    const Scalar z876 = z811 + z50 * z484 + z49 * z367 + z26 * z281 + z31 * z875 - z32 * z572;
    const Scalar z877 = z559 - z552;
    const Scalar z878 = z5 * z297 - z41 * z487 + z33 * z327 - z20 * z344 + z42 * z537 - z43 * z877 - z429;
    const Scalar z879 = z555 + z552;
    const Scalar z880 = z18 * z344 - z870 - z21 * z487 + z20 * z327 + z43 * z540 + z42 * z879 + z449;
    const Scalar z881 = z875 + z41 * z491 + z21 * z492;
    const Scalar z882 = s_q5 * z875 - c_q5 * z572;
    const Scalar z883 = c_q5 * z875 + s_q5 * z572;
    const Scalar z884 = z882 + z46 * z490 + z27 * z596;
    const Scalar z885 = z883 + z27 * z598 + z45 * z490;
    const Scalar z886 = z43 * z566 - z19 * z344 - k13 * z327 + z42 * z568;
    const Scalar z887 = z66 * z356 - z27 * z272 - z45 * z273 + z56 * z442 + z65 * z323 + z10 * z874 + z11 * z884;
    const Scalar z888 = z885 + z65 * z447 - z66 * z446;
    const Scalar z889 = z90 * z461 + z885;
    const Scalar z890 = s_q4 * z874 - c_q4 * z884;
    const Scalar z891 = c_q4 * z874 + s_q4 * z884;
    const Scalar z892 = z46 * z461 - z890 + z77 * z445;
    const Scalar z893 = z90 * z445 - z891;
    const Scalar z894 = s_q6 * z871 - c_q6 * z872;
    const Scalar z895 = c_q6 * z871 + s_q6 * z872;
    const Scalar z896 = z97 * z676 - z893 + z100 * z674;
    const Scalar z897 = z90 * z257 - z46 * z256 - z86 * z372 - z91 * z324 - z80 * z444 + z7 * z889 + z8 * z892;
    const Scalar z898 = z893 + z91 * z461 - z86 * z460;
    const Scalar z899 = c_q6 * z878 + s_q6 * z880;
    const Scalar z900 = s_q6 * z878 - c_q6 * z880;
    const Scalar z901 = s_q5 * z886 - c_q5 * z894;
    const Scalar z902 = c_q5 * z886 + s_q5 * z894;
    const Scalar z903 = s_q3 * z889 + c_q3 * z892;
    const Scalar z904 = s_q3 * z892 - c_q3 * z889;
    const Scalar z905 = z77 * z676 + z903;
    const Scalar z906 = z77 * z674 - z904;
    const Scalar z907 = s_q5 * z869 - c_q5 * z899;
    const Scalar z908 = z77 * z178 - z97 * z179 - z80 * z401 - z102 * z395 - z99 * z443 + z0 * z896 + z1 * z905;
    const Scalar z909 = z906 + z80 * z475 - z102 * z479;
    const Scalar z910 = s_q2 * z905 - c_q2 * z896;
    const Scalar z911 = s_q5 * z860 + c_q5 * z858;
    const Scalar z912 = s_q5 * z858 - c_q5 * z860;
    const Scalar z913 = c_q5 * z869 + s_q5 * z899;
    const Scalar z914 = n256_over_55 * z902 + z907;
    const Scalar z915 = n256_over_55 * z867 + z911;
    const Scalar z916 = z844 - n256_over_55 * z866 - z912;
    const Scalar z917 = z900 - z902;
    const Scalar z918 = z804 - z867;
    const Scalar z919 = z895 + n256_over_55 * z901 - z913;
    const Scalar z920 = s_q4 * z895 - c_q4 * z901;
    const Scalar z921 = s_q4 * z866 - c_q4 * z844;
    const Scalar z922 = s_q4 * z844 + c_q4 * z866;
    const Scalar z923 = c_q4 * z895 + s_q4 * z901;
    const Scalar z924 = z916 + z921;
    const Scalar z925 = s_q4 * z917 + c_q4 * z914;
    const Scalar z926 = s_q4 * z918 + c_q4 * z915;
    const Scalar z927 = s_q4 * z914 - c_q4 * z917;
    const Scalar z928 = s_q4 * z915 - c_q4 * z918;
    const Scalar z929 = z919 - z923;
    const Scalar z930 = z902 - z927;
    const Scalar z931 = z867 - z928;
    const Scalar z932 = s_q3 * z902 - c_q3 * z920;
    const Scalar z933 = s_q3 * z922 - c_q3 * z867;
    const Scalar z934 = s_q3 * z867 + c_q3 * z922;
    const Scalar z935 = c_q3 * z902 + s_q3 * z920;
    const Scalar z936 = s_q3 * z929 - c_q3 * z925;
    const Scalar z937 = s_q3 * z924 + c_q3 * z926;
    const Scalar z938 = c_q3 * z929 + s_q3 * z925;
    const Scalar z939 = s_q3 * z926 - c_q3 * z924;
    const Scalar z940 = n632_over_165 * z935 - z936;
    const Scalar z941 = n632_over_165 * z933 - z937;
    const Scalar z942 = n632_over_165 * z932 + z938;
    const Scalar z943 = n632_over_165 * z934 + z939;
    const Scalar z944 = c_q2 * z930 + s_q2 * z940;
    const Scalar z945 = s_q2 * z941 - c_q2 * z931;
    const Scalar z946 = z54 * z520 - k6 * z486 + z57 * z523 + k4 * z336 + k2 * z318 - k3 * z315 - k5 * z335;
    const Scalar z947 = z3 * z526 + z527;
    const Scalar z948 = z561 + z18 * z492 - z20 * z491;
    const Scalar z949 = z33 * z491 - z538 + z20 * z492;
    const Scalar z950 = z5 * z491 - z568;
    const Scalar z951 = z5 * z492 + z566;
    const Scalar z952 = z19 * z492 - k13 * z491;
    const Scalar z953 = z547 + z4 * z491 + z13 * z492;
    const Scalar z954 = z54 * z531 - z333 - k2 * z486;
    const Scalar z955 = z521 + z522;
    const Scalar z956 = z5 * z533 + z955;
    const Scalar z957 = z504 + z505 - z955;
    const Scalar z958 = z522 - z558;
    const Scalar z959 = z521 - z558;
    const Scalar z960 = s_q6 * z950 - c_q6 * z951;
    const Scalar z961 = z13 * z344 - z870 - z6 * z487 - z4 * z327 + z42 * z956 - z43 * z947;
    const Scalar z962 = z57 * z531 + z334 + k3 * z486;
    const Scalar z963 = s_q6 * z951 + c_q6 * z950;
    const Scalar z964 = z54 * z511 - z57 * z515 + k3 * z336 - k2 * z335;
    const Scalar z965 = s_q6 * z956 - c_q6 * z947;
    const Scalar z966 = z29 * z484 + z6 * z364 + z28 * z367 - z3 * z280 - z14 * z281 + z31 * z547 - z32 * z965;
    const Scalar z967 = c_q6 * z956 + s_q6 * z947;
    const Scalar z968 = z967 + z6 * z493 - z28 * z494;
    const Scalar z969 = z967 + z23 * z598 + z22 * z596;
    const Scalar z970 = s_q5 * z547 - c_q5 * z965;
    const Scalar z971 = c_q5 * z547 + s_q5 * z965;
    const Scalar z972 = z970 + z15 * z596 - z23 * z490;
    const Scalar z973 = z971 + z22 * z490 + z15 * z598;
    const Scalar z974 = s_q6 * z948 - c_q6 * z949;
    const Scalar z975 = z54 * z518 - k5 * z486 - z57 * z958 - k8 * z336 - k0 * z335 - z428;
    const Scalar z976 = z51 * z442 + z40 * z356 - z15 * z272 - z22 * z273 - z52 * z323 + z10 * z969 + z11 * z972;
    const Scalar z977 = z40 * z446 - z973 + z52 * z447;
    const Scalar z978 = c_q6 * z948 + s_q6 * z949;
    const Scalar z979 = k4 * z486 - z57 * z519 + z54 * z959 - k8 * z335 - z427;
    const Scalar z980 = z35 * z461 + z973;
    const Scalar z981 = s_q4 * z969 - c_q4 * z972;
    const Scalar z982 = c_q4 * z969 + s_q4 * z972;
    const Scalar z983 = z35 * z445 - z982;
    const Scalar z984 = z981 + z23 * z461 - z36 * z445;
    const Scalar z985 = s_q5 * z952 + c_q5 * z960;
    const Scalar z986 = s_q5 * z960 - c_q5 * z952;
    const Scalar z987 = z983 + z78 * z461 - z76 * z460;
    const Scalar z988 = z23 * z256 + z35 * z257 - z76 * z372 - z78 * z324 + z68 * z444 + z7 * z980 - z8 * z984;
    const Scalar z989 = z983 + z47 * z676 - z48 * z674;
    const Scalar z990 = s_q7 * z954 - c_q7 * z962;
    const Scalar z991 = s_q7 * z962 + c_q7 * z954;
    const Scalar z992 = s_q5 * z974 + c_q5 * z881;
    const Scalar z993 = s_q5 * z881 - c_q5 * z974;
    const Scalar z994 = z963 - n256_over_55 * z985 - z992;
    const Scalar z995 = n256_over_55 * z986 + z993;
    const Scalar z996 = s_q7 * z975 - c_q7 * z979;
    const Scalar z997 = c_q7 * z975 + s_q7 * z979;
    const Scalar z998 = z946 + n16_over_15 * z990;
    const Scalar z999 = c_q3 * z980 + s_q3 * z984;
    const Scalar z1000 = s_q3 * z980 - c_q3 * z984;
    const Scalar z1001 = z36 * z674 + z999;
    const Scalar z1002 = z36 * z676 + z1000;
    const Scalar z1003 = z978 + z986;
    const Scalar z1004 = z68 * z475 - z1001 + z88 * z479;
    const Scalar z1005 = z88 * z395 - z36 * z178 - z47 * z179 - z68 * z401 - z94 * z443 + z0 * z989 - z1 * z1002;
    const Scalar z1006 = c_q2 * z989 + s_q2 * z1002;
    const Scalar z1007 = n16_over_15 * z964 + z996;
    const Scalar z1008 = s_q6 * z964 + c_q6 * z991;
    const Scalar z1009 = s_q4 * z985 - c_q4 * z963;
    const Scalar z1010 = s_q4 * z963 + c_q4 * z985;
    const Scalar z1011 = s_q6 * z991 - c_q6 * z964;
    const Scalar z1012 = z994 + z1009;
    const Scalar z1013 = s_q6 * z998 - c_q6 * z997;
    const Scalar z1014 = s_q4 * z1003 - c_q4 * z995;
    const Scalar z1015 = s_q6 * z997 + c_q6 * z998;
    const Scalar z1016 = c_q4 * z1003 + s_q4 * z995;
    const Scalar z1017 = z986 - z1016;
    const Scalar z1018 = s_q5 * z990 + c_q5 * z1008;
    const Scalar z1019 = s_q5 * z1008 - c_q5 * z990;
    const Scalar z1020 = s_q5 * z1007 - c_q5 * z1013;
    const Scalar z1021 = c_q3 * z986 + s_q3 * z1010;
    const Scalar z1022 = s_q3 * z986 - c_q3 * z1010;
    const Scalar z1023 = c_q5 * z1007 + s_q5 * z1013;
    const Scalar z1024 = n256_over_55 * z1019 + z1020;
    const Scalar z1025 = s_q3 * z1012 + c_q3 * z1014;
    const Scalar z1026 = s_q3 * z1014 - c_q3 * z1012;
    const Scalar z1027 = n632_over_165 * z1021 - z1025;
    const Scalar z1028 = n632_over_165 * z1022 - z1026;
    const Scalar z1029 = z1011 + n256_over_55 * z1018 + z1023;
    const Scalar z1030 = c_q2 * z1017 + s_q2 * z1027;
    const Scalar z1031 = k0 * z503 - z517 + z530;
    const Scalar z1032 = u_tau1 - z513;
    const Scalar z1033 = u_tau2 - z509;
    const Scalar z1034 = u_tau3 + z468;
    const Scalar z1035 = u_tau4 - z463;
    const Scalar z1036 = u_tau5 + z456;
    const Scalar z1037 = u_tau6 - z451;
    const Scalar z1038 = u_tau7 - z337;
    const Scalar z1039 = k8 * z503 - z529;
    const Scalar z1040 = k3 * z502 + k2 * z503;
    const Scalar z1041 = z325 * z1006 - z910;
    const Scalar z1042 = z331 * z1006 - z831 - z369 * z1041;
    const Scalar z1043 = s_q7 * z1039 + c_q7 * z1031;
    const Scalar z1044 = s_q7 * z1031 - c_q7 * z1039;
    const Scalar z1045 = n16_over_15 * z1040 + z1044;
    const Scalar z1046 = z357 * z1006 - z371 * z1041 - z419 * z1042 + z762;
    const Scalar z1047 = n16_over_15 * z541 - z957;
    const Scalar z1048 = s_q6 * z1040 - c_q6 * z548;
    const Scalar z1049 = c_q6 * z1040 + s_q6 * z548;
    const Scalar z1050 = z380 * z1006 - z388 * z1041 - z420 * z1042 - z470 * z1046 + z740;
    const Scalar z1051 = c_q6 * z1043 + s_q6 * z1047;
    const Scalar z1052 = s_q6 * z1043 - c_q6 * z1047;
    const Scalar z1053 = z405 * z1006 - z415 * z1041 - z421 * z1042 - z480 * z1046 - z495 * z1050 - z713;
    const Scalar z1054 = z422 * z1006 - z424 * z1041 - z425 * z1042 - z483 * z1046 - z498 * z1050 - z510 * z1053 - z755;
    const Scalar z1055 = s_q5 * z541 - c_q5 * z1048;
    const Scalar z1056 = c_q5 * z541 + s_q5 * z1048;
    const Scalar z1057 = z516 * z1054;
    const Scalar z1058 = z1015 + z1019;
    const Scalar z1059 = z501 * z1053 - z510 * z1057;
    const Scalar z1060 = c_q4 * z1011 + s_q4 * z1018;
    const Scalar z1061 = s_q4 * z1011 - c_q4 * z1018;
    const Scalar z1062 = z1029 - z1060;
    const Scalar z1063 = z476 * z1050 - z498 * z1057 - z495 * z1059;
    const Scalar z1064 = s_q5 * z1051 - c_q5 * z1045;
    const Scalar z1065 = s_q5 * z1045 + c_q5 * z1051;
    const Scalar z1066 = z1049 + n256_over_55 * z1055 + z1064;
    const Scalar z1067 = n256_over_55 * z1056 + z1065;
    const Scalar z1068 = z434 * z1046 - z483 * z1057 - z480 * z1059 - z470 * z1063;
    const Scalar z1069 = z404 * z1042 - z425 * z1057 - z421 * z1059 - z420 * z1063 - z419 * z1068;
    const Scalar z1070 = z1052 + z1056;
    const Scalar z1071 = c_q4 * z1049 + s_q4 * z1055;
    const Scalar z1072 = s_q4 * z1049 - c_q4 * z1055;
    const Scalar z1073 = z1066 - z1071;
    const Scalar z1074 = s_q4 * z1058 - c_q4 * z1024;
    const Scalar z1075 = c_q4 * z1058 + s_q4 * z1024;
    const Scalar z1076 = z325 * z1005 + z908;
    const Scalar z1077 = z1019 - z1075;
    const Scalar z1078 = z331 * z1005 - z829 - z369 * z1076;
    const Scalar z1079 = z353 * z1041 - z424 * z1057 - z415 * z1059 - z388 * z1063 - z371 * z1068 - z369 * z1069;
    const Scalar z1080 = z422 * z1057 - k52 * z1006 + z405 * z1059 + z380 * z1063 + z357 * z1068 + z331 * z1069 + z325
        * z1079;
    const Scalar z1081 = s_q4 * z1070 - c_q4 * z1067;
    const Scalar z1082 = c_q4 * z1070 + s_q4 * z1067;
    const Scalar z1083 = z1056 - z1082;
    const Scalar z1084 = s_q3 * z1061 - c_q3 * z1019;
    const Scalar z1085 = s_q3 * z1019 + c_q3 * z1061;
    const Scalar z1086 = z357 * z1005 - z371 * z1076 - z419 * z1078 - z760;
    const Scalar z1087 = z380 * z1005 - z388 * z1076 - z420 * z1078 - z470 * z1086 - z739;
    const Scalar z1088 = s_q3 * z1062 - c_q3 * z1074;
    const Scalar z1089 = n632_over_165 * z1084 - z1088;
    const Scalar z1090 = c_q3 * z1062 + s_q3 * z1074;
    const Scalar z1091 = n632_over_165 * z1085 - z1090;
    const Scalar z1092 = z405 * z1005 - z415 * z1076 - z421 * z1078 - z480 * z1086 - z495 * z1087 - z712;
    const Scalar z1093 = s_q2 * z1089 - c_q2 * z1077;
    const Scalar z1094 = z325 * z1004 + z909;
    const Scalar z1095 = z325 * z988 - z897;
    const Scalar z1096 = z331 * z1004 - z830 - z369 * z1094;
    const Scalar z1097 = z331 * z988 - z818 - z369 * z1095;
    const Scalar z1098 = z761 + z357 * z1004 - z371 * z1094 - z419 * z1096;
    const Scalar z1099 = z357 * z988 - z745 - z371 * z1095 - z419 * z1097;
    const Scalar z1100 = z380 * z1004 - z388 * z1094 - z420 * z1096 - z719 - z470 * z1098;
    const Scalar z1101 = z380 * z988 - z388 * z1095 - z420 * z1097 - z470 * z1099 + z688;
    const Scalar z1102 = z405 * z1004 - z415 * z1094 - z421 * z1096 - z480 * z1098 - z495 * z1100 + z748;
    const Scalar z1103 = z405 * z988 - z415 * z1095 - z421 * z1097 - z480 * z1099 - z781 - z495 * z1101;
    const Scalar z1104 = z422 * z1005 - z730 - z424 * z1076 - z425 * z1078 - z483 * z1086 - z498 * z1087 - z510 * z1092;
    const Scalar z1105 = z422 * z1004 - z424 * z1094 - z425 * z1096 - z483 * z1098 - z498 * z1100 - z510 * z1102 - z721;
    const Scalar z1106 = z422 * z988 - z424 * z1095 - z425 * z1097 - z483 * z1099 - z498 * z1101 - z510 * z1103 + z787;
    const Scalar z1107 = z516 * z1104;
    const Scalar z1108 = z516 * z1105;
    const Scalar z1109 = z516 * z1106;
    const Scalar z1110 = z501 * z1092 - z510 * z1107;
    const Scalar z1111 = z501 * z1102 - z510 * z1108;
    const Scalar z1112 = z476 * z1087 - z498 * z1107 - z495 * z1110;
    const Scalar z1113 = z476 * z1100 - z498 * z1108 - z495 * z1111;
    const Scalar z1114 = z434 * z1086 - z483 * z1107 - z480 * z1110 - z470 * z1112;
    const Scalar z1115 = z434 * z1098 - z483 * z1108 - z480 * z1111 - z470 * z1113;
    const Scalar z1116 = z404 * z1078 - z425 * z1107 - z421 * z1110 - z420 * z1112 - z419 * z1114;
    const Scalar z1117 = z404 * z1096 - z425 * z1108 - z421 * z1111 - z420 * z1113 - z419 * z1115;
    const Scalar z1118 = z353 * z1076 - z424 * z1107 - z415 * z1110 - z388 * z1112 - z371 * z1114 - z369 * z1116;
    const Scalar z1119 = z422 * z1107 - k52 * z1005 + z405 * z1110 + z380 * z1112 + z357 * z1114 + z331 * z1116 + z325
        * z1118;
    const Scalar z1120 = z353 * z1094 - z424 * z1108 - z415 * z1111 - z388 * z1113 - z371 * z1115 - z369 * z1117;
    const Scalar z1121 = z422 * z1108 - k52 * z1004 + z405 * z1111 + z380 * z1113 + z357 * z1115 + z331 * z1117 + z325
        * z1120;
    const Scalar z1122 = c_q3 * z1056 + s_q3 * z1072;
    const Scalar z1123 = s_q3 * z1056 - c_q3 * z1072;
    const Scalar z1124 = z501 * z1103 - z510 * z1109;
    const Scalar z1125 = z476 * z1101 - z498 * z1109 - z495 * z1124;
    const Scalar z1126 = s_q3 * z1073 + c_q3 * z1081;
    const Scalar z1127 = s_q3 * z1081 - c_q3 * z1073;
    const Scalar z1128 = n632_over_165 * z1122 - z1126;
    const Scalar z1129 = n632_over_165 * z1123 - z1127;
    const Scalar z1130 = z434 * z1099 - z483 * z1109 - z480 * z1124 - z470 * z1125;
    const Scalar z1131 = c_q2 * z1083 + s_q2 * z1128;
    const Scalar z1132 = z325 * z987 - z898;
    const Scalar z1133 = z325 * z976 - z887;
    const Scalar z1134 = z325 * z977 + z888;
    const Scalar z1135 = z331 * z987 - z819 - z369 * z1132;
    const Scalar z1136 = z331 * z976 - z806 - z369 * z1133;
    const Scalar z1137 = z331 * z977 - z807 - z369 * z1134;
    const Scalar z1138 = z325 * z966 - z876;
    const Scalar z1139 = z325 * z968 - z873;
    const Scalar z1140 = z797 + z331 * z966 - z369 * z1138;
    const Scalar z1141 = z331 * z968 - z804 - z369 * z1139;
    const Scalar z1142 = z357 * z987 - z371 * z1132 - z419 * z1135 + z746;
    const Scalar z1143 = z357 * z976 - z371 * z1133 - z419 * z1136 + z717;
    const Scalar z1144 = z357 * z977 - z371 * z1134 - z419 * z1137 - z741;
    const Scalar z1145 = z357 * z966 - z835 - z371 * z1138 - z419 * z1140;
    const Scalar z1146 = z916 + z357 * z968 - z371 * z1139 - z419 * z1141;
    const Scalar z1147 = z380 * z987 - z388 * z1132 - z420 * z1135 - z470 * z1142 + z737;
    const Scalar z1148 = z380 * z976 - z388 * z1133 - z420 * z1136 - z470 * z1143 - z786;
    const Scalar z1149 = z380 * z977 - z388 * z1134 - z420 * z1137 - z470 * z1144 - z790;
    const Scalar z1150 = z380 * z966 - z388 * z1138 - z420 * z1140 + z850 - z470 * z1145;
    const Scalar z1151 = z380 * z968 - z388 * z1139 - z420 * z1141 + z931 - z470 * z1146;
    const Scalar z1152 = z405 * z987 - z415 * z1132 - z421 * z1135 - z480 * z1142 - z495 * z1147 - z798;
    const Scalar z1153 = z405 * z976 - z415 * z1133 - z421 * z1136 - z480 * z1143 - z495 * z1148 - z840;
    const Scalar z1154 = z405 * z977 - z415 * z1134 - z421 * z1137 - z480 * z1144 - z495 * z1149 - z865;
    const Scalar z1155 = z405 * z966 - z415 * z1138 - z421 * z1140 - z480 * z1145 - z495 * z1150 + z856;
    const Scalar z1156 = z405 * z968 - z415 * z1139 - z421 * z1141 - z480 * z1146 + z943 - z495 * z1151;
    const Scalar z1157 = z422 * z987 - z424 * z1132 - z425 * z1135 - z483 * z1142 - z498 * z1147 - z510 * z1152 + z801;
    const Scalar z1158 = z422 * z976 - z424 * z1133 - z425 * z1136 - z483 * z1143 - z498 * z1148 - z510 * z1153 - z843;
    const Scalar z1159 = z422 * z977 - z424 * z1134 - z425 * z1137 - z483 * z1144 - z498 * z1149 - z510 * z1154 - z868;
    const Scalar z1160 = z422 * z966 - z861 - z424 * z1138 - z425 * z1140 - z483 * z1145 - z498 * z1150 - z510 * z1155;
    const Scalar z1161 = z516 * z1157;
    const Scalar z1162 = z516 * z1158;
    const Scalar z1163 = z516 * z1159;
    const Scalar z1164 = z516 * z1160;
    const Scalar z1165 = z501 * z1152 - z510 * z1161;
    const Scalar z1166 = z501 * z1153 - z510 * z1162;
    const Scalar z1167 = z501 * z1154 - z510 * z1163;
    const Scalar z1168 = z501 * z1155 - z510 * z1164;
    const Scalar z1169 = z476 * z1147 - z498 * z1161 - z495 * z1165;
    const Scalar z1170 = z476 * z1148 - z498 * z1162 - z495 * z1166;
    const Scalar z1171 = z476 * z1149 - z498 * z1163 - z495 * z1167;
    const Scalar z1172 = z476 * z1150 - z498 * z1164 - z495 * z1168;
    const Scalar z1173 = z434 * z1142 - z483 * z1161 - z480 * z1165 - z470 * z1169;
    const Scalar z1174 = z434 * z1143 - z483 * z1162 - z480 * z1166 - z470 * z1170;
    const Scalar z1175 = z434 * z1144 - z483 * z1163 - z480 * z1167 - z470 * z1171;
    const Scalar z1176 = z434 * z1145 - z483 * z1164 - z480 * z1168 - z470 * z1172;
    const Scalar z1177 = z404 * z1097 - z425 * z1109 - z421 * z1124 - z420 * z1125 - z419 * z1130;
    const Scalar z1178 = z422 * z968 - z424 * z1139 - z425 * z1141 - z483 * z1146 - z498 * z1151 + z945 - z510 * z1156;
    const Scalar z1179 = z404 * z1135 - z425 * z1161 - z421 * z1165 - z420 * z1169 - z419 * z1173;
    const Scalar z1180 = z404 * z1136 - z425 * z1162 - z421 * z1166 - z420 * z1170 - z419 * z1174;
    const Scalar z1181 = z404 * z1137 - z425 * z1163 - z421 * z1167 - z420 * z1171 - z419 * z1175;
    const Scalar z1182 = z404 * z1140 - z425 * z1164 - z421 * z1168 - z420 * z1172 - z419 * z1176;
    const Scalar z1183 = z353 * z1095 - z424 * z1109 - z415 * z1124 - z388 * z1125 - z371 * z1130 - z369 * z1177;
    const Scalar z1184 = z422 * z1109 - k52 * z988 + z405 * z1124 + z380 * z1125 + z357 * z1130 + z331 * z1177 + z325
        * z1183;
    const Scalar z1185 = z325 * z961 - z869;
    const Scalar z1186 = z331 * z961 - z900 - z369 * z1185;
    const Scalar z1187 = z516 * z1178;
    const Scalar z1188 = z501 * z1156 - z510 * z1187;
    const Scalar z1189 = z357 * z961 - z919 - z371 * z1185 - z419 * z1186;
    const Scalar z1190 = z476 * z1151 - z498 * z1187 - z495 * z1188;
    const Scalar z1191 = z380 * z961 - z388 * z1185 - z420 * z1186 + z930 - z470 * z1189;
    const Scalar z1192 = z434 * z1146 - z483 * z1187 - z480 * z1188 - z470 * z1190;
    const Scalar z1193 = z942 + z405 * z961 - z415 * z1185 - z421 * z1186 - z480 * z1189 - z495 * z1191;
    const Scalar z1194 = z422 * z961 - z944 - z424 * z1185 - z425 * z1186 - z483 * z1189 - z498 * z1191 - z510 * z1193;
    const Scalar z1195 = z404 * z1141 - z425 * z1187 - z421 * z1188 - z420 * z1190 - z419 * z1192;
    const Scalar z1196 = z353 * z1132 - z424 * z1161 - z415 * z1165 - z388 * z1169 - z371 * z1173 - z369 * z1179;
    const Scalar z1197 = z422 * z1161 - k52 * z987 + z405 * z1165 + z380 * z1169 + z357 * z1173 + z331 * z1179 + z325
        * z1196;
    const Scalar z1198 = z325 * z953 - z881;
    const Scalar z1199 = z331 * z953 + z978 - z369 * z1198;
    const Scalar z1200 = z516 * z1194;
    const Scalar z1201 = z501 * z1193 - z510 * z1200;
    const Scalar z1202 = z357 * z953 - z994 - z371 * z1198 - z419 * z1199;
    const Scalar z1203 = z476 * z1191 - z498 * z1200 - z495 * z1201;
    const Scalar z1204 = z380 * z953 - z388 * z1198 - z420 * z1199 + z1017 - z470 * z1202;
    const Scalar z1205 = z434 * z1189 - z483 * z1200 - z480 * z1201 - z470 * z1203;
    const Scalar z1206 = z1028 + z405 * z953 - z415 * z1198 - z421 * z1199 - z480 * z1202 - z495 * z1204;
    const Scalar z1207 = z422 * z953 - z1030 - z424 * z1198 - z425 * z1199 - z483 * z1202 - z498 * z1204 - z510 * z1206;
    const Scalar z1208 = z404 * z1186 - z425 * z1200 - z421 * z1201 - z420 * z1203 - z419 * z1205;
    const Scalar z1209 = z353 * z1133 - z424 * z1162 - z415 * z1166 - z388 * z1170 - z371 * z1174 - z369 * z1180;
    const Scalar z1210 = z422 * z1162 - k52 * z976 + z405 * z1166 + z380 * z1170 + z357 * z1174 + z331 * z1180 + z325
        * z1209;
    const Scalar z1211 = z325 * z946 - z1007;
    const Scalar z1212 = z331 * z946 + z1015 - z369 * z1211;
    const Scalar z1213 = z516 * z1207;
    const Scalar z1214 = z501 * z1206 - z510 * z1213;
    const Scalar z1215 = z1029 + z357 * z946 - z371 * z1211 - z419 * z1212;
    const Scalar z1216 = z476 * z1204 - z498 * z1213 - z495 * z1214;
    const Scalar z1217 = z380 * z946 - z388 * z1211 - z420 * z1212 + z1077 - z470 * z1215;
    const Scalar z1218 = z434 * z1202 - z483 * z1213 - z480 * z1214 - z470 * z1216;
    const Scalar z1219 = z1091 + z405 * z946 - z415 * z1211 - z421 * z1212 - z480 * z1215 - z495 * z1217;
    const Scalar z1220 = z1093 + z422 * z946 - z424 * z1211 - z425 * z1212 - z483 * z1215 - z498 * z1217 - z510 * z1219;
    const Scalar z1221 = z404 * z1199 - z425 * z1213 - z421 * z1214 - z420 * z1216 - z419 * z1218;
    const Scalar z1222 = z353 * z1134 - z424 * z1163 - z415 * z1167 - z388 * z1171 - z371 * z1175 - z369 * z1181;
    const Scalar z1223 = z422 * z1163 - k52 * z977 + z405 * z1167 + z380 * z1171 + z357 * z1175 + z331 * z1181 + z325
        * z1222;
    const Scalar z1224 = z325 * z957 - z1045;
    const Scalar z1225 = z331 * z957 + z1052 - z369 * z1224;
    const Scalar z1226 = z516 * z1220;
    const Scalar z1227 = z501 * z1219 - z510 * z1226;
    const Scalar z1228 = z357 * z957 - z1066 - z371 * z1224 - z419 * z1225;
    const Scalar z1229 = z476 * z1217 - z498 * z1226 - z495 * z1227;
    const Scalar z1230 = z1083 + z380 * z957 - z388 * z1224 - z420 * z1225 - z470 * z1228;
    const Scalar z1231 = z1129 + z405 * z957 - z415 * z1224 - z421 * z1225 - z480 * z1228 - z495 * z1230;
    const Scalar z1232 = z422 * z957 - z1131 - z424 * z1224 - z425 * z1225 - z483 * z1228 - z498 * z1230 - z510 * z1231;
    const Scalar z1233 = z434 * z1215 - z483 * z1226 - z480 * z1227 - z470 * z1229;
    const Scalar z1234 = z404 * z1212 - z425 * z1226 - z421 * z1227 - z420 * z1229 - z419 * z1233;
    const Scalar z1235 = z353 * z1138 - z424 * z1164 - z415 * z1168 - z388 * z1172 - z371 * z1176 - z369 * z1182;
    const Scalar z1236 = z422 * z1164 - k52 * z966 + z405 * z1168 + z380 * z1172 + z357 * z1176 + z331 * z1182 + z325
        * z1235;
    const Scalar z1237 = z516 * z1232;
    const Scalar z1238 = z501 * z1231 - z510 * z1237;
    const Scalar z1239 = z353 * z1139 - z424 * z1187 - z415 * z1188 - z388 * z1190 - z371 * z1192 - z369 * z1195;
    const Scalar z1240 = z422 * z1187 - k52 * z968 + z405 * z1188 + z380 * z1190 + z357 * z1192 + z331 * z1195 + z325
        * z1239;
    const Scalar z1241 = z476 * z1230 - z498 * z1237 - z495 * z1238;
    const Scalar z1242 = z434 * z1228 - z483 * z1237 - z480 * z1238 - z470 * z1241;
    const Scalar z1243 = z353 * z1185 - z424 * z1200 - z415 * z1201 - z388 * z1203 - z371 * z1205 - z369 * z1208;
    const Scalar z1244 = z422 * z1200 - k52 * z961 + z405 * z1201 + z380 * z1203 + z357 * z1205 + z331 * z1208 + z325
        * z1243;
    const Scalar z1245 = z404 * z1225 - z425 * z1237 - z421 * z1238 - z420 * z1241 - z419 * z1242;
    const Scalar z1246 = z353 * z1198 - z424 * z1213 - z415 * z1214 - z388 * z1216 - z371 * z1218 - z369 * z1221;
    const Scalar z1247 = z422 * z1213 - k52 * z953 + z405 * z1214 + z380 * z1216 + z357 * z1218 + z331 * z1221 + z325
        * z1246;
    const Scalar z1248 = z353 * z1211 - z424 * z1226 - z415 * z1227 - z388 * z1229 - z371 * z1233 - z369 * z1234;
    const Scalar z1249 = z422 * z1226 - k52 * z946 + z405 * z1227 + z380 * z1229 + z357 * z1233 + z331 * z1234 + z325
        * z1248;
    const Scalar z1250 = z353 * z1224 - z424 * z1237 - z415 * z1238 - z388 * z1241 - z371 * z1242 - z369 * z1245;
    const Scalar z1251 = z422 * z1237 - k52 * z957 + z405 * z1238 + z380 * z1241 + z357 * z1242 + z331 * z1245 + z325
        * z1250;
    const Scalar z1252 = z331 - z325 * z369;
    const Scalar z1253 = z371 - z369 * z419;
    const Scalar z1254 = z357 - z325 * z371 - z419 * z1252;
    const Scalar z1255 = z420 - z419 * z470;
    const Scalar z1256 = z388 - z369 * z420 - z470 * z1253;
    const Scalar z1257 = z380 - z325 * z388 - z420 * z1252 - z470 * z1254;
    const Scalar z1258 = z480 - z470 * z495;
    const Scalar z1259 = z421 - z419 * z480 - z495 * z1255;
    const Scalar z1260 = z415 - z369 * z421 - z480 * z1253 - z495 * z1256;
    const Scalar z1261 = z405 - z325 * z415 - z421 * z1252 - z480 * z1254 - z495 * z1257;
    const Scalar z1262 = z498 - z495 * z510;
    const Scalar z1263 = z516 * z1262;
    const Scalar z1264 = z483 - z470 * z498 - z510 * z1258;
    const Scalar z1265 = z516 * z1264;
    const Scalar z1266 = z425 - z419 * z483 - z498 * z1255 - z510 * z1259;
    const Scalar z1267 = z516 * z1266;
    const Scalar z1268 = z501 * z1258 - z510 * z1265;
    const Scalar z1269 = z424 - z369 * z425 - z483 * z1253 - z498 * z1256 - z510 * z1260;
    const Scalar z1270 = z516 * z1269;
    const Scalar z1271 = z501 * z1259 - z510 * z1267;
    const Scalar z1272 = z476 * z1255 - z498 * z1267 - z495 * z1271;
    const Scalar z1273 = z501 * z1260 - z510 * z1270;
    const Scalar z1274 = z422 - z325 * z424 - z425 * z1252 - z483 * z1254 - z498 * z1257 - z510 * z1261;
    const Scalar z1275 = z516 * z1274;
    const Scalar z1276 = z476 * z1256 - z498 * z1270 - z495 * z1273;
    const Scalar z1277 = z501 * z1261 - z510 * z1275;
    const Scalar z1278 = z434 * z1253 - z483 * z1270 - z480 * z1273 - z470 * z1276;
    const Scalar z1279 = z476 * z1257 - z498 * z1275 - z495 * z1277;
    const Scalar z1280 = z510 * z516;
    const Scalar z1281 = z434 * z1254 - z483 * z1275 - z480 * z1277 - z470 * z1279;
    const Scalar z1282 = z501 + z510 * z1280;
    const Scalar z1283 = z495 * z501 - z510 * z1263;
    const Scalar z1284 = z404 * z1252 - z425 * z1275 - z421 * z1277 - z420 * z1279 - z419 * z1281;
    const Scalar z1285 = z498 * z516 - z495 * z1280;
    const Scalar z1286 = z498 * z1280 - z495 * z1282;
    const Scalar z1287 = z476 + z498 * z1263 + z495 * z1283;
    const Scalar z1288 = z470 * z476 - z498 * z1265 - z495 * z1268;
    const Scalar z1289 = z483 * z516 - z480 * z1280 - z470 * z1285;
    const Scalar z1290 = z483 * z1280 - z480 * z1282 - z470 * z1286;
    const Scalar z1291 = z483 * z1263 + z480 * z1283 - z470 * z1287;
    const Scalar z1292 = z434 + z483 * z1265 + z480 * z1268 + z470 * z1288;
    const Scalar z1293 = z419 * z434 - z483 * z1267 - z480 * z1271 - z470 * z1272;
    const Scalar z1294 = z425 * z516 - z421 * z1280 - z420 * z1285 - z419 * z1289;
    const Scalar z1295 = z425 * z1280 - z421 * z1282 - z420 * z1286 - z419 * z1290;
    const Scalar z1296 = z425 * z1263 + z421 * z1283 - z420 * z1287 - z419 * z1291;
    const Scalar z1297 = z425 * z1265 + z421 * z1268 + z420 * z1288 - z419 * z1292;
    const Scalar z1298 = z404 + z425 * z1267 + z421 * z1271 + z420 * z1272 + z419 * z1293;
    const Scalar z1299 = z369 * z404 - z425 * z1270 - z421 * z1273 - z420 * z1276 - z419 * z1278;
    const Scalar z1300 = z424 * z516 - z415 * z1280 - z388 * z1285 - z371 * z1289 - z369 * z1294;
    const Scalar z1301 = z422 * z516 - z405 * z1280 - z380 * z1285 - z357 * z1289 - z331 * z1294 - z325 * z1300;
    const Scalar z1302 = z424 * z1280 - z415 * z1282 - z388 * z1286 - z371 * z1290 - z369 * z1295;
    const Scalar z1303 = z422 * z1280 - z405 * z1282 - z380 * z1286 - z357 * z1290 - z331 * z1295 - z325 * z1302;
    const Scalar z1304 = z424 * z1263 + z415 * z1283 - z388 * z1287 - z371 * z1291 - z369 * z1296;
    const Scalar z1305 = z422 * z1263 + z405 * z1283 - z380 * z1287 - z357 * z1291 - z331 * z1296 - z325 * z1304;
    const Scalar z1306 = z424 * z1265 + z415 * z1268 + z388 * z1288 - z371 * z1292 - z369 * z1297;
    const Scalar z1307 = z422 * z1265 + z405 * z1268 + z380 * z1288 - z357 * z1292 - z331 * z1297 - z325 * z1306;
    const Scalar z1308 = z424 * z1267 + z415 * z1271 + z388 * z1272 + z371 * z1293 - z369 * z1298;
    const Scalar z1309 = z422 * z1267 + z405 * z1271 + z380 * z1272 + z357 * z1293 - z331 * z1298 - z325 * z1308;
    const Scalar z1310 = z353 + z424 * z1270 + z415 * z1273 + z388 * z1276 + z371 * z1278 + z369 * z1299;
    const Scalar z1311 = z422 * z1270 + z405 * z1273 + z380 * z1276 + z357 * z1278 + z331 * z1299 - z325 * z1310;
    const Scalar z1312 = z325 * z353 - z424 * z1275 - z415 * z1277 - z388 * z1279 - z371 * z1281 - z369 * z1284;
    const Scalar z1313 = k52 - z422 * z1275 - z405 * z1277 - z380 * z1279 - z357 * z1281 - z331 * z1284 - z325 * z1312;
    result.M[0] = z239;
    result.M[1] = -z238;
    result.M[2] = -z225;
    result.M[3] = z195;
    result.M[4] = z173;
    result.M[5] = -z140;
    result.M[6] = z103;
    result.M[7] = -z238;
    result.M[8] = z197;
    result.M[9] = -z169;
    result.M[10] = z155;
    result.M[11] = z138;
    result.M[12] = z99;
    result.M[13] = z94;
    result.M[14] = -z225;
    result.M[15] = -z169;
    result.M[16] = z164;
    result.M[17] = z129;
    result.M[18] = -z115;
    result.M[19] = -z80;
    result.M[20] = -z68;
    result.M[21] = z195;
    result.M[22] = z155;
    result.M[23] = z129;
    result.M[24] = z130;
    result.M[25] = -z93;
    result.M[26] = -z56;
    result.M[27] = z51;
    result.M[28] = z173;
    result.M[29] = z138;
    result.M[30] = -z115;
    result.M[31] = -z93;
    result.M[32] = z79;
    result.M[33] = -z50;
    result.M[34] = z29;
    result.M[35] = -z140;
    result.M[36] = z99;
    result.M[37] = -z80;
    result.M[38] = -z56;
    result.M[39] = -z50;
    result.M[40] = z37;
    result.M[41] = -z6;
    result.M[42] = z103;
    result.M[43] = z94;
    result.M[44] = -z68;
    result.M[45] = z51;
    result.M[46] = z29;
    result.M[47] = -z6;
    result.M[48] = k6;
    result.C[0] = -z755;
    result.C[1] = -z713;
    result.C[2] = -z740;
    result.C[3] = z762;
    result.C[4] = -z831;
    result.C[5] = z910;
    result.C[6] = -z1006;
    result.C[7] = z721;
    result.C[8] = -z748;
    result.C[9] = -z719;
    result.C[10] = -z761;
    result.C[11] = z830;
    result.C[12] = z909;
    result.C[13] = z1004;
    result.C[14] = z801;
    result.C[15] = -z798;
    result.C[16] = -z737;
    result.C[17] = z746;
    result.C[18] = -z819;
    result.C[19] = z898;
    result.C[20] = -z987;
    result.C[21] = -z868;
    result.C[22] = -z865;
    result.C[23] = z790;
    result.C[24] = -z741;
    result.C[25] = -z807;
    result.C[26] = -z888;
    result.C[27] = -z977;
    result.C[28] = -z945;
    result.C[29] = -z943;
    result.C[30] = z931;
    result.C[31] = -z916;
    result.C[32] = z804;
    result.C[33] = -z873;
    result.C[34] = z968;
    result.C[35] = z1030;
    result.C[36] = -z1028;
    result.C[37] = z1017;
    result.C[38] = z994;
    result.C[39] = -z978;
    result.C[40] = -z881;
    result.C[41] = z953;
    result.C[42] = z1131;
    result.C[43] = -z1129;
    result.C[44] = z1083;
    result.C[45] = z1066;
    result.C[46] = -z1052;
    result.C[47] = -z1045;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z730;
    result.K[8] = z712;
    result.K[9] = -z739;
    result.K[10] = z760;
    result.K[11] = z829;
    result.K[12] = z908;
    result.K[13] = z1005;
    result.K[14] = -z787;
    result.K[15] = z781;
    result.K[16] = z688;
    result.K[17] = z745;
    result.K[18] = z818;
    result.K[19] = -z897;
    result.K[20] = z988;
    result.K[21] = -z843;
    result.K[22] = -z840;
    result.K[23] = z786;
    result.K[24] = z717;
    result.K[25] = -z806;
    result.K[26] = z887;
    result.K[27] = -z976;
    result.K[28] = -z861;
    result.K[29] = z856;
    result.K[30] = -z850;
    result.K[31] = -z835;
    result.K[32] = z797;
    result.K[33] = z876;
    result.K[34] = -z966;
    result.K[35] = -z944;
    result.K[36] = z942;
    result.K[37] = -z930;
    result.K[38] = -z919;
    result.K[39] = -z900;
    result.K[40] = z869;
    result.K[41] = -z961;
    result.K[42] = -z1093;
    result.K[43] = -z1091;
    result.K[44] = z1077;
    result.K[45] = -z1029;
    result.K[46] = -z1015;
    result.K[47] = -z1007;
    result.K[48] = z946;
    result.F[0] = z1032;
    result.F[1] = z1033;
    result.F[2] = z1034;
    result.F[3] = z1035;
    result.F[4] = z1036;
    result.F[5] = z1037;
    result.F[6] = z1038;
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
    result.A[21] = -z1107;
    result.A[22] = -z1110;
    result.A[23] = z1112;
    result.A[24] = -z1114;
    result.A[25] = -z1116;
    result.A[26] = z1118;
    result.A[27] = z1119;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = -z1109;
    result.A[36] = -z1124;
    result.A[37] = z1125;
    result.A[38] = -z1130;
    result.A[39] = -z1177;
    result.A[40] = z1183;
    result.A[41] = z1184;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z1162;
    result.A[50] = z1166;
    result.A[51] = -z1170;
    result.A[52] = z1174;
    result.A[53] = z1180;
    result.A[54] = -z1209;
    result.A[55] = -z1210;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z1164;
    result.A[64] = z1168;
    result.A[65] = -z1172;
    result.A[66] = z1176;
    result.A[67] = z1182;
    result.A[68] = -z1235;
    result.A[69] = -z1236;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = z1200;
    result.A[78] = z1201;
    result.A[79] = -z1203;
    result.A[80] = z1205;
    result.A[81] = z1208;
    result.A[82] = -z1243;
    result.A[83] = -z1244;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = -z1226;
    result.A[92] = -z1227;
    result.A[93] = z1229;
    result.A[94] = -z1233;
    result.A[95] = -z1234;
    result.A[96] = z1248;
    result.A[97] = z1249;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = z1057;
    result.A[106] = z1059;
    result.A[107] = -z1063;
    result.A[108] = z1068;
    result.A[109] = z1069;
    result.A[110] = -z1079;
    result.A[111] = -z1080;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = -z1108;
    result.A[120] = -z1111;
    result.A[121] = z1113;
    result.A[122] = -z1115;
    result.A[123] = -z1117;
    result.A[124] = z1120;
    result.A[125] = z1121;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = z1161;
    result.A[134] = z1165;
    result.A[135] = -z1169;
    result.A[136] = z1173;
    result.A[137] = z1179;
    result.A[138] = -z1196;
    result.A[139] = -z1197;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z1163;
    result.A[148] = z1167;
    result.A[149] = -z1171;
    result.A[150] = z1175;
    result.A[151] = z1181;
    result.A[152] = -z1222;
    result.A[153] = -z1223;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z1187;
    result.A[162] = -z1188;
    result.A[163] = z1190;
    result.A[164] = -z1192;
    result.A[165] = -z1195;
    result.A[166] = z1239;
    result.A[167] = z1240;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z1213;
    result.A[176] = -z1214;
    result.A[177] = z1216;
    result.A[178] = -z1218;
    result.A[179] = -z1221;
    result.A[180] = z1246;
    result.A[181] = z1247;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z1237;
    result.A[190] = -z1238;
    result.A[191] = z1241;
    result.A[192] = -z1242;
    result.A[193] = -z1245;
    result.A[194] = z1250;
    result.A[195] = z1251;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z516;
    result.B[8] = z1280;
    result.B[9] = -z1285;
    result.B[10] = z1289;
    result.B[11] = z1294;
    result.B[12] = -z1300;
    result.B[13] = z1301;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z1280;
    result.B[22] = -z1282;
    result.B[23] = z1286;
    result.B[24] = -z1290;
    result.B[25] = -z1295;
    result.B[26] = z1302;
    result.B[27] = -z1303;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z1263;
    result.B[36] = -z1283;
    result.B[37] = -z1287;
    result.B[38] = z1291;
    result.B[39] = z1296;
    result.B[40] = -z1304;
    result.B[41] = z1305;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z1265;
    result.B[50] = z1268;
    result.B[51] = -z1288;
    result.B[52] = -z1292;
    result.B[53] = -z1297;
    result.B[54] = z1306;
    result.B[55] = -z1307;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z1267;
    result.B[64] = z1271;
    result.B[65] = -z1272;
    result.B[66] = z1293;
    result.B[67] = -z1298;
    result.B[68] = z1308;
    result.B[69] = -z1309;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z1270;
    result.B[78] = -z1273;
    result.B[79] = z1276;
    result.B[80] = -z1278;
    result.B[81] = -z1299;
    result.B[82] = -z1310;
    result.B[83] = z1311;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z1275;
    result.B[92] = z1277;
    result.B[93] = -z1279;
    result.B[94] = z1281;
    result.B[95] = z1284;
    result.B[96] = -z1312;
    result.B[97] = z1313;
    if (!(traits::regular(-z514, z239) && traits::regular(-z496, z197) && traits::regular(-z471, z164)
        && traits::regular(-z430, z130) && traits::regular(-z403, z79) && traits::regular(-z349,
        z37))) return torsor::Status::singular;
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
