// SPDX-License-Identifier: MIT-0
// Sine and cosine in one, with an error of at most 1 ulp: the operations of sincos.hpp in the same order, so that results
// have the same bits as those of a C++ header whose sums and products are not fused.

const turned = new Float64Array(2);  // sine and cosine of the last angle

const SHIFT = 6755399441055744;
const rounded = (x) => x + SHIFT - SHIFT;

/// Of high - rest, |high| <= pi/4, rest being about an ulp of high at most.
function ofReduced(high, rest) {
  const z = high * high, z2 = z * z;
  const S01 = -0.1666666666666663 + z * 0.00833333333332184;
  const S23 = -0.00019841269829358528 + z * 2.755731353851415e-6;
  const S45 = -2.505073438921608e-8 + z * 1.5895433285784582e-10;
  const C01 = 0.0416666666666666 + z * -0.0013888888888874465;
  const C23 = 2.480158728966221e-5 + z * -2.75573143974569e-7;
  const C45 = 2.087572869762074e-9 + z * -1.1359899724337997e-11;
  const S = S01 + z2 * (S23 + z2 * S45);
  const C = C01 + z2 * (C23 + z2 * C45);
  const halfZ = 0.5 * z, w = 1 - halfZ, highZ = high * z;
  turned[0] = high - (rest * w - highZ * S);
  turned[1] = w + (1 - w - halfZ + high * rest + z2 * C);
}

/// Beyond the bound n pi/2 is subtracted exactly: x/(2 pi) modulo 1 in integers.
function sincosFar(x) {
  if (!(Math.abs(x) <= Number.MAX_VALUE)) {
    turned[0] = turned[1] = x - x;
    return;
  }
  if (Math.abs(x) <= 0.5) return ofReduced(x, 0);
  const mask = 0xffffffffn;
  // 1/(2 pi) behind 64 zeros
  const turns = [
    0n, 0n, 0x28be60dbn, 0x9391054an, 0x7f09d5f4n, 0x7d4d3770n, 0x36d8a566n, 0x4f10e410n,
    0x7f9458ean, 0xf7aef158n, 0x6dc91b8en, 0x909374b8n, 0x01924bban, 0x82746487n, 0x3f877ac7n, 0x2c4a69cfn,
    0xba208d7dn, 0x4baed121n, 0x3a671c09n, 0xad17df90n, 0x4e64758en, 0x60d4ce7dn, 0x272117e2n, 0xef7e4a0en,
    0xc7fe25ffn, 0xf7816603n, 0xfbcbc462n, 0xd6829b47n, 0xdb4d9fb3n, 0xc9f2c26dn, 0xd3d18fd9n, 0xa797fa8bn,
    0x5d49eeb1n, 0xfaf97c5en, 0xcf41ce7dn, 0xe294a4ban, 0x9afed7ecn, 0x47e35742n, 0x1580cc11n,
  ];
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, Math.abs(x));
  const word = bits.getBigUint64(0);
  const exponent = Number(word >> 52n) - 1022;  // |x| >= 1/2: no subnormal
  const integer = (word & 0xfffffffffffffn) | 0x10000000000000n;  // |x| = integer 2^(exponent - 53)
  const position = exponent - 53 + 64;
  const skipped = Math.floor(position / 32), shift = BigInt(position % 32);
  const lowWord = (integer & mask) << shift, highWord = (integer >> 32n) << shift;
  const factor = [lowWord & mask, ((lowWord >> 32n) + highWord) & mask, ((lowWord >> 32n) + highWord) >> 32n];

  // The fraction of the product with seven words of 1/(2 pi), the lowest word first
  const turn = new Array(8).fill(0n);
  for (let k = 0; k < 7; ++k) {
    let carry = 0n;
    for (let m = 0; m < 3 && k + m < 7; ++m) {
      carry += turn[k + m] + factor[m] * turns[skipped + 6 - k];
      turn[k + m] = carry & mask;
      carry >>= 32n;
    }
    if (k + 3 < 7) turn[k + 3] = carry;
  }
  // Quarters of a turn, to nearest; what is left and its sign
  const quarter = ((turn[6] + 0x20000000n) & mask) >> 30n;
  turn[6] = (turn[6] - (quarter << 30n)) & mask;
  const negative = turn[6] >> 31n !== 0n;
  let carry = negative ? 1n : 0n;
  for (let k = 0; k < 7; ++k) {
    turn[k] = (negative ? turn[k] ^ mask : turn[k]) + carry;
    carry = turn[k] >> 32n;
    turn[k] &= mask;
  }
  // Its 128 leading bits, and these times pi/4
  let zeros = 0;
  for (; zeros < 96 && turn[6] >> 31n === 0n; ++zeros) {
    for (let k = 6; k > 0; --k) turn[k] = ((turn[k] << 1n) & mask) | (turn[k - 1] >> 31n);
    turn[0] = (turn[0] << 1n) & mask;
  }
  const quarterPi = [0x80dc1cd1n, 0xc4c6628bn, 0x2168c234n, 0xc90fdaa2n];
  const product = new Array(8).fill(0n);
  for (let k = 0; k < 4; ++k) {
    carry = 0n;
    for (let m = 0; m < 4; ++m) {
      carry += product[k + m] + turn[3 + k] * quarterPi[m];
      product[k + m] = carry & mask;
      carry >>= 32n;
    }
    product[k + 4] = carry;
  }
  const leading = (product[7] << 32n) | product[6], following = (product[5] << 32n) | product[4];
  const high = Number(leading & ~2047n) * 2 ** (3 - zeros - 64);
  const low = Number(((leading & 2047n) << 53n) | (following >> 11n)) * 2 ** (3 - zeros - 117);
  ofReduced(negative ? -high : high, negative ? low : -low);
  const s = turned[0], c = turned[1];
  const sine = quarter === 0n ? s : quarter === 1n ? c : quarter === 2n ? -s : -c;
  turned[1] = quarter === 0n ? c : quarter === 1n ? -s : quarter === 2n ? -c : s;
  turned[0] = x < 0 ? -sine : sine;
}

/// Sine and cosine of an angle, into `turned`.
function sincos(x) {
  if (Math.abs(x) > 2097152) return sincosFar(x);
  const n = x * 0.6366197723675814 + SHIFT - SHIFT;
  const first = x - n * 1.5707963267341256;
  const r = first - n * 6.077100506303966e-11;
  const error = first - r - n * 6.077100506303966e-11;
  const high = r - n * 2.0222662487111665e-21;
  const rest = n * 2.0222662487111665e-21 - (r - high) - error + n * 8.4784276603689e-32;
  ofReduced(high, rest);
  const s = turned[0], c = turned[1];
  // i = cos(n pi/2) and j = -sin(n pi/2)
  const next = n + 1;
  const i = next - 2 * rounded(0.5 * next);
  const j = 2 * rounded(0.5 * n) - n;
  turned[0] = s * i - c * j;
  turned[1] = c * i + s * j;
}

/// Whether a pivot is positive beyond the rounding of the diagonal entry it came from. A pivot that is not a number spoils
/// results, which say so.
const regular = (pivot, diagonal) => !(pivot <= 2.220446049250313e-16 * Math.abs(diagonal));

// Functions that take one of several forms, and the angle of a vector, as in selections.hpp.
const absolute = (x) => (x > 0 ? x : 0 - x);
const sign = (x) => (x > 0 ? 1 : x < 0 ? -1 : x);
const maximum = (a, b) => (a >= b ? a : a < b ? b : a + b);
const chosen = (condition, a, b) => (condition >= 0 ? a : condition < 0 ? b : condition);
function arctangent(y, x) {
  const along = absolute(x), up = absolute(y);
  const steep = up > along;
  const least = steep ? along : up, most = steep ? up : along;
  const beyond = least > 0.41421356237309503 * most;
  const below = beyond ? least + most : most;
  const r = (beyond ? least - most : least) / (below <= 0 ? 1 : below);
  const z = r * r, z2 = z * z, z4 = z2 * z2;
  const P01 = -0.333333333333332 + z * 0.1999999999995368;
  const P23 = -0.14285714280200829 + z * 0.11111110783578146;
  const P45 = -0.09090897760448766 + z * 0.0769206026900859;
  const P67 = -0.06663104825235365 + z * 0.058478964396876866;
  const P89 = -0.050393441967960376 + z * 0.0380657577033582;
  const P = P01 + z2 * P23 + z4 * (P45 + z2 * P67 + z4 * (P89 + z2 * -0.017908733845680366));
  const turn = r + r * z * P;
  const eighths = beyond ? 1 : 0;
  const back = x < 0;
  const mRight = steep ? 2 - eighths : eighths, tRight = steep ? -turn : turn;
  const m = back ? 4 - mRight : mRight, t = back ? -tRight : tRight;
  const angle = m * 0.7853981633974483 + (m * 3.061616997868383e-17 + t);
  return y < 0 ? -angle : angle;
}

/// Of each pair of series the terms a_i b_(k-i), i = 1..k-1, summed in the order of jets.hpp. Coefficients of order 0 are
/// not kept.
function convolutions(count, k, left, right, sums) {
  for (let lane = 0; lane < count; ++lane) {
    let sum = 0;
    for (let i = 2; i < k - 1; ++i) sum += left[count * i + lane] * right[count * (k - i) + lane];
    if (k > 1) sum += left[count + lane] * right[count * (k - 1) + lane];
    if (k > 2) sum += left[count * (k - 1) + lane] * right[count + lane];
    sums[lane] = sum;
  }
}
