// SPDX-License-Identifier: MIT
// Keeps this build of the page in the browser's store and answers from there. It adds the headers
// that isolate the page, which threads need and which many hosts cannot send. A new build takes over
// at once, for all that is loaded from then on. A page of the build before asks for what it still
// needs with ?build=…, and gets it from the store of that build.
const build = "versorium-@BUILD@";
const files = ["./", @FILES@];
const root = new URL("./", self.location);

function isolated(response) {
  const headers = new Headers(response.headers);
  headers.set("Cross-Origin-Opener-Policy", "same-origin");
  headers.set("Cross-Origin-Embedder-Policy", "require-corp");
  headers.set("Cross-Origin-Resource-Policy", "same-origin");
  return new Response(response.body, { status: response.status, statusText: response.statusText, headers });
}

self.addEventListener("install", (event) => {
  const keep = async () => {
    const cache = await caches.open(build);
    // Past what the browser has kept by itself: that may be of the build before.
    await cache.addAll(files.map((name) => new Request(new URL(name, root), { cache: "no-cache" })));
    await self.skipWaiting();
  };
  event.waitUntil(keep());
});

// Other builds, once no page is open that may be one of theirs. Only stores of this page: others of
// the same origin are not its own.
async function tidy() {
  if ((await self.clients.matchAll({ type: "window" })).length > 0) return;
  for (const name of await caches.keys()) {
    if (!name.startsWith("versorium-") || name === build) continue;
    const cache = await caches.open(name);
    if (await cache.match(root, { ignoreSearch: true })) await caches.delete(name);
  }
}

self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim().then(tidy)));

self.addEventListener("fetch", (event) => {
  const address = new URL(event.request.url);
  if (event.request.method !== "GET" || !address.href.startsWith(root.href)) return;
  if (event.request.mode === "navigate") event.waitUntil(tidy());
  const answer = async () => {
    const asked = "versorium-" + address.searchParams.get("build");
    const cache = await caches.open((await caches.has(asked)) ? asked : build);
    const kept = await cache.match(event.request, { ignoreSearch: true });
    const response = kept ?? (await fetch(event.request));
    return response.type === "opaque" || response.status === 0 ? response : isolated(response);
  };
  event.respondWith(answer());
});
