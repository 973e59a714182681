// SPDX-License-Identifier: MIT
// whipple_bicycle: Whipple's bicycle: two rolling wheels, benchmark of 2007
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   forward_dynamics       1099             1488         26             2                  4       0   2623    2785
//   energy                  109              162          0             0                  6       0    283     302
//   first_integrals         110              162          0             0                  6       0    284     303
//   constraints             339              537         14             2                  4       0    900     941
//   linearisation          3149             4300        107             2                  4       0   7566    8537
//
// Not computed because this mechanism does not need it:
//   energy: of 3 results 1 vanish identically
//   constraints: of 72 results 30 vanish identically, 2 repeat another up to sign
//   linearisation: of 394 results 187 vanish identically, 24 repeat another up to sign
//
// To write this file again:
//   whipple_bicycle_scene generate --kernels forward_dynamics,energy,first_integrals,constraints,linearisation --output whipple_bicycle.hpp
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

namespace whipple_bicycle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "whipple_bicycle";
  static constexpr int coordinate_count = 9;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar yaw;  ///< coordinate [rad or 1]
    Scalar roll;  ///< coordinate [rad or 1]
    Scalar pitch;  ///< coordinate [rad or 1]
    Scalar steer;  ///< coordinate [rad or 1]
    Scalar rear;  ///< coordinate [rad or 1]
    Scalar front;  ///< coordinate [rad or 1]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z, &Coordinates::yaw,
          &Coordinates::roll, &Coordinates::pitch, &Coordinates::steer, &Coordinates::rear, &Coordinates::front};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar yaw;  ///< its rate [rad/s]
    Scalar roll;  ///< its rate [rad/s]
    Scalar pitch;  ///< its rate [rad/s]
    Scalar steer;  ///< its rate [rad/s]
    Scalar rear;  ///< its rate [rad/s]
    Scalar front;  ///< its rate [rad/s]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z, &Velocities::yaw,
          &Velocities::roll, &Velocities::pitch, &Velocities::steer, &Velocities::rear, &Velocities::front};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar yaw;  ///< its second rate [rad/s^2]
    Scalar roll;  ///< its second rate [rad/s^2]
    Scalar pitch;  ///< its second rate [rad/s^2]
    Scalar steer;  ///< its second rate [rad/s^2]
    Scalar rear;  ///< its second rate [rad/s^2]
    Scalar front;  ///< its second rate [rad/s^2]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::yaw, &Accelerations::roll, &Accelerations::pitch, &Accelerations::steer, &Accelerations::rear,
          &Accelerations::front};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar yaw;  ///< works with the rate of yaw [N m]
    Scalar roll;  ///< works with the rate of roll [N m]
    Scalar pitch;  ///< works with the rate of pitch [N m]
    Scalar steer;  ///< works with the rate of steer [N m]
    Scalar rear;  ///< works with the rate of rear [N m]
    Scalar front;  ///< works with the rate of front [N m]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::yaw, &GeneralizedForces::roll, &GeneralizedForces::pitch,
          &GeneralizedForces::steer, &GeneralizedForces::rear, &GeneralizedForces::front};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_rear_touches;  ///< of the constraint rear_touches [N]
    Scalar lambda_front_touches;  ///< of the constraint front_touches [N]
    Scalar lambda_rear_rolls_x;  ///< of the constraint rear_rolls_x [N]
    Scalar lambda_rear_rolls_y;  ///< of the constraint rear_rolls_y [N]
    Scalar lambda_front_rolls_x;  ///< of the constraint front_rolls_x [N]
    Scalar lambda_front_rolls_y;  ///< of the constraint front_rolls_y [N]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_rear_touches,
          &Multipliers::lambda_front_touches, &Multipliers::lambda_rear_rolls_x, &Multipliers::lambda_rear_rolls_y,
          &Multipliers::lambda_front_rolls_x, &Multipliers::lambda_front_rolls_y};
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n4_6 = traits::constant(4.6, 4.6f, "23/5");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n46_over_3 = traits::constant(15.333333333333334, 15.333333f, "46/3");
    const Scalar n92_over_7 = traits::constant(13.142857142857142, 13.142858f, "92/7");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.z = -n0_3;
    state.q.yaw = n0;
    state.q.roll = n0;
    state.q.pitch = n0;
    state.q.steer = n0;
    state.q.rear = n0;
    state.q.front = n0;
    state.v.x = n4_6;
    state.v.y = n0_15;
    state.v.z = n0;
    state.v.yaw = n0;
    state.v.roll = n0_5;
    state.v.pitch = n0;
    state.v.steer = n0;
    state.v.rear = -n46_over_3;
    state.v.front = -n92_over_7;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

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
    std::array<Scalar, 6> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 6> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 54> jacobian;  ///< A, stored column by column (6 x 9)
    std::array<Scalar, 6> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 81> M;  ///< mass matrix (9 x 9)
    std::array<Scalar, 81> C;  ///< damping and gyroscopic terms (9 x 9)
    std::array<Scalar, 81> K;  ///< stiffness (9 x 9)
    std::array<Scalar, 9> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 21> K_r;  ///< reduced stiffness (3 x 7)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 100> A;  ///< state matrix of x = (e, w): x' = A x + B du (10 x 10)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 7;
  static constexpr int independent_coordinates[] = {0, 1, 3, 4, 6, 7, 8};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[] = {4, 6, 7};

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar k13 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k14 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k15 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k17 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar k18 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar k19 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n78_6 = traits::constant(78.6, 78.6f, "393/5");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n79_7206 = traits::constant(79.7206, 79.7206f, "398603/5000");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z48 = s_yaw * c_roll;
    const Scalar z49 = c_yaw * c_roll;
    const Scalar z50 = s_roll * z48;
    const Scalar z51 = s_roll * z49;
    const Scalar z52 = n1 - s_roll * s_roll;
    const Scalar z53 = z50 * z50 + z51 * z51 + z52 * z52;
    const Scalar z54 = traits::sqrt(z53);
    const Scalar z55 = n0_3 / z54;
    const Scalar z56 = q_x + z50 * z55;
    const Scalar z57 = q_y - z51 * z55;
    const Scalar z58 = q_z + z52 * z55;
    const Scalar z60 = v_roll * c_roll;
    const Scalar z61 = v_yaw * c_yaw;
    const Scalar z62 = v_roll * s_roll;
    const Scalar z63 = s_yaw * z62 - c_roll * z61;
    const Scalar z64 = s_roll * z63 - z48 * z60;
    const Scalar z65 = v_yaw * s_yaw;
    const Scalar z66 = c_yaw * z62 + c_roll * z65;
    const Scalar z67 = s_roll * z66 - z49 * z60;
    const Scalar z68 = n2 * s_roll * z60;
    const Scalar z69 = n2 * (z50 * z64 + z51 * z67 + z52 * z68);
    const Scalar z70 = n0_5 * z69 / z54;
    const Scalar z72 = s_yaw * s_roll;
    const Scalar z73 = s_roll * z72 - c_roll * z48;
    const Scalar z74 = c_yaw * s_roll;
    const Scalar z75 = s_roll * z74 - c_roll * z49;
    const Scalar z76 = n2 * s_roll * c_roll;
    const Scalar z77 = n2 * (z50 * z73 + z51 * z75 + z52 * z76);
    const Scalar z78 = n0_5 * z77 / z54;
    const Scalar z79 = n0_3 * z78;
    const Scalar z80 = v_roll * z60;
    const Scalar z81 = v_yaw * z65;
    const Scalar z82 = s_yaw * z80 + c_roll * z81 + n2 * z61 * z62;
    const Scalar z83 = v_roll * z62;
    const Scalar z84 = s_roll * z82 + z48 * z83 + n2 * z60 * z63;
    const Scalar z85 = v_yaw * z61;
    const Scalar z86 = c_yaw * z80 + c_roll * z85 - n2 * z62 * z65;
    const Scalar z87 = s_roll * z86 + z49 * z83 + n2 * z60 * z66;
    const Scalar z88 = n2 * (s_roll * z83 - z60 * z60);
    const Scalar z89 = n2 * (z50 * z84 + z51 * z87 - z52 * z88 - z64 * z64 - z67 * z67 - z68 * z68);
    const Scalar z90 = n0_5 * (z69 * z70 / (z54 * z54) + z89 / z54);
    const Scalar z91 = n0_3 * z90;
    const Scalar z92 = n0_08 * z38 + n0_35 * z40;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z97 = s_pitch * z96 + c_pitch * z95;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z99 = s_roll * z98 - c_roll * z93;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z101 = s_yaw * z99 - c_yaw * z97;
    const Scalar z102 = s_yaw * z97 + c_yaw * z99;
    const Scalar z103 = q_z - z100;
    const Scalar z104 = q_y + z102;
    const Scalar z105 = q_x - z101;
    const Scalar z106 = s_pitch * z41 - c_pitch * z39;
    const Scalar z107 = s_pitch * z39 + c_pitch * z41;
    const Scalar z108 = s_roll * z107 - c_roll * c_steer;
    const Scalar z109 = s_roll * c_steer + c_roll * z107;
    const Scalar z110 = s_yaw * z108 + c_yaw * z106;
    const Scalar z111 = s_yaw * z106 - c_yaw * z108;
    const Scalar z112 = z109 * z110;
    const Scalar z113 = z109 * z111;
    const Scalar z114 = n1 - z109 * z109;
    const Scalar z115 = z112 * z112 + z113 * z113 + z114 * z114;
    const Scalar z116 = traits::sqrt(z115);
    const Scalar z117 = n0_35 / z116;
    const Scalar z118 = z105 - z112 * z117;
    const Scalar z119 = z104 - z113 * z117;
    const Scalar z120 = z103 + z114 * z117;
    const Scalar z122 = v_steer * c_steer;
    const Scalar z123 = z32 * z122;
    const Scalar z124 = z31 * z122;
    const Scalar z125 = n0_08 * z123 - n0_35 * z124;
    const Scalar z126 = v_pitch * c_pitch;
    const Scalar z127 = v_steer * s_steer;
    const Scalar z128 = -z127 * (n1 - z31 * z31);
    const Scalar z129 = z31 * z32 * z127;
    const Scalar z130 = n0_08 * z128 + n0_35 * z129;
    const Scalar z131 = v_pitch * s_pitch;
    const Scalar z132 = -z127 * (n1 - z32 * z32);
    const Scalar z133 = n0_08 * z129 + n0_35 * z132;
    const Scalar z134 = s_pitch * z130 - c_pitch * z133 - z95 * z126 - z96 * z131;
    const Scalar z135 = s_roll * z125 - c_roll * z134 + z60 * z93 - z62 * z98;
    const Scalar z136 = v_z - z135;
    const Scalar z137 = s_pitch * z123 + c_pitch * z124 + z39 * z126 - z41 * z131;
    const Scalar z138 = s_roll * z127 - c_roll * z137 - c_steer * z60 + z62 * z107;
    const Scalar z139 = s_roll * z137 + c_roll * z127 + c_steer * z62 + z60 * z107;
    const Scalar z140 = s_pitch * z124 - c_pitch * z123 + z39 * z131 + z41 * z126;
    const Scalar z141 = s_yaw * z139 + c_yaw * z140 + z61 * z108 - z65 * z106;
    const Scalar z142 = z109 * z141 - z110 * z138;
    const Scalar z143 = s_yaw * z140 - c_yaw * z139 + z61 * z106 + z65 * z108;
    const Scalar z144 = z109 * z143 - z111 * z138;
    const Scalar z145 = n2 * z109 * z138;
    const Scalar z146 = n2 * (z112 * z142 + z113 * z144 + z114 * z145);
    const Scalar z147 = n0_5 * z146 / z116;
    const Scalar z149 = s_yaw * z109;
    const Scalar z150 = z108 * z110 - z109 * z149;
    const Scalar z151 = c_yaw * z109;
    const Scalar z152 = z108 * z111 + z109 * z151;
    const Scalar z153 = n2 * z108 * z109;
    const Scalar z154 = n2 * (z112 * z150 + z113 * z152 - z114 * z153);
    const Scalar z155 = n0_5 * z154 / z116;
    const Scalar z156 = z99 - n0_35 * z155;
    const Scalar z157 = c_roll * z97;
    const Scalar z158 = c_roll * z106;
    const Scalar z159 = s_roll * z106;
    const Scalar z160 = s_yaw * z159 - c_yaw * z107;
    const Scalar z161 = z109 * z160 + z110 * z158;
    const Scalar z162 = s_yaw * z107 + c_yaw * z159;
    const Scalar z163 = z109 * z162 - z111 * z158;
    const Scalar z164 = n2 * z109 * z158;
    const Scalar z165 = n2 * (z112 * z161 - z113 * z163 - z114 * z164);
    const Scalar z166 = n0_5 * z165 / z116;
    const Scalar z167 = z157 + n0_35 * z166;
    const Scalar z168 = z32 * c_steer;
    const Scalar z169 = z31 * c_steer;
    const Scalar z170 = n0_08 * z168 - n0_35 * z169;
    const Scalar z171 = -s_steer * (n1 - z31 * z31);
    const Scalar z172 = z31 * z32 * s_steer;
    const Scalar z173 = n0_08 * z171 + n0_35 * z172;
    const Scalar z174 = -s_steer * (n1 - z32 * z32);
    const Scalar z175 = n0_08 * z172 + n0_35 * z174;
    const Scalar z176 = s_pitch * z173 - c_pitch * z175;
    const Scalar z177 = s_roll * z170 - c_roll * z176;
    const Scalar z178 = s_pitch * z168 + c_pitch * z169;
    const Scalar z179 = s_roll * s_steer - c_roll * z178;
    const Scalar z180 = s_roll * z178 + c_roll * s_steer;
    const Scalar z181 = s_pitch * z169 - c_pitch * z168;
    const Scalar z182 = s_yaw * z180 + c_yaw * z181;
    const Scalar z183 = z109 * z182 - z110 * z179;
    const Scalar z184 = s_yaw * z181 - c_yaw * z180;
    const Scalar z185 = z109 * z184 - z111 * z179;
    const Scalar z186 = n2 * z109 * z179;
    const Scalar z187 = n2 * (z112 * z183 + z113 * z185 + z114 * z186);
    const Scalar z188 = n0_5 * z187 / z116;
    const Scalar z189 = z177 - n0_35 * z188;
    const Scalar z190 = v_steer * z127;
    const Scalar z191 = z32 * z190;
    const Scalar z192 = z31 * z190;
    const Scalar z193 = n0_08 * z191 - n0_35 * z192;
    const Scalar z194 = v_steer * z122;
    const Scalar z195 = -z194 * (n1 - z31 * z31);
    const Scalar z196 = z31 * z32 * z194;
    const Scalar z197 = n0_08 * z195 + n0_35 * z196;
    const Scalar z198 = -z194 * (n1 - z32 * z32);
    const Scalar z199 = n0_08 * z196 + n0_35 * z198;
    const Scalar z200 = v_pitch * z131;
    const Scalar z201 = v_pitch * z126;
    const Scalar z202 = n2 * (z126 * z130 + z131 * z133) + s_pitch * z197 - c_pitch * z199 + z95 * z200 - z96 * z201;
    const Scalar z203 = -n2 * (z60 * z125 + z62 * z134) + s_roll * z193 + c_roll * z202 + z80 * z98 + z83 * z93;
    const Scalar z204 = -n2 * (z123 * z126 - z124 * z131) + s_pitch * z191 + c_pitch * z192 + z39 * z200 + z41 * z201;
    const Scalar z205 = -n2 * (z60 * z137 - z62 * z127) + s_roll * z204 - c_roll * z194 - c_steer * z80 + z83 * z107;
    const Scalar z206 = -n2 * (z123 * z131 + z124 * z126) + s_pitch * z192 - c_pitch * z191 - z39 * z201 + z41 * z200;
    const Scalar z207 = -n2 * (z61 * z139 - z65 * z140) + s_yaw * z205 + c_yaw * z206 + z81 * z108 + z85 * z106;
    const Scalar z208 = n2 * (z60 * z127 + z62 * z137) + s_roll * z194 + c_roll * z204 + c_steer * z83 + z80 * z107;
    const Scalar z209 = z109 * z207 + z110 * z208 + n2 * z138 * z141;
    const Scalar z210 = -n2 * (z61 * z140 + z65 * z139) + s_yaw * z206 - c_yaw * z205 + z81 * z106 - z85 * z108;
    const Scalar z211 = z109 * z210 + z111 * z208 + n2 * z138 * z143;
    const Scalar z212 = n2 * (z109 * z208 - z138 * z138);
    const Scalar z213 = n2 * (z112 * z209 + z113 * z211 - z114 * z212 - z142 * z142 - z144 * z144 - z145 * z145);
    const Scalar z214 = n0_5 * (z146 * z147 / (z116 * z116) + z213 / z116);
    const Scalar z215 = z203 - n0_35 * z214;
    const Scalar z216 = q_x - z56;
    const Scalar z217 = q_y - z57;
    const Scalar z218 = q_z - z58;
    const Scalar z219 = s_yaw * z218;
    const Scalar z220 = c_yaw * z218;
    const Scalar z222 = s_roll * z217 - z49 * z218;
    const Scalar z223 = s_roll * z216 + z48 * z218;
    const Scalar z226 = n0_3 * z70 / (z54 * z54);
    const Scalar z227 = v_y - z51 * z226 + z55 * z67;
    const Scalar z228 = v_y - z227;
    const Scalar z229 = v_z + z52 * z226 - z55 * z68;
    const Scalar z230 = v_z - z229;
    const Scalar z231 = s_yaw * z230 + z61 * z218;
    const Scalar z232 = s_roll * z228 - z49 * z230 + z60 * z217 + z66 * z218;
    const Scalar z233 = z232 * (v_pitch + v_rear) + v_yaw * z228 - v_roll * z231;
    const Scalar z235 = v_x + z50 * z226 - z55 * z64;
    const Scalar z236 = v_x - z235;
    const Scalar z237 = c_yaw * z230 - z65 * z218;
    const Scalar z238 = s_roll * z236 + z48 * z230 + z60 * z216 - z63 * z218;
    const Scalar z239 = z238 * (v_pitch + v_rear) + v_yaw * z236 - v_roll * z237;
    const Scalar z240 = q_x - z118;
    const Scalar z241 = q_y - z119;
    const Scalar z242 = q_z - z120;
    const Scalar z243 = s_yaw * z242;
    const Scalar z244 = c_yaw * z242;
    const Scalar z246 = s_roll * z241 - z49 * z242;
    const Scalar z247 = s_roll * z240 + z48 * z242;
    const Scalar z249 = s_pitch * z32 + c_pitch * z31;
    const Scalar z250 = s_pitch * z31 - c_pitch * z32;
    const Scalar z251 = s_roll * z250;
    const Scalar z252 = c_roll * z250;
    const Scalar z253 = s_yaw * z251 - c_yaw * z249;
    const Scalar z254 = s_yaw * z249 + c_yaw * z251;
    const Scalar z255 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z257 = s_roll * z256;
    const Scalar z258 = c_roll * z256;
    const Scalar z259 = s_yaw * z257 - c_yaw * z255;
    const Scalar z260 = s_yaw * z255 + c_yaw * z257;
    const Scalar z261 = q_z - z258;
    const Scalar z262 = q_y + z260;
    const Scalar z263 = q_x - z259;
    const Scalar z264 = z118 - z263;
    const Scalar z265 = z119 - z262;
    const Scalar z266 = z120 - z261;
    const Scalar z267 = z252 * z265 + z254 * z266;
    const Scalar z268 = z252 * z264 - z253 * z266;
    const Scalar z270 = z105 - z118;
    const Scalar z271 = z104 - z119;
    const Scalar z272 = z103 - z120;
    const Scalar z273 = z109 * z271 - z111 * z272;
    const Scalar z274 = z109 * z270 - z110 * z272;
    const Scalar z277 = s_pitch * z133 + c_pitch * z130 + z95 * z131 - z96 * z126;
    const Scalar z278 = s_roll * z134 + c_roll * z125 - z60 * z98 - z62 * z93;
    const Scalar z279 = s_yaw * z277 + c_yaw * z278 - z61 * z97 + z65 * z99;
    const Scalar z280 = v_y - z279;
    const Scalar z281 = n0_35 * z147 / (z116 * z116);
    const Scalar z282 = z113 * z281 - z117 * z144 + z280;
    const Scalar z283 = v_y - z282;
    const Scalar z284 = z114 * z281 - z117 * z145 - z136;
    const Scalar z285 = v_z + z284;
    const Scalar z286 = s_yaw * z285 + z61 * z242;
    const Scalar z287 = s_roll * z283 - z49 * z285 + z60 * z241 + z66 * z242;
    const Scalar z288 = z31 * z126 + z32 * z131;
    const Scalar z289 = c_roll * z288 - z62 * z250;
    const Scalar z290 = n0_3 * z126 - n1_1 * z131;
    const Scalar z291 = n1_1 * z126 + n0_3 * z131;
    const Scalar z292 = s_roll * z291 + z60 * z256;
    const Scalar z293 = s_yaw * z290 + c_yaw * z292 + z61 * z255 - z65 * z257;
    const Scalar z294 = v_y + z293;
    const Scalar z295 = z282 - z294;
    const Scalar z296 = z31 * z131 - z32 * z126;
    const Scalar z297 = s_roll * z288 + z60 * z250;
    const Scalar z298 = s_yaw * z296 - c_yaw * z297 - z61 * z249 + z65 * z251;
    const Scalar z299 = c_roll * z291 - z62 * z256;
    const Scalar z300 = v_z - z299;
    const Scalar z301 = z284 + z300;
    const Scalar z302 = z252 * z295 - z254 * z301 + z265 * z289 - z266 * z298;
    const Scalar z303 = z280 - z282;
    const Scalar z304 = z136 + z284;
    const Scalar z305 = z109 * z303 - z111 * z304 - z138 * z271 - z143 * z272;
    const Scalar z306 = v_yaw * z283 - v_roll * z286 + v_pitch * z287 + v_steer * z302 + v_front * z305;
    const Scalar z308 = s_yaw * z278 - c_yaw * z277 - z61 * z99 - z65 * z97;
    const Scalar z309 = v_x + z308;
    const Scalar z310 = z112 * z281 - z117 * z142 + z309;
    const Scalar z311 = v_x - z310;
    const Scalar z312 = c_yaw * z285 - z65 * z242;
    const Scalar z313 = s_roll * z311 + z48 * z285 + z60 * z240 - z63 * z242;
    const Scalar z314 = s_yaw * z292 - c_yaw * z290 + z61 * z257 + z65 * z255;
    const Scalar z315 = v_x - z314;
    const Scalar z316 = z310 - z315;
    const Scalar z317 = s_yaw * z297 + c_yaw * z296 + z61 * z251 + z65 * z249;
    const Scalar z318 = z252 * z316 + z253 * z301 + z264 * z289 - z266 * z317;
    const Scalar z319 = z309 - z310;
    const Scalar z320 = z109 * z319 - z110 * z304 - z138 * z270 - z141 * z272;
    const Scalar z321 = v_yaw * z311 - v_roll * z312 + v_pitch * z313 + v_steer * z318 + v_front * z320;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z324 = n9_81 * s_roll;
    const Scalar z325 = n9_81 * c_roll;
    const Scalar z326 = v_roll * z323;  // angular acceleration of frame.2, y
    const Scalar z327 = v_roll * z322;  // angular acceleration of frame.2, z
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z330 = s_pitch * z327;
    const Scalar z331 = c_pitch * z327;
    const Scalar z332 = s_pitch * z325;
    const Scalar z333 = c_pitch * z325;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z335 = v_pitch * z329 - z330;  // angular acceleration of frame, x
    const Scalar z336 = v_pitch * z328 - z331;  // angular acceleration of frame, z
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z340 = z334 * z334;
    const Scalar z341 = z329 * z329;
    const Scalar z342 = z340 + z341;
    const Scalar z343 = z328 * z329;
    const Scalar z344 = z326 + z343;
    const Scalar z345 = z328 * z334;
    const Scalar z346 = z336 + z345;
    const Scalar z347 = z329 * z334;
    const Scalar z348 = z335 + z347;
    const Scalar z349 = z326 - z343;
    const Scalar z350 = z328 * z328;
    const Scalar z351 = z340 + z350;
    const Scalar z352 = z38 * z328 + z39 * z334 + z40 * z329;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z355 = z38 * z335 - z39 * z326 - z40 * z336;
    const Scalar z356 = c_steer * z326 + z39 * z335 + z41 * z336;
    const Scalar z357 = z40 * z335 + z41 * z326 - z42 * z336;
    const Scalar z358 = z332 - n1_1 * z342 + n0_3 * z344;
    const Scalar z359 = z324 - n1_1 * z346 - n0_3 * z348;
    const Scalar z360 = z333 + n1_1 * z349 + n0_3 * z351;
    const Scalar z361 = z38 * z358 - z39 * z359 - z40 * z360;
    const Scalar z362 = c_steer * z359 + z39 * z358 + z41 * z360;
    const Scalar z363 = z40 * z358 + z41 * z359 - z42 * z360;
    const Scalar z364 = z31 * z354 - z32 * z352;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z367 = z32 * v_steer * z353 - z355;  // angular acceleration of fork, x
    const Scalar z368 = v_steer * z364 + z356;  // angular acceleration of fork, y
    const Scalar z369 = z31 * v_steer * z353 + z357;  // angular acceleration of fork, z
    const Scalar z370 = z353 * z353;
    const Scalar z371 = z366 * z366;
    const Scalar z372 = z370 + z371;
    const Scalar z373 = z365 * z366;
    const Scalar z374 = z368 + z373;
    const Scalar z375 = z353 * z365;
    const Scalar z376 = z369 - z375;
    const Scalar z377 = z353 * z366;
    const Scalar z378 = z367 - z377;
    const Scalar z379 = z368 - z373;
    const Scalar z380 = z365 * z365;
    const Scalar z381 = z370 + z380;
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z388 = z366 * z385;
    const Scalar z389 = z365 * z385;
    const Scalar z390 = n0_28 * z388;  // moment on front_wheel, x
    const Scalar z391 = n0_28 * z368;  // moment on front_wheel, y
    const Scalar z392 = n0_28 * z389;  // moment on front_wheel, z
    const Scalar z393 = z371 - z380;
    const Scalar z394 = n7 * z361 + n1_04 * z372 - n3_85 * z374;  // force on fork, x
    const Scalar z395 = n7 * z362 - n1_04 * z376 - n3_85 * z378;  // force on fork, y
    const Scalar z396 = n7 * z363 + n1_04 * z379 + n3_85 * z381;  // force on fork, z
    const Scalar z397 = n3_85 * z362 - k13 * z367 - k14 * z376 + k15 * z377 + z390;  // moment on fork, x
    // moment on fork, y
    const Scalar z398 = n3_85 * z361 - n1_04 * z363 - n2_5667 * z368 - k17 * z373 - z391 + k14 * z393;
    const Scalar z399 = n1_04 * z362 - k18 * z369 + k19 * z375 - k14 * z378 + z392;  // moment on fork, z
    const Scalar z400 = z31 * z397 - z32 * z399;
    const Scalar z401 = z38 * z394 + z39 * z395 + z40 * z396;
    const Scalar z402 = c_steer * z395 - z39 * z394 + z41 * z396;
    const Scalar z403 = z40 * z394 - z41 * z395 + z42 * z396;
    const Scalar z404 = z38 * z397 - z39 * z398 - z40 * z399;
    const Scalar z405 = c_steer * z398 + z39 * z397 + z41 * z399;
    const Scalar z406 = z40 * z397 + z41 * z398 - z42 * z399;
    const Scalar z407 = z329 * z337;
    const Scalar z408 = z328 * z337;
    const Scalar z409 = n0_12 * z407;  // moment on rear_wheel, x
    const Scalar z410 = n0_12 * z326;  // moment on rear_wheel, y
    const Scalar z411 = n0_12 * z408;  // moment on rear_wheel, z
    const Scalar z412 = z341 - z350;
    const Scalar z413 = n25_5 * z342 + n51 * z344 - z401;  // force on frame, x
    const Scalar z414 = n25_5 * z346 - n51 * z348 - z402;  // force on frame, y
    const Scalar z415 = n25_5 * z349 - n51 * z351 - z403;  // force on frame, z
    const Scalar z416 = n51 * z324 - n17_7 * z346 + n78_6 * z347 - n0_3 * z402 + z404 + z409;  // moment on frame, x
    // moment on frame, y
    const Scalar z417 = n49_25 * z326 - n51 * z332 + n25_5 * z333 + n29_35 * z343 + n0_3 * z401 - n1_1 * z403 - z405
        + z410 + n17_7 * z412;
    // moment on frame, z
    const Scalar z418 = n25_5 * z324 + n29_35 * z336 - n49_25 * z345 + n17_7 * z348 + n1_1 * z402 + z406 - z411;
    const Scalar z419 = s_pitch * z415 + c_pitch * z413;
    const Scalar z420 = s_pitch * z413 - c_pitch * z415;
    const Scalar z421 = s_pitch * z418 + c_pitch * z416;
    const Scalar z422 = s_pitch * z416 - c_pitch * z418;
    const Scalar z423 = z322 * z323;
    const Scalar z424 = z421 - n39_8603 * z423;  // moment on frame.2, x
    const Scalar z425 = n79_7206 * z327 - z422;  // moment on frame.2, z
    const Scalar z426 = s_roll * z420 - c_roll * z414;
    const Scalar z427 = s_roll * z414 + c_roll * z420;
    const Scalar z429 = s_roll * z417 - c_roll * z425;
    const Scalar z430 = s_yaw * z426 - c_yaw * z419;
    const Scalar z431 = s_yaw * z419 + c_yaw * z426;
    const Scalar z434 = n853_47 - z427;  // force on frame.z, z
    const Scalar z439 = n0_28 * z39;
    const Scalar z440 = n0_28 * c_steer;
    const Scalar z441 = n0_28 * z41;
    const Scalar z442 = s_pitch * z441 - c_pitch * z439;
    const Scalar z443 = s_pitch * z439 + c_pitch * z441;
    const Scalar z445 = s_roll * z440 + c_roll * z443;
    const Scalar z448 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k13 * z31 - k14 * z32;
    });
    const Scalar z449 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k14 * z31 - k18 * z32;
    });
    const Scalar z450 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z448 - z32 * z449;
    });
    const Scalar z451 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z452 = z39 * z451;
    const Scalar z453 = c_steer * z451;
    const Scalar z454 = z41 * z451;
    const Scalar z455 = z38 * z448 - z40 * z449;
    const Scalar z456 = z39 * z448 + z41 * z449;
    const Scalar z457 = z40 * z448 - z42 * z449;
    const Scalar z458 = n0_3 * z452 + n1_1 * z454 - z456;
    const Scalar z459 = s_pitch * z454 - c_pitch * z452;
    const Scalar z460 = s_pitch * z452 + c_pitch * z454;
    const Scalar z461 = n0_3 * z453 - z455;
    const Scalar z462 = n1_1 * z453 + z457;
    const Scalar z463 = s_pitch * z462 - c_pitch * z461;
    const Scalar z464 = s_pitch * z461 + c_pitch * z462;
    const Scalar z465 = s_roll * z460 - c_roll * z453;
    const Scalar z466 = s_roll * z453 + c_roll * z460;
    const Scalar z468 = s_roll * z458 - c_roll * z464;
    const Scalar z469 = s_yaw * z465 + c_yaw * z459;
    const Scalar z470 = s_yaw * z459 - c_yaw * z465;
    const Scalar z475 = n1_04 * z38 + n3_85 * z40;
    const Scalar z476 = n1_04 * z39 - n3_85 * z41;
    const Scalar z477 = n1_04 * z40 + n3_85 * z42;
    const Scalar z478 = k13 * z38 - k14 * z40;
    const Scalar z479 = n2_8467 * z39;
    const Scalar z480 = k14 * z38 - k18 * z40;
    const Scalar z481 = k13 * z39 + k14 * z41;
    const Scalar z482 = n2_8467 * c_steer;
    const Scalar z483 = k14 * z39 + k18 * z41;
    const Scalar z484 = k13 * z40 - k14 * z42;
    const Scalar z485 = n2_8467 * z41;
    const Scalar z486 = k14 * z40 - k18 * z42;
    const Scalar z487 = z38 * z478 + z39 * z479 - z40 * z480;
    const Scalar z490 = z38 * z481 - z39 * z482 - z40 * z483;
    const Scalar z491 = c_steer * z482 + z39 * z481 + z41 * z483;
    const Scalar z493 = z38 * z484 - z39 * z485 - z40 * z486;
    const Scalar z494 = c_steer * z485 + z39 * z484 + z41 * z486;
    const Scalar z495 = z40 * z484 + z41 * z485 - z42 * z486;
    const Scalar z496 = n0_63 - n0_6 * z477 + z487;
    const Scalar z499 = n1_1 * z476 + z490;
    const Scalar z500 = n9_1 - n2_2 * z475 - n0_6 * z477 + z491;
    const Scalar z502 = n2_31 - n0_3 * z475 - n1_1 * z477 - z493;
    const Scalar z503 = n0_3 * z476 + z494;
    const Scalar z504 = n8_47 - n2_2 * z475 + z495;
    const Scalar z505 = n7_7 - z475;
    const Scalar z506 = n2_1 - z477;
    const Scalar z507 = n25_5 + z505;
    const Scalar z508 = n51 - z506;
    const Scalar z509 = n49_25 + z500;
    const Scalar z510 = n17_7 - z502;
    const Scalar z511 = n29_35 - z504;
    const Scalar z513 = n0_12 * s_roll;
    const Scalar z516 = n0_12 + z509;
    const Scalar z517 = s_pitch * z507 + c_pitch * z508;
    const Scalar z518 = s_pitch * z508 - c_pitch * z507;
    const Scalar z519 = s_pitch * z503 + c_pitch * z499;
    const Scalar z520 = s_pitch * z499 - c_pitch * z503;
    const Scalar z521 = s_roll * z518;
    const Scalar z522 = c_roll * z518;
    const Scalar z524 = s_roll * z516 - c_roll * z520;
    const Scalar z525 = s_yaw * z521 - c_yaw * z517;
    const Scalar z526 = s_yaw * z517 + c_yaw * z521;
    const Scalar z531 = z496 + z511;
    const Scalar z532 = n2 * z510;
    const Scalar z533 = s_pitch * z531 - c_pitch * z532;
    const Scalar z534 = s_pitch * z533;
    const Scalar z535 = z511 - z534;
    const Scalar z536 = z496 - z534;
    const Scalar z537 = c_pitch * z533 + z510;
    const Scalar z538 = n39_8603 + z536;
    const Scalar z539 = n39_8603 - z516;
    const Scalar z540 = s_roll * z476 + c_roll * z517;
    const Scalar z541 = s_roll * z517 - c_roll * z476;
    const Scalar z543 = s_roll * z519 - c_roll * z537;
    const Scalar z544 = s_yaw * z540;
    const Scalar z545 = c_yaw * z540;
    const Scalar z550 = z535 - z539;
    const Scalar z551 = n2 * z520;
    const Scalar z552 = s_roll * z550 - c_roll * z551;
    const Scalar z553 = s_roll * z552;
    const Scalar z555 = z535 - z553;
    const Scalar z558 = n39_8603 - z555;
    const Scalar z559 = s_yaw * z518 - c_yaw * z541;
    const Scalar z560 = s_yaw * z541 + c_yaw * z518;
    const Scalar z580 = n25_over_7 * z445;
    const Scalar z581 = n25_over_7 * z442;
    const Scalar z582 = n25_over_7 * z440;
    const Scalar z583 = z445 * z580 - z558;
    const Scalar z584 = z445 * z581 - z543;
    const Scalar z585 = z442 * z581 - z538;
    const Scalar z586 = z445 * z582 - z524;
    const Scalar z587 = z442 * z582 - z519;
    const Scalar z588 = z440 * z582 - z516;
    const Scalar z589 = n25_over_3 * z513;
    const Scalar z590 = z513 * z589 + z583;
    const Scalar z591 = z513 + z586;
    const Scalar z592 = n0_12 + z588;
    const Scalar z593 = traits::formula(6.497839117007668, 6.497839f, [&]() -> Scalar {
      return n1 / z450;
    });
    const Scalar z594 = z469 * z593;
    const Scalar z595 = z470 * z593;
    const Scalar z596 = z466 * z593;
    const Scalar z597 = z468 * z593;
    const Scalar z598 = z463 * z593;
    const Scalar z599 = z458 * z593;
    const Scalar z600 = n94 - z469 * z594;
    const Scalar z601 = z469 * z595;
    const Scalar z602 = n94 - z470 * z595;
    const Scalar z603 = z469 * z596;
    const Scalar z604 = z470 * z596;
    const Scalar z605 = n94 - z466 * z596;
    const Scalar z606 = z469 * z597 + z559;
    const Scalar z607 = z470 * z597 - z560;
    const Scalar z608 = z466 * z597;
    const Scalar z609 = z468 * z597 + z590;
    const Scalar z610 = z469 * z598 + z544;
    const Scalar z611 = z470 * z598 - z545;
    const Scalar z612 = z466 * z598 - z541;
    const Scalar z613 = z468 * z598 - z584;
    const Scalar z614 = z463 * z598 + z585;
    const Scalar z615 = z469 * z599 + z525;
    const Scalar z616 = z470 * z599 - z526;
    const Scalar z617 = z466 * z599 + z522;
    const Scalar z618 = z468 * z599 + z591;
    const Scalar z619 = z463 * z599 - z587;
    const Scalar z620 = z458 * z599 + z592;
    const Scalar z621 = n1 / z620;
    const Scalar z622 = z615 * z621;
    const Scalar z623 = z616 * z621;
    const Scalar z624 = z617 * z621;
    const Scalar z625 = z618 * z621;
    const Scalar z626 = z619 * z621;
    const Scalar z627 = z600 + z615 * z622;
    const Scalar z628 = z601 - z615 * z623;
    const Scalar z629 = z602 + z616 * z623;
    const Scalar z630 = z603 - z615 * z624;
    const Scalar z631 = z604 - z616 * z624;
    const Scalar z632 = z605 + z617 * z624;
    const Scalar z633 = z606 - z615 * z625;
    const Scalar z634 = z607 - z616 * z625;
    const Scalar z635 = z608 - z617 * z625;
    const Scalar z636 = z609 - z618 * z625;
    const Scalar z637 = z610 - z615 * z626;
    const Scalar z638 = z611 - z616 * z626;
    const Scalar z639 = z612 - z617 * z626;
    const Scalar z640 = z613 - z618 * z626;
    const Scalar z641 = z614 - z619 * z626;
    const Scalar z642 = n1 / z641;
    const Scalar z643 = z637 * z642;
    const Scalar z644 = z638 * z642;
    const Scalar z645 = z639 * z642;
    const Scalar z646 = z640 * z642;
    const Scalar z647 = z627 + z637 * z643;
    const Scalar z648 = z628 - z637 * z644;
    const Scalar z649 = z629 + z638 * z644;
    const Scalar z650 = z630 - z637 * z645;
    const Scalar z651 = z631 - z638 * z645;
    const Scalar z652 = z632 + z639 * z645;
    const Scalar z653 = z633 - z637 * z646;
    const Scalar z654 = z634 - z638 * z646;
    const Scalar z655 = z635 - z639 * z646;
    const Scalar z656 = z636 - z640 * z646;
    const Scalar z657 = n1 / z656;
    const Scalar z658 = z653 * z657;
    const Scalar z659 = z654 * z657;
    const Scalar z660 = z655 * z657;
    const Scalar z661 = z647 + z653 * z658;
    const Scalar z662 = z648 - z653 * z659;
    const Scalar z663 = z649 + z654 * z659;
    const Scalar z664 = z650 - z653 * z660;
    const Scalar z665 = z651 - z654 * z660;
    const Scalar z666 = z652 + z655 * z660;
    const Scalar z667 = n1 / z666;
    const Scalar z668 = z664 * z667;
    const Scalar z669 = z665 * z667;
    const Scalar z670 = z661 - z664 * z668;
    const Scalar z671 = z662 + z664 * z669;
    const Scalar z672 = z663 - z665 * z669;
    const Scalar z673 = n1 / z672;
    const Scalar z674 = z671 * z673;
    const Scalar z675 = z670 - z671 * z674;
    const Scalar z676 = n1 / z675;
    const Scalar z677 = z391 * z582 + z400 * z599 + z410 - z417;
    const Scalar z678 = z391 * z581 - z400 * z598 + z424 + z626 * z677;
    const Scalar z679 = z391 * z580 + z400 * z597 + z410 * z589 - z429 - z625 * z677 + z646 * z678;
    const Scalar z680 = z400 * z596 - z434 - z624 * z677 + z645 * z678 - z660 * z679;
    const Scalar z681 = z400 * z595 - z431 - z623 * z677 + z644 * z678 - z659 * z679 + z669 * z680;
    const Scalar z682 = z400 * z594 + z430 - z622 * z677 + z643 * z678 - z658 * z679 + z668 * z680 + z674 * z681;
    const Scalar z683 = z676 * z682;
    const Scalar z684 = z673 * z681 + z674 * z683;
    const Scalar z685 = z667 * z680 + z668 * z683 + z669 * z684;
    const Scalar z686 = z657 * z679 + z658 * z683 + z659 * z684 + z660 * z685;
    const Scalar z687 = z642 * z678 - z643 * z683 - z644 * z684 - z645 * z685 + z646 * z686;
    const Scalar z688 = z621 * z677 + z622 * z683 + z623 * z684 + z624 * z685 - z625 * z686 + z626 * z687;
    const Scalar z689 = z400 * z593 + z594 * z683 + z595 * z684 + z596 * z685 - z597 * z686 + z598 * z687 - z599 * z688;
    const Scalar z690 = n25_over_3 * z410 - z589 * z686 - z688;
    const Scalar z691 = n25_over_7 * z391 - z580 * z686 - z581 * z687 - z582 * z688;
    const Scalar z692 = z79 * z646;
    const Scalar z693 = n1 + z79 * z645 - z660 * z692;
    const Scalar z694 = z79 * z644 - z659 * z692 + z669 * z693;
    const Scalar z695 = z79 * z643 - z658 * z692 + z668 * z693 + z674 * z694;
    const Scalar z696 = z676 * z695;
    const Scalar z697 = z673 * z694 + z674 * z696;
    const Scalar z698 = z667 * z693 + z668 * z696 + z669 * z697;
    const Scalar z699 = z657 * z692 + z658 * z696 + z659 * z697 + z660 * z698;
    const Scalar z700 = z79 * z642 - z643 * z696 - z644 * z697 - z645 * z698 + z646 * z699;
    const Scalar z701 = z622 * z696 + z623 * z697 + z624 * z698 - z625 * z699 + z626 * z700;
    const Scalar z702 = z594 * z696 + z595 * z697 + z596 * z698 - z597 * z699 + z598 * z700 - z599 * z701;
    const Scalar z703 = z589 * z699 + z701;
    const Scalar z704 = z580 * z699 + z581 * z700 + z582 * z701;
    const Scalar z705 = z167 + z189 * z599;
    const Scalar z706 = z156 + z189 * z598 - z626 * z705;
    const Scalar z707 = z189 * z597 - z625 * z705 - z646 * z706;
    const Scalar z708 = n1 + z189 * z596 - z624 * z705 - z645 * z706 - z660 * z707;
    const Scalar z709 = z189 * z595 - z623 * z705 - z644 * z706 - z659 * z707 + z669 * z708;
    const Scalar z710 = z189 * z594 - z622 * z705 - z643 * z706 - z658 * z707 + z668 * z708 + z674 * z709;
    const Scalar z711 = z676 * z710;
    const Scalar z712 = z673 * z709 + z674 * z711;
    const Scalar z713 = z667 * z708 + z668 * z711 + z669 * z712;
    const Scalar z714 = z657 * z707 + z658 * z711 + z659 * z712 + z660 * z713;
    const Scalar z715 = z642 * z706 + z643 * z711 + z644 * z712 + z645 * z713 - z646 * z714;
    const Scalar z716 = z621 * z705 + z622 * z711 + z623 * z712 + z624 * z713 - z625 * z714 - z626 * z715;
    const Scalar z717 = z189 * z593 + z594 * z711 + z595 * z712 + z596 * z713 - z597 * z714 - z598 * z715 - z599 * z716;
    const Scalar z718 = z589 * z714 + z716;
    const Scalar z719 = z580 * z714 - z581 * z715 + z582 * z716;
    const Scalar z720 = z217 - z219 * z646 - z222 * z589;
    const Scalar z721 = z219 * z645 + z660 * z720;
    const Scalar z722 = z219 * z644 + z659 * z720 + z669 * z721;
    const Scalar z723 = n1 + z219 * z643 + z658 * z720 + z668 * z721 + z674 * z722;
    const Scalar z724 = z676 * z723;
    const Scalar z725 = z673 * z722 + z674 * z724;
    const Scalar z726 = z667 * z721 + z668 * z724 + z669 * z725;
    const Scalar z727 = z657 * z720 - z658 * z724 - z659 * z725 - z660 * z726;
    const Scalar z728 = z219 * z642 - z643 * z724 - z644 * z725 - z645 * z726 - z646 * z727;
    const Scalar z729 = z622 * z724 + z623 * z725 + z624 * z726 + z625 * z727 + z626 * z728;
    const Scalar z730 = z594 * z724 + z595 * z725 + z596 * z726 + z597 * z727 + z598 * z728 - z599 * z729;
    const Scalar z731 = n25_over_3 * z222 + z589 * z727 - z729;
    const Scalar z732 = z580 * z727 - z581 * z728 - z582 * z729;
    const Scalar z733 = z216 - z220 * z646 - z223 * z589;
    const Scalar z734 = z220 * z645 + z660 * z733;
    const Scalar z735 = n1 - z220 * z644 - z659 * z733 - z669 * z734;
    const Scalar z736 = z220 * z643 + z658 * z733 + z668 * z734 - z674 * z735;
    const Scalar z737 = z676 * z736;
    const Scalar z738 = z673 * z735 - z674 * z737;
    const Scalar z739 = z667 * z734 + z668 * z737 - z669 * z738;
    const Scalar z740 = z657 * z733 - z658 * z737 + z659 * z738 - z660 * z739;
    const Scalar z741 = z220 * z642 - z643 * z737 + z644 * z738 - z645 * z739 - z646 * z740;
    const Scalar z742 = z622 * z737 - z623 * z738 + z624 * z739 + z625 * z740 + z626 * z741;
    const Scalar z743 = z594 * z737 - z595 * z738 + z596 * z739 + z597 * z740 + z598 * z741 - z599 * z742;
    const Scalar z744 = n25_over_3 * z223 + z589 * z740 - z742;
    const Scalar z745 = z580 * z740 - z581 * z741 - z582 * z742;
    const Scalar z746 = z246 + z267 * z599 - z273 * z582;
    const Scalar z747 = z243 + z267 * z598 + z273 * z581 - z626 * z746;
    const Scalar z748 = z241 + z267 * z597 - z273 * z580 - z625 * z746 - z646 * z747;
    const Scalar z749 = z267 * z596 - z624 * z746 - z645 * z747 - z660 * z748;
    const Scalar z750 = z267 * z595 - z623 * z746 - z644 * z747 - z659 * z748 + z669 * z749;
    const Scalar z751 = n1 - z267 * z594 + z622 * z746 + z643 * z747 + z658 * z748 - z668 * z749 - z674 * z750;
    const Scalar z752 = z676 * z751;
    const Scalar z753 = z673 * z750 - z674 * z752;
    const Scalar z754 = z667 * z749 - z668 * z752 + z669 * z753;
    const Scalar z755 = z657 * z748 - z658 * z752 + z659 * z753 + z660 * z754;
    const Scalar z756 = z642 * z747 - z643 * z752 + z644 * z753 + z645 * z754 - z646 * z755;
    const Scalar z757 = z621 * z746 - z622 * z752 + z623 * z753 + z624 * z754 - z625 * z755 - z626 * z756;
    const Scalar z758 = z267 * z593 - z594 * z752 + z595 * z753 + z596 * z754 - z597 * z755 - z598 * z756 - z599 * z757;
    const Scalar z759 = z589 * z755 + z757;
    const Scalar z760 = n25_over_7 * z273 + z580 * z755 - z581 * z756 + z582 * z757;
    const Scalar z761 = z247 + z268 * z599 - z274 * z582;
    const Scalar z762 = z244 + z268 * z598 + z274 * z581 - z626 * z761;
    const Scalar z763 = z240 + z268 * z597 - z274 * z580 - z625 * z761 - z646 * z762;
    const Scalar z764 = z268 * z596 - z624 * z761 - z645 * z762 - z660 * z763;
    const Scalar z765 = n1 + z268 * z595 - z623 * z761 - z644 * z762 - z659 * z763 + z669 * z764;
    const Scalar z766 = z268 * z594 - z622 * z761 - z643 * z762 - z658 * z763 + z668 * z764 + z674 * z765;
    const Scalar z767 = z676 * z766;
    const Scalar z768 = z673 * z765 + z674 * z767;
    const Scalar z769 = z667 * z764 + z668 * z767 + z669 * z768;
    const Scalar z770 = z657 * z763 + z658 * z767 + z659 * z768 + z660 * z769;
    const Scalar z771 = z642 * z762 + z643 * z767 + z644 * z768 + z645 * z769 - z646 * z770;
    const Scalar z772 = z621 * z761 + z622 * z767 + z623 * z768 + z624 * z769 - z625 * z770 - z626 * z771;
    const Scalar z773 = z268 * z593 + z594 * z767 + z595 * z768 + z596 * z769 - z597 * z770 - z598 * z771 - z599 * z772;
    const Scalar z774 = z589 * z770 + z772;
    const Scalar z775 = n25_over_7 * z274 + z580 * z770 - z581 * z771 + z582 * z772;
    const Scalar z776 = z79 * z700 - z698;
    const Scalar z777 = z79 * z687 - z91 - z685;
    const Scalar z778 = z156 * z700 - z167 * z701 + z189 * z702 + z698;
    const Scalar z779 = z156 * z715 + z167 * z716 - z189 * z717 - z713;
    const Scalar z780 = z156 * z687 - z167 * z688 + z189 * z689 - z215 + z685;
    const Scalar z781 = z222 * (z701 - z703) + z217 * z699 - z219 * z700 + z696;
    const Scalar z782 = z222 * (z716 - z718) + z217 * z714 + z219 * z715 + z711;
    const Scalar z783 = -z222 * (z729 + z731) + z217 * z727 + z219 * z728 - z724;
    const Scalar z784 = z222 * (z688 + z690) + z217 * z686 - z219 * z687 - z233 + z683;
    const Scalar z785 = z223 * (z701 - z703) + z216 * z699 - z220 * z700 - z697;
    const Scalar z786 = z223 * (z716 - z718) + z216 * z714 + z220 * z715 - z712;
    const Scalar z787 = -z223 * (z729 + z731) + z216 * z727 + z220 * z728 + z725;
    const Scalar z788 = -z223 * (z742 + z744) + z216 * z740 + z220 * z741 - z738;
    const Scalar z789 = z223 * (z688 + z690) + z216 * z686 - z220 * z687 - z239 - z684;
    const Scalar z790 = z241 * z699 - z243 * z700 + z246 * z701 - z267 * z702 - z273 * z704 + z696;
    const Scalar z791 = z241 * z714 + z243 * z715 + z246 * z716 - z267 * z717 - z273 * z719 + z711;
    const Scalar z792 = z241 * z727 + z243 * z728 - z246 * z729 + z267 * z730 - z273 * z732 - z724;
    const Scalar z793 = z241 * z740 + z243 * z741 - z246 * z742 + z267 * z743 - z273 * z745 - z737;
    const Scalar z794 = z241 * z755 + z243 * z756 + z246 * z757 - z267 * z758 - z273 * z760 - z752;
    const Scalar z795 = z241 * z686 - z243 * z687 + z246 * z688 - z267 * z689 + z273 * z691 - z306 + z683;
    const Scalar z796 = z240 * z699 - z244 * z700 + z247 * z701 - z268 * z702 - z274 * z704 - z697;
    const Scalar z797 = z240 * z714 + z244 * z715 + z247 * z716 - z268 * z717 - z274 * z719 - z712;
    const Scalar z798 = z240 * z727 + z244 * z728 - z247 * z729 + z268 * z730 - z274 * z732 + z725;
    const Scalar z799 = z240 * z740 + z244 * z741 - z247 * z742 + z268 * z743 - z274 * z745 - z738;
    const Scalar z800 = z240 * z755 + z244 * z756 + z247 * z757 - z268 * z758 - z274 * z760 - z753;
    const Scalar z801 = z240 * z770 + z244 * z771 + z247 * z772 - z268 * z773 - z274 * z775 - z768;
    const Scalar z802 = z240 * z686 - z244 * z687 + z247 * z688 - z268 * z689 + z274 * z691 - z321 - z684;
    const Scalar z803 = n1 / z801;
    const Scalar z804 = z796 * z803;
    const Scalar z805 = z797 * z803;
    const Scalar z806 = z798 * z803;
    const Scalar z807 = z799 * z803;
    const Scalar z808 = z800 * z803;
    const Scalar z809 = z776 - z796 * z804;
    const Scalar z810 = z778 + z796 * z805;
    const Scalar z811 = z779 - z797 * z805;
    const Scalar z812 = z781 - z796 * z806;
    const Scalar z813 = z782 - z797 * z806;
    const Scalar z814 = z783 - z798 * z806;
    const Scalar z815 = z785 - z796 * z807;
    const Scalar z816 = z786 - z797 * z807;
    const Scalar z817 = z787 - z798 * z807;
    const Scalar z818 = z788 - z799 * z807;
    const Scalar z819 = z790 - z796 * z808;
    const Scalar z820 = z791 - z797 * z808;
    const Scalar z821 = z792 - z798 * z808;
    const Scalar z822 = z793 - z799 * z808;
    const Scalar z823 = z794 - z800 * z808;
    const Scalar z824 = n1 / z823;
    const Scalar z825 = z819 * z824;
    const Scalar z826 = z820 * z824;
    const Scalar z827 = z821 * z824;
    const Scalar z828 = z822 * z824;
    const Scalar z829 = z809 - z819 * z825;
    const Scalar z830 = z810 + z819 * z826;
    const Scalar z831 = z811 - z820 * z826;
    const Scalar z832 = z812 - z819 * z827;
    const Scalar z833 = z813 - z820 * z827;
    const Scalar z834 = z814 - z821 * z827;
    const Scalar z835 = z815 - z819 * z828;
    const Scalar z836 = z816 - z820 * z828;
    const Scalar z837 = z817 - z821 * z828;
    const Scalar z838 = z818 - z822 * z828;
    const Scalar z839 = n1 / z838;
    const Scalar z840 = z835 * z839;
    const Scalar z841 = z836 * z839;
    const Scalar z842 = z837 * z839;
    const Scalar z843 = z829 - z835 * z840;
    const Scalar z844 = z830 + z835 * z841;
    const Scalar z845 = z831 - z836 * z841;
    const Scalar z846 = z832 - z835 * z842;
    const Scalar z847 = z833 - z836 * z842;
    const Scalar z848 = z834 - z837 * z842;
    const Scalar z849 = n1 / z848;
    const Scalar z850 = z846 * z849;
    const Scalar z851 = z847 * z849;
    const Scalar z852 = z843 - z846 * z850;
    const Scalar z853 = z844 + z846 * z851;
    const Scalar z854 = z845 - z847 * z851;
    const Scalar z855 = n1 / z854;
    const Scalar z856 = z853 * z855;
    const Scalar z857 = z852 - z853 * z856;
    const Scalar z858 = n1 / z857;
    const Scalar z859 = z795 - z802 * z808;
    const Scalar z860 = z789 - z802 * z807 - z828 * z859;
    const Scalar z861 = z784 - z802 * z806 - z827 * z859 - z842 * z860;
    const Scalar z862 = z780 + z802 * z805 + z826 * z859 + z841 * z860 + z851 * z861;
    const Scalar z863 = z777 - z802 * z804 - z825 * z859 - z840 * z860 - z850 * z861 - z856 * z862;
    const Scalar z864 = z858 * z863;
    const Scalar z865 = z855 * z862 - z856 * z864;
    const Scalar z866 = z849 * z861 - z850 * z864 + z851 * z865;
    const Scalar z867 = z839 * z860 - z840 * z864 + z841 * z865 - z842 * z866;
    const Scalar z868 = z824 * z859 - z825 * z864 + z826 * z865 - z827 * z866 - z828 * z867;
    const Scalar z869 = z802 * z803 - z804 * z864 + z805 * z865 - z806 * z866 - z807 * z867 - z808 * z868;
    const Scalar z870 = z683 - z696 * z864 + z711 * z865 + z724 * z866 + z737 * z867 + z752 * z868 - z767 * z869;
    const Scalar z871 = z684 - z697 * z864 + z712 * z865 + z725 * z866 - z738 * z867 - z753 * z868 - z768 * z869;
    const Scalar z872 = z685 - z698 * z864 + z713 * z865 + z726 * z866 + z739 * z867 - z754 * z868 - z769 * z869;
    const Scalar z873 = z686 - z699 * z864 + z714 * z865 - z727 * z866 - z740 * z867 - z755 * z868 - z770 * z869;
    const Scalar z874 = z687 - z700 * z864 - z715 * z865 + z728 * z866 + z741 * z867 + z756 * z868 + z771 * z869;
    const Scalar z875 = z688 - z701 * z864 + z716 * z865 + z729 * z866 + z742 * z867 - z757 * z868 - z772 * z869;
    const Scalar z876 = z689 - z702 * z864 + z717 * z865 + z730 * z866 + z743 * z867 - z758 * z868 - z773 * z869;
    const Scalar z877 = z690 + z703 * z864 - z718 * z865 + z731 * z866 + z744 * z867 + z759 * z868 + z774 * z869;
    const Scalar z878 = z691 + z704 * z864 - z719 * z865 + z732 * z866 + z745 * z867 + z760 * z868 + z775 * z869;
    accelerations.x = -z870;
    accelerations.y = -z871;
    accelerations.z = -z872;
    accelerations.yaw = -z873;
    accelerations.roll = -z874;
    accelerations.pitch = -z875;
    accelerations.steer = z876;
    accelerations.rear = -z877;
    accelerations.front = -z878;
    multipliers.lambda_rear_touches = -z864;
    multipliers.lambda_front_touches = z865;
    multipliers.lambda_rear_rolls_x = -z866;
    multipliers.lambda_rear_rolls_y = -z867;
    multipliers.lambda_front_rolls_x = -z868;
    multipliers.lambda_front_rolls_y = -z869;
    if (!(traits::regular(z675, n94) && traits::regular(z672, n94) && traits::regular(z666, n94)
        && traits::regular(-z656, z558) && traits::regular(-z641, z538) && traits::regular(-z620, z516)
        && traits::regular(z450, z450) && traits::regular(-z857, -z776) && traits::regular(-z854, -z779)
        && traits::regular(-z848, -z783) && traits::regular(-z838, -z788) && traits::regular(-z823, -z794)
        && traits::regular(-z801, -z801))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.x - accelerations.x) + (accelerations.y - accelerations.y) + (accelerations.z
        - accelerations.z) + (accelerations.yaw - accelerations.yaw) + (accelerations.roll - accelerations.roll)
        + (accelerations.pitch - accelerations.pitch) + (accelerations.steer - accelerations.steer)
        + (accelerations.rear - accelerations.rear) + (accelerations.front - accelerations.front)
        + (multipliers.lambda_rear_touches - multipliers.lambda_rear_touches) + (multipliers.lambda_front_touches
        - multipliers.lambda_front_touches) + (multipliers.lambda_rear_rolls_x - multipliers.lambda_rear_rolls_x)
        + (multipliers.lambda_rear_rolls_y - multipliers.lambda_rear_rolls_y) + (multipliers.lambda_front_rolls_x
        - multipliers.lambda_front_rolls_x) + (multipliers.lambda_front_rolls_y - multipliers.lambda_front_rolls_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n85 = traits::constant(85.0, 85.0f, "85/1");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n39_8 = traits::constant(39.8, 39.8f, "199/5");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n10_45 = traits::constant(10.45, 10.45f, "209/20");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar k16 = traits::constant(2.01892, 2.01892f, "50473/25000");
    const Scalar k17 = traits::constant(0.56756, 0.56756f, "14189/25000");
    const Scalar n2_18 = traits::constant(2.18, 2.18f, "109/50");
    const Scalar k19 = traits::constant(0.16708, 0.16708f, "4177/25000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar k22 = traits::constant(0.03015, 0.03015f, "603/20000");
    const Scalar k23 = traits::constant(0.07025, 0.07025f, "281/4000");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n39_24 = traits::constant(39.24, 39.24f, "981/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z92 = n0_08 * z38 + n0_35 * z40;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z103 = q_z - z100;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z258 = c_roll * z256;
    const Scalar z261 = q_z - z258;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z352 = z38 * z328 + z39 * z334 + z40 * z329;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z879 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z880 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z881 = v_z * s_roll - c_roll * z880;
    const Scalar z882 = v_z * c_roll + s_roll * z880;
    const Scalar z883 = s_pitch * z882 - c_pitch * z879;
    const Scalar z884 = s_pitch * z879 + c_pitch * z882;
    const Scalar z885 = s_rear * z329 - c_rear * z328;
    const Scalar z886 = s_rear * z328 + c_rear * z329;
    const Scalar z887 = s_rear * z884 + c_rear * z883;
    const Scalar z888 = s_rear * z883 - c_rear * z884;
    const Scalar z889 = n0_3 * z334 - z883;
    const Scalar z890 = n0_3 * z328 - n1_1 * z329 - z881;
    const Scalar z891 = n1_1 * z334 - z884;
    const Scalar z892 = z38 * z889 - z39 * z890 - z40 * z891;
    const Scalar z893 = c_steer * z890 + z39 * z889 + z41 * z891;
    const Scalar z894 = z40 * z889 + z41 * z890 - z42 * z891;
    const Scalar z895 = n0_35 * z353 - z892;
    const Scalar z896 = n0_35 * z365 - n0_08 * z366 - z893;
    const Scalar z897 = n0_08 * z353 + z894;
    const Scalar z898 = s_front * z366 - c_front * z365;
    const Scalar z899 = s_front * z365 + c_front * z366;
    const Scalar z900 = s_front * z897 + c_front * z895;
    const Scalar z901 = s_front * z895 - c_front * z897;
    const Scalar z902 = n51 * z334 + n85 * z883;
    const Scalar z903 = n51 * z328 + n25_5 * z329 + n85 * z881;
    const Scalar z904 = n25_5 * z334 - n85 * z884;
    const Scalar z905 = n39_8 * z328 + n17_7 * z329 + n51 * z881;
    const Scalar z906 = n49_25 * z334 + n51 * z883 - n25_5 * z884;
    const Scalar z907 = n17_7 * z328 + n10_45 * z329 + n25_5 * z881;
    const Scalar z908 = n2_8 * z353 - n4 * z892;
    const Scalar z909 = n2_8 * z365 - n0_8 * z366 - n4 * z893;
    const Scalar z910 = n0_8 * z353 + n4 * z894;
    const Scalar z911 = k16 * z365 - k17 * z366 - n2_8 * z893;
    const Scalar z912 = n2_18 * z353 - n2_8 * z892 + n0_8 * z894;
    const Scalar z913 = k17 * z365 - k19 * z366 - n0_8 * z893;
    const Scalar z915 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z917 = c_roll * z915;
    const Scalar z923 = n0_8 * z38 + n2_8 * z40;
    const Scalar z924 = n0_8 * z39 - n2_8 * z41;
    const Scalar z925 = n0_8 * z40 + n2_8 * z42;
    const Scalar z927 = s_pitch * z923 - c_pitch * z925;
    const Scalar z929 = s_roll * z924 - c_roll * z927;
    result.kinetic = n0_5 * (z328 * z905 + z329 * z907 + z334 * z906 + z353 * z912 + z365 * z911 - z366 * z913 + z881
        * z903 + z883 * z902 - z884 * z904 - z892 * z908 - z893 * z909 + z894 * z910) + n1_5 * (z896 * z896 + z900
        * z900 + z901 * z901) + k22 * (z885 * z885 + z886 * z886) + k23 * (z898 * z898 + z899 * z899) + n0_06 * z337
        * z337 + n0_14 * z385 * z385 + z881 * z881 + z887 * z887 + z888 * z888;
    result.force_function = -n9_81 * (z917 + z929) + n853_47 * q_z + n29_43 * z103 + n39_24 * z261;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n85 = traits::constant(85.0, 85.0f, "85/1");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n39_8 = traits::constant(39.8, 39.8f, "199/5");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n10_45 = traits::constant(10.45, 10.45f, "209/20");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar k16 = traits::constant(2.01892, 2.01892f, "50473/25000");
    const Scalar k17 = traits::constant(0.56756, 0.56756f, "14189/25000");
    const Scalar n2_18 = traits::constant(2.18, 2.18f, "109/50");
    const Scalar k19 = traits::constant(0.16708, 0.16708f, "4177/25000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar k22 = traits::constant(0.03015, 0.03015f, "603/20000");
    const Scalar k23 = traits::constant(0.07025, 0.07025f, "281/4000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n39_24 = traits::constant(39.24, 39.24f, "981/25");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z92 = n0_08 * z38 + n0_35 * z40;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z103 = q_z - z100;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z258 = c_roll * z256;
    const Scalar z261 = q_z - z258;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z352 = z38 * z328 + z39 * z334 + z40 * z329;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z879 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z880 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z881 = v_z * s_roll - c_roll * z880;
    const Scalar z882 = v_z * c_roll + s_roll * z880;
    const Scalar z883 = s_pitch * z882 - c_pitch * z879;
    const Scalar z884 = s_pitch * z879 + c_pitch * z882;
    const Scalar z885 = s_rear * z329 - c_rear * z328;
    const Scalar z886 = s_rear * z328 + c_rear * z329;
    const Scalar z887 = s_rear * z884 + c_rear * z883;
    const Scalar z888 = s_rear * z883 - c_rear * z884;
    const Scalar z889 = n0_3 * z334 - z883;
    const Scalar z890 = n0_3 * z328 - n1_1 * z329 - z881;
    const Scalar z891 = n1_1 * z334 - z884;
    const Scalar z892 = z38 * z889 - z39 * z890 - z40 * z891;
    const Scalar z893 = c_steer * z890 + z39 * z889 + z41 * z891;
    const Scalar z894 = z40 * z889 + z41 * z890 - z42 * z891;
    const Scalar z895 = n0_35 * z353 - z892;
    const Scalar z896 = n0_35 * z365 - n0_08 * z366 - z893;
    const Scalar z897 = n0_08 * z353 + z894;
    const Scalar z898 = s_front * z366 - c_front * z365;
    const Scalar z899 = s_front * z365 + c_front * z366;
    const Scalar z900 = s_front * z897 + c_front * z895;
    const Scalar z901 = s_front * z895 - c_front * z897;
    const Scalar z902 = n51 * z334 + n85 * z883;
    const Scalar z903 = n51 * z328 + n25_5 * z329 + n85 * z881;
    const Scalar z904 = n25_5 * z334 - n85 * z884;
    const Scalar z905 = n39_8 * z328 + n17_7 * z329 + n51 * z881;
    const Scalar z906 = n49_25 * z334 + n51 * z883 - n25_5 * z884;
    const Scalar z907 = n17_7 * z328 + n10_45 * z329 + n25_5 * z881;
    const Scalar z908 = n2_8 * z353 - n4 * z892;
    const Scalar z909 = n2_8 * z365 - n0_8 * z366 - n4 * z893;
    const Scalar z910 = n0_8 * z353 + n4 * z894;
    const Scalar z911 = k16 * z365 - k17 * z366 - n2_8 * z893;
    const Scalar z912 = n2_18 * z353 - n2_8 * z892 + n0_8 * z894;
    const Scalar z913 = k17 * z365 - k19 * z366 - n0_8 * z893;
    const Scalar z915 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z917 = c_roll * z915;
    const Scalar z923 = n0_8 * z38 + n2_8 * z40;
    const Scalar z924 = n0_8 * z39 - n2_8 * z41;
    const Scalar z925 = n0_8 * z40 + n2_8 * z42;
    const Scalar z927 = s_pitch * z923 - c_pitch * z925;
    const Scalar z929 = s_roll * z924 - c_roll * z927;
    result.energy = n0_5 * (z328 * z905 + z329 * z907 + z334 * z906 + z353 * z912 + z365 * z911 - z366 * z913 + z881
        * z903 + z883 * z902 - z884 * z904 - z892 * z908 - z893 * z909 + z894 * z910) + n1_5 * (z896 * z896 + z900
        * z900 + z901 * z901) + k22 * (z885 * z885 + z886 * z886) + k23 * (z898 * z898 + z899 * z899) + n9_81 * (z917
        + z929) - n853_47 * q_z - n29_43 * z103 - n39_24 * z261 + n0_06 * z337 * z337 + n0_14 * z385 * z385 + z881
        * z881 + z887 * z887 + z888 * z888;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z48 = s_yaw * c_roll;
    const Scalar z49 = c_yaw * c_roll;
    const Scalar z50 = s_roll * z48;
    const Scalar z51 = s_roll * z49;
    const Scalar z52 = n1 - s_roll * s_roll;
    const Scalar z53 = z50 * z50 + z51 * z51 + z52 * z52;
    const Scalar z54 = traits::sqrt(z53);
    const Scalar z55 = n0_3 / z54;
    const Scalar z56 = q_x + z50 * z55;
    const Scalar z57 = q_y - z51 * z55;
    const Scalar z58 = q_z + z52 * z55;
    const Scalar z59 = q_z + n0_3 * z54;
    const Scalar z60 = v_roll * c_roll;
    const Scalar z61 = v_yaw * c_yaw;
    const Scalar z62 = v_roll * s_roll;
    const Scalar z63 = s_yaw * z62 - c_roll * z61;
    const Scalar z64 = s_roll * z63 - z48 * z60;
    const Scalar z65 = v_yaw * s_yaw;
    const Scalar z66 = c_yaw * z62 + c_roll * z65;
    const Scalar z67 = s_roll * z66 - z49 * z60;
    const Scalar z68 = n2 * s_roll * z60;
    const Scalar z69 = n2 * (z50 * z64 + z51 * z67 + z52 * z68);
    const Scalar z70 = n0_5 * z69 / z54;
    const Scalar z71 = v_z - n0_3 * z70;
    const Scalar z72 = s_yaw * s_roll;
    const Scalar z73 = s_roll * z72 - c_roll * z48;
    const Scalar z74 = c_yaw * s_roll;
    const Scalar z75 = s_roll * z74 - c_roll * z49;
    const Scalar z76 = n2 * s_roll * c_roll;
    const Scalar z77 = n2 * (z50 * z73 + z51 * z75 + z52 * z76);
    const Scalar z78 = n0_5 * z77 / z54;
    const Scalar z79 = n0_3 * z78;
    const Scalar z80 = v_roll * z60;
    const Scalar z81 = v_yaw * z65;
    const Scalar z82 = s_yaw * z80 + c_roll * z81 + n2 * z61 * z62;
    const Scalar z83 = v_roll * z62;
    const Scalar z84 = s_roll * z82 + z48 * z83 + n2 * z60 * z63;
    const Scalar z85 = v_yaw * z61;
    const Scalar z86 = c_yaw * z80 + c_roll * z85 - n2 * z62 * z65;
    const Scalar z87 = s_roll * z86 + z49 * z83 + n2 * z60 * z66;
    const Scalar z88 = n2 * (s_roll * z83 - z60 * z60);
    const Scalar z89 = n2 * (z50 * z84 + z51 * z87 - z52 * z88 - z64 * z64 - z67 * z67 - z68 * z68);
    const Scalar z90 = n0_5 * (z69 * z70 / (z54 * z54) + z89 / z54);
    const Scalar z91 = n0_3 * z90;
    const Scalar z92 = n0_08 * z38 + n0_35 * z40;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z97 = s_pitch * z96 + c_pitch * z95;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z99 = s_roll * z98 - c_roll * z93;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z101 = s_yaw * z99 - c_yaw * z97;
    const Scalar z102 = s_yaw * z97 + c_yaw * z99;
    const Scalar z103 = q_z - z100;
    const Scalar z104 = q_y + z102;
    const Scalar z105 = q_x - z101;
    const Scalar z106 = s_pitch * z41 - c_pitch * z39;
    const Scalar z107 = s_pitch * z39 + c_pitch * z41;
    const Scalar z108 = s_roll * z107 - c_roll * c_steer;
    const Scalar z109 = s_roll * c_steer + c_roll * z107;
    const Scalar z110 = s_yaw * z108 + c_yaw * z106;
    const Scalar z111 = s_yaw * z106 - c_yaw * z108;
    const Scalar z112 = z109 * z110;
    const Scalar z113 = z109 * z111;
    const Scalar z114 = n1 - z109 * z109;
    const Scalar z115 = z112 * z112 + z113 * z113 + z114 * z114;
    const Scalar z116 = traits::sqrt(z115);
    const Scalar z117 = n0_35 / z116;
    const Scalar z118 = z105 - z112 * z117;
    const Scalar z119 = z104 - z113 * z117;
    const Scalar z120 = z103 + z114 * z117;
    const Scalar z121 = z103 + n0_35 * z116;
    const Scalar z122 = v_steer * c_steer;
    const Scalar z123 = z32 * z122;
    const Scalar z124 = z31 * z122;
    const Scalar z125 = n0_08 * z123 - n0_35 * z124;
    const Scalar z126 = v_pitch * c_pitch;
    const Scalar z127 = v_steer * s_steer;
    const Scalar z128 = -z127 * (n1 - z31 * z31);
    const Scalar z129 = z31 * z32 * z127;
    const Scalar z130 = n0_08 * z128 + n0_35 * z129;
    const Scalar z131 = v_pitch * s_pitch;
    const Scalar z132 = -z127 * (n1 - z32 * z32);
    const Scalar z133 = n0_08 * z129 + n0_35 * z132;
    const Scalar z134 = s_pitch * z130 - c_pitch * z133 - z95 * z126 - z96 * z131;
    const Scalar z135 = s_roll * z125 - c_roll * z134 + z60 * z93 - z62 * z98;
    const Scalar z136 = v_z - z135;
    const Scalar z137 = s_pitch * z123 + c_pitch * z124 + z39 * z126 - z41 * z131;
    const Scalar z138 = s_roll * z127 - c_roll * z137 - c_steer * z60 + z62 * z107;
    const Scalar z139 = s_roll * z137 + c_roll * z127 + c_steer * z62 + z60 * z107;
    const Scalar z140 = s_pitch * z124 - c_pitch * z123 + z39 * z131 + z41 * z126;
    const Scalar z141 = s_yaw * z139 + c_yaw * z140 + z61 * z108 - z65 * z106;
    const Scalar z142 = z109 * z141 - z110 * z138;
    const Scalar z143 = s_yaw * z140 - c_yaw * z139 + z61 * z106 + z65 * z108;
    const Scalar z144 = z109 * z143 - z111 * z138;
    const Scalar z145 = n2 * z109 * z138;
    const Scalar z146 = n2 * (z112 * z142 + z113 * z144 + z114 * z145);
    const Scalar z147 = n0_5 * z146 / z116;
    const Scalar z148 = z136 + n0_35 * z147;
    const Scalar z149 = s_yaw * z109;
    const Scalar z150 = z108 * z110 - z109 * z149;
    const Scalar z151 = c_yaw * z109;
    const Scalar z152 = z108 * z111 + z109 * z151;
    const Scalar z153 = n2 * z108 * z109;
    const Scalar z154 = n2 * (z112 * z150 + z113 * z152 - z114 * z153);
    const Scalar z155 = n0_5 * z154 / z116;
    const Scalar z156 = z99 - n0_35 * z155;
    const Scalar z157 = c_roll * z97;
    const Scalar z158 = c_roll * z106;
    const Scalar z159 = s_roll * z106;
    const Scalar z160 = s_yaw * z159 - c_yaw * z107;
    const Scalar z161 = z109 * z160 + z110 * z158;
    const Scalar z162 = s_yaw * z107 + c_yaw * z159;
    const Scalar z163 = z109 * z162 - z111 * z158;
    const Scalar z164 = n2 * z109 * z158;
    const Scalar z165 = n2 * (z112 * z161 - z113 * z163 - z114 * z164);
    const Scalar z166 = n0_5 * z165 / z116;
    const Scalar z167 = z157 + n0_35 * z166;
    const Scalar z168 = z32 * c_steer;
    const Scalar z169 = z31 * c_steer;
    const Scalar z170 = n0_08 * z168 - n0_35 * z169;
    const Scalar z171 = -s_steer * (n1 - z31 * z31);
    const Scalar z172 = z31 * z32 * s_steer;
    const Scalar z173 = n0_08 * z171 + n0_35 * z172;
    const Scalar z174 = -s_steer * (n1 - z32 * z32);
    const Scalar z175 = n0_08 * z172 + n0_35 * z174;
    const Scalar z176 = s_pitch * z173 - c_pitch * z175;
    const Scalar z177 = s_roll * z170 - c_roll * z176;
    const Scalar z178 = s_pitch * z168 + c_pitch * z169;
    const Scalar z179 = s_roll * s_steer - c_roll * z178;
    const Scalar z180 = s_roll * z178 + c_roll * s_steer;
    const Scalar z181 = s_pitch * z169 - c_pitch * z168;
    const Scalar z182 = s_yaw * z180 + c_yaw * z181;
    const Scalar z183 = z109 * z182 - z110 * z179;
    const Scalar z184 = s_yaw * z181 - c_yaw * z180;
    const Scalar z185 = z109 * z184 - z111 * z179;
    const Scalar z186 = n2 * z109 * z179;
    const Scalar z187 = n2 * (z112 * z183 + z113 * z185 + z114 * z186);
    const Scalar z188 = n0_5 * z187 / z116;
    const Scalar z189 = z177 - n0_35 * z188;
    const Scalar z190 = v_steer * z127;
    const Scalar z191 = z32 * z190;
    const Scalar z192 = z31 * z190;
    const Scalar z193 = n0_08 * z191 - n0_35 * z192;
    const Scalar z194 = v_steer * z122;
    const Scalar z195 = -z194 * (n1 - z31 * z31);
    const Scalar z196 = z31 * z32 * z194;
    const Scalar z197 = n0_08 * z195 + n0_35 * z196;
    const Scalar z198 = -z194 * (n1 - z32 * z32);
    const Scalar z199 = n0_08 * z196 + n0_35 * z198;
    const Scalar z200 = v_pitch * z131;
    const Scalar z201 = v_pitch * z126;
    const Scalar z202 = n2 * (z126 * z130 + z131 * z133) + s_pitch * z197 - c_pitch * z199 + z95 * z200 - z96 * z201;
    const Scalar z203 = -n2 * (z60 * z125 + z62 * z134) + s_roll * z193 + c_roll * z202 + z80 * z98 + z83 * z93;
    const Scalar z204 = -n2 * (z123 * z126 - z124 * z131) + s_pitch * z191 + c_pitch * z192 + z39 * z200 + z41 * z201;
    const Scalar z205 = -n2 * (z60 * z137 - z62 * z127) + s_roll * z204 - c_roll * z194 - c_steer * z80 + z83 * z107;
    const Scalar z206 = -n2 * (z123 * z131 + z124 * z126) + s_pitch * z192 - c_pitch * z191 - z39 * z201 + z41 * z200;
    const Scalar z207 = -n2 * (z61 * z139 - z65 * z140) + s_yaw * z205 + c_yaw * z206 + z81 * z108 + z85 * z106;
    const Scalar z208 = n2 * (z60 * z127 + z62 * z137) + s_roll * z194 + c_roll * z204 + c_steer * z83 + z80 * z107;
    const Scalar z209 = z109 * z207 + z110 * z208 + n2 * z138 * z141;
    const Scalar z210 = -n2 * (z61 * z140 + z65 * z139) + s_yaw * z206 - c_yaw * z205 + z81 * z106 - z85 * z108;
    const Scalar z211 = z109 * z210 + z111 * z208 + n2 * z138 * z143;
    const Scalar z212 = n2 * (z109 * z208 - z138 * z138);
    const Scalar z213 = n2 * (z112 * z209 + z113 * z211 - z114 * z212 - z142 * z142 - z144 * z144 - z145 * z145);
    const Scalar z214 = n0_5 * (z146 * z147 / (z116 * z116) + z213 / z116);
    const Scalar z215 = z203 - n0_35 * z214;
    const Scalar z216 = q_x - z56;
    const Scalar z217 = q_y - z57;
    const Scalar z218 = q_z - z58;
    const Scalar z219 = s_yaw * z218;
    const Scalar z220 = c_yaw * z218;
    const Scalar z222 = s_roll * z217 - z49 * z218;
    const Scalar z223 = s_roll * z216 + z48 * z218;
    const Scalar z225 = z222 * (v_pitch + v_rear) + v_x + v_yaw * z217 - v_roll * z219;
    const Scalar z226 = n0_3 * z70 / (z54 * z54);
    const Scalar z227 = v_y - z51 * z226 + z55 * z67;
    const Scalar z228 = v_y - z227;
    const Scalar z229 = v_z + z52 * z226 - z55 * z68;
    const Scalar z230 = v_z - z229;
    const Scalar z231 = s_yaw * z230 + z61 * z218;
    const Scalar z232 = s_roll * z228 - z49 * z230 + z60 * z217 + z66 * z218;
    const Scalar z233 = z232 * (v_pitch + v_rear) + v_yaw * z228 - v_roll * z231;
    const Scalar z234 = -z223 * (v_pitch + v_rear) + v_y - v_yaw * z216 + v_roll * z220;
    const Scalar z235 = v_x + z50 * z226 - z55 * z64;
    const Scalar z236 = v_x - z235;
    const Scalar z237 = c_yaw * z230 - z65 * z218;
    const Scalar z238 = s_roll * z236 + z48 * z230 + z60 * z216 - z63 * z218;
    const Scalar z239 = z238 * (v_pitch + v_rear) + v_yaw * z236 - v_roll * z237;
    const Scalar z240 = q_x - z118;
    const Scalar z241 = q_y - z119;
    const Scalar z242 = q_z - z120;
    const Scalar z243 = s_yaw * z242;
    const Scalar z244 = c_yaw * z242;
    const Scalar z246 = s_roll * z241 - z49 * z242;
    const Scalar z247 = s_roll * z240 + z48 * z242;
    const Scalar z249 = s_pitch * z32 + c_pitch * z31;
    const Scalar z250 = s_pitch * z31 - c_pitch * z32;
    const Scalar z251 = s_roll * z250;
    const Scalar z252 = c_roll * z250;
    const Scalar z253 = s_yaw * z251 - c_yaw * z249;
    const Scalar z254 = s_yaw * z249 + c_yaw * z251;
    const Scalar z255 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z257 = s_roll * z256;
    const Scalar z258 = c_roll * z256;
    const Scalar z259 = s_yaw * z257 - c_yaw * z255;
    const Scalar z260 = s_yaw * z255 + c_yaw * z257;
    const Scalar z261 = q_z - z258;
    const Scalar z262 = q_y + z260;
    const Scalar z263 = q_x - z259;
    const Scalar z264 = z118 - z263;
    const Scalar z265 = z119 - z262;
    const Scalar z266 = z120 - z261;
    const Scalar z267 = z252 * z265 + z254 * z266;
    const Scalar z268 = z252 * z264 - z253 * z266;
    const Scalar z270 = z105 - z118;
    const Scalar z271 = z104 - z119;
    const Scalar z272 = z103 - z120;
    const Scalar z273 = z109 * z271 - z111 * z272;
    const Scalar z274 = z109 * z270 - z110 * z272;
    const Scalar z276 = v_x + v_yaw * z241 - v_roll * z243 + v_pitch * z246 + v_steer * z267 + v_front * z273;
    const Scalar z277 = s_pitch * z133 + c_pitch * z130 + z95 * z131 - z96 * z126;
    const Scalar z278 = s_roll * z134 + c_roll * z125 - z60 * z98 - z62 * z93;
    const Scalar z279 = s_yaw * z277 + c_yaw * z278 - z61 * z97 + z65 * z99;
    const Scalar z280 = v_y - z279;
    const Scalar z281 = n0_35 * z147 / (z116 * z116);
    const Scalar z282 = z113 * z281 - z117 * z144 + z280;
    const Scalar z283 = v_y - z282;
    const Scalar z284 = z114 * z281 - z117 * z145 - z136;
    const Scalar z285 = v_z + z284;
    const Scalar z286 = s_yaw * z285 + z61 * z242;
    const Scalar z287 = s_roll * z283 - z49 * z285 + z60 * z241 + z66 * z242;
    const Scalar z288 = z31 * z126 + z32 * z131;
    const Scalar z289 = c_roll * z288 - z62 * z250;
    const Scalar z290 = n0_3 * z126 - n1_1 * z131;
    const Scalar z291 = n1_1 * z126 + n0_3 * z131;
    const Scalar z292 = s_roll * z291 + z60 * z256;
    const Scalar z293 = s_yaw * z290 + c_yaw * z292 + z61 * z255 - z65 * z257;
    const Scalar z294 = v_y + z293;
    const Scalar z295 = z282 - z294;
    const Scalar z296 = z31 * z131 - z32 * z126;
    const Scalar z297 = s_roll * z288 + z60 * z250;
    const Scalar z298 = s_yaw * z296 - c_yaw * z297 - z61 * z249 + z65 * z251;
    const Scalar z299 = c_roll * z291 - z62 * z256;
    const Scalar z300 = v_z - z299;
    const Scalar z301 = z284 + z300;
    const Scalar z302 = z252 * z295 - z254 * z301 + z265 * z289 - z266 * z298;
    const Scalar z303 = z280 - z282;
    const Scalar z304 = z136 + z284;
    const Scalar z305 = z109 * z303 - z111 * z304 - z138 * z271 - z143 * z272;
    const Scalar z306 = v_yaw * z283 - v_roll * z286 + v_pitch * z287 + v_steer * z302 + v_front * z305;
    const Scalar z307 = v_y - v_yaw * z240 + v_roll * z244 - v_pitch * z247 - v_steer * z268 - v_front * z274;
    const Scalar z308 = s_yaw * z278 - c_yaw * z277 - z61 * z99 - z65 * z97;
    const Scalar z309 = v_x + z308;
    const Scalar z310 = z112 * z281 - z117 * z142 + z309;
    const Scalar z311 = v_x - z310;
    const Scalar z312 = c_yaw * z285 - z65 * z242;
    const Scalar z313 = s_roll * z311 + z48 * z285 + z60 * z240 - z63 * z242;
    const Scalar z314 = s_yaw * z292 - c_yaw * z290 + z61 * z257 + z65 * z255;
    const Scalar z315 = v_x - z314;
    const Scalar z316 = z310 - z315;
    const Scalar z317 = s_yaw * z297 + c_yaw * z296 + z61 * z251 + z65 * z249;
    const Scalar z318 = z252 * z316 + z253 * z301 + z264 * z289 - z266 * z317;
    const Scalar z319 = z309 - z310;
    const Scalar z320 = z109 * z319 - z110 * z304 - z138 * z270 - z141 * z272;
    const Scalar z321 = v_yaw * z311 - v_roll * z312 + v_pitch * z313 + v_steer * z318 + v_front * z320;
    result.value[0] = -z59;
    result.rate[0] = -z71;
    result.gamma[0] = z91;
    result.value[1] = -z121;
    result.rate[1] = -z148;
    result.gamma[1] = -z215;
    result.value[2] = n0;
    result.rate[2] = z225;
    result.gamma[2] = z233;
    result.value[3] = n0;
    result.rate[3] = -z234;
    result.gamma[3] = z239;
    result.value[4] = n0;
    result.rate[4] = z276;
    result.gamma[4] = z306;
    result.value[5] = n0;
    result.rate[5] = -z307;
    result.gamma[5] = z321;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n1;
    result.jacobian[3] = n0;
    result.jacobian[4] = n1;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = -n1;
    result.jacobian[10] = n0;
    result.jacobian[11] = -n1;
    result.jacobian[12] = -n1;
    result.jacobian[13] = -n1;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z217;
    result.jacobian[21] = z216;
    result.jacobian[22] = z241;
    result.jacobian[23] = z240;
    result.jacobian[24] = z79;
    result.jacobian[25] = -z156;
    result.jacobian[26] = -z219;
    result.jacobian[27] = -z220;
    result.jacobian[28] = -z243;
    result.jacobian[29] = -z244;
    result.jacobian[30] = n0;
    result.jacobian[31] = z167;
    result.jacobian[32] = z222;
    result.jacobian[33] = z223;
    result.jacobian[34] = z246;
    result.jacobian[35] = z247;
    result.jacobian[36] = n0;
    result.jacobian[37] = z189;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z267;
    result.jacobian[41] = z268;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z222;
    result.jacobian[45] = z223;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z273;
    result.jacobian[53] = z274;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, yaw, roll, steer, rear, front,
  /// w those of the rates of roll, steer, rear;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar k10 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k11 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k12 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar k32 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k33 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k35 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n78_6 = traits::constant(78.6, 78.6f, "393/5");
    const Scalar n79_7206 = traits::constant(79.7206, 79.7206f, "398603/5000");
    const Scalar n87 = traits::constant(87.0, 87.0f, "87/1");
    const Scalar n19_9 = traits::constant(19.9, 19.9f, "199/10");
    const Scalar n0_287 = traits::constant(0.287, 0.287f, "287/1000");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n1_over_94 = traits::constant(0.010638297872340425, 0.010638298f, "1/94");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar a_z = accelerations.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar a_yaw = accelerations.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar a_roll = accelerations.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar a_pitch = accelerations.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar a_rear = accelerations.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar a_steer = accelerations.steer;
    const Scalar v_front = state.v.front;
    const Scalar a_front = accelerations.front;
    const Scalar l_lambda_rear_touches = multipliers.lambda_rear_touches;
    const Scalar l_lambda_front_touches = multipliers.lambda_front_touches;
    const Scalar l_lambda_rear_rolls_x = multipliers.lambda_rear_rolls_x;
    const Scalar l_lambda_rear_rolls_y = multipliers.lambda_rear_rolls_y;
    const Scalar l_lambda_front_rolls_x = multipliers.lambda_front_rolls_x;
    const Scalar l_lambda_front_rolls_y = multipliers.lambda_front_rolls_y;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z30 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z31 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return sine;
    });
    const Scalar z32 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z30, sine, cosine);
      return cosine;
    });
    const Scalar z38 = z31 * z31 * (n1 - c_steer) + c_steer;
    const Scalar z39 = z32 * s_steer;
    const Scalar z40 = z31 * z32 * (n1 - c_steer);
    const Scalar z41 = z31 * s_steer;
    const Scalar z42 = z32 * z32 * (n1 - c_steer) + c_steer;
    const Scalar z48 = s_yaw * c_roll;
    const Scalar z49 = c_yaw * c_roll;
    const Scalar z50 = s_roll * z48;
    const Scalar z51 = s_roll * z49;
    const Scalar z52 = n1 - s_roll * s_roll;
    const Scalar z53 = z50 * z50 + z51 * z51 + z52 * z52;
    const Scalar z54 = traits::sqrt(z53);
    const Scalar z55 = n0_3 / z54;
    const Scalar z56 = q_x + z50 * z55;
    const Scalar z57 = q_y - z51 * z55;
    const Scalar z58 = q_z + z52 * z55;
    const Scalar z60 = v_roll * c_roll;
    const Scalar z61 = v_yaw * c_yaw;
    const Scalar z62 = v_roll * s_roll;
    const Scalar z63 = s_yaw * z62 - c_roll * z61;
    const Scalar z64 = s_roll * z63 - z48 * z60;
    const Scalar z65 = v_yaw * s_yaw;
    const Scalar z66 = c_yaw * z62 + c_roll * z65;
    const Scalar z67 = s_roll * z66 - z49 * z60;
    const Scalar z68 = n2 * s_roll * z60;
    const Scalar z69 = n2 * (z50 * z64 + z51 * z67 + z52 * z68);
    const Scalar z70 = n0_5 * z69 / z54;
    const Scalar z72 = s_yaw * s_roll;
    const Scalar z73 = s_roll * z72 - c_roll * z48;
    const Scalar z74 = c_yaw * s_roll;
    const Scalar z75 = s_roll * z74 - c_roll * z49;
    const Scalar z76 = n2 * s_roll * c_roll;
    const Scalar z77 = n2 * (z50 * z73 + z51 * z75 + z52 * z76);
    const Scalar z78 = n0_5 * z77 / z54;
    const Scalar z79 = n0_3 * z78;
    const Scalar z80 = v_roll * z60;
    const Scalar z81 = v_yaw * z65;
    const Scalar z82 = s_yaw * z80 + c_roll * z81 + n2 * z61 * z62;
    const Scalar z83 = v_roll * z62;
    const Scalar z84 = s_roll * z82 + z48 * z83 + n2 * z60 * z63;
    const Scalar z85 = v_yaw * z61;
    const Scalar z86 = c_yaw * z80 + c_roll * z85 - n2 * z62 * z65;
    const Scalar z87 = s_roll * z86 + z49 * z83 + n2 * z60 * z66;
    const Scalar z88 = n2 * (s_roll * z83 - z60 * z60);
    const Scalar z89 = n2 * (z50 * z84 + z51 * z87 - z52 * z88 - z64 * z64 - z67 * z67 - z68 * z68);
    const Scalar z90 = n0_5 * (z69 * z70 / (z54 * z54) + z89 / z54);
    const Scalar z91 = n0_3 * z90;
    const Scalar z92 = n0_08 * z38 + n0_35 * z40;
    const Scalar z93 = n0_08 * z39 - n0_35 * z41;
    const Scalar z94 = n0_08 * z40 + n0_35 * z42;
    const Scalar z95 = n1_1 - z92;
    const Scalar z96 = n0_3 - z94;
    const Scalar z97 = s_pitch * z96 + c_pitch * z95;
    const Scalar z98 = s_pitch * z95 - c_pitch * z96;
    const Scalar z99 = s_roll * z98 - c_roll * z93;
    const Scalar z100 = s_roll * z93 + c_roll * z98;
    const Scalar z101 = s_yaw * z99 - c_yaw * z97;
    const Scalar z102 = s_yaw * z97 + c_yaw * z99;
    const Scalar z103 = q_z - z100;
    const Scalar z104 = q_y + z102;
    const Scalar z105 = q_x - z101;
    const Scalar z106 = s_pitch * z41 - c_pitch * z39;
    const Scalar z107 = s_pitch * z39 + c_pitch * z41;
    const Scalar z108 = s_roll * z107 - c_roll * c_steer;
    const Scalar z109 = s_roll * c_steer + c_roll * z107;
    const Scalar z110 = s_yaw * z108 + c_yaw * z106;
    const Scalar z111 = s_yaw * z106 - c_yaw * z108;
    const Scalar z112 = z109 * z110;
    const Scalar z113 = z109 * z111;
    const Scalar z114 = n1 - z109 * z109;
    const Scalar z115 = z112 * z112 + z113 * z113 + z114 * z114;
    const Scalar z116 = traits::sqrt(z115);
    const Scalar z117 = n0_35 / z116;
    const Scalar z118 = z105 - z112 * z117;
    const Scalar z119 = z104 - z113 * z117;
    const Scalar z120 = z103 + z114 * z117;
    const Scalar z122 = v_steer * c_steer;
    const Scalar z123 = z32 * z122;
    const Scalar z124 = z31 * z122;
    const Scalar z125 = n0_08 * z123 - n0_35 * z124;
    const Scalar z126 = v_pitch * c_pitch;
    const Scalar z127 = v_steer * s_steer;
    const Scalar z128 = -z127 * (n1 - z31 * z31);
    const Scalar z129 = z31 * z32 * z127;
    const Scalar z130 = n0_08 * z128 + n0_35 * z129;
    const Scalar z131 = v_pitch * s_pitch;
    const Scalar z132 = -z127 * (n1 - z32 * z32);
    const Scalar z133 = n0_08 * z129 + n0_35 * z132;
    const Scalar z134 = s_pitch * z130 - c_pitch * z133 - z95 * z126 - z96 * z131;
    const Scalar z135 = s_roll * z125 - c_roll * z134 + z60 * z93 - z62 * z98;
    const Scalar z136 = v_z - z135;
    const Scalar z137 = s_pitch * z123 + c_pitch * z124 + z39 * z126 - z41 * z131;
    const Scalar z138 = s_roll * z127 - c_roll * z137 - c_steer * z60 + z62 * z107;
    const Scalar z139 = s_roll * z137 + c_roll * z127 + c_steer * z62 + z60 * z107;
    const Scalar z140 = s_pitch * z124 - c_pitch * z123 + z39 * z131 + z41 * z126;
    const Scalar z141 = s_yaw * z139 + c_yaw * z140 + z61 * z108 - z65 * z106;
    const Scalar z142 = z109 * z141 - z110 * z138;
    const Scalar z143 = s_yaw * z140 - c_yaw * z139 + z61 * z106 + z65 * z108;
    const Scalar z144 = z109 * z143 - z111 * z138;
    const Scalar z145 = n2 * z109 * z138;
    const Scalar z146 = n2 * (z112 * z142 + z113 * z144 + z114 * z145);
    const Scalar z147 = n0_5 * z146 / z116;
    const Scalar z149 = s_yaw * z109;
    const Scalar z150 = z108 * z110 - z109 * z149;
    const Scalar z151 = c_yaw * z109;
    const Scalar z152 = z108 * z111 + z109 * z151;
    const Scalar z153 = n2 * z108 * z109;
    const Scalar z154 = n2 * (z112 * z150 + z113 * z152 - z114 * z153);
    const Scalar z155 = n0_5 * z154 / z116;
    const Scalar z156 = z99 - n0_35 * z155;
    const Scalar z157 = c_roll * z97;
    const Scalar z158 = c_roll * z106;
    const Scalar z159 = s_roll * z106;
    const Scalar z160 = s_yaw * z159 - c_yaw * z107;
    const Scalar z161 = z109 * z160 + z110 * z158;
    const Scalar z162 = s_yaw * z107 + c_yaw * z159;
    const Scalar z163 = z109 * z162 - z111 * z158;
    const Scalar z164 = n2 * z109 * z158;
    const Scalar z165 = n2 * (z112 * z161 - z113 * z163 - z114 * z164);
    const Scalar z166 = n0_5 * z165 / z116;
    const Scalar z167 = z157 + n0_35 * z166;
    const Scalar z168 = z32 * c_steer;
    const Scalar z169 = z31 * c_steer;
    const Scalar z170 = n0_08 * z168 - n0_35 * z169;
    const Scalar z171 = -s_steer * (n1 - z31 * z31);
    const Scalar z172 = z31 * z32 * s_steer;
    const Scalar z173 = n0_08 * z171 + n0_35 * z172;
    const Scalar z174 = -s_steer * (n1 - z32 * z32);
    const Scalar z175 = n0_08 * z172 + n0_35 * z174;
    const Scalar z176 = s_pitch * z173 - c_pitch * z175;
    const Scalar z177 = s_roll * z170 - c_roll * z176;
    const Scalar z178 = s_pitch * z168 + c_pitch * z169;
    const Scalar z179 = s_roll * s_steer - c_roll * z178;
    const Scalar z180 = s_roll * z178 + c_roll * s_steer;
    const Scalar z181 = s_pitch * z169 - c_pitch * z168;
    const Scalar z182 = s_yaw * z180 + c_yaw * z181;
    const Scalar z183 = z109 * z182 - z110 * z179;
    const Scalar z184 = s_yaw * z181 - c_yaw * z180;
    const Scalar z185 = z109 * z184 - z111 * z179;
    const Scalar z186 = n2 * z109 * z179;
    const Scalar z187 = n2 * (z112 * z183 + z113 * z185 + z114 * z186);
    const Scalar z188 = n0_5 * z187 / z116;
    const Scalar z189 = z177 - n0_35 * z188;
    const Scalar z190 = v_steer * z127;
    const Scalar z191 = z32 * z190;
    const Scalar z192 = z31 * z190;
    const Scalar z193 = n0_08 * z191 - n0_35 * z192;
    const Scalar z194 = v_steer * z122;
    const Scalar z195 = -z194 * (n1 - z31 * z31);
    const Scalar z196 = z31 * z32 * z194;
    const Scalar z197 = n0_08 * z195 + n0_35 * z196;
    const Scalar z198 = -z194 * (n1 - z32 * z32);
    const Scalar z199 = n0_08 * z196 + n0_35 * z198;
    const Scalar z200 = v_pitch * z131;
    const Scalar z201 = v_pitch * z126;
    const Scalar z202 = n2 * (z126 * z130 + z131 * z133) + s_pitch * z197 - c_pitch * z199 + z95 * z200 - z96 * z201;
    const Scalar z203 = -n2 * (z60 * z125 + z62 * z134) + s_roll * z193 + c_roll * z202 + z80 * z98 + z83 * z93;
    const Scalar z204 = -n2 * (z123 * z126 - z124 * z131) + s_pitch * z191 + c_pitch * z192 + z39 * z200 + z41 * z201;
    const Scalar z205 = -n2 * (z60 * z137 - z62 * z127) + s_roll * z204 - c_roll * z194 - c_steer * z80 + z83 * z107;
    const Scalar z206 = -n2 * (z123 * z131 + z124 * z126) + s_pitch * z192 - c_pitch * z191 - z39 * z201 + z41 * z200;
    const Scalar z207 = -n2 * (z61 * z139 - z65 * z140) + s_yaw * z205 + c_yaw * z206 + z81 * z108 + z85 * z106;
    const Scalar z208 = n2 * (z60 * z127 + z62 * z137) + s_roll * z194 + c_roll * z204 + c_steer * z83 + z80 * z107;
    const Scalar z209 = z109 * z207 + z110 * z208 + n2 * z138 * z141;
    const Scalar z210 = -n2 * (z61 * z140 + z65 * z139) + s_yaw * z206 - c_yaw * z205 + z81 * z106 - z85 * z108;
    const Scalar z211 = z109 * z210 + z111 * z208 + n2 * z138 * z143;
    const Scalar z212 = n2 * (z109 * z208 - z138 * z138);
    const Scalar z213 = n2 * (z112 * z209 + z113 * z211 - z114 * z212 - z142 * z142 - z144 * z144 - z145 * z145);
    const Scalar z214 = n0_5 * (z146 * z147 / (z116 * z116) + z213 / z116);
    const Scalar z215 = z203 - n0_35 * z214;
    const Scalar z216 = q_x - z56;
    const Scalar z217 = q_y - z57;
    const Scalar z218 = q_z - z58;
    const Scalar z219 = s_yaw * z218;
    const Scalar z220 = c_yaw * z218;
    const Scalar z222 = s_roll * z217 - z49 * z218;
    const Scalar z223 = s_roll * z216 + z48 * z218;
    const Scalar z226 = n0_3 * z70 / (z54 * z54);
    const Scalar z227 = v_y - z51 * z226 + z55 * z67;
    const Scalar z228 = v_y - z227;
    const Scalar z229 = v_z + z52 * z226 - z55 * z68;
    const Scalar z230 = v_z - z229;
    const Scalar z231 = s_yaw * z230 + z61 * z218;
    const Scalar z232 = s_roll * z228 - z49 * z230 + z60 * z217 + z66 * z218;
    const Scalar z233 = z232 * (v_pitch + v_rear) + v_yaw * z228 - v_roll * z231;
    const Scalar z235 = v_x + z50 * z226 - z55 * z64;
    const Scalar z236 = v_x - z235;
    const Scalar z237 = c_yaw * z230 - z65 * z218;
    const Scalar z238 = s_roll * z236 + z48 * z230 + z60 * z216 - z63 * z218;
    const Scalar z239 = z238 * (v_pitch + v_rear) + v_yaw * z236 - v_roll * z237;
    const Scalar z240 = q_x - z118;
    const Scalar z241 = q_y - z119;
    const Scalar z242 = q_z - z120;
    const Scalar z243 = s_yaw * z242;
    const Scalar z244 = c_yaw * z242;
    const Scalar z246 = s_roll * z241 - z49 * z242;
    const Scalar z247 = s_roll * z240 + z48 * z242;
    const Scalar z249 = s_pitch * z32 + c_pitch * z31;
    const Scalar z250 = s_pitch * z31 - c_pitch * z32;
    const Scalar z251 = s_roll * z250;
    const Scalar z252 = c_roll * z250;
    const Scalar z253 = s_yaw * z251 - c_yaw * z249;
    const Scalar z254 = s_yaw * z249 + c_yaw * z251;
    const Scalar z255 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z256 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z257 = s_roll * z256;
    const Scalar z258 = c_roll * z256;
    const Scalar z259 = s_yaw * z257 - c_yaw * z255;
    const Scalar z260 = s_yaw * z255 + c_yaw * z257;
    const Scalar z261 = q_z - z258;
    const Scalar z262 = q_y + z260;
    const Scalar z263 = q_x - z259;
    const Scalar z264 = z118 - z263;
    const Scalar z265 = z119 - z262;
    const Scalar z266 = z120 - z261;
    const Scalar z267 = z252 * z265 + z254 * z266;
    const Scalar z268 = z252 * z264 - z253 * z266;
    const Scalar z270 = z105 - z118;
    const Scalar z271 = z104 - z119;
    const Scalar z272 = z103 - z120;
    const Scalar z273 = z109 * z271 - z111 * z272;
    const Scalar z274 = z109 * z270 - z110 * z272;
    const Scalar z277 = s_pitch * z133 + c_pitch * z130 + z95 * z131 - z96 * z126;
    const Scalar z278 = s_roll * z134 + c_roll * z125 - z60 * z98 - z62 * z93;
    const Scalar z279 = s_yaw * z277 + c_yaw * z278 - z61 * z97 + z65 * z99;
    const Scalar z280 = v_y - z279;
    const Scalar z281 = n0_35 * z147 / (z116 * z116);
    const Scalar z282 = z113 * z281 - z117 * z144 + z280;
    const Scalar z283 = v_y - z282;
    const Scalar z284 = z114 * z281 - z117 * z145 - z136;
    const Scalar z285 = v_z + z284;
    const Scalar z286 = s_yaw * z285 + z61 * z242;
    const Scalar z287 = s_roll * z283 - z49 * z285 + z60 * z241 + z66 * z242;
    const Scalar z288 = z31 * z126 + z32 * z131;
    const Scalar z289 = c_roll * z288 - z62 * z250;
    const Scalar z290 = n0_3 * z126 - n1_1 * z131;
    const Scalar z291 = n1_1 * z126 + n0_3 * z131;
    const Scalar z292 = s_roll * z291 + z60 * z256;
    const Scalar z293 = s_yaw * z290 + c_yaw * z292 + z61 * z255 - z65 * z257;
    const Scalar z294 = v_y + z293;
    const Scalar z295 = z282 - z294;
    const Scalar z296 = z31 * z131 - z32 * z126;
    const Scalar z297 = s_roll * z288 + z60 * z250;
    const Scalar z298 = s_yaw * z296 - c_yaw * z297 - z61 * z249 + z65 * z251;
    const Scalar z299 = c_roll * z291 - z62 * z256;
    const Scalar z300 = v_z - z299;
    const Scalar z301 = z284 + z300;
    const Scalar z302 = z252 * z295 - z254 * z301 + z265 * z289 - z266 * z298;
    const Scalar z303 = z280 - z282;
    const Scalar z304 = z136 + z284;
    const Scalar z305 = z109 * z303 - z111 * z304 - z138 * z271 - z143 * z272;
    const Scalar z306 = v_yaw * z283 - v_roll * z286 + v_pitch * z287 + v_steer * z302 + v_front * z305;
    const Scalar z308 = s_yaw * z278 - c_yaw * z277 - z61 * z99 - z65 * z97;
    const Scalar z309 = v_x + z308;
    const Scalar z310 = z112 * z281 - z117 * z142 + z309;
    const Scalar z311 = v_x - z310;
    const Scalar z312 = c_yaw * z285 - z65 * z242;
    const Scalar z313 = s_roll * z311 + z48 * z285 + z60 * z240 - z63 * z242;
    const Scalar z314 = s_yaw * z292 - c_yaw * z290 + z61 * z257 + z65 * z255;
    const Scalar z315 = v_x - z314;
    const Scalar z316 = z310 - z315;
    const Scalar z317 = s_yaw * z297 + c_yaw * z296 + z61 * z251 + z65 * z249;
    const Scalar z318 = z252 * z316 + z253 * z301 + z264 * z289 - z266 * z317;
    const Scalar z319 = z309 - z310;
    const Scalar z320 = z109 * z319 - z110 * z304 - z138 * z270 - z141 * z272;
    const Scalar z321 = v_yaw * z311 - v_roll * z312 + v_pitch * z313 + v_steer * z318 + v_front * z320;
    const Scalar z322 = v_yaw * s_roll;
    const Scalar z323 = v_yaw * c_roll;
    const Scalar z326 = v_roll * z323;  // angular acceleration of frame.2, y
    const Scalar z327 = v_roll * z322;  // angular acceleration of frame.2, z
    const Scalar z328 = v_roll * c_pitch - s_pitch * z323;
    const Scalar z329 = v_roll * s_pitch + c_pitch * z323;
    const Scalar z334 = v_pitch + z322;  // angular velocity of frame, y
    const Scalar z337 = v_rear + z334;  // angular velocity of rear_wheel, y
    const Scalar z340 = z334 * z334;
    const Scalar z341 = z329 * z329;
    const Scalar z342 = z340 + z341;
    const Scalar z343 = z328 * z329;
    const Scalar z345 = z328 * z334;
    const Scalar z347 = z329 * z334;
    const Scalar z350 = z328 * z328;
    const Scalar z351 = z340 + z350;
    const Scalar z352 = z38 * z328 + z39 * z334 + z40 * z329;
    const Scalar z353 = c_steer * z334 - z39 * z328 + z41 * z329;
    const Scalar z354 = z40 * z328 - z41 * z334 + z42 * z329;
    const Scalar z364 = z31 * z354 - z32 * z352;
    const Scalar z365 = z31 * v_steer + z352;  // angular velocity of fork, x
    const Scalar z366 = z32 * v_steer + z354;  // angular velocity of fork, z
    const Scalar z370 = z353 * z353;
    const Scalar z371 = z366 * z366;
    const Scalar z372 = z370 + z371;
    const Scalar z373 = z365 * z366;
    const Scalar z375 = z353 * z365;
    const Scalar z377 = z353 * z366;
    const Scalar z380 = z365 * z365;
    const Scalar z381 = z370 + z380;
    const Scalar z385 = v_front + z353;  // angular velocity of front_wheel, y
    const Scalar z388 = z366 * z385;
    const Scalar z389 = z365 * z385;
    const Scalar z390 = n0_28 * z388;  // moment on front_wheel, x
    const Scalar z392 = n0_28 * z389;  // moment on front_wheel, z
    const Scalar z393 = z371 - z380;
    const Scalar z407 = z329 * z337;
    const Scalar z408 = z328 * z337;
    const Scalar z409 = n0_12 * z407;  // moment on rear_wheel, x
    const Scalar z411 = n0_12 * z408;  // moment on rear_wheel, z
    const Scalar z412 = z341 - z350;
    const Scalar z423 = z322 * z323;
    const Scalar z439 = n0_28 * z39;
    const Scalar z440 = n0_28 * c_steer;
    const Scalar z441 = n0_28 * z41;
    const Scalar z442 = s_pitch * z441 - c_pitch * z439;
    const Scalar z443 = s_pitch * z439 + c_pitch * z441;
    const Scalar z445 = s_roll * z440 + c_roll * z443;
    const Scalar z448 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k10 * z31 - k11 * z32;
    });
    const Scalar z449 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k11 * z31 - k12 * z32;
    });
    const Scalar z450 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z31 * z448 - z32 * z449;
    });
    const Scalar z451 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z31 - n1_04 * z32;
    });
    const Scalar z452 = z39 * z451;
    const Scalar z453 = c_steer * z451;
    const Scalar z454 = z41 * z451;
    const Scalar z455 = z38 * z448 - z40 * z449;
    const Scalar z456 = z39 * z448 + z41 * z449;
    const Scalar z457 = z40 * z448 - z42 * z449;
    const Scalar z458 = n0_3 * z452 + n1_1 * z454 - z456;
    const Scalar z459 = s_pitch * z454 - c_pitch * z452;
    const Scalar z460 = s_pitch * z452 + c_pitch * z454;
    const Scalar z461 = n0_3 * z453 - z455;
    const Scalar z462 = n1_1 * z453 + z457;
    const Scalar z463 = s_pitch * z462 - c_pitch * z461;
    const Scalar z464 = s_pitch * z461 + c_pitch * z462;
    const Scalar z465 = s_roll * z460 - c_roll * z453;
    const Scalar z466 = s_roll * z453 + c_roll * z460;
    const Scalar z468 = s_roll * z458 - c_roll * z464;
    const Scalar z469 = s_yaw * z465 + c_yaw * z459;
    const Scalar z470 = s_yaw * z459 - c_yaw * z465;
    const Scalar z475 = n1_04 * z38 + n3_85 * z40;
    const Scalar z476 = n1_04 * z39 - n3_85 * z41;
    const Scalar z477 = n1_04 * z40 + n3_85 * z42;
    const Scalar z478 = k10 * z38 - k11 * z40;
    const Scalar z479 = n2_8467 * z39;
    const Scalar z480 = k11 * z38 - k12 * z40;
    const Scalar z481 = k10 * z39 + k11 * z41;
    const Scalar z482 = n2_8467 * c_steer;
    const Scalar z483 = k11 * z39 + k12 * z41;
    const Scalar z484 = k10 * z40 - k11 * z42;
    const Scalar z485 = n2_8467 * z41;
    const Scalar z486 = k11 * z40 - k12 * z42;
    const Scalar z487 = z38 * z478 + z39 * z479 - z40 * z480;
    const Scalar z490 = z38 * z481 - z39 * z482 - z40 * z483;
    const Scalar z491 = c_steer * z482 + z39 * z481 + z41 * z483;
    const Scalar z493 = z38 * z484 - z39 * z485 - z40 * z486;
    const Scalar z494 = c_steer * z485 + z39 * z484 + z41 * z486;
    const Scalar z495 = z40 * z484 + z41 * z485 - z42 * z486;
    const Scalar z496 = n0_63 - n0_6 * z477 + z487;
    const Scalar z499 = n1_1 * z476 + z490;
    const Scalar z500 = n9_1 - n2_2 * z475 - n0_6 * z477 + z491;
    const Scalar z502 = n2_31 - n0_3 * z475 - n1_1 * z477 - z493;
    const Scalar z503 = n0_3 * z476 + z494;
    const Scalar z504 = n8_47 - n2_2 * z475 + z495;
    const Scalar z505 = n7_7 - z475;
    const Scalar z506 = n2_1 - z477;
    const Scalar z507 = n25_5 + z505;
    const Scalar z508 = n51 - z506;
    const Scalar z509 = n49_25 + z500;
    const Scalar z510 = n17_7 - z502;
    const Scalar z511 = n29_35 - z504;
    const Scalar z513 = n0_12 * s_roll;
    const Scalar z516 = n0_12 + z509;
    const Scalar z517 = s_pitch * z507 + c_pitch * z508;
    const Scalar z518 = s_pitch * z508 - c_pitch * z507;
    const Scalar z519 = s_pitch * z503 + c_pitch * z499;
    const Scalar z520 = s_pitch * z499 - c_pitch * z503;
    const Scalar z521 = s_roll * z518;
    const Scalar z522 = c_roll * z518;
    const Scalar z524 = s_roll * z516 - c_roll * z520;
    const Scalar z525 = s_yaw * z521 - c_yaw * z517;
    const Scalar z526 = s_yaw * z517 + c_yaw * z521;
    const Scalar z531 = z496 + z511;
    const Scalar z532 = n2 * z510;
    const Scalar z533 = s_pitch * z531 - c_pitch * z532;
    const Scalar z534 = s_pitch * z533;
    const Scalar z535 = z511 - z534;
    const Scalar z536 = z496 - z534;
    const Scalar z537 = c_pitch * z533 + z510;
    const Scalar z538 = n39_8603 + z536;
    const Scalar z539 = n39_8603 - z516;
    const Scalar z540 = s_roll * z476 + c_roll * z517;
    const Scalar z541 = s_roll * z517 - c_roll * z476;
    const Scalar z543 = s_roll * z519 - c_roll * z537;
    const Scalar z544 = s_yaw * z540;
    const Scalar z545 = c_yaw * z540;
    const Scalar z550 = z535 - z539;
    const Scalar z551 = n2 * z520;
    const Scalar z552 = s_roll * z550 - c_roll * z551;
    const Scalar z553 = s_roll * z552;
    const Scalar z555 = z535 - z553;
    const Scalar z558 = n39_8603 - z555;
    const Scalar z559 = s_yaw * z518 - c_yaw * z541;
    const Scalar z560 = s_yaw * z541 + c_yaw * z518;
    const Scalar z1007 = n9_81 - a_z;
    const Scalar z1008 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z1009 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z1010 = a_yaw * s_roll;
    const Scalar z1011 = a_yaw * c_roll;
    const Scalar z1012 = s_roll * z1007 + c_roll * z1009;
    const Scalar z1013 = s_roll * z1009 - c_roll * z1007;
    const Scalar z1014 = v_roll * z323 + z1010;  // angular acceleration of frame.2, y
    const Scalar z1015 = v_roll * z322 - z1011;  // angular acceleration of frame.2, z
    const Scalar z1016 = a_roll * c_pitch + s_pitch * z1015;
    const Scalar z1017 = a_roll * s_pitch - c_pitch * z1015;
    const Scalar z1018 = s_pitch * z1013 - c_pitch * z1008;
    const Scalar z1019 = s_pitch * z1008 + c_pitch * z1013;
    const Scalar z1020 = v_pitch * z329 - z1016;  // angular acceleration of frame, x
    const Scalar z1021 = a_pitch + z1014;  // angular acceleration of frame, y
    const Scalar z1022 = v_pitch * z328 + z1017;  // angular acceleration of frame, z
    const Scalar z1024 = a_rear + z1021;  // angular acceleration of rear_wheel, y
    const Scalar z1026 = z343 + z1021;
    const Scalar z1027 = z345 + z1022;
    const Scalar z1028 = z347 + z1020;
    const Scalar z1029 = z343 - z1021;
    const Scalar z1030 = z38 * z1020 - z39 * z1021 - z40 * z1022;
    const Scalar z1031 = c_steer * z1021 + z39 * z1020 + z41 * z1022;
    const Scalar z1032 = z40 * z1020 + z41 * z1021 - z42 * z1022;
    const Scalar z1033 = n1_1 * z342 + z1018 - n0_3 * z1026;
    const Scalar z1034 = z1012 - n1_1 * z1027 - n0_3 * z1028;
    const Scalar z1035 = n0_3 * z351 - z1019 - n1_1 * z1029;
    const Scalar z1036 = z38 * z1033 + z39 * z1034 + z40 * z1035;
    const Scalar z1037 = c_steer * z1034 - z39 * z1033 + z41 * z1035;
    const Scalar z1038 = z40 * z1033 - z41 * z1034 + z42 * z1035;
    const Scalar z1039 = z31 * a_steer + z32 * v_steer * z353 - z1030;  // angular acceleration of fork, x
    const Scalar z1040 = v_steer * z364 + z1031;  // angular acceleration of fork, y
    const Scalar z1041 = z31 * v_steer * z353 - z32 * a_steer + z1032;  // angular acceleration of fork, z
    const Scalar z1042 = z373 + z1040;
    const Scalar z1043 = z375 - z1041;
    const Scalar z1044 = z377 - z1039;
    const Scalar z1045 = z373 - z1040;
    const Scalar z1050 = a_front + z1040;  // angular acceleration of front_wheel, y
    const Scalar z1052 = n0_28 * z1050;  // moment on front_wheel, y
    const Scalar z1053 = n1_04 * z372 - n7 * z1036 - n3_85 * z1042;  // force on fork, x
    const Scalar z1054 = n7 * z1037 + n1_04 * z1043 + n3_85 * z1044;  // force on fork, y
    const Scalar z1055 = n3_85 * z381 - n7 * z1038 - n1_04 * z1045;  // force on fork, z
    const Scalar z1056 = k32 * z377 + z390 + n3_85 * z1037 - k10 * z1039 + k11 * z1043;  // moment on fork, x
    // moment on fork, y
    const Scalar z1057 = k33 * z373 - k11 * z393 + n3_85 * z1036 - n1_04 * z1038 + n2_5667 * z1040 + z1052;
    const Scalar z1058 = k35 * z375 + z392 + n1_04 * z1037 - k12 * z1041 + k11 * z1044;  // moment on fork, z
    const Scalar z1059 = z31 * z1056 - z32 * z1058;
    const Scalar z1060 = z38 * z1053 + z39 * z1054 + z40 * z1055;
    const Scalar z1061 = c_steer * z1054 - z39 * z1053 + z41 * z1055;
    const Scalar z1062 = z40 * z1053 - z41 * z1054 + z42 * z1055;
    const Scalar z1063 = z38 * z1056 + z39 * z1057 - z40 * z1058;
    const Scalar z1064 = c_steer * z1057 - z39 * z1056 - z41 * z1058;
    const Scalar z1065 = z40 * z1056 - z41 * z1057 - z42 * z1058;
    const Scalar z1066 = n0_12 * z1024;  // moment on rear_wheel, y
    const Scalar z1067 = n25_5 * z342 + n51 * z1026 - z1060;  // force on frame, x
    const Scalar z1068 = n25_5 * z1027 - n51 * z1028 - z1061;  // force on frame, y
    const Scalar z1069 = n51 * z351 + n25_5 * z1029 + z1062;  // force on frame, z
    // moment on frame, x
    const Scalar z1070 = n78_6 * z347 + z409 + n51 * z1012 - n17_7 * z1027 - n0_3 * z1061 + z1063;
    // moment on frame, y
    const Scalar z1071 = n29_35 * z343 + n17_7 * z412 + n51 * z1018 - n25_5 * z1019 + n49_25 * z1021 + n0_3 * z1060
        - n1_1 * z1062 + z1064 + z1066;
    // moment on frame, z
    const Scalar z1072 = n49_25 * z345 + z411 - n25_5 * z1012 - n29_35 * z1022 - n17_7 * z1028 - n1_1 * z1061 - z1065;
    const Scalar z1073 = s_pitch * z1069 - c_pitch * z1067;
    const Scalar z1074 = s_pitch * z1067 + c_pitch * z1069;
    const Scalar z1075 = s_pitch * z1072 - c_pitch * z1070;
    const Scalar z1076 = s_pitch * z1070 + c_pitch * z1072;
    const Scalar z1077 = n39_8603 * (a_roll + z423) + z1075;  // moment on frame.2, x
    const Scalar z1078 = n39_8603 * (z326 - z1014) + z1071;  // moment on frame.2, y
    const Scalar z1079 = n79_7206 * z327 - z1076;  // moment on frame.2, z
    const Scalar z1080 = s_roll * z1074 - c_roll * z1068;
    const Scalar z1081 = s_roll * z1068 + c_roll * z1074;
    const Scalar z1083 = s_roll * z1078 - c_roll * z1079;
    const Scalar z1084 = n39_8603 * a_yaw + z1083;  // moment on frame.1, z
    const Scalar z1085 = s_yaw * z1080 + c_yaw * z1073;
    const Scalar z1086 = s_yaw * z1073 - c_yaw * z1080;
    const Scalar z1089 = n87 * a_x + z1085;  // force on frame.z, x
    const Scalar z1090 = n87 * a_y + z1086;  // force on frame.z, y
    const Scalar z1091 = n87 * z1007 - z1081;  // force on frame.z, z
    const Scalar z1102 = n2 * s_roll * z334;
    const Scalar z1103 = c_roll * c_pitch;
    const Scalar z1104 = n2 * z329 * z1103;
    const Scalar z1105 = z1102 + z1104;
    const Scalar z1106 = c_roll * s_pitch;
    const Scalar z1107 = z328 * z1103 - z329 * z1106;
    const Scalar z1108 = z60 + z1107;
    const Scalar z1109 = n1_1 * z1105 - n0_3 * z1108;
    const Scalar z1110 = c_pitch * z62;
    const Scalar z1111 = v_pitch * z1106 + z1110;
    const Scalar z1112 = s_roll * z328 - z334 * z1106;
    const Scalar z1113 = z1111 - z1112;
    const Scalar z1114 = s_pitch * z62;
    const Scalar z1115 = v_pitch * z1103 - z1114;
    const Scalar z1116 = s_roll * z329 + z334 * z1103;
    const Scalar z1117 = z1115 + z1116;
    const Scalar z1118 = n1_1 * z1113 - n0_3 * z1117;
    const Scalar z1119 = z60 - z1107;
    const Scalar z1120 = n2 * z328 * z1106;
    const Scalar z1121 = z1102 - z1120;
    const Scalar z1122 = n1_1 * z1119 + n0_3 * z1121;
    const Scalar z1123 = z38 * z1109 + z39 * z1118 + z40 * z1122;
    const Scalar z1124 = s_roll * c_steer + z39 * z1106 + z41 * z1103;
    const Scalar z1125 = n2 * z353 * z1124;
    const Scalar z1126 = s_roll * z41 + z40 * z1106 - z42 * z1103;
    const Scalar z1127 = n2 * z366 * z1126;
    const Scalar z1128 = z1125 - z1127;
    const Scalar z1129 = s_roll * z39 - z38 * z1106 + z40 * z1103;
    const Scalar z1130 = z31 * z1126 + z32 * z1129;
    const Scalar z1131 = c_steer * z60 + z39 * z1115 - z41 * z1111;
    const Scalar z1132 = v_steer * z1130 - z1131;
    const Scalar z1133 = z365 * z1126 - z366 * z1129;
    const Scalar z1134 = z1132 + z1133;
    const Scalar z1135 = n7 * z1123 - n1_04 * z1128 - n3_85 * z1134;
    const Scalar z1136 = c_steer * z1118 - z39 * z1109 + z41 * z1122;
    const Scalar z1137 = z40 * z1115 + z41 * z60 + z42 * z1111;
    const Scalar z1138 = z31 * v_steer * z1124 + z1137;
    const Scalar z1139 = z353 * z1129 + z365 * z1124;
    const Scalar z1140 = z1138 - z1139;
    const Scalar z1141 = z38 * z1115 - z39 * z60 + z40 * z1111;
    const Scalar z1142 = z32 * v_steer * z1124 - z1141;
    const Scalar z1143 = z353 * z1126 - z366 * z1124;
    const Scalar z1144 = z1142 + z1143;
    const Scalar z1145 = n7 * z1136 - n1_04 * z1140 - n3_85 * z1144;
    const Scalar z1146 = z40 * z1109 - z41 * z1118 + z42 * z1122;
    const Scalar z1147 = z1132 - z1133;
    const Scalar z1148 = n2 * z365 * z1129;
    const Scalar z1149 = z1125 + z1148;
    const Scalar z1150 = n7 * z1146 + n1_04 * z1147 - n3_85 * z1149;
    const Scalar z1151 = z38 * z1135 - z39 * z1145 + z40 * z1150;
    const Scalar z1152 = n25_5 * z1105 + n51 * z1108 + z1151;
    const Scalar z1153 = z40 * z1135 + z41 * z1145 + z42 * z1150;
    const Scalar z1154 = n25_5 * z1119 - n51 * z1121 + z1153;
    const Scalar z1155 = s_pitch * z1152 - c_pitch * z1154;
    const Scalar z1156 = c_steer * z1145 + z39 * z1135 - z41 * z1150;
    const Scalar z1157 = n25_5 * z1113 + n51 * z1117 + z1156;
    const Scalar z1158 = s_roll * z1155 + c_roll * z1157;
    const Scalar z1159 = s_pitch * z1154 + c_pitch * z1152;
    const Scalar z1160 = s_yaw * z1158 - c_yaw * z1159;
    const Scalar z1161 = s_roll * z1008;
    const Scalar z1162 = s_pitch * z1161 + c_pitch * z1009;
    const Scalar z1163 = c_roll * z1008;
    const Scalar z1164 = s_pitch * z1009 - c_pitch * z1161;
    const Scalar z1165 = z38 * z1162 + z39 * z1163 + z40 * z1164;
    const Scalar z1166 = n7 * z1165;
    const Scalar z1167 = c_steer * z1163 - z39 * z1162 + z41 * z1164;
    const Scalar z1168 = n7 * z1167;
    const Scalar z1169 = z40 * z1162 - z41 * z1163 + z42 * z1164;
    const Scalar z1170 = n7 * z1169;
    const Scalar z1171 = z38 * z1166 - z39 * z1168 + z40 * z1170;
    const Scalar z1172 = z40 * z1166 + z41 * z1168 + z42 * z1170;
    const Scalar z1173 = s_pitch * z1171 - c_pitch * z1172;
    const Scalar z1174 = c_steer * z1168 + z39 * z1166 - z41 * z1170;
    const Scalar z1175 = s_roll * z1173 + c_roll * z1174;
    const Scalar z1176 = s_pitch * z1172 + c_pitch * z1171;
    const Scalar z1177 = s_yaw * (z1073 - z1175) - c_yaw * (z1080 - z1176);
    const Scalar z1178 = s_yaw * z1159 + c_yaw * z1158;
    const Scalar z1179 = s_yaw * (z1080 - z1176) + c_yaw * (z1073 - z1175);
    const Scalar z1182 = n0_28 * z1132;
    const Scalar z1183 = z1127 + z1148;
    const Scalar z1184 = n3_85 * z1123 - n2_5667 * z1132 - k33 * z1133 - n1_04 * z1146 - z1182 + k11 * z1183;
    const Scalar z1185 = z366 * z1124 - z385 * z1126;
    const Scalar z1186 = n0_28 * z1185;
    const Scalar z1187 = n3_85 * z1136 - k11 * z1140 - k10 * z1142 - k32 * z1143 + z1186;
    const Scalar z1188 = z365 * z1124 + z385 * z1129;
    const Scalar z1189 = n0_28 * z1188;
    const Scalar z1190 = n1_04 * z1136 - k12 * z1138 + k35 * z1139 - k11 * z1144 + z1189;
    const Scalar z1191 = c_steer * z1184 - z39 * z1187 - z41 * z1190;
    const Scalar z1192 = n0_12 * z60;
    const Scalar z1193 = z1104 + z1120;
    const Scalar z1194 = n49_25 * z60 + n29_35 * z1107 - n0_3 * z1151 + n1_1 * z1153 + z1191 + z1192 + n17_7 * z1193;
    const Scalar z1195 = z38 * z1187 + z39 * z1184 - z40 * z1190;
    const Scalar z1196 = s_roll * z329 + z337 * z1103;
    const Scalar z1197 = n0_12 * z1196;
    const Scalar z1198 = n17_7 * z1113 + n78_6 * z1116 - n0_3 * z1156 + z1195 + z1197;
    const Scalar z1199 = z40 * z1187 - z41 * z1184 - z42 * z1190;
    const Scalar z1200 = s_roll * z328 - z337 * z1106;
    const Scalar z1201 = n0_12 * z1200;
    const Scalar z1202 = n29_35 * z1111 + n49_25 * z1112 - n17_7 * z1117 - n1_1 * z1156 - z1199 + z1201;
    const Scalar z1203 = s_pitch * z1198 + c_pitch * z1202;
    const Scalar z1204 = n79_7206 * z62 - z1203;
    const Scalar z1205 = s_roll * z1194 - c_roll * z1204;
    const Scalar z1206 = z51 * z55;
    const Scalar z1207 = z50 * z55;
    const Scalar z1208 = z102 - z113 * z117;
    const Scalar z1209 = z101 + z112 * z117;
    const Scalar z1210 = n3_85 * z1165 - n1_04 * z1169;
    const Scalar z1211 = n3_85 * z1167;
    const Scalar z1212 = n1_04 * z1167;
    const Scalar z1213 = c_steer * z1210 - z39 * z1211 - z41 * z1212;
    const Scalar z1214 = n51 * z1162 + n25_5 * z1164 - n0_3 * z1171 + n1_1 * z1172 + z1213;
    const Scalar z1215 = z38 * z1211 + z39 * z1210 - z40 * z1212;
    const Scalar z1216 = n51 * z1163 - n0_3 * z1174 + z1215;
    const Scalar z1217 = z40 * z1211 - z41 * z1210 - z42 * z1212;
    const Scalar z1218 = n25_5 * z1163 + n1_1 * z1174 + z1217;
    const Scalar z1219 = s_pitch * z1216 - c_pitch * z1218;
    const Scalar z1220 = s_roll * z1214 + c_roll * z1219;
    const Scalar z1221 = l_lambda_rear_rolls_x * z1207 + l_lambda_rear_rolls_y * z1206 - l_lambda_front_rolls_x * z1209
        - l_lambda_front_rolls_y * z1208 + z1220;
    const Scalar z1222 = s_pitch * z1202 - c_pitch * z1198;
    const Scalar z1223 = s_roll * z323 + c_roll * z322;
    const Scalar z1224 = z1222 + n39_8603 * z1223;
    const Scalar z1225 = s_pitch * z1218 + c_pitch * z1216;
    const Scalar z1226 = z219 * l_lambda_rear_rolls_y - z220 * l_lambda_rear_rolls_x + z243 * l_lambda_front_rolls_y
        - z244 * l_lambda_front_rolls_x + z1225;
    const Scalar z1227 = s_roll * z1207 - z48 * z218;
    const Scalar z1228 = s_roll * z1206 - z49 * z218;
    const Scalar z1229 = s_roll * z1209 + z48 * z242;
    const Scalar z1230 = s_roll * z1208 + z49 * z242;
    const Scalar z1231 = l_lambda_rear_rolls_x * z1227 + l_lambda_rear_rolls_y * z1228 - l_lambda_front_rolls_x * z1229
        - l_lambda_front_rolls_y * z1230 + z1214;
    const Scalar z1232 = z31 * z1187 - z32 * z1190;
    const Scalar z1233 = z259 - z1209;
    const Scalar z1234 = z252 * z1233 - z253 * z266;
    const Scalar z1235 = z260 - z1208;
    const Scalar z1236 = z252 * z1235 - z254 * z266;
    const Scalar z1237 = z31 * z1211 - z32 * z1212;
    const Scalar z1238 = l_lambda_front_rolls_x * z1234 + l_lambda_front_rolls_y * z1236 + z1237;
    const Scalar z1239 = l_lambda_rear_rolls_x * z1227 + l_lambda_rear_rolls_y * z1228;
    const Scalar z1240 = z101 - z1209;
    const Scalar z1241 = z109 * z1240 + z110 * z272;
    const Scalar z1242 = z102 - z1208;
    const Scalar z1243 = z109 * z1242 - z111 * z272;
    const Scalar z1244 = l_lambda_front_rolls_x * z1241 + l_lambda_front_rolls_y * z1243;
    const Scalar z1245 = n2 * s_pitch * z329;
    const Scalar z1246 = s_pitch * z328 + c_pitch * z329;
    const Scalar z1247 = z323 + z1246;
    const Scalar z1248 = n1_1 * z1245 - n0_3 * z1247;
    const Scalar z1249 = c_pitch * z322;
    const Scalar z1250 = v_pitch * c_pitch - z1249;
    const Scalar z1251 = c_pitch * z334;
    const Scalar z1252 = z1250 + z1251;
    const Scalar z1253 = s_pitch * z322;
    const Scalar z1254 = v_pitch * s_pitch - z1253;
    const Scalar z1255 = s_pitch * z334;
    const Scalar z1256 = z1254 + z1255;
    const Scalar z1257 = n1_1 * z1252 + n0_3 * z1256;
    const Scalar z1258 = z323 - z1246;
    const Scalar z1259 = n2 * c_pitch * z328;
    const Scalar z1260 = n1_1 * z1258 + n0_3 * z1259;
    const Scalar z1261 = z38 * z1248 - z39 * z1257 + z40 * z1260;
    const Scalar z1262 = n2 * z106 * z353;
    const Scalar z1263 = s_pitch * z42 + c_pitch * z40;
    const Scalar z1264 = n2 * z366 * z1263;
    const Scalar z1265 = z1262 + z1264;
    const Scalar z1266 = s_pitch * z40 + c_pitch * z38;
    const Scalar z1267 = z31 * z1263 - z32 * z1266;
    const Scalar z1268 = c_steer * z323 + z39 * z1254 + z41 * z1250;
    const Scalar z1269 = v_steer * z1267 + z1268;
    const Scalar z1270 = z365 * z1263 + z366 * z1266;
    const Scalar z1271 = z1269 + z1270;
    const Scalar z1272 = n7 * z1261 - n1_04 * z1265 + n3_85 * z1271;
    const Scalar z1273 = c_steer * z1257 + z39 * z1248 - z41 * z1260;
    const Scalar z1274 = z40 * z1254 + z41 * z323 - z42 * z1250;
    const Scalar z1275 = z31 * v_steer * z106 + z1274;
    const Scalar z1276 = z106 * z365 + z353 * z1266;
    const Scalar z1277 = z1275 - z1276;
    const Scalar z1278 = z38 * z1254 - z39 * z323 - z40 * z1250;
    const Scalar z1279 = z32 * v_steer * z106 - z1278;
    const Scalar z1280 = z106 * z366 + z353 * z1263;
    const Scalar z1281 = z1279 - z1280;
    const Scalar z1282 = n7 * z1273 + n1_04 * z1277 + n3_85 * z1281;
    const Scalar z1283 = z40 * z1248 + z41 * z1257 + z42 * z1260;
    const Scalar z1284 = z1269 - z1270;
    const Scalar z1285 = n2 * z365 * z1266;
    const Scalar z1286 = z1262 + z1285;
    const Scalar z1287 = n7 * z1283 - n1_04 * z1284 - n3_85 * z1286;
    const Scalar z1288 = z38 * z1272 + z39 * z1282 + z40 * z1287;
    const Scalar z1289 = n25_5 * z1245 + n51 * z1247 + z1288;
    const Scalar z1290 = z40 * z1272 - z41 * z1282 + z42 * z1287;
    const Scalar z1291 = n25_5 * z1258 - n51 * z1259 + z1290;
    const Scalar z1292 = s_pitch * z1289 - c_pitch * z1291;
    const Scalar z1293 = c_steer * z1282 - z39 * z1272 + z41 * z1287;
    const Scalar z1294 = n25_5 * z1252 - n51 * z1256 + z1293;
    const Scalar z1295 = s_roll * z1292 - c_roll * z1294;
    const Scalar z1296 = s_pitch * z1291 + c_pitch * z1289;
    const Scalar z1297 = s_yaw * z1295 - c_yaw * z1296;
    const Scalar z1298 = n2 * z323 * z334;
    const Scalar z1299 = n2 * z329 * z1249;
    const Scalar z1300 = z1298 - z1299;
    const Scalar z1301 = z328 * z1249 - z329 * z1253;
    const Scalar z1302 = z1015 + z1301;
    const Scalar z1303 = c_steer * z323 - z39 * z1253 - z41 * z1249;
    const Scalar z1304 = n2 * z353 * z1303;
    const Scalar z1305 = z40 * z1253 - z41 * z323 - z42 * z1249;
    const Scalar z1306 = n2 * z366 * z1305;
    const Scalar z1307 = z1304 + z1306;
    const Scalar z1308 = s_pitch * z1012;
    const Scalar z1309 = n1_1 * z1300 + n0_3 * z1302 + z1308;
    const Scalar z1310 = z323 * z328 + z334 * z1253;
    const Scalar z1311 = c_pitch * z1014;
    const Scalar z1312 = v_pitch * z1253 - z1311;
    const Scalar z1313 = z1310 + z1312;
    const Scalar z1314 = z323 * z329 - z334 * z1249;
    const Scalar z1315 = s_pitch * z1014;
    const Scalar z1316 = v_pitch * z1249 + z1315;
    const Scalar z1317 = z1314 - z1316;
    const Scalar z1318 = z1013 + n1_1 * z1313 + n0_3 * z1317;
    const Scalar z1319 = n2 * z328 * z1253;
    const Scalar z1320 = z1298 + z1319;
    const Scalar z1321 = c_pitch * z1012;
    const Scalar z1322 = z1015 - z1301;
    const Scalar z1323 = n0_3 * z1320 - z1321 - n1_1 * z1322;
    const Scalar z1324 = z38 * z1309 - z39 * z1318 + z40 * z1323;
    const Scalar z1325 = z38 * z1253 + z39 * z323 - z40 * z1249;
    const Scalar z1326 = z365 * z1305 + z366 * z1325;
    const Scalar z1327 = z31 * z1305 - z32 * z1325;
    const Scalar z1328 = c_steer * z1015 + z39 * z1316 - z41 * z1312;
    const Scalar z1329 = v_steer * z1327 - z1328;
    const Scalar z1330 = z1326 + z1329;
    const Scalar z1331 = n1_04 * z1307 - n7 * z1324 - n3_85 * z1330;
    const Scalar z1332 = c_steer * z1318 + z39 * z1309 - z41 * z1323;
    const Scalar z1333 = z353 * z1325 + z365 * z1303;
    const Scalar z1334 = z40 * z1316 + z41 * z1015 + z42 * z1312;
    const Scalar z1335 = z31 * v_steer * z1303 - z1334;
    const Scalar z1336 = z1333 - z1335;
    const Scalar z1337 = z353 * z1305 + z366 * z1303;
    const Scalar z1338 = z38 * z1316 - z39 * z1015 + z40 * z1312;
    const Scalar z1339 = z32 * v_steer * z1303 + z1338;
    const Scalar z1340 = z1337 - z1339;
    const Scalar z1341 = n7 * z1332 - n1_04 * z1336 - n3_85 * z1340;
    const Scalar z1342 = n2 * z365 * z1325;
    const Scalar z1343 = z1304 + z1342;
    const Scalar z1344 = z40 * z1309 + z41 * z1318 + z42 * z1323;
    const Scalar z1345 = z1326 - z1329;
    const Scalar z1346 = n3_85 * z1343 - n7 * z1344 - n1_04 * z1345;
    const Scalar z1347 = z38 * z1331 - z39 * z1341 + z40 * z1346;
    const Scalar z1348 = n25_5 * z1300 - n51 * z1302 - z1347;
    const Scalar z1349 = z40 * z1331 + z41 * z1341 + z42 * z1346;
    const Scalar z1350 = n51 * z1320 + n25_5 * z1322 + z1349;
    const Scalar z1351 = s_pitch * z1348 + c_pitch * z1350;
    const Scalar z1352 = c_steer * z1341 + z39 * z1331 - z41 * z1346;
    const Scalar z1353 = n25_5 * z1313 - n51 * z1317 + z1352;
    const Scalar z1354 = s_roll * (z1068 + z1351) + c_roll * (z1074 - z1353);
    const Scalar z1355 = s_pitch * z1350 - c_pitch * z1348;
    const Scalar z1356 = s_yaw * z1354 + c_yaw * z1355;
    const Scalar z1357 = s_yaw * z1296 + c_yaw * z1295;
    const Scalar z1358 = s_yaw * z1355 - c_yaw * z1354;
    const Scalar z1359 = s_roll * z1294 + c_roll * z1292;
    const Scalar z1360 = s_roll * (z1074 - z1353) - c_roll * (z1068 + z1351);
    const Scalar z1361 = n0_28 * z1269;
    const Scalar z1362 = z1264 - z1285;
    const Scalar z1363 = n3_85 * z1261 + n2_5667 * z1269 + k33 * z1270 - n1_04 * z1283 + z1361 - k11 * z1362;
    const Scalar z1364 = z106 * z366 + z385 * z1263;
    const Scalar z1365 = n0_28 * z1364;
    const Scalar z1366 = n3_85 * z1273 + k11 * z1277 + k10 * z1279 - k32 * z1280 - z1365;
    const Scalar z1367 = z106 * z365 + z385 * z1266;
    const Scalar z1368 = n0_28 * z1367;
    const Scalar z1369 = n1_04 * z1273 + k12 * z1275 - k35 * z1276 + k11 * z1281 - z1368;
    const Scalar z1370 = c_steer * z1363 + z39 * z1366 + z41 * z1369;
    const Scalar z1371 = n0_12 * z323;
    const Scalar z1372 = z1245 - z1259;
    const Scalar z1373 = n49_25 * z323 + n29_35 * z1246 - n0_3 * z1288 + n1_1 * z1290 + z1370 + z1371 + n17_7 * z1372;
    const Scalar z1374 = z38 * z1366 - z39 * z1363 - z40 * z1369;
    const Scalar z1375 = s_pitch * z337;
    const Scalar z1376 = n0_12 * z1375;
    const Scalar z1377 = n17_7 * z1252 - n78_6 * z1255 - n0_3 * z1293 + z1374 - z1376;
    const Scalar z1378 = z40 * z1366 + z41 * z1363 - z42 * z1369;
    const Scalar z1379 = c_pitch * z337;
    const Scalar z1380 = n0_12 * z1379;
    const Scalar z1381 = n29_35 * z1250 - n49_25 * z1251 + n17_7 * z1256 - n1_1 * z1293 - z1378 - z1380;
    const Scalar z1382 = s_pitch * z1377 + c_pitch * z1381;
    const Scalar z1383 = n79_7206 * z322 + z1382;
    const Scalar z1384 = s_roll * z1373 - c_roll * z1383;
    const Scalar z1385 = n0_3 * z78 / (z54 * z54);
    const Scalar z1386 = z50 * z1385 - z55 * z73;
    const Scalar z1387 = z51 * z1385 - z55 * z75;
    const Scalar z1388 = s_yaw * z100;
    const Scalar z1389 = n0_35 * z155 / (z116 * z116);
    const Scalar z1390 = z112 * z1389 - z117 * z150 + z1388;
    const Scalar z1391 = c_yaw * z100;
    const Scalar z1392 = z113 * z1389 - z117 * z152 - z1391;
    const Scalar z1393 = z1299 + z1319;
    const Scalar z1394 = z1306 - z1342;
    const Scalar z1395 = n0_28 * z1329;
    const Scalar z1396 = n3_85 * z1324 + k33 * z1326 + n2_5667 * z1329 - n1_04 * z1344 - k11 * z1394 + z1395;
    const Scalar z1397 = z366 * z1303 + z385 * z1305;
    const Scalar z1398 = n0_28 * z1397;
    const Scalar z1399 = n3_85 * z1332 - k11 * z1336 - k32 * z1337 + k10 * z1339 - z1398;
    const Scalar z1400 = z365 * z1303 + z385 * z1325;
    const Scalar z1401 = n0_28 * z1400;
    const Scalar z1402 = n1_04 * z1332 - k35 * z1333 + k12 * z1335 - k11 * z1340 - z1401;
    const Scalar z1403 = c_steer * z1396 + z39 * z1399 + z41 * z1402;
    const Scalar z1404 = n0_12 * z1015;
    const Scalar z1405 = n49_25 * z1015 + n29_35 * z1301 - n51 * z1308 + n25_5 * z1321 - n0_3 * z1347 + n1_1 * z1349
        + n17_7 * z1393 - z1403 + z1404;
    const Scalar z1406 = n39_8603 * (z327 - z1015) + z1405;
    const Scalar z1407 = z323 * z329 - z337 * z1249;
    const Scalar z1408 = n0_12 * z1407;
    const Scalar z1409 = z38 * z1399 - z39 * z1396 - z40 * z1402;
    const Scalar z1410 = n51 * z1013 + n17_7 * z1313 - n78_6 * z1314 - n0_3 * z1352 - z1408 + z1409;
    const Scalar z1411 = z323 * z328 + z337 * z1253;
    const Scalar z1412 = n0_12 * z1411;
    const Scalar z1413 = z40 * z1399 + z41 * z1396 - z42 * z1402;
    const Scalar z1414 = n25_5 * z1013 + n49_25 * z1310 - n29_35 * z1312 - n17_7 * z1317 + n1_1 * z1352 + z1412 + z1413;
    const Scalar z1415 = s_pitch * z1410 - c_pitch * z1414;
    const Scalar z1416 = n79_7206 * z326 + z1415;
    const Scalar z1417 = s_roll * (z1079 - z1406) + c_roll * (z1078 - z1416);
    const Scalar z1418 = l_lambda_rear_rolls_x * z1387 - l_lambda_rear_rolls_y * z1386 + l_lambda_front_rolls_x * z1392
        + l_lambda_front_rolls_y * z1390 - z1417;
    const Scalar z1419 = s_pitch * z1381 - c_pitch * z1377;
    const Scalar z1420 = n2 * (s_roll * z48 + c_roll * z72);
    const Scalar z1421 = n2 * (s_roll * z49 + c_roll * z74);
    const Scalar z1422 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z1423 = n2 * (z50 * z1420 + z51 * z1421 - z52 * z1422 - z73 * z73 - z75 * z75 - z76 * z76);
    const Scalar z1424 = n0_5 * (z77 * z78 / (z54 * z54) + z1423 / z54);
    const Scalar z1425 = n0_3 * z1424;
    const Scalar z1426 = s_yaw * z108;
    const Scalar z1427 = z109 * (z110 + z1426) + n2 * z108 * z149;
    const Scalar z1428 = c_yaw * z108;
    const Scalar z1429 = -z109 * (z111 - z1428) + n2 * z108 * z151;
    const Scalar z1430 = n2 * (z108 * z108 - z109 * z109);
    const Scalar z1431 = n2 * (z112 * z1427 - z113 * z1429 + z114 * z1430 - z150 * z150 - z152 * z152 - z153 * z153);
    const Scalar z1432 = n0_5 * (z154 * z155 / (z116 * z116) + z1431 / z116);
    const Scalar z1433 = z100 - n0_35 * z1432;
    const Scalar z1434 = z52 * z1385 - z55 * z76;
    const Scalar z1435 = s_yaw * z1434;
    const Scalar z1436 = c_yaw * z1434;
    const Scalar z1437 = z99 + z114 * z1389 + z117 * z153;
    const Scalar z1438 = s_yaw * z1437;
    const Scalar z1439 = c_yaw * z1437;
    const Scalar z1440 = z322 * z322 - z323 * z323;
    const Scalar z1441 = s_pitch * z1414 + c_pitch * z1410;
    const Scalar z1442 = n39_8603 * z1440 - z1441;
    const Scalar z1443 = l_lambda_rear_touches * z1425 - l_lambda_front_touches * z1433 + l_lambda_rear_rolls_x * z1435
        + l_lambda_rear_rolls_y * z1436 + l_lambda_front_rolls_x * z1438 + l_lambda_front_rolls_y * z1439 + z1442;
    const Scalar z1444 = s_roll * z97;
    const Scalar z1445 = s_yaw * z158;
    const Scalar z1446 = z108 * z160 - z109 * z1445 + z110 * z159 - z149 * z158;
    const Scalar z1447 = c_yaw * z158;
    const Scalar z1448 = z108 * z162 - z109 * z1447 - z111 * z159 - z151 * z158;
    const Scalar z1449 = n2 * (z108 * z158 + z109 * z159);
    const Scalar z1450 = n2 * (z112 * z1446 - z113 * z1448 - z114 * z1449 + z150 * z161 - z152 * z163 + z153 * z164);
    const Scalar z1451 = n0_5 * (z155 * z165 / (z116 * z116) - z1450 / z116);
    const Scalar z1452 = z1444 - n0_35 * z1451;
    const Scalar z1453 = s_roll * z1387 + c_roll * z217 + z49 * z1434 + z74 * z218;
    const Scalar z1454 = s_roll * z1386 - c_roll * z216 + z48 * z1434 + z72 * z218;
    const Scalar z1455 = s_roll * z1392 + c_roll * z241 + z49 * z1437 + z74 * z242;
    const Scalar z1456 = s_roll * z1390 + c_roll * z240 - z48 * z1437 - z72 * z242;
    const Scalar z1457 = l_lambda_front_touches * z1452 - l_lambda_rear_rolls_x * z1453 + l_lambda_rear_rolls_y * z1454
        - l_lambda_front_rolls_x * z1455 - l_lambda_front_rolls_y * z1456 - z1405;
    const Scalar z1458 = z31 * z1366 - z32 * z1369;
    const Scalar z1459 = s_roll * z176 + c_roll * z170;
    const Scalar z1460 = s_yaw * z179;
    const Scalar z1461 = z108 * z182 + z109 * z1460 + z110 * z180 + z149 * z179;
    const Scalar z1462 = c_yaw * z179;
    const Scalar z1463 = z108 * z184 - z109 * z1462 + z111 * z180 - z151 * z179;
    const Scalar z1464 = n2 * (z108 * z179 - z109 * z180);
    const Scalar z1465 = n2 * (z112 * z1461 + z113 * z1463 + z114 * z1464 + z150 * z183 + z152 * z185 - z153 * z186);
    const Scalar z1466 = n0_5 * (z155 * z187 / (z116 * z116) - z1465 / z116);
    const Scalar z1467 = z1459 - n0_35 * z1466;
    const Scalar z1468 = c_yaw * z258;
    const Scalar z1469 = z1392 + z1468;
    const Scalar z1470 = c_yaw * z252;
    const Scalar z1471 = z257 - z1437;
    const Scalar z1472 = z251 * z265 + z252 * z1469 + z254 * z1471 - z266 * z1470;
    const Scalar z1473 = s_yaw * z258;
    const Scalar z1474 = z1390 - z1473;
    const Scalar z1475 = s_yaw * z252;
    const Scalar z1476 = z251 * z264 + z252 * z1474 - z253 * z1471 + z266 * z1475;
    const Scalar z1477 = z31 * z1399 - z32 * z1402;
    const Scalar z1478 = l_lambda_front_touches * z1467 - l_lambda_front_rolls_x * z1472 - l_lambda_front_rolls_y
        * z1476 - z1477;
    const Scalar z1479 = l_lambda_rear_rolls_x * z1453 - l_lambda_rear_rolls_y * z1454 + z1404;
    const Scalar z1480 = z1391 + z1392;
    const Scalar z1481 = z99 - z1437;
    const Scalar z1482 = z108 * z271 - z109 * z1480 + z111 * z1481 - z151 * z272;
    const Scalar z1483 = z1388 - z1390;
    const Scalar z1484 = z108 * z270 + z109 * z1483 + z110 * z1481 + z149 * z272;
    const Scalar z1485 = l_lambda_front_rolls_x * z1482 + l_lambda_front_rolls_y * z1484 + z1395;
    const Scalar z1486 = n2 * z334;
    const Scalar z1487 = n1_1 * z1486;
    const Scalar z1488 = n2 * z328;
    const Scalar z1489 = n2 * z329;
    const Scalar z1490 = n1_1 * z1488 + n0_3 * z1489;
    const Scalar z1491 = n0_3 * z1486;
    const Scalar z1492 = z38 * z1487 - z39 * z1490 + z40 * z1491;
    const Scalar z1493 = n2 * c_steer * z353;
    const Scalar z1494 = n2 * z41 * z366;
    const Scalar z1495 = z1493 - z1494;
    const Scalar z1496 = z31 * z41 + z32 * z39;
    const Scalar z1497 = z39 * z329 + z41 * z328;
    const Scalar z1498 = v_steer * z1496 - z1497;
    const Scalar z1499 = z39 * z366 - z41 * z365;
    const Scalar z1500 = z1498 - z1499;
    const Scalar z1501 = n7 * z1492 - n1_04 * z1495 - n3_85 * z1500;
    const Scalar z1502 = c_steer * z1490 + z39 * z1487 - z41 * z1491;
    const Scalar z1503 = z40 * z329 - z42 * z328;
    const Scalar z1504 = z31 * v_steer * c_steer + z1503;
    const Scalar z1505 = c_steer * z365 + z39 * z353;
    const Scalar z1506 = z1504 - z1505;
    const Scalar z1507 = z38 * z329 - z40 * z328;
    const Scalar z1508 = z32 * v_steer * c_steer - z1507;
    const Scalar z1509 = c_steer * z366 - z41 * z353;
    const Scalar z1510 = z1508 - z1509;
    const Scalar z1511 = n7 * z1502 + n1_04 * z1506 + n3_85 * z1510;
    const Scalar z1512 = z40 * z1487 + z41 * z1490 + z42 * z1491;
    const Scalar z1513 = z1498 + z1499;
    const Scalar z1514 = n2 * z39 * z365;
    const Scalar z1515 = z1493 + z1514;
    const Scalar z1516 = n7 * z1512 + n1_04 * z1513 - n3_85 * z1515;
    const Scalar z1517 = z38 * z1501 + z39 * z1511 + z40 * z1516;
    const Scalar z1518 = n25_5 * z1486 + z1517;
    const Scalar z1519 = z40 * z1501 - z41 * z1511 + z42 * z1516;
    const Scalar z1520 = n51 * z1486 - z1519;
    const Scalar z1521 = s_pitch * z1518 + c_pitch * z1520;
    const Scalar z1522 = c_steer * z1511 - z39 * z1501 + z41 * z1516;
    const Scalar z1523 = n25_5 * z1488 - n51 * z1489 + z1522;
    const Scalar z1524 = s_roll * z1521 - c_roll * z1523;
    const Scalar z1525 = s_pitch * z1520 - c_pitch * z1518;
    const Scalar z1526 = s_yaw * z1524 + c_yaw * z1525;
    const Scalar z1527 = n2 * z328 * z329;
    const Scalar z1528 = z328 * z328 - z329 * z329;
    const Scalar z1529 = n2 * z353 * z1497;
    const Scalar z1530 = n2 * z366 * z1503;
    const Scalar z1531 = z1529 - z1530;
    const Scalar z1532 = z1019 + n1_1 * z1527 - n0_3 * z1528;
    const Scalar z1533 = n0_3 * z1027 - n1_1 * z1028;
    const Scalar z1534 = z1018 - n0_3 * z1527 - n1_1 * z1528;
    const Scalar z1535 = z38 * z1532 - z39 * z1533 + z40 * z1534;
    const Scalar z1536 = z365 * z1503 + z366 * z1507;
    const Scalar z1537 = z31 * z1503 - z32 * z1507;
    const Scalar z1538 = z39 * z1022 - z41 * z1020;
    const Scalar z1539 = v_steer * z1537 - z1538;
    const Scalar z1540 = z1536 + z1539;
    const Scalar z1541 = n1_04 * z1531 - n7 * z1535 + n3_85 * z1540;
    const Scalar z1542 = c_steer * z1533 + z39 * z1532 - z41 * z1534;
    const Scalar z1543 = z353 * z1507 - z365 * z1497;
    const Scalar z1544 = z40 * z1022 + z42 * z1020;
    const Scalar z1545 = z31 * v_steer * z1497 + z1544;
    const Scalar z1546 = z1543 + z1545;
    const Scalar z1547 = z353 * z1503 - z366 * z1497;
    const Scalar z1548 = z38 * z1022 + z40 * z1020;
    const Scalar z1549 = z32 * v_steer * z1497 - z1548;
    const Scalar z1550 = z1547 + z1549;
    const Scalar z1551 = n7 * z1542 + n1_04 * z1546 + n3_85 * z1550;
    const Scalar z1552 = n2 * z365 * z1507;
    const Scalar z1553 = z1529 - z1552;
    const Scalar z1554 = z40 * z1532 + z41 * z1533 + z42 * z1534;
    const Scalar z1555 = z1536 - z1539;
    const Scalar z1556 = n3_85 * z1553 - n7 * z1554 + n1_04 * z1555;
    const Scalar z1557 = z38 * z1541 - z39 * z1551 + z40 * z1556;
    const Scalar z1558 = n25_5 * z1527 + n51 * z1528 - z1557;
    const Scalar z1559 = z40 * z1541 + z41 * z1551 + z42 * z1556;
    const Scalar z1560 = n51 * z1527 - n25_5 * z1528 - z1559;
    const Scalar z1561 = s_pitch * (z1069 - z1558) - c_pitch * (z1067 - z1560);
    const Scalar z1562 = c_steer * z1551 + z39 * z1541 - z41 * z1556;
    const Scalar z1563 = n51 * z1027 + n25_5 * z1028 - z1562;
    const Scalar z1564 = s_roll * z1561 - c_roll * z1563;
    const Scalar z1565 = s_pitch * (z1067 - z1560) + c_pitch * (z1069 - z1558);
    const Scalar z1566 = s_yaw * z1564 - c_yaw * z1565;
    const Scalar z1567 = s_yaw * z1525 - c_yaw * z1524;
    const Scalar z1568 = s_yaw * z1565 + c_yaw * z1564;
    const Scalar z1569 = s_roll * z1523 + c_roll * z1521;
    const Scalar z1570 = s_roll * z1563 + c_roll * z1561;
    const Scalar z1571 = n0_28 * z1498;
    const Scalar z1572 = z1494 + z1514;
    const Scalar z1573 = n3_85 * z1492 - n2_5667 * z1498 + k33 * z1499 - n1_04 * z1512 - z1571 + k11 * z1572;
    const Scalar z1574 = c_steer * z366 - z41 * z385;
    const Scalar z1575 = n0_28 * z1574;
    const Scalar z1576 = n3_85 * z1502 + k11 * z1506 + k10 * z1508 - k32 * z1509 - z1575;
    const Scalar z1577 = c_steer * z365 + z39 * z385;
    const Scalar z1578 = n0_28 * z1577;
    const Scalar z1579 = n1_04 * z1502 + k12 * z1504 - k35 * z1505 + k11 * z1510 - z1578;
    const Scalar z1580 = c_steer * z1573 + z39 * z1576 + z41 * z1579;
    const Scalar z1581 = n0_3 * z1517 - n1_1 * z1519 - z1580;
    const Scalar z1582 = z38 * z1576 - z39 * z1573 - z40 * z1579;
    const Scalar z1583 = n0_12 * z329;
    const Scalar z1584 = n78_6 * z329 - n17_7 * z1488 + n0_3 * z1522 - z1582 + z1583;
    const Scalar z1585 = z40 * z1576 + z41 * z1573 - z42 * z1579;
    const Scalar z1586 = n0_12 * z328;
    const Scalar z1587 = n19_9 * z328 - n17_7 * z1489 + n1_1 * z1522 + z1585 + z1586;
    const Scalar z1588 = s_pitch * z1584 + c_pitch * z1587;
    const Scalar z1589 = s_roll * z1581 - c_roll * z1588;
    const Scalar z1590 = s_yaw * z1444 + c_yaw * z98;
    const Scalar z1591 = n0_35 * z166 / (z116 * z116);
    const Scalar z1592 = z112 * z1591 - z117 * z161 + z1590;
    const Scalar z1593 = s_yaw * z98 - c_yaw * z1444;
    const Scalar z1594 = z113 * z1591 + z117 * z163 + z1593;
    const Scalar z1595 = n2 * z1527;
    const Scalar z1596 = z1530 - z1552;
    const Scalar z1597 = n0_28 * z1539;
    const Scalar z1598 = n3_85 * z1535 - k33 * z1536 - n2_5667 * z1539 - n1_04 * z1554 + k11 * z1596 - z1597;
    const Scalar z1599 = z366 * z1497 - z385 * z1503;
    const Scalar z1600 = n0_28 * z1599;
    const Scalar z1601 = n3_85 * z1542 + k11 * z1546 + k32 * z1547 + k10 * z1549 - z1600;
    const Scalar z1602 = z365 * z1497 - z385 * z1507;
    const Scalar z1603 = n0_28 * z1602;
    const Scalar z1604 = n1_04 * z1542 + k35 * z1543 + k12 * z1545 + k11 * z1550 - z1603;
    const Scalar z1605 = c_steer * z1598 + z39 * z1601 + z41 * z1604;
    const Scalar z1606 = n25_5 * z1018 + n51 * z1019 + n29_35 * z1528 + n0_3 * z1557 - n1_1 * z1559 + n17_7 * z1595
        + z1605;
    const Scalar z1607 = z38 * z1601 - z39 * z1598 - z40 * z1604;
    const Scalar z1608 = n78_6 * z345 + z411 + n17_7 * z1028 + n0_3 * z1562 - z1607;
    const Scalar z1609 = z40 * z1601 + z41 * z1598 - z42 * z1604;
    const Scalar z1610 = n49_25 * z347 + z409 - n29_35 * z1020 + n17_7 * z1027 - n1_1 * z1562 - z1609;
    const Scalar z1611 = s_pitch * (z1072 - z1608) - c_pitch * (z1070 - z1610);
    const Scalar z1612 = s_roll * z1606 - c_roll * z1611;
    const Scalar z1613 = l_lambda_front_rolls_x * z1594 + l_lambda_front_rolls_y * z1592 - z1612;
    const Scalar z1614 = s_pitch * z1587 - c_pitch * z1584;
    const Scalar z1615 = n0_5 * (z154 * z166 / (z116 * z116) - z1450 / z116);
    const Scalar z1616 = z1444 - n0_35 * z1615;
    const Scalar z1617 = z114 * z1591 + z117 * z164 - z157;
    const Scalar z1618 = s_yaw * z1617;
    const Scalar z1619 = c_yaw * z1617;
    const Scalar z1620 = s_pitch * (z1070 - z1610) + c_pitch * (z1072 - z1608);
    const Scalar z1621 = l_lambda_front_touches * z1616 - l_lambda_front_rolls_x * z1618 - l_lambda_front_rolls_y
        * z1619 + z1620;
    const Scalar z1622 = c_roll * z98;
    const Scalar z1623 = s_roll * z107;
    const Scalar z1624 = s_yaw * z1623 + c_yaw * z106;
    const Scalar z1625 = c_roll * z107;
    const Scalar z1626 = z109 * z1624 + z110 * z1625 - n2 * z158 * z160;
    const Scalar z1627 = s_yaw * z106 - c_yaw * z1623;
    const Scalar z1628 = z109 * z1627 + z111 * z1625 + n2 * z158 * z162;
    const Scalar z1629 = n2 * (z109 * z1625 - z158 * z158);
    const Scalar z1630 = n2 * (z112 * z1626 + z113 * z1628 - z114 * z1629 - z161 * z161 - z163 * z163 - z164 * z164);
    const Scalar z1631 = n0_5 * (z165 * z166 / (z116 * z116) + z1630 / z116);
    const Scalar z1632 = z1622 - n0_35 * z1631;
    const Scalar z1633 = s_roll * z1594 + z49 * z1617;
    const Scalar z1634 = s_roll * z1592 - z48 * z1617;
    const Scalar z1635 = l_lambda_front_touches * z1632 - l_lambda_front_rolls_x * z1633 - l_lambda_front_rolls_y
        * z1634 + z1606;
    const Scalar z1636 = z31 * z1576 - z32 * z1579;
    const Scalar z1637 = s_pitch * z175 + c_pitch * z173;
    const Scalar z1638 = c_roll * z1637;
    const Scalar z1639 = s_roll * z181;
    const Scalar z1640 = s_yaw * z1639 - c_yaw * z178;
    const Scalar z1641 = c_roll * z181;
    const Scalar z1642 = z109 * z1640 + z110 * z1641 + z158 * z182 - z160 * z179;
    const Scalar z1643 = s_yaw * z178 + c_yaw * z1639;
    const Scalar z1644 = z109 * z1643 - z111 * z1641 - z158 * z184 - z162 * z179;
    const Scalar z1645 = n2 * (z109 * z1641 - z158 * z179);
    const Scalar z1646 = n2 * (z112 * z1642 - z113 * z1644 - z114 * z1645 + z161 * z183 - z163 * z185 - z164 * z186);
    const Scalar z1647 = n0_5 * (z166 * z187 / (z116 * z116) - z1646 / z116);
    const Scalar z1648 = z1638 + n0_35 * z1647;
    const Scalar z1649 = c_roll * z249;
    const Scalar z1650 = s_roll * z255;
    const Scalar z1651 = s_yaw * z256 - c_yaw * z1650;
    const Scalar z1652 = z1594 - z1651;
    const Scalar z1653 = s_roll * z249;
    const Scalar z1654 = s_yaw * z250 - c_yaw * z1653;
    const Scalar z1655 = c_roll * z255;
    const Scalar z1656 = z1617 + z1655;
    const Scalar z1657 = z252 * z1652 - z254 * z1656 - z265 * z1649 + z266 * z1654;
    const Scalar z1658 = s_yaw * z1650 + c_yaw * z256;
    const Scalar z1659 = z1592 - z1658;
    const Scalar z1660 = s_yaw * z1653 + c_yaw * z250;
    const Scalar z1661 = z252 * z1659 + z253 * z1656 - z264 * z1649 + z266 * z1660;
    const Scalar z1662 = z31 * z1601 - z32 * z1604;
    const Scalar z1663 = l_lambda_front_touches * z1648 + l_lambda_front_rolls_x * z1657 + l_lambda_front_rolls_y
        * z1661 + z1662;
    const Scalar z1664 = z1593 - z1594;
    const Scalar z1665 = z157 + z1617;
    const Scalar z1666 = z109 * z1664 - z111 * z1665 + z158 * z271 + z162 * z272;
    const Scalar z1667 = z1590 - z1592;
    const Scalar z1668 = z109 * z1667 - z110 * z1665 + z158 * z270 - z160 * z272;
    const Scalar z1669 = l_lambda_front_rolls_x * z1666 + l_lambda_front_rolls_y * z1668 - z1597;
    const Scalar z1670 = n2 * z32 * z366;
    const Scalar z1671 = z31 * z366 + z32 * z365;
    const Scalar z1672 = z364 + z1671;
    const Scalar z1673 = n1_04 * z1670 - n3_85 * z1672;
    const Scalar z1674 = z31 * z353;
    const Scalar z1675 = z32 * z353;
    const Scalar z1676 = z364 - z1671;
    const Scalar z1677 = n2 * z31 * z365;
    const Scalar z1678 = n1_04 * z1676 + n3_85 * z1677;
    const Scalar z1679 = z38 * z1673 + z40 * z1678;
    const Scalar z1680 = z40 * z1673 + z42 * z1678;
    const Scalar z1681 = s_pitch * z1679 - c_pitch * z1680;
    const Scalar z1682 = z39 * z1673 - z41 * z1678;
    const Scalar z1683 = s_roll * z1681 + c_roll * z1682;
    const Scalar z1684 = s_pitch * z1680 + c_pitch * z1679;
    const Scalar z1685 = s_yaw * z1683 - c_yaw * z1684;
    const Scalar z1686 = s_steer * z334 + z168 * z328 - z169 * z329;
    const Scalar z1687 = n2 * z353 * z1686;
    const Scalar z1688 = z169 * z334 - z172 * z328 - z174 * z329;
    const Scalar z1689 = n2 * z366 * z1688;
    const Scalar z1690 = z1687 + z1689;
    const Scalar z1691 = z168 * z1034 + z171 * z1033 + z172 * z1035;
    const Scalar z1692 = z168 * z334 + z171 * z328 + z172 * z329;
    const Scalar z1693 = z365 * z1688 - z366 * z1692;
    const Scalar z1694 = z31 * z1688 + z32 * z1692;
    const Scalar z1695 = s_steer * z1021 - z168 * z1020 - z169 * z1022;
    const Scalar z1696 = v_steer * z1694 + z1695;
    const Scalar z1697 = z1693 + z1696;
    const Scalar z1698 = n1_04 * z1690 + n7 * z1691 - n3_85 * z1697;
    const Scalar z1699 = s_steer * z1034 + z168 * z1033 - z169 * z1035;
    const Scalar z1700 = z353 * z1692 - z365 * z1686;
    const Scalar z1701 = z169 * z1021 + z172 * z1020 - z174 * z1022;
    const Scalar z1702 = z31 * v_steer * z1686 - z1701;
    const Scalar z1703 = z1700 + z1702;
    const Scalar z1704 = z353 * z1688 + z366 * z1686;
    const Scalar z1705 = z168 * z1021 - z171 * z1020 + z172 * z1022;
    const Scalar z1706 = z32 * v_steer * z1686 - z1705;
    const Scalar z1707 = z1704 - z1706;
    const Scalar z1708 = n7 * z1699 - n1_04 * z1703 + n3_85 * z1707;
    const Scalar z1709 = n2 * z365 * z1692;
    const Scalar z1710 = z1687 - z1709;
    const Scalar z1711 = z169 * z1034 - z172 * z1033 - z174 * z1035;
    const Scalar z1712 = z1693 - z1696;
    const Scalar z1713 = n3_85 * z1710 - n7 * z1711 - n1_04 * z1712;
    const Scalar z1714 = z38 * z1698 + z39 * z1708 + z40 * z1713 - z168 * z1054 - z171 * z1053 - z172 * z1055;
    const Scalar z1715 = z40 * z1698 - z41 * z1708 + z42 * z1713 + z169 * z1054 - z172 * z1053 - z174 * z1055;
    const Scalar z1716 = s_pitch * z1714 - c_pitch * z1715;
    const Scalar z1717 = s_steer * z1054 + c_steer * z1708 - z39 * z1698 + z41 * z1713 + z168 * z1053 - z169 * z1055;
    const Scalar z1718 = s_roll * z1716 - c_roll * z1717;
    const Scalar z1719 = s_pitch * z1715 + c_pitch * z1714;
    const Scalar z1720 = s_yaw * z1718 - c_yaw * z1719;
    const Scalar z1721 = s_yaw * z1684 + c_yaw * z1683;
    const Scalar z1722 = s_yaw * z1719 + c_yaw * z1718;
    const Scalar z1723 = s_roll * z1682 - c_roll * z1681;
    const Scalar z1724 = s_roll * z1717 + c_roll * z1716;
    const Scalar z1725 = n0_28 * z364;
    const Scalar z1726 = z1670 - z1677;
    const Scalar z1727 = n2_5667 * z364 + k33 * z1671 + z1725 - k11 * z1726;
    const Scalar z1728 = z32 * z385;
    const Scalar z1729 = n0_28 * z1728;
    const Scalar z1730 = n0_287 * z1675 - z1729;
    const Scalar z1731 = z31 * z385;
    const Scalar z1732 = n0_28 * z1731;
    const Scalar z1733 = n0_287 * z1674 - z1732;
    const Scalar z1734 = c_steer * z1727 + z39 * z1730 + z41 * z1733;
    const Scalar z1735 = n0_3 * z1679 - n1_1 * z1680 + z1734;
    const Scalar z1736 = z38 * z1730 - z39 * z1727 - z40 * z1733;
    const Scalar z1737 = n0_3 * z1682 - z1736;
    const Scalar z1738 = z40 * z1730 + z41 * z1727 - z42 * z1733;
    const Scalar z1739 = n1_1 * z1682 + z1738;
    const Scalar z1740 = s_pitch * z1737 + c_pitch * z1739;
    const Scalar z1741 = s_roll * z1735 + c_roll * z1740;
    const Scalar z1742 = s_yaw * z1459 - c_yaw * z1637;
    const Scalar z1743 = n0_35 * z188 / (z116 * z116);
    const Scalar z1744 = z112 * z1743 - z117 * z183 + z1742;
    const Scalar z1745 = s_yaw * z1637 + c_yaw * z1459;
    const Scalar z1746 = z113 * z1743 - z117 * z185 - z1745;
    const Scalar z1747 = z1689 + z1709;
    const Scalar z1748 = n0_28 * z1696;
    const Scalar z1749 = n3_85 * z1691 - k33 * z1693 - n2_5667 * z1696 + n1_04 * z1711 + k11 * z1747 - z1748;
    const Scalar z1750 = z366 * z1686 + z385 * z1688;
    const Scalar z1751 = n0_28 * z1750;
    const Scalar z1752 = n3_85 * z1699 - k11 * z1703 + k32 * z1704 - k10 * z1706 + z1751;
    const Scalar z1753 = z365 * z1686 - z385 * z1692;
    const Scalar z1754 = n0_28 * z1753;
    const Scalar z1755 = n1_04 * z1699 - k35 * z1700 - k12 * z1702 + k11 * z1707 + z1754;
    const Scalar z1756 = s_steer * z1057 - c_steer * z1749 - z39 * z1752 - z41 * z1755 + z168 * z1056 + z169 * z1058;
    const Scalar z1757 = n0_3 * z1714 - n1_1 * z1715 + z1756;
    const Scalar z1758 = z38 * z1752 - z39 * z1749 - z40 * z1755 - z168 * z1057 - z171 * z1056 + z172 * z1058;
    const Scalar z1759 = n0_3 * z1717 - z1758;
    const Scalar z1760 = z40 * z1752 + z41 * z1749 - z42 * z1755 + z169 * z1057 - z172 * z1056 + z174 * z1058;
    const Scalar z1761 = n1_1 * z1717 + z1760;
    const Scalar z1762 = s_pitch * z1759 + c_pitch * z1761;
    const Scalar z1763 = s_roll * z1757 - c_roll * z1762;
    const Scalar z1764 = l_lambda_front_rolls_x * z1746 + l_lambda_front_rolls_y * z1744 - z1763;
    const Scalar z1765 = s_pitch * z1739 - c_pitch * z1737;
    const Scalar z1766 = n0_5 * (z154 * z188 / (z116 * z116) - z1465 / z116);
    const Scalar z1767 = z1459 - n0_35 * z1766;
    const Scalar z1768 = z114 * z1743 - z117 * z186 + z177;
    const Scalar z1769 = s_yaw * z1768;
    const Scalar z1770 = c_yaw * z1768;
    const Scalar z1771 = s_pitch * z1761 - c_pitch * z1759;
    const Scalar z1772 = l_lambda_front_touches * z1767 - l_lambda_front_rolls_x * z1769 - l_lambda_front_rolls_y
        * z1770 - z1771;
    const Scalar z1773 = n0_5 * (z165 * z188 / (z116 * z116) - z1646 / z116);
    const Scalar z1774 = z1638 + n0_35 * z1773;
    const Scalar z1775 = s_roll * z1746 + z49 * z1768;
    const Scalar z1776 = s_roll * z1744 - z48 * z1768;
    const Scalar z1777 = l_lambda_front_touches * z1774 + l_lambda_front_rolls_x * z1775 + l_lambda_front_rolls_y
        * z1776 - z1757;
    const Scalar z1779 = -c_steer * (n1 - z31 * z31);
    const Scalar z1780 = z31 * z32 * c_steer;
    const Scalar z1781 = n0_08 * z1779 + n0_35 * z1780;
    const Scalar z1782 = -c_steer * (n1 - z32 * z32);
    const Scalar z1783 = n0_08 * z1780 + n0_35 * z1782;
    const Scalar z1784 = s_pitch * z1781 - c_pitch * z1783;
    const Scalar z1785 = s_roll * z93 + c_roll * z1784;
    const Scalar z1786 = n2 * (z109 * z110 + z179 * z182);
    const Scalar z1787 = n2 * (z109 * z111 + z179 * z184);
    const Scalar z1788 = n2 * (z109 * z109 - z179 * z179);
    const Scalar z1789 = n2 * (z112 * z1786 + z113 * z1787 - z114 * z1788 - z183 * z183 - z185 * z185 - z186 * z186);
    const Scalar z1790 = n0_5 * (z187 * z188 / (z116 * z116) + z1789 / z116);
    const Scalar z1791 = z1785 - n0_35 * z1790;
    const Scalar z1792 = z252 * z1746 - z254 * z1768;
    const Scalar z1793 = z252 * z1744 + z253 * z1768;
    const Scalar z1794 = z31 * z1752 - z32 * z1755;
    const Scalar z1795 = l_lambda_front_touches * z1791 - l_lambda_front_rolls_x * z1792 - l_lambda_front_rolls_y
        * z1793 + z1794;
    const Scalar z1796 = z1745 + z1746;
    const Scalar z1797 = z177 - z1768;
    const Scalar z1798 = z109 * z1796 - z111 * z1797 + z179 * z271 + z184 * z272;
    const Scalar z1799 = z1742 - z1744;
    const Scalar z1800 = z109 * z1799 + z110 * z1797 - z179 * z270 - z182 * z272;
    const Scalar z1801 = l_lambda_front_rolls_x * z1798 - l_lambda_front_rolls_y * z1800 - z1748;
    const Scalar z1802 = s_pitch * z1583 + c_pitch * z1586;
    const Scalar z1803 = c_roll * z1802;
    const Scalar z1804 = s_pitch * z1586 - c_pitch * z1583;
    const Scalar z1805 = n0_28 * z366;
    const Scalar z1806 = n0_28 * z365;
    const Scalar z1807 = z39 * z1805 + z41 * z1806;
    const Scalar z1808 = z38 * z1805 - z40 * z1806;
    const Scalar z1809 = z40 * z1805 - z42 * z1806;
    const Scalar z1810 = s_pitch * z1808 - c_pitch * z1809;
    const Scalar z1811 = s_roll * z1807 - c_roll * z1810;
    const Scalar z1812 = s_pitch * z1809 + c_pitch * z1808;
    const Scalar z1813 = z31 * z1805 - z32 * z1806;
    const Scalar z1814 = a_z - a_roll * z79 - z91;
    const Scalar z1815 = a_z + a_roll * z156 - a_pitch * z167 - a_steer * z189 + z215;
    const Scalar z1816 = a_x + a_yaw * z241 - a_roll * z243 + a_pitch * z246 + a_steer * z267 + a_front * z273 + z306;
    const Scalar z1817 = -z223 * (a_pitch + a_rear) + a_y - a_yaw * z216 + a_roll * z220 - z239;
    const Scalar z1818 = a_y - a_yaw * z240 + a_roll * z244 - a_pitch * z247 - a_steer * z268 - a_front * z274 - z321;
    const Scalar z1819 = z222 * (a_pitch + a_rear) + a_x + a_yaw * z217 - a_roll * z219 + z233;
    const Scalar z1836 = v_yaw * z1209 - v_roll * z244 + v_pitch * z1229 + v_steer * z1234 - v_front * z1241;
    const Scalar z1837 = v_yaw * z1209 - v_roll * z244 + v_pitch * z1229 + v_steer * z1234 - v_front * z1241 + z283;
    const Scalar z1838 = z112 * z281 - z117 * z142 + z308;
    const Scalar z1839 = s_roll * z1838 - z48 * z285 - z60 * z1209 + z63 * z242;
    const Scalar z1840 = z314 + z1838;
    const Scalar z1841 = z252 * z1840 + z253 * z301 - z266 * z317 + z289 * z1233;
    const Scalar z1842 = z308 - z1838;
    const Scalar z1843 = z109 * z1842 - z110 * z304 + z138 * z1240 - z141 * z272;
    const Scalar z1844 = v_yaw * z1838 + v_roll * z312 + v_pitch * z1839 - v_steer * z1841 - v_front * z1843;
    const Scalar z1845 = a_yaw * z1209 - a_roll * z244 + a_pitch * z1229 + a_steer * z1234 - a_front * z1241 - z1844;
    const Scalar z1846 = z1228 * (v_pitch + v_rear) + v_yaw * z1206 - v_roll * z219;
    const Scalar z1847 = z1228 * (v_pitch + v_rear) + v_yaw * z1206 - v_roll * z219 - z236;
    const Scalar z1848 = z51 * z226 - z55 * z67;
    const Scalar z1849 = s_roll * z1848 - z49 * z230 + z60 * z1206 + z66 * z218;
    const Scalar z1850 = z1849 * (v_pitch + v_rear) + v_yaw * z1848 - v_roll * z231;
    const Scalar z1851 = z1228 * (a_pitch + a_rear) + a_yaw * z1206 - a_roll * z219 + z1850;
    const Scalar z1852 = v_yaw * z1208 + v_roll * z243 + v_pitch * z1230 + v_steer * z1236 - v_front * z1243;
    const Scalar z1853 = v_yaw * z1208 + v_roll * z243 + v_pitch * z1230 + v_steer * z1236 - v_front * z1243 + z311;
    const Scalar z1854 = z113 * z281 - z117 * z144 - z279;
    const Scalar z1855 = s_roll * z1854 + z49 * z285 + z60 * z1208 - z66 * z242;
    const Scalar z1856 = z293 - z1854;
    const Scalar z1857 = z252 * z1856 + z254 * z301 + z266 * z298 + z289 * z1235;
    const Scalar z1858 = z279 + z1854;
    const Scalar z1859 = z109 * z1858 + z111 * z304 + z138 * z1242 + z143 * z272;
    const Scalar z1860 = v_yaw * z1854 + v_roll * z286 + v_pitch * z1855 + v_steer * z1857 + v_front * z1859;
    const Scalar z1861 = a_yaw * z1208 + a_roll * z243 + a_pitch * z1230 + a_steer * z1236 - a_front * z1243 + z1860;
    const Scalar z1862 = z1227 * (v_pitch + v_rear) + v_yaw * z1207 + v_roll * z220;
    const Scalar z1863 = z1227 * (v_pitch + v_rear) + v_yaw * z1207 + v_roll * z220 - z228;
    const Scalar z1864 = z50 * z226 - z55 * z64;
    const Scalar z1865 = s_roll * z1864 - z48 * z230 + z60 * z1207 + z63 * z218;
    const Scalar z1866 = z1865 * (v_pitch + v_rear) + v_yaw * z1864 + v_roll * z237;
    const Scalar z1867 = z1227 * (a_pitch + a_rear) + a_yaw * z1207 + a_roll * z220 + z1866;
    const Scalar z1868 = s_yaw * z60 + s_roll * z61;
    const Scalar z1869 = s_roll * z1868 + c_roll * z63 + z48 * z62 + z60 * z72;
    const Scalar z1870 = c_yaw * z60 - s_roll * z65;
    const Scalar z1871 = s_roll * z1870 + c_roll * z66 + z49 * z62 + z60 * z74;
    const Scalar z1872 = n2 * (s_roll * z62 - c_roll * z60);
    const Scalar z1873 = n2 * (z50 * z1869 + z51 * z1871 - z52 * z1872 - z64 * z73 - z67 * z75 - z68 * z76);
    const Scalar z1874 = n0_5 * (z69 * z78 / (z54 * z54) + z1873 / z54);
    const Scalar z1875 = n0_3 * z1874;
    const Scalar z1876 = v_roll * c_roll + z60;
    const Scalar z1877 = s_yaw * z1876 + n2 * s_roll * z61;
    const Scalar z1878 = v_roll * s_roll + z62;
    const Scalar z1879 = n2 * (c_roll * z63 + z60 * z72) + s_roll * z1877 + z48 * z1878;
    const Scalar z1880 = c_yaw * z1876 - n2 * s_roll * z65;
    const Scalar z1881 = n2 * (c_roll * z66 + z60 * z74) + s_roll * z1880 + z49 * z1878;
    const Scalar z1882 = n2 * s_roll * z1878 - n4 * c_roll * z60;
    const Scalar z1883 = n2 * (z50 * z1879 + z51 * z1881 - z52 * z1882) - n4 * (z64 * z73 + z67 * z75 + z68 * z76);
    const Scalar z1884 = n0_5 * (z69 * z78 / (z54 * z54) + z70 * z77 / (z54 * z54) + z1883 / z54);
    const Scalar z1885 = n0_3 * z1884;
    const Scalar z1886 = s_yaw * z83 + s_roll * z81 - n2 * z60 * z61;
    const Scalar z1887 = -n2 * (z60 * z1868 - z62 * z63) + s_roll * z1886 - c_roll * z82 - z48 * z80 + z72 * z83;
    const Scalar z1888 = c_yaw * z83 + s_roll * z85 + n2 * z60 * z65;
    const Scalar z1889 = -n2 * (z60 * z1870 - z62 * z66) + s_roll * z1888 - c_roll * z86 - z49 * z80 + z74 * z83;
    const Scalar z1890 = n2 * (s_roll * z80 + c_roll * z83) + n4 * z60 * z62;
    const Scalar z1891 = n2 * (z50 * z1887 + z51 * z1889 + z52 * z1890 + z73 * z84 + z75 * z87 - z76 * z88) + n4 * (z64
        * z1869 + z67 * z1871 - z68 * z1872);
    const Scalar z1892 = n0_5 * (z69 * z1874 / (z54 * z54) + z70 * z1873 / (z54 * z54) + z78 * z89 / (z54 * z54) - z1891
        / z54) + z69 * z70 * z78 / (z54 * z54 * z54);
    const Scalar z1893 = n0_3 * z1892;
    const Scalar z1894 = a_roll * z1425 + z1893;
    const Scalar z1895 = s_yaw * z138 - z61 * z109;
    const Scalar z1896 = z108 * z141 + z109 * z1895 + z110 * z139 + z138 * z149;
    const Scalar z1897 = c_yaw * z138 + z65 * z109;
    const Scalar z1898 = z108 * z143 - z109 * z1897 + z111 * z139 - z138 * z151;
    const Scalar z1899 = n2 * (z108 * z138 - z109 * z139);
    const Scalar z1900 = n2 * (z112 * z1896 + z113 * z1898 + z114 * z1899 + z142 * z150 + z144 * z152 - z145 * z153);
    const Scalar z1901 = n0_5 * (z146 * z155 / (z116 * z116) - z1900 / z116);
    const Scalar z1902 = z278 - n0_35 * z1901;
    const Scalar z1903 = n2 * (s_roll * z134 + c_roll * z125) - z93 * z1878 - z98 * z1876;
    const Scalar z1904 = n2 * (s_roll * z127 - c_roll * z137) - c_steer * z1876 + z107 * z1878;
    const Scalar z1905 = s_yaw * z1904 - n2 * z61 * z109;
    const Scalar z1906 = n2 * (s_roll * z137 + c_roll * z127) + c_steer * z1878 + z107 * z1876;
    const Scalar z1907 = n2 * (z108 * z141 + z138 * z149) + z109 * z1905 + z110 * z1906;
    const Scalar z1908 = c_yaw * z1904 + n2 * z65 * z109;
    const Scalar z1909 = n2 * (z108 * z143 - z138 * z151) - z109 * z1908 + z111 * z1906;
    const Scalar z1910 = n4 * z108 * z138 - n2 * z109 * z1906;
    const Scalar z1911 = n2 * (z112 * z1907 + z113 * z1909 + z114 * z1910) + n4 * (z142 * z150 + z144 * z152 - z145
        * z153);
    const Scalar z1912 = n0_5 * (z146 * z155 / (z116 * z116) + z147 * z154 / (z116 * z116) - z1911 / z116);
    const Scalar z1913 = z1903 - n0_35 * z1912;
    const Scalar z1914 = n2 * (z60 * z134 - z62 * z125) + s_roll * z202 - c_roll * z193 - z80 * z93 + z83 * z98;
    const Scalar z1915 = s_yaw * z208 + n2 * z61 * z138 + z81 * z109;
    const Scalar z1916 = n2 * (z138 * z1895 - z139 * z141) + z108 * z207 - z109 * z1915 + z110 * z205 - z149 * z208;
    const Scalar z1917 = c_yaw * z208 - n2 * z65 * z138 + z85 * z109;
    const Scalar z1918 = -n2 * (z138 * z1897 + z139 * z143) + z108 * z210 + z109 * z1917 + z111 * z205 + z151 * z208;
    const Scalar z1919 = n2 * (z108 * z208 + z109 * z205) + n4 * z138 * z139;
    const Scalar z1920 = n2 * (z112 * z1916 + z113 * z1918 - z114 * z1919 + z150 * z209 + z152 * z211 + z153 * z212)
        - n4 * (z142 * z1896 + z144 * z1898 + z145 * z1899);
    const Scalar z1921 = n0_5 * (z146 * z1901 / (z116 * z116) - z147 * z1900 / (z116 * z116) + z155 * z213 / (z116
        * z116) - z1920 / z116) + z146 * z147 * z155 / (z116 * z116 * z116);
    const Scalar z1922 = z1914 + n0_35 * z1921;
    const Scalar z1923 = a_roll * z1433 + a_pitch * z1452 - a_steer * z1467 - z1922;
    const Scalar z1924 = v_yaw * z1392 + v_roll * z1438 + v_pitch * z1455 - v_steer * z1472 - v_front * z1482;
    const Scalar z1925 = v_yaw * z1392 + v_roll * z1438 + v_pitch * z1455 - v_steer * z1472 - v_front * z1482 - z286;
    const Scalar z1926 = n0_7 * z147 * z155 / (z116 * z116 * z116) + n0_35 * z1901 / (z116 * z116);
    const Scalar z1927 = c_yaw * z135 - z65 * z100;
    const Scalar z1928 = z113 * z1926 + z117 * z1898 - z144 * z1389 - z152 * z281 + z1927;
    const Scalar z1929 = z114 * z1926 + z117 * z1899 - z145 * z1389 + z153 * z281 + z278;
    const Scalar z1930 = s_yaw * z1929 - z61 * z1437;
    const Scalar z1931 = s_roll * z1928 - c_roll * z283 + z49 * z1929 - z60 * z1392 + z62 * z241 + z66 * z1437 - z74
        * z285 - z242 * z1870;
    const Scalar z1932 = c_yaw * z299 - z65 * z258;
    const Scalar z1933 = z1928 - z1932;
    const Scalar z1934 = z292 + z1929;
    const Scalar z1935 = c_yaw * z289 - z65 * z252;
    const Scalar z1936 = z251 * z295 - z252 * z1933 + z254 * z1934 + z265 * z297 - z266 * z1935 + z289 * z1469 - z298
        * z1471 + z301 * z1470;
    const Scalar z1937 = z1927 - z1928;
    const Scalar z1938 = z278 - z1929;
    const Scalar z1939 = z108 * z303 - z109 * z1937 - z111 * z1938 + z138 * z1480 + z139 * z271 + z143 * z1481 - z151
        * z304 + z272 * z1897;
    const Scalar z1940 = v_yaw * z1928 + v_roll * z1930 + v_pitch * z1931 + v_steer * z1936 + v_front * z1939;
    const Scalar z1941 = a_yaw * z1392 + a_roll * z1438 + a_pitch * z1455 - a_steer * z1472 - a_front * z1482 - z1940;
    const Scalar z1942 = z1454 * (v_pitch + v_rear) + v_yaw * z1386 - v_roll * z1436;
    const Scalar z1943 = z1454 * (v_pitch + v_rear) + v_yaw * z1386 - v_roll * z1436 + z237;
    const Scalar z1944 = n0_6 * z70 * z78 / (z54 * z54 * z54) + n0_3 * z1874 / (z54 * z54);
    const Scalar z1945 = z50 * z1944 - z55 * z1869 - z64 * z1385 - z73 * z226;
    const Scalar z1946 = z52 * z1944 + z55 * z1872 - z68 * z1385 - z76 * z226;
    const Scalar z1947 = c_yaw * z1946 - z65 * z1434;
    const Scalar z1948 = s_roll * z1945 - c_roll * z236 + z48 * z1946 + z60 * z1386 + z62 * z216 - z63 * z1434 + z72
        * z230 + z218 * z1868;
    const Scalar z1949 = z1948 * (v_pitch + v_rear) + v_yaw * z1945 - v_roll * z1947;
    const Scalar z1950 = z1454 * (a_pitch + a_rear) + a_yaw * z1386 - a_roll * z1436 + z1949;
    const Scalar z1951 = v_yaw * z1390 + v_roll * z1439 + v_pitch * z1456 - v_steer * z1476 - v_front * z1484;
    const Scalar z1952 = v_yaw * z1390 + v_roll * z1439 + v_pitch * z1456 - v_steer * z1476 - v_front * z1484 - z312;
    const Scalar z1953 = s_yaw * z135 + z61 * z100;
    const Scalar z1954 = z112 * z1926 + z117 * z1896 - z142 * z1389 - z150 * z281 - z1953;
    const Scalar z1955 = c_yaw * z1929 + z65 * z1437;
    const Scalar z1956 = s_roll * z1954 - c_roll * z311 - z48 * z1929 - z60 * z1390 + z62 * z240 - z63 * z1437 + z72
        * z285 + z242 * z1868;
    const Scalar z1957 = s_yaw * z299 + z61 * z258;
    const Scalar z1958 = z1954 + z1957;
    const Scalar z1959 = s_yaw * z289 + z61 * z252;
    const Scalar z1960 = z251 * z316 - z252 * z1958 - z253 * z1934 + z264 * z297 + z266 * z1959 + z289 * z1474 - z301
        * z1475 - z317 * z1471;
    const Scalar z1961 = z1953 + z1954;
    const Scalar z1962 = z108 * z319 + z109 * z1961 - z110 * z1938 - z138 * z1483 + z139 * z270 + z141 * z1481 + z149
        * z304 - z272 * z1895;
    const Scalar z1963 = v_yaw * z1954 + v_roll * z1955 + v_pitch * z1956 + v_steer * z1960 + v_front * z1962;
    const Scalar z1964 = a_yaw * z1390 + a_roll * z1439 + a_pitch * z1456 - a_steer * z1476 - a_front * z1484 - z1963;
    const Scalar z1965 = z1453 * (v_pitch + v_rear) + v_yaw * z1387 + v_roll * z1435;
    const Scalar z1966 = z1453 * (v_pitch + v_rear) + v_yaw * z1387 + v_roll * z1435 - z231;
    const Scalar z1967 = z51 * z1944 - z55 * z1871 - z67 * z1385 - z75 * z226;
    const Scalar z1968 = s_yaw * z1946 + z61 * z1434;
    const Scalar z1969 = s_roll * z1967 + c_roll * z228 + z49 * z1946 + z60 * z1387 - z62 * z217 - z66 * z1434 + z74
        * z230 + z218 * z1870;
    const Scalar z1970 = z1969 * (v_pitch + v_rear) + v_yaw * z1967 + v_roll * z1968;
    const Scalar z1971 = z1453 * (a_pitch + a_rear) + a_yaw * z1387 + a_roll * z1435 + z1970;
    const Scalar z1972 = c_roll * z277 + z62 * z97;
    const Scalar z1973 = s_roll * z140 + z60 * z106;
    const Scalar z1974 = s_yaw * z1973 - c_yaw * z137 + z61 * z159 + z65 * z107;
    const Scalar z1975 = c_roll * z140 - z62 * z106;
    const Scalar z1976 = z109 * z1974 + z110 * z1975 - z138 * z160 + z141 * z158;
    const Scalar z1977 = s_yaw * z137 + c_yaw * z1973 + z61 * z107 - z65 * z159;
    const Scalar z1978 = z109 * z1977 - z111 * z1975 - z138 * z162 - z143 * z158;
    const Scalar z1979 = n2 * (z109 * z1975 - z138 * z158);
    const Scalar z1980 = n2 * (z112 * z1976 - z113 * z1978 - z114 * z1979 + z142 * z161 - z144 * z163 - z145 * z164);
    const Scalar z1981 = n0_5 * (z146 * z166 / (z116 * z116) - z1980 / z116);
    const Scalar z1982 = z1972 + n0_35 * z1981;
    const Scalar z1983 = v_pitch * s_pitch + z131;
    const Scalar z1984 = v_pitch * c_pitch + z126;
    const Scalar z1985 = n2 * (s_pitch * z133 + c_pitch * z130) + z95 * z1983 - z96 * z1984;
    const Scalar z1986 = c_roll * z1985 + n2 * z62 * z97;
    const Scalar z1987 = n2 * (s_pitch * z124 - c_pitch * z123) + z39 * z1983 + z41 * z1984;
    const Scalar z1988 = s_roll * z1987 + n2 * z60 * z106;
    const Scalar z1989 = n2 * (s_pitch * z123 + c_pitch * z124) + z39 * z1984 - z41 * z1983;
    const Scalar z1990 = n2 * (z61 * z159 + z65 * z107) + s_yaw * z1988 - c_yaw * z1989;
    const Scalar z1991 = c_roll * z1987 - n2 * z62 * z106;
    const Scalar z1992 = -n2 * (z138 * z160 - z141 * z158) + z109 * z1990 + z110 * z1991;
    const Scalar z1993 = n2 * (z61 * z107 - z65 * z159) + s_yaw * z1989 + c_yaw * z1988;
    const Scalar z1994 = -n2 * (z138 * z162 + z143 * z158) + z109 * z1993 - z111 * z1991;
    const Scalar z1995 = n2 * z109 * z1991 - n4 * z138 * z158;
    const Scalar z1996 = n2 * (z112 * z1992 - z113 * z1994 - z114 * z1995) + n4 * (z142 * z161 - z144 * z163 - z145
        * z164);
    const Scalar z1997 = n0_5 * (z146 * z166 / (z116 * z116) + z147 * z165 / (z116 * z116) - z1996 / z116);
    const Scalar z1998 = z1986 + n0_35 * z1997;
    const Scalar z1999 = n2 * (z126 * z133 - z130 * z131) + s_pitch * z199 + c_pitch * z197 + z95 * z201 + z96 * z200;
    const Scalar z2000 = c_roll * z1999 - n2 * z62 * z277 + z80 * z97;
    const Scalar z2001 = s_roll * z206 - n2 * z60 * z140 + z83 * z106;
    const Scalar z2002 = -n2 * (z61 * z1973 + z65 * z137) + s_yaw * z2001 - c_yaw * z204 + z81 * z159 - z85 * z107;
    const Scalar z2003 = c_roll * z206 + n2 * z62 * z140 + z80 * z106;
    const Scalar z2004 = n2 * (z138 * z1974 - z141 * z1975) + z109 * z2002 + z110 * z2003 + z158 * z207 + z160 * z208;
    const Scalar z2005 = -n2 * (z61 * z137 - z65 * z1973) + s_yaw * z204 + c_yaw * z2001 + z81 * z107 + z85 * z159;
    const Scalar z2006 = n2 * (z138 * z1977 + z143 * z1975) + z109 * z2005 - z111 * z2003 - z158 * z210 + z162 * z208;
    const Scalar z2007 = n2 * (z109 * z2003 + z158 * z208) + n4 * z138 * z1975;
    const Scalar z2008 = n2 * (z112 * z2004 - z113 * z2006 - z114 * z2007 + z161 * z209 - z163 * z211 + z164 * z212)
        - n4 * (z142 * z1976 - z144 * z1978 - z145 * z1979);
    const Scalar z2009 = n0_5 * (z146 * z1981 / (z116 * z116) - z147 * z1980 / (z116 * z116) + z166 * z213 / (z116
        * z116) - z2008 / z116) + z146 * z147 * z166 / (z116 * z116 * z116);
    const Scalar z2010 = z2000 - n0_35 * z2009;
    const Scalar z2011 = a_roll * z1616 + a_pitch * z1632 + a_steer * z1648 + z2010;
    const Scalar z2012 = v_yaw * z1594 + v_roll * z1618 + v_pitch * z1633 - v_steer * z1657 - v_front * z1666;
    const Scalar z2013 = v_yaw * z1594 + v_roll * z1618 + v_pitch * z1633 - v_steer * z1657 - v_front * z1666 + z287;
    const Scalar z2014 = n0_7 * z147 * z166 / (z116 * z116 * z116) + n0_35 * z1981 / (z116 * z116);
    const Scalar z2015 = s_roll * z277 - z60 * z97;
    const Scalar z2016 = s_yaw * z134 - c_yaw * z2015 - z61 * z98 - z65 * z1444;
    const Scalar z2017 = z113 * z2014 - z117 * z1978 - z144 * z1591 + z163 * z281 + z2016;
    const Scalar z2018 = z114 * z2014 - z117 * z1979 - z145 * z1591 + z164 * z281 - z1972;
    const Scalar z2019 = s_yaw * z2018 - z61 * z1617;
    const Scalar z2020 = s_roll * z2017 + z49 * z2018 - z60 * z1594 + z66 * z1617;
    const Scalar z2021 = s_roll * z290 + z60 * z255;
    const Scalar z2022 = s_yaw * z291 - c_yaw * z2021 + z61 * z256 + z65 * z1650;
    const Scalar z2023 = z2017 + z2022;
    const Scalar z2024 = c_roll * z290 - z62 * z255;
    const Scalar z2025 = z2018 - z2024;
    const Scalar z2026 = c_roll * z296 + z62 * z249;
    const Scalar z2027 = s_roll * z296 - z60 * z249;
    const Scalar z2028 = s_yaw * z288 + c_yaw * z2027 + z61 * z250 + z65 * z1653;
    const Scalar z2029 = z252 * z2023 - z254 * z2025 - z265 * z2026 - z266 * z2028 - z289 * z1652 + z295 * z1649 - z298
        * z1656 + z301 * z1654;
    const Scalar z2030 = z2016 - z2017;
    const Scalar z2031 = z1972 + z2018;
    const Scalar z2032 = z109 * z2030 - z111 * z2031 + z138 * z1664 + z143 * z1665 - z158 * z303 - z162 * z304 - z271
        * z1975 - z272 * z1977;
    const Scalar z2033 = v_yaw * z2017 + v_roll * z2019 + v_pitch * z2020 - v_steer * z2029 - v_front * z2032;
    const Scalar z2034 = a_yaw * z1594 + a_roll * z1618 + a_pitch * z1633 - a_steer * z1657 - a_front * z1666 - z2033;
    const Scalar z2035 = v_yaw * z1592 + v_roll * z1619 + v_pitch * z1634 - v_steer * z1661 - v_front * z1668;
    const Scalar z2036 = v_yaw * z1592 + v_roll * z1619 + v_pitch * z1634 - v_steer * z1661 - v_front * z1668 + z313;
    const Scalar z2037 = s_yaw * z2015 + c_yaw * z134 - z61 * z1444 + z65 * z98;
    const Scalar z2038 = z112 * z2014 + z117 * z1976 - z142 * z1591 - z161 * z281 + z2037;
    const Scalar z2039 = c_yaw * z2018 + z65 * z1617;
    const Scalar z2040 = s_roll * z2038 - z48 * z2018 - z60 * z1592 - z63 * z1617;
    const Scalar z2041 = s_yaw * z2021 + c_yaw * z291 + z61 * z1650 - z65 * z256;
    const Scalar z2042 = z2038 + z2041;
    const Scalar z2043 = s_yaw * z2027 - c_yaw * z288 - z61 * z1653 + z65 * z250;
    const Scalar z2044 = z252 * z2042 + z253 * z2025 - z264 * z2026 + z266 * z2043 - z289 * z1659 + z301 * z1660 + z316
        * z1649 - z317 * z1656;
    const Scalar z2045 = z2037 - z2038;
    const Scalar z2046 = z109 * z2045 - z110 * z2031 + z138 * z1667 + z141 * z1665 - z158 * z319 + z160 * z304 - z270
        * z1975 + z272 * z1974;
    const Scalar z2047 = v_yaw * z2038 + v_roll * z2039 + v_pitch * z2040 - v_steer * z2044 - v_front * z2046;
    const Scalar z2048 = a_yaw * z1592 + a_roll * z1619 + a_pitch * z1634 - a_steer * z1661 - a_front * z1668 - z2047;
    const Scalar z2049 = z32 * z127;
    const Scalar z2050 = z31 * z127;
    const Scalar z2051 = n0_08 * z2049 - n0_35 * z2050;
    const Scalar z2052 = -z122 * (n1 - z31 * z31);
    const Scalar z2053 = z31 * z32 * z122;
    const Scalar z2054 = n0_08 * z2052 + n0_35 * z2053;
    const Scalar z2055 = -z122 * (n1 - z32 * z32);
    const Scalar z2056 = n0_08 * z2053 + n0_35 * z2055;
    const Scalar z2057 = s_pitch * z2054 - c_pitch * z2056 + z126 * z173 + z131 * z175;
    const Scalar z2058 = s_roll * z2051 + c_roll * z2057 - z60 * z170 - z62 * z176;
    const Scalar z2059 = s_pitch * z2049 + c_pitch * z2050 - z126 * z168 + z131 * z169;
    const Scalar z2060 = s_roll * z2059 - c_roll * z122 + s_steer * z62 - z60 * z178;
    const Scalar z2061 = s_pitch * z2050 - c_pitch * z2049 - z126 * z169 - z131 * z168;
    const Scalar z2062 = s_yaw * z2060 + c_yaw * z2061 - z61 * z180 + z65 * z181;
    const Scalar z2063 = s_roll * z122 + c_roll * z2059 + s_steer * z60 + z62 * z178;
    const Scalar z2064 = z109 * z2062 + z110 * z2063 + z138 * z182 + z141 * z179;
    const Scalar z2065 = s_yaw * z2061 - c_yaw * z2060 - z61 * z181 - z65 * z180;
    const Scalar z2066 = z109 * z2065 + z111 * z2063 + z138 * z184 + z143 * z179;
    const Scalar z2067 = n2 * (z109 * z2063 - z138 * z179);
    const Scalar z2068 = n2 * (z112 * z2064 + z113 * z2066 - z114 * z2067 - z142 * z183 - z144 * z185 - z145 * z186);
    const Scalar z2069 = n0_5 * (z146 * z188 / (z116 * z116) + z2068 / z116);
    const Scalar z2070 = z2058 - n0_35 * z2069;
    const Scalar z2071 = v_steer * s_steer + z127;
    const Scalar z2072 = z32 * z2071;
    const Scalar z2073 = z31 * z2071;
    const Scalar z2074 = n0_08 * z2072 - n0_35 * z2073;
    const Scalar z2075 = v_steer * c_steer + z122;
    const Scalar z2076 = -z2075 * (n1 - z31 * z31);
    const Scalar z2077 = z31 * z32 * z2075;
    const Scalar z2078 = n0_08 * z2076 + n0_35 * z2077;
    const Scalar z2079 = -z2075 * (n1 - z32 * z32);
    const Scalar z2080 = n0_08 * z2077 + n0_35 * z2079;
    const Scalar z2081 = n2 * (z126 * z173 + z131 * z175) + s_pitch * z2078 - c_pitch * z2080;
    const Scalar z2082 = -n2 * (z60 * z170 + z62 * z176) + s_roll * z2074 + c_roll * z2081;
    const Scalar z2083 = -n2 * (z126 * z168 - z131 * z169) + s_pitch * z2072 + c_pitch * z2073;
    const Scalar z2084 = n2 * (s_steer * z62 - z60 * z178) + s_roll * z2083 - c_roll * z2075;
    const Scalar z2085 = -n2 * (z126 * z169 + z131 * z168) + s_pitch * z2073 - c_pitch * z2072;
    const Scalar z2086 = -n2 * (z61 * z180 - z65 * z181) + s_yaw * z2084 + c_yaw * z2085;
    const Scalar z2087 = n2 * (s_steer * z60 + z62 * z178) + s_roll * z2075 + c_roll * z2083;
    const Scalar z2088 = n2 * (z138 * z182 + z141 * z179) + z109 * z2086 + z110 * z2087;
    const Scalar z2089 = -n2 * (z61 * z181 + z65 * z180) + s_yaw * z2085 - c_yaw * z2084;
    const Scalar z2090 = n2 * (z138 * z184 + z143 * z179) + z109 * z2089 + z111 * z2087;
    const Scalar z2091 = n2 * z109 * z2087 - n4 * z138 * z179;
    const Scalar z2092 = n2 * (z112 * z2088 + z113 * z2090 - z114 * z2091) - n4 * (z142 * z183 + z144 * z185 + z145
        * z186);
    const Scalar z2093 = n0_5 * (z146 * z188 / (z116 * z116) + z147 * z187 / (z116 * z116) + z2092 / z116);
    const Scalar z2094 = z2082 - n0_35 * z2093;
    const Scalar z2095 = z32 * z194;
    const Scalar z2096 = z31 * z194;
    const Scalar z2097 = n0_08 * z2095 - n0_35 * z2096;
    const Scalar z2098 = -z190 * (n1 - z31 * z31);
    const Scalar z2099 = z31 * z32 * z190;
    const Scalar z2100 = n0_08 * z2098 + n0_35 * z2099;
    const Scalar z2101 = -z190 * (n1 - z32 * z32);
    const Scalar z2102 = n0_08 * z2099 + n0_35 * z2101;
    const Scalar z2103 = -n2 * (z126 * z2054 + z131 * z2056) + s_pitch * z2100 - c_pitch * z2102 + z173 * z200 - z175
        * z201;
    const Scalar z2104 = n2 * (z60 * z2051 - z62 * z2057) + s_roll * z2097 - c_roll * z2103 - z80 * z176 + z83 * z170;
    const Scalar z2105 = n2 * (z126 * z2049 - z131 * z2050) + s_pitch * z2095 + c_pitch * z2096 + z168 * z200 + z169
        * z201;
    const Scalar z2106 = n2 * (z60 * z2059 + z62 * z122) + s_roll * z2105 + c_roll * z190 + s_steer * z80 + z83 * z178;
    const Scalar z2107 = n2 * (z126 * z2050 + z131 * z2049) + s_pitch * z2096 - c_pitch * z2095 - z168 * z201 + z169
        * z200;
    const Scalar z2108 = n2 * (z61 * z2060 - z65 * z2061) + s_yaw * z2106 + c_yaw * z2107 + z81 * z180 + z85 * z181;
    const Scalar z2109 = -n2 * (z60 * z122 - z62 * z2059) + s_roll * z190 - c_roll * z2105 + s_steer * z83 - z80 * z178;
    const Scalar z2110 = -n2 * (z138 * z2062 - z141 * z2063) + z109 * z2108 - z110 * z2109 - z179 * z207 + z182 * z208;
    const Scalar z2111 = n2 * (z61 * z2061 + z65 * z2060) + s_yaw * z2107 - c_yaw * z2106 + z81 * z181 - z85 * z180;
    const Scalar z2112 = -n2 * (z138 * z2065 - z143 * z2063) + z109 * z2111 - z111 * z2109 - z179 * z210 + z184 * z208;
    const Scalar z2113 = n2 * (z109 * z2109 + z179 * z208) + n4 * z138 * z2063;
    const Scalar z2114 = n2 * (z112 * z2110 + z113 * z2112 + z114 * z2113 + z183 * z209 + z185 * z211 - z186 * z212)
        + n4 * (z142 * z2064 + z144 * z2066 - z145 * z2067);
    const Scalar z2115 = n0_5 * (z146 * z2069 / (z116 * z116) + z147 * z2068 / (z116 * z116) + z188 * z213 / (z116
        * z116) - z2114 / z116) + z146 * z147 * z188 / (z116 * z116 * z116);
    const Scalar z2116 = z2104 + n0_35 * z2115;
    const Scalar z2117 = a_roll * z1767 - a_pitch * z1774 - a_steer * z1791 - z2116;
    const Scalar z2118 = v_yaw * z1746 + v_roll * z1769 + v_pitch * z1775 - v_steer * z1792 + v_front * z1798;
    const Scalar z2119 = v_yaw * z1746 + v_roll * z1769 + v_pitch * z1775 - v_steer * z1792 + v_front * z1798 - z302;
    const Scalar z2120 = n0_7 * z147 * z188 / (z116 * z116 * z116) + n0_35 * z2069 / (z116 * z116);
    const Scalar z2121 = s_pitch * z2056 + c_pitch * z2054 + z126 * z175 - z131 * z173;
    const Scalar z2122 = s_roll * z2057 - c_roll * z2051 + z60 * z176 - z62 * z170;
    const Scalar z2123 = s_yaw * z2121 + c_yaw * z2122 + z61 * z1637 - z65 * z1459;
    const Scalar z2124 = z113 * z2120 - z117 * z2066 - z144 * z1743 - z185 * z281 + z2123;
    const Scalar z2125 = z114 * z2120 + z117 * z2067 - z145 * z1743 - z186 * z281 + z2058;
    const Scalar z2126 = s_yaw * z2125 - z61 * z1768;
    const Scalar z2127 = s_roll * z2124 + z49 * z2125 - z60 * z1746 + z66 * z1768;
    const Scalar z2128 = z252 * z2124 - z254 * z2125 - z289 * z1746 - z298 * z1768;
    const Scalar z2129 = z2123 - z2124;
    const Scalar z2130 = z2058 - z2125;
    const Scalar z2131 = z109 * z2129 + z111 * z2130 - z138 * z1796 - z143 * z1797 + z179 * z303 + z184 * z304 + z271
        * z2063 - z272 * z2065;
    const Scalar z2132 = v_yaw * z2124 + v_roll * z2126 + v_pitch * z2127 - v_steer * z2128 - v_front * z2131;
    const Scalar z2133 = a_yaw * z1746 + a_roll * z1769 + a_pitch * z1775 - a_steer * z1792 + a_front * z1798 - z2132;
    const Scalar z2134 = v_yaw * z1744 + v_roll * z1770 + v_pitch * z1776 - v_steer * z1793 - v_front * z1800;
    const Scalar z2135 = v_yaw * z1744 + v_roll * z1770 + v_pitch * z1776 - v_steer * z1793 - v_front * z1800 - z318;
    const Scalar z2136 = s_yaw * z2122 - c_yaw * z2121 + z61 * z1459 + z65 * z1637;
    const Scalar z2137 = z112 * z2120 - z117 * z2064 - z142 * z1743 - z183 * z281 - z2136;
    const Scalar z2138 = c_yaw * z2125 + z65 * z1768;
    const Scalar z2139 = s_roll * z2137 - z48 * z2125 - z60 * z1744 - z63 * z1768;
    const Scalar z2140 = z252 * z2137 + z253 * z2125 - z289 * z1744 - z317 * z1768;
    const Scalar z2141 = z2136 + z2137;
    const Scalar z2142 = z109 * z2141 - z110 * z2130 - z138 * z1799 + z141 * z1797 - z179 * z319 - z182 * z304 - z270
        * z2063 + z272 * z2062;
    const Scalar z2143 = v_yaw * z2137 + v_roll * z2138 + v_pitch * z2139 - v_steer * z2140 + v_front * z2142;
    const Scalar z2144 = a_yaw * z1744 + a_roll * z1770 + a_pitch * z1776 - a_steer * z1793 - a_front * z1800 - z2143;
    const Scalar z2145 = n1 / z167;
    const Scalar z2146 = z246 * z2145;
    const Scalar z2147 = z223 * z2145;
    const Scalar z2148 = z247 * z2145;
    const Scalar z2149 = z222 * z2145;
    const Scalar z2150 = n1 / z273;
    const Scalar z2151 = z274 * z2150;
    const Scalar z2152 = z240 - z241 * z2151;
    const Scalar z2153 = z216 - z2152;
    const Scalar z2154 = n1 / z2153;
    const Scalar z2155 = z217 * z2154;
    const Scalar z2156 = n1 - z2151 * z2155;
    const Scalar z2157 = n1 / z2156;
    const Scalar z2158 = z167 * z167;
    const Scalar z2159 = n1_over_94 + z156 * z156 / z538 + z167 * z167 / z516 + z189 * z189 / z450;
    const Scalar z2160 = z516 * z2159;
    const Scalar z2161 = z273 * z273;
    const Scalar z2162 = n1_over_94 + z241 * z241 / z558 + z243 * z243 / z538 + z246 * z246 / z516 + z267 * z267 / z450
        + n25_over_7 * z273 * z273;
    const Scalar z2163 = n0_28 * z2162;
    const Scalar z2164 = z2153 * z2153;
    const Scalar z2165 = n1_over_94 + z240 * z240 / z558 + z244 * z244 / z538 + z247 * z247 / z516 + z268 * z268 / z450
        + n25_over_7 * z274 * z274;
    const Scalar z2166 = z558 * z2165;
    const Scalar z2167 = z2156 * z2156;
    const Scalar z2168 = z222 * z222 * (n25_over_3 + n1 / z516) + n1_over_94 + z217 * z217 / z558 + z219 * z219 / z538;
    const Scalar z2169 = n94 * z2168;
    const Scalar z2170 = z79 + z156;
    const Scalar z2171 = z2145 * z2170;
    const Scalar z2172 = z189 * z2145;
    const Scalar z2173 = z243 - z2146 * z2170;
    const Scalar z2174 = z220 - z2147 * z2170;
    const Scalar z2175 = z244 - z2148 * z2170 - z2151 * z2173 - z2174;
    const Scalar z2176 = z219 - z2149 * z2170 + z2155 * z2175;
    const Scalar z2177 = z2157 * z2176;
    const Scalar z2178 = z2151 * z2177 + z2175;
    const Scalar z2179 = z2154 * z2178;
    const Scalar z2180 = z216 * z2179 + z2174;
    const Scalar z2181 = z241 * z2179 + z2173 - z2177;
    const Scalar z2182 = z2150 * z2181;
    const Scalar z2183 = z189 * z2146 - z267;
    const Scalar z2184 = z189 * z2147;
    const Scalar z2185 = z189 * z2148 - z268 - z2151 * z2183 - z2184;
    const Scalar z2186 = z189 * z2149 + z2155 * z2185;
    const Scalar z2187 = z2157 * z2186;
    const Scalar z2188 = z2151 * z2187 + z2185;
    const Scalar z2189 = z2154 * z2188;
    const Scalar z2190 = z216 * z2189 + z2184;
    const Scalar z2191 = z241 * z2189 + z2183 - z2187;
    const Scalar z2192 = z2150 * z2191;
    const Scalar z2193 = z222 - z223 * z2155;
    const Scalar z2194 = z2157 * z2193;
    const Scalar z2195 = z223 - z2151 * z2194;
    const Scalar z2196 = z2154 * z2195;
    const Scalar z2197 = z216 * z2196 - z223;
    const Scalar z2198 = z241 * z2196 + z2194;
    const Scalar z2199 = z2150 * z2198;
    const Scalar z2200 = z1902 - z1982 * z2171;
    const Scalar z2201 = z1982 * z2172 - z2070;
    const Scalar z2202 = z1924 + z2012 * z2171;
    const Scalar z2203 = z2012 * z2172 + z2118;
    const Scalar z2204 = z1951 + z2035 * z2171;
    const Scalar z2205 = z2035 * z2172 + z2134;
    const Scalar z2206 = z1836 * z2151 - z1846 - z1852;
    const Scalar z2207 = z1862 + z2155 * z2206;
    const Scalar z2208 = z2157 * z2207;
    const Scalar z2209 = z2151 * z2208 + z2206;
    const Scalar z2210 = z2154 * z2209;
    const Scalar z2211 = z216 * z2210 + z1846;
    const Scalar z2212 = z241 * z2210 - z1836 - z2208;
    const Scalar z2213 = z2150 * z2212;
    const Scalar z2214 = z1875 - z2200;
    const Scalar z2215 = z2146 * z2214 + z2202;
    const Scalar z2216 = z1942 - z2147 * z2214;
    const Scalar z2217 = z2148 * z2214 - z2151 * z2215 + z2204 + z2216;
    const Scalar z2218 = z1965 + z2149 * z2214 + z2155 * z2217;
    const Scalar z2219 = z2157 * z2218;
    const Scalar z2220 = z2151 * z2219 + z2217;
    const Scalar z2221 = z2154 * z2220;
    const Scalar z2222 = z216 * z2221 - z2216;
    const Scalar z2223 = z241 * z2221 + z2215 - z2219;
    const Scalar z2224 = z2150 * z2223;
    const Scalar z2225 = z2145 * z2214;
    const Scalar z2226 = z2146 * z2201 + z2203;
    const Scalar z2227 = z2147 * z2201;
    const Scalar z2228 = z2148 * z2201 - z2151 * z2226 + z2205 - z2227;
    const Scalar z2229 = z2149 * z2201 + z2155 * z2228;
    const Scalar z2230 = z2157 * z2229;
    const Scalar z2231 = z2151 * z2230 + z2228;
    const Scalar z2232 = z2154 * z2231;
    const Scalar z2233 = z216 * z2232 + z2227;
    const Scalar z2234 = z241 * z2232 + z2226 - z2230;
    const Scalar z2235 = z2150 * z2234;
    const Scalar z2236 = z2145 * z2201;
    const Scalar z2237 = z1913 - z1998 * z2171;
    const Scalar z2238 = z1998 * z2172 - z2094;
    const Scalar z2239 = z232 * z2171 + z1863 * z2179 + z1966;
    const Scalar z2240 = z232 * z2172 - z1863 * z2189;
    const Scalar z2241 = z232 + z1863 * z2196;
    const Scalar z2242 = z238 * z2171 + z1847 * z2179 - z1943;
    const Scalar z2243 = z238 * z2172 - z1847 * z2189;
    const Scalar z2244 = z238 + z1847 * z2196;
    const Scalar z2245 = z305 * z2182 - z1837 * z2179 + z1925 + z2013 * z2171;
    const Scalar z2246 = z305 * z2192 - z1837 * z2189 - z2013 * z2172 - z2119;
    const Scalar z2247 = z305 * z2199 - z1837 * z2196;
    const Scalar z2248 = z320 * z2182 - z1853 * z2179 + z1952 + z2036 * z2171;
    const Scalar z2249 = z320 * z2192 - z1853 * z2189 - z2036 * z2172 - z2135;
    const Scalar z2250 = z320 * z2199 - z1853 * z2196;
    const Scalar z2251 = z1885 - z2237;
    const Scalar z2252 = z2146 * z2251 + z2245;
    const Scalar z2253 = z2147 * z2251 + z2242;
    const Scalar z2254 = z2148 * z2251 - z2151 * z2252 + z2248 - z2253;
    const Scalar z2255 = z2149 * z2251 + z2155 * z2254 + z2239;
    const Scalar z2256 = z2157 * z2255;
    const Scalar z2257 = z2151 * z2256 + z2254;
    const Scalar z2258 = z2154 * z2257;
    const Scalar z2259 = z216 * z2258 + z2253;
    const Scalar z2260 = z241 * z2258 + z2252 - z2256;
    const Scalar z2261 = z2150 * z2260;
    const Scalar z2262 = z2145 * z2251;
    const Scalar z2263 = z2146 * z2238 - z2246;
    const Scalar z2264 = z2147 * z2238 + z2243;
    const Scalar z2265 = z2148 * z2238 - z2151 * z2263 - z2249 - z2264;
    const Scalar z2266 = z2149 * z2238 + z2155 * z2265 + z2240;
    const Scalar z2267 = z2157 * z2266;
    const Scalar z2268 = z2151 * z2267 + z2265;
    const Scalar z2269 = z2154 * z2268;
    const Scalar z2270 = z216 * z2269 + z2264;
    const Scalar z2271 = z241 * z2269 + z2263 - z2267;
    const Scalar z2272 = z2150 * z2271;
    const Scalar z2273 = z2145 * z2238;
    const Scalar z2274 = z2151 * z2247 + z2244 - z2250;
    const Scalar z2275 = z2155 * z2274 - z2241;
    const Scalar z2276 = z2157 * z2275;
    const Scalar z2277 = z2151 * z2276 + z2274;
    const Scalar z2278 = z2154 * z2277;
    const Scalar z2279 = z216 * z2278 - z2244;
    const Scalar z2280 = z241 * z2278 - z2247 - z2276;
    const Scalar z2281 = z2150 * z2280;
    const Scalar z2282 = z1998 * z2225;
    const Scalar z2283 = z1998 * z2236;
    const Scalar z2284 = z1863 * z2210;
    const Scalar z2285 = z232 * z2225 - z1863 * z2221;
    const Scalar z2286 = z232 * z2236 - z1863 * z2232;
    const Scalar z2287 = z1847 * z2210;
    const Scalar z2288 = z238 * z2225 - z1847 * z2221;
    const Scalar z2289 = z238 * z2236 - z1847 * z2232;
    const Scalar z2290 = z305 * z2213 - z1837 * z2210;
    const Scalar z2291 = z305 * z2224 - z1837 * z2221 - z2013 * z2225;
    const Scalar z2292 = z305 * z2235 - z1837 * z2232 - z2013 * z2236;
    const Scalar z2293 = z320 * z2213 - z1853 * z2210;
    const Scalar z2294 = z320 * z2224 - z1853 * z2221 - z2036 * z2225;
    const Scalar z2295 = z320 * z2235 - z1853 * z2232 - z2036 * z2236;
    const Scalar z2296 = z1923 + z2011 * z2171;
    const Scalar z2297 = z2011 * z2172 + z2117;
    const Scalar z2298 = z1941 + z2034 * z2171;
    const Scalar z2299 = z2034 * z2172 + z2133;
    const Scalar z2300 = z1964 + z2048 * z2171;
    const Scalar z2301 = z2048 * z2172 + z2144;
    const Scalar z2302 = z2282 + z2296;
    const Scalar z2303 = z2283 + z2297;
    const Scalar z2304 = z1867 - z2284;
    const Scalar z2305 = z1971 + z2285;
    const Scalar z2306 = z1851 - z2287;
    const Scalar z2307 = z1950 - z2288;
    const Scalar z2308 = z1845 + z2290;
    const Scalar z2309 = z2291 - z2298;
    const Scalar z2310 = z2292 - z2299;
    const Scalar z2311 = z1861 + z2293;
    const Scalar z2312 = z2294 - z2300;
    const Scalar z2313 = z2295 - z2301;
    const Scalar z2314 = z2151 * z2308 - z2306 - z2311;
    const Scalar z2315 = z2155 * z2314 + z2304;
    const Scalar z2316 = z2157 * z2315;
    const Scalar z2317 = z2151 * z2316 + z2314;
    const Scalar z2318 = z2154 * z2317;
    const Scalar z2319 = z216 * z2318 + z2306;
    const Scalar z2320 = z241 * z2318 - z2308 - z2316;
    const Scalar z2321 = z2150 * z2320;
    const Scalar z2322 = z1894 + z2302;
    const Scalar z2323 = z2146 * z2322 - z2309;
    const Scalar z2324 = z2147 * z2322 - z2307;
    const Scalar z2325 = z2148 * z2322 - z2151 * z2323 - z2312 - z2324;
    const Scalar z2326 = z2149 * z2322 + z2155 * z2325 + z2305;
    const Scalar z2327 = z2157 * z2326;
    const Scalar z2328 = z2151 * z2327 + z2325;
    const Scalar z2329 = z2154 * z2328;
    const Scalar z2330 = z216 * z2329 + z2324;
    const Scalar z2331 = z241 * z2329 + z2323 - z2327;
    const Scalar z2332 = z2150 * z2331;
    const Scalar z2333 = z2145 * z2322;
    const Scalar z2334 = z2146 * z2303 - z2310;
    const Scalar z2335 = z2147 * z2303 + z2289;
    const Scalar z2336 = z2148 * z2303 - z2151 * z2334 - z2313 - z2335;
    const Scalar z2337 = z2149 * z2303 + z2155 * z2336 + z2286;
    const Scalar z2338 = z2157 * z2337;
    const Scalar z2339 = z2151 * z2338 + z2336;
    const Scalar z2340 = z2154 * z2339;
    const Scalar z2341 = z216 * z2340 + z2335;
    const Scalar z2342 = z241 * z2340 + z2334 - z2338;
    const Scalar z2343 = z2150 * z2342;
    const Scalar z2344 = z2145 * z2303;
    const Scalar z2345 = z1814 - z1815;
    const Scalar z2346 = z1816 - z2146 * z2345;
    const Scalar z2347 = z1817 + z2147 * z2345;
    const Scalar z2348 = z1818 + z2148 * z2345 + z2151 * z2346 - z2347;
    const Scalar z2349 = z1819 - z2149 * z2345 - z2155 * z2348;
    const Scalar z2350 = z2157 * z2349;
    const Scalar z2351 = z2151 * z2350 - z2348;
    const Scalar z2352 = z2154 * z2351;
    const Scalar z2353 = z216 * z2352 - z2347;
    const Scalar z2354 = z241 * z2352 + z2346 - z2350;
    const Scalar z2355 = z2150 * z2354;
    const Scalar z2356 = z2145 * z2345;
    const Scalar z2357 = z525 * z2171 - z544 - z559 * z2179 + n94 * z2177;
    const Scalar z2358 = z526 * z2171 - z545 - z560 * z2179 + n94 * z2180;
    const Scalar z2359 = n94 * z79 + z522 * z2171 + z541;
    const Scalar z2360 = z445 * z2182 + z524 * z2171 + z543 - z558 * z2179 + z559 * z2177 + z560 * z2180;
    const Scalar z2361 = z79 * z541 + z442 * z2182 + z519 * z2171 + z538 - z543 * z2179 - z544 * z2177 - z545 * z2180;
    const Scalar z2362 = z79 * z522 + z440 * z2182 + z516 * z2171 + z519 - z524 * z2179 + z525 * z2177 + z526 * z2180;
    const Scalar z2363 = z79 * z466 - z458 * z2171 + z463 + z468 * z2179 + z469 * z2177 - z470 * z2180;
    const Scalar z2364 = z513 * z2179 - n0_12 * z2171;
    const Scalar z2365 = z440 * z2171 + z442 - z445 * z2179 + n0_28 * z2182;
    const Scalar z2366 = z469 - z525 * z2172 - z559 * z2189 + n94 * z2187;
    const Scalar z2367 = z470 + z526 * z2172 + z560 * z2189 - n94 * z2190;
    const Scalar z2368 = z466 - z522 * z2172;
    const Scalar z2369 = z445 * z2192 - z468 - z524 * z2172 - z558 * z2189 + z559 * z2187 + z560 * z2190;
    const Scalar z2371 = z440 * z2192 - z458 - z516 * z2172 - z524 * z2189 + z525 * z2187 + z526 * z2190;
    const Scalar z2372 = z450 + z458 * z2172 + z468 * z2189 + z469 * z2187 - z470 * z2190;
    const Scalar z2373 = z513 * z2189 + n0_12 * z2172;
    const Scalar z2374 = z440 * z2172 + z445 * z2189 - n0_28 * z2192;
    const Scalar z2375 = z559 * z2196 + n94 * z2194;
    const Scalar z2376 = z560 * z2196 - n94 * z2197;
    const Scalar z2377 = z445 * z2199 + z513 - z558 * z2196 - z559 * z2194 + z560 * z2197;
    const Scalar z2379 = n0_12 + z440 * z2199 - z524 * z2196 - z525 * z2194 + z526 * z2197;
    const Scalar z2381 = n0_12 - z513 * z2196;
    const Scalar z2382 = z445 * z2196 - n0_28 * z2199;
    const Scalar z2383 = z79 * z2359 + z2171 * z2362 + z2177 * z2357 - z2179 * z2360 + z2180 * z2358 + z2182 * z2365
        + z2361;
    const Scalar z2384 = z2172 * z2362 - z2187 * z2357 + z2189 * z2360 - z2190 * z2358 - z2192 * z2365 - z2363;
    const Scalar z2385 = z2194 * z2357 + z2196 * z2360 - z2197 * z2358 - z2199 * z2365 + z2364;
    const Scalar z2387 = z2172 * z2371 - z2187 * z2366 + z2189 * z2369 + z2190 * z2367 + z2192 * z2374 - z2372;
    const Scalar z2388 = z2194 * z2366 + z2196 * z2369 + z2197 * z2367 + z2199 * z2374 + z2373;
    const Scalar z2391 = z2194 * z2375 - z2196 * z2377 - z2197 * z2376 - z2199 * z2382 + z2381;
    const Scalar z2392 = z1885 * z2359 - z2256 * z2357 + z2258 * z2360 - z2259 * z2358 - z2261 * z2365 + z2262 * z2362;
    const Scalar z2393 = z2267 * z2357 - z2269 * z2360 + z2270 * z2358 + z2272 * z2365 - z2273 * z2362;
    const Scalar z2394 = z2276 * z2357 - z2278 * z2360 + z2279 * z2358 + z2281 * z2365;
    const Scalar z2395 = z1885 * z2368 - z2256 * z2366 + z2258 * z2369 + z2259 * z2367 + z2261 * z2374 + z2262 * z2371;
    const Scalar z2396 = z2267 * z2366 - z2269 * z2369 - z2270 * z2367 - z2272 * z2374 - z2273 * z2371;
    const Scalar z2397 = z2276 * z2366 - z2278 * z2369 - z2279 * z2367 - z2281 * z2374;
    const Scalar z2398 = z2256 * z2375 + z2258 * z2377 + z2259 * z2376 + z2261 * z2382 + z2262 * z2379;
    const Scalar z2399 = z2267 * z2375 + z2269 * z2377 + z2270 * z2376 + z2272 * z2382 + z2273 * z2379;
    const Scalar z2400 = z2276 * z2375 + z2278 * z2377 + z2279 * z2376 + z2281 * z2382;
    const Scalar z2401 = z1160 * z2179 - z1297 - z1526 * z2171;
    const Scalar z2402 = z1160 * z2189 + z1526 * z2172 + z1685;
    const Scalar z2403 = z1160 * z2196;
    const Scalar z2404 = z1178 * z2179 - z1357 + z1567 * z2171;
    const Scalar z2405 = z1178 * z2189 - z1567 * z2172 + z1721;
    const Scalar z2406 = z1178 * z2196;
    const Scalar z2407 = z1359 + z1569 * z2171;
    const Scalar z2408 = z1569 * z2172 - z1723;
    const Scalar z2409 = z1205 * z2179 - z1384 + z1589 * z2171 + z1811 * z2182;
    const Scalar z2410 = z1205 * z2189 - z1589 * z2172 - z1741 + z1811 * z2192;
    const Scalar z2411 = z1205 * z2196 - z1803 + z1811 * z2199;
    const Scalar z2412 = z1224 * z2179 + z1419 - z1614 * z2171 + z1812 * z2182;
    const Scalar z2413 = z1224 * z2189 + z1614 * z2172 - z1765 + z1812 * z2192;
    const Scalar z2414 = z1224 * z2196 - z1804 + z1812 * z2199;
    const Scalar z2415 = z1194 * z2179 - z1373 + z1581 * z2171 + z1807 * z2182;
    const Scalar z2416 = z1194 * z2189 - z1581 * z2172 - z1735 + z1807 * z2192;
    const Scalar z2417 = z1194 * z2196 + z1807 * z2199;
    const Scalar z2418 = z1232 * z2179 + z1458 + z1636 * z2171 - z1813 * z2182;
    const Scalar z2419 = z1232 * z2189 - z1636 * z2172 - z1813 * z2192;
    const Scalar z2420 = z1232 * z2196 - z1813 * z2199;
    const Scalar z2421 = z1192 * z2179 - z1371;
    const Scalar z2422 = z1192 * z2189;
    const Scalar z2423 = z1192 * z2196;
    const Scalar z2424 = z1182 * z2179 + z1361 - z1571 * z2171;
    const Scalar z2425 = z1182 * z2189 + z1571 * z2172 + z1725;
    const Scalar z2426 = z1182 * z2196;
    const Scalar z2427 = z79 * z2407 - z2171 * z2415 - z2177 * z2401 + z2179 * z2409 - z2180 * z2404 + z2182 * z2424
        - z2412;
    const Scalar z2428 = z79 * z2408 + z2171 * z2416 + z2177 * z2402 - z2179 * z2410 + z2180 * z2405 - z2182 * z2425
        + z2413;
    const Scalar z2429 = z2171 * z2417 + z2177 * z2403 - z2179 * z2411 + z2180 * z2406 - z2182 * z2426 + z2414;
    const Scalar z2430 = z2172 * z2415 - z2187 * z2401 + z2189 * z2409 - z2190 * z2404 + z2192 * z2424 + z2418;
    const Scalar z2431 = z2172 * z2416 - z2187 * z2402 + z2189 * z2410 - z2190 * z2405 + z2192 * z2425 + z2419;
    const Scalar z2432 = z2172 * z2417 - z2187 * z2403 + z2189 * z2411 - z2190 * z2406 + z2192 * z2426 + z2420;
    const Scalar z2433 = z2194 * z2401 + z2196 * z2409 - z2197 * z2404 + z2199 * z2424 - z2421;
    const Scalar z2434 = z2194 * z2402 + z2196 * z2410 - z2197 * z2405 + z2199 * z2425 - z2422;
    const Scalar z2435 = z2194 * z2403 + z2196 * z2411 - z2197 * z2406 + z2199 * z2426 - z2423;
    const Scalar z2436 = z2392 + z2427;
    const Scalar z2437 = z2393 - z2428;
    const Scalar z2438 = z2394 - z2429;
    const Scalar z2439 = z2395 + z2430;
    const Scalar z2440 = z2396 + z2431;
    const Scalar z2441 = z2397 + z2432;
    const Scalar z2442 = z2398 + z2433;
    const Scalar z2443 = z2399 - z2434;
    const Scalar z2444 = z2400 - z2435;
    const Scalar z2445 = z2316 * z2357 - z2318 * z2360 + z2319 * z2358 + z2321 * z2365;
    const Scalar z2446 = z1894 * z2359 - z2327 * z2357 + z2329 * z2360 - z2330 * z2358 - z2332 * z2365 + z2333 * z2362;
    const Scalar z2447 = z2338 * z2357 - z2340 * z2360 + z2341 * z2358 + z2343 * z2365 - z2344 * z2362;
    const Scalar z2448 = z2316 * z2366 - z2318 * z2369 - z2319 * z2367 - z2321 * z2374;
    const Scalar z2449 = z1894 * z2368 - z2327 * z2366 + z2329 * z2369 + z2330 * z2367 + z2332 * z2374 + z2333 * z2371;
    const Scalar z2450 = z2338 * z2366 - z2340 * z2369 - z2341 * z2367 - z2343 * z2374 - z2344 * z2371;
    const Scalar z2451 = z2316 * z2375 + z2318 * z2377 + z2319 * z2376 + z2321 * z2382;
    const Scalar z2452 = z2327 * z2375 + z2329 * z2377 + z2330 * z2376 + z2332 * z2382 + z2333 * z2379;
    const Scalar z2453 = z2338 * z2375 + z2340 * z2377 + z2341 * z2376 + z2343 * z2382 + z2344 * z2379;
    const Scalar z2454 = z1160 * z2210;
    const Scalar z2455 = z1160 * z2221 + z1526 * z2225;
    const Scalar z2456 = z1160 * z2232 + z1526 * z2236;
    const Scalar z2457 = z1178 * z2210;
    const Scalar z2458 = z1178 * z2221 - z1567 * z2225;
    const Scalar z2459 = z1178 * z2232 - z1567 * z2236;
    const Scalar z2460 = z1569 * z2225;
    const Scalar z2461 = z1569 * z2236;
    const Scalar z2462 = z1205 * z2210 + z1811 * z2213;
    const Scalar z2463 = z1205 * z2221 - z1589 * z2225 + z1811 * z2224;
    const Scalar z2464 = z1205 * z2232 - z1589 * z2236 + z1811 * z2235;
    const Scalar z2465 = z1224 * z2210 + z1812 * z2213;
    const Scalar z2466 = z1224 * z2221 + z1614 * z2225 + z1812 * z2224;
    const Scalar z2467 = z1224 * z2232 + z1614 * z2236 + z1812 * z2235;
    const Scalar z2468 = z1194 * z2210 + z1807 * z2213;
    const Scalar z2469 = z1194 * z2221 - z1581 * z2225 + z1807 * z2224;
    const Scalar z2470 = z1194 * z2232 - z1581 * z2236 + z1807 * z2235;
    const Scalar z2471 = z1232 * z2210 - z1813 * z2213;
    const Scalar z2472 = z1232 * z2221 - z1636 * z2225 - z1813 * z2224;
    const Scalar z2473 = z1232 * z2232 - z1636 * z2236 - z1813 * z2235;
    const Scalar z2474 = z1192 * z2210;
    const Scalar z2475 = z1192 * z2221;
    const Scalar z2476 = z1192 * z2232;
    const Scalar z2477 = z1182 * z2210;
    const Scalar z2478 = z1182 * z2221 + z1571 * z2225;
    const Scalar z2479 = z1182 * z2232 + z1571 * z2236;
    const Scalar z2480 = z1356 - z1566 * z2171;
    const Scalar z2481 = z1566 * z2172 + z1720;
    const Scalar z2482 = z1358 + z1568 * z2171;
    const Scalar z2483 = z1568 * z2172 + z1722;
    const Scalar z2484 = z1360 + z1570 * z2171;
    const Scalar z2485 = z1570 * z2172 + z1724;
    const Scalar z2486 = z1418 + z1613 * z2171;
    const Scalar z2487 = z1613 * z2172 + z1764;
    const Scalar z2488 = z1443 - z1621 * z2171;
    const Scalar z2489 = z1621 * z2172 + z1772;
    const Scalar z2490 = z1457 + z1635 * z2171;
    const Scalar z2491 = z1635 * z2172 - z1777;
    const Scalar z2492 = z1478 - z1663 * z2171;
    const Scalar z2493 = z1663 * z2172 - z1795;
    const Scalar z2494 = z1485 + z1669 * z2171;
    const Scalar z2495 = z1669 * z2172 - z1801;
    const Scalar z2496 = z1177 + z2454;
    const Scalar z2497 = z2455 + z2480;
    const Scalar z2498 = z2456 - z2481;
    const Scalar z2499 = z1179 + z2457;
    const Scalar z2500 = z2458 - z2482;
    const Scalar z2501 = z2459 - z2483;
    const Scalar z2502 = z2460 - z2484;
    const Scalar z2503 = z2461 - z2485;
    const Scalar z2504 = z1221 - z2462;
    const Scalar z2505 = z2463 - z2486;
    const Scalar z2506 = z2464 - z2487;
    const Scalar z2507 = z1226 + z2465;
    const Scalar z2508 = z2466 - z2488;
    const Scalar z2509 = z2467 + z2489;
    const Scalar z2510 = z1231 - z2468;
    const Scalar z2511 = z2469 + z2490;
    const Scalar z2512 = z2470 + z2491;
    const Scalar z2513 = z1238 - z2471;
    const Scalar z2514 = z2472 + z2492;
    const Scalar z2515 = z2473 - z2493;
    const Scalar z2516 = z1239 - z2474;
    const Scalar z2517 = z1479 - z2475;
    const Scalar z2518 = z1244 + z2477;
    const Scalar z2519 = z2478 - z2494;
    const Scalar z2520 = z2479 - z2495;
    const Scalar z2521 = z2171 * z2510 - z2177 * z2496 - z2179 * z2504 - z2180 * z2499 + z2182 * z2518 - z2507;
    const Scalar z2522 = z79 * z2502 + z2171 * z2511 + z2177 * z2497 - z2179 * z2505 + z2180 * z2500 - z2182 * z2519
        + z2508;
    const Scalar z2523 = z79 * z2503 + z2171 * z2512 + z2177 * z2498 - z2179 * z2506 + z2180 * z2501 - z2182 * z2520
        + z2509;
    const Scalar z2524 = z2172 * z2510 + z2187 * z2496 + z2189 * z2504 + z2190 * z2499 - z2192 * z2518 + z2513;
    const Scalar z2525 = z2172 * z2511 - z2187 * z2497 + z2189 * z2505 - z2190 * z2500 + z2192 * z2519 + z2514;
    const Scalar z2526 = z2172 * z2512 - z2187 * z2498 + z2189 * z2506 - z2190 * z2501 + z2192 * z2520 + z2515;
    const Scalar z2527 = z2194 * z2496 - z2196 * z2504 - z2197 * z2499 + z2199 * z2518 + z2516;
    const Scalar z2528 = z2194 * z2497 + z2196 * z2505 - z2197 * z2500 + z2199 * z2519 + z2517;
    const Scalar z2529 = z2194 * z2498 + z2196 * z2506 - z2197 * z2501 + z2199 * z2520 - z2476;
    const Scalar z2530 = z2445 + z2521;
    const Scalar z2531 = z2446 + z2522;
    const Scalar z2532 = z2447 - z2523;
    const Scalar z2533 = z2448 - z2524;
    const Scalar z2534 = z2449 - z2525;
    const Scalar z2535 = z2450 + z2526;
    const Scalar z2536 = z2451 - z2527;
    const Scalar z2537 = z2452 - z2528;
    const Scalar z2538 = z2453 - z2529;
    const Scalar z2539 = z1089 - l_lambda_rear_rolls_x - l_lambda_front_rolls_x;
    const Scalar z2540 = z1090 + l_lambda_rear_rolls_y + l_lambda_front_rolls_y;
    const Scalar z2541 = z1091 - l_lambda_rear_touches - l_lambda_front_touches;
    const Scalar z2542 = z216 * l_lambda_rear_rolls_y + z217 * l_lambda_rear_rolls_x + z240 * l_lambda_front_rolls_y
        + z241 * l_lambda_front_rolls_x - z1084;
    const Scalar z2543 = z167 * l_lambda_front_touches + z222 * l_lambda_rear_rolls_x + z223 * l_lambda_rear_rolls_y
        + z246 * l_lambda_front_rolls_x + z247 * l_lambda_front_rolls_y - z1071;
    const Scalar z2544 = z273 * l_lambda_front_rolls_x + z274 * l_lambda_front_rolls_y - z1052;
    const Scalar z2545 = z79 * (l_lambda_rear_touches + z2541) - z156 * l_lambda_front_touches - z219
        * l_lambda_rear_rolls_x - z220 * l_lambda_rear_rolls_y - z243 * l_lambda_front_rolls_x - z244
        * l_lambda_front_rolls_y - z1077 + z2171 * z2543 - z2177 * z2539 - z2179 * z2542 + z2180 * z2540 + z2182
        * z2544;
    const Scalar z2546 = z189 * l_lambda_front_touches + z267 * l_lambda_front_rolls_x + z268 * l_lambda_front_rolls_y
        + z1059 - z2172 * z2543 - z2187 * z2539 - z2189 * z2542 + z2190 * z2540 + z2192 * z2544;
    const Scalar z2547 = z222 * l_lambda_rear_rolls_x + z223 * l_lambda_rear_rolls_y - z1066 + z2194 * z2539 - z2196
        * z2542 + z2197 * z2540 + z2199 * z2544;
    const Scalar z2548 = z1814 * z2359 + z2350 * z2357 - z2352 * z2360 + z2353 * z2358 + z2355 * z2365 + z2356 * z2362;
    const Scalar z2549 = z1814 * z2368 + z2350 * z2366 - z2352 * z2369 - z2353 * z2367 - z2355 * z2374 + z2356 * z2371;
    const Scalar z2550 = z2350 * z2375 + z2352 * z2377 + z2353 * z2376 + z2355 * z2382 - z2356 * z2379;
    const Scalar z2551 = z2545 + z2548;
    const Scalar z2552 = z2546 + z2549;
    const Scalar z2553 = z2547 - z2550;
    const Scalar z2554 = n1 / z2391;
    const Scalar z2555 = z2385 * z2554;
    const Scalar z2556 = z2388 * z2554;
    const Scalar z2557 = z2383 - z2385 * z2555;
    const Scalar z2558 = z2384 + z2385 * z2556;
    const Scalar z2559 = z2387 + z2388 * z2556;
    const Scalar z2560 = n1 / z2559;
    const Scalar z2561 = z2558 * z2560;
    const Scalar z2562 = z2557 + z2558 * z2561;
    const Scalar z2563 = n1 / z2562;
    const Scalar z2564 = z2439 + z2442 * z2556;
    const Scalar z2565 = z2436 + z2442 * z2555 - z2561 * z2564;
    const Scalar z2566 = z2563 * z2565;
    const Scalar z2567 = z2560 * z2564 + z2561 * z2566;
    const Scalar z2568 = z2442 * z2554 + z2555 * z2566 - z2556 * z2567;
    const Scalar z2569 = z2440 - z2443 * z2556;
    const Scalar z2570 = z2437 - z2443 * z2555 - z2561 * z2569;
    const Scalar z2571 = z2563 * z2570;
    const Scalar z2572 = z2560 * z2569 + z2561 * z2571;
    const Scalar z2573 = z2443 * z2554 - z2555 * z2571 + z2556 * z2572;
    const Scalar z2574 = z2533 - z2536 * z2556;
    const Scalar z2575 = z2530 - z2536 * z2555 - z2561 * z2574;
    const Scalar z2576 = z2563 * z2575;
    const Scalar z2577 = z2560 * z2574 + z2561 * z2576;
    const Scalar z2578 = z2536 * z2554 - z2555 * z2576 + z2556 * z2577;
    const Scalar z2579 = z2441 - z2444 * z2556;
    const Scalar z2580 = z2438 - z2444 * z2555 - z2561 * z2579;
    const Scalar z2581 = z2563 * z2580;
    const Scalar z2582 = z2560 * z2579 + z2561 * z2581;
    const Scalar z2583 = z2444 * z2554 - z2555 * z2581 + z2556 * z2582;
    const Scalar z2584 = z2534 + z2537 * z2556;
    const Scalar z2585 = z2531 + z2537 * z2555 - z2561 * z2584;
    const Scalar z2586 = z2563 * z2585;
    const Scalar z2587 = z2560 * z2584 + z2561 * z2586;
    const Scalar z2588 = z2537 * z2554 + z2555 * z2586 - z2556 * z2587;
    const Scalar z2589 = z2535 - z2538 * z2556;
    const Scalar z2590 = z2532 - z2538 * z2555 - z2561 * z2589;
    const Scalar z2591 = z2563 * z2590;
    const Scalar z2592 = z2560 * z2589 + z2561 * z2591;
    const Scalar z2593 = z2538 * z2554 - z2555 * z2591 + z2556 * z2592;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z559;
    result.M[4] = -z544;
    result.M[5] = z525;
    result.M[6] = z469;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z560;
    result.M[13] = z545;
    result.M[14] = -z526;
    result.M[15] = z470;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z541;
    result.M[23] = z522;
    result.M[24] = z466;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z559;
    result.M[28] = -z560;
    result.M[29] = n0;
    result.M[30] = z558;
    result.M[31] = z543;
    result.M[32] = z524;
    result.M[33] = -z468;
    result.M[34] = z513;
    result.M[35] = z445;
    result.M[36] = -z544;
    result.M[37] = z545;
    result.M[38] = z541;
    result.M[39] = z543;
    result.M[40] = z538;
    result.M[41] = z519;
    result.M[42] = z463;
    result.M[43] = n0;
    result.M[44] = z442;
    result.M[45] = z525;
    result.M[46] = -z526;
    result.M[47] = z522;
    result.M[48] = z524;
    result.M[49] = z519;
    result.M[50] = z516;
    result.M[51] = -z458;
    result.M[52] = n0_12;
    result.M[53] = z440;
    result.M[54] = z469;
    result.M[55] = z470;
    result.M[56] = z466;
    result.M[57] = -z468;
    result.M[58] = z463;
    result.M[59] = -z458;
    result.M[60] = z450;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z513;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z445;
    result.M[76] = z442;
    result.M[77] = z440;
    result.M[78] = n0;
    result.M[79] = n0;
    result.M[80] = n0_28;
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
    result.C[21] = n0;
    result.C[22] = n0;
    result.C[23] = n0;
    result.C[24] = n0;
    result.C[25] = n0;
    result.C[26] = n0;
    result.C[27] = z1160;
    result.C[28] = -z1178;
    result.C[29] = n0;
    result.C[30] = z1205;
    result.C[31] = z1224;
    result.C[32] = z1194;
    result.C[33] = -z1232;
    result.C[34] = z1192;
    result.C[35] = -z1182;
    result.C[36] = z1297;
    result.C[37] = -z1357;
    result.C[38] = z1359;
    result.C[39] = z1384;
    result.C[40] = -z1419;
    result.C[41] = z1373;
    result.C[42] = z1458;
    result.C[43] = z1371;
    result.C[44] = z1361;
    result.C[45] = z1526;
    result.C[46] = z1567;
    result.C[47] = z1569;
    result.C[48] = -z1589;
    result.C[49] = z1614;
    result.C[50] = -z1581;
    result.C[51] = z1636;
    result.C[52] = n0;
    result.C[53] = -z1571;
    result.C[54] = -z1685;
    result.C[55] = z1721;
    result.C[56] = z1723;
    result.C[57] = z1741;
    result.C[58] = z1765;
    result.C[59] = z1735;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z1725;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z1803;
    result.C[67] = z1804;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = -z1811;
    result.C[76] = -z1812;
    result.C[77] = -z1807;
    result.C[78] = -z1813;
    result.C[79] = n0;
    result.C[80] = n0;
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
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.K[25] = n0;
    result.K[26] = n0;
    result.K[27] = -z1177;
    result.K[28] = z1179;
    result.K[29] = n0;
    result.K[30] = z1221;
    result.K[31] = -z1226;
    result.K[32] = z1231;
    result.K[33] = -z1238;
    result.K[34] = z1239;
    result.K[35] = z1244;
    result.K[36] = z1356;
    result.K[37] = z1358;
    result.K[38] = -z1360;
    result.K[39] = -z1418;
    result.K[40] = -z1443;
    result.K[41] = z1457;
    result.K[42] = -z1478;
    result.K[43] = -z1479;
    result.K[44] = z1485;
    result.K[45] = -z1566;
    result.K[46] = z1568;
    result.K[47] = -z1570;
    result.K[48] = -z1613;
    result.K[49] = z1621;
    result.K[50] = z1635;
    result.K[51] = z1663;
    result.K[52] = n0;
    result.K[53] = z1669;
    result.K[54] = z1720;
    result.K[55] = -z1722;
    result.K[56] = z1724;
    result.K[57] = z1764;
    result.K[58] = -z1772;
    result.K[59] = z1777;
    result.K[60] = z1795;
    result.K[61] = n0;
    result.K[62] = z1801;
    result.K[63] = n0;
    result.K[64] = n0;
    result.K[65] = n0;
    result.K[66] = n0;
    result.K[67] = n0;
    result.K[68] = n0;
    result.K[69] = n0;
    result.K[70] = n0;
    result.K[71] = n0;
    result.K[72] = n0;
    result.K[73] = n0;
    result.K[74] = n0;
    result.K[75] = n0;
    result.K[76] = n0;
    result.K[77] = n0;
    result.K[78] = n0;
    result.K[79] = n0;
    result.K[80] = n0;
    result.F[0] = -z1089 + l_lambda_rear_rolls_x + l_lambda_front_rolls_x;
    result.F[1] = -z1090 - l_lambda_rear_rolls_y - l_lambda_front_rolls_y;
    result.F[2] = z1091 - l_lambda_rear_touches - l_lambda_front_touches;
    result.F[3] = z216 * l_lambda_rear_rolls_y + z217 * l_lambda_rear_rolls_x + z240 * l_lambda_front_rolls_y + z241
        * l_lambda_front_rolls_x - z1084;
    result.F[4] = z79 * l_lambda_rear_touches - z156 * l_lambda_front_touches - z219 * l_lambda_rear_rolls_x - z220
        * l_lambda_rear_rolls_y - z243 * l_lambda_front_rolls_x - z244 * l_lambda_front_rolls_y - z1077;
    result.F[5] = z167 * l_lambda_front_touches + z222 * l_lambda_rear_rolls_x + z223 * l_lambda_rear_rolls_y + z246
        * l_lambda_front_rolls_x + z247 * l_lambda_front_rolls_y - z1071;
    result.F[6] = z189 * l_lambda_front_touches + z267 * l_lambda_front_rolls_x + z268 * l_lambda_front_rolls_y + z1059;
    result.F[7] = z222 * l_lambda_rear_rolls_x + z223 * l_lambda_rear_rolls_y - z1066;
    result.F[8] = z273 * l_lambda_front_rolls_x + z274 * l_lambda_front_rolls_y - z1052;
    result.M_r[0] = z2383;
    result.M_r[1] = -z2384;
    result.M_r[2] = -z2385;
    result.M_r[3] = -z2384;
    result.M_r[4] = -z2387;
    result.M_r[5] = -z2388;
    result.M_r[6] = -z2385;
    result.M_r[7] = -z2388;
    result.M_r[8] = z2391;
    result.C_r[0] = z2436;
    result.C_r[1] = z2439;
    result.C_r[2] = z2442;
    result.C_r[3] = z2437;
    result.C_r[4] = z2440;
    result.C_r[5] = -z2443;
    result.C_r[6] = z2438;
    result.C_r[7] = z2441;
    result.C_r[8] = -z2444;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z2530;
    result.K_r[7] = z2533;
    result.K_r[8] = -z2536;
    result.K_r[9] = z2531;
    result.K_r[10] = z2534;
    result.K_r[11] = z2537;
    result.K_r[12] = z2532;
    result.K_r[13] = z2535;
    result.K_r[14] = -z2538;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = z2551;
    result.F_r[1] = z2552;
    result.F_r[2] = z2553;
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
    result.A[20] = z2208;
    result.A[21] = -z2211;
    result.A[22] = -z2210;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z2213;
    result.A[27] = -z2576;
    result.A[28] = z2577;
    result.A[29] = z2578;
    result.A[30] = -z2219;
    result.A[31] = z2222;
    result.A[32] = z2221;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z2224;
    result.A[37] = -z2586;
    result.A[38] = z2587;
    result.A[39] = -z2588;
    result.A[40] = z2230;
    result.A[41] = -z2233;
    result.A[42] = -z2232;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z2235;
    result.A[47] = -z2591;
    result.A[48] = z2592;
    result.A[49] = z2593;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = n0;
    result.A[55] = n0;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = n0;
    result.A[67] = n0;
    result.A[68] = n0;
    result.A[69] = n0;
    result.A[70] = z2177;
    result.A[71] = -z2180;
    result.A[72] = -z2179;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z2566;
    result.A[78] = z2567;
    result.A[79] = -z2568;
    result.A[80] = z2187;
    result.A[81] = -z2190;
    result.A[82] = -z2189;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z2192;
    result.A[87] = -z2571;
    result.A[88] = z2572;
    result.A[89] = z2573;
    result.A[90] = -z2194;
    result.A[91] = -z2197;
    result.A[92] = -z2196;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z2199;
    result.A[97] = -z2581;
    result.A[98] = z2582;
    result.A[99] = z2583;
    if (!(traits::regular(z2158, z2160) && traits::regular(z2161, z2163) && traits::regular(z2164, z2166)
        && traits::regular(z2167, z2169) && traits::regular(z2562, z2383) && traits::regular(-z2559, -z2387)
        && traits::regular(z2391, z2391))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[3] - result.M[3]) + (result.M[4] - result.M[4]) + (result.M[5] - result.M[5])
        + (result.M[6] - result.M[6]) + (result.M[12] - result.M[12]) + (result.M[13] - result.M[13]) + (result.M[14]
        - result.M[14]) + (result.M[15] - result.M[15]) + (result.M[22] - result.M[22]) + (result.M[23] - result.M[23])
        + (result.M[24] - result.M[24]) + (result.M[27] - result.M[27]) + (result.M[28] - result.M[28]) + (result.M[30]
        - result.M[30]) + (result.M[31] - result.M[31]) + (result.M[32] - result.M[32]) + (result.M[33] - result.M[33])
        + (result.M[34] - result.M[34]) + (result.M[35] - result.M[35]) + (result.M[36] - result.M[36]) + (result.M[37]
        - result.M[37]) + (result.M[38] - result.M[38]) + (result.M[39] - result.M[39]) + (result.M[40] - result.M[40])
        + (result.M[41] - result.M[41]) + (result.M[42] - result.M[42]) + (result.M[44] - result.M[44]) + (result.M[45]
        - result.M[45]) + (result.M[46] - result.M[46]) + (result.M[47] - result.M[47]) + (result.M[48] - result.M[48])
        + (result.M[49] - result.M[49]) + (result.M[50] - result.M[50]) + (result.M[51] - result.M[51]) + (result.M[53]
        - result.M[53]) + (result.M[54] - result.M[54]) + (result.M[55] - result.M[55]) + (result.M[56] - result.M[56])
        + (result.M[57] - result.M[57]) + (result.M[58] - result.M[58]) + (result.M[59] - result.M[59]) + (result.M[60]
        - result.M[60]) + (result.M[66] - result.M[66]) + (result.M[75] - result.M[75]) + (result.M[76] - result.M[76])
        + (result.M[77] - result.M[77]) + (result.C[27] - result.C[27]) + (result.C[28] - result.C[28]) + (result.C[30]
        - result.C[30]) + (result.C[31] - result.C[31]) + (result.C[32] - result.C[32]) + (result.C[33] - result.C[33])
        + (result.C[34] - result.C[34]) + (result.C[35] - result.C[35]) + (result.C[36] - result.C[36]) + (result.C[37]
        - result.C[37]) + (result.C[38] - result.C[38]) + (result.C[39] - result.C[39]) + (result.C[40] - result.C[40])
        + (result.C[41] - result.C[41]) + (result.C[42] - result.C[42]) + (result.C[43] - result.C[43]) + (result.C[44]
        - result.C[44]) + (result.C[45] - result.C[45]) + (result.C[46] - result.C[46]) + (result.C[47] - result.C[47])
        + (result.C[48] - result.C[48]) + (result.C[49] - result.C[49]) + (result.C[50] - result.C[50]) + (result.C[51]
        - result.C[51]) + (result.C[53] - result.C[53]) + (result.C[54] - result.C[54]) + (result.C[55] - result.C[55])
        + (result.C[56] - result.C[56]) + (result.C[57] - result.C[57]) + (result.C[58] - result.C[58]) + (result.C[59]
        - result.C[59]) + (result.C[62] - result.C[62]) + (result.C[66] - result.C[66]) + (result.C[67] - result.C[67])
        + (result.C[75] - result.C[75]) + (result.C[76] - result.C[76]) + (result.C[77] - result.C[77]) + (result.C[78]
        - result.C[78]) + (result.K[27] - result.K[27]) + (result.K[28] - result.K[28]) + (result.K[30] - result.K[30])
        + (result.K[31] - result.K[31]) + (result.K[32] - result.K[32]) + (result.K[33] - result.K[33]) + (result.K[34]
        - result.K[34]) + (result.K[35] - result.K[35]) + (result.K[36] - result.K[36]) + (result.K[37] - result.K[37])
        + (result.K[38] - result.K[38]) + (result.K[39] - result.K[39]) + (result.K[40] - result.K[40]) + (result.K[41]
        - result.K[41]) + (result.K[42] - result.K[42]) + (result.K[43] - result.K[43]) + (result.K[44] - result.K[44])
        + (result.K[45] - result.K[45]) + (result.K[46] - result.K[46]) + (result.K[47] - result.K[47]) + (result.K[48]
        - result.K[48]) + (result.K[49] - result.K[49]) + (result.K[50] - result.K[50]) + (result.K[51] - result.K[51])
        + (result.K[53] - result.K[53]) + (result.K[54] - result.K[54]) + (result.K[55] - result.K[55]) + (result.K[56]
        - result.K[56]) + (result.K[57] - result.K[57]) + (result.K[58] - result.K[58]) + (result.K[59] - result.K[59])
        + (result.K[60] - result.K[60]) + (result.K[62] - result.K[62]) + (result.F[0] - result.F[0]) + (result.F[1]
        - result.F[1]) + (result.F[2] - result.F[2]) + (result.F[3] - result.F[3]) + (result.F[4] - result.F[4])
        + (result.F[5] - result.F[5]) + (result.F[6] - result.F[6]) + (result.F[7] - result.F[7]) + (result.F[8]
        - result.F[8]) + (result.M_r[0] - result.M_r[0]) + (result.M_r[1] - result.M_r[1]) + (result.M_r[2]
        - result.M_r[2]) + (result.M_r[3] - result.M_r[3]) + (result.M_r[4] - result.M_r[4]) + (result.M_r[5]
        - result.M_r[5]) + (result.M_r[6] - result.M_r[6]) + (result.M_r[7] - result.M_r[7]) + (result.M_r[8]
        - result.M_r[8]) + (result.C_r[0] - result.C_r[0]) + (result.C_r[1] - result.C_r[1]) + (result.C_r[2]
        - result.C_r[2]) + (result.C_r[3] - result.C_r[3]) + (result.C_r[4] - result.C_r[4]) + (result.C_r[5]
        - result.C_r[5]) + (result.C_r[6] - result.C_r[6]) + (result.C_r[7] - result.C_r[7]) + (result.C_r[8]
        - result.C_r[8]) + (result.K_r[6] - result.K_r[6]) + (result.K_r[7] - result.K_r[7]) + (result.K_r[8]
        - result.K_r[8]) + (result.K_r[9] - result.K_r[9]) + (result.K_r[10] - result.K_r[10]) + (result.K_r[11]
        - result.K_r[11]) + (result.K_r[12] - result.K_r[12]) + (result.K_r[13] - result.K_r[13]) + (result.K_r[14]
        - result.K_r[14]) + (result.F_r[0] - result.F_r[0]) + (result.F_r[1] - result.F_r[1]) + (result.F_r[2]
        - result.F_r[2]) + (result.A[20] - result.A[20]) + (result.A[21] - result.A[21]) + (result.A[22] - result.A[22])
        + (result.A[26] - result.A[26]) + (result.A[27] - result.A[27]) + (result.A[28] - result.A[28]) + (result.A[29]
        - result.A[29]) + (result.A[30] - result.A[30]) + (result.A[31] - result.A[31]) + (result.A[32] - result.A[32])
        + (result.A[36] - result.A[36]) + (result.A[37] - result.A[37]) + (result.A[38] - result.A[38]) + (result.A[39]
        - result.A[39]) + (result.A[40] - result.A[40]) + (result.A[41] - result.A[41]) + (result.A[42] - result.A[42])
        + (result.A[46] - result.A[46]) + (result.A[47] - result.A[47]) + (result.A[48] - result.A[48]) + (result.A[49]
        - result.A[49]) + (result.A[70] - result.A[70]) + (result.A[71] - result.A[71]) + (result.A[72] - result.A[72])
        + (result.A[77] - result.A[77]) + (result.A[78] - result.A[78]) + (result.A[79] - result.A[79]) + (result.A[80]
        - result.A[80]) + (result.A[81] - result.A[81]) + (result.A[82] - result.A[82]) + (result.A[86] - result.A[86])
        + (result.A[87] - result.A[87]) + (result.A[88] - result.A[88]) + (result.A[89] - result.A[89]) + (result.A[90]
        - result.A[90]) + (result.A[91] - result.A[91]) + (result.A[92] - result.A[92]) + (result.A[96] - result.A[96])
        + (result.A[97] - result.A[97]) + (result.A[98] - result.A[98]) + (result.A[99] - result.A[99]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace whipple_bicycle
