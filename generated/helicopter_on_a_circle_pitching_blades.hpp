// SPDX-License-Identifier: MIT
// helicopter_on_a_circle_pitching_blades: The helicopter's rotor with blades of variable pitch
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions
// Parameters set at run time: theta, omega, alpha, alpha_c, k, c
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                7          0             0                  1       0      9       -
//   kinematics              159              342          0             0                  6       0    513     518
//   mass_matrix               4                8          0             0                  4       0     20      24
//   bias                     56               69          0             0                  5       0    135     160
//   inverse_dynamics         65               74          0             0                  5       0    149     174
//   forward_dynamics         61               82          1             0                  5       0    154     183
//   energy                   40               54          0             0                  5       0    104     124
//   reactions                48               66          0             0                  5       0    124     153
//
// Not computed because this mechanism does not need it:
//   kinematics: of 165 results 25 vanish identically, 58 repeat another up to sign
//   mass_matrix: of 25 results 20 vanish identically
//   reactions: of 6 results 2 vanish identically
//
// To write this file again:
//   helicopter_on_a_circle_pitching_blades_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,reactions --output helicopter_on_a_circle_pitching_blades.hpp
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

namespace helicopter_on_a_circle_pitching_blades {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "helicopter_on_a_circle_pitching_blades";
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 6;
  static constexpr int multiplier_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar theta;  ///< parameter [rad or 1]
    Scalar omega;  ///< parameter [rad/s]
    Scalar alpha;  ///< parameter [rad or 1]
    Scalar alpha_c;  ///< parameter [rad or 1]
    Scalar k;  ///< parameter [N m]
    Scalar c;  ///< parameter [N m s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::theta, &Parameters::omega, &Parameters::alpha,
          &Parameters::alpha_c, &Parameters::k, &Parameters::c};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar phi;  ///< coordinate [rad or 1]
    Scalar alpha_1;  ///< coordinate [rad or 1]
    Scalar alpha_2;  ///< coordinate [rad or 1]
    Scalar alpha_3;  ///< coordinate [rad or 1]
    Scalar alpha_4;  ///< coordinate [rad or 1]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::phi, &Coordinates::alpha_1, &Coordinates::alpha_2,
          &Coordinates::alpha_3, &Coordinates::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar phi;  ///< its rate [rad/s]
    Scalar alpha_1;  ///< its rate [rad/s]
    Scalar alpha_2;  ///< its rate [rad/s]
    Scalar alpha_3;  ///< its rate [rad/s]
    Scalar alpha_4;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::phi, &Velocities::alpha_1, &Velocities::alpha_2,
          &Velocities::alpha_3, &Velocities::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar phi;  ///< its second rate [rad/s^2]
    Scalar alpha_1;  ///< its second rate [rad/s^2]
    Scalar alpha_2;  ///< its second rate [rad/s^2]
    Scalar alpha_3;  ///< its second rate [rad/s^2]
    Scalar alpha_4;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::phi, &Accelerations::alpha_1,
          &Accelerations::alpha_2, &Accelerations::alpha_3, &Accelerations::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar phi;  ///< works with the rate of phi [N m]
    Scalar alpha_1;  ///< works with the rate of alpha_1 [N m]
    Scalar alpha_2;  ///< works with the rate of alpha_2 [N m]
    Scalar alpha_3;  ///< works with the rate of alpha_3 [N m]
    Scalar alpha_4;  ///< works with the rate of alpha_4 [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::phi, &GeneralizedForces::alpha_1,
          &GeneralizedForces::alpha_2, &GeneralizedForces::alpha_3, &GeneralizedForces::alpha_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C;  ///< motor [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C};
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
    Scalar s_theta;
    Scalar c_theta;
    Scalar z33;
    Scalar z34;
    Scalar z35;
    Scalar z412;
    Scalar z416;  ///< force on upwards, x
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4000 = traits::constant(4000.0, 4000.0f, "4000/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    parameters.theta = n0_3;
    parameters.omega = n0_2;
    parameters.alpha = n0_2;
    parameters.alpha_c = n0_1;
    parameters.k = n4000;
    parameters.c = n8;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n120 = traits::constant(120.0, 120.0f, "120/1");
    const Scalar p_omega = parameters.omega;
    const Scalar p_theta = parameters.theta;
    Scalar s_theta, c_theta;
    traits::sincos(p_theta, s_theta, c_theta);
    const Scalar z33 = n100 * p_omega;
    const Scalar z34 = p_omega * s_theta;
    const Scalar z35 = p_omega * c_theta;
    const Scalar z345 = p_omega * p_omega;
    const Scalar z346 = n100 * z345;
    const Scalar z412 = z34 * z35;
    const Scalar z416 = n120 * z346;  // force on upwards, x
    precomputed.s_theta = s_theta;
    precomputed.c_theta = c_theta;
    precomputed.z33 = z33;
    precomputed.z34 = z34;
    precomputed.z35 = z35;
    precomputed.z412 = z412;
    precomputed.z416 = z416;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar p_alpha = parameters.alpha;
    const Scalar p_alpha_c = parameters.alpha_c;
    state.time = n0;
    state.q.phi = n0;
    state.q.alpha_1 = p_alpha + p_alpha_c;
    state.q.alpha_2 = p_alpha;
    state.q.alpha_3 = p_alpha - p_alpha_c;
    state.q.alpha_4 = p_alpha;
    state.v.phi = n30;
    state.v.alpha_1 = n0;
    state.v.alpha_2 = -n30 * p_alpha_c;
    state.v.alpha_3 = n0;
    state.v.alpha_4 = -state.v.alpha_2;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> span_1_position;  ///< centre of mass of span_1 [m]
    std::array<Scalar, 9> span_1_rotation;  ///< from the axes of span_1 to the ground's (3 x 3)
    std::array<Scalar, 3> span_1_velocity;  ///< velocity of the centre of mass of span_1 [m/s]
    std::array<Scalar, 3> span_1_angular_velocity;  ///< angular velocity of span_1 [rad/s]
    std::array<Scalar, 3> blade_1_position;  ///< centre of mass of blade_1 [m]
    std::array<Scalar, 9> blade_1_rotation;  ///< from the axes of blade_1 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_1_velocity;  ///< velocity of the centre of mass of blade_1 [m/s]
    std::array<Scalar, 3> blade_1_angular_velocity;  ///< angular velocity of blade_1 [rad/s]
    std::array<Scalar, 3> span_2_position;  ///< centre of mass of span_2 [m]
    std::array<Scalar, 9> span_2_rotation;  ///< from the axes of span_2 to the ground's (3 x 3)
    std::array<Scalar, 3> span_2_velocity;  ///< velocity of the centre of mass of span_2 [m/s]
    std::array<Scalar, 3> span_2_angular_velocity;  ///< angular velocity of span_2 [rad/s]
    std::array<Scalar, 3> blade_2_position;  ///< centre of mass of blade_2 [m]
    std::array<Scalar, 9> blade_2_rotation;  ///< from the axes of blade_2 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_2_velocity;  ///< velocity of the centre of mass of blade_2 [m/s]
    std::array<Scalar, 3> blade_2_angular_velocity;  ///< angular velocity of blade_2 [rad/s]
    std::array<Scalar, 3> span_3_position;  ///< centre of mass of span_3 [m]
    std::array<Scalar, 9> span_3_rotation;  ///< from the axes of span_3 to the ground's (3 x 3)
    std::array<Scalar, 3> span_3_velocity;  ///< velocity of the centre of mass of span_3 [m/s]
    std::array<Scalar, 3> span_3_angular_velocity;  ///< angular velocity of span_3 [rad/s]
    std::array<Scalar, 3> blade_3_position;  ///< centre of mass of blade_3 [m]
    std::array<Scalar, 9> blade_3_rotation;  ///< from the axes of blade_3 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_3_velocity;  ///< velocity of the centre of mass of blade_3 [m/s]
    std::array<Scalar, 3> blade_3_angular_velocity;  ///< angular velocity of blade_3 [rad/s]
    std::array<Scalar, 3> span_4_position;  ///< centre of mass of span_4 [m]
    std::array<Scalar, 9> span_4_rotation;  ///< from the axes of span_4 to the ground's (3 x 3)
    std::array<Scalar, 3> span_4_velocity;  ///< velocity of the centre of mass of span_4 [m/s]
    std::array<Scalar, 3> span_4_angular_velocity;  ///< angular velocity of span_4 [rad/s]
    std::array<Scalar, 3> blade_4_position;  ///< centre of mass of blade_4 [m]
    std::array<Scalar, 9> blade_4_rotation;  ///< from the axes of blade_4 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_4_velocity;  ///< velocity of the centre of mass of blade_4 [m/s]
    std::array<Scalar, 3> blade_4_angular_velocity;  ///< angular velocity of blade_4 [rad/s]
    std::array<Scalar, 3> A_position;  ///< position of A [m]
    std::array<Scalar, 3> A_velocity;  ///< velocity of the material point at A [m/s]
    std::array<Scalar, 15> A_jacobian;  ///< partial velocities of A (3 x 5)
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

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar X;  ///< reaction along 'X' [kg m s^-2]
    Scalar Y;  ///< reaction along 'Y' [kg m s^-2]
    Scalar Z;  ///< reaction along 'Z' [kg m s^-2]
    Scalar M_x;  ///< reaction along 'M_x' [kg m^2 s^-2]
    Scalar M_y;  ///< reaction along 'M_y' [kg m^2 s^-2]
    Scalar M_z;  ///< reaction along 'M_z' [kg m^2 s^-2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::X, &Reactions::Y, &Reactions::Z, &Reactions::M_x,
          &Reactions::M_y, &Reactions::M_z};
      return members_[i_];
    }
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar s_theta = precomputed.s_theta;
    const Scalar c_theta = precomputed.c_theta;
    const Scalar z33 = precomputed.z33;
    const Scalar z34 = precomputed.z34;
    const Scalar z35 = precomputed.z35;
    const Scalar z2 = p_omega * t;
    const Scalar angles_[] = {z2, q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z3 = sines_[0], z4 = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar s_alpha_1 = sines_[2], c_alpha_1 = cosines_[2];
    const Scalar s_alpha_2 = sines_[3], c_alpha_2 = cosines_[3];
    const Scalar s_alpha_3 = sines_[4], c_alpha_3 = cosines_[4];
    const Scalar s_alpha_4 = sines_[5], c_alpha_4 = cosines_[5];
    const Scalar z36 = c_phi * z34;
    const Scalar z37 = s_phi * z34;
    const Scalar z38 = s_phi * z33;
    const Scalar z39 = c_phi * z33;
    const Scalar z40 = v_phi + z35;  // angular velocity of rotor, z
    const Scalar z41 = s_alpha_1 * z40 - c_alpha_1 * z37;
    const Scalar z42 = s_alpha_1 * z37 + c_alpha_1 * z40;
    const Scalar z43 = c_alpha_1 * z39;
    const Scalar z44 = s_alpha_1 * z39;
    const Scalar z45 = v_alpha_1 + z36;  // angular velocity of blade_1, x
    const Scalar z46 = s_alpha_2 * z40 - c_alpha_2 * z36;
    const Scalar z47 = s_alpha_2 * z36 + c_alpha_2 * z40;
    const Scalar z48 = c_alpha_2 * z38;
    const Scalar z49 = s_alpha_2 * z38;
    const Scalar z50 = v_alpha_2 - z37;  // angular velocity of blade_2, x
    const Scalar z51 = s_alpha_3 * z40 + c_alpha_3 * z37;
    const Scalar z52 = s_alpha_3 * z37 - c_alpha_3 * z40;
    const Scalar z53 = c_alpha_3 * z39;
    const Scalar z54 = s_alpha_3 * z39;
    const Scalar z55 = v_alpha_3 - z36;  // angular velocity of blade_3, x
    const Scalar z56 = s_alpha_4 * z40 + c_alpha_4 * z36;
    const Scalar z57 = s_alpha_4 * z36 - c_alpha_4 * z40;
    const Scalar z58 = c_alpha_4 * z38;
    const Scalar z59 = s_alpha_4 * z38;
    const Scalar z60 = v_alpha_4 + z37;  // angular velocity of blade_4, x
    const Scalar z61 = n3 * c_phi;
    const Scalar z62 = n3 * s_phi;
    const Scalar z63 = c_theta * z61;
    const Scalar z64 = s_theta * z61;
    const Scalar z65 = n100 + z63;
    const Scalar z66 = z3 * z62 - z4 * z65;
    const Scalar z67 = z3 * z65 + z4 * z62;
    const Scalar z68 = c_theta * c_phi;
    const Scalar z69 = s_theta * c_phi;
    const Scalar z70 = z3 * s_phi - z4 * z68;
    const Scalar z71 = z3 * z68 + z4 * s_phi;
    const Scalar z72 = c_theta * s_phi;
    const Scalar z73 = s_theta * s_phi;
    const Scalar z74 = z3 * c_phi + z4 * z72;
    const Scalar z75 = z3 * z72 - z4 * c_phi;
    const Scalar z76 = z4 * s_theta;
    const Scalar z77 = z3 * s_theta;
    const Scalar z78 = z39 + n3 * z40;
    const Scalar z79 = n3 * z37;
    const Scalar z80 = s_phi * z78 - c_phi * z38;
    const Scalar z81 = s_phi * z38 + c_phi * z78;
    const Scalar z82 = s_theta * z79 + c_theta * z80;
    const Scalar z83 = s_theta * z80 - c_theta * z79;
    const Scalar z84 = z3 * z81 + z4 * z82;
    const Scalar z85 = z3 * z82 - z4 * z81;
    const Scalar z86 = s_phi * z37 + c_phi * z36;
    const Scalar z87 = s_phi * z36 - c_phi * z37;
    const Scalar z88 = s_theta * z40 - c_theta * z86;
    const Scalar z89 = s_theta * z86 + c_theta * z40;
    const Scalar z90 = z3 * z87 + z4 * z88;
    const Scalar z91 = z3 * z88 - z4 * z87;
    const Scalar z92 = n100 * z4;
    const Scalar z93 = n100 * z3;
    const Scalar z94 = s_phi * c_alpha_1;
    const Scalar z95 = c_phi * c_alpha_1;
    const Scalar z96 = s_theta * s_alpha_1 + c_theta * z94;
    const Scalar z97 = s_theta * z94 - c_theta * s_alpha_1;
    const Scalar z98 = z3 * z95 + z4 * z96;
    const Scalar z99 = z3 * z96 - z4 * z95;
    const Scalar z100 = s_phi * s_alpha_1;
    const Scalar z101 = c_phi * s_alpha_1;
    const Scalar z102 = s_theta * c_alpha_1 - c_theta * z100;
    const Scalar z103 = s_theta * z100 + c_theta * c_alpha_1;
    const Scalar z104 = z3 * z101 - z4 * z102;
    const Scalar z105 = z3 * z102 + z4 * z101;
    const Scalar z106 = s_alpha_1 * z44 + c_alpha_1 * z43;
    const Scalar z107 = s_alpha_1 * z43 - c_alpha_1 * z44;
    const Scalar z108 = s_phi * z106 - c_phi * z38;
    const Scalar z109 = s_phi * z38 + c_phi * z106;
    const Scalar z110 = s_theta * z107 + c_theta * z108;
    const Scalar z112 = z3 * z109 + z4 * z110;
    const Scalar z113 = z3 * z110 - z4 * z109;
    const Scalar z114 = s_alpha_1 * z42 - c_alpha_1 * z41;
    const Scalar z115 = s_alpha_1 * z41 + c_alpha_1 * z42;
    const Scalar z116 = s_phi * z114 + c_phi * z45;
    const Scalar z117 = s_phi * z45 - c_phi * z114;
    const Scalar z118 = s_theta * z115 - c_theta * z116;
    const Scalar z119 = s_theta * z116 + c_theta * z115;
    const Scalar z120 = z3 * z117 + z4 * z118;
    const Scalar z121 = z3 * z118 - z4 * z117;
    const Scalar z122 = c_theta * z62;
    const Scalar z123 = s_theta * z62;
    const Scalar z124 = n100 - z122;
    const Scalar z125 = z3 * z61 - z4 * z124;
    const Scalar z126 = z3 * z124 + z4 * z61;
    const Scalar z127 = z38 - n3 * z40;
    const Scalar z128 = n3 * z36;
    const Scalar z129 = s_phi * z39 - c_phi * z127;
    const Scalar z130 = s_phi * z127 + c_phi * z39;
    const Scalar z131 = s_theta * z128 + c_theta * z129;
    const Scalar z132 = s_theta * z129 - c_theta * z128;
    const Scalar z133 = z3 * z130 + z4 * z131;
    const Scalar z134 = z3 * z131 - z4 * z130;
    const Scalar z135 = c_phi * c_alpha_2;
    const Scalar z136 = s_phi * c_alpha_2;
    const Scalar z137 = s_theta * s_alpha_2 + c_theta * z135;
    const Scalar z138 = s_theta * z135 - c_theta * s_alpha_2;
    const Scalar z139 = z3 * z136 - z4 * z137;
    const Scalar z140 = z3 * z137 + z4 * z136;
    const Scalar z141 = c_phi * s_alpha_2;
    const Scalar z142 = s_phi * s_alpha_2;
    const Scalar z143 = s_theta * c_alpha_2 - c_theta * z141;
    const Scalar z144 = s_theta * z141 + c_theta * c_alpha_2;
    const Scalar z145 = z3 * z142 + z4 * z143;
    const Scalar z146 = z3 * z143 - z4 * z142;
    const Scalar z147 = s_alpha_2 * z49 + c_alpha_2 * z48;
    const Scalar z148 = s_alpha_2 * z48 - c_alpha_2 * z49;
    const Scalar z149 = s_phi * z39 - c_phi * z147;
    const Scalar z150 = s_phi * z147 + c_phi * z39;
    const Scalar z151 = s_theta * z148 - c_theta * z149;
    const Scalar z153 = z3 * z150 - z4 * z151;
    const Scalar z154 = z3 * z151 + z4 * z150;
    const Scalar z155 = s_alpha_2 * z47 - c_alpha_2 * z46;
    const Scalar z156 = s_alpha_2 * z46 + c_alpha_2 * z47;
    const Scalar z157 = s_phi * z50 - c_phi * z155;
    const Scalar z158 = s_phi * z155 + c_phi * z50;
    const Scalar z159 = s_theta * z156 + c_theta * z157;
    const Scalar z160 = s_theta * z157 - c_theta * z156;
    const Scalar z161 = z3 * z158 + z4 * z159;
    const Scalar z162 = z3 * z159 - z4 * z158;
    const Scalar z163 = n100 - z63;
    const Scalar z164 = z3 * z62 + z4 * z163;
    const Scalar z165 = z3 * z163 - z4 * z62;
    const Scalar z166 = z39 - n3 * z40;
    const Scalar z167 = s_phi * z166 - c_phi * z38;
    const Scalar z168 = s_phi * z38 + c_phi * z166;
    const Scalar z169 = s_theta * z79 - c_theta * z167;
    const Scalar z170 = s_theta * z167 + c_theta * z79;
    const Scalar z171 = z3 * z168 - z4 * z169;
    const Scalar z172 = z3 * z169 + z4 * z168;
    const Scalar z173 = s_phi * c_alpha_3;
    const Scalar z174 = c_phi * c_alpha_3;
    const Scalar z175 = s_theta * s_alpha_3 - c_theta * z173;
    const Scalar z176 = s_theta * z173 + c_theta * s_alpha_3;
    const Scalar z177 = z3 * z174 - z4 * z175;
    const Scalar z178 = z3 * z175 + z4 * z174;
    const Scalar z179 = s_phi * s_alpha_3;
    const Scalar z180 = c_phi * s_alpha_3;
    const Scalar z181 = s_theta * c_alpha_3 + c_theta * z179;
    const Scalar z182 = s_theta * z179 - c_theta * c_alpha_3;
    const Scalar z183 = z3 * z180 + z4 * z181;
    const Scalar z184 = z3 * z181 - z4 * z180;
    const Scalar z185 = s_alpha_3 * z54 + c_alpha_3 * z53;
    const Scalar z186 = s_alpha_3 * z53 - c_alpha_3 * z54;
    const Scalar z187 = s_phi * z185 - c_phi * z38;
    const Scalar z188 = s_phi * z38 + c_phi * z185;
    const Scalar z189 = s_theta * z186 - c_theta * z187;
    const Scalar z191 = z3 * z188 - z4 * z189;
    const Scalar z192 = z3 * z189 + z4 * z188;
    const Scalar z193 = s_alpha_3 * z52 + c_alpha_3 * z51;
    const Scalar z194 = s_alpha_3 * z51 - c_alpha_3 * z52;
    const Scalar z195 = s_phi * z193 - c_phi * z55;
    const Scalar z196 = s_phi * z55 + c_phi * z193;
    const Scalar z197 = s_theta * z194 - c_theta * z195;
    const Scalar z198 = s_theta * z195 + c_theta * z194;
    const Scalar z199 = z3 * z196 - z4 * z197;
    const Scalar z200 = z3 * z197 + z4 * z196;
    const Scalar z201 = n100 + z122;
    const Scalar z202 = z3 * z61 + z4 * z201;
    const Scalar z203 = z3 * z201 - z4 * z61;
    const Scalar z204 = z38 + n3 * z40;
    const Scalar z205 = s_phi * z39 - c_phi * z204;
    const Scalar z206 = s_phi * z204 + c_phi * z39;
    const Scalar z207 = s_theta * z128 - c_theta * z205;
    const Scalar z208 = s_theta * z205 + c_theta * z128;
    const Scalar z209 = z3 * z206 - z4 * z207;
    const Scalar z210 = z3 * z207 + z4 * z206;
    const Scalar z211 = c_phi * c_alpha_4;
    const Scalar z212 = s_phi * c_alpha_4;
    const Scalar z213 = s_theta * s_alpha_4 - c_theta * z211;
    const Scalar z214 = s_theta * z211 + c_theta * s_alpha_4;
    const Scalar z215 = z3 * z212 + z4 * z213;
    const Scalar z216 = z3 * z213 - z4 * z212;
    const Scalar z217 = c_phi * s_alpha_4;
    const Scalar z218 = s_phi * s_alpha_4;
    const Scalar z219 = s_theta * c_alpha_4 + c_theta * z217;
    const Scalar z220 = s_theta * z217 - c_theta * c_alpha_4;
    const Scalar z221 = z3 * z218 - z4 * z219;
    const Scalar z222 = z3 * z219 + z4 * z218;
    const Scalar z223 = s_alpha_4 * z59 + c_alpha_4 * z58;
    const Scalar z224 = s_alpha_4 * z58 - c_alpha_4 * z59;
    const Scalar z225 = s_phi * z39 - c_phi * z223;
    const Scalar z226 = s_phi * z223 + c_phi * z39;
    const Scalar z227 = s_theta * z224 + c_theta * z225;
    const Scalar z229 = z3 * z226 + z4 * z227;
    const Scalar z230 = z3 * z227 - z4 * z226;
    const Scalar z231 = s_alpha_4 * z57 + c_alpha_4 * z56;
    const Scalar z232 = s_alpha_4 * z56 - c_alpha_4 * z57;
    const Scalar z233 = s_phi * z60 + c_phi * z231;
    const Scalar z234 = s_phi * z231 - c_phi * z60;
    const Scalar z235 = s_theta * z232 - c_theta * z233;
    const Scalar z236 = s_theta * z233 + c_theta * z232;
    const Scalar z237 = z3 * z234 + z4 * z235;
    const Scalar z238 = z3 * z235 - z4 * z234;
    const Scalar z239 = s_phi * z39 - c_phi * z38;
    const Scalar z240 = s_phi * z38 + c_phi * z39;
    const Scalar z241 = c_theta * z239;
    const Scalar z243 = z3 * z240 + z4 * z241;
    const Scalar z244 = z3 * z241 - z4 * z240;
    result.span_1_position[0] = -z66;
    result.span_1_position[1] = z67;
    result.span_1_position[2] = z64;
    result.span_1_rotation[0] = -z70;
    result.span_1_rotation[1] = z71;
    result.span_1_rotation[2] = z69;
    result.span_1_rotation[3] = -z74;
    result.span_1_rotation[4] = -z75;
    result.span_1_rotation[5] = -z73;
    result.span_1_rotation[6] = -z76;
    result.span_1_rotation[7] = -z77;
    result.span_1_rotation[8] = c_theta;
    result.span_1_velocity[0] = -z84;
    result.span_1_velocity[1] = -z85;
    result.span_1_velocity[2] = -z83;
    result.span_1_angular_velocity[0] = -z90;
    result.span_1_angular_velocity[1] = -z91;
    result.span_1_angular_velocity[2] = z89;
    result.blade_1_position[0] = z92;
    result.blade_1_position[1] = z93;
    result.blade_1_position[2] = n0;
    result.blade_1_rotation[0] = -z70;
    result.blade_1_rotation[1] = z71;
    result.blade_1_rotation[2] = z69;
    result.blade_1_rotation[3] = -z98;
    result.blade_1_rotation[4] = -z99;
    result.blade_1_rotation[5] = -z97;
    result.blade_1_rotation[6] = z104;
    result.blade_1_rotation[7] = -z105;
    result.blade_1_rotation[8] = z103;
    result.blade_1_velocity[0] = -z112;
    result.blade_1_velocity[1] = -z113;
    result.blade_1_velocity[2] = n0;
    result.blade_1_angular_velocity[0] = -z120;
    result.blade_1_angular_velocity[1] = -z121;
    result.blade_1_angular_velocity[2] = z119;
    result.span_2_position[0] = -z125;
    result.span_2_position[1] = z126;
    result.span_2_position[2] = -z123;
    result.span_2_rotation[0] = -z74;
    result.span_2_rotation[1] = -z75;
    result.span_2_rotation[2] = -z73;
    result.span_2_rotation[3] = z70;
    result.span_2_rotation[4] = -z71;
    result.span_2_rotation[5] = -z69;
    result.span_2_rotation[6] = -z76;
    result.span_2_rotation[7] = -z77;
    result.span_2_rotation[8] = c_theta;
    result.span_2_velocity[0] = -z133;
    result.span_2_velocity[1] = -z134;
    result.span_2_velocity[2] = -z132;
    result.span_2_angular_velocity[0] = -z90;
    result.span_2_angular_velocity[1] = -z91;
    result.span_2_angular_velocity[2] = z89;
    result.blade_2_position[0] = z92;
    result.blade_2_position[1] = z93;
    result.blade_2_position[2] = n0;
    result.blade_2_rotation[0] = -z74;
    result.blade_2_rotation[1] = -z75;
    result.blade_2_rotation[2] = -z73;
    result.blade_2_rotation[3] = z139;
    result.blade_2_rotation[4] = -z140;
    result.blade_2_rotation[5] = -z138;
    result.blade_2_rotation[6] = -z145;
    result.blade_2_rotation[7] = -z146;
    result.blade_2_rotation[8] = z144;
    result.blade_2_velocity[0] = -z153;
    result.blade_2_velocity[1] = z154;
    result.blade_2_velocity[2] = n0;
    result.blade_2_angular_velocity[0] = -z161;
    result.blade_2_angular_velocity[1] = -z162;
    result.blade_2_angular_velocity[2] = -z160;
    result.span_3_position[0] = z164;
    result.span_3_position[1] = z165;
    result.span_3_position[2] = -z64;
    result.span_3_rotation[0] = z70;
    result.span_3_rotation[1] = -z71;
    result.span_3_rotation[2] = -z69;
    result.span_3_rotation[3] = z74;
    result.span_3_rotation[4] = z75;
    result.span_3_rotation[5] = z73;
    result.span_3_rotation[6] = -z76;
    result.span_3_rotation[7] = -z77;
    result.span_3_rotation[8] = c_theta;
    result.span_3_velocity[0] = -z171;
    result.span_3_velocity[1] = z172;
    result.span_3_velocity[2] = -z170;
    result.span_3_angular_velocity[0] = -z90;
    result.span_3_angular_velocity[1] = -z91;
    result.span_3_angular_velocity[2] = z89;
    result.blade_3_position[0] = z92;
    result.blade_3_position[1] = z93;
    result.blade_3_position[2] = n0;
    result.blade_3_rotation[0] = z70;
    result.blade_3_rotation[1] = -z71;
    result.blade_3_rotation[2] = -z69;
    result.blade_3_rotation[3] = z177;
    result.blade_3_rotation[4] = -z178;
    result.blade_3_rotation[5] = z176;
    result.blade_3_rotation[6] = -z183;
    result.blade_3_rotation[7] = -z184;
    result.blade_3_rotation[8] = -z182;
    result.blade_3_velocity[0] = -z191;
    result.blade_3_velocity[1] = z192;
    result.blade_3_velocity[2] = n0;
    result.blade_3_angular_velocity[0] = z199;
    result.blade_3_angular_velocity[1] = -z200;
    result.blade_3_angular_velocity[2] = z198;
    result.span_4_position[0] = z202;
    result.span_4_position[1] = z203;
    result.span_4_position[2] = z123;
    result.span_4_rotation[0] = z74;
    result.span_4_rotation[1] = z75;
    result.span_4_rotation[2] = z73;
    result.span_4_rotation[3] = -z70;
    result.span_4_rotation[4] = z71;
    result.span_4_rotation[5] = z69;
    result.span_4_rotation[6] = -z76;
    result.span_4_rotation[7] = -z77;
    result.span_4_rotation[8] = c_theta;
    result.span_4_velocity[0] = -z209;
    result.span_4_velocity[1] = z210;
    result.span_4_velocity[2] = -z208;
    result.span_4_angular_velocity[0] = -z90;
    result.span_4_angular_velocity[1] = -z91;
    result.span_4_angular_velocity[2] = z89;
    result.blade_4_position[0] = z92;
    result.blade_4_position[1] = z93;
    result.blade_4_position[2] = n0;
    result.blade_4_rotation[0] = z74;
    result.blade_4_rotation[1] = z75;
    result.blade_4_rotation[2] = z73;
    result.blade_4_rotation[3] = -z215;
    result.blade_4_rotation[4] = -z216;
    result.blade_4_rotation[5] = z214;
    result.blade_4_rotation[6] = z221;
    result.blade_4_rotation[7] = -z222;
    result.blade_4_rotation[8] = -z220;
    result.blade_4_velocity[0] = -z229;
    result.blade_4_velocity[1] = -z230;
    result.blade_4_velocity[2] = n0;
    result.blade_4_angular_velocity[0] = -z237;
    result.blade_4_angular_velocity[1] = -z238;
    result.blade_4_angular_velocity[2] = z236;
    result.A_position[0] = z92;
    result.A_position[1] = z93;
    result.A_position[2] = n0;
    result.A_velocity[0] = -z243;
    result.A_velocity[1] = -z244;
    result.A_velocity[2] = n0;
    result.A_jacobian[0] = n0;
    result.A_jacobian[3] = n0;
    result.A_jacobian[6] = n0;
    result.A_jacobian[9] = n0;
    result.A_jacobian[12] = n0;
    result.A_jacobian[1] = n0;
    result.A_jacobian[4] = n0;
    result.A_jacobian[7] = n0;
    result.A_jacobian[10] = n0;
    result.A_jacobian[13] = n0;
    result.A_jacobian[2] = n0;
    result.A_jacobian[5] = n0;
    result.A_jacobian[8] = n0;
    result.A_jacobian[11] = n0;
    result.A_jacobian[14] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 25>& mass) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1331_6 = traits::constant(1331.6, 1331.6f, "6658/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar angles_[] = {q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha_1 = sines_[0];
    const Scalar s_alpha_2 = sines_[1];
    const Scalar s_alpha_3 = sines_[2];
    const Scalar s_alpha_4 = sines_[3];
    const Scalar z251 = n0_4 * s_alpha_4;
    const Scalar z252 = s_alpha_4 * z251;
    const Scalar z255 = n1331_6 - z252;
    const Scalar z258 = n0_4 * s_alpha_3;
    const Scalar z259 = s_alpha_3 * z258;
    const Scalar z264 = z255 - z259;
    const Scalar z265 = n0_4 * s_alpha_2;
    const Scalar z266 = s_alpha_2 * z265;
    const Scalar z272 = z264 - z266;
    const Scalar z273 = n0_4 * s_alpha_1;
    const Scalar z274 = s_alpha_1 * z273;
    const Scalar z280 = z272 - z274;
    mass[0] = z280;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0_4;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0_4;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0_4;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z34 = precomputed.z34;
    const Scalar z35 = precomputed.z35;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z36 = c_phi * z34;
    const Scalar z37 = s_phi * z34;
    const Scalar z40 = v_phi + z35;  // angular velocity of rotor, z
    const Scalar z41 = s_alpha_1 * z40 - c_alpha_1 * z37;
    const Scalar z42 = s_alpha_1 * z37 + c_alpha_1 * z40;
    const Scalar z45 = v_alpha_1 + z36;  // angular velocity of blade_1, x
    const Scalar z46 = s_alpha_2 * z40 - c_alpha_2 * z36;
    const Scalar z47 = s_alpha_2 * z36 + c_alpha_2 * z40;
    const Scalar z50 = v_alpha_2 - z37;  // angular velocity of blade_2, x
    const Scalar z51 = s_alpha_3 * z40 + c_alpha_3 * z37;
    const Scalar z52 = s_alpha_3 * z37 - c_alpha_3 * z40;
    const Scalar z55 = v_alpha_3 - z36;  // angular velocity of blade_3, x
    const Scalar z56 = s_alpha_4 * z40 + c_alpha_4 * z36;
    const Scalar z57 = s_alpha_4 * z36 - c_alpha_4 * z40;
    const Scalar z60 = v_alpha_4 + z37;  // angular velocity of blade_4, x
    const Scalar z326 = c_phi * p_alpha_c - q_alpha_1 + p_alpha;
    const Scalar z327 = p_k * z326;
    const Scalar z328 = v_phi * s_phi;
    const Scalar z329 = v_alpha_1 + p_alpha_c * z328;
    const Scalar z331 = z329 * p_c;
    const Scalar z332 = s_phi * p_alpha_c + q_alpha_2 - p_alpha;
    const Scalar z333 = p_k * z332;
    const Scalar z334 = v_phi * c_phi;
    const Scalar z335 = v_alpha_2 + p_alpha_c * z334;
    const Scalar z336 = p_c * z335;
    const Scalar z337 = c_phi * p_alpha_c + q_alpha_3 - p_alpha;
    const Scalar z338 = p_k * z337;
    const Scalar z339 = v_alpha_3 - p_alpha_c * z328;
    const Scalar z340 = p_c * z339;
    const Scalar z341 = s_phi * p_alpha_c - q_alpha_4 + p_alpha;
    const Scalar z342 = p_k * z341;
    const Scalar z343 = v_alpha_4 - p_alpha_c * z334;
    const Scalar z344 = p_c * z343;
    const Scalar z351 = v_phi * z37;  // angular acceleration of rotor, x
    const Scalar z352 = v_phi * z36;  // angular acceleration of rotor, y
    const Scalar z354 = s_alpha_1 * z352;
    const Scalar z358 = v_alpha_1 * z41 - z354;  // angular acceleration of blade_1, z
    const Scalar z360 = s_alpha_2 * z351;
    const Scalar z364 = v_alpha_2 * z46 + z360;  // angular acceleration of blade_2, z
    const Scalar z366 = s_alpha_3 * z352;
    const Scalar z370 = v_alpha_3 * z51 + z366;  // angular acceleration of blade_3, z
    const Scalar z372 = s_alpha_4 * z351;
    const Scalar z376 = v_alpha_4 * z56 - z372;  // angular acceleration of blade_4, z
    const Scalar z377 = z56 * z57;
    const Scalar z378 = z56 * z60;
    const Scalar z379 = z376 + z378;
    const Scalar z380 = n0_4 * (z352 - z377);  // moment on blade_4, x
    const Scalar z381 = n0_4 * z379;  // moment on blade_4, z
    const Scalar z383 = c_alpha_4 * z381;
    const Scalar z384 = z51 * z52;
    const Scalar z385 = z51 * z55;
    const Scalar z386 = z370 + z385;
    const Scalar z387 = n0_4 * (z351 - z384);  // moment on blade_3, x
    const Scalar z388 = n0_4 * z386;  // moment on blade_3, z
    const Scalar z390 = c_alpha_3 * z388;
    const Scalar z391 = z46 * z47;
    const Scalar z392 = z46 * z50;
    const Scalar z393 = z364 + z392;
    const Scalar z394 = n0_4 * (z352 - z391);  // moment on blade_2, x
    const Scalar z395 = n0_4 * z393;  // moment on blade_2, z
    const Scalar z397 = c_alpha_2 * z395;
    const Scalar z398 = z41 * z42;
    const Scalar z399 = z41 * z45;
    const Scalar z400 = z358 + z399;
    const Scalar z401 = n0_4 * (z351 - z398);  // moment on blade_1, x
    const Scalar z402 = n0_4 * z400;  // moment on blade_1, z
    const Scalar z404 = c_alpha_1 * z402;
    const Scalar z409 = z383 + z390 + z397 + z404;  // moment on rotor, z
    const Scalar z417 = p_alpha_c * (s_phi * (z327 - z331 + z338 + z340) - c_phi * (z333 + z336 + z342 - z344)) + z409;
    const Scalar z418 = z327 - z331 + z401;
    const Scalar z419 = z333 + z336 - z394;
    const Scalar z420 = z338 + z340 + z387;
    const Scalar z421 = z342 - z344 - z380;
    forces.phi = -z417;
    forces.alpha_1 = -z418;
    forces.alpha_2 = z419;
    forces.alpha_3 = z420;
    forces.alpha_4 = -z421;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar a_alpha_1 = accelerations.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar a_alpha_2 = accelerations.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar a_alpha_3 = accelerations.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar a_alpha_4 = accelerations.alpha_4;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z34 = precomputed.z34;
    const Scalar z35 = precomputed.z35;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z36 = c_phi * z34;
    const Scalar z37 = s_phi * z34;
    const Scalar z40 = v_phi + z35;  // angular velocity of rotor, z
    const Scalar z41 = s_alpha_1 * z40 - c_alpha_1 * z37;
    const Scalar z42 = s_alpha_1 * z37 + c_alpha_1 * z40;
    const Scalar z45 = v_alpha_1 + z36;  // angular velocity of blade_1, x
    const Scalar z46 = s_alpha_2 * z40 - c_alpha_2 * z36;
    const Scalar z47 = s_alpha_2 * z36 + c_alpha_2 * z40;
    const Scalar z50 = v_alpha_2 - z37;  // angular velocity of blade_2, x
    const Scalar z51 = s_alpha_3 * z40 + c_alpha_3 * z37;
    const Scalar z52 = s_alpha_3 * z37 - c_alpha_3 * z40;
    const Scalar z55 = v_alpha_3 - z36;  // angular velocity of blade_3, x
    const Scalar z56 = s_alpha_4 * z40 + c_alpha_4 * z36;
    const Scalar z57 = s_alpha_4 * z36 - c_alpha_4 * z40;
    const Scalar z60 = v_alpha_4 + z37;  // angular velocity of blade_4, x
    const Scalar z326 = c_phi * p_alpha_c - q_alpha_1 + p_alpha;
    const Scalar z327 = p_k * z326;
    const Scalar z328 = v_phi * s_phi;
    const Scalar z329 = v_alpha_1 + p_alpha_c * z328;
    const Scalar z331 = z329 * p_c;
    const Scalar z332 = s_phi * p_alpha_c + q_alpha_2 - p_alpha;
    const Scalar z333 = p_k * z332;
    const Scalar z334 = v_phi * c_phi;
    const Scalar z335 = v_alpha_2 + p_alpha_c * z334;
    const Scalar z336 = p_c * z335;
    const Scalar z337 = c_phi * p_alpha_c + q_alpha_3 - p_alpha;
    const Scalar z338 = p_k * z337;
    const Scalar z339 = v_alpha_3 - p_alpha_c * z328;
    const Scalar z340 = p_c * z339;
    const Scalar z341 = s_phi * p_alpha_c - q_alpha_4 + p_alpha;
    const Scalar z342 = p_k * z341;
    const Scalar z343 = v_alpha_4 - p_alpha_c * z334;
    const Scalar z344 = p_c * z343;
    const Scalar z351 = v_phi * z37;  // angular acceleration of rotor, x
    const Scalar z352 = v_phi * z36;  // angular acceleration of rotor, y
    const Scalar z377 = z56 * z57;
    const Scalar z378 = z56 * z60;
    const Scalar z384 = z51 * z52;
    const Scalar z385 = z51 * z55;
    const Scalar z391 = z46 * z47;
    const Scalar z392 = z46 * z50;
    const Scalar z398 = z41 * z42;
    const Scalar z399 = z41 * z45;
    const Scalar z423 = a_phi * c_alpha_1 + s_alpha_1 * z352;
    const Scalar z424 = a_alpha_1 - z351;  // angular acceleration of blade_1, x
    const Scalar z426 = v_alpha_1 * z41 - z423;  // angular acceleration of blade_1, z
    const Scalar z428 = a_phi * c_alpha_2 - s_alpha_2 * z351;
    const Scalar z429 = a_alpha_2 - z352;  // angular acceleration of blade_2, x
    const Scalar z431 = v_alpha_2 * z46 - z428;  // angular acceleration of blade_2, z
    const Scalar z433 = a_phi * c_alpha_3 - s_alpha_3 * z352;
    const Scalar z434 = a_alpha_3 + z351;  // angular acceleration of blade_3, x
    const Scalar z436 = v_alpha_3 * z51 - z433;  // angular acceleration of blade_3, z
    const Scalar z438 = a_phi * c_alpha_4 + s_alpha_4 * z351;
    const Scalar z439 = a_alpha_4 + z352;  // angular acceleration of blade_4, x
    const Scalar z441 = v_alpha_4 * z56 - z438;  // angular acceleration of blade_4, z
    const Scalar z442 = z378 + z441;
    const Scalar z443 = n0_4 * (z377 - z439);  // moment on blade_4, x
    const Scalar z444 = n0_4 * z442;  // moment on blade_4, z
    const Scalar z446 = c_alpha_4 * z444;
    const Scalar z447 = z385 + z436;
    const Scalar z448 = n0_4 * (z384 - z434);  // moment on blade_3, x
    const Scalar z449 = n0_4 * z447;  // moment on blade_3, z
    const Scalar z451 = c_alpha_3 * z449;
    const Scalar z452 = z392 + z431;
    const Scalar z453 = n0_4 * (z391 + z429);  // moment on blade_2, x
    const Scalar z454 = n0_4 * z452;  // moment on blade_2, z
    const Scalar z456 = c_alpha_2 * z454;
    const Scalar z457 = z399 + z426;
    const Scalar z458 = n0_4 * (z398 + z424);  // moment on blade_1, x
    const Scalar z459 = n0_4 * z457;  // moment on blade_1, z
    const Scalar z461 = c_alpha_1 * z459;
    const Scalar z464 = n1330 * a_phi - z446 - z451 - z456 - z461;  // moment on rotor, z
    const Scalar z470 = p_alpha_c * (s_phi * (z327 - z331 + z338 + z340) - c_phi * (z333 + z336 + z342 - z344)) - z464;
    const Scalar z471 = z327 - z331 - z458;
    const Scalar z472 = z333 + z336 + z453;
    const Scalar z473 = z338 + z340 - z448;
    const Scalar z474 = z342 - z344 + z443;
    forces.phi = -z470;
    forces.alpha_1 = -z471;
    forces.alpha_2 = z472;
    forces.alpha_3 = z473;
    forces.alpha_4 = -z474;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1331_6 = traits::constant(1331.6, 1331.6f, "6658/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar u_C = inputs.C;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z34 = precomputed.z34;
    const Scalar z35 = precomputed.z35;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z36 = c_phi * z34;
    const Scalar z37 = s_phi * z34;
    const Scalar z40 = v_phi + z35;  // angular velocity of rotor, z
    const Scalar z41 = s_alpha_1 * z40 - c_alpha_1 * z37;
    const Scalar z42 = s_alpha_1 * z37 + c_alpha_1 * z40;
    const Scalar z45 = v_alpha_1 + z36;  // angular velocity of blade_1, x
    const Scalar z46 = s_alpha_2 * z40 - c_alpha_2 * z36;
    const Scalar z47 = s_alpha_2 * z36 + c_alpha_2 * z40;
    const Scalar z50 = v_alpha_2 - z37;  // angular velocity of blade_2, x
    const Scalar z51 = s_alpha_3 * z40 + c_alpha_3 * z37;
    const Scalar z52 = s_alpha_3 * z37 - c_alpha_3 * z40;
    const Scalar z55 = v_alpha_3 - z36;  // angular velocity of blade_3, x
    const Scalar z56 = s_alpha_4 * z40 + c_alpha_4 * z36;
    const Scalar z57 = s_alpha_4 * z36 - c_alpha_4 * z40;
    const Scalar z60 = v_alpha_4 + z37;  // angular velocity of blade_4, x
    const Scalar z251 = n0_4 * s_alpha_4;
    const Scalar z252 = s_alpha_4 * z251;
    const Scalar z255 = n1331_6 - z252;
    const Scalar z258 = n0_4 * s_alpha_3;
    const Scalar z259 = s_alpha_3 * z258;
    const Scalar z264 = z255 - z259;
    const Scalar z265 = n0_4 * s_alpha_2;
    const Scalar z266 = s_alpha_2 * z265;
    const Scalar z272 = z264 - z266;
    const Scalar z273 = n0_4 * s_alpha_1;
    const Scalar z274 = s_alpha_1 * z273;
    const Scalar z280 = z272 - z274;
    const Scalar z326 = c_phi * p_alpha_c - q_alpha_1 + p_alpha;
    const Scalar z327 = p_k * z326;
    const Scalar z328 = v_phi * s_phi;
    const Scalar z329 = v_alpha_1 + p_alpha_c * z328;
    const Scalar z331 = z329 * p_c;
    const Scalar z332 = s_phi * p_alpha_c + q_alpha_2 - p_alpha;
    const Scalar z333 = p_k * z332;
    const Scalar z334 = v_phi * c_phi;
    const Scalar z335 = v_alpha_2 + p_alpha_c * z334;
    const Scalar z336 = p_c * z335;
    const Scalar z337 = c_phi * p_alpha_c + q_alpha_3 - p_alpha;
    const Scalar z338 = p_k * z337;
    const Scalar z339 = v_alpha_3 - p_alpha_c * z328;
    const Scalar z340 = p_c * z339;
    const Scalar z341 = s_phi * p_alpha_c - q_alpha_4 + p_alpha;
    const Scalar z342 = p_k * z341;
    const Scalar z343 = v_alpha_4 - p_alpha_c * z334;
    const Scalar z344 = p_c * z343;
    const Scalar z351 = v_phi * z37;  // angular acceleration of rotor, x
    const Scalar z352 = v_phi * z36;  // angular acceleration of rotor, y
    const Scalar z354 = s_alpha_1 * z352;
    const Scalar z358 = v_alpha_1 * z41 - z354;  // angular acceleration of blade_1, z
    const Scalar z360 = s_alpha_2 * z351;
    const Scalar z364 = v_alpha_2 * z46 + z360;  // angular acceleration of blade_2, z
    const Scalar z366 = s_alpha_3 * z352;
    const Scalar z370 = v_alpha_3 * z51 + z366;  // angular acceleration of blade_3, z
    const Scalar z372 = s_alpha_4 * z351;
    const Scalar z376 = v_alpha_4 * z56 - z372;  // angular acceleration of blade_4, z
    const Scalar z377 = z56 * z57;
    const Scalar z378 = z56 * z60;
    const Scalar z379 = z376 + z378;
    const Scalar z380 = n0_4 * (z352 - z377);  // moment on blade_4, x
    const Scalar z381 = n0_4 * z379;  // moment on blade_4, z
    const Scalar z383 = c_alpha_4 * z381;
    const Scalar z384 = z51 * z52;
    const Scalar z385 = z51 * z55;
    const Scalar z386 = z370 + z385;
    const Scalar z387 = n0_4 * (z351 - z384);  // moment on blade_3, x
    const Scalar z388 = n0_4 * z386;  // moment on blade_3, z
    const Scalar z390 = c_alpha_3 * z388;
    const Scalar z391 = z46 * z47;
    const Scalar z392 = z46 * z50;
    const Scalar z393 = z364 + z392;
    const Scalar z394 = n0_4 * (z352 - z391);  // moment on blade_2, x
    const Scalar z395 = n0_4 * z393;  // moment on blade_2, z
    const Scalar z397 = c_alpha_2 * z395;
    const Scalar z398 = z41 * z42;
    const Scalar z399 = z41 * z45;
    const Scalar z400 = z358 + z399;
    const Scalar z401 = n0_4 * (z351 - z398);  // moment on blade_1, x
    const Scalar z402 = n0_4 * z400;  // moment on blade_1, z
    const Scalar z404 = c_alpha_1 * z402;
    const Scalar z409 = z383 + z390 + z397 + z404;  // moment on rotor, z
    const Scalar z417 = p_alpha_c * (s_phi * (z327 - z331 + z338 + z340) - c_phi * (z333 + z336 + z342 - z344)) + z409;
    const Scalar z418 = z327 - z331 + z401;
    const Scalar z419 = z333 + z336 - z394;
    const Scalar z420 = z338 + z340 + z387;
    const Scalar z421 = z342 - z344 - z380;
    const Scalar z475 = u_C + z417;
    const Scalar z476 = n1 / z280;
    const Scalar z477 = z475 * z476;
    const Scalar z478 = n2_5 * z418;
    const Scalar z479 = n2_5 * z419;
    const Scalar z480 = n2_5 * z420;
    const Scalar z481 = n2_5 * z421;
    accelerations.phi = z477;
    accelerations.alpha_1 = z478;
    accelerations.alpha_2 = -z479;
    accelerations.alpha_3 = -z480;
    accelerations.alpha_4 = z481;
    if (!(traits::regular(z280, z280))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.phi - accelerations.phi) + (accelerations.alpha_1 - accelerations.alpha_1)
        + (accelerations.alpha_2 - accelerations.alpha_2) + (accelerations.alpha_3 - accelerations.alpha_3)
        + (accelerations.alpha_4 - accelerations.alpha_4);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n332_5 = traits::constant(332.5, 332.5f, "665/2");
    const Scalar n60 = traits::constant(60.0, 60.0f, "60/1");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar u_C = inputs.C;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z33 = precomputed.z33;
    const Scalar z34 = precomputed.z34;
    const Scalar z35 = precomputed.z35;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z36 = c_phi * z34;
    const Scalar z37 = s_phi * z34;
    const Scalar z38 = s_phi * z33;
    const Scalar z39 = c_phi * z33;
    const Scalar z40 = v_phi + z35;  // angular velocity of rotor, z
    const Scalar z42 = s_alpha_1 * z37 + c_alpha_1 * z40;
    const Scalar z45 = v_alpha_1 + z36;  // angular velocity of blade_1, x
    const Scalar z47 = s_alpha_2 * z36 + c_alpha_2 * z40;
    const Scalar z50 = v_alpha_2 - z37;  // angular velocity of blade_2, x
    const Scalar z52 = s_alpha_3 * z37 - c_alpha_3 * z40;
    const Scalar z55 = v_alpha_3 - z36;  // angular velocity of blade_3, x
    const Scalar z57 = s_alpha_4 * z36 - c_alpha_4 * z40;
    const Scalar z60 = v_alpha_4 + z37;  // angular velocity of blade_4, x
    const Scalar z326 = c_phi * p_alpha_c - q_alpha_1 + p_alpha;
    const Scalar z328 = v_phi * s_phi;
    const Scalar z329 = v_alpha_1 + p_alpha_c * z328;
    const Scalar z331 = z329 * p_c;
    const Scalar z332 = s_phi * p_alpha_c + q_alpha_2 - p_alpha;
    const Scalar z334 = v_phi * c_phi;
    const Scalar z335 = v_alpha_2 + p_alpha_c * z334;
    const Scalar z336 = p_c * z335;
    const Scalar z337 = c_phi * p_alpha_c + q_alpha_3 - p_alpha;
    const Scalar z339 = v_alpha_3 - p_alpha_c * z328;
    const Scalar z340 = p_c * z339;
    const Scalar z341 = s_phi * p_alpha_c - q_alpha_4 + p_alpha;
    const Scalar z343 = v_alpha_4 - p_alpha_c * z334;
    const Scalar z344 = p_c * z343;
    result.kinetic = n0_2 * (z42 * z42 + z45 * z45 + z47 * z47 + z50 * z50 + z52 * z52 + z55 * z55 + z57 * z57 + z60
        * z60) + n332_5 * (z36 * z36 + z37 * z37) + n60 * (z38 * z38 + z39 * z39) + n665 * z40 * z40;
    result.force_function = -p_k * n0_5 * (z326 * z326 + z332 * z332 + z337 * z337 + z341 * z341);
    result.power = v_phi * u_C - z329 * z331 - z335 * z336 - z339 * z340 - z343 * z344;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar a_alpha_1 = accelerations.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar a_alpha_2 = accelerations.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar a_alpha_3 = accelerations.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar a_alpha_4 = accelerations.alpha_4;
    const Scalar z34 = precomputed.z34;
    const Scalar z35 = precomputed.z35;
    const Scalar z412 = precomputed.z412;
    const Scalar z416 = precomputed.z416;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z36 = c_phi * z34;
    const Scalar z37 = s_phi * z34;
    const Scalar z40 = v_phi + z35;  // angular velocity of rotor, z
    const Scalar z41 = s_alpha_1 * z40 - c_alpha_1 * z37;
    const Scalar z42 = s_alpha_1 * z37 + c_alpha_1 * z40;
    const Scalar z45 = v_alpha_1 + z36;  // angular velocity of blade_1, x
    const Scalar z46 = s_alpha_2 * z40 - c_alpha_2 * z36;
    const Scalar z47 = s_alpha_2 * z36 + c_alpha_2 * z40;
    const Scalar z50 = v_alpha_2 - z37;  // angular velocity of blade_2, x
    const Scalar z51 = s_alpha_3 * z40 + c_alpha_3 * z37;
    const Scalar z52 = s_alpha_3 * z37 - c_alpha_3 * z40;
    const Scalar z55 = v_alpha_3 - z36;  // angular velocity of blade_3, x
    const Scalar z56 = s_alpha_4 * z40 + c_alpha_4 * z36;
    const Scalar z57 = s_alpha_4 * z36 - c_alpha_4 * z40;
    const Scalar z60 = v_alpha_4 + z37;  // angular velocity of blade_4, x
    const Scalar z351 = v_phi * z37;  // angular acceleration of rotor, x
    const Scalar z352 = v_phi * z36;  // angular acceleration of rotor, y
    const Scalar z377 = z56 * z57;
    const Scalar z378 = z56 * z60;
    const Scalar z384 = z51 * z52;
    const Scalar z385 = z51 * z55;
    const Scalar z391 = z46 * z47;
    const Scalar z392 = z46 * z50;
    const Scalar z398 = z41 * z42;
    const Scalar z399 = z41 * z45;
    const Scalar z405 = z37 * z40;
    const Scalar z406 = z36 * z40;
    const Scalar z423 = a_phi * c_alpha_1 + s_alpha_1 * z352;
    const Scalar z424 = a_alpha_1 - z351;  // angular acceleration of blade_1, x
    const Scalar z426 = v_alpha_1 * z41 - z423;  // angular acceleration of blade_1, z
    const Scalar z428 = a_phi * c_alpha_2 - s_alpha_2 * z351;
    const Scalar z429 = a_alpha_2 - z352;  // angular acceleration of blade_2, x
    const Scalar z431 = v_alpha_2 * z46 - z428;  // angular acceleration of blade_2, z
    const Scalar z433 = a_phi * c_alpha_3 - s_alpha_3 * z352;
    const Scalar z434 = a_alpha_3 + z351;  // angular acceleration of blade_3, x
    const Scalar z436 = v_alpha_3 * z51 - z433;  // angular acceleration of blade_3, z
    const Scalar z438 = a_phi * c_alpha_4 + s_alpha_4 * z351;
    const Scalar z439 = a_alpha_4 + z352;  // angular acceleration of blade_4, x
    const Scalar z441 = v_alpha_4 * z56 - z438;  // angular acceleration of blade_4, z
    const Scalar z442 = z378 + z441;
    const Scalar z443 = n0_4 * (z377 - z439);  // moment on blade_4, x
    const Scalar z444 = n0_4 * z442;  // moment on blade_4, z
    const Scalar z445 = s_alpha_4 * z444;
    const Scalar z446 = c_alpha_4 * z444;
    const Scalar z447 = z385 + z436;
    const Scalar z448 = n0_4 * (z384 - z434);  // moment on blade_3, x
    const Scalar z449 = n0_4 * z447;  // moment on blade_3, z
    const Scalar z450 = s_alpha_3 * z449;
    const Scalar z451 = c_alpha_3 * z449;
    const Scalar z452 = z392 + z431;
    const Scalar z453 = n0_4 * (z391 + z429);  // moment on blade_2, x
    const Scalar z454 = n0_4 * z452;  // moment on blade_2, z
    const Scalar z455 = s_alpha_2 * z454;
    const Scalar z456 = c_alpha_2 * z454;
    const Scalar z457 = z399 + z426;
    const Scalar z458 = n0_4 * (z398 + z424);  // moment on blade_1, x
    const Scalar z459 = n0_4 * z457;  // moment on blade_1, z
    const Scalar z460 = s_alpha_1 * z459;
    const Scalar z461 = c_alpha_1 * z459;
    const Scalar z462 = n1330 * z405 - z445 - z448 + z455 - z458;  // moment on rotor, x
    const Scalar z463 = n1330 * z406 - z443 + z450 - z453 - z460;  // moment on rotor, y
    const Scalar z464 = n1330 * a_phi - z446 - z451 - z456 - z461;  // moment on rotor, z
    const Scalar z465 = s_phi * z463 - c_phi * z462;
    const Scalar z466 = s_phi * z462 + c_phi * z463;
    const Scalar z467 = n665 * z412 - z466;  // moment on pitch, y
    result.X = -z416;
    result.Y = n0;
    result.Z = n0;
    result.M_x = z465;
    result.M_y = z467;
    result.M_z = z464;
  }
};

}  // namespace helicopter_on_a_circle_pitching_blades
