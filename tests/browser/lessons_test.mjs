// SPDX-License-Identifier: MIT
// Every lesson from a fresh profile to its end, as learners of four kinds would: by the keyboard
// alone, by touch alone on a phone, through the accessibility tree alone, and by the mouse.
//   lessons_test.mjs ROOT [SCREENSHOTS]
// The lessons are dealt out to the four kinds and the two languages; with EVERY=1 in the environment
// each kind takes all of them in both.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, readdirSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { open, prepare, runOnPage, waitFor } from "./browser.mjs";

const [root, screenshots] = process.argv.slice(2);
const { browser } = await prepare(root);
const folder = mkdtempSync(join(tmpdir(), "versorium-lessons-"));
const every = Boolean(process.env.EVERY);

const only = process.env.LESSON;
const ids = readdirSync(join(root, "lessons")).filter((name) => name.endsWith(".en.md"))
  .map((name) => name.slice(0, -6)).sort().filter((id) => !only || id.startsWith(only));

// What a step asks and how it is solved, from the lesson's own file.
function sheetOf(id, language) {
  const steps = [];
  let fence = null;
  for (const line of readFileSync(join(root, "lessons", `${id}.${language}.md`), "utf8").split("\n")) {
    if (fence && line.startsWith("```")) fence = null;
    else if (line.startsWith("```")) steps.at(-1)[(fence = line.slice(3).trim())] ??= [];
    else if (fence) steps.at(-1)[fence].push(line.trim());
    else if (line.startsWith("## ")) steps.push({ title: line.slice(3) });
  }
  return steps;
}

const numbers = (text) => {
  const complex = text.replaceAll("−", "-").match(/^([+-]?[\d.]+)?\s*(?:([+-])?\s*([\d.]*)i)?$/);
  if (!text.includes(",") && complex)
    return [Number(complex[1] ?? 0), complex[0].includes("i") ? Number(`${complex[2] ?? ""}${complex[3] || 1}`) : 0];
  return text.split(",").map(Number);
};

// What to do, in order, for a solution's lines: pairs of a control's id and its value.
function settings(solution, open) {
  const wanted = [];
  let circles = -1, dropped = open.filter((id) => /^circles.*radius$/.test(id)).length;
  for (const line of (solution ?? []).filter(Boolean)) {
    const colon = line.indexOf(":");
    const key = line.slice(0, colon).trim(), value = line.slice(colon + 1).trim();
    const each = (ids) => numbers(value).forEach((number, k) => ids[k] && wanted.push([ids[k], String(number)]));
    if (open.includes(key)) wanted.push([key, value]);
    else if (key === "shape") wanted.push(["shape.source", value]);
    else if (key.endsWith("slice.center")) each(["slice.center[0]", "slice.center[1]"]);
    else if (key.endsWith("slice.height")) wanted.push(["slice.height", value]);
    else if (key.endsWith(".start")) wanted.push(["critical", "on"]);
    else if (key === "ensemble.count") wanted.push(["ensemble.count", value]);
    else if (key === "point") each(open.filter((id) => ["x", "y", "z.re", "z.im"].includes(id)));
    else if (key === "circle") {
      if (value === "none") continue;
      if (++circles >= dropped) wanted.push(["drop circle", ""]);
      const [x, y, radius] = value.split(",").map((part) => part.trim());
      const id = `circles[${circles}].`;
      wanted.push([id + "radius", radius], [id + "center[0]", x], [id + "center[1]", y]);
    } else if (key === "roots" || key === "poles") {
      value.split(";").forEach((root, k) => {
        const [re, im, power] = root.trim().split(/\s+/);
        const id = `${key}[${k}].`;
        if (!open.some((one) => one.startsWith(id)) && open.includes("add root")) wanted.push(["add root", key]);
        wanted.push([id + "re", re], [id + "im", im], [id + "power", power ?? "1"]);
      });
    } else {
      const parts = open.filter((id) => id.startsWith(key + "."));
      assert.ok(parts.length > 0, `how is "${line}" set by ${open}?`);
      each(parts);
    }
  }
  return wanted;
}

// Sets what the step offers of it: a root that is not offered stays where it is.
async function solve(page, way, solution) {
  const offered = async () => (await state(page)).step.controls;
  const reached = async () => (await state(page)).step.goal.reached;
  const open = await offered();
  // Chance is drawn until it is kind.
  for (let seed = 1; open.includes("draw roots") && seed < 20 && !(await reached()); ++seed) {
    await way.set(page, "random.seed", String(seed));
    await way.set(page, "draw roots", "");
    await page.waitForTimeout(600);
  }
  if (open.includes("draw roots")) return;
  for (const [id, value] of settings(solution, open)) {
    if (!(await offered()).includes(id)) continue;
    if (await page.evaluate(([id, value]) =>
      JSON.parse(window.versorium.controls()).controls.find((one) => one.id === id).value === value, [id, value])) continue;
    await waitFor(page, (id) => document.querySelector(`#lesson [data-key="control ${id} box"]`), id);
    // Whoever sees that it was not taken tries again.
    for (let k = 0; k < 3; ++k) {
      await way.set(page, id, value);
      await page.waitForTimeout(350);
      if (await page.evaluate(([id, value]) => {
        const one = JSON.parse(window.versorium.controls()).controls.find((one) => one.id === id);
        return !one || one.kind === "command" || one.kind === "choice" || one.kind === "toggle" ||
          one.value === value || Number(one.value) === Number(value);
      }, [id, value])) break;
    }
  }
}

const state = (page) => page.evaluate(() => JSON.parse(window.versorium.lesson()));
const rightChoice = (ask) => ask.filter((line) => /^[-+] /.test(line)).findIndex((line) => line[0] === "+");
const typedAnswer = (ask) => ask.find((line) => line.startsWith("answer:")).slice(7).trim();
const controlName = (page, id) => page.evaluate(
  (id) => JSON.parse(window.versorium.controls()).controls.find((control) => control.id === id).label, id);

const shownOption = (page, id, value) => page.evaluate(([id, value]) => {
  const { options, shown } = JSON.parse(window.versorium.controls()).controls.find((one) => one.id === id);
  return shown?.[options.indexOf(value)] ?? value;
}, [id, value]);

// Four ways to do the same few things.
const byKeyboard = {
  async focus(page, key) {
    for (let k = 0; k < 200; ++k) {
      // The way to go: onwards, or back with Shift.
      const way = await page.evaluate((key) => {
        const active = document.activeElement, target = document.querySelector(`#lesson [data-key="${key}"]`);
        if (active === target) return "";
        return target && active.compareDocumentPosition(target) & Node.DOCUMENT_POSITION_PRECEDING ? "Shift+Tab" : "Tab";
      }, key);
      if (way === "") return;
      await page.keyboard.press(way);
    }
    throw new Error(`Tab never comes to "${key}"`);
  },
  async press(page, key) {
    await this.focus(page, key);
    await page.keyboard.press("Enter");
  },
  async choose(page, index) {
    // A group of radio buttons is one stop of Tab; arrows walk within it.
    await page.evaluate(() => document.querySelector('#lesson h2')?.focus());
    for (let k = 0; k < 600; ++k) {
      const at = await page.evaluate(() => document.activeElement?.dataset?.key ?? "");
      if (at.startsWith("choice ")) break;
      await page.keyboard.press("Tab");
    }
    await page.keyboard.press("Space");
    for (let k = 0; k < 12; ++k) {
      const at = await page.evaluate(() => document.activeElement?.dataset?.key ?? "");
      if (at === `choice ${index}`) return;
      await page.keyboard.press("ArrowDown");
    }
    throw new Error(`there is no choice ${index}`);
  },
  async write(page, key, text) {
    await this.focus(page, key);
    await page.keyboard.press("Control+a");
    await page.keyboard.type(text);
    await page.keyboard.press("Tab");
  },
  async set(page, id, value) {
    await this.focus(page, `control ${id} box`);
    const kind = await page.evaluate(() => document.activeElement.type);
    if (kind === "checkbox") return page.keyboard.press("Space");
    if (kind === "submit" || kind === "button") return page.keyboard.press("Enter");
    if (kind === "select-one") return page.keyboard.type(await shownOption(page, id, value));
    await this.write(page, `control ${id} box`, value);
  },
};

// With a finger ("tap") or the mouse ("click").
const byPointer = (hit) => ({
  at: (page, key) => page.locator(`#lesson [data-key="${key}"]`),
  async press(page, key) {
    await this.at(page, key)[hit]();
  },
  async choose(page, index) {
    await this.at(page, `choice ${index}`)[hit]();
  },
  async write(page, key, text) {
    await this.at(page, key)[hit]();
    await page.keyboard.press("Control+a");
    await page.keyboard.type(text);
    await this.at(page, key).blur();
  },
  async set(page, id, value) {
    const key = `control ${id} box`;
    const kind = await this.at(page, key).evaluate((element) => element.type);
    if (kind === "checkbox" || kind === "button") return this.press(page, key);
    if (kind === "select-one") return this.at(page, key).selectOption(value);
    await this.write(page, key, value);
  },
});

// Roles and names, and nothing else.
const labels = {
  en: { commit: "Commit", next: "Next →", answer: /number/, steps: /Steps/ },
  es: { commit: "Responder", next: "Siguiente →", answer: /número/, steps: /Pasos/ },
};
const byTree = (language) => ({
  pane: (page) => page.getByRole("article"),
  async press(page, key) {
    await this.pane(page).getByRole("button", { name: labels[language][key], exact: true }).press("Enter");
  },
  async choose(page, index) {
    await this.pane(page).getByRole("radio").nth(index).check();
  },
  async write(page, key, text) {
    await this.pane(page).getByRole("textbox", { name: labels[language].answer }).fill(text);
  },
  async set(page, id, value) {
    const name = await controlName(page, id);
    const pane = this.pane(page);
    const box = pane.getByRole("spinbutton", { name, exact: true });
    if (await box.count()) {
      await box.fill(value);
      return box.press("Tab");
    }
    const toggle = pane.getByRole("checkbox", { name, exact: true });
    if (await toggle.count()) return toggle.check();
    const button = pane.getByRole("button", { name, exact: true });
    if (await button.count()) return button.press("Enter");
    const choice = pane.getByRole("combobox", { name, exact: true });
    if (await choice.count()) return choice.selectOption(value);
    const text = pane.getByRole("textbox", { name, exact: true });
    await text.fill(value);
    await text.press("Tab");
  },
});

async function complete(page, id, language, way) {
  const sheet = sheetOf(id, language);
  for (let k = 0; k < sheet.length; ++k) {
    const where = `${id}.${language}, step ${k + 1}`;
    await waitFor(page, (k) => JSON.parse(window.versorium.lesson()).lesson?.at === k, k);
    // The pane follows the program within a moment.
    await waitFor(page, (title) => document.querySelector("#lesson h2")?.innerText.length > 0, "");
    const { step } = await state(page);
    if (sheet[k].ask) {
      const ask = sheet[k].ask;
      if (ask[0].startsWith("choice")) await way.choose(page, rightChoice(ask));
      else await way.write(page, "answer", typedAnswer(ask));
      await way.press(page, "commit");
      await waitFor(page, () => JSON.parse(window.versorium.lesson()).step.question.right === true)
        .catch(() => assert.fail(`${where}: the answer is not taken as right`));
    }
    if (sheet[k].goal) {
      assert.ok(step.controls.length > 0, `${where}: a goal without controls of its own`);
      await solve(page, way, sheet[k].solution);
      await waitFor(page, () => JSON.parse(window.versorium.lesson()).step.goal.reached)
        .catch(() => assert.fail(`${where}: the goal is not reached`));
    }
    if (screenshots && k === 1)
      await page.screenshot({ path: join(screenshots, `lesson-${id}-${language}-${page.viewportSize().width}.png`) });
    if (k + 1 < sheet.length) await way.press(page, "next");
  }
  const { lesson } = await state(page);
  assert.deepEqual(lesson.steps.filter(({ done }) => !done), [], `${id}.${language}`);
}

async function lessonPage(browser, address, id, language, options) {
  const page = await open(browser, `${address}#lesson=${id}&language=${language}`, options);
  await waitFor(page, () => JSON.parse(window.versorium.lesson()).lesson);
  const { lesson } = await state(page);
  assert.equal(lesson.language, language);
  assert.equal(lesson.at, 0);
  return page;
}

const wide = { viewport: { width: 1366, height: 640 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

async function pass(browser, address, kind, way, options, after = () => {}) {
  for (const [index, id] of ids.entries()) {
    if (!every && index % 4 !== kind) continue;
    for (const language of every ? ["en", "es"] : [index % 2 ? "en" : "es"]) {
      const page = await lessonPage(browser, address, id, language, options);
      await after(page);
      await complete(page, id, language, way(language));
      assert.deepEqual(page.faults, []);
      await page.context().close();
    }
  }
}

const tests = {
  async "by the keyboard alone"(browser, address) {
    await pass(browser, address, 0, () => byKeyboard, wide);
  },

  async "by touch alone, on a phone"(browser, address) {
    await pass(browser, address, 1, () => byPointer("tap"), phone);
  },

  async "through the accessibility tree alone, offline"(browser, address) {
    await pass(browser, address, 2, byTree, wide,
      (page) => page.context().setOffline(true));
  },

  async "by the mouse"(browser, address) {
    await pass(browser, address, 3, () => byPointer("click"), wide);
  },

  async "a teacher's link in another page locks, keeps the wheel apart and resets to the teacher's state"(browser, address) {
    // Another port is another origin.
    const host = createServer((_, answer) => {
      answer.setHeader("Content-Type", "text/html");
      answer.end(`<!doctype html><body style="margin:0;height:3000px">
        <iframe id="frame" width="1000" height="600" style="border:0;margin-top:40px"
          src="${address}#lesson=1-orbits&rest=hidden&open=r&theme=light"></iframe></body>`);
    });
    await new Promise((done) => host.listen(0, done));
    const context = await browser.newContext({ viewport: { width: 1100, height: 700 } });
    const page = await context.newPage();
    await page.goto(`http://localhost:${host.address().port}/`);
    const frame = await (await page.waitForSelector("#frame")).contentFrame();
    await waitFor(frame, () => window.versorium && JSON.parse(window.versorium.lesson()).lesson);
    const value = (id) => frame.evaluate(
      (id) => JSON.parse(window.versorium.controls()).controls.find((one) => one.id === id)?.value, id);
    const teachers = await value("r");
    assert.equal(await value("iterations"), undefined, "hidden controls are not there");
    assert.equal(await frame.evaluate(() => window.versorium.set("iterations", "3")), false);
    await page.mouse.move(600, 300);
    await page.mouse.wheel(0, 200);
    await waitFor(page, () => window.scrollY > 100);
    await page.evaluate(() => window.scrollTo(0, 0));
    // The lesson's text scrolls by itself, and it alone.
    assert.equal(await frame.evaluate(() => window.versorium.set("r", "3.1")), true);
    await waitFor(frame, () => JSON.parse(window.versorium.controls()).controls.find(({ id }) => id === "r").value === "3.1");
    await frame.locator('#lesson [data-key="reset"]').click();
    await waitFor(frame, (is) => JSON.parse(window.versorium.controls()).controls.find(({ id }) => id === "r").value === is, teachers);
    assert.equal(await frame.locator('#lesson [data-key="all"]').count(), 0, "a locked lesson is not left");
    if (screenshots) await page.screenshot({ path: join(screenshots, "teachers-link.png") });
    await context.close();
    host.close();
  },

  async "what was done is kept, and can be handed in"(browser, address) {
    const page = await lessonPage(browser, address, ids[0], "en", wide);
    const asking = sheetOf(ids[0], "en").findIndex(({ ask }) => ask);
    await page.evaluate((k) => window.versorium.lessonDo("step", String(k)), asking);
    await waitFor(page, () => document.querySelector('#lesson [data-key="commit"]'));
    await answerAnything(page, "999999");
    await waitFor(page, () => document.querySelector("#lesson .wrong"));
    assert.equal((await state(page)).step.hints.length > 0, true, "a wrong answer brings a hint");
    await page.reload();
    await waitFor(page, () => window.versorium && JSON.parse(window.versorium.lesson()).step?.question?.answer);
    const last = sheetOf(ids[0], "en").length - 1;
    await page.evaluate((k) => window.versorium.lessonDo("step", String(k)), last);
    await waitFor(page, () => document.querySelector('#lesson [data-key="answers json"]'));
    const [download] = await Promise.all([
      page.waitForEvent("download"), page.click('#lesson [data-key="answers json"]'),
    ]);
    const handed = JSON.parse(readFileSync(await download.path(), "utf8"));
    assert.equal(handed.lesson, ids[0]);
    assert.equal(handed.steps[asking].attempts, 1);
    assert.equal(handed.steps[asking].right, false);
    const [plate] = await Promise.all([
      page.waitForEvent("download"), page.click('#lesson [data-key="plate"]'),
    ]);
    assert.equal(readFileSync(await plate.path()).subarray(1, 4).toString(), "PNG");
    await page.context().close();
  },
};

async function answerAnything(page, answer) {
  const field = page.locator('#lesson [data-key="answer"]');
  if (await field.count()) await field.fill(answer);
  else await page.locator('#lesson [data-key="choice 0"]').check();
  await page.click('#lesson [data-key="commit"]');
}

await runOnPage(tests, root, browser, folder);
