// SPDX-License-Identifier: MIT
// The page's core module, run in Node: core_module_test.mjs FOLDER [VERSORIUM]. FOLDER has the module
// without threads; the native program, if given, must give the same bytes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, native] = process.argv.slice(2);
if (!existsSync(join(folder, "versorium_core.wasm"))) {
  console.log(`SKIPPED: ${folder} has no versorium_core.wasm: run scripts/build web`);
  process.exit(77);
}
const load = (name) => import(pathToFileURL(resolve(folder, name)));
const { default: create } = await load("versorium_core.mjs");
const { openCore, CoreError } = await load("core.mjs");
const core = await openCore(create, { wasmBinary: readFileSync(join(folder, "versorium_core.wasm")) });

const scene = core.preset("mandelbrot");
assert.equal(scene.map, "quadratic");

// PNG's signature, and the size in its first chunk.
const png = core.render(scene, 48, 36);
assert.deepEqual([...png.slice(0, 8)], [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const header = new DataView(png.buffer, png.byteOffset);
assert.deepEqual([header.getUint32(16), header.getUint32(20)], [48, 36]);
assert.deepEqual(core.render(JSON.stringify(scene), 48, 36), png);

// 0 belongs to the Mandelbrot set: the field has members and others.
const npy = core.measure(scene, "membership", 48, 36);
const headerSize = 10 + new DataView(npy.buffer, npy.byteOffset).getUint16(8, true);
const values = new Float64Array(npy.slice(headerSize).buffer);
assert.equal(values.length, 48 * 36);
assert.deepEqual([...new Set(values)].sort(), [0, 1]);

// What is wrong is said, and the core goes on.
const refused = (kind, words, work) =>
  assert.throws(work, (error) => {
    assert.ok(error instanceof CoreError, String(error));
    assert.equal(error.kind, kind);
    assert.match(error.message, words);
    return true;
  });
refused("data", /./, () => core.render("{", 48, 36));
refused("data", /nonsense/, () => core.render({ ...scene, nonsense: 1 }, 48, 36));
refused("usage", /./, () => core.render(scene, -1, 36));
refused("usage", /./, () => core.render(scene, 1e9, 1e9));
refused("usage", /nonsense/, () => core.measure(scene, "nonsense", 48, 36));
refused("usage", /nonsense/, () => core.preset("nonsense"));
assert.deepEqual(core.render(scene, 48, 36), png);

if (native) {
  const theirs = execFileSync(native, ["render", "mandelbrot", "--size", "48x36", "-o", "-"]);
  assert.ok(theirs.equals(Buffer.from(png)), "the native program gives other bytes");
}
core.close();
console.log(`the module renders and measures${native ? ", with the native program's bytes" : ""}`);
