// SPDX-License-Identifier: MIT
// A film of an animation's pictures, by the browser's own recorder. It records what is played, at the
// speed at which it is played.

const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

const kind = () =>
  typeof MediaRecorder === "undefined" || !HTMLCanvasElement.prototype.captureStream
    ? undefined
    : kinds.find((name) => MediaRecorder.isTypeSupported(name));

export const makesFilms = () => kind() !== undefined;

// The files of an archive whose files are stored as they are: those of io/zip.h.
export function filesOf(archive) {
  const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);
  const files = new Map();
  for (let at = 0; at + 30 <= archive.length && view.getUint32(at, true) === 0x04034b50;) {
    const size = view.getUint32(at + 18, true);
    const nameLength = view.getUint16(at + 26, true);
    const begin = at + 30 + nameLength + view.getUint16(at + 28, true);
    const name = new TextDecoder().decode(archive.subarray(at + 30, at + 30 + nameLength));
    files.set(name, archive.subarray(begin, begin + size));
    at = begin + size;
  }
  return files;
}

const pause = (milliseconds) => new Promise((done) => setTimeout(done, Math.max(0, milliseconds)));

// The film's bytes; undefined once `isWanted` says no. `onProgress` hears from 0 to 1.
export async function filmOf(archive, isWanted, onProgress) {
  const files = filesOf(archive);
  const text = new TextDecoder().decode(files.get("animation.json"));
  const { frames_per_second: rate } = JSON.parse(text).body;
  const frames = [...files].filter(([name]) => name.endsWith(".png"));
  const bitmapOf = ([, bytes]) => createImageBitmap(new Blob([bytes], { type: "image/png" }));
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d", { alpha: false });
  let next = await bitmapOf(frames[0]);
  canvas.width = next.width;
  canvas.height = next.height;
  const stream = canvas.captureStream(0);
  const [track] = stream.getVideoTracks();
  const bits = Math.min(5e7, Math.max(1e6, 0.2 * canvas.width * canvas.height * rate));
  const recorder = new MediaRecorder(stream, { mimeType: kind(), videoBitsPerSecond: bits });
  const parts = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const ended = new Promise((done, failed) => {
    recorder.onstop = done;
    recorder.onerror = ({ error }) => failed(error);
  });
  recorder.start();
  const begin = performance.now();
  for (let k = 0; k < frames.length && isWanted(); ++k) {
    context.drawImage(next, 0, 0);
    track.requestFrame();
    next.close();
    if (k + 1 < frames.length) next = await bitmapOf(frames[k + 1]);
    onProgress((k + 1) / frames.length);
    await pause(begin + (1000 * (k + 1)) / rate - performance.now());
  }
  // The last picture lasts as long as the others.
  context.drawImage(canvas, 0, 0);
  track.requestFrame();
  recorder.stop();
  await ended;
  track.stop();
  if (!isWanted()) return undefined;
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
