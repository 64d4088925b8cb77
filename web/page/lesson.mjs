// SPDX-License-Identifier: MIT
// The lesson's pane: its text, question and goal as elements of the page, so that it can be read
// aloud, walked through by Tab and written into. What it holds comes from the program as JSON
// (core/ui/lesson_page.cpp), and every button goes back there.
import { gathered, make, makeInput, showValue, stepByKeys, valueOf } from "./elements.mjs";
import { announce, embedded } from "./host.mjs";
import { tr } from "./words.mjs";

const every = 250; // milliseconds between two looks at the studio

// Text with emphasis; a formula is spoken in words.
function runs(list) {
  return list.map(({ text, spoken, strong, emphasis, code }) => {
    let node = document.createTextNode(text);
    if (spoken && spoken !== text) {
      node = make("span", {},
        make("span", { ariaHidden: "true", textContent: text }),
        make("span", { className: "unseen", textContent: spoken }));
    }
    if (code) node = make("code", {}, node);
    if (emphasis) node = make("em", {}, node);
    if (strong) node = make("strong", {}, node);
    return node;
  });
}

const plain = (list) => list.map(({ text }) => text).join("");

// Paragraphs and lists within each other.
function blocks(list) {
  const home = document.createDocumentFragment();
  const open = []; // lists that are open, from the outermost
  for (const { runs: text, item } of list) {
    if (!item) {
      open.length = 0;
      home.append(make("p", {}, ...runs(text)));
      continue;
    }
    open.length = Math.min(open.length, item.level);
    while (open.length < item.level) {
      const inner = make(item.number > 0 ? "ol" : "ul");
      (open.length ? open[open.length - 1].lastElementChild ?? open[open.length - 1] : home).append(inner);
      open.push(inner);
    }
    open[open.length - 1].append(make("li", {}, ...runs(text)));
  }
  return home;
}

export class LessonPane {
  // `read` gives the JSON, `act(action, value)` says whether it was done, `set(id, value)` sets a
  // control, and `ring()` is the ring's place as an answer.
  constructor(home, { read, act, set, ring }) {
    Object.assign(this, { home, read, set, ring });
    this.soon = gathered(every, () => this.refresh());
    this.act = (action, value = "") => {
      const done = act(action, value);
      this.refresh();
      return done;
    };
    this.text = this.at = "";
    this.draft = "";
    this.fields = new Map();
  }

  refresh() {
    const text = this.read();
    if (text !== this.text) {
      this.text = text;
      this.build(JSON.parse(text));
    }
    this.showControls();
  }

  build(state) {
    const focused = document.activeElement?.closest?.("#lesson") ? document.activeElement.dataset.key : null;
    const scrolled = this.home.scrollTop;
    const shown = !this.home.hidden;
    this.home.hidden = !state.open;
    document.documentElement.classList.toggle("with-lesson", state.open);
    if (!state.open) return void this.home.replaceChildren();
    const at = state.lesson ? `${state.lesson.id} ${state.lesson.at}` : "list";
    if (at !== this.at) this.draft = state.step?.question?.answer ?? "";
    this.home.replaceChildren(...(state.lesson ? this.lesson(state) : this.list(state)));
    const turned = at !== this.at;
    this.at = at;
    this.home.scrollTop = turned ? 0 : scrolled;
    const again = focused && this.home.querySelector(`[data-key="${CSS.escape(focused)}"]`);
    // A new step is read from its heading on.
    if (turned && (focused || (!shown && !embedded))) this.home.querySelector("h2")?.focus({ preventScroll: true });
    else if (again && !again.disabled) again.focus({ preventScroll: true });
    else if (focused) this.home.querySelector("h2")?.focus({ preventScroll: true });
  }

  button(label, key, action, value = "", properties = {}) {
    const button = make("button", { type: "button", textContent: label, ...properties });
    button.dataset.key = key;
    button.addEventListener("click", () => this.act(action, value));
    return button;
  }

  heading(text, children) {
    return make("h2", { tabIndex: -1 }, ...(children ?? [text]));
  }

  list({ lessons }) {
    const entries = lessons.map(({ id, title, level, minutes, steps, done }) => make("li", {},
      this.button(`${done === steps ? "✓ " : ""}${title}`, `open ${id}`, "open", id, { className: "lesson" }),
      make("small", { textContent: `${minutes} min · ${level} · ${done} / ${steps}` })));
    const file = make("button", { type: "button", textContent: tr("Open a lesson's file") });
    file.dataset.key = "file";
    file.addEventListener("click", () => document.getElementById("file").click());
    return [
      this.heading(tr("Lessons")),
      make("p", { textContent: tr("Each takes five to ten minutes. What you have done is kept here, on this device.") }),
      make("ol", { className: "lessons" }, ...entries),
      make("p", { className: "buttons" }, file, this.button(tr("Close"), "close", "close")),
    ];
  }

  lesson({ lesson, step }) {
    const done = lesson.steps.filter((one) => one.done).length;
    const dots = lesson.steps.map((one, index) => {
      const name = `${index + 1}. ${one.title}${one.done ? " ✓" : ""}`;
      const dot = this.button(one.done ? "●" : "○", `step ${index}`, "step", String(index), { title: name, ariaLabel: name });
      if (index === lesson.at) dot.setAttribute("aria-current", "step");
      return make("li", {}, dot);
    });
    const parts = [
      make("header", {},
        make("h1", { textContent: lesson.title }),
        make("nav", { ariaLabel: `${tr("Steps")}: ${done} / ${lesson.steps.length}` },
          make("ol", { className: "steps" }, ...dots))),
      this.heading("", [...runs(step.title)]),
      blocks(step.prose),
      this.controlsHome(step.controls),
      step.question ? this.question(step.question, step) : null,
      step.reveal ? this.reveal(step) : null,
      step.goal ? this.goal(step.goal) : null,
      ...step.hints.map((hint) => make("aside", { className: "hint" }, make("strong", { textContent: tr("Hint") }), blocks(hint))),
      make("p", { className: "buttons" },
        step.canHint ? this.button(tr("Hint"), "hint", "hint") : null,
        step.canReveal ? this.button(tr("Show me"), "show", "show") : null,
        step.wandering ? this.button(tr("Back to the step"), "return", "return") : null,
        step.mayWander ? this.button(tr("All controls"), "wander", "wander") : null,
        this.button(tr("Reset"), "reset", "reset")),
      step.last ? this.end() : null,
      step.notes.length
        ? make("details", {}, make("summary", { textContent: tr("For teachers") }), ...step.notes.map(blocks)) : null,
      make("footer", { className: "buttons" },
        this.button(tr("← Back"), "back", "back", "", { disabled: lesson.at === 0 }),
        this.button(tr("Next →"), "next", "next", "", { disabled: step.last }),
        lesson.locked ? null : this.button(tr("All lessons"), "all", "all"),
        lesson.locked ? null : this.button(tr("Close"), "close", "close")),
    ];
    return parts.filter(Boolean);
  }

  question(question, step) {
    const form = make("form", { className: "question" });
    form.dataset.key = "question";
    const group = make("fieldset", {}, make("legend", {}, ...runs(question.prompt)));
    form.append(group);
    question.choices.forEach(({ text, value }, index) => {
      const input = make("input", { type: "radio", name: "answer", value, checked: this.draft === value });
      input.dataset.key = `choice ${index}`;
      input.addEventListener("change", () => {
        this.draft = value;
        if (this.field) this.field.value = value;
      });
      group.append(make("label", { className: "choice" }, input, make("span", {}, ...runs(text))));
    });
    this.field = null;
    if (question.kind !== "choice") {
      const name = question.kind === "point" ? tr("two numbers: x, y") : tr("a number");
      this.field = make("input", { type: "text", inputMode: question.kind === "point" ? "text" : "decimal", value: this.draft, autocomplete: "off" });
      this.field.dataset.key = "answer";
      this.field.addEventListener("input", () => {
        this.draft = this.field.value;
        form.querySelectorAll("input[type=radio]").forEach((radio) => { radio.checked = radio.value === this.draft; });
      });
      group.append(make("label", { className: "typed" }, name, this.field));
    }
    const commit = make("button", { type: "submit", textContent: tr("Commit") });
    commit.dataset.key = "commit";
    group.append(make("p", { className: "buttons" },
      question.kind === "point" ? this.ringButton() : null, commit));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (this.draft.trim() === "") return announce(tr("Choose or write an answer first"));
      this.act("commit", this.draft);
    });
    if (question.problem) group.append(make("p", { className: "problem", textContent: question.problem }));
    if (question.said) {
      group.append(make("p", { className: question.right ? "right" : "wrong" },
        make("strong", { textContent: question.right ? `✓ ${tr("Right.")} ` : `✗ ${tr("Not yet.")} ` }),
        `${tr("Your answer: {1}", "")}`, ...runs(question.said), /[.!?…]$/.test(plain(question.said)) ? " " : ". ", ...runs(question.meaning)));
      if (step.rightAnswer) group.append(make("p", {}, `${tr("The answer: {1}", "")}`, ...runs(step.rightAnswer)));
    }
    return form;
  }

  ringButton() {
    const button = make("button", { type: "button", textContent: tr("Take the ring's place") });
    button.dataset.key = "ring";
    button.addEventListener("click", () => {
      this.draft = this.field.value = this.ring();
    });
    return button;
  }

  reveal(step) {
    return make("section", { className: "reveal" }, blocks(step.reveal),
      step.revealShown === undefined ? null
      : make("p", { className: "buttons" },
          this.button(step.revealShown ? tr("Back to my picture") : tr("Show it in the picture"), "reveal", "reveal")));
  }

  goal({ text, reached, praise }) {
    return make("section", { className: reached ? "goal reached" : "goal" },
      make("p", {}, make("strong", {}, reached ? "✓ " : "○ ", make("span", { className: "unseen", textContent: `${reached ? tr("Goal, reached:") : tr("Goal:")} ` }), ...runs(text))),
      reached && praise.length ? make("p", {}, ...runs(praise)) : null);
  }

  end() {
    return make("p", { className: "buttons" },
      this.button(tr("Export this as a plate"), "plate", "plate"),
      this.button(tr("Save my answers"), "answers", "answers", "text"),
      this.button(tr("… as JSON"), "answers json", "answers", "json"),
      this.button(tr("Begin again"), "again", "again"));
  }

  // The controls that the step opens, to be turned here as well as in the picture.
  controlsHome(ids) {
    this.ids = ids;
    this.fields.clear();
    this.panel = ids.length ? make("fieldset", { className: "open-controls" }, make("legend", { textContent: tr("Controls") })) : null;
    return this.panel;
  }

  // Those of ui/controls/controls.h, as they are now.
  showControls(controls = this.known) {
    this.known = controls;
    if (this.home.hidden || !this.panel || !controls) return;
    const all = new Map(controls.map((control) => [control.id, control]));
    for (const id of this.ids) {
      const control = all.get(id);
      if (!control) continue;
      if (!this.fields.has(id)) {
        const field = this.makeField(control);
        this.fields.set(id, field);
        this.panel.append(field.element);
      }
      this.fields.get(id).show(control);
    }
  }

  makeField(control) {
    const { id, label, kind, step, range } = control;
    const named = (element, part) => {
      element.dataset.key = `control ${id} ${part}`;
      return element;
    };
    if (kind === "command") {
      const element = make("button", { type: "button", textContent: label });
      element.addEventListener("click", () => this.set(id, ""));
      return { element: named(element, "box"), show: ({ locked }) => { element.disabled = Boolean(locked); } };
    }
    const box = named(makeInput(control), "box");
    if (kind === "number") stepByKeys(box, () => step);
    let slider = null, now = null;
    const write = (value) => {
      if (this.set(id, value)) return;
      announce(tr("{1} cannot be {2}", label, value));
      showValue(box, kind, now);
    };
    box.addEventListener("change", () => write(valueOf(box, kind)));
    if (kind === "number" && range) {
      slider = named(make("input", { type: "range", min: range[0], max: range[1], step, ariaLabel: label }), "slider");
      slider.addEventListener("input", () => write(slider.value));
    }
    const show = ({ value, locked }) => {
      box.disabled = Boolean(locked);
      if (slider) {
        slider.disabled = Boolean(locked);
        if (document.activeElement !== slider) slider.value = value;
      }
      // What somebody is typing is left alone.
      if (now === value && document.activeElement === box) return;
      now = value;
      showValue(box, kind, value);
    };
    const element = make("div", { className: "control" }, make("label", {}, `${label} `, box), slider);
    return { element, show };
  }
}
