// SPDX-License-Identifier: MIT-0
// Bodies that touch a plane as triangles: boxes by their corners, convex bodies and tori by points of their surfaces.
(() => {
"use strict";
const { add, scaled, dot, length } = torsorReport.vectors;

/// Triangles, each corner with its normal, of a grid of places; `closed` where the last row is beside the first.
function triangles(rows, columns, place, normal, closed) {
  const corners = [];
  const corner = (i, k) => [...place(i % rows, k % columns), ...normal(i % rows, k % columns)];
  for (let i = 0; i + (closed ? 0 : 1) < rows; ++i) {
    for (let k = 0; k < columns; ++k) {
      const [a, b, c, d] = [corner(i, k), corner(i, k + 1), corner(i + 1, k + 1), corner(i + 1, k)];
      corners.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  }
  return new Float32Array(corners);
}

/// A convex body by its places with given normals, from pole to pole; `lines` are four of its meridians and its equator.
function convex({ rows, columns, places }) {
  const place = (i, k) => places.slice(3 * (i * columns + (k % columns)), 3 * (i * columns + (k % columns)) + 3);
  const normal = (i, k) => {
    const latitude = Math.PI * (i / (rows - 1) - 0.5), longitude = (2 * Math.PI * k) / columns;
    return [Math.cos(latitude) * Math.cos(longitude), Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude)];
  };
  const along = (count, at) => Array.from({ length: count }, (_, i) => scaled(at(i), 1.005));
  const lines = [0, 1, 2, 3].map((quarter) => along(rows, (i) => place(i, (quarter * columns) / 4)));
  lines.push(along(columns + 1, (k) => place((rows - 1) / 2, k)));
  return { corners: triangles(rows, columns, place, normal, false), lines, extent: Math.max(...places.map(Math.abs)) };
}

/// A torus about z: a circle of the radius with a tube around it.
function torus(radius, tube) {
  const rows = 16, columns = 40;
  const normal = (i, k) => {
    const [a, b] = [(2 * Math.PI * i) / rows, (2 * Math.PI * k) / columns];
    return [Math.cos(a) * Math.cos(b), Math.cos(a) * Math.sin(b), Math.sin(a)];
  };
  const place = (i, k) => {
    const b = (2 * Math.PI * k) / columns;
    return add([radius * Math.cos(b), radius * Math.sin(b), 0], normal(i, k), tube);
  };
  return { corners: triangles(rows, columns, place, normal, true), lines: [], extent: radius + tube };
}

/// The box between corners, in a frame with these axes; what has no thickness gets the least one.
function boxAround(places, axes, least) {
  const middle = scaled(places.reduce((sum, place) => add(sum, place)), 1 / places.length);
  const [x, y, z] = axes.map((axis) => scaled(axis, Math.max(least, ...places.map((place) => Math.abs(dot(add(place, middle, -1), axis)))) / (length(axis) || 1)));
  return { mesh: "box", x, y, z, origin: middle };
}

torsorReport.surfaces = { convex, torus, boxAround };
})();
