// SPDX-License-Identifier: GPL-3.0-or-later
// page.mjs BROWSER KATEX FOLDER PROGRAM...: reports of scene programs (or of "torsor FILE") as a browser sees them: no
// complaint, no request, every formula typeset (where KATEX is 1), a motion that a slider changes, everything within
// reach of the keyboard. Where TORSOR_AXE names axe.min.js of axe-core, it finds nothing that keeps people out.
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, statSync } from "node:fs";
import { basename, join } from "node:path";
import { Browser } from "./browser.mjs";

const [program, katex, folder, ...scenes] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const browser = await Browser.start(program, { unseen: true });
let failed = false;

/// The motion that the scene states meets its reference; another one is not compared with it.
async function expectReference(expect) {
  const words = await browser.evaluate(`new Promise((done) => {
    document.getElementById("restart").click();
    const agreement = document.getElementById("agreement"), last = JSON.parse(document.getElementById("reference").textContent).rows.at(-1)[0];
    const wait = () => (torsorReport.current.time >= Math.min(last, 9) && !agreement.hidden && agreement.textContent ? done(agreement.textContent) : setTimeout(wait, 50));
    wait();
  })`);
  const [, met, all, off] = /(\d+) \D+ (\d+) \D+ ([\d.e-]+) /.exec(words) ?? [];
  expect(Number(met) > 0 && Number(met) <= Number(all), `the reference is met at no time: ${words}`);
  expect(Number(off) < 1e-9, `the motion is off its reference: ${words}`);
  const hidden = await browser.evaluate(`new Promise((done) => {
    const slider = document.querySelector("#sliders input[type=range]");
    slider.value = Number(slider.value) + 0.01 * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input"));
    requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(() => done(document.getElementById("agreement").hidden))));
  })`);
  expect(hidden, "a motion with another parameter is compared with the reference");
}

/// A motion with contacts is what `simulate` says, to the last digit; the page says that it is recorded, and tells its events.
async function expectPlayback(tool, files, expect) {
  const page = await browser.evaluate(`(() => {
    const { current } = torsorReport, buttons = [...document.querySelectorAll("#event-list button")], at = Number(document.getElementById("time").value);
    document.getElementById("contact-events").open = true;
    buttons.at(-1)?.click();
    return { interval: current.interval, duration: JSON.parse(document.getElementById("scene").textContent).duration, samples: current.samples.map((each) => [...each]), ofContacts: current.ofContacts.map((each) => [...each]),
             events: current.events.map(({ time }) => time), buttons: buttons.length, sliders: document.querySelectorAll("#sliders *").length,
             regimes: document.getElementById("regimes").textContent, note: document.querySelector("#motion .note")?.textContent ?? "" };
  })()`);
  await browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
  const last = page.events[Math.min(page.events.length, page.buttons) - 1];
  const shown = await browser.evaluate("Number(document.getElementById('time').value)");
  expect(last === undefined || Math.abs(shown - last) < 1e-9, `a click on an event goes to ${shown} instead of ${last}`);
  expect(/recorded|enregistré/.test(page.note), "the page does not say that its motion is recorded");
  const remarks = await browser.evaluate("[...document.querySelectorAll('#remarks li')].map((each) => each.textContent).join('; ')");
  expect(/laws of contact|lois de contact/.test(remarks), `remarks of the motion: ${remarks}`);
  expect(page.sliders === 0, "there are sliders that change nothing");
  expect(/: (open|free|closed|sticks|slides|ouvert|libre|fermé|adhère|glisse)/.test(page.regimes), `regimes: ${page.regimes}`);
  const reached = page.interval * Math.max(1, page.samples.length - 1);
  const to = Math.abs(reached - page.duration) < 1e-9 * page.duration ? page.duration : reached;  // the last sample is at the end, not a rounding away
  const { stdout: table } = spawnSync(tool, ["simulate", ...files.filter((each) => !/^--(language|reference|to)/.test(each)), "--to", String(to), "--step", String(page.interval)],
                                      { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1e8 });
  const [names, ...rows] = table.split("\n").filter((line) => line && !line.startsWith("#")).map((line) => line.split(","));
  const width = page.samples[0].length, ofContacts = page.ofContacts[0].length;
  expect(rows.length === page.samples.length, `${page.samples.length} samples, and simulate has ${rows.length} rows`);
  const wrong = rows.findIndex((row, k) => {
    const numbers = row.map(Number);
    const same = (a, b) => a.length === b.length && a.every((value, i) => value === b[i] || Number.isNaN(value) && b[i] === null);
    return !same(numbers.slice(1, 1 + width), page.samples[k]) || !same(numbers.slice(names.length - ofContacts), page.ofContacts[k]);
  });
  expect(wrong < 0, `sample ${wrong} is not that of simulate`);
  expect((table.match(/^# Event: /gm) ?? []).length === page.events.length, "events are not those of simulate");
}

/// A motion of given start values and inputs is what `simulate` makes of them; the button that starts anew goes back to them.
async function expectGiven(tool, files, expect) {
  const { stdout: table } = spawnSync(tool, ["simulate", ...files, "--to", "1", "--step", "1", "--tolerance", "1e-12"],
                                      { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  const rows = table.split("\n").filter((line) => line && !line.startsWith("#")).map((line) => line.split(","));
  const reached = async (how) => browser.evaluate(`new Promise((done) => {
    ${how}
    const { current } = torsorReport, wanted = Math.round(1 / current.interval);
    while (current.samples.length <= wanted && current.status === "ok") current.extend();
    done({ start: [...current.samples[0]], end: [...(current.samples[wanted] ?? [])], time: wanted * current.interval });
  })`);
  const slide = `for (const slider of document.querySelectorAll("#sliders input[type=range]")) {
    slider.value = Number(slider.value) + 0.01 * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input"));
  }`;
  const again = "document.getElementById('restart').click();", off = (a, b) => Math.max(...a.map((value, i) => Math.abs(value - b[i]) / Math.max(1, Math.abs(value))));
  const numbers = (row, width) => row.slice(1, 1 + width).map(Number);
  const given = await reached(again), elsewhere = await reached(slide), back = await reached(again), width = given.start.length;
  expect(rows.length === 3 && Math.abs(given.time - 1) < 1e-12, `simulate has ${rows.length - 1} rows, the page a sample at ${given.time}`);
  expect(off(numbers(rows[1], width), given.start) === 0, `the page starts at ${given.start} instead of ${rows[1]}`);
  expect(off(numbers(rows[2], width), given.end) < 1e-9, `the page reaches ${given.end} instead of ${rows[2]}`);
  expect(off(elsewhere.end, given.end) > 1e-6, "sliders change nothing");
  expect(off(back.start, given.start) === 0 && off(back.end, given.end) === 0, "starting anew forgets what was given");
}

for (const scene of scenes) {
  const [tool, ...files] = scene.split(" "), failures = [];
  const file = join(folder, `${basename(files[0] ?? tool)}.html`);
  execFileSync(tool, ["report", ...files, "--output", file], { stdio: ["ignore", "ignore", "ignore"] });
  const expect = (holds, text) => { if (!holds) failures.push(text); };
  await browser.open(file);

  const recorded = await browser.evaluate("document.getElementById('recording') !== null");
  const twice = await browser.evaluate(`[...document.querySelectorAll("[id]")].map((each) => each.id).filter((id, i, all) => all.indexOf(id) !== i)`);
  expect(twice.length === 0, `ids stand twice: ${twice.join(", ")}`);
  expect(await browser.evaluate("[...document.scripts].every((each) => getComputedStyle(each).display === 'none')"), "a script is shown as text");
  expect(await browser.evaluate("typeof hacked") === "undefined", "a name of the scene became a script");
  expect(await browser.evaluate("document.querySelectorAll('img, iframe, object, embed, link, base, form').length") === 0, "there are elements that no report has");
  const formulas = await browser.evaluate(`(() => {
    if (torsorReport.typesetAll) torsorReport.typesetAll();
    const all = [...document.querySelectorAll("[data-latex], [data-inline]")];
    return { count: all.length, errors: [...document.querySelectorAll(".katex-error, .formula-error")].map((e) => e.title + ": " + e.textContent.slice(0, 200)).slice(0, 3),
             set: all.filter((each) => each.querySelector(".katex")).length };
  })()`);
  expect(formulas.count > 3, "there are hardly any formulas");
  expect(formulas.errors.length === 0, `formulas are not typeset: ${formulas.errors.join("; ")}`);
  expect(formulas.set === (katex === "1" ? formulas.count : 0), `${formulas.set} of ${formulas.count} formulas are typeset`);

  // A rest and its modes where there are any: the picture follows one, and comes back.
  const modes = await browser.evaluate(`(() => {
    const find = document.getElementById("find-rest");
    if (!find) return null;
    document.getElementById("small-motions").open = true;
    find.click();
    const buttons = [...document.querySelectorAll("#modes button")];
    buttons[0]?.click();
    return { words: document.getElementById("rest").textContent, count: buttons.length };
  })()`);
  expect(modes !== null && modes.words.length > 10, "a search for a rest says nothing");
  expect(modes === null || modes.count > 0 || /^(No modes|Pas de modes propres) ?: /.test(modes.words), `no modes and no reason: ${modes?.words}`);
  await browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
  await browser.evaluate("document.getElementById('play').click()");

  // The motion, before and after the first slider is moved.
  const end = "Array.from(torsorReport.current.samples.at(-1))";
  const reached = `new Promise((done) => { const wait = () => torsorReport.current.samples.length > 6 || torsorReport.current.recorded || torsorReport.current.status !== "ok" ? done(torsorReport.current.status) : setTimeout(wait, 50); wait(); })`;
  expect(await browser.evaluate(reached) === "ok", "the motion fails at its beginning");
  const moved = await browser.evaluate(`(async () => {
    const slider = document.querySelector("#sliders input[type=range]");
    if (!slider) return true;
    const before = torsorReport.current;
    slider.value = Number(slider.value) + 0.01 * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input"));
    if (torsorReport.current === before) return "a slider does not restart the motion";
    return document.querySelector("#modes button") || document.getElementById("rest").textContent ? "modes of other parameters stay" : true;
  })()`);
  expect(moved === true, moved);
  await browser.evaluate(reached);
  expect(await browser.evaluate("document.querySelector('#view') !== null"), "there is no picture");
  expect(await browser.evaluate("[...document.querySelectorAll('figcaption')].every((each) => !each.textContent.endsWith('[SI]'))"),
         "curves have no unit of their own");
  // Something is drawn: not all pixels are those of the background.
  const drawn = await browser.evaluate(`new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
    const view = document.getElementById("view"), copy = document.createElement("canvas");
    copy.width = copy.height = 64;
    const context = copy.getContext("2d");
    context.drawImage(view, 0, 0, 64, 64);
    done(context.getImageData(0, 0, 64, 64).data.filter((value, i) => i % 4 === 3 && value > 0).length);
  })))`);
  expect(drawn > 20, `the picture is empty (${drawn} of 4096 points)`);

  // Arrows: a velocity is how far a place goes in a small time, over that time.
  const arrows = await browser.evaluate(`(() => {
    if (!globalThis.torsorMechanism.forward_dynamics) return 0;
    const motion = new torsorReport.Motion(globalThis.torsorMechanism, { interval: 1e-5 });
    for (let k = 0; k < 42; ++k) motion.extend();
    if (motion.status !== "ok") return 0;
    const before = motion.evaluate("poses", 40), after = motion.evaluate("poses", 42), rates = motion.change("poses", 41);
    if (!rates) return 0;
    let worst = 0, size = 1e-9;
    before.origins.forEach((value, i) => {
      const mean = (after.origins[i] - value) / (2 * motion.interval);
      worst = Math.max(worst, Math.abs(mean - rates.origins[i]));
      size = Math.max(size, Math.abs(mean));
    });
    return worst / size;
  })()`);
  // Over 2e-5 s; the fastest motions, of the squeezer, turn at some 1e4 rad/s: (0.1)^2/6 is 0.2 %, twice. From rest a velocity
  // may grow with t^2, and its mean over h is off by (h/t)^2/3: 41 h after the start by 0.02 %.
  expect(arrows < 0.01, `velocities are off by ${arrows}`);
  for (const id of ["velocities", "weights", "reactions"]) await browser.evaluate(`document.getElementById("${id}")?.click()`);
  await browser.evaluate("document.getElementById('portraits') && (document.getElementById('portraits').open = true)");
  await browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");

  if (process.env.TORSOR_AXE) {
    // What KaTeX makes of a formula is the same everywhere: of long pages, which would take minutes, axe-core sees the first
    // formulas and all else.
    await browser.evaluate(`shut = [...document.querySelectorAll("details:not([open])")];
      shut.forEach((each) => { each.open = true; });
      unseen = [...document.querySelectorAll(".katex")].slice(50).map((each) => [each, [...each.childNodes]]);
      unseen.forEach(([each]) => each.replaceChildren());`);
    await browser.evaluate(`${readFileSync(process.env.TORSOR_AXE, "utf8")}; 0`);
    const found = await browser.evaluate(`axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) =>
      violations.filter(({ impact }) => impact === "serious" || impact === "critical").map(({ id, nodes }) => id + ": " + nodes[0].html.slice(0, 120)))`);
    await browser.evaluate(`unseen.forEach(([each, nodes]) => each.append(...nodes));
      shut.forEach((each) => { each.open = false; });`);
    expect(found.length === 0, `axe-core finds ${found.join("; ")}`);
  }

  // Tab reaches the picture, the buttons and the first slider.
  const focused = new Set();
  await browser.evaluate("document.activeElement.blur()");
  for (let i = 0; i < 18; ++i) {
    for (const type of ["rawKeyDown", "keyUp"]) await browser.send("Input.dispatchKeyEvent", { type, key: "Tab", code: "Tab", windowsVirtualKeyCode: 9 });
    focused.add(await browser.evaluate("document.activeElement.id || document.activeElement.type || document.activeElement.tagName"));
  }
  const within = ["view", "play", "time", "speed", "traces", "velocities", "weights", ...(recorded ? ["view-home"] : ["until"])];
  for (const id of within) expect(focused.has(id), `the keyboard does not reach ${id}`);
  const unnamed = await browser.evaluate(`[...document.querySelectorAll("canvas, input, button, select")]
    .filter((each) => !each.getAttribute("aria-label") && !each.labels?.length && !each.textContent.trim()).map((each) => each.id || each.type)`);
  expect(unnamed.length === 0, `without words: ${unnamed.join(", ")}`);

  // On a French page, what the scripts say is French too; titles and names are the scene's.
  const english = await browser.evaluate(`(() => {
    if (document.documentElement.lang !== "fr") return [];
    document.querySelectorAll("details").forEach((each) => { each.open = true; });
    const said = document.querySelector("main").innerText.split("\\n").concat([...document.querySelectorAll("[aria-label]")].map((each) => each.getAttribute("aria-label")));
    return said.filter((line) => !line.includes(document.title) && /(^|[ (])(the|of|is|and|with|between|until|over|start|steps?)([ ,.:;)]|$)/i.test(line));
  })()`);
  expect(english.length === 0, `English on a French page: ${english.slice(0, 5).join("; ")}`);

  const wide = await browser.evaluate(`document.documentElement.scrollWidth - document.documentElement.clientWidth`);
  expect(wide <= 0, `something on the page is ${wide} px wider than the window`);
  const stuck = await browser.evaluate(`[...document.querySelectorAll("pre, .formula")].filter((each) => each.scrollWidth > each.clientWidth + 1 && each.tabIndex < 0).length`);
  expect(stuck === 0, `${stuck} texts scroll, but not by the keyboard`);

  if (await browser.evaluate("document.getElementById('reference') !== null")) await expectReference(expect);
  if (recorded) await expectPlayback(tool, files, expect);
  if (files.some((each) => /^--(initial|input)/.test(each))) await expectGiven(tool, files, expect);

  expect(browser.complaints().length === 0, `complaints: ${browser.complaints().join("; ")}`);
  expect(browser.requests().length === 0, `requests: ${browser.requests().join(", ")}`);
  const size = statSync(file).size;
  expect(size < 1.4e6, `the page has ${size} bytes`);
  console.log(`${basename(file)}: ${size} bytes, ${formulas.count} formulas${failures.length ? "" : ", ok"}`);
  for (const each of failures) console.error(`${basename(file)}: ${each}`);
  failed ||= failures.length > 0;
}
await browser.close();
process.exit(failed ? 1 : 0);
