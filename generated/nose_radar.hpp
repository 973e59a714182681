// SPDX-License-Identifier: MIT
// nose_radar: Radar on the nose of an aircraft
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               14               35          0             0                  2       0     53      53
//   mass_matrix               5                7          0             0                  2       0     16      16
//   bias                      8               29          0             0                  2       0     41      40
//   inverse_dynamics         20               39          0             0                  2       0     63      63
//   forward_dynamics         22               47          2             0                  2       0     75      74
//   energy                   14               31          0             0                  2       0     49      52
//   reactions                11               25          0             0                  2       0     40      40
//   linearisation            74              156          2             0                  2       0    236     244
//
// Not computed because this mechanism does not need it:
//   kinematics: of 54 results 24 vanish identically, 5 repeat another up to sign
//   mass_matrix: of 9 results 2 vanish identically, 2 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, 'thrust', 'azimuth', 'elevation' have no force function
//   constraints: left out, the scene has no constraints
//   linearisation: of 93 results 45 vanish identically, 4 repeat another up to sign
//
// To write this file again:
//   nose_radar_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output nose_radar.hpp
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

namespace nose_radar {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "nose_radar";
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 3;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar alpha;  ///< coordinate [rad or 1]
    Scalar beta;  ///< coordinate [rad or 1]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::alpha, &Coordinates::beta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar alpha;  ///< its rate [rad/s]
    Scalar beta;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::alpha, &Velocities::beta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar alpha;  ///< its second rate [rad/s^2]
    Scalar beta;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::alpha, &Accelerations::beta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar alpha;  ///< works with the rate of alpha [N m]
    Scalar beta;  ///< works with the rate of beta [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::alpha,
          &GeneralizedForces::beta};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar thrust;  ///< motor [N]
    Scalar azimuth;  ///< motor [N m]
    Scalar elevation;  ///< motor [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::thrust, &Inputs::azimuth, &Inputs::elevation};
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
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    state.time = n0;
    state.q.x = n0;
    state.q.alpha = n0_3;
    state.q.beta = -n0_4;
    state.v.x = n200;
    state.v.alpha = n1_5;
    state.v.beta = n2;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> aircraft_position;  ///< centre of mass of aircraft [m]
    std::array<Scalar, 9> aircraft_rotation;  ///< from the axes of aircraft to the ground's (3 x 3)
    std::array<Scalar, 3> aircraft_velocity;  ///< velocity of the centre of mass of aircraft [m/s]
    std::array<Scalar, 3> aircraft_angular_velocity;  ///< angular velocity of aircraft [rad/s]
    std::array<Scalar, 3> unit_1_position;  ///< centre of mass of unit_1 [m]
    std::array<Scalar, 9> unit_1_rotation;  ///< from the axes of unit_1 to the ground's (3 x 3)
    std::array<Scalar, 3> unit_1_velocity;  ///< velocity of the centre of mass of unit_1 [m/s]
    std::array<Scalar, 3> unit_1_angular_velocity;  ///< angular velocity of unit_1 [rad/s]
    std::array<Scalar, 3> antenna_position;  ///< centre of mass of antenna [m]
    std::array<Scalar, 9> antenna_rotation;  ///< from the axes of antenna to the ground's (3 x 3)
    std::array<Scalar, 3> antenna_velocity;  ///< velocity of the centre of mass of antenna [m/s]
    std::array<Scalar, 3> antenna_angular_velocity;  ///< angular velocity of antenna [rad/s]
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
    Scalar F_x;  ///< reaction along 'F_x' [kg m s^-2]
    Scalar F_x2;  ///< reaction along 'F_x2' [kg m s^-2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::F_x, &Reactions::F_x2};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 9> E;  ///< effect of the inputs (3 x 3)
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, e'): x' = A x + B du (6 x 6)
    std::array<Scalar, 18> B;  ///< input matrix (6 x 3)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z13 = v_x * c_alpha;
    const Scalar z14 = v_x * s_alpha;
    const Scalar z15 = n0_4 * v_alpha - z14;
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z18 = c_beta * z13;
    const Scalar z19 = s_beta * z13;
    const Scalar z20 = s_alpha * z14 + c_alpha * z13;
    const Scalar z22 = n0_25 * c_beta;
    const Scalar z23 = n0_25 * s_beta;
    const Scalar z24 = n0_4 + z22;
    const Scalar z25 = c_alpha * z24;
    const Scalar z26 = s_alpha * z24;
    const Scalar z27 = q_x + z25;
    const Scalar z28 = c_alpha * c_beta;
    const Scalar z29 = s_alpha * c_beta;
    const Scalar z30 = c_alpha * s_beta;
    const Scalar z31 = s_alpha * s_beta;
    const Scalar z32 = z15 + n0_25 * z17;
    const Scalar z33 = n0_25 * v_beta - z19;
    const Scalar z34 = s_beta * z33 - c_beta * z18;
    const Scalar z35 = s_beta * z18 + c_beta * z33;
    const Scalar z36 = s_alpha * z32 + c_alpha * z34;
    const Scalar z37 = s_alpha * z34 - c_alpha * z32;
    const Scalar z38 = s_beta * z17 - c_beta * z16;
    const Scalar z39 = s_beta * z16 + c_beta * z17;
    const Scalar z40 = s_alpha * v_beta - c_alpha * z38;
    const Scalar z41 = s_alpha * z38 + c_alpha * v_beta;
    result.aircraft_position[0] = q_x;
    result.aircraft_position[1] = n0;
    result.aircraft_position[2] = n0;
    result.aircraft_rotation[0] = n1;
    result.aircraft_rotation[1] = n0;
    result.aircraft_rotation[2] = n0;
    result.aircraft_rotation[3] = n0;
    result.aircraft_rotation[4] = n1;
    result.aircraft_rotation[5] = n0;
    result.aircraft_rotation[6] = n0;
    result.aircraft_rotation[7] = n0;
    result.aircraft_rotation[8] = n1;
    result.aircraft_velocity[0] = v_x;
    result.aircraft_velocity[1] = n0;
    result.aircraft_velocity[2] = n0;
    result.aircraft_angular_velocity[0] = n0;
    result.aircraft_angular_velocity[1] = n0;
    result.aircraft_angular_velocity[2] = n0;
    result.unit_1_position[0] = q_x;
    result.unit_1_position[1] = n0;
    result.unit_1_position[2] = n0;
    result.unit_1_rotation[0] = c_alpha;
    result.unit_1_rotation[1] = s_alpha;
    result.unit_1_rotation[2] = n0;
    result.unit_1_rotation[3] = -s_alpha;
    result.unit_1_rotation[4] = c_alpha;
    result.unit_1_rotation[5] = n0;
    result.unit_1_rotation[6] = n0;
    result.unit_1_rotation[7] = n0;
    result.unit_1_rotation[8] = n1;
    result.unit_1_velocity[0] = z20;
    result.unit_1_velocity[1] = n0;
    result.unit_1_velocity[2] = n0;
    result.unit_1_angular_velocity[0] = n0;
    result.unit_1_angular_velocity[1] = n0;
    result.unit_1_angular_velocity[2] = v_alpha;
    result.antenna_position[0] = z27;
    result.antenna_position[1] = z26;
    result.antenna_position[2] = -z23;
    result.antenna_rotation[0] = z28;
    result.antenna_rotation[1] = z29;
    result.antenna_rotation[2] = -s_beta;
    result.antenna_rotation[3] = -s_alpha;
    result.antenna_rotation[4] = c_alpha;
    result.antenna_rotation[5] = n0;
    result.antenna_rotation[6] = z30;
    result.antenna_rotation[7] = z31;
    result.antenna_rotation[8] = c_beta;
    result.antenna_velocity[0] = -z36;
    result.antenna_velocity[1] = -z37;
    result.antenna_velocity[2] = -z35;
    result.antenna_angular_velocity[0] = -z40;
    result.antenna_angular_velocity[1] = z41;
    result.antenna_angular_velocity[2] = z39;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_92 = traits::constant(1.92, 1.92f, "48/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n4_8 = traits::constant(4.8, 4.8f, "24/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n9012 = traits::constant(9012.0, 9012.0f, "9012/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar q_alpha = state.q.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z49 = n3 * s_beta;
    const Scalar z50 = n3 * c_beta;
    const Scalar z52 = c_alpha * z49;
    const Scalar z56 = n0_35 * s_beta;
    const Scalar z57 = s_beta * z56;
    const Scalar z58 = n0_35 - z57;
    const Scalar z62 = n1_92 + n0_8 * z50 + z58;
    const Scalar z63 = n4_8 + z50;
    const Scalar z65 = n1_2 + z62;
    const Scalar z66 = s_alpha * z63;
    mass[0] = n9012;
    mass[1] = -z66;
    mass[2] = -z52;
    mass[3] = -z66;
    mass[4] = z65;
    mass[5] = n0;
    mass[6] = -z52;
    mass[7] = n0;
    mass[8] = n1_25;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z79 = v_alpha * v_alpha;
    const Scalar z80 = n0_4 * z79;
    const Scalar z81 = c_beta * z80;
    const Scalar z82 = s_beta * z80;
    const Scalar z83 = v_beta * z17;  // angular acceleration of hinge, x
    const Scalar z84 = v_beta * z16;  // angular acceleration of hinge, z
    const Scalar z85 = v_beta * v_beta;
    const Scalar z86 = z17 * z17;
    const Scalar z87 = z85 + z86;
    const Scalar z88 = n2 * z84;
    const Scalar z89 = z16 * z17;
    const Scalar z90 = n12 * z81 + n3 * z87;  // force on antenna, x
    const Scalar z91 = n3 * z88;  // force on antenna, y
    const Scalar z92 = n12 * z82 + n3 * z89;  // force on antenna, z
    const Scalar z93 = n3 * z82;  // moment on antenna, y
    const Scalar z94 = n2 * z83;
    const Scalar z95 = n0_45 * z94;  // moment on hinge, x
    const Scalar z96 = n0_35 * z89 + z93;  // moment on hinge, y
    const Scalar z97 = n0_8 * z88;  // moment on hinge, z
    const Scalar z98 = s_beta * z92 + c_beta * z90;
    const Scalar z101 = s_beta * z95 - c_beta * z97;
    const Scalar z103 = n0_4 * z91 - z101;  // moment on unit_1, z
    const Scalar z104 = s_alpha * z91 - c_alpha * z98;
    forces.x = z104;
    forces.alpha = -z103;
    forces.beta = z96;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n9000 = traits::constant(9000.0, 9000.0f, "9000/1");
    const Scalar a_x = accelerations.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z79 = v_alpha * v_alpha;
    const Scalar z83 = v_beta * z17;  // angular acceleration of hinge, x
    const Scalar z84 = v_beta * z16;  // angular acceleration of hinge, z
    const Scalar z85 = v_beta * v_beta;
    const Scalar z86 = z17 * z17;
    const Scalar z87 = z85 + z86;
    const Scalar z89 = z16 * z17;
    const Scalar z108 = a_x * c_alpha;
    const Scalar z109 = a_x * s_alpha;
    const Scalar z110 = a_alpha * s_beta;
    const Scalar z111 = a_alpha * c_beta;
    const Scalar z112 = n0_4 * z79 - z108;
    const Scalar z113 = n0_4 * a_alpha - z109;
    const Scalar z114 = c_beta * z112;
    const Scalar z115 = s_beta * z112;
    const Scalar z116 = v_beta * z17 + z110;  // angular acceleration of hinge, x
    const Scalar z117 = v_beta * z16 - z111;  // angular acceleration of hinge, z
    const Scalar z118 = z84 + z117;
    const Scalar z119 = a_beta + z89;
    const Scalar z120 = n3 * z87 + n12 * z114;  // force on antenna, x
    const Scalar z121 = n12 * z113 - n3 * z118;  // force on antenna, y
    const Scalar z122 = n12 * z115 + n3 * z119;  // force on antenna, z
    const Scalar z123 = n3 * z115;  // moment on antenna, y
    const Scalar z124 = n3 * z113;  // moment on antenna, z
    const Scalar z125 = z83 + z116;
    const Scalar z126 = n0_45 * z125;  // moment on hinge, x
    const Scalar z127 = n1_25 * a_beta + n0_35 * z89 + z123;  // moment on hinge, y
    const Scalar z128 = n0_8 * z118 - z124;  // moment on hinge, z
    const Scalar z129 = s_beta * z122 + c_beta * z120;
    const Scalar z132 = s_beta * z126 - c_beta * z128;
    const Scalar z134 = n0_75 * a_alpha + n0_4 * z121 + z132;  // moment on unit_1, z
    const Scalar z135 = s_alpha * z121 + c_alpha * z129;
    const Scalar z139 = n9000 * a_x - z135;  // force on aircraft, x
    forces.x = z139;
    forces.alpha = z134;
    forces.beta = z127;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_92 = traits::constant(1.92, 1.92f, "48/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n4_8 = traits::constant(4.8, 4.8f, "24/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n9012 = traits::constant(9012.0, 9012.0f, "9012/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar u_thrust = inputs.thrust;
    const Scalar u_azimuth = inputs.azimuth;
    const Scalar u_elevation = inputs.elevation;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z49 = n3 * s_beta;
    const Scalar z50 = n3 * c_beta;
    const Scalar z52 = c_alpha * z49;
    const Scalar z56 = n0_35 * s_beta;
    const Scalar z57 = s_beta * z56;
    const Scalar z58 = n0_35 - z57;
    const Scalar z62 = n1_92 + n0_8 * z50 + z58;
    const Scalar z63 = n4_8 + z50;
    const Scalar z65 = n1_2 + z62;
    const Scalar z66 = s_alpha * z63;
    const Scalar z79 = v_alpha * v_alpha;
    const Scalar z80 = n0_4 * z79;
    const Scalar z81 = c_beta * z80;
    const Scalar z82 = s_beta * z80;
    const Scalar z83 = v_beta * z17;  // angular acceleration of hinge, x
    const Scalar z84 = v_beta * z16;  // angular acceleration of hinge, z
    const Scalar z85 = v_beta * v_beta;
    const Scalar z86 = z17 * z17;
    const Scalar z87 = z85 + z86;
    const Scalar z88 = n2 * z84;
    const Scalar z89 = z16 * z17;
    const Scalar z90 = n12 * z81 + n3 * z87;  // force on antenna, x
    const Scalar z91 = n3 * z88;  // force on antenna, y
    const Scalar z92 = n12 * z82 + n3 * z89;  // force on antenna, z
    const Scalar z93 = n3 * z82;  // moment on antenna, y
    const Scalar z94 = n2 * z83;
    const Scalar z95 = n0_45 * z94;  // moment on hinge, x
    const Scalar z96 = n0_35 * z89 + z93;  // moment on hinge, y
    const Scalar z97 = n0_8 * z88;  // moment on hinge, z
    const Scalar z98 = s_beta * z92 + c_beta * z90;
    const Scalar z101 = s_beta * z95 - c_beta * z97;
    const Scalar z103 = n0_4 * z91 - z101;  // moment on unit_1, z
    const Scalar z104 = s_alpha * z91 - c_alpha * z98;
    const Scalar z140 = u_thrust - z104;
    const Scalar z141 = u_azimuth + z103;
    const Scalar z142 = u_elevation - z96;
    const Scalar z143 = n0_8 * z52;
    const Scalar z144 = n9012 - z52 * z143;
    const Scalar z145 = n1 / z65;
    const Scalar z146 = z66 * z145;
    const Scalar z147 = z66 * z146 - z144;
    const Scalar z148 = n1 / z147;
    const Scalar z149 = z140 + z141 * z146 + z142 * z143;
    const Scalar z150 = z148 * z149;
    const Scalar z151 = z141 * z145 - z146 * z150;
    const Scalar z152 = n0_8 * z142 - z143 * z150;
    accelerations.x = -z150;
    accelerations.alpha = z151;
    accelerations.beta = z152;
    if (!(traits::regular(-z147, n9012) && traits::regular(z65, z65))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.x - accelerations.x) + (accelerations.alpha - accelerations.alpha)
        + (accelerations.beta - accelerations.beta);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4500 = traits::constant(4500.0, 4500.0f, "4500/1");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar u_thrust = inputs.thrust;
    const Scalar u_azimuth = inputs.azimuth;
    const Scalar u_elevation = inputs.elevation;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z13 = v_x * c_alpha;
    const Scalar z14 = v_x * s_alpha;
    const Scalar z15 = n0_4 * v_alpha - z14;
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z18 = c_beta * z13;
    const Scalar z19 = s_beta * z13;
    const Scalar z153 = n12 * z15 + n3 * z17;
    const Scalar z154 = n3 * v_beta - n12 * z19;
    const Scalar z155 = n1_25 * v_beta - n3 * z19;
    const Scalar z156 = n3 * z15 + n1_25 * z17;
    result.kinetic = n0_5 * (v_beta * z155 + z15 * z153 + z17 * z156 - z19 * z154) + n4500 * v_x * v_x + n0_15 * v_alpha
        * v_alpha + n0_45 * z16 * z16 + n6 * z18 * z18;
    result.force_function = n0;
    result.power = v_x * u_thrust + v_alpha * u_azimuth + v_beta * u_elevation;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar a_x = accelerations.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z79 = v_alpha * v_alpha;
    const Scalar z84 = v_beta * z16;  // angular acceleration of hinge, z
    const Scalar z85 = v_beta * v_beta;
    const Scalar z86 = z17 * z17;
    const Scalar z87 = z85 + z86;
    const Scalar z89 = z16 * z17;
    const Scalar z108 = a_x * c_alpha;
    const Scalar z109 = a_x * s_alpha;
    const Scalar z111 = a_alpha * c_beta;
    const Scalar z112 = n0_4 * z79 - z108;
    const Scalar z113 = n0_4 * a_alpha - z109;
    const Scalar z114 = c_beta * z112;
    const Scalar z115 = s_beta * z112;
    const Scalar z117 = v_beta * z16 - z111;  // angular acceleration of hinge, z
    const Scalar z118 = z84 + z117;
    const Scalar z119 = a_beta + z89;
    const Scalar z120 = n3 * z87 + n12 * z114;  // force on antenna, x
    const Scalar z121 = n12 * z113 - n3 * z118;  // force on antenna, y
    const Scalar z122 = n12 * z115 + n3 * z119;  // force on antenna, z
    const Scalar z129 = s_beta * z122 + c_beta * z120;
    const Scalar z135 = s_alpha * z121 + c_alpha * z129;
    result.F_x = -z135;
    result.F_x2 = -z120;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n1_92 = traits::constant(1.92, 1.92f, "48/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n4_8 = traits::constant(4.8, 4.8f, "24/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n9000 = traits::constant(9000.0, 9000.0f, "9000/1");
    const Scalar n9012 = traits::constant(9012.0, 9012.0f, "9012/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_x = accelerations.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar u_thrust = inputs.thrust;
    const Scalar u_azimuth = inputs.azimuth;
    const Scalar u_elevation = inputs.elevation;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z16 = v_alpha * s_beta;
    const Scalar z17 = v_alpha * c_beta;
    const Scalar z49 = n3 * s_beta;
    const Scalar z50 = n3 * c_beta;
    const Scalar z52 = c_alpha * z49;
    const Scalar z56 = n0_35 * s_beta;
    const Scalar z57 = s_beta * z56;
    const Scalar z58 = n0_35 - z57;
    const Scalar z62 = n1_92 + n0_8 * z50 + z58;
    const Scalar z63 = n4_8 + z50;
    const Scalar z65 = n1_2 + z62;
    const Scalar z66 = s_alpha * z63;
    const Scalar z79 = v_alpha * v_alpha;
    const Scalar z83 = v_beta * z17;  // angular acceleration of hinge, x
    const Scalar z84 = v_beta * z16;  // angular acceleration of hinge, z
    const Scalar z85 = v_beta * v_beta;
    const Scalar z86 = z17 * z17;
    const Scalar z87 = z85 + z86;
    const Scalar z89 = z16 * z17;
    const Scalar z108 = a_x * c_alpha;
    const Scalar z109 = a_x * s_alpha;
    const Scalar z110 = a_alpha * s_beta;
    const Scalar z111 = a_alpha * c_beta;
    const Scalar z112 = n0_4 * z79 - z108;
    const Scalar z113 = n0_4 * a_alpha - z109;
    const Scalar z114 = c_beta * z112;
    const Scalar z115 = s_beta * z112;
    const Scalar z116 = v_beta * z17 + z110;  // angular acceleration of hinge, x
    const Scalar z117 = v_beta * z16 - z111;  // angular acceleration of hinge, z
    const Scalar z118 = z84 + z117;
    const Scalar z119 = a_beta + z89;
    const Scalar z120 = n3 * z87 + n12 * z114;  // force on antenna, x
    const Scalar z121 = n12 * z113 - n3 * z118;  // force on antenna, y
    const Scalar z122 = n12 * z115 + n3 * z119;  // force on antenna, z
    const Scalar z123 = n3 * z115;  // moment on antenna, y
    const Scalar z124 = n3 * z113;  // moment on antenna, z
    const Scalar z125 = z83 + z116;
    const Scalar z126 = n0_45 * z125;  // moment on hinge, x
    const Scalar z127 = n1_25 * a_beta + n0_35 * z89 + z123;  // moment on hinge, y
    const Scalar z128 = n0_8 * z118 - z124;  // moment on hinge, z
    const Scalar z129 = s_beta * z122 + c_beta * z120;
    const Scalar z132 = s_beta * z126 - c_beta * z128;
    const Scalar z134 = n0_75 * a_alpha + n0_4 * z121 + z132;  // moment on unit_1, z
    const Scalar z135 = s_alpha * z121 + c_alpha * z129;
    const Scalar z139 = n9000 * a_x - z135;  // force on aircraft, x
    const Scalar z143 = n0_8 * z52;
    const Scalar z144 = n9012 - z52 * z143;
    const Scalar z145 = n1 / z65;
    const Scalar z146 = z66 * z145;
    const Scalar z147 = z66 * z146 - z144;
    const Scalar z148 = n1 / z147;
    const Scalar z181 = v_beta * s_beta;
    const Scalar z182 = n2 * z181;
    const Scalar z183 = n3 * z182;
    const Scalar z184 = n2 * v_alpha;
    const Scalar z185 = n0_4 * z184;
    const Scalar z186 = s_beta * z185;
    const Scalar z187 = s_beta * z17 + c_beta * z16;
    const Scalar z188 = n12 * z186 + n3 * z187;
    const Scalar z189 = n2 * c_beta * z17;
    const Scalar z190 = c_beta * z185;
    const Scalar z191 = n3 * z189 + n12 * z190;
    const Scalar z192 = s_beta * z188 + c_beta * z191;
    const Scalar z193 = s_alpha * z183 - c_alpha * z192;
    const Scalar z194 = n12 * z108;
    const Scalar z195 = s_beta * z109;
    const Scalar z196 = n12 * z195;
    const Scalar z197 = c_beta * z109;
    const Scalar z198 = n12 * z197;
    const Scalar z199 = s_beta * z196 + c_beta * z198;
    const Scalar z200 = s_alpha * (z129 + z194) - c_alpha * (z121 + z199);
    const Scalar z201 = v_beta * c_beta;
    const Scalar z202 = n2 * z201;
    const Scalar z203 = n0_45 * z202;
    const Scalar z204 = n0_8 * z182;
    const Scalar z205 = s_beta * z203 - c_beta * z204;
    const Scalar z206 = n0_4 * z183 - z205;
    const Scalar z207 = n3 * z108;
    const Scalar z208 = c_beta * z207;
    const Scalar z209 = n0_4 * z194 + z208;
    const Scalar z210 = n3 * z186;
    const Scalar z211 = n0_35 * z187 + z210;
    const Scalar z212 = n3 * z195;
    const Scalar z213 = n2 * z16;
    const Scalar z214 = n3 * z213;
    const Scalar z215 = n2 * v_beta;
    const Scalar z216 = n3 * z215;
    const Scalar z217 = c_beta * z216;
    const Scalar z218 = s_alpha * z214 - c_alpha * z217;
    const Scalar z219 = n3 * z125;
    const Scalar z220 = z16 * z16 - z17 * z17;
    const Scalar z221 = n12 * z114 - n3 * z220;
    const Scalar z222 = n2 * z16 * z17;
    const Scalar z223 = n12 * z115 + n3 * z222;
    const Scalar z224 = s_beta * (z120 - z221) - c_beta * (z122 - z223);
    const Scalar z225 = s_alpha * z219 + c_alpha * z224;
    const Scalar z226 = n2 * z17;
    const Scalar z227 = n0_45 * z226;
    const Scalar z228 = n0_8 * z213;
    const Scalar z229 = s_beta * z227 - c_beta * z228;
    const Scalar z230 = n0_4 * z214 - z229;
    const Scalar z231 = n0_45 * z118;
    const Scalar z232 = n0_8 * z125;
    const Scalar z233 = s_beta * (z128 - z231) + c_beta * (z126 - z232);
    const Scalar z234 = n0_4 * z219 - z233;
    const Scalar z235 = n3 * z114;
    const Scalar z236 = n0_35 * z220 - z235;
    const Scalar z237 = z143 * z212 - z146 * z209 + z200;
    const Scalar z238 = z148 * z237;
    const Scalar z239 = z145 * z209 + z146 * z238;
    const Scalar z240 = z143 * z238 - n0_8 * z212;
    const Scalar z241 = z143 * z211 - z146 * z206 + z193;
    const Scalar z242 = z148 * z241;
    const Scalar z243 = z145 * z206 + z146 * z242;
    const Scalar z244 = z143 * z242 - n0_8 * z211;
    const Scalar z245 = z143 * z236 + z146 * z234 - z225;
    const Scalar z246 = z148 * z245;
    const Scalar z247 = z145 * z234 - z146 * z246;
    const Scalar z248 = z143 * z246 - n0_8 * z236;
    const Scalar z249 = z146 * z230 - z218;
    const Scalar z250 = z148 * z249;
    const Scalar z251 = z145 * z230 - z146 * z250;
    const Scalar z252 = z143 * z250;
    const Scalar z253 = z146 * z148;
    const Scalar z254 = z143 * z148;
    const Scalar z255 = z145 - z146 * z253;
    const Scalar z256 = z143 * z253;
    const Scalar z257 = z146 * z254;
    const Scalar z258 = n0_8 - z143 * z254;
    result.M[0] = n9012;
    result.M[1] = -z66;
    result.M[2] = -z52;
    result.M[3] = -z66;
    result.M[4] = z65;
    result.M[5] = n0;
    result.M[6] = -z52;
    result.M[7] = n0;
    result.M[8] = n1_25;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = z193;
    result.C[4] = -z206;
    result.C[5] = z211;
    result.C[6] = z218;
    result.C[7] = -z230;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = z200;
    result.K[4] = -z209;
    result.K[5] = z212;
    result.K[6] = z225;
    result.K[7] = -z234;
    result.K[8] = -z236;
    result.F[0] = u_thrust - z139;
    result.F[1] = u_azimuth - z134;
    result.F[2] = u_elevation - z127;
    result.E[0] = n1;
    result.E[1] = n0;
    result.E[2] = n0;
    result.E[3] = n0;
    result.E[4] = n1;
    result.E[5] = n0;
    result.E[6] = n0;
    result.E[7] = n0;
    result.E[8] = n1;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = z238;
    result.A[10] = z239;
    result.A[11] = z240;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = -z246;
    result.A[16] = z247;
    result.A[17] = -z248;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = n0;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = z242;
    result.A[28] = z243;
    result.A[29] = z244;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = -z250;
    result.A[34] = z251;
    result.A[35] = -z252;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = -z148;
    result.B[4] = -z253;
    result.B[5] = -z254;
    result.B[6] = n0;
    result.B[7] = n0;
    result.B[8] = n0;
    result.B[9] = -z253;
    result.B[10] = z255;
    result.B[11] = -z256;
    result.B[12] = n0;
    result.B[13] = n0;
    result.B[14] = n0;
    result.B[15] = -z254;
    result.B[16] = -z257;
    result.B[17] = z258;
    if (!(traits::regular(-z147, n9012) && traits::regular(z65, z65))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[1] - result.M[1]) + (result.M[2] - result.M[2]) + (result.M[3] - result.M[3])
        + (result.M[4] - result.M[4]) + (result.M[6] - result.M[6]) + (result.C[3] - result.C[3]) + (result.C[4]
        - result.C[4]) + (result.C[5] - result.C[5]) + (result.C[6] - result.C[6]) + (result.C[7] - result.C[7])
        + (result.K[3] - result.K[3]) + (result.K[4] - result.K[4]) + (result.K[5] - result.K[5]) + (result.K[6]
        - result.K[6]) + (result.K[7] - result.K[7]) + (result.K[8] - result.K[8]) + (result.F[0] - result.F[0])
        + (result.F[1] - result.F[1]) + (result.F[2] - result.F[2]) + (result.A[9] - result.A[9]) + (result.A[10]
        - result.A[10]) + (result.A[11] - result.A[11]) + (result.A[15] - result.A[15]) + (result.A[16] - result.A[16])
        + (result.A[17] - result.A[17]) + (result.A[27] - result.A[27]) + (result.A[28] - result.A[28]) + (result.A[29]
        - result.A[29]) + (result.A[33] - result.A[33]) + (result.A[34] - result.A[34]) + (result.A[35] - result.A[35])
        + (result.B[3] - result.B[3]) + (result.B[4] - result.B[4]) + (result.B[5] - result.B[5]) + (result.B[9]
        - result.B[9]) + (result.B[10] - result.B[10]) + (result.B[11] - result.B[11]) + (result.B[15] - result.B[15])
        + (result.B[16] - result.B[16]) + (result.B[17] - result.B[17]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace nose_radar
