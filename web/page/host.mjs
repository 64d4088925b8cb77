// SPDX-License-Identifier: MIT
// What the studio's Host needs of a browser: page_host.cpp calls these as Module.page.
import { tr } from "./words.mjs";

const byId = (id) => document.getElementById(id);

// Whether the page is shown within another one.
export const embedded = window.self !== window.top;

export function announce(text) {
  byId("said").textContent = text;
}

// A message that stays until it is closed, for what went wrong.
export function showMessage(text) {
  byId("message-text").textContent = text;
  byId("message").hidden = false;
  announce(text);
}

export function hideMessage() {
  byId("message").hidden = true;
}

function download(name, bytes) {
  const type = name.endsWith(".png") ? "image/png" : "application/octet-stream";
  const address = URL.createObjectURL(new Blob([bytes], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // The download has begun long before.
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}

function publicAddress() {
  const configured = document.querySelector('meta[name="versorium-public-url"]').content;
  if (configured) return configured;
  const local = /^(localhost|127\.\d+\.\d+\.\d+|\[::1\])$/.test(location.hostname);
  return local || location.protocol === "file:" ? "" : location.origin + location.pathname;
}

const cursors = {
  "-1": "none", 0: "default", 1: "text", 2: "move", 3: "ns-resize", 4: "ew-resize",
  5: "nesw-resize", 6: "nwse-resize", 7: "pointer", 8: "not-allowed",
};

// The state of the studio in the page's address. Changes that follow one another closely share one
// entry of the history; browsers refuse when it is written too often.
const entryAfter = 4000, writeAfter = 400; // milliseconds

export class Address {
  constructor(open) {
    this.fragment = location.hash.slice(1);
    this.changed = -Infinity;
    const moved = () => {
      const fragment = location.hash.slice(1);
      if (fragment === this.fragment) return;
      clearTimeout(this.timer);
      this.fragment = fragment;
      open(fragment);
    };
    addEventListener("popstate", moved);
    addEventListener("hashchange", moved);
  }

  set(fragment) {
    if (fragment === this.fragment) return;
    const now = performance.now();
    // The first state is the one the page was opened with: it has its entry.
    this.push ||= this.fragment !== "" && now - this.changed > entryAfter;
    this.changed = now;
    this.fragment = fragment;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), writeAfter);
  }

  write() {
    try {
      if (this.push) history.pushState(null, "", "#" + this.fragment);
      else history.replaceState(null, "", "#" + this.fragment);
    } catch {
      // Too many within a short time: the next change writes again.
    }
    this.push = false;
  }
}

// The object that the module is made with. `studio()` is the module once it is there.
export function makeHost({ studio, wake, address, tasks, exports, makesFilms, giveUpFilm }) {
  const canvas = byId("canvas");
  let due = Infinity, timer = 0;
  let flat = null, image = null;
  return {
    wake,
    wakeAfter(seconds) {
      const at = performance.now() + 1000 * seconds;
      if (at >= due) return;
      due = at;
      clearTimeout(timer);
      timer = setTimeout(() => { due = Infinity; wake(); }, 1000 * seconds);
    },
    copy(text) {
      navigator.clipboard?.writeText(text).catch(() => announce(tr("The browser did not copy.")));
    },
    work: (head, scene) => tasks().request({ ...JSON.parse(head), head, scene }),
    startExport: (document, name, copy, assets) => exports().begin(document, name, copy, assets),
    cancelExport() {
      giveUpFilm();
      exports().cancel();
    },
    makesFilms,
    save(name, bytes) {
      download(name, bytes);
      return true;
    },
    chooseFile: () => byId("file").click(),
    address: publicAddress,
    stored(name) {
      try {
        return localStorage.getItem("versorium." + name) ?? "";
      } catch {
        return "";
      }
    },
    store(name, text) {
      try {
        localStorage.setItem("versorium." + name, text);
      } catch {
        // Full or forbidden: the text is kept until the page closes, and no longer.
      }
    },
    setFragment: (fragment) => address.set(fragment),
    fullscreen() {
      if (!document.fullscreenEnabled) return false;
      const refused = () => announce(tr("The browser did not fill the screen."));
      if (document.fullscreenElement) document.exitFullscreen().catch(refused);
      else document.documentElement.requestFullscreen().catch(refused);
      return true;
    },
    language: () => navigator.language ?? "en",
    reducedMotion: () => matchMedia("(prefers-reduced-motion: reduce)").matches,
    announce,
    cursor(index) {
      canvas.style.cursor = cursors[index] ?? "default";
    },
    // A screen keyboard comes only for a text field that has the focus.
    typing(wanted) {
      const field = byId("typing");
      if (wanted && matchMedia("(pointer: coarse)").matches) field.focus({ preventScroll: true });
      else if (!wanted && document.activeElement === field) canvas.focus({ preventScroll: true });
    },
    // The canvas without WebGL: opaque RGBA.
    show(rgba, width, height) {
      if (image?.width !== width || image.height !== height) image = new ImageData(width, height);
      image.data.set(rgba);
      flat ??= canvas.getContext("2d", { alpha: false });
      flat?.putImageData(image, 0, 0);
    },
    // A text on the program's heap, which it frees.
    give(text) {
      const module = studio();
      const size = module.lengthBytesUTF8(text) + 1;
      const pointer = module._malloc(size);
      if (pointer !== 0) module.stringToUTF8(text, pointer, size);
      return pointer;
    },
  };
}

// Puts a PNG on the clipboard, or where the browser does not take it, among the downloads. Says
// where it is.
async function copyPicture(name, bytes) {
  try {
    const blob = new Blob([bytes], { type: "image/png" });
    await navigator.clipboard.write([new ClipboardItem({ "image/png": blob })]);
    return tr("the clipboard");
  } catch {
    download(name, bytes);
    return tr("{1}, among your downloads: the browser did not take it into its clipboard", name);
  }
}

export { copyPicture, download };
