// The worker's side of the connection, with a made-up socket and clock.
import assert from "node:assert/strict";
import { test } from "node:test";
import { encodeDevice } from "../../src/protocol.js";
import { makeWire, take, TICK, tick } from "../../src/wire.js";

const sample = (time, x, buttons = 1) => ({ time, position: [x, 0, 0], quaternion: [0, 0, 0, 1], buttons });

/// A wire whose clock goes by run(ms), in ticks of the worker's timer.
function bench({ shift = 0 } = {}) {
  const it = { now: 1000, sockets: [], said: [] };
  it.wire = makeWire({ now: () => it.now, post: (message) => it.said.push(message), connect: (url) => {
    const socket = { url, readyState: 0, bufferedAmount: 0, sent: [], close() { this.readyState = 3; }, send(data) { this.sent.push({ at: it.now, data }); } };
    it.sockets.push(socket);
    return socket;
  } });
  it.take = (message) => take(it.wire, message);
  it.run = (ms) => { for (const end = it.now + ms; it.now < end;) { it.now += TICK; tick(it.wire); } };
  Object.defineProperty(it, "socket", { get: () => it.sockets[it.sockets.length - 1] });
  it.accept = () => { it.socket.readyState = 1; it.socket.onopen(); };
  it.take({ open: "ws://here/live", shift });
  it.accept();
  return it;
}

/// The samples of a message of the hand: [time, x, buttons].
function read(data) {
  const words = new DataView(data);
  return Array.from({ length: words.getUint32(4, true) }, (_, k) =>
    [words.getFloat64(16 + 40 * k, true), words.getFloat32(24 + 40 * k, true), words.getUint32(52 + 40 * k, true)]);
}

test("a page that stands still for seconds is said to be there, with the pose it had and the age of that", () => {
  const it = bench({ shift: 5000 });
  it.take({ hand: [sample(5.9, 0.25)] });
  it.now += 1;
  it.run(3000); // not a word of the page
  const { sent } = it.socket;
  assert.ok(sent.length > 3000 / 100, `${sent.length} messages`);
  for (let k = 1; k < sent.length; k++) assert.ok(sent[k].at - sent[k - 1].at <= 70, "never 0.1 s of silence");
  for (const { at, data } of sent) {
    assert.deepEqual(read(data), [[5.9, 0.25, 1]], "the same sample, no younger than it is");
    assert.equal(new DataView(data).getFloat64(8, true), (at + 5000) / 1000, "sent by the page's clock");
  }
});

test("the newest pose goes at once, and no more than 250 messages a second", () => {
  const it = bench();
  for (let k = 0; k < 1000; k++) {
    it.now += 1;
    it.take({ hand: [sample(1 + k / 1000, k)] });
    if (k % TICK === 0) tick(it.wire);
  }
  it.run(2 * TICK);
  const { sent } = it.socket;
  assert.equal(sent[0].at, 1001, "without waiting for the timer");
  assert.ok(sent.length <= 252 && sent.length > 150, `${sent.length}`);
  const samples = sent.flatMap(({ data }) => read(data));
  assert.equal(samples[samples.length - 1][1], 999, "the newest is never lost");
  for (let k = 1; k < samples.length; k++) assert.ok(samples[k][0] >= samples[k - 1][0], "oldest first");
});

test("a press between two messages is never swallowed", () => {
  const it = bench();
  it.take({ hand: [sample(1, 0, 0)] });
  it.take({ hand: [sample(1, 0, 1)] });
  it.take({ hand: [sample(1.001, 0, 0)] });
  it.run(2 * TICK);
  assert.deepEqual(it.socket.sent.flatMap(({ data }) => read(data)).map(([, , buttons]) => buttons), [0, 1, 0]);
});

test("a hand that has let go is silent, after its last word", () => {
  const it = bench();
  it.take({ hand: [sample(1, 0)] });
  it.take({ hand: [sample(1.001, 0, 0)] });
  it.take({ letGo: true });
  it.take({ text: "hold" });
  const before = it.socket.sent.map(({ data }) => (typeof data === "string" ? data : read(data)[0][2]));
  assert.deepEqual(before, [1, 0, "hold"], "in order");
  it.run(2000);
  assert.equal(it.socket.sent.length, 3);
});

test("an old pose is not put behind what is stuck", () => {
  const it = bench();
  it.socket.bufferedAmount = 20000;
  for (let k = 0; k < 200; k++) it.take({ hand: [sample(1 + k / 100, k)] });
  it.run(200);
  assert.equal(it.socket.sent.length, 0);
  it.socket.bufferedAmount = 0;
  it.run(TICK);
  const samples = read(it.socket.sent[0].data);
  assert.ok(samples.length <= 64 && samples[samples.length - 1][1] === 199);
});

const binary = (kind, mark = 0) => Uint8Array.from([kind, 1, mark, 0]).buffer;
const marks = (said) => said.filter(({ data }) => data !== undefined)
  .map(({ data }) => (typeof data === "string" ? data : [...new Uint8Array(data).slice(0, 3)].filter((_, k) => k !== 1).join(":")));

test("a page that takes nothing is not buried: the newest snapshot waits, rows of a second, and all else", () => {
  const it = bench();
  for (let k = 0; k < 200; k++) {
    it.socket.onmessage({ data: binary(2, k) });
    it.socket.onmessage({ data: binary(3, k) });
    if (k % 50 === 0) it.socket.onmessage({ data: `text ${k}` });
  }
  assert.equal(marks(it.said).length, 16, "no more than it can take");
  assert.ok(it.wire.waiting.length < 75, `${it.wire.waiting.length} wait`);
  while (it.wire.waiting.length > 0) it.take({ taken: 1 });
  const all = marks(it.said);
  assert.deepEqual(all.filter((one) => one.startsWith("text")), ["text 0", "text 50", "text 100", "text 150"]);
  assert.equal(all.filter((one) => one.startsWith("3:")).pop(), "3:199");
  assert.equal(all.filter((one) => one.startsWith("2:")).pop(), "2:199");
  assert.equal(it.wire.dropped + all.length, 404, "what is left out is counted");
});

test("a lost connection is said, tried again, and begins without a hand", () => {
  const it = bench();
  it.take({ hand: [sample(1, 0)] });
  it.socket.onclose({ code: 1006, reason: "" });
  assert.equal(it.said.pop().lost, "The program does not answer; perhaps it has ended.");
  it.run(250);
  assert.equal(it.sockets.length, 1);
  it.run(100);
  assert.equal(it.sockets.length, 2);
  it.accept();
  assert.deepEqual(it.said.pop(), { opened: true });
  it.run(500);
  assert.equal(it.socket.sent.length, 0, "who held it before has to take hold anew");
  it.take({ stop: true });
  it.run(5000);
  assert.equal(it.sockets.length, 2);
});

test("a program that falls silent is noticed, but not after the computer has slept", () => {
  const it = bench();
  it.now += 60000;
  tick(it.wire);
  assert.equal(it.socket.readyState, 1);
  it.run(2900);
  assert.equal(it.socket.readyState, 1);
  it.run(200);
  assert.equal(it.said.pop().lost, "The program has stopped talking.");
});

test("a page that sends a file knows how much is on its way", () => {
  const it = bench();
  it.socket.bufferedAmount = 300;
  it.take({ bytes: new ArrayBuffer(1000) });
  assert.deepEqual(it.said.pop(), { gone: 700 });
  it.socket.bufferedAmount = 0;
  it.run(TICK);
  assert.deepEqual(it.said.pop(), { gone: 1000 });
});

test("messages are what the protocol says", () => {
  const it = bench({ shift: 7 });
  it.take({ hand: [sample(0.5, 1), sample(0.75, 2)] });
  assert.deepEqual(Buffer.from(it.socket.sent[0].data), Buffer.from(encodeDevice([sample(0.5, 1), sample(0.75, 2)], 1.007)));
});
