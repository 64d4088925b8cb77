// SPDX-License-Identifier: MIT
// Computes pictures and exports beside the page: one task after the other, with the page's program.
// In: {program, root, build, threads} first, then {id, task: "picture" | "export", …}; {cancel: id} gives
// up that task, where the program has threads to hear it.
// Out: {id, …} for each task, {progress} now and then.

let studio, done, threads, running;

async function open(start) {
  const partOf = (name) => `${start.root}${name}?build=${start.build}`;
  const { default: create } = await import(partOf("versorium_studio.mjs"));
  const { instantiation } = await import("./load.mjs" + location.search);
  threads = start.threads;
  return create({
    instantiateWasm: instantiation(start.program),
    locateFile: partOf,
    mainScriptUrlOrBlob: partOf("versorium_studio.mjs"),
    threads,
    progress: (progress) => postMessage({ progress }),
    done: (bytes, message, seconds, members) => done({ bytes, message, seconds, members }),
  });
}

function run(module, task) {
  const ended = new Promise((resolve) => (done = resolve));
  if (task.task === "picture")
    withTexts(module, [task.scene], (scene) =>
      module._worker_picture(
        threads, scene, task.width, task.height, task.samples, task.portion, task.least));
  else
    withTexts(module, [task.document, task.name], (document, name) =>
      module._worker_export(threads, document, name));
  return ended;
}

function withTexts(module, texts, work) {
  const pointers = texts.map((text) => {
    const size = module.lengthBytesUTF8(text) + 1;
    const pointer = module._malloc(size);
    if (pointer === 0) throw new Error(`${size} bytes do not fit into memory`);
    module.stringToUTF8(text, pointer, size);
    return pointer;
  });
  work(...pointers);
  pointers.forEach((pointer) => module._free(pointer));
}

onmessage = async ({ data }) => {
  if (data.program) {
    studio = open(data);
    return;
  }
  if (data.cancel) {
    if (data.cancel === running) (await studio)._worker_cancel();
    return;
  }
  let answer;
  try {
    const module = await studio;
    running = data.id;
    answer = await run(module, data);
    if (answer.message) delete answer.bytes;
  } catch (error) {
    answer = { message: `the computation stopped: ${error.message ?? error}`, broken: true };
  }
  running = 0;
  postMessage({ id: data.id, ...answer }, answer.bytes ? [answer.bytes.buffer] : []);
};
