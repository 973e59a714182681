// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of inertias: name: [what is seen, in words, how it is drawn]. The origin of the frame is the black point.
const { sum, times, unit } = require("./drawing.cjs");
const x = [1, 0, 0], y = [0, 1, 0], z = [0, 0, 1], o = [0, 0, 0], pi = Math.PI;

/// The axes of the frame, in front of a solid.
const framed = (d, length = 1.3, at = o) => d.axes(at, length, "t").point(at);
/// Its axis, through the solid.
const round = (d, to = 1.45) => d.axis([0, 0, 0.95], [0, 0, to], "axis", [18, 4]);
/// Axes x and y alone.
const flat = (d) => d.arrow(o, [0.75, 0, 0], "t", "x").arrow(o, [0, 0.75, 0], "t", "y").point(o);

module.exports = {
  "Inertia::point": ["A point of mass m at the origin of the frame", (d) => framed(d).sphere(o, 0.13, "b")
    .text("m", o, [14, -8]), { at: [115, 90] }],
  "Inertia::general": ["A blue body of any shape; its centre of mass is the origin of the axes x, y, z", (d) => framed(d
    .blob((u) => [0.7 * u[0], 1.35 * u[1] + 0.2 * u[1] * u[2], (0.8 + 0.3 * u[1]) * u[2]], "b"), 1.25)
      .text("G", o, [-10, -4])],
  "Inertia::rod": ["A thin blue rod of length l, centred at the origin, along its axis", (d) => framed(d
    .rod([[0, -1.6, 0], [0, 1.6, 0]], "b", 8), 0.8).axis([0, 1.7, 0], [0, 2.3, 0], "axis", [-4, -6])
      .measure([0.5, -1.6, -0.35], [0.5, 1.6, -0.35], "l", [0, 14])],
  "Inertia::disk": ["A thin blue disc of radius r, centred, with its axis across it", (d) => round(d
    .cylinder([0, 0, -0.06], [0, 0, 0], 1.3, "b").line(o, [0, 0, 0.95], "c")).point(o).line(o, [0.9, 0.92, 0])
      .text("r", [0.6, 0.62, 0], [8, -4], "tx")],
  "Inertia::ring": ["A thin blue ring of radius r, centred, with its axis across it", (d) => round(d
    .ring(o, z, 1.3, "b", 7).line(o, [0, 0, 0.95], "c")).point(o).line(o, [0.9, 0.92, 0])
      .text("r", [0.55, 0.57, 0], [8, -4], "tx")],
  "Inertia::cylinder": ["A solid blue cylinder of radius r and height h, centred", (d) => framed(d.cylinder([0, 0, -0.75],
    [0, 0, 0.75], 0.8, "b"), 0.6)
    .axis([0, 0, 0.75], [0, 0, 1.45], "axis", [18, 4]).line([0, 0, 0.75], [0, 0.8, 0.75])
      .text("r", [0, 0.45, 0.75], [2, -4], "tx").measure([0, 1.15, -0.75], [0, 1.15, 0.75], "h", [8, 4])],
  "Inertia::hollow_cylinder": ["A thick blue tube of outer radius R, inner radius r and height h, centred", (d) => d.tube([0,
    0, -0.75], [0, 0, 0.75], 1, 0.55, "b").point(o)
    .axis([0, 0, 0.75], [0, 0, 1.45], "axis", [18, 4]).line([0, 0, 0.75], [0, 1, 0.75]).text("R", [0, 1, 0.75], [8, 0], "tx")
      .line([0, 0, 0.75], [0, -0.55, 0.75]).text("r", [0, -0.3, 0.75], [0, -4], "tx")
    .measure([0, 1.35, -0.75], [0, 1.35, 0.75], "h", [8, 4])],
  "Inertia::cylindrical_shell": ["A thin blue shell of radius r and height h without ends, centred", (d) => d.tube([0, 0,
    -0.75], [0, 0, 0.75], 0.85, 0.82, "b").point(o)
    .axis([0, 0, 0.75], [0, 0, 1.45], "axis", [18, 4]).line([0, 0, 0.75], [0, 0.85, 0.75])
      .text("r", [0, 0.45, 0.75], [2, -4], "tx").measure([0, 1.2, -0.75], [0, 1.2, 0.75], "h", [8, 4])],
  "Inertia::cone": [
    "A solid blue cone with a base of radius r and the height h; its centre of mass is a quarter of the height "
      + "above the base", (d) => d
    .cone([0, 0, -0.5], [0, 0, 1.5], 0.95, "b").axis([0, 0, -0.5], [0, 0, 1.5]).line([0, 0, -0.5], [0, 0.95, -0.5])
      .text("r", [0, 0.5, -0.5], [0, 12], "tx").point(o, "G")
    .measure([0, 1.3, -0.5], [0, 1.3, 1.5], "h", [8, 4]).measure([0, -1.3, -0.5], [0, -1.3, 0], "h/4", [-16, 4])
      .line([0, -1.3, 0], o, "c"), { at: [115, 98] }],
  "Inertia::conical_shell": [
    "A thin blue conical shell without its base; its centre of mass is a third of the height above the base", (d) => d
    .cone([0, 0, 0.67], [0, 0, -1.33], 0.95, "b").disc([0, 0, 0.67], z, 0.92, "h").axis([0, 0, -1.33], [0, 0, 0.67])
      .line([0, 0, 0.67], [0, 0.95, 0.67]).text("r", [0, 0.5, 0.67], [0, -4], "tx").point(o, "G", [9, 10])
    .measure([0, 1.3, -1.33], [0, 1.3, 0.67], "h", [8, 4]).measure([0, -1.3, 0], [0, -1.3, 0.67], "h/3", [-16, 4])
      .line([0, -1.3, 0], o, "c"), { at: [115, 66] }],
  "Inertia::solid_sphere": ["A solid blue sphere of radius r, centred", (d) => framed(d.sphere(o, 1.1, "b"), 0.8)
    .line(o, [0, 0.85, 0.68]).text("r", [0, 0.45, 0.36], [-4, -4], "tx"), { at: [115, 78] }],
  "Inertia::hollow_sphere": ["A thin blue spherical shell of radius r, opened to show that it is hollow", (d) => d.sphere(o,
    1.1, "b")
    .disc(times(0.75, [0.77, 0.47, 0.43]), [0.77, 0.47, 0.43], 0.8, "h").line(o, [0, 0.85, 0.68])
      .text("r", [0, 0.45, 0.36], [-4, -4], "tx").point(o), { at: [115, 78] }],
  "Inertia::box": ["A solid blue box with its edges a, b and c along x, y and z, centred", (d) => framed(d.box(o, [0.6, 1.1,
    0.55], "b"), 0.5).text("a", [0.2, 1.1, -0.55], [12, 8], "tx")
    .text("b", [0.6, 0, -0.55], [0, 14], "tx").text("c", [0.6, -1.1, 0], [-8, 4], "tx"), { scale: 48, at: [115, 78] }],
  "Inertia::plate": ["A thin blue plate with its edges a along x and b along y, centred", (d) => framed(d.box([0, 0, -0.03],
    [0.9, 1.4, 0.03], "b"), 0.8)
    .text("a", [0, 1.4, 0], [12, 8], "tx").text("b", [0.9, 0.3, 0], [0, 17], "tx"), { scale: 46, at: [115, 78] }],
  "Inertia::half_disk": [
    "A thin blue half disc: its diameter lies along x, its half on the positive side of y, and G is 4 r/(3 π) "
      + "from the diameter", (d) => {
    d.polygon([...Array(25).keys()].map((i) => [1.35 * Math.cos(i * pi / 24), 1.35 * Math.sin(i * pi / 24), 0]), "b");
    flat(d).axis(o, [0, 0, 1.3], "axis", [18, 4]).point([0, 0.573, 0], "G").text("r", [-0.67, 0, 0], [2, -5], "tx");
  }, { scale: 50, at: [95, 72] }],
  "Inertia::quarter_disk": [
    "A thin blue quarter disc: its corner is the origin, its edges lie along x and y, and G is 4 r/(3 π) along both", (d) => {
    d.polygon([o, ...[...Array(19).keys()].map((i) => [1.5 * Math.cos(i * pi / 36), 1.5 * Math.sin(i * pi / 36), 0])], "b");
    flat(d).axis(o, [0, 0, 1.3], "axis", [18, 4]).point([0.637, 0.637, 0], "G").text("r", [0, 1.1, 0], [0, -5], "tx");
  }, { scale: 52, at: [105, 72] }],
  "Inertia::triangle": [
    "A thin blue triangular plate with its corners a, b and c and its centre of mass G, anywhere in the frame", (d) => {
    const [a, b, c] = [[0.8, -0.5, -0.1], [0, 1.9, 0], [-0.4, 0.2, 1.3]];
    framed(d.polygon([a, b, c], "b"), 0.8, [0, -1.4, -0.3]).point(a, "a", [0, 14]).point(b, "b", [9, 5])
      .point(c, "c", [0, -6]).point(times(1 / 3, sum(a, sum(b, c))), "G");
  }],
  at: ["The body keeps its turn; its centre of mass moves to new_center, an arrow from the origin O",
    (d) => framed(d.sphere([0, 1.15, 0.45], 0.55, "b"), 0.85, [0, -1.3, -0.4])
    .arrow([0, -1.3, -0.4], [0, 1.15, 0.45], "m").text("new_center", [0, -0.2, 0.05], [-14, -10], "mx")
      .point([0, 1.15, 0.45], "G").text("O", [0, -1.3, -0.4], [-9, -4])],
  rotated: ["A grey box and the same box in blue, turned by the angle about the axis through the origin", (d) => {
    const f = [unit([0.8, 0.6, 0]), unit([-0.6, 0.8, 0]), z];
    d.box([0, 0.95, 0], [0.2, 0.85, 0.12], "a").box(times(0.95, f[1]), [0.2, 0.85, 0.12], "b", f)
      .axis(o, [0, 0, 1.3], "axis", [18, 4]).point(o).turn(o, z, 2.05, pi / 2, pi / 2 + 0.6, "m", "angle", [14, -10]);
  }, { at: [70, 85] }],
};
