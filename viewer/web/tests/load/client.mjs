// A page without a browser: speaks the protocol over a plain socket, so that it can also stop reading.
import { randomBytes } from "node:crypto";
import { connect } from "node:net";

/// Connects to the page's server; on(message) gets {text} parsed or {binary}.
export async function openClient(port, on = () => {}) {
  const socket = connect(port, "127.0.0.1");
  const host = `127.0.0.1:${port}`;
  socket.write(`GET /live HTTP/1.1\r\nHost: ${host}\r\nOrigin: http://${host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n` +
    `Sec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: thigma.live.1\r\nSec-WebSocket-Key: ${randomBytes(16).toString("base64")}\r\n\r\n`);
  const client = { socket, states: [], snapshots: 0, bytes: 0, waiting: new Map(), nextId: 1 };
  let pending = Buffer.alloc(0), greeted = null;
  const ready = new Promise((resolve, reject) => { greeted = resolve; socket.on("error", reject); socket.on("close", () => reject(new Error("closed"))); });
  socket.on("data", (data) => {
    client.bytes += data.length;
    pending = pending.length > 0 ? Buffer.concat([pending, data]) : data;
    if (greeted) {
      const end = pending.indexOf("\r\n\r\n");
      if (end < 0) return;
      if (!pending.subarray(0, end).toString().startsWith("HTTP/1.1 101")) { socket.destroy(new Error(pending.subarray(0, 80).toString())); return; }
      pending = pending.subarray(end + 4);
      greeted();
      greeted = null;
    }
    for (let frame = takeFrame(pending); frame; frame = takeFrame(pending)) {
      pending = pending.subarray(frame.size);
      hear(client, frame, on);
    }
  });
  await ready;
  return Object.assign(client, {
    send: (message) => sendFrame(socket, 1, Buffer.from(JSON.stringify(message))),
    ask: (message) => new Promise((resolve) => {
      const id = client.nextId++;
      client.waiting.set(id, resolve);
      client.send({ ...message, id });
    }),
    sendBinary: (bytes) => sendFrame(socket, 2, bytes),
    close: () => socket.destroy(),
  });
}

function hear(client, { opcode, payload }, on) {
  if (opcode === 9) sendFrame(client.socket, 10, payload);
  if (opcode === 2 && payload[0] === 3) client.snapshots += 1;
  if (opcode === 2) on({ binary: payload });
  if (opcode !== 1) return;
  const text = JSON.parse(payload.toString("utf8"));
  if (text.type === "state") client.states.push(text);
  if (text.type === "ack") {
    client.waiting.get(text.id)?.(text);
    client.waiting.delete(text.id);
  }
  on({ text });
}

/// One whole frame of the server, which masks nothing; null when more has to come.
function takeFrame(data) {
  if (data.length < 2) return null;
  let size = data[1] & 127, at = 2;
  if (size === 126) { if (data.length < 4) return null; size = data.readUInt16BE(2); at = 4; }
  else if (size === 127) { if (data.length < 10) return null; size = Number(data.readBigUInt64BE(2)); at = 10; }
  if (data.length < at + size) return null;
  return { opcode: data[0] & 15, payload: Buffer.from(data.subarray(at, at + size)), size: at + size };
}

function sendFrame(socket, opcode, payload) {
  if (socket.destroyed) return;
  const size = payload.length;
  const head = size < 126 ? Buffer.from([0x80 | opcode, 0x80 | size]) : Buffer.from([0x80 | opcode, 0x80 | 126, size >> 8, size & 255]);
  socket.write(Buffer.concat([head, Buffer.alloc(4), payload])); // a mask of zeros
}
