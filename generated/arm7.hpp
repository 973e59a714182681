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
//   mass_matrix             162              181          0             0                  6       0    355     395
//   bias                    266              292          0             0                  6       0    570     684
//   inverse_dynamics        285              300          0             0                  6       0    597     715
//   forward_dynamics        515              586          6             0                  6       0   1119    1273
//   energy                  221              307          0             0                  6       0    540     577
//   linearisation          2054             2394          6             0                  6       0   4466    4732
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
    const Scalar k0 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k1 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k8 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k9 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k12 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k13 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k14 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k15 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k18 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k22 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k23 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k24 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k25 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k26 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k28 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k31 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k32 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k33 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k38 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k39 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k40 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k43 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k44 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k45 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k46 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k47 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k48 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
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
    const Scalar z469 = k4 + n16_over_15 * z466;
    const Scalar z470 = c_q6 * z465;
    const Scalar z471 = s_q6 * z465;
    const Scalar z472 = s_q6 * z469 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z469;
    const Scalar z474 = s_q5 * z466 - c_q5 * z470;
    const Scalar z475 = s_q5 * z470 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n256_over_55 * z475 - z476;
    const Scalar z479 = z473 + z475;
    const Scalar z480 = z471 - n256_over_55 * z474 - z477;
    const Scalar z481 = s_q4 * z471 + c_q4 * z474;
    const Scalar z482 = s_q4 * z474 - c_q4 * z471;
    const Scalar z483 = s_q4 * z479 - c_q4 * z478;
    const Scalar z484 = s_q4 * z478 + c_q4 * z479;
    const Scalar z485 = z480 + z482;
    const Scalar z486 = z475 - z484;
    const Scalar z487 = s_q3 * z475 + c_q3 * z481;
    const Scalar z488 = s_q3 * z481 - c_q3 * z475;
    const Scalar z489 = s_q3 * z485 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z485;
    const Scalar z491 = n632_over_165 * z488 - z489;
    const Scalar z492 = n632_over_165 * z487 - z490;
    const Scalar z496 = s_q2 * z491 - c_q2 * z486;
    const Scalar z497 = k8 * s_q7 - k9 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k8 - z498;
    const Scalar z500 = k10 + c_q7 * z497;
    const Scalar z501 = n16_over_15 * z465 - z500;
    const Scalar z502 = k4 + n32_over_15 * z466;
    const Scalar z503 = n32_over_15 * z466 + z498;
    const Scalar z504 = k12 + z466;
    const Scalar z505 = k13 - z499;
    const Scalar z506 = k14 - z467;
    const Scalar z507 = k15 + z501;
    const Scalar z508 = k16 + z468;
    const Scalar z509 = k17 + z503;
    const Scalar z510 = s_q6 * z504 - k18 * c_q6;
    const Scalar z511 = k18 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n256_over_55 * z515 + z516;
    const Scalar z519 = z513 - z515;
    const Scalar z520 = z511 - n256_over_55 * z514 - z517;
    const Scalar z521 = s_q4 * z511 + c_q4 * z514;
    const Scalar z522 = s_q4 * z514 - c_q4 * z511;
    const Scalar z523 = s_q4 * z519 + c_q4 * z518;
    const Scalar z524 = s_q4 * z518 - c_q4 * z519;
    const Scalar z525 = z520 + z522;
    const Scalar z526 = z515 - z524;
    const Scalar z527 = s_q3 * z515 - c_q3 * z521;
    const Scalar z528 = s_q3 * z521 + c_q3 * z515;
    const Scalar z529 = s_q3 * z525 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z525;
    const Scalar z531 = n632_over_165 * z528 - z529;
    const Scalar z532 = n632_over_165 * z527 + z530;
    const Scalar z536 = s_q2 * z531 + c_q2 * z526;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k20 - z511;
    const Scalar z545 = k21 - z465;
    const Scalar z546 = k22 - z541;
    const Scalar z547 = k23 - z512;
    const Scalar z548 = k24 + z543;
    const Scalar z549 = k25 + z513;
    const Scalar z550 = k26 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n256_over_55 * z552 - z553;
    const Scalar z556 = z550 + z552;
    const Scalar z557 = n256_over_55 * z551 - z554;
    const Scalar z558 = c_q4 * z551;
    const Scalar z559 = s_q4 * z551;
    const Scalar z560 = s_q4 * z556 - c_q4 * z555;
    const Scalar z561 = s_q4 * z555 + c_q4 * z556;
    const Scalar z562 = z557 - z559;
    const Scalar z563 = z552 - z561;
    const Scalar z564 = s_q3 * z552 + c_q3 * z558;
    const Scalar z565 = s_q3 * z558 - c_q3 * z552;
    const Scalar z566 = s_q3 * z562 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z562;
    const Scalar z568 = n632_over_165 * z565 + z566;
    const Scalar z569 = n632_over_165 * z564 - z567;
    const Scalar z573 = s_q2 * z568 - c_q2 * z563;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n512_over_55 * z510 + z578;
    const Scalar z582 = z510 + n256_over_55 * z552 - z553;
    const Scalar z583 = z551 + z580;
    const Scalar z584 = z550 + n2 * z552;
    const Scalar z585 = n512_over_55 * z510 + n2 * z552 + z579;
    const Scalar z586 = k28 + z552;
    const Scalar z587 = k29 + z510;
    const Scalar z588 = k30 + z581;
    const Scalar z589 = k31 + z582;
    const Scalar z590 = k32 + z583;
    const Scalar z591 = k33 + z557;
    const Scalar z592 = k34 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = z592 - z594;
    const Scalar z598 = c_q3 * z593;
    const Scalar z599 = s_q3 * z593;
    const Scalar z600 = s_q3 * z597 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z597;
    const Scalar z602 = n632_over_165 * z599 - z600;
    const Scalar z603 = n632_over_165 * z598 + z601;
    const Scalar z607 = s_q2 * z602 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = z551 - z595;
    const Scalar z616 = z593 - z614;
    const Scalar z617 = z592 - n2 * z594;
    const Scalar z618 = n2 * z594 - z613;
    const Scalar z619 = k35 - z594;
    const Scalar z620 = k36 - z551;
    const Scalar z621 = k37 + z612;
    const Scalar z622 = k38 - z615;
    const Scalar z623 = k39 - z616;
    const Scalar z624 = k40 + z596;
    const Scalar z625 = k41 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n632_over_165 * z627 + z628;
    const Scalar z631 = n632_over_165 * z626 + z629;
    const Scalar z635 = s_q2 * z630 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = k42 * z593 - z640;
    const Scalar z644 = k42 * z593 - z641;
    const Scalar z647 = k43 - z643;
    const Scalar z648 = k44 + z630;
    const Scalar z649 = k45 - z642;
    const Scalar z650 = k46 + z631;
    const Scalar z651 = k47 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k48 + z661;
    mass[0] = z669;
    mass[1] = -z655;
    mass[2] = -z635;
    mass[3] = z607;
    mass[4] = z573;
    mass[5] = -z536;
    mass[6] = z496;
    mass[7] = -z655;
    mass[8] = z651;
    mass[9] = -z631;
    mass[10] = z603;
    mass[11] = z569;
    mass[12] = z532;
    mass[13] = z492;
    mass[14] = -z635;
    mass[15] = -z631;
    mass[16] = z625;
    mass[17] = z596;
    mass[18] = -z563;
    mass[19] = -z526;
    mass[20] = -z486;
    mass[21] = z607;
    mass[22] = z603;
    mass[23] = z596;
    mass[24] = z592;
    mass[25] = -z557;
    mass[26] = -z520;
    mass[27] = z480;
    mass[28] = z573;
    mass[29] = z569;
    mass[30] = -z563;
    mass[31] = -z557;
    mass[32] = z550;
    mass[33] = -z513;
    mass[34] = z473;
    mass[35] = -z536;
    mass[36] = z532;
    mass[37] = -z526;
    mass[38] = -z520;
    mass[39] = -z513;
    mass[40] = z509;
    mass[41] = -z468;
    mass[42] = z496;
    mass[43] = z492;
    mass[44] = -z486;
    mass[45] = z480;
    mass[46] = z473;
    mass[47] = -z468;
    mass[48] = k4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k5 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k6 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k7 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k9 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k10 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k11 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k12 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k13 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k14 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k15 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k18 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k19 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k20 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k21 = traits::constant(0.02914515311624745, 0.029145153f, "3643144139530931/125000000000000000");
    const Scalar k22 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k23 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k24 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k27 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k28 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k29 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k30 = traits::constant(0.011496343893347959, 0.011496344f, "11496343893347959/1000000000000000000");
    const Scalar k31 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k32 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k33 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k36 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k37 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k38 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k39 = traits::constant(0.6310729011877872, 0.6310729f, "631072901187787269/1000000000000000000");
    const Scalar k40 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k41 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k42 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k45 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k46 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k47 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k48 = traits::constant(0.07860781999140594, 0.07860782f, "19651954997851483/250000000000000000");
    const Scalar k49 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k50 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k51 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k52 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k53 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k54 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k55 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k56 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k57 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
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
    const Scalar z677 = k0 * s_q2;
    const Scalar z678 = k0 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z685 = n2 * z679;
    const Scalar z686 = c_q3 * z679;
    const Scalar z687 = s_q3 * z679;
    const Scalar z688 = z677 + n632_over_165 * z681;
    const Scalar z689 = z678 - n632_over_165 * z684;
    const Scalar z690 = n632_over_165 * z685;
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
    const Scalar z704 = z691 - z697;
    const Scalar z705 = z692 - z699;
    const Scalar z706 = z689 + z701;
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
    const Scalar z725 = z707 + z713 - n256_over_55 * z715;
    const Scalar z726 = z708 + z716 + n256_over_55 * z718;
    const Scalar z727 = z705 + z720 + n256_over_55 * z722;
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
    const Scalar z747 = z734 + n16_over_15 * z740;
    const Scalar z748 = z735 + n16_over_15 * z742;
    const Scalar z749 = z729 + n16_over_15 * z744;
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
    const Scalar z771 = k5 * z756 - k6 * z758;  // force on link7, times 0.0825 m, x
    const Scalar z772 = k5 * z759 + k6 * z761;  // force on link7, times 0.0825 m, y
    const Scalar z773 = k5 * z763 + k6 * z765;  // force on link7, times 0.0825 m, z
    const Scalar z774 = k6 * z748 + k7 * z759 - k8 * z763 + k9 * z765 + k10 * z766;  // moment on link7, x
    const Scalar z775 = k5 * z748 + k10 * z758 + k11 * z763 - k8 * z765 + k7 * z767;  // moment on link7, y
    // moment on link7, z
    const Scalar z776 = k12 * z737 + k6 * z750 + k5 * z751 + k13 * z757 + k7 * z768 + k10 * z769 + k8 * z770;
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
    const Scalar z791 = k14 * z740 + z777 + k15 * z781;  // force on link6, times 0.0825 m, x
    const Scalar z792 = k14 * z742 + z773 - k15 * z783;  // force on link6, times 0.0825 m, y
    const Scalar z793 = k14 * z744 - z778 - k15 * z785;  // force on link6, times 0.0825 m, z
    const Scalar z794 = k15 * z729 - k16 * z742 + k17 * z744 - z779 - k18 * z785 - k19 * z786;  // moment on link6, x
    // moment on link6, y
    const Scalar z795 = k14 * z729 + k20 * z744 + z776 - n16_over_15 * z778 + k19 * z781 - k17 * z785 + k16 * z787;
    // moment on link6, z
    const Scalar z796 = k21 * z731 + k15 * z734 + k14 * z735 - k22 * z741 + n16_over_15 * z773 + z780 + k16 * z788 + k19
        * z789 + k17 * z790;
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
    const Scalar z818 = z797 + k23 * z803 + k24 * z805;  // force on link5, times 0.0825 m, x
    const Scalar z819 = z793 - k23 * z806 + k24 * z808;  // force on link5, times 0.0825 m, y
    const Scalar z820 = z798 - k23 * z810 + k24 * z812;  // force on link5, times 0.0825 m, z
    const Scalar z821 = k24 * z726 - z799 - k25 * z806 + k26 * z810 + k27 * z812 - k28 * z813;  // moment on link5, x
    const Scalar z822 = k23 * z726 - z796 + k28 * z805 - k29 * z810 - k26 * z812 + k25 * z814;  // moment on link5, y
    // moment on link5, z
    const Scalar z823 = k30 * z710 + k24 * z728 - k23 * z729 + z800 + k31 * z804 - k25 * z815 - k28 * z816 - k26 * z817;
    const Scalar z824 = s_q5 * z819 + c_q5 * z818;
    const Scalar z825 = s_q5 * z818 - c_q5 * z819;
    const Scalar z826 = s_q5 * z822 - c_q5 * z821;
    const Scalar z827 = s_q5 * z821 + c_q5 * z822;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z830 = z709 - z721;
    const Scalar z831 = z710 - z719;
    const Scalar z832 = z711 - z717;
    const Scalar z833 = k32 * z713 - k33 * z715 + z824;  // force on link4, times 0.0825 m, x
    const Scalar z834 = k32 * z716 + k33 * z718 + z820;  // force on link4, times 0.0825 m, y
    const Scalar z835 = k32 * z720 + k33 * z722 + z825;  // force on link4, times 0.0825 m, z
    // moment on link4, x
    const Scalar z836 = k33 * z705 - k34 * z716 + k35 * z720 + k36 * z722 + n256_over_55 * z825 - z826 + k37 * z828;
    // moment on link4, y
    const Scalar z837 = k32 * z705 + k37 * z715 + k38 * z720 + k35 * z722 + z823 + z825 - k34 * z829;
    // moment on link4, z
    const Scalar z838 = k39 * z694 - k33 * z707 + k32 * z708 + k40 * z714 + z820 - n256_over_55 * z824 + z827 - k34
        * z830 + k37 * z831 - k35 * z832;
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
    const Scalar z853 = k41 * z697 - z839 - k42 * z843;  // force on link3, times 0.0825 m, x
    const Scalar z854 = k41 * z699 - z835 + k42 * z845;  // force on link3, times 0.0825 m, y
    const Scalar z856 = k42 * z689 + k43 * z699 + k44 * z701 + z841 + k45 * z847 - k46 * z848;  // moment on link3, x
    // moment on link3, y
    const Scalar z857 = k41 * z689 + k47 * z701 + z838 + z840 - k46 * z843 + k44 * z847 + k43 * z849;
    // moment on link3, z
    const Scalar z858 = k48 * z680 + k42 * z691 - k41 * z692 - k49 * z698 - z835 + z842 + k43 * z850 - k46 * z851 - k44
        * z852;
    const Scalar z859 = s_q3 * z854 - c_q3 * z853;
    const Scalar z860 = s_q3 * z853 + c_q3 * z854;
    const Scalar z861 = s_q3 * z857 + c_q3 * z856;
    const Scalar z862 = s_q3 * z856 - c_q3 * z857;
    const Scalar z863 = z36 * z36;
    const Scalar z865 = n2 * z680;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    // moment on link2, x
    const Scalar z872 = k50 * z681 - k51 * z685 + n632_over_165 * z860 + z861 - k52 * z865 - k53 * z866;
    const Scalar z873 = k53 * z681 - k52 * z685 - z858 - k54 * z865 - k50 * z867;  // moment on link2, y
    // moment on link2, z
    const Scalar z874 = k55 * z677 - k56 * z678 + k57 * z681 - n632_over_165 * z859 - z862 + k52 * z868;
    const Scalar z878 = s_q2 * z872 - c_q2 * z873;
    forces.q1 = -z878;
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
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k4 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k5 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k6 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k7 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k9 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k10 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k11 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k12 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k13 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k14 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k15 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k18 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k19 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k20 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k21 = traits::constant(0.02914515311624745, 0.029145153f, "3643144139530931/125000000000000000");
    const Scalar k22 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k23 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k24 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k27 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k28 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k29 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k30 = traits::constant(0.011496343893347959, 0.011496344f, "11496343893347959/1000000000000000000");
    const Scalar k31 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k32 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k33 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k36 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k37 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k38 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k39 = traits::constant(0.6310729011877872, 0.6310729f, "631072901187787269/1000000000000000000");
    const Scalar k40 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k41 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k45 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k46 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k47 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k48 = traits::constant(0.07860781999140594, 0.07860782f, "19651954997851483/250000000000000000");
    const Scalar k49 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k50 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k51 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k52 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k53 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k54 = traits::constant(0.9793493837268126, 0.9793494f, "489674691863406311/500000000000000000");
    const Scalar k55 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k56 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k57 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
    const Scalar k58 = traits::constant(0.014259565994474374, 0.014259566f, "7129782997237187/500000000000000000");
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
    const Scalar z677 = k0 * s_q2;
    const Scalar z678 = k0 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z689 = z678 - n632_over_165 * z684;
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
    const Scalar z892 = z677 - n632_over_165 * z888;
    const Scalar z893 = n632_over_165 * z889;
    const Scalar z894 = s_q3 * z893 - c_q3 * z892;
    const Scalar z895 = s_q3 * z892 + c_q3 * z893;
    const Scalar z896 = v_q3 * z40 + z890;  // angular acceleration of link3, x
    const Scalar z897 = v_q3 * z39 - z891;  // angular acceleration of link3, y
    const Scalar z898 = a_q3 - z887;  // angular acceleration of link3, z
    const Scalar z899 = z698 + z898;
    const Scalar z900 = z700 + z897;
    const Scalar z901 = s_q4 * z898 + c_q4 * z896;
    const Scalar z902 = s_q4 * z896 - c_q4 * z898;
    const Scalar z903 = z697 - z894;
    const Scalar z904 = z895 + z899;
    const Scalar z905 = z689 + z900;
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
    const Scalar z917 = z713 + z906 - n256_over_55 * z911;
    const Scalar z918 = n256_over_55 * z718 - z907 - z912;
    const Scalar z919 = z904 + z913 + n256_over_55 * z914;
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
    const Scalar z936 = n16_over_15 * z740 + z927;
    const Scalar z937 = z928 - n16_over_15 * z932;
    const Scalar z938 = z921 + n16_over_15 * z933;
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
    const Scalar z950 = k4 * z756 - k5 * z944;  // force on link7, times 0.0825 m, x
    const Scalar z951 = k5 * z761 - k4 * z945;  // force on link7, times 0.0825 m, y
    const Scalar z952 = k4 * z946 + k5 * z947;  // force on link7, times 0.0825 m, z
    const Scalar z953 = k6 * z766 + k5 * z937 - k7 * z945 - k8 * z946 + k9 * z947;  // moment on link7, x
    const Scalar z954 = k7 * z767 + k4 * z937 + k6 * z944 + k10 * z946 - k8 * z947;  // moment on link7, y
    // moment on link7, z
    const Scalar z955 = k11 * z757 + k8 * z770 + k5 * z939 + k4 * z940 + k12 * z943 - k7 * z948 - k6 * z949;
    const Scalar z956 = s_q7 * z951 + c_q7 * z950;
    const Scalar z957 = s_q7 * z950 - c_q7 * z951;
    const Scalar z958 = s_q7 * z954 - c_q7 * z953;
    const Scalar z959 = s_q7 * z953 + c_q7 * z954;
    const Scalar z960 = z741 - z931;
    const Scalar z961 = z784 + z929;
    const Scalar z962 = z784 - z929;
    const Scalar z963 = z743 - z930;
    const Scalar z964 = k13 * z740 + z956 + k14 * z960;  // force on link6, times 0.0825 m, x
    const Scalar z965 = k14 * z783 + k13 * z932 - z952;  // force on link6, times 0.0825 m, y
    const Scalar z966 = k13 * z933 - z957 - k14 * z961;  // force on link6, times 0.0825 m, z
    const Scalar z967 = k15 * z786 - k14 * z921 - k16 * z932 - k17 * z933 + z958 + k18 * z961;  // moment on link6, x
    // moment on link6, y
    const Scalar z968 = k16 * z787 + k13 * z921 + k19 * z933 + z955 - n16_over_15 * z957 + k15 * z960 - k17 * z961;
    // moment on link6, z
    const Scalar z969 = k20 * z741 - k17 * z790 - k14 * z927 - k13 * z928 + k21 * z931 - n16_over_15 * z952 - z959 + k16
        * z962 + k15 * z963;
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
    const Scalar z980 = k22 * z803 - z970 + k23 * z974;  // force on link5, times 0.0825 m, x
    const Scalar z981 = k23 * z808 + z966 + k22 * z975;  // force on link5, times 0.0825 m, y
    const Scalar z982 = z971 - k22 * z976 + k23 * z977;  // force on link5, times 0.0825 m, z
    const Scalar z983 = k24 * z813 - k23 * z918 + z972 - k25 * z975 - k26 * z976 - k27 * z977;  // moment on link5, x
    const Scalar z984 = k25 * z814 + k22 * z918 + z969 + k24 * z974 - k28 * z976 - k26 * z977;  // moment on link5, y
    // moment on link5, z
    const Scalar z985 = k29 * z804 - k26 * z817 + k23 * z920 - k22 * z921 - k30 * z924 - z973 + k25 * z978 + k24 * z979;
    const Scalar z986 = s_q5 * z981 + c_q5 * z980;
    const Scalar z987 = s_q5 * z980 - c_q5 * z981;
    const Scalar z988 = s_q5 * z984 + c_q5 * z983;
    const Scalar z989 = s_q5 * z983 - c_q5 * z984;
    const Scalar z990 = z721 - z908;
    const Scalar z991 = z719 - z909;
    const Scalar z992 = k31 * z713 - k32 * z911 + z986;  // force on link4, times 0.0825 m, x
    const Scalar z993 = k32 * z718 - k31 * z912 + z982;  // force on link4, times 0.0825 m, y
    const Scalar z994 = k31 * z913 + k32 * z914 + z987;  // force on link4, times 0.0825 m, z
    // moment on link4, x
    const Scalar z995 = k33 * z828 + k32 * z904 + k34 * z912 + k35 * z913 + k36 * z914 + n256_over_55 * z987 - z988;
    // moment on link4, y
    const Scalar z996 = k34 * z829 - k31 * z904 - k33 * z911 - k37 * z913 - k35 * z914 - z985 - z987;
    // moment on link4, z
    const Scalar z997 = k38 * z714 - k35 * z832 - k32 * z906 - k31 * z907 + k39 * z910 + z982 - n256_over_55 * z986
        - z989 + k34 * z990 - k33 * z991;
    const Scalar z998 = s_q4 * z993 + c_q4 * z992;
    const Scalar z999 = s_q4 * z992 - c_q4 * z993;
    const Scalar z1000 = s_q4 * z996 + c_q4 * z995;
    const Scalar z1001 = s_q4 * z995 - c_q4 * z996;
    const Scalar z1002 = z698 - z898;
    const Scalar z1003 = z846 + z896;
    const Scalar z1004 = z846 - z896;
    const Scalar z1005 = z700 - z897;
    const Scalar z1006 = k40 * z697 - z998 - k41 * z1002;  // force on link3, times 0.0825 m, x
    const Scalar z1007 = k41 * z845 - k40 * z899 - z994;  // force on link3, times 0.0825 m, y
    const Scalar z1009 = k41 * z689 - k42 * z848 - k43 * z899 + k44 * z900 - z1000 + k45 * z1003;  // moment on link3, x
    // moment on link3, y
    const Scalar z1010 = k40 * z689 + k43 * z849 + k46 * z900 + z997 + z999 - k42 * z1002 + k44 * z1003;
    // moment on link3, z
    const Scalar z1011 = k47 * z698 + k44 * z852 - k41 * z894 + k40 * z895 + k48 * z898 + z994 - z1001 + k43 * z1004
        - k42 * z1005;
    const Scalar z1012 = s_q3 * z1007 - c_q3 * z1006;
    const Scalar z1013 = s_q3 * z1006 + c_q3 * z1007;
    const Scalar z1014 = s_q3 * z1010 + c_q3 * z1009;
    const Scalar z1015 = s_q3 * z1009 - c_q3 * z1010;
    const Scalar z1016 = a_q2 + z681;
    const Scalar z1017 = z680 + z887;
    const Scalar z1018 = z679 - z886;
    const Scalar z1019 = z680 - z887;
    // moment on link2, x
    const Scalar z1023 = k49 * z866 + k50 * z889 - n632_over_165 * z1013 - z1014 - k51 * z1016 + k52 * z1017;
    const Scalar z1024 = k51 * z867 + k49 * z888 + k52 * z889 - z1011 + k53 * z1017;  // moment on link2, y
    // moment on link2, z
    const Scalar z1025 = k54 * a_q2 - k55 * z677 + k56 * z678 - k57 * z681 - k52 * z868 + n632_over_165 * z1012 + z1015
        + k51 * z1018 - k49 * z1019;
    const Scalar z1029 = s_q2 * z1023 - c_q2 * z1024;
    const Scalar z1034 = k58 * a_q1 + z1029;  // moment on link1, z
    forces.q1 = z1034;
    forces.q2 = z1025;
    forces.q3 = z1011;
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
    const Scalar k0 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k1 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k8 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k9 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k12 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k13 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k14 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k15 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k18 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k22 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k23 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k24 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k25 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k26 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k28 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k31 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k32 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k33 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k38 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k39 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k40 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k43 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k44 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k45 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k46 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k47 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k48 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar k49 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar k50 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k51 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k52 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k54 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k55 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k56 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k57 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k58 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k59 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k60 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k61 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k62 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k63 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k64 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k65 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k66 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k67 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k68 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k69 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k70 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
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
    const Scalar z469 = k4 + n16_over_15 * z466;
    const Scalar z470 = c_q6 * z465;
    const Scalar z471 = s_q6 * z465;
    const Scalar z472 = s_q6 * z469 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z469;
    const Scalar z474 = s_q5 * z466 - c_q5 * z470;
    const Scalar z475 = s_q5 * z470 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n256_over_55 * z475 - z476;
    const Scalar z479 = z473 + z475;
    const Scalar z480 = z471 - n256_over_55 * z474 - z477;
    const Scalar z481 = s_q4 * z471 + c_q4 * z474;
    const Scalar z482 = s_q4 * z474 - c_q4 * z471;
    const Scalar z483 = s_q4 * z479 - c_q4 * z478;
    const Scalar z484 = s_q4 * z478 + c_q4 * z479;
    const Scalar z485 = z480 + z482;
    const Scalar z486 = z475 - z484;
    const Scalar z487 = s_q3 * z475 + c_q3 * z481;
    const Scalar z488 = s_q3 * z481 - c_q3 * z475;
    const Scalar z489 = s_q3 * z485 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z485;
    const Scalar z491 = n632_over_165 * z488 - z489;
    const Scalar z492 = n632_over_165 * z487 - z490;
    const Scalar z496 = s_q2 * z491 - c_q2 * z486;
    const Scalar z497 = k8 * s_q7 - k9 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k8 - z498;
    const Scalar z500 = k10 + c_q7 * z497;
    const Scalar z501 = n16_over_15 * z465 - z500;
    const Scalar z502 = k4 + n32_over_15 * z466;
    const Scalar z503 = n32_over_15 * z466 + z498;
    const Scalar z504 = k12 + z466;
    const Scalar z505 = k13 - z499;
    const Scalar z506 = k14 - z467;
    const Scalar z507 = k15 + z501;
    const Scalar z508 = k16 + z468;
    const Scalar z509 = k17 + z503;
    const Scalar z510 = s_q6 * z504 - k18 * c_q6;
    const Scalar z511 = k18 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n256_over_55 * z515 + z516;
    const Scalar z519 = z513 - z515;
    const Scalar z520 = z511 - n256_over_55 * z514 - z517;
    const Scalar z521 = s_q4 * z511 + c_q4 * z514;
    const Scalar z522 = s_q4 * z514 - c_q4 * z511;
    const Scalar z523 = s_q4 * z519 + c_q4 * z518;
    const Scalar z524 = s_q4 * z518 - c_q4 * z519;
    const Scalar z525 = z520 + z522;
    const Scalar z526 = z515 - z524;
    const Scalar z527 = s_q3 * z515 - c_q3 * z521;
    const Scalar z528 = s_q3 * z521 + c_q3 * z515;
    const Scalar z529 = s_q3 * z525 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z525;
    const Scalar z531 = n632_over_165 * z528 - z529;
    const Scalar z532 = n632_over_165 * z527 + z530;
    const Scalar z536 = s_q2 * z531 + c_q2 * z526;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k20 - z511;
    const Scalar z545 = k21 - z465;
    const Scalar z546 = k22 - z541;
    const Scalar z547 = k23 - z512;
    const Scalar z548 = k24 + z543;
    const Scalar z549 = k25 + z513;
    const Scalar z550 = k26 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n256_over_55 * z552 - z553;
    const Scalar z556 = z550 + z552;
    const Scalar z557 = n256_over_55 * z551 - z554;
    const Scalar z558 = c_q4 * z551;
    const Scalar z559 = s_q4 * z551;
    const Scalar z560 = s_q4 * z556 - c_q4 * z555;
    const Scalar z561 = s_q4 * z555 + c_q4 * z556;
    const Scalar z562 = z557 - z559;
    const Scalar z563 = z552 - z561;
    const Scalar z564 = s_q3 * z552 + c_q3 * z558;
    const Scalar z565 = s_q3 * z558 - c_q3 * z552;
    const Scalar z566 = s_q3 * z562 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z562;
    const Scalar z568 = n632_over_165 * z565 + z566;
    const Scalar z569 = n632_over_165 * z564 - z567;
    const Scalar z573 = s_q2 * z568 - c_q2 * z563;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n512_over_55 * z510 + z578;
    const Scalar z582 = z510 + n256_over_55 * z552 - z553;
    const Scalar z583 = z551 + z580;
    const Scalar z584 = z550 + n2 * z552;
    const Scalar z585 = n512_over_55 * z510 + n2 * z552 + z579;
    const Scalar z586 = k28 + z552;
    const Scalar z587 = k29 + z510;
    const Scalar z588 = k30 + z581;
    const Scalar z589 = k31 + z582;
    const Scalar z590 = k32 + z583;
    const Scalar z591 = k33 + z557;
    const Scalar z592 = k34 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = z592 - z594;
    const Scalar z598 = c_q3 * z593;
    const Scalar z599 = s_q3 * z593;
    const Scalar z600 = s_q3 * z597 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z597;
    const Scalar z602 = n632_over_165 * z599 - z600;
    const Scalar z603 = n632_over_165 * z598 + z601;
    const Scalar z607 = s_q2 * z602 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = z551 - z595;
    const Scalar z616 = z593 - z614;
    const Scalar z617 = z592 - n2 * z594;
    const Scalar z618 = n2 * z594 - z613;
    const Scalar z619 = k35 - z594;
    const Scalar z620 = k36 - z551;
    const Scalar z621 = k37 + z612;
    const Scalar z622 = k38 - z615;
    const Scalar z623 = k39 - z616;
    const Scalar z624 = k40 + z596;
    const Scalar z625 = k41 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n632_over_165 * z627 + z628;
    const Scalar z631 = n632_over_165 * z626 + z629;
    const Scalar z635 = s_q2 * z630 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = k42 * z593 - z640;
    const Scalar z644 = k42 * z593 - z641;
    const Scalar z647 = k43 - z643;
    const Scalar z648 = k44 + z630;
    const Scalar z649 = k45 - z642;
    const Scalar z650 = k46 + z631;
    const Scalar z651 = k47 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k48 + z661;
    const Scalar z677 = k49 * s_q2;
    const Scalar z678 = k49 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z685 = n2 * z679;
    const Scalar z686 = c_q3 * z679;
    const Scalar z687 = s_q3 * z679;
    const Scalar z688 = z677 + n632_over_165 * z681;
    const Scalar z689 = z678 - n632_over_165 * z684;
    const Scalar z690 = n632_over_165 * z685;
    const Scalar z691 = s_q3 * z690 - c_q3 * z688;
    const Scalar z692 = s_q3 * z688 + c_q3 * z690;
    const Scalar z693 = v_q3 * z40 - z686;  // angular acceleration of link3, x
    const Scalar z694 = v_q3 * z39 - z687;  // angular acceleration of link3, y
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z700 = z39 * z43;
    const Scalar z701 = z694 + z700;
    const Scalar z704 = z691 - z697;
    const Scalar z706 = z689 + z701;
    const Scalar z707 = s_q4 * z706 + c_q4 * z704;
    const Scalar z708 = s_q4 * z704 - c_q4 * z706;
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
    const Scalar z847 = z693 + z846;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z850 = z693 - z846;
    const Scalar z851 = z694 - z700;
    const Scalar z852 = z695 - z844;
    const Scalar z863 = z36 * z36;
    const Scalar z865 = n2 * z680;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z1366 = c_q4 * z693;
    const Scalar z1367 = s_q4 * z693;
    const Scalar z1368 = z692 + z698;
    const Scalar z1369 = v_q4 * z47 - z1366;  // angular acceleration of link4, x
    const Scalar z1370 = v_q4 * z46 + z1367;  // angular acceleration of link4, y
    const Scalar z1371 = z719 + z1370;
    const Scalar z1372 = z721 + z1369;
    const Scalar z1373 = c_q5 * z1369;
    const Scalar z1374 = s_q5 * z1369;
    const Scalar z1375 = z707 + z713 - n256_over_55 * z714;
    const Scalar z1376 = z708 - z714 + n256_over_55 * z718;
    const Scalar z1377 = z1368 + z1371 + n256_over_55 * z1372;
    const Scalar z1378 = s_q5 * z1377 + c_q5 * z1375;
    const Scalar z1379 = s_q5 * z1375 - c_q5 * z1377;
    const Scalar z1380 = v_q5 * z55 + z1373;  // angular acceleration of link5, x
    const Scalar z1381 = v_q5 * z54 + z1374;  // angular acceleration of link5, y
    const Scalar z1382 = c_q6 * z1380;
    const Scalar z1383 = s_q6 * z1380;
    const Scalar z1384 = s_q6 * z1376 - c_q6 * z1378;
    const Scalar z1385 = s_q6 * z1378 + c_q6 * z1376;
    const Scalar z1386 = v_q6 * z60 - z1382;  // angular acceleration of link6, x
    const Scalar z1387 = v_q6 * z59 - z1383;  // angular acceleration of link6, y
    const Scalar z1388 = z743 + z1387;
    const Scalar z1389 = c_q7 * z1386;
    const Scalar z1390 = s_q7 * z1386;
    const Scalar z1391 = n16_over_15 * z740 + z1384;
    const Scalar z1392 = n16_over_15 * z741 - z1385;
    const Scalar z1393 = z1379 + n16_over_15 * z1388;
    const Scalar z1394 = s_q7 * z1393 - c_q7 * z1391;
    const Scalar z1395 = s_q7 * z1391 + c_q7 * z1393;
    const Scalar z1396 = v_q7 * z67 - z1389;  // angular acceleration of link7, x
    const Scalar z1397 = v_q7 * z66 + z1390;  // angular acceleration of link7, y
    const Scalar z1398 = z762 + z1397;
    const Scalar z1399 = z764 + z1396;
    const Scalar z1400 = z764 - z1396;
    const Scalar z1401 = z762 - z1397;
    const Scalar z1402 = k0 * z756 - k1 * z757;
    const Scalar z1403 = k0 * z757 - k1 * z761;
    const Scalar z1404 = k0 * z1398 + k1 * z1399;
    const Scalar z1405 = k3 * z757 - k2 * z766 + k1 * z1392 + k10 * z1398 - k50 * z1399;
    const Scalar z1406 = k2 * z757 + k3 * z767 - k0 * z1392 + k51 * z1398 - k10 * z1399;
    const Scalar z1407 = k8 * z757 + k10 * z770 + k1 * z1394 + k0 * z1395 - k3 * z1400 - k2 * z1401;
    const Scalar z1408 = u_tau7 - z1407;
    const Scalar z1418 = z784 + z1386;
    const Scalar z1419 = z784 - z1386;
    const Scalar z1420 = z743 - z1387;
    const Scalar z1422 = k12 * z741 + k18 * z783 - z1404;
    const Scalar z1438 = z809 + z1381;
    const Scalar z1439 = z811 + z1380;
    const Scalar z1440 = z811 - z1380;
    const Scalar z1441 = z809 - z1381;
    const Scalar z1459 = z721 - z1369;
    const Scalar z1460 = z719 - z1370;
    const Scalar z1576 = k52 * z496;
    const Scalar z1577 = k52 * z492;
    const Scalar z1578 = k52 * z486;
    const Scalar z1579 = k52 * z480;
    const Scalar z1580 = k52 * z473;
    const Scalar z1581 = k52 * z468;
    const Scalar z1582 = z496 * z1576 - z669;
    const Scalar z1583 = z496 * z1577 + z655;
    const Scalar z1584 = z492 * z1577 - z651;
    const Scalar z1585 = z496 * z1578 - z635;
    const Scalar z1586 = z492 * z1578 - z631;
    const Scalar z1587 = z486 * z1578 - z625;
    const Scalar z1588 = z496 * z1579 - z607;
    const Scalar z1589 = z492 * z1579 - z603;
    const Scalar z1590 = z486 * z1579 + z596;
    const Scalar z1591 = z480 * z1579 - z592;
    const Scalar z1592 = z496 * z1580 - z573;
    const Scalar z1593 = z492 * z1580 - z569;
    const Scalar z1594 = z486 * z1580 - z563;
    const Scalar z1595 = z480 * z1580 + z557;
    const Scalar z1596 = z473 * z1580 - z550;
    const Scalar z1597 = z496 * z1581 - z536;
    const Scalar z1598 = z492 * z1581 + z532;
    const Scalar z1599 = z486 * z1581 + z526;
    const Scalar z1600 = z480 * z1581 - z520;
    const Scalar z1601 = z473 * z1581 - z513;
    const Scalar z1602 = z468 * z1581 - z509;
    const Scalar z1603 = n1 / z1602;
    const Scalar z1604 = z1597 * z1603;
    const Scalar z1605 = z1598 * z1603;
    const Scalar z1606 = z1599 * z1603;
    const Scalar z1607 = z1600 * z1603;
    const Scalar z1608 = z1601 * z1603;
    const Scalar z1609 = z1582 - z1597 * z1604;
    const Scalar z1610 = z1583 - z1597 * z1605;
    const Scalar z1611 = z1584 - z1598 * z1605;
    const Scalar z1612 = z1585 - z1597 * z1606;
    const Scalar z1613 = z1586 - z1598 * z1606;
    const Scalar z1614 = z1587 - z1599 * z1606;
    const Scalar z1615 = z1588 - z1597 * z1607;
    const Scalar z1616 = z1589 - z1598 * z1607;
    const Scalar z1617 = z1590 - z1599 * z1607;
    const Scalar z1618 = z1591 - z1600 * z1607;
    const Scalar z1619 = z1592 - z1597 * z1608;
    const Scalar z1620 = z1593 - z1598 * z1608;
    const Scalar z1621 = z1594 - z1599 * z1608;
    const Scalar z1622 = z1595 - z1600 * z1608;
    const Scalar z1623 = z1596 - z1601 * z1608;
    const Scalar z1624 = n1 / z1623;
    const Scalar z1625 = z1619 * z1624;
    const Scalar z1626 = z1620 * z1624;
    const Scalar z1627 = z1621 * z1624;
    const Scalar z1628 = z1622 * z1624;
    const Scalar z1629 = z1609 - z1619 * z1625;
    const Scalar z1630 = z1610 - z1619 * z1626;
    const Scalar z1631 = z1611 - z1620 * z1626;
    const Scalar z1632 = z1612 - z1619 * z1627;
    const Scalar z1633 = z1613 - z1620 * z1627;
    const Scalar z1634 = z1614 - z1621 * z1627;
    const Scalar z1635 = z1615 - z1619 * z1628;
    const Scalar z1636 = z1616 - z1620 * z1628;
    const Scalar z1637 = z1617 - z1621 * z1628;
    const Scalar z1638 = z1618 - z1622 * z1628;
    const Scalar z1639 = n1 / z1638;
    const Scalar z1640 = z1635 * z1639;
    const Scalar z1641 = z1636 * z1639;
    const Scalar z1642 = z1637 * z1639;
    const Scalar z1643 = z1629 - z1635 * z1640;
    const Scalar z1644 = z1630 - z1635 * z1641;
    const Scalar z1645 = z1631 - z1636 * z1641;
    const Scalar z1646 = z1632 - z1635 * z1642;
    const Scalar z1647 = z1633 - z1636 * z1642;
    const Scalar z1648 = z1634 - z1637 * z1642;
    const Scalar z1649 = n1 / z1648;
    const Scalar z1650 = z1646 * z1649;
    const Scalar z1651 = z1647 * z1649;
    const Scalar z1652 = z1643 - z1646 * z1650;
    const Scalar z1653 = z1644 - z1646 * z1651;
    const Scalar z1654 = z1645 - z1647 * z1651;
    const Scalar z1655 = n1 / z1654;
    const Scalar z1656 = z1653 * z1655;
    const Scalar z1657 = z1652 - z1653 * z1656;
    const Scalar z1658 = n1 / z1657;
    const Scalar z1672 = s_q7 * z1403 - c_q7 * z1402;
    const Scalar z1673 = s_q7 * z1402 + c_q7 * z1403;
    const Scalar z1674 = s_q7 * z1406 + c_q7 * z1405;
    const Scalar z1675 = s_q7 * z1405 - c_q7 * z1406;
    const Scalar z1676 = k12 * z740 + k18 * z741 - z1672;  // force on link6, times 0.0825 m, x
    const Scalar z1677 = k12 * z1388 - k18 * z1418 - z1673;  // force on link6, times 0.0825 m, z
    // moment on link6, x
    const Scalar z1678 = k15 * z741 - k16 * z786 + k18 * z1379 + k14 * z1388 - k54 * z1418 - z1674;
    // moment on link6, y
    const Scalar z1679 = k16 * z741 + k15 * z787 + k12 * z1379 + k55 * z1388 + z1407 - k14 * z1418 - n16_over_15
        * z1673;
    // moment on link6, z
    const Scalar z1680 = k56 * z741 - k14 * z790 - k18 * z1384 - k12 * z1385 - n16_over_15 * z1404 + k15 * z1419 + k16
        * z1420 + z1675;
    const Scalar z1681 = s_q6 * z1422 + c_q6 * z1676;
    const Scalar z1682 = s_q6 * z1676 - c_q6 * z1422;
    const Scalar z1683 = s_q6 * z1679 - c_q6 * z1678;
    const Scalar z1684 = s_q6 * z1678 + c_q6 * z1679;
    const Scalar z1685 = k20 * z803 + k21 * z804 - z1681;  // force on link5, times 0.0825 m, x
    const Scalar z1686 = k20 * z804 + k21 * z808 + z1677;  // force on link5, times 0.0825 m, y
    const Scalar z1687 = k20 * z1438 - k21 * z1439 - z1682;  // force on link5, times 0.0825 m, z
    // moment on link5, x
    const Scalar z1688 = k24 * z804 - k25 * z813 + k21 * z1376 + k23 * z1438 + k57 * z1439 - z1683;
    // moment on link5, y
    const Scalar z1689 = k25 * z804 + k24 * z814 + k20 * z1376 - k58 * z1438 - k23 * z1439 + z1680;
    // moment on link5, z
    const Scalar z1690 = k59 * z804 - k23 * z817 + k21 * z1378 - k20 * z1379 + k24 * z1440 + k25 * z1441 + z1684;
    const Scalar z1691 = s_q5 * z1686 + c_q5 * z1685;
    const Scalar z1692 = s_q5 * z1685 - c_q5 * z1686;
    const Scalar z1693 = s_q5 * z1689 - c_q5 * z1688;
    const Scalar z1694 = s_q5 * z1688 + c_q5 * z1689;
    const Scalar z1695 = k28 * z713 - k29 * z714 + z1691;  // force on link4, times 0.0825 m, x
    const Scalar z1696 = k28 * z714 - k29 * z718 + z1687;  // force on link4, times 0.0825 m, y
    const Scalar z1697 = k28 * z1371 + k29 * z1372 + z1692;  // force on link4, times 0.0825 m, z
    // moment on link4, x
    const Scalar z1698 = k32 * z714 + k33 * z828 + k29 * z1368 + k31 * z1371 + k60 * z1372 + n256_over_55 * z1692
        - z1693;
    // moment on link4, y
    const Scalar z1699 = k33 * z714 - k32 * z829 + k28 * z1368 + k61 * z1371 + k31 * z1372 + z1690 + z1692;
    // moment on link4, z
    const Scalar z1700 = k29 * z707 - k28 * z708 - k62 * z714 + k31 * z832 - k32 * z1459 + k33 * z1460 + z1687
        + n256_over_55 * z1691 - z1694;
    const Scalar z1701 = s_q4 * z1696 - c_q4 * z1695;
    const Scalar z1702 = s_q4 * z1695 + c_q4 * z1696;
    const Scalar z1703 = s_q4 * z1699 - c_q4 * z1698;
    const Scalar z1704 = s_q4 * z1698 + c_q4 * z1699;
    const Scalar z1705 = k35 * z697 - k36 * z698 + z1701;  // force on link3, times 0.0825 m, x
    const Scalar z1706 = k35 * z698 - k36 * z845 + z1697;  // force on link3, times 0.0825 m, y
    const Scalar z1708 = k36 * z689 - k39 * z698 + k38 * z701 + k63 * z847 - k40 * z848 + z1703;  // moment on link3, x
    // moment on link3, y
    const Scalar z1709 = k35 * z689 - k40 * z698 + k64 * z701 + k38 * z847 + k39 * z849 - z1700 + z1702;
    // moment on link3, z
    const Scalar z1710 = k36 * z691 - k35 * z692 - k65 * z698 + k39 * z850 - k40 * z851 - k38 * z852 - z1697 + z1704;
    const Scalar z1711 = s_q3 * z1706 + c_q3 * z1705;
    const Scalar z1712 = s_q3 * z1705 - c_q3 * z1706;
    const Scalar z1713 = s_q3 * z1709 + c_q3 * z1708;
    const Scalar z1714 = s_q3 * z1708 - c_q3 * z1709;
    // moment on link2, x
    const Scalar z1718 = k45 * z681 - k66 * z685 - k44 * z865 - k46 * z866 + n632_over_165 * z1712 + z1713;
    const Scalar z1719 = k46 * z681 - k44 * z685 - k67 * z865 - k45 * z867 - z1710;  // moment on link2, y
    // moment on link2, z
    const Scalar z1720 = k68 * z677 - k69 * z678 + k70 * z681 + k44 * z868 + n632_over_165 * z1711 - z1714;
    const Scalar z1724 = s_q2 * z1718 - c_q2 * z1719;
    const Scalar z1729 = u_tau1 + z1724;
    const Scalar z1730 = u_tau2 + z1720;
    const Scalar z1731 = u_tau3 + z1710;
    const Scalar z1732 = u_tau4 + z1700;
    const Scalar z1733 = u_tau5 + z1690;
    const Scalar z1734 = u_tau6 - z1680;
    const Scalar z1735 = z1408 * z1581 + z1734;
    const Scalar z1736 = z1408 * z1580 - z1608 * z1735 - z1733;
    const Scalar z1737 = z1408 * z1579 - z1607 * z1735 - z1628 * z1736 - z1732;
    const Scalar z1738 = z1408 * z1578 - z1606 * z1735 - z1627 * z1736 - z1642 * z1737 + z1731;
    const Scalar z1739 = z1408 * z1577 - z1605 * z1735 - z1626 * z1736 - z1641 * z1737 - z1651 * z1738 - z1730;
    const Scalar z1740 = z1408 * z1576 - z1604 * z1735 - z1625 * z1736 - z1640 * z1737 - z1650 * z1738 - z1656 * z1739
        - z1729;
    const Scalar z1741 = z1658 * z1740;
    const Scalar z1742 = z1655 * z1739 - z1656 * z1741;
    const Scalar z1743 = z1649 * z1738 - z1650 * z1741 - z1651 * z1742;
    const Scalar z1744 = z1639 * z1737 - z1640 * z1741 - z1641 * z1742 - z1642 * z1743;
    const Scalar z1745 = z1624 * z1736 - z1625 * z1741 - z1626 * z1742 - z1627 * z1743 - z1628 * z1744;
    const Scalar z1746 = z1603 * z1735 - z1604 * z1741 - z1605 * z1742 - z1606 * z1743 - z1607 * z1744 - z1608 * z1745;
    const Scalar z1747 = k52 * z1408 - z1576 * z1741 - z1577 * z1742 - z1578 * z1743 - z1579 * z1744 - z1580 * z1745
        - z1581 * z1746;
    const Scalar z1748 = z680 - z1743;
    const Scalar z1749 = z694 - z1744;
    const Scalar z1750 = z1370 + z1745;
    const Scalar z1751 = z1381 - z1746;
    const Scalar z1752 = z1387 - z1747;
    accelerations.q1 = z1741;
    accelerations.q2 = z1742;
    accelerations.q3 = z1748;
    accelerations.q4 = -z1749;
    accelerations.q5 = z1750;
    accelerations.q6 = z1751;
    accelerations.q7 = -z1752;
    if (!(traits::regular(-z1657, z669) && traits::regular(-z1654, z651) && traits::regular(-z1648, z625)
        && traits::regular(-z1638, z592) && traits::regular(-z1623, z550) && traits::regular(-z1602,
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
    const Scalar k5 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k6 = traits::constant(0.00850351162402155, 0.008503512f, "170070232480431/20000000000000000");
    const Scalar k7 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k8 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k9 = traits::constant(0.028124284712194955, 0.028124284f, "7031071178048739/250000000000000000");
    const Scalar k10 = traits::constant(0.026534991901690206, 0.026534991f, "13267495950845103/500000000000000000");
    const Scalar k11 = traits::constant(0.214708623208, 0.21470863f, "26838577901/125000000000");
    const Scalar k12 = traits::constant(3.228604, 3.228604f, "807151/250000");
    const Scalar k13 = traits::constant(0.126729164208, 0.12672916f, "7920572763/62500000000");
    const Scalar k14 = traits::constant(0.088844724872, 0.088844724f, "11105590609/125000000000");
    const Scalar k15 = traits::constant(0.05649492601407083, 0.056494925f, "3530932875879427/62500000000000000");
    const Scalar k16 = traits::constant(0.008248333140675744, 0.008248333f, "257760410646117/31250000000000000");
    const Scalar k17 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k18 = traits::constant(0.052878381999606115, 0.052878384f, "1652449437487691/31250000000000000");
    const Scalar k19 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k20 = traits::constant(0.01824920229252011, 0.018249203f, "1140575143282507/62500000000000000");
    const Scalar k21 = traits::constant(0.09850206933, 0.09850207f, "9850206933/100000000000");
    const Scalar k22 = traits::constant(3.587895, 3.587895f, "717579/200000");
    const Scalar k23 = traits::constant(0.374644408005, 0.3746444f, "74928881601/200000000000");
    const Scalar k24 = traits::constant(0.19076837715, 0.19076838f, "3815367543/20000000000");
    const Scalar k25 = traits::constant(0.06767727025085991, 0.06767727f, "13535454050171983/200000000000000000");
    const Scalar k26 = traits::constant(0.02771584317362585, 0.027715843f, "554316863472517/20000000000000000");
    const Scalar k27 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k28 = traits::constant(0.03239943042445132, 0.03239943f, "809985760611283/25000000000000000");
    const Scalar k29 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k30 = traits::constant(0.07758614905253959, 0.07758615f, "15517229810507919/200000000000000000");
    const Scalar k31 = traits::constant(0.047121686402, 0.047121685f, "23560843201/500000000000");
    const Scalar k32 = traits::constant(1.225946, 1.225946f, "612973/500000");
    const Scalar k33 = traits::constant(0.05034347249, 0.050343473f, "5034347249/100000000000");
    const Scalar k34 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k35 = traits::constant(0.03942757095803552, 0.03942757f, "9856892739508881/250000000000000000");
    const Scalar k36 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k37 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k38 = traits::constant(0.03146037232526039, 0.03146037f, "7865093081315097/250000000000000000");
    const Scalar k39 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k40 = traits::constant(0.010869510762828565, 0.0108695105f, "2717377690707141/250000000000000000");
    const Scalar k41 = traits::constant(0.017527158935, 0.01752716f, "3505431787/200000000000");
    const Scalar k42 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k43 = traits::constant(0.023526756935, 0.023526756f, "4705351387/200000000000");
    const Scalar k44 = traits::constant(0.100241616695, 0.10024162f, "20048323339/200000000000");
    const Scalar k45 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k46 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k47 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k48 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k49 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k50 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
    const Scalar k51 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k52 = traits::constant(0.735522, 0.735522f, "367761/500000");
    const Scalar k53 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k54 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
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
    const Scalar z1753 = k5 * v_q2 - k6 * z35 + k7 * z36;
    const Scalar z1754 = k8 * v_q2 + k7 * z35 - k9 * z36;
    const Scalar z1755 = k10 * v_q2 - k5 * z35 - k8 * z36;
    const Scalar z1756 = k11 * z40 - k12 * z41 + k13 * z43;
    const Scalar z1757 = k11 * z39 - k12 * z42 + k14 * z43;
    const Scalar z1758 = k15 * z39 - k16 * z40 - k11 * z42 - k17 * z43;
    const Scalar z1759 = k16 * z39 - k18 * z40 + k11 * z41 + k19 * z43;
    const Scalar z1760 = k17 * z39 + k19 * z40 + k13 * z41 + k14 * z42 - k20 * z43;
    const Scalar z1761 = k21 * z47 + k22 * z48 + k23 * z50;
    const Scalar z1762 = k21 * z46 + k22 * z49 + k24 * z50;
    const Scalar z1763 = k22 * z44 + k23 * z46 - k24 * z47;
    const Scalar z1764 = k23 * z44 + k25 * z46 - k26 * z47 + k21 * z49 + k27 * z50;
    const Scalar z1765 = k24 * z44 + k26 * z46 - k28 * z47 - k21 * z48 - k29 * z50;
    const Scalar z1766 = k27 * z46 + k29 * z47 + k23 * z48 + k24 * z49 + k30 * z50;
    const Scalar z1767 = k31 * z55 - k32 * z56 - k33 * z58;
    const Scalar z1768 = k31 * z54 - k32 * z57 + k34 * z58;
    const Scalar z1769 = k32 * z52 + k33 * z54 + k34 * z55;
    const Scalar z1770 = k33 * z52 + k35 * z54 - k36 * z55 - k31 * z57 + k37 * z58;
    const Scalar z1771 = k34 * z52 - k36 * z54 + k38 * z55 - k31 * z56 - k39 * z58;
    const Scalar z1772 = k37 * z54 - k39 * z55 + k33 * z56 - k34 * z57 + k40 * z58;
    const Scalar z1773 = k41 * z60 + k42 * z61 - k43 * z63;
    const Scalar z1774 = k41 * z59 + k42 * z62 + k44 * z63;
    const Scalar z1775 = k42 * z57 + k43 * z59 + k44 * z60;
    const Scalar z1776 = k43 * z57 + k45 * z59 + k46 * z60 + k41 * z62 - k47 * z63;
    const Scalar z1777 = k44 * z57 + k46 * z59 + k48 * z60 + k41 * z61 + k49 * z63;
    const Scalar z1778 = k47 * z59 - k49 * z60 + k43 * z61 - k44 * z62 - k50 * z63;
    const Scalar z1779 = k51 * z67 + k52 * z68 - k53 * z70;
    const Scalar z1780 = k51 * z66 - k52 * z69 - k54 * z70;
    const Scalar z1781 = k52 * z64 + k53 * z66 - k54 * z67;
    const Scalar z1782 = k53 * z64 + k55 * z66 + k56 * z67 - k51 * z69 - k57 * z70;
    const Scalar z1783 = k54 * z64 - k56 * z66 - k58 * z67 - k51 * z68 - k59 * z70;
    const Scalar z1784 = k57 * z66 - k59 * z67 + k53 * z68 - k54 * z69 - k60 * z70;
    const Scalar z1788 = k61 * s_q2 + k62 * c_q2;
    const Scalar z1791 = k13 * s_q3 - k14 * c_q3;
    const Scalar z1794 = s_q2 * z1791 - k11 * c_q2;
    const Scalar z1797 = k23 * s_q4 + k24 * c_q4;
    const Scalar z1798 = k24 * s_q4 - k23 * c_q4;
    const Scalar z1799 = k21 * s_q3 - c_q3 * z1797;
    const Scalar z1802 = s_q2 * z1799 + c_q2 * z1798;
    const Scalar z1805 = k33 * s_q5 + k34 * c_q5;
    const Scalar z1806 = k34 * s_q5 - k33 * c_q5;
    const Scalar z1807 = k31 * s_q4 - c_q4 * z1805;
    const Scalar z1808 = s_q4 * z1805 + k31 * c_q4;
    const Scalar z1809 = s_q3 * z1806 + c_q3 * z1807;
    const Scalar z1812 = s_q2 * z1809 + c_q2 * z1808;
    const Scalar z1815 = k43 * s_q6 + k44 * c_q6;
    const Scalar z1816 = k44 * s_q6 - k43 * c_q6;
    const Scalar z1817 = k41 * s_q5 - c_q5 * z1815;
    const Scalar z1818 = s_q5 * z1815 + k41 * c_q5;
    const Scalar z1819 = s_q4 * z1816 + c_q4 * z1817;
    const Scalar z1820 = s_q4 * z1817 - c_q4 * z1816;
    const Scalar z1821 = s_q3 * z1818 + c_q3 * z1819;
    const Scalar z1824 = s_q2 * z1821 - c_q2 * z1820;
    const Scalar z1827 = k53 * s_q7 + k54 * c_q7;
    const Scalar z1828 = k54 * s_q7 - k53 * c_q7;
    const Scalar z1829 = k51 * s_q6 + c_q6 * z1827;
    const Scalar z1830 = s_q6 * z1827 - k51 * c_q6;
    const Scalar z1831 = s_q5 * z1828 + c_q5 * z1829;
    const Scalar z1832 = s_q5 * z1829 - c_q5 * z1828;
    const Scalar z1833 = s_q4 * z1830 - c_q4 * z1831;
    const Scalar z1834 = s_q4 * z1831 + c_q4 * z1830;
    const Scalar z1835 = s_q3 * z1832 + c_q3 * z1833;
    const Scalar z1838 = s_q2 * z1835 + c_q2 * z1834;
    result.kinetic = n0_5 * (-z57 * (z1768 - z1775) + v_q2 * z1755 - z35 * z1753 - z36 * z1754 + z39 * z1758 - z40
        * z1759 - z41 * z1756 - z42 * z1757 - z43 * z1760 + z44 * z1763 + z46 * z1764 - z47 * z1765 + z48 * z1761 + z49
        * z1762 + z50 * z1766 + z52 * z1769 + z54 * z1770 + z55 * z1771 - z56 * z1767 + z58 * z1772 + z59 * z1776 + z60
        * z1777 + z61 * z1773 + z62 * z1774 - z63 * z1778 + z64 * z1781 + z66 * z1782 - z67 * z1783 + z68 * z1779 - z69
        * z1780 - z70 * z1784) + k64 * v_q1 * v_q1;
    result.force_function = -n9_81 * (z1788 + z1794 - z1802 - z1812 + z1824 + z1838) - k66 - k67 * z402 - k68 * z415
        - k69 * z432 - k70 * z458;
    result.power = v_q1 * u_tau1 + v_q2 * u_tau2 + v_q3 * u_tau3 + v_q4 * u_tau4 + v_q5 * u_tau5 + v_q6 * u_tau6 + v_q7
        * u_tau7;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar k0 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k1 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k8 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k9 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k12 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k13 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k14 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k15 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k18 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k22 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k23 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k24 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k25 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k26 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k28 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k31 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k32 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k33 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k38 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k39 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k40 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k43 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k44 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar k51 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar k52 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k54 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k55 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k56 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k57 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k58 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k59 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k60 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k61 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k62 = traits::constant(0.01475269184007975, 0.014752692f, "14752691840079751/1000000000000000000");
    const Scalar k63 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k64 = traits::constant(0.0256820031989088, 0.025682002f, "8025625999659/312500000000000");
    const Scalar k65 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k66 = traits::constant(0.5866766710959985, 0.58667666f, "586676671095998483/1000000000000000000");
    const Scalar k67 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k68 = traits::constant(0.06802553512169374, 0.06802554f, "8503191890211717/125000000000000000");
    const Scalar k69 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k70 = traits::constant(1.0127011722584085, 1.0127012f, "15823455816537633/15625000000000000");
    const Scalar k71 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k72 = traits::constant(0.0001790829744405, 0.00017908297f, "358165948881/2000000000000000");
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
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = k4 + n16_over_15 * z466;
    const Scalar z470 = c_q6 * z465;
    const Scalar z471 = s_q6 * z465;
    const Scalar z472 = s_q6 * z469 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z469;
    const Scalar z474 = s_q5 * z466 - c_q5 * z470;
    const Scalar z475 = s_q5 * z470 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n256_over_55 * z475 - z476;
    const Scalar z479 = z473 + z475;
    const Scalar z480 = z471 - n256_over_55 * z474 - z477;
    const Scalar z481 = s_q4 * z471 + c_q4 * z474;
    const Scalar z482 = s_q4 * z474 - c_q4 * z471;
    const Scalar z483 = s_q4 * z479 - c_q4 * z478;
    const Scalar z484 = s_q4 * z478 + c_q4 * z479;
    const Scalar z485 = z480 + z482;
    const Scalar z486 = z475 - z484;
    const Scalar z487 = s_q3 * z475 + c_q3 * z481;
    const Scalar z488 = s_q3 * z481 - c_q3 * z475;
    const Scalar z489 = s_q3 * z485 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z485;
    const Scalar z491 = n632_over_165 * z488 - z489;
    const Scalar z492 = n632_over_165 * z487 - z490;
    const Scalar z496 = s_q2 * z491 - c_q2 * z486;
    const Scalar z497 = k8 * s_q7 - k9 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k8 - z498;
    const Scalar z500 = k10 + c_q7 * z497;
    const Scalar z501 = n16_over_15 * z465 - z500;
    const Scalar z502 = k4 + n32_over_15 * z466;
    const Scalar z503 = n32_over_15 * z466 + z498;
    const Scalar z504 = k12 + z466;
    const Scalar z505 = k13 - z499;
    const Scalar z506 = k14 - z467;
    const Scalar z507 = k15 + z501;
    const Scalar z508 = k16 + z468;
    const Scalar z509 = k17 + z503;
    const Scalar z510 = s_q6 * z504 - k18 * c_q6;
    const Scalar z511 = k18 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n256_over_55 * z515 + z516;
    const Scalar z519 = z513 - z515;
    const Scalar z520 = z511 - n256_over_55 * z514 - z517;
    const Scalar z521 = s_q4 * z511 + c_q4 * z514;
    const Scalar z522 = s_q4 * z514 - c_q4 * z511;
    const Scalar z523 = s_q4 * z519 + c_q4 * z518;
    const Scalar z524 = s_q4 * z518 - c_q4 * z519;
    const Scalar z525 = z520 + z522;
    const Scalar z526 = z515 - z524;
    const Scalar z527 = s_q3 * z515 - c_q3 * z521;
    const Scalar z528 = s_q3 * z521 + c_q3 * z515;
    const Scalar z529 = s_q3 * z525 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z525;
    const Scalar z531 = n632_over_165 * z528 - z529;
    const Scalar z532 = n632_over_165 * z527 + z530;
    const Scalar z536 = s_q2 * z531 + c_q2 * z526;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k20 - z511;
    const Scalar z545 = k21 - z465;
    const Scalar z546 = k22 - z541;
    const Scalar z547 = k23 - z512;
    const Scalar z548 = k24 + z543;
    const Scalar z549 = k25 + z513;
    const Scalar z550 = k26 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n256_over_55 * z552 - z553;
    const Scalar z556 = z550 + z552;
    const Scalar z557 = n256_over_55 * z551 - z554;
    const Scalar z558 = c_q4 * z551;
    const Scalar z559 = s_q4 * z551;
    const Scalar z560 = s_q4 * z556 - c_q4 * z555;
    const Scalar z561 = s_q4 * z555 + c_q4 * z556;
    const Scalar z562 = z557 - z559;
    const Scalar z563 = z552 - z561;
    const Scalar z564 = s_q3 * z552 + c_q3 * z558;
    const Scalar z565 = s_q3 * z558 - c_q3 * z552;
    const Scalar z566 = s_q3 * z562 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z562;
    const Scalar z568 = n632_over_165 * z565 + z566;
    const Scalar z569 = n632_over_165 * z564 - z567;
    const Scalar z573 = s_q2 * z568 - c_q2 * z563;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n512_over_55 * z510 + z578;
    const Scalar z582 = z510 + n256_over_55 * z552 - z553;
    const Scalar z583 = z551 + z580;
    const Scalar z584 = z550 + n2 * z552;
    const Scalar z585 = n512_over_55 * z510 + n2 * z552 + z579;
    const Scalar z586 = k28 + z552;
    const Scalar z587 = k29 + z510;
    const Scalar z588 = k30 + z581;
    const Scalar z589 = k31 + z582;
    const Scalar z590 = k32 + z583;
    const Scalar z591 = k33 + z557;
    const Scalar z592 = k34 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = z592 - z594;
    const Scalar z598 = c_q3 * z593;
    const Scalar z599 = s_q3 * z593;
    const Scalar z600 = s_q3 * z597 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z597;
    const Scalar z602 = n632_over_165 * z599 - z600;
    const Scalar z603 = n632_over_165 * z598 + z601;
    const Scalar z607 = s_q2 * z602 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = z551 - z595;
    const Scalar z616 = z593 - z614;
    const Scalar z617 = z592 - n2 * z594;
    const Scalar z618 = n2 * z594 - z613;
    const Scalar z619 = k35 - z594;
    const Scalar z620 = k36 - z551;
    const Scalar z621 = k37 + z612;
    const Scalar z622 = k38 - z615;
    const Scalar z623 = k39 - z616;
    const Scalar z624 = k40 + z596;
    const Scalar z625 = k41 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n632_over_165 * z627 + z628;
    const Scalar z631 = n632_over_165 * z626 + z629;
    const Scalar z635 = s_q2 * z630 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = k42 * z593 - z640;
    const Scalar z644 = k42 * z593 - z641;
    const Scalar z645 = k43 + z627;
    const Scalar z646 = k44 - z593;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z630;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z631;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    const Scalar z677 = k51 * s_q2;
    const Scalar z678 = k51 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z689 = z678 - n632_over_165 * z684;
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
    const Scalar z892 = z677 - n632_over_165 * z888;
    const Scalar z893 = n632_over_165 * z889;
    const Scalar z894 = s_q3 * z893 - c_q3 * z892;
    const Scalar z895 = s_q3 * z892 + c_q3 * z893;
    const Scalar z896 = v_q3 * z40 + z890;  // angular acceleration of link3, x
    const Scalar z897 = v_q3 * z39 - z891;  // angular acceleration of link3, y
    const Scalar z898 = a_q3 - z887;  // angular acceleration of link3, z
    const Scalar z899 = z698 + z898;
    const Scalar z900 = z700 + z897;
    const Scalar z901 = s_q4 * z898 + c_q4 * z896;
    const Scalar z902 = s_q4 * z896 - c_q4 * z898;
    const Scalar z903 = z697 - z894;
    const Scalar z904 = z895 + z899;
    const Scalar z905 = z689 + z900;
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
    const Scalar z917 = z713 + z906 - n256_over_55 * z911;
    const Scalar z918 = n256_over_55 * z718 - z907 - z912;
    const Scalar z919 = z904 + z913 + n256_over_55 * z914;
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
    const Scalar z936 = n16_over_15 * z740 + z927;
    const Scalar z937 = z928 - n16_over_15 * z932;
    const Scalar z938 = z921 + n16_over_15 * z933;
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
    const Scalar z950 = k0 * z756 - k1 * z944;  // force on link7, times 0.0825 m, x
    const Scalar z951 = k1 * z761 - k0 * z945;  // force on link7, times 0.0825 m, y
    const Scalar z952 = k0 * z946 + k1 * z947;  // force on link7, times 0.0825 m, z
    // moment on link7, z
    const Scalar z955 = k8 * z757 + k10 * z770 + k1 * z939 + k0 * z940 + k4 * z943 - k3 * z948 - k2 * z949;
    const Scalar z956 = s_q7 * z951 + c_q7 * z950;
    const Scalar z957 = s_q7 * z950 - c_q7 * z951;
    const Scalar z960 = z741 - z931;
    const Scalar z961 = z784 + z929;
    const Scalar z962 = z784 - z929;
    const Scalar z963 = z743 - z930;
    const Scalar z964 = k12 * z740 + z956 + k18 * z960;  // force on link6, times 0.0825 m, x
    const Scalar z965 = k18 * z783 + k12 * z932 - z952;  // force on link6, times 0.0825 m, y
    const Scalar z966 = k12 * z933 - z957 - k18 * z961;  // force on link6, times 0.0825 m, z
    const Scalar z970 = s_q6 * z965 + c_q6 * z964;
    const Scalar z971 = s_q6 * z964 - c_q6 * z965;
    const Scalar z974 = z804 - z924;
    const Scalar z975 = z804 + z924;
    const Scalar z976 = z809 + z923;
    const Scalar z977 = z811 + z922;
    const Scalar z978 = z811 - z922;
    const Scalar z979 = z809 - z923;
    const Scalar z980 = k20 * z803 - z970 + k21 * z974;  // force on link5, times 0.0825 m, x
    const Scalar z981 = k21 * z808 + z966 + k20 * z975;  // force on link5, times 0.0825 m, y
    const Scalar z982 = z971 - k20 * z976 + k21 * z977;  // force on link5, times 0.0825 m, z
    const Scalar z986 = s_q5 * z981 + c_q5 * z980;
    const Scalar z987 = s_q5 * z980 - c_q5 * z981;
    const Scalar z990 = z721 - z908;
    const Scalar z991 = z719 - z909;
    const Scalar z992 = k28 * z713 - k29 * z911 + z986;  // force on link4, times 0.0825 m, x
    const Scalar z993 = k29 * z718 - k28 * z912 + z982;  // force on link4, times 0.0825 m, y
    const Scalar z994 = k28 * z913 + k29 * z914 + z987;  // force on link4, times 0.0825 m, z
    const Scalar z998 = s_q4 * z993 + c_q4 * z992;
    const Scalar z999 = s_q4 * z992 - c_q4 * z993;
    const Scalar z1002 = z698 - z898;
    const Scalar z1003 = z846 + z896;
    const Scalar z1004 = z846 - z896;
    const Scalar z1005 = z700 - z897;
    const Scalar z1006 = k35 * z697 - z998 - k36 * z1002;  // force on link3, times 0.0825 m, x
    const Scalar z1007 = k36 * z845 - k35 * z899 - z994;  // force on link3, times 0.0825 m, y
    const Scalar z1012 = s_q3 * z1007 - c_q3 * z1006;
    const Scalar z1013 = s_q3 * z1006 + c_q3 * z1007;
    const Scalar z1016 = a_q2 + z681;
    const Scalar z1017 = z680 + z887;
    const Scalar z1018 = z679 - z886;
    const Scalar z1019 = z680 - z887;
    const Scalar z1576 = k52 * z496;
    const Scalar z1577 = k52 * z492;
    const Scalar z1578 = k52 * z486;
    const Scalar z1579 = k52 * z480;
    const Scalar z1580 = k52 * z473;
    const Scalar z1581 = k52 * z468;
    const Scalar z1582 = z496 * z1576 - z669;
    const Scalar z1583 = z496 * z1577 + z655;
    const Scalar z1584 = z492 * z1577 - z651;
    const Scalar z1585 = z496 * z1578 - z635;
    const Scalar z1586 = z492 * z1578 - z631;
    const Scalar z1587 = z486 * z1578 - z625;
    const Scalar z1588 = z496 * z1579 - z607;
    const Scalar z1589 = z492 * z1579 - z603;
    const Scalar z1590 = z486 * z1579 + z596;
    const Scalar z1591 = z480 * z1579 - z592;
    const Scalar z1592 = z496 * z1580 - z573;
    const Scalar z1593 = z492 * z1580 - z569;
    const Scalar z1594 = z486 * z1580 - z563;
    const Scalar z1595 = z480 * z1580 + z557;
    const Scalar z1596 = z473 * z1580 - z550;
    const Scalar z1597 = z496 * z1581 - z536;
    const Scalar z1598 = z492 * z1581 + z532;
    const Scalar z1599 = z486 * z1581 + z526;
    const Scalar z1600 = z480 * z1581 - z520;
    const Scalar z1601 = z473 * z1581 - z513;
    const Scalar z1602 = z468 * z1581 - z509;
    const Scalar z1603 = n1 / z1602;
    const Scalar z1604 = z1597 * z1603;
    const Scalar z1605 = z1598 * z1603;
    const Scalar z1606 = z1599 * z1603;
    const Scalar z1607 = z1600 * z1603;
    const Scalar z1608 = z1601 * z1603;
    const Scalar z1609 = z1582 - z1597 * z1604;
    const Scalar z1610 = z1583 - z1597 * z1605;
    const Scalar z1611 = z1584 - z1598 * z1605;
    const Scalar z1612 = z1585 - z1597 * z1606;
    const Scalar z1613 = z1586 - z1598 * z1606;
    const Scalar z1614 = z1587 - z1599 * z1606;
    const Scalar z1615 = z1588 - z1597 * z1607;
    const Scalar z1616 = z1589 - z1598 * z1607;
    const Scalar z1617 = z1590 - z1599 * z1607;
    const Scalar z1618 = z1591 - z1600 * z1607;
    const Scalar z1619 = z1592 - z1597 * z1608;
    const Scalar z1620 = z1593 - z1598 * z1608;
    const Scalar z1621 = z1594 - z1599 * z1608;
    const Scalar z1622 = z1595 - z1600 * z1608;
    const Scalar z1623 = z1596 - z1601 * z1608;
    const Scalar z1624 = n1 / z1623;
    const Scalar z1625 = z1619 * z1624;
    const Scalar z1626 = z1620 * z1624;
    const Scalar z1627 = z1621 * z1624;
    const Scalar z1628 = z1622 * z1624;
    const Scalar z1629 = z1609 - z1619 * z1625;
    const Scalar z1630 = z1610 - z1619 * z1626;
    const Scalar z1631 = z1611 - z1620 * z1626;
    const Scalar z1632 = z1612 - z1619 * z1627;
    const Scalar z1633 = z1613 - z1620 * z1627;
    const Scalar z1634 = z1614 - z1621 * z1627;
    const Scalar z1635 = z1615 - z1619 * z1628;
    const Scalar z1636 = z1616 - z1620 * z1628;
    const Scalar z1637 = z1617 - z1621 * z1628;
    const Scalar z1638 = z1618 - z1622 * z1628;
    const Scalar z1639 = n1 / z1638;
    const Scalar z1640 = z1635 * z1639;
    const Scalar z1641 = z1636 * z1639;
    const Scalar z1642 = z1637 * z1639;
    const Scalar z1643 = z1629 - z1635 * z1640;
    const Scalar z1644 = z1630 - z1635 * z1641;
    const Scalar z1645 = z1631 - z1636 * z1641;
    const Scalar z1646 = z1632 - z1635 * z1642;
    const Scalar z1647 = z1633 - z1636 * z1642;
    const Scalar z1648 = z1634 - z1637 * z1642;
    const Scalar z1649 = n1 / z1648;
    const Scalar z1650 = z1646 * z1649;
    const Scalar z1651 = z1647 * z1649;
    const Scalar z1652 = z1643 - z1646 * z1650;
    const Scalar z1653 = z1644 - z1646 * z1651;
    const Scalar z1654 = z1645 - z1647 * z1651;
    const Scalar z1655 = n1 / z1654;
    const Scalar z1656 = z1653 * z1655;
    const Scalar z1657 = z1652 - z1653 * z1656;
    const Scalar z1658 = n1 / z1657;
    const Scalar z1928 = k4 * z764 + k2 * z766 + k1 * z937 + k8 * z941 - k3 * z945 - k10 * z946;  // moment on link7, x
    const Scalar z1929 = k54 * z762 + k3 * z767 + k0 * z937 + k2 * z944 - k10 * z947;  // moment on link7, y
    const Scalar z1930 = s_q7 * z1929 - c_q7 * z1928;
    const Scalar z1931 = s_q7 * z1928 + c_q7 * z1929;
    // moment on link6, x
    const Scalar z1932 = k17 * z784 + k16 * z786 - k18 * z921 - k13 * z929 - k15 * z932 - k14 * z933 + z1930;
    // moment on link6, y
    const Scalar z1933 = k55 * z743 + k15 * z787 + k12 * z921 + z955 - n16_over_15 * z957 + k16 * z960 - k14 * z961;
    // moment on link6, z
    const Scalar z1934 = k13 * z741 - k14 * z790 - k18 * z927 - k12 * z928 + k17 * z931 - n16_over_15 * z952 + k15
        * z962 + k16 * z963 - z1931;
    const Scalar z1935 = s_q6 * z1933 + c_q6 * z1932;
    const Scalar z1936 = s_q6 * z1932 - c_q6 * z1933;
    // moment on link5, x
    const Scalar z1937 = k26 * z811 - k25 * z813 + k21 * z918 + k22 * z922 + k24 * z975 + k23 * z976 - z1935;
    const Scalar z1938 = k56 * z809 - k24 * z814 - k20 * z918 - k25 * z974 + k23 * z977 - z1934;  // moment on link5, y
    // moment on link5, z
    const Scalar z1939 = k22 * z804 - k23 * z817 + k21 * z920 - k20 * z921 - k26 * z924 + k24 * z978 + k25 * z979
        - z1936;
    const Scalar z1940 = s_q5 * z1938 + c_q5 * z1937;
    const Scalar z1941 = s_q5 * z1937 - c_q5 * z1938;
    // moment on link4, x
    const Scalar z1942 = k34 * z721 + k33 * z828 + k29 * z904 + k30 * z908 + k32 * z912 + k31 * z913 + n256_over_55
        * z987 + z1940;
    // moment on link4, y
    const Scalar z1943 = k57 * z719 - k32 * z829 + k28 * z904 + k33 * z911 + k31 * z914 + z987 + z1939;
    // moment on link4, z
    const Scalar z1944 = k30 * z714 - k31 * z832 - k29 * z906 - k28 * z907 + k34 * z910 + z982 - n256_over_55 * z986
        + k32 * z990 - k33 * z991 + z1941;
    const Scalar z1945 = s_q4 * z1943 - c_q4 * z1942;
    const Scalar z1946 = s_q4 * z1942 + c_q4 * z1943;
    // moment on link3, x
    const Scalar z1947 = k36 * z689 + k41 * z846 - k40 * z848 + k37 * z896 - k39 * z899 + k38 * z900 + z1945;
    // moment on link3, y
    const Scalar z1948 = k35 * z689 + k58 * z700 + k39 * z849 + z999 - k40 * z1002 + k38 * z1003 + z1944;
    // moment on link3, z
    const Scalar z1949 = k37 * z698 - k38 * z852 + k36 * z894 - k35 * z895 - k41 * z898 - z994 - k39 * z1004 + k40
        * z1005 + z1946;
    const Scalar z1950 = s_q3 * z1948 + c_q3 * z1947;
    const Scalar z1951 = s_q3 * z1947 - c_q3 * z1948;
    // moment on link2, x
    const Scalar z1952 = k49 * z679 + k48 * z866 + k45 * z886 - n632_over_165 * z1013 - k47 * z1016 + k46 * z1017
        - z1950;
    const Scalar z1953 = k59 * z680 + k47 * z867 + k48 * z888 + k46 * z889 + z1949;  // moment on link2, y
    // moment on link2, z
    const Scalar z1954 = k49 * a_q2 - k44 * z677 + k43 * z678 - k45 * z681 - k46 * z868 + n632_over_165 * z1012 + k47
        * z1018 - k48 * z1019 + z1951;
    const Scalar z1956 = s_q2 * z1952 - c_q2 * z1953;
    const Scalar z1959 = k50 * a_q1 + z1956;  // moment on link1, z
    const Scalar z1960 = n2 * v_q1;
    const Scalar z1961 = z683 + z863;
    const Scalar z1962 = n2 * z35;
    const Scalar z1963 = n2 * z36;
    const Scalar z1964 = n2 * v_q2;
    const Scalar z1965 = z695 + z844;
    const Scalar z1966 = n2 * z39;
    const Scalar z1967 = n2 * z40;
    const Scalar z1968 = n2 * z43;
    const Scalar z1969 = z711 + z717;
    const Scalar z1970 = n2 * z46;
    const Scalar z1971 = n2 * z47;
    const Scalar z1972 = n2 * z50;
    const Scalar z1973 = z801 + z807;
    const Scalar z1974 = n2 * z54;
    const Scalar z1975 = n2 * z55;
    const Scalar z1976 = n2 * z58;
    const Scalar z1977 = z738 + z782;
    const Scalar z1978 = n2 * z59;
    const Scalar z1979 = n2 * z60;
    const Scalar z1980 = n2 * z63;
    const Scalar z1981 = z754 + z760;
    const Scalar z1982 = n2 * z66;
    const Scalar z1983 = n2 * z67;
    const Scalar z1984 = n2 * z70;
    const Scalar z1985 = k2 * z1982;
    const Scalar z1986 = k3 * z1983;
    const Scalar z1987 = k10 * z1984;
    const Scalar z1988 = k1 * z1984;
    const Scalar z1989 = k0 * z1984;
    const Scalar z1990 = k1 * z1982 - k0 * z1983;
    const Scalar z1991 = z1986 + z1987;
    const Scalar z1992 = k2 * z1983 + k60 * z1984;
    const Scalar z1993 = k61 * z1983 - k2 * z1984;
    const Scalar z1994 = k3 * z1982 - k61 * z1984;
    const Scalar z1995 = z1985 - z1987;
    const Scalar z1996 = k61 * z1982 + k3 * z1984;
    const Scalar z1997 = k10 * z1982 + k61 * z1983;
    const Scalar z1998 = k60 * z1982 + k10 * z1983;
    const Scalar z1999 = z1985 + z1986;
    const Scalar z2000 = n16_over_15 * z1980;
    const Scalar z2001 = n16_over_15 * z1979;
    const Scalar z2002 = s_q7 * z1989 - c_q7 * z1988;
    const Scalar z2003 = s_q7 * z1988 + c_q7 * z1989;
    const Scalar z2004 = z1991 - z1995;
    const Scalar z2005 = z1992 + z1994;
    const Scalar z2006 = s_q7 * z2004 + c_q7 * z2005;
    const Scalar z2007 = s_q7 * z2006;
    const Scalar z2008 = s_q7 * z1996 - c_q7 * z1993;
    const Scalar z2009 = s_q7 * z1993 + c_q7 * z1996;
    const Scalar z2010 = s_q7 * z1998 - c_q7 * z1997;
    const Scalar z2011 = s_q7 * z1997 + c_q7 * z1998;
    const Scalar z2012 = z1991 - z2007;
    const Scalar z2013 = z1995 + z2007;
    const Scalar z2014 = c_q7 * z2006 - z1994;
    const Scalar z2015 = c_q7 * z2006 - z1992;
    const Scalar z2016 = n16_over_15 * z2002 + z2012;
    const Scalar z2017 = z466 * z2000 + n16_over_15 * z1990 + z2010;
    const Scalar z2018 = z465 * z2000 - z2011;
    const Scalar z2019 = z466 * z2001 - n16_over_15 * z2003 + z2015;
    const Scalar z2020 = z465 * z2001 + z2013;
    const Scalar z2021 = k16 * z1978;
    const Scalar z2022 = k15 * z1979;
    const Scalar z2023 = k14 * z1980;
    const Scalar z2024 = k18 * z1980 - z2002;
    const Scalar z2025 = k12 * z1980 + z1990;
    const Scalar z2026 = k18 * z1978 + k12 * z1979 - z2003;
    const Scalar z2027 = z2016 - z2022 - z2023;
    const Scalar z2028 = k16 * z1979 + k62 * z1980 - z2008;
    const Scalar z2029 = k63 * z1979 - k16 * z1980 + z2014;
    const Scalar z2030 = k15 * z1978 - k63 * z1980 - z2017;
    const Scalar z2031 = z1999 + z2021 - z2023;
    const Scalar z2032 = k63 * z1978 + k15 * z1980 + z2018;
    const Scalar z2033 = k14 * z1978 + k63 * z1979 + z2019;
    const Scalar z2034 = k62 * z1978 + k14 * z1979 - z2009;
    const Scalar z2035 = z2020 + z2021 + z2022;
    const Scalar z2036 = s_q6 * z2025 - c_q6 * z2024;
    const Scalar z2037 = s_q6 * z2024 + c_q6 * z2025;
    const Scalar z2038 = z2027 + z2031;
    const Scalar z2039 = z2028 + z2030;
    const Scalar z2040 = s_q6 * z2038 + c_q6 * z2039;
    const Scalar z2041 = s_q6 * z2040;
    const Scalar z2042 = s_q6 * z2032 + c_q6 * z2029;
    const Scalar z2043 = s_q6 * z2029 - c_q6 * z2032;
    const Scalar z2044 = s_q6 * z2034 + c_q6 * z2033;
    const Scalar z2045 = s_q6 * z2033 - c_q6 * z2034;
    const Scalar z2046 = z2027 - z2041;
    const Scalar z2047 = z2031 - z2041;
    const Scalar z2048 = c_q6 * z2040 - z2030;
    const Scalar z2049 = c_q6 * z2040 - z2028;
    const Scalar z2050 = k25 * z1974;
    const Scalar z2051 = k24 * z1975;
    const Scalar z2052 = k23 * z1976;
    const Scalar z2053 = k21 * z1976 + z2036;
    const Scalar z2054 = k20 * z1976 - z2026;
    const Scalar z2055 = k21 * z1974 + k20 * z1975 - z2037;
    const Scalar z2056 = z2046 + z2051 + z2052;
    const Scalar z2057 = k25 * z1975 - k64 * z1976 + z2042;
    const Scalar z2058 = k65 * z1975 + k25 * z1976 - z2048;
    const Scalar z2059 = k24 * z1974 + k65 * z1976 + z2044;
    const Scalar z2060 = z2035 + z2050 - z2052;
    const Scalar z2061 = k65 * z1974 - k24 * z1976 - z2045;
    const Scalar z2062 = k23 * z1974 - k65 * z1975 + z2049;
    const Scalar z2063 = k64 * z1974 - k23 * z1975 - z2043;
    const Scalar z2064 = z2047 + z2050 + z2051;
    const Scalar z2065 = n256_over_55 * z1972;
    const Scalar z2066 = n256_over_55 * z1970 - z1971;
    const Scalar z2067 = s_q5 * z2054 - c_q5 * z2053;
    const Scalar z2068 = s_q5 * z2053 + c_q5 * z2054;
    const Scalar z2069 = z2056 - z2060;
    const Scalar z2070 = z2057 + z2059;
    const Scalar z2071 = s_q5 * z2069 - c_q5 * z2070;
    const Scalar z2072 = s_q5 * z2071;
    const Scalar z2073 = s_q5 * z2061 + c_q5 * z2058;
    const Scalar z2074 = s_q5 * z2058 - c_q5 * z2061;
    const Scalar z2075 = s_q5 * z2063 - c_q5 * z2062;
    const Scalar z2076 = s_q5 * z2062 + c_q5 * z2063;
    const Scalar z2077 = z2056 - z2072;
    const Scalar z2078 = z2060 + z2072;
    const Scalar z2079 = c_q5 * z2071 + z2059;
    const Scalar z2080 = c_q5 * z2071 + z2057;
    const Scalar z2081 = z552 * z2065 - z2067 - z2077;
    const Scalar z2082 = z510 * z2065 - n256_over_55 * z2067 - z2073;
    const Scalar z2083 = z551 * z2065 - z2079;
    const Scalar z2084 = z552 * z1972 + z2055 + z2075;
    const Scalar z2085 = z510 * z1972 + n256_over_55 * z2055 - z2064;
    const Scalar z2086 = z551 * z1972 - z2076;
    const Scalar z2087 = z552 * z2066 + z2068 - z2080;
    const Scalar z2088 = z510 * z2066 + n256_over_55 * z2068 - z2074;
    const Scalar z2089 = z551 * z2066 - z2078;
    const Scalar z2090 = k33 * z1970;
    const Scalar z2091 = k32 * z1971;
    const Scalar z2092 = k31 * z1972;
    const Scalar z2093 = k29 * z1972 - z2067;
    const Scalar z2094 = k28 * z1972 + z2055;
    const Scalar z2095 = k29 * z1970 - k28 * z1971 + z2068;
    const Scalar z2096 = z2081 + z2091 + z2092;
    const Scalar z2097 = k33 * z1971 + k66 * z1972 + z2082;
    const Scalar z2098 = k67 * z1971 - k33 * z1972 - z2083;
    const Scalar z2099 = k32 * z1970 + k67 * z1972 + z2084;
    const Scalar z2100 = z2085 + z2090 + z2092;
    const Scalar z2101 = k67 * z1970 - k32 * z1972 - z2086;
    const Scalar z2102 = k31 * z1970 - k67 * z1971 + z2087;
    const Scalar z2103 = k66 * z1970 - k31 * z1971 + z2088;
    const Scalar z2104 = z2089 + z2090 - z2091;
    const Scalar z2105 = s_q4 * z2094 - c_q4 * z2093;
    const Scalar z2106 = s_q4 * z2093 + c_q4 * z2094;
    const Scalar z2107 = z2096 + z2100;
    const Scalar z2108 = z2097 - z2099;
    const Scalar z2109 = s_q4 * z2107 - c_q4 * z2108;
    const Scalar z2110 = s_q4 * z2109;
    const Scalar z2111 = s_q4 * z2101 - c_q4 * z2098;
    const Scalar z2112 = s_q4 * z2098 + c_q4 * z2101;
    const Scalar z2113 = s_q4 * z2103 + c_q4 * z2102;
    const Scalar z2114 = s_q4 * z2102 - c_q4 * z2103;
    const Scalar z2115 = z2096 - z2110;
    const Scalar z2116 = z2100 - z2110;
    const Scalar z2117 = c_q4 * z2109 - z2099;
    const Scalar z2118 = c_q4 * z2109 + z2097;
    const Scalar z2119 = z2105 + z2115;
    const Scalar z2120 = z594 * z1968 + z2095 - z2113;
    const Scalar z2121 = z551 * z1968 - z2104;
    const Scalar z2122 = z593 * z1968 - z2114;
    const Scalar z2123 = z594 * z1967 - z2106 + z2118;
    const Scalar z2124 = z551 * z1967 - z2112;
    const Scalar z2125 = z593 * z1967 - z2116;
    const Scalar z2126 = k40 * z1966;
    const Scalar z2127 = k39 * z1967;
    const Scalar z2128 = k38 * z1968;
    const Scalar z2129 = k36 * z1968 - z2105;
    const Scalar z2130 = k35 * z1968 - z2095;
    const Scalar z2131 = k36 * z1966 - k35 * z1967 - z2106;
    const Scalar z2132 = z2119 + z2127 - z2128;
    const Scalar z2133 = k40 * z1967 - k68 * z1968 + z2111;
    const Scalar z2134 = k69 * z1967 + k40 * z1968 - z2117;
    const Scalar z2135 = k39 * z1966 - k69 * z1968 + z2120;
    const Scalar z2136 = z2121 + z2126 - z2128;
    const Scalar z2137 = k69 * z1966 + k39 * z1968 - z2122;
    const Scalar z2138 = k38 * z1966 - k69 * z1967 + z2123;
    const Scalar z2139 = k68 * z1966 - k38 * z1967 + z2124;
    const Scalar z2140 = z2125 + z2126 - z2127;
    const Scalar z2141 = n632_over_165 * z1964;
    const Scalar z2142 = n632_over_165 * z1962;
    const Scalar z2143 = s_q3 * z2130 + c_q3 * z2129;
    const Scalar z2144 = s_q3 * z2129 - c_q3 * z2130;
    const Scalar z2145 = z2132 + z2136;
    const Scalar z2146 = z2133 - z2135;
    const Scalar z2147 = s_q3 * z2145 + c_q3 * z2146;
    const Scalar z2148 = s_q3 * z2147;
    const Scalar z2149 = s_q3 * z2137 + c_q3 * z2134;
    const Scalar z2150 = s_q3 * z2134 - c_q3 * z2137;
    const Scalar z2151 = s_q3 * z2139 - c_q3 * z2138;
    const Scalar z2152 = s_q3 * z2138 + c_q3 * z2139;
    const Scalar z2153 = z2132 - z2148;
    const Scalar z2154 = z2136 - z2148;
    const Scalar z2155 = c_q3 * z2147 + z2135;
    const Scalar z2156 = c_q3 * z2147 - z2133;
    const Scalar z2157 = z627 * z2141 - z2153;
    const Scalar z2158 = z593 * z2141 + n632_over_165 * z2143 + z2149;
    const Scalar z2159 = z626 * z2141 + z2155;
    const Scalar z2160 = n632_over_165 * z2131 + z2140;
    const Scalar z2161 = z627 * z2142 - z2156;
    const Scalar z2162 = z593 * z2142 + n632_over_165 * z2144 + z2150;
    const Scalar z2163 = z626 * z2142 - z2154;
    const Scalar z2164 = k48 * z1962;
    const Scalar z2165 = k47 * z1963;
    const Scalar z2166 = k46 * z1964;
    const Scalar z2170 = z2157 - z2165 + z2166;
    const Scalar z2171 = k48 * z1963 - k70 * z1964 + z2158;
    const Scalar z2172 = k71 * z1963 + k48 * z1964 + z2159;
    const Scalar z2173 = k47 * z1962 - k71 * z1964 - z2151;
    const Scalar z2174 = z2160 - z2164 + z2166;
    const Scalar z2175 = k71 * z1962 + k47 * z1964 + z2152;
    const Scalar z2176 = k46 * z1962 - k71 * z1963 + z2161;
    const Scalar z2177 = k70 * z1962 - k46 * z1963 - z2162;
    const Scalar z2178 = z2163 + z2164 - z2165;
    const Scalar z2181 = z2170 + z2174;
    const Scalar z2182 = z2171 - z2173;
    const Scalar z2183 = s_q2 * z2181 - c_q2 * z2182;
    const Scalar z2184 = s_q2 * z2183;
    const Scalar z2188 = s_q2 * z2176 + c_q2 * z2177;
    const Scalar z2189 = z2170 - z2184;
    const Scalar z2193 = k72 * z1960;
    const Scalar z2196 = z2189 + z2193;
    const Scalar z2200 = z2178 + z2193;
    const Scalar z2204 = z2196 - z2200;
    const Scalar z2205 = z2174 + z2178;
    const Scalar z2206 = z2170 - z2178;
    const Scalar z2207 = z2170 - z2174;
    const Scalar z2208 = z35 * z2177 - z36 * z2176 - z645 * z677 - z646 * z678 - z649 * z1019 - z650 * z1018 - z651
        * z1961;
    const Scalar z2209 = z649 * z1963 - z650 * z1962 + z2207;
    const Scalar z2213 = z35 * z2171 + z36 * z2205 + z626 * z677 + z647 * z1019 - z648 * z1018 + z649 * z1961 + z1953;
    const Scalar z2214 = z35 * z2206 + z36 * z2173 + z625 * z1018 + z626 * z678 - z648 * z1019 + z650 * z1961 + z1952;
    const Scalar z2218 = s_q2 * z2213 + c_q2 * z2214;
    const Scalar z2222 = z647 * z1963 + z648 * z1962 + z2172;
    const Scalar z2223 = z625 * z1962 + z648 * z1963 + z2175;
    const Scalar z2227 = s_q2 * z2222 - c_q2 * z2223;
    const Scalar z2228 = z2136 - z2140;
    const Scalar z2229 = z2132 + z2140;
    const Scalar z2230 = z2132 - z2136;
    const Scalar z2231 = z39 * z2139 - z40 * z2138 - z619 * z894 - z620 * z895 - z623 * z1005 - z624 * z1004 - z625
        * z1965;
    const Scalar z2232 = z623 * z1967 - z624 * z1966 - z2230;
    const Scalar z2233 = z626 * z2142 - z627 * z2141 + z2230;
    const Scalar z2234 = z35 * z2233 + z36 * z2151 - z625 * z1018 - z626 * z678 + z630 * z1019 - z631 * z1961;
    const Scalar z2235 = z625 * z1962 + z630 * z1963 + z2152;
    const Scalar z2237 = s_q2 * z2151 - c_q2 * z2233;
    const Scalar z2238 = z39 * z2131 + z593 * z1004 - z620 * z1965 - z1007;
    const Scalar z2239 = z40 * z2131 - z593 * z1005 + z619 * z1965 + z1006;
    const Scalar z2241 = z39 * z2133 - z40 * z2228 - z593 * z894 + z621 * z1005 - z622 * z1004 + z623 * z1965 + z1948;
    const Scalar z2242 = z39 * z2229 - z40 * z2135 + z593 * z895 - z617 * z1004 + z622 * z1005 - z624 * z1965 - z1947;
    const Scalar z2243 = s_q3 * z2239 - c_q3 * z2238;
    const Scalar z2244 = s_q3 * z2238 + c_q3 * z2239;
    const Scalar z2245 = s_q3 * z2242 + c_q3 * z2241;
    const Scalar z2246 = s_q3 * z2241 - c_q3 * z2242;
    const Scalar z2247 = n632_over_165 * z2244 + z2245;
    const Scalar z2248 = n632_over_165 * z2243 + z2246;
    const Scalar z2252 = s_q2 * z2247 - c_q2 * z2231;
    const Scalar z2253 = z593 * z1966 - z2130;
    const Scalar z2254 = z593 * z1967 - z2129;
    const Scalar z2256 = z621 * z1967 + z622 * z1966 + z2134;
    const Scalar z2257 = z617 * z1966 + z622 * z1967 + z2137;
    const Scalar z2258 = s_q3 * z2254 - c_q3 * z2253;
    const Scalar z2259 = s_q3 * z2253 + c_q3 * z2254;
    const Scalar z2260 = s_q3 * z2257 + c_q3 * z2256;
    const Scalar z2261 = s_q3 * z2256 - c_q3 * z2257;
    const Scalar z2262 = n632_over_165 * z2259 - z2260;
    const Scalar z2263 = n632_over_165 * z2258 - z2261;
    const Scalar z2267 = s_q2 * z2262 - c_q2 * z2232;
    const Scalar z2268 = z2100 - z2104;
    const Scalar z2269 = z2096 + z2104;
    const Scalar z2270 = z2096 - z2100;
    const Scalar z2271 = z46 * z2103 - z47 * z2102 + z586 * z906 - z587 * z907 + z590 * z991 + z591 * z990 - z592
        * z1969;
    const Scalar z2272 = z590 * z1971 - z591 * z1970 - z2270;
    const Scalar z2273 = z594 * z1968 - z2113;
    const Scalar z2274 = z593 * z1967 + z2270;
    const Scalar z2275 = z39 * z2274 - z40 * z2273 + z593 * z895 + z595 * z1005 - z596 * z1965 - z597 * z1004;
    const Scalar z2276 = z595 * z1967 + z597 * z1966 - z2122;
    const Scalar z2277 = s_q3 * z2274 - c_q3 * z2273;
    const Scalar z2278 = s_q3 * z2273 + c_q3 * z2274;
    const Scalar z2279 = z594 * z2142 - z2277;
    const Scalar z2280 = z598 * z2142 - z599 * z2141 + z2122;
    const Scalar z2281 = z594 * z2141 - z2278;
    const Scalar z2282 = z35 * z2280 + z36 * z2279 + z594 * z677 + z596 * z1018 - z598 * z678 + z602 * z1019 - z603
        * z1961;
    const Scalar z2283 = z596 * z1962 - z602 * z1963 - z2281;
    const Scalar z2285 = s_q2 * z2279 - c_q2 * z2280;
    const Scalar z2286 = z46 * z2095 + z551 * z990 - z587 * z1969 - z993;
    const Scalar z2287 = z47 * z2095 - z551 * z991 + z586 * z1969 + z992;
    const Scalar z2288 = z46 * z2093 - z47 * z2094 + z586 * z990 - z587 * z991;
    const Scalar z2289 = z46 * z2097 - z47 * z2268 - z551 * z906 - z588 * z991 + z589 * z990 + z590 * z1969 - z1943;
    const Scalar z2290 = z46 * z2269 - z47 * z2099 - z551 * z907 + z584 * z990 - z589 * z991 - z591 * z1969 + z1942;
    const Scalar z2291 = s_q4 * z2287 + c_q4 * z2286;
    const Scalar z2292 = s_q4 * z2286 - c_q4 * z2287;
    const Scalar z2293 = s_q4 * z2290 - c_q4 * z2289;
    const Scalar z2294 = s_q4 * z2289 + c_q4 * z2290;
    const Scalar z2295 = z2271 - z2292;
    const Scalar z2296 = z2288 - z2294;
    const Scalar z2297 = s_q3 * z2288 + c_q3 * z2291;
    const Scalar z2298 = s_q3 * z2291 - c_q3 * z2288;
    const Scalar z2299 = s_q3 * z2295 + c_q3 * z2293;
    const Scalar z2300 = s_q3 * z2293 - c_q3 * z2295;
    const Scalar z2301 = n632_over_165 * z2298 + z2299;
    const Scalar z2302 = n632_over_165 * z2297 - z2300;
    const Scalar z2306 = s_q2 * z2301 - c_q2 * z2296;
    const Scalar z2307 = z551 * z1970 - z2094;
    const Scalar z2308 = z551 * z1971 - z2093;
    const Scalar z2309 = z586 * z1970 + z587 * z1971;
    const Scalar z2310 = z588 * z1971 + z589 * z1970 + z2098;
    const Scalar z2311 = z584 * z1970 + z589 * z1971 + z2101;
    const Scalar z2312 = s_q4 * z2308 + c_q4 * z2307;
    const Scalar z2313 = s_q4 * z2307 - c_q4 * z2308;
    const Scalar z2314 = s_q4 * z2311 - c_q4 * z2310;
    const Scalar z2315 = s_q4 * z2310 + c_q4 * z2311;
    const Scalar z2316 = z2272 + z2313;
    const Scalar z2317 = z2309 - z2315;
    const Scalar z2318 = s_q3 * z2309 + c_q3 * z2312;
    const Scalar z2319 = s_q3 * z2312 - c_q3 * z2309;
    const Scalar z2320 = s_q3 * z2316 - c_q3 * z2314;
    const Scalar z2321 = s_q3 * z2314 + c_q3 * z2316;
    const Scalar z2322 = n632_over_165 * z2319 - z2320;
    const Scalar z2323 = n632_over_165 * z2318 - z2321;
    const Scalar z2327 = s_q2 * z2322 - c_q2 * z2317;
    const Scalar z2328 = z2060 - z2064;
    const Scalar z2329 = z2056 - z2064;
    const Scalar z2330 = z2056 + z2060;
    const Scalar z2331 = z54 * z2063 - z55 * z2062 + z544 * z920 + z545 * z921 + z548 * z979 - z549 * z978 - z550
        * z1973;
    const Scalar z2332 = z548 * z1975 + z549 * z1974 - z2330;
    const Scalar z2333 = z552 * z1972 + z2075;
    const Scalar z2334 = z551 * z2066 + z552 * z2065 - z2330;
    const Scalar z2335 = z46 * z2334 - z47 * z2333 - z551 * z907 - z555 * z991 + z556 * z990 - z557 * z1969;
    const Scalar z2336 = z555 * z1971 + z556 * z1970 - z2086;
    const Scalar z2337 = s_q4 * z2334 + c_q4 * z2333;
    const Scalar z2338 = s_q4 * z2333 - c_q4 * z2334;
    const Scalar z2339 = z552 * z1967 - z559 * z1968 + z2337;
    const Scalar z2340 = z558 * z1967 + z2086;
    const Scalar z2341 = z558 * z1968 + z2338;
    const Scalar z2342 = z39 * z2340 - z40 * z2339 + z552 * z894 + z558 * z895 - z560 * z1005 + z562 * z1004 + z563
        * z1965;
    const Scalar z2343 = z560 * z1967 + z562 * z1966 + z2341;
    const Scalar z2344 = s_q3 * z2340 - c_q3 * z2339;
    const Scalar z2345 = s_q3 * z2339 + c_q3 * z2340;
    const Scalar z2346 = z559 * z2142 + z2344;
    const Scalar z2347 = z564 * z2142 - z565 * z2141 + z2341;
    const Scalar z2348 = z559 * z2141 + z2345;
    const Scalar z2349 = z35 * z2347 - z36 * z2346 - z559 * z677 - z563 * z1018 - z564 * z678 + z568 * z1019 - z569
        * z1961;
    const Scalar z2350 = z563 * z1962 + z568 * z1963 - z2348;
    const Scalar z2352 = s_q2 * z2346 + c_q2 * z2347;
    const Scalar z2353 = z54 * z2055 + z510 * z978 - z545 * z1973 - z981;
    const Scalar z2354 = z55 * z2055 - z510 * z979 - z544 * z1973 - z980;
    const Scalar z2355 = z54 * z2053 + z55 * z2054 - z544 * z978 - z545 * z979;
    const Scalar z2356 = z54 * z2057 - z55 * z2328 - z510 * z920 + z546 * z979 - z547 * z978 - z548 * z1973 + z1938;
    const Scalar z2357 = z54 * z2329 - z55 * z2059 + z509 * z978 + z510 * z921 - z547 * z979 + z549 * z1973 + z1937;
    const Scalar z2358 = s_q5 * z2354 - c_q5 * z2353;
    const Scalar z2359 = s_q5 * z2353 + c_q5 * z2354;
    const Scalar z2360 = s_q5 * z2357 - c_q5 * z2356;
    const Scalar z2361 = s_q5 * z2356 + c_q5 * z2357;
    const Scalar z2362 = n256_over_55 * z2359 + z2360;
    const Scalar z2363 = z2331 + z2359;
    const Scalar z2364 = z2355 + n256_over_55 * z2358 - z2361;
    const Scalar z2365 = s_q4 * z2355 - c_q4 * z2358;
    const Scalar z2366 = s_q4 * z2358 + c_q4 * z2355;
    const Scalar z2367 = s_q4 * z2363 - c_q4 * z2362;
    const Scalar z2368 = s_q4 * z2362 + c_q4 * z2363;
    const Scalar z2369 = z2364 - z2366;
    const Scalar z2370 = z2359 - z2368;
    const Scalar z2371 = s_q3 * z2359 - c_q3 * z2365;
    const Scalar z2372 = s_q3 * z2365 + c_q3 * z2359;
    const Scalar z2373 = s_q3 * z2369 + c_q3 * z2367;
    const Scalar z2374 = s_q3 * z2367 - c_q3 * z2369;
    const Scalar z2375 = n632_over_165 * z2372 - z2373;
    const Scalar z2376 = n632_over_165 * z2371 - z2374;
    const Scalar z2380 = s_q2 * z2375 + c_q2 * z2370;
    const Scalar z2381 = z510 * z1974 + z2054;
    const Scalar z2382 = z510 * z1975 - z2053;
    const Scalar z2383 = z544 * z1974 - z545 * z1975;
    const Scalar z2384 = z546 * z1975 + z547 * z1974 + z2058;
    const Scalar z2385 = z509 * z1974 + z547 * z1975 + z2061;
    const Scalar z2386 = s_q5 * z2382 - c_q5 * z2381;
    const Scalar z2387 = s_q5 * z2381 + c_q5 * z2382;
    const Scalar z2388 = s_q5 * z2385 + c_q5 * z2384;
    const Scalar z2389 = s_q5 * z2384 - c_q5 * z2385;
    const Scalar z2390 = n256_over_55 * z2387 + z2388;
    const Scalar z2391 = z2332 - z2387;
    const Scalar z2392 = z2383 - n256_over_55 * z2386 - z2389;
    const Scalar z2393 = s_q4 * z2383 + c_q4 * z2386;
    const Scalar z2394 = s_q4 * z2386 - c_q4 * z2383;
    const Scalar z2395 = s_q4 * z2391 + c_q4 * z2390;
    const Scalar z2396 = s_q4 * z2390 - c_q4 * z2391;
    const Scalar z2397 = z2392 + z2394;
    const Scalar z2398 = z2387 - z2396;
    const Scalar z2399 = s_q3 * z2387 + c_q3 * z2393;
    const Scalar z2400 = s_q3 * z2393 - c_q3 * z2387;
    const Scalar z2401 = s_q3 * z2397 + c_q3 * z2395;
    const Scalar z2402 = s_q3 * z2395 - c_q3 * z2397;
    const Scalar z2403 = n632_over_165 * z2400 - z2401;
    const Scalar z2404 = n632_over_165 * z2399 + z2402;
    const Scalar z2408 = s_q2 * z2403 - c_q2 * z2398;
    const Scalar z2409 = z2031 - z2035;
    const Scalar z2410 = z2027 + z2035;
    const Scalar z2411 = z2027 - z2031;
    const Scalar z2412 = z59 * z2034 + z60 * z2033 + z504 * z927 - z507 * z963 + z508 * z962 - z509 * z1977 - k18
        * z928;
    const Scalar z2413 = z507 * z1979 + z508 * z1978 + z2411;
    const Scalar z2414 = z54 * z2411 - z55 * z2044 + z509 * z978 + z510 * z921 + z512 * z979 + z513 * z1973;
    const Scalar z2415 = z509 * z1974 - z512 * z1975 - z2045;
    const Scalar z2416 = s_q5 * z2411 - c_q5 * z2044;
    const Scalar z2417 = s_q5 * z2044 + c_q5 * z2411;
    const Scalar z2418 = z511 * z2066 + z515 * z1972 + z2416;
    const Scalar z2419 = z514 * z2066 - z515 * z2065 - z2045;
    const Scalar z2420 = z511 * z2065 + z514 * z1972 + z2417;
    const Scalar z2421 = z46 * z2419 + z47 * z2418 - z511 * z906 - z514 * z907 + z518 * z991 + z519 * z990 + z520
        * z1969;
    const Scalar z2422 = z518 * z1971 - z519 * z1970 + z2420;
    const Scalar z2423 = s_q4 * z2419 - c_q4 * z2418;
    const Scalar z2424 = s_q4 * z2418 + c_q4 * z2419;
    const Scalar z2425 = z515 * z1967 + z522 * z1968 - z2423;
    const Scalar z2426 = z521 * z1967 + z2420;
    const Scalar z2427 = z521 * z1968 - z2424;
    const Scalar z2428 = z39 * z2426 + z40 * z2425 - z515 * z894 + z521 * z895 - z523 * z1005 - z525 * z1004 - z526
        * z1965;
    const Scalar z2429 = z523 * z1967 - z525 * z1966 + z2427;
    const Scalar z2430 = s_q3 * z2426 + c_q3 * z2425;
    const Scalar z2431 = s_q3 * z2425 - c_q3 * z2426;
    const Scalar z2432 = z522 * z2142 + z2430;
    const Scalar z2433 = z527 * z2142 + z528 * z2141 - z2427;
    const Scalar z2434 = z522 * z2141 - z2431;
    const Scalar z2435 = z35 * z2433 + z36 * z2432 + z522 * z677 - z526 * z1018 - z527 * z678 - z531 * z1019 - z532
        * z1961;
    const Scalar z2436 = z526 * z1962 - z531 * z1963 + z2434;
    const Scalar z2438 = s_q2 * z2432 - c_q2 * z2433;
    const Scalar z2439 = z59 * z2026 + z465 * z962 - z965 - k18 * z1977;
    const Scalar z2440 = z60 * z2026 - z465 * z963 - z504 * z1977 - z964;
    const Scalar z2441 = z59 * z2024 + z60 * z2025 - z504 * z962 - k18 * z963;
    const Scalar z2442 = z59 * z2028 - z60 * z2409 + z465 * z927 + z505 * z963 - z506 * z962 - z507 * z1977 - z1933;
    const Scalar z2443 = z59 * z2410 + z60 * z2030 - z465 * z928 + z502 * z962 + z506 * z963 - z508 * z1977 + z1932;
    const Scalar z2444 = s_q6 * z2440 - c_q6 * z2439;
    const Scalar z2445 = s_q6 * z2439 + c_q6 * z2440;
    const Scalar z2446 = s_q6 * z2443 + c_q6 * z2442;
    const Scalar z2447 = s_q6 * z2442 - c_q6 * z2443;
    const Scalar z2448 = s_q5 * z2441 - c_q5 * z2444;
    const Scalar z2449 = s_q5 * z2444 + c_q5 * z2441;
    const Scalar z2450 = s_q5 * z2412 - c_q5 * z2446;
    const Scalar z2451 = s_q5 * z2446 + c_q5 * z2412;
    const Scalar z2452 = n256_over_55 * z2449 + z2450;
    const Scalar z2453 = z2447 - z2449;
    const Scalar z2454 = z2445 + n256_over_55 * z2448 - z2451;
    const Scalar z2455 = s_q4 * z2445 - c_q4 * z2448;
    const Scalar z2456 = s_q4 * z2448 + c_q4 * z2445;
    const Scalar z2457 = s_q4 * z2453 + c_q4 * z2452;
    const Scalar z2458 = s_q4 * z2452 - c_q4 * z2453;
    const Scalar z2459 = z2454 - z2456;
    const Scalar z2460 = z2449 - z2458;
    const Scalar z2461 = s_q3 * z2449 - c_q3 * z2455;
    const Scalar z2462 = s_q3 * z2455 + c_q3 * z2449;
    const Scalar z2463 = s_q3 * z2459 - c_q3 * z2457;
    const Scalar z2464 = s_q3 * z2457 + c_q3 * z2459;
    const Scalar z2465 = n632_over_165 * z2462 - z2463;
    const Scalar z2466 = n632_over_165 * z2461 + z2464;
    const Scalar z2470 = s_q2 * z2465 + c_q2 * z2460;
    const Scalar z2471 = z465 * z1978 + z2025;
    const Scalar z2472 = z465 * z1979 - z2024;
    const Scalar z2473 = z504 * z1978 - k18 * z1979;
    const Scalar z2474 = z505 * z1979 + z506 * z1978 - z2029;
    const Scalar z2475 = z502 * z1978 - z506 * z1979 + z2032;
    const Scalar z2476 = s_q6 * z2472 - c_q6 * z2471;
    const Scalar z2477 = s_q6 * z2471 + c_q6 * z2472;
    const Scalar z2478 = s_q6 * z2475 - c_q6 * z2474;
    const Scalar z2479 = s_q6 * z2474 + c_q6 * z2475;
    const Scalar z2480 = s_q5 * z2473 + c_q5 * z2476;
    const Scalar z2481 = s_q5 * z2476 - c_q5 * z2473;
    const Scalar z2482 = s_q5 * z2413 - c_q5 * z2478;
    const Scalar z2483 = s_q5 * z2478 + c_q5 * z2413;
    const Scalar z2484 = n256_over_55 * z2481 + z2482;
    const Scalar z2485 = z2479 + z2481;
    const Scalar z2486 = z2477 - n256_over_55 * z2480 - z2483;
    const Scalar z2487 = s_q4 * z2477 + c_q4 * z2480;
    const Scalar z2488 = s_q4 * z2480 - c_q4 * z2477;
    const Scalar z2489 = s_q4 * z2485 - c_q4 * z2484;
    const Scalar z2490 = s_q4 * z2484 + c_q4 * z2485;
    const Scalar z2491 = z2486 + z2488;
    const Scalar z2492 = z2481 - z2490;
    const Scalar z2493 = s_q3 * z2481 - c_q3 * z2487;
    const Scalar z2494 = s_q3 * z2487 + c_q3 * z2481;
    const Scalar z2495 = s_q3 * z2491 + c_q3 * z2489;
    const Scalar z2496 = s_q3 * z2489 - c_q3 * z2491;
    const Scalar z2497 = n632_over_165 * z2494 - z2495;
    const Scalar z2498 = n632_over_165 * z2493 - z2496;
    const Scalar z2502 = s_q2 * z2497 + c_q2 * z2492;
    const Scalar z2503 = z1995 - z1999;
    const Scalar z2504 = z1991 - z1999;
    const Scalar z2505 = z1991 + z1995;
    const Scalar z2506 = z66 * z1998 + z67 * z1997 - k0 * z939 + k1 * z940 + k2 * z948 - k3 * z949 - k4 * z1981;
    const Scalar z2507 = k2 * z1982 + k3 * z1983 - z2505;
    const Scalar z2508 = z466 * z2000 + z2010;
    const Scalar z2509 = z465 * z2001 + z2505;
    const Scalar z2510 = z59 * z2509 - z60 * z2508 - z465 * z928 - z467 * z963 - z468 * z1977 + z469 * z962;
    const Scalar z2511 = z467 * z1979 + z469 * z1978 + z2018;
    const Scalar z2512 = s_q6 * z2509 - c_q6 * z2508;
    const Scalar z2513 = s_q6 * z2508 + c_q6 * z2509;
    const Scalar z2514 = z54 * z2018 - z55 * z2512 - z466 * z920 + z468 * z978 - z470 * z921 + z472 * z979 + z473
        * z1973;
    const Scalar z2515 = z468 * z1974 - z472 * z1975 + z2513;
    const Scalar z2516 = s_q5 * z2018 - c_q5 * z2512;
    const Scalar z2517 = s_q5 * z2512 + c_q5 * z2018;
    const Scalar z2518 = z471 * z2066 - z475 * z1972 + z2516;
    const Scalar z2519 = z474 * z2066 + z475 * z2065 + z2513;
    const Scalar z2520 = z471 * z2065 + z474 * z1972 + z2517;
    const Scalar z2521 = z46 * z2519 + z47 * z2518 - z471 * z906 - z474 * z907 - z478 * z991 + z479 * z990 + z480
        * z1969;
    const Scalar z2522 = z478 * z1971 + z479 * z1970 - z2520;
    const Scalar z2523 = s_q4 * z2519 - c_q4 * z2518;
    const Scalar z2524 = s_q4 * z2518 + c_q4 * z2519;
    const Scalar z2525 = z475 * z1967 - z482 * z1968 + z2523;
    const Scalar z2526 = z481 * z1967 + z2520;
    const Scalar z2527 = z481 * z1968 - z2524;
    const Scalar z2528 = z39 * z2526 - z40 * z2525 + z475 * z894 + z481 * z895 - z483 * z1005 - z485 * z1004 + z486
        * z1965;
    const Scalar z2529 = z483 * z1967 - z485 * z1966 + z2527;
    const Scalar z2530 = s_q3 * z2526 - c_q3 * z2525;
    const Scalar z2531 = s_q3 * z2525 + c_q3 * z2526;
    const Scalar z2532 = z482 * z2142 + z2530;
    const Scalar z2533 = z487 * z2142 - z488 * z2141 + z2527;
    const Scalar z2534 = z482 * z2141 + z2531;
    const Scalar z2535 = z35 * z2533 - z36 * z2532 - z482 * z677 - z486 * z1018 - z487 * z678 + z491 * z1019 - z492
        * z1961;
    const Scalar z2536 = z486 * z1962 + z491 * z1963 - z2534;
    const Scalar z2538 = s_q2 * z2532 + c_q2 * z2533;
    const Scalar z2539 = z66 * z1990 - z951 - k1 * z1981;
    const Scalar z2540 = z67 * z1990 + z950 + k0 * z1981;
    const Scalar z2541 = z66 * z1988 - z67 * z1989 + k0 * z948 - k1 * z949;
    const Scalar z2542 = z66 * z1992 - z67 * z2503 - k10 * z948 - k8 * z949 - z1929 - k3 * z1981;
    const Scalar z2543 = z66 * z2504 - z67 * z1994 - k10 * z949 - z1928 + k2 * z1981;
    const Scalar z2544 = s_q7 * z2540 + c_q7 * z2539;
    const Scalar z2545 = s_q7 * z2539 - c_q7 * z2540;
    const Scalar z2546 = s_q7 * z2543 + c_q7 * z2542;
    const Scalar z2547 = s_q7 * z2542 - c_q7 * z2543;
    const Scalar z2548 = z2506 + n16_over_15 * z2545;
    const Scalar z2549 = n16_over_15 * z2541 + z2547;
    const Scalar z2550 = s_q6 * z2541 + c_q6 * z2544;
    const Scalar z2551 = s_q6 * z2544 - c_q6 * z2541;
    const Scalar z2552 = s_q6 * z2548 - c_q6 * z2546;
    const Scalar z2553 = s_q6 * z2546 + c_q6 * z2548;
    const Scalar z2554 = s_q5 * z2545 + c_q5 * z2550;
    const Scalar z2555 = s_q5 * z2550 - c_q5 * z2545;
    const Scalar z2556 = s_q5 * z2549 - c_q5 * z2552;
    const Scalar z2557 = s_q5 * z2552 + c_q5 * z2549;
    const Scalar z2558 = n256_over_55 * z2555 + z2556;
    const Scalar z2559 = z2553 + z2555;
    const Scalar z2560 = z2551 + n256_over_55 * z2554 + z2557;
    const Scalar z2561 = s_q4 * z2551 - c_q4 * z2554;
    const Scalar z2562 = s_q4 * z2554 + c_q4 * z2551;
    const Scalar z2563 = s_q4 * z2559 - c_q4 * z2558;
    const Scalar z2564 = s_q4 * z2558 + c_q4 * z2559;
    const Scalar z2565 = z2560 - z2562;
    const Scalar z2566 = z2555 - z2564;
    const Scalar z2567 = s_q3 * z2555 + c_q3 * z2561;
    const Scalar z2568 = s_q3 * z2561 - c_q3 * z2555;
    const Scalar z2569 = s_q3 * z2565 - c_q3 * z2563;
    const Scalar z2570 = s_q3 * z2563 + c_q3 * z2565;
    const Scalar z2571 = n632_over_165 * z2568 - z2569;
    const Scalar z2572 = n632_over_165 * z2567 - z2570;
    const Scalar z2576 = s_q2 * z2571 - c_q2 * z2566;
    const Scalar z2577 = k0 * z1982 + k1 * z1983;
    const Scalar z2578 = k10 * z1982 - k8 * z1983 - z1993;
    const Scalar z2579 = k10 * z1983 - z1996;
    const Scalar z2580 = s_q7 * z2579 - c_q7 * z2578;
    const Scalar z2581 = s_q7 * z2578 + c_q7 * z2579;
    const Scalar z2582 = n16_over_15 * z2002 - z2507;
    const Scalar z2583 = n16_over_15 * z2577 - z2581;
    const Scalar z2584 = s_q6 * z2577 - c_q6 * z2003;
    const Scalar z2585 = s_q6 * z2003 + c_q6 * z2577;
    const Scalar z2586 = s_q6 * z2582 + c_q6 * z2580;
    const Scalar z2587 = s_q6 * z2580 - c_q6 * z2582;
    const Scalar z2588 = s_q5 * z2002 - c_q5 * z2584;
    const Scalar z2589 = s_q5 * z2584 + c_q5 * z2002;
    const Scalar z2590 = s_q5 * z2583 + c_q5 * z2586;
    const Scalar z2591 = s_q5 * z2586 - c_q5 * z2583;
    const Scalar z2592 = n256_over_55 * z2589 + z2590;
    const Scalar z2593 = z2587 + z2589;
    const Scalar z2594 = z2585 + n256_over_55 * z2588 + z2591;
    const Scalar z2595 = s_q4 * z2585 - c_q4 * z2588;
    const Scalar z2596 = s_q4 * z2588 + c_q4 * z2585;
    const Scalar z2597 = s_q4 * z2593 - c_q4 * z2592;
    const Scalar z2598 = s_q4 * z2592 + c_q4 * z2593;
    const Scalar z2599 = z2594 - z2596;
    const Scalar z2600 = z2589 - z2598;
    const Scalar z2601 = s_q3 * z2589 - c_q3 * z2595;
    const Scalar z2602 = s_q3 * z2595 + c_q3 * z2589;
    const Scalar z2603 = s_q3 * z2599 + c_q3 * z2597;
    const Scalar z2604 = s_q3 * z2597 - c_q3 * z2599;
    const Scalar z2605 = n632_over_165 * z2602 - z2603;
    const Scalar z2606 = n632_over_165 * z2601 - z2604;
    const Scalar z2610 = s_q2 * z2605 + c_q2 * z2600;
    const Scalar z2611 = u_tau1 - z1959;
    const Scalar z2612 = u_tau2 - z1954;
    const Scalar z2613 = u_tau3 + z1949;
    const Scalar z2614 = u_tau4 - z1944;
    const Scalar z2615 = u_tau5 + z1939;
    const Scalar z2616 = u_tau6 - z1934;
    const Scalar z2617 = u_tau7 - z955;
    const Scalar z2618 = z1581 * z2538 - z2438;
    const Scalar z2619 = z1580 * z2538 - z1608 * z2618 - z2352;
    const Scalar z2620 = z1579 * z2538 - z1607 * z2618 - z1628 * z2619 + z2285;
    const Scalar z2621 = z1578 * z2538 - z1606 * z2618 - z1627 * z2619 - z1642 * z2620 + z2237;
    const Scalar z2622 = z1577 * z2538 - z1605 * z2618 - z1626 * z2619 - z1641 * z2620 - z1651 * z2621 - z2188;
    const Scalar z2623 = z1576 * z2538 - z1604 * z2618 - z1625 * z2619 - z1640 * z2620 - z1650 * z2621 - z1656 * z2622
        - z2204;
    const Scalar z2624 = z1658 * z2623;
    const Scalar z2625 = z1655 * z2622 - z1656 * z2624;
    const Scalar z2626 = z1649 * z2621 - z1650 * z2624 - z1651 * z2625;
    const Scalar z2627 = z1639 * z2620 - z1640 * z2624 - z1641 * z2625 - z1642 * z2626;
    const Scalar z2628 = z1624 * z2619 - z1625 * z2624 - z1626 * z2625 - z1627 * z2626 - z1628 * z2627;
    const Scalar z2629 = z1603 * z2618 - z1604 * z2624 - z1605 * z2625 - z1606 * z2626 - z1607 * z2627 - z1608 * z2628;
    const Scalar z2630 = z1576 * z2624 + z1577 * z2625 + z1578 * z2626 + z1579 * z2627 + z1580 * z2628 + z1581 * z2629
        - k52 * z2538;
    const Scalar z2631 = z1581 * z2535 + z2435;
    const Scalar z2632 = z1580 * z2535 - z1608 * z2631 - z2349;
    const Scalar z2633 = z1579 * z2535 - z1607 * z2631 - z1628 * z2632 - z2282;
    const Scalar z2634 = z1578 * z2535 - z1606 * z2631 - z1627 * z2632 - z1642 * z2633 - z2234;
    const Scalar z2635 = z1577 * z2535 - z1605 * z2631 - z1626 * z2632 - z1641 * z2633 - z1651 * z2634 - z2208;
    const Scalar z2636 = z1576 * z2535 - z1604 * z2631 - z1625 * z2632 - z1640 * z2633 - z1650 * z2634 - z1656 * z2635
        - z2218;
    const Scalar z2637 = z1658 * z2636;
    const Scalar z2638 = z1655 * z2635 - z1656 * z2637;
    const Scalar z2639 = z1649 * z2634 - z1650 * z2637 - z1651 * z2638;
    const Scalar z2640 = z1639 * z2633 - z1640 * z2637 - z1641 * z2638 - z1642 * z2639;
    const Scalar z2641 = z1624 * z2632 - z1625 * z2637 - z1626 * z2638 - z1627 * z2639 - z1628 * z2640;
    const Scalar z2642 = z1603 * z2631 - z1604 * z2637 - z1605 * z2638 - z1606 * z2639 - z1607 * z2640 - z1608 * z2641;
    const Scalar z2643 = z1576 * z2637 + z1577 * z2638 + z1578 * z2639 + z1579 * z2640 + z1580 * z2641 + z1581 * z2642
        - k52 * z2535;
    const Scalar z2644 = z1581 * z2536 + z2436;
    const Scalar z2645 = z1580 * z2536 - z1608 * z2644 - z2350;
    const Scalar z2646 = z1579 * z2536 - z1607 * z2644 - z1628 * z2645 + z2283;
    const Scalar z2647 = z1578 * z2536 - z1606 * z2644 - z1627 * z2645 - z1642 * z2646 - z2235;
    const Scalar z2648 = z1577 * z2536 - z1605 * z2644 - z1626 * z2645 - z1641 * z2646 - z1651 * z2647 + z2209;
    const Scalar z2649 = z1576 * z2536 - z1604 * z2644 - z1625 * z2645 - z1640 * z2646 - z1650 * z2647 - z1656 * z2648
        - z2227;
    const Scalar z2650 = z1658 * z2649;
    const Scalar z2651 = z1655 * z2648 - z1656 * z2650;
    const Scalar z2652 = z1649 * z2647 - z1650 * z2650 - z1651 * z2651;
    const Scalar z2653 = z1639 * z2646 - z1640 * z2650 - z1641 * z2651 - z1642 * z2652;
    const Scalar z2654 = z1624 * z2645 - z1625 * z2650 - z1626 * z2651 - z1627 * z2652 - z1628 * z2653;
    const Scalar z2655 = z1603 * z2644 - z1604 * z2650 - z1605 * z2651 - z1606 * z2652 - z1607 * z2653 - z1608 * z2654;
    const Scalar z2656 = z1576 * z2650 + z1577 * z2651 + z1578 * z2652 + z1579 * z2653 + z1580 * z2654 + z1581 * z2655
        - k52 * z2536;
    const Scalar z2657 = z1581 * z2528 - z2428;
    const Scalar z2658 = z1580 * z2528 - z1608 * z2657 - z2342;
    const Scalar z2659 = z1579 * z2528 - z1607 * z2657 - z1628 * z2658 - z2275;
    const Scalar z2660 = z1578 * z2528 - z1606 * z2657 - z1627 * z2658 - z1642 * z2659 + z2231;
    const Scalar z2661 = z1577 * z2528 - z1605 * z2657 - z1626 * z2658 - z1641 * z2659 - z1651 * z2660 - z2248;
    const Scalar z2662 = z1576 * z2528 - z1604 * z2657 - z1625 * z2658 - z1640 * z2659 - z1650 * z2660 - z1656 * z2661
        + z2252;
    const Scalar z2663 = z1658 * z2662;
    const Scalar z2664 = z1655 * z2661 - z1656 * z2663;
    const Scalar z2665 = z1649 * z2660 - z1650 * z2663 - z1651 * z2664;
    const Scalar z2666 = z1639 * z2659 - z1640 * z2663 - z1641 * z2664 - z1642 * z2665;
    const Scalar z2667 = z1624 * z2658 - z1625 * z2663 - z1626 * z2664 - z1627 * z2665 - z1628 * z2666;
    const Scalar z2668 = z1603 * z2657 - z1604 * z2663 - z1605 * z2664 - z1606 * z2665 - z1607 * z2666 - z1608 * z2667;
    const Scalar z2669 = z1576 * z2663 + z1577 * z2664 + z1578 * z2665 + z1579 * z2666 + z1580 * z2667 + z1581 * z2668
        - k52 * z2528;
    const Scalar z2670 = z1581 * z2529 - z2429;
    const Scalar z2671 = z1580 * z2529 - z1608 * z2670 - z2343;
    const Scalar z2672 = z1579 * z2529 - z1607 * z2670 - z1628 * z2671 + z2276;
    const Scalar z2673 = z1578 * z2529 - z1606 * z2670 - z1627 * z2671 - z1642 * z2672 + z2232;
    const Scalar z2674 = z1577 * z2529 - z1605 * z2670 - z1626 * z2671 - z1641 * z2672 - z1651 * z2673 - z2263;
    const Scalar z2675 = z1576 * z2529 - z1604 * z2670 - z1625 * z2671 - z1640 * z2672 - z1650 * z2673 - z1656 * z2674
        + z2267;
    const Scalar z2676 = z1658 * z2675;
    const Scalar z2677 = z1655 * z2674 - z1656 * z2676;
    const Scalar z2678 = z1649 * z2673 - z1650 * z2676 - z1651 * z2677;
    const Scalar z2679 = z1639 * z2672 - z1640 * z2676 - z1641 * z2677 - z1642 * z2678;
    const Scalar z2680 = z1624 * z2671 - z1625 * z2676 - z1626 * z2677 - z1627 * z2678 - z1628 * z2679;
    const Scalar z2681 = z1603 * z2670 - z1604 * z2676 - z1605 * z2677 - z1606 * z2678 - z1607 * z2679 - z1608 * z2680;
    const Scalar z2682 = z1576 * z2676 + z1577 * z2677 + z1578 * z2678 + z1579 * z2679 + z1580 * z2680 + z1581 * z2681
        - k52 * z2529;
    const Scalar z2683 = z1581 * z2521 - z2421;
    const Scalar z2684 = z1580 * z2521 - z1608 * z2683 - z2335;
    const Scalar z2685 = z1579 * z2521 - z1607 * z2683 - z1628 * z2684 + z2271;
    const Scalar z2686 = z1578 * z2521 - z1606 * z2683 - z1627 * z2684 - z1642 * z2685 - z2296;
    const Scalar z2687 = z1577 * z2521 - z1605 * z2683 - z1626 * z2684 - z1641 * z2685 - z1651 * z2686 - z2302;
    const Scalar z2688 = z1576 * z2521 - z1604 * z2683 - z1625 * z2684 - z1640 * z2685 - z1650 * z2686 - z1656 * z2687
        - z2306;
    const Scalar z2689 = z1658 * z2688;
    const Scalar z2690 = z1655 * z2687 - z1656 * z2689;
    const Scalar z2691 = z1649 * z2686 - z1650 * z2689 - z1651 * z2690;
    const Scalar z2692 = z1639 * z2685 - z1640 * z2689 - z1641 * z2690 - z1642 * z2691;
    const Scalar z2693 = z1624 * z2684 - z1625 * z2689 - z1626 * z2690 - z1627 * z2691 - z1628 * z2692;
    const Scalar z2694 = z1603 * z2683 - z1604 * z2689 - z1605 * z2690 - z1606 * z2691 - z1607 * z2692 - z1608 * z2693;
    const Scalar z2695 = z1576 * z2689 + z1577 * z2690 + z1578 * z2691 + z1579 * z2692 + z1580 * z2693 + z1581 * z2694
        - k52 * z2521;
    const Scalar z2696 = z1581 * z2522 + z2422;
    const Scalar z2697 = z1580 * z2522 - z1608 * z2696 - z2336;
    const Scalar z2698 = z1579 * z2522 - z1607 * z2696 - z1628 * z2697 - z2272;
    const Scalar z2699 = z1578 * z2522 - z1606 * z2696 - z1627 * z2697 - z1642 * z2698 - z2317;
    const Scalar z2700 = z1577 * z2522 - z1605 * z2696 - z1626 * z2697 - z1641 * z2698 - z1651 * z2699 - z2323;
    const Scalar z2701 = z1576 * z2522 - z1604 * z2696 - z1625 * z2697 - z1640 * z2698 - z1650 * z2699 - z1656 * z2700
        - z2327;
    const Scalar z2702 = z1658 * z2701;
    const Scalar z2703 = z1655 * z2700 - z1656 * z2702;
    const Scalar z2704 = z1649 * z2699 - z1650 * z2702 - z1651 * z2703;
    const Scalar z2705 = z1639 * z2698 - z1640 * z2702 - z1641 * z2703 - z1642 * z2704;
    const Scalar z2706 = z1624 * z2697 - z1625 * z2702 - z1626 * z2703 - z1627 * z2704 - z1628 * z2705;
    const Scalar z2707 = z1603 * z2696 - z1604 * z2702 - z1605 * z2703 - z1606 * z2704 - z1607 * z2705 - z1608 * z2706;
    const Scalar z2708 = z1576 * z2702 + z1577 * z2703 + z1578 * z2704 + z1579 * z2705 + z1580 * z2706 + z1581 * z2707
        - k52 * z2522;
    const Scalar z2709 = z1581 * z2514 - z2414;
    const Scalar z2710 = z1580 * z2514 - z1608 * z2709 + z2331;
    const Scalar z2711 = z1579 * z2514 - z1607 * z2709 - z1628 * z2710 - z2364;
    const Scalar z2712 = z1578 * z2514 - z1606 * z2709 - z1627 * z2710 - z1642 * z2711 + z2370;
    const Scalar z2713 = z1577 * z2514 - z1605 * z2709 - z1626 * z2710 - z1641 * z2711 - z1651 * z2712 + z2376;
    const Scalar z2714 = z1576 * z2514 - z1604 * z2709 - z1625 * z2710 - z1640 * z2711 - z1650 * z2712 - z1656 * z2713
        - z2380;
    const Scalar z2715 = z1658 * z2714;
    const Scalar z2716 = z1655 * z2713 - z1656 * z2715;
    const Scalar z2717 = z1649 * z2712 - z1650 * z2715 - z1651 * z2716;
    const Scalar z2718 = z1639 * z2711 - z1640 * z2715 - z1641 * z2716 - z1642 * z2717;
    const Scalar z2719 = z1624 * z2710 - z1625 * z2715 - z1626 * z2716 - z1627 * z2717 - z1628 * z2718;
    const Scalar z2720 = z1603 * z2709 - z1604 * z2715 - z1605 * z2716 - z1606 * z2717 - z1607 * z2718 - z1608 * z2719;
    const Scalar z2721 = z1576 * z2715 + z1577 * z2716 + z1578 * z2717 + z1579 * z2718 + z1580 * z2719 + z1581 * z2720
        - k52 * z2514;
    const Scalar z2722 = z1581 * z2515 - z2415;
    const Scalar z2723 = z1580 * z2515 - z1608 * z2722 - z2332;
    const Scalar z2724 = z1579 * z2515 - z1607 * z2722 - z1628 * z2723 + z2392;
    const Scalar z2725 = z1578 * z2515 - z1606 * z2722 - z1627 * z2723 - z1642 * z2724 + z2398;
    const Scalar z2726 = z1577 * z2515 - z1605 * z2722 - z1626 * z2723 - z1641 * z2724 - z1651 * z2725 + z2404;
    const Scalar z2727 = z1576 * z2515 - z1604 * z2722 - z1625 * z2723 - z1640 * z2724 - z1650 * z2725 - z1656 * z2726
        + z2408;
    const Scalar z2728 = z1658 * z2727;
    const Scalar z2729 = z1655 * z2726 - z1656 * z2728;
    const Scalar z2730 = z1649 * z2725 - z1650 * z2728 - z1651 * z2729;
    const Scalar z2731 = z1639 * z2724 - z1640 * z2728 - z1641 * z2729 - z1642 * z2730;
    const Scalar z2732 = z1624 * z2723 - z1625 * z2728 - z1626 * z2729 - z1627 * z2730 - z1628 * z2731;
    const Scalar z2733 = z1603 * z2722 - z1604 * z2728 - z1605 * z2729 - z1606 * z2730 - z1607 * z2731 - z1608 * z2732;
    const Scalar z2734 = z1576 * z2728 + z1577 * z2729 + z1578 * z2730 + z1579 * z2731 + z1580 * z2732 + z1581 * z2733
        - k52 * z2515;
    const Scalar z2735 = z1581 * z2510 - z2412;
    const Scalar z2736 = z1580 * z2510 - z1608 * z2735 - z2447;
    const Scalar z2737 = z1579 * z2510 - z1607 * z2735 - z1628 * z2736 - z2454;
    const Scalar z2738 = z1578 * z2510 - z1606 * z2735 - z1627 * z2736 - z1642 * z2737 + z2460;
    const Scalar z2739 = z1577 * z2510 - z1605 * z2735 - z1626 * z2736 - z1641 * z2737 - z1651 * z2738 + z2466;
    const Scalar z2740 = z1576 * z2510 - z1604 * z2735 - z1625 * z2736 - z1640 * z2737 - z1650 * z2738 - z1656 * z2739
        - z2470;
    const Scalar z2741 = z1658 * z2740;
    const Scalar z2742 = z1655 * z2739 - z1656 * z2741;
    const Scalar z2743 = z1649 * z2738 - z1650 * z2741 - z1651 * z2742;
    const Scalar z2744 = z1639 * z2737 - z1640 * z2741 - z1641 * z2742 - z1642 * z2743;
    const Scalar z2745 = z1624 * z2736 - z1625 * z2741 - z1626 * z2742 - z1627 * z2743 - z1628 * z2744;
    const Scalar z2746 = z1603 * z2735 - z1604 * z2741 - z1605 * z2742 - z1606 * z2743 - z1607 * z2744 - z1608 * z2745;
    const Scalar z2747 = z1576 * z2741 + z1577 * z2742 + z1578 * z2743 + z1579 * z2744 + z1580 * z2745 + z1581 * z2746
        - k52 * z2510;
    const Scalar z2748 = z1581 * z2511 - z2413;
    const Scalar z2749 = z1580 * z2511 - z1608 * z2748 + z2479;
    const Scalar z2750 = z1579 * z2511 - z1607 * z2748 - z1628 * z2749 - z2486;
    const Scalar z2751 = z1578 * z2511 - z1606 * z2748 - z1627 * z2749 - z1642 * z2750 + z2492;
    const Scalar z2752 = z1577 * z2511 - z1605 * z2748 - z1626 * z2749 - z1641 * z2750 - z1651 * z2751 + z2498;
    const Scalar z2753 = z1576 * z2511 - z1604 * z2748 - z1625 * z2749 - z1640 * z2750 - z1650 * z2751 - z1656 * z2752
        - z2502;
    const Scalar z2754 = z1658 * z2753;
    const Scalar z2755 = z1655 * z2752 - z1656 * z2754;
    const Scalar z2756 = z1649 * z2751 - z1650 * z2754 - z1651 * z2755;
    const Scalar z2757 = z1639 * z2750 - z1640 * z2754 - z1641 * z2755 - z1642 * z2756;
    const Scalar z2758 = z1624 * z2749 - z1625 * z2754 - z1626 * z2755 - z1627 * z2756 - z1628 * z2757;
    const Scalar z2759 = z1603 * z2748 - z1604 * z2754 - z1605 * z2755 - z1606 * z2756 - z1607 * z2757 - z1608 * z2758;
    const Scalar z2760 = z1576 * z2754 + z1577 * z2755 + z1578 * z2756 + z1579 * z2757 + z1580 * z2758 + z1581 * z2759
        - k52 * z2511;
    const Scalar z2761 = z1581 * z2506 - z2549;
    const Scalar z2762 = z1580 * z2506 - z1608 * z2761 + z2553;
    const Scalar z2763 = z1579 * z2506 - z1607 * z2761 - z1628 * z2762 + z2560;
    const Scalar z2764 = z1578 * z2506 - z1606 * z2761 - z1627 * z2762 - z1642 * z2763 + z2566;
    const Scalar z2765 = z1577 * z2506 - z1605 * z2761 - z1626 * z2762 - z1641 * z2763 - z1651 * z2764 + z2572;
    const Scalar z2766 = z1576 * z2506 - z1604 * z2761 - z1625 * z2762 - z1640 * z2763 - z1650 * z2764 - z1656 * z2765
        + z2576;
    const Scalar z2767 = z1658 * z2766;
    const Scalar z2768 = z1655 * z2765 - z1656 * z2767;
    const Scalar z2769 = z1649 * z2764 - z1650 * z2767 - z1651 * z2768;
    const Scalar z2770 = z1639 * z2763 - z1640 * z2767 - z1641 * z2768 - z1642 * z2769;
    const Scalar z2771 = z1624 * z2762 - z1625 * z2767 - z1626 * z2768 - z1627 * z2769 - z1628 * z2770;
    const Scalar z2772 = z1603 * z2761 - z1604 * z2767 - z1605 * z2768 - z1606 * z2769 - z1607 * z2770 - z1608 * z2771;
    const Scalar z2773 = z1576 * z2767 + z1577 * z2768 + z1578 * z2769 + z1579 * z2770 + z1580 * z2771 + z1581 * z2772
        - k52 * z2506;
    const Scalar z2774 = z1581 * z2507 - z2583;
    const Scalar z2775 = z1580 * z2507 - z1608 * z2774 + z2587;
    const Scalar z2776 = z1579 * z2507 - z1607 * z2774 - z1628 * z2775 - z2594;
    const Scalar z2777 = z1578 * z2507 - z1606 * z2774 - z1627 * z2775 - z1642 * z2776 + z2600;
    const Scalar z2778 = z1577 * z2507 - z1605 * z2774 - z1626 * z2775 - z1641 * z2776 - z1651 * z2777 + z2606;
    const Scalar z2779 = z1576 * z2507 - z1604 * z2774 - z1625 * z2775 - z1640 * z2776 - z1650 * z2777 - z1656 * z2778
        - z2610;
    const Scalar z2780 = z1658 * z2779;
    const Scalar z2781 = z1655 * z2778 - z1656 * z2780;
    const Scalar z2782 = z1649 * z2777 - z1650 * z2780 - z1651 * z2781;
    const Scalar z2783 = z1639 * z2776 - z1640 * z2780 - z1641 * z2781 - z1642 * z2782;
    const Scalar z2784 = z1624 * z2775 - z1625 * z2780 - z1626 * z2781 - z1627 * z2782 - z1628 * z2783;
    const Scalar z2785 = z1603 * z2774 - z1604 * z2780 - z1605 * z2781 - z1606 * z2782 - z1607 * z2783 - z1608 * z2784;
    const Scalar z2786 = z1576 * z2780 + z1577 * z2781 + z1578 * z2782 + z1579 * z2783 + z1580 * z2784 + z1581 * z2785
        - k52 * z2507;
    const Scalar z2787 = z1656 * z1658;
    const Scalar z2788 = z1650 * z1658 - z1651 * z2787;
    const Scalar z2789 = z1640 * z1658 - z1641 * z2787 - z1642 * z2788;
    const Scalar z2790 = z1625 * z1658 - z1626 * z2787 - z1627 * z2788 - z1628 * z2789;
    const Scalar z2791 = z1604 * z1658 - z1605 * z2787 - z1606 * z2788 - z1607 * z2789 - z1608 * z2790;
    const Scalar z2792 = z1576 * z1658 - z1577 * z2787 - z1578 * z2788 - z1579 * z2789 - z1580 * z2790 - z1581 * z2791;
    const Scalar z2793 = z1655 + z1656 * z2787;
    const Scalar z2794 = z1650 * z2787 - z1651 * z2793;
    const Scalar z2795 = z1640 * z2787 - z1641 * z2793 - z1642 * z2794;
    const Scalar z2796 = z1625 * z2787 - z1626 * z2793 - z1627 * z2794 - z1628 * z2795;
    const Scalar z2797 = z1604 * z2787 - z1605 * z2793 - z1606 * z2794 - z1607 * z2795 - z1608 * z2796;
    const Scalar z2798 = z1576 * z2787 - z1577 * z2793 - z1578 * z2794 - z1579 * z2795 - z1580 * z2796 - z1581 * z2797;
    const Scalar z2799 = z1650 - z1651 * z1656;
    const Scalar z2800 = z1658 * z2799;
    const Scalar z2801 = z1651 * z1655 - z1656 * z2800;
    const Scalar z2802 = z1649 + z1650 * z2800 + z1651 * z2801;
    const Scalar z2803 = z1640 * z2800 + z1641 * z2801 - z1642 * z2802;
    const Scalar z2804 = z1625 * z2800 + z1626 * z2801 - z1627 * z2802 - z1628 * z2803;
    const Scalar z2805 = z1604 * z2800 + z1605 * z2801 - z1606 * z2802 - z1607 * z2803 - z1608 * z2804;
    const Scalar z2806 = z1576 * z2800 + z1577 * z2801 - z1578 * z2802 - z1579 * z2803 - z1580 * z2804 - z1581 * z2805;
    const Scalar z2807 = z1641 - z1642 * z1651;
    const Scalar z2808 = z1640 - z1642 * z1650 - z1656 * z2807;
    const Scalar z2809 = z1658 * z2808;
    const Scalar z2810 = z1655 * z2807 - z1656 * z2809;
    const Scalar z2811 = z1642 * z1649 - z1650 * z2809 - z1651 * z2810;
    const Scalar z2812 = z1639 + z1640 * z2809 + z1641 * z2810 + z1642 * z2811;
    const Scalar z2813 = z1625 * z2809 + z1626 * z2810 + z1627 * z2811 - z1628 * z2812;
    const Scalar z2814 = z1604 * z2809 + z1605 * z2810 + z1606 * z2811 - z1607 * z2812 - z1608 * z2813;
    const Scalar z2815 = z1576 * z2809 + z1577 * z2810 + z1578 * z2811 - z1579 * z2812 - z1580 * z2813 - z1581 * z2814;
    const Scalar z2816 = z1627 - z1628 * z1642;
    const Scalar z2817 = z1626 - z1628 * z1641 - z1651 * z2816;
    const Scalar z2818 = z1625 - z1628 * z1640 - z1650 * z2816 - z1656 * z2817;
    const Scalar z2819 = z1658 * z2818;
    const Scalar z2820 = z1655 * z2817 - z1656 * z2819;
    const Scalar z2821 = z1649 * z2816 - z1650 * z2819 - z1651 * z2820;
    const Scalar z2822 = z1628 * z1639 - z1640 * z2819 - z1641 * z2820 - z1642 * z2821;
    const Scalar z2823 = z1624 + z1625 * z2819 + z1626 * z2820 + z1627 * z2821 + z1628 * z2822;
    const Scalar z2824 = z1604 * z2819 + z1605 * z2820 + z1606 * z2821 + z1607 * z2822 - z1608 * z2823;
    const Scalar z2825 = z1576 * z2819 + z1577 * z2820 + z1578 * z2821 + z1579 * z2822 - z1580 * z2823 - z1581 * z2824;
    const Scalar z2826 = z1607 - z1608 * z1628;
    const Scalar z2827 = z1606 - z1608 * z1627 - z1642 * z2826;
    const Scalar z2828 = z1605 - z1608 * z1626 - z1641 * z2826 - z1651 * z2827;
    const Scalar z2829 = z1604 - z1608 * z1625 - z1640 * z2826 - z1650 * z2827 - z1656 * z2828;
    const Scalar z2830 = z1658 * z2829;
    const Scalar z2831 = z1655 * z2828 - z1656 * z2830;
    const Scalar z2832 = z1649 * z2827 - z1650 * z2830 - z1651 * z2831;
    const Scalar z2833 = z1639 * z2826 - z1640 * z2830 - z1641 * z2831 - z1642 * z2832;
    const Scalar z2834 = z1608 * z1624 - z1625 * z2830 - z1626 * z2831 - z1627 * z2832 - z1628 * z2833;
    const Scalar z2835 = z1603 + z1604 * z2830 + z1605 * z2831 + z1606 * z2832 + z1607 * z2833 + z1608 * z2834;
    const Scalar z2836 = z1576 * z2830 + z1577 * z2831 + z1578 * z2832 + z1579 * z2833 + z1580 * z2834 - z1581 * z2835;
    const Scalar z2837 = z1580 - z1581 * z1608;
    const Scalar z2838 = z1579 - z1581 * z1607 - z1628 * z2837;
    const Scalar z2839 = z1578 - z1581 * z1606 - z1627 * z2837 - z1642 * z2838;
    const Scalar z2840 = z1577 - z1581 * z1605 - z1626 * z2837 - z1641 * z2838 - z1651 * z2839;
    const Scalar z2841 = z1576 - z1581 * z1604 - z1625 * z2837 - z1640 * z2838 - z1650 * z2839 - z1656 * z2840;
    const Scalar z2842 = z1658 * z2841;
    const Scalar z2843 = z1655 * z2840 - z1656 * z2842;
    const Scalar z2844 = z1649 * z2839 - z1650 * z2842 - z1651 * z2843;
    const Scalar z2845 = z1639 * z2838 - z1640 * z2842 - z1641 * z2843 - z1642 * z2844;
    const Scalar z2846 = z1624 * z2837 - z1625 * z2842 - z1626 * z2843 - z1627 * z2844 - z1628 * z2845;
    const Scalar z2847 = z1581 * z1603 - z1604 * z2842 - z1605 * z2843 - z1606 * z2844 - z1607 * z2845 - z1608 * z2846;
    const Scalar z2848 = k52 - z1576 * z2842 - z1577 * z2843 - z1578 * z2844 - z1579 * z2845 - z1580 * z2846 - z1581
        * z2847;
    result.M[0] = z669;
    result.M[1] = -z655;
    result.M[2] = -z635;
    result.M[3] = z607;
    result.M[4] = z573;
    result.M[5] = -z536;
    result.M[6] = z496;
    result.M[7] = -z655;
    result.M[8] = z651;
    result.M[9] = -z631;
    result.M[10] = z603;
    result.M[11] = z569;
    result.M[12] = z532;
    result.M[13] = z492;
    result.M[14] = -z635;
    result.M[15] = -z631;
    result.M[16] = z625;
    result.M[17] = z596;
    result.M[18] = -z563;
    result.M[19] = -z526;
    result.M[20] = -z486;
    result.M[21] = z607;
    result.M[22] = z603;
    result.M[23] = z596;
    result.M[24] = z592;
    result.M[25] = -z557;
    result.M[26] = -z520;
    result.M[27] = z480;
    result.M[28] = z573;
    result.M[29] = z569;
    result.M[30] = -z563;
    result.M[31] = -z557;
    result.M[32] = z550;
    result.M[33] = -z513;
    result.M[34] = z473;
    result.M[35] = -z536;
    result.M[36] = z532;
    result.M[37] = -z526;
    result.M[38] = -z520;
    result.M[39] = -z513;
    result.M[40] = z509;
    result.M[41] = -z468;
    result.M[42] = z496;
    result.M[43] = z492;
    result.M[44] = -z486;
    result.M[45] = z480;
    result.M[46] = z473;
    result.M[47] = -z468;
    result.M[48] = k4;
    result.C[0] = -z2204;
    result.C[1] = -z2188;
    result.C[2] = -z2237;
    result.C[3] = z2285;
    result.C[4] = -z2352;
    result.C[5] = z2438;
    result.C[6] = -z2538;
    result.C[7] = z2227;
    result.C[8] = -z2209;
    result.C[9] = -z2235;
    result.C[10] = -z2283;
    result.C[11] = z2350;
    result.C[12] = z2436;
    result.C[13] = z2536;
    result.C[14] = z2267;
    result.C[15] = -z2263;
    result.C[16] = -z2232;
    result.C[17] = z2276;
    result.C[18] = -z2343;
    result.C[19] = z2429;
    result.C[20] = -z2529;
    result.C[21] = -z2327;
    result.C[22] = -z2323;
    result.C[23] = z2317;
    result.C[24] = -z2272;
    result.C[25] = -z2336;
    result.C[26] = -z2422;
    result.C[27] = -z2522;
    result.C[28] = -z2408;
    result.C[29] = -z2404;
    result.C[30] = z2398;
    result.C[31] = -z2392;
    result.C[32] = z2332;
    result.C[33] = -z2415;
    result.C[34] = z2515;
    result.C[35] = z2502;
    result.C[36] = -z2498;
    result.C[37] = z2492;
    result.C[38] = z2486;
    result.C[39] = -z2479;
    result.C[40] = -z2413;
    result.C[41] = z2511;
    result.C[42] = z2610;
    result.C[43] = -z2606;
    result.C[44] = z2600;
    result.C[45] = z2594;
    result.C[46] = -z2587;
    result.C[47] = -z2583;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z2218;
    result.K[8] = z2208;
    result.K[9] = -z2234;
    result.K[10] = z2282;
    result.K[11] = z2349;
    result.K[12] = z2435;
    result.K[13] = z2535;
    result.K[14] = -z2252;
    result.K[15] = z2248;
    result.K[16] = z2231;
    result.K[17] = z2275;
    result.K[18] = z2342;
    result.K[19] = -z2428;
    result.K[20] = z2528;
    result.K[21] = -z2306;
    result.K[22] = -z2302;
    result.K[23] = z2296;
    result.K[24] = z2271;
    result.K[25] = -z2335;
    result.K[26] = z2421;
    result.K[27] = -z2521;
    result.K[28] = -z2380;
    result.K[29] = z2376;
    result.K[30] = -z2370;
    result.K[31] = -z2364;
    result.K[32] = z2331;
    result.K[33] = z2414;
    result.K[34] = -z2514;
    result.K[35] = -z2470;
    result.K[36] = z2466;
    result.K[37] = -z2460;
    result.K[38] = -z2454;
    result.K[39] = -z2447;
    result.K[40] = z2412;
    result.K[41] = -z2510;
    result.K[42] = -z2576;
    result.K[43] = -z2572;
    result.K[44] = z2566;
    result.K[45] = -z2560;
    result.K[46] = -z2553;
    result.K[47] = -z2549;
    result.K[48] = z2506;
    result.F[0] = z2611;
    result.F[1] = z2612;
    result.F[2] = z2613;
    result.F[3] = z2614;
    result.F[4] = z2615;
    result.F[5] = z2616;
    result.F[6] = z2617;
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
    result.A[21] = -z2637;
    result.A[22] = -z2638;
    result.A[23] = z2639;
    result.A[24] = -z2640;
    result.A[25] = -z2641;
    result.A[26] = z2642;
    result.A[27] = z2643;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = -z2663;
    result.A[36] = -z2664;
    result.A[37] = z2665;
    result.A[38] = -z2666;
    result.A[39] = -z2667;
    result.A[40] = z2668;
    result.A[41] = z2669;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z2689;
    result.A[50] = z2690;
    result.A[51] = -z2691;
    result.A[52] = z2692;
    result.A[53] = z2693;
    result.A[54] = -z2694;
    result.A[55] = -z2695;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z2715;
    result.A[64] = z2716;
    result.A[65] = -z2717;
    result.A[66] = z2718;
    result.A[67] = z2719;
    result.A[68] = -z2720;
    result.A[69] = -z2721;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = z2741;
    result.A[78] = z2742;
    result.A[79] = -z2743;
    result.A[80] = z2744;
    result.A[81] = z2745;
    result.A[82] = -z2746;
    result.A[83] = -z2747;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = -z2767;
    result.A[92] = -z2768;
    result.A[93] = z2769;
    result.A[94] = -z2770;
    result.A[95] = -z2771;
    result.A[96] = z2772;
    result.A[97] = z2773;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = z2624;
    result.A[106] = z2625;
    result.A[107] = -z2626;
    result.A[108] = z2627;
    result.A[109] = z2628;
    result.A[110] = -z2629;
    result.A[111] = -z2630;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = -z2650;
    result.A[120] = -z2651;
    result.A[121] = z2652;
    result.A[122] = -z2653;
    result.A[123] = -z2654;
    result.A[124] = z2655;
    result.A[125] = z2656;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = z2676;
    result.A[134] = z2677;
    result.A[135] = -z2678;
    result.A[136] = z2679;
    result.A[137] = z2680;
    result.A[138] = -z2681;
    result.A[139] = -z2682;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z2702;
    result.A[148] = z2703;
    result.A[149] = -z2704;
    result.A[150] = z2705;
    result.A[151] = z2706;
    result.A[152] = -z2707;
    result.A[153] = -z2708;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z2728;
    result.A[162] = -z2729;
    result.A[163] = z2730;
    result.A[164] = -z2731;
    result.A[165] = -z2732;
    result.A[166] = z2733;
    result.A[167] = z2734;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z2754;
    result.A[176] = -z2755;
    result.A[177] = z2756;
    result.A[178] = -z2757;
    result.A[179] = -z2758;
    result.A[180] = z2759;
    result.A[181] = z2760;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z2780;
    result.A[190] = -z2781;
    result.A[191] = z2782;
    result.A[192] = -z2783;
    result.A[193] = -z2784;
    result.A[194] = z2785;
    result.A[195] = z2786;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z1658;
    result.B[8] = z2787;
    result.B[9] = -z2788;
    result.B[10] = z2789;
    result.B[11] = z2790;
    result.B[12] = -z2791;
    result.B[13] = z2792;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z2787;
    result.B[22] = -z2793;
    result.B[23] = z2794;
    result.B[24] = -z2795;
    result.B[25] = -z2796;
    result.B[26] = z2797;
    result.B[27] = -z2798;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z2800;
    result.B[36] = -z2801;
    result.B[37] = -z2802;
    result.B[38] = z2803;
    result.B[39] = z2804;
    result.B[40] = -z2805;
    result.B[41] = z2806;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z2809;
    result.B[50] = z2810;
    result.B[51] = -z2811;
    result.B[52] = -z2812;
    result.B[53] = -z2813;
    result.B[54] = z2814;
    result.B[55] = -z2815;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z2819;
    result.B[64] = z2820;
    result.B[65] = -z2821;
    result.B[66] = z2822;
    result.B[67] = -z2823;
    result.B[68] = z2824;
    result.B[69] = -z2825;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z2830;
    result.B[78] = -z2831;
    result.B[79] = z2832;
    result.B[80] = -z2833;
    result.B[81] = -z2834;
    result.B[82] = -z2835;
    result.B[83] = z2836;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z2842;
    result.B[92] = z2843;
    result.B[93] = -z2844;
    result.B[94] = z2845;
    result.B[95] = z2846;
    result.B[96] = -z2847;
    result.B[97] = z2848;
    if (!(traits::regular(-z1657, z669) && traits::regular(-z1654, z651) && traits::regular(-z1648, z625)
        && traits::regular(-z1638, z592) && traits::regular(-z1623, z550) && traits::regular(-z1602,
        z509))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((((result.M[0] - result.M[0]) + (result.M[1] - result.M[1]) + (result.M[2] - result.M[2])
        + (result.M[3] - result.M[3]) + (result.M[4] - result.M[4]) + (result.M[5] - result.M[5]) + (result.M[6]
        - result.M[6]) + (result.M[7] - result.M[7])) + ((result.M[8] - result.M[8]) + (result.M[9] - result.M[9])
        + (result.M[10] - result.M[10]) + (result.M[11] - result.M[11]) + (result.M[12] - result.M[12]) + (result.M[13]
        - result.M[13]) + (result.M[14] - result.M[14]) + (result.M[15] - result.M[15]) + (result.M[16]
        - result.M[16]))) + (((result.M[17] - result.M[17]) + (result.M[18] - result.M[18]) + (result.M[19]
        - result.M[19]) + (result.M[20] - result.M[20]) + (result.M[21] - result.M[21]) + (result.M[22] - result.M[22])
        + (result.M[23] - result.M[23]) + (result.M[24] - result.M[24]) + (result.M[25] - result.M[25]))
        + ((result.M[26] - result.M[26]) + (result.M[27] - result.M[27]) + (result.M[28] - result.M[28]) + (result.M[29]
        - result.M[29]) + (result.M[30] - result.M[30]) + (result.M[31] - result.M[31]) + (result.M[32] - result.M[32])
        + (result.M[33] - result.M[33]) + (result.M[34] - result.M[34])))) + ((((result.M[35] - result.M[35])
        + (result.M[36] - result.M[36]) + (result.M[37] - result.M[37]) + (result.M[38] - result.M[38]) + (result.M[39]
        - result.M[39]) + (result.M[40] - result.M[40]) + (result.M[41] - result.M[41]) + (result.M[42] - result.M[42])
        + (result.M[43] - result.M[43])) + ((result.M[44] - result.M[44]) + (result.M[45] - result.M[45])
        + (result.M[46] - result.M[46]) + (result.M[47] - result.M[47]) + (result.C[0] - result.C[0]) + (result.C[1]
        - result.C[1]) + (result.C[2] - result.C[2]) + (result.C[3] - result.C[3]) + (result.C[4] - result.C[4])))
        + (((result.C[5] - result.C[5]) + (result.C[6] - result.C[6]) + (result.C[7] - result.C[7]) + (result.C[8]
        - result.C[8]) + (result.C[9] - result.C[9]) + (result.C[10] - result.C[10]) + (result.C[11] - result.C[11])
        + (result.C[12] - result.C[12]) + (result.C[13] - result.C[13])) + ((result.C[14] - result.C[14])
        + (result.C[15] - result.C[15]) + (result.C[16] - result.C[16]) + (result.C[17] - result.C[17]) + (result.C[18]
        - result.C[18]) + (result.C[19] - result.C[19]) + (result.C[20] - result.C[20]) + (result.C[21] - result.C[21])
        + (result.C[22] - result.C[22]))))) + (((((result.C[23] - result.C[23]) + (result.C[24] - result.C[24])
        + (result.C[25] - result.C[25]) + (result.C[26] - result.C[26]) + (result.C[27] - result.C[27]) + (result.C[28]
        - result.C[28]) + (result.C[29] - result.C[29]) + (result.C[30] - result.C[30])) + ((result.C[31]
        - result.C[31]) + (result.C[32] - result.C[32]) + (result.C[33] - result.C[33]) + (result.C[34] - result.C[34])
        + (result.C[35] - result.C[35]) + (result.C[36] - result.C[36]) + (result.C[37] - result.C[37]) + (result.C[38]
        - result.C[38]) + (result.C[39] - result.C[39]))) + (((result.C[40] - result.C[40]) + (result.C[41]
        - result.C[41]) + (result.C[42] - result.C[42]) + (result.C[43] - result.C[43]) + (result.C[44] - result.C[44])
        + (result.C[45] - result.C[45]) + (result.C[46] - result.C[46]) + (result.C[47] - result.C[47]) + (result.K[7]
        - result.K[7])) + ((result.K[8] - result.K[8]) + (result.K[9] - result.K[9]) + (result.K[10] - result.K[10])
        + (result.K[11] - result.K[11]) + (result.K[12] - result.K[12]) + (result.K[13] - result.K[13]) + (result.K[14]
        - result.K[14]) + (result.K[15] - result.K[15]) + (result.K[16] - result.K[16])))) + ((((result.K[17]
        - result.K[17]) + (result.K[18] - result.K[18]) + (result.K[19] - result.K[19]) + (result.K[20] - result.K[20])
        + (result.K[21] - result.K[21]) + (result.K[22] - result.K[22]) + (result.K[23] - result.K[23]) + (result.K[24]
        - result.K[24]) + (result.K[25] - result.K[25])) + ((result.K[26] - result.K[26]) + (result.K[27]
        - result.K[27]) + (result.K[28] - result.K[28]) + (result.K[29] - result.K[29]) + (result.K[30] - result.K[30])
        + (result.K[31] - result.K[31]) + (result.K[32] - result.K[32]) + (result.K[33] - result.K[33]) + (result.K[34]
        - result.K[34]))) + (((result.K[35] - result.K[35]) + (result.K[36] - result.K[36]) + (result.K[37]
        - result.K[37]) + (result.K[38] - result.K[38]) + (result.K[39] - result.K[39]) + (result.K[40] - result.K[40])
        + (result.K[41] - result.K[41]) + (result.K[42] - result.K[42]) + (result.K[43] - result.K[43]))
        + ((result.K[44] - result.K[44]) + (result.K[45] - result.K[45]) + (result.K[46] - result.K[46]) + (result.K[47]
        - result.K[47]) + (result.K[48] - result.K[48]) + (result.F[0] - result.F[0]) + (result.F[1] - result.F[1])
        + (result.F[2] - result.F[2]) + (result.F[3] - result.F[3])))))) + ((((((result.F[4] - result.F[4])
        + (result.F[5] - result.F[5]) + (result.F[6] - result.F[6]) + (result.A[21] - result.A[21]) + (result.A[22]
        - result.A[22]) + (result.A[23] - result.A[23]) + (result.A[24] - result.A[24]) + (result.A[25] - result.A[25]))
        + ((result.A[26] - result.A[26]) + (result.A[27] - result.A[27]) + (result.A[35] - result.A[35]) + (result.A[36]
        - result.A[36]) + (result.A[37] - result.A[37]) + (result.A[38] - result.A[38]) + (result.A[39] - result.A[39])
        + (result.A[40] - result.A[40]) + (result.A[41] - result.A[41]))) + (((result.A[49] - result.A[49])
        + (result.A[50] - result.A[50]) + (result.A[51] - result.A[51]) + (result.A[52] - result.A[52]) + (result.A[53]
        - result.A[53]) + (result.A[54] - result.A[54]) + (result.A[55] - result.A[55]) + (result.A[63] - result.A[63])
        + (result.A[64] - result.A[64])) + ((result.A[65] - result.A[65]) + (result.A[66] - result.A[66])
        + (result.A[67] - result.A[67]) + (result.A[68] - result.A[68]) + (result.A[69] - result.A[69]) + (result.A[77]
        - result.A[77]) + (result.A[78] - result.A[78]) + (result.A[79] - result.A[79]) + (result.A[80]
        - result.A[80])))) + ((((result.A[81] - result.A[81]) + (result.A[82] - result.A[82]) + (result.A[83]
        - result.A[83]) + (result.A[91] - result.A[91]) + (result.A[92] - result.A[92]) + (result.A[93] - result.A[93])
        + (result.A[94] - result.A[94]) + (result.A[95] - result.A[95]) + (result.A[96] - result.A[96]))
        + ((result.A[97] - result.A[97]) + (result.A[105] - result.A[105]) + (result.A[106] - result.A[106])
        + (result.A[107] - result.A[107]) + (result.A[108] - result.A[108]) + (result.A[109] - result.A[109])
        + (result.A[110] - result.A[110]) + (result.A[111] - result.A[111]) + (result.A[119] - result.A[119])))
        + (((result.A[120] - result.A[120]) + (result.A[121] - result.A[121]) + (result.A[122] - result.A[122])
        + (result.A[123] - result.A[123]) + (result.A[124] - result.A[124]) + (result.A[125] - result.A[125])
        + (result.A[133] - result.A[133]) + (result.A[134] - result.A[134]) + (result.A[135] - result.A[135]))
        + ((result.A[136] - result.A[136]) + (result.A[137] - result.A[137]) + (result.A[138] - result.A[138])
        + (result.A[139] - result.A[139]) + (result.A[147] - result.A[147]) + (result.A[148] - result.A[148])
        + (result.A[149] - result.A[149]) + (result.A[150] - result.A[150]) + (result.A[151] - result.A[151])))))
        + (((((result.A[152] - result.A[152]) + (result.A[153] - result.A[153]) + (result.A[161] - result.A[161])
        + (result.A[162] - result.A[162]) + (result.A[163] - result.A[163]) + (result.A[164] - result.A[164])
        + (result.A[165] - result.A[165]) + (result.A[166] - result.A[166]) + (result.A[167] - result.A[167]))
        + ((result.A[175] - result.A[175]) + (result.A[176] - result.A[176]) + (result.A[177] - result.A[177])
        + (result.A[178] - result.A[178]) + (result.A[179] - result.A[179]) + (result.A[180] - result.A[180])
        + (result.A[181] - result.A[181]) + (result.A[189] - result.A[189]) + (result.A[190] - result.A[190])))
        + (((result.A[191] - result.A[191]) + (result.A[192] - result.A[192]) + (result.A[193] - result.A[193])
        + (result.A[194] - result.A[194]) + (result.A[195] - result.A[195]) + (result.B[7] - result.B[7]) + (result.B[8]
        - result.B[8]) + (result.B[9] - result.B[9]) + (result.B[10] - result.B[10])) + ((result.B[11] - result.B[11])
        + (result.B[12] - result.B[12]) + (result.B[13] - result.B[13]) + (result.B[21] - result.B[21]) + (result.B[22]
        - result.B[22]) + (result.B[23] - result.B[23]) + (result.B[24] - result.B[24]) + (result.B[25] - result.B[25])
        + (result.B[26] - result.B[26])))) + ((((result.B[27] - result.B[27]) + (result.B[35] - result.B[35])
        + (result.B[36] - result.B[36]) + (result.B[37] - result.B[37]) + (result.B[38] - result.B[38]) + (result.B[39]
        - result.B[39]) + (result.B[40] - result.B[40]) + (result.B[41] - result.B[41]) + (result.B[49] - result.B[49]))
        + ((result.B[50] - result.B[50]) + (result.B[51] - result.B[51]) + (result.B[52] - result.B[52]) + (result.B[53]
        - result.B[53]) + (result.B[54] - result.B[54]) + (result.B[55] - result.B[55]) + (result.B[63] - result.B[63])
        + (result.B[64] - result.B[64]) + (result.B[65] - result.B[65]))) + (((result.B[66] - result.B[66])
        + (result.B[67] - result.B[67]) + (result.B[68] - result.B[68]) + (result.B[69] - result.B[69]) + (result.B[77]
        - result.B[77]) + (result.B[78] - result.B[78]) + (result.B[79] - result.B[79]) + (result.B[80] - result.B[80])
        + (result.B[81] - result.B[81])) + ((result.B[82] - result.B[82]) + (result.B[83] - result.B[83])
        + (result.B[91] - result.B[91]) + (result.B[92] - result.B[92]) + (result.B[93] - result.B[93]) + (result.B[94]
        - result.B[94]) + (result.B[95] - result.B[95]) + (result.B[96] - result.B[96]) + (result.B[97]
        - result.B[97]))))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace arm7
