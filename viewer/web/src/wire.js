// What the page's worker does: it owns the connection, so that a page that draws, lays out or thinks for seconds neither
// loses the hand nor lets messages pile up. Knows when to send and what may be dropped, not what messages mean.
import { addSample, SHORTEST } from "./hand.js";
import { BODIES, CHANNELS, encodeDevice, SNAPSHOT } from "./protocol.js";

export const TICK = 10; // [ms]
const REPEAT = 50; // the hand says at least so often that the page is there [ms]
const STUCK = 16384; // an old pose behind as much is worth nothing [bytes]
const RETRY = [300, 600, 1200, 2500]; // [ms]
const SILENT = 3000; // `state` comes once a second: nothing for this long, and the connection counts as lost [ms]
const SLEPT = 1500; // between two looks: the computer slept, what came meanwhile is still to be read [ms]
const UNREAD = 16; // messages that the page has been given and not yet taken; more wait here
const ROWS = 64; // batches of rows that wait for a page that is busy: a second

/// world   {connect(url): a WebSocket, post(message, transfer), now() [ms]}
export function makeWire(world) {
  return { world, url: null, socket: null, attempt: 0, retryAt: null, heard: 0, looked: world.now(), stopped: false, shift: 0,
    hand: { pending: [], last: null, sentAt: -Infinity }, unread: 0, waiting: [], posted: 0, told: 0, dropped: 0 };
}

const isOpen = (wire) => wire.socket?.readyState === 1;

/// A message of the page:
///   {open: url, shift [ms]: of the page's clock before the worker's}, {text}, {bytes}, {stop: true}
///   {hand: samples}   where the hand is; the last is said again until another comes or {letGo: true}
///   {taken: n}        so many messages of the program have been dealt with
export function take(wire, message) {
  const now = wire.world.now();
  if (message.open) {
    Object.assign(wire, { url: message.open, shift: message.shift });
    open(wire);
  } else if (message.hand) {
    for (const sample of message.hand) {
      addSample(wire.hand.pending, sample, wire.hand.last?.time);
    }
    sendHand(wire, now);
  } else if (message.letGo) {
    sendHand(wire, Infinity); // what opens the clutch waits for nothing
    Object.assign(wire.hand, { pending: [], last: null });
  } else if (message.taken) {
    wire.unread -= message.taken;
    pass(wire);
  } else if (message.stop) {
    wire.stopped = true;
    close(wire);
  } else if (isOpen(wire)) {
    sendHand(wire, Infinity); // in the order the page sent them
    wire.socket.send(message.bytes ?? message.text);
    if (message.bytes) wire.posted += message.bytes.byteLength;
    tellRoom(wire);
  }
}

/// Every TICK, by a timer that no work of the page delays.
export function tick(wire) {
  const now = wire.world.now();
  if (now - wire.looked > SLEPT) wire.heard = now;
  wire.looked = now;
  if (wire.retryAt !== null && now >= wire.retryAt) open(wire);
  if (isOpen(wire) && now - wire.heard > SILENT) lose(wire, "The program has stopped talking.");
  sendHand(wire, now);
  tellRoom(wire);
}

function open(wire) {
  const socket = wire.world.connect(wire.url);
  Object.assign(wire, { socket, retryAt: null, heard: wire.world.now() });
  socket.binaryType = "arraybuffer";
  socket.onopen = () => { if (socket === wire.socket) { wire.attempt = 0; wire.world.post({ opened: true }); } };
  socket.onmessage = (event) => { if (socket === wire.socket) hear(wire, event.data); };
  socket.onclose = (event) => { if (socket === wire.socket) lose(wire, closeSentence(event)); };
}

function close(wire) {
  const { socket } = wire;
  wire.socket = null;
  if (socket) {
    socket.onclose = socket.onmessage = socket.onopen = null;
    socket.close();
  }
  Object.assign(wire.hand, { pending: [], last: null });
  Object.assign(wire, { waiting: [], posted: 0, told: 0 });
}

function lose(wire, sentence) {
  close(wire);
  wire.world.post({ lost: sentence });
  if (!wire.stopped) wire.retryAt = wire.world.now() + RETRY[Math.min(wire.attempt++, RETRY.length - 1)];
}

/// Samples that wait, or the last one again with the time it had: the program knows by that how old it is.
function sendHand(wire, now) {
  const { hand, socket } = wire;
  const isNew = hand.pending.length > 0;
  if (!isOpen(wire) || (!isNew && (!hand.last || now === Infinity))) return;
  if (now - hand.sentAt < (isNew ? 1000 * SHORTEST : REPEAT) || socket.bufferedAmount > STUCK) return;
  const clock = wire.world.now();
  socket.send(encodeDevice(isNew ? hand.pending : [hand.last], (clock + wire.shift) / 1000));
  if (isNew) hand.last = hand.pending[hand.pending.length - 1];
  Object.assign(hand, { pending: [], sentAt: clock });
}

// ---- from the program to the page

const kindOf = (data) => (typeof data === "string" ? 0 : new Uint8Array(data, 0, Math.min(1, data.byteLength))[0]);

/// A page that is busy finds what it may not miss, the newest snapshot and bodies, and the rows of about a second.
function hear(wire, data) {
  wire.heard = wire.world.now();
  const kind = kindOf(data);
  const same = [SNAPSHOT, CHANNELS, BODIES].includes(kind) ? wire.waiting.filter((one) => one.kind === kind) : [];
  if (same.length >= (kind === CHANNELS ? ROWS : 1)) {
    wire.waiting.splice(wire.waiting.indexOf(same[0]), 1);
    wire.dropped += 1;
  }
  wire.waiting.push({ kind, data });
  pass(wire);
}

function pass(wire) {
  while (wire.waiting.length > 0 && wire.unread < UNREAD) {
    const { data } = wire.waiting.shift();
    wire.unread += 1;
    wire.world.post({ data }, typeof data === "string" ? [] : [data]);
  }
}

/// How many bytes of those the page has sent are on their way.
function tellRoom(wire) {
  const gone = wire.posted - Math.min(wire.posted, isOpen(wire) ? wire.socket.bufferedAmount : 0);
  if (gone === wire.told) return;
  wire.told = gone;
  wire.world.post({ gone });
}

function closeSentence({ code, reason }) {
  if (reason) return `The program closed the connection: ${reason}`;
  if (code === 1013) return "The program dropped this page because it was too slow to keep up.";
  if (code === 1000 || code === 1001) return "The program has ended.";
  return "The program does not answer; perhaps it has ended.";
}
