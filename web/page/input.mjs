// SPDX-License-Identifier: MIT
// Mouse, fingers, keys and text of the canvas, for page_input.cpp.
import { embedded } from "./host.mjs";

const longPress = 80; // milliseconds that one finger waits for a second
const slop = 6; // CSS pixels that it may tremble meanwhile

function listenToPointers(canvas, studio, wake) {
  const at = (x, y) => {
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / Math.max(1, box.width);
    return [(x - box.left) * scale, (y - box.top) * scale];
  };
  const move = (x, y, touch) => {
    studio._page_move(...at(x, y), touch);
    wake();
  };
  const button = (which, down) => {
    studio._page_button(which, down ? 1 : 0);
    wake();
  };

  // Fingers: one is the left button. Two move and zoom the view that they are on, and elsewhere turn
  // the wheel; the button waits a little so that two fingers never begin with a click of one.
  const fingers = new Map();
  let pressed = false, timer = 0, spread = 0, centre = [0, 0];
  const press = (down) => {
    clearTimeout(timer);
    timer = 0;
    if (pressed !== down) button(0, down);
    pressed = down;
  };
  const middle = () => {
    const all = [...fingers.values()];
    return [(all[0].x + all[1].x) / 2, (all[0].y + all[1].y) / 2];
  };
  const distance = () => {
    const [a, b] = fingers.values();
    return Math.max(1, Math.hypot(a.x - b.x, a.y - b.y));
  };
  const fingerDown = (event) => {
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (fingers.size === 1) {
      move(event.clientX, event.clientY, 1);
      timer = setTimeout(() => press(true), longPress);
    } else if (fingers.size === 2) {
      press(false);
      move(...middle(), 1);
      centre = at(...middle());
      spread = distance();
    } else {
      press(false);
    }
  };
  const fingerMove = (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return;
    if (timer && Math.hypot(event.clientX - finger.x, event.clientY - finger.y) > slop) press(true);
    if (timer) return;
    finger.x = event.clientX;
    finger.y = event.clientY;
    if (fingers.size === 1) move(finger.x, finger.y, 1);
    if (fingers.size !== 2) return;
    const now = distance(), next = at(...middle());
    if (!studio._page_pinch(...centre, ...next, now / spread)) {
      move(...middle(), 1);
      studio._page_wheel(0, (next[1] - centre[1]) / 40);
    }
    spread = now;
    centre = next;
    wake();
  };
  const fingerUp = (event) => {
    if (!fingers.delete(event.pointerId)) return;
    if (timer && event.type === "pointerup") press(true); // a tap
    press(false);
    // What remains of two fingers rests until it is lifted too.
    if (fingers.size > 0) fingers.forEach((_, id) => fingers.set(id, { x: NaN, y: NaN }));
    if (fingers.size === 1) fingers.clear();
    if (fingers.size === 0) studio._page_leave();
    wake();
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture?.(event.pointerId);
    if (event.pointerType === "touch") return fingerDown(event);
    move(event.clientX, event.clientY, 0);
    button([0, 2, 1, 3, 4][event.button] ?? 0, true);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.pointerType === "touch") return fingerMove(event);
    move(event.clientX, event.clientY, 0);
    // A second button, pressed or let go while another is held, comes as a movement.
    if (event.button > 0) button([0, 2, 1, 3, 4][event.button] ?? 0, event.buttons & [1, 4, 2, 8, 16][event.button]);
  });
  const up = (event) => {
    if (event.pointerType === "touch") return fingerUp(event);
    if (event.type === "pointercancel") [0, 1, 2].forEach((which) => button(which, false));
    else button([0, 2, 1, 3, 4][event.button] ?? 0, false);
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch" && event.buttons === 0) studio._page_leave();
    wake();
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());

  // Within another page the wheel scrolls that page until somebody works in here.
  canvas.addEventListener("wheel", (event) => {
    if (embedded && !event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    const unit = [100, 3, 1][event.deltaMode] ?? 100;
    // Fingers on a touch pad come as a wheel with Ctrl, in small steps.
    const pinch = event.ctrlKey && Math.abs(event.deltaY) < 50 ? 6 : 1;
    const limited = (steps) => Math.min(5, Math.max(-5, steps));
    studio._page_wheel(limited(-event.deltaX / unit), limited((-event.deltaY * pinch) / unit));
    wake();
  }, { passive: false });
}

// What the browser keeps: tabs and windows, its own tools, the clipboard's events.
function isBrowsers(event) {
  const command = event.ctrlKey || event.metaKey;
  if (/^F([1-9]|1[0-2])$/.test(event.code)) return true;
  if (command && /^Key[CXVRTNWLQ]$/.test(event.code)) return true;
  if (command && event.shiftKey && /^Key[IJ]$/.test(event.code)) return true;
  if (command && /^(Equal|Minus|Digit0|Numpad.*|Tab)$/.test(event.code)) return true;
  return event.altKey && /^Arrow/.test(event.code);
}

function listenToKeys(canvas, studio, wake, openFile) {
  const field = document.getElementById("typing");
  const key = (code, down) => studio.ccall("page_key", null, ["string", "number"], [code, down]);
  const text = (characters) => studio.ccall("page_text", null, ["string"], [characters]);
  // Shortcuts follow the letters of the layout, all else the places of the keys.
  const codeOf = (event) =>
    /^[a-zA-Z]$/.test(event.key) ? "Key" + event.key.toUpperCase()
    : event.key === "?" ? "Slash"
    : event.code || { Enter: "Enter", Backspace: "Backspace" }[event.key] || "";
  const modifiers = (event) =>
    studio._page_modifiers(+event.ctrlKey, +event.shiftKey, +event.altKey, +event.metaKey);

  const onKey = (event) => {
    const down = event.type === "keydown";
    // Tab walks on through the page's controls, but within the studio's text fields; there
    // Shift+Escape gives the keyboard back to the page.
    if (event.code === "Tab" && !studio._page_typing()) return;
    if (down && event.code === "Escape" && event.shiftKey) return event.target.blur();
    if (down && (event.ctrlKey || event.metaKey) && event.code === "KeyO") {
      event.preventDefault();
      return openFile();
    }
    modifiers(event);
    if (!event.repeat || !down) key(codeOf(event), down ? 1 : 0);
    // While the command key is held, letting go of others is never said.
    if (!down && event.key === "Meta") studio._page_focus(0), studio._page_focus(1);
    const printed = [...event.key].length === 1 && !event.ctrlKey && !event.metaKey;
    if (down && printed && event.target !== field) text(event.key);
    if (!isBrowsers(event) && event.target !== field) event.preventDefault();
    wake();
  };
  const listenOn = (target) => {
    target.addEventListener("keydown", onKey);
    target.addEventListener("keyup", onKey);
  };
  listenOn(canvas);
  listenOn(field);
  field.addEventListener("input", (event) => {
    if (event.isComposing) return;
    if (event.inputType === "deleteContentBackward") key("Backspace", 1), key("Backspace", 0);
    text(field.value.trim() === "" ? field.value.slice(1) : field.value.replace(/^\u00a0/, ""));
    field.value = "\u00a0"; // something to delete
    wake();
  });
  field.value = "\u00a0";

  addEventListener("blur", () => {
    modifiers({ ctrlKey: false, shiftKey: false, altKey: false, metaKey: false });
    studio._page_focus(0);
    wake();
  });
  addEventListener("focus", () => {
    studio._page_focus(1);
    wake();
  });
  return listenOn;
}

// Returns what makes another element's keys the studio's.
export function listen(canvas, studio, wake, openFile) {
  listenToPointers(canvas, studio, wake);
  return listenToKeys(canvas, studio, wake, openFile);
}
