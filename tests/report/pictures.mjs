// SPDX-License-Identifier: GPL-3.0-or-later
// pictures.mjs BROWSER FOLDER NAME...: FOLDER/NAME.png, the mechanism of FOLDER/NAME.html a while after it started.
import { join } from "node:path";
import { writeFileSync } from "node:fs";
import { Browser } from "./browser.mjs";

const [program, folder, ...names] = process.argv.slice(2);
const browser = await Browser.start(program, { width: 900, height: 900 });
for (const name of names) {
  await browser.open(join(folder, `${name}.html`));
  await browser.moved(10);
  await new Promise((done) => setTimeout(done, 1500));
  const clip = await browser.evaluate(`(() => {
    const view = document.getElementById("view");
    if (!view) return null;
    const { x, y, width, height } = view.getBoundingClientRect();
    return { x, y, width, height, scale: 0.75 };
  })()`);
  if (!clip) continue;
  const { data } = await browser.send("Page.captureScreenshot", { format: "png", clip });
  writeFileSync(join(folder, `${name}.png`), Buffer.from(data, "base64"));
}
await browser.close();
