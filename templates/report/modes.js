// SPDX-License-Identifier: MIT-0
// A rest near a state, and the small motions about it without damping and gyroscopic forces: K phi = omega^2 M phi.
(() => {
"use strict";
const { cholesky } = torsorReport;

/// Eigenvalues and eigenvectors of a symmetric matrix, a list of rows, by Jacobi's rotations.
function eigen(matrix) {
  const n = matrix.length, a = matrix.map((row) => Float64Array.from(row));
  const v = a.map((_, i) => Float64Array.from({ length: n }, (__, j) => (i === j ? 1 : 0)));
  for (let sweep = 0; sweep < 40; ++sweep) {
    let largest = 0;
    for (let p = 0; p < n; ++p) for (let q = p + 1; q < n; ++q) {
      const scale = Math.sqrt(Math.abs(a[p][p] * a[q][q])) + 1e-300;
      largest = Math.max(largest, Math.abs(a[p][q]) / scale);
      if (a[p][q] === 0) continue;
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]), c = Math.cos(angle), s = Math.sin(angle);
      for (let k = 0; k < n; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < n; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      for (let k = 0; k < n; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
    if (largest < 1e-15) break;
  }
  return a.map((row, i) => ({ value: row[i], vector: Float64Array.from({ length: n }, (_, k) => v[k][i]) }));
}

class SmallMotions {
  /// About a rest that Newton's method reaches from q; `why` says why there are none.
  constructor(motion, q) {
    Object.assign(this, { motion, n: motion.nv, q: Float64Array.from(q), modes: [], why: "" });
    const { mechanism } = motion;
    if (motion.recorded) this.why = "«the mechanism has contacts»";
    else if (mechanism.multipliers.length > 0) this.why = "«the mechanism has constraints»";
    else if (mechanism.quaternions.length > 0) this.why = "«an attitude is a quaternion»";
    else if (!mechanism.mass_matrix || !mechanism.forward_dynamics) this.why = "«the page has no mass matrix»";
    else if (mechanism.variesInTime) this.why = "«time enters its masses or its forces»";
    else this.search();
  }

  /// M(q), a list of rows.
  mass(q) {
    const { mechanism, precomputed } = this.motion, state = new Float64Array(mechanism.stateSize), columns = new Float64Array(this.n * this.n);
    state.set(q, 1);
    mechanism.mass_matrix(precomputed, state, columns);
    return Array.from({ length: this.n }, (_, i) => Float64Array.from({ length: this.n }, (__, j) => columns[j * this.n + i]));
  }
  accelerations(q) {
    const y = new Float64Array(2 * this.n), slope = new Float64Array(2 * this.n);
    y.set(q);
    this.motion.slope(0, y, slope);
    return slope.slice(this.n);
  }
  /// M q'' at rest: the forces.
  forces(q) {
    const a = this.accelerations(q);
    return Float64Array.from(this.mass(q), (row) => row.reduce((sum, m, j) => sum + m * a[j], 0));
  }

  /// A column of -dQ/dq: central differences over h, 2 h and 4 h, of which two extrapolations to zero tell what each may be off
  /// by, rounding of the forces apart. Of several h the best.
  column(j) {
    let best = null;
    for (const part of [1e-3, 1e-4, 1e-5, 1e-6]) {
      const h = part * (1 + Math.abs(this.q[j])), moved = Float64Array.from(this.q), sizes = new Float64Array(this.n);
      const [one, two, four] = [1, 2, 4].map((times) => {
        moved[j] = this.q[j] + times * h;
        const after = this.forces(moved);
        moved[j] = this.q[j] - times * h;
        const before = this.forces(moved);
        sizes.forEach((size, i) => { sizes[i] = Math.max(size, Math.abs(after[i]), Math.abs(before[i])); });
        return before.map((force, i) => (force - after[i]) / (2 * times * h));
      });
      const entries = one.map((slope, i) => (4 * slope - two[i]) / 3);
      const doubt = entries.map((entry, i) => Math.abs(entry - (4 * two[i] - four[i]) / 3) + 1e-15 * sizes[i] / h);
      const sum = doubt.reduce((all, each) => all + each, 0);
      if (!best || !(sum >= best.sum)) best = { entries, doubt, sum, h };
    }
    return best;
  }

  /// -dQ/dq: the symmetric part, what each entry may be off by, and whether the rest is a part of the forces that has no
  /// potential energy.
  stiffness() {
    const { n } = this, columns = Array.from({ length: n }, (_, j) => this.column(j));
    const rows = columns.map((_, i) => Float64Array.from(columns, ({ entries }) => entries[i]));
    const reach = 1 + Math.max(...this.q.map(Math.abs));
    // Forces are sums, of what a stiffness makes of the coordinates.
    const terms = rows.map((row) => 1e-15 * reach * row.reduce((sum, k) => sum + Math.abs(k), 0));
    const doubt = columns.map((_, i) => Float64Array.from(columns, (column) => column.doubt[i] + terms[i] / column.h));
    let skew = false;
    for (let i = 0; i < n; ++i) for (let j = 0; j < i; ++j) {
      const apart = Math.abs(rows[i][j] - rows[j][i]), off = doubt[i][j] + doubt[j][i];
      const size = Math.abs(rows[i][j]) + Math.abs(rows[j][i]) + Math.min(Math.abs(rows[i][i]), Math.abs(rows[j][j]));
      skew ||= apart > 1e-4 * size + 4 * off;
      rows[i][j] = rows[j][i] = (rows[i][j] + rows[j][i]) / 2;
      doubt[i][j] = doubt[j][i] = off / 2;
    }
    return { rows, doubt, skew };
  }

  /// K phi = omega^2 M phi with phi' M phi = 1.
  pencil(K) {
    const { n } = this, columns = new Float64Array(n * n), M = this.mass(this.q);
    M.forEach((row, i) => row.forEach((m, j) => { columns[j * n + i] = m; }));
    const L = cholesky(columns, n);
    if (!L) return null;
    const forward = (b) => {  // L^-1 b
      const x = Float64Array.from(b);
      for (let i = 0; i < n; ++i) {
        for (let k = 0; k < i; ++k) x[i] -= L[k * n + i] * x[k];
        x[i] /= L[i * n + i];
      }
      return x;
    };
    const rows = K.map(forward);  // K L^-T, row by row
    const reduced = Array.from({ length: n }, (_, j) => forward(rows.map((row) => row[j])));
    return eigen(reduced).map(({ value, vector }) => {
      const shape = Float64Array.from(vector);
      for (let i = n - 1; i >= 0; --i) {
        for (let k = i + 1; k < n; ++k) shape[i] -= L[i * n + k] * shape[k];
        shape[i] /= L[i * n + i];
      }
      return { square: value, shape };
    }).sort((a, b) => a.square - b.square);
  }

  search() {
    // sum |x_i k_ij x_j|
    const form = (rows, x) => rows.reduce((sum, row, i) =>
      sum + Math.abs(x[i]) * row.reduce((all, k, j) => all + Math.abs(k * x[j]), 0), 0);
    let near = false;
    for (let tries = 0; tries < 60; ++tries) {
      const { rows, doubt, skew } = this.stiffness(), modes = this.pencil(rows), forces = this.forces(this.q);
      if (!modes || modes.some(({ square }) => !Number.isFinite(square))) {
        this.why = "«the masses are not positive there»";
        return;
      }
      const largest = Math.max(...modes.map(({ square }) => Math.abs(square))), far = 1 + Math.max(...this.q.map(Math.abs));
      const along = ({ shape }) => shape.reduce((sum, value, i) => sum + value * forces[i], 0);
      const rounding = ({ shape }) => 1e-12 * far * shape.reduce((sum, value, i) =>
        sum + Math.abs(value) * rows[i].reduce((all, k) => all + Math.abs(k), 0), 0);
      // A mode is neutral where its square is no more than it may be off by, whatever the others are: a rod may be stiff. One
      // that a force pulls along is none.
      const step = new Float64Array(this.n);
      let falls = false;
      for (const mode of modes) {
        const pulled = Math.abs(along(mode)) > rounding(mode) + 1e-9;
        mode.off = 2 * form(doubt, mode.shape) + 1e-15 * largest;
        const flat = Math.abs(mode.square) <= mode.off;
        mode.neutral = flat && !pulled;
        falls ||= flat && pulled && Math.abs(mode.square) <= 1e-15 * largest;
        if (!mode.neutral && mode.square !== 0) mode.shape.forEach((value, i) => { step[i] += along(mode) / mode.square * value; });
      }
      const length = Math.max(...step.map(Math.abs));
      const there = near;
      near = length < 1e-9 * far;
      if (near && there) {  // one step more than that: of a stiff rod 1e-9 is much
        if (falls) break;
        if (skew) this.why = "«the forces there have no potential energy»";
        else this.modes = modes;
        return;
      }
      this.q.forEach((value, i) => { this.q[i] = value + step[i] * Math.min(1, 0.5 / length); });
    }
    this.why = "«no rest was found near this state»";
  }

  /// In words: its frequency, or how fast it leaves, in digits that are known.
  static words({ square, neutral, off = 0 }) {
    if (neutral) return "«neutral: no force brings it back»";
    const rate = Math.sqrt(Math.abs(square)), known = Math.floor(-Math.log10(off / Math.abs(square)));
    const digits = Math.max(1, Math.min(4, known)), written = (number, more) => number.toPrecision(Math.min(digits + more, 5));
    return square > 0 ? `${written(rate / (2 * Math.PI), 0)} Hz (${written(rate, 1)} rad/s)` : `«leaves the rest as exp(${written(rate, 0)} t)»`;
  }
}

torsorReport.SmallMotions = SmallMotions;
})();
