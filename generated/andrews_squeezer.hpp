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
//   kinematics               64               95          0             0                  7       0    173     173
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
    const Scalar k2 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k3 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar k4 = traits::constant(0.00092, 0.00092f, "23/25000");
    const Scalar n0_0115 = traits::constant(0.0115, 0.0115f, "23/2000");
    const Scalar k6 = traits::constant(0.01874, 0.01874f, "937/50000");
    const Scalar k7 = traits::constant(0.01043, 0.01043f, "1043/100000");
    const Scalar k8 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k9 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k10 = traits::constant(0.00579, 0.00579f, "579/100000");
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
    const Scalar z35 = q_beta + q_Theta;
    const Scalar z44 = q_delta + q_Phi;
    const Scalar z55 = q_epsilon + q_Omega;
    const Scalar angles_[] = {q_beta, q_gamma, q_delta, q_epsilon, z35, z44, z55};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar s_delta = sines_[2], c_delta = cosines_[2];
    const Scalar s_epsilon = sines_[3], c_epsilon = cosines_[3];
    const Scalar z36 = sines_[4], z37 = cosines_[4];
    const Scalar z45 = sines_[5], z46 = cosines_[5];
    const Scalar z56 = sines_[6], z57 = cosines_[6];
    const Scalar z38 = n0_007 * c_beta;
    const Scalar z39 = n0_007 * s_beta;
    const Scalar z40 = n0_007 * v_beta;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z42 = s_beta * z40;  // velocity of K2, x
    const Scalar z43 = c_beta * z40;  // velocity of K2, y
    const Scalar z47 = n0_04 * c_delta;
    const Scalar z48 = n0_04 * s_delta;
    const Scalar z49 = k2 - z47;  // place of K4, x
    const Scalar z50 = k3 - z48;  // place of K4, y
    const Scalar z51 = n0_04 * v_delta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z53 = s_delta * z51;  // velocity of K4, x
    const Scalar z54 = c_delta * z51;  // velocity of K4, y
    const Scalar z58 = n0_04 * s_epsilon;
    const Scalar z59 = n0_04 * c_epsilon;
    const Scalar z60 = k2 - z58;  // place of K6, x
    const Scalar z61 = k3 + z59;  // place of K6, y
    const Scalar z62 = n0_04 * v_epsilon;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z64 = c_epsilon * z62;  // velocity of K6, x
    const Scalar z65 = s_epsilon * z62;  // velocity of K6, y
    const Scalar z66 = k4 * c_beta;
    const Scalar z67 = k4 * s_beta;
    const Scalar z68 = k4 * v_beta;
    const Scalar z69 = s_beta * z68;
    const Scalar z70 = c_beta * z68;
    const Scalar z71 = n0_0115 * z37;
    const Scalar z72 = n0_0115 * z36;
    const Scalar z73 = z38 - z71;
    const Scalar z74 = z39 - z72;
    const Scalar z75 = n0_0115 * z41;
    const Scalar z76 = z36 * z75 - z42;
    const Scalar z77 = z37 * z75 - z43;
    const Scalar z78 = k6 * s_gamma + k7 * c_gamma;
    const Scalar z79 = k7 * s_gamma - k6 * c_gamma;
    const Scalar z80 = k8 - z78;
    const Scalar z81 = k9 + z79;
    const Scalar z82 = k6 * v_gamma;
    const Scalar z83 = k7 * v_gamma;
    const Scalar z84 = s_gamma * z83 - c_gamma * z82;
    const Scalar z85 = s_gamma * z82 + c_gamma * z83;
    const Scalar z86 = k10 * z45;
    const Scalar z87 = k10 * z46;
    const Scalar z88 = z49 - z86;
    const Scalar z89 = z50 + z87;
    const Scalar z90 = k10 * z52;
    const Scalar z91 = z46 * z90 - z53;
    const Scalar z92 = z45 * z90 + z54;
    const Scalar z93 = k11 * s_delta - k12 * c_delta;
    const Scalar z94 = k12 * s_delta + k11 * c_delta;
    const Scalar z95 = k2 + z93;
    const Scalar z96 = k3 - z94;
    const Scalar z97 = k11 * v_delta;
    const Scalar z98 = k12 * v_delta;
    const Scalar z99 = s_delta * z98 + c_delta * z97;
    const Scalar z100 = s_delta * z97 - c_delta * z98;
    const Scalar z101 = k10 * z57;
    const Scalar z102 = k10 * z56;
    const Scalar z103 = z60 - z101;
    const Scalar z104 = z61 - z102;
    const Scalar z105 = k10 * z63;
    const Scalar z106 = z56 * z105 - z64;
    const Scalar z107 = z57 * z105 + z65;
    const Scalar z108 = k13 * s_epsilon - k14 * c_epsilon;
    const Scalar z109 = k14 * s_epsilon + k13 * c_epsilon;
    const Scalar z110 = k2 - z108;
    const Scalar z111 = k3 + z109;
    const Scalar z112 = k13 * v_epsilon;
    const Scalar z113 = k14 * v_epsilon;
    const Scalar z114 = s_epsilon * z113 + c_epsilon * z112;
    const Scalar z115 = s_epsilon * z112 - c_epsilon * z113;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z118 = n0_018 * v_gamma;
    const Scalar z119 = n0_02 * v_gamma;
    const Scalar z120 = s_gamma * z119 - c_gamma * z118;
    const Scalar z121 = s_gamma * z118 + c_gamma * z119;
    const Scalar z122 = k8 - z116;
    const Scalar z123 = k9 + z117;
    const Scalar z124 = n0_028 * z37;
    const Scalar z125 = n0_028 * z36;
    const Scalar z126 = n0_028 * z41;
    const Scalar z127 = z36 * z126 - z42;
    const Scalar z128 = z37 * z126 - z43;
    const Scalar z129 = z38 - z124;
    const Scalar z130 = z39 - z125;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z133 = n0_035 * v_gamma;
    const Scalar z134 = c_gamma * z133;
    const Scalar z135 = s_gamma * z133;
    const Scalar z136 = k8 - z131;
    const Scalar z137 = k9 - z132;
    const Scalar z138 = n0_02 * z45;
    const Scalar z139 = n0_02 * z46;
    const Scalar z140 = n0_02 * z52;
    const Scalar z141 = z46 * z140 - z53;
    const Scalar z142 = z45 * z140 + z54;
    const Scalar z143 = z49 - z138;
    const Scalar z144 = z50 + z139;
    const Scalar z145 = z47 + z138;
    const Scalar z146 = z48 - z139;
    const Scalar z149 = n0_02 * z57;
    const Scalar z150 = n0_02 * z56;
    const Scalar z151 = n0_02 * z63;
    const Scalar z152 = z56 * z151 - z64;
    const Scalar z153 = z57 * z151 + z65;
    const Scalar z154 = z60 - z149;
    const Scalar z155 = z61 - z150;
    const Scalar z156 = z58 + z149;
    const Scalar z157 = z59 - z150;
    result.S1_position[0] = z66;
    result.S1_position[1] = z67;
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
    result.S1_velocity[0] = -z69;
    result.S1_velocity[1] = z70;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_beta;
    result.S2_position[0] = z73;
    result.S2_position[1] = z74;
    result.S2_position[2] = n0;
    result.S2_rotation[0] = z37;
    result.S2_rotation[1] = z36;
    result.S2_rotation[2] = n0;
    result.S2_rotation[3] = -z36;
    result.S2_rotation[4] = z37;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = n0;
    result.S2_rotation[7] = n0;
    result.S2_rotation[8] = n1;
    result.S2_velocity[0] = z76;
    result.S2_velocity[1] = -z77;
    result.S2_velocity[2] = n0;
    result.S2_angular_velocity[0] = n0;
    result.S2_angular_velocity[1] = n0;
    result.S2_angular_velocity[2] = z41;
    result.S3_position[0] = -z80;
    result.S3_position[1] = z81;
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
    result.S3_velocity[0] = -z84;
    result.S3_velocity[1] = z85;
    result.S3_velocity[2] = n0;
    result.S3_angular_velocity[0] = n0;
    result.S3_angular_velocity[1] = n0;
    result.S3_angular_velocity[2] = v_gamma;
    result.S4_position[0] = -z88;
    result.S4_position[1] = -z89;
    result.S4_position[2] = n0;
    result.S4_rotation[0] = z46;
    result.S4_rotation[1] = z45;
    result.S4_rotation[2] = n0;
    result.S4_rotation[3] = -z45;
    result.S4_rotation[4] = z46;
    result.S4_rotation[5] = n0;
    result.S4_rotation[6] = n0;
    result.S4_rotation[7] = n0;
    result.S4_rotation[8] = n1;
    result.S4_velocity[0] = z91;
    result.S4_velocity[1] = z92;
    result.S4_velocity[2] = n0;
    result.S4_angular_velocity[0] = n0;
    result.S4_angular_velocity[1] = n0;
    result.S4_angular_velocity[2] = z52;
    result.S5_position[0] = -z95;
    result.S5_position[1] = -z96;
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
    result.S5_velocity[0] = -z99;
    result.S5_velocity[1] = -z100;
    result.S5_velocity[2] = n0;
    result.S5_angular_velocity[0] = n0;
    result.S5_angular_velocity[1] = n0;
    result.S5_angular_velocity[2] = v_delta;
    result.S6_position[0] = -z103;
    result.S6_position[1] = -z104;
    result.S6_position[2] = n0;
    result.S6_rotation[0] = z57;
    result.S6_rotation[1] = z56;
    result.S6_rotation[2] = n0;
    result.S6_rotation[3] = -z56;
    result.S6_rotation[4] = z57;
    result.S6_rotation[5] = n0;
    result.S6_rotation[6] = n0;
    result.S6_rotation[7] = n0;
    result.S6_rotation[8] = n1;
    result.S6_velocity[0] = -z106;
    result.S6_velocity[1] = z107;
    result.S6_velocity[2] = n0;
    result.S6_angular_velocity[0] = n0;
    result.S6_angular_velocity[1] = n0;
    result.S6_angular_velocity[2] = z63;
    result.S7_position[0] = -z110;
    result.S7_position[1] = -z111;
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
    result.S7_velocity[0] = z114;
    result.S7_velocity[1] = z115;
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
    result.D_position[0] = -z122;
    result.D_position[1] = z123;
    result.D_position[2] = n0;
    result.D_velocity[0] = -z120;
    result.D_velocity[1] = z121;
    result.D_velocity[2] = n0;
    result.D_jacobian[0] = n0;
    result.D_jacobian[3] = n0;
    result.D_jacobian[6] = -z117;
    result.D_jacobian[9] = n0;
    result.D_jacobian[12] = n0;
    result.D_jacobian[15] = n0;
    result.D_jacobian[18] = n0;
    result.D_jacobian[1] = n0;
    result.D_jacobian[4] = n0;
    result.D_jacobian[7] = z116;
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
    result.E2_position[0] = z129;
    result.E2_position[1] = z130;
    result.E2_position[2] = n0;
    result.E2_velocity[0] = z127;
    result.E2_velocity[1] = -z128;
    result.E2_velocity[2] = n0;
    result.E2_jacobian[0] = -z130;
    result.E2_jacobian[3] = z125;
    result.E2_jacobian[6] = n0;
    result.E2_jacobian[9] = n0;
    result.E2_jacobian[12] = n0;
    result.E2_jacobian[15] = n0;
    result.E2_jacobian[18] = n0;
    result.E2_jacobian[1] = z129;
    result.E2_jacobian[4] = -z124;
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
    result.E3_position[0] = -z136;
    result.E3_position[1] = z137;
    result.E3_position[2] = n0;
    result.E3_velocity[0] = z134;
    result.E3_velocity[1] = z135;
    result.E3_velocity[2] = n0;
    result.E3_jacobian[0] = n0;
    result.E3_jacobian[3] = n0;
    result.E3_jacobian[6] = z132;
    result.E3_jacobian[9] = n0;
    result.E3_jacobian[12] = n0;
    result.E3_jacobian[15] = n0;
    result.E3_jacobian[18] = n0;
    result.E3_jacobian[1] = n0;
    result.E3_jacobian[4] = n0;
    result.E3_jacobian[7] = z131;
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
    result.E4_position[0] = -z143;
    result.E4_position[1] = -z144;
    result.E4_position[2] = n0;
    result.E4_velocity[0] = z141;
    result.E4_velocity[1] = z142;
    result.E4_velocity[2] = n0;
    result.E4_jacobian[0] = n0;
    result.E4_jacobian[3] = n0;
    result.E4_jacobian[6] = n0;
    result.E4_jacobian[9] = z139;
    result.E4_jacobian[12] = -z146;
    result.E4_jacobian[15] = n0;
    result.E4_jacobian[18] = n0;
    result.E4_jacobian[1] = n0;
    result.E4_jacobian[4] = n0;
    result.E4_jacobian[7] = n0;
    result.E4_jacobian[10] = z138;
    result.E4_jacobian[13] = z145;
    result.E4_jacobian[16] = n0;
    result.E4_jacobian[19] = n0;
    result.E4_jacobian[2] = n0;
    result.E4_jacobian[5] = n0;
    result.E4_jacobian[8] = n0;
    result.E4_jacobian[11] = n0;
    result.E4_jacobian[14] = n0;
    result.E4_jacobian[17] = n0;
    result.E4_jacobian[20] = n0;
    result.E6_position[0] = -z154;
    result.E6_position[1] = -z155;
    result.E6_position[2] = n0;
    result.E6_velocity[0] = -z152;
    result.E6_velocity[1] = z153;
    result.E6_velocity[2] = n0;
    result.E6_jacobian[0] = n0;
    result.E6_jacobian[3] = n0;
    result.E6_jacobian[6] = n0;
    result.E6_jacobian[9] = n0;
    result.E6_jacobian[12] = n0;
    result.E6_jacobian[15] = -z150;
    result.E6_jacobian[18] = z157;
    result.E6_jacobian[1] = n0;
    result.E6_jacobian[4] = n0;
    result.E6_jacobian[7] = n0;
    result.E6_jacobian[10] = n0;
    result.E6_jacobian[13] = n0;
    result.E6_jacobian[16] = z149;
    result.E6_jacobian[19] = z156;
    result.E6_jacobian[2] = n0;
    result.E6_jacobian[5] = n0;
    result.E6_jacobian[8] = n0;
    result.E6_jacobian[11] = n0;
    result.E6_jacobian[14] = n0;
    result.E6_jacobian[17] = n0;
    result.E6_jacobian[20] = n0;
    result.F_position[0] = z38;
    result.F_position[1] = z39;
    result.F_position[2] = n0;
    result.F_velocity[0] = -z42;
    result.F_velocity[1] = z43;
    result.F_velocity[2] = n0;
    result.F_jacobian[0] = -z39;
    result.F_jacobian[3] = n0;
    result.F_jacobian[6] = n0;
    result.F_jacobian[9] = n0;
    result.F_jacobian[12] = n0;
    result.F_jacobian[15] = n0;
    result.F_jacobian[18] = n0;
    result.F_jacobian[1] = z38;
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
    const Scalar z160 = k0 * s_Omega;
    const Scalar z162 = k1 - z160;
    const Scalar z170 = k1 - n2 * z160;
    const Scalar z175 = k3 + z170;
    const Scalar z177 = k0 * s_Phi;
    const Scalar z178 = k1 + z177;
    const Scalar z186 = k1 + n2 * z177;
    const Scalar z191 = k4 + z186;
    const Scalar z193 = k5 * c_Theta;
    const Scalar z194 = k6 - n0_175 * z193;
    const Scalar z202 = k6 - n0_35 * z193;
    const Scalar z205 = k9 + z202;
    mass[0] = z205;
    mass[1] = z194;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = z194;
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
    mass[25] = z178;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = z178;
    mass[32] = z191;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k1;
    mass[41] = z162;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = z162;
    mass[48] = z175;
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
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z122 = k2 - z116;
    const Scalar z123 = k3 + z117;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z214 = k6 * s_gamma + k7 * c_gamma;
    const Scalar z215 = k7 * s_gamma - k6 * c_gamma;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z220 = n1 / z219;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z223 = z216 * z221;
    const Scalar z224 = z217 * z221;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z227 = n0_175 * z226;
    const Scalar z229 = s_Theta * z227;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z231 = c_Phi * z230;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z235 = c_Omega * z233;
    const Scalar z236 = z63 * z63;
    const Scalar z237 = k12 * z236;  // force on K6, times 0.04 m, x
    const Scalar z238 = k12 * z235;  // moment on K6, z
    const Scalar z239 = c_Omega * z237;
    const Scalar z243 = z238 - z239;  // moment on K7, z
    const Scalar z244 = z52 * z52;
    const Scalar z245 = k12 * z244;  // force on K4, times 0.04 m, y
    const Scalar z246 = k12 * z231;  // moment on K4, z
    const Scalar z248 = c_Phi * z245;
    const Scalar z251 = z246 - z248;  // moment on K5, z
    const Scalar z255 = z41 * z41;
    const Scalar z256 = k13 * z255;  // force on K2, times 0.04 m, x
    const Scalar z257 = k13 * z229;  // moment on K2, z
    const Scalar z259 = s_Theta * z256;
    const Scalar z261 = n0_033 + z257 - n0_175 * z259;  // moment on K1, z
    forces.beta = -z261;
    forces.Theta = -z257;
    forces.gamma = z225;
    forces.Phi = -z246;
    forces.delta = -z251;
    forces.Omega = z238;
    forces.epsilon = z243;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k3 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k7 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k8 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k13 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k14 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k15 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k16 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k17 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k18 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar k19 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k21 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
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
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z122 = k2 - z116;
    const Scalar z123 = k3 + z117;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z214 = k7 * s_gamma + k8 * c_gamma;
    const Scalar z215 = k8 * s_gamma - k7 * c_gamma;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z220 = n1 / z219;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z223 = z216 * z221;
    const Scalar z224 = z217 * z221;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z227 = n0_175 * z226;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z236 = z63 * z63;
    const Scalar z237 = k13 * z236;  // force on K6, times 0.04 m, x
    const Scalar z244 = z52 * z52;
    const Scalar z245 = k13 * z244;  // force on K4, times 0.04 m, y
    const Scalar z255 = z41 * z41;
    const Scalar z256 = k14 * z255;  // force on K2, times 0.04 m, x
    const Scalar z262 = n0_175 * a_beta;
    const Scalar z264 = s_Theta * z227 + c_Theta * z262;
    const Scalar z265 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z266 = a_delta * s_Phi - c_Phi * z230;
    const Scalar z268 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z270 = a_epsilon * s_Omega - c_Omega * z233;
    const Scalar z271 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z272 = k13 * z271;  // force on K6, times 0.04 m, y
    const Scalar z273 = k13 * z270 - k15 * z271;  // moment on K6, z
    const Scalar z274 = s_Omega * z272 + c_Omega * z237;
    const Scalar z278 = k16 * a_epsilon - z273 - z274;  // moment on K7, z
    const Scalar z279 = k13 * z268;  // force on K4, times 0.04 m, x
    const Scalar z280 = k13 * z266 + k15 * z268;  // moment on K4, z
    const Scalar z282 = s_Phi * z279 + c_Phi * z245;
    const Scalar z285 = k17 * a_delta + z280 + z282;  // moment on K5, z
    const Scalar z288 = k18 * a_gamma + z225;  // moment on K3, z
    const Scalar z289 = k14 * z265;  // force on K2, times 0.04 m, y
    const Scalar z290 = k14 * z264 - k19 * z265;  // moment on K2, z
    const Scalar z292 = s_Theta * z256 - c_Theta * z289;
    const Scalar z295 = n0_033 - k21 * a_beta + z290 - n0_175 * z292;  // moment on K1, z
    const Scalar z296 = n0_028 * c_Theta;
    const Scalar z297 = n0_028 * s_Theta;
    const Scalar z298 = n0_007 - z296;
    const Scalar z299 = s_beta * z297 + c_beta * z298;
    const Scalar z300 = s_beta * z298 - c_beta * z297;
    const Scalar z313 = s_beta * z296 + c_beta * z297;
    const Scalar z332 = s_beta * z297 - c_beta * z296;
    const Scalar z337 = n0_02 * s_Phi;
    const Scalar z338 = n0_02 * c_Phi;
    const Scalar z339 = n0_04 + z337;
    const Scalar z340 = s_delta * z338 + c_delta * z339;
    const Scalar z341 = s_delta * z339 - c_delta * z338;
    const Scalar z354 = s_delta * z337 - c_delta * z338;
    const Scalar z369 = s_delta * z338 + c_delta * z337;
    const Scalar z372 = n0_02 * c_Omega;
    const Scalar z373 = n0_02 * s_Omega;
    const Scalar z374 = n0_04 - z373;
    const Scalar z375 = s_epsilon * z374 + c_epsilon * z372;
    const Scalar z376 = s_epsilon * z372 - c_epsilon * z374;
    const Scalar z389 = s_epsilon * z372 + c_epsilon * z373;
    const Scalar z404 = s_epsilon * z373 - c_epsilon * z372;
    forces.beta = -z299 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z300 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z295;
    forces.Theta = -z313 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z332 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) - z290;
    forces.gamma = z131 * l_lambda_E3_y + z132 * l_lambda_E3_x + z288;
    forces.Phi = z280 - z354 * l_lambda_E4_x + z369 * l_lambda_E4_y;
    forces.delta = z285 + z340 * l_lambda_E4_y - z341 * l_lambda_E4_x;
    forces.Omega = -z273 - z389 * l_lambda_E6_x - z404 * l_lambda_E6_y;
    forces.epsilon = z278 + z375 * l_lambda_E6_y - z376 * l_lambda_E6_x;
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
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k5 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k6 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k9 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k10 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k11 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k14 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k17 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k18 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
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
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z122 = k2 - z116;
    const Scalar z123 = k3 + z117;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z160 = k5 * s_Omega;
    const Scalar z162 = k6 - z160;
    const Scalar z170 = k6 - n2 * z160;
    const Scalar z175 = k8 + z170;
    const Scalar z177 = k5 * s_Phi;
    const Scalar z178 = k6 + z177;
    const Scalar z186 = k6 + n2 * z177;
    const Scalar z191 = k9 + z186;
    const Scalar z193 = k10 * c_Theta;
    const Scalar z194 = k11 - n0_175 * z193;
    const Scalar z202 = k11 - n0_35 * z193;
    const Scalar z205 = k14 + z202;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z214 = k17 * s_gamma + k18 * c_gamma;
    const Scalar z215 = k18 * s_gamma - k17 * c_gamma;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z220 = n1 / z219;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z223 = z216 * z221;
    const Scalar z224 = z217 * z221;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z227 = n0_175 * z226;
    const Scalar z229 = s_Theta * z227;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z231 = c_Phi * z230;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z235 = c_Omega * z233;
    const Scalar z236 = z63 * z63;
    const Scalar z237 = k5 * z236;  // force on K6, times 0.04 m, x
    const Scalar z238 = k5 * z235;  // moment on K6, z
    const Scalar z239 = c_Omega * z237;
    const Scalar z243 = z238 - z239;  // moment on K7, z
    const Scalar z244 = z52 * z52;
    const Scalar z245 = k5 * z244;  // force on K4, times 0.04 m, y
    const Scalar z246 = k5 * z231;  // moment on K4, z
    const Scalar z248 = c_Phi * z245;
    const Scalar z251 = z246 - z248;  // moment on K5, z
    const Scalar z255 = z41 * z41;
    const Scalar z256 = k10 * z255;  // force on K2, times 0.04 m, x
    const Scalar z257 = k10 * z229;  // moment on K2, z
    const Scalar z259 = s_Theta * z256;
    const Scalar z261 = n0_033 + z257 - n0_175 * z259;  // moment on K1, z
    const Scalar z296 = n0_028 * c_Theta;
    const Scalar z297 = n0_028 * s_Theta;
    const Scalar z298 = n0_007 - z296;
    const Scalar z299 = s_beta * z297 + c_beta * z298;
    const Scalar z300 = s_beta * z298 - c_beta * z297;
    const Scalar z303 = v_gamma * c_gamma;
    const Scalar z305 = v_beta * c_beta;
    const Scalar z306 = v_Theta * c_Theta;
    const Scalar z307 = n0_028 * z306;
    const Scalar z308 = v_beta * s_beta;
    const Scalar z309 = v_Theta * s_Theta;
    const Scalar z310 = n0_028 * z309;
    const Scalar z313 = s_beta * z296 + c_beta * z297;
    const Scalar z318 = v_gamma * s_gamma;
    const Scalar z319 = v_gamma * z318;
    const Scalar z320 = n0_035 * z319;
    const Scalar z321 = v_Theta * z309;
    const Scalar z322 = n0_028 * z321;
    const Scalar z323 = v_Theta * z306;
    const Scalar z324 = n0_028 * z323;
    const Scalar z325 = v_beta * z308;
    const Scalar z326 = v_beta * z305;
    const Scalar z327 = -n2 * (z305 * z307 - z308 * z310) + s_beta * z322 - c_beta * z324 + z297 * z325 + z298 * z326;
    const Scalar z328 = z320 - z327;
    const Scalar z332 = s_beta * z297 - c_beta * z296;
    const Scalar z333 = v_gamma * z303;
    const Scalar z334 = n0_035 * z333;
    const Scalar z335 = n2 * (z305 * z310 + z307 * z308) + s_beta * z324 + c_beta * z322 + z297 * z326 - z298 * z325;
    const Scalar z336 = z334 - z335;
    const Scalar z337 = n0_02 * s_Phi;
    const Scalar z338 = n0_02 * c_Phi;
    const Scalar z339 = n0_04 + z337;
    const Scalar z340 = s_delta * z338 + c_delta * z339;
    const Scalar z341 = s_delta * z339 - c_delta * z338;
    const Scalar z346 = v_delta * c_delta;
    const Scalar z347 = v_Phi * s_Phi;
    const Scalar z348 = n0_02 * z347;
    const Scalar z349 = v_delta * s_delta;
    const Scalar z350 = v_Phi * c_Phi;
    const Scalar z351 = n0_02 * z350;
    const Scalar z354 = s_delta * z337 - c_delta * z338;
    const Scalar z359 = v_Phi * z350;
    const Scalar z360 = n0_02 * z359;
    const Scalar z361 = v_Phi * z347;
    const Scalar z362 = n0_02 * z361;
    const Scalar z363 = v_delta * z349;
    const Scalar z364 = v_delta * z346;
    const Scalar z365 = n2 * (z346 * z348 + z349 * z351) + s_delta * z360 + c_delta * z362 + z338 * z363 + z339 * z364;
    const Scalar z366 = z327 - z365;
    const Scalar z369 = s_delta * z338 + c_delta * z337;
    const Scalar z370 = -n2 * (z346 * z351 - z348 * z349) + s_delta * z362 - c_delta * z360 - z338 * z364 + z339 * z363;
    const Scalar z371 = z335 + z370;
    const Scalar z372 = n0_02 * c_Omega;
    const Scalar z373 = n0_02 * s_Omega;
    const Scalar z374 = n0_04 - z373;
    const Scalar z375 = s_epsilon * z374 + c_epsilon * z372;
    const Scalar z376 = s_epsilon * z372 - c_epsilon * z374;
    const Scalar z381 = v_epsilon * c_epsilon;
    const Scalar z382 = v_Omega * c_Omega;
    const Scalar z383 = n0_02 * z382;
    const Scalar z384 = v_epsilon * s_epsilon;
    const Scalar z385 = v_Omega * s_Omega;
    const Scalar z386 = n0_02 * z385;
    const Scalar z389 = s_epsilon * z372 + c_epsilon * z373;
    const Scalar z394 = v_Omega * z385;
    const Scalar z395 = n0_02 * z394;
    const Scalar z396 = v_Omega * z382;
    const Scalar z397 = n0_02 * z396;
    const Scalar z398 = v_epsilon * z381;
    const Scalar z399 = v_epsilon * z384;
    const Scalar z400 = -n2 * (z381 * z383 - z384 * z386) + s_epsilon * z395 - c_epsilon * z397 - z372 * z398 - z374
        * z399;
    const Scalar z401 = z327 + z400;
    const Scalar z404 = s_epsilon * z373 - c_epsilon * z372;
    const Scalar z405 = n2 * (z381 * z386 + z383 * z384) + s_epsilon * z397 + c_epsilon * z395 + z372 * z399 - z374
        * z398;
    const Scalar z406 = z335 + z405;
    const Scalar z413 = n1 / z175;
    const Scalar z414 = z162 * z413;
    const Scalar z415 = k6 - z162 * z414;
    const Scalar z416 = n1 / z415;
    const Scalar z417 = n1 / z191;
    const Scalar z418 = z178 * z417;
    const Scalar z419 = k6 - z178 * z418;
    const Scalar z420 = n1 / z419;
    const Scalar z421 = k26 * z194;
    const Scalar z422 = z194 * z421 - z205;
    const Scalar z423 = n1 / z422;
    const Scalar z424 = z300 + z313 * z421;
    const Scalar z425 = z423 * z424;
    const Scalar z426 = k26 * z313 - z421 * z425;
    const Scalar z427 = k27 * z132;
    const Scalar z428 = z299 - z332 * z421;
    const Scalar z429 = z423 * z428;
    const Scalar z430 = k26 * z332 + z421 * z429;
    const Scalar z431 = k27 * z131;
    const Scalar z432 = z341 * z418 - z354;
    const Scalar z433 = z420 * z432;
    const Scalar z434 = z341 * z417 + z418 * z433;
    const Scalar z435 = z340 * z418 - z369;
    const Scalar z436 = z420 * z435;
    const Scalar z437 = z340 * z417 + z418 * z436;
    const Scalar z438 = z376 * z414 - z389;
    const Scalar z439 = z416 * z438;
    const Scalar z440 = z376 * z413 + z414 * z439;
    const Scalar z441 = z375 * z414 + z404;
    const Scalar z442 = z416 * z441;
    const Scalar z443 = z375 * z413 + z414 * z442;
    const Scalar z444 = z132 * z427 - z300 * z425 + z313 * z426;
    const Scalar z445 = z131 * z427 + z299 * z425 + z332 * z426;
    const Scalar z446 = z131 * z431 - z299 * z429 + z332 * z430;
    const Scalar z447 = z300 * z425 - z313 * z426;
    const Scalar z448 = z300 * z429 + z313 * z430;
    const Scalar z449 = z300 * z425 - z313 * z426 - z341 * z434 + z354 * z433;
    const Scalar z450 = z299 * z425 + z332 * z426;
    const Scalar z451 = z299 * z429 - z332 * z430;
    const Scalar z452 = z299 * z425 + z332 * z426 - z340 * z434 + z369 * z433;
    const Scalar z453 = z299 * z429 - z332 * z430 - z340 * z437 + z369 * z436;
    const Scalar z454 = z300 * z425 - z313 * z426 - z376 * z440 + z389 * z439;
    const Scalar z455 = z299 * z425 + z332 * z426 - z375 * z440 - z404 * z439;
    const Scalar z456 = z299 * z429 - z332 * z430 - z375 * z443 - z404 * z442;
    const Scalar z457 = n1 / z456;
    const Scalar z458 = z450 * z457;
    const Scalar z459 = z451 * z457;
    const Scalar z460 = z455 * z457;
    const Scalar z461 = z444 + z450 * z458;
    const Scalar z462 = z445 - z450 * z459;
    const Scalar z463 = z446 + z451 * z459;
    const Scalar z464 = z447 - z450 * z458;
    const Scalar z465 = z448 - z451 * z458;
    const Scalar z466 = z449 - z450 * z458;
    const Scalar z467 = z450 * (n1 - z459);
    const Scalar z468 = z451 * (n1 - z459);
    const Scalar z469 = z450 * z459 - z452;
    const Scalar z470 = z451 * z459 - z453;
    const Scalar z471 = z447 - z450 * z460;
    const Scalar z472 = z448 - z451 * z460;
    const Scalar z473 = z454 - z455 * z460;
    const Scalar z474 = n1 / z473;
    const Scalar z475 = z471 * z474;
    const Scalar z476 = z472 * z474;
    const Scalar z477 = z461 + z471 * z475;
    const Scalar z478 = z462 - z471 * z476;
    const Scalar z479 = z463 + z472 * z476;
    const Scalar z480 = z464 - z471 * z475;
    const Scalar z481 = z465 - z472 * z475;
    const Scalar z482 = z466 - z471 * z475;
    const Scalar z483 = z467 - z471 * z476;
    const Scalar z484 = z468 - z472 * z476;
    const Scalar z485 = z469 + z471 * z476;
    const Scalar z486 = z470 + z472 * z476;
    const Scalar z487 = n1 / z486;
    const Scalar z488 = z483 * z487;
    const Scalar z489 = z484 * z487;
    const Scalar z490 = z485 * z487;
    const Scalar z491 = z477 - z483 * z488;
    const Scalar z492 = z478 + z483 * z489;
    const Scalar z493 = z479 - z484 * z489;
    const Scalar z494 = z480 - z483 * z490;
    const Scalar z495 = z481 - z484 * z490;
    const Scalar z496 = z482 + z485 * z490;
    const Scalar z497 = n1 / z496;
    const Scalar z498 = z494 * z497;
    const Scalar z499 = z495 * z497;
    const Scalar z500 = z491 + z494 * z498;
    const Scalar z501 = z492 - z494 * z499;
    const Scalar z502 = z493 + z495 * z499;
    const Scalar z503 = n1 / z502;
    const Scalar z504 = z501 * z503;
    const Scalar z505 = z500 - z501 * z504;
    const Scalar z506 = n1 / z505;
    const Scalar z507 = z238 - z243 * z414;
    const Scalar z508 = z246 - z251 * z418;
    const Scalar z509 = z257 * z421 - z261;
    const Scalar z510 = z423 * z509;
    const Scalar z511 = k26 * z257 - z421 * z510;
    const Scalar z512 = k27 * z225;
    const Scalar z513 = z420 * z508;
    const Scalar z514 = z251 * z417 - z418 * z513;
    const Scalar z515 = z416 * z507;
    const Scalar z516 = z243 * z413 - z414 * z515;
    const Scalar z517 = z132 * z512 - z300 * z510 + z313 * z511 + z328;
    const Scalar z518 = z131 * z512 + z299 * z510 + z332 * z511 - z336;
    const Scalar z519 = z300 * z510 - z313 * z511 - z341 * z514 - z354 * z513 + z366;
    const Scalar z520 = z299 * z510 + z332 * z511 - z340 * z514 - z369 * z513 + z371;
    const Scalar z521 = z300 * z510 - z313 * z511 + z376 * z516 + z389 * z515 + z401;
    const Scalar z522 = z299 * z510 + z332 * z511 + z375 * z516 - z404 * z515 + z406;
    const Scalar z523 = z460 * z522 - z521;
    const Scalar z524 = z459 * z522 - z476 * z523 - z520;
    const Scalar z525 = z458 * z522 - z475 * z523 - z490 * z524 - z519;
    const Scalar z526 = z459 * z522 - z476 * z523 + z489 * z524 - z499 * z525 - z518;
    const Scalar z527 = z458 * z522 - z475 * z523 + z488 * z524 - z498 * z525 + z504 * z526 + z517;
    const Scalar z528 = z506 * z527;
    const Scalar z529 = z503 * z526 + z504 * z528;
    const Scalar z530 = z497 * z525 + z498 * z528 + z499 * z529;
    const Scalar z531 = z487 * z524 + z488 * z528 + z489 * z529 + z490 * z530;
    const Scalar z532 = z475 * (z528 - z530) + z476 * (z529 + z531) + z474 * z523;
    const Scalar z533 = -z458 * (z528 - z530) - z459 * (z529 + z531) + z457 * z522 + z460 * z532;
    const Scalar z534 = z425 * (z528 - z530 - z532) + z429 * (z529 + z531 + z533) - z510;
    const Scalar z535 = z426 * (z528 - z530 - z532) - z430 * (z529 + z531 + z533) - z511;
    const Scalar z536 = z427 * z528 - z431 * z529 - z512;
    const Scalar z537 = z433 * z530 - z436 * z531 - z513;
    const Scalar z538 = z434 * z530 - z437 * z531 + z514;
    const Scalar z539 = z439 * z532 - z442 * z533 + z515;
    const Scalar z540 = z440 * z532 - z443 * z533 - z516;
    accelerations.beta = -z534;
    accelerations.Theta = -z535;
    accelerations.gamma = z536;
    accelerations.Phi = -z537;
    accelerations.delta = z538;
    accelerations.Omega = -z539;
    accelerations.epsilon = z540;
    multipliers.lambda_E3_x = -z528;
    multipliers.lambda_E3_y = z529;
    multipliers.lambda_E4_x = z530;
    multipliers.lambda_E4_y = z531;
    multipliers.lambda_E6_x = z532;
    multipliers.lambda_E6_y = z533;
    if (!(traits::regular(-z422, z205) && traits::regular(z419, k6) && traits::regular(z191, z191)
        && traits::regular(z415, k6) && traits::regular(z175, z175) && traits::regular(z505, z444)
        && traits::regular(z502, z446) && traits::regular(-z496, -z449) && traits::regular(z486, -z453)
        && traits::regular(-z473, -z454) && traits::regular(-z456, -z456))) return torsor::Status::singular;
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
    const Scalar k9 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k10 = traits::constant(0.00365, 0.00365f, "73/20000");
    const Scalar k11 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar k12 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k13 = traits::constant(0.00706, 0.00706f, "353/50000");
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
    const Scalar z40 = n0_007 * v_beta;
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z51 = n0_04 * v_delta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z62 = n0_04 * v_epsilon;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z122 = k4 - z116;
    const Scalar z123 = k5 + z117;
    const Scalar z206 = s_Theta * z40;
    const Scalar z207 = c_Theta * z40;
    const Scalar z208 = s_Phi * z51;
    const Scalar z209 = c_Phi * z51;
    const Scalar z210 = c_Omega * z62;
    const Scalar z211 = s_Omega * z62;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z222 = k8 - z219;
    const Scalar z541 = k9 * z41 - k10 * z207;
    const Scalar z542 = k11 * z41 - k9 * z207;
    const Scalar z543 = k12 * z52 + k13 * z208;
    const Scalar z544 = k14 * z52 + k12 * z208;
    const Scalar z545 = k12 * z63 - k13 * z211;
    const Scalar z546 = k14 * z63 - k12 * z211;
    result.kinetic = n0_5 * (z41 * z542 + z52 * z544 + z63 * z546 - z207 * z541 + z208 * z543 - z211 * z545) + k16
        * (z209 * z209 + z210 * z210) + k17 * v_beta * v_beta + k18 * v_gamma * v_gamma + k19 * v_delta * v_delta + k20
        * v_epsilon * v_epsilon + k21 * z206 * z206;
    result.force_function = -n2265 * z222 * z222;
    result.power = n0_033 * v_beta;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k1 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k2 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k8 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k9 = traits::constant(0.00227, 0.00227f, "227/100000");
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
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z136 = k1 - z131;
    const Scalar z137 = k2 - z132;
    const Scalar z296 = n0_028 * c_Theta;
    const Scalar z297 = n0_028 * s_Theta;
    const Scalar z298 = n0_007 - z296;
    const Scalar z299 = s_beta * z297 + c_beta * z298;
    const Scalar z300 = s_beta * z298 - c_beta * z297;
    const Scalar z301 = z136 + z299;
    const Scalar z302 = z137 - z300;
    const Scalar z303 = v_gamma * c_gamma;
    const Scalar z304 = n0_035 * z303;
    const Scalar z305 = v_beta * c_beta;
    const Scalar z306 = v_Theta * c_Theta;
    const Scalar z307 = n0_028 * z306;
    const Scalar z308 = v_beta * s_beta;
    const Scalar z309 = v_Theta * s_Theta;
    const Scalar z310 = n0_028 * z309;
    const Scalar z311 = s_beta * z307 + c_beta * z310 + z297 * z305 - z298 * z308;
    const Scalar z312 = z304 - z311;
    const Scalar z313 = s_beta * z296 + c_beta * z297;
    const Scalar z318 = v_gamma * s_gamma;
    const Scalar z319 = v_gamma * z318;
    const Scalar z320 = n0_035 * z319;
    const Scalar z321 = v_Theta * z309;
    const Scalar z322 = n0_028 * z321;
    const Scalar z323 = v_Theta * z306;
    const Scalar z324 = n0_028 * z323;
    const Scalar z325 = v_beta * z308;
    const Scalar z326 = v_beta * z305;
    const Scalar z327 = -n2 * (z305 * z307 - z308 * z310) + s_beta * z322 - c_beta * z324 + z297 * z325 + z298 * z326;
    const Scalar z328 = z320 - z327;
    const Scalar z329 = n0_035 * z318;
    const Scalar z330 = s_beta * z310 - c_beta * z307 + z297 * z308 + z298 * z305;
    const Scalar z331 = z329 - z330;
    const Scalar z332 = s_beta * z297 - c_beta * z296;
    const Scalar z333 = v_gamma * z303;
    const Scalar z334 = n0_035 * z333;
    const Scalar z335 = n2 * (z305 * z310 + z307 * z308) + s_beta * z324 + c_beta * z322 + z297 * z326 - z298 * z325;
    const Scalar z336 = z334 - z335;
    const Scalar z337 = n0_02 * s_Phi;
    const Scalar z338 = n0_02 * c_Phi;
    const Scalar z339 = n0_04 + z337;
    const Scalar z340 = s_delta * z338 + c_delta * z339;
    const Scalar z341 = s_delta * z339 - c_delta * z338;
    const Scalar z342 = k8 - z340;
    const Scalar z343 = k9 - z341;
    const Scalar z344 = z299 + z342;
    const Scalar z345 = z300 + z343;
    const Scalar z346 = v_delta * c_delta;
    const Scalar z347 = v_Phi * s_Phi;
    const Scalar z348 = n0_02 * z347;
    const Scalar z349 = v_delta * s_delta;
    const Scalar z350 = v_Phi * c_Phi;
    const Scalar z351 = n0_02 * z350;
    const Scalar z352 = s_delta * z348 - c_delta * z351 - z338 * z346 + z339 * z349;
    const Scalar z353 = z311 + z352;
    const Scalar z354 = s_delta * z337 - c_delta * z338;
    const Scalar z359 = v_Phi * z350;
    const Scalar z360 = n0_02 * z359;
    const Scalar z361 = v_Phi * z347;
    const Scalar z362 = n0_02 * z361;
    const Scalar z363 = v_delta * z349;
    const Scalar z364 = v_delta * z346;
    const Scalar z365 = n2 * (z346 * z348 + z349 * z351) + s_delta * z360 + c_delta * z362 + z338 * z363 + z339 * z364;
    const Scalar z366 = z327 - z365;
    const Scalar z367 = s_delta * z351 + c_delta * z348 + z338 * z349 + z339 * z346;
    const Scalar z368 = z330 - z367;
    const Scalar z369 = s_delta * z338 + c_delta * z337;
    const Scalar z370 = -n2 * (z346 * z351 - z348 * z349) + s_delta * z362 - c_delta * z360 - z338 * z364 + z339 * z363;
    const Scalar z371 = z335 + z370;
    const Scalar z372 = n0_02 * c_Omega;
    const Scalar z373 = n0_02 * s_Omega;
    const Scalar z374 = n0_04 - z373;
    const Scalar z375 = s_epsilon * z374 + c_epsilon * z372;
    const Scalar z376 = s_epsilon * z372 - c_epsilon * z374;
    const Scalar z377 = k8 - z375;
    const Scalar z378 = k9 - z376;
    const Scalar z379 = z299 + z377;
    const Scalar z380 = z300 + z378;
    const Scalar z381 = v_epsilon * c_epsilon;
    const Scalar z382 = v_Omega * c_Omega;
    const Scalar z383 = n0_02 * z382;
    const Scalar z384 = v_epsilon * s_epsilon;
    const Scalar z385 = v_Omega * s_Omega;
    const Scalar z386 = n0_02 * z385;
    const Scalar z387 = s_epsilon * z383 + c_epsilon * z386 + z372 * z384 - z374 * z381;
    const Scalar z388 = z311 + z387;
    const Scalar z389 = s_epsilon * z372 + c_epsilon * z373;
    const Scalar z394 = v_Omega * z385;
    const Scalar z395 = n0_02 * z394;
    const Scalar z396 = v_Omega * z382;
    const Scalar z397 = n0_02 * z396;
    const Scalar z398 = v_epsilon * z381;
    const Scalar z399 = v_epsilon * z384;
    const Scalar z400 = -n2 * (z381 * z383 - z384 * z386) + s_epsilon * z395 - c_epsilon * z397 - z372 * z398 - z374
        * z399;
    const Scalar z401 = z327 + z400;
    const Scalar z402 = s_epsilon * z386 - c_epsilon * z383 - z372 * z381 - z374 * z384;
    const Scalar z403 = z330 + z402;
    const Scalar z404 = s_epsilon * z373 - c_epsilon * z372;
    const Scalar z405 = n2 * (z381 * z386 + z383 * z384) + s_epsilon * z397 + c_epsilon * z395 + z372 * z399 - z374
        * z398;
    const Scalar z406 = z335 + z405;
    result.value[0] = z301;
    result.rate[0] = -z312;
    result.gamma[0] = z328;
    result.value[1] = -z302;
    result.rate[1] = -z331;
    result.gamma[1] = -z336;
    result.value[2] = z344;
    result.rate[2] = z353;
    result.gamma[2] = -z366;
    result.value[3] = z345;
    result.rate[3] = z368;
    result.gamma[3] = z371;
    result.value[4] = z379;
    result.rate[4] = z388;
    result.gamma[4] = -z401;
    result.value[5] = z380;
    result.rate[5] = z403;
    result.gamma[5] = z406;
    result.jacobian[0] = -z300;
    result.jacobian[1] = z299;
    result.jacobian[2] = -z300;
    result.jacobian[3] = z299;
    result.jacobian[4] = -z300;
    result.jacobian[5] = z299;
    result.jacobian[6] = z313;
    result.jacobian[7] = z332;
    result.jacobian[8] = z313;
    result.jacobian[9] = z332;
    result.jacobian[10] = z313;
    result.jacobian[11] = z332;
    result.jacobian[12] = -z132;
    result.jacobian[13] = -z131;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z354;
    result.jacobian[21] = -z369;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = z341;
    result.jacobian[27] = -z340;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = z389;
    result.jacobian[35] = z404;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z376;
    result.jacobian[41] = -z375;
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
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k5 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k6 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k9 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k10 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k11 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k14 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k17 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k18 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k22 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
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
    const Scalar z41 = v_beta + v_Theta;
    const Scalar z52 = v_delta + v_Phi;
    const Scalar z63 = v_epsilon + v_Omega;
    const Scalar z116 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z117 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z122 = k2 - z116;
    const Scalar z123 = k3 + z117;
    const Scalar z131 = n0_035 * s_gamma;
    const Scalar z132 = n0_035 * c_gamma;
    const Scalar z160 = k5 * s_Omega;
    const Scalar z162 = k6 - z160;
    const Scalar z170 = k6 - n2 * z160;
    const Scalar z175 = k8 + z170;
    const Scalar z177 = k5 * s_Phi;
    const Scalar z178 = k6 + z177;
    const Scalar z186 = k6 + n2 * z177;
    const Scalar z191 = k9 + z186;
    const Scalar z193 = k10 * c_Theta;
    const Scalar z194 = k11 - n0_175 * z193;
    const Scalar z202 = k11 - n0_35 * z193;
    const Scalar z205 = k14 + z202;
    const Scalar z212 = n0_014 + z122;
    const Scalar z213 = n0_072 - z123;
    const Scalar z214 = k17 * s_gamma + k18 * c_gamma;
    const Scalar z215 = k18 * s_gamma - k17 * c_gamma;
    const Scalar z216 = n0_02 - z214;
    const Scalar z217 = n0_018 - z215;
    const Scalar z218 = z212 * z212 + z213 * z213;
    const Scalar z219 = traits::sqrt(z218);
    const Scalar z220 = n1 / z219;
    const Scalar z221 = n4530 - n352_6605 * z220;
    const Scalar z223 = z216 * z221;
    const Scalar z224 = z217 * z221;
    const Scalar z225 = n0_018 * z223 - n0_02 * z224;
    const Scalar z226 = v_beta * v_beta;
    const Scalar z227 = n0_175 * z226;
    const Scalar z230 = v_delta * v_delta;
    const Scalar z233 = v_epsilon * v_epsilon;
    const Scalar z236 = z63 * z63;
    const Scalar z237 = k5 * z236;  // force on K6, times 0.04 m, x
    const Scalar z244 = z52 * z52;
    const Scalar z245 = k5 * z244;  // force on K4, times 0.04 m, y
    const Scalar z255 = z41 * z41;
    const Scalar z256 = k10 * z255;  // force on K2, times 0.04 m, x
    const Scalar z262 = n0_175 * a_beta;
    const Scalar z263 = s_Theta * z262 - c_Theta * z227;
    const Scalar z264 = s_Theta * z227 + c_Theta * z262;
    const Scalar z265 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z266 = a_delta * s_Phi - c_Phi * z230;
    const Scalar z267 = a_delta * c_Phi + s_Phi * z230;
    const Scalar z268 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z269 = a_epsilon * c_Omega + s_Omega * z233;
    const Scalar z270 = a_epsilon * s_Omega - c_Omega * z233;
    const Scalar z271 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z272 = k5 * z271;  // force on K6, times 0.04 m, y
    const Scalar z273 = k5 * z270 - k6 * z271;  // moment on K6, z
    const Scalar z274 = s_Omega * z272 + c_Omega * z237;
    const Scalar z275 = s_Omega * z237 - c_Omega * z272;
    const Scalar z278 = k8 * a_epsilon - z273 - z274;  // moment on K7, z
    const Scalar z279 = k5 * z268;  // force on K4, times 0.04 m, x
    const Scalar z280 = k5 * z266 + k6 * z268;  // moment on K4, z
    const Scalar z281 = s_Phi * z245 - c_Phi * z279;
    const Scalar z282 = s_Phi * z279 + c_Phi * z245;
    const Scalar z285 = k9 * a_delta + z280 + z282;  // moment on K5, z
    const Scalar z288 = k22 * a_gamma + z225;  // moment on K3, z
    const Scalar z289 = k10 * z265;  // force on K2, times 0.04 m, y
    const Scalar z290 = k10 * z264 - k11 * z265;  // moment on K2, z
    const Scalar z291 = s_Theta * z289 + c_Theta * z256;
    const Scalar z292 = s_Theta * z256 - c_Theta * z289;
    const Scalar z295 = n0_033 - k14 * a_beta + z290 - n0_175 * z292;  // moment on K1, z
    const Scalar z296 = n0_028 * c_Theta;
    const Scalar z297 = n0_028 * s_Theta;
    const Scalar z298 = n0_007 - z296;
    const Scalar z299 = s_beta * z297 + c_beta * z298;
    const Scalar z300 = s_beta * z298 - c_beta * z297;
    const Scalar z303 = v_gamma * c_gamma;
    const Scalar z304 = n0_035 * z303;
    const Scalar z305 = v_beta * c_beta;
    const Scalar z306 = v_Theta * c_Theta;
    const Scalar z307 = n0_028 * z306;
    const Scalar z308 = v_beta * s_beta;
    const Scalar z309 = v_Theta * s_Theta;
    const Scalar z310 = n0_028 * z309;
    const Scalar z311 = s_beta * z307 + c_beta * z310 + z297 * z305 - z298 * z308;
    const Scalar z313 = s_beta * z296 + c_beta * z297;
    const Scalar z318 = v_gamma * s_gamma;
    const Scalar z319 = v_gamma * z318;
    const Scalar z320 = n0_035 * z319;
    const Scalar z321 = v_Theta * z309;
    const Scalar z322 = n0_028 * z321;
    const Scalar z323 = v_Theta * z306;
    const Scalar z324 = n0_028 * z323;
    const Scalar z325 = v_beta * z308;
    const Scalar z326 = v_beta * z305;
    const Scalar z327 = -n2 * (z305 * z307 - z308 * z310) + s_beta * z322 - c_beta * z324 + z297 * z325 + z298 * z326;
    const Scalar z328 = z320 - z327;
    const Scalar z329 = n0_035 * z318;
    const Scalar z330 = s_beta * z310 - c_beta * z307 + z297 * z308 + z298 * z305;
    const Scalar z332 = s_beta * z297 - c_beta * z296;
    const Scalar z333 = v_gamma * z303;
    const Scalar z334 = n0_035 * z333;
    const Scalar z335 = n2 * (z305 * z310 + z307 * z308) + s_beta * z324 + c_beta * z322 + z297 * z326 - z298 * z325;
    const Scalar z336 = z334 - z335;
    const Scalar z337 = n0_02 * s_Phi;
    const Scalar z338 = n0_02 * c_Phi;
    const Scalar z339 = n0_04 + z337;
    const Scalar z340 = s_delta * z338 + c_delta * z339;
    const Scalar z341 = s_delta * z339 - c_delta * z338;
    const Scalar z346 = v_delta * c_delta;
    const Scalar z347 = v_Phi * s_Phi;
    const Scalar z348 = n0_02 * z347;
    const Scalar z349 = v_delta * s_delta;
    const Scalar z350 = v_Phi * c_Phi;
    const Scalar z351 = n0_02 * z350;
    const Scalar z352 = s_delta * z348 - c_delta * z351 - z338 * z346 + z339 * z349;
    const Scalar z354 = s_delta * z337 - c_delta * z338;
    const Scalar z359 = v_Phi * z350;
    const Scalar z360 = n0_02 * z359;
    const Scalar z361 = v_Phi * z347;
    const Scalar z362 = n0_02 * z361;
    const Scalar z363 = v_delta * z349;
    const Scalar z364 = v_delta * z346;
    const Scalar z365 = n2 * (z346 * z348 + z349 * z351) + s_delta * z360 + c_delta * z362 + z338 * z363 + z339 * z364;
    const Scalar z366 = z327 - z365;
    const Scalar z367 = s_delta * z351 + c_delta * z348 + z338 * z349 + z339 * z346;
    const Scalar z369 = s_delta * z338 + c_delta * z337;
    const Scalar z370 = -n2 * (z346 * z351 - z348 * z349) + s_delta * z362 - c_delta * z360 - z338 * z364 + z339 * z363;
    const Scalar z371 = z335 + z370;
    const Scalar z372 = n0_02 * c_Omega;
    const Scalar z373 = n0_02 * s_Omega;
    const Scalar z374 = n0_04 - z373;
    const Scalar z375 = s_epsilon * z374 + c_epsilon * z372;
    const Scalar z376 = s_epsilon * z372 - c_epsilon * z374;
    const Scalar z381 = v_epsilon * c_epsilon;
    const Scalar z382 = v_Omega * c_Omega;
    const Scalar z383 = n0_02 * z382;
    const Scalar z384 = v_epsilon * s_epsilon;
    const Scalar z385 = v_Omega * s_Omega;
    const Scalar z386 = n0_02 * z385;
    const Scalar z387 = s_epsilon * z383 + c_epsilon * z386 + z372 * z384 - z374 * z381;
    const Scalar z389 = s_epsilon * z372 + c_epsilon * z373;
    const Scalar z394 = v_Omega * z385;
    const Scalar z395 = n0_02 * z394;
    const Scalar z396 = v_Omega * z382;
    const Scalar z397 = n0_02 * z396;
    const Scalar z398 = v_epsilon * z381;
    const Scalar z399 = v_epsilon * z384;
    const Scalar z400 = -n2 * (z381 * z383 - z384 * z386) + s_epsilon * z395 - c_epsilon * z397 - z372 * z398 - z374
        * z399;
    const Scalar z401 = z327 + z400;
    const Scalar z402 = s_epsilon * z386 - c_epsilon * z383 - z372 * z381 - z374 * z384;
    const Scalar z404 = s_epsilon * z373 - c_epsilon * z372;
    const Scalar z405 = n2 * (z381 * z386 + z383 * z384) + s_epsilon * z397 + c_epsilon * z395 + z372 * z399 - z374
        * z398;
    const Scalar z406 = z335 + z405;
    const Scalar z592 = n2 * v_beta;
    const Scalar z593 = n0_175 * z592;
    const Scalar z594 = s_Theta * z593;
    const Scalar z595 = k10 * z594;
    const Scalar z596 = n2 * z41;
    const Scalar z597 = k10 * z596;
    const Scalar z598 = s_Theta * z597;
    const Scalar z599 = z595 - n0_175 * z598;
    const Scalar z600 = z299 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z300 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z601 = z313 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z332 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z602 = n0_175 * z598;
    const Scalar z603 = k10 * z263;
    const Scalar z604 = n0_175 * z291 + z603;
    const Scalar z605 = z313 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z332 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z604;
    const Scalar z606 = z313 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z332 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) - z603;
    const Scalar z607 = n2 * (z116 * z213 - z117 * z212);
    const Scalar z608 = n0_5 * z607 / z219;
    const Scalar z609 = z608 / (z219 * z219);
    const Scalar z610 = n352_6605 * z609;
    const Scalar z611 = z215 * z221 - z216 * z610;
    const Scalar z612 = z214 * z221 + z217 * z610;
    const Scalar z613 = n0_018 * z611 + n0_02 * z612;
    const Scalar z614 = z131 * l_lambda_E3_x - z132 * l_lambda_E3_y - z613;
    const Scalar z615 = k5 * z267;
    const Scalar z616 = z354 * l_lambda_E4_y + z369 * l_lambda_E4_x - z615;
    const Scalar z617 = n2 * z52;
    const Scalar z618 = k5 * z617;
    const Scalar z619 = c_Phi * z618;
    const Scalar z620 = z281 - z615;
    const Scalar z621 = z354 * l_lambda_E4_y + z369 * l_lambda_E4_x + z620;
    const Scalar z622 = n2 * v_delta;
    const Scalar z623 = c_Phi * z622;
    const Scalar z624 = k5 * z623;
    const Scalar z625 = z354 * l_lambda_E4_y + z369 * l_lambda_E4_x;
    const Scalar z626 = z619 - z624;
    const Scalar z627 = z340 * l_lambda_E4_x + z341 * l_lambda_E4_y;
    const Scalar z628 = k5 * z269;
    const Scalar z629 = z389 * l_lambda_E6_y - z404 * l_lambda_E6_x + z628;
    const Scalar z630 = n2 * z63;
    const Scalar z631 = k5 * z630;
    const Scalar z632 = c_Omega * z631;
    const Scalar z633 = z275 - z628;
    const Scalar z634 = z389 * l_lambda_E6_y - z404 * l_lambda_E6_x - z633;
    const Scalar z635 = n2 * v_epsilon;
    const Scalar z636 = c_Omega * z635;
    const Scalar z637 = k5 * z636;
    const Scalar z638 = z389 * l_lambda_E6_y - z404 * l_lambda_E6_x;
    const Scalar z639 = z632 - z637;
    const Scalar z640 = z375 * l_lambda_E6_x + z376 * l_lambda_E6_y;
    const Scalar z641 = a_beta * z300 - a_Theta * z313 - a_epsilon * z376 - a_Omega * z389 + z401;
    const Scalar z642 = a_beta * z300 - a_Theta * z313 - a_delta * z341 - a_Phi * z354 + z366;
    const Scalar z643 = a_beta * z300 - a_Theta * z313 + a_gamma * z132 - z328;
    const Scalar z644 = a_beta * z299 + a_Theta * z332 - a_gamma * z131 - z336;
    const Scalar z645 = a_beta * z299 + a_Theta * z332 - a_epsilon * z375 + a_Omega * z404 + z406;
    const Scalar z646 = a_beta * z299 + a_Theta * z332 - a_delta * z340 - a_Phi * z369 + z371;
    const Scalar z647 = v_beta * s_beta + z308;
    const Scalar z648 = v_beta * c_beta + z305;
    const Scalar z649 = n2 * (s_beta * z310 - c_beta * z307) + z297 * z647 + z298 * z648;
    const Scalar z650 = a_beta * z299 + a_Theta * z332 + z335;
    const Scalar z651 = n2 * (s_beta * z307 + c_beta * z310) + z297 * z648 - z298 * z647;
    const Scalar z652 = a_beta * z300 - a_Theta * z313 + z327;
    const Scalar z653 = s_beta * z310 - c_beta * z307 - z296 * z305 + z297 * z308;
    const Scalar z654 = v_Theta * s_Theta + z309;
    const Scalar z655 = n0_028 * z654;
    const Scalar z656 = v_Theta * c_Theta + z306;
    const Scalar z657 = n0_028 * z656;
    const Scalar z658 = -n2 * (z296 * z305 - z297 * z308) + s_beta * z655 - c_beta * z657;
    const Scalar z659 = n2 * (z305 * z310 + z307 * z308) + s_beta * z324 + c_beta * z322 + z296 * z325 + z297 * z326;
    const Scalar z660 = z332 * (a_beta + a_Theta) + z659;
    const Scalar z661 = s_beta * z307 + c_beta * z310 + z296 * z308 + z297 * z305;
    const Scalar z662 = n2 * (z296 * z308 + z297 * z305) + s_beta * z657 + c_beta * z655;
    const Scalar z663 = -n2 * (z305 * z307 - z308 * z310) + s_beta * z322 - c_beta * z324 - z296 * z326 + z297 * z325;
    const Scalar z664 = z313 * (a_beta + a_Theta) - z663;
    const Scalar z665 = v_gamma * s_gamma + z318;
    const Scalar z666 = n0_035 * z665;
    const Scalar z667 = a_gamma * z131 + z334;
    const Scalar z668 = v_gamma * c_gamma + z303;
    const Scalar z669 = n0_035 * z668;
    const Scalar z670 = a_gamma * z132 - z320;
    const Scalar z671 = s_delta * z351 + c_delta * z348 + z337 * z346 + z338 * z349;
    const Scalar z672 = v_Phi * c_Phi + z350;
    const Scalar z673 = n0_02 * z672;
    const Scalar z674 = v_Phi * s_Phi + z347;
    const Scalar z675 = n0_02 * z674;
    const Scalar z676 = n2 * (z337 * z346 + z338 * z349) + s_delta * z673 + c_delta * z675;
    const Scalar z677 = -n2 * (z346 * z351 - z348 * z349) + s_delta * z362 - c_delta * z360 + z337 * z363 - z338 * z364;
    const Scalar z678 = z369 * (a_delta + a_Phi) - z677;
    const Scalar z679 = s_delta * z348 - c_delta * z351 + z337 * z349 - z338 * z346;
    const Scalar z680 = n2 * (z337 * z349 - z338 * z346) + s_delta * z675 - c_delta * z673;
    const Scalar z681 = n2 * (z346 * z348 + z349 * z351) + s_delta * z360 + c_delta * z362 + z337 * z364 + z338 * z363;
    const Scalar z682 = z354 * (a_delta + a_Phi) + z681;
    const Scalar z683 = v_delta * s_delta + z349;
    const Scalar z684 = v_delta * c_delta + z346;
    const Scalar z685 = n2 * (s_delta * z351 + c_delta * z348) + z338 * z683 + z339 * z684;
    const Scalar z686 = a_delta * z340 + a_Phi * z369 - z370;
    const Scalar z687 = n2 * (s_delta * z348 - c_delta * z351) - z338 * z684 + z339 * z683;
    const Scalar z688 = a_delta * z341 + a_Phi * z354 + z365;
    const Scalar z689 = s_epsilon * z386 - c_epsilon * z383 - z372 * z381 + z373 * z384;
    const Scalar z690 = v_Omega * s_Omega + z385;
    const Scalar z691 = n0_02 * z690;
    const Scalar z692 = v_Omega * c_Omega + z382;
    const Scalar z693 = n0_02 * z692;
    const Scalar z694 = -n2 * (z372 * z381 - z373 * z384) + s_epsilon * z691 - c_epsilon * z693;
    const Scalar z695 = n2 * (z381 * z386 + z383 * z384) + s_epsilon * z397 + c_epsilon * z395 + z372 * z399 + z373
        * z398;
    const Scalar z696 = z404 * (a_epsilon + a_Omega) + z695;
    const Scalar z697 = s_epsilon * z383 + c_epsilon * z386 + z372 * z384 + z373 * z381;
    const Scalar z698 = n2 * (z372 * z384 + z373 * z381) + s_epsilon * z693 + c_epsilon * z691;
    const Scalar z699 = -n2 * (z381 * z383 - z384 * z386) + s_epsilon * z395 - c_epsilon * z397 - z372 * z398 + z373
        * z399;
    const Scalar z700 = z389 * (a_epsilon + a_Omega) - z699;
    const Scalar z701 = v_epsilon * c_epsilon + z381;
    const Scalar z702 = v_epsilon * s_epsilon + z384;
    const Scalar z703 = n2 * (s_epsilon * z386 - c_epsilon * z383) - z372 * z701 - z374 * z702;
    const Scalar z704 = a_epsilon * z375 - a_Omega * z404 - z405;
    const Scalar z705 = n2 * (s_epsilon * z383 + c_epsilon * z386) + z372 * z702 - z374 * z701;
    const Scalar z706 = a_epsilon * z376 + a_Omega * z389 - z400;
    const Scalar z707 = n1 / z389;
    const Scalar z708 = z404 * z707;
    const Scalar z709 = z313 * z708 - z332;
    const Scalar z710 = z375 + z376 * z708;
    const Scalar z711 = n1 / z354;
    const Scalar z712 = z369 * z711;
    const Scalar z713 = z313 * z712 + z332;
    const Scalar z714 = z340 - z341 * z712;
    const Scalar z715 = n1 / z132;
    const Scalar z716 = z131 * z715;
    const Scalar z717 = z313 * z716 - z332;
    const Scalar z718 = n1 / z717;
    const Scalar z719 = z709 * z718;
    const Scalar z720 = z713 * z718;
    const Scalar z721 = n1 / z710;
    const Scalar z722 = n1 / z714;
    const Scalar z723 = z389 * z389;
    const Scalar z724 = z376 * z376 / z175 + z300 * z300 / z205 + k28 * z313 * z313 + k29 * z389 * z389;
    const Scalar z725 = k6 * z724;
    const Scalar z726 = z354 * z354;
    const Scalar z727 = z341 * z341 / z191 + z300 * z300 / z205 + k28 * z313 * z313 + k29 * z354 * z354;
    const Scalar z728 = k6 * z727;
    const Scalar z729 = z132 * z132;
    const Scalar z730 = k30 * z132 * z132 + z300 * z300 / z205 + k28 * z313 * z313;
    const Scalar z731 = k22 * z730;
    const Scalar z732 = z717 * z717;
    const Scalar z733 = k30 * z131 * z131 + z299 * z299 / z205 + k28 * z332 * z332;
    const Scalar z734 = k11 * z733;
    const Scalar z735 = z710 * z710;
    const Scalar z736 = z375 * z375 / z175 + z299 * z299 / z205 + k28 * z332 * z332 + k29 * z404 * z404;
    const Scalar z737 = z175 * z736;
    const Scalar z738 = z714 * z714;
    const Scalar z739 = z340 * z340 / z191 + z299 * z299 / z205 + k28 * z332 * z332 + k29 * z369 * z369;
    const Scalar z740 = z191 * z739;
    const Scalar z741 = z299 + z300 * z716;
    const Scalar z742 = z299 + z300 * z708 - z719 * z741;
    const Scalar z743 = z299 - z300 * z712 + z720 * z741;
    const Scalar z744 = z722 * z743;
    const Scalar z745 = z721 * z742;
    const Scalar z746 = z718 * z741;
    const Scalar z747 = z300 - z313 * z746;
    const Scalar z748 = z715 * z747;
    const Scalar z749 = z300 - z313 * z746 - z341 * z744;
    const Scalar z750 = z711 * z749;
    const Scalar z751 = z300 - z313 * z746 - z376 * z745;
    const Scalar z752 = z707 * z751;
    const Scalar z753 = z329 * z748 + z330 + z653 * z746;
    const Scalar z754 = z304 * z748 + z311 + z661 * z746;
    const Scalar z755 = z330 - z367 * z744 + z653 * z746 - z671 * z750;
    const Scalar z756 = z311 + z352 * z744 + z661 * z746 + z679 * z750;
    const Scalar z757 = z330 + z402 * z745 + z653 * z746 + z689 * z752;
    const Scalar z758 = z311 + z387 * z745 + z661 * z746 + z697 * z752;
    const Scalar z759 = z716 * z753 + z754;
    const Scalar z760 = z708 * z757 - z719 * z759 + z758;
    const Scalar z761 = z712 * z755 - z720 * z759 - z756;
    const Scalar z762 = z722 * z761;
    const Scalar z763 = z721 * z760;
    const Scalar z764 = z718 * z759;
    const Scalar z765 = z313 * z764 - z753;
    const Scalar z766 = z715 * z765;
    const Scalar z767 = z313 * z764 - z341 * z762 - z755;
    const Scalar z768 = z711 * z767;
    const Scalar z769 = z313 * z764 + z376 * z763 - z757;
    const Scalar z770 = z707 * z769;
    const Scalar z771 = z649 + z658 * z746 + z666 * z748;
    const Scalar z772 = z651 + z662 * z746 + z669 * z748;
    const Scalar z773 = z649 + z658 * z746 - z676 * z750 - z685 * z744;
    const Scalar z774 = z651 + z662 * z746 + z680 * z750 + z687 * z744;
    const Scalar z775 = z649 + z658 * z746 + z694 * z752 + z703 * z745;
    const Scalar z776 = z651 + z662 * z746 + z698 * z752 + z705 * z745;
    const Scalar z777 = z716 * z771 + z772;
    const Scalar z778 = z708 * z775 - z719 * z777 + z776;
    const Scalar z779 = z712 * z773 - z720 * z777 - z774;
    const Scalar z780 = z722 * z779;
    const Scalar z781 = z721 * z778;
    const Scalar z782 = z718 * z777;
    const Scalar z783 = z313 * z782 - z771;
    const Scalar z784 = z715 * z783;
    const Scalar z785 = z313 * z782 - z341 * z780 - z773;
    const Scalar z786 = z711 * z785;
    const Scalar z787 = z313 * z782 + z376 * z781 - z775;
    const Scalar z788 = z707 * z787;
    const Scalar z789 = z658 * z764 - z666 * z766;
    const Scalar z790 = z662 * z764 - z669 * z766;
    const Scalar z791 = z658 * z764 + z676 * z768 + z685 * z762;
    const Scalar z792 = z662 * z764 - z680 * z768 - z687 * z762;
    const Scalar z793 = z658 * z764 - z694 * z770 + z703 * z763;
    const Scalar z794 = z662 * z764 - z698 * z770 + z705 * z763;
    const Scalar z795 = z650 + z660 * z746 + z667 * z748;
    const Scalar z796 = z652 - z664 * z746 - z670 * z748;
    const Scalar z797 = z650 + z660 * z746 - z678 * z750 - z686 * z744;
    const Scalar z798 = z652 - z664 * z746 - z682 * z750 - z688 * z744;
    const Scalar z799 = z650 + z660 * z746 + z696 * z752 - z704 * z745;
    const Scalar z800 = z652 - z664 * z746 - z700 * z752 - z706 * z745;
    const Scalar z801 = z789 + z795;
    const Scalar z802 = z790 - z796;
    const Scalar z803 = z791 + z797;
    const Scalar z804 = z792 - z798;
    const Scalar z805 = z793 + z799;
    const Scalar z806 = z794 - z800;
    const Scalar z807 = z716 * z801 + z802;
    const Scalar z808 = z708 * z805 - z719 * z807 + z806;
    const Scalar z809 = z712 * z803 - z720 * z807 - z804;
    const Scalar z810 = z722 * z809;
    const Scalar z811 = z721 * z808;
    const Scalar z812 = z718 * z807;
    const Scalar z813 = z313 * z812 - z801;
    const Scalar z814 = z715 * z813;
    const Scalar z815 = z313 * z812 - z341 * z810 - z803;
    const Scalar z816 = z711 * z815;
    const Scalar z817 = z313 * z812 + z376 * z811 - z805;
    const Scalar z818 = z707 * z817;
    const Scalar z819 = z643 * z716 + z644;
    const Scalar z820 = z641 * z708 + z645 - z719 * z819;
    const Scalar z821 = z642 * z712 - z646 - z720 * z819;
    const Scalar z822 = z722 * z821;
    const Scalar z823 = z721 * z820;
    const Scalar z824 = z718 * z819;
    const Scalar z825 = z313 * z824 - z643;
    const Scalar z826 = z715 * z825;
    const Scalar z827 = z313 * z824 - z341 * z822 - z642;
    const Scalar z828 = z711 * z827;
    const Scalar z829 = z313 * z824 + z376 * z823 - z641;
    const Scalar z830 = z707 * z829;
    const Scalar z831 = z194 * z746 + z205;
    const Scalar z832 = z194 + k11 * z746;
    const Scalar z833 = k22 * z748;
    const Scalar z834 = z178 * z744 + k6 * z750;
    const Scalar z835 = z178 * z750 + z191 * z744;
    const Scalar z836 = z162 * z745 + k6 * z752;
    const Scalar z837 = z162 * z752 + z175 * z745;
    const Scalar z838 = z744 * z835 + z745 * z837 + z746 * z832 + z748 * z833 + z750 * z834 + z752 * z836 + z831;
    const Scalar z839 = z780 * z835 - z781 * z837 - z782 * z832 + z784 * z833 + z786 * z834 + z788 * z836;
    const Scalar z840 = z599 - z602 * z746;
    const Scalar z841 = z624 * z744;
    const Scalar z842 = z619 * z750 + z626 * z744;
    const Scalar z843 = z637 * z745;
    const Scalar z844 = z632 * z752 + z639 * z745;
    const Scalar z845 = z595 * z746 - z744 * z842 + z745 * z844 + z750 * z841 - z752 * z843 + z840;
    const Scalar z846 = z839 + z845;
    const Scalar z847 = z810 * z835 - z811 * z837 - z812 * z832 + z814 * z833 + z816 * z834 + z818 * z836;
    const Scalar z848 = z602 * z764;
    const Scalar z849 = z624 * z762;
    const Scalar z850 = z619 * z768 + z626 * z762;
    const Scalar z851 = z637 * z763;
    const Scalar z852 = z632 * z770 - z639 * z763;
    const Scalar z853 = z600 - z605 * z746;
    const Scalar z854 = z601 + z606 * z746;
    const Scalar z855 = z614 * z748;
    const Scalar z856 = z616 * z750 + z625 * z744;
    const Scalar z857 = z621 * z750 + z627 * z744;
    const Scalar z858 = z629 * z752 + z638 * z745;
    const Scalar z859 = z634 * z752 + z640 * z745;
    const Scalar z860 = z848 + z853;
    const Scalar z861 = z849 - z856;
    const Scalar z862 = z850 + z857;
    const Scalar z863 = z851 - z858;
    const Scalar z864 = z852 - z859;
    const Scalar z865 = z744 * z862 - z745 * z864 + z746 * z854 + z748 * z855 - z750 * z861 - z752 * z863 - z860;
    const Scalar z866 = z847 + z865;
    const Scalar z867 = z313 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z332 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) + z290;
    const Scalar z868 = z131 * l_lambda_E3_y + z132 * l_lambda_E3_x + z288;
    const Scalar z869 = z280 - z354 * l_lambda_E4_x + z369 * l_lambda_E4_y;
    const Scalar z870 = z285 + z340 * l_lambda_E4_y - z341 * l_lambda_E4_x;
    const Scalar z871 = z273 + z389 * l_lambda_E6_x + z404 * l_lambda_E6_y;
    const Scalar z872 = z278 + z375 * l_lambda_E6_y - z376 * l_lambda_E6_x;
    const Scalar z873 = z299 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z300 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) + z295 - z744 * z870 - z745 * z872 + z746 * z867 + z748 * z868 - z750 * z869 + z752 * z871;
    const Scalar z874 = z822 * z835 - z823 * z837 - z824 * z832 + z826 * z833 + z828 * z834 + z830 * z836;
    const Scalar z875 = z873 + z874;
    const Scalar z876 = n1 / z838;
    const Scalar z877 = z866 * z876;
    const Scalar z878 = z846 * z876;
    result.M[0] = z205;
    result.M[1] = z194;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = z194;
    result.M[8] = k11;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = n0;
    result.M[16] = k22;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = n0;
    result.M[23] = n0;
    result.M[24] = k6;
    result.M[25] = z178;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = n0;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = z178;
    result.M[32] = z191;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n0;
    result.M[36] = n0;
    result.M[37] = n0;
    result.M[38] = n0;
    result.M[39] = n0;
    result.M[40] = k6;
    result.M[41] = z162;
    result.M[42] = n0;
    result.M[43] = n0;
    result.M[44] = n0;
    result.M[45] = n0;
    result.M[46] = n0;
    result.M[47] = z162;
    result.M[48] = z175;
    result.C[0] = -z599;
    result.C[1] = -z595;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z602;
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
    result.C[25] = z619;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z624;
    result.C[32] = z626;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z632;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z637;
    result.C[48] = -z639;
    result.K[0] = z600;
    result.K[1] = -z601;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z605;
    result.K[8] = -z606;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z614;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z616;
    result.K[25] = -z621;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z625;
    result.K[32] = -z627;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = -z629;
    result.K[41] = -z634;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = -z638;
    result.K[48] = -z640;
    result.F[0] = z299 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z300 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x) + z295;
    result.F[1] = z313 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z332 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y) + z290;
    result.F[2] = -z131 * l_lambda_E3_y - z132 * l_lambda_E3_x - z288;
    result.F[3] = -z280 + z354 * l_lambda_E4_x - z369 * l_lambda_E4_y;
    result.F[4] = -z285 - z340 * l_lambda_E4_y + z341 * l_lambda_E4_x;
    result.F[5] = z273 + z389 * l_lambda_E6_x + z404 * l_lambda_E6_y;
    result.F[6] = -z278 - z375 * l_lambda_E6_y + z376 * l_lambda_E6_x;
    result.M_r[0] = z838;
    result.C_r[0] = -z846;
    result.K_r[0] = -z866;
    result.F_r[0] = z875;
    result.A[0] = n0;
    result.A[1] = z877;
    result.A[2] = n1;
    result.A[3] = z878;
    if (!(traits::regular(z723, z725) && traits::regular(z726, z728) && traits::regular(z729, z731)
        && traits::regular(z732, z734) && traits::regular(z735, z737) && traits::regular(z738, z740)
        && traits::regular(z838, z838))) return torsor::Status::singular;
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
