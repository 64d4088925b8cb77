// SPDX-License-Identifier: MIT
// The page's side of the workers: what the studio asks for in one that stays, an export in one made for it.

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

function sendAsset(worker, { hash, name, bytes }) {
  worker.postMessage({ asset: hash, name, bytes }, [bytes.buffer]);
}

// One worker, what it does now, and the files it was sent.
class Slot {
  constructor(start, assetOf, deliver) {
    Object.assign(this, { start, assetOf, deliver, running: null, sent: new Set(), patience: patienceOf(start) });
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
    for (const hash of request.assets) if (!this.sent.has(hash)) this.send(hash);
    this.worker.postMessage({ task: "work", id: request.id, head: request.head, scene: request.scene });
  }

  // Whether the file is there to be sent.
  send(hash) {
    const asset = this.assetOf(hash);
    if (!asset) return false;
    sendAsset(this.worker, asset);
    this.sent.add(hash);
    return true;
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
    this.sent.clear();
  }

  // The worker let files go to have room for others: it gets them again, and the request once more.
  again(request, missing) {
    missing.forEach((hash) => this.sent.delete(hash));
    if (request.repeated || request.cancelled || missing.length === 0) return false;
    if (!missing.every((hash) => this.send(hash))) return false;
    this.run({ ...request, repeated: true });
    return true;
  }

  answered(answer) {
    const request = this.running;
    if (!request) return;
    if (answer.head) Object.assign(answer, JSON.parse(answer.head));
    clearTimeout(this.timer);
    this.running = null;
    if (this.again(request, answer.missing ?? [])) return;
    answer.seconds ??= (performance.now() - request.since) / 1000;
    if (!request.cancelled) this.patience = patienceOf(this.start);
    if (answer.broken) this.close();
    this.deliver(request, answer);
  }
}

// Without threads there are two workers, and what takes long is left to the second: the first always
// has a coarse answer soon.
export class Tasks {
  // `start` is the worker's first message, `assetOf(hash)` gives {hash, name, bytes} or null, and
  // `deliver(request, answer)` takes what comes back. Requests are heads of ui/host/work.h with `head`
  // and `scene` as texts.
  constructor(start, assetOf, deliver) {
    this.waiting = new Map(); // place → its newest request
    this.rates = new Map(); // place → samples in a millisecond, of its last answer
    const arrived = (request, answer) => {
      if (answer.bytes && !answer.members && !answer.recoloured) this.rates.set(request.place, request.cost / Math.max(1, answer.seconds * 1000));
      deliver(request, answer);
      this.next();
    };
    this.slots = Array.from({ length: start.threads > 0 ? 1 : 2 }, () => new Slot(start, assetOf, arrived));
  }

  isLong(request) {
    return request.cost / (this.rates.get(request.place) ?? Infinity) > long;
  }

  request(request) {
    this.waiting.set(request.place, request);
    for (const slot of this.slots)
      if (slot.running?.place === request.place) slot.overtake(this.isLong(slot.running), () => this.next());
    this.next();
  }

  next() {
    // Views take turns: a map keeps the order in which its keys came. Small pictures come last.
    const last = ({ kind }) => kind === "thumbnail";
    const inTurn = [...this.waiting].sort(([, one], [, other]) => last(one) - last(other));
    for (const [place, request] of inTurn) {
      // What is counted of an averaged map stays in one worker.
      const able = request.portion > 0 || this.isLong(request) ? this.slots.slice(-1) : this.slots;
      const free = able.find((slot) => !slot.running);
      if (!free) continue;
      this.waiting.delete(place);
      free.run(request);
    }
  }
}

export class Export {
  constructor(start, assetOf, { onProgress, onEnd }) {
    Object.assign(this, { start, assetOf, onProgress, onEnd });
  }

  // `copy`: the picture is for the clipboard. `assets`: the files that the document names, by hash.
  begin(document, name, copy, assets) {
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
      else end({ ...data, ...(data.head ? JSON.parse(data.head) : {}) });
    };
    worker.onerror = (event) => end({ message: event.message || "the worker stopped" });
    for (const asset of assets.map(this.assetOf)) if (asset) sendAsset(worker, asset);
    worker.postMessage({ task: "export", id: 0, document, name });
  }

  cancel() {
    this.worker?.terminate();
    this.worker = null;
  }
}
