// SPDX-License-Identifier: MIT
// Shapes drawn by hand in the page, on a desktop and by a finger on a phone, painted on, and exported:
// shape_test.mjs ROOT PROGRAM [SCREENSHOTS]. PROGRAM is the native one, whose plates must be the page's.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import {
  changed, finished, fragment, open, patience, prepare, runOnPage, settled, unpacked, waitFor,
} from "./browser.mjs";

const [root, program, screenshots] = process.argv.slice(2);
const { browser } = await prepare(root);
const folder = mkdtempSync(join(tmpdir(), "versorium-shape-"));

const set = (page, id, value) =>
  page.evaluate(([id, value]) => window.versorium.set(id, value), [id, value]);
const state = async (page) => unpacked(await fragment(page));
const shoot = (page, name) =>
  screenshots ? page.screenshot({ path: join(screenshots, name + ".png") }) : null;

// The sides of a star around (x, y), in steps of a hand.
function star(x, y, radius) {
  const corners = [...Array(11).keys()].map((k) => {
    const r = k % 2 ? 0.45 * radius : radius;
    return [x + r * Math.sin((k * Math.PI) / 5), y - r * Math.cos((k * Math.PI) / 5)];
  });
  return corners.slice(1).flatMap((to, k) =>
    [...Array(6).keys()].map((part) => corners[k].map((from, i) => from + ((to[i] - from) * part) / 6)));
}

const tests = {
  async "a drawn star becomes its Julia set in two actions"(browser, address) {
    const page = await open(browser, address, { viewport: { width: 1280, height: 720 }, acceptDownloads: true });
    await finished(page);
    const first = await fragment(page);
    const points = star(690, 270, 180);
    // One: the key. Two: the stroke.
    await page.keyboard.press("d");
    await page.waitForTimeout(200);
    await page.mouse.move(...points[0]);
    await page.mouse.down();
    for (const point of points.slice(1)) await page.mouse.move(...point);
    await shoot(page, "drawing");
    const taken = await page.evaluate(() => window.versorium.picturesTaken);
    await page.mouse.up();
    const begin = performance.now();
    await changed(page, first);
    await waitFor(page, (taken) => window.versorium.picturesTaken > taken, taken);
    const seen = Math.round(performance.now() - begin);
    await waitFor(page, (taken) => window.versorium.picturesTaken > taken + 2 && window.versorium.finished, taken);
    console.log(`  a drawn star: first picture after ${seen} ms, all of both views after ${Math.round(performance.now() - begin)} ms`);
    await page.waitForTimeout(300);
    await shoot(page, "drawn");
    const { views, focused } = await state(page);
    assert.equal(views[focused].map, "shape-modulus-complex-rational");
    assert.match(views[focused].shape.source, /^polygon\(/);
    // α turned, and painted onto the upper arm.
    await set(page, "alpha", "25");
    await finished(page);
    await set(page, "brush.alpha", "5");
    const turned = await fragment(page);
    await page.keyboard.press("Control+k");
    await page.waitForTimeout(300);
    await page.keyboard.type("paint", { delay: 15 });
    await page.waitForTimeout(300);
    await page.keyboard.press("Enter");
    await page.waitForTimeout(300);
    await page.mouse.move(690, 110);
    await page.mouse.down();
    for (let y = 110; y < 170; y += 10) {
      await page.mouse.move(690, y);
      await page.waitForTimeout(60);
    }
    await page.mouse.up();
    await settled(page, turned);
    await finished(page);
    await shoot(page, "painted");
    const discs = (await state(page)).views[focused].modulation.alpha.discs;
    assert.ok(discs.length > 1 && discs.every((disc) => disc[4] === 5), JSON.stringify(discs));
    await page.keyboard.press("Escape");
    // The plate of it is the one that the command line makes.
    await page.keyboard.press("Control+e");
    await page.waitForTimeout(400);
    await shoot(page, "export");
    await page.keyboard.press("Escape");
    await set(page, "export.width", "320");
    const coming = page.waitForEvent("download", { timeout: patience });
    await set(page, "begin export", "");
    const path = join(folder, "star.png");
    await (await coming).saveAs(path);
    const again = execFileSync(program, ["render", path, "-o", "-"], { maxBuffer: 1 << 28 });
    assert.ok(readFileSync(path).equals(again), "the page's picture is not the command line's");
    // Undone, all of it.
    for (let k = 0; k < 12 && (await state(page)).views[0].map !== "quadratic"; ++k) {
      await page.keyboard.press("Control+z");
      await page.waitForTimeout(300);
    }
    assert.equal((await state(page)).views[0].map, "quadratic");
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "by a finger, on a phone"(browser, address) {
    const page = await open(browser, address, {
      viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2,
    });
    await finished(page);
    await shoot(page, "phone");
    const first = await fragment(page);
    await set(page, "do draw.outline", "");
    await page.waitForTimeout(400);
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const points = star(195, 400, 150);
    await touch("touchStart", points[0]);
    for (const point of points.slice(1)) await touch("touchMove", point);
    await touch("touchEnd");
    await settled(page, first);
    await finished(page);
    await page.waitForTimeout(300);
    await shoot(page, "phone-drawn");
    const { views, focused } = await state(page);
    assert.match(views[focused].shape.source, /^polygon\(/);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "what cannot be a shape says so and changes nothing"(browser, address) {
    const page = await open(browser, address, { viewport: { width: 1000, height: 480 } });
    await finished(page);
    const first = await fragment(page);
    for (const [text, said] of [["polygon(0, 0, 1, 1, 2, 2)", "one line"], ["star(5, 1", "character"]]) {
      await set(page, "shape.source", text);
      await waitFor(page, (said) => document.getElementById("said").textContent.includes(said), said);
    }
    assert.equal(await fragment(page), first);
    await page.context().close();
  },
};

await runOnPage(tests, root, browser, folder);
