// The page's worker: wire.js with a real connection and a real clock.
import { SUBPROTOCOL } from "./protocol.js";
import { makeWire, take, TICK, tick } from "./wire.js";

const wire = makeWire({
  connect: (url) => new WebSocket(url, SUBPROTOCOL),
  post: (message, transfer = []) => postMessage(message, transfer),
  now: () => performance.now(),
});
onmessage = ({ data }) => take(wire, data.open ? { ...data, shift: performance.timeOrigin - data.origin } : data);
setInterval(() => tick(wire), TICK);
