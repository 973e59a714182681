// SPDX-License-Identifier: MIT-0
// Dormand and Prince's method of order 8 with embedded formulas of orders 5 and 3, in the version of Hairer and Wanner
// (Hairer-Norsett-Wanner I, II.5 and II.10, constants of their code dop853).
globalThis.torsorReport = {};
(() => {
"use strict";
const times = [
  0.0, 5.26001519587677318785587544488e-2, 7.89002279381515978178381316732e-2, 1.18350341907227396726757197510e-1,
  2.81649658092772603273242802490e-1, 1.0 / 3, 0.25, 4.0 / 13, 127.0 / 195, 0.6, 6.0 / 7, 1.0
];
// Weights of the slopes in stages 2 to 12, then of the solution.
const weights = [
  [
    5.26001519587677318785587544488e-2
  ],
  [
    1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2
  ],
  [
    2.95875854768068491816892993775e-2, 0, 8.87627564304205475450678981324e-2
  ],
  [
    2.41365134159266685502369798665e-1, 0, -8.84549479328286085344864962717e-1, 9.24834003261792003115737966543e-1
  ],
  [
    3.7037037037037037037037037037e-2, 0, 0, 1.70828608729473871279604482173e-1, 1.25467687566822425016691814123e-1
  ],
  [
    3.7109375e-2, 0, 0, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2, -1.7578125e-2
  ],
  [
    3.70920001185047927108779319836e-2, 0, 0, 1.70383925712239993810214054705e-1, 1.07262030446373284651809199168e-1,
    -1.53194377486244017527936158236e-2, 8.27378916381402288758473766002e-3
  ],
  [
    6.24110958716075717114429577812e-1, 0, 0, -3.36089262944694129406857109825, -8.68219346841726006818189891453e-1,
    2.75920996994467083049415600797e1, 2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1
  ],
  [
    4.77662536438264365890433908527e-1, 0, 0, -2.48811461997166764192642586468, -5.90290826836842996371446475743e-1,
    2.12300514481811942347288949897e1, 1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1,
    -2.03312017085086261358222928593e-2
  ],
  [
    -9.3714243008598732571704021658e-1, 0, 0, 5.18637242884406370830023853209, 1.09143734899672957818500254654,
    -8.14978701074692612513997267357, -1.85200656599969598641566180701e1, 2.27394870993505042818970056734e1,
    2.49360555267965238987089396762, -3.0467644718982195003823669022
  ],
  [
    2.27331014751653820792359768449, 0, 0, -1.05344954667372501984066689879e1, -2.00087205822486249909675718444,
    -1.79589318631187989172765950534e1, 2.79488845294199600508499808837e1, -2.85899827713502369474065508674,
    -8.87285693353062954433549289258, 1.23605671757943030647266201528e1, 6.43392746015763530355970484046e-1
  ],
  [
    5.42937341165687622380535766363e-2, 0, 0, 0, 0, 4.45031289275240888144113950566, 1.89151789931450038304281599044,
    -5.8012039600105847814672114227, 3.1116436695781989440891606237e-1, -1.52160949662516078556178806805e-1,
    2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2
  ],
];
// Weights of the slopes in the error of order 5, and of slopes 1, 9 and 12 in the solution of order 3.
const fifth = [
  1.312004499419488073250102996e-2, 0, 0, 0, 0, -1.225156446376204440720569753, -4.957589496572501915214079952e-1,
  1.664377182454986536961530415, -3.50328848749973681688648729e-1, 3.341791187130174790297318841e-1,
  8.192320648511571246570742613e-2, -2.235530786388629525884427845e-2
];
const third = [31 / 127, 0.733846688281611857341361741547, 3 / 136];

/// How far settling may move the end of a step, in tolerances: a constraint that follows a law of time is left by whatever that
/// law did within the step, and no other estimate sees it. Roundings of the largest number of the state are no correction.
const mostSettled = 100, roundings = 4096;

/// A motion from (t, y) by steps that the tolerance chooses; f(t, y, slope) says false where there is no slope.
/// `settle(t, y)`, when given, puts what a step has reached onto its constraints and says false where it cannot.
class Integrator {
  constructor(f, t, y, { tolerance = 1e-10, absolute = tolerance, settle = null, stepLimit = Infinity } = {}) {
    Object.assign(this, { f, t, settle, tolerance, absolute, stepLimit, h: 0, steps: 0, rejected: 0, status: "ok" });
    this.y = Float64Array.from(y);
    this.slopes = Array.from({ length: 12 }, () => new Float64Array(y.length));
    this.trial = new Float64Array(y.length);
    this.next = new Float64Array(y.length);
    this.memory = 1e-4;
    if (!f(t, this.y, this.slopes[0])) this.status = "«no acceleration at the start»";
  }

  /// Goes on to the time `end`; false, with a status, where the motion cannot.
  advance(end) {
    if (this.status !== "ok") return false;
    if (this.h === 0) this.h = this.firstStep(end - this.t);
    let rejections = 0;
    while (end - this.t > 1e-14 * Math.max(1, Math.abs(end))) {
      const h = Math.min(this.h, end - this.t);
      const reached = h === end - this.t ? end : this.t + h;
      let error = this.attempt(h);
      if (error <= 1 && this.settle) {
        const moved = this.settled(reached);
        if (Number.isNaN(moved)) {
          this.h = h * 0.3;
          if (++rejections > 60) return this.fail("«the constraints could not be closed»");
          continue;
        }
        if (moved > 1) error = moved;
      }
      if (!(error <= 1)) {
        ++this.rejected;
        this.h = h * (Number.isFinite(error) ? Math.max(0.3, 0.8 * error ** -0.125) : 0.3);
        if (++rejections > 60 || this.h < 1e-14 * Math.max(1, Math.abs(this.t))) return this.fail("«steps became too short»");
        continue;
      }
      this.t = reached;
      this.y.set(this.next);
      if (!this.f(this.t, this.y, this.slopes[0])) return this.fail("«no acceleration here»");
      const wanted = h * (error > 0 ? Math.min(6, Math.max(0.3, 0.8 * error ** -0.125)) : 6);
      this.h = rejections > 0 ? Math.min(wanted, h) : h < 0.99 * this.h ? Math.max(wanted, this.h) : wanted;
      rejections = 0;
      if (++this.steps > this.stepLimit) return this.fail("«too many steps»");
    }
    return true;
  }

  fail(status) {
    this.status = status;
    return false;
  }

  /// Weighted error of a step of length h, which leaves its end in `next`.
  attempt(h) {
    const { y, trial, next, slopes } = this, n = y.length;
    for (let stage = 1; stage <= 12; ++stage) {
      const row = weights[stage - 1], to = stage < 12 ? trial : next;
      for (let i = 0; i < n; ++i) {
        let sum = 0;
        for (let j = 0; j < row.length; ++j) if (row[j] !== 0) sum += row[j] * slopes[j][i];
        to[i] = y[i] + h * sum;
      }
      if (stage < 12 && !this.f(this.t + times[stage] * h, trial, slopes[stage])) return NaN;
    }
    let five = 0, three = 0;
    for (let i = 0; i < n; ++i) {
      let slope = 0, off = 0;
      for (let j = 0; j < 12; ++j) {
        if (weights[11][j]) slope += weights[11][j] * slopes[j][i];
        if (fifth[j]) off += fifth[j] * slopes[j][i];
      }
      const low = third[0] * slopes[0][i] + third[1] * slopes[8][i] + third[2] * slopes[11][i];
      const weight = this.absolute + this.tolerance * Math.max(Math.abs(y[i]), Math.abs(next[i]));
      five += (off / weight) ** 2;
      three += ((slope - low) / weight) ** 2;
    }
    const mixed = five + 0.01 * three;
    return mixed === 0 ? 0 : (Math.abs(h) * five) / Math.sqrt(mixed * n);
  }

  /// Settles `next`; what that moved over the most that it may, 1 and less being allowed, and not a number where it could not.
  settled(reached) {
    const { y, next } = this, before = Float64Array.from(next);
    if (!this.settle(reached, next)) return NaN;
    const least = roundings * Number.EPSILON * before.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    let sum = 0;
    for (let i = 0; i < next.length; ++i) {
      const size = Math.max(Math.abs(y[i]), Math.abs(before[i]), Math.abs(next[i]));
      const allowed = Math.max(mostSettled * (this.absolute + this.tolerance * size), least);
      if (next[i] !== before[i]) sum += ((next[i] - before[i]) / allowed) ** 2;
    }
    return Math.sqrt(sum / next.length);
  }

  firstStep(span) {
    let size = 0, slope = 0;
    this.y.forEach((value, i) => {
      const weight = this.absolute + this.tolerance * Math.abs(value);
      size += (value / weight) ** 2;
      slope += (this.slopes[0][i] / weight) ** 2;
    });
    const guess = slope > 0 && size > 0 ? 0.01 * Math.sqrt(size / slope) : 1e-3;
    return Math.min(span, Math.max(guess, 1e-6 * span));
  }
}

torsorReport.Integrator = Integrator;
})();
