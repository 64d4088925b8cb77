// SPDX-License-Identifier: MIT
// The core for JavaScript, over the C interface of core_api.cpp:
//   const core = await openCore(createVersorium);
//   const png = core.render(scene, 800, 600);               // Uint8Array
//   const npy = core.measure(scene, "distance", 800, 600);  // Uint8Array, NumPy's format
// A scene is an object or its JSON text. It blocks while it computes: run it in a worker.

// As base/status.h counts them.
const kinds = ["none", "usage", "data", "inputOutput", "cancelled"];

export class CoreError extends Error {
  constructor(kind, message) {
    super(message);
    this.name = "CoreError";
    this.kind = kind;
  }
}

// `create` is the default export of versorium_core.mjs, `options` what Emscripten's modules take.
export async function openCore(create, { threads = 0, ...options } = {}) {
  const module = await create(options);
  const instance = module._versorium_open(threads);

  // Texts are put on the heap, not on the stack: a scene may carry assets of megabytes.
  const call = (name, texts, numbers) => {
    const pointers = texts.map((text) => {
      const size = module.lengthBytesUTF8(text) + 1;
      const pointer = module._malloc(size);
      if (pointer === 0) throw new CoreError("usage", `${size} bytes do not fit into memory`);
      module.stringToUTF8(text, pointer, size);
      return pointer;
    });
    const code = module[name](instance, ...pointers, ...numbers);
    pointers.forEach((pointer) => module._free(pointer));
    if (code !== 0) {
      throw new CoreError(kinds[code], module.UTF8ToString(module._versorium_message(instance)));
    }
    const begin = module._versorium_bytes(instance);
    return module.HEAPU8.slice(begin, begin + module._versorium_size(instance));
  };
  const textOf = (scene) => (typeof scene === "string" ? scene : JSON.stringify(scene));

  return {
    render: (scene, width = 0, height = 0) =>
      call("_versorium_render", [textOf(scene)], [width, height]),
    measure: (scene, field, width = 0, height = 0) =>
      call("_versorium_measure", [textOf(scene), field], [width, height]),
    preset: (name) => JSON.parse(new TextDecoder().decode(call("_versorium_preset", [name], []))),
    close: () => module._versorium_close(instance),
  };
}
