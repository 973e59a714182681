// SPDX-License-Identifier: MIT
// arm7: Arm with seven revolute joints
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              379              674          0             0                  7       0   1067    1067
//   mass_matrix             162              197          0             0                  6       0    371     395
//   bias                    271              307          0             0                  6       0    590     684
//   inverse_dynamics        291              316          0             0                  6       0    619     715
//   forward_dynamics        538              630          6             0                  6       0   1186    1304
//   energy                  221              307          0             0                  6       0    540     577
//   linearisation          3355             4068          6             0                  6       0   7441    8315
//
// Not computed because this mechanism does not need it:
//   kinematics: of 153 results 12 vanish identically, 21 repeat another up to sign
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

namespace arm7 {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "arm7";
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
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k4 = traits::constant(0.002081, 0.002081f, "2081/1000000");
    const Scalar k5 = traits::constant(0.003875, 0.003875f, "31/8000");
    const Scalar k6 = traits::constant(0.02872, 0.02872f, "359/12500");
    const Scalar k7 = traits::constant(0.003141, 0.003141f, "3141/1000000");
    const Scalar k8 = traits::constant(0.003495, 0.003495f, "699/200000");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar k10 = traits::constant(0.039252, 0.039252f, "9813/250000");
    const Scalar k11 = traits::constant(0.027518, 0.027518f, "13759/500000");
    const Scalar k12 = traits::constant(0.249498, 0.249498f, "124749/500000");
    const Scalar k13 = traits::constant(0.066502, 0.066502f, "33251/500000");
    const Scalar k14 = traits::constant(0.104419, 0.104419f, "104419/1000000");
    const Scalar k15 = traits::constant(0.05317, 0.05317f, "5317/100000");
    const Scalar k16 = traits::constant(0.027454, 0.027454f, "13727/500000");
    const Scalar k17 = traits::constant(0.041065, 0.041065f, "8213/200000");
    const Scalar k18 = traits::constant(0.011953, 0.011953f, "11953/1000000");
    const Scalar k19 = traits::constant(0.345563, 0.345563f, "345563/1000000");
    const Scalar k20 = traits::constant(0.038437, 0.038437f, "38437/1000000");
    const Scalar k21 = traits::constant(0.014117, 0.014117f, "14117/1000000");
    const Scalar k22 = traits::constant(0.060149, 0.060149f, "60149/1000000");
    const Scalar k23 = traits::constant(0.010517, 0.010517f, "10517/1000000");
    const Scalar k24 = traits::constant(0.004252, 0.004252f, "1063/250000");
    const Scalar k25 = traits::constant(0.061597, 0.061597f, "61597/1000000");
    const Scalar n0_107 = traits::constant(0.107, 0.107f, "107/1000");
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
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z37 = n0_316 * v_q2;
    const Scalar z38 = n0_316 * z35;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z41 = s_q3 * z38 + c_q3 * z37;
    const Scalar z42 = s_q3 * z37 - c_q3 * z38;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z44 = z42 - n0_0825 * z43;
    const Scalar z45 = n0_0825 * z40;
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z48 = s_q4 * z45 - c_q4 * z41;
    const Scalar z49 = s_q4 * z41 + c_q4 * z45;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z51 = z48 + n0_384 * z50;
    const Scalar z52 = z49 + n0_0825 * z50;
    const Scalar z53 = z44 + n0_384 * z46 - n0_0825 * z47;
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z56 = s_q5 * z53 + c_q5 * z51;
    const Scalar z57 = s_q5 * z51 - c_q5 * z53;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z61 = s_q6 * z52 + c_q6 * z56;
    const Scalar z62 = s_q6 * z56 - c_q6 * z52;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z64 = z62 + n0_088 * z63;
    const Scalar z65 = z57 + n0_088 * z60;
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z68 = s_q7 * z65 + c_q7 * z61;
    const Scalar z69 = s_q7 * z61 - c_q7 * z65;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z71 = k4 * s_q1 - k5 * c_q1;
    const Scalar z72 = k5 * s_q1 + k4 * c_q1;
    const Scalar z73 = k4 * v_q1;
    const Scalar z74 = k5 * v_q1;
    const Scalar z75 = s_q1 * z74 + c_q1 * z73;
    const Scalar z76 = s_q1 * z73 - c_q1 * z74;
    const Scalar z77 = k6 * s_q2 - k7 * c_q2;
    const Scalar z78 = k7 * s_q2 + k6 * c_q2;
    const Scalar z79 = k8 * s_q1 - c_q1 * z77;
    const Scalar z80 = s_q1 * z77 + k8 * c_q1;
    const Scalar z81 = n0_333 + z78;
    const Scalar z82 = c_q1 * c_q2;
    const Scalar z83 = s_q1 * c_q2;
    const Scalar z84 = c_q1 * s_q2;
    const Scalar z85 = s_q1 * s_q2;
    const Scalar z86 = k6 * v_q2 - k8 * z36;
    const Scalar z87 = k7 * v_q2 - k8 * z35;
    const Scalar z88 = k6 * z35 - k7 * z36;
    const Scalar z89 = s_q2 * z87 + c_q2 * z86;
    const Scalar z90 = s_q2 * z86 - c_q2 * z87;
    const Scalar z91 = s_q1 * z88 - c_q1 * z89;
    const Scalar z92 = s_q1 * z89 + c_q1 * z88;
    const Scalar z93 = s_q2 * z36 - c_q2 * z35;
    const Scalar z94 = s_q2 * z35 + c_q2 * z36;
    const Scalar z95 = s_q1 * v_q2 - c_q1 * z93;
    const Scalar z96 = s_q1 * z93 + c_q1 * v_q2;
    const Scalar z97 = k10 * s_q3 - k11 * c_q3;
    const Scalar z98 = k11 * s_q3 + k10 * c_q3;
    const Scalar z99 = k12 * s_q2 - c_q2 * z97;
    const Scalar z100 = s_q2 * z97 + k12 * c_q2;
    const Scalar z101 = s_q1 * z98 - c_q1 * z99;
    const Scalar z102 = s_q1 * z99 + c_q1 * z98;
    const Scalar z103 = n0_333 + z100;
    const Scalar z104 = c_q2 * c_q3;
    const Scalar z105 = s_q2 * c_q3;
    const Scalar z106 = s_q1 * s_q3 - c_q1 * z104;
    const Scalar z107 = s_q1 * z104 + c_q1 * s_q3;
    const Scalar z108 = c_q2 * s_q3;
    const Scalar z109 = s_q2 * s_q3;
    const Scalar z110 = s_q1 * c_q3 + c_q1 * z108;
    const Scalar z111 = s_q1 * z108 - c_q1 * c_q3;
    const Scalar z112 = k13 * z40 - z41 + k10 * z43;
    const Scalar z113 = k13 * z39 - z42 + k11 * z43;
    const Scalar z114 = k10 * z39 - k11 * z40;
    const Scalar z115 = s_q3 * z113 + c_q3 * z112;
    const Scalar z116 = s_q3 * z112 - c_q3 * z113;
    const Scalar z117 = s_q2 * z114 - c_q2 * z115;
    const Scalar z118 = s_q2 * z115 + c_q2 * z114;
    const Scalar z119 = s_q1 * z116 + c_q1 * z117;
    const Scalar z120 = s_q1 * z117 - c_q1 * z116;
    const Scalar z121 = s_q3 * z40 - c_q3 * z39;
    const Scalar z122 = s_q3 * z39 + c_q3 * z40;
    const Scalar z123 = s_q2 * z43 - c_q2 * z121;
    const Scalar z124 = s_q2 * z121 + c_q2 * z43;
    const Scalar z125 = s_q1 * z122 - c_q1 * z123;
    const Scalar z126 = s_q1 * z123 + c_q1 * z122;
    const Scalar z127 = k14 * s_q4 + k15 * c_q4;
    const Scalar z128 = k15 * s_q4 - k14 * c_q4;
    const Scalar z129 = n0_0825 - z127;
    const Scalar z130 = k16 * s_q3 + c_q3 * z129;
    const Scalar z131 = s_q3 * z129 - k16 * c_q3;
    const Scalar z132 = n0_316 - z128;
    const Scalar z133 = s_q2 * z132 + c_q2 * z130;
    const Scalar z134 = s_q2 * z130 - c_q2 * z132;
    const Scalar z135 = s_q1 * z131 - c_q1 * z133;
    const Scalar z136 = s_q1 * z133 + c_q1 * z131;
    const Scalar z137 = n0_333 - z134;
    const Scalar z138 = c_q3 * c_q4;
    const Scalar z139 = s_q3 * c_q4;
    const Scalar z140 = s_q2 * s_q4 + c_q2 * z138;
    const Scalar z141 = s_q2 * z138 - c_q2 * s_q4;
    const Scalar z142 = s_q1 * z139 - c_q1 * z140;
    const Scalar z143 = s_q1 * z140 + c_q1 * z139;
    const Scalar z144 = c_q3 * s_q4;
    const Scalar z145 = s_q3 * s_q4;
    const Scalar z146 = s_q2 * c_q4 - c_q2 * z144;
    const Scalar z147 = s_q2 * z144 + c_q2 * c_q4;
    const Scalar z148 = s_q1 * z145 + c_q1 * z146;
    const Scalar z149 = s_q1 * z146 - c_q1 * z145;
    const Scalar z150 = k16 * z47 + z48 + k14 * z50;
    const Scalar z151 = k16 * z46 + z49 + k15 * z50;
    const Scalar z152 = z44 + k14 * z46 - k15 * z47;
    const Scalar z153 = s_q4 * z151 - c_q4 * z150;
    const Scalar z154 = s_q4 * z150 + c_q4 * z151;
    const Scalar z155 = s_q3 * z152 + c_q3 * z153;
    const Scalar z156 = s_q3 * z153 - c_q3 * z152;
    const Scalar z157 = s_q2 * z154 - c_q2 * z155;
    const Scalar z158 = s_q2 * z155 + c_q2 * z154;
    const Scalar z159 = s_q1 * z156 + c_q1 * z157;
    const Scalar z160 = s_q1 * z157 - c_q1 * z156;
    const Scalar z161 = s_q4 * z47 + c_q4 * z46;
    const Scalar z162 = s_q4 * z46 - c_q4 * z47;
    const Scalar z163 = s_q3 * z50 + c_q3 * z161;
    const Scalar z164 = s_q3 * z161 - c_q3 * z50;
    const Scalar z165 = s_q2 * z162 + c_q2 * z163;
    const Scalar z166 = s_q2 * z163 - c_q2 * z162;
    const Scalar z167 = s_q1 * z164 - c_q1 * z165;
    const Scalar z168 = s_q1 * z165 + c_q1 * z164;
    const Scalar z169 = k17 * s_q5 + k18 * c_q5;
    const Scalar z170 = k18 * s_q5 - k17 * c_q5;
    const Scalar z171 = n0_0825 + z169;
    const Scalar z172 = k19 * s_q4 + c_q4 * z171;
    const Scalar z173 = s_q4 * z171 - k19 * c_q4;
    const Scalar z174 = n0_0825 - z172;
    const Scalar z175 = s_q3 * z170 + c_q3 * z174;
    const Scalar z176 = s_q3 * z174 - c_q3 * z170;
    const Scalar z177 = n0_316 - z173;
    const Scalar z178 = s_q2 * z177 + c_q2 * z175;
    const Scalar z179 = s_q2 * z175 - c_q2 * z177;
    const Scalar z180 = s_q1 * z176 - c_q1 * z178;
    const Scalar z181 = s_q1 * z178 + c_q1 * z176;
    const Scalar z182 = n0_333 - z179;
    const Scalar z183 = c_q4 * c_q5;
    const Scalar z184 = s_q4 * c_q5;
    const Scalar z185 = s_q3 * s_q5 - c_q3 * z183;
    const Scalar z186 = s_q3 * z183 + c_q3 * s_q5;
    const Scalar z187 = s_q2 * z184 - c_q2 * z185;
    const Scalar z188 = s_q2 * z185 + c_q2 * z184;
    const Scalar z189 = s_q1 * z186 - c_q1 * z187;
    const Scalar z190 = s_q1 * z187 + c_q1 * z186;
    const Scalar z191 = c_q4 * s_q5;
    const Scalar z192 = s_q4 * s_q5;
    const Scalar z193 = s_q3 * c_q5 + c_q3 * z191;
    const Scalar z194 = s_q3 * z191 - c_q3 * c_q5;
    const Scalar z195 = s_q2 * z192 + c_q2 * z193;
    const Scalar z196 = s_q2 * z193 - c_q2 * z192;
    const Scalar z197 = s_q1 * z194 - c_q1 * z195;
    const Scalar z198 = s_q1 * z195 + c_q1 * z194;
    const Scalar z199 = k20 * z55 - z56 - k17 * z58;
    const Scalar z200 = k20 * z54 - z57 + k18 * z58;
    const Scalar z201 = z52 + k17 * z54 + k18 * z55;
    const Scalar z202 = s_q5 * z200 + c_q5 * z199;
    const Scalar z203 = s_q5 * z199 - c_q5 * z200;
    const Scalar z204 = s_q4 * z201 + c_q4 * z202;
    const Scalar z205 = s_q4 * z202 - c_q4 * z201;
    const Scalar z206 = s_q3 * z203 - c_q3 * z204;
    const Scalar z207 = s_q3 * z204 + c_q3 * z203;
    const Scalar z208 = s_q2 * z205 - c_q2 * z206;
    const Scalar z209 = s_q2 * z206 + c_q2 * z205;
    const Scalar z210 = s_q1 * z207 - c_q1 * z208;
    const Scalar z211 = s_q1 * z208 + c_q1 * z207;
    const Scalar z212 = s_q5 * z55 - c_q5 * z54;
    const Scalar z213 = s_q5 * z54 + c_q5 * z55;
    const Scalar z214 = s_q4 * z58 - c_q4 * z212;
    const Scalar z215 = s_q4 * z212 + c_q4 * z58;
    const Scalar z216 = s_q3 * z213 - c_q3 * z214;
    const Scalar z217 = s_q3 * z214 + c_q3 * z213;
    const Scalar z218 = s_q2 * z215 + c_q2 * z216;
    const Scalar z219 = s_q2 * z216 - c_q2 * z215;
    const Scalar z220 = s_q1 * z217 + c_q1 * z218;
    const Scalar z221 = s_q1 * z218 - c_q1 * z217;
    const Scalar z222 = k21 * s_q6 + k22 * c_q6;
    const Scalar z223 = k22 * s_q6 - k21 * c_q6;
    const Scalar z224 = k23 * s_q5 - c_q5 * z222;
    const Scalar z225 = s_q5 * z222 + k23 * c_q5;
    const Scalar z226 = n0_0825 + z224;
    const Scalar z227 = n0_384 + z223;
    const Scalar z228 = s_q4 * z227 + c_q4 * z226;
    const Scalar z229 = s_q4 * z226 - c_q4 * z227;
    const Scalar z230 = n0_0825 - z228;
    const Scalar z231 = s_q3 * z225 - c_q3 * z230;
    const Scalar z232 = s_q3 * z230 + c_q3 * z225;
    const Scalar z233 = n0_316 - z229;
    const Scalar z234 = s_q2 * z233 - c_q2 * z231;
    const Scalar z235 = s_q2 * z231 + c_q2 * z233;
    const Scalar z236 = s_q1 * z232 - c_q1 * z234;
    const Scalar z237 = s_q1 * z234 + c_q1 * z232;
    const Scalar z238 = n0_333 + z235;
    const Scalar z239 = c_q5 * c_q6;
    const Scalar z240 = s_q5 * c_q6;
    const Scalar z241 = s_q4 * s_q6 - c_q4 * z239;
    const Scalar z242 = s_q4 * z239 + c_q4 * s_q6;
    const Scalar z243 = s_q3 * z240 + c_q3 * z241;
    const Scalar z244 = s_q3 * z241 - c_q3 * z240;
    const Scalar z245 = s_q2 * z242 - c_q2 * z243;
    const Scalar z246 = s_q2 * z243 + c_q2 * z242;
    const Scalar z247 = s_q1 * z244 + c_q1 * z245;
    const Scalar z248 = s_q1 * z245 - c_q1 * z244;
    const Scalar z249 = c_q5 * s_q6;
    const Scalar z250 = s_q5 * s_q6;
    const Scalar z251 = s_q4 * c_q6 + c_q4 * z249;
    const Scalar z252 = s_q4 * z249 - c_q4 * c_q6;
    const Scalar z253 = s_q3 * z250 - c_q3 * z251;
    const Scalar z254 = s_q3 * z251 + c_q3 * z250;
    const Scalar z255 = s_q2 * z252 - c_q2 * z253;
    const Scalar z256 = s_q2 * z253 + c_q2 * z252;
    const Scalar z257 = s_q1 * z254 - c_q1 * z255;
    const Scalar z258 = s_q1 * z255 + c_q1 * z254;
    const Scalar z259 = k23 * z60 + z61 - k21 * z63;
    const Scalar z260 = k23 * z59 + z62 + k22 * z63;
    const Scalar z261 = z57 + k21 * z59 + k22 * z60;
    const Scalar z262 = s_q6 * z260 + c_q6 * z259;
    const Scalar z263 = s_q6 * z259 - c_q6 * z260;
    const Scalar z264 = s_q5 * z261 + c_q5 * z262;
    const Scalar z265 = s_q5 * z262 - c_q5 * z261;
    const Scalar z266 = s_q4 * z263 - c_q4 * z264;
    const Scalar z267 = s_q4 * z264 + c_q4 * z263;
    const Scalar z268 = s_q3 * z265 + c_q3 * z266;
    const Scalar z269 = s_q3 * z266 - c_q3 * z265;
    const Scalar z270 = s_q2 * z267 - c_q2 * z268;
    const Scalar z271 = s_q2 * z268 + c_q2 * z267;
    const Scalar z272 = s_q1 * z269 + c_q1 * z270;
    const Scalar z273 = s_q1 * z270 - c_q1 * z269;
    const Scalar z274 = s_q6 * z60 - c_q6 * z59;
    const Scalar z275 = s_q6 * z59 + c_q6 * z60;
    const Scalar z276 = s_q5 * z63 - c_q5 * z274;
    const Scalar z277 = s_q5 * z274 + c_q5 * z63;
    const Scalar z278 = s_q4 * z275 - c_q4 * z276;
    const Scalar z279 = s_q4 * z276 + c_q4 * z275;
    const Scalar z280 = s_q3 * z277 - c_q3 * z278;
    const Scalar z281 = s_q3 * z278 + c_q3 * z277;
    const Scalar z282 = s_q2 * z279 + c_q2 * z280;
    const Scalar z283 = s_q2 * z280 - c_q2 * z279;
    const Scalar z284 = s_q1 * z281 + c_q1 * z282;
    const Scalar z285 = s_q1 * z282 - c_q1 * z281;
    const Scalar z286 = k24 * s_q7 + k23 * c_q7;
    const Scalar z287 = k23 * s_q7 - k24 * c_q7;
    const Scalar z288 = n0_088 + z286;
    const Scalar z289 = k25 * s_q6 + c_q6 * z288;
    const Scalar z290 = s_q6 * z288 - k25 * c_q6;
    const Scalar z291 = s_q5 * z287 + c_q5 * z289;
    const Scalar z292 = s_q5 * z289 - c_q5 * z287;
    const Scalar z293 = n0_0825 - z291;
    const Scalar z294 = n0_384 + z290;
    const Scalar z295 = s_q4 * z294 + c_q4 * z293;
    const Scalar z296 = s_q4 * z293 - c_q4 * z294;
    const Scalar z297 = n0_0825 - z295;
    const Scalar z298 = s_q3 * z292 - c_q3 * z297;
    const Scalar z299 = s_q3 * z297 + c_q3 * z292;
    const Scalar z300 = n0_316 - z296;
    const Scalar z301 = s_q2 * z300 - c_q2 * z298;
    const Scalar z302 = s_q2 * z298 + c_q2 * z300;
    const Scalar z303 = s_q1 * z299 - c_q1 * z301;
    const Scalar z304 = s_q1 * z301 + c_q1 * z299;
    const Scalar z305 = n0_333 + z302;
    const Scalar z306 = c_q6 * c_q7;
    const Scalar z307 = s_q6 * c_q7;
    const Scalar z308 = s_q5 * s_q7 + c_q5 * z306;
    const Scalar z309 = s_q5 * z306 - c_q5 * s_q7;
    const Scalar z310 = s_q4 * z307 - c_q4 * z308;
    const Scalar z311 = s_q4 * z308 + c_q4 * z307;
    const Scalar z312 = s_q3 * z309 + c_q3 * z310;
    const Scalar z313 = s_q3 * z310 - c_q3 * z309;
    const Scalar z314 = s_q2 * z311 - c_q2 * z312;
    const Scalar z315 = s_q2 * z312 + c_q2 * z311;
    const Scalar z316 = s_q1 * z313 + c_q1 * z314;
    const Scalar z317 = s_q1 * z314 - c_q1 * z313;
    const Scalar z318 = c_q6 * s_q7;
    const Scalar z319 = s_q6 * s_q7;
    const Scalar z320 = s_q5 * c_q7 - c_q5 * z318;
    const Scalar z321 = s_q5 * z318 + c_q5 * c_q7;
    const Scalar z322 = s_q4 * z319 + c_q4 * z320;
    const Scalar z323 = s_q4 * z320 - c_q4 * z319;
    const Scalar z324 = s_q3 * z321 + c_q3 * z322;
    const Scalar z325 = s_q3 * z322 - c_q3 * z321;
    const Scalar z326 = s_q2 * z323 + c_q2 * z324;
    const Scalar z327 = s_q2 * z324 - c_q2 * z323;
    const Scalar z328 = s_q1 * z325 - c_q1 * z326;
    const Scalar z329 = s_q1 * z326 + c_q1 * z325;
    const Scalar z330 = k25 * z67 + z68 - k24 * z70;
    const Scalar z331 = k25 * z66 - z69 - k23 * z70;
    const Scalar z332 = z64 + k24 * z66 - k23 * z67;
    const Scalar z333 = s_q7 * z331 - c_q7 * z330;
    const Scalar z334 = s_q7 * z330 + c_q7 * z331;
    const Scalar z335 = s_q6 * z332 - c_q6 * z333;
    const Scalar z336 = s_q6 * z333 + c_q6 * z332;
    const Scalar z337 = s_q5 * z334 + c_q5 * z335;
    const Scalar z338 = s_q5 * z335 - c_q5 * z334;
    const Scalar z339 = s_q4 * z336 + c_q4 * z337;
    const Scalar z340 = s_q4 * z337 - c_q4 * z336;
    const Scalar z341 = s_q3 * z338 - c_q3 * z339;
    const Scalar z342 = s_q3 * z339 + c_q3 * z338;
    const Scalar z343 = s_q2 * z340 - c_q2 * z341;
    const Scalar z344 = s_q2 * z341 + c_q2 * z340;
    const Scalar z345 = s_q1 * z342 - c_q1 * z343;
    const Scalar z346 = s_q1 * z343 + c_q1 * z342;
    const Scalar z347 = s_q7 * z67 + c_q7 * z66;
    const Scalar z348 = s_q7 * z66 - c_q7 * z67;
    const Scalar z349 = s_q6 * z70 + c_q6 * z347;
    const Scalar z350 = s_q6 * z347 - c_q6 * z70;
    const Scalar z351 = s_q5 * z348 + c_q5 * z349;
    const Scalar z352 = s_q5 * z349 - c_q5 * z348;
    const Scalar z353 = s_q4 * z350 - c_q4 * z351;
    const Scalar z354 = s_q4 * z351 + c_q4 * z350;
    const Scalar z355 = s_q3 * z352 + c_q3 * z353;
    const Scalar z356 = s_q3 * z353 - c_q3 * z352;
    const Scalar z357 = s_q2 * z354 - c_q2 * z355;
    const Scalar z358 = s_q2 * z355 + c_q2 * z354;
    const Scalar z359 = s_q1 * z356 + c_q1 * z357;
    const Scalar z360 = s_q1 * z357 - c_q1 * z356;
    const Scalar z361 = n0_107 * s_q6 + n0_088 * c_q6;
    const Scalar z362 = n0_088 * s_q6 - n0_107 * c_q6;
    const Scalar z363 = c_q5 * z361;
    const Scalar z364 = s_q5 * z361;
    const Scalar z365 = n0_0825 - z363;
    const Scalar z366 = n0_384 + z362;
    const Scalar z367 = s_q4 * z366 + c_q4 * z365;
    const Scalar z368 = s_q4 * z365 - c_q4 * z366;
    const Scalar z369 = n0_0825 - z367;
    const Scalar z370 = s_q3 * z364 - c_q3 * z369;
    const Scalar z371 = s_q3 * z369 + c_q3 * z364;
    const Scalar z372 = n0_316 - z368;
    const Scalar z373 = s_q2 * z372 - c_q2 * z370;
    const Scalar z374 = s_q2 * z370 + c_q2 * z372;
    const Scalar z375 = s_q1 * z371 - c_q1 * z373;
    const Scalar z376 = s_q1 * z373 + c_q1 * z371;
    const Scalar z377 = n0_333 + z374;
    const Scalar z378 = n0_107 * z67 + z68;
    const Scalar z379 = n0_107 * z66 - z69;
    const Scalar z380 = s_q7 * z379 - c_q7 * z378;
    const Scalar z381 = s_q7 * z378 + c_q7 * z379;
    const Scalar z382 = s_q6 * z64 - c_q6 * z380;
    const Scalar z383 = s_q6 * z380 + c_q6 * z64;
    const Scalar z384 = s_q5 * z381 + c_q5 * z382;
    const Scalar z385 = s_q5 * z382 - c_q5 * z381;
    const Scalar z386 = s_q4 * z383 + c_q4 * z384;
    const Scalar z387 = s_q4 * z384 - c_q4 * z383;
    const Scalar z388 = s_q3 * z385 - c_q3 * z386;
    const Scalar z389 = s_q3 * z386 + c_q3 * z385;
    const Scalar z390 = s_q2 * z387 - c_q2 * z388;
    const Scalar z391 = s_q2 * z388 + c_q2 * z387;
    const Scalar z392 = s_q1 * z389 - c_q1 * z390;
    const Scalar z393 = s_q1 * z390 + c_q1 * z389;
    const Scalar z394 = n0_333 - z377;
    const Scalar z395 = c_q1 * z394;
    const Scalar z396 = s_q1 * z394;
    const Scalar z397 = s_q1 * z376 - c_q1 * z375;
    const Scalar z398 = n0_316 * s_q2;
    const Scalar z399 = n0_316 * c_q2;
    const Scalar z400 = c_q1 * z398;
    const Scalar z401 = s_q1 * z398;
    const Scalar z402 = n0_333 + z399;
    const Scalar z403 = z375 + z400;
    const Scalar z404 = z376 - z401;
    const Scalar z405 = z377 - z402;
    const Scalar z406 = c_q2 * z404 - z85 * z405;
    const Scalar z407 = c_q2 * z403 + z84 * z405;
    const Scalar z408 = z84 * z404 + z85 * z403;
    const Scalar z409 = n0_0825 * c_q3;
    const Scalar z410 = n0_0825 * s_q3;
    const Scalar z411 = n0_316 * s_q2 + c_q2 * z409;
    const Scalar z412 = s_q2 * z409 - n0_316 * c_q2;
    const Scalar z413 = s_q1 * z410 - c_q1 * z411;
    const Scalar z414 = s_q1 * z411 + c_q1 * z410;
    const Scalar z415 = n0_333 - z412;
    const Scalar z416 = z375 - z413;
    const Scalar z417 = z376 - z414;
    const Scalar z418 = z377 - z415;
    const Scalar z419 = z109 * z417 + z111 * z418;
    const Scalar z420 = z109 * z416 - z110 * z418;
    const Scalar z421 = z110 * z417 + z111 * z416;
    const Scalar z422 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z423 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z424 = n0_0825 - z422;
    const Scalar z425 = c_q3 * z424;
    const Scalar z426 = s_q3 * z424;
    const Scalar z427 = n0_316 - z423;
    const Scalar z428 = s_q2 * z427 + c_q2 * z425;
    const Scalar z429 = s_q2 * z425 - c_q2 * z427;
    const Scalar z430 = s_q1 * z426 - c_q1 * z428;
    const Scalar z431 = s_q1 * z428 + c_q1 * z426;
    const Scalar z432 = n0_333 - z429;
    const Scalar z433 = z375 - z430;
    const Scalar z434 = z376 - z431;
    const Scalar z435 = z377 - z432;
    const Scalar z436 = z147 * z434 - z149 * z435;
    const Scalar z437 = z147 * z433 + z148 * z435;
    const Scalar z438 = z148 * z434 + z149 * z433;
    const Scalar z439 = z196 * z434 + z198 * z435;
    const Scalar z440 = z196 * z433 + z197 * z435;
    const Scalar z441 = z197 * z434 - z198 * z433;
    result.link1_position[0] = -z71;
    result.link1_position[1] = z72;
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
    result.link1_velocity[0] = -z75;
    result.link1_velocity[1] = -z76;
    result.link1_velocity[2] = n0;
    result.link1_angular_velocity[0] = n0;
    result.link1_angular_velocity[1] = n0;
    result.link1_angular_velocity[2] = v_q1;
    result.link2_position[0] = -z79;
    result.link2_position[1] = z80;
    result.link2_position[2] = z81;
    result.link2_rotation[0] = z82;
    result.link2_rotation[1] = z83;
    result.link2_rotation[2] = -s_q2;
    result.link2_rotation[3] = -z84;
    result.link2_rotation[4] = -z85;
    result.link2_rotation[5] = -c_q2;
    result.link2_rotation[6] = -s_q1;
    result.link2_rotation[7] = c_q1;
    result.link2_rotation[8] = n0;
    result.link2_velocity[0] = -z91;
    result.link2_velocity[1] = z92;
    result.link2_velocity[2] = -z90;
    result.link2_angular_velocity[0] = -z95;
    result.link2_angular_velocity[1] = z96;
    result.link2_angular_velocity[2] = z94;
    result.link3_position[0] = -z101;
    result.link3_position[1] = z102;
    result.link3_position[2] = z103;
    result.link3_rotation[0] = -z106;
    result.link3_rotation[1] = z107;
    result.link3_rotation[2] = -z105;
    result.link3_rotation[3] = -z110;
    result.link3_rotation[4] = -z111;
    result.link3_rotation[5] = z109;
    result.link3_rotation[6] = z84;
    result.link3_rotation[7] = z85;
    result.link3_rotation[8] = c_q2;
    result.link3_velocity[0] = z119;
    result.link3_velocity[1] = z120;
    result.link3_velocity[2] = z118;
    result.link3_angular_velocity[0] = -z125;
    result.link3_angular_velocity[1] = z126;
    result.link3_angular_velocity[2] = z124;
    result.link4_position[0] = -z135;
    result.link4_position[1] = z136;
    result.link4_position[2] = z137;
    result.link4_rotation[0] = -z142;
    result.link4_rotation[1] = z143;
    result.link4_rotation[2] = -z141;
    result.link4_rotation[3] = z148;
    result.link4_rotation[4] = z149;
    result.link4_rotation[5] = z147;
    result.link4_rotation[6] = z110;
    result.link4_rotation[7] = z111;
    result.link4_rotation[8] = -z109;
    result.link4_velocity[0] = -z159;
    result.link4_velocity[1] = -z160;
    result.link4_velocity[2] = -z158;
    result.link4_angular_velocity[0] = -z167;
    result.link4_angular_velocity[1] = z168;
    result.link4_angular_velocity[2] = -z166;
    result.link5_position[0] = -z180;
    result.link5_position[1] = z181;
    result.link5_position[2] = z182;
    result.link5_rotation[0] = -z189;
    result.link5_rotation[1] = z190;
    result.link5_rotation[2] = z188;
    result.link5_rotation[3] = z197;
    result.link5_rotation[4] = -z198;
    result.link5_rotation[5] = z196;
    result.link5_rotation[6] = z148;
    result.link5_rotation[7] = z149;
    result.link5_rotation[8] = z147;
    result.link5_velocity[0] = -z210;
    result.link5_velocity[1] = z211;
    result.link5_velocity[2] = z209;
    result.link5_angular_velocity[0] = z220;
    result.link5_angular_velocity[1] = z221;
    result.link5_angular_velocity[2] = -z219;
    result.link6_position[0] = -z236;
    result.link6_position[1] = z237;
    result.link6_position[2] = z238;
    result.link6_rotation[0] = z247;
    result.link6_rotation[1] = z248;
    result.link6_rotation[2] = z246;
    result.link6_rotation[3] = z257;
    result.link6_rotation[4] = -z258;
    result.link6_rotation[5] = -z256;
    result.link6_rotation[6] = -z197;
    result.link6_rotation[7] = z198;
    result.link6_rotation[8] = -z196;
    result.link6_velocity[0] = -z272;
    result.link6_velocity[1] = -z273;
    result.link6_velocity[2] = -z271;
    result.link6_angular_velocity[0] = z284;
    result.link6_angular_velocity[1] = z285;
    result.link6_angular_velocity[2] = -z283;
    result.link7_position[0] = -z303;
    result.link7_position[1] = z304;
    result.link7_position[2] = z305;
    result.link7_rotation[0] = z316;
    result.link7_rotation[1] = z317;
    result.link7_rotation[2] = z315;
    result.link7_rotation[3] = -z328;
    result.link7_rotation[4] = z329;
    result.link7_rotation[5] = -z327;
    result.link7_rotation[6] = -z257;
    result.link7_rotation[7] = z258;
    result.link7_rotation[8] = z256;
    result.link7_velocity[0] = z345;
    result.link7_velocity[1] = -z346;
    result.link7_velocity[2] = -z344;
    result.link7_angular_velocity[0] = z359;
    result.link7_angular_velocity[1] = z360;
    result.link7_angular_velocity[2] = z358;
    result.tip_position[0] = -z375;
    result.tip_position[1] = z376;
    result.tip_position[2] = z377;
    result.tip_velocity[0] = z392;
    result.tip_velocity[1] = -z393;
    result.tip_velocity[2] = -z391;
    result.tip_jacobian[0] = -z376;
    result.tip_jacobian[3] = -z395;
    result.tip_jacobian[6] = -z406;
    result.tip_jacobian[9] = z419;
    result.tip_jacobian[12] = -z436;
    result.tip_jacobian[15] = z439;
    result.tip_jacobian[18] = n0;
    result.tip_jacobian[1] = -z375;
    result.tip_jacobian[4] = -z396;
    result.tip_jacobian[7] = -z407;
    result.tip_jacobian[10] = z420;
    result.tip_jacobian[13] = -z437;
    result.tip_jacobian[16] = z440;
    result.tip_jacobian[19] = n0;
    result.tip_jacobian[2] = n0;
    result.tip_jacobian[5] = -z397;
    result.tip_jacobian[8] = z408;
    result.tip_jacobian[11] = z421;
    result.tip_jacobian[14] = z438;
    result.tip_jacobian[17] = -z441;
    result.tip_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 49>& mass) noexcept {
    const Scalar k0 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k1 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n0_176 = traits::constant(0.176, 0.176f, "22/125");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k19 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n0_768 = traits::constant(0.768, 0.768f, "96/125");
    const Scalar n0_165 = traits::constant(0.165, 0.165f, "33/200");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar n0_632 = traits::constant(0.632, 0.632f, "79/125");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
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
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = c_q6 * z465;
    const Scalar z470 = s_q6 * z465;
    const Scalar z471 = k4 + n0_088 * z466;
    const Scalar z472 = s_q6 * z471 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z471;
    const Scalar z474 = s_q5 * z466 - c_q5 * z469;
    const Scalar z475 = s_q5 * z469 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n0_0825 * z470 - n0_384 * z474 - z477;
    const Scalar z479 = s_q4 * z470 + c_q4 * z474;
    const Scalar z480 = s_q4 * z474 - c_q4 * z470;
    const Scalar z481 = n0_384 * z475 - z476;
    const Scalar z482 = z473 + n0_0825 * z475;
    const Scalar z483 = s_q4 * z482 - c_q4 * z481;
    const Scalar z484 = s_q4 * z481 + c_q4 * z482;
    const Scalar z485 = n0_0825 * z475 - z484;
    const Scalar z486 = s_q3 * z475 + c_q3 * z479;
    const Scalar z487 = s_q3 * z479 - c_q3 * z475;
    const Scalar z488 = z478 + n0_0825 * z480;
    const Scalar z489 = s_q3 * z488 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z488;
    const Scalar z491 = n0_316 * z486 - z490;
    const Scalar z494 = n0_316 * z487 - z489;
    const Scalar z496 = s_q2 * z494 - c_q2 * z485;
    const Scalar z497 = k9 * s_q7 - k10 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k9 - z498;
    const Scalar z500 = k11 + c_q7 * z497;
    const Scalar z501 = n0_088 * z465 - z500;
    const Scalar z502 = k4 + n0_176 * z466;
    const Scalar z503 = n0_176 * z466 + z498;
    const Scalar z504 = k13 + z466;
    const Scalar z505 = k14 - z499;
    const Scalar z506 = k15 - z467;
    const Scalar z507 = k16 + z501;
    const Scalar z508 = k17 + z468;
    const Scalar z509 = k18 + z503;
    const Scalar z510 = s_q6 * z504 - k19 * c_q6;
    const Scalar z511 = k19 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n0_0825 * z511 - n0_384 * z514 - z517;
    const Scalar z519 = s_q4 * z511 + c_q4 * z514;
    const Scalar z520 = s_q4 * z514 - c_q4 * z511;
    const Scalar z521 = n0_384 * z515 + z516;
    const Scalar z522 = z513 - n0_0825 * z515;
    const Scalar z523 = s_q4 * z522 + c_q4 * z521;
    const Scalar z524 = s_q4 * z521 - c_q4 * z522;
    const Scalar z525 = n0_0825 * z515 - z524;
    const Scalar z526 = s_q3 * z515 - c_q3 * z519;
    const Scalar z527 = s_q3 * z519 + c_q3 * z515;
    const Scalar z528 = z518 + n0_0825 * z520;
    const Scalar z529 = s_q3 * z528 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z528;
    const Scalar z531 = n0_316 * z526 + z530;
    const Scalar z534 = n0_316 * z527 - z529;
    const Scalar z536 = s_q2 * z534 + c_q2 * z525;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k21 - z511;
    const Scalar z545 = k22 - z465;
    const Scalar z546 = k23 - z541;
    const Scalar z547 = k24 - z512;
    const Scalar z548 = k25 + z543;
    const Scalar z549 = k26 + z513;
    const Scalar z550 = k27 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n0_384 * z551 - z554;
    const Scalar z556 = c_q4 * z551;
    const Scalar z557 = s_q4 * z551;
    const Scalar z558 = n0_384 * z552 - z553;
    const Scalar z559 = z550 + n0_0825 * z552;
    const Scalar z560 = s_q4 * z559 - c_q4 * z558;
    const Scalar z561 = s_q4 * z558 + c_q4 * z559;
    const Scalar z562 = n0_0825 * z552 - z561;
    const Scalar z563 = s_q3 * z552 + c_q3 * z556;
    const Scalar z564 = s_q3 * z556 - c_q3 * z552;
    const Scalar z565 = z555 - n0_0825 * z557;
    const Scalar z566 = s_q3 * z565 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z565;
    const Scalar z568 = n0_316 * z563 - z567;
    const Scalar z571 = n0_316 * z564 + z566;
    const Scalar z573 = s_q2 * z571 - c_q2 * z562;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n0_768 * z510 + z578;
    const Scalar z582 = n0_0825 * z510 + n0_384 * z552 - z553;
    const Scalar z583 = n0_0825 * z551 + z580;
    const Scalar z584 = z550 + n0_165 * z552;
    const Scalar z585 = n0_768 * z510 + n0_165 * z552 + z579;
    const Scalar z586 = k30 + z552;
    const Scalar z587 = k31 + z510;
    const Scalar z588 = k32 + z581;
    const Scalar z589 = k33 + z582;
    const Scalar z590 = k34 + z583;
    const Scalar z591 = k35 + z555;
    const Scalar z592 = k36 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = c_q3 * z593;
    const Scalar z598 = s_q3 * z593;
    const Scalar z599 = z592 - n0_0825 * z594;
    const Scalar z600 = s_q3 * z599 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z599;
    const Scalar z602 = n0_316 * z597 + z601;
    const Scalar z605 = n0_316 * z598 - z600;
    const Scalar z607 = s_q2 * z605 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = n0_0825 * z551 - z595;
    const Scalar z616 = n0_0825 * z593 - z614;
    const Scalar z617 = z592 - n0_165 * z594;
    const Scalar z618 = n0_165 * z594 - z613;
    const Scalar z619 = k37 - z594;
    const Scalar z620 = k38 - z551;
    const Scalar z621 = k39 + z612;
    const Scalar z622 = k40 - z615;
    const Scalar z623 = k41 - z616;
    const Scalar z624 = k42 + z596;
    const Scalar z625 = k43 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n0_316 * z626 + z629;
    const Scalar z633 = n0_316 * z627 + z628;
    const Scalar z635 = s_q2 * z633 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = n0_632 * z593 - z640;
    const Scalar z644 = n0_632 * z593 - z641;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z633;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z630;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    mass[0] = z669;
    mass[1] = -z655;
    mass[2] = -z635;
    mass[3] = z607;
    mass[4] = z573;
    mass[5] = -z536;
    mass[6] = z496;
    mass[7] = -z655;
    mass[8] = z651;
    mass[9] = -z630;
    mass[10] = z602;
    mass[11] = z568;
    mass[12] = z531;
    mass[13] = z491;
    mass[14] = -z635;
    mass[15] = -z630;
    mass[16] = z625;
    mass[17] = z596;
    mass[18] = -z562;
    mass[19] = -z525;
    mass[20] = -z485;
    mass[21] = z607;
    mass[22] = z602;
    mass[23] = z596;
    mass[24] = z592;
    mass[25] = -z555;
    mass[26] = -z518;
    mass[27] = z478;
    mass[28] = z573;
    mass[29] = z568;
    mass[30] = -z562;
    mass[31] = -z555;
    mass[32] = z550;
    mass[33] = -z513;
    mass[34] = z473;
    mass[35] = -z536;
    mass[36] = z531;
    mass[37] = -z525;
    mass[38] = -z518;
    mass[39] = -z513;
    mass[40] = z509;
    mass[41] = -z468;
    mass[42] = z496;
    mass[43] = z491;
    mass[44] = -z485;
    mass[45] = z478;
    mass[46] = z473;
    mass[47] = -z468;
    mass[48] = k4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k6 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k7 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k8 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k9 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k11 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k12 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k13 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k14 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k15 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar k16 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k17 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k18 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k19 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k20 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k21 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k22 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k23 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k24 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k28 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k29 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k35 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k36 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k37 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k38 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k39 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k40 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k44 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k45 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k46 = traits::constant(2.025402344516817, 2.0254023f, "15823455816537633/7812500000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k49 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k50 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k51 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k52 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k53 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
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
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z685 = n2 * z679;
    const Scalar z686 = c_q3 * z679;
    const Scalar z687 = s_q3 * z679;
    const Scalar z688 = z677 + n0_316 * z681;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z690 = n0_316 * z685;
    const Scalar z691 = s_q3 * z690 - c_q3 * z688;
    const Scalar z692 = s_q3 * z688 + c_q3 * z690;
    const Scalar z693 = v_q3 * z40 - z686;  // angular acceleration of link3, x
    const Scalar z694 = v_q3 * z39 - z687;  // angular acceleration of link3, y
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z699 = z680 - z698;
    const Scalar z700 = z39 * z43;
    const Scalar z701 = z694 + z700;
    const Scalar z702 = s_q4 * z680 - c_q4 * z693;
    const Scalar z703 = s_q4 * z693 + c_q4 * z680;
    const Scalar z704 = z691 - n0_0825 * z697;
    const Scalar z705 = z692 - n0_0825 * z699;
    const Scalar z706 = z689 + n0_0825 * z701;
    const Scalar z707 = s_q4 * z706 + c_q4 * z704;
    const Scalar z708 = s_q4 * z704 - c_q4 * z706;
    const Scalar z709 = v_q4 * z47 + z702;  // angular acceleration of link4, x
    const Scalar z710 = v_q4 * z46 + z703;  // angular acceleration of link4, y
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z715 = z694 + z714;
    const Scalar z716 = z694 - z714;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z720 = z710 + z719;
    const Scalar z721 = z47 * z50;
    const Scalar z722 = z709 + z721;
    const Scalar z723 = s_q5 * z694 + c_q5 * z709;
    const Scalar z724 = s_q5 * z709 - c_q5 * z694;
    const Scalar z725 = z707 + n0_0825 * z713 - n0_384 * z715;
    const Scalar z726 = z708 + n0_0825 * z716 + n0_384 * z718;
    const Scalar z727 = z705 + n0_0825 * z720 + n0_384 * z722;
    const Scalar z728 = s_q5 * z727 + c_q5 * z725;
    const Scalar z729 = s_q5 * z725 - c_q5 * z727;
    const Scalar z730 = v_q5 * z55 + z723;  // angular acceleration of link5, x
    const Scalar z731 = v_q5 * z54 + z724;  // angular acceleration of link5, y
    const Scalar z732 = s_q6 * z710 + c_q6 * z730;
    const Scalar z733 = s_q6 * z730 - c_q6 * z710;
    const Scalar z734 = s_q6 * z726 - c_q6 * z728;
    const Scalar z735 = s_q6 * z728 + c_q6 * z726;
    const Scalar z736 = v_q6 * z60 - z732;  // angular acceleration of link6, x
    const Scalar z737 = v_q6 * z59 - z733;  // angular acceleration of link6, y
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z742 = z731 - z741;
    const Scalar z743 = z59 * z63;
    const Scalar z744 = z737 + z743;
    const Scalar z745 = s_q7 * z731 - c_q7 * z736;
    const Scalar z746 = s_q7 * z736 + c_q7 * z731;
    const Scalar z747 = z734 + n0_088 * z740;
    const Scalar z748 = z735 + n0_088 * z742;
    const Scalar z749 = z729 + n0_088 * z744;
    const Scalar z750 = s_q7 * z749 - c_q7 * z747;
    const Scalar z751 = s_q7 * z747 + c_q7 * z749;
    const Scalar z752 = v_q7 * z67 + z745;  // angular acceleration of link7, x
    const Scalar z753 = v_q7 * z66 + z746;  // angular acceleration of link7, y
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z758 = z737 + z757;
    const Scalar z759 = z737 - z757;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z763 = z753 + z762;
    const Scalar z764 = z67 * z70;
    const Scalar z765 = z752 + z764;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z768 = z752 - z764;
    const Scalar z769 = z753 - z762;
    const Scalar z770 = z754 - z760;
    const Scalar z771 = k6 * z756 - k7 * z758;  // force on link7, x
    const Scalar z772 = k6 * z759 + k7 * z761;  // force on link7, y
    const Scalar z773 = k6 * z763 + k7 * z765;  // force on link7, z
    const Scalar z774 = k7 * z748 + k8 * z752 + k9 * z759 - k10 * z763 + k11 * z764 + k12 * z766;  // moment on link7, x
    const Scalar z775 = k6 * z748 + k12 * z758 + k13 * z762 - k10 * z765 + k9 * z767;  // moment on link7, y
    // moment on link7, z
    const Scalar z776 = k11 * z737 + k7 * z750 + k6 * z751 + k8 * z757 + k9 * z768 + k12 * z769 + k10 * z770;
    const Scalar z777 = s_q7 * z772 + c_q7 * z771;
    const Scalar z778 = s_q7 * z771 - c_q7 * z772;
    const Scalar z779 = s_q7 * z775 - c_q7 * z774;
    const Scalar z780 = s_q7 * z774 + c_q7 * z775;
    const Scalar z781 = z731 + z741;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z785 = z736 + z784;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z788 = z736 - z784;
    const Scalar z789 = z737 - z743;
    const Scalar z790 = z738 - z782;
    const Scalar z791 = k14 * z740 + z777 + k15 * z781;  // force on link6, x
    const Scalar z792 = k14 * z742 + z773 - k15 * z783;  // force on link6, y
    const Scalar z793 = k14 * z744 - z778 - k15 * z785;  // force on link6, z
    // moment on link6, x
    const Scalar z794 = k15 * z729 + k16 * z736 - k17 * z742 + k18 * z744 - z779 - k19 * z784 - k20 * z786;
    // moment on link6, y
    const Scalar z795 = k14 * z729 + k21 * z743 + z776 - n0_088 * z778 + k20 * z781 - k18 * z785 + k17 * z787;
    // moment on link6, z
    const Scalar z796 = k19 * z731 + k15 * z734 + k14 * z735 - k16 * z741 + n0_088 * z773 + z780 + k17 * z788 + k20
        * z789 + k18 * z790;
    const Scalar z797 = s_q6 * z792 - c_q6 * z791;
    const Scalar z798 = s_q6 * z791 + c_q6 * z792;
    const Scalar z799 = s_q6 * z795 - c_q6 * z794;
    const Scalar z800 = s_q6 * z794 + c_q6 * z795;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z805 = z710 + z804;
    const Scalar z806 = z710 - z804;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z810 = z731 + z809;
    const Scalar z811 = z55 * z58;
    const Scalar z812 = z730 + z811;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z815 = z730 - z811;
    const Scalar z816 = z731 - z809;
    const Scalar z817 = z801 - z807;
    const Scalar z818 = z797 + k22 * z803 + k23 * z805;  // force on link5, x
    const Scalar z819 = z793 - k22 * z806 + k23 * z808;  // force on link5, y
    const Scalar z820 = z798 - k22 * z810 + k23 * z812;  // force on link5, z
    // moment on link5, x
    const Scalar z821 = k23 * z726 + k24 * z730 - z799 - k25 * z806 + k26 * z810 + k27 * z811 - k28 * z813;
    const Scalar z822 = k22 * z726 - z796 + k28 * z805 - k29 * z809 - k26 * z812 + k25 * z814;  // moment on link5, y
    // moment on link5, z
    const Scalar z823 = k27 * z710 + k23 * z728 - k22 * z729 + z800 + k24 * z804 - k25 * z815 - k28 * z816 - k26 * z817;
    const Scalar z824 = s_q5 * z819 + c_q5 * z818;
    const Scalar z825 = s_q5 * z818 - c_q5 * z819;
    const Scalar z826 = s_q5 * z822 - c_q5 * z821;
    const Scalar z827 = s_q5 * z821 + c_q5 * z822;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z830 = z709 - z721;
    const Scalar z831 = z710 - z719;
    const Scalar z832 = z711 - z717;
    const Scalar z833 = k30 * z713 - k31 * z715 + z824;  // force on link4, x
    const Scalar z834 = k30 * z716 + k31 * z718 + z820;  // force on link4, y
    const Scalar z835 = k30 * z720 + k31 * z722 + z825;  // force on link4, z
    // moment on link4, x
    const Scalar z836 = k31 * z705 + k32 * z709 - k33 * z716 + k34 * z720 + k35 * z721 + n0_384 * z825 - z826 + k36
        * z828;
    // moment on link4, y
    const Scalar z837 = k30 * z705 + k36 * z715 + k37 * z719 + k34 * z722 + z823 + n0_0825 * z825 - k33 * z829;
    // moment on link4, z
    const Scalar z838 = k35 * z694 - k31 * z707 + k30 * z708 + k32 * z714 + n0_0825 * z820 - n0_384 * z824 + z827 - k33
        * z830 + k36 * z831 - k34 * z832;
    const Scalar z839 = s_q4 * z834 + c_q4 * z833;
    const Scalar z840 = s_q4 * z833 - c_q4 * z834;
    const Scalar z841 = s_q4 * z837 - c_q4 * z836;
    const Scalar z842 = s_q4 * z836 + c_q4 * z837;
    const Scalar z843 = z680 + z698;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z847 = z693 + z846;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z850 = z693 - z846;
    const Scalar z851 = z694 - z700;
    const Scalar z852 = z695 - z844;
    const Scalar z853 = k38 * z697 - z839 - k39 * z843;  // force on link3, x
    const Scalar z854 = k38 * z699 - z835 + k39 * z845;  // force on link3, y
    // moment on link3, x
    const Scalar z856 = k39 * z689 + k40 * z693 + k41 * z699 + k42 * z701 + z841 + k43 * z846 - k44 * z848;
    // moment on link3, y
    const Scalar z857 = k38 * z689 + k45 * z700 + z838 + n0_0825 * z840 - k44 * z843 + k42 * z847 + k41 * z849;
    // moment on link3, z
    const Scalar z858 = k43 * z680 + k39 * z691 - k38 * z692 + k40 * z698 - n0_0825 * z835 + z842 + k41 * z850 - k44
        * z851 - k42 * z852;
    const Scalar z859 = s_q3 * z854 - c_q3 * z853;
    const Scalar z860 = s_q3 * z853 + c_q3 * z854;
    const Scalar z861 = s_q3 * z857 + c_q3 * z856;
    const Scalar z862 = s_q3 * z856 - c_q3 * z857;
    const Scalar z863 = z36 * z36;
    const Scalar z865 = n2 * z680;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z872 = k46 * z679 - k47 * z681 - n0_316 * z860 - z861 + k48 * z865 + k49 * z866;  // moment on link2, x
    const Scalar z873 = k50 * z680 - k49 * z681 + k48 * z685 + z858 + k47 * z867;  // moment on link2, y
    const Scalar z874 = k51 * z677 - k52 * z678 + k53 * z681 - n0_316 * z859 - z862 + k48 * z868;  // moment on link2, z
    const Scalar z878 = s_q2 * z872 - c_q2 * z873;
    forces.q1 = z878;
    forces.q2 = -z874;
    forces.q3 = -z858;
    forces.q4 = z838;
    forces.q5 = -z823;
    forces.q6 = -z796;
    forces.q7 = z776;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k5 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k6 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k7 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k8 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k12 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar k15 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k18 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k19 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k20 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k24 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k25 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k26 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k27 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k28 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k29 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k30 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k31 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k32 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k33 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k36 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k40 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k41 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k42 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k43 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k44 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k45 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k46 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k47 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k48 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k49 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k50 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k51 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k52 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k53 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
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
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z700 = z39 * z43;
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z721 = z47 * z50;
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z743 = z59 * z63;
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z764 = z67 * z70;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z770 = z754 - z760;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z790 = z738 - z782;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z811 = z55 * z58;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z817 = z801 - z807;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z832 = z711 - z717;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z852 = z695 - z844;
    const Scalar z863 = z36 * z36;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z884 = a_q1 * s_q2;
    const Scalar z885 = a_q1 * c_q2;
    const Scalar z886 = v_q2 * z36 + z884;  // angular acceleration of link2, x
    const Scalar z887 = v_q2 * z35 - z885;  // angular acceleration of link2, y
    const Scalar z888 = a_q2 - z681;
    const Scalar z889 = z679 + z886;
    const Scalar z890 = a_q2 * s_q3 - c_q3 * z886;
    const Scalar z891 = a_q2 * c_q3 + s_q3 * z886;
    const Scalar z892 = z677 - n0_316 * z888;
    const Scalar z893 = n0_316 * z889;
    const Scalar z894 = s_q3 * z893 - c_q3 * z892;
    const Scalar z895 = s_q3 * z892 + c_q3 * z893;
    const Scalar z896 = v_q3 * z40 + z890;  // angular acceleration of link3, x
    const Scalar z897 = v_q3 * z39 - z891;  // angular acceleration of link3, y
    const Scalar z898 = a_q3 - z887;  // angular acceleration of link3, z
    const Scalar z899 = z698 + z898;
    const Scalar z900 = z700 + z897;
    const Scalar z901 = s_q4 * z898 + c_q4 * z896;
    const Scalar z902 = s_q4 * z896 - c_q4 * z898;
    const Scalar z903 = n0_0825 * z697 - z894;
    const Scalar z904 = z895 + n0_0825 * z899;
    const Scalar z905 = z689 + n0_0825 * z900;
    const Scalar z906 = s_q4 * z905 - c_q4 * z903;
    const Scalar z907 = s_q4 * z903 + c_q4 * z905;
    const Scalar z908 = v_q4 * z47 - z901;  // angular acceleration of link4, x
    const Scalar z909 = v_q4 * z46 + z902;  // angular acceleration of link4, y
    const Scalar z910 = a_q4 + z897;  // angular acceleration of link4, z
    const Scalar z911 = z714 + z910;
    const Scalar z912 = z714 - z910;
    const Scalar z913 = z719 + z909;
    const Scalar z914 = z721 + z908;
    const Scalar z915 = s_q5 * z910 + c_q5 * z908;
    const Scalar z916 = s_q5 * z908 - c_q5 * z910;
    const Scalar z917 = n0_0825 * z713 + z906 - n0_384 * z911;
    const Scalar z918 = n0_384 * z718 - z907 - n0_0825 * z912;
    const Scalar z919 = z904 + n0_0825 * z913 + n0_384 * z914;
    const Scalar z920 = s_q5 * z919 + c_q5 * z917;
    const Scalar z921 = s_q5 * z917 - c_q5 * z919;
    const Scalar z922 = v_q5 * z55 + z915;  // angular acceleration of link5, x
    const Scalar z923 = v_q5 * z54 + z916;  // angular acceleration of link5, y
    const Scalar z924 = a_q5 - z909;  // angular acceleration of link5, z
    const Scalar z925 = s_q6 * z924 - c_q6 * z922;
    const Scalar z926 = s_q6 * z922 + c_q6 * z924;
    const Scalar z927 = s_q6 * z918 - c_q6 * z920;
    const Scalar z928 = s_q6 * z920 + c_q6 * z918;
    const Scalar z929 = v_q6 * z60 + z925;  // angular acceleration of link6, x
    const Scalar z930 = v_q6 * z59 - z926;  // angular acceleration of link6, y
    const Scalar z931 = a_q6 - z923;  // angular acceleration of link6, z
    const Scalar z932 = z741 + z931;
    const Scalar z933 = z743 + z930;
    const Scalar z934 = s_q7 * z931 + c_q7 * z929;
    const Scalar z935 = s_q7 * z929 - c_q7 * z931;
    const Scalar z936 = n0_088 * z740 + z927;
    const Scalar z937 = z928 - n0_088 * z932;
    const Scalar z938 = z921 + n0_088 * z933;
    const Scalar z939 = s_q7 * z938 - c_q7 * z936;
    const Scalar z940 = s_q7 * z936 + c_q7 * z938;
    const Scalar z941 = v_q7 * z67 - z934;  // angular acceleration of link7, x
    const Scalar z942 = v_q7 * z66 + z935;  // angular acceleration of link7, y
    const Scalar z943 = a_q7 + z930;  // angular acceleration of link7, z
    const Scalar z944 = z757 + z943;
    const Scalar z945 = z757 - z943;
    const Scalar z946 = z762 + z942;
    const Scalar z947 = z764 + z941;
    const Scalar z948 = z764 - z941;
    const Scalar z949 = z762 - z942;
    const Scalar z950 = k5 * z756 - k6 * z944;  // force on link7, x
    const Scalar z951 = k6 * z761 - k5 * z945;  // force on link7, y
    const Scalar z952 = k5 * z946 + k6 * z947;  // force on link7, z
    const Scalar z953 = k7 * z764 + k8 * z766 + k6 * z937 + k9 * z941 - k10 * z945 - k11 * z946;  // moment on link7, x
    const Scalar z954 = k12 * z762 + k10 * z767 + k5 * z937 + k8 * z944 - k11 * z947;  // moment on link7, y
    // moment on link7, z
    const Scalar z955 = k9 * z757 + k11 * z770 + k6 * z939 + k5 * z940 + k7 * z943 - k10 * z948 - k8 * z949;
    const Scalar z956 = s_q7 * z951 + c_q7 * z950;
    const Scalar z957 = s_q7 * z950 - c_q7 * z951;
    const Scalar z958 = s_q7 * z954 - c_q7 * z953;
    const Scalar z959 = s_q7 * z953 + c_q7 * z954;
    const Scalar z960 = z741 - z931;
    const Scalar z961 = z784 + z929;
    const Scalar z962 = z784 - z929;
    const Scalar z963 = z743 - z930;
    const Scalar z964 = k13 * z740 + z956 + k14 * z960;  // force on link6, x
    const Scalar z965 = k14 * z783 + k13 * z932 - z952;  // force on link6, y
    const Scalar z966 = k13 * z933 - z957 - k14 * z961;  // force on link6, z
    // moment on link6, x
    const Scalar z967 = k15 * z784 + k16 * z786 - k14 * z921 - k17 * z929 - k18 * z932 - k19 * z933 + z958;
    // moment on link6, y
    const Scalar z968 = k20 * z743 + k18 * z787 + k13 * z921 + z955 - n0_088 * z957 + k16 * z960 - k19 * z961;
    // moment on link6, z
    const Scalar z969 = k17 * z741 - k19 * z790 - k14 * z927 - k13 * z928 + k15 * z931 - n0_088 * z952 - z959 + k18
        * z962 + k16 * z963;
    const Scalar z970 = s_q6 * z965 + c_q6 * z964;
    const Scalar z971 = s_q6 * z964 - c_q6 * z965;
    const Scalar z972 = s_q6 * z968 + c_q6 * z967;
    const Scalar z973 = s_q6 * z967 - c_q6 * z968;
    const Scalar z974 = z804 - z924;
    const Scalar z975 = z804 + z924;
    const Scalar z976 = z809 + z923;
    const Scalar z977 = z811 + z922;
    const Scalar z978 = z811 - z922;
    const Scalar z979 = z809 - z923;
    const Scalar z980 = k21 * z803 - z970 + k22 * z974;  // force on link5, x
    const Scalar z981 = k22 * z808 + z966 + k21 * z975;  // force on link5, y
    const Scalar z982 = z971 - k21 * z976 + k22 * z977;  // force on link5, z
    // moment on link5, x
    const Scalar z983 = k23 * z811 - k24 * z813 + k22 * z918 + k25 * z922 - z972 + k26 * z975 + k27 * z976;
    const Scalar z984 = k28 * z809 - k26 * z814 - k21 * z918 - z969 - k24 * z974 + k27 * z977;  // moment on link5, y
    // moment on link5, z
    const Scalar z985 = k25 * z804 - k27 * z817 + k22 * z920 - k21 * z921 - k23 * z924 - z973 + k26 * z978 + k24 * z979;
    const Scalar z986 = s_q5 * z981 + c_q5 * z980;
    const Scalar z987 = s_q5 * z980 - c_q5 * z981;
    const Scalar z988 = s_q5 * z984 + c_q5 * z983;
    const Scalar z989 = s_q5 * z983 - c_q5 * z984;
    const Scalar z990 = z721 - z908;
    const Scalar z991 = z719 - z909;
    const Scalar z992 = k29 * z713 - k30 * z911 + z986;  // force on link4, x
    const Scalar z993 = k30 * z718 - k29 * z912 + z982;  // force on link4, y
    const Scalar z994 = k29 * z913 + k30 * z914 + z987;  // force on link4, z
    // moment on link4, x
    const Scalar z995 = k31 * z721 + k32 * z828 + k30 * z904 + k33 * z908 + k34 * z912 + k35 * z913 + n0_384 * z987
        + z988;
    // moment on link4, y
    const Scalar z996 = k36 * z719 - k34 * z829 + k29 * z904 + k32 * z911 + k35 * z914 + z985 + n0_0825 * z987;
    // moment on link4, z
    const Scalar z997 = k33 * z714 - k35 * z832 - k30 * z906 - k29 * z907 + k31 * z910 + n0_0825 * z982 - n0_384 * z986
        + z989 + k34 * z990 - k32 * z991;
    const Scalar z998 = s_q4 * z993 + c_q4 * z992;
    const Scalar z999 = s_q4 * z992 - c_q4 * z993;
    const Scalar z1000 = s_q4 * z996 - c_q4 * z995;
    const Scalar z1001 = s_q4 * z995 + c_q4 * z996;
    const Scalar z1002 = z698 - z898;
    const Scalar z1003 = z846 + z896;
    const Scalar z1004 = z846 - z896;
    const Scalar z1005 = z700 - z897;
    const Scalar z1006 = k37 * z697 - z998 - k38 * z1002;  // force on link3, x
    const Scalar z1007 = k38 * z845 - k37 * z899 - z994;  // force on link3, y
    // moment on link3, x
    const Scalar z1009 = k38 * z689 + k39 * z846 - k40 * z848 + k41 * z896 - k42 * z899 + k43 * z900 + z1000;
    // moment on link3, y
    const Scalar z1010 = k37 * z689 + k44 * z700 + k42 * z849 + z997 + n0_0825 * z999 - k40 * z1002 + k43 * z1003;
    // moment on link3, z
    const Scalar z1011 = k41 * z698 - k43 * z852 + k38 * z894 - k37 * z895 - k39 * z898 - n0_0825 * z994 + z1001 - k42
        * z1004 + k40 * z1005;
    const Scalar z1012 = s_q3 * z1007 - c_q3 * z1006;
    const Scalar z1013 = s_q3 * z1006 + c_q3 * z1007;
    const Scalar z1014 = s_q3 * z1010 + c_q3 * z1009;
    const Scalar z1015 = s_q3 * z1009 - c_q3 * z1010;
    const Scalar z1016 = a_q2 + z681;
    const Scalar z1017 = z680 + z887;
    const Scalar z1018 = z679 - z886;
    const Scalar z1019 = z680 - z887;
    // moment on link2, x
    const Scalar z1023 = k45 * z679 + k46 * z866 + k47 * z886 - n0_316 * z1013 - z1014 - k48 * z1016 + k49 * z1017;
    const Scalar z1024 = k50 * z680 + k48 * z867 + k46 * z888 + k49 * z889 + z1011;  // moment on link2, y
    // moment on link2, z
    const Scalar z1025 = k45 * a_q2 - k51 * z677 + k52 * z678 - k47 * z681 - k49 * z868 + n0_316 * z1012 + z1015 + k48
        * z1018 - k46 * z1019;
    const Scalar z1029 = s_q2 * z1023 - c_q2 * z1024;
    const Scalar z1034 = k53 * a_q1 + z1029;  // moment on link1, z
    forces.q1 = z1034;
    forces.q2 = z1025;
    forces.q3 = -z1011;
    forces.q4 = z997;
    forces.q5 = -z985;
    forces.q6 = z969;
    forces.q7 = z955;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k1 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n0_176 = traits::constant(0.176, 0.176f, "22/125");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k19 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n0_768 = traits::constant(0.768, 0.768f, "96/125");
    const Scalar n0_165 = traits::constant(0.165, 0.165f, "33/200");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar n0_632 = traits::constant(0.632, 0.632f, "79/125");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k52 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k53 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k54 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k55 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k56 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k57 = traits::constant(2.025402344516817, 2.0254023f, "15823455816537633/7812500000000000");
    const Scalar k58 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k59 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k60 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k61 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
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
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = c_q6 * z465;
    const Scalar z470 = s_q6 * z465;
    const Scalar z471 = k4 + n0_088 * z466;
    const Scalar z472 = s_q6 * z471 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z471;
    const Scalar z474 = s_q5 * z466 - c_q5 * z469;
    const Scalar z475 = s_q5 * z469 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n0_0825 * z470 - n0_384 * z474 - z477;
    const Scalar z479 = s_q4 * z470 + c_q4 * z474;
    const Scalar z480 = s_q4 * z474 - c_q4 * z470;
    const Scalar z481 = n0_384 * z475 - z476;
    const Scalar z482 = z473 + n0_0825 * z475;
    const Scalar z483 = s_q4 * z482 - c_q4 * z481;
    const Scalar z484 = s_q4 * z481 + c_q4 * z482;
    const Scalar z485 = n0_0825 * z475 - z484;
    const Scalar z486 = s_q3 * z475 + c_q3 * z479;
    const Scalar z487 = s_q3 * z479 - c_q3 * z475;
    const Scalar z488 = z478 + n0_0825 * z480;
    const Scalar z489 = s_q3 * z488 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z488;
    const Scalar z491 = n0_316 * z486 - z490;
    const Scalar z494 = n0_316 * z487 - z489;
    const Scalar z496 = s_q2 * z494 - c_q2 * z485;
    const Scalar z497 = k9 * s_q7 - k10 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k9 - z498;
    const Scalar z500 = k11 + c_q7 * z497;
    const Scalar z501 = n0_088 * z465 - z500;
    const Scalar z502 = k4 + n0_176 * z466;
    const Scalar z503 = n0_176 * z466 + z498;
    const Scalar z504 = k13 + z466;
    const Scalar z505 = k14 - z499;
    const Scalar z506 = k15 - z467;
    const Scalar z507 = k16 + z501;
    const Scalar z508 = k17 + z468;
    const Scalar z509 = k18 + z503;
    const Scalar z510 = s_q6 * z504 - k19 * c_q6;
    const Scalar z511 = k19 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n0_0825 * z511 - n0_384 * z514 - z517;
    const Scalar z519 = s_q4 * z511 + c_q4 * z514;
    const Scalar z520 = s_q4 * z514 - c_q4 * z511;
    const Scalar z521 = n0_384 * z515 + z516;
    const Scalar z522 = z513 - n0_0825 * z515;
    const Scalar z523 = s_q4 * z522 + c_q4 * z521;
    const Scalar z524 = s_q4 * z521 - c_q4 * z522;
    const Scalar z525 = n0_0825 * z515 - z524;
    const Scalar z526 = s_q3 * z515 - c_q3 * z519;
    const Scalar z527 = s_q3 * z519 + c_q3 * z515;
    const Scalar z528 = z518 + n0_0825 * z520;
    const Scalar z529 = s_q3 * z528 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z528;
    const Scalar z531 = n0_316 * z526 + z530;
    const Scalar z534 = n0_316 * z527 - z529;
    const Scalar z536 = s_q2 * z534 + c_q2 * z525;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k21 - z511;
    const Scalar z545 = k22 - z465;
    const Scalar z546 = k23 - z541;
    const Scalar z547 = k24 - z512;
    const Scalar z548 = k25 + z543;
    const Scalar z549 = k26 + z513;
    const Scalar z550 = k27 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n0_384 * z551 - z554;
    const Scalar z556 = c_q4 * z551;
    const Scalar z557 = s_q4 * z551;
    const Scalar z558 = n0_384 * z552 - z553;
    const Scalar z559 = z550 + n0_0825 * z552;
    const Scalar z560 = s_q4 * z559 - c_q4 * z558;
    const Scalar z561 = s_q4 * z558 + c_q4 * z559;
    const Scalar z562 = n0_0825 * z552 - z561;
    const Scalar z563 = s_q3 * z552 + c_q3 * z556;
    const Scalar z564 = s_q3 * z556 - c_q3 * z552;
    const Scalar z565 = z555 - n0_0825 * z557;
    const Scalar z566 = s_q3 * z565 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z565;
    const Scalar z568 = n0_316 * z563 - z567;
    const Scalar z571 = n0_316 * z564 + z566;
    const Scalar z573 = s_q2 * z571 - c_q2 * z562;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n0_768 * z510 + z578;
    const Scalar z582 = n0_0825 * z510 + n0_384 * z552 - z553;
    const Scalar z583 = n0_0825 * z551 + z580;
    const Scalar z584 = z550 + n0_165 * z552;
    const Scalar z585 = n0_768 * z510 + n0_165 * z552 + z579;
    const Scalar z586 = k30 + z552;
    const Scalar z587 = k31 + z510;
    const Scalar z588 = k32 + z581;
    const Scalar z589 = k33 + z582;
    const Scalar z590 = k34 + z583;
    const Scalar z591 = k35 + z555;
    const Scalar z592 = k36 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = c_q3 * z593;
    const Scalar z598 = s_q3 * z593;
    const Scalar z599 = z592 - n0_0825 * z594;
    const Scalar z600 = s_q3 * z599 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z599;
    const Scalar z602 = n0_316 * z597 + z601;
    const Scalar z605 = n0_316 * z598 - z600;
    const Scalar z607 = s_q2 * z605 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = n0_0825 * z551 - z595;
    const Scalar z616 = n0_0825 * z593 - z614;
    const Scalar z617 = z592 - n0_165 * z594;
    const Scalar z618 = n0_165 * z594 - z613;
    const Scalar z619 = k37 - z594;
    const Scalar z620 = k38 - z551;
    const Scalar z621 = k39 + z612;
    const Scalar z622 = k40 - z615;
    const Scalar z623 = k41 - z616;
    const Scalar z624 = k42 + z596;
    const Scalar z625 = k43 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n0_316 * z626 + z629;
    const Scalar z633 = n0_316 * z627 + z628;
    const Scalar z635 = s_q2 * z633 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = n0_632 * z593 - z640;
    const Scalar z644 = n0_632 * z593 - z641;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z633;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z630;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z685 = n2 * z679;
    const Scalar z686 = c_q3 * z679;
    const Scalar z687 = s_q3 * z679;
    const Scalar z688 = z677 + n0_316 * z681;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z690 = n0_316 * z685;
    const Scalar z691 = s_q3 * z690 - c_q3 * z688;
    const Scalar z692 = s_q3 * z688 + c_q3 * z690;
    const Scalar z693 = v_q3 * z40 - z686;  // angular acceleration of link3, x
    const Scalar z694 = v_q3 * z39 - z687;  // angular acceleration of link3, y
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z699 = z680 - z698;
    const Scalar z700 = z39 * z43;
    const Scalar z701 = z694 + z700;
    const Scalar z702 = s_q4 * z680 - c_q4 * z693;
    const Scalar z703 = s_q4 * z693 + c_q4 * z680;
    const Scalar z704 = z691 - n0_0825 * z697;
    const Scalar z705 = z692 - n0_0825 * z699;
    const Scalar z706 = z689 + n0_0825 * z701;
    const Scalar z707 = s_q4 * z706 + c_q4 * z704;
    const Scalar z708 = s_q4 * z704 - c_q4 * z706;
    const Scalar z709 = v_q4 * z47 + z702;  // angular acceleration of link4, x
    const Scalar z710 = v_q4 * z46 + z703;  // angular acceleration of link4, y
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z715 = z694 + z714;
    const Scalar z716 = z694 - z714;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z720 = z710 + z719;
    const Scalar z721 = z47 * z50;
    const Scalar z722 = z709 + z721;
    const Scalar z723 = s_q5 * z694 + c_q5 * z709;
    const Scalar z724 = s_q5 * z709 - c_q5 * z694;
    const Scalar z725 = z707 + n0_0825 * z713 - n0_384 * z715;
    const Scalar z726 = z708 + n0_0825 * z716 + n0_384 * z718;
    const Scalar z727 = z705 + n0_0825 * z720 + n0_384 * z722;
    const Scalar z728 = s_q5 * z727 + c_q5 * z725;
    const Scalar z729 = s_q5 * z725 - c_q5 * z727;
    const Scalar z730 = v_q5 * z55 + z723;  // angular acceleration of link5, x
    const Scalar z731 = v_q5 * z54 + z724;  // angular acceleration of link5, y
    const Scalar z732 = s_q6 * z710 + c_q6 * z730;
    const Scalar z733 = s_q6 * z730 - c_q6 * z710;
    const Scalar z734 = s_q6 * z726 - c_q6 * z728;
    const Scalar z735 = s_q6 * z728 + c_q6 * z726;
    const Scalar z736 = v_q6 * z60 - z732;  // angular acceleration of link6, x
    const Scalar z737 = v_q6 * z59 - z733;  // angular acceleration of link6, y
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z742 = z731 - z741;
    const Scalar z743 = z59 * z63;
    const Scalar z744 = z737 + z743;
    const Scalar z745 = s_q7 * z731 - c_q7 * z736;
    const Scalar z746 = s_q7 * z736 + c_q7 * z731;
    const Scalar z747 = z734 + n0_088 * z740;
    const Scalar z748 = z735 + n0_088 * z742;
    const Scalar z749 = z729 + n0_088 * z744;
    const Scalar z750 = s_q7 * z749 - c_q7 * z747;
    const Scalar z751 = s_q7 * z747 + c_q7 * z749;
    const Scalar z752 = v_q7 * z67 + z745;  // angular acceleration of link7, x
    const Scalar z753 = v_q7 * z66 + z746;  // angular acceleration of link7, y
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z758 = z737 + z757;
    const Scalar z759 = z737 - z757;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z763 = z753 + z762;
    const Scalar z764 = z67 * z70;
    const Scalar z765 = z752 + z764;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z768 = z752 - z764;
    const Scalar z769 = z753 - z762;
    const Scalar z770 = z754 - z760;
    const Scalar z771 = k0 * z756 - k1 * z758;  // force on link7, x
    const Scalar z772 = k0 * z759 + k1 * z761;  // force on link7, y
    const Scalar z773 = k0 * z763 + k1 * z765;  // force on link7, z
    const Scalar z774 = k1 * z748 + k9 * z752 + k3 * z759 - k11 * z763 + k4 * z764 + k2 * z766;  // moment on link7, x
    const Scalar z775 = k0 * z748 + k2 * z758 + k52 * z762 - k11 * z765 + k3 * z767;  // moment on link7, y
    // moment on link7, z
    const Scalar z776 = k4 * z737 + k1 * z750 + k0 * z751 + k9 * z757 + k3 * z768 + k2 * z769 + k11 * z770;
    const Scalar z777 = s_q7 * z772 + c_q7 * z771;
    const Scalar z778 = s_q7 * z771 - c_q7 * z772;
    const Scalar z779 = s_q7 * z775 - c_q7 * z774;
    const Scalar z780 = s_q7 * z774 + c_q7 * z775;
    const Scalar z781 = z731 + z741;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z785 = z736 + z784;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z788 = z736 - z784;
    const Scalar z789 = z737 - z743;
    const Scalar z790 = z738 - z782;
    const Scalar z791 = k13 * z740 + z777 + k19 * z781;  // force on link6, x
    const Scalar z792 = k13 * z742 + z773 - k19 * z783;  // force on link6, y
    const Scalar z793 = k13 * z744 - z778 - k19 * z785;  // force on link6, z
    // moment on link6, x
    const Scalar z794 = k19 * z729 + k14 * z736 - k16 * z742 + k15 * z744 - z779 - k18 * z784 - k17 * z786;
    // moment on link6, y
    const Scalar z795 = k13 * z729 + k53 * z743 + z776 - n0_088 * z778 + k17 * z781 - k15 * z785 + k16 * z787;
    // moment on link6, z
    const Scalar z796 = k18 * z731 + k19 * z734 + k13 * z735 - k14 * z741 + n0_088 * z773 + z780 + k16 * z788 + k17
        * z789 + k15 * z790;
    const Scalar z797 = s_q6 * z792 - c_q6 * z791;
    const Scalar z798 = s_q6 * z791 + c_q6 * z792;
    const Scalar z799 = s_q6 * z795 - c_q6 * z794;
    const Scalar z800 = s_q6 * z794 + c_q6 * z795;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z805 = z710 + z804;
    const Scalar z806 = z710 - z804;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z810 = z731 + z809;
    const Scalar z811 = z55 * z58;
    const Scalar z812 = z730 + z811;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z815 = z730 - z811;
    const Scalar z816 = z731 - z809;
    const Scalar z817 = z801 - z807;
    const Scalar z818 = z797 + k21 * z803 + k22 * z805;  // force on link5, x
    const Scalar z819 = z793 - k21 * z806 + k22 * z808;  // force on link5, y
    const Scalar z820 = z798 - k21 * z810 + k22 * z812;  // force on link5, z
    // moment on link5, x
    const Scalar z821 = k22 * z726 + k23 * z730 - z799 - k25 * z806 + k24 * z810 + k27 * z811 - k26 * z813;
    const Scalar z822 = k21 * z726 - z796 + k26 * z805 - k54 * z809 - k24 * z812 + k25 * z814;  // moment on link5, y
    // moment on link5, z
    const Scalar z823 = k27 * z710 + k22 * z728 - k21 * z729 + z800 + k23 * z804 - k25 * z815 - k26 * z816 - k24 * z817;
    const Scalar z824 = s_q5 * z819 + c_q5 * z818;
    const Scalar z825 = s_q5 * z818 - c_q5 * z819;
    const Scalar z826 = s_q5 * z822 - c_q5 * z821;
    const Scalar z827 = s_q5 * z821 + c_q5 * z822;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z830 = z709 - z721;
    const Scalar z831 = z710 - z719;
    const Scalar z832 = z711 - z717;
    const Scalar z833 = k30 * z713 - k31 * z715 + z824;  // force on link4, x
    const Scalar z834 = k30 * z716 + k31 * z718 + z820;  // force on link4, y
    const Scalar z835 = k30 * z720 + k31 * z722 + z825;  // force on link4, z
    // moment on link4, x
    const Scalar z836 = k31 * z705 + k32 * z709 - k34 * z716 + k33 * z720 + k36 * z721 + n0_384 * z825 - z826 + k35
        * z828;
    // moment on link4, y
    const Scalar z837 = k30 * z705 + k35 * z715 + k55 * z719 + k33 * z722 + z823 + n0_0825 * z825 - k34 * z829;
    // moment on link4, z
    const Scalar z838 = k36 * z694 - k31 * z707 + k30 * z708 + k32 * z714 + n0_0825 * z820 - n0_384 * z824 + z827 - k34
        * z830 + k35 * z831 - k33 * z832;
    const Scalar z839 = s_q4 * z834 + c_q4 * z833;
    const Scalar z840 = s_q4 * z833 - c_q4 * z834;
    const Scalar z841 = s_q4 * z837 - c_q4 * z836;
    const Scalar z842 = s_q4 * z836 + c_q4 * z837;
    const Scalar z843 = z680 + z698;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z847 = z693 + z846;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z850 = z693 - z846;
    const Scalar z851 = z694 - z700;
    const Scalar z852 = z695 - z844;
    const Scalar z853 = k37 * z697 - z839 - k38 * z843;  // force on link3, x
    const Scalar z854 = k37 * z699 - z835 + k38 * z845;  // force on link3, y
    // moment on link3, x
    const Scalar z856 = k38 * z689 + k39 * z693 + k41 * z699 + k40 * z701 + z841 + k43 * z846 - k42 * z848;
    // moment on link3, y
    const Scalar z857 = k37 * z689 + k56 * z700 + z838 + n0_0825 * z840 - k42 * z843 + k40 * z847 + k41 * z849;
    // moment on link3, z
    const Scalar z858 = k43 * z680 + k38 * z691 - k37 * z692 + k39 * z698 - n0_0825 * z835 + z842 + k41 * z850 - k42
        * z851 - k40 * z852;
    const Scalar z859 = s_q3 * z854 - c_q3 * z853;
    const Scalar z860 = s_q3 * z853 + c_q3 * z854;
    const Scalar z861 = s_q3 * z857 + c_q3 * z856;
    const Scalar z862 = s_q3 * z856 - c_q3 * z857;
    const Scalar z863 = z36 * z36;
    const Scalar z865 = n2 * z680;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z872 = k57 * z679 - k47 * z681 - n0_316 * z860 - z861 + k46 * z865 + k48 * z866;  // moment on link2, x
    const Scalar z873 = k58 * z680 - k48 * z681 + k46 * z685 + z858 + k47 * z867;  // moment on link2, y
    const Scalar z874 = k59 * z677 - k60 * z678 + k45 * z681 - n0_316 * z859 - z862 + k46 * z868;  // moment on link2, z
    const Scalar z878 = s_q2 * z872 - c_q2 * z873;
    const Scalar z1624 = u_tau1 - z878;
    const Scalar z1625 = u_tau2 + z874;
    const Scalar z1626 = u_tau3 + z858;
    const Scalar z1627 = u_tau4 - z838;
    const Scalar z1628 = u_tau5 + z823;
    const Scalar z1629 = u_tau6 + z796;
    const Scalar z1630 = u_tau7 - z776;
    const Scalar z1631 = k61 * z496;
    const Scalar z1632 = k61 * z491;
    const Scalar z1633 = k61 * z485;
    const Scalar z1634 = k61 * z478;
    const Scalar z1635 = k61 * z473;
    const Scalar z1636 = k61 * z468;
    const Scalar z1637 = z496 * z1631 - z669;
    const Scalar z1638 = z496 * z1632 + z655;
    const Scalar z1639 = z491 * z1632 - z651;
    const Scalar z1640 = z496 * z1633 - z635;
    const Scalar z1641 = z491 * z1633 - z630;
    const Scalar z1642 = z485 * z1633 - z625;
    const Scalar z1643 = z496 * z1634 - z607;
    const Scalar z1644 = z491 * z1634 - z602;
    const Scalar z1645 = z485 * z1634 + z596;
    const Scalar z1646 = z478 * z1634 - z592;
    const Scalar z1647 = z496 * z1635 - z573;
    const Scalar z1648 = z491 * z1635 - z568;
    const Scalar z1649 = z485 * z1635 - z562;
    const Scalar z1650 = z478 * z1635 + z555;
    const Scalar z1651 = z473 * z1635 - z550;
    const Scalar z1652 = z496 * z1636 - z536;
    const Scalar z1653 = z491 * z1636 + z531;
    const Scalar z1654 = z485 * z1636 + z525;
    const Scalar z1655 = z478 * z1636 - z518;
    const Scalar z1656 = z473 * z1636 - z513;
    const Scalar z1657 = z468 * z1636 - z509;
    const Scalar z1658 = n1 / z1657;
    const Scalar z1659 = z1652 * z1658;
    const Scalar z1660 = z1653 * z1658;
    const Scalar z1661 = z1654 * z1658;
    const Scalar z1662 = z1655 * z1658;
    const Scalar z1663 = z1656 * z1658;
    const Scalar z1664 = z1637 - z1652 * z1659;
    const Scalar z1665 = z1638 - z1652 * z1660;
    const Scalar z1666 = z1639 - z1653 * z1660;
    const Scalar z1667 = z1640 - z1652 * z1661;
    const Scalar z1668 = z1641 - z1653 * z1661;
    const Scalar z1669 = z1642 - z1654 * z1661;
    const Scalar z1670 = z1643 - z1652 * z1662;
    const Scalar z1671 = z1644 - z1653 * z1662;
    const Scalar z1672 = z1645 - z1654 * z1662;
    const Scalar z1673 = z1646 - z1655 * z1662;
    const Scalar z1674 = z1647 - z1652 * z1663;
    const Scalar z1675 = z1648 - z1653 * z1663;
    const Scalar z1676 = z1649 - z1654 * z1663;
    const Scalar z1677 = z1650 - z1655 * z1663;
    const Scalar z1678 = z1651 - z1656 * z1663;
    const Scalar z1679 = n1 / z1678;
    const Scalar z1680 = z1674 * z1679;
    const Scalar z1681 = z1675 * z1679;
    const Scalar z1682 = z1676 * z1679;
    const Scalar z1683 = z1677 * z1679;
    const Scalar z1684 = z1664 - z1674 * z1680;
    const Scalar z1685 = z1665 - z1674 * z1681;
    const Scalar z1686 = z1666 - z1675 * z1681;
    const Scalar z1687 = z1667 - z1674 * z1682;
    const Scalar z1688 = z1668 - z1675 * z1682;
    const Scalar z1689 = z1669 - z1676 * z1682;
    const Scalar z1690 = z1670 - z1674 * z1683;
    const Scalar z1691 = z1671 - z1675 * z1683;
    const Scalar z1692 = z1672 - z1676 * z1683;
    const Scalar z1693 = z1673 - z1677 * z1683;
    const Scalar z1694 = n1 / z1693;
    const Scalar z1695 = z1690 * z1694;
    const Scalar z1696 = z1691 * z1694;
    const Scalar z1697 = z1692 * z1694;
    const Scalar z1698 = z1684 - z1690 * z1695;
    const Scalar z1699 = z1685 - z1690 * z1696;
    const Scalar z1700 = z1686 - z1691 * z1696;
    const Scalar z1701 = z1687 - z1690 * z1697;
    const Scalar z1702 = z1688 - z1691 * z1697;
    const Scalar z1703 = z1689 - z1692 * z1697;
    const Scalar z1704 = n1 / z1703;
    const Scalar z1705 = z1701 * z1704;
    const Scalar z1706 = z1702 * z1704;
    const Scalar z1707 = z1698 - z1701 * z1705;
    const Scalar z1708 = z1699 - z1701 * z1706;
    const Scalar z1709 = z1700 - z1702 * z1706;
    const Scalar z1710 = n1 / z1709;
    const Scalar z1711 = z1708 * z1710;
    const Scalar z1712 = z1707 - z1708 * z1711;
    const Scalar z1713 = n1 / z1712;
    const Scalar z1714 = z1629 + z1630 * z1636;
    const Scalar z1715 = z1628 - z1630 * z1635 + z1663 * z1714;
    const Scalar z1716 = z1627 - z1630 * z1634 + z1662 * z1714 - z1683 * z1715;
    const Scalar z1717 = z1626 + z1630 * z1633 - z1661 * z1714 + z1682 * z1715 + z1697 * z1716;
    const Scalar z1718 = z1625 - z1630 * z1632 + z1660 * z1714 - z1681 * z1715 - z1696 * z1716 + z1706 * z1717;
    const Scalar z1719 = z1624 - z1630 * z1631 + z1659 * z1714 - z1680 * z1715 - z1695 * z1716 + z1705 * z1717 - z1711
        * z1718;
    const Scalar z1720 = z1713 * z1719;
    const Scalar z1721 = z1710 * z1718 - z1711 * z1720;
    const Scalar z1722 = z1704 * z1717 + z1705 * z1720 + z1706 * z1721;
    const Scalar z1723 = z1694 * z1716 - z1695 * z1720 - z1696 * z1721 + z1697 * z1722;
    const Scalar z1724 = z1679 * z1715 - z1680 * z1720 - z1681 * z1721 + z1682 * z1722 - z1683 * z1723;
    const Scalar z1725 = z1658 * z1714 + z1659 * z1720 + z1660 * z1721 - z1661 * z1722 + z1662 * z1723 + z1663 * z1724;
    const Scalar z1726 = k61 * z1630 + z1631 * z1720 + z1632 * z1721 - z1633 * z1722 + z1634 * z1723 + z1635 * z1724
        - z1636 * z1725;
    accelerations.q1 = -z1720;
    accelerations.q2 = -z1721;
    accelerations.q3 = -z1722;
    accelerations.q4 = -z1723;
    accelerations.q5 = -z1724;
    accelerations.q6 = -z1725;
    accelerations.q7 = z1726;
    if (!(traits::regular(-z1712, z669) && traits::regular(-z1709, z651) && traits::regular(-z1703, z625)
        && traits::regular(-z1693, z592) && traits::regular(-z1678, z550) && traits::regular(-z1657,
        z509))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.q1 - accelerations.q1) + (accelerations.q2 - accelerations.q2)
        + (accelerations.q3 - accelerations.q3) + (accelerations.q4 - accelerations.q4) + (accelerations.q5
        - accelerations.q5) + (accelerations.q6 - accelerations.q6) + (accelerations.q7 - accelerations.q7);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar k5 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k6 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k7 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k8 = traits::constant(0.00850351162402155, 0.008503512f, "170070232480431/20000000000000000");
    const Scalar k9 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k10 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k11 = traits::constant(0.028124284712194955, 0.028124284f, "7031071178048739/250000000000000000");
    const Scalar k12 = traits::constant(0.026534991901690206, 0.026534991f, "13267495950845103/500000000000000000");
    const Scalar k13 = traits::constant(0.214708623208, 0.21470863f, "26838577901/125000000000");
    const Scalar k14 = traits::constant(3.228604, 3.228604f, "807151/250000");
    const Scalar k15 = traits::constant(0.126729164208, 0.12672916f, "7920572763/62500000000");
    const Scalar k16 = traits::constant(0.088844724872, 0.088844724f, "11105590609/125000000000");
    const Scalar k17 = traits::constant(0.05649492601407083, 0.056494925f, "3530932875879427/62500000000000000");
    const Scalar k18 = traits::constant(0.008248333140675744, 0.008248333f, "257760410646117/31250000000000000");
    const Scalar k19 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k20 = traits::constant(0.052878381999606115, 0.052878384f, "1652449437487691/31250000000000000");
    const Scalar k21 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k22 = traits::constant(0.01824920229252011, 0.018249203f, "1140575143282507/62500000000000000");
    const Scalar k23 = traits::constant(0.09850206933, 0.09850207f, "9850206933/100000000000");
    const Scalar k24 = traits::constant(3.587895, 3.587895f, "717579/200000");
    const Scalar k25 = traits::constant(0.374644408005, 0.3746444f, "74928881601/200000000000");
    const Scalar k26 = traits::constant(0.19076837715, 0.19076838f, "3815367543/20000000000");
    const Scalar k27 = traits::constant(0.06767727025085991, 0.06767727f, "13535454050171983/200000000000000000");
    const Scalar k28 = traits::constant(0.02771584317362585, 0.027715843f, "554316863472517/20000000000000000");
    const Scalar k29 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k30 = traits::constant(0.03239943042445132, 0.03239943f, "809985760611283/25000000000000000");
    const Scalar k31 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k32 = traits::constant(0.07758614905253959, 0.07758615f, "15517229810507919/200000000000000000");
    const Scalar k33 = traits::constant(0.047121686402, 0.047121685f, "23560843201/500000000000");
    const Scalar k34 = traits::constant(1.225946, 1.225946f, "612973/500000");
    const Scalar k35 = traits::constant(0.05034347249, 0.050343473f, "5034347249/100000000000");
    const Scalar k36 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k37 = traits::constant(0.03942757095803552, 0.03942757f, "9856892739508881/250000000000000000");
    const Scalar k38 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k39 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k40 = traits::constant(0.03146037232526039, 0.03146037f, "7865093081315097/250000000000000000");
    const Scalar k41 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k42 = traits::constant(0.010869510762828565, 0.0108695105f, "2717377690707141/250000000000000000");
    const Scalar k43 = traits::constant(0.017527158935, 0.01752716f, "3505431787/200000000000");
    const Scalar k44 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k45 = traits::constant(0.023526756935, 0.023526756f, "4705351387/200000000000");
    const Scalar k46 = traits::constant(0.100241616695, 0.10024162f, "20048323339/200000000000");
    const Scalar k47 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k48 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k49 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k50 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k51 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k52 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
    const Scalar k53 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k54 = traits::constant(0.735522, 0.735522f, "367761/500000");
    const Scalar k55 = traits::constant(0.015320008390949586, 0.015320009f, "7660004195474793/500000000000000000");
    const Scalar k56 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k57 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k58 = traits::constant(0.012899064612428356, 0.012899064f, "3224766153107089/250000000000000000");
    const Scalar k59 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k60 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k61 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k62 = traits::constant(0.01857971472, 0.018579714f, "116123217/6250000000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k64 = traits::constant(0.004606581888605612, 0.0046065818f, "1151645472151403/250000000000000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k66 = traits::constant(9.8177933583, 9.817793f, "98177933583/10000000000");
    const Scalar k67 = traits::constant(31.67260524, 31.672606f, "791815131/25000000");
    const Scalar k68 = traits::constant(35.19724995, 35.19725f, "703944999/20000000");
    const Scalar k69 = traits::constant(28.37543481, 28.375435f, "2837543481/100000000");
    const Scalar k70 = traits::constant(7.21547082, 7.215471f, "360773541/50000000");
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
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z37 = n0_316 * v_q2;
    const Scalar z38 = n0_316 * z35;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z41 = s_q3 * z38 + c_q3 * z37;
    const Scalar z42 = s_q3 * z37 - c_q3 * z38;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z44 = z42 - n0_0825 * z43;
    const Scalar z45 = n0_0825 * z40;
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z48 = s_q4 * z45 - c_q4 * z41;
    const Scalar z49 = s_q4 * z41 + c_q4 * z45;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z51 = z48 + n0_384 * z50;
    const Scalar z52 = z49 + n0_0825 * z50;
    const Scalar z53 = z44 + n0_384 * z46 - n0_0825 * z47;
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z56 = s_q5 * z53 + c_q5 * z51;
    const Scalar z57 = s_q5 * z51 - c_q5 * z53;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z61 = s_q6 * z52 + c_q6 * z56;
    const Scalar z62 = s_q6 * z56 - c_q6 * z52;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z64 = z62 + n0_088 * z63;
    const Scalar z65 = z57 + n0_088 * z60;
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z68 = s_q7 * z65 + c_q7 * z61;
    const Scalar z69 = s_q7 * z61 - c_q7 * z65;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z399 = n0_316 * c_q2;
    const Scalar z402 = n0_333 + z399;
    const Scalar z409 = n0_0825 * c_q3;
    const Scalar z412 = s_q2 * z409 - n0_316 * c_q2;
    const Scalar z415 = n0_333 - z412;
    const Scalar z422 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z423 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z424 = n0_0825 - z422;
    const Scalar z425 = c_q3 * z424;
    const Scalar z427 = n0_316 - z423;
    const Scalar z429 = s_q2 * z425 - c_q2 * z427;
    const Scalar z432 = n0_333 - z429;
    const Scalar z442 = n0_088 * c_q6;
    const Scalar z443 = n0_088 * s_q6;
    const Scalar z444 = c_q5 * z442;
    const Scalar z445 = s_q5 * z442;
    const Scalar z446 = n0_0825 - z444;
    const Scalar z447 = n0_384 + z443;
    const Scalar z448 = s_q4 * z447 + c_q4 * z446;
    const Scalar z449 = s_q4 * z446 - c_q4 * z447;
    const Scalar z450 = n0_0825 - z448;
    const Scalar z451 = s_q3 * z445 - c_q3 * z450;
    const Scalar z453 = n0_316 - z449;
    const Scalar z455 = s_q2 * z451 + c_q2 * z453;
    const Scalar z458 = n0_333 + z455;
    const Scalar z465 = k5 * s_q7 - k6 * c_q7;
    const Scalar z466 = k6 * s_q7 + k5 * c_q7;
    const Scalar z1727 = k7 * v_q2 - k8 * z35 + k9 * z36;
    const Scalar z1728 = k10 * v_q2 + k9 * z35 - k11 * z36;
    const Scalar z1729 = k12 * v_q2 - k7 * z35 - k10 * z36;
    const Scalar z1730 = k13 * z40 - k14 * z41 + k15 * z43;
    const Scalar z1731 = k13 * z39 - k14 * z42 + k16 * z43;
    const Scalar z1732 = k17 * z39 - k18 * z40 - k13 * z42 - k19 * z43;
    const Scalar z1733 = k18 * z39 - k20 * z40 + k13 * z41 + k21 * z43;
    const Scalar z1734 = k19 * z39 + k21 * z40 + k15 * z41 + k16 * z42 - k22 * z43;
    const Scalar z1735 = k23 * z47 + k24 * z48 + k25 * z50;
    const Scalar z1736 = k23 * z46 + k24 * z49 + k26 * z50;
    const Scalar z1737 = k24 * z44 + k25 * z46 - k26 * z47;
    const Scalar z1738 = k25 * z44 + k27 * z46 - k28 * z47 + k23 * z49 + k29 * z50;
    const Scalar z1739 = k26 * z44 + k28 * z46 - k30 * z47 - k23 * z48 - k31 * z50;
    const Scalar z1740 = k29 * z46 + k31 * z47 + k25 * z48 + k26 * z49 + k32 * z50;
    const Scalar z1741 = k33 * z55 - k34 * z56 - k35 * z58;
    const Scalar z1742 = k33 * z54 - k34 * z57 + k36 * z58;
    const Scalar z1743 = k34 * z52 + k35 * z54 + k36 * z55;
    const Scalar z1744 = k35 * z52 + k37 * z54 - k38 * z55 - k33 * z57 + k39 * z58;
    const Scalar z1745 = k36 * z52 - k38 * z54 + k40 * z55 - k33 * z56 - k41 * z58;
    const Scalar z1746 = k39 * z54 - k41 * z55 + k35 * z56 - k36 * z57 + k42 * z58;
    const Scalar z1747 = k43 * z60 + k44 * z61 - k45 * z63;
    const Scalar z1748 = k43 * z59 + k44 * z62 + k46 * z63;
    const Scalar z1749 = k44 * z57 + k45 * z59 + k46 * z60;
    const Scalar z1750 = k45 * z57 + k47 * z59 + k48 * z60 + k43 * z62 - k49 * z63;
    const Scalar z1751 = k46 * z57 + k48 * z59 + k50 * z60 + k43 * z61 + k51 * z63;
    const Scalar z1752 = k49 * z59 - k51 * z60 + k45 * z61 - k46 * z62 - k52 * z63;
    const Scalar z1753 = k53 * z67 + k54 * z68 - k6 * z70;
    const Scalar z1754 = k53 * z66 - k54 * z69 - k5 * z70;
    const Scalar z1755 = k54 * z64 + k6 * z66 - k5 * z67;
    const Scalar z1756 = k6 * z64 + k55 * z66 + k56 * z67 - k53 * z69 - k57 * z70;
    const Scalar z1757 = k5 * z64 - k56 * z66 - k58 * z67 - k53 * z68 - k59 * z70;
    const Scalar z1758 = k57 * z66 - k59 * z67 + k6 * z68 - k5 * z69 - k60 * z70;
    const Scalar z1762 = k61 * s_q2 + k62 * c_q2;
    const Scalar z1765 = k15 * s_q3 - k16 * c_q3;
    const Scalar z1768 = s_q2 * z1765 - k13 * c_q2;
    const Scalar z1771 = k25 * s_q4 + k26 * c_q4;
    const Scalar z1772 = k26 * s_q4 - k25 * c_q4;
    const Scalar z1773 = k23 * s_q3 - c_q3 * z1771;
    const Scalar z1776 = s_q2 * z1773 + c_q2 * z1772;
    const Scalar z1779 = k35 * s_q5 + k36 * c_q5;
    const Scalar z1780 = k36 * s_q5 - k35 * c_q5;
    const Scalar z1781 = k33 * s_q4 - c_q4 * z1779;
    const Scalar z1782 = s_q4 * z1779 + k33 * c_q4;
    const Scalar z1783 = s_q3 * z1780 + c_q3 * z1781;
    const Scalar z1786 = s_q2 * z1783 + c_q2 * z1782;
    const Scalar z1789 = k45 * s_q6 + k46 * c_q6;
    const Scalar z1790 = k46 * s_q6 - k45 * c_q6;
    const Scalar z1791 = k43 * s_q5 - c_q5 * z1789;
    const Scalar z1792 = s_q5 * z1789 + k43 * c_q5;
    const Scalar z1793 = s_q4 * z1790 + c_q4 * z1791;
    const Scalar z1794 = s_q4 * z1791 - c_q4 * z1790;
    const Scalar z1795 = s_q3 * z1792 + c_q3 * z1793;
    const Scalar z1798 = s_q2 * z1795 - c_q2 * z1794;
    const Scalar z1801 = k53 * s_q6 + c_q6 * z466;
    const Scalar z1802 = s_q6 * z466 - k53 * c_q6;
    const Scalar z1803 = s_q5 * z465 + c_q5 * z1801;
    const Scalar z1804 = s_q5 * z1801 - c_q5 * z465;
    const Scalar z1805 = s_q4 * z1802 - c_q4 * z1803;
    const Scalar z1806 = s_q4 * z1803 + c_q4 * z1802;
    const Scalar z1807 = s_q3 * z1804 + c_q3 * z1805;
    const Scalar z1810 = s_q2 * z1807 + c_q2 * z1806;
    result.kinetic = n0_5 * (-z57 * (z1742 - z1749) + v_q2 * z1729 - z35 * z1727 - z36 * z1728 + z39 * z1732 - z40
        * z1733 - z41 * z1730 - z42 * z1731 - z43 * z1734 + z44 * z1737 + z46 * z1738 - z47 * z1739 + z48 * z1735 + z49
        * z1736 + z50 * z1740 + z52 * z1743 + z54 * z1744 + z55 * z1745 - z56 * z1741 + z58 * z1746 + z59 * z1750 + z60
        * z1751 + z61 * z1747 + z62 * z1748 - z63 * z1752 + z64 * z1755 + z66 * z1756 - z67 * z1757 + z68 * z1753 - z69
        * z1754 - z70 * z1758) + k64 * v_q1 * v_q1;
    result.force_function = -n9_81 * (z1762 + z1768 - z1776 - z1786 + z1798 + z1810) - k66 - k67 * z402 - k68 * z415
        - k69 * z432 - k70 * z458;
    result.power = v_q1 * u_tau1 + v_q2 * u_tau2 + v_q3 * u_tau3 + v_q4 * u_tau4 + v_q5 * u_tau5 + v_q6 * u_tau6 + v_q7
        * u_tau7;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar k0 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k1 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n0_176 = traits::constant(0.176, 0.176f, "22/125");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k19 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n0_768 = traits::constant(0.768, 0.768f, "96/125");
    const Scalar n0_165 = traits::constant(0.165, 0.165f, "33/200");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar n0_632 = traits::constant(0.632, 0.632f, "79/125");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k52 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k53 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k54 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k55 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k56 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k57 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k58 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k59 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k60 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k62 = traits::constant(2.025402344516817, 2.0254023f, "15823455816537633/7812500000000000");
    const Scalar k63 = traits::constant(0.13605107024338747, 0.13605107f, "8503191890211717/62500000000000000");
    const Scalar k64 = traits::constant(1.173353342191997, 1.1733533f, "586676671095998483/500000000000000000");
    const Scalar k65 = traits::constant(0.0513640063978176, 0.051364005f, "8025625999659/156250000000000");
    const Scalar k66 = traits::constant(0.0295053836801595, 0.029505383f, "14752691840079751/500000000000000000");
    const Scalar k67 = traits::constant(0.007330595745882176, 0.0073305955f, "114540558529409/15625000000000000");
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
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z105 = s_q2 * c_q3;
    const Scalar z109 = s_q2 * s_q3;
    const Scalar z139 = s_q3 * c_q4;
    const Scalar z145 = s_q3 * s_q4;
    const Scalar z184 = s_q4 * c_q5;
    const Scalar z192 = s_q4 * s_q5;
    const Scalar z240 = s_q5 * c_q6;
    const Scalar z250 = s_q5 * s_q6;
    const Scalar z307 = s_q6 * c_q7;
    const Scalar z319 = s_q6 * s_q7;
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = c_q6 * z465;
    const Scalar z470 = s_q6 * z465;
    const Scalar z471 = k4 + n0_088 * z466;
    const Scalar z472 = s_q6 * z471 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z471;
    const Scalar z474 = s_q5 * z466 - c_q5 * z469;
    const Scalar z475 = s_q5 * z469 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n0_0825 * z470 - n0_384 * z474 - z477;
    const Scalar z479 = s_q4 * z470 + c_q4 * z474;
    const Scalar z480 = s_q4 * z474 - c_q4 * z470;
    const Scalar z481 = n0_384 * z475 - z476;
    const Scalar z482 = z473 + n0_0825 * z475;
    const Scalar z483 = s_q4 * z482 - c_q4 * z481;
    const Scalar z484 = s_q4 * z481 + c_q4 * z482;
    const Scalar z485 = n0_0825 * z475 - z484;
    const Scalar z486 = s_q3 * z475 + c_q3 * z479;
    const Scalar z487 = s_q3 * z479 - c_q3 * z475;
    const Scalar z488 = z478 + n0_0825 * z480;
    const Scalar z489 = s_q3 * z488 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z488;
    const Scalar z491 = n0_316 * z486 - z490;
    const Scalar z494 = n0_316 * z487 - z489;
    const Scalar z496 = s_q2 * z494 - c_q2 * z485;
    const Scalar z497 = k9 * s_q7 - k10 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k9 - z498;
    const Scalar z500 = k11 + c_q7 * z497;
    const Scalar z501 = n0_088 * z465 - z500;
    const Scalar z502 = k4 + n0_176 * z466;
    const Scalar z503 = n0_176 * z466 + z498;
    const Scalar z504 = k13 + z466;
    const Scalar z505 = k14 - z499;
    const Scalar z506 = k15 - z467;
    const Scalar z507 = k16 + z501;
    const Scalar z508 = k17 + z468;
    const Scalar z509 = k18 + z503;
    const Scalar z510 = s_q6 * z504 - k19 * c_q6;
    const Scalar z511 = k19 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n0_0825 * z511 - n0_384 * z514 - z517;
    const Scalar z519 = s_q4 * z511 + c_q4 * z514;
    const Scalar z520 = s_q4 * z514 - c_q4 * z511;
    const Scalar z521 = n0_384 * z515 + z516;
    const Scalar z522 = z513 - n0_0825 * z515;
    const Scalar z523 = s_q4 * z522 + c_q4 * z521;
    const Scalar z524 = s_q4 * z521 - c_q4 * z522;
    const Scalar z525 = n0_0825 * z515 - z524;
    const Scalar z526 = s_q3 * z515 - c_q3 * z519;
    const Scalar z527 = s_q3 * z519 + c_q3 * z515;
    const Scalar z528 = z518 + n0_0825 * z520;
    const Scalar z529 = s_q3 * z528 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z528;
    const Scalar z531 = n0_316 * z526 + z530;
    const Scalar z534 = n0_316 * z527 - z529;
    const Scalar z536 = s_q2 * z534 + c_q2 * z525;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k21 - z511;
    const Scalar z545 = k22 - z465;
    const Scalar z546 = k23 - z541;
    const Scalar z547 = k24 - z512;
    const Scalar z548 = k25 + z543;
    const Scalar z549 = k26 + z513;
    const Scalar z550 = k27 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n0_384 * z551 - z554;
    const Scalar z556 = c_q4 * z551;
    const Scalar z557 = s_q4 * z551;
    const Scalar z558 = n0_384 * z552 - z553;
    const Scalar z559 = z550 + n0_0825 * z552;
    const Scalar z560 = s_q4 * z559 - c_q4 * z558;
    const Scalar z561 = s_q4 * z558 + c_q4 * z559;
    const Scalar z562 = n0_0825 * z552 - z561;
    const Scalar z563 = s_q3 * z552 + c_q3 * z556;
    const Scalar z564 = s_q3 * z556 - c_q3 * z552;
    const Scalar z565 = z555 - n0_0825 * z557;
    const Scalar z566 = s_q3 * z565 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z565;
    const Scalar z568 = n0_316 * z563 - z567;
    const Scalar z571 = n0_316 * z564 + z566;
    const Scalar z573 = s_q2 * z571 - c_q2 * z562;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n0_768 * z510 + z578;
    const Scalar z582 = n0_0825 * z510 + n0_384 * z552 - z553;
    const Scalar z583 = n0_0825 * z551 + z580;
    const Scalar z584 = z550 + n0_165 * z552;
    const Scalar z585 = n0_768 * z510 + n0_165 * z552 + z579;
    const Scalar z586 = k30 + z552;
    const Scalar z587 = k31 + z510;
    const Scalar z588 = k32 + z581;
    const Scalar z589 = k33 + z582;
    const Scalar z590 = k34 + z583;
    const Scalar z591 = k35 + z555;
    const Scalar z592 = k36 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = c_q3 * z593;
    const Scalar z598 = s_q3 * z593;
    const Scalar z599 = z592 - n0_0825 * z594;
    const Scalar z600 = s_q3 * z599 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z599;
    const Scalar z602 = n0_316 * z597 + z601;
    const Scalar z605 = n0_316 * z598 - z600;
    const Scalar z607 = s_q2 * z605 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = n0_0825 * z551 - z595;
    const Scalar z616 = n0_0825 * z593 - z614;
    const Scalar z617 = z592 - n0_165 * z594;
    const Scalar z618 = n0_165 * z594 - z613;
    const Scalar z619 = k37 - z594;
    const Scalar z620 = k38 - z551;
    const Scalar z621 = k39 + z612;
    const Scalar z622 = k40 - z615;
    const Scalar z623 = k41 - z616;
    const Scalar z624 = k42 + z596;
    const Scalar z625 = k43 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n0_316 * z626 + z629;
    const Scalar z633 = n0_316 * z627 + z628;
    const Scalar z635 = s_q2 * z633 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = n0_632 * z593 - z640;
    const Scalar z644 = n0_632 * z593 - z641;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z633;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z630;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z700 = z39 * z43;
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z721 = z47 * z50;
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z743 = z59 * z63;
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z764 = z67 * z70;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z770 = z754 - z760;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z790 = z738 - z782;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z811 = z55 * z58;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z817 = z801 - z807;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z832 = z711 - z717;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z852 = z695 - z844;
    const Scalar z863 = z36 * z36;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z884 = a_q1 * s_q2;
    const Scalar z885 = a_q1 * c_q2;
    const Scalar z886 = v_q2 * z36 + z884;  // angular acceleration of link2, x
    const Scalar z887 = v_q2 * z35 - z885;  // angular acceleration of link2, y
    const Scalar z888 = a_q2 - z681;
    const Scalar z889 = z679 + z886;
    const Scalar z890 = a_q2 * s_q3 - c_q3 * z886;
    const Scalar z891 = a_q2 * c_q3 + s_q3 * z886;
    const Scalar z892 = z677 - n0_316 * z888;
    const Scalar z893 = n0_316 * z889;
    const Scalar z894 = s_q3 * z893 - c_q3 * z892;
    const Scalar z895 = s_q3 * z892 + c_q3 * z893;
    const Scalar z896 = v_q3 * z40 + z890;  // angular acceleration of link3, x
    const Scalar z897 = v_q3 * z39 - z891;  // angular acceleration of link3, y
    const Scalar z898 = a_q3 - z887;  // angular acceleration of link3, z
    const Scalar z899 = z698 + z898;
    const Scalar z900 = z700 + z897;
    const Scalar z901 = s_q4 * z898 + c_q4 * z896;
    const Scalar z902 = s_q4 * z896 - c_q4 * z898;
    const Scalar z903 = n0_0825 * z697 - z894;
    const Scalar z904 = z895 + n0_0825 * z899;
    const Scalar z905 = z689 + n0_0825 * z900;
    const Scalar z906 = s_q4 * z905 - c_q4 * z903;
    const Scalar z907 = s_q4 * z903 + c_q4 * z905;
    const Scalar z908 = v_q4 * z47 - z901;  // angular acceleration of link4, x
    const Scalar z909 = v_q4 * z46 + z902;  // angular acceleration of link4, y
    const Scalar z910 = a_q4 + z897;  // angular acceleration of link4, z
    const Scalar z911 = z714 + z910;
    const Scalar z912 = z714 - z910;
    const Scalar z913 = z719 + z909;
    const Scalar z914 = z721 + z908;
    const Scalar z915 = s_q5 * z910 + c_q5 * z908;
    const Scalar z916 = s_q5 * z908 - c_q5 * z910;
    const Scalar z917 = n0_0825 * z713 + z906 - n0_384 * z911;
    const Scalar z918 = n0_384 * z718 - z907 - n0_0825 * z912;
    const Scalar z919 = z904 + n0_0825 * z913 + n0_384 * z914;
    const Scalar z920 = s_q5 * z919 + c_q5 * z917;
    const Scalar z921 = s_q5 * z917 - c_q5 * z919;
    const Scalar z922 = v_q5 * z55 + z915;  // angular acceleration of link5, x
    const Scalar z923 = v_q5 * z54 + z916;  // angular acceleration of link5, y
    const Scalar z924 = a_q5 - z909;  // angular acceleration of link5, z
    const Scalar z925 = s_q6 * z924 - c_q6 * z922;
    const Scalar z926 = s_q6 * z922 + c_q6 * z924;
    const Scalar z927 = s_q6 * z918 - c_q6 * z920;
    const Scalar z928 = s_q6 * z920 + c_q6 * z918;
    const Scalar z929 = v_q6 * z60 + z925;  // angular acceleration of link6, x
    const Scalar z930 = v_q6 * z59 - z926;  // angular acceleration of link6, y
    const Scalar z931 = a_q6 - z923;  // angular acceleration of link6, z
    const Scalar z932 = z741 + z931;
    const Scalar z933 = z743 + z930;
    const Scalar z934 = s_q7 * z931 + c_q7 * z929;
    const Scalar z935 = s_q7 * z929 - c_q7 * z931;
    const Scalar z936 = n0_088 * z740 + z927;
    const Scalar z937 = z928 - n0_088 * z932;
    const Scalar z938 = z921 + n0_088 * z933;
    const Scalar z939 = s_q7 * z938 - c_q7 * z936;
    const Scalar z940 = s_q7 * z936 + c_q7 * z938;
    const Scalar z941 = v_q7 * z67 - z934;  // angular acceleration of link7, x
    const Scalar z942 = v_q7 * z66 + z935;  // angular acceleration of link7, y
    const Scalar z943 = a_q7 + z930;  // angular acceleration of link7, z
    const Scalar z944 = z757 + z943;
    const Scalar z945 = z757 - z943;
    const Scalar z946 = z762 + z942;
    const Scalar z947 = z764 + z941;
    const Scalar z948 = z764 - z941;
    const Scalar z949 = z762 - z942;
    const Scalar z950 = k0 * z756 - k1 * z944;  // force on link7, x
    const Scalar z951 = k1 * z761 - k0 * z945;  // force on link7, y
    const Scalar z952 = k0 * z946 + k1 * z947;  // force on link7, z
    const Scalar z953 = k4 * z764 + k2 * z766 + k1 * z937 + k9 * z941 - k3 * z945 - k11 * z946;  // moment on link7, x
    const Scalar z954 = k52 * z762 + k3 * z767 + k0 * z937 + k2 * z944 - k11 * z947;  // moment on link7, y
    // moment on link7, z
    const Scalar z955 = k9 * z757 + k11 * z770 + k1 * z939 + k0 * z940 + k4 * z943 - k3 * z948 - k2 * z949;
    const Scalar z956 = s_q7 * z951 + c_q7 * z950;
    const Scalar z957 = s_q7 * z950 - c_q7 * z951;
    const Scalar z958 = s_q7 * z954 - c_q7 * z953;
    const Scalar z959 = s_q7 * z953 + c_q7 * z954;
    const Scalar z960 = z741 - z931;
    const Scalar z961 = z784 + z929;
    const Scalar z962 = z784 - z929;
    const Scalar z963 = z743 - z930;
    const Scalar z964 = k13 * z740 + z956 + k19 * z960;  // force on link6, x
    const Scalar z965 = k19 * z783 + k13 * z932 - z952;  // force on link6, y
    const Scalar z966 = k13 * z933 - z957 - k19 * z961;  // force on link6, z
    // moment on link6, x
    const Scalar z967 = k18 * z784 + k17 * z786 - k19 * z921 - k14 * z929 - k16 * z932 - k15 * z933 + z958;
    // moment on link6, y
    const Scalar z968 = k53 * z743 + k16 * z787 + k13 * z921 + z955 - n0_088 * z957 + k17 * z960 - k15 * z961;
    // moment on link6, z
    const Scalar z969 = k14 * z741 - k15 * z790 - k19 * z927 - k13 * z928 + k18 * z931 - n0_088 * z952 - z959 + k16
        * z962 + k17 * z963;
    const Scalar z970 = s_q6 * z965 + c_q6 * z964;
    const Scalar z971 = s_q6 * z964 - c_q6 * z965;
    const Scalar z972 = s_q6 * z968 + c_q6 * z967;
    const Scalar z973 = s_q6 * z967 - c_q6 * z968;
    const Scalar z974 = z804 - z924;
    const Scalar z975 = z804 + z924;
    const Scalar z976 = z809 + z923;
    const Scalar z977 = z811 + z922;
    const Scalar z978 = z811 - z922;
    const Scalar z979 = z809 - z923;
    const Scalar z980 = k21 * z803 - z970 + k22 * z974;  // force on link5, x
    const Scalar z981 = k22 * z808 + z966 + k21 * z975;  // force on link5, y
    const Scalar z982 = z971 - k21 * z976 + k22 * z977;  // force on link5, z
    // moment on link5, x
    const Scalar z983 = k27 * z811 - k26 * z813 + k22 * z918 + k23 * z922 - z972 + k25 * z975 + k24 * z976;
    const Scalar z984 = k54 * z809 - k25 * z814 - k21 * z918 - z969 - k26 * z974 + k24 * z977;  // moment on link5, y
    // moment on link5, z
    const Scalar z985 = k23 * z804 - k24 * z817 + k22 * z920 - k21 * z921 - k27 * z924 - z973 + k25 * z978 + k26 * z979;
    const Scalar z986 = s_q5 * z981 + c_q5 * z980;
    const Scalar z987 = s_q5 * z980 - c_q5 * z981;
    const Scalar z988 = s_q5 * z984 + c_q5 * z983;
    const Scalar z989 = s_q5 * z983 - c_q5 * z984;
    const Scalar z990 = z721 - z908;
    const Scalar z991 = z719 - z909;
    const Scalar z992 = k30 * z713 - k31 * z911 + z986;  // force on link4, x
    const Scalar z993 = k31 * z718 - k30 * z912 + z982;  // force on link4, y
    const Scalar z994 = k30 * z913 + k31 * z914 + z987;  // force on link4, z
    // moment on link4, x
    const Scalar z995 = k36 * z721 + k35 * z828 + k31 * z904 + k32 * z908 + k34 * z912 + k33 * z913 + n0_384 * z987
        + z988;
    // moment on link4, y
    const Scalar z996 = k55 * z719 - k34 * z829 + k30 * z904 + k35 * z911 + k33 * z914 + z985 + n0_0825 * z987;
    // moment on link4, z
    const Scalar z997 = k32 * z714 - k33 * z832 - k31 * z906 - k30 * z907 + k36 * z910 + n0_0825 * z982 - n0_384 * z986
        + z989 + k34 * z990 - k35 * z991;
    const Scalar z998 = s_q4 * z993 + c_q4 * z992;
    const Scalar z999 = s_q4 * z992 - c_q4 * z993;
    const Scalar z1000 = s_q4 * z996 - c_q4 * z995;
    const Scalar z1001 = s_q4 * z995 + c_q4 * z996;
    const Scalar z1002 = z698 - z898;
    const Scalar z1003 = z846 + z896;
    const Scalar z1004 = z846 - z896;
    const Scalar z1005 = z700 - z897;
    const Scalar z1006 = k37 * z697 - z998 - k38 * z1002;  // force on link3, x
    const Scalar z1007 = k38 * z845 - k37 * z899 - z994;  // force on link3, y
    // moment on link3, x
    const Scalar z1009 = k38 * z689 + k43 * z846 - k42 * z848 + k39 * z896 - k41 * z899 + k40 * z900 + z1000;
    // moment on link3, y
    const Scalar z1010 = k37 * z689 + k56 * z700 + k41 * z849 + z997 + n0_0825 * z999 - k42 * z1002 + k40 * z1003;
    // moment on link3, z
    const Scalar z1011 = k39 * z698 - k40 * z852 + k38 * z894 - k37 * z895 - k43 * z898 - n0_0825 * z994 + z1001 - k41
        * z1004 + k42 * z1005;
    const Scalar z1012 = s_q3 * z1007 - c_q3 * z1006;
    const Scalar z1013 = s_q3 * z1006 + c_q3 * z1007;
    const Scalar z1014 = s_q3 * z1010 + c_q3 * z1009;
    const Scalar z1015 = s_q3 * z1009 - c_q3 * z1010;
    const Scalar z1016 = a_q2 + z681;
    const Scalar z1017 = z680 + z887;
    const Scalar z1018 = z679 - z886;
    const Scalar z1019 = z680 - z887;
    // moment on link2, x
    const Scalar z1023 = k49 * z679 + k48 * z866 + k45 * z886 - n0_316 * z1013 - z1014 - k47 * z1016 + k46 * z1017;
    const Scalar z1024 = k57 * z680 + k47 * z867 + k48 * z888 + k46 * z889 + z1011;  // moment on link2, y
    // moment on link2, z
    const Scalar z1025 = k49 * a_q2 - k58 * z677 + k59 * z678 - k45 * z681 - k46 * z868 + n0_316 * z1012 + z1015 + k47
        * z1018 - k48 * z1019;
    const Scalar z1029 = s_q2 * z1023 - c_q2 * z1024;
    const Scalar z1034 = k50 * a_q1 + z1029;  // moment on link1, z
    const Scalar z1631 = k60 * z496;
    const Scalar z1632 = k60 * z491;
    const Scalar z1633 = k60 * z485;
    const Scalar z1634 = k60 * z478;
    const Scalar z1635 = k60 * z473;
    const Scalar z1636 = k60 * z468;
    const Scalar z1637 = z496 * z1631 - z669;
    const Scalar z1638 = z496 * z1632 + z655;
    const Scalar z1639 = z491 * z1632 - z651;
    const Scalar z1640 = z496 * z1633 - z635;
    const Scalar z1641 = z491 * z1633 - z630;
    const Scalar z1642 = z485 * z1633 - z625;
    const Scalar z1643 = z496 * z1634 - z607;
    const Scalar z1644 = z491 * z1634 - z602;
    const Scalar z1645 = z485 * z1634 + z596;
    const Scalar z1646 = z478 * z1634 - z592;
    const Scalar z1647 = z496 * z1635 - z573;
    const Scalar z1648 = z491 * z1635 - z568;
    const Scalar z1649 = z485 * z1635 - z562;
    const Scalar z1650 = z478 * z1635 + z555;
    const Scalar z1651 = z473 * z1635 - z550;
    const Scalar z1652 = z496 * z1636 - z536;
    const Scalar z1653 = z491 * z1636 + z531;
    const Scalar z1654 = z485 * z1636 + z525;
    const Scalar z1655 = z478 * z1636 - z518;
    const Scalar z1656 = z473 * z1636 - z513;
    const Scalar z1657 = z468 * z1636 - z509;
    const Scalar z1658 = n1 / z1657;
    const Scalar z1659 = z1652 * z1658;
    const Scalar z1660 = z1653 * z1658;
    const Scalar z1661 = z1654 * z1658;
    const Scalar z1662 = z1655 * z1658;
    const Scalar z1663 = z1656 * z1658;
    const Scalar z1664 = z1637 - z1652 * z1659;
    const Scalar z1665 = z1638 - z1652 * z1660;
    const Scalar z1666 = z1639 - z1653 * z1660;
    const Scalar z1667 = z1640 - z1652 * z1661;
    const Scalar z1668 = z1641 - z1653 * z1661;
    const Scalar z1669 = z1642 - z1654 * z1661;
    const Scalar z1670 = z1643 - z1652 * z1662;
    const Scalar z1671 = z1644 - z1653 * z1662;
    const Scalar z1672 = z1645 - z1654 * z1662;
    const Scalar z1673 = z1646 - z1655 * z1662;
    const Scalar z1674 = z1647 - z1652 * z1663;
    const Scalar z1675 = z1648 - z1653 * z1663;
    const Scalar z1676 = z1649 - z1654 * z1663;
    const Scalar z1677 = z1650 - z1655 * z1663;
    const Scalar z1678 = z1651 - z1656 * z1663;
    const Scalar z1679 = n1 / z1678;
    const Scalar z1680 = z1674 * z1679;
    const Scalar z1681 = z1675 * z1679;
    const Scalar z1682 = z1676 * z1679;
    const Scalar z1683 = z1677 * z1679;
    const Scalar z1684 = z1664 - z1674 * z1680;
    const Scalar z1685 = z1665 - z1674 * z1681;
    const Scalar z1686 = z1666 - z1675 * z1681;
    const Scalar z1687 = z1667 - z1674 * z1682;
    const Scalar z1688 = z1668 - z1675 * z1682;
    const Scalar z1689 = z1669 - z1676 * z1682;
    const Scalar z1690 = z1670 - z1674 * z1683;
    const Scalar z1691 = z1671 - z1675 * z1683;
    const Scalar z1692 = z1672 - z1676 * z1683;
    const Scalar z1693 = z1673 - z1677 * z1683;
    const Scalar z1694 = n1 / z1693;
    const Scalar z1695 = z1690 * z1694;
    const Scalar z1696 = z1691 * z1694;
    const Scalar z1697 = z1692 * z1694;
    const Scalar z1698 = z1684 - z1690 * z1695;
    const Scalar z1699 = z1685 - z1690 * z1696;
    const Scalar z1700 = z1686 - z1691 * z1696;
    const Scalar z1701 = z1687 - z1690 * z1697;
    const Scalar z1702 = z1688 - z1691 * z1697;
    const Scalar z1703 = z1689 - z1692 * z1697;
    const Scalar z1704 = n1 / z1703;
    const Scalar z1705 = z1701 * z1704;
    const Scalar z1706 = z1702 * z1704;
    const Scalar z1707 = z1698 - z1701 * z1705;
    const Scalar z1708 = z1699 - z1701 * z1706;
    const Scalar z1709 = z1700 - z1702 * z1706;
    const Scalar z1710 = n1 / z1709;
    const Scalar z1711 = z1708 * z1710;
    const Scalar z1712 = z1707 - z1708 * z1711;
    const Scalar z1713 = n1 / z1712;
    const Scalar z1900 = v_q2 * c_q2;
    const Scalar z1901 = s_q2 * z36 + c_q2 * z35;
    const Scalar z1902 = n2 * z40 * z109;
    const Scalar z1903 = n2 * c_q2 * z43;
    const Scalar z1904 = z1902 + z1903;
    const Scalar z1905 = s_q3 * z1900;
    const Scalar z1906 = v_q3 * z105 + z1905;
    const Scalar z1907 = c_q2 * s_q4 - c_q4 * z105;
    const Scalar z1908 = c_q2 * c_q4 + s_q4 * z105;
    const Scalar z1909 = z46 * z1908 - z47 * z1907;
    const Scalar z1910 = z1906 - z1909;
    const Scalar z1911 = n2 * z50 * z109;
    const Scalar z1912 = n2 * z46 * z1907;
    const Scalar z1913 = z1911 - z1912;
    const Scalar z1914 = s_q5 * z109 + c_q5 * z1907;
    const Scalar z1915 = s_q6 * z1914 - c_q6 * z1908;
    const Scalar z1916 = n2 * z60 * z1915;
    const Scalar z1917 = s_q5 * z1907 - c_q5 * z109;
    const Scalar z1918 = n2 * z63 * z1917;
    const Scalar z1919 = z1916 - z1918;
    const Scalar z1920 = s_q6 * z1908 + c_q6 * z1914;
    const Scalar z1921 = v_q2 * s_q2;
    const Scalar z1922 = c_q3 * z1900;
    const Scalar z1923 = v_q3 * z109 - z1922;
    const Scalar z1924 = s_q4 * z1921 - c_q4 * z1923;
    const Scalar z1925 = v_q4 * z1908 - z1924;
    const Scalar z1926 = s_q5 * z1906 + c_q5 * z1925;
    const Scalar z1927 = v_q5 * z1917 - z1926;
    const Scalar z1928 = s_q4 * z1923 + c_q4 * z1921;
    const Scalar z1929 = v_q4 * z1907 + z1928;
    const Scalar z1930 = s_q6 * z1927 - c_q6 * z1929;
    const Scalar z1931 = v_q6 * z1920 - z1930;
    const Scalar z1932 = s_q7 * z1917 + c_q7 * z1920;
    const Scalar z1933 = s_q7 * z1920 - c_q7 * z1917;
    const Scalar z1934 = z66 * z1933 + z67 * z1932;
    const Scalar z1935 = z1931 - z1934;
    const Scalar z1936 = n2 * z70 * z1915;
    const Scalar z1937 = n2 * z66 * z1932;
    const Scalar z1938 = z1936 + z1937;
    const Scalar z1939 = k0 * z1935 + k1 * z1938;
    const Scalar z1940 = n2 * z67 * z1933;
    const Scalar z1941 = z1936 + z1940;
    const Scalar z1942 = z1931 + z1934;
    const Scalar z1943 = k0 * z1941 - k1 * z1942;
    const Scalar z1944 = s_q7 * z1939 + c_q7 * z1943;
    const Scalar z1945 = s_q5 * z1925 - c_q5 * z1906;
    const Scalar z1946 = v_q5 * z1914 + z1945;
    const Scalar z1947 = z59 * z1915 - z60 * z1920;
    const Scalar z1948 = z1946 + z1947;
    const Scalar z1949 = k13 * z1919 - z1944 + k19 * z1948;
    const Scalar z1950 = z1946 - z1947;
    const Scalar z1951 = s_q6 * z1929 + c_q6 * z1927;
    const Scalar z1952 = v_q6 * z1915 + z1951;
    const Scalar z1953 = s_q7 * z1952 + c_q7 * z1946;
    const Scalar z1954 = v_q7 * z1932 - z1953;
    const Scalar z1955 = z66 * z1915 + z70 * z1932;
    const Scalar z1956 = z1954 + z1955;
    const Scalar z1957 = s_q7 * z1946 - c_q7 * z1952;
    const Scalar z1958 = v_q7 * z1933 - z1957;
    const Scalar z1959 = z67 * z1915 + z70 * z1933;
    const Scalar z1960 = z1958 + z1959;
    const Scalar z1961 = k0 * z1956 + k1 * z1960;
    const Scalar z1962 = n2 * z59 * z1920;
    const Scalar z1963 = z1918 + z1962;
    const Scalar z1964 = k13 * z1950 - z1961 + k19 * z1963;
    const Scalar z1965 = s_q6 * z1949 + c_q6 * z1964;
    const Scalar z1966 = z54 * z1908 - z58 * z1914;
    const Scalar z1967 = z1946 - z1966;
    const Scalar z1968 = z55 * z1908 + z58 * z1917;
    const Scalar z1969 = z1927 + z1968;
    const Scalar z1970 = z1965 - k21 * z1967 - k22 * z1969;
    const Scalar z1971 = k30 * z1910 + k31 * z1913 + z1970;
    const Scalar z1972 = n2 * z47 * z1908;
    const Scalar z1973 = z1911 + z1972;
    const Scalar z1974 = z1906 + z1909;
    const Scalar z1975 = z59 * z1917 + z63 * z1920;
    const Scalar z1976 = z1931 + z1975;
    const Scalar z1977 = s_q7 * z1943 - c_q7 * z1939;
    const Scalar z1978 = z60 * z1917 - z63 * z1915;
    const Scalar z1979 = z1952 - z1978;
    const Scalar z1980 = k13 * z1976 - z1977 + k19 * z1979;
    const Scalar z1981 = z54 * z1917 - z55 * z1914;
    const Scalar z1982 = z1929 - z1981;
    const Scalar z1983 = n2 * z58 * z1908;
    const Scalar z1984 = n2 * z54 * z1914;
    const Scalar z1985 = z1983 - z1984;
    const Scalar z1986 = z1980 - k21 * z1982 + k22 * z1985;
    const Scalar z1987 = s_q6 * z1964 - c_q6 * z1949;
    const Scalar z1988 = n2 * z55 * z1917;
    const Scalar z1989 = z1983 + z1988;
    const Scalar z1990 = z1929 + z1981;
    const Scalar z1991 = z1987 - k21 * z1989 - k22 * z1990;
    const Scalar z1992 = s_q5 * z1986 - c_q5 * z1991;
    const Scalar z1993 = k30 * z1973 - k31 * z1974 - z1992;
    const Scalar z1994 = s_q4 * z1971 + c_q4 * z1993;
    const Scalar z1995 = z39 * z109 - z40 * z105;
    const Scalar z1996 = z1921 + z1995;
    const Scalar z1997 = k37 * z1904 + z1994 - k38 * z1996;
    const Scalar z1998 = z1921 - z1995;
    const Scalar z1999 = z46 * z109 - z50 * z1907;
    const Scalar z2000 = z1929 - z1999;
    const Scalar z2001 = z47 * z109 + z50 * z1908;
    const Scalar z2002 = z1925 + z2001;
    const Scalar z2003 = s_q5 * z1991 + c_q5 * z1986;
    const Scalar z2004 = k30 * z2000 - k31 * z2002 - z2003;
    const Scalar z2005 = n2 * z39 * z105;
    const Scalar z2006 = z1903 - z2005;
    const Scalar z2007 = k37 * z1998 - z2004 + k38 * z2006;
    const Scalar z2008 = s_q3 * z1997 + c_q3 * z2007;
    const Scalar z2009 = n2 * s_q2 * z35;
    const Scalar z2010 = n0_316 * z2009;
    const Scalar z2011 = c_q2 * z39 - z43 * z105;
    const Scalar z2012 = z1906 - z2011;
    const Scalar z2013 = z2010 + n0_0825 * z2012;
    const Scalar z2014 = n2 * z1900;
    const Scalar z2015 = n0_316 * z2014;
    const Scalar z2016 = n0_316 * z1901;
    const Scalar z2017 = s_q3 * z2015 - c_q3 * z2016;
    const Scalar z2018 = n0_0825 * z1904 - z2017;
    const Scalar z2019 = s_q4 * z2013 + c_q4 * z2018;
    const Scalar z2020 = s_q4 * z2018 - c_q4 * z2013;
    const Scalar z2021 = n0_0825 * z1910 + n0_384 * z1913 + z2020;
    const Scalar z2022 = n0_0825 * z1973 - n0_384 * z1974 + z2019;
    const Scalar z2023 = s_q3 * z2016 + c_q3 * z2015;
    const Scalar z2024 = n0_0825 * z1998 - z2023;
    const Scalar z2025 = n0_0825 * z2000 - n0_384 * z2002 - z2024;
    const Scalar z2026 = s_q5 * z2022 + c_q5 * z2025;
    const Scalar z2027 = n0_088 * z1976 - z2026;
    const Scalar z2028 = s_q5 * z2025 - c_q5 * z2022;
    const Scalar z2029 = s_q6 * z2021 + c_q6 * z2028;
    const Scalar z2030 = n0_088 * z1919 + z2029;
    const Scalar z2031 = s_q7 * z2027 + c_q7 * z2030;
    const Scalar z2032 = s_q7 * z2030 - c_q7 * z2027;
    const Scalar z2033 = z1958 - z1959;
    const Scalar z2034 = z1954 - z1955;
    const Scalar z2035 = z1937 - z1940;
    const Scalar z2036 = k4 * z1931 + k9 * z1934 + k1 * z2031 - k0 * z2032 + k3 * z2033 + k2 * z2034 - k11 * z2035;
    const Scalar z2037 = z1918 - z1962;
    const Scalar z2038 = k17 * z1948 - k53 * z1975 + n0_088 * z1977 - k15 * z1979 + k13 * z2026 - z2036 - k16 * z2037;
    const Scalar z2039 = s_q6 * z2028 - c_q6 * z2021;
    const Scalar z2040 = n0_088 * z1950 - z2039;
    const Scalar z2041 = z1936 - z1937;
    const Scalar z2042 = k2 * z1942 + k52 * z1955 - k11 * z1960 - k0 * z2040 + k3 * z2041;
    const Scalar z2043 = z1936 - z1940;
    const Scalar z2044 = k3 * z1935 - k11 * z1956 + k9 * z1958 + k4 * z1959 - k1 * z2040 - k2 * z2043;
    const Scalar z2045 = s_q7 * z2042 - c_q7 * z2044;
    const Scalar z2046 = z1916 + z1918;
    const Scalar z2047 = k16 * z1950 - k14 * z1952 + k15 * z1976 - k18 * z1978 - k19 * z2026 - z2045 + k17 * z2046;
    const Scalar z2048 = s_q6 * z2038 + c_q6 * z2047;
    const Scalar z2049 = z1983 - z1988;
    const Scalar z2050 = k23 * z1927 - k24 * z1967 + k27 * z1968 - k25 * z1982 - k22 * z2021 + z2048 + k26 * z2049;
    const Scalar z2051 = s_q7 * z2044 + c_q7 * z2042;
    const Scalar z2052 = z1952 + z1978;
    const Scalar z2053 = z1931 - z1975;
    const Scalar z2054 = z1916 + z1962;
    const Scalar z2055 = k18 * z1946 - k14 * z1947 - n0_088 * z1961 + k19 * z2029 - k13 * z2039 - z2051 + k16 * z2052
        - k17 * z2053 + k15 * z2054;
    const Scalar z2056 = z1983 + z1984;
    const Scalar z2057 = k54 * z1966 + k24 * z1969 - k26 * z1990 + k21 * z2021 - z2055 - k25 * z2056;
    const Scalar z2058 = s_q5 * z2050 - c_q5 * z2057;
    const Scalar z2059 = z1925 - z2001;
    const Scalar z2060 = z1929 + z1999;
    const Scalar z2061 = z1912 + z1972;
    const Scalar z2062 = k36 * z1906 + k32 * z1909 + n0_0825 * z1970 + n0_384 * z1992 - k31 * z2019 + k30 * z2020
        - z2058 - k34 * z2059 - k35 * z2060 - k33 * z2061;
    const Scalar z2063 = s_q4 * z1993 - c_q4 * z1971;
    const Scalar z2064 = c_q2 * z40 + z43 * z109;
    const Scalar z2065 = z1923 + z2064;
    const Scalar z2066 = z1903 + z2005;
    const Scalar z2067 = k42 * z1996 + k37 * z2010 - k56 * z2011 + z2062 + n0_0825 * z2063 - k40 * z2065 - k41 * z2066;
    const Scalar z2068 = s_q6 * z2047 - c_q6 * z2038;
    const Scalar z2069 = z1927 - z1968;
    const Scalar z2070 = z1946 + z1966;
    const Scalar z2071 = z1984 + z1988;
    const Scalar z2072 = k27 * z1929 + k23 * z1981 + k21 * z2026 + k22 * z2028 + z2068 - k25 * z2069 + k26 * z2070 - k24
        * z2071;
    const Scalar z2073 = z1911 + z1912;
    const Scalar z2074 = k35 * z1974 + k55 * z1999 + k33 * z2002 + n0_0825 * z2003 + k30 * z2024 - z2072 - k34 * z2073;
    const Scalar z2075 = s_q5 * z2057 + c_q5 * z2050;
    const Scalar z2076 = z1911 - z1972;
    const Scalar z2077 = k34 * z1910 - k32 * z1925 + k33 * z2000 - k36 * z2001 - n0_384 * z2003 - k31 * z2024 + z2075
        + k35 * z2076;
    const Scalar z2078 = s_q4 * z2074 + c_q4 * z2077;
    const Scalar z2079 = z1902 - z1903;
    const Scalar z2080 = k39 * z1923 + k41 * z1998 - k38 * z2010 - k40 * z2012 + k43 * z2064 - z2078 - k42 * z2079;
    const Scalar z2081 = s_q3 * z2067 - c_q3 * z2080;
    const Scalar z2082 = n2 * z1921;
    const Scalar z2083 = n2 * c_q2 * z36;
    const Scalar z2084 = k62 * z1900 - k47 * z1901 - n0_316 * z2008 + z2081 + k46 * z2082 - k48 * z2083;
    const Scalar z2085 = s_q4 * z2077 - c_q4 * z2074;
    const Scalar z2086 = z1923 - z2064;
    const Scalar z2087 = z1906 + z2011;
    const Scalar z2088 = z1902 + z2005;
    const Scalar z2089 = k43 * z1921 + k39 * z1995 - n0_0825 * z2004 + k38 * z2017 - k37 * z2023 + z2085 + k41 * z2086
        + k42 * z2087 - k40 * z2088;
    const Scalar z2090 = k48 * z1901 - k57 * z1921 + k47 * z2009 - k46 * z2014 - z2089;
    const Scalar z2091 = s_q2 * z2084 + c_q2 * z2090;
    const Scalar z2092 = s_q3 * z2007 - c_q3 * z1997;
    const Scalar z2093 = s_q3 * z2080 + c_q3 * z2067;
    const Scalar z2094 = z2009 - z2083;
    const Scalar z2095 = k45 * z1901 - n0_316 * z2092 - z2093 + k46 * z2094;
    const Scalar z2096 = n2 * c_q3 * z40;
    const Scalar z2097 = s_q3 * z36;
    const Scalar z2098 = v_q3 * s_q3 - z2097;
    const Scalar z2099 = z46 * z145 + z47 * z139;
    const Scalar z2100 = z2098 - z2099;
    const Scalar z2101 = n2 * c_q3 * z50;
    const Scalar z2102 = n2 * z46 * z139;
    const Scalar z2103 = z2101 - z2102;
    const Scalar z2104 = c_q3 * s_q5 + c_q5 * z139;
    const Scalar z2105 = s_q6 * z2104 + c_q6 * z145;
    const Scalar z2106 = n2 * z60 * z2105;
    const Scalar z2107 = c_q3 * c_q5 - s_q5 * z139;
    const Scalar z2108 = n2 * z63 * z2107;
    const Scalar z2109 = z2106 + z2108;
    const Scalar z2110 = s_q6 * z145 - c_q6 * z2104;
    const Scalar z2111 = c_q3 * z36;
    const Scalar z2112 = v_q3 * c_q3 - z2111;
    const Scalar z2113 = s_q4 * z35 - c_q4 * z2112;
    const Scalar z2114 = v_q4 * z145 + z2113;
    const Scalar z2115 = s_q5 * z2098 + c_q5 * z2114;
    const Scalar z2116 = v_q5 * z2107 - z2115;
    const Scalar z2117 = s_q4 * z2112 + c_q4 * z35;
    const Scalar z2118 = v_q4 * z139 + z2117;
    const Scalar z2119 = s_q6 * z2116 + c_q6 * z2118;
    const Scalar z2120 = v_q6 * z2110 - z2119;
    const Scalar z2121 = s_q7 * z2107 + c_q7 * z2110;
    const Scalar z2122 = s_q7 * z2110 - c_q7 * z2107;
    const Scalar z2123 = z66 * z2122 + z67 * z2121;
    const Scalar z2124 = z2120 - z2123;
    const Scalar z2125 = n2 * z70 * z2105;
    const Scalar z2126 = n2 * z66 * z2121;
    const Scalar z2127 = z2125 - z2126;
    const Scalar z2128 = k0 * z2124 - k1 * z2127;
    const Scalar z2129 = n2 * z67 * z2122;
    const Scalar z2130 = z2125 - z2129;
    const Scalar z2131 = z2120 + z2123;
    const Scalar z2132 = k0 * z2130 + k1 * z2131;
    const Scalar z2133 = s_q7 * z2128 - c_q7 * z2132;
    const Scalar z2134 = s_q5 * z2114 - c_q5 * z2098;
    const Scalar z2135 = v_q5 * z2104 - z2134;
    const Scalar z2136 = z59 * z2105 + z60 * z2110;
    const Scalar z2137 = z2135 + z2136;
    const Scalar z2138 = k13 * z2109 + z2133 + k19 * z2137;
    const Scalar z2139 = z2135 - z2136;
    const Scalar z2140 = s_q6 * z2118 - c_q6 * z2116;
    const Scalar z2141 = v_q6 * z2105 + z2140;
    const Scalar z2142 = s_q7 * z2141 + c_q7 * z2135;
    const Scalar z2143 = v_q7 * z2121 + z2142;
    const Scalar z2144 = z66 * z2105 - z70 * z2121;
    const Scalar z2145 = z2143 - z2144;
    const Scalar z2146 = s_q7 * z2135 - c_q7 * z2141;
    const Scalar z2147 = v_q7 * z2122 + z2146;
    const Scalar z2148 = z67 * z2105 - z70 * z2122;
    const Scalar z2149 = z2147 - z2148;
    const Scalar z2150 = k0 * z2145 + k1 * z2149;
    const Scalar z2151 = n2 * z59 * z2110;
    const Scalar z2152 = z2108 + z2151;
    const Scalar z2153 = k13 * z2139 + z2150 - k19 * z2152;
    const Scalar z2154 = s_q6 * z2138 + c_q6 * z2153;
    const Scalar z2155 = z54 * z145 + z58 * z2104;
    const Scalar z2156 = z2135 + z2155;
    const Scalar z2157 = z55 * z145 + z58 * z2107;
    const Scalar z2158 = z2116 + z2157;
    const Scalar z2159 = z2154 - k21 * z2156 + k22 * z2158;
    const Scalar z2160 = k30 * z2100 - k31 * z2103 - z2159;
    const Scalar z2161 = n2 * z47 * z145;
    const Scalar z2162 = z2101 - z2161;
    const Scalar z2163 = z2098 + z2099;
    const Scalar z2164 = z59 * z2107 + z63 * z2110;
    const Scalar z2165 = z2120 + z2164;
    const Scalar z2166 = s_q7 * z2132 + c_q7 * z2128;
    const Scalar z2167 = z60 * z2107 + z63 * z2105;
    const Scalar z2168 = z2141 + z2167;
    const Scalar z2169 = k13 * z2165 + z2166 - k19 * z2168;
    const Scalar z2170 = z54 * z2107 + z55 * z2104;
    const Scalar z2171 = z2118 + z2170;
    const Scalar z2172 = n2 * z58 * z145;
    const Scalar z2173 = n2 * z54 * z2104;
    const Scalar z2174 = z2172 + z2173;
    const Scalar z2175 = z2169 + k21 * z2171 + k22 * z2174;
    const Scalar z2176 = s_q6 * z2153 - c_q6 * z2138;
    const Scalar z2177 = n2 * z55 * z2107;
    const Scalar z2178 = z2172 + z2177;
    const Scalar z2179 = z2118 - z2170;
    const Scalar z2180 = z2176 + k21 * z2178 - k22 * z2179;
    const Scalar z2181 = s_q5 * z2175 + c_q5 * z2180;
    const Scalar z2182 = k30 * z2162 + k31 * z2163 + z2181;
    const Scalar z2183 = s_q4 * z2160 - c_q4 * z2182;
    const Scalar z2184 = s_q3 * z40 + c_q3 * z39;
    const Scalar z2185 = z35 + z2184;
    const Scalar z2186 = k37 * z2096 - z2183 - k38 * z2185;
    const Scalar z2187 = z35 - z2184;
    const Scalar z2188 = c_q3 * z46 - z50 * z139;
    const Scalar z2189 = z2118 - z2188;
    const Scalar z2190 = c_q3 * z47 - z50 * z145;
    const Scalar z2191 = z2114 - z2190;
    const Scalar z2192 = s_q5 * z2180 - c_q5 * z2175;
    const Scalar z2193 = k30 * z2189 + k31 * z2191 - z2192;
    const Scalar z2194 = n2 * s_q3 * z39;
    const Scalar z2195 = k37 * z2187 - z2193 + k38 * z2194;
    const Scalar z2196 = s_q3 * z2186 + c_q3 * z2195;
    const Scalar z2197 = n2 * v_q2;
    const Scalar z2198 = n0_316 * z2197;
    const Scalar z2199 = s_q3 * z43;
    const Scalar z2200 = z2098 + z2199;
    const Scalar z2201 = z2198 - n0_0825 * z2200;
    const Scalar z2202 = n2 * z36;
    const Scalar z2203 = n0_316 * z2202;
    const Scalar z2204 = s_q3 * z2203;
    const Scalar z2205 = n0_0825 * z2096 - z2204;
    const Scalar z2206 = s_q4 * z2201 + c_q4 * z2205;
    const Scalar z2207 = s_q4 * z2205 - c_q4 * z2201;
    const Scalar z2208 = n0_0825 * z2100 - n0_384 * z2103 - z2207;
    const Scalar z2209 = n0_0825 * z2162 + n0_384 * z2163 + z2206;
    const Scalar z2210 = c_q3 * z2203;
    const Scalar z2211 = n0_0825 * z2187 - z2210;
    const Scalar z2212 = n0_0825 * z2189 + n0_384 * z2191 - z2211;
    const Scalar z2213 = s_q5 * z2209 + c_q5 * z2212;
    const Scalar z2214 = n0_088 * z2165 + z2213;
    const Scalar z2215 = s_q5 * z2212 - c_q5 * z2209;
    const Scalar z2216 = s_q6 * z2208 - c_q6 * z2215;
    const Scalar z2217 = n0_088 * z2109 - z2216;
    const Scalar z2218 = s_q7 * z2214 - c_q7 * z2217;
    const Scalar z2219 = s_q7 * z2217 + c_q7 * z2214;
    const Scalar z2220 = z2147 + z2148;
    const Scalar z2221 = z2143 + z2144;
    const Scalar z2222 = z2126 - z2129;
    const Scalar z2223 = k4 * z2120 + k9 * z2123 + k1 * z2218 + k0 * z2219 + k3 * z2220 + k2 * z2221 - k11 * z2222;
    const Scalar z2224 = z2108 - z2151;
    const Scalar z2225 = k17 * z2137 + k53 * z2164 + n0_088 * z2166 - k15 * z2168 + k13 * z2213 + z2223 + k16 * z2224;
    const Scalar z2226 = s_q6 * z2215 + c_q6 * z2208;
    const Scalar z2227 = n0_088 * z2139 - z2226;
    const Scalar z2228 = z2125 + z2126;
    const Scalar z2229 = k2 * z2131 - k52 * z2144 - k11 * z2149 + k0 * z2227 - k3 * z2228;
    const Scalar z2230 = z2125 + z2129;
    const Scalar z2231 = k3 * z2124 - k11 * z2145 + k9 * z2147 - k4 * z2148 + k1 * z2227 + k2 * z2230;
    const Scalar z2232 = s_q7 * z2229 - c_q7 * z2231;
    const Scalar z2233 = z2106 - z2108;
    const Scalar z2234 = k16 * z2139 - k14 * z2141 - k15 * z2165 + k18 * z2167 - k19 * z2213 + z2232 + k17 * z2233;
    const Scalar z2235 = s_q6 * z2225 + c_q6 * z2234;
    const Scalar z2236 = z2172 - z2177;
    const Scalar z2237 = k23 * z2116 + k24 * z2156 + k27 * z2157 + k25 * z2171 - k22 * z2208 - z2235 + k26 * z2236;
    const Scalar z2238 = s_q7 * z2231 + c_q7 * z2229;
    const Scalar z2239 = z2141 - z2167;
    const Scalar z2240 = z2120 - z2164;
    const Scalar z2241 = z2106 - z2151;
    const Scalar z2242 = k18 * z2135 - k14 * z2136 + n0_088 * z2150 - k19 * z2216 - k13 * z2226 + z2238 + k16 * z2239
        + k17 * z2240 + k15 * z2241;
    const Scalar z2243 = z2172 - z2173;
    const Scalar z2244 = k54 * z2155 + k24 * z2158 + k26 * z2179 + k21 * z2208 + z2242 - k25 * z2243;
    const Scalar z2245 = s_q5 * z2237 - c_q5 * z2244;
    const Scalar z2246 = z2114 + z2190;
    const Scalar z2247 = z2118 + z2188;
    const Scalar z2248 = z2102 - z2161;
    const Scalar z2249 = k36 * z2098 + k32 * z2099 - n0_0825 * z2159 + n0_384 * z2181 + k31 * z2206 - k30 * z2207
        - z2245 - k34 * z2246 + k35 * z2247 + k33 * z2248;
    const Scalar z2250 = s_q4 * z2182 + c_q4 * z2160;
    const Scalar z2251 = c_q3 * z43;
    const Scalar z2252 = z2112 + z2251;
    const Scalar z2253 = k42 * z2185 + k41 * z2194 + k37 * z2198 - k56 * z2199 - z2249 + n0_0825 * z2250 - k40 * z2252;
    const Scalar z2254 = s_q6 * z2234 - c_q6 * z2225;
    const Scalar z2255 = z2116 - z2157;
    const Scalar z2256 = z2135 - z2155;
    const Scalar z2257 = z2173 - z2177;
    const Scalar z2258 = k27 * z2118 - k23 * z2170 + k21 * z2213 + k22 * z2215 + z2254 + k25 * z2255 + k26 * z2256 - k24
        * z2257;
    const Scalar z2259 = z2101 + z2102;
    const Scalar z2260 = k35 * z2163 - k55 * z2188 + k33 * z2191 - n0_0825 * z2192 - k30 * z2211 + z2258 + k34 * z2259;
    const Scalar z2261 = s_q5 * z2244 + c_q5 * z2237;
    const Scalar z2262 = z2101 + z2161;
    const Scalar z2263 = k34 * z2100 - k32 * z2114 - k33 * z2189 + k36 * z2190 + n0_384 * z2192 + k31 * z2211 + z2261
        - k35 * z2262;
    const Scalar z2264 = s_q4 * z2260 + c_q4 * z2263;
    const Scalar z2265 = k42 * z2096 - k39 * z2112 - k41 * z2187 + k38 * z2198 - k40 * z2200 - k43 * z2251 - z2264;
    const Scalar z2266 = s_q3 * z2253 + c_q3 * z2265;
    const Scalar z2267 = n2 * z35;
    const Scalar z2268 = k62 * z36 - n0_316 * z2196 + k48 * z2197 + z2266 + k46 * z2267;
    const Scalar z2269 = s_q4 * z2263 - c_q4 * z2260;
    const Scalar z2270 = z2112 - z2251;
    const Scalar z2271 = z2098 - z2199;
    const Scalar z2272 = z2096 - z2194;
    const Scalar z2273 = k43 * z35 + k39 * z2184 - n0_0825 * z2193 + k38 * z2204 - k37 * z2210 - z2269 + k41 * z2270
        - k42 * z2271 - k40 * z2272;
    const Scalar z2274 = k57 * z35 + k47 * z2197 + k46 * z2202 + z2273;
    const Scalar z2275 = s_q2 * z2268 - c_q2 * z2274;
    const Scalar z2276 = n2 * z35 * z36;
    const Scalar z2277 = n2 * z40 * z2097;
    const Scalar z2278 = n2 * z35 * z43;
    const Scalar z2279 = z2277 - z2278;
    const Scalar z2280 = n2 * z50 * z2097;
    const Scalar z2281 = s_q4 * z35 + c_q4 * z2111;
    const Scalar z2282 = n2 * z46 * z2281;
    const Scalar z2283 = z2280 + z2282;
    const Scalar z2284 = s_q4 * z2111 - c_q4 * z35;
    const Scalar z2285 = z46 * z2284 + z47 * z2281;
    const Scalar z2286 = s_q3 * z887;
    const Scalar z2287 = v_q3 * z2111 - z2286;
    const Scalar z2288 = z2285 - z2287;
    const Scalar z2289 = s_q5 * z2097 - c_q5 * z2281;
    const Scalar z2290 = s_q6 * z2289 - c_q6 * z2284;
    const Scalar z2291 = n2 * z60 * z2290;
    const Scalar z2292 = s_q5 * z2281 + c_q5 * z2097;
    const Scalar z2293 = n2 * z63 * z2292;
    const Scalar z2294 = z2291 + z2293;
    const Scalar z2295 = n2 * z70 * z2290;
    const Scalar z2296 = s_q6 * z2284 + c_q6 * z2289;
    const Scalar z2297 = s_q7 * z2292 - c_q7 * z2296;
    const Scalar z2298 = n2 * z66 * z2297;
    const Scalar z2299 = z2295 - z2298;
    const Scalar z2300 = s_q7 * z2296 + c_q7 * z2292;
    const Scalar z2301 = z66 * z2300 - z67 * z2297;
    const Scalar z2302 = c_q3 * z887;
    const Scalar z2303 = v_q3 * z2097 + z2302;
    const Scalar z2304 = s_q4 * z886 - c_q4 * z2303;
    const Scalar z2305 = v_q4 * z2284 - z2304;
    const Scalar z2306 = s_q5 * z2287 + c_q5 * z2305;
    const Scalar z2307 = v_q5 * z2292 + z2306;
    const Scalar z2308 = s_q4 * z2303 + c_q4 * z886;
    const Scalar z2309 = v_q4 * z2281 - z2308;
    const Scalar z2310 = s_q6 * z2307 - c_q6 * z2309;
    const Scalar z2311 = v_q6 * z2296 + z2310;
    const Scalar z2312 = z2301 - z2311;
    const Scalar z2313 = k1 * z2299 - k0 * z2312;
    const Scalar z2314 = n2 * z67 * z2300;
    const Scalar z2315 = z2295 + z2314;
    const Scalar z2316 = z2301 + z2311;
    const Scalar z2317 = k0 * z2315 - k1 * z2316;
    const Scalar z2318 = s_q7 * z2313 + c_q7 * z2317;
    const Scalar z2319 = z59 * z2290 - z60 * z2296;
    const Scalar z2320 = s_q5 * z2305 - c_q5 * z2287;
    const Scalar z2321 = v_q5 * z2289 + z2320;
    const Scalar z2322 = z2319 + z2321;
    const Scalar z2323 = k13 * z2294 - z2318 + k19 * z2322;
    const Scalar z2324 = n2 * z59 * z2296;
    const Scalar z2325 = z2293 - z2324;
    const Scalar z2326 = z2319 - z2321;
    const Scalar z2327 = z66 * z2290 - z70 * z2297;
    const Scalar z2328 = s_q6 * z2309 + c_q6 * z2307;
    const Scalar z2329 = v_q6 * z2290 - z2328;
    const Scalar z2330 = s_q7 * z2329 + c_q7 * z2321;
    const Scalar z2331 = v_q7 * z2297 + z2330;
    const Scalar z2332 = z2327 - z2331;
    const Scalar z2333 = z67 * z2290 + z70 * z2300;
    const Scalar z2334 = s_q7 * z2321 - c_q7 * z2329;
    const Scalar z2335 = v_q7 * z2300 - z2334;
    const Scalar z2336 = z2333 + z2335;
    const Scalar z2337 = k0 * z2332 + k1 * z2336;
    const Scalar z2338 = k19 * z2325 + k13 * z2326 + z2337;
    const Scalar z2339 = s_q6 * z2323 - c_q6 * z2338;
    const Scalar z2340 = z54 * z2284 - z58 * z2289;
    const Scalar z2341 = z2321 - z2340;
    const Scalar z2342 = z55 * z2284 - z58 * z2292;
    const Scalar z2343 = z2307 - z2342;
    const Scalar z2344 = z2339 - k21 * z2341 + k22 * z2343;
    const Scalar z2345 = k31 * z2283 - k30 * z2288 + z2344;
    const Scalar z2346 = n2 * z47 * z2284;
    const Scalar z2347 = z2280 + z2346;
    const Scalar z2348 = z2285 + z2287;
    const Scalar z2349 = n2 * z58 * z2284;
    const Scalar z2350 = n2 * z54 * z2289;
    const Scalar z2351 = z2349 - z2350;
    const Scalar z2352 = z59 * z2292 - z63 * z2296;
    const Scalar z2353 = z2311 - z2352;
    const Scalar z2354 = s_q7 * z2317 - c_q7 * z2313;
    const Scalar z2355 = z60 * z2292 + z63 * z2290;
    const Scalar z2356 = z2329 + z2355;
    const Scalar z2357 = k13 * z2353 - z2354 + k19 * z2356;
    const Scalar z2358 = z54 * z2292 + z55 * z2289;
    const Scalar z2359 = z2309 - z2358;
    const Scalar z2360 = k22 * z2351 + z2357 + k21 * z2359;
    const Scalar z2361 = n2 * z55 * z2292;
    const Scalar z2362 = z2349 - z2361;
    const Scalar z2363 = s_q6 * z2338 + c_q6 * z2323;
    const Scalar z2364 = z2309 + z2358;
    const Scalar z2365 = k21 * z2362 + z2363 - k22 * z2364;
    const Scalar z2366 = s_q5 * z2360 + c_q5 * z2365;
    const Scalar z2367 = k30 * z2347 - k31 * z2348 - z2366;
    const Scalar z2368 = s_q4 * z2345 + c_q4 * z2367;
    const Scalar z2369 = z39 * z2097 - z40 * z2111;
    const Scalar z2370 = z886 + z2369;
    const Scalar z2371 = k37 * z2279 + z2368 - k38 * z2370;
    const Scalar z2372 = n2 * z39 * z2111;
    const Scalar z2373 = z2278 + z2372;
    const Scalar z2374 = z886 - z2369;
    const Scalar z2375 = z46 * z2097 + z50 * z2281;
    const Scalar z2376 = z2309 + z2375;
    const Scalar z2377 = z47 * z2097 + z50 * z2284;
    const Scalar z2378 = z2305 + z2377;
    const Scalar z2379 = s_q5 * z2365 - c_q5 * z2360;
    const Scalar z2380 = k30 * z2376 + k31 * z2378 - z2379;
    const Scalar z2381 = k38 * z2373 - k37 * z2374 - z2380;
    const Scalar z2382 = s_q3 * z2371 - c_q3 * z2381;
    const Scalar z2383 = z677 + n0_316 * z2276;
    const Scalar z2384 = z35 * z39 + z43 * z2111;
    const Scalar z2385 = z2278 - z2372;
    const Scalar z2386 = z2282 - z2346;
    const Scalar z2387 = z2287 + z2384;
    const Scalar z2388 = z2383 + n0_0825 * z2387;
    const Scalar z2389 = n0_316 * z1017;
    const Scalar z2390 = z35 * z35 - z36 * z36;
    const Scalar z2391 = z678 - n0_316 * z2390;
    const Scalar z2392 = s_q3 * z2389 + c_q3 * z2391;
    const Scalar z2393 = n0_0825 * z2279 + z2392;
    const Scalar z2394 = s_q4 * z2388 + c_q4 * z2393;
    const Scalar z2395 = s_q4 * z2393 - c_q4 * z2388;
    const Scalar z2396 = z2349 + z2361;
    const Scalar z2397 = n0_384 * z2283 - n0_0825 * z2288 + z2395;
    const Scalar z2398 = z2293 + z2324;
    const Scalar z2399 = n0_0825 * z2347 - n0_384 * z2348 + z2394;
    const Scalar z2400 = s_q3 * z2391 - c_q3 * z2389;
    const Scalar z2401 = n0_0825 * z2374 - z2400;
    const Scalar z2402 = n0_0825 * z2376 + n0_384 * z2378 + z2401;
    const Scalar z2403 = s_q5 * z2399 - c_q5 * z2402;
    const Scalar z2404 = z2298 + z2314;
    const Scalar z2405 = n0_088 * z2353 - z2403;
    const Scalar z2406 = s_q5 * z2402 + c_q5 * z2399;
    const Scalar z2407 = s_q6 * z2397 - c_q6 * z2406;
    const Scalar z2408 = n0_088 * z2294 + z2407;
    const Scalar z2409 = s_q7 * z2405 + c_q7 * z2408;
    const Scalar z2410 = s_q7 * z2408 - c_q7 * z2405;
    const Scalar z2411 = z2333 - z2335;
    const Scalar z2412 = z2327 + z2331;
    const Scalar z2413 = k9 * z2301 + k4 * z2311 + k11 * z2404 + k1 * z2409 - k0 * z2410 - k3 * z2411 - k2 * z2412;
    const Scalar z2414 = k17 * z2322 + k53 * z2352 + n0_088 * z2354 - k15 * z2356 + k16 * z2398 + k13 * z2403 - z2413;
    const Scalar z2415 = z2291 - z2293;
    const Scalar z2416 = z2295 + z2298;
    const Scalar z2417 = s_q6 * z2406 + c_q6 * z2397;
    const Scalar z2418 = n0_088 * z2326 - z2417;
    const Scalar z2419 = k2 * z2316 + k52 * z2327 - k11 * z2336 + k3 * z2416 + k0 * z2418;
    const Scalar z2420 = z2295 - z2314;
    const Scalar z2421 = k3 * z2312 + k11 * z2332 - k4 * z2333 - k9 * z2335 - k1 * z2418 + k2 * z2420;
    const Scalar z2422 = s_q7 * z2419 + c_q7 * z2421;
    const Scalar z2423 = k16 * z2326 + k14 * z2329 - k15 * z2353 - k18 * z2355 + k19 * z2403 - k17 * z2415 + z2422;
    const Scalar z2424 = s_q6 * z2414 - c_q6 * z2423;
    const Scalar z2425 = k23 * z2307 + k24 * z2341 - k27 * z2342 - k25 * z2359 - k26 * z2396 + k22 * z2397 - z2424;
    const Scalar z2426 = z2349 + z2350;
    const Scalar z2427 = z2291 + z2324;
    const Scalar z2428 = s_q7 * z2421 - c_q7 * z2419;
    const Scalar z2429 = z2329 - z2355;
    const Scalar z2430 = z2311 + z2352;
    const Scalar z2431 = k14 * z2319 - k18 * z2321 + n0_088 * z2337 - k19 * z2407 - k13 * z2417 - k15 * z2427 - z2428
        - k16 * z2429 + k17 * z2430;
    const Scalar z2432 = k54 * z2340 - k24 * z2343 + k26 * z2364 + k21 * z2397 - k25 * z2426 + z2431;
    const Scalar z2433 = s_q5 * z2425 + c_q5 * z2432;
    const Scalar z2434 = z2305 - z2377;
    const Scalar z2435 = z2309 - z2375;
    const Scalar z2436 = k32 * z2285 + k36 * z2287 + n0_0825 * z2344 + n0_384 * z2366 + k33 * z2386 - k31 * z2394 + k30
        * z2395 + z2433 - k34 * z2434 + k35 * z2435;
    const Scalar z2437 = s_q4 * z2367 - c_q4 * z2345;
    const Scalar z2438 = z35 * z40 - z43 * z2097;
    const Scalar z2439 = z2303 - z2438;
    const Scalar z2440 = k42 * z2370 + k37 * z2383 + k56 * z2384 + k41 * z2385 + z2436 + n0_0825 * z2437 - k40 * z2439;
    const Scalar z2441 = z2277 + z2278;
    const Scalar z2442 = z2280 - z2282;
    const Scalar z2443 = z2350 - z2361;
    const Scalar z2444 = s_q6 * z2423 + c_q6 * z2414;
    const Scalar z2445 = z2307 + z2342;
    const Scalar z2446 = z2321 + z2340;
    const Scalar z2447 = k27 * z2309 + k23 * z2358 - k21 * z2403 + k22 * z2406 + k24 * z2443 + z2444 - k25 * z2445 - k26
        * z2446;
    const Scalar z2448 = k35 * z2348 + k55 * z2375 + k33 * z2378 - n0_0825 * z2379 + k30 * z2401 - k34 * z2442 + z2447;
    const Scalar z2449 = z2280 - z2346;
    const Scalar z2450 = s_q5 * z2432 - c_q5 * z2425;
    const Scalar z2451 = k34 * z2288 + k32 * z2305 + k33 * z2376 + k36 * z2377 - n0_384 * z2379 + k31 * z2401 - k35
        * z2449 - z2450;
    const Scalar z2452 = s_q4 * z2448 - c_q4 * z2451;
    const Scalar z2453 = k39 * z2303 + k41 * z2374 - k38 * z2383 - k40 * z2387 - k43 * z2438 - k42 * z2441 - z2452;
    const Scalar z2454 = s_q3 * z2440 - c_q3 * z2453;
    const Scalar z2455 = k49 * z680 + k45 * z887 - k46 * z889 - k48 * z2276 + n0_316 * z2382 - k47 * z2390 - z2454;
    const Scalar z2456 = z2277 + z2372;
    const Scalar z2457 = s_q4 * z2451 + c_q4 * z2448;
    const Scalar z2458 = z2303 + z2438;
    const Scalar z2459 = z2287 - z2384;
    const Scalar z2460 = k43 * z886 + k39 * z2369 + n0_0825 * z2380 - k38 * z2392 - k37 * z2400 - k40 * z2456 - z2457
        + k41 * z2458 + k42 * z2459;
    const Scalar z2461 = k57 * z679 - k46 * z1017 - k47 * z2276 + k48 * z2390 + z2460;
    const Scalar z2462 = s_q2 * (z1024 - z2455) + c_q2 * (z1023 - z2461);
    const Scalar z2463 = s_q3 * z2195 - c_q3 * z2186;
    const Scalar z2464 = s_q3 * z2265 - c_q3 * z2253;
    const Scalar z2465 = n0_316 * z2463 - z2464;
    const Scalar z2466 = n2 * z2276;
    const Scalar z2467 = s_q3 * z2381 + c_q3 * z2371;
    const Scalar z2468 = s_q3 * z2453 + c_q3 * z2440;
    const Scalar z2469 = k59 * z677 + k58 * z678 + k48 * z1018 + k47 * z1019 - k45 * z2390 + k46 * z2466 + n0_316
        * z2467 - z2468;
    const Scalar z2470 = n2 * z43;
    const Scalar z2471 = s_q4 * z47 - c_q4 * z46;
    const Scalar z2472 = z39 - z2471;
    const Scalar z2473 = n2 * s_q4 * z46;
    const Scalar z2474 = c_q4 * c_q6 - s_q6 * z184;
    const Scalar z2475 = n2 * z60 * z2474;
    const Scalar z2476 = n2 * z63 * z192;
    const Scalar z2477 = z2475 + z2476;
    const Scalar z2478 = c_q4 * s_q6 + c_q6 * z184;
    const Scalar z2479 = c_q4 * z40;
    const Scalar z2480 = v_q4 * c_q4 + z2479;
    const Scalar z2481 = s_q5 * z39 - c_q5 * z2480;
    const Scalar z2482 = v_q5 * z192 + z2481;
    const Scalar z2483 = s_q4 * z40;
    const Scalar z2484 = v_q4 * s_q4 + z2483;
    const Scalar z2485 = s_q6 * z2482 - c_q6 * z2484;
    const Scalar z2486 = v_q6 * z2478 - z2485;
    const Scalar z2487 = s_q7 * z192 + c_q7 * z2478;
    const Scalar z2488 = s_q7 * z2478 - c_q7 * z192;
    const Scalar z2489 = z66 * z2488 + z67 * z2487;
    const Scalar z2490 = z2486 - z2489;
    const Scalar z2491 = n2 * z70 * z2474;
    const Scalar z2492 = n2 * z66 * z2487;
    const Scalar z2493 = z2491 - z2492;
    const Scalar z2494 = k0 * z2490 - k1 * z2493;
    const Scalar z2495 = n2 * z67 * z2488;
    const Scalar z2496 = z2491 - z2495;
    const Scalar z2497 = z2486 + z2489;
    const Scalar z2498 = k0 * z2496 + k1 * z2497;
    const Scalar z2499 = s_q7 * z2494 - c_q7 * z2498;
    const Scalar z2500 = s_q5 * z2480 + c_q5 * z39;
    const Scalar z2501 = v_q5 * z184 + z2500;
    const Scalar z2502 = z59 * z2474 + z60 * z2478;
    const Scalar z2503 = z2501 - z2502;
    const Scalar z2504 = k13 * z2477 + z2499 - k19 * z2503;
    const Scalar z2505 = z2501 + z2502;
    const Scalar z2506 = s_q6 * z2484 + c_q6 * z2482;
    const Scalar z2507 = v_q6 * z2474 - z2506;
    const Scalar z2508 = s_q7 * z2507 - c_q7 * z2501;
    const Scalar z2509 = v_q7 * z2487 + z2508;
    const Scalar z2510 = z66 * z2474 - z70 * z2487;
    const Scalar z2511 = z2509 - z2510;
    const Scalar z2512 = s_q7 * z2501 + c_q7 * z2507;
    const Scalar z2513 = v_q7 * z2488 - z2512;
    const Scalar z2514 = z67 * z2474 - z70 * z2488;
    const Scalar z2515 = z2513 - z2514;
    const Scalar z2516 = k0 * z2511 + k1 * z2515;
    const Scalar z2517 = n2 * z59 * z2478;
    const Scalar z2518 = z2476 + z2517;
    const Scalar z2519 = k13 * z2505 - z2516 + k19 * z2518;
    const Scalar z2520 = s_q6 * z2504 - c_q6 * z2519;
    const Scalar z2521 = c_q4 * z54 - z58 * z184;
    const Scalar z2522 = z2501 - z2521;
    const Scalar z2523 = c_q4 * z55 + z58 * z192;
    const Scalar z2524 = z2482 + z2523;
    const Scalar z2525 = z2520 + k21 * z2522 + k22 * z2524;
    const Scalar z2526 = k30 * z2472 + k31 * z2473 + z2525;
    const Scalar z2527 = n2 * c_q4 * z47;
    const Scalar z2528 = z39 + z2471;
    const Scalar z2529 = z59 * z192 + z63 * z2478;
    const Scalar z2530 = z2486 + z2529;
    const Scalar z2531 = s_q7 * z2498 + c_q7 * z2494;
    const Scalar z2532 = z60 * z192 + z63 * z2474;
    const Scalar z2533 = z2507 + z2532;
    const Scalar z2534 = k13 * z2530 + z2531 - k19 * z2533;
    const Scalar z2535 = z54 * z192 - z55 * z184;
    const Scalar z2536 = z2484 - z2535;
    const Scalar z2537 = n2 * c_q4 * z58;
    const Scalar z2538 = n2 * z54 * z184;
    const Scalar z2539 = z2537 - z2538;
    const Scalar z2540 = z2534 - k21 * z2536 + k22 * z2539;
    const Scalar z2541 = s_q6 * z2519 + c_q6 * z2504;
    const Scalar z2542 = n2 * z55 * z192;
    const Scalar z2543 = z2537 + z2542;
    const Scalar z2544 = z2484 + z2535;
    const Scalar z2545 = z2541 - k21 * z2543 - k22 * z2544;
    const Scalar z2546 = s_q5 * z2540 - c_q5 * z2545;
    const Scalar z2547 = k30 * z2527 + k31 * z2528 - z2546;
    const Scalar z2548 = s_q4 * z2526 - c_q4 * z2547;
    const Scalar z2549 = k37 * z2470 - z2548;
    const Scalar z2550 = s_q4 * z50;
    const Scalar z2551 = z2484 + z2550;
    const Scalar z2552 = c_q4 * z50;
    const Scalar z2553 = z2480 + z2552;
    const Scalar z2554 = s_q5 * z2545 + c_q5 * z2540;
    const Scalar z2555 = k30 * z2551 - k31 * z2553 - z2554;
    const Scalar z2556 = k38 * z2470 - z2555;
    const Scalar z2557 = s_q3 * z2549 + c_q3 * z2556;
    const Scalar z2558 = n2 * z39;
    const Scalar z2559 = n0_0825 * z2558;
    const Scalar z2560 = n0_0825 * z2470;
    const Scalar z2561 = s_q4 * z2559 - c_q4 * z2560;
    const Scalar z2562 = s_q4 * z2560 + c_q4 * z2559;
    const Scalar z2563 = n0_0825 * z2472 + n0_384 * z2473 - z2562;
    const Scalar z2564 = n0_0825 * z2527 + n0_384 * z2528 - z2561;
    const Scalar z2565 = n0_0825 * z2551 - n0_384 * z2553;
    const Scalar z2566 = s_q5 * z2564 + c_q5 * z2565;
    const Scalar z2567 = n0_088 * z2530 - z2566;
    const Scalar z2568 = s_q5 * z2565 - c_q5 * z2564;
    const Scalar z2569 = s_q6 * z2563 - c_q6 * z2568;
    const Scalar z2570 = n0_088 * z2477 + z2569;
    const Scalar z2571 = s_q7 * z2567 - c_q7 * z2570;
    const Scalar z2572 = s_q7 * z2570 + c_q7 * z2567;
    const Scalar z2573 = z2513 + z2514;
    const Scalar z2574 = z2509 + z2510;
    const Scalar z2575 = z2492 - z2495;
    const Scalar z2576 = k4 * z2486 + k9 * z2489 + k1 * z2571 + k0 * z2572 + k3 * z2573 + k2 * z2574 - k11 * z2575;
    const Scalar z2577 = z2476 - z2517;
    const Scalar z2578 = k17 * z2503 - k53 * z2529 - n0_088 * z2531 + k15 * z2533 + k13 * z2566 - z2576 - k16 * z2577;
    const Scalar z2579 = s_q6 * z2568 + c_q6 * z2563;
    const Scalar z2580 = n0_088 * z2505 - z2579;
    const Scalar z2581 = z2491 + z2492;
    const Scalar z2582 = k2 * z2497 - k52 * z2510 - k11 * z2515 - k0 * z2580 - k3 * z2581;
    const Scalar z2583 = z2491 + z2495;
    const Scalar z2584 = k3 * z2490 - k11 * z2511 + k9 * z2513 - k4 * z2514 - k1 * z2580 + k2 * z2583;
    const Scalar z2585 = s_q7 * z2582 - c_q7 * z2584;
    const Scalar z2586 = z2475 - z2476;
    const Scalar z2587 = k16 * z2505 + k14 * z2507 + k15 * z2530 - k18 * z2532 - k19 * z2566 - z2585 - k17 * z2586;
    const Scalar z2588 = s_q6 * z2578 + c_q6 * z2587;
    const Scalar z2589 = z2537 - z2542;
    const Scalar z2590 = k23 * z2482 - k24 * z2522 + k27 * z2523 - k25 * z2536 + k22 * z2563 + z2588 + k26 * z2589;
    const Scalar z2591 = s_q7 * z2584 + c_q7 * z2582;
    const Scalar z2592 = z2507 - z2532;
    const Scalar z2593 = z2486 - z2529;
    const Scalar z2594 = z2475 - z2517;
    const Scalar z2595 = k18 * z2501 + k14 * z2502 - n0_088 * z2516 - k19 * z2569 - k13 * z2579 - z2591 - k16 * z2592
        - k17 * z2593 - k15 * z2594;
    const Scalar z2596 = z2537 + z2538;
    const Scalar z2597 = k54 * z2521 + k24 * z2524 - k26 * z2544 - k21 * z2563 - z2595 - k25 * z2596;
    const Scalar z2598 = s_q5 * z2590 - c_q5 * z2597;
    const Scalar z2599 = z2480 - z2552;
    const Scalar z2600 = z2484 - z2550;
    const Scalar z2601 = z2473 + z2527;
    const Scalar z2602 = k36 * z39 + k32 * z2471 + n0_0825 * z2525 - n0_384 * z2546 - k31 * z2561 - k30 * z2562 + z2598
        + k34 * z2599 + k35 * z2600 + k33 * z2601;
    const Scalar z2603 = s_q4 * z2547 + c_q4 * z2526;
    const Scalar z2604 = n2 * z40;
    const Scalar z2605 = k56 * z39 + k41 * z2470 + z2602 - n0_0825 * z2603 + k40 * z2604;
    const Scalar z2606 = s_q6 * z2587 - c_q6 * z2578;
    const Scalar z2607 = z2482 - z2523;
    const Scalar z2608 = z2501 + z2521;
    const Scalar z2609 = z2538 + z2542;
    const Scalar z2610 = k27 * z2484 + k23 * z2535 + k21 * z2566 + k22 * z2568 + z2606 - k25 * z2607 + k26 * z2608 - k24
        * z2609;
    const Scalar z2611 = k34 * z2473 + k35 * z2528 + k55 * z2550 - k33 * z2553 - n0_0825 * z2554 + z2610;
    const Scalar z2612 = s_q5 * z2597 + c_q5 * z2590;
    const Scalar z2613 = k34 * z2472 + k32 * z2480 + k35 * z2527 - k33 * z2551 + k36 * z2552 + n0_384 * z2554 - z2612;
    const Scalar z2614 = s_q4 * z2611 + c_q4 * z2613;
    const Scalar z2615 = k63 * z40 + k42 * z2470 + k40 * z2558 + z2614;
    const Scalar z2616 = s_q3 * z2605 + c_q3 * z2615;
    const Scalar z2617 = n0_316 * z2557 + z2616;
    const Scalar z2618 = s_q4 * z2613 - c_q4 * z2611;
    const Scalar z2619 = n0_0825 * z2555 + z2618;
    const Scalar z2620 = s_q2 * z2617 - c_q2 * z2619;
    const Scalar z2621 = n2 * z39 * z40;
    const Scalar z2622 = n2 * z39 * z50;
    const Scalar z2623 = n2 * z46 * z2479;
    const Scalar z2624 = z2622 + z2623;
    const Scalar z2625 = z46 * z2483 + z47 * z2479;
    const Scalar z2626 = z896 - z2625;
    const Scalar z2627 = s_q5 * z39 - c_q5 * z2479;
    const Scalar z2628 = s_q6 * z2627 - c_q6 * z2483;
    const Scalar z2629 = n2 * z60 * z2628;
    const Scalar z2630 = s_q5 * z2479 + c_q5 * z39;
    const Scalar z2631 = n2 * z63 * z2630;
    const Scalar z2632 = z2629 + z2631;
    const Scalar z2633 = n2 * z70 * z2628;
    const Scalar z2634 = s_q6 * z2483 + c_q6 * z2627;
    const Scalar z2635 = s_q7 * z2630 - c_q7 * z2634;
    const Scalar z2636 = n2 * z66 * z2635;
    const Scalar z2637 = z2633 - z2636;
    const Scalar z2638 = s_q7 * z2634 + c_q7 * z2630;
    const Scalar z2639 = z66 * z2638 - z67 * z2635;
    const Scalar z2640 = c_q4 * z897;
    const Scalar z2641 = v_q4 * z2483 + z2640;
    const Scalar z2642 = s_q5 * z896 + c_q5 * z2641;
    const Scalar z2643 = v_q5 * z2630 + z2642;
    const Scalar z2644 = s_q4 * z897;
    const Scalar z2645 = v_q4 * z2479 - z2644;
    const Scalar z2646 = s_q6 * z2643 - c_q6 * z2645;
    const Scalar z2647 = v_q6 * z2634 + z2646;
    const Scalar z2648 = z2639 - z2647;
    const Scalar z2649 = k1 * z2637 - k0 * z2648;
    const Scalar z2650 = n2 * z67 * z2638;
    const Scalar z2651 = z2633 + z2650;
    const Scalar z2652 = z2639 + z2647;
    const Scalar z2653 = k0 * z2651 - k1 * z2652;
    const Scalar z2654 = s_q7 * z2649 + c_q7 * z2653;
    const Scalar z2655 = z59 * z2628 - z60 * z2634;
    const Scalar z2656 = s_q5 * z2641 - c_q5 * z896;
    const Scalar z2657 = v_q5 * z2627 + z2656;
    const Scalar z2658 = z2655 + z2657;
    const Scalar z2659 = k13 * z2632 - z2654 + k19 * z2658;
    const Scalar z2660 = n2 * z59 * z2634;
    const Scalar z2661 = z2631 - z2660;
    const Scalar z2662 = z2655 - z2657;
    const Scalar z2663 = z66 * z2628 - z70 * z2635;
    const Scalar z2664 = s_q6 * z2645 + c_q6 * z2643;
    const Scalar z2665 = v_q6 * z2628 - z2664;
    const Scalar z2666 = s_q7 * z2665 + c_q7 * z2657;
    const Scalar z2667 = v_q7 * z2635 + z2666;
    const Scalar z2668 = z2663 - z2667;
    const Scalar z2669 = z67 * z2628 + z70 * z2638;
    const Scalar z2670 = s_q7 * z2657 - c_q7 * z2665;
    const Scalar z2671 = v_q7 * z2638 - z2670;
    const Scalar z2672 = z2669 + z2671;
    const Scalar z2673 = k0 * z2668 + k1 * z2672;
    const Scalar z2674 = k19 * z2661 + k13 * z2662 + z2673;
    const Scalar z2675 = s_q6 * z2659 - c_q6 * z2674;
    const Scalar z2676 = z54 * z2483 - z58 * z2627;
    const Scalar z2677 = z2657 - z2676;
    const Scalar z2678 = z55 * z2483 - z58 * z2630;
    const Scalar z2679 = z2643 - z2678;
    const Scalar z2680 = z2675 - k21 * z2677 + k22 * z2679;
    const Scalar z2681 = k31 * z2624 + k30 * z2626 + z2680;
    const Scalar z2682 = n2 * z47 * z2483;
    const Scalar z2683 = z2622 + z2682;
    const Scalar z2684 = z896 + z2625;
    const Scalar z2685 = n2 * z58 * z2483;
    const Scalar z2686 = n2 * z54 * z2627;
    const Scalar z2687 = z2685 - z2686;
    const Scalar z2688 = z59 * z2630 - z63 * z2634;
    const Scalar z2689 = z2647 - z2688;
    const Scalar z2690 = s_q7 * z2653 - c_q7 * z2649;
    const Scalar z2691 = z60 * z2630 + z63 * z2628;
    const Scalar z2692 = z2665 + z2691;
    const Scalar z2693 = k13 * z2689 - z2690 + k19 * z2692;
    const Scalar z2694 = z54 * z2630 + z55 * z2627;
    const Scalar z2695 = z2645 - z2694;
    const Scalar z2696 = k22 * z2687 + z2693 + k21 * z2695;
    const Scalar z2697 = n2 * z55 * z2630;
    const Scalar z2698 = z2685 - z2697;
    const Scalar z2699 = s_q6 * z2674 + c_q6 * z2659;
    const Scalar z2700 = z2645 + z2694;
    const Scalar z2701 = k21 * z2698 + z2699 - k22 * z2700;
    const Scalar z2702 = s_q5 * z2696 + c_q5 * z2701;
    const Scalar z2703 = k30 * z2683 - k31 * z2684 - z2702;
    const Scalar z2704 = s_q4 * z2681 + c_q4 * z2703;
    const Scalar z2705 = z39 * z39 - z40 * z40;
    const Scalar z2706 = k37 * z2621 + z2704 - k38 * z2705;
    const Scalar z2707 = z39 * z46 + z50 * z2479;
    const Scalar z2708 = z2645 + z2707;
    const Scalar z2709 = z39 * z47 + z50 * z2483;
    const Scalar z2710 = z2641 + z2709;
    const Scalar z2711 = s_q5 * z2701 - c_q5 * z2696;
    const Scalar z2712 = k30 * z2708 + k31 * z2710 - z2711;
    const Scalar z2713 = k38 * z2621 + k37 * z2705 - z2712;
    const Scalar z2714 = s_q3 * (z1007 + z2706) - c_q3 * (z1006 + z2713);
    const Scalar z2715 = z2623 - z2682;
    const Scalar z2716 = n0_0825 * z1003;
    const Scalar z2717 = z895 + n0_0825 * z2621;
    const Scalar z2718 = s_q4 * z2716 + c_q4 * z2717;
    const Scalar z2719 = s_q4 * z2717 - c_q4 * z2716;
    const Scalar z2720 = z2685 + z2697;
    const Scalar z2721 = n0_384 * z2624 + n0_0825 * z2626 + z2719;
    const Scalar z2722 = z2631 + z2660;
    const Scalar z2723 = n0_0825 * z2683 - n0_384 * z2684 + z2718;
    const Scalar z2724 = z894 + n0_0825 * z2705;
    const Scalar z2725 = n0_0825 * z2708 + n0_384 * z2710 - z2724;
    const Scalar z2726 = s_q5 * z2723 - c_q5 * z2725;
    const Scalar z2727 = z2636 + z2650;
    const Scalar z2728 = n0_088 * z2689 - z2726;
    const Scalar z2729 = s_q5 * z2725 + c_q5 * z2723;
    const Scalar z2730 = s_q6 * z2721 - c_q6 * z2729;
    const Scalar z2731 = n0_088 * z2632 + z2730;
    const Scalar z2732 = s_q7 * z2728 + c_q7 * z2731;
    const Scalar z2733 = s_q7 * z2731 - c_q7 * z2728;
    const Scalar z2734 = z2669 - z2671;
    const Scalar z2735 = z2663 + z2667;
    const Scalar z2736 = k9 * z2639 + k4 * z2647 + k11 * z2727 + k1 * z2732 - k0 * z2733 - k3 * z2734 - k2 * z2735;
    const Scalar z2737 = k17 * z2658 + k53 * z2688 + n0_088 * z2690 - k15 * z2692 + k16 * z2722 + k13 * z2726 - z2736;
    const Scalar z2738 = z2629 - z2631;
    const Scalar z2739 = z2633 + z2636;
    const Scalar z2740 = s_q6 * z2729 + c_q6 * z2721;
    const Scalar z2741 = n0_088 * z2662 - z2740;
    const Scalar z2742 = k2 * z2652 + k52 * z2663 - k11 * z2672 + k3 * z2739 + k0 * z2741;
    const Scalar z2743 = z2633 - z2650;
    const Scalar z2744 = k3 * z2648 + k11 * z2668 - k4 * z2669 - k9 * z2671 - k1 * z2741 + k2 * z2743;
    const Scalar z2745 = s_q7 * z2742 + c_q7 * z2744;
    const Scalar z2746 = k16 * z2662 + k14 * z2665 - k15 * z2689 - k18 * z2691 + k19 * z2726 - k17 * z2738 + z2745;
    const Scalar z2747 = s_q6 * z2737 - c_q6 * z2746;
    const Scalar z2748 = k23 * z2643 + k24 * z2677 - k27 * z2678 - k25 * z2695 - k26 * z2720 + k22 * z2721 - z2747;
    const Scalar z2749 = z2685 + z2686;
    const Scalar z2750 = z2629 + z2660;
    const Scalar z2751 = s_q7 * z2744 - c_q7 * z2742;
    const Scalar z2752 = z2665 - z2691;
    const Scalar z2753 = z2647 + z2688;
    const Scalar z2754 = k14 * z2655 - k18 * z2657 + n0_088 * z2673 - k19 * z2730 - k13 * z2740 - k15 * z2750 - z2751
        - k16 * z2752 + k17 * z2753;
    const Scalar z2755 = k54 * z2676 - k24 * z2679 + k26 * z2700 + k21 * z2721 - k25 * z2749 + z2754;
    const Scalar z2756 = s_q5 * z2748 + c_q5 * z2755;
    const Scalar z2757 = z2641 - z2709;
    const Scalar z2758 = z2645 - z2707;
    const Scalar z2759 = k36 * z896 + k32 * z2625 + n0_0825 * z2680 + n0_384 * z2702 + k33 * z2715 - k31 * z2718 + k30
        * z2719 + z2756 - k34 * z2757 + k35 * z2758;
    const Scalar z2760 = s_q4 * z2703 - c_q4 * z2681;
    const Scalar z2761 = k56 * z846 - k40 * z900 - k41 * z2621 + k42 * z2705 + z2759 + n0_0825 * z2760;
    const Scalar z2762 = z2622 - z2623;
    const Scalar z2763 = z2686 - z2697;
    const Scalar z2764 = s_q6 * z2746 + c_q6 * z2737;
    const Scalar z2765 = z2643 + z2678;
    const Scalar z2766 = z2657 + z2676;
    const Scalar z2767 = k27 * z2645 + k23 * z2694 - k21 * z2726 + k22 * z2729 + k24 * z2763 + z2764 - k25 * z2765 - k26
        * z2766;
    const Scalar z2768 = k35 * z2684 + k55 * z2707 + k33 * z2710 - n0_0825 * z2711 - k30 * z2724 - k34 * z2762 + z2767;
    const Scalar z2769 = z2622 - z2682;
    const Scalar z2770 = s_q5 * z2755 - c_q5 * z2748;
    const Scalar z2771 = k34 * z2626 - k32 * z2641 - k33 * z2708 - k36 * z2709 + n0_384 * z2711 + k31 * z2724 + k35
        * z2769 + z2770;
    const Scalar z2772 = s_q4 * z2768 + c_q4 * z2771;
    const Scalar z2773 = k43 * z700 + k39 * z897 - k40 * z1003 - k42 * z2621 - k41 * z2705 - z2772;
    const Scalar z2774 = s_q3 * (z1009 - z2761) - c_q3 * (z1010 - z2773);
    const Scalar z2775 = n0_316 * z2714 + z2774;
    const Scalar z2776 = n2 * z2621;
    const Scalar z2777 = s_q4 * z2771 - c_q4 * z2768;
    const Scalar z2778 = k37 * z894 + k38 * z895 + k42 * z1004 + k41 * z1005 - k39 * z2705 - n0_0825 * z2712 + k40
        * z2776 - z2777;
    const Scalar z2779 = s_q2 * z2775 - c_q2 * z2778;
    const Scalar z2780 = s_q3 * z2556 - c_q3 * z2549;
    const Scalar z2781 = s_q3 * z2615 - c_q3 * z2605;
    const Scalar z2782 = n0_316 * z2780 + z2781;
    const Scalar z2783 = s_q3 * (z1006 + z2713) + c_q3 * (z1007 + z2706);
    const Scalar z2784 = s_q3 * (z1010 - z2773) + c_q3 * (z1009 - z2761);
    const Scalar z2785 = n0_316 * z2783 + z2784;
    const Scalar z2786 = n2 * z50;
    const Scalar z2787 = n2 * z60 * z250;
    const Scalar z2788 = n2 * c_q5 * z63;
    const Scalar z2789 = z2787 + z2788;
    const Scalar z2790 = c_q5 * z47;
    const Scalar z2791 = v_q5 * c_q5 + z2790;
    const Scalar z2792 = s_q6 * z2791 - c_q6 * z46;
    const Scalar z2793 = v_q6 * z240 + z2792;
    const Scalar z2794 = c_q5 * s_q7 - c_q7 * z240;
    const Scalar z2795 = c_q5 * c_q7 + s_q7 * z240;
    const Scalar z2796 = z66 * z2795 - z67 * z2794;
    const Scalar z2797 = z2793 - z2796;
    const Scalar z2798 = n2 * z70 * z250;
    const Scalar z2799 = n2 * z66 * z2794;
    const Scalar z2800 = z2798 - z2799;
    const Scalar z2801 = k0 * z2797 + k1 * z2800;
    const Scalar z2802 = n2 * z67 * z2795;
    const Scalar z2803 = z2798 + z2802;
    const Scalar z2804 = z2793 + z2796;
    const Scalar z2805 = k0 * z2803 - k1 * z2804;
    const Scalar z2806 = s_q7 * z2801 + c_q7 * z2805;
    const Scalar z2807 = s_q5 * z47;
    const Scalar z2808 = v_q5 * s_q5 + z2807;
    const Scalar z2809 = z59 * z250 - z60 * z240;
    const Scalar z2810 = z2808 + z2809;
    const Scalar z2811 = k13 * z2789 - z2806 + k19 * z2810;
    const Scalar z2812 = z2808 - z2809;
    const Scalar z2813 = s_q6 * z46 + c_q6 * z2791;
    const Scalar z2814 = v_q6 * z250 - z2813;
    const Scalar z2815 = s_q7 * z2814 + c_q7 * z2808;
    const Scalar z2816 = v_q7 * z2794 + z2815;
    const Scalar z2817 = z66 * z250 - z70 * z2794;
    const Scalar z2818 = z2816 - z2817;
    const Scalar z2819 = s_q7 * z2808 - c_q7 * z2814;
    const Scalar z2820 = v_q7 * z2795 - z2819;
    const Scalar z2821 = z67 * z250 + z70 * z2795;
    const Scalar z2822 = z2820 + z2821;
    const Scalar z2823 = k0 * z2818 - k1 * z2822;
    const Scalar z2824 = n2 * z59 * z240;
    const Scalar z2825 = z2788 - z2824;
    const Scalar z2826 = k13 * z2812 + z2823 - k19 * z2825;
    const Scalar z2827 = s_q6 * z2811 + c_q6 * z2826;
    const Scalar z2828 = s_q5 * z58;
    const Scalar z2829 = z2808 + z2828;
    const Scalar z2830 = c_q5 * z58;
    const Scalar z2831 = z2791 + z2830;
    const Scalar z2832 = z2827 - k21 * z2829 + k22 * z2831;
    const Scalar z2833 = k31 * z2786 + z2832;
    const Scalar z2834 = c_q5 * z59 - z63 * z240;
    const Scalar z2835 = z2793 - z2834;
    const Scalar z2836 = s_q7 * z2805 - c_q7 * z2801;
    const Scalar z2837 = c_q5 * z60 + z63 * z250;
    const Scalar z2838 = z2814 + z2837;
    const Scalar z2839 = k13 * z2835 - z2836 + k19 * z2838;
    const Scalar z2840 = s_q5 * z55 + c_q5 * z54;
    const Scalar z2841 = z46 - z2840;
    const Scalar z2842 = n2 * s_q5 * z54;
    const Scalar z2843 = z2839 + k21 * z2841 - k22 * z2842;
    const Scalar z2844 = s_q6 * z2826 - c_q6 * z2811;
    const Scalar z2845 = n2 * c_q5 * z55;
    const Scalar z2846 = z46 + z2840;
    const Scalar z2847 = z2844 + k21 * z2845 + k22 * z2846;
    const Scalar z2848 = s_q5 * z2843 - c_q5 * z2847;
    const Scalar z2849 = k30 * z2786 - z2848;
    const Scalar z2850 = s_q4 * z2833 + c_q4 * z2849;
    const Scalar z2851 = n2 * z46;
    const Scalar z2852 = n2 * z47;
    const Scalar z2853 = s_q5 * z2847 + c_q5 * z2843;
    const Scalar z2854 = k30 * z2851 + k31 * z2852 + z2853;
    const Scalar z2855 = s_q3 * z2850 + c_q3 * z2854;
    const Scalar z2856 = n0_384 * z2786;
    const Scalar z2857 = n0_0825 * z2786;
    const Scalar z2858 = n0_0825 * z2851 + n0_384 * z2852;
    const Scalar z2859 = s_q5 * z2857 - c_q5 * z2858;
    const Scalar z2860 = n0_088 * z2835 - z2859;
    const Scalar z2861 = s_q5 * z2858 + c_q5 * z2857;
    const Scalar z2862 = s_q6 * z2856 - c_q6 * z2861;
    const Scalar z2863 = n0_088 * z2789 + z2862;
    const Scalar z2864 = s_q7 * z2860 + c_q7 * z2863;
    const Scalar z2865 = s_q7 * z2863 - c_q7 * z2860;
    const Scalar z2866 = z2820 - z2821;
    const Scalar z2867 = z2816 + z2817;
    const Scalar z2868 = z2799 + z2802;
    const Scalar z2869 = k4 * z2793 + k9 * z2796 + k1 * z2864 - k0 * z2865 + k3 * z2866 - k2 * z2867 + k11 * z2868;
    const Scalar z2870 = z2788 + z2824;
    const Scalar z2871 = k17 * z2810 + k53 * z2834 + n0_088 * z2836 - k15 * z2838 + k13 * z2859 - z2869 + k16 * z2870;
    const Scalar z2872 = s_q6 * z2861 + c_q6 * z2856;
    const Scalar z2873 = n0_088 * z2812 + z2872;
    const Scalar z2874 = z2798 + z2799;
    const Scalar z2875 = k2 * z2804 + k52 * z2817 - k11 * z2822 - k0 * z2873 + k3 * z2874;
    const Scalar z2876 = z2798 - z2802;
    const Scalar z2877 = k3 * z2797 + k11 * z2818 + k9 * z2820 + k4 * z2821 - k1 * z2873 - k2 * z2876;
    const Scalar z2878 = s_q7 * z2875 - c_q7 * z2877;
    const Scalar z2879 = z2787 - z2788;
    const Scalar z2880 = k16 * z2812 - k14 * z2814 + k15 * z2835 + k18 * z2837 - k19 * z2859 - z2878 + k17 * z2879;
    const Scalar z2881 = s_q6 * z2871 + c_q6 * z2880;
    const Scalar z2882 = k23 * z2791 + k24 * z2829 + k27 * z2830 - k25 * z2841 - k26 * z2845 + k22 * z2856 - z2881;
    const Scalar z2883 = s_q7 * z2877 + c_q7 * z2875;
    const Scalar z2884 = z2814 - z2837;
    const Scalar z2885 = z2793 + z2834;
    const Scalar z2886 = z2787 + z2824;
    const Scalar z2887 = k18 * z2808 - k14 * z2809 + n0_088 * z2823 + k19 * z2862 + k13 * z2872 - z2883 + k16 * z2884
        - k17 * z2885 + k15 * z2886;
    const Scalar z2888 = k54 * z2828 + k24 * z2831 + k25 * z2842 - k26 * z2846 - k21 * z2856 + z2887;
    const Scalar z2889 = s_q5 * z2882 - c_q5 * z2888;
    const Scalar z2890 = n0_0825 * z2832 + n0_384 * z2848 + z2889;
    const Scalar z2891 = s_q4 * z2849 - c_q4 * z2833;
    const Scalar z2892 = z2890 + n0_0825 * z2891;
    const Scalar z2893 = s_q6 * z2880 - c_q6 * z2871;
    const Scalar z2894 = z2791 - z2830;
    const Scalar z2895 = z2808 - z2828;
    const Scalar z2896 = z2842 - z2845;
    const Scalar z2897 = k27 * z46 + k23 * z2840 - k21 * z2859 + k22 * z2861 - z2893 - k25 * z2894 - k26 * z2895 + k24
        * z2896;
    const Scalar z2898 = k55 * z46 - k34 * z2786 + k33 * z2852 + n0_0825 * z2853 + z2897;
    const Scalar z2899 = s_q5 * z2888 + c_q5 * z2882;
    const Scalar z2900 = k64 * z47 - k35 * z2786 + k33 * z2851 + n0_384 * z2853 + z2899;
    const Scalar z2901 = s_q4 * z2898 - c_q4 * z2900;
    const Scalar z2902 = s_q3 * z2892 + c_q3 * z2901;
    const Scalar z2903 = n0_316 * z2855 - z2902;
    const Scalar z2904 = s_q4 * z2900 + c_q4 * z2898;
    const Scalar z2905 = n0_0825 * z2854 - z2904;
    const Scalar z2906 = s_q2 * z2903 + c_q2 * z2905;
    const Scalar z2907 = n2 * z46 * z47;
    const Scalar z2908 = z46 * z46 - z47 * z47;
    const Scalar z2909 = s_q6 * z2790 - c_q6 * z46;
    const Scalar z2910 = n2 * z60 * z2909;
    const Scalar z2911 = n2 * z63 * z2807;
    const Scalar z2912 = z2910 - z2911;
    const Scalar z2913 = n2 * z70 * z2909;
    const Scalar z2914 = s_q6 * z46 + c_q6 * z2790;
    const Scalar z2915 = s_q7 * z2807 + c_q7 * z2914;
    const Scalar z2916 = n2 * z66 * z2915;
    const Scalar z2917 = z2913 + z2916;
    const Scalar z2918 = s_q7 * z2914 - c_q7 * z2807;
    const Scalar z2919 = z66 * z2918 + z67 * z2915;
    const Scalar z2920 = c_q5 * z909;
    const Scalar z2921 = v_q5 * z2807 - z2920;
    const Scalar z2922 = s_q6 * z2921 - c_q6 * z908;
    const Scalar z2923 = v_q6 * z2914 - z2922;
    const Scalar z2924 = z2919 - z2923;
    const Scalar z2925 = k1 * z2917 - k0 * z2924;
    const Scalar z2926 = n2 * z67 * z2918;
    const Scalar z2927 = z2913 + z2926;
    const Scalar z2928 = z2919 + z2923;
    const Scalar z2929 = k0 * z2927 - k1 * z2928;
    const Scalar z2930 = s_q7 * z2925 + c_q7 * z2929;
    const Scalar z2931 = z59 * z2909 - z60 * z2914;
    const Scalar z2932 = s_q5 * z909;
    const Scalar z2933 = v_q5 * z2790 + z2932;
    const Scalar z2934 = z2931 + z2933;
    const Scalar z2935 = k13 * z2912 - z2930 + k19 * z2934;
    const Scalar z2936 = n2 * z59 * z2914;
    const Scalar z2937 = z2911 + z2936;
    const Scalar z2938 = z2931 - z2933;
    const Scalar z2939 = z66 * z2909 + z70 * z2915;
    const Scalar z2940 = s_q6 * z908 + c_q6 * z2921;
    const Scalar z2941 = v_q6 * z2909 + z2940;
    const Scalar z2942 = s_q7 * z2941 + c_q7 * z2933;
    const Scalar z2943 = v_q7 * z2915 - z2942;
    const Scalar z2944 = z2939 + z2943;
    const Scalar z2945 = z67 * z2909 + z70 * z2918;
    const Scalar z2946 = s_q7 * z2933 - c_q7 * z2941;
    const Scalar z2947 = v_q7 * z2918 - z2946;
    const Scalar z2948 = z2945 + z2947;
    const Scalar z2949 = k0 * z2944 + k1 * z2948;
    const Scalar z2950 = k19 * z2937 - k13 * z2938 - z2949;
    const Scalar z2951 = s_q6 * z2935 + c_q6 * z2950;
    const Scalar z2952 = z46 * z54 - z58 * z2790;
    const Scalar z2953 = z2933 - z2952;
    const Scalar z2954 = z46 * z55 + z58 * z2807;
    const Scalar z2955 = z2921 + z2954;
    const Scalar z2956 = z2951 - k21 * z2953 - k22 * z2955;
    const Scalar z2957 = k31 * z2907 + k30 * z2908 - z2956;
    const Scalar z2958 = n2 * z46 * z58;
    const Scalar z2959 = n2 * z54 * z2790;
    const Scalar z2960 = z2958 - z2959;
    const Scalar z2961 = z59 * z2807 + z63 * z2914;
    const Scalar z2962 = z2923 + z2961;
    const Scalar z2963 = s_q7 * z2929 - c_q7 * z2925;
    const Scalar z2964 = z60 * z2807 - z63 * z2909;
    const Scalar z2965 = z2941 - z2964;
    const Scalar z2966 = k13 * z2962 - z2963 + k19 * z2965;
    const Scalar z2967 = z54 * z2807 - z55 * z2790;
    const Scalar z2968 = z908 - z2967;
    const Scalar z2969 = k22 * z2960 + z2966 - k21 * z2968;
    const Scalar z2970 = n2 * z55 * z2807;
    const Scalar z2971 = z2958 + z2970;
    const Scalar z2972 = s_q6 * z2950 - c_q6 * z2935;
    const Scalar z2973 = z908 + z2967;
    const Scalar z2974 = k21 * z2971 - z2972 + k22 * z2973;
    const Scalar z2975 = s_q5 * z2969 + c_q5 * z2974;
    const Scalar z2976 = k30 * z2907 - k31 * z2908 - z2975;
    const Scalar z2977 = s_q4 * (z992 + z2957) - c_q4 * (z993 + z2976);
    const Scalar z2978 = s_q5 * z2974 - c_q5 * z2969;
    const Scalar z2979 = k31 * z913 - k30 * z914 - z2978;
    const Scalar z2980 = s_q3 * z2977 - c_q3 * z2979;
    const Scalar z2981 = n2 * z2907;
    const Scalar z2982 = z2958 - z2970;
    const Scalar z2983 = z906 - n0_384 * z2907 - n0_0825 * z2908;
    const Scalar z2984 = z2911 - z2936;
    const Scalar z2985 = z907 + n0_0825 * z2907 - n0_384 * z2908;
    const Scalar z2986 = n0_384 * z913 - n0_0825 * z914;
    const Scalar z2987 = s_q5 * z2985 - c_q5 * z2986;
    const Scalar z2988 = z2916 - z2926;
    const Scalar z2989 = n0_088 * z2962 - z2987;
    const Scalar z2990 = s_q5 * z2986 + c_q5 * z2985;
    const Scalar z2991 = s_q6 * z2983 - c_q6 * z2990;
    const Scalar z2992 = n0_088 * z2912 + z2991;
    const Scalar z2993 = s_q7 * z2989 + c_q7 * z2992;
    const Scalar z2994 = s_q7 * z2992 - c_q7 * z2989;
    const Scalar z2995 = z2945 - z2947;
    const Scalar z2996 = z2939 - z2943;
    const Scalar z2997 = k9 * z2919 + k4 * z2923 - k11 * z2988 + k1 * z2993 - k0 * z2994 - k3 * z2995 - k2 * z2996;
    const Scalar z2998 = k17 * z2934 - k53 * z2961 + n0_088 * z2963 - k15 * z2965 - k16 * z2984 + k13 * z2987 - z2997;
    const Scalar z2999 = z2910 + z2911;
    const Scalar z3000 = z2913 - z2916;
    const Scalar z3001 = s_q6 * z2990 + c_q6 * z2983;
    const Scalar z3002 = n0_088 * z2938 - z3001;
    const Scalar z3003 = k2 * z2928 + k52 * z2939 - k11 * z2948 + k3 * z3000 + k0 * z3002;
    const Scalar z3004 = z2913 - z2926;
    const Scalar z3005 = k3 * z2924 + k11 * z2944 - k4 * z2945 - k9 * z2947 - k1 * z3002 + k2 * z3004;
    const Scalar z3006 = s_q7 * z3003 + c_q7 * z3005;
    const Scalar z3007 = k16 * z2938 + k14 * z2941 - k15 * z2962 + k18 * z2964 + k19 * z2987 - k17 * z2999 + z3006;
    const Scalar z3008 = s_q6 * z2998 - c_q6 * z3007;
    const Scalar z3009 = k23 * z2921 - k24 * z2953 + k27 * z2954 - k25 * z2968 + k26 * z2982 - k22 * z2983 + z3008;
    const Scalar z3010 = z2958 + z2959;
    const Scalar z3011 = z2910 + z2936;
    const Scalar z3012 = s_q7 * z3005 - c_q7 * z3003;
    const Scalar z3013 = z2941 + z2964;
    const Scalar z3014 = z2923 - z2961;
    const Scalar z3015 = k14 * z2931 - k18 * z2933 + n0_088 * z2949 - k19 * z2991 - k13 * z3001 - k15 * z3011 - z3012
        - k16 * z3013 + k17 * z3014;
    const Scalar z3016 = k54 * z2952 + k24 * z2955 - k26 * z2973 + k21 * z2983 - k25 * z3010 + z3015;
    const Scalar z3017 = s_q5 * z3009 - c_q5 * z3016;
    const Scalar z3018 = k30 * z906 - k31 * z907 + k35 * z990 + k34 * z991 + k32 * z2908 + n0_0825 * z2956 + n0_384
        * z2975 - k33 * z2981 - z3017;
    const Scalar z3019 = s_q4 * (z993 + z2976) + c_q4 * (z992 + z2957);
    const Scalar z3020 = z3018 + n0_0825 * z3019;
    const Scalar z3021 = z2959 + z2970;
    const Scalar z3022 = s_q6 * z3007 + c_q6 * z2998;
    const Scalar z3023 = z2921 - z2954;
    const Scalar z3024 = z2933 + z2952;
    const Scalar z3025 = k27 * z908 + k23 * z2967 + k21 * z2987 - k22 * z2990 - k24 * z3021 - z3022 - k25 * z3023 + k26
        * z3024;
    const Scalar z3026 = k55 * z721 - k33 * z913 + k34 * z2907 - k35 * z2908 + n0_0825 * z2978 + z3025;
    const Scalar z3027 = s_q5 * z3016 + c_q5 * z3009;
    const Scalar z3028 = k36 * z719 + k32 * z909 - k33 * z914 + k35 * z2907 + k34 * z2908 - n0_384 * z2978 - z3027;
    const Scalar z3029 = s_q4 * (z995 - z3026) + c_q4 * (z996 - z3028);
    const Scalar z3030 = s_q3 * z3020 + c_q3 * z3029;
    const Scalar z3031 = n0_316 * z2980 + z3030;
    const Scalar z3032 = s_q4 * (z996 - z3028) - c_q4 * (z995 - z3026);
    const Scalar z3033 = n0_0825 * z2979 + z3032;
    const Scalar z3034 = s_q2 * z3031 - c_q2 * z3033;
    const Scalar z3035 = s_q3 * z2854 - c_q3 * z2850;
    const Scalar z3036 = s_q3 * z2901 - c_q3 * z2892;
    const Scalar z3037 = n0_316 * z3035 - z3036;
    const Scalar z3038 = s_q3 * z2979 + c_q3 * z2977;
    const Scalar z3039 = s_q3 * z3029 - c_q3 * z3020;
    const Scalar z3040 = n0_316 * z3038 - z3039;
    const Scalar z3041 = n2 * c_q6 * z60;
    const Scalar z3042 = s_q6 * z55;
    const Scalar z3043 = v_q6 * s_q6 - z3042;
    const Scalar z3044 = z66 * z319 + z67 * z307;
    const Scalar z3045 = z3043 - z3044;
    const Scalar z3046 = n2 * c_q6 * z70;
    const Scalar z3047 = n2 * z66 * z307;
    const Scalar z3048 = z3046 - z3047;
    const Scalar z3049 = k0 * z3045 - k1 * z3048;
    const Scalar z3050 = n2 * z67 * z319;
    const Scalar z3051 = z3046 - z3050;
    const Scalar z3052 = z3043 + z3044;
    const Scalar z3053 = k0 * z3051 + k1 * z3052;
    const Scalar z3054 = s_q7 * z3049 - c_q7 * z3053;
    const Scalar z3055 = s_q6 * z60 + c_q6 * z59;
    const Scalar z3056 = z54 + z3055;
    const Scalar z3057 = k13 * z3041 + z3054 + k19 * z3056;
    const Scalar z3058 = z54 - z3055;
    const Scalar z3059 = c_q6 * z55;
    const Scalar z3060 = v_q6 * c_q6 - z3059;
    const Scalar z3061 = s_q7 * z3060 + c_q7 * z54;
    const Scalar z3062 = v_q7 * z307 + z3061;
    const Scalar z3063 = c_q6 * z66 - z70 * z307;
    const Scalar z3064 = z3062 - z3063;
    const Scalar z3065 = s_q7 * z54 - c_q7 * z3060;
    const Scalar z3066 = v_q7 * z319 + z3065;
    const Scalar z3067 = c_q6 * z67 - z70 * z319;
    const Scalar z3068 = z3066 - z3067;
    const Scalar z3069 = k0 * z3064 + k1 * z3068;
    const Scalar z3070 = n2 * s_q6 * z59;
    const Scalar z3071 = k13 * z3058 + z3069 - k19 * z3070;
    const Scalar z3072 = s_q6 * z3057 + c_q6 * z3071;
    const Scalar z3073 = n2 * z54;
    const Scalar z3074 = n2 * z55;
    const Scalar z3075 = z3072 - k21 * z3073 + k22 * z3074;
    const Scalar z3076 = s_q6 * z63;
    const Scalar z3077 = z3043 + z3076;
    const Scalar z3078 = s_q7 * z3053 + c_q7 * z3049;
    const Scalar z3079 = c_q6 * z63;
    const Scalar z3080 = z3060 + z3079;
    const Scalar z3081 = k13 * z3077 + z3078 - k19 * z3080;
    const Scalar z3082 = n2 * z58;
    const Scalar z3083 = z3081 + k22 * z3082;
    const Scalar z3084 = s_q6 * z3071 - c_q6 * z3057;
    const Scalar z3085 = k21 * z3082 + z3084;
    const Scalar z3086 = s_q5 * z3083 + c_q5 * z3085;
    const Scalar z3087 = s_q4 * z3075 + c_q4 * z3086;
    const Scalar z3088 = s_q5 * z3085 - c_q5 * z3083;
    const Scalar z3089 = s_q3 * z3087 + c_q3 * z3088;
    const Scalar z3090 = n0_088 * z3077;
    const Scalar z3091 = n0_088 * z3041;
    const Scalar z3092 = s_q7 * z3090 - c_q7 * z3091;
    const Scalar z3093 = s_q7 * z3091 + c_q7 * z3090;
    const Scalar z3094 = z3066 + z3067;
    const Scalar z3095 = z3062 + z3063;
    const Scalar z3096 = z3047 - z3050;
    const Scalar z3097 = k4 * z3043 + k9 * z3044 + k1 * z3092 + k0 * z3093 + k3 * z3094 + k2 * z3095 - k11 * z3096;
    const Scalar z3098 = k17 * z3056 - k16 * z3070 + k53 * z3076 + n0_088 * z3078 - k15 * z3080 + z3097;
    const Scalar z3099 = n0_088 * z3058;
    const Scalar z3100 = z3046 + z3047;
    const Scalar z3101 = k2 * z3052 - k52 * z3063 - k11 * z3068 + k0 * z3099 - k3 * z3100;
    const Scalar z3102 = z3046 + z3050;
    const Scalar z3103 = k3 * z3045 - k11 * z3064 + k9 * z3066 - k4 * z3067 + k1 * z3099 + k2 * z3102;
    const Scalar z3104 = s_q7 * z3101 - c_q7 * z3103;
    const Scalar z3105 = k17 * z3041 + k16 * z3058 - k14 * z3060 - k15 * z3077 + k18 * z3079 + z3104;
    const Scalar z3106 = s_q6 * z3098 + c_q6 * z3105;
    const Scalar z3107 = k65 * z55 + k24 * z3073 + k26 * z3082 - z3106;
    const Scalar z3108 = s_q7 * z3103 + c_q7 * z3101;
    const Scalar z3109 = z3060 - z3079;
    const Scalar z3110 = z3043 - z3076;
    const Scalar z3111 = z3041 - z3070;
    const Scalar z3112 = k18 * z54 - k14 * z3055 + n0_088 * z3069 + z3108 + k16 * z3109 + k17 * z3110 + k15 * z3111;
    const Scalar z3113 = k54 * z54 + k24 * z3074 - k25 * z3082 + z3112;
    const Scalar z3114 = s_q5 * z3107 - c_q5 * z3113;
    const Scalar z3115 = n0_0825 * z3075 - n0_384 * z3086 + z3114;
    const Scalar z3116 = s_q4 * z3086 - c_q4 * z3075;
    const Scalar z3117 = z3115 + n0_0825 * z3116;
    const Scalar z3118 = s_q6 * z3105 - c_q6 * z3098;
    const Scalar z3119 = n0_0825 * z3088 - z3118;
    const Scalar z3120 = s_q5 * z3113 + c_q5 * z3107;
    const Scalar z3121 = n0_384 * z3088 + z3120;
    const Scalar z3122 = s_q4 * z3119 - c_q4 * z3121;
    const Scalar z3123 = s_q3 * z3117 + c_q3 * z3122;
    const Scalar z3124 = n0_316 * z3089 - z3123;
    const Scalar z3125 = s_q4 * z3121 + c_q4 * z3119;
    const Scalar z3126 = n0_0825 * z3088 - z3125;
    const Scalar z3127 = s_q2 * z3124 + c_q2 * z3126;
    const Scalar z3128 = n2 * z60 * z3042;
    const Scalar z3129 = n2 * z54 * z63;
    const Scalar z3130 = z3128 - z3129;
    const Scalar z3131 = n2 * z70 * z3042;
    const Scalar z3132 = s_q7 * z54 + c_q7 * z3059;
    const Scalar z3133 = n2 * z66 * z3132;
    const Scalar z3134 = z3131 + z3133;
    const Scalar z3135 = s_q7 * z3059 - c_q7 * z54;
    const Scalar z3136 = z66 * z3135 + z67 * z3132;
    const Scalar z3137 = s_q6 * z923;
    const Scalar z3138 = v_q6 * z3059 - z3137;
    const Scalar z3139 = z3136 - z3138;
    const Scalar z3140 = k1 * z3134 - k0 * z3139;
    const Scalar z3141 = n2 * z67 * z3135;
    const Scalar z3142 = z3131 + z3141;
    const Scalar z3143 = z3136 + z3138;
    const Scalar z3144 = k0 * z3142 - k1 * z3143;
    const Scalar z3145 = s_q7 * z3140 + c_q7 * z3144;
    const Scalar z3146 = z59 * z3042 - z60 * z3059;
    const Scalar z3147 = z922 + z3146;
    const Scalar z3148 = k13 * z3130 - z3145 + k19 * z3147;
    const Scalar z3149 = n2 * z59 * z3059;
    const Scalar z3150 = z3129 + z3149;
    const Scalar z3151 = z922 - z3146;
    const Scalar z3152 = z66 * z3042 + z70 * z3132;
    const Scalar z3153 = c_q6 * z923;
    const Scalar z3154 = v_q6 * z3042 + z3153;
    const Scalar z3155 = s_q7 * z3154 + c_q7 * z922;
    const Scalar z3156 = v_q7 * z3132 - z3155;
    const Scalar z3157 = z3152 + z3156;
    const Scalar z3158 = z67 * z3042 + z70 * z3135;
    const Scalar z3159 = s_q7 * z922 - c_q7 * z3154;
    const Scalar z3160 = v_q7 * z3135 - z3159;
    const Scalar z3161 = z3158 + z3160;
    const Scalar z3162 = k0 * z3157 + k1 * z3161;
    const Scalar z3163 = k19 * z3150 + k13 * z3151 - z3162;
    const Scalar z3164 = s_q6 * z3148 + c_q6 * z3163;
    const Scalar z3165 = k22 * z976 + k21 * z977 - z3164;
    const Scalar z3166 = n2 * z54 * z55;
    const Scalar z3167 = z54 * z59 + z63 * z3059;
    const Scalar z3168 = z3138 + z3167;
    const Scalar z3169 = s_q7 * z3144 - c_q7 * z3140;
    const Scalar z3170 = z54 * z60 - z63 * z3042;
    const Scalar z3171 = z3154 - z3170;
    const Scalar z3172 = k13 * z3168 - z3169 + k19 * z3171;
    const Scalar z3173 = z54 * z54 - z55 * z55;
    const Scalar z3174 = k22 * z3166 - z3172 - k21 * z3173;
    const Scalar z3175 = s_q6 * z3163 - c_q6 * z3148;
    const Scalar z3176 = k21 * z3166 + k22 * z3173 - z3175;
    const Scalar z3177 = s_q5 * (z980 - z3174) - c_q5 * (z981 - z3176);
    const Scalar z3178 = s_q4 * z3165 + c_q4 * z3177;
    const Scalar z3179 = s_q5 * (z981 - z3176) + c_q5 * (z980 - z3174);
    const Scalar z3180 = s_q3 * z3178 - c_q3 * z3179;
    const Scalar z3181 = z3129 - z3149;
    const Scalar z3182 = z3133 - z3141;
    const Scalar z3183 = z920 - n0_088 * z3168;
    const Scalar z3184 = c_q6 * z921;
    const Scalar z3185 = n0_088 * z3130 + z3184;
    const Scalar z3186 = s_q7 * z3183 - c_q7 * z3185;
    const Scalar z3187 = s_q7 * z3185 + c_q7 * z3183;
    const Scalar z3188 = z3158 - z3160;
    const Scalar z3189 = z3152 - z3156;
    const Scalar z3190 = k9 * z3136 + k4 * z3138 - k11 * z3182 - k1 * z3186 - k0 * z3187 - k3 * z3188 - k2 * z3189;
    const Scalar z3191 = k13 * z920 + k17 * z3147 - k53 * z3167 + n0_088 * z3169 - k15 * z3171 - k16 * z3181 - z3190;
    const Scalar z3192 = z3128 + z3129;
    const Scalar z3193 = z3131 - z3133;
    const Scalar z3194 = s_q6 * z921;
    const Scalar z3195 = n0_088 * z3151 - z3194;
    const Scalar z3196 = k2 * z3143 + k52 * z3152 - k11 * z3161 + k3 * z3193 - k0 * z3195;
    const Scalar z3197 = z3131 - z3141;
    const Scalar z3198 = k3 * z3139 + k11 * z3157 - k4 * z3158 - k9 * z3160 + k1 * z3195 + k2 * z3197;
    const Scalar z3199 = s_q7 * z3196 + c_q7 * z3198;
    const Scalar z3200 = k19 * z920 - k16 * z3151 + k14 * z3154 - k15 * z3168 + k18 * z3170 - k17 * z3192 + z3199;
    const Scalar z3201 = s_q6 * z3191 - c_q6 * z3200;
    const Scalar z3202 = k27 * z809 + k23 * z923 - k24 * z977 - k26 * z3166 + k25 * z3173 + z3201;
    const Scalar z3203 = z3128 + z3149;
    const Scalar z3204 = s_q7 * z3198 - c_q7 * z3196;
    const Scalar z3205 = z3154 + z3170;
    const Scalar z3206 = z3138 - z3167;
    const Scalar z3207 = k18 * z922 - k14 * z3146 - n0_088 * z3162 + k19 * z3184 - k13 * z3194 + k15 * z3203 + z3204
        + k16 * z3205 - k17 * z3206;
    const Scalar z3208 = k54 * z811 - k24 * z976 + k25 * z3166 + k26 * z3173 + z3207;
    const Scalar z3209 = s_q5 * (z984 - z3202) + c_q5 * (z983 - z3208);
    const Scalar z3210 = n0_0825 * z3165 - n0_384 * z3177 - z3209;
    const Scalar z3211 = s_q4 * z3177 - c_q4 * z3165;
    const Scalar z3212 = z3210 + n0_0825 * z3211;
    const Scalar z3213 = n2 * z3166;
    const Scalar z3214 = s_q6 * z3200 + c_q6 * z3191;
    const Scalar z3215 = k21 * z920 + k22 * z921 - k26 * z978 + k25 * z979 + k23 * z3173 - k24 * z3213 - z3214;
    const Scalar z3216 = n0_0825 * z3179 - z3215;
    const Scalar z3217 = s_q5 * (z983 - z3208) - c_q5 * (z984 - z3202);
    const Scalar z3218 = n0_384 * z3179 - z3217;
    const Scalar z3219 = s_q4 * z3216 - c_q4 * z3218;
    const Scalar z3220 = s_q3 * z3212 - c_q3 * z3219;
    const Scalar z3221 = n0_316 * z3180 - z3220;
    const Scalar z3222 = s_q4 * z3218 + c_q4 * z3216;
    const Scalar z3223 = n0_0825 * z3179 - z3222;
    const Scalar z3224 = s_q2 * z3221 - c_q2 * z3223;
    const Scalar z3225 = s_q3 * z3088 - c_q3 * z3087;
    const Scalar z3226 = s_q3 * z3122 - c_q3 * z3117;
    const Scalar z3227 = n0_316 * z3225 - z3226;
    const Scalar z3228 = s_q3 * z3179 + c_q3 * z3178;
    const Scalar z3229 = s_q3 * z3219 + c_q3 * z3212;
    const Scalar z3230 = n0_316 * z3228 - z3229;
    const Scalar z3231 = n2 * z63;
    const Scalar z3232 = s_q7 * z67 - c_q7 * z66;
    const Scalar z3233 = z59 - z3232;
    const Scalar z3234 = n2 * s_q7 * z66;
    const Scalar z3235 = k0 * z3233 + k1 * z3234;
    const Scalar z3236 = n2 * c_q7 * z67;
    const Scalar z3237 = z59 + z3232;
    const Scalar z3238 = k0 * z3236 + k1 * z3237;
    const Scalar z3239 = s_q7 * z3235 - c_q7 * z3238;
    const Scalar z3240 = k13 * z3231 + z3239;
    const Scalar z3241 = s_q7 * z60;
    const Scalar z3242 = v_q7 * s_q7 + z3241;
    const Scalar z3243 = s_q7 * z70;
    const Scalar z3244 = z3242 + z3243;
    const Scalar z3245 = c_q7 * z60;
    const Scalar z3246 = v_q7 * c_q7 + z3245;
    const Scalar z3247 = c_q7 * z70;
    const Scalar z3248 = z3246 + z3247;
    const Scalar z3249 = k0 * z3244 - k1 * z3248;
    const Scalar z3250 = k19 * z3231 - z3249;
    const Scalar z3251 = s_q6 * z3240 - c_q6 * z3250;
    const Scalar z3252 = n2 * z59;
    const Scalar z3253 = s_q7 * z3238 + c_q7 * z3235;
    const Scalar z3254 = n2 * z60;
    const Scalar z3255 = k13 * z3252 + z3253 - k19 * z3254;
    const Scalar z3256 = s_q6 * z3250 + c_q6 * z3240;
    const Scalar z3257 = s_q5 * z3255 - c_q5 * z3256;
    const Scalar z3258 = s_q4 * z3251 + c_q4 * z3257;
    const Scalar z3259 = s_q5 * z3256 + c_q5 * z3255;
    const Scalar z3260 = s_q3 * z3258 - c_q3 * z3259;
    const Scalar z3261 = n0_088 * z3252;
    const Scalar z3262 = n0_088 * z3231;
    const Scalar z3263 = s_q7 * z3261 - c_q7 * z3262;
    const Scalar z3264 = s_q7 * z3262 + c_q7 * z3261;
    const Scalar z3265 = z3246 - z3247;
    const Scalar z3266 = z3242 - z3243;
    const Scalar z3267 = z3234 + z3236;
    const Scalar z3268 = k4 * z59 + k9 * z3232 + k1 * z3263 + k0 * z3264 - k3 * z3265 + k2 * z3266 - k11 * z3267;
    const Scalar z3269 = k53 * z59 + k16 * z3231 + n0_088 * z3253 - k15 * z3254 + z3268;
    const Scalar z3270 = k3 * z3234 - k2 * z3237 - k52 * z3243 - k11 * z3248;
    const Scalar z3271 = k3 * z3233 - k2 * z3236 - k11 * z3244 - k9 * z3246 - k4 * z3247;
    const Scalar z3272 = s_q7 * z3270 + c_q7 * z3271;
    const Scalar z3273 = k66 * z60 - k17 * z3231 - k15 * z3252 - z3272;
    const Scalar z3274 = s_q6 * z3269 + c_q6 * z3273;
    const Scalar z3275 = s_q7 * z3271 - c_q7 * z3270;
    const Scalar z3276 = n0_088 * z3249 + z3275;
    const Scalar z3277 = s_q5 * z3274 + c_q5 * z3276;
    const Scalar z3278 = n0_0825 * z3251 - n0_384 * z3257 - z3277;
    const Scalar z3279 = s_q4 * z3257 - c_q4 * z3251;
    const Scalar z3280 = z3278 + n0_0825 * z3279;
    const Scalar z3281 = s_q6 * z3273 - c_q6 * z3269;
    const Scalar z3282 = n0_0825 * z3259 + z3281;
    const Scalar z3283 = s_q5 * z3276 - c_q5 * z3274;
    const Scalar z3284 = n0_384 * z3259 - z3283;
    const Scalar z3285 = s_q4 * z3282 - c_q4 * z3284;
    const Scalar z3286 = s_q3 * z3280 - c_q3 * z3285;
    const Scalar z3287 = n0_316 * z3260 - z3286;
    const Scalar z3288 = s_q4 * z3284 + c_q4 * z3282;
    const Scalar z3289 = n0_0825 * z3259 - z3288;
    const Scalar z3290 = s_q2 * z3287 - c_q2 * z3289;
    const Scalar z3291 = n2 * z59 * z60;
    const Scalar z3292 = n2 * z59 * z70;
    const Scalar z3293 = n2 * z66 * z3245;
    const Scalar z3294 = z3292 + z3293;
    const Scalar z3295 = z66 * z3241 + z67 * z3245;
    const Scalar z3296 = z929 - z3295;
    const Scalar z3297 = k1 * z3294 + k0 * z3296;
    const Scalar z3298 = n2 * z67 * z3241;
    const Scalar z3299 = z3292 + z3298;
    const Scalar z3300 = z929 + z3295;
    const Scalar z3301 = k0 * z3299 - k1 * z3300;
    const Scalar z3302 = s_q7 * z3297 + c_q7 * z3301;
    const Scalar z3303 = z59 * z59 - z60 * z60;
    const Scalar z3304 = k13 * z3291 - z3302 + k19 * z3303;
    const Scalar z3305 = z59 * z66 + z70 * z3245;
    const Scalar z3306 = s_q7 * z930;
    const Scalar z3307 = v_q7 * z3245 - z3306;
    const Scalar z3308 = z3305 + z3307;
    const Scalar z3309 = z59 * z67 + z70 * z3241;
    const Scalar z3310 = c_q7 * z930;
    const Scalar z3311 = v_q7 * z3241 + z3310;
    const Scalar z3312 = z3309 + z3311;
    const Scalar z3313 = k0 * z3308 + k1 * z3312;
    const Scalar z3314 = k19 * z3291 - k13 * z3303 - z3313;
    const Scalar z3315 = s_q6 * (z965 - z3304) + c_q6 * (z964 - z3314);
    const Scalar z3316 = s_q7 * z3301 - c_q7 * z3297;
    const Scalar z3317 = k19 * z933 + k13 * z961 - z3316;
    const Scalar z3318 = s_q6 * (z964 - z3314) - c_q6 * (z965 - z3304);
    const Scalar z3319 = s_q5 * z3317 + c_q5 * z3318;
    const Scalar z3320 = s_q4 * z3315 + c_q4 * z3319;
    const Scalar z3321 = s_q5 * z3318 - c_q5 * z3317;
    const Scalar z3322 = s_q3 * z3320 + c_q3 * z3321;
    const Scalar z3323 = z3293 - z3298;
    const Scalar z3324 = n0_088 * z961;
    const Scalar z3325 = z928 - n0_088 * z3291;
    const Scalar z3326 = s_q7 * z3324 - c_q7 * z3325;
    const Scalar z3327 = s_q7 * z3325 + c_q7 * z3324;
    const Scalar z3328 = z3309 - z3311;
    const Scalar z3329 = z3305 - z3307;
    const Scalar z3330 = k4 * z929 + k9 * z3295 - k11 * z3323 + k1 * z3326 + k0 * z3327 - k3 * z3328 - k2 * z3329;
    const Scalar z3331 = k53 * z784 + k15 * z933 - k16 * z3291 - k17 * z3303 - n0_088 * z3316 + z3330;
    const Scalar z3332 = z3292 - z3293;
    const Scalar z3333 = z927 - n0_088 * z3303;
    const Scalar z3334 = k2 * z3300 + k52 * z3305 - k11 * z3312 + k3 * z3332 - k0 * z3333;
    const Scalar z3335 = z3292 - z3298;
    const Scalar z3336 = k3 * z3296 - k11 * z3308 + k4 * z3309 + k9 * z3311 - k1 * z3333 - k2 * z3335;
    const Scalar z3337 = s_q7 * z3334 - c_q7 * z3336;
    const Scalar z3338 = k18 * z743 - k14 * z930 + k15 * z961 + k17 * z3291 - k16 * z3303 - z3337;
    const Scalar z3339 = s_q6 * (z967 - z3331) - c_q6 * (z968 - z3338);
    const Scalar z3340 = n2 * z3291;
    const Scalar z3341 = s_q7 * z3336 + c_q7 * z3334;
    const Scalar z3342 = k13 * z927 - k19 * z928 + k17 * z962 - k16 * z963 - k14 * z3303 - n0_088 * z3313 + k15 * z3340
        - z3341;
    const Scalar z3343 = s_q5 * z3339 + c_q5 * z3342;
    const Scalar z3344 = n0_0825 * z3315 - n0_384 * z3319 + z3343;
    const Scalar z3345 = s_q4 * z3319 - c_q4 * z3315;
    const Scalar z3346 = z3344 + n0_0825 * z3345;
    const Scalar z3347 = s_q6 * (z968 - z3338) + c_q6 * (z967 - z3331);
    const Scalar z3348 = n0_0825 * z3321 - z3347;
    const Scalar z3349 = s_q5 * z3342 - c_q5 * z3339;
    const Scalar z3350 = n0_384 * z3321 - z3349;
    const Scalar z3351 = s_q4 * z3348 - c_q4 * z3350;
    const Scalar z3352 = s_q3 * z3346 + c_q3 * z3351;
    const Scalar z3353 = n0_316 * z3322 - z3352;
    const Scalar z3354 = s_q4 * z3350 + c_q4 * z3348;
    const Scalar z3355 = n0_0825 * z3321 - z3354;
    const Scalar z3356 = s_q2 * z3353 + c_q2 * z3355;
    const Scalar z3357 = s_q3 * z3259 + c_q3 * z3258;
    const Scalar z3358 = s_q3 * z3285 + c_q3 * z3280;
    const Scalar z3359 = n0_316 * z3357 - z3358;
    const Scalar z3360 = s_q3 * z3321 - c_q3 * z3320;
    const Scalar z3361 = s_q3 * z3351 - c_q3 * z3346;
    const Scalar z3362 = n0_316 * z3360 - z3361;
    const Scalar z3363 = n2 * z70;
    const Scalar z3364 = k1 * z3363;
    const Scalar z3365 = k0 * z3363;
    const Scalar z3366 = s_q7 * z3364 + c_q7 * z3365;
    const Scalar z3367 = n2 * z66;
    const Scalar z3368 = n2 * z67;
    const Scalar z3369 = k0 * z3367 + k1 * z3368;
    const Scalar z3370 = s_q6 * z3366 + c_q6 * z3369;
    const Scalar z3371 = s_q7 * z3365 - c_q7 * z3364;
    const Scalar z3372 = s_q6 * z3369 - c_q6 * z3366;
    const Scalar z3373 = s_q5 * z3371 - c_q5 * z3372;
    const Scalar z3374 = s_q4 * z3370 - c_q4 * z3373;
    const Scalar z3375 = s_q5 * z3372 + c_q5 * z3371;
    const Scalar z3376 = s_q3 * z3374 + c_q3 * z3375;
    const Scalar z3377 = n0_088 * z3371;
    const Scalar z3378 = k52 * z66 + k3 * z3363 - k11 * z3368;
    const Scalar z3379 = k67 * z67 - k2 * z3363 - k11 * z3367;
    const Scalar z3380 = s_q7 * z3378 - c_q7 * z3379;
    const Scalar z3381 = s_q6 * z3377 - c_q6 * z3380;
    const Scalar z3382 = s_q7 * z3379 + c_q7 * z3378;
    const Scalar z3383 = n0_088 * z3369 + z3382;
    const Scalar z3384 = s_q5 * z3381 - c_q5 * z3383;
    const Scalar z3385 = n0_0825 * z3370 + n0_384 * z3373 + z3384;
    const Scalar z3386 = s_q4 * z3373 + c_q4 * z3370;
    const Scalar z3387 = z3385 - n0_0825 * z3386;
    const Scalar z3388 = s_q6 * z3380 + c_q6 * z3377;
    const Scalar z3389 = n0_0825 * z3375 - z3388;
    const Scalar z3390 = s_q5 * z3383 + c_q5 * z3381;
    const Scalar z3391 = n0_384 * z3375 + z3390;
    const Scalar z3392 = s_q4 * z3389 - c_q4 * z3391;
    const Scalar z3393 = s_q3 * z3387 + c_q3 * z3392;
    const Scalar z3394 = n0_316 * z3376 - z3393;
    const Scalar z3395 = s_q4 * z3391 + c_q4 * z3389;
    const Scalar z3396 = n0_0825 * z3375 - z3395;
    const Scalar z3397 = s_q2 * z3394 + c_q2 * z3396;
    const Scalar z3398 = n2 * z66 * z67;
    const Scalar z3399 = z66 * z66 - z67 * z67;
    const Scalar z3400 = k1 * z3398 + k0 * z3399;
    const Scalar z3401 = k0 * z3398 - k1 * z3399;
    const Scalar z3402 = s_q7 * (z950 + z3400) - c_q7 * (z951 + z3401);
    const Scalar z3403 = k1 * z946 - k0 * z947;
    const Scalar z3404 = s_q6 * z3402 - c_q6 * z3403;
    const Scalar z3405 = s_q7 * (z951 + z3401) + c_q7 * (z950 + z3400);
    const Scalar z3406 = s_q6 * z3403 + c_q6 * z3402;
    const Scalar z3407 = s_q5 * z3405 - c_q5 * z3406;
    const Scalar z3408 = s_q4 * z3404 + c_q4 * z3407;
    const Scalar z3409 = s_q5 * z3406 + c_q5 * z3405;
    const Scalar z3410 = s_q3 * z3408 - c_q3 * z3409;
    const Scalar z3411 = n2 * z3398;
    const Scalar z3412 = k0 * z939 - k1 * z940 - k2 * z948 + k3 * z949 - k9 * z3399 - k11 * z3411;
    const Scalar z3413 = n0_088 * z3405 + z3412;
    const Scalar z3414 = k52 * z764 + k11 * z946 - k3 * z3398 - k2 * z3399;
    const Scalar z3415 = k4 * z762 + k9 * z942 + k11 * z947 + k2 * z3398 - k3 * z3399;
    const Scalar z3416 = s_q7 * (z953 - z3414) + c_q7 * (z954 - z3415);
    const Scalar z3417 = s_q6 * z3413 - c_q6 * z3416;
    const Scalar z3418 = s_q7 * (z954 - z3415) - c_q7 * (z953 - z3414);
    const Scalar z3419 = n0_088 * z3403 - z3418;
    const Scalar z3420 = s_q5 * z3417 - c_q5 * z3419;
    const Scalar z3421 = n0_0825 * z3404 - n0_384 * z3407 - z3420;
    const Scalar z3422 = s_q4 * z3407 - c_q4 * z3404;
    const Scalar z3423 = z3421 + n0_0825 * z3422;
    const Scalar z3424 = s_q6 * z3416 + c_q6 * z3413;
    const Scalar z3425 = n0_0825 * z3409 - z3424;
    const Scalar z3426 = s_q5 * z3419 + c_q5 * z3417;
    const Scalar z3427 = n0_384 * z3409 + z3426;
    const Scalar z3428 = s_q4 * z3425 - c_q4 * z3427;
    const Scalar z3429 = s_q3 * z3423 - c_q3 * z3428;
    const Scalar z3430 = n0_316 * z3410 - z3429;
    const Scalar z3431 = s_q4 * z3427 + c_q4 * z3425;
    const Scalar z3432 = n0_0825 * z3409 - z3431;
    const Scalar z3433 = s_q2 * z3430 - c_q2 * z3432;
    const Scalar z3434 = s_q3 * z3375 - c_q3 * z3374;
    const Scalar z3435 = s_q3 * z3392 - c_q3 * z3387;
    const Scalar z3436 = n0_316 * z3434 - z3435;
    const Scalar z3437 = s_q3 * z3409 + c_q3 * z3408;
    const Scalar z3438 = s_q3 * z3428 + c_q3 * z3423;
    const Scalar z3439 = n0_316 * z3437 - z3438;
    const Scalar z3440 = z1636 * z2036 + z2055;
    const Scalar z3441 = z1635 * z2036 - z1663 * z3440 + z2072;
    const Scalar z3442 = z1634 * z2036 - z1662 * z3440 - z1683 * z3441 + z2062;
    const Scalar z3443 = z1633 * z2036 - z1661 * z3440 - z1682 * z3441 - z1697 * z3442 - z2089;
    const Scalar z3444 = z1632 * z2036 - z1660 * z3440 - z1681 * z3441 - z1696 * z3442 - z1706 * z3443 + z2095;
    const Scalar z3445 = z1631 * z2036 - z1659 * z3440 - z1680 * z3441 - z1695 * z3442 - z1705 * z3443 - z1711 * z3444
        - z2091;
    const Scalar z3446 = z1713 * z3445;
    const Scalar z3447 = z1710 * z3444 - z1711 * z3446;
    const Scalar z3448 = z1704 * z3443 - z1705 * z3446 - z1706 * z3447;
    const Scalar z3449 = z1694 * z3442 - z1695 * z3446 - z1696 * z3447 - z1697 * z3448;
    const Scalar z3450 = z1679 * z3441 - z1680 * z3446 - z1681 * z3447 - z1682 * z3448 - z1683 * z3449;
    const Scalar z3451 = z1658 * z3440 - z1659 * z3446 - z1660 * z3447 - z1661 * z3448 - z1662 * z3449 - z1663 * z3450;
    const Scalar z3452 = z1631 * z3446 + z1632 * z3447 + z1633 * z3448 + z1634 * z3449 + z1635 * z3450 + z1636 * z3451
        - k60 * z2036;
    const Scalar z3453 = z1636 * z2413 - z2431;
    const Scalar z3454 = z1635 * z2413 - z1663 * z3453 - z2447;
    const Scalar z3455 = z1634 * z2413 - z1662 * z3453 - z1683 * z3454 + z2436;
    const Scalar z3456 = z1633 * z2413 - z1661 * z3453 - z1682 * z3454 - z1697 * z3455 - z2460;
    const Scalar z3457 = z1632 * z2413 - z1660 * z3453 - z1681 * z3454 - z1696 * z3455 - z1706 * z3456 + z2469;
    const Scalar z3458 = z1631 * z2413 - z1659 * z3453 - z1680 * z3454 - z1695 * z3455 - z1705 * z3456 - z1711 * z3457
        - z2462;
    const Scalar z3459 = z1713 * z3458;
    const Scalar z3460 = z1710 * z3457 - z1711 * z3459;
    const Scalar z3461 = z1704 * z3456 - z1705 * z3459 - z1706 * z3460;
    const Scalar z3462 = z1694 * z3455 - z1695 * z3459 - z1696 * z3460 - z1697 * z3461;
    const Scalar z3463 = z1679 * z3454 - z1680 * z3459 - z1681 * z3460 - z1682 * z3461 - z1683 * z3462;
    const Scalar z3464 = z1658 * z3453 - z1659 * z3459 - z1660 * z3460 - z1661 * z3461 - z1662 * z3462 - z1663 * z3463;
    const Scalar z3465 = z1631 * z3459 + z1632 * z3460 + z1633 * z3461 + z1634 * z3462 + z1635 * z3463 + z1636 * z3464
        - k60 * z2413;
    const Scalar z3466 = z1636 * z2223 - z2242;
    const Scalar z3467 = z1635 * z2223 - z1663 * z3466 - z2258;
    const Scalar z3468 = z1634 * z2223 - z1662 * z3466 - z1683 * z3467 + z2249;
    const Scalar z3469 = z1633 * z2223 - z1661 * z3466 - z1682 * z3467 - z1697 * z3468 + z2273;
    const Scalar z3470 = z1632 * z2223 - z1660 * z3466 - z1681 * z3467 - z1696 * z3468 - z1706 * z3469 + z2465;
    const Scalar z3471 = z1631 * z2223 - z1659 * z3466 - z1680 * z3467 - z1695 * z3468 - z1705 * z3469 - z1711 * z3470
        + z2275;
    const Scalar z3472 = z1713 * z3471;
    const Scalar z3473 = z1710 * z3470 - z1711 * z3472;
    const Scalar z3474 = z1704 * z3469 - z1705 * z3472 - z1706 * z3473;
    const Scalar z3475 = z1694 * z3468 - z1695 * z3472 - z1696 * z3473 - z1697 * z3474;
    const Scalar z3476 = z1679 * z3467 - z1680 * z3472 - z1681 * z3473 - z1682 * z3474 - z1683 * z3475;
    const Scalar z3477 = z1658 * z3466 - z1659 * z3472 - z1660 * z3473 - z1661 * z3474 - z1662 * z3475 - z1663 * z3476;
    const Scalar z3478 = z1631 * z3472 + z1632 * z3473 + z1633 * z3474 + z1634 * z3475 + z1635 * z3476 + z1636 * z3477
        - k60 * z2223;
    const Scalar z3479 = z1636 * z2736 - z2754;
    const Scalar z3480 = z1635 * z2736 - z1663 * z3479 - z2767;
    const Scalar z3481 = z1634 * z2736 - z1662 * z3479 - z1683 * z3480 + z2759;
    const Scalar z3482 = z1633 * z2736 - z1661 * z3479 - z1682 * z3480 - z1697 * z3481 + z2778;
    const Scalar z3483 = z1632 * z2736 - z1660 * z3479 - z1681 * z3480 - z1696 * z3481 - z1706 * z3482 + z2785;
    const Scalar z3484 = z1631 * z2736 - z1659 * z3479 - z1680 * z3480 - z1695 * z3481 - z1705 * z3482 - z1711 * z3483
        + z2779;
    const Scalar z3485 = z1713 * z3484;
    const Scalar z3486 = z1710 * z3483 - z1711 * z3485;
    const Scalar z3487 = z1704 * z3482 - z1705 * z3485 - z1706 * z3486;
    const Scalar z3488 = z1694 * z3481 - z1695 * z3485 - z1696 * z3486 - z1697 * z3487;
    const Scalar z3489 = z1679 * z3480 - z1680 * z3485 - z1681 * z3486 - z1682 * z3487 - z1683 * z3488;
    const Scalar z3490 = z1658 * z3479 - z1659 * z3485 - z1660 * z3486 - z1661 * z3487 - z1662 * z3488 - z1663 * z3489;
    const Scalar z3491 = z1631 * z3485 + z1632 * z3486 + z1633 * z3487 + z1634 * z3488 + z1635 * z3489 + z1636 * z3490
        - k60 * z2736;
    const Scalar z3492 = z1636 * z2576 + z2595;
    const Scalar z3493 = z1635 * z2576 - z1663 * z3492 + z2610;
    const Scalar z3494 = z1634 * z2576 - z1662 * z3492 - z1683 * z3493 - z2602;
    const Scalar z3495 = z1633 * z2576 - z1661 * z3492 - z1682 * z3493 - z1697 * z3494 + z2619;
    const Scalar z3496 = z1632 * z2576 - z1660 * z3492 - z1681 * z3493 - z1696 * z3494 - z1706 * z3495 - z2782;
    const Scalar z3497 = z1631 * z2576 - z1659 * z3492 - z1680 * z3493 - z1695 * z3494 - z1705 * z3495 - z1711 * z3496
        + z2620;
    const Scalar z3498 = z1713 * z3497;
    const Scalar z3499 = z1710 * z3496 - z1711 * z3498;
    const Scalar z3500 = z1704 * z3495 - z1705 * z3498 - z1706 * z3499;
    const Scalar z3501 = z1694 * z3494 - z1695 * z3498 - z1696 * z3499 - z1697 * z3500;
    const Scalar z3502 = z1679 * z3493 - z1680 * z3498 - z1681 * z3499 - z1682 * z3500 - z1683 * z3501;
    const Scalar z3503 = z1658 * z3492 - z1659 * z3498 - z1660 * z3499 - z1661 * z3500 - z1662 * z3501 - z1663 * z3502;
    const Scalar z3504 = z1631 * z3498 + z1632 * z3499 + z1633 * z3500 + z1634 * z3501 + z1635 * z3502 + z1636 * z3503
        - k60 * z2576;
    const Scalar z3505 = z1636 * z2997 - z3015;
    const Scalar z3506 = z1635 * z2997 - z1663 * z3505 + z3025;
    const Scalar z3507 = z1634 * z2997 - z1662 * z3505 - z1683 * z3506 + z3018;
    const Scalar z3508 = z1633 * z2997 - z1661 * z3505 - z1682 * z3506 - z1697 * z3507 - z3033;
    const Scalar z3509 = z1632 * z2997 - z1660 * z3505 - z1681 * z3506 - z1696 * z3507 - z1706 * z3508 - z3040;
    const Scalar z3510 = z1631 * z2997 - z1659 * z3505 - z1680 * z3506 - z1695 * z3507 - z1705 * z3508 - z1711 * z3509
        - z3034;
    const Scalar z3511 = z1713 * z3510;
    const Scalar z3512 = z1710 * z3509 - z1711 * z3511;
    const Scalar z3513 = z1704 * z3508 - z1705 * z3511 - z1706 * z3512;
    const Scalar z3514 = z1694 * z3507 - z1695 * z3511 - z1696 * z3512 - z1697 * z3513;
    const Scalar z3515 = z1679 * z3506 - z1680 * z3511 - z1681 * z3512 - z1682 * z3513 - z1683 * z3514;
    const Scalar z3516 = z1658 * z3505 - z1659 * z3511 - z1660 * z3512 - z1661 * z3513 - z1662 * z3514 - z1663 * z3515;
    const Scalar z3517 = z1631 * z3511 + z1632 * z3512 + z1633 * z3513 + z1634 * z3514 + z1635 * z3515 + z1636 * z3516
        - k60 * z2997;
    const Scalar z3518 = z1636 * z2869 + z2887;
    const Scalar z3519 = z1635 * z2869 - z1663 * z3518 - z2897;
    const Scalar z3520 = z1634 * z2869 - z1662 * z3518 - z1683 * z3519 + z2890;
    const Scalar z3521 = z1633 * z2869 - z1661 * z3518 - z1682 * z3519 - z1697 * z3520 - z2905;
    const Scalar z3522 = z1632 * z2869 - z1660 * z3518 - z1681 * z3519 - z1696 * z3520 - z1706 * z3521 - z3037;
    const Scalar z3523 = z1631 * z2869 - z1659 * z3518 - z1680 * z3519 - z1695 * z3520 - z1705 * z3521 - z1711 * z3522
        + z2906;
    const Scalar z3524 = z1713 * z3523;
    const Scalar z3525 = z1710 * z3522 - z1711 * z3524;
    const Scalar z3526 = z1704 * z3521 - z1705 * z3524 - z1706 * z3525;
    const Scalar z3527 = z1694 * z3520 - z1695 * z3524 - z1696 * z3525 - z1697 * z3526;
    const Scalar z3528 = z1679 * z3519 - z1680 * z3524 - z1681 * z3525 - z1682 * z3526 - z1683 * z3527;
    const Scalar z3529 = z1658 * z3518 - z1659 * z3524 - z1660 * z3525 - z1661 * z3526 - z1662 * z3527 - z1663 * z3528;
    const Scalar z3530 = z1631 * z3524 + z1632 * z3525 + z1633 * z3526 + z1634 * z3527 + z1635 * z3528 + z1636 * z3529
        - k60 * z2869;
    const Scalar z3531 = z1636 * z3190 + z3207;
    const Scalar z3532 = z1635 * z3190 - z1663 * z3531 + z3215;
    const Scalar z3533 = z1634 * z3190 - z1662 * z3531 - z1683 * z3532 - z3210;
    const Scalar z3534 = z1633 * z3190 - z1661 * z3531 - z1682 * z3532 - z1697 * z3533 - z3223;
    const Scalar z3535 = z1632 * z3190 - z1660 * z3531 - z1681 * z3532 - z1696 * z3533 - z1706 * z3534 - z3230;
    const Scalar z3536 = z1631 * z3190 - z1659 * z3531 - z1680 * z3532 - z1695 * z3533 - z1705 * z3534 - z1711 * z3535
        - z3224;
    const Scalar z3537 = z1713 * z3536;
    const Scalar z3538 = z1710 * z3535 - z1711 * z3537;
    const Scalar z3539 = z1704 * z3534 - z1705 * z3537 - z1706 * z3538;
    const Scalar z3540 = z1694 * z3533 - z1695 * z3537 - z1696 * z3538 - z1697 * z3539;
    const Scalar z3541 = z1679 * z3532 - z1680 * z3537 - z1681 * z3538 - z1682 * z3539 - z1683 * z3540;
    const Scalar z3542 = z1658 * z3531 - z1659 * z3537 - z1660 * z3538 - z1661 * z3539 - z1662 * z3540 - z1663 * z3541;
    const Scalar z3543 = z1631 * z3537 + z1632 * z3538 + z1633 * z3539 + z1634 * z3540 + z1635 * z3541 + z1636 * z3542
        - k60 * z3190;
    const Scalar z3544 = z1636 * z3097 - z3112;
    const Scalar z3545 = z1635 * z3097 - z1663 * z3544 - z3118;
    const Scalar z3546 = z1634 * z3097 - z1662 * z3544 - z1683 * z3545 - z3115;
    const Scalar z3547 = z1633 * z3097 - z1661 * z3544 - z1682 * z3545 - z1697 * z3546 + z3126;
    const Scalar z3548 = z1632 * z3097 - z1660 * z3544 - z1681 * z3545 - z1696 * z3546 - z1706 * z3547 + z3227;
    const Scalar z3549 = z1631 * z3097 - z1659 * z3544 - z1680 * z3545 - z1695 * z3546 - z1705 * z3547 - z1711 * z3548
        - z3127;
    const Scalar z3550 = z1713 * z3549;
    const Scalar z3551 = z1710 * z3548 - z1711 * z3550;
    const Scalar z3552 = z1704 * z3547 - z1705 * z3550 - z1706 * z3551;
    const Scalar z3553 = z1694 * z3546 - z1695 * z3550 - z1696 * z3551 - z1697 * z3552;
    const Scalar z3554 = z1679 * z3545 - z1680 * z3550 - z1681 * z3551 - z1682 * z3552 - z1683 * z3553;
    const Scalar z3555 = z1658 * z3544 - z1659 * z3550 - z1660 * z3551 - z1661 * z3552 - z1662 * z3553 - z1663 * z3554;
    const Scalar z3556 = z1631 * z3550 + z1632 * z3551 + z1633 * z3552 + z1634 * z3553 + z1635 * z3554 + z1636 * z3555
        - k60 * z3097;
    const Scalar z3557 = z1636 * z3330 + z3342;
    const Scalar z3558 = z1635 * z3330 - z1663 * z3557 - z3347;
    const Scalar z3559 = z1634 * z3330 - z1662 * z3557 - z1683 * z3558 - z3344;
    const Scalar z3560 = z1633 * z3330 - z1661 * z3557 - z1682 * z3558 - z1697 * z3559 + z3355;
    const Scalar z3561 = z1632 * z3330 - z1660 * z3557 - z1681 * z3558 - z1696 * z3559 - z1706 * z3560 + z3362;
    const Scalar z3562 = z1631 * z3330 - z1659 * z3557 - z1680 * z3558 - z1695 * z3559 - z1705 * z3560 - z1711 * z3561
        - z3356;
    const Scalar z3563 = z1713 * z3562;
    const Scalar z3564 = z1710 * z3561 - z1711 * z3563;
    const Scalar z3565 = z1704 * z3560 - z1705 * z3563 - z1706 * z3564;
    const Scalar z3566 = z1694 * z3559 - z1695 * z3563 - z1696 * z3564 - z1697 * z3565;
    const Scalar z3567 = z1679 * z3558 - z1680 * z3563 - z1681 * z3564 - z1682 * z3565 - z1683 * z3566;
    const Scalar z3568 = z1658 * z3557 - z1659 * z3563 - z1660 * z3564 - z1661 * z3565 - z1662 * z3566 - z1663 * z3567;
    const Scalar z3569 = z1631 * z3563 + z1632 * z3564 + z1633 * z3565 + z1634 * z3566 + z1635 * z3567 + z1636 * z3568
        - k60 * z3330;
    const Scalar z3570 = z1636 * z3268 - z3276;
    const Scalar z3571 = z1635 * z3268 - z1663 * z3570 - z3281;
    const Scalar z3572 = z1634 * z3268 - z1662 * z3570 - z1683 * z3571 - z3278;
    const Scalar z3573 = z1633 * z3268 - z1661 * z3570 - z1682 * z3571 - z1697 * z3572 - z3289;
    const Scalar z3574 = z1632 * z3268 - z1660 * z3570 - z1681 * z3571 - z1696 * z3572 - z1706 * z3573 - z3359;
    const Scalar z3575 = z1631 * z3268 - z1659 * z3570 - z1680 * z3571 - z1695 * z3572 - z1705 * z3573 - z1711 * z3574
        - z3290;
    const Scalar z3576 = z1713 * z3575;
    const Scalar z3577 = z1710 * z3574 - z1711 * z3576;
    const Scalar z3578 = z1704 * z3573 - z1705 * z3576 - z1706 * z3577;
    const Scalar z3579 = z1694 * z3572 - z1695 * z3576 - z1696 * z3577 - z1697 * z3578;
    const Scalar z3580 = z1679 * z3571 - z1680 * z3576 - z1681 * z3577 - z1682 * z3578 - z1683 * z3579;
    const Scalar z3581 = z1658 * z3570 - z1659 * z3576 - z1660 * z3577 - z1661 * z3578 - z1662 * z3579 - z1663 * z3580;
    const Scalar z3582 = z1631 * z3576 + z1632 * z3577 + z1633 * z3578 + z1634 * z3579 + z1635 * z3580 + z1636 * z3581
        - k60 * z3268;
    const Scalar z3583 = z1636 * z3412 + z3419;
    const Scalar z3584 = z1635 * z3412 - z1663 * z3583 + z3424;
    const Scalar z3585 = z1634 * z3412 - z1662 * z3583 - z1683 * z3584 - z3421;
    const Scalar z3586 = z1633 * z3412 - z1661 * z3583 - z1682 * z3584 - z1697 * z3585 - z3432;
    const Scalar z3587 = z1632 * z3412 - z1660 * z3583 - z1681 * z3584 - z1696 * z3585 - z1706 * z3586 - z3439;
    const Scalar z3588 = z1631 * z3412 - z1659 * z3583 - z1680 * z3584 - z1695 * z3585 - z1705 * z3586 - z1711 * z3587
        - z3433;
    const Scalar z3589 = z1713 * z3588;
    const Scalar z3590 = z1710 * z3587 - z1711 * z3589;
    const Scalar z3591 = z1704 * z3586 - z1705 * z3589 - z1706 * z3590;
    const Scalar z3592 = z1694 * z3585 - z1695 * z3589 - z1696 * z3590 - z1697 * z3591;
    const Scalar z3593 = z1679 * z3584 - z1680 * z3589 - z1681 * z3590 - z1682 * z3591 - z1683 * z3592;
    const Scalar z3594 = z1658 * z3583 - z1659 * z3589 - z1660 * z3590 - z1661 * z3591 - z1662 * z3592 - z1663 * z3593;
    const Scalar z3595 = z1631 * z3589 + z1632 * z3590 + z1633 * z3591 + z1634 * z3592 + z1635 * z3593 + z1636 * z3594
        - k60 * z3412;
    const Scalar z3596 = z1663 * z3383 - z3388;
    const Scalar z3597 = z1662 * z3383 - z1683 * z3596 - z3385;
    const Scalar z3598 = z1661 * z3383 - z1682 * z3596 - z1697 * z3597 + z3396;
    const Scalar z3599 = z1660 * z3383 - z1681 * z3596 - z1696 * z3597 - z1706 * z3598 + z3436;
    const Scalar z3600 = z1659 * z3383 - z1680 * z3596 - z1695 * z3597 - z1705 * z3598 - z1711 * z3599 - z3397;
    const Scalar z3601 = z1713 * z3600;
    const Scalar z3602 = z1710 * z3599 - z1711 * z3601;
    const Scalar z3603 = z1704 * z3598 - z1705 * z3601 - z1706 * z3602;
    const Scalar z3604 = z1694 * z3597 - z1695 * z3601 - z1696 * z3602 - z1697 * z3603;
    const Scalar z3605 = z1679 * z3596 - z1680 * z3601 - z1681 * z3602 - z1682 * z3603 - z1683 * z3604;
    const Scalar z3606 = z1658 * z3383 + z1659 * z3601 + z1660 * z3602 + z1661 * z3603 + z1662 * z3604 + z1663 * z3605;
    const Scalar z3607 = z1631 * z3601 + z1632 * z3602 + z1633 * z3603 + z1634 * z3604 + z1635 * z3605 - z1636 * z3606;
    const Scalar z3608 = z1711 * z1713;
    const Scalar z3609 = z1705 * z1713 - z1706 * z3608;
    const Scalar z3610 = z1695 * z1713 - z1696 * z3608 - z1697 * z3609;
    const Scalar z3611 = z1680 * z1713 - z1681 * z3608 - z1682 * z3609 - z1683 * z3610;
    const Scalar z3612 = z1659 * z1713 - z1660 * z3608 - z1661 * z3609 - z1662 * z3610 - z1663 * z3611;
    const Scalar z3613 = z1631 * z1713 - z1632 * z3608 - z1633 * z3609 - z1634 * z3610 - z1635 * z3611 - z1636 * z3612;
    const Scalar z3614 = z1710 + z1711 * z3608;
    const Scalar z3615 = z1705 * z3608 - z1706 * z3614;
    const Scalar z3616 = z1695 * z3608 - z1696 * z3614 - z1697 * z3615;
    const Scalar z3617 = z1680 * z3608 - z1681 * z3614 - z1682 * z3615 - z1683 * z3616;
    const Scalar z3618 = z1659 * z3608 - z1660 * z3614 - z1661 * z3615 - z1662 * z3616 - z1663 * z3617;
    const Scalar z3619 = z1631 * z3608 - z1632 * z3614 - z1633 * z3615 - z1634 * z3616 - z1635 * z3617 - z1636 * z3618;
    const Scalar z3620 = z1705 - z1706 * z1711;
    const Scalar z3621 = z1713 * z3620;
    const Scalar z3622 = z1706 * z1710 - z1711 * z3621;
    const Scalar z3623 = z1704 + z1705 * z3621 + z1706 * z3622;
    const Scalar z3624 = z1695 * z3621 + z1696 * z3622 - z1697 * z3623;
    const Scalar z3625 = z1680 * z3621 + z1681 * z3622 - z1682 * z3623 - z1683 * z3624;
    const Scalar z3626 = z1659 * z3621 + z1660 * z3622 - z1661 * z3623 - z1662 * z3624 - z1663 * z3625;
    const Scalar z3627 = z1631 * z3621 + z1632 * z3622 - z1633 * z3623 - z1634 * z3624 - z1635 * z3625 - z1636 * z3626;
    const Scalar z3628 = z1696 - z1697 * z1706;
    const Scalar z3629 = z1695 - z1697 * z1705 - z1711 * z3628;
    const Scalar z3630 = z1713 * z3629;
    const Scalar z3631 = z1710 * z3628 - z1711 * z3630;
    const Scalar z3632 = z1697 * z1704 - z1705 * z3630 - z1706 * z3631;
    const Scalar z3633 = z1694 + z1695 * z3630 + z1696 * z3631 + z1697 * z3632;
    const Scalar z3634 = z1680 * z3630 + z1681 * z3631 + z1682 * z3632 - z1683 * z3633;
    const Scalar z3635 = z1659 * z3630 + z1660 * z3631 + z1661 * z3632 - z1662 * z3633 - z1663 * z3634;
    const Scalar z3636 = z1631 * z3630 + z1632 * z3631 + z1633 * z3632 - z1634 * z3633 - z1635 * z3634 - z1636 * z3635;
    const Scalar z3637 = z1682 - z1683 * z1697;
    const Scalar z3638 = z1681 - z1683 * z1696 - z1706 * z3637;
    const Scalar z3639 = z1680 - z1683 * z1695 - z1705 * z3637 - z1711 * z3638;
    const Scalar z3640 = z1713 * z3639;
    const Scalar z3641 = z1710 * z3638 - z1711 * z3640;
    const Scalar z3642 = z1704 * z3637 - z1705 * z3640 - z1706 * z3641;
    const Scalar z3643 = z1683 * z1694 - z1695 * z3640 - z1696 * z3641 - z1697 * z3642;
    const Scalar z3644 = z1679 + z1680 * z3640 + z1681 * z3641 + z1682 * z3642 + z1683 * z3643;
    const Scalar z3645 = z1659 * z3640 + z1660 * z3641 + z1661 * z3642 + z1662 * z3643 - z1663 * z3644;
    const Scalar z3646 = z1631 * z3640 + z1632 * z3641 + z1633 * z3642 + z1634 * z3643 - z1635 * z3644 - z1636 * z3645;
    const Scalar z3647 = z1662 - z1663 * z1683;
    const Scalar z3648 = z1661 - z1663 * z1682 - z1697 * z3647;
    const Scalar z3649 = z1660 - z1663 * z1681 - z1696 * z3647 - z1706 * z3648;
    const Scalar z3650 = z1659 - z1663 * z1680 - z1695 * z3647 - z1705 * z3648 - z1711 * z3649;
    const Scalar z3651 = z1713 * z3650;
    const Scalar z3652 = z1710 * z3649 - z1711 * z3651;
    const Scalar z3653 = z1704 * z3648 - z1705 * z3651 - z1706 * z3652;
    const Scalar z3654 = z1694 * z3647 - z1695 * z3651 - z1696 * z3652 - z1697 * z3653;
    const Scalar z3655 = z1663 * z1679 - z1680 * z3651 - z1681 * z3652 - z1682 * z3653 - z1683 * z3654;
    const Scalar z3656 = z1658 + z1659 * z3651 + z1660 * z3652 + z1661 * z3653 + z1662 * z3654 + z1663 * z3655;
    const Scalar z3657 = z1631 * z3651 + z1632 * z3652 + z1633 * z3653 + z1634 * z3654 + z1635 * z3655 - z1636 * z3656;
    const Scalar z3658 = z1635 - z1636 * z1663;
    const Scalar z3659 = z1634 - z1636 * z1662 - z1683 * z3658;
    const Scalar z3660 = z1633 - z1636 * z1661 - z1682 * z3658 - z1697 * z3659;
    const Scalar z3661 = z1632 - z1636 * z1660 - z1681 * z3658 - z1696 * z3659 - z1706 * z3660;
    const Scalar z3662 = z1631 - z1636 * z1659 - z1680 * z3658 - z1695 * z3659 - z1705 * z3660 - z1711 * z3661;
    const Scalar z3663 = z1713 * z3662;
    const Scalar z3664 = z1710 * z3661 - z1711 * z3663;
    const Scalar z3665 = z1704 * z3660 - z1705 * z3663 - z1706 * z3664;
    const Scalar z3666 = z1694 * z3659 - z1695 * z3663 - z1696 * z3664 - z1697 * z3665;
    const Scalar z3667 = z1679 * z3658 - z1680 * z3663 - z1681 * z3664 - z1682 * z3665 - z1683 * z3666;
    const Scalar z3668 = z1636 * z1658 - z1659 * z3663 - z1660 * z3664 - z1661 * z3665 - z1662 * z3666 - z1663 * z3667;
    const Scalar z3669 = k60 - z1631 * z3663 - z1632 * z3664 - z1633 * z3665 - z1634 * z3666 - z1635 * z3667 - z1636
        * z3668;
    result.M[0] = z669;
    result.M[1] = -z655;
    result.M[2] = -z635;
    result.M[3] = z607;
    result.M[4] = z573;
    result.M[5] = -z536;
    result.M[6] = z496;
    result.M[7] = -z655;
    result.M[8] = z651;
    result.M[9] = -z630;
    result.M[10] = z602;
    result.M[11] = z568;
    result.M[12] = z531;
    result.M[13] = z491;
    result.M[14] = -z635;
    result.M[15] = -z630;
    result.M[16] = z625;
    result.M[17] = z596;
    result.M[18] = -z562;
    result.M[19] = -z525;
    result.M[20] = -z485;
    result.M[21] = z607;
    result.M[22] = z602;
    result.M[23] = z596;
    result.M[24] = z592;
    result.M[25] = -z555;
    result.M[26] = -z518;
    result.M[27] = z478;
    result.M[28] = z573;
    result.M[29] = z568;
    result.M[30] = -z562;
    result.M[31] = -z555;
    result.M[32] = z550;
    result.M[33] = -z513;
    result.M[34] = z473;
    result.M[35] = -z536;
    result.M[36] = z531;
    result.M[37] = -z525;
    result.M[38] = -z518;
    result.M[39] = -z513;
    result.M[40] = z509;
    result.M[41] = -z468;
    result.M[42] = z496;
    result.M[43] = z491;
    result.M[44] = -z485;
    result.M[45] = z478;
    result.M[46] = z473;
    result.M[47] = -z468;
    result.M[48] = k4;
    result.C[0] = z2091;
    result.C[1] = -z2095;
    result.C[2] = -z2089;
    result.C[3] = -z2062;
    result.C[4] = -z2072;
    result.C[5] = z2055;
    result.C[6] = z2036;
    result.C[7] = z2275;
    result.C[8] = z2465;
    result.C[9] = -z2273;
    result.C[10] = z2249;
    result.C[11] = -z2258;
    result.C[12] = z2242;
    result.C[13] = -z2223;
    result.C[14] = -z2620;
    result.C[15] = z2782;
    result.C[16] = z2619;
    result.C[17] = z2602;
    result.C[18] = -z2610;
    result.C[19] = z2595;
    result.C[20] = z2576;
    result.C[21] = z2906;
    result.C[22] = -z3037;
    result.C[23] = z2905;
    result.C[24] = z2890;
    result.C[25] = -z2897;
    result.C[26] = -z2887;
    result.C[27] = -z2869;
    result.C[28] = z3127;
    result.C[29] = -z3227;
    result.C[30] = z3126;
    result.C[31] = z3115;
    result.C[32] = z3118;
    result.C[33] = -z3112;
    result.C[34] = z3097;
    result.C[35] = z3290;
    result.C[36] = z3359;
    result.C[37] = -z3289;
    result.C[38] = z3278;
    result.C[39] = z3281;
    result.C[40] = -z3276;
    result.C[41] = z3268;
    result.C[42] = z3397;
    result.C[43] = -z3436;
    result.C[44] = z3396;
    result.C[45] = z3385;
    result.C[46] = z3388;
    result.C[47] = -z3383;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z2462;
    result.K[8] = -z2469;
    result.K[9] = -z2460;
    result.K[10] = -z2436;
    result.K[11] = z2447;
    result.K[12] = -z2431;
    result.K[13] = z2413;
    result.K[14] = z2779;
    result.K[15] = z2785;
    result.K[16] = -z2778;
    result.K[17] = z2759;
    result.K[18] = -z2767;
    result.K[19] = z2754;
    result.K[20] = -z2736;
    result.K[21] = -z3034;
    result.K[22] = -z3040;
    result.K[23] = z3033;
    result.K[24] = z3018;
    result.K[25] = z3025;
    result.K[26] = z3015;
    result.K[27] = -z2997;
    result.K[28] = -z3224;
    result.K[29] = -z3230;
    result.K[30] = z3223;
    result.K[31] = -z3210;
    result.K[32] = z3215;
    result.K[33] = -z3207;
    result.K[34] = -z3190;
    result.K[35] = z3356;
    result.K[36] = -z3362;
    result.K[37] = z3355;
    result.K[38] = z3344;
    result.K[39] = z3347;
    result.K[40] = z3342;
    result.K[41] = z3330;
    result.K[42] = -z3433;
    result.K[43] = -z3439;
    result.K[44] = z3432;
    result.K[45] = -z3421;
    result.K[46] = z3424;
    result.K[47] = -z3419;
    result.K[48] = -z3412;
    result.F[0] = u_tau1 - z1034;
    result.F[1] = u_tau2 - z1025;
    result.F[2] = u_tau3 + z1011;
    result.F[3] = u_tau4 - z997;
    result.F[4] = u_tau5 + z985;
    result.F[5] = u_tau6 - z969;
    result.F[6] = u_tau7 - z955;
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
    result.A[21] = -z3459;
    result.A[22] = -z3460;
    result.A[23] = z3461;
    result.A[24] = -z3462;
    result.A[25] = -z3463;
    result.A[26] = z3464;
    result.A[27] = z3465;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = z3485;
    result.A[36] = z3486;
    result.A[37] = -z3487;
    result.A[38] = z3488;
    result.A[39] = z3489;
    result.A[40] = -z3490;
    result.A[41] = -z3491;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z3511;
    result.A[50] = z3512;
    result.A[51] = -z3513;
    result.A[52] = z3514;
    result.A[53] = z3515;
    result.A[54] = -z3516;
    result.A[55] = -z3517;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z3537;
    result.A[64] = z3538;
    result.A[65] = -z3539;
    result.A[66] = z3540;
    result.A[67] = z3541;
    result.A[68] = -z3542;
    result.A[69] = -z3543;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z3563;
    result.A[78] = -z3564;
    result.A[79] = z3565;
    result.A[80] = -z3566;
    result.A[81] = -z3567;
    result.A[82] = z3568;
    result.A[83] = z3569;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = z3589;
    result.A[92] = z3590;
    result.A[93] = -z3591;
    result.A[94] = z3592;
    result.A[95] = z3593;
    result.A[96] = -z3594;
    result.A[97] = -z3595;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = -z3446;
    result.A[106] = -z3447;
    result.A[107] = z3448;
    result.A[108] = -z3449;
    result.A[109] = -z3450;
    result.A[110] = z3451;
    result.A[111] = z3452;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = z3472;
    result.A[120] = z3473;
    result.A[121] = -z3474;
    result.A[122] = z3475;
    result.A[123] = z3476;
    result.A[124] = -z3477;
    result.A[125] = -z3478;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = -z3498;
    result.A[134] = -z3499;
    result.A[135] = z3500;
    result.A[136] = -z3501;
    result.A[137] = -z3502;
    result.A[138] = z3503;
    result.A[139] = z3504;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z3524;
    result.A[148] = z3525;
    result.A[149] = -z3526;
    result.A[150] = z3527;
    result.A[151] = z3528;
    result.A[152] = -z3529;
    result.A[153] = -z3530;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z3550;
    result.A[162] = -z3551;
    result.A[163] = z3552;
    result.A[164] = -z3553;
    result.A[165] = -z3554;
    result.A[166] = z3555;
    result.A[167] = z3556;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z3576;
    result.A[176] = -z3577;
    result.A[177] = z3578;
    result.A[178] = -z3579;
    result.A[179] = -z3580;
    result.A[180] = z3581;
    result.A[181] = z3582;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z3601;
    result.A[190] = -z3602;
    result.A[191] = z3603;
    result.A[192] = -z3604;
    result.A[193] = -z3605;
    result.A[194] = -z3606;
    result.A[195] = z3607;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z1713;
    result.B[8] = z3608;
    result.B[9] = -z3609;
    result.B[10] = z3610;
    result.B[11] = z3611;
    result.B[12] = -z3612;
    result.B[13] = z3613;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z3608;
    result.B[22] = -z3614;
    result.B[23] = z3615;
    result.B[24] = -z3616;
    result.B[25] = -z3617;
    result.B[26] = z3618;
    result.B[27] = -z3619;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z3621;
    result.B[36] = -z3622;
    result.B[37] = -z3623;
    result.B[38] = z3624;
    result.B[39] = z3625;
    result.B[40] = -z3626;
    result.B[41] = z3627;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z3630;
    result.B[50] = z3631;
    result.B[51] = -z3632;
    result.B[52] = -z3633;
    result.B[53] = -z3634;
    result.B[54] = z3635;
    result.B[55] = -z3636;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z3640;
    result.B[64] = z3641;
    result.B[65] = -z3642;
    result.B[66] = z3643;
    result.B[67] = -z3644;
    result.B[68] = z3645;
    result.B[69] = -z3646;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z3651;
    result.B[78] = -z3652;
    result.B[79] = z3653;
    result.B[80] = -z3654;
    result.B[81] = -z3655;
    result.B[82] = -z3656;
    result.B[83] = z3657;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z3663;
    result.B[92] = z3664;
    result.B[93] = -z3665;
    result.B[94] = z3666;
    result.B[95] = z3667;
    result.B[96] = -z3668;
    result.B[97] = z3669;
    if (!(traits::regular(-z1712, z669) && traits::regular(-z1709, z651) && traits::regular(-z1703, z625)
        && traits::regular(-z1693, z592) && traits::regular(-z1678, z550) && traits::regular(-z1657,
        z509))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[0] - result.M[0]) + (result.M[1] - result.M[1]) + (result.M[2] - result.M[2])
        + (result.M[3] - result.M[3]) + (result.M[4] - result.M[4]) + (result.M[5] - result.M[5]) + (result.M[6]
        - result.M[6]) + (result.M[7] - result.M[7]) + (result.M[8] - result.M[8]) + (result.M[9] - result.M[9])
        + (result.M[10] - result.M[10]) + (result.M[11] - result.M[11]) + (result.M[12] - result.M[12]) + (result.M[13]
        - result.M[13]) + (result.M[14] - result.M[14]) + (result.M[15] - result.M[15]) + (result.M[16] - result.M[16])
        + (result.M[17] - result.M[17]) + (result.M[18] - result.M[18]) + (result.M[19] - result.M[19]) + (result.M[20]
        - result.M[20]) + (result.M[21] - result.M[21]) + (result.M[22] - result.M[22]) + (result.M[23] - result.M[23])
        + (result.M[24] - result.M[24]) + (result.M[25] - result.M[25]) + (result.M[26] - result.M[26]) + (result.M[27]
        - result.M[27]) + (result.M[28] - result.M[28]) + (result.M[29] - result.M[29]) + (result.M[30] - result.M[30])
        + (result.M[31] - result.M[31]) + (result.M[32] - result.M[32]) + (result.M[33] - result.M[33]) + (result.M[34]
        - result.M[34]) + (result.M[35] - result.M[35]) + (result.M[36] - result.M[36]) + (result.M[37] - result.M[37])
        + (result.M[38] - result.M[38]) + (result.M[39] - result.M[39]) + (result.M[40] - result.M[40]) + (result.M[41]
        - result.M[41]) + (result.M[42] - result.M[42]) + (result.M[43] - result.M[43]) + (result.M[44] - result.M[44])
        + (result.M[45] - result.M[45]) + (result.M[46] - result.M[46]) + (result.M[47] - result.M[47]) + (result.C[0]
        - result.C[0]) + (result.C[1] - result.C[1]) + (result.C[2] - result.C[2]) + (result.C[3] - result.C[3])
        + (result.C[4] - result.C[4]) + (result.C[5] - result.C[5]) + (result.C[6] - result.C[6]) + (result.C[7]
        - result.C[7]) + (result.C[8] - result.C[8]) + (result.C[9] - result.C[9]) + (result.C[10] - result.C[10])
        + (result.C[11] - result.C[11]) + (result.C[12] - result.C[12]) + (result.C[13] - result.C[13]) + (result.C[14]
        - result.C[14]) + (result.C[15] - result.C[15]) + (result.C[16] - result.C[16]) + (result.C[17] - result.C[17])
        + (result.C[18] - result.C[18]) + (result.C[19] - result.C[19]) + (result.C[20] - result.C[20]) + (result.C[21]
        - result.C[21]) + (result.C[22] - result.C[22]) + (result.C[23] - result.C[23]) + (result.C[24] - result.C[24])
        + (result.C[25] - result.C[25]) + (result.C[26] - result.C[26]) + (result.C[27] - result.C[27]) + (result.C[28]
        - result.C[28]) + (result.C[29] - result.C[29]) + (result.C[30] - result.C[30]) + (result.C[31] - result.C[31])
        + (result.C[32] - result.C[32]) + (result.C[33] - result.C[33]) + (result.C[34] - result.C[34]) + (result.C[35]
        - result.C[35]) + (result.C[36] - result.C[36]) + (result.C[37] - result.C[37]) + (result.C[38] - result.C[38])
        + (result.C[39] - result.C[39]) + (result.C[40] - result.C[40]) + (result.C[41] - result.C[41]) + (result.C[42]
        - result.C[42]) + (result.C[43] - result.C[43]) + (result.C[44] - result.C[44]) + (result.C[45] - result.C[45])
        + (result.C[46] - result.C[46]) + (result.C[47] - result.C[47]) + (result.K[7] - result.K[7]) + (result.K[8]
        - result.K[8]) + (result.K[9] - result.K[9]) + (result.K[10] - result.K[10]) + (result.K[11] - result.K[11])
        + (result.K[12] - result.K[12]) + (result.K[13] - result.K[13]) + (result.K[14] - result.K[14]) + (result.K[15]
        - result.K[15]) + (result.K[16] - result.K[16]) + (result.K[17] - result.K[17]) + (result.K[18] - result.K[18])
        + (result.K[19] - result.K[19]) + (result.K[20] - result.K[20]) + (result.K[21] - result.K[21]) + (result.K[22]
        - result.K[22]) + (result.K[23] - result.K[23]) + (result.K[24] - result.K[24]) + (result.K[25] - result.K[25])
        + (result.K[26] - result.K[26]) + (result.K[27] - result.K[27]) + (result.K[28] - result.K[28]) + (result.K[29]
        - result.K[29]) + (result.K[30] - result.K[30]) + (result.K[31] - result.K[31]) + (result.K[32] - result.K[32])
        + (result.K[33] - result.K[33]) + (result.K[34] - result.K[34]) + (result.K[35] - result.K[35]) + (result.K[36]
        - result.K[36]) + (result.K[37] - result.K[37]) + (result.K[38] - result.K[38]) + (result.K[39] - result.K[39])
        + (result.K[40] - result.K[40]) + (result.K[41] - result.K[41]) + (result.K[42] - result.K[42]) + (result.K[43]
        - result.K[43]) + (result.K[44] - result.K[44]) + (result.K[45] - result.K[45]) + (result.K[46] - result.K[46])
        + (result.K[47] - result.K[47]) + (result.K[48] - result.K[48]) + (result.F[0] - result.F[0]) + (result.F[1]
        - result.F[1]) + (result.F[2] - result.F[2]) + (result.F[3] - result.F[3]) + (result.F[4] - result.F[4])
        + (result.F[5] - result.F[5]) + (result.F[6] - result.F[6]) + (result.A[21] - result.A[21]) + (result.A[22]
        - result.A[22]) + (result.A[23] - result.A[23]) + (result.A[24] - result.A[24]) + (result.A[25] - result.A[25])
        + (result.A[26] - result.A[26]) + (result.A[27] - result.A[27]) + (result.A[35] - result.A[35]) + (result.A[36]
        - result.A[36]) + (result.A[37] - result.A[37]) + (result.A[38] - result.A[38]) + (result.A[39] - result.A[39])
        + (result.A[40] - result.A[40]) + (result.A[41] - result.A[41]) + (result.A[49] - result.A[49]) + (result.A[50]
        - result.A[50]) + (result.A[51] - result.A[51]) + (result.A[52] - result.A[52]) + (result.A[53] - result.A[53])
        + (result.A[54] - result.A[54]) + (result.A[55] - result.A[55]) + (result.A[63] - result.A[63]) + (result.A[64]
        - result.A[64]) + (result.A[65] - result.A[65]) + (result.A[66] - result.A[66]) + (result.A[67] - result.A[67])
        + (result.A[68] - result.A[68]) + (result.A[69] - result.A[69]) + (result.A[77] - result.A[77]) + (result.A[78]
        - result.A[78]) + (result.A[79] - result.A[79]) + (result.A[80] - result.A[80]) + (result.A[81] - result.A[81])
        + (result.A[82] - result.A[82]) + (result.A[83] - result.A[83]) + (result.A[91] - result.A[91]) + (result.A[92]
        - result.A[92]) + (result.A[93] - result.A[93]) + (result.A[94] - result.A[94]) + (result.A[95] - result.A[95])
        + (result.A[96] - result.A[96]) + (result.A[97] - result.A[97]) + (result.A[105] - result.A[105])
        + (result.A[106] - result.A[106]) + (result.A[107] - result.A[107]) + (result.A[108] - result.A[108])
        + (result.A[109] - result.A[109]) + (result.A[110] - result.A[110]) + (result.A[111] - result.A[111])
        + (result.A[119] - result.A[119]) + (result.A[120] - result.A[120]) + (result.A[121] - result.A[121])
        + (result.A[122] - result.A[122]) + (result.A[123] - result.A[123]) + (result.A[124] - result.A[124])
        + (result.A[125] - result.A[125]) + (result.A[133] - result.A[133]) + (result.A[134] - result.A[134])
        + (result.A[135] - result.A[135]) + (result.A[136] - result.A[136]) + (result.A[137] - result.A[137])
        + (result.A[138] - result.A[138]) + (result.A[139] - result.A[139]) + (result.A[147] - result.A[147])
        + (result.A[148] - result.A[148]) + (result.A[149] - result.A[149]) + (result.A[150] - result.A[150])
        + (result.A[151] - result.A[151]) + (result.A[152] - result.A[152]) + (result.A[153] - result.A[153])
        + (result.A[161] - result.A[161]) + (result.A[162] - result.A[162]) + (result.A[163] - result.A[163])
        + (result.A[164] - result.A[164]) + (result.A[165] - result.A[165]) + (result.A[166] - result.A[166])
        + (result.A[167] - result.A[167]) + (result.A[175] - result.A[175]) + (result.A[176] - result.A[176])
        + (result.A[177] - result.A[177]) + (result.A[178] - result.A[178]) + (result.A[179] - result.A[179])
        + (result.A[180] - result.A[180]) + (result.A[181] - result.A[181]) + (result.A[189] - result.A[189])
        + (result.A[190] - result.A[190]) + (result.A[191] - result.A[191]) + (result.A[192] - result.A[192])
        + (result.A[193] - result.A[193]) + (result.A[194] - result.A[194]) + (result.A[195] - result.A[195])
        + (result.B[7] - result.B[7]) + (result.B[8] - result.B[8]) + (result.B[9] - result.B[9]) + (result.B[10]
        - result.B[10]) + (result.B[11] - result.B[11]) + (result.B[12] - result.B[12]) + (result.B[13] - result.B[13])
        + (result.B[21] - result.B[21]) + (result.B[22] - result.B[22]) + (result.B[23] - result.B[23]) + (result.B[24]
        - result.B[24]) + (result.B[25] - result.B[25]) + (result.B[26] - result.B[26]) + (result.B[27] - result.B[27])
        + (result.B[35] - result.B[35]) + (result.B[36] - result.B[36]) + (result.B[37] - result.B[37]) + (result.B[38]
        - result.B[38]) + (result.B[39] - result.B[39]) + (result.B[40] - result.B[40]) + (result.B[41] - result.B[41])
        + (result.B[49] - result.B[49]) + (result.B[50] - result.B[50]) + (result.B[51] - result.B[51]) + (result.B[52]
        - result.B[52]) + (result.B[53] - result.B[53]) + (result.B[54] - result.B[54]) + (result.B[55] - result.B[55])
        + (result.B[63] - result.B[63]) + (result.B[64] - result.B[64]) + (result.B[65] - result.B[65]) + (result.B[66]
        - result.B[66]) + (result.B[67] - result.B[67]) + (result.B[68] - result.B[68]) + (result.B[69] - result.B[69])
        + (result.B[77] - result.B[77]) + (result.B[78] - result.B[78]) + (result.B[79] - result.B[79]) + (result.B[80]
        - result.B[80]) + (result.B[81] - result.B[81]) + (result.B[82] - result.B[82]) + (result.B[83] - result.B[83])
        + (result.B[91] - result.B[91]) + (result.B[92] - result.B[92]) + (result.B[93] - result.B[93]) + (result.B[94]
        - result.B[94]) + (result.B[95] - result.B[95]) + (result.B[96] - result.B[96]) + (result.B[97] - result.B[97]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace arm7
