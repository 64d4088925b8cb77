// SPDX-License-Identifier: MIT
// What all tests of the page share: the browser, waiting, and running them one by one.
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const chromium = "/usr/bin/chromium";
export const patience = 90000; // milliseconds: for machines that are busy with other tests

function skip(why) {
  console.log("SKIPPED: " + why);
  process.exit(77);
}

// The folder of the page, and a browser. Where one of them is missing the test is skipped.
export async function prepare(root) {
  const dist = join(root, "build/web/dist");
  const driver = resolve(root, ".deps/node_modules/playwright-core");
  if (!existsSync(join(dist, "index.html"))) skip("there is no page: run scripts/build web");
  if (!existsSync(driver)) skip("playwright-core is missing: run scripts/setup web");
  if (!existsSync(chromium)) skip("chromium is missing: run scripts/setup web");
  const browser = await createRequire(import.meta.url)(driver).chromium.launch({
    executablePath: chromium,
    args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader"],
  });
  return { dist, browser };
}

// The content policy forbids what playwright's own waitForFunction does in the page: ask from here.
export async function waitFor(page, condition, argument) {
  const end = Date.now() + patience;
  while (Date.now() < end) {
    if (await page.evaluate(condition, argument)) return;
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error("it never came to this: " + condition);
}

export const fragment = (page) => page.evaluate(() => window.versorium.fragment());
export const changed = (page, before) =>
  waitFor(page, (was) => window.versorium.fragment() !== was, before);

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
