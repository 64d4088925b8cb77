// SPDX-License-Identifier: MIT
// The page where it is not alone: within another page, in a folder of a server that sends no special
// headers, without WebGL 2, under two fingers, after a lost context. surroundings_test.mjs ROOT [SCREENSHOTS]
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { changed, difference, fragment, prepare, runAll, waitFor } from "./browser.mjs";

const [root, screenshots] = process.argv.slice(2);
const { dist, browser, launch } = await prepare(root);

// The page below /some/folder/, and at / a tall page that has it in a frame. Nothing more is sent
// than a plain host for static files sends; below /isolated/ the page comes with the headers that
// threads need.
const types = {
  ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".mjs": "text/javascript",
  ".wasm": "application/wasm", ".svg": "image/svg+xml", ".webmanifest": "application/manifest+json",
  ".packed": "application/octet-stream",
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

  async "the keyboard reaches every view and control"(browser) {
    const page = await open(browser);
    const said = () => page.textContent("#said");
    const tab = async (wanted) => {
      for (let k = 0; k < 40; ++k) {
        await page.keyboard.press("Tab");
        const name = await page.evaluate(() => {
          const at = document.activeElement;
          return at.closest(".field")?.dataset.id ?? at.getAttribute("aria-label") ?? at.id;
        });
        if (name.includes(wanted)) return;
      }
      throw new Error("Tab does not come to " + wanted);
    };
    await waitFor(page, () => document.querySelectorAll(".field").length > 40);
    // Views: their keys are the studio's.
    await tab("View 2");
    for (const key of ["ArrowRight", "+", "-"]) {
      const before = await fragment(page);
      await page.keyboard.press(key);
      await changed(page, before);
    }
    await waitFor(page, () => /View 2, starting points .* escapes at step/.test(document.getElementById("shown").textContent));
    // A choice, a number by strokes and by typing, a switch.
    const state = async () => JSON.parse(await page.evaluate(() => versorium.controls())).controls;
    const value = async (id) => (await state()).find((control) => control.id === id).value;
    await tab("map");
    await page.keyboard.press("Shift+Tab"); // back to the view
    await tab("map");
    await tab("c.re");
    const before = Number(await value("c.re"));
    await page.keyboard.press("ArrowUp");
    assert.ok(Number(await value("c.re")) > before);
    await page.keyboard.press("Control+a");
    await page.keyboard.type("-0.125");
    await page.keyboard.press("Enter");
    assert.equal(await value("c.re"), "-0.125");
    if (screenshots) await page.screenshot({ path: join(screenshots, "keyboard.png") });
    await page.keyboard.press("Control+a");
    await page.keyboard.type("much");
    await page.keyboard.press("Enter");
    assert.match(await said(), /cannot be much/);
    assert.equal(await value("c.re"), "-0.125");
    await tab("colour.palette");
    await page.keyboard.press("f");
    await waitFor(page, () => /"id":"colour.palette","group":"[^"]*","label":"[^"]*","kind":"choice","value":"f/.test(versorium.controls()));
    await tab("colour.reverse");
    await page.keyboard.press("Space");
    assert.equal(await value("colour.reverse"), "on");
    // A command; each of the studio's is here.
    await tab("do undo");
    const now = await fragment(page);
    await page.keyboard.press("Enter");
    await changed(page, now);
    await waitFor(page, () => {
      const ids = [...document.querySelectorAll(".field")].map((field) => field.dataset.id);
      return String(ids) === String(JSON.parse(versorium.controls()).controls.map(({ id }) => id));
    });
    await page.keyboard.press("Escape");
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "the page speaks the browser's language, and another one from one moment to the next"(browser) {
    const page = await open(browser, { locale: "es-ES" });
    const spoken = (language) => waitFor(page, (wanted) => document.documentElement.lang === wanted, language);
    const value = () => page.evaluate(() =>
      JSON.parse(versorium.controls()).controls.find(({ id }) => id === "c.re").value);
    await spoken("es");
    await waitFor(page, () => document.querySelector('[data-id="do undo"]')?.textContent === "Deshacer");
    assert.equal(await page.textContent("#open"), "Abrir un archivo");
    assert.match(await page.inputValue('[data-id="c.re"] input'), /^-?0,\d+$/);
    await page.focus('[data-id="c.re"] input');
    await page.keyboard.press("Control+a");
    await page.keyboard.type("-0,125");
    await page.keyboard.press("Enter");
    assert.equal(await value(), "-0.125");
    await page.evaluate(() => versorium.set("language", "en"));
    await spoken("en");
    await waitFor(page, () => document.querySelector('[data-id="do undo"]')?.textContent === "Undo");
    assert.equal(await page.textContent("#open"), "Open a file");
    assert.equal(await page.inputValue('[data-id="c.re"] input'), "-0.125");
    await page.reload();
    await ready(page);
    await spoken("en"); // what was chosen stays
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "without WebGL 2 the CPU draws the same picture, and the page says so"(browser) {
    const plain = await launch("--disable-3d-apis", "--disable-gpu");
    const shots = [];
    for (const which of [browser, plain]) {
      const page = await open(which);
      if (which === plain) {
        assert.match(await page.textContent("#message-text"), /WebGL 2/);
        if (screenshots) await page.screenshot({ path: join(screenshots, "no-webgl.png") });
        await page.click("#dismiss");
      }
      const before = await fragment(page);
      await page.mouse.move(...spot);
      await page.mouse.wheel(0, -300);
      await changed(page, before);
      await page.mouse.move(1275, 797);
      await finished(page);
      await page.waitForTimeout(500);
      shots.push(await page.screenshot());
      assert.deepEqual(page.faults, []);
      await page.context().close();
    }
    await plain.close();
    // Letters and thin lines are rounded in other ways; pictures are not.
    const { mean, share } = await difference(browser, ...shots);
    assert.ok(mean < 0.005 && share < 0.01, `mean ${mean}, share ${share}`);
  },
};

const failed = await runAll(tests, browser);
await browser.close();
server.close();
process.exit(failed ? 1 : 0);
