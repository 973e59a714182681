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
//   kinematics              252              343          0             0                  7       0    609     609
//   mass_matrix             162              181          0             0                  6       0    355     395
//   bias                    266              292          0             0                  6       0    570     684
//   inverse_dynamics        285              300          0             0                  6       0    597     715
//   forward_dynamics        515              586          6             0                  6       0   1119    1273
//   energy                  221              307          0             0                  6       0    540     577
//   linearisation          2054             2394          6             0                  6       0   4466    4732
//
// Not computed because this mechanism does not need it:
//   kinematics: of 153 results 12 vanish identically, 20 repeat another up to sign
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
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k5 = traits::constant(0.002081, 0.002081f, "2081/1000000");
    const Scalar k6 = traits::constant(0.003875, 0.003875f, "31/8000");
    const Scalar k7 = traits::constant(0.003495, 0.003495f, "699/200000");
    const Scalar k8 = traits::constant(0.003141, 0.003141f, "3141/1000000");
    const Scalar k9 = traits::constant(0.02872, 0.02872f, "359/12500");
    const Scalar k10 = traits::constant(0.066502, 0.066502f, "33251/500000");
    const Scalar k11 = traits::constant(0.027518, 0.027518f, "13759/500000");
    const Scalar k12 = traits::constant(0.039252, 0.039252f, "9813/250000");
    const Scalar k13 = traits::constant(0.027454, 0.027454f, "13727/500000");
    const Scalar k14 = traits::constant(0.05317, 0.05317f, "5317/100000");
    const Scalar k15 = traits::constant(0.104419, 0.104419f, "104419/1000000");
    const Scalar k16 = traits::constant(0.038437, 0.038437f, "38437/1000000");
    const Scalar k17 = traits::constant(0.011953, 0.011953f, "11953/1000000");
    const Scalar k18 = traits::constant(0.041065, 0.041065f, "8213/200000");
    const Scalar k19 = traits::constant(0.010517, 0.010517f, "10517/1000000");
    const Scalar k20 = traits::constant(0.060149, 0.060149f, "60149/1000000");
    const Scalar k21 = traits::constant(0.014117, 0.014117f, "14117/1000000");
    const Scalar k22 = traits::constant(0.061597, 0.061597f, "61597/1000000");
    const Scalar k23 = traits::constant(0.004252, 0.004252f, "1063/250000");
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
    const Scalar z35 = c_q1 * c_q2;
    const Scalar z36 = c_q1 * s_q2;
    const Scalar z37 = s_q1 * c_q2;
    const Scalar z38 = s_q1 * s_q2;
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z41 = s_q1 * v_q2;  // angular velocity of link2, x
    const Scalar z42 = c_q1 * v_q2;  // angular velocity of link2, y
    const Scalar z43 = s_q1 * s_q3 - c_q3 * z35;
    const Scalar z44 = s_q1 * c_q3 + s_q3 * z35;
    const Scalar z45 = c_q1 * s_q3 + c_q3 * z37;
    const Scalar z46 = c_q1 * c_q3 - s_q3 * z37;
    const Scalar z47 = s_q2 * c_q3;
    const Scalar z48 = s_q2 * s_q3;
    const Scalar z49 = n0_316 * z36;
    const Scalar z50 = n0_316 * z38;
    const Scalar z51 = n0_316 * c_q2;
    const Scalar z52 = n0_333 + z51;  // place of link3, z
    const Scalar z53 = n0_316 * v_q2;
    const Scalar z54 = n0_316 * z39;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z58 = v_q3 * z36 - z41;  // angular velocity of link3, x
    const Scalar z59 = v_q3 * z38 + z42;  // angular velocity of link3, y
    const Scalar z60 = v_q1 + c_q2 * v_q3;  // angular velocity of link3, z
    const Scalar z61 = s_q1 * z54 - z35 * z53;  // velocity of link3, x
    const Scalar z62 = c_q1 * z54 + z37 * z53;  // velocity of link3, y
    const Scalar z63 = s_q2 * z53;  // velocity of link3, z
    const Scalar z64 = s_q4 * z36 - c_q4 * z43;
    const Scalar z65 = s_q4 * z43 + c_q4 * z36;
    const Scalar z66 = s_q4 * z38 + c_q4 * z45;
    const Scalar z67 = s_q4 * z45 - c_q4 * z38;
    const Scalar z68 = c_q2 * s_q4 - c_q4 * z47;
    const Scalar z69 = c_q2 * c_q4 + s_q4 * z47;
    const Scalar z70 = n0_0825 * z43;
    const Scalar z71 = n0_0825 * z45;
    const Scalar z72 = n0_0825 * z47;
    const Scalar z73 = z49 - z70;  // place of link4, x
    const Scalar z74 = z50 + z71;  // place of link4, y
    const Scalar z75 = z52 - z72;  // place of link4, z
    const Scalar z76 = n0_0825 * z57;
    const Scalar z77 = n0_0825 * z56;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z81 = v_q4 * z44 + z58;  // angular velocity of link4, x
    const Scalar z82 = v_q4 * z46 - z59;  // angular velocity of link4, y
    const Scalar z83 = v_q4 * z48 - z60;  // angular velocity of link4, z
    const Scalar z84 = z36 * z77 + z44 * z76 + z61;  // velocity of link4, x
    const Scalar z85 = z38 * z77 - z46 * z76 - z62;  // velocity of link4, y
    const Scalar z86 = c_q2 * z77 - z48 * z76 + z63;  // velocity of link4, z
    const Scalar z87 = s_q5 * z44 - c_q5 * z64;
    const Scalar z88 = s_q5 * z64 + c_q5 * z44;
    const Scalar z89 = s_q5 * z46 + c_q5 * z66;
    const Scalar z90 = s_q5 * z66 - c_q5 * z46;
    const Scalar z91 = s_q5 * z48 + c_q5 * z68;
    const Scalar z92 = s_q5 * z68 - c_q5 * z48;
    const Scalar z93 = n0_0825 * z64 - n0_384 * z65;
    const Scalar z94 = n0_0825 * z66 + n0_384 * z67;
    const Scalar z95 = n0_0825 * z68 - n0_384 * z69;
    const Scalar z96 = z73 - z93;  // place of link5, x
    const Scalar z97 = z74 - z94;  // place of link5, y
    const Scalar z98 = z75 - z95;  // place of link5, z
    const Scalar z99 = n0_384 * z80;
    const Scalar z100 = n0_0825 * z80;
    const Scalar z101 = n0_384 * z78 - n0_0825 * z79;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = s_q5 * z78 + c_q5 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z105 = v_q5 * z65 + z81;  // angular velocity of link5, x
    const Scalar z106 = v_q5 * z67 + z82;  // angular velocity of link5, y
    const Scalar z107 = v_q5 * z69 - z83;  // angular velocity of link5, z
    const Scalar z108 = z44 * z101 - z64 * z99 - z65 * z100 - z84;  // velocity of link5, x
    const Scalar z109 = z46 * z101 + z66 * z99 - z67 * z100 + z85;  // velocity of link5, y
    const Scalar z110 = z48 * z101 + z68 * z99 + z69 * z100 + z86;  // velocity of link5, z
    const Scalar z111 = s_q6 * z65 - c_q6 * z87;
    const Scalar z112 = s_q6 * z87 + c_q6 * z65;
    const Scalar z113 = s_q6 * z67 - c_q6 * z89;
    const Scalar z114 = s_q6 * z89 + c_q6 * z67;
    const Scalar z115 = s_q6 * z69 + c_q6 * z91;
    const Scalar z116 = s_q6 * z91 - c_q6 * z69;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z120 = v_q6 * z88 + z105;  // angular velocity of link6, x
    const Scalar z121 = v_q6 * z90 - z106;  // angular velocity of link6, y
    const Scalar z122 = v_q6 * z92 + z107;  // angular velocity of link6, z
    const Scalar z123 = s_q7 * z88 + c_q7 * z111;
    const Scalar z124 = s_q7 * z111 - c_q7 * z88;
    const Scalar z125 = s_q7 * z90 - c_q7 * z113;
    const Scalar z126 = s_q7 * z113 + c_q7 * z90;
    const Scalar z127 = s_q7 * z92 + c_q7 * z115;
    const Scalar z128 = s_q7 * z115 - c_q7 * z92;
    const Scalar z129 = n0_088 * z111;
    const Scalar z130 = n0_088 * z113;
    const Scalar z131 = n0_088 * z115;
    const Scalar z132 = z96 + z129;  // place of link7, x
    const Scalar z133 = z97 - z130;  // place of link7, y
    const Scalar z134 = z98 + z131;  // place of link7, z
    const Scalar z135 = n0_088 * z119;
    const Scalar z136 = n0_088 * z118;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z140 = v_q7 * z112 - z120;  // angular velocity of link7, x
    const Scalar z141 = v_q7 * z114 + z121;  // angular velocity of link7, y
    const Scalar z142 = v_q7 * z116 + z122;  // angular velocity of link7, z
    const Scalar z143 = z88 * z136 - z108 - z112 * z135;  // velocity of link7, x
    const Scalar z144 = z90 * z136 + z109 + z114 * z135;  // velocity of link7, y
    const Scalar z145 = z92 * z136 + z110 + z116 * z135;  // velocity of link7, z
    const Scalar z146 = k5 * s_q1 - k6 * c_q1;
    const Scalar z147 = k6 * s_q1 + k5 * c_q1;
    const Scalar z148 = k5 * v_q1;
    const Scalar z149 = k6 * v_q1;
    const Scalar z150 = s_q1 * z149 + c_q1 * z148;
    const Scalar z151 = s_q1 * z148 - c_q1 * z149;
    const Scalar z152 = k7 * s_q1 + k8 * z35 - k9 * z36;
    const Scalar z153 = k7 * c_q1 - k8 * z37 + k9 * z38;
    const Scalar z154 = k8 * s_q2 + k9 * c_q2;
    const Scalar z155 = n0_333 + z154;
    const Scalar z156 = k9 * v_q2 - k7 * z40;
    const Scalar z157 = k8 * v_q2 - k7 * z39;
    const Scalar z158 = k9 * z39 - k8 * z40;
    const Scalar z159 = s_q1 * z158 - z35 * z156 - z36 * z157;
    const Scalar z160 = c_q1 * z158 + z37 * z156 + z38 * z157;
    const Scalar z161 = s_q2 * z156 - c_q2 * z157;
    const Scalar z162 = k10 * z36 + k11 * z43 + k12 * z44;
    const Scalar z163 = k10 * z38 - k11 * z45 - k12 * z46;
    const Scalar z164 = k10 * c_q2 + k11 * z47 - k12 * z48;
    const Scalar z165 = z49 - z162;
    const Scalar z166 = z50 - z163;
    const Scalar z167 = z52 - z164;
    const Scalar z168 = k10 * z56 + k12 * z57;
    const Scalar z169 = k10 * z55 + k11 * z57;
    const Scalar z170 = k12 * z55 - k11 * z56;
    const Scalar z171 = z36 * z170 + z43 * z168 - z44 * z169 - z61;
    const Scalar z172 = z38 * z170 - z45 * z168 + z46 * z169 + z62;
    const Scalar z173 = c_q2 * z170 + z47 * z168 + z48 * z169 - z63;
    const Scalar z174 = k13 * z44 - k14 * z64 + k15 * z65;
    const Scalar z175 = k13 * z46 + k14 * z66 + k15 * z67;
    const Scalar z176 = k13 * z48 + k14 * z68 - k15 * z69;
    const Scalar z177 = z73 + z174;
    const Scalar z178 = z74 - z175;
    const Scalar z179 = z75 - z176;
    const Scalar z180 = k13 * z79 + k15 * z80;
    const Scalar z181 = k13 * z78 + k14 * z80;
    const Scalar z182 = k15 * z78 - k14 * z79;
    const Scalar z183 = z44 * z182 - z64 * z180 - z65 * z181 - z84;
    const Scalar z184 = z46 * z182 + z66 * z180 - z67 * z181 + z85;
    const Scalar z185 = z48 * z182 + z68 * z180 + z69 * z181 + z86;
    const Scalar z186 = k16 * z65 - k17 * z87 + k18 * z88;
    const Scalar z187 = k16 * z67 - k17 * z89 - k18 * z90;
    const Scalar z188 = k16 * z69 + k17 * z91 + k18 * z92;
    const Scalar z189 = z96 - z186;
    const Scalar z190 = z97 + z187;
    const Scalar z191 = z98 - z188;
    const Scalar z192 = k16 * z103 - k18 * z104;
    const Scalar z193 = k16 * z102 + k17 * z104;
    const Scalar z194 = k18 * z102 + k17 * z103;
    const Scalar z195 = z65 * z194 + z87 * z192 - z88 * z193 - z108;
    const Scalar z196 = z67 * z194 + z89 * z192 + z90 * z193 - z109;
    const Scalar z197 = z69 * z194 - z91 * z192 - z92 * z193 + z110;
    const Scalar z198 = k19 * z88 - k20 * z111 + k21 * z112;
    const Scalar z199 = k19 * z90 + k20 * z113 - k21 * z114;
    const Scalar z200 = k19 * z92 - k20 * z115 - k21 * z116;
    const Scalar z201 = z96 - z198;
    const Scalar z202 = z97 - z199;
    const Scalar z203 = z98 - z200;
    const Scalar z204 = k19 * z118 - k21 * z119;
    const Scalar z205 = k19 * z117 + k20 * z119;
    const Scalar z206 = k21 * z117 + k20 * z118;
    const Scalar z207 = z88 * z206 - z108 + z111 * z204 - z112 * z205;
    const Scalar z208 = z90 * z206 + z109 - z113 * z204 + z114 * z205;
    const Scalar z209 = z92 * z206 + z110 + z115 * z204 + z116 * z205;
    const Scalar z210 = k22 * z112 - k19 * z123 - k23 * z124;
    const Scalar z211 = k22 * z114 + k19 * z125 - k23 * z126;
    const Scalar z212 = k22 * z116 + k19 * z127 + k23 * z128;
    const Scalar z213 = z132 - z210;
    const Scalar z214 = z133 + z211;
    const Scalar z215 = z134 + z212;
    const Scalar z216 = k22 * z138 - k23 * z139;
    const Scalar z217 = k22 * z137 - k19 * z139;
    const Scalar z218 = k23 * z137 - k19 * z138;
    const Scalar z219 = z112 * z218 - z123 * z216 + z124 * z217 - z143;
    const Scalar z220 = z114 * z218 + z125 * z216 + z126 * z217 + z144;
    const Scalar z221 = z116 * z218 + z127 * z216 - z128 * z217 + z145;
    const Scalar z222 = n0_107 * z112;
    const Scalar z223 = n0_107 * z114;
    const Scalar z224 = n0_107 * z116;
    const Scalar z225 = n0_107 * z138;
    const Scalar z226 = n0_107 * z137;
    const Scalar z227 = z123 * z225 - z124 * z226 + z143;
    const Scalar z228 = z125 * z225 + z126 * z226 + z144;
    const Scalar z229 = z127 * z225 - z128 * z226 + z145;
    const Scalar z230 = z132 - z222;
    const Scalar z231 = z133 + z223;
    const Scalar z232 = z134 + z224;
    const Scalar z236 = z129 - z222;
    const Scalar z237 = z130 - z223;
    const Scalar z238 = z131 + z224;
    const Scalar z239 = z90 * z238 + z92 * z237;
    const Scalar z240 = z88 * z238 - z92 * z236;
    const Scalar z241 = z88 * z237 + z90 * z236;
    const Scalar z242 = z67 * z238 - z69 * z237;
    const Scalar z243 = z65 * z238 - z69 * z236;
    const Scalar z244 = z65 * z237 - z67 * z236;
    const Scalar z245 = z93 - z236;
    const Scalar z246 = z94 + z237;
    const Scalar z247 = z95 - z238;
    const Scalar z248 = z46 * z247 - z48 * z246;
    const Scalar z249 = z44 * z247 + z48 * z245;
    const Scalar z250 = z44 * z246 + z46 * z245;
    const Scalar z251 = z70 + z245;
    const Scalar z252 = z71 - z246;
    const Scalar z253 = z72 + z247;
    const Scalar z254 = c_q2 * z252 + z38 * z253;
    const Scalar z255 = c_q2 * z251 - z36 * z253;
    const Scalar z256 = z36 * z252 + z38 * z251;
    const Scalar z257 = z49 - z251;
    const Scalar z258 = z50 + z252;
    const Scalar z259 = z51 - z253;
    const Scalar z260 = c_q1 * z259;
    const Scalar z261 = s_q1 * z259;
    const Scalar z262 = s_q1 * z258 + c_q1 * z257;
    result.link1_position[0] = -z146;
    result.link1_position[1] = z147;
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
    result.link1_velocity[0] = -z150;
    result.link1_velocity[1] = -z151;
    result.link1_velocity[2] = n0;
    result.link1_angular_velocity[0] = n0;
    result.link1_angular_velocity[1] = n0;
    result.link1_angular_velocity[2] = v_q1;
    result.link2_position[0] = -z152;
    result.link2_position[1] = z153;
    result.link2_position[2] = z155;
    result.link2_rotation[0] = z35;
    result.link2_rotation[1] = z37;
    result.link2_rotation[2] = -s_q2;
    result.link2_rotation[3] = -z36;
    result.link2_rotation[4] = -z38;
    result.link2_rotation[5] = -c_q2;
    result.link2_rotation[6] = -s_q1;
    result.link2_rotation[7] = c_q1;
    result.link2_rotation[8] = n0;
    result.link2_velocity[0] = -z159;
    result.link2_velocity[1] = z160;
    result.link2_velocity[2] = -z161;
    result.link2_angular_velocity[0] = -z41;
    result.link2_angular_velocity[1] = z42;
    result.link2_angular_velocity[2] = v_q1;
    result.link3_position[0] = z165;
    result.link3_position[1] = z166;
    result.link3_position[2] = z167;
    result.link3_rotation[0] = -z43;
    result.link3_rotation[1] = z45;
    result.link3_rotation[2] = -z47;
    result.link3_rotation[3] = -z44;
    result.link3_rotation[4] = z46;
    result.link3_rotation[5] = z48;
    result.link3_rotation[6] = z36;
    result.link3_rotation[7] = z38;
    result.link3_rotation[8] = c_q2;
    result.link3_velocity[0] = z171;
    result.link3_velocity[1] = z172;
    result.link3_velocity[2] = z173;
    result.link3_angular_velocity[0] = z58;
    result.link3_angular_velocity[1] = z59;
    result.link3_angular_velocity[2] = z60;
    result.link4_position[0] = z177;
    result.link4_position[1] = z178;
    result.link4_position[2] = z179;
    result.link4_rotation[0] = z64;
    result.link4_rotation[1] = z66;
    result.link4_rotation[2] = z68;
    result.link4_rotation[3] = z65;
    result.link4_rotation[4] = -z67;
    result.link4_rotation[5] = z69;
    result.link4_rotation[6] = z44;
    result.link4_rotation[7] = -z46;
    result.link4_rotation[8] = -z48;
    result.link4_velocity[0] = z183;
    result.link4_velocity[1] = -z184;
    result.link4_velocity[2] = -z185;
    result.link4_angular_velocity[0] = z81;
    result.link4_angular_velocity[1] = -z82;
    result.link4_angular_velocity[2] = -z83;
    result.link5_position[0] = z189;
    result.link5_position[1] = z190;
    result.link5_position[2] = z191;
    result.link5_rotation[0] = -z87;
    result.link5_rotation[1] = z89;
    result.link5_rotation[2] = z91;
    result.link5_rotation[3] = -z88;
    result.link5_rotation[4] = -z90;
    result.link5_rotation[5] = -z92;
    result.link5_rotation[6] = z65;
    result.link5_rotation[7] = -z67;
    result.link5_rotation[8] = z69;
    result.link5_velocity[0] = -z195;
    result.link5_velocity[1] = z196;
    result.link5_velocity[2] = -z197;
    result.link5_angular_velocity[0] = z105;
    result.link5_angular_velocity[1] = -z106;
    result.link5_angular_velocity[2] = z107;
    result.link6_position[0] = z201;
    result.link6_position[1] = z202;
    result.link6_position[2] = z203;
    result.link6_rotation[0] = z111;
    result.link6_rotation[1] = -z113;
    result.link6_rotation[2] = z115;
    result.link6_rotation[3] = z112;
    result.link6_rotation[4] = -z114;
    result.link6_rotation[5] = -z116;
    result.link6_rotation[6] = z88;
    result.link6_rotation[7] = z90;
    result.link6_rotation[8] = z92;
    result.link6_velocity[0] = -z207;
    result.link6_velocity[1] = -z208;
    result.link6_velocity[2] = -z209;
    result.link6_angular_velocity[0] = z120;
    result.link6_angular_velocity[1] = z121;
    result.link6_angular_velocity[2] = z122;
    result.link7_position[0] = z213;
    result.link7_position[1] = z214;
    result.link7_position[2] = z215;
    result.link7_rotation[0] = z123;
    result.link7_rotation[1] = z125;
    result.link7_rotation[2] = z127;
    result.link7_rotation[3] = -z124;
    result.link7_rotation[4] = z126;
    result.link7_rotation[5] = -z128;
    result.link7_rotation[6] = -z112;
    result.link7_rotation[7] = z114;
    result.link7_rotation[8] = z116;
    result.link7_velocity[0] = z219;
    result.link7_velocity[1] = -z220;
    result.link7_velocity[2] = -z221;
    result.link7_angular_velocity[0] = -z140;
    result.link7_angular_velocity[1] = z141;
    result.link7_angular_velocity[2] = z142;
    result.tip_position[0] = z230;
    result.tip_position[1] = z231;
    result.tip_position[2] = z232;
    result.tip_velocity[0] = -z227;
    result.tip_velocity[1] = -z228;
    result.tip_velocity[2] = -z229;
    result.tip_jacobian[0] = -z258;
    result.tip_jacobian[3] = z260;
    result.tip_jacobian[6] = -z254;
    result.tip_jacobian[9] = z248;
    result.tip_jacobian[12] = -z242;
    result.tip_jacobian[15] = z239;
    result.tip_jacobian[18] = n0;
    result.tip_jacobian[1] = z257;
    result.tip_jacobian[4] = z261;
    result.tip_jacobian[7] = -z255;
    result.tip_jacobian[10] = z249;
    result.tip_jacobian[13] = -z243;
    result.tip_jacobian[16] = -z240;
    result.tip_jacobian[19] = n0;
    result.tip_jacobian[2] = n0;
    result.tip_jacobian[5] = -z262;
    result.tip_jacobian[8] = z256;
    result.tip_jacobian[11] = -z250;
    result.tip_jacobian[14] = -z244;
    result.tip_jacobian[17] = -z241;
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
    const Scalar z264 = k0 * s_q7 - k1 * c_q7;
    const Scalar z265 = k1 * s_q7 + k0 * c_q7;
    const Scalar z266 = k2 * s_q7 - k3 * c_q7;
    const Scalar z267 = k3 * s_q7 + k2 * c_q7;
    const Scalar z268 = k4 + n16_over_15 * z265;
    const Scalar z269 = c_q6 * z264;
    const Scalar z270 = s_q6 * z264;
    const Scalar z271 = s_q6 * z268 + c_q6 * z266;
    const Scalar z272 = s_q6 * z266 - c_q6 * z268;
    const Scalar z273 = s_q5 * z265 - c_q5 * z269;
    const Scalar z274 = s_q5 * z269 + c_q5 * z265;
    const Scalar z275 = s_q5 * z267 - c_q5 * z271;
    const Scalar z276 = s_q5 * z271 + c_q5 * z267;
    const Scalar z277 = n256_over_55 * z274 - z275;
    const Scalar z278 = z272 + z274;
    const Scalar z279 = z270 - n256_over_55 * z273 - z276;
    const Scalar z280 = s_q4 * z270 + c_q4 * z273;
    const Scalar z281 = s_q4 * z273 - c_q4 * z270;
    const Scalar z282 = s_q4 * z278 - c_q4 * z277;
    const Scalar z283 = s_q4 * z277 + c_q4 * z278;
    const Scalar z284 = z279 + z281;
    const Scalar z285 = z274 - z283;
    const Scalar z286 = s_q3 * z274 + c_q3 * z280;
    const Scalar z287 = s_q3 * z280 - c_q3 * z274;
    const Scalar z288 = s_q3 * z284 - c_q3 * z282;
    const Scalar z289 = s_q3 * z282 + c_q3 * z284;
    const Scalar z290 = n632_over_165 * z287 - z288;
    const Scalar z291 = n632_over_165 * z286 - z289;
    const Scalar z295 = s_q2 * z290 - c_q2 * z285;
    const Scalar z296 = k8 * s_q7 - k9 * c_q7;
    const Scalar z297 = s_q7 * z296;
    const Scalar z298 = k8 - z297;
    const Scalar z299 = k10 + c_q7 * z296;
    const Scalar z300 = n16_over_15 * z264 - z299;
    const Scalar z301 = k4 + n32_over_15 * z265;
    const Scalar z302 = n32_over_15 * z265 + z297;
    const Scalar z303 = k12 + z265;
    const Scalar z304 = k13 - z298;
    const Scalar z305 = k14 - z266;
    const Scalar z306 = k15 + z300;
    const Scalar z307 = k16 + z267;
    const Scalar z308 = k17 + z302;
    const Scalar z309 = s_q6 * z303 - k18 * c_q6;
    const Scalar z310 = k18 * s_q6 + c_q6 * z303;
    const Scalar z311 = s_q6 * z307 + c_q6 * z306;
    const Scalar z312 = s_q6 * z306 - c_q6 * z307;
    const Scalar z313 = c_q5 * z309;
    const Scalar z314 = s_q5 * z309;
    const Scalar z315 = s_q5 * z308 - c_q5 * z311;
    const Scalar z316 = s_q5 * z311 + c_q5 * z308;
    const Scalar z317 = n256_over_55 * z314 + z315;
    const Scalar z318 = z312 - z314;
    const Scalar z319 = z310 - n256_over_55 * z313 - z316;
    const Scalar z320 = s_q4 * z310 + c_q4 * z313;
    const Scalar z321 = s_q4 * z313 - c_q4 * z310;
    const Scalar z322 = s_q4 * z318 + c_q4 * z317;
    const Scalar z323 = s_q4 * z317 - c_q4 * z318;
    const Scalar z324 = z319 + z321;
    const Scalar z325 = z314 - z323;
    const Scalar z326 = s_q3 * z314 - c_q3 * z320;
    const Scalar z327 = s_q3 * z320 + c_q3 * z314;
    const Scalar z328 = s_q3 * z324 - c_q3 * z322;
    const Scalar z329 = s_q3 * z322 + c_q3 * z324;
    const Scalar z330 = n632_over_165 * z327 - z328;
    const Scalar z331 = n632_over_165 * z326 + z329;
    const Scalar z335 = s_q2 * z330 + c_q2 * z325;
    const Scalar z336 = z301 + z304;
    const Scalar z337 = n2 * z305;
    const Scalar z338 = s_q6 * z336 - c_q6 * z337;
    const Scalar z339 = s_q6 * z338;
    const Scalar z340 = z304 - z339;
    const Scalar z341 = z301 - z339;
    const Scalar z342 = c_q6 * z338 + z305;
    const Scalar z343 = k20 - z310;
    const Scalar z344 = k21 - z264;
    const Scalar z345 = k22 - z340;
    const Scalar z346 = k23 - z311;
    const Scalar z347 = k24 + z342;
    const Scalar z348 = k25 + z312;
    const Scalar z349 = k26 + z341;
    const Scalar z350 = s_q5 * z343 - c_q5 * z344;
    const Scalar z351 = s_q5 * z344 + c_q5 * z343;
    const Scalar z352 = s_q5 * z348 + c_q5 * z347;
    const Scalar z353 = s_q5 * z347 - c_q5 * z348;
    const Scalar z354 = n256_over_55 * z351 - z352;
    const Scalar z355 = z349 + z351;
    const Scalar z356 = n256_over_55 * z350 - z353;
    const Scalar z357 = c_q4 * z350;
    const Scalar z358 = s_q4 * z350;
    const Scalar z359 = s_q4 * z355 - c_q4 * z354;
    const Scalar z360 = s_q4 * z354 + c_q4 * z355;
    const Scalar z361 = z356 - z358;
    const Scalar z362 = z351 - z360;
    const Scalar z363 = s_q3 * z351 + c_q3 * z357;
    const Scalar z364 = s_q3 * z357 - c_q3 * z351;
    const Scalar z365 = s_q3 * z361 + c_q3 * z359;
    const Scalar z366 = s_q3 * z359 - c_q3 * z361;
    const Scalar z367 = n632_over_165 * z364 + z365;
    const Scalar z368 = n632_over_165 * z363 - z366;
    const Scalar z372 = s_q2 * z367 - c_q2 * z362;
    const Scalar z373 = z308 - z345;
    const Scalar z374 = n2 * z346;
    const Scalar z375 = s_q5 * z373 + c_q5 * z374;
    const Scalar z376 = s_q5 * z375;
    const Scalar z377 = z345 + z376;
    const Scalar z378 = z308 - z376;
    const Scalar z379 = c_q5 * z375 - z346;
    const Scalar z380 = n512_over_55 * z309 + z377;
    const Scalar z381 = z309 + n256_over_55 * z351 - z352;
    const Scalar z382 = z350 + z379;
    const Scalar z383 = z349 + n2 * z351;
    const Scalar z384 = n512_over_55 * z309 + n2 * z351 + z378;
    const Scalar z385 = k28 + z351;
    const Scalar z386 = k29 + z309;
    const Scalar z387 = k30 + z380;
    const Scalar z388 = k31 + z381;
    const Scalar z389 = k32 + z382;
    const Scalar z390 = k33 + z356;
    const Scalar z391 = k34 + z384;
    const Scalar z392 = s_q4 * z385 - c_q4 * z386;
    const Scalar z393 = s_q4 * z386 + c_q4 * z385;
    const Scalar z394 = s_q4 * z390 + c_q4 * z389;
    const Scalar z395 = s_q4 * z389 - c_q4 * z390;
    const Scalar z396 = z391 - z393;
    const Scalar z397 = c_q3 * z392;
    const Scalar z398 = s_q3 * z392;
    const Scalar z399 = s_q3 * z396 + c_q3 * z394;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z406 = s_q2 * z401 + c_q2 * z395;
    const Scalar z407 = z383 - z387;
    const Scalar z408 = n2 * z388;
    const Scalar z409 = s_q4 * z407 - c_q4 * z408;
    const Scalar z410 = s_q4 * z409;
    const Scalar z411 = z387 + z410;
    const Scalar z412 = z383 - z410;
    const Scalar z413 = c_q4 * z409 + z388;
    const Scalar z414 = z350 - z394;
    const Scalar z415 = z392 - z413;
    const Scalar z416 = z391 - n2 * z393;
    const Scalar z417 = n2 * z393 - z412;
    const Scalar z418 = k35 - z393;
    const Scalar z419 = k36 - z350;
    const Scalar z420 = k37 + z411;
    const Scalar z421 = k38 - z414;
    const Scalar z422 = k39 - z415;
    const Scalar z423 = k40 + z395;
    const Scalar z424 = k41 - z417;
    const Scalar z425 = s_q3 * z418 + c_q3 * z419;
    const Scalar z426 = s_q3 * z419 - c_q3 * z418;
    const Scalar z427 = s_q3 * z423 - c_q3 * z422;
    const Scalar z428 = s_q3 * z422 + c_q3 * z423;
    const Scalar z429 = n632_over_165 * z426 + z427;
    const Scalar z430 = n632_over_165 * z425 + z428;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z435 = z416 - z420;
    const Scalar z436 = n2 * z421;
    const Scalar z437 = s_q3 * z435 + c_q3 * z436;
    const Scalar z438 = s_q3 * z437;
    const Scalar z439 = z420 + z438;
    const Scalar z440 = z416 - z438;
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z442 = k42 * z392 - z439;
    const Scalar z443 = k42 * z392 - z440;
    const Scalar z446 = k43 - z442;
    const Scalar z447 = k44 + z429;
    const Scalar z448 = k45 - z441;
    const Scalar z449 = k46 + z430;
    const Scalar z450 = k47 - z443;
    const Scalar z454 = s_q2 * z448 + c_q2 * z449;
    const Scalar z455 = z424 - z446;
    const Scalar z456 = n2 * z447;
    const Scalar z457 = s_q2 * z455 + c_q2 * z456;
    const Scalar z458 = s_q2 * z457;
    const Scalar z460 = z424 - z458;
    const Scalar z468 = k48 + z460;
    mass[0] = z468;
    mass[1] = -z454;
    mass[2] = -z434;
    mass[3] = z406;
    mass[4] = z372;
    mass[5] = -z335;
    mass[6] = z295;
    mass[7] = -z454;
    mass[8] = z450;
    mass[9] = -z430;
    mass[10] = z402;
    mass[11] = z368;
    mass[12] = z331;
    mass[13] = z291;
    mass[14] = -z434;
    mass[15] = -z430;
    mass[16] = z424;
    mass[17] = z395;
    mass[18] = -z362;
    mass[19] = -z325;
    mass[20] = -z285;
    mass[21] = z406;
    mass[22] = z402;
    mass[23] = z395;
    mass[24] = z391;
    mass[25] = -z356;
    mass[26] = -z319;
    mass[27] = z279;
    mass[28] = z372;
    mass[29] = z368;
    mass[30] = -z362;
    mass[31] = -z356;
    mass[32] = z349;
    mass[33] = -z312;
    mass[34] = z272;
    mass[35] = -z335;
    mass[36] = z331;
    mass[37] = -z325;
    mass[38] = -z319;
    mass[39] = -z312;
    mass[40] = z308;
    mass[41] = -z267;
    mass[42] = z295;
    mass[43] = z291;
    mass[44] = -z285;
    mass[45] = z279;
    mass[46] = z272;
    mass[47] = -z267;
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = s_q5 * z78 + c_q5 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z476 = k0 * s_q2;
    const Scalar z477 = k0 * c_q2;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z480 = z39 * z40;
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z482 = z39 * z39;
    const Scalar z483 = z481 + z482;
    const Scalar z484 = n2 * z478;
    const Scalar z485 = c_q3 * z478;
    const Scalar z486 = s_q3 * z478;
    const Scalar z487 = z476 + n632_over_165 * z480;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z489 = n632_over_165 * z484;
    const Scalar z490 = s_q3 * z489 - c_q3 * z487;
    const Scalar z491 = s_q3 * z487 + c_q3 * z489;
    const Scalar z492 = v_q3 * z56 - z485;  // angular acceleration of link3, x
    const Scalar z493 = v_q3 * z55 - z486;  // angular acceleration of link3, y
    const Scalar z494 = z56 * z56;
    const Scalar z495 = z57 * z57;
    const Scalar z496 = z494 + z495;
    const Scalar z497 = z55 * z56;
    const Scalar z498 = z479 - z497;
    const Scalar z499 = z55 * z57;
    const Scalar z500 = z493 + z499;
    const Scalar z501 = s_q4 * z479 - c_q4 * z492;
    const Scalar z502 = s_q4 * z492 + c_q4 * z479;
    const Scalar z503 = z490 - z496;
    const Scalar z504 = z491 - z498;
    const Scalar z505 = z488 + z500;
    const Scalar z506 = s_q4 * z505 + c_q4 * z503;
    const Scalar z507 = s_q4 * z503 - c_q4 * z505;
    const Scalar z508 = v_q4 * z79 + z501;  // angular acceleration of link4, x
    const Scalar z509 = v_q4 * z78 + z502;  // angular acceleration of link4, y
    const Scalar z510 = z79 * z79;
    const Scalar z511 = z80 * z80;
    const Scalar z512 = z510 + z511;
    const Scalar z513 = z78 * z79;
    const Scalar z514 = z493 + z513;
    const Scalar z515 = z493 - z513;
    const Scalar z516 = z78 * z78;
    const Scalar z517 = z511 + z516;
    const Scalar z518 = z78 * z80;
    const Scalar z519 = z509 + z518;
    const Scalar z520 = z79 * z80;
    const Scalar z521 = z508 + z520;
    const Scalar z522 = s_q5 * z493 + c_q5 * z508;
    const Scalar z523 = s_q5 * z508 - c_q5 * z493;
    const Scalar z524 = z506 + z512 - n256_over_55 * z514;
    const Scalar z525 = z507 + z515 + n256_over_55 * z517;
    const Scalar z526 = z504 + z519 + n256_over_55 * z521;
    const Scalar z527 = s_q5 * z526 + c_q5 * z524;
    const Scalar z528 = s_q5 * z524 - c_q5 * z526;
    const Scalar z529 = v_q5 * z103 + z522;  // angular acceleration of link5, x
    const Scalar z530 = v_q5 * z102 + z523;  // angular acceleration of link5, y
    const Scalar z531 = s_q6 * z509 + c_q6 * z529;
    const Scalar z532 = s_q6 * z529 - c_q6 * z509;
    const Scalar z533 = s_q6 * z525 - c_q6 * z527;
    const Scalar z534 = s_q6 * z527 + c_q6 * z525;
    const Scalar z535 = v_q6 * z118 - z531;  // angular acceleration of link6, x
    const Scalar z536 = v_q6 * z117 - z532;  // angular acceleration of link6, y
    const Scalar z537 = z118 * z118;
    const Scalar z538 = z119 * z119;
    const Scalar z539 = z537 + z538;
    const Scalar z540 = z117 * z118;
    const Scalar z541 = z530 - z540;
    const Scalar z542 = z117 * z119;
    const Scalar z543 = z536 + z542;
    const Scalar z544 = s_q7 * z530 - c_q7 * z535;
    const Scalar z545 = s_q7 * z535 + c_q7 * z530;
    const Scalar z546 = z533 + n16_over_15 * z539;
    const Scalar z547 = z534 + n16_over_15 * z541;
    const Scalar z548 = z528 + n16_over_15 * z543;
    const Scalar z549 = s_q7 * z548 - c_q7 * z546;
    const Scalar z550 = s_q7 * z546 + c_q7 * z548;
    const Scalar z551 = v_q7 * z138 + z544;  // angular acceleration of link7, x
    const Scalar z552 = v_q7 * z137 + z545;  // angular acceleration of link7, y
    const Scalar z553 = z138 * z138;
    const Scalar z554 = z139 * z139;
    const Scalar z555 = z553 + z554;
    const Scalar z556 = z137 * z138;
    const Scalar z557 = z536 + z556;
    const Scalar z558 = z536 - z556;
    const Scalar z559 = z137 * z137;
    const Scalar z560 = z554 + z559;
    const Scalar z561 = z137 * z139;
    const Scalar z562 = z552 + z561;
    const Scalar z563 = z138 * z139;
    const Scalar z564 = z551 + z563;
    const Scalar z565 = z553 - z554;
    const Scalar z566 = z554 - z559;
    const Scalar z567 = z551 - z563;
    const Scalar z568 = z552 - z561;
    const Scalar z569 = z553 - z559;
    const Scalar z570 = k5 * z555 - k6 * z557;  // force on link7, times 0.0825 m, x
    const Scalar z571 = k5 * z558 + k6 * z560;  // force on link7, times 0.0825 m, y
    const Scalar z572 = k5 * z562 + k6 * z564;  // force on link7, times 0.0825 m, z
    const Scalar z573 = k6 * z547 + k7 * z558 - k8 * z562 + k9 * z564 + k10 * z565;  // moment on link7, x
    const Scalar z574 = k5 * z547 + k10 * z557 + k11 * z562 - k8 * z564 + k7 * z566;  // moment on link7, y
    // moment on link7, z
    const Scalar z575 = k12 * z536 + k6 * z549 + k5 * z550 + k13 * z556 + k7 * z567 + k10 * z568 + k8 * z569;
    const Scalar z576 = s_q7 * z571 + c_q7 * z570;
    const Scalar z577 = s_q7 * z570 - c_q7 * z571;
    const Scalar z578 = s_q7 * z574 - c_q7 * z573;
    const Scalar z579 = s_q7 * z573 + c_q7 * z574;
    const Scalar z580 = z530 + z540;
    const Scalar z581 = z117 * z117;
    const Scalar z582 = z538 + z581;
    const Scalar z583 = z118 * z119;
    const Scalar z584 = z535 + z583;
    const Scalar z585 = z537 - z538;
    const Scalar z586 = z538 - z581;
    const Scalar z587 = z535 - z583;
    const Scalar z588 = z536 - z542;
    const Scalar z589 = z537 - z581;
    const Scalar z590 = k14 * z539 + z576 + k15 * z580;  // force on link6, times 0.0825 m, x
    const Scalar z591 = k14 * z541 + z572 - k15 * z582;  // force on link6, times 0.0825 m, y
    const Scalar z592 = k14 * z543 - z577 - k15 * z584;  // force on link6, times 0.0825 m, z
    const Scalar z593 = k15 * z528 - k16 * z541 + k17 * z543 - z578 - k18 * z584 - k19 * z585;  // moment on link6, x
    // moment on link6, y
    const Scalar z594 = k14 * z528 + k20 * z543 + z575 - n16_over_15 * z577 + k19 * z580 - k17 * z584 + k16 * z586;
    // moment on link6, z
    const Scalar z595 = k21 * z530 + k15 * z533 + k14 * z534 - k22 * z540 + n16_over_15 * z572 + z579 + k16 * z587 + k19
        * z588 + k17 * z589;
    const Scalar z596 = s_q6 * z591 - c_q6 * z590;
    const Scalar z597 = s_q6 * z590 + c_q6 * z591;
    const Scalar z598 = s_q6 * z594 - c_q6 * z593;
    const Scalar z599 = s_q6 * z593 + c_q6 * z594;
    const Scalar z600 = z103 * z103;
    const Scalar z601 = z104 * z104;
    const Scalar z602 = z600 + z601;
    const Scalar z603 = z102 * z103;
    const Scalar z604 = z509 + z603;
    const Scalar z605 = z509 - z603;
    const Scalar z606 = z102 * z102;
    const Scalar z607 = z601 + z606;
    const Scalar z608 = z102 * z104;
    const Scalar z609 = z530 + z608;
    const Scalar z610 = z103 * z104;
    const Scalar z611 = z529 + z610;
    const Scalar z612 = z600 - z601;
    const Scalar z613 = z601 - z606;
    const Scalar z614 = z529 - z610;
    const Scalar z615 = z530 - z608;
    const Scalar z616 = z600 - z606;
    const Scalar z617 = z596 + k23 * z602 + k24 * z604;  // force on link5, times 0.0825 m, x
    const Scalar z618 = z592 - k23 * z605 + k24 * z607;  // force on link5, times 0.0825 m, y
    const Scalar z619 = z597 - k23 * z609 + k24 * z611;  // force on link5, times 0.0825 m, z
    const Scalar z620 = k24 * z525 - z598 - k25 * z605 + k26 * z609 + k27 * z611 - k28 * z612;  // moment on link5, x
    const Scalar z621 = k23 * z525 - z595 + k28 * z604 - k29 * z609 - k26 * z611 + k25 * z613;  // moment on link5, y
    // moment on link5, z
    const Scalar z622 = k30 * z509 + k24 * z527 - k23 * z528 + z599 + k31 * z603 - k25 * z614 - k28 * z615 - k26 * z616;
    const Scalar z623 = s_q5 * z618 + c_q5 * z617;
    const Scalar z624 = s_q5 * z617 - c_q5 * z618;
    const Scalar z625 = s_q5 * z621 - c_q5 * z620;
    const Scalar z626 = s_q5 * z620 + c_q5 * z621;
    const Scalar z627 = z510 - z511;
    const Scalar z628 = z511 - z516;
    const Scalar z629 = z508 - z520;
    const Scalar z630 = z509 - z518;
    const Scalar z631 = z510 - z516;
    const Scalar z632 = k32 * z512 - k33 * z514 + z623;  // force on link4, times 0.0825 m, x
    const Scalar z633 = k32 * z515 + k33 * z517 + z619;  // force on link4, times 0.0825 m, y
    const Scalar z634 = k32 * z519 + k33 * z521 + z624;  // force on link4, times 0.0825 m, z
    // moment on link4, x
    const Scalar z635 = k33 * z504 - k34 * z515 + k35 * z519 + k36 * z521 + n256_over_55 * z624 - z625 + k37 * z627;
    // moment on link4, y
    const Scalar z636 = k32 * z504 + k37 * z514 + k38 * z519 + k35 * z521 + z622 + z624 - k34 * z628;
    // moment on link4, z
    const Scalar z637 = k39 * z493 - k33 * z506 + k32 * z507 + k40 * z513 + z619 - n256_over_55 * z623 + z626 - k34
        * z629 + k37 * z630 - k35 * z631;
    const Scalar z638 = s_q4 * z633 + c_q4 * z632;
    const Scalar z639 = s_q4 * z632 - c_q4 * z633;
    const Scalar z640 = s_q4 * z636 - c_q4 * z635;
    const Scalar z641 = s_q4 * z635 + c_q4 * z636;
    const Scalar z642 = z479 + z497;
    const Scalar z643 = z55 * z55;
    const Scalar z644 = z495 + z643;
    const Scalar z645 = z56 * z57;
    const Scalar z646 = z492 + z645;
    const Scalar z647 = z494 - z495;
    const Scalar z648 = z495 - z643;
    const Scalar z649 = z492 - z645;
    const Scalar z650 = z493 - z499;
    const Scalar z651 = z494 - z643;
    const Scalar z652 = k41 * z496 - z638 - k42 * z642;  // force on link3, times 0.0825 m, x
    const Scalar z653 = k41 * z498 - z634 + k42 * z644;  // force on link3, times 0.0825 m, y
    const Scalar z655 = k42 * z488 + k43 * z498 + k44 * z500 + z640 + k45 * z646 - k46 * z647;  // moment on link3, x
    // moment on link3, y
    const Scalar z656 = k41 * z488 + k47 * z500 + z637 + z639 - k46 * z642 + k44 * z646 + k43 * z648;
    // moment on link3, z
    const Scalar z657 = k48 * z479 + k42 * z490 - k41 * z491 - k49 * z497 - z634 + z641 + k43 * z649 - k46 * z650 - k44
        * z651;
    const Scalar z658 = s_q3 * z653 - c_q3 * z652;
    const Scalar z659 = s_q3 * z652 + c_q3 * z653;
    const Scalar z660 = s_q3 * z656 + c_q3 * z655;
    const Scalar z661 = s_q3 * z655 - c_q3 * z656;
    const Scalar z662 = z40 * z40;
    const Scalar z664 = n2 * z479;
    const Scalar z665 = z481 - z662;
    const Scalar z666 = z481 - z482;
    const Scalar z667 = z482 - z662;
    // moment on link2, x
    const Scalar z671 = k50 * z480 - k51 * z484 + n632_over_165 * z659 + z660 - k52 * z664 - k53 * z665;
    const Scalar z672 = k53 * z480 - k52 * z484 - z657 - k54 * z664 - k50 * z666;  // moment on link2, y
    // moment on link2, z
    const Scalar z673 = k55 * z476 - k56 * z477 + k57 * z480 - n632_over_165 * z658 - z661 + k52 * z667;
    const Scalar z677 = s_q2 * z671 - c_q2 * z672;
    forces.q1 = -z677;
    forces.q2 = -z673;
    forces.q3 = -z657;
    forces.q4 = z637;
    forces.q5 = -z622;
    forces.q6 = -z595;
    forces.q7 = z575;
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = s_q5 * z78 + c_q5 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z476 = k0 * s_q2;
    const Scalar z477 = k0 * c_q2;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z480 = z39 * z40;
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z482 = z39 * z39;
    const Scalar z483 = z481 + z482;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z494 = z56 * z56;
    const Scalar z495 = z57 * z57;
    const Scalar z496 = z494 + z495;
    const Scalar z497 = z55 * z56;
    const Scalar z499 = z55 * z57;
    const Scalar z510 = z79 * z79;
    const Scalar z511 = z80 * z80;
    const Scalar z512 = z510 + z511;
    const Scalar z513 = z78 * z79;
    const Scalar z516 = z78 * z78;
    const Scalar z517 = z511 + z516;
    const Scalar z518 = z78 * z80;
    const Scalar z520 = z79 * z80;
    const Scalar z537 = z118 * z118;
    const Scalar z538 = z119 * z119;
    const Scalar z539 = z537 + z538;
    const Scalar z540 = z117 * z118;
    const Scalar z542 = z117 * z119;
    const Scalar z553 = z138 * z138;
    const Scalar z554 = z139 * z139;
    const Scalar z555 = z553 + z554;
    const Scalar z556 = z137 * z138;
    const Scalar z559 = z137 * z137;
    const Scalar z560 = z554 + z559;
    const Scalar z561 = z137 * z139;
    const Scalar z563 = z138 * z139;
    const Scalar z565 = z553 - z554;
    const Scalar z566 = z554 - z559;
    const Scalar z569 = z553 - z559;
    const Scalar z581 = z117 * z117;
    const Scalar z582 = z538 + z581;
    const Scalar z583 = z118 * z119;
    const Scalar z585 = z537 - z538;
    const Scalar z586 = z538 - z581;
    const Scalar z589 = z537 - z581;
    const Scalar z600 = z103 * z103;
    const Scalar z601 = z104 * z104;
    const Scalar z602 = z600 + z601;
    const Scalar z603 = z102 * z103;
    const Scalar z606 = z102 * z102;
    const Scalar z607 = z601 + z606;
    const Scalar z608 = z102 * z104;
    const Scalar z610 = z103 * z104;
    const Scalar z612 = z600 - z601;
    const Scalar z613 = z601 - z606;
    const Scalar z616 = z600 - z606;
    const Scalar z627 = z510 - z511;
    const Scalar z628 = z511 - z516;
    const Scalar z631 = z510 - z516;
    const Scalar z643 = z55 * z55;
    const Scalar z644 = z495 + z643;
    const Scalar z645 = z56 * z57;
    const Scalar z647 = z494 - z495;
    const Scalar z648 = z495 - z643;
    const Scalar z651 = z494 - z643;
    const Scalar z662 = z40 * z40;
    const Scalar z665 = z481 - z662;
    const Scalar z666 = z481 - z482;
    const Scalar z667 = z482 - z662;
    const Scalar z683 = a_q1 * s_q2;
    const Scalar z684 = a_q1 * c_q2;
    const Scalar z685 = v_q2 * z40 + z683;  // angular acceleration of link2, x
    const Scalar z686 = v_q2 * z39 - z684;  // angular acceleration of link2, y
    const Scalar z687 = a_q2 - z480;
    const Scalar z688 = z478 + z685;
    const Scalar z689 = a_q2 * s_q3 - c_q3 * z685;
    const Scalar z690 = a_q2 * c_q3 + s_q3 * z685;
    const Scalar z691 = z476 - n632_over_165 * z687;
    const Scalar z692 = n632_over_165 * z688;
    const Scalar z693 = s_q3 * z692 - c_q3 * z691;
    const Scalar z694 = s_q3 * z691 + c_q3 * z692;
    const Scalar z695 = v_q3 * z56 + z689;  // angular acceleration of link3, x
    const Scalar z696 = v_q3 * z55 - z690;  // angular acceleration of link3, y
    const Scalar z697 = a_q3 - z686;  // angular acceleration of link3, z
    const Scalar z698 = z497 + z697;
    const Scalar z699 = z499 + z696;
    const Scalar z700 = s_q4 * z697 + c_q4 * z695;
    const Scalar z701 = s_q4 * z695 - c_q4 * z697;
    const Scalar z702 = z496 - z693;
    const Scalar z703 = z694 + z698;
    const Scalar z704 = z488 + z699;
    const Scalar z705 = s_q4 * z704 - c_q4 * z702;
    const Scalar z706 = s_q4 * z702 + c_q4 * z704;
    const Scalar z707 = v_q4 * z79 - z700;  // angular acceleration of link4, x
    const Scalar z708 = v_q4 * z78 + z701;  // angular acceleration of link4, y
    const Scalar z709 = a_q4 + z696;  // angular acceleration of link4, z
    const Scalar z710 = z513 + z709;
    const Scalar z711 = z513 - z709;
    const Scalar z712 = z518 + z708;
    const Scalar z713 = z520 + z707;
    const Scalar z714 = s_q5 * z709 + c_q5 * z707;
    const Scalar z715 = s_q5 * z707 - c_q5 * z709;
    const Scalar z716 = z512 + z705 - n256_over_55 * z710;
    const Scalar z717 = n256_over_55 * z517 - z706 - z711;
    const Scalar z718 = z703 + z712 + n256_over_55 * z713;
    const Scalar z719 = s_q5 * z718 + c_q5 * z716;
    const Scalar z720 = s_q5 * z716 - c_q5 * z718;
    const Scalar z721 = v_q5 * z103 + z714;  // angular acceleration of link5, x
    const Scalar z722 = v_q5 * z102 + z715;  // angular acceleration of link5, y
    const Scalar z723 = a_q5 - z708;  // angular acceleration of link5, z
    const Scalar z724 = s_q6 * z723 - c_q6 * z721;
    const Scalar z725 = s_q6 * z721 + c_q6 * z723;
    const Scalar z726 = s_q6 * z717 - c_q6 * z719;
    const Scalar z727 = s_q6 * z719 + c_q6 * z717;
    const Scalar z728 = v_q6 * z118 + z724;  // angular acceleration of link6, x
    const Scalar z729 = v_q6 * z117 - z725;  // angular acceleration of link6, y
    const Scalar z730 = a_q6 - z722;  // angular acceleration of link6, z
    const Scalar z731 = z540 + z730;
    const Scalar z732 = z542 + z729;
    const Scalar z733 = s_q7 * z730 + c_q7 * z728;
    const Scalar z734 = s_q7 * z728 - c_q7 * z730;
    const Scalar z735 = n16_over_15 * z539 + z726;
    const Scalar z736 = z727 - n16_over_15 * z731;
    const Scalar z737 = z720 + n16_over_15 * z732;
    const Scalar z738 = s_q7 * z737 - c_q7 * z735;
    const Scalar z739 = s_q7 * z735 + c_q7 * z737;
    const Scalar z740 = v_q7 * z138 - z733;  // angular acceleration of link7, x
    const Scalar z741 = v_q7 * z137 + z734;  // angular acceleration of link7, y
    const Scalar z742 = a_q7 + z729;  // angular acceleration of link7, z
    const Scalar z743 = z556 + z742;
    const Scalar z744 = z556 - z742;
    const Scalar z745 = z561 + z741;
    const Scalar z746 = z563 + z740;
    const Scalar z747 = z563 - z740;
    const Scalar z748 = z561 - z741;
    const Scalar z749 = k4 * z555 - k5 * z743;  // force on link7, times 0.0825 m, x
    const Scalar z750 = k5 * z560 - k4 * z744;  // force on link7, times 0.0825 m, y
    const Scalar z751 = k4 * z745 + k5 * z746;  // force on link7, times 0.0825 m, z
    const Scalar z752 = k6 * z565 + k5 * z736 - k7 * z744 - k8 * z745 + k9 * z746;  // moment on link7, x
    const Scalar z753 = k7 * z566 + k4 * z736 + k6 * z743 + k10 * z745 - k8 * z746;  // moment on link7, y
    // moment on link7, z
    const Scalar z754 = k11 * z556 + k8 * z569 + k5 * z738 + k4 * z739 + k12 * z742 - k7 * z747 - k6 * z748;
    const Scalar z755 = s_q7 * z750 + c_q7 * z749;
    const Scalar z756 = s_q7 * z749 - c_q7 * z750;
    const Scalar z757 = s_q7 * z753 - c_q7 * z752;
    const Scalar z758 = s_q7 * z752 + c_q7 * z753;
    const Scalar z759 = z540 - z730;
    const Scalar z760 = z583 + z728;
    const Scalar z761 = z583 - z728;
    const Scalar z762 = z542 - z729;
    const Scalar z763 = k13 * z539 + z755 + k14 * z759;  // force on link6, times 0.0825 m, x
    const Scalar z764 = k14 * z582 + k13 * z731 - z751;  // force on link6, times 0.0825 m, y
    const Scalar z765 = k13 * z732 - z756 - k14 * z760;  // force on link6, times 0.0825 m, z
    const Scalar z766 = k15 * z585 - k14 * z720 - k16 * z731 - k17 * z732 + z757 + k18 * z760;  // moment on link6, x
    // moment on link6, y
    const Scalar z767 = k16 * z586 + k13 * z720 + k19 * z732 + z754 - n16_over_15 * z756 + k15 * z759 - k17 * z760;
    // moment on link6, z
    const Scalar z768 = k20 * z540 - k17 * z589 - k14 * z726 - k13 * z727 + k21 * z730 - n16_over_15 * z751 - z758 + k16
        * z761 + k15 * z762;
    const Scalar z769 = s_q6 * z764 + c_q6 * z763;
    const Scalar z770 = s_q6 * z763 - c_q6 * z764;
    const Scalar z771 = s_q6 * z767 + c_q6 * z766;
    const Scalar z772 = s_q6 * z766 - c_q6 * z767;
    const Scalar z773 = z603 - z723;
    const Scalar z774 = z603 + z723;
    const Scalar z775 = z608 + z722;
    const Scalar z776 = z610 + z721;
    const Scalar z777 = z610 - z721;
    const Scalar z778 = z608 - z722;
    const Scalar z779 = k22 * z602 - z769 + k23 * z773;  // force on link5, times 0.0825 m, x
    const Scalar z780 = k23 * z607 + z765 + k22 * z774;  // force on link5, times 0.0825 m, y
    const Scalar z781 = z770 - k22 * z775 + k23 * z776;  // force on link5, times 0.0825 m, z
    const Scalar z782 = k24 * z612 - k23 * z717 + z771 - k25 * z774 - k26 * z775 - k27 * z776;  // moment on link5, x
    const Scalar z783 = k25 * z613 + k22 * z717 + z768 + k24 * z773 - k28 * z775 - k26 * z776;  // moment on link5, y
    // moment on link5, z
    const Scalar z784 = k29 * z603 - k26 * z616 + k23 * z719 - k22 * z720 - k30 * z723 - z772 + k25 * z777 + k24 * z778;
    const Scalar z785 = s_q5 * z780 + c_q5 * z779;
    const Scalar z786 = s_q5 * z779 - c_q5 * z780;
    const Scalar z787 = s_q5 * z783 + c_q5 * z782;
    const Scalar z788 = s_q5 * z782 - c_q5 * z783;
    const Scalar z789 = z520 - z707;
    const Scalar z790 = z518 - z708;
    const Scalar z791 = k31 * z512 - k32 * z710 + z785;  // force on link4, times 0.0825 m, x
    const Scalar z792 = k32 * z517 - k31 * z711 + z781;  // force on link4, times 0.0825 m, y
    const Scalar z793 = k31 * z712 + k32 * z713 + z786;  // force on link4, times 0.0825 m, z
    // moment on link4, x
    const Scalar z794 = k33 * z627 + k32 * z703 + k34 * z711 + k35 * z712 + k36 * z713 + n256_over_55 * z786 - z787;
    // moment on link4, y
    const Scalar z795 = k34 * z628 - k31 * z703 - k33 * z710 - k37 * z712 - k35 * z713 - z784 - z786;
    // moment on link4, z
    const Scalar z796 = k38 * z513 - k35 * z631 - k32 * z705 - k31 * z706 + k39 * z709 + z781 - n256_over_55 * z785
        - z788 + k34 * z789 - k33 * z790;
    const Scalar z797 = s_q4 * z792 + c_q4 * z791;
    const Scalar z798 = s_q4 * z791 - c_q4 * z792;
    const Scalar z799 = s_q4 * z795 + c_q4 * z794;
    const Scalar z800 = s_q4 * z794 - c_q4 * z795;
    const Scalar z801 = z497 - z697;
    const Scalar z802 = z645 + z695;
    const Scalar z803 = z645 - z695;
    const Scalar z804 = z499 - z696;
    const Scalar z805 = k40 * z496 - z797 - k41 * z801;  // force on link3, times 0.0825 m, x
    const Scalar z806 = k41 * z644 - k40 * z698 - z793;  // force on link3, times 0.0825 m, y
    const Scalar z808 = k41 * z488 - k42 * z647 - k43 * z698 + k44 * z699 - z799 + k45 * z802;  // moment on link3, x
    // moment on link3, y
    const Scalar z809 = k40 * z488 + k43 * z648 + k46 * z699 + z796 + z798 - k42 * z801 + k44 * z802;
    // moment on link3, z
    const Scalar z810 = k47 * z497 + k44 * z651 - k41 * z693 + k40 * z694 + k48 * z697 + z793 - z800 + k43 * z803 - k42
        * z804;
    const Scalar z811 = s_q3 * z806 - c_q3 * z805;
    const Scalar z812 = s_q3 * z805 + c_q3 * z806;
    const Scalar z813 = s_q3 * z809 + c_q3 * z808;
    const Scalar z814 = s_q3 * z808 - c_q3 * z809;
    const Scalar z815 = a_q2 + z480;
    const Scalar z816 = z479 + z686;
    const Scalar z817 = z478 - z685;
    const Scalar z818 = z479 - z686;
    // moment on link2, x
    const Scalar z822 = k49 * z665 + k50 * z688 - n632_over_165 * z812 - z813 - k51 * z815 + k52 * z816;
    const Scalar z823 = k51 * z666 + k49 * z687 + k52 * z688 - z810 + k53 * z816;  // moment on link2, y
    // moment on link2, z
    const Scalar z824 = k54 * a_q2 - k55 * z476 + k56 * z477 - k57 * z480 - k52 * z667 + n632_over_165 * z811 + z814
        + k51 * z817 - k49 * z818;
    const Scalar z828 = s_q2 * z822 - c_q2 * z823;
    const Scalar z833 = k58 * a_q1 + z828;  // moment on link1, z
    forces.q1 = z833;
    forces.q2 = z824;
    forces.q3 = z810;
    forces.q4 = z796;
    forces.q5 = -z784;
    forces.q6 = z768;
    forces.q7 = z754;
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = s_q5 * z78 + c_q5 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z264 = k0 * s_q7 - k1 * c_q7;
    const Scalar z265 = k1 * s_q7 + k0 * c_q7;
    const Scalar z266 = k2 * s_q7 - k3 * c_q7;
    const Scalar z267 = k3 * s_q7 + k2 * c_q7;
    const Scalar z268 = k4 + n16_over_15 * z265;
    const Scalar z269 = c_q6 * z264;
    const Scalar z270 = s_q6 * z264;
    const Scalar z271 = s_q6 * z268 + c_q6 * z266;
    const Scalar z272 = s_q6 * z266 - c_q6 * z268;
    const Scalar z273 = s_q5 * z265 - c_q5 * z269;
    const Scalar z274 = s_q5 * z269 + c_q5 * z265;
    const Scalar z275 = s_q5 * z267 - c_q5 * z271;
    const Scalar z276 = s_q5 * z271 + c_q5 * z267;
    const Scalar z277 = n256_over_55 * z274 - z275;
    const Scalar z278 = z272 + z274;
    const Scalar z279 = z270 - n256_over_55 * z273 - z276;
    const Scalar z280 = s_q4 * z270 + c_q4 * z273;
    const Scalar z281 = s_q4 * z273 - c_q4 * z270;
    const Scalar z282 = s_q4 * z278 - c_q4 * z277;
    const Scalar z283 = s_q4 * z277 + c_q4 * z278;
    const Scalar z284 = z279 + z281;
    const Scalar z285 = z274 - z283;
    const Scalar z286 = s_q3 * z274 + c_q3 * z280;
    const Scalar z287 = s_q3 * z280 - c_q3 * z274;
    const Scalar z288 = s_q3 * z284 - c_q3 * z282;
    const Scalar z289 = s_q3 * z282 + c_q3 * z284;
    const Scalar z290 = n632_over_165 * z287 - z288;
    const Scalar z291 = n632_over_165 * z286 - z289;
    const Scalar z295 = s_q2 * z290 - c_q2 * z285;
    const Scalar z296 = k8 * s_q7 - k9 * c_q7;
    const Scalar z297 = s_q7 * z296;
    const Scalar z298 = k8 - z297;
    const Scalar z299 = k10 + c_q7 * z296;
    const Scalar z300 = n16_over_15 * z264 - z299;
    const Scalar z301 = k4 + n32_over_15 * z265;
    const Scalar z302 = n32_over_15 * z265 + z297;
    const Scalar z303 = k12 + z265;
    const Scalar z304 = k13 - z298;
    const Scalar z305 = k14 - z266;
    const Scalar z306 = k15 + z300;
    const Scalar z307 = k16 + z267;
    const Scalar z308 = k17 + z302;
    const Scalar z309 = s_q6 * z303 - k18 * c_q6;
    const Scalar z310 = k18 * s_q6 + c_q6 * z303;
    const Scalar z311 = s_q6 * z307 + c_q6 * z306;
    const Scalar z312 = s_q6 * z306 - c_q6 * z307;
    const Scalar z313 = c_q5 * z309;
    const Scalar z314 = s_q5 * z309;
    const Scalar z315 = s_q5 * z308 - c_q5 * z311;
    const Scalar z316 = s_q5 * z311 + c_q5 * z308;
    const Scalar z317 = n256_over_55 * z314 + z315;
    const Scalar z318 = z312 - z314;
    const Scalar z319 = z310 - n256_over_55 * z313 - z316;
    const Scalar z320 = s_q4 * z310 + c_q4 * z313;
    const Scalar z321 = s_q4 * z313 - c_q4 * z310;
    const Scalar z322 = s_q4 * z318 + c_q4 * z317;
    const Scalar z323 = s_q4 * z317 - c_q4 * z318;
    const Scalar z324 = z319 + z321;
    const Scalar z325 = z314 - z323;
    const Scalar z326 = s_q3 * z314 - c_q3 * z320;
    const Scalar z327 = s_q3 * z320 + c_q3 * z314;
    const Scalar z328 = s_q3 * z324 - c_q3 * z322;
    const Scalar z329 = s_q3 * z322 + c_q3 * z324;
    const Scalar z330 = n632_over_165 * z327 - z328;
    const Scalar z331 = n632_over_165 * z326 + z329;
    const Scalar z335 = s_q2 * z330 + c_q2 * z325;
    const Scalar z336 = z301 + z304;
    const Scalar z337 = n2 * z305;
    const Scalar z338 = s_q6 * z336 - c_q6 * z337;
    const Scalar z339 = s_q6 * z338;
    const Scalar z340 = z304 - z339;
    const Scalar z341 = z301 - z339;
    const Scalar z342 = c_q6 * z338 + z305;
    const Scalar z343 = k20 - z310;
    const Scalar z344 = k21 - z264;
    const Scalar z345 = k22 - z340;
    const Scalar z346 = k23 - z311;
    const Scalar z347 = k24 + z342;
    const Scalar z348 = k25 + z312;
    const Scalar z349 = k26 + z341;
    const Scalar z350 = s_q5 * z343 - c_q5 * z344;
    const Scalar z351 = s_q5 * z344 + c_q5 * z343;
    const Scalar z352 = s_q5 * z348 + c_q5 * z347;
    const Scalar z353 = s_q5 * z347 - c_q5 * z348;
    const Scalar z354 = n256_over_55 * z351 - z352;
    const Scalar z355 = z349 + z351;
    const Scalar z356 = n256_over_55 * z350 - z353;
    const Scalar z357 = c_q4 * z350;
    const Scalar z358 = s_q4 * z350;
    const Scalar z359 = s_q4 * z355 - c_q4 * z354;
    const Scalar z360 = s_q4 * z354 + c_q4 * z355;
    const Scalar z361 = z356 - z358;
    const Scalar z362 = z351 - z360;
    const Scalar z363 = s_q3 * z351 + c_q3 * z357;
    const Scalar z364 = s_q3 * z357 - c_q3 * z351;
    const Scalar z365 = s_q3 * z361 + c_q3 * z359;
    const Scalar z366 = s_q3 * z359 - c_q3 * z361;
    const Scalar z367 = n632_over_165 * z364 + z365;
    const Scalar z368 = n632_over_165 * z363 - z366;
    const Scalar z372 = s_q2 * z367 - c_q2 * z362;
    const Scalar z373 = z308 - z345;
    const Scalar z374 = n2 * z346;
    const Scalar z375 = s_q5 * z373 + c_q5 * z374;
    const Scalar z376 = s_q5 * z375;
    const Scalar z377 = z345 + z376;
    const Scalar z378 = z308 - z376;
    const Scalar z379 = c_q5 * z375 - z346;
    const Scalar z380 = n512_over_55 * z309 + z377;
    const Scalar z381 = z309 + n256_over_55 * z351 - z352;
    const Scalar z382 = z350 + z379;
    const Scalar z383 = z349 + n2 * z351;
    const Scalar z384 = n512_over_55 * z309 + n2 * z351 + z378;
    const Scalar z385 = k28 + z351;
    const Scalar z386 = k29 + z309;
    const Scalar z387 = k30 + z380;
    const Scalar z388 = k31 + z381;
    const Scalar z389 = k32 + z382;
    const Scalar z390 = k33 + z356;
    const Scalar z391 = k34 + z384;
    const Scalar z392 = s_q4 * z385 - c_q4 * z386;
    const Scalar z393 = s_q4 * z386 + c_q4 * z385;
    const Scalar z394 = s_q4 * z390 + c_q4 * z389;
    const Scalar z395 = s_q4 * z389 - c_q4 * z390;
    const Scalar z396 = z391 - z393;
    const Scalar z397 = c_q3 * z392;
    const Scalar z398 = s_q3 * z392;
    const Scalar z399 = s_q3 * z396 + c_q3 * z394;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z406 = s_q2 * z401 + c_q2 * z395;
    const Scalar z407 = z383 - z387;
    const Scalar z408 = n2 * z388;
    const Scalar z409 = s_q4 * z407 - c_q4 * z408;
    const Scalar z410 = s_q4 * z409;
    const Scalar z411 = z387 + z410;
    const Scalar z412 = z383 - z410;
    const Scalar z413 = c_q4 * z409 + z388;
    const Scalar z414 = z350 - z394;
    const Scalar z415 = z392 - z413;
    const Scalar z416 = z391 - n2 * z393;
    const Scalar z417 = n2 * z393 - z412;
    const Scalar z418 = k35 - z393;
    const Scalar z419 = k36 - z350;
    const Scalar z420 = k37 + z411;
    const Scalar z421 = k38 - z414;
    const Scalar z422 = k39 - z415;
    const Scalar z423 = k40 + z395;
    const Scalar z424 = k41 - z417;
    const Scalar z425 = s_q3 * z418 + c_q3 * z419;
    const Scalar z426 = s_q3 * z419 - c_q3 * z418;
    const Scalar z427 = s_q3 * z423 - c_q3 * z422;
    const Scalar z428 = s_q3 * z422 + c_q3 * z423;
    const Scalar z429 = n632_over_165 * z426 + z427;
    const Scalar z430 = n632_over_165 * z425 + z428;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z435 = z416 - z420;
    const Scalar z436 = n2 * z421;
    const Scalar z437 = s_q3 * z435 + c_q3 * z436;
    const Scalar z438 = s_q3 * z437;
    const Scalar z439 = z420 + z438;
    const Scalar z440 = z416 - z438;
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z442 = k42 * z392 - z439;
    const Scalar z443 = k42 * z392 - z440;
    const Scalar z446 = k43 - z442;
    const Scalar z447 = k44 + z429;
    const Scalar z448 = k45 - z441;
    const Scalar z449 = k46 + z430;
    const Scalar z450 = k47 - z443;
    const Scalar z454 = s_q2 * z448 + c_q2 * z449;
    const Scalar z455 = z424 - z446;
    const Scalar z456 = n2 * z447;
    const Scalar z457 = s_q2 * z455 + c_q2 * z456;
    const Scalar z458 = s_q2 * z457;
    const Scalar z460 = z424 - z458;
    const Scalar z468 = k48 + z460;
    const Scalar z476 = k49 * s_q2;
    const Scalar z477 = k49 * c_q2;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z480 = z39 * z40;
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z482 = z39 * z39;
    const Scalar z483 = z481 + z482;
    const Scalar z484 = n2 * z478;
    const Scalar z485 = c_q3 * z478;
    const Scalar z486 = s_q3 * z478;
    const Scalar z487 = z476 + n632_over_165 * z480;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z489 = n632_over_165 * z484;
    const Scalar z490 = s_q3 * z489 - c_q3 * z487;
    const Scalar z491 = s_q3 * z487 + c_q3 * z489;
    const Scalar z492 = v_q3 * z56 - z485;  // angular acceleration of link3, x
    const Scalar z493 = v_q3 * z55 - z486;  // angular acceleration of link3, y
    const Scalar z494 = z56 * z56;
    const Scalar z495 = z57 * z57;
    const Scalar z496 = z494 + z495;
    const Scalar z497 = z55 * z56;
    const Scalar z499 = z55 * z57;
    const Scalar z500 = z493 + z499;
    const Scalar z503 = z490 - z496;
    const Scalar z505 = z488 + z500;
    const Scalar z506 = s_q4 * z505 + c_q4 * z503;
    const Scalar z507 = s_q4 * z503 - c_q4 * z505;
    const Scalar z510 = z79 * z79;
    const Scalar z511 = z80 * z80;
    const Scalar z512 = z510 + z511;
    const Scalar z513 = z78 * z79;
    const Scalar z516 = z78 * z78;
    const Scalar z517 = z511 + z516;
    const Scalar z518 = z78 * z80;
    const Scalar z520 = z79 * z80;
    const Scalar z537 = z118 * z118;
    const Scalar z538 = z119 * z119;
    const Scalar z539 = z537 + z538;
    const Scalar z540 = z117 * z118;
    const Scalar z542 = z117 * z119;
    const Scalar z553 = z138 * z138;
    const Scalar z554 = z139 * z139;
    const Scalar z555 = z553 + z554;
    const Scalar z556 = z137 * z138;
    const Scalar z559 = z137 * z137;
    const Scalar z560 = z554 + z559;
    const Scalar z561 = z137 * z139;
    const Scalar z563 = z138 * z139;
    const Scalar z565 = z553 - z554;
    const Scalar z566 = z554 - z559;
    const Scalar z569 = z553 - z559;
    const Scalar z581 = z117 * z117;
    const Scalar z582 = z538 + z581;
    const Scalar z583 = z118 * z119;
    const Scalar z585 = z537 - z538;
    const Scalar z586 = z538 - z581;
    const Scalar z589 = z537 - z581;
    const Scalar z600 = z103 * z103;
    const Scalar z601 = z104 * z104;
    const Scalar z602 = z600 + z601;
    const Scalar z603 = z102 * z103;
    const Scalar z606 = z102 * z102;
    const Scalar z607 = z601 + z606;
    const Scalar z608 = z102 * z104;
    const Scalar z610 = z103 * z104;
    const Scalar z612 = z600 - z601;
    const Scalar z613 = z601 - z606;
    const Scalar z616 = z600 - z606;
    const Scalar z627 = z510 - z511;
    const Scalar z628 = z511 - z516;
    const Scalar z631 = z510 - z516;
    const Scalar z643 = z55 * z55;
    const Scalar z644 = z495 + z643;
    const Scalar z645 = z56 * z57;
    const Scalar z646 = z492 + z645;
    const Scalar z647 = z494 - z495;
    const Scalar z648 = z495 - z643;
    const Scalar z649 = z492 - z645;
    const Scalar z650 = z493 - z499;
    const Scalar z651 = z494 - z643;
    const Scalar z662 = z40 * z40;
    const Scalar z664 = n2 * z479;
    const Scalar z665 = z481 - z662;
    const Scalar z666 = z481 - z482;
    const Scalar z667 = z482 - z662;
    const Scalar z1165 = c_q4 * z492;
    const Scalar z1166 = s_q4 * z492;
    const Scalar z1167 = z491 + z497;
    const Scalar z1168 = v_q4 * z79 - z1165;  // angular acceleration of link4, x
    const Scalar z1169 = v_q4 * z78 + z1166;  // angular acceleration of link4, y
    const Scalar z1170 = z518 + z1169;
    const Scalar z1171 = z520 + z1168;
    const Scalar z1172 = c_q5 * z1168;
    const Scalar z1173 = s_q5 * z1168;
    const Scalar z1174 = z506 + z512 - n256_over_55 * z513;
    const Scalar z1175 = z507 - z513 + n256_over_55 * z517;
    const Scalar z1176 = z1167 + z1170 + n256_over_55 * z1171;
    const Scalar z1177 = s_q5 * z1176 + c_q5 * z1174;
    const Scalar z1178 = s_q5 * z1174 - c_q5 * z1176;
    const Scalar z1179 = v_q5 * z103 + z1172;  // angular acceleration of link5, x
    const Scalar z1180 = v_q5 * z102 + z1173;  // angular acceleration of link5, y
    const Scalar z1181 = c_q6 * z1179;
    const Scalar z1182 = s_q6 * z1179;
    const Scalar z1183 = s_q6 * z1175 - c_q6 * z1177;
    const Scalar z1184 = s_q6 * z1177 + c_q6 * z1175;
    const Scalar z1185 = v_q6 * z118 - z1181;  // angular acceleration of link6, x
    const Scalar z1186 = v_q6 * z117 - z1182;  // angular acceleration of link6, y
    const Scalar z1187 = z542 + z1186;
    const Scalar z1188 = c_q7 * z1185;
    const Scalar z1189 = s_q7 * z1185;
    const Scalar z1190 = n16_over_15 * z539 + z1183;
    const Scalar z1191 = n16_over_15 * z540 - z1184;
    const Scalar z1192 = z1178 + n16_over_15 * z1187;
    const Scalar z1193 = s_q7 * z1192 - c_q7 * z1190;
    const Scalar z1194 = s_q7 * z1190 + c_q7 * z1192;
    const Scalar z1195 = v_q7 * z138 - z1188;  // angular acceleration of link7, x
    const Scalar z1196 = v_q7 * z137 + z1189;  // angular acceleration of link7, y
    const Scalar z1197 = z561 + z1196;
    const Scalar z1198 = z563 + z1195;
    const Scalar z1199 = z563 - z1195;
    const Scalar z1200 = z561 - z1196;
    const Scalar z1201 = k0 * z555 - k1 * z556;
    const Scalar z1202 = k0 * z556 - k1 * z560;
    const Scalar z1203 = k0 * z1197 + k1 * z1198;
    const Scalar z1204 = k3 * z556 - k2 * z565 + k1 * z1191 + k10 * z1197 - k50 * z1198;
    const Scalar z1205 = k2 * z556 + k3 * z566 - k0 * z1191 + k51 * z1197 - k10 * z1198;
    const Scalar z1206 = k8 * z556 + k10 * z569 + k1 * z1193 + k0 * z1194 - k3 * z1199 - k2 * z1200;
    const Scalar z1207 = u_tau7 - z1206;
    const Scalar z1217 = z583 + z1185;
    const Scalar z1218 = z583 - z1185;
    const Scalar z1219 = z542 - z1186;
    const Scalar z1221 = k12 * z540 + k18 * z582 - z1203;
    const Scalar z1237 = z608 + z1180;
    const Scalar z1238 = z610 + z1179;
    const Scalar z1239 = z610 - z1179;
    const Scalar z1240 = z608 - z1180;
    const Scalar z1258 = z520 - z1168;
    const Scalar z1259 = z518 - z1169;
    const Scalar z1375 = k52 * z295;
    const Scalar z1376 = k52 * z291;
    const Scalar z1377 = k52 * z285;
    const Scalar z1378 = k52 * z279;
    const Scalar z1379 = k52 * z272;
    const Scalar z1380 = k52 * z267;
    const Scalar z1381 = z295 * z1375 - z468;
    const Scalar z1382 = z295 * z1376 + z454;
    const Scalar z1383 = z291 * z1376 - z450;
    const Scalar z1384 = z295 * z1377 - z434;
    const Scalar z1385 = z291 * z1377 - z430;
    const Scalar z1386 = z285 * z1377 - z424;
    const Scalar z1387 = z295 * z1378 - z406;
    const Scalar z1388 = z291 * z1378 - z402;
    const Scalar z1389 = z285 * z1378 + z395;
    const Scalar z1390 = z279 * z1378 - z391;
    const Scalar z1391 = z295 * z1379 - z372;
    const Scalar z1392 = z291 * z1379 - z368;
    const Scalar z1393 = z285 * z1379 - z362;
    const Scalar z1394 = z279 * z1379 + z356;
    const Scalar z1395 = z272 * z1379 - z349;
    const Scalar z1396 = z295 * z1380 - z335;
    const Scalar z1397 = z291 * z1380 + z331;
    const Scalar z1398 = z285 * z1380 + z325;
    const Scalar z1399 = z279 * z1380 - z319;
    const Scalar z1400 = z272 * z1380 - z312;
    const Scalar z1401 = z267 * z1380 - z308;
    const Scalar z1402 = n1 / z1401;
    const Scalar z1403 = z1396 * z1402;
    const Scalar z1404 = z1397 * z1402;
    const Scalar z1405 = z1398 * z1402;
    const Scalar z1406 = z1399 * z1402;
    const Scalar z1407 = z1400 * z1402;
    const Scalar z1408 = z1381 - z1396 * z1403;
    const Scalar z1409 = z1382 - z1396 * z1404;
    const Scalar z1410 = z1383 - z1397 * z1404;
    const Scalar z1411 = z1384 - z1396 * z1405;
    const Scalar z1412 = z1385 - z1397 * z1405;
    const Scalar z1413 = z1386 - z1398 * z1405;
    const Scalar z1414 = z1387 - z1396 * z1406;
    const Scalar z1415 = z1388 - z1397 * z1406;
    const Scalar z1416 = z1389 - z1398 * z1406;
    const Scalar z1417 = z1390 - z1399 * z1406;
    const Scalar z1418 = z1391 - z1396 * z1407;
    const Scalar z1419 = z1392 - z1397 * z1407;
    const Scalar z1420 = z1393 - z1398 * z1407;
    const Scalar z1421 = z1394 - z1399 * z1407;
    const Scalar z1422 = z1395 - z1400 * z1407;
    const Scalar z1423 = n1 / z1422;
    const Scalar z1424 = z1418 * z1423;
    const Scalar z1425 = z1419 * z1423;
    const Scalar z1426 = z1420 * z1423;
    const Scalar z1427 = z1421 * z1423;
    const Scalar z1428 = z1408 - z1418 * z1424;
    const Scalar z1429 = z1409 - z1418 * z1425;
    const Scalar z1430 = z1410 - z1419 * z1425;
    const Scalar z1431 = z1411 - z1418 * z1426;
    const Scalar z1432 = z1412 - z1419 * z1426;
    const Scalar z1433 = z1413 - z1420 * z1426;
    const Scalar z1434 = z1414 - z1418 * z1427;
    const Scalar z1435 = z1415 - z1419 * z1427;
    const Scalar z1436 = z1416 - z1420 * z1427;
    const Scalar z1437 = z1417 - z1421 * z1427;
    const Scalar z1438 = n1 / z1437;
    const Scalar z1439 = z1434 * z1438;
    const Scalar z1440 = z1435 * z1438;
    const Scalar z1441 = z1436 * z1438;
    const Scalar z1442 = z1428 - z1434 * z1439;
    const Scalar z1443 = z1429 - z1434 * z1440;
    const Scalar z1444 = z1430 - z1435 * z1440;
    const Scalar z1445 = z1431 - z1434 * z1441;
    const Scalar z1446 = z1432 - z1435 * z1441;
    const Scalar z1447 = z1433 - z1436 * z1441;
    const Scalar z1448 = n1 / z1447;
    const Scalar z1449 = z1445 * z1448;
    const Scalar z1450 = z1446 * z1448;
    const Scalar z1451 = z1442 - z1445 * z1449;
    const Scalar z1452 = z1443 - z1445 * z1450;
    const Scalar z1453 = z1444 - z1446 * z1450;
    const Scalar z1454 = n1 / z1453;
    const Scalar z1455 = z1452 * z1454;
    const Scalar z1456 = z1451 - z1452 * z1455;
    const Scalar z1457 = n1 / z1456;
    const Scalar z1471 = s_q7 * z1202 - c_q7 * z1201;
    const Scalar z1472 = s_q7 * z1201 + c_q7 * z1202;
    const Scalar z1473 = s_q7 * z1205 + c_q7 * z1204;
    const Scalar z1474 = s_q7 * z1204 - c_q7 * z1205;
    const Scalar z1475 = k12 * z539 + k18 * z540 - z1471;  // force on link6, times 0.0825 m, x
    const Scalar z1476 = k12 * z1187 - k18 * z1217 - z1472;  // force on link6, times 0.0825 m, z
    // moment on link6, x
    const Scalar z1477 = k15 * z540 - k16 * z585 + k18 * z1178 + k14 * z1187 - k54 * z1217 - z1473;
    // moment on link6, y
    const Scalar z1478 = k16 * z540 + k15 * z586 + k12 * z1178 + k55 * z1187 + z1206 - k14 * z1217 - n16_over_15
        * z1472;
    // moment on link6, z
    const Scalar z1479 = k56 * z540 - k14 * z589 - k18 * z1183 - k12 * z1184 - n16_over_15 * z1203 + k15 * z1218 + k16
        * z1219 + z1474;
    const Scalar z1480 = s_q6 * z1221 + c_q6 * z1475;
    const Scalar z1481 = s_q6 * z1475 - c_q6 * z1221;
    const Scalar z1482 = s_q6 * z1478 - c_q6 * z1477;
    const Scalar z1483 = s_q6 * z1477 + c_q6 * z1478;
    const Scalar z1484 = k20 * z602 + k21 * z603 - z1480;  // force on link5, times 0.0825 m, x
    const Scalar z1485 = k20 * z603 + k21 * z607 + z1476;  // force on link5, times 0.0825 m, y
    const Scalar z1486 = k20 * z1237 - k21 * z1238 - z1481;  // force on link5, times 0.0825 m, z
    // moment on link5, x
    const Scalar z1487 = k24 * z603 - k25 * z612 + k21 * z1175 + k23 * z1237 + k57 * z1238 - z1482;
    // moment on link5, y
    const Scalar z1488 = k25 * z603 + k24 * z613 + k20 * z1175 - k58 * z1237 - k23 * z1238 + z1479;
    // moment on link5, z
    const Scalar z1489 = k59 * z603 - k23 * z616 + k21 * z1177 - k20 * z1178 + k24 * z1239 + k25 * z1240 + z1483;
    const Scalar z1490 = s_q5 * z1485 + c_q5 * z1484;
    const Scalar z1491 = s_q5 * z1484 - c_q5 * z1485;
    const Scalar z1492 = s_q5 * z1488 - c_q5 * z1487;
    const Scalar z1493 = s_q5 * z1487 + c_q5 * z1488;
    const Scalar z1494 = k28 * z512 - k29 * z513 + z1490;  // force on link4, times 0.0825 m, x
    const Scalar z1495 = k28 * z513 - k29 * z517 + z1486;  // force on link4, times 0.0825 m, y
    const Scalar z1496 = k28 * z1170 + k29 * z1171 + z1491;  // force on link4, times 0.0825 m, z
    // moment on link4, x
    const Scalar z1497 = k32 * z513 + k33 * z627 + k29 * z1167 + k31 * z1170 + k60 * z1171 + n256_over_55 * z1491
        - z1492;
    // moment on link4, y
    const Scalar z1498 = k33 * z513 - k32 * z628 + k28 * z1167 + k61 * z1170 + k31 * z1171 + z1489 + z1491;
    // moment on link4, z
    const Scalar z1499 = k29 * z506 - k28 * z507 - k62 * z513 + k31 * z631 - k32 * z1258 + k33 * z1259 + z1486
        + n256_over_55 * z1490 - z1493;
    const Scalar z1500 = s_q4 * z1495 - c_q4 * z1494;
    const Scalar z1501 = s_q4 * z1494 + c_q4 * z1495;
    const Scalar z1502 = s_q4 * z1498 - c_q4 * z1497;
    const Scalar z1503 = s_q4 * z1497 + c_q4 * z1498;
    const Scalar z1504 = k35 * z496 - k36 * z497 + z1500;  // force on link3, times 0.0825 m, x
    const Scalar z1505 = k35 * z497 - k36 * z644 + z1496;  // force on link3, times 0.0825 m, y
    const Scalar z1507 = k36 * z488 - k39 * z497 + k38 * z500 + k63 * z646 - k40 * z647 + z1502;  // moment on link3, x
    // moment on link3, y
    const Scalar z1508 = k35 * z488 - k40 * z497 + k64 * z500 + k38 * z646 + k39 * z648 - z1499 + z1501;
    // moment on link3, z
    const Scalar z1509 = k36 * z490 - k35 * z491 - k65 * z497 + k39 * z649 - k40 * z650 - k38 * z651 - z1496 + z1503;
    const Scalar z1510 = s_q3 * z1505 + c_q3 * z1504;
    const Scalar z1511 = s_q3 * z1504 - c_q3 * z1505;
    const Scalar z1512 = s_q3 * z1508 + c_q3 * z1507;
    const Scalar z1513 = s_q3 * z1507 - c_q3 * z1508;
    // moment on link2, x
    const Scalar z1517 = k45 * z480 - k66 * z484 - k44 * z664 - k46 * z665 + n632_over_165 * z1511 + z1512;
    const Scalar z1518 = k46 * z480 - k44 * z484 - k67 * z664 - k45 * z666 - z1509;  // moment on link2, y
    // moment on link2, z
    const Scalar z1519 = k68 * z476 - k69 * z477 + k70 * z480 + k44 * z667 + n632_over_165 * z1510 - z1513;
    const Scalar z1523 = s_q2 * z1517 - c_q2 * z1518;
    const Scalar z1528 = u_tau1 + z1523;
    const Scalar z1529 = u_tau2 + z1519;
    const Scalar z1530 = u_tau3 + z1509;
    const Scalar z1531 = u_tau4 + z1499;
    const Scalar z1532 = u_tau5 + z1489;
    const Scalar z1533 = u_tau6 - z1479;
    const Scalar z1534 = z1207 * z1380 + z1533;
    const Scalar z1535 = z1207 * z1379 - z1407 * z1534 - z1532;
    const Scalar z1536 = z1207 * z1378 - z1406 * z1534 - z1427 * z1535 - z1531;
    const Scalar z1537 = z1207 * z1377 - z1405 * z1534 - z1426 * z1535 - z1441 * z1536 + z1530;
    const Scalar z1538 = z1207 * z1376 - z1404 * z1534 - z1425 * z1535 - z1440 * z1536 - z1450 * z1537 - z1529;
    const Scalar z1539 = z1207 * z1375 - z1403 * z1534 - z1424 * z1535 - z1439 * z1536 - z1449 * z1537 - z1455 * z1538
        - z1528;
    const Scalar z1540 = z1457 * z1539;
    const Scalar z1541 = z1454 * z1538 - z1455 * z1540;
    const Scalar z1542 = z1448 * z1537 - z1449 * z1540 - z1450 * z1541;
    const Scalar z1543 = z1438 * z1536 - z1439 * z1540 - z1440 * z1541 - z1441 * z1542;
    const Scalar z1544 = z1423 * z1535 - z1424 * z1540 - z1425 * z1541 - z1426 * z1542 - z1427 * z1543;
    const Scalar z1545 = z1402 * z1534 - z1403 * z1540 - z1404 * z1541 - z1405 * z1542 - z1406 * z1543 - z1407 * z1544;
    const Scalar z1546 = k52 * z1207 - z1375 * z1540 - z1376 * z1541 - z1377 * z1542 - z1378 * z1543 - z1379 * z1544
        - z1380 * z1545;
    const Scalar z1547 = z479 - z1542;
    const Scalar z1548 = z493 - z1543;
    const Scalar z1549 = z1169 + z1544;
    const Scalar z1550 = z1180 - z1545;
    const Scalar z1551 = z1186 - z1546;
    accelerations.q1 = z1540;
    accelerations.q2 = z1541;
    accelerations.q3 = z1547;
    accelerations.q4 = -z1548;
    accelerations.q5 = z1549;
    accelerations.q6 = z1550;
    accelerations.q7 = -z1551;
    if (!(traits::regular(-z1456, z468) && traits::regular(-z1453, z450) && traits::regular(-z1447, z424)
        && traits::regular(-z1437, z391) && traits::regular(-z1422, z349) && traits::regular(-z1401,
        z308))) return torsor::Status::singular;
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
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k5 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k6 = traits::constant(0.00850351162402155, 0.008503512f, "170070232480431/20000000000000000");
    const Scalar k7 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k8 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k9 = traits::constant(0.028124284712194955, 0.028124284f, "7031071178048739/250000000000000000");
    const Scalar k10 = traits::constant(0.026534991901690206, 0.026534991f, "13267495950845103/500000000000000000");
    const Scalar k11 = traits::constant(0.214708623208, 0.21470863f, "26838577901/125000000000");
    const Scalar k12 = traits::constant(0.126729164208, 0.12672916f, "7920572763/62500000000");
    const Scalar k13 = traits::constant(3.228604, 3.228604f, "807151/250000");
    const Scalar k14 = traits::constant(0.088844724872, 0.088844724f, "11105590609/125000000000");
    const Scalar k15 = traits::constant(0.05649492601407083, 0.056494925f, "3530932875879427/62500000000000000");
    const Scalar k16 = traits::constant(0.008248333140675744, 0.008248333f, "257760410646117/31250000000000000");
    const Scalar k17 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k18 = traits::constant(0.052878381999606115, 0.052878384f, "1652449437487691/31250000000000000");
    const Scalar k19 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k20 = traits::constant(0.01824920229252011, 0.018249203f, "1140575143282507/62500000000000000");
    const Scalar k21 = traits::constant(0.09850206933, 0.09850207f, "9850206933/100000000000");
    const Scalar k22 = traits::constant(0.374644408005, 0.3746444f, "74928881601/200000000000");
    const Scalar k23 = traits::constant(3.587895, 3.587895f, "717579/200000");
    const Scalar k24 = traits::constant(0.19076837715, 0.19076838f, "3815367543/20000000000");
    const Scalar k25 = traits::constant(0.06767727025085991, 0.06767727f, "13535454050171983/200000000000000000");
    const Scalar k26 = traits::constant(0.02771584317362585, 0.027715843f, "554316863472517/20000000000000000");
    const Scalar k27 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k28 = traits::constant(0.03239943042445132, 0.03239943f, "809985760611283/25000000000000000");
    const Scalar k29 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k30 = traits::constant(0.07758614905253959, 0.07758615f, "15517229810507919/200000000000000000");
    const Scalar k31 = traits::constant(0.047121686402, 0.047121685f, "23560843201/500000000000");
    const Scalar k32 = traits::constant(0.05034347249, 0.050343473f, "5034347249/100000000000");
    const Scalar k33 = traits::constant(1.225946, 1.225946f, "612973/500000");
    const Scalar k34 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k35 = traits::constant(0.03942757095803552, 0.03942757f, "9856892739508881/250000000000000000");
    const Scalar k36 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k37 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k38 = traits::constant(0.03146037232526039, 0.03146037f, "7865093081315097/250000000000000000");
    const Scalar k39 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k40 = traits::constant(0.010869510762828565, 0.0108695105f, "2717377690707141/250000000000000000");
    const Scalar k41 = traits::constant(0.017527158935, 0.01752716f, "3505431787/200000000000");
    const Scalar k42 = traits::constant(0.023526756935, 0.023526756f, "4705351387/200000000000");
    const Scalar k43 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k44 = traits::constant(0.100241616695, 0.10024162f, "20048323339/200000000000");
    const Scalar k45 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k46 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k47 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k48 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k49 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k50 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
    const Scalar k51 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k52 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k53 = traits::constant(0.735522, 0.735522f, "367761/500000");
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z51 = n0_316 * c_q2;
    const Scalar z52 = n0_333 + z51;  // place of link3, z
    const Scalar z53 = n0_316 * v_q2;
    const Scalar z54 = n0_316 * z39;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z77 = n0_0825 * z56;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = s_q5 * z78 + c_q5 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z1552 = s_q3 * z54 + c_q3 * z53;
    const Scalar z1553 = s_q3 * z53 - c_q3 * z54;
    const Scalar z1554 = n0_0825 * z57 - z1553;
    const Scalar z1555 = s_q4 * z77 - c_q4 * z1552;
    const Scalar z1556 = s_q4 * z1552 + c_q4 * z77;
    const Scalar z1557 = n0_384 * z80 + z1555;
    const Scalar z1558 = n0_0825 * z80 + z1556;
    const Scalar z1559 = n0_384 * z78 - n0_0825 * z79 - z1554;
    const Scalar z1560 = s_q5 * z1559 + c_q5 * z1557;
    const Scalar z1561 = s_q5 * z1557 - c_q5 * z1559;
    const Scalar z1562 = s_q6 * z1558 + c_q6 * z1560;
    const Scalar z1563 = s_q6 * z1560 - c_q6 * z1558;
    const Scalar z1564 = n0_088 * z119 + z1563;
    const Scalar z1565 = n0_088 * z118 + z1561;
    const Scalar z1566 = s_q7 * z1565 + c_q7 * z1562;
    const Scalar z1567 = s_q7 * z1562 - c_q7 * z1565;
    const Scalar z1568 = k5 * v_q2 - k6 * z39 + k7 * z40;
    const Scalar z1569 = k8 * v_q2 + k7 * z39 - k9 * z40;
    const Scalar z1570 = k10 * v_q2 - k5 * z39 - k8 * z40;
    const Scalar z1571 = k11 * z56 + k12 * z57 - k13 * z1552;
    const Scalar z1572 = k11 * z55 + k14 * z57 - k13 * z1553;
    const Scalar z1573 = k15 * z55 - k16 * z56 - k17 * z57 - k11 * z1553;
    const Scalar z1574 = k16 * z55 - k18 * z56 + k19 * z57 + k11 * z1552;
    const Scalar z1575 = k17 * z55 + k19 * z56 - k20 * z57 + k12 * z1552 + k14 * z1553;
    const Scalar z1576 = k21 * z79 + k22 * z80 + k23 * z1555;
    const Scalar z1577 = k21 * z78 + k24 * z80 + k23 * z1556;
    const Scalar z1578 = k22 * z78 - k24 * z79 - k23 * z1554;
    const Scalar z1579 = k25 * z78 - k26 * z79 + k27 * z80 - k22 * z1554 + k21 * z1556;
    const Scalar z1580 = k26 * z78 - k28 * z79 - k29 * z80 - k24 * z1554 - k21 * z1555;
    const Scalar z1581 = k27 * z78 + k29 * z79 + k30 * z80 + k22 * z1555 + k24 * z1556;
    const Scalar z1582 = k31 * z103 - k32 * z104 - k33 * z1560;
    const Scalar z1583 = k31 * z102 + k34 * z104 - k33 * z1561;
    const Scalar z1584 = k32 * z102 + k34 * z103 + k33 * z1558;
    const Scalar z1585 = k35 * z102 - k36 * z103 + k37 * z104 + k32 * z1558 - k31 * z1561;
    const Scalar z1586 = k36 * z102 - k38 * z103 + k39 * z104 - k34 * z1558 + k31 * z1560;
    const Scalar z1587 = k37 * z102 - k39 * z103 + k40 * z104 + k32 * z1560 - k34 * z1561;
    const Scalar z1588 = k41 * z118 - k42 * z119 + k43 * z1562;
    const Scalar z1589 = k41 * z117 + k44 * z119 + k43 * z1563;
    const Scalar z1590 = k42 * z117 + k44 * z118 + k43 * z1561;
    const Scalar z1591 = k45 * z117 + k46 * z118 - k47 * z119 + k42 * z1561 + k41 * z1563;
    const Scalar z1592 = k46 * z117 + k48 * z118 + k49 * z119 + k44 * z1561 + k41 * z1562;
    const Scalar z1593 = k47 * z117 - k49 * z118 - k50 * z119 + k42 * z1562 - k44 * z1563;
    const Scalar z1594 = k51 * z138 - k52 * z139 + k53 * z1566;
    const Scalar z1595 = k51 * z137 - k54 * z139 - k53 * z1567;
    const Scalar z1596 = k52 * z137 - k54 * z138 + k53 * z1564;
    const Scalar z1597 = k55 * z137 + k56 * z138 - k57 * z139 + k52 * z1564 - k51 * z1567;
    const Scalar z1598 = k56 * z137 + k58 * z138 + k59 * z139 - k54 * z1564 + k51 * z1566;
    const Scalar z1599 = k57 * z137 - k59 * z138 - k60 * z139 + k52 * z1566 - k54 * z1567;
    const Scalar z1603 = k61 * s_q2 + k62 * c_q2;
    const Scalar z1609 = k12 * s_q3 - k14 * c_q3;
    const Scalar z1612 = s_q2 * z1609 - k11 * c_q2;
    const Scalar z1615 = n0_0825 * c_q3;
    const Scalar z1618 = s_q2 * z1615 - n0_316 * c_q2;
    const Scalar z1621 = n0_333 - z1618;
    const Scalar z1622 = k22 * s_q4 + k24 * c_q4;
    const Scalar z1623 = k24 * s_q4 - k22 * c_q4;
    const Scalar z1624 = k21 * s_q3 - c_q3 * z1622;
    const Scalar z1627 = s_q2 * z1624 + c_q2 * z1623;
    const Scalar z1630 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z1631 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z1632 = n0_0825 - z1630;
    const Scalar z1633 = c_q3 * z1632;
    const Scalar z1635 = n0_316 - z1631;
    const Scalar z1637 = s_q2 * z1633 - c_q2 * z1635;
    const Scalar z1640 = n0_333 - z1637;
    const Scalar z1641 = k32 * s_q5 + k34 * c_q5;
    const Scalar z1642 = k34 * s_q5 - k32 * c_q5;
    const Scalar z1643 = k31 * s_q4 - c_q4 * z1641;
    const Scalar z1644 = s_q4 * z1641 + k31 * c_q4;
    const Scalar z1645 = s_q3 * z1642 + c_q3 * z1643;
    const Scalar z1648 = s_q2 * z1645 + c_q2 * z1644;
    const Scalar z1651 = k42 * s_q6 + k44 * c_q6;
    const Scalar z1652 = k44 * s_q6 - k42 * c_q6;
    const Scalar z1653 = k41 * s_q5 - c_q5 * z1651;
    const Scalar z1654 = s_q5 * z1651 + k41 * c_q5;
    const Scalar z1655 = s_q4 * z1652 + c_q4 * z1653;
    const Scalar z1656 = s_q4 * z1653 - c_q4 * z1652;
    const Scalar z1657 = s_q3 * z1654 + c_q3 * z1655;
    const Scalar z1660 = s_q2 * z1657 - c_q2 * z1656;
    const Scalar z1663 = n0_088 * c_q6;
    const Scalar z1664 = n0_088 * s_q6;
    const Scalar z1665 = c_q5 * z1663;
    const Scalar z1666 = s_q5 * z1663;
    const Scalar z1667 = n0_0825 - z1665;
    const Scalar z1668 = n0_384 + z1664;
    const Scalar z1669 = s_q4 * z1668 + c_q4 * z1667;
    const Scalar z1670 = s_q4 * z1667 - c_q4 * z1668;
    const Scalar z1671 = n0_0825 - z1669;
    const Scalar z1672 = s_q3 * z1666 - c_q3 * z1671;
    const Scalar z1674 = n0_316 - z1670;
    const Scalar z1676 = s_q2 * z1672 + c_q2 * z1674;
    const Scalar z1679 = n0_333 + z1676;
    const Scalar z1680 = k52 * s_q7 + k54 * c_q7;
    const Scalar z1681 = k54 * s_q7 - k52 * c_q7;
    const Scalar z1682 = k51 * s_q6 + c_q6 * z1680;
    const Scalar z1683 = s_q6 * z1680 - k51 * c_q6;
    const Scalar z1684 = s_q5 * z1681 + c_q5 * z1682;
    const Scalar z1685 = s_q5 * z1682 - c_q5 * z1681;
    const Scalar z1686 = s_q4 * z1683 - c_q4 * z1684;
    const Scalar z1687 = s_q4 * z1684 + c_q4 * z1683;
    const Scalar z1688 = s_q3 * z1685 + c_q3 * z1686;
    const Scalar z1691 = s_q2 * z1688 + c_q2 * z1687;
    result.kinetic = n0_5 * (-z1561 * (z1583 - z1590) + v_q2 * z1570 - z39 * z1568 - z40 * z1569 + z55 * z1573 - z56
        * z1574 - z57 * z1575 + z78 * z1579 - z79 * z1580 + z80 * z1581 + z102 * z1585 - z103 * z1586 + z104 * z1587
        + z117 * z1591 + z118 * z1592 - z119 * z1593 + z137 * z1597 + z138 * z1598 - z139 * z1599 - z1552 * z1571
        - z1553 * z1572 - z1554 * z1578 + z1555 * z1576 + z1556 * z1577 + z1558 * z1584 - z1560 * z1582 + z1562 * z1588
        + z1563 * z1589 + z1564 * z1596 + z1566 * z1594 - z1567 * z1595) + k64 * v_q1 * v_q1;
    result.force_function = -n9_81 * (z1603 + z1612 - z1627 - z1648 + z1660 + z1691) - k66 - k67 * z52 - k68 * z1621
        - k69 * z1640 - k70 * z1679;
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
    const Scalar z39 = v_q1 * s_q2;
    const Scalar z40 = v_q1 * c_q2;
    const Scalar z55 = v_q2 * s_q3 - c_q3 * z39;
    const Scalar z56 = v_q2 * c_q3 + s_q3 * z39;
    const Scalar z57 = v_q3 + z40;
    const Scalar z78 = s_q4 * z57 + c_q4 * z55;
    const Scalar z79 = s_q4 * z55 - c_q4 * z57;
    const Scalar z80 = v_q4 - z56;
    const Scalar z102 = s_q5 * z80 - c_q5 * z78;
    const Scalar z103 = s_q5 * z78 + c_q5 * z80;
    const Scalar z104 = v_q5 - z79;
    const Scalar z117 = s_q6 * z104 - c_q6 * z102;
    const Scalar z118 = s_q6 * z102 + c_q6 * z104;
    const Scalar z119 = v_q6 + z103;
    const Scalar z137 = s_q7 * z119 + c_q7 * z117;
    const Scalar z138 = s_q7 * z117 - c_q7 * z119;
    const Scalar z139 = v_q7 - z118;
    const Scalar z264 = k0 * s_q7 - k1 * c_q7;
    const Scalar z265 = k1 * s_q7 + k0 * c_q7;
    const Scalar z266 = k2 * s_q7 - k3 * c_q7;
    const Scalar z267 = k3 * s_q7 + k2 * c_q7;
    const Scalar z268 = k4 + n16_over_15 * z265;
    const Scalar z269 = c_q6 * z264;
    const Scalar z270 = s_q6 * z264;
    const Scalar z271 = s_q6 * z268 + c_q6 * z266;
    const Scalar z272 = s_q6 * z266 - c_q6 * z268;
    const Scalar z273 = s_q5 * z265 - c_q5 * z269;
    const Scalar z274 = s_q5 * z269 + c_q5 * z265;
    const Scalar z275 = s_q5 * z267 - c_q5 * z271;
    const Scalar z276 = s_q5 * z271 + c_q5 * z267;
    const Scalar z277 = n256_over_55 * z274 - z275;
    const Scalar z278 = z272 + z274;
    const Scalar z279 = z270 - n256_over_55 * z273 - z276;
    const Scalar z280 = s_q4 * z270 + c_q4 * z273;
    const Scalar z281 = s_q4 * z273 - c_q4 * z270;
    const Scalar z282 = s_q4 * z278 - c_q4 * z277;
    const Scalar z283 = s_q4 * z277 + c_q4 * z278;
    const Scalar z284 = z279 + z281;
    const Scalar z285 = z274 - z283;
    const Scalar z286 = s_q3 * z274 + c_q3 * z280;
    const Scalar z287 = s_q3 * z280 - c_q3 * z274;
    const Scalar z288 = s_q3 * z284 - c_q3 * z282;
    const Scalar z289 = s_q3 * z282 + c_q3 * z284;
    const Scalar z290 = n632_over_165 * z287 - z288;
    const Scalar z291 = n632_over_165 * z286 - z289;
    const Scalar z295 = s_q2 * z290 - c_q2 * z285;
    const Scalar z296 = k8 * s_q7 - k9 * c_q7;
    const Scalar z297 = s_q7 * z296;
    const Scalar z298 = k8 - z297;
    const Scalar z299 = k10 + c_q7 * z296;
    const Scalar z300 = n16_over_15 * z264 - z299;
    const Scalar z301 = k4 + n32_over_15 * z265;
    const Scalar z302 = n32_over_15 * z265 + z297;
    const Scalar z303 = k12 + z265;
    const Scalar z304 = k13 - z298;
    const Scalar z305 = k14 - z266;
    const Scalar z306 = k15 + z300;
    const Scalar z307 = k16 + z267;
    const Scalar z308 = k17 + z302;
    const Scalar z309 = s_q6 * z303 - k18 * c_q6;
    const Scalar z310 = k18 * s_q6 + c_q6 * z303;
    const Scalar z311 = s_q6 * z307 + c_q6 * z306;
    const Scalar z312 = s_q6 * z306 - c_q6 * z307;
    const Scalar z313 = c_q5 * z309;
    const Scalar z314 = s_q5 * z309;
    const Scalar z315 = s_q5 * z308 - c_q5 * z311;
    const Scalar z316 = s_q5 * z311 + c_q5 * z308;
    const Scalar z317 = n256_over_55 * z314 + z315;
    const Scalar z318 = z312 - z314;
    const Scalar z319 = z310 - n256_over_55 * z313 - z316;
    const Scalar z320 = s_q4 * z310 + c_q4 * z313;
    const Scalar z321 = s_q4 * z313 - c_q4 * z310;
    const Scalar z322 = s_q4 * z318 + c_q4 * z317;
    const Scalar z323 = s_q4 * z317 - c_q4 * z318;
    const Scalar z324 = z319 + z321;
    const Scalar z325 = z314 - z323;
    const Scalar z326 = s_q3 * z314 - c_q3 * z320;
    const Scalar z327 = s_q3 * z320 + c_q3 * z314;
    const Scalar z328 = s_q3 * z324 - c_q3 * z322;
    const Scalar z329 = s_q3 * z322 + c_q3 * z324;
    const Scalar z330 = n632_over_165 * z327 - z328;
    const Scalar z331 = n632_over_165 * z326 + z329;
    const Scalar z335 = s_q2 * z330 + c_q2 * z325;
    const Scalar z336 = z301 + z304;
    const Scalar z337 = n2 * z305;
    const Scalar z338 = s_q6 * z336 - c_q6 * z337;
    const Scalar z339 = s_q6 * z338;
    const Scalar z340 = z304 - z339;
    const Scalar z341 = z301 - z339;
    const Scalar z342 = c_q6 * z338 + z305;
    const Scalar z343 = k20 - z310;
    const Scalar z344 = k21 - z264;
    const Scalar z345 = k22 - z340;
    const Scalar z346 = k23 - z311;
    const Scalar z347 = k24 + z342;
    const Scalar z348 = k25 + z312;
    const Scalar z349 = k26 + z341;
    const Scalar z350 = s_q5 * z343 - c_q5 * z344;
    const Scalar z351 = s_q5 * z344 + c_q5 * z343;
    const Scalar z352 = s_q5 * z348 + c_q5 * z347;
    const Scalar z353 = s_q5 * z347 - c_q5 * z348;
    const Scalar z354 = n256_over_55 * z351 - z352;
    const Scalar z355 = z349 + z351;
    const Scalar z356 = n256_over_55 * z350 - z353;
    const Scalar z357 = c_q4 * z350;
    const Scalar z358 = s_q4 * z350;
    const Scalar z359 = s_q4 * z355 - c_q4 * z354;
    const Scalar z360 = s_q4 * z354 + c_q4 * z355;
    const Scalar z361 = z356 - z358;
    const Scalar z362 = z351 - z360;
    const Scalar z363 = s_q3 * z351 + c_q3 * z357;
    const Scalar z364 = s_q3 * z357 - c_q3 * z351;
    const Scalar z365 = s_q3 * z361 + c_q3 * z359;
    const Scalar z366 = s_q3 * z359 - c_q3 * z361;
    const Scalar z367 = n632_over_165 * z364 + z365;
    const Scalar z368 = n632_over_165 * z363 - z366;
    const Scalar z372 = s_q2 * z367 - c_q2 * z362;
    const Scalar z373 = z308 - z345;
    const Scalar z374 = n2 * z346;
    const Scalar z375 = s_q5 * z373 + c_q5 * z374;
    const Scalar z376 = s_q5 * z375;
    const Scalar z377 = z345 + z376;
    const Scalar z378 = z308 - z376;
    const Scalar z379 = c_q5 * z375 - z346;
    const Scalar z380 = n512_over_55 * z309 + z377;
    const Scalar z381 = z309 + n256_over_55 * z351 - z352;
    const Scalar z382 = z350 + z379;
    const Scalar z383 = z349 + n2 * z351;
    const Scalar z384 = n512_over_55 * z309 + n2 * z351 + z378;
    const Scalar z385 = k28 + z351;
    const Scalar z386 = k29 + z309;
    const Scalar z387 = k30 + z380;
    const Scalar z388 = k31 + z381;
    const Scalar z389 = k32 + z382;
    const Scalar z390 = k33 + z356;
    const Scalar z391 = k34 + z384;
    const Scalar z392 = s_q4 * z385 - c_q4 * z386;
    const Scalar z393 = s_q4 * z386 + c_q4 * z385;
    const Scalar z394 = s_q4 * z390 + c_q4 * z389;
    const Scalar z395 = s_q4 * z389 - c_q4 * z390;
    const Scalar z396 = z391 - z393;
    const Scalar z397 = c_q3 * z392;
    const Scalar z398 = s_q3 * z392;
    const Scalar z399 = s_q3 * z396 + c_q3 * z394;
    const Scalar z400 = s_q3 * z394 - c_q3 * z396;
    const Scalar z401 = n632_over_165 * z398 - z399;
    const Scalar z402 = n632_over_165 * z397 + z400;
    const Scalar z406 = s_q2 * z401 + c_q2 * z395;
    const Scalar z407 = z383 - z387;
    const Scalar z408 = n2 * z388;
    const Scalar z409 = s_q4 * z407 - c_q4 * z408;
    const Scalar z410 = s_q4 * z409;
    const Scalar z411 = z387 + z410;
    const Scalar z412 = z383 - z410;
    const Scalar z413 = c_q4 * z409 + z388;
    const Scalar z414 = z350 - z394;
    const Scalar z415 = z392 - z413;
    const Scalar z416 = z391 - n2 * z393;
    const Scalar z417 = n2 * z393 - z412;
    const Scalar z418 = k35 - z393;
    const Scalar z419 = k36 - z350;
    const Scalar z420 = k37 + z411;
    const Scalar z421 = k38 - z414;
    const Scalar z422 = k39 - z415;
    const Scalar z423 = k40 + z395;
    const Scalar z424 = k41 - z417;
    const Scalar z425 = s_q3 * z418 + c_q3 * z419;
    const Scalar z426 = s_q3 * z419 - c_q3 * z418;
    const Scalar z427 = s_q3 * z423 - c_q3 * z422;
    const Scalar z428 = s_q3 * z422 + c_q3 * z423;
    const Scalar z429 = n632_over_165 * z426 + z427;
    const Scalar z430 = n632_over_165 * z425 + z428;
    const Scalar z434 = s_q2 * z429 - c_q2 * z424;
    const Scalar z435 = z416 - z420;
    const Scalar z436 = n2 * z421;
    const Scalar z437 = s_q3 * z435 + c_q3 * z436;
    const Scalar z438 = s_q3 * z437;
    const Scalar z439 = z420 + z438;
    const Scalar z440 = z416 - z438;
    const Scalar z441 = c_q3 * z437 - z421;
    const Scalar z442 = k42 * z392 - z439;
    const Scalar z443 = k42 * z392 - z440;
    const Scalar z444 = k43 + z426;
    const Scalar z445 = k44 - z392;
    const Scalar z446 = k45 - z442;
    const Scalar z447 = k46 + z429;
    const Scalar z448 = k47 - z441;
    const Scalar z449 = k48 + z430;
    const Scalar z450 = k49 - z443;
    const Scalar z454 = s_q2 * z448 + c_q2 * z449;
    const Scalar z455 = z424 - z446;
    const Scalar z456 = n2 * z447;
    const Scalar z457 = s_q2 * z455 + c_q2 * z456;
    const Scalar z458 = s_q2 * z457;
    const Scalar z460 = z424 - z458;
    const Scalar z468 = k50 + z460;
    const Scalar z476 = k51 * s_q2;
    const Scalar z477 = k51 * c_q2;
    const Scalar z478 = v_q2 * z40;  // angular acceleration of link2, x
    const Scalar z479 = v_q2 * z39;  // angular acceleration of link2, y
    const Scalar z480 = z39 * z40;
    const Scalar z481 = v_q2 * v_q2;
    const Scalar z482 = z39 * z39;
    const Scalar z483 = z481 + z482;
    const Scalar z488 = z477 - n632_over_165 * z483;
    const Scalar z494 = z56 * z56;
    const Scalar z495 = z57 * z57;
    const Scalar z496 = z494 + z495;
    const Scalar z497 = z55 * z56;
    const Scalar z499 = z55 * z57;
    const Scalar z510 = z79 * z79;
    const Scalar z511 = z80 * z80;
    const Scalar z512 = z510 + z511;
    const Scalar z513 = z78 * z79;
    const Scalar z516 = z78 * z78;
    const Scalar z517 = z511 + z516;
    const Scalar z518 = z78 * z80;
    const Scalar z520 = z79 * z80;
    const Scalar z537 = z118 * z118;
    const Scalar z538 = z119 * z119;
    const Scalar z539 = z537 + z538;
    const Scalar z540 = z117 * z118;
    const Scalar z542 = z117 * z119;
    const Scalar z553 = z138 * z138;
    const Scalar z554 = z139 * z139;
    const Scalar z555 = z553 + z554;
    const Scalar z556 = z137 * z138;
    const Scalar z559 = z137 * z137;
    const Scalar z560 = z554 + z559;
    const Scalar z561 = z137 * z139;
    const Scalar z563 = z138 * z139;
    const Scalar z565 = z553 - z554;
    const Scalar z566 = z554 - z559;
    const Scalar z569 = z553 - z559;
    const Scalar z581 = z117 * z117;
    const Scalar z582 = z538 + z581;
    const Scalar z583 = z118 * z119;
    const Scalar z585 = z537 - z538;
    const Scalar z586 = z538 - z581;
    const Scalar z589 = z537 - z581;
    const Scalar z600 = z103 * z103;
    const Scalar z601 = z104 * z104;
    const Scalar z602 = z600 + z601;
    const Scalar z603 = z102 * z103;
    const Scalar z606 = z102 * z102;
    const Scalar z607 = z601 + z606;
    const Scalar z608 = z102 * z104;
    const Scalar z610 = z103 * z104;
    const Scalar z612 = z600 - z601;
    const Scalar z613 = z601 - z606;
    const Scalar z616 = z600 - z606;
    const Scalar z627 = z510 - z511;
    const Scalar z628 = z511 - z516;
    const Scalar z631 = z510 - z516;
    const Scalar z643 = z55 * z55;
    const Scalar z644 = z495 + z643;
    const Scalar z645 = z56 * z57;
    const Scalar z647 = z494 - z495;
    const Scalar z648 = z495 - z643;
    const Scalar z651 = z494 - z643;
    const Scalar z662 = z40 * z40;
    const Scalar z665 = z481 - z662;
    const Scalar z666 = z481 - z482;
    const Scalar z667 = z482 - z662;
    const Scalar z683 = a_q1 * s_q2;
    const Scalar z684 = a_q1 * c_q2;
    const Scalar z685 = v_q2 * z40 + z683;  // angular acceleration of link2, x
    const Scalar z686 = v_q2 * z39 - z684;  // angular acceleration of link2, y
    const Scalar z687 = a_q2 - z480;
    const Scalar z688 = z478 + z685;
    const Scalar z689 = a_q2 * s_q3 - c_q3 * z685;
    const Scalar z690 = a_q2 * c_q3 + s_q3 * z685;
    const Scalar z691 = z476 - n632_over_165 * z687;
    const Scalar z692 = n632_over_165 * z688;
    const Scalar z693 = s_q3 * z692 - c_q3 * z691;
    const Scalar z694 = s_q3 * z691 + c_q3 * z692;
    const Scalar z695 = v_q3 * z56 + z689;  // angular acceleration of link3, x
    const Scalar z696 = v_q3 * z55 - z690;  // angular acceleration of link3, y
    const Scalar z697 = a_q3 - z686;  // angular acceleration of link3, z
    const Scalar z698 = z497 + z697;
    const Scalar z699 = z499 + z696;
    const Scalar z700 = s_q4 * z697 + c_q4 * z695;
    const Scalar z701 = s_q4 * z695 - c_q4 * z697;
    const Scalar z702 = z496 - z693;
    const Scalar z703 = z694 + z698;
    const Scalar z704 = z488 + z699;
    const Scalar z705 = s_q4 * z704 - c_q4 * z702;
    const Scalar z706 = s_q4 * z702 + c_q4 * z704;
    const Scalar z707 = v_q4 * z79 - z700;  // angular acceleration of link4, x
    const Scalar z708 = v_q4 * z78 + z701;  // angular acceleration of link4, y
    const Scalar z709 = a_q4 + z696;  // angular acceleration of link4, z
    const Scalar z710 = z513 + z709;
    const Scalar z711 = z513 - z709;
    const Scalar z712 = z518 + z708;
    const Scalar z713 = z520 + z707;
    const Scalar z714 = s_q5 * z709 + c_q5 * z707;
    const Scalar z715 = s_q5 * z707 - c_q5 * z709;
    const Scalar z716 = z512 + z705 - n256_over_55 * z710;
    const Scalar z717 = n256_over_55 * z517 - z706 - z711;
    const Scalar z718 = z703 + z712 + n256_over_55 * z713;
    const Scalar z719 = s_q5 * z718 + c_q5 * z716;
    const Scalar z720 = s_q5 * z716 - c_q5 * z718;
    const Scalar z721 = v_q5 * z103 + z714;  // angular acceleration of link5, x
    const Scalar z722 = v_q5 * z102 + z715;  // angular acceleration of link5, y
    const Scalar z723 = a_q5 - z708;  // angular acceleration of link5, z
    const Scalar z724 = s_q6 * z723 - c_q6 * z721;
    const Scalar z725 = s_q6 * z721 + c_q6 * z723;
    const Scalar z726 = s_q6 * z717 - c_q6 * z719;
    const Scalar z727 = s_q6 * z719 + c_q6 * z717;
    const Scalar z728 = v_q6 * z118 + z724;  // angular acceleration of link6, x
    const Scalar z729 = v_q6 * z117 - z725;  // angular acceleration of link6, y
    const Scalar z730 = a_q6 - z722;  // angular acceleration of link6, z
    const Scalar z731 = z540 + z730;
    const Scalar z732 = z542 + z729;
    const Scalar z733 = s_q7 * z730 + c_q7 * z728;
    const Scalar z734 = s_q7 * z728 - c_q7 * z730;
    const Scalar z735 = n16_over_15 * z539 + z726;
    const Scalar z736 = z727 - n16_over_15 * z731;
    const Scalar z737 = z720 + n16_over_15 * z732;
    const Scalar z738 = s_q7 * z737 - c_q7 * z735;
    const Scalar z739 = s_q7 * z735 + c_q7 * z737;
    const Scalar z740 = v_q7 * z138 - z733;  // angular acceleration of link7, x
    const Scalar z741 = v_q7 * z137 + z734;  // angular acceleration of link7, y
    const Scalar z742 = a_q7 + z729;  // angular acceleration of link7, z
    const Scalar z743 = z556 + z742;
    const Scalar z744 = z556 - z742;
    const Scalar z745 = z561 + z741;
    const Scalar z746 = z563 + z740;
    const Scalar z747 = z563 - z740;
    const Scalar z748 = z561 - z741;
    const Scalar z749 = k0 * z555 - k1 * z743;  // force on link7, times 0.0825 m, x
    const Scalar z750 = k1 * z560 - k0 * z744;  // force on link7, times 0.0825 m, y
    const Scalar z751 = k0 * z745 + k1 * z746;  // force on link7, times 0.0825 m, z
    // moment on link7, z
    const Scalar z754 = k8 * z556 + k10 * z569 + k1 * z738 + k0 * z739 + k4 * z742 - k3 * z747 - k2 * z748;
    const Scalar z755 = s_q7 * z750 + c_q7 * z749;
    const Scalar z756 = s_q7 * z749 - c_q7 * z750;
    const Scalar z759 = z540 - z730;
    const Scalar z760 = z583 + z728;
    const Scalar z761 = z583 - z728;
    const Scalar z762 = z542 - z729;
    const Scalar z763 = k12 * z539 + z755 + k18 * z759;  // force on link6, times 0.0825 m, x
    const Scalar z764 = k18 * z582 + k12 * z731 - z751;  // force on link6, times 0.0825 m, y
    const Scalar z765 = k12 * z732 - z756 - k18 * z760;  // force on link6, times 0.0825 m, z
    const Scalar z769 = s_q6 * z764 + c_q6 * z763;
    const Scalar z770 = s_q6 * z763 - c_q6 * z764;
    const Scalar z773 = z603 - z723;
    const Scalar z774 = z603 + z723;
    const Scalar z775 = z608 + z722;
    const Scalar z776 = z610 + z721;
    const Scalar z777 = z610 - z721;
    const Scalar z778 = z608 - z722;
    const Scalar z779 = k20 * z602 - z769 + k21 * z773;  // force on link5, times 0.0825 m, x
    const Scalar z780 = k21 * z607 + z765 + k20 * z774;  // force on link5, times 0.0825 m, y
    const Scalar z781 = z770 - k20 * z775 + k21 * z776;  // force on link5, times 0.0825 m, z
    const Scalar z785 = s_q5 * z780 + c_q5 * z779;
    const Scalar z786 = s_q5 * z779 - c_q5 * z780;
    const Scalar z789 = z520 - z707;
    const Scalar z790 = z518 - z708;
    const Scalar z791 = k28 * z512 - k29 * z710 + z785;  // force on link4, times 0.0825 m, x
    const Scalar z792 = k29 * z517 - k28 * z711 + z781;  // force on link4, times 0.0825 m, y
    const Scalar z793 = k28 * z712 + k29 * z713 + z786;  // force on link4, times 0.0825 m, z
    const Scalar z797 = s_q4 * z792 + c_q4 * z791;
    const Scalar z798 = s_q4 * z791 - c_q4 * z792;
    const Scalar z801 = z497 - z697;
    const Scalar z802 = z645 + z695;
    const Scalar z803 = z645 - z695;
    const Scalar z804 = z499 - z696;
    const Scalar z805 = k35 * z496 - z797 - k36 * z801;  // force on link3, times 0.0825 m, x
    const Scalar z806 = k36 * z644 - k35 * z698 - z793;  // force on link3, times 0.0825 m, y
    const Scalar z811 = s_q3 * z806 - c_q3 * z805;
    const Scalar z812 = s_q3 * z805 + c_q3 * z806;
    const Scalar z815 = a_q2 + z480;
    const Scalar z816 = z479 + z686;
    const Scalar z817 = z478 - z685;
    const Scalar z818 = z479 - z686;
    const Scalar z1375 = k52 * z295;
    const Scalar z1376 = k52 * z291;
    const Scalar z1377 = k52 * z285;
    const Scalar z1378 = k52 * z279;
    const Scalar z1379 = k52 * z272;
    const Scalar z1380 = k52 * z267;
    const Scalar z1381 = z295 * z1375 - z468;
    const Scalar z1382 = z295 * z1376 + z454;
    const Scalar z1383 = z291 * z1376 - z450;
    const Scalar z1384 = z295 * z1377 - z434;
    const Scalar z1385 = z291 * z1377 - z430;
    const Scalar z1386 = z285 * z1377 - z424;
    const Scalar z1387 = z295 * z1378 - z406;
    const Scalar z1388 = z291 * z1378 - z402;
    const Scalar z1389 = z285 * z1378 + z395;
    const Scalar z1390 = z279 * z1378 - z391;
    const Scalar z1391 = z295 * z1379 - z372;
    const Scalar z1392 = z291 * z1379 - z368;
    const Scalar z1393 = z285 * z1379 - z362;
    const Scalar z1394 = z279 * z1379 + z356;
    const Scalar z1395 = z272 * z1379 - z349;
    const Scalar z1396 = z295 * z1380 - z335;
    const Scalar z1397 = z291 * z1380 + z331;
    const Scalar z1398 = z285 * z1380 + z325;
    const Scalar z1399 = z279 * z1380 - z319;
    const Scalar z1400 = z272 * z1380 - z312;
    const Scalar z1401 = z267 * z1380 - z308;
    const Scalar z1402 = n1 / z1401;
    const Scalar z1403 = z1396 * z1402;
    const Scalar z1404 = z1397 * z1402;
    const Scalar z1405 = z1398 * z1402;
    const Scalar z1406 = z1399 * z1402;
    const Scalar z1407 = z1400 * z1402;
    const Scalar z1408 = z1381 - z1396 * z1403;
    const Scalar z1409 = z1382 - z1396 * z1404;
    const Scalar z1410 = z1383 - z1397 * z1404;
    const Scalar z1411 = z1384 - z1396 * z1405;
    const Scalar z1412 = z1385 - z1397 * z1405;
    const Scalar z1413 = z1386 - z1398 * z1405;
    const Scalar z1414 = z1387 - z1396 * z1406;
    const Scalar z1415 = z1388 - z1397 * z1406;
    const Scalar z1416 = z1389 - z1398 * z1406;
    const Scalar z1417 = z1390 - z1399 * z1406;
    const Scalar z1418 = z1391 - z1396 * z1407;
    const Scalar z1419 = z1392 - z1397 * z1407;
    const Scalar z1420 = z1393 - z1398 * z1407;
    const Scalar z1421 = z1394 - z1399 * z1407;
    const Scalar z1422 = z1395 - z1400 * z1407;
    const Scalar z1423 = n1 / z1422;
    const Scalar z1424 = z1418 * z1423;
    const Scalar z1425 = z1419 * z1423;
    const Scalar z1426 = z1420 * z1423;
    const Scalar z1427 = z1421 * z1423;
    const Scalar z1428 = z1408 - z1418 * z1424;
    const Scalar z1429 = z1409 - z1418 * z1425;
    const Scalar z1430 = z1410 - z1419 * z1425;
    const Scalar z1431 = z1411 - z1418 * z1426;
    const Scalar z1432 = z1412 - z1419 * z1426;
    const Scalar z1433 = z1413 - z1420 * z1426;
    const Scalar z1434 = z1414 - z1418 * z1427;
    const Scalar z1435 = z1415 - z1419 * z1427;
    const Scalar z1436 = z1416 - z1420 * z1427;
    const Scalar z1437 = z1417 - z1421 * z1427;
    const Scalar z1438 = n1 / z1437;
    const Scalar z1439 = z1434 * z1438;
    const Scalar z1440 = z1435 * z1438;
    const Scalar z1441 = z1436 * z1438;
    const Scalar z1442 = z1428 - z1434 * z1439;
    const Scalar z1443 = z1429 - z1434 * z1440;
    const Scalar z1444 = z1430 - z1435 * z1440;
    const Scalar z1445 = z1431 - z1434 * z1441;
    const Scalar z1446 = z1432 - z1435 * z1441;
    const Scalar z1447 = z1433 - z1436 * z1441;
    const Scalar z1448 = n1 / z1447;
    const Scalar z1449 = z1445 * z1448;
    const Scalar z1450 = z1446 * z1448;
    const Scalar z1451 = z1442 - z1445 * z1449;
    const Scalar z1452 = z1443 - z1445 * z1450;
    const Scalar z1453 = z1444 - z1446 * z1450;
    const Scalar z1454 = n1 / z1453;
    const Scalar z1455 = z1452 * z1454;
    const Scalar z1456 = z1451 - z1452 * z1455;
    const Scalar z1457 = n1 / z1456;
    const Scalar z1781 = k4 * z563 + k2 * z565 + k1 * z736 + k8 * z740 - k3 * z744 - k10 * z745;  // moment on link7, x
    const Scalar z1782 = k54 * z561 + k3 * z566 + k0 * z736 + k2 * z743 - k10 * z746;  // moment on link7, y
    const Scalar z1783 = s_q7 * z1782 - c_q7 * z1781;
    const Scalar z1784 = s_q7 * z1781 + c_q7 * z1782;
    // moment on link6, x
    const Scalar z1785 = k17 * z583 + k16 * z585 - k18 * z720 - k13 * z728 - k15 * z731 - k14 * z732 + z1783;
    // moment on link6, y
    const Scalar z1786 = k55 * z542 + k15 * z586 + k12 * z720 + z754 - n16_over_15 * z756 + k16 * z759 - k14 * z760;
    // moment on link6, z
    const Scalar z1787 = k13 * z540 - k14 * z589 - k18 * z726 - k12 * z727 + k17 * z730 - n16_over_15 * z751 + k15
        * z761 + k16 * z762 - z1784;
    const Scalar z1788 = s_q6 * z1786 + c_q6 * z1785;
    const Scalar z1789 = s_q6 * z1785 - c_q6 * z1786;
    // moment on link5, x
    const Scalar z1790 = k26 * z610 - k25 * z612 + k21 * z717 + k22 * z721 + k24 * z774 + k23 * z775 - z1788;
    const Scalar z1791 = k56 * z608 - k24 * z613 - k20 * z717 - k25 * z773 + k23 * z776 - z1787;  // moment on link5, y
    // moment on link5, z
    const Scalar z1792 = k22 * z603 - k23 * z616 + k21 * z719 - k20 * z720 - k26 * z723 + k24 * z777 + k25 * z778
        - z1789;
    const Scalar z1793 = s_q5 * z1791 + c_q5 * z1790;
    const Scalar z1794 = s_q5 * z1790 - c_q5 * z1791;
    // moment on link4, x
    const Scalar z1795 = k34 * z520 + k33 * z627 + k29 * z703 + k30 * z707 + k32 * z711 + k31 * z712 + n256_over_55
        * z786 + z1793;
    // moment on link4, y
    const Scalar z1796 = k57 * z518 - k32 * z628 + k28 * z703 + k33 * z710 + k31 * z713 + z786 + z1792;
    // moment on link4, z
    const Scalar z1797 = k30 * z513 - k31 * z631 - k29 * z705 - k28 * z706 + k34 * z709 + z781 - n256_over_55 * z785
        + k32 * z789 - k33 * z790 + z1794;
    const Scalar z1798 = s_q4 * z1796 - c_q4 * z1795;
    const Scalar z1799 = s_q4 * z1795 + c_q4 * z1796;
    // moment on link3, x
    const Scalar z1800 = k36 * z488 + k41 * z645 - k40 * z647 + k37 * z695 - k39 * z698 + k38 * z699 + z1798;
    // moment on link3, y
    const Scalar z1801 = k35 * z488 + k58 * z499 + k39 * z648 + z798 - k40 * z801 + k38 * z802 + z1797;
    // moment on link3, z
    const Scalar z1802 = k37 * z497 - k38 * z651 + k36 * z693 - k35 * z694 - k41 * z697 - z793 - k39 * z803 + k40 * z804
        + z1799;
    const Scalar z1803 = s_q3 * z1801 + c_q3 * z1800;
    const Scalar z1804 = s_q3 * z1800 - c_q3 * z1801;
    // moment on link2, x
    const Scalar z1805 = k49 * z478 + k48 * z665 + k45 * z685 - n632_over_165 * z812 - k47 * z815 + k46 * z816 - z1803;
    const Scalar z1806 = k59 * z479 + k47 * z666 + k48 * z687 + k46 * z688 + z1802;  // moment on link2, y
    // moment on link2, z
    const Scalar z1807 = k49 * a_q2 - k44 * z476 + k43 * z477 - k45 * z480 - k46 * z667 + n632_over_165 * z811 + k47
        * z817 - k48 * z818 + z1804;
    const Scalar z1809 = s_q2 * z1805 - c_q2 * z1806;
    const Scalar z1812 = k50 * a_q1 + z1809;  // moment on link1, z
    const Scalar z1813 = n2 * v_q1;
    const Scalar z1814 = z482 + z662;
    const Scalar z1815 = n2 * z39;
    const Scalar z1816 = n2 * z40;
    const Scalar z1817 = n2 * v_q2;
    const Scalar z1818 = z494 + z643;
    const Scalar z1819 = n2 * z55;
    const Scalar z1820 = n2 * z56;
    const Scalar z1821 = n2 * z57;
    const Scalar z1822 = z510 + z516;
    const Scalar z1823 = n2 * z78;
    const Scalar z1824 = n2 * z79;
    const Scalar z1825 = n2 * z80;
    const Scalar z1826 = z600 + z606;
    const Scalar z1827 = n2 * z102;
    const Scalar z1828 = n2 * z103;
    const Scalar z1829 = n2 * z104;
    const Scalar z1830 = z537 + z581;
    const Scalar z1831 = n2 * z117;
    const Scalar z1832 = n2 * z118;
    const Scalar z1833 = n2 * z119;
    const Scalar z1834 = z553 + z559;
    const Scalar z1835 = n2 * z137;
    const Scalar z1836 = n2 * z138;
    const Scalar z1837 = n2 * z139;
    const Scalar z1838 = k2 * z1835;
    const Scalar z1839 = k3 * z1836;
    const Scalar z1840 = k10 * z1837;
    const Scalar z1841 = k1 * z1837;
    const Scalar z1842 = k0 * z1837;
    const Scalar z1843 = k1 * z1835 - k0 * z1836;
    const Scalar z1844 = z1839 + z1840;
    const Scalar z1845 = k2 * z1836 + k60 * z1837;
    const Scalar z1846 = k61 * z1836 - k2 * z1837;
    const Scalar z1847 = k3 * z1835 - k61 * z1837;
    const Scalar z1848 = z1838 - z1840;
    const Scalar z1849 = k61 * z1835 + k3 * z1837;
    const Scalar z1850 = k10 * z1835 + k61 * z1836;
    const Scalar z1851 = k60 * z1835 + k10 * z1836;
    const Scalar z1852 = z1838 + z1839;
    const Scalar z1853 = n16_over_15 * z1833;
    const Scalar z1854 = n16_over_15 * z1832;
    const Scalar z1855 = s_q7 * z1842 - c_q7 * z1841;
    const Scalar z1856 = s_q7 * z1841 + c_q7 * z1842;
    const Scalar z1857 = z1844 - z1848;
    const Scalar z1858 = z1845 + z1847;
    const Scalar z1859 = s_q7 * z1849 - c_q7 * z1846;
    const Scalar z1860 = s_q7 * z1846 + c_q7 * z1849;
    const Scalar z1861 = s_q7 * z1851 - c_q7 * z1850;
    const Scalar z1862 = s_q7 * z1850 + c_q7 * z1851;
    const Scalar z1863 = s_q7 * z1857 + c_q7 * z1858;
    const Scalar z1864 = s_q7 * z1863;
    const Scalar z1865 = z1844 - z1864;
    const Scalar z1866 = z1848 + z1864;
    const Scalar z1867 = c_q7 * z1863 - z1847;
    const Scalar z1868 = c_q7 * z1863 - z1845;
    const Scalar z1869 = n16_over_15 * z1855 + z1865;
    const Scalar z1870 = z265 * z1853 + n16_over_15 * z1843 + z1861;
    const Scalar z1871 = z264 * z1853 - z1862;
    const Scalar z1872 = z265 * z1854 - n16_over_15 * z1856 + z1868;
    const Scalar z1873 = z264 * z1854 + z1866;
    const Scalar z1874 = k16 * z1831;
    const Scalar z1875 = k15 * z1832;
    const Scalar z1876 = k14 * z1833;
    const Scalar z1877 = k18 * z1833 - z1855;
    const Scalar z1878 = k12 * z1833 + z1843;
    const Scalar z1879 = k18 * z1831 + k12 * z1832 - z1856;
    const Scalar z1880 = z1869 - z1875 - z1876;
    const Scalar z1881 = k16 * z1832 + k62 * z1833 - z1859;
    const Scalar z1882 = k63 * z1832 - k16 * z1833 + z1867;
    const Scalar z1883 = k15 * z1831 - k63 * z1833 - z1870;
    const Scalar z1884 = z1852 + z1874 - z1876;
    const Scalar z1885 = k63 * z1831 + k15 * z1833 + z1871;
    const Scalar z1886 = k14 * z1831 + k63 * z1832 + z1872;
    const Scalar z1887 = k62 * z1831 + k14 * z1832 - z1860;
    const Scalar z1888 = z1873 + z1874 + z1875;
    const Scalar z1889 = s_q6 * z1878 - c_q6 * z1877;
    const Scalar z1890 = s_q6 * z1877 + c_q6 * z1878;
    const Scalar z1891 = z1880 + z1884;
    const Scalar z1892 = z1881 + z1883;
    const Scalar z1893 = s_q6 * z1885 + c_q6 * z1882;
    const Scalar z1894 = s_q6 * z1882 - c_q6 * z1885;
    const Scalar z1895 = s_q6 * z1887 + c_q6 * z1886;
    const Scalar z1896 = s_q6 * z1886 - c_q6 * z1887;
    const Scalar z1897 = s_q6 * z1891 + c_q6 * z1892;
    const Scalar z1898 = s_q6 * z1897;
    const Scalar z1899 = z1880 - z1898;
    const Scalar z1900 = z1884 - z1898;
    const Scalar z1901 = c_q6 * z1897 - z1883;
    const Scalar z1902 = c_q6 * z1897 - z1881;
    const Scalar z1903 = k25 * z1827;
    const Scalar z1904 = k24 * z1828;
    const Scalar z1905 = k23 * z1829;
    const Scalar z1906 = k21 * z1829 + z1889;
    const Scalar z1907 = k20 * z1829 - z1879;
    const Scalar z1908 = k21 * z1827 + k20 * z1828 - z1890;
    const Scalar z1909 = z1899 + z1904 + z1905;
    const Scalar z1910 = k25 * z1828 - k64 * z1829 + z1893;
    const Scalar z1911 = k65 * z1828 + k25 * z1829 - z1901;
    const Scalar z1912 = k24 * z1827 + k65 * z1829 + z1895;
    const Scalar z1913 = z1888 + z1903 - z1905;
    const Scalar z1914 = k65 * z1827 - k24 * z1829 - z1896;
    const Scalar z1915 = k23 * z1827 - k65 * z1828 + z1902;
    const Scalar z1916 = k64 * z1827 - k23 * z1828 - z1894;
    const Scalar z1917 = z1900 + z1903 + z1904;
    const Scalar z1918 = n256_over_55 * z1825;
    const Scalar z1919 = n256_over_55 * z1823 - z1824;
    const Scalar z1920 = s_q5 * z1907 - c_q5 * z1906;
    const Scalar z1921 = s_q5 * z1906 + c_q5 * z1907;
    const Scalar z1922 = z1909 - z1913;
    const Scalar z1923 = z1910 + z1912;
    const Scalar z1924 = s_q5 * z1914 + c_q5 * z1911;
    const Scalar z1925 = s_q5 * z1911 - c_q5 * z1914;
    const Scalar z1926 = s_q5 * z1916 - c_q5 * z1915;
    const Scalar z1927 = s_q5 * z1915 + c_q5 * z1916;
    const Scalar z1928 = s_q5 * z1922 - c_q5 * z1923;
    const Scalar z1929 = s_q5 * z1928;
    const Scalar z1930 = z1909 - z1929;
    const Scalar z1931 = z1913 + z1929;
    const Scalar z1932 = c_q5 * z1928 + z1912;
    const Scalar z1933 = c_q5 * z1928 + z1910;
    const Scalar z1934 = z351 * z1918 - z1920 - z1930;
    const Scalar z1935 = z309 * z1918 - n256_over_55 * z1920 - z1924;
    const Scalar z1936 = z350 * z1918 - z1932;
    const Scalar z1937 = z351 * z1825 + z1908 + z1926;
    const Scalar z1938 = z309 * z1825 + n256_over_55 * z1908 - z1917;
    const Scalar z1939 = z350 * z1825 - z1927;
    const Scalar z1940 = z351 * z1919 + z1921 - z1933;
    const Scalar z1941 = z309 * z1919 + n256_over_55 * z1921 - z1925;
    const Scalar z1942 = z350 * z1919 - z1931;
    const Scalar z1943 = k33 * z1823;
    const Scalar z1944 = k32 * z1824;
    const Scalar z1945 = k31 * z1825;
    const Scalar z1946 = k29 * z1825 - z1920;
    const Scalar z1947 = k28 * z1825 + z1908;
    const Scalar z1948 = k29 * z1823 - k28 * z1824 + z1921;
    const Scalar z1949 = z1934 + z1944 + z1945;
    const Scalar z1950 = k33 * z1824 + k66 * z1825 + z1935;
    const Scalar z1951 = k67 * z1824 - k33 * z1825 - z1936;
    const Scalar z1952 = k32 * z1823 + k67 * z1825 + z1937;
    const Scalar z1953 = z1938 + z1943 + z1945;
    const Scalar z1954 = k67 * z1823 - k32 * z1825 - z1939;
    const Scalar z1955 = k31 * z1823 - k67 * z1824 + z1940;
    const Scalar z1956 = k66 * z1823 - k31 * z1824 + z1941;
    const Scalar z1957 = z1942 + z1943 - z1944;
    const Scalar z1958 = s_q4 * z1947 - c_q4 * z1946;
    const Scalar z1959 = s_q4 * z1946 + c_q4 * z1947;
    const Scalar z1960 = z1949 + z1953;
    const Scalar z1961 = z1950 - z1952;
    const Scalar z1962 = s_q4 * z1954 - c_q4 * z1951;
    const Scalar z1963 = s_q4 * z1951 + c_q4 * z1954;
    const Scalar z1964 = s_q4 * z1956 + c_q4 * z1955;
    const Scalar z1965 = s_q4 * z1955 - c_q4 * z1956;
    const Scalar z1966 = s_q4 * z1960 - c_q4 * z1961;
    const Scalar z1967 = s_q4 * z1966;
    const Scalar z1968 = z1949 - z1967;
    const Scalar z1969 = z1953 - z1967;
    const Scalar z1970 = c_q4 * z1966 - z1952;
    const Scalar z1971 = c_q4 * z1966 + z1950;
    const Scalar z1972 = z1958 + z1968;
    const Scalar z1973 = z393 * z1821 + z1948 - z1964;
    const Scalar z1974 = z350 * z1821 - z1957;
    const Scalar z1975 = z392 * z1821 - z1965;
    const Scalar z1976 = z393 * z1820 - z1959 + z1971;
    const Scalar z1977 = z350 * z1820 - z1963;
    const Scalar z1978 = z392 * z1820 - z1969;
    const Scalar z1979 = k40 * z1819;
    const Scalar z1980 = k39 * z1820;
    const Scalar z1981 = k38 * z1821;
    const Scalar z1982 = k36 * z1821 - z1958;
    const Scalar z1983 = k35 * z1821 - z1948;
    const Scalar z1984 = k36 * z1819 - k35 * z1820 - z1959;
    const Scalar z1985 = z1972 + z1980 - z1981;
    const Scalar z1986 = k40 * z1820 - k68 * z1821 + z1962;
    const Scalar z1987 = k69 * z1820 + k40 * z1821 - z1970;
    const Scalar z1988 = k39 * z1819 - k69 * z1821 + z1973;
    const Scalar z1989 = z1974 + z1979 - z1981;
    const Scalar z1990 = k69 * z1819 + k39 * z1821 - z1975;
    const Scalar z1991 = k38 * z1819 - k69 * z1820 + z1976;
    const Scalar z1992 = k68 * z1819 - k38 * z1820 + z1977;
    const Scalar z1993 = z1978 + z1979 - z1980;
    const Scalar z1994 = n632_over_165 * z1817;
    const Scalar z1995 = n632_over_165 * z1815;
    const Scalar z1996 = s_q3 * z1983 + c_q3 * z1982;
    const Scalar z1997 = s_q3 * z1982 - c_q3 * z1983;
    const Scalar z1998 = z1985 + z1989;
    const Scalar z1999 = z1986 - z1988;
    const Scalar z2000 = s_q3 * z1990 + c_q3 * z1987;
    const Scalar z2001 = s_q3 * z1987 - c_q3 * z1990;
    const Scalar z2002 = s_q3 * z1992 - c_q3 * z1991;
    const Scalar z2003 = s_q3 * z1991 + c_q3 * z1992;
    const Scalar z2004 = s_q3 * z1998 + c_q3 * z1999;
    const Scalar z2005 = s_q3 * z2004;
    const Scalar z2006 = z1985 - z2005;
    const Scalar z2007 = z1989 - z2005;
    const Scalar z2008 = c_q3 * z2004 + z1988;
    const Scalar z2009 = c_q3 * z2004 - z1986;
    const Scalar z2010 = z426 * z1994 - z2006;
    const Scalar z2011 = z392 * z1994 + n632_over_165 * z1996 + z2000;
    const Scalar z2012 = z425 * z1994 + z2008;
    const Scalar z2013 = n632_over_165 * z1984 + z1993;
    const Scalar z2014 = z426 * z1995 - z2009;
    const Scalar z2015 = z392 * z1995 + n632_over_165 * z1997 + z2001;
    const Scalar z2016 = z425 * z1995 - z2007;
    const Scalar z2017 = k48 * z1815;
    const Scalar z2018 = k47 * z1816;
    const Scalar z2019 = k46 * z1817;
    const Scalar z2023 = z2010 - z2018 + z2019;
    const Scalar z2024 = k48 * z1816 - k70 * z1817 + z2011;
    const Scalar z2025 = k71 * z1816 + k48 * z1817 + z2012;
    const Scalar z2026 = k47 * z1815 - k71 * z1817 - z2002;
    const Scalar z2027 = z2013 - z2017 + z2019;
    const Scalar z2028 = k71 * z1815 + k47 * z1817 + z2003;
    const Scalar z2029 = k46 * z1815 - k71 * z1816 + z2014;
    const Scalar z2030 = k70 * z1815 - k46 * z1816 - z2015;
    const Scalar z2031 = z2016 + z2017 - z2018;
    const Scalar z2034 = z2023 + z2027;
    const Scalar z2035 = z2024 - z2026;
    const Scalar z2039 = s_q2 * z2029 + c_q2 * z2030;
    const Scalar z2040 = s_q2 * z2034 - c_q2 * z2035;
    const Scalar z2041 = s_q2 * z2040;
    const Scalar z2042 = z2023 - z2041;
    const Scalar z2046 = k72 * z1813;
    const Scalar z2049 = z2042 + z2046;
    const Scalar z2053 = z2031 + z2046;
    const Scalar z2057 = z2049 - z2053;
    const Scalar z2058 = z2027 + z2031;
    const Scalar z2059 = z2023 - z2031;
    const Scalar z2060 = z2023 - z2027;
    const Scalar z2061 = z39 * z2030 - z40 * z2029 - z444 * z476 - z445 * z477 - z448 * z818 - z449 * z817 - z450
        * z1814;
    const Scalar z2062 = z448 * z1816 - z449 * z1815 + z2060;
    const Scalar z2066 = z39 * z2024 + z40 * z2058 + z425 * z476 + z446 * z818 - z447 * z817 + z448 * z1814 + z1806;
    const Scalar z2067 = z39 * z2059 + z40 * z2026 + z424 * z817 + z425 * z477 - z447 * z818 + z449 * z1814 + z1805;
    const Scalar z2071 = s_q2 * z2066 + c_q2 * z2067;
    const Scalar z2075 = z446 * z1816 + z447 * z1815 + z2025;
    const Scalar z2076 = z424 * z1815 + z447 * z1816 + z2028;
    const Scalar z2080 = s_q2 * z2075 - c_q2 * z2076;
    const Scalar z2081 = z1989 - z1993;
    const Scalar z2082 = z1985 + z1993;
    const Scalar z2083 = z1985 - z1989;
    const Scalar z2084 = z55 * z1992 - z56 * z1991 - z418 * z693 - z419 * z694 - z422 * z804 - z423 * z803 - z424
        * z1818;
    const Scalar z2085 = z422 * z1820 - z423 * z1819 - z2083;
    const Scalar z2086 = z425 * z1995 - z426 * z1994 + z2083;
    const Scalar z2087 = z39 * z2086 + z40 * z2002 - z424 * z817 - z425 * z477 + z429 * z818 - z430 * z1814;
    const Scalar z2088 = z424 * z1815 + z429 * z1816 + z2003;
    const Scalar z2090 = s_q2 * z2002 - c_q2 * z2086;
    const Scalar z2091 = z55 * z1984 + z392 * z803 - z419 * z1818 - z806;
    const Scalar z2092 = z56 * z1984 - z392 * z804 + z418 * z1818 + z805;
    const Scalar z2094 = z55 * z1986 - z56 * z2081 - z392 * z693 + z420 * z804 - z421 * z803 + z422 * z1818 + z1801;
    const Scalar z2095 = z55 * z2082 - z56 * z1988 + z392 * z694 - z416 * z803 + z421 * z804 - z423 * z1818 - z1800;
    const Scalar z2096 = s_q3 * z2092 - c_q3 * z2091;
    const Scalar z2097 = s_q3 * z2091 + c_q3 * z2092;
    const Scalar z2098 = s_q3 * z2095 + c_q3 * z2094;
    const Scalar z2099 = s_q3 * z2094 - c_q3 * z2095;
    const Scalar z2100 = n632_over_165 * z2097 + z2098;
    const Scalar z2101 = n632_over_165 * z2096 + z2099;
    const Scalar z2105 = s_q2 * z2100 - c_q2 * z2084;
    const Scalar z2106 = z392 * z1819 - z1983;
    const Scalar z2107 = z392 * z1820 - z1982;
    const Scalar z2109 = z420 * z1820 + z421 * z1819 + z1987;
    const Scalar z2110 = z416 * z1819 + z421 * z1820 + z1990;
    const Scalar z2111 = s_q3 * z2107 - c_q3 * z2106;
    const Scalar z2112 = s_q3 * z2106 + c_q3 * z2107;
    const Scalar z2113 = s_q3 * z2110 + c_q3 * z2109;
    const Scalar z2114 = s_q3 * z2109 - c_q3 * z2110;
    const Scalar z2115 = n632_over_165 * z2112 - z2113;
    const Scalar z2116 = n632_over_165 * z2111 - z2114;
    const Scalar z2120 = s_q2 * z2115 - c_q2 * z2085;
    const Scalar z2121 = z1953 - z1957;
    const Scalar z2122 = z1949 + z1957;
    const Scalar z2123 = z1949 - z1953;
    const Scalar z2124 = z78 * z1956 - z79 * z1955 + z385 * z705 - z386 * z706 + z389 * z790 + z390 * z789 - z391
        * z1822;
    const Scalar z2125 = z389 * z1824 - z390 * z1823 - z2123;
    const Scalar z2126 = z393 * z1821 - z1964;
    const Scalar z2127 = z392 * z1820 + z2123;
    const Scalar z2128 = z55 * z2127 - z56 * z2126 + z392 * z694 + z394 * z804 - z395 * z1818 - z396 * z803;
    const Scalar z2129 = z394 * z1820 + z396 * z1819 - z1975;
    const Scalar z2130 = s_q3 * z2127 - c_q3 * z2126;
    const Scalar z2131 = s_q3 * z2126 + c_q3 * z2127;
    const Scalar z2132 = z393 * z1995 - z2130;
    const Scalar z2133 = z397 * z1995 - z398 * z1994 + z1975;
    const Scalar z2134 = z393 * z1994 - z2131;
    const Scalar z2135 = z39 * z2133 + z40 * z2132 + z393 * z476 + z395 * z817 - z397 * z477 + z401 * z818 - z402
        * z1814;
    const Scalar z2136 = z395 * z1815 - z401 * z1816 - z2134;
    const Scalar z2138 = s_q2 * z2132 - c_q2 * z2133;
    const Scalar z2139 = z78 * z1948 + z350 * z789 - z386 * z1822 - z792;
    const Scalar z2140 = z79 * z1948 - z350 * z790 + z385 * z1822 + z791;
    const Scalar z2141 = z78 * z1946 - z79 * z1947 + z385 * z789 - z386 * z790;
    const Scalar z2142 = z78 * z1950 - z79 * z2121 - z350 * z705 - z387 * z790 + z388 * z789 + z389 * z1822 - z1796;
    const Scalar z2143 = z78 * z2122 - z79 * z1952 - z350 * z706 + z383 * z789 - z388 * z790 - z390 * z1822 + z1795;
    const Scalar z2144 = s_q4 * z2140 + c_q4 * z2139;
    const Scalar z2145 = s_q4 * z2139 - c_q4 * z2140;
    const Scalar z2146 = s_q4 * z2143 - c_q4 * z2142;
    const Scalar z2147 = s_q4 * z2142 + c_q4 * z2143;
    const Scalar z2148 = z2124 - z2145;
    const Scalar z2149 = z2141 - z2147;
    const Scalar z2150 = s_q3 * z2141 + c_q3 * z2144;
    const Scalar z2151 = s_q3 * z2144 - c_q3 * z2141;
    const Scalar z2152 = s_q3 * z2148 + c_q3 * z2146;
    const Scalar z2153 = s_q3 * z2146 - c_q3 * z2148;
    const Scalar z2154 = n632_over_165 * z2151 + z2152;
    const Scalar z2155 = n632_over_165 * z2150 - z2153;
    const Scalar z2159 = s_q2 * z2154 - c_q2 * z2149;
    const Scalar z2160 = z350 * z1823 - z1947;
    const Scalar z2161 = z350 * z1824 - z1946;
    const Scalar z2162 = z385 * z1823 + z386 * z1824;
    const Scalar z2163 = z387 * z1824 + z388 * z1823 + z1951;
    const Scalar z2164 = z383 * z1823 + z388 * z1824 + z1954;
    const Scalar z2165 = s_q4 * z2161 + c_q4 * z2160;
    const Scalar z2166 = s_q4 * z2160 - c_q4 * z2161;
    const Scalar z2167 = s_q4 * z2164 - c_q4 * z2163;
    const Scalar z2168 = s_q4 * z2163 + c_q4 * z2164;
    const Scalar z2169 = z2125 + z2166;
    const Scalar z2170 = z2162 - z2168;
    const Scalar z2171 = s_q3 * z2162 + c_q3 * z2165;
    const Scalar z2172 = s_q3 * z2165 - c_q3 * z2162;
    const Scalar z2173 = s_q3 * z2169 - c_q3 * z2167;
    const Scalar z2174 = s_q3 * z2167 + c_q3 * z2169;
    const Scalar z2175 = n632_over_165 * z2172 - z2173;
    const Scalar z2176 = n632_over_165 * z2171 - z2174;
    const Scalar z2180 = s_q2 * z2175 - c_q2 * z2170;
    const Scalar z2181 = z1913 - z1917;
    const Scalar z2182 = z1909 - z1917;
    const Scalar z2183 = z1909 + z1913;
    const Scalar z2184 = z102 * z1916 - z103 * z1915 + z343 * z719 + z344 * z720 + z347 * z778 - z348 * z777 - z349
        * z1826;
    const Scalar z2185 = z347 * z1828 + z348 * z1827 - z2183;
    const Scalar z2186 = z351 * z1825 + z1926;
    const Scalar z2187 = z350 * z1919 + z351 * z1918 - z2183;
    const Scalar z2188 = z78 * z2187 - z79 * z2186 - z350 * z706 - z354 * z790 + z355 * z789 - z356 * z1822;
    const Scalar z2189 = z354 * z1824 + z355 * z1823 - z1939;
    const Scalar z2190 = s_q4 * z2187 + c_q4 * z2186;
    const Scalar z2191 = s_q4 * z2186 - c_q4 * z2187;
    const Scalar z2192 = z351 * z1820 - z358 * z1821 + z2190;
    const Scalar z2193 = z357 * z1820 + z1939;
    const Scalar z2194 = z357 * z1821 + z2191;
    const Scalar z2195 = z55 * z2193 - z56 * z2192 + z351 * z693 + z357 * z694 - z359 * z804 + z361 * z803 + z362
        * z1818;
    const Scalar z2196 = z359 * z1820 + z361 * z1819 + z2194;
    const Scalar z2197 = s_q3 * z2193 - c_q3 * z2192;
    const Scalar z2198 = s_q3 * z2192 + c_q3 * z2193;
    const Scalar z2199 = z358 * z1995 + z2197;
    const Scalar z2200 = z363 * z1995 - z364 * z1994 + z2194;
    const Scalar z2201 = z358 * z1994 + z2198;
    const Scalar z2202 = z39 * z2200 - z40 * z2199 - z358 * z476 - z362 * z817 - z363 * z477 + z367 * z818 - z368
        * z1814;
    const Scalar z2203 = z362 * z1815 + z367 * z1816 - z2201;
    const Scalar z2205 = s_q2 * z2199 + c_q2 * z2200;
    const Scalar z2206 = z102 * z1908 + z309 * z777 - z344 * z1826 - z780;
    const Scalar z2207 = z103 * z1908 - z309 * z778 - z343 * z1826 - z779;
    const Scalar z2208 = z102 * z1906 + z103 * z1907 - z343 * z777 - z344 * z778;
    const Scalar z2209 = z102 * z1910 - z103 * z2181 - z309 * z719 + z345 * z778 - z346 * z777 - z347 * z1826 + z1791;
    const Scalar z2210 = z102 * z2182 - z103 * z1912 + z308 * z777 + z309 * z720 - z346 * z778 + z348 * z1826 + z1790;
    const Scalar z2211 = s_q5 * z2207 - c_q5 * z2206;
    const Scalar z2212 = s_q5 * z2206 + c_q5 * z2207;
    const Scalar z2213 = s_q5 * z2210 - c_q5 * z2209;
    const Scalar z2214 = s_q5 * z2209 + c_q5 * z2210;
    const Scalar z2215 = n256_over_55 * z2212 + z2213;
    const Scalar z2216 = z2184 + z2212;
    const Scalar z2217 = z2208 + n256_over_55 * z2211 - z2214;
    const Scalar z2218 = s_q4 * z2208 - c_q4 * z2211;
    const Scalar z2219 = s_q4 * z2211 + c_q4 * z2208;
    const Scalar z2220 = s_q4 * z2216 - c_q4 * z2215;
    const Scalar z2221 = s_q4 * z2215 + c_q4 * z2216;
    const Scalar z2222 = z2217 - z2219;
    const Scalar z2223 = z2212 - z2221;
    const Scalar z2224 = s_q3 * z2212 - c_q3 * z2218;
    const Scalar z2225 = s_q3 * z2218 + c_q3 * z2212;
    const Scalar z2226 = s_q3 * z2222 + c_q3 * z2220;
    const Scalar z2227 = s_q3 * z2220 - c_q3 * z2222;
    const Scalar z2228 = n632_over_165 * z2225 - z2226;
    const Scalar z2229 = n632_over_165 * z2224 - z2227;
    const Scalar z2233 = s_q2 * z2228 + c_q2 * z2223;
    const Scalar z2234 = z309 * z1827 + z1907;
    const Scalar z2235 = z309 * z1828 - z1906;
    const Scalar z2236 = z343 * z1827 - z344 * z1828;
    const Scalar z2237 = z345 * z1828 + z346 * z1827 + z1911;
    const Scalar z2238 = z308 * z1827 + z346 * z1828 + z1914;
    const Scalar z2239 = s_q5 * z2235 - c_q5 * z2234;
    const Scalar z2240 = s_q5 * z2234 + c_q5 * z2235;
    const Scalar z2241 = s_q5 * z2238 + c_q5 * z2237;
    const Scalar z2242 = s_q5 * z2237 - c_q5 * z2238;
    const Scalar z2243 = n256_over_55 * z2240 + z2241;
    const Scalar z2244 = z2185 - z2240;
    const Scalar z2245 = z2236 - n256_over_55 * z2239 - z2242;
    const Scalar z2246 = s_q4 * z2236 + c_q4 * z2239;
    const Scalar z2247 = s_q4 * z2239 - c_q4 * z2236;
    const Scalar z2248 = s_q4 * z2244 + c_q4 * z2243;
    const Scalar z2249 = s_q4 * z2243 - c_q4 * z2244;
    const Scalar z2250 = z2245 + z2247;
    const Scalar z2251 = z2240 - z2249;
    const Scalar z2252 = s_q3 * z2240 + c_q3 * z2246;
    const Scalar z2253 = s_q3 * z2246 - c_q3 * z2240;
    const Scalar z2254 = s_q3 * z2250 + c_q3 * z2248;
    const Scalar z2255 = s_q3 * z2248 - c_q3 * z2250;
    const Scalar z2256 = n632_over_165 * z2253 - z2254;
    const Scalar z2257 = n632_over_165 * z2252 + z2255;
    const Scalar z2261 = s_q2 * z2256 - c_q2 * z2251;
    const Scalar z2262 = z1884 - z1888;
    const Scalar z2263 = z1880 + z1888;
    const Scalar z2264 = z1880 - z1884;
    const Scalar z2265 = z117 * z1887 + z118 * z1886 + z303 * z726 - z306 * z762 + z307 * z761 - z308 * z1830 - k18
        * z727;
    const Scalar z2266 = z306 * z1832 + z307 * z1831 + z2264;
    const Scalar z2267 = z102 * z2264 - z103 * z1895 + z308 * z777 + z309 * z720 + z311 * z778 + z312 * z1826;
    const Scalar z2268 = z308 * z1827 - z311 * z1828 - z1896;
    const Scalar z2269 = s_q5 * z2264 - c_q5 * z1895;
    const Scalar z2270 = s_q5 * z1895 + c_q5 * z2264;
    const Scalar z2271 = z310 * z1919 + z314 * z1825 + z2269;
    const Scalar z2272 = z313 * z1919 - z314 * z1918 - z1896;
    const Scalar z2273 = z310 * z1918 + z313 * z1825 + z2270;
    const Scalar z2274 = z78 * z2272 + z79 * z2271 - z310 * z705 - z313 * z706 + z317 * z790 + z318 * z789 + z319
        * z1822;
    const Scalar z2275 = z317 * z1824 - z318 * z1823 + z2273;
    const Scalar z2276 = s_q4 * z2272 - c_q4 * z2271;
    const Scalar z2277 = s_q4 * z2271 + c_q4 * z2272;
    const Scalar z2278 = z314 * z1820 + z321 * z1821 - z2276;
    const Scalar z2279 = z320 * z1820 + z2273;
    const Scalar z2280 = z320 * z1821 - z2277;
    const Scalar z2281 = z55 * z2279 + z56 * z2278 - z314 * z693 + z320 * z694 - z322 * z804 - z324 * z803 - z325
        * z1818;
    const Scalar z2282 = z322 * z1820 - z324 * z1819 + z2280;
    const Scalar z2283 = s_q3 * z2279 + c_q3 * z2278;
    const Scalar z2284 = s_q3 * z2278 - c_q3 * z2279;
    const Scalar z2285 = z321 * z1995 + z2283;
    const Scalar z2286 = z326 * z1995 + z327 * z1994 - z2280;
    const Scalar z2287 = z321 * z1994 - z2284;
    const Scalar z2288 = z39 * z2286 + z40 * z2285 + z321 * z476 - z325 * z817 - z326 * z477 - z330 * z818 - z331
        * z1814;
    const Scalar z2289 = z325 * z1815 - z330 * z1816 + z2287;
    const Scalar z2291 = s_q2 * z2285 - c_q2 * z2286;
    const Scalar z2292 = z117 * z1879 + z264 * z761 - z764 - k18 * z1830;
    const Scalar z2293 = z118 * z1879 - z264 * z762 - z303 * z1830 - z763;
    const Scalar z2294 = z117 * z1877 + z118 * z1878 - z303 * z761 - k18 * z762;
    const Scalar z2295 = z117 * z1881 - z118 * z2262 + z264 * z726 + z304 * z762 - z305 * z761 - z306 * z1830 - z1786;
    const Scalar z2296 = z117 * z2263 + z118 * z1883 - z264 * z727 + z301 * z761 + z305 * z762 - z307 * z1830 + z1785;
    const Scalar z2297 = s_q6 * z2293 - c_q6 * z2292;
    const Scalar z2298 = s_q6 * z2292 + c_q6 * z2293;
    const Scalar z2299 = s_q6 * z2296 + c_q6 * z2295;
    const Scalar z2300 = s_q6 * z2295 - c_q6 * z2296;
    const Scalar z2301 = s_q5 * z2294 - c_q5 * z2297;
    const Scalar z2302 = s_q5 * z2297 + c_q5 * z2294;
    const Scalar z2303 = s_q5 * z2265 - c_q5 * z2299;
    const Scalar z2304 = s_q5 * z2299 + c_q5 * z2265;
    const Scalar z2305 = n256_over_55 * z2302 + z2303;
    const Scalar z2306 = z2300 - z2302;
    const Scalar z2307 = z2298 + n256_over_55 * z2301 - z2304;
    const Scalar z2308 = s_q4 * z2298 - c_q4 * z2301;
    const Scalar z2309 = s_q4 * z2301 + c_q4 * z2298;
    const Scalar z2310 = s_q4 * z2306 + c_q4 * z2305;
    const Scalar z2311 = s_q4 * z2305 - c_q4 * z2306;
    const Scalar z2312 = z2307 - z2309;
    const Scalar z2313 = z2302 - z2311;
    const Scalar z2314 = s_q3 * z2302 - c_q3 * z2308;
    const Scalar z2315 = s_q3 * z2308 + c_q3 * z2302;
    const Scalar z2316 = s_q3 * z2312 - c_q3 * z2310;
    const Scalar z2317 = s_q3 * z2310 + c_q3 * z2312;
    const Scalar z2318 = n632_over_165 * z2315 - z2316;
    const Scalar z2319 = n632_over_165 * z2314 + z2317;
    const Scalar z2323 = s_q2 * z2318 + c_q2 * z2313;
    const Scalar z2324 = z264 * z1831 + z1878;
    const Scalar z2325 = z264 * z1832 - z1877;
    const Scalar z2326 = z303 * z1831 - k18 * z1832;
    const Scalar z2327 = z304 * z1832 + z305 * z1831 - z1882;
    const Scalar z2328 = z301 * z1831 - z305 * z1832 + z1885;
    const Scalar z2329 = s_q6 * z2325 - c_q6 * z2324;
    const Scalar z2330 = s_q6 * z2324 + c_q6 * z2325;
    const Scalar z2331 = s_q6 * z2328 - c_q6 * z2327;
    const Scalar z2332 = s_q6 * z2327 + c_q6 * z2328;
    const Scalar z2333 = s_q5 * z2326 + c_q5 * z2329;
    const Scalar z2334 = s_q5 * z2329 - c_q5 * z2326;
    const Scalar z2335 = s_q5 * z2266 - c_q5 * z2331;
    const Scalar z2336 = s_q5 * z2331 + c_q5 * z2266;
    const Scalar z2337 = n256_over_55 * z2334 + z2335;
    const Scalar z2338 = z2332 + z2334;
    const Scalar z2339 = z2330 - n256_over_55 * z2333 - z2336;
    const Scalar z2340 = s_q4 * z2330 + c_q4 * z2333;
    const Scalar z2341 = s_q4 * z2333 - c_q4 * z2330;
    const Scalar z2342 = s_q4 * z2338 - c_q4 * z2337;
    const Scalar z2343 = s_q4 * z2337 + c_q4 * z2338;
    const Scalar z2344 = z2339 + z2341;
    const Scalar z2345 = z2334 - z2343;
    const Scalar z2346 = s_q3 * z2334 - c_q3 * z2340;
    const Scalar z2347 = s_q3 * z2340 + c_q3 * z2334;
    const Scalar z2348 = s_q3 * z2344 + c_q3 * z2342;
    const Scalar z2349 = s_q3 * z2342 - c_q3 * z2344;
    const Scalar z2350 = n632_over_165 * z2347 - z2348;
    const Scalar z2351 = n632_over_165 * z2346 - z2349;
    const Scalar z2355 = s_q2 * z2350 + c_q2 * z2345;
    const Scalar z2356 = z1848 - z1852;
    const Scalar z2357 = z1844 - z1852;
    const Scalar z2358 = z1844 + z1848;
    const Scalar z2359 = z137 * z1851 + z138 * z1850 - k0 * z738 + k1 * z739 + k2 * z747 - k3 * z748 - k4 * z1834;
    const Scalar z2360 = k2 * z1835 + k3 * z1836 - z2358;
    const Scalar z2361 = z265 * z1853 + z1861;
    const Scalar z2362 = z264 * z1854 + z2358;
    const Scalar z2363 = z117 * z2362 - z118 * z2361 - z264 * z727 - z266 * z762 - z267 * z1830 + z268 * z761;
    const Scalar z2364 = z266 * z1832 + z268 * z1831 + z1871;
    const Scalar z2365 = s_q6 * z2362 - c_q6 * z2361;
    const Scalar z2366 = s_q6 * z2361 + c_q6 * z2362;
    const Scalar z2367 = z102 * z1871 - z103 * z2365 - z265 * z719 + z267 * z777 - z269 * z720 + z271 * z778 + z272
        * z1826;
    const Scalar z2368 = z267 * z1827 - z271 * z1828 + z2366;
    const Scalar z2369 = s_q5 * z1871 - c_q5 * z2365;
    const Scalar z2370 = s_q5 * z2365 + c_q5 * z1871;
    const Scalar z2371 = z270 * z1919 - z274 * z1825 + z2369;
    const Scalar z2372 = z273 * z1919 + z274 * z1918 + z2366;
    const Scalar z2373 = z270 * z1918 + z273 * z1825 + z2370;
    const Scalar z2374 = z78 * z2372 + z79 * z2371 - z270 * z705 - z273 * z706 - z277 * z790 + z278 * z789 + z279
        * z1822;
    const Scalar z2375 = z277 * z1824 + z278 * z1823 - z2373;
    const Scalar z2376 = s_q4 * z2372 - c_q4 * z2371;
    const Scalar z2377 = s_q4 * z2371 + c_q4 * z2372;
    const Scalar z2378 = z274 * z1820 - z281 * z1821 + z2376;
    const Scalar z2379 = z280 * z1820 + z2373;
    const Scalar z2380 = z280 * z1821 - z2377;
    const Scalar z2381 = z55 * z2379 - z56 * z2378 + z274 * z693 + z280 * z694 - z282 * z804 - z284 * z803 + z285
        * z1818;
    const Scalar z2382 = z282 * z1820 - z284 * z1819 + z2380;
    const Scalar z2383 = s_q3 * z2379 - c_q3 * z2378;
    const Scalar z2384 = s_q3 * z2378 + c_q3 * z2379;
    const Scalar z2385 = z281 * z1995 + z2383;
    const Scalar z2386 = z286 * z1995 - z287 * z1994 + z2380;
    const Scalar z2387 = z281 * z1994 + z2384;
    const Scalar z2388 = z39 * z2386 - z40 * z2385 - z281 * z476 - z285 * z817 - z286 * z477 + z290 * z818 - z291
        * z1814;
    const Scalar z2389 = z285 * z1815 + z290 * z1816 - z2387;
    const Scalar z2391 = s_q2 * z2385 + c_q2 * z2386;
    const Scalar z2392 = z137 * z1843 - z750 - k1 * z1834;
    const Scalar z2393 = z138 * z1843 + z749 + k0 * z1834;
    const Scalar z2394 = z137 * z1841 - z138 * z1842 + k0 * z747 - k1 * z748;
    const Scalar z2395 = z137 * z1845 - z138 * z2356 - k10 * z747 - k8 * z748 - z1782 - k3 * z1834;
    const Scalar z2396 = z137 * z2357 - z138 * z1847 - k10 * z748 - z1781 + k2 * z1834;
    const Scalar z2397 = s_q7 * z2393 + c_q7 * z2392;
    const Scalar z2398 = s_q7 * z2392 - c_q7 * z2393;
    const Scalar z2399 = s_q7 * z2396 + c_q7 * z2395;
    const Scalar z2400 = s_q7 * z2395 - c_q7 * z2396;
    const Scalar z2401 = z2359 + n16_over_15 * z2398;
    const Scalar z2402 = n16_over_15 * z2394 + z2400;
    const Scalar z2403 = s_q6 * z2394 + c_q6 * z2397;
    const Scalar z2404 = s_q6 * z2397 - c_q6 * z2394;
    const Scalar z2405 = s_q6 * z2401 - c_q6 * z2399;
    const Scalar z2406 = s_q6 * z2399 + c_q6 * z2401;
    const Scalar z2407 = s_q5 * z2398 + c_q5 * z2403;
    const Scalar z2408 = s_q5 * z2403 - c_q5 * z2398;
    const Scalar z2409 = s_q5 * z2402 - c_q5 * z2405;
    const Scalar z2410 = s_q5 * z2405 + c_q5 * z2402;
    const Scalar z2411 = n256_over_55 * z2408 + z2409;
    const Scalar z2412 = z2406 + z2408;
    const Scalar z2413 = z2404 + n256_over_55 * z2407 + z2410;
    const Scalar z2414 = s_q4 * z2404 - c_q4 * z2407;
    const Scalar z2415 = s_q4 * z2407 + c_q4 * z2404;
    const Scalar z2416 = s_q4 * z2412 - c_q4 * z2411;
    const Scalar z2417 = s_q4 * z2411 + c_q4 * z2412;
    const Scalar z2418 = z2413 - z2415;
    const Scalar z2419 = z2408 - z2417;
    const Scalar z2420 = s_q3 * z2408 + c_q3 * z2414;
    const Scalar z2421 = s_q3 * z2414 - c_q3 * z2408;
    const Scalar z2422 = s_q3 * z2418 - c_q3 * z2416;
    const Scalar z2423 = s_q3 * z2416 + c_q3 * z2418;
    const Scalar z2424 = n632_over_165 * z2421 - z2422;
    const Scalar z2425 = n632_over_165 * z2420 - z2423;
    const Scalar z2429 = s_q2 * z2424 - c_q2 * z2419;
    const Scalar z2430 = k0 * z1835 + k1 * z1836;
    const Scalar z2431 = k10 * z1835 - k8 * z1836 - z1846;
    const Scalar z2432 = k10 * z1836 - z1849;
    const Scalar z2433 = s_q7 * z2432 - c_q7 * z2431;
    const Scalar z2434 = s_q7 * z2431 + c_q7 * z2432;
    const Scalar z2435 = n16_over_15 * z1855 - z2360;
    const Scalar z2436 = n16_over_15 * z2430 - z2434;
    const Scalar z2437 = s_q6 * z2430 - c_q6 * z1856;
    const Scalar z2438 = s_q6 * z1856 + c_q6 * z2430;
    const Scalar z2439 = s_q6 * z2435 + c_q6 * z2433;
    const Scalar z2440 = s_q6 * z2433 - c_q6 * z2435;
    const Scalar z2441 = s_q5 * z1855 - c_q5 * z2437;
    const Scalar z2442 = s_q5 * z2437 + c_q5 * z1855;
    const Scalar z2443 = s_q5 * z2436 + c_q5 * z2439;
    const Scalar z2444 = s_q5 * z2439 - c_q5 * z2436;
    const Scalar z2445 = n256_over_55 * z2442 + z2443;
    const Scalar z2446 = z2440 + z2442;
    const Scalar z2447 = z2438 + n256_over_55 * z2441 + z2444;
    const Scalar z2448 = s_q4 * z2438 - c_q4 * z2441;
    const Scalar z2449 = s_q4 * z2441 + c_q4 * z2438;
    const Scalar z2450 = s_q4 * z2446 - c_q4 * z2445;
    const Scalar z2451 = s_q4 * z2445 + c_q4 * z2446;
    const Scalar z2452 = z2447 - z2449;
    const Scalar z2453 = z2442 - z2451;
    const Scalar z2454 = s_q3 * z2442 - c_q3 * z2448;
    const Scalar z2455 = s_q3 * z2448 + c_q3 * z2442;
    const Scalar z2456 = s_q3 * z2452 + c_q3 * z2450;
    const Scalar z2457 = s_q3 * z2450 - c_q3 * z2452;
    const Scalar z2458 = n632_over_165 * z2455 - z2456;
    const Scalar z2459 = n632_over_165 * z2454 - z2457;
    const Scalar z2463 = s_q2 * z2458 + c_q2 * z2453;
    const Scalar z2464 = u_tau1 - z1812;
    const Scalar z2465 = u_tau2 - z1807;
    const Scalar z2466 = u_tau3 + z1802;
    const Scalar z2467 = u_tau4 - z1797;
    const Scalar z2468 = u_tau5 + z1792;
    const Scalar z2469 = u_tau6 - z1787;
    const Scalar z2470 = u_tau7 - z754;
    const Scalar z2471 = z1380 * z2391 - z2291;
    const Scalar z2472 = z1379 * z2391 - z1407 * z2471 - z2205;
    const Scalar z2473 = z1378 * z2391 - z1406 * z2471 - z1427 * z2472 + z2138;
    const Scalar z2474 = z1377 * z2391 - z1405 * z2471 - z1426 * z2472 - z1441 * z2473 + z2090;
    const Scalar z2475 = z1376 * z2391 - z1404 * z2471 - z1425 * z2472 - z1440 * z2473 - z1450 * z2474 - z2039;
    const Scalar z2476 = z1375 * z2391 - z1403 * z2471 - z1424 * z2472 - z1439 * z2473 - z1449 * z2474 - z1455 * z2475
        - z2057;
    const Scalar z2477 = z1457 * z2476;
    const Scalar z2478 = z1454 * z2475 - z1455 * z2477;
    const Scalar z2479 = z1448 * z2474 - z1449 * z2477 - z1450 * z2478;
    const Scalar z2480 = z1438 * z2473 - z1439 * z2477 - z1440 * z2478 - z1441 * z2479;
    const Scalar z2481 = z1423 * z2472 - z1424 * z2477 - z1425 * z2478 - z1426 * z2479 - z1427 * z2480;
    const Scalar z2482 = z1402 * z2471 - z1403 * z2477 - z1404 * z2478 - z1405 * z2479 - z1406 * z2480 - z1407 * z2481;
    const Scalar z2483 = z1375 * z2477 + z1376 * z2478 + z1377 * z2479 + z1378 * z2480 + z1379 * z2481 + z1380 * z2482
        - k52 * z2391;
    const Scalar z2484 = z1380 * z2388 + z2288;
    const Scalar z2485 = z1379 * z2388 - z1407 * z2484 - z2202;
    const Scalar z2486 = z1378 * z2388 - z1406 * z2484 - z1427 * z2485 - z2135;
    const Scalar z2487 = z1377 * z2388 - z1405 * z2484 - z1426 * z2485 - z1441 * z2486 - z2087;
    const Scalar z2488 = z1376 * z2388 - z1404 * z2484 - z1425 * z2485 - z1440 * z2486 - z1450 * z2487 - z2061;
    const Scalar z2489 = z1375 * z2388 - z1403 * z2484 - z1424 * z2485 - z1439 * z2486 - z1449 * z2487 - z1455 * z2488
        - z2071;
    const Scalar z2490 = z1457 * z2489;
    const Scalar z2491 = z1454 * z2488 - z1455 * z2490;
    const Scalar z2492 = z1448 * z2487 - z1449 * z2490 - z1450 * z2491;
    const Scalar z2493 = z1438 * z2486 - z1439 * z2490 - z1440 * z2491 - z1441 * z2492;
    const Scalar z2494 = z1423 * z2485 - z1424 * z2490 - z1425 * z2491 - z1426 * z2492 - z1427 * z2493;
    const Scalar z2495 = z1402 * z2484 - z1403 * z2490 - z1404 * z2491 - z1405 * z2492 - z1406 * z2493 - z1407 * z2494;
    const Scalar z2496 = z1375 * z2490 + z1376 * z2491 + z1377 * z2492 + z1378 * z2493 + z1379 * z2494 + z1380 * z2495
        - k52 * z2388;
    const Scalar z2497 = z1380 * z2389 + z2289;
    const Scalar z2498 = z1379 * z2389 - z1407 * z2497 - z2203;
    const Scalar z2499 = z1378 * z2389 - z1406 * z2497 - z1427 * z2498 + z2136;
    const Scalar z2500 = z1377 * z2389 - z1405 * z2497 - z1426 * z2498 - z1441 * z2499 - z2088;
    const Scalar z2501 = z1376 * z2389 - z1404 * z2497 - z1425 * z2498 - z1440 * z2499 - z1450 * z2500 + z2062;
    const Scalar z2502 = z1375 * z2389 - z1403 * z2497 - z1424 * z2498 - z1439 * z2499 - z1449 * z2500 - z1455 * z2501
        - z2080;
    const Scalar z2503 = z1457 * z2502;
    const Scalar z2504 = z1454 * z2501 - z1455 * z2503;
    const Scalar z2505 = z1448 * z2500 - z1449 * z2503 - z1450 * z2504;
    const Scalar z2506 = z1438 * z2499 - z1439 * z2503 - z1440 * z2504 - z1441 * z2505;
    const Scalar z2507 = z1423 * z2498 - z1424 * z2503 - z1425 * z2504 - z1426 * z2505 - z1427 * z2506;
    const Scalar z2508 = z1402 * z2497 - z1403 * z2503 - z1404 * z2504 - z1405 * z2505 - z1406 * z2506 - z1407 * z2507;
    const Scalar z2509 = z1375 * z2503 + z1376 * z2504 + z1377 * z2505 + z1378 * z2506 + z1379 * z2507 + z1380 * z2508
        - k52 * z2389;
    const Scalar z2510 = z1380 * z2381 - z2281;
    const Scalar z2511 = z1379 * z2381 - z1407 * z2510 - z2195;
    const Scalar z2512 = z1378 * z2381 - z1406 * z2510 - z1427 * z2511 - z2128;
    const Scalar z2513 = z1377 * z2381 - z1405 * z2510 - z1426 * z2511 - z1441 * z2512 + z2084;
    const Scalar z2514 = z1376 * z2381 - z1404 * z2510 - z1425 * z2511 - z1440 * z2512 - z1450 * z2513 - z2101;
    const Scalar z2515 = z1375 * z2381 - z1403 * z2510 - z1424 * z2511 - z1439 * z2512 - z1449 * z2513 - z1455 * z2514
        + z2105;
    const Scalar z2516 = z1457 * z2515;
    const Scalar z2517 = z1454 * z2514 - z1455 * z2516;
    const Scalar z2518 = z1448 * z2513 - z1449 * z2516 - z1450 * z2517;
    const Scalar z2519 = z1438 * z2512 - z1439 * z2516 - z1440 * z2517 - z1441 * z2518;
    const Scalar z2520 = z1423 * z2511 - z1424 * z2516 - z1425 * z2517 - z1426 * z2518 - z1427 * z2519;
    const Scalar z2521 = z1402 * z2510 - z1403 * z2516 - z1404 * z2517 - z1405 * z2518 - z1406 * z2519 - z1407 * z2520;
    const Scalar z2522 = z1375 * z2516 + z1376 * z2517 + z1377 * z2518 + z1378 * z2519 + z1379 * z2520 + z1380 * z2521
        - k52 * z2381;
    const Scalar z2523 = z1380 * z2382 - z2282;
    const Scalar z2524 = z1379 * z2382 - z1407 * z2523 - z2196;
    const Scalar z2525 = z1378 * z2382 - z1406 * z2523 - z1427 * z2524 + z2129;
    const Scalar z2526 = z1377 * z2382 - z1405 * z2523 - z1426 * z2524 - z1441 * z2525 + z2085;
    const Scalar z2527 = z1376 * z2382 - z1404 * z2523 - z1425 * z2524 - z1440 * z2525 - z1450 * z2526 - z2116;
    const Scalar z2528 = z1375 * z2382 - z1403 * z2523 - z1424 * z2524 - z1439 * z2525 - z1449 * z2526 - z1455 * z2527
        + z2120;
    const Scalar z2529 = z1457 * z2528;
    const Scalar z2530 = z1454 * z2527 - z1455 * z2529;
    const Scalar z2531 = z1448 * z2526 - z1449 * z2529 - z1450 * z2530;
    const Scalar z2532 = z1438 * z2525 - z1439 * z2529 - z1440 * z2530 - z1441 * z2531;
    const Scalar z2533 = z1423 * z2524 - z1424 * z2529 - z1425 * z2530 - z1426 * z2531 - z1427 * z2532;
    const Scalar z2534 = z1402 * z2523 - z1403 * z2529 - z1404 * z2530 - z1405 * z2531 - z1406 * z2532 - z1407 * z2533;
    const Scalar z2535 = z1375 * z2529 + z1376 * z2530 + z1377 * z2531 + z1378 * z2532 + z1379 * z2533 + z1380 * z2534
        - k52 * z2382;
    const Scalar z2536 = z1380 * z2374 - z2274;
    const Scalar z2537 = z1379 * z2374 - z1407 * z2536 - z2188;
    const Scalar z2538 = z1378 * z2374 - z1406 * z2536 - z1427 * z2537 + z2124;
    const Scalar z2539 = z1377 * z2374 - z1405 * z2536 - z1426 * z2537 - z1441 * z2538 - z2149;
    const Scalar z2540 = z1376 * z2374 - z1404 * z2536 - z1425 * z2537 - z1440 * z2538 - z1450 * z2539 - z2155;
    const Scalar z2541 = z1375 * z2374 - z1403 * z2536 - z1424 * z2537 - z1439 * z2538 - z1449 * z2539 - z1455 * z2540
        - z2159;
    const Scalar z2542 = z1457 * z2541;
    const Scalar z2543 = z1454 * z2540 - z1455 * z2542;
    const Scalar z2544 = z1448 * z2539 - z1449 * z2542 - z1450 * z2543;
    const Scalar z2545 = z1438 * z2538 - z1439 * z2542 - z1440 * z2543 - z1441 * z2544;
    const Scalar z2546 = z1423 * z2537 - z1424 * z2542 - z1425 * z2543 - z1426 * z2544 - z1427 * z2545;
    const Scalar z2547 = z1402 * z2536 - z1403 * z2542 - z1404 * z2543 - z1405 * z2544 - z1406 * z2545 - z1407 * z2546;
    const Scalar z2548 = z1375 * z2542 + z1376 * z2543 + z1377 * z2544 + z1378 * z2545 + z1379 * z2546 + z1380 * z2547
        - k52 * z2374;
    const Scalar z2549 = z1380 * z2375 + z2275;
    const Scalar z2550 = z1379 * z2375 - z1407 * z2549 - z2189;
    const Scalar z2551 = z1378 * z2375 - z1406 * z2549 - z1427 * z2550 - z2125;
    const Scalar z2552 = z1377 * z2375 - z1405 * z2549 - z1426 * z2550 - z1441 * z2551 - z2170;
    const Scalar z2553 = z1376 * z2375 - z1404 * z2549 - z1425 * z2550 - z1440 * z2551 - z1450 * z2552 - z2176;
    const Scalar z2554 = z1375 * z2375 - z1403 * z2549 - z1424 * z2550 - z1439 * z2551 - z1449 * z2552 - z1455 * z2553
        - z2180;
    const Scalar z2555 = z1457 * z2554;
    const Scalar z2556 = z1454 * z2553 - z1455 * z2555;
    const Scalar z2557 = z1448 * z2552 - z1449 * z2555 - z1450 * z2556;
    const Scalar z2558 = z1438 * z2551 - z1439 * z2555 - z1440 * z2556 - z1441 * z2557;
    const Scalar z2559 = z1423 * z2550 - z1424 * z2555 - z1425 * z2556 - z1426 * z2557 - z1427 * z2558;
    const Scalar z2560 = z1402 * z2549 - z1403 * z2555 - z1404 * z2556 - z1405 * z2557 - z1406 * z2558 - z1407 * z2559;
    const Scalar z2561 = z1375 * z2555 + z1376 * z2556 + z1377 * z2557 + z1378 * z2558 + z1379 * z2559 + z1380 * z2560
        - k52 * z2375;
    const Scalar z2562 = z1380 * z2367 - z2267;
    const Scalar z2563 = z1379 * z2367 - z1407 * z2562 + z2184;
    const Scalar z2564 = z1378 * z2367 - z1406 * z2562 - z1427 * z2563 - z2217;
    const Scalar z2565 = z1377 * z2367 - z1405 * z2562 - z1426 * z2563 - z1441 * z2564 + z2223;
    const Scalar z2566 = z1376 * z2367 - z1404 * z2562 - z1425 * z2563 - z1440 * z2564 - z1450 * z2565 + z2229;
    const Scalar z2567 = z1375 * z2367 - z1403 * z2562 - z1424 * z2563 - z1439 * z2564 - z1449 * z2565 - z1455 * z2566
        - z2233;
    const Scalar z2568 = z1457 * z2567;
    const Scalar z2569 = z1454 * z2566 - z1455 * z2568;
    const Scalar z2570 = z1448 * z2565 - z1449 * z2568 - z1450 * z2569;
    const Scalar z2571 = z1438 * z2564 - z1439 * z2568 - z1440 * z2569 - z1441 * z2570;
    const Scalar z2572 = z1423 * z2563 - z1424 * z2568 - z1425 * z2569 - z1426 * z2570 - z1427 * z2571;
    const Scalar z2573 = z1402 * z2562 - z1403 * z2568 - z1404 * z2569 - z1405 * z2570 - z1406 * z2571 - z1407 * z2572;
    const Scalar z2574 = z1375 * z2568 + z1376 * z2569 + z1377 * z2570 + z1378 * z2571 + z1379 * z2572 + z1380 * z2573
        - k52 * z2367;
    const Scalar z2575 = z1380 * z2368 - z2268;
    const Scalar z2576 = z1379 * z2368 - z1407 * z2575 - z2185;
    const Scalar z2577 = z1378 * z2368 - z1406 * z2575 - z1427 * z2576 + z2245;
    const Scalar z2578 = z1377 * z2368 - z1405 * z2575 - z1426 * z2576 - z1441 * z2577 + z2251;
    const Scalar z2579 = z1376 * z2368 - z1404 * z2575 - z1425 * z2576 - z1440 * z2577 - z1450 * z2578 + z2257;
    const Scalar z2580 = z1375 * z2368 - z1403 * z2575 - z1424 * z2576 - z1439 * z2577 - z1449 * z2578 - z1455 * z2579
        + z2261;
    const Scalar z2581 = z1457 * z2580;
    const Scalar z2582 = z1454 * z2579 - z1455 * z2581;
    const Scalar z2583 = z1448 * z2578 - z1449 * z2581 - z1450 * z2582;
    const Scalar z2584 = z1438 * z2577 - z1439 * z2581 - z1440 * z2582 - z1441 * z2583;
    const Scalar z2585 = z1423 * z2576 - z1424 * z2581 - z1425 * z2582 - z1426 * z2583 - z1427 * z2584;
    const Scalar z2586 = z1402 * z2575 - z1403 * z2581 - z1404 * z2582 - z1405 * z2583 - z1406 * z2584 - z1407 * z2585;
    const Scalar z2587 = z1375 * z2581 + z1376 * z2582 + z1377 * z2583 + z1378 * z2584 + z1379 * z2585 + z1380 * z2586
        - k52 * z2368;
    const Scalar z2588 = z1380 * z2363 - z2265;
    const Scalar z2589 = z1379 * z2363 - z1407 * z2588 - z2300;
    const Scalar z2590 = z1378 * z2363 - z1406 * z2588 - z1427 * z2589 - z2307;
    const Scalar z2591 = z1377 * z2363 - z1405 * z2588 - z1426 * z2589 - z1441 * z2590 + z2313;
    const Scalar z2592 = z1376 * z2363 - z1404 * z2588 - z1425 * z2589 - z1440 * z2590 - z1450 * z2591 + z2319;
    const Scalar z2593 = z1375 * z2363 - z1403 * z2588 - z1424 * z2589 - z1439 * z2590 - z1449 * z2591 - z1455 * z2592
        - z2323;
    const Scalar z2594 = z1457 * z2593;
    const Scalar z2595 = z1454 * z2592 - z1455 * z2594;
    const Scalar z2596 = z1448 * z2591 - z1449 * z2594 - z1450 * z2595;
    const Scalar z2597 = z1438 * z2590 - z1439 * z2594 - z1440 * z2595 - z1441 * z2596;
    const Scalar z2598 = z1423 * z2589 - z1424 * z2594 - z1425 * z2595 - z1426 * z2596 - z1427 * z2597;
    const Scalar z2599 = z1402 * z2588 - z1403 * z2594 - z1404 * z2595 - z1405 * z2596 - z1406 * z2597 - z1407 * z2598;
    const Scalar z2600 = z1375 * z2594 + z1376 * z2595 + z1377 * z2596 + z1378 * z2597 + z1379 * z2598 + z1380 * z2599
        - k52 * z2363;
    const Scalar z2601 = z1380 * z2364 - z2266;
    const Scalar z2602 = z1379 * z2364 - z1407 * z2601 + z2332;
    const Scalar z2603 = z1378 * z2364 - z1406 * z2601 - z1427 * z2602 - z2339;
    const Scalar z2604 = z1377 * z2364 - z1405 * z2601 - z1426 * z2602 - z1441 * z2603 + z2345;
    const Scalar z2605 = z1376 * z2364 - z1404 * z2601 - z1425 * z2602 - z1440 * z2603 - z1450 * z2604 + z2351;
    const Scalar z2606 = z1375 * z2364 - z1403 * z2601 - z1424 * z2602 - z1439 * z2603 - z1449 * z2604 - z1455 * z2605
        - z2355;
    const Scalar z2607 = z1457 * z2606;
    const Scalar z2608 = z1454 * z2605 - z1455 * z2607;
    const Scalar z2609 = z1448 * z2604 - z1449 * z2607 - z1450 * z2608;
    const Scalar z2610 = z1438 * z2603 - z1439 * z2607 - z1440 * z2608 - z1441 * z2609;
    const Scalar z2611 = z1423 * z2602 - z1424 * z2607 - z1425 * z2608 - z1426 * z2609 - z1427 * z2610;
    const Scalar z2612 = z1402 * z2601 - z1403 * z2607 - z1404 * z2608 - z1405 * z2609 - z1406 * z2610 - z1407 * z2611;
    const Scalar z2613 = z1375 * z2607 + z1376 * z2608 + z1377 * z2609 + z1378 * z2610 + z1379 * z2611 + z1380 * z2612
        - k52 * z2364;
    const Scalar z2614 = z1380 * z2359 - z2402;
    const Scalar z2615 = z1379 * z2359 - z1407 * z2614 + z2406;
    const Scalar z2616 = z1378 * z2359 - z1406 * z2614 - z1427 * z2615 + z2413;
    const Scalar z2617 = z1377 * z2359 - z1405 * z2614 - z1426 * z2615 - z1441 * z2616 + z2419;
    const Scalar z2618 = z1376 * z2359 - z1404 * z2614 - z1425 * z2615 - z1440 * z2616 - z1450 * z2617 + z2425;
    const Scalar z2619 = z1375 * z2359 - z1403 * z2614 - z1424 * z2615 - z1439 * z2616 - z1449 * z2617 - z1455 * z2618
        + z2429;
    const Scalar z2620 = z1457 * z2619;
    const Scalar z2621 = z1454 * z2618 - z1455 * z2620;
    const Scalar z2622 = z1448 * z2617 - z1449 * z2620 - z1450 * z2621;
    const Scalar z2623 = z1438 * z2616 - z1439 * z2620 - z1440 * z2621 - z1441 * z2622;
    const Scalar z2624 = z1423 * z2615 - z1424 * z2620 - z1425 * z2621 - z1426 * z2622 - z1427 * z2623;
    const Scalar z2625 = z1402 * z2614 - z1403 * z2620 - z1404 * z2621 - z1405 * z2622 - z1406 * z2623 - z1407 * z2624;
    const Scalar z2626 = z1375 * z2620 + z1376 * z2621 + z1377 * z2622 + z1378 * z2623 + z1379 * z2624 + z1380 * z2625
        - k52 * z2359;
    const Scalar z2627 = z1380 * z2360 - z2436;
    const Scalar z2628 = z1379 * z2360 - z1407 * z2627 + z2440;
    const Scalar z2629 = z1378 * z2360 - z1406 * z2627 - z1427 * z2628 - z2447;
    const Scalar z2630 = z1377 * z2360 - z1405 * z2627 - z1426 * z2628 - z1441 * z2629 + z2453;
    const Scalar z2631 = z1376 * z2360 - z1404 * z2627 - z1425 * z2628 - z1440 * z2629 - z1450 * z2630 + z2459;
    const Scalar z2632 = z1375 * z2360 - z1403 * z2627 - z1424 * z2628 - z1439 * z2629 - z1449 * z2630 - z1455 * z2631
        - z2463;
    const Scalar z2633 = z1457 * z2632;
    const Scalar z2634 = z1454 * z2631 - z1455 * z2633;
    const Scalar z2635 = z1448 * z2630 - z1449 * z2633 - z1450 * z2634;
    const Scalar z2636 = z1438 * z2629 - z1439 * z2633 - z1440 * z2634 - z1441 * z2635;
    const Scalar z2637 = z1423 * z2628 - z1424 * z2633 - z1425 * z2634 - z1426 * z2635 - z1427 * z2636;
    const Scalar z2638 = z1402 * z2627 - z1403 * z2633 - z1404 * z2634 - z1405 * z2635 - z1406 * z2636 - z1407 * z2637;
    const Scalar z2639 = z1375 * z2633 + z1376 * z2634 + z1377 * z2635 + z1378 * z2636 + z1379 * z2637 + z1380 * z2638
        - k52 * z2360;
    const Scalar z2640 = z1455 * z1457;
    const Scalar z2641 = z1449 * z1457 - z1450 * z2640;
    const Scalar z2642 = z1439 * z1457 - z1440 * z2640 - z1441 * z2641;
    const Scalar z2643 = z1424 * z1457 - z1425 * z2640 - z1426 * z2641 - z1427 * z2642;
    const Scalar z2644 = z1403 * z1457 - z1404 * z2640 - z1405 * z2641 - z1406 * z2642 - z1407 * z2643;
    const Scalar z2645 = z1375 * z1457 - z1376 * z2640 - z1377 * z2641 - z1378 * z2642 - z1379 * z2643 - z1380 * z2644;
    const Scalar z2646 = z1454 + z1455 * z2640;
    const Scalar z2647 = z1449 * z2640 - z1450 * z2646;
    const Scalar z2648 = z1439 * z2640 - z1440 * z2646 - z1441 * z2647;
    const Scalar z2649 = z1424 * z2640 - z1425 * z2646 - z1426 * z2647 - z1427 * z2648;
    const Scalar z2650 = z1403 * z2640 - z1404 * z2646 - z1405 * z2647 - z1406 * z2648 - z1407 * z2649;
    const Scalar z2651 = z1375 * z2640 - z1376 * z2646 - z1377 * z2647 - z1378 * z2648 - z1379 * z2649 - z1380 * z2650;
    const Scalar z2652 = z1449 - z1450 * z1455;
    const Scalar z2653 = z1457 * z2652;
    const Scalar z2654 = z1450 * z1454 - z1455 * z2653;
    const Scalar z2655 = z1448 + z1449 * z2653 + z1450 * z2654;
    const Scalar z2656 = z1439 * z2653 + z1440 * z2654 - z1441 * z2655;
    const Scalar z2657 = z1424 * z2653 + z1425 * z2654 - z1426 * z2655 - z1427 * z2656;
    const Scalar z2658 = z1403 * z2653 + z1404 * z2654 - z1405 * z2655 - z1406 * z2656 - z1407 * z2657;
    const Scalar z2659 = z1375 * z2653 + z1376 * z2654 - z1377 * z2655 - z1378 * z2656 - z1379 * z2657 - z1380 * z2658;
    const Scalar z2660 = z1440 - z1441 * z1450;
    const Scalar z2661 = z1439 - z1441 * z1449 - z1455 * z2660;
    const Scalar z2662 = z1457 * z2661;
    const Scalar z2663 = z1454 * z2660 - z1455 * z2662;
    const Scalar z2664 = z1441 * z1448 - z1449 * z2662 - z1450 * z2663;
    const Scalar z2665 = z1438 + z1439 * z2662 + z1440 * z2663 + z1441 * z2664;
    const Scalar z2666 = z1424 * z2662 + z1425 * z2663 + z1426 * z2664 - z1427 * z2665;
    const Scalar z2667 = z1403 * z2662 + z1404 * z2663 + z1405 * z2664 - z1406 * z2665 - z1407 * z2666;
    const Scalar z2668 = z1375 * z2662 + z1376 * z2663 + z1377 * z2664 - z1378 * z2665 - z1379 * z2666 - z1380 * z2667;
    const Scalar z2669 = z1426 - z1427 * z1441;
    const Scalar z2670 = z1425 - z1427 * z1440 - z1450 * z2669;
    const Scalar z2671 = z1424 - z1427 * z1439 - z1449 * z2669 - z1455 * z2670;
    const Scalar z2672 = z1457 * z2671;
    const Scalar z2673 = z1454 * z2670 - z1455 * z2672;
    const Scalar z2674 = z1448 * z2669 - z1449 * z2672 - z1450 * z2673;
    const Scalar z2675 = z1427 * z1438 - z1439 * z2672 - z1440 * z2673 - z1441 * z2674;
    const Scalar z2676 = z1423 + z1424 * z2672 + z1425 * z2673 + z1426 * z2674 + z1427 * z2675;
    const Scalar z2677 = z1403 * z2672 + z1404 * z2673 + z1405 * z2674 + z1406 * z2675 - z1407 * z2676;
    const Scalar z2678 = z1375 * z2672 + z1376 * z2673 + z1377 * z2674 + z1378 * z2675 - z1379 * z2676 - z1380 * z2677;
    const Scalar z2679 = z1406 - z1407 * z1427;
    const Scalar z2680 = z1405 - z1407 * z1426 - z1441 * z2679;
    const Scalar z2681 = z1404 - z1407 * z1425 - z1440 * z2679 - z1450 * z2680;
    const Scalar z2682 = z1403 - z1407 * z1424 - z1439 * z2679 - z1449 * z2680 - z1455 * z2681;
    const Scalar z2683 = z1457 * z2682;
    const Scalar z2684 = z1454 * z2681 - z1455 * z2683;
    const Scalar z2685 = z1448 * z2680 - z1449 * z2683 - z1450 * z2684;
    const Scalar z2686 = z1438 * z2679 - z1439 * z2683 - z1440 * z2684 - z1441 * z2685;
    const Scalar z2687 = z1407 * z1423 - z1424 * z2683 - z1425 * z2684 - z1426 * z2685 - z1427 * z2686;
    const Scalar z2688 = z1402 + z1403 * z2683 + z1404 * z2684 + z1405 * z2685 + z1406 * z2686 + z1407 * z2687;
    const Scalar z2689 = z1375 * z2683 + z1376 * z2684 + z1377 * z2685 + z1378 * z2686 + z1379 * z2687 - z1380 * z2688;
    const Scalar z2690 = z1379 - z1380 * z1407;
    const Scalar z2691 = z1378 - z1380 * z1406 - z1427 * z2690;
    const Scalar z2692 = z1377 - z1380 * z1405 - z1426 * z2690 - z1441 * z2691;
    const Scalar z2693 = z1376 - z1380 * z1404 - z1425 * z2690 - z1440 * z2691 - z1450 * z2692;
    const Scalar z2694 = z1375 - z1380 * z1403 - z1424 * z2690 - z1439 * z2691 - z1449 * z2692 - z1455 * z2693;
    const Scalar z2695 = z1457 * z2694;
    const Scalar z2696 = z1454 * z2693 - z1455 * z2695;
    const Scalar z2697 = z1448 * z2692 - z1449 * z2695 - z1450 * z2696;
    const Scalar z2698 = z1438 * z2691 - z1439 * z2695 - z1440 * z2696 - z1441 * z2697;
    const Scalar z2699 = z1423 * z2690 - z1424 * z2695 - z1425 * z2696 - z1426 * z2697 - z1427 * z2698;
    const Scalar z2700 = z1380 * z1402 - z1403 * z2695 - z1404 * z2696 - z1405 * z2697 - z1406 * z2698 - z1407 * z2699;
    const Scalar z2701 = k52 - z1375 * z2695 - z1376 * z2696 - z1377 * z2697 - z1378 * z2698 - z1379 * z2699 - z1380
        * z2700;
    result.M[0] = z468;
    result.M[1] = -z454;
    result.M[2] = -z434;
    result.M[3] = z406;
    result.M[4] = z372;
    result.M[5] = -z335;
    result.M[6] = z295;
    result.M[7] = -z454;
    result.M[8] = z450;
    result.M[9] = -z430;
    result.M[10] = z402;
    result.M[11] = z368;
    result.M[12] = z331;
    result.M[13] = z291;
    result.M[14] = -z434;
    result.M[15] = -z430;
    result.M[16] = z424;
    result.M[17] = z395;
    result.M[18] = -z362;
    result.M[19] = -z325;
    result.M[20] = -z285;
    result.M[21] = z406;
    result.M[22] = z402;
    result.M[23] = z395;
    result.M[24] = z391;
    result.M[25] = -z356;
    result.M[26] = -z319;
    result.M[27] = z279;
    result.M[28] = z372;
    result.M[29] = z368;
    result.M[30] = -z362;
    result.M[31] = -z356;
    result.M[32] = z349;
    result.M[33] = -z312;
    result.M[34] = z272;
    result.M[35] = -z335;
    result.M[36] = z331;
    result.M[37] = -z325;
    result.M[38] = -z319;
    result.M[39] = -z312;
    result.M[40] = z308;
    result.M[41] = -z267;
    result.M[42] = z295;
    result.M[43] = z291;
    result.M[44] = -z285;
    result.M[45] = z279;
    result.M[46] = z272;
    result.M[47] = -z267;
    result.M[48] = k4;
    result.C[0] = -z2057;
    result.C[1] = -z2039;
    result.C[2] = -z2090;
    result.C[3] = z2138;
    result.C[4] = -z2205;
    result.C[5] = z2291;
    result.C[6] = -z2391;
    result.C[7] = z2080;
    result.C[8] = -z2062;
    result.C[9] = -z2088;
    result.C[10] = -z2136;
    result.C[11] = z2203;
    result.C[12] = z2289;
    result.C[13] = z2389;
    result.C[14] = z2120;
    result.C[15] = -z2116;
    result.C[16] = -z2085;
    result.C[17] = z2129;
    result.C[18] = -z2196;
    result.C[19] = z2282;
    result.C[20] = -z2382;
    result.C[21] = -z2180;
    result.C[22] = -z2176;
    result.C[23] = z2170;
    result.C[24] = -z2125;
    result.C[25] = -z2189;
    result.C[26] = -z2275;
    result.C[27] = -z2375;
    result.C[28] = -z2261;
    result.C[29] = -z2257;
    result.C[30] = z2251;
    result.C[31] = -z2245;
    result.C[32] = z2185;
    result.C[33] = -z2268;
    result.C[34] = z2368;
    result.C[35] = z2355;
    result.C[36] = -z2351;
    result.C[37] = z2345;
    result.C[38] = z2339;
    result.C[39] = -z2332;
    result.C[40] = -z2266;
    result.C[41] = z2364;
    result.C[42] = z2463;
    result.C[43] = -z2459;
    result.C[44] = z2453;
    result.C[45] = z2447;
    result.C[46] = -z2440;
    result.C[47] = -z2436;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z2071;
    result.K[8] = z2061;
    result.K[9] = -z2087;
    result.K[10] = z2135;
    result.K[11] = z2202;
    result.K[12] = z2288;
    result.K[13] = z2388;
    result.K[14] = -z2105;
    result.K[15] = z2101;
    result.K[16] = z2084;
    result.K[17] = z2128;
    result.K[18] = z2195;
    result.K[19] = -z2281;
    result.K[20] = z2381;
    result.K[21] = -z2159;
    result.K[22] = -z2155;
    result.K[23] = z2149;
    result.K[24] = z2124;
    result.K[25] = -z2188;
    result.K[26] = z2274;
    result.K[27] = -z2374;
    result.K[28] = -z2233;
    result.K[29] = z2229;
    result.K[30] = -z2223;
    result.K[31] = -z2217;
    result.K[32] = z2184;
    result.K[33] = z2267;
    result.K[34] = -z2367;
    result.K[35] = -z2323;
    result.K[36] = z2319;
    result.K[37] = -z2313;
    result.K[38] = -z2307;
    result.K[39] = -z2300;
    result.K[40] = z2265;
    result.K[41] = -z2363;
    result.K[42] = -z2429;
    result.K[43] = -z2425;
    result.K[44] = z2419;
    result.K[45] = -z2413;
    result.K[46] = -z2406;
    result.K[47] = -z2402;
    result.K[48] = z2359;
    result.F[0] = z2464;
    result.F[1] = z2465;
    result.F[2] = z2466;
    result.F[3] = z2467;
    result.F[4] = z2468;
    result.F[5] = z2469;
    result.F[6] = z2470;
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
    result.A[21] = -z2490;
    result.A[22] = -z2491;
    result.A[23] = z2492;
    result.A[24] = -z2493;
    result.A[25] = -z2494;
    result.A[26] = z2495;
    result.A[27] = z2496;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = -z2516;
    result.A[36] = -z2517;
    result.A[37] = z2518;
    result.A[38] = -z2519;
    result.A[39] = -z2520;
    result.A[40] = z2521;
    result.A[41] = z2522;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z2542;
    result.A[50] = z2543;
    result.A[51] = -z2544;
    result.A[52] = z2545;
    result.A[53] = z2546;
    result.A[54] = -z2547;
    result.A[55] = -z2548;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z2568;
    result.A[64] = z2569;
    result.A[65] = -z2570;
    result.A[66] = z2571;
    result.A[67] = z2572;
    result.A[68] = -z2573;
    result.A[69] = -z2574;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = z2594;
    result.A[78] = z2595;
    result.A[79] = -z2596;
    result.A[80] = z2597;
    result.A[81] = z2598;
    result.A[82] = -z2599;
    result.A[83] = -z2600;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = -z2620;
    result.A[92] = -z2621;
    result.A[93] = z2622;
    result.A[94] = -z2623;
    result.A[95] = -z2624;
    result.A[96] = z2625;
    result.A[97] = z2626;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = z2477;
    result.A[106] = z2478;
    result.A[107] = -z2479;
    result.A[108] = z2480;
    result.A[109] = z2481;
    result.A[110] = -z2482;
    result.A[111] = -z2483;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = -z2503;
    result.A[120] = -z2504;
    result.A[121] = z2505;
    result.A[122] = -z2506;
    result.A[123] = -z2507;
    result.A[124] = z2508;
    result.A[125] = z2509;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = z2529;
    result.A[134] = z2530;
    result.A[135] = -z2531;
    result.A[136] = z2532;
    result.A[137] = z2533;
    result.A[138] = -z2534;
    result.A[139] = -z2535;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z2555;
    result.A[148] = z2556;
    result.A[149] = -z2557;
    result.A[150] = z2558;
    result.A[151] = z2559;
    result.A[152] = -z2560;
    result.A[153] = -z2561;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z2581;
    result.A[162] = -z2582;
    result.A[163] = z2583;
    result.A[164] = -z2584;
    result.A[165] = -z2585;
    result.A[166] = z2586;
    result.A[167] = z2587;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z2607;
    result.A[176] = -z2608;
    result.A[177] = z2609;
    result.A[178] = -z2610;
    result.A[179] = -z2611;
    result.A[180] = z2612;
    result.A[181] = z2613;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z2633;
    result.A[190] = -z2634;
    result.A[191] = z2635;
    result.A[192] = -z2636;
    result.A[193] = -z2637;
    result.A[194] = z2638;
    result.A[195] = z2639;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z1457;
    result.B[8] = z2640;
    result.B[9] = -z2641;
    result.B[10] = z2642;
    result.B[11] = z2643;
    result.B[12] = -z2644;
    result.B[13] = z2645;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z2640;
    result.B[22] = -z2646;
    result.B[23] = z2647;
    result.B[24] = -z2648;
    result.B[25] = -z2649;
    result.B[26] = z2650;
    result.B[27] = -z2651;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z2653;
    result.B[36] = -z2654;
    result.B[37] = -z2655;
    result.B[38] = z2656;
    result.B[39] = z2657;
    result.B[40] = -z2658;
    result.B[41] = z2659;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z2662;
    result.B[50] = z2663;
    result.B[51] = -z2664;
    result.B[52] = -z2665;
    result.B[53] = -z2666;
    result.B[54] = z2667;
    result.B[55] = -z2668;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z2672;
    result.B[64] = z2673;
    result.B[65] = -z2674;
    result.B[66] = z2675;
    result.B[67] = -z2676;
    result.B[68] = z2677;
    result.B[69] = -z2678;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z2683;
    result.B[78] = -z2684;
    result.B[79] = z2685;
    result.B[80] = -z2686;
    result.B[81] = -z2687;
    result.B[82] = -z2688;
    result.B[83] = z2689;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z2695;
    result.B[92] = z2696;
    result.B[93] = -z2697;
    result.B[94] = z2698;
    result.B[95] = z2699;
    result.B[96] = -z2700;
    result.B[97] = z2701;
    if (!(traits::regular(-z1456, z468) && traits::regular(-z1453, z450) && traits::regular(-z1447, z424)
        && traits::regular(-z1437, z391) && traits::regular(-z1422, z349) && traits::regular(-z1401,
        z308))) return torsor::Status::singular;
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
