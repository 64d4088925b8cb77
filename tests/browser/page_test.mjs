// SPDX-License-Identifier: MIT
// The built page in a browser, as its users meet it: page_test.mjs [DIST]
import assert from "node:assert/strict";
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { openBrowser, root, serve, skip } from "./browser.mjs";

const dist = resolve(process.argv[2] ?? join(root, "build/web/dist"));
if (!existsSync(join(dist, "service_worker.js"))) skip(`${dist} is missing: run scripts/build web`);
const browser = await openBrowser();
const server = await serve(dist);
const patience = 60000; // milliseconds: a software renderer on a busy machine

// A page that keeps what goes wrong in it. Without motion, so that states can be compared.
async function open({ address = server.address, script, ...options } = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", acceptDownloads: true,
    serviceWorkers: "block", ...options,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(patience);
  page.faults = [];
  page.on("console", (message) => message.type() === "error" && page.faults.push(message.text()));
  page.on("pageerror", (error) => page.faults.push(String(error)));
  if (script) await page.addInitScript(script);
  const begin = performance.now();
  await page.goto(address);
  await ready(page);
  page.seconds = (performance.now() - begin) / 1000;
  return page;
}
const ready = (page) => page.waitForFunction(() => document.documentElement.dataset.state === "ready");
const finished = (page) => page.waitForFunction(() => versorium.finished);
const fragment = (page) => page.evaluate(() => versorium.fragment());
const changedFrom = (page, before) =>
  page.waitForFunction((old) => versorium.fragment() !== old, before);
const close = async (page) => {
  assert.deepEqual(page.faults, [], "the console is quiet");
  await page.context().close();
};
// Colours that the studio's pictures show, seen in a screenshot: a plain area has few.
const coloursOf = async (page, clip) => {
  const shot = (await page.screenshot({ clip })).toString("base64");
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, shot);
};
// Somewhere in the left picture, away from its ring.
const spot = [180, 150];

const tests = {
  async "opens, draws its first picture, and rests"() {
    const page = await open();
    const sizes = await page.evaluate(() =>
      performance.getEntries().filter((entry) => "encodedBodySize" in entry)
        .map((entry) => [entry.name, entry.encodedBodySize]));
    const bytes = sizes.reduce((sum, [, size]) => sum + size, 0);
    console.log(`  first picture after ${page.seconds.toFixed(2)} s, ${bytes} bytes transferred`);
    assert.ok(bytes > 100000 && bytes < 2e6, `${bytes} bytes`);
    await finished(page);
    assert.ok((await coloursOf(page)) > 100, "there are pictures");
    assert.match(await fragment(page), /^v1:/);
    // Nothing moves, nobody touches it: no frame is drawn. A notice may stay for a while.
    await page.waitForFunction(async () => {
      const before = versorium.framesDrawn;
      await new Promise((done) => setTimeout(done, 700));
      return versorium.framesDrawn === before;
    });
    await close(page);
  },

  async "the wheel zooms in the canvas, and scrolls around it"() {
    const page = await open();
    const before = await fragment(page);
    await page.mouse.move(...spot);
    await page.mouse.wheel(0, -300);
    await changedFrom(page, before);
    // Around the canvas the wheel is the page's own.
    const prevented = (selector) => page.evaluate((where) => {
      const event = new WheelEvent("wheel", { deltaY: 100, bubbles: true, cancelable: true });
      document.querySelector(where).dispatchEvent(event);
      return event.defaultPrevented;
    }, selector);
    assert.equal(await prevented("#canvas"), true);
    assert.equal(await prevented("body"), false);
    await close(page);
  },

  async "a drag moves the picture, also beyond the canvas; keys undo it; back goes back"() {
    const page = await open();
    await finished(page);
    const before = await fragment(page);
    await page.mouse.move(...spot);
    await page.mouse.down();
    await page.mouse.move(spot[0] - 40, spot[1] + 30, { steps: 4 });
    await page.mouse.move(-60, spot[1] + 30, { steps: 4 });
    await page.mouse.up();
    await changedFrom(page, before);
    const after = await fragment(page);
    await page.waitForFunction((text) => decodeURIComponent(location.hash) === "#" + decodeURIComponent(text), after);
    // What is undone must have been recorded first, which takes a quiet moment.
    await page.waitForTimeout(1200);
    await page.keyboard.press("Control+z");
    await page.waitForFunction((old) => versorium.fragment() === old, before);
    await close(page);
  },

  async "a link opens what it says"() {
    const page = await open();
    const before = await fragment(page);
    await page.mouse.move(...spot);
    await page.mouse.wheel(0, -200);
    await changedFrom(page, before);
    const link = await fragment(page);
    await close(page);
    const other = await open({ address: `${server.address}#${link}` });
    assert.equal(await fragment(other), link);
    await other.evaluate(() => { location.hash = "v1:nonsense"; });
    await other.waitForSelector("#message:not([hidden])");
    assert.equal(await fragment(other), link, "everything stays as it was");
    await other.click("#dismiss");
    assert.equal(await other.isVisible("#message"), false);
    await close(other);
  },

  async "files open, wrong ones are refused with words"() {
    const page = await open();
    const before = await fragment(page);
    const preset = join(root, "lessons/presets/burning-ship.json");
    await page.setInputFiles("#file", preset);
    await changedFrom(page, before);
    const drop = await page.evaluateHandle((text) => {
      const data = new DataTransfer();
      data.items.add(new File([text], "wrong.json"));
      return data;
    }, "{");
    const opened = await fragment(page);
    await page.dispatchEvent("#canvas", "drop", { dataTransfer: drop });
    await page.waitForSelector("#message:not([hidden])");
    assert.match(await page.textContent("#message-text"), /wrong\.json/);
    assert.match(await page.textContent("#said"), /wrong\.json/);
    assert.equal(await fragment(page), opened);
    await close(page);
  },

  async "the canvas follows the window, the pixel ratio, and a phone"() {
    const page = await open();
    const size = () => page.evaluate(() => [canvas.width, canvas.height]);
    assert.deepEqual(await size(), [1280, 800]);
    await page.setViewportSize({ width: 1000, height: 620 });
    await page.waitForFunction(() => canvas.width === 1000 && canvas.height === 620);
    await finished(page);
    await close(page);
    const fine = await open({ deviceScaleFactor: 2 });
    assert.deepEqual(await fine.evaluate(() => [canvas.width, canvas.height]), [2560, 1600]);
    await finished(fine);
    await close(fine);
    const phone = await open({
      viewport: { width: 390, height: 844 }, deviceScaleFactor: 3, isMobile: true, hasTouch: true,
    });
    assert.deepEqual(await phone.evaluate(() => [canvas.width, canvas.height]), [1170, 2532]);
    await finished(phone);
    const before = await fragment(phone);
    const session = await phone.context().newCDPSession(phone);
    const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", {
      type, touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
    await touch("touchStart", [150, 300], [250, 300]);
    for (let k = 1; k <= 5; ++k) await touch("touchMove", [150 - 10 * k, 300], [250 + 10 * k, 300]);
    await touch("touchEnd");
    await changedFrom(phone, before);
    await close(phone);
  },

  async "a lost context comes back with its pictures"() {
    const page = await open();
    await finished(page);
    await page.evaluate(() => {
      globalThis.lose = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
      lose.loseContext();
    });
    await page.waitForFunction(() => canvas.getContext("webgl2").isContextLost());
    const frames = await page.evaluate(() => versorium.framesDrawn);
    await page.evaluate(() => setTimeout(() => lose.restoreContext(), 100));
    await page.waitForFunction((before) => versorium.framesDrawn > before + 2, frames);
    assert.ok((await coloursOf(page)) > 100, "the pictures are there again");
    assert.equal(await page.evaluate(() => canvas.getContext("webgl2").getError()), 0);
    await close(page);
  },

  async "without WebGL 2 it says so"() {
    const context = await browser.newContext({ serviceWorkers: "block" });
    const page = await context.newPage();
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(server.address);
    await page.waitForSelector("#message:not([hidden])", { timeout: patience });
    assert.match(await page.textContent("#message-text"), /WebGL 2/);
    await context.close();
  },

  async "within another page the wheel waits for a click"() {
    const folder = mkdtempSync(join(tmpdir(), "versorium-page-"));
    cpSync(dist, join(folder, "below/studio"), { recursive: true });
    writeFileSync(join(folder, "index.html"),
      '<body style="height:3000px"><iframe src="below/studio/" width=1000 height=600></iframe>');
    const other = await serve(folder);
    const context = await browser.newContext({
      viewport: { width: 1100, height: 700 }, reducedMotion: "reduce", serviceWorkers: "block",
    });
    const page = await context.newPage();
    await page.goto(other.address);
    const frame = page.frames()[1];
    await frame.waitForFunction(() => document.documentElement?.dataset.state === "ready", null, { timeout: patience });
    const before = await frame.evaluate(() => versorium.fragment());
    await frame.evaluate(() => document.activeElement.blur());
    await page.mouse.move(...spot);
    await page.mouse.wheel(0, 200);
    await page.waitForFunction(() => scrollY > 0);
    assert.equal(await frame.evaluate(() => versorium.fragment()), before);
    await page.evaluate(() => scrollTo(0, 0));
    await page.mouse.click(...spot);
    await page.mouse.wheel(0, -200);
    await frame.waitForFunction((old) => versorium.fragment() !== old, before);
    await context.close();
    other.stop();
    rmSync(folder, { recursive: true });
  },

  async "opens again without a network, isolated by its service worker"() {
    // A server that sends no headers of isolation, in a folder below its root.
    const folder = mkdtempSync(join(tmpdir(), "versorium-page-"));
    cpSync(dist, join(folder, "below/studio"), { recursive: true });
    const plain = await serve(folder, "--plain");
    const page = await open({ address: `${plain.address}below/studio/`, serviceWorkers: "allow" });
    assert.equal(await page.evaluate(() => crossOriginIsolated), false);
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    const link = await fragment(page);
    plain.stop();
    await page.context().setOffline(true);
    await page.reload();
    await ready(page);
    assert.equal(await fragment(page), link);
    assert.equal(await page.evaluate(() => crossOriginIsolated), true);
    console.log(`  threads after the reload: ${await page.evaluate(() => versorium.threads)}`);
    await close(page);
    rmSync(folder, { recursive: true });
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  if (process.argv[3] && !name.includes(process.argv[3])) continue;
  try {
    await test();
    console.log(`ok: ${name}`);
  } catch (error) {
    ++failed;
    console.log(`FAILED: ${name}\n  ${error.stack}`);
  }
}
await browser.close();
server.stop();
process.exit(failed ? 1 : 0);
