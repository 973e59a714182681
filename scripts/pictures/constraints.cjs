// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of constraints: name: [what is seen, in words, how it is drawn].
const { sum, times, unit } = require("./drawing.cjs");
const x = [1, 0, 0], y = [0, 1, 0], z = [0, 0, 1], o = [0, 0, 0], pi = Math.PI;

module.exports = {
  holonomic: ["A blue bead stays on a grey curve f = 0; the force of its multiplier is across the curve", (d) => {
    const at = (s) => [0, s, 0.55 * Math.sin(1.3 * s)], p = at(0.5), n = unit([0, -0.55 * 1.3 * Math.cos(0.65), 1]);
    d.rod([...Array(41).keys()].map((i) => at(-2.1 + 0.105 * i)), "a", 6).sphere(p, 0.2, "b")
      .arrow(p, sum(p, times(1.1, n)), "f", "λ grad f", [-10, -6]).text("f(q, t) = 0", at(-1.2), [0, 26], "ax");
  }],
  nonholonomic: ["The blade of a skate: its velocity V lies along the blade, the force λ a across it", (d) => {
    const u = unit([0.35, 1, 0]), v = unit([1, -0.35, 0]);
    d.plane([0, 0, -0.4], 1.25, 2, "a").polygon([sum(times(-0.8, u), [0, 0, -0.4]), sum(times(0.8, u), [0, 0, -0.4]),
      sum(times(0.9, u), [0, 0, 0.1]), sum(times(-0.9, u), [0, 0, 0.1])], "b")
      .arrow(sum(times(0.8, u), [0, 0, -0.4]), sum(times(1.9, u), [0, 0, -0.4]), "m", "V")
        .arrow([0, 0, -0.4], sum(times(1.2, v), [0, 0, -0.4]), "f", "λ a", [-12, 8]).point([0, 0, -0.4]);
  }],
  no_slip: ["A blue wheel on a grey plane: the velocity of its point at P has no component along the direction",
    (d) => d.plane([0, 0, -0.9], 1.1, 2, "a").cylinder([-0.1, 0, 0], [0.1, 0, 0], 0.9, "b")
    .turn([0.1, 0, 0], x, 0.55, 2.7, 0.5, "m").arrow([0.1, 0, -0.9], [0.1, 1.5, -0.9], "t", "direction", [-6, -7])
      .point([0.1, 0, -0.9], "P", [-9, 11]).text("V(P) · direction = 0", [0, 0, 1.3], [0, 0], "mx"), { at: [115, 76] }],
  rolling: ["A blue ball rolls on a grey plane: the velocity of its point at P has no component along x and y",
    (d) => d.plane([0, 0, -0.75], 1.25, 2, "a").sphere([0, 0, 0], 0.75, "b").turn(o, x, 1.0, 2.2, 0.9, "m")
    .axes([0, 0, -0.75], 1.3, "t")
    .point([0, 0, -0.75], "P", [-9, 10]), { at: [115, 74] }],
  point_in_plane: ["A point P of a blue body stays in a grey plane; N is the normal force on the body", (d) => d.plane([0, 0,
    -0.6], 1.25, 2, "a").cone([0, 0.5, 0.75], [0, 0, -0.6], 0.45, "b").arrow([0, 0, -0.6], [0, 0, 0.8], "f", "N", [-10, 4])
    .axes([-1.25, -2, -0.6], 0.75, "a").point([0, 0, -0.6], "P", [-9, 11])],
  closure: ["Two chains end in A and B; their distance along the direction is held at zero", (d) => d.ground([0, -1.9, -1])
    .rod([[0, -1.9, -1], [0, -1.4, 0.5], [0, -0.35, 0.2]], "a").ground([0, 1.9, -1])
    .rod([[0, 1.9, -1], [0, 1.5, 0.7], [0, 0.35, 0.2]], "b")
    .point([0, -1.9, -1]).point([0, -1.4, 0.5]).point([0, 1.9, -1]).point([0, 1.5, 0.7])
      .both([0, -0.35, 0.2], [0, 0.35, 0.2], "m").point([0, -0.35, 0.2], "A", [-3, -8]).point([0, 0.35, 0.2], "B", [4, -8])
      .arrow([0, -0.4, -0.7], [0, 0.6, -0.7], "t", "direction", [-20, 15])],
  loop_joint: [
    "A four-bar loop: the frames a of a grey bar and b of a blue one are held together by a revolute joint about "
      + "x of both", (d) => d.ground([0, -1.6, -1]).rod([[0, -1.6, -1], [0, -1.1, 0.8], [0, 0.9, 0.9]], "a")
    .ground([0, 1.6, -1]).rod([[0, 1.6, -1], [0, 0.9, 0.9]], "b")
    .axis([-0.6, 0.9, 0.9], [1.1, 0.9, 0.9], "x", [-7, 6]).cylinder([-0.15, 0.9, 0.9], [0.15, 0.9, 0.9], 0.16, "b")
      .turn([0.7, 0.9, 0.9], x, 0.3, -0.6, 3.2, "m").text("a", [0, 0.3, 0.87], [0, -8], "ax")
      .text("b", [0, 1.2, 0.1], [14, 4], "bx")
    .point([0, -1.6, -1]).point([0, -1.1, 0.8]).point([0, 1.6, -1]), { at: [112, 88] }],
  reaction: [
    "A force of unknown intensity on a blue body at the point of contact, along the direction, and its opposite "
      + "on the other body", (d) => d.box([0, -0.2, -0.75], [0.7, 1.7, 0.2], "a")
    .text("other", [0.7, -1.2, -0.75], [0, 4], "ax").ellipsoid([0, -0.2, 0], [0.5, 0.9, 0.55], "b").text("body", [0, -0.6, 0.15], [0, 0], "bx")
    .arrow([0, -0.2, -0.55], [0, 0.25, 1.1], "f", "λ direction", [34, 0])
      .arrow([0, -0.2, -0.55], [0, -0.5, -1.65], "f", "−λ direction", [52, -2])
      .point([0, -0.2, -0.55], "", [0, 0]), { scale: 40, at: [108, 76] }],
};
