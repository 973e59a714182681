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
//   mass_matrix               9                7          0             0                  3       0     22      24
//   bias                     20               35          1             1                  4       0     65      87
//   inverse_dynamics         73               98          1             1                  7       0    187     222
//   forward_dynamics        236              356         12             1                  7       0    619     661
//   energy                   29               50          0             1                  4       0     88      94
//   constraints              87              142          0             0                  7       0    243     249
//   linearisation           554              773         20             1                  7       0   1362    1495
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
    const Scalar k0 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k1 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k3 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k4 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k5 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k6 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k9 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k11 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
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
    const Scalar z184 = k1 - z182;
    const Scalar z191 = k1 - n2 * z182;
    const Scalar z196 = k3 + z191;
    const Scalar z198 = k0 * s_Phi;
    const Scalar z199 = k1 + z198;
    const Scalar z206 = k1 + n2 * z198;
    const Scalar z211 = k4 + z206;
    const Scalar z213 = k5 * c_Theta;
    const Scalar z214 = k6 - n0_175 * z213;
    const Scalar z221 = k6 - n0_35 * z213;
    const Scalar z224 = k9 + z221;
    mass[0] = z224;
    mass[1] = z214;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = z214;
    mass[8] = k6;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k11;
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
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k12 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k13 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
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
    const Scalar z240 = n0_175 * z239;
    const Scalar z242 = s_Theta * z240;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z244 = c_Phi * z243;
    const Scalar z246 = v_epsilon * v_epsilon;
    const Scalar z248 = c_Omega * z246;
    const Scalar z249 = z46 * z46;
    const Scalar z250 = k12 * z249;  // force on K6, times 0.04 m, x
    const Scalar z251 = k12 * z248;  // moment on K6, z
    const Scalar z252 = c_Omega * z250;
    const Scalar z256 = z251 - z252;  // moment on K7, z
    const Scalar z257 = z42 * z42;
    const Scalar z258 = k12 * z257;  // force on K4, times 0.04 m, y
    const Scalar z259 = k12 * z244;  // moment on K4, z
    const Scalar z261 = c_Phi * z258;
    const Scalar z264 = z259 - z261;  // moment on K5, z
    const Scalar z268 = z38 * z38;
    const Scalar z269 = k13 * z268;  // force on K2, times 0.04 m, x
    const Scalar z270 = k13 * z242;  // moment on K2, z
    const Scalar z272 = s_Theta * z269;
    const Scalar z274 = n0_033 + z270 - n0_175 * z272;  // moment on K1, z
    forces.beta = -z274;
    forces.Theta = -z270;
    forces.gamma = z238;
    forces.Phi = -z259;
    forces.delta = -z264;
    forces.Omega = z251;
    forces.epsilon = z256;
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
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k16 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k17 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k18 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k19 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k20 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k21 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar k22 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k24 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
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
    const Scalar z240 = n0_175 * z239;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z246 = v_epsilon * v_epsilon;
    const Scalar z249 = z46 * z46;
    const Scalar z250 = k16 * z249;  // force on K6, times 0.04 m, x
    const Scalar z257 = z42 * z42;
    const Scalar z258 = k16 * z257;  // force on K4, times 0.04 m, y
    const Scalar z268 = z38 * z38;
    const Scalar z269 = k17 * z268;  // force on K2, times 0.04 m, x
    const Scalar z275 = n0_175 * a_beta;
    const Scalar z277 = s_Theta * z240 + c_Theta * z275;
    const Scalar z278 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z279 = a_delta * s_Phi - c_Phi * z243;
    const Scalar z281 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z283 = a_epsilon * s_Omega - c_Omega * z246;
    const Scalar z284 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z285 = k16 * z284;  // force on K6, times 0.04 m, y
    const Scalar z286 = k16 * z283 - k18 * z284;  // moment on K6, z
    const Scalar z287 = s_Omega * z285 + c_Omega * z250;
    const Scalar z291 = k19 * a_epsilon - z286 - z287;  // moment on K7, z
    const Scalar z292 = k16 * z281;  // force on K4, times 0.04 m, x
    const Scalar z293 = k16 * z279 + k18 * z281;  // moment on K4, z
    const Scalar z295 = s_Phi * z292 + c_Phi * z258;
    const Scalar z298 = k20 * a_delta + z293 + z295;  // moment on K5, z
    const Scalar z301 = k21 * a_gamma + z238;  // moment on K3, z
    const Scalar z302 = k17 * z278;  // force on K2, times 0.04 m, y
    const Scalar z303 = k17 * z277 - k22 * z278;  // moment on K2, z
    const Scalar z305 = s_Theta * z269 - c_Theta * z302;
    const Scalar z308 = n0_033 - k24 * a_beta + z303 - n0_175 * z305;  // moment on K1, z
    const Scalar z321 = s_beta * z123 + c_beta * z124;
    const Scalar z336 = s_beta * z124 - c_beta * z123;
    const Scalar z351 = s_delta * z144 - c_delta * z145;
    const Scalar z362 = s_delta * z145 + c_delta * z144;
    const Scalar z375 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z386 = s_epsilon * z163 - c_epsilon * z162;
    forces.beta = -z126 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z127 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z308;
    forces.Theta = -z321 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z336 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) - z303;
    forces.gamma = z135 * l_lambda_E3_y + z136 * l_lambda_E3_x + z301;
    forces.Phi = z293 - z351 * l_lambda_E4_x + z362 * l_lambda_E4_y;
    forces.delta = z147 * l_lambda_E4_y - z148 * l_lambda_E4_x + z298;
    forces.Omega = -z286 - z375 * l_lambda_E6_x - z386 * l_lambda_E6_y;
    forces.epsilon = z165 * l_lambda_E6_y - z166 * l_lambda_E6_x + z291;
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
    const Scalar k8 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k11 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k12 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k13 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k14 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k17 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k20 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k21 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k26 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k27 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
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
    const Scalar z184 = k9 - z182;
    const Scalar z191 = k9 - n2 * z182;
    const Scalar z196 = k11 + z191;
    const Scalar z198 = k8 * s_Phi;
    const Scalar z199 = k9 + z198;
    const Scalar z206 = k9 + n2 * z198;
    const Scalar z211 = k12 + z206;
    const Scalar z213 = k13 * c_Theta;
    const Scalar z214 = k14 - n0_175 * z213;
    const Scalar z221 = k14 - n0_35 * z213;
    const Scalar z224 = k17 + z221;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z227 = k20 * s_gamma + k21 * c_gamma;
    const Scalar z228 = k21 * s_gamma - k20 * c_gamma;
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
    const Scalar z240 = n0_175 * z239;
    const Scalar z242 = s_Theta * z240;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z244 = c_Phi * z243;
    const Scalar z246 = v_epsilon * v_epsilon;
    const Scalar z248 = c_Omega * z246;
    const Scalar z249 = z46 * z46;
    const Scalar z250 = k8 * z249;  // force on K6, times 0.04 m, x
    const Scalar z251 = k8 * z248;  // moment on K6, z
    const Scalar z252 = c_Omega * z250;
    const Scalar z256 = z251 - z252;  // moment on K7, z
    const Scalar z257 = z42 * z42;
    const Scalar z258 = k8 * z257;  // force on K4, times 0.04 m, y
    const Scalar z259 = k8 * z244;  // moment on K4, z
    const Scalar z261 = c_Phi * z258;
    const Scalar z264 = z259 - z261;  // moment on K5, z
    const Scalar z268 = z38 * z38;
    const Scalar z269 = k13 * z268;  // force on K2, times 0.04 m, x
    const Scalar z270 = k13 * z242;  // moment on K2, z
    const Scalar z272 = s_Theta * z269;
    const Scalar z274 = n0_033 + z270 - n0_175 * z272;  // moment on K1, z
    const Scalar z311 = v_beta * c_beta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z313 = n0_028 * z312;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z316 = n0_028 * z315;
    const Scalar z318 = v_gamma * c_gamma;
    const Scalar z321 = s_beta * z123 + c_beta * z124;
    const Scalar z322 = v_Theta * z315;
    const Scalar z323 = n0_028 * z322;
    const Scalar z324 = v_Theta * z312;
    const Scalar z325 = n0_028 * z324;
    const Scalar z326 = v_beta * z314;
    const Scalar z327 = v_beta * z311;
    const Scalar z328 = -n2 * (z311 * z313 - z314 * z316) + s_beta * z323 - c_beta * z325 + z124 * z326 + z125 * z327;
    const Scalar z329 = v_gamma * s_gamma;
    const Scalar z330 = v_gamma * z329;
    const Scalar z331 = n0_035 * z330;
    const Scalar z332 = z328 - z331;
    const Scalar z336 = s_beta * z124 - c_beta * z123;
    const Scalar z337 = n2 * (z311 * z316 + z313 * z314) + s_beta * z325 + c_beta * z323 + z124 * z327 - z125 * z326;
    const Scalar z338 = v_gamma * z318;
    const Scalar z339 = n0_035 * z338;
    const Scalar z340 = z337 - z339;
    const Scalar z343 = v_delta * c_delta;
    const Scalar z344 = v_Phi * s_Phi;
    const Scalar z345 = n0_02 * z344;
    const Scalar z346 = v_delta * s_delta;
    const Scalar z347 = v_Phi * c_Phi;
    const Scalar z348 = n0_02 * z347;
    const Scalar z351 = s_delta * z144 - c_delta * z145;
    const Scalar z352 = v_Phi * z347;
    const Scalar z353 = n0_02 * z352;
    const Scalar z354 = v_Phi * z344;
    const Scalar z355 = n0_02 * z354;
    const Scalar z356 = v_delta * z346;
    const Scalar z357 = v_delta * z343;
    const Scalar z358 = n2 * (z343 * z345 + z346 * z348) + s_delta * z353 + c_delta * z355 + z145 * z356 + z146 * z357;
    const Scalar z359 = z328 - z358;
    const Scalar z362 = s_delta * z145 + c_delta * z144;
    const Scalar z363 = -n2 * (z343 * z348 - z345 * z346) + s_delta * z355 - c_delta * z353 - z145 * z357 + z146 * z356;
    const Scalar z364 = z337 + z363;
    const Scalar z367 = v_epsilon * c_epsilon;
    const Scalar z368 = v_Omega * c_Omega;
    const Scalar z369 = n0_02 * z368;
    const Scalar z370 = v_epsilon * s_epsilon;
    const Scalar z371 = v_Omega * s_Omega;
    const Scalar z372 = n0_02 * z371;
    const Scalar z375 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z376 = v_Omega * z371;
    const Scalar z377 = n0_02 * z376;
    const Scalar z378 = v_Omega * z368;
    const Scalar z379 = n0_02 * z378;
    const Scalar z380 = v_epsilon * z367;
    const Scalar z381 = v_epsilon * z370;
    const Scalar z382 = -n2 * (z367 * z369 - z370 * z372) + s_epsilon * z377 - c_epsilon * z379 - z162 * z380 - z164
        * z381;
    const Scalar z383 = z328 + z382;
    const Scalar z386 = s_epsilon * z163 - c_epsilon * z162;
    const Scalar z387 = n2 * (z367 * z372 + z369 * z370) + s_epsilon * z379 + c_epsilon * z377 + z162 * z381 - z164
        * z380;
    const Scalar z388 = z337 + z387;
    const Scalar z395 = n1 / z196;
    const Scalar z396 = z184 * z395;
    const Scalar z397 = k9 - z184 * z396;
    const Scalar z398 = n1 / z397;
    const Scalar z399 = n1 / z211;
    const Scalar z400 = z199 * z399;
    const Scalar z401 = k9 - z199 * z400;
    const Scalar z402 = n1 / z401;
    const Scalar z403 = k26 * z214;
    const Scalar z404 = z214 * z403 - z224;
    const Scalar z405 = n1 / z404;
    const Scalar z406 = z127 + z321 * z403;
    const Scalar z407 = z405 * z406;
    const Scalar z408 = k26 * z321 - z403 * z407;
    const Scalar z409 = k27 * z136;
    const Scalar z410 = z126 - z336 * z403;
    const Scalar z411 = z405 * z410;
    const Scalar z412 = k26 * z336 + z403 * z411;
    const Scalar z413 = k27 * z135;
    const Scalar z414 = z148 * z400 - z351;
    const Scalar z415 = z402 * z414;
    const Scalar z416 = z148 * z399 + z400 * z415;
    const Scalar z417 = z147 * z400 - z362;
    const Scalar z418 = z402 * z417;
    const Scalar z419 = z147 * z399 + z400 * z418;
    const Scalar z420 = z166 * z396 - z375;
    const Scalar z421 = z398 * z420;
    const Scalar z422 = z166 * z395 + z396 * z421;
    const Scalar z423 = z165 * z396 + z386;
    const Scalar z424 = z398 * z423;
    const Scalar z425 = z165 * z395 + z396 * z424;
    const Scalar z426 = z127 * z407 - z136 * z409 - z321 * z408;
    const Scalar z427 = z126 * z407 + z135 * z409 + z336 * z408;
    const Scalar z428 = z126 * z411 - z135 * z413 - z336 * z412;
    const Scalar z429 = z127 * z407 - z321 * z408;
    const Scalar z430 = z127 * z411 + z321 * z412;
    const Scalar z431 = z127 * z407 - z148 * z416 - z321 * z408 + z351 * z415;
    const Scalar z432 = z126 * z407 + z336 * z408;
    const Scalar z433 = z126 * z411 - z336 * z412;
    const Scalar z434 = z126 * z407 - z147 * z416 + z336 * z408 + z362 * z415;
    const Scalar z435 = z126 * z411 - z147 * z419 - z336 * z412 + z362 * z418;
    const Scalar z436 = z127 * z407 - z166 * z422 - z321 * z408 + z375 * z421;
    const Scalar z437 = z126 * z407 - z165 * z422 + z336 * z408 - z386 * z421;
    const Scalar z438 = z126 * z411 - z165 * z425 - z336 * z412 - z386 * z424;
    const Scalar z439 = n1 / z438;
    const Scalar z440 = z432 * z439;
    const Scalar z441 = z433 * z439;
    const Scalar z442 = z437 * z439;
    const Scalar z443 = z426 - z432 * z440;
    const Scalar z444 = z427 - z432 * z441;
    const Scalar z445 = z428 - z433 * z441;
    const Scalar z446 = z429 - z432 * z440;
    const Scalar z447 = z430 - z433 * z440;
    const Scalar z448 = z431 - z432 * z440;
    const Scalar z449 = z432 * (n1 - z441);
    const Scalar z450 = z433 * (n1 - z441);
    const Scalar z451 = z432 * z441 - z434;
    const Scalar z452 = z433 * z441 - z435;
    const Scalar z453 = z429 - z432 * z442;
    const Scalar z454 = z430 - z433 * z442;
    const Scalar z455 = z436 - z437 * z442;
    const Scalar z456 = n1 / z455;
    const Scalar z457 = z453 * z456;
    const Scalar z458 = z454 * z456;
    const Scalar z459 = z443 - z453 * z457;
    const Scalar z460 = z444 - z453 * z458;
    const Scalar z461 = z445 - z454 * z458;
    const Scalar z462 = z446 - z453 * z457;
    const Scalar z463 = z447 - z454 * z457;
    const Scalar z464 = z448 - z453 * z457;
    const Scalar z465 = z449 - z453 * z458;
    const Scalar z466 = z450 - z454 * z458;
    const Scalar z467 = z451 + z453 * z458;
    const Scalar z468 = z452 + z454 * z458;
    const Scalar z469 = n1 / z468;
    const Scalar z470 = z465 * z469;
    const Scalar z471 = z466 * z469;
    const Scalar z472 = z467 * z469;
    const Scalar z473 = z459 + z465 * z470;
    const Scalar z474 = z460 + z465 * z471;
    const Scalar z475 = z461 + z466 * z471;
    const Scalar z476 = z462 - z465 * z472;
    const Scalar z477 = z463 - z466 * z472;
    const Scalar z478 = z464 + z467 * z472;
    const Scalar z479 = n1 / z478;
    const Scalar z480 = z476 * z479;
    const Scalar z481 = z477 * z479;
    const Scalar z482 = z473 - z476 * z480;
    const Scalar z483 = z474 - z476 * z481;
    const Scalar z484 = z475 - z477 * z481;
    const Scalar z485 = n1 / z484;
    const Scalar z486 = z483 * z485;
    const Scalar z487 = z482 - z483 * z486;
    const Scalar z488 = n1 / z487;
    const Scalar z489 = z251 - z256 * z396;
    const Scalar z490 = z259 - z264 * z400;
    const Scalar z491 = z270 * z403 - z274;
    const Scalar z492 = z405 * z491;
    const Scalar z493 = k26 * z270 - z403 * z492;
    const Scalar z494 = k27 * z238;
    const Scalar z495 = z402 * z490;
    const Scalar z496 = z264 * z399 - z400 * z495;
    const Scalar z497 = z398 * z489;
    const Scalar z498 = z256 * z395 - z396 * z497;
    const Scalar z499 = z127 * z492 - z136 * z494 - z321 * z493 + z332;
    const Scalar z500 = z126 * z492 + z135 * z494 + z336 * z493 + z340;
    const Scalar z501 = z127 * z492 - z148 * z496 - z321 * z493 - z351 * z495 + z359;
    const Scalar z502 = z126 * z492 - z147 * z496 + z336 * z493 - z362 * z495 + z364;
    const Scalar z503 = z127 * z492 + z166 * z498 - z321 * z493 + z375 * z497 + z383;
    const Scalar z504 = z126 * z492 + z165 * z498 + z336 * z493 - z386 * z497 + z388;
    const Scalar z505 = z442 * z504 - z503;
    const Scalar z506 = z441 * z504 - z458 * z505 - z502;
    const Scalar z507 = z440 * z504 - z457 * z505 - z472 * z506 - z501;
    const Scalar z508 = z441 * z504 - z458 * z505 + z471 * z506 - z481 * z507 - z500;
    const Scalar z509 = z440 * z504 - z457 * z505 + z470 * z506 - z480 * z507 - z486 * z508 - z499;
    const Scalar z510 = z488 * z509;
    const Scalar z511 = z485 * z508 - z486 * z510;
    const Scalar z512 = z479 * z507 - z480 * z510 - z481 * z511;
    const Scalar z513 = z469 * z506 - z470 * z510 - z471 * z511 + z472 * z512;
    const Scalar z514 = -z457 * (z510 + z512) - z458 * (z511 - z513) + z456 * z505;
    const Scalar z515 = z440 * (z510 + z512) + z441 * (z511 - z513) + z439 * z504 + z442 * z514;
    const Scalar z516 = z407 * (z510 + z512 + z514) + z411 * (z511 - z513 - z515) + z492;
    const Scalar z517 = z408 * (z510 + z512 + z514) - z412 * (z511 - z513 - z515) + z493;
    const Scalar z518 = z409 * z510 - z413 * z511 + z494;
    const Scalar z519 = z415 * z512 - z418 * z513 - z495;
    const Scalar z520 = z416 * z512 - z419 * z513 + z496;
    const Scalar z521 = z421 * z514 - z424 * z515 + z497;
    const Scalar z522 = z422 * z514 - z425 * z515 - z498;
    accelerations.beta = z516;
    accelerations.Theta = z517;
    accelerations.gamma = -z518;
    accelerations.Phi = -z519;
    accelerations.delta = z520;
    accelerations.Omega = -z521;
    accelerations.epsilon = z522;
    multipliers.lambda_E3_x = z510;
    multipliers.lambda_E3_y = -z511;
    multipliers.lambda_E4_x = z512;
    multipliers.lambda_E4_y = z513;
    multipliers.lambda_E6_x = z514;
    multipliers.lambda_E6_y = z515;
    if (!(traits::regular(-z404, z224) && traits::regular(z401, k9) && traits::regular(z211, z211)
        && traits::regular(z397, k9) && traits::regular(z196, z196) && traits::regular(-z487, -z426)
        && traits::regular(-z484, -z428) && traits::regular(-z478, -z431) && traits::regular(z468, -z435)
        && traits::regular(-z455, -z436) && traits::regular(-z438, -z438))) return torsor::Status::singular;
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
    const Scalar z523 = k9 * z37 - k10 * z38;
    const Scalar z524 = k10 * z37 - k11 * z38;
    const Scalar z525 = k12 * z40 + k13 * z42;
    const Scalar z526 = k13 * z40 + k14 * z42;
    const Scalar z527 = k12 * z45 - k13 * z46;
    const Scalar z528 = k13 * z45 - k14 * z46;
    result.kinetic = n0_5 * (z37 * z523 - z38 * z524 + z40 * z525 + z42 * z526 + z45 * z527 - z46 * z528) + k16 * (z41
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
    const Scalar z309 = z126 + z137;
    const Scalar z310 = z127 - z138;
    const Scalar z311 = v_beta * c_beta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z313 = n0_028 * z312;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z316 = n0_028 * z315;
    const Scalar z317 = s_beta * z313 + c_beta * z316 + z124 * z311 - z125 * z314;
    const Scalar z318 = v_gamma * c_gamma;
    const Scalar z319 = n0_035 * z318;
    const Scalar z320 = z317 - z319;
    const Scalar z321 = s_beta * z123 + c_beta * z124;
    const Scalar z322 = v_Theta * z315;
    const Scalar z323 = n0_028 * z322;
    const Scalar z324 = v_Theta * z312;
    const Scalar z325 = n0_028 * z324;
    const Scalar z326 = v_beta * z314;
    const Scalar z327 = v_beta * z311;
    const Scalar z328 = -n2 * (z311 * z313 - z314 * z316) + s_beta * z323 - c_beta * z325 + z124 * z326 + z125 * z327;
    const Scalar z329 = v_gamma * s_gamma;
    const Scalar z330 = v_gamma * z329;
    const Scalar z331 = n0_035 * z330;
    const Scalar z332 = z328 - z331;
    const Scalar z333 = s_beta * z316 - c_beta * z313 + z124 * z314 + z125 * z311;
    const Scalar z334 = n0_035 * z329;
    const Scalar z335 = z333 - z334;
    const Scalar z336 = s_beta * z124 - c_beta * z123;
    const Scalar z337 = n2 * (z311 * z316 + z313 * z314) + s_beta * z325 + c_beta * z323 + z124 * z327 - z125 * z326;
    const Scalar z338 = v_gamma * z318;
    const Scalar z339 = n0_035 * z338;
    const Scalar z340 = z337 - z339;
    const Scalar z341 = z126 + z149;
    const Scalar z342 = z127 + z150;
    const Scalar z343 = v_delta * c_delta;
    const Scalar z344 = v_Phi * s_Phi;
    const Scalar z345 = n0_02 * z344;
    const Scalar z346 = v_delta * s_delta;
    const Scalar z347 = v_Phi * c_Phi;
    const Scalar z348 = n0_02 * z347;
    const Scalar z349 = s_delta * z345 - c_delta * z348 - z145 * z343 + z146 * z346;
    const Scalar z350 = z317 + z349;
    const Scalar z351 = s_delta * z144 - c_delta * z145;
    const Scalar z352 = v_Phi * z347;
    const Scalar z353 = n0_02 * z352;
    const Scalar z354 = v_Phi * z344;
    const Scalar z355 = n0_02 * z354;
    const Scalar z356 = v_delta * z346;
    const Scalar z357 = v_delta * z343;
    const Scalar z358 = n2 * (z343 * z345 + z346 * z348) + s_delta * z353 + c_delta * z355 + z145 * z356 + z146 * z357;
    const Scalar z359 = z328 - z358;
    const Scalar z360 = s_delta * z348 + c_delta * z345 + z145 * z346 + z146 * z343;
    const Scalar z361 = z333 - z360;
    const Scalar z362 = s_delta * z145 + c_delta * z144;
    const Scalar z363 = -n2 * (z343 * z348 - z345 * z346) + s_delta * z355 - c_delta * z353 - z145 * z357 + z146 * z356;
    const Scalar z364 = z337 + z363;
    const Scalar z365 = z126 + z167;
    const Scalar z366 = z127 + z168;
    const Scalar z367 = v_epsilon * c_epsilon;
    const Scalar z368 = v_Omega * c_Omega;
    const Scalar z369 = n0_02 * z368;
    const Scalar z370 = v_epsilon * s_epsilon;
    const Scalar z371 = v_Omega * s_Omega;
    const Scalar z372 = n0_02 * z371;
    const Scalar z373 = s_epsilon * z369 + c_epsilon * z372 + z162 * z370 - z164 * z367;
    const Scalar z374 = z317 + z373;
    const Scalar z375 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z376 = v_Omega * z371;
    const Scalar z377 = n0_02 * z376;
    const Scalar z378 = v_Omega * z368;
    const Scalar z379 = n0_02 * z378;
    const Scalar z380 = v_epsilon * z367;
    const Scalar z381 = v_epsilon * z370;
    const Scalar z382 = -n2 * (z367 * z369 - z370 * z372) + s_epsilon * z377 - c_epsilon * z379 - z162 * z380 - z164
        * z381;
    const Scalar z383 = z328 + z382;
    const Scalar z384 = s_epsilon * z372 - c_epsilon * z369 - z162 * z367 - z164 * z370;
    const Scalar z385 = z333 + z384;
    const Scalar z386 = s_epsilon * z163 - c_epsilon * z162;
    const Scalar z387 = n2 * (z367 * z372 + z369 * z370) + s_epsilon * z379 + c_epsilon * z377 + z162 * z381 - z164
        * z380;
    const Scalar z388 = z337 + z387;
    result.value[0] = z309;
    result.rate[0] = z320;
    result.gamma[0] = -z332;
    result.value[1] = z310;
    result.rate[1] = z335;
    result.gamma[1] = z340;
    result.value[2] = z341;
    result.rate[2] = z350;
    result.gamma[2] = -z359;
    result.value[3] = z342;
    result.rate[3] = z361;
    result.gamma[3] = z364;
    result.value[4] = z365;
    result.rate[4] = z374;
    result.gamma[4] = -z383;
    result.value[5] = z366;
    result.rate[5] = z385;
    result.gamma[5] = z388;
    result.jacobian[0] = -z127;
    result.jacobian[1] = z126;
    result.jacobian[2] = -z127;
    result.jacobian[3] = z126;
    result.jacobian[4] = -z127;
    result.jacobian[5] = z126;
    result.jacobian[6] = z321;
    result.jacobian[7] = z336;
    result.jacobian[8] = z321;
    result.jacobian[9] = z336;
    result.jacobian[10] = z321;
    result.jacobian[11] = z336;
    result.jacobian[12] = -z136;
    result.jacobian[13] = -z135;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z351;
    result.jacobian[21] = -z362;
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
    result.jacobian[34] = z375;
    result.jacobian[35] = z386;
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
    const Scalar k8 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k11 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k12 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k13 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k14 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k17 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k20 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k21 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k25 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k28 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k29 = traits::constant(1244740.7431948162, 1244740.8f, "500000000000000/401690073");
    const Scalar k30 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
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
    const Scalar z184 = k9 - z182;
    const Scalar z191 = k9 - n2 * z182;
    const Scalar z196 = k11 + z191;
    const Scalar z198 = k8 * s_Phi;
    const Scalar z199 = k9 + z198;
    const Scalar z206 = k9 + n2 * z198;
    const Scalar z211 = k12 + z206;
    const Scalar z213 = k13 * c_Theta;
    const Scalar z214 = k14 - n0_175 * z213;
    const Scalar z221 = k14 - n0_35 * z213;
    const Scalar z224 = k17 + z221;
    const Scalar z225 = n0_014 + z115;
    const Scalar z226 = n0_072 - z116;
    const Scalar z227 = k20 * s_gamma + k21 * c_gamma;
    const Scalar z228 = k21 * s_gamma - k20 * c_gamma;
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
    const Scalar z240 = n0_175 * z239;
    const Scalar z243 = v_delta * v_delta;
    const Scalar z246 = v_epsilon * v_epsilon;
    const Scalar z249 = z46 * z46;
    const Scalar z250 = k8 * z249;  // force on K6, times 0.04 m, x
    const Scalar z257 = z42 * z42;
    const Scalar z258 = k8 * z257;  // force on K4, times 0.04 m, y
    const Scalar z268 = z38 * z38;
    const Scalar z269 = k13 * z268;  // force on K2, times 0.04 m, x
    const Scalar z275 = n0_175 * a_beta;
    const Scalar z276 = s_Theta * z275 - c_Theta * z240;
    const Scalar z277 = s_Theta * z240 + c_Theta * z275;
    const Scalar z278 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z279 = a_delta * s_Phi - c_Phi * z243;
    const Scalar z280 = a_delta * c_Phi + s_Phi * z243;
    const Scalar z281 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z282 = a_epsilon * c_Omega + s_Omega * z246;
    const Scalar z283 = a_epsilon * s_Omega - c_Omega * z246;
    const Scalar z284 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z285 = k8 * z284;  // force on K6, times 0.04 m, y
    const Scalar z286 = k8 * z283 - k9 * z284;  // moment on K6, z
    const Scalar z287 = s_Omega * z285 + c_Omega * z250;
    const Scalar z288 = s_Omega * z250 - c_Omega * z285;
    const Scalar z291 = k11 * a_epsilon - z286 - z287;  // moment on K7, z
    const Scalar z292 = k8 * z281;  // force on K4, times 0.04 m, x
    const Scalar z293 = k8 * z279 + k9 * z281;  // moment on K4, z
    const Scalar z294 = s_Phi * z258 - c_Phi * z292;
    const Scalar z295 = s_Phi * z292 + c_Phi * z258;
    const Scalar z298 = k12 * a_delta + z293 + z295;  // moment on K5, z
    const Scalar z301 = k25 * a_gamma + z238;  // moment on K3, z
    const Scalar z302 = k13 * z278;  // force on K2, times 0.04 m, y
    const Scalar z303 = k13 * z277 - k14 * z278;  // moment on K2, z
    const Scalar z304 = s_Theta * z302 + c_Theta * z269;
    const Scalar z305 = s_Theta * z269 - c_Theta * z302;
    const Scalar z308 = n0_033 - k17 * a_beta + z303 - n0_175 * z305;  // moment on K1, z
    const Scalar z311 = v_beta * c_beta;
    const Scalar z312 = v_Theta * c_Theta;
    const Scalar z313 = n0_028 * z312;
    const Scalar z314 = v_beta * s_beta;
    const Scalar z315 = v_Theta * s_Theta;
    const Scalar z316 = n0_028 * z315;
    const Scalar z317 = s_beta * z313 + c_beta * z316 + z124 * z311 - z125 * z314;
    const Scalar z318 = v_gamma * c_gamma;
    const Scalar z319 = n0_035 * z318;
    const Scalar z321 = s_beta * z123 + c_beta * z124;
    const Scalar z322 = v_Theta * z315;
    const Scalar z323 = n0_028 * z322;
    const Scalar z324 = v_Theta * z312;
    const Scalar z325 = n0_028 * z324;
    const Scalar z326 = v_beta * z314;
    const Scalar z327 = v_beta * z311;
    const Scalar z328 = -n2 * (z311 * z313 - z314 * z316) + s_beta * z323 - c_beta * z325 + z124 * z326 + z125 * z327;
    const Scalar z329 = v_gamma * s_gamma;
    const Scalar z330 = v_gamma * z329;
    const Scalar z331 = n0_035 * z330;
    const Scalar z332 = z328 - z331;
    const Scalar z333 = s_beta * z316 - c_beta * z313 + z124 * z314 + z125 * z311;
    const Scalar z334 = n0_035 * z329;
    const Scalar z336 = s_beta * z124 - c_beta * z123;
    const Scalar z337 = n2 * (z311 * z316 + z313 * z314) + s_beta * z325 + c_beta * z323 + z124 * z327 - z125 * z326;
    const Scalar z338 = v_gamma * z318;
    const Scalar z339 = n0_035 * z338;
    const Scalar z340 = z337 - z339;
    const Scalar z343 = v_delta * c_delta;
    const Scalar z344 = v_Phi * s_Phi;
    const Scalar z345 = n0_02 * z344;
    const Scalar z346 = v_delta * s_delta;
    const Scalar z347 = v_Phi * c_Phi;
    const Scalar z348 = n0_02 * z347;
    const Scalar z349 = s_delta * z345 - c_delta * z348 - z145 * z343 + z146 * z346;
    const Scalar z351 = s_delta * z144 - c_delta * z145;
    const Scalar z352 = v_Phi * z347;
    const Scalar z353 = n0_02 * z352;
    const Scalar z354 = v_Phi * z344;
    const Scalar z355 = n0_02 * z354;
    const Scalar z356 = v_delta * z346;
    const Scalar z357 = v_delta * z343;
    const Scalar z358 = n2 * (z343 * z345 + z346 * z348) + s_delta * z353 + c_delta * z355 + z145 * z356 + z146 * z357;
    const Scalar z359 = z328 - z358;
    const Scalar z360 = s_delta * z348 + c_delta * z345 + z145 * z346 + z146 * z343;
    const Scalar z362 = s_delta * z145 + c_delta * z144;
    const Scalar z363 = -n2 * (z343 * z348 - z345 * z346) + s_delta * z355 - c_delta * z353 - z145 * z357 + z146 * z356;
    const Scalar z364 = z337 + z363;
    const Scalar z367 = v_epsilon * c_epsilon;
    const Scalar z368 = v_Omega * c_Omega;
    const Scalar z369 = n0_02 * z368;
    const Scalar z370 = v_epsilon * s_epsilon;
    const Scalar z371 = v_Omega * s_Omega;
    const Scalar z372 = n0_02 * z371;
    const Scalar z373 = s_epsilon * z369 + c_epsilon * z372 + z162 * z370 - z164 * z367;
    const Scalar z375 = s_epsilon * z162 + c_epsilon * z163;
    const Scalar z376 = v_Omega * z371;
    const Scalar z377 = n0_02 * z376;
    const Scalar z378 = v_Omega * z368;
    const Scalar z379 = n0_02 * z378;
    const Scalar z380 = v_epsilon * z367;
    const Scalar z381 = v_epsilon * z370;
    const Scalar z382 = -n2 * (z367 * z369 - z370 * z372) + s_epsilon * z377 - c_epsilon * z379 - z162 * z380 - z164
        * z381;
    const Scalar z383 = z328 + z382;
    const Scalar z384 = s_epsilon * z372 - c_epsilon * z369 - z162 * z367 - z164 * z370;
    const Scalar z386 = s_epsilon * z163 - c_epsilon * z162;
    const Scalar z387 = n2 * (z367 * z372 + z369 * z370) + s_epsilon * z379 + c_epsilon * z377 + z162 * z381 - z164
        * z380;
    const Scalar z388 = z337 + z387;
    const Scalar z574 = n2 * v_beta;
    const Scalar z575 = n0_175 * z574;
    const Scalar z576 = s_Theta * z575;
    const Scalar z577 = k13 * z576;
    const Scalar z578 = n2 * z38;
    const Scalar z579 = k13 * z578;
    const Scalar z580 = s_Theta * z579;
    const Scalar z581 = z577 - n0_175 * z580;
    const Scalar z582 = z126 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z127 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z583 = z321 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z336 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z584 = n0_175 * z580;
    const Scalar z585 = k13 * z276;
    const Scalar z586 = n0_175 * z304 + z585;
    const Scalar z587 = z321 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z336 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z586;
    const Scalar z588 = z321 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z336 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z585;
    const Scalar z589 = n2 * (z113 * z226 - z114 * z225);
    const Scalar z590 = n0_5 * z589 / z232;
    const Scalar z591 = z590 / (z232 * z232);
    const Scalar z592 = n352_6605 * z591;
    const Scalar z593 = z228 * z234 - z229 * z592;
    const Scalar z594 = z227 * z234 + z230 * z592;
    const Scalar z595 = n0_018 * z593 + n0_02 * z594;
    const Scalar z596 = z135 * l_lambda_E3_x - z136 * l_lambda_E3_y - z595;
    const Scalar z597 = k8 * z280;
    const Scalar z598 = z351 * l_lambda_E4_y + z362 * l_lambda_E4_x - z597;
    const Scalar z599 = n2 * z42;
    const Scalar z600 = k8 * z599;
    const Scalar z601 = c_Phi * z600;
    const Scalar z602 = z294 - z597;
    const Scalar z603 = z351 * l_lambda_E4_y + z362 * l_lambda_E4_x + z602;
    const Scalar z604 = n2 * v_delta;
    const Scalar z605 = c_Phi * z604;
    const Scalar z606 = k8 * z605;
    const Scalar z607 = z351 * l_lambda_E4_y + z362 * l_lambda_E4_x;
    const Scalar z608 = z601 - z606;
    const Scalar z609 = z147 * l_lambda_E4_x + z148 * l_lambda_E4_y;
    const Scalar z610 = k8 * z282;
    const Scalar z611 = z375 * l_lambda_E6_y - z386 * l_lambda_E6_x + z610;
    const Scalar z612 = n2 * z46;
    const Scalar z613 = k8 * z612;
    const Scalar z614 = c_Omega * z613;
    const Scalar z615 = z288 - z610;
    const Scalar z616 = z375 * l_lambda_E6_y - z386 * l_lambda_E6_x - z615;
    const Scalar z617 = n2 * v_epsilon;
    const Scalar z618 = c_Omega * z617;
    const Scalar z619 = k8 * z618;
    const Scalar z620 = z375 * l_lambda_E6_y - z386 * l_lambda_E6_x;
    const Scalar z621 = z614 - z619;
    const Scalar z622 = z165 * l_lambda_E6_x + z166 * l_lambda_E6_y;
    const Scalar z623 = a_beta * z127 - a_Theta * z321 - a_epsilon * z166 - a_Omega * z375 + z383;
    const Scalar z624 = a_beta * z127 - a_Theta * z321 - a_delta * z148 - a_Phi * z351 + z359;
    const Scalar z625 = a_beta * z127 - a_Theta * z321 + a_gamma * z136 + z332;
    const Scalar z626 = a_beta * z126 + a_Theta * z336 - a_gamma * z135 + z340;
    const Scalar z627 = a_beta * z126 + a_Theta * z336 - a_epsilon * z165 + a_Omega * z386 + z388;
    const Scalar z628 = a_beta * z126 + a_Theta * z336 - a_delta * z147 - a_Phi * z362 + z364;
    const Scalar z629 = v_beta * s_beta + z314;
    const Scalar z630 = v_beta * c_beta + z311;
    const Scalar z631 = n2 * (s_beta * z316 - c_beta * z313) + z124 * z629 + z125 * z630;
    const Scalar z632 = a_beta * z126 + a_Theta * z336 + z337;
    const Scalar z633 = n2 * (s_beta * z313 + c_beta * z316) + z124 * z630 - z125 * z629;
    const Scalar z634 = a_beta * z127 - a_Theta * z321 + z328;
    const Scalar z635 = s_beta * z316 - c_beta * z313 - z123 * z311 + z124 * z314;
    const Scalar z636 = v_Theta * s_Theta + z315;
    const Scalar z637 = n0_028 * z636;
    const Scalar z638 = v_Theta * c_Theta + z312;
    const Scalar z639 = n0_028 * z638;
    const Scalar z640 = -n2 * (z123 * z311 - z124 * z314) + s_beta * z637 - c_beta * z639;
    const Scalar z641 = n2 * (z311 * z316 + z313 * z314) + s_beta * z325 + c_beta * z323 + z123 * z326 + z124 * z327;
    const Scalar z642 = z336 * (a_beta + a_Theta) + z641;
    const Scalar z643 = s_beta * z313 + c_beta * z316 + z123 * z314 + z124 * z311;
    const Scalar z644 = n2 * (z123 * z314 + z124 * z311) + s_beta * z639 + c_beta * z637;
    const Scalar z645 = -n2 * (z311 * z313 - z314 * z316) + s_beta * z323 - c_beta * z325 - z123 * z327 + z124 * z326;
    const Scalar z646 = z321 * (a_beta + a_Theta) - z645;
    const Scalar z647 = v_gamma * s_gamma + z329;
    const Scalar z648 = n0_035 * z647;
    const Scalar z649 = a_gamma * z135 + z339;
    const Scalar z650 = v_gamma * c_gamma + z318;
    const Scalar z651 = n0_035 * z650;
    const Scalar z652 = a_gamma * z136 - z331;
    const Scalar z653 = s_delta * z348 + c_delta * z345 + z144 * z343 + z145 * z346;
    const Scalar z654 = v_Phi * c_Phi + z347;
    const Scalar z655 = n0_02 * z654;
    const Scalar z656 = v_Phi * s_Phi + z344;
    const Scalar z657 = n0_02 * z656;
    const Scalar z658 = n2 * (z144 * z343 + z145 * z346) + s_delta * z655 + c_delta * z657;
    const Scalar z659 = -n2 * (z343 * z348 - z345 * z346) + s_delta * z355 - c_delta * z353 + z144 * z356 - z145 * z357;
    const Scalar z660 = z362 * (a_delta + a_Phi) - z659;
    const Scalar z661 = s_delta * z345 - c_delta * z348 + z144 * z346 - z145 * z343;
    const Scalar z662 = n2 * (z144 * z346 - z145 * z343) + s_delta * z657 - c_delta * z655;
    const Scalar z663 = n2 * (z343 * z345 + z346 * z348) + s_delta * z353 + c_delta * z355 + z144 * z357 + z145 * z356;
    const Scalar z664 = z351 * (a_delta + a_Phi) + z663;
    const Scalar z665 = v_delta * s_delta + z346;
    const Scalar z666 = v_delta * c_delta + z343;
    const Scalar z667 = n2 * (s_delta * z348 + c_delta * z345) + z145 * z665 + z146 * z666;
    const Scalar z668 = a_delta * z147 + a_Phi * z362 - z363;
    const Scalar z669 = n2 * (s_delta * z345 - c_delta * z348) - z145 * z666 + z146 * z665;
    const Scalar z670 = a_delta * z148 + a_Phi * z351 + z358;
    const Scalar z671 = s_epsilon * z372 - c_epsilon * z369 - z162 * z367 + z163 * z370;
    const Scalar z672 = v_Omega * s_Omega + z371;
    const Scalar z673 = n0_02 * z672;
    const Scalar z674 = v_Omega * c_Omega + z368;
    const Scalar z675 = n0_02 * z674;
    const Scalar z676 = -n2 * (z162 * z367 - z163 * z370) + s_epsilon * z673 - c_epsilon * z675;
    const Scalar z677 = n2 * (z367 * z372 + z369 * z370) + s_epsilon * z379 + c_epsilon * z377 + z162 * z381 + z163
        * z380;
    const Scalar z678 = z386 * (a_epsilon + a_Omega) + z677;
    const Scalar z679 = s_epsilon * z369 + c_epsilon * z372 + z162 * z370 + z163 * z367;
    const Scalar z680 = n2 * (z162 * z370 + z163 * z367) + s_epsilon * z675 + c_epsilon * z673;
    const Scalar z681 = -n2 * (z367 * z369 - z370 * z372) + s_epsilon * z377 - c_epsilon * z379 - z162 * z380 + z163
        * z381;
    const Scalar z682 = z375 * (a_epsilon + a_Omega) - z681;
    const Scalar z683 = v_epsilon * c_epsilon + z367;
    const Scalar z684 = v_epsilon * s_epsilon + z370;
    const Scalar z685 = n2 * (s_epsilon * z372 - c_epsilon * z369) - z162 * z683 - z164 * z684;
    const Scalar z686 = a_epsilon * z165 - a_Omega * z386 - z387;
    const Scalar z687 = n2 * (s_epsilon * z369 + c_epsilon * z372) + z162 * z684 - z164 * z683;
    const Scalar z688 = a_epsilon * z166 + a_Omega * z375 - z382;
    const Scalar z689 = n1 / z375;
    const Scalar z690 = z386 * z689;
    const Scalar z691 = z321 * z690 - z336;
    const Scalar z692 = z165 + z166 * z690;
    const Scalar z693 = n1 / z351;
    const Scalar z694 = z362 * z693;
    const Scalar z695 = z321 * z694 + z336;
    const Scalar z696 = z147 - z148 * z694;
    const Scalar z697 = n1 / z136;
    const Scalar z698 = z135 * z697;
    const Scalar z699 = z321 * z698 - z336;
    const Scalar z700 = n1 / z699;
    const Scalar z701 = z691 * z700;
    const Scalar z702 = z695 * z700;
    const Scalar z703 = n1 / z692;
    const Scalar z704 = n1 / z696;
    const Scalar z705 = z375 * z375;
    const Scalar z706 = z127 * z127 / z224 + z166 * z166 / z196 + k28 * z321 * z321 + k29 * z375 * z375;
    const Scalar z707 = k9 * z706;
    const Scalar z708 = z351 * z351;
    const Scalar z709 = z127 * z127 / z224 + z148 * z148 / z211 + k28 * z321 * z321 + k29 * z351 * z351;
    const Scalar z710 = k9 * z709;
    const Scalar z711 = z136 * z136;
    const Scalar z712 = z127 * z127 / z224 + k30 * z136 * z136 + k28 * z321 * z321;
    const Scalar z713 = k25 * z712;
    const Scalar z714 = z699 * z699;
    const Scalar z715 = z126 * z126 / z224 + k30 * z135 * z135 + k28 * z336 * z336;
    const Scalar z716 = k14 * z715;
    const Scalar z717 = z692 * z692;
    const Scalar z718 = z126 * z126 / z224 + z165 * z165 / z196 + k28 * z336 * z336 + k29 * z386 * z386;
    const Scalar z719 = z196 * z718;
    const Scalar z720 = z696 * z696;
    const Scalar z721 = z126 * z126 / z224 + z147 * z147 / z211 + k28 * z336 * z336 + k29 * z362 * z362;
    const Scalar z722 = z211 * z721;
    const Scalar z723 = z126 + z127 * z698;
    const Scalar z724 = z126 + z127 * z690 - z701 * z723;
    const Scalar z725 = z126 - z127 * z694 + z702 * z723;
    const Scalar z726 = z704 * z725;
    const Scalar z727 = z703 * z724;
    const Scalar z728 = z700 * z723;
    const Scalar z729 = z127 - z321 * z728;
    const Scalar z730 = z697 * z729;
    const Scalar z731 = z127 - z148 * z726 - z321 * z728;
    const Scalar z732 = z693 * z731;
    const Scalar z733 = z127 - z166 * z727 - z321 * z728;
    const Scalar z734 = z689 * z733;
    const Scalar z735 = z333 + z334 * z730 + z635 * z728;
    const Scalar z736 = z317 + z319 * z730 + z643 * z728;
    const Scalar z737 = z333 - z360 * z726 + z635 * z728 - z653 * z732;
    const Scalar z738 = z317 + z349 * z726 + z643 * z728 + z661 * z732;
    const Scalar z739 = z333 + z384 * z727 + z635 * z728 + z671 * z734;
    const Scalar z740 = z317 + z373 * z727 + z643 * z728 + z679 * z734;
    const Scalar z741 = z698 * z735 + z736;
    const Scalar z742 = z690 * z739 - z701 * z741 + z740;
    const Scalar z743 = z694 * z737 - z702 * z741 - z738;
    const Scalar z744 = z704 * z743;
    const Scalar z745 = z703 * z742;
    const Scalar z746 = z700 * z741;
    const Scalar z747 = z321 * z746 - z735;
    const Scalar z748 = z697 * z747;
    const Scalar z749 = z148 * z744 - z321 * z746 + z737;
    const Scalar z750 = z693 * z749;
    const Scalar z751 = z166 * z745 + z321 * z746 - z739;
    const Scalar z752 = z689 * z751;
    const Scalar z753 = z631 + z640 * z728 + z648 * z730;
    const Scalar z754 = z633 + z644 * z728 + z651 * z730;
    const Scalar z755 = z631 + z640 * z728 - z658 * z732 - z667 * z726;
    const Scalar z756 = z633 + z644 * z728 + z662 * z732 + z669 * z726;
    const Scalar z757 = z631 + z640 * z728 + z676 * z734 + z685 * z727;
    const Scalar z758 = z633 + z644 * z728 + z680 * z734 + z687 * z727;
    const Scalar z759 = z698 * z753 + z754;
    const Scalar z760 = z690 * z757 - z701 * z759 + z758;
    const Scalar z761 = z694 * z755 - z702 * z759 - z756;
    const Scalar z762 = z704 * z761;
    const Scalar z763 = z703 * z760;
    const Scalar z764 = z700 * z759;
    const Scalar z765 = z321 * z764 - z753;
    const Scalar z766 = z697 * z765;
    const Scalar z767 = z148 * z762 - z321 * z764 + z755;
    const Scalar z768 = z693 * z767;
    const Scalar z769 = z166 * z763 + z321 * z764 - z757;
    const Scalar z770 = z689 * z769;
    const Scalar z771 = z640 * z746 - z648 * z748;
    const Scalar z772 = z644 * z746 - z651 * z748;
    const Scalar z773 = z640 * z746 - z658 * z750 + z667 * z744;
    const Scalar z774 = z644 * z746 + z662 * z750 - z669 * z744;
    const Scalar z775 = z640 * z746 - z676 * z752 + z685 * z745;
    const Scalar z776 = z644 * z746 - z680 * z752 + z687 * z745;
    const Scalar z777 = z632 + z642 * z728 + z649 * z730;
    const Scalar z778 = z634 - z646 * z728 - z652 * z730;
    const Scalar z779 = z632 + z642 * z728 - z660 * z732 - z668 * z726;
    const Scalar z780 = z634 - z646 * z728 - z664 * z732 - z670 * z726;
    const Scalar z781 = z632 + z642 * z728 + z678 * z734 - z686 * z727;
    const Scalar z782 = z634 - z646 * z728 - z682 * z734 - z688 * z727;
    const Scalar z783 = z771 + z777;
    const Scalar z784 = z772 - z778;
    const Scalar z785 = z773 + z779;
    const Scalar z786 = z774 - z780;
    const Scalar z787 = z775 + z781;
    const Scalar z788 = z776 - z782;
    const Scalar z789 = z698 * z783 + z784;
    const Scalar z790 = z690 * z787 - z701 * z789 + z788;
    const Scalar z791 = z694 * z785 - z702 * z789 - z786;
    const Scalar z792 = z704 * z791;
    const Scalar z793 = z703 * z790;
    const Scalar z794 = z700 * z789;
    const Scalar z795 = z321 * z794 - z783;
    const Scalar z796 = z697 * z795;
    const Scalar z797 = z148 * z792 - z321 * z794 + z785;
    const Scalar z798 = z693 * z797;
    const Scalar z799 = z166 * z793 + z321 * z794 - z787;
    const Scalar z800 = z689 * z799;
    const Scalar z801 = z625 * z698 + z626;
    const Scalar z802 = z623 * z690 + z627 - z701 * z801;
    const Scalar z803 = z624 * z694 - z628 - z702 * z801;
    const Scalar z804 = z704 * z803;
    const Scalar z805 = z703 * z802;
    const Scalar z806 = z700 * z801;
    const Scalar z807 = z321 * z806 - z625;
    const Scalar z808 = z697 * z807;
    const Scalar z809 = z148 * z804 - z321 * z806 + z624;
    const Scalar z810 = z693 * z809;
    const Scalar z811 = z166 * z805 + z321 * z806 - z623;
    const Scalar z812 = z689 * z811;
    const Scalar z813 = z214 * z728 + z224;
    const Scalar z814 = z214 + k14 * z728;
    const Scalar z815 = k25 * z730;
    const Scalar z816 = z199 * z726 + k9 * z732;
    const Scalar z817 = z199 * z732 + z211 * z726;
    const Scalar z818 = z184 * z727 + k9 * z734;
    const Scalar z819 = z184 * z734 + z196 * z727;
    const Scalar z820 = z726 * z817 + z727 * z819 + z728 * z814 + z730 * z815 + z732 * z816 + z734 * z818 + z813;
    const Scalar z821 = z762 * z817 - z763 * z819 - z764 * z814 + z766 * z815 - z768 * z816 + z770 * z818;
    const Scalar z822 = z581 - z584 * z728;
    const Scalar z823 = z606 * z726;
    const Scalar z824 = z601 * z732 + z608 * z726;
    const Scalar z825 = z619 * z727;
    const Scalar z826 = z614 * z734 + z621 * z727;
    const Scalar z827 = z577 * z728 - z726 * z824 + z727 * z826 + z732 * z823 - z734 * z825 + z822;
    const Scalar z828 = z821 + z827;
    const Scalar z829 = z792 * z817 - z793 * z819 - z794 * z814 + z796 * z815 - z798 * z816 + z800 * z818;
    const Scalar z830 = z584 * z746;
    const Scalar z831 = z606 * z744;
    const Scalar z832 = z601 * z750 - z608 * z744;
    const Scalar z833 = z619 * z745;
    const Scalar z834 = z614 * z752 - z621 * z745;
    const Scalar z835 = z582 - z587 * z728;
    const Scalar z836 = z583 + z588 * z728;
    const Scalar z837 = z596 * z730;
    const Scalar z838 = z598 * z732 + z607 * z726;
    const Scalar z839 = z603 * z732 + z609 * z726;
    const Scalar z840 = z611 * z734 + z620 * z727;
    const Scalar z841 = z616 * z734 + z622 * z727;
    const Scalar z842 = z830 + z835;
    const Scalar z843 = z831 - z838;
    const Scalar z844 = z832 - z839;
    const Scalar z845 = z833 - z840;
    const Scalar z846 = z834 - z841;
    const Scalar z847 = z726 * z844 + z727 * z846 - z728 * z836 - z730 * z837 + z732 * z843 + z734 * z845 + z842;
    const Scalar z848 = z829 - z847;
    const Scalar z849 = z321 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z336 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) + z303;
    const Scalar z850 = z135 * l_lambda_E3_y + z136 * l_lambda_E3_x + z301;
    const Scalar z851 = z293 - z351 * l_lambda_E4_x + z362 * l_lambda_E4_y;
    const Scalar z852 = z147 * l_lambda_E4_y - z148 * l_lambda_E4_x + z298;
    const Scalar z853 = z286 + z375 * l_lambda_E6_x + z386 * l_lambda_E6_y;
    const Scalar z854 = z165 * l_lambda_E6_y - z166 * l_lambda_E6_x + z291;
    const Scalar z855 = z126 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z127 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) + z308 - z726 * z852 - z727 * z854 + z728 * z849 + z730 * z850 - z732 * z851 + z734 * z853;
    const Scalar z856 = z804 * z817 - z805 * z819 - z806 * z814 + z808 * z815 - z810 * z816 + z812 * z818;
    const Scalar z857 = z855 + z856;
    const Scalar z858 = n1 / z820;
    const Scalar z859 = z848 * z858;
    const Scalar z860 = z828 * z858;
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
    result.M[16] = k25;
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
    result.C[0] = -z581;
    result.C[1] = -z577;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z584;
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
    result.C[25] = z601;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z606;
    result.C[32] = z608;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z614;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z619;
    result.C[48] = -z621;
    result.K[0] = z582;
    result.K[1] = -z583;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z587;
    result.K[8] = -z588;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z596;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z598;
    result.K[25] = -z603;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z607;
    result.K[32] = -z609;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = -z611;
    result.K[41] = -z616;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = -z620;
    result.K[48] = -z622;
    result.F[0] = z126 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z127 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) + z308;
    result.F[1] = z321 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z336 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) + z303;
    result.F[2] = -z135 * l_lambda_E3_y - z136 * l_lambda_E3_x - z301;
    result.F[3] = -z293 + z351 * l_lambda_E4_x - z362 * l_lambda_E4_y;
    result.F[4] = -z147 * l_lambda_E4_y + z148 * l_lambda_E4_x - z298;
    result.F[5] = z286 + z375 * l_lambda_E6_x + z386 * l_lambda_E6_y;
    result.F[6] = -z165 * l_lambda_E6_y + z166 * l_lambda_E6_x - z291;
    result.M_r[0] = z820;
    result.C_r[0] = -z828;
    result.K_r[0] = -z848;
    result.F_r[0] = z857;
    result.A[0] = n0;
    result.A[1] = z859;
    result.A[2] = n1;
    result.A[3] = z860;
    if (!(traits::regular(z705, z707) && traits::regular(z708, z710) && traits::regular(z711, z713)
        && traits::regular(z714, z716) && traits::regular(z717, z719) && traits::regular(z720, z722)
        && traits::regular(z820, z820))) return torsor::Status::singular;
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
