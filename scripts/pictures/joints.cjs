// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of joints and of points of contact: name: [what is seen, in words, how it is drawn].
const { sum, times, unit } = require("./drawing.cjs");
const x = [1, 0, 0], y = [0, 1, 0], z = [0, 0, 1], o = [0, 0, 0], pi = Math.PI;
/// A turned frame.
const turned = [unit([0.9, 0.35, 0.25]), unit([-0.45, 0.85, 0.25]), unit([-0.12, -0.33, 0.93])];

module.exports = {
  weld: ["A grey frame and a blue one, which is held away from it and turned by a fixed rod", (d) => d
    .rod([[0, -1.5, -0.6], [0, 0.8, 0.2]], "a").axes([0, -1.5, -0.6], 0.9, "a")
      .axes([0, 0.8, 0.2], 0.8, "b", ["x", "y", "z"], turned)
    .point([0, -1.5, -0.6]).point([0, 0.8, 0.2]).text("origin, rotation", [0, -0.3, -0.2], [-4, -12], "tx"), { scale: 50,
      at: [118, 80] }],
  revolute: ["A blue arm turns by the angle about the axis of a grey bearing", (d) => d
    .ground([0, 0, -1.1]).line([0, 0, -1.1], [0, 0, -0.6], "a").axis([0, 0, -0.6], [0, 0, 1.6], "axis", [17, 6])
    .cylinder([0, 0, -0.7], [0, 0, 0.1], 0.35, "a").cylinder([0, 0, 0.1], [0, 0, 0.5], 0.2, "b")
      .rod([[0, 0, 0.55], [0, 2, 0.55]], "b", 9)
    .axis([0, 0, 0.55], [0, 0, 1.6]).turn([0, 0, 0.55], z, 1.3, -0.3, 1.2, "m", "angle", [-78, -16]), { scale: 46, at: [95,
      90] }],
  prismatic: ["A blue block slides by the displacement along a grey rail, whose direction is the axis", (d) => d
    .ground([0, -1.2, -0.55]).axis([0, -2.3, 0], [0, 2.4, 0], "axis", [-2, -7]).box([0, 0, -0.3], [0.35, 1.9, 0.16], "a")
    .box([0, 0.1, 0.1], [0.5, 0.5, 0.3], "b").arrow([0, -1.3, 0.75], [0, 0.1, 0.75], "m")
      .line([0, -1.3, 0.6], [0, -1.3, 0.95], "m")
    .text("displacement", [0, -0.55, 0.75], [10, -16], "mx")],
  helical: ["A blue screw turns by the angle in a grey nut and advances by the pitch times it", (d) => {
    d.axis([0, -2.3, 0], [0, 2.3, 0], "axis", [-4, 15]).cylinder([0, -1.7, 0], [0, 1.8, 0], 0.26, "b");
    for (let i = 0; i < 16; ++i) if (i < 4 || i > 9) d.path(d.circle_points([0, -1.5 + 0.2 * i, 0], y, 0.27, -0.9, 2.2, 12)
      .map((p, k) => sum(p, [0, 0.013 * k, 0])), "b");
    d.box([0, 0, 0], [0.5, 0.4, 0.5], "a").line([0, 0, -0.5], [0, 0, -1.1], "a").ground([0, 0, -1.1]);
    d.turn([0, -1.25, 0], y, 0.75, 0.4, 2.6, "m", "angle", [-16, 10]).arrow([0, 0.8, 0.75], [0, 1.9, 0.75], "m")
      .text("pitch · angle", [0, 1.3, 0.75], [22, -12], "mx");
  }],
  cylindrical: ["A blue shaft slides by the displacement along the axis of a grey sleeve and turns by the angle about it",
    (d) => d
    .axis([0, -2.3, 0], [0, 2.3, 0], "axis", [-4, 15]).ground([0, 0, -1.1]).line([0, 0, -1.1], [0, 0, 0], "a")
      .cylinder([0, -1.8, 0], [0, -0.5, 0], 0.2, "b")
    .cylinder([0, -0.7, 0], [0, 0.6, 0], 0.38, "a").cylinder([0, 0.6, 0], [0, 1.8, 0], 0.2, "b")
    .turn([0, -1.3, 0], y, 0.7, 0.4, 2.6, "m", "angle", [-16, 10]).arrow([0, 0.6, 0.75], [0, 1.7, 0.75], "m")
      .text("displacement", [0, 1.1, 0.75], [0, -10], "mx")],
  universal: [
    "A cross turns about the first axis in a grey fork; a blue fork turns about the second axis, which the cross carries",
    (d) => d
    .axis([-1.7, 0, 0], [1.9, 0, 0], "first", [-6, 14]).rod([[0, 0, -1.6], [0, 0, -0.8]], "a", 9)
      .rod([[-0.7, 0, 0], [-0.7, 0, -0.8], [0.7, 0, -0.8], [0.7, 0, 0]], "a")
    .axis([0, -1.5, 0], [0, 1.9, 0], "second", [0, 17]).rod([[-0.7, 0, 0], [0.7, 0, 0]], "w", 6)
      .rod([[0, -0.7, 0], [0, 0.7, 0]], "w", 6)
    .rod([[0, -0.7, 0], [0, -0.7, 0.7], [0, 0.7, 0.7], [0, 0.7, 0]], "b").rod([[0, 0, 0.7], [0, 0, 1.5]], "b", 9)
    .turn([1.45, 0, 0], x, 0.32, -0.6, 3.2, "m").text("first_angle", [1.45, 0, 0], [-24, -20], "mx")
    .turn([0, 1.45, 0], y, 0.32, -1.5, 2.2, "m").text("second_angle", [0, 1.45, 0], [16, -22], "mx"), { scale: 44, at: [112,
      74] }],
  spherical: ["A blue ball with a rod turns every way in a grey socket", (d) => d
    .ground([0, 0, -1.25]).cylinder([0, 0, -1.25], [0, 0, -0.5], 0.14, "a").shape([...Array(21).keys()].map((i) => {
      const c = d.flat(o), a = pi * i / 20; return [c[0] + 26 * Math.cos(a), c[1] + 26 * Math.sin(a)]; }), "a")
    .sphere(o, 0.45, "b").rod([[0, 0.12, 0.4], [0, 0.5, 1.45]], "b")
    .turn([0, 0.42, 1.25], [0, 0.32, 0.94], 0.35, -1.2, 3.4, "m").turn(o, x, 1.05, 1.9, 2.7, "m")
      .turn(o, y, 1.05, 0.6, 1.9, "m").point(o)
    .text("three angles", [0, 0, 1], [-80, -10], "mx").text("or attitude", [0, 0, 1], [-80, 5], "mx"), { scale: 44, at: [125,
      84] }],
  planar: ["A blue block slides by x and y on a grey plane and turns by the angle about its normal z", (d) => d
    .plane([0, 0, -0.4], 1.25, 2, "a").axes([-1.25, -2, -0.4], 0.75, "a")
      .box([0.1, 0.2, -0.1], [0.45, 0.6, 0.3], "b", [unit([1, 0.35, 0]), unit([-0.35, 1, 0]), z])
    .arrow([0.6, 0.2, -0.4], [1.6, 0.2, -0.4], "m", "x", [-9, 5]).arrow([0.1, 1.1, -0.4], [0.1, 2.1, -0.4], "m", "y", [2, 13])
    .axis([0.1, 0.2, 0.2], [0.1, 0.2, 1.2]).turn([0.1, 0.2, 0.75], z, 0.45, -1.2, 3.2, "m", "angle", [28, -5])],
  line_contact: [
    "The edge of a blue prism lies in a grey plane: it slides by x and y, turns by yaw about the normal, by roll "
      + "about the edge", (d) => {
    const u = unit([0.25, 1, 0]), v = unit([1, -0.25, 0]), at = (a, b, c) => sum(sum(times(a, u), times(b, v)), [0, 0,
      c - 0.4]);
    d.plane([0, 0, -0.4], 1.25, 2, "a").axes([-1.25, -2, -0.4], 0.75, "a")
      .polygon([at(-1, 0, 0), at(1, 0, 0), at(1, -0.3, 0.6), at(-1, -0.3, 0.6)], "b")
      .polygon([at(-1, -0.3, 0.6), at(1, -0.3, 0.6), at(1, 0.45, 0.55), at(-1, 0.45, 0.55)], "b")
        .polygon([at(-1, 0, 0), at(1, 0, 0), at(1, 0.45, 0.55), at(-1, 0.45, 0.55)], "b")
      .polygon([at(1, 0, 0), at(1, -0.3, 0.6), at(1, 0.45, 0.55)], "b").axis(at(1, 0, 0), at(1.9, 0, 0))
        .turn(at(1.45, 0, 0), u, 0.4, -0.6, 2.8, "m", "roll", [24, 18])
      .axis(at(0, 0, 0.6), at(0, 0, 1.6)).turn(at(0, 0, 1.15), z, 0.42, -1.2, 3.2, "m", "yaw", [26, -5])
      .arrow([0.5, 0.2, -0.4], [1.6, 0.2, -0.4], "m", "x", [-9, 5]).arrow([-0.9, 0.75, -0.4], [-0.9, 1.75, -0.4], "m", "y",
        [2, -6]);
  }],
  sphere_in_cylinder: ["The centre of a blue ball slides along the axis of a grey tube; the ball turns every way", (d) => d
    .axis([0, -2.3, 0], [0, 2.3, 0], "axis", [-4, 15]).ground([0, -0.7, -1.15]).line([0, -0.7, -1.15], [0, -0.7, -0.4], "a")
      .cylinder([0, -1.6, 0], [0, 1.4, 0], 0.52, "a")
    .polygon([[0.1, -1.1, 0.52], [0.1, 0.9, 0.52], [0.5, 0.9, -0.12], [0.5, -1.1, -0.12]], "w")
      .line([0, -2.3, 0], [0, 2.3, 0], "c")
    .sphere([0, 0, 0], 0.48, "b").rod([[0, 0.1, 0.4], [0, 0.45, 1.4]], "b")
      .turn([0, 0.38, 1.2], [0, 0.33, 0.94], 0.35, -1.2, 3.4, "m", "turn", [26, -2])
    .arrow([0, 0.5, 0], [0, 1.3, 0], "m").text("displacement", [0, 1.6, 0], [2, 40], "mx")],
  point_contact: ["The tip of a blue body slides by x and y in a grey plane; the body turns every way about the tip", (d) => d
    .plane([0, 0, -0.6], 1.25, 2, "a").axes([-1.25, -2, -0.6], 0.75, "a").cone([-0.1, 0.35, 0.75], [0, 0, -0.6], 0.5, "b")
    .arrow([0.1, 0, -0.6], [1.4, 0, -0.6], "m", "x", [-9, 5]).arrow([0, 0.15, -0.6], [0, 1.5, -0.6], "m", "y", [6, 13])
      .point([0, 0, -0.6])
    .turn([-0.1, 0.4, 1.1], [-0.08, 0.26, 0.96], 0.35, -1.2, 3.4, "m", "turn", [27, -2])],
  free: ["A blue body is at the place x, y, z of a grey frame and turns every way", (d) => d
    .axes([0, -1.7, -0.7], 0.95, "a").box([0, 0.75, 0.35], [0.4, 0.55, 0.28], "b", turned)
      .arrow([0, -1.7, -0.7], [0, 0.75, 0.35], "m", "x, y, z", [-52, -10]).point([0, 0.75, 0.35])
    .turn([0, 0.75, 1.05], z, 0.35, -1.2, 3.4, "m").turn([0, 1.8, 0.3], y, 0.35, -1.3, 2.4, "m")
      .text("turn", [0, 1.8, 0.3], [4, 32], "mx"), { scale: 46 }],

  point: ["A point of a blue body with its components along the axes of the frame", (d) => d
    .ellipsoid([0, 0.2, 0], [0.7, 1.7, 0.8], "b").axes([0, -0.6, -0.2], 1.1, "b")
      .arrow([0, -0.6, -0.2], [0.2, 1.1, 0.35], "t").point([0.2, 1.1, 0.35], "P")],
  disc_contact: ["A leaning blue disc with centre C and axis k touches a grey plane with the normal n at its lowest point P",
    (d) => {
    const k = unit([0.25, 0.9, 0.42]), nk = k[2], c = [0, 0, 0.35], p = sum(c, times(-1, times(1 / Math.sqrt(1 - nk * nk),
      sum(z, times(-nk, k)))));
    d.plane([0, 0.1, p[2]], 1.15, 2, "a").cylinder(sum(c, times(-0.05, k)), sum(c, times(0.05, k)), 1, "b")
      .arrow(c, sum(c, times(1.5, k)), "t", "k")
      .line(c, p, "t").text("r", times(0.5, sum(c, p)), [-8, 4], "tx").arrow([0, 1.5, p[2]], [0, 1.5, p[2] + 0.9], "t", "n")
        .point(c, "C", [-9, -4]).point(p, "P", [-9, 12]);
  }, { at: [108, 82] }],
  sphere_contact: ["A blue sphere with centre C touches a grey plane with the normal n at P, a radius below", (d) => d
    .plane([0, 0, -0.75], 1.25, 2, "a").sphere([0, 0, 0.1], 0.85, "b").line([0, 0, 0.1], [0, 0, -0.75], "t")
      .text("r", [0, 0, -0.3], [8, 4], "tx")
    .arrow([0, 1.5, -0.75], [0, 1.5, 0.25], "t", "n").point([0, 0, 0.1], "C")
      .point([0, 0, -0.75], "P", [10, 10]), { at: [115, 74] }],
  torus_contact: ["A leaning blue ring, a tube around a circle, touches a grey plane at its lowest point P", (d) => {
    const k = unit([0.3, 0.85, 0.35]), nk = k[2], c = [0, 0, 0.4], e = times(1 / Math.sqrt(1 - nk * nk), sum(z, times(-nk,
      k)));
    const p = sum(c, sum(times(-0.85, e), [0, 0, -0.18]));
    d.plane([0, 0, p[2]], 1.15, 2, "a").ring(c, k, 0.85, "b", 15).circle(c, k, 0.85, "c")
      .line(c, sum(c, times(-0.85, e)), "t").arrow(c, sum(c, times(1.3, k)), "t", "axis", [16, 4])
      .arrow([0, 1.6, p[2]], [0, 1.6, p[2] + 0.9], "t", "n").point(c, "C", [-9, -3]).point(p, "P", [-10, 10]);
  }],
  ellipsoid_contact: ["A turned blue ellipsoid with its semi-axes touches a grey plane at its lowest point P", (d) => {
    const f = turned, s = [0.6, 1.35, 0.65], place = (u) => f.reduce((p, e, i) => sum(p, times(s[i] * u[i], e)), [0, 0, 0.1]);
    const n = f.map((e) => e[2]), size = Math.hypot(...n.map((v, i) => v * s[i])), p = place(n.map((v,
      i) => -s[i] * v / size));
    d.plane([0, 0, p[2]], 1.25, 2, "a").blob(place, "b").path([...Array(33)
      .keys()].map((i) => place([0, Math.cos(i * pi / 16), Math.sin(i * pi / 16)])), "b n")
      .arrow(place(o), place([0, 1, 0]), "t", "b", [-8, -6]).arrow(place(o), place([0, 0, 1]), "t", "c", [-8, 8])
        .arrow(place(o), place([1, 0, 0]), "t", "a", [-2, -6])
      .arrow([0, 1.75, p[2]], [0, 1.75, p[2] + 0.8], "t", "n").point(place(o), "C", [9, 8]).point(p, "P", [10, 10]);
  }],
  support_contact: [
    "A blue convex body lies on a grey plane: its tangent plane across −n has the distance h from the origin C", (d) => {
    const place = (u) => [0.6 * u[0], 1.2 * u[1] + 0.25 * u[1] * u[1],
      (0.75 + 0.25 * u[1]) * u[2] * (u[2] > 0 ? 1.15 : 0.9) + 0.1];
    d.plane([0, 0, -0.62], 1.25, 2, "a").blob(place, "b").arrow([0, -0.3, 0.2], [0, -0.3, -0.62], "t")
      .text("h(−n)", [0, -0.3, -0.2], [-21, 4], "tx").line([0, -0.3, -0.62], [0, 0.25, -0.62], "c")
      .arrow([0, 1.7, -0.62], [0, 1.7, 0.25], "t", "n").point([0, -0.3, 0.2], "C", [-10, -2])
        .point([0, 0.28, -0.62], "P", [9, 11]);
  }],
  body: ["A blue body with its mass and its centre of mass G, in a frame with the origin O", (d) => d
    .ellipsoid([0, 0.35, 0.15], [0.7, 1.5, 0.75], "b").axes([0, -1.6, -0.5], 0.85, "a")
      .arrow([0, -1.6, -0.5], [0, 0.35, 0.15], "t").text("m, J", [0, 1.3, 0.3], [0, 0])
    .point([0, -1.6, -0.5], "O", [-9, -5]).point([0, 0.35, 0.15], "G")],
  reflected_inertia: [
    "A small rotor with the inertia J turns N times as fast as the blue wheel that it drives through a gear", (d) => d
    .cylinder([0.1, 1.15, -0.3], [-0.1, 1.15, -0.3], 0.34, "a").cylinder([0.12, 0, 0], [-0.12, 0, 0], 0.95, "b")
      .circle([0.12, 0, 0], x, 0.12, "b").axis([0.12, 0, 0], [1.6, 0, 0])
    .cylinder([0.9, 1.15, -0.3], [0.1, 1.15, -0.3], 0.3, "a").text("J", [0.9, 1.15, -0.3], [0, 4])
      .turn([0.12, 0, 0], x, 1.15, 1.1, 2.1, "m", "e", [-8, 4])
    .turn([0.9, 1.15, -0.3], x, 0.5, 0.9, -1.6, "m").text("N e", [0.9, 1.15, -0.3], [40, 6], "mx")],
};
