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

  /// -dQ/dq by central differences, and by how much it fails to be symmetric.
  stiffness() {
    const rows = Array.from({ length: this.n }, () => new Float64Array(this.n));
    for (let j = 0; j < this.n; ++j) {
      const h = 1e-5 * (1 + Math.abs(this.q[j])), moved = Float64Array.from(this.q);
      moved[j] = this.q[j] + h;
      const after = this.forces(moved);
      moved[j] = this.q[j] - h;
      this.forces(moved).forEach((before, i) => { rows[i][j] = (before - after[i]) / (2 * h); });
    }
    let largest = 0, skew = 0;
    for (let i = 0; i < this.n; ++i) for (let j = 0; j <= i; ++j) {
      largest = Math.max(largest, Math.abs(rows[i][j]), Math.abs(rows[j][i]));
      skew = Math.max(skew, Math.abs(rows[i][j] - rows[j][i]));
      rows[i][j] = rows[j][i] = (rows[i][j] + rows[j][i]) / 2;
    }
    return { rows, skew: largest > 0 ? skew / largest : 0 };
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
    for (let tries = 0; tries < 60; ++tries) {
      const { rows, skew } = this.stiffness(), modes = this.pencil(rows), forces = this.forces(this.q);
      if (!modes || modes.some(({ square }) => !Number.isFinite(square))) {
        this.why = "«the masses are not positive there»";
        return;
      }
      const largest = Math.max(...modes.map(({ square }) => Math.abs(square)));
      const firm = modes.filter(({ square }) => Math.abs(square) > 1e-8 * largest);
      const step = new Float64Array(this.n);
      for (const { square, shape } of firm) {
        const along = shape.reduce((sum, value, i) => sum + value * forces[i], 0) / square;
        shape.forEach((value, i) => { step[i] += along * value; });
      }
      const length = Math.max(...step.map(Math.abs)), least = 1e-9 * (1 + Math.max(...this.q.map(Math.abs)));
      if (length < least) {
        const left = forces.map((force, i) => force - rows[i].reduce((sum, k, j) => sum + k * step[j], 0));
        if (Math.max(...left.map(Math.abs)) > 1e-6 * (1 + Math.max(...rows.map((row, i) => Math.abs(row[i]))))) break;
        if (skew > 1e-4) this.why = "«the forces there have no potential energy»";
        else this.modes = modes.map((mode) => ({ ...mode, neutral: !firm.includes(mode) }));
        return;
      }
      this.q.forEach((value, i) => { this.q[i] = value + step[i] * Math.min(1, 0.5 / length); });
    }
    this.why = "«no rest was found near this state»";
  }

  /// In words: its frequency, or how fast it leaves.
  static words({ square, neutral }) {
    if (neutral) return "«neutral: no force brings it back»";
    const rate = Math.sqrt(Math.abs(square));
    return square > 0 ? `${(rate / (2 * Math.PI)).toPrecision(4)} Hz (${rate.toPrecision(5)} rad/s)` : `«leaves the rest as exp(${rate.toPrecision(4)} t)»`;
  }
}

torsorReport.SmallMotions = SmallMotions;
})();
