// SPDX-License-Identifier: MIT
// The page's side of the workers: live pictures in one that stays, an export in one made for it.

function openWorker(start) {
  const address = new URL(`worker.mjs?build=${start.build}`, import.meta.url);
  const worker = new Worker(address, { type: "module" });
  worker.postMessage(start);
  return worker;
}

// A superseded picture is given up only when it has run for this long. Doubled each time until one
// gets through, so that something is always shown. With threads the worker hears that it should
// stop; without it must end, and a new one takes some time to start as well.
const patienceOf = ({ threads }) => (threads > 0 ? 60 : 400); // milliseconds
// What is expected to take longer may keep nobody waiting who wants a first coarse answer.
const long = 100; // milliseconds
const thumbnails = 5; // kThumbnails of ui/host/host.h

// One worker and what it does now.
class Slot {
  constructor(start, deliver) {
    Object.assign(this, { start, deliver, running: null, patience: patienceOf(start) });
  }

  run(request) {
    this.running = { ...request, since: performance.now() };
    if (!this.worker) {
      const worker = (this.worker = openWorker(this.start));
      worker.onmessage = ({ data }) => this.answered(data);
      worker.onerror = (event) => {
        event.preventDefault?.();
        this.answered({ message: event.message || "the worker stopped", broken: true });
      };
    }
    this.worker.postMessage({ task: "picture", ...request });
  }

  // What runs is superseded. `next` is called when there is room.
  overtake(isLong, next) {
    const patience = isLong && this.start.threads > 0 ? 0 : this.patience;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (!this.running) return;
      this.patience *= 2;
      if (this.start.threads > 0) {
        this.running.cancelled = true;
        return this.worker.postMessage({ cancel: this.running.id });
      }
      this.close();
      next();
    }, Math.max(0, this.running.since + patience - performance.now()));
  }

  close() {
    clearTimeout(this.timer);
    this.worker?.terminate();
    this.worker = null;
    this.running = null;
  }

  answered(answer) {
    const request = this.running;
    if (!request) return;
    clearTimeout(this.timer);
    this.running = null;
    if (!request.cancelled) this.patience = patienceOf(this.start);
    if (answer.broken) this.close();
    this.deliver(request, answer);
  }
}

// Without threads there are two workers, and pictures that take long are left to the second: the
// first always has a coarse answer soon.
export class Pictures {
  // `start` is the worker's first message, `deliver(request, answer)` takes what comes back.
  constructor(start, deliver) {
    this.waiting = new Map(); // view → its newest request
    this.rates = new Map(); // view → samples in a millisecond, of its last picture
    const arrived = (request, answer) => {
      if (answer.bytes && !answer.members) this.rates.set(request.view, costOf(request) / Math.max(1, answer.seconds * 1000));
      deliver(request, answer);
      this.next();
    };
    this.slots = Array.from({ length: start.threads > 0 ? 1 : 2 }, () => new Slot(start, arrived));
  }

  isLong(request) {
    return costOf(request) / (this.rates.get(request.view) ?? Infinity) > long;
  }

  request(request) {
    this.waiting.set(request.view, request);
    for (const slot of this.slots)
      if (slot.running?.view === request.view) slot.overtake(this.isLong(slot.running), () => this.next());
    this.next();
  }

  next() {
    // Views take turns: a map keeps the order in which its keys came. The gallery comes last.
    const inTurn = [...this.waiting].sort(([one], [other]) => (one === thumbnails) - (other === thumbnails));
    for (const [view, request] of inTurn) {
      // What is counted of an averaged map stays in one worker.
      const able = request.portion > 0 || this.isLong(request) ? this.slots.slice(-1) : this.slots;
      const free = able.find((slot) => !slot.running);
      if (!free) continue;
      this.waiting.delete(view);
      free.run(request);
    }
  }
}

const costOf = ({ width, height, samples }) => width * height * samples * samples;

export class Export {
  constructor(start, { onProgress, onEnd }) {
    Object.assign(this, { start, onProgress, onEnd });
  }

  // `copy`: the picture is for the clipboard.
  begin(document, name, copy = false) {
    this.cancel();
    const worker = (this.worker = openWorker(this.start));
    const end = (answer) => {
      if (this.worker !== worker) return;
      this.cancel();
      this.onEnd(name, answer, copy);
    };
    worker.onmessage = ({ data }) => {
      if (this.worker !== worker) return;
      if (data.progress !== undefined) this.onProgress(data.progress);
      else end(data);
    };
    worker.onerror = (event) => end({ message: event.message || "the worker stopped" });
    worker.postMessage({ task: "export", id: 0, document, name });
  }

  cancel() {
    this.worker?.terminate();
    this.worker = null;
  }
}
