// SPDX-License-Identifier: GPL-3.0-or-later
// messages.mjs ROOT: each message that begins an item of a list of docs/errors.md stands in the sources. "…" is there for a part
// that is filled in: "{}" of a format, or the end of one piece of text and the beginning of the next.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const root = process.argv[2];
const sources = (folder) => readdirSync(join(root, folder), { withFileTypes: true }).flatMap((entry) =>
  entry.isDirectory() ? sources(join(folder, entry.name)) : /\.([ch]pp|py)$/.test(entry.name) ? [join(folder, entry.name)] : []);
const text = ["generator", "runtime", "python/torsor"].flatMap(sources)
  .map((file) => readFileSync(join(root, file), "utf8").replace(/"\s*\n\s*f?"/g, "").replace(/\\"/g, '"').replace(/\{[^{}\s]*\}/g, "…")).join("\n");

let count = 0, missing = 0;
for (const line of readFileSync(join(root, "docs/errors.md"), "utf8").split("\n")) {
  const message = /^\* `([^`]+)`<br>$/.exec(line)?.[1];
  if (!message) continue;
  ++count;
  if (text.includes(message)) continue;
  ++missing;
  console.error(`docs/errors.md: no source says: ${message}`);
}
console.log(`${count} messages, ${missing} of them in no source`);
process.exit(missing > 0 || count < 100 ? 1 : 0);
