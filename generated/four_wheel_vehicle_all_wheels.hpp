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
    Scalar z237;
    Scalar z238;
    Scalar z239;
    Scalar z272;
    Scalar z273;
    Scalar z274;
    Scalar z307;
    Scalar z308;
    Scalar z309;
    Scalar z485;
    Scalar z486;
    Scalar z494;
    Scalar z495;
    Scalar z503;
    Scalar z504;
    Scalar z512;
    Scalar z513;
    Scalar z531;
    Scalar z540;
    Scalar z549;
    Scalar z558;
    Scalar z585;
    Scalar z604;
    Scalar z623;
    Scalar z642;
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
    const Scalar z237 = n20 * c_alpha_3;
    const Scalar z238 = n20 * s_alpha_3;
    const Scalar z239 = z237 - k1 * z238;
    const Scalar z272 = n20 * c_alpha_2;
    const Scalar z273 = n20 * s_alpha_2;
    const Scalar z274 = z272 + k1 * z273;
    const Scalar z307 = n20 * c_alpha_1;
    const Scalar z308 = n20 * s_alpha_1;
    const Scalar z309 = z307 - k1 * z308;
    const Scalar z485 = s_alpha_1 + k1 * c_alpha_1;
    const Scalar z486 = k1 * s_alpha_1 - c_alpha_1;
    const Scalar z494 = s_alpha_2 - k1 * c_alpha_2;
    const Scalar z495 = k1 * s_alpha_2 + c_alpha_2;
    const Scalar z503 = s_alpha_3 + k1 * c_alpha_3;
    const Scalar z504 = k1 * s_alpha_3 - c_alpha_3;
    const Scalar z512 = s_alpha_4 - k1 * c_alpha_4;
    const Scalar z513 = k1 * s_alpha_4 + c_alpha_4;
    const Scalar z531 = n0_05 * z209;
    const Scalar z540 = n0_05 * z239;
    const Scalar z549 = n0_05 * z274;
    const Scalar z558 = n0_05 * z309;
    const Scalar z585 = z486 + z558;
    const Scalar z604 = z495 - z549;
    const Scalar z623 = z504 + z540;
    const Scalar z642 = z513 - z531;
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
    precomputed.z237 = z237;
    precomputed.z238 = z238;
    precomputed.z239 = z239;
    precomputed.z272 = z272;
    precomputed.z273 = z273;
    precomputed.z274 = z274;
    precomputed.z307 = z307;
    precomputed.z308 = z308;
    precomputed.z309 = z309;
    precomputed.z485 = z485;
    precomputed.z486 = z486;
    precomputed.z494 = z494;
    precomputed.z495 = z495;
    precomputed.z503 = z503;
    precomputed.z504 = z504;
    precomputed.z512 = z512;
    precomputed.z513 = z513;
    precomputed.z531 = z531;
    precomputed.z540 = z540;
    precomputed.z549 = z549;
    precomputed.z558 = z558;
    precomputed.z585 = z585;
    precomputed.z604 = z604;
    precomputed.z623 = z623;
    precomputed.z642 = z642;
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
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z272 = precomputed.z272;
    const Scalar z273 = precomputed.z273;
    const Scalar z274 = precomputed.z274;
    const Scalar z307 = precomputed.z307;
    const Scalar z308 = precomputed.z308;
    const Scalar z309 = precomputed.z309;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z210 = s_psi * z208 - c_psi * z207;
    const Scalar z211 = s_psi * z207 + c_psi * z208;
    const Scalar z212 = n20 * q_s_4 * q_s_4;
    const Scalar z213 = n20 * q_s_4;
    const Scalar z214 = n0_5 + z212;
    const Scalar z215 = s_alpha_4 * z213;
    const Scalar z216 = c_alpha_4 * z213;
    const Scalar z229 = k2 + z214 - n2 * z215 + k4 * z216;
    const Scalar z230 = k5 + z216;
    const Scalar z231 = n20 - z215;
    const Scalar z232 = n900 + z229;
    const Scalar z240 = s_psi * z238 - c_psi * z237;
    const Scalar z241 = s_psi * z237 + c_psi * z238;
    const Scalar z242 = n20 * q_s_3 * q_s_3;
    const Scalar z243 = n20 * q_s_3;
    const Scalar z244 = n0_5 + z242;
    const Scalar z245 = s_alpha_3 * z243;
    const Scalar z246 = c_alpha_3 * z243;
    const Scalar z259 = k2 + z244 - n2 * z245 - k4 * z246;
    const Scalar z260 = k5 - z246;
    const Scalar z261 = n20 - z245;
    const Scalar z262 = z230 - z260;
    const Scalar z263 = z231 + z261;
    const Scalar z267 = z232 + z259;
    const Scalar z275 = s_psi * z273 - c_psi * z272;
    const Scalar z276 = s_psi * z272 + c_psi * z273;
    const Scalar z277 = n20 * q_s_2 * q_s_2;
    const Scalar z278 = n20 * q_s_2;
    const Scalar z279 = n0_5 + z277;
    const Scalar z280 = s_alpha_2 * z278;
    const Scalar z281 = c_alpha_2 * z278;
    const Scalar z294 = k2 + z279 + n2 * z280 - k4 * z281;
    const Scalar z295 = k5 - z281;
    const Scalar z296 = n20 + z280;
    const Scalar z297 = z262 - z295;
    const Scalar z298 = z263 - z296;
    const Scalar z302 = z267 + z294;
    const Scalar z310 = s_psi * z308 - c_psi * z307;
    const Scalar z311 = s_psi * z307 + c_psi * z308;
    const Scalar z312 = n20 * q_s_1 * q_s_1;
    const Scalar z313 = n20 * q_s_1;
    const Scalar z314 = n0_5 + z312;
    const Scalar z315 = s_alpha_1 * z313;
    const Scalar z316 = c_alpha_1 * z313;
    const Scalar z329 = k2 + z314 + n2 * z315 + k4 * z316;
    const Scalar z330 = k5 + z316;
    const Scalar z331 = n20 + z315;
    const Scalar z332 = z297 + z330;
    const Scalar z333 = z298 - z331;
    const Scalar z337 = z302 + z329;
    const Scalar z338 = s_psi * z332 - c_psi * z333;
    const Scalar z339 = s_psi * z333 + c_psi * z332;
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = -z338;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = -z310;
    mass[8] = -z275;
    mass[9] = -z240;
    mass[10] = -z210;
    mass[11] = n0;
    mass[12] = n880;
    mass[13] = z339;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z311;
    mass[19] = z276;
    mass[20] = z241;
    mass[21] = z211;
    mass[22] = -z338;
    mass[23] = z339;
    mass[24] = z337;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = -z309;
    mass[30] = -z274;
    mass[31] = z239;
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
    mass[77] = -z310;
    mass[78] = z311;
    mass[79] = -z309;
    mass[80] = n0;
    mass[81] = n0;
    mass[82] = n0;
    mass[83] = n0;
    mass[84] = n20;
    mass[85] = n0;
    mass[86] = n0;
    mass[87] = n0;
    mass[88] = -z275;
    mass[89] = z276;
    mass[90] = -z274;
    mass[91] = n0;
    mass[92] = n0;
    mass[93] = n0;
    mass[94] = n0;
    mass[95] = n0;
    mass[96] = n20;
    mass[97] = n0;
    mass[98] = n0;
    mass[99] = -z240;
    mass[100] = z241;
    mass[101] = z239;
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
    const Scalar z351 = v_psi * v_psi;
    const Scalar z352 = k0 * z351;
    const Scalar z353 = s_alpha_1 * z351 + c_alpha_1 * z352;
    const Scalar z354 = s_alpha_1 * z352 - c_alpha_1 * z351;
    const Scalar z355 = q_s_1 * z351 + z353;
    const Scalar z356 = n2 * v_psi * v_s_1 + z354;
    const Scalar z358 = s_alpha_2 * z351 - c_alpha_2 * z352;
    const Scalar z359 = s_alpha_2 * z352 + c_alpha_2 * z351;
    const Scalar z360 = q_s_2 * z351 + z358;
    const Scalar z361 = n2 * v_psi * v_s_2 - z359;
    const Scalar z363 = s_alpha_3 * z351 + c_alpha_3 * z352;
    const Scalar z364 = s_alpha_3 * z352 - c_alpha_3 * z351;
    const Scalar z365 = q_s_3 * z351 - z363;
    const Scalar z366 = n2 * v_psi * v_s_3 - z364;
    const Scalar z368 = s_alpha_4 * z351 - c_alpha_4 * z352;
    const Scalar z369 = s_alpha_4 * z352 + c_alpha_4 * z351;
    const Scalar z370 = q_s_4 * z351 - z368;
    const Scalar z371 = n2 * v_psi * v_s_4 + z369;
    const Scalar z374 = n20 * z370;  // force on axle_4, x
    const Scalar z375 = n20 * z371;  // force on axle_4, y
    const Scalar z376 = q_s_4 * z375;  // moment on steered_4, z
    const Scalar z377 = s_alpha_4 * z375 + c_alpha_4 * z374;
    const Scalar z378 = s_alpha_4 * z374 - c_alpha_4 * z375;
    const Scalar z382 = n20 * z365;  // force on axle_3, x
    const Scalar z383 = n20 * z366;  // force on axle_3, y
    const Scalar z384 = q_s_3 * z383;  // moment on steered_3, z
    const Scalar z385 = s_alpha_3 * z383 + c_alpha_3 * z382;
    const Scalar z386 = s_alpha_3 * z382 - c_alpha_3 * z383;
    const Scalar z390 = n20 * z360;  // force on axle_2, x
    const Scalar z391 = n20 * z361;  // force on axle_2, y
    const Scalar z392 = q_s_2 * z391;  // moment on steered_2, z
    const Scalar z393 = s_alpha_2 * z391 + c_alpha_2 * z390;
    const Scalar z394 = s_alpha_2 * z390 - c_alpha_2 * z391;
    const Scalar z398 = n20 * z355;  // force on axle_1, x
    const Scalar z399 = n20 * z356;  // force on axle_1, y
    const Scalar z400 = q_s_1 * z399;  // moment on steered_1, z
    const Scalar z401 = s_alpha_1 * z399 + c_alpha_1 * z398;
    const Scalar z402 = s_alpha_1 * z398 - c_alpha_1 * z399;
    const Scalar z405 = z377 + z385 + z393 + z401;  // force on S, x
    const Scalar z406 = z378 + z386 + z394 + z402;  // force on S, y
    // moment on S, z
    const Scalar z409 = -k0 * (z378 - z386 - z394 + z402) + z376 - z377 + z384 - z385 + z392 + z393 + z400 + z401;
    const Scalar z410 = s_psi * z406 - c_psi * z405;
    const Scalar z411 = s_psi * z405 + c_psi * z406;
    forces.x = z410;
    forces.y = -z411;
    forces.psi = z409;
    forces.phi_1 = n0;
    forces.phi_2 = n0;
    forces.phi_3 = n0;
    forces.phi_4 = n0;
    forces.s_1 = -z398;
    forces.s_2 = -z390;
    forces.s_3 = -z382;
    forces.s_4 = -z374;
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
    const Scalar z485 = precomputed.z485;
    const Scalar z486 = precomputed.z486;
    const Scalar z494 = precomputed.z494;
    const Scalar z495 = precomputed.z495;
    const Scalar z503 = precomputed.z503;
    const Scalar z504 = precomputed.z504;
    const Scalar z512 = precomputed.z512;
    const Scalar z513 = precomputed.z513;
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
    const Scalar z351 = v_psi * v_psi;
    const Scalar z415 = a_x * c_psi + a_y * s_psi;
    const Scalar z416 = a_x * s_psi - a_y * c_psi;
    const Scalar z417 = a_psi + k0 * z351 - z415;
    const Scalar z418 = k0 * a_psi - z351 - z416;
    const Scalar z419 = s_alpha_1 * z418 - c_alpha_1 * z417;
    const Scalar z420 = s_alpha_1 * z417 + c_alpha_1 * z418;
    const Scalar z421 = q_s_1 * z351 - a_s_1 - z419;
    const Scalar z422 = n2 * v_psi * v_s_1 + a_psi * q_s_1 + z420;
    const Scalar z423 = a_psi - k0 * z351 - z415;
    const Scalar z424 = k0 * a_psi + z351 + z416;
    const Scalar z425 = s_alpha_2 * z424 + c_alpha_2 * z423;
    const Scalar z426 = s_alpha_2 * z423 - c_alpha_2 * z424;
    const Scalar z427 = q_s_2 * z351 - a_s_2 + z425;
    const Scalar z428 = n2 * v_psi * v_s_2 + a_psi * q_s_2 + z426;
    const Scalar z429 = a_psi + k0 * z351 + z415;
    const Scalar z430 = k0 * a_psi - z351 + z416;
    const Scalar z431 = s_alpha_3 * z430 - c_alpha_3 * z429;
    const Scalar z432 = s_alpha_3 * z429 + c_alpha_3 * z430;
    const Scalar z433 = q_s_3 * z351 - a_s_3 + z431;
    const Scalar z434 = n2 * v_psi * v_s_3 + a_psi * q_s_3 - z432;
    const Scalar z435 = a_psi - k0 * z351 + z415;
    const Scalar z436 = k0 * a_psi + z351 - z416;
    const Scalar z437 = s_alpha_4 * z436 + c_alpha_4 * z435;
    const Scalar z438 = s_alpha_4 * z435 - c_alpha_4 * z436;
    const Scalar z439 = q_s_4 * z351 - a_s_4 - z437;
    const Scalar z440 = n2 * v_psi * v_s_4 + a_psi * q_s_4 - z438;
    const Scalar z441 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z442 = n20 * z439;  // force on axle_4, x
    const Scalar z443 = n20 * z440;  // force on axle_4, y
    const Scalar z444 = n0_5 * a_psi + q_s_4 * z443;  // moment on steered_4, z
    const Scalar z445 = s_alpha_4 * z443 + c_alpha_4 * z442;
    const Scalar z446 = s_alpha_4 * z442 - c_alpha_4 * z443;
    const Scalar z449 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z450 = n20 * z433;  // force on axle_3, x
    const Scalar z451 = n20 * z434;  // force on axle_3, y
    const Scalar z452 = n0_5 * a_psi + q_s_3 * z451;  // moment on steered_3, z
    const Scalar z453 = s_alpha_3 * z451 + c_alpha_3 * z450;
    const Scalar z454 = s_alpha_3 * z450 - c_alpha_3 * z451;
    const Scalar z457 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z458 = n20 * z427;  // force on axle_2, x
    const Scalar z459 = n20 * z428;  // force on axle_2, y
    const Scalar z460 = n0_5 * a_psi + q_s_2 * z459;  // moment on steered_2, z
    const Scalar z461 = s_alpha_2 * z459 + c_alpha_2 * z458;
    const Scalar z462 = s_alpha_2 * z458 - c_alpha_2 * z459;
    const Scalar z465 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z466 = n20 * z421;  // force on axle_1, x
    const Scalar z467 = n20 * z422;  // force on axle_1, y
    const Scalar z468 = n0_5 * a_psi + q_s_1 * z467;  // moment on steered_1, z
    const Scalar z469 = s_alpha_1 * z467 + c_alpha_1 * z466;
    const Scalar z470 = s_alpha_1 * z466 - c_alpha_1 * z467;
    const Scalar z473 = z445 + z453 + z461 + z469;  // force on S, x
    const Scalar z474 = z446 + z454 + z462 + z470;  // force on S, y
    // moment on S, z
    const Scalar z477 = -k0 * (z446 - z454 - z462 + z470) + n900 * a_psi + z444 - z445 + z452 - z453 + z460 + z461
        + z468 + z469;
    const Scalar z478 = s_psi * z474 - c_psi * z473;
    const Scalar z479 = s_psi * z473 + c_psi * z474;
    const Scalar z482 = n800 * a_x + z478;  // force on S.y, x
    const Scalar z483 = n800 * a_y - z479;  // force on S.y, y
    const Scalar z487 = q_s_1 + z485;
    const Scalar z496 = q_s_2 + z494;
    const Scalar z505 = q_s_3 - z503;
    const Scalar z514 = q_s_4 - z512;
    forces.x = z104 * l_lambda_wheel_1_y - z105 * l_lambda_wheel_1_x + z127 * l_lambda_wheel_2_y - z128
        * l_lambda_wheel_2_x + z150 * l_lambda_wheel_3_y - z151 * l_lambda_wheel_3_x + z173 * l_lambda_wheel_4_y - z174
        * l_lambda_wheel_4_x + z482;
    forces.y = -z104 * l_lambda_wheel_1_x - z105 * l_lambda_wheel_1_y - z127 * l_lambda_wheel_2_x - z128
        * l_lambda_wheel_2_y - z150 * l_lambda_wheel_3_x - z151 * l_lambda_wheel_3_y - z173 * l_lambda_wheel_4_x - z174
        * l_lambda_wheel_4_y + z483;
    forces.psi = z477 - z486 * l_lambda_wheel_1_x - z487 * l_lambda_wheel_1_y + z495 * l_lambda_wheel_2_x - z496
        * l_lambda_wheel_2_y + z504 * l_lambda_wheel_3_x - z505 * l_lambda_wheel_3_y - z513 * l_lambda_wheel_4_x - z514
        * l_lambda_wheel_4_y;
    forces.phi_1 = z465 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z457 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z449 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z441 - n0_3 * l_lambda_wheel_4_y;
    forces.s_1 = -z466 - l_lambda_wheel_1_x;
    forces.s_2 = -z458 - l_lambda_wheel_2_x;
    forces.s_3 = -z450 - l_lambda_wheel_3_x;
    forces.s_4 = -z442 - l_lambda_wheel_4_x;
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
    const Scalar z237 = precomputed.z237;
    const Scalar z238 = precomputed.z238;
    const Scalar z239 = precomputed.z239;
    const Scalar z272 = precomputed.z272;
    const Scalar z273 = precomputed.z273;
    const Scalar z274 = precomputed.z274;
    const Scalar z307 = precomputed.z307;
    const Scalar z308 = precomputed.z308;
    const Scalar z309 = precomputed.z309;
    const Scalar z485 = precomputed.z485;
    const Scalar z486 = precomputed.z486;
    const Scalar z494 = precomputed.z494;
    const Scalar z495 = precomputed.z495;
    const Scalar z503 = precomputed.z503;
    const Scalar z504 = precomputed.z504;
    const Scalar z512 = precomputed.z512;
    const Scalar z513 = precomputed.z513;
    const Scalar z531 = precomputed.z531;
    const Scalar z540 = precomputed.z540;
    const Scalar z549 = precomputed.z549;
    const Scalar z558 = precomputed.z558;
    const Scalar z585 = precomputed.z585;
    const Scalar z604 = precomputed.z604;
    const Scalar z623 = precomputed.z623;
    const Scalar z642 = precomputed.z642;
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
    const Scalar z212 = n20 * q_s_4 * q_s_4;
    const Scalar z213 = n20 * q_s_4;
    const Scalar z214 = n0_5 + z212;
    const Scalar z215 = s_alpha_4 * z213;
    const Scalar z216 = c_alpha_4 * z213;
    const Scalar z229 = k2 + z214 - n2 * z215 + k4 * z216;
    const Scalar z230 = k5 + z216;
    const Scalar z231 = n20 - z215;
    const Scalar z232 = n900 + z229;
    const Scalar z240 = s_psi * z238 - c_psi * z237;
    const Scalar z241 = s_psi * z237 + c_psi * z238;
    const Scalar z242 = n20 * q_s_3 * q_s_3;
    const Scalar z243 = n20 * q_s_3;
    const Scalar z244 = n0_5 + z242;
    const Scalar z245 = s_alpha_3 * z243;
    const Scalar z246 = c_alpha_3 * z243;
    const Scalar z259 = k2 + z244 - n2 * z245 - k4 * z246;
    const Scalar z260 = k5 - z246;
    const Scalar z261 = n20 - z245;
    const Scalar z262 = z230 - z260;
    const Scalar z263 = z231 + z261;
    const Scalar z267 = z232 + z259;
    const Scalar z275 = s_psi * z273 - c_psi * z272;
    const Scalar z276 = s_psi * z272 + c_psi * z273;
    const Scalar z277 = n20 * q_s_2 * q_s_2;
    const Scalar z278 = n20 * q_s_2;
    const Scalar z279 = n0_5 + z277;
    const Scalar z280 = s_alpha_2 * z278;
    const Scalar z281 = c_alpha_2 * z278;
    const Scalar z294 = k2 + z279 + n2 * z280 - k4 * z281;
    const Scalar z295 = k5 - z281;
    const Scalar z296 = n20 + z280;
    const Scalar z297 = z262 - z295;
    const Scalar z298 = z263 - z296;
    const Scalar z302 = z267 + z294;
    const Scalar z310 = s_psi * z308 - c_psi * z307;
    const Scalar z311 = s_psi * z307 + c_psi * z308;
    const Scalar z312 = n20 * q_s_1 * q_s_1;
    const Scalar z313 = n20 * q_s_1;
    const Scalar z314 = n0_5 + z312;
    const Scalar z315 = s_alpha_1 * z313;
    const Scalar z316 = c_alpha_1 * z313;
    const Scalar z329 = k2 + z314 + n2 * z315 + k4 * z316;
    const Scalar z330 = k5 + z316;
    const Scalar z331 = n20 + z315;
    const Scalar z332 = z297 + z330;
    const Scalar z333 = z298 - z331;
    const Scalar z337 = z302 + z329;
    const Scalar z338 = s_psi * z332 - c_psi * z333;
    const Scalar z339 = s_psi * z333 + c_psi * z332;
    const Scalar z351 = v_psi * v_psi;
    const Scalar z352 = k7 * z351;
    const Scalar z353 = s_alpha_1 * z351 + c_alpha_1 * z352;
    const Scalar z354 = s_alpha_1 * z352 - c_alpha_1 * z351;
    const Scalar z355 = q_s_1 * z351 + z353;
    const Scalar z356 = n2 * v_psi * v_s_1 + z354;
    const Scalar z358 = s_alpha_2 * z351 - c_alpha_2 * z352;
    const Scalar z359 = s_alpha_2 * z352 + c_alpha_2 * z351;
    const Scalar z360 = q_s_2 * z351 + z358;
    const Scalar z361 = n2 * v_psi * v_s_2 - z359;
    const Scalar z363 = s_alpha_3 * z351 + c_alpha_3 * z352;
    const Scalar z364 = s_alpha_3 * z352 - c_alpha_3 * z351;
    const Scalar z365 = q_s_3 * z351 - z363;
    const Scalar z366 = n2 * v_psi * v_s_3 - z364;
    const Scalar z368 = s_alpha_4 * z351 - c_alpha_4 * z352;
    const Scalar z369 = s_alpha_4 * z352 + c_alpha_4 * z351;
    const Scalar z370 = q_s_4 * z351 - z368;
    const Scalar z371 = n2 * v_psi * v_s_4 + z369;
    const Scalar z374 = n20 * z370;  // force on axle_4, x
    const Scalar z375 = n20 * z371;  // force on axle_4, y
    const Scalar z376 = q_s_4 * z375;  // moment on steered_4, z
    const Scalar z377 = s_alpha_4 * z375 + c_alpha_4 * z374;
    const Scalar z378 = s_alpha_4 * z374 - c_alpha_4 * z375;
    const Scalar z382 = n20 * z365;  // force on axle_3, x
    const Scalar z383 = n20 * z366;  // force on axle_3, y
    const Scalar z384 = q_s_3 * z383;  // moment on steered_3, z
    const Scalar z385 = s_alpha_3 * z383 + c_alpha_3 * z382;
    const Scalar z386 = s_alpha_3 * z382 - c_alpha_3 * z383;
    const Scalar z390 = n20 * z360;  // force on axle_2, x
    const Scalar z391 = n20 * z361;  // force on axle_2, y
    const Scalar z392 = q_s_2 * z391;  // moment on steered_2, z
    const Scalar z393 = s_alpha_2 * z391 + c_alpha_2 * z390;
    const Scalar z394 = s_alpha_2 * z390 - c_alpha_2 * z391;
    const Scalar z398 = n20 * z355;  // force on axle_1, x
    const Scalar z399 = n20 * z356;  // force on axle_1, y
    const Scalar z400 = q_s_1 * z399;  // moment on steered_1, z
    const Scalar z401 = s_alpha_1 * z399 + c_alpha_1 * z398;
    const Scalar z402 = s_alpha_1 * z398 - c_alpha_1 * z399;
    const Scalar z405 = z377 + z385 + z393 + z401;  // force on S, x
    const Scalar z406 = z378 + z386 + z394 + z402;  // force on S, y
    // moment on S, z
    const Scalar z409 = -k7 * (z378 - z386 - z394 + z402) + z376 - z377 + z384 - z385 + z392 + z393 + z400 + z401;
    const Scalar z410 = s_psi * z406 - c_psi * z405;
    const Scalar z411 = s_psi * z405 + c_psi * z406;
    const Scalar z487 = q_s_1 + z485;
    const Scalar z489 = v_psi * z104;
    const Scalar z490 = v_psi * z105;
    const Scalar z491 = v_x * z489 - v_y * z490;
    const Scalar z493 = v_x * z490 + v_y * z489 - v_psi * v_s_1;
    const Scalar z496 = q_s_2 + z494;
    const Scalar z498 = v_psi * z127;
    const Scalar z499 = v_psi * z128;
    const Scalar z500 = v_x * z498 - v_y * z499;
    const Scalar z502 = v_x * z499 + v_y * z498 - v_psi * v_s_2;
    const Scalar z505 = q_s_3 - z503;
    const Scalar z507 = v_psi * z150;
    const Scalar z508 = v_psi * z151;
    const Scalar z509 = v_x * z507 - v_y * z508;
    const Scalar z511 = v_x * z508 + v_y * z507 - v_psi * v_s_3;
    const Scalar z514 = q_s_4 - z512;
    const Scalar z516 = v_psi * z173;
    const Scalar z517 = v_psi * z174;
    const Scalar z518 = v_x * z516 - v_y * z517;
    const Scalar z520 = v_x * z517 + v_y * z516 - v_psi * v_s_4;
    const Scalar z529 = n0_05 * z210;
    const Scalar z530 = n0_05 * z211;
    const Scalar z532 = n880 - z210 * z529;
    const Scalar z533 = z210 * z530;
    const Scalar z534 = n880 - z211 * z530;
    const Scalar z535 = z210 * z531 - z338;
    const Scalar z536 = z211 * z531 - z339;
    const Scalar z537 = z209 * z531 - z337;
    const Scalar z538 = n0_05 * z240;
    const Scalar z539 = n0_05 * z241;
    const Scalar z541 = z240 * z538 - z532;
    const Scalar z542 = z240 * z539 + z533;
    const Scalar z543 = z241 * z539 - z534;
    const Scalar z544 = z240 * z540 + z535;
    const Scalar z545 = z241 * z540 + z536;
    const Scalar z546 = z239 * z540 + z537;
    const Scalar z547 = n0_05 * z275;
    const Scalar z548 = n0_05 * z276;
    const Scalar z550 = z275 * z547 + z541;
    const Scalar z551 = z275 * z548 + z542;
    const Scalar z552 = z276 * z548 + z543;
    const Scalar z553 = z275 * z549 - z544;
    const Scalar z554 = z276 * z549 - z545;
    const Scalar z555 = z274 * z549 + z546;
    const Scalar z556 = n0_05 * z310;
    const Scalar z557 = n0_05 * z311;
    const Scalar z559 = z310 * z556 + z550;
    const Scalar z560 = z310 * z557 + z551;
    const Scalar z561 = z311 * z557 + z552;
    const Scalar z562 = z310 * z558 + z553;
    const Scalar z563 = z311 * z558 + z554;
    const Scalar z564 = z309 * z558 + z555;
    const Scalar z565 = n1 / z564;
    const Scalar z566 = z562 * z565;
    const Scalar z567 = z563 * z565;
    const Scalar z568 = z559 - z562 * z566;
    const Scalar z569 = z560 - z562 * z567;
    const Scalar z570 = z561 - z563 * z567;
    const Scalar z571 = n1 / z570;
    const Scalar z572 = z569 * z571;
    const Scalar z573 = z568 - z569 * z572;
    const Scalar z574 = n1 / z573;
    const Scalar z575 = z374 * z531 + z382 * z540 - z390 * z549 - z398 * z558 + z409;
    const Scalar z576 = z374 * z530 + z382 * z539 + z390 * z548 + z398 * z557 - z411 + z567 * z575;
    const Scalar z577 = z374 * z529 + z382 * z538 + z390 * z547 + z398 * z556 - z410 + z566 * z575 - z572 * z576;
    const Scalar z578 = z574 * z577;
    const Scalar z579 = z571 * z576 - z572 * z578;
    const Scalar z580 = z565 * z575 + z566 * z578 + z567 * z579;
    const Scalar z581 = n0_05 * z398 - z556 * z578 - z557 * z579 + z558 * z580;
    const Scalar z582 = n0_05 * z390 - z547 * z578 - z548 * z579 + z549 * z580;
    const Scalar z583 = n0_05 * z382 - z538 * z578 - z539 * z579 - z540 * z580;
    const Scalar z584 = n0_05 * z374 - z529 * z578 - z530 * z579 - z531 * z580;
    const Scalar z586 = z104 - z557 + z567 * z585;
    const Scalar z587 = z105 + z556 - z566 * z585 + z572 * z586;
    const Scalar z588 = z574 * z587;
    const Scalar z589 = z571 * z586 + z572 * z588;
    const Scalar z590 = z565 * z585 - z566 * z588 + z567 * z589;
    const Scalar z591 = n0_05 - z556 * z588 + z557 * z589 - z558 * z590;
    const Scalar z592 = z547 * z588 - z548 * z589 + z549 * z590;
    const Scalar z593 = z538 * z588 - z539 * z589 - z540 * z590;
    const Scalar z594 = z529 * z588 - z530 * z589 - z531 * z590;
    const Scalar z595 = z105 + z487 * z567;
    const Scalar z596 = z104 + z487 * z566 - z572 * z595;
    const Scalar z597 = z574 * z596;
    const Scalar z598 = z571 * z595 - z572 * z597;
    const Scalar z599 = z487 * z565 + z566 * z597 + z567 * z598;
    const Scalar z600 = z556 * z597 + z557 * z598 - z558 * z599;
    const Scalar z601 = z547 * z597 + z548 * z598 - z549 * z599;
    const Scalar z602 = z538 * z597 + z539 * z598 + z540 * z599;
    const Scalar z603 = z529 * z597 + z530 * z598 + z531 * z599;
    const Scalar z605 = z127 - z548 - z567 * z604;
    const Scalar z606 = z128 + z547 + z566 * z604 + z572 * z605;
    const Scalar z607 = z574 * z606;
    const Scalar z608 = z571 * z605 + z572 * z607;
    const Scalar z609 = z565 * z604 + z566 * z607 - z567 * z608;
    const Scalar z610 = z556 * z607 - z557 * z608 - z558 * z609;
    const Scalar z611 = n0_05 - z547 * z607 + z548 * z608 + z549 * z609;
    const Scalar z612 = z538 * z607 - z539 * z608 + z540 * z609;
    const Scalar z613 = z529 * z607 - z530 * z608 + z531 * z609;
    const Scalar z614 = z128 + z496 * z567;
    const Scalar z615 = z127 + z496 * z566 - z572 * z614;
    const Scalar z616 = z574 * z615;
    const Scalar z617 = z571 * z614 - z572 * z616;
    const Scalar z618 = z496 * z565 + z566 * z616 + z567 * z617;
    const Scalar z619 = z556 * z616 + z557 * z617 - z558 * z618;
    const Scalar z620 = z547 * z616 + z548 * z617 - z549 * z618;
    const Scalar z621 = z538 * z616 + z539 * z617 + z540 * z618;
    const Scalar z622 = z529 * z616 + z530 * z617 + z531 * z618;
    const Scalar z624 = z150 - z539 - z567 * z623;
    const Scalar z625 = z151 + z538 + z566 * z623 + z572 * z624;
    const Scalar z626 = z574 * z625;
    const Scalar z627 = z571 * z624 + z572 * z626;
    const Scalar z628 = z565 * z623 + z566 * z626 - z567 * z627;
    const Scalar z629 = z556 * z626 - z557 * z627 - z558 * z628;
    const Scalar z630 = z547 * z626 - z548 * z627 - z549 * z628;
    const Scalar z631 = n0_05 - z538 * z626 + z539 * z627 - z540 * z628;
    const Scalar z632 = z529 * z626 - z530 * z627 + z531 * z628;
    const Scalar z633 = z151 + z505 * z567;
    const Scalar z634 = z150 + z505 * z566 - z572 * z633;
    const Scalar z635 = z574 * z634;
    const Scalar z636 = z571 * z633 - z572 * z635;
    const Scalar z637 = z505 * z565 + z566 * z635 + z567 * z636;
    const Scalar z638 = z556 * z635 + z557 * z636 - z558 * z637;
    const Scalar z639 = z547 * z635 + z548 * z636 - z549 * z637;
    const Scalar z640 = z538 * z635 + z539 * z636 + z540 * z637;
    const Scalar z641 = z529 * z635 + z530 * z636 + z531 * z637;
    const Scalar z643 = z173 - z530 + z567 * z642;
    const Scalar z644 = z174 + z529 - z566 * z642 + z572 * z643;
    const Scalar z645 = z574 * z644;
    const Scalar z646 = z571 * z643 + z572 * z645;
    const Scalar z647 = z565 * z642 - z566 * z645 + z567 * z646;
    const Scalar z648 = z556 * z645 - z557 * z646 + z558 * z647;
    const Scalar z649 = z547 * z645 - z548 * z646 + z549 * z647;
    const Scalar z650 = z538 * z645 - z539 * z646 - z540 * z647;
    const Scalar z651 = n0_05 - z529 * z645 + z530 * z646 + z531 * z647;
    const Scalar z652 = z174 + z514 * z567;
    const Scalar z653 = z173 + z514 * z566 - z572 * z652;
    const Scalar z654 = z574 * z653;
    const Scalar z655 = z571 * z652 - z572 * z654;
    const Scalar z656 = z514 * z565 + z566 * z654 + z567 * z655;
    const Scalar z657 = z556 * z654 + z557 * z655 - z558 * z656;
    const Scalar z658 = z547 * z654 + z548 * z655 - z549 * z656;
    const Scalar z659 = z538 * z654 + z539 * z655 + z540 * z656;
    const Scalar z660 = z529 * z654 + z530 * z655 + z531 * z656;
    const Scalar z661 = z104 * z589 + z105 * z588 + z486 * z590 - z591;
    const Scalar z662 = z104 * z579 - z105 * z578 + z486 * z580 - z491 + z581;
    const Scalar z663 = z104 * z588 - z105 * z589 - z487 * z590;
    const Scalar z664 = n0_1 - z104 * z597 - z105 * z598 - z487 * z599;
    const Scalar z665 = z104 * z578 + z105 * z579 + z487 * z580 - z493;
    const Scalar z666 = z127 * z589 + z128 * z588 - z495 * z590 + z592;
    const Scalar z667 = z127 * z598 - z128 * z597 - z495 * z599 - z601;
    const Scalar z668 = z127 * z608 + z128 * z607 + z495 * z609 - z611;
    const Scalar z669 = z127 * z579 - z128 * z578 - z495 * z580 - z500 + z582;
    const Scalar z670 = z127 * z588 - z128 * z589 - z496 * z590;
    const Scalar z671 = z127 * z597 + z128 * z598 + z496 * z599;
    const Scalar z672 = z127 * z607 - z128 * z608 + z496 * z609;
    const Scalar z673 = n0_1 - z127 * z616 - z128 * z617 - z496 * z618;
    const Scalar z674 = z127 * z578 + z128 * z579 + z496 * z580 - z502;
    const Scalar z675 = z150 * z589 + z151 * z588 - z504 * z590 + z593;
    const Scalar z676 = z150 * z598 - z151 * z597 - z504 * z599 - z602;
    const Scalar z677 = z150 * z608 + z151 * z607 + z504 * z609 + z612;
    const Scalar z678 = z150 * z617 - z151 * z616 - z504 * z618 - z621;
    const Scalar z679 = z150 * z627 + z151 * z626 + z504 * z628 - z631;
    const Scalar z680 = z150 * z579 - z151 * z578 - z504 * z580 - z509 + z583;
    const Scalar z681 = z150 * z588 - z151 * z589 - z505 * z590;
    const Scalar z682 = z150 * z597 + z151 * z598 + z505 * z599;
    const Scalar z683 = z150 * z607 - z151 * z608 + z505 * z609;
    const Scalar z684 = z150 * z616 + z151 * z617 + z505 * z618;
    const Scalar z685 = z150 * z626 - z151 * z627 + z505 * z628;
    const Scalar z686 = n0_1 - z150 * z635 - z151 * z636 - z505 * z637;
    const Scalar z687 = z150 * z578 + z151 * z579 + z505 * z580 - z511;
    const Scalar z688 = z173 * z589 + z174 * z588 + z513 * z590 + z594;
    const Scalar z689 = z173 * z598 - z174 * z597 + z513 * z599 - z603;
    const Scalar z690 = z173 * z608 + z174 * z607 - z513 * z609 + z613;
    const Scalar z691 = z173 * z617 - z174 * z616 + z513 * z618 - z622;
    const Scalar z692 = z173 * z627 + z174 * z626 - z513 * z628 + z632;
    const Scalar z693 = z173 * z636 - z174 * z635 + z513 * z637 - z641;
    const Scalar z694 = z173 * z646 + z174 * z645 + z513 * z647 - z651;
    const Scalar z695 = z173 * z579 - z174 * z578 + z513 * z580 - z518 + z584;
    const Scalar z696 = z173 * z588 - z174 * z589 - z514 * z590;
    const Scalar z697 = z173 * z597 + z174 * z598 + z514 * z599;
    const Scalar z698 = z173 * z607 - z174 * z608 + z514 * z609;
    const Scalar z699 = z173 * z616 + z174 * z617 + z514 * z618;
    const Scalar z700 = z173 * z626 - z174 * z627 + z514 * z628;
    const Scalar z701 = z173 * z635 + z174 * z636 + z514 * z637;
    const Scalar z702 = z173 * z645 - z174 * z646 - z514 * z647;
    const Scalar z703 = n0_1 - z173 * z654 - z174 * z655 - z514 * z656;
    const Scalar z704 = z173 * z578 + z174 * z579 + z514 * z580 - z520;
    const Scalar z705 = n1 / z703;
    const Scalar z706 = z696 * z705;
    const Scalar z707 = z697 * z705;
    const Scalar z708 = z698 * z705;
    const Scalar z709 = z699 * z705;
    const Scalar z710 = z700 * z705;
    const Scalar z711 = z701 * z705;
    const Scalar z712 = z702 * z705;
    const Scalar z713 = z661 + z696 * z706;
    const Scalar z714 = z663 + z696 * z707;
    const Scalar z715 = z664 - z697 * z707;
    const Scalar z716 = z666 + z696 * z708;
    const Scalar z717 = z667 - z697 * z708;
    const Scalar z718 = z668 + z698 * z708;
    const Scalar z719 = z670 + z696 * z709;
    const Scalar z720 = z671 + z697 * z709;
    const Scalar z721 = z672 + z698 * z709;
    const Scalar z722 = z673 - z699 * z709;
    const Scalar z723 = z675 + z696 * z710;
    const Scalar z724 = z676 - z697 * z710;
    const Scalar z725 = z677 + z698 * z710;
    const Scalar z726 = z678 - z699 * z710;
    const Scalar z727 = z679 + z700 * z710;
    const Scalar z728 = z681 + z696 * z711;
    const Scalar z729 = z682 + z697 * z711;
    const Scalar z730 = z683 + z698 * z711;
    const Scalar z731 = z684 + z699 * z711;
    const Scalar z732 = z685 + z700 * z711;
    const Scalar z733 = z686 - z701 * z711;
    const Scalar z734 = z688 + z696 * z712;
    const Scalar z735 = z689 - z697 * z712;
    const Scalar z736 = z690 + z698 * z712;
    const Scalar z737 = z691 - z699 * z712;
    const Scalar z738 = z692 + z700 * z712;
    const Scalar z739 = z693 - z701 * z712;
    const Scalar z740 = z694 + z702 * z712;
    const Scalar z741 = n1 / z740;
    const Scalar z742 = z734 * z741;
    const Scalar z743 = z735 * z741;
    const Scalar z744 = z736 * z741;
    const Scalar z745 = z737 * z741;
    const Scalar z746 = z738 * z741;
    const Scalar z747 = z739 * z741;
    const Scalar z748 = z713 - z734 * z742;
    const Scalar z749 = z714 + z734 * z743;
    const Scalar z750 = z715 + z735 * z743;
    const Scalar z751 = z716 - z734 * z744;
    const Scalar z752 = z717 - z735 * z744;
    const Scalar z753 = z718 - z736 * z744;
    const Scalar z754 = z719 + z734 * z745;
    const Scalar z755 = z720 - z735 * z745;
    const Scalar z756 = z721 + z736 * z745;
    const Scalar z757 = z722 + z737 * z745;
    const Scalar z758 = z723 - z734 * z746;
    const Scalar z759 = z724 - z735 * z746;
    const Scalar z760 = z725 - z736 * z746;
    const Scalar z761 = z726 - z737 * z746;
    const Scalar z762 = z727 - z738 * z746;
    const Scalar z763 = z728 + z734 * z747;
    const Scalar z764 = z729 - z735 * z747;
    const Scalar z765 = z730 + z736 * z747;
    const Scalar z766 = z731 - z737 * z747;
    const Scalar z767 = z732 + z738 * z747;
    const Scalar z768 = z733 + z739 * z747;
    const Scalar z769 = n1 / z768;
    const Scalar z770 = z763 * z769;
    const Scalar z771 = z764 * z769;
    const Scalar z772 = z765 * z769;
    const Scalar z773 = z766 * z769;
    const Scalar z774 = z767 * z769;
    const Scalar z775 = z748 + z763 * z770;
    const Scalar z776 = z749 + z763 * z771;
    const Scalar z777 = z750 - z764 * z771;
    const Scalar z778 = z751 + z763 * z772;
    const Scalar z779 = z752 - z764 * z772;
    const Scalar z780 = z753 + z765 * z772;
    const Scalar z781 = z754 + z763 * z773;
    const Scalar z782 = z755 + z764 * z773;
    const Scalar z783 = z756 + z765 * z773;
    const Scalar z784 = z757 - z766 * z773;
    const Scalar z785 = z758 + z763 * z774;
    const Scalar z786 = z759 - z764 * z774;
    const Scalar z787 = z760 + z765 * z774;
    const Scalar z788 = z761 - z766 * z774;
    const Scalar z789 = z762 + z767 * z774;
    const Scalar z790 = n1 / z789;
    const Scalar z791 = z785 * z790;
    const Scalar z792 = z786 * z790;
    const Scalar z793 = z787 * z790;
    const Scalar z794 = z788 * z790;
    const Scalar z795 = z775 - z785 * z791;
    const Scalar z796 = z776 + z785 * z792;
    const Scalar z797 = z777 + z786 * z792;
    const Scalar z798 = z778 - z785 * z793;
    const Scalar z799 = z779 - z786 * z793;
    const Scalar z800 = z780 - z787 * z793;
    const Scalar z801 = z781 + z785 * z794;
    const Scalar z802 = z782 - z786 * z794;
    const Scalar z803 = z783 + z787 * z794;
    const Scalar z804 = z784 + z788 * z794;
    const Scalar z805 = n1 / z804;
    const Scalar z806 = z801 * z805;
    const Scalar z807 = z802 * z805;
    const Scalar z808 = z803 * z805;
    const Scalar z809 = z795 + z801 * z806;
    const Scalar z810 = z796 + z801 * z807;
    const Scalar z811 = z797 - z802 * z807;
    const Scalar z812 = z798 + z801 * z808;
    const Scalar z813 = z799 - z802 * z808;
    const Scalar z814 = z800 + z803 * z808;
    const Scalar z815 = n1 / z814;
    const Scalar z816 = z812 * z815;
    const Scalar z817 = z813 * z815;
    const Scalar z818 = z809 - z812 * z816;
    const Scalar z819 = z810 + z812 * z817;
    const Scalar z820 = z811 + z813 * z817;
    const Scalar z821 = n1 / z820;
    const Scalar z822 = z819 * z821;
    const Scalar z823 = z818 + z819 * z822;
    const Scalar z824 = n1 / z823;
    const Scalar z825 = z695 - z704 * z712;
    const Scalar z826 = z687 + z704 * z711 - z747 * z825;
    const Scalar z827 = z680 - z704 * z710 - z746 * z825 - z774 * z826;
    const Scalar z828 = z674 + z704 * z709 - z745 * z825 + z773 * z826 - z794 * z827;
    const Scalar z829 = z669 - z704 * z708 - z744 * z825 - z772 * z826 - z793 * z827 - z808 * z828;
    const Scalar z830 = z665 + z704 * z707 - z743 * z825 + z771 * z826 - z792 * z827 + z807 * z828 - z817 * z829;
    const Scalar z831 = z662 - z704 * z706 - z742 * z825 - z770 * z826 - z791 * z827 - z806 * z828 - z816 * z829 - z822
        * z830;
    const Scalar z832 = z824 * z831;
    const Scalar z833 = z821 * z830 + z822 * z832;
    const Scalar z834 = z815 * z829 - z816 * z832 + z817 * z833;
    const Scalar z835 = z805 * z828 + z806 * z832 + z807 * z833 + z808 * z834;
    const Scalar z836 = z790 * z827 - z791 * z832 + z792 * z833 - z793 * z834 + z794 * z835;
    const Scalar z837 = z769 * z826 + z770 * z832 + z771 * z833 + z772 * z834 + z773 * z835 + z774 * z836;
    const Scalar z838 = z741 * z825 - z742 * z832 + z743 * z833 - z744 * z834 + z745 * z835 - z746 * z836 + z747 * z837;
    const Scalar z839 = z704 * z705 + z706 * z832 + z707 * z833 + z708 * z834 + z709 * z835 + z710 * z836 + z711 * z837
        + z712 * z838;
    const Scalar z840 = z578 + z588 * z832 + z597 * z833 + z607 * z834 + z616 * z835 + z626 * z836 + z635 * z837 + z645
        * z838 + z654 * z839;
    const Scalar z841 = z579 - z589 * z832 + z598 * z833 - z608 * z834 + z617 * z835 - z627 * z836 + z636 * z837 - z646
        * z838 + z655 * z839;
    const Scalar z842 = z580 - z590 * z832 + z599 * z833 + z609 * z834 + z618 * z835 + z628 * z836 + z637 * z837 - z647
        * z838 + z656 * z839;
    const Scalar z843 = n1_over_3 * z833;
    const Scalar z844 = n1_over_3 * z835;
    const Scalar z845 = n1_over_3 * z837;
    const Scalar z846 = n1_over_3 * z839;
    const Scalar z847 = z581 + z591 * z832 - z600 * z833 - z610 * z834 - z619 * z835 - z629 * z836 - z638 * z837 - z648
        * z838 - z657 * z839;
    const Scalar z848 = z582 - z592 * z832 - z601 * z833 + z611 * z834 - z620 * z835 - z630 * z836 - z639 * z837 - z649
        * z838 - z658 * z839;
    const Scalar z849 = z583 - z593 * z832 - z602 * z833 - z612 * z834 - z621 * z835 + z631 * z836 - z640 * z837 - z650
        * z838 - z659 * z839;
    const Scalar z850 = z584 - z594 * z832 - z603 * z833 - z613 * z834 - z622 * z835 - z632 * z836 - z641 * z837 + z651
        * z838 - z660 * z839;
    accelerations.x = -z840;
    accelerations.y = z841;
    accelerations.psi = z842;
    accelerations.phi_1 = -z843;
    accelerations.phi_2 = -z844;
    accelerations.phi_3 = -z845;
    accelerations.phi_4 = -z846;
    accelerations.s_1 = z847;
    accelerations.s_2 = z848;
    accelerations.s_3 = z849;
    accelerations.s_4 = z850;
    multipliers.lambda_wheel_1_x = z832;
    multipliers.lambda_wheel_1_y = -z833;
    multipliers.lambda_wheel_2_x = z834;
    multipliers.lambda_wheel_2_y = -z835;
    multipliers.lambda_wheel_3_x = z836;
    multipliers.lambda_wheel_3_y = -z837;
    multipliers.lambda_wheel_4_x = z838;
    multipliers.lambda_wheel_4_y = -z839;
    if (!(traits::regular(-z573, n880) && traits::regular(-z570, n880) && traits::regular(-z564, z337)
        && traits::regular(-z823, -z661) && traits::regular(z820, z664) && traits::regular(-z814, -z668)
        && traits::regular(z804, z673) && traits::regular(-z789, -z679) && traits::regular(z768, z686)
        && traits::regular(-z740, -z694) && traits::regular(z703, z703))) return torsor::Status::singular;
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
    const Scalar z485 = precomputed.z485;
    const Scalar z486 = precomputed.z486;
    const Scalar z494 = precomputed.z494;
    const Scalar z495 = precomputed.z495;
    const Scalar z503 = precomputed.z503;
    const Scalar z504 = precomputed.z504;
    const Scalar z512 = precomputed.z512;
    const Scalar z513 = precomputed.z513;
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
    const Scalar z487 = q_s_1 + z485;
    const Scalar z488 = v_x * z105 + v_y * z104 + v_psi * z486 + v_s_1;
    const Scalar z489 = v_psi * z104;
    const Scalar z490 = v_psi * z105;
    const Scalar z491 = v_x * z489 - v_y * z490;
    const Scalar z492 = v_x * z104 - v_y * z105 - v_psi * z487 - n0_3 * v_phi_1;
    const Scalar z493 = v_x * z490 + v_y * z489 - v_psi * v_s_1;
    const Scalar z496 = q_s_2 + z494;
    const Scalar z497 = v_x * z128 + v_y * z127 - v_psi * z495 + v_s_2;
    const Scalar z498 = v_psi * z127;
    const Scalar z499 = v_psi * z128;
    const Scalar z500 = v_x * z498 - v_y * z499;
    const Scalar z501 = v_x * z127 - v_y * z128 - v_psi * z496 - n0_3 * v_phi_2;
    const Scalar z502 = v_x * z499 + v_y * z498 - v_psi * v_s_2;
    const Scalar z505 = q_s_3 - z503;
    const Scalar z506 = v_x * z151 + v_y * z150 - v_psi * z504 + v_s_3;
    const Scalar z507 = v_psi * z150;
    const Scalar z508 = v_psi * z151;
    const Scalar z509 = v_x * z507 - v_y * z508;
    const Scalar z510 = v_x * z150 - v_y * z151 - v_psi * z505 - n0_3 * v_phi_3;
    const Scalar z511 = v_x * z508 + v_y * z507 - v_psi * v_s_3;
    const Scalar z514 = q_s_4 - z512;
    const Scalar z515 = v_x * z174 + v_y * z173 + v_psi * z513 + v_s_4;
    const Scalar z516 = v_psi * z173;
    const Scalar z517 = v_psi * z174;
    const Scalar z518 = v_x * z516 - v_y * z517;
    const Scalar z519 = v_x * z173 - v_y * z174 - v_psi * z514 - n0_3 * v_phi_4;
    const Scalar z520 = v_x * z517 + v_y * z516 - v_psi * v_s_4;
    result.value[0] = n0;
    result.rate[0] = z488;
    result.gamma[0] = -z491;
    result.value[1] = n0;
    result.rate[1] = -z492;
    result.gamma[1] = -z493;
    result.value[2] = n0;
    result.rate[2] = z497;
    result.gamma[2] = -z500;
    result.value[3] = n0;
    result.rate[3] = -z501;
    result.gamma[3] = -z502;
    result.value[4] = n0;
    result.rate[4] = z506;
    result.gamma[4] = -z509;
    result.value[5] = n0;
    result.rate[5] = -z510;
    result.gamma[5] = -z511;
    result.value[6] = n0;
    result.rate[6] = z515;
    result.gamma[6] = -z518;
    result.value[7] = n0;
    result.rate[7] = -z519;
    result.gamma[7] = -z520;
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
    result.jacobian[16] = z486;
    result.jacobian[17] = z487;
    result.jacobian[18] = -z495;
    result.jacobian[19] = z496;
    result.jacobian[20] = -z504;
    result.jacobian[21] = z505;
    result.jacobian[22] = z513;
    result.jacobian[23] = z514;
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
