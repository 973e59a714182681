// SPDX-License-Identifier: MIT
// four_wheel_vehicle: Four-wheel vehicle whose wheels roll without slipping
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                8               14          0             0                  4       0     30       -
//   kinematics               76              134          0             0                  9       0    228     236
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                4          0             0                  0       0      4       4
//   inverse_dynamics         37               41          0             0                  4       0     86     334
//   forward_dynamics        146              211          6             0                  4       0    371     594
//   energy                   45               78          0             0                  5       0    133     165
//   constraints              32               52          0             0                  4       0     92     116
//
// Not computed because this mechanism does not need it:
//   kinematics: of 198 results 91 vanish identically, 10 repeat another up to sign
//   mass_matrix: of 49 results 42 vanish identically
//   bias: of 7 results 3 vanish identically
//   forward_dynamics: of 15 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 80 results 36 vanish identically, 8 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: wheel_3_x, wheel_4_x.
//   Indeterminate, as they are shared with those in a way that no motion tells: lambda_wheel_1_x, lambda_wheel_2_x.
//
// To write this file again:
//   four_wheel_vehicle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output four_wheel_vehicle.hpp
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

// Sine and cosine in one, of one angle or of several at once, with an error of at most 1 ulp. With rounding to nearest:
//  * the angle loses its quadrant, x = n pi/2 + r, by parts of pi/2 so short that n times a part is exact. Whether a
//    product and a sum are fused does not matter, here or elsewhere; letting the compiler reassociate sums would;
//  * two polynomials of least greatest error give the sine and the cosine of r, |r| <= pi/4;
//  * angles beyond `bound` are rare: they are reduced exactly, in integers, by a function that is not inlined.
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

  /// Of n pi/2 + high - rest, rest being about an ulp of high at most.
  TORSOR_DEVICE TORSOR_INLINED static void of_reduced(const Scalar& n, const Scalar& high, const Scalar& rest,
                                                      Scalar& sine, Scalar& cosine) noexcept {
    const Scalar one = number(1.0, 1.0f), two = number(2.0, 2.0f), half = number(0.5, 0.5f);
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
    const Scalar s = high + (high * (tiny + z * S) - rest * w);
    const Scalar c = w + (((one - w) - half_z) + (z2 * C + high * rest));
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
    of_reduced(n, high, rest, sine, cosine);
  }
};

/// Of any x, beyond the bound too, where n pi/2 is subtracted exactly: x/(2 pi) modulo 1 in integers, with as many
/// digits of 1/(2 pi) as |x - n pi/2| >= 2^-62 needs. Infinite: not a number.
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
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(x), &exponent);
  const Word integer = static_cast<Word>(std::ldexp(mantissa, 53));  // |x| = integer 2^(exponent - 53)
  const int position = exponent - 53 + 64;                           // at least 64 - 53 + 21
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
  double s = 0;
  SineCosine<double, false>::of_reduced(static_cast<double>(quarter), negative ? -high : high, negative ? low : -low, s,
                                        cosine);
  sine = x < 0 ? -s : s;
}
TORSOR_OUTLINED inline void sincos_far(float x, float& sine, float& cosine) noexcept {
  double s = 0, c = 0;
  if (std::abs(x) <= static_cast<float>(SineCosine<double, false>::bound))
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
  if (std::abs(angle) > static_cast<Scalar>(Core::bound))
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
    if (sum <= bound) return;
    for (int i = 0; i < N; ++i) {
      if (std::abs(angles[i]) > bound) sincos_far(angles[i], sines[i], cosines[i]);
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

namespace four_wheel_vehicle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle";
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 2;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 8;
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 2;
  static constexpr int redundant_multipliers[] = {4, 6};

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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4};
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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4};
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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4};
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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C3;  ///< motor [N m]
    Scalar C4;  ///< motor [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C3, &Inputs::C4};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< indeterminate, of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< indeterminate, of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< indeterminate, of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< indeterminate, of the constraint wheel_4_x [N]
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
    Scalar z294;
    Scalar z295;
    Scalar z302;
    Scalar z303;
    Scalar z310;
    Scalar z311;
    Scalar z318;
    Scalar z319;
    Scalar z342;
    Scalar z343;
    Scalar z346;
    Scalar z347;
    Scalar z350;
    Scalar z353;
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
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k1 = traits::constant(0.0009757317265719934, 0.0009757317f, "217/269734;0;40/404601;0");
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
    const Scalar z294 = s_alpha_1 + k0 * c_alpha_1;
    const Scalar z295 = k0 * s_alpha_1 - c_alpha_1;
    const Scalar z302 = s_alpha_2 - k0 * c_alpha_2;
    const Scalar z303 = k0 * s_alpha_2 + c_alpha_2;
    const Scalar z310 = s_alpha_3 + k0 * c_alpha_3;
    const Scalar z311 = k0 * s_alpha_3 - c_alpha_3;
    const Scalar z318 = s_alpha_4 - k0 * c_alpha_4;
    const Scalar z319 = k0 * s_alpha_4 + c_alpha_4;
    const Scalar z342 = k1 * z295;
    const Scalar z343 = k1 * z294;
    const Scalar z346 = k1 * z303;
    const Scalar z347 = k1 * z302;
    const Scalar z350 = k1 * z310;
    const Scalar z353 = k1 * z318;
    precomputed.s_alpha_1 = s_alpha_1;
    precomputed.c_alpha_1 = c_alpha_1;
    precomputed.s_alpha_2 = s_alpha_2;
    precomputed.c_alpha_2 = c_alpha_2;
    precomputed.s_alpha_3 = s_alpha_3;
    precomputed.c_alpha_3 = c_alpha_3;
    precomputed.s_alpha_4 = s_alpha_4;
    precomputed.c_alpha_4 = c_alpha_4;
    precomputed.z294 = z294;
    precomputed.z295 = z295;
    precomputed.z302 = z302;
    precomputed.z303 = z303;
    precomputed.z310 = z310;
    precomputed.z311 = z311;
    precomputed.z318 = z318;
    precomputed.z319 = z319;
    precomputed.z342 = z342;
    precomputed.z343 = z343;
    precomputed.z346 = z346;
    precomputed.z347 = z347;
    precomputed.z350 = z350;
    precomputed.z353 = z353;
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
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
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
    std::array<Scalar, 21> P1_jacobian;  ///< partial velocities of P1 (3 x 7)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 21> P2_jacobian;  ///< partial velocities of P2 (3 x 7)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 21> P3_jacobian;  ///< partial velocities of P3 (3 x 7)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 21> P4_jacobian;  ///< partial velocities of P4 (3 x 7)
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
    std::array<Scalar, 56> jacobian;  ///< A, stored column by column (8 x 7)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
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
    const Scalar z79 = q_psi + p_alpha_1;
    const Scalar z98 = q_psi + p_alpha_2;
    const Scalar z115 = q_psi + p_alpha_3;
    const Scalar z132 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4, z79, z98, z115, z132};
    Scalar sines_[9], cosines_[9];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z80 = sines_[5], z81 = cosines_[5];
    const Scalar z99 = sines_[6], z100 = cosines_[6];
    const Scalar z116 = sines_[7], z117 = cosines_[7];
    const Scalar z133 = sines_[8], z134 = cosines_[8];
    const Scalar z43 = v_x * c_psi + v_y * s_psi;
    const Scalar z44 = v_x * s_psi - v_y * c_psi;
    const Scalar z45 = v_psi - z43;
    const Scalar z46 = k0 * v_psi - z44;
    const Scalar z47 = s_alpha_1 * z46 - c_alpha_1 * z45;
    const Scalar z48 = s_alpha_1 * z45 + c_alpha_1 * z46;
    const Scalar z49 = v_psi * s_phi_1;
    const Scalar z50 = v_psi * c_phi_1;
    const Scalar z51 = c_phi_1 * z48;
    const Scalar z52 = s_phi_1 * z48;
    const Scalar z53 = k0 * v_psi + z44;
    const Scalar z54 = s_alpha_2 * z53 + c_alpha_2 * z45;
    const Scalar z55 = s_alpha_2 * z45 - c_alpha_2 * z53;
    const Scalar z56 = v_psi * s_phi_2;
    const Scalar z57 = v_psi * c_phi_2;
    const Scalar z58 = c_phi_2 * z55;
    const Scalar z59 = s_phi_2 * z55;
    const Scalar z60 = v_psi + z43;
    const Scalar z61 = s_alpha_3 * z53 - c_alpha_3 * z60;
    const Scalar z62 = s_alpha_3 * z60 + c_alpha_3 * z53;
    const Scalar z63 = v_psi * s_phi_3;
    const Scalar z64 = v_psi * c_phi_3;
    const Scalar z65 = c_phi_3 * z62;
    const Scalar z66 = s_phi_3 * z62;
    const Scalar z67 = s_alpha_4 * z46 + c_alpha_4 * z60;
    const Scalar z68 = s_alpha_4 * z60 - c_alpha_4 * z46;
    const Scalar z69 = v_psi * s_phi_4;
    const Scalar z70 = v_psi * c_phi_4;
    const Scalar z71 = c_phi_4 * z68;
    const Scalar z72 = s_phi_4 * z68;
    const Scalar z73 = s_psi * z44 + c_psi * z43;
    const Scalar z74 = s_psi * z43 - c_psi * z44;
    const Scalar z75 = s_psi - k0 * c_psi;
    const Scalar z76 = k0 * s_psi + c_psi;
    const Scalar z77 = q_y + z76;
    const Scalar z78 = q_x - z75;
    const Scalar z82 = c_phi_1 * z80;
    const Scalar z83 = c_phi_1 * z81;
    const Scalar z84 = s_phi_1 * z80;
    const Scalar z85 = s_phi_1 * z81;
    const Scalar z86 = s_phi_1 * z52 + c_phi_1 * z51;
    const Scalar z88 = z47 * z81 - z80 * z86;
    const Scalar z89 = z47 * z80 + z81 * z86;
    const Scalar z90 = s_phi_1 * z50 - c_phi_1 * z49;
    const Scalar z91 = s_phi_1 * z49 + c_phi_1 * z50;
    const Scalar z92 = v_phi_1 * z81 + z80 * z90;
    const Scalar z93 = v_phi_1 * z80 - z81 * z90;
    const Scalar z94 = s_psi + k0 * c_psi;
    const Scalar z95 = k0 * s_psi - c_psi;
    const Scalar z96 = q_y - z95;
    const Scalar z97 = q_x - z94;
    const Scalar z101 = c_phi_2 * z99;
    const Scalar z102 = c_phi_2 * z100;
    const Scalar z103 = s_phi_2 * z99;
    const Scalar z104 = s_phi_2 * z100;
    const Scalar z105 = s_phi_2 * z59 + c_phi_2 * z58;
    const Scalar z107 = z54 * z100 + z99 * z105;
    const Scalar z108 = z54 * z99 - z100 * z105;
    const Scalar z109 = s_phi_2 * z57 - c_phi_2 * z56;
    const Scalar z110 = s_phi_2 * z56 + c_phi_2 * z57;
    const Scalar z111 = v_phi_2 * z100 + z99 * z109;
    const Scalar z112 = v_phi_2 * z99 - z100 * z109;
    const Scalar z113 = q_y - z76;
    const Scalar z114 = q_x + z75;
    const Scalar z118 = c_phi_3 * z116;
    const Scalar z119 = c_phi_3 * z117;
    const Scalar z120 = s_phi_3 * z116;
    const Scalar z121 = s_phi_3 * z117;
    const Scalar z122 = s_phi_3 * z66 + c_phi_3 * z65;
    const Scalar z124 = z61 * z117 - z116 * z122;
    const Scalar z125 = z61 * z116 + z117 * z122;
    const Scalar z126 = s_phi_3 * z64 - c_phi_3 * z63;
    const Scalar z127 = s_phi_3 * z63 + c_phi_3 * z64;
    const Scalar z128 = v_phi_3 * z117 + z116 * z126;
    const Scalar z129 = v_phi_3 * z116 - z117 * z126;
    const Scalar z130 = q_y + z95;
    const Scalar z131 = q_x + z94;
    const Scalar z135 = c_phi_4 * z133;
    const Scalar z136 = c_phi_4 * z134;
    const Scalar z137 = s_phi_4 * z133;
    const Scalar z138 = s_phi_4 * z134;
    const Scalar z139 = s_phi_4 * z72 + c_phi_4 * z71;
    const Scalar z141 = z67 * z134 + z133 * z139;
    const Scalar z142 = z67 * z133 - z134 * z139;
    const Scalar z143 = s_phi_4 * z70 - c_phi_4 * z69;
    const Scalar z144 = s_phi_4 * z69 + c_phi_4 * z70;
    const Scalar z145 = v_phi_4 * z134 + z133 * z143;
    const Scalar z146 = v_phi_4 * z133 - z134 * z143;
    const Scalar z147 = z47 * z81 - z48 * z80;
    const Scalar z148 = z47 * z80 + z48 * z81;
    const Scalar z149 = q_x - z78;
    const Scalar z150 = q_y - z77;
    const Scalar z151 = z54 * z100 + z55 * z99;
    const Scalar z152 = z54 * z99 - z55 * z100;
    const Scalar z153 = q_x - z97;
    const Scalar z154 = q_y - z96;
    const Scalar z155 = z61 * z117 - z62 * z116;
    const Scalar z156 = z61 * z116 + z62 * z117;
    const Scalar z157 = q_x - z114;
    const Scalar z158 = q_y - z113;
    const Scalar z159 = z67 * z134 + z68 * z133;
    const Scalar z160 = z67 * z133 - z68 * z134;
    const Scalar z161 = q_x - z131;
    const Scalar z162 = q_y - z130;
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
    result.chassis_velocity[0] = z73;
    result.chassis_velocity[1] = z74;
    result.chassis_velocity[2] = n0;
    result.chassis_angular_velocity[0] = n0;
    result.chassis_angular_velocity[1] = n0;
    result.chassis_angular_velocity[2] = v_psi;
    result.wheel_1_position[0] = z78;
    result.wheel_1_position[1] = z77;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z81;
    result.wheel_1_rotation[1] = z80;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z82;
    result.wheel_1_rotation[4] = z83;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z84;
    result.wheel_1_rotation[7] = -z85;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z88;
    result.wheel_1_velocity[1] = z89;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z92;
    result.wheel_1_angular_velocity[1] = z93;
    result.wheel_1_angular_velocity[2] = z91;
    result.wheel_2_position[0] = z97;
    result.wheel_2_position[1] = z96;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z100;
    result.wheel_2_rotation[1] = z99;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z101;
    result.wheel_2_rotation[4] = z102;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z103;
    result.wheel_2_rotation[7] = -z104;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = -z107;
    result.wheel_2_velocity[1] = -z108;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z111;
    result.wheel_2_angular_velocity[1] = z112;
    result.wheel_2_angular_velocity[2] = z110;
    result.wheel_3_position[0] = z114;
    result.wheel_3_position[1] = z113;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = z117;
    result.wheel_3_rotation[1] = z116;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z118;
    result.wheel_3_rotation[4] = z119;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z120;
    result.wheel_3_rotation[7] = -z121;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = -z124;
    result.wheel_3_velocity[1] = -z125;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z128;
    result.wheel_3_angular_velocity[1] = z129;
    result.wheel_3_angular_velocity[2] = z127;
    result.wheel_4_position[0] = z131;
    result.wheel_4_position[1] = z130;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = z134;
    result.wheel_4_rotation[1] = z133;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z135;
    result.wheel_4_rotation[4] = z136;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z137;
    result.wheel_4_rotation[7] = -z138;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z141;
    result.wheel_4_velocity[1] = z142;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z145;
    result.wheel_4_angular_velocity[1] = z146;
    result.wheel_4_angular_velocity[2] = z144;
    result.P1_position[0] = z78;
    result.P1_position[1] = z77;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z147;
    result.P1_velocity[1] = z148;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = z150;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z149;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P2_position[0] = z97;
    result.P2_position[1] = z96;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = -z151;
    result.P2_velocity[1] = -z152;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z154;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z153;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P3_position[0] = z114;
    result.P3_position[1] = z113;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = -z155;
    result.P3_velocity[1] = -z156;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z158;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = -z157;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P4_position[0] = z131;
    result.P4_position[1] = z130;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z159;
    result.P4_velocity[1] = z160;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = z162;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = -z161;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 49>& mass) noexcept {
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k2 = traits::constant(1024.8718707889795, 1024.8718f, "1302;0;-160;0");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n880;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k2;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_9;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0_9;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0_9;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    forces.x = n0;
    forces.y = n0;
    forces.psi = n0;
    forces.phi_1 = z217;
    forces.phi_2 = z218;
    forces.phi_3 = z219;
    forces.phi_4 = z220;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(1022.8718707889797, 1022.8719f, "1300;0;-160;0");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar z294 = precomputed.z294;
    const Scalar z295 = precomputed.z295;
    const Scalar z302 = precomputed.z302;
    const Scalar z303 = precomputed.z303;
    const Scalar z310 = precomputed.z310;
    const Scalar z311 = precomputed.z311;
    const Scalar z318 = precomputed.z318;
    const Scalar z319 = precomputed.z319;
    const Scalar z79 = q_psi + p_alpha_1;
    const Scalar z98 = q_psi + p_alpha_2;
    const Scalar z115 = q_psi + p_alpha_3;
    const Scalar z132 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z79, z98, z115, z132};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z80 = sines_[0], z81 = cosines_[0];
    const Scalar z99 = sines_[1], z100 = cosines_[1];
    const Scalar z116 = sines_[2], z117 = cosines_[2];
    const Scalar z133 = sines_[3], z134 = cosines_[3];
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    const Scalar z269 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z270 = n0_5 * a_psi;  // moment on steered_4, z
    const Scalar z273 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z276 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z279 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z284 = k3 * a_psi + n4 * z270;  // moment on S, z
    const Scalar z287 = n880 * a_x;  // force on S.y, x
    const Scalar z288 = n880 * a_y;  // force on S.y, y
    const Scalar z290 = z217 + z279;
    const Scalar z291 = z218 + z276;
    const Scalar z292 = z219 + z273;
    const Scalar z293 = z220 + z269;
    forces.x = z80 * l_lambda_wheel_1_y - z81 * l_lambda_wheel_1_x + z99 * l_lambda_wheel_2_y - z100
        * l_lambda_wheel_2_x + z116 * l_lambda_wheel_3_y - z117 * l_lambda_wheel_3_x + z133 * l_lambda_wheel_4_y - z134
        * l_lambda_wheel_4_x + z287;
    forces.y = -z80 * l_lambda_wheel_1_x - z81 * l_lambda_wheel_1_y - z99 * l_lambda_wheel_2_x - z100
        * l_lambda_wheel_2_y - z116 * l_lambda_wheel_3_x - z117 * l_lambda_wheel_3_y - z133 * l_lambda_wheel_4_x - z134
        * l_lambda_wheel_4_y + z288;
    forces.psi = z284 - z294 * l_lambda_wheel_1_y - z295 * l_lambda_wheel_1_x - z302 * l_lambda_wheel_2_y + z303
        * l_lambda_wheel_2_x + z310 * l_lambda_wheel_3_y + z311 * l_lambda_wheel_3_x + z318 * l_lambda_wheel_4_y - z319
        * l_lambda_wheel_4_x;
    forces.phi_1 = z290 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z291 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z292 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z293 - n0_3 * l_lambda_wheel_4_y;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n10_over_9 = traits::constant(1.1111111111111112, 1.1111112f, "10/9");
    const Scalar n1_over_880 = traits::constant(0.0011363636363636363, 0.0011363636f, "1/880");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
    const Scalar z294 = precomputed.z294;
    const Scalar z295 = precomputed.z295;
    const Scalar z302 = precomputed.z302;
    const Scalar z303 = precomputed.z303;
    const Scalar z310 = precomputed.z310;
    const Scalar z318 = precomputed.z318;
    const Scalar z342 = precomputed.z342;
    const Scalar z343 = precomputed.z343;
    const Scalar z346 = precomputed.z346;
    const Scalar z347 = precomputed.z347;
    const Scalar z350 = precomputed.z350;
    const Scalar z353 = precomputed.z353;
    const Scalar z79 = q_psi + p_alpha_1;
    const Scalar z98 = q_psi + p_alpha_2;
    const Scalar z115 = q_psi + p_alpha_3;
    const Scalar z132 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z79, z98, z115, z132};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z80 = sines_[0], z81 = cosines_[0];
    const Scalar z99 = sines_[1], z100 = cosines_[1];
    const Scalar z116 = sines_[2], z117 = cosines_[2];
    const Scalar z133 = sines_[3], z134 = cosines_[3];
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    const Scalar z297 = v_psi * z80;
    const Scalar z298 = v_psi * z81;
    const Scalar z299 = v_x * z297 - v_y * z298;
    const Scalar z301 = v_x * z298 + v_y * z297;
    const Scalar z305 = v_psi * z99;
    const Scalar z306 = v_psi * z100;
    const Scalar z307 = v_x * z305 - v_y * z306;
    const Scalar z309 = v_x * z306 + v_y * z305;
    const Scalar z313 = v_psi * z116;
    const Scalar z314 = v_psi * z117;
    const Scalar z317 = v_x * z314 + v_y * z313;
    const Scalar z321 = v_psi * z133;
    const Scalar z322 = v_psi * z134;
    const Scalar z325 = v_x * z322 + v_y * z321;
    const Scalar z334 = u_C3 - z219;
    const Scalar z335 = u_C4 - z220;
    const Scalar z336 = n10_over_9 * z217;
    const Scalar z337 = n10_over_9 * z218;
    const Scalar z338 = n10_over_9 * z334;
    const Scalar z339 = n10_over_9 * z335;
    const Scalar z340 = n1_over_880 * z81;
    const Scalar z341 = n1_over_880 * z80;
    const Scalar z344 = n1_over_880 * z100;
    const Scalar z345 = n1_over_880 * z99;
    const Scalar z348 = n1_over_880 * z116;
    const Scalar z349 = n1_over_880 * z117;
    const Scalar z351 = n1_over_880 * z133;
    const Scalar z352 = n1_over_880 * z134;
    const Scalar z354 = z80 * z341 + z81 * z340 + z295 * z342;
    const Scalar z355 = z80 * z340 - z81 * z341 - z294 * z342;
    const Scalar z356 = n0_1 + z80 * z341 + z81 * z340 + z294 * z343;
    const Scalar z357 = z301 + n0_3 * z336;
    const Scalar z358 = z99 * z341 + z100 * z340 - z303 * z342;
    const Scalar z359 = z99 * z340 - z100 * z341 - z303 * z343;
    const Scalar z360 = z99 * z345 + z100 * z344 + z303 * z346;
    const Scalar z361 = z99 * z340 - z100 * z341 - z302 * z342;
    const Scalar z362 = z99 * z341 + z100 * z340 + z302 * z343;
    const Scalar z363 = z99 * z344 - z100 * z345 + z302 * z346;
    const Scalar z364 = n0_1 + z99 * z345 + z100 * z344 + z302 * z347;
    const Scalar z365 = z309 + n0_3 * z337;
    const Scalar z366 = z116 * z340 - z117 * z341 + z310 * z342;
    const Scalar z367 = z116 * z341 + z117 * z340 - z310 * z343;
    const Scalar z368 = z116 * z344 - z117 * z345 - z310 * z346;
    const Scalar z369 = z116 * z345 + z117 * z344 - z310 * z347;
    const Scalar z370 = n0_1 + z116 * z348 + z117 * z349 + z310 * z350;
    const Scalar z371 = z317 - n0_3 * z338;
    const Scalar z372 = z133 * z340 - z134 * z341 + z318 * z342;
    const Scalar z373 = z133 * z341 + z134 * z340 - z318 * z343;
    const Scalar z374 = z133 * z344 - z134 * z345 - z318 * z346;
    const Scalar z375 = z133 * z345 + z134 * z344 - z318 * z347;
    const Scalar z376 = z133 * z348 + z134 * z349 + z318 * z350;
    const Scalar z377 = n0_1 + z133 * z351 + z134 * z352 + z318 * z353;
    const Scalar z378 = z325 - n0_3 * z339;
    const Scalar z379 = n1 / z377;
    const Scalar z380 = z372 * z379;
    const Scalar z381 = z373 * z379;
    const Scalar z382 = z374 * z379;
    const Scalar z383 = z375 * z379;
    const Scalar z384 = z376 * z379;
    const Scalar z385 = z354 - z372 * z380;
    const Scalar z386 = z355 - z372 * z381;
    const Scalar z387 = z356 - z373 * z381;
    const Scalar z388 = z358 - z372 * z382;
    const Scalar z389 = z359 + z373 * z382;
    const Scalar z390 = z360 - z374 * z382;
    const Scalar z391 = z361 - z372 * z383;
    const Scalar z392 = z362 - z373 * z383;
    const Scalar z393 = z363 - z374 * z383;
    const Scalar z394 = z364 - z375 * z383;
    const Scalar z395 = z366 - z372 * z384;
    const Scalar z396 = z367 - z373 * z384;
    const Scalar z397 = z368 - z374 * z384;
    const Scalar z398 = z369 - z375 * z384;
    const Scalar z399 = z370 - z376 * z384;
    const Scalar z400 = n1 / z399;
    const Scalar z401 = z395 * z400;
    const Scalar z402 = z396 * z400;
    const Scalar z403 = z397 * z400;
    const Scalar z404 = z398 * z400;
    const Scalar z405 = z385 - z395 * z401;
    const Scalar z406 = z386 - z395 * z402;
    const Scalar z407 = z387 - z396 * z402;
    const Scalar z408 = z388 - z395 * z403;
    const Scalar z409 = z389 + z396 * z403;
    const Scalar z410 = z390 - z397 * z403;
    const Scalar z411 = z391 - z395 * z404;
    const Scalar z412 = z392 - z396 * z404;
    const Scalar z413 = z393 - z397 * z404;
    const Scalar z414 = z394 - z398 * z404;
    const Scalar z415 = n1 / z414;
    const Scalar z416 = z411 * z415;
    const Scalar z417 = z412 * z415;
    const Scalar z418 = z413 * z415;
    const Scalar z419 = z405 - z411 * z416;
    const Scalar z420 = z406 - z411 * z417;
    const Scalar z421 = z407 - z412 * z417;
    const Scalar z422 = z408 - z411 * z418;
    const Scalar z423 = z409 + z412 * z418;
    const Scalar z424 = z410 - z413 * z418;
    const Scalar z425 = n1 / z424;
    const Scalar z426 = z422 * z425;
    const Scalar z427 = z423 * z425;
    const Scalar z428 = z419 - z422 * z426;
    const Scalar z429 = z420 + z422 * z427;
    const Scalar z430 = z421 - z423 * z427;
    const Scalar z431 = n1 / z430;
    const Scalar z432 = z429 * z431;
    const Scalar z433 = z428 - z429 * z432;
    const Scalar z434 = n1 / z433;
    const Scalar z435 = z371 - z378 * z384;
    const Scalar z436 = z365 - z378 * z383 - z404 * z435;
    const Scalar z437 = z307 + z378 * z382 + z403 * z435 + z418 * z436;
    const Scalar z438 = z357 - z378 * z381 - z402 * z435 - z417 * z436 - z427 * z437;
    const Scalar z439 = z299 + z378 * z380 + z401 * z435 + z416 * z436 - z426 * z437 + z432 * z438;
    const Scalar z440 = z434 * z439;
    const Scalar z441 = z431 * z438 + z432 * z440;
    const Scalar z442 = z425 * z437 - z426 * z440 - z427 * z441;
    const Scalar z443 = z415 * z436 + z416 * z440 - z417 * z441 + z418 * z442;
    const Scalar z444 = z400 * z435 + z401 * z440 - z402 * z441 + z403 * z442 - z404 * z443;
    const Scalar z445 = z378 * z379 + z380 * z440 - z381 * z441 + z382 * z442 - z383 * z443 - z384 * z444;
    const Scalar z446 = z340 * z440 - z341 * z441 + z344 * z442 - z345 * z443 - z348 * z444 - z351 * z445;
    const Scalar z447 = z340 * z441 + z341 * z440 + z344 * z443 + z345 * z442 + z349 * z444 + z352 * z445;
    const Scalar z448 = z342 * z440 + z343 * z441 - z346 * z442 + z347 * z443 - z350 * z444 - z353 * z445;
    const Scalar z449 = z336 - n1_over_3 * z441;
    const Scalar z450 = z337 - n1_over_3 * z443;
    const Scalar z451 = z338 + n1_over_3 * z444;
    const Scalar z452 = z339 + n1_over_3 * z445;
    accelerations.x = z446;
    accelerations.y = z447;
    accelerations.psi = z448;
    accelerations.phi_1 = -z449;
    accelerations.phi_2 = -z450;
    accelerations.phi_3 = z451;
    accelerations.phi_4 = z452;
    multipliers.lambda_wheel_1_x = z440;
    multipliers.lambda_wheel_1_y = z441;
    multipliers.lambda_wheel_2_x = z442;
    multipliers.lambda_wheel_2_y = z443;
    multipliers.lambda_wheel_3_x = n0;
    multipliers.lambda_wheel_3_y = z444;
    multipliers.lambda_wheel_4_x = n0;
    multipliers.lambda_wheel_4_y = z445;
    if (!(traits::regular(z433, z354) && traits::regular(z430, z356) && traits::regular(z424, z360)
        && traits::regular(z414, z364) && traits::regular(z399, z370) && traits::regular(z377,
        z377))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.x - accelerations.x) + (accelerations.y - accelerations.y) + (accelerations.psi
        - accelerations.psi) + (accelerations.phi_1 - accelerations.phi_1) + (accelerations.phi_2 - accelerations.phi_2)
        + (accelerations.phi_3 - accelerations.phi_3) + (accelerations.phi_4 - accelerations.phi_4)
        + (multipliers.lambda_wheel_1_x - multipliers.lambda_wheel_1_x) + (multipliers.lambda_wheel_1_y
        - multipliers.lambda_wheel_1_y) + (multipliers.lambda_wheel_2_x - multipliers.lambda_wheel_2_x)
        + (multipliers.lambda_wheel_2_y - multipliers.lambda_wheel_2_y) + (multipliers.lambda_wheel_3_y
        - multipliers.lambda_wheel_3_y) + (multipliers.lambda_wheel_4_y - multipliers.lambda_wheel_4_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
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
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
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
    const Scalar z43 = v_x * c_psi + v_y * s_psi;
    const Scalar z44 = v_x * s_psi - v_y * c_psi;
    const Scalar z45 = v_psi - z43;
    const Scalar z46 = k0 * v_psi - z44;
    const Scalar z47 = s_alpha_1 * z46 - c_alpha_1 * z45;
    const Scalar z48 = s_alpha_1 * z45 + c_alpha_1 * z46;
    const Scalar z49 = v_psi * s_phi_1;
    const Scalar z50 = v_psi * c_phi_1;
    const Scalar z51 = c_phi_1 * z48;
    const Scalar z52 = s_phi_1 * z48;
    const Scalar z53 = k0 * v_psi + z44;
    const Scalar z54 = s_alpha_2 * z53 + c_alpha_2 * z45;
    const Scalar z55 = s_alpha_2 * z45 - c_alpha_2 * z53;
    const Scalar z56 = v_psi * s_phi_2;
    const Scalar z57 = v_psi * c_phi_2;
    const Scalar z58 = c_phi_2 * z55;
    const Scalar z59 = s_phi_2 * z55;
    const Scalar z60 = v_psi + z43;
    const Scalar z61 = s_alpha_3 * z53 - c_alpha_3 * z60;
    const Scalar z62 = s_alpha_3 * z60 + c_alpha_3 * z53;
    const Scalar z63 = v_psi * s_phi_3;
    const Scalar z64 = v_psi * c_phi_3;
    const Scalar z65 = c_phi_3 * z62;
    const Scalar z66 = s_phi_3 * z62;
    const Scalar z67 = s_alpha_4 * z46 + c_alpha_4 * z60;
    const Scalar z68 = s_alpha_4 * z60 - c_alpha_4 * z46;
    const Scalar z69 = v_psi * s_phi_4;
    const Scalar z70 = v_psi * c_phi_4;
    const Scalar z71 = c_phi_4 * z68;
    const Scalar z72 = s_phi_4 * z68;
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    result.kinetic = n10 * (z47 * z47 + z51 * z51 + z52 * z52 + z54 * z54 + z58 * z58 + z59 * z59 + z61 * z61 + z65
        * z65 + z66 * z66 + z67 * z67 + z71 * z71 + z72 * z72) + n0_25 * (z49 * z49 + z50 * z50 + z56 * z56 + z57 * z57
        + z63 * z63 + z64 * z64 + z69 * z69 + z70 * z70) + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3
        * v_phi_3 + v_phi_4 * v_phi_4) + n400 * (z43 * z43 + z44 * z44) + n450 * v_psi * v_psi;
    result.force_function = n0;
    result.power = v_phi_3 * (u_C3 - z219) + v_phi_4 * (u_C4 - z220) - v_phi_1 * z217 - v_phi_2 * z218;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z294 = precomputed.z294;
    const Scalar z295 = precomputed.z295;
    const Scalar z302 = precomputed.z302;
    const Scalar z303 = precomputed.z303;
    const Scalar z310 = precomputed.z310;
    const Scalar z311 = precomputed.z311;
    const Scalar z318 = precomputed.z318;
    const Scalar z319 = precomputed.z319;
    const Scalar z79 = q_psi + p_alpha_1;
    const Scalar z98 = q_psi + p_alpha_2;
    const Scalar z115 = q_psi + p_alpha_3;
    const Scalar z132 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z79, z98, z115, z132};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z80 = sines_[0], z81 = cosines_[0];
    const Scalar z99 = sines_[1], z100 = cosines_[1];
    const Scalar z116 = sines_[2], z117 = cosines_[2];
    const Scalar z133 = sines_[3], z134 = cosines_[3];
    const Scalar z296 = v_x * z81 + v_y * z80 + v_psi * z295;
    const Scalar z297 = v_psi * z80;
    const Scalar z298 = v_psi * z81;
    const Scalar z299 = v_x * z297 - v_y * z298;
    const Scalar z300 = v_x * z80 - v_y * z81 - v_psi * z294 - n0_3 * v_phi_1;
    const Scalar z301 = v_x * z298 + v_y * z297;
    const Scalar z304 = v_x * z100 + v_y * z99 - v_psi * z303;
    const Scalar z305 = v_psi * z99;
    const Scalar z306 = v_psi * z100;
    const Scalar z307 = v_x * z305 - v_y * z306;
    const Scalar z308 = v_x * z99 - v_y * z100 - v_psi * z302 - n0_3 * v_phi_2;
    const Scalar z309 = v_x * z306 + v_y * z305;
    const Scalar z312 = v_x * z117 + v_y * z116 - v_psi * z311;
    const Scalar z313 = v_psi * z116;
    const Scalar z314 = v_psi * z117;
    const Scalar z315 = v_x * z313 - v_y * z314;
    const Scalar z316 = v_x * z116 - v_y * z117 + v_psi * z310 - n0_3 * v_phi_3;
    const Scalar z317 = v_x * z314 + v_y * z313;
    const Scalar z320 = v_x * z134 + v_y * z133 + v_psi * z319;
    const Scalar z321 = v_psi * z133;
    const Scalar z322 = v_psi * z134;
    const Scalar z323 = v_x * z321 - v_y * z322;
    const Scalar z324 = v_x * z133 - v_y * z134 + v_psi * z318 - n0_3 * v_phi_4;
    const Scalar z325 = v_x * z322 + v_y * z321;
    result.value[0] = n0;
    result.rate[0] = z296;
    result.gamma[0] = -z299;
    result.value[1] = n0;
    result.rate[1] = -z300;
    result.gamma[1] = -z301;
    result.value[2] = n0;
    result.rate[2] = z304;
    result.gamma[2] = -z307;
    result.value[3] = n0;
    result.rate[3] = -z308;
    result.gamma[3] = -z309;
    result.value[4] = n0;
    result.rate[4] = z312;
    result.gamma[4] = -z315;
    result.value[5] = n0;
    result.rate[5] = -z316;
    result.gamma[5] = -z317;
    result.value[6] = n0;
    result.rate[6] = z320;
    result.gamma[6] = -z323;
    result.value[7] = n0;
    result.rate[7] = -z324;
    result.gamma[7] = -z325;
    result.jacobian[0] = z81;
    result.jacobian[1] = -z80;
    result.jacobian[2] = z100;
    result.jacobian[3] = -z99;
    result.jacobian[4] = z117;
    result.jacobian[5] = -z116;
    result.jacobian[6] = z134;
    result.jacobian[7] = -z133;
    result.jacobian[8] = z80;
    result.jacobian[9] = z81;
    result.jacobian[10] = z99;
    result.jacobian[11] = z100;
    result.jacobian[12] = z116;
    result.jacobian[13] = z117;
    result.jacobian[14] = z133;
    result.jacobian[15] = z134;
    result.jacobian[16] = z295;
    result.jacobian[17] = z294;
    result.jacobian[18] = -z303;
    result.jacobian[19] = z302;
    result.jacobian[20] = -z311;
    result.jacobian[21] = -z310;
    result.jacobian[22] = z319;
    result.jacobian[23] = -z318;
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
  }
};

}  // namespace four_wheel_vehicle
