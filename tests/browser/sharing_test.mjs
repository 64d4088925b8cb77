// SPDX-License-Identifier: MIT
// What is sent to others and comes back: links, files, the clipboard, the page's history, the packed
// page on another server, and a new build of it. sharing_test.mjs ROOT PROGRAM [SCREENSHOTS]
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { changed, difference, fragment, patience, prepare, runAll, waitFor } from "./browser.mjs";

const [root, program, screenshots] = process.argv.slice(2);
const { dist, browser } = await prepare(root);
const folder = mkdtempSync(join(tmpdir(), "versorium-sharing-"));
const built = join(folder, "built"); // this build, and later a newer one
cpSync(dist, built, { recursive: true });
const unpacked = join(folder, "unpacked");
execFileSync(join(root, "scripts/package"), [join(folder, "page.zip")], { cwd: root });
execFileSync("python3", ["-m", "zipfile", "-e", join(folder, "page.zip"), unpacked]);

// Two sites: the build below /, whose links are configured to begin with the other one, and the
// unpacked ZIP below /course/week 3/.
const types = {
  ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".mjs": "text/javascript",
  ".wasm": "application/wasm", ".svg": "image/svg+xml", ".webmanifest": "application/manifest+json",
  ".packed": "application/octet-stream",
};
const course = "/course/week%203/";
function serve(answer) {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    const body = answer(path.endsWith("/") ? path + "index.html" : path);
    response.writeHead(body ? 200 : 404, { "Content-Type": types[extname(path)] ?? "text/html" });
    response.end(body);
  });
  return new Promise((done) => server.listen(0, "127.0.0.1", () => done(server)));
}
const read = (file) => (existsSync(file) ? readFileSync(file) : null);
const second = await serve((path) => {
  const below = decodeURIComponent(course);
  return path.startsWith(below) ? read(join(unpacked, path.slice(below.length))) : null;
});
const elsewhere = `http://127.0.0.1:${second.address().port}${course}`;
const first = await serve((path) => {
  const bytes = read(join(built, path));
  const mark = 'name="versorium-public-url" content="';
  return path === "/index.html" ? String(bytes).replace(mark, mark + elsewhere) : bytes;
});
const address = `http://localhost:${first.address().port}/`;

async function open(where, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", acceptDownloads: true,
    permissions: ["clipboard-read", "clipboard-write"], ...options,
  });
  const page = await context.newPage();
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(String(error)));
  await page.goto(where);
  await waitFor(page, () => window.versorium?.finished);
  return page;
}
const set = (page, id, value = "") =>
  page.evaluate(([id, value]) => versorium.set(id, value), [id, value]);
const rest = async (page) => {
  await page.mouse.move(1275, 797);
  await page.waitForTimeout(500);
  await waitFor(page, () => versorium.finished);
};
const said = (page, words) =>
  waitFor(page, (words) => document.getElementById("said").textContent.includes(words), words);
const paste = (page, text, png) =>
  page.evaluate(([text, png]) => {
    const clipboardData = new DataTransfer();
    if (text) clipboardData.setData("text/plain", text);
    if (png) clipboardData.items.add(new File([new Uint8Array(png)], "pasted.png", { type: "image/png" }));
    document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, [text, png && [...png]]);
const views = { x: 0, y: 0, width: 940, height: 610 };

const tests = {
  async "a copied link opens the same picture in the unpacked ZIP of another site"() {
    const page = await open(address);
    await set(page, "c.re", "-0.4");
    await set(page, "c.im", "0.6");
    await rest(page);
    await page.keyboard.press("Control+l");
    await said(page, "The link is on the clipboard");
    const link = await page.evaluate(() => navigator.clipboard.readText());
    assert.ok(link.startsWith(elsewhere + "#v1:"), link);
    const other = await open(link);
    await rest(page);
    await rest(other);
    assert.equal(await fragment(other), await fragment(page));
    const { share } = await difference(browser, await page.screenshot(), await other.screenshot(), views);
    assert.equal(share, 0);
    assert.deepEqual(other.faults, []);
    // Pasted into a page that shows something else it opens there as well.
    const third = await open(address);
    const before = await fragment(third);
    await paste(third, link);
    await changed(third, before);
    assert.equal(await fragment(third), await fragment(page));
    for (const one of [page, other, third]) await one.context().close();
  },

  async "scenes and pictures are pasted"() {
    const png = execFileSync(program, ["render", "henon", "-o", "-", "--size", "40x30"]);
    const file = join(folder, "scene.png");
    writeFileSync(file, png);
    const scene = execFileSync(program, ["scene", file]);
    const page = await open(address);
    for (const content of [[String(scene)], ["", png]]) {
      await set(page, "map", "Quadratic family (quadratic)");
      const before = await fragment(page);
      await paste(page, ...content);
      await changed(page, before);
      const map = JSON.parse(await page.evaluate(() => versorium.controls())).controls[0].value;
      assert.equal(map, "Planar polynomial system (planar)");
    }
    await page.context().close();
  },

  async "the browser goes back and forward"() {
    const page = await open(address);
    await waitFor(page, () => location.hash.length > 4);
    await page.waitForTimeout(4500); // changes that follow closely share an entry
    const before = await fragment(page);
    await set(page, "c.re", "0.3");
    await waitFor(page, (hash) => location.hash !== hash, "#" + before);
    await rest(page);
    const after = await fragment(page);
    const is = (wanted) => waitFor(page, (wanted) => versorium.fragment() === wanted, wanted);
    await page.goBack();
    await is(before);
    await page.goForward();
    await is(after);
    await page.context().close();
  },

  async "an export can be cancelled"() {
    const page = await open(address);
    let downloads = 0;
    page.on("download", () => ++downloads);
    await set(page, "export.width", "6000");
    await set(page, "begin export");
    await page.waitForTimeout(300);
    assert.equal(await set(page, "cancel export"), true);
    await said(page, "cancelled");
    await waitFor(page, () => !versorium.controls().includes("cancel export"));
    // The next one is not disturbed.
    await set(page, "export.width", "64");
    const coming = page.waitForEvent("download", { timeout: patience });
    await set(page, "begin export");
    await coming;
    assert.equal(downloads, 1);
    await page.context().close();
  },

  async "it fills the screen"() {
    const page = await open(address);
    await page.mouse.click(180, 150);
    for (const wanted of [true, false]) {
      await page.keyboard.press("Shift+F");
      await waitFor(page, (wanted) => (document.fullscreenElement !== null) === wanted, wanted);
    }
    await page.context().close();
  },

  async "the window shows the same picture"() {
    const file = join(folder, "window.json"), shot = join(folder, "window.png");
    const scene = join(folder, "window-scene.png");
    writeFileSync(scene, execFileSync(program, ["render", "julia", "-o", "-", "--size", "48x48"]));
    writeFileSync(file, execFileSync(program, ["scene", scene]));
    try {
      execFileSync("xvfb-run", ["-a", "-s", "-screen 0 1280x800x24", program, "studio", file,
        "--screenshot", shot, "--size", "1280x800"], {
        env: { ...process.env, XDG_CONFIG_HOME: folder, LIBGL_ALWAYS_SOFTWARE: "1" }, timeout: patience,
      });
    } catch (error) {
      if (error.code !== "ENOENT") throw error;
      return console.log("  left out: there is no xvfb-run");
    }
    const page = await open(address);
    await page.setInputFiles("#file", file);
    await said(page, "is open");
    await rest(page);
    await page.waitForTimeout(6500); // until the notice is gone
    const image = await page.screenshot();
    if (screenshots) writeFileSync(join(screenshots, "window.png"), readFileSync(shot));
    if (screenshots) writeFileSync(join(screenshots, "page-like-window.png"), image);
    // The pictures have the same numbers; only what OpenGL rounds in lines and letters differs.
    const { mean, share } = await difference(browser, image, readFileSync(shot), views);
    assert.ok(mean < 0.005 && share < 0.01, `mean ${mean}, share ${share}`);
    await page.context().close();
  },

  async "a new build takes over at the next load"() {
    const page = await open(address);
    await waitFor(page, () => navigator.serviceWorker.controller !== null);
    const old = await page.getAttribute('meta[name="versorium-build"]', "content");
    const newer = "0123456789abcdef";
    for (const name of ["index.html", "service_worker.js"]) {
      const file = join(built, name);
      writeFileSync(file, readFileSync(file, "utf8").replaceAll(old, newer));
    }
    await page.reload();
    await page.waitForSelector("#message:not([hidden])", { timeout: patience });
    assert.match(await page.textContent("#message-text"), /new version/);
    assert.equal(await page.getAttribute('meta[name="versorium-build"]', "content"), old);
    // The old page still finds its own parts.
    await set(page, "export.width", "64");
    const coming = page.waitForEvent("download", { timeout: patience });
    await set(page, "begin export");
    await coming;
    await page.reload();
    await waitFor(page, () => window.versorium?.finished);
    assert.equal(await page.getAttribute('meta[name="versorium-build"]', "content"), newer);
    assert.equal(await page.isHidden("#message"), true);
    await page.context().close();
  },
};

const failed = await runAll(tests);
await browser.close();
first.close();
second.close();
rmSync(folder, { recursive: true });
process.exit(failed ? 1 : 0);
