import assert from "node:assert/strict";
import { test } from "node:test";
import { decode, encodeDevice, encodeUpload, parseText, ProtocolError } from "../../src/protocol.js";
import { CHANNELS, encodeBodies, encodeChannels, encodeLevel, encodeMesh, encodeRelief, encodeSnapshot, readDevice } from "../mock/encode.mjs";

const bytes = (buffer) => buffer.buffer.slice(buffer.byteOffset, buffer.byteOffset + buffer.length);
const MESH = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], triangles: [0, 2, 1, 0, 1, 3], patchOfTriangle: [0, 0xffffffff],
  nodeOfPatch: [0, 1], parents: [2, 2, -1], levels: [0, 0, 1] };
const CONTACT = { point: [1, 2, 3], normal: [0, 0, -1], depth: 0.5, bound: 0.25, body: 2, objectNode: 7, sceneNode: 9, objectLevel: 3,
  sceneLevel: 4, status: 1, decidedBy: 2 };
const CLUSTER = { point: [4, 5, 6], normal: [1, 0, 0], depth: -0.5, force: [7, 8, 9], id: 11 };
const ROW = { point: [1, 2, 3], normal: [0, 1, 0], gap: 0.25, force: [4, 5, 6], friction: 0.5, kind: 2, presses: true };
const SNAPSHOT = { time: 1.5, bits: 3, frame: 1500, fields: Array.from({ length: 48 }, (_, k) => k), found: 40, dropped: 1, front: 77,
  fault: 1, contacts: [CONTACT], clusters: [CLUSTER], rows: [ROW, { ...ROW, kind: 1, presses: false }] };

test("a mesh comes through whole", () => {
  const mesh = decode(bytes(encodeMesh(5, MESH)));
  assert.equal(mesh.number, 5);
  for (const [name, values] of Object.entries(MESH)) assert.deepEqual([...mesh[name]], values, name);
});

test("a level comes through whole, and wrong ones are refused", () => {
  const LEVEL = { positions: MESH.positions, triangles: MESH.triangles, patchOfTriangle: MESH.patchOfTriangle, nodeOfPatch: [2, -1] };
  const level = decode(bytes(encodeLevel(5, 3, LEVEL)));
  assert.deepEqual([level.kind, level.number, level.level], ["level", 5, 3]);
  for (const [name, values] of Object.entries(LEVEL)) assert.deepEqual([...level[name]], values, name);
  assert.throws(() => decode(bytes(encodeLevel(5, 0, LEVEL))), /level 0/);
  for (const wrong of [{ triangles: [0, 2, 1, 0, 1, 4] }, { patchOfTriangle: [0, 2] }, { nodeOfPatch: [2, -2] }]) {
    assert.throws(() => decode(bytes(encodeLevel(5, 3, { ...LEVEL, ...wrong }))), ProtocolError);
  }
});

test("relief comes through whole, and wrong ones are refused", () => {
  const RELIEF = { positions: MESH.positions, triangles: MESH.triangles, patchOfTriangle: [1, 0], nodeOfPatch: [0, 1] };
  const relief = decode(bytes(encodeRelief(2, RELIEF)));
  assert.deepEqual([relief.kind, relief.number, relief.patches], ["relief", 2, 2]);
  for (const name of ["positions", "triangles", "patchOfTriangle"]) assert.deepEqual([...relief[name]], RELIEF[name], name);
  for (const wrong of [{ triangles: [0, 2, 1, 0, 1, 4] }, { patchOfTriangle: [0, 2] }, { positions: [...MESH.positions.slice(1), NaN] }]) {
    assert.throws(() => decode(bytes(encodeRelief(2, { ...RELIEF, ...wrong }))), ProtocolError);
  }
  const whole = bytes(encodeRelief(2, RELIEF));
  for (let n = 0; n < whole.byteLength; n += 4) assert.throws(() => decode(whole.slice(0, n)), ProtocolError, `${n} bytes`);
});

test("an upload says how many bytes it has", () => {
  const message = new Uint8Array(encodeUpload(Uint8Array.from([7, 8, 9])));
  assert.deepEqual([...message], [33, 1, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 8, 9]);
});

test("bodies come through whole, and damaged ones are refused", () => {
  const BODIES = { time: 1.5, frame: 1500, bodies: [{ position: [1, 2, 3], quaternion: [0, 0, 0, 1], asleep: true }, { position: [4, 5, 6], quaternion: [1, 0, 0, 0], asleep: false }],
    hands: [{ handle: { position: [7, 8, 9], quaternion: [0, 1, 0, 0] }, grasp: [10, 11, 12], force: [13, 14, 15], body: -1, page: false },
      { handle: { position: [7, 8, 9], quaternion: [0, 1, 0, 0] }, grasp: [1, 1, 1], force: [0, 0, -2], body: 1, page: true }] };
  assert.deepEqual(decode(bytes(encodeBodies(BODIES))), { kind: "bodies", ...BODIES });
  const whole = bytes(encodeBodies(BODIES));
  for (let n = 0; n < whole.byteLength; n += 4) assert.throws(() => decode(whole.slice(0, n)), ProtocolError, `${n} bytes`);
  const wrong = { ...BODIES, bodies: [{ position: [1, NaN, 3], quaternion: [0, 0, 0, 1], asleep: false }] };
  assert.throws(() => decode(bytes(encodeBodies(wrong))), /no number/);
});

test("a snapshot comes through field by field", () => {
  const s = decode(bytes(encodeSnapshot(SNAPSHOT)));
  assert.deepEqual([s.time, s.bits, s.frame, s.contactsFound, s.contactsDropped, s.front, s.fault], [1.5, 3, 1500, 40, 1, 77, 1]);
  assert.deepEqual(s.object, { position: [0, 1, 2], quaternion: [3, 4, 5, 6] });
  assert.deepEqual(s.ghost, { position: [7, 8, 9], quaternion: [10, 11, 12, 13] });
  assert.deepEqual(s.handle, { position: [14, 15, 16], quaternion: [17, 18, 19, 20] });
  assert.deepEqual([s.grasp, s.force, s.torque], [[21, 22, 23], [24, 25, 26], [27, 28, 29]]);
  assert.deepEqual([s.contactForce, s.contactTorque, s.center], [[30, 31, 32], [33, 34, 35], [36, 37, 38]]);
  assert.deepEqual([s.penetration, s.stretch, s.energy, s.modelAge, s.modelWeight, s.hapticRate, s.contactRate, s.queryCpu,
    s.metresPerNewton], [39, 40, 41, 42, 43, 44, 45, 46, 47]);
  assert.deepEqual(s.contacts, [CONTACT]);
  assert.deepEqual(s.clusters, [CLUSTER]);
  assert.deepEqual(s.rows, SNAPSHOT.rows);
});

test("channels come through row by row", () => {
  const rows = [0, 1].map((row) => CHANNELS.map((_, k) => 100 * row + k));
  const message = decode(bytes(encodeChannels(2.5, rows)));
  assert.deepEqual([message.columns, message.rows, message.time], [16, 2, 2.5]);
  assert.deepEqual([...message.values], rows.flat());
});

test("unknown numbers stay unknown", () => {
  const s = decode(bytes(encodeSnapshot({ ...SNAPSHOT, fields: SNAPSHOT.fields.map((value, k) => (k === 39 ? NaN : value)) })));
  assert.ok(Number.isNaN(s.penetration));
});

test("every other length is refused", () => {
  for (const whole of [encodeMesh(0, MESH), encodeLevel(0, 1, MESH), encodeSnapshot(SNAPSHOT), encodeChannels(0, [CHANNELS.map(() => 0)])]) {
    for (let length = 0; length < whole.length; length++) {
      assert.throws(() => decode(bytes(whole.subarray(0, length))), ProtocolError, `${length} of ${whole.length} bytes`);
    }
    assert.throws(() => decode(bytes(Buffer.concat([whole, Buffer.alloc(4)]))), ProtocolError);
  }
});

test("counts that promise more than memory are refused without allocating", () => {
  for (const at of [16, 20, 24, 28]) {
    const mesh = encodeMesh(0, MESH);
    mesh.writeUInt32LE(0xffffffff, at);
    assert.throws(() => decode(bytes(mesh)), ProtocolError);
  }
  for (const at of [216, 236]) {
    const snapshot = encodeSnapshot(SNAPSHOT);
    snapshot.writeUInt32LE(0xfffffff0, at);
    assert.throws(() => decode(bytes(snapshot)), ProtocolError);
  }
});

test("another type, another layout and poses that are no numbers are refused", () => {
  const change = (at, value) => { const b = encodeSnapshot(SNAPSHOT); b[at] = value; return bytes(b); };
  assert.throws(() => decode(change(0, 9)), /type 9/);
  assert.throws(() => decode(change(1, 2)), /layout 2/);
  const broken = encodeSnapshot({ ...SNAPSHOT, fields: SNAPSHOT.fields.map((value, k) => (k === 8 ? NaN : value)) });
  assert.throws(() => decode(bytes(broken)), /pose/);
});

test("a mesh that names what is not there is refused", () => {
  const wrong = { positions: [...MESH.positions.slice(0, 11), Infinity], triangles: [0, 2, 1, 0, 1, 4], patchOfTriangle: [0, 2], nodeOfPatch: [0, 3],
    parents: [2, 3, -1], levels: [0, 0, -1] };
  for (const [name, values] of Object.entries(wrong)) {
    assert.throws(() => decode(bytes(encodeMesh(0, { ...MESH, [name]: values }))), ProtocolError, name);
  }
});

test("samples of the hand are as the document says", () => {
  const samples = [0, 1].map((k) => ({ time: 10 + k, position: [0.5, -0.25, k], quaternion: [0, 0, 0, 1], buttons: k }));
  const buffer = encodeDevice(samples, 12);
  assert.equal(buffer.byteLength, 16 + 80);
  assert.equal(new DataView(buffer).getFloat64(8, true), 12);
  assert.deepEqual(readDevice(Buffer.from(buffer)), samples);
  assert.throws(() => encodeDevice([], 0), ProtocolError);
  assert.throws(() => encodeDevice(Array(65).fill(samples[0]), 0), ProtocolError);
});

test("text is an object with a type", () => {
  assert.deepEqual(parseText('{"type":"ack","id":1}'), { type: "ack", id: 1 });
  for (const text of ["", "{", "null", "3", "[]", '{"type":1}']) assert.throws(() => parseText(text), ProtocolError, text);
});
