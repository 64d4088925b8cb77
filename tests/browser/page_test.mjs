// SPDX-License-Identifier: MIT
// The page in Chromium with real mouse, wheel and keys: page_test.mjs ROOT PROGRAM [SCREENSHOTS]
// ROOT is the repository, PROGRAM the native one, whose exports must be the page's, byte for byte.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import {
  changed, difference, finished, fragment, look, open, packed, patience, prepare, runOnPage, unpacked, waitFor,
} from "./browser.mjs";

const [root, program, screenshots] = process.argv.slice(2);
const { browser } = await prepare(root);

const folder = mkdtempSync(join(tmpdir(), "versorium-page-"));

const became = (page, wanted) =>
  waitFor(page, (is) => window.versorium.fragment() === is, wanted);

const left = { x: 10, y: 40, width: 440, height: 540 };
const right = { x: 480, y: 40, width: 440, height: 540 };

// The page's graphics context is lost and given back.
const loseContext = (page) =>
  page.evaluate(async () => {
    const canvas = document.getElementById("canvas");
    const extension = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const once = (name) => new Promise((done) => canvas.addEventListener(name, done, { once: true }));
    const lost = once("webglcontextlost");
    extension.loseContext();
    await lost;
    await new Promise((done) => setTimeout(done, 20));
    const restored = once("webglcontextrestored");
    extension.restoreContext();
    await restored;
    // Some frames in the new one, as many as it can draw meanwhile.
    await new Promise((done) => setTimeout(done, 50));
  });

const tests = {
  async "first picture, figures"(browser, address) {
    const begin = performance.now();
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
    const page = await context.newPage();
    const client = await context.newCDPSession(page);
    await client.send("Network.enable");
    let bytes = 0;
    client.on("Network.loadingFinished", (event) => (bytes += event.encodedDataLength));
    await page.goto(address);
    await waitFor(page, () => document.documentElement.dataset.state === "ready");
    console.log(`  first picture after ${Math.round(performance.now() - begin)} ms, ${bytes} bytes transferred`);
    await context.close();
  },

  async "pan, zoom, weld and undo"(browser, address) {
    const page = await open(browser, address);
    await finished(page);
    const first = await fragment(page);
    const julia = await look(page, right);
    // Ctrl and a click put the ring; the other view follows.
    await page.keyboard.down("Control");
    await page.mouse.click(100, 260);
    await page.keyboard.up("Control");
    await changed(page, first);
    await page.waitForTimeout(700); // until it is a step of its own for undo
    await finished(page);
    assert.ok(!julia.equals(await look(page, right)), "the right view did not follow the left ring");
    const put = await fragment(page);
    await page.mouse.move(300, 300);
    await page.mouse.wheel(0, -300);
    await changed(page, put);
    await page.waitForTimeout(700);
    const zoomed = await fragment(page);
    await page.mouse.move(300, 400);
    await page.mouse.down();
    await page.mouse.move(340, 420, { steps: 5 });
    await page.mouse.up();
    await changed(page, zoomed);
    await page.waitForTimeout(700);
    for (const state of [zoomed, put, first]) {
      await page.keyboard.press("Control+z");
      await became(page, state);
    }
    assert.deepEqual(page.faults, []);
    if (screenshots) await page.screenshot({ path: join(screenshots, "page.png") });
    await page.context().close();
  },

  async "a link opens the same picture in a fresh profile"(browser, address) {
    const page = await open(browser, address);
    const first = await fragment(page);
    await page.mouse.move(250, 300);
    await page.mouse.wheel(0, -600);
    await changed(page, first);
    await finished(page);
    await page.mouse.move(1150, 780);
    await waitFor(page, () => location.hash.length > 4);
    const link = await fragment(page);
    const other = await open(browser, address + "#" + link);
    await finished(other);
    await other.mouse.move(1150, 780);
    assert.equal(await fragment(other), link);
    await page.context().close();
    await other.context().close();
  },

  async "a damaged link says so"(browser, address) {
    const page = await open(browser, address + "#v1:AAAA");
    await page.waitForSelector("#message:not([hidden])", { timeout: patience });
    assert.match(await page.textContent("#message-text"), /link/);
    await page.context().close();
  },

  async "an export is the command line's file"(browser, address) {
    const page = await open(browser, address, { acceptDownloads: true });
    const scene = join(folder, "scene.json");
    writeFileSync(scene, execFileSync(program, ["render", "julia", "-o", "-", "--size", "48x48"]));
    await page.setInputFiles("#file", { name: "j.png", mimeType: "image/png", buffer: readFileSync(scene) });
    await waitFor(page, () => document.getElementById("said").textContent.includes("j.png"));
    await finished(page);
    await page.mouse.move(700, 500);
    await page.keyboard.press("Control+e");
    await page.waitForTimeout(500);
    if (screenshots) await page.screenshot({ path: join(screenshots, "export.png") });
    const coming = page.waitForEvent("download", { timeout: patience });
    await page.keyboard.press("Enter");
    const download = await coming;
    const path = join(folder, "export.png");
    await download.saveAs(path);
    const again = execFileSync(program, ["render", path, "-o", "-"], { maxBuffer: 1 << 28 });
    assert.ok(readFileSync(path).equals(again), "the page's PNG is not the command line's");
    await page.context().close();
  },

  async "a context that is lost fifty times comes back"(browser, address) {
    const page = await open(browser, address);
    await finished(page);
    await page.mouse.move(1150, 790);
    await page.waitForTimeout(500);
    const before = await look(page, left);
    for (let k = 1; k < 50; ++k)
      await loseContext(page);
    // Counted before the last loss: all frames in the new context may be drawn by the time it returns.
    const frames = await page.evaluate(() => versorium.framesDrawn);
    await loseContext(page);
    await waitFor(page, (before) => versorium.framesDrawn > before, frames);
    await finished(page);
    await page.waitForTimeout(500);
    assert.ok(before.equals(await look(page, left)), "the picture is another one");
    await page.context().close();
  },

  // One light view, since a program draws in place of the GPU here.
  async "drawn by the GPU it is the same picture, and again in a new context"(browser, address) {
    const page = await open(browser, address, { viewport: { width: 640, height: 300 } });
    await finished(page);
    const workspace = unpacked(await fragment(page));
    workspace.views = [{ ...workspace.views[0], iterations: 60, samples: 1 }];
    workspace.focused = 0;
    const link = packed(workspace);
    const area = { x: 10, y: 40, width: 240, height: 180 };
    const shots = [];
    for (const who of ["processor", "graphics"]) {
      await page.evaluate((who) => localStorage.setItem("versorium.renderer", who), who);
      await page.goto(address + "#" + link);
      await page.reload();
      await waitFor(page, () => document.documentElement.dataset.state === "ready");
      await page.mouse.move(600, 295);
      await finished(page);
      await page.waitForTimeout(500);
      shots.push(await look(page, area));
    }
    const { share } = await difference(browser, ...shots);
    assert.ok(share < 0.03, `${share} of the pixels differ`);
    assert.ok(!shots[0].equals(shots[1]), "32 bits drew what 64 bits draw");
    const taken = await page.evaluate(() => versorium.framesDrawn);
    await loseContext(page);
    await waitFor(page, (before) => versorium.framesDrawn > before, taken);
    await finished(page);
    await page.waitForTimeout(500);
    const again = await difference(browser, shots[1], await look(page, area));
    assert.ok(again.share < 0.03, `${again.share} of the pixels differ in the new context`);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "offline after the first visit"(browser, address) {
    const page = await open(browser, address);
    await page.evaluate(() => navigator.serviceWorker.ready);
    await waitFor(page, () => navigator.serviceWorker.controller);
    await page.context().setOffline(true);
    await page.reload();
    await waitFor(page, () => document.documentElement.dataset.state === "ready");
    await page.context().close();
  },

  async "twice the pixels, and a phone"(browser, address) {
    for (const [name, options] of [
      ["dense", { deviceScaleFactor: 2, viewport: { width: 1000, height: 640 } }],
      ["laptop", { viewport: { width: 1366, height: 640 } }],
      ["phone", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }],
    ]) {
      const page = await open(browser, address, options);
      await finished(page);
      if (screenshots) await page.screenshot({ path: join(screenshots, name + ".png") });
      const size = await page.evaluate(() => [document.getElementById("canvas").width, innerWidth * devicePixelRatio]);
      assert.equal(size[0], size[1], name);
      assert.deepEqual(page.faults, [], name);
      await page.context().close();
    }
  },
};

await runOnPage(tests, root, browser, folder);
