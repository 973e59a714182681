// SPDX-License-Identifier: GPL-3.0-or-later
// picture.mjs BROWSER REPORT PICTURE: two views of a report side by side, the motion and the equations: docs/pictures/report.png.
import { tmpdir } from "node:os";
import { join } from "node:path";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { Browser } from "../report/browser.mjs";

const [program, report, picture] = process.argv.slice(2);
const width = 760, height = 690;
const folder = mkdtempSync(join(tmpdir(), "torsor_picture_"));
const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
const shot = async (browser, clip) => Buffer.from((await browser.send("Page.captureScreenshot", { format: "png", ...clip })).data, "base64");

const browser = await Browser.start(program, { width: 2 * width + 20, height });
const size = (wide) => browser.send("Emulation.setDeviceMetricsOverride", { width: wide, height, deviceScaleFactor: 1, mobile: false });
await browser.send("Emulation.setScrollbarsHidden", { hidden: true });
await size(width);
await browser.open(report);
await wait(5000);
writeFileSync(join(folder, "motion.png"), await shot(browser, {}));
await browser.evaluate(`[...document.querySelectorAll("h2, h3, summary")].find((each) => /Kinetic energy/.test(each.textContent)).scrollIntoView()`);
await wait(4000);
writeFileSync(join(folder, "equations.png"), await shot(browser, {}));
await size(2 * width + 20);
writeFileSync(join(folder, "both.html"), `<!DOCTYPE html><meta charset="utf-8"><body style="margin:0;display:flex;gap:20px;background:#cbd5e1">
<img src="motion.png" width="${width}"><img src="equations.png" width="${width}"></body>`);
await browser.open(join(folder, "both.html"));
await wait(1000);
writeFileSync(picture, await shot(browser, { clip: { x: 0, y: 0, width: 2 * width + 20, height, scale: 0.68 } }));
await browser.close();
rmSync(folder, { recursive: true });
