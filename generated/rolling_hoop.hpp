// SPDX-License-Identifier: MIT
// rolling_hoop: Hoop rolling without slipping: five coordinates, two multipliers
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, constraints, linearisation, inverse_dynamics_derivatives, forward_dynamics_derivatives, jets, sparse_constraint_jacobian, inverse_dynamics_sensitivities, forward_dynamics_sensitivities
// Parameters set at run time: A, C
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function                        additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                              4                7          1             0                  0       0     12       -
//   kinematics                             34               65          0             0                  3       0    105     105
//   mass_matrix                             2                4          0             0                  1       0      8       9
//   bias                                    6               18          0             0                  1       0     26      55
//   inverse_dynamics                       19               27          0             0                  2       0     50     107
//   forward_dynamics                       28               54          4             0                  2       0     90     142
//   energy                                 14               29          0             0                  3       0     49      55
//   first_integrals                        15               29          0             0                  3       0     50      56
//   constraints                             9               16          0             0                  2       0     29      29
//   linearisation                         213              313          8             0                  2       0    538     713
//   inverse_dynamics_derivatives           31               59          0             0                  2       0     94     266
//   forward_dynamics_derivatives          127              230          4             0                  2       0    365     645
//   jets                                  128              150         12             0                  2       0    294       -
//   sparse_constraint_jacobian              0                0          0             0                  2       0      4       4
//   inverse_dynamics_sensitivities          7               13          0             0                  1       0     22      50
//   forward_dynamics_sensitivities         46               87          4             0                  2       0    141     213
//
// Not computed because this mechanism does not need it:
//   kinematics: of 39 results 11 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 25 results 18 vanish identically, 1 repeat another up to sign
//   bias: of 5 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 16 results 5 vanish identically, 2 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 180 results 100 vanish identically, 5 repeat another up to sign
//   inverse_dynamics_derivatives: of 50 results 37 vanish identically, 1 repeat another up to sign
//   forward_dynamics_derivatives: of 105 results 40 vanish identically, 6 repeat another up to sign
//   sparse_constraint_jacobian: of 7 results 2 repeat another up to sign
//   inverse_dynamics_sensitivities: of 10 results 5 vanish identically
//   forward_dynamics_sensitivities: of 14 results 1 vanish identically
//
// To write this file again:
//   rolling_hoop_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,inverse_dynamics_derivatives,forward_dynamics_derivatives,jets,sparse_constraint_jacobian,inverse_dynamics_sensitivities,forward_dynamics_sensitivities --output rolling_hoop.hpp
#pragma once

#include <array>
#include <cmath>

#ifndef TORSOR_KERNEL_SUPPORT
#define TORSOR_KERNEL_SUPPORT 2
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
// The core has no branch, so that compilers turn a loop over several angles into vector instructions.
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
  /// To the nearest integer, of two the even one.
  TORSOR_DEVICE TORSOR_INLINED static Scalar rounded(const Scalar& x) noexcept {
    const Scalar unit_ulp = number(0x1.8p52, 0x1.8p23f);
    return (x + unit_ulp) - unit_ulp;
  }

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
      const Scalar z4 = z2 * z2;
      const Scalar S01 = number(-0x1.5555555555548p-3, 0.0f) + z * number(0x1.111111110f73p-7, 0.0f);
      const Scalar S23 = number(-0x1.a01a019be9217p-13, 0.0f) + z * number(0x1.71de35552b518p-19, 0.0f);
      const Scalar S45 = number(-0x1.ae5e4b83e1601p-26, 0.0f) + z * number(0x1.5d8b55934597bp-33, 0.0f);
      const Scalar C01 = number(0x1.555555555554cp-5, 0.0f) + z * number(-0x1.6c16c16c1521bp-10, 0.0f);
      const Scalar C23 = number(0x1.a01a019cbeb68p-16, 0.0f) + z * number(-0x1.27e4f8121198fp-22, 0.0f);
      const Scalar C45 = number(0x1.1ee9f0cbf70d6p-29, 0.0f) + z * number(-0x1.8fb0e15d5f2ap-37, 0.0f);
      S = (S01 + z2 * S23) + z4 * S45;
      C = (C01 + z2 * C23) + z4 * C45;
    }
    const Scalar half_z = half * z, w = one - half_z;
    // Far below an ulp, it makes the correction of -0 a -0, and so the sine.
    const Scalar tiny = number(0x1p-100, 0x1p-60f);
    sine = high + (high * (tiny + z * S) - rest * w);
    cosine = w + (((one - w) - half_z) + (z2 * C + high * rest));
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

  /// For |x| <= bound; what is no number gives no number. Exact are n times the first three parts of pi/2, the first
  /// difference, and each rounded difference together with its rounding error.
  TORSOR_DEVICE TORSOR_INLINED static void core(const Scalar& x, Scalar& sine, Scalar& cosine) noexcept {
    const Scalar n = rounded(x * number(0x1.45f306dc9c883p-1, 0x1.45f306p-1f));
    const Scalar first = x - n * number(0x1.921fb544p+0, 0x1.9218p+0f);
    const Scalar second = n * number(0x1.0b4611a6p-34, 0x1.ed5p-14f);
    const Scalar third = n * number(0x1.3198a2ep-69, 0x1.10bp-30f);
    const Scalar fourth = n * number(0x1.b839a252049c1p-104, 0x1.184698p-44f);
    const Scalar r = first - second;
    const Scalar taken = first - r;
    const Scalar error = (first - (r + taken)) - (second - taken);
    const Scalar high = r - third;
    const Scalar rest = ((third - (r - high)) - error) + fourth;
    of_reduced(high, rest, sine, cosine);
    turn(n, sine, cosine);
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

/// Of some angles up to the bound, a multiple of what a vector holds. Local arrays, which nothing else can point to.
template <int size, class Scalar>
TORSOR_DEVICE TORSOR_INLINED void sincos_of_block(const Scalar* angles, Scalar* sines, Scalar* cosines) noexcept {
  Scalar x[size], s[size], c[size];
  for (int i = 0; i < size; ++i) x[i] = angles[i];
  // Compilers make vector instructions of a loop, but not always of a row of statements.
#if defined(__clang__)
#pragma clang loop unroll(disable)
#elif defined(__GNUC__) && !defined(__CUDACC__)
#pragma GCC unroll 1
#endif
  for (int i = 0; i < size; ++i) SineCosine<Scalar, sizeof(Scalar) == sizeof(float)>::core(x[i], s[i], c[i]);
  for (int i = 0; i < size; ++i) sines[i] = s[i];
  for (int i = 0; i < size; ++i) cosines[i] = c[i];
}

/// Of several angles at once, in float or double: as many as a vector holds go through the core together.
template <class Scalar, int N>
TORSOR_DEVICE inline void sincos_of_several(const Scalar (&angles)[N], Scalar (&sines)[N],
                                            Scalar (&cosines)[N]) noexcept {
  constexpr int narrow = 16 / sizeof(Scalar);
#if defined(__AVX__)
  constexpr int wide = 32 / sizeof(Scalar);
#else
  constexpr int wide = narrow;
#endif
#if defined(__CUDA_ARCH__) || defined(TORSOR_STD_SINCOS)
  constexpr bool by_vectors = false;
#elif defined(__clang__)
  constexpr bool by_vectors = N >= 4;  // it leaves a loop over two as it is
#else
  constexpr bool by_vectors = N >= narrow;
#endif
  if constexpr (by_vectors) {
    constexpr int vector = N >= wide ? wide : narrow, rest = N % vector;
    // Of a rest some angles are done again: a whole vector costs less than two or three alone.
#if defined(__clang__)
    sincos_of_block<N - rest>(angles, sines, cosines);  // best as one loop
    if constexpr (rest > 1) {
      sincos_of_block<vector>(angles + (N - vector), sines + (N - vector), cosines + (N - vector));
    }
#else
    for (int next = 0; next < N - (rest == 1); next += vector) {
      const int first = next + vector <= N ? next : N - vector;
      sincos_of_block<vector>(angles + first, sines + first, cosines + first);
    }
#endif
    if constexpr (rest == 1) sincos_of_one(angles[N - 1], sines[N - 1], cosines[N - 1]);
    constexpr Scalar bound = static_cast<Scalar>(SineCosine<Scalar, sizeof(Scalar) == sizeof(float)>::bound);
    Scalar sum = 0;
    for (int i = 0; i < N; ++i) sum += std::abs(angles[i]);
    const bool to_one_side = rounds_to_one_side(sum);
    if (sum <= bound && !to_one_side) return;
    for (int i = 0; i < N; ++i) {
      if (std::abs(angles[i]) > bound || to_one_side) sincos_far(angles[i], sines[i], cosines[i]);
    }
  } else {
    for (int i = 0; i < N; ++i) sincos_of_one(angles[i], sines[i], cosines[i]);
  }
}

/// Of several angles of any scalar: at once where its traits have a `sincos` of arrays, else one by one.
template <class Scalar, int N>
TORSOR_DEVICE auto sincos_by_traits(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N], int) noexcept
    -> decltype(scalar_traits<Scalar>::sincos(angles, sines, cosines)) {
  scalar_traits<Scalar>::sincos(angles, sines, cosines);
}
template <class Scalar, int N>
TORSOR_DEVICE void sincos_by_traits(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N],
                                    long) noexcept {
  for (int i = 0; i < N; ++i) scalar_traits<Scalar>::sincos(angles[i], sines[i], cosines[i]);
}
template <class Scalar, int N>
TORSOR_DEVICE void sines_and_cosines(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N]) noexcept {
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
  TORSOR_DEVICE static void sincos(const Scalar (&angles)[N], Scalar (&sines)[N], Scalar (&cosines)[N]) noexcept {
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
#elif TORSOR_KERNEL_SUPPORT != 2
#error "headers of incompatible versions of torsor meet here: write them again with one version"
#endif

#ifndef TORSOR_JET_SUPPORT
#define TORSOR_JET_SUPPORT 1

namespace torsor {

/// Numbers that are treated alike. float and double fill a vector register where the compiler has a type for it.
template <class Scalar>
struct Lanes {
  static constexpr int width = 1;
  struct Vector {
    Scalar lane[width];
    TORSOR_DEVICE Scalar& operator[](int i) noexcept { return lane[i]; }
    TORSOR_DEVICE const Scalar& operator[](int i) const noexcept { return lane[i]; }
  };
  TORSOR_DEVICE TORSOR_INLINED static void add_product(Vector& sum, const Vector& a, const Vector& b) noexcept {
    for (int i = 0; i < width; ++i) sum[i] = sum[i] + a[i] * b[i];
  }
};
#if defined(__GNUC__) && !defined(__CUDACC__)
template <class Number>
struct RegisterLanes {
#if defined(__AVX__)
  static constexpr int width = 32 / static_cast<int>(sizeof(Number));
#else
  static constexpr int width = 16 / static_cast<int>(sizeof(Number));
#endif
  typedef Number Vector __attribute__((vector_size(width * sizeof(Number))));
  TORSOR_INLINED static void add_product(Vector& sum, const Vector& a, const Vector& b) noexcept { sum += a * b; }
};
template <>
struct Lanes<double> : RegisterLanes<double> {};
template <>
struct Lanes<float> : RegisterLanes<float> {};
#endif

/// Pairs of Taylor series and their convolutions, side by side in vectors. Coefficients of order 0 are not kept: whoever
/// asks for a sum adds the terms with them.
template <class Scalar, int count>
class Convolutions {
  using Vector = typename Lanes<Scalar>::Vector;
  static constexpr int width = Lanes<Scalar>::width;
  static constexpr int vectors = (count + width - 1) / width;
  static constexpr int block = 4, blocks = vectors / block, rest = vectors % block;
  static constexpr int order_max = 30;

 public:
  class Sums {
   public:
    TORSOR_DEVICE TORSOR_INLINED Scalar operator[](int i) const noexcept { return vector_[i / width][i % width]; }

   private:
    friend class Convolutions;
    Vector vector_[vectors];
  };

  /// The terms a_i b_(k-i), i = 1..k-1, of each pair, summed.
  TORSOR_DEVICE TORSOR_INLINED void sum(int k, Sums& sums) const noexcept {
    for (int i = 0; i < blocks; ++i) sum_block<block>(k, i, sums);
    if constexpr (rest > 0) sum_block<rest>(k, blocks, sums);
  }

  /// The coefficients of order k.
  TORSOR_DEVICE TORSOR_INLINED void keep(int k, const Scalar (&left)[count], const Scalar (&right)[count]) noexcept {
    for (int i = 0; i < blocks; ++i) keep_block<block>(k, i, left, right);
    if constexpr (rest > 0) keep_block<rest>(k, blocks, left, right);
  }

 private:
  /// As many vectors as there are chains of additions that a processor works on at once. The coefficients of order
  /// k - 1, which have only just been computed, come last.
  template <int size>
  TORSOR_DEVICE TORSOR_INLINED void sum_block(int k, int index, Sums& sums) const noexcept {
    Vector a = {}, b = {}, c = {}, d = {};
    const Vector* const all_left = left_ + index * block * order_max;
    const Vector* const all_right = right_ + index * block * order_max;
    const auto add = [&](int i) {
      const Vector* left = all_left + i * size;
      const Vector* right = all_right + (k - i) * size;
      Lanes<Scalar>::add_product(a, left[0], right[0]);
      if constexpr (size > 1) Lanes<Scalar>::add_product(b, left[1], right[1]);
      if constexpr (size > 2) Lanes<Scalar>::add_product(c, left[2], right[2]);
      if constexpr (size > 3) Lanes<Scalar>::add_product(d, left[3], right[3]);
    };
    for (int i = 2; i < k - 1; ++i) add(i);
    if (k > 1) add(1);
    if (k > 2) add(k - 1);
    Vector* result = sums.vector_ + index * block;
    result[0] = a;
    if constexpr (size > 1) result[1] = b;
    if constexpr (size > 2) result[2] = c;
    if constexpr (size > 3) result[3] = d;
  }

  template <int size>
  TORSOR_DEVICE TORSOR_INLINED void keep_block(int k, int index, const Scalar (&left)[count],
                                               const Scalar (&right)[count]) noexcept {
    const Scalar zero = scalar_traits<Scalar>::constant(0.0, 0.0f, "0/1");
    const int first = index * block * order_max + k * size;
    for (int v = 0; v < size; ++v) {
      for (int i = 0; i < width; ++i) {
        const int place = (index * block + v) * width + i;
        left_[first + v][i] = place < count ? left[place] : zero;
        right_[first + v][i] = place < count ? right[place] : zero;
      }
    }
  }

  /// Block after block, of one block order after order.
  Vector left_[vectors * order_max], right_[vectors * order_max];
};

}  // namespace torsor
#endif

namespace rolling_hoop {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "rolling_hoop";
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 2;

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
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar theta;  ///< coordinate [rad or 1]
    Scalar phi;  ///< coordinate [rad or 1]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::theta,
          &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::theta, &GeneralizedForces::phi};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_along_x1;  ///< of the constraint along_x1 [N]
    Scalar lambda_along_y1;  ///< of the constraint along_y1 [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_along_x1, &Multipliers::lambda_along_y1};
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
    Scalar z79;
    Scalar z155;
    Scalar y0;
    Scalar y1;
    Scalar y2;
    Scalar y3;
    Scalar y4;
    Scalar y5;
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_A = parameters.A;
    const Scalar p_C = parameters.C;
    const Scalar z79 = p_A - p_C;
    const Scalar z155 = n1 / p_C;
    precomputed.z79 = z79;
    precomputed.z155 = z155;
    precomputed.y0 = n2 * p_A;
    precomputed.y1 = p_C * p_C * z155;
    precomputed.y2 = n1 - p_C * z155;
    precomputed.y3 = n1 + z155;
    precomputed.y4 = p_C * (n1 - p_C * z155);
    precomputed.y5 = p_C * z155;
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
    state.q.psi = n0;
    state.q.theta = n1_2;
    state.q.phi = n0;
    state.v.x = n4 - n0_5 * z1;
    state.v.y = n0_3 * z2;
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
    std::array<Scalar, 15> I_jacobian;  ///< partial velocities of I (3 x 5)
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
  static constexpr int first_integral_count = 1;

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 2> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 2> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 10> jacobian;  ///< A, stored column by column (2 x 5)
    std::array<Scalar, 2> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 25> M;  ///< mass matrix (5 x 5)
    std::array<Scalar, 25> C;  ///< damping and gyroscopic terms (5 x 5)
    std::array<Scalar, 25> K;  ///< stiffness (5 x 5)
    std::array<Scalar, 5> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 15> K_r;  ///< reduced stiffness (3 x 5)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, w): x' = A x + B du (8 x 8)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 5;
  static constexpr int independent_coordinates[] = {0, 1, 2, 3, 4};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[] = {1, 2, 4};

  /// Derivatives of generalised forces, stored column by column.
  struct InverseDynamicsDerivatives {
    std::array<Scalar, 25> by_position;  ///< df_i/dq_j (5 x 5)
    std::array<Scalar, 25> by_velocity;  ///< df_i/dv_j (5 x 5)
  };

  /// Derivatives of accelerations and multipliers, stored column by column.
  struct ForwardDynamicsDerivatives {
    std::array<Scalar, 25> by_position;  ///< da_i/dq_j (5 x 5)
    std::array<Scalar, 25> by_velocity;  ///< da_i/dv_j (5 x 5)
    std::array<Scalar, 25> by_force;  ///< da_i/df_j, f generalised forces added to E u (5 x 5)
    std::array<Scalar, 10> multipliers_by_position;  ///< dlambda_i/dq_j (2 x 5)
    std::array<Scalar, 10> multipliers_by_velocity;  ///< dlambda_i/dv_j (2 x 5)
    std::array<Scalar, 10> multipliers_by_force;  ///< dlambda_i/df_j, f generalised forces added to E u (2 x 5)
  };

  /// Entries of A in compressed rows.
  struct SparseConstraintJacobian {
    std::array<Scalar, 7> values;  ///< entries of A, row by row
  };
  /// Where the values of SparseConstraintJacobian stand: those of row i, in the order of the multipliers, from
  /// row_start[i] to row_start[i + 1], each in its column, an index in v.
  static constexpr int constraint_jacobian_nonzeros = 7;
  static constexpr int constraint_jacobian_row_start[] = {0, 4, 7};
  static constexpr int constraint_jacobian_column[] = {0, 1, 2, 4, 0, 1, 3};

  /// Derivatives by the run-time parameters, a column for each, in the order of Parameters.
  struct InverseDynamicsSensitivities {
    std::array<Scalar, 10> by_parameter;  ///< df_i/dp_k (5 x 2)
  };

  /// Derivatives by the run-time parameters, a column for each, in the order of Parameters.
  struct ForwardDynamicsSensitivities {
    std::array<Scalar, 10> by_parameter;  ///< da_i/dp_k (5 x 2)
    std::array<Scalar, 4> multipliers_by_parameter;  ///< dlambda_i/dp_k (2 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z26 = v_x * c_psi + v_y * s_psi;
    const Scalar z27 = v_x * s_psi - v_y * c_psi;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z30 = s_theta * z10 - c_theta * z27;
    const Scalar z31 = s_theta * z27 + c_theta * z10;
    const Scalar z32 = v_theta * c_phi + s_phi * z28;
    const Scalar z33 = v_theta * s_phi - c_phi * z28;
    const Scalar z34 = s_phi * z30 + c_phi * z26;
    const Scalar z35 = s_phi * z26 - c_phi * z30;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z37 = c_theta * s_phi;
    const Scalar z38 = s_theta * s_phi;
    const Scalar z39 = s_psi * z37 - c_psi * c_phi;
    const Scalar z40 = s_psi * c_phi + c_psi * z37;
    const Scalar z41 = c_theta * c_phi;
    const Scalar z42 = s_theta * c_phi;
    const Scalar z43 = s_psi * z41 + c_psi * s_phi;
    const Scalar z44 = s_psi * s_phi - c_psi * z41;
    const Scalar z45 = s_theta * s_psi;
    const Scalar z46 = s_theta * c_psi;
    const Scalar z47 = s_phi * z35 + c_phi * z34;
    const Scalar z48 = s_phi * z34 - c_phi * z35;
    const Scalar z49 = s_theta * z31 - c_theta * z48;
    const Scalar z50 = s_theta * z48 + c_theta * z31;
    const Scalar z51 = s_psi * z49 + c_psi * z47;
    const Scalar z52 = s_psi * z47 - c_psi * z49;
    const Scalar z53 = s_phi * z33 + c_phi * z32;
    const Scalar z54 = s_phi * z32 - c_phi * z33;
    const Scalar z55 = s_theta * z36 - c_theta * z54;
    const Scalar z56 = s_theta * z54 + c_theta * z36;
    const Scalar z57 = s_psi * z55 + c_psi * z53;
    const Scalar z58 = s_psi * z53 - c_psi * z55;
    const Scalar z59 = c_theta * s_psi;
    const Scalar z60 = c_theta * c_psi;
    const Scalar z61 = q_y - z60;
    const Scalar z62 = q_x + z59;
    const Scalar z63 = z26 + z29;
    const Scalar z64 = v_theta - z31;
    const Scalar z65 = s_theta * z64 + c_theta * z30;
    const Scalar z67 = s_psi * z65 - c_psi * z63;
    const Scalar z68 = s_psi * z63 + c_psi * z65;
    const Scalar z69 = q_x - z62;
    const Scalar z70 = q_y - z61;
    result.hoop_position[0] = q_x;
    result.hoop_position[1] = q_y;
    result.hoop_position[2] = s_theta;
    result.hoop_rotation[0] = -z39;
    result.hoop_rotation[1] = z40;
    result.hoop_rotation[2] = z38;
    result.hoop_rotation[3] = -z43;
    result.hoop_rotation[4] = -z44;
    result.hoop_rotation[5] = z42;
    result.hoop_rotation[6] = z45;
    result.hoop_rotation[7] = -z46;
    result.hoop_rotation[8] = c_theta;
    result.hoop_velocity[0] = z51;
    result.hoop_velocity[1] = z52;
    result.hoop_velocity[2] = z50;
    result.hoop_angular_velocity[0] = z57;
    result.hoop_angular_velocity[1] = z58;
    result.hoop_angular_velocity[2] = z56;
    result.I_position[0] = z62;
    result.I_position[1] = z61;
    result.I_position[2] = n0;
    result.I_velocity[0] = -z67;
    result.I_velocity[1] = z68;
    result.I_velocity[2] = n0;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = z70;
    result.I_jacobian[9] = -z45;
    result.I_jacobian[12] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = -z69;
    result.I_jacobian[10] = z46;
    result.I_jacobian[13] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n0;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 25>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z79 = precomputed.z79;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z74 = c_theta * p_C;
    const Scalar z80 = s_theta * z79;
    const Scalar z81 = s_theta * z80;
    const Scalar z83 = p_C + z81;
    const Scalar z98 = c_theta * c_theta + p_A;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n1;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = z83;
    mass[13] = n0;
    mass[14] = z74;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z98;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = z74;
    mass[23] = n0;
    mass[24] = p_C;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z11 = s_theta * v_theta;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z99 = v_theta * z11;
    const Scalar z100 = n9_81 - z99;
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z104 = v_theta * z28;  // angular acceleration of hoop.2, z
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z109 = p_C * z107;  // moment on hoop, x
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z111 = p_C * z104;  // moment on hoop, z
    const Scalar z112 = z28 * z29;
    const Scalar z113 = n2 * z103;
    const Scalar z114 = p_A * z112 - z109;  // moment on hoop.2, x
    const Scalar z115 = p_A * z113 - z110;  // moment on hoop.2, y
    const Scalar z117 = s_theta * z115 - c_theta * z111;
    const Scalar z121 = c_theta * z100 - z114;
    forces.x = n0;
    forces.y = n0;
    forces.psi = z117;
    forces.theta = z121;
    forces.phi = -z111;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z11 = s_theta * v_theta;
    const Scalar z13 = c_theta * a_theta - v_theta * z11;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z109 = p_C * z107;  // moment on hoop, x
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z112 = z28 * z29;
    const Scalar z122 = n9_81 + z13;
    const Scalar z125 = s_theta * a_psi;
    const Scalar z126 = c_theta * a_psi;
    const Scalar z129 = v_theta * z29 + z125;  // angular acceleration of hoop.2, y
    const Scalar z130 = v_theta * z28 - z126;  // angular acceleration of hoop.2, z
    const Scalar z133 = a_phi - z130;  // angular acceleration of hoop, z
    const Scalar z134 = p_C * z133;  // moment on hoop, z
    const Scalar z135 = z103 + z129;
    const Scalar z136 = p_A * (a_theta - z112) + z109;  // moment on hoop.2, x
    const Scalar z137 = p_A * z135 - z110;  // moment on hoop.2, y
    const Scalar z139 = s_theta * z137 + c_theta * z134;
    const Scalar z146 = c_theta * z122 + z136;
    forces.x = a_x + s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    forces.y = a_y - s_psi * l_lambda_along_x1 - c_psi * l_lambda_along_y1;
    forces.psi = -c_theta * l_lambda_along_x1 + z139;
    forces.theta = -s_theta * l_lambda_along_y1 + z146;
    forces.phi = z134 - l_lambda_along_x1;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z79 = precomputed.z79;
    const Scalar z155 = precomputed.z155;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z74 = c_theta * p_C;
    const Scalar z80 = s_theta * z79;
    const Scalar z81 = s_theta * z80;
    const Scalar z83 = p_C + z81;
    const Scalar z98 = c_theta * c_theta + p_A;
    const Scalar z99 = v_theta * z11;
    const Scalar z100 = n9_81 - z99;
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z104 = v_theta * z28;  // angular acceleration of hoop.2, z
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z109 = p_C * z107;  // moment on hoop, x
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z111 = p_C * z104;  // moment on hoop, z
    const Scalar z112 = z28 * z29;
    const Scalar z113 = n2 * z103;
    const Scalar z114 = p_A * z112 - z109;  // moment on hoop.2, x
    const Scalar z115 = p_A * z113 - z110;  // moment on hoop.2, y
    const Scalar z117 = s_theta * z115 - c_theta * z111;
    const Scalar z121 = c_theta * z100 - z114;
    const Scalar z148 = v_psi * s_psi;
    const Scalar z149 = v_psi * c_psi;
    const Scalar z150 = v_x * z148 - v_y * z149 + z11 * v_psi;
    const Scalar z152 = v_x * z149 + v_y * z148 - v_theta * z10;
    const Scalar z156 = z74 * z155;
    const Scalar z157 = z74 * z156 - z83;
    const Scalar z158 = n1 / z98;
    const Scalar z159 = n1 / z157;
    const Scalar z160 = c_theta - z156;
    const Scalar z161 = z159 * z160;
    const Scalar z162 = z155 + z156 * z161;
    const Scalar z163 = s_theta * z158;
    const Scalar z164 = n1 - c_theta * z161 + z162;
    const Scalar z165 = n1 + s_theta * z163;
    const Scalar z166 = n1 / z165;
    const Scalar z167 = n1 / z164;
    const Scalar z168 = z111 * z156 + z117;
    const Scalar z169 = z159 * z168;
    const Scalar z170 = z121 * z158;
    const Scalar z171 = z111 * z155 - z156 * z169;
    const Scalar z172 = c_theta * z169 - z150 + z171;
    const Scalar z173 = s_theta * z170 + z152;
    const Scalar z174 = z167 * z172;
    const Scalar z175 = z166 * z173;
    const Scalar z176 = s_psi * z175 + c_psi * z174;
    const Scalar z177 = s_psi * z174 - c_psi * z175;
    const Scalar z178 = z161 * z174 + z169;
    const Scalar z179 = z163 * z175 - z170;
    const Scalar z180 = z162 * z174 - z171;
    accelerations.x = -z176;
    accelerations.y = -z177;
    accelerations.psi = z178;
    accelerations.theta = z179;
    accelerations.phi = -z180;
    multipliers.lambda_along_x1 = -z174;
    multipliers.lambda_along_y1 = z175;
    if (!(traits::regular(-z157, z83) && traits::regular(z98, z98) && traits::regular(p_C, p_C) && traits::regular(z164,
        z164) && traits::regular(z165, z165))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.x - accelerations.x) + (accelerations.y - accelerations.y) + (accelerations.psi
        - accelerations.psi) + (accelerations.theta - accelerations.theta) + (accelerations.phi - accelerations.phi)
        + (multipliers.lambda_along_x1 - multipliers.lambda_along_x1) + (multipliers.lambda_along_y1
        - multipliers.lambda_along_y1);
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
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z26 = v_x * c_psi + v_y * s_psi;
    const Scalar z27 = v_x * s_psi - v_y * c_psi;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z30 = s_theta * z10 - c_theta * z27;
    const Scalar z31 = s_theta * z27 + c_theta * z10;
    const Scalar z32 = v_theta * c_phi + s_phi * z28;
    const Scalar z33 = v_theta * s_phi - c_phi * z28;
    const Scalar z34 = s_phi * z30 + c_phi * z26;
    const Scalar z35 = s_phi * z26 - c_phi * z30;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    result.kinetic = n0_5 * (p_A * (z32 * z32 + z33 * z33) + p_C * z36 * z36 + z31 * z31 + z34 * z34 + z35 * z35);
    result.force_function = -n9_81 * s_theta;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z26 = v_x * c_psi + v_y * s_psi;
    const Scalar z27 = v_x * s_psi - v_y * c_psi;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z30 = s_theta * z10 - c_theta * z27;
    const Scalar z31 = s_theta * z27 + c_theta * z10;
    const Scalar z32 = v_theta * c_phi + s_phi * z28;
    const Scalar z33 = v_theta * s_phi - c_phi * z28;
    const Scalar z34 = s_phi * z30 + c_phi * z26;
    const Scalar z35 = s_phi * z26 - c_phi * z30;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    result.energy = n0_5 * (p_A * (z32 * z32 + z33 * z33) + p_C * z36 * z36 + z31 * z31 + z34 * z34 + z35 * z35) + n9_81
        * s_theta;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z147 = v_x * c_psi + v_y * s_psi + c_theta * v_psi + v_phi;
    const Scalar z148 = v_psi * s_psi;
    const Scalar z149 = v_psi * c_psi;
    const Scalar z150 = v_x * z148 - v_y * z149 + z11 * v_psi;
    const Scalar z151 = v_x * s_psi - v_y * c_psi - s_theta * v_theta;
    const Scalar z152 = v_x * z149 + v_y * z148 - v_theta * z10;
    result.value[0] = n0;
    result.rate[0] = z147;
    result.gamma[0] = -z150;
    result.value[1] = n0;
    result.rate[1] = -z151;
    result.gamma[1] = -z152;
    result.jacobian[0] = c_psi;
    result.jacobian[1] = -s_psi;
    result.jacobian[2] = s_psi;
    result.jacobian[3] = c_psi;
    result.jacobian[4] = c_theta;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = s_theta;
    result.jacobian[8] = n1;
    result.jacobian[9] = n0;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar z79 = precomputed.z79;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z13 = c_theta * a_theta - v_theta * z11;
    const Scalar z26 = v_x * c_psi + v_y * s_psi;
    const Scalar z27 = v_x * s_psi - v_y * c_psi;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z74 = c_theta * p_C;
    const Scalar z80 = s_theta * z79;
    const Scalar z81 = s_theta * z80;
    const Scalar z83 = p_C + z81;
    const Scalar z98 = c_theta * c_theta + p_A;
    const Scalar z99 = v_theta * z11;
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z104 = v_theta * z28;  // angular acceleration of hoop.2, z
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z109 = p_C * z107;  // moment on hoop, x
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z111 = p_C * z104;  // moment on hoop, z
    const Scalar z112 = z28 * z29;
    const Scalar z122 = n9_81 + z13;
    const Scalar z125 = s_theta * a_psi;
    const Scalar z126 = c_theta * a_psi;
    const Scalar z129 = v_theta * z29 + z125;  // angular acceleration of hoop.2, y
    const Scalar z130 = v_theta * z28 - z126;  // angular acceleration of hoop.2, z
    const Scalar z133 = a_phi - z130;  // angular acceleration of hoop, z
    const Scalar z134 = p_C * z133;  // moment on hoop, z
    const Scalar z135 = z103 + z129;
    const Scalar z136 = p_A * (a_theta - z112) + z109;  // moment on hoop.2, x
    const Scalar z137 = p_A * z135 - z110;  // moment on hoop.2, y
    const Scalar z139 = s_theta * z137 + c_theta * z134;
    const Scalar z146 = c_theta * z122 + z136;
    const Scalar z148 = v_psi * s_psi;
    const Scalar z149 = v_psi * c_psi;
    const Scalar z150 = v_x * z148 - v_y * z149 + z11 * v_psi;
    const Scalar z152 = v_x * z149 + v_y * z148 - v_theta * z10;
    const Scalar z181 = p_C * z36;
    const Scalar z198 = s_psi * l_lambda_along_x1 + c_psi * l_lambda_along_y1;
    const Scalar z199 = s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    const Scalar z200 = n2 * z10;
    const Scalar z201 = z10 * p_C;
    const Scalar z202 = p_A * z200 - z201;
    const Scalar z203 = z11 * p_C;
    const Scalar z204 = s_theta * z202 - c_theta * z203;
    const Scalar z205 = s_theta * z29 + c_theta * z28;
    const Scalar z206 = s_theta * z36 + c_theta * z28;
    const Scalar z207 = p_C * z206;
    const Scalar z208 = p_A * z205 - z207;
    const Scalar z209 = n2 * z29;
    const Scalar z210 = p_A * z209 - z181;
    const Scalar z211 = p_C * z28;
    const Scalar z212 = s_theta * z210 - c_theta * z211;
    const Scalar z213 = z104 + z130;
    const Scalar z214 = p_A * z213 - z111;
    const Scalar z215 = p_C * z129;
    const Scalar z216 = s_theta * (z134 + z214) - c_theta * (z137 - z215);
    const Scalar z217 = s_theta * l_lambda_along_x1 - z216;
    const Scalar z218 = s_theta * v_theta + z11;
    const Scalar z219 = c_theta * z218;
    const Scalar z220 = s_theta * a_theta + v_theta * z10;
    const Scalar z221 = z28 * z28 - z29 * z29;
    const Scalar z222 = z28 * z28 - z29 * z36;
    const Scalar z223 = p_C * z222;
    const Scalar z224 = p_A * z221 - z223;
    const Scalar z225 = s_theta * z122 + c_theta * z220 - z224;
    const Scalar z226 = c_theta * l_lambda_along_y1 + z225;
    const Scalar z227 = v_theta * p_C;
    const Scalar z228 = s_theta * z227;
    const Scalar z229 = a_x * s_psi - a_y * c_psi - s_theta * a_theta + z152;
    const Scalar z230 = a_x * c_psi + a_y * s_psi + c_theta * a_psi + a_phi - z150;
    const Scalar z231 = v_x * z148 - v_y * z149;
    const Scalar z232 = a_x * c_psi + a_y * s_psi - z231;
    const Scalar z233 = v_x * s_psi - v_y * c_psi + z11;
    const Scalar z234 = v_x * z149 + v_y * z148;
    const Scalar z235 = a_x * s_psi - a_y * c_psi + z234;
    const Scalar z236 = c_theta * v_theta + z10;
    const Scalar z237 = c_theta * a_theta - z99;
    const Scalar z238 = z10 * v_psi;
    const Scalar z239 = s_theta * a_psi + z238;
    const Scalar z240 = n1 / s_theta;
    const Scalar z241 = n1 / c_psi;
    const Scalar z242 = s_theta * s_theta;
    const Scalar z243 = n1 + s_theta * s_theta / z98;
    const Scalar z244 = z98 * z243;
    const Scalar z245 = c_psi * c_psi;
    const Scalar z246 = n1 + c_theta * c_theta / z83 + n1 / p_C;
    const Scalar z247 = s_psi * z241;
    const Scalar z248 = s_psi * z247 + c_psi;
    const Scalar z249 = z240 * z248;
    const Scalar z250 = c_theta * z241;
    const Scalar z251 = s_psi * z250;
    const Scalar z252 = z240 * z251;
    const Scalar z253 = z240 * z247;
    const Scalar z254 = z27 * z241;
    const Scalar z255 = s_psi * z254 + z26;
    const Scalar z256 = z240 * z255;
    const Scalar z257 = z28 * z241;
    const Scalar z258 = z10 - s_psi * z257;
    const Scalar z259 = z240 * z258;
    const Scalar z260 = z28 * z249 + z148 * z247 + z149;
    const Scalar z261 = z28 * z252 + z148 * z250 - z233;
    const Scalar z262 = z28 * z253 + z148 * z241;
    const Scalar z263 = z148 - z149 * z247 + z236 * z249;
    const Scalar z264 = z26 - z149 * z250 + z236 * z252;
    const Scalar z265 = z149 * z241 - z236 * z253;
    const Scalar z266 = z241 * z260;
    const Scalar z267 = s_psi * z266 - z263;
    const Scalar z268 = z240 * z267;
    const Scalar z269 = z241 * z261;
    const Scalar z270 = s_psi * z269 - z264;
    const Scalar z271 = z240 * z270;
    const Scalar z272 = z241 * z262;
    const Scalar z273 = s_psi * z272 + z265;
    const Scalar z274 = z240 * z273;
    const Scalar z275 = z28 * z256 + z148 * z254;
    const Scalar z276 = z28 * z259 - z148 * z257;
    const Scalar z277 = z149 * z254 - z236 * z256;
    const Scalar z278 = z149 * z257 + z236 * z259;
    const Scalar z279 = z235 + z275;
    const Scalar z280 = z239 - z276;
    const Scalar z281 = z232 + z277;
    const Scalar z282 = z237 - z278;
    const Scalar z283 = z241 * z279;
    const Scalar z284 = s_psi * z283 + z281;
    const Scalar z285 = z240 * z284;
    const Scalar z286 = z241 * z280;
    const Scalar z287 = s_psi * z286 - z282;
    const Scalar z288 = z240 * z287;
    const Scalar z289 = z230 * z241;
    const Scalar z290 = s_psi * z289 - z229;
    const Scalar z291 = z240 * z290;
    const Scalar z292 = z98 * z249;
    const Scalar z293 = z98 * z252;
    const Scalar z294 = z98 * z253;
    const Scalar z295 = n1 + z247 * z247 + z249 * z292;
    const Scalar z296 = z247 * z250 + z252 * z292;
    const Scalar z297 = z241 * z247 + z253 * z292;
    const Scalar z299 = z83 + z250 * z250 + z252 * z293;
    const Scalar z300 = z74 + z241 * z250 + z253 * z293;
    const Scalar z303 = p_C + z241 * z241 + z253 * z294;
    const Scalar z304 = z247 * z266 + z268 * z292;
    const Scalar z305 = z247 * z269 + z271 * z292;
    const Scalar z306 = z247 * z272 + z274 * z292;
    const Scalar z307 = z250 * z266 + z268 * z293;
    const Scalar z308 = z250 * z269 + z271 * z293;
    const Scalar z309 = z250 * z272 + z274 * z293;
    const Scalar z310 = z241 * z266 + z268 * z294;
    const Scalar z311 = z241 * z269 + z271 * z294;
    const Scalar z312 = z241 * z272 + z274 * z294;
    const Scalar z313 = z212 * z249;
    const Scalar z314 = z204 - z212 * z252;
    const Scalar z315 = z212 * z253 + z228;
    const Scalar z316 = z219 * z249;
    const Scalar z317 = z208 - z219 * z252;
    const Scalar z318 = z211 + z219 * z253;
    const Scalar z319 = z211 * z249;
    const Scalar z320 = z203 - z211 * z252;
    const Scalar z321 = z211 * z253;
    const Scalar z322 = z249 * z316;
    const Scalar z323 = z249 * z317;
    const Scalar z324 = z249 * z318;
    const Scalar z325 = z252 * z316 + z313;
    const Scalar z326 = z252 * z317 + z314;
    const Scalar z327 = z252 * z318 + z315;
    const Scalar z328 = z253 * z316 - z319;
    const Scalar z329 = z253 * z317 - z320;
    const Scalar z330 = z253 * z318 - z321;
    const Scalar z331 = z304 - z322;
    const Scalar z332 = z305 + z323;
    const Scalar z333 = z306 - z324;
    const Scalar z334 = z307 - z325;
    const Scalar z335 = z308 + z326;
    const Scalar z336 = z309 - z327;
    const Scalar z337 = z310 - z328;
    const Scalar z338 = z311 + z329;
    const Scalar z339 = z312 - z330;
    const Scalar z340 = z247 * z283 + z285 * z292;
    const Scalar z341 = z247 * z286 + z288 * z292;
    const Scalar z342 = z250 * z283 + z285 * z293;
    const Scalar z343 = z250 * z286 + z288 * z293;
    const Scalar z344 = z241 * z283 + z285 * z294;
    const Scalar z345 = z241 * z286 + z288 * z294;
    const Scalar z346 = z212 * z256;
    const Scalar z347 = z212 * z259;
    const Scalar z348 = z219 * z256;
    const Scalar z349 = z219 * z259;
    const Scalar z350 = z211 * z256;
    const Scalar z351 = z211 * z259;
    const Scalar z352 = z217 - z347;
    const Scalar z353 = z226 - z349;
    const Scalar z354 = z215 - z351;
    const Scalar z355 = z198 * z247 - z199 - z249 * z348;
    const Scalar z356 = z249 * z353;
    const Scalar z357 = z198 * z250 - z252 * z348 - z346;
    const Scalar z358 = z252 * z353 + z352;
    const Scalar z359 = z198 * z241 - z253 * z348 + z350;
    const Scalar z360 = z253 * z353 - z354;
    const Scalar z361 = z340 + z355;
    const Scalar z362 = z341 - z356;
    const Scalar z363 = z342 + z357;
    const Scalar z364 = z343 - z358;
    const Scalar z365 = z344 + z359;
    const Scalar z366 = z345 - z360;
    const Scalar z367 = a_x + s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    const Scalar z368 = s_theta * l_lambda_along_y1 - z146;
    const Scalar z369 = a_y - s_psi * l_lambda_along_x1 - c_psi * l_lambda_along_y1 - z247 * z367 + z249 * z368;
    const Scalar z370 = c_theta * l_lambda_along_x1 - z139 + z250 * z367 - z252 * z368;
    const Scalar z371 = z134 - l_lambda_along_x1 - z241 * z367 + z253 * z368;
    const Scalar z372 = z247 * z289 + z291 * z292;
    const Scalar z373 = z250 * z289 + z291 * z293;
    const Scalar z374 = z241 * z289 + z291 * z294;
    const Scalar z375 = z369 + z372;
    const Scalar z376 = z370 - z373;
    const Scalar z377 = z371 + z374;
    const Scalar z378 = n1 / z303;
    const Scalar z379 = z297 * z378;
    const Scalar z380 = z300 * z378;
    const Scalar z381 = z295 - z297 * z379;
    const Scalar z382 = z296 - z297 * z380;
    const Scalar z383 = z299 - z300 * z380;
    const Scalar z384 = n1 / z383;
    const Scalar z385 = z382 * z384;
    const Scalar z386 = z381 - z382 * z385;
    const Scalar z387 = n1 / z386;
    const Scalar z388 = z334 - z337 * z380;
    const Scalar z389 = z331 - z337 * z379 - z385 * z388;
    const Scalar z390 = z387 * z389;
    const Scalar z391 = z384 * z388 - z385 * z390;
    const Scalar z392 = z337 * z378 - z379 * z390 - z380 * z391;
    const Scalar z393 = z335 - z338 * z380;
    const Scalar z394 = z332 - z338 * z379 - z385 * z393;
    const Scalar z395 = z387 * z394;
    const Scalar z396 = z384 * z393 - z385 * z395;
    const Scalar z397 = z338 * z378 - z379 * z395 - z380 * z396;
    const Scalar z398 = z363 - z365 * z380;
    const Scalar z399 = z361 - z365 * z379 - z385 * z398;
    const Scalar z400 = z387 * z399;
    const Scalar z401 = z384 * z398 - z385 * z400;
    const Scalar z402 = z365 * z378 - z379 * z400 - z380 * z401;
    const Scalar z403 = z336 - z339 * z380;
    const Scalar z404 = z333 - z339 * z379 - z385 * z403;
    const Scalar z405 = z387 * z404;
    const Scalar z406 = z384 * z403 - z385 * z405;
    const Scalar z407 = z339 * z378 - z379 * z405 - z380 * z406;
    const Scalar z408 = z364 - z366 * z380;
    const Scalar z409 = z362 - z366 * z379 - z385 * z408;
    const Scalar z410 = z387 * z409;
    const Scalar z411 = z384 * z408 - z385 * z410;
    const Scalar z412 = z366 * z378 - z379 * z410 - z380 * z411;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n1;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = z83;
    result.M[13] = n0;
    result.M[14] = z74;
    result.M[15] = n0;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = z98;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = z74;
    result.M[23] = n0;
    result.M[24] = p_C;
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
    result.C[12] = z204;
    result.C[13] = -z208;
    result.C[14] = -z203;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = z212;
    result.C[18] = -z219;
    result.C[19] = -z211;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = -z228;
    result.C[23] = z211;
    result.C[24] = n0;
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
    result.K[10] = z198;
    result.K[11] = z199;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = z217;
    result.K[18] = -z226;
    result.K[19] = -z215;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.F[0] = -a_x - s_psi * l_lambda_along_y1 + c_psi * l_lambda_along_x1;
    result.F[1] = -a_y + s_psi * l_lambda_along_x1 + c_psi * l_lambda_along_y1;
    result.F[2] = c_theta * l_lambda_along_x1 - z139;
    result.F[3] = s_theta * l_lambda_along_y1 - z146;
    result.F[4] = -z134 + l_lambda_along_x1;
    result.M_r[0] = z295;
    result.M_r[1] = z296;
    result.M_r[2] = z297;
    result.M_r[3] = z296;
    result.M_r[4] = z299;
    result.M_r[5] = z300;
    result.M_r[6] = z297;
    result.M_r[7] = z300;
    result.M_r[8] = z303;
    result.C_r[0] = z331;
    result.C_r[1] = z334;
    result.C_r[2] = z337;
    result.C_r[3] = z332;
    result.C_r[4] = z335;
    result.C_r[5] = z338;
    result.C_r[6] = z333;
    result.C_r[7] = z336;
    result.C_r[8] = z339;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = -z361;
    result.K_r[7] = -z363;
    result.K_r[8] = -z365;
    result.K_r[9] = -z362;
    result.K_r[10] = -z364;
    result.K_r[11] = -z366;
    result.K_r[12] = n0;
    result.K_r[13] = n0;
    result.K_r[14] = n0;
    result.F_r[0] = -z375;
    result.F_r[1] = z376;
    result.F_r[2] = -z377;
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
    result.A[16] = z254;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = z256;
    result.A[20] = n0;
    result.A[21] = z400;
    result.A[22] = z401;
    result.A[23] = z402;
    result.A[24] = z257;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = -z259;
    result.A[28] = n0;
    result.A[29] = z410;
    result.A[30] = z411;
    result.A[31] = z412;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = -z247;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = -z249;
    result.A[44] = n0;
    result.A[45] = -z390;
    result.A[46] = -z391;
    result.A[47] = -z392;
    result.A[48] = -z250;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = -z252;
    result.A[52] = n0;
    result.A[53] = -z395;
    result.A[54] = -z396;
    result.A[55] = -z397;
    result.A[56] = -z241;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = -z253;
    result.A[60] = n1;
    result.A[61] = -z405;
    result.A[62] = -z406;
    result.A[63] = -z407;
    if (!(traits::regular(z242, z244) && traits::regular(z245, z246) && traits::regular(z386, z295)
        && traits::regular(z383, z299) && traits::regular(z303, z303))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((result.M[12] - result.M[12]) + (result.M[14] - result.M[14]) + (result.M[18] - result.M[18])
        + (result.M[22] - result.M[22]) + (result.M[24] - result.M[24]) + (result.C[12] - result.C[12]) + (result.C[13]
        - result.C[13]) + (result.C[14] - result.C[14]) + (result.C[17] - result.C[17])) + ((result.C[18]
        - result.C[18]) + (result.C[19] - result.C[19]) + (result.C[22] - result.C[22]) + (result.C[23] - result.C[23])
        + (result.K[10] - result.K[10]) + (result.K[11] - result.K[11]) + (result.K[17] - result.K[17]) + (result.K[18]
        - result.K[18]) + (result.K[19] - result.K[19]))) + (((result.F[0] - result.F[0]) + (result.F[1] - result.F[1])
        + (result.F[2] - result.F[2]) + (result.F[3] - result.F[3]) + (result.F[4] - result.F[4]) + (result.M_r[0]
        - result.M_r[0]) + (result.M_r[1] - result.M_r[1]) + (result.M_r[2] - result.M_r[2]) + (result.M_r[3]
        - result.M_r[3])) + ((result.M_r[4] - result.M_r[4]) + (result.M_r[5] - result.M_r[5]) + (result.M_r[6]
        - result.M_r[6]) + (result.M_r[7] - result.M_r[7]) + (result.M_r[8] - result.M_r[8]) + (result.C_r[0]
        - result.C_r[0]) + (result.C_r[1] - result.C_r[1]) + (result.C_r[2] - result.C_r[2]) + (result.C_r[3]
        - result.C_r[3]) + (result.C_r[4] - result.C_r[4])))) + ((((result.C_r[5] - result.C_r[5]) + (result.C_r[6]
        - result.C_r[6]) + (result.C_r[7] - result.C_r[7]) + (result.C_r[8] - result.C_r[8]) + (result.K_r[6]
        - result.K_r[6]) + (result.K_r[7] - result.K_r[7]) + (result.K_r[8] - result.K_r[8]) + (result.K_r[9]
        - result.K_r[9]) + (result.K_r[10] - result.K_r[10])) + ((result.K_r[11] - result.K_r[11]) + (result.F_r[0]
        - result.F_r[0]) + (result.F_r[1] - result.F_r[1]) + (result.F_r[2] - result.F_r[2]) + (result.A[16]
        - result.A[16]) + (result.A[19] - result.A[19]) + (result.A[21] - result.A[21]) + (result.A[22] - result.A[22])
        + (result.A[23] - result.A[23]) + (result.A[24] - result.A[24]))) + (((result.A[27] - result.A[27])
        + (result.A[29] - result.A[29]) + (result.A[30] - result.A[30]) + (result.A[31] - result.A[31]) + (result.A[40]
        - result.A[40]) + (result.A[43] - result.A[43]) + (result.A[45] - result.A[45]) + (result.A[46] - result.A[46])
        + (result.A[47] - result.A[47])) + ((result.A[48] - result.A[48]) + (result.A[51] - result.A[51])
        + (result.A[53] - result.A[53]) + (result.A[54] - result.A[54]) + (result.A[55] - result.A[55]) + (result.A[56]
        - result.A[56]) + (result.A[59] - result.A[59]) + (result.A[61] - result.A[61]) + (result.A[62] - result.A[62])
        + (result.A[63] - result.A[63]))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Derivatives of inverse_dynamics at (q, v, a, lambda). That by accelerations is the mass matrix.
  TORSOR_DEVICE static void inverse_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, InverseDynamicsDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z13 = c_theta * a_theta - v_theta * z11;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z104 = v_theta * z28;  // angular acceleration of hoop.2, z
    const Scalar z108 = v_theta * z36;
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z111 = p_C * z104;  // moment on hoop, z
    const Scalar z122 = n9_81 + z13;
    const Scalar z125 = s_theta * a_psi;
    const Scalar z126 = c_theta * a_psi;
    const Scalar z129 = v_theta * z29 + z125;  // angular acceleration of hoop.2, y
    const Scalar z130 = v_theta * z28 - z126;  // angular acceleration of hoop.2, z
    const Scalar z133 = a_phi - z130;  // angular acceleration of hoop, z
    const Scalar z134 = p_C * z133;  // moment on hoop, z
    const Scalar z135 = z103 + z129;
    const Scalar z137 = p_A * z135 - z110;  // moment on hoop.2, y
    const Scalar z181 = p_C * z36;
    const Scalar z198 = s_psi * l_lambda_along_x1 + c_psi * l_lambda_along_y1;
    const Scalar z199 = s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    const Scalar z200 = n2 * z10;
    const Scalar z201 = z10 * p_C;
    const Scalar z202 = p_A * z200 - z201;
    const Scalar z203 = z11 * p_C;
    const Scalar z204 = s_theta * z202 - c_theta * z203;
    const Scalar z205 = s_theta * z29 + c_theta * z28;
    const Scalar z206 = s_theta * z36 + c_theta * z28;
    const Scalar z207 = p_C * z206;
    const Scalar z208 = p_A * z205 - z207;
    const Scalar z209 = n2 * z29;
    const Scalar z210 = p_A * z209 - z181;
    const Scalar z211 = p_C * z28;
    const Scalar z212 = s_theta * z210 - c_theta * z211;
    const Scalar z213 = z104 + z130;
    const Scalar z214 = p_A * z213 - z111;
    const Scalar z215 = p_C * z129;
    const Scalar z216 = s_theta * (z134 + z214) - c_theta * (z137 - z215);
    const Scalar z217 = s_theta * l_lambda_along_x1 - z216;
    const Scalar z218 = s_theta * v_theta + z11;
    const Scalar z219 = c_theta * z218;
    const Scalar z220 = s_theta * a_theta + v_theta * z10;
    const Scalar z221 = z28 * z28 - z29 * z29;
    const Scalar z222 = z28 * z28 - z29 * z36;
    const Scalar z223 = p_C * z222;
    const Scalar z224 = p_A * z221 - z223;
    const Scalar z225 = s_theta * z122 + c_theta * z220 - z224;
    const Scalar z226 = c_theta * l_lambda_along_y1 + z225;
    const Scalar z227 = v_theta * p_C;
    const Scalar z228 = s_theta * z227;
    result.by_position[0] = n0;
    result.by_position[1] = n0;
    result.by_position[2] = n0;
    result.by_position[3] = n0;
    result.by_position[4] = n0;
    result.by_position[5] = n0;
    result.by_position[6] = n0;
    result.by_position[7] = n0;
    result.by_position[8] = n0;
    result.by_position[9] = n0;
    result.by_position[10] = z198;
    result.by_position[11] = z199;
    result.by_position[12] = n0;
    result.by_position[13] = n0;
    result.by_position[14] = n0;
    result.by_position[15] = n0;
    result.by_position[16] = n0;
    result.by_position[17] = z217;
    result.by_position[18] = -z226;
    result.by_position[19] = -z215;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = n0;
    result.by_velocity[1] = n0;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = n0;
    result.by_velocity[4] = n0;
    result.by_velocity[5] = n0;
    result.by_velocity[6] = n0;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = n0;
    result.by_velocity[9] = n0;
    result.by_velocity[10] = n0;
    result.by_velocity[11] = n0;
    result.by_velocity[12] = z204;
    result.by_velocity[13] = -z208;
    result.by_velocity[14] = -z203;
    result.by_velocity[15] = n0;
    result.by_velocity[16] = n0;
    result.by_velocity[17] = z212;
    result.by_velocity[18] = -z219;
    result.by_velocity[19] = -z211;
    result.by_velocity[20] = n0;
    result.by_velocity[21] = n0;
    result.by_velocity[22] = -z228;
    result.by_velocity[23] = z211;
    result.by_velocity[24] = n0;
  }

  /// Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by
  /// solving with the factorisation of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z79 = precomputed.z79;
    const Scalar z155 = precomputed.z155;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z26 = v_x * c_psi + v_y * s_psi;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z74 = c_theta * p_C;
    const Scalar z80 = s_theta * z79;
    const Scalar z81 = s_theta * z80;
    const Scalar z83 = p_C + z81;
    const Scalar z98 = c_theta * c_theta + p_A;
    const Scalar z99 = v_theta * z11;
    const Scalar z100 = n9_81 - z99;
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z104 = v_theta * z28;  // angular acceleration of hoop.2, z
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z109 = p_C * z107;  // moment on hoop, x
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z111 = p_C * z104;  // moment on hoop, z
    const Scalar z112 = z28 * z29;
    const Scalar z113 = n2 * z103;
    const Scalar z114 = p_A * z112 - z109;  // moment on hoop.2, x
    const Scalar z115 = p_A * z113 - z110;  // moment on hoop.2, y
    const Scalar z117 = s_theta * z115 - c_theta * z111;
    const Scalar z121 = c_theta * z100 - z114;
    const Scalar z148 = v_psi * s_psi;
    const Scalar z149 = v_psi * c_psi;
    const Scalar z150 = v_x * z148 - v_y * z149 + z11 * v_psi;
    const Scalar z152 = v_x * z149 + v_y * z148 - v_theta * z10;
    const Scalar z156 = z74 * z155;
    const Scalar z157 = z74 * z156 - z83;
    const Scalar z158 = n1 / z98;
    const Scalar z159 = n1 / z157;
    const Scalar z160 = c_theta - z156;
    const Scalar z161 = z159 * z160;
    const Scalar z162 = z155 + z156 * z161;
    const Scalar z163 = s_theta * z158;
    const Scalar z164 = n1 - c_theta * z161 + z162;
    const Scalar z165 = n1 + s_theta * z163;
    const Scalar z166 = n1 / z165;
    const Scalar z167 = n1 / z164;
    const Scalar z168 = z111 * z156 + z117;
    const Scalar z169 = z159 * z168;
    const Scalar z170 = z121 * z158;
    const Scalar z171 = z111 * z155 - z156 * z169;
    const Scalar z172 = c_theta * z169 - z150 + z171;
    const Scalar z173 = s_theta * z170 + z152;
    const Scalar z174 = z167 * z172;
    const Scalar z175 = z166 * z173;
    const Scalar z176 = s_psi * z175 + c_psi * z174;
    const Scalar z177 = s_psi * z174 - c_psi * z175;
    const Scalar z178 = z161 * z174 + z169;
    const Scalar z179 = z163 * z175 - z170;
    const Scalar z180 = z162 * z174 - z171;
    const Scalar z181 = p_C * z36;
    const Scalar z200 = n2 * z10;
    const Scalar z201 = z10 * p_C;
    const Scalar z202 = p_A * z200 - z201;
    const Scalar z203 = z11 * p_C;
    const Scalar z204 = s_theta * z202 - c_theta * z203;
    const Scalar z205 = s_theta * z29 + c_theta * z28;
    const Scalar z206 = s_theta * z36 + c_theta * z28;
    const Scalar z207 = p_C * z206;
    const Scalar z208 = p_A * z205 - z207;
    const Scalar z209 = n2 * z29;
    const Scalar z210 = p_A * z209 - z181;
    const Scalar z211 = p_C * z28;
    const Scalar z212 = s_theta * z210 - c_theta * z211;
    const Scalar z218 = s_theta * v_theta + z11;
    const Scalar z219 = c_theta * z218;
    const Scalar z221 = z28 * z28 - z29 * z29;
    const Scalar z222 = z28 * z28 - z29 * z36;
    const Scalar z223 = p_C * z222;
    const Scalar z224 = p_A * z221 - z223;
    const Scalar z227 = v_theta * p_C;
    const Scalar z228 = s_theta * z227;
    const Scalar z231 = v_x * z148 - v_y * z149;
    const Scalar z233 = v_x * s_psi - v_y * c_psi + z11;
    const Scalar z234 = v_x * z149 + v_y * z148;
    const Scalar z236 = c_theta * v_theta + z10;
    const Scalar z238 = z10 * v_psi;
    const Scalar z413 = z148 * z167;
    const Scalar z414 = z149 * z166;
    const Scalar z415 = s_psi * z414 - c_psi * z413;
    const Scalar z416 = s_psi * z413 + c_psi * z414;
    const Scalar z418 = z163 * z414;
    const Scalar z419 = z162 * z413;
    const Scalar z420 = c_psi * z167;
    const Scalar z421 = s_psi * z166;
    const Scalar z422 = n1 - s_psi * z421 - c_psi * z420;
    const Scalar z427 = z149 * z167;
    const Scalar z428 = z148 * z166;
    const Scalar z429 = s_psi * z428 + c_psi * z427;
    const Scalar z430 = s_psi * z427 - c_psi * z428;
    const Scalar z432 = z163 * z428;
    const Scalar z433 = z162 * z427;
    const Scalar z434 = s_psi * z167;
    const Scalar z435 = c_psi * z166;
    const Scalar z436 = s_psi * z435 - c_psi * z434;
    const Scalar z437 = n1 - s_psi * z434 - c_psi * z435;
    const Scalar z441 = s_psi * z176 - c_psi * z177 - z234;
    const Scalar z442 = s_psi * z177 + c_psi * z176 + z231;
    const Scalar z443 = s_psi * z176 - c_psi * z177 - z441;
    const Scalar z444 = s_psi * z177 + c_psi * z176 - z442;
    const Scalar z445 = z167 * z443;
    const Scalar z446 = z166 * z444;
    const Scalar z447 = s_psi * z446 - c_psi * z445 - z177;
    const Scalar z448 = s_psi * z445 + c_psi * z446 - z176;
    const Scalar z450 = z163 * z446;
    const Scalar z451 = z162 * z445;
    const Scalar z452 = z156 * z203 + z204;
    const Scalar z453 = z159 * z452;
    const Scalar z454 = z158 * z208;
    const Scalar z455 = z155 * z203 - z156 * z453;
    const Scalar z456 = c_theta * z453 - z233 + z455;
    const Scalar z457 = s_theta * z454 - z26;
    const Scalar z458 = z167 * z456;
    const Scalar z459 = z166 * z457;
    const Scalar z460 = s_psi * z459 - c_psi * z458;
    const Scalar z461 = s_psi * z458 + c_psi * z459;
    const Scalar z462 = z161 * z458 + z453;
    const Scalar z463 = z163 * z459 - z454;
    const Scalar z464 = z162 * z458 - z455;
    const Scalar z465 = z156 * z159;
    const Scalar z466 = c_theta * z159 - z465;
    const Scalar z467 = z167 * z466;
    const Scalar z470 = z159 + z161 * z467;
    const Scalar z472 = s_theta * z178 + z238;
    const Scalar z473 = c_theta * z179 - z99;
    const Scalar z474 = c_theta * z178;
    const Scalar z475 = v_theta * z28 - z474;  // angular acceleration of hoop.2, z
    const Scalar z476 = z180 + z475;  // angular acceleration of hoop, z
    const Scalar z477 = p_C * z476;  // moment on hoop, z
    const Scalar z478 = z104 + z475;
    const Scalar z479 = p_A * z478 - z111;
    const Scalar z480 = s_theta * z178;
    const Scalar z481 = v_theta * z29 + z480;  // angular acceleration of hoop.2, y
    const Scalar z482 = z103 + z481;
    const Scalar z483 = p_A * z482 - z110;  // moment on hoop.2, y
    const Scalar z484 = p_C * z481;
    const Scalar z485 = s_theta * (z477 - z479) + c_theta * (z483 - z484);
    const Scalar z486 = s_theta * z174 - z485;
    const Scalar z487 = c_theta * z179 - v_theta * z11;
    const Scalar z488 = n9_81 + z487;
    const Scalar z489 = s_theta * z179 + v_theta * z10;
    const Scalar z490 = s_theta * z488 + c_theta * z489 - z224;
    const Scalar z491 = c_theta * z175 + z490;
    const Scalar z492 = z156 * z484 - z486;
    const Scalar z493 = z159 * z492;
    const Scalar z494 = z158 * z491;
    const Scalar z495 = z155 * z484 - z156 * z493;
    const Scalar z496 = c_theta * z493 - z472 + z495;
    const Scalar z497 = s_theta * z494 + z473;
    const Scalar z498 = z167 * z496;
    const Scalar z499 = z166 * z497;
    const Scalar z500 = s_psi * z499 - c_psi * z498;
    const Scalar z501 = s_psi * z498 + c_psi * z499;
    const Scalar z502 = z161 * z498 + z493;
    const Scalar z503 = z163 * z499 - z494;
    const Scalar z504 = z162 * z498 - z495;
    const Scalar z505 = z156 * z211 + z212;
    const Scalar z506 = z159 * z505;
    const Scalar z507 = z158 * z219;
    const Scalar z508 = z155 * z211 - z156 * z506;
    const Scalar z509 = c_theta * z506 - z28 + z508;
    const Scalar z510 = s_theta * z507 + z236;
    const Scalar z511 = z167 * z509;
    const Scalar z512 = z166 * z510;
    const Scalar z513 = s_psi * z512 - c_psi * z511;
    const Scalar z514 = s_psi * z511 + c_psi * z512;
    const Scalar z515 = z161 * z511 + z506;
    const Scalar z517 = z162 * z511 - z508;
    const Scalar z518 = z163 * z166;
    const Scalar z519 = s_psi * z518;
    const Scalar z520 = c_psi * z518;
    const Scalar z521 = z158 - z163 * z518;
    const Scalar z522 = z159 * z228;
    const Scalar z523 = z158 * z211;
    const Scalar z524 = z156 * z522;
    const Scalar z525 = c_theta * z522 - z524;
    const Scalar z526 = s_theta * z523;
    const Scalar z527 = z167 * z525;
    const Scalar z528 = z166 * z526;
    const Scalar z529 = s_psi * z528 - c_psi * z527;
    const Scalar z530 = s_psi * z527 + c_psi * z528;
    const Scalar z531 = z161 * z527 + z522;
    const Scalar z532 = z163 * z528 - z523;
    const Scalar z533 = z162 * z527 + z524;
    const Scalar z534 = z155 - z156 * z465;
    const Scalar z535 = c_theta * z465 + z534;
    const Scalar z536 = z167 * z535;
    const Scalar z537 = c_psi * z536;
    const Scalar z538 = s_psi * z536;
    const Scalar z539 = z161 * z536 + z465;
    const Scalar z540 = z162 * z536 - z534;
    result.by_position[0] = n0;
    result.by_position[1] = n0;
    result.by_position[2] = n0;
    result.by_position[3] = n0;
    result.by_position[4] = n0;
    result.by_position[5] = n0;
    result.by_position[6] = n0;
    result.by_position[7] = n0;
    result.by_position[8] = n0;
    result.by_position[9] = n0;
    result.by_position[10] = -z447;
    result.by_position[11] = z448;
    result.by_position[12] = n0;
    result.by_position[13] = z450;
    result.by_position[14] = z451;
    result.by_position[15] = z500;
    result.by_position[16] = -z501;
    result.by_position[17] = z502;
    result.by_position[18] = -z503;
    result.by_position[19] = -z504;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = -z415;
    result.by_velocity[1] = z416;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = z418;
    result.by_velocity[4] = z419;
    result.by_velocity[5] = -z429;
    result.by_velocity[6] = -z430;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = z432;
    result.by_velocity[9] = -z433;
    result.by_velocity[10] = z460;
    result.by_velocity[11] = -z461;
    result.by_velocity[12] = z462;
    result.by_velocity[13] = -z463;
    result.by_velocity[14] = -z464;
    result.by_velocity[15] = z513;
    result.by_velocity[16] = -z514;
    result.by_velocity[17] = z515;
    result.by_velocity[18] = n0;
    result.by_velocity[19] = -z517;
    result.by_velocity[20] = -z529;
    result.by_velocity[21] = z530;
    result.by_velocity[22] = -z531;
    result.by_velocity[23] = z532;
    result.by_velocity[24] = z533;
    result.by_force[0] = z422;
    result.by_force[1] = z436;
    result.by_force[2] = n0;
    result.by_force[3] = z519;
    result.by_force[4] = -z537;
    result.by_force[5] = z436;
    result.by_force[6] = z437;
    result.by_force[7] = n0;
    result.by_force[8] = -z520;
    result.by_force[9] = -z538;
    result.by_force[10] = n0;
    result.by_force[11] = n0;
    result.by_force[12] = -z470;
    result.by_force[13] = n0;
    result.by_force[14] = z539;
    result.by_force[15] = z519;
    result.by_force[16] = -z520;
    result.by_force[17] = n0;
    result.by_force[18] = z521;
    result.by_force[19] = n0;
    result.by_force[20] = -z537;
    result.by_force[21] = -z538;
    result.by_force[22] = z539;
    result.by_force[23] = n0;
    result.by_force[24] = -z540;
    result.multipliers_by_position[0] = n0;
    result.multipliers_by_position[1] = n0;
    result.multipliers_by_position[2] = n0;
    result.multipliers_by_position[3] = n0;
    result.multipliers_by_position[4] = z445;
    result.multipliers_by_position[5] = z446;
    result.multipliers_by_position[6] = n0;
    result.multipliers_by_position[7] = -z499;
    result.multipliers_by_position[8] = n0;
    result.multipliers_by_position[9] = n0;
    result.multipliers_by_velocity[0] = z413;
    result.multipliers_by_velocity[1] = z414;
    result.multipliers_by_velocity[2] = -z427;
    result.multipliers_by_velocity[3] = z428;
    result.multipliers_by_velocity[4] = -z458;
    result.multipliers_by_velocity[5] = -z459;
    result.multipliers_by_velocity[6] = n0;
    result.multipliers_by_velocity[7] = -z512;
    result.multipliers_by_velocity[8] = n0;
    result.multipliers_by_velocity[9] = z528;
    result.multipliers_by_force[0] = -z420;
    result.multipliers_by_force[1] = z421;
    result.multipliers_by_force[2] = -z434;
    result.multipliers_by_force[3] = -z435;
    result.multipliers_by_force[4] = n0;
    result.multipliers_by_force[5] = n0;
    result.multipliers_by_force[6] = n0;
    result.multipliers_by_force[7] = -z518;
    result.multipliers_by_force[8] = -z536;
    result.multipliers_by_force[9] = n0;
    if (!(traits::regular(-z157, z83) && traits::regular(z98, z98) && traits::regular(p_C, p_C) && traits::regular(z164,
        z164) && traits::regular(z165, z165))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((result.by_position[10] - result.by_position[10]) + (result.by_position[11]
        - result.by_position[11]) + (result.by_position[13] - result.by_position[13]) + (result.by_position[14]
        - result.by_position[14]) + (result.by_position[15] - result.by_position[15]) + (result.by_position[16]
        - result.by_position[16]) + (result.by_position[17] - result.by_position[17]) + (result.by_position[18]
        - result.by_position[18]) + (result.by_position[19] - result.by_position[19]) + (result.by_velocity[0]
        - result.by_velocity[0]) + (result.by_velocity[1] - result.by_velocity[1]) + (result.by_velocity[3]
        - result.by_velocity[3]) + (result.by_velocity[4] - result.by_velocity[4]) + (result.by_velocity[5]
        - result.by_velocity[5]) + (result.by_velocity[6] - result.by_velocity[6]) + (result.by_velocity[8]
        - result.by_velocity[8])) + ((result.by_velocity[9] - result.by_velocity[9]) + (result.by_velocity[10]
        - result.by_velocity[10]) + (result.by_velocity[11] - result.by_velocity[11]) + (result.by_velocity[12]
        - result.by_velocity[12]) + (result.by_velocity[13] - result.by_velocity[13]) + (result.by_velocity[14]
        - result.by_velocity[14]) + (result.by_velocity[15] - result.by_velocity[15]) + (result.by_velocity[16]
        - result.by_velocity[16]) + (result.by_velocity[17] - result.by_velocity[17]) + (result.by_velocity[19]
        - result.by_velocity[19]) + (result.by_velocity[20] - result.by_velocity[20]) + (result.by_velocity[21]
        - result.by_velocity[21]) + (result.by_velocity[22] - result.by_velocity[22]) + (result.by_velocity[23]
        - result.by_velocity[23]) + (result.by_velocity[24] - result.by_velocity[24]) + (result.by_force[0]
        - result.by_force[0]))) + (((result.by_force[1] - result.by_force[1]) + (result.by_force[3]
        - result.by_force[3]) + (result.by_force[4] - result.by_force[4]) + (result.by_force[5] - result.by_force[5])
        + (result.by_force[6] - result.by_force[6]) + (result.by_force[8] - result.by_force[8]) + (result.by_force[9]
        - result.by_force[9]) + (result.by_force[12] - result.by_force[12]) + (result.by_force[14]
        - result.by_force[14]) + (result.by_force[15] - result.by_force[15]) + (result.by_force[16]
        - result.by_force[16]) + (result.by_force[18] - result.by_force[18]) + (result.by_force[20]
        - result.by_force[20]) + (result.by_force[21] - result.by_force[21]) + (result.by_force[22]
        - result.by_force[22]) + (result.by_force[24] - result.by_force[24])) + (((result.multipliers_by_position[4]
        - result.multipliers_by_position[4]) + (result.multipliers_by_position[5] - result.multipliers_by_position[5])
        + (result.multipliers_by_position[7] - result.multipliers_by_position[7]) + (result.multipliers_by_velocity[0]
        - result.multipliers_by_velocity[0]) + (result.multipliers_by_velocity[1] - result.multipliers_by_velocity[1])
        + (result.multipliers_by_velocity[2] - result.multipliers_by_velocity[2]) + (result.multipliers_by_velocity[3]
        - result.multipliers_by_velocity[3]) + (result.multipliers_by_velocity[4] - result.multipliers_by_velocity[4]))
        + ((result.multipliers_by_velocity[5] - result.multipliers_by_velocity[5]) + (result.multipliers_by_velocity[7]
        - result.multipliers_by_velocity[7]) + (result.multipliers_by_velocity[9] - result.multipliers_by_velocity[9])
        + (result.multipliers_by_force[0] - result.multipliers_by_force[0]) + (result.multipliers_by_force[1]
        - result.multipliers_by_force[1]) + (result.multipliers_by_force[2] - result.multipliers_by_force[2])
        + (result.multipliers_by_force[3] - result.multipliers_by_force[3]) + (result.multipliers_by_force[7]
        - result.multipliers_by_force[7]) + (result.multipliers_by_force[8] - result.multipliers_by_force[8]))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 41 operations take a convolution at each order.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, const Inputs&, int order,
      std::array<Scalar, 10>* coefficients) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_theta = state.q.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z79 = precomputed.z79;
    const Scalar z155 = precomputed.z155;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z74 = c_theta * p_C;
    const Scalar z80 = s_theta * z79;
    const Scalar z81 = s_theta * z80;
    const Scalar z83 = p_C + z81;
    const Scalar z98 = c_theta * c_theta + p_A;
    const Scalar z156 = z74 * z155;
    const Scalar z157 = z74 * z156 - z83;
    const Scalar z158 = n1 / z98;
    const Scalar z159 = n1 / z157;
    const Scalar z160 = c_theta - z156;
    const Scalar z161 = z159 * z160;
    const Scalar z162 = z155 + z156 * z161;
    const Scalar z163 = s_theta * z158;
    const Scalar z164 = n1 - c_theta * z161 + z162;
    const Scalar z165 = n1 + s_theta * z163;
    const Scalar b5 = state.v.theta;
    const Scalar b8 = state.v.psi;
    const Scalar b6 = s_theta * b5;
    const Scalar f0 = precomputed.y0;
    const Scalar b12 = c_theta * b8;
    const Scalar b11 = state.v.phi;
    const Scalar b13 = b11 + b12;
    const Scalar b15 = f0 * b12 - p_C * b13;
    const Scalar b16 = b5 * b15;
    const Scalar b14 = b6 * b8;
    const Scalar f1 = precomputed.y1;
    const Scalar f2 = precomputed.y2;
    const Scalar b23 = c_theta * c_theta;
    const Scalar b25 = s_theta * s_theta;
    const Scalar b26 = -p_C + f1 * b23 - z79 * b25;
    const Scalar i28 = n1 / b26;
    const Scalar b24 = p_A + b23;
    const Scalar i30 = n1 / b24;
    const Scalar f3 = precomputed.y4;
    const Scalar b18 = c_theta * b14;
    const Scalar b17 = s_theta * b16;
    const Scalar b34 = -f3 * b18 + b17;
    const Scalar b35 = b34 / b26;
    const Scalar i35 = n1 / b26;
    const Scalar b36 = p_A * b12 - p_C * b13;
    const Scalar b37 = b8 * b36;
    const Scalar b19 = b5 * b6;
    const Scalar b20 = -n9_81 + b19;
    const Scalar b39 = c_theta * b20;
    const Scalar b38 = s_theta * b37;
    const Scalar b40 = b39 + b38;
    const Scalar b41 = b40 / b24;
    const Scalar i41 = n1 / b24;
    const Scalar f4 = precomputed.y5;
    const Scalar b21 = b8 * s_psi;
    const Scalar b0 = state.v.x;
    const Scalar b22 = b8 * c_psi;
    const Scalar b1 = state.v.y;
    const Scalar b44 = b0 * b21;
    const Scalar b45 = b1 * b22;
    const Scalar b42 = c_theta * b35;
    const Scalar b46 = f2 * b14 + b44 - b45 - f2 * b42;
    const Scalar f5 = precomputed.y3;
    const Scalar b29 = c_theta * z161;
    const Scalar b33 = -f5 + f2 * b29;
    const Scalar b47 = b46 / b33;
    const Scalar i47 = n1 / b33;
    const Scalar b51 = b5 * b5;
    const Scalar b52 = c_theta * b51;
    const Scalar b49 = b0 * b22;
    const Scalar b50 = b1 * b21;
    const Scalar b48 = s_theta * b41;
    const Scalar b53 = b52 - b49 - b50 + b48;
    const Scalar b31 = s_theta * z163;
    const Scalar b32 = n1 + b31;
    const Scalar b54 = b53 / b32;
    const Scalar i54 = n1 / b32;
    const Scalar b55 = z155 + f4 * b29;
    const Scalar b56 = s_psi * b54;
    const Scalar b57 = c_psi * b47;
    const Scalar b58 = s_psi * b47;
    const Scalar b59 = c_psi * b54;
    const Scalar b60 = z161 * b47;
    const Scalar b61 = z163 * b54;
    const Scalar b43 = f4 * b14 - f4 * b42;
    const Scalar b62 = b47 * b55;
    coefficients[0][0] = state.q.x;
    coefficients[0][1] = state.q.y;
    coefficients[0][2] = state.q.psi;
    coefficients[0][3] = state.q.theta;
    coefficients[0][4] = state.q.phi;
    coefficients[0][5] = state.v.x;
    coefficients[0][6] = state.v.y;
    coefficients[0][7] = state.v.psi;
    coefficients[0][8] = state.v.theta;
    coefficients[0][9] = state.v.phi;
    coefficients[1][0] = b0;
    coefficients[1][1] = b1;
    coefficients[1][2] = b8;
    coefficients[1][3] = b5;
    coefficients[1][4] = b11;
    coefficients[1][5] = b56 - b57;
    coefficients[1][6] = -b58 - b59;
    coefficients[1][7] = b35 + b60;
    coefficients[1][8] = b41 - b61;
    coefficients[1][9] = b43 - b62;
    torsor::Convolutions<Scalar, 41> operations_;
    typename torsor::Convolutions<Scalar, 41>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][5];
      const Scalar x1 = coefficients[k_][6];
      const Scalar x2 = coefficients[k_][3];
      const Scalar x3 = inverse_ * sums_[0] + c_theta * x2;
      const Scalar w2 = number_ * x2;
      const Scalar x4 = -inverse_ * sums_[1] - s_theta * x2;
      const Scalar x5 = coefficients[k_][8];
      const Scalar x6 = sums_[2] + s_theta * x5 + b5 * x3;
      const Scalar x7 = coefficients[k_][2];
      const Scalar x8 = coefficients[k_][7];
      const Scalar x9 = inverse_ * sums_[3] + c_psi * x7;
      const Scalar w7 = number_ * x7;
      const Scalar x10 = -inverse_ * sums_[4] - s_psi * x7;
      const Scalar x11 = coefficients[k_][9];
      const Scalar x12 = sums_[5] + c_theta * x8 + b8 * x4;
      const Scalar x13 = x11 + x12;
      const Scalar x14 = sums_[6] + b6 * x8 + b8 * x6;
      const Scalar x15 = f0 * x12 - p_C * x13;
      const Scalar x16 = sums_[7] + b15 * x5 + b5 * x15;  // moment on hoop.2, y
      const Scalar x17 = sums_[8] + b16 * x3 + s_theta * x16;
      const Scalar x18 = sums_[9] + b14 * x4 + c_theta * x14;
      const Scalar x19 = sums_[10] + b6 * x5 + b5 * x6;
      const Scalar x20 = x19;
      const Scalar x21 = sums_[11] + s_psi * x8 + b8 * x9;
      const Scalar x22 = sums_[12] + c_psi * x8 + b8 * x10;
      const Scalar x23 = sums_[13] + (c_theta + c_theta) * x4;
      const Scalar x24 = x23;
      const Scalar x25 = sums_[14] + (s_theta + s_theta) * x3;
      const Scalar x26 = f1 * x23 - z79 * x25;
      const Scalar x27 = f2 * x4;
      const Scalar x28 = (x27 - sums_[15] - z161 * x26) * i28;
      const Scalar x29 = sums_[16] + z161 * x4 + c_theta * x28;
      const Scalar x30 = (x3 - sums_[17] - z163 * x24) * i30;
      const Scalar x31 = sums_[18] + z163 * x3 + s_theta * x30;
      const Scalar x32 = x31;
      const Scalar x33 = f2 * x29;
      const Scalar x34 = -f3 * x18 + x17;
      const Scalar x35 = (x34 - (sums_[19] + b35 * x26)) * i35;
      const Scalar x36 = p_A * x12 - p_C * x13;
      const Scalar x37 = sums_[20] + b36 * x8 + b8 * x36;
      const Scalar x38 = sums_[21] + b37 * x3 + s_theta * x37;
      const Scalar x39 = sums_[22] + b20 * x4 + c_theta * x20;
      const Scalar x40 = x39 + x38;
      const Scalar x41 = (x40 - (sums_[23] + b41 * x24)) * i41;
      const Scalar x42 = sums_[24] + b35 * x4 + c_theta * x35;
      const Scalar x43 = f4 * x14 - f4 * x42;
      const Scalar x44 = sums_[25] + b21 * x0 + b0 * x21;
      const Scalar x45 = sums_[26] + b22 * x1 + b1 * x22;
      const Scalar x46 = f2 * x14 + x44 - x45 - f2 * x42;
      const Scalar x47 = (x46 - (sums_[27] + b47 * x33)) * i47;
      const Scalar x48 = sums_[28] + b41 * x3 + s_theta * x41;
      const Scalar x49 = sums_[29] + b22 * x0 + b0 * x22;
      const Scalar x50 = sums_[30] + b21 * x1 + b1 * x21;
      const Scalar x51 = sums_[31] + (b5 + b5) * x5;
      const Scalar x52 = sums_[32] + c_theta * x51 + b51 * x4;
      const Scalar x53 = x52 - x49 - x50 + x48;
      const Scalar x54 = (x53 - (sums_[33] + b54 * x32)) * i54;
      const Scalar x55 = f4 * x29;
      const Scalar x56 = sums_[34] + b54 * x9 + s_psi * x54;
      const Scalar x57 = sums_[35] + b47 * x10 + c_psi * x47;
      const Scalar x58 = sums_[36] + b47 * x9 + s_psi * x47;
      const Scalar x59 = sums_[37] + b54 * x10 + c_psi * x54;
      const Scalar x60 = sums_[38] + b47 * x28 + z161 * x47;
      const Scalar x61 = sums_[39] + b54 * x30 + z163 * x54;
      const Scalar x62 = sums_[40] + b47 * x55 + b55 * x47;
      coefficients[k_ + 1][0] = next_ * x0;
      coefficients[k_ + 1][1] = next_ * x1;
      coefficients[k_ + 1][2] = next_ * x8;
      coefficients[k_ + 1][3] = next_ * x5;
      coefficients[k_ + 1][4] = next_ * x11;
      coefficients[k_ + 1][5] = next_ * (x56 - x57);
      coefficients[k_ + 1][6] = next_ * (-x58 - x59);
      coefficients[k_ + 1][7] = next_ * (x35 + x60);
      coefficients[k_ + 1][8] = next_ * (x41 - x61);
      coefficients[k_ + 1][9] = next_ * (x43 - x62);
      const Scalar left_[] = {w2, w2, x3, w7, w7, x4, x6, x5, x3, x4, x5, x8, x8, x4, x3, x28, x4, x30, x3, x35, x8, x3,
        x4, x41, x4, x0, x1, x47, x3, x0, x1, x5, x4, x54, x9, x10, x9, x10, x28, x30, x47};
      const Scalar right_[] = {x4, x3, x5, x10, x9, x8, x8, x15, x16, x14, x6, x9, x10, x4, x3, x26, x28, x24, x30, x26,
        x36, x37, x20, x24, x35, x21, x22, x33, x41, x22, x21, x5, x51, x32, x54, x47, x47, x54, x47, x54, x55};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    if (!(traits::regular(-z157, z83) && traits::regular(z98, z98) && traits::regular(p_C, p_C) && traits::regular(z164,
        z164) && traits::regular(z165, z165))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (coefficients[order][0] - coefficients[order][0]) + (coefficients[order][1]
        - coefficients[order][1]) + (coefficients[order][2] - coefficients[order][2]) + (coefficients[order][3]
        - coefficients[order][3]) + (coefficients[order][4] - coefficients[order][4]) + (coefficients[order][5]
        - coefficients[order][5]) + (coefficients[order][6] - coefficients[order][6]) + (coefficients[order][7]
        - coefficients[order][7]) + (coefficients[order][8] - coefficients[order][8]) + (coefficients[order][9]
        - coefficients[order][9]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Jacobian A(q, t) of the constraints without the entries that vanish identically: `values` of compressed rows.
  TORSOR_DEVICE static void sparse_constraint_jacobian(const Precomputed&, const State& state,
      SparseConstraintJacobian& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta = state.q.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    result.values[0] = c_psi;
    result.values[1] = s_psi;
    result.values[2] = c_theta;
    result.values[3] = n1;
    result.values[4] = -s_psi;
    result.values[5] = c_psi;
    result.values[6] = s_theta;
  }

  /// Derivatives of inverse_dynamics by the run-time parameters p at fixed (q, v, a, lambda).
  TORSOR_DEVICE static void inverse_dynamics_sensitivities(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsSensitivities& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z112 = z28 * z29;
    const Scalar z125 = s_theta * a_psi;
    const Scalar z126 = c_theta * a_psi;
    const Scalar z129 = v_theta * z29 + z125;  // angular acceleration of hoop.2, y
    const Scalar z130 = v_theta * z28 - z126;  // angular acceleration of hoop.2, z
    const Scalar z133 = a_phi - z130;  // angular acceleration of hoop, z
    const Scalar z135 = z103 + z129;
    const Scalar z541 = s_theta * z135;
    const Scalar z542 = a_theta - z112;
    const Scalar z543 = s_theta * z108 - c_theta * z133;
    result.by_parameter[0] = n0;
    result.by_parameter[1] = n0;
    result.by_parameter[2] = z541;
    result.by_parameter[3] = z542;
    result.by_parameter[4] = n0;
    result.by_parameter[5] = n0;
    result.by_parameter[6] = n0;
    result.by_parameter[7] = -z543;
    result.by_parameter[8] = z107;
    result.by_parameter[9] = z133;
  }

  /// Derivatives of forward_dynamics by the run-time parameters p at fixed (q, v, u), the accelerations and
  /// multipliers being those of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_sensitivities(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsSensitivities& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar z79 = precomputed.z79;
    const Scalar z155 = precomputed.z155;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z10 = c_theta * v_theta;
    const Scalar z11 = s_theta * v_theta;
    const Scalar z28 = s_theta * v_psi;
    const Scalar z29 = c_theta * v_psi;
    const Scalar z36 = v_phi + z29;  // angular velocity of hoop, z
    const Scalar z74 = c_theta * p_C;
    const Scalar z80 = s_theta * z79;
    const Scalar z81 = s_theta * z80;
    const Scalar z83 = p_C + z81;
    const Scalar z98 = c_theta * c_theta + p_A;
    const Scalar z99 = v_theta * z11;
    const Scalar z100 = n9_81 - z99;
    const Scalar z103 = v_theta * z29;  // angular acceleration of hoop.2, y
    const Scalar z104 = v_theta * z28;  // angular acceleration of hoop.2, z
    const Scalar z107 = z28 * z36;
    const Scalar z108 = v_theta * z36;
    const Scalar z109 = p_C * z107;  // moment on hoop, x
    const Scalar z110 = p_C * z108;  // moment on hoop, y
    const Scalar z111 = p_C * z104;  // moment on hoop, z
    const Scalar z112 = z28 * z29;
    const Scalar z113 = n2 * z103;
    const Scalar z114 = p_A * z112 - z109;  // moment on hoop.2, x
    const Scalar z115 = p_A * z113 - z110;  // moment on hoop.2, y
    const Scalar z117 = s_theta * z115 - c_theta * z111;
    const Scalar z121 = c_theta * z100 - z114;
    const Scalar z148 = v_psi * s_psi;
    const Scalar z149 = v_psi * c_psi;
    const Scalar z150 = v_x * z148 - v_y * z149 + z11 * v_psi;
    const Scalar z152 = v_x * z149 + v_y * z148 - v_theta * z10;
    const Scalar z156 = z74 * z155;
    const Scalar z157 = z74 * z156 - z83;
    const Scalar z158 = n1 / z98;
    const Scalar z159 = n1 / z157;
    const Scalar z160 = c_theta - z156;
    const Scalar z161 = z159 * z160;
    const Scalar z162 = z155 + z156 * z161;
    const Scalar z163 = s_theta * z158;
    const Scalar z164 = n1 - c_theta * z161 + z162;
    const Scalar z165 = n1 + s_theta * z163;
    const Scalar z166 = n1 / z165;
    const Scalar z167 = n1 / z164;
    const Scalar z168 = z111 * z156 + z117;
    const Scalar z169 = z159 * z168;
    const Scalar z170 = z121 * z158;
    const Scalar z171 = z111 * z155 - z156 * z169;
    const Scalar z172 = c_theta * z169 - z150 + z171;
    const Scalar z173 = s_theta * z170 + z152;
    const Scalar z174 = z167 * z172;
    const Scalar z175 = z166 * z173;
    const Scalar z178 = z161 * z174 + z169;
    const Scalar z179 = z163 * z175 - z170;
    const Scalar z180 = z162 * z174 - z171;
    const Scalar z474 = c_theta * z178;
    const Scalar z475 = v_theta * z28 - z474;  // angular acceleration of hoop.2, z
    const Scalar z476 = z180 + z475;  // angular acceleration of hoop, z
    const Scalar z480 = s_theta * z178;
    const Scalar z481 = v_theta * z29 + z480;  // angular acceleration of hoop.2, y
    const Scalar z482 = z103 + z481;
    const Scalar z547 = s_theta * z482;
    const Scalar z548 = z112 - z179;
    const Scalar z549 = z159 * z547;
    const Scalar z550 = z158 * z548;
    const Scalar z551 = z156 * z549;
    const Scalar z552 = c_theta * z549 - z551;
    const Scalar z553 = s_theta * z550;
    const Scalar z554 = z167 * z552;
    const Scalar z555 = z166 * z553;
    const Scalar z556 = s_psi * z555 - c_psi * z554;
    const Scalar z557 = s_psi * z554 + c_psi * z555;
    const Scalar z558 = z161 * z554 + z549;
    const Scalar z559 = z163 * z555 - z550;
    const Scalar z560 = z162 * z554 + z551;
    const Scalar z561 = s_theta * z108 + c_theta * z476;
    const Scalar z562 = z156 * z476 - z561;
    const Scalar z563 = z159 * z562;
    const Scalar z564 = z107 * z158;
    const Scalar z565 = z155 * z476 - z156 * z563;
    const Scalar z566 = c_theta * z563 + z565;
    const Scalar z567 = s_theta * z564;
    const Scalar z568 = z167 * z566;
    const Scalar z569 = z166 * z567;
    const Scalar z570 = s_psi * z569 + c_psi * z568;
    const Scalar z571 = s_psi * z568 - c_psi * z569;
    const Scalar z572 = z161 * z568 + z563;
    const Scalar z573 = z163 * z569 - z564;
    const Scalar z574 = z162 * z568 - z565;
    result.by_parameter[0] = z556;
    result.by_parameter[1] = -z557;
    result.by_parameter[2] = z558;
    result.by_parameter[3] = -z559;
    result.by_parameter[4] = -z560;
    result.by_parameter[5] = -z570;
    result.by_parameter[6] = -z571;
    result.by_parameter[7] = z572;
    result.by_parameter[8] = z573;
    result.by_parameter[9] = -z574;
    result.multipliers_by_parameter[0] = n0;
    result.multipliers_by_parameter[1] = -z555;
    result.multipliers_by_parameter[2] = -z568;
    result.multipliers_by_parameter[3] = z569;
    if (!(traits::regular(-z157, z83) && traits::regular(z98, z98) && traits::regular(p_C, p_C) && traits::regular(z164,
        z164) && traits::regular(z165, z165))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.by_parameter[0] - result.by_parameter[0]) + (result.by_parameter[1]
        - result.by_parameter[1]) + (result.by_parameter[2] - result.by_parameter[2]) + (result.by_parameter[3]
        - result.by_parameter[3]) + (result.by_parameter[4] - result.by_parameter[4]) + (result.by_parameter[5]
        - result.by_parameter[5]) + (result.by_parameter[6] - result.by_parameter[6]) + (result.by_parameter[7]
        - result.by_parameter[7]) + (result.by_parameter[8] - result.by_parameter[8]) + (result.by_parameter[9]
        - result.by_parameter[9]) + (result.multipliers_by_parameter[1] - result.multipliers_by_parameter[1])
        + (result.multipliers_by_parameter[2] - result.multipliers_by_parameter[2])
        + (result.multipliers_by_parameter[3] - result.multipliers_by_parameter[3]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace rolling_hoop
