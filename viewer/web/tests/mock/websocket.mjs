// As much of RFC 6455 as a test server needs: handshake with subprotocol, whole frames, close.
import { createHash } from "node:crypto";

/// Accepts an upgrade; on gets {text(string), binary(Buffer), closed()}. Returns {sendText, sendBinary, close, open}.
export function acceptSocket(request, socket, subprotocol, on) {
  const key = createHash("sha1").update(`${request.headers["sec-websocket-key"]}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`).digest("base64");
  socket.write("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n" +
    `Sec-WebSocket-Accept: ${key}\r\nSec-WebSocket-Protocol: ${subprotocol}\r\n\r\n`);
  socket.setNoDelay(true);
  const side = { open: true,
    sendText: (text) => send(1, Buffer.from(text)), sendBinary: (bytes) => send(2, Buffer.from(bytes)),
    close: (code, reason) => { send(8, Buffer.concat([Buffer.from([code >> 8, code & 255]), Buffer.from(reason)])); end(); },
    destroy: () => { socket.destroy(); end(); } };
  function send(opcode, payload) {
    if (!side.open || socket.destroyed) return;
    const head = payload.length < 126 ? Buffer.from([0x80 | opcode, payload.length])
      : payload.length < 65536 ? Buffer.from([0x80 | opcode, 126, payload.length >> 8, payload.length & 255]) : longHead(opcode, payload.length);
    socket.write(Buffer.concat([head, payload]));
  }
  function end() {
    if (!side.open) return;
    side.open = false;
    socket.end();
    on.closed();
  }
  let pending = Buffer.alloc(0);
  socket.on("data", (data) => {
    pending = Buffer.concat([pending, data]);
    for (let frame = takeFrame(pending); frame; frame = takeFrame(pending)) {
      pending = pending.subarray(frame.size);
      if (frame.opcode === 1) on.text(frame.payload.toString("utf8"));
      if (frame.opcode === 2) on.binary(frame.payload);
      if (frame.opcode === 8) end();
      if (frame.opcode === 9) send(10, frame.payload);
    }
  });
  socket.on("close", end);
  socket.on("error", end);
  return side;
}

function longHead(opcode, length) {
  const head = Buffer.alloc(10);
  head[0] = 0x80 | opcode;
  head[1] = 127;
  head.writeBigUInt64BE(BigInt(length), 2);
  return head;
}

/// One whole masked frame, or null when more has to come.
function takeFrame(data) {
  if (data.length < 6) return null;
  let size = data[1] & 127, at = 2;
  if (size === 126) { size = data.readUInt16BE(2); at = 4; }
  if (data.length < at + 4 + size) return null;
  const mask = data.subarray(at, at + 4);
  const payload = Buffer.from(data.subarray(at + 4, at + 4 + size));
  for (let k = 0; k < size; k++) payload[k] ^= mask[k & 3];
  return { opcode: data[0] & 15, payload, size: at + 4 + size };
}
