// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of actions and of contact laws: name: [what is seen, in words, how it is drawn].
const { sum, times, unit, right, up, towards } = require("./drawing.cjs");
const x = [1, 0, 0], y = [0, 1, 0], z = [0, 0, 1], o = [0, 0, 0], pi = Math.PI;
/// A wall on the left, with the line that a slider moves along, and the slider.
const wall = (d) => d.polygon([[0.5, -1.9, -0.5], [-0.5, -1.9, -0.5], [-0.5, -1.9, 0.6], [0.5, -1.9, 0.6]], "a");
const slider = (d, at = 1.2) => d.line([0, -1.9, -0.35], [0, 2.2, -0.35], "a").box([0, at, 0], [0.35, 0.4, 0.35], "b");
const elongation = (d, from = -1.9, to = 0.8) => d.both([0.5, from, -0.75], [0.5, to, -0.75], "m", "e", [0, 14]);
/// Two bodies, a in blue and b in grey.
const pair = (d) => d.ellipsoid([0, -0.95, 0], [0.5, 0.85, 0.6], "a").text("b", [0, -1.4, 0], [0, 4])
  .ellipsoid([0, 0.95, 0], [0.5, 0.85, 0.6], "b").text("a", [0, 1.4, 0], [0, 4]);
/// The graph of a function on paper, with the names of its axes.
function graph(d, f, across, upwards, from = 0) {
  const at = (s, v) => [45 + 150 * s, 118 - 90 * v], zero = at(0, 0), end = at(1, 0), left = at(from, 0);
  d.curve([left, [end[0] - 6, end[1]]], "t").head(end, zero, "t").curve([[at(0, from)[0], at(0, from)[1]], [zero[0], 24]],
    "t").head([zero[0], 20], [zero[0], 60], "t");
  d.curve([...Array(61).keys()].map((i) => at(0.95 * i / 60, f(0.95 * i / 60))), "f");
  d.at = [0, 0];
  return d.text(across, o, [end[0] - 2, end[1] + 16], "tx").text(upwards, o, [zero[0] - 20, 30], "tx");
}

module.exports = {
  gravity: ["Two bodies with their weights m g, along the acceleration g of gravity", (d) => d.ellipsoid([0, -0.7, 0.5],
    [0.5, 0.7, 0.4], "b").sphere([0, 0.8, 0.35], 0.35, "b")
    .arrow([0, -0.7, 0.5], [0, -0.7, -0.75], "f", "m_1 g", [19, 0]).arrow([0, 0.8, 0.35], [0, 0.8, -0.45], "f", "m_2 g", [19,
      0]).point([0, -0.7, 0.5], "G_1").point([0, 0.8, 0.35], "G_2").arrow([0, 2.1, 1], [0, 2.1, 0], "t", "g")],
  spring: [
    "A spring k between a wall and a blue slider, with its elongation e; points A and B are the ends of one "
      + "between two points", (d) => elongation(slider(wall(d))
    .spring([0, -1.9, 0.1], [0, 0.8, 0.1]).text("k", [0, -0.5, 0.1], [0, -12], "fx").point([0, -1.9, 0.1], "A", [-8, -5])
      .point([0, 0.8, 0.1], "B", [-4, -8]))],
  damper: [
    "A damper c between a wall and a blue slider, with its elongation e; points A and B are the ends of one "
      + "between two points", (d) => elongation(slider(wall(d))
    .damper([0, -1.9, 0.1], [0, 0.8, 0.1]).text("c", [0, -0.5, 0.1], [0, -14], "fx").point([0, -1.9, 0.1], "A", [-8, -5])
      .point([0, 0.8, 0.1], "B", [-4, -8]))],
  motor: ["A motor in a bearing turns a blue arm with the torque u, which works with the angle e", (d) => d.ground([0, 0,
    -1.1]).line([0, 0, -1.1], [0, 0, -0.6], "a")
    .cylinder([0, 0, -0.7], [0, 0, 0.15], 0.5, "a").text("M", [0.3, 0.2, -0.2], [0, 2])
      .cylinder([0, 0, 0.15], [0, 0, 0.5], 0.15, "b").rod([[0, 0, 0.55], [0, 2, 0.55]], "b", 9)
      .axis([0, 0, 0.55], [0, 0, 1.5])
    .turn([0, 0, 1.1], z, 0.4, -1.2, 3.2, "f", "u", [14, -4]).turn([0, 0, 0.55], z, 1.6, 1, 2.2, "m", "e", [4, -8])],
  force: ["A force F at a point P of a blue body", (d) => d.ellipsoid([0, -0.2, 0], [0.6, 1.4, 0.65], "b")
    .arrow([0, 0.6, 0.25], [0, 1.9, 0.95], "f", "F").point([0, 0.6, 0.25], "P", [-8, -5])],
  torque: ["A torque C on a blue body, as a turn about its direction", (d) => d.ellipsoid([0, 0, -0.2], [0.6, 1.4, 0.65], "b")
    .arrow([0, 0, -0.1], [0, 0.35, 1.3], "f", "C", [14, 0]).turn([0, 0.27, 1], [0, 0.25, 1], 0.4, -1.2, 3.4, "f")],
  force_function: ["The force function U over a coordinate q; its slope is the generalised force Q", (d) => {
    graph(d, (s) => 0.25 + 0.6 * Math.sin(2.7 * s) ** 2 * (1 - 0.3 * s), "q", "U");
    d.curve([[56, 98], [112, 51.4]], "m").text("slope Q = ∂U/∂q", o, [146, 98],
      "mx").parts.push('<circle class="p" cx="82" cy="76.4" r="2.6"/>');
  }],
  generalised_force: ["A force F acts on a blue slider along its displacement e", (d) => elongation(slider(wall(d), 0.4)
    .arrow([0, 0.8, 0.1], [0, 2.1, 0.1], "f", "F", [0, -7]), -1.9, 0)],
  gravitation: ["Two bodies A and B at the distance d attract each other with opposite forces", (d) => d.sphere([0, -1.4, 0],
    0.55, "a").sphere([0, 1.4, 0], 0.4, "b")
    .arrow([0, -1.4, 0], [0, -0.3, 0], "f").arrow([0, 1.4, 0], [0, 0.3, 0], "f").text("k/d²", [0, 0, 0], [2, -12], "fx")
      .point([0, -1.4, 0], "A", [-6, -6]).point([0, 1.4, 0], "B").measure([0, -1.4, -0.9], [0, 1.4, -0.9], "d", [0, 14]),
      { at: [115, 70] }],
  wrench: ["A force R at a point P of a blue body and a moment M about P", (d) => d.ellipsoid([0, -0.3, -0.1], [0.6, 1.3,
    0.65], "b").arrow([0, 0.2, 0.15], [0, 1.8, 0.5], "f", "R")
    .arrow([0, 0.2, 0.15], [0, 0, 1.35], "f", "M_P", [-14, 2]).turn([0, 0.05, 1.05], [0, -0.16, 1], 0.35, -1.2, 3.4, "f")
      .point([0, 0.2, 0.15], "P", [-9, 10])],
  drag: ["A point P of a blue body moves with the velocity V; the drag −c V is opposite", (d) => d.ellipsoid([0, 0, 0], [0.5,
    0.9, 0.5], "b").arrow([0, 0.3, 0.2], [0, 1.9, 0.2], "m", "V").arrow([0, 0.3, 0.2], [0, -1.3, 0.2], "f", "−c V", [-12, -6])
    .point([0, 0.3, 0.2], "P", [4, -7])],
  rotational_drag: ["A blue body turns with Ω; the torque −c Ω is opposite", (d) => d.cylinder([0, 0, -0.5], [0, 0, -0.2],
    1.1, "b").axis([0, 0, -0.2], [0, 0, 1.4]).arrow([0, 0, -0.2], [0, 0, 1], "m", "Ω", [12, 4])
    .turn([0, 0, 0.5], z, 0.5, -1.2, 1.8, "m").turn([0, 0, -0.35], z, 1.35, 1.4, -0.9, "f", "−c Ω", [-30, 2])],
  force_between: ["A force F on body a and its opposite on body b, at the same point P", (d) => pair(d)
    .arrow(o, [0, 1.1, 0.9], "f", "F").arrow(o, [0, -1.1, -0.9], "f", "−F", [-4, 14]).point(o, "P", [-3, -9])],
  torque_between: ["A torque C on body a and its opposite on body b", (d) => pair(d)
    .arrow([0, 0.8, 0], [0, 0.8, 1.35], "f", "C", [12, 4]).turn([0, 0.8, 1], z, 0.35, -1.2, 3.4, "f")
    .arrow([0, -0.8, 0], [0, -0.8, -1.35], "f", "−C", [14, 2]).turn([0, -0.8, -1], z, 0.35, 3.4, -1.2, "f"), { scale: 40,
    at: [115, 75] }],

  sliding_friction: [
    "A blue body slides along G on a grey one; the normal force N presses it, the friction T is opposite to G", (d) => d
    .plane([0, 0, -0.4], 1, 2, "a").box([0, 0, -0.05], [0.4, 0.7, 0.35], "b")
    .arrow([0, 0.7, -0.05], [0, 1.9, -0.05], "m", "G").arrow([0.4, 0, -0.4], [0.4, -1.5, -0.4], "f", "T", [-6, -6])
      .arrow([0.4, 0, -0.4], [0.4, 0, 0.8], "f", "N", [9, 0]).point([0.4, 0, -0.4], "P", [9, 11])
      .text("other", [0.75, -0.7, -0.4], [-4, 4], "ax")],
  friction_law: ["Any law φ over the speed of slip s, here one that falls", (d) => {
    graph(d, (s) => 0.32 + 0.55 * Math.exp(-4 * s), "s", "φ(s)");
    d.text("|T| = N φ(s)", o, [130, 62], "fx");
  }],
  rolling_resistance: ["A blue wheel rolls on a grey plane with the turn R12; the moment −h N is opposite",
    (d) => d.plane([0, 0, -0.9], 1, 2, "a").cylinder([-0.12, 0, 0], [0.12, 0, 0], 0.9, "b").point([0.12, 0, 0])
    .turn([0.12, 0, 0], x, 0.6, 2.6, 0.6, "m", "R12", [22, -2]).turn([0.12, 0, 0], x, 1.15, 0.6, 1.9, "f", "h N", [-14, -2])
      .arrow([0.12, 0, -0.9], [0.12, 0, -0.2], "f", "N", [10, 6]), { at: [115, 78] }],
  spinning_resistance: ["A blue ball spins on a grey plane with P12 about the normal; the moment −k N is opposite",
    (d) => d.plane([0, 0, -0.75], 1.1, 2, "a").sphere([0, 0, 0], 0.75, "b").axis([0, 0, 0.75], [0, 0, 1.6])
    .turn([0, 0, 1.2], z, 0.4, -1.2, 3.2, "m", "P12", [22, -2]).turn([0, 0, -0.72], z, 1, 1.7, -1, "f", "k N", [-20, 6])
      .arrow([0, 0, -0.75], [0, 0, 0.35], "f", "N", [11, 4])],

  contact: [
    "Two blue balls above a grey plane with the normal n: one has a gap and no reaction, the other touches, with reactions N and T",
    (d) => d.plane([0, 0, -0.7], 1.15, 2.1, "a").sphere([0, -1.15, 0.2], 0.5, "b")
      .measure([0, -1.15, -0.7], [0, -1.15, -0.3], "gap", [18, 4])
      .sphere([0, 0.45, -0.2], 0.5, "b").arrow([0, 0.45, -0.7], [0, 0.45, 0.75], "f", "N", [11, 6])
      .arrow([0, 0.45, -0.7], [0, -0.45, -0.7], "f", "T", [-4, 13]).point([0, 0.45, -0.7])
      .arrow([0, 1.75, -0.7], [0, 1.75, 0.2], "t", "n"),
    { at: [112, 80] }],
  stop: ["A blue slider between two grey stops, lower and upper, of its coordinate q", (d) => d.line([0, -2, -0.35], [0, 2,
    -0.35], "a").polygon([[0.4, -1.7, -0.35], [-0.4, -1.7, -0.35], [-0.4, -1.7, 0.5], [0.4, -1.7, 0.5]], "a")
    .box([0, -0.1, 0], [0.35, 0.4, 0.35], "b").polygon([[0.4, 1.6, -0.35], [-0.4, 1.6, -0.35], [-0.4, 1.6, 0.5], [0.4, 1.6,
      0.5]], "a").arrow([0.2, -0.1, 0.6], [0.2, 0.9, 0.6], "m", "q")
    .text("lower", [0.4, -1.7, -0.35], [0, 18], "ax").text("upper", [0.4, 1.6, -0.35], [0, 18], "ax")],
  dry_friction: [
    "The force of dry friction over the rate: bound against the motion, anything up to the static bound at rest", (d) => {
    const at = (s, v) => [115 + 85 * s, 75 - 55 * v];
    d.curve([at(-1.1, 0), at(1.05, 0)], "t").head(at(1.15, 0), at(0, 0), "t").curve([at(0, -1.15), at(0, 1)], "t")
      .head(at(0, 1.15), at(0, 0), "t");
    d.curve([at(-1, 0.6), at(0, 0.6), at(0, 0.85), at(0, -0.85), at(0, -0.6), at(1, -0.6)], "f");
    d.at = [0, 0];
    d.text("rate", o, [205, 92], "tx").text("force", o, [92, 20], "tx").text("bound", o, [60, 34], "fx")
      .text("−bound", o, [165, 125], "fx").text("static_bound", o, [158, 32], "fx");
    d.parts.push('<circle class="p" cx="115" cy="28.3" r="2.4"/><circle class="p" cx="115" cy="121.8" r="2.4"/>');
  }],
  joint_friction: [
    "A blue journal of radius r turns in a grey bearing, seen along its axis: "
      + "the bearing gives it the resultant R and a torque against its turn",
    (d) => {
      const place = (across, above) => sum(times(across, right), times(above, up)), centre = place(0, -0.12);
      d.disc(o, towards, 1.35, "a").disc(o, towards, 0.95, "w").disc(centre, towards, 0.82, "b")
        .line(centre, place(0.62, 0.42)).text("r", place(0.3, 0.15), [-4, -5], "tx").point(centre)
        .arrow(place(0, -0.95), place(0, 0.6), "f", "R", [-10, 4]).turn(centre, towards, 0.6, pi, pi + 1.9, "m")
        .turn(centre, towards, 1.2, 1.9, 0.4, "f").text("f r |R|", place(-1.5, 1.1), [-14, 6], "fx").point(place(0, -0.95));
    }, { at: [120, 75] }],
};
