// SPDX-License-Identifier: MIT
// The fields of the GPU against the CPU's, in a browser:
// gpu_fields_test.mjs ROOT runs tests/gpu/fields_test.cpp and averaged_test.cpp as a page.
// What of the latter says nothing about the shaders is left to the window's graphics.
import { createServer } from "node:http";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { patience, prepare, waitFor } from "./browser.mjs";

const root = process.argv[2];
const folder = join(root, "build/web/tests/gpu");
if (!existsSync(join(folder, "versorium_gpu_tests.wasm"))) {
  console.log(`SKIPPED: ${folder} has no versorium_gpu_tests.wasm: run scripts/build web`);
  process.exit(77);
}
const { browser } = await prepare(root);

const html = `<!doctype html><meta charset="utf-8"><canvas id="canvas" width="16" height="16"></canvas>
<script type="module">
import create from "./versorium_gpu_tests.mjs";
window.lines = [];
const say = (line) => window.lines.push(line);
create({ arguments: ["--gtest_filter=-GpuAveraged.GoesOn*:GpuAveraged.Colours*"], canvas: document.getElementById("canvas"), print: say, printErr: say,
  onExit: (code) => { window.code = code; } }).catch((error) => { say(String(error)); window.code = 1; });
</script>`;
const kinds = { ".mjs": "text/javascript", ".wasm": "application/wasm" };
const server = createServer((request, response) => {
  const name = request.url.slice(1);
  const kind = kinds[name.slice(name.lastIndexOf("."))];
  if (name && !kind) return response.writeHead(404).end();
  response.writeHead(200, { "content-type": kind ?? "text/html" });
  response.end(name ? readFileSync(join(folder, name)) : html);
});
await new Promise((done) => server.listen(0, "127.0.0.1", done));

const page = await browser.newPage();
await page.goto(`http://127.0.0.1:${server.address().port}/`);
let failed = true;
try {
  await waitFor(page, () => window.code !== undefined, undefined, 4 * patience);
  failed = (await page.evaluate(() => window.code)) !== 0;
} finally {
  console.log((await page.evaluate(() => window.lines)).join("\n"));
  await browser.close();
  server.close();
}
process.exit(failed ? 1 : 0);
