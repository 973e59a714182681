// SPDX-License-Identifier: MIT
// elastic_wing: Half an aircraft with an elastic wing and an engine
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: gust
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              111              121          0             0                  9       0    250     250
//   mass_matrix              35               45          0             0                  5       0     90      96
//   bias                     55               67          0             0                  8       0    138     162
//   inverse_dynamics         79               89          0             0                  8       0    184     211
//   forward_dynamics        122              155          4             0                  8       0    297     326
//   energy                   66              105          0             0                  8       0    187     199
//   linearisation           471              608          4             0                  8       0   1099    1329
//
// Not computed because this mechanism does not need it:
//   kinematics: of 228 results 120 vanish identically, 31 repeat another up to sign
//   mass_matrix: of 36 results 6 vanish identically, 12 repeat another up to sign
//   first_integrals: left out, 'gust_1', 'friction_1', 'gust_2', 'friction_2', 'gust_3', 'friction_3', 'gust_4', 'friction_4', 'pylon_friction' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 258 results 108 vanish identically, 12 repeat another up to sign
//
// To write this file again:
//   elastic_wing_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output elastic_wing.hpp
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

namespace elastic_wing {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "elastic_wing";
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar gust;  ///< parameter [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::gust};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar z;  ///< coordinate [m]
    Scalar beta_1;  ///< coordinate [rad or 1]
    Scalar beta_2;  ///< coordinate [rad or 1]
    Scalar beta_3;  ///< coordinate [rad or 1]
    Scalar beta_4;  ///< coordinate [rad or 1]
    Scalar gamma;  ///< coordinate [rad or 1]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::z, &Coordinates::beta_1, &Coordinates::beta_2,
          &Coordinates::beta_3, &Coordinates::beta_4, &Coordinates::gamma};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar z;  ///< its rate [m/s]
    Scalar beta_1;  ///< its rate [rad/s]
    Scalar beta_2;  ///< its rate [rad/s]
    Scalar beta_3;  ///< its rate [rad/s]
    Scalar beta_4;  ///< its rate [rad/s]
    Scalar gamma;  ///< its rate [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::z, &Velocities::beta_1, &Velocities::beta_2,
          &Velocities::beta_3, &Velocities::beta_4, &Velocities::gamma};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar z;  ///< its second rate [m/s^2]
    Scalar beta_1;  ///< its second rate [rad/s^2]
    Scalar beta_2;  ///< its second rate [rad/s^2]
    Scalar beta_3;  ///< its second rate [rad/s^2]
    Scalar beta_4;  ///< its second rate [rad/s^2]
    Scalar gamma;  ///< its second rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::z, &Accelerations::beta_1, &Accelerations::beta_2,
          &Accelerations::beta_3, &Accelerations::beta_4, &Accelerations::gamma};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar z;  ///< works with the rate of z [N]
    Scalar beta_1;  ///< works with the rate of beta_1 [N m]
    Scalar beta_2;  ///< works with the rate of beta_2 [N m]
    Scalar beta_3;  ///< works with the rate of beta_3 [N m]
    Scalar beta_4;  ///< works with the rate of beta_4 [N m]
    Scalar gamma;  ///< works with the rate of gamma [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::z, &GeneralizedForces::beta_1,
          &GeneralizedForces::beta_2, &GeneralizedForces::beta_3, &GeneralizedForces::beta_4,
          &GeneralizedForces::gamma};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
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
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    parameters.gust = n10000;
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
    state.time = n0;
    state.q.z = n0;
    state.q.beta_1 = n0;
    state.q.beta_2 = n0;
    state.q.beta_3 = n0;
    state.q.beta_4 = n0;
    state.q.gamma = n0;
    state.v.z = n0;
    state.v.beta_1 = n0;
    state.v.beta_2 = n0;
    state.v.beta_3 = n0;
    state.v.beta_4 = n0;
    state.v.gamma = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> fuselage_position;  ///< centre of mass of fuselage [m]
    std::array<Scalar, 9> fuselage_rotation;  ///< from the axes of fuselage to the ground's (3 x 3)
    std::array<Scalar, 3> fuselage_velocity;  ///< velocity of the centre of mass of fuselage [m/s]
    std::array<Scalar, 3> fuselage_angular_velocity;  ///< angular velocity of fuselage [rad/s]
    std::array<Scalar, 3> panel_1_position;  ///< centre of mass of panel_1 [m]
    std::array<Scalar, 9> panel_1_rotation;  ///< from the axes of panel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_1_velocity;  ///< velocity of the centre of mass of panel_1 [m/s]
    std::array<Scalar, 3> panel_1_angular_velocity;  ///< angular velocity of panel_1 [rad/s]
    std::array<Scalar, 3> panel_2_position;  ///< centre of mass of panel_2 [m]
    std::array<Scalar, 9> panel_2_rotation;  ///< from the axes of panel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_2_velocity;  ///< velocity of the centre of mass of panel_2 [m/s]
    std::array<Scalar, 3> panel_2_angular_velocity;  ///< angular velocity of panel_2 [rad/s]
    std::array<Scalar, 3> panel_3_position;  ///< centre of mass of panel_3 [m]
    std::array<Scalar, 9> panel_3_rotation;  ///< from the axes of panel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_3_velocity;  ///< velocity of the centre of mass of panel_3 [m/s]
    std::array<Scalar, 3> panel_3_angular_velocity;  ///< angular velocity of panel_3 [rad/s]
    std::array<Scalar, 3> panel_4_position;  ///< centre of mass of panel_4 [m]
    std::array<Scalar, 9> panel_4_rotation;  ///< from the axes of panel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_4_velocity;  ///< velocity of the centre of mass of panel_4 [m/s]
    std::array<Scalar, 3> panel_4_angular_velocity;  ///< angular velocity of panel_4 [rad/s]
    std::array<Scalar, 3> engine_position;  ///< centre of mass of engine [m]
    std::array<Scalar, 9> engine_rotation;  ///< from the axes of engine to the ground's (3 x 3)
    std::array<Scalar, 3> engine_velocity;  ///< velocity of the centre of mass of engine [m/s]
    std::array<Scalar, 3> engine_angular_velocity;  ///< angular velocity of engine [rad/s]
    std::array<Scalar, 3> middle_1_position;  ///< position of middle_1 [m]
    std::array<Scalar, 3> middle_1_velocity;  ///< velocity of the material point at middle_1 [m/s]
    std::array<Scalar, 18> middle_1_jacobian;  ///< partial velocities of middle_1 (3 x 6)
    std::array<Scalar, 3> middle_2_position;  ///< position of middle_2 [m]
    std::array<Scalar, 3> middle_2_velocity;  ///< velocity of the material point at middle_2 [m/s]
    std::array<Scalar, 18> middle_2_jacobian;  ///< partial velocities of middle_2 (3 x 6)
    std::array<Scalar, 3> middle_3_position;  ///< position of middle_3 [m]
    std::array<Scalar, 3> middle_3_velocity;  ///< velocity of the material point at middle_3 [m/s]
    std::array<Scalar, 18> middle_3_jacobian;  ///< partial velocities of middle_3 (3 x 6)
    std::array<Scalar, 3> middle_4_position;  ///< position of middle_4 [m]
    std::array<Scalar, 3> middle_4_velocity;  ///< velocity of the material point at middle_4 [m/s]
    std::array<Scalar, 18> middle_4_jacobian;  ///< partial velocities of middle_4 (3 x 6)
    std::array<Scalar, 3> tip_position;  ///< position of tip [m]
    std::array<Scalar, 3> tip_velocity;  ///< velocity of the material point at tip [m/s]
    std::array<Scalar, 18> tip_jacobian;  ///< partial velocities of tip (3 x 6)
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
    std::array<Scalar, 36> M;  ///< mass matrix (6 x 6)
    std::array<Scalar, 36> C;  ///< damping and gyroscopic terms (6 x 6)
    std::array<Scalar, 36> K;  ///< stiffness (6 x 6)
    std::array<Scalar, 6> F;  ///< right-hand side
    std::array<Scalar, 144> A;  ///< state matrix of x = (e, e'): x' = A x + B du (12 x 12)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar z57 = q_beta_1 + q_beta_2;
    const Scalar z72 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z90 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar z102 = q_beta_1 + q_gamma;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z57, z72, z90, z102};
    Scalar sines_[9], cosines_[9];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z58 = sines_[5], z59 = cosines_[5];
    const Scalar z73 = sines_[6], z74 = cosines_[6];
    const Scalar z91 = sines_[7], z92 = cosines_[7];
    const Scalar z103 = sines_[8], z104 = cosines_[8];
    const Scalar z28 = v_z * s_beta_1;
    const Scalar z29 = v_z * c_beta_1;
    const Scalar z30 = n4 * v_beta_1 + z29;
    const Scalar z31 = s_beta_2 * z30 + c_beta_2 * z28;
    const Scalar z32 = s_beta_2 * z28 - c_beta_2 * z30;
    const Scalar z33 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z34 = z32 - n4 * z33;
    const Scalar z35 = s_beta_3 * z34 - c_beta_3 * z31;
    const Scalar z36 = s_beta_3 * z31 + c_beta_3 * z34;
    const Scalar z37 = v_beta_3 + z33;  // angular velocity of panel_3, x
    const Scalar z38 = z36 - n4 * z37;
    const Scalar z39 = s_beta_4 * z38 + c_beta_4 * z35;
    const Scalar z40 = s_beta_4 * z35 - c_beta_4 * z38;
    const Scalar z41 = v_beta_4 + z37;  // angular velocity of panel_4, x
    const Scalar z42 = s_gamma * z30 + c_gamma * z28;
    const Scalar z43 = s_gamma * z28 - c_gamma * z30;
    const Scalar z44 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z45 = n2 * c_beta_1;
    const Scalar z46 = n2 * s_beta_1;
    const Scalar z47 = q_z + z46;
    const Scalar z48 = n2 * v_beta_1 + z29;
    const Scalar z49 = s_beta_1 * z48 - c_beta_1 * z28;
    const Scalar z50 = s_beta_1 * z28 + c_beta_1 * z48;
    const Scalar z51 = n2 * c_beta_2;
    const Scalar z52 = n2 * s_beta_2;
    const Scalar z53 = n4 + z51;
    const Scalar z54 = s_beta_1 * z52 - c_beta_1 * z53;
    const Scalar z55 = s_beta_1 * z53 + c_beta_1 * z52;
    const Scalar z56 = q_z + z55;
    const Scalar z60 = z32 - n2 * z33;
    const Scalar z61 = z31 * z59 + z58 * z60;
    const Scalar z62 = z31 * z58 - z59 * z60;
    const Scalar z63 = n2 * c_beta_3;
    const Scalar z64 = n2 * s_beta_3;
    const Scalar z65 = n4 + z63;
    const Scalar z66 = s_beta_2 * z64 - c_beta_2 * z65;
    const Scalar z67 = s_beta_2 * z65 + c_beta_2 * z64;
    const Scalar z68 = n4 - z66;
    const Scalar z69 = s_beta_1 * z67 - c_beta_1 * z68;
    const Scalar z70 = s_beta_1 * z68 + c_beta_1 * z67;
    const Scalar z71 = q_z + z70;
    const Scalar z75 = z36 - n2 * z37;
    const Scalar z76 = z35 * z74 - z73 * z75;
    const Scalar z77 = z35 * z73 + z74 * z75;
    const Scalar z78 = n2 * c_beta_4;
    const Scalar z79 = n2 * s_beta_4;
    const Scalar z80 = n4 + z78;
    const Scalar z81 = s_beta_3 * z79 - c_beta_3 * z80;
    const Scalar z82 = s_beta_3 * z80 + c_beta_3 * z79;
    const Scalar z83 = n4 - z81;
    const Scalar z84 = s_beta_2 * z82 - c_beta_2 * z83;
    const Scalar z85 = s_beta_2 * z83 + c_beta_2 * z82;
    const Scalar z86 = n4 - z84;
    const Scalar z87 = s_beta_1 * z85 - c_beta_1 * z86;
    const Scalar z88 = s_beta_1 * z86 + c_beta_1 * z85;
    const Scalar z89 = q_z + z88;
    const Scalar z93 = z40 + n2 * z41;
    const Scalar z94 = z39 * z92 + z91 * z93;
    const Scalar z95 = z39 * z91 - z92 * z93;
    const Scalar z96 = n1_2 * s_gamma;
    const Scalar z97 = n1_2 * c_gamma;
    const Scalar z98 = n4 + z96;
    const Scalar z99 = s_beta_1 * z97 + c_beta_1 * z98;
    const Scalar z100 = s_beta_1 * z98 - c_beta_1 * z97;
    const Scalar z101 = q_z + z100;
    const Scalar z105 = z42 + n1_2 * z44;
    const Scalar z106 = z43 * z103 + z104 * z105;
    const Scalar z107 = z43 * z104 - z103 * z105;
    const Scalar z108 = q_z - z47;
    const Scalar z109 = q_z - z56;
    const Scalar z110 = n4 * c_beta_1;
    const Scalar z111 = n4 * s_beta_1;
    const Scalar z112 = q_z + z111;
    const Scalar z113 = z54 + z110;
    const Scalar z114 = z56 - z112;
    const Scalar z115 = q_z - z71;
    const Scalar z116 = z69 + z110;
    const Scalar z117 = z71 - z112;
    const Scalar z118 = n4 * c_beta_2;
    const Scalar z119 = n4 * s_beta_2;
    const Scalar z120 = n4 + z118;
    const Scalar z121 = s_beta_1 * z119 - c_beta_1 * z120;
    const Scalar z122 = s_beta_1 * z120 + c_beta_1 * z119;
    const Scalar z123 = q_z + z122;
    const Scalar z124 = z69 - z121;
    const Scalar z125 = z71 - z123;
    const Scalar z126 = q_z - z89;
    const Scalar z127 = z87 + z110;
    const Scalar z128 = z89 - z112;
    const Scalar z129 = z87 - z121;
    const Scalar z130 = z89 - z123;
    const Scalar z131 = n4 * c_beta_3;
    const Scalar z132 = n4 * s_beta_3;
    const Scalar z133 = n4 + z131;
    const Scalar z134 = s_beta_2 * z132 - c_beta_2 * z133;
    const Scalar z135 = s_beta_2 * z133 + c_beta_2 * z132;
    const Scalar z136 = n4 - z134;
    const Scalar z137 = s_beta_1 * z135 - c_beta_1 * z136;
    const Scalar z138 = s_beta_1 * z136 + c_beta_1 * z135;
    const Scalar z139 = q_z + z138;
    const Scalar z140 = z87 - z137;
    const Scalar z141 = z89 - z139;
    const Scalar z142 = n4 * c_beta_4;
    const Scalar z143 = n4 * s_beta_4;
    const Scalar z144 = n4 + z142;
    const Scalar z145 = s_beta_3 * z143 - c_beta_3 * z144;
    const Scalar z146 = s_beta_3 * z144 + c_beta_3 * z143;
    const Scalar z147 = n4 - z145;
    const Scalar z148 = s_beta_2 * z146 - c_beta_2 * z147;
    const Scalar z149 = s_beta_2 * z147 + c_beta_2 * z146;
    const Scalar z150 = n4 - z148;
    const Scalar z151 = s_beta_1 * z149 - c_beta_1 * z150;
    const Scalar z152 = s_beta_1 * z150 + c_beta_1 * z149;
    const Scalar z153 = q_z + z152;
    const Scalar z154 = z40 + n4 * z41;
    const Scalar z155 = z39 * z92 + z91 * z154;
    const Scalar z156 = z39 * z91 - z92 * z154;
    const Scalar z157 = q_z - z153;
    const Scalar z158 = z110 + z151;
    const Scalar z159 = z112 - z153;
    const Scalar z160 = z121 - z151;
    const Scalar z161 = z123 - z153;
    const Scalar z162 = z137 - z151;
    const Scalar z163 = z139 - z153;
    result.fuselage_position[0] = n0;
    result.fuselage_position[1] = n0;
    result.fuselage_position[2] = q_z;
    result.fuselage_rotation[0] = n1;
    result.fuselage_rotation[1] = n0;
    result.fuselage_rotation[2] = n0;
    result.fuselage_rotation[3] = n0;
    result.fuselage_rotation[4] = n1;
    result.fuselage_rotation[5] = n0;
    result.fuselage_rotation[6] = n0;
    result.fuselage_rotation[7] = n0;
    result.fuselage_rotation[8] = n1;
    result.fuselage_velocity[0] = n0;
    result.fuselage_velocity[1] = n0;
    result.fuselage_velocity[2] = v_z;
    result.fuselage_angular_velocity[0] = n0;
    result.fuselage_angular_velocity[1] = n0;
    result.fuselage_angular_velocity[2] = n0;
    result.panel_1_position[0] = n0;
    result.panel_1_position[1] = z45;
    result.panel_1_position[2] = z47;
    result.panel_1_rotation[0] = n1;
    result.panel_1_rotation[1] = n0;
    result.panel_1_rotation[2] = n0;
    result.panel_1_rotation[3] = n0;
    result.panel_1_rotation[4] = c_beta_1;
    result.panel_1_rotation[5] = s_beta_1;
    result.panel_1_rotation[6] = n0;
    result.panel_1_rotation[7] = -s_beta_1;
    result.panel_1_rotation[8] = c_beta_1;
    result.panel_1_velocity[0] = n0;
    result.panel_1_velocity[1] = -z49;
    result.panel_1_velocity[2] = z50;
    result.panel_1_angular_velocity[0] = v_beta_1;
    result.panel_1_angular_velocity[1] = n0;
    result.panel_1_angular_velocity[2] = n0;
    result.panel_2_position[0] = n0;
    result.panel_2_position[1] = -z54;
    result.panel_2_position[2] = z56;
    result.panel_2_rotation[0] = n1;
    result.panel_2_rotation[1] = n0;
    result.panel_2_rotation[2] = n0;
    result.panel_2_rotation[3] = n0;
    result.panel_2_rotation[4] = z59;
    result.panel_2_rotation[5] = z58;
    result.panel_2_rotation[6] = n0;
    result.panel_2_rotation[7] = -z58;
    result.panel_2_rotation[8] = z59;
    result.panel_2_velocity[0] = n0;
    result.panel_2_velocity[1] = z61;
    result.panel_2_velocity[2] = z62;
    result.panel_2_angular_velocity[0] = z33;
    result.panel_2_angular_velocity[1] = n0;
    result.panel_2_angular_velocity[2] = n0;
    result.panel_3_position[0] = n0;
    result.panel_3_position[1] = -z69;
    result.panel_3_position[2] = z71;
    result.panel_3_rotation[0] = n1;
    result.panel_3_rotation[1] = n0;
    result.panel_3_rotation[2] = n0;
    result.panel_3_rotation[3] = n0;
    result.panel_3_rotation[4] = z74;
    result.panel_3_rotation[5] = z73;
    result.panel_3_rotation[6] = n0;
    result.panel_3_rotation[7] = -z73;
    result.panel_3_rotation[8] = z74;
    result.panel_3_velocity[0] = n0;
    result.panel_3_velocity[1] = -z76;
    result.panel_3_velocity[2] = -z77;
    result.panel_3_angular_velocity[0] = z37;
    result.panel_3_angular_velocity[1] = n0;
    result.panel_3_angular_velocity[2] = n0;
    result.panel_4_position[0] = n0;
    result.panel_4_position[1] = -z87;
    result.panel_4_position[2] = z89;
    result.panel_4_rotation[0] = n1;
    result.panel_4_rotation[1] = n0;
    result.panel_4_rotation[2] = n0;
    result.panel_4_rotation[3] = n0;
    result.panel_4_rotation[4] = z92;
    result.panel_4_rotation[5] = z91;
    result.panel_4_rotation[6] = n0;
    result.panel_4_rotation[7] = -z91;
    result.panel_4_rotation[8] = z92;
    result.panel_4_velocity[0] = n0;
    result.panel_4_velocity[1] = -z94;
    result.panel_4_velocity[2] = -z95;
    result.panel_4_angular_velocity[0] = z41;
    result.panel_4_angular_velocity[1] = n0;
    result.panel_4_angular_velocity[2] = n0;
    result.engine_position[0] = n0;
    result.engine_position[1] = z99;
    result.engine_position[2] = z101;
    result.engine_rotation[0] = n1;
    result.engine_rotation[1] = n0;
    result.engine_rotation[2] = n0;
    result.engine_rotation[3] = n0;
    result.engine_rotation[4] = z104;
    result.engine_rotation[5] = z103;
    result.engine_rotation[6] = n0;
    result.engine_rotation[7] = -z103;
    result.engine_rotation[8] = z104;
    result.engine_velocity[0] = n0;
    result.engine_velocity[1] = z106;
    result.engine_velocity[2] = -z107;
    result.engine_angular_velocity[0] = z44;
    result.engine_angular_velocity[1] = n0;
    result.engine_angular_velocity[2] = n0;
    result.middle_1_position[0] = n0;
    result.middle_1_position[1] = z45;
    result.middle_1_position[2] = z47;
    result.middle_1_velocity[0] = n0;
    result.middle_1_velocity[1] = -z49;
    result.middle_1_velocity[2] = z50;
    result.middle_1_jacobian[0] = n0;
    result.middle_1_jacobian[3] = n0;
    result.middle_1_jacobian[6] = n0;
    result.middle_1_jacobian[9] = n0;
    result.middle_1_jacobian[12] = n0;
    result.middle_1_jacobian[15] = n0;
    result.middle_1_jacobian[1] = n0;
    result.middle_1_jacobian[4] = z108;
    result.middle_1_jacobian[7] = n0;
    result.middle_1_jacobian[10] = n0;
    result.middle_1_jacobian[13] = n0;
    result.middle_1_jacobian[16] = n0;
    result.middle_1_jacobian[2] = n1;
    result.middle_1_jacobian[5] = z45;
    result.middle_1_jacobian[8] = n0;
    result.middle_1_jacobian[11] = n0;
    result.middle_1_jacobian[14] = n0;
    result.middle_1_jacobian[17] = n0;
    result.middle_2_position[0] = n0;
    result.middle_2_position[1] = -z54;
    result.middle_2_position[2] = z56;
    result.middle_2_velocity[0] = n0;
    result.middle_2_velocity[1] = z61;
    result.middle_2_velocity[2] = z62;
    result.middle_2_jacobian[0] = n0;
    result.middle_2_jacobian[3] = n0;
    result.middle_2_jacobian[6] = n0;
    result.middle_2_jacobian[9] = n0;
    result.middle_2_jacobian[12] = n0;
    result.middle_2_jacobian[15] = n0;
    result.middle_2_jacobian[1] = n0;
    result.middle_2_jacobian[4] = z109;
    result.middle_2_jacobian[7] = -z114;
    result.middle_2_jacobian[10] = n0;
    result.middle_2_jacobian[13] = n0;
    result.middle_2_jacobian[16] = n0;
    result.middle_2_jacobian[2] = n1;
    result.middle_2_jacobian[5] = -z54;
    result.middle_2_jacobian[8] = -z113;
    result.middle_2_jacobian[11] = n0;
    result.middle_2_jacobian[14] = n0;
    result.middle_2_jacobian[17] = n0;
    result.middle_3_position[0] = n0;
    result.middle_3_position[1] = -z69;
    result.middle_3_position[2] = z71;
    result.middle_3_velocity[0] = n0;
    result.middle_3_velocity[1] = -z76;
    result.middle_3_velocity[2] = -z77;
    result.middle_3_jacobian[0] = n0;
    result.middle_3_jacobian[3] = n0;
    result.middle_3_jacobian[6] = n0;
    result.middle_3_jacobian[9] = n0;
    result.middle_3_jacobian[12] = n0;
    result.middle_3_jacobian[15] = n0;
    result.middle_3_jacobian[1] = n0;
    result.middle_3_jacobian[4] = z115;
    result.middle_3_jacobian[7] = -z117;
    result.middle_3_jacobian[10] = -z125;
    result.middle_3_jacobian[13] = n0;
    result.middle_3_jacobian[16] = n0;
    result.middle_3_jacobian[2] = n1;
    result.middle_3_jacobian[5] = -z69;
    result.middle_3_jacobian[8] = -z116;
    result.middle_3_jacobian[11] = -z124;
    result.middle_3_jacobian[14] = n0;
    result.middle_3_jacobian[17] = n0;
    result.middle_4_position[0] = n0;
    result.middle_4_position[1] = -z87;
    result.middle_4_position[2] = z89;
    result.middle_4_velocity[0] = n0;
    result.middle_4_velocity[1] = -z94;
    result.middle_4_velocity[2] = -z95;
    result.middle_4_jacobian[0] = n0;
    result.middle_4_jacobian[3] = n0;
    result.middle_4_jacobian[6] = n0;
    result.middle_4_jacobian[9] = n0;
    result.middle_4_jacobian[12] = n0;
    result.middle_4_jacobian[15] = n0;
    result.middle_4_jacobian[1] = n0;
    result.middle_4_jacobian[4] = z126;
    result.middle_4_jacobian[7] = -z128;
    result.middle_4_jacobian[10] = -z130;
    result.middle_4_jacobian[13] = -z141;
    result.middle_4_jacobian[16] = n0;
    result.middle_4_jacobian[2] = n1;
    result.middle_4_jacobian[5] = -z87;
    result.middle_4_jacobian[8] = -z127;
    result.middle_4_jacobian[11] = -z129;
    result.middle_4_jacobian[14] = -z140;
    result.middle_4_jacobian[17] = n0;
    result.tip_position[0] = n0;
    result.tip_position[1] = -z151;
    result.tip_position[2] = z153;
    result.tip_velocity[0] = n0;
    result.tip_velocity[1] = -z155;
    result.tip_velocity[2] = -z156;
    result.tip_jacobian[0] = n0;
    result.tip_jacobian[3] = n0;
    result.tip_jacobian[6] = n0;
    result.tip_jacobian[9] = n0;
    result.tip_jacobian[12] = n0;
    result.tip_jacobian[15] = n0;
    result.tip_jacobian[1] = n0;
    result.tip_jacobian[4] = z157;
    result.tip_jacobian[7] = z159;
    result.tip_jacobian[10] = z161;
    result.tip_jacobian[13] = z163;
    result.tip_jacobian[16] = n0;
    result.tip_jacobian[2] = n1;
    result.tip_jacobian[5] = -z151;
    result.tip_jacobian[8] = -z158;
    result.tip_jacobian[11] = z160;
    result.tip_jacobian[14] = z162;
    result.tip_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 36>& mass) noexcept {
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k5 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar k7 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k11 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z164 = n2400 * c_gamma;
    const Scalar z165 = n2400 * s_gamma;
    const Scalar z166 = n3580 + n4 * z165;
    const Scalar z168 = s_beta_1 * z164 + c_beta_1 * z165;
    const Scalar z173 = n3580 + n8 * z165;
    const Scalar z176 = n16600 + z165;
    const Scalar z177 = k5 + z173;
    const Scalar z179 = n500 * s_beta_4;
    const Scalar z180 = n500 * c_beta_4;
    const Scalar z181 = k7 + n4 * z180;
    const Scalar z182 = s_beta_3 * z180 + c_beta_3 * z179;
    const Scalar z183 = s_beta_3 * z179 - c_beta_3 * z180;
    const Scalar z184 = z181 - n4 * z183;
    const Scalar z185 = s_beta_2 * z183 - c_beta_2 * z182;
    const Scalar z186 = s_beta_2 * z182 + c_beta_2 * z183;
    const Scalar z187 = z184 - n4 * z186;
    const Scalar z189 = s_beta_1 * z185 - c_beta_1 * z186;
    const Scalar z194 = k7 + n8 * z180;
    const Scalar z197 = n1900 + z180;
    const Scalar z198 = n6400 + z194;
    const Scalar z200 = s_beta_3 * z197 + c_beta_3 * z179;
    const Scalar z201 = s_beta_3 * z179 - c_beta_3 * z197;
    const Scalar z202 = z198 - n4 * z201;
    const Scalar z203 = s_beta_2 * z201 - c_beta_2 * z200;
    const Scalar z204 = s_beta_2 * z200 + c_beta_2 * z201;
    const Scalar z205 = z202 - n4 * z204;
    const Scalar z207 = s_beta_1 * z203 - c_beta_1 * z204;
    const Scalar z215 = z198 - n8 * z201;
    const Scalar z218 = n4400 - z201;
    const Scalar z219 = k11 + z215;
    const Scalar z221 = s_beta_2 * z218 + c_beta_2 * z200;
    const Scalar z222 = s_beta_2 * z200 - c_beta_2 * z218;
    const Scalar z223 = z219 - n4 * z222;
    const Scalar z225 = s_beta_1 * z221 + c_beta_1 * z222;
    const Scalar z233 = z219 - n8 * z222;
    const Scalar z236 = z176 - z222;
    const Scalar z237 = z164 - z221;
    const Scalar z238 = z177 + z233;
    const Scalar z243 = s_beta_1 * z237 + c_beta_1 * z236;
    mass[0] = n20500;
    mass[1] = z243;
    mass[2] = -z225;
    mass[3] = z207;
    mass[4] = z189;
    mass[5] = z168;
    mass[6] = z243;
    mass[7] = z238;
    mass[8] = z223;
    mass[9] = z205;
    mass[10] = z187;
    mass[11] = z166;
    mass[12] = -z225;
    mass[13] = z223;
    mass[14] = z219;
    mass[15] = z202;
    mass[16] = z184;
    mass[17] = n0;
    mass[18] = z207;
    mass[19] = z205;
    mass[20] = z202;
    mass[21] = z198;
    mass[22] = z181;
    mass[23] = n0;
    mass[24] = z189;
    mass[25] = z187;
    mass[26] = z184;
    mass[27] = z181;
    mass[28] = k7;
    mass[29] = n0;
    mass[30] = z168;
    mass[31] = z166;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n3580;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k2 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k4 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k6 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z57 = q_beta_1 + q_beta_2;
    const Scalar z72 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z90 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z57, z72, z90};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z58 = sines_[5], z59 = cosines_[5];
    const Scalar z73 = sines_[6], z74 = cosines_[6];
    const Scalar z91 = sines_[7], z92 = cosines_[7];
    const Scalar z33 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z37 = v_beta_3 + z33;  // angular velocity of panel_3, x
    const Scalar z41 = v_beta_4 + z37;  // angular velocity of panel_4, x
    const Scalar z44 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z252 = s_beta_1 * p_gust;
    const Scalar z253 = c_beta_1 * p_gust;
    const Scalar z254 = k0 * q_beta_1;
    const Scalar z255 = n60000 * v_beta_1;
    const Scalar z256 = z58 * p_gust;
    const Scalar z257 = z59 * p_gust;
    const Scalar z258 = k2 * q_beta_2;
    const Scalar z259 = n28000 * v_beta_2;
    const Scalar z260 = z73 * p_gust;
    const Scalar z261 = z74 * p_gust;
    const Scalar z262 = k4 * q_beta_3;
    const Scalar z263 = n12000 * v_beta_3;
    const Scalar z264 = z91 * p_gust;
    const Scalar z265 = z92 * p_gust;
    const Scalar z266 = k6 * q_beta_4;
    const Scalar z267 = n5000 * v_beta_4;
    const Scalar z268 = n600000 * q_gamma;
    const Scalar z269 = n1200 * v_gamma;
    const Scalar z270 = n2 * z253;
    const Scalar z271 = n2 * z257;
    const Scalar z272 = n2 * z261;
    const Scalar z273 = n2 * z265;
    const Scalar z274 = v_beta_1 * v_beta_1;
    const Scalar z275 = n4 * z274;
    const Scalar z276 = c_beta_2 * z275;
    const Scalar z277 = s_beta_2 * z275;
    const Scalar z278 = z33 * z33;
    const Scalar z279 = z276 + n4 * z278;
    const Scalar z280 = s_beta_3 * z277 - c_beta_3 * z279;
    const Scalar z281 = s_beta_3 * z279 + c_beta_3 * z277;
    const Scalar z282 = z37 * z37;
    const Scalar z283 = z280 - n4 * z282;
    const Scalar z285 = s_beta_4 * z283 - c_beta_4 * z281;
    const Scalar z286 = c_gamma * z275;
    const Scalar z288 = z44 * z44;
    const Scalar z289 = n2400 * z288;  // force on engine, z
    const Scalar z290 = n2400 * z286;  // moment on engine, x
    const Scalar z291 = s_gamma * z289;
    const Scalar z292 = c_gamma * z289;
    const Scalar z293 = z41 * z41;
    const Scalar z294 = z264 + n500 * z293;  // force on panel_4, y
    const Scalar z295 = z273 + n500 * z285;  // moment on panel_4, x
    const Scalar z296 = s_beta_4 * z265 - c_beta_4 * z294;
    const Scalar z297 = s_beta_4 * z294 + c_beta_4 * z265;
    const Scalar z298 = z260 + n1900 * z282 - z296;  // force on panel_3, y
    const Scalar z299 = z261 + z297;  // force on panel_3, z
    const Scalar z300 = z272 - n1900 * z281 + z295 + n4 * z297;  // moment on panel_3, x
    const Scalar z301 = s_beta_3 * z299 - c_beta_3 * z298;
    const Scalar z302 = s_beta_3 * z298 + c_beta_3 * z299;
    const Scalar z303 = z256 + n4400 * z278 - z301;  // force on panel_2, y
    const Scalar z304 = z257 + z302;  // force on panel_2, z
    const Scalar z305 = z271 - n4400 * z277 + z300 + n4 * z302;  // moment on panel_2, x
    const Scalar z306 = s_beta_2 * z304 - c_beta_2 * z303;
    const Scalar z307 = s_beta_2 * z303 + c_beta_2 * z304;
    const Scalar z308 = z252 + n16600 * z274 + z291 - z306;  // force on panel_1, y
    const Scalar z309 = z253 - z292 + z307;  // force on panel_1, z
    const Scalar z310 = -n4 * (z292 - z307) + z270 + z290 + z305;  // moment on panel_1, x
    const Scalar z312 = s_beta_1 * z308 + c_beta_1 * z309;
    const Scalar z313 = z254 + z255 - z310;
    const Scalar z314 = z258 + z259 - z305;
    const Scalar z315 = z262 + z263 - z300;
    const Scalar z316 = z266 + z267 - z295;
    const Scalar z317 = z268 + z269 - z290;
    forces.z = -z312;
    forces.beta_1 = z313;
    forces.beta_2 = z314;
    forces.beta_3 = z315;
    forces.beta_4 = z316;
    forces.gamma = z317;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k2 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k4 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k6 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar k15 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k19 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k21 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar a_z = accelerations.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar a_beta_3 = accelerations.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar a_beta_4 = accelerations.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z57 = q_beta_1 + q_beta_2;
    const Scalar z72 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z90 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z57, z72, z90};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z58 = sines_[5], z59 = cosines_[5];
    const Scalar z73 = sines_[6], z74 = cosines_[6];
    const Scalar z91 = sines_[7], z92 = cosines_[7];
    const Scalar z33 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z37 = v_beta_3 + z33;  // angular velocity of panel_3, x
    const Scalar z41 = v_beta_4 + z37;  // angular velocity of panel_4, x
    const Scalar z44 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z252 = s_beta_1 * p_gust;
    const Scalar z253 = c_beta_1 * p_gust;
    const Scalar z254 = k0 * q_beta_1;
    const Scalar z255 = n60000 * v_beta_1;
    const Scalar z256 = z58 * p_gust;
    const Scalar z257 = z59 * p_gust;
    const Scalar z258 = k2 * q_beta_2;
    const Scalar z259 = n28000 * v_beta_2;
    const Scalar z260 = z73 * p_gust;
    const Scalar z261 = z74 * p_gust;
    const Scalar z262 = k4 * q_beta_3;
    const Scalar z263 = n12000 * v_beta_3;
    const Scalar z264 = z91 * p_gust;
    const Scalar z265 = z92 * p_gust;
    const Scalar z266 = k6 * q_beta_4;
    const Scalar z267 = n5000 * v_beta_4;
    const Scalar z268 = n600000 * q_gamma;
    const Scalar z269 = n1200 * v_gamma;
    const Scalar z270 = n2 * z253;
    const Scalar z271 = n2 * z257;
    const Scalar z272 = n2 * z261;
    const Scalar z273 = n2 * z265;
    const Scalar z274 = v_beta_1 * v_beta_1;
    const Scalar z278 = z33 * z33;
    const Scalar z282 = z37 * z37;
    const Scalar z288 = z44 * z44;
    const Scalar z289 = n2400 * z288;  // force on engine, z
    const Scalar z293 = z41 * z41;
    const Scalar z294 = z264 + n500 * z293;  // force on panel_4, y
    const Scalar z318 = a_z * s_beta_1;
    const Scalar z319 = a_z * c_beta_1;
    const Scalar z320 = n4 * z274 - z318;
    const Scalar z321 = n4 * a_beta_1 + z319;
    const Scalar z322 = s_beta_2 * z321 - c_beta_2 * z320;
    const Scalar z323 = s_beta_2 * z320 + c_beta_2 * z321;
    const Scalar z324 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z325 = n4 * z278 - z322;
    const Scalar z326 = z323 + n4 * z324;
    const Scalar z327 = s_beta_3 * z326 - c_beta_3 * z325;
    const Scalar z328 = s_beta_3 * z325 + c_beta_3 * z326;
    const Scalar z329 = a_beta_3 + z324;  // angular acceleration of panel_3, x
    const Scalar z330 = n4 * z282 - z327;
    const Scalar z331 = z328 + n4 * z329;
    const Scalar z333 = s_beta_4 * z330 + c_beta_4 * z331;
    const Scalar z334 = a_beta_4 + z329;  // angular acceleration of panel_4, x
    const Scalar z335 = s_gamma * z321 - c_gamma * z320;
    const Scalar z337 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z338 = n2400 * z337;  // force on engine, y
    const Scalar z339 = n2400 * z335 + n3580 * z337;  // moment on engine, x
    const Scalar z340 = s_gamma * z289 - c_gamma * z338;
    const Scalar z341 = s_gamma * z338 + c_gamma * z289;
    const Scalar z342 = z265 - n500 * z334;  // force on panel_4, z
    const Scalar z343 = z273 - n500 * z333 - k15 * z334;  // moment on panel_4, x
    const Scalar z344 = s_beta_4 * z342 - c_beta_4 * z294;
    const Scalar z345 = s_beta_4 * z294 + c_beta_4 * z342;
    const Scalar z346 = z260 + n1900 * z282 - z344;  // force on panel_3, y
    const Scalar z347 = z261 - n1900 * z329 + z345;  // force on panel_3, z
    const Scalar z348 = z272 - n1900 * z328 - n6400 * z329 + z343 + n4 * z345;  // moment on panel_3, x
    const Scalar z349 = s_beta_3 * z347 - c_beta_3 * z346;
    const Scalar z350 = s_beta_3 * z346 + c_beta_3 * z347;
    const Scalar z351 = z256 + n4400 * z278 - z349;  // force on panel_2, y
    const Scalar z352 = z257 - n4400 * z324 + z350;  // force on panel_2, z
    const Scalar z353 = z271 - n4400 * z323 - k19 * z324 + z348 + n4 * z350;  // moment on panel_2, x
    const Scalar z354 = s_beta_2 * z352 - c_beta_2 * z351;
    const Scalar z355 = s_beta_2 * z351 + c_beta_2 * z352;
    const Scalar z356 = z252 + n16600 * z274 + z340 - z354;  // force on panel_1, y
    const Scalar z357 = n16600 * a_beta_1 - z253 + z341 - z355;  // force on panel_1, z
    // moment on panel_1, x
    const Scalar z358 = n4 * (z341 - z355) + k21 * a_beta_1 - z270 + n16600 * z319 + z339 - z353;
    const Scalar z360 = s_beta_1 * z356 - c_beta_1 * z357;
    const Scalar z361 = n20500 * a_z - z360;  // force on fuselage, z
    const Scalar z362 = z254 + z255 + z358;
    const Scalar z363 = z258 + z259 - z353;
    const Scalar z364 = z262 + z263 - z348;
    const Scalar z365 = z266 + z267 - z343;
    const Scalar z366 = z268 + z269 + z339;
    forces.z = z361;
    forces.beta_1 = z362;
    forces.beta_2 = z363;
    forces.beta_3 = z364;
    forces.beta_4 = z365;
    forces.gamma = z366;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k2 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k4 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k6 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar k14 = traits::constant(1608.9385474860335, 1608.9386f, "288000/179");
    const Scalar k15 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar n187_5 = traits::constant(187.5, 187.5f, "375/2");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k21 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar k24 = traits::constant(0.00027932960893854746, 0.0002793296f, "1/3580");
    const Scalar n120_over_179 = traits::constant(0.6703910614525139, 0.6703911f, "120/179");
    const Scalar k26 = traits::constant(0.00075, 0.00075f, "3/4000");
    const Scalar n0_375 = traits::constant(0.375, 0.375f, "3/8");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z57 = q_beta_1 + q_beta_2;
    const Scalar z72 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z90 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z57, z72, z90};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z58 = sines_[5], z59 = cosines_[5];
    const Scalar z73 = sines_[6], z74 = cosines_[6];
    const Scalar z91 = sines_[7], z92 = cosines_[7];
    const Scalar z33 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z37 = v_beta_3 + z33;  // angular velocity of panel_3, x
    const Scalar z41 = v_beta_4 + z37;  // angular velocity of panel_4, x
    const Scalar z44 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z252 = s_beta_1 * p_gust;
    const Scalar z253 = c_beta_1 * p_gust;
    const Scalar z254 = k0 * q_beta_1;
    const Scalar z255 = n60000 * v_beta_1;
    const Scalar z256 = z58 * p_gust;
    const Scalar z257 = z59 * p_gust;
    const Scalar z258 = k2 * q_beta_2;
    const Scalar z259 = n28000 * v_beta_2;
    const Scalar z260 = z73 * p_gust;
    const Scalar z261 = z74 * p_gust;
    const Scalar z262 = k4 * q_beta_3;
    const Scalar z263 = n12000 * v_beta_3;
    const Scalar z264 = z91 * p_gust;
    const Scalar z265 = z92 * p_gust;
    const Scalar z266 = k6 * q_beta_4;
    const Scalar z267 = n5000 * v_beta_4;
    const Scalar z268 = n600000 * q_gamma;
    const Scalar z269 = n1200 * v_gamma;
    const Scalar z270 = n2 * z253;
    const Scalar z271 = n2 * z257;
    const Scalar z272 = n2 * z261;
    const Scalar z273 = n2 * z265;
    const Scalar z274 = v_beta_1 * v_beta_1;
    const Scalar z275 = n4 * z274;
    const Scalar z276 = c_beta_2 * z275;
    const Scalar z277 = s_beta_2 * z275;
    const Scalar z278 = z33 * z33;
    const Scalar z279 = z276 + n4 * z278;
    const Scalar z280 = s_beta_3 * z277 - c_beta_3 * z279;
    const Scalar z281 = s_beta_3 * z279 + c_beta_3 * z277;
    const Scalar z282 = z37 * z37;
    const Scalar z283 = z280 - n4 * z282;
    const Scalar z285 = s_beta_4 * z283 - c_beta_4 * z281;
    const Scalar z286 = c_gamma * z275;
    const Scalar z288 = z44 * z44;
    const Scalar z289 = n2400 * z288;  // force on engine, z
    const Scalar z290 = n2400 * z286;  // moment on engine, x
    const Scalar z293 = z41 * z41;
    const Scalar z294 = z264 + n500 * z293;  // force on panel_4, y
    const Scalar z295 = z273 + n500 * z285;  // moment on panel_4, x
    const Scalar z367 = z254 + z255;
    const Scalar z368 = z258 + z259;
    const Scalar z369 = z262 + z263;
    const Scalar z370 = z266 + z267;
    const Scalar z371 = z268 + z269;
    const Scalar z372 = k14 * s_gamma;
    const Scalar z373 = s_gamma * z372;
    const Scalar z374 = k14 - z373;
    const Scalar z375 = c_gamma * z372;
    const Scalar z376 = n4 * z375;
    const Scalar z377 = n4 * z373;
    const Scalar z378 = n4 * z377;
    const Scalar z379 = k15 - z378;
    const Scalar z380 = n16600 - z377;
    const Scalar z381 = n187_5 * s_beta_4;
    const Scalar z382 = s_beta_4 * z381;
    const Scalar z383 = n187_5 - z382;
    const Scalar z384 = c_beta_4 * z381;
    const Scalar z385 = n4 * z384;
    const Scalar z386 = n4 * z383;
    const Scalar z387 = n4 * z386;
    const Scalar z388 = n6400 - z387;
    const Scalar z389 = n1900 - z386;
    const Scalar z390 = n1 / z388;
    const Scalar z391 = z385 * z390;
    const Scalar z392 = z389 * z390;
    const Scalar z393 = z382 + z385 * z391;
    const Scalar z394 = z384 - z385 * z392;
    const Scalar z395 = z383 + z389 * z392;
    const Scalar z396 = z393 - z395;
    const Scalar z397 = n2 * z394;
    const Scalar z398 = s_beta_3 * z396 - c_beta_3 * z397;
    const Scalar z399 = s_beta_3 * z398;
    const Scalar z400 = z393 - z399;
    const Scalar z401 = z395 + z399;
    const Scalar z402 = c_beta_3 * z398 + z394;
    const Scalar z403 = n4 * z402;
    const Scalar z404 = n4 * z401;
    const Scalar z405 = n4 * z404;
    const Scalar z406 = k21 - z405;
    const Scalar z407 = n4400 - z404;
    const Scalar z408 = n1 / z406;
    const Scalar z409 = z403 * z408;
    const Scalar z410 = z407 * z408;
    const Scalar z411 = z400 + z403 * z409;
    const Scalar z412 = z402 - z403 * z410;
    const Scalar z413 = z401 + z407 * z410;
    const Scalar z414 = z411 - z413;
    const Scalar z415 = n2 * z412;
    const Scalar z416 = s_beta_2 * z414 + c_beta_2 * z415;
    const Scalar z417 = s_beta_2 * z416;
    const Scalar z418 = z411 - z417;
    const Scalar z419 = z413 + z417;
    const Scalar z420 = c_beta_2 * z416 - z412;
    const Scalar z421 = n4 * z420;
    const Scalar z422 = n4 * z419;
    const Scalar z423 = n4 * z422;
    const Scalar z424 = z379 - z423;
    const Scalar z425 = z376 + z421;
    const Scalar z426 = z380 - z422;
    const Scalar z427 = z374 + z418;
    const Scalar z428 = z375 + z420;
    const Scalar z429 = z373 + z419;
    const Scalar z430 = n1 / z424;
    const Scalar z431 = z425 * z430;
    const Scalar z432 = z426 * z430;
    const Scalar z433 = z425 * z431 + z427;
    const Scalar z434 = z425 * z432 - z428;
    const Scalar z435 = z426 * z432 + z429;
    const Scalar z436 = z433 - z435;
    const Scalar z437 = n2 * z434;
    const Scalar z438 = s_beta_1 * z436 - c_beta_1 * z437;
    const Scalar z439 = s_beta_1 * z438;
    const Scalar z441 = z435 + z439;
    const Scalar z444 = n20500 - z441;
    const Scalar z445 = n1 / z444;
    const Scalar z447 = z290 - z371;
    const Scalar z448 = k24 * z447;
    const Scalar z449 = n120_over_179 * z447;
    const Scalar z450 = s_gamma * z289 - c_gamma * z449;
    const Scalar z451 = s_gamma * z449 + c_gamma * z289;
    const Scalar z452 = z295 - z370;
    const Scalar z453 = k26 * z452;
    const Scalar z454 = z265 - n0_375 * z452;
    const Scalar z455 = s_beta_4 * z454 - c_beta_4 * z294;
    const Scalar z456 = s_beta_4 * z294 + c_beta_4 * z454;
    const Scalar z457 = z260 + n1900 * z282 - z455;
    const Scalar z458 = z261 + z456;
    const Scalar z459 = z272 - n1900 * z281 + z370 + n4 * z456;
    const Scalar z460 = z369 - z459;
    const Scalar z461 = z390 * z460;
    const Scalar z462 = z391 * z460 + z457;
    const Scalar z463 = z392 * z460 + z458;
    const Scalar z464 = s_beta_3 * z463 - c_beta_3 * z462;
    const Scalar z465 = s_beta_3 * z462 + c_beta_3 * z463;
    const Scalar z466 = z256 + n4400 * z278 - z464;
    const Scalar z467 = z257 + z465;
    const Scalar z468 = z271 - n4400 * z277 + z369 + n4 * z465;
    const Scalar z469 = z368 - z468;
    const Scalar z470 = z408 * z469;
    const Scalar z471 = z409 * z469 - z466;
    const Scalar z472 = z410 * z469 + z467;
    const Scalar z473 = s_beta_2 * z472 + c_beta_2 * z471;
    const Scalar z474 = s_beta_2 * z471 - c_beta_2 * z472;
    const Scalar z475 = z252 + n16600 * z274 + z450 - z473;
    const Scalar z476 = z253 - z451 - z474;
    const Scalar z477 = -n4 * (z451 + z474) + z270 + z368 + z371;
    const Scalar z478 = z367 - z477;
    const Scalar z479 = z430 * z478;
    const Scalar z480 = z431 * z478 - z475;
    const Scalar z481 = z432 * z478 + z476;
    const Scalar z483 = s_beta_1 * z480 - c_beta_1 * z481;
    const Scalar z484 = z445 * z483;
    const Scalar z486 = s_beta_1 * z484;
    const Scalar z487 = c_beta_1 * z484;
    const Scalar z488 = z431 * z486 - z432 * z487 + z479;
    const Scalar z489 = z487 + n4 * z488;
    const Scalar z490 = s_beta_2 * z489 + c_beta_2 * z486;
    const Scalar z491 = s_beta_2 * z486 - c_beta_2 * z489;
    const Scalar z492 = z409 * z490 + z410 * z491 + z470;
    const Scalar z493 = z488 - z492;
    const Scalar z494 = z491 - n4 * z492;
    const Scalar z495 = s_beta_3 * z494 - c_beta_3 * z490;
    const Scalar z496 = s_beta_3 * z490 + c_beta_3 * z494;
    const Scalar z497 = z391 * z495 + z392 * z496 + z461;
    const Scalar z498 = z492 - z497;
    const Scalar z499 = z496 - n4 * z497;
    const Scalar z501 = s_beta_4 * z495 - c_beta_4 * z499;
    const Scalar z502 = z453 + n0_375 * z501;
    const Scalar z503 = z497 + z502;
    const Scalar z504 = s_gamma * z489 + c_gamma * z486;
    const Scalar z506 = z448 + n120_over_179 * z504;
    const Scalar z507 = z488 + z506;
    accelerations.z = -z484;
    accelerations.beta_1 = -z488;
    accelerations.beta_2 = z493;
    accelerations.beta_3 = z498;
    accelerations.beta_4 = z503;
    accelerations.gamma = z507;
    if (!(traits::regular(z388, z388) && traits::regular(z406, z406) && traits::regular(z424, z424)
        && traits::regular(z444, z444))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.z - accelerations.z) + (accelerations.beta_1 - accelerations.beta_1)
        + (accelerations.beta_2 - accelerations.beta_2) + (accelerations.beta_3 - accelerations.beta_3)
        + (accelerations.beta_4 - accelerations.beta_4) + (accelerations.gamma - accelerations.gamma);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2600 = traits::constant(2600.0, 2600.0f, "2600/1");
    const Scalar n1300 = traits::constant(1300.0, 1300.0f, "1300/1");
    const Scalar k8 = traits::constant(6933.333333333333, 6933.3335f, "20800/3");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar n1600 = traits::constant(1600.0, 1600.0f, "1600/1");
    const Scalar k11 = traits::constant(4266.666666666667, 4266.6665f, "12800/3");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n250 = traits::constant(250.0, 250.0f, "250/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar k17 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n2000 = traits::constant(2000.0, 2000.0f, "2000/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n7850 = traits::constant(7850.0, 7850.0f, "7850/1");
    const Scalar n650 = traits::constant(650.0, 650.0f, "650/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n225 = traits::constant(225.0, 225.0f, "225/1");
    const Scalar n125 = traits::constant(125.0, 125.0f, "125/1");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar k27 = traits::constant(1.5e+07, 1.5e+07f, "15000000/1");
    const Scalar k28 = traits::constant(7e+06, 7e+06f, "7000000/1");
    const Scalar k29 = traits::constant(3e+06, 3e+06f, "3000000/1");
    const Scalar k30 = traits::constant(1250000.0, 1250000.0f, "1250000/1");
    const Scalar n300000 = traits::constant(3e+05, 3e+05f, "300000/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar v_z = state.v.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z57 = q_beta_1 + q_beta_2;
    const Scalar z72 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z90 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z57, z72, z90};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z58 = sines_[5], z59 = cosines_[5];
    const Scalar z73 = sines_[6], z74 = cosines_[6];
    const Scalar z91 = sines_[7], z92 = cosines_[7];
    const Scalar z28 = v_z * s_beta_1;
    const Scalar z29 = v_z * c_beta_1;
    const Scalar z30 = n4 * v_beta_1 + z29;
    const Scalar z31 = s_beta_2 * z30 + c_beta_2 * z28;
    const Scalar z32 = s_beta_2 * z28 - c_beta_2 * z30;
    const Scalar z33 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z34 = z32 - n4 * z33;
    const Scalar z35 = s_beta_3 * z34 - c_beta_3 * z31;
    const Scalar z36 = s_beta_3 * z31 + c_beta_3 * z34;
    const Scalar z37 = v_beta_3 + z33;  // angular velocity of panel_3, x
    const Scalar z38 = z36 - n4 * z37;
    const Scalar z39 = s_beta_4 * z38 + c_beta_4 * z35;
    const Scalar z40 = s_beta_4 * z35 - c_beta_4 * z38;
    const Scalar z41 = v_beta_4 + z37;  // angular velocity of panel_4, x
    const Scalar z42 = s_gamma * z30 + c_gamma * z28;
    const Scalar z43 = s_gamma * z28 - c_gamma * z30;
    const Scalar z44 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z252 = s_beta_1 * p_gust;
    const Scalar z253 = c_beta_1 * p_gust;
    const Scalar z255 = n60000 * v_beta_1;
    const Scalar z256 = z58 * p_gust;
    const Scalar z257 = z59 * p_gust;
    const Scalar z259 = n28000 * v_beta_2;
    const Scalar z260 = z73 * p_gust;
    const Scalar z261 = z74 * p_gust;
    const Scalar z263 = n12000 * v_beta_3;
    const Scalar z264 = z91 * p_gust;
    const Scalar z265 = z92 * p_gust;
    const Scalar z267 = n5000 * v_beta_4;
    const Scalar z269 = n1200 * v_gamma;
    const Scalar z570 = n2600 * v_beta_1 + n1300 * z29;
    const Scalar z571 = k8 * v_beta_1 + n2600 * z29;
    const Scalar z572 = n800 * z32 - n1600 * z33;
    const Scalar z573 = n1600 * z32 - k11 * z33;
    const Scalar z574 = n450 * z36 - n900 * z37;
    const Scalar z575 = n900 * z36 - n2400 * z37;
    const Scalar z576 = n250 * z40 + n500 * z41;
    const Scalar z577 = n500 * z40 + k17 * z41;
    const Scalar z578 = n2000 * z42 + n2400 * z44;
    const Scalar z579 = n2400 * z42 + n3580 * z44;
    result.kinetic = n0_5 * (v_beta_1 * z571 + z29 * z570 + z32 * z572 - z33 * z573 + z36 * z574 - z37 * z575 + z40
        * z576 + z41 * z577 + z42 * z578 + z44 * z579) + n7850 * v_z * v_z + n650 * z28 * z28 + n400 * z31 * z31 + n225
        * z35 * z35 + n125 * z39 * z39 + n1000 * z43 * z43;
    result.force_function = -k27 * q_beta_1 * q_beta_1 - k28 * q_beta_2 * q_beta_2 - k29 * q_beta_3 * q_beta_3 - k30
        * q_beta_4 * q_beta_4 - n300000 * q_gamma * q_gamma;
    result.power = n2 * (v_beta_1 * z253 + z33 * z257 + z37 * z261 + z41 * z265) - v_beta_1 * z255 - v_beta_2 * z259
        - v_beta_3 * z263 - v_beta_4 * z267 - v_gamma * z269 + z28 * z252 + z29 * z253 + z31 * z256 - z32 * z257 - z35
        * z260 - z36 * z261 - z39 * z264 + z40 * z265;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k5 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar k7 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k11 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar k12 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k14 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k16 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k18 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar k24 = traits::constant(0.00027932960893854746, 0.0002793296f, "1/3580");
    const Scalar k25 = traits::constant(0.00075, 0.00075f, "3/4000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n3_75 = traits::constant(3.75, 3.75f, "15/4");
    const Scalar n60_over_179 = traits::constant(0.33519553072625696, 0.33519554f, "60/179");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_z = accelerations.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar a_beta_3 = accelerations.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar a_beta_4 = accelerations.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z57 = q_beta_1 + q_beta_2;
    const Scalar z72 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z90 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z57, z72, z90};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z58 = sines_[5], z59 = cosines_[5];
    const Scalar z73 = sines_[6], z74 = cosines_[6];
    const Scalar z91 = sines_[7], z92 = cosines_[7];
    const Scalar z33 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z37 = v_beta_3 + z33;  // angular velocity of panel_3, x
    const Scalar z41 = v_beta_4 + z37;  // angular velocity of panel_4, x
    const Scalar z44 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z164 = n2400 * c_gamma;
    const Scalar z165 = n2400 * s_gamma;
    const Scalar z166 = n3580 + n4 * z165;
    const Scalar z168 = s_beta_1 * z164 + c_beta_1 * z165;
    const Scalar z173 = n3580 + n8 * z165;
    const Scalar z176 = n16600 + z165;
    const Scalar z177 = k5 + z173;
    const Scalar z179 = n500 * s_beta_4;
    const Scalar z180 = n500 * c_beta_4;
    const Scalar z181 = k7 + n4 * z180;
    const Scalar z182 = s_beta_3 * z180 + c_beta_3 * z179;
    const Scalar z183 = s_beta_3 * z179 - c_beta_3 * z180;
    const Scalar z184 = z181 - n4 * z183;
    const Scalar z185 = s_beta_2 * z183 - c_beta_2 * z182;
    const Scalar z186 = s_beta_2 * z182 + c_beta_2 * z183;
    const Scalar z187 = z184 - n4 * z186;
    const Scalar z189 = s_beta_1 * z185 - c_beta_1 * z186;
    const Scalar z194 = k7 + n8 * z180;
    const Scalar z197 = n1900 + z180;
    const Scalar z198 = n6400 + z194;
    const Scalar z200 = s_beta_3 * z197 + c_beta_3 * z179;
    const Scalar z201 = s_beta_3 * z179 - c_beta_3 * z197;
    const Scalar z202 = z198 - n4 * z201;
    const Scalar z203 = s_beta_2 * z201 - c_beta_2 * z200;
    const Scalar z204 = s_beta_2 * z200 + c_beta_2 * z201;
    const Scalar z205 = z202 - n4 * z204;
    const Scalar z207 = s_beta_1 * z203 - c_beta_1 * z204;
    const Scalar z215 = z198 - n8 * z201;
    const Scalar z218 = n4400 - z201;
    const Scalar z219 = k11 + z215;
    const Scalar z221 = s_beta_2 * z218 + c_beta_2 * z200;
    const Scalar z222 = s_beta_2 * z200 - c_beta_2 * z218;
    const Scalar z223 = z219 - n4 * z222;
    const Scalar z225 = s_beta_1 * z221 + c_beta_1 * z222;
    const Scalar z233 = z219 - n8 * z222;
    const Scalar z236 = z176 - z222;
    const Scalar z237 = z164 - z221;
    const Scalar z238 = z177 + z233;
    const Scalar z243 = s_beta_1 * z237 + c_beta_1 * z236;
    const Scalar z252 = s_beta_1 * p_gust;
    const Scalar z253 = c_beta_1 * p_gust;
    const Scalar z254 = k12 * q_beta_1;
    const Scalar z255 = n60000 * v_beta_1;
    const Scalar z256 = z58 * p_gust;
    const Scalar z257 = z59 * p_gust;
    const Scalar z258 = k14 * q_beta_2;
    const Scalar z259 = n28000 * v_beta_2;
    const Scalar z260 = z73 * p_gust;
    const Scalar z261 = z74 * p_gust;
    const Scalar z262 = k16 * q_beta_3;
    const Scalar z263 = n12000 * v_beta_3;
    const Scalar z264 = z91 * p_gust;
    const Scalar z265 = z92 * p_gust;
    const Scalar z266 = k18 * q_beta_4;
    const Scalar z267 = n5000 * v_beta_4;
    const Scalar z268 = n600000 * q_gamma;
    const Scalar z269 = n1200 * v_gamma;
    const Scalar z270 = n2 * z253;
    const Scalar z271 = n2 * z257;
    const Scalar z272 = n2 * z261;
    const Scalar z273 = n2 * z265;
    const Scalar z274 = v_beta_1 * v_beta_1;
    const Scalar z278 = z33 * z33;
    const Scalar z282 = z37 * z37;
    const Scalar z288 = z44 * z44;
    const Scalar z289 = n2400 * z288;  // force on engine, z
    const Scalar z293 = z41 * z41;
    const Scalar z294 = z264 + n500 * z293;  // force on panel_4, y
    const Scalar z318 = a_z * s_beta_1;
    const Scalar z319 = a_z * c_beta_1;
    const Scalar z320 = n4 * z274 - z318;
    const Scalar z321 = n4 * a_beta_1 + z319;
    const Scalar z322 = s_beta_2 * z321 - c_beta_2 * z320;
    const Scalar z323 = s_beta_2 * z320 + c_beta_2 * z321;
    const Scalar z324 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z325 = n4 * z278 - z322;
    const Scalar z326 = z323 + n4 * z324;
    const Scalar z327 = s_beta_3 * z326 - c_beta_3 * z325;
    const Scalar z328 = s_beta_3 * z325 + c_beta_3 * z326;
    const Scalar z329 = a_beta_3 + z324;  // angular acceleration of panel_3, x
    const Scalar z330 = n4 * z282 - z327;
    const Scalar z331 = z328 + n4 * z329;
    const Scalar z332 = s_beta_4 * z331 - c_beta_4 * z330;
    const Scalar z333 = s_beta_4 * z330 + c_beta_4 * z331;
    const Scalar z334 = a_beta_4 + z329;  // angular acceleration of panel_4, x
    const Scalar z335 = s_gamma * z321 - c_gamma * z320;
    const Scalar z336 = s_gamma * z320 + c_gamma * z321;
    const Scalar z337 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z338 = n2400 * z337;  // force on engine, y
    const Scalar z339 = n2400 * z335 + n3580 * z337;  // moment on engine, x
    const Scalar z340 = s_gamma * z289 - c_gamma * z338;
    const Scalar z341 = s_gamma * z338 + c_gamma * z289;
    const Scalar z342 = z265 - n500 * z334;  // force on panel_4, z
    const Scalar z343 = z273 - n500 * z333 - k7 * z334;  // moment on panel_4, x
    const Scalar z344 = s_beta_4 * z342 - c_beta_4 * z294;
    const Scalar z345 = s_beta_4 * z294 + c_beta_4 * z342;
    const Scalar z346 = z260 + n1900 * z282 - z344;  // force on panel_3, y
    const Scalar z347 = z261 - n1900 * z329 + z345;  // force on panel_3, z
    const Scalar z348 = z272 - n1900 * z328 - n6400 * z329 + z343 + n4 * z345;  // moment on panel_3, x
    const Scalar z349 = s_beta_3 * z347 - c_beta_3 * z346;
    const Scalar z350 = s_beta_3 * z346 + c_beta_3 * z347;
    const Scalar z351 = z256 + n4400 * z278 - z349;  // force on panel_2, y
    const Scalar z352 = z257 - n4400 * z324 + z350;  // force on panel_2, z
    const Scalar z353 = z271 - n4400 * z323 - k11 * z324 + z348 + n4 * z350;  // moment on panel_2, x
    const Scalar z354 = s_beta_2 * z352 - c_beta_2 * z351;
    const Scalar z355 = s_beta_2 * z351 + c_beta_2 * z352;
    const Scalar z356 = z252 + n16600 * z274 + z340 - z354;  // force on panel_1, y
    const Scalar z357 = n16600 * a_beta_1 - z253 + z341 - z355;  // force on panel_1, z
    // moment on panel_1, x
    const Scalar z358 = n4 * (z341 - z355) + k5 * a_beta_1 - z270 + n16600 * z319 + z339 - z353;
    const Scalar z360 = s_beta_1 * z356 - c_beta_1 * z357;
    const Scalar z361 = n20500 * a_z - z360;  // force on fuselage, z
    const Scalar z362 = z254 + z255 + z358;
    const Scalar z363 = z258 + z259 - z353;
    const Scalar z364 = z262 + z263 - z348;
    const Scalar z365 = z266 + z267 - z343;
    const Scalar z366 = z268 + z269 + z339;
    const Scalar z508 = k24 * z168;
    const Scalar z509 = k24 * z166;
    const Scalar z510 = n20500 - z168 * z508;
    const Scalar z511 = z168 * z509 - z243;
    const Scalar z512 = z166 * z509 - z238;
    const Scalar z513 = k25 * z189;
    const Scalar z514 = k25 * z187;
    const Scalar z515 = k25 * z184;
    const Scalar z516 = k25 * z181;
    const Scalar z517 = z189 * z513 - z510;
    const Scalar z518 = z189 * z514 + z511;
    const Scalar z519 = z187 * z514 + z512;
    const Scalar z520 = z189 * z515 + z225;
    const Scalar z521 = z187 * z515 - z223;
    const Scalar z522 = z184 * z515 - z219;
    const Scalar z523 = z189 * z516 - z207;
    const Scalar z524 = z187 * z516 - z205;
    const Scalar z525 = z184 * z516 - z202;
    const Scalar z526 = z181 * z516 - z198;
    const Scalar z527 = n1 / z526;
    const Scalar z528 = z523 * z527;
    const Scalar z529 = z524 * z527;
    const Scalar z530 = z525 * z527;
    const Scalar z531 = z517 - z523 * z528;
    const Scalar z532 = z518 - z523 * z529;
    const Scalar z533 = z519 - z524 * z529;
    const Scalar z534 = z520 - z523 * z530;
    const Scalar z535 = z521 - z524 * z530;
    const Scalar z536 = z522 - z525 * z530;
    const Scalar z537 = n1 / z536;
    const Scalar z538 = z534 * z537;
    const Scalar z539 = z535 * z537;
    const Scalar z540 = z531 - z534 * z538;
    const Scalar z541 = z532 - z534 * z539;
    const Scalar z542 = z533 - z535 * z539;
    const Scalar z543 = n1 / z542;
    const Scalar z544 = z541 * z543;
    const Scalar z545 = z540 - z541 * z544;
    const Scalar z546 = n1 / z545;
    const Scalar z647 = n2 * v_beta_1;
    const Scalar z648 = n2 * z44;
    const Scalar z649 = n2400 * z648;
    const Scalar z650 = s_gamma * z649;
    const Scalar z651 = n2 * z37;
    const Scalar z652 = n2 * z41;
    const Scalar z653 = n500 * z652;
    const Scalar z654 = c_beta_4 * z653;
    const Scalar z655 = n1900 * z651 + z654;
    const Scalar z656 = s_beta_4 * z653;
    const Scalar z657 = s_beta_3 * z655 + c_beta_3 * z656;
    const Scalar z658 = n2 * z33;
    const Scalar z659 = s_beta_3 * z656 - c_beta_3 * z655;
    const Scalar z660 = n4400 * z658 - z659;
    const Scalar z661 = s_beta_2 * z657 - c_beta_2 * z660;
    const Scalar z662 = n16600 * z647 + z650 - z661;
    const Scalar z663 = c_gamma * z649;
    const Scalar z664 = s_beta_2 * z660 + c_beta_2 * z657;
    const Scalar z665 = z663 - z664;
    const Scalar z666 = s_beta_1 * z662 - c_beta_1 * z665;
    const Scalar z667 = s_beta_4 * z264 + c_beta_4 * z265;
    const Scalar z668 = z261 + z667;
    const Scalar z669 = s_beta_4 * z265 - c_beta_4 * z264;
    const Scalar z670 = z260 - z669;
    const Scalar z671 = s_beta_3 * z668 - c_beta_3 * z670;
    const Scalar z672 = z256 - z671;
    const Scalar z673 = s_beta_3 * z670 + c_beta_3 * z668;
    const Scalar z674 = z257 + z673;
    const Scalar z675 = s_beta_2 * z672 + c_beta_2 * z674;
    const Scalar z676 = z253 + z675;
    const Scalar z677 = s_beta_2 * z674 - c_beta_2 * z672;
    const Scalar z678 = z252 - z677;
    const Scalar z679 = s_beta_1 * (z357 + z676) + c_beta_1 * (z356 - z678);
    const Scalar z680 = n4 * z647;
    const Scalar z681 = c_gamma * z680;
    const Scalar z682 = n2400 * z681;
    const Scalar z683 = s_beta_2 * z680;
    const Scalar z684 = c_beta_2 * z680;
    const Scalar z685 = n4 * z658 + z684;
    const Scalar z686 = s_beta_3 * z685 + c_beta_3 * z683;
    const Scalar z687 = s_beta_3 * z683 - c_beta_3 * z685;
    const Scalar z688 = n4 * z651 - z687;
    const Scalar z689 = s_beta_4 * z688 + c_beta_4 * z686;
    const Scalar z690 = n500 * z689;
    const Scalar z691 = n4 * z656 - n1900 * z686 - z690;
    const Scalar z692 = n4 * z657 - n4400 * z683 + z691;
    const Scalar z693 = n4 * (z663 - z664) - z682 - z692;
    const Scalar z694 = n60000 + z693;
    const Scalar z695 = n2 * z252;
    const Scalar z696 = s_gamma * z318 - c_gamma * z319;
    const Scalar z697 = n2400 * z696;
    const Scalar z698 = n2 * z256;
    const Scalar z699 = s_beta_2 * z319 + c_beta_2 * z318;
    const Scalar z700 = n2 * z260;
    const Scalar z701 = s_beta_2 * z318 - c_beta_2 * z319;
    const Scalar z702 = s_beta_3 * z701 - c_beta_3 * z699;
    const Scalar z703 = n2 * z264;
    const Scalar z704 = s_beta_3 * z699 + c_beta_3 * z701;
    const Scalar z705 = s_beta_4 * z704 + c_beta_4 * z702;
    const Scalar z706 = z703 + n500 * z705;
    const Scalar z707 = n4 * z669 - z700 - n1900 * z702 - z706;
    const Scalar z708 = n4 * z671 - z698 + n4400 * z699 + z707;
    const Scalar z709 = n16600 * z318 + n4 * z677 - z695 + z697 + z708;
    const Scalar z710 = k12 - z709;
    const Scalar z711 = s_beta_1 * z661 - c_beta_1 * z664;
    const Scalar z712 = s_beta_2 * (z351 - z672) + c_beta_2 * (z352 - z674);
    const Scalar z713 = s_beta_2 * (z352 - z674) - c_beta_2 * (z351 - z672);
    const Scalar z714 = s_beta_1 * z712 + c_beta_1 * z713;
    const Scalar z715 = n4 * z658;
    const Scalar z716 = s_beta_3 * z715;
    const Scalar z717 = c_beta_3 * z715;
    const Scalar z718 = n4 * z651 + z717;
    const Scalar z719 = s_beta_4 * z718 + c_beta_4 * z716;
    const Scalar z720 = n500 * z719;
    const Scalar z721 = n4 * z656 - n1900 * z716 - z720;
    const Scalar z722 = n4 * z657 + z721;
    const Scalar z723 = n4 * z664 + z722;
    const Scalar z724 = s_beta_3 * z323 + c_beta_3 * z322;
    const Scalar z725 = s_beta_3 * z322 - c_beta_3 * z323;
    const Scalar z726 = s_beta_4 * z725 - c_beta_4 * z724;
    const Scalar z727 = z703 + n500 * z726;
    const Scalar z728 = n4 * z669 - z700 + n1900 * z724 - z727;
    const Scalar z729 = n4400 * z322 + n4 * z671 - z698 + z728;
    const Scalar z730 = n4 * z713 - z729;
    const Scalar z731 = n28000 - z722;
    const Scalar z732 = k14 - z729;
    const Scalar z733 = s_beta_2 * z657 + c_beta_2 * z659;
    const Scalar z734 = s_beta_2 * z659 - c_beta_2 * z657;
    const Scalar z735 = s_beta_1 * z733 + c_beta_1 * z734;
    const Scalar z736 = s_beta_3 * (z347 - z668) - c_beta_3 * (z346 - z670);
    const Scalar z737 = s_beta_3 * (z346 - z670) + c_beta_3 * (z347 - z668);
    const Scalar z738 = s_beta_2 * z736 - c_beta_2 * z737;
    const Scalar z739 = s_beta_2 * z737 + c_beta_2 * z736;
    const Scalar z740 = s_beta_1 * z738 - c_beta_1 * z739;
    const Scalar z741 = n4 * z651;
    const Scalar z742 = s_beta_4 * z741;
    const Scalar z743 = n500 * z742;
    const Scalar z744 = n4 * z656 - z743;
    const Scalar z745 = n4 * z657 + z744;
    const Scalar z746 = n4 * z734 - z745;
    const Scalar z747 = s_beta_4 * z328 + c_beta_4 * z327;
    const Scalar z748 = z703 - n500 * z747;
    const Scalar z749 = n1900 * z327 + n4 * z669 - z700 - z748;
    const Scalar z750 = n4 * z736 - z749;
    const Scalar z751 = n4 * z739 + z750;
    const Scalar z752 = n12000 - z744;
    const Scalar z753 = k16 - z749;
    const Scalar z754 = s_beta_3 * z654 + c_beta_3 * z656;
    const Scalar z755 = s_beta_3 * z656 - c_beta_3 * z654;
    const Scalar z756 = s_beta_2 * z754 + c_beta_2 * z755;
    const Scalar z757 = s_beta_2 * z755 - c_beta_2 * z754;
    const Scalar z758 = s_beta_1 * z756 + c_beta_1 * z757;
    const Scalar z759 = s_beta_4 * (z264 - z294) + c_beta_4 * (z265 - z342);
    const Scalar z760 = s_beta_4 * (z265 - z342) - c_beta_4 * (z264 - z294);
    const Scalar z761 = s_beta_3 * z759 + c_beta_3 * z760;
    const Scalar z762 = s_beta_3 * z760 - c_beta_3 * z759;
    const Scalar z763 = s_beta_2 * z761 + c_beta_2 * z762;
    const Scalar z764 = s_beta_2 * z762 - c_beta_2 * z761;
    const Scalar z765 = s_beta_1 * z763 + c_beta_1 * z764;
    const Scalar z766 = n4 * z656;
    const Scalar z767 = n4 * z754 + z766;
    const Scalar z768 = n4 * z757 - z767;
    const Scalar z769 = n500 * z332 - z703;
    const Scalar z770 = n4 * z760 + z769;
    const Scalar z771 = n4 * z761 + z770;
    const Scalar z772 = n4 * z764 - z771;
    const Scalar z773 = k18 - z769;
    const Scalar z774 = s_beta_1 * z650 - c_beta_1 * z663;
    const Scalar z775 = s_beta_1 * z341 + c_beta_1 * z340;
    const Scalar z776 = n4 * z663;
    const Scalar z777 = n2400 * z336;
    const Scalar z778 = n4 * z340 - z777;
    const Scalar z779 = n600000 + z777;
    const Scalar z780 = z516 * z706 + z707;
    const Scalar z781 = z515 * z706 - z530 * z780 + z708;
    const Scalar z782 = z509 * z697 - z514 * z706 + z529 * z780 + z539 * z781 + z710;
    const Scalar z783 = z508 * z697 - z513 * z706 + z528 * z780 + z538 * z781 - z544 * z782 - z679;
    const Scalar z784 = z546 * z783;
    const Scalar z785 = z543 * z782 - z544 * z784;
    const Scalar z786 = z537 * z781 + z538 * z784 + z539 * z785;
    const Scalar z787 = z527 * z780 + z528 * z784 + z529 * z785 - z530 * z786;
    const Scalar z788 = z513 * z784 + z514 * z785 - z515 * z786 - z516 * z787 + k25 * z706;
    const Scalar z789 = z508 * z784 + z509 * z785 - k24 * z697;
    const Scalar z790 = z516 * z690 + z691;
    const Scalar z791 = z515 * z690 - z530 * z790 + z692;
    const Scalar z792 = z509 * z682 - z514 * z690 + z529 * z790 + z539 * z791 + z694;
    const Scalar z793 = z508 * z682 - z513 * z690 + z528 * z790 + z538 * z791 - z544 * z792 - z666;
    const Scalar z794 = z546 * z793;
    const Scalar z795 = z543 * z792 - z544 * z794;
    const Scalar z796 = z537 * z791 + z538 * z794 + z539 * z795;
    const Scalar z797 = z527 * z790 + z528 * z794 + z529 * z795 - z530 * z796;
    const Scalar z798 = z513 * z794 + z514 * z795 - z515 * z796 - z516 * z797 + k25 * z690;
    const Scalar z799 = z508 * z794 + z509 * z795 - k24 * z682;
    const Scalar z800 = z516 * z727 + z728;
    const Scalar z801 = z515 * z727 - z530 * z800 - z732;
    const Scalar z802 = z514 * z727 - z529 * z800 - z539 * z801 - z730;
    const Scalar z803 = z513 * z727 - z528 * z800 - z538 * z801 - z544 * z802 - z714;
    const Scalar z804 = z546 * z803;
    const Scalar z805 = z543 * z802 - z544 * z804;
    const Scalar z806 = z537 * z801 - z538 * z804 - z539 * z805;
    const Scalar z807 = z527 * z800 - z528 * z804 - z529 * z805 - z530 * z806;
    const Scalar z808 = z513 * z804 + z514 * z805 + z515 * z806 + z516 * z807 - k25 * z727;
    const Scalar z809 = z508 * z804 + z509 * z805;
    const Scalar z810 = z516 * z720 + z721;
    const Scalar z811 = z515 * z720 - z530 * z810 - z731;
    const Scalar z812 = z514 * z720 - z529 * z810 - z539 * z811 + z723;
    const Scalar z813 = z513 * z720 - z528 * z810 - z538 * z811 - z544 * z812 - z711;
    const Scalar z814 = z546 * z813;
    const Scalar z815 = z543 * z812 - z544 * z814;
    const Scalar z816 = z537 * z811 - z538 * z814 - z539 * z815;
    const Scalar z817 = z527 * z810 - z528 * z814 - z529 * z815 - z530 * z816;
    const Scalar z818 = z513 * z814 + z514 * z815 + z515 * z816 + z516 * z817 - k25 * z720;
    const Scalar z819 = z508 * z814 + z509 * z815;
    const Scalar z820 = z516 * z748 - z753;
    const Scalar z821 = z515 * z748 - z530 * z820 - z750;
    const Scalar z822 = z514 * z748 - z529 * z820 - z539 * z821 - z751;
    const Scalar z823 = z513 * z748 - z528 * z820 - z538 * z821 - z544 * z822 + z740;
    const Scalar z824 = z546 * z823;
    const Scalar z825 = z543 * z822 - z544 * z824;
    const Scalar z826 = z537 * z821 - z538 * z824 - z539 * z825;
    const Scalar z827 = z527 * z820 - z528 * z824 - z529 * z825 - z530 * z826;
    const Scalar z828 = z513 * z824 + z514 * z825 + z515 * z826 + z516 * z827 - k25 * z748;
    const Scalar z829 = z508 * z824 + z509 * z825;
    const Scalar z830 = z516 * z743 - z752;
    const Scalar z831 = z515 * z743 - z530 * z830 + z745;
    const Scalar z832 = z514 * z743 - z529 * z830 - z539 * z831 - z746;
    const Scalar z833 = z513 * z743 - z528 * z830 - z538 * z831 - z544 * z832 - z735;
    const Scalar z834 = z546 * z833;
    const Scalar z835 = z543 * z832 - z544 * z834;
    const Scalar z836 = z537 * z831 - z538 * z834 - z539 * z835;
    const Scalar z837 = z527 * z830 - z528 * z834 - z529 * z835 - z530 * z836;
    const Scalar z838 = z513 * z834 + z514 * z835 + z515 * z836 + z516 * z837 - k25 * z743;
    const Scalar z839 = z508 * z834 + z509 * z835;
    const Scalar z840 = z516 * z773 + z770;
    const Scalar z841 = z515 * z773 - z530 * z840 + z771;
    const Scalar z842 = z514 * z773 - z529 * z840 - z539 * z841 - z772;
    const Scalar z843 = z513 * z773 - z528 * z840 - z538 * z841 - z544 * z842 - z765;
    const Scalar z844 = z546 * z843;
    const Scalar z845 = z543 * z842 - z544 * z844;
    const Scalar z846 = z537 * z841 - z538 * z844 - z539 * z845;
    const Scalar z847 = z527 * z840 - z528 * z844 - z529 * z845 - z530 * z846;
    const Scalar z848 = z513 * z844 + z514 * z845 + z515 * z846 + z516 * z847 - k25 * z773;
    const Scalar z849 = z508 * z844 + z509 * z845;
    const Scalar z850 = n5000 * z516 + z766;
    const Scalar z851 = n5000 * z515 - z530 * z850 + z767;
    const Scalar z852 = n5000 * z514 - z529 * z850 - z539 * z851 - z768;
    const Scalar z853 = n5000 * z513 - z528 * z850 - z538 * z851 - z544 * z852 - z758;
    const Scalar z854 = z546 * z853;
    const Scalar z855 = z543 * z852 - z544 * z854;
    const Scalar z856 = z537 * z851 - z538 * z854 - z539 * z855;
    const Scalar z857 = z527 * z850 - z528 * z854 - z529 * z855 - z530 * z856;
    const Scalar z858 = n3_75 - z513 * z854 - z514 * z855 - z515 * z856 - z516 * z857;
    const Scalar z859 = z508 * z854 + z509 * z855;
    const Scalar z860 = z509 * z779 + z778;
    const Scalar z861 = z508 * z779 - z544 * z860 + z775;
    const Scalar z862 = z546 * z861;
    const Scalar z863 = z543 * z860 - z544 * z862;
    const Scalar z864 = z538 * z862 + z539 * z863;
    const Scalar z865 = z528 * z862 + z529 * z863 - z530 * z864;
    const Scalar z866 = z513 * z862 + z514 * z863 - z515 * z864 - z516 * z865;
    const Scalar z867 = z508 * z862 + z509 * z863 - k24 * z779;
    const Scalar z868 = n1200 * z509 - z776;
    const Scalar z869 = n1200 * z508 - z544 * z868 + z774;
    const Scalar z870 = z546 * z869;
    const Scalar z871 = z543 * z868 - z544 * z870;
    const Scalar z872 = z538 * z870 + z539 * z871;
    const Scalar z873 = z528 * z870 + z529 * z871 - z530 * z872;
    const Scalar z874 = z513 * z870 + z514 * z871 - z515 * z872 - z516 * z873;
    const Scalar z875 = n60_over_179 - z508 * z870 - z509 * z871;
    result.M[0] = n20500;
    result.M[1] = z243;
    result.M[2] = -z225;
    result.M[3] = z207;
    result.M[4] = z189;
    result.M[5] = z168;
    result.M[6] = z243;
    result.M[7] = z238;
    result.M[8] = z223;
    result.M[9] = z205;
    result.M[10] = z187;
    result.M[11] = z166;
    result.M[12] = -z225;
    result.M[13] = z223;
    result.M[14] = z219;
    result.M[15] = z202;
    result.M[16] = z184;
    result.M[17] = n0;
    result.M[18] = z207;
    result.M[19] = z205;
    result.M[20] = z202;
    result.M[21] = z198;
    result.M[22] = z181;
    result.M[23] = n0;
    result.M[24] = z189;
    result.M[25] = z187;
    result.M[26] = z184;
    result.M[27] = z181;
    result.M[28] = k7;
    result.M[29] = n0;
    result.M[30] = z168;
    result.M[31] = z166;
    result.M[32] = n0;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n3580;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = -z666;
    result.C[7] = z694;
    result.C[8] = -z692;
    result.C[9] = -z691;
    result.C[10] = z690;
    result.C[11] = -z682;
    result.C[12] = z711;
    result.C[13] = -z723;
    result.C[14] = z731;
    result.C[15] = -z721;
    result.C[16] = z720;
    result.C[17] = n0;
    result.C[18] = z735;
    result.C[19] = z746;
    result.C[20] = -z745;
    result.C[21] = z752;
    result.C[22] = z743;
    result.C[23] = n0;
    result.C[24] = z758;
    result.C[25] = z768;
    result.C[26] = -z767;
    result.C[27] = -z766;
    result.C[28] = n5000;
    result.C[29] = n0;
    result.C[30] = -z774;
    result.C[31] = z776;
    result.C[32] = n0;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n1200;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = -z679;
    result.K[7] = z710;
    result.K[8] = -z708;
    result.K[9] = -z707;
    result.K[10] = z706;
    result.K[11] = -z697;
    result.K[12] = z714;
    result.K[13] = z730;
    result.K[14] = z732;
    result.K[15] = -z728;
    result.K[16] = z727;
    result.K[17] = n0;
    result.K[18] = -z740;
    result.K[19] = z751;
    result.K[20] = z750;
    result.K[21] = z753;
    result.K[22] = z748;
    result.K[23] = n0;
    result.K[24] = z765;
    result.K[25] = z772;
    result.K[26] = -z771;
    result.K[27] = -z770;
    result.K[28] = z773;
    result.K[29] = n0;
    result.K[30] = -z775;
    result.K[31] = -z778;
    result.K[32] = n0;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = z779;
    result.F[0] = -z361;
    result.F[1] = -z362;
    result.F[2] = -z363;
    result.F[3] = -z364;
    result.F[4] = -z365;
    result.F[5] = -z366;
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
    result.A[18] = z784;
    result.A[19] = z785;
    result.A[20] = -z786;
    result.A[21] = -z787;
    result.A[22] = -z788;
    result.A[23] = -z789;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = -z804;
    result.A[31] = -z805;
    result.A[32] = -z806;
    result.A[33] = -z807;
    result.A[34] = z808;
    result.A[35] = z809;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n0;
    result.A[42] = -z824;
    result.A[43] = -z825;
    result.A[44] = -z826;
    result.A[45] = -z827;
    result.A[46] = z828;
    result.A[47] = z829;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = -z844;
    result.A[55] = -z845;
    result.A[56] = -z846;
    result.A[57] = -z847;
    result.A[58] = z848;
    result.A[59] = z849;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = -z862;
    result.A[67] = -z863;
    result.A[68] = z864;
    result.A[69] = z865;
    result.A[70] = z866;
    result.A[71] = z867;
    result.A[72] = n1;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = n0;
    result.A[78] = n0;
    result.A[79] = n0;
    result.A[80] = n0;
    result.A[81] = n0;
    result.A[82] = n0;
    result.A[83] = n0;
    result.A[84] = n0;
    result.A[85] = n1;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = z794;
    result.A[91] = z795;
    result.A[92] = -z796;
    result.A[93] = -z797;
    result.A[94] = -z798;
    result.A[95] = -z799;
    result.A[96] = n0;
    result.A[97] = n0;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = -z814;
    result.A[103] = -z815;
    result.A[104] = -z816;
    result.A[105] = -z817;
    result.A[106] = z818;
    result.A[107] = z819;
    result.A[108] = n0;
    result.A[109] = n0;
    result.A[110] = n0;
    result.A[111] = n1;
    result.A[112] = n0;
    result.A[113] = n0;
    result.A[114] = -z834;
    result.A[115] = -z835;
    result.A[116] = -z836;
    result.A[117] = -z837;
    result.A[118] = z838;
    result.A[119] = z839;
    result.A[120] = n0;
    result.A[121] = n0;
    result.A[122] = n0;
    result.A[123] = n0;
    result.A[124] = n1;
    result.A[125] = n0;
    result.A[126] = -z854;
    result.A[127] = -z855;
    result.A[128] = -z856;
    result.A[129] = -z857;
    result.A[130] = -z858;
    result.A[131] = z859;
    result.A[132] = n0;
    result.A[133] = n0;
    result.A[134] = n0;
    result.A[135] = n0;
    result.A[136] = n0;
    result.A[137] = n1;
    result.A[138] = -z870;
    result.A[139] = -z871;
    result.A[140] = z872;
    result.A[141] = z873;
    result.A[142] = z874;
    result.A[143] = -z875;
    if (!(traits::regular(-z545, n20500) && traits::regular(-z542, z238) && traits::regular(-z536, z219)
        && traits::regular(-z526, z198))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((((result.M[1] - result.M[1]) + (result.M[2] - result.M[2]) + (result.M[3] - result.M[3])
        + (result.M[4] - result.M[4]) + (result.M[5] - result.M[5]) + (result.M[6] - result.M[6]) + (result.M[7]
        - result.M[7]) + (result.M[8] - result.M[8])) + ((result.M[9] - result.M[9]) + (result.M[10] - result.M[10])
        + (result.M[11] - result.M[11]) + (result.M[12] - result.M[12]) + (result.M[13] - result.M[13]) + (result.M[14]
        - result.M[14]) + (result.M[15] - result.M[15]) + (result.M[16] - result.M[16]) + (result.M[18]
        - result.M[18]))) + (((result.M[19] - result.M[19]) + (result.M[20] - result.M[20]) + (result.M[21]
        - result.M[21]) + (result.M[22] - result.M[22]) + (result.M[24] - result.M[24]) + (result.M[25] - result.M[25])
        + (result.M[26] - result.M[26]) + (result.M[27] - result.M[27])) + ((result.M[30] - result.M[30])
        + (result.M[31] - result.M[31]) + (result.C[6] - result.C[6]) + (result.C[7] - result.C[7]) + (result.C[8]
        - result.C[8]) + (result.C[9] - result.C[9]) + (result.C[10] - result.C[10]) + (result.C[11] - result.C[11])
        + (result.C[12] - result.C[12])))) + ((((result.C[13] - result.C[13]) + (result.C[14] - result.C[14])
        + (result.C[15] - result.C[15]) + (result.C[16] - result.C[16]) + (result.C[18] - result.C[18]) + (result.C[19]
        - result.C[19]) + (result.C[20] - result.C[20]) + (result.C[21] - result.C[21])) + ((result.C[22]
        - result.C[22]) + (result.C[24] - result.C[24]) + (result.C[25] - result.C[25]) + (result.C[26] - result.C[26])
        + (result.C[27] - result.C[27]) + (result.C[30] - result.C[30]) + (result.C[31] - result.C[31]) + (result.K[6]
        - result.K[6]) + (result.K[7] - result.K[7]))) + (((result.K[8] - result.K[8]) + (result.K[9] - result.K[9])
        + (result.K[10] - result.K[10]) + (result.K[11] - result.K[11]) + (result.K[12] - result.K[12]) + (result.K[13]
        - result.K[13]) + (result.K[14] - result.K[14]) + (result.K[15] - result.K[15]) + (result.K[16] - result.K[16]))
        + ((result.K[18] - result.K[18]) + (result.K[19] - result.K[19]) + (result.K[20] - result.K[20]) + (result.K[21]
        - result.K[21]) + (result.K[22] - result.K[22]) + (result.K[24] - result.K[24]) + (result.K[25] - result.K[25])
        + (result.K[26] - result.K[26]) + (result.K[27] - result.K[27]))))) + (((((result.K[28] - result.K[28])
        + (result.K[30] - result.K[30]) + (result.K[31] - result.K[31]) + (result.K[35] - result.K[35]) + (result.F[0]
        - result.F[0]) + (result.F[1] - result.F[1]) + (result.F[2] - result.F[2]) + (result.F[3] - result.F[3]))
        + ((result.F[4] - result.F[4]) + (result.F[5] - result.F[5]) + (result.A[18] - result.A[18]) + (result.A[19]
        - result.A[19]) + (result.A[20] - result.A[20]) + (result.A[21] - result.A[21]) + (result.A[22] - result.A[22])
        + (result.A[23] - result.A[23]) + (result.A[30] - result.A[30]))) + (((result.A[31] - result.A[31])
        + (result.A[32] - result.A[32]) + (result.A[33] - result.A[33]) + (result.A[34] - result.A[34]) + (result.A[35]
        - result.A[35]) + (result.A[42] - result.A[42]) + (result.A[43] - result.A[43]) + (result.A[44] - result.A[44])
        + (result.A[45] - result.A[45])) + ((result.A[46] - result.A[46]) + (result.A[47] - result.A[47])
        + (result.A[54] - result.A[54]) + (result.A[55] - result.A[55]) + (result.A[56] - result.A[56]) + (result.A[57]
        - result.A[57]) + (result.A[58] - result.A[58]) + (result.A[59] - result.A[59]) + (result.A[66]
        - result.A[66])))) + ((((result.A[67] - result.A[67]) + (result.A[68] - result.A[68]) + (result.A[69]
        - result.A[69]) + (result.A[70] - result.A[70]) + (result.A[71] - result.A[71]) + (result.A[90] - result.A[90])
        + (result.A[91] - result.A[91]) + (result.A[92] - result.A[92])) + ((result.A[93] - result.A[93])
        + (result.A[94] - result.A[94]) + (result.A[95] - result.A[95]) + (result.A[102] - result.A[102])
        + (result.A[103] - result.A[103]) + (result.A[104] - result.A[104]) + (result.A[105] - result.A[105])
        + (result.A[106] - result.A[106]) + (result.A[107] - result.A[107]))) + (((result.A[114] - result.A[114])
        + (result.A[115] - result.A[115]) + (result.A[116] - result.A[116]) + (result.A[117] - result.A[117])
        + (result.A[118] - result.A[118]) + (result.A[119] - result.A[119]) + (result.A[126] - result.A[126])
        + (result.A[127] - result.A[127]) + (result.A[128] - result.A[128])) + ((result.A[129] - result.A[129])
        + (result.A[130] - result.A[130]) + (result.A[131] - result.A[131]) + (result.A[138] - result.A[138])
        + (result.A[139] - result.A[139]) + (result.A[140] - result.A[140]) + (result.A[141] - result.A[141])
        + (result.A[142] - result.A[142]) + (result.A[143] - result.A[143])))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace elastic_wing
