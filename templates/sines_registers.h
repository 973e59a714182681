/* SPDX-License-Identifier: MIT-0 */
// Sines and cosines of several angles at once, in vector registers where GNU C has types for them and the processor has
// registers of two doubles.
#if defined(__GNUC__) && !defined(TORSOR_SMALL) && (defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON)))
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
  TORSOR_AS_WRITTEN
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
