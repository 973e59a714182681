// SPDX-License-Identifier: GPL-3.0-or-later
// compare.mjs NAME STATES FOLDER C++-COMPILER C-COMPILER...: evaluates every kernel of FOLDER/NAME.mjs, .h and .hpp at
// the same random states and expects the same bits from all of them: results, Taylor coefficients, statuses. C in float is
// compared with C++ in float, and C as header and source file (FOLDER/apart) too. All describe themselves alike.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";

const [name, count, folder, cppCompiler, ...cCompilers] = process.argv.slice(2);
const states = Number(count), order = 6;
const m = await import(resolve(folder, `${name}.mjs`));
const sizes = {
  parameters: m.parameters.length,
  state: m.stateSize,
  accelerations: m.velocities.length,
  multipliers: m.multipliers.length,
  inputs: m.inputs.length,
};
const width = Object.values(sizes).reduce((sum, size) => sum + size, 0);

// States: ordinary ones, some at rest, some with angles of many turns, some that are not finite.
let seed = 12345n;
function uniform() {
  seed = (seed * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
  return Number(seed >> 11n) / 2 ** 53;
}
const data = new Float64Array(width * states);
for (let s = 0; s < states; ++s) {
  const row = data.subarray(width * s, width * (s + 1));
  const kind = s % 10;
  for (let i = 0; i < row.length; ++i) row[i] = 4 * uniform() - 2;
  const defaults = m.defaultParameters();
  for (let i = 0; i < sizes.parameters; ++i) row[i] = Number.isNaN(defaults[i]) ? 0.5 + uniform() : defaults[i];
  const state = row.subarray(sizes.parameters, sizes.parameters + sizes.state);
  const q = state.subarray(1, 1 + m.coordinates.length);
  if (kind === 7) state.fill(0);
  if (kind === 8) for (let i = 0; i < q.length; ++i) q[i] *= 10 ** (12 * uniform());
  if (kind === 9 && q.length > 0) q[Math.floor(uniform() * q.length)] = s % 20 === 9 ? NaN : Infinity;
  for (const first of m.quaternions) {
    const norm = Math.hypot(...q.subarray(first, first + 4));
    if (norm > 0 && norm < Infinity) for (let i = 0; i < 4; ++i) q[first + i] /= norm;
  }
}
writeFileSync(join(folder, `${name}.states`), data);

// What each kernel writes, one number after the other; its status goes last.
const taylor = sizes.state - 1;
const outputs = m.kernels.map((kernel) => {
  const size = kernel.results.reduce((sum, result) => sum + result.size, 0);
  return size + (kernel.coefficients ? taylor * (order + 1) : 0) + 1;
});

function ofModule() {
  const all = [];
  for (let s = 0; s < states; ++s) {
    let at = width * s;
    const take = (size) => data.slice(at, (at += size));
    const parameters = take(sizes.parameters), state = take(sizes.state);
    const given = { accelerations: take(sizes.accelerations), multipliers: take(sizes.multipliers), inputs: take(sizes.inputs) };
    const precomputed = m.precompute(parameters);
    for (const kernel of m.kernels) {
      const results = kernel.results.map((result) => new Float64Array(result.size));
      const coefficients = new Float64Array(taylor * (order + 1));
      const more = kernel.coefficients ? [order, coefficients] : [];
      const status = m[kernel.name](precomputed, state, ...kernel.arguments.map((a) => given[a]), ...results, ...more);
      for (const result of results) all.push(...result);
      if (kernel.coefficients) all.push(...coefficients);
      all.push(status ?? 0);
    }
  }
  return new Float64Array(all);
}

const vectors = ["Accelerations", "Multipliers", "GeneralizedForces"];
const isArray = (result) => !result.structure || vectors.includes(result.structure);

/// What the texts say of themselves, a line for each fact.
const lists = { coordinates: m.coordinates, velocities: m.velocities, inputs: m.inputs, multipliers: m.multipliers, parameters: m.parameters };
const description = [];
for (const [list, all] of Object.entries(lists)) for (const each of all) description.push(`${list} ${each.name} ${each.unit}`);
for (const kernel of m.kernels) {
  const reads = ["accelerations", "multipliers", "inputs"].map((argument) => Number(kernel.arguments.includes(argument)));
  description.push(`kernel ${kernel.name} ${reads.join(" ")} ${Number(kernel.status)}`);
  for (const result of kernel.results) {
    if (isArray(result)) description.push(`${result.name}  ${result.rows ?? result.size} ${result.columns ?? 1}`);
    else for (const each of result.members ?? []) description.push(`${result.name} ${each.name} ${each.rows ?? 1} ${each.columns ?? 1}`);
  }
  if (kernel.coefficients) description.push(`coefficients  ${kernel.coefficients} 0`);
}
/// The same from a program: of the list of a name its entry k, and the number of entries.
function describing(at, size) {
  let text = "    if (argc == 3) {\n      FILE* say = fopen(argv[2], \"w\");\n      if (say == 0) return 1;\n";
  for (const list of Object.keys(lists)) {
    text += `      for (int k = 0; k < ${size(list)}; ++k) fprintf(say, "${list} %s %s\\n", ${at(list)}.name, ${at(list)}.unit);\n`;
  }
  const kernel = at("kernels");
  text += `      for (int k = 0; k < ${size("kernels")}; ++k) {\n        fprintf(say, "kernel %s %d %d %d %d\\n", ${kernel}.name, `;
  text += `(int)${kernel}.reads_accelerations, (int)${kernel}.reads_multipliers, (int)${kernel}.reads_inputs, (int)${kernel}.has_status);\n`;
  text += `        for (int r = 0; r < ${kernel}.result_count; ++r)\n          fprintf(say, "%s %s %d %d\\n", ${kernel}.results[r].result, `;
  text += `${kernel}.results[r].member, ${kernel}.results[r].rows, ${kernel}.results[r].columns);\n      }\n`;
  return text + "      if (fclose(say) != 0) return 1;\n    }\n";
}

/// Reads the states, in the numbers `real` of the program, and writes results as doubles.
const readStates = (real, say) => `static FILE* out;
static void put(const ${real}* from, int count) {
  for (int i = 0; i < count; ++i) {
    const double number = (double)from[i];
    fwrite(&number, sizeof number, 1, out);
  }
}
int main(int argc, char** argv) {
  FILE* in = fopen("${join(folder, name)}.states", "rb");
  if (argc < 2 || in == 0) return 1;
${say}
  out = fopen(argv[1], "wb");
  if (out == 0) return 1;
  double row[${width}];
  while (fread(row, sizeof(double), ${width}, in) == ${width}) {
    ${real} numbers[${width}];
    for (int i = 0; i < ${width}; ++i) numbers[i] = (${real})row[i];
    const ${real}* at = numbers;
`;
const end = "  }\n  return fclose(out) != 0;\n}\n";

/// Calls of all kernels: how a result is declared, passed and read.
function calls(declaration, passed, read, call, coefficients) {
  let text = "";
  for (const kernel of m.kernels) {
    text += "    {\n";
    kernel.results.forEach((result, i) => (text += `      ${declaration(result, `r${i}`)}\n`));
    const jets = Boolean(kernel.coefficients);
    if (jets) text += `      ${coefficients}\n`;
    const list = ["precomputed", "state", ...kernel.arguments];
    const results = kernel.results.map((result, i) => passed(result, `r${i}`));
    const given = call(kernel.name, list, [...results, ...(jets ? [String(order), "c"] : [])]);
    text += kernel.status ? `      const int code = (int)${given};\n` : `      ${given};\n      const int code = 0;\n`;
    kernel.results.forEach((result, i) => (text += `      put(${read(result, `r${i}`)}, ${result.size});\n`));
    if (jets) text += `      put(&c[0]${declaration === declaredInCpp ? "[0]" : ""}, ${taylor * (order + 1)});\n`;
    text += "      const REAL status = (REAL)code;\n      put(&status, 1);\n    }\n";
  }
  return text;
}

const declaredInC = (result, r) =>
  isArray(result) ? `torsor_real ${r}[${Math.max(1, result.size)}] = {0};` : `${name}_${result.structure} ${r};`;
const declaredInCpp = (result, r) => `${result.structure ? `M::${result.structure}` : `std::array<REAL, ${result.size}>`} ${r}{};`;

function driverInC() {
  const counts = [m.coordinates.length, m.velocities.length];
  let text = `#include "${name}.h"\n#include <stdio.h>\n#include <string.h>\n#define REAL torsor_real\n`;
  const singular = { coordinates: "coordinate", velocities: "velocity", inputs: "input", multipliers: "multiplier", parameters: "parameter", kernels: "kernel" };
  text += readStates("torsor_real", describing((list) => `${name}_${list}[k]`, (list) => `${name}_${singular[list]}_size`));
  text += `    ${name}_precomputed precomputed;\n    ${name}_precompute(at, &precomputed);\n    at += ${sizes.parameters};\n`;
  text += `    ${name}_state state;\n    state.time = at[0];\n`;
  text += `    memcpy(state.q, at + 1, ${counts[0]} * sizeof(torsor_real));\n`;
  text += `    memcpy(state.v, at + ${1 + counts[0]}, ${counts[1]} * sizeof(torsor_real));\n    at += ${sizes.state};\n`;
  text += "    const torsor_real *accelerations = at, *multipliers = at + SKIP1, *inputs = at + SKIP2;\n"
    .replace("SKIP1", sizes.accelerations)
    .replace("SKIP2", sizes.accelerations + sizes.multipliers);
  text += "    (void)accelerations, (void)multipliers, (void)inputs;\n";
  const passed = (result, r) => (isArray(result) ? r : `&${r}`);
  const call = (kernel, given, results) => `${name}_${kernel}(${[`&${given[0]}`, `&${given[1]}`, ...given.slice(2), ...results].join(", ")})`;
  const coefficients = `torsor_real c[${taylor * (order + 1)}];\n      memset(c, 0, sizeof c);`;
  return text + calls(declaredInC, passed, (result, r) => (isArray(result) ? r : `(const torsor_real*)&${r}`), call, coefficients) + end;
}

function driverInCpp(real) {
  let text = `#include "${name}.hpp"\n#include <cstdio>\n#include <cstring>\nusing REAL = ${real};\nusing M = ${name}::Mechanism<REAL>;\n`;
  text += "template <class T>\nT filled(const REAL* from, unsigned size) {\n  T t{};\n";
  text += "  if (size > 0) std::memcpy(static_cast<void*>(&t), from, sizeof(REAL) * size);\n  return t;\n}\n";
  text += readStates("REAL", describing((list) => `M::Description::${list}[(unsigned)k]`, (list) => `(int)M::Description::${list}.size()`));
  text += `    const auto precomputed = M::precompute(filled<M::Parameters>(at, ${sizes.parameters}));\n    at += ${sizes.parameters};\n`;
  text += `    const auto state = filled<M::State>(at, ${sizes.state});\n    at += ${sizes.state};\n`;
  for (const [type, key] of [["Accelerations", "accelerations"], ["Multipliers", "multipliers"], ["Inputs", "inputs"]]) {
    text += `    const auto ${key} = filled<M::${type}>(at, ${sizes[key]});\n    at += ${sizes[key]};\n    (void)${key};\n`;
  }
  const call = (kernel, given, results) => `M::${kernel}(${[...given, ...results].join(", ")})`;
  const read = (result, r) => `reinterpret_cast<const REAL*>(&${r})`;
  return text + calls(declaredInCpp, (result, r) => r, read, call, `std::array<REAL, ${taylor}> c[${order + 1}] = {};`) + end;
}

const found = [];
function run(driver, extension, compiler, flags, where = folder, sources = []) {
  const base = join(where, `${name}_${compiler.replace(/\W/g, "")}_${flags.join("").replace(/\W/g, "")}_${extension}`);
  writeFileSync(`${base}.${extension}`, driver);
  const options = [...flags, "-O1", "-ffp-contract=off", `-I${where}`, `${base}.${extension}`, ...sources, "-o", base, "-lm"];
  execFileSync(compiler, options, { stdio: "inherit" });
  execFileSync(base, [`${base}.out`, `${base}.description`], { stdio: "inherit" });
  const said = readFileSync(`${base}.description`, "utf8").split("\n").slice(0, -1);
  const wrong = [...said, ""].findIndex((line, i) => line !== (description[i] ?? ""));
  if (wrong >= 0) found.push(`${base} describes itself by "${said[wrong]}" instead of "${description[wrong]}"`);
  const bytes = readFileSync(`${base}.out`);
  return new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/// What is not a number has many bit patterns, of which languages promise none.
function differences(expected, found, language) {
  if (expected.length !== found.length) return [`${language}: ${found.length} numbers instead of ${expected.length}`];
  const list = [];
  let at = 0;
  for (let s = 0; s < states; ++s) {
    m.kernels.forEach((kernel, k) => {
      for (let i = 0; i < outputs[k]; ++i, ++at) {
        if (!Object.is(expected[at], found[at])) {
          list.push(`${language}: ${kernel.name}, state ${s}, number ${i}: ${found[at]} instead of ${expected[at]}`);
        }
      }
    });
  }
  return list;
}

const reference = run(driverInCpp("double"), "cpp", cppCompiler, ["-std=c++17"]);
const single = run(driverInCpp("float"), "cpp", cppCompiler, ["-std=c++17", "-DSINGLE"]);
found.push(...differences(reference, ofModule(), "JavaScript"));
const strict = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror"];
for (const compiler of cCompilers) {
  found.push(...differences(reference, run(driverInC(), "c", compiler, strict), compiler));
  found.push(...differences(single, run(driverInC(), "c", compiler, [...strict, "-DTORSOR_SINGLE"]), `${compiler} in float`));
}
// Where sums may be reassociated those of sines stay as they are. Elsewhere that is rounding, which few results let grow.
for (const compiler of cCompilers) {
  const loose = run(driverInC(), "c", compiler, ["-std=c99", "-O2", "-funsafe-math-optimizations"]);
  const off = reference.filter((number, i) => Number.isFinite(number) && !(Math.abs(loose[i] - number) <= 1e-3 * Math.abs(number) + 1e-9));
  if (off.length > reference.length / 100) {
    found.push(`${compiler} with -funsafe-math-optimizations: ${off.length} of ${reference.length} numbers are others`);
  }
}
const apart = join(folder, "apart");
found.push(...differences(reference, run(driverInC(), "c", cCompilers[0], strict, apart, [join(apart, `${name}.c`)]), "C with a source file"));
// What is said to compile, compiles.
const header = join(folder, `${name}.h`);
for (const compiler of cCompilers) {
  for (const flags of [["-DTORSOR_LIBM"], ["-ffast-math"], ["-DTORSOR_SINGLE", "-DTORSOR_LIBM"]]) {
    execFileSync(compiler, ["-fsyntax-only", ...strict, ...flags, "-xc", header], { stdio: "inherit" });
  }
  const asCpp = ["-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Werror"];
  execFileSync(compiler, ["-fsyntax-only", ...asCpp, "-xc++", header], { stdio: "inherit" });
}
if (reference.length === 0) found.push("nothing was computed");
console.log(`${name}: ${m.kernels.length} kernels, ${states} states, ${reference.length} numbers, ${found.length} differ`);
for (const line of found.slice(0, 20)) console.log(line);
process.exit(found.length === 0 ? 0 : 1);
