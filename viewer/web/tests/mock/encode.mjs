// The server's side of docs/protocol.md, written from the document and not from the page's decoder.

export const CHANNELS = ["t", "force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z", "penetration", "stretch", "energy",
  "model_age", "step_cpu", "wake_late", "speed", "touching", "state"];
export const FAULTS = ["none", "device_lost", "watchdog"];

function header(bytes, type, bits, count, time) {
  const buffer = Buffer.alloc(bytes);
  buffer[0] = type;
  buffer[1] = 1;
  buffer.writeUInt16LE(bits, 2);
  buffer.writeUInt32LE(count, 4);
  buffer.writeDoubleLE(time, 8);
  return buffer;
}

export function encodeMesh(number, mesh) {
  const { positions, triangles, patchOfTriangle, nodeOfPatch, parents, levels } = mesh;
  const sizes = [positions.length / 3, triangles.length / 3, nodeOfPatch.length, parents.length];
  const buffer = header(32 + 4 * (positions.length + triangles.length + patchOfTriangle.length + nodeOfPatch.length +
    parents.length + levels.length), 1, 0, number, 0);
  sizes.forEach((size, k) => buffer.writeUInt32LE(size, 16 + 4 * k));
  let at = 32;
  const put = (list, write) => { for (const value of list) { buffer[write](value, at); at += 4; } };
  put(positions, "writeFloatLE");
  put(triangles, "writeUInt32LE");
  put(patchOfTriangle, "writeUInt32LE");
  put(nodeOfPatch, "writeInt32LE");
  put(parents, "writeInt32LE");
  put(levels, "writeInt32LE");
  return buffer;
}

export function encodeLevel(number, level, { positions, triangles, patchOfTriangle, nodeOfPatch }) {
  const sizes = [positions.length / 3, triangles.length / 3, nodeOfPatch.length, 0];
  const buffer = header(32 + 4 * (positions.length + triangles.length + patchOfTriangle.length + nodeOfPatch.length), 4, level, number, 0);
  sizes.forEach((size, k) => buffer.writeUInt32LE(size, 16 + 4 * k));
  let at = 32;
  const put = (list, write) => { for (const value of list) { buffer[write](value, at); at += 4; } };
  put(positions, "writeFloatLE");
  put(triangles, "writeUInt32LE");
  put(patchOfTriangle, "writeUInt32LE");
  put(nodeOfPatch, "writeInt32LE");
  return buffer;
}

/// A mesh that stands for what its own level 0 is felt as.
export function encodeRelief(number, { positions, triangles, patchOfTriangle, nodeOfPatch }) {
  const buffer = header(32 + 4 * (positions.length + triangles.length + patchOfTriangle.length), 5, 0, number, 0);
  [positions.length / 3, triangles.length / 3, nodeOfPatch.length, 0].forEach((size, k) => buffer.writeUInt32LE(size, 16 + 4 * k));
  let at = 32;
  for (const value of positions) { buffer.writeFloatLE(value, at); at += 4; }
  for (const value of [...triangles, ...patchOfTriangle]) { buffer.writeUInt32LE(value, at); at += 4; }
  return buffer;
}

/// rows   arrays of numbers in the order of CHANNELS
export function encodeChannels(time, rows) {
  const buffer = header(16 + 4 * CHANNELS.length * rows.length, 2, CHANNELS.length, rows.length, time);
  rows.flat().forEach((value, k) => buffer.writeFloatLE(value, 16 + 4 * k));
  return buffer;
}

/// b   {time, frame, bodies: [{position, quaternion, asleep}], hands: [{handle: {position, quaternion}, grasp, force, body, page}]}
export function encodeBodies(b) {
  const buffer = header(32 + 32 * b.bodies.length + 64 * b.hands.length, 6, 0, b.bodies.length, b.time);
  buffer.writeDoubleLE(b.frame, 16);
  buffer.writeUInt32LE(b.hands.length, 24);
  let at = 32;
  const put = (list) => { for (const value of list) { buffer.writeFloatLE(value, at); at += 4; } };
  for (const { position, quaternion, asleep } of b.bodies) {
    put([...position, ...quaternion]);
    buffer.writeUInt32LE(asleep ? 1 : 0, at);
    at += 4;
  }
  for (const { handle, grasp, force, body, page } of b.hands) {
    put([...handle.position, ...handle.quaternion, ...grasp, ...force]);
    buffer.writeInt32LE(body, at);
    buffer.writeUInt32LE(page ? 1 : 0, at + 4);
    at += 12;
  }
  return buffer;
}

/// s   {time, bits, frame, fields: 48 numbers, found, dropped, front, fault, contacts, clusters, rows: none where left out}
export function encodeSnapshot(s) {
  const rows = s.rows ?? [];
  const buffer = header(240 + 48 * (s.contacts.length + s.clusters.length + rows.length), 3, s.bits, s.contacts.length, s.time);
  buffer.writeDoubleLE(s.frame, 16);
  s.fields.forEach((value, k) => buffer.writeFloatLE(value, 24 + 4 * k));
  [s.clusters.length, s.found, s.dropped, s.front, s.fault, rows.length].forEach((value, k) => buffer.writeUInt32LE(value, 216 + 4 * k));
  let at = 240;
  for (const c of s.contacts) {
    [...c.point, ...c.normal, c.depth, c.bound].forEach((value, k) => buffer.writeFloatLE(value, at + 4 * k));
    [c.body, c.objectNode, c.sceneNode].forEach((value, k) => buffer.writeInt32LE(value, at + 32 + 4 * k));
    buffer.writeUInt32LE((c.objectLevel | (c.sceneLevel << 8) | (c.status << 16) | ((c.decidedBy ?? 5) << 24)) >>> 0, at + 44);
    at += 48;
  }
  for (const c of s.clusters) {
    [...c.point, ...c.normal, c.depth, ...c.force].forEach((value, k) => buffer.writeFloatLE(value, at + 4 * k));
    buffer.writeInt32LE(c.id, at + 40);
    at += 48;
  }
  for (const r of rows) {
    [...r.point, ...r.normal, r.gap, ...r.force, r.friction].forEach((value, k) => buffer.writeFloatLE(value, at + 4 * k));
    buffer.writeUInt32LE(r.kind | (r.presses ? 4 : 0), at + 44);
    at += 48;
  }
  return buffer;
}

/// A `device` message, or a sentence that says what is wrong with it.
export function readDevice(data) {
  if (data.length < 16 || data[0] !== 32 || data[1] !== 1) return "not a device message";
  const count = data.readUInt32LE(4);
  if (count < 1 || count > 64 || data.length !== 16 + 40 * count) return `device message of ${data.length} bytes with ${count} samples`;
  const samples = Array.from({ length: count }, (_, k) => {
    const at = 16 + 40 * k;
    const floats = Array.from({ length: 7 }, (_, i) => data.readFloatLE(at + 8 + 4 * i));
    return { time: data.readDoubleLE(at), position: floats.slice(0, 3), quaternion: floats.slice(3), buttons: data.readUInt32LE(at + 36) };
  });
  for (let k = 1; k < count; k++) if (samples[k].time < samples[k - 1].time) return "clock runs backwards";
  for (const { position, quaternion } of samples) {
    if (![...position, ...quaternion].every(Number.isFinite)) return "a number that is not finite";
    if (Math.abs(Math.hypot(...quaternion) - 1) > 1e-3) return "orientation not unit";
  }
  return samples;
}
