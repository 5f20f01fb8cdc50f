// The page's end of the connection, which a worker holds (wire.js): messages as objects, requests and their answers.
import { decode, parseText, ProtocolError } from "./protocol.js";

/// on   {message(object), opened(), lost(sentence)}
export function makeLink(url, on) {
  const link = { url, on, worker: new Worker("worker.js"), isOpen: false, attempt: 0, nextId: 1, asked: new Map(), received: 0, bytes: 0,
    posted: 0, gone: 0, stopped: false };
  link.worker.onmessage = ({ data }) => hear(link, data);
  link.worker.onerror = () => stop(link, "The page could not start its worker. Reload the page.");
  link.worker.postMessage({ open: url, origin: performance.timeOrigin });
  return link;
}

function hear(link, message) {
  if (link.stopped) return;
  if (message.data !== undefined) {
    try {
      receive(link, message.data);
    } finally {
      link.worker.postMessage({ taken: 1 });
    }
  } else if (message.opened) {
    Object.assign(link, { isOpen: true, attempt: 0 });
    link.on.opened();
  } else if (message.lost) {
    lose(link, message.lost);
  } else if (message.gone !== undefined) {
    link.gone = message.gone;
  }
}

function receive(link, data) {
  if (!link.isOpen) return; // of a connection that is gone
  link.received += 1;
  link.bytes += typeof data === "string" ? data.length : data.byteLength;
  let message = null;
  try {
    message = typeof data === "string" ? parseText(data) : decode(data);
  } catch (error) {
    if (!(error instanceof ProtocolError)) throw error;
    // The same program would say the same again.
    stop(link, `The program says something this page does not understand: ${error.message}. Reload the page.`);
    return;
  }
  if (message.type === "ack") answer(link, message);
  link.on.message(message);
}

function answer(link, ack) {
  const asked = link.asked.get(ack.id);
  link.asked.delete(ack.id);
  asked?.(ack);
}

/// Sends a request; the promise gives its `ack`, with ok false when the connection goes.
export function ask(link, message) {
  if (!link.isOpen) return Promise.resolve({ ok: false, reason: "The program is not connected." });
  const id = link.nextId;
  link.nextId = id === 0x7fffffff ? 1 : id + 1;
  link.worker.postMessage({ text: JSON.stringify({ ...message, id }) });
  return new Promise((resolve) => link.asked.set(id, resolve));
}

/// Samples of the hand, oldest first; the worker says the last again until letGo.
export function sendHand(link, samples) {
  if (link.isOpen && samples.length > 0) link.worker.postMessage({ hand: samples });
}
export const letGo = (link) => link?.worker.postMessage({ letGo: true });

/// Sends bytes that must not be lost; whether they went.
export function sendAll(link, buffer) {
  if (!link.isOpen) return false;
  link.posted += buffer.byteLength;
  link.worker.postMessage({ bytes: buffer }, [buffer]);
  return true;
}
export const waitingBytes = (link) => Math.max(0, link.posted - link.gone);

function stop(link, sentence) {
  link.stopped = true;
  link.worker.postMessage({ stop: true });
  lose(link, sentence);
}

function lose(link, sentence) {
  Object.assign(link, { isOpen: false, posted: 0, gone: 0, attempt: link.attempt + 1 });
  for (const resolve of link.asked.values()) resolve({ ok: false, reason: "The connection was lost." });
  link.asked.clear();
  link.on.lost(sentence);
}
