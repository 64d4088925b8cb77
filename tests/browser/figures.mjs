// SPDX-License-Identifier: MIT
// Measures the page and prints what it finds; no time fails it. figures.mjs ROOT
// A slow visitor: a processor at a quarter of its speed, 10 Mbit/s, a window of 1366 × 640. The
// aims: first picture within 2 s and first coarse answer within 100 ms on a machine that is not
// slowed down; 5 s and 250 ms here. No main-thread task above 50 ms after the start, 2 MB to transfer.
import { spawn } from "node:child_process";
import { join } from "node:path";
import { prepare, waitFor } from "./browser.mjs";

const [root] = process.argv.slice(2);
const { browser } = await prepare(root);
const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1] ?? NaN;
const largest = (numbers) => (numbers.length ? Math.max(...numbers) : 0);
const round = (number) => Math.round(number);

// Runs in the page before all else: keeps long tasks and frames.
function watch() {
  window.seen = { tasks: [], frames: [] };
  new PerformanceObserver((list) =>
    window.seen.tasks.push(...list.getEntries().map(({ startTime, duration }) => ({ startTime, duration }))),
  ).observe({ type: "longtask", buffered: true });
  let last = 0;
  const frame = (now) => {
    if (last) window.seen.frames.push({ now, took: now - last });
    last = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

// Sets a control and waits for the first picture that comes of it, in the page: its own clock counts.
const answer = (page, id, value) =>
  page.evaluate(([id, value]) => new Promise((done) => {
    const begin = performance.now(), before = versorium.picturesTaken;
    versorium.set(id, value);
    const look = () => {
      if (versorium.picturesTaken > before) done(performance.now() - begin);
      else setTimeout(look, 1);
    };
    look();
  }), [id, value]);

async function measure(address, slow) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 640 } });
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  await client.send("Network.enable");
  let bytes = 0, counting = true;
  client.on("Network.loadingFinished", (event) => counting && (bytes += event.encodedDataLength));
  if (slow) {
    await client.send("Emulation.setCPUThrottlingRate", { rate: 4 });
    await client.send("Network.emulateNetworkConditions",
      { offline: false, latency: 20, downloadThroughput: 10e6 / 8, uploadThroughput: 10e6 / 8 });
  }
  await page.addInitScript(watch);
  await page.goto(address);
  await waitFor(page, () => window.versorium?.firstPicture > 0);
  const first = await page.evaluate(() => versorium.firstPicture);
  counting = false;
  await page.evaluate(() => versorium.stop());
  await waitFor(page, () => versorium.finished);
  const begin = await page.evaluate(() => performance.now());
  const answers = [];
  for (let k = 0; k < 9; ++k) {
    answers.push(await answer(page, "c.re", String(-0.75 + 0.01 * k)));
    // Half of them come while the last picture is still refined.
    if (k % 2) await waitFor(page, () => versorium.finished);
    else await page.waitForTimeout(150);
  }
  await waitFor(page, () => versorium.finished);
  // A hand that drags for two seconds.
  const from = await page.evaluate(() => performance.now());
  await page.mouse.move(620, 200);
  await page.mouse.down();
  for (let k = 0; k < 60; ++k) {
    await page.mouse.move(620 + 40 * Math.sin(k / 5), 200 + 40 * Math.cos(k / 5));
    await page.waitForTimeout(33);
  }
  await page.mouse.up();
  const seen = await page.evaluate(() => window.seen);
  const tasks = (low, high) =>
    seen.tasks.filter(({ startTime }) => startTime >= low && startTime < high).map(({ duration }) => duration);
  const frames = seen.frames.filter(({ now }) => now > from).map(({ took }) => took);
  console.log(
    `  ${slow ? "slowed down" : "as it is  "}  first picture ${round(first)} ms, ${round(bytes / 1024)} kB; ` +
    `first answer ${round(median(answers))} ms, at most ${round(largest(answers))}; ` +
    `longest task ${round(largest(tasks(0, begin)))} ms at the start, ${round(largest(tasks(begin, Infinity)))} later; ` +
    `frames of a drag ${round(median(frames))} ms, at most ${round(largest(frames))}; threads ${await page.evaluate(() => versorium.threads)}`);
  await context.close();
}

const server = spawn("python3", [join(root, "scripts/serve"), "--port", "0"]);
const address = await new Promise((done) => server.stdout.once("data", (text) => done(String(text).trim())));
for (const slow of [false, true]) for (let k = 0; k < (slow ? 3 : 1); ++k) await measure(address, slow);
await browser.close();
server.kill();
