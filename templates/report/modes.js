// SPDX-License-Identifier: MIT-0
// A rest near a state, and the small motions about it without damping and gyroscopic forces: K phi = omega^2 M phi, on the
// constraints Z' K Z and Z' M Z, A Z = 0. There M q'' = Q + A' lambda, and Z' takes away what lambda changes by.
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

/// Directions x with A x = 0 for the rows given, where x_j is measured in scale_j, and the rank of A: by Gauss-Jordan
/// elimination, the largest pivot of all first.
function nullSpace(rows, scale) {
  const n = scale.length, left = rows.map((row) => {
    const own = Float64Array.from(row, (value, j) => value * scale[j]), length = Math.hypot(...own);
    return own.map((value) => (length > 0 ? value / length : 0));
  }), pivots = [];
  for (;;) {
    let best = { size: 1e-10 };
    left.forEach((row, i) => {
      if (pivots.some((pivot) => pivot.i === i)) return;
      row.forEach((value, j) => { if (Math.abs(value) > best.size) best = { size: Math.abs(value), i, j }; });
    });
    if (best.i === undefined) break;
    const { i, j } = best, divisor = left[i][j];
    left[i] = left[i].map((value) => value / divisor);
    left.forEach((row, k) => {
      const share = row[j];
      if (k !== i && share !== 0) row.forEach((_, l) => { row[l] = l === j ? 0 : row[l] - share * left[i][l]; });
    });
    pivots.push(best);
  }
  const columns = [];
  for (let free = 0; free < n; ++free) {
    if (pivots.some(({ j }) => j === free)) continue;
    const column = new Float64Array(n);
    column[free] = scale[free];
    for (const { i, j } of pivots) column[j] = -left[i][free] * scale[j];
    columns.push(column);
  }
  return { columns, rank: pivots.length };
}

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
/// Z' X Z of the columns of Z.
const within = (columns, rows) => columns.map((z) => Float64Array.from(columns, (w) => dot(z, rows.map((row) => dot(row, w)))));
const sizesOf = (rows) => rows.map((row) => row.map(Math.abs));

class SmallMotions {
  /// About a rest that Newton's method reaches from q; `why` says why there are none. Constraints on velocities alone let the
  /// mechanism rest at neighbouring places: `zeroRoots` of them, beside the modes.
  constructor(motion, q) {
    Object.assign(this, { motion, n: motion.nv, q: Float64Array.from(q), modes: [], why: "", zeroRoots: 0 });
    const { mechanism } = motion;
    this.constrained = mechanism.multipliers.length > 0;
    if (motion.recorded) this.why = "«the mechanism has contacts»";
    else if (this.n > 12) this.why = "«it has more than 12 coordinates»";
    else if (!mechanism.mass_matrix || !mechanism.forward_dynamics) this.why = "«its accelerations are not determined»";
    else if (mechanism.variesInTime) this.why = "«time enters its masses or its forces»";
    else if (mechanism.rubsAtRest) this.why = "«friction of its constraints has no direction at rest»";
    else this.search();
  }

  /// Coordinates that are moved by small deviations, of an attitude turns about its moving axes.
  displaced(q, change) {
    const y = new Float64Array(this.motion.nq + this.n);
    y.set(q);
    this.motion.projection.displace(0, y, change);
    return y;
  }
  /// The state that a deviation from the rest leads to, on the constraints where these can be closed.
  posed(shape) {
    const open = this.displaced(this.q, shape), y = Float64Array.from(open);
    return this.motion.projection.settle(0, y) ? y : open;
  }
  /// Puts q onto the constraints; false where they cannot be closed, or keep the mechanism moving.
  stand() {
    const { motion } = this, y = new Float64Array(motion.nq + this.n);
    y.set(this.q);
    if (!motion.projection.settle(0, y)) return this.fail("«the constraints cannot be closed near this state»");
    if (y.subarray(motion.nq).some((rate) => rate !== 0)) return this.fail("«the constraints keep it moving»");
    this.q = y.slice(0, motion.nq);
    return true;
  }
  fail(why) {
    this.why = why;
    return false;
  }
  /// Rows of A at the state that was read last.
  jacobian(rows) {
    const { jacobian, m, vanishes } = this.motion.projection;
    return rows.filter((row) => !vanishes[row]).map((row) => Float64Array.from({ length: this.n }, (_, j) => jacobian[j * m + row]));
  }
  /// Directions of motion at q, columns of Z; all of them without constraints.
  directions() {
    const { n, motion: { projection } } = this, unit = (j) => Float64Array.from({ length: n }, (_, i) => (i === j ? 1 : 0));
    if (!this.constrained) return Array.from({ length: n }, (_, j) => unit(j));
    this.read(this.q);
    const scale = this.mass(this.q).map((row, i) => (row[i] > 0 ? 1 / Math.sqrt(row[i]) : 1));
    const all = nullSpace(this.jacobian(Array.from({ length: projection.m }, (_, row) => row)), scale);
    this.zeroRoots = all.rank - nullSpace(this.jacobian(projection.holonomic), scale).rank;
    return all.columns;
  }
  read(q) {
    const y = new Float64Array(this.motion.nq + this.n);
    y.set(q);
    this.motion.projection.read(0, y);
  }

  /// M(q), a list of rows.
  mass(q) {
    const { mechanism, precomputed } = this.motion, state = new Float64Array(mechanism.stateSize), columns = new Float64Array(this.n * this.n);
    state.set(q, 1);
    mechanism.mass_matrix(precomputed, state, columns);
    return Array.from({ length: this.n }, (_, i) => Float64Array.from({ length: this.n }, (__, j) => columns[j * this.n + i]));
  }
  /// M q'' at rest, or at rates v: the forces, those of constraints among them.
  forces(q, v = null) {
    const { motion, n } = this, y = new Float64Array(motion.nq + n), slope = new Float64Array(motion.nq + n);
    y.set(q);
    if (v) y.set(v, motion.nq);
    if (!motion.slope(0, y, slope)) return new Float64Array(n).fill(NaN);
    const a = slope.slice(motion.nq);
    return Float64Array.from(this.mass(q), (row) => dot(row, a));
  }

  /// A column of -dQ/dq: central differences over h, 2 h and 4 h, of which two extrapolations to zero tell what each may be off
  /// by, rounding of the forces apart. Of several h the best.
  column(j) {
    const turns = this.motion.mechanism.quaternions.length > 0;
    let best = null;
    for (const part of [1e-3, 1e-4, 1e-5, 1e-6]) {
      const h = part * (1 + Math.abs(turns ? 0 : this.q[j])), sizes = new Float64Array(this.n);
      const moved = (by) => this.displaced(this.q, Float64Array.from({ length: this.n }, (_, i) => (i === j ? by : 0))).slice(0, this.motion.nq);
      const [one, two, four] = [1, 2, 4].map((times) => {
        const after = this.forces(moved(times * h)), before = this.forces(moved(-times * h));
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

  /// -dQ/dq along Z: the symmetric part, what each entry may be off by, and whether the rest is a part of the forces that has no
  /// potential energy.
  stiffness(directions, mass) {
    const columns = Array.from({ length: this.n }, (_, j) => this.column(j));
    let rows = columns.map((_, i) => Float64Array.from(columns, ({ entries }) => entries[i]));
    const reach = 1 + Math.max(...this.q.map(Math.abs));
    // Forces are sums, of what a stiffness makes of the coordinates.
    const terms = rows.map((row) => 1e-15 * reach * row.reduce((sum, k) => sum + Math.abs(k), 0));
    let doubt = columns.map((_, i) => Float64Array.from(columns, (column) => column.doubt[i] + terms[i] / column.h));
    if (this.constrained) {
      const sizes = sizesOf(directions), sums = within(sizes, sizesOf(rows));
      doubt = within(sizes, doubt).map((row, i) => row.map((off, j) => off + 1e-15 * sums[i][j]));
      rows = within(directions, rows);
    }
    const n = rows.length, size = (i, j) => Math.sqrt(mass[i][i] * mass[j][j]);
    // Multipliers are rounded as the largest of the forces are.
    const largest = !this.constrained ? 0 : Math.max(...rows.map((row, i) => Math.max(...row.map((k, j) => Math.abs(k) / size(i, j)))));
    let skew = false;
    for (let i = 0; i < n; ++i) for (let j = 0; j < i; ++j) {
      const apart = Math.abs(rows[i][j] - rows[j][i]), off = doubt[i][j] + doubt[j][i];
      const both = Math.abs(rows[i][j]) + Math.abs(rows[j][i]) + Math.min(Math.abs(rows[i][i]), Math.abs(rows[j][j]));
      skew ||= apart > 1e-4 * both + 4 * off + 1e-9 * largest * size(i, j);
      rows[i][j] = rows[j][i] = (rows[i][j] + rows[j][i]) / 2;
      doubt[i][j] = doubt[j][i] = off / 2;
    }
    // What couples motions that are neutral by rounding alone would mix them.
    rows.forEach((row, i) => row.forEach((k, j) => { if (Math.abs(k) <= 1e-15 * largest * size(i, j)) row[j] = 0; }));
    return { rows, doubt, skew };
  }

  /// K phi = omega^2 M phi with phi' M phi = 1.
  pencil(K, M) {
    const n = K.length, columns = new Float64Array(n * n);
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
      if (!this.stand()) return;
      const directions = this.directions();
      if (directions.length === 0) return void this.fail("«the constraints leave no motion»");
      const all = this.forces(this.q), forces = directions.map((z) => dot(z, all));
      const mass = within(directions, this.mass(this.q)), { rows, doubt, skew } = this.stiffness(directions, mass);
      const modes = this.pencil(rows, mass);
      if (!modes || modes.some(({ square }) => !Number.isFinite(square))) {
        return void this.fail(this.constrained ? "«its accelerations there are not determined»" : "«the masses are not positive there»");
      }
      const largest = Math.max(...modes.map(({ square }) => Math.abs(square))), far = 1 + Math.max(...this.q.map(Math.abs));
      const along = ({ shape }) => dot(shape, forces);
      const rounding = ({ shape }) => 1e-12 * far * shape.reduce((sum, value, i) =>
        sum + Math.abs(value) * rows[i].reduce((all, k) => all + Math.abs(k), 0), 0);
      // A mode is neutral where its square is no more than it may be off by, whatever the others are: a rod may be stiff. One
      // that a force pulls along is none.
      const step = new Float64Array(directions.length);
      let falls = false;
      for (const mode of modes) {
        const pulled = Math.abs(along(mode)) > rounding(mode) + 1e-9;
        mode.off = 2 * form(doubt, mode.shape) + 1e-15 * largest;
        const flat = Math.abs(mode.square) <= mode.off;
        mode.neutral = flat && !pulled;
        falls ||= flat && pulled && Math.abs(mode.square) <= 1e-15 * largest;
        if (!mode.neutral && mode.square !== 0) mode.shape.forEach((value, i) => { step[i] += along(mode) / mode.square * value; });
      }
      const whole = (shape) => Float64Array.from({ length: this.n }, (_, i) => dot(shape, directions.map((z) => z[i])));
      const change = whole(step), length = Math.max(...change.map(Math.abs));
      const there = near;
      near = length < 1e-9 * far;
      if (near && there) {  // one step more than that: of a stiff rod 1e-9 is much
        if (falls) break;
        if (skew) {
          return void this.fail(this.zeroRoots ? "«constraints on velocities act there by forces that have no potential energy»"
                                               : "«the forces there have no potential energy»");
        }
        this.modes = modes.map((mode) => ({ ...mode, shape: whole(mode.shape) }));
        this.modes.forEach((mode) => { mode.damping = this.dampingOf(mode); });
        return;
      }
      this.q = this.displaced(this.q, change.map((value) => value * Math.min(1, 0.5 / length))).slice(0, this.motion.nq);
    }
    this.why = "«no rest was found near this state»";
  }

  /// phi' C phi / (2 omega): the damping ratio where damping does not couple modes, and to first order in it. 0 without damping,
  /// and where forces jump with the sense of the motion.
  dampingOf({ square, neutral, shape }) {
    if (neutral || !(square > 0)) return 0;
    const rate = Math.sqrt(square), [coarse, fine] = [1e-3, 1e-4].map((part) => {
      const size = part / Math.max(...shape.map(Math.abs)), v = shape.map((value) => size * value);
      const [after, before] = [v, v.map((value) => -value)].map((each) => dot(shape, this.forces(this.q, each)));
      return (before - after) / (2 * size) / (2 * rate);
    });
    return Math.abs(fine) > 1e-6 && Math.abs(coarse - fine) < 1e-3 * Math.abs(fine) ? fine : 0;
  }

  /// In words: its frequency, or how fast it leaves, in digits that are known.
  static words({ square, neutral, off = 0, damping = 0 }) {
    if (neutral) return "«neutral: no force brings it back»";
    const rate = Math.sqrt(Math.abs(square)), known = Math.floor(-Math.log10(off / Math.abs(square)));
    const digits = Math.max(1, Math.min(4, known)), written = (number, more) => number.toPrecision(Math.min(digits + more, 5));
    if (!(square > 0)) return `«leaves the rest as exp(${written(rate, 0)} t)»`;
    if (damping >= 1) return `«does not swing, comes back slowly; damping ratio ${damping.toPrecision(3)}»`;
    const swings = `${written(rate / (2 * Math.PI), 0)} Hz (${written(rate, 1)} rad/s)`;
    return damping === 0 ? swings : `${swings}«, damping ratio ${damping.toPrecision(3)}»`;
  }
}

torsorReport.SmallMotions = SmallMotions;
})();
