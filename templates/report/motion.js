// SPDX-License-Identifier: MIT-0
// The motion of a mechanism from its generated kernels, sample by sample.
(() => {
"use strict";
const { Integrator, Projection } = torsorReport;

/// What is known by names of a scene, and nothing else: `constructor` and `valueOf` may be such names.
const byName = (values) => Object.assign(Object.create(null), values);

/// States of a mechanism at times k · interval, and what its kernels say of them.
class Samples {
  constructor(mechanism, interval) {
    Object.assign(this, { mechanism, interval, samples: [], status: "ok" });
    this.nq = mechanism.coordinates.length;
    this.nv = mechanism.velocities.length;
    this.rates = mechanism.coordinate_rates ? new Float64Array(this.nq) : null;
    this.state = new Float64Array(mechanism.stateSize);
  }

  /// The time that has been reached.
  get time() { return (this.samples.length - 1) * this.interval; }

  /// dq/dt.
  coordinateRates(t, y) {
    if (!this.rates) return y.subarray(this.nq, 2 * this.nq);
    this.state[0] = t;
    this.state.set(y, 1);
    this.mechanism.coordinate_rates(this.precomputed, this.state, this.rates);
    return this.rates;
  }

  /// What a kernel without arguments but the inputs says of sample k.
  evaluate(name, k) { return this.members(name, k * this.interval, this.samples[k]); }

  /// How fast that changes along the motion, of what the configuration determines: a central difference, off by some h^2.
  change(name, k) {
    const h = 1e-5, t = k * this.interval, y = this.samples[k], rates = this.coordinateRates(t, y);
    const moved = (by) => y.map((value, i) => (i < this.nq ? value + by * rates[i] : value));
    const after = this.members(name, t + h, moved(h)), before = this.members(name, t - h, moved(-h)), result = byName();
    for (const [member, values] of Object.entries(after)) result[member] = values.map((value, i) => (value - before[member][i]) / (2 * h));
    return result;
  }

  members(name, t, y) {
    const kernel = this.mechanism.kernels.find((each) => each.name === name);
    if (!kernel) return null;
    const state = new Float64Array(this.mechanism.stateSize), result = new Float64Array(kernel.results[0].size);
    state[0] = t;
    state.set(y, 1);
    const given = kernel.arguments.map((argument) => this[argument]);
    this.mechanism[name](this.precomputed, state, ...given, result);
    const members = byName();
    for (const member of kernel.results[0].members) {
      const size = member.rows ? member.rows * member.columns : 1;
      members[member.name] = result.subarray(member.offset, member.offset + size);
    }
    return members;
  }
}

/// Samples that the generated kernels give.
class Motion extends Samples {
  /// Values by name: parameters, inputs, start values of coordinates (`start`) and velocities (`speeds`, which have their
  /// coordinates' names). What is not named has the value of the scene, or 1 for a parameter without one.
  /// `latest` is the one of `start` ("q") or `speeds` ("q'") that stays where not all can; `closed` is a whole state that
  /// fulfils the constraints, for a motion that starts there.
  constructor(mechanism, { latest = null, closed = null, interval = 1 / 60, tolerance = 1e-12, ...given } = {}) {
    super(mechanism, interval);
    const [parameters, inputs, start, speeds] = ["parameters", "inputs", "start", "speeds"].map((each) => byName(given[each]));
    this.parameters = mechanism.defaultParameters();
    mechanism.parameters.forEach((each, i) => {
      if (each.name in parameters) this.parameters[i] = parameters[each.name];
      else if (Number.isNaN(this.parameters[i])) this.parameters[i] = 1;
    });
    this.precomputed = mechanism.precompute(this.parameters);
    this.inputs = Float64Array.from(mechanism.inputs, (each) => inputs[each.name] ?? 0);
    this.accelerations = new Float64Array(this.nv);
    this.multipliers = new Float64Array(mechanism.multipliers.length);
    this.state = mechanism.initialState(this.parameters);
    const y = this.state.slice(1);
    mechanism.coordinates.forEach((each, i) => { y[i] = start[each.name] ?? y[i]; });
    mechanism.velocities.forEach((each, i) => { y[this.nq + i] = speeds[each.name] ?? y[this.nq + i]; });
    this.projection = new Projection(mechanism, this.precomputed);
    const settle = (t, at) => this.projection.settle(t, at);
    this.start = Float64Array.from(y);
    if (closed) y.set(closed);
    const stands = closed ? settle(0, y) : this.close(y, { start, speeds, latest });
    this.moved = stands ? this.movedFrom(y, { start, speeds }) : [];
    if (!stands) this.status = "«the constraints could not be closed at the start»";
    else if (!mechanism.forward_dynamics) this.status = "«the mechanism's accelerations are not determined»";
    if (this.status !== "ok") {
      this.samples.push(stands ? y : this.start);
      return;
    }
    const needsSettling = mechanism.multipliers.length > 0 || mechanism.quaternions.length > 0;
    this.integrator = new Integrator((t, at, slope) => this.slope(t, at, slope), 0, y,
                                     { tolerance, settle: needsSettling ? settle : null, stepLimit: 2e6 });
    this.status = this.integrator.status;
    this.samples.push(Float64Array.from(y));
  }

  /// Velocities that go with each position: all three of a quaternion.
  freedoms() {
    const all = [];
    for (let j = 0; all.length < this.nq;) {
      const turns = this.mechanism.quaternions.includes(all.length);
      const own = turns ? [j, j + 1, j + 2] : [j];
      all.push(...Array(turns ? 4 : 1).fill(own));
      j += own.length;
    }
    return all;
  }

  /// Puts the start onto the constraints. What is asked for stays where the other numbers can follow; else the latest alone,
  /// else nothing. False where the constraints cannot be closed near there.
  close(y, { start, speeds, latest }) {
    const { coordinates, velocities } = this.mechanism, freedoms = this.freedoms(), asked = Float64Array.from(y);
    const kept = (ofPosition, ofRate) => ({
      positions: [...new Set(coordinates.flatMap(({ name }, i) => (ofPosition(name) ? freedoms[i] : [])))],
      rates: velocities.flatMap(({ name }, i) => (ofRate(name) ? [i] : [])),
    });
    const all = kept((name) => name in start, (name) => name in speeds);
    const last = kept((name) => name === latest, (name) => `${name}'` === latest);
    for (const each of [all, last]) {
      if (each.positions.length + each.rates.length === 0) continue;
      if (this.projection.settle(0, y, each)) return true;
      y.set(asked);
    }
    return this.projection.settle(0, y);
  }

  /// What was asked for and is not there: that a closed start is typed in few digits is no news.
  movedFrom(y, { start, speeds }) {
    const moved = [], { coordinates, velocities } = this.mechanism;
    const compare = (name, asked, value) => {
      if (Math.abs(value - asked) > 1e-3 * (1 + Math.abs(asked))) moved.push({ name, asked, value });
    };
    coordinates.forEach(({ name }, i) => name in start && compare(name, start[name], y[i]));
    const rate = (name) => coordinates.some((each) => each.name === name) ? `${name}'` : name;
    velocities.forEach(({ name }, i) => name in speeds && compare(rate(name), speeds[name], y[this.nq + i]));
    return moved;
  }

  slope(t, y, slope) {
    const { mechanism, state } = this;
    state[0] = t;
    state.set(y, 1);
    const status = mechanism.forward_dynamics(this.precomputed, state, this.inputs, this.accelerations, this.multipliers);
    slope.set(this.coordinateRates(t, y));
    slope.set(this.accelerations, this.nq);
    return status === mechanism.Status.ok;
  }

  /// One sample more; false, with a status, where the motion cannot go on.
  extend() {
    if (this.status !== "ok") return false;
    if (!this.integrator.advance(this.samples.length * this.interval)) {
      this.status = `${this.integrator.status}« at t = »${this.integrator.t.toPrecision(6)} s`;
      return false;
    }
    this.samples.push(Float64Array.from(this.integrator.y));
    return true;
  }

  /// The multipliers of the constraints at sample k.
  reactions(k) {
    this.slope(k * this.interval, this.samples[k], new Float64Array(this.samples[k].length));
    return Array.from(this.multipliers);
  }
}

Object.assign(torsorReport, { Samples, Motion });
})();
