// SPDX-License-Identifier: MIT
// rolling_hoop_contact_forces: Hoop rolling without slipping: six coordinates, the three contact forces
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: A, C
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without inertia moved across
// joints, products that sums share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                2                1          3             0                  0       0      6       -
//   kinematics               16               27          0             0                  3       0     49      49
//   mass_matrix               1                3          0             0                  1       0      6       7
//   bias                      4               15          0             0                  1       0     21      50
//   inverse_dynamics         26               33          0             0                  2       0     63      99
//   forward_dynamics         34               68          3             0                  2       0    109     142
//   energy                   14               28          0             0                  3       0     48      54
//   first_integrals          15               28          0             0                  3       0     49      55
//   constraints              11               16          0             0                  2       0     31      32
//   linearisation           237              345         13             0                  3       0    601     680
//
// Not computed because this mechanism does not need it:
//   kinematics: of 42 results 10 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 36 results 28 vanish identically, 1 repeat another up to sign
//   bias: of 6 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 27 results 11 vanish identically, 3 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 214 results 133 vanish identically, 5 repeat another up to sign
//
// To write this file again:
//   rolling_hoop_contact_forces_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output rolling_hoop_contact_forces.hpp
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

namespace rolling_hoop_contact_forces {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "rolling_hoop_contact_forces";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x154e6bd40db86be4ULL;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 3;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar A;  ///< parameter [kg m^2]
    Scalar C;  ///< parameter [kg m^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::A, &Parameters::C};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar theta;  ///< coordinate [rad or 1]
    Scalar phi;  ///< coordinate [rad or 1]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z, &Coordinates::psi,
          &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z, &Velocities::psi,
          &Velocities::theta, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::psi, &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::psi, &GeneralizedForces::theta, &GeneralizedForces::phi};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar X_F;  ///< of the constraint along_x1 [N]
    Scalar Y_F;  ///< of the constraint along_y1 [N]
    Scalar N;  ///< of the constraint touching [N]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::X_F, &Multipliers::Y_F, &Multipliers::N};
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
    Scalar z59;
    Scalar z147;
    Scalar z150;
    Scalar z155;
    Scalar z163;
    Scalar z261;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    parameters.A = n0_5;
    parameters.C = n1;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar p_A = parameters.A;
    const Scalar p_C = parameters.C;
    const Scalar z59 = p_A - p_C;
    const Scalar z147 = n1 / p_C;
    const Scalar z150 = n1 / p_A;
    const Scalar z155 = n1 + z147;
    const Scalar z163 = n1 / z155;
    const Scalar z261 = n0_5 * p_C;
    precomputed.z59 = z59;
    precomputed.z147 = z147;
    precomputed.z150 = z150;
    precomputed.z155 = z155;
    precomputed.z163 = z163;
    precomputed.z261 = z261;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar z0 = n1_2;
    const Scalar z1 = traits::formula(0.36235775447667357, 0.36235777f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z2 = traits::formula(0.9320390859672264, 0.9320391f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    state.time = n0;
    state.q.x = n0;
    state.q.y = z1;
    state.q.z = z2;
    state.q.psi = n0;
    state.q.theta = n1_2;
    state.q.phi = n0;
    state.v.x = n4 - n0_5 * z1;
    state.v.y = n0_3 * z2;
    state.v.z = -n0_3 * z1;
    state.v.psi = n0_5;
    state.v.theta = -n0_3;
    state.v.phi = -n4;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> hoop_position;  ///< centre of mass of hoop [m]
    std::array<Scalar, 9> hoop_rotation;  ///< from the axes of hoop to the ground's (3 x 3)
    std::array<Scalar, 3> hoop_velocity;  ///< velocity of the centre of mass of hoop [m/s]
    std::array<Scalar, 3> hoop_angular_velocity;  ///< angular velocity of hoop [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 18> I_jacobian;  ///< partial velocities of I (3 x 6)
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
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy};
      return members_[i_];
    }
  };

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 3> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 3> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 18> jacobian;  ///< A, stored column by column (3 x 6)
    std::array<Scalar, 3> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 36> M;  ///< mass matrix (6 x 6)
    std::array<Scalar, 36> C;  ///< damping and gyroscopic terms (6 x 6)
    std::array<Scalar, 36> K;  ///< stiffness (6 x 6)
    std::array<Scalar, 6> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 15> K_r;  ///< reduced stiffness (3 x 5)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, w): x' = A x + B du (8 x 8)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 5;
  static constexpr int independent_coordinates[] = {0, 1, 3, 4, 5};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[] = {1, 3, 5};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z31 = v_psi * c_theta;
    const Scalar z26 = s_psi * c_theta;
    const Scalar z27 = s_psi * s_theta;
    const Scalar z28 = c_psi * c_theta;
    const Scalar z29 = c_psi * s_theta;
    const Scalar z32 = c_psi * v_theta;  // angular velocity of hoop.2, x
    const Scalar z33 = s_psi * v_theta;  // angular velocity of hoop.2, y
    const Scalar z38 = s_theta * s_phi;
    const Scalar z39 = s_theta * c_phi;
    const Scalar z45 = v_psi + c_theta * v_phi;  // angular velocity of hoop, z
    const Scalar z48 = v_z - v_theta * c_theta;
    const Scalar z51 = q_z - s_theta;
    const Scalar z34 = c_psi * c_phi - s_phi * z26;
    const Scalar z35 = c_psi * s_phi + c_phi * z26;
    const Scalar z36 = s_psi * c_phi + s_phi * z28;
    const Scalar z37 = s_psi * s_phi - c_phi * z28;
    const Scalar z43 = v_phi * z27 + z32;  // angular velocity of hoop, x
    const Scalar z44 = v_phi * z29 - z33;  // angular velocity of hoop, y
    const Scalar z46 = v_x + c_psi * z31 - v_theta * z27;
    const Scalar z47 = v_y + s_psi * z31 + v_theta * z29;
    const Scalar z49 = q_x + z26;
    const Scalar z50 = q_y - z28;
    const Scalar z52 = s_psi * z26 + c_psi * z28;
    result.hoop_position[0] = q_x;
    result.hoop_position[1] = q_y;
    result.hoop_position[2] = q_z;
    result.hoop_rotation[0] = z34;
    result.hoop_rotation[1] = z36;
    result.hoop_rotation[2] = z38;
    result.hoop_rotation[3] = -z35;
    result.hoop_rotation[4] = -z37;
    result.hoop_rotation[5] = z39;
    result.hoop_rotation[6] = z27;
    result.hoop_rotation[7] = -z29;
    result.hoop_rotation[8] = c_theta;
    result.hoop_velocity[0] = v_x;
    result.hoop_velocity[1] = v_y;
    result.hoop_velocity[2] = v_z;
    result.hoop_angular_velocity[0] = z43;
    result.hoop_angular_velocity[1] = -z44;
    result.hoop_angular_velocity[2] = z45;
    result.I_position[0] = z49;
    result.I_position[1] = z50;
    result.I_position[2] = z51;
    result.I_velocity[0] = z46;
    result.I_velocity[1] = z47;
    result.I_velocity[2] = z48;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = n0;
    result.I_jacobian[9] = z28;
    result.I_jacobian[12] = -z27;
    result.I_jacobian[15] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = n0;
    result.I_jacobian[10] = z26;
    result.I_jacobian[13] = z29;
    result.I_jacobian[16] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n1;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = -z52;
    result.I_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 36>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z61 = c_theta * z59;
    const Scalar z54 = c_theta * p_C;
    const Scalar z62 = c_theta * z61 - p_A;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n1;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n1;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = -z62;
    mass[22] = n0;
    mass[23] = z54;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = p_A;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = z54;
    mass[34] = n0;
    mass[35] = p_C;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z31 = v_psi * c_theta;
    const Scalar z30 = v_psi * s_theta;
    const Scalar z42 = v_phi + z31;
    const Scalar z80 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z81 = v_theta * z30;  // angular acceleration of hoop.2, z
    const Scalar z89 = z30 * z31;
    const Scalar z84 = z30 * z42;
    const Scalar z85 = v_theta * z42;
    const Scalar z88 = p_C * z81;  // moment on hoop, z
    const Scalar z90 = n2 * z80;
    const Scalar z86 = p_C * z84;  // moment on hoop, x
    const Scalar z87 = p_C * z85;  // moment on hoop, y
    const Scalar z91 = p_A * z89 - z86;  // moment on hoop.2, x
    const Scalar z92 = p_A * z90 - z87;  // moment on hoop.2, y
    const Scalar z94 = s_theta * z92 - c_theta * z88;
    forces.x = n0;
    forces.y = n0;
    forces.z = n9_81;
    forces.psi = z94;
    forces.theta = -z91;
    forces.phi = -z88;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_x = state.q.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar a_y = accelerations.y;
    const Scalar a_z = accelerations.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_X_F = multipliers.X_F;
    const Scalar l_Y_F = multipliers.Y_F;
    const Scalar l_N = multipliers.N;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z30 = v_psi * s_theta;
    const Scalar z31 = v_psi * c_theta;
    const Scalar z102 = a_psi * c_theta;
    const Scalar z101 = a_psi * s_theta;
    const Scalar z26 = s_psi * c_theta;
    const Scalar z28 = c_psi * c_theta;
    const Scalar z27 = s_psi * s_theta;
    const Scalar z29 = c_psi * s_theta;
    const Scalar z98 = n9_81 + a_z;
    const Scalar z42 = v_phi + z31;
    const Scalar z49 = q_x + z26;
    const Scalar z50 = q_y - z28;
    const Scalar z80 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z89 = z30 * z31;
    const Scalar z105 = v_theta * z31 + z101;  // angular acceleration of hoop.2, y
    const Scalar z106 = v_theta * z30 - z102;  // angular acceleration of hoop.2, z
    const Scalar z84 = z30 * z42;
    const Scalar z85 = v_theta * z42;
    const Scalar z135 = q_x - z49;
    const Scalar z136 = q_y - z50;
    const Scalar z109 = a_phi - z106;  // angular acceleration of hoop, z
    const Scalar z111 = z80 + z105;
    const Scalar z86 = p_C * z84;  // moment on hoop, x
    const Scalar z87 = p_C * z85;  // moment on hoop, y
    const Scalar z140 = s_psi * z135 - c_psi * z136;
    const Scalar z143 = z27 * z136 + z29 * z135;
    const Scalar z110 = p_C * z109;  // moment on hoop, z
    const Scalar z112 = p_A * (a_theta - z89) + z86;  // moment on hoop.2, x
    const Scalar z113 = p_A * z111 - z87;  // moment on hoop.2, y
    const Scalar z115 = c_theta * z110 + s_theta * z113;
    forces.x = a_x + s_psi * l_Y_F - c_psi * l_X_F;
    forces.y = a_y - s_psi * l_X_F - c_psi * l_Y_F;
    forces.z = z98 - l_N;
    forces.psi = -c_theta * l_X_F + z115;
    forces.theta = -s_theta * l_Y_F + z112 - z140 * l_N;
    forces.phi = z110 - l_X_F + z143 * l_N;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z59 = precomputed.z59;
    const Scalar z147 = precomputed.z147;
    const Scalar z150 = precomputed.z150;
    const Scalar z155 = precomputed.z155;
    const Scalar z163 = precomputed.z163;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z26 = s_psi * c_theta;
    const Scalar z28 = c_psi * c_theta;
    const Scalar z31 = v_psi * c_theta;
    const Scalar z149 = s_theta * s_theta * p_A;
    const Scalar z152 = s_theta * z150;
    const Scalar z30 = v_psi * s_theta;
    const Scalar z127 = v_psi * c_psi;
    const Scalar z126 = v_psi * s_psi;
    const Scalar z128 = v_theta * s_theta;
    const Scalar z131 = v_theta * c_theta;
    const Scalar z54 = c_theta * p_C;
    const Scalar z27 = s_psi * s_theta;
    const Scalar z29 = c_psi * s_theta;
    const Scalar z61 = c_theta * z59;
    const Scalar z42 = v_phi + z31;
    const Scalar z49 = q_x + z26;
    const Scalar z50 = q_y - z28;
    const Scalar z62 = c_theta * z61 - p_A;
    const Scalar z80 = v_theta * z31;  // angular acceleration of hoop.2, y
    const Scalar z81 = v_theta * z30;  // angular acceleration of hoop.2, z
    const Scalar z89 = z30 * z31;
    const Scalar z129 = v_x * z126 - v_y * z127 + v_psi * z128;
    const Scalar z132 = v_x * z127 + v_y * z126 - v_theta * z131;
    const Scalar z134 = v_theta * z128;
    const Scalar z148 = z54 * z147;
    const Scalar z156 = n1 + s_theta * z152;
    const Scalar z157 = c_theta * z152;
    const Scalar z84 = z30 * z42;
    const Scalar z85 = v_theta * z42;
    const Scalar z88 = p_C * z81;  // moment on hoop, z
    const Scalar z90 = n2 * z80;
    const Scalar z135 = q_x - z49;
    const Scalar z136 = q_y - z50;
    const Scalar z151 = n1 / z149;
    const Scalar z86 = p_C * z84;  // moment on hoop, x
    const Scalar z87 = p_C * z85;  // moment on hoop, y
    const Scalar z140 = s_psi * z135 - c_psi * z136;
    const Scalar z143 = z27 * z136 + z29 * z135;
    const Scalar z91 = p_A * z89 - z86;  // moment on hoop.2, x
    const Scalar z92 = p_A * z90 - z87;  // moment on hoop.2, y
    const Scalar z153 = z140 * z150;
    const Scalar z154 = z143 * z147;
    const Scalar z164 = s_theta * z92;
    const Scalar z166 = z91 * z150;
    const Scalar z158 = n1 - c_theta * z153;
    const Scalar z165 = z151 * z164;
    const Scalar z169 = s_theta * z166 - z132;
    const Scalar z170 = n9_81 - z134 + c_theta * z166;
    const Scalar z167 = z88 * z147 + z148 * z165;
    const Scalar z159 = n1 / z158;
    const Scalar z175 = z155 + z156 + z158;
    const Scalar z168 = c_theta * z165 + z129 - z167;
    const Scalar z176 = n4096 * z175;
    const Scalar z172 = z163 * z168;
    const Scalar z160 = z157 * z159;
    const Scalar z161 = z156 - z157 * z160;
    const Scalar z171 = z160 * z170 - z169;
    const Scalar z162 = n1 / z161;
    const Scalar z173 = z162 * z171;
    const Scalar z174 = z159 * z170 + z160 * z173;
    const Scalar z177 = s_psi * z173 - c_psi * z172;
    const Scalar z178 = s_psi * z172 + c_psi * z173;
    const Scalar z179 = n9_81 - z174;
    const Scalar z180 = z166 + z152 * z173 + z153 * z174;
    const Scalar z181 = z167 + z147 * z172 - z154 * z174;
    accelerations.x = -z177;
    accelerations.y = z178;
    accelerations.z = -z179;
    accelerations.psi = -z165;
    accelerations.theta = z180;
    accelerations.phi = z181;
    multipliers.X_F = z172;
    multipliers.Y_F = z173;
    multipliers.N = z174;
    if (!(traits::regular(z149, -z62) && traits::regular(p_A, p_A) && traits::regular(p_C, p_C) && traits::regular(z155,
        z176) && traits::regular(z161, z176) && traits::regular(z158, z176))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.z * accelerations.psi
        * accelerations.theta * accelerations.phi * multipliers.X_F * multipliers.Y_F * multipliers.N;
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
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z183 = v_x * s_psi - v_y * c_psi;
    const Scalar z182 = v_x * c_psi + v_y * s_psi;
    const Scalar z30 = v_psi * s_theta;
    const Scalar z31 = v_psi * c_theta;
    const Scalar z40 = v_theta * c_phi + s_phi * z30;
    const Scalar z41 = v_theta * s_phi - c_phi * z30;
    const Scalar z42 = v_phi + z31;
    const Scalar z184 = v_z * s_theta - c_theta * z183;
    const Scalar z185 = v_z * c_theta + s_theta * z183;
    const Scalar z186 = c_phi * z182 + s_phi * z184;
    const Scalar z187 = s_phi * z182 - c_phi * z184;
    result.kinetic = n0_5 * (p_C * z42 * z42 + z185 * z185 + p_A * (z40 * z40 + z41 * z41) + z186 * z186 + z187 * z187);
    result.force_function = -n9_81 * q_z;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z183 = v_x * s_psi - v_y * c_psi;
    const Scalar z182 = v_x * c_psi + v_y * s_psi;
    const Scalar z30 = v_psi * s_theta;
    const Scalar z31 = v_psi * c_theta;
    const Scalar z40 = v_theta * c_phi + s_phi * z30;
    const Scalar z41 = v_theta * s_phi - c_phi * z30;
    const Scalar z42 = v_phi + z31;
    const Scalar z184 = v_z * s_theta - c_theta * z183;
    const Scalar z185 = v_z * c_theta + s_theta * z183;
    const Scalar z186 = c_phi * z182 + s_phi * z184;
    const Scalar z187 = s_phi * z182 - c_phi * z184;
    result.energy = n9_81 * q_z + n0_5 * (p_C * z42 * z42 + z185 * z185 + p_A * (z40 * z40 + z41 * z41) + z186 * z186
        + z187 * z187);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z213 = v_psi * s_psi;
    const Scalar z214 = v_psi * c_psi;
    const Scalar z215 = v_theta * s_theta;
    const Scalar z218 = v_theta * c_theta;
    const Scalar z211 = q_z - s_theta;
    const Scalar z212 = v_phi + v_x * c_psi + v_y * s_psi + v_psi * c_theta;
    const Scalar z216 = v_x * z213 - v_y * z214 + v_psi * z215;
    const Scalar z217 = v_x * s_psi - z215 - v_y * c_psi;
    const Scalar z219 = v_x * z214 + v_y * z213 - v_theta * z218;
    const Scalar z220 = v_z - z218;
    const Scalar z221 = v_theta * z215;
    result.value[0] = n0;
    result.rate[0] = z212;
    result.gamma[0] = -z216;
    result.value[1] = n0;
    result.rate[1] = -z217;
    result.gamma[1] = -z219;
    result.value[2] = z211;
    result.rate[2] = z220;
    result.gamma[2] = z221;
    result.jacobian[0] = c_psi;
    result.jacobian[1] = -s_psi;
    result.jacobian[2] = n0;
    result.jacobian[3] = s_psi;
    result.jacobian[4] = c_psi;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n1;
    result.jacobian[9] = c_theta;
    result.jacobian[10] = n0;
    result.jacobian[11] = n0;
    result.jacobian[12] = n0;
    result.jacobian[13] = s_theta;
    result.jacobian[14] = -c_theta;
    result.jacobian[15] = n1;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, psi, theta, phi,
  /// w those of the rates of y, psi, phi;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar a_z = accelerations.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_X_F = multipliers.X_F;
    const Scalar l_Y_F = multipliers.Y_F;
    const Scalar l_N = multipliers.N;
    const Scalar z59 = precomputed.z59;
    const Scalar z261 = precomputed.z261;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z568 = v_psi * s_theta;
    const Scalar z576 = c_theta * z59;
    const Scalar z575 = c_theta * p_C;
    const Scalar z569 = v_psi * c_theta;
    const Scalar z594 = v_psi * c_psi;
    const Scalar z587 = a_psi * c_theta;
    const Scalar z593 = v_psi * s_psi;
    const Scalar z595 = v_theta * s_theta;
    const Scalar z598 = v_theta * c_theta;
    const Scalar z608 = v_x * s_psi;
    const Scalar z586 = a_psi * s_theta;
    const Scalar z621 = n2 * v_theta;
    const Scalar z566 = c_psi * c_theta;
    const Scalar z564 = s_psi * c_theta;
    const Scalar z607 = v_x * c_psi + v_y * s_psi;
    const Scalar z565 = s_psi * s_theta;
    const Scalar z567 = c_psi * s_theta;
    const Scalar z585 = n9_81 + a_z;
    const Scalar z570 = v_theta * c_phi + s_phi * z568;
    const Scalar z571 = v_theta * s_phi - c_phi * z568;
    const Scalar z572 = v_phi + z569;
    const Scalar z573 = q_x + z564;
    const Scalar z574 = q_y - z566;
    const Scalar z577 = c_theta * z576 - p_A;
    const Scalar z578 = v_theta * z569;  // angular acceleration of hoop.2, y
    const Scalar z579 = v_theta * z568;  // angular acceleration of hoop.2, z
    const Scalar z584 = z568 * z569;
    const Scalar z588 = v_theta * z569 + z586;  // angular acceleration of hoop.2, y
    const Scalar z589 = v_theta * z568 - z587;  // angular acceleration of hoop.2, z
    const Scalar z596 = v_x * z593;
    const Scalar z599 = v_theta * z598;
    const Scalar z600 = v_x * z594;
    const Scalar z602 = v_theta * z595;
    const Scalar z609 = v_y * c_psi - z608;
    const Scalar z616 = z568 * z568;
    const Scalar z617 = z569 * z569;
    const Scalar z622 = n2 * z568;
    const Scalar z623 = n2 * z569;
    const Scalar z580 = z568 * z572;
    const Scalar z581 = v_theta * z572;
    const Scalar z597 = v_y * z594 - z596 - v_psi * z595;
    const Scalar z601 = v_y * z593 - z599 + z600;
    const Scalar z603 = q_x - z573;
    const Scalar z604 = q_y - z574;
    const Scalar z618 = z616 + z617;
    const Scalar z626 = n2 * z572;
    const Scalar z590 = a_phi - z589;  // angular acceleration of hoop, z
    const Scalar z610 = z571 * z572;
    const Scalar z611 = z570 * z572;
    const Scalar z619 = z579 - z589;
    const Scalar z620 = z578 - z588;
    const Scalar z624 = n2 * z570;
    const Scalar z625 = n2 * z571;
    const Scalar z582 = p_C * z580;  // moment on hoop, x
    const Scalar z583 = p_C * z581;  // moment on hoop, y
    const Scalar z649 = s_psi * l_X_F + c_psi * l_Y_F;
    const Scalar z648 = s_psi * l_Y_F - c_psi * l_X_F;
    const Scalar z650 = c_theta * l_X_F;
    const Scalar z605 = s_psi * z603 - c_psi * z604;
    const Scalar z606 = z565 * z604 + z567 * z603;
    const Scalar z627 = z261 * z626;
    const Scalar z591 = p_C * z590;  // moment on hoop, z
    const Scalar z612 = p_C * z610;  // moment on hoop, x
    const Scalar z613 = p_C * z611;  // moment on hoop, y
    const Scalar z628 = z261 * z625;
    const Scalar z629 = z261 * z624;
    const Scalar z640 = p_C * z620;
    const Scalar z592 = p_A * (a_theta - z584) + z582;  // moment on hoop.2, x
    const Scalar z658 = z564 * z604 + z566 * z603;
    const Scalar z655 = s_psi * z565 + c_psi * z567;
    const Scalar z672 = v_y * z594 - z596;
    const Scalar z614 = s_phi * z612 + c_phi * z613;
    const Scalar z671 = a_phi + a_x * c_psi + a_y * s_psi + z587 + z597;
    const Scalar z674 = v_y * c_psi - z595 - z608;
    const Scalar z673 = z672 + a_x * c_psi + a_y * s_psi;
    const Scalar z615 = p_A * (z578 + z588) - z614;  // moment on hoop.2, y
    const Scalar z661 = p_A * (z578 + z588) - z583;  // moment on hoop.2, y
    const Scalar z675 = v_y * z593 + z600;
    const Scalar z676 = z675 + a_x * s_psi - a_y * c_psi;
    const Scalar z643 = p_A * z623 - z627;
    const Scalar z677 = n2 * z595;
    const Scalar z678 = a_theta * s_theta + z599;
    const Scalar z659 = l_N * z658;
    const Scalar z656 = c_theta * l_Y_F + l_N * z655;
    const Scalar z652 = l_X_F - l_N * z606;
    const Scalar z662 = c_theta * z591 + s_theta * z661;
    const Scalar z666 = z650 - z662;
    const Scalar z670 = a_x * s_psi - a_y * c_psi - a_theta * s_theta + z601;
    const Scalar z663 = a_x + z648;
    const Scalar z668 = z591 - z652;
    const Scalar z651 = s_theta * l_Y_F + l_N * z605;
    const Scalar z667 = z592 - z651;
    const Scalar z665 = l_N - z585;
    const Scalar z688 = c_psi * c_psi;
    const Scalar z689 = n1 + n1 / p_C - c_theta * c_theta / z577;
    const Scalar z684 = n1 / c_psi;
    const Scalar z683 = n1 / s_theta;
    const Scalar z631 = s_phi * z628 + c_phi * z629;
    const Scalar z630 = s_phi * z629 - c_phi * z628;
    const Scalar z641 = z569 * z631 - z640 - z615;
    const Scalar z646 = z569 * z631 - z640;
    const Scalar z660 = z646 - z659;
    const Scalar z690 = s_psi * z684;
    const Scalar z681 = v_psi * z598;
    const Scalar z682 = z586 + z681;
    const Scalar z691 = z683 * z684;
    const Scalar z679 = n2 * z598;
    const Scalar z633 = p_A * z621 - z631;
    const Scalar z639 = p_A * z619 - z591 - z568 * z633;
    const Scalar z634 = z631 - z633;
    const Scalar z647 = s_theta * z631;
    const Scalar z636 = c_theta * z634;
    const Scalar z680 = a_theta * c_theta - z602;
    const Scalar z642 = s_theta * z639 - c_theta * z641;
    const Scalar z637 = s_theta * z636;
    const Scalar z669 = a_z - a_theta * c_theta + z602;
    const Scalar z644 = p_C * z622 - z630;
    const Scalar z632 = p_A * z622 - z630;
    const Scalar z638 = p_A * z618 - z569 * z627 - z568 * z632;
    const Scalar z635 = s_theta * z627 - c_theta * z632;
    const Scalar z657 = z638 + z656;
    const Scalar z699 = z609 * z684;
    const Scalar z645 = s_theta * z643 - c_theta * z644;
    const Scalar z709 = c_theta * z621 / (c_psi * s_theta);
    const Scalar z697 = z683 * z690;
    const Scalar z693 = c_theta * z684;
    const Scalar z698 = c_theta * z697;
    const Scalar z694 = s_psi * z693;
    const Scalar z705 = n2 * v_psi;
    const Scalar z702 = z568 * z684;
    const Scalar z703 = s_psi * z702 - z598;
    const Scalar z695 = z683 * z694;
    const Scalar z700 = v_x / c_psi;
    const Scalar z701 = z683 * z700;
    const Scalar z706 = z705 / c_psi;
    const Scalar z708 = s_psi * z705 / c_psi;
    const Scalar z704 = z683 * z703;
    const Scalar z707 = z674 + z593 * z693 + z568 * z695;
    const Scalar z710 = z594 * z693 - z607 - z679 * z695;
    const Scalar z696 = c_theta * z695;
    const Scalar z692 = c_theta * z691;
    const Scalar z711 = z594 * z684 - z679 * z697;
    const Scalar z653 = s_theta * l_X_F;
    const Scalar z654 = z642 + z653;
    const Scalar z719 = z684 * z707;
    const Scalar z715 = z684 * z706;
    const Scalar z720 = s_psi * z719 + z710;
    const Scalar z712 = z677 * z691;
    const Scalar z713 = z677 * z695;
    const Scalar z714 = z677 * z697;
    const Scalar z723 = z684 * z708;
    const Scalar z716 = s_psi * z715 - z709;
    const Scalar z721 = z683 * z720;
    const Scalar z685 = s_theta * s_theta;
    const Scalar z686 = n1 + z685 / p_A;
    const Scalar z664 = a_y - z649;
    const Scalar z724 = s_psi * z723 + z711;
    const Scalar z717 = z683 * z716;
    const Scalar z722 = c_theta * z721 - z713;
    const Scalar z746 = z671 * z684;
    const Scalar z725 = z683 * z724;
    const Scalar z718 = c_theta * z717 - z712;
    const Scalar z727 = z568 * z701 - z593 * z699;
    const Scalar z728 = z593 * z702 + z568 * z704;
    const Scalar z733 = z676 + z727;
    const Scalar z734 = z682 + z728;
    const Scalar z729 = z594 * z699 + z679 * z701;
    const Scalar z730 = z594 * z702 - z679 * z704;
    const Scalar z735 = z673 - z729;
    const Scalar z736 = z680 - z730;
    const Scalar z738 = z684 * z733;
    const Scalar z742 = z684 * z734;
    const Scalar z739 = s_psi * z738 + z735;
    const Scalar z687 = p_A * z686;
    const Scalar z743 = s_psi * z742 - z736;
    const Scalar z726 = c_theta * z725 - z714;
    const Scalar z740 = z683 * z739;
    const Scalar z769 = z637 + z645 * z695;
    const Scalar z744 = z683 * z743;
    const Scalar z775 = z635 * z695 + z769;
    const Scalar z747 = s_psi * z746 - z670;
    const Scalar z748 = z683 * z747;
    const Scalar z752 = p_A * z697;
    const Scalar z758 = p_C + z684 * z684 + z697 * z752 + z698 * z698;
    const Scalar z749 = c_theta * z748 + z669;
    const Scalar z751 = p_A * z695;
    const Scalar z757 = z575 + z684 * z693 + z696 * z698 + z697 * z751;
    const Scalar z756 = z577 - z693 * z693 - z695 * z751 - z696 * z696;
    const Scalar z750 = p_A * z691;
    const Scalar z754 = z690 * z693 + z695 * z750 + z692 * z696;
    const Scalar z755 = z684 * z690 + z697 * z750 + z692 * z698;
    const Scalar z732 = z677 * z704;
    const Scalar z737 = z678 + z732;
    const Scalar z731 = z677 * z701;
    const Scalar z741 = c_theta * z740 - z731;
    const Scalar z753 = n1 + z690 * z690 + z691 * z750 + z692 * z692;
    const Scalar z745 = c_theta * z744 - z737;
    const Scalar z818 = n1 / z758;
    const Scalar z809 = z663 * z690 - z664 - z665 * z692 + z667 * z691;
    const Scalar z810 = z666 + z663 * z693 + z667 * z695 - z665 * z696;
    const Scalar z811 = z663 * z684 - z668 - z665 * z698 + z667 * z697;
    const Scalar z792 = z645 * z704;
    const Scalar z795 = z654 + z792;
    const Scalar z794 = z644 * z704;
    const Scalar z796 = z660 + z794;
    const Scalar z770 = z645 * z697 + z647;
    const Scalar z772 = z644 * z695 - z647;
    const Scalar z776 = z630 * z695 + z770;
    const Scalar z800 = z657 * z695 + z795;
    const Scalar z774 = z630 * z691;
    const Scalar z777 = z635 * z697 - z772;
    const Scalar z802 = z657 * z697 - z796;
    const Scalar z773 = z635 * z691;
    const Scalar z798 = z657 * z691;
    const Scalar z791 = z645 * z701;
    const Scalar z793 = z644 * z701;
    const Scalar z768 = z645 * z691;
    const Scalar z771 = z644 * z691;
    const Scalar z799 = z649 * z693 - z791;
    const Scalar z801 = z649 * z684 + z793;
    const Scalar z760 = z690 * z719 + z721 * z750 + z692 * z722;
    const Scalar z778 = z760 - z773;
    const Scalar z761 = z690 * z723 + z725 * z750 + z692 * z726;
    const Scalar z779 = z761 - z774;
    const Scalar z762 = z693 * z715 + z717 * z751 + z696 * z718;
    const Scalar z780 = z762 - z768;
    const Scalar z763 = z693 * z719 + z721 * z751 + z696 * z722;
    const Scalar z766 = z684 * z719 + z721 * z752 + z698 * z722;
    const Scalar z781 = z763 - z775;
    const Scalar z784 = z766 - z777;
    const Scalar z764 = z693 * z723 + z725 * z751 + z696 * z726;
    const Scalar z767 = z684 * z723 + z725 * z752 + z698 * z726;
    const Scalar z782 = z764 - z776;
    const Scalar z765 = z684 * z715 + z717 * z752 + z698 * z718;
    const Scalar z759 = z690 * z715 + z717 * z750 + z692 * z718;
    const Scalar z783 = z765 + z771;
    const Scalar z820 = z757 * z818;
    const Scalar z823 = z756 + z757 * z820;
    const Scalar z822 = z754 - z755 * z820;
    const Scalar z828 = z780 - z783 * z820;
    const Scalar z833 = z781 - z784 * z820;
    const Scalar z824 = n1 / z823;
    const Scalar z843 = z767 * z820 - z782;
    const Scalar z819 = z755 * z818;
    const Scalar z821 = z753 - z755 * z819;
    const Scalar z785 = z690 * z738 + z740 * z750 + z692 * z741;
    const Scalar z786 = z690 * z742 + z744 * z750 + z692 * z745;
    const Scalar z812 = z690 * z746 + z748 * z750 + z692 * z749;
    const Scalar z815 = z809 - z812;
    const Scalar z804 = z786 - z798;
    const Scalar z787 = z693 * z738 + z740 * z751 + z696 * z741;
    const Scalar z789 = z684 * z738 + z740 * z752 + z698 * z741;
    const Scalar z805 = z787 + z799;
    const Scalar z807 = z789 + z801;
    const Scalar z825 = z822 * z824;
    const Scalar z826 = z821 + z822 * z825;
    const Scalar z829 = z759 - z783 * z819 + z825 * z828;
    const Scalar z838 = z805 - z807 * z820;
    const Scalar z827 = n1 / z826;
    const Scalar z834 = z778 - z784 * z819 + z825 * z833;
    const Scalar z844 = z767 * z819 - z779 + z825 * z843;
    const Scalar z788 = z693 * z742 + z744 * z751 + z696 * z745;
    const Scalar z790 = z684 * z742 + z744 * z752 + z698 * z745;
    const Scalar z813 = z693 * z746 + z748 * z751 + z696 * z749;
    const Scalar z814 = z684 * z746 + z748 * z752 + z698 * z749;
    const Scalar z816 = z810 - z813;
    const Scalar z817 = z811 - z814;
    const Scalar z806 = z788 - z800;
    const Scalar z808 = z790 - z802;
    const Scalar z848 = z806 - z808 * z820;
    const Scalar z830 = z827 * z829;
    const Scalar z835 = z827 * z834;
    const Scalar z845 = z827 * z844;
    const Scalar z831 = z824 * z828 - z825 * z830;
    const Scalar z849 = z804 - z808 * z819 + z825 * z848;
    const Scalar z832 = z783 * z818 - z819 * z830 + z820 * z831;
    const Scalar z797 = l_X_F / c_psi;
    const Scalar z803 = z785 + z797;
    const Scalar z850 = z827 * z849;
    const Scalar z836 = z824 * z833 - z825 * z835;
    const Scalar z846 = z824 * z843 - z825 * z845;
    const Scalar z839 = z803 - z807 * z819 + z825 * z838;
    const Scalar z851 = z824 * z848 - z825 * z850;
    const Scalar z837 = z784 * z818 - z819 * z835 + z820 * z836;
    const Scalar z847 = z767 * z818 + z819 * z845 - z820 * z846;
    const Scalar z840 = z827 * z839;
    const Scalar z852 = z808 * z818 - z819 * z850 + z820 * z851;
    const Scalar z841 = z824 * z838 - z825 * z840;
    const Scalar z842 = z807 * z818 - z819 * z840 + z820 * z841;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n1;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n1;
    result.M[15] = n0;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = -z577;
    result.M[22] = n0;
    result.M[23] = z575;
    result.M[24] = n0;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = p_A;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = n0;
    result.M[32] = n0;
    result.M[33] = z575;
    result.M[34] = n0;
    result.M[35] = p_C;
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
    result.C[21] = -z637;
    result.C[22] = z635;
    result.C[23] = -z647;
    result.C[24] = n0;
    result.C[25] = n0;
    result.C[26] = n0;
    result.C[27] = z645;
    result.C[28] = n0;
    result.C[29] = -z644;
    result.C[30] = n0;
    result.C[31] = n0;
    result.C[32] = n0;
    result.C[33] = -z647;
    result.C[34] = z630;
    result.C[35] = n0;
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
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = n0;
    result.K[18] = z649;
    result.K[19] = z648;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.K[25] = n0;
    result.K[26] = n0;
    result.K[27] = z654;
    result.K[28] = -z657;
    result.K[29] = -z660;
    result.K[30] = n0;
    result.K[31] = n0;
    result.K[32] = n0;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.F[0] = -z663;
    result.F[1] = -z664;
    result.F[2] = z665;
    result.F[3] = z666;
    result.F[4] = -z667;
    result.F[5] = -z668;
    result.M_r[0] = z753;
    result.M_r[1] = z754;
    result.M_r[2] = z755;
    result.M_r[3] = z754;
    result.M_r[4] = -z756;
    result.M_r[5] = z757;
    result.M_r[6] = z755;
    result.M_r[7] = z757;
    result.M_r[8] = z758;
    result.C_r[0] = z759;
    result.C_r[1] = z780;
    result.C_r[2] = z783;
    result.C_r[3] = z778;
    result.C_r[4] = z781;
    result.C_r[5] = z784;
    result.C_r[6] = z779;
    result.C_r[7] = z782;
    result.C_r[8] = z767;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = -z803;
    result.K_r[7] = -z805;
    result.K_r[8] = -z807;
    result.K_r[9] = -z804;
    result.K_r[10] = -z806;
    result.K_r[11] = -z808;
    result.K_r[12] = n0;
    result.K_r[13] = n0;
    result.K_r[14] = n0;
    result.F_r[0] = z815;
    result.F_r[1] = z816;
    result.F_r[2] = z817;
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
    result.A[16] = -z699;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = z701;
    result.A[20] = n0;
    result.A[21] = z840;
    result.A[22] = -z841;
    result.A[23] = z842;
    result.A[24] = z702;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = z704;
    result.A[28] = n0;
    result.A[29] = z850;
    result.A[30] = -z851;
    result.A[31] = z852;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = -z690;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = -z691;
    result.A[44] = n0;
    result.A[45] = -z830;
    result.A[46] = z831;
    result.A[47] = -z832;
    result.A[48] = -z693;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = -z695;
    result.A[52] = n0;
    result.A[53] = -z835;
    result.A[54] = z836;
    result.A[55] = -z837;
    result.A[56] = -z684;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = -z697;
    result.A[60] = n1;
    result.A[61] = z845;
    result.A[62] = -z846;
    result.A[63] = -z847;
    if (!(traits::regular(z685, z687) && traits::regular(z688, z689) && traits::regular(z826, z753)
        && traits::regular(-z823, -z756) && traits::regular(z758, z758))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((n0 * result.M[21] * result.M[23] * result.M[28] * result.M[33] * result.M[35] * result.C[21]
        * result.C[22] * result.C[23] * result.C[27]) * (n0 * result.C[29] * result.C[33] * result.C[34] * result.K[18]
        * result.K[19] * result.K[27] * result.K[28] * result.K[29] * result.F[0])) * ((n0 * result.F[1] * result.F[2]
        * result.F[3] * result.F[4] * result.F[5] * result.M_r[0] * result.M_r[1] * result.M_r[2] * result.M_r[3]) * (n0
        * result.M_r[4] * result.M_r[5] * result.M_r[6] * result.M_r[7] * result.M_r[8] * result.C_r[0] * result.C_r[1]
        * result.C_r[2] * result.C_r[3] * result.C_r[4]))) * (((n0 * result.C_r[5] * result.C_r[6] * result.C_r[7]
        * result.C_r[8] * result.K_r[6] * result.K_r[7] * result.K_r[8] * result.K_r[9] * result.K_r[10]) * (n0
        * result.K_r[11] * result.F_r[0] * result.F_r[1] * result.F_r[2] * result.A[16] * result.A[19] * result.A[21]
        * result.A[22] * result.A[23] * result.A[24])) * ((n0 * result.A[27] * result.A[29] * result.A[30]
        * result.A[31] * result.A[40] * result.A[43] * result.A[45] * result.A[46] * result.A[47]) * (n0 * result.A[48]
        * result.A[51] * result.A[53] * result.A[54] * result.A[55] * result.A[56] * result.A[59] * result.A[61]
        * result.A[62] * result.A[63])));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace rolling_hoop_contact_forces
