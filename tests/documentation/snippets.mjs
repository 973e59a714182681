// SPDX-License-Identifier: GPL-3.0-or-later
// snippets.mjs ROOT FOLDER PROGRAM -- COMPILER [FLAGS]: every block of C++, C and JavaScript of README and docs/ stands in a file
// of tests/documentation/snippets/, which says what it takes for granted, and these compile. JavaScript is run.
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const separator = process.argv.indexOf("--");
const [root, folder, program] = process.argv.slice(2, separator).map((each) => resolve(each)), compiler = process.argv.slice(separator + 1);
/// Worked through elsewhere: scene_examples_test.cpp, session.mjs.
const elsewhere = new Set(["docs/scene.md", "docs/tutorial.md", "docs/cookbook.md"]);

let failures = 0;
const fail = (text) => { ++failures; console.error(text); };

/// Blocks by language and place: "cpp docs/batches.md 3".
const blocks = new Map();
for (const page of ["README.md", ...readdirSync(join(root, "docs")).filter((name) => name.endsWith(".md")).sort().map((name) => `docs/${name}`)]) {
  if (elsewhere.has(page)) continue;
  const lines = readFileSync(join(root, page), "utf8").split("\n"), count = {};
  for (let i = 0; i < lines.length; ++i) {
    const language = /^```(\w*)/.exec(lines[i])?.[1];
    if (language === undefined) continue;
    const line = i + 2, code = [];
    while (lines[++i] !== "```") code.push(lines[i]);
    count[language] = (count[language] ?? 0) + 1;
    blocks.set(`${language} ${page} ${count[language]}`, { line, code, used: false });
  }
}
// README's scene is the tutorial's.
blocks.get("cpp README.md 1").used = true;

/// The text of a file with the blocks in their places.
function filled(name, language) {
  const text = readFileSync(join(root, "tests/documentation/snippets", name), "utf8").split("\n");
  return text.flatMap((line, i) => {
    const place = /^\s*\/[/*] snippet: (\S+ \d+)/.exec(line)?.[1];
    if (!place) return [line];
    const block = blocks.get(`${language} ${place}`);
    if (!block) { fail(`${name}:${i + 1}: there is no block ${place} of ${language}`); return []; }
    if (block.used) fail(`${name}:${i + 1}: ${place} stands twice`);
    block.used = true;
    return [`#line ${block.line} "${place.split(" ")[0]}"`, ...block.code, `#line ${i + 2} "tests/documentation/snippets/${name}"`];
  }).join("\n");
}

function run(command, ...options) {
  const done = spawnSync(command, options, { cwd: folder, encoding: "utf8", timeout: 280000 });
  if (done.status !== 0) fail(`${command} ${options.join(" ")}\n${done.error ?? ""}${done.stdout ?? ""}${done.stderr ?? ""}`);
  return done.stdout;
}

mkdirSync(folder, { recursive: true });
for (const name of ["generator.cpp", "runtime.cpp"]) {
  writeFileSync(join(folder, name), filled(name, "cpp"));
  run(compiler[0], ...compiler.slice(1), "-std=c++20", "-fsyntax-only", `-I${root}`, `-I${join(root, "include")}`, name);
}

// What double_pendulum.h and double_pendulum.mjs are, the program says.
for (const language of ["c99", "javascript"])
  run(program, "generate", `--language=${language}`, "--output", language === "c99" ? "double_pendulum.h" : "double_pendulum.mjs");
const c = filled("kernels.c", "c");
writeFileSync(join(folder, "kernels.c"), c);
run(compiler[0], "-x", "c", "-std=c99", "-fsyntax-only", "-Wall", "-Wno-unused-variable", "-I.", "kernels.c");
for (const [place, block] of blocks) {
  if (place.startsWith("js ")) {  // it is run
    writeFileSync(join(folder, "block.mjs"), block.code.join("\n") + "\nexport { status, pendulum };\n");
    const { status, pendulum } = await import(pathToFileURL(join(folder, "block.mjs")));
    if (status !== pendulum.Status.ok) fail(`${place}: status ${status}`);
    block.used = true;
  }
  if (/^(cpp|c|js) /.test(place) && !block.used) fail(`${place} stands in no file of tests/documentation/snippets/: add it there`);
  if (place.startsWith("sh ")) { run("bash", "-n", "-c", block.code.join("\n")); block.used = true; }
}
const tried = [...blocks.values()].filter((block) => block.used).length;
console.log(`${tried} blocks of code, ${failures} failures`);
process.exit(failures > 0 || tried < 40 ? 1 : 0);
