// What goes over the wire, docs/protocol.md version 1: bytes to plain objects and back. Strict: what does not have
// exactly the length its header asks for, or names things that are not there, is a ProtocolError.

export const SUBPROTOCOL = "thigma.live.1";
export const VERSION = 1;
export const MESH = 1, CHANNELS = 2, SNAPSHOT = 3, LEVEL = 4, RELIEF = 5, BODIES = 6, DEVICE = 32, UPLOAD = 33;
export const NOTHING = 0xffffffff;
export const CLUTCH = 1;
export const STATE = { grasped: 1, armed: 2, fault: 4, paused: 8, ended: 16, fading: 32, heldBack: 64, squeezed: 128, constrained: 256 };
export const STATUS = ["apart", "inside", "deep inside", "side by side"];
export const MAX_SAMPLES = 64;
export const ROW_KINDS = ["a corner of the object, a face", "a face of the object, a corner", "two edges"];
const HEADER = 16, FIELDS = 48, CONTACT = 48, SAMPLE = 40, BODY = 32, HAND = 64;

export class ProtocolError extends Error {}

const must = (holds, sentence) => { if (!holds) throw new ProtocolError(sentence); };

/// buffer   one binary frame
/// returns  {kind: "mesh" | "level" | "relief" | "channels" | "snapshot" | "bodies", ...}
/// errors   ProtocolError
export function decode(buffer) {
  must(buffer.byteLength >= HEADER, `a message of ${buffer.byteLength} bytes has no header`);
  const words = new DataView(buffer);
  const type = words.getUint8(0), version = words.getUint8(1);
  const head = { bits: words.getUint16(2, true), count: words.getUint32(4, true), time: words.getFloat64(8, true) };
  const decoders = { [MESH]: decodeMesh, [CHANNELS]: decodeChannels, [SNAPSHOT]: decodeSnapshot, [LEVEL]: decodeLevel, [RELIEF]: decodeRelief, [BODIES]: decodeBodies };
  must(decoders[type], `message type ${type} is not known`);
  must(version === 1, `layout ${version} of message type ${type} is not known`);
  return decoders[type](buffer, words, head);
}

function exactly(buffer, bytes, what) {
  must(buffer.byteLength === bytes, `${what} of ${buffer.byteLength} bytes, ${bytes} expected`);
}

/// Takes arrays of 4-byte numbers from where a message's head ends.
function taker(buffer, begin) {
  let at = begin;
  return (Kind, n) => {
    const part = new Kind(buffer, at, n);
    at += 4 * n;
    return part;
  };
}

function checkSurface({ positions, triangles, patchOfTriangle }, V, P, what) {
  must(positions.every(Number.isFinite), `${what} with a position that is no number`);
  must(triangles.every((v) => v < V), `${what} with a triangle of a vertex that is not there`);
  must(patchOfTriangle.every((p) => p < P || p === NOTHING), `${what} with a triangle of a patch that is not there`);
}

function decodeMesh(buffer, words, { count: number }) {
  must(buffer.byteLength >= 32, `mesh of ${buffer.byteLength} bytes, 32 at least`);
  const [V, T, P, N] = [16, 20, 24, 28].map((at) => words.getUint32(at, true));
  exactly(buffer, 32 + 12 * V + 16 * T + 4 * P + 8 * N, "mesh");
  const take = taker(buffer, 32);
  const mesh = { kind: "mesh", number, positions: take(Float32Array, 3 * V), triangles: take(Uint32Array, 3 * T),
    patchOfTriangle: take(Uint32Array, T), nodeOfPatch: take(Int32Array, P), parents: take(Int32Array, N),
    levels: take(Int32Array, N) };
  checkSurface(mesh, V, P, "mesh");
  must(mesh.nodeOfPatch.every((n) => n >= 0 && n < N), "mesh with a patch of a node that is not there");
  must(mesh.parents.every((n) => n >= -1 && n < N), "mesh with a parent that is not there");
  must(mesh.levels.every((level) => level >= 0), "mesh with a negative level");
  return mesh;
}

function decodeLevel(buffer, words, { bits: level, count: number }) {
  must(buffer.byteLength >= 32, `level of ${buffer.byteLength} bytes, 32 at least`);
  const [V, T, P] = [16, 20, 24].map((at) => words.getUint32(at, true));
  exactly(buffer, 32 + 12 * V + 16 * T + 4 * P, "level");
  const take = taker(buffer, 32);
  const mesh = { kind: "level", number, level, positions: take(Float32Array, 3 * V), triangles: take(Uint32Array, 3 * T),
    patchOfTriangle: take(Uint32Array, T), nodeOfPatch: take(Int32Array, P) };
  must(level > 0, "level 0 comes as a mesh");
  checkSurface(mesh, V, P, "level");
  must(mesh.nodeOfPatch.every((n) => n >= -1), "level with a patch of no node that could be");
  return mesh;
}

function decodeRelief(buffer, words, { count: number }) {
  must(buffer.byteLength >= 32, `relief of ${buffer.byteLength} bytes, 32 at least`);
  const [V, T, P] = [16, 20, 24].map((at) => words.getUint32(at, true));
  exactly(buffer, 32 + 12 * V + 16 * T, "relief");
  const take = taker(buffer, 32);
  const mesh = { kind: "relief", number, patches: P, positions: take(Float32Array, 3 * V), triangles: take(Uint32Array, 3 * T),
    patchOfTriangle: take(Uint32Array, T) };
  checkSurface(mesh, V, P, "relief");
  return mesh;
}

function decodeChannels(buffer, words, { bits: columns, count: rows, time }) {
  must(columns > 0, "channels without a column");
  must(Number.isFinite(time), "channels without a time");
  exactly(buffer, HEADER + 4 * columns * rows, "channels");
  return { kind: "channels", columns, rows, time, values: new Float32Array(buffer, HEADER, columns * rows) };
}

function decodeSnapshot(buffer, words, { bits, count, time }) {
  must(buffer.byteLength >= 240, `snapshot of ${buffer.byteLength} bytes, 240 at least`);
  const clusters = words.getUint32(216, true), rows = words.getUint32(236, true);
  exactly(buffer, 240 + CONTACT * (count + clusters + rows), "snapshot");
  const f = new Float32Array(buffer, 24, FIELDS);
  const triple = (k) => [f[k], f[k + 1], f[k + 2]];
  const pose = (k) => ({ position: triple(k), quaternion: [f[k + 3], f[k + 4], f[k + 5], f[k + 6]] });
  const snapshot = {
    kind: "snapshot", time, bits, frame: words.getFloat64(16, true),
    object: pose(0), ghost: pose(7), handle: pose(14), grasp: triple(21),
    force: triple(24), torque: triple(27), contactForce: triple(30), contactTorque: triple(33), center: triple(36),
    penetration: f[39], stretch: f[40], energy: f[41], modelAge: f[42], modelWeight: f[43],
    hapticRate: f[44], contactRate: f[45], queryCpu: f[46], metresPerNewton: f[47],
    contactsFound: words.getUint32(220, true), contactsDropped: words.getUint32(224, true),
    front: words.getUint32(228, true), fault: words.getUint32(232, true), contacts: [], clusters: [], rows: [],
  };
  must(f.subarray(0, 24).every(Number.isFinite), "snapshot with a pose that is no number");
  for (let k = 0; k < count; k++) snapshot.contacts.push(contactAt(words, 240 + CONTACT * k));
  for (let k = 0; k < clusters; k++) snapshot.clusters.push(clusterAt(words, 240 + CONTACT * (count + k)));
  for (let k = 0; k < rows; k++) snapshot.rows.push(rowAt(words, 240 + CONTACT * (count + clusters + k)));
  return snapshot;
}

function decodeBodies(buffer, words, { count, time }) {
  must(buffer.byteLength >= 32, `bodies of ${buffer.byteLength} bytes, 32 at least`);
  const hands = words.getUint32(24, true);
  exactly(buffer, 32 + BODY * count + HAND * hands, "bodies");
  const f = new Float32Array(buffer, 32, 8 * count + 16 * hands);
  const pose = (k) => ({ position: [f[k], f[k + 1], f[k + 2]], quaternion: [f[k + 3], f[k + 4], f[k + 5], f[k + 6]] });
  const message = { kind: "bodies", time, frame: words.getFloat64(16, true), bodies: [], hands: [] };
  for (let k = 0; k < count; k++) {
    must(f.subarray(8 * k, 8 * k + 7).every(Number.isFinite), "bodies with a pose that is no number");
    message.bodies.push({ ...pose(8 * k), asleep: (words.getUint32(32 + BODY * k + 28, true) & 1) !== 0 });
  }
  for (let h = 0; h < hands; h++) {
    const k = 8 * count + 16 * h, at = 32 + 4 * k;
    message.hands.push({ handle: pose(k), grasp: [f[k + 7], f[k + 8], f[k + 9]], force: [f[k + 10], f[k + 11], f[k + 12]],
      body: words.getInt32(at + 52, true), page: (words.getUint32(at + 56, true) & 1) !== 0 });
  }
  return message;
}

const floats = (words, at, n) => Array.from({ length: n }, (_, k) => words.getFloat32(at + 4 * k, true));

function contactAt(words, at) {
  const levels = words.getUint32(at + 44, true);
  return { point: floats(words, at, 3), normal: floats(words, at + 12, 3), depth: words.getFloat32(at + 24, true),
    bound: words.getFloat32(at + 28, true), body: words.getInt32(at + 32, true), objectNode: words.getInt32(at + 36, true),
    sceneNode: words.getInt32(at + 40, true), objectLevel: levels & 0xff, sceneLevel: (levels >> 8) & 0xff,
    status: (levels >> 16) & 0xff, decidedBy: levels >>> 24 };
}

function clusterAt(words, at) {
  return { point: floats(words, at, 3), normal: floats(words, at + 12, 3), depth: words.getFloat32(at + 24, true),
    force: floats(words, at + 28, 3), id: words.getInt32(at + 40, true) };
}

function rowAt(words, at) {
  const bits = words.getUint32(at + 44, true);
  return { point: floats(words, at, 3), normal: floats(words, at + 12, 3), gap: words.getFloat32(at + 24, true),
    force: floats(words, at + 28, 3), friction: words.getFloat32(at + 40, true), kind: bits & 3, presses: (bits & 4) !== 0 };
}

/// One text frame: an object with a type, or ProtocolError.
export function parseText(text) {
  let message = null;
  try { message = JSON.parse(text); } catch { /* said below */ }
  must(message && typeof message === "object" && typeof message.type === "string", "a text message without a type");
  return message;
}

/// A piece of a file as an `upload` message.
export function encodeUpload(bytes) {
  const buffer = new ArrayBuffer(HEADER + bytes.length);
  const words = new DataView(buffer);
  words.setUint8(0, UPLOAD);
  words.setUint8(1, 1);
  words.setUint32(4, bytes.length, true);
  new Uint8Array(buffer, HEADER).set(bytes);
  return buffer;
}

/// Samples of the hand, oldest first, as a `device` message.
/// samples   [{time [s], position [3], quaternion [4, xyzw], buttons}], 1 to 64
/// now       browser's clock [s]
export function encodeDevice(samples, now) {
  must(samples.length >= 1 && samples.length <= MAX_SAMPLES, `${samples.length} samples in one message`);
  const buffer = new ArrayBuffer(HEADER + SAMPLE * samples.length);
  const words = new DataView(buffer);
  words.setUint8(0, DEVICE);
  words.setUint8(1, 1);
  words.setUint32(4, samples.length, true);
  words.setFloat64(8, now, true);
  samples.forEach((sample, k) => {
    const at = HEADER + SAMPLE * k;
    words.setFloat64(at, sample.time, true);
    sample.position.forEach((value, i) => words.setFloat32(at + 8 + 4 * i, value, true));
    sample.quaternion.forEach((value, i) => words.setFloat32(at + 20 + 4 * i, value, true));
    words.setUint32(at + 36, sample.buttons, true);
  });
  return buffer;
}
