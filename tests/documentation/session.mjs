// SPDX-License-Identifier: GPL-3.0-or-later
// session.mjs PAGE FOLDER [--write]: does what a page of the manual tells its reader, in an empty FOLDER, from top to bottom.
//   <!-- file: NAME -->    the code block that follows is written to NAME
//   <!-- append: NAME -->  it is added to the end of NAME
//   <!-- files first -->   all files of the page are written before its first command
//   <!-- fails: CODE -->   the command of the block that follows ends with that exit code, any other with 0
//   ```console             each line "$ COMMAND" is run; what it prints on both streams must be the lines after it. A line
//                          "..." stands for any number of lines, and at the end of a line for any rest of it.
// With --write the page is written again with what the commands print now; shorten it by hand.
import { spawnSync } from "node:child_process";
import { appendFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

const [page, folder, mode] = process.argv.slice(2);
if (!page || !folder) {
  console.error("session.mjs: usage: session.mjs PAGE FOLDER [--write]");
  process.exit(2);
}
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });

const lineMatches = (pattern, line) =>
  pattern.endsWith("...") ? line.startsWith(pattern.slice(0, -3)) : pattern.trimEnd() === line.trimEnd();

/// Whether lines from j on are those that patterns from i on stand for.
function matches(patterns, lines, i = 0, j = 0) {
  if (i === patterns.length) return j === lines.length;
  if (patterns[i].trim() === "...") {
    for (let k = j; k <= lines.length; ++k) if (matches(patterns, lines, i + 1, k)) return true;
    return false;
  }
  return j < lines.length && lineMatches(patterns[i], lines[j]) && matches(patterns, lines, i + 1, j + 1);
}

function run(command) {
  const done = spawnSync("bash", ["-c", `exec 2>&1; ${command}`], { cwd: folder, encoding: "utf8", timeout: 300000 });
  const text = done.stdout.replace(/\n$/, "");
  return { code: done.status, lines: text === "" ? [] : text.split("\n") };
}

let failures = 0, commands = 0, files = 0;
const written = [];
const lines = readFileSync(page, "utf8").split("\n");
const comment_of = (line) => /^<!-- (file|append|fails): (.*?) -->$/.exec(line);
function write(note, block) {
  const path = join(folder, note[2]);
  mkdirSync(dirname(path), { recursive: true });
  (note[1] === "file" ? writeFileSync : appendFileSync)(path, block.join("\n") + "\n");
  ++files;
}
const first = lines.includes("<!-- files first -->");
for (let i = 0; first && i < lines.length; ++i) {
  const comment = comment_of(lines[i]);
  if (comment && comment[1] !== "fails") write(comment, lines.slice(i + 2, lines.indexOf("```", i + 2)));
}
let note = null;
for (let i = 0; i < lines.length; ++i) {
  written.push(lines[i]);
  const comment = comment_of(lines[i]);
  if (comment) note = comment;
  if (!lines[i].startsWith("```")) {
    if (!comment && lines[i].trim() !== "" && note) throw new Error(`${page}:${i + 1}: no code block follows <!-- ${note[1]} -->`);
    continue;
  }
  const language = lines[i].slice(3).trim(), begin = i + 1;
  let end = begin;
  while (lines[end] !== "```") if (++end >= lines.length) throw new Error(`${page}:${begin}: a code block has no end`);
  const block = lines.slice(begin, end);
  i = end;
  if (note && note[1] !== "fails") {
    if (!first) write(note, block);
    written.push(...block);
  } else if (language === "console") {
    for (let k = 0; k < block.length;) {
      if (!block[k].startsWith("$ ")) throw new Error(`${page}:${begin + k + 1}: a line of output without a command`);
      const at = begin + k + 1, command = block[k].slice(2);
      let next = k + 1;
      while (next < block.length && !block[next].startsWith("$ ")) ++next;
      const expected = block.slice(k + 1, next), result = run(command);
      ++commands;
      const code = note ? Number(note[2]) : 0;
      if (result.code !== code || (mode !== "--write" && !matches(expected, result.lines))) {
        ++failures;
        console.error(`${page}:${at}: ${command}\nends with ${result.code}, expected ${code}, and prints\n${result.lines.join("\n")}\n`);
      }
      written.push(block[k], ...(expected.join() === "..." ? expected : result.lines));
      k = next;
    }
  } else {
    written.push(...block);
  }
  written.push("```");
  note = null;
}
if (mode === "--write") writeFileSync(page, written.join("\n"));
console.log(`${page}: ${files} files, ${commands} commands, ${failures} failures`);
if (commands === 0) console.error(`${page}: no command in it`);
process.exit(failures > 0 || commands === 0 ? 1 : 0);
