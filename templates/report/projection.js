// SPDX-License-Identifier: MIT-0
// States on their constraints by the least change in the metric of the masses (Hairer-Wanner II, VII.2; Lubich, Engstler,
// Nowak, Poehle 1995); constraints that repeat others are left out.
(() => {
"use strict";

/// Below this part of its usual size, or of what others have not repeated of it, a row of A is rounding and has no direction.
const rowIsRounding = 1e-9;
/// And below this part of the largest row it is rounding everywhere.
const rowIsAlwaysRounding = 1e-14;

/// Lower Cholesky factor of a symmetric matrix stored column by column, or null where it is not positive.
function cholesky(matrix, n) {
  const factor = Float64Array.from(matrix);
  for (let j = 0; j < n; ++j) {
    for (let k = 0; k < j; ++k) for (let i = j; i < n; ++i) factor[j * n + i] -= factor[k * n + i] * factor[k * n + j];
    const pivot = factor[j * n + j];
    if (!(pivot > 1e-14 * Math.abs(matrix[j * n + j]))) return null;
    for (let i = j; i < n; ++i) factor[j * n + i] /= Math.sqrt(pivot);
  }
  return factor;
}

/// The least change dv, in the metric of the factor L L', with A dv = right for the given rows of A (m rows, n columns,
/// column by column) and dv = 0 at the places kept, which the factor knows. Rows that others repeat are left out.
/// Rows that vanish here are none of those given.
function leastChange(jacobian, m, n, factor, rows, right, kept) {
  // Rows of A L'^-1, made orthonormal, the longest remainder first.
  const own = rows.map((row) => {
    const b = Float64Array.from({ length: n }, (_, j) => (kept.includes(j) ? 0 : jacobian[j * m + row]));
    for (let j = 0; j < n; ++j) {
      for (let k = 0; k < j; ++k) b[j] -= factor[k * n + j] * b[k];
      b[j] /= factor[j * n + j];
    }
    const size = Math.hypot(...b);
    return { b, right: right[row], size };
  }).filter((each) => each.size > 0);
  const basis = [], change = new Float64Array(n);
  const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
  while (own.length > 0) {
    let best = 0, share = -1;
    own.forEach((each, i) => {
      const left = Math.hypot(...each.b) / each.size;
      if (left > share) [best, share] = [i, left];
    });
    if (share < rowIsRounding) break;
    const [{ b, right: value }] = own.splice(best, 1);
    for (const e of basis) {  // once more: what is left of nearly dependent rows
      const along = dot(b, e.b);
      for (let i = 0; i < n; ++i) b[i] -= along * e.b[i];
    }
    const length = Math.hypot(...b);
    const e = b.map((entry) => entry / length), coefficient = value / length;
    basis.push({ b: e });
    for (let i = 0; i < n; ++i) change[i] += coefficient * e[i];
    for (const each of own) {
      const along = dot(each.b, e);
      for (let i = 0; i < n; ++i) each.b[i] -= along * e[i];
      each.right -= along * coefficient;
    }
  }
  for (let j = n - 1; j >= 0; --j) {  // L' dv = change
    for (let k = j + 1; k < n; ++k) change[j] -= factor[j * n + k] * change[k];
    change[j] /= factor[j * n + j];
  }
  return change;
}

/// Puts states of a mechanism onto its constraints, and gives quaternions their norm.
class Projection {
  constructor(mechanism, precomputed) {
    Object.assign(this, { mechanism, precomputed });
    this.nq = mechanism.coordinates.length;
    this.nv = mechanism.velocities.length;
    this.rates = new Float64Array(this.nq);
    this.state = new Float64Array(mechanism.stateSize);
    const kernel = mechanism.kernels.find((each) => each.name === "constraints");
    if (!kernel) return;
    const result = kernel.results[0];
    this.m = mechanism.multipliers.length;
    this.result = new Float64Array(result.size);
    this.at = Object.fromEntries(result.members.map((member) => [member.name, member.offset]));
    this.mass = new Float64Array(this.nv * this.nv);
    this.holonomic = this.usual = null;
  }

  normalise(y) {
    for (const first of this.mechanism.quaternions) {
      const norm = Math.hypot(y[first], y[first + 1], y[first + 2], y[first + 3]);
      for (let i = first; i < first + 4; ++i) y[i] /= norm;
    }
  }

  read(t, y) {
    this.state[0] = t;
    this.state.set(y, 1);
    this.mechanism.constraints(this.precomputed, this.state, this.result);
    const { at, m, nv } = this;
    this.jacobian = this.result.subarray(at.jacobian, at.jacobian + m * nv);
    this.value = this.result.subarray(at.value, at.value + m);
    this.rate = this.result.subarray(at.rate, at.rate + m);
    const sums = this.lengths();
    // Below its usual size by so much a row is rounding: it has no direction, and is no measure.
    this.vanishes = sums.map((sum, row) => this.usual !== null && sum < rowIsRounding * this.usual[row]);
    this.scale = sums.map((sum, row) => Math.max(this.vanishes[row] ? this.usual[row] : sum, 1e-300));
    return this.result.every(Number.isFinite);
  }

  lengths() {
    return Array.from({ length: this.m }, (_, row) => {
      let sum = 0;
      for (let j = 0; j < this.nv; ++j) sum += Math.abs(this.jacobian[j * this.m + row]);
      return sum;
    });
  }

  /// Lengths that rows have here and where other angles are; one that is rounding everywhere is judged as the others are.
  findUsual(t, y) {
    const turns = this.mechanism.velocities.map((each) => each.unit === "rad/s" || each.unit === "1/s");
    const usual = new Array(this.m).fill(0);
    for (let k = 0; k < 4; ++k) {
      const there = Float64Array.from(y);
      this.displace(t, there, Float64Array.from({ length: this.nv }, (_, i) => (turns[i] ? 0.2 * k * Math.sin(1 + k + 2.7 * i) : 0)));
      this.read(t, there);
      this.lengths().forEach((sum, row) => { if (Number.isFinite(sum)) usual[row] = Math.max(usual[row], sum); });
    }
    const largest = Math.max(...usual);
    this.usual = usual.map((sum) => (sum > rowIsAlwaysRounding * largest ? sum : largest || 1));
  }

  /// The value of a constraint on velocities alone is 0 wherever it is read: found by moving along both ways.
  findHolonomic(t, y) {
    const seen = new Set();
    for (const sign of [0, 1, -1]) {
      const there = Float64Array.from(y);
      this.displace(t, there, Float64Array.from({ length: this.nv }, (_, i) => sign * 1e-3 * Math.sin(1 + 7 * i)));
      this.read(t, there);
      this.value.forEach((value, row) => { if (value !== 0) seen.add(row); });
    }
    this.holonomic = [...seen].sort((a, b) => a - b);
  }

  displace(t, y, change) {
    if (typeof this.mechanism.coordinate_rates === "function") {
      this.state[0] = t;
      this.state.set(y, 1);
      this.state.set(change, 1 + this.nq);
      this.mechanism.coordinate_rates(this.precomputed, this.state, this.rates);
      for (let i = 0; i < this.nq; ++i) y[i] += this.rates[i];
      this.normalise(y);
    } else {
      for (let i = 0; i < this.nq; ++i) y[i] += change[i];
    }
  }

  /// What is kept is out of the problem: nothing couples with it.
  metric(kept) {
    const { nv } = this;
    if (this.mechanism.mass_matrix) {
      this.mechanism.mass_matrix(this.precomputed, this.state, this.mass);
      for (const i of kept) for (let j = 0; j < nv; ++j) this.mass[i * nv + j] = this.mass[j * nv + i] = i === j ? 1 : 0;
      const factor = cholesky(this.mass, nv);
      if (factor) return factor;
    }
    return Float64Array.from({ length: nv * nv }, (_, i) => (i % (nv + 1) === 0 ? 1 : 0));
  }

  largest(values, rows) {
    return rows.reduce((most, row) => Math.max(most, Math.abs(values[row]) / this.scale[row]), 0);
  }

  /// False where the constraints cannot be closed near y. Positions that go with the velocities at places of `kept.positions`
  /// stay as they are, and velocities at places of `kept.rates`.
  settle(t, y, kept = { positions: [], rates: [] }) {
    this.normalise(y);
    if (!this.m) return y.every(Number.isFinite);
    if (!this.holonomic) this.findHolonomic(t, y);
    if (!this.usual) this.findUsual(t, y);
    const { m, nv, nq, holonomic } = this, all = Array.from({ length: m }, (_, row) => row);
    const sizes = y.subarray(0, nq).reduce((most, value) => Math.max(most, Math.abs(value)), 1);
    const present = (rows) => rows.filter((row) => !this.vanishes[row]);
    if (!this.read(t, y)) return false;
    let before = Infinity;
    for (let round = 0; round < 40; ++round) {
      const open = this.largest(this.value, holonomic);
      if (open <= 1e-15 * sizes || (open >= before / 2 && open <= 1e-12 * sizes)) break;
      if (round > 20 && !(open < before)) return false;
      before = open;
      this.displace(t, y, leastChange(this.jacobian, m, nv, this.metric(kept.positions), present(holonomic), this.value.map((f) => -f), kept.positions));
      if (!this.read(t, y)) return false;
    }
    if (this.largest(this.value, holonomic) > 1e-9 * sizes) return false;
    for (let round = 0; round < 2; ++round) {
      const change = leastChange(this.jacobian, m, nv, this.metric(kept.rates), present(all), this.rate.map((rate) => -rate), kept.rates);
      for (let i = 0; i < nv; ++i) y[nq + i] += change[i];
      if (!this.read(t, y)) return false;
    }
    const speeds = y.subarray(nq).reduce((most, value) => Math.max(most, Math.abs(value)), 1);
    return this.largest(this.rate, all) <= 1e-9 * speeds;
  }
}

Object.assign(torsorReport, { Projection, cholesky });
})();
