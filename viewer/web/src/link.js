// The connection to the program: opened, watched, opened again. Knows messages, not what they mean to the page.
import { decode, parseText, ProtocolError, SUBPROTOCOL } from "./protocol.js";

const RETRY = [300, 600, 1200, 2500]; // [ms]
const SILENT = 3000; // `state` comes once a second: nothing for this long, and the connection counts as lost [ms]

/// on   {message(object), opened(), lost(sentence), retrying()}
export function makeLink(url, on) {
  const link = { url, on, socket: null, attempt: 0, nextId: 1, waiting: new Map(), heard: 0, watched: 0, received: 0, bytes: 0,
    timer: 0, stopped: false };
  setInterval(() => watch(link), 500);
  open(link);
  return link;
}

export const isOpen = (link) => link.socket?.readyState === WebSocket.OPEN;

function open(link) {
  const socket = new WebSocket(link.url, SUBPROTOCOL);
  link.socket = socket;
  link.heard = performance.now();
  socket.binaryType = "arraybuffer";
  socket.onopen = () => { link.attempt = 0; link.on.opened(); };
  socket.onmessage = (event) => { if (socket === link.socket) receive(link, event.data); };
  socket.onclose = (event) => { if (socket === link.socket) lose(link, closeSentence(event)); };
}

function receive(link, data) {
  link.heard = performance.now();
  link.received += 1;
  link.bytes += typeof data === "string" ? data.length : data.byteLength;
  let message = null;
  try {
    message = typeof data === "string" ? parseText(data) : decode(data);
  } catch (error) {
    if (!(error instanceof ProtocolError)) throw error;
    link.stopped = true; // the same program would say the same again
    lose(link, `The program says something this page does not understand: ${error.message}. Reload the page.`);
    return;
  }
  if (message.type === "ack") answer(link, message);
  link.on.message(message);
}

function answer(link, ack) {
  const waiting = link.waiting.get(ack.id);
  link.waiting.delete(ack.id);
  waiting?.(ack);
}

/// Sends a request; the promise gives its `ack`, with ok false when the connection goes.
export function ask(link, message) {
  if (!isOpen(link)) return Promise.resolve({ ok: false, reason: "The program is not connected." });
  const id = link.nextId;
  link.nextId = id === 0x7fffffff ? 1 : id + 1;
  link.socket.send(JSON.stringify({ ...message, id }));
  return new Promise((resolve) => link.waiting.set(id, resolve));
}

/// Sends bytes, unless earlier ones are still stuck: an old pose is worth nothing.
export function sendBytes(link, buffer) {
  if (!isOpen(link) || link.socket.bufferedAmount > 16384) return false;
  link.socket.send(buffer);
  return true;
}

/// Sends bytes that must not be lost; whether they went.
export function sendAll(link, buffer) {
  if (isOpen(link)) link.socket.send(buffer);
  return isOpen(link);
}
export const waitingBytes = (link) => link.socket?.bufferedAmount ?? 0;

function watch(link) {
  const now = performance.now();
  if (now - link.watched > 1500) link.heard = now; // this page slept; what came meanwhile is still to be read
  link.watched = now;
  if (isOpen(link) && now - link.heard > SILENT && !document.hidden) {
    lose(link, "The program has stopped talking.");
  }
}

function lose(link, sentence) {
  const socket = link.socket;
  link.socket = null;
  if (socket) {
    socket.onclose = socket.onmessage = socket.onopen = null;
    socket.close();
  }
  for (const resolve of link.waiting.values()) resolve({ ok: false, reason: "The connection was lost." });
  link.waiting.clear();
  link.on.lost(sentence);
  if (link.stopped) return;
  const wait = RETRY[Math.min(link.attempt++, RETRY.length - 1)];
  clearTimeout(link.timer);
  link.timer = setTimeout(() => { link.on.retrying(); open(link); }, wait);
}

function closeSentence({ code, reason }) {
  if (reason) return `The program closed the connection: ${reason}`;
  if (code === 1013) return "The program dropped this page because it was too slow to keep up.";
  if (code === 1000 || code === 1001) return "The program has ended.";
  return "The program does not answer; perhaps it has ended.";
}
