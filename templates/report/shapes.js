// SPDX-License-Identifier: MIT-0
// From the poses of a scene to shapes: joints by their type, rods between joints, discs, ellipsoids of inertia.
(() => {
"use strict";
const { add, column, scaled, dot, cross, length, unit, triad, principal } = torsorReport.vectors;
const { convex, torus, boxAround } = torsorReport.surfaces;
const { Framing } = torsorReport.framing;

const palette = [[0.55, 0.57, 0.6], [0.13, 0.4, 0.75], [0.8, 0.3, 0.2], [0.2, 0.58, 0.35], [0.6, 0.36, 0.7],
                 [0.83, 0.6, 0.12], [0.1, 0.58, 0.65], [0.78, 0.35, 0.55], [0.45, 0.5, 0.2], [0.5, 0.35, 0.25]];
const steel = [0.35, 0.37, 0.4];
const colourOf = (body) => (body === 0 ? palette[0] : palette[1 + ((body - 1) % (palette.length - 1))]);

function cylinder(from, to, radius, colour, mesh = "cylinder") {
  const along = add(to, from, -1), [x, y] = triad(along);
  return { mesh, x: scaled(x, radius), y: scaled(y, radius), z: along, origin: from, colour };
}
function ball(origin, radius, colour) {
  return { mesh: "sphere", x: [radius, 0, 0], y: [0, radius, 0], z: [0, 0, radius], origin, colour };
}

/// An arrow in front of all else, whose shaft has this radius; nothing where it would be shorter than its head.
function arrow(from, vector, radius, colour) {
  const far = length(vector);
  if (!(far > 7 * radius)) return [];
  const neck = add(from, vector, 1 - (7 * radius) / far);
  return [cylinder(from, neck, radius, colour), cylinder(neck, add(from, vector), 2.6 * radius, colour, "cone")].map((shape) => ({ ...shape, above: true }));
}
const arrowColours = { velocities: [0.1, 0.6, 0.3], weights: [0.75, 0.2, 0.2], reactions: [0.85, 0.45, 0.05] };

/// What is drawn of a scene, decided once at its first pose: sizes, and which places of a body are joined by rods.
class Picture {
  constructor(scene, poses) {
    this.scene = scene;
    this.shown = scene.forms.map((form, k) => ({ ...form, k })).filter((form) => form.kind !== "mesh" || form.mesh);
    const places = [];
    scene.frames.forEach((_, k) => places.push(column(poses.origins, k), column(poses.anchors, k)));
    scene.bodies.forEach((_, k) => places.push(column(poses.centres, k)));
    scene.points.forEach((_, k) => places.push(column(poses.points, k)));
    this.ofAuthor = new Set(this.shown.map((form) => scene.frames[form.frame].body));  // bodies that the author draws
    // A ring keeps the thickness for its size that it has at the parameters' values in the scene.
    this.rings = this.shown.filter((form) => form.kind === "torus").map((form) => {
      const [radius, tube] = poses.form_lengths.subarray(4 * form.k, 4 * form.k + 2), thickness = tube / radius, out = 1 + thickness;
      Object.assign(form, { mesh: `torus ${form.k}`, ends: [[-out, out], [-out, out], [-thickness, thickness]] });
      return { mesh: form.mesh, ...torus(1, thickness) };
    });
    places.push(...this.formCorners(poses));
    const low = [0, 1, 2].map((i) => Math.min(...places.map((p) => p[i])));
    const high = [0, 1, 2].map((i) => Math.max(...places.map((p) => p[i])));
    const middle = scaled(add(low, high), 0.5);
    const extents = scene.bodies.map((body, k) => {
      if (this.ofAuthor.has(scene.frames[body.frame].body)) return 0;  // no ellipsoid is drawn
      const m = poses.masses[k], trace = poses.inertias[6 * k] + poses.inertias[6 * k + 1] + poses.inertias[6 * k + 2];
      return m > 0 && trace > 0 ? Math.sqrt((1.5 * trace) / m) : 0;
    });
    this.corners = new Set(scene.boxes.flat());
    this.surfaces = scene.surfaces.map((each, k) => ({ mesh: `surface ${k}`, point: each.point, ...("tube" in each ? torus(poses.radii[each.point], each.tube) : convex(each)) }));
    const radii = [...this.surfaces.map((each) => each.extent), ...scene.points.map((_, k) => poses.radii[k]), ...scene.contacts.flatMap((each, c) => (each.spheres ? [...poses.contact_radii.subarray(2 * c, 2 * c + 2)] : []))];
    this.size = Math.max(length(add(high, low, -1)) / 2, 0.9 * Math.max(0, ...extents), 1.4 * Math.max(0, ...radii)) || 1;
    this.low = low;
    const gravity = column(poses.gravity, 0);
    this.weightless = length(gravity) === 0;
    const axes = scene.frames.map((frame, k) => (frame.joint === "revolute" ? column(poses.axes, k) : null)).filter(Boolean);
    const planar = axes.length > 0 && axes.every((axis) => Math.abs(dot(axis, axes[0])) > 0.999);
    this.across = planar ? axes[0] : null;  // the direction about which all joints turn
    this.up = !this.weightless ? unit(scaled(gravity, -1)) : planar && Math.abs(axes[0][2]) > 0.9 ? [0, 1, 0] : [0, 0, 1];
    this.round = new Map();  // frames that carry a disc, a sphere or another body that touches a plane
    scene.points.forEach((point, k) => (point.lowest || this.corners.has(k)) && this.round.set(point.frame, true));
    this.sortFrames();
    this.findTranslations();
    this.findRods(poses);
    this.findTraces();
    this.bulks = scene.bodies.map((each, k) => this.bulk(each, k, poses));
    this.framing = new Framing(this, middle);
    this.framing.include([poses]);
  }

  /// Corners of boxes around what the author of the scene shows, or of one body only.
  formCorners(poses, only = null) {
    const corners = [];
    for (const { mesh, x, y, z, origin, ends } of this.forms(poses, only)) {
      const [as, bs, cs] = ends ?? [[-1, 1], [-1, 1], mesh === "cylinder" || mesh === "cone" ? [0, 1] : [-1, 1]];
      for (const a of as) for (const b of bs) for (const c of cs) corners.push(add(add(add(origin, x, a), y, b), z, c));
    }
    return corners;
  }

  /// How far a body is drawn around its centre of mass.
  bulk(body, k, poses) {
    const rigid = this.scene.frames[body.frame].body, m = poses.masses[k], moments = poses.inertias.subarray(6 * k, 6 * k + 6);
    const own = (point) => this.scene.frames[this.scene.points[point].frame].body === rigid;
    const discs = this.scene.points.map((point, i) => (point.lowest && own(i) ? poses.radii[i] : 0));
    discs.push(...this.surfaces.filter(({ point }) => own(point)).map((each) => each.extent));
    for (const i of this.corners) if (own(i)) discs.push(length(add(column(poses.points, i), column(poses.centres, k), -1)));
    if (this.ofAuthor.has(rigid)) discs.push(...this.formCorners(poses, rigid).map((corner) => length(add(corner, column(poses.centres, k), -1))));
    if (this.ofAuthor.has(rigid) || this.linked.has(rigid) || !(m > 0) || this.round.get(body.frame)) return Math.max(0, ...discs);
    const trace = moments[0] + moments[1] + moments[2], { values } = principal(moments);
    const halves = values.map((value) => Math.sqrt(Math.max(0, (1.5 * (trace - 2 * value)) / m)));
    return Math.max(...discs, Math.min(1.2 * this.size, Math.max(...halves)));
  }

  /// Frames that move, by the rigid body at their end, outermost last.
  sortFrames() {
    const { frames } = this.scene, depth = (k) => (frames[k].parent < 0 ? 0 : 1 + depth(frames[k].parent));
    this.ofBody = new Map();
    frames.forEach((frame, k) => {
      if (frame.joint === "weld") return;
      if (!this.ofBody.has(frame.body)) this.ofBody.set(frame.body, []);
      this.ofBody.get(frame.body).push(k);
    });
    for (const list of this.ofBody.values()) list.sort((a, b) => depth(a) - depth(b));
  }

  /// Slides that follow each other without a mass between them are coordinates of one translation: they have no rails.
  findTranslations() {
    const { frames, bodies } = this.scene, slides = (k) => frames[k].joint === "prismatic" && frames[k].parent >= 0;
    this.massless = new Set(frames.map((frame) => frame.body));
    bodies.forEach((each) => this.massless.delete(frames[each.frame].body));
    this.translations = new Set();
    frames.forEach((frame, k) => {
      const before = slides(k) ? frames.findIndex((each, j) => slides(j) && each.body === frames[frame.parent].body) : -1;
      if (before >= 0 && this.massless.has(frames[before].body)) this.translations.add(k).add(before);
    });
  }

  findRods(poses) {
    const { scene, size } = this;
    this.rods = [];
    this.linked = new Set();  // bodies whose rods lead from joint to joint: they need no ellipsoid
    for (const [body, list] of this.ofBody) {
      if (body === 0 || this.ofAuthor.has(body)) continue;
      const main = list[list.length - 1], start = column(poses.origins, main), taken = [start];
      const join = (member, k, thick) => {
        const place = column(poses[member], k);
        if (taken.some((other) => length(add(place, other, -1)) < 1e-6 * size)) return;
        taken.push(place);
        this.rods.push({ body, main, member, k, thick });
        if (member === "anchors" || member === "origins") this.linked.add(body);
      };
      const { frames } = scene;
      frames.forEach((frame, k) => {
        const first = frame.parent >= 0 && frame.body !== body && frames[frame.parent].body === body;
        if (first && frame.joint !== "weld") join("anchors", k, true);
        if (frame.joint === "weld" && frame.body === body) join("origins", k, true);
      });
      scene.bodies.forEach((each, k) => frames[each.frame].body === body && join("centres", k, true));
      scene.points.forEach((each, k) => frames[each.frame].body === body && !each.lowest && !this.corners.has(k) && join("points", k, false));
    }
  }

  /// Named points that a body carries, else the centres of the outermost bodies.
  findTraces() {
    const { scene } = this, { frames } = scene;
    this.traced = scene.points.map((point, k) => ({ member: "points", k, body: frames[point.frame].body }))
      .filter((each) => each.body !== 0 && !this.corners.has(each.k));
    if (this.traced.length === 0) {
      const inner = new Set(frames.filter((frame) => frame.parent >= 0 && frames[frame.parent].body !== frame.body)
        .map((frame) => frames[frame.parent].body));
      scene.bodies.forEach((each, k) => {
        const body = frames[each.frame].body;
        if (body !== 0 && !inner.has(body)) this.traced.push({ member: "centres", k, body });
      });
    }
    this.traced = this.traced.slice(0, 8);
  }

  /// Velocities of the traced places, `rates` being those of the poses. The fastest that has been met is as long as a third
  /// of the picture.
  velocities(poses, rates) {
    const found = this.traced.map(({ member, k }) => [column(poses[member], k), column(rates[member], k)]);
    this.fastest = Math.max(this.fastest ?? 0, ...found.map(([, v]) => length(v)));
    if (!(this.fastest > 0)) return [];
    return found.flatMap(([place, v]) => arrow(place, scaled(v, (0.66 * this.size) / this.fastest), 0.01 * this.size, arrowColours.velocities));
  }

  /// Weights at the centres of mass; the greatest is as long as a quarter of the picture.
  weights(poses) {
    const gravity = column(poses.gravity, 0), greatest = Math.max(...poses.masses) * length(gravity);
    if (!(greatest > 0)) return [];
    return this.scene.bodies.flatMap((_, k) =>
      arrow(column(poses.centres, k), scaled(gravity, (0.5 * this.size * poses.masses[k]) / greatest), 0.01 * this.size, arrowColours.weights));
  }

  /// Forces of constraints by their multipliers, those at one place added; the greatest that has been met is as long as a
  /// quarter of the picture.
  reactions(poses, multipliers) {
    const found = [];
    multipliers.forEach((multiplier, k) => {
      const force = scaled(column(poses.reaction_forces, k), multiplier), place = column(poses.reaction_points, k);
      if (!(length(force) > 0)) return;
      const there = found.find((each) => length(add(each.place, place, -1)) < 1e-9 * this.size);
      if (there) there.force = add(there.force, force);
      else found.push({ place, force });
    });
    this.strongest = Math.max(this.strongest ?? 0, ...found.map(({ force }) => length(force)));
    if (!(this.strongest > 0)) return [];
    return found.flatMap(({ place, force }) => arrow(place, scaled(force, (0.5 * this.size) / this.strongest), 0.01 * this.size, arrowColours.reactions));
  }

  /// Forces N n + T t of contacts on the first of their bodies, at the points of contact; the same scale.
  contactForces(poses, contacts, reactionsOf) {
    const found = contacts.map(({ row }, c) => {
      const force = Array.from(reactionsOf(c)).reduce((sum, value, i) => add(sum, column(poses.contact_directions, row + i), value), [0, 0, 0]);
      return { place: column(poses.contact_points, c), force };
    }).filter(({ force }) => length(force) > 0);
    this.strongest = Math.max(this.strongest ?? 0, ...found.map(({ force }) => length(force)));
    return found.flatMap(({ place, force }) => arrow(place, scaled(force, (0.5 * this.size) / this.strongest), 0.01 * this.size, arrowColours.reactions));
  }

  /// Shapes and lines of one pose; `traces` are lists of places.
  at(poses, traces, target = this.framing.middle) {
    const { scene, size } = this, shapes = [], lines = [];
    this.joints(poses, shapes);
    for (const rod of this.rods) {
      const from = column(poses.origins, rod.main), to = column(poses[rod.member], rod.k);
      if (length(add(to, from, -1)) > 1e-9 * size) shapes.push(cylinder(from, to, (rod.thick ? 0.02 : 0.008) * size, colourOf(rod.body)));
      if (rod.member === "points") shapes.push(ball(to, 0.018 * size, colourOf(rod.body)));
    }
    shapes.push(...this.forms(poses));
    scene.bodies.forEach((each, k) => this.inertia(each, k, poses, shapes));
    scene.points.forEach((each, k) => each.lowest && this.rim(each, k, poses, shapes, lines));
    this.surfaces.forEach((each) => this.surface(each, poses, shapes, lines));
    scene.boxes.forEach((corners) => this.box(corners, poses, shapes));
    scene.contacts.forEach((contact, c) => contact.spheres && this.spheres(contact, c, poses, shapes, lines));
    for (const link of scene.links) this.link(link, poses, shapes, lines);
    this.grid(poses, lines, target);
    traces.forEach((points, i) => points.length > 3 && lines.push({ points, colour: scaled(add([0.25, 0.25, 0.25], colourOf(this.traced[i].body), 0.75), 1) }));
    return { shapes, lines };
  }

  /// What the author of the scene shows.
  forms(poses, only = null) {
    const shown = this.shown.filter(({ frame }) => only === null || this.scene.frames[frame].body === only);
    return shown.flatMap((form) => {
      const { frame, kind, rotation, k } = form, colour = form.colour ?? colourOf(this.scene.frames[frame].body);
      const axes = [0, 1, 2].map((j) => column(poses.rotations, 3 * frame + j));
      const inGround = (v) => add(add(scaled(axes[0], v[0]), axes[1], v[1]), axes[2], v[2]);
      const [x, y, z] = [0, 1, 2].map((j) => inGround(column(rotation, j)));
      const turned = (v) => add(add(scaled(x, v[0]), y, v[1]), z, v[2]);
      const origin = add(column(poses.origins, frame), inGround(column(poses.form_origins, k)));
      const [a, b, c, d] = poses.form_lengths.subarray(4 * k, 4 * k + 4);
      if (kind === "box") return [{ mesh: "box", x: scaled(x, a / 2), y: scaled(y, b / 2), z: scaled(z, c / 2), origin, colour }];
      if (kind === "sphere") return [ball(origin, a, colour)];
      if (kind === "segment") return length([a, b, c]) > 0 ? [cylinder(origin, add(origin, turned([a, b, c])), d, colour)] : [];
      if (kind === "torus") return [{ mesh: form.mesh, x: scaled(x, a), y: scaled(y, a), z: scaled(z, a), origin, colour, ends: form.ends }];
      if (kind === "mesh") {
        const [p, q, r] = form.scale;
        return [{ mesh: form.mesh, x: scaled(x, p), y: scaled(y, q), z: scaled(z, r), origin, colour, ends: form.ends }];
      }
      return [{ mesh: kind, x: scaled(x, a), y: scaled(y, a), z: scaled(z, b), origin: kind === "cylinder" ? add(origin, z, -b / 2) : origin, colour }];
    });
  }

  joints(poses, shapes) {
    const { size } = this;
    for (const [body, list] of this.ofBody) {
      if (this.ofAuthor.has(body)) continue;
      for (const k of list) {
        const frame = this.scene.frames[k], origin = column(poses.origins, k), axis = column(poses.axes, k);
        if (frame.joint === "revolute" && list.length <= 3) {
          shapes.push(cylinder(add(origin, axis, -0.045 * size), add(origin, axis, 0.045 * size), 0.028 * size, steel));
        } else if (frame.joint === "prismatic" && list.length <= 2) {
          const anchor = column(poses.anchors, k), [x, y] = triad(axis), half = 0.05 * size, alone = !this.translations.has(k);
          if (alone) {
            const far = dot(add(origin, anchor, -1), axis), [low, high] = [Math.min(-0.9 * size, far), Math.max(0.9 * size, far)];
            shapes.push(cylinder(add(anchor, axis, low), add(anchor, axis, high), 0.008 * size, steel));
          }
          if (alone || !this.massless.has(body)) shapes.push({ mesh: "box", x: scaled(x, half), y: scaled(y, half), z: scaled(axis, 1.5 * half), origin, colour: colourOf(body) });
        } else if (frame.joint === "attitude") {
          shapes.push(ball(origin, 0.035 * size, steel));
        }
      }
    }
  }

  /// The ellipsoid with the same mass and moments, in the proportion in which a rod's is as long as the rod.
  inertia(body, k, poses, shapes) {
    const rigid = this.scene.frames[body.frame].body, colour = colourOf(rigid), centre = column(poses.centres, k);
    const m = poses.masses[k];
    if (this.ofAuthor.has(rigid)) return;
    if (this.round.get(body.frame) || !(m > 0)) return;
    const { values, axes } = principal(poses.inertias.subarray(6 * k, 6 * k + 6));
    const trace = values[0] + values[1] + values[2];
    if (!(trace > 0) || this.linked.has(rigid)) {
      shapes.push(ball(centre, (trace > 0 ? 0.035 : 0.05) * this.size, colour));
      return;
    }
    const rotation = [0, 1, 2].map((j) => column(poses.rotations, 3 * body.frame + j));
    const turned = (v) => add(add(scaled(rotation[0], v[0]), rotation[1], v[1]), rotation[2], v[2]);
    const [x, y, z] = axes.map((axis, i) => {
      const half = Math.sqrt(Math.max(0, (1.5 * (trace - 2 * values[i])) / m));
      return scaled(turned(axis), Math.min(1.2 * this.size, Math.max(0.03 * this.size, half)));
    });
    shapes.push({ mesh: "sphere", x, y, z, origin: centre, colour });
  }

  /// A disc, or a sphere, that touches a plane: with spokes, which show how it turns.
  rim(point, k, poses, shapes, lines) {
    const radius = poses.radii[k], frame = point.frame, colour = colourOf(this.scene.frames[frame].body);
    if (!(radius > 0)) return;
    const origin = column(poses.origins, frame), axis = column(poses.rims, k);
    const [x, y, z] = [0, 1, 2].map((j) => column(poses.rotations, 3 * frame + j));
    if (length(axis) === 0) {
      shapes.push(ball(origin, radius, colour));
      for (const [u, v] of [[x, y], [y, z], [z, x]]) lines.push({ points: circle(origin, scaled(u, 1.01 * radius), scaled(v, 1.01 * radius)), colour: steel });
      return;
    }
    const n = unit(axis), half = 0.012 * this.size;
    shapes.push(cylinder(add(origin, n, -half), add(origin, n, half), radius, colour));
    const across = [x, y, z].reduce((best, v) => (Math.abs(dot(v, n)) < Math.abs(dot(best, n)) - 1e-9 ? v : best));
    const spoke = unit(add(across, n, -dot(across, n))), other = cross(n, spoke);
    for (const [u, v] of [[spoke, other], [other, spoke]]) {
      shapes.push({ mesh: "box", x: scaled(u, 0.96 * radius), y: scaled(v, 0.02 * radius), z: scaled(n, 1.6 * half), origin, colour: steel });
    }
  }

  /// A convex body or a torus that touches a plane, and lines on it, which show how it turns.
  surface({ mesh, point, lines: drawn }, poses, shapes, lines) {
    const { frame } = this.scene.points[point], rigid = this.scene.frames[frame].body, origin = column(poses.origins, frame);
    if (this.ofAuthor.has(rigid)) return;
    const rim = column(poses.rims, point);
    const [x, y, z] = length(rim) > 0 ? triad(rim) : [0, 1, 2].map((j) => column(poses.rotations, 3 * frame + j));
    shapes.push({ mesh, x, y, z, origin, colour: colourOf(rigid) });
    for (const line of drawn) lines.push({ points: line.flatMap((v) => add(add(add(origin, x, v[0]), y, v[1]), z, v[2])), colour: steel });
  }

  /// A box of which corners touch a plane.
  box(corners, poses, shapes) {
    const { frame } = this.scene.points[corners[0]], rigid = this.scene.frames[frame].body;
    if (this.ofAuthor.has(rigid)) return;
    const axes = [0, 1, 2].map((j) => column(poses.rotations, 3 * frame + j));
    shapes.push({ ...boxAround(corners.map((k) => column(poses.points, k)), axes, 0.01 * this.size), colour: colourOf(rigid) });
  }

  /// Two spheres that touch, but for what is drawn already; of a hollow one three circles.
  spheres({ spheres, hollow }, c, poses, shapes, lines) {
    spheres.forEach((frame, i) => {
      const radius = poses.contact_radii[2 * c + i], body = this.scene.frames[frame].body, origin = column(poses.origins, frame);
      const drawn = this.ofAuthor.has(body) || this.round.get(frame);
      const first = this.scene.contacts.findIndex((each) => each.spheres?.includes(frame)) === c;
      if (drawn || !first || !(radius > 0)) return;
      if (!(hollow && i === 1)) return void shapes.push(ball(origin, radius, colourOf(body)));
      const [x, y, z] = [0, 1, 2].map((j) => scaled(column(poses.rotations, 3 * frame + j), radius));
      for (const [u, v] of [[x, y], [y, z], [z, x]]) lines.push({ points: circle(origin, u, v), colour: colourOf(body) });
    });
  }

  link(link, poses, shapes, lines) {
    const a = column(poses.points, link.a), b = column(poses.points, link.b), along = add(b, a, -1), far = length(along);
    if (!(far > 1e-9 * this.size)) return;
    if (link.kind === "damper") {
      shapes.push(cylinder(a, add(a, along, 0.6), 0.02 * this.size, steel), cylinder(a, b, 0.007 * this.size, steel));
    } else if (link.kind === "attraction") {
      lines.push({ points: [...a, ...b], colour: steel });
    } else {
      const [x, y] = triad(along), points = [], turns = 10, radius = 0.03 * this.size;
      for (let i = 0; i <= 200; ++i) {
        const angle = (2 * Math.PI * turns * i) / 200, edge = i < 10 || i > 190 ? 0 : radius;
        points.push(...add(add(add(a, along, i / 200), x, edge * Math.cos(angle)), y, edge * Math.sin(angle)));
      }
      lines.push({ points, colour: [0.7, 0.45, 0.1] });
    }
  }

  /// The planes on which the mechanism rolls; else a floor across gravity below the first pose, or, without gravity, the
  /// plane in which a mechanism moves.
  grid(poses, lines, target) {
    const { frames, points, contacts } = this.scene;
    const planes = [...new Set([...points.filter((each) => each.lowest), ...contacts.filter((each) => each.plane !== undefined)].map((each) => each.plane))];
    const put = (origin, x, y) => {
      const points = [], step = niceStep(this.framing.reach / 2.5), count = 6;
      for (const axis of [x, y]) {  // under the camera's target, on lines of the same grid
        origin = add(origin, axis, step * Math.round(dot(add(target, origin, -1), axis) / step));
      }
      for (let i = -count; i <= count; ++i) {
        for (const [u, v] of [[x, y], [y, x]]) {
          points.push(...add(add(origin, u, i * step), v, -count * step), ...add(add(origin, u, i * step), v, count * step));
        }
      }
      lines.push({ points, colour: [0.62, 0.64, 0.67], pairs: true });
    };
    const fixed = planes.filter((plane) => frames[plane].body === 0);
    for (const plane of fixed) put(column(poses.origins, plane), column(poses.rotations, 3 * plane), column(poses.rotations, 3 * plane + 1));
    for (const plane of planes) if (!fixed.includes(plane)) this.patch(plane, poses, lines);
    if (fixed.length > 0) return;
    if (this.weightless && this.across) {
      put(add(this.framing.middle, this.framing.side(), -0.06 * this.size), ...triad(this.across));
    } else {
      put(add(this.framing.middle, this.up, -1.05 * this.size), ...triad(this.up));
    }
  }

  /// A piece of a plane that moves with a body, as far as its contacts reach at first.
  patch(plane, poses, lines) {
    const origin = column(poses.origins, plane), [x, y] = [0, 1].map((j) => column(poses.rotations, 3 * plane + j)), points = [];
    this.patches ??= new Map();
    if (!this.patches.has(plane)) {
      const reaches = this.scene.contacts.map((each, c) => (each.plane === plane ? length(add(column(poses.contact_points, c), origin, -1)) : 0));
      this.patches.set(plane, Math.min(this.size, 1.2 * Math.max(0.25 * this.size, ...reaches)));
    }
    const half = this.patches.get(plane), count = 4;
    for (let i = -count; i <= count; ++i) {
      for (const [u, v] of [[x, y], [y, x]]) {
        const from = add(origin, u, (i * half) / count);
        points.push(...add(from, v, -half), ...add(from, v, half));
      }
    }
    lines.push({ points, colour: [0.62, 0.64, 0.67], pairs: true });
  }
}

/// Tells the forms of a scene which mesh each is, and returns the corners of the meshes with their normals, by name.
function readMeshes(scene, { meshes, forms }) {
  forms.forEach((each, k) => each && Object.assign(scene.forms[k], { mesh: `mesh ${each.mesh}`, scale: each.scale, ends: [0, 1, 2].map((i) => [meshes[each.mesh].low[i], meshes[each.mesh].high[i]]) }));
  const numbers = (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    return Array.from({ length: bytes.length / 2 }, (_, i) => bytes[2 * i] + 256 * bytes[2 * i + 1]);
  };
  return meshes.map(({ low, high, corners, triangles }, m) => {
    const shares = numbers(corners), flat = [];
    const corner = (k) => low.map((from, i) => from + ((high[i] - from) * shares[3 * k + i]) / 65535);
    const order = numbers(triangles);
    for (let k = 0; k < order.length; k += 3) {
      const [a, b, c] = [corner(order[k]), corner(order[k + 1]), corner(order[k + 2])];
      const across = cross(add(b, a, -1), add(c, a, -1)), normal = length(across) > 0 ? unit(across) : [0, 0, 1];
      flat.push(...a, ...normal, ...b, ...normal, ...c, ...normal);
    }
    return [`mesh ${m}`, new Float32Array(flat)];
  });
}

function circle(origin, u, v) {
  const points = [];
  for (let i = 0; i <= 48; ++i) points.push(...add(add(origin, u, Math.cos((Math.PI * i) / 24)), v, Math.sin((Math.PI * i) / 24)));
  return points;
}

/// 1, 2 or 5 times a power of ten, near the given length. Along nothing there is no second line: the step is infinite.
function niceStep(wanted) {
  if (!(wanted > 0)) return Infinity;
  const power = 10 ** Math.floor(Math.log10(wanted)), rest = wanted / power;
  return power * (rest < 1.5 ? 1 : rest < 3.5 ? 2 : rest < 7.5 ? 5 : 10);
}

Object.assign(torsorReport, { Picture, readMeshes, column, niceStep, palette });
})();
