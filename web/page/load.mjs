// SPDX-License-Identifier: MIT
// Fetches the program, packed by gzip, and compiles it while it comes in. `onBytes(loaded, total)`;
// `tr` says texts in the language of the page (words.mjs).

export async function compileProgram(address, total, onBytes, tr) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(tr("{1}: the server answers {2}", address.pathname, response.status));
  let loaded = 0;
  const counted = response.body.pipeThrough(
    new TransformStream({
      transform(bytes, controller) {
        loaded += bytes.byteLength;
        onBytes(loaded, Math.max(total, loaded));
        controller.enqueue(bytes);
      },
    }),
  );
  const headers = { "Content-Type": "application/wasm" };
  const unpacked = counted.pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(unpacked, { headers }));
}

// What Emscripten's modules take in order to run a program that is compiled already.
export function instantiation(program) {
  return function (imports, receive) {
    WebAssembly.instantiate(program, imports).then((instance) => {
      receive(instance, program);
      // A program with threads waits until all that it begins with are there, and for none of them
      // it would wait for ever.
      if (this.threads === 0) this.removeRunDependency?.("wasm-instantiate");
    });
    return {};
  };
}
