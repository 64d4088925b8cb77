// SPDX-License-Identifier: MIT
// The page: loads the program, draws frames when something happened, and opens what it is given.
import { Controls } from "./controls.mjs";
import { Address, announce, copyPicture, download, embedded, hideMessage, makeHost, showMessage } from "./host.mjs";
import { listen } from "./input.mjs";
import { LessonPane } from "./lesson.mjs";
import { compileProgram, instantiation } from "./load.mjs";
import { filmOf, makesFilms } from "./film.mjs";
import { Export, Tasks } from "./tasks.mjs";
import { firstLanguage, sayBy, speak, tr } from "./words.mjs";

const byId = (id) => document.getElementById(id);
const canvas = byId("canvas");
const here = new URL("./", import.meta.url);

let studio = null, tasks = null, exports = null, controls = null, lesson = null, pending = 0, later = 0, firstPicture = 0;

// Calls a function of the program that takes texts and perhaps returns one.
const call = (name, returns, ...texts) =>
  studio.ccall(name, returns, texts.map(() => "string"), texts);

function showBytes(loaded, total) {
  byId("progress").value = loaded / total;
  const kilobytes = (bytes) => Math.round(bytes / 1024);
  byId("loaded").textContent = tr("{1} of {2} kB", kilobytes(loaded), kilobytes(total));
}

// Frames

function fitCanvas() {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio);
  const height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  return [width, height, ratio];
}

function frame() {
  pending = 0;
  const more = studio._page_frame(...fitCanvas());
  controls.soon(studio._page_finished() === 1);
  lesson.soon();
  if (!firstPicture && studio._page_pictures_taken() > 0) {
    firstPicture = performance.now();
    document.documentElement.dataset.state = "ready";
  }
  if (more === 1) wake();
  clearTimeout(later);
  if (more === 2) later = setTimeout(wake, 250);
}

function wake() {
  if (!pending && studio) pending = requestAnimationFrame(frame);
}

function wakeAnew() {
  studio._page_wake();
  wake();
}

// What comes back from the workers

function deliver(request, { bytes, head, message }) {
  if (head) {
    const begin = studio._page_answer_begin(bytes?.length ?? 0);
    if (bytes) studio.HEAPU8.set(bytes, begin);
    call("page_answer_end", null, head);
  } else {
    call("page_work_failed", null, request.head, message || tr("the picture did not arrive"));
  }
  wake();
}

// A file that scenes name, copied from the program; null where it has none of this name.
function assetOf(hash) {
  const begin = call("page_asset", "number", hash);
  if (begin === 0) return null;
  const name = call("page_asset_name", "string", hash);
  return { hash, name, bytes: studio.HEAPU8.slice(begin, begin + call("page_asset_size", "number", hash)) };
}

let film = null; // the one that is being recorded; another one once it is given up

async function endExport(name, { bytes, message }, copy) {
  if (bytes && name.endsWith(".webm")) {
    const mine = (film = {});
    try {
      bytes = await filmOf(bytes, () => film === mine, (part) => {
        studio._page_export_progress(part);
        wake();
      });
    } catch (error) {
      [bytes, message] = [undefined, tr("the browser did not record the film: {1}", error.message ?? error)];
    }
    if (film !== mine) return;
  }
  if (bytes && !copy) download(name, bytes);
  const where = bytes && copy ? await copyPicture(name, bytes) : tr("{1}, among your downloads", name);
  studio.ccall("page_export_end", null, ["number", "string"],
    [bytes ? 1 : 0, bytes ? where : message || tr("nothing arrived")]);
  wake();
}

// Files and links

function openFragment(fragment) {
  const message = call("page_open_fragment", "string", fragment);
  if (message) showMessage(tr("The link does not open: {1}", message));
  else hideMessage();
  wake();
}

const largest = 64 * 1024 * 1024;

async function openFile(file) {
  if (!file) return;
  let message = "";
  if (file.size > largest) {
    message = tr("{1}: {2} bytes are too many; {3} may be opened", file.name, file.size, largest);
  } else {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const pointer = studio._malloc(bytes.length || 1);
    if (pointer === 0) return showMessage(tr("{1}: there is not enough memory", file.name));
    studio.HEAPU8.set(bytes, pointer);
    message = studio.ccall("page_open", "string", ["string", "number", "number"],
      [file.name, pointer, bytes.length]);
    studio._free(pointer);
  }
  if (message) return showMessage(message);
  hideMessage();
  announce(tr("{1} is open", file.name));
  wake();
}

function listenToFiles() {
  const input = byId("file");
  byId("open").addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    openFile(input.files[0]);
    input.value = "";
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    openFile(event.dataTransfer.files[0]);
  });
  document.addEventListener("paste", (event) => {
    if (event.target.closest?.(".field, #lesson")) return;
    event.preventDefault();
    const { files } = event.clipboardData;
    if (files.length > 0) return openFile(files[0]);
    const text = event.clipboardData.getData("text/plain");
    // A link or a scene opens, but not while somebody writes.
    const link = text.trim().match(/^(?:\S*#)?(v1:\S+)$/);
    if (!studio._page_typing() && link) openFragment(link[1]);
    else if (!studio._page_typing() && /^\s*\{/.test(text)) openFile(new File([text], tr("the pasted scene")));
    else call("page_paste", null, text);
    wake();
  });
  byId("dismiss").addEventListener("click", () => {
    hideMessage();
    canvas.focus();
  });
}

function listenToContext() {
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    studio._page_context_lost();
  });
  canvas.addEventListener("webglcontextrestored", () => {
    studio._page_context_restored();
    wake();
  });
}

// The ratio of pixels changes when the window moves to another display, or is zoomed.
function listenToSize() {
  new ResizeObserver(wakeAnew).observe(canvas);
  const again = () => {
    wakeAnew();
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", again, { once: true });
  };
  again();
}

// Beginning

const meta = (name) => document.querySelector(`meta[name="${name}"]`).content;

// A page that is isolated uses threads, where that build stands beside this one.
function programHere() {
  const threads = Number(meta("versorium-threads"));
  if (!globalThis.crossOriginIsolated || !threads)
    return { root: here, size: Number(meta("versorium-program-size")), threads: 0 };
  const processors = navigator.hardwareConcurrency || 1;
  return { root: new URL("threads/", here), size: threads, threads: Math.min(8, processors) };
}

// A part of the program, of this build.
const partOf = (root, name) => new URL(`${name}?build=${meta("versorium-build")}`, root);

async function begin() {
  const { root, size, threads } = programHere();
  const [program, { default: create }] = await Promise.all([
    compileProgram(partOf(root, "versorium_studio.packed"), size, showBytes, tr),
    import(partOf(root, "versorium_studio.mjs")),
  ]);
  byId("loaded").textContent = tr("Starting …");
  const address = new Address(openFragment);
  const start = { program, root: root.href, build: meta("versorium-build"), threads };
  tasks = new Tasks(start, assetOf, deliver);
  let module = null;
  const page = makeHost({
    studio: () => module, wake, address, tasks: () => tasks, exports: () => exports, makesFilms,
    giveUpFilm: () => { film = null; },
  });
  module = await create({
    page, threads: 0, instantiateWasm: instantiation(program),
    locateFile: (name) => partOf(root, name).href,
    onAbort: (what) => showMessage(tr("The program stopped: {1}. Load the page again.", what)),
  });
  exports = new Export(start, assetOf, {
    onProgress: (progress) => { module._page_export_progress(progress); wake(); },
    onEnd: endExport,
  });
  const graphics = module._page_start(/Mac|iP(hone|ad|od)/.test(navigator.platform) ? 1 : 0);
  studio = module;
  sayBy((english) => call("page_tr", "string", english));
  const keys = listen(canvas, studio, wake, () => byId("file").click());
  const set = (id, value) => {
    const taken = call("page_set_control", "number", id, value) === 1;
    wake();
    return taken;
  };
  controls = new Controls(byId("controls"), canvas, {
    read: () => call("page_controls", "string"),
    set,
    mark: (view) => { studio._page_mark_view(view); wake(); },
  });
  controls.onView = keys;
  lesson = new LessonPane(byId("lesson"), {
    read: () => call("page_lesson", "string"),
    act: (action, value) => {
      const done = call("page_lesson_do", "number", action, value) === 1;
      wake();
      return done;
    },
    set,
    ring: () => call("page_lesson_ring", "string"),
  });
  controls.onChange = (all) => lesson.showControls(all);
  byId("lessons").addEventListener("click", () => lesson.act("list"));
  listenToContext();
  listenToFiles();
  listenToSize();
  byId("loading").remove();
  // Within another page nothing takes the focus before somebody works in here.
  if (!embedded) canvas.focus({ preventScroll: true });
  if (location.hash.length > 1) openFragment(location.hash.slice(1));
  if (!graphics)
    showMessage(tr("This browser gives no WebGL 2: the CPU draws, and everything is slower."));
  window.versorium = {
    get framesDrawn() { return studio._page_frames_drawn(); },
    get picturesTaken() { return studio._page_pictures_taken(); },
    get firstPicture() { return firstPicture; }, // in milliseconds since the page was asked for
    get threads() { return threads; },
    get finished() { return studio._page_finished() === 1; },
    stop: () => studio._page_stop(),
    fragment: () => call("page_fragment", "string"),
    set,
    controls: () => call("page_controls", "string"),
    lesson: () => call("page_lesson", "string"),
    lessonDo: (action, value = "") => call("page_lesson_do", "number", action, value) === 1,
  };
  wakeAnew();
}

// Later visits come from the browser's own store, and work without a network.
function keepForLater() {
  if (!("serviceWorker" in navigator) || !window.isSecureContext) return;
  // The first one that comes brings nothing new.
  let before = navigator.serviceWorker.controller;
  navigator.serviceWorker.addEventListener("controllerchange", () => {
    if (before) showMessage(tr("There is a new version of this page: load it again to have it."));
    before = navigator.serviceWorker.controller;
  });
  navigator.serviceWorker.register(new URL("service_worker.js", here)).catch(() => {});
}

speak(firstLanguage());
begin().then(keepForLater, (error) => {
  byId("loading").remove();
  document.documentElement.dataset.state = "failed";
  showMessage(tr("Versorium did not start: {1}", error.message ?? error));
});
