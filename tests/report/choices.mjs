// SPDX-License-Identifier: GPL-3.0-or-later
// choices.mjs PROGRAMS FOLDER: what a page makes of laws of time, of parameters that follow others or have no value, and of
// start values that constraints do not allow; modes with constraints and attitudes. PROGRAMS is the folder of shaken_scene,
// following_scene, elastic_scene, four_bar_scene, crank_rocker_scene, skate_scene, floating_scene and rising_scene.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import vm from "node:vm";

const [programs, folder] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const failures = [];
const expect = (holds, words) => { if (!holds) failures.push(words); };
const near = (values, wanted, off) => wanted.every((value, i) => Math.abs(values[i] - value) <= off);

/// The page of a scene: its text, what its scripts leave, what it was given.
function opened(name, ...options) {
  const file = join(folder, `${name}.html`);
  execFileSync(join(programs, `${name}_scene`), ["report", "--output", file, ...options]);
  const text = readFileSync(file, "utf8"), context = vm.createContext({});
  const scripts = ["integrator", "projection", "motion", "modes", "vectors", "surfaces", "framing", "shapes"];
  for (const id of ["mechanism", ...scripts.map((name) => `script-${name}`)]) {
    vm.runInContext(new RegExp(`<script id="${id}">\n([^]*?)</script>`).exec(text)[1], context);
  }
  const given = /<script id="given" type="application\/json">(.*?)<\/script>/.exec(text);
  const scene = JSON.parse(/<script id="scene" type="application\/json">(.*?)<\/script>/.exec(text)[1]);
  return { text, scene, mechanism: context.torsorMechanism, ...context.torsorReport, given: given && JSON.parse(given[1]) };
}

{  // Mathieu's equation: where the pendulum hangs nothing accelerates it at any time, and yet there are no modes.
  const { mechanism, Motion, SmallMotions } = opened("shaken"), small = new SmallMotions(new Motion(mechanism), [0]);
  expect(small.modes.length === 0 && small.why.includes("time enters"), `modes of a shaken pendulum: ${small.why}`);
}
{  // k = 4: x'' = 4 x - x', of which r^2 + r - 4 = 0 has the roots (-1 +- sqrt 17)/2. A slip of 1e-12 a step grows as x does.
  const { text, mechanism, Motion, SmallMotions } = opened("following"), motion = new Motion(mechanism, { parameters: { k: 4 } });
  while (motion.time < 2 - 1e-9 && motion.extend());
  const [r, s] = [1, -1].map((sign) => (-1 + sign * Math.sqrt(17)) / 2), wanted = (s * Math.exp(2 * r) - r * Math.exp(2 * s)) / (s - r);
  expect(near(motion.samples[120], [wanted], 1e-9), `x(2) = ${motion.samples[120][0]} instead of ${wanted}`);
  expect(mechanism.parameters.map(({ name }) => name).join() === "m,k,c", "what follows has a slider");
  expect(/take[s]? 1 for them[^<]*: m\./.test(text), "the page does not say that m has no value");
  // As the scene states it: k - b = 1/2 N/m.
  const { modes } = new SmallMotions(new Motion(mechanism), [0.1]);
  expect(modes.length === 1 && Math.abs(modes[0].square - 0.5) < 1e-8, `a mode is lost: ${modes.length}`);
}
{  // omega^2 = g/l and k/m; two of the names, of what is not asked for, are those of every object. Differences over 1e-5.
  const { mechanism, Motion, SmallMotions } = opened("elastic"), motion = new Motion(mechanism);
  expect(near(motion.samples[0], [0.5, 0, 0, 0], 0) && motion.parameters[0] === 1, `it starts at ${motion.samples[0]} with ${motion.parameters}`);
  const small = new SmallMotions(motion, [0.5, 0]), squares = small.modes.map(({ square }) => square);
  expect(near(small.q, [0, 9.81 / 2e9], 1e-8), `a rest at ${small.q}: ${small.why}`);
  expect(squares.length === 2 && near([squares[0] / 9.81, squares[1] / 2e9], [1, 1], 1e-6), `omega^2 = ${squares}`);
  expect(small.modes.every(({ neutral }) => !neutral), "its swing is neutral");
}
{  // A parallelogram is closed where b = -a and c = a.
  const { mechanism, Motion, SmallMotions, given } = opened("four_bar", "--initial", "a=1");
  const start = (options) => new Motion(mechanism, options), closed = [1, -1, 1, 0, 0, 0];
  expect(near(given.closed, closed, 1e-14), `the page is given the start ${given.closed}`);
  expect(near(start({ start: given.initial, closed: given.closed }).samples[0], closed, 1e-14), "the page starts elsewhere than simulate");
  const held = start({ start: { a: 1 }, speeds: { a: 2 } });
  expect(near(held.samples[0], [1, -1, 1, 2, -2, 2], 1e-13) && held.moved.length === 0, `what is asked for moves: ${held.samples[0]}`);
  const late = start({ start: { a: 1, b: -0.5 }, latest: "b" });
  expect(near(late.samples[0], [0.5, -0.5, 0.5, 0, 0, 0], 1e-13), `the slider that was moved last does not stay: ${late.samples[0]}`);
  expect(late.moved.length === 1 && late.moved[0].name === "a" && late.moved[0].asked === 1, "the page does not know that a moved");
  // Bars hang and the one across does not turn: 2 m l^2/3 + m l^2 is its inertia, 2 m l g its stiffness.
  const small = new SmallMotions(new Motion(mechanism), closed.slice(0, 3)), square = 1.2 * 9.81;
  expect(near(small.q, [0, 0, 0], 1e-9) && small.modes.length === 1, `a parallelogram rests at ${small.q}: ${small.why}`);
  expect(near(small.modes.map((mode) => mode.square), [square], 1e-8), `its omega^2 is ${small.modes[0]?.square} instead of ${square}`);
  const shape = small.modes[0].shape, pose = small.posed(shape.map((value) => 0.4 * value / shape[0]));
  expect(Math.abs(pose[0] + pose[1]) < 1e-12 && Math.abs(pose[0] - pose[2]) < 1e-12 && small.zeroRoots === 0, `a mode opens the loop: ${pose}`);
}
{  // U(turn) with the loop closed for each angle, its second derivative by differences in 40 digits, over the inertia reduced to turn.
  const { mechanism, Motion, SmallMotions } = opened("crank_rocker"), motion = new Motion(mechanism);
  const small = new SmallMotions(motion, motion.samples[0].slice(0, 3)), [mode] = small.modes;
  expect(near(small.q, [-1.455408998584992, -0.5200434287409246, -1.683625870840726], 1e-9), `it hangs at ${small.q}: ${small.why}`);
  expect(small.modes.length === 1 && Math.abs(mode.square - 8.4750787224662) < 1e-8, `it swings with omega^2 = ${mode?.square}`);
}
{  // K/(J + m a^2) and k/m: the edge takes y along with the heading, and leaves a zero root. c/(2 sqrt(k m)) is the damping ratio.
  const { scene, mechanism, Motion, Picture, SmallMotions } = opened("skate"), small = new SmallMotions(new Motion(mechanism), [0.1, 0.3, 0.2]);
  const [turns, runs] = small.modes;
  expect(near(small.modes.map(({ square }) => square), [9, 25], 1e-7) && small.zeroRoots === 1, `a skate has ${small.modes.map(({ square }) => square)}, ${small.zeroRoots} zero roots: ${small.why}`);
  // A small box is drawn of it, and no ellipsoid of its inertia, which would reach 0.6 m.
  const { size } = new Picture(scene, new Motion(mechanism).evaluate("poses", 0));
  expect(size < 0.4, `a picture of 0.6 m is ${2 * size} m wide`);
  expect(Math.abs(turns.shape[1] - 0.5 * turns.shape[2]) < 1e-9 && turns.damping === 0, `it turns as ${turns.shape}`);
  expect(Math.abs(runs.damping - 0.05) < 1e-6 && SmallMotions.words(runs) === "0.7958 Hz (5.0000 rad/s), damping ratio 0.0500", SmallMotions.words(runs));
  const creeps = SmallMotions.words({ ...runs, damping: 1.25 });
  expect(creeps === "does not swing, comes back slowly; damping ratio 1.25", creeps);
}
{  // m g l over the moments of inertia about the point that holds it, and no force about the vertical.
  const { mechanism, Motion, SmallMotions } = opened("floating"), tilted = [Math.cos(0.2), Math.sin(0.2) * 0.6, Math.sin(0.2) * 0.8, 0];
  const small = new SmallMotions(new Motion(mechanism), tilted), squares = small.modes.map(({ square }) => square);
  expect(near(squares, [0, 9.81 / 0.8, 9.81 / 0.7], 1e-7) && squares.length === 3 && small.modes[0].neutral, `a hanging body has ${squares}: ${small.why}`);
}
{  // A speed that rises within a step: the integral of the law is known by its symmetry. One that jumps ends the motion.
  const { mechanism, Motion, Integrator } = opened("rising");
  for (const interval of [1, 0.3, 0.25]) {
    const motion = new Motion(mechanism, { interval });
    while (motion.time < 0.9 - 1e-9 && motion.extend());
    const after = motion.samples.at(-1)[0] - (motion.time - 0.5);
    expect(motion.status === "ok" && Math.abs(after) < 1e-9,
           `rows each ${interval} s: ${motion.status}, off by ${after} at ${motion.time}`);
  }
  const slope = (t, [, speed], rates) => { rates.set([speed, 0]); return true; };
  const settle = (t, y) => { y[1] = t < 0.5 ? 0 : 1; return true; };
  const jumping = new Integrator(slope, 0, [0, 0], { settle });
  expect(!jumping.advance(1) && Math.abs(jumping.t - 0.5) < 1e-12, `a jump ends at ${jumping.t}: ${jumping.status}`);
}

for (const each of failures) console.error(each);
process.exit(failures.length > 0 ? 1 : 0);
