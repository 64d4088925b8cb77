// SPDX-License-Identifier: MIT
// What the page itself says, in the language of the studio: English stands where it is said, the
// rest is the program's (core/i18n). Until that runs, these few.
const early = {
  es: {
    "Loading …": "Cargando …",
    "Starting …": "Iniciando …",
    "{1} of {2} kB": "{1} de {2} kB",
    "{1}: the server answers {2}": "{1}: el servidor responde {2}",
    "Versorium did not start: {1}": "Versorium no pudo iniciarse: {1}",
    "Versorium studio: pictures of dynamical systems, with their controls":
      "Estudio Versorium: imágenes de sistemas dinámicos, con sus controles",
  },
};

let program = (english) => early[document.documentElement.lang]?.[english] ?? english;

// Places {1}, {2} … of a sentence take the values.
export function tr(english, ...values) {
  return program(english).replace(/\{([1-9])\}/g, (place, number) => String(values[number - 1] ?? place));
}

// From now on the program says everything.
export function sayBy(translate) {
  program = translate;
}

// The language that was chosen last, or the browser's.
export function firstLanguage() {
  let chosen = "";
  try {
    chosen = localStorage.getItem("versorium.language") ?? "";
  } catch {
    // Forbidden: nothing is kept.
  }
  const id = chosen || navigator.language?.split("-")[0];
  return id in early ? id : "en";
}

// The texts of index.html, and the language that screen readers speak.
export function speak(language) {
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll("[data-text]")) element.textContent = tr(element.dataset.text);
  for (const element of document.querySelectorAll("[data-label]"))
    element.setAttribute("aria-label", tr(element.dataset.label));
}
