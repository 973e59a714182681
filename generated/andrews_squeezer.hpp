// SPDX-License-Identifier: MIT
// andrews_squeezer: Andrews' squeezing mechanism: seven bodies, three loops
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               94              133          0             0                 10       0    247     247
//   mass_matrix               9                9          0             0                  3       0     24      24
//   bias                     20               39          1             1                  4       0     69      87
//   inverse_dynamics         73              104          1             1                  7       0    193     222
//   forward_dynamics        236              362         12             1                  7       0    625     661
//   energy                   29               50          0             1                  4       0     88      94
//   constraints              87              142          0             0                  7       0    243     249
//   linearisation           554              789         20             1                  7       0   1378    1495
//
// Not computed because this mechanism does not need it:
//   kinematics: of 315 results 201 vanish identically, 18 repeat another up to sign
//   mass_matrix: of 49 results 36 vanish identically, 3 repeat another up to sign
//   first_integrals: left out, 'motor' has no force function
//   constraints: of 60 results 20 vanish identically, 8 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 162 results 113 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   andrews_squeezer_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output andrews_squeezer.hpp
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

namespace andrews_squeezer {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "andrews_squeezer";
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

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k2 = traits::constant(0.00092, 0.00092f, "23/25000");
    const Scalar n0_0115 = traits::constant(0.0115, 0.0115f, "23/2000");
    const Scalar k4 = traits::constant(0.01874, 0.01874f, "937/50000");
    const Scalar k5 = traits::constant(0.01043, 0.01043f, "1043/100000");
    const Scalar k6 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k7 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k8 = traits::constant(0.00579, 0.00579f, "579/100000");
    const Scalar k9 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k10 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar k11 = traits::constant(0.00916, 0.00916f, "229/25000");
    const Scalar k12 = traits::constant(0.02308, 0.02308f, "577/25000");
    const Scalar k13 = traits::constant(0.01228, 0.01228f, "307/25000");
    const Scalar k14 = traits::constant(0.00449, 0.00449f, "449/100000");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
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
    const Scalar z57 = q_beta + q_Theta;
    const Scalar z78 = q_delta + q_Phi;
    const Scalar z99 = q_epsilon + q_Omega;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega, z57, z78, z99};
    Scalar sines_[10], cosines_[10];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z58 = sines_[7], z59 = cosines_[7];
    const Scalar z79 = sines_[8], z80 = cosines_[8];
    const Scalar z100 = sines_[9], z101 = cosines_[9];
    const Scalar z35 = n0_007 * v_beta;
    const Scalar z36 = s_Theta * z35;
    const Scalar z37 = c_Theta * z35;
    const Scalar z38 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z39 = n0_04 * v_delta;
    const Scalar z40 = s_Phi * z39;
    const Scalar z41 = c_Phi * z39;
    const Scalar z42 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z43 = n0_04 * v_epsilon;
    const Scalar z44 = c_Omega * z43;
    const Scalar z45 = s_Omega * z43;
    const Scalar z46 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z47 = k2 * c_beta;
    const Scalar z48 = k2 * s_beta;
    const Scalar z49 = k2 * v_beta;
    const Scalar z50 = s_beta * z49;
    const Scalar z51 = c_beta * z49;
    const Scalar z52 = n0_0115 * c_Theta;
    const Scalar z53 = n0_0115 * s_Theta;
    const Scalar z54 = n0_007 - z52;
    const Scalar z55 = s_beta * z53 + c_beta * z54;
    const Scalar z56 = s_beta * z54 - c_beta * z53;
    const Scalar z60 = z37 - n0_0115 * z38;
    const Scalar z61 = z36 * z59 - z58 * z60;
    const Scalar z62 = z36 * z58 + z59 * z60;
    const Scalar z63 = k4 * s_gamma + k5 * c_gamma;
    const Scalar z64 = k5 * s_gamma - k4 * c_gamma;
    const Scalar z65 = k6 - z63;
    const Scalar z66 = k7 + z64;
    const Scalar z67 = k4 * v_gamma;
    const Scalar z68 = k5 * v_gamma;
    const Scalar z69 = s_gamma * z68 - c_gamma * z67;
    const Scalar z70 = s_gamma * z67 + c_gamma * z68;
    const Scalar z71 = k8 * s_Phi;
    const Scalar z72 = k8 * c_Phi;
    const Scalar z73 = n0_04 + z71;
    const Scalar z74 = s_delta * z72 + c_delta * z73;
    const Scalar z75 = s_delta * z73 - c_delta * z72;
    const Scalar z76 = k9 - z74;
    const Scalar z77 = k10 - z75;
    const Scalar z81 = z40 + k8 * z42;
    const Scalar z82 = z41 * z79 - z80 * z81;
    const Scalar z83 = z41 * z80 + z79 * z81;
    const Scalar z84 = k11 * s_delta - k12 * c_delta;
    const Scalar z85 = k12 * s_delta + k11 * c_delta;
    const Scalar z86 = k9 + z84;
    const Scalar z87 = k10 - z85;
    const Scalar z88 = k11 * v_delta;
    const Scalar z89 = k12 * v_delta;
    const Scalar z90 = s_delta * z89 + c_delta * z88;
    const Scalar z91 = s_delta * z88 - c_delta * z89;
    const Scalar z92 = k8 * c_Omega;
    const Scalar z93 = k8 * s_Omega;
    const Scalar z94 = n0_04 - z93;
    const Scalar z95 = s_epsilon * z94 + c_epsilon * z92;
    const Scalar z96 = s_epsilon * z92 - c_epsilon * z94;
    const Scalar z97 = k9 - z95;
    const Scalar z98 = k10 - z96;
    const Scalar z102 = z45 - k8 * z46;
    const Scalar z103 = z44 * z101 + z100 * z102;
    const Scalar z104 = z44 * z100 - z101 * z102;
    const Scalar z105 = k13 * s_epsilon - k14 * c_epsilon;
    const Scalar z106 = k14 * s_epsilon + k13 * c_epsilon;
    const Scalar z107 = k9 - z105;
    const Scalar z108 = k10 + z106;
    const Scalar z109 = k13 * v_epsilon;
    const Scalar z110 = k14 * v_epsilon;
    const Scalar z111 = s_epsilon * z110 + c_epsilon * z109;
    const Scalar z112 = s_epsilon * z109 - c_epsilon * z110;
    const Scalar z113 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z114 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z115 = k6 - z113;
    const Scalar z116 = k7 + z114;
    const Scalar z117 = n0_018 * v_gamma;
    const Scalar z118 = n0_02 * v_gamma;
    const Scalar z119 = s_gamma * z118 - c_gamma * z117;
    const Scalar z120 = s_gamma * z117 + c_gamma * z118;
    const Scalar z121 = k6 - z115;
    const Scalar z122 = k7 - z116;
    const Scalar z123 = n0_028 * c_Theta;
    const Scalar z124 = n0_028 * s_Theta;
    const Scalar z125 = n0_007 - z123;
    const Scalar z126 = s_beta * z124 + c_beta * z125;
    const Scalar z127 = s_beta * z125 - c_beta * z124;
    const Scalar z128 = z37 - n0_028 * z38;
    const Scalar z129 = z36 * z59 - z58 * z128;
    const Scalar z130 = z36 * z58 + z59 * z128;
    const Scalar z131 = n0_007 * c_beta;
    const Scalar z132 = n0_007 * s_beta;
    const Scalar z133 = z126 - z131;
    const Scalar z134 = z127 - z132;
    const Scalar z135 = n0_035 * s_gamma;
    const Scalar z136 = n0_035 * c_gamma;
    const Scalar z137 = k6 - z135;
    const Scalar z138 = k7 - z136;
    const Scalar z139 = n0_035 * v_gamma;
    const Scalar z140 = c_gamma * z139;
    const Scalar z141 = s_gamma * z139;
    const Scalar z142 = k6 - z137;
    const Scalar z143 = k7 - z138;
    const Scalar z144 = n0_02 * s_Phi;
    const Scalar z145 = n0_02 * c_Phi;
    const Scalar z146 = n0_04 + z144;
    const Scalar z147 = s_delta * z145 + c_delta * z146;
    const Scalar z148 = s_delta * z146 - c_delta * z145;
    const Scalar z149 = k9 - z147;
    const Scalar z150 = k10 - z148;
    const Scalar z151 = z40 + n0_02 * z42;
    const Scalar z152 = z41 * z79 - z80 * z151;
    const Scalar z153 = z41 * z80 + z79 * z151;
    const Scalar z154 = k9 - z149;
    const Scalar z155 = k10 - z150;
    const Scalar z156 = n0_04 * c_delta;
    const Scalar z157 = n0_04 * s_delta;
    const Scalar z158 = k9 - z156;
    const Scalar z159 = k10 - z157;
    const Scalar z160 = z149 - z158;
    const Scalar z161 = z150 - z159;
    const Scalar z162 = n0_02 * c_Omega;
    const Scalar z163 = n0_02 * s_Omega;
    const Scalar z164 = n0_04 - z163;
    const Scalar z165 = s_epsilon * z164 + c_epsilon * z162;
    const Scalar z166 = s_epsilon * z162 - c_epsilon * z164;
    const Scalar z167 = k9 - z165;
    const Scalar z168 = k10 - z166;
    const Scalar z169 = z45 - n0_02 * z46;
    const Scalar z170 = z44 * z101 + z100 * z169;
    const Scalar z171 = z44 * z100 - z101 * z169;
    const Scalar z172 = k9 - z167;
    const Scalar z173 = k10 - z168;
    const Scalar z174 = n0_04 * s_epsilon;
    const Scalar z175 = n0_04 * c_epsilon;
    const Scalar z176 = k9 - z174;
    const Scalar z177 = k10 + z175;
    const Scalar z178 = z167 - z176;
    const Scalar z179 = z168 - z177;
    const Scalar z180 = s_beta * z35;
    const Scalar z181 = c_beta * z35;
    result.S1_position[0] = z47;
    result.S1_position[1] = z48;
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
    result.S1_velocity[0] = -z50;
    result.S1_velocity[1] = z51;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_beta;
    result.S2_position[0] = z55;
    result.S2_position[1] = z56;
    result.S2_position[2] = n0;
    result.S2_rotation[0] = z59;
    result.S2_rotation[1] = z58;
    result.S2_rotation[2] = n0;
    result.S2_rotation[3] = -z58;
    result.S2_rotation[4] = z59;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = n0;
    result.S2_rotation[7] = n0;
    result.S2_rotation[8] = n1;
    result.S2_velocity[0] = z61;
    result.S2_velocity[1] = z62;
    result.S2_velocity[2] = n0;
    result.S2_angular_velocity[0] = n0;
    result.S2_angular_velocity[1] = n0;
    result.S2_angular_velocity[2] = z38;
    result.S3_position[0] = -z65;
    result.S3_position[1] = z66;
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
    result.S3_velocity[0] = -z69;
    result.S3_velocity[1] = z70;
    result.S3_velocity[2] = n0;
    result.S3_angular_velocity[0] = n0;
    result.S3_angular_velocity[1] = n0;
    result.S3_angular_velocity[2] = v_gamma;
    result.S4_position[0] = -z76;
    result.S4_position[1] = -z77;
    result.S4_position[2] = n0;
    result.S4_rotation[0] = z80;
    result.S4_rotation[1] = z79;
    result.S4_rotation[2] = n0;
    result.S4_rotation[3] = -z79;
    result.S4_rotation[4] = z80;
    result.S4_rotation[5] = n0;
    result.S4_rotation[6] = n0;
    result.S4_rotation[7] = n0;
    result.S4_rotation[8] = n1;
    result.S4_velocity[0] = -z82;
    result.S4_velocity[1] = z83;
    result.S4_velocity[2] = n0;
    result.S4_angular_velocity[0] = n0;
    result.S4_angular_velocity[1] = n0;
    result.S4_angular_velocity[2] = z42;
    result.S5_position[0] = -z86;
    result.S5_position[1] = -z87;
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
    result.S5_velocity[0] = -z90;
    result.S5_velocity[1] = -z91;
    result.S5_velocity[2] = n0;
    result.S5_angular_velocity[0] = n0;
    result.S5_angular_velocity[1] = n0;
    result.S5_angular_velocity[2] = v_delta;
    result.S6_position[0] = -z97;
    result.S6_position[1] = -z98;
    result.S6_position[2] = n0;
    result.S6_rotation[0] = z101;
    result.S6_rotation[1] = z100;
    result.S6_rotation[2] = n0;
    result.S6_rotation[3] = -z100;
    result.S6_rotation[4] = z101;
    result.S6_rotation[5] = n0;
    result.S6_rotation[6] = n0;
    result.S6_rotation[7] = n0;
    result.S6_rotation[8] = n1;
    result.S6_velocity[0] = z103;
    result.S6_velocity[1] = z104;
    result.S6_velocity[2] = n0;
    result.S6_angular_velocity[0] = n0;
    result.S6_angular_velocity[1] = n0;
    result.S6_angular_velocity[2] = z46;
    result.S7_position[0] = -z107;
    result.S7_position[1] = -z108;
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
    result.S7_velocity[0] = z111;
    result.S7_velocity[1] = z112;
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
    result.D_position[0] = -z115;
    result.D_position[1] = z116;
    result.D_position[2] = n0;
    result.D_velocity[0] = -z119;
    result.D_velocity[1] = z120;
    result.D_velocity[2] = n0;
    result.D_jacobian[0] = n0;
    result.D_jacobian[3] = n0;
    result.D_jacobian[6] = z122;
    result.D_jacobian[9] = n0;
    result.D_jacobian[12] = n0;
    result.D_jacobian[15] = n0;
    result.D_jacobian[18] = n0;
    result.D_jacobian[1] = n0;
    result.D_jacobian[4] = n0;
    result.D_jacobian[7] = z121;
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
    result.E2_position[0] = z126;
    result.E2_position[1] = z127;
    result.E2_position[2] = n0;
    result.E2_velocity[0] = z129;
    result.E2_velocity[1] = z130;
    result.E2_velocity[2] = n0;
    result.E2_jacobian[0] = -z127;
    result.E2_jacobian[3] = -z134;
    result.E2_jacobian[6] = n0;
    result.E2_jacobian[9] = n0;
    result.E2_jacobian[12] = n0;
    result.E2_jacobian[15] = n0;
    result.E2_jacobian[18] = n0;
    result.E2_jacobian[1] = z126;
    result.E2_jacobian[4] = z133;
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
    result.E3_position[0] = -z137;
    result.E3_position[1] = z138;
    result.E3_position[2] = n0;
    result.E3_velocity[0] = z140;
    result.E3_velocity[1] = z141;
    result.E3_velocity[2] = n0;
    result.E3_jacobian[0] = n0;
    result.E3_jacobian[3] = n0;
    result.E3_jacobian[6] = z143;
    result.E3_jacobian[9] = n0;
    result.E3_jacobian[12] = n0;
    result.E3_jacobian[15] = n0;
    result.E3_jacobian[18] = n0;
    result.E3_jacobian[1] = n0;
    result.E3_jacobian[4] = n0;
    result.E3_jacobian[7] = z142;
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
    result.E4_position[0] = -z149;
    result.E4_position[1] = -z150;
    result.E4_position[2] = n0;
    result.E4_velocity[0] = -z152;
    result.E4_velocity[1] = z153;
    result.E4_velocity[2] = n0;
    result.E4_jacobian[0] = n0;
    result.E4_jacobian[3] = n0;
    result.E4_jacobian[6] = n0;
    result.E4_jacobian[9] = z161;
    result.E4_jacobian[12] = -z155;
    result.E4_jacobian[15] = n0;
    result.E4_jacobian[18] = n0;
    result.E4_jacobian[1] = n0;
    result.E4_jacobian[4] = n0;
    result.E4_jacobian[7] = n0;
    result.E4_jacobian[10] = -z160;
    result.E4_jacobian[13] = z154;
    result.E4_jacobian[16] = n0;
    result.E4_jacobian[19] = n0;
    result.E4_jacobian[2] = n0;
    result.E4_jacobian[5] = n0;
    result.E4_jacobian[8] = n0;
    result.E4_jacobian[11] = n0;
    result.E4_jacobian[14] = n0;
    result.E4_jacobian[17] = n0;
    result.E4_jacobian[20] = n0;
    result.E6_position[0] = -z167;
    result.E6_position[1] = -z168;
    result.E6_position[2] = n0;
    result.E6_velocity[0] = z170;
    result.E6_velocity[1] = z171;
    result.E6_velocity[2] = n0;
    result.E6_jacobian[0] = n0;
    result.E6_jacobian[3] = n0;
    result.E6_jacobian[6] = n0;
    result.E6_jacobian[9] = n0;
    result.E6_jacobian[12] = n0;
    result.E6_jacobian[15] = z179;
    result.E6_jacobian[18] = -z173;
    result.E6_jacobian[1] = n0;
    result.E6_jacobian[4] = n0;
    result.E6_jacobian[7] = n0;
    result.E6_jacobian[10] = n0;
    result.E6_jacobian[13] = n0;
    result.E6_jacobian[16] = -z178;
    result.E6_jacobian[19] = z172;
    result.E6_jacobian[2] = n0;
    result.E6_jacobian[5] = n0;
    result.E6_jacobian[8] = n0;
    result.E6_jacobian[11] = n0;
    result.E6_jacobian[14] = n0;
    result.E6_jacobian[17] = n0;
    result.E6_jacobian[20] = n0;
    result.F_position[0] = z131;
    result.F_position[1] = z132;
    result.F_position[2] = n0;
    result.F_velocity[0] = -z180;
    result.F_velocity[1] = z181;
    result.F_velocity[2] = n0;
    result.F_jacobian[0] = -z132;
    result.F_jacobian[3] = n0;
    result.F_jacobian[6] = n0;
    result.F_jacobian[9] = n0;
    result.F_jacobian[12] = n0;
    result.F_jacobian[15] = n0;
    result.F_jacobian[18] = n0;
    result.F_jacobian[1] = z131;
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
    const Scalar k0 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k1 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k4 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k5 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k6 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k7 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar k10 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k12 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_Theta = state.q.Theta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar q_Omega = state.q.Omega;
    const Scalar angles_[] = {q_Theta, q_Phi, q_Omega};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_Theta = cosines_[0];
    const Scalar s_Phi = sines_[1];
    const Scalar s_Omega = sines_[2];
    const Scalar z182 = k0 * s_Omega;
    const Scalar z184 = k1 - n0_04 * z182;
    const Scalar z191 = k1 - n0_08 * z182;
    const Scalar z196 = k4 + z191;
    const Scalar z198 = k0 * s_Phi;
    const Scalar z199 = k1 + n0_04 * z198;
    const Scalar z206 = k1 + n0_08 * z198;
    const Scalar z211 = k5 + z206;
    const Scalar z213 = k6 * c_Theta;
    const Scalar z214 = k7 - n0_007 * z213;
    const Scalar z221 = k7 - n0_014 * z213;
    const Scalar z224 = k10 + z221;
    mass[0] = z224;
    mass[1] = z214;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = z214;
    mass[8] = k7;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k12;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = k1;
    mass[25] = z199;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = z199;
    mass[32] = z211;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k1;
    mass[41] = z184;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = z184;
    mass[48] = z196;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k3 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k6 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k7 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k13 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k14 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
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
    const Scalar z38 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z42 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z46 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z113 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z114 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z115 = k2 - z113;
    const Scalar z116 = k3 + z114;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z227 = k6 * s_gamma + k7 * c_gamma;
    const Scalar z228 = k7 * s_gamma - k6 * c_gamma;
    const Scalar z229 = n0_02 - z227;
    const Scalar z230 = n0_018 - z228;
    const Scalar z231 = z225 * z225 + z226 * z226;
    const Scalar z232 = traits::sqrt(z231);
    const Scalar z233 = n1 / z232;
    const Scalar z234 = n4530 - n352_6605 * z233;
    const Scalar z236 = z229 * z234;
    const Scalar z237 = z230 * z234;
    const Scalar z238 = n0_018 * z236 - n0_02 * z237;
    const Scalar z239 = v_beta * v_beta;
    const Scalar z240 = n0_007 * z239;
    const Scalar z242 = s_Theta * z240;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z244 = n0_04 * z243;
    const Scalar z245 = c_Phi * z244;
    const Scalar z247 = v_epsilon * v_epsilon;
    const Scalar z248 = n0_04 * z247;
    const Scalar z250 = c_Omega * z248;
    const Scalar z251 = z46 * z46;
    const Scalar z252 = k13 * z251;  // force on K6, x
    const Scalar z253 = k13 * z250;  // moment on K6, z
    const Scalar z254 = c_Omega * z252;
    const Scalar z258 = z253 - n0_04 * z254;  // moment on K7, z
    const Scalar z259 = z42 * z42;
    const Scalar z260 = k13 * z259;  // force on K4, y
    const Scalar z261 = k13 * z245;  // moment on K4, z
    const Scalar z263 = c_Phi * z260;
    const Scalar z266 = z261 - n0_04 * z263;  // moment on K5, z
    const Scalar z270 = z38 * z38;
    const Scalar z271 = k14 * z270;  // force on K2, x
    const Scalar z272 = k14 * z242;  // moment on K2, z
    const Scalar z274 = s_Theta * z271;
    const Scalar z276 = n0_033 + z272 - n0_007 * z274;  // moment on K1, z
    forces.beta = -z276;
    forces.Theta = -z272;
    forces.gamma = z238;
    forces.Phi = -z261;
    forces.delta = -z266;
    forces.Omega = z253;
    forces.epsilon = z258;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k3 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k10 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k11 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k15 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k16 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k17 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k18 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k19 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k20 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar k21 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k23 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
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
    const Scalar z38 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z42 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z46 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z113 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z114 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z115 = k2 - z113;
    const Scalar z116 = k3 + z114;
    const Scalar z123 = n0_028 * c_Theta;
    const Scalar z124 = n0_028 * s_Theta;
    const Scalar z125 = n0_007 - z123;
    const Scalar z126 = s_beta * z124 + c_beta * z125;
    const Scalar z127 = s_beta * z125 - c_beta * z124;
    const Scalar z135 = n0_035 * s_gamma;
    const Scalar z136 = n0_035 * c_gamma;
    const Scalar z144 = n0_02 * s_Phi;
    const Scalar z145 = n0_02 * c_Phi;
    const Scalar z146 = n0_04 + z144;
    const Scalar z147 = s_delta * z145 + c_delta * z146;
    const Scalar z148 = s_delta * z146 - c_delta * z145;
    const Scalar z162 = n0_02 * c_Omega;
    const Scalar z163 = n0_02 * s_Omega;
    const Scalar z164 = n0_04 - z163;
    const Scalar z165 = s_epsilon * z164 + c_epsilon * z162;
    const Scalar z166 = s_epsilon * z162 - c_epsilon * z164;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z227 = k10 * s_gamma + k11 * c_gamma;
    const Scalar z228 = k11 * s_gamma - k10 * c_gamma;
    const Scalar z229 = n0_02 - z227;
    const Scalar z230 = n0_018 - z228;
    const Scalar z231 = z225 * z225 + z226 * z226;
    const Scalar z232 = traits::sqrt(z231);
    const Scalar z233 = n1 / z232;
    const Scalar z234 = n4530 - n352_6605 * z233;
    const Scalar z236 = z229 * z234;
    const Scalar z237 = z230 * z234;
    const Scalar z238 = n0_018 * z236 - n0_02 * z237;
    const Scalar z239 = v_beta * v_beta;
    const Scalar z240 = n0_007 * z239;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z244 = n0_04 * z243;
    const Scalar z247 = v_epsilon * v_epsilon;
    const Scalar z248 = n0_04 * z247;
    const Scalar z251 = z46 * z46;
    const Scalar z252 = k15 * z251;  // force on K6, x
    const Scalar z259 = z42 * z42;
    const Scalar z260 = k15 * z259;  // force on K4, y
    const Scalar z270 = z38 * z38;
    const Scalar z271 = k16 * z270;  // force on K2, x
    const Scalar z277 = n0_007 * a_beta;
    const Scalar z279 = s_Theta * z240 + c_Theta * z277;
    const Scalar z280 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z281 = n0_04 * a_delta;
    const Scalar z282 = s_Phi * z281 - c_Phi * z244;
    const Scalar z284 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z285 = n0_04 * a_epsilon;
    const Scalar z287 = s_Omega * z285 - c_Omega * z248;
    const Scalar z288 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z289 = k15 * z288;  // force on K6, y
    const Scalar z290 = k15 * z287 - k17 * z288;  // moment on K6, z
    const Scalar z291 = s_Omega * z289 + c_Omega * z252;
    const Scalar z295 = k18 * a_epsilon - z290 - n0_04 * z291;  // moment on K7, z
    const Scalar z296 = k15 * z284;  // force on K4, x
    const Scalar z297 = k15 * z282 + k17 * z284;  // moment on K4, z
    const Scalar z299 = s_Phi * z296 + c_Phi * z260;
    const Scalar z302 = k19 * a_delta + z297 + n0_04 * z299;  // moment on K5, z
    const Scalar z305 = k20 * a_gamma + z238;  // moment on K3, z
    const Scalar z306 = k16 * z280;  // force on K2, y
    const Scalar z307 = k16 * z279 - k21 * z280;  // moment on K2, z
    const Scalar z309 = s_Theta * z271 - c_Theta * z306;
    const Scalar z312 = n0_033 - k23 * a_beta + z307 - n0_007 * z309;  // moment on K1, z
    const Scalar z325 = s_beta * z123 + c_beta * z124;
    const Scalar z340 = s_beta * z124 - c_beta * z123;
    const Scalar z355 = s_delta * z144 - c_delta * z145;
    const Scalar z366 = s_delta * z145 + c_delta * z144;
    const Scalar z379 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z390 = s_epsilon * z163 - c_epsilon * z162;
    forces.beta = -z126 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z127 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z312;
    forces.Theta = -z325 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z340 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) - z307;
    forces.gamma = z135 * l_lambda_E3_y + z136 * l_lambda_E3_x + z305;
    forces.Phi = z297 - z355 * l_lambda_E4_x + z366 * l_lambda_E4_y;
    forces.delta = z147 * l_lambda_E4_y - z148 * l_lambda_E4_x + z302;
    forces.Omega = -z290 - z379 * l_lambda_E6_x - z390 * l_lambda_E6_y;
    forces.epsilon = z165 * l_lambda_E6_y - z166 * l_lambda_E6_x + z295;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k3 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k8 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k11 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k12 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k13 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k14 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar k16 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k18 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k19 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k25 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k26 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
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
    const Scalar z38 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z42 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z46 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z113 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z114 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z115 = k2 - z113;
    const Scalar z116 = k3 + z114;
    const Scalar z123 = n0_028 * c_Theta;
    const Scalar z124 = n0_028 * s_Theta;
    const Scalar z125 = n0_007 - z123;
    const Scalar z126 = s_beta * z124 + c_beta * z125;
    const Scalar z127 = s_beta * z125 - c_beta * z124;
    const Scalar z135 = n0_035 * s_gamma;
    const Scalar z136 = n0_035 * c_gamma;
    const Scalar z144 = n0_02 * s_Phi;
    const Scalar z145 = n0_02 * c_Phi;
    const Scalar z146 = n0_04 + z144;
    const Scalar z147 = s_delta * z145 + c_delta * z146;
    const Scalar z148 = s_delta * z146 - c_delta * z145;
    const Scalar z162 = n0_02 * c_Omega;
    const Scalar z163 = n0_02 * s_Omega;
    const Scalar z164 = n0_04 - z163;
    const Scalar z165 = s_epsilon * z164 + c_epsilon * z162;
    const Scalar z166 = s_epsilon * z162 - c_epsilon * z164;
    const Scalar z182 = k8 * s_Omega;
    const Scalar z184 = k9 - n0_04 * z182;
    const Scalar z191 = k9 - n0_08 * z182;
    const Scalar z196 = k11 + z191;
    const Scalar z198 = k8 * s_Phi;
    const Scalar z199 = k9 + n0_04 * z198;
    const Scalar z206 = k9 + n0_08 * z198;
    const Scalar z211 = k12 + z206;
    const Scalar z213 = k13 * c_Theta;
    const Scalar z214 = k14 - n0_007 * z213;
    const Scalar z221 = k14 - n0_014 * z213;
    const Scalar z224 = k16 + z221;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z227 = k18 * s_gamma + k19 * c_gamma;
    const Scalar z228 = k19 * s_gamma - k18 * c_gamma;
    const Scalar z229 = n0_02 - z227;
    const Scalar z230 = n0_018 - z228;
    const Scalar z231 = z225 * z225 + z226 * z226;
    const Scalar z232 = traits::sqrt(z231);
    const Scalar z233 = n1 / z232;
    const Scalar z234 = n4530 - n352_6605 * z233;
    const Scalar z236 = z229 * z234;
    const Scalar z237 = z230 * z234;
    const Scalar z238 = n0_018 * z236 - n0_02 * z237;
    const Scalar z239 = v_beta * v_beta;
    const Scalar z240 = n0_007 * z239;
    const Scalar z242 = s_Theta * z240;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z244 = n0_04 * z243;
    const Scalar z245 = c_Phi * z244;
    const Scalar z247 = v_epsilon * v_epsilon;
    const Scalar z248 = n0_04 * z247;
    const Scalar z250 = c_Omega * z248;
    const Scalar z251 = z46 * z46;
    const Scalar z252 = k8 * z251;  // force on K6, x
    const Scalar z253 = k8 * z250;  // moment on K6, z
    const Scalar z254 = c_Omega * z252;
    const Scalar z258 = z253 - n0_04 * z254;  // moment on K7, z
    const Scalar z259 = z42 * z42;
    const Scalar z260 = k8 * z259;  // force on K4, y
    const Scalar z261 = k8 * z245;  // moment on K4, z
    const Scalar z263 = c_Phi * z260;
    const Scalar z266 = z261 - n0_04 * z263;  // moment on K5, z
    const Scalar z270 = z38 * z38;
    const Scalar z271 = k13 * z270;  // force on K2, x
    const Scalar z272 = k13 * z242;  // moment on K2, z
    const Scalar z274 = s_Theta * z271;
    const Scalar z276 = n0_033 + z272 - n0_007 * z274;  // moment on K1, z
    const Scalar z315 = v_beta * c_beta;
    const Scalar z316 = v_Theta * c_Theta;
    const Scalar z317 = n0_028 * z316;
    const Scalar z318 = v_beta * s_beta;
    const Scalar z319 = v_Theta * s_Theta;
    const Scalar z320 = n0_028 * z319;
    const Scalar z322 = v_gamma * c_gamma;
    const Scalar z325 = s_beta * z123 + c_beta * z124;
    const Scalar z326 = v_Theta * z319;
    const Scalar z327 = n0_028 * z326;
    const Scalar z328 = v_Theta * z316;
    const Scalar z329 = n0_028 * z328;
    const Scalar z330 = v_beta * z318;
    const Scalar z331 = v_beta * z315;
    const Scalar z332 = -n2 * (z315 * z317 - z318 * z320) + s_beta * z327 - c_beta * z329 + z124 * z330 + z125 * z331;
    const Scalar z333 = v_gamma * s_gamma;
    const Scalar z334 = v_gamma * z333;
    const Scalar z335 = n0_035 * z334;
    const Scalar z336 = z332 - z335;
    const Scalar z340 = s_beta * z124 - c_beta * z123;
    const Scalar z341 = n2 * (z315 * z320 + z317 * z318) + s_beta * z329 + c_beta * z327 + z124 * z331 - z125 * z330;
    const Scalar z342 = v_gamma * z322;
    const Scalar z343 = n0_035 * z342;
    const Scalar z344 = z341 - z343;
    const Scalar z347 = v_delta * c_delta;
    const Scalar z348 = v_Phi * s_Phi;
    const Scalar z349 = n0_02 * z348;
    const Scalar z350 = v_delta * s_delta;
    const Scalar z351 = v_Phi * c_Phi;
    const Scalar z352 = n0_02 * z351;
    const Scalar z355 = s_delta * z144 - c_delta * z145;
    const Scalar z356 = v_Phi * z351;
    const Scalar z357 = n0_02 * z356;
    const Scalar z358 = v_Phi * z348;
    const Scalar z359 = n0_02 * z358;
    const Scalar z360 = v_delta * z350;
    const Scalar z361 = v_delta * z347;
    const Scalar z362 = n2 * (z347 * z349 + z350 * z352) + s_delta * z357 + c_delta * z359 + z145 * z360 + z146 * z361;
    const Scalar z363 = z332 - z362;
    const Scalar z366 = s_delta * z145 + c_delta * z144;
    const Scalar z367 = -n2 * (z347 * z352 - z349 * z350) + s_delta * z359 - c_delta * z357 - z145 * z361 + z146 * z360;
    const Scalar z368 = z341 + z367;
    const Scalar z371 = v_epsilon * c_epsilon;
    const Scalar z372 = v_Omega * c_Omega;
    const Scalar z373 = n0_02 * z372;
    const Scalar z374 = v_epsilon * s_epsilon;
    const Scalar z375 = v_Omega * s_Omega;
    const Scalar z376 = n0_02 * z375;
    const Scalar z379 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z380 = v_Omega * z375;
    const Scalar z381 = n0_02 * z380;
    const Scalar z382 = v_Omega * z372;
    const Scalar z383 = n0_02 * z382;
    const Scalar z384 = v_epsilon * z371;
    const Scalar z385 = v_epsilon * z374;
    const Scalar z386 = -n2 * (z371 * z373 - z374 * z376) + s_epsilon * z381 - c_epsilon * z383 - z162 * z384 - z164
        * z385;
    const Scalar z387 = z332 + z386;
    const Scalar z390 = s_epsilon * z163 - c_epsilon * z162;
    const Scalar z391 = n2 * (z371 * z376 + z373 * z374) + s_epsilon * z383 + c_epsilon * z381 + z162 * z385 - z164
        * z384;
    const Scalar z392 = z341 + z391;
    const Scalar z399 = n1 / z196;
    const Scalar z400 = z184 * z399;
    const Scalar z401 = k9 - z184 * z400;
    const Scalar z402 = n1 / z401;
    const Scalar z403 = n1 / z211;
    const Scalar z404 = z199 * z403;
    const Scalar z405 = k9 - z199 * z404;
    const Scalar z406 = n1 / z405;
    const Scalar z407 = k25 * z214;
    const Scalar z408 = z214 * z407 - z224;
    const Scalar z409 = n1 / z408;
    const Scalar z410 = z127 + z325 * z407;
    const Scalar z411 = z409 * z410;
    const Scalar z412 = k25 * z325 - z407 * z411;
    const Scalar z413 = k26 * z136;
    const Scalar z414 = z126 - z340 * z407;
    const Scalar z415 = z409 * z414;
    const Scalar z416 = k25 * z340 + z407 * z415;
    const Scalar z417 = k26 * z135;
    const Scalar z418 = z148 * z404 - z355;
    const Scalar z419 = z406 * z418;
    const Scalar z420 = z148 * z403 + z404 * z419;
    const Scalar z421 = z147 * z404 - z366;
    const Scalar z422 = z406 * z421;
    const Scalar z423 = z147 * z403 + z404 * z422;
    const Scalar z424 = z166 * z400 - z379;
    const Scalar z425 = z402 * z424;
    const Scalar z426 = z166 * z399 + z400 * z425;
    const Scalar z427 = z165 * z400 + z390;
    const Scalar z428 = z402 * z427;
    const Scalar z429 = z165 * z399 + z400 * z428;
    const Scalar z430 = z127 * z411 - z136 * z413 - z325 * z412;
    const Scalar z431 = z126 * z411 + z135 * z413 + z340 * z412;
    const Scalar z432 = z126 * z415 - z135 * z417 - z340 * z416;
    const Scalar z433 = z127 * z411 - z325 * z412;
    const Scalar z434 = z127 * z415 + z325 * z416;
    const Scalar z435 = z127 * z411 - z148 * z420 - z325 * z412 + z355 * z419;
    const Scalar z436 = z126 * z411 + z340 * z412;
    const Scalar z437 = z126 * z415 - z340 * z416;
    const Scalar z438 = z126 * z411 - z147 * z420 + z340 * z412 + z366 * z419;
    const Scalar z439 = z126 * z415 - z147 * z423 - z340 * z416 + z366 * z422;
    const Scalar z440 = z127 * z411 - z166 * z426 - z325 * z412 + z379 * z425;
    const Scalar z441 = z126 * z411 - z165 * z426 + z340 * z412 - z390 * z425;
    const Scalar z442 = z126 * z415 - z165 * z429 - z340 * z416 - z390 * z428;
    const Scalar z443 = n1 / z442;
    const Scalar z444 = z436 * z443;
    const Scalar z445 = z437 * z443;
    const Scalar z446 = z441 * z443;
    const Scalar z447 = z430 - z436 * z444;
    const Scalar z448 = z431 - z436 * z445;
    const Scalar z449 = z432 - z437 * z445;
    const Scalar z450 = z433 - z436 * z444;
    const Scalar z451 = z434 - z437 * z444;
    const Scalar z452 = z435 - z436 * z444;
    const Scalar z453 = z436 * (n1 - z445);
    const Scalar z454 = z437 * (n1 - z445);
    const Scalar z455 = z436 * z445 - z438;
    const Scalar z456 = z437 * z445 - z439;
    const Scalar z457 = z433 - z436 * z446;
    const Scalar z458 = z434 - z437 * z446;
    const Scalar z459 = z440 - z441 * z446;
    const Scalar z460 = n1 / z459;
    const Scalar z461 = z457 * z460;
    const Scalar z462 = z458 * z460;
    const Scalar z463 = z447 - z457 * z461;
    const Scalar z464 = z448 - z457 * z462;
    const Scalar z465 = z449 - z458 * z462;
    const Scalar z466 = z450 - z457 * z461;
    const Scalar z467 = z451 - z458 * z461;
    const Scalar z468 = z452 - z457 * z461;
    const Scalar z469 = z453 - z457 * z462;
    const Scalar z470 = z454 - z458 * z462;
    const Scalar z471 = z455 + z457 * z462;
    const Scalar z472 = z456 + z458 * z462;
    const Scalar z473 = n1 / z472;
    const Scalar z474 = z469 * z473;
    const Scalar z475 = z470 * z473;
    const Scalar z476 = z471 * z473;
    const Scalar z477 = z463 + z469 * z474;
    const Scalar z478 = z464 + z469 * z475;
    const Scalar z479 = z465 + z470 * z475;
    const Scalar z480 = z466 - z469 * z476;
    const Scalar z481 = z467 - z470 * z476;
    const Scalar z482 = z468 + z471 * z476;
    const Scalar z483 = n1 / z482;
    const Scalar z484 = z480 * z483;
    const Scalar z485 = z481 * z483;
    const Scalar z486 = z477 - z480 * z484;
    const Scalar z487 = z478 - z480 * z485;
    const Scalar z488 = z479 - z481 * z485;
    const Scalar z489 = n1 / z488;
    const Scalar z490 = z487 * z489;
    const Scalar z491 = z486 - z487 * z490;
    const Scalar z492 = n1 / z491;
    const Scalar z493 = z253 - z258 * z400;
    const Scalar z494 = z261 - z266 * z404;
    const Scalar z495 = z272 * z407 - z276;
    const Scalar z496 = z409 * z495;
    const Scalar z497 = k25 * z272 - z407 * z496;
    const Scalar z498 = k26 * z238;
    const Scalar z499 = z406 * z494;
    const Scalar z500 = z266 * z403 - z404 * z499;
    const Scalar z501 = z402 * z493;
    const Scalar z502 = z258 * z399 - z400 * z501;
    const Scalar z503 = z127 * z496 - z136 * z498 - z325 * z497 + z336;
    const Scalar z504 = z126 * z496 + z135 * z498 + z340 * z497 + z344;
    const Scalar z505 = z127 * z496 - z148 * z500 - z325 * z497 - z355 * z499 + z363;
    const Scalar z506 = z126 * z496 - z147 * z500 + z340 * z497 - z366 * z499 + z368;
    const Scalar z507 = z127 * z496 + z166 * z502 - z325 * z497 + z379 * z501 + z387;
    const Scalar z508 = z126 * z496 + z165 * z502 + z340 * z497 - z390 * z501 + z392;
    const Scalar z509 = z446 * z508 - z507;
    const Scalar z510 = z445 * z508 - z462 * z509 - z506;
    const Scalar z511 = z444 * z508 - z461 * z509 - z476 * z510 - z505;
    const Scalar z512 = z445 * z508 - z462 * z509 + z475 * z510 - z485 * z511 - z504;
    const Scalar z513 = z444 * z508 - z461 * z509 + z474 * z510 - z484 * z511 - z490 * z512 - z503;
    const Scalar z514 = z492 * z513;
    const Scalar z515 = z489 * z512 - z490 * z514;
    const Scalar z516 = z483 * z511 - z484 * z514 - z485 * z515;
    const Scalar z517 = z473 * z510 - z474 * z514 - z475 * z515 + z476 * z516;
    const Scalar z518 = -z461 * (z514 + z516) - z462 * (z515 - z517) + z460 * z509;
    const Scalar z519 = z444 * (z514 + z516) + z445 * (z515 - z517) + z443 * z508 + z446 * z518;
    const Scalar z520 = z411 * (z514 + z516 + z518) + z415 * (z515 - z517 - z519) + z496;
    const Scalar z521 = z412 * (z514 + z516 + z518) - z416 * (z515 - z517 - z519) + z497;
    const Scalar z522 = z413 * z514 - z417 * z515 + z498;
    const Scalar z523 = z419 * z516 - z422 * z517 - z499;
    const Scalar z524 = z420 * z516 - z423 * z517 + z500;
    const Scalar z525 = z425 * z518 - z428 * z519 + z501;
    const Scalar z526 = z426 * z518 - z429 * z519 - z502;
    accelerations.beta = z520;
    accelerations.Theta = z521;
    accelerations.gamma = -z522;
    accelerations.Phi = -z523;
    accelerations.delta = z524;
    accelerations.Omega = -z525;
    accelerations.epsilon = z526;
    multipliers.lambda_E3_x = z514;
    multipliers.lambda_E3_y = -z515;
    multipliers.lambda_E4_x = z516;
    multipliers.lambda_E4_y = z517;
    multipliers.lambda_E6_x = z518;
    multipliers.lambda_E6_y = z519;
    if (!(traits::regular(-z408, z224) && traits::regular(z405, k9) && traits::regular(z211, z211)
        && traits::regular(z401, k9) && traits::regular(z196, z196) && traits::regular(-z491, -z430)
        && traits::regular(-z488, -z432) && traits::regular(-z482, -z435) && traits::regular(z472, -z439)
        && traits::regular(-z459, -z440) && traits::regular(-z442, -z442))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.beta - accelerations.beta) + (accelerations.Theta - accelerations.Theta)
        + (accelerations.gamma - accelerations.gamma) + (accelerations.Phi - accelerations.Phi) + (accelerations.delta
        - accelerations.delta) + (accelerations.Omega - accelerations.Omega) + (accelerations.epsilon
        - accelerations.epsilon) + (multipliers.lambda_E3_x - multipliers.lambda_E3_x) + (multipliers.lambda_E3_y
        - multipliers.lambda_E3_y) + (multipliers.lambda_E4_x - multipliers.lambda_E4_x) + (multipliers.lambda_E4_y
        - multipliers.lambda_E4_y) + (multipliers.lambda_E6_x - multipliers.lambda_E6_x) + (multipliers.lambda_E6_y
        - multipliers.lambda_E6_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k4 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k5 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k8 = traits::constant(0.07785, 0.07785f, "1557/20000");
    const Scalar k9 = traits::constant(0.00365, 0.00365f, "73/20000");
    const Scalar k10 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k11 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar k12 = traits::constant(0.00706, 0.00706f, "353/50000");
    const Scalar k13 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k14 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k16 = traits::constant(0.00353, 0.00353f, "353/100000");
    const Scalar k17 = traits::constant(1.1153034e-06, 1.1153033e-06f, "5576517/5000000000000");
    const Scalar k18 = traits::constant(8.0850737125e-06, 8.085074e-06f, "646805897/80000000000000");
    const Scalar k19 = traits::constant(2.7579868e-05, 2.7579868e-05f, "6894967/250000000000");
    const Scalar k20 = traits::constant(1.4259649165e-05, 1.4259649e-05f, "2851929833/200000000000000");
    const Scalar k21 = traits::constant(0.001825, 0.001825f, "73/40000");
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
    const Scalar z35 = n0_007 * v_beta;
    const Scalar z36 = s_Theta * z35;
    const Scalar z37 = c_Theta * z35;
    const Scalar z38 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z39 = n0_04 * v_delta;
    const Scalar z40 = s_Phi * z39;
    const Scalar z41 = c_Phi * z39;
    const Scalar z42 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z43 = n0_04 * v_epsilon;
    const Scalar z44 = c_Omega * z43;
    const Scalar z45 = s_Omega * z43;
    const Scalar z46 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z113 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z114 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z115 = k4 - z113;
    const Scalar z116 = k5 + z114;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z231 = z225 * z225 + z226 * z226;
    const Scalar z232 = traits::sqrt(z231);
    const Scalar z235 = k8 - z232;
    const Scalar z527 = k9 * z37 - k10 * z38;
    const Scalar z528 = k10 * z37 - k11 * z38;
    const Scalar z529 = k12 * z40 + k13 * z42;
    const Scalar z530 = k13 * z40 + k14 * z42;
    const Scalar z531 = k12 * z45 - k13 * z46;
    const Scalar z532 = k13 * z45 - k14 * z46;
    result.kinetic = n0_5 * (z37 * z527 - z38 * z528 + z40 * z529 + z42 * z530 + z45 * z531 - z46 * z532) + k16 * (z41
        * z41 + z44 * z44) + k17 * v_beta * v_beta + k18 * v_gamma * v_gamma + k19 * v_delta * v_delta + k20 * v_epsilon
        * v_epsilon + k21 * z36 * z36;
    result.force_function = -n2265 * z235 * z235;
    result.power = n0_033 * v_beta;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k3 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k4 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
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
    const Scalar z123 = n0_028 * c_Theta;
    const Scalar z124 = n0_028 * s_Theta;
    const Scalar z125 = n0_007 - z123;
    const Scalar z126 = s_beta * z124 + c_beta * z125;
    const Scalar z127 = s_beta * z125 - c_beta * z124;
    const Scalar z135 = n0_035 * s_gamma;
    const Scalar z136 = n0_035 * c_gamma;
    const Scalar z137 = k3 - z135;
    const Scalar z138 = k4 - z136;
    const Scalar z144 = n0_02 * s_Phi;
    const Scalar z145 = n0_02 * c_Phi;
    const Scalar z146 = n0_04 + z144;
    const Scalar z147 = s_delta * z145 + c_delta * z146;
    const Scalar z148 = s_delta * z146 - c_delta * z145;
    const Scalar z149 = k7 - z147;
    const Scalar z150 = k8 - z148;
    const Scalar z162 = n0_02 * c_Omega;
    const Scalar z163 = n0_02 * s_Omega;
    const Scalar z164 = n0_04 - z163;
    const Scalar z165 = s_epsilon * z164 + c_epsilon * z162;
    const Scalar z166 = s_epsilon * z162 - c_epsilon * z164;
    const Scalar z167 = k7 - z165;
    const Scalar z168 = k8 - z166;
    const Scalar z313 = z126 + z137;
    const Scalar z314 = z127 - z138;
    const Scalar z315 = v_beta * c_beta;
    const Scalar z316 = v_Theta * c_Theta;
    const Scalar z317 = n0_028 * z316;
    const Scalar z318 = v_beta * s_beta;
    const Scalar z319 = v_Theta * s_Theta;
    const Scalar z320 = n0_028 * z319;
    const Scalar z321 = s_beta * z317 + c_beta * z320 + z124 * z315 - z125 * z318;
    const Scalar z322 = v_gamma * c_gamma;
    const Scalar z323 = n0_035 * z322;
    const Scalar z324 = z321 - z323;
    const Scalar z325 = s_beta * z123 + c_beta * z124;
    const Scalar z326 = v_Theta * z319;
    const Scalar z327 = n0_028 * z326;
    const Scalar z328 = v_Theta * z316;
    const Scalar z329 = n0_028 * z328;
    const Scalar z330 = v_beta * z318;
    const Scalar z331 = v_beta * z315;
    const Scalar z332 = -n2 * (z315 * z317 - z318 * z320) + s_beta * z327 - c_beta * z329 + z124 * z330 + z125 * z331;
    const Scalar z333 = v_gamma * s_gamma;
    const Scalar z334 = v_gamma * z333;
    const Scalar z335 = n0_035 * z334;
    const Scalar z336 = z332 - z335;
    const Scalar z337 = s_beta * z320 - c_beta * z317 + z124 * z318 + z125 * z315;
    const Scalar z338 = n0_035 * z333;
    const Scalar z339 = z337 - z338;
    const Scalar z340 = s_beta * z124 - c_beta * z123;
    const Scalar z341 = n2 * (z315 * z320 + z317 * z318) + s_beta * z329 + c_beta * z327 + z124 * z331 - z125 * z330;
    const Scalar z342 = v_gamma * z322;
    const Scalar z343 = n0_035 * z342;
    const Scalar z344 = z341 - z343;
    const Scalar z345 = z126 + z149;
    const Scalar z346 = z127 + z150;
    const Scalar z347 = v_delta * c_delta;
    const Scalar z348 = v_Phi * s_Phi;
    const Scalar z349 = n0_02 * z348;
    const Scalar z350 = v_delta * s_delta;
    const Scalar z351 = v_Phi * c_Phi;
    const Scalar z352 = n0_02 * z351;
    const Scalar z353 = s_delta * z349 - c_delta * z352 - z145 * z347 + z146 * z350;
    const Scalar z354 = z321 + z353;
    const Scalar z355 = s_delta * z144 - c_delta * z145;
    const Scalar z356 = v_Phi * z351;
    const Scalar z357 = n0_02 * z356;
    const Scalar z358 = v_Phi * z348;
    const Scalar z359 = n0_02 * z358;
    const Scalar z360 = v_delta * z350;
    const Scalar z361 = v_delta * z347;
    const Scalar z362 = n2 * (z347 * z349 + z350 * z352) + s_delta * z357 + c_delta * z359 + z145 * z360 + z146 * z361;
    const Scalar z363 = z332 - z362;
    const Scalar z364 = s_delta * z352 + c_delta * z349 + z145 * z350 + z146 * z347;
    const Scalar z365 = z337 - z364;
    const Scalar z366 = s_delta * z145 + c_delta * z144;
    const Scalar z367 = -n2 * (z347 * z352 - z349 * z350) + s_delta * z359 - c_delta * z357 - z145 * z361 + z146 * z360;
    const Scalar z368 = z341 + z367;
    const Scalar z369 = z126 + z167;
    const Scalar z370 = z127 + z168;
    const Scalar z371 = v_epsilon * c_epsilon;
    const Scalar z372 = v_Omega * c_Omega;
    const Scalar z373 = n0_02 * z372;
    const Scalar z374 = v_epsilon * s_epsilon;
    const Scalar z375 = v_Omega * s_Omega;
    const Scalar z376 = n0_02 * z375;
    const Scalar z377 = s_epsilon * z373 + c_epsilon * z376 + z162 * z374 - z164 * z371;
    const Scalar z378 = z321 + z377;
    const Scalar z379 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z380 = v_Omega * z375;
    const Scalar z381 = n0_02 * z380;
    const Scalar z382 = v_Omega * z372;
    const Scalar z383 = n0_02 * z382;
    const Scalar z384 = v_epsilon * z371;
    const Scalar z385 = v_epsilon * z374;
    const Scalar z386 = -n2 * (z371 * z373 - z374 * z376) + s_epsilon * z381 - c_epsilon * z383 - z162 * z384 - z164
        * z385;
    const Scalar z387 = z332 + z386;
    const Scalar z388 = s_epsilon * z376 - c_epsilon * z373 - z162 * z371 - z164 * z374;
    const Scalar z389 = z337 + z388;
    const Scalar z390 = s_epsilon * z163 - c_epsilon * z162;
    const Scalar z391 = n2 * (z371 * z376 + z373 * z374) + s_epsilon * z383 + c_epsilon * z381 + z162 * z385 - z164
        * z384;
    const Scalar z392 = z341 + z391;
    result.value[0] = z313;
    result.rate[0] = z324;
    result.gamma[0] = -z336;
    result.value[1] = z314;
    result.rate[1] = z339;
    result.gamma[1] = z344;
    result.value[2] = z345;
    result.rate[2] = z354;
    result.gamma[2] = -z363;
    result.value[3] = z346;
    result.rate[3] = z365;
    result.gamma[3] = z368;
    result.value[4] = z369;
    result.rate[4] = z378;
    result.gamma[4] = -z387;
    result.value[5] = z370;
    result.rate[5] = z389;
    result.gamma[5] = z392;
    result.jacobian[0] = -z127;
    result.jacobian[1] = z126;
    result.jacobian[2] = -z127;
    result.jacobian[3] = z126;
    result.jacobian[4] = -z127;
    result.jacobian[5] = z126;
    result.jacobian[6] = z325;
    result.jacobian[7] = z340;
    result.jacobian[8] = z325;
    result.jacobian[9] = z340;
    result.jacobian[10] = z325;
    result.jacobian[11] = z340;
    result.jacobian[12] = -z136;
    result.jacobian[13] = -z135;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z355;
    result.jacobian[21] = -z366;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = z148;
    result.jacobian[27] = -z147;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = z379;
    result.jacobian[35] = z390;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z166;
    result.jacobian[41] = -z165;
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
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k3 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k8 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k11 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k12 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k13 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k14 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar k16 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k18 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k19 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k23 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k27 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k28 = traits::constant(1244740.7431948162, 1244740.8f, "500000000000000/401690073");
    const Scalar k29 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
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
    const Scalar z38 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z42 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z46 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z113 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z114 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z115 = k2 - z113;
    const Scalar z116 = k3 + z114;
    const Scalar z123 = n0_028 * c_Theta;
    const Scalar z124 = n0_028 * s_Theta;
    const Scalar z125 = n0_007 - z123;
    const Scalar z126 = s_beta * z124 + c_beta * z125;
    const Scalar z127 = s_beta * z125 - c_beta * z124;
    const Scalar z135 = n0_035 * s_gamma;
    const Scalar z136 = n0_035 * c_gamma;
    const Scalar z144 = n0_02 * s_Phi;
    const Scalar z145 = n0_02 * c_Phi;
    const Scalar z146 = n0_04 + z144;
    const Scalar z147 = s_delta * z145 + c_delta * z146;
    const Scalar z148 = s_delta * z146 - c_delta * z145;
    const Scalar z162 = n0_02 * c_Omega;
    const Scalar z163 = n0_02 * s_Omega;
    const Scalar z164 = n0_04 - z163;
    const Scalar z165 = s_epsilon * z164 + c_epsilon * z162;
    const Scalar z166 = s_epsilon * z162 - c_epsilon * z164;
    const Scalar z182 = k8 * s_Omega;
    const Scalar z184 = k9 - n0_04 * z182;
    const Scalar z191 = k9 - n0_08 * z182;
    const Scalar z196 = k11 + z191;
    const Scalar z198 = k8 * s_Phi;
    const Scalar z199 = k9 + n0_04 * z198;
    const Scalar z206 = k9 + n0_08 * z198;
    const Scalar z211 = k12 + z206;
    const Scalar z213 = k13 * c_Theta;
    const Scalar z214 = k14 - n0_007 * z213;
    const Scalar z221 = k14 - n0_014 * z213;
    const Scalar z224 = k16 + z221;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z227 = k18 * s_gamma + k19 * c_gamma;
    const Scalar z228 = k19 * s_gamma - k18 * c_gamma;
    const Scalar z229 = n0_02 - z227;
    const Scalar z230 = n0_018 - z228;
    const Scalar z231 = z225 * z225 + z226 * z226;
    const Scalar z232 = traits::sqrt(z231);
    const Scalar z233 = n1 / z232;
    const Scalar z234 = n4530 - n352_6605 * z233;
    const Scalar z236 = z229 * z234;
    const Scalar z237 = z230 * z234;
    const Scalar z238 = n0_018 * z236 - n0_02 * z237;
    const Scalar z239 = v_beta * v_beta;
    const Scalar z240 = n0_007 * z239;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z244 = n0_04 * z243;
    const Scalar z247 = v_epsilon * v_epsilon;
    const Scalar z248 = n0_04 * z247;
    const Scalar z251 = z46 * z46;
    const Scalar z252 = k8 * z251;  // force on K6, x
    const Scalar z259 = z42 * z42;
    const Scalar z260 = k8 * z259;  // force on K4, y
    const Scalar z270 = z38 * z38;
    const Scalar z271 = k13 * z270;  // force on K2, x
    const Scalar z277 = n0_007 * a_beta;
    const Scalar z278 = s_Theta * z277 - c_Theta * z240;
    const Scalar z279 = s_Theta * z240 + c_Theta * z277;
    const Scalar z280 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z281 = n0_04 * a_delta;
    const Scalar z282 = s_Phi * z281 - c_Phi * z244;
    const Scalar z283 = s_Phi * z244 + c_Phi * z281;
    const Scalar z284 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z285 = n0_04 * a_epsilon;
    const Scalar z286 = s_Omega * z248 + c_Omega * z285;
    const Scalar z287 = s_Omega * z285 - c_Omega * z248;
    const Scalar z288 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z289 = k8 * z288;  // force on K6, y
    const Scalar z290 = k8 * z287 - k9 * z288;  // moment on K6, z
    const Scalar z291 = s_Omega * z289 + c_Omega * z252;
    const Scalar z292 = s_Omega * z252 - c_Omega * z289;
    const Scalar z295 = k11 * a_epsilon - z290 - n0_04 * z291;  // moment on K7, z
    const Scalar z296 = k8 * z284;  // force on K4, x
    const Scalar z297 = k8 * z282 + k9 * z284;  // moment on K4, z
    const Scalar z298 = s_Phi * z260 - c_Phi * z296;
    const Scalar z299 = s_Phi * z296 + c_Phi * z260;
    const Scalar z302 = k12 * a_delta + z297 + n0_04 * z299;  // moment on K5, z
    const Scalar z305 = k23 * a_gamma + z238;  // moment on K3, z
    const Scalar z306 = k13 * z280;  // force on K2, y
    const Scalar z307 = k13 * z279 - k14 * z280;  // moment on K2, z
    const Scalar z308 = s_Theta * z306 + c_Theta * z271;
    const Scalar z309 = s_Theta * z271 - c_Theta * z306;
    const Scalar z312 = n0_033 - k16 * a_beta + z307 - n0_007 * z309;  // moment on K1, z
    const Scalar z315 = v_beta * c_beta;
    const Scalar z316 = v_Theta * c_Theta;
    const Scalar z317 = n0_028 * z316;
    const Scalar z318 = v_beta * s_beta;
    const Scalar z319 = v_Theta * s_Theta;
    const Scalar z320 = n0_028 * z319;
    const Scalar z321 = s_beta * z317 + c_beta * z320 + z124 * z315 - z125 * z318;
    const Scalar z322 = v_gamma * c_gamma;
    const Scalar z323 = n0_035 * z322;
    const Scalar z325 = s_beta * z123 + c_beta * z124;
    const Scalar z326 = v_Theta * z319;
    const Scalar z327 = n0_028 * z326;
    const Scalar z328 = v_Theta * z316;
    const Scalar z329 = n0_028 * z328;
    const Scalar z330 = v_beta * z318;
    const Scalar z331 = v_beta * z315;
    const Scalar z332 = -n2 * (z315 * z317 - z318 * z320) + s_beta * z327 - c_beta * z329 + z124 * z330 + z125 * z331;
    const Scalar z333 = v_gamma * s_gamma;
    const Scalar z334 = v_gamma * z333;
    const Scalar z335 = n0_035 * z334;
    const Scalar z336 = z332 - z335;
    const Scalar z337 = s_beta * z320 - c_beta * z317 + z124 * z318 + z125 * z315;
    const Scalar z338 = n0_035 * z333;
    const Scalar z340 = s_beta * z124 - c_beta * z123;
    const Scalar z341 = n2 * (z315 * z320 + z317 * z318) + s_beta * z329 + c_beta * z327 + z124 * z331 - z125 * z330;
    const Scalar z342 = v_gamma * z322;
    const Scalar z343 = n0_035 * z342;
    const Scalar z344 = z341 - z343;
    const Scalar z347 = v_delta * c_delta;
    const Scalar z348 = v_Phi * s_Phi;
    const Scalar z349 = n0_02 * z348;
    const Scalar z350 = v_delta * s_delta;
    const Scalar z351 = v_Phi * c_Phi;
    const Scalar z352 = n0_02 * z351;
    const Scalar z353 = s_delta * z349 - c_delta * z352 - z145 * z347 + z146 * z350;
    const Scalar z355 = s_delta * z144 - c_delta * z145;
    const Scalar z356 = v_Phi * z351;
    const Scalar z357 = n0_02 * z356;
    const Scalar z358 = v_Phi * z348;
    const Scalar z359 = n0_02 * z358;
    const Scalar z360 = v_delta * z350;
    const Scalar z361 = v_delta * z347;
    const Scalar z362 = n2 * (z347 * z349 + z350 * z352) + s_delta * z357 + c_delta * z359 + z145 * z360 + z146 * z361;
    const Scalar z363 = z332 - z362;
    const Scalar z364 = s_delta * z352 + c_delta * z349 + z145 * z350 + z146 * z347;
    const Scalar z366 = s_delta * z145 + c_delta * z144;
    const Scalar z367 = -n2 * (z347 * z352 - z349 * z350) + s_delta * z359 - c_delta * z357 - z145 * z361 + z146 * z360;
    const Scalar z368 = z341 + z367;
    const Scalar z371 = v_epsilon * c_epsilon;
    const Scalar z372 = v_Omega * c_Omega;
    const Scalar z373 = n0_02 * z372;
    const Scalar z374 = v_epsilon * s_epsilon;
    const Scalar z375 = v_Omega * s_Omega;
    const Scalar z376 = n0_02 * z375;
    const Scalar z377 = s_epsilon * z373 + c_epsilon * z376 + z162 * z374 - z164 * z371;
    const Scalar z379 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z380 = v_Omega * z375;
    const Scalar z381 = n0_02 * z380;
    const Scalar z382 = v_Omega * z372;
    const Scalar z383 = n0_02 * z382;
    const Scalar z384 = v_epsilon * z371;
    const Scalar z385 = v_epsilon * z374;
    const Scalar z386 = -n2 * (z371 * z373 - z374 * z376) + s_epsilon * z381 - c_epsilon * z383 - z162 * z384 - z164
        * z385;
    const Scalar z387 = z332 + z386;
    const Scalar z388 = s_epsilon * z376 - c_epsilon * z373 - z162 * z371 - z164 * z374;
    const Scalar z390 = s_epsilon * z163 - c_epsilon * z162;
    const Scalar z391 = n2 * (z371 * z376 + z373 * z374) + s_epsilon * z383 + c_epsilon * z381 + z162 * z385 - z164
        * z384;
    const Scalar z392 = z341 + z391;
    const Scalar z578 = n2 * v_beta;
    const Scalar z579 = n0_007 * z578;
    const Scalar z580 = s_Theta * z579;
    const Scalar z581 = k13 * z580;
    const Scalar z582 = n2 * z38;
    const Scalar z583 = k13 * z582;
    const Scalar z584 = s_Theta * z583;
    const Scalar z585 = z581 - n0_007 * z584;
    const Scalar z586 = z126 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z127 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z587 = z325 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z340 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z588 = n0_007 * z584;
    const Scalar z589 = k13 * z278;
    const Scalar z590 = n0_007 * z308 + z589;
    const Scalar z591 = z325 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z340 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z590;
    const Scalar z592 = z325 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z340 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z589;
    const Scalar z593 = n2 * (z113 * z226 - z114 * z225);
    const Scalar z594 = n0_5 * z593 / z232;
    const Scalar z595 = z594 / (z232 * z232);
    const Scalar z596 = n352_6605 * z595;
    const Scalar z597 = z228 * z234 - z229 * z596;
    const Scalar z598 = z227 * z234 + z230 * z596;
    const Scalar z599 = n0_018 * z597 + n0_02 * z598;
    const Scalar z600 = z135 * l_lambda_E3_x - z136 * l_lambda_E3_y - z599;
    const Scalar z601 = k8 * z283;
    const Scalar z602 = z355 * l_lambda_E4_y + z366 * l_lambda_E4_x - z601;
    const Scalar z603 = n2 * z42;
    const Scalar z604 = k8 * z603;
    const Scalar z605 = c_Phi * z604;
    const Scalar z606 = n0_04 * z605;
    const Scalar z607 = n0_04 * z298 - z601;
    const Scalar z608 = z355 * l_lambda_E4_y + z366 * l_lambda_E4_x + z607;
    const Scalar z609 = n2 * v_delta;
    const Scalar z610 = n0_04 * z609;
    const Scalar z611 = c_Phi * z610;
    const Scalar z612 = k8 * z611;
    const Scalar z613 = z355 * l_lambda_E4_y + z366 * l_lambda_E4_x;
    const Scalar z614 = n0_04 * z605 - z612;
    const Scalar z615 = z147 * l_lambda_E4_x + z148 * l_lambda_E4_y;
    const Scalar z616 = k8 * z286;
    const Scalar z617 = z379 * l_lambda_E6_y - z390 * l_lambda_E6_x + z616;
    const Scalar z618 = n2 * z46;
    const Scalar z619 = k8 * z618;
    const Scalar z620 = c_Omega * z619;
    const Scalar z621 = n0_04 * z620;
    const Scalar z622 = n0_04 * z292 - z616;
    const Scalar z623 = z379 * l_lambda_E6_y - z390 * l_lambda_E6_x - z622;
    const Scalar z624 = n2 * v_epsilon;
    const Scalar z625 = n0_04 * z624;
    const Scalar z626 = c_Omega * z625;
    const Scalar z627 = k8 * z626;
    const Scalar z628 = z379 * l_lambda_E6_y - z390 * l_lambda_E6_x;
    const Scalar z629 = n0_04 * z620 - z627;
    const Scalar z630 = z165 * l_lambda_E6_x + z166 * l_lambda_E6_y;
    const Scalar z631 = a_beta * z127 - a_Theta * z325 - a_epsilon * z166 - a_Omega * z379 + z387;
    const Scalar z632 = a_beta * z127 - a_Theta * z325 - a_delta * z148 - a_Phi * z355 + z363;
    const Scalar z633 = a_beta * z127 - a_Theta * z325 + a_gamma * z136 + z336;
    const Scalar z634 = a_beta * z126 + a_Theta * z340 - a_gamma * z135 + z344;
    const Scalar z635 = a_beta * z126 + a_Theta * z340 - a_epsilon * z165 + a_Omega * z390 + z392;
    const Scalar z636 = a_beta * z126 + a_Theta * z340 - a_delta * z147 - a_Phi * z366 + z368;
    const Scalar z637 = v_beta * s_beta + z318;
    const Scalar z638 = v_beta * c_beta + z315;
    const Scalar z639 = n2 * (s_beta * z320 - c_beta * z317) + z124 * z637 + z125 * z638;
    const Scalar z640 = a_beta * z126 + a_Theta * z340 + z341;
    const Scalar z641 = n2 * (s_beta * z317 + c_beta * z320) + z124 * z638 - z125 * z637;
    const Scalar z642 = a_beta * z127 - a_Theta * z325 + z332;
    const Scalar z643 = s_beta * z320 - c_beta * z317 - z123 * z315 + z124 * z318;
    const Scalar z644 = v_Theta * s_Theta + z319;
    const Scalar z645 = n0_028 * z644;
    const Scalar z646 = v_Theta * c_Theta + z316;
    const Scalar z647 = n0_028 * z646;
    const Scalar z648 = -n2 * (z123 * z315 - z124 * z318) + s_beta * z645 - c_beta * z647;
    const Scalar z649 = n2 * (z315 * z320 + z317 * z318) + s_beta * z329 + c_beta * z327 + z123 * z330 + z124 * z331;
    const Scalar z650 = z340 * (a_beta + a_Theta) + z649;
    const Scalar z651 = s_beta * z317 + c_beta * z320 + z123 * z318 + z124 * z315;
    const Scalar z652 = n2 * (z123 * z318 + z124 * z315) + s_beta * z647 + c_beta * z645;
    const Scalar z653 = -n2 * (z315 * z317 - z318 * z320) + s_beta * z327 - c_beta * z329 - z123 * z331 + z124 * z330;
    const Scalar z654 = z325 * (a_beta + a_Theta) - z653;
    const Scalar z655 = v_gamma * s_gamma + z333;
    const Scalar z656 = n0_035 * z655;
    const Scalar z657 = a_gamma * z135 + z343;
    const Scalar z658 = v_gamma * c_gamma + z322;
    const Scalar z659 = n0_035 * z658;
    const Scalar z660 = a_gamma * z136 - z335;
    const Scalar z661 = s_delta * z352 + c_delta * z349 + z144 * z347 + z145 * z350;
    const Scalar z662 = v_Phi * c_Phi + z351;
    const Scalar z663 = n0_02 * z662;
    const Scalar z664 = v_Phi * s_Phi + z348;
    const Scalar z665 = n0_02 * z664;
    const Scalar z666 = n2 * (z144 * z347 + z145 * z350) + s_delta * z663 + c_delta * z665;
    const Scalar z667 = -n2 * (z347 * z352 - z349 * z350) + s_delta * z359 - c_delta * z357 + z144 * z360 - z145 * z361;
    const Scalar z668 = z366 * (a_delta + a_Phi) - z667;
    const Scalar z669 = s_delta * z349 - c_delta * z352 + z144 * z350 - z145 * z347;
    const Scalar z670 = n2 * (z144 * z350 - z145 * z347) + s_delta * z665 - c_delta * z663;
    const Scalar z671 = n2 * (z347 * z349 + z350 * z352) + s_delta * z357 + c_delta * z359 + z144 * z361 + z145 * z360;
    const Scalar z672 = z355 * (a_delta + a_Phi) + z671;
    const Scalar z673 = v_delta * s_delta + z350;
    const Scalar z674 = v_delta * c_delta + z347;
    const Scalar z675 = n2 * (s_delta * z352 + c_delta * z349) + z145 * z673 + z146 * z674;
    const Scalar z676 = a_delta * z147 + a_Phi * z366 - z367;
    const Scalar z677 = n2 * (s_delta * z349 - c_delta * z352) - z145 * z674 + z146 * z673;
    const Scalar z678 = a_delta * z148 + a_Phi * z355 + z362;
    const Scalar z679 = s_epsilon * z376 - c_epsilon * z373 - z162 * z371 + z163 * z374;
    const Scalar z680 = v_Omega * s_Omega + z375;
    const Scalar z681 = n0_02 * z680;
    const Scalar z682 = v_Omega * c_Omega + z372;
    const Scalar z683 = n0_02 * z682;
    const Scalar z684 = -n2 * (z162 * z371 - z163 * z374) + s_epsilon * z681 - c_epsilon * z683;
    const Scalar z685 = n2 * (z371 * z376 + z373 * z374) + s_epsilon * z383 + c_epsilon * z381 + z162 * z385 + z163
        * z384;
    const Scalar z686 = z390 * (a_epsilon + a_Omega) + z685;
    const Scalar z687 = s_epsilon * z373 + c_epsilon * z376 + z162 * z374 + z163 * z371;
    const Scalar z688 = n2 * (z162 * z374 + z163 * z371) + s_epsilon * z683 + c_epsilon * z681;
    const Scalar z689 = -n2 * (z371 * z373 - z374 * z376) + s_epsilon * z381 - c_epsilon * z383 - z162 * z384 + z163
        * z385;
    const Scalar z690 = z379 * (a_epsilon + a_Omega) - z689;
    const Scalar z691 = v_epsilon * c_epsilon + z371;
    const Scalar z692 = v_epsilon * s_epsilon + z374;
    const Scalar z693 = n2 * (s_epsilon * z376 - c_epsilon * z373) - z162 * z691 - z164 * z692;
    const Scalar z694 = a_epsilon * z165 - a_Omega * z390 - z391;
    const Scalar z695 = n2 * (s_epsilon * z373 + c_epsilon * z376) + z162 * z692 - z164 * z691;
    const Scalar z696 = a_epsilon * z166 + a_Omega * z379 - z386;
    const Scalar z697 = n1 / z379;
    const Scalar z698 = z390 * z697;
    const Scalar z699 = z325 * z698 - z340;
    const Scalar z700 = z165 + z166 * z698;
    const Scalar z701 = n1 / z355;
    const Scalar z702 = z366 * z701;
    const Scalar z703 = z325 * z702 + z340;
    const Scalar z704 = z147 - z148 * z702;
    const Scalar z705 = n1 / z136;
    const Scalar z706 = z135 * z705;
    const Scalar z707 = z325 * z706 - z340;
    const Scalar z708 = n1 / z707;
    const Scalar z709 = z699 * z708;
    const Scalar z710 = z703 * z708;
    const Scalar z711 = n1 / z700;
    const Scalar z712 = n1 / z704;
    const Scalar z713 = z379 * z379;
    const Scalar z714 = z127 * z127 / z224 + z166 * z166 / z196 + k27 * z325 * z325 + k28 * z379 * z379;
    const Scalar z715 = k9 * z714;
    const Scalar z716 = z355 * z355;
    const Scalar z717 = z127 * z127 / z224 + z148 * z148 / z211 + k27 * z325 * z325 + k28 * z355 * z355;
    const Scalar z718 = k9 * z717;
    const Scalar z719 = z136 * z136;
    const Scalar z720 = z127 * z127 / z224 + k29 * z136 * z136 + k27 * z325 * z325;
    const Scalar z721 = k23 * z720;
    const Scalar z722 = z707 * z707;
    const Scalar z723 = z126 * z126 / z224 + k29 * z135 * z135 + k27 * z340 * z340;
    const Scalar z724 = k14 * z723;
    const Scalar z725 = z700 * z700;
    const Scalar z726 = z126 * z126 / z224 + z165 * z165 / z196 + k27 * z340 * z340 + k28 * z390 * z390;
    const Scalar z727 = z196 * z726;
    const Scalar z728 = z704 * z704;
    const Scalar z729 = z126 * z126 / z224 + z147 * z147 / z211 + k27 * z340 * z340 + k28 * z366 * z366;
    const Scalar z730 = z211 * z729;
    const Scalar z731 = z126 + z127 * z706;
    const Scalar z732 = z126 + z127 * z698 - z709 * z731;
    const Scalar z733 = z126 - z127 * z702 + z710 * z731;
    const Scalar z734 = z712 * z733;
    const Scalar z735 = z711 * z732;
    const Scalar z736 = z708 * z731;
    const Scalar z737 = z127 - z325 * z736;
    const Scalar z738 = z705 * z737;
    const Scalar z739 = z127 - z148 * z734 - z325 * z736;
    const Scalar z740 = z701 * z739;
    const Scalar z741 = z127 - z166 * z735 - z325 * z736;
    const Scalar z742 = z697 * z741;
    const Scalar z743 = z337 + z338 * z738 + z643 * z736;
    const Scalar z744 = z321 + z323 * z738 + z651 * z736;
    const Scalar z745 = z337 - z364 * z734 + z643 * z736 - z661 * z740;
    const Scalar z746 = z321 + z353 * z734 + z651 * z736 + z669 * z740;
    const Scalar z747 = z337 + z388 * z735 + z643 * z736 + z679 * z742;
    const Scalar z748 = z321 + z377 * z735 + z651 * z736 + z687 * z742;
    const Scalar z749 = z706 * z743 + z744;
    const Scalar z750 = z698 * z747 - z709 * z749 + z748;
    const Scalar z751 = z702 * z745 - z710 * z749 - z746;
    const Scalar z752 = z712 * z751;
    const Scalar z753 = z711 * z750;
    const Scalar z754 = z708 * z749;
    const Scalar z755 = z325 * z754 - z743;
    const Scalar z756 = z705 * z755;
    const Scalar z757 = z148 * z752 - z325 * z754 + z745;
    const Scalar z758 = z701 * z757;
    const Scalar z759 = z166 * z753 + z325 * z754 - z747;
    const Scalar z760 = z697 * z759;
    const Scalar z761 = z639 + z648 * z736 + z656 * z738;
    const Scalar z762 = z641 + z652 * z736 + z659 * z738;
    const Scalar z763 = z639 + z648 * z736 - z666 * z740 - z675 * z734;
    const Scalar z764 = z641 + z652 * z736 + z670 * z740 + z677 * z734;
    const Scalar z765 = z639 + z648 * z736 + z684 * z742 + z693 * z735;
    const Scalar z766 = z641 + z652 * z736 + z688 * z742 + z695 * z735;
    const Scalar z767 = z706 * z761 + z762;
    const Scalar z768 = z698 * z765 - z709 * z767 + z766;
    const Scalar z769 = z702 * z763 - z710 * z767 - z764;
    const Scalar z770 = z712 * z769;
    const Scalar z771 = z711 * z768;
    const Scalar z772 = z708 * z767;
    const Scalar z773 = z325 * z772 - z761;
    const Scalar z774 = z705 * z773;
    const Scalar z775 = z148 * z770 - z325 * z772 + z763;
    const Scalar z776 = z701 * z775;
    const Scalar z777 = z166 * z771 + z325 * z772 - z765;
    const Scalar z778 = z697 * z777;
    const Scalar z779 = z648 * z754 - z656 * z756;
    const Scalar z780 = z652 * z754 - z659 * z756;
    const Scalar z781 = z648 * z754 - z666 * z758 + z675 * z752;
    const Scalar z782 = z652 * z754 + z670 * z758 - z677 * z752;
    const Scalar z783 = z648 * z754 - z684 * z760 + z693 * z753;
    const Scalar z784 = z652 * z754 - z688 * z760 + z695 * z753;
    const Scalar z785 = z640 + z650 * z736 + z657 * z738;
    const Scalar z786 = z642 - z654 * z736 - z660 * z738;
    const Scalar z787 = z640 + z650 * z736 - z668 * z740 - z676 * z734;
    const Scalar z788 = z642 - z654 * z736 - z672 * z740 - z678 * z734;
    const Scalar z789 = z640 + z650 * z736 + z686 * z742 - z694 * z735;
    const Scalar z790 = z642 - z654 * z736 - z690 * z742 - z696 * z735;
    const Scalar z791 = z779 + z785;
    const Scalar z792 = z780 - z786;
    const Scalar z793 = z781 + z787;
    const Scalar z794 = z782 - z788;
    const Scalar z795 = z783 + z789;
    const Scalar z796 = z784 - z790;
    const Scalar z797 = z706 * z791 + z792;
    const Scalar z798 = z698 * z795 - z709 * z797 + z796;
    const Scalar z799 = z702 * z793 - z710 * z797 - z794;
    const Scalar z800 = z712 * z799;
    const Scalar z801 = z711 * z798;
    const Scalar z802 = z708 * z797;
    const Scalar z803 = z325 * z802 - z791;
    const Scalar z804 = z705 * z803;
    const Scalar z805 = z148 * z800 - z325 * z802 + z793;
    const Scalar z806 = z701 * z805;
    const Scalar z807 = z166 * z801 + z325 * z802 - z795;
    const Scalar z808 = z697 * z807;
    const Scalar z809 = z633 * z706 + z634;
    const Scalar z810 = z631 * z698 + z635 - z709 * z809;
    const Scalar z811 = z632 * z702 - z636 - z710 * z809;
    const Scalar z812 = z712 * z811;
    const Scalar z813 = z711 * z810;
    const Scalar z814 = z708 * z809;
    const Scalar z815 = z325 * z814 - z633;
    const Scalar z816 = z705 * z815;
    const Scalar z817 = z148 * z812 - z325 * z814 + z632;
    const Scalar z818 = z701 * z817;
    const Scalar z819 = z166 * z813 + z325 * z814 - z631;
    const Scalar z820 = z697 * z819;
    const Scalar z821 = z214 * z736 + z224;
    const Scalar z822 = z214 + k14 * z736;
    const Scalar z823 = k23 * z738;
    const Scalar z824 = z199 * z734 + k9 * z740;
    const Scalar z825 = z199 * z740 + z211 * z734;
    const Scalar z826 = z184 * z735 + k9 * z742;
    const Scalar z827 = z184 * z742 + z196 * z735;
    const Scalar z828 = z734 * z825 + z735 * z827 + z736 * z822 + z738 * z823 + z740 * z824 + z742 * z826 + z821;
    const Scalar z829 = z770 * z825 - z771 * z827 - z772 * z822 + z774 * z823 - z776 * z824 + z778 * z826;
    const Scalar z830 = z585 - z588 * z736;
    const Scalar z831 = z612 * z734;
    const Scalar z832 = z606 * z740 + z614 * z734;
    const Scalar z833 = z627 * z735;
    const Scalar z834 = z621 * z742 + z629 * z735;
    const Scalar z835 = z581 * z736 - z734 * z832 + z735 * z834 + z740 * z831 - z742 * z833 + z830;
    const Scalar z836 = z829 + z835;
    const Scalar z837 = z800 * z825 - z801 * z827 - z802 * z822 + z804 * z823 - z806 * z824 + z808 * z826;
    const Scalar z838 = z588 * z754;
    const Scalar z839 = z612 * z752;
    const Scalar z840 = z606 * z758 - z614 * z752;
    const Scalar z841 = z627 * z753;
    const Scalar z842 = z621 * z760 - z629 * z753;
    const Scalar z843 = z586 - z591 * z736;
    const Scalar z844 = z587 + z592 * z736;
    const Scalar z845 = z600 * z738;
    const Scalar z846 = z602 * z740 + z613 * z734;
    const Scalar z847 = z608 * z740 + z615 * z734;
    const Scalar z848 = z617 * z742 + z628 * z735;
    const Scalar z849 = z623 * z742 + z630 * z735;
    const Scalar z850 = z838 + z843;
    const Scalar z851 = z839 - z846;
    const Scalar z852 = z840 - z847;
    const Scalar z853 = z841 - z848;
    const Scalar z854 = z842 - z849;
    const Scalar z855 = z734 * z852 + z735 * z854 - z736 * z844 - z738 * z845 + z740 * z851 + z742 * z853 + z850;
    const Scalar z856 = z837 - z855;
    const Scalar z857 = z325 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z340 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) + z307;
    const Scalar z858 = z135 * l_lambda_E3_y + z136 * l_lambda_E3_x + z305;
    const Scalar z859 = z297 - z355 * l_lambda_E4_x + z366 * l_lambda_E4_y;
    const Scalar z860 = z147 * l_lambda_E4_y - z148 * l_lambda_E4_x + z302;
    const Scalar z861 = z290 + z379 * l_lambda_E6_x + z390 * l_lambda_E6_y;
    const Scalar z862 = z165 * l_lambda_E6_y - z166 * l_lambda_E6_x + z295;
    const Scalar z863 = z126 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z127 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) + z312 - z734 * z860 - z735 * z862 + z736 * z857 + z738 * z858 - z740 * z859 + z742 * z861;
    const Scalar z864 = z812 * z825 - z813 * z827 - z814 * z822 + z816 * z823 - z818 * z824 + z820 * z826;
    const Scalar z865 = z863 + z864;
    const Scalar z866 = n1 / z828;
    const Scalar z867 = z856 * z866;
    const Scalar z868 = z836 * z866;
    result.M[0] = z224;
    result.M[1] = z214;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = z214;
    result.M[8] = k14;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = n0;
    result.M[16] = k23;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = n0;
    result.M[23] = n0;
    result.M[24] = k9;
    result.M[25] = z199;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = n0;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = z199;
    result.M[32] = z211;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n0;
    result.M[36] = n0;
    result.M[37] = n0;
    result.M[38] = n0;
    result.M[39] = n0;
    result.M[40] = k9;
    result.M[41] = z184;
    result.M[42] = n0;
    result.M[43] = n0;
    result.M[44] = n0;
    result.M[45] = n0;
    result.M[46] = n0;
    result.M[47] = z184;
    result.M[48] = z196;
    result.C[0] = -z585;
    result.C[1] = -z581;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z588;
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
    result.C[25] = z606;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z612;
    result.C[32] = z614;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z621;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z627;
    result.C[48] = -z629;
    result.K[0] = z586;
    result.K[1] = -z587;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z591;
    result.K[8] = -z592;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z600;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z602;
    result.K[25] = -z608;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z613;
    result.K[32] = -z615;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = -z617;
    result.K[41] = -z623;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = -z628;
    result.K[48] = -z630;
    result.F[0] = z126 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z127 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) + z312;
    result.F[1] = z325 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z340 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) + z307;
    result.F[2] = -z135 * l_lambda_E3_y - z136 * l_lambda_E3_x - z305;
    result.F[3] = -z297 + z355 * l_lambda_E4_x - z366 * l_lambda_E4_y;
    result.F[4] = -z147 * l_lambda_E4_y + z148 * l_lambda_E4_x - z302;
    result.F[5] = z290 + z379 * l_lambda_E6_x + z390 * l_lambda_E6_y;
    result.F[6] = -z165 * l_lambda_E6_y + z166 * l_lambda_E6_x - z295;
    result.M_r[0] = z828;
    result.C_r[0] = -z836;
    result.K_r[0] = -z856;
    result.F_r[0] = z865;
    result.A[0] = n0;
    result.A[1] = z867;
    result.A[2] = n1;
    result.A[3] = z868;
    if (!(traits::regular(z713, z715) && traits::regular(z716, z718) && traits::regular(z719, z721)
        && traits::regular(z722, z724) && traits::regular(z725, z727) && traits::regular(z728, z730)
        && traits::regular(z828, z828))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[0] - result.M[0]) + (result.M[1] - result.M[1]) + (result.M[7] - result.M[7])
        + (result.M[25] - result.M[25]) + (result.M[31] - result.M[31]) + (result.M[32] - result.M[32]) + (result.M[41]
        - result.M[41]) + (result.M[47] - result.M[47]) + (result.M[48] - result.M[48]) + (result.C[0] - result.C[0])
        + (result.C[1] - result.C[1]) + (result.C[7] - result.C[7]) + (result.C[25] - result.C[25]) + (result.C[31]
        - result.C[31]) + (result.C[32] - result.C[32]) + (result.C[41] - result.C[41]) + (result.C[47] - result.C[47])
        + (result.C[48] - result.C[48]) + (result.K[0] - result.K[0]) + (result.K[1] - result.K[1]) + (result.K[7]
        - result.K[7]) + (result.K[8] - result.K[8]) + (result.K[16] - result.K[16]) + (result.K[24] - result.K[24])
        + (result.K[25] - result.K[25]) + (result.K[31] - result.K[31]) + (result.K[32] - result.K[32]) + (result.K[40]
        - result.K[40]) + (result.K[41] - result.K[41]) + (result.K[47] - result.K[47]) + (result.K[48] - result.K[48])
        + (result.F[0] - result.F[0]) + (result.F[1] - result.F[1]) + (result.F[2] - result.F[2]) + (result.F[3]
        - result.F[3]) + (result.F[4] - result.F[4]) + (result.F[5] - result.F[5]) + (result.F[6] - result.F[6])
        + (result.M_r[0] - result.M_r[0]) + (result.C_r[0] - result.C_r[0]) + (result.K_r[0] - result.K_r[0])
        + (result.F_r[0] - result.F_r[0]) + (result.A[1] - result.A[1]) + (result.A[3] - result.A[3]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace andrews_squeezer
