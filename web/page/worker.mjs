// SPDX-License-Identifier: MIT
// Computes what the studio asks for, and exports, beside the page: one task after the other, with the
// page's program.
// In: {program, root, build, threads} first, then {id, task: "work" | "export", …}; before a task
// {asset: hash, name, bytes} for files that it names; {cancel: id} gives up that task, where the program
// has threads to hear it.
// Out: {id, head, bytes} for each task, or {id, message, broken}; {progress} now and then.

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
    done: (bytes, head) => done({ bytes, head }),
  });
}

function run(module, task) {
  const ended = new Promise((resolve) => (done = resolve));
  if (task.task === "work")
    withTexts(module, [task.head, task.scene], (head, scene) => module._worker_work(threads, head, scene));
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

// A file that tasks name by its hash.
function keep(module, { asset, name, bytes }) {
  const pointer = module._malloc(bytes.length || 1);
  if (pointer === 0) return; // the task that names it says that it is missing
  module.HEAPU8.set(bytes, pointer);
  withTexts(module, [asset, name], (hash, own) => module._worker_asset(hash, own, pointer, bytes.length));
  module._free(pointer);
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
  if (data.asset) {
    keep(await studio, data);
    return;
  }
  let answer;
  try {
    const module = await studio;
    running = data.id;
    answer = await run(module, data);
    if (answer.bytes.length === 0) delete answer.bytes;
  } catch (error) {
    answer = { message: `the computation stopped: ${error.message ?? error}`, broken: true };
  }
  running = 0;
  postMessage({ id: data.id, ...answer }, answer.bytes ? [answer.bytes.buffer] : []);
};
