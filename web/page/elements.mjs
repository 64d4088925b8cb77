// SPDX-License-Identifier: MIT
// What the controls of the page and the lesson's pane are made of.

export const make = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
};

// Numbers are written with the decimal sign of the language, and read with a point or a comma.
let decimal = ".";
export const setDecimal = (sign) => { decimal = sign; };
export const written = (number) => number.replace(".", decimal);
export const readNumber = (text) => text.trim().replace(",", ".");

// The element of a control of ui/controls/controls.h that holds a value, not a command's.
export function makeInput({ kind, options, shown }) {
  if (kind === "choice")
    return make("select", {}, ...options.map((value, index) => make("option", { textContent: shown[index], value })));
  const type = { number: "text", toggle: "checkbox", colour: "color", text: "text" }[kind];
  return make("input", { type });
}

// The value as the studio takes it, and how it is shown.
export const valueOf = (input, kind) =>
  kind === "toggle" ? (input.checked ? "on" : "off")
  : kind === "number" ? readNumber(input.value)
  : input.value;

export function showValue(input, kind, value) {
  if (kind === "toggle") input.checked = value === "on";
  else input.value = kind === "number" ? written(value) : value;
  if (kind === "number") input.setAttribute("aria-valuenow", value);
  if (kind === "choice" && input.value !== value) input.selectedIndex = -1;
}

// Arrows and Page keys step a number; `step()` is one step.
export function stepByKeys(input, step) {
  input.setAttribute("role", "spinbutton");
  input.inputMode = "decimal";
  input.addEventListener("keydown", (event) => {
    const steps = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (!steps) return;
    event.preventDefault();
    const wanted = Number(readNumber(input.value)) + steps * step();
    input.value = written(String(Number(wanted.toPrecision(12))));
    input.dispatchEvent(new Event("change"));
  });
}

// Calls once for all that happens within a moment.
export function gathered(milliseconds, call) {
  let timer = 0;
  return () => {
    timer ||= setTimeout(() => {
      timer = 0;
      call();
    }, milliseconds);
  };
}
