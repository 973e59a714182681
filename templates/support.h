/* SPDX-License-Identifier: MIT */
#ifndef TORSOR_C_SUPPORT
#define TORSOR_C_SUPPORT 1
// Define TORSOR_SINGLE before the first generated header, alike in the whole program, for float in place of double, and
// TORSOR_LIBM for the library's sine and cosine. The file is C99, and as C++ the same.
#include <math.h>

#if defined(__FAST_MATH__) || (defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0)
#ifndef TORSOR_LIBM
#define TORSOR_LIBM  // sums would be reassociated or hold more digits than their type
#endif
#endif

#ifdef TORSOR_SINGLE
typedef float torsor_real;
#define TORSOR_NUMBER(in_double, in_float) (in_float)
#define TORSOR_FUNCTION(name) name##f
#else
typedef double torsor_real;
#define TORSOR_NUMBER(in_double, in_float) (in_double)
#define TORSOR_FUNCTION(name) name
#endif
#if defined(__GNUC__)
#define TORSOR_UNUSED __attribute__((unused))
#else
#define TORSOR_UNUSED
#endif

/// What a kernel says about its results; the larger, the worse.
typedef enum { torsor_ok = 0, torsor_singular = 1, torsor_not_finite = 2 } torsor_status;

enum { torsor_order_max = 30 };  // of Taylor coefficients

/// Whether a pivot is positive beyond the rounding of the diagonal entry it came from; not when it is not a number.
TORSOR_UNUSED static inline int torsor_regular(torsor_real pivot, torsor_real diagonal) {
  return pivot > TORSOR_NUMBER(0x1p-52, 0x1p-23f) * TORSOR_FUNCTION(fabs)(diagonal);
}

#ifdef TORSOR_LIBM
TORSOR_UNUSED static inline void torsor_sincos(torsor_real angle, torsor_real* sine, torsor_real* cosine) {
  *sine = TORSOR_FUNCTION(sin)(angle);
  *cosine = TORSOR_FUNCTION(cos)(angle);
}
#else
// Sine and cosine in one, with an error of at most 1 ulp: the operations of the C++ header in the same order, so that
// results have the same bits where no product is fused with a sum.
typedef unsigned long long torsor_word;  // at least 64 bits

/// Of high - rest, |high| <= pi/4, rest being about an ulp of high at most.
TORSOR_UNUSED static inline void torsor_of_reduced(double high, double rest, double* sine, double* cosine) {
  const double z = high * high, z2 = z * z;
  // sin r = r + r z S(z), cos r = 1 - z/2 + z z C(z)
  const double S01 = -0x1.5555555555548p-3 + z * 0x1.111111110f73p-7;
  const double S23 = -0x1.a01a019be9217p-13 + z * 0x1.71de35552b518p-19;
  const double S45 = -0x1.ae5e4b83e1601p-26 + z * 0x1.5d8b55934597bp-33;
  const double C01 = 0x1.555555555554cp-5 + z * -0x1.6c16c16c1521bp-10;
  const double C23 = 0x1.a01a019cbeb68p-16 + z * -0x1.27e4f8121198fp-22;
  const double C45 = 0x1.1ee9f0cbf70d6p-29 + z * -0x1.8fb0e15d5f2ap-37;
  const double S = S01 + z2 * (S23 + z2 * S45);
  const double C = C01 + z2 * (C23 + z2 * C45);
  const double half_z = 0.5 * z, w = 1.0 - half_z, high_z = high * z;
  *sine = high - (rest * w - high_z * S);
  *cosine = w + ((((1.0 - w) - half_z) + high * rest) + z2 * C);
}

/// For |x| <= 2^21: x - n pi/2 by parts of pi/2 so short that n times a part is exact.
TORSOR_UNUSED static inline void torsor_core(double x, double* sine, double* cosine) {
  const double shift = 0x1.8p52, P = 0x1.0b4611a6p-34, Q = 0x1.3198a2ep-69;
  const double n = (x * 0x1.45f306dc9c883p-1 + shift) - shift;
  const double first = x - n * 0x1.921fb544p+0;
  const double r = first - n * P;
  const double error = (first - r) - n * P;
  const double high = r - n * Q;
  const double rest = ((n * Q - (r - high)) - error) + n * 0x1.b839a252049c1p-104;
  double s, c;
  torsor_of_reduced(high, rest, &s, &c);
  // i = cos(n pi/2) and j = -sin(n pi/2): halves are rounded to even, which tells 1 from 3.
  const double next = n + 1.0;
  const double i = next - 2.0 * ((0.5 * next + shift) - shift);
  const double j = 2.0 * ((0.5 * n + shift) - shift) - n;
  *sine = s * i - c * j;
  *cosine = c * i + s * j;
}

/// Whether sums are rounded up, down or towards zero: a little more and a little less than one then differ. What is no
/// number does not tell. x keeps compilers from doing the sums themselves.
TORSOR_UNUSED static inline int torsor_rounds_to_one_side(torsor_real x) {
  const torsor_real one = TORSOR_NUMBER(1.0, 1.0f) + (x - x), little = TORSOR_NUMBER(0x1p-60, 0x1p-60f);
  return (one + little) - (one - little) > TORSOR_NUMBER(0.0, 0.0f);
}

/// Of any x: n pi/2 is subtracted exactly, x/(2 pi) modulo 1 in integers. Infinite: not a number. Under any rounding.
TORSOR_UNUSED static void torsor_sincos_far(double x, double* sine, double* cosine) {
  const torsor_word mask = 0xffffffffu;
  // 1/(2 pi) behind 64 zeros
  static const unsigned long turns[] = {
      0u,          0u,          0x28be60dbu, 0x9391054au, 0x7f09d5f4u, 0x7d4d3770u, 0x36d8a566u, 0x4f10e410u,
      0x7f9458eau, 0xf7aef158u, 0x6dc91b8eu, 0x909374b8u, 0x01924bbau, 0x82746487u, 0x3f877ac7u, 0x2c4a69cfu,
      0xba208d7du, 0x4baed121u, 0x3a671c09u, 0xad17df90u, 0x4e64758eu, 0x60d4ce7du, 0x272117e2u, 0xef7e4a0eu,
      0xc7fe25ffu, 0xf7816603u, 0xfbcbc462u, 0xd6829b47u, 0xdb4d9fb3u, 0xc9f2c26du, 0xd3d18fd9u, 0xa797fa8bu,
      0x5d49eeb1u, 0xfaf97c5eu, 0xcf41ce7du, 0xe294a4bau, 0x9afed7ecu, 0x47e35742u, 0x1580cc11u};
  if (!(fabs(x) <= 0x1.fffffffffffffp+1023)) {
    *sine = *cosine = x - x;
    return;
  }
  if (fabs(x) <= 0.5) {
    torsor_of_reduced(x, 0.0, sine, cosine);
    return;
  }
  int exponent = 0;
  const double mantissa = frexp(fabs(x), &exponent);
  const torsor_word integer = (torsor_word)ldexp(mantissa, 53);  // |x| = integer 2^(exponent - 53)
  const int position = exponent - 53 + 64;                           // at least 64 - 53
  const int skipped = position / 32, shift = position % 32;
  const torsor_word low_word = (integer & mask) << shift, high_word = (integer >> 32) << shift;
  const torsor_word factor[3] = {low_word & mask, ((low_word >> 32) + high_word) & mask,
                          (((low_word >> 32) + high_word) >> 32)};

  // The fraction of the product with seven words of 1/(2 pi), the lowest word first: an error of 2^-139 at most.
  torsor_word turn[8] = {0};
  for (int k = 0; k < 7; ++k) {
    torsor_word carry = 0;
    for (int m = 0; m < 3 && k + m < 7; ++m) {
      carry += turn[k + m] + factor[m] * turns[skipped + 6 - k];
      turn[k + m] = carry & mask;
      carry >>= 32;
    }
    if (k + 3 < 7) turn[k + 3] = carry;
  }
  // Quarters of a turn, to nearest; what is left, |rest| <= 1/8, and its sign
  const torsor_word quarter = ((turn[6] + 0x20000000u) & mask) >> 30;
  turn[6] = (turn[6] - (quarter << 30)) & mask;
  const int negative = (turn[6] >> 31) != 0;
  torsor_word carry = negative ? 1 : 0;
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
  static const torsor_word quarter_pi[4] = {0x80dc1cd1u, 0xc4c6628bu, 0x2168c234u, 0xc90fdaa2u};
  torsor_word product[8] = {0};
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
  const torsor_word leading = (product[7] << 32) | product[6], following = (product[5] << 32) | product[4];
  const double high = ldexp((double)(leading & ~(torsor_word)2047), 3 - zeros - 64);
  const double low = ldexp((double)(((leading & 2047) << 53) | (following >> 11)), 3 - zeros - 117);
  double s = 0, c = 0;
  torsor_of_reduced(negative ? -high : high, negative ? low : -low, &s, &c);
  const double turned = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
  *cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
  *sine = x < 0 ? -turned : turned;
}

#ifdef TORSOR_SINGLE
/// For |x| <= 1600.
TORSOR_UNUSED static inline void torsor_near(float x, float* sine, float* cosine) {
  const float shift = 0x1.8p23f, P = 0x1.ed5p-14f, Q = 0x1.10bp-30f;
  const float n = (x * 0x1.45f306p-1f + shift) - shift;
  const float first = x - n * 0x1.9218p+0f;
  const float r = first - n * P;
  const float error = (first - r) - n * P;
  const float high = r - n * Q;
  const float rest = ((n * Q - (r - high)) - error) + n * 0x1.184698p-44f;
  const float z = high * high, z2 = z * z;
  const float S01 = -0x1.555546p-3f + z * 0x1.110778p-7f;
  const float C01 = 0x1.55554ap-5f + z * -0x1.6c0c1ap-10f;
  const float S = S01 + z2 * -0x1.9953f2p-13f;
  const float C = C01 + z2 * 0x1.99e0eep-16f;
  const float half_z = 0.5f * z, w = 1.0f - half_z, high_z = high * z;
  const float s = high - (rest * w - high_z * S);
  const float c = w + ((((1.0f - w) - half_z) + high * rest) + z2 * C);
  const float next = n + 1.0f;
  const float i = next - 2.0f * ((0.5f * next + shift) - shift);
  const float j = 2.0f * ((0.5f * n + shift) - shift) - n;
  *sine = s * i - c * j;
  *cosine = c * i + s * j;
}
TORSOR_UNUSED static inline int torsor_is_far(float x) { return fabsf(x) > 1600.0f; }
TORSOR_UNUSED static void torsor_far(float x, float* sine, float* cosine) {
  double s, c;
  if (fabsf(x) <= 2097152.0f && !torsor_rounds_to_one_side(x))
    torsor_core((double)x, &s, &c);
  else
    torsor_sincos_far((double)x, &s, &c);
  *sine = (float)s;
  *cosine = (float)c;
}
#else
TORSOR_UNUSED static inline void torsor_near(double x, double* sine, double* cosine) { torsor_core(x, sine, cosine); }
TORSOR_UNUSED static inline int torsor_is_far(double x) { return fabs(x) > 2097152.0; }
TORSOR_UNUSED static void torsor_far(double x, double* sine, double* cosine) { torsor_sincos_far(x, sine, cosine); }
#endif

TORSOR_UNUSED static inline void torsor_sincos(torsor_real angle, torsor_real* sine, torsor_real* cosine) {
  if (torsor_is_far(angle) || torsor_rounds_to_one_side(angle))
    torsor_far(angle, sine, cosine);
  else
    torsor_near(angle, sine, cosine);
}
#endif

#ifndef TORSOR_LIBM
// Sines and cosines of several angles at once, in vector registers where GNU C has types for them and the processor has
// registers of two doubles.
#if defined(__GNUC__) && (defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON)))
#define TORSOR_VECTORS
#define TORSOR_FLATTENED static inline __attribute__((always_inline, unused))
#if defined(__AVX__)
#define TORSOR_VECTOR_BYTES 32
#else
#define TORSOR_VECTOR_BYTES 16
#endif
typedef torsor_real torsor_vector __attribute__((vector_size(TORSOR_VECTOR_BYTES)));
#ifdef TORSOR_SINGLE
typedef int torsor_bits __attribute__((vector_size(TORSOR_VECTOR_BYTES)));
#else
typedef long long torsor_bits __attribute__((vector_size(TORSOR_VECTOR_BYTES)));
#endif
enum { torsor_lanes = TORSOR_VECTOR_BYTES / (int)sizeof(torsor_real) };
// Lane by lane without a loop: places are then constants before anything is optimised.
#if defined(__AVX__) && defined(TORSOR_SINGLE)
#define TORSOR_EACH_LANE(act) act(0) act(1) act(2) act(3) act(4) act(5) act(6) act(7)
#elif defined(__AVX__) || defined(TORSOR_SINGLE)
#define TORSOR_EACH_LANE(act) act(0) act(1) act(2) act(3)
#else
#define TORSOR_EACH_LANE(act) act(0) act(1)
#endif
#define TORSOR_LOAD(i) if (first + i < size) x[i] = angles[first + i];
#define TORSOR_STORE(i) if (first + i < size) sines[first + i] = s[i], cosines[first + i] = c[i];
#define TORSOR_ADD(i) sum += squares[i];

/// What torsor_near does, in every lane. The quarter of the turn is in the last two bits of `shifted`: it is chosen by
/// bits, not by products.
TORSOR_FLATTENED void torsor_near_lanes(torsor_vector x, torsor_vector* sine, torsor_vector* cosine) {
  const torsor_vector zero = {0};
#ifdef TORSOR_SINGLE
  const torsor_vector shift = zero + 0x1.8p23f, P = zero + 0x1.ed5p-14f, Q = zero + 0x1.10bp-30f;
  const torsor_vector shifted = x * 0x1.45f306p-1f + shift, n = shifted - shift;
  const torsor_vector first = x - n * 0x1.9218p+0f;
#else
  const torsor_vector shift = zero + 0x1.8p52, P = zero + 0x1.0b4611a6p-34, Q = zero + 0x1.3198a2ep-69;
  const torsor_vector shifted = x * 0x1.45f306dc9c883p-1 + shift, n = shifted - shift;
  const torsor_vector first = x - n * 0x1.921fb544p+0;
#endif
  const torsor_vector r = first - n * P;
  const torsor_vector error = (first - r) - n * P;
  const torsor_vector high = r - n * Q;
  const torsor_vector z = high * high, z2 = z * z;
#ifdef TORSOR_SINGLE
  const torsor_vector rest = ((n * Q - (r - high)) - error) + n * 0x1.184698p-44f;
  const torsor_vector S01 = -0x1.555546p-3f + z * 0x1.110778p-7f;
  const torsor_vector C01 = 0x1.55554ap-5f + z * -0x1.6c0c1ap-10f;
  const torsor_vector S = S01 + z2 * -0x1.9953f2p-13f;
  const torsor_vector C = C01 + z2 * 0x1.99e0eep-16f;
  const torsor_vector half_z = 0.5f * z, w = 1.0f - half_z, high_z = high * z;
  const torsor_vector s = high - (rest * w - high_z * S);
  const torsor_vector c = w + ((((1.0f - w) - half_z) + high * rest) + z2 * C);
  const int sign_bit = 31;
#else
  const torsor_vector rest = ((n * Q - (r - high)) - error) + n * 0x1.b839a252049c1p-104;
  const torsor_vector S01 = -0x1.5555555555548p-3 + z * 0x1.111111110f73p-7;
  const torsor_vector S23 = -0x1.a01a019be9217p-13 + z * 0x1.71de35552b518p-19;
  const torsor_vector S45 = -0x1.ae5e4b83e1601p-26 + z * 0x1.5d8b55934597bp-33;
  const torsor_vector C01 = 0x1.555555555554cp-5 + z * -0x1.6c16c16c1521bp-10;
  const torsor_vector C23 = 0x1.a01a019cbeb68p-16 + z * -0x1.27e4f8121198fp-22;
  const torsor_vector C45 = 0x1.1ee9f0cbf70d6p-29 + z * -0x1.8fb0e15d5f2ap-37;
  const torsor_vector S = S01 + z2 * (S23 + z2 * S45);
  const torsor_vector C = C01 + z2 * (C23 + z2 * C45);
  const torsor_vector half_z = 0.5 * z, w = 1.0 - half_z, high_z = high * z;
  const torsor_vector s = high - (rest * w - high_z * S);
  const torsor_vector c = w + ((((1.0 - w) - half_z) + high * rest) + z2 * C);
  const int sign_bit = 63;
#endif
  const torsor_bits bits = (torsor_bits)shifted, odd = bits << sign_bit, upper = bits << (sign_bit - 1);
  const torsor_bits none = {0}, sign = ~none << sign_bit;
#if defined(__AVX__)
  const torsor_bits exchanged = odd < none;
#else
  const torsor_bits exchanged = none - (bits & 1);
#endif
  const torsor_bits both = ((torsor_bits)s ^ (torsor_bits)c) & exchanged;
  // The sine is negated for n = 2 and 3, the cosine for 1 and 2.
  *sine = (torsor_vector)((torsor_bits)s ^ both ^ (upper & sign));
  *cosine = (torsor_vector)((torsor_bits)c ^ both ^ ((upper ^ odd) & sign));
}

/// Of a register of angles, `first` and those behind it below `size`, idle lanes being 0; adds their squares. Both are
/// constants where this is called: lanes then come from registers and go there, where a way through memory would be
/// stored in parts and loaded whole.
TORSOR_FLATTENED void torsor_near_some(int first, int size, const torsor_real* angles, torsor_real* sines,
                                       torsor_real* cosines, torsor_vector* squares) {
  torsor_vector x = {0}, s, c;
  TORSOR_EACH_LANE(TORSOR_LOAD)
  torsor_near_lanes(x, &s, &c);
  TORSOR_EACH_LANE(TORSOR_STORE)
  *squares += x * x;
}

/// Of several angles: two registers at a time.
TORSOR_FLATTENED void torsor_sines_and_cosines(int count, const torsor_real* angles, torsor_real* sines,
                                               torsor_real* cosines) {
  enum { both = 2 * torsor_lanes };
  const int rest = count % both, whole = count - rest;
  torsor_vector squares = {0};
  for (int i = 0; i < whole; i += both) {
    torsor_near_some(0, both, angles + i, sines + i, cosines + i, &squares);
    torsor_near_some(torsor_lanes, both, angles + i, sines + i, cosines + i, &squares);
  }
  if (rest > 0) torsor_near_some(0, rest, angles + whole, sines + whole, cosines + whole, &squares);
  if (rest > torsor_lanes) torsor_near_some(torsor_lanes, rest, angles + whole, sines + whole, cosines + whole, &squares);
  torsor_real sum = TORSOR_NUMBER(0.0, 0.0f);
  TORSOR_EACH_LANE(TORSOR_ADD)
  const torsor_real bound = TORSOR_NUMBER(2097152.0, 1600.0f);
  if (sum <= bound * bound && !torsor_rounds_to_one_side(sum)) return;
  for (int i = 0; i < count; ++i) {
    if (torsor_is_far(angles[i]) || torsor_rounds_to_one_side(angles[i])) torsor_far(angles[i], sines + i, cosines + i);
  }
}
#endif
#endif
#ifndef TORSOR_VECTORS
/// Of several angles: where none is far the loop has no branch, and the compiler takes several at once.
TORSOR_UNUSED static inline void torsor_sines_and_cosines(int count, const torsor_real* angles, torsor_real* sines,
                                                          torsor_real* cosines) {
#ifndef TORSOR_LIBM
  int far = torsor_rounds_to_one_side(angles[0]);
  for (int i = 0; i < count; ++i) far |= torsor_is_far(angles[i]);
  if (!far) {
    for (int i = 0; i < count; ++i) torsor_near(angles[i], sines + i, cosines + i);
    return;
  }
#endif
  for (int i = 0; i < count; ++i) torsor_sincos(angles[i], sines + i, cosines + i);
}
#endif

// Functions that take one of several forms, and the angle of a vector. What is not a number stays so.
TORSOR_UNUSED static inline torsor_real torsor_absolute(torsor_real x) {
  const torsor_real zero = TORSOR_NUMBER(0.0, 0.0f);
  return x > zero ? x : zero - x;
}
TORSOR_UNUSED static inline torsor_real torsor_sign(torsor_real x) {
  const torsor_real zero = TORSOR_NUMBER(0.0, 0.0f), one = TORSOR_NUMBER(1.0, 1.0f);
  return x > zero ? one : x < zero ? -one : x;
}
TORSOR_UNUSED static inline torsor_real torsor_maximum(torsor_real a, torsor_real b) {
  return a >= b ? a : a < b ? b : a + b;
}
/// a where the condition is not negative, else b.
TORSOR_UNUSED static inline torsor_real torsor_chosen(torsor_real condition, torsor_real a, torsor_real b) {
  const torsor_real zero = TORSOR_NUMBER(0.0, 0.0f);
  return condition >= zero ? a : condition < zero ? b : condition;
}
/// The angle of (x, y) in (-pi, pi], 0 of (0, 0), within 2 ulp.
TORSOR_UNUSED static inline torsor_real torsor_arctangent(torsor_real y, torsor_real x) {
  const torsor_real zero = TORSOR_NUMBER(0.0, 0.0f), one = TORSOR_NUMBER(1.0, 1.0f);
  const torsor_real two = TORSOR_NUMBER(2.0, 2.0f), four = TORSOR_NUMBER(4.0, 4.0f);
  const torsor_real along = torsor_absolute(x), up = torsor_absolute(y);
  const int steep = up > along;
  const torsor_real least = steep ? along : up, most = steep ? up : along;
  const int beyond = least > TORSOR_NUMBER(0.41421356237309503, 0.41421357f) * most;
  const torsor_real below = beyond ? least + most : most;
  const torsor_real r = (beyond ? least - most : least) / (below <= zero ? one : below);
  const torsor_real z = r * r, z2 = z * z;
#ifdef TORSOR_SINGLE
  const float P01 = -0x1.55554ap-2f + z * 0x1.9991e2p-3f;
  const float P23 = -0x1.23b9a2p-3f + z * 0x1.b22456p-4f;
  const float P = P01 + z2 * (P23 + z2 * -0x1.f2e5a8p-5f);
#else
  const double z4 = z2 * z2;
  const double P01 = -0x1.555555555553dp-2 + z * 0x1.9999999995869p-3;
  const double P23 = -0x1.24924922ad512p-3 + z * 0x1.c71c70e6083c6p-4;
  const double P45 = -0x1.745cf8db95cb6p-4 + z * 0x1.3b11190f1498dp-4;
  const double P67 = -0x1.10ebb7d245dd7p-4 + z * 0x1.df0f46f2d5465p-5;
  const double P89 = -0x1.9cd2b525edae2p-5 + z * 0x1.37d5ae0dde472p-5;
  const double P = (P01 + z2 * P23) + z4 * ((P45 + z2 * P67) + z4 * (P89 + z2 * -0x1.256aac8b848dfp-6));
#endif
  const torsor_real turn = r + r * z * P;
  const torsor_real eighths = beyond ? one : zero;
  const torsor_real m_right = steep ? two - eighths : eighths, t_right = steep ? -turn : turn;
  const torsor_real m = x < zero ? four - m_right : m_right, t = x < zero ? -t_right : t_right;
  const torsor_real angle = m * TORSOR_NUMBER(0x1.921fb54442d18p-1, 0x1.921fbp-1f) +
                            (m * TORSOR_NUMBER(0x1.1a62633145c07p-55, 0x1.5110b4p-23f) + t);
  return y < zero ? -angle : angle;
}

/// Of each pair of series the terms a_i b_(k-i), i = 1..k-1, summed. Coefficients of order 0 are not kept.
TORSOR_UNUSED static inline void torsor_convolutions(int count, int k, const torsor_real left[],
                                                     const torsor_real right[], torsor_real sums[]) {
  for (int lane = 0; lane < count; ++lane) {
    torsor_real sum = TORSOR_NUMBER(0.0, 0.0f);
    for (int i = 2; i < k - 1; ++i) sum += left[count * i + lane] * right[count * (k - i) + lane];
    if (k > 1) sum += left[count + lane] * right[count * (k - 1) + lane];
    if (k > 2) sum += left[count * (k - 1) + lane] * right[count + lane];
    sums[lane] = sum;
  }
}
#elif TORSOR_C_SUPPORT != 1
#error "headers of incompatible versions of torsor meet here: write them again with one version"
#endif
