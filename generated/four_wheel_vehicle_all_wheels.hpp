// SPDX-License-Identifier: MIT
// four_wheel_vehicle_all_wheels: Four-wheel vehicle: the eight conditions of its four wheels
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               16               24          0             0                  4       0     48       -
//   kinematics               96              158          0             0                  9       0    272     280
//   mass_matrix              44               48          0             0                  1       0     94     118
//   bias                     43               63          0             0                  1       0    108     191
//   inverse_dynamics        116              117          0             0                  5       0    243     374
//   forward_dynamics        604              751         11             0                  5       0   1376    1499
//   energy                   48               74          0             0                  5       0    132     162
//   constraints              44               56          0             0                  4       0    108     132
//
// Not computed because this mechanism does not need it:
//   kinematics: of 246 results 131 vanish identically, 18 repeat another up to sign
//   mass_matrix: of 121 results 82 vanish identically, 14 repeat another up to sign
//   bias: of 11 results 4 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 112 results 64 vanish identically, 8 repeat another up to sign
//
// To write this file again:
//   four_wheel_vehicle_all_wheels_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output four_wheel_vehicle_all_wheels.hpp
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

namespace four_wheel_vehicle_all_wheels {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle_all_wheels";
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 11;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 8;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha_1;  ///< parameter [rad or 1]
    Scalar alpha_2;  ///< parameter [rad or 1]
    Scalar alpha_3;  ///< parameter [rad or 1]
    Scalar alpha_4;  ///< parameter [rad or 1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::alpha_1, &Parameters::alpha_2, &Parameters::alpha_3,
          &Parameters::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar phi_1;  ///< coordinate [rad or 1]
    Scalar phi_2;  ///< coordinate [rad or 1]
    Scalar phi_3;  ///< coordinate [rad or 1]
    Scalar phi_4;  ///< coordinate [rad or 1]
    Scalar s_1;  ///< coordinate [m]
    Scalar s_2;  ///< coordinate [m]
    Scalar s_3;  ///< coordinate [m]
    Scalar s_4;  ///< coordinate [m]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4, &Coordinates::s_1,
          &Coordinates::s_2, &Coordinates::s_3, &Coordinates::s_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar phi_1;  ///< its rate [rad/s]
    Scalar phi_2;  ///< its rate [rad/s]
    Scalar phi_3;  ///< its rate [rad/s]
    Scalar phi_4;  ///< its rate [rad/s]
    Scalar s_1;  ///< its rate [m/s]
    Scalar s_2;  ///< its rate [m/s]
    Scalar s_3;  ///< its rate [m/s]
    Scalar s_4;  ///< its rate [m/s]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4, &Velocities::s_1, &Velocities::s_2,
          &Velocities::s_3, &Velocities::s_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar phi_1;  ///< its second rate [rad/s^2]
    Scalar phi_2;  ///< its second rate [rad/s^2]
    Scalar phi_3;  ///< its second rate [rad/s^2]
    Scalar phi_4;  ///< its second rate [rad/s^2]
    Scalar s_1;  ///< its second rate [m/s^2]
    Scalar s_2;  ///< its second rate [m/s^2]
    Scalar s_3;  ///< its second rate [m/s^2]
    Scalar s_4;  ///< its second rate [m/s^2]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4,
          &Accelerations::s_1, &Accelerations::s_2, &Accelerations::s_3, &Accelerations::s_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar phi_1;  ///< works with the rate of phi_1 [N m]
    Scalar phi_2;  ///< works with the rate of phi_2 [N m]
    Scalar phi_3;  ///< works with the rate of phi_3 [N m]
    Scalar phi_4;  ///< works with the rate of phi_4 [N m]
    Scalar s_1;  ///< works with the rate of s_1 [N]
    Scalar s_2;  ///< works with the rate of s_2 [N]
    Scalar s_3;  ///< works with the rate of s_3 [N]
    Scalar s_4;  ///< works with the rate of s_4 [N]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4, &GeneralizedForces::s_1, &GeneralizedForces::s_2, &GeneralizedForces::s_3,
          &GeneralizedForces::s_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< of the constraint wheel_4_x [N]
    Scalar lambda_wheel_4_y;  ///< of the constraint wheel_4_y [N]
    static constexpr int size = 8;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_wheel_1_x, &Multipliers::lambda_wheel_1_y,
          &Multipliers::lambda_wheel_2_x, &Multipliers::lambda_wheel_2_y, &Multipliers::lambda_wheel_3_x,
          &Multipliers::lambda_wheel_3_y, &Multipliers::lambda_wheel_4_x, &Multipliers::lambda_wheel_4_y};
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
    Scalar s_alpha_1;
    Scalar c_alpha_1;
    Scalar s_alpha_2;
    Scalar c_alpha_2;
    Scalar s_alpha_3;
    Scalar c_alpha_3;
    Scalar s_alpha_4;
    Scalar c_alpha_4;
    Scalar z207;
    Scalar z208;
    Scalar z209;
    Scalar z239;
    Scalar z240;
    Scalar z241;
    Scalar z276;
    Scalar z277;
    Scalar z278;
    Scalar z313;
    Scalar z314;
    Scalar z315;
    Scalar z494;
    Scalar z495;
    Scalar z503;
    Scalar z504;
    Scalar z512;
    Scalar z513;
    Scalar z521;
    Scalar z522;
    Scalar z540;
    Scalar z549;
    Scalar z558;
    Scalar z567;
    Scalar z584;
    Scalar z603;
    Scalar z622;
    Scalar z641;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar pi = traits::pi();
    parameters.alpha_1 = -n0_25 * pi;
    parameters.alpha_2 = -n1_over_6 * pi;
    parameters.alpha_3 = n0;
    parameters.alpha_4 = n0;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar p_alpha_1 = parameters.alpha_1;
    const Scalar p_alpha_2 = parameters.alpha_2;
    const Scalar p_alpha_3 = parameters.alpha_3;
    const Scalar p_alpha_4 = parameters.alpha_4;
    const Scalar angles_[] = {p_alpha_1, p_alpha_2, p_alpha_3, p_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha_1 = sines_[0], c_alpha_1 = cosines_[0];
    const Scalar s_alpha_2 = sines_[1], c_alpha_2 = cosines_[1];
    const Scalar s_alpha_3 = sines_[2], c_alpha_3 = cosines_[2];
    const Scalar s_alpha_4 = sines_[3], c_alpha_4 = cosines_[3];
    const Scalar z207 = n20 * c_alpha_4;
    const Scalar z208 = n20 * s_alpha_4;
    const Scalar z209 = z207 + k1 * z208;
    const Scalar z239 = n20 * c_alpha_3;
    const Scalar z240 = n20 * s_alpha_3;
    const Scalar z241 = z239 - k1 * z240;
    const Scalar z276 = n20 * c_alpha_2;
    const Scalar z277 = n20 * s_alpha_2;
    const Scalar z278 = z276 + k1 * z277;
    const Scalar z313 = n20 * c_alpha_1;
    const Scalar z314 = n20 * s_alpha_1;
    const Scalar z315 = z313 - k1 * z314;
    const Scalar z494 = s_alpha_1 + k1 * c_alpha_1;
    const Scalar z495 = k1 * s_alpha_1 - c_alpha_1;
    const Scalar z503 = s_alpha_2 - k1 * c_alpha_2;
    const Scalar z504 = k1 * s_alpha_2 + c_alpha_2;
    const Scalar z512 = s_alpha_3 + k1 * c_alpha_3;
    const Scalar z513 = k1 * s_alpha_3 - c_alpha_3;
    const Scalar z521 = s_alpha_4 - k1 * c_alpha_4;
    const Scalar z522 = k1 * s_alpha_4 + c_alpha_4;
    const Scalar z540 = n0_05 * z209;
    const Scalar z549 = n0_05 * z241;
    const Scalar z558 = n0_05 * z278;
    const Scalar z567 = n0_05 * z315;
    const Scalar z584 = z495 + z567;
    const Scalar z603 = z504 - z558;
    const Scalar z622 = z513 + z549;
    const Scalar z641 = z522 - z540;
    precomputed.s_alpha_1 = s_alpha_1;
    precomputed.c_alpha_1 = c_alpha_1;
    precomputed.s_alpha_2 = s_alpha_2;
    precomputed.c_alpha_2 = c_alpha_2;
    precomputed.s_alpha_3 = s_alpha_3;
    precomputed.c_alpha_3 = c_alpha_3;
    precomputed.s_alpha_4 = s_alpha_4;
    precomputed.c_alpha_4 = c_alpha_4;
    precomputed.z207 = z207;
    precomputed.z208 = z208;
    precomputed.z209 = z209;
    precomputed.z239 = z239;
    precomputed.z240 = z240;
    precomputed.z241 = z241;
    precomputed.z276 = z276;
    precomputed.z277 = z277;
    precomputed.z278 = z278;
    precomputed.z313 = z313;
    precomputed.z314 = z314;
    precomputed.z315 = z315;
    precomputed.z494 = z494;
    precomputed.z495 = z495;
    precomputed.z503 = z503;
    precomputed.z504 = z504;
    precomputed.z512 = z512;
    precomputed.z513 = z513;
    precomputed.z521 = z521;
    precomputed.z522 = z522;
    precomputed.z540 = z540;
    precomputed.z549 = z549;
    precomputed.z558 = z558;
    precomputed.z567 = z567;
    precomputed.z584 = z584;
    precomputed.z603 = z603;
    precomputed.z622 = z622;
    precomputed.z641 = z641;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(2.732050807568877, 2.732051f, "1;0;1;0");
    const Scalar k3 = traits::constant(9.428090415820634, 9.42809f, "0;20/3;0;0");
    const Scalar n40_over_3 = traits::constant(13.333333333333334, 13.333333f, "40/3");
    const Scalar k5 = traits::constant(11.547005383792515, 11.547006f, "0;0;20/3;0");
    const Scalar n20_over_3 = traits::constant(6.666666666666667, 6.6666665f, "20/3");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.psi = n0;
    state.q.phi_1 = n0;
    state.q.phi_2 = n0;
    state.q.phi_3 = n0;
    state.q.phi_4 = n0;
    state.q.s_1 = n0;
    state.q.s_2 = n0;
    state.q.s_3 = n0;
    state.q.s_4 = n0;
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
    state.v.s_1 = n0;
    state.v.s_2 = n0;
    state.v.s_3 = n0;
    state.v.s_4 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> chassis_position;  ///< centre of mass of chassis [m]
    std::array<Scalar, 9> chassis_rotation;  ///< from the axes of chassis to the ground's (3 x 3)
    std::array<Scalar, 3> chassis_velocity;  ///< velocity of the centre of mass of chassis [m/s]
    std::array<Scalar, 3> chassis_angular_velocity;  ///< angular velocity of chassis [rad/s]
    std::array<Scalar, 3> wheel_1_position;  ///< centre of mass of wheel_1 [m]
    std::array<Scalar, 9> wheel_1_rotation;  ///< from the axes of wheel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_1_velocity;  ///< velocity of the centre of mass of wheel_1 [m/s]
    std::array<Scalar, 3> wheel_1_angular_velocity;  ///< angular velocity of wheel_1 [rad/s]
    std::array<Scalar, 3> wheel_2_position;  ///< centre of mass of wheel_2 [m]
    std::array<Scalar, 9> wheel_2_rotation;  ///< from the axes of wheel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_2_velocity;  ///< velocity of the centre of mass of wheel_2 [m/s]
    std::array<Scalar, 3> wheel_2_angular_velocity;  ///< angular velocity of wheel_2 [rad/s]
    std::array<Scalar, 3> wheel_3_position;  ///< centre of mass of wheel_3 [m]
    std::array<Scalar, 9> wheel_3_rotation;  ///< from the axes of wheel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_3_velocity;  ///< velocity of the centre of mass of wheel_3 [m/s]
    std::array<Scalar, 3> wheel_3_angular_velocity;  ///< angular velocity of wheel_3 [rad/s]
    std::array<Scalar, 3> wheel_4_position;  ///< centre of mass of wheel_4 [m]
    std::array<Scalar, 9> wheel_4_rotation;  ///< from the axes of wheel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_4_velocity;  ///< velocity of the centre of mass of wheel_4 [m/s]
    std::array<Scalar, 3> wheel_4_angular_velocity;  ///< angular velocity of wheel_4 [rad/s]
    std::array<Scalar, 3> P1_position;  ///< position of P1 [m]
    std::array<Scalar, 3> P1_velocity;  ///< velocity of the material point at P1 [m/s]
    std::array<Scalar, 33> P1_jacobian;  ///< partial velocities of P1 (3 x 11)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 33> P2_jacobian;  ///< partial velocities of P2 (3 x 11)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 33> P3_jacobian;  ///< partial velocities of P3 (3 x 11)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 33> P4_jacobian;  ///< partial velocities of P4 (3 x 11)
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
    std::array<Scalar, 8> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 8> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 88> jacobian;  ///< A, stored column by column (8 x 11)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z103 = q_psi + p_alpha_1;
    const Scalar z126 = q_psi + p_alpha_2;
    const Scalar z149 = q_psi + p_alpha_3;
    const Scalar z172 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4, z103, z126, z149, z172};
    Scalar sines_[9], cosines_[9];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z104 = sines_[5], z105 = cosines_[5];
    const Scalar z127 = sines_[6], z128 = cosines_[6];
    const Scalar z150 = sines_[7], z151 = cosines_[7];
    const Scalar z173 = sines_[8], z174 = cosines_[8];
    const Scalar z55 = v_x * c_psi + v_y * s_psi;
    const Scalar z56 = v_x * s_psi - v_y * c_psi;
    const Scalar z57 = v_psi - z55;
    const Scalar z58 = k0 * v_psi - z56;
    const Scalar z59 = s_alpha_1 * z58 - c_alpha_1 * z57;
    const Scalar z60 = s_alpha_1 * z57 + c_alpha_1 * z58;
    const Scalar z61 = v_psi * q_s_1 + z60;
    const Scalar z62 = v_s_1 + z59;  // velocity of axle_1, x
    const Scalar z63 = v_psi * s_phi_1;
    const Scalar z64 = v_psi * c_phi_1;
    const Scalar z65 = c_phi_1 * z61;
    const Scalar z66 = s_phi_1 * z61;
    const Scalar z67 = k0 * v_psi + z56;
    const Scalar z68 = s_alpha_2 * z67 + c_alpha_2 * z57;
    const Scalar z69 = s_alpha_2 * z57 - c_alpha_2 * z67;
    const Scalar z70 = v_psi * q_s_2 + z69;
    const Scalar z71 = v_s_2 - z68;  // velocity of axle_2, x
    const Scalar z72 = v_psi * s_phi_2;
    const Scalar z73 = v_psi * c_phi_2;
    const Scalar z74 = c_phi_2 * z70;
    const Scalar z75 = s_phi_2 * z70;
    const Scalar z76 = v_psi + z55;
    const Scalar z77 = s_alpha_3 * z67 - c_alpha_3 * z76;
    const Scalar z78 = s_alpha_3 * z76 + c_alpha_3 * z67;
    const Scalar z79 = v_psi * q_s_3 - z78;
    const Scalar z80 = v_s_3 - z77;  // velocity of axle_3, x
    const Scalar z81 = v_psi * s_phi_3;
    const Scalar z82 = v_psi * c_phi_3;
    const Scalar z83 = c_phi_3 * z79;
    const Scalar z84 = s_phi_3 * z79;
    const Scalar z85 = s_alpha_4 * z58 + c_alpha_4 * z76;
    const Scalar z86 = s_alpha_4 * z76 - c_alpha_4 * z58;
    const Scalar z87 = v_psi * q_s_4 - z86;
    const Scalar z88 = v_s_4 + z85;  // velocity of axle_4, x
    const Scalar z89 = v_psi * s_phi_4;
    const Scalar z90 = v_psi * c_phi_4;
    const Scalar z91 = c_phi_4 * z87;
    const Scalar z92 = s_phi_4 * z87;
    const Scalar z93 = s_psi * z56 + c_psi * z55;
    const Scalar z94 = s_psi * z55 - c_psi * z56;
    const Scalar z95 = c_alpha_1 * q_s_1;
    const Scalar z96 = s_alpha_1 * q_s_1;
    const Scalar z97 = k0 + z95;
    const Scalar z98 = n1 + z96;
    const Scalar z99 = s_psi * z98 - c_psi * z97;
    const Scalar z100 = s_psi * z97 + c_psi * z98;
    const Scalar z101 = q_y + z100;
    const Scalar z102 = q_x - z99;
    const Scalar z106 = c_phi_1 * z104;
    const Scalar z107 = c_phi_1 * z105;
    const Scalar z108 = s_phi_1 * z104;
    const Scalar z109 = s_phi_1 * z105;
    const Scalar z110 = s_phi_1 * z66 + c_phi_1 * z65;
    const Scalar z112 = z62 * z105 - z104 * z110;
    const Scalar z113 = z62 * z104 + z105 * z110;
    const Scalar z114 = s_phi_1 * z64 - c_phi_1 * z63;
    const Scalar z115 = s_phi_1 * z63 + c_phi_1 * z64;
    const Scalar z116 = v_phi_1 * z105 + z104 * z114;
    const Scalar z117 = v_phi_1 * z104 - z105 * z114;
    const Scalar z118 = c_alpha_2 * q_s_2;
    const Scalar z119 = s_alpha_2 * q_s_2;
    const Scalar z120 = k0 - z118;
    const Scalar z121 = n1 + z119;
    const Scalar z122 = s_psi * z121 + c_psi * z120;
    const Scalar z123 = s_psi * z120 - c_psi * z121;
    const Scalar z124 = q_y - z123;
    const Scalar z125 = q_x - z122;
    const Scalar z129 = c_phi_2 * z127;
    const Scalar z130 = c_phi_2 * z128;
    const Scalar z131 = s_phi_2 * z127;
    const Scalar z132 = s_phi_2 * z128;
    const Scalar z133 = s_phi_2 * z75 + c_phi_2 * z74;
    const Scalar z135 = z71 * z128 - z127 * z133;
    const Scalar z136 = z71 * z127 + z128 * z133;
    const Scalar z137 = s_phi_2 * z73 - c_phi_2 * z72;
    const Scalar z138 = s_phi_2 * z72 + c_phi_2 * z73;
    const Scalar z139 = v_phi_2 * z128 + z127 * z137;
    const Scalar z140 = v_phi_2 * z127 - z128 * z137;
    const Scalar z141 = c_alpha_3 * q_s_3;
    const Scalar z142 = s_alpha_3 * q_s_3;
    const Scalar z143 = k0 - z141;
    const Scalar z144 = n1 - z142;
    const Scalar z145 = s_psi * z144 - c_psi * z143;
    const Scalar z146 = s_psi * z143 + c_psi * z144;
    const Scalar z147 = q_y - z146;
    const Scalar z148 = q_x + z145;
    const Scalar z152 = c_phi_3 * z150;
    const Scalar z153 = c_phi_3 * z151;
    const Scalar z154 = s_phi_3 * z150;
    const Scalar z155 = s_phi_3 * z151;
    const Scalar z156 = s_phi_3 * z84 + c_phi_3 * z83;
    const Scalar z158 = z80 * z151 - z150 * z156;
    const Scalar z159 = z80 * z150 + z151 * z156;
    const Scalar z160 = s_phi_3 * z82 - c_phi_3 * z81;
    const Scalar z161 = s_phi_3 * z81 + c_phi_3 * z82;
    const Scalar z162 = v_phi_3 * z151 + z150 * z160;
    const Scalar z163 = v_phi_3 * z150 - z151 * z160;
    const Scalar z164 = c_alpha_4 * q_s_4;
    const Scalar z165 = s_alpha_4 * q_s_4;
    const Scalar z166 = k0 + z164;
    const Scalar z167 = n1 - z165;
    const Scalar z168 = s_psi * z167 + c_psi * z166;
    const Scalar z169 = s_psi * z166 - c_psi * z167;
    const Scalar z170 = q_y + z169;
    const Scalar z171 = q_x + z168;
    const Scalar z175 = c_phi_4 * z173;
    const Scalar z176 = c_phi_4 * z174;
    const Scalar z177 = s_phi_4 * z173;
    const Scalar z178 = s_phi_4 * z174;
    const Scalar z179 = s_phi_4 * z92 + c_phi_4 * z91;
    const Scalar z181 = z88 * z174 - z173 * z179;
    const Scalar z182 = z88 * z173 + z174 * z179;
    const Scalar z183 = s_phi_4 * z90 - c_phi_4 * z89;
    const Scalar z184 = s_phi_4 * z89 + c_phi_4 * z90;
    const Scalar z185 = v_phi_4 * z174 + z173 * z183;
    const Scalar z186 = v_phi_4 * z173 - z174 * z183;
    const Scalar z187 = z61 * z104 - z62 * z105;
    const Scalar z188 = z61 * z105 + z62 * z104;
    const Scalar z189 = q_x - z102;
    const Scalar z190 = q_y - z101;
    const Scalar z191 = z70 * z127 - z71 * z128;
    const Scalar z192 = z70 * z128 + z71 * z127;
    const Scalar z193 = q_x - z125;
    const Scalar z194 = q_y - z124;
    const Scalar z195 = z79 * z150 - z80 * z151;
    const Scalar z196 = z79 * z151 + z80 * z150;
    const Scalar z197 = q_x - z148;
    const Scalar z198 = q_y - z147;
    const Scalar z199 = z87 * z173 - z88 * z174;
    const Scalar z200 = z87 * z174 + z88 * z173;
    const Scalar z201 = q_x - z171;
    const Scalar z202 = q_y - z170;
    result.chassis_position[0] = q_x;
    result.chassis_position[1] = q_y;
    result.chassis_position[2] = n0_3;
    result.chassis_rotation[0] = c_psi;
    result.chassis_rotation[1] = s_psi;
    result.chassis_rotation[2] = n0;
    result.chassis_rotation[3] = -s_psi;
    result.chassis_rotation[4] = c_psi;
    result.chassis_rotation[5] = n0;
    result.chassis_rotation[6] = n0;
    result.chassis_rotation[7] = n0;
    result.chassis_rotation[8] = n1;
    result.chassis_velocity[0] = z93;
    result.chassis_velocity[1] = z94;
    result.chassis_velocity[2] = n0;
    result.chassis_angular_velocity[0] = n0;
    result.chassis_angular_velocity[1] = n0;
    result.chassis_angular_velocity[2] = v_psi;
    result.wheel_1_position[0] = z102;
    result.wheel_1_position[1] = z101;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z105;
    result.wheel_1_rotation[1] = z104;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z106;
    result.wheel_1_rotation[4] = z107;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z108;
    result.wheel_1_rotation[7] = -z109;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z112;
    result.wheel_1_velocity[1] = z113;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z116;
    result.wheel_1_angular_velocity[1] = z117;
    result.wheel_1_angular_velocity[2] = z115;
    result.wheel_2_position[0] = z125;
    result.wheel_2_position[1] = z124;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z128;
    result.wheel_2_rotation[1] = z127;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z129;
    result.wheel_2_rotation[4] = z130;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z131;
    result.wheel_2_rotation[7] = -z132;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = z135;
    result.wheel_2_velocity[1] = z136;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z139;
    result.wheel_2_angular_velocity[1] = z140;
    result.wheel_2_angular_velocity[2] = z138;
    result.wheel_3_position[0] = z148;
    result.wheel_3_position[1] = z147;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = z151;
    result.wheel_3_rotation[1] = z150;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z152;
    result.wheel_3_rotation[4] = z153;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z154;
    result.wheel_3_rotation[7] = -z155;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = z158;
    result.wheel_3_velocity[1] = z159;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z162;
    result.wheel_3_angular_velocity[1] = z163;
    result.wheel_3_angular_velocity[2] = z161;
    result.wheel_4_position[0] = z171;
    result.wheel_4_position[1] = z170;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = z174;
    result.wheel_4_rotation[1] = z173;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z175;
    result.wheel_4_rotation[4] = z176;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z177;
    result.wheel_4_rotation[7] = -z178;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z181;
    result.wheel_4_velocity[1] = z182;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z185;
    result.wheel_4_angular_velocity[1] = z186;
    result.wheel_4_angular_velocity[2] = z184;
    result.P1_position[0] = z102;
    result.P1_position[1] = z101;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = -z187;
    result.P1_velocity[1] = z188;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = z190;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[21] = z105;
    result.P1_jacobian[24] = n0;
    result.P1_jacobian[27] = n0;
    result.P1_jacobian[30] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z189;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[22] = z104;
    result.P1_jacobian[25] = n0;
    result.P1_jacobian[28] = n0;
    result.P1_jacobian[31] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P1_jacobian[23] = n0;
    result.P1_jacobian[26] = n0;
    result.P1_jacobian[29] = n0;
    result.P1_jacobian[32] = n0;
    result.P2_position[0] = z125;
    result.P2_position[1] = z124;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = -z191;
    result.P2_velocity[1] = z192;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z194;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[21] = n0;
    result.P2_jacobian[24] = z128;
    result.P2_jacobian[27] = n0;
    result.P2_jacobian[30] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z193;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[22] = n0;
    result.P2_jacobian[25] = z127;
    result.P2_jacobian[28] = n0;
    result.P2_jacobian[31] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P2_jacobian[23] = n0;
    result.P2_jacobian[26] = n0;
    result.P2_jacobian[29] = n0;
    result.P2_jacobian[32] = n0;
    result.P3_position[0] = z148;
    result.P3_position[1] = z147;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = -z195;
    result.P3_velocity[1] = z196;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z198;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[21] = n0;
    result.P3_jacobian[24] = n0;
    result.P3_jacobian[27] = z151;
    result.P3_jacobian[30] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = -z197;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[22] = n0;
    result.P3_jacobian[25] = n0;
    result.P3_jacobian[28] = z150;
    result.P3_jacobian[31] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P3_jacobian[23] = n0;
    result.P3_jacobian[26] = n0;
    result.P3_jacobian[29] = n0;
    result.P3_jacobian[32] = n0;
    result.P4_position[0] = z171;
    result.P4_position[1] = z170;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = -z199;
    result.P4_velocity[1] = z200;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = z202;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[21] = n0;
    result.P4_jacobian[24] = n0;
    result.P4_jacobian[27] = n0;
    result.P4_jacobian[30] = z174;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = -z201;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[22] = n0;
    result.P4_jacobian[25] = n0;
    result.P4_jacobian[28] = n0;
    result.P4_jacobian[31] = z173;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
    result.P4_jacobian[23] = n0;
    result.P4_jacobian[26] = n0;
    result.P4_jacobian[29] = n0;
    result.P4_jacobian[32] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 121>& mass) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k4 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar k5 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar q_psi = state.q.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z207 = precomputed.z207;
    const Scalar z208 = precomputed.z208;
    const Scalar z209 = precomputed.z209;
    const Scalar z239 = precomputed.z239;
    const Scalar z240 = precomputed.z240;
    const Scalar z241 = precomputed.z241;
    const Scalar z276 = precomputed.z276;
    const Scalar z277 = precomputed.z277;
    const Scalar z278 = precomputed.z278;
    const Scalar z313 = precomputed.z313;
    const Scalar z314 = precomputed.z314;
    const Scalar z315 = precomputed.z315;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z210 = s_psi * z208 - c_psi * z207;
    const Scalar z211 = s_psi * z207 + c_psi * z208;
    const Scalar z213 = n20 * q_s_4 * q_s_4;
    const Scalar z214 = n20 * q_s_4;
    const Scalar z215 = n0_5 + z213;
    const Scalar z216 = s_alpha_4 * z214;
    const Scalar z217 = c_alpha_4 * z214;
    const Scalar z231 = k2 + z215 - n2 * z216 + k4 * z217;
    const Scalar z232 = k5 + z217;
    const Scalar z233 = n20 - z216;
    const Scalar z234 = n900 + z231;
    const Scalar z242 = s_psi * z240 - c_psi * z239;
    const Scalar z243 = s_psi * z239 + c_psi * z240;
    const Scalar z245 = n20 * q_s_3 * q_s_3;
    const Scalar z246 = n20 * q_s_3;
    const Scalar z247 = n0_5 + z245;
    const Scalar z248 = s_alpha_3 * z246;
    const Scalar z249 = c_alpha_3 * z246;
    const Scalar z263 = k2 + z247 - n2 * z248 - k4 * z249;
    const Scalar z264 = k5 - z249;
    const Scalar z265 = n20 - z248;
    const Scalar z266 = z232 - z264;
    const Scalar z267 = z233 + z265;
    const Scalar z271 = z234 + z263;
    const Scalar z279 = s_psi * z277 - c_psi * z276;
    const Scalar z280 = s_psi * z276 + c_psi * z277;
    const Scalar z282 = n20 * q_s_2 * q_s_2;
    const Scalar z283 = n20 * q_s_2;
    const Scalar z284 = n0_5 + z282;
    const Scalar z285 = s_alpha_2 * z283;
    const Scalar z286 = c_alpha_2 * z283;
    const Scalar z300 = k2 + z284 + n2 * z285 - k4 * z286;
    const Scalar z301 = k5 - z286;
    const Scalar z302 = n20 + z285;
    const Scalar z303 = z266 - z301;
    const Scalar z304 = z267 - z302;
    const Scalar z308 = z271 + z300;
    const Scalar z316 = s_psi * z314 - c_psi * z313;
    const Scalar z317 = s_psi * z313 + c_psi * z314;
    const Scalar z319 = n20 * q_s_1 * q_s_1;
    const Scalar z320 = n20 * q_s_1;
    const Scalar z321 = n0_5 + z319;
    const Scalar z322 = s_alpha_1 * z320;
    const Scalar z323 = c_alpha_1 * z320;
    const Scalar z337 = k2 + z321 + n2 * z322 + k4 * z323;
    const Scalar z338 = k5 + z323;
    const Scalar z339 = n20 + z322;
    const Scalar z340 = z303 + z338;
    const Scalar z341 = z304 - z339;
    const Scalar z345 = z308 + z337;
    const Scalar z346 = s_psi * z340 - c_psi * z341;
    const Scalar z347 = s_psi * z341 + c_psi * z340;
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = -z346;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = -z316;
    mass[8] = -z279;
    mass[9] = -z242;
    mass[10] = -z210;
    mass[11] = n0;
    mass[12] = n880;
    mass[13] = z347;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z317;
    mass[19] = z280;
    mass[20] = z243;
    mass[21] = z211;
    mass[22] = -z346;
    mass[23] = z347;
    mass[24] = z345;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = -z315;
    mass[30] = -z278;
    mass[31] = z241;
    mass[32] = z209;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0_9;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
    mass[49] = n0;
    mass[50] = n0;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = n0;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = n0_9;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = n0;
    mass[71] = n0;
    mass[72] = n0_9;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = -z316;
    mass[78] = z317;
    mass[79] = -z315;
    mass[80] = n0;
    mass[81] = n0;
    mass[82] = n0;
    mass[83] = n0;
    mass[84] = n20;
    mass[85] = n0;
    mass[86] = n0;
    mass[87] = n0;
    mass[88] = -z279;
    mass[89] = z280;
    mass[90] = -z278;
    mass[91] = n0;
    mass[92] = n0;
    mass[93] = n0;
    mass[94] = n0;
    mass[95] = n0;
    mass[96] = n20;
    mass[97] = n0;
    mass[98] = n0;
    mass[99] = -z242;
    mass[100] = z243;
    mass[101] = z241;
    mass[102] = n0;
    mass[103] = n0;
    mass[104] = n0;
    mass[105] = n0;
    mass[106] = n0;
    mass[107] = n0;
    mass[108] = n20;
    mass[109] = n0;
    mass[110] = -z210;
    mass[111] = z211;
    mass[112] = z209;
    mass[113] = n0;
    mass[114] = n0;
    mass[115] = n0;
    mass[116] = n0;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n20;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z360 = v_psi * v_psi;
    const Scalar z361 = k0 * z360;
    const Scalar z362 = s_alpha_1 * z360 + c_alpha_1 * z361;
    const Scalar z363 = s_alpha_1 * z361 - c_alpha_1 * z360;
    const Scalar z364 = q_s_1 * z360 + z362;
    const Scalar z365 = n2 * v_psi * v_s_1 + z363;
    const Scalar z367 = s_alpha_2 * z360 - c_alpha_2 * z361;
    const Scalar z368 = s_alpha_2 * z361 + c_alpha_2 * z360;
    const Scalar z369 = q_s_2 * z360 + z367;
    const Scalar z370 = n2 * v_psi * v_s_2 - z368;
    const Scalar z372 = s_alpha_3 * z360 + c_alpha_3 * z361;
    const Scalar z373 = s_alpha_3 * z361 - c_alpha_3 * z360;
    const Scalar z374 = q_s_3 * z360 - z372;
    const Scalar z375 = n2 * v_psi * v_s_3 - z373;
    const Scalar z377 = s_alpha_4 * z360 - c_alpha_4 * z361;
    const Scalar z378 = s_alpha_4 * z361 + c_alpha_4 * z360;
    const Scalar z379 = q_s_4 * z360 - z377;
    const Scalar z380 = n2 * v_psi * v_s_4 + z378;
    const Scalar z383 = n20 * z379;  // force on axle_4, x
    const Scalar z384 = n20 * z380;  // force on axle_4, y
    const Scalar z385 = q_s_4 * z384;  // moment on steered_4, z
    const Scalar z386 = s_alpha_4 * z384 + c_alpha_4 * z383;
    const Scalar z387 = s_alpha_4 * z383 - c_alpha_4 * z384;
    const Scalar z391 = n20 * z374;  // force on axle_3, x
    const Scalar z392 = n20 * z375;  // force on axle_3, y
    const Scalar z393 = q_s_3 * z392;  // moment on steered_3, z
    const Scalar z394 = s_alpha_3 * z392 + c_alpha_3 * z391;
    const Scalar z395 = s_alpha_3 * z391 - c_alpha_3 * z392;
    const Scalar z399 = n20 * z369;  // force on axle_2, x
    const Scalar z400 = n20 * z370;  // force on axle_2, y
    const Scalar z401 = q_s_2 * z400;  // moment on steered_2, z
    const Scalar z402 = s_alpha_2 * z400 + c_alpha_2 * z399;
    const Scalar z403 = s_alpha_2 * z399 - c_alpha_2 * z400;
    const Scalar z407 = n20 * z364;  // force on axle_1, x
    const Scalar z408 = n20 * z365;  // force on axle_1, y
    const Scalar z409 = q_s_1 * z408;  // moment on steered_1, z
    const Scalar z410 = s_alpha_1 * z408 + c_alpha_1 * z407;
    const Scalar z411 = s_alpha_1 * z407 - c_alpha_1 * z408;
    const Scalar z414 = z386 + z394 + z402 + z410;  // force on S, x
    const Scalar z415 = z387 + z395 + z403 + z411;  // force on S, y
    // moment on S, z
    const Scalar z418 = -k0 * (z387 - z395 - z403 + z411) + z385 - z386 + z393 - z394 + z401 + z402 + z409 + z410;
    const Scalar z419 = s_psi * z415 - c_psi * z414;
    const Scalar z420 = s_psi * z414 + c_psi * z415;
    forces.x = z419;
    forces.y = -z420;
    forces.psi = z418;
    forces.phi_1 = n0;
    forces.phi_2 = n0;
    forces.phi_3 = n0;
    forces.phi_4 = n0;
    forces.s_1 = -z407;
    forces.s_2 = -z399;
    forces.s_3 = -z391;
    forces.s_4 = -z383;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar a_s_1 = accelerations.s_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar a_s_2 = accelerations.s_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar a_s_3 = accelerations.s_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar a_s_4 = accelerations.s_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z494 = precomputed.z494;
    const Scalar z495 = precomputed.z495;
    const Scalar z503 = precomputed.z503;
    const Scalar z504 = precomputed.z504;
    const Scalar z512 = precomputed.z512;
    const Scalar z513 = precomputed.z513;
    const Scalar z521 = precomputed.z521;
    const Scalar z522 = precomputed.z522;
    const Scalar z103 = q_psi + p_alpha_1;
    const Scalar z126 = q_psi + p_alpha_2;
    const Scalar z149 = q_psi + p_alpha_3;
    const Scalar z172 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z103, z126, z149, z172};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z104 = sines_[1], z105 = cosines_[1];
    const Scalar z127 = sines_[2], z128 = cosines_[2];
    const Scalar z150 = sines_[3], z151 = cosines_[3];
    const Scalar z173 = sines_[4], z174 = cosines_[4];
    const Scalar z360 = v_psi * v_psi;
    const Scalar z424 = a_x * c_psi + a_y * s_psi;
    const Scalar z425 = a_x * s_psi - a_y * c_psi;
    const Scalar z426 = a_psi + k0 * z360 - z424;
    const Scalar z427 = k0 * a_psi - z360 - z425;
    const Scalar z428 = s_alpha_1 * z427 - c_alpha_1 * z426;
    const Scalar z429 = s_alpha_1 * z426 + c_alpha_1 * z427;
    const Scalar z430 = q_s_1 * z360 - a_s_1 - z428;
    const Scalar z431 = n2 * v_psi * v_s_1 + a_psi * q_s_1 + z429;
    const Scalar z432 = a_psi - k0 * z360 - z424;
    const Scalar z433 = k0 * a_psi + z360 + z425;
    const Scalar z434 = s_alpha_2 * z433 + c_alpha_2 * z432;
    const Scalar z435 = s_alpha_2 * z432 - c_alpha_2 * z433;
    const Scalar z436 = q_s_2 * z360 - a_s_2 + z434;
    const Scalar z437 = n2 * v_psi * v_s_2 + a_psi * q_s_2 + z435;
    const Scalar z438 = a_psi + k0 * z360 + z424;
    const Scalar z439 = k0 * a_psi - z360 + z425;
    const Scalar z440 = s_alpha_3 * z439 - c_alpha_3 * z438;
    const Scalar z441 = s_alpha_3 * z438 + c_alpha_3 * z439;
    const Scalar z442 = q_s_3 * z360 - a_s_3 + z440;
    const Scalar z443 = n2 * v_psi * v_s_3 + a_psi * q_s_3 - z441;
    const Scalar z444 = a_psi - k0 * z360 + z424;
    const Scalar z445 = k0 * a_psi + z360 - z425;
    const Scalar z446 = s_alpha_4 * z445 + c_alpha_4 * z444;
    const Scalar z447 = s_alpha_4 * z444 - c_alpha_4 * z445;
    const Scalar z448 = q_s_4 * z360 - a_s_4 - z446;
    const Scalar z449 = n2 * v_psi * v_s_4 + a_psi * q_s_4 - z447;
    const Scalar z450 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z451 = n20 * z448;  // force on axle_4, x
    const Scalar z452 = n20 * z449;  // force on axle_4, y
    const Scalar z453 = n0_5 * a_psi + q_s_4 * z452;  // moment on steered_4, z
    const Scalar z454 = s_alpha_4 * z452 + c_alpha_4 * z451;
    const Scalar z455 = s_alpha_4 * z451 - c_alpha_4 * z452;
    const Scalar z458 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z459 = n20 * z442;  // force on axle_3, x
    const Scalar z460 = n20 * z443;  // force on axle_3, y
    const Scalar z461 = n0_5 * a_psi + q_s_3 * z460;  // moment on steered_3, z
    const Scalar z462 = s_alpha_3 * z460 + c_alpha_3 * z459;
    const Scalar z463 = s_alpha_3 * z459 - c_alpha_3 * z460;
    const Scalar z466 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z467 = n20 * z436;  // force on axle_2, x
    const Scalar z468 = n20 * z437;  // force on axle_2, y
    const Scalar z469 = n0_5 * a_psi + q_s_2 * z468;  // moment on steered_2, z
    const Scalar z470 = s_alpha_2 * z468 + c_alpha_2 * z467;
    const Scalar z471 = s_alpha_2 * z467 - c_alpha_2 * z468;
    const Scalar z474 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z475 = n20 * z430;  // force on axle_1, x
    const Scalar z476 = n20 * z431;  // force on axle_1, y
    const Scalar z477 = n0_5 * a_psi + q_s_1 * z476;  // moment on steered_1, z
    const Scalar z478 = s_alpha_1 * z476 + c_alpha_1 * z475;
    const Scalar z479 = s_alpha_1 * z475 - c_alpha_1 * z476;
    const Scalar z482 = z454 + z462 + z470 + z478;  // force on S, x
    const Scalar z483 = z455 + z463 + z471 + z479;  // force on S, y
    // moment on S, z
    const Scalar z486 = -k0 * (z455 - z463 - z471 + z479) + n900 * a_psi + z453 - z454 + z461 - z462 + z469 + z470
        + z477 + z478;
    const Scalar z487 = s_psi * z483 - c_psi * z482;
    const Scalar z488 = s_psi * z482 + c_psi * z483;
    const Scalar z491 = n800 * a_x + z487;  // force on S.y, x
    const Scalar z492 = n800 * a_y - z488;  // force on S.y, y
    const Scalar z496 = q_s_1 + z494;
    const Scalar z505 = q_s_2 + z503;
    const Scalar z514 = q_s_3 - z512;
    const Scalar z523 = q_s_4 - z521;
    forces.x = z104 * l_lambda_wheel_1_y - z105 * l_lambda_wheel_1_x + z127 * l_lambda_wheel_2_y - z128
        * l_lambda_wheel_2_x + z150 * l_lambda_wheel_3_y - z151 * l_lambda_wheel_3_x + z173 * l_lambda_wheel_4_y - z174
        * l_lambda_wheel_4_x + z491;
    forces.y = -z104 * l_lambda_wheel_1_x - z105 * l_lambda_wheel_1_y - z127 * l_lambda_wheel_2_x - z128
        * l_lambda_wheel_2_y - z150 * l_lambda_wheel_3_x - z151 * l_lambda_wheel_3_y - z173 * l_lambda_wheel_4_x - z174
        * l_lambda_wheel_4_y + z492;
    forces.psi = z486 - z495 * l_lambda_wheel_1_x - z496 * l_lambda_wheel_1_y + z504 * l_lambda_wheel_2_x - z505
        * l_lambda_wheel_2_y + z513 * l_lambda_wheel_3_x - z514 * l_lambda_wheel_3_y - z522 * l_lambda_wheel_4_x - z523
        * l_lambda_wheel_4_y;
    forces.phi_1 = z474 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z466 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z458 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z450 - n0_3 * l_lambda_wheel_4_y;
    forces.s_1 = -z475 - l_lambda_wheel_1_x;
    forces.s_2 = -z467 - l_lambda_wheel_2_x;
    forces.s_3 = -z459 - l_lambda_wheel_3_x;
    forces.s_4 = -z451 - l_lambda_wheel_4_x;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k4 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar k5 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar k7 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar z207 = precomputed.z207;
    const Scalar z208 = precomputed.z208;
    const Scalar z209 = precomputed.z209;
    const Scalar z239 = precomputed.z239;
    const Scalar z240 = precomputed.z240;
    const Scalar z241 = precomputed.z241;
    const Scalar z276 = precomputed.z276;
    const Scalar z277 = precomputed.z277;
    const Scalar z278 = precomputed.z278;
    const Scalar z313 = precomputed.z313;
    const Scalar z314 = precomputed.z314;
    const Scalar z315 = precomputed.z315;
    const Scalar z494 = precomputed.z494;
    const Scalar z495 = precomputed.z495;
    const Scalar z503 = precomputed.z503;
    const Scalar z504 = precomputed.z504;
    const Scalar z512 = precomputed.z512;
    const Scalar z513 = precomputed.z513;
    const Scalar z521 = precomputed.z521;
    const Scalar z522 = precomputed.z522;
    const Scalar z540 = precomputed.z540;
    const Scalar z549 = precomputed.z549;
    const Scalar z558 = precomputed.z558;
    const Scalar z567 = precomputed.z567;
    const Scalar z584 = precomputed.z584;
    const Scalar z603 = precomputed.z603;
    const Scalar z622 = precomputed.z622;
    const Scalar z641 = precomputed.z641;
    const Scalar z103 = q_psi + p_alpha_1;
    const Scalar z126 = q_psi + p_alpha_2;
    const Scalar z149 = q_psi + p_alpha_3;
    const Scalar z172 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z103, z126, z149, z172};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z104 = sines_[1], z105 = cosines_[1];
    const Scalar z127 = sines_[2], z128 = cosines_[2];
    const Scalar z150 = sines_[3], z151 = cosines_[3];
    const Scalar z173 = sines_[4], z174 = cosines_[4];
    const Scalar z210 = s_psi * z208 - c_psi * z207;
    const Scalar z211 = s_psi * z207 + c_psi * z208;
    const Scalar z213 = n20 * q_s_4 * q_s_4;
    const Scalar z214 = n20 * q_s_4;
    const Scalar z215 = n0_5 + z213;
    const Scalar z216 = s_alpha_4 * z214;
    const Scalar z217 = c_alpha_4 * z214;
    const Scalar z231 = k2 + z215 - n2 * z216 + k4 * z217;
    const Scalar z232 = k5 + z217;
    const Scalar z233 = n20 - z216;
    const Scalar z234 = n900 + z231;
    const Scalar z242 = s_psi * z240 - c_psi * z239;
    const Scalar z243 = s_psi * z239 + c_psi * z240;
    const Scalar z245 = n20 * q_s_3 * q_s_3;
    const Scalar z246 = n20 * q_s_3;
    const Scalar z247 = n0_5 + z245;
    const Scalar z248 = s_alpha_3 * z246;
    const Scalar z249 = c_alpha_3 * z246;
    const Scalar z263 = k2 + z247 - n2 * z248 - k4 * z249;
    const Scalar z264 = k5 - z249;
    const Scalar z265 = n20 - z248;
    const Scalar z266 = z232 - z264;
    const Scalar z267 = z233 + z265;
    const Scalar z271 = z234 + z263;
    const Scalar z279 = s_psi * z277 - c_psi * z276;
    const Scalar z280 = s_psi * z276 + c_psi * z277;
    const Scalar z282 = n20 * q_s_2 * q_s_2;
    const Scalar z283 = n20 * q_s_2;
    const Scalar z284 = n0_5 + z282;
    const Scalar z285 = s_alpha_2 * z283;
    const Scalar z286 = c_alpha_2 * z283;
    const Scalar z300 = k2 + z284 + n2 * z285 - k4 * z286;
    const Scalar z301 = k5 - z286;
    const Scalar z302 = n20 + z285;
    const Scalar z303 = z266 - z301;
    const Scalar z304 = z267 - z302;
    const Scalar z308 = z271 + z300;
    const Scalar z316 = s_psi * z314 - c_psi * z313;
    const Scalar z317 = s_psi * z313 + c_psi * z314;
    const Scalar z319 = n20 * q_s_1 * q_s_1;
    const Scalar z320 = n20 * q_s_1;
    const Scalar z321 = n0_5 + z319;
    const Scalar z322 = s_alpha_1 * z320;
    const Scalar z323 = c_alpha_1 * z320;
    const Scalar z337 = k2 + z321 + n2 * z322 + k4 * z323;
    const Scalar z338 = k5 + z323;
    const Scalar z339 = n20 + z322;
    const Scalar z340 = z303 + z338;
    const Scalar z341 = z304 - z339;
    const Scalar z345 = z308 + z337;
    const Scalar z346 = s_psi * z340 - c_psi * z341;
    const Scalar z347 = s_psi * z341 + c_psi * z340;
    const Scalar z360 = v_psi * v_psi;
    const Scalar z361 = k7 * z360;
    const Scalar z362 = s_alpha_1 * z360 + c_alpha_1 * z361;
    const Scalar z363 = s_alpha_1 * z361 - c_alpha_1 * z360;
    const Scalar z364 = q_s_1 * z360 + z362;
    const Scalar z365 = n2 * v_psi * v_s_1 + z363;
    const Scalar z367 = s_alpha_2 * z360 - c_alpha_2 * z361;
    const Scalar z368 = s_alpha_2 * z361 + c_alpha_2 * z360;
    const Scalar z369 = q_s_2 * z360 + z367;
    const Scalar z370 = n2 * v_psi * v_s_2 - z368;
    const Scalar z372 = s_alpha_3 * z360 + c_alpha_3 * z361;
    const Scalar z373 = s_alpha_3 * z361 - c_alpha_3 * z360;
    const Scalar z374 = q_s_3 * z360 - z372;
    const Scalar z375 = n2 * v_psi * v_s_3 - z373;
    const Scalar z377 = s_alpha_4 * z360 - c_alpha_4 * z361;
    const Scalar z378 = s_alpha_4 * z361 + c_alpha_4 * z360;
    const Scalar z379 = q_s_4 * z360 - z377;
    const Scalar z380 = n2 * v_psi * v_s_4 + z378;
    const Scalar z383 = n20 * z379;  // force on axle_4, x
    const Scalar z384 = n20 * z380;  // force on axle_4, y
    const Scalar z385 = q_s_4 * z384;  // moment on steered_4, z
    const Scalar z386 = s_alpha_4 * z384 + c_alpha_4 * z383;
    const Scalar z387 = s_alpha_4 * z383 - c_alpha_4 * z384;
    const Scalar z391 = n20 * z374;  // force on axle_3, x
    const Scalar z392 = n20 * z375;  // force on axle_3, y
    const Scalar z393 = q_s_3 * z392;  // moment on steered_3, z
    const Scalar z394 = s_alpha_3 * z392 + c_alpha_3 * z391;
    const Scalar z395 = s_alpha_3 * z391 - c_alpha_3 * z392;
    const Scalar z399 = n20 * z369;  // force on axle_2, x
    const Scalar z400 = n20 * z370;  // force on axle_2, y
    const Scalar z401 = q_s_2 * z400;  // moment on steered_2, z
    const Scalar z402 = s_alpha_2 * z400 + c_alpha_2 * z399;
    const Scalar z403 = s_alpha_2 * z399 - c_alpha_2 * z400;
    const Scalar z407 = n20 * z364;  // force on axle_1, x
    const Scalar z408 = n20 * z365;  // force on axle_1, y
    const Scalar z409 = q_s_1 * z408;  // moment on steered_1, z
    const Scalar z410 = s_alpha_1 * z408 + c_alpha_1 * z407;
    const Scalar z411 = s_alpha_1 * z407 - c_alpha_1 * z408;
    const Scalar z414 = z386 + z394 + z402 + z410;  // force on S, x
    const Scalar z415 = z387 + z395 + z403 + z411;  // force on S, y
    // moment on S, z
    const Scalar z418 = -k7 * (z387 - z395 - z403 + z411) + z385 - z386 + z393 - z394 + z401 + z402 + z409 + z410;
    const Scalar z419 = s_psi * z415 - c_psi * z414;
    const Scalar z420 = s_psi * z414 + c_psi * z415;
    const Scalar z496 = q_s_1 + z494;
    const Scalar z498 = v_psi * z104;
    const Scalar z499 = v_psi * z105;
    const Scalar z500 = v_x * z498 - v_y * z499;
    const Scalar z502 = v_x * z499 + v_y * z498 - v_psi * v_s_1;
    const Scalar z505 = q_s_2 + z503;
    const Scalar z507 = v_psi * z127;
    const Scalar z508 = v_psi * z128;
    const Scalar z509 = v_x * z507 - v_y * z508;
    const Scalar z511 = v_x * z508 + v_y * z507 - v_psi * v_s_2;
    const Scalar z514 = q_s_3 - z512;
    const Scalar z516 = v_psi * z150;
    const Scalar z517 = v_psi * z151;
    const Scalar z518 = v_x * z516 - v_y * z517;
    const Scalar z520 = v_x * z517 + v_y * z516 - v_psi * v_s_3;
    const Scalar z523 = q_s_4 - z521;
    const Scalar z525 = v_psi * z173;
    const Scalar z526 = v_psi * z174;
    const Scalar z527 = v_x * z525 - v_y * z526;
    const Scalar z529 = v_x * z526 + v_y * z525 - v_psi * v_s_4;
    const Scalar z538 = n0_05 * z210;
    const Scalar z539 = n0_05 * z211;
    const Scalar z541 = n880 - z210 * z538;
    const Scalar z542 = z210 * z539;
    const Scalar z543 = n880 - z211 * z539;
    const Scalar z544 = z210 * z540 - z346;
    const Scalar z545 = z211 * z540 - z347;
    const Scalar z546 = z209 * z540 - z345;
    const Scalar z547 = n0_05 * z242;
    const Scalar z548 = n0_05 * z243;
    const Scalar z550 = z242 * z547 - z541;
    const Scalar z551 = z242 * z548 + z542;
    const Scalar z552 = z243 * z548 - z543;
    const Scalar z553 = z242 * z549 + z544;
    const Scalar z554 = z243 * z549 + z545;
    const Scalar z555 = z241 * z549 + z546;
    const Scalar z556 = n0_05 * z279;
    const Scalar z557 = n0_05 * z280;
    const Scalar z559 = z279 * z556 + z550;
    const Scalar z560 = z279 * z557 + z551;
    const Scalar z561 = z280 * z557 + z552;
    const Scalar z562 = z279 * z558 - z553;
    const Scalar z563 = z280 * z558 - z554;
    const Scalar z564 = z278 * z558 + z555;
    const Scalar z565 = n0_05 * z316;
    const Scalar z566 = n0_05 * z317;
    const Scalar z568 = z316 * z565 + z559;
    const Scalar z569 = z316 * z566 + z560;
    const Scalar z570 = z317 * z566 + z561;
    const Scalar z571 = z316 * z567 + z562;
    const Scalar z572 = z317 * z567 + z563;
    const Scalar z573 = z315 * z567 + z564;
    const Scalar z574 = n1 / z573;
    const Scalar z575 = z571 * z574;
    const Scalar z576 = z572 * z574;
    const Scalar z577 = z568 - z571 * z575;
    const Scalar z578 = z569 - z571 * z576;
    const Scalar z579 = z570 - z572 * z576;
    const Scalar z580 = n1 / z579;
    const Scalar z581 = z578 * z580;
    const Scalar z582 = z577 - z578 * z581;
    const Scalar z583 = n1 / z582;
    const Scalar z585 = z104 - z566 + z576 * z584;
    const Scalar z586 = z105 + z565 - z575 * z584 + z581 * z585;
    const Scalar z587 = z583 * z586;
    const Scalar z588 = z580 * z585 + z581 * z587;
    const Scalar z589 = z574 * z584 - z575 * z587 + z576 * z588;
    const Scalar z590 = n0_05 - z565 * z587 + z566 * z588 - z567 * z589;
    const Scalar z591 = z556 * z587 - z557 * z588 + z558 * z589;
    const Scalar z592 = z547 * z587 - z548 * z588 - z549 * z589;
    const Scalar z593 = z538 * z587 - z539 * z588 - z540 * z589;
    const Scalar z594 = z105 + z496 * z576;
    const Scalar z595 = z104 + z496 * z575 - z581 * z594;
    const Scalar z596 = z583 * z595;
    const Scalar z597 = z580 * z594 - z581 * z596;
    const Scalar z598 = z496 * z574 + z575 * z596 + z576 * z597;
    const Scalar z599 = z565 * z596 + z566 * z597 - z567 * z598;
    const Scalar z600 = z556 * z596 + z557 * z597 - z558 * z598;
    const Scalar z601 = z547 * z596 + z548 * z597 + z549 * z598;
    const Scalar z602 = z538 * z596 + z539 * z597 + z540 * z598;
    const Scalar z604 = z127 - z557 - z576 * z603;
    const Scalar z605 = z128 + z556 + z575 * z603 + z581 * z604;
    const Scalar z606 = z583 * z605;
    const Scalar z607 = z580 * z604 + z581 * z606;
    const Scalar z608 = z574 * z603 + z575 * z606 - z576 * z607;
    const Scalar z609 = z565 * z606 - z566 * z607 - z567 * z608;
    const Scalar z610 = n0_05 - z556 * z606 + z557 * z607 + z558 * z608;
    const Scalar z611 = z547 * z606 - z548 * z607 + z549 * z608;
    const Scalar z612 = z538 * z606 - z539 * z607 + z540 * z608;
    const Scalar z613 = z128 + z505 * z576;
    const Scalar z614 = z127 + z505 * z575 - z581 * z613;
    const Scalar z615 = z583 * z614;
    const Scalar z616 = z580 * z613 - z581 * z615;
    const Scalar z617 = z505 * z574 + z575 * z615 + z576 * z616;
    const Scalar z618 = z565 * z615 + z566 * z616 - z567 * z617;
    const Scalar z619 = z556 * z615 + z557 * z616 - z558 * z617;
    const Scalar z620 = z547 * z615 + z548 * z616 + z549 * z617;
    const Scalar z621 = z538 * z615 + z539 * z616 + z540 * z617;
    const Scalar z623 = z150 - z548 - z576 * z622;
    const Scalar z624 = z151 + z547 + z575 * z622 + z581 * z623;
    const Scalar z625 = z583 * z624;
    const Scalar z626 = z580 * z623 + z581 * z625;
    const Scalar z627 = z574 * z622 + z575 * z625 - z576 * z626;
    const Scalar z628 = z565 * z625 - z566 * z626 - z567 * z627;
    const Scalar z629 = z556 * z625 - z557 * z626 - z558 * z627;
    const Scalar z630 = n0_05 - z547 * z625 + z548 * z626 - z549 * z627;
    const Scalar z631 = z538 * z625 - z539 * z626 + z540 * z627;
    const Scalar z632 = z151 + z514 * z576;
    const Scalar z633 = z150 + z514 * z575 - z581 * z632;
    const Scalar z634 = z583 * z633;
    const Scalar z635 = z580 * z632 - z581 * z634;
    const Scalar z636 = z514 * z574 + z575 * z634 + z576 * z635;
    const Scalar z637 = z565 * z634 + z566 * z635 - z567 * z636;
    const Scalar z638 = z556 * z634 + z557 * z635 - z558 * z636;
    const Scalar z639 = z547 * z634 + z548 * z635 + z549 * z636;
    const Scalar z640 = z538 * z634 + z539 * z635 + z540 * z636;
    const Scalar z642 = z173 - z539 + z576 * z641;
    const Scalar z643 = z174 + z538 - z575 * z641 + z581 * z642;
    const Scalar z644 = z583 * z643;
    const Scalar z645 = z580 * z642 + z581 * z644;
    const Scalar z646 = z574 * z641 - z575 * z644 + z576 * z645;
    const Scalar z647 = z565 * z644 - z566 * z645 + z567 * z646;
    const Scalar z648 = z556 * z644 - z557 * z645 + z558 * z646;
    const Scalar z649 = z547 * z644 - z548 * z645 - z549 * z646;
    const Scalar z650 = n0_05 - z538 * z644 + z539 * z645 + z540 * z646;
    const Scalar z651 = z174 + z523 * z576;
    const Scalar z652 = z173 + z523 * z575 - z581 * z651;
    const Scalar z653 = z583 * z652;
    const Scalar z654 = z580 * z651 - z581 * z653;
    const Scalar z655 = z523 * z574 + z575 * z653 + z576 * z654;
    const Scalar z656 = z565 * z653 + z566 * z654 - z567 * z655;
    const Scalar z657 = z556 * z653 + z557 * z654 - z558 * z655;
    const Scalar z658 = z547 * z653 + z548 * z654 + z549 * z655;
    const Scalar z659 = z538 * z653 + z539 * z654 + z540 * z655;
    const Scalar z660 = z104 * z588 + z105 * z587 + z495 * z589 - z590;
    const Scalar z661 = z104 * z587 - z105 * z588 - z496 * z589;
    const Scalar z662 = n0_1 - z104 * z596 - z105 * z597 - z496 * z598;
    const Scalar z663 = z127 * z588 + z128 * z587 - z504 * z589 + z591;
    const Scalar z664 = z127 * z597 - z128 * z596 - z504 * z598 - z600;
    const Scalar z665 = z127 * z607 + z128 * z606 + z504 * z608 - z610;
    const Scalar z666 = z127 * z587 - z128 * z588 - z505 * z589;
    const Scalar z667 = z127 * z596 + z128 * z597 + z505 * z598;
    const Scalar z668 = z127 * z606 - z128 * z607 + z505 * z608;
    const Scalar z669 = n0_1 - z127 * z615 - z128 * z616 - z505 * z617;
    const Scalar z670 = z150 * z588 + z151 * z587 - z513 * z589 + z592;
    const Scalar z671 = z150 * z597 - z151 * z596 - z513 * z598 - z601;
    const Scalar z672 = z150 * z607 + z151 * z606 + z513 * z608 + z611;
    const Scalar z673 = z150 * z616 - z151 * z615 - z513 * z617 - z620;
    const Scalar z674 = z150 * z626 + z151 * z625 + z513 * z627 - z630;
    const Scalar z675 = z150 * z587 - z151 * z588 - z514 * z589;
    const Scalar z676 = z150 * z596 + z151 * z597 + z514 * z598;
    const Scalar z677 = z150 * z606 - z151 * z607 + z514 * z608;
    const Scalar z678 = z150 * z615 + z151 * z616 + z514 * z617;
    const Scalar z679 = z150 * z625 - z151 * z626 + z514 * z627;
    const Scalar z680 = n0_1 - z150 * z634 - z151 * z635 - z514 * z636;
    const Scalar z681 = z173 * z588 + z174 * z587 + z522 * z589 + z593;
    const Scalar z682 = z173 * z597 - z174 * z596 + z522 * z598 - z602;
    const Scalar z683 = z173 * z607 + z174 * z606 - z522 * z608 + z612;
    const Scalar z684 = z173 * z616 - z174 * z615 + z522 * z617 - z621;
    const Scalar z685 = z173 * z626 + z174 * z625 - z522 * z627 + z631;
    const Scalar z686 = z173 * z635 - z174 * z634 + z522 * z636 - z640;
    const Scalar z687 = z173 * z645 + z174 * z644 + z522 * z646 - z650;
    const Scalar z688 = z173 * z587 - z174 * z588 - z523 * z589;
    const Scalar z689 = z173 * z596 + z174 * z597 + z523 * z598;
    const Scalar z690 = z173 * z606 - z174 * z607 + z523 * z608;
    const Scalar z691 = z173 * z615 + z174 * z616 + z523 * z617;
    const Scalar z692 = z173 * z625 - z174 * z626 + z523 * z627;
    const Scalar z693 = z173 * z634 + z174 * z635 + z523 * z636;
    const Scalar z694 = z173 * z644 - z174 * z645 - z523 * z646;
    const Scalar z695 = n0_1 - z173 * z653 - z174 * z654 - z523 * z655;
    const Scalar z696 = n1 / z695;
    const Scalar z697 = z688 * z696;
    const Scalar z698 = z689 * z696;
    const Scalar z699 = z690 * z696;
    const Scalar z700 = z691 * z696;
    const Scalar z701 = z692 * z696;
    const Scalar z702 = z693 * z696;
    const Scalar z703 = z694 * z696;
    const Scalar z704 = z660 + z688 * z697;
    const Scalar z705 = z661 + z688 * z698;
    const Scalar z706 = z662 - z689 * z698;
    const Scalar z707 = z663 + z688 * z699;
    const Scalar z708 = z664 - z689 * z699;
    const Scalar z709 = z665 + z690 * z699;
    const Scalar z710 = z666 + z688 * z700;
    const Scalar z711 = z667 + z689 * z700;
    const Scalar z712 = z668 + z690 * z700;
    const Scalar z713 = z669 - z691 * z700;
    const Scalar z714 = z670 + z688 * z701;
    const Scalar z715 = z671 - z689 * z701;
    const Scalar z716 = z672 + z690 * z701;
    const Scalar z717 = z673 - z691 * z701;
    const Scalar z718 = z674 + z692 * z701;
    const Scalar z719 = z675 + z688 * z702;
    const Scalar z720 = z676 + z689 * z702;
    const Scalar z721 = z677 + z690 * z702;
    const Scalar z722 = z678 + z691 * z702;
    const Scalar z723 = z679 + z692 * z702;
    const Scalar z724 = z680 - z693 * z702;
    const Scalar z725 = z681 + z688 * z703;
    const Scalar z726 = z682 - z689 * z703;
    const Scalar z727 = z683 + z690 * z703;
    const Scalar z728 = z684 - z691 * z703;
    const Scalar z729 = z685 + z692 * z703;
    const Scalar z730 = z686 - z693 * z703;
    const Scalar z731 = z687 + z694 * z703;
    const Scalar z732 = n1 / z731;
    const Scalar z733 = z725 * z732;
    const Scalar z734 = z726 * z732;
    const Scalar z735 = z727 * z732;
    const Scalar z736 = z728 * z732;
    const Scalar z737 = z729 * z732;
    const Scalar z738 = z730 * z732;
    const Scalar z739 = z704 - z725 * z733;
    const Scalar z740 = z705 + z725 * z734;
    const Scalar z741 = z706 + z726 * z734;
    const Scalar z742 = z707 - z725 * z735;
    const Scalar z743 = z708 - z726 * z735;
    const Scalar z744 = z709 - z727 * z735;
    const Scalar z745 = z710 + z725 * z736;
    const Scalar z746 = z711 - z726 * z736;
    const Scalar z747 = z712 + z727 * z736;
    const Scalar z748 = z713 + z728 * z736;
    const Scalar z749 = z714 - z725 * z737;
    const Scalar z750 = z715 - z726 * z737;
    const Scalar z751 = z716 - z727 * z737;
    const Scalar z752 = z717 - z728 * z737;
    const Scalar z753 = z718 - z729 * z737;
    const Scalar z754 = z719 + z725 * z738;
    const Scalar z755 = z720 - z726 * z738;
    const Scalar z756 = z721 + z727 * z738;
    const Scalar z757 = z722 - z728 * z738;
    const Scalar z758 = z723 + z729 * z738;
    const Scalar z759 = z724 + z730 * z738;
    const Scalar z760 = n1 / z759;
    const Scalar z761 = z754 * z760;
    const Scalar z762 = z755 * z760;
    const Scalar z763 = z756 * z760;
    const Scalar z764 = z757 * z760;
    const Scalar z765 = z758 * z760;
    const Scalar z766 = z739 + z754 * z761;
    const Scalar z767 = z740 + z754 * z762;
    const Scalar z768 = z741 - z755 * z762;
    const Scalar z769 = z742 + z754 * z763;
    const Scalar z770 = z743 - z755 * z763;
    const Scalar z771 = z744 + z756 * z763;
    const Scalar z772 = z745 + z754 * z764;
    const Scalar z773 = z746 + z755 * z764;
    const Scalar z774 = z747 + z756 * z764;
    const Scalar z775 = z748 - z757 * z764;
    const Scalar z776 = z749 + z754 * z765;
    const Scalar z777 = z750 - z755 * z765;
    const Scalar z778 = z751 + z756 * z765;
    const Scalar z779 = z752 - z757 * z765;
    const Scalar z780 = z753 + z758 * z765;
    const Scalar z781 = n1 / z780;
    const Scalar z782 = z776 * z781;
    const Scalar z783 = z777 * z781;
    const Scalar z784 = z778 * z781;
    const Scalar z785 = z779 * z781;
    const Scalar z786 = z766 - z776 * z782;
    const Scalar z787 = z767 + z776 * z783;
    const Scalar z788 = z768 + z777 * z783;
    const Scalar z789 = z769 - z776 * z784;
    const Scalar z790 = z770 - z777 * z784;
    const Scalar z791 = z771 - z778 * z784;
    const Scalar z792 = z772 + z776 * z785;
    const Scalar z793 = z773 - z777 * z785;
    const Scalar z794 = z774 + z778 * z785;
    const Scalar z795 = z775 + z779 * z785;
    const Scalar z796 = n1 / z795;
    const Scalar z797 = z792 * z796;
    const Scalar z798 = z793 * z796;
    const Scalar z799 = z794 * z796;
    const Scalar z800 = z786 + z792 * z797;
    const Scalar z801 = z787 + z792 * z798;
    const Scalar z802 = z788 - z793 * z798;
    const Scalar z803 = z789 + z792 * z799;
    const Scalar z804 = z790 - z793 * z799;
    const Scalar z805 = z791 + z794 * z799;
    const Scalar z806 = n1 / z805;
    const Scalar z807 = z803 * z806;
    const Scalar z808 = z804 * z806;
    const Scalar z809 = z800 - z803 * z807;
    const Scalar z810 = z801 + z803 * z808;
    const Scalar z811 = z802 + z804 * z808;
    const Scalar z812 = n1 / z811;
    const Scalar z813 = z810 * z812;
    const Scalar z814 = z809 + z810 * z813;
    const Scalar z815 = n1 / z814;
    const Scalar z816 = z383 * z540 + z391 * z549 - z399 * z558 - z407 * z567 + z418;
    const Scalar z817 = z383 * z539 + z391 * z548 + z399 * z557 + z407 * z566 - z420 + z576 * z816;
    const Scalar z818 = z383 * z538 + z391 * z547 + z399 * z556 + z407 * z565 - z419 + z575 * z816 - z581 * z817;
    const Scalar z819 = z583 * z818;
    const Scalar z820 = z580 * z817 - z581 * z819;
    const Scalar z821 = z574 * z816 + z575 * z819 + z576 * z820;
    const Scalar z822 = n0_05 * z407 - z565 * z819 - z566 * z820 + z567 * z821;
    const Scalar z823 = n0_05 * z399 - z556 * z819 - z557 * z820 + z558 * z821;
    const Scalar z824 = n0_05 * z391 - z547 * z819 - z548 * z820 - z549 * z821;
    const Scalar z825 = n0_05 * z383 - z538 * z819 - z539 * z820 - z540 * z821;
    const Scalar z826 = z104 * z820 - z105 * z819 + z495 * z821 - z500 + z822;
    const Scalar z827 = z104 * z819 + z105 * z820 + z496 * z821 - z502;
    const Scalar z828 = z127 * z820 - z128 * z819 - z504 * z821 - z509 + z823;
    const Scalar z829 = z127 * z819 + z128 * z820 + z505 * z821 - z511;
    const Scalar z830 = z150 * z820 - z151 * z819 - z513 * z821 - z518 + z824;
    const Scalar z831 = z150 * z819 + z151 * z820 + z514 * z821 - z520;
    const Scalar z832 = z173 * z820 - z174 * z819 + z522 * z821 - z527 + z825;
    const Scalar z833 = z173 * z819 + z174 * z820 + z523 * z821 - z529;
    const Scalar z834 = z703 * z833 - z832;
    const Scalar z835 = z702 * z833 + z738 * z834 + z831;
    const Scalar z836 = z701 * z833 - z737 * z834 + z765 * z835 - z830;
    const Scalar z837 = z700 * z833 + z736 * z834 + z764 * z835 + z785 * z836 + z829;
    const Scalar z838 = z699 * z833 - z735 * z834 + z763 * z835 - z784 * z836 + z799 * z837 - z828;
    const Scalar z839 = z698 * z833 + z734 * z834 + z762 * z835 + z783 * z836 + z798 * z837 + z808 * z838 + z827;
    const Scalar z840 = z697 * z833 - z733 * z834 + z761 * z835 - z782 * z836 + z797 * z837 - z807 * z838 + z813 * z839
        - z826;
    const Scalar z841 = z815 * z840;
    const Scalar z842 = z812 * z839 - z813 * z841;
    const Scalar z843 = z806 * z838 - z807 * z841 - z808 * z842;
    const Scalar z844 = z796 * z837 - z797 * z841 + z798 * z842 - z799 * z843;
    const Scalar z845 = z781 * z836 - z782 * z841 - z783 * z842 - z784 * z843 - z785 * z844;
    const Scalar z846 = z760 * z835 - z761 * z841 + z762 * z842 - z763 * z843 + z764 * z844 - z765 * z845;
    const Scalar z847 = z732 * z834 - z733 * z841 - z734 * z842 - z735 * z843 - z736 * z844 - z737 * z845 - z738 * z846;
    const Scalar z848 = z696 * z833 - z697 * z841 + z698 * z842 - z699 * z843 + z700 * z844 - z701 * z845 + z702 * z846
        - z703 * z847;
    const Scalar z849 = z587 * z841 - z596 * z842 + z606 * z843 - z615 * z844 + z625 * z845 - z634 * z846 + z644 * z847
        - z653 * z848 - z819;
    const Scalar z850 = z588 * z841 + z597 * z842 + z607 * z843 + z616 * z844 + z626 * z845 + z635 * z846 + z645 * z847
        + z654 * z848 + z820;
    const Scalar z851 = z589 * z841 + z598 * z842 - z608 * z843 + z617 * z844 - z627 * z845 + z636 * z846 + z646 * z847
        + z655 * z848 + z821;
    const Scalar z852 = n1_over_3 * z842;
    const Scalar z853 = n1_over_3 * z844;
    const Scalar z854 = n1_over_3 * z846;
    const Scalar z855 = n1_over_3 * z848;
    const Scalar z856 = z590 * z841 + z599 * z842 - z609 * z843 + z618 * z844 - z628 * z845 + z637 * z846 - z647 * z847
        + z656 * z848 - z822;
    const Scalar z857 = z591 * z841 - z600 * z842 - z610 * z843 - z619 * z844 + z629 * z845 - z638 * z846 + z648 * z847
        - z657 * z848 + z823;
    const Scalar z858 = z592 * z841 - z601 * z842 + z611 * z843 - z620 * z844 - z630 * z845 - z639 * z846 + z649 * z847
        - z658 * z848 + z824;
    const Scalar z859 = z593 * z841 - z602 * z842 + z612 * z843 - z621 * z844 + z631 * z845 - z640 * z846 - z650 * z847
        - z659 * z848 + z825;
    accelerations.x = z849;
    accelerations.y = z850;
    accelerations.psi = z851;
    accelerations.phi_1 = -z852;
    accelerations.phi_2 = -z853;
    accelerations.phi_3 = -z854;
    accelerations.phi_4 = -z855;
    accelerations.s_1 = -z856;
    accelerations.s_2 = z857;
    accelerations.s_3 = z858;
    accelerations.s_4 = z859;
    multipliers.lambda_wheel_1_x = -z841;
    multipliers.lambda_wheel_1_y = -z842;
    multipliers.lambda_wheel_2_x = -z843;
    multipliers.lambda_wheel_2_y = -z844;
    multipliers.lambda_wheel_3_x = -z845;
    multipliers.lambda_wheel_3_y = -z846;
    multipliers.lambda_wheel_4_x = -z847;
    multipliers.lambda_wheel_4_y = -z848;
    if (!(traits::regular(-z582, n880) && traits::regular(-z579, n880) && traits::regular(-z573, z345)
        && traits::regular(-z814, -z660) && traits::regular(z811, z662) && traits::regular(-z805, -z665)
        && traits::regular(z795, z669) && traits::regular(-z780, -z674) && traits::regular(z759, z680)
        && traits::regular(-z731, -z687) && traits::regular(z695, z695))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.x - accelerations.x) + (accelerations.y - accelerations.y) + (accelerations.psi
        - accelerations.psi) + (accelerations.phi_1 - accelerations.phi_1) + (accelerations.phi_2 - accelerations.phi_2)
        + (accelerations.phi_3 - accelerations.phi_3) + (accelerations.phi_4 - accelerations.phi_4) + (accelerations.s_1
        - accelerations.s_1) + (accelerations.s_2 - accelerations.s_2) + (accelerations.s_3 - accelerations.s_3)
        + (accelerations.s_4 - accelerations.s_4) + (multipliers.lambda_wheel_1_x - multipliers.lambda_wheel_1_x)
        + (multipliers.lambda_wheel_1_y - multipliers.lambda_wheel_1_y) + (multipliers.lambda_wheel_2_x
        - multipliers.lambda_wheel_2_x) + (multipliers.lambda_wheel_2_y - multipliers.lambda_wheel_2_y)
        + (multipliers.lambda_wheel_3_x - multipliers.lambda_wheel_3_x) + (multipliers.lambda_wheel_3_y
        - multipliers.lambda_wheel_3_y) + (multipliers.lambda_wheel_4_x - multipliers.lambda_wheel_4_x)
        + (multipliers.lambda_wheel_4_y - multipliers.lambda_wheel_4_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z55 = v_x * c_psi + v_y * s_psi;
    const Scalar z56 = v_x * s_psi - v_y * c_psi;
    const Scalar z57 = v_psi - z55;
    const Scalar z58 = k0 * v_psi - z56;
    const Scalar z59 = s_alpha_1 * z58 - c_alpha_1 * z57;
    const Scalar z60 = s_alpha_1 * z57 + c_alpha_1 * z58;
    const Scalar z61 = v_psi * q_s_1 + z60;
    const Scalar z62 = v_s_1 + z59;  // velocity of axle_1, x
    const Scalar z63 = v_psi * s_phi_1;
    const Scalar z64 = v_psi * c_phi_1;
    const Scalar z65 = c_phi_1 * z61;
    const Scalar z66 = s_phi_1 * z61;
    const Scalar z67 = k0 * v_psi + z56;
    const Scalar z68 = s_alpha_2 * z67 + c_alpha_2 * z57;
    const Scalar z69 = s_alpha_2 * z57 - c_alpha_2 * z67;
    const Scalar z70 = v_psi * q_s_2 + z69;
    const Scalar z71 = v_s_2 - z68;  // velocity of axle_2, x
    const Scalar z72 = v_psi * s_phi_2;
    const Scalar z73 = v_psi * c_phi_2;
    const Scalar z74 = c_phi_2 * z70;
    const Scalar z75 = s_phi_2 * z70;
    const Scalar z76 = v_psi + z55;
    const Scalar z77 = s_alpha_3 * z67 - c_alpha_3 * z76;
    const Scalar z78 = s_alpha_3 * z76 + c_alpha_3 * z67;
    const Scalar z79 = v_psi * q_s_3 - z78;
    const Scalar z80 = v_s_3 - z77;  // velocity of axle_3, x
    const Scalar z81 = v_psi * s_phi_3;
    const Scalar z82 = v_psi * c_phi_3;
    const Scalar z83 = c_phi_3 * z79;
    const Scalar z84 = s_phi_3 * z79;
    const Scalar z85 = s_alpha_4 * z58 + c_alpha_4 * z76;
    const Scalar z86 = s_alpha_4 * z76 - c_alpha_4 * z58;
    const Scalar z87 = v_psi * q_s_4 - z86;
    const Scalar z88 = v_s_4 + z85;  // velocity of axle_4, x
    const Scalar z89 = v_psi * s_phi_4;
    const Scalar z90 = v_psi * c_phi_4;
    const Scalar z91 = c_phi_4 * z87;
    const Scalar z92 = s_phi_4 * z87;
    result.kinetic = n10 * (z62 * z62 + z65 * z65 + z66 * z66 + z71 * z71 + z74 * z74 + z75 * z75 + z80 * z80 + z83
        * z83 + z84 * z84 + z88 * z88 + z91 * z91 + z92 * z92) + n0_25 * (z63 * z63 + z64 * z64 + z72 * z72 + z73 * z73
        + z81 * z81 + z82 * z82 + z89 * z89 + z90 * z90) + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3
        * v_phi_3 + v_phi_4 * v_phi_4) + n400 * (z55 * z55 + z56 * z56) + n450 * v_psi * v_psi;
    result.force_function = n0;
    result.power = n0;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z494 = precomputed.z494;
    const Scalar z495 = precomputed.z495;
    const Scalar z503 = precomputed.z503;
    const Scalar z504 = precomputed.z504;
    const Scalar z512 = precomputed.z512;
    const Scalar z513 = precomputed.z513;
    const Scalar z521 = precomputed.z521;
    const Scalar z522 = precomputed.z522;
    const Scalar z103 = q_psi + p_alpha_1;
    const Scalar z126 = q_psi + p_alpha_2;
    const Scalar z149 = q_psi + p_alpha_3;
    const Scalar z172 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z103, z126, z149, z172};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z104 = sines_[0], z105 = cosines_[0];
    const Scalar z127 = sines_[1], z128 = cosines_[1];
    const Scalar z150 = sines_[2], z151 = cosines_[2];
    const Scalar z173 = sines_[3], z174 = cosines_[3];
    const Scalar z496 = q_s_1 + z494;
    const Scalar z497 = v_x * z105 + v_y * z104 + v_psi * z495 + v_s_1;
    const Scalar z498 = v_psi * z104;
    const Scalar z499 = v_psi * z105;
    const Scalar z500 = v_x * z498 - v_y * z499;
    const Scalar z501 = v_x * z104 - v_y * z105 - v_psi * z496 - n0_3 * v_phi_1;
    const Scalar z502 = v_x * z499 + v_y * z498 - v_psi * v_s_1;
    const Scalar z505 = q_s_2 + z503;
    const Scalar z506 = v_x * z128 + v_y * z127 - v_psi * z504 + v_s_2;
    const Scalar z507 = v_psi * z127;
    const Scalar z508 = v_psi * z128;
    const Scalar z509 = v_x * z507 - v_y * z508;
    const Scalar z510 = v_x * z127 - v_y * z128 - v_psi * z505 - n0_3 * v_phi_2;
    const Scalar z511 = v_x * z508 + v_y * z507 - v_psi * v_s_2;
    const Scalar z514 = q_s_3 - z512;
    const Scalar z515 = v_x * z151 + v_y * z150 - v_psi * z513 + v_s_3;
    const Scalar z516 = v_psi * z150;
    const Scalar z517 = v_psi * z151;
    const Scalar z518 = v_x * z516 - v_y * z517;
    const Scalar z519 = v_x * z150 - v_y * z151 - v_psi * z514 - n0_3 * v_phi_3;
    const Scalar z520 = v_x * z517 + v_y * z516 - v_psi * v_s_3;
    const Scalar z523 = q_s_4 - z521;
    const Scalar z524 = v_x * z174 + v_y * z173 + v_psi * z522 + v_s_4;
    const Scalar z525 = v_psi * z173;
    const Scalar z526 = v_psi * z174;
    const Scalar z527 = v_x * z525 - v_y * z526;
    const Scalar z528 = v_x * z173 - v_y * z174 - v_psi * z523 - n0_3 * v_phi_4;
    const Scalar z529 = v_x * z526 + v_y * z525 - v_psi * v_s_4;
    result.value[0] = n0;
    result.rate[0] = z497;
    result.gamma[0] = -z500;
    result.value[1] = n0;
    result.rate[1] = -z501;
    result.gamma[1] = -z502;
    result.value[2] = n0;
    result.rate[2] = z506;
    result.gamma[2] = -z509;
    result.value[3] = n0;
    result.rate[3] = -z510;
    result.gamma[3] = -z511;
    result.value[4] = n0;
    result.rate[4] = z515;
    result.gamma[4] = -z518;
    result.value[5] = n0;
    result.rate[5] = -z519;
    result.gamma[5] = -z520;
    result.value[6] = n0;
    result.rate[6] = z524;
    result.gamma[6] = -z527;
    result.value[7] = n0;
    result.rate[7] = -z528;
    result.gamma[7] = -z529;
    result.jacobian[0] = z105;
    result.jacobian[1] = -z104;
    result.jacobian[2] = z128;
    result.jacobian[3] = -z127;
    result.jacobian[4] = z151;
    result.jacobian[5] = -z150;
    result.jacobian[6] = z174;
    result.jacobian[7] = -z173;
    result.jacobian[8] = z104;
    result.jacobian[9] = z105;
    result.jacobian[10] = z127;
    result.jacobian[11] = z128;
    result.jacobian[12] = z150;
    result.jacobian[13] = z151;
    result.jacobian[14] = z173;
    result.jacobian[15] = z174;
    result.jacobian[16] = z495;
    result.jacobian[17] = z496;
    result.jacobian[18] = -z504;
    result.jacobian[19] = z505;
    result.jacobian[20] = -z513;
    result.jacobian[21] = z514;
    result.jacobian[22] = z522;
    result.jacobian[23] = z523;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0_3;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = n0;
    result.jacobian[35] = n0_3;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = n0_3;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0_3;
    result.jacobian[56] = n1;
    result.jacobian[57] = n0;
    result.jacobian[58] = n0;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n1;
    result.jacobian[67] = n0;
    result.jacobian[68] = n0;
    result.jacobian[69] = n0;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n1;
    result.jacobian[77] = n0;
    result.jacobian[78] = n0;
    result.jacobian[79] = n0;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = n0;
    result.jacobian[85] = n0;
    result.jacobian[86] = n1;
    result.jacobian[87] = n0;
  }
};

}  // namespace four_wheel_vehicle_all_wheels
