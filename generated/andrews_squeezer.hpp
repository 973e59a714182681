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
// joints, factoring, and what is done once for a set of parameters:
//   function           additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                64               95          0             0                  7       0    173     173
//   mass_matrix                9                7          0             0                  3       0     22      24
//   bias                      20               35          1             1                  4       0     65      87
//   inverse_dynamics          73               98          1             1                  7       0    187     222
//   forward_dynamics         236              356         12             1                  7       0    619     661
//   energy                    29               50          0             1                  4       0     88      94
//   constraints               87              142          0             0                  7       0    243     249
//   linearisation            554              773         20             1                  7       0   1362    1495
//   residual                 131              204          1             1                  7       0    351     392
//   residual_jacobian        230              367          3             1                  7       0    615     739
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

namespace andrews_squeezer {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "andrews_squeezer";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe42e5ef7300a03eeULL;
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
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z214 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z227 = n0_175 * z226;
    const Scalar z255 = z41 * z41;
    const Scalar z268 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z271 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z215 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z236 = z63 * z63;
    const Scalar z244 = z52 * z52;
    const Scalar z256 = k5 * z255;  // force on K2, times 0.04 m, x
    const Scalar z262 = n0_175 * a_beta;
    const Scalar z265 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z272 = k6 * z271;  // force on K6, times 0.04 m, y
    const Scalar z279 = k6 * z268;  // force on K4, times 0.04 m, x
    const Scalar z230 = v_delta * v_delta;
    const Scalar z237 = k6 * z236;  // force on K6, times 0.04 m, x
    const Scalar z245 = k6 * z244;  // force on K4, times 0.04 m, y
    const Scalar z289 = k5 * z265;  // force on K2, times 0.04 m, y
    const Scalar z264 = s_Theta * z227 + c_Theta * z262;
    const Scalar z270 = a_epsilon * s_Omega - c_Omega * z233;
    const Scalar z302 = n0_028 * c_Theta;
    const Scalar z343 = n0_02 * s_Phi;
    const Scalar z266 = a_delta * s_Phi - c_Phi * z230;
    const Scalar z274 = s_Omega * z272 + c_Omega * z237;
    const Scalar z282 = s_Phi * z279 + c_Phi * z245;
    const Scalar z292 = s_Theta * z256 - c_Theta * z289;
    const Scalar z303 = n0_028 * s_Theta;
    const Scalar z344 = n0_02 * c_Phi;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z304 = n0_007 - z302;
    const Scalar z319 = s_beta * z302 + c_beta * z303;
    const Scalar z338 = s_beta * z303 - c_beta * z302;
    const Scalar z345 = n0_04 + z343;
    const Scalar z360 = s_delta * z343 - c_delta * z344;
    const Scalar z305 = s_beta * z303 + c_beta * z304;
    const Scalar z306 = s_beta * z304 - c_beta * z303;
    const Scalar z346 = s_delta * z344 + c_delta * z345;
    const Scalar z347 = s_delta * z345 - c_delta * z344;
    const Scalar z122 = k11 - z116;
    const Scalar z375 = s_delta * z344 + c_delta * z343;
    const Scalar z123 = k12 + z117;
    const Scalar z378 = n0_02 * c_Omega;
    const Scalar z379 = n0_02 * s_Omega;
    const Scalar z380 = n0_04 - z379;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z273 = k6 * z270 - k13 * z271;  // moment on K6, z
    const Scalar z280 = k13 * z268 + k6 * z266;  // moment on K4, z
    const Scalar z290 = k5 * z264 - k14 * z265;  // moment on K2, z
    const Scalar z212 = n0_014 + z122;
    const Scalar z381 = c_epsilon * z378 + s_epsilon * z380;
    const Scalar z213 = n0_072 - z123;
    const Scalar z382 = s_epsilon * z378 - c_epsilon * z380;
    const Scalar z395 = s_epsilon * z378 + c_epsilon * z379;
    const Scalar z410 = s_epsilon * z379 - c_epsilon * z378;
    const Scalar z285 = k17 * a_delta + z282 + z280;  // moment on K5, z
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z278 = k18 * a_epsilon - z274 - z273;  // moment on K7, z
    const Scalar z295 = n0_033 - k20 * a_beta - n0_175 * z292 + z290;  // moment on K1, z
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z220 = n1 / z219;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z223 = z216 * z221;
    const Scalar z224 = z217 * z221;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z288 = k24 * a_gamma + z225;  // moment on K3, z
    forces.beta = -z295 - z305 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z306 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    forces.Theta = -z290 - z319 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z338 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    forces.gamma = z288 + z131 * l_lambda_E3_y + z132 * l_lambda_E3_x;
    forces.Phi = z280 - z360 * l_lambda_E4_x + z375 * l_lambda_E4_y;
    forces.delta = z285 + z346 * l_lambda_E4_y - z347 * l_lambda_E4_x;
    forces.Omega = -z273 - z395 * l_lambda_E6_x - z410 * l_lambda_E6_y;
    forces.epsilon = z278 + z381 * l_lambda_E6_y - z382 * l_lambda_E6_x;
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
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
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
    const Scalar z160 = k0 * s_Omega;
    const Scalar z193 = k1 * c_Theta;
    const Scalar z302 = n0_028 * c_Theta;
    const Scalar z303 = n0_028 * s_Theta;
    const Scalar z177 = k0 * s_Phi;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z255 = z41 * z41;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z227 = n0_175 * z226;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z311 = v_beta * c_beta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z256 = k1 * z255;  // force on K2, times 0.04 m, x
    const Scalar z229 = s_Theta * z227;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z259 = s_Theta * z256;
    const Scalar z236 = z63 * z63;
    const Scalar z244 = z52 * z52;
    const Scalar z231 = c_Phi * z230;
    const Scalar z235 = c_Omega * z233;
    const Scalar z237 = k0 * z236;  // force on K6, times 0.04 m, x
    const Scalar z245 = k0 * z244;  // force on K4, times 0.04 m, y
    const Scalar z309 = v_gamma * c_gamma;
    const Scalar z214 = k7 * s_gamma + k8 * c_gamma;
    const Scalar z239 = c_Omega * z237;
    const Scalar z248 = c_Phi * z245;
    const Scalar z215 = k8 * s_gamma - k7 * c_gamma;
    const Scalar z162 = k9 - z160;
    const Scalar z170 = k9 - n2 * z160;
    const Scalar z178 = k9 + z177;
    const Scalar z186 = k9 + n2 * z177;
    const Scalar z194 = k11 - n0_175 * z193;
    const Scalar z202 = k11 - n0_35 * z193;
    const Scalar z238 = k0 * z235;  // moment on K6, z
    const Scalar z246 = k0 * z231;  // moment on K4, z
    const Scalar z257 = k1 * z229;  // moment on K2, z
    const Scalar z304 = n0_007 - z302;
    const Scalar z313 = n0_028 * z312;
    const Scalar z243 = z238 - z239;  // moment on K7, z
    const Scalar z251 = z246 - z248;  // moment on K5, z
    const Scalar z261 = n0_033 - n0_175 * z259 + z257;  // moment on K1, z
    const Scalar z305 = s_beta * z303 + c_beta * z304;
    const Scalar z306 = s_beta * z304 - c_beta * z303;
    const Scalar z122 = k15 - z116;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z123 = k16 + z117;
    const Scalar z319 = s_beta * z302 + c_beta * z303;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z324 = v_gamma * s_gamma;
    const Scalar z316 = n0_028 * z315;
    const Scalar z325 = v_gamma * z324;
    const Scalar z326 = n0_035 * z325;
    const Scalar z175 = k17 + z170;
    const Scalar z327 = v_Theta * z315;
    const Scalar z329 = v_Theta * z312;
    const Scalar z328 = n0_028 * z327;
    const Scalar z330 = n0_028 * z329;
    const Scalar z191 = k18 + z186;
    const Scalar z331 = v_beta * z314;
    const Scalar z332 = v_beta * z311;
    const Scalar z205 = k19 + z202;
    const Scalar z338 = s_beta * z303 - c_beta * z302;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z333 = z303 * z331 + z304 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z212 = n0_014 + z122;
    const Scalar z339 = v_gamma * z309;
    const Scalar z213 = n0_072 - z123;
    const Scalar z341 = z303 * z332 - z304 * z331 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z340 = n0_035 * z339;
    const Scalar z343 = n0_02 * s_Phi;
    const Scalar z344 = n0_02 * c_Phi;
    const Scalar z345 = n0_04 + z343;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z346 = s_delta * z344 + c_delta * z345;
    const Scalar z334 = z326 - z333;
    const Scalar z342 = z340 - z341;
    const Scalar z220 = n1 / z219;
    const Scalar z347 = s_delta * z345 - c_delta * z344;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z352 = v_delta * c_delta;
    const Scalar z223 = z216 * z221;
    const Scalar z353 = v_Phi * s_Phi;
    const Scalar z224 = z217 * z221;
    const Scalar z354 = n0_02 * z353;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z419 = n1 / z175;
    const Scalar z423 = n1 / z191;
    const Scalar z367 = v_Phi * z353;
    const Scalar z368 = n0_02 * z367;
    const Scalar z427 = k26 * z194;
    const Scalar z428 = z194 * z427 - z205;
    const Scalar z420 = z162 * z419;
    const Scalar z421 = k9 - z162 * z420;
    const Scalar z378 = n0_02 * c_Omega;
    const Scalar z379 = n0_02 * s_Omega;
    const Scalar z380 = n0_04 - z379;
    const Scalar z429 = n1 / z428;
    const Scalar z434 = z305 - z338 * z427;
    const Scalar z422 = n1 / z421;
    const Scalar z410 = s_epsilon * z379 - c_epsilon * z378;
    const Scalar z395 = s_epsilon * z378 + c_epsilon * z379;
    const Scalar z381 = c_epsilon * z378 + s_epsilon * z380;
    const Scalar z430 = z306 + z319 * z427;
    const Scalar z382 = s_epsilon * z378 - c_epsilon * z380;
    const Scalar z424 = z178 * z423;
    const Scalar z425 = k9 - z178 * z424;
    const Scalar z375 = s_delta * z344 + c_delta * z343;
    const Scalar z360 = s_delta * z343 - c_delta * z344;
    const Scalar z435 = z429 * z434;
    const Scalar z431 = z429 * z430;
    const Scalar z426 = n1 / z425;
    const Scalar z438 = z347 * z424 - z360;
    const Scalar z436 = k26 * z338 + z427 * z435;
    const Scalar z432 = k26 * z319 - z427 * z431;
    const Scalar z391 = v_Omega * s_Omega;
    const Scalar z355 = v_delta * s_delta;
    const Scalar z441 = z346 * z424 - z375;
    const Scalar z390 = v_epsilon * s_epsilon;
    const Scalar z400 = v_Omega * z391;
    const Scalar z392 = n0_02 * z391;
    const Scalar z401 = n0_02 * z400;
    const Scalar z437 = k27 * z131;
    const Scalar z369 = v_delta * z355;
    const Scalar z387 = v_epsilon * c_epsilon;
    const Scalar z405 = v_epsilon * z390;
    const Scalar z356 = v_Phi * c_Phi;
    const Scalar z388 = v_Omega * c_Omega;
    const Scalar z370 = v_delta * z352;
    const Scalar z442 = z426 * z441;
    const Scalar z439 = z426 * z438;
    const Scalar z404 = v_epsilon * z387;
    const Scalar z365 = v_Phi * z356;
    const Scalar z366 = n0_02 * z365;
    const Scalar z357 = n0_02 * z356;
    const Scalar z447 = z381 * z420 + z410;
    const Scalar z448 = z422 * z447;
    const Scalar z444 = z382 * z420 - z395;
    const Scalar z445 = z422 * z444;
    const Scalar z443 = z346 * z423 + z424 * z442;
    const Scalar z449 = z381 * z419 + z420 * z448;
    const Scalar z446 = z382 * z419 + z420 * z445;
    const Scalar z440 = z347 * z423 + z424 * z439;
    const Scalar z402 = v_Omega * z388;
    const Scalar z403 = n0_02 * z402;
    const Scalar z389 = n0_02 * z388;
    const Scalar z433 = k27 * z132;
    const Scalar z371 = z344 * z369 + z345 * z370 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z376 = z345 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z372 = z333 - z371;
    const Scalar z377 = z341 + z376;
    const Scalar z462 = z305 * z435 - z338 * z436 - z410 * z448 - z381 * z449;
    const Scalar z463 = n1 / z462;
    const Scalar z461 = z305 * z431 + z338 * z432 - z410 * z445 - z381 * z446;
    const Scalar z460 = z306 * z431 - z319 * z432 + z395 * z445 - z382 * z446;
    const Scalar z454 = z306 * z435 + z319 * z436;
    const Scalar z457 = z305 * z435 - z338 * z436;
    const Scalar z459 = z305 * z435 - z338 * z436 + z375 * z442 - z346 * z443;
    const Scalar z466 = z461 * z463;
    const Scalar z465 = z457 * z463;
    const Scalar z453 = z306 * z431 - z319 * z432;
    const Scalar z456 = z305 * z431 + z338 * z432;
    const Scalar z458 = z305 * z431 + z338 * z432 + z375 * z439 - z346 * z440;
    const Scalar z455 = z306 * z431 - z319 * z432 + z360 * z439 - z347 * z440;
    const Scalar z464 = z456 * z463;
    const Scalar z472 = z455 - z456 * z464;
    const Scalar z452 = z131 * z437 - z305 * z435 + z338 * z436;
    const Scalar z469 = z452 + z457 * z465;
    const Scalar z471 = z454 - z457 * z464;
    const Scalar z406 = s_epsilon * z401 - z378 * z404 - z380 * z405 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z411 = z378 * z405 - z380 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z407 = z333 + z406;
    const Scalar z412 = z341 + z411;
    const Scalar z479 = z460 - z461 * z466;
    const Scalar z478 = z454 - z457 * z466;
    const Scalar z480 = n1 / z479;
    const Scalar z476 = z457 * z465 - z459;
    const Scalar z475 = z456 * z465 - z458;
    const Scalar z474 = z457 * (n1 - z465);
    const Scalar z477 = z453 - z456 * z466;
    const Scalar z470 = z453 - z456 * z464;
    const Scalar z451 = z131 * z433 + z305 * z431 + z338 * z432;
    const Scalar z468 = z451 - z456 * z465;
    const Scalar z450 = z132 * z433 - z306 * z431 + z319 * z432;
    const Scalar z515 = z257 * z427 - z261;
    const Scalar z516 = z429 * z515;
    const Scalar z513 = z238 - z243 * z420;
    const Scalar z521 = z422 * z513;
    const Scalar z514 = z246 - z251 * z424;
    const Scalar z517 = k26 * z257 - z427 * z516;
    const Scalar z522 = z243 * z419 - z420 * z521;
    const Scalar z519 = z426 * z514;
    const Scalar z520 = z251 * z423 - z424 * z519;
    const Scalar z467 = z450 + z456 * z464;
    const Scalar z527 = z306 * z516 + z407 - z319 * z517 + z395 * z521 + z382 * z522;
    const Scalar z525 = z306 * z516 + z372 - z319 * z517 - z360 * z519 - z347 * z520;
    const Scalar z526 = z305 * z516 + z377 + z338 * z517 - z375 * z519 - z346 * z520;
    const Scalar z528 = z305 * z516 + z412 + z338 * z517 - z410 * z521 + z381 * z522;
    const Scalar z473 = z456 * (n1 - z465);
    const Scalar z518 = k27 * z225;
    const Scalar z523 = z334 - z306 * z516 + z319 * z517 + z132 * z518;
    const Scalar z524 = z305 * z516 - z342 + z338 * z517 + z131 * z518;
    const Scalar z529 = z466 * z528 - z527;
    const Scalar z482 = z478 * z480;
    const Scalar z492 = z476 + z478 * z482;
    const Scalar z491 = z475 + z477 * z482;
    const Scalar z490 = z474 - z478 * z482;
    const Scalar z485 = z469 + z478 * z482;
    const Scalar z493 = n1 / z492;
    const Scalar z484 = z468 - z477 * z482;
    const Scalar z489 = z473 - z477 * z482;
    const Scalar z530 = z465 * z528 - z526 - z482 * z529;
    const Scalar z481 = z477 * z480;
    const Scalar z487 = z471 - z478 * z481;
    const Scalar z488 = z472 - z477 * z481;
    const Scalar z486 = z470 - z477 * z481;
    const Scalar z483 = z467 + z477 * z481;
    const Scalar z494 = z489 * z493;
    const Scalar z495 = z490 * z493;
    const Scalar z496 = z491 * z493;
    const Scalar z497 = z483 - z489 * z494;
    const Scalar z498 = z484 + z489 * z495;
    const Scalar z499 = z485 - z490 * z495;
    const Scalar z500 = z486 - z489 * z496;
    const Scalar z501 = z487 - z490 * z496;
    const Scalar z502 = z488 + z491 * z496;
    const Scalar z531 = z464 * z528 - z525 - z481 * z529 - z496 * z530;
    const Scalar z503 = n1 / z502;
    const Scalar z504 = z500 * z503;
    const Scalar z505 = z501 * z503;
    const Scalar z506 = z497 + z500 * z504;
    const Scalar z507 = z498 - z500 * z505;
    const Scalar z508 = z499 + z501 * z505;
    const Scalar z532 = z465 * z528 - z524 - z482 * z529 + z495 * z530 - z505 * z531;
    const Scalar z509 = n1 / z508;
    const Scalar z510 = z507 * z509;
    const Scalar z511 = z506 - z507 * z510;
    const Scalar z533 = z464 * z528 + z523 - z481 * z529 + z494 * z530 - z504 * z531 + z510 * z532;
    const Scalar z512 = n1 / z511;
    const Scalar z534 = z512 * z533;
    const Scalar z535 = z509 * z532 + z510 * z534;
    const Scalar z536 = z503 * z531 + z504 * z534 + z505 * z535;
    const Scalar z542 = z433 * z534 - z518 - z437 * z535;
    const Scalar z537 = z493 * z530 + z494 * z534 + z495 * z535 + z496 * z536;
    const Scalar z538 = z480 * z529 + z481 * (z534 - z536) + z482 * (z535 + z537);
    const Scalar z543 = z439 * z536 - z519 - z442 * z537;
    const Scalar z544 = z520 + z440 * z536 - z443 * z537;
    const Scalar z539 = z463 * z528 - z464 * (z534 - z536) - z465 * (z535 + z537) + z466 * z538;
    const Scalar z540 = z431 * (z534 - z536 - z538) - z516 + z435 * (z535 + z537 + z539);
    const Scalar z541 = z432 * (z534 - z536 - z538) - z517 - z436 * (z535 + z537 + z539);
    const Scalar z545 = z521 + z445 * z538 - z448 * z539;
    const Scalar z546 = z446 * z538 - z522 - z449 * z539;
    accelerations.beta = -z540;
    accelerations.Theta = -z541;
    accelerations.gamma = z542;
    accelerations.Phi = -z543;
    accelerations.delta = z544;
    accelerations.Omega = -z545;
    accelerations.epsilon = z546;
    multipliers.lambda_E3_x = -z534;
    multipliers.lambda_E3_y = z535;
    multipliers.lambda_E4_x = z536;
    multipliers.lambda_E4_y = z537;
    multipliers.lambda_E6_x = z538;
    multipliers.lambda_E6_y = z539;
    if (!(traits::regular(-z428, z205) && traits::regular(z425, k9) && traits::regular(z191, z191)
        && traits::regular(z421, k9) && traits::regular(z175, z175) && traits::regular(z511, z450)
        && traits::regular(z508, z452) && traits::regular(-z502, -z455) && traits::regular(z492, -z459)
        && traits::regular(-z479, -z460) && traits::regular(-z462, -z462))) return torsor::Status::singular;
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
    const Scalar z547 = k4 * z41 - k5 * z207;
    const Scalar z548 = k6 * z41 - k4 * z207;
    const Scalar z549 = k7 * z52 + k8 * z208;
    const Scalar z550 = k9 * z52 + k7 * z208;
    const Scalar z551 = k7 * z63 - k8 * z211;
    const Scalar z552 = k9 * z63 - k7 * z211;
    const Scalar z122 = k10 - z116;
    const Scalar z123 = k11 + z117;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z222 = k14 - z219;
    result.kinetic = k15 * v_beta * v_beta + k16 * v_gamma * v_gamma + k17 * v_delta * v_delta + k18 * v_epsilon
        * v_epsilon + k19 * z206 * z206 + k20 * (z209 * z209 + z210 * z210) + n0_5 * (z41 * z548 + z52 * z550 + z63
        * z552 - z207 * z547 + z208 * z549 - z211 * z551);
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
    const Scalar k7 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k8 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
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
    const Scalar z311 = v_beta * c_beta;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z343 = n0_02 * s_Phi;
    const Scalar z355 = v_delta * s_delta;
    const Scalar z302 = n0_028 * c_Theta;
    const Scalar z303 = n0_028 * s_Theta;
    const Scalar z344 = n0_02 * c_Phi;
    const Scalar z352 = v_delta * c_delta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z353 = v_Phi * s_Phi;
    const Scalar z356 = v_Phi * c_Phi;
    const Scalar z309 = v_gamma * c_gamma;
    const Scalar z324 = v_gamma * s_gamma;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z136 = k3 - z131;
    const Scalar z137 = k4 - z132;
    const Scalar z304 = n0_007 - z302;
    const Scalar z310 = n0_035 * z309;
    const Scalar z313 = n0_028 * z312;
    const Scalar z316 = n0_028 * z315;
    const Scalar z319 = s_beta * z302 + c_beta * z303;
    const Scalar z325 = v_gamma * z324;
    const Scalar z327 = v_Theta * z315;
    const Scalar z329 = v_Theta * z312;
    const Scalar z331 = v_beta * z314;
    const Scalar z332 = v_beta * z311;
    const Scalar z335 = n0_035 * z324;
    const Scalar z338 = s_beta * z303 - c_beta * z302;
    const Scalar z339 = v_gamma * z309;
    const Scalar z345 = n0_04 + z343;
    const Scalar z354 = n0_02 * z353;
    const Scalar z357 = n0_02 * z356;
    const Scalar z360 = s_delta * z343 - c_delta * z344;
    const Scalar z365 = v_Phi * z356;
    const Scalar z367 = v_Phi * z353;
    const Scalar z369 = v_delta * z355;
    const Scalar z370 = v_delta * z352;
    const Scalar z305 = s_beta * z303 + c_beta * z304;
    const Scalar z306 = s_beta * z304 - c_beta * z303;
    const Scalar z317 = z303 * z311 + s_beta * z313 + c_beta * z316 - z304 * z314;
    const Scalar z326 = n0_035 * z325;
    const Scalar z328 = n0_028 * z327;
    const Scalar z330 = n0_028 * z329;
    const Scalar z336 = z303 * z314 + s_beta * z316 - c_beta * z313 + z304 * z311;
    const Scalar z340 = n0_035 * z339;
    const Scalar z346 = s_delta * z344 + c_delta * z345;
    const Scalar z347 = s_delta * z345 - c_delta * z344;
    const Scalar z358 = s_delta * z354 - c_delta * z357 - z344 * z352 + z345 * z355;
    const Scalar z366 = n0_02 * z365;
    const Scalar z368 = n0_02 * z367;
    const Scalar z373 = z344 * z355 + s_delta * z357 + c_delta * z354 + z345 * z352;
    const Scalar z307 = z136 + z305;
    const Scalar z375 = s_delta * z344 + c_delta * z343;
    const Scalar z348 = k7 - z346;
    const Scalar z308 = z137 - z306;
    const Scalar z350 = z305 + z348;
    const Scalar z349 = k8 - z347;
    const Scalar z378 = n0_02 * c_Omega;
    const Scalar z379 = n0_02 * s_Omega;
    const Scalar z380 = n0_04 - z379;
    const Scalar z351 = z306 + z349;
    const Scalar z333 = z303 * z331 + z304 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z341 = z303 * z332 - z304 * z331 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z318 = z310 - z317;
    const Scalar z334 = z326 - z333;
    const Scalar z337 = z335 - z336;
    const Scalar z342 = z340 - z341;
    const Scalar z359 = z317 + z358;
    const Scalar z374 = z336 - z373;
    const Scalar z391 = v_Omega * s_Omega;
    const Scalar z395 = s_epsilon * z378 + c_epsilon * z379;
    const Scalar z410 = s_epsilon * z379 - c_epsilon * z378;
    const Scalar z390 = v_epsilon * s_epsilon;
    const Scalar z400 = v_Omega * z391;
    const Scalar z401 = n0_02 * z400;
    const Scalar z392 = n0_02 * z391;
    const Scalar z387 = v_epsilon * c_epsilon;
    const Scalar z405 = v_epsilon * z390;
    const Scalar z388 = v_Omega * c_Omega;
    const Scalar z404 = v_epsilon * z387;
    const Scalar z402 = v_Omega * z388;
    const Scalar z389 = n0_02 * z388;
    const Scalar z381 = c_epsilon * z378 + s_epsilon * z380;
    const Scalar z403 = n0_02 * z402;
    const Scalar z383 = k7 - z381;
    const Scalar z382 = s_epsilon * z378 - c_epsilon * z380;
    const Scalar z384 = k8 - z382;
    const Scalar z385 = z305 + z383;
    const Scalar z371 = z344 * z369 + z345 * z370 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z376 = z345 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z393 = z378 * z390 + s_epsilon * z389 + c_epsilon * z392 - z380 * z387;
    const Scalar z406 = s_epsilon * z401 - z378 * z404 - z380 * z405 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z411 = z378 * z405 - z380 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z408 = s_epsilon * z392 - c_epsilon * z389 - z378 * z387 - z380 * z390;
    const Scalar z372 = z333 - z371;
    const Scalar z377 = z341 + z376;
    const Scalar z386 = z306 + z384;
    const Scalar z394 = z317 + z393;
    const Scalar z407 = z333 + z406;
    const Scalar z409 = z336 + z408;
    const Scalar z412 = z341 + z411;
    result.value[0] = z307;
    result.rate[0] = -z318;
    result.gamma[0] = z334;
    result.value[1] = -z308;
    result.rate[1] = -z337;
    result.gamma[1] = -z342;
    result.value[2] = z350;
    result.rate[2] = z359;
    result.gamma[2] = -z372;
    result.value[3] = z351;
    result.rate[3] = z374;
    result.gamma[3] = z377;
    result.value[4] = z385;
    result.rate[4] = z394;
    result.gamma[4] = -z407;
    result.value[5] = z386;
    result.rate[5] = z409;
    result.gamma[5] = z412;
    result.jacobian[0] = -z306;
    result.jacobian[1] = z305;
    result.jacobian[2] = -z306;
    result.jacobian[3] = z305;
    result.jacobian[4] = -z306;
    result.jacobian[5] = z305;
    result.jacobian[6] = z319;
    result.jacobian[7] = z338;
    result.jacobian[8] = z319;
    result.jacobian[9] = z338;
    result.jacobian[10] = z319;
    result.jacobian[11] = z338;
    result.jacobian[12] = -z132;
    result.jacobian[13] = -z131;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z360;
    result.jacobian[21] = -z375;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = z347;
    result.jacobian[27] = -z346;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = z395;
    result.jacobian[35] = z410;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z382;
    result.jacobian[41] = -z381;
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
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z262 = n0_175 * a_beta;
    const Scalar z265 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z227 = n0_175 * z226;
    const Scalar z255 = z41 * z41;
    const Scalar z193 = k4 * c_Theta;
    const Scalar z256 = k4 * z255;  // force on K2, times 0.04 m, x
    const Scalar z263 = s_Theta * z262 - c_Theta * z227;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z268 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z177 = k5 * s_Phi;
    const Scalar z244 = z52 * z52;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z264 = s_Theta * z227 + c_Theta * z262;
    const Scalar z279 = k5 * z268;  // force on K4, times 0.04 m, x
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z267 = a_delta * c_Phi + s_Phi * z230;
    const Scalar z271 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z245 = k5 * z244;  // force on K4, times 0.04 m, y
    const Scalar z266 = a_delta * s_Phi - c_Phi * z230;
    const Scalar z160 = k5 * s_Omega;
    const Scalar z236 = z63 * z63;
    const Scalar z237 = k5 * z236;  // force on K6, times 0.04 m, x
    const Scalar z272 = k5 * z271;  // force on K6, times 0.04 m, y
    const Scalar z269 = a_epsilon * c_Omega + s_Omega * z233;
    const Scalar z270 = a_epsilon * s_Omega - c_Omega * z233;
    const Scalar z282 = s_Phi * z279 + c_Phi * z245;
    const Scalar z281 = s_Phi * z245 - c_Phi * z279;
    const Scalar z214 = k6 * s_gamma + k7 * c_gamma;
    const Scalar z215 = k7 * s_gamma - k6 * c_gamma;
    const Scalar z274 = s_Omega * z272 + c_Omega * z237;
    const Scalar z275 = s_Omega * z237 - c_Omega * z272;
    const Scalar z162 = k8 - z160;
    const Scalar z170 = k8 - n2 * z160;
    const Scalar z178 = k8 + z177;
    const Scalar z186 = k8 + n2 * z177;
    const Scalar z194 = k10 - n0_175 * z193;
    const Scalar z202 = k10 - n0_35 * z193;
    const Scalar z122 = k12 - z116;
    const Scalar z289 = k4 * z265;  // force on K2, times 0.04 m, y
    const Scalar z123 = k13 + z117;
    const Scalar z302 = n0_028 * c_Theta;
    const Scalar z303 = n0_028 * s_Theta;
    const Scalar z291 = s_Theta * z289 + c_Theta * z256;
    const Scalar z292 = s_Theta * z256 - c_Theta * z289;
    const Scalar z175 = k15 + z170;
    const Scalar z304 = n0_007 - z302;
    const Scalar z309 = v_gamma * c_gamma;
    const Scalar z305 = s_beta * z303 + c_beta * z304;
    const Scalar z306 = s_beta * z304 - c_beta * z303;
    const Scalar z191 = k17 + z186;
    const Scalar z311 = v_beta * c_beta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z313 = n0_028 * z312;
    const Scalar z310 = n0_035 * z309;
    const Scalar z205 = k18 + z202;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z216 = n0_02 - z214;
    const Scalar z290 = k4 * z264 - k10 * z265;  // moment on K2, z
    const Scalar z280 = k8 * z268 + k5 * z266;  // moment on K4, z
    const Scalar z273 = k5 * z270 - k8 * z271;  // moment on K6, z
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z285 = k17 * a_delta + z282 + z280;  // moment on K5, z
    const Scalar z295 = n0_033 - k18 * a_beta - n0_175 * z292 + z290;  // moment on K1, z
    const Scalar z278 = k15 * a_epsilon - z274 - z273;  // moment on K7, z
    const Scalar z319 = s_beta * z302 + c_beta * z303;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z316 = n0_028 * z315;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z324 = v_gamma * s_gamma;
    const Scalar z317 = z303 * z311 + s_beta * z313 + c_beta * z316 - z304 * z314;
    const Scalar z217 = n0_018 - z215;
    const Scalar z327 = v_Theta * z315;
    const Scalar z325 = v_gamma * z324;
    const Scalar z326 = n0_035 * z325;
    const Scalar z220 = n1 / z219;
    const Scalar z328 = n0_028 * z327;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z329 = v_Theta * z312;
    const Scalar z223 = z216 * z221;
    const Scalar z330 = n0_028 * z329;
    const Scalar z224 = z217 * z221;
    const Scalar z331 = v_beta * z314;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z343 = n0_02 * s_Phi;
    const Scalar z344 = n0_02 * c_Phi;
    const Scalar z360 = s_delta * z343 - c_delta * z344;
    const Scalar z338 = s_beta * z303 - c_beta * z302;
    const Scalar z345 = n0_04 + z343;
    const Scalar z346 = s_delta * z344 + c_delta * z345;
    const Scalar z347 = s_delta * z345 - c_delta * z344;
    const Scalar z353 = v_Phi * s_Phi;
    const Scalar z332 = v_beta * z311;
    const Scalar z354 = n0_02 * z353;
    const Scalar z355 = v_delta * s_delta;
    const Scalar z356 = v_Phi * c_Phi;
    const Scalar z357 = n0_02 * z356;
    const Scalar z352 = v_delta * c_delta;
    const Scalar z336 = z303 * z314 + s_beta * z316 - c_beta * z313 + z304 * z311;
    const Scalar z369 = v_delta * z355;
    const Scalar z335 = n0_035 * z324;
    const Scalar z370 = v_delta * z352;
    const Scalar z365 = v_Phi * z356;
    const Scalar z366 = n0_02 * z365;
    const Scalar z367 = v_Phi * z353;
    const Scalar z368 = n0_02 * z367;
    const Scalar z358 = s_delta * z354 - c_delta * z357 - z344 * z352 + z345 * z355;
    const Scalar z333 = z303 * z331 + z304 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z341 = z303 * z332 - z304 * z331 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z288 = k26 * a_gamma + z225;  // moment on K3, z
    const Scalar z378 = n0_02 * c_Omega;
    const Scalar z379 = n0_02 * s_Omega;
    const Scalar z395 = s_epsilon * z378 + c_epsilon * z379;
    const Scalar z375 = s_delta * z344 + c_delta * z343;
    const Scalar z380 = n0_04 - z379;
    const Scalar z410 = s_epsilon * z379 - c_epsilon * z378;
    const Scalar z381 = c_epsilon * z378 + s_epsilon * z380;
    const Scalar z382 = s_epsilon * z378 - c_epsilon * z380;
    const Scalar z391 = v_Omega * s_Omega;
    const Scalar z388 = v_Omega * c_Omega;
    const Scalar z390 = v_epsilon * s_epsilon;
    const Scalar z392 = n0_02 * z391;
    const Scalar z389 = n0_02 * z388;
    const Scalar z387 = v_epsilon * c_epsilon;
    const Scalar z400 = v_Omega * z391;
    const Scalar z401 = n0_02 * z400;
    const Scalar z405 = v_epsilon * z390;
    const Scalar z373 = z344 * z355 + s_delta * z357 + c_delta * z354 + z345 * z352;
    const Scalar z404 = v_epsilon * z387;
    const Scalar z402 = v_Omega * z388;
    const Scalar z403 = n0_02 * z402;
    const Scalar z393 = z378 * z390 + s_epsilon * z389 + c_epsilon * z392 - z380 * z387;
    const Scalar z408 = s_epsilon * z392 - c_epsilon * z389 - z378 * z387 - z380 * z390;
    const Scalar z339 = v_gamma * z309;
    const Scalar z340 = n0_035 * z339;
    const Scalar z371 = z344 * z369 + z345 * z370 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z376 = z345 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z406 = s_epsilon * z401 - z378 * z404 - z380 * z405 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z411 = z378 * z405 - z380 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z334 = z326 - z333;
    const Scalar z602 = n2 * z41;
    const Scalar z603 = k4 * z602;
    const Scalar z342 = z340 - z341;
    const Scalar z613 = n2 * (z116 * z213 - z117 * z212);
    const Scalar z609 = k4 * z263;
    const Scalar z614 = n0_5 * z613 / z219;
    const Scalar z610 = n0_175 * z291 + z609;
    const Scalar z621 = k5 * z267;
    const Scalar z604 = s_Theta * z603;
    const Scalar z623 = n2 * z52;
    const Scalar z612 = z319 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z609 - z338 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z611 = z319 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z610 - z338 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z624 = k5 * z623;
    const Scalar z626 = z281 - z621;
    const Scalar z622 = z360 * l_lambda_E4_y - z621 + z375 * l_lambda_E4_x;
    const Scalar z625 = c_Phi * z624;
    const Scalar z627 = z626 + z360 * l_lambda_E4_y + z375 * l_lambda_E4_x;
    const Scalar z615 = z614 / (z219 * z219);
    const Scalar z598 = n2 * v_beta;
    const Scalar z599 = n0_175 * z598;
    const Scalar z606 = z305 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z306 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z600 = s_Theta * z599;
    const Scalar z608 = n0_175 * z604;
    const Scalar z607 = z319 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z338 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z601 = k4 * z600;
    const Scalar z605 = z601 - n0_175 * z604;
    const Scalar z616 = n352_6605 * z615;
    const Scalar z372 = z333 - z371;
    const Scalar z628 = n2 * v_delta;
    const Scalar z629 = c_Phi * z628;
    const Scalar z631 = z360 * l_lambda_E4_y + z375 * l_lambda_E4_x;
    const Scalar z617 = z215 * z221 - z216 * z616;
    const Scalar z618 = z214 * z221 + z217 * z616;
    const Scalar z630 = k5 * z629;
    const Scalar z619 = n0_018 * z617 + n0_02 * z618;
    const Scalar z377 = z341 + z376;
    const Scalar z649 = a_beta * z306 - a_Theta * z319 + a_gamma * z132 - z334;
    const Scalar z650 = a_beta * z305 + a_Theta * z338 - a_gamma * z131 - z342;
    const Scalar z634 = k5 * z269;
    const Scalar z636 = n2 * z63;
    const Scalar z648 = a_beta * z306 - a_Theta * z319 - a_delta * z347 - a_Phi * z360 + z372;
    const Scalar z652 = a_beta * z305 + a_Theta * z338 - a_delta * z346 - a_Phi * z375 + z377;
    const Scalar z639 = z275 - z634;
    const Scalar z635 = z634 + z395 * l_lambda_E6_y - z410 * l_lambda_E6_x;
    const Scalar z637 = k5 * z636;
    const Scalar z638 = c_Omega * z637;
    const Scalar z640 = z395 * l_lambda_E6_y - z639 - z410 * l_lambda_E6_x;
    const Scalar z620 = z131 * l_lambda_E3_x - z619 - z132 * l_lambda_E3_y;
    const Scalar z641 = n2 * v_epsilon;
    const Scalar z642 = c_Omega * z641;
    const Scalar z644 = z395 * l_lambda_E6_y - z410 * l_lambda_E6_x;
    const Scalar z407 = z333 + z406;
    const Scalar z647 = a_beta * z306 - a_Theta * z319 - a_epsilon * z382 - a_Omega * z395 + z407;
    const Scalar z643 = k5 * z642;
    const Scalar z653 = v_beta * s_beta + z314;
    const Scalar z654 = v_beta * c_beta + z311;
    const Scalar z656 = z341 + a_beta * z305 + a_Theta * z338;
    const Scalar z412 = z341 + z411;
    const Scalar z660 = v_Theta * s_Theta + z315;
    const Scalar z661 = n0_028 * z660;
    const Scalar z662 = v_Theta * c_Theta + z312;
    const Scalar z663 = n0_028 * z662;
    const Scalar z658 = z333 + a_beta * z306 - a_Theta * z319;
    const Scalar z671 = v_gamma * s_gamma + z324;
    const Scalar z674 = v_gamma * c_gamma + z309;
    const Scalar z678 = v_Phi * c_Phi + z356;
    const Scalar z680 = v_Phi * s_Phi + z353;
    const Scalar z672 = n0_035 * z671;
    const Scalar z673 = a_gamma * z131 + z340;
    const Scalar z675 = n0_035 * z674;
    const Scalar z676 = a_gamma * z132 - z326;
    const Scalar z679 = n0_02 * z678;
    const Scalar z681 = n0_02 * z680;
    const Scalar z651 = a_beta * z305 + a_Theta * z338 - a_epsilon * z381 + a_Omega * z410 + z412;
    const Scalar z659 = z303 * z314 - z302 * z311 + s_beta * z316 - c_beta * z313;
    const Scalar z667 = z302 * z314 + z303 * z311 + s_beta * z313 + c_beta * z316;
    const Scalar z677 = z343 * z352 + z344 * z355 + s_delta * z357 + c_delta * z354;
    const Scalar z685 = z343 * z355 - z344 * z352 + s_delta * z354 - c_delta * z357;
    const Scalar z665 = z302 * z331 + z303 * z332 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z669 = z303 * z331 - z302 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z666 = z338 * (a_beta + a_Theta) + z665;
    const Scalar z670 = z319 * (a_beta + a_Theta) - z669;
    const Scalar z689 = v_delta * s_delta + z355;
    const Scalar z664 = s_beta * z661 - n2 * (z302 * z311 - z303 * z314) - c_beta * z663;
    const Scalar z668 = n2 * (z302 * z314 + z303 * z311) + s_beta * z663 + c_beta * z661;
    const Scalar z690 = v_delta * c_delta + z352;
    const Scalar z655 = z303 * z653 + z304 * z654 + n2 * (s_beta * z316 - c_beta * z313);
    const Scalar z657 = z303 * z654 - z304 * z653 + n2 * (s_beta * z313 + c_beta * z316);
    const Scalar z683 = z343 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z687 = z343 * z370 + z344 * z369 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z684 = z375 * (a_delta + a_Phi) - z683;
    const Scalar z688 = z360 * (a_delta + a_Phi) + z687;
    const Scalar z691 = z344 * z689 + z345 * z690 + n2 * (s_delta * z357 + c_delta * z354);
    const Scalar z682 = n2 * (z343 * z352 + z344 * z355) + s_delta * z679 + c_delta * z681;
    const Scalar z686 = n2 * (z343 * z355 - z344 * z352) + s_delta * z681 - c_delta * z679;
    const Scalar z632 = z625 - z630;
    const Scalar z692 = a_delta * z346 - z376 + a_Phi * z375;
    const Scalar z633 = z346 * l_lambda_E4_x + z347 * l_lambda_E4_y;
    const Scalar z693 = z345 * z689 - z344 * z690 + n2 * (s_delta * z354 - c_delta * z357);
    const Scalar z696 = v_Omega * s_Omega + z391;
    const Scalar z697 = n0_02 * z696;
    const Scalar z698 = v_Omega * c_Omega + z388;
    const Scalar z694 = z371 + a_Phi * z360 + a_delta * z347;
    const Scalar z699 = n0_02 * z698;
    const Scalar z695 = z379 * z390 - z378 * z387 + s_epsilon * z392 - c_epsilon * z389;
    const Scalar z703 = z378 * z390 + z379 * z387 + s_epsilon * z389 + c_epsilon * z392;
    const Scalar z701 = z378 * z405 + z379 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z702 = z410 * (a_epsilon + a_Omega) + z701;
    const Scalar z700 = s_epsilon * z697 - n2 * (z378 * z387 - z379 * z390) - c_epsilon * z699;
    const Scalar z704 = n2 * (z378 * z390 + z379 * z387) + s_epsilon * z699 + c_epsilon * z697;
    const Scalar z646 = z381 * l_lambda_E6_x + z382 * l_lambda_E6_y;
    const Scalar z645 = z638 - z643;
    const Scalar z705 = z379 * z405 - z378 * z404 + s_epsilon * z401 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z708 = v_epsilon * s_epsilon + z390;
    const Scalar z707 = v_epsilon * c_epsilon + z387;
    const Scalar z710 = a_epsilon * z381 - z411 - a_Omega * z410;
    const Scalar z712 = a_epsilon * z382 - z406 + a_Omega * z395;
    const Scalar z706 = z395 * (a_epsilon + a_Omega) - z705;
    const Scalar z729 = z395 * z395;
    const Scalar z732 = z360 * z360;
    const Scalar z735 = z132 * z132;
    const Scalar z721 = n1 / z132;
    const Scalar z722 = z131 * z721;
    const Scalar z717 = n1 / z360;
    const Scalar z718 = z375 * z717;
    const Scalar z713 = n1 / z395;
    const Scalar z714 = z410 * z713;
    const Scalar z709 = n2 * (s_epsilon * z392 - c_epsilon * z389) - z378 * z707 - z380 * z708;
    const Scalar z711 = z378 * z708 - z380 * z707 + n2 * (s_epsilon * z389 + c_epsilon * z392);
    const Scalar z723 = z319 * z722 - z338;
    const Scalar z738 = z723 * z723;
    const Scalar z724 = n1 / z723;
    const Scalar z720 = z346 - z347 * z718;
    const Scalar z744 = z720 * z720;
    const Scalar z728 = n1 / z720;
    const Scalar z716 = z381 + z382 * z714;
    const Scalar z741 = z716 * z716;
    const Scalar z727 = n1 / z716;
    const Scalar z719 = z319 * z718 + z338;
    const Scalar z747 = z305 + z306 * z722;
    const Scalar z715 = z319 * z714 - z338;
    const Scalar z730 = z382 * z382 / z175 + k28 * z319 * z319 + k29 * z395 * z395 + z306 * z306 / z205;
    const Scalar z731 = k8 * z730;
    const Scalar z726 = z719 * z724;
    const Scalar z725 = z715 * z724;
    const Scalar z752 = z724 * z747;
    const Scalar z733 = z347 * z347 / z191 + z306 * z306 / z205 + k28 * z319 * z319 + k29 * z360 * z360;
    const Scalar z734 = k8 * z733;
    const Scalar z749 = z305 - z306 * z718 + z726 * z747;
    const Scalar z750 = z728 * z749;
    const Scalar z748 = z305 + z306 * z714 - z725 * z747;
    const Scalar z751 = z727 * z748;
    const Scalar z753 = z306 - z319 * z752;
    const Scalar z754 = z721 * z753;
    const Scalar z755 = z306 - z319 * z752 - z347 * z750;
    const Scalar z757 = z306 - z319 * z752 - z382 * z751;
    const Scalar z759 = z336 + z659 * z752 + z335 * z754;
    const Scalar z760 = z317 + z667 * z752 + z310 * z754;
    const Scalar z756 = z717 * z755;
    const Scalar z761 = z336 + z659 * z752 - z373 * z750 - z677 * z756;
    const Scalar z762 = z317 + z667 * z752 + z358 * z750 + z685 * z756;
    const Scalar z765 = z722 * z759 + z760;
    const Scalar z758 = z713 * z757;
    const Scalar z763 = z336 + z659 * z752 + z408 * z751 + z695 * z758;
    const Scalar z764 = z317 + z667 * z752 + z393 * z751 + z703 * z758;
    const Scalar z767 = z718 * z761 - z762 - z726 * z765;
    const Scalar z768 = z728 * z767;
    const Scalar z766 = z764 + z714 * z763 - z725 * z765;
    const Scalar z770 = z724 * z765;
    const Scalar z771 = z319 * z770 - z759;
    const Scalar z773 = z319 * z770 - z761 - z347 * z768;
    const Scalar z769 = z727 * z766;
    const Scalar z777 = z655 + z664 * z752 + z672 * z754;
    const Scalar z772 = z721 * z771;
    const Scalar z775 = z319 * z770 - z763 + z382 * z769;
    const Scalar z795 = z664 * z770 - z672 * z772;
    const Scalar z774 = z717 * z773;
    const Scalar z776 = z713 * z775;
    const Scalar z778 = z657 + z668 * z752 + z675 * z754;
    const Scalar z783 = z722 * z777 + z778;
    const Scalar z779 = z655 + z664 * z752 - z691 * z750 - z682 * z756;
    const Scalar z781 = z655 + z664 * z752 + z709 * z751 + z700 * z758;
    const Scalar z788 = z724 * z783;
    const Scalar z789 = z319 * z788 - z777;
    const Scalar z780 = z657 + z668 * z752 + z693 * z750 + z686 * z756;
    const Scalar z782 = z657 + z668 * z752 + z711 * z751 + z704 * z758;
    const Scalar z790 = z721 * z789;
    const Scalar z785 = z718 * z779 - z780 - z726 * z783;
    const Scalar z784 = z782 + z714 * z781 - z725 * z783;
    const Scalar z736 = k30 * z132 * z132 + z306 * z306 / z205 + k28 * z319 * z319;
    const Scalar z796 = z668 * z770 - z675 * z772;
    const Scalar z737 = k26 * z736;
    const Scalar z797 = z664 * z770 + z691 * z768 + z682 * z774;
    const Scalar z798 = z668 * z770 - z693 * z768 - z686 * z774;
    const Scalar z786 = z728 * z785;
    const Scalar z787 = z727 * z784;
    const Scalar z791 = z319 * z788 - z779 - z347 * z786;
    const Scalar z793 = z319 * z788 - z781 + z382 * z787;
    const Scalar z792 = z717 * z791;
    const Scalar z794 = z713 * z793;
    const Scalar z739 = k30 * z131 * z131 + z305 * z305 / z205 + k28 * z338 * z338;
    const Scalar z799 = z664 * z770 + z709 * z769 - z700 * z776;
    const Scalar z740 = k10 * z739;
    const Scalar z800 = z668 * z770 + z711 * z769 - z704 * z776;
    const Scalar z801 = z656 + z666 * z752 + z673 * z754;
    const Scalar z742 = z381 * z381 / z175 + z305 * z305 / z205 + k28 * z338 * z338 + k29 * z410 * z410;
    const Scalar z743 = z175 * z742;
    const Scalar z803 = z656 + z666 * z752 - z692 * z750 - z684 * z756;
    const Scalar z804 = z658 - z670 * z752 - z694 * z750 - z688 * z756;
    const Scalar z802 = z658 - z670 * z752 - z676 * z754;
    const Scalar z745 = z346 * z346 / z191 + z305 * z305 / z205 + k28 * z338 * z338 + k29 * z375 * z375;
    const Scalar z805 = z656 + z666 * z752 - z710 * z751 + z702 * z758;
    const Scalar z746 = z191 * z745;
    const Scalar z806 = z658 - z670 * z752 - z712 * z751 - z706 * z758;
    const Scalar z807 = z795 + z801;
    const Scalar z808 = z796 - z802;
    const Scalar z809 = z797 + z803;
    const Scalar z810 = z798 - z804;
    const Scalar z859 = z606 - z611 * z752;
    const Scalar z860 = z607 + z612 * z752;
    const Scalar z811 = z799 + z805;
    const Scalar z812 = z800 - z806;
    const Scalar z862 = z631 * z750 + z622 * z756;
    const Scalar z864 = z644 * z751 + z635 * z758;
    const Scalar z863 = z633 * z750 + z627 * z756;
    const Scalar z865 = z646 * z751 + z640 * z758;
    const Scalar z837 = z194 * z752 + z205;
    const Scalar z838 = z194 + k10 * z752;
    const Scalar z813 = z722 * z807 + z808;
    const Scalar z825 = z649 * z722 + z650;
    const Scalar z873 = z290 + z319 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z338 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z854 = z608 * z770;
    const Scalar z866 = z854 + z859;
    const Scalar z846 = z605 - z608 * z752;
    const Scalar z841 = z191 * z750 + z178 * z756;
    const Scalar z843 = z175 * z751 + z162 * z758;
    const Scalar z815 = z718 * z809 - z810 - z726 * z813;
    const Scalar z827 = z648 * z718 - z652 - z726 * z825;
    const Scalar z840 = z178 * z750 + k8 * z756;
    const Scalar z816 = z728 * z815;
    const Scalar z828 = z728 * z827;
    const Scalar z814 = z812 + z714 * z811 - z725 * z813;
    const Scalar z826 = z647 * z714 + z651 - z725 * z825;
    const Scalar z875 = z280 - z360 * l_lambda_E4_x + z375 * l_lambda_E4_y;
    const Scalar z874 = z288 + z131 * l_lambda_E3_y + z132 * l_lambda_E3_x;
    const Scalar z876 = z285 + z346 * l_lambda_E4_y - z347 * l_lambda_E4_x;
    const Scalar z818 = z724 * z813;
    const Scalar z830 = z724 * z825;
    const Scalar z819 = z319 * z818 - z807;
    const Scalar z831 = z319 * z830 - z649;
    const Scalar z856 = z632 * z768 + z625 * z774;
    const Scalar z868 = z856 + z863;
    const Scalar z848 = z632 * z750 + z625 * z756;
    const Scalar z820 = z721 * z819;
    const Scalar z832 = z721 * z831;
    const Scalar z855 = z630 * z768;
    const Scalar z867 = z855 - z862;
    const Scalar z847 = z630 * z750;
    const Scalar z842 = z162 * z751 + k8 * z758;
    const Scalar z817 = z727 * z814;
    const Scalar z877 = z273 + z395 * l_lambda_E6_x + z410 * l_lambda_E6_y;
    const Scalar z878 = z278 + z381 * l_lambda_E6_y - z382 * l_lambda_E6_x;
    const Scalar z879 = z295 + z305 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z306 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x) + z752 * z873 - z750 * z876 - z751 * z878 - z756 * z875 + z758 * z877 + z754
        * z874;
    const Scalar z829 = z727 * z826;
    const Scalar z821 = z319 * z818 - z809 - z347 * z816;
    const Scalar z833 = z319 * z830 - z648 - z347 * z828;
    const Scalar z858 = z638 * z776 - z645 * z769;
    const Scalar z870 = z858 - z865;
    const Scalar z850 = z645 * z751 + z638 * z758;
    const Scalar z857 = z643 * z769;
    const Scalar z869 = z857 - z864;
    const Scalar z849 = z643 * z751;
    const Scalar z851 = z601 * z752 + z846 + z756 * z847 - z758 * z849 - z750 * z848 + z751 * z850;
    const Scalar z822 = z717 * z821;
    const Scalar z834 = z717 * z833;
    const Scalar z823 = z319 * z818 - z811 + z382 * z817;
    const Scalar z835 = z319 * z830 - z647 + z382 * z829;
    const Scalar z824 = z713 * z823;
    const Scalar z836 = z713 * z835;
    const Scalar z861 = z620 * z754;
    const Scalar z871 = z752 * z860 - z866 - z756 * z867 - z758 * z869 + z750 * z868 - z751 * z870 + z754 * z861;
    const Scalar z839 = k26 * z754;
    const Scalar z844 = z752 * z838 + z837 + z754 * z839 + z750 * z841 + z751 * z843 + z756 * z840 + z758 * z842;
    const Scalar z845 = z790 * z839 - z788 * z838 + z786 * z841 - z787 * z843 + z792 * z840 + z794 * z842;
    const Scalar z853 = z820 * z839 - z818 * z838 + z816 * z841 - z817 * z843 + z822 * z840 + z824 * z842;
    const Scalar z880 = z832 * z839 - z830 * z838 + z828 * z841 - z829 * z843 + z834 * z840 + z836 * z842;
    const Scalar z882 = n1 / z844;
    const Scalar z852 = z845 + z851;
    const Scalar z872 = z853 + z871;
    const Scalar z881 = z879 + z880;
    const Scalar z883 = z872 * z882;
    const Scalar z884 = z852 * z882;
    result.M[0] = z205;
    result.M[1] = z194;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = z194;
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
    result.M[25] = z178;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = n0;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = z178;
    result.M[32] = z191;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n0;
    result.M[36] = n0;
    result.M[37] = n0;
    result.M[38] = n0;
    result.M[39] = n0;
    result.M[40] = k8;
    result.M[41] = z162;
    result.M[42] = n0;
    result.M[43] = n0;
    result.M[44] = n0;
    result.M[45] = n0;
    result.M[46] = n0;
    result.M[47] = z162;
    result.M[48] = z175;
    result.C[0] = -z605;
    result.C[1] = -z601;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z608;
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
    result.C[25] = z625;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z630;
    result.C[32] = z632;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z638;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z643;
    result.C[48] = -z645;
    result.K[0] = z606;
    result.K[1] = -z607;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z611;
    result.K[8] = -z612;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z620;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z622;
    result.K[25] = -z627;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z631;
    result.K[32] = -z633;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = -z635;
    result.K[41] = -z640;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = -z644;
    result.K[48] = -z646;
    result.F[0] = z295 + z305 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z306 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    result.F[1] = z290 + z319 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z338 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    result.F[2] = -z288 - z131 * l_lambda_E3_y - z132 * l_lambda_E3_x;
    result.F[3] = -z280 + z360 * l_lambda_E4_x - z375 * l_lambda_E4_y;
    result.F[4] = -z285 - z346 * l_lambda_E4_y + z347 * l_lambda_E4_x;
    result.F[5] = z273 + z395 * l_lambda_E6_x + z410 * l_lambda_E6_y;
    result.F[6] = -z278 - z381 * l_lambda_E6_y + z382 * l_lambda_E6_x;
    result.M_r[0] = z844;
    result.C_r[0] = -z852;
    result.K_r[0] = -z872;
    result.F_r[0] = z881;
    result.A[0] = n0;
    result.A[1] = z883;
    result.A[2] = n1;
    result.A[3] = z884;
    if (!(traits::regular(z729, z731) && traits::regular(z732, z734) && traits::regular(z735, z737)
        && traits::regular(z738, z740) && traits::regular(z741, z743) && traits::regular(z744, z746)
        && traits::regular(z844, z844))) return torsor::Status::singular;
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k17 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k18 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k20 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
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
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z302 = n0_028 * c_Theta;
    const Scalar z311 = v_beta * c_beta;
    const Scalar z303 = n0_028 * s_Theta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z214 = k3 * s_gamma + k4 * c_gamma;
    const Scalar z227 = n0_175 * z226;
    const Scalar z255 = z41 * z41;
    const Scalar z268 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z271 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z215 = k4 * s_gamma - k3 * c_gamma;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z236 = z63 * z63;
    const Scalar z244 = z52 * z52;
    const Scalar z256 = k6 * z255;  // force on K2, times 0.04 m, x
    const Scalar z262 = n0_175 * a_beta;
    const Scalar z265 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z272 = k7 * z271;  // force on K6, times 0.04 m, y
    const Scalar z264 = s_Theta * z227 + c_Theta * z262;
    const Scalar z279 = k7 * z268;  // force on K4, times 0.04 m, x
    const Scalar z237 = k7 * z236;  // force on K6, times 0.04 m, x
    const Scalar z274 = s_Omega * z272 + c_Omega * z237;
    const Scalar z309 = v_gamma * c_gamma;
    const Scalar z245 = k7 * z244;  // force on K4, times 0.04 m, y
    const Scalar z282 = s_Phi * z279 + c_Phi * z245;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z270 = a_epsilon * s_Omega - c_Omega * z233;
    const Scalar z266 = a_delta * s_Phi - c_Phi * z230;
    const Scalar z289 = k6 * z265;  // force on K2, times 0.04 m, y
    const Scalar z292 = s_Theta * z256 - c_Theta * z289;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z304 = n0_007 - z302;
    const Scalar z313 = n0_028 * z312;
    const Scalar z316 = n0_028 * z315;
    const Scalar z319 = s_beta * z302 + c_beta * z303;
    const Scalar z305 = s_beta * z303 + c_beta * z304;
    const Scalar z306 = s_beta * z304 - c_beta * z303;
    const Scalar z122 = k10 - z116;
    const Scalar z324 = v_gamma * s_gamma;
    const Scalar z123 = k11 + z117;
    const Scalar z327 = v_Theta * z315;
    const Scalar z325 = v_gamma * z324;
    const Scalar z326 = n0_035 * z325;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z273 = k7 * z270 - k12 * z271;  // moment on K6, z
    const Scalar z280 = k12 * z268 + k7 * z266;  // moment on K4, z
    const Scalar z290 = k6 * z264 - k13 * z265;  // moment on K2, z
    const Scalar z212 = n0_014 + z122;
    const Scalar z328 = n0_028 * z327;
    const Scalar z213 = n0_072 - z123;
    const Scalar z329 = v_Theta * z312;
    const Scalar z331 = v_beta * z314;
    const Scalar z332 = v_beta * z311;
    const Scalar z330 = n0_028 * z329;
    const Scalar z333 = z303 * z331 + z304 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z285 = k17 * a_delta + z282 + z280;  // moment on K5, z
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z278 = k18 * a_epsilon - z274 - z273;  // moment on K7, z
    const Scalar z295 = n0_033 - k20 * a_beta - n0_175 * z292 + z290;  // moment on K1, z
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z338 = s_beta * z303 - c_beta * z302;
    const Scalar z334 = z326 - z333;
    const Scalar z220 = n1 / z219;
    const Scalar z339 = v_gamma * z309;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z340 = n0_035 * z339;
    const Scalar z223 = z216 * z221;
    const Scalar z341 = z303 * z332 - z304 * z331 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z224 = z217 * z221;
    const Scalar z342 = z340 - z341;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z343 = n0_02 * s_Phi;
    const Scalar z355 = v_delta * s_delta;
    const Scalar z344 = n0_02 * c_Phi;
    const Scalar z345 = n0_04 + z343;
    const Scalar z352 = v_delta * c_delta;
    const Scalar z369 = v_delta * z355;
    const Scalar z378 = n0_02 * c_Omega;
    const Scalar z379 = n0_02 * s_Omega;
    const Scalar z353 = v_Phi * s_Phi;
    const Scalar z356 = v_Phi * c_Phi;
    const Scalar z370 = v_delta * z352;
    const Scalar z380 = n0_04 - z379;
    const Scalar z365 = v_Phi * z356;
    const Scalar z357 = n0_02 * z356;
    const Scalar z367 = v_Phi * z353;
    const Scalar z368 = n0_02 * z367;
    const Scalar z366 = n0_02 * z365;
    const Scalar z354 = n0_02 * z353;
    const Scalar z346 = s_delta * z344 + c_delta * z345;
    const Scalar z347 = s_delta * z345 - c_delta * z344;
    const Scalar z360 = s_delta * z343 - c_delta * z344;
    const Scalar z375 = s_delta * z344 + c_delta * z343;
    const Scalar z371 = z344 * z369 + z345 * z370 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z376 = z345 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z372 = z333 - z371;
    const Scalar z377 = z341 + z376;
    const Scalar z288 = k25 * a_gamma + z225;  // moment on K3, z
    const Scalar z391 = v_Omega * s_Omega;
    const Scalar z648 = a_beta * z306 - a_Theta * z319 - a_delta * z347 - a_Phi * z360 + z372;
    const Scalar z390 = v_epsilon * s_epsilon;
    const Scalar z400 = v_Omega * z391;
    const Scalar z387 = v_epsilon * c_epsilon;
    const Scalar z652 = a_beta * z305 + a_Theta * z338 - a_delta * z346 - a_Phi * z375 + z377;
    const Scalar z401 = n0_02 * z400;
    const Scalar z405 = v_epsilon * z390;
    const Scalar z388 = v_Omega * c_Omega;
    const Scalar z404 = v_epsilon * z387;
    const Scalar z649 = a_beta * z306 - a_Theta * z319 + a_gamma * z132 - z334;
    const Scalar z402 = v_Omega * z388;
    const Scalar z403 = n0_02 * z402;
    const Scalar z389 = n0_02 * z388;
    const Scalar z392 = n0_02 * z391;
    const Scalar z381 = c_epsilon * z378 + s_epsilon * z380;
    const Scalar z650 = a_beta * z305 + a_Theta * z338 - a_gamma * z131 - z342;
    const Scalar z382 = s_epsilon * z378 - c_epsilon * z380;
    const Scalar z395 = s_epsilon * z378 + c_epsilon * z379;
    const Scalar z410 = s_epsilon * z379 - c_epsilon * z378;
    const Scalar z406 = s_epsilon * z401 - z378 * z404 - z380 * z405 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z411 = z378 * z405 - z380 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z407 = z333 + z406;
    const Scalar z412 = z341 + z411;
    const Scalar z647 = a_beta * z306 - a_Theta * z319 - a_epsilon * z382 - a_Omega * z395 + z407;
    const Scalar z651 = a_beta * z305 + a_Theta * z338 - a_epsilon * z381 + a_Omega * z410 + z412;
    residual[0] = -z295 - z305 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z306 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    residual[1] = -z290 - z319 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z338 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    residual[2] = z288 + z131 * l_lambda_E3_y + z132 * l_lambda_E3_x;
    residual[3] = z280 - z360 * l_lambda_E4_x + z375 * l_lambda_E4_y;
    residual[4] = z285 + z346 * l_lambda_E4_y - z347 * l_lambda_E4_x;
    residual[5] = -z273 - z395 * l_lambda_E6_x - z410 * l_lambda_E6_y;
    residual[6] = z278 + z381 * l_lambda_E6_y - z382 * l_lambda_E6_x;
    residual[7] = -z649;
    residual[8] = z650;
    residual[9] = -z648;
    residual[10] = z652;
    residual[11] = -z647;
    residual[12] = z651;
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
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
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
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z302 = n0_028 * c_Theta;
    const Scalar z303 = n0_028 * s_Theta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z311 = v_beta * c_beta;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z214 = k3 * s_gamma + k4 * c_gamma;
    const Scalar z215 = k4 * s_gamma - k3 * c_gamma;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z262 = n0_175 * a_beta;
    const Scalar z265 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z236 = z63 * z63;
    const Scalar z244 = z52 * z52;
    const Scalar z227 = n0_175 * z226;
    const Scalar z255 = z41 * z41;
    const Scalar z289 = k6 * z265;  // force on K2, times 0.04 m, y
    const Scalar z230 = v_delta * v_delta;
    const Scalar z263 = s_Theta * z262 - c_Theta * z227;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z237 = k7 * z236;  // force on K6, times 0.04 m, x
    const Scalar z245 = k7 * z244;  // force on K4, times 0.04 m, y
    const Scalar z256 = k6 * z255;  // force on K2, times 0.04 m, x
    const Scalar z291 = s_Theta * z289 + c_Theta * z256;
    const Scalar z268 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z279 = k7 * z268;  // force on K4, times 0.04 m, x
    const Scalar z267 = a_delta * c_Phi + s_Phi * z230;
    const Scalar z269 = a_epsilon * c_Omega + s_Omega * z233;
    const Scalar z281 = s_Phi * z245 - c_Phi * z279;
    const Scalar z271 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z272 = k7 * z271;  // force on K6, times 0.04 m, y
    const Scalar z309 = v_gamma * c_gamma;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z160 = k7 * s_Omega;
    const Scalar z177 = k7 * s_Phi;
    const Scalar z193 = k6 * c_Theta;
    const Scalar z275 = s_Omega * z237 - c_Omega * z272;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z162 = k9 - z160;
    const Scalar z170 = k9 - n2 * z160;
    const Scalar z178 = k9 + z177;
    const Scalar z186 = k9 + n2 * z177;
    const Scalar z194 = k11 - n0_175 * z193;
    const Scalar z202 = k11 - n0_35 * z193;
    const Scalar z304 = n0_007 - z302;
    const Scalar z313 = n0_028 * z312;
    const Scalar z305 = s_beta * z303 + c_beta * z304;
    const Scalar z306 = s_beta * z304 - c_beta * z303;
    const Scalar z122 = k14 - z116;
    const Scalar z316 = n0_028 * z315;
    const Scalar z123 = k15 + z117;
    const Scalar z327 = v_Theta * z315;
    const Scalar z324 = v_gamma * s_gamma;
    const Scalar z319 = s_beta * z302 + c_beta * z303;
    const Scalar z325 = v_gamma * z324;
    const Scalar z326 = n0_035 * z325;
    const Scalar z328 = n0_028 * z327;
    const Scalar z175 = k16 + z170;
    const Scalar z331 = v_beta * z314;
    const Scalar z332 = v_beta * z311;
    const Scalar z329 = v_Theta * z312;
    const Scalar z330 = n0_028 * z329;
    const Scalar z191 = k17 + z186;
    const Scalar z339 = v_gamma * z309;
    const Scalar z338 = s_beta * z303 - c_beta * z302;
    const Scalar z340 = n0_035 * z339;
    const Scalar z205 = k18 + z202;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z333 = z303 * z331 + z304 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z343 = n0_02 * s_Phi;
    const Scalar z344 = n0_02 * c_Phi;
    const Scalar z345 = n0_04 + z343;
    const Scalar z352 = v_delta * c_delta;
    const Scalar z353 = v_Phi * s_Phi;
    const Scalar z341 = z303 * z332 - z304 * z331 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z354 = n0_02 * z353;
    const Scalar z346 = s_delta * z344 + c_delta * z345;
    const Scalar z347 = s_delta * z345 - c_delta * z344;
    const Scalar z220 = n1 / z219;
    const Scalar z355 = v_delta * s_delta;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z613 = n2 * (z116 * z213 - z117 * z212);
    const Scalar z609 = k6 * z263;
    const Scalar z621 = k7 * z267;
    const Scalar z602 = n2 * z41;
    const Scalar z623 = n2 * z52;
    const Scalar z610 = n0_175 * z291 + z609;
    const Scalar z612 = z319 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z609 - z338 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z611 = z319 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z610 - z338 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z614 = n0_5 * z613 / z219;
    const Scalar z603 = k6 * z602;
    const Scalar z624 = k7 * z623;
    const Scalar z604 = s_Theta * z603;
    const Scalar z606 = z305 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z306 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z607 = z319 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z338 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z615 = z614 / (z219 * z219);
    const Scalar z608 = n0_175 * z604;
    const Scalar z391 = v_Omega * s_Omega;
    const Scalar z390 = v_epsilon * s_epsilon;
    const Scalar z400 = v_Omega * z391;
    const Scalar z369 = v_delta * z355;
    const Scalar z378 = n0_02 * c_Omega;
    const Scalar z379 = n0_02 * s_Omega;
    const Scalar z387 = v_epsilon * c_epsilon;
    const Scalar z401 = n0_02 * z400;
    const Scalar z405 = v_epsilon * z390;
    const Scalar z356 = v_Phi * c_Phi;
    const Scalar z625 = c_Phi * z624;
    const Scalar z388 = v_Omega * c_Omega;
    const Scalar z370 = v_delta * z352;
    const Scalar z380 = n0_04 - z379;
    const Scalar z404 = v_epsilon * z387;
    const Scalar z365 = v_Phi * z356;
    const Scalar z366 = n0_02 * z365;
    const Scalar z367 = v_Phi * z353;
    const Scalar z368 = n0_02 * z367;
    const Scalar z402 = v_Omega * z388;
    const Scalar z403 = n0_02 * z402;
    const Scalar z616 = n352_6605 * z615;
    const Scalar z357 = n0_02 * z356;
    const Scalar z626 = z281 - z621;
    const Scalar z389 = n0_02 * z388;
    const Scalar z392 = n0_02 * z391;
    const Scalar z598 = n2 * v_beta;
    const Scalar z617 = z215 * z221 - z216 * z616;
    const Scalar z618 = z214 * z221 + z217 * z616;
    const Scalar z599 = n0_175 * z598;
    const Scalar z600 = s_Theta * z599;
    const Scalar z619 = n0_018 * z617 + n0_02 * z618;
    const Scalar z360 = s_delta * z343 - c_delta * z344;
    const Scalar z601 = k6 * z600;
    const Scalar z633 = z346 * l_lambda_E4_x + z347 * l_lambda_E4_y;
    const Scalar z628 = n2 * v_delta;
    const Scalar z605 = z601 - n0_175 * z604;
    const Scalar z629 = c_Phi * z628;
    const Scalar z620 = z131 * l_lambda_E3_x - z619 - z132 * l_lambda_E3_y;
    const Scalar z630 = k7 * z629;
    const Scalar z371 = z344 * z369 + z345 * z370 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z632 = z625 - z630;
    const Scalar z634 = k7 * z269;
    const Scalar z376 = z345 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z381 = c_epsilon * z378 + s_epsilon * z380;
    const Scalar z382 = s_epsilon * z378 - c_epsilon * z380;
    const Scalar z395 = s_epsilon * z378 + c_epsilon * z379;
    const Scalar z406 = s_epsilon * z401 - z378 * z404 - z380 * z405 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z411 = z378 * z405 - z380 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z375 = s_delta * z344 + c_delta * z343;
    const Scalar z656 = z341 + a_beta * z305 + a_Theta * z338;
    const Scalar z658 = z333 + a_beta * z306 - a_Theta * z319;
    const Scalar z622 = z360 * l_lambda_E4_y - z621 + z375 * l_lambda_E4_x;
    const Scalar z627 = z626 + z360 * l_lambda_E4_y + z375 * l_lambda_E4_x;
    const Scalar z660 = v_Theta * s_Theta + z315;
    const Scalar z661 = n0_028 * z660;
    const Scalar z662 = v_Theta * c_Theta + z312;
    const Scalar z636 = n2 * z63;
    const Scalar z639 = z275 - z634;
    const Scalar z637 = k7 * z636;
    const Scalar z631 = z360 * l_lambda_E4_y + z375 * l_lambda_E4_x;
    const Scalar z646 = z381 * l_lambda_E6_x + z382 * l_lambda_E6_y;
    const Scalar z638 = c_Omega * z637;
    const Scalar z653 = v_beta * s_beta + z314;
    const Scalar z654 = v_beta * c_beta + z311;
    const Scalar z655 = z303 * z653 + z304 * z654 + n2 * (s_beta * z316 - c_beta * z313);
    const Scalar z657 = z303 * z654 - z304 * z653 + n2 * (s_beta * z313 + c_beta * z316);
    const Scalar z641 = n2 * v_epsilon;
    const Scalar z642 = c_Omega * z641;
    const Scalar z410 = s_epsilon * z379 - c_epsilon * z378;
    const Scalar z673 = a_gamma * z131 + z340;
    const Scalar z676 = a_gamma * z132 - z326;
    const Scalar z692 = a_delta * z346 - z376 + a_Phi * z375;
    const Scalar z694 = z371 + a_Phi * z360 + a_delta * z347;
    const Scalar z635 = z634 + z395 * l_lambda_E6_y - z410 * l_lambda_E6_x;
    const Scalar z710 = a_epsilon * z381 - z411 - a_Omega * z410;
    const Scalar z640 = z395 * l_lambda_E6_y - z639 - z410 * l_lambda_E6_x;
    const Scalar z712 = a_epsilon * z382 - z406 + a_Omega * z395;
    const Scalar z696 = v_Omega * s_Omega + z391;
    const Scalar z678 = v_Phi * c_Phi + z356;
    const Scalar z680 = v_Phi * s_Phi + z353;
    const Scalar z697 = n0_02 * z696;
    const Scalar z698 = v_Omega * c_Omega + z388;
    const Scalar z663 = n0_028 * z662;
    const Scalar z679 = n0_02 * z678;
    const Scalar z681 = n0_02 * z680;
    const Scalar z699 = n0_02 * z698;
    const Scalar z643 = k7 * z642;
    const Scalar z645 = z638 - z643;
    const Scalar z671 = v_gamma * s_gamma + z324;
    const Scalar z672 = n0_035 * z671;
    const Scalar z674 = v_gamma * c_gamma + z309;
    const Scalar z675 = n0_035 * z674;
    const Scalar z644 = z395 * l_lambda_E6_y - z410 * l_lambda_E6_x;
    const Scalar z664 = s_beta * z661 - n2 * (z302 * z311 - z303 * z314) - c_beta * z663;
    const Scalar z668 = n2 * (z302 * z314 + z303 * z311) + s_beta * z663 + c_beta * z661;
    const Scalar z682 = n2 * (z343 * z352 + z344 * z355) + s_delta * z679 + c_delta * z681;
    const Scalar z686 = n2 * (z343 * z355 - z344 * z352) + s_delta * z681 - c_delta * z679;
    const Scalar z700 = s_epsilon * z697 - n2 * (z378 * z387 - z379 * z390) - c_epsilon * z699;
    const Scalar z704 = n2 * (z378 * z390 + z379 * z387) + s_epsilon * z699 + c_epsilon * z697;
    const Scalar z689 = v_delta * s_delta + z355;
    const Scalar z708 = v_epsilon * s_epsilon + z390;
    const Scalar z690 = v_delta * c_delta + z352;
    const Scalar z691 = z344 * z689 + z345 * z690 + n2 * (s_delta * z357 + c_delta * z354);
    const Scalar z693 = z345 * z689 - z344 * z690 + n2 * (s_delta * z354 - c_delta * z357);
    const Scalar z707 = v_epsilon * c_epsilon + z387;
    const Scalar z709 = n2 * (s_epsilon * z392 - c_epsilon * z389) - z378 * z707 - z380 * z708;
    const Scalar z711 = z378 * z708 - z380 * z707 + n2 * (s_epsilon * z389 + c_epsilon * z392);
    const Scalar z665 = z302 * z331 + z303 * z332 + s_beta * z330 + c_beta * z328 + n2 * (z311 * z316 + z313 * z314);
    const Scalar z669 = z303 * z331 - z302 * z332 + s_beta * z328 - c_beta * z330 - n2 * (z311 * z313 - z314 * z316);
    const Scalar z666 = z338 * (a_beta + a_Theta) + z665;
    const Scalar z670 = z319 * (a_beta + a_Theta) - z669;
    const Scalar z683 = z343 * z369 - z344 * z370 + s_delta * z368 - c_delta * z366 - n2 * (z352 * z357 - z354 * z355);
    const Scalar z687 = z343 * z370 + z344 * z369 + s_delta * z366 + c_delta * z368 + n2 * (z352 * z354 + z355 * z357);
    const Scalar z701 = z378 * z405 + z379 * z404 + s_epsilon * z403 + c_epsilon * z401 + n2 * (z387 * z392 + z389
        * z390);
    const Scalar z705 = z379 * z405 - z378 * z404 + s_epsilon * z401 - c_epsilon * z403 - n2 * (z387 * z389 - z390
        * z392);
    const Scalar z684 = z375 * (a_delta + a_Phi) - z683;
    const Scalar z688 = z360 * (a_delta + a_Phi) + z687;
    const Scalar z702 = z410 * (a_epsilon + a_Omega) + z701;
    const Scalar z706 = z395 * (a_epsilon + a_Omega) - z705;
    result.values[0] = z606;
    result.values[1] = -z611;
    result.values[2] = -z605;
    result.values[3] = z608;
    result.values[4] = z205;
    result.values[5] = z194;
    result.values[6] = z306;
    result.values[7] = -z305;
    result.values[8] = z306;
    result.values[9] = -z305;
    result.values[10] = z306;
    result.values[11] = -z305;
    result.values[12] = -z607;
    result.values[13] = -z612;
    result.values[14] = -z601;
    result.values[15] = z194;
    result.values[16] = k11;
    result.values[17] = -z319;
    result.values[18] = -z338;
    result.values[19] = -z319;
    result.values[20] = -z338;
    result.values[21] = -z319;
    result.values[22] = -z338;
    result.values[23] = -z620;
    result.values[24] = k26;
    result.values[25] = z132;
    result.values[26] = z131;
    result.values[27] = -z622;
    result.values[28] = -z631;
    result.values[29] = -z630;
    result.values[30] = k9;
    result.values[31] = z178;
    result.values[32] = -z360;
    result.values[33] = z375;
    result.values[34] = -z627;
    result.values[35] = -z633;
    result.values[36] = z625;
    result.values[37] = z632;
    result.values[38] = z178;
    result.values[39] = z191;
    result.values[40] = -z347;
    result.values[41] = z346;
    result.values[42] = -z635;
    result.values[43] = -z644;
    result.values[44] = z643;
    result.values[45] = k9;
    result.values[46] = z162;
    result.values[47] = -z395;
    result.values[48] = -z410;
    result.values[49] = -z640;
    result.values[50] = -z646;
    result.values[51] = -z638;
    result.values[52] = -z645;
    result.values[53] = z162;
    result.values[54] = z175;
    result.values[55] = -z382;
    result.values[56] = z381;
    result.values[57] = -z656;
    result.values[58] = -z666;
    result.values[59] = z673;
    result.values[60] = -z655;
    result.values[61] = -z664;
    result.values[62] = z672;
    result.values[63] = -z306;
    result.values[64] = z319;
    result.values[65] = -z132;
    result.values[66] = -z658;
    result.values[67] = z670;
    result.values[68] = -z676;
    result.values[69] = z657;
    result.values[70] = z668;
    result.values[71] = -z675;
    result.values[72] = z305;
    result.values[73] = z338;
    result.values[74] = -z131;
    result.values[75] = -z656;
    result.values[76] = -z666;
    result.values[77] = z684;
    result.values[78] = z692;
    result.values[79] = -z655;
    result.values[80] = -z664;
    result.values[81] = z682;
    result.values[82] = z691;
    result.values[83] = -z306;
    result.values[84] = z319;
    result.values[85] = z360;
    result.values[86] = z347;
    result.values[87] = -z658;
    result.values[88] = z670;
    result.values[89] = z688;
    result.values[90] = z694;
    result.values[91] = z657;
    result.values[92] = z668;
    result.values[93] = z686;
    result.values[94] = z693;
    result.values[95] = z305;
    result.values[96] = z338;
    result.values[97] = -z375;
    result.values[98] = -z346;
    result.values[99] = -z656;
    result.values[100] = -z666;
    result.values[101] = -z702;
    result.values[102] = z710;
    result.values[103] = -z655;
    result.values[104] = -z664;
    result.values[105] = -z700;
    result.values[106] = -z709;
    result.values[107] = -z306;
    result.values[108] = z319;
    result.values[109] = z395;
    result.values[110] = z382;
    result.values[111] = -z658;
    result.values[112] = z670;
    result.values[113] = z706;
    result.values[114] = z712;
    result.values[115] = z657;
    result.values[116] = z668;
    result.values[117] = z704;
    result.values[118] = z711;
    result.values[119] = z305;
    result.values[120] = z338;
    result.values[121] = z410;
    result.values[122] = -z381;
  }
};

}  // namespace andrews_squeezer
