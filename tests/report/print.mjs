// SPDX-License-Identifier: GPL-3.0-or-later
// print.mjs BROWSER FOLDER PROGRAM...: reports of scene programs (or of "torsor FILE") as they are printed on A4: nothing is wider
// than the page. FOLDER keeps the PDFs.
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { Browser } from "./browser.mjs";

const [program, folder, ...scenes] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const browser = await Browser.start(program, { unseen: true });
const margin = 0.4, width = Math.floor((8.27 - 2 * margin) * 96);  // inches; of the page's text in CSS pixels
let failed = false;

for (const scene of scenes) {
  const [tool, ...files] = scene.split(" "), name = basename(files[0] ?? tool);
  const file = join(folder, `${name}.html`);
  if (!tool.endsWith(".html")) execFileSync(tool, ["report", ...files, "--output", file], { stdio: ["ignore", "ignore", "ignore"] });
  await browser.open(tool.endsWith(".html") ? tool : file);
  await browser.send("Emulation.setDeviceMetricsOverride", { width, height: 1000, deviceScaleFactor: 1, mobile: false });
  await browser.send("Emulation.setEmulatedMedia", { media: "print" });
  const wide = await browser.evaluate(`(async () => {
    window.dispatchEvent(new Event("beforeprint"));
    await document.fonts.ready;
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const seen = (each) => each.textContent.slice(0, 60).replace(/\\s+/g, " ");
    const edge = document.documentElement.clientWidth + 0.5;
    const cut = [...document.querySelectorAll(".formula, pre, p, figure, svg, h1, h2, h3")].filter((each) => {
      const box = each.getBoundingClientRect();
      return box.width > 0 && (box.right > edge || each.scrollWidth > each.clientWidth + 1 && each.clientWidth > 0 && getComputedStyle(each).display !== "inline");
    });
    return cut.map((each) => each.className + " " + each.tagName + " by " + Math.round(Math.max(each.scrollWidth - each.clientWidth, each.getBoundingClientRect().right - edge)) + " px: " + (each.dataset.latex ?? seen(each)).slice(0, 200));
  })()`);
  // Smaller letters than half their size nobody reads; what would need them is there as text.
  const tiny = await browser.evaluate(`[...document.querySelectorAll(".formula")].filter((each) => each.style.getPropertyValue("--on-paper") && (Number(each.style.getPropertyValue("--on-paper")) < 0.5 ||
    each.classList.contains("not-on-paper") && (each.offsetWidth > 0 || !(each.parentElement.querySelector("pre.on-paper")?.offsetWidth > 0)))).length`);
  if (tiny > 0) wide.push(`${tiny} formulas in letters that nobody reads`);
  const { data } = await browser.send("Page.printToPDF", { paperWidth: 8.27, paperHeight: 11.69, marginTop: margin, marginBottom: margin, marginLeft: margin, marginRight: margin });
  writeFileSync(join(folder, `${name}.pdf`), Buffer.from(data, "base64"));
  await browser.send("Emulation.setEmulatedMedia", { media: "" });
  await browser.send("Emulation.clearDeviceMetricsOverride");
  console.log(`${name}: ${wide.length === 0 ? "fits the page" : `${wide.length} too wide`}`);
  for (const each of wide) console.error(`  ${each}`);
  failed ||= wide.length > 0;
}
await browser.close();
process.exit(failed ? 1 : 0);
