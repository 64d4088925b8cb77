// SPDX-License-Identifier: MIT
// The page's side of the workers: live pictures in one that stays, an export in one made for it.

function openWorker(start) {
  const worker = new Worker(new URL("worker.mjs", import.meta.url), { type: "module" });
  worker.postMessage(start);
  return worker;
}

// A superseded picture is given up only when it has run for this long. Doubled each time until one
// gets through, so that something is always shown. With threads the worker hears that it should
// stop; without it must end, and a new one takes some time to start as well.
const patienceOf = ({ threads }) => (threads > 0 ? 60 : 400); // milliseconds

export class Pictures {
  // `start` is the worker's first message, `deliver(request, answer)` takes what comes back.
  constructor(start, deliver) {
    this.start = start;
    this.deliver = deliver;
    this.waiting = new Map(); // view → its newest request
    this.running = null;
    this.patience = patienceOf(this.start);
  }

  request(request) {
    this.waiting.set(request.view, request);
    if (this.running?.view === request.view) this.overtake();
    else this.next();
  }

  overtake() {
    const late = this.running.since + this.patience - performance.now();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (!this.running || !this.waiting.has(this.running.view)) return;
      this.patience *= 2;
      if (this.start.threads > 0) {
        this.running.cancelled = true;
        return this.worker.postMessage({ cancel: this.running.id });
      }
      this.close();
      this.next();
    }, Math.max(0, late));
  }

  close() {
    clearTimeout(this.timer);
    this.worker?.terminate();
    this.worker = null;
    this.running = null;
  }

  next() {
    if (this.running || this.waiting.size === 0) return;
    // Views take turns: a map keeps the order in which its keys came.
    const [view, request] = this.waiting.entries().next().value;
    this.waiting.delete(view);
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

  answered(answer) {
    const request = this.running;
    if (!request) return;
    this.running = null;
    if (!request.cancelled) this.patience = patienceOf(this.start);
    clearTimeout(this.timer);
    if (answer.broken) this.close();
    this.deliver(request, answer);
    this.next();
  }
}

export class Export {
  constructor(start, { onProgress, onEnd }) {
    Object.assign(this, { start, onProgress, onEnd });
  }

  begin(document, name) {
    this.cancel();
    const worker = (this.worker = openWorker(this.start));
    const end = (answer) => {
      if (this.worker !== worker) return;
      this.cancel();
      this.onEnd(name, answer);
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
