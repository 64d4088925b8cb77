// SPDX-License-Identifier: MIT
// Chromium and the server for tests of the page.
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));

export function skip(why) {
  console.log(`SKIPPED: ${why}`);
  process.exit(77);
}

export async function openBrowser() {
  const executablePath =
    process.env.VERSORIUM_CHROMIUM ??
    ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
  if (!executablePath) skip("there is no Chromium: run scripts/setup web");
  const folder = join(root, ".deps/node_modules/playwright-core");
  if (!existsSync(folder)) skip("playwright-core is missing: run scripts/setup web");
  const { chromium } = createRequire(import.meta.url)(folder);
  return chromium.launch({
    executablePath,
    args: [
      "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader",
    ],
  });
}

// Serves a folder with scripts/serve; `stop` ends it.
export async function serve(folder, ...options) {
  const server = spawn(join(root, "scripts/serve"), ["--port", "0", "--folder", folder, ...options], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  const address = await first(server);
  return { address, stop: () => server.kill() };
}

async function first(server) {
  for await (const line of createInterface({ input: server.stdout })) return line;
  throw new Error("scripts/serve ended at once");
}
