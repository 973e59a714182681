// SPDX-License-Identifier: MIT-0
// What a picture shows of the space around a mechanism: its middle, how far it reaches, and where the camera stands.
(() => {
"use strict";
const { add, column, scaled, cross, dot, length, triad } = torsorReport.vectors;

class Framing {
  /// Around what the picture shows at its first pose, whose middle is given.
  constructor(picture, middle) {
    Object.assign(this, { picture, middle, reach: picture.size, places: null });
  }

  /// The middle of everything in some poses and how far it reaches from there, unless it runs away.
  include(allPoses) {
    const { scene, size, bulks, traced } = this.picture, apart = scene.bodies.length > 1 ? 2.5 : 4, places = [];
    let low = [Infinity, Infinity, Infinity], high = low.map((v) => -v), reach = 0;
    const take = (place, bulk = 0) => {
      const radius = Math.max(bulk, 0.08 * size);  // of pins and blocks
      places.push([place, radius]);
      low = low.map((v, i) => Math.min(v, place[i] - radius));
      high = high.map((v, i) => Math.max(v, place[i] + radius));
    };
    for (const poses of allPoses) {
      scene.bodies.forEach((_, k) => take(column(poses.centres, k), bulks[k]));
      scene.frames.forEach((_, k) => take(column(poses.anchors, k)));
      scene.points.forEach((_, k) => take(column(poses.points, k)));
      this.picture.formCorners(poses).forEach((place) => take(place));
      traced.forEach((each) => take(column(poses[each.member], each.k)));
      if (apart < 4 && length(add(high, low, -1)) / 2 > apart * size) break;  // bodies that part: their beginning
    }
    const middle = scaled(add(low, high), 0.5);
    for (const [place, radius] of places) reach = Math.max(reach, length(add(place, middle, -1)) + radius);
    if (!(reach < 4 * size)) return;
    const beside = Math.max(0.3 * size, 1.3 * Math.max(0, ...bulks));  // what rolls needs its plane beside it
    Object.assign(this, { middle, reach: Math.max(reach, beside), places: [...places, [middle, beside]] });
    this.comeNear(allPoses[0]);
  }

  /// Bodies may be tiny beside the way that they go: they are then seen from near, and followed.
  comeNear(poses) {
    const { scene, bulks, rods } = this.picture, apart = (a, b) => length(add(a, b, -1));
    const drawn = Math.max(...bulks,
      ...rods.map((rod) => apart(column(poses.origins, rod.main), column(poses[rod.member], rod.k))),
      ...scene.links.map(({ a, b }) => apart(column(poses.points, a), column(poses.points, b))),
      ...this.picture.formCorners(poses).map((corner) => apart(corner, column(poses.centres, 0))));
    if (!(7 * drawn < this.reach) || bulks.every((bulk) => bulk === 0)) return;
    const centres = scene.bodies.map((_, k) => column(poses.centres, k));
    const middle = scaled(centres.reduce((sum, centre) => add(sum, centre), [0, 0, 0]), 1 / centres.length);
    Object.assign(this, { middle, reach: 7 * drawn, places: null });
  }

  /// Where the camera looks: it follows a mechanism that leaves the view as far as it must, without what has left it.
  followed(poses, target) {
    const { scene, bulks } = this.picture, all = scene.bodies.map((_, k) => ({ place: column(poses.centres, k), bulk: bulks[k] }));
    if (all.length === 0) return target;
    const far = ({ place }) => length(add(place, target, -1));
    const middle = (some) => scaled(some.reduce((sum, { place }) => add(sum, place), [0, 0, 0]), 1 / some.length);
    const fit = (some) => {
      const centre = middle(some);
      return some.every(({ place, bulk }) => length(add(place, centre, -1)) + bulk <= this.reach);
    };
    // Bodies that part do not fit the picture: those that are nearest stay in it.
    const seen = all.sort((a, b) => far(a) - far(b)).reduce((some, each) => (some.length === 0 || fit([...some, each]) ? [...some, each] : some), []);
    const beyond = Math.max(...seen.map((each) => far(each) + each.bulk)) - this.reach;
    if (!(beyond > 0)) return target;
    const away = add(middle(seen), target, -1);
    return add(target, away, Math.min(1, beyond / Math.max(length(away), 1e-300)));
  }

  /// The side of a plane of motion from which it is seen: from above, the front or the right.
  side() {
    const { across } = this.picture;
    return scaled(across, across[2] > 0.5 || across[1] < -0.5 || across[0] < -0.5 ? 1 : -1);
  }

  /// Where a camera sees the most: across the axes where all joints turn about one direction.
  camera() {
    const { up, across } = this.picture, [x, y] = triad(up);
    let from = add(add(scaled(x, 0.5), y, -1), up, 0.5);
    if (across && Math.abs(dot(across, up)) < 0.1) {
      const towards = this.side();
      from = add(add(towards, up, 0.25), cross(up, towards), 0.35);
    }
    return { target: this.middle, up, from, size: 1.1 * this.reach, places: this.places };
  }
}

torsorReport.framing = { Framing };
})();
