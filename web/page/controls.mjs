// SPDX-License-Identifier: MIT
// A canvas says nothing to a screen reader and has nothing for Tab to walk through. So everything
// that can be set or done in the studio stands here once more, as controls of the page: unseen until
// one has the focus, and in step with the studio. Each view has a place to focus as well, whose keys
// go to the studio.
import { gathered, make, makeInput, setDecimal, showValue, stepByKeys, valueOf } from "./elements.mjs";
import { announce } from "./host.mjs";
import { speak, tr } from "./words.mjs";

const every = 300; // milliseconds between two looks at the studio

// One control: its element, where to read and write it, and what of it cannot change in place.
function makeField(control, set) {
  const { id, label, kind, step } = control;
  if (kind === "command") {
    const element = make("button", { type: "button", className: "field", textContent: label });
    element.addEventListener("click", () => set(id, ""));
    const show = (keys) => keys && element.setAttribute("aria-keyshortcuts", keys.replaceAll(" ", "+"));
    return { element, show };
  }
  const input = makeInput(control);
  let now = "";
  input.step_ = step;
  if (kind === "number") stepByKeys(input, () => input.step_);
  input.addEventListener("change", () => {
    const value = valueOf(input, kind);
    if (value === now) return;
    if (set(id, value)) return void (now = value);
    announce(tr("{1} cannot be {2}", label, input.value));
    show(now, true);
  });
  const show = (value, anyway) => {
    // What somebody is typing is left alone.
    if (!anyway && value === now) return;
    now = value;
    showValue(input, kind, value);
  };
  return { element: make("label", { className: "field" }, label + " ", input), input, show };
}

export class Controls {
  // `read` gives the JSON of ui/controls/controls.h, `set(id, value)` says whether it was taken, and
  // `mark(view)` makes a view the one that keys act on.
  constructor(home, canvas, { read, set, mark }) {
    Object.assign(this, { home, canvas, read, set, mark });
    this.fields = new Map();
    this.views = [];
    this.shape = this.text = this.sentence = "";
    this.later = gathered(every, () => this.refresh());
    home.addEventListener("keydown", (event) => {
      if (event.key === "Escape") canvas.focus({ preventScroll: true });
    });
  }

  // The studio may have changed.
  soon(resting) {
    this.resting = resting;
    this.later();
  }

  refresh() {
    const text = this.read();
    if (text !== this.text) {
      this.text = text;
      const { controls, views, focused, language, decimal: sign } = JSON.parse(text);
      if (language !== this.language) {
        setDecimal(sign);
        speak((this.language = language));
      }
      const shape = JSON.stringify(controls.map(({ id, label, options }) => [id, label, options]));
      if (shape !== this.shape) this.build(controls, shape);
      for (const control of controls) {
        const field = this.fields.get(control.id);
        if (field.input) field.input.step_ = control.step;
        field.show(control.value);
      }
      this.onChange?.(controls);
      this.place(views);
      this.sentence = views[focused]?.text ?? "";
    }
    // Only what came to rest is spoken.
    const shown = document.getElementById("shown");
    if (this.resting && this.sentence !== shown.textContent) shown.textContent = this.sentence;
  }

  // The control that has the focus keeps it, where it is still there.
  build(controls, shape) {
    this.shape = shape;
    const focused = document.activeElement?.closest?.(".field")?.dataset.id;
    const groups = new Map();
    this.fields.clear();
    for (const control of controls) {
      const field = makeField(control, this.set);
      field.element.dataset.id = control.id;
      this.fields.set(control.id, field);
      if (!groups.has(control.group)) groups.set(control.group, [make("legend", { textContent: control.group })]);
      groups.get(control.group).push(field.element);
    }
    this.home.replaceChildren(...[...groups.values()].map((parts) => make("fieldset", {}, ...parts)));
    if (!focused) return;
    const again = this.fields.get(focused);
    if (again) (again.input ?? again.element).focus({ preventScroll: true });
    else this.canvas.focus({ preventScroll: true });
  }

  place(views) {
    while (this.views.length > views.length) this.views.pop().remove();
    while (this.views.length < views.length) {
      const index = this.views.length;
      const view = make("div", { className: "view", tabIndex: 0 });
      view.setAttribute("role", "application");
      view.addEventListener("focus", () => this.mark(index));
      this.views.push(view);
      this.home.before(view);
      this.onView?.(view);
    }
    const scale = this.canvas.clientWidth / Math.max(1, this.canvas.width);
    const box = this.canvas.getBoundingClientRect();
    views.forEach(({ text, low, high }, index) => {
      const view = this.views[index];
      view.setAttribute("aria-label", tr("{1} Arrow keys pan, plus and minus zoom.", text));
      view.hidden = !low;
      if (!low) return;
      const [left, top, right, bottom] = [...low, ...high].map((length) => length * scale);
      Object.assign(view.style, {
        left: `${box.left + left}px`, top: `${box.top + top}px`, width: `${right - left}px`, height: `${bottom - top}px`,
      });
    });
  }
}
