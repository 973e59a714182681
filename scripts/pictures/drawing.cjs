// SPDX-License-Identifier: GPL-3.0-or-later
// Line drawings of mechanisms as SVG: solids, arrows, turns and labels in space, seen from one side; what is drawn later lies in
// front. The first of two bodies has the class "a" (grey), the second "b" (blue), what moves "m" (red), what acts "f" (green).
const width = 230, height = 150, azimuth = 0.55, elevation = 0.45;
const right = [-Math.sin(azimuth), Math.cos(azimuth), 0];
const up = [-Math.sin(elevation) * Math.cos(azimuth), -Math.sin(elevation) * Math.sin(azimuth), Math.cos(elevation)];
const towards = [Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation)];

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sum = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const times = (k, a) => [k * a[0], k * a[1], k * a[2]];
const less = (a, b) => sum(a, times(-1, b));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / Math.hypot(...a), a);
/// Two directions across one: with it they are right-handed.
function across(axis) {
  const n = unit(axis), u = unit(Math.abs(n[2]) > 0.9 ? cross([0, 1, 0], n) : cross([0, 0, 1], n));
  return [u, cross(n, u)];
}
/// The convex hull of points of the plane.
function hull_of(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (all) => {
    const chain = [];
    for (const p of all) {
      while (chain.length > 1) {
        const [a, b] = chain.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

class Drawing {
  constructor({ scale = 42, at = [115, 85] } = {}) {
    this.scale = scale;
    this.at = at;
    this.parts = [];
  }
  flat(p) { return [this.at[0] + this.scale * dot(p, right), this.at[1] - this.scale * dot(p, up)]; }
  static number(x) { return (Math.round(10 * x) / 10 + 0).toString(); }
  static pairs(points) { return points.map((p) => p.map(Drawing.number).join(" ")).join(" "); }
  shape(points, kind) { this.parts.push(`<path class="${kind}" d="M${Drawing.pairs(points)}z"/>`); return this; }
  curve(points, kind) { this.parts.push(`<path class="${kind} o" d="M${Drawing.pairs(points)}"/>`); return this; }

  line(p, q, kind = "t") { return this.curve([this.flat(p), this.flat(q)], kind); }
  path(points, kind = "t") { return this.curve(points.map((p) => this.flat(p)), kind); }
  polygon(points, kind) { return this.shape(points.map((p) => this.flat(p)), kind); }
  hull(points, kind) { return this.shape(hull_of(points.map((p) => this.flat(p))), kind); }
  circle_points(centre, axis, radius, from = 0, to = 2 * Math.PI, count = 36) {
    const [u, v] = across(axis);
    return Array.from({ length: count + 1 }, (_, i) => {
      const a = from + (to - from) * i / count;
      return sum(centre, sum(times(radius * Math.cos(a), u), times(radius * Math.sin(a), v)));
    });
  }
  circle(centre, axis, radius, kind = "t") { return this.path(this.circle_points(centre, axis, radius), kind); }
  disc(centre, axis, radius, kind) { return this.polygon(this.circle_points(centre, axis, radius), kind); }
  cylinder(p, q, radius, kind, end = radius) {
    const axis = less(q, p), near = dot(axis, towards) > 0;
    this.hull([...this.circle_points(p, axis, radius), ...this.circle_points(q, axis, end)], kind);
    if (near ? end : radius) this.disc(near ? q : p, axis, near ? end : radius, kind);
    return this;
  }
  tube(p, q, radius, inner, kind) {
    const axis = less(q, p), end = dot(axis, towards) > 0 ? q : p;
    return this.cylinder(p, q, radius, kind).disc(end, axis, inner, "h");
  }
  cone(base, tip, radius, kind) { return this.cylinder(base, tip, radius, kind, 0); }
  sphere(centre, radius, kind) {
    const [x, y] = this.flat(centre).map(Drawing.number), r = Drawing.number(radius * this.scale);
    this.parts.push(`<circle class="${kind}" cx="${x}" cy="${y}" r="${r}"/>`);
    const begin = Math.atan2(...((w) => [dot(towards, w[1]), dot(towards, w[0])])(across([0, 0, 1]))) - Math.PI / 2;
    return this.path(this.circle_points(centre, [0, 0, 1], radius, begin, begin + Math.PI, 20), kind + " n");
  }
  /// A body with an outline from a map of the unit sphere.
  blob(map, kind) {
    const points = [];
    for (let i = 0; i <= 16; ++i) for (let k = 0; k < 32; ++k) {
      const t = Math.PI * i / 16, f = Math.PI * k / 16;
      points.push(map([Math.sin(t) * Math.cos(f), Math.sin(t) * Math.sin(f), Math.cos(t)]));
    }
    return this.hull(points, kind);
  }
  ellipsoid(centre, [a, b, c], kind) { return this.blob((u) => sum(centre, [a * u[0], b * u[1], c * u[2]]), kind); }
  /// Edges 2 a along `axes`, which are x, y and z when absent.
  box(centre, half, kind, axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
    for (let i = 0; i < 3; ++i) {
      const n = dot(axes[i], towards) > 0 ? 1 : -1, [j, k] = [(i + 1) % 3, (i + 2) % 3];
      const corner = (a, b) => sum(centre, sum(times(n * half[i], axes[i]), sum(times(a * half[j], axes[j]),
        times(b * half[k], axes[k]))));
      this.polygon([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], kind);
    }
    return this;
  }
  /// A piece of the plane z = height, or of another one.
  plane(centre, a, b, kind = "a", u = [1, 0, 0], v = [0, 1, 0]) {
    const corner = (s, t) => sum(centre, sum(times(s * a, u), times(t * b, v)));
    return this.polygon([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], kind);
  }
  /// The ground as hatching below a line.
  ground(centre, half = 0.5, along = [0, 1, 0]) {
    const [p, q] = [sum(centre, times(-half, along)), sum(centre, times(half, along))].map((each) => this.flat(each));
    this.curve([p, q], "a");
    for (let i = 0; i < 6; ++i) {
      const s = (i + 0.7) / 6, x = p[0] + s * (q[0] - p[0]), y = p[1] + s * (q[1] - p[1]);
      this.curve([[x, y], [x - 5, y + 6]], "t");
    }
    return this;
  }
  /// A round bar through points.
  rod(points, kind, thick = 7) {
    const d = "M" + Drawing.pairs(points.map((p) => this.flat(p)));
    const path = (part, wide) => `<path class="${kind}${part} o" style="stroke-width:${wide}" d="${d}"/>`;
    this.parts.push(path("e", thick) + path("i", thick - 2.6));
    return this;
  }
  /// A ring about an axis: a circle with a tube around it.
  ring(centre, axis, radius, kind, thick = 9) { return this.rod([...this.circle_points(centre, axis, radius),
    this.circle_points(centre, axis, radius)[1]], kind, thick); }
  spring(p, q, kind = "f", turns = 7, radius = 6) {
    const [a, b] = [this.flat(p), this.flat(q)], d = [b[0] - a[0], b[1] - a[1]], n = [-d[1],
      d[0]].map((x) => x / Math.hypot(...d));
    const points = [a];
    for (let i = 0; i <= 2 * turns; ++i) {
      const s = 0.15 + 0.7 * i / (2 * turns), side = i === 0 || i === 2 * turns ? 0 : (i % 2 ? 1 : -1) * radius;
      points.push([a[0] + s * d[0] + side * n[0], a[1] + s * d[1] + side * n[1]]);
    }
    return this.curve([...points, b], kind);
  }
  damper(p, q, kind = "f") {
    const [a, b] = [this.flat(p), this.flat(q)], d = [b[0] - a[0], b[1] - a[1]], n = [-d[1],
      d[0]].map((x) => 7 * x / Math.hypot(...d));
    const point = (s, side) => [a[0] + s * d[0] + side * n[0], a[1] + s * d[1] + side * n[1]];
    this.curve([a, point(0.35, 0)], kind).curve([point(0.68, 1), point(0.35, 1), point(0.35, -1), point(0.68, -1)], kind);
    return this.curve([point(0.55, 0.8), point(0.55, -0.8)], kind).curve([point(0.55, 0), b], kind);
  }
  head(tip, from, kind) {
    const d = unit([tip[0] - from[0], tip[1] - from[1], 0]), n = [-d[1], d[0]];
    return this.shape([tip, [tip[0] - 8 * d[0] + 3.4 * n[0], tip[1] - 8 * d[1] + 3.4 * n[1]],
      [tip[0] - 8 * d[0] - 3.4 * n[0], tip[1] - 8 * d[1] - 3.4 * n[1]]], kind + "h");
  }
  arrow(p, q, kind, text, shift) {
    const [a, b] = [this.flat(p), this.flat(q)], d = unit([b[0] - a[0], b[1] - a[1], 0]);
    this.curve([a, [b[0] - 6 * d[0], b[1] - 6 * d[1]]], kind).head(b, a, kind);
    return text ? this.text(text, q, shift ?? [d[0] * 9 + (d[0] < -0.5 ? -2 : 0), d[1] * 9 + 4], kind + "x") : this;
  }
  /// An arrow at both ends.
  both(p, q, kind, text, shift = [0, -6]) {
    const middle = times(0.5, sum(p, q));
    this.arrow(middle, q, kind).arrow(middle, p, kind);
    return text ? this.text(text, middle, shift, kind + "x") : this;
  }
  /// A turn about an axis: an arc with an arrow.
  turn(centre, axis, radius, from, to, kind, text, shift = [8, 4]) {
    const points = this.circle_points(centre, axis, radius, from, to, 24).map((p) => this.flat(p));
    this.curve(points.slice(0, -2), kind).head(points[24], points[21], kind);
    return text ? this.text(text, this.circle_points(centre, axis, radius, from, to, 24)[24], shift, kind + "x") : this;
  }
  /// A line with its length.
  measure(p, q, text, shift = [0, -5]) {
    return this.both(p, q, "t", undefined).text(text, times(0.5, sum(p, q)), shift, "tx");
  }
  axes(origin, length, kind = "t", names = ["x", "y", "z"], frame = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
    frame.forEach((e, i) => this.arrow(origin, sum(origin, times(length, e)), kind, names[i]));
    return this;
  }
  axis(p, q, text, shift = [8, 4]) {
    this.line(p, q, "c");
    return text ? this.text(text, q, shift, "tx") : this;
  }
  point(p, text, shift = [7, -5]) {
    const [x, y] = this.flat(p).map(Drawing.number);
    this.parts.push(`<circle class="p" cx="${x}" cy="${y}" r="2.6"/>`);
    return text ? this.text(text, p, shift) : this;
  }
  /// A text at a place, moved on paper; "_" puts a single letter that follows lower.
  text(text, p, [dx, dy] = [0, 0], kind = "x") {
    const [x, y] = this.flat(p);
    const escaped = text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
    const set = escaped.replace(/_(\w)\b/g, '<tspan dy="3" font-size="9">$1</tspan><tspan dy="-3"> </tspan>')
      .replace(/<tspan dy="-3"> <\/tspan>$/, "");
    this.parts.push(`<text class="${kind}" x="${Drawing.number(x + dx)}" y="${Drawing.number(y + dy)}">${set}</text>`);
    return this;
  }

  svg(title) {
    const drawn = this.parts.join("\n"), escaped = title.replace(/&/g, "&amp;").replace(/</g, "&lt;");
    const size = `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size} role="img">
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Drawn by scripts/scene_reference. -->
<title>${escaped}</title>
<style>${style}</style>
<rect class="w" x=".5" y=".5" width="${width - 1}" height="${height - 1}" rx="6"/>
${drawn}
</svg>
`;
  }
}

/// Rules of colours: of bodies their edge "e" and inside "i"; "h" is the head of an arrow, "x" the text that belongs to it.
function colours({ edge, fill, body, face, moves, acts, thin, words, paper, hole }) {
  return [
    `.a{stroke:${edge};fill:${fill}}.ae{stroke:${edge}}.ai{stroke:${fill}}.ah,.ax{fill:${edge}}`,
    `.b{stroke:${body};fill:${face}}.be{stroke:${body}}.bi{stroke:${face}}.bh,.bx{fill:${body}}`,
    `.m{stroke:${moves}}.mh,.mx{fill:${moves}}.f{stroke:${acts}}.fh,.fx{fill:${acts}}`,
    `.t,.c{stroke:${thin}}.th,.tx{fill:${thin}}.p,.x{fill:${words}}.h{stroke:${body};fill:${hole}}`,
    `.w{fill:${paper};stroke:${hole}}.we{stroke:${thin}}.wi{stroke:${paper}}text{stroke:${paper}}`,
    ".o,.n{fill:none}.p,.ah,.bh,.mh,.fh,.th{stroke:none}",
  ].join("");
}
const light = { edge: "#475569", fill: "#dbe1e8", body: "#1d4ed8", face: "#bfdbfe", moves: "#c81e1e", acts: "#047857",
  thin: "#64748b", words: "#0f172a", paper: "#ffffff", hole: "#94a3b8" };
const dark = { edge: "#cbd5e1", fill: "#475569", body: "#93c5fd", face: "#1e40af", moves: "#fca5a5", acts: "#6ee7b7",
  thin: "#a3b1c4", words: "#f1f5f9", paper: "#111827", hole: "#334155" };
const style = [
  "path,circle{stroke-width:1.3;stroke-linejoin:round;stroke-linecap:round}.m,.f{stroke-width:1.8}.t,.c{stroke-width:1}",
  ".c{stroke-dasharray:8 3 2 3}.n{stroke-width:.7}",
  'text{font:italic 13px "Latin Modern Roman","Times New Roman",serif;text-anchor:middle;paint-order:stroke;',
  `stroke-width:3px;stroke-linejoin:round}${colours(light)}@media(prefers-color-scheme:dark){${colours(dark)}}`,
].join("");

module.exports = { Drawing, sum, times, unit, right, up, towards };
