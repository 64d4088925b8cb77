// SPDX-License-Identifier: MIT
// What all tests of the page share: the browser, waiting, and running them one by one.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { deflateSync, inflateSync } from "node:zlib";

const chromium = "/usr/bin/chromium";
export const patience = 90000; // milliseconds: for machines that are busy with other tests

function skip(why) {
  console.log("SKIPPED: " + why);
  process.exit(77);
}

// The folder of the page, a browser, and how to start another one. Where something is missing the
// test is skipped.
export async function prepare(root) {
  const dist = join(root, "build/web/dist");
  const driver = resolve(root, ".deps/node_modules/playwright-core");
  if (!existsSync(join(dist, "index.html"))) skip("there is no page: run scripts/build web");
  if (!existsSync(driver)) skip("playwright-core is missing: run scripts/setup web");
  if (!existsSync(chromium)) skip("chromium is missing: run scripts/setup web");
  const launch = (...graphics) =>
    createRequire(import.meta.url)(driver).chromium.launch({
      executablePath: chromium,
      args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", ...graphics],
    });
  const browser = await launch("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader");
  return { dist, browser, launch };
}

// The content policy forbids what playwright's own waitForFunction does in the page: ask from here.
export async function waitFor(page, condition, argument, within = patience) {
  const end = Date.now() + within;
  while (Date.now() < end) {
    if (await page.evaluate(condition, argument)) return;
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error("it never came to this: " + condition);
}

export const fragment = (page) => page.evaluate(() => window.versorium.fragment());
export const changed = (page, before) =>
  waitFor(page, (was) => window.versorium.fragment() !== was, before);

// The state has changed, and changes no more.
export async function settled(page, before) {
  await changed(page, before);
  for (let now = "", last = null; now !== last; ) {
    last = now;
    await page.waitForTimeout(400);
    now = await fragment(page);
  }
}

// The page served on this machine: the server's process and its address.
export function serve(root) {
  const server = spawn("python3", [join(root, "scripts/serve"), "--port", "0"]);
  return new Promise((resolve, reject) => {
    server.stdout.once("data", (text) => resolve({ server, address: String(text).trim() }));
    server.stderr.once("data", (text) => reject(new Error(String(text))));
  });
}

export const finished = (page) =>
  waitFor(page, () => {
    if (!window.versorium) return false;
    window.versorium.stop();
    return window.versorium.picturesTaken > 1 && window.versorium.finished;
  });

// What is drawn into a part of the canvas, as a PNG's bytes.
export const look = async (page, clip) => Buffer.from(await page.screenshot({ clip }));

export async function open(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(String(error)));
  page.on("console", (line) => line.type() === "error" && page.faults.push(line.text()));
  await page.goto(address);
  await waitFor(page, () => document.documentElement.dataset.state);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.state), "ready");
  return page;
}

// A link's fragment, and the workspace in it.
export const unpacked = (link) => JSON.parse(inflateSync(Buffer.from(link.slice(3), "base64url")));
export const packed = (workspace) => "v1:" + deflateSync(JSON.stringify(workspace)).toString("base64url");

// How far two screenshots of the same size are from one another: the mean over all channels, and the
// share of pixels of which one differs by more than 16, both in [0, 1].
export async function difference(browser, first, second, clip) {
  const page = await browser.newPage();
  const answer = await page.evaluate(async ([texts, clip]) => {
    const pixels = async (text) => {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes]));
      const { x, y, width, height } = clip ?? { x: 0, y: 0, width: image.width, height: image.height };
      const context = new OffscreenCanvas(width, height).getContext("2d");
      context.drawImage(image, -x, -y);
      return context.getImageData(0, 0, width, height).data;
    };
    const [a, b] = [await pixels(texts[0]), await pixels(texts[1])];
    if (a.length !== b.length) return { mean: 1, share: 1 };
    let sum = 0, far = 0;
    for (let k = 0; k < a.length; k += 4) {
      const gaps = [0, 1, 2].map((channel) => Math.abs(a[k + channel] - b[k + channel]));
      sum += gaps[0] + gaps[1] + gaps[2];
      if (Math.max(...gaps) > 16) ++far;
    }
    return { mean: sum / (a.length * 0.75 * 255), share: far / (a.length / 4) };
  }, [[first, second].map((png) => Buffer.from(png).toString("base64")), clip]);
  await page.close();
  return answer;
}

// Runs the tests, or with ONLY in the environment those whose name has it; returns how many failed.
export async function runAll(tests, ...given) {
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    if (process.env.ONLY && !name.includes(process.env.ONLY)) continue;
    try {
      await test(...given);
      console.log("ok      " + name);
    } catch (error) {
      ++failed;
      console.log("FAILED  " + name + "\n" + (error.stack ?? error));
    }
  }
  return failed;
}

// Runs the tests on the page as this machine serves it, and ends the program; the folder goes.
export async function runOnPage(tests, root, browser, folder) {
  const { server, address } = await serve(root);
  const failed = await runAll(tests, browser, address);
  await browser.close();
  server.kill();
  rmSync(folder, { recursive: true });
  process.exit(failed ? 1 : 0);
}
