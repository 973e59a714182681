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
// joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              252              343          0             0                  7       0    609     609
//   mass_matrix             162              181          0             0                  6       0    355     395
//   bias                    266              292          0             0                  6       0    570     684
//   inverse_dynamics        285              300          0             0                  6       0    597     715
//   forward_dynamics        515              586          6             0                  6       0   1119    1273
//   energy                  221              307          0             0                  6       0    540     577
//   linearisation          2054             2394          6             0                  6       0   4466    4732
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

namespace arm7 {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "arm7";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x28742b11f1e024e5ULL;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 7;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;

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
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z476 = k0 * s_q2;
    const Scalar z477 = k0 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z480 = z39 * z40;
    const Scalar z482 = z39 * z39;
    const Scalar z483 = z481 + z482;
    const Scalar z484 = n2 * z478;
    const Scalar z485 = c_q3 * z478;
    const Scalar z486 = s_q3 * z478;
    const Scalar z487 = z476 + n632_over_165 * z480;
    const Scalar z495 = z57 * z57;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z494 = z56 * z56;
    const Scalar z497 = z55 * z56;
    const Scalar z499 = z55 * z57;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z489 = n632_over_165 * z484;
    const Scalar z492 = v_q3 * z56 - z485;  // angular acceleration of link3, x
    const Scalar z493 = v_q3 * z55 - z486;  // angular acceleration of link3, y
    const Scalar z496 = z494 + z495;
    const Scalar z498 = z479 - z497;
    const Scalar z511 = z80 * z80;
    const Scalar z490 = s_q3 * z489 - c_q3 * z487;
    const Scalar z491 = s_q3 * z487 + c_q3 * z489;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z500 = z493 + z499;
    const Scalar z501 = s_q4 * z479 - c_q4 * z492;
    const Scalar z502 = c_q4 * z479 + s_q4 * z492;
    const Scalar z516 = z78 * z78;
    const Scalar z518 = z78 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z510 = z79 * z79;
    const Scalar z513 = z78 * z79;
    const Scalar z520 = z79 * z80;
    const Scalar z505 = z488 + z500;
    const Scalar z517 = z511 + z516;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z504 = z491 - z498;
    const Scalar z508 = v_q4 * z79 + z501;  // angular acceleration of link4, x
    const Scalar z509 = v_q4 * z78 + z502;  // angular acceleration of link4, y
    const Scalar z512 = z510 + z511;
    const Scalar z514 = z493 + z513;
    const Scalar z515 = z493 - z513;
    const Scalar z503 = z490 - z496;
    const Scalar z519 = z509 + z518;
    const Scalar z521 = z508 + z520;
    const Scalar z522 = s_q5 * z493 + c_q5 * z508;
    const Scalar z523 = s_q5 * z508 - c_q5 * z493;
    const Scalar z506 = s_q4 * z505 + c_q4 * z503;
    const Scalar z507 = s_q4 * z503 - c_q4 * z505;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z537 = z118 * z118;
    const Scalar z581 = z117 * z117;
    const Scalar z529 = v_q5 * z103 + z522;  // angular acceleration of link5, x
    const Scalar z524 = z512 - n256_over_55 * z514 + z506;
    const Scalar z526 = z504 + z519 + n256_over_55 * z521;
    const Scalar z530 = v_q5 * z102 + z523;  // angular acceleration of link5, y
    const Scalar z531 = s_q6 * z509 + c_q6 * z529;
    const Scalar z525 = n256_over_55 * z517 + z515 + z507;
    const Scalar z535 = v_q6 * z118 - z531;  // angular acceleration of link6, x
    const Scalar z532 = s_q6 * z529 - c_q6 * z509;
    const Scalar z553 = z138 * z138;
    const Scalar z536 = v_q6 * z117 - z532;  // angular acceleration of link6, y
    const Scalar z556 = z137 * z138;
    const Scalar z559 = z137 * z137;
    const Scalar z538 = z119 * z119;
    const Scalar z545 = c_q7 * z530 + s_q7 * z535;
    const Scalar z554 = z139 * z139;
    const Scalar z527 = c_q5 * z524 + s_q5 * z526;
    const Scalar z528 = s_q5 * z524 - c_q5 * z526;
    const Scalar z552 = v_q7 * z137 + z545;  // angular acceleration of link7, y
    const Scalar z561 = z137 * z139;
    const Scalar z563 = z138 * z139;
    const Scalar z589 = z537 - z581;
    const Scalar z540 = z117 * z118;
    const Scalar z542 = z117 * z119;
    const Scalar z583 = z118 * z119;
    const Scalar z569 = z553 - z559;
    const Scalar z544 = s_q7 * z530 - c_q7 * z535;
    const Scalar z551 = v_q7 * z138 + z544;  // angular acceleration of link7, x
    const Scalar z560 = z554 + z559;
    const Scalar z566 = z554 - z559;
    const Scalar z586 = z538 - z581;
    const Scalar z582 = z538 + z581;
    const Scalar z565 = z553 - z554;
    const Scalar z555 = z553 + z554;
    const Scalar z534 = c_q6 * z525 + s_q6 * z527;
    const Scalar z541 = z530 - z540;
    const Scalar z557 = z536 + z556;
    const Scalar z570 = k4 * z555 - k5 * z557;  // force on link7, times 0.0825 m, x
    const Scalar z558 = z536 - z556;
    const Scalar z571 = k5 * z560 + k4 * z558;  // force on link7, times 0.0825 m, y
    const Scalar z580 = z530 + z540;
    const Scalar z533 = s_q6 * z525 - c_q6 * z527;
    const Scalar z539 = z537 + z538;
    const Scalar z585 = z537 - z538;
    const Scalar z562 = z552 + z561;
    const Scalar z568 = z552 - z561;
    const Scalar z543 = z536 + z542;
    const Scalar z588 = z536 - z542;
    const Scalar z547 = z534 + n16_over_15 * z541;
    const Scalar z564 = z551 + z563;
    const Scalar z567 = z551 - z563;
    const Scalar z574 = k7 * z566 + k8 * z557 + k4 * z547 + k9 * z562 - k10 * z564;  // moment on link7, y
    const Scalar z573 = k8 * z565 + k7 * z558 + k5 * z547 - k10 * z562 + k11 * z564;  // moment on link7, x
    const Scalar z572 = k4 * z562 + k5 * z564;  // force on link7, times 0.0825 m, z
    const Scalar z591 = k12 * z541 + z572 - k13 * z582;  // force on link6, times 0.0825 m, y
    const Scalar z546 = z533 + n16_over_15 * z539;
    const Scalar z601 = z104 * z104;
    const Scalar z603 = z102 * z103;
    const Scalar z606 = z102 * z102;
    const Scalar z548 = z528 + n16_over_15 * z543;
    const Scalar z608 = z102 * z104;
    const Scalar z584 = z535 + z583;
    const Scalar z587 = z535 - z583;
    const Scalar z600 = z103 * z103;
    const Scalar z576 = s_q7 * z571 + c_q7 * z570;
    const Scalar z577 = s_q7 * z570 - c_q7 * z571;
    const Scalar z590 = k12 * z539 + z576 + k13 * z580;  // force on link6, times 0.0825 m, x
    const Scalar z604 = z509 + z603;
    const Scalar z550 = s_q7 * z546 + c_q7 * z548;
    const Scalar z549 = s_q7 * z548 - c_q7 * z546;
    // moment on link7, z
    const Scalar z575 = k14 * z556 + k10 * z569 + k15 * z536 + k7 * z567 + k8 * z568 + k4 * z550 + k5 * z549;
    // moment on link6, y
    const Scalar z594 = k16 * z586 + k17 * z580 + k12 * z528 - k18 * z584 + k19 * z543 - n16_over_15 * z577 + z575;
    const Scalar z610 = z103 * z104;
    const Scalar z629 = z508 - z520;
    const Scalar z592 = k12 * z543 - z577 - k13 * z584;  // force on link6, times 0.0825 m, z
    const Scalar z630 = z509 - z518;
    const Scalar z613 = z601 - z606;
    const Scalar z616 = z600 - z606;
    const Scalar z607 = z601 + z606;
    const Scalar z612 = z600 - z601;
    const Scalar z602 = z600 + z601;
    const Scalar z614 = z529 - z610;
    const Scalar z611 = z529 + z610;
    const Scalar z605 = z509 - z603;
    const Scalar z618 = z592 - k20 * z605 + k21 * z607;  // force on link5, times 0.0825 m, y
    const Scalar z631 = z510 - z516;
    const Scalar z628 = z511 - z516;
    const Scalar z627 = z510 - z511;
    const Scalar z615 = z530 - z608;
    const Scalar z609 = z530 + z608;
    const Scalar z578 = s_q7 * z574 - c_q7 * z573;
    const Scalar z593 = k13 * z528 - k17 * z585 - k16 * z541 - k22 * z584 + k18 * z543 - z578;  // moment on link6, x
    const Scalar z579 = s_q7 * z573 + c_q7 * z574;
    // moment on link6, z
    const Scalar z595 = k18 * z589 - k23 * z540 + k24 * z530 + k13 * z533 + k12 * z534 + k16 * z587 + k17 * z588
        + n16_over_15 * z572 + z579;
    const Scalar z621 = k25 * z613 + k26 * z604 + k20 * z525 - k27 * z611 - k28 * z609 - z595;  // moment on link5, y
    const Scalar z645 = z56 * z57;
    const Scalar z643 = z55 * z55;
    const Scalar z650 = z493 - z499;
    const Scalar z596 = s_q6 * z591 - c_q6 * z590;
    const Scalar z617 = z596 + k20 * z602 + k21 * z604;  // force on link5, times 0.0825 m, x
    const Scalar z597 = s_q6 * z590 + c_q6 * z591;
    const Scalar z619 = z597 - k20 * z609 + k21 * z611;  // force on link5, times 0.0825 m, z
    const Scalar z598 = s_q6 * z594 - c_q6 * z593;
    const Scalar z620 = k21 * z525 - k26 * z612 - k25 * z605 + k29 * z611 + k27 * z609 - z598;  // moment on link5, x
    const Scalar z599 = c_q6 * z594 + s_q6 * z593;
    // moment on link5, z
    const Scalar z622 = k30 * z603 + k31 * z509 - k27 * z616 - k25 * z614 - k26 * z615 + k21 * z527 - k20 * z528 + z599;
    const Scalar z633 = z619 + k32 * z517 + k33 * z515;  // force on link4, times 0.0825 m, y
    const Scalar z662 = z40 * z40;
    const Scalar z642 = z479 + z497;
    const Scalar z623 = s_q5 * z618 + c_q5 * z617;
    const Scalar z624 = s_q5 * z617 - c_q5 * z618;
    // moment on link4, y
    const Scalar z636 = k33 * z504 - k34 * z628 + k35 * z514 + k36 * z519 + k37 * z521 + z622 + z624;
    const Scalar z632 = z623 + k33 * z512 - k32 * z514;  // force on link4, times 0.0825 m, x
    const Scalar z647 = z494 - z495;
    const Scalar z651 = z494 - z643;
    const Scalar z648 = z495 - z643;
    const Scalar z644 = z495 + z643;
    const Scalar z625 = s_q5 * z621 - c_q5 * z620;
    // moment on link4, x
    const Scalar z635 = k32 * z504 - k34 * z515 + k35 * z627 + k37 * z519 + k38 * z521 - z625 + n256_over_55 * z624;
    const Scalar z634 = z624 + k33 * z519 + k32 * z521;  // force on link4, times 0.0825 m, z
    const Scalar z626 = c_q5 * z621 + s_q5 * z620;
    // moment on link4, z
    const Scalar z637 = k39 * z493 + k40 * z513 - k37 * z631 - k34 * z629 + k35 * z630 - k32 * z506 + k33 * z507 + z619
        + z626 - n256_over_55 * z623;
    const Scalar z653 = k41 * z498 - z634 + k42 * z644;  // force on link3, times 0.0825 m, y
    const Scalar z649 = z492 - z645;
    const Scalar z646 = z492 + z645;
    const Scalar z640 = s_q4 * z636 - c_q4 * z635;
    const Scalar z655 = k42 * z488 + k43 * z498 - k44 * z647 + k45 * z500 + k46 * z646 + z640;  // moment on link3, x
    const Scalar z641 = c_q4 * z636 + s_q4 * z635;
    // moment on link3, z
    const Scalar z657 = k47 * z479 - k48 * z497 - k45 * z651 + k43 * z649 - k44 * z650 - k41 * z491 + k42 * z490 - z634
        + z641;
    const Scalar z664 = n2 * z479;
    const Scalar z638 = s_q4 * z633 + c_q4 * z632;
    const Scalar z639 = s_q4 * z632 - c_q4 * z633;
    // moment on link3, y
    const Scalar z656 = k41 * z488 - k44 * z642 + k43 * z648 + k49 * z500 + k45 * z646 + z637 + z639;
    const Scalar z665 = z481 - z662;
    const Scalar z652 = k41 * z496 - z638 - k42 * z642;  // force on link3, times 0.0825 m, x
    const Scalar z660 = c_q3 * z655 + s_q3 * z656;
    const Scalar z659 = c_q3 * z653 + s_q3 * z652;
    const Scalar z666 = z481 - z482;
    const Scalar z667 = z482 - z662;
    const Scalar z661 = s_q3 * z655 - c_q3 * z656;
    // moment on link2, x
    const Scalar z671 = k50 * z480 - k51 * z484 - k52 * z664 - k53 * z665 + z660 + n632_over_165 * z659;
    const Scalar z658 = s_q3 * z653 - c_q3 * z652;
    const Scalar z672 = k53 * z480 - k52 * z484 - k54 * z664 - k50 * z666 - z657;  // moment on link2, y
    // moment on link2, z
    const Scalar z673 = k55 * z476 - k56 * z477 + k57 * z480 + k52 * z667 - z661 - n632_over_165 * z658;
    const Scalar z677 = s_q2 * z671 - c_q2 * z672;
    forces.q1 = -z677;
    forces.q2 = -z673;
    forces.q3 = -z657;
    forces.q4 = z637;
    forces.q5 = -z622;
    forces.q6 = -z595;
    forces.q7 = z575;
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
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z476 = k0 * s_q2;
    const Scalar z477 = k0 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z480 = z39 * z40;
    const Scalar z482 = z39 * z39;
    const Scalar z483 = z481 + z482;
    const Scalar z495 = z57 * z57;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z494 = z56 * z56;
    const Scalar z497 = z55 * z56;
    const Scalar z499 = z55 * z57;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z496 = z494 + z495;
    const Scalar z511 = z80 * z80;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z516 = z78 * z78;
    const Scalar z518 = z78 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z510 = z79 * z79;
    const Scalar z513 = z78 * z79;
    const Scalar z520 = z79 * z80;
    const Scalar z517 = z511 + z516;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z628 = z511 - z516;
    const Scalar z512 = z510 + z511;
    const Scalar z600 = z103 * z103;
    const Scalar z601 = z104 * z104;
    const Scalar z603 = z102 * z103;
    const Scalar z606 = z102 * z102;
    const Scalar z608 = z102 * z104;
    const Scalar z610 = z103 * z104;
    const Scalar z627 = z510 - z511;
    const Scalar z538 = z119 * z119;
    const Scalar z602 = z600 + z601;
    const Scalar z607 = z601 + z606;
    const Scalar z612 = z600 - z601;
    const Scalar z613 = z601 - z606;
    const Scalar z616 = z600 - z606;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z631 = z510 - z516;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z643 = z55 * z55;
    const Scalar z139 = v_q7 - z118;
    const Scalar z645 = z56 * z57;
    const Scalar z683 = a_q1 * s_q2;
    const Scalar z685 = v_q2 * z40 + z683;  // angular acceleration of link2, x
    const Scalar z662 = z40 * z40;
    const Scalar z684 = a_q1 * c_q2;
    const Scalar z686 = v_q2 * z39 - z684;  // angular acceleration of link2, y
    const Scalar z687 = a_q2 - z480;
    const Scalar z691 = z476 - n632_over_165 * z687;
    const Scalar z689 = a_q2 * s_q3 - c_q3 * z685;
    const Scalar z688 = z478 + z685;
    const Scalar z690 = a_q2 * c_q3 + s_q3 * z685;
    const Scalar z695 = v_q3 * z56 + z689;  // angular acceleration of link3, x
    const Scalar z696 = v_q3 * z55 - z690;  // angular acceleration of link3, y
    const Scalar z692 = n632_over_165 * z688;
    const Scalar z693 = s_q3 * z692 - c_q3 * z691;
    const Scalar z694 = s_q3 * z691 + c_q3 * z692;
    const Scalar z647 = z494 - z495;
    const Scalar z651 = z494 - z643;
    const Scalar z540 = z117 * z118;
    const Scalar z537 = z118 * z118;
    const Scalar z697 = a_q3 - z686;  // angular acceleration of link3, z
    const Scalar z698 = z497 + z697;
    const Scalar z581 = z117 * z117;
    const Scalar z542 = z117 * z119;
    const Scalar z583 = z118 * z119;
    const Scalar z554 = z139 * z139;
    const Scalar z559 = z137 * z137;
    const Scalar z589 = z537 - z581;
    const Scalar z539 = z537 + z538;
    const Scalar z585 = z537 - z538;
    const Scalar z699 = z499 + z696;
    const Scalar z700 = s_q4 * z697 + c_q4 * z695;
    const Scalar z701 = s_q4 * z695 - c_q4 * z697;
    const Scalar z553 = z138 * z138;
    const Scalar z702 = z496 - z693;
    const Scalar z703 = z694 + z698;
    const Scalar z556 = z137 * z138;
    const Scalar z560 = z554 + z559;
    const Scalar z566 = z554 - z559;
    const Scalar z569 = z553 - z559;
    const Scalar z555 = z553 + z554;
    const Scalar z707 = v_q4 * z79 - z700;  // angular acceleration of link4, x
    const Scalar z565 = z553 - z554;
    const Scalar z704 = z488 + z699;
    const Scalar z705 = s_q4 * z704 - c_q4 * z702;
    const Scalar z706 = c_q4 * z704 + s_q4 * z702;
    const Scalar z586 = z538 - z581;
    const Scalar z582 = z538 + z581;
    const Scalar z563 = z138 * z139;
    const Scalar z561 = z137 * z139;
    const Scalar z708 = v_q4 * z78 + z701;  // angular acceleration of link4, y
    const Scalar z709 = a_q4 + z696;  // angular acceleration of link4, z
    const Scalar z710 = z513 + z709;
    const Scalar z714 = s_q5 * z709 + c_q5 * z707;
    const Scalar z713 = z520 + z707;
    const Scalar z723 = a_q5 - z708;  // angular acceleration of link5, z
    const Scalar z711 = z513 - z709;
    const Scalar z715 = s_q5 * z707 - c_q5 * z709;
    const Scalar z722 = v_q5 * z102 + z715;  // angular acceleration of link5, y
    const Scalar z712 = z518 + z708;
    const Scalar z716 = z512 - n256_over_55 * z710 + z705;
    const Scalar z721 = v_q5 * z103 + z714;  // angular acceleration of link5, x
    const Scalar z718 = z703 + n256_over_55 * z713 + z712;
    const Scalar z717 = n256_over_55 * z517 - z711 - z706;
    const Scalar z725 = c_q6 * z723 + s_q6 * z721;
    const Scalar z724 = s_q6 * z723 - c_q6 * z721;
    const Scalar z729 = v_q6 * z117 - z725;  // angular acceleration of link6, y
    const Scalar z728 = v_q6 * z118 + z724;  // angular acceleration of link6, x
    const Scalar z730 = a_q6 - z722;  // angular acceleration of link6, z
    const Scalar z719 = c_q5 * z716 + s_q5 * z718;
    const Scalar z720 = s_q5 * z716 - c_q5 * z718;
    const Scalar z727 = c_q6 * z717 + s_q6 * z719;
    const Scalar z731 = z540 + z730;
    const Scalar z726 = s_q6 * z717 - c_q6 * z719;
    const Scalar z733 = s_q7 * z730 + c_q7 * z728;
    const Scalar z732 = z542 + z729;
    const Scalar z648 = z495 - z643;
    const Scalar z644 = z495 + z643;
    const Scalar z736 = z727 - n16_over_15 * z731;
    const Scalar z734 = s_q7 * z728 - c_q7 * z730;
    const Scalar z735 = n16_over_15 * z539 + z726;
    const Scalar z737 = z720 + n16_over_15 * z732;
    const Scalar z739 = s_q7 * z735 + c_q7 * z737;
    const Scalar z738 = s_q7 * z737 - c_q7 * z735;
    const Scalar z665 = z481 - z662;
    const Scalar z740 = v_q7 * z138 - z733;  // angular acceleration of link7, x
    const Scalar z666 = z481 - z482;
    const Scalar z741 = v_q7 * z137 + z734;  // angular acceleration of link7, y
    const Scalar z667 = z482 - z662;
    const Scalar z789 = z520 - z707;
    const Scalar z790 = z518 - z708;
    const Scalar z762 = z542 - z729;
    const Scalar z742 = a_q7 + z729;  // angular acceleration of link7, z
    const Scalar z744 = z556 - z742;
    const Scalar z743 = z556 + z742;
    const Scalar z804 = z499 - z696;
    const Scalar z746 = z563 + z740;
    const Scalar z747 = z563 - z740;
    const Scalar z759 = z540 - z730;
    const Scalar z750 = k4 * z560 - k5 * z744;  // force on link7, times 0.0825 m, y
    const Scalar z749 = k5 * z555 - k4 * z743;  // force on link7, times 0.0825 m, x
    const Scalar z745 = z561 + z741;
    const Scalar z753 = k6 * z566 + k5 * z736 + k7 * z743 + k8 * z745 - k9 * z746;  // moment on link7, y
    const Scalar z752 = k7 * z565 + k4 * z736 - k6 * z744 - k9 * z745 + k10 * z746;  // moment on link7, x
    const Scalar z751 = k4 * z746 + k5 * z745;  // force on link7, times 0.0825 m, z
    const Scalar z748 = z561 - z741;
    // moment on link7, z
    const Scalar z754 = k11 * z556 + k9 * z569 + k12 * z742 - k6 * z747 + k5 * z739 + k4 * z738 - k7 * z748;
    const Scalar z764 = k13 * z582 - z751 + k14 * z731;  // force on link6, times 0.0825 m, y
    const Scalar z755 = s_q7 * z750 + c_q7 * z749;
    const Scalar z756 = s_q7 * z749 - c_q7 * z750;
    const Scalar z763 = k14 * z539 + z755 + k13 * z759;  // force on link6, times 0.0825 m, x
    const Scalar z817 = z478 - z685;
    const Scalar z760 = z583 + z728;
    // moment on link6, y
    const Scalar z767 = k15 * z586 + k14 * z720 + k16 * z759 + k17 * z732 - k18 * z760 - n16_over_15 * z756 + z754;
    const Scalar z761 = z583 - z728;
    const Scalar z765 = k14 * z732 - z756 - k13 * z760;  // force on link6, times 0.0825 m, z
    const Scalar z773 = z603 - z723;
    const Scalar z777 = z610 - z721;
    const Scalar z776 = z610 + z721;
    const Scalar z774 = z603 + z723;
    const Scalar z780 = k19 * z607 + z765 + k20 * z774;  // force on link5, times 0.0825 m, y
    const Scalar z778 = z608 - z722;
    const Scalar z775 = z608 + z722;
    const Scalar z757 = s_q7 * z753 - c_q7 * z752;
    const Scalar z766 = k16 * z585 - k13 * z720 - k15 * z731 - k18 * z732 + k21 * z760 + z757;  // moment on link6, x
    const Scalar z758 = s_q7 * z752 + c_q7 * z753;
    // moment on link6, z
    const Scalar z768 = k22 * z540 - k18 * z589 + k23 * z730 - k13 * z726 - k14 * z727 + k15 * z761 + k16 * z762
        - n16_over_15 * z751 - z758;
    const Scalar z783 = k24 * z613 + k20 * z717 + k25 * z773 - k26 * z776 - k27 * z775 + z768;  // moment on link5, y
    const Scalar z769 = c_q6 * z763 + s_q6 * z764;
    const Scalar z779 = k20 * z602 - z769 + k19 * z773;  // force on link5, times 0.0825 m, x
    const Scalar z770 = s_q6 * z763 - c_q6 * z764;
    const Scalar z781 = z770 - k20 * z775 + k19 * z776;  // force on link5, times 0.0825 m, z
    const Scalar z771 = s_q6 * z767 + c_q6 * z766;
    const Scalar z782 = k25 * z612 - k19 * z717 - k24 * z774 - k28 * z776 - k26 * z775 + z771;  // moment on link5, x
    const Scalar z772 = s_q6 * z766 - c_q6 * z767;
    // moment on link5, z
    const Scalar z784 = k29 * z603 - k26 * z616 - k30 * z723 + k24 * z777 + k25 * z778 + k19 * z719 - k20 * z720 - z772;
    const Scalar z792 = z781 + k31 * z517 - k32 * z711;  // force on link4, times 0.0825 m, y
    const Scalar z785 = s_q5 * z780 + c_q5 * z779;
    const Scalar z786 = s_q5 * z779 - c_q5 * z780;
    // moment on link4, y
    const Scalar z795 = k33 * z628 - k32 * z703 - k34 * z710 - k35 * z712 - k36 * z713 - z784 - z786;
    const Scalar z791 = z785 + k32 * z512 - k31 * z710;  // force on link4, times 0.0825 m, x
    const Scalar z801 = z497 - z697;
    const Scalar z787 = s_q5 * z783 + c_q5 * z782;
    // moment on link4, x
    const Scalar z794 = k34 * z627 + k33 * z711 + k31 * z703 + k37 * z713 + k36 * z712 - z787 + n256_over_55 * z786;
    const Scalar z793 = z786 + k31 * z713 + k32 * z712;  // force on link4, times 0.0825 m, z
    const Scalar z788 = s_q5 * z782 - c_q5 * z783;
    // moment on link4, z
    const Scalar z796 = k38 * z513 + k39 * z709 - k36 * z631 + k33 * z789 - k31 * z705 - k32 * z706 - k34 * z790 + z781
        - n256_over_55 * z785 - z788;
    const Scalar z806 = k40 * z644 - z793 - k41 * z698;  // force on link3, times 0.0825 m, y
    const Scalar z803 = z645 - z695;
    const Scalar z802 = z645 + z695;
    const Scalar z815 = a_q2 + z480;
    const Scalar z799 = s_q4 * z795 + c_q4 * z794;
    const Scalar z808 = k40 * z488 - k42 * z647 - k43 * z698 + k44 * z699 + k45 * z802 - z799;  // moment on link3, x
    const Scalar z800 = s_q4 * z794 - c_q4 * z795;
    // moment on link3, z
    const Scalar z810 = k46 * z497 + k47 * z697 + k44 * z651 + k43 * z803 - k42 * z804 - k40 * z693 + k41 * z694 + z793
        - z800;
    const Scalar z797 = s_q4 * z792 + c_q4 * z791;
    const Scalar z798 = s_q4 * z791 - c_q4 * z792;
    // moment on link3, y
    const Scalar z809 = k41 * z488 + k43 * z648 - k42 * z801 + k48 * z699 + k44 * z802 + z796 + z798;
    const Scalar z816 = z479 + z686;
    const Scalar z805 = k41 * z496 - z797 - k40 * z801;  // force on link3, times 0.0825 m, x
    const Scalar z813 = c_q3 * z808 + s_q3 * z809;
    const Scalar z812 = c_q3 * z806 + s_q3 * z805;
    const Scalar z823 = k49 * z666 + k50 * z687 + k51 * z688 + k52 * z816 - z810;  // moment on link2, y
    const Scalar z818 = z479 - z686;
    // moment on link2, x
    const Scalar z822 = k50 * z665 - k49 * z815 + k53 * z688 + k51 * z816 - z813 - n632_over_165 * z812;
    const Scalar z814 = s_q3 * z808 - c_q3 * z809;
    const Scalar z811 = s_q3 * z806 - c_q3 * z805;
    const Scalar z828 = s_q2 * z822 - c_q2 * z823;
    // moment on link2, z
    const Scalar z824 = k54 * a_q2 - k55 * z476 + k56 * z477 - k57 * z480 - k51 * z667 + k49 * z817 - k50 * z818 + z814
        + n632_over_165 * z811;
    const Scalar z833 = k58 * a_q1 + z828;  // moment on link1, z
    forces.q1 = z833;
    forces.q2 = z824;
    forces.q3 = z810;
    forces.q4 = z796;
    forces.q5 = -z784;
    forces.q6 = z768;
    forces.q7 = z754;
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
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z482 = z39 * z39;
    const Scalar z476 = k42 * s_q2;
    const Scalar z480 = z39 * z40;
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z438 = s_q3 * z437;
    const Scalar z477 = k42 * c_q2;
    const Scalar z483 = z481 + z482;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z399 = c_q3 * z394 + s_q3 * z396;
    const Scalar z439 = z420 + z438;
    const Scalar z440 = z416 - z438;
    const Scalar z442 = k43 * z392 - z439;
    const Scalar z443 = k43 * z392 - z440;
    const Scalar z398 = s_q3 * z392;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z446 = k44 - z442;
    const Scalar z450 = k45 - z443;
    const Scalar z448 = k46 - z441;
    const Scalar z485 = c_q3 * z478;
    const Scalar z455 = z424 - z446;
    const Scalar z406 = c_q2 * z395 + s_q2 * z401;
    const Scalar z492 = v_q3 * z56 - z485;  // angular acceleration of link3, x
    const Scalar z484 = n2 * z478;
    const Scalar z486 = s_q3 * z478;
    const Scalar z493 = v_q3 * z55 - z486;  // angular acceleration of link3, y
    const Scalar z489 = n632_over_165 * z484;
    const Scalar z499 = z55 * z57;
    const Scalar z487 = z476 + n632_over_165 * z480;
    const Scalar z494 = z56 * z56;
    const Scalar z495 = z57 * z57;
    const Scalar z500 = z493 + z499;
    const Scalar z490 = s_q3 * z489 - c_q3 * z487;
    const Scalar z491 = s_q3 * z487 + c_q3 * z489;
    const Scalar z496 = z494 + z495;
    const Scalar z505 = z488 + z500;
    const Scalar z510 = z79 * z79;
    const Scalar z511 = z80 * z80;
    const Scalar z497 = z55 * z56;
    const Scalar z503 = z490 - z496;
    const Scalar z512 = z510 + z511;
    const Scalar z513 = z78 * z79;
    const Scalar z518 = z78 * z80;
    const Scalar z520 = z79 * z80;
    const Scalar z516 = z78 * z78;
    const Scalar z506 = s_q4 * z505 + c_q4 * z503;
    const Scalar z507 = s_q4 * z503 - c_q4 * z505;
    const Scalar z517 = z511 + z516;
    const Scalar z537 = z118 * z118;
    const Scalar z538 = z119 * z119;
    const Scalar z447 = k47 + z429;
    const Scalar z456 = n2 * z447;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z553 = z138 * z138;
    const Scalar z554 = z139 * z139;
    const Scalar z457 = c_q2 * z456 + s_q2 * z455;
    const Scalar z556 = z137 * z138;
    const Scalar z559 = z137 * z137;
    const Scalar z555 = z553 + z554;
    const Scalar z560 = z554 + z559;
    const Scalar z540 = z117 * z118;
    const Scalar z561 = z137 * z139;
    const Scalar z563 = z138 * z139;
    const Scalar z542 = z117 * z119;
    const Scalar z566 = z554 - z559;
    const Scalar z565 = z553 - z554;
    const Scalar z539 = z537 + z538;
    const Scalar z458 = s_q2 * z457;
    const Scalar z449 = k48 + z430;
    const Scalar z569 = z553 - z559;
    const Scalar z454 = c_q2 * z449 + s_q2 * z448;
    const Scalar z583 = z118 * z119;
    const Scalar z460 = z424 - z458;
    const Scalar z581 = z117 * z117;
    const Scalar z586 = z538 - z581;
    const Scalar z589 = z537 - z581;
    const Scalar z585 = z537 - z538;
    const Scalar z582 = z538 + z581;
    const Scalar z468 = k49 + z460;
    const Scalar z645 = z56 * z57;
    const Scalar z643 = z55 * z55;
    const Scalar z650 = z493 - z499;
    const Scalar z662 = z40 * z40;
    const Scalar z1172 = c_q4 * z492;
    const Scalar z1175 = v_q4 * z79 - z1172;  // angular acceleration of link4, x
    const Scalar z1173 = s_q4 * z492;
    const Scalar z1176 = v_q4 * z78 + z1173;  // angular acceleration of link4, y
    const Scalar z1174 = z491 + z497;
    const Scalar z1181 = z512 - n256_over_55 * z513 + z506;
    const Scalar z1179 = c_q5 * z1175;
    const Scalar z1178 = z520 + z1175;
    const Scalar z1177 = z518 + z1176;
    const Scalar z1182 = n256_over_55 * z517 - z513 + z507;
    const Scalar z1186 = v_q5 * z103 + z1179;  // angular acceleration of link5, x
    const Scalar z1183 = z1174 + z1177 + n256_over_55 * z1178;
    const Scalar z601 = z104 * z104;
    const Scalar z603 = z102 * z103;
    const Scalar z1188 = c_q6 * z1186;
    const Scalar z1189 = s_q6 * z1186;
    const Scalar z606 = z102 * z102;
    const Scalar z600 = z103 * z103;
    const Scalar z610 = z103 * z104;
    const Scalar z608 = z102 * z104;
    const Scalar z1192 = v_q6 * z118 - z1188;  // angular acceleration of link6, x
    const Scalar z1193 = v_q6 * z117 - z1189;  // angular acceleration of link6, y
    const Scalar z1184 = c_q5 * z1181 + s_q5 * z1183;
    const Scalar z1185 = s_q5 * z1181 - c_q5 * z1183;
    const Scalar z1196 = s_q7 * z1192;
    const Scalar z1195 = c_q7 * z1192;
    const Scalar z1191 = c_q6 * z1182 + s_q6 * z1184;
    const Scalar z1203 = v_q7 * z137 + z1196;  // angular acceleration of link7, y
    const Scalar z1202 = v_q7 * z138 - z1195;  // angular acceleration of link7, x
    const Scalar z1194 = z542 + z1193;
    const Scalar z1190 = s_q6 * z1182 - c_q6 * z1184;
    const Scalar z1204 = z561 + z1203;
    const Scalar z1205 = z563 + z1202;
    const Scalar z1198 = n16_over_15 * z540 - z1191;
    const Scalar z1199 = z1185 + n16_over_15 * z1194;
    const Scalar z1197 = n16_over_15 * z539 + z1190;
    const Scalar z613 = z601 - z606;
    const Scalar z616 = z600 - z606;
    const Scalar z607 = z601 + z606;
    const Scalar z1180 = s_q5 * z1175;
    const Scalar z1187 = v_q5 * z102 + z1180;  // angular acceleration of link5, y
    const Scalar z1200 = s_q7 * z1199 - c_q7 * z1197;
    const Scalar z1201 = c_q7 * z1199 + s_q7 * z1197;
    const Scalar z612 = z600 - z601;
    const Scalar z602 = z600 + z601;
    const Scalar z1206 = z563 - z1202;
    const Scalar z1207 = z561 - z1203;
    const Scalar z1213 = k0 * z556 + k8 * z569 - k5 * z1206 - k4 * z1207 + k2 * z1200 + k3 * z1201;
    const Scalar z1209 = k3 * z556 - k2 * z560;
    const Scalar z1208 = k3 * z555 - k2 * z556;
    const Scalar z1212 = k4 * z556 + k5 * z566 - k3 * z1198 + k50 * z1204 - k8 * z1205;
    const Scalar z1211 = k5 * z556 - k4 * z565 + k2 * z1198 + k8 * z1204 - k51 * z1205;
    const Scalar z1210 = k3 * z1204 + k2 * z1205;
    const Scalar z628 = z511 - z516;
    const Scalar z631 = z510 - z516;
    const Scalar z627 = z510 - z511;
    const Scalar z1228 = k10 * z540 - z1210 + k13 * z582;
    const Scalar z1226 = z542 - z1193;
    const Scalar z1224 = z583 + z1192;
    const Scalar z1225 = z583 - z1192;
    const Scalar z646 = z492 + z645;
    const Scalar z649 = z492 - z645;
    const Scalar z648 = z495 - z643;
    const Scalar z647 = z494 - z495;
    const Scalar z644 = z495 + z643;
    const Scalar z1265 = z520 - z1175;
    const Scalar z651 = z494 - z643;
    const Scalar z1266 = z518 - z1176;
    const Scalar z1244 = z608 + z1187;
    const Scalar z1247 = z608 - z1187;
    const Scalar z1245 = z610 + z1186;
    const Scalar z1246 = z610 - z1186;
    const Scalar z1384 = k52 * z285;
    const Scalar z1383 = k52 * z291;
    const Scalar z664 = n2 * z479;
    const Scalar z1385 = k52 * z279;
    const Scalar z665 = z481 - z662;
    const Scalar z666 = z481 - z482;
    const Scalar z667 = z482 - z662;
    const Scalar z1397 = z279 * z1385 - z391;
    const Scalar z1396 = z285 * z1385 + z395;
    const Scalar z1393 = z285 * z1384 - z424;
    const Scalar z1392 = z291 * z1384 - z430;
    const Scalar z1395 = z291 * z1385 - z402;
    const Scalar z1390 = z291 * z1383 - z450;
    const Scalar z1389 = z295 * z1383 + z454;
    const Scalar z1391 = z295 * z1384 - z434;
    const Scalar z1394 = z295 * z1385 - z406;
    const Scalar z1387 = k52 * z267;
    const Scalar z1408 = z267 * z1387 - z308;
    const Scalar z1407 = z272 * z1387 - z312;
    const Scalar z1406 = z279 * z1387 - z319;
    const Scalar z1405 = z285 * z1387 + z325;
    const Scalar z1409 = n1 / z1408;
    const Scalar z1404 = z291 * z1387 + z331;
    const Scalar z1403 = z295 * z1387 - z335;
    const Scalar z1386 = k52 * z272;
    const Scalar z1402 = z272 * z1386 - z349;
    const Scalar z1401 = z279 * z1386 + z356;
    const Scalar z1400 = z285 * z1386 - z362;
    const Scalar z1399 = z291 * z1386 - z368;
    const Scalar z1398 = z295 * z1386 - z372;
    const Scalar z1382 = k52 * z295;
    const Scalar z1388 = z295 * z1382 - z468;
    const Scalar z1214 = u_tau7 - z1213;
    const Scalar z1478 = s_q7 * z1209 - c_q7 * z1208;
    const Scalar z1479 = c_q7 * z1209 + s_q7 * z1208;
    const Scalar z1482 = k13 * z540 - z1478 + k10 * z539;  // force on link6, times 0.0825 m, x
    const Scalar z1414 = z1407 * z1409;
    const Scalar z1413 = z1406 * z1409;
    const Scalar z1429 = z1402 - z1407 * z1414;
    const Scalar z1428 = z1401 - z1406 * z1414;
    const Scalar z1424 = z1397 - z1406 * z1413;
    const Scalar z1423 = z1396 - z1405 * z1413;
    const Scalar z1430 = n1 / z1429;
    const Scalar z1427 = z1400 - z1405 * z1414;
    const Scalar z1422 = z1395 - z1404 * z1413;
    const Scalar z1426 = z1399 - z1404 * z1414;
    const Scalar z1421 = z1394 - z1403 * z1413;
    const Scalar z1425 = z1398 - z1403 * z1414;
    const Scalar z1480 = s_q7 * z1212 + c_q7 * z1211;
    const Scalar z1481 = s_q7 * z1211 - c_q7 * z1212;
    const Scalar z1412 = z1405 * z1409;
    const Scalar z1420 = z1393 - z1405 * z1412;
    const Scalar z1419 = z1392 - z1404 * z1412;
    const Scalar z1418 = z1391 - z1403 * z1412;
    const Scalar z1411 = z1404 * z1409;
    const Scalar z1417 = z1390 - z1404 * z1411;
    const Scalar z1416 = z1389 - z1403 * z1411;
    const Scalar z1434 = z1428 * z1430;
    const Scalar z1433 = z1427 * z1430;
    const Scalar z1432 = z1426 * z1430;
    const Scalar z1444 = z1424 - z1428 * z1434;
    const Scalar z1443 = z1423 - z1427 * z1434;
    const Scalar z1440 = z1420 - z1427 * z1433;
    const Scalar z1439 = z1419 - z1426 * z1433;
    const Scalar z1445 = n1 / z1444;
    const Scalar z1442 = z1422 - z1426 * z1434;
    const Scalar z1437 = z1417 - z1426 * z1432;
    const Scalar z1436 = z1416 - z1425 * z1432;
    const Scalar z1438 = z1418 - z1425 * z1433;
    const Scalar z1441 = z1421 - z1425 * z1434;
    const Scalar z1410 = z1403 * z1409;
    // moment on link6, z
    const Scalar z1486 = k54 * z540 - k11 * z589 - k13 * z1190 - k10 * z1191 - n16_over_15 * z1210 + k16 * z1225 + k12
        * z1226 + z1481;
    // moment on link6, y
    const Scalar z1485 = k12 * z540 + k16 * z586 + k10 * z1185 + k55 * z1194 - k11 * z1224 - n16_over_15 * z1479
        + z1213;
    // moment on link6, x
    const Scalar z1484 = k16 * z540 - k12 * z585 + k13 * z1185 + k11 * z1194 - k56 * z1224 - z1480;
    const Scalar z1483 = k10 * z1194 - z1479 - k13 * z1224;  // force on link6, times 0.0825 m, z
    const Scalar z1415 = z1388 - z1403 * z1410;
    const Scalar z1492 = z1483 + k21 * z603 + k18 * z607;  // force on link5, times 0.0825 m, y
    // moment on link5, y
    const Scalar z1495 = k23 * z603 + k22 * z613 + k21 * z1182 - k57 * z1244 - k20 * z1245 + z1486;
    const Scalar z1487 = c_q6 * z1482 + s_q6 * z1228;
    const Scalar z1488 = s_q6 * z1482 - c_q6 * z1228;
    const Scalar z1491 = k18 * z603 - z1487 + k21 * z602;  // force on link5, times 0.0825 m, x
    const Scalar z1493 = k21 * z1244 - z1488 - k18 * z1245;  // force on link5, times 0.0825 m, z
    const Scalar z1489 = s_q6 * z1485 - c_q6 * z1484;
    // moment on link5, x
    const Scalar z1494 = k22 * z603 - k23 * z612 + k18 * z1182 + k20 * z1244 + k58 * z1245 - z1489;
    const Scalar z1490 = c_q6 * z1485 + s_q6 * z1484;
    // moment on link5, z
    const Scalar z1496 = k59 * z603 - k20 * z616 + k18 * z1184 - k21 * z1185 + k22 * z1246 + k23 * z1247 + z1490;
    const Scalar z1502 = z1493 + k30 * z513 - k29 * z517;  // force on link4, times 0.0825 m, y
    const Scalar z1497 = s_q5 * z1492 + c_q5 * z1491;
    const Scalar z1498 = s_q5 * z1491 - c_q5 * z1492;
    const Scalar z1501 = z1497 + k30 * z512 - k29 * z513;  // force on link4, times 0.0825 m, x
    const Scalar z1499 = s_q5 * z1495 - c_q5 * z1494;
    const Scalar z1500 = c_q5 * z1495 + s_q5 * z1494;
    const Scalar z1448 = z1443 * z1445;
    const Scalar z1454 = z1440 - z1443 * z1448;
    const Scalar z1453 = z1439 - z1442 * z1448;
    const Scalar z1452 = z1438 - z1441 * z1448;
    const Scalar z1503 = z1498 + k30 * z1177 + k29 * z1178;  // force on link4, times 0.0825 m, z
    const Scalar z1455 = n1 / z1454;
    const Scalar z1447 = z1442 * z1445;
    const Scalar z1451 = z1437 - z1442 * z1447;
    const Scalar z1450 = z1436 - z1441 * z1447;
    const Scalar z1431 = z1425 * z1430;
    // moment on link4, z
    const Scalar z1506 = k29 * z506 - k30 * z507 - k60 * z513 + k27 * z631 - k33 * z1265 + k28 * z1266 + z1493
        + n256_over_55 * z1497 - z1500;
    // moment on link4, x
    const Scalar z1504 = k33 * z513 + k28 * z627 + k29 * z1174 + k27 * z1177 + k61 * z1178 - z1499 + n256_over_55
        * z1498;
    // moment on link4, y
    const Scalar z1505 = k28 * z513 - k33 * z628 + k30 * z1174 + k62 * z1177 + k27 * z1178 + z1496 + z1498;
    const Scalar z1435 = z1415 - z1425 * z1431;
    const Scalar z1512 = z1503 + k38 * z497 - k36 * z644;  // force on link3, times 0.0825 m, y
    const Scalar z1507 = s_q4 * z1502 - c_q4 * z1501;
    const Scalar z1508 = c_q4 * z1502 + s_q4 * z1501;
    // moment on link3, y
    const Scalar z1515 = k38 * z488 - k37 * z497 + k63 * z500 + k35 * z646 + k40 * z648 - z1506 + z1508;
    const Scalar z1511 = z1507 + k38 * z496 - k36 * z497;  // force on link3, times 0.0825 m, x
    const Scalar z1509 = s_q4 * z1505 - c_q4 * z1504;
    const Scalar z1514 = k36 * z488 - k40 * z497 + k35 * z500 + k64 * z646 - k37 * z647 + z1509;  // moment on link3, x
    const Scalar z1510 = c_q4 * z1505 + s_q4 * z1504;
    // moment on link3, z
    const Scalar z1516 = k36 * z490 - k38 * z491 - k65 * z497 + k40 * z649 - k37 * z650 - k35 * z651 - z1503 + z1510;
    const Scalar z1519 = s_q3 * z1515 + c_q3 * z1514;
    const Scalar z1518 = s_q3 * z1511 - c_q3 * z1512;
    const Scalar z1517 = s_q3 * z1512 + c_q3 * z1511;
    const Scalar z1457 = z1453 * z1455;
    const Scalar z1460 = z1451 - z1453 * z1457;
    const Scalar z1459 = z1450 - z1452 * z1457;
    const Scalar z1446 = z1441 * z1445;
    // moment on link2, x
    const Scalar z1524 = k46 * z480 - k66 * z484 - k47 * z664 - k48 * z665 + z1519 + n632_over_165 * z1518;
    const Scalar z1525 = k48 * z480 - k47 * z484 - k67 * z664 - k46 * z666 - z1516;  // moment on link2, y
    const Scalar z1449 = z1435 - z1441 * z1446;
    const Scalar z1530 = s_q2 * z1524 - c_q2 * z1525;
    const Scalar z1520 = s_q3 * z1514 - c_q3 * z1515;
    // moment on link2, z
    const Scalar z1526 = k68 * z476 - k69 * z477 + k70 * z480 + k47 * z667 - z1520 + n632_over_165 * z1517;
    const Scalar z1538 = u_tau4 + z1506;
    const Scalar z1539 = u_tau5 + z1496;
    const Scalar z1535 = u_tau1 + z1530;
    const Scalar z1461 = n1 / z1460;
    const Scalar z1537 = u_tau3 + z1516;
    const Scalar z1536 = u_tau2 + z1526;
    const Scalar z1456 = z1452 * z1455;
    const Scalar z1458 = z1449 - z1452 * z1456;
    const Scalar z1540 = u_tau6 - z1486;
    const Scalar z1541 = z1214 * z1387 + z1540;
    const Scalar z1462 = z1459 * z1461;
    const Scalar z1463 = z1458 - z1459 * z1462;
    const Scalar z1542 = z1214 * z1386 - z1539 - z1414 * z1541;
    const Scalar z1464 = n1 / z1463;
    const Scalar z1543 = z1214 * z1385 - z1538 - z1413 * z1541 - z1434 * z1542;
    const Scalar z1544 = z1214 * z1384 - z1412 * z1541 - z1433 * z1542 + z1537 - z1448 * z1543;
    const Scalar z1545 = z1214 * z1383 - z1411 * z1541 - z1432 * z1542 - z1447 * z1543 - z1536 - z1457 * z1544;
    const Scalar z1546 = z1214 * z1382 - z1535 - z1410 * z1541 - z1431 * z1542 - z1446 * z1543 - z1456 * z1544 - z1462
        * z1545;
    const Scalar z1547 = z1464 * z1546;
    const Scalar z1548 = z1461 * z1545 - z1462 * z1547;
    const Scalar z1549 = z1455 * z1544 - z1456 * z1547 - z1457 * z1548;
    const Scalar z1550 = z1445 * z1543 - z1446 * z1547 - z1447 * z1548 - z1448 * z1549;
    const Scalar z1554 = z479 - z1549;
    const Scalar z1551 = z1430 * z1542 - z1431 * z1547 - z1432 * z1548 - z1433 * z1549 - z1434 * z1550;
    const Scalar z1555 = z493 - z1550;
    const Scalar z1552 = z1409 * z1541 - z1410 * z1547 - z1411 * z1548 - z1412 * z1549 - z1413 * z1550 - z1414 * z1551;
    const Scalar z1556 = z1176 + z1551;
    const Scalar z1553 = k52 * z1214 - z1382 * z1547 - z1383 * z1548 - z1384 * z1549 - z1385 * z1550 - z1386 * z1551
        - z1387 * z1552;
    const Scalar z1557 = z1187 - z1552;
    const Scalar z1558 = z1193 - z1553;
    accelerations.q1 = z1547;
    accelerations.q2 = z1548;
    accelerations.q3 = z1554;
    accelerations.q4 = -z1555;
    accelerations.q5 = z1556;
    accelerations.q6 = z1557;
    accelerations.q7 = -z1558;
    if (!(traits::regular(-z1463, z468) && traits::regular(-z1460, z450) && traits::regular(-z1454, z424)
        && traits::regular(-z1444, z391) && traits::regular(-z1429, z349) && traits::regular(-z1408,
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
    const Scalar k46 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k47 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k48 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k49 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k50 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k51 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k52 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k53 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k54 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k55 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z53 = n0_316 * v_q2;
    const Scalar z51 = n0_316 * c_q2;
    const Scalar z52 = n0_333 + z51;  // place of link3, z
    const Scalar z54 = n0_316 * z39;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z1575 = k2 * v_q2 - k3 * z39 + k4 * z40;
    const Scalar z1576 = k5 * v_q2 + k4 * z39 - k6 * z40;
    const Scalar z1577 = k7 * v_q2 - k2 * z39 - k5 * z40;
    const Scalar z1559 = c_q3 * z53 + s_q3 * z54;
    const Scalar z1560 = s_q3 * z53 - c_q3 * z54;
    const Scalar z77 = n0_0825 * z56;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z1610 = k9 * s_q2 + k10 * c_q2;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z1616 = k11 * s_q3 - k12 * c_q3;
    const Scalar z80 = v_q4 - z56;
    const Scalar z1619 = s_q2 * z1616 - k13 * c_q2;
    const Scalar z1561 = n0_0825 * z57 - z1560;
    const Scalar z1562 = s_q4 * z77 - c_q4 * z1559;
    const Scalar z1563 = s_q4 * z1559 + c_q4 * z77;
    const Scalar z1578 = k11 * z57 + k13 * z56 - k14 * z1559;
    const Scalar z1579 = k12 * z57 + k13 * z55 - k14 * z1560;
    const Scalar z1580 = k15 * z55 - k16 * z56 - k17 * z57 - k13 * z1560;
    const Scalar z1581 = k18 * z57 + k16 * z55 - k19 * z56 + k13 * z1559;
    const Scalar z1582 = k17 * z55 + k18 * z56 - k20 * z57 + k11 * z1559 + k12 * z1560;
    const Scalar z104 = v_q5 - z79;
    const Scalar z103 = c_q5 * z80 + s_q5 * z78;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z119 = v_q6 + z103;
    const Scalar z1564 = n0_384 * z80 + z1562;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z1566 = n0_384 * z78 - z1561 - n0_0825 * z79;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z1565 = n0_0825 * z80 + z1563;
    const Scalar z1567 = c_q5 * z1564 + s_q5 * z1566;
    const Scalar z1568 = s_q5 * z1564 - c_q5 * z1566;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z1637 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z1572 = n0_088 * z118 + z1568;
    const Scalar z139 = v_q7 - z118;
    const Scalar z1639 = n0_0825 - z1637;
    const Scalar z1583 = k23 * z80 + k24 * z79 + k25 * z1562;
    const Scalar z1640 = c_q3 * z1639;
    const Scalar z1584 = k26 * z80 + k24 * z78 + k25 * z1563;
    const Scalar z1585 = k23 * z78 - k26 * z79 - k25 * z1561;
    const Scalar z1586 = k27 * z80 + k28 * z78 - k29 * z79 - k23 * z1561 + k24 * z1563;
    const Scalar z1587 = k29 * z78 - k30 * z79 - k31 * z80 - k26 * z1561 - k24 * z1562;
    const Scalar z1569 = s_q6 * z1565 + c_q6 * z1567;
    const Scalar z1588 = k32 * z80 + k27 * z78 + k31 * z79 + k23 * z1562 + k26 * z1563;
    const Scalar z1570 = s_q6 * z1567 - c_q6 * z1565;
    const Scalar z1658 = k33 * s_q6 + k34 * c_q6;
    const Scalar z1648 = k35 * s_q5 + k36 * c_q5;
    const Scalar z1649 = k36 * s_q5 - k35 * c_q5;
    const Scalar z1622 = n0_0825 * c_q3;
    const Scalar z1625 = s_q2 * z1622 - n0_316 * c_q2;
    const Scalar z1589 = k37 * z103 - k35 * z104 - k38 * z1567;
    const Scalar z1590 = k37 * z102 + k36 * z104 - k38 * z1568;
    const Scalar z1591 = k35 * z102 + k36 * z103 + k38 * z1565;
    const Scalar z1628 = n0_333 - z1625;
    const Scalar z1638 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z1642 = n0_316 - z1638;
    const Scalar z1592 = k39 * z102 - k40 * z103 + k41 * z104 + k35 * z1565 - k37 * z1568;
    const Scalar z1644 = s_q2 * z1640 - c_q2 * z1642;
    const Scalar z1571 = n0_088 * z119 + z1570;
    const Scalar z1593 = k40 * z102 - k42 * z103 + k43 * z104 - k36 * z1565 + k37 * z1567;
    const Scalar z1659 = k34 * s_q6 - k33 * c_q6;
    const Scalar z1594 = k41 * z102 - k43 * z103 + k44 * z104 + k35 * z1567 - k36 * z1568;
    const Scalar z1660 = k45 * s_q5 - c_q5 * z1658;
    const Scalar z1573 = s_q7 * z1572 + c_q7 * z1569;
    const Scalar z1661 = k45 * c_q5 + s_q5 * z1658;
    const Scalar z1629 = k23 * s_q4 + k26 * c_q4;
    const Scalar z1650 = k37 * s_q4 - c_q4 * z1648;
    const Scalar z1652 = s_q3 * z1649 + c_q3 * z1650;
    const Scalar z1630 = k26 * s_q4 - k23 * c_q4;
    const Scalar z1647 = n0_333 - z1644;
    const Scalar z1651 = k37 * c_q4 + s_q4 * z1648;
    const Scalar z1574 = s_q7 * z1569 - c_q7 * z1572;
    const Scalar z1670 = n0_088 * c_q6;
    const Scalar z1655 = c_q2 * z1651 + s_q2 * z1652;
    const Scalar z1671 = n0_088 * s_q6;
    const Scalar z1672 = c_q5 * z1670;
    const Scalar z1675 = n0_384 + z1671;
    const Scalar z1674 = n0_0825 - z1672;
    const Scalar z1673 = s_q5 * z1670;
    const Scalar z1631 = k24 * s_q3 - c_q3 * z1629;
    const Scalar z1634 = c_q2 * z1630 + s_q2 * z1631;
    const Scalar z1687 = k46 * s_q7 + k47 * c_q7;
    const Scalar z1688 = k47 * s_q7 - k46 * c_q7;
    const Scalar z1595 = k45 * z118 - k33 * z119 + k48 * z1569;
    const Scalar z1596 = k45 * z117 + k34 * z119 + k48 * z1570;
    const Scalar z1597 = k33 * z117 + k34 * z118 + k48 * z1568;
    const Scalar z1598 = k49 * z117 + k50 * z118 - k51 * z119 + k33 * z1568 + k45 * z1570;
    const Scalar z1599 = k52 * z119 + k50 * z117 + k53 * z118 + k34 * z1568 + k45 * z1569;
    const Scalar z1689 = k54 * s_q6 + c_q6 * z1687;
    const Scalar z1600 = k51 * z117 - k52 * z118 - k55 * z119 + k33 * z1569 - k34 * z1570;
    const Scalar z1690 = s_q6 * z1687 - k54 * c_q6;
    const Scalar z1676 = s_q4 * z1675 + c_q4 * z1674;
    const Scalar z1677 = s_q4 * z1674 - c_q4 * z1675;
    const Scalar z1691 = s_q5 * z1688 + c_q5 * z1689;
    const Scalar z1662 = s_q4 * z1659 + c_q4 * z1660;
    const Scalar z1678 = n0_0825 - z1676;
    const Scalar z1692 = s_q5 * z1689 - c_q5 * z1688;
    const Scalar z1681 = n0_316 - z1677;
    const Scalar z1693 = s_q4 * z1690 - c_q4 * z1691;
    const Scalar z1664 = s_q3 * z1661 + c_q3 * z1662;
    const Scalar z1679 = s_q3 * z1673 - c_q3 * z1678;
    const Scalar z1694 = c_q4 * z1690 + s_q4 * z1691;
    const Scalar z1663 = s_q4 * z1660 - c_q4 * z1659;
    const Scalar z1695 = s_q3 * z1692 + c_q3 * z1693;
    const Scalar z1683 = c_q2 * z1681 + s_q2 * z1679;
    const Scalar z1601 = k54 * z138 - k46 * z139 + k56 * z1573;
    const Scalar z1602 = k54 * z137 - k47 * z139 - k56 * z1574;
    const Scalar z1603 = k46 * z137 - k47 * z138 + k56 * z1571;
    const Scalar z1604 = k57 * z137 + k58 * z138 - k59 * z139 + k46 * z1571 - k54 * z1574;
    const Scalar z1605 = k58 * z137 + k60 * z138 + k61 * z139 - k47 * z1571 + k54 * z1573;
    const Scalar z1606 = k59 * z137 - k61 * z138 - k62 * z139 + k46 * z1573 - k47 * z1574;
    const Scalar z1667 = s_q2 * z1664 - c_q2 * z1663;
    const Scalar z1686 = n0_333 + z1683;
    const Scalar z1698 = c_q2 * z1694 + s_q2 * z1695;
    result.kinetic = k63 * v_q1 * v_q1 + n0_5 * (v_q2 * z1577 - z39 * z1575 - z40 * z1576 - z1559 * z1578 - z1560
        * z1579 - z56 * z1581 + z1563 * z1584 + z55 * z1580 + z1562 * z1583 - z1561 * z1585 - z57 * z1582 + z1565
        * z1591 + z78 * z1586 + z80 * z1588 - z79 * z1587 - z1567 * z1589 + z102 * z1592 - z103 * z1593 + z104 * z1594
        + z1569 * z1595 - z1568 * (z1590 - z1597) + z1570 * z1596 + z118 * z1599 + z117 * z1598 - z119 * z1600 + z1571
        * z1603 + z1573 * z1601 - z1574 * z1602 + z137 * z1604 + z138 * z1605 - z139 * z1606);
    result.force_function = -k65 - k66 * z52 - k67 * z1628 - k68 * z1647 - k69 * z1686 - n9_81 * (z1610 + z1619 - z1634
        - z1655 + z1667 + z1698);
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z296 = k0 * s_q7 - k1 * c_q7;
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
    const Scalar z316 = c_q5 * z308 + s_q5 * z311;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z139 = v_q7 - z118;
    const Scalar z319 = z310 - n256_over_55 * z313 - z316;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z336 = z301 + z304;
    const Scalar z337 = n2 * z305;
    const Scalar z338 = s_q6 * z336 - c_q6 * z337;
    const Scalar z346 = k19 - z311;
    const Scalar z344 = k20 - z264;
    const Scalar z343 = k21 - z310;
    const Scalar z315 = s_q5 * z308 - c_q5 * z311;
    const Scalar z317 = n256_over_55 * z314 + z315;
    const Scalar z318 = z312 - z314;
    const Scalar z283 = c_q4 * z278 + s_q4 * z277;
    const Scalar z285 = z274 - z283;
    const Scalar z339 = s_q6 * z338;
    const Scalar z342 = c_q6 * z338 + z305;
    const Scalar z340 = z304 - z339;
    const Scalar z341 = z301 - z339;
    const Scalar z347 = k22 + z342;
    const Scalar z323 = s_q4 * z317 - c_q4 * z318;
    const Scalar z345 = k23 - z340;
    const Scalar z284 = z279 + z281;
    const Scalar z321 = s_q4 * z313 - c_q4 * z310;
    const Scalar z282 = s_q4 * z278 - c_q4 * z277;
    const Scalar z349 = k24 + z341;
    const Scalar z325 = z314 - z323;
    const Scalar z348 = k25 + z312;
    const Scalar z351 = s_q5 * z344 + c_q5 * z343;
    const Scalar z350 = s_q5 * z343 - c_q5 * z344;
    const Scalar z353 = s_q5 * z347 - c_q5 * z348;
    const Scalar z352 = s_q5 * z348 + c_q5 * z347;
    const Scalar z324 = z319 + z321;
    const Scalar z288 = s_q3 * z284 - c_q3 * z282;
    const Scalar z290 = n632_over_165 * z287 - z288;
    const Scalar z354 = n256_over_55 * z351 - z352;
    const Scalar z320 = s_q4 * z310 + c_q4 * z313;
    const Scalar z322 = s_q4 * z318 + c_q4 * z317;
    const Scalar z289 = c_q3 * z284 + s_q3 * z282;
    const Scalar z356 = n256_over_55 * z350 - z353;
    const Scalar z291 = n632_over_165 * z286 - z289;
    const Scalar z355 = z349 + z351;
    const Scalar z357 = c_q4 * z350;
    const Scalar z326 = s_q3 * z314 - c_q3 * z320;
    const Scalar z329 = c_q3 * z324 + s_q3 * z322;
    const Scalar z331 = n632_over_165 * z326 + z329;
    const Scalar z327 = c_q3 * z314 + s_q3 * z320;
    const Scalar z328 = s_q3 * z324 - c_q3 * z322;
    const Scalar z330 = n632_over_165 * z327 - z328;
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
    const Scalar z393 = s_q4 * z386 + c_q4 * z385;
    const Scalar z360 = c_q4 * z355 + s_q4 * z354;
    const Scalar z362 = z351 - z360;
    const Scalar z376 = s_q5 * z375;
    const Scalar z379 = c_q5 * z375 - z346;
    const Scalar z392 = s_q4 * z385 - c_q4 * z386;
    const Scalar z382 = z350 + z379;
    const Scalar z377 = z345 + z376;
    const Scalar z378 = z308 - z376;
    const Scalar z358 = s_q4 * z350;
    const Scalar z380 = n512_over_55 * z309 + z377;
    const Scalar z384 = z378 + n512_over_55 * z309 + n2 * z351;
    const Scalar z389 = k32 + z382;
    const Scalar z359 = s_q4 * z355 - c_q4 * z354;
    const Scalar z387 = k33 + z380;
    const Scalar z394 = s_q4 * z390 + c_q4 * z389;
    const Scalar z395 = s_q4 * z389 - c_q4 * z390;
    const Scalar z391 = k34 + z384;
    const Scalar z361 = z356 - z358;
    const Scalar z364 = s_q3 * z357 - c_q3 * z351;
    const Scalar z365 = c_q3 * z359 + s_q3 * z361;
    const Scalar z396 = z391 - z393;
    const Scalar z363 = s_q3 * z351 + c_q3 * z357;
    const Scalar z367 = n632_over_165 * z364 + z365;
    const Scalar z366 = s_q3 * z359 - c_q3 * z361;
    const Scalar z368 = n632_over_165 * z363 - z366;
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
    const Scalar z426 = s_q3 * z419 - c_q3 * z418;
    const Scalar z410 = s_q4 * z409;
    const Scalar z413 = c_q4 * z409 + z388;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z415 = z392 - z413;
    const Scalar z411 = z387 + z410;
    const Scalar z412 = z383 - z410;
    const Scalar z420 = k39 + z411;
    const Scalar z417 = n2 * z393 - z412;
    const Scalar z422 = k40 - z415;
    const Scalar z425 = c_q3 * z419 + s_q3 * z418;
    const Scalar z435 = z416 - z420;
    const Scalar z424 = k41 - z417;
    const Scalar z427 = s_q3 * z423 - c_q3 * z422;
    const Scalar z437 = c_q3 * z436 + s_q3 * z435;
    const Scalar z428 = c_q3 * z423 + s_q3 * z422;
    const Scalar z429 = n632_over_165 * z426 + z427;
    const Scalar z430 = n632_over_165 * z425 + z428;
    const Scalar z398 = s_q3 * z392;
    const Scalar z399 = c_q3 * z394 + s_q3 * z396;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z372 = s_q2 * z367 - c_q2 * z362;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z480 = z39 * z40;
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z482 = z39 * z39;
    const Scalar z476 = k42 * s_q2;
    const Scalar z477 = k42 * c_q2;
    const Scalar z483 = z481 + z482;
    const Scalar z494 = z56 * z56;
    const Scalar z495 = z57 * z57;
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z438 = s_q3 * z437;
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z448 = k43 - z441;
    const Scalar z439 = z420 + z438;
    const Scalar z440 = z416 - z438;
    const Scalar z447 = k44 + z429;
    const Scalar z442 = k45 * z392 - z439;
    const Scalar z443 = k45 * z392 - z440;
    const Scalar z456 = n2 * z447;
    const Scalar z449 = k46 + z430;
    const Scalar z406 = c_q2 * z395 + s_q2 * z401;
    const Scalar z446 = k47 - z442;
    const Scalar z450 = k48 - z443;
    const Scalar z499 = z55 * z57;
    const Scalar z496 = z494 + z495;
    const Scalar z497 = z55 * z56;
    const Scalar z510 = z79 * z79;
    const Scalar z511 = z80 * z80;
    const Scalar z513 = z78 * z79;
    const Scalar z512 = z510 + z511;
    const Scalar z520 = z79 * z80;
    const Scalar z516 = z78 * z78;
    const Scalar z517 = z511 + z516;
    const Scalar z518 = z78 * z80;
    const Scalar z554 = z139 * z139;
    const Scalar z559 = z137 * z137;
    const Scalar z537 = z118 * z118;
    const Scalar z540 = z117 * z118;
    const Scalar z553 = z138 * z138;
    const Scalar z563 = z138 * z139;
    const Scalar z556 = z137 * z138;
    const Scalar z560 = z554 + z559;
    const Scalar z561 = z137 * z139;
    const Scalar z565 = z553 - z554;
    const Scalar z538 = z119 * z119;
    const Scalar z555 = z553 + z554;
    const Scalar z539 = z537 + z538;
    const Scalar z542 = z117 * z119;
    const Scalar z455 = z424 - z446;
    const Scalar z457 = c_q2 * z456 + s_q2 * z455;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z566 = z554 - z559;
    const Scalar z581 = z117 * z117;
    const Scalar z458 = s_q2 * z457;
    const Scalar z589 = z537 - z581;
    const Scalar z583 = z118 * z119;
    const Scalar z569 = z553 - z559;
    const Scalar z585 = z537 - z538;
    const Scalar z586 = z538 - z581;
    const Scalar z582 = z538 + z581;
    const Scalar z460 = z424 - z458;
    const Scalar z600 = z103 * z103;
    const Scalar z601 = z104 * z104;
    const Scalar z454 = c_q2 * z449 + s_q2 * z448;
    const Scalar z468 = k49 + z460;
    const Scalar z444 = k50 + z426;
    const Scalar z602 = z600 + z601;
    const Scalar z445 = k51 - z392;
    const Scalar z683 = a_q1 * s_q2;
    const Scalar z685 = v_q2 * z40 + z683;  // angular acceleration of link2, x
    const Scalar z684 = a_q1 * c_q2;
    const Scalar z686 = v_q2 * z39 - z684;  // angular acceleration of link2, y
    const Scalar z687 = a_q2 - z480;
    const Scalar z691 = z476 - n632_over_165 * z687;
    const Scalar z689 = a_q2 * s_q3 - c_q3 * z685;
    const Scalar z697 = a_q3 - z686;  // angular acceleration of link3, z
    const Scalar z688 = z478 + z685;
    const Scalar z690 = a_q2 * c_q3 + s_q3 * z685;
    const Scalar z695 = v_q3 * z56 + z689;  // angular acceleration of link3, x
    const Scalar z696 = v_q3 * z55 - z690;  // angular acceleration of link3, y
    const Scalar z692 = n632_over_165 * z688;
    const Scalar z693 = s_q3 * z692 - c_q3 * z691;
    const Scalar z694 = s_q3 * z691 + c_q3 * z692;
    const Scalar z700 = s_q4 * z697 + c_q4 * z695;
    const Scalar z699 = z499 + z696;
    const Scalar z709 = a_q4 + z696;  // angular acceleration of link4, z
    const Scalar z707 = v_q4 * z79 - z700;  // angular acceleration of link4, x
    const Scalar z701 = s_q4 * z695 - c_q4 * z697;
    const Scalar z704 = z488 + z699;
    const Scalar z708 = v_q4 * z78 + z701;  // angular acceleration of link4, y
    const Scalar z698 = z497 + z697;
    const Scalar z702 = z496 - z693;
    const Scalar z710 = z513 + z709;
    const Scalar z714 = s_q5 * z709 + c_q5 * z707;
    const Scalar z703 = z694 + z698;
    const Scalar z713 = z520 + z707;
    const Scalar z721 = v_q5 * z103 + z714;  // angular acceleration of link5, x
    const Scalar z705 = s_q4 * z704 - c_q4 * z702;
    const Scalar z706 = c_q4 * z704 + s_q4 * z702;
    const Scalar z711 = z513 - z709;
    const Scalar z715 = s_q5 * z707 - c_q5 * z709;
    const Scalar z712 = z518 + z708;
    const Scalar z716 = z512 - n256_over_55 * z710 + z705;
    const Scalar z718 = z703 + n256_over_55 * z713 + z712;
    const Scalar z717 = n256_over_55 * z517 - z711 - z706;
    const Scalar z719 = c_q5 * z716 + s_q5 * z718;
    const Scalar z720 = s_q5 * z716 - c_q5 * z718;
    const Scalar z603 = z102 * z103;
    const Scalar z722 = v_q5 * z102 + z715;  // angular acceleration of link5, y
    const Scalar z606 = z102 * z102;
    const Scalar z723 = a_q5 - z708;  // angular acceleration of link5, z
    const Scalar z610 = z103 * z104;
    const Scalar z608 = z102 * z104;
    const Scalar z616 = z600 - z606;
    const Scalar z612 = z600 - z601;
    const Scalar z613 = z601 - z606;
    const Scalar z607 = z601 + z606;
    const Scalar z725 = c_q6 * z723 + s_q6 * z721;
    const Scalar z724 = s_q6 * z723 - c_q6 * z721;
    const Scalar z727 = c_q6 * z717 + s_q6 * z719;
    const Scalar z729 = v_q6 * z117 - z725;  // angular acceleration of link6, y
    const Scalar z728 = v_q6 * z118 + z724;  // angular acceleration of link6, x
    const Scalar z726 = s_q6 * z717 - c_q6 * z719;
    const Scalar z627 = z510 - z511;
    const Scalar z628 = z511 - z516;
    const Scalar z730 = a_q6 - z722;  // angular acceleration of link6, z
    const Scalar z731 = z540 + z730;
    const Scalar z631 = z510 - z516;
    const Scalar z732 = z542 + z729;
    const Scalar z645 = z56 * z57;
    const Scalar z647 = z494 - z495;
    const Scalar z643 = z55 * z55;
    const Scalar z733 = s_q7 * z730 + c_q7 * z728;
    const Scalar z648 = z495 - z643;
    const Scalar z644 = z495 + z643;
    const Scalar z734 = s_q7 * z728 - c_q7 * z730;
    const Scalar z736 = z727 - n16_over_15 * z731;
    const Scalar z735 = n16_over_15 * z539 + z726;
    const Scalar z737 = z720 + n16_over_15 * z732;
    const Scalar z651 = z494 - z643;
    const Scalar z738 = s_q7 * z737 - c_q7 * z735;
    const Scalar z662 = z40 * z40;
    const Scalar z739 = s_q7 * z735 + c_q7 * z737;
    const Scalar z665 = z481 - z662;
    const Scalar z740 = v_q7 * z138 - z733;  // angular acceleration of link7, x
    const Scalar z666 = z481 - z482;
    const Scalar z741 = v_q7 * z137 + z734;  // angular acceleration of link7, y
    const Scalar z667 = z482 - z662;
    const Scalar z790 = z518 - z708;
    const Scalar z804 = z499 - z696;
    const Scalar z742 = a_q7 + z729;  // angular acceleration of link7, z
    const Scalar z762 = z542 - z729;
    const Scalar z744 = z556 - z742;
    const Scalar z743 = z556 + z742;
    const Scalar z1387 = k52 * z267;
    const Scalar z746 = z563 + z740;
    const Scalar z745 = z561 + z741;
    const Scalar z750 = k2 * z560 - k3 * z744;  // force on link7, times 0.0825 m, y
    const Scalar z749 = k3 * z555 - k2 * z743;  // force on link7, times 0.0825 m, x
    const Scalar z748 = z561 - z741;
    const Scalar z747 = z563 - z740;
    // moment on link7, z
    const Scalar z754 = k0 * z556 + k8 * z569 + k6 * z742 - k5 * z747 + k3 * z739 + k2 * z738 - k4 * z748;
    const Scalar z755 = s_q7 * z750 + c_q7 * z749;
    const Scalar z751 = k2 * z746 + k3 * z745;  // force on link7, times 0.0825 m, z
    const Scalar z764 = k13 * z582 - z751 + k10 * z731;  // force on link6, times 0.0825 m, y
    const Scalar z759 = z540 - z730;
    const Scalar z763 = k10 * z539 + z755 + k13 * z759;  // force on link6, times 0.0825 m, x
    const Scalar z761 = z583 - z728;
    const Scalar z756 = s_q7 * z749 - c_q7 * z750;
    const Scalar z1403 = z295 * z1387 - z335;
    const Scalar z760 = z583 + z728;
    const Scalar z1408 = z267 * z1387 - z308;
    const Scalar z773 = z603 - z723;
    const Scalar z1386 = k52 * z272;
    const Scalar z1398 = z295 * z1386 - z372;
    const Scalar z1407 = z272 * z1387 - z312;
    const Scalar z765 = k10 * z732 - z756 - k13 * z760;  // force on link6, times 0.0825 m, z
    const Scalar z1409 = n1 / z1408;
    const Scalar z774 = z603 + z723;
    const Scalar z780 = k20 * z607 + z765 + k21 * z774;  // force on link5, times 0.0825 m, y
    const Scalar z789 = z520 - z707;
    const Scalar z769 = c_q6 * z763 + s_q6 * z764;
    const Scalar z779 = k21 * z602 - z769 + k20 * z773;  // force on link5, times 0.0825 m, x
    const Scalar z776 = z610 + z721;
    const Scalar z1402 = z272 * z1386 - z349;
    const Scalar z777 = z610 - z721;
    const Scalar z770 = s_q6 * z763 - c_q6 * z764;
    const Scalar z775 = z608 + z722;
    const Scalar z778 = z608 - z722;
    const Scalar z781 = z770 - k21 * z775 + k20 * z776;  // force on link5, times 0.0825 m, z
    const Scalar z1414 = z1407 * z1409;
    const Scalar z1385 = k52 * z279;
    const Scalar z1394 = z295 * z1385 - z406;
    const Scalar z785 = s_q5 * z780 + c_q5 * z779;
    const Scalar z791 = z785 + k30 * z512 - k29 * z710;  // force on link4, times 0.0825 m, x
    const Scalar z792 = z781 + k29 * z517 - k30 * z711;  // force on link4, times 0.0825 m, y
    const Scalar z1401 = z279 * z1386 + z356;
    const Scalar z1406 = z279 * z1387 - z319;
    const Scalar z786 = s_q5 * z779 - c_q5 * z780;
    const Scalar z1425 = z1398 - z1403 * z1414;
    const Scalar z1397 = z279 * z1385 - z391;
    const Scalar z1413 = z1406 * z1409;
    const Scalar z1424 = z1397 - z1406 * z1413;
    const Scalar z1421 = z1394 - z1403 * z1413;
    const Scalar z801 = z497 - z697;
    const Scalar z803 = z645 - z695;
    const Scalar z802 = z645 + z695;
    const Scalar z793 = z786 + k29 * z713 + k30 * z712;  // force on link4, times 0.0825 m, z
    const Scalar z806 = k36 * z644 - z793 - k38 * z698;  // force on link3, times 0.0825 m, y
    const Scalar z797 = s_q4 * z792 + c_q4 * z791;
    const Scalar z1428 = z1401 - z1406 * z1414;
    const Scalar z805 = k38 * z496 - z797 - k36 * z801;  // force on link3, times 0.0825 m, x
    const Scalar z815 = a_q2 + z480;
    const Scalar z798 = s_q4 * z791 - c_q4 * z792;
    const Scalar z1429 = z1402 - z1407 * z1414;
    const Scalar z1430 = n1 / z1429;
    const Scalar z1384 = k52 * z285;
    const Scalar z1391 = z295 * z1384 - z434;
    const Scalar z1396 = z285 * z1385 + z395;
    const Scalar z1400 = z285 * z1386 - z362;
    const Scalar z1405 = z285 * z1387 + z325;
    const Scalar z1423 = z1396 - z1405 * z1413;
    const Scalar z1427 = z1400 - z1405 * z1414;
    const Scalar z816 = z479 + z686;
    const Scalar z818 = z479 - z686;
    const Scalar z1393 = z285 * z1384 - z424;
    const Scalar z1412 = z1405 * z1409;
    const Scalar z1420 = z1393 - z1405 * z1412;
    const Scalar z1418 = z1391 - z1403 * z1412;
    const Scalar z812 = c_q3 * z806 + s_q3 * z805;
    const Scalar z1434 = z1428 * z1430;
    const Scalar z1433 = z1427 * z1430;
    const Scalar z817 = z478 - z685;
    const Scalar z1383 = k52 * z291;
    const Scalar z1389 = z295 * z1383 + z454;
    const Scalar z1392 = z291 * z1384 - z430;
    const Scalar z1395 = z291 * z1385 - z402;
    const Scalar z1399 = z291 * z1386 - z368;
    const Scalar z1404 = z291 * z1387 + z331;
    const Scalar z1419 = z1392 - z1404 * z1412;
    const Scalar z1422 = z1395 - z1404 * z1413;
    const Scalar z1426 = z1399 - z1404 * z1414;
    const Scalar z1390 = z291 * z1383 - z450;
    const Scalar z1411 = z1404 * z1409;
    const Scalar z1417 = z1390 - z1404 * z1411;
    const Scalar z1416 = z1389 - z1403 * z1411;
    const Scalar z1432 = z1426 * z1430;
    const Scalar z1382 = k52 * z295;
    const Scalar z1388 = z295 * z1382 - z468;
    const Scalar z1410 = z1403 * z1409;
    const Scalar z1431 = z1425 * z1430;
    const Scalar z811 = s_q3 * z806 - c_q3 * z805;
    const Scalar z1788 = k6 * z563 + k4 * z565 + k2 * z736 + k0 * z740 - k5 * z744 - k8 * z745;  // moment on link7, x
    const Scalar z1789 = k54 * z561 + k5 * z566 + k3 * z736 + k4 * z743 - k8 * z746;  // moment on link7, y
    // moment on link6, y
    const Scalar z1793 = k55 * z542 + k16 * z586 + k10 * z720 + k12 * z759 - k11 * z760 - n16_over_15 * z756 + z754;
    const Scalar z1444 = z1424 - z1428 * z1434;
    const Scalar z1415 = z1388 - z1403 * z1410;
    const Scalar z1443 = z1423 - z1427 * z1434;
    const Scalar z1440 = z1420 - z1427 * z1433;
    const Scalar z1445 = n1 / z1444;
    const Scalar z1439 = z1419 - z1426 * z1433;
    const Scalar z1442 = z1422 - z1426 * z1434;
    const Scalar z1437 = z1417 - z1426 * z1432;
    const Scalar z1436 = z1416 - z1425 * z1432;
    const Scalar z1438 = z1418 - z1425 * z1433;
    const Scalar z1441 = z1421 - z1425 * z1434;
    const Scalar z1435 = z1415 - z1425 * z1431;
    const Scalar z1829 = z510 + z516;
    const Scalar z1825 = z494 + z643;
    const Scalar z1821 = z482 + z662;
    const Scalar z1828 = n2 * z57;
    const Scalar z1790 = s_q7 * z1789 - c_q7 * z1788;
    // moment on link6, x
    const Scalar z1792 = k15 * z583 + k12 * z585 - k13 * z720 - k14 * z728 - k16 * z731 - k11 * z732 + z1790;
    const Scalar z1830 = n2 * z78;
    const Scalar z1831 = n2 * z79;
    const Scalar z1791 = c_q7 * z1789 + s_q7 * z1788;
    // moment on link6, z
    const Scalar z1794 = k14 * z540 - k11 * z589 + k15 * z730 - k13 * z726 - k10 * z727 + k16 * z761 + k12 * z762
        - n16_over_15 * z751 - z1791;
    const Scalar z1798 = k56 * z608 - k22 * z613 - k21 * z717 - k25 * z773 + k19 * z776 - z1794;  // moment on link5, y
    const Scalar z1795 = c_q6 * z1792 + s_q6 * z1793;
    // moment on link5, x
    const Scalar z1797 = k24 * z610 - k25 * z612 + k20 * z717 + k23 * z721 + k22 * z774 + k19 * z775 - z1795;
    const Scalar z1796 = s_q6 * z1792 - c_q6 * z1793;
    // moment on link5, z
    const Scalar z1799 = k23 * z603 - k19 * z616 + k20 * z719 - k21 * z720 - k24 * z723 + k22 * z777 + k25 * z778
        - z1796;
    // moment on link4, y
    const Scalar z1803 = k57 * z518 - k32 * z628 + k28 * z710 + k30 * z703 + k27 * z713 + z1799 + z786;
    const Scalar z1800 = s_q5 * z1798 + c_q5 * z1797;
    // moment on link4, x
    const Scalar z1802 = k34 * z520 + k28 * z627 + k32 * z711 + k29 * z703 + k33 * z707 + k27 * z712 + z1800
        + n256_over_55 * z786;
    const Scalar z1801 = s_q5 * z1797 - c_q5 * z1798;
    // moment on link4, z
    const Scalar z1804 = k33 * z513 + k34 * z709 - k27 * z631 + k32 * z789 - k29 * z705 - k30 * z706 - k28 * z790 + z781
        - n256_over_55 * z785 + z1801;
    // moment on link3, y
    const Scalar z1808 = k58 * z499 + k38 * z488 + k40 * z648 - k37 * z801 + k35 * z802 + z1804 + z798;
    const Scalar z1805 = s_q4 * z1803 - c_q4 * z1802;
    // moment on link3, x
    const Scalar z1807 = k36 * z488 + k41 * z645 - k37 * z647 + k39 * z695 - k40 * z698 + k35 * z699 + z1805;
    const Scalar z1826 = n2 * z55;
    const Scalar z1827 = n2 * z56;
    const Scalar z1810 = c_q3 * z1807 + s_q3 * z1808;
    const Scalar z1806 = c_q4 * z1803 + s_q4 * z1802;
    // moment on link3, z
    const Scalar z1809 = k39 * z497 - k41 * z697 - k35 * z651 - k40 * z803 + k37 * z804 + k36 * z693 - k38 * z694 - z793
        + z1806;
    // moment on link2, x
    const Scalar z1812 = k48 * z478 + k47 * z685 + k46 * z665 - k43 * z815 + k44 * z816 - z1810 - n632_over_165 * z812;
    const Scalar z1813 = k59 * z479 + k43 * z666 + k46 * z687 + k44 * z688 + z1809;  // moment on link2, y
    const Scalar z1448 = z1443 * z1445;
    const Scalar z1454 = z1440 - z1443 * z1448;
    const Scalar z1453 = z1439 - z1442 * z1448;
    const Scalar z1452 = z1438 - z1441 * z1448;
    const Scalar z1824 = n2 * v_q2;
    const Scalar z1822 = n2 * z39;
    const Scalar z1455 = n1 / z1454;
    const Scalar z1823 = n2 * z40;
    const Scalar z1447 = z1442 * z1445;
    const Scalar z1451 = z1437 - z1442 * z1447;
    const Scalar z1450 = z1436 - z1441 * z1447;
    const Scalar z1446 = z1441 * z1445;
    const Scalar z1833 = z600 + z606;
    const Scalar z1449 = z1435 - z1441 * z1446;
    const Scalar z1841 = z553 + z559;
    const Scalar z1837 = z537 + z581;
    const Scalar z1840 = n2 * z119;
    const Scalar z1836 = n2 * z104;
    const Scalar z1832 = n2 * z80;
    const Scalar z1839 = n2 * z118;
    const Scalar z1838 = n2 * z117;
    const Scalar z1834 = n2 * z102;
    const Scalar z1835 = n2 * z103;
    const Scalar z1820 = n2 * v_q1;
    const Scalar z1811 = s_q3 * z1807 - c_q3 * z1808;
    // moment on link2, z
    const Scalar z1814 = k48 * a_q2 - k51 * z476 + k50 * z477 - k47 * z480 - k44 * z667 + k43 * z817 - k46 * z818
        + z1811 + n632_over_165 * z811;
    const Scalar z1457 = z1453 * z1455;
    const Scalar z1460 = z1451 - z1453 * z1457;
    const Scalar z1459 = z1450 - z1452 * z1457;
    const Scalar z1456 = z1452 * z1455;
    const Scalar z1458 = z1449 - z1452 * z1456;
    const Scalar z1844 = n2 * z139;
    const Scalar z1461 = n1 / z1460;
    const Scalar z1842 = n2 * z137;
    const Scalar z1843 = n2 * z138;
    const Scalar z1845 = k4 * z1842;
    const Scalar z1846 = k5 * z1843;
    const Scalar z1847 = k8 * z1844;
    const Scalar z1816 = s_q2 * z1812 - c_q2 * z1813;
    const Scalar z1819 = k49 * a_q1 + z1816;  // moment on link1, z
    const Scalar z1462 = z1459 * z1461;
    const Scalar z1848 = k2 * z1844;
    const Scalar z1463 = z1458 - z1459 * z1462;
    const Scalar z1849 = k3 * z1844;
    const Scalar z1464 = n1 / z1463;
    const Scalar z1852 = k60 * z1844 + k4 * z1843;
    const Scalar z1854 = k5 * z1842 - k61 * z1844;
    const Scalar z1858 = k60 * z1842 + k8 * z1843;
    const Scalar z1851 = z1846 + z1847;
    const Scalar z1855 = z1845 - z1847;
    const Scalar z1859 = z1845 + z1846;
    const Scalar z1857 = k8 * z1842 + k61 * z1843;
    const Scalar z1865 = z1852 + z1854;
    const Scalar z1864 = z1851 - z1855;
    const Scalar z1870 = c_q7 * z1865 + s_q7 * z1864;
    const Scalar z1860 = n16_over_15 * z1840;
    const Scalar z1868 = s_q7 * z1858 - c_q7 * z1857;
    const Scalar z1856 = k5 * z1844 + k61 * z1842;
    const Scalar z1853 = k61 * z1843 - k4 * z1844;
    const Scalar z1850 = k2 * z1842 - k3 * z1843;
    const Scalar z1871 = s_q7 * z1870;
    const Scalar z1861 = n16_over_15 * z1839;
    const Scalar z1866 = s_q7 * z1856 - c_q7 * z1853;
    const Scalar z1875 = c_q7 * z1870 - z1852;
    const Scalar z1874 = c_q7 * z1870 - z1854;
    const Scalar z1888 = k62 * z1840 - z1866 + k12 * z1839;
    const Scalar z1889 = z1874 + k63 * z1839 - k12 * z1840;
    const Scalar z1877 = z1868 + z265 * z1860 + n16_over_15 * z1850;
    const Scalar z1890 = k16 * z1838 - z1877 - k63 * z1840;
    const Scalar z1862 = s_q7 * z1849 - c_q7 * z1848;
    const Scalar z1872 = z1851 - z1871;
    const Scalar z1876 = n16_over_15 * z1862 + z1872;
    const Scalar z1873 = z1855 + z1871;
    const Scalar z1880 = z264 * z1861 + z1873;
    const Scalar z1869 = s_q7 * z1857 + c_q7 * z1858;
    const Scalar z1878 = z264 * z1860 - z1869;
    const Scalar z1863 = s_q7 * z1848 + c_q7 * z1849;
    const Scalar z1879 = z1875 + z265 * z1861 - n16_over_15 * z1863;
    const Scalar z1881 = k12 * z1838;
    const Scalar z1882 = k16 * z1839;
    const Scalar z1895 = z1881 + z1882 + z1880;
    const Scalar z1893 = z1879 + k11 * z1838 + k63 * z1839;
    const Scalar z1883 = k11 * z1840;
    const Scalar z1887 = z1876 - z1882 - z1883;
    const Scalar z1891 = z1881 - z1883 + z1859;
    const Scalar z1867 = c_q7 * z1856 + s_q7 * z1853;
    const Scalar z1894 = k62 * z1838 - z1867 + k11 * z1839;
    const Scalar z1899 = z1888 + z1890;
    const Scalar z1898 = z1887 + z1891;
    const Scalar z1892 = z1878 + k16 * z1840 + k63 * z1838;
    const Scalar z1910 = k25 * z1834;
    const Scalar z1904 = c_q6 * z1899 + s_q6 * z1898;
    const Scalar z1911 = k22 * z1835;
    const Scalar z1912 = k19 * z1836;
    const Scalar z1885 = k10 * z1840 + z1850;
    const Scalar z1884 = k13 * z1840 - z1862;
    const Scalar z1905 = s_q6 * z1904;
    const Scalar z1900 = s_q6 * z1892 + c_q6 * z1889;
    const Scalar z1917 = z1900 + k25 * z1835 - k64 * z1836;
    const Scalar z1902 = s_q6 * z1894 + c_q6 * z1893;
    const Scalar z1903 = s_q6 * z1893 - c_q6 * z1894;
    const Scalar z1906 = z1887 - z1905;
    const Scalar z1916 = z1911 + z1912 + z1906;
    const Scalar z1920 = z1910 - z1912 + z1895;
    const Scalar z1907 = z1891 - z1905;
    const Scalar z1924 = z1910 + z1911 + z1907;
    const Scalar z1908 = c_q6 * z1904 - z1890;
    const Scalar z1909 = c_q6 * z1904 - z1888;
    const Scalar z1918 = k65 * z1835 - z1908 + k25 * z1836;
    const Scalar z1922 = z1909 + k19 * z1834 - k65 * z1835;
    const Scalar z1886 = k13 * z1838 - z1863 + k10 * z1839;
    const Scalar z1901 = s_q6 * z1889 - c_q6 * z1892;
    const Scalar z1923 = k64 * z1834 - z1901 - k19 * z1835;
    const Scalar z1896 = s_q6 * z1885 - c_q6 * z1884;
    const Scalar z1913 = k20 * z1836 + z1896;
    const Scalar z1914 = k21 * z1836 - z1886;
    const Scalar z1919 = z1902 + k22 * z1834 + k65 * z1836;
    const Scalar z1921 = k65 * z1834 - z1903 - k22 * z1836;
    const Scalar z1929 = z1916 - z1920;
    const Scalar z1897 = c_q6 * z1885 + s_q6 * z1884;
    const Scalar z1915 = k20 * z1834 - z1897 + k21 * z1835;
    const Scalar z1930 = z1917 + z1919;
    const Scalar z1935 = s_q5 * z1929 - c_q5 * z1930;
    const Scalar z1926 = n256_over_55 * z1830 - z1831;
    const Scalar z1928 = c_q5 * z1914 + s_q5 * z1913;
    const Scalar z1925 = n256_over_55 * z1832;
    const Scalar z1931 = s_q5 * z1921 + c_q5 * z1918;
    const Scalar z1932 = s_q5 * z1918 - c_q5 * z1921;
    const Scalar z1948 = z309 * z1926 - z1932 + n256_over_55 * z1928;
    const Scalar z1927 = s_q5 * z1914 - c_q5 * z1913;
    const Scalar z1942 = z309 * z1925 - z1931 - n256_over_55 * z1927;
    const Scalar z1940 = c_q5 * z1935 + z1917;
    const Scalar z1947 = z351 * z1926 + z1928 - z1940;
    const Scalar z1957 = z1942 + k66 * z1832 + k28 * z1831;
    const Scalar z1962 = z1947 + k27 * z1830 - k67 * z1831;
    const Scalar z1955 = z1928 + k29 * z1830 - k30 * z1831;
    const Scalar z1963 = z1948 + k66 * z1830 - k27 * z1831;
    const Scalar z1936 = s_q5 * z1935;
    const Scalar z1939 = c_q5 * z1935 + z1919;
    const Scalar z1943 = z350 * z1925 - z1939;
    const Scalar z1933 = s_q5 * z1923 - c_q5 * z1922;
    const Scalar z1934 = c_q5 * z1923 + s_q5 * z1922;
    const Scalar z1946 = z350 * z1832 - z1934;
    const Scalar z1958 = k67 * z1831 - z1943 - k28 * z1832;
    const Scalar z1937 = z1916 - z1936;
    const Scalar z1941 = z351 * z1925 - z1927 - z1937;
    const Scalar z1938 = z1920 + z1936;
    const Scalar z1953 = k29 * z1832 - z1927;
    const Scalar z1949 = z350 * z1926 - z1938;
    const Scalar z1950 = k28 * z1830;
    const Scalar z1951 = k32 * z1831;
    const Scalar z1952 = k27 * z1832;
    const Scalar z1956 = z1952 + z1951 + z1941;
    const Scalar z1964 = z1950 - z1951 + z1949;
    const Scalar z1944 = z351 * z1832 + z1915 + z1933;
    const Scalar z1959 = z1944 + k67 * z1832 + k32 * z1830;
    const Scalar z1945 = z309 * z1832 - z1924 + n256_over_55 * z1915;
    const Scalar z1960 = z1952 + z1950 + z1945;
    const Scalar z1961 = k67 * z1830 - z1946 - k32 * z1832;
    const Scalar z1967 = z1956 + z1960;
    const Scalar z1954 = k30 * z1832 + z1915;
    const Scalar z1968 = z1957 - z1959;
    const Scalar z1971 = c_q4 * z1962 + s_q4 * z1963;
    const Scalar z1972 = s_q4 * z1962 - c_q4 * z1963;
    const Scalar z1973 = s_q4 * z1967 - c_q4 * z1968;
    const Scalar z1982 = z392 * z1828 - z1972;
    const Scalar z1969 = s_q4 * z1961 - c_q4 * z1958;
    const Scalar z1993 = z1969 + k37 * z1827 - k68 * z1828;
    const Scalar z1980 = z393 * z1828 + z1955 - z1971;
    const Scalar z1995 = z1980 + k40 * z1826 - k69 * z1828;
    const Scalar z1974 = s_q4 * z1973;
    const Scalar z1966 = c_q4 * z1954 + s_q4 * z1953;
    const Scalar z1970 = c_q4 * z1961 + s_q4 * z1958;
    const Scalar z1984 = z350 * z1827 - z1970;
    const Scalar z1977 = c_q4 * z1973 - z1959;
    const Scalar z1978 = c_q4 * z1973 + z1957;
    const Scalar z1983 = z393 * z1827 - z1966 + z1978;
    const Scalar z1994 = k37 * z1828 - z1977 + k69 * z1827;
    const Scalar z1999 = z1984 + k68 * z1826 - k35 * z1827;
    const Scalar z1998 = z1983 + k35 * z1826 - k69 * z1827;
    const Scalar z1991 = k36 * z1826 - z1966 - k38 * z1827;
    const Scalar z1965 = s_q4 * z1954 - c_q4 * z1953;
    const Scalar z1975 = z1956 - z1974;
    const Scalar z1979 = z1965 + z1975;
    const Scalar z1989 = k36 * z1828 - z1965;
    const Scalar z1976 = z1960 - z1974;
    const Scalar z1985 = z392 * z1827 - z1976;
    const Scalar z1986 = k37 * z1826;
    const Scalar z1987 = k40 * z1827;
    const Scalar z1988 = k35 * z1828;
    const Scalar z1992 = z1987 - z1988 + z1979;
    const Scalar z1981 = z350 * z1828 - z1964;
    const Scalar z1996 = z1986 - z1988 + z1981;
    const Scalar z2000 = z1986 - z1987 + z1985;
    const Scalar z2053 = k70 * z1820;
    const Scalar z1997 = k40 * z1828 - z1982 + k69 * z1826;
    const Scalar z2006 = z1993 - z1995;
    const Scalar z1990 = k38 * z1828 - z1955;
    const Scalar z2005 = z1992 + z1996;
    const Scalar z2001 = n632_over_165 * z1824;
    const Scalar z2011 = c_q3 * z2006 + s_q3 * z2005;
    const Scalar z2007 = s_q3 * z1997 + c_q3 * z1994;
    const Scalar z2002 = n632_over_165 * z1822;
    const Scalar z2008 = s_q3 * z1994 - c_q3 * z1997;
    const Scalar z2003 = s_q3 * z1990 + c_q3 * z1989;
    const Scalar z2018 = z2007 + z392 * z2001 + n632_over_165 * z2003;
    const Scalar z2012 = s_q3 * z2011;
    const Scalar z2009 = s_q3 * z1999 - c_q3 * z1998;
    const Scalar z2004 = s_q3 * z1989 - c_q3 * z1990;
    const Scalar z2022 = z2008 + z392 * z2002 + n632_over_165 * z2004;
    const Scalar z2031 = z2018 + k46 * z1823 - k71 * z1824;
    const Scalar z2037 = k71 * z1822 - z2022 - k44 * z1823;
    const Scalar z2099 = z56 * z1991 - z392 * z804 + z418 * z1825 + z805;
    const Scalar z2098 = z55 * z1991 + z392 * z803 - z419 * z1825 - z806;
    const Scalar z2091 = z55 * z1999 - z419 * z694 - z418 * z693 - z423 * z803 - z422 * z804 - z424 * z1825 - z56
        * z1998;
    const Scalar z2010 = c_q3 * z1999 + s_q3 * z1998;
    const Scalar z2020 = n632_over_165 * z1991 + z2000;
    const Scalar z2013 = z1992 - z2012;
    const Scalar z2014 = z1996 - z2012;
    const Scalar z2017 = z426 * z2001 - z2013;
    const Scalar z2023 = z425 * z2002 - z2014;
    const Scalar z2024 = k46 * z1822;
    const Scalar z2025 = k43 * z1823;
    const Scalar z2026 = k44 * z1824;
    const Scalar z2030 = z2026 - z2025 + z2017;
    const Scalar z2038 = z2024 - z2025 + z2023;
    const Scalar z2034 = z2026 - z2024 + z2020;
    const Scalar z2016 = c_q3 * z2011 - z1993;
    const Scalar z2021 = z426 * z2002 - z2016;
    const Scalar z2015 = c_q3 * z2011 + z1995;
    const Scalar z2019 = z425 * z2001 + z2015;
    const Scalar z2113 = z392 * z1826 - z1990;
    const Scalar z2036 = z2021 + k44 * z1822 - k72 * z1823;
    const Scalar z2114 = z392 * z1827 - z1989;
    const Scalar z2116 = z1994 + z421 * z1826 + z420 * z1827;
    const Scalar z2117 = z1997 + z421 * z1827 + z416 * z1826;
    const Scalar z2032 = z2019 + k46 * z1824 + k72 * z1823;
    const Scalar z2068 = z39 * z2037 - z40 * z2036 - z444 * z476 - z445 * z477 - z448 * z818 - z449 * z817 - z450
        * z1821;
    const Scalar z2046 = c_q2 * z2037 + s_q2 * z2036;
    const Scalar z2082 = z2032 + z447 * z1822 + z446 * z1823;
    const Scalar z2033 = k43 * z1822 - z2009 - k72 * z1824;
    const Scalar z2131 = z385 * z705 - z386 * z706 + z390 * z789 + z389 * z790 - z391 * z1829 - z79 * z1962 + z78
        * z1963;
    const Scalar z2035 = z2010 + k43 * z1824 + k72 * z1822;
    const Scalar z2133 = z393 * z1828 - z1971;
    const Scalar z2095 = z2010 + z424 * z1822 + z429 * z1823;
    const Scalar z2083 = z2035 + z424 * z1822 + z447 * z1823;
    const Scalar z2130 = z1956 - z1960;
    const Scalar z2129 = z1956 + z1964;
    const Scalar z2128 = z1960 - z1964;
    const Scalar z2134 = z392 * z1827 + z2130;
    const Scalar z2132 = z389 * z1831 - z2130 - z390 * z1830;
    const Scalar z2087 = s_q2 * z2082 - c_q2 * z2083;
    const Scalar z2066 = z2030 - z2038;
    const Scalar z2074 = z1812 + z425 * z477 + z424 * z817 - z447 * z818 + z449 * z1821 + z40 * z2033 + z39 * z2066;
    const Scalar z2042 = z2031 - z2033;
    const Scalar z2065 = z2034 + z2038;
    const Scalar z2073 = z1813 + z425 * z476 - z447 * z817 + z448 * z1821 + z446 * z818 + z39 * z2031 + z40 * z2065;
    const Scalar z2078 = c_q2 * z2074 + s_q2 * z2073;
    const Scalar z2060 = z2038 + z2053;
    const Scalar z2135 = z392 * z694 + z394 * z804 - z395 * z1825 - z396 * z803 + z55 * z2134 - z56 * z2133;
    const Scalar z2088 = z1996 - z2000;
    const Scalar z2101 = z1808 + z420 * z804 - z392 * z693 - z421 * z803 + z422 * z1825 + z55 * z1993 - z56 * z2088;
    const Scalar z2090 = z1992 - z1996;
    const Scalar z2089 = z1992 + z2000;
    const Scalar z2102 = z392 * z694 - z1807 + z421 * z804 - z423 * z1825 - z416 * z803 - z56 * z1995 + z55 * z2089;
    const Scalar z2092 = z422 * z1827 - z2090 - z423 * z1826;
    const Scalar z2093 = z2090 + z425 * z2002 - z426 * z2001;
    const Scalar z2094 = z429 * z818 - z425 * z477 - z424 * z817 - z430 * z1821 + z40 * z2009 + z39 * z2093;
    const Scalar z2097 = s_q2 * z2009 - c_q2 * z2093;
    const Scalar z2041 = z2030 + z2034;
    const Scalar z2136 = z394 * z1827 - z1982 + z396 * z1826;
    const Scalar z2047 = s_q2 * z2041 - c_q2 * z2042;
    const Scalar z2067 = z2030 - z2034;
    const Scalar z2069 = z2067 + z448 * z1823 - z449 * z1822;
    const Scalar z2138 = c_q3 * z2134 + s_q3 * z2133;
    const Scalar z2137 = s_q3 * z2134 - c_q3 * z2133;
    const Scalar z2139 = z393 * z2002 - z2137;
    const Scalar z2048 = s_q2 * z2047;
    const Scalar z2140 = z1982 + z397 * z2002 - z398 * z2001;
    const Scalar z2049 = z2030 - z2048;
    const Scalar z2142 = z393 * z476 - z397 * z477 + z395 * z817 + z401 * z818 - z402 * z1821 + z39 * z2140 + z40
        * z2139;
    const Scalar z2141 = z393 * z2001 - z2138;
    const Scalar z2056 = z2049 + z2053;
    const Scalar z2143 = z395 * z1822 - z2141 - z401 * z1823;
    const Scalar z2145 = s_q2 * z2139 - c_q2 * z2140;
    const Scalar z2064 = z2056 - z2060;
    const Scalar z2150 = z1802 + z383 * z789 - z350 * z706 - z388 * z790 - z390 * z1829 - z79 * z1959 + z78 * z2129;
    const Scalar z2149 = z388 * z789 - z1803 - z350 * z705 + z389 * z1829 - z387 * z790 + z78 * z1957 - z79 * z2128;
    const Scalar z2171 = z1961 + z383 * z1830 + z388 * z1831;
    const Scalar z2170 = z1958 + z388 * z1830 + z387 * z1831;
    const Scalar z2146 = z78 * z1955 + z350 * z789 - z386 * z1829 - z792;
    const Scalar z2147 = z79 * z1955 - z350 * z790 + z385 * z1829 + z791;
    const Scalar z2167 = z350 * z1830 - z1954;
    const Scalar z2148 = z385 * z789 - z386 * z790 - z79 * z1954 + z78 * z1953;
    const Scalar z2169 = z386 * z1831 + z385 * z1830;
    const Scalar z2168 = z350 * z1831 - z1953;
    const Scalar z2152 = s_q4 * z2146 - c_q4 * z2147;
    const Scalar z2151 = c_q4 * z2146 + s_q4 * z2147;
    const Scalar z2155 = z2131 - z2152;
    const Scalar z2173 = s_q4 * z2167 - c_q4 * z2168;
    const Scalar z2172 = c_q4 * z2167 + s_q4 * z2168;
    const Scalar z2153 = s_q4 * z2150 - c_q4 * z2149;
    const Scalar z2154 = s_q4 * z2149 + c_q4 * z2150;
    const Scalar z2156 = z2148 - z2154;
    const Scalar z2103 = s_q3 * z2099 - c_q3 * z2098;
    const Scalar z2104 = s_q3 * z2098 + c_q3 * z2099;
    const Scalar z2175 = c_q4 * z2171 + s_q4 * z2170;
    const Scalar z2174 = s_q4 * z2171 - c_q4 * z2170;
    const Scalar z2106 = s_q3 * z2101 - c_q3 * z2102;
    const Scalar z2105 = s_q3 * z2102 + c_q3 * z2101;
    const Scalar z2108 = n632_over_165 * z2103 + z2106;
    const Scalar z2107 = n632_over_165 * z2104 + z2105;
    const Scalar z2176 = z2132 + z2173;
    const Scalar z2177 = z2169 - z2175;
    const Scalar z2118 = s_q3 * z2114 - c_q3 * z2113;
    const Scalar z2119 = s_q3 * z2113 + c_q3 * z2114;
    const Scalar z2112 = s_q2 * z2107 - c_q2 * z2091;
    const Scalar z2188 = z1920 - z1924;
    const Scalar z2189 = z1916 - z1924;
    const Scalar z2120 = s_q3 * z2117 + c_q3 * z2116;
    const Scalar z2190 = z1916 + z1920;
    const Scalar z2121 = s_q3 * z2116 - c_q3 * z2117;
    const Scalar z2191 = z347 * z778 - z348 * z777 - z349 * z1833 + z343 * z719 + z344 * z720 + z102 * z1923 - z103
        * z1922;
    const Scalar z2122 = n632_over_165 * z2119 - z2120;
    const Scalar z2123 = n632_over_165 * z2118 - z2121;
    const Scalar z2193 = z351 * z1832 + z1933;
    const Scalar z2127 = s_q2 * z2122 - c_q2 * z2092;
    const Scalar z2216 = z345 * z778 - z347 * z1833 - z346 * z777 - z309 * z719 + z102 * z1917 + z1798 - z103 * z2188;
    const Scalar z2217 = z348 * z1833 + z308 * z777 - z346 * z778 + z309 * z720 + z1797 - z103 * z1919 + z102 * z2189;
    const Scalar z2192 = z348 * z1834 - z2190 + z347 * z1835;
    const Scalar z2194 = z351 * z1925 - z2190 + z350 * z1926;
    const Scalar z2195 = z355 * z789 - z350 * z706 - z354 * z790 - z356 * z1829 + z78 * z2194 - z79 * z2193;
    const Scalar z2196 = z355 * z1830 - z1946 + z354 * z1831;
    const Scalar z2214 = z103 * z1915 - z309 * z778 - z343 * z1833 - z779;
    const Scalar z2213 = z102 * z1915 + z309 * z777 - z344 * z1833 - z780;
    const Scalar z2200 = z357 * z1827 + z1946;
    const Scalar z2197 = s_q4 * z2194 + c_q4 * z2193;
    const Scalar z2198 = s_q4 * z2193 - c_q4 * z2194;
    const Scalar z2201 = z357 * z1828 + z2198;
    const Scalar z2199 = z2197 + z351 * z1827 - z358 * z1828;
    const Scalar z2215 = z103 * z1914 - z343 * z777 - z344 * z778 + z102 * z1913;
    const Scalar z2202 = z351 * z693 + z357 * z694 - z359 * z804 + z361 * z803 + z362 * z1825 + z55 * z2200 - z56
        * z2199;
    const Scalar z2203 = z2201 + z359 * z1827 + z361 * z1826;
    const Scalar z2207 = z2201 + z363 * z2002 - z364 * z2001;
    const Scalar z2218 = s_q5 * z2214 - c_q5 * z2213;
    const Scalar z2219 = s_q5 * z2213 + c_q5 * z2214;
    const Scalar z2205 = c_q3 * z2200 + s_q3 * z2199;
    const Scalar z2204 = s_q3 * z2200 - c_q3 * z2199;
    const Scalar z2208 = z358 * z2001 + z2205;
    const Scalar z2206 = z358 * z2002 + z2204;
    const Scalar z2221 = s_q5 * z2216 + c_q5 * z2217;
    const Scalar z2220 = s_q5 * z2217 - c_q5 * z2216;
    const Scalar z2209 = z367 * z818 - z358 * z476 - z363 * z477 - z362 * z817 - z368 * z1821 + z39 * z2207 - z40
        * z2206;
    const Scalar z2210 = z362 * z1822 - z2208 + z367 * z1823;
    const Scalar z2212 = c_q2 * z2207 + s_q2 * z2206;
    const Scalar z2222 = n256_over_55 * z2219 + z2220;
    const Scalar z2223 = z2191 + z2219;
    const Scalar z2157 = s_q3 * z2148 + c_q3 * z2151;
    const Scalar z2158 = s_q3 * z2151 - c_q3 * z2148;
    const Scalar z2224 = z2215 + n256_over_55 * z2218 - z2221;
    const Scalar z2225 = s_q4 * z2215 - c_q4 * z2218;
    const Scalar z2159 = s_q3 * z2155 + c_q3 * z2153;
    const Scalar z2226 = c_q4 * z2215 + s_q4 * z2218;
    const Scalar z2160 = s_q3 * z2153 - c_q3 * z2155;
    const Scalar z2161 = n632_over_165 * z2158 + z2159;
    const Scalar z2162 = n632_over_165 * z2157 - z2160;
    const Scalar z2229 = z2224 - z2226;
    const Scalar z2166 = s_q2 * z2161 - c_q2 * z2156;
    const Scalar z2244 = z1918 + z346 * z1834 + z345 * z1835;
    const Scalar z2243 = z343 * z1834 - z344 * z1835;
    const Scalar z2242 = z309 * z1835 - z1913;
    const Scalar z2241 = z309 * z1834 + z1914;
    const Scalar z2227 = s_q4 * z2223 - c_q4 * z2222;
    const Scalar z2228 = c_q4 * z2223 + s_q4 * z2222;
    const Scalar z2230 = z2219 - z2228;
    const Scalar z2232 = c_q3 * z2219 + s_q3 * z2225;
    const Scalar z2231 = s_q3 * z2219 - c_q3 * z2225;
    const Scalar z2233 = s_q3 * z2229 + c_q3 * z2227;
    const Scalar z2235 = n632_over_165 * z2232 - z2233;
    const Scalar z2234 = s_q3 * z2227 - c_q3 * z2229;
    const Scalar z2236 = n632_over_165 * z2231 - z2234;
    const Scalar z2178 = s_q3 * z2169 + c_q3 * z2172;
    const Scalar z2245 = z1921 + z308 * z1834 + z346 * z1835;
    const Scalar z2179 = s_q3 * z2172 - c_q3 * z2169;
    const Scalar z2240 = c_q2 * z2230 + s_q2 * z2235;
    const Scalar z2246 = s_q5 * z2242 - c_q5 * z2241;
    const Scalar z2180 = s_q3 * z2176 - c_q3 * z2174;
    const Scalar z2247 = s_q5 * z2241 + c_q5 * z2242;
    const Scalar z2181 = c_q3 * z2176 + s_q3 * z2174;
    const Scalar z2182 = n632_over_165 * z2179 - z2180;
    const Scalar z2183 = n632_over_165 * z2178 - z2181;
    const Scalar z2187 = s_q2 * z2182 - c_q2 * z2177;
    const Scalar z2272 = z303 * z726 - z308 * z1837 - k13 * z727 - z306 * z762 + z307 * z761 + z117 * z1894 + z118
        * z1893;
    const Scalar z2300 = z118 * z1886 - z264 * z762 - z303 * z1837 - z763;
    const Scalar z2299 = z264 * z761 - k13 * z1837 + z117 * z1886 - z764;
    const Scalar z2271 = z1887 - z1891;
    const Scalar z2274 = z312 * z1833 + z308 * z777 + z311 * z778 + z309 * z720 + z102 * z2271 - z103 * z1902;
    const Scalar z2275 = z308 * z1834 - z1903 - z311 * z1835;
    const Scalar z2279 = z313 * z1926 - z1903 - z314 * z1925;
    const Scalar z2269 = z1891 - z1895;
    const Scalar z2302 = z264 * z726 - z306 * z1837 + z304 * z762 - z305 * z761 + z117 * z1888 - z118 * z2269 - z1793;
    const Scalar z2270 = z1887 + z1895;
    const Scalar z2303 = z301 * z761 - z307 * z1837 - z264 * z727 + z305 * z762 + z118 * z1890 + z117 * z2270 + z1792;
    const Scalar z2273 = z2271 + z306 * z1839 + z307 * z1838;
    const Scalar z2276 = s_q5 * z2271 - c_q5 * z1902;
    const Scalar z2277 = c_q5 * z2271 + s_q5 * z1902;
    const Scalar z2278 = z2276 + z314 * z1832 + z310 * z1926;
    const Scalar z2280 = z2277 + z310 * z1925 + z313 * z1832;
    const Scalar z2301 = z118 * z1885 - z303 * z761 - k13 * z762 + z117 * z1884;
    const Scalar z2281 = z318 * z789 - z310 * z705 - z313 * z706 + z319 * z1829 + z317 * z790 + z78 * z2279 + z79
        * z2278;
    const Scalar z2282 = z2280 + z317 * z1831 - z318 * z1830;
    const Scalar z2286 = z320 * z1827 + z2280;
    const Scalar z2283 = s_q4 * z2279 - c_q4 * z2278;
    const Scalar z2284 = c_q4 * z2279 + s_q4 * z2278;
    const Scalar z2285 = z314 * z1827 - z2283 + z321 * z1828;
    const Scalar z2287 = z320 * z1828 - z2284;
    const Scalar z2304 = s_q6 * z2300 - c_q6 * z2299;
    const Scalar z2305 = c_q6 * z2300 + s_q6 * z2299;
    const Scalar z2293 = z326 * z2002 - z2287 + z327 * z2001;
    const Scalar z2288 = z320 * z694 - z314 * z693 - z324 * z803 - z322 * z804 - z325 * z1825 + z55 * z2286 + z56
        * z2285;
    const Scalar z2289 = z2287 + z322 * z1827 - z324 * z1826;
    const Scalar z2306 = c_q6 * z2302 + s_q6 * z2303;
    const Scalar z2307 = s_q6 * z2302 - c_q6 * z2303;
    const Scalar z2308 = s_q5 * z2301 - c_q5 * z2304;
    const Scalar z2309 = c_q5 * z2301 + s_q5 * z2304;
    const Scalar z2290 = s_q3 * z2286 + c_q3 * z2285;
    const Scalar z2291 = s_q3 * z2285 - c_q3 * z2286;
    const Scalar z2292 = z321 * z2002 + z2290;
    const Scalar z2294 = z321 * z2001 - z2291;
    const Scalar z2310 = s_q5 * z2272 - c_q5 * z2306;
    const Scalar z2295 = z321 * z476 - z326 * z477 - z325 * z817 - z330 * z818 - z331 * z1821 + z39 * z2293 + z40
        * z2292;
    const Scalar z2296 = z2294 + z325 * z1822 - z330 * z1823;
    const Scalar z2298 = s_q2 * z2292 - c_q2 * z2293;
    const Scalar z2311 = c_q5 * z2272 + s_q5 * z2306;
    const Scalar z2248 = s_q5 * z2245 + c_q5 * z2244;
    const Scalar z2249 = s_q5 * z2244 - c_q5 * z2245;
    const Scalar z2312 = n256_over_55 * z2309 + z2310;
    const Scalar z2250 = n256_over_55 * z2247 + z2248;
    const Scalar z2314 = z2305 + n256_over_55 * z2308 - z2311;
    const Scalar z2252 = z2243 - n256_over_55 * z2246 - z2249;
    const Scalar z2313 = z2307 - z2309;
    const Scalar z2251 = z2192 - z2247;
    const Scalar z2316 = c_q4 * z2305 + s_q4 * z2308;
    const Scalar z2315 = s_q4 * z2305 - c_q4 * z2308;
    const Scalar z2254 = s_q4 * z2246 - c_q4 * z2243;
    const Scalar z2253 = s_q4 * z2243 + c_q4 * z2246;
    const Scalar z2257 = z2252 + z2254;
    const Scalar z2317 = s_q4 * z2313 + c_q4 * z2312;
    const Scalar z2318 = s_q4 * z2312 - c_q4 * z2313;
    const Scalar z2255 = s_q4 * z2251 + c_q4 * z2250;
    const Scalar z2256 = s_q4 * z2250 - c_q4 * z2251;
    const Scalar z2319 = z2314 - z2316;
    const Scalar z2320 = z2309 - z2318;
    const Scalar z2258 = z2247 - z2256;
    const Scalar z2322 = c_q3 * z2309 + s_q3 * z2315;
    const Scalar z2321 = s_q3 * z2309 - c_q3 * z2315;
    const Scalar z2260 = s_q3 * z2253 - c_q3 * z2247;
    const Scalar z2259 = s_q3 * z2247 + c_q3 * z2253;
    const Scalar z2323 = s_q3 * z2319 - c_q3 * z2317;
    const Scalar z2324 = c_q3 * z2319 + s_q3 * z2317;
    const Scalar z2261 = s_q3 * z2257 + c_q3 * z2255;
    const Scalar z2325 = n632_over_165 * z2322 - z2323;
    const Scalar z2262 = s_q3 * z2255 - c_q3 * z2257;
    const Scalar z2326 = n632_over_165 * z2321 + z2324;
    const Scalar z2263 = n632_over_165 * z2260 - z2261;
    const Scalar z2264 = n632_over_165 * z2259 + z2262;
    const Scalar z2331 = z264 * z1838 + z1885;
    const Scalar z2330 = c_q2 * z2320 + s_q2 * z2325;
    const Scalar z2268 = s_q2 * z2263 - c_q2 * z2258;
    const Scalar z2366 = z137 * z1858 - k6 * z1841 + z138 * z1857 + k4 * z747 + k2 * z739 - k3 * z738 - k5 * z748;
    const Scalar z2368 = z265 * z1860 + z1868;
    const Scalar z2335 = z1892 + z301 * z1838 - z305 * z1839;
    const Scalar z2334 = z304 * z1839 - z1889 + z305 * z1838;
    const Scalar z2332 = z264 * z1839 - z1884;
    const Scalar z2333 = z303 * z1838 - k13 * z1839;
    const Scalar z2371 = z1878 + z266 * z1839 + z268 * z1838;
    const Scalar z2399 = z137 * z1850 - z750 - k2 * z1841;
    const Scalar z2365 = z1851 + z1855;
    const Scalar z2363 = z1855 - z1859;
    const Scalar z2364 = z1851 - z1859;
    const Scalar z2369 = z264 * z1861 + z2365;
    const Scalar z2367 = k4 * z1842 - z2365 + k5 * z1843;
    const Scalar z2370 = z268 * z761 - z267 * z1837 - z264 * z727 - z266 * z762 + z117 * z2369 - z118 * z2368;
    const Scalar z2372 = s_q6 * z2369 - c_q6 * z2368;
    const Scalar z2374 = z272 * z1833 + z267 * z777 + z271 * z778 - z265 * z719 - z269 * z720 + z102 * z1878 - z103
        * z2372;
    const Scalar z2373 = c_q6 * z2369 + s_q6 * z2368;
    const Scalar z2375 = z2373 + z267 * z1834 - z271 * z1835;
    const Scalar z2379 = z2373 + z274 * z1925 + z273 * z1926;
    const Scalar z2376 = s_q5 * z1878 - c_q5 * z2372;
    const Scalar z2377 = c_q5 * z1878 + s_q5 * z2372;
    const Scalar z2378 = z2376 + z270 * z1926 - z274 * z1832;
    const Scalar z2380 = z2377 + z273 * z1832 + z270 * z1925;
    const Scalar z2336 = s_q6 * z2332 - c_q6 * z2331;
    const Scalar z2400 = z138 * z1850 + z749 + k3 * z1841;
    const Scalar z2381 = z279 * z1829 + z278 * z789 - z270 * z705 - z273 * z706 - z277 * z790 + z78 * z2379 + z79
        * z2378;
    const Scalar z2382 = z278 * z1830 - z2380 + z277 * z1831;
    const Scalar z2337 = s_q6 * z2331 + c_q6 * z2332;
    const Scalar z2401 = z137 * z1848 - z138 * z1849 + k3 * z747 - k2 * z748;
    const Scalar z2386 = z280 * z1827 + z2380;
    const Scalar z2383 = s_q4 * z2379 - c_q4 * z2378;
    const Scalar z2384 = c_q4 * z2379 + s_q4 * z2378;
    const Scalar z2387 = z280 * z1828 - z2384;
    const Scalar z2385 = z2383 + z274 * z1827 - z281 * z1828;
    const Scalar z2338 = s_q6 * z2335 - c_q6 * z2334;
    const Scalar z2402 = z137 * z1852 - k5 * z1841 - z138 * z2363 - k8 * z747 - k0 * z748 - z1789;
    const Scalar z2388 = z274 * z693 + z280 * z694 - z284 * z803 - z282 * z804 + z285 * z1825 + z55 * z2386 - z56
        * z2385;
    const Scalar z2389 = z2387 + z282 * z1827 - z284 * z1826;
    const Scalar z2339 = c_q6 * z2335 + s_q6 * z2334;
    const Scalar z2403 = k4 * z1841 - z138 * z1854 + z137 * z2364 - k8 * z748 - z1788;
    const Scalar z2393 = z2387 + z286 * z2002 - z287 * z2001;
    const Scalar z2340 = s_q5 * z2333 + c_q5 * z2336;
    const Scalar z2341 = s_q5 * z2336 - c_q5 * z2333;
    const Scalar z2405 = s_q7 * z2399 - c_q7 * z2400;
    const Scalar z2404 = s_q7 * z2400 + c_q7 * z2399;
    const Scalar z2343 = s_q5 * z2338 + c_q5 * z2273;
    const Scalar z2342 = s_q5 * z2273 - c_q5 * z2338;
    const Scalar z2346 = z2337 - n256_over_55 * z2340 - z2343;
    const Scalar z2344 = n256_over_55 * z2341 + z2342;
    const Scalar z2407 = s_q7 * z2402 - c_q7 * z2403;
    const Scalar z2406 = c_q7 * z2402 + s_q7 * z2403;
    const Scalar z2408 = z2366 + n16_over_15 * z2405;
    const Scalar z2391 = c_q3 * z2386 + s_q3 * z2385;
    const Scalar z2390 = s_q3 * z2386 - c_q3 * z2385;
    const Scalar z2394 = z281 * z2001 + z2391;
    const Scalar z2392 = z281 * z2002 + z2390;
    const Scalar z2345 = z2339 + z2341;
    const Scalar z2396 = z285 * z1822 - z2394 + z290 * z1823;
    const Scalar z2395 = z290 * z818 - z281 * z476 - z286 * z477 - z285 * z817 - z291 * z1821 + z39 * z2393 - z40
        * z2392;
    const Scalar z2398 = c_q2 * z2393 + s_q2 * z2392;
    const Scalar z2409 = n16_over_15 * z2401 + z2407;
    const Scalar z2410 = s_q6 * z2401 + c_q6 * z2404;
    const Scalar z2348 = s_q4 * z2340 - c_q4 * z2337;
    const Scalar z2347 = s_q4 * z2337 + c_q4 * z2340;
    const Scalar z2411 = s_q6 * z2404 - c_q6 * z2401;
    const Scalar z2351 = z2346 + z2348;
    const Scalar z2412 = s_q6 * z2408 - c_q6 * z2406;
    const Scalar z2349 = s_q4 * z2345 - c_q4 * z2344;
    const Scalar z2413 = s_q6 * z2406 + c_q6 * z2408;
    const Scalar z2350 = c_q4 * z2345 + s_q4 * z2344;
    const Scalar z2352 = z2341 - z2350;
    const Scalar z2414 = s_q5 * z2405 + c_q5 * z2410;
    const Scalar z2415 = s_q5 * z2410 - c_q5 * z2405;
    const Scalar z2416 = s_q5 * z2409 - c_q5 * z2412;
    const Scalar z2354 = c_q3 * z2341 + s_q3 * z2347;
    const Scalar z2353 = s_q3 * z2341 - c_q3 * z2347;
    const Scalar z2417 = c_q5 * z2409 + s_q5 * z2412;
    const Scalar z2418 = n256_over_55 * z2415 + z2416;
    const Scalar z2355 = s_q3 * z2351 + c_q3 * z2349;
    const Scalar z2356 = s_q3 * z2349 - c_q3 * z2351;
    const Scalar z2357 = n632_over_165 * z2354 - z2355;
    const Scalar z2358 = n632_over_165 * z2353 - z2356;
    const Scalar z2420 = z2411 + n256_over_55 * z2414 + z2417;
    const Scalar z2362 = c_q2 * z2352 + s_q2 * z2357;
    const Scalar z2471 = u_tau1 - z1819;
    const Scalar z2472 = u_tau2 - z1814;
    const Scalar z2473 = u_tau3 + z1809;
    const Scalar z2474 = u_tau4 - z1804;
    const Scalar z2475 = u_tau5 + z1799;
    const Scalar z2476 = u_tau6 - z1794;
    const Scalar z2477 = u_tau7 - z754;
    const Scalar z2439 = k8 * z1843 - z1856;
    const Scalar z2438 = k8 * z1842 - z1853 - k0 * z1843;
    const Scalar z2437 = k3 * z1842 + k2 * z1843;
    const Scalar z2478 = z1387 * z2398 - z2298;
    const Scalar z2479 = z1386 * z2398 - z2212 - z1414 * z2478;
    const Scalar z2440 = s_q7 * z2439 - c_q7 * z2438;
    const Scalar z2441 = c_q7 * z2439 + s_q7 * z2438;
    const Scalar z2443 = n16_over_15 * z2437 - z2441;
    const Scalar z2480 = z1385 * z2398 - z1413 * z2478 - z1434 * z2479 + z2145;
    const Scalar z2442 = n16_over_15 * z1862 - z2367;
    const Scalar z2444 = s_q6 * z2437 - c_q6 * z1863;
    const Scalar z2445 = c_q6 * z2437 + s_q6 * z1863;
    const Scalar z2481 = z1384 * z2398 - z1412 * z2478 - z1433 * z2479 - z1448 * z2480 + z2097;
    const Scalar z2446 = c_q6 * z2440 + s_q6 * z2442;
    const Scalar z2447 = s_q6 * z2440 - c_q6 * z2442;
    const Scalar z2482 = z1383 * z2398 - z1411 * z2478 - z1432 * z2479 - z1447 * z2480 - z1457 * z2481 - z2046;
    const Scalar z2483 = z1382 * z2398 - z1410 * z2478 - z1431 * z2479 - z1446 * z2480 - z1456 * z2481 - z1462 * z2482
        - z2064;
    const Scalar z2449 = c_q5 * z1862 + s_q5 * z2444;
    const Scalar z2448 = s_q5 * z1862 - c_q5 * z2444;
    const Scalar z2484 = z1464 * z2483;
    const Scalar z2450 = s_q5 * z2443 + c_q5 * z2446;
    const Scalar z2452 = n256_over_55 * z2449 + z2450;
    const Scalar z2451 = s_q5 * z2446 - c_q5 * z2443;
    const Scalar z2454 = z2445 + n256_over_55 * z2448 + z2451;
    const Scalar z2419 = z2413 + z2415;
    const Scalar z2485 = z1461 * z2482 - z1462 * z2484;
    const Scalar z2486 = z1455 * z2481 - z1456 * z2484 - z1457 * z2485;
    const Scalar z2453 = z2447 + z2449;
    const Scalar z2422 = c_q4 * z2411 + s_q4 * z2414;
    const Scalar z2421 = s_q4 * z2411 - c_q4 * z2414;
    const Scalar z2425 = z2420 - z2422;
    const Scalar z2487 = z1445 * z2480 - z1446 * z2484 - z1447 * z2485 - z1448 * z2486;
    const Scalar z2488 = z1430 * z2479 - z1431 * z2484 - z1432 * z2485 - z1433 * z2486 - z1434 * z2487;
    const Scalar z2423 = s_q4 * z2419 - c_q4 * z2418;
    const Scalar z2424 = c_q4 * z2419 + s_q4 * z2418;
    const Scalar z2491 = z1387 * z2395 + z2295;
    const Scalar z2426 = z2415 - z2424;
    const Scalar z2492 = z1386 * z2395 - z2209 - z1414 * z2491;
    const Scalar z2489 = z1409 * z2478 - z1410 * z2484 - z1411 * z2485 - z1412 * z2486 - z1413 * z2487 - z1414 * z2488;
    const Scalar z2490 = z1382 * z2484 - k52 * z2398 + z1383 * z2485 + z1384 * z2486 + z1385 * z2487 + z1386 * z2488
        + z1387 * z2489;
    const Scalar z2456 = c_q4 * z2445 + s_q4 * z2448;
    const Scalar z2455 = s_q4 * z2445 - c_q4 * z2448;
    const Scalar z2459 = z2454 - z2456;
    const Scalar z2457 = s_q4 * z2453 - c_q4 * z2452;
    const Scalar z2458 = c_q4 * z2453 + s_q4 * z2452;
    const Scalar z2460 = z2449 - z2458;
    const Scalar z2428 = s_q3 * z2421 - c_q3 * z2415;
    const Scalar z2427 = s_q3 * z2415 + c_q3 * z2421;
    const Scalar z2493 = z1385 * z2395 - z1413 * z2491 - z1434 * z2492 - z2142;
    const Scalar z2494 = z1384 * z2395 - z1412 * z2491 - z1433 * z2492 - z1448 * z2493 - z2094;
    const Scalar z2429 = s_q3 * z2425 - c_q3 * z2423;
    const Scalar z2431 = n632_over_165 * z2428 - z2429;
    const Scalar z2430 = c_q3 * z2425 + s_q3 * z2423;
    const Scalar z2432 = n632_over_165 * z2427 - z2430;
    const Scalar z2495 = z1383 * z2395 - z1411 * z2491 - z1432 * z2492 - z1447 * z2493 - z1457 * z2494 - z2068;
    const Scalar z2436 = s_q2 * z2431 - c_q2 * z2426;
    const Scalar z2504 = z1387 * z2396 + z2296;
    const Scalar z2517 = z1387 * z2388 - z2288;
    const Scalar z2505 = z1386 * z2396 - z2210 - z1414 * z2504;
    const Scalar z2518 = z1386 * z2388 - z2202 - z1414 * z2517;
    const Scalar z2506 = z2143 + z1385 * z2396 - z1413 * z2504 - z1434 * z2505;
    const Scalar z2519 = z1385 * z2388 - z2135 - z1413 * z2517 - z1434 * z2518;
    const Scalar z2507 = z1384 * z2396 - z1412 * z2504 - z1433 * z2505 - z2095 - z1448 * z2506;
    const Scalar z2520 = z1384 * z2388 - z1412 * z2517 - z1433 * z2518 - z1448 * z2519 + z2091;
    const Scalar z2508 = z1383 * z2396 - z1411 * z2504 - z1432 * z2505 - z1447 * z2506 - z1457 * z2507 + z2069;
    const Scalar z2521 = z1383 * z2388 - z1411 * z2517 - z1432 * z2518 - z1447 * z2519 - z2108 - z1457 * z2520;
    const Scalar z2496 = z1382 * z2395 - z2078 - z1410 * z2491 - z1431 * z2492 - z1446 * z2493 - z1456 * z2494 - z1462
        * z2495;
    const Scalar z2509 = z1382 * z2396 - z1410 * z2504 - z1431 * z2505 - z1446 * z2506 - z1456 * z2507 - z1462 * z2508
        - z2087;
    const Scalar z2522 = z1382 * z2388 - z1410 * z2517 - z1431 * z2518 - z1446 * z2519 - z1456 * z2520 - z1462 * z2521
        + z2112;
    const Scalar z2497 = z1464 * z2496;
    const Scalar z2510 = z1464 * z2509;
    const Scalar z2523 = z1464 * z2522;
    const Scalar z2498 = z1461 * z2495 - z1462 * z2497;
    const Scalar z2511 = z1461 * z2508 - z1462 * z2510;
    const Scalar z2499 = z1455 * z2494 - z1456 * z2497 - z1457 * z2498;
    const Scalar z2512 = z1455 * z2507 - z1456 * z2510 - z1457 * z2511;
    const Scalar z2500 = z1445 * z2493 - z1446 * z2497 - z1447 * z2498 - z1448 * z2499;
    const Scalar z2513 = z1445 * z2506 - z1446 * z2510 - z1447 * z2511 - z1448 * z2512;
    const Scalar z2501 = z1430 * z2492 - z1431 * z2497 - z1432 * z2498 - z1433 * z2499 - z1434 * z2500;
    const Scalar z2514 = z1430 * z2505 - z1431 * z2510 - z1432 * z2511 - z1433 * z2512 - z1434 * z2513;
    const Scalar z2502 = z1409 * z2491 - z1410 * z2497 - z1411 * z2498 - z1412 * z2499 - z1413 * z2500 - z1414 * z2501;
    const Scalar z2503 = z1382 * z2497 - k52 * z2395 + z1383 * z2498 + z1384 * z2499 + z1385 * z2500 + z1386 * z2501
        + z1387 * z2502;
    const Scalar z2515 = z1409 * z2504 - z1410 * z2510 - z1411 * z2511 - z1412 * z2512 - z1413 * z2513 - z1414 * z2514;
    const Scalar z2516 = z1382 * z2510 - k52 * z2396 + z1383 * z2511 + z1384 * z2512 + z1385 * z2513 + z1386 * z2514
        + z1387 * z2515;
    const Scalar z2462 = c_q3 * z2449 + s_q3 * z2455;
    const Scalar z2461 = s_q3 * z2449 - c_q3 * z2455;
    const Scalar z2524 = z1461 * z2521 - z1462 * z2523;
    const Scalar z2525 = z1455 * z2520 - z1456 * z2523 - z1457 * z2524;
    const Scalar z2463 = c_q3 * z2457 + s_q3 * z2459;
    const Scalar z2464 = s_q3 * z2457 - c_q3 * z2459;
    const Scalar z2465 = n632_over_165 * z2462 - z2463;
    const Scalar z2466 = n632_over_165 * z2461 - z2464;
    const Scalar z2526 = z1445 * z2519 - z1446 * z2523 - z1447 * z2524 - z1448 * z2525;
    const Scalar z2470 = c_q2 * z2460 + s_q2 * z2465;
    const Scalar z2530 = z1387 * z2389 - z2289;
    const Scalar z2543 = z1387 * z2381 - z2281;
    const Scalar z2556 = z1387 * z2382 + z2282;
    const Scalar z2531 = z1386 * z2389 - z2203 - z1414 * z2530;
    const Scalar z2544 = z1386 * z2381 - z2195 - z1414 * z2543;
    const Scalar z2557 = z1386 * z2382 - z2196 - z1414 * z2556;
    const Scalar z2569 = z1387 * z2374 - z2274;
    const Scalar z2582 = z1387 * z2375 - z2275;
    const Scalar z2570 = z2191 + z1386 * z2374 - z1414 * z2569;
    const Scalar z2583 = z1386 * z2375 - z2192 - z1414 * z2582;
    const Scalar z2532 = z1385 * z2389 - z1413 * z2530 - z1434 * z2531 + z2136;
    const Scalar z2545 = z1385 * z2381 - z1413 * z2543 - z1434 * z2544 + z2131;
    const Scalar z2558 = z1385 * z2382 - z1413 * z2556 - z1434 * z2557 - z2132;
    const Scalar z2571 = z1385 * z2374 - z2224 - z1413 * z2569 - z1434 * z2570;
    const Scalar z2584 = z2252 + z1385 * z2375 - z1413 * z2582 - z1434 * z2583;
    const Scalar z2533 = z1384 * z2389 - z1412 * z2530 - z1433 * z2531 - z1448 * z2532 + z2092;
    const Scalar z2546 = z1384 * z2381 - z1412 * z2543 - z1433 * z2544 - z1448 * z2545 - z2156;
    const Scalar z2559 = z1384 * z2382 - z1412 * z2556 - z1433 * z2557 - z1448 * z2558 - z2177;
    const Scalar z2572 = z1384 * z2374 - z1412 * z2569 - z1433 * z2570 + z2230 - z1448 * z2571;
    const Scalar z2585 = z1384 * z2375 - z1412 * z2582 - z1433 * z2583 + z2258 - z1448 * z2584;
    const Scalar z2534 = z1383 * z2389 - z1411 * z2530 - z1432 * z2531 - z1447 * z2532 - z1457 * z2533 - z2123;
    const Scalar z2547 = z1383 * z2381 - z1411 * z2543 - z1432 * z2544 - z1447 * z2545 - z1457 * z2546 - z2162;
    const Scalar z2560 = z1383 * z2382 - z1411 * z2556 - z1432 * z2557 - z1447 * z2558 - z1457 * z2559 - z2183;
    const Scalar z2573 = z1383 * z2374 - z1411 * z2569 - z1432 * z2570 - z1447 * z2571 - z1457 * z2572 + z2236;
    const Scalar z2586 = z1383 * z2375 - z1411 * z2582 - z1432 * z2583 - z1447 * z2584 + z2264 - z1457 * z2585;
    const Scalar z2535 = z1382 * z2389 - z1410 * z2530 - z1431 * z2531 - z1446 * z2532 - z1456 * z2533 - z1462 * z2534
        + z2127;
    const Scalar z2548 = z1382 * z2381 - z1410 * z2543 - z1431 * z2544 - z1446 * z2545 - z1456 * z2546 - z1462 * z2547
        - z2166;
    const Scalar z2561 = z1382 * z2382 - z1410 * z2556 - z1431 * z2557 - z1446 * z2558 - z1456 * z2559 - z1462 * z2560
        - z2187;
    const Scalar z2574 = z1382 * z2374 - z2240 - z1410 * z2569 - z1431 * z2570 - z1446 * z2571 - z1456 * z2572 - z1462
        * z2573;
    const Scalar z2536 = z1464 * z2535;
    const Scalar z2549 = z1464 * z2548;
    const Scalar z2562 = z1464 * z2561;
    const Scalar z2575 = z1464 * z2574;
    const Scalar z2537 = z1461 * z2534 - z1462 * z2536;
    const Scalar z2550 = z1461 * z2547 - z1462 * z2549;
    const Scalar z2563 = z1461 * z2560 - z1462 * z2562;
    const Scalar z2576 = z1461 * z2573 - z1462 * z2575;
    const Scalar z2538 = z1455 * z2533 - z1456 * z2536 - z1457 * z2537;
    const Scalar z2551 = z1455 * z2546 - z1456 * z2549 - z1457 * z2550;
    const Scalar z2564 = z1455 * z2559 - z1456 * z2562 - z1457 * z2563;
    const Scalar z2577 = z1455 * z2572 - z1456 * z2575 - z1457 * z2576;
    const Scalar z2539 = z1445 * z2532 - z1446 * z2536 - z1447 * z2537 - z1448 * z2538;
    const Scalar z2552 = z1445 * z2545 - z1446 * z2549 - z1447 * z2550 - z1448 * z2551;
    const Scalar z2565 = z1445 * z2558 - z1446 * z2562 - z1447 * z2563 - z1448 * z2564;
    const Scalar z2578 = z1445 * z2571 - z1446 * z2575 - z1447 * z2576 - z1448 * z2577;
    const Scalar z2527 = z1430 * z2518 - z1431 * z2523 - z1432 * z2524 - z1433 * z2525 - z1434 * z2526;
    const Scalar z2587 = z1382 * z2375 - z1410 * z2582 - z1431 * z2583 - z1446 * z2584 - z1456 * z2585 + z2268 - z1462
        * z2586;
    const Scalar z2540 = z1430 * z2531 - z1431 * z2536 - z1432 * z2537 - z1433 * z2538 - z1434 * z2539;
    const Scalar z2553 = z1430 * z2544 - z1431 * z2549 - z1432 * z2550 - z1433 * z2551 - z1434 * z2552;
    const Scalar z2566 = z1430 * z2557 - z1431 * z2562 - z1432 * z2563 - z1433 * z2564 - z1434 * z2565;
    const Scalar z2579 = z1430 * z2570 - z1431 * z2575 - z1432 * z2576 - z1433 * z2577 - z1434 * z2578;
    const Scalar z2528 = z1409 * z2517 - z1410 * z2523 - z1411 * z2524 - z1412 * z2525 - z1413 * z2526 - z1414 * z2527;
    const Scalar z2529 = z1382 * z2523 - k52 * z2388 + z1383 * z2524 + z1384 * z2525 + z1385 * z2526 + z1386 * z2527
        + z1387 * z2528;
    const Scalar z2595 = z1387 * z2370 - z2272;
    const Scalar z2596 = z1386 * z2370 - z2307 - z1414 * z2595;
    const Scalar z2588 = z1464 * z2587;
    const Scalar z2589 = z1461 * z2586 - z1462 * z2588;
    const Scalar z2597 = z1385 * z2370 - z2314 - z1413 * z2595 - z1434 * z2596;
    const Scalar z2590 = z1455 * z2585 - z1456 * z2588 - z1457 * z2589;
    const Scalar z2598 = z1384 * z2370 - z1412 * z2595 - z1433 * z2596 + z2320 - z1448 * z2597;
    const Scalar z2591 = z1445 * z2584 - z1446 * z2588 - z1447 * z2589 - z1448 * z2590;
    const Scalar z2599 = z2326 + z1383 * z2370 - z1411 * z2595 - z1432 * z2596 - z1447 * z2597 - z1457 * z2598;
    const Scalar z2600 = z1382 * z2370 - z2330 - z1410 * z2595 - z1431 * z2596 - z1446 * z2597 - z1456 * z2598 - z1462
        * z2599;
    const Scalar z2592 = z1430 * z2583 - z1431 * z2588 - z1432 * z2589 - z1433 * z2590 - z1434 * z2591;
    const Scalar z2541 = z1409 * z2530 - z1410 * z2536 - z1411 * z2537 - z1412 * z2538 - z1413 * z2539 - z1414 * z2540;
    const Scalar z2542 = z1382 * z2536 - k52 * z2389 + z1383 * z2537 + z1384 * z2538 + z1385 * z2539 + z1386 * z2540
        + z1387 * z2541;
    const Scalar z2608 = z1387 * z2371 - z2273;
    const Scalar z2609 = z1386 * z2371 + z2339 - z1414 * z2608;
    const Scalar z2601 = z1464 * z2600;
    const Scalar z2602 = z1461 * z2599 - z1462 * z2601;
    const Scalar z2610 = z1385 * z2371 - z2346 - z1413 * z2608 - z1434 * z2609;
    const Scalar z2603 = z1455 * z2598 - z1456 * z2601 - z1457 * z2602;
    const Scalar z2611 = z1384 * z2371 - z1412 * z2608 - z1433 * z2609 + z2352 - z1448 * z2610;
    const Scalar z2604 = z1445 * z2597 - z1446 * z2601 - z1447 * z2602 - z1448 * z2603;
    const Scalar z2612 = z2358 + z1383 * z2371 - z1411 * z2608 - z1432 * z2609 - z1447 * z2610 - z1457 * z2611;
    const Scalar z2613 = z1382 * z2371 - z2362 - z1410 * z2608 - z1431 * z2609 - z1446 * z2610 - z1456 * z2611 - z1462
        * z2612;
    const Scalar z2605 = z1430 * z2596 - z1431 * z2601 - z1432 * z2602 - z1433 * z2603 - z1434 * z2604;
    const Scalar z2554 = z1409 * z2543 - z1410 * z2549 - z1411 * z2550 - z1412 * z2551 - z1413 * z2552 - z1414 * z2553;
    const Scalar z2555 = z1382 * z2549 - k52 * z2381 + z1383 * z2550 + z1384 * z2551 + z1385 * z2552 + z1386 * z2553
        + z1387 * z2554;
    const Scalar z2621 = z1387 * z2366 - z2409;
    const Scalar z2622 = z1386 * z2366 + z2413 - z1414 * z2621;
    const Scalar z2614 = z1464 * z2613;
    const Scalar z2615 = z1461 * z2612 - z1462 * z2614;
    const Scalar z2623 = z2420 + z1385 * z2366 - z1413 * z2621 - z1434 * z2622;
    const Scalar z2616 = z1455 * z2611 - z1456 * z2614 - z1457 * z2615;
    const Scalar z2624 = z1384 * z2366 - z1412 * z2621 - z1433 * z2622 + z2426 - z1448 * z2623;
    const Scalar z2617 = z1445 * z2610 - z1446 * z2614 - z1447 * z2615 - z1448 * z2616;
    const Scalar z2625 = z2432 + z1383 * z2366 - z1411 * z2621 - z1432 * z2622 - z1447 * z2623 - z1457 * z2624;
    const Scalar z2626 = z2436 + z1382 * z2366 - z1410 * z2621 - z1431 * z2622 - z1446 * z2623 - z1456 * z2624 - z1462
        * z2625;
    const Scalar z2618 = z1430 * z2609 - z1431 * z2614 - z1432 * z2615 - z1433 * z2616 - z1434 * z2617;
    const Scalar z2567 = z1409 * z2556 - z1410 * z2562 - z1411 * z2563 - z1412 * z2564 - z1413 * z2565 - z1414 * z2566;
    const Scalar z2568 = z1382 * z2562 - k52 * z2382 + z1383 * z2563 + z1384 * z2564 + z1385 * z2565 + z1386 * z2566
        + z1387 * z2567;
    const Scalar z2634 = z1387 * z2367 - z2443;
    const Scalar z2635 = z1386 * z2367 + z2447 - z1414 * z2634;
    const Scalar z2627 = z1464 * z2626;
    const Scalar z2628 = z1461 * z2625 - z1462 * z2627;
    const Scalar z2636 = z1385 * z2367 - z2454 - z1413 * z2634 - z1434 * z2635;
    const Scalar z2629 = z1455 * z2624 - z1456 * z2627 - z1457 * z2628;
    const Scalar z2637 = z2460 + z1384 * z2367 - z1412 * z2634 - z1433 * z2635 - z1448 * z2636;
    const Scalar z2638 = z2466 + z1383 * z2367 - z1411 * z2634 - z1432 * z2635 - z1447 * z2636 - z1457 * z2637;
    const Scalar z2639 = z1382 * z2367 - z2470 - z1410 * z2634 - z1431 * z2635 - z1446 * z2636 - z1456 * z2637 - z1462
        * z2638;
    const Scalar z2630 = z1445 * z2623 - z1446 * z2627 - z1447 * z2628 - z1448 * z2629;
    const Scalar z2631 = z1430 * z2622 - z1431 * z2627 - z1432 * z2628 - z1433 * z2629 - z1434 * z2630;
    const Scalar z2580 = z1409 * z2569 - z1410 * z2575 - z1411 * z2576 - z1412 * z2577 - z1413 * z2578 - z1414 * z2579;
    const Scalar z2581 = z1382 * z2575 - k52 * z2374 + z1383 * z2576 + z1384 * z2577 + z1385 * z2578 + z1386 * z2579
        + z1387 * z2580;
    const Scalar z2640 = z1464 * z2639;
    const Scalar z2641 = z1461 * z2638 - z1462 * z2640;
    const Scalar z2593 = z1409 * z2582 - z1410 * z2588 - z1411 * z2589 - z1412 * z2590 - z1413 * z2591 - z1414 * z2592;
    const Scalar z2594 = z1382 * z2588 - k52 * z2375 + z1383 * z2589 + z1384 * z2590 + z1385 * z2591 + z1386 * z2592
        + z1387 * z2593;
    const Scalar z2642 = z1455 * z2637 - z1456 * z2640 - z1457 * z2641;
    const Scalar z2643 = z1445 * z2636 - z1446 * z2640 - z1447 * z2641 - z1448 * z2642;
    const Scalar z2606 = z1409 * z2595 - z1410 * z2601 - z1411 * z2602 - z1412 * z2603 - z1413 * z2604 - z1414 * z2605;
    const Scalar z2607 = z1382 * z2601 - k52 * z2370 + z1383 * z2602 + z1384 * z2603 + z1385 * z2604 + z1386 * z2605
        + z1387 * z2606;
    const Scalar z2644 = z1430 * z2635 - z1431 * z2640 - z1432 * z2641 - z1433 * z2642 - z1434 * z2643;
    const Scalar z2619 = z1409 * z2608 - z1410 * z2614 - z1411 * z2615 - z1412 * z2616 - z1413 * z2617 - z1414 * z2618;
    const Scalar z2620 = z1382 * z2614 - k52 * z2371 + z1383 * z2615 + z1384 * z2616 + z1385 * z2617 + z1386 * z2618
        + z1387 * z2619;
    const Scalar z2632 = z1409 * z2621 - z1410 * z2627 - z1411 * z2628 - z1412 * z2629 - z1413 * z2630 - z1414 * z2631;
    const Scalar z2633 = z1382 * z2627 - k52 * z2366 + z1383 * z2628 + z1384 * z2629 + z1385 * z2630 + z1386 * z2631
        + z1387 * z2632;
    const Scalar z2645 = z1409 * z2634 - z1410 * z2640 - z1411 * z2641 - z1412 * z2642 - z1413 * z2643 - z1414 * z2644;
    const Scalar z2646 = z1382 * z2640 - k52 * z2367 + z1383 * z2641 + z1384 * z2642 + z1385 * z2643 + z1386 * z2644
        + z1387 * z2645;
    const Scalar z2697 = z1386 - z1387 * z1414;
    const Scalar z2686 = z1413 - z1414 * z1434;
    const Scalar z2698 = z1385 - z1387 * z1413 - z1434 * z2697;
    const Scalar z2676 = z1433 - z1434 * z1448;
    const Scalar z2687 = z1412 - z1414 * z1433 - z1448 * z2686;
    const Scalar z2699 = z1384 - z1387 * z1412 - z1433 * z2697 - z1448 * z2698;
    const Scalar z2667 = z1447 - z1448 * z1457;
    const Scalar z2677 = z1432 - z1434 * z1447 - z1457 * z2676;
    const Scalar z2688 = z1411 - z1414 * z1432 - z1447 * z2686 - z1457 * z2687;
    const Scalar z2700 = z1383 - z1387 * z1411 - z1432 * z2697 - z1447 * z2698 - z1457 * z2699;
    const Scalar z2659 = z1456 - z1457 * z1462;
    const Scalar z2660 = z1464 * z2659;
    const Scalar z2668 = z1446 - z1448 * z1456 - z1462 * z2667;
    const Scalar z2669 = z1464 * z2668;
    const Scalar z2678 = z1431 - z1434 * z1446 - z1456 * z2676 - z1462 * z2677;
    const Scalar z2679 = z1464 * z2678;
    const Scalar z2670 = z1461 * z2667 - z1462 * z2669;
    const Scalar z2689 = z1410 - z1414 * z1431 - z1446 * z2686 - z1456 * z2687 - z1462 * z2688;
    const Scalar z2690 = z1464 * z2689;
    const Scalar z2680 = z1461 * z2677 - z1462 * z2679;
    const Scalar z2681 = z1455 * z2676 - z1456 * z2679 - z1457 * z2680;
    const Scalar z2691 = z1461 * z2688 - z1462 * z2690;
    const Scalar z2701 = z1382 - z1387 * z1410 - z1431 * z2697 - z1446 * z2698 - z1456 * z2699 - z1462 * z2700;
    const Scalar z2702 = z1464 * z2701;
    const Scalar z2692 = z1455 * z2687 - z1456 * z2690 - z1457 * z2691;
    const Scalar z2703 = z1461 * z2700 - z1462 * z2702;
    const Scalar z2693 = z1445 * z2686 - z1446 * z2690 - z1447 * z2691 - z1448 * z2692;
    const Scalar z2704 = z1455 * z2699 - z1456 * z2702 - z1457 * z2703;
    const Scalar z2647 = z1462 * z1464;
    const Scalar z2705 = z1445 * z2698 - z1446 * z2702 - z1447 * z2703 - z1448 * z2704;
    const Scalar z2653 = z1461 + z1462 * z2647;
    const Scalar z2661 = z1457 * z1461 - z1462 * z2660;
    const Scalar z2706 = z1430 * z2697 - z1431 * z2702 - z1432 * z2703 - z1433 * z2704 - z1434 * z2705;
    const Scalar z2648 = z1456 * z1464 - z1457 * z2647;
    const Scalar z2654 = z1456 * z2647 - z1457 * z2653;
    const Scalar z2662 = z1455 + z1456 * z2660 + z1457 * z2661;
    const Scalar z2671 = z1448 * z1455 - z1456 * z2669 - z1457 * z2670;
    const Scalar z2649 = z1446 * z1464 - z1447 * z2647 - z1448 * z2648;
    const Scalar z2655 = z1446 * z2647 - z1447 * z2653 - z1448 * z2654;
    const Scalar z2663 = z1446 * z2660 + z1447 * z2661 - z1448 * z2662;
    const Scalar z2672 = z1445 + z1446 * z2669 + z1447 * z2670 + z1448 * z2671;
    const Scalar z2682 = z1434 * z1445 - z1446 * z2679 - z1447 * z2680 - z1448 * z2681;
    const Scalar z2650 = z1431 * z1464 - z1432 * z2647 - z1433 * z2648 - z1434 * z2649;
    const Scalar z2656 = z1431 * z2647 - z1432 * z2653 - z1433 * z2654 - z1434 * z2655;
    const Scalar z2664 = z1431 * z2660 + z1432 * z2661 - z1433 * z2662 - z1434 * z2663;
    const Scalar z2673 = z1431 * z2669 + z1432 * z2670 + z1433 * z2671 - z1434 * z2672;
    const Scalar z2683 = z1430 + z1431 * z2679 + z1432 * z2680 + z1433 * z2681 + z1434 * z2682;
    const Scalar z2694 = z1414 * z1430 - z1431 * z2690 - z1432 * z2691 - z1433 * z2692 - z1434 * z2693;
    const Scalar z2651 = z1410 * z1464 - z1411 * z2647 - z1412 * z2648 - z1413 * z2649 - z1414 * z2650;
    const Scalar z2652 = z1382 * z1464 - z1383 * z2647 - z1384 * z2648 - z1385 * z2649 - z1386 * z2650 - z1387 * z2651;
    const Scalar z2657 = z1410 * z2647 - z1411 * z2653 - z1412 * z2654 - z1413 * z2655 - z1414 * z2656;
    const Scalar z2658 = z1382 * z2647 - z1383 * z2653 - z1384 * z2654 - z1385 * z2655 - z1386 * z2656 - z1387 * z2657;
    const Scalar z2665 = z1410 * z2660 + z1411 * z2661 - z1412 * z2662 - z1413 * z2663 - z1414 * z2664;
    const Scalar z2666 = z1382 * z2660 + z1383 * z2661 - z1384 * z2662 - z1385 * z2663 - z1386 * z2664 - z1387 * z2665;
    const Scalar z2674 = z1410 * z2669 + z1411 * z2670 + z1412 * z2671 - z1413 * z2672 - z1414 * z2673;
    const Scalar z2675 = z1382 * z2669 + z1383 * z2670 + z1384 * z2671 - z1385 * z2672 - z1386 * z2673 - z1387 * z2674;
    const Scalar z2684 = z1410 * z2679 + z1411 * z2680 + z1412 * z2681 + z1413 * z2682 - z1414 * z2683;
    const Scalar z2685 = z1382 * z2679 + z1383 * z2680 + z1384 * z2681 + z1385 * z2682 - z1386 * z2683 - z1387 * z2684;
    const Scalar z2695 = z1409 + z1410 * z2690 + z1411 * z2691 + z1412 * z2692 + z1413 * z2693 + z1414 * z2694;
    const Scalar z2696 = z1382 * z2690 + z1383 * z2691 + z1384 * z2692 + z1385 * z2693 + z1386 * z2694 - z1387 * z2695;
    const Scalar z2707 = z1387 * z1409 - z1410 * z2702 - z1411 * z2703 - z1412 * z2704 - z1413 * z2705 - z1414 * z2706;
    const Scalar z2708 = k52 - z1382 * z2702 - z1383 * z2703 - z1384 * z2704 - z1385 * z2705 - z1386 * z2706 - z1387
        * z2707;
    result.M[0] = z468;
    result.M[1] = -z454;
    result.M[2] = -z434;
    result.M[3] = z406;
    result.M[4] = z372;
    result.M[5] = -z335;
    result.M[6] = z295;
    result.M[7] = -z454;
    result.M[8] = z450;
    result.M[9] = -z430;
    result.M[10] = z402;
    result.M[11] = z368;
    result.M[12] = z331;
    result.M[13] = z291;
    result.M[14] = -z434;
    result.M[15] = -z430;
    result.M[16] = z424;
    result.M[17] = z395;
    result.M[18] = -z362;
    result.M[19] = -z325;
    result.M[20] = -z285;
    result.M[21] = z406;
    result.M[22] = z402;
    result.M[23] = z395;
    result.M[24] = z391;
    result.M[25] = -z356;
    result.M[26] = -z319;
    result.M[27] = z279;
    result.M[28] = z372;
    result.M[29] = z368;
    result.M[30] = -z362;
    result.M[31] = -z356;
    result.M[32] = z349;
    result.M[33] = -z312;
    result.M[34] = z272;
    result.M[35] = -z335;
    result.M[36] = z331;
    result.M[37] = -z325;
    result.M[38] = -z319;
    result.M[39] = -z312;
    result.M[40] = z308;
    result.M[41] = -z267;
    result.M[42] = z295;
    result.M[43] = z291;
    result.M[44] = -z285;
    result.M[45] = z279;
    result.M[46] = z272;
    result.M[47] = -z267;
    result.M[48] = k6;
    result.C[0] = -z2064;
    result.C[1] = -z2046;
    result.C[2] = -z2097;
    result.C[3] = z2145;
    result.C[4] = -z2212;
    result.C[5] = z2298;
    result.C[6] = -z2398;
    result.C[7] = z2087;
    result.C[8] = -z2069;
    result.C[9] = -z2095;
    result.C[10] = -z2143;
    result.C[11] = z2210;
    result.C[12] = z2296;
    result.C[13] = z2396;
    result.C[14] = z2127;
    result.C[15] = -z2123;
    result.C[16] = -z2092;
    result.C[17] = z2136;
    result.C[18] = -z2203;
    result.C[19] = z2289;
    result.C[20] = -z2389;
    result.C[21] = -z2187;
    result.C[22] = -z2183;
    result.C[23] = z2177;
    result.C[24] = -z2132;
    result.C[25] = -z2196;
    result.C[26] = -z2282;
    result.C[27] = -z2382;
    result.C[28] = -z2268;
    result.C[29] = -z2264;
    result.C[30] = z2258;
    result.C[31] = -z2252;
    result.C[32] = z2192;
    result.C[33] = -z2275;
    result.C[34] = z2375;
    result.C[35] = z2362;
    result.C[36] = -z2358;
    result.C[37] = z2352;
    result.C[38] = z2346;
    result.C[39] = -z2339;
    result.C[40] = -z2273;
    result.C[41] = z2371;
    result.C[42] = z2470;
    result.C[43] = -z2466;
    result.C[44] = z2460;
    result.C[45] = z2454;
    result.C[46] = -z2447;
    result.C[47] = -z2443;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z2078;
    result.K[8] = z2068;
    result.K[9] = -z2094;
    result.K[10] = z2142;
    result.K[11] = z2209;
    result.K[12] = z2295;
    result.K[13] = z2395;
    result.K[14] = -z2112;
    result.K[15] = z2108;
    result.K[16] = z2091;
    result.K[17] = z2135;
    result.K[18] = z2202;
    result.K[19] = -z2288;
    result.K[20] = z2388;
    result.K[21] = -z2166;
    result.K[22] = -z2162;
    result.K[23] = z2156;
    result.K[24] = z2131;
    result.K[25] = -z2195;
    result.K[26] = z2281;
    result.K[27] = -z2381;
    result.K[28] = -z2240;
    result.K[29] = z2236;
    result.K[30] = -z2230;
    result.K[31] = -z2224;
    result.K[32] = z2191;
    result.K[33] = z2274;
    result.K[34] = -z2374;
    result.K[35] = -z2330;
    result.K[36] = z2326;
    result.K[37] = -z2320;
    result.K[38] = -z2314;
    result.K[39] = -z2307;
    result.K[40] = z2272;
    result.K[41] = -z2370;
    result.K[42] = -z2436;
    result.K[43] = -z2432;
    result.K[44] = z2426;
    result.K[45] = -z2420;
    result.K[46] = -z2413;
    result.K[47] = -z2409;
    result.K[48] = z2366;
    result.F[0] = z2471;
    result.F[1] = z2472;
    result.F[2] = z2473;
    result.F[3] = z2474;
    result.F[4] = z2475;
    result.F[5] = z2476;
    result.F[6] = z2477;
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
    result.A[21] = -z2497;
    result.A[22] = -z2498;
    result.A[23] = z2499;
    result.A[24] = -z2500;
    result.A[25] = -z2501;
    result.A[26] = z2502;
    result.A[27] = z2503;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = -z2523;
    result.A[36] = -z2524;
    result.A[37] = z2525;
    result.A[38] = -z2526;
    result.A[39] = -z2527;
    result.A[40] = z2528;
    result.A[41] = z2529;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z2549;
    result.A[50] = z2550;
    result.A[51] = -z2551;
    result.A[52] = z2552;
    result.A[53] = z2553;
    result.A[54] = -z2554;
    result.A[55] = -z2555;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z2575;
    result.A[64] = z2576;
    result.A[65] = -z2577;
    result.A[66] = z2578;
    result.A[67] = z2579;
    result.A[68] = -z2580;
    result.A[69] = -z2581;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = z2601;
    result.A[78] = z2602;
    result.A[79] = -z2603;
    result.A[80] = z2604;
    result.A[81] = z2605;
    result.A[82] = -z2606;
    result.A[83] = -z2607;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = -z2627;
    result.A[92] = -z2628;
    result.A[93] = z2629;
    result.A[94] = -z2630;
    result.A[95] = -z2631;
    result.A[96] = z2632;
    result.A[97] = z2633;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = z2484;
    result.A[106] = z2485;
    result.A[107] = -z2486;
    result.A[108] = z2487;
    result.A[109] = z2488;
    result.A[110] = -z2489;
    result.A[111] = -z2490;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = -z2510;
    result.A[120] = -z2511;
    result.A[121] = z2512;
    result.A[122] = -z2513;
    result.A[123] = -z2514;
    result.A[124] = z2515;
    result.A[125] = z2516;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = z2536;
    result.A[134] = z2537;
    result.A[135] = -z2538;
    result.A[136] = z2539;
    result.A[137] = z2540;
    result.A[138] = -z2541;
    result.A[139] = -z2542;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z2562;
    result.A[148] = z2563;
    result.A[149] = -z2564;
    result.A[150] = z2565;
    result.A[151] = z2566;
    result.A[152] = -z2567;
    result.A[153] = -z2568;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z2588;
    result.A[162] = -z2589;
    result.A[163] = z2590;
    result.A[164] = -z2591;
    result.A[165] = -z2592;
    result.A[166] = z2593;
    result.A[167] = z2594;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z2614;
    result.A[176] = -z2615;
    result.A[177] = z2616;
    result.A[178] = -z2617;
    result.A[179] = -z2618;
    result.A[180] = z2619;
    result.A[181] = z2620;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z2640;
    result.A[190] = -z2641;
    result.A[191] = z2642;
    result.A[192] = -z2643;
    result.A[193] = -z2644;
    result.A[194] = z2645;
    result.A[195] = z2646;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z1464;
    result.B[8] = z2647;
    result.B[9] = -z2648;
    result.B[10] = z2649;
    result.B[11] = z2650;
    result.B[12] = -z2651;
    result.B[13] = z2652;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z2647;
    result.B[22] = -z2653;
    result.B[23] = z2654;
    result.B[24] = -z2655;
    result.B[25] = -z2656;
    result.B[26] = z2657;
    result.B[27] = -z2658;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z2660;
    result.B[36] = -z2661;
    result.B[37] = -z2662;
    result.B[38] = z2663;
    result.B[39] = z2664;
    result.B[40] = -z2665;
    result.B[41] = z2666;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z2669;
    result.B[50] = z2670;
    result.B[51] = -z2671;
    result.B[52] = -z2672;
    result.B[53] = -z2673;
    result.B[54] = z2674;
    result.B[55] = -z2675;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z2679;
    result.B[64] = z2680;
    result.B[65] = -z2681;
    result.B[66] = z2682;
    result.B[67] = -z2683;
    result.B[68] = z2684;
    result.B[69] = -z2685;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z2690;
    result.B[78] = -z2691;
    result.B[79] = z2692;
    result.B[80] = -z2693;
    result.B[81] = -z2694;
    result.B[82] = -z2695;
    result.B[83] = z2696;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z2702;
    result.B[92] = z2703;
    result.B[93] = -z2704;
    result.B[94] = z2705;
    result.B[95] = z2706;
    result.B[96] = -z2707;
    result.B[97] = z2708;
    if (!(traits::regular(-z1463, z468) && traits::regular(-z1460, z450) && traits::regular(-z1454, z424)
        && traits::regular(-z1444, z391) && traits::regular(-z1429, z349) && traits::regular(-z1408,
        z308))) return torsor::Status::singular;
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
