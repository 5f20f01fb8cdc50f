// A stand-in for the program: serves dist/ and speaks docs/protocol.md over a made-up session.
//   node tests/mock/server.mjs [PORT]     to look at the page without building anything
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { acceptSocket } from "./websocket.mjs";
import { CHANNELS, encodeChannels, encodeLevel, encodeMesh, encodeRelief, encodeSnapshot, FAULTS, readDevice } from "./encode.mjs";
import { constraintOf, levelList, makeBlock, makeWorld, rowOf, scriptedHand, snapshotOf, START, stepWorld } from "./world.mjs";

const dist = join(dirname(fileURLToPath(import.meta.url)), "../../dist");
const MIME = { ".js": "text/javascript", ".css": "text/css", ".html": "text/html; charset=utf-8", ".svg": "image/svg+xml", ".txt": "text/plain", ".webp": "image/webp" };
const policy = (host) => "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; " +
  `connect-src 'self' ws://${host}; font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'`;

const LOST_AFTER = 10000; // [ms]; the program says 5000, but a test machine may be busy

/// options   {port 0: any, device "web:" | "hand:", constrained: contacts are constraints}
/// returns   {port, world, received: {device, samples, text, refused}, silence(bool), drop(), close()}
export async function startMock({ port = 0, device = "web:", constrained = false } = {}) {
  const mock = { world: makeWorld(), device, pages: new Set(), run: "running", session: 1, holder: null, lastDevice: 0, nextPage: 1,
    received: { device: 0, samples: 0, newest: null, text: [], refused: [] }, quiet: false, rows: [], started: 0 };
  mock.world.constrained = constrained;
  mock.meshes = [makeBlock(true), makeBlock(false)].map((mesh, number) => encodeMesh(number, mesh));
  mock.parameters = [parameter("contact_stiffness", "contact stiffness", "N/m", 5000, 200, 20000, "how hard the surfaces are"),
    parameter("coupling_stiffness", "coupling stiffness", "N/m", 500, 50, 1000, "how firmly the hand holds the object"),
    parameter("mass", "mass", "kg", 0.01, 0.0005, 0.5, "of the object in the hand"),
    { ...parameter("budget_us", "time budget", "µs", 0, 20, 20000, "CPU time of a contact query"), kind: "optional" },
    { ...parameter("response", "response", "", 0, 0, 1, "coupled or direct"), kind: "choice", choices: ["coupled", "direct"], begins_again: true },
    { ...parameter("threshold", "error threshold", "", 0.025, 0.001, 0.2, "how coarse contacts may be"), locked: "While recording this stays as it is." }];
  const server = createServer((request, response) => serve(request, response));
  server.on("upgrade", (request, socket) => enter(mock, request, socket));
  await new Promise((resolve) => server.listen(port, "127.0.0.1", resolve));
  const clock = setInterval(() => tick(mock), 16);
  const slow = setInterval(() => tellState(mock), 1000);
  Object.assign(mock, {
    port: server.address().port,
    silence: (quiet) => { mock.quiet = quiet; },
    event: (kind, detail, text) => event(mock, kind, detail, text),
    relief: (number) => { for (const page of mock.pages) page.sendBinary(encodeRelief(number, makeBlock(number === 0))); },
    progress: (what, share) => { for (const page of mock.pages) page.say({ type: "progress", what, share }); },
    show: (refined = false) => { for (const page of mock.pages) tellScene(mock, page, page.say, refined); },
    drop: () => { for (const page of [...mock.pages]) page.destroy(); },
    close: () => { clearInterval(clock); clearInterval(slow); for (const page of [...mock.pages]) page.destroy(); server.close(); },
  });
  return mock;
}

const parameter = (name, label, unit, value, min, max, help) => ({ name, label, unit, value, min, max, scale: "log", locked: null, help,
  kind: "number", choices: [], begins_again: false, warning: null });

async function serve(request, response) {
  const path = request.url.split("?")[0];
  const name = path === "/" ? "index.html" : path.slice(1);
  const body = /^[A-Za-z.]+$/.test(name) ? await readFile(join(dist, name)).catch(() => null) : null;
  response.writeHead(body ? 200 : 404, { "Content-Type": MIME[extname(name)] ?? "text/plain",
    "Content-Security-Policy": policy(request.headers.host), "Cache-Control": "no-cache" });
  response.end(body ?? "not here\n");
}

function enter(mock, request, socket) {
  if (request.headers.origin !== `http://${request.headers.host}` || request.headers["sec-websocket-protocol"] !== "thigma.live.1") {
    socket.end("HTTP/1.1 403 Forbidden\r\n\r\n");
    return;
  }
  const page = acceptSocket(request, socket, "thigma.live.1", {
    text: (text) => hear(mock, page, JSON.parse(text)), binary: (data) => hearDevice(mock, page, data),
    closed: () => { mock.pages.delete(page); if (mock.holder === page) loseDevice(mock); } });
  const say = (message) => page.sendText(JSON.stringify(message));
  mock.pages.add(page);
  say({ type: "hello", protocol: 1, program: "mock", page: mock.nextPage++, lost_after: 5, max_message: 65536,
    channels: CHANNELS.map((name) => ({ name, unit: "" })), faults: FAULTS });
  tellScene(mock, page, say);
  say({ type: "parameters", list: mock.parameters });
  say({ type: "menu", scenes: [{ name: "mock", title: "Block on block (made up)" }, { name: "cups", title: "Cup and spoon" },
      { name: "jaws", title: "Upper jaw on lower jaw" }],
    recordings: [{ name: "session-001.mcap", title: "session-001.mcap" }],
    meshes: [{ name: "OBJ", ending: ".obj" }, { name: "PLY", ending: ".ply" }] });
  page.say = say;
  tellState(mock);
}

function tellScene(mock, page, say, refined = false) {
  const block = (name, mesh) => ({ name, mesh, radius: 0.043, center: [0, 0, 0], levels: 6, triangles: 9600, patches: 576,
    level_list: levelList() });
  const [held, ...still] = mock.composed?.objects ?? [{ source: "scene:0", name: "upper block", unit: 1, ...START },
    { source: "scene:1", name: "lower block", unit: 1, position: [0, 0, 0], quat_xyzw: [0, 0, 0, 1] }];
  say({ type: "scene", title: mock.composed?.title ?? "Block on block (made up)", name: "mock", object: { ...held, ...block(held.name, 0) },
    statics: still.map((one) => ({ ...one, ...block(one.name, 1) })), start: { position: held.position, quat_xyzw: held.quat_xyzw },
    workspace: { position: [0, 0, 0], quat_xyzw: [0, 0, 0, 1], motion_scale: 1, force_scale: 1 }, tolerance: 0.0004, rate: 1000, refined });
  for (const mesh of mock.meshes) page.sendBinary(mesh);
}

function tellState(mock) {
  if (mock.quiet) return;
  for (const page of mock.pages) {
    page.say({ type: "state", session: mock.session, run: mock.run, reason: null, time: mock.world.time, device: mock.device,
      devices: ["hand:", "web:"], holder: mock.holder === page ? "you" : mock.holder ? "other" : "none", recording: mock.recording ?? null,
      replay: mock.replay ?? null, limits: { force: 3.3, torque: 0.1 }, constraint: constraintOf(mock.world),
      pages: mock.pages.size, simulated: true, timing: { step_cpu_us: { p50: 2.1, p99: 4 }, wake_late_us: { p50: 60, p99: 400 },
        query_cpu_us: { p50: 1180, p99: 2100 }, haptic_hz: 1000, contact_hz: 420, missed: 0 }, dropped: { yours: 0, rows: 0, samples: 0 } });
  }
}

function event(mock, kind, detail = "", text = "") {
  for (const page of mock.pages) page.say({ type: "event", time: mock.world.time, frame: mock.world.frame, kind, detail, text });
}

function loseDevice(mock) {
  mock.holder = null;
  mock.world.hand = null;
  mock.world.fault = 1;
  event(mock, "fault", "device_lost");
}

function hear(mock, page, message) {
  mock.received.text.push(message);
  const reason = obey(mock, page, message);
  if (reason === undefined) return; // answered later
  const found = mock.parameters.find((one) => one.name === message.name);
  page.say({ type: "ack", id: message.id, ok: reason === null, reason, ...(message.type === "set" && reason === null ? { value: found.value } : {}) });
  tellState(mock);
}

/// Does what a page asks; null, or the reason why not.
function obey(mock, page, { type, value, name, mesh, id, repair, objects, title }) {
  if (type === "level") page.sendBinary(encodeLevel(mesh, value, makeBlock(mesh === 0, value)));
  else if (type === "open") return open(mock, value);
  else if (type === "seek") mock.world.time = value;
  else if (type === "speed") mock.replay.speed = value;
  else if (type === "cancel") { mock.cancelled = true; mock.progress(null, 1); }
  else if (type === "upload") { mock.upload = { id, page, name, left: value, bytes: [] }; return undefined; }
  else if (type === "compose") return compose(mock, objects, title);
  else if (type === "save") {
    if (!/^[A-Za-z0-9]/.test(name)) return `'${name}' is no name for a scene`;
    mock.saved = { name, isOneFile: value };
    page.say({ type: "saved", id, file: `/home/me/scenes/${name}.${value ? "mcap" : "toml"}` });
  } else if (type === "place") mock.placed = { how: name, unit: value, repair };
  else if (type === "hold") {
    if (mock.device !== "web:") return "The session's device is not web:.";
    if (mock.holder && mock.holder !== page) return "Another page holds the device.";
    mock.holder = value ? page : null;
    mock.lastDevice = Date.now();
    if (!value) mock.world.hand = null;
  } else if (type === "use_device") {
    mock.device = value;
    mock.replay = null;
    mock.holder = value === "web:" ? page : null;
    mock.world.hand = null;
    mock.lastDevice = Date.now();
  } else if (type === "pause") mock.run = value ? "paused" : "running";
  else if (type === "step") for (let k = 0; k < value; k++) advance(mock);
  else if (type === "reset") { mock.world = { ...makeWorld(), constrained: mock.world.constrained }; mock.session += 1; mock.rows = []; }
  else if (type === "record") mock.recording = value ? "session.mcap" : null;
  else if (type === "set") {
    const found = mock.parameters.find((one) => one.name === name);
    if (name === "mass" && value < 0.001) return `mass ${value} kg is too light for this coupling at 1000 Hz; 0.001 kg or more is safe.`;
    found.value = value;
    if (name === "coupling_stiffness") {
      mock.world.spring = value;
      found.warning = value > 800 ? `${value} N/m is above 800 N/m, where the loop begins to swing` : null;
    }
    event(mock, "parameter", `${name} ${value}`);
    for (const one of mock.pages) one.say({ type: "parameters", list: mock.parameters });
  }
  return null;
}

/// The scene that a page has put together; blocks stand for whatever was dropped.
function compose(mock, objects, title) {
  if (objects.some(({ friction }) => friction < 0)) return "friction is wrong, expected 0 to 10";
  mock.composed = { title, objects };
  for (const page of mock.pages) tellScene(mock, page, page.say);
  return null;
}

/// A recording, or a scene that takes a moment to prepare.
function open(mock, name) {
  if (name.endsWith(".mcap")) {
    mock.replay = { file: name, seconds: 20, speed: 1 };
    for (const page of mock.pages) page.say({ type: "strip", seconds: 20, force: Array.from({ length: 300 }, (_, k) => Math.max(0, Math.sin(k / 20))) });
    return null;
  }
  if (name !== "cups") return `there is no '${name}' here`;
  for (const page of mock.pages) page.say({ type: "progress", what: "building levels of cup", share: 0.4 });
  mock.opened = name;
  return null;
}

function hearUpload(mock, page, data) {
  const { upload } = mock;
  const bytes = data.subarray(16);
  if (!upload || upload.page !== page || data.readUInt32LE(4) !== bytes.length || bytes.length > upload.left) { page.close(1008, "upload"); return; }
  upload.bytes.push(Buffer.from(bytes));
  upload.left -= bytes.length;
  if (upload.left > 0) return;
  mock.upload = null;
  mock.uploaded = Buffer.concat(upload.bytes);
  const bad = upload.name.startsWith("bad");
  mock.files = (mock.files ?? 0) + 1;
  page.say({ type: "model", id: upload.id, name: upload.name, number: mock.files, unit: 0.001, object_radius: 0.03, report: { verdict: bad ? "rejected" : "repairable",
    triangles: 4, closed: true, components: 1, radius: 30, bounds: { min: [0, 0, 0], max: [40, 30, 20] },
    reasons: [bad ? "no triangle" : "2 duplicate faces"], warnings: [] } });
  page.say({ type: "ack", id: upload.id, ok: true, reason: null });
}

function hearDevice(mock, page, data) {
  if (data[0] === 33) { hearUpload(mock, page, data); return; }
  const samples = readDevice(data);
  if (typeof samples === "string") { mock.received.refused.push(samples); page.close(1008, samples); return; }
  if (page !== mock.holder) { mock.received.refused.push("not the holder"); return; }
  mock.received.device += 1;
  mock.received.samples += samples.length;
  mock.lastDevice = Date.now();
  mock.received.newest = samples[samples.length - 1].time;
  for (const { position, quaternion, buttons } of samples) {
    const clutch = (buttons & 1) !== 0;
    if (clutch && !mock.world.hand?.clutch && mock.world.fault === 1) { mock.world.fault = 0; event(mock, "resumed"); }
    mock.world.hand = { position, quaternion, clutch };
  }
}

function advance(mock) {
  if (mock.device === "hand:") mock.world.hand = scriptedHand(mock.world.time);
  const before = mock.world.grasped;
  stepWorld(mock.world);
  if (before !== mock.world.grasped) event(mock, mock.world.grasped ? "grasped" : "released");
  if (mock.rows.length === 0) mock.started = mock.world.time;
  mock.rows.push(rowOf(mock.world, mock.started));
}

function tick(mock) {
  if (mock.device === "web:" && mock.holder && mock.world.fault === 0 && Date.now() - mock.lastDevice > LOST_AFTER) loseDevice(mock);
  if (mock.run === "running") for (let k = 0; k < 16; k++) advance(mock);
  if (mock.quiet) return;
  const snapshot = encodeSnapshot(snapshotOf(mock.world, mock.run === "paused"));
  const rows = mock.rows.length > 0 ? encodeChannels(mock.started, mock.rows) : null;
  mock.rows = [];
  for (const page of mock.pages) {
    if (rows) page.sendBinary(rows);
    page.sendBinary(snapshot);
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const mock = await startMock({ port: Number(process.argv[2] ?? 0), device: process.argv[3] ?? "hand:" });
  console.log(`http://127.0.0.1:${mock.port}/`);
}
