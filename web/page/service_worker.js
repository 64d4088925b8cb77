// SPDX-License-Identifier: MIT
// Keeps this build of the page in the browser's store and answers from there. It adds the headers
// that isolate the page, which threads need and which many hosts cannot send.
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
  event.waitUntil(caches.open(build).then((cache) => cache.addAll(files.map((name) => new URL(name, root)))));
});

self.addEventListener("activate", (event) => {
  const tidy = async () => {
    // Only stores of this page: others of the same origin are not its own.
    for (const name of await caches.keys()) {
      if (!name.startsWith("versorium-") || name === build) continue;
      const cache = await caches.open(name);
      if (await cache.match(root, { ignoreSearch: true })) await caches.delete(name);
    }
    await self.clients.claim();
  };
  event.waitUntil(tidy());
});

self.addEventListener("fetch", (event) => {
  const address = new URL(event.request.url);
  if (event.request.method !== "GET" || !address.href.startsWith(root.href)) return;
  const answer = async () => {
    const cache = await caches.open(build);
    const kept = await cache.match(event.request, { ignoreSearch: true });
    const response = kept ?? (await fetch(event.request));
    return response.type === "opaque" || response.status === 0 ? response : isolated(response);
  };
  event.respondWith(answer());
});
