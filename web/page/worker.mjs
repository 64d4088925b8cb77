// SPDX-License-Identifier: MIT
// Computes pictures and exports beside the page: one task after the other, with the page's program.
// In: {program, root, threads} first, then {id, task: "picture" | "export", …}.
// Out: {id, …} for each task, {progress} now and then.
import { instantiation } from "./load.mjs";

let studio;

async function open({ program, root, threads }) {
  const { default: create } = await import(root + "versorium_studio.mjs");
  return create({
    instantiateWasm: instantiation(program),
    locateFile: (name) => root + name,
    mainScriptUrlOrBlob: root + "versorium_studio.mjs",
    threads,
    progress: (progress) => postMessage({ progress }),
  });
}

function withTexts(module, texts, work) {
  const pointers = texts.map((text) => {
    const size = module.lengthBytesUTF8(text) + 1;
    const pointer = module._malloc(size);
    if (pointer === 0) throw new Error(`${size} bytes do not fit into memory`);
    module.stringToUTF8(text, pointer, size);
    return pointer;
  });
  const done = work(...pointers);
  pointers.forEach((pointer) => module._free(pointer));
  return done;
}

function run(module, task) {
  const ok =
    task.task === "picture"
      ? withTexts(module, [task.scene], (scene) =>
          module._worker_picture(scene, task.width, task.height, task.samples),
        )
      : withTexts(module, [task.document, task.name], (document, name) =>
          module._worker_export(document, name),
        );
  if (!ok) return { message: module.UTF8ToString(module._worker_message()) };
  const begin = module._worker_bytes();
  const bytes = module.HEAPU8.slice(begin, begin + module._worker_size());
  return { bytes, seconds: module._worker_seconds() };
}

onmessage = async ({ data }) => {
  if (data.program) {
    studio = open(data);
    return;
  }
  let answer;
  try {
    answer = run(await studio, data);
  } catch (error) {
    answer = { message: `the computation stopped: ${error.message ?? error}`, broken: true };
  }
  postMessage({ id: data.id, ...answer }, answer.bytes ? [answer.bytes.buffer] : []);
};
