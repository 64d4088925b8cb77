// SPDX-License-Identifier: MIT
// The page where it is not alone: within another page, in a folder of a server that sends no special
// headers, without WebGL 2, under two fingers, after a lost context. surroundings_test.mjs ROOT
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { changed, fragment, patience, prepare, runAll, waitFor } from "./browser.mjs";

const [root] = process.argv.slice(2);
const { dist, browser } = await prepare(root);

// The page below /some/folder/, and at / a tall page that has it in a frame. Nothing more is sent
// than a plain host for static files sends; below /isolated/ the page comes with the headers that
// threads need.
const types = {
  ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".mjs": "text/javascript",
  ".wasm": "application/wasm", ".svg": "image/svg+xml", ".webmanifest": "application/manifest+json",
};
const outer =
  '<!doctype html><body style="height:3000px"><iframe src="some/folder/" width="1000" height="600"></iframe>';
const server = createServer((request, response) => {
  const path = new URL(request.url, "http://localhost").pathname;
  const [, folder, name] = path.match(/^\/(some\/folder|isolated)\/(.*)$/) ?? [];
  const file = folder && join(dist, name || "index.html");
  if (folder === "isolated") {
    response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
    response.setHeader("Cross-Origin-Embedder-Policy", "require-corp");
  }
  if (path === "/") response.writeHead(200, { "Content-Type": "text/html" }).end(outer);
  else if (file && existsSync(file))
    response.writeHead(200, { "Content-Type": types[extname(file)] }).end(readFileSync(file));
  else response.writeHead(404).end();
});
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const outside = `http://localhost:${server.address().port}/`;
const address = outside + "some/folder/";

const ready = (page) => waitFor(page, () => document.documentElement?.dataset.state === "ready");
const finished = (page) => waitFor(page, () => window.versorium?.finished);

// Without motion, so that states can be compared.
async function visit(browser, where, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options,
  });
  const page = await context.newPage();
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(String(error)));
  page.on("console", (line) => ["error", "warning"].includes(line.type()) && page.faults.push(line.text()));
  await page.goto(where);
  return page;
}
async function open(browser, options, where = address) {
  const page = await visit(browser, where, options);
  await ready(page);
  await finished(page);
  return page;
}
const spot = [180, 150]; // in the left picture, away from its ring

const tests = {
  async "from a folder, then without a network, isolated by its service worker"(browser) {
    const page = await open(browser);
    assert.equal(await page.evaluate(() => crossOriginIsolated), false);
    await waitFor(page, () => navigator.serviceWorker.controller !== null);
    const state = await fragment(page);
    await page.context().setOffline(true);
    await page.reload();
    await ready(page);
    assert.equal(await fragment(page), state);
    assert.equal(await page.evaluate(() => crossOriginIsolated), true);
    await page.context().close();
  },

  async "with threads and without them the pictures are the same"(browser) {
    if (!existsSync(join(dist, "threads"))) throw new Error("the program with threads is missing");
    const shots = [];
    for (const [where, isolated] of [[address, false], [outside + "isolated/", true]]) {
      const page = await open(browser, {}, where);
      const threads = await page.evaluate(() => versorium.threads);
      assert.equal(threads > 0, isolated, `${threads} threads`);
      for (let k = 0; k < 3; ++k) {
        await page.mouse.move(...spot);
        await page.mouse.wheel(0, -200);
        await page.waitForTimeout(50); // a picture that is on its way is overtaken
      }
      await page.mouse.move(1200, 790);
      await page.waitForTimeout(800);
      await finished(page);
      shots.push(await page.screenshot());
      assert.deepEqual(page.faults, []);
      await page.context().close();
    }
    assert.ok(shots[0].equals(shots[1]), "the pictures differ");
  },

  async "in a frame the wheel scrolls the page around it until a click"(browser) {
    const page = await visit(browser, outside);
    const frame = page.frames()[1];
    await ready(frame);
    const before = await fragment(frame);
    await frame.evaluate(() => document.activeElement.blur());
    await page.mouse.move(...spot);
    await page.mouse.wheel(0, 200);
    await waitFor(page, () => scrollY > 0);
    assert.equal(await fragment(frame), before);
    await page.evaluate(() => scrollTo(0, 0));
    await waitFor(page, () => scrollY === 0);
    await page.mouse.click(...spot);
    await page.mouse.wheel(0, -200);
    await changed(frame, before);
    assert.equal(await page.evaluate(() => scrollY), 0);
    await page.context().close();
  },

  async "a drag goes on beyond the canvas"(browser) {
    const page = await open(browser);
    const first = await fragment(page);
    await page.mouse.move(...spot);
    await page.mouse.down();
    await page.mouse.move(5, spot[1], { steps: 4 });
    await changed(page, first);
    const inside = await fragment(page);
    await page.mouse.move(-120, spot[1], { steps: 4 });
    await changed(page, inside);
    await page.mouse.up();
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "two fingers zoom and move"(browser) {
    const page = await open(browser, {
      viewport: { width: 390, height: 844 }, deviceScaleFactor: 3, isMobile: true, hasTouch: true,
    });
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    for (const [dx, dy] of [[10, 0], [0, 8]]) {
      // First apart from one another, then both in one direction.
      const before = await fragment(page);
      await touch("touchStart", [110, 280], [180, 280]);
      for (let k = 1; k <= 5; ++k)
        await touch("touchMove", [110 - k * dx, 280 + k * dy], [180 + k * dx, 280 + k * dy]);
      await touch("touchEnd");
      await changed(page, before);
      await finished(page);
    }
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "a lost context leaves no error behind"(browser) {
    const page = await open(browser);
    await page.evaluate(async () => {
      const canvas = document.getElementById("canvas");
      const gl = canvas.getContext("webgl2");
      const extension = gl.getExtension("WEBGL_lose_context");
      const once = (name) => new Promise((done) => canvas.addEventListener(name, done, { once: true }));
      const lost = once("webglcontextlost");
      extension.loseContext();
      await lost;
      gl.getError(); // says that it is lost, once
      await new Promise((done) => setTimeout(done, 50));
      const restored = once("webglcontextrestored");
      extension.restoreContext();
      await restored;
    });
    const frames = await page.evaluate(() => versorium.framesDrawn);
    await waitFor(page, (before) => versorium.framesDrawn > before + 2, frames);
    assert.equal(await page.evaluate(() => document.getElementById("canvas").getContext("webgl2").getError()), 0);
    await page.context().close();
  },

  async "without WebGL 2 it says so"(browser) {
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(address);
    await page.waitForSelector("#message:not([hidden])", { timeout: patience });
    assert.match(await page.textContent("#message-text"), /WebGL 2/);
    await context.close();
  },
};

const failed = await runAll(tests, browser);
await browser.close();
server.close();
process.exit(failed ? 1 : 0);
