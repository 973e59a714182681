// SPDX-License-Identifier: MIT-0
// Vectors of three components, matrices of four columns for WebGL, principal axes.
(() => {
"use strict";
const add = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const scaled = (a, k) => [k * a[0], k * a[1], k * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a, other = [0, 0, 1]) => (length(a) > 0 ? scaled(a, 1 / length(a)) : other);

/// Two unit vectors that make a right-handed triad with a third, (x, y, axis).
function triad(axis) {
  const z = unit(axis), least = Math.abs(z[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const x = unit(cross(least, z));
  return [x, cross(z, x), z];
}

/// The affine map with these images of the unit vectors and of the origin.
const affine = (x, y, z, origin) =>
  new Float32Array([...x, 0, ...y, 0, ...z, 0, ...origin, 1]);

function product(a, b) {
  const c = new Float32Array(16);
  for (let j = 0; j < 4; ++j) for (let i = 0; i < 4; ++i) for (let k = 0; k < 4; ++k) c[4 * j + i] += a[4 * k + i] * b[4 * j + k];
  return c;
}

/// What a camera at `eye` that looks at `target` sees, `up` upwards.
function looking(eye, target, up) {
  const z = unit(add(eye, target, -1)), x = unit(cross(up, z), [1, 0, 0]), y = cross(z, x);
  return new Float32Array([x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0,
                           -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
}

function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2);
  return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1,
                           0, 0, (2 * far * near) / (near - far), 0]);
}

/// Eigenvalues and unit eigenvectors of a symmetric matrix by Jacobi's rotations.
function principal([xx, yy, zz, xy, xz, yz]) {
  const a = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], v = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (let sweep = 0; sweep < 20; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (Math.abs(a[p][q]) <= 1e-15 * (Math.abs(a[p][p]) + Math.abs(a[q][q]))) continue;
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]), c = Math.cos(angle), s = Math.sin(angle);
      for (let k = 0; k < 3; ++k) [a[k][p], a[k][q]] = [c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]];
      for (let k = 0; k < 3; ++k) [a[p][k], a[q][k]] = [c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]];
      for (let k = 0; k < 3; ++k) [v[k][p], v[k][q]] = [c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]];
    }
  }
  const axes = [0, 1, 2].map((j) => [v[0][j], v[1][j], v[2][j]]);
  if (dot(cross(axes[0], axes[1]), axes[2]) < 0) axes[2] = scaled(axes[2], -1);
  return { values: [a[0][0], a[1][1], a[2][2]], axes };
}

/// The k-th of the vectors that stand one after the other.
const column = (member, k) => [member[3 * k], member[3 * k + 1], member[3 * k + 2]];

torsorReport.vectors = { add, column, scaled, dot, cross, length, unit, triad, affine, product, looking, perspective, principal };
})();
