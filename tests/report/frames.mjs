// SPDX-License-Identifier: GPL-3.0-or-later
// frames.mjs BROWSER PROGRAM...: frames a second of the reports of scene programs (or of "torsor FILE") while they move, after
// they have been integrated, and the processor time of a frame. The browser draws as it does without a
// graphics card.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { Browser } from "./browser.mjs";

const [program, ...scenes] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "torsor-frames-"));
const browser = await Browser.start(program, { width: 1100, height: 900, software: true });

/// Processor time of all processes of the browser so far [s].
async function processorTime() {
  const { processInfo } = await browser.send("SystemInfo.getProcessInfo", {}, "");
  return processInfo.reduce((sum, each) => sum + each.cpuTime, 0);
}

console.log("page                            bodies  frames a second  processor time of a frame [ms]");
for (const scene of scenes) {
  const [tool, ...files] = scene.split(" "), name = basename(files.find((each) => !each.startsWith("-")) ?? tool), file = join(folder, `${name}.html`);
  execFileSync(tool, ["report", ...files, "--output", file], { stdio: ["ignore", "ignore", "ignore"] });
  await browser.open(file);
  if (!(await browser.moved())) throw new Error(`${name}: the motion is not known after ten minutes`);
  const before = await processorTime();
  const [frames, seconds, bodies] = await browser.evaluate(`new Promise((done) => {
    const time = document.getElementById("time"), play = document.getElementById("play"), begin = performance.now();
    let frames = 0;
    time.value = 0;
    time.dispatchEvent(new Event("input"));
    play.click();
    const next = () => {
      ++frames;
      if (document.getElementById("play").textContent !== "Pause") play.click();  // at the end, from the beginning
      if (performance.now() - begin < 6000) requestAnimationFrame(next);
      else done([frames, (performance.now() - begin) / 1000, JSON.parse(document.getElementById("scene").textContent).bodies.length]);
    };
    requestAnimationFrame(next);
  })`);
  const spent = await processorTime() - before;
  console.log(`${name.padEnd(32)}${String(bodies).padStart(6)}${(frames / seconds).toFixed(1).padStart(17)}${(1000 * spent / frames).toFixed(1).padStart(32)}`);
}
await browser.close();
rmSync(folder, { recursive: true, force: true });
