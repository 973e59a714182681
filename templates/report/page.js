// SPDX-License-Identifier: MIT-0
// The page: what its reader changes restarts the motion; time runs, stops or follows the slider.
(() => {
"use strict";
if (typeof document === "undefined") return;
const { Motion, Playback, Picture, Viewer, Plot, Portrait, SmallMotions, column, label, written } = torsorReport;
const mechanism = globalThis.torsorMechanism, scene = JSON.parse(document.getElementById("scene").textContent);
const element = (id) => document.getElementById(id);
const read = (node) => (node ? JSON.parse(node.textContent) : null);
const reference = read(element("reference")), recording = read(element("recording"));
const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;

/// By names, which may be those that objects have.
const chosen = Object.fromEntries(["parameters", "inputs", "start", "speeds"].map((kind) => [kind, Object.create(null)]));
/// Of a start that is to be put on the constraints: the slider that was moved last, and the state that the page was made with.
let latest = null, closed = null, startRows = [];
/// What the page was made with, in place of the scene's start and of inputs that are zero.
function asGiven() {
  for (const each of Object.values(chosen)) for (const name of Object.keys(each)) delete each[name];
  const given = read(element("given")) ?? {}, { initial = {}, inputs = {} } = given;
  const coordinates = new Set(mechanism.coordinates.map((each) => each.name));
  Object.assign(chosen.inputs, inputs);
  [latest, closed] = [null, given.closed ?? null];
  for (const [name, value] of Object.entries(initial)) {
    if (coordinates.has(name)) chosen.start[name] = value;
    else chosen.speeds[name.endsWith("'") ? name.slice(0, -1) : name] = value;
  }
}
if (mechanism) asGiven();
let mode = null, until = scene.duration, motion = null, picture = null, viewer = null, plots = [], playing = !still, now = 0, last = 0, told = "", traces = [];

function restart(keepTime) {
  mode = null;  // modes belong to the parameters that they were found with
  element("modes").replaceChildren();
  element("rest").textContent = "";
  motion = recording ? new Playback(mechanism, recording) : new Motion(mechanism, { ...chosen, latest, closed });
  torsorReport.current = motion;
  if (!keepTime) now = 0;
  told = "";
  traces = picture ? picture.traced.map(() => []) : [];
  plots.forEach((plot) => plot.clear());
  if (viewer) viewer.changed = true;
}

/// Whether the motion is the one that the scene states.
const asStated = () => Object.values(chosen).every((each) => Object.keys(each).length === 0);

/// How far the motion is from the reference at times of samples, when it has passed them all.
function agreement() {
  const words = element("agreement"), shown = reference && asStated();
  plots.forEach((plot) => { plot.withDots = shown; });
  words.hidden = true;
  if (!shown) return;
  let worst = 0, count = 0, last = 0;
  for (const each of reference.rows) {
    const k = Math.round(each[0] / motion.interval);
    if (Math.abs(k * motion.interval - each[0]) > 1e-12 * Math.max(1, each[0]) || k >= motion.samples.length) continue;
    ++count;
    last = Math.max(last, each[0]);
    mechanism.coordinates.forEach((of, i) => {
      const value = each[reference.names.indexOf(of.name)];
      if (value !== undefined) worst = Math.max(worst, Math.abs(motion.samples[k][i] - value) / (1 + Math.abs(value)));
    });
  }
  words.hidden = last === 0;  // at its start a motion meets every reference
  const text = `«Dots: the reference trajectory, derived and integrated a second time in many digits. At ${count} of its ${reference.rows.length} times the motion is off by ${worst.toPrecision(2)} at most, as a part of 1 + |q|.»`;
  if (last > 0 && text !== words.textContent) words.textContent = text;
}

function row(parent, { name, unit, value, low, high, change }) {
  const line = document.createElement("div"), text = document.createElement("span"), slider = document.createElement("input");
  const number = document.createElement("input"), units = document.createElement("span");
  line.className = "row";
  name.match(/[^_]*_|[^_]+$/g).forEach((part) => text.append(part, document.createElement("wbr")));  // long names break behind _
  units.textContent = written(unit);
  Object.assign(slider, { type: "range", min: low, max: high, step: "any", value });
  Object.assign(number, { type: "number", step: "any", value: Number(value.toPrecision(6)) });
  slider.setAttribute("aria-label", `${name} [${unit}]`);
  number.setAttribute("aria-label", `${name} [${unit}]«, as a number»`);
  const set = (next, from) => {
    if (!Number.isFinite(next)) return;
    if (from !== slider) slider.value = next;
    if (from !== number) number.value = Number(next.toPrecision(6));
    change(next);
    restart();
    startRows.forEach((each) => each.line !== line && each.show(motion.samples[0][each.place]));
  };
  slider.addEventListener("input", () => set(Number(slider.value), slider));
  number.addEventListener("change", () => number.value !== "" && set(Number(number.value), number));
  line.append(text, slider, number, units);
  parent.append(line);
  const show = (next) => { [slider.value, number.value] = [next, Number(next.toPrecision(6))]; };
  return { line, show };
}

function range(value, unit) {
  if (unit === "rad") return [Math.min(-Math.PI, value - Math.PI), Math.max(Math.PI, value + Math.PI)];
  if (value === 0) return [-1, 1];
  return value > 0 ? [0.05 * value, 4 * value] : [4 * value, 0.05 * value];
}

function heading(parent, text) {
  const title = document.createElement("h3");
  title.textContent = text;
  parent.append(title);
}

function buildSliders() {
  const parent = element("sliders"), first = new Motion(mechanism, { ...chosen, latest, closed }), begins = first.samples[0];
  parent.replaceChildren();
  startRows = [];
  const known = new Set(mechanism.coordinates.map((each) => each.name));
  const shown = (symbol) => (mechanism.velocities.includes(symbol) && known.has(symbol.name) ? `${symbol.name}'` : symbol.name);
  const add = (symbols, title, valueOf, store, limits, place = -1) => {
    if (symbols.length === 0) return;
    heading(parent, title);
    symbols.forEach((symbol, i) => {
      const value = valueOf(i), [low, high] = limits(value, symbol.unit);
      const change = (next) => {
        store[symbol.name] = next;
        if (store !== chosen.inputs) closed = null;
        if (place >= 0) latest = store === chosen.speeds ? `${symbol.name}'` : symbol.name;
      };
      const made = row(parent, { name: shown(symbol), unit: symbol.unit, value, low, high, change });
      if (place >= 0) startRows.push({ ...made, place: place + i });
    });
  };
  add(mechanism.parameters, "«Parameters»", (i) => first.parameters[i], chosen.parameters, range);
  add(mechanism.inputs, "«Inputs, constant in time»", (i) => first.inputs[i], chosen.inputs, (value) => [Math.min(-10, 2 * value), Math.max(10, 2 * value)]);
  const spread = (value, unit) => (unit === "rad" ? range(value, unit) : [Math.min(-1, 2 * value), Math.max(1, 2 * value)]);
  add(mechanism.coordinates, "«Start: coordinates»", (i) => begins[i], chosen.start, spread, 0);
  add(mechanism.velocities, "«Start: velocities»", (i) => begins[first.nq + i], chosen.speeds,
      (value) => [Math.min(-10, 2 * value), Math.max(10, 2 * value)], first.nq);
}

/// Velocity over coordinate, of coordinates whose velocities are their rates; a page has room for some.
function buildPortraits() {
  const most = 6, nq = mechanism.coordinates.length;
  mechanism.coordinates.forEach((each, i) => {
    const j = mechanism.velocities.findIndex((other) => other.name === each.name);
    if (j < 0 || plots.filter((plot) => plot instanceof Portrait).length >= most) return;
    const unit = (of) => (of === "1" ? "" : ` [${written(of)}]`);
    plots.push(new Portrait(element("portrait-list"), `${each.name}'« over »${each.name}`, each.name + unit(each.unit), `${each.name}'` + unit(mechanism.velocities[j].unit),
                            { x: (k) => motion.samples[k][i], y: (k) => motion.samples[k][nq + j] }));
  });
  if (!plots.some((plot) => plot instanceof Portrait)) element("portraits").remove();
}

function buildPlots() {
  const parent = element("plots"), groups = new Map();
  mechanism.coordinates.forEach((each, i) => {
    if (mechanism.quaternions.some((first) => i >= first && i < first + 4)) return;
    if (!groups.has(each.unit)) groups.set(each.unit, []);
    const at = reference ? reference.names.indexOf(each.name) : -1;
    groups.get(each.unit).push({ name: each.name, value: (k) => motion.samples[k][i], dots: at < 0 ? [] : reference.rows.map((numbers) => [numbers[0], numbers[at]]) });
  });
  const goTo = (t) => { now = Math.max(0, Math.min(motion.time, t)); pause(); };
  const add = (title, unit, curves) => { for (let i = 0; i < curves.length; i += 8) plots.push(new Plot(parent, title, unit, curves.slice(i, i + 8), goTo)); };
  for (const [unit, curves] of groups) add("«Coordinates»", unit === "1" ? "" : unit, curves);
  buildPortraits();
  if (recording) buildContactPlots(add);
  const remember = (name) => {
    let at = -1, of = null, result = null;
    return (k) => {
      if (k !== at || of !== motion) [at, of, result] = [k, motion, motion.evaluate(name, k)];
      return result;
    };
  };
  const has = (name) => mechanism.kernels.some((each) => each.name === name);
  if (has("energy")) {
    const energy = remember("energy");
    add("«Energy»", "J", [{ name: "T", value: (k) => energy(k).kinetic[0] },
                        { name: "-U", value: (k) => -energy(k).force_function[0] },
                        { name: "T - U", value: (k) => energy(k).kinetic[0] - energy(k).force_function[0] }]);
  }
  if (has("first_integrals")) {
    const integrals = remember("first_integrals");
    const units = new Map();
    for (const { name, unit } of mechanism.kernels.find((each) => each.name === "first_integrals").results[0].members) {
      units.set(unit, [...(units.get(unit) ?? []), name]);
    }
    let first = null, of = null;
    const change = (name) => (k) => {
      if (of !== motion) [of, first] = [motion, motion.evaluate("first_integrals", 0)];
      return integrals(k)[name][0] - first[name][0];
    };
    for (const [unit, names] of units) {
      add(recording ? "«First integrals of the mechanism on which no contact acts: change since the start»"
                    : "«First integrals: change since the start (what rounding and steps leave)»", unit, names.map((name) => ({ name, value: change(name) })));
    }
  }
}

/// Gaps and reactions, those of one unit together.
function buildContactPlots(add) {
  const gaps = new Map(), forces = new Map();
  const put = (groups, unit, curve) => groups.set(unit, [...(groups.get(unit) ?? []), curve]);
  motion.contacts.forEach((each, c) => {
    if (each.normal) put(gaps, each.gapUnit, { name: each.name, value: (k) => motion.ofContacts[k][each.gap] });
    each.reactions.forEach((which, i) => put(forces, each.unit, { name: `${which}(${each.name})`, value: (k) => motion.reactionsOf(c, k)[i] }));
  });
  for (const [unit, curves] of gaps) add("«Gaps of contacts»", unit, curves);
  for (const [unit, curves] of forces) add("«Reactions of contacts»", unit, curves);
}

/// Events as buttons that go there; a page has room for some.
function buildEvents() {
  const most = 300, list = element("event-list"), { events } = motion;
  if (events.length === 0) return;
  element("contact-events").hidden = false;
  for (const each of events.slice(0, most)) {
    const item = document.createElement("li"), button = document.createElement("button"), text = document.createElement("span");
    Object.assign(button, { type: "button", textContent: `t = ${each.time.toPrecision(6)} s` });
    button.addEventListener("click", () => { now = Math.min(each.time, motion.time); pause(); });
    text.textContent = ` ${motion.eventInWords(each)}; ${motion.regimesInWords(each.after)}`;
    item.append(button, text);
    list.append(item);
  }
  if (motion.eventCount > most) {
    list.after(Object.assign(document.createElement("p"), { textContent: `«The first ${most} of ${motion.eventCount} events.»` }));
  }
}

/// What cannot be changed on a page that plays a motion back.
function buildPlayback() {
  until = motion.time || motion.interval;  // one that ends before its second sample has an axis of time all the same
  for (const id of ["until", "restart"]) element(id).closest("label, button").remove();
  element("regimes").hidden = motion.contacts.length === 0;
  element("remarks").hidden = recording.remarks.length === 0;
  element("remarks").append(...recording.remarks.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
  buildEvents();
}

function pause() {
  playing = false;
  element("play").textContent = "«Play»";
  plots.forEach((plot) => plot.describe());
  if (viewer) viewer.changed = true;
}
function play() {
  mode = null;
  if (now >= until - 1e-9) now = 0;
  playing = true;
  element("play").textContent = "«Pause»";
}

const sampleAt = (t) => Math.min(motion.samples.length - 1, Math.max(0, Math.round(t / motion.interval)));
const poses = (t) => motion.evaluate("poses", sampleAt(t));

/// Buttons for the modes about a rest near what is seen now.
function findRest() {
  const q = motion.samples[sampleAt(now)].slice(0, motion.nq), small = new SmallMotions(motion, q), buttons = element("modes");
  mode = null;
  buttons.replaceChildren();
  if (small.why) {
    element("rest").textContent = `«No modes: ${small.why}.»`;
    return;
  }
  const stable = small.modes.every(({ square, neutral }) => neutral || square > 0);
  const place = mechanism.coordinates.map((each, i) => `${each.name} = ${label(small.q[i])}`).join(", ");
  const { zeroRoots } = small;
  const lowest = zeroRoots ? "«where all that is not neutral swings»"
                           : "«where the potential energy has a minimum along all that is not neutral»";
  const neighbours = "«constraints on velocities let the mechanism rest at neighbouring places too.»";
  const roots = zeroRoots === 1 ? "«Beside these modes there is one zero root:»" : `«Beside these modes there are ${zeroRoots} zero roots:»`;
  element("rest").textContent = `«A rest, »${stable ? lowest : "«unstable without gyroscopic forces»"}: ${place}. ` +
    "«Modes leave damping and gyroscopic forces out.»" + (small.modes.some(({ damping }) => damping) ? "« Damping ratios are right to first order in damping.»" : "") +
    (zeroRoots ? ` ${roots} ${neighbours}` : "");
  small.modes.forEach((each, i) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = `«Mode ${i + 1}: »${SmallMotions.words(each)}`;
    button.addEventListener("click", () => {
      pause();
      // Seen at a pace that the eye follows: at most two swings a second. The largest angle is 0.4 rad.
      const limit = (unit) => (unit === "m/s" ? 0.3 * (picture?.size ?? 1) : 0.4);
      const size = Math.min(...mechanism.velocities.map((c, k) => limit(c.unit) / Math.max(Math.abs(each.shape[k]), 1e-300)));
      const rate = each.square > 0 && !each.neutral ? Math.min(4 * Math.PI, Math.max(1, Math.sqrt(each.square))) : 2;
      mode = { small, shape: each.shape.map((value) => value * size), rate, phase: 0, number: i + 1 };
    });
    buttons.append(button);
  });
}

/// The mechanism swinging in a mode.
function showMode(passed) {
  mode.phase += passed * mode.rate * Number(element("speed").value);
  const y = mode.small.posed(mode.shape.map((value) => value * Math.sin(mode.phase)));
  const here = motion.members("poses", 0, y);
  viewer.target = picture.framing.followed(here, viewer.target);
  viewer.draw(picture.at(here, [], viewer.target));
  element("clock").textContent = `«Mode ${mode.number}»`;
}

function addTraces() {
  for (let k = traces.length ? traces[0].length / 3 : 0; k < motion.samples.length; ++k) {
    const at = motion.evaluate("poses", k);
    picture.traced.forEach((each, i) => traces[i].push(...column(at[each.member], each.k)));
  }
}

function frame(stamp) {
  const passed = last === 0 ? 0 : Math.min(0.1, (stamp - last) / 1000);
  last = stamp;
  const budget = performance.now() + 9, before = motion.samples.length;
  while (motion.time < until - 1e-9 && performance.now() < budget && motion.extend());
  if (playing) {
    now = Math.min(now + passed * Number(element("speed").value), motion.time, until);
    if (now >= until - 1e-9 || (recording || motion.status !== "ok") && now >= motion.time - 1e-9) pause();
  }
  const fresh = motion.samples.length !== before;
  if (mode && viewer) showMode(passed);
  else if (playing || fresh || !viewer || viewer.changed) show(fresh);
  requestAnimationFrame(frame);
}

function show(fresh) {
  if (fresh || plots.length && plots[0].data[0].length === 0) plots.forEach((plot) => plot.read(motion.samples.length));
  if (reference) agreement();
  plots.forEach((plot) => plot.draw(motion.interval, until, now, motion.events ?? []));
  element("time").max = until;
  element("time").value = now;
  element("clock").textContent = `t = ${now.toFixed(2)} s`;
  if (viewer) {
    if (element("traces").checked) addTraces();
    const upTo = 3 * (1 + Math.round(now / motion.interval));
    const here = poses(now);
    viewer.target = picture.framing.followed(here, viewer.target);
    const seen = picture.at(here, element("traces").checked ? traces.map((each) => each.slice(0, upTo)) : [], viewer.target);
    if (element("velocities").checked) {
      const rates = motion.change("poses", sampleAt(now));
      if (rates) seen.shapes.push(...picture.velocities(here, rates));
    }
    if (element("weights").checked) seen.shapes.push(...picture.weights(here));
    if (element("reactions")?.checked) {
      const k = sampleAt(now);
      seen.shapes.push(...(recording ? picture.contactForces(here, motion.contacts, (c) => motion.reactionsOf(c, k)) : picture.reactions(here, motion.reactions(k))));
    }
    viewer.draw(seen);
  }
  if (recording) element("regimes").textContent = motion.regimesInWords(motion.regimesAt(sampleAt(now)));
  const state = recording ? recordedState() : startInWords() + integratedState();
  if (state !== told) element("status").textContent = told = state;
}

function integratedState() {
  return motion.status !== "ok" ? `«The motion ends: ${motion.status}.»`
    : motion.time < until - 1e-9 ? `«Integrated until ${motion.time.toFixed(1)} s»`
    : `«Integrated until ${until} s in ${motion.integrator.steps} steps.»`;
}

/// Where the motion starts elsewhere than it was told to.
function startInWords() {
  if (motion.moved.length === 0) return "";
  const where = motion.moved.map(({ name, asked, value }) => `${name} = ${label(value)} (${label(asked)})`).join(", ");
  return `«The constraints do not allow these start values: the motion starts at ${where}, in brackets what was asked for.»` + " ";
}

function recordedState() {
  const end = `«Recorded until ${label(until)} s, ${motion.eventCount} events of contacts.»`;
  return motion.stopped ? `${end} «The motion ends: ${motion.stopped}.»` : end;
}

function start() {
  if (!mechanism) return;
  element("until").value = until;
  restart();
  if (recording) buildPlayback();
  else buildSliders();
  try {
    const first = motion.evaluate("poses", 0), triangles = element("meshes");
    const meshes = triangles ? torsorReport.readMeshes(scene, JSON.parse(triangles.textContent)) : [];
    picture = new Picture(scene, first);
    const forces = recording ? first.contact_directions : first.reaction_forces;
    if (!forces?.some((value) => value !== 0)) element("reactions").parentElement.remove();
    const ready = performance.now() + 120;  // what the beginning of the motion reaches is in the first view
    while (motion.time < until - 1e-9 && performance.now() < ready && motion.extend());
    const step = Math.max(1, Math.floor(motion.samples.length / 40)), seen = [];
    for (let k = 0; k < motion.samples.length; k += step) seen.push(motion.evaluate("poses", k));
    picture.framing.include(seen);
    viewer = new Viewer(element("view"));
    meshes.forEach((each) => viewer.mesh(...each));
    [...picture.surfaces, ...picture.rings].forEach(({ mesh, corners }) => viewer.mesh(mesh, corners));
    viewer.home(picture.framing.camera());
    element("view").setAttribute("aria-label", `${scene.bodies.length}« bodies in three dimensions: »${scene.bodies.slice(0, 12).map((each) => each.name).join(", ")}. ` +
      "«Arrow keys turn the picture, plus and minus come nearer and go away, 0 is the first view.»");
    traces = picture.traced.map(() => []);
  } catch (error) {
    viewer = null;
    element("view").replaceWith(Object.assign(document.createElement("p"), { className: "note", textContent: `«No picture: ${error.message}.»` }));
  }
  buildPlots();
  element("play").addEventListener("click", () => (playing ? pause() : play()));
  if (!playing) element("play").textContent = "«Play»";
  element("find-rest").addEventListener("click", findRest);
  element("time").addEventListener("input", () => { mode = null; now = Math.min(Number(element("time").value), motion.time); pause(); });
  for (const id of ["traces", "velocities", "weights", "reactions"]) element(id)?.addEventListener("change", () => { if (viewer) viewer.changed = true; });
  element("portraits")?.addEventListener("toggle", () => { if (viewer) viewer.changed = true; else show(false); });
  element("until")?.addEventListener("change", () => {
    const wanted = Number(element("until").value);
    if (wanted > 0) [until, told] = [wanted, ""];
    if (viewer) viewer.changed = true;
  });
  element("restart")?.addEventListener("click", () => {
    asGiven();
    buildSliders();
    restart();
  });
  element("view-home").addEventListener("click", () => viewer && viewer.reset());
  document.addEventListener("keydown", (event) => {
    if (event.key === " " && (event.target === document.body || event.target === element("view"))) {
      event.preventDefault();
      if (playing) pause();
      else play();
    }
  });
  requestAnimationFrame(frame);
}
start();
})();
