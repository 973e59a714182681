// SPDX-License-Identifier: GPL-3.0-or-later
// motion.mjs PROGRAM NAME REFERENCE FOLDER: the integrator of a report's page, run here, ends where the reference motion in
// 40 digits does, and a parameter that is changed changes the motion.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import vm from "node:vm";

const [program, name, reference, folder] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const file = join(folder, `${name}.html`);
execFileSync(program, ["report", "--output", file]);
const page = readFileSync(file, "utf8");

const context = vm.createContext({});
for (const id of ["mechanism", "script-integrator", "script-projection", "script-motion", "script-modes", "script-vectors", "script-surfaces", "script-framing", "script-shapes", "script-viewer"]) {
  vm.runInContext(new RegExp(`<script id="${id}">\n([^]*?)</script>`).exec(page)[1], context);
}
const { torsorMechanism: mechanism, torsorReport } = context;
const failures = [];

const [header, ...rows] = readFileSync(reference, "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
const columns = header.split(",").length - 1;
const motion = new torsorReport.Motion(mechanism);
let worst = 0;
for (const row of rows) {
  const [time, ...wanted] = row.split(",").map(Number);
  if (!motion.integrator.advance(time)) {
    failures.push(`the motion ended: ${motion.integrator.status}`);
    break;
  }
  if (motion.integrator.y.length !== columns) failures.push(`${columns} columns for ${motion.integrator.y.length} numbers`);
  wanted.forEach((value, i) => { worst = Math.max(worst, Math.abs(motion.integrator.y[i] - value) / Math.max(1, Math.abs(value))); });
}
// Steps keep 1e-12 each; there are at most a thousand of them.
if (!(worst < 1e-9)) failures.push(`the end is off by ${worst}`);

const parameter = mechanism.parameters.find((each) => each.name === "g" || each.name.startsWith("m")) ?? mechanism.parameters[0];
if (parameter) {
  const place = mechanism.parameters.indexOf(parameter);
  const other = new torsorReport.Motion(mechanism, { parameters: { [parameter.name]: 1.1 * motion.parameters[place] } });
  if (other.status === "ok" && other.parameters[place] === motion.parameters[place]) failures.push("a parameter was not set");
}
// A coordinate and its velocity have one name, and start where each is told to.
const [first] = mechanism.coordinates;
if (first && mechanism.multipliers.length === 0 && mechanism.quaternions.length === 0) {
  const other = new torsorReport.Motion(mechanism, { start: { [first.name]: 0.125 }, speeds: { [first.name]: 0.5 } });
  if (other.start[0] !== 0.125 || other.start[other.nq] !== 0.5) failures.push("start values are not what was asked for");
}
// Two equal bars without mass, absolute angles: omega^2 = (2 -+ sqrt 2) g/l hanging, the opposite standing. Differences over
// h = 1e-5 (1 + q) are off by h^2/6, at 4 rad 4e-10 of the stiffness, and by 1e-16/h of rounding.
if (name === "double_pendulum") {
  for (const [start, sign] of [[[0.2, -0.1], 1], [[3.1, 3.2], -1]]) {
    const small = new torsorReport.SmallMotions(new torsorReport.Motion(mechanism), start);
    const squares = small.modes.map(({ square }) => (sign * square) / 9.81).sort((a, b) => a - b);
    const wanted = [2 - Math.SQRT2, 2 + Math.SQRT2];
    if (squares.length !== 2 || squares.some((each, i) => Math.abs(each - wanted[i]) > 1e-8)) failures.push(`modes are ${squares}: ${small.why}`);
    const rest = sign > 0 ? 0 : Math.PI;
    if (small.q.some((angle) => Math.abs(angle - rest) > 1e-8)) failures.push(`the rest is ${small.q}`);
    // The slow mode of hanging bars: both the same way, as 1 to sqrt 2.
    const slow = small.modes[sign > 0 ? 0 : 1]?.shape ?? [];
    if (!(Math.abs(slow[1] / slow[0] - Math.SQRT2) < 1e-8)) failures.push(`the slow mode is ${slow}`);
  }
}
// The upright bicycle at rest falls with the roots of Meijaard, Papadopoulos, Ruina and Schwab (Proc. R. Soc. A 463, 2007).
if (name === "whipple_bicycle") {
  const start = new torsorReport.Motion(mechanism), small = new torsorReport.SmallMotions(start, start.samples[0].slice(0, start.nq));
  const rates = small.modes.filter(({ square, neutral }) => !neutral && square < 0).map(({ square }) => Math.sqrt(-square));
  const wanted = [5.53094371765393, 3.13164324790656];
  if (rates.length !== 2 || rates.some((each, i) => Math.abs(each - wanted[i]) > 1e-6)) failures.push(`it falls with ${rates}: ${small.why}`);
  if (small.zeroRoots !== 4) failures.push(`rolling leaves ${small.zeroRoots} zero roots`);
}
// A hoop that stands: (A + m R^2) theta'' = m g R theta with A = m R^2/2. It turns about its contact and rolls for nothing.
if (name === "rolling_hoop") {
  const small = new torsorReport.SmallMotions(new torsorReport.Motion(mechanism), [0, 0, 0, 1.3, 0]), [falls, ...rest] = small.modes;
  if (!(Math.abs(falls?.square + 9.81 / 1.5) < 1e-7)) failures.push(`it falls with ${falls?.square}: ${small.why}`);
  if (rest.length !== 2 || !rest.every(({ neutral }) => neutral) || small.zeroRoots !== 2) failures.push(`${rest.length} modes more, ${small.zeroRoots} zero roots`);
}
// The first view holds every ellipsoid of inertia, disc and ball, on a wide screen and on a narrow one.
const poses = new torsorReport.Motion(mechanism).evaluate("poses", 0);
const picture = new torsorReport.Picture(JSON.parse(/<script id="scene" type="application\/json">(.*?)<\/script>/.exec(page)[1]), poses);
const { dot, add, cross, unit } = torsorReport.vectors;
for (const canvas of [{ clientWidth: 850, clientHeight: 470 }, { clientWidth: 330, clientHeight: 480 }]) {
  const viewer = Object.assign(Object.create(torsorReport.Viewer.prototype), { canvas });
  viewer.home(picture.framing.camera());
  const view = viewer.towardsEye(), across = unit(cross(viewer.up, view)), upwards = cross(view, across);
  const half = Math.tan(0.35), aspect = canvas.clientWidth / canvas.clientHeight;
  for (const { origin, x, y, z } of picture.at(poses, []).shapes.filter((each) => each.mesh === "sphere")) {
    const from = add(origin, viewer.target, -1), radius = Math.max(...[x, y, z].map((axis) => Math.hypot(...axis)));
    const depth = viewer.distance - dot(from, view);
    const beyond = Math.max((Math.abs(dot(from, across)) + radius) / aspect, Math.abs(dot(from, upwards)) + radius) / (half * depth);
    if (!(depth > 0 && beyond < 1)) failures.push(`a ball of radius ${radius} reaches ${beyond} times the half picture of ${canvas.clientWidth} pixels`);
  }
}

if (page.length > 1.2e6) failures.push(`the page has ${page.length} characters`);
console.log(`${name}: ${rows.length} times, off by ${worst}, ${motion.integrator.steps} steps, ${page.length} characters`);
for (const each of failures) console.error(each);
process.exit(failures.length > 0 ? 1 : 0);
