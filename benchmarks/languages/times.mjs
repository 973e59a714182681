// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds of a call in JavaScript.
import * as robot from "./robot.mjs";

const joints = robot.velocities.length, count = 64;
const uniform = () => 2 * Math.random() - 1;
const samples = Array.from({ length: count }, () => {
  const state = robot.initialState();
  for (let i = 0; i < joints; ++i) {
    state[1 + i] = 3 * uniform();
    state[1 + joints + i] = uniform();
  }
  return { state, accelerations: Float64Array.from({ length: joints }, uniform), forces: new Float64Array(joints) };
});
const precomputed = robot.precompute(), none = new Float64Array(0);
let least = Infinity;
for (let turn = 0; turn < 4000; ++turn) {
  const start = process.hrtime.bigint();
  for (const each of samples) robot.inverse_dynamics(precomputed, each.state, each.accelerations, none, each.forces);
  least = Math.min(least, Number(process.hrtime.bigint() - start) / count);
}
console.log(`JavaScript ${least.toFixed(2)}`);
