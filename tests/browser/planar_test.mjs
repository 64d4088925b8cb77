// SPDX-License-Identifier: MIT
// Planar systems, bifurcation sets, motions and formulas in the page: planar_test.mjs ROOT PROGRAM
// [SCREENSHOTS]. PROGRAM is the native one, whose pictures must be the page's, byte for byte.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { filesOf } from "../../web/page/film.mjs";
import {
  changed, finished, fragment, look, open, patience, prepare, runOnPage, settled, unpacked, waitFor,
} from "./browser.mjs";

const [root, program, screenshots] = process.argv.slice(2);
const { browser } = await prepare(root);
const folder = mkdtempSync(join(tmpdir(), "versorium-planar-"));
const small = { viewport: { width: 1000, height: 480 }, acceptDownloads: true };

const set = (page, id, value) =>
  page.evaluate(([id, value]) => window.versorium.set(id, value), [id, value]);
const state = async (page) => unpacked(await fragment(page));
const shoot = (page, name) =>
  screenshots ? page.screenshot({ path: join(screenshots, name + ".png") }) : null;

// What is found by a name is opened by Enter, as a user does it.
async function find(page, words) {
  const before = await fragment(page);
  await page.keyboard.press("Control+k");
  await page.waitForTimeout(300);
  await page.keyboard.type(words, { delay: 15 });
  await page.waitForTimeout(300);
  await page.keyboard.press("Enter");
  await changed(page, before);
}

const tests = {
  async "every row has its preset behind Ctrl K"(browser, address) {
    const page = await open(browser, address, small);
    await finished(page);
    const shots = [];
    for (const [words, test] of [
      ["preset: planar-quartic", ({ views }) => views[0].map === "planar"],
      ["preset: planar-set", ({ views, focused }) => "g.d" in views[focused].slice.axes[0]],
      ["preset: henon-set", ({ views, focused }) => "g.d" in views[focused].slice.axes[0]],
      ["preset: not-critical", ({ views }) => views[0].map === "planar"],
      ["preset: gold", ({ views, focused }) => views[focused].colour.rule === "gradient"],
      ["bands beside smooth", ({ views }) =>
        views[0].colour.smoothing === "none" && views[1].colour.smoothing !== "none"],
      ["preset: leaf", ({ views, focused }) => views[focused].layers.length === 2],
      ["preset: sine", ({ views }) => views[0].formula.includes("sin(z)")],
    ]) {
      await find(page, words);
      await finished(page);
      assert.ok(test(await state(page)), words + ": " + JSON.stringify(await state(page)).slice(0, 300));
      await page.mouse.move(900, 470);
      await page.waitForTimeout(300);
      shots.push(String(await look(page, { x: 8, y: 40, width: 600, height: 230 })));
      await shoot(page, "row-" + words.split(" ").pop());
    }
    assert.equal(new Set(shots).size, shots.length, "two presets look the same");
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "an analysis: each place moves its own view"(browser, address) {
    const page = await open(browser, address, { viewport: { width: 1280, height: 720 } });
    await finished(page);
    await find(page, "analysis: planar-set");
    await finished(page);
    const whole = await fragment(page);
    const before = unpacked(whole);
    assert.equal(before.views.length, 5);
    await shoot(page, "analysis");
    // Ctrl and a click bring the focused view's place there.
    await page.keyboard.press("4");
    await page.keyboard.down("Control");
    await page.mouse.click(250, 200);
    await page.keyboard.up("Control");
    await settled(page, whole);
    const clicked = await fragment(page);
    const after = unpacked(clicked);
    const numbers = ({ views }) => views.map(({ parameters }) => JSON.stringify(parameters));
    const [old, now] = [numbers(before), numbers(after)];
    assert.deepEqual(now.map((text, k) => text !== old[k]), [false, false, false, true, false]);
    // And it is dragged from there.
    await page.mouse.move(250, 200);
    await page.mouse.down();
    await page.mouse.move(290, 240, { steps: 6 });
    await page.mouse.up();
    await settled(page, clicked);
    assert.deepEqual(numbers(await state(page)).map((text, k) => text !== now[k]),
      [false, false, false, true, false]);
    await finished(page);
    await shoot(page, "analysis-dragged");
    // Undo takes the place back to where the drag began.
    const dragged = await fragment(page);
    await page.keyboard.press("Control+z");
    await changed(page, dragged);
    assert.deepEqual(numbers(await state(page)), now);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "a motion is recorded, played, and exported as the command line does"(browser, address) {
    const page = await open(browser, address, small);
    await finished(page);
    await page.mouse.click(200, 200, { modifiers: ["Control"] });
    await page.keyboard.press("r");
    await page.waitForTimeout(300);
    for (let k = 0; k < 4; ++k) {
      await set(page, "c.re", String(-0.7 + 0.1 * k));
      await page.waitForTimeout(120);
    }
    await page.keyboard.press("r");
    await waitFor(page, () => document.getElementById("said").textContent.includes("Recorded"));
    const { motion } = await state(page);
    assert.ok(motion.keys.length >= 2, JSON.stringify(motion));
    assert.ok(motion.keys.every(({ values }) => "c.re" in values));
    // Played, it comes by where it has been.
    await set(page, "motion time", "0");
    assert.equal((await state(page)).views[0].parameters.c[0], motion.keys[0].values["c.re"]);
    await page.keyboard.press("Shift+R");
    await waitFor(page, (end) => Math.abs(JSON.parse(window.versorium.controls()).controls
      .find(({ id }) => id === "motion time").value - end) < 1e-6, motion.keys.at(-1).time);
    assert.ok(Math.abs((await state(page)).views[0].parameters.c[0] + 0.4) < 0.01);
    await shoot(page, "motion");
    // Four pictures, small ones.
    await set(page, "frame rate", String(Math.max(1, 3 / motion.keys.at(-1).time)));
    await set(page, "export.width", "64");
    const coming = page.waitForEvent("download", { timeout: patience });
    await set(page, "export motion", "");
    const path = join(folder, "motion.zip");
    await (await coming).saveAs(path);
    const files = filesOf(new Uint8Array(readFileSync(path)));
    const pictures = [...files.keys()].filter((name) => name.endsWith(".png"));
    assert.ok(pictures.length >= 3, [...files.keys()].join());
    writeFileSync(join(folder, "animation.json"), files.get("animation.json"));
    mkdirSync(join(folder, "frames"));
    execFileSync(program, ["animate", join(folder, "animation.json"), "-o", join(folder, "frames")]);
    for (const name of pictures)
      assert.ok(readFileSync(join(folder, "frames", name)).equals(Buffer.from(files.get(name))), name);
    // As a film: Matroska's first bytes, and something in it.
    const film = page.waitForEvent("download", { timeout: patience });
    await set(page, "export film", "");
    await (await film).saveAs(join(folder, "motion.webm"));
    const bytes = readFileSync(join(folder, "motion.webm"));
    assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3);
    assert.ok(bytes.length > 500, `${bytes.length} bytes`);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },

  async "a formula is typed, and a wrong one says where"(browser, address) {
    const page = await open(browser, address, small);
    await finished(page);
    await find(page, "z^3 - a*z + c");
    const { views } = await state(page);
    assert.equal(views[0].formula, "z^3 - a*z + c");
    await finished(page);
    await shoot(page, "formula");
    const link = await fragment(page);
    const other = await open(browser, address + "#" + link, small);
    await finished(other);
    assert.equal(await fragment(other), link);
    assert.deepEqual([...page.faults, ...other.faults], []);
    await page.context().close();
    await other.context().close();
  },

  async "an image lies behind the fractal"(browser, address) {
    const page = await open(browser, address, small);
    await finished(page);
    await find(page, "preset: leaf");
    await finished(page);
    const area = { x: 480, y: 60, width: 120, height: 160 };
    const before = await look(page, area);
    await set(page, "images_are_layers", "on");
    const png = execFileSync(program, ["render", "newton", "-o", "-", "--size", "40x40"], { maxBuffer: 1 << 26 });
    await page.setInputFiles("#file", { name: "newton.png", mimeType: "image/png", buffer: png });
    await waitFor(page, () => JSON.parse(window.versorium.controls()).controls
      .some(({ id }) => id === "layers[2].x"));
    await finished(page);
    await shoot(page, "image-behind");
    assert.ok(!before.equals(await look(page, area)));
    await page.setInputFiles("#file", { name: "bad.png", mimeType: "image/png", buffer: Buffer.from([137, 80, 78, 71, 13]) });
    await waitFor(page, () => /bad\.png/.test(document.body.textContent));
    assert.deepEqual(page.faults, []);
    await page.context().close();
  },
};

await runOnPage(tests, root, browser, folder);
